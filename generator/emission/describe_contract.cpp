#include <fmt/format.h>

#include "emission/backend.hpp"
#include "emission/comment.hpp"
#include "emission/costs.hpp"
#include "emission/descriptions.hpp"
#include "emission/generated_file.hpp"
#include "emission/print_files.hpp"
#include "emission/print_link_inputs.hpp"
#include "emission/print_link_table.hpp"
#include "emission/print_parts.hpp"
#include "emission/print_target.hpp"
#include "program/format_literal.hpp"
#include "program/link_loops.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

std::string describe_origin(const EmissionContext& context) {
  std::string text = "From";
  const std::size_t count = context.inputs.size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::string& file = context.inputs[i].file;
    const char* const link = i == 0 ? " " : i + 1 < count ? ", " : " and ";
    text += file.empty() ? ", without a scene," : link + printable(file);
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

constexpr const char* kNamesInSources =
    "Names in the sources: links count from 1, and headings tell which they are. s3 and c3 are "
    "sine "
    "and cosine of joint 3's angle, s23 and c23 of the sum of two. mass_3, h_3_x (first moment, kg "
    "m) and J_3_xx (inertia about the origin of the link's frame) are numbers of link 3 with all "
    "that is fixed to it, less what its joint does not feel: that is counted with the link before. "
    "link2_to_3_x places the frame of link 3 in that of link 2. t17 is a value on the way.";

std::string describe_argument(const Argument& argument, const char* direction) {
  const std::string shape = argument.cols == 1 ? std::to_string(argument.rows)
                                               : fmt::format("{}x{}", argument.rows, argument.cols);
  return wrap_text(fmt::format("{} {} ({}): {}", direction, argument.name, shape, argument.meaning),
                   95) +
         "\n";
}

/// `gravity as an argument costs 12 flops, payload 80`
std::string describe_input_costs(const EmissionContext& context, const Program& program) {
  const auto costs = context.input_costs.find(program.name);
  if (costs == context.input_costs.end()) return {};
  std::string text;
  for (const EmissionContext::InputCost& cost : costs->second) {
    text += text.empty()
                ? fmt::format("Of these, {} as an argument takes {}", cost.argument, cost.flops)
                : fmt::format(", {} {}", cost.argument, cost.flops);
  }
  return wrap_text(text + ".", 95) + "\n";
}

/// `13 values live at once, 104 bytes`
std::string describe_stack(const EmissionContext& context, const Program& program) {
  const std::size_t values = count_stack_values(program, false);
  const auto bytes = static_cast<std::size_t>(number_bytes(context));
  if (program.loops) {
    return fmt::format("{} values of work space, {} bytes, and what calls take", values,
                       values * bytes);
  }
  const std::size_t shared = context.misra ? count_shared_values(program) : 0;
  return fmt::format("{} values live at once{}, {} bytes", values,
                     shared > 0 ? fmt::format(", {} are shared by parts", shared) : "",
                     (values + shared) * bytes);
}

std::string describe_loops(const EmissionContext& context) {
  return fmt::format(
      "Branches are on the table in {} alone, so that every input takes the same "
      "instructions where the target has some for Real. Rounding is that of the operations of the "
      "loops in their order, as the generator traced them.",
      header_name(context, context.name + "_links"));
}

}  // namespace

std::string describe_conventions(const EmissionContext& context) {
  std::string text = describe_joints(context);
  for (const std::string& convention : context.joint_conventions) {
    text += wrap_text(convention, 95) + "\n";
  }
  text += describe_points("Operational points, rows of task vectors:", context.operational_points);
  text += describe_points("External forces, elements of f_ext ([force; moment] on the robot):",
                          context.external_forces);
  text += context.gravity_given
              ? "Gravity is the argument gravity, an acceleration in world axes, m/s^2.\n"
              : fmt::format("Gravity ({}, {}, {}) m/s^2 in world axes.\n",
                            format_literal(context.gravity[0]), format_literal(context.gravity[1]),
                            format_literal(context.gravity[2]));
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

std::string describe_function(const EmissionContext& context, const Program& program) {
  std::string text = wrap_text(program.equation.empty() ? program.name : program.equation, 95);
  text += '\n';
  text += describe_method(program);
  if (program.loops) text += wrap_text(describe_loops(context), 95) + "\n";
  for (const Argument& argument : program.arguments) {
    text += describe_argument(argument, "in ");
  }
  for (const Result& result : program.results) {
    text += describe_argument(result.argument, "out");
  }
  text += fmt::format("Cost: {}.\n{}Stack, an estimate: {}.\n", describe_cost(program),
                      describe_input_costs(context, program), describe_stack(context, program));
  if (!program.singular.empty()) {
    text += wrap_text("Singularities: " + program.singular, 95) + "\n";
  }
  return text + describe_rounding(context, program.name);
}

std::map<std::string, std::string> describe_contract(const EmissionContext& context) {
  const bool single = context.single_precision;
  const SineWords sines = describe_sines(single, context.misra);
  return {{"robot", context.robot},
          {"version", generator_version()},
          {"origin", comment("//", describe_origin(context))},
          {"conventions",
           comment("//", describe_conventions(context) + wrap_text(kNamesInSources, 95) + "\n")},
          {"target", comment("//", describe_target(context))},
          {"name", context.name},
          {"id_size", std::to_string(size_of_identity(context))},
          {"real", number_type(context)},
          {"digits", single ? "24" : "53"},
          {"format", single ? "binary32" : "binary64"},
          {"accurate", sines.accurate},
          {"largest", sines.largest},
          {"beyond", sines.beyond},
          {"coordinates", std::to_string(context.coordinates)},
          {"velocities", std::to_string(context.velocities)},
          {"task_rows", std::to_string(context.task_rows)}};
}

}  // namespace treeline
