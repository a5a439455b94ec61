#include "emission/print_contract.hpp"

#include <fmt/format.h>

#include "description/printable.hpp"
#include "emission/comment.hpp"
#include "emission/fill_template.hpp"
#include "emission/generator_version.hpp"
#include "emission/print_source.hpp"
#include "emission/print_target.hpp"
#include "emission/templates.hpp"
#include "program/format_literal.hpp"

namespace treeline {
namespace {

std::string describe_origin(const EmissionContext& context) {
  std::string text = "From";
  for (std::size_t i = 0; i < context.inputs.size(); ++i) {
    const std::string& file = context.inputs[i].file;
    text += file.empty() ? ", without a scene," : (i == 0 ? " " : " and ") + printable(file);
  }
  return text + " by\n  " + context.command + "\n";
}

/// `3` or `3..8`: the elements that `count` from `first` on take.
std::string elements(int first, int count) {
  return count == 1 ? std::to_string(first) : fmt::format("{}..{}", first, first + count - 1);
}

std::string describe_joints(const EmissionContext& context) {
  std::string text =
      fmt::format("Joints, in the order of q and of qd, qdd, tau ({} base):\n", context.base);
  for (const EmissionContext::JointRow& joint : context.joints) {
    text += wrap_text(fmt::format("  q {:<7} qd {:<7} {} ({}){}{}",
                                  elements(joint.first_coordinate, joint.coordinates),
                                  elements(joint.first_velocity, joint.velocities), joint.name,
                                  joint.type, joint.limits.empty() ? "" : ": ", joint.limits),
                      95) +
            "\n";
  }
  return text;
}

std::string describe_points(const char* title,
                            const std::vector<EmissionContext::PointRow>& points) {
  std::string text = points.empty() ? "" : std::string(title) + "\n";
  for (const EmissionContext::PointRow& point : points) {
    text += wrap_text(fmt::format("  from {:<4} {} on {}, {}: {}", point.first_row, point.name,
                                  point.link, point.frame, point.rows),
                      95) +
            "\n";
  }
  return text;
}

std::string describe_conventions(const EmissionContext& context) {
  std::string text = describe_joints(context);
  for (const EmissionContext::JointRow& joint : context.joints) {
    if (joint.coordinates != joint.velocities) {
      text +=
          "Of a floating joint q is position and quaternion (x y z w, of any length but 0, which "
          "turns by nothing)\nin the parent's frame, qd its linear and angular velocity in the "
          "moving link's axes, tau "
          "force and moment in those axes;\nqdd is the derivative of qd, component by "
          "component.\n";
      break;
    }
  }
  text += describe_points("Operational points, rows of task vectors:", context.operational_points);
  text += describe_points("External forces, elements of f_ext ([force; moment] on the robot):",
                          context.external_forces);
  text +=
      fmt::format("Gravity ({}, {}, {}) m/s^2 in world axes.\n", format_literal(context.gravity[0]),
                  format_literal(context.gravity[1]), format_literal(context.gravity[2]));
  for (const std::string& note : context.notes) {
    text += wrap_text(note, 95) + "\n";
  }
  if (!context.domain.empty()) {
    text += wrap_text("Bounds of rounding errors hold for inputs, taken as exact, of " +
                          context.domain + ".",
                      95) +
            "\n";
  }
  return text;
}

std::string describe_argument(const Argument& argument, const char* direction) {
  const std::string shape = argument.cols == 1 ? std::to_string(argument.rows)
                                               : fmt::format("{}x{}", argument.rows, argument.cols);
  return wrap_text(fmt::format("{} {} ({}): {}", direction, argument.name, shape, argument.meaning),
                   95) +
         "\n";
}

std::string describe_function(const EmissionContext& context, const Program& program) {
  std::string text = wrap_text(program.equation.empty() ? program.name : program.equation, 95);
  text += '\n';
  text += describe_method(program);
  for (const Argument& argument : program.arguments) {
    text += describe_argument(argument, "in ");
  }
  for (const Result& result : program.results) {
    text += describe_argument(result.argument, "out");
  }
  const int live = count_live_values(program);
  text += fmt::format("Cost: {}.\nStack, an estimate: {} values live at once, {} bytes.\n",
                      describe_cost(program), live, live * (context.single_precision ? 4 : 8));
  if (!program.singular.empty()) {
    text += wrap_text("Singularities: " + program.singular, 95) + "\n";
  }
  return text + describe_rounding(context, program.name);
}

}  // namespace

std::string print_contract(const EmissionContext& context, std::span<const Program> programs) {
  std::string declarations;
  for (const Program& program : programs) {
    declarations += declarations.empty() ? "" : "\n";
    declarations += fill_template(templates::kDeclaration,
                                  {{"comment", comment("///", describe_function(context, program))},
                                   {"signature", print_declaration(program)}});
  }
  const bool single = context.single_precision;
  return fill_template(templates::kContract,
                       {{"robot", context.robot},
                        {"version", generator_version()},
                        {"origin", comment("//", describe_origin(context))},
                        {"conventions", comment("//", describe_conventions(context))},
                        {"target", comment("//", describe_target(context))},
                        {"name", context.name},
                        {"real", single ? "float" : "double"},
                        {"bytes", single ? "4" : "8"},
                        {"fraction", single ? "23" : "52"},
                        {"digits", single ? "24" : "53"},
                        {"least", single ? "149" : "1074"},
                        {"format", single ? "binary32" : "binary64"},
                        {"f", single ? "F" : ""},
                        {"accurate", single ? "4000" : "1e5"},
                        {"largest", single ? "2^20" : "2^32"},
                        {"coordinates", std::to_string(context.coordinates)},
                        {"velocities", std::to_string(context.velocities)},
                        {"task_rows", std::to_string(context.task_rows)},
                        {"declarations", declarations}});
}

}  // namespace treeline
