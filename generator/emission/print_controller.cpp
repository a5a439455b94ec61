#include "emission/print_controller.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "emission/adapt_controller.hpp"
#include "emission/backend/backend.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/controller_faults.hpp"
#include "emission/describe_controller.hpp"
#include "emission/fill_template.hpp"
#include "emission/print_constants.hpp"
#include "emission/print_defaults.hpp"
#include "emission/print_prefetch.hpp"
#include "emission/print_target.hpp"
#include "emission/templates.hpp"
#include "emission/wrap_line.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

/// Name in the step of an argument of its functions; empty for one that the input has.
std::string variable_of(const std::string& argument) {
  static const std::map<std::string, std::string> kVariables = {{"q", "at->q"},
                                                                {"sin_q", "at->sin_q"},
                                                                {"cos_q", "at->cos_q"},
                                                                {"qd", "at->qd"},
                                                                {"qdd", "qdd"},
                                                                {"qdd_0", "qdd_0"},
                                                                {"tau", "tau"},
                                                                {"xdd_cmd", "xdd_cmd"},
                                                                {"position", "at->position"},
                                                                {"g", "at->gravity"},
                                                                {"rotation", "at->rotation"},
                                                                {"velocity", "at->velocity"}};
  const auto found = kVariables.find(argument);
  return found == kVariables.end() ? std::string() : found->second;
}

/// Whether an argument describes the robot: the step leads it to what it becomes, so that torques
/// have no step. Places of tools and known forces are taken as they are.
bool is_led(const std::string& argument) {
  return argument == "gravity" || argument == "payload" || argument == "parameters" ||
         argument == "base_parameters";
}

/// The call of a function in the step; `forces` are the law's own in place of known ones.
std::string print_step_call(const EmissionContext& context, const Program& program,
                            const std::string& forces = {}) {
  std::string list;
  const auto append = [&](const Argument& argument) {
    std::string variable = variable_of(argument.name);
    if (variable.empty()) {
      const std::string from = is_led(argument.name) ? "state->" : "input->";
      variable = argument.name == "f_ext" && !forces.empty() ? forces : from + argument.name;
    }
    list += (list.empty() ? "" : ", ") + variable;
  };
  for (const Argument& argument : program.arguments) append(argument);
  for (const Result& result : program.results) append(result.argument);
  const std::string prefix = context.language == Language::c ? context.name + "_" : "";
  return wrap_in_hole(fmt::format("{}{}({});", prefix, program.name, list), 2);
}

/// Arguments that the input brings beside q and qd: what of the robot changes, known forces.
std::vector<Argument> list_inputs(const ControllerUnit& unit) {
  std::vector<Argument> inputs;
  for (const Program* const program : unit.programs()) {
    if (unit.push_torque && program == &*unit.push_torque) continue;
    for (const Argument& argument : program->arguments) {
      const bool known = !variable_of(argument.name).empty() ||
                         std::any_of(inputs.begin(), inputs.end(), [&](const Argument& listed) {
                           return listed.name == argument.name;
                         });
      if (!known) inputs.push_back(argument);
    }
  }
  return inputs;
}

/// Text within a comment of C: no end and no begin of one, lines of the width of the rest.
std::string in_comment(std::string text, std::size_t columns = 94) {
  for (const char* mark : {"*/", "/*"}) {
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at)) {
      text.insert(at + 1, 1, ' ');
    }
  }
  std::string wrapped = wrap_text(text, columns);
  for (std::size_t at = wrapped.find('\n'); at != std::string::npos; at = wrapped.find('\n', at)) {
    wrapped.insert(at + 1, 1, ' ');
    at += 2;
  }
  return wrapped;
}

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
    if (!is_led(argument.name)) continue;
    text += fmt::format("{}_number {}[{}]; /* led to the input's */\n", context.name, argument.name,
                        argument.rows * argument.cols);
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

/// Statements of a function of the robot, before which C is told what they do not read.
std::string print_body(std::initializer_list<const char*> parameters, const std::string& text) {
  std::string unread;
  for (const std::string parameter : parameters) {
    if (text.find(parameter + "->") == std::string::npos) unread += "(void)" + parameter + ";\n";
  }
  return unread + text;
}

/// A statement that returns whether all these inputs are finite.
std::string print_finite(const std::vector<Argument>& inputs) {
  std::string text;
  for (const Argument& argument : inputs) {
    text += fmt::format("{}tl_are_numbers(&input->{}[0], {})", text.empty() ? "" : " &&\n    ",
                        argument.name, argument.rows * argument.cols);
  }
  return print_body({"input"}, "return " + (text.empty() ? "true" : text) + ";");
}

/// Statements that lead what describes the robot to what it has become.
std::string print_adopt(const std::vector<Argument>& inputs) {
  std::string text;
  for (const Argument& argument : inputs) {
    if (!is_led(argument.name)) continue;
    if (text.empty()) {
      text =
          "const real share = tl_adopted_share(config->period, config->fade, state->posed == 0);\n";
    }
    text += fmt::format("tl_lead_to(&input->{0}[0], {1}, share, &state->{0}[0]);\n", argument.name,
                        argument.rows * argument.cols);
  }
  return print_body({"config", "input", "state"}, text);
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
      fmt::format("int32_t unmet; /* of {}_unmet, until another command */\n", context.name);
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

std::string print_header(const EmissionContext& context, const ControllerUnit& unit) {
  Holes holes = {
      {"robot", in_comment(printable(context.robot))},
      {"name", context.name},
      {"NAME", name_in_capitals(context)},
      {"real", number_type(context)},
      {"laws", in_comment("Laws: " + describe_laws(unit))},
      {"fade", "config.fade"},
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
  return fill_template(templates::kControllerHeader, holes);
}

/// The declarations of what a step calls, which the contract does not have.
std::string print_functions(const EmissionContext& context, const ControllerUnit& unit) {
  const Backend& backend = backend_of(context.language);
  std::string declarations;
  for (const Program* const program : unit.programs()) {
    declarations += backend.print_declaration(context, *program) + "\n";
  }
  const std::string front = fmt::format(
      "#pragma once\n// What the controller calls beside the functions of {0}{1}.\n"
      "// Generated; see {0}_controller.h for the contract.\n#include \"{0}{1}\"\n\n",
      context.name, backend.header);
  if (context.language == Language::c) return front + declarations;
  return fmt::format("{1}namespace {0} {{\n\n{2}\n}}  // namespace {0}\n", context.name, front,
                     declarations);
}

/// A function of the controller, which another header than that of the contract declares.
std::string print_step_function(const EmissionContext& context, const Program& program) {
  const Backend& backend = backend_of(context.language);
  const std::string contract = fmt::format("#include \"{}{}\"", context.name, backend.header);
  std::string text = backend.print_source(context, program);
  return text.replace(text.find(contract), contract.size(),
                      fmt::format("#include \"controller_functions{}\"", backend.header));
}

std::string print_sizes(const ControllerUnit& unit, const Adaptation& own) {
  const Constant constants[] = {{"ROWS", unit.rows, "of the task"},
                                {"JOINT_LAW", 0, ""},
                                {"TASK_LAW", 1, ""},
                                {"COMPLIANCE_LAW", 2, ""},
                                {"DISCONNECT", 1, "a command of loops, which stops"}};
  return print_constants(own, constants);
}

/// C++ has references to arrays, and sines by references.
std::string print_array_types(const EmissionContext& context, const ControllerUnit& unit) {
  if (context.language == Language::c) return {};
  std::string text = "using JointArray = real[TL_JOINTS];\n";
  if (unit.task_torque) text += "using RowArray = real[TL_ROWS];\n";
  if (unit.push_torque) text += "using ForceArray = real[6 * TL_POINTS];\n";
  return text +
         "\nTL_INLINE void tl_sin_cos_of(real x, real* sine, real* cosine) {\n"
         "  sin_cos(x, *sine, *cosine);\n}\n";
}

std::string print_measure(const EmissionContext& context, const ControllerUnit& unit) {
  std::string text = context.language == Language::c
                         ? "tl_sin_cos(TL_JOINTS, at->q, at->sin_q, at->cos_q);\n"
                         : "sin_cos(at->q, at->sin_q, at->cos_q);\n";
  text += print_step_call(context, unit.kinematics);
  if (unit.gravity) text += "\n" + print_step_call(context, *unit.gravity);
  return print_body({"input", "state"}, text);
}

std::string print_robot(const EmissionContext& context, const ControllerUnit& unit,
                        const Adaptation& own) {
  const std::vector<Argument> inputs = list_inputs(unit);
  const auto print_torque = [&](const Program* program, const char* forces) {
    return program == nullptr
               ? std::string()
               : print_body({"input", "state"}, print_step_call(context, *program, forces));
  };
  Holes holes = {
      {"name", context.name},
      {"constants", print_sizes(unit, own)},
      {"arrays", print_array_types(context, unit)},
      {"finite", print_finite(inputs)},
      {"adopt", print_adopt(inputs)},
      {"measure", print_measure(context, unit)},
      {"joint_torque", print_torque(&unit.joint_torque, "")},
      {"task_torque", print_torque(unit.task_torque ? &*unit.task_torque : nullptr, "")},
      {"push_torque", print_torque(unit.push_torque ? &*unit.push_torque : nullptr, "f")}};
  add_controller_numbers(context, unit, holes);
  return adapt(fill_template(templates::kControllerRobot, holes), own);
}

std::string print_step(const EmissionContext& context, const ControllerUnit& unit,
                       const Adaptation& own) {
  const bool is_c = context.language == Language::c;
  return adapt_words(
      fill_template(
          templates::kControllerSource,
          {{"name", context.name},
           {"in", is_c ? "" : context.name + "::detail::"},
           {"cost", comment("//", wrap_text(describe_step_cost(unit), 95))},
           {"section", print_section_macro(context) +
                           print_prefetch_macro(context, kControllerStem, Attributes::whole)},
           {"code_section", print_section(context)},
           {"step_section", print_prefetch_section(context)}}),
      own);
}

/// Headers of runtime/emitted that the step includes.
constexpr std::pair<const char*, std::string_view const*> kHeaders[] = {
    {"controller_braking", &templates::kControllerBraking},
    {"controller_commands", &templates::kControllerCommands},
    {"controller_compliance", &templates::kControllerCompliance},
    {"controller_config", &templates::kControllerConfig},
    {"controller_drift", &templates::kControllerDrift},
    {"controller_faults", &templates::kControllerFaults},
    {"controller_following", &templates::kControllerFollowing},
    {"controller_laws", &templates::kControllerLaws},
    {"controller_mailbox", &templates::kControllerMailbox},
    {"controller_measurement", &templates::kControllerMeasurement},
    {"controller_numbers", &templates::kControllerNumbers},
    {"controller_pace", &templates::kControllerPace},
    {"controller_points", &templates::kControllerPoints},
    {"controller_references", &templates::kControllerReferences},
    {"controller_safety", &templates::kControllerSafety},
    {"controller_step", &templates::kControllerStep},
    {"orientation", &templates::kOrientation},
    {"quintic", &templates::kQuintic},
    {"turn_motion", &templates::kTurnMotion}};

std::vector<GeneratedFile> print_laws(const EmissionContext& context, const ControllerUnit& unit,
                                      bool for_reference) {
  const Backend& backend = backend_of(context.language);
  const Adaptation own = adapt_controller(context, unit, for_reference);
  const std::string header(backend.header);
  std::vector<GeneratedFile> files = {
      {context.name + "_controller.h", print_header(context, unit)},
      {"controller" + std::string(backend.source), print_step(context, unit, own)},
      {"controller_functions" + header, print_functions(context, unit)},
      {"controller_robot" + header, print_robot(context, unit, own)}};
  for (const auto& [name, text] : kHeaders) files.push_back({name + header, adapt(*text, own)});
  return files;
}

}  // namespace

std::vector<GeneratedFile> print_controller(const EmissionContext& context,
                                            const ControllerUnit& unit) {
  std::vector<GeneratedFile> files = print_laws(context, unit, false);
  for (const Program* const program : unit.programs()) {
    files.push_back({program->name + std::string(backend_of(context.language).source),
                     print_step_function(context, *program)});
  }
  return files;
}

std::vector<GeneratedFile> print_reference_laws(const EmissionContext& context,
                                                const ControllerUnit& unit) {
  EmissionContext plain = context;
  plain.language = Language::cpp;
  plain.misra = false;
  return print_laws(plain, unit, true);
}

}  // namespace treeline
