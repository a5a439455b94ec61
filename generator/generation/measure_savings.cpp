#include "generation/measure_savings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "choice/function_mechanisms.hpp"
#include "description/check_scene.hpp"
#include "emission/backend.hpp"
#include "generation/describe_scene.hpp"
#include "generation/generate_code.hpp"
#include "mechanism/build_mechanism.hpp"

namespace treeline {
namespace {

Savings::Sum sum_of(const std::vector<FunctionSize>& functions, bool emitted_only) {
  Savings::Sum sum;
  for (const FunctionSize& function : functions) {
    if (emitted_only && !function.emitted) continue;
    ++sum.functions;
    sum.flops += function.flops;
    sum.bytes += function.bytes;
  }
  return sum;
}

double percent(double part, double whole) {
  return whole > 0 ? 100 * part / whole : 100;
}

/// Size of the function's source file, bytes; 0 where it cannot be emitted.
std::size_t emitted_bytes(const EmissionContext& context, const Program& program) {
  Diagnostics faults;
  const std::string source = program.name + std::string(backend_of(context.language).source);
  for (const GeneratedFile& file : emit(context, {&program, 1}, faults)) {
    if (file.name == source) return file.text.size();
  }
  return 0;
}

}  // namespace

Savings::Sum Savings::emitted() const {
  return sum_of(functions, true);
}
Savings::Sum Savings::possible() const {
  return sum_of(functions, false);
}

std::vector<Function> possible_functions(const Robot& robot, const Scene& scene) {
  std::vector<Function> functions;
  for (const Function function : kSceneFunctions) {
    if (permits(robot, scene, function)) functions.push_back(function);
  }
  return functions;
}

Savings measure_savings(const Robot& robot, const Scene& scene) {
  FunctionMechanisms mechanisms(robot, scene);
  EmissionContext context = describe_scene(robot, scene, reduced_mechanism(robot, scene));
  context.batch = 0;
  context.effective_mass_limits.clear();
  Savings savings{scene.name, {}};
  for (const Function function : possible_functions(robot, scene)) {
    const GeneratedFunction generated =
        generate_function(mechanisms.of(function), function, route_options(scene));
    const std::size_t bytes = emitted_bytes(context, generated.program);
    const bool emitted = std::find(scene.functions.begin(), scene.functions.end(), function) !=
                         scene.functions.end();
    if (bytes > 0) {
      savings.functions.push_back({function, emitted, generated.chosen.count.flops(), bytes});
    }
  }
  return savings;
}

std::string print_functions(const Savings& savings) {
  std::string text = fmt::format("{:<30} {:>8} {:>9}  emitted\n", "function", "flops", "bytes");
  for (const FunctionSize& function : savings.functions) {
    text += fmt::format("{:<30} {:>8} {:>9}  {}\n", function_name(function.function),
                        function.flops, function.bytes, function.emitted ? "yes" : "no");
  }
  return text;
}

std::string print_table(const std::vector<Savings>& scenes) {
  std::string text = fmt::format("{:<22} {:>10} {:>18} {:>6} {:>20} {:>6}\n", "scene", "functions",
                                 "flops", "", "bytes", "");
  for (const Savings& savings : scenes) {
    const Savings::Sum some = savings.emitted();
    const Savings::Sum all = savings.possible();
    text +=
        fmt::format("{:<22} {:>4} of {:>2} {:>8} of {:>6} {:>4.0f} % {:>9} of {:>7} {:>4.0f} %\n",
                    savings.scene, some.functions, all.functions, some.flops, all.flops,
                    percent(some.flops, all.flops), some.bytes, all.bytes,
                    percent(static_cast<double>(some.bytes), static_cast<double>(all.bytes)));
  }
  return text;
}

}  // namespace treeline
