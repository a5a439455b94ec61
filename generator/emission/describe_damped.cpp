#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "emission/comment.hpp"
#include "emission/costs.hpp"
#include "emission/descriptions.hpp"

namespace treeline {
namespace {

/// The functions called and the variable that each result goes to.
constexpr std::array<std::array<const char*, 2>, 4> kCalls = {{{"lambda_inverse", "Lambda_inv"},
                                                               {"jacobian", "J"},
                                                               {"bias_acceleration", "bias"},
                                                               {"inverse_dynamics", "tau"}}};

}  // namespace

std::vector<DampedCall> list_damped_calls(std::span<const Program> programs) {
  std::vector<DampedCall> calls;
  for (const auto& [function, result] : kCalls) {
    const std::string name = function;
    const auto found = std::find_if(programs.begin(), programs.end(),
                                    [&](const Program& program) { return program.name == name; });
    if (found == programs.end()) throw std::logic_error("no program is called " + name);
    calls.push_back({&*found, result});
  }
  return calls;
}

std::string damped_name(const Argument& argument) {
  return argument.name == "qdd" ? "qdd_0" : argument.name;
}

std::vector<Argument> list_damped_arguments(const std::vector<DampedCall>& calls, int task_rows) {
  std::vector<Argument> arguments;
  for (Argument argument : calls.back().program->arguments) {
    const bool is_posture = argument.name == "qdd";
    argument.name = damped_name(argument);
    arguments.push_back(argument);
    if (is_posture) arguments.push_back({"xdd_cmd", task_rows, 1, ""});
  }
  for (const DampedCall& call : calls) {
    for (const Argument& argument : call.program->arguments) {
      const std::string name = damped_name(argument);
      if (std::none_of(arguments.begin(), arguments.end(),
                       [&](const Argument& listed) { return listed.name == name; })) {
        arguments.push_back(argument);
      }
    }
  }
  return arguments;
}

std::string describe_damped_cost(const EmissionContext& context,
                                 std::span<const Program> programs) {
  const DampedCost cost = cost_of_damped(context, programs);
  std::string text = fmt::format(
      "Cost: {} flops (add {}, mul {}, div {}), {} square roots, sine and cosine of {} angles; {} "
      "of "
      "the flops in the solve.",
      cost.count.flops(), cost.count.add, cost.count.mul, cost.count.div, cost.square_roots,
      cost.count.sin_cos,
      cost_of_damped_solve(context.task_rows, context.velocities, context.single_precision)
          .count.flops());
  text = wrap_text(text, 95) + "\n";
  text += fmt::format("Stack, an estimate: {} values live at once, {} bytes.\n", cost.values,
                      cost.values * number_bytes(context));
  return text + describe_rounding(context, "damped_control_torque");
}

std::string list_effective_mass_limits(const EmissionContext& context, const Syntax& syntax) {
  std::string list;
  for (const double value : context.effective_mass_limits) {
    list += (list.empty() ? "" : ", ") + syntax.literal(value);
  }
  return list;
}

}  // namespace treeline
