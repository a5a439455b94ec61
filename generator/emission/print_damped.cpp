#include "emission/print_damped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

#include "emission/comment.hpp"
#include "emission/damped_cost.hpp"
#include "emission/fill_template.hpp"
#include "emission/templates.hpp"
#include "emission/wrap_line.hpp"
#include "program/format_literal.hpp"

namespace treeline {
namespace {

/// The functions called and the variable that each result goes to.
constexpr std::array<std::array<const char*, 2>, 4> kCalls = {{{"lambda_inverse", "Lambda_inv"},
                                                               {"jacobian", "J"},
                                                               {"bias_acceleration", "bias"},
                                                               {"inverse_dynamics", "tau"}}};

const Program& find_program(std::span<const Program> programs, const std::string& name) {
  const auto found = std::find_if(programs.begin(), programs.end(),
                                  [&](const Program& program) { return program.name == name; });
  if (found == programs.end()) throw std::logic_error("no program is called " + name);
  return *found;
}

/// What the caller calls an argument of one of the functions.
std::string outer_name(const Argument& argument) {
  return argument.name == "qdd" ? "qdd_0" : argument.name;
}

std::string print_calls(std::span<const Program> programs) {
  std::string calls;
  for (const auto& [function, result] : kCalls) {
    std::string list;
    for (const Argument& argument : find_program(programs, function).arguments) {
      list += outer_name(argument) + ", ";
    }
    calls += fmt::format("{}{}({}{});", calls.empty() ? "" : "\n", function, list, result);
  }
  return calls;
}

/// In the order of control_torque: q, its sines and cosines, qd, qdd_0, xdd_cmd, f_ext.
std::string print_signature(std::span<const Program> programs) {
  std::string list;
  for (const Argument& argument : find_program(programs, "inverse_dynamics").arguments) {
    list +=
        fmt::format("const Real (&{})[{}], ", outer_name(argument), argument.rows * argument.cols);
    if (argument.name == "qdd") list += "const Real (&xdd_cmd)[kTaskRows], ";
  }
  return fmt::format(
      "inline Real damped_control_torque({}Real (&tau)[kVelocities], "
      "const Real (&heaviest)[kTaskRows] = kHeaviest) noexcept {{",
      list);
}

/// Cost, stack and rounding, as every function of the contract states them.
std::string describe_cost(const EmissionContext& context, std::span<const Program> programs) {
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
                      cost.values * (context.single_precision ? 4 : 8));
  text += describe_rounding(context, "damped_control_torque");
  return comment("///", text);
}

}  // namespace

std::string print_damped(const EmissionContext& context, std::span<const Program> programs) {
  std::string heaviest = "inline constexpr Real kHeaviest[kTaskRows] = {";
  const char* comma = "";
  for (const double value : context.heaviest) {
    heaviest += std::exchange(comma, ", ");
    heaviest += context.single_precision ? format_literal(static_cast<float>(value))
                                         : format_literal(value);
  }
  heaviest += "};";
  return fill_template(templates::kDamped, {{"robot", context.robot},
                                            {"name", context.name},
                                            {"heaviest", wrap_line(heaviest, 0)},
                                            {"cost", describe_cost(context, programs)},
                                            {"signature", wrap_line(print_signature(programs), 0)},
                                            {"calls", print_calls(programs)}});
}

}  // namespace treeline
