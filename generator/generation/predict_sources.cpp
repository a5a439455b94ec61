#include "generation/predict_sources.hpp"

#include "description/scene_queries.hpp"
#include "emission/controller_unit.hpp"
#include "emission/ground_unit.hpp"
#include "emission/list_sources.hpp"
#include "emission/selftest_facts.hpp"
#include "functions/function.hpp"

namespace treeline {
namespace {

Program name_program(const std::string& name) {
  Program program;
  program.name = name;
  return program;
}

/// A controller of functions that are names alone.
std::shared_ptr<const ControllerUnit> name_controller(const Scene& scene) {
  const SceneController& controller = *scene.controller;
  ControllerUnit unit;
  unit.kinematics = name_program("controller_kinematics");
  unit.joint_torque = name_program("controller_joint_torque");
  if (scene.optimize == Optimize::size) unit.gravity = name_program("controller_gravity");
  if (controller.task) unit.task_torque = name_program("controller_task_torque");
  if (controller.task && controller.force) {
    unit.push_torque = name_program("controller_push_torque");
  }
  return std::make_shared<const ControllerUnit>(std::move(unit));
}

/// A step on the ground of functions that are names alone.
std::shared_ptr<const GroundUnit> name_ground() {
  GroundUnit unit;
  unit.flight = name_program("ground_flight");
  unit.heights = name_program("ground_heights");
  unit.dynamics = name_program("ground_dynamics");
  unit.energy = name_program("ground_energy");
  return std::make_shared<const GroundUnit>(std::move(unit));
}

}  // namespace

std::vector<std::string> predict_sources(const Scene& scene) {
  EmissionContext context;
  context.name = scene.name;
  context.language = scene.language;
  context.misra = scene.profile == Profile::misra;
  context.effective_mass_limits = effective_mass_limits(scene);
  if (scene.has_limits()) context.limits.emplace();
  if (scene.controller) context.controller = name_controller(scene);
  if (scene.ground_step) context.ground = name_ground();
  if (scene.selftest > 0) context.selftest = std::make_shared<const SelftestFacts>();
  std::vector<Program> programs;
  for (const Function function : scene.functions) {
    programs.push_back(name_program(function_name(function)));
  }
  std::vector<std::string> stems;
  for (const Source& source :
       list_sources({context, programs, scene.batch > 0 ? programs : std::vector<Program>{}})) {
    stems.push_back(source.file.substr(0, source.file.find('.')));
  }
  return stems;
}

}  // namespace treeline
