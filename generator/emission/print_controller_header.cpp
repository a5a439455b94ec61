#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>
#include <vector>

#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/controller_faults.hpp"
#include "emission/controller_inputs.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "emission/templates.hpp"
#include "text/identifier.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

/// A member of a struct and its meaning, beside it or before it.
std::string print_commented(const std::string& declaration, const std::string& meaning) {
  constexpr std::size_t kWidth = 98;  // between the blanks of a struct and the margin
  if (meaning.empty()) return declaration + "\n";
  const std::string commented = fmt::format("/* {} */", in_comment(meaning, kWidth - 6));
  const bool fits = declaration.size() + 1 + commented.size() <= kWidth;
  return fits ? declaration + " " + commented + "\n" : commented + "\n" + declaration + "\n";
}

/// Members of the state that keep inputs.
std::string print_led_inputs(const EmissionContext& context, const ControllerUnit& unit) {
  std::string text;
  for (const Argument& argument : list_inputs(unit)) {
    text += fmt::format("{}_number {}[{}]; /* {} */\n", context.name, argument.name,
                        argument.rows * argument.cols,
                        is_led(argument.name) ? "led to the input's" : "the input's last finite");
  }
  return text;
}

std::string print_inputs(const EmissionContext& context, const ControllerUnit& unit) {
  std::string text;
  for (const Argument& argument : list_inputs(unit)) {
    text += print_commented(fmt::format("{}_number {}[{}];", context.name, argument.name,
                                        argument.rows * argument.cols),
                            printable(argument.meaning));
  }
  return text;
}

/// `names` with the prefix of the robot: a declaration a line.
std::string declare(const std::string& robot,
                    const std::vector<std::pair<std::string, std::string>>& members) {
  std::string text;
  for (const auto& [member, meaning] : members) {
    text += print_commented(fmt::format("{}_number {};", robot, member), meaning);
  }
  return text;
}

/// Members of the structs that only controllers with laws of tasks have.
void add_task_holes(const EmissionContext& context, const ControllerUnit& unit, Holes& holes) {
  const std::string points = name_in_capitals(context) + "_POINTS";
  for (const char* hole : {"task_config", "task_command", "task_output", "task_state"}) {
    holes[hole] = "";
  }
  if (!unit.task_torque) return;
  const auto fill = [&](const char* hole,
                        const std::vector<std::pair<std::string, std::string>>& members) {
    holes[hole] = declare(context.name, members);
  };
  fill("task_config",
       {{"task_frequency[6 * " + points + "]", "rad/s, by point: x y z rx ry rz of the world"},
        {"task_damping[6 * " + points + "]", "ratio"},
        {"posture_frequency[" + name_in_capitals(context) + "_JOINTS]",
         "rad/s, of motions that the task leaves free"},
        {"point_speed", "m/s of a point along its reference"},
        {"point_turn", "rad/s"}});
  fill("task_command", {{"position[3]", "m, world"}, {"rotation[9]", "of the point's axes"}});
  fill("task_output",
       {{"task_error[6 * " + points + "]", "m, rad: reference less measured, world axes"}});
  holes["task_output"] +=
      fmt::format("int32_t unmet; /* of {}_unmet, until another motion begins */\n", context.name);
  fill("task_state",
       {{"posture[" + name_in_capitals(context) + "_JOINTS]", "where joints were led last"},
        {"point_motion[24 * " + points + "]", ""},
        {"point_from[9 * " + points + "]", "rotation at the motion's begin"},
        {"point_rate[" + points + "]", "1/s"},
        {"point_lag[" + points + "]", "s, by which its clock is behind the steps"},
        {"point_slow[" + points + "]", "0: its clock runs with them, 1: it stands"},
        {"point_slow_rate[" + points + "]", "1/s"},
        {"away", "m, rad: the largest error of a point"},
        {"fastest", "share of a limit of speed, smoothed"}});
  holes["task_state"] += fmt::format(
      "int32_t point_ticks[{}];\nint32_t stuck_ticks;\nint32_t cut_ticks;\nint32_t unmet;\n",
      points);
}

void add_force_holes(const EmissionContext& context, const ControllerUnit& unit, Holes& holes) {
  const std::string name = context.name;
  for (const char* hole :
       {"force_config", "force_command", "force_input", "force_output", "force_state"}) {
    holes[hole] = "";
  }
  if (!unit.settings.force) return;
  const std::string points = name_in_capitals(context) + "_POINTS";
  holes["force_config"] =
      declare(name, {{"force_gain", "1/kg, of the force that is missing"},
                     {"force_rate", "1/s, of its integral; below force_damping"},
                     {"force_damping", "1/s, of motion along the direction"},
                     {"largest_force", "N, that is commanded, compensated, integrated"},
                     {"point_stiffness[6 * " + points + "]", "N/m, N m/rad, of COMPLY"},
                     {"point_viscosity[6 * " + points + "]", "N s/m, N m s/rad"}});
  holes["force_command"] = declare(
      name, {{"direction[3]", "of length 1, world"}, {"force", "N, that the point shall exert"}});
  holes["force_input"] =
      declare(name, {{"force[3]", "N, measured: that the pressing point exerts, world"}});
  holes["force_output"] = declare(name, {{"force_error", "N, wanted less measured"}});
  holes["force_state"] =
      "int32_t pressing;\nint32_t press_point;\nint32_t press_ticks;\n"
      "int32_t contact_ticks; /* 0: none yet; more than 1: since it was lost */\n" +
      declare(name, {{"press_rate", "1/s"},
                     {"press_force", "N"},
                     {"force_integral", "N"},
                     {"direction[3]", ""}});
}

/// Behaviours by name, each with the tasks that it does, and members of controllers that have them.
void add_behaviour_holes(const EmissionContext& context, const ControllerUnit& unit, Holes& holes) {
  for (const char* hole :
       {"behaviours", "behaviour_config", "behaviour_output", "behaviour_state"}) {
    holes[hole] = "";
  }
  if (!unit.behaves()) return;
  const std::string name = context.name, capitals = name_in_capitals(context);
  const auto& all = unit.settings.behaviours;
  std::string list;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string tasks = fmt::format("{}", fmt::join(all[k].tasks, ", "));
    list +=
        print_commented(fmt::format("  {}_BEHAVIOUR_{} = {}{}", capitals, in_capitals(all[k].name),
                                    k, k + 1 == all.size() ? "" : ","),
                        tasks.empty() ? "none of them" : printable(tasks));
  }
  holes["behaviours"] = fmt::format(
      "/* Behaviours, each with the tasks that it does of those that come and go. The first is\n"
      "   what the controller begins with. */\n"
      "typedef enum {0}_behaviour {{\n{1}}} {0}_behaviour;\n\n",
      name, list);
  const std::string shares = fmt::format("[{}]", unit.count_shares());
  holes["behaviour_config"] =
      declare(name, {{fmt::format("behaviour_share[{} * {}]", all.size(), unit.count_shares()),
                      "0 to 1, by behaviour: the share to which a task is done"}});
  holes["behaviour_output"] = fmt::format("int32_t behaviour; /* of {}_behaviour */\n", name);
  holes["behaviour_state"] =
      "int32_t behaviour;\nint32_t share_ticks;\n" +
      declare(name, {{"share_rate", "1/s"},
                     {"share_from" + shares, "when the behaviour began"},
                     {"active_tasks" + shares, "share to which each task is done"}});
}

/// Members of controllers that tell the currents of motors.
void add_current_holes(const EmissionContext& context, const ControllerUnit& unit, Holes& holes) {
  holes["current_config"] = holes["current_output"] = "";
  if (!unit.tells_currents()) return;
  const std::string joints = "[" + name_in_capitals(context) + "_JOINTS]";
  holes["current_config"] =
      declare(context.name, {{"torque_per_ampere" + joints, "N m/A, N/A, behind the gear"}});
  holes["current_output"] =
      declare(context.name, {{"current" + joints, "A: tau over torque_per_ampere"}});
}

/// Enumerators of the faults, each with its meaning.
std::string print_faults(const EmissionContext& context) {
  std::string text;
  for (const ControllerFault& fault : kControllerFaults) {
    const bool last = fault.bit == kControllerFaults.back().bit;
    text += print_commented(fmt::format("{}_FAULT_{} = {}{}", name_in_capitals(context), fault.name,
                                        fault.bit, last ? "" : ","),
                            fault.meaning);
  }
  return text;
}

}  // namespace

std::string print_controller_header(const EmissionContext& context, const ControllerUnit& unit) {
  Holes holes = {
      {"robot", in_comment(printable(context.robot))},
      {"name", context.name},
      {"NAME", name_in_capitals(context)},
      {"real", number_type(context)},
      {"laws", in_comment("Laws: " + describe_laws(unit))},
      {"cost", in_comment("Cost of a step, at most: " + describe_step_cost(unit) + " " +
                          describe_step_stack(unit, context.misra, number_bytes(context)))},
      {"files", in_comment(describe_files(context, unit))},
      {"faults", print_faults(context)},
      {"joints", std::to_string(unit.joints.size())},
      {"points", std::to_string(unit.points.size())},
      {"joint_list", in_comment(list_joint_names(unit))},
      {"task", unit.task_torque ? "true" : "false"},
      {"force", unit.settings.force ? "true" : "false"},
      {"model_inputs", print_inputs(context, unit)},
      {"model_state", print_led_inputs(context, unit)}};
  add_task_holes(context, unit, holes);
  add_force_holes(context, unit, holes);
  add_behaviour_holes(context, unit, holes);
  add_current_holes(context, unit, holes);
  return fill_template(templates::kControllerHeader, holes);
}

}  // namespace treeline
