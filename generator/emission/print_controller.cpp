#include <fmt/format.h>

#include "emission/backend.hpp"
#include "emission/body_steps.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/comment.hpp"
#include "emission/controller_inputs.hpp"
#include "emission/descriptions.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"
#include "emission/print_target.hpp"
#include "emission/templates.hpp"

namespace treeline {
namespace {

/// The call of a function in the step; `forces` are the law's own in place of known ones.
std::string print_step_call(const EmissionContext& context, const Program& program,
                            const std::string& forces = {}) {
  const std::string list = join_arguments(program, [&](const Argument& argument, const char*) {
    const std::string variable = variable_of(argument.name);
    if (!variable.empty()) return variable;
    return argument.name == "f_ext" && !forces.empty() ? forces : "state->" + argument.name;
  });
  return print_own_call(context, program, list);
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
  if (std::any_of(inputs.begin(), inputs.end(),
                  [](const Argument& each) { return is_led(each.name); })) {
    text =
        "const real share = tl_adopted_share(config->period, config->fade, state->posed == 0);\n";
  }
  for (const Argument& argument : inputs) {
    text += fmt::format("tl_lead_to(&input->{0}[0], {1}, {2}, &state->{0}[0]);\n", argument.name,
                        argument.rows * argument.cols, is_led(argument.name) ? "share" : "TL_ONE");
  }
  return print_body({"config", "input", "state"}, text);
}

std::string print_sizes(const ControllerUnit& unit, const Adaptation& own) {
  std::vector<Constant> constants = {{"ROWS", unit.rows, "of the task"},
                                     {"JOINT_LAW", 0, ""},
                                     {"TASK_LAW", 1, ""},
                                     {"COMPLIANCE_LAW", 2, ""}};
  if (unit.behaves()) {
    const auto behaviours = static_cast<int>(unit.settings.behaviours.size());
    const auto shares = static_cast<int>(unit.count_shares());
    constants.push_back({"BEHAVIOURS", behaviours, ""});
    constants.push_back({"SHARE_COUNT", shares, "points whose tasks come and go"});
  }
  return print_constants(own, constants);
}

/// C++ has references to arrays, and sines by references.
std::string print_array_types(const EmissionContext& context, const ControllerUnit& unit) {
  if (!backend_of(context.language).has_references) return {};
  std::string text = "using JointArray = real[TL_JOINTS];\n";
  if (unit.task_torque) text += "using RowArray = real[TL_ROWS];\n";
  if (unit.push_torque) text += "using ForceArray = real[6 * TL_POINTS];\n";
  return text + "\n" + std::string(kSinesByPointers);
}

std::string print_measure(const EmissionContext& context, const ControllerUnit& unit) {
  std::string text = backend_of(context.language).has_references
                         ? "sin_cos(at->q, at->sin_q, at->cos_q);\n"
                         : "tl_sin_cos(TL_JOINTS, at->q, at->sin_q, at->cos_q);\n";
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
  return adapt(fill_template(templates::kControllerOfRobot, holes), own);
}

std::string print_step(const EmissionContext& context, const ControllerUnit& unit,
                       const Adaptation& own) {
  const bool scoped = backend_of(context.language).has_namespaces;
  return adapt_words(
      fill_template(templates::kControllerSource,
                    {{"name", context.name},
                     {"in", scoped ? context.name + "::detail::" : ""},
                     {"cost", comment("//", wrap_text(describe_step_cost(unit), 95))},
                     {"section", print_section_macro(context)},
                     {"code_section", print_section(context)}}),
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
    {"controller_observer", &templates::kControllerObserver},
    {"controller_pace", &templates::kControllerPace},
    {"controller_points", &templates::kControllerPoints},
    {"controller_references", &templates::kControllerReferences},
    {"controller_safety", &templates::kControllerSafety},
    {"controller_step", &templates::kControllerStep},
    {"controller_waiting", &templates::kControllerWaiting},
    {"orientation", &templates::kOrientation},
    {"quintic", &templates::kQuintic},
    {"turn_motion", &templates::kTurnMotion}};

std::vector<GeneratedFile> print_laws(const EmissionContext& context, const ControllerUnit& unit,
                                      bool for_reference) {
  const Backend& backend = backend_of(context.language);
  const Adaptation own = adapt_controller(context, unit, for_reference);
  const std::string header(backend.header);
  std::vector<GeneratedFile> files = {
      {context.name + "_controller.h", print_controller_header(context, unit)},
      {"controller" + std::string(backend.source), print_step(context, unit, own)},
      {"controller_functions" + header,
       print_own_functions(context, unit.programs(), kControllerStem, "the controller")},
      {"controller_robot" + header, print_robot(context, unit, own)}};
  for (const auto& [name, text] : kHeaders) files.push_back({name + header, adapt(*text, own)});
  return files;
}

}  // namespace

std::vector<GeneratedFile> print_controller(const Contents& contents) {
  const EmissionContext& context = contents.context;
  const ControllerUnit& unit = *context.controller;
  std::vector<GeneratedFile> files = print_laws(context, unit, false);
  for (const Program* const program : unit.programs()) {
    files.push_back({program->name + std::string(backend_of(context.language).source),
                     print_own_source(context, *program, kControllerStem)});
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
