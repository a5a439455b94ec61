#include "emission/print_optimize.hpp"

#include <fmt/format.h>

#include <utility>

#include "emission/backend/backend.hpp"
#include "emission/c/print_loops.hpp"
#include "emission/controller_unit.hpp"
#include "emission/describe_program.hpp"
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

CodeModel model_of(std::string_view name) {
  const Target* const target = find_target(name);
  const bool small = target != nullptr && !target->contracts;  // as microcontrollers do
  return small ? CodeModel{5, 16384} : CodeModel{9, 32768};
}

std::vector<std::string> with_endings(const EmissionContext& context,
                                      std::vector<std::string> names) {
  for (std::string& name : names) name += backend_of(context.language).source;
  return names;
}

const char* language_id(const EmissionContext& context) {
  return context.language == Language::c ? "C" : "CXX";
}

/// Lines of CMake that add options to some sources. Empty where there are no sources.
std::string print_source_options(std::span<const std::string> names, const char* options) {
  if (names.empty()) return {};
  std::string sources;
  for (const std::string& name : names) sources += fmt::format("    {}\n", name);
  return fmt::format("  set_property(SOURCE\n{}    APPEND PROPERTY COMPILE_OPTIONS {})\n", sources,
                     options);
}

/// Sources of those functions, of those for several states, and of a controller.
std::vector<std::string> list_sources_where(bool (*holds)(const Program&),
                                            const EmissionContext& context,
                                            std::span<const Program> programs,
                                            std::span<const Program> batch) {
  std::vector<std::string> names;
  const auto add = [&](const Program& program, const char* prefix) {
    if (holds(program)) names.push_back(prefix + program.name);
  };
  for (const Program& program : programs) add(program, "");
  for (const Program& program : batch) add(program, "batch_");
  if (context.controller) {
    for (const Program* const program : context.controller->programs()) add(*program, "");
  }
  return with_endings(context, std::move(names));
}

}  // namespace

std::string print_extra_passes(const EmissionContext& context, std::span<const Program> programs,
                               std::span<const Program> batch) {
  // Of a chain of 60 joints g++ 12 compiles Lambda^-1 (25000 operations) in 200 s with these passes
  // and in 17 s without, M (27000) in 48 and 28 s, to 5 % more code.
  const std::vector<std::string> slow = list_sources_where(is_long, context, programs, batch);
  return fmt::format(
      "if(CMAKE_{0}_COMPILER_ID STREQUAL \"GNU\")\n"
      "  # Fewer spills and copies in long straight-line code; no arithmetic changes.\n"
      "  target_compile_options({1} PRIVATE\n"
      "    \"$<$<IN_LIST:$<CONFIG>,{2}>:-flive-range-shrinkage>\"\n"
      "    \"$<$<IN_LIST:$<CONFIG>,{2}>:-frename-registers>\")\n{3}"
      "endif()\n",
      language_id(context), context.name, "Release;RelWithDebInfo;MinSizeRel",
      print_source_options(slow, kNoExtraPasses));
}

std::string print_huge_code(const EmissionContext& context, std::span<const Program> programs,
                            std::span<const Program> batch) {
  const std::vector<std::string> huge = list_sources_where(is_huge, context, programs, batch);
  if (huge.empty()) return {};
  return fmt::format(
      "# Too long for a higher level, whatever level the project compiles with.\n"
      "if(CMAKE_{}_COMPILER_ID MATCHES \"GNU|Clang|IntelLLVM\")\n{}"
      "endif()\n",
      language_id(context), print_source_options(huge, kHugeFlag));
}

bool compiles_to_small_code(Optimize optimize, std::string_view target, const Program& program) {
  if (is_huge(program)) return false;
  if (optimize != Optimize::balanced) return optimize == Optimize::size;
  if (program.small_code) return *program.small_code;
  const CodeModel model = model_of(target);
  return count_operations(program).flops() * model.bytes_of_operation > model.cache;
}

std::vector<std::string> list_small_sources(const EmissionContext& context,
                                            std::span<const Program> programs,
                                            std::span<const Program> batch) {
  std::vector<std::string> names;
  const auto add = [&](const Program& program) {
    if (compiles_to_small_code(context.optimize, context.target, program)) {
      names.push_back(program.name);
    }
  };
  for (const Program& program : programs) add(program);
  if (context.controller) {
    for (const Program* const program : context.controller->programs()) add(*program);
  }
  if (context.optimize != Optimize::size) return with_endings(context, std::move(names));
  for (const Program& program : batch) {
    if (!is_huge(program)) names.push_back("batch_" + program.name);
  }
  if (context.controller) names.emplace_back("controller");
  if (context.language == Language::c) {  // in C++ they are headers
    if (!context.effective_mass_limits.empty()) names.emplace_back("damped_control_torque");
    if (context.limits) names.emplace_back("limited_control_torque");
    if (context.limits && !batch.empty()) names.emplace_back("batch_limited_control_torque");
    if (const std::string joined = c::joined_loops(context, programs); !joined.empty()) {
      names.push_back(joined);
    }
  }
  return with_endings(context, std::move(names));
}

std::string print_small_code(const EmissionContext& context, std::span<const Program> programs,
                             std::span<const Program> batch) {
  const std::vector<std::string> small = list_small_sources(context, programs, batch);
  if (small.empty()) return {};
  return fmt::format(
      "# `optimize` of the scene: small code, whatever level the project compiles with.\n"
      "if(CMAKE_{}_COMPILER_ID MATCHES \"GNU|Clang|IntelLLVM\")\n{}"
      "endif()\n",
      language_id(context), print_source_options(small, kSmallCodeFlag));
}

}  // namespace treeline
