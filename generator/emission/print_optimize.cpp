#include "emission/print_optimize.hpp"

#include <fmt/format.h>

#include "emission/backend/backend.hpp"
#include "passes/count_operations.hpp"
#include "target/target.hpp"

namespace treeline {
namespace {

/// Bytes of code that an operation takes with its loads and stores, and of the cache for code, at
/// most: x86-64 and AArch64 as on PCs; cores of microcontrollers that have a cache have 16 KB.
struct CodeModel {
  int bytes_of_operation;
  int cache;
};

CodeModel model_of(const EmissionContext& context) {
  const Target* const target = find_target(context.target);
  const bool small = target != nullptr && !target->contracts;  // as microcontrollers do
  return small ? CodeModel{5, 16384} : CodeModel{9, 32768};
}

bool is_small(const EmissionContext& context, const Program& program) {
  const CodeModel model = model_of(context);
  return context.optimize == Optimize::size ||
         count_operations(program).flops() * model.bytes_of_operation > model.cache;
}

}  // namespace

std::string print_small_code(const EmissionContext& context, std::span<const Program> programs) {
  if (context.optimize == Optimize::speed) return {};
  const Backend& backend = backend_of(context.language);
  std::string sources;
  for (const Program& program : programs) {
    if (is_small(context, program)) {
      sources += fmt::format("    {}{}\n", program.name, backend.source);
    }
  }
  if (sources.empty()) return {};
  return fmt::format(
      "# `optimize` of the scene: small code, whatever level the project compiles with.\n"
      "if(CMAKE_{}_COMPILER_ID MATCHES \"GNU|Clang|IntelLLVM\")\n"
      "  set_property(SOURCE\n{}    APPEND PROPERTY COMPILE_OPTIONS -Os)\n"
      "endif()\n",
      context.language == Language::c ? "C" : "CXX", sources);
}

}  // namespace treeline
