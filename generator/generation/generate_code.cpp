#include "generation/generate_code.hpp"

#include <fmt/format.h>

#include <memory>
#include <set>
#include <utility>

#include "emission/backend.hpp"
#include "emission/descriptions.hpp"
#include "emission/print_files.hpp"
#include "generation/compose.hpp"
#include "generation/describe_limits.hpp"
#include "generation/describe_scene.hpp"
#include "generation/quote_for_shell.hpp"

namespace treeline {
namespace {

/// Lists the routes of a function, each in the coordinates and lanes in which it costs least.
/// Rejected ones are sorted by cost.
EmissionContext::ChoiceRow choice_row(const GeneratedFunction& generated) {
  EmissionContext::ChoiceRow row;
  row.function = source_stem(generated);
  const auto method = [](const Cost& cost, int lanes) -> EmissionContext::Method {
    return {key_of(cost.route), describe(cost.route), cost.count.flops(), cost.weighted, lanes};
  };
  row.chosen = method(generated.chosen, generated.other_lanes);
  std::set<std::string> algorithms{generated.chosen.route.algorithm};
  for (const Cost& cost : generated.rejected) {
    if (algorithms.insert(cost.route.algorithm).second) row.rejected.push_back(method(cost, 0));
  }
  return row;
}

/// Adds the text of the contract about rounding errors, and the ranges of inputs that it assumes.
void add_rounding(const Generation& generation, EmissionContext& context) {
  const Scene& scene = generation.scene;
  for (const auto* functions : {&generation.functions, &generation.batch}) {
    for (const GeneratedFunction& generated : *functions) {
      const Program& program = generated.program;
      context.rounding[source_stem(generated)] =
          describe(generated.rounding, program, rounding_unit(scene.real));
    }
  }
  if (generation.damped) {
    context.rounding[function_name(Function::damped_control_torque)] =
        describe_damped_rounding(generation.functions, scene, generation.domain);
  }
  context.domain = describe_domain(generation);
}

/// Command that regenerates the folder, if run where the files and the folder lie side by side.
std::string command_of(const Provenance& provenance, const Generation& generation) {
  return fmt::format("treeline generate{} --output {}{}", list_files(provenance),
                     generation.scene.name, describe_options(provenance, generation));
}

EmissionContext context_of(const Robot& robot, const Provenance& provenance,
                           const Generation& generation) {
  const Scene& scene = generation.scene;
  EmissionContext context = describe_scene(robot, scene, generation.mechanism);
  context.command = command_of(provenance, generation);
  for (auto& [name, text] : list_inputs(provenance)) {
    context.inputs.push_back({std::move(name), std::move(text)});
  }
  for (const auto* functions : {&generation.functions, &generation.batch}) {
    for (const auto& generated : *functions) context.choices.push_back(choice_row(generated));
  }
  context.measured = generation.choices.measured;
  context.input_costs = count_inputs(robot, scene, generation.functions);
  add_rounding(generation, context);
  if (scene.has_limits()) {
    context.limits = describe_limits(robot, scene, generation.mechanism, generation.functions);
  }
  return context;
}

/// Composes the controller that the scene asks for, and gives it to the context that prints it. Its
/// laws as `profile: plain` has them are kept in `Generation::laws`.
void add_controller(const Robot& robot, EmissionContext& context, Generation& generation) {
  generation.controller = std::make_shared<const ControllerUnit>(
      compose_controller(robot, generation.scene, generation.mechanism));
  context.controller = generation.controller;
  generation.laws = print_reference_laws(context, *generation.controller);
}

void add_ground(const Robot& robot, const Scene& scene, EmissionContext& context,
                Diagnostics& diagnostics) {
  GroundUnit unit = compose_ground(robot, scene);
  if (unit.groups.empty()) {
    diagnostics.add({Severity::error, robot.file, 0, "collision",
                     "no link that moves has a shape that could touch the ground",
                     "Give links a <collision>, or leave out `step` of the scene's ground."});
    return;
  }
  context.ground = std::make_shared<const GroundUnit>(std::move(unit));
}

}  // namespace

std::vector<Provenance::File> list_inputs(const Provenance& provenance) {
  const Provenance::File scene{provenance.scene_name, provenance.scene_text};
  if (provenance.robots.empty()) return {{provenance.urdf_name, provenance.urdf_text}, scene};
  std::vector<Provenance::File> files{scene};
  files.insert(files.end(), provenance.robots.begin(), provenance.robots.end());
  return files;
}

std::string describe_options(const Provenance& provenance, const Generation& generation) {
  const std::string choices =
      generation.choices.empty()
          ? ""
          : fmt::format(" --choices {}/manifest.json", generation.scene.name);
  return choices + provenance.options;
}

std::string list_files(const Provenance& provenance) {
  std::string files;
  for (const std::string& name : {provenance.urdf_name, provenance.scene_name}) {
    if (!name.empty()) files += " " + quote_for_shell(name);
  }
  return files;
}

std::optional<ChosenFunctions> choose_for_language(const Robot& robot, const Scene& scene,
                                                   const Choices& choices, const TellFunction& tell,
                                                   Diagnostics& diagnostics) {
  FunctionMechanisms mechanisms(robot, scene);
  backend_of(scene.language).refuse(describe_scene(robot, scene, mechanisms.whole()), diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  auto chosen = choose_functions(robot, scene, mechanisms, choices, tell, diagnostics);
  if (!chosen) return std::nullopt;
  check_held_rows(scene, chosen->mechanism, chosen->functions, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return chosen;
}

std::optional<Generation> emit_chosen(const Robot& robot, const Scene& scene,
                                      const Provenance& provenance, ChosenFunctions chosen,
                                      const TellFunction& tell, Diagnostics& diagnostics) {
  Diagnostics found;
  Generation generation{std::move(chosen), scene};
  EmissionContext context = context_of(robot, provenance, generation);
  if (scene.controller) {
    if (tell) tell("the controller");
    add_controller(robot, context, generation);
  }
  if (scene.ground_step) {
    if (tell) tell("the step on the ground");
    add_ground(robot, scene, context, found);
  }
  const std::vector<Program> programs = programs_of(generation.functions);
  const std::vector<Program> batch = programs_of(generation.batch);
  if (!found.has_errors()) generation.files = emit(context, programs, found, batch);
  for (const Diagnostic& each : found.list()) diagnostics.add(each);
  if (found.has_errors()) return std::nullopt;
  generation.conventions = describe_conventions(context);
  generation.sources = list_sources({context, programs, batch});
  generation.context = std::make_shared<const EmissionContext>(std::move(context));
  return generation;
}

std::optional<Generation> generate_code(const Robot& robot, const Scene& scene,
                                        const Provenance& provenance, Diagnostics& diagnostics,
                                        const Choices& choices, const TellFunction& tell) {
  auto chosen = choose_for_language(robot, scene, choices, tell, diagnostics);
  if (!chosen) return std::nullopt;
  return emit_chosen(robot, scene, provenance, std::move(*chosen), tell, diagnostics);
}

}  // namespace treeline
