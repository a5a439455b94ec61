#include "launch/driven_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "description/follow_target.hpp"
#include "description/total_mass.hpp"
#include "launch/assume_damping.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/leave_out_singular.hpp"

namespace treeline {
namespace {

/// Beyond this many links a pull would cost too much of a cycle, and its code too long to compile.
constexpr std::size_t kMostLinks = 80;

void note_left_out(const Scene& scene, Diagnostics& diagnostics) {
  std::string left;
  const auto add = [&left](bool there, const char* what) {
    if (there) left += (left.empty() ? "" : ", ") + std::string(what);
  };
  add(!scene.objects.empty(), "objects");
  add(!scene.contacts.empty(), "contacts");
  add(!scene.external_forces.empty(), "external_forces");
  add(!scene.inputs.empty(), "inputs");
  add(scene.batch > 0, "batch");
  add(scene.has_limits(), "limits of torque and friction");
  add(scene.controller.has_value(), "controller");
  add(scene.real == Real::float32, "real: float");
  add(scene.sin_cos == Sines::given, "sin_cos: given");
  add(scene.implicit_friction, "implicit friction");
  add(scene.language == Language::c, "language: c");
  add(scene.target != "generic", "target");
  if (left.empty()) return;
  diagnostics.add(
      {Severity::note, scene.file, 0, "", "left out while the robot is driven: " + left, ""});
}

bool has_loops(const Scene& scene) {
  return !scene.loops.empty() || !scene.couplings.empty();
}

/// Loops of the robot's own can be driven by the motors of their joints. What holds the robot to
/// the world, or leads a task across a loop, cannot yet.
void check_constraints(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  const auto refuse = [&](const char* element, const char* fault, const char* remedy) {
    diagnostics.add({Severity::error, scene.file, 0, element, fault, remedy});
  };
  if (!scene.constraints.empty()) {
    refuse(
        "constraints", "a robot that is held to the world cannot be driven yet",
        "remove the constraints to the world: `base: fixed` holds it, and a floating base is held "
        "by ideal forces");
  }
  if (!has_loops(scene)) return;
  const Mechanism mechanism = build_mechanism(robot, scene);
  if (mechanism.nq() != mechanism.nv()) {
    refuse("constraints", "closed loops of a robot with a quaternion cannot be driven yet",
           "write `base: fixed`, or remove the loops");
  }
  if (static_cast<int>(scene.passive.size()) == mechanism.nv()) {
    refuse("passive", "no joint has a motor", "leave out the joints that motors move");
  }
}

/// Task control knows the tree alone.
void leave_out_points(Scene& control, Diagnostics& diagnostics) {
  if (!has_loops(control) || control.operational_points.empty()) return;
  control.operational_points.clear();
  control.damped.reset();
  diagnostics.add({Severity::warning, control.file, 0, "operational_points",
                   "the points are not driven: their task does not know the closed loops",
                   "move the motors by `joint`, or remove the loops"});
}

std::vector<Function> functions_for(const Scene& scene, const Robot& robot) {
  std::vector<Function> functions = {Function::inverse_dynamics, Function::forward_dynamics};
  if (has_loops(scene)) {
    functions = {Function::constrained_forward_dynamics, Function::constraint_errors,
                 Function::constraint_jacobian};
  }
  if (!scene.operational_points.empty()) {
    functions.insert(functions.end(), {Function::forward_kinematics, Function::jacobian});
    if (scene.damped) {
      functions.insert(functions.end(), kDampedFunctions.begin(), kDampedFunctions.end());
    } else {
      functions.push_back(Function::control_torque);
    }
  }
  if (total_mass(robot) > 0) functions.push_back(Function::center_of_mass);
  std::sort(functions.begin(), functions.end());
  functions.erase(std::unique(functions.begin(), functions.end()), functions.end());
  return functions;
}

}  // namespace

Scene control_scene(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  note_left_out(scene, diagnostics);
  check_constraints(robot, scene, diagnostics);
  Scene control = scene;
  control.language = Language::cpp;
  control.target = "generic";
  follow_target(control);
  control.objects.clear();
  control.contacts.clear();
  control.constraints.clear();
  if (!has_loops(scene)) control.passive.clear();  // of a tree every joint is moved
  leave_out_points(control, diagnostics);
  assume_damping(robot, control, diagnostics);
  control.remove_limits();
  control.controller.reset();
  control.external_forces.clear();
  control.inputs = {};
  control.implicit_friction = false;
  control.batch = 0;
  control.real = Real::float64;
  control.sin_cos = Sines::computed;
  control.functions = functions_for(control, robot);
  if (build_mechanism(robot, control).nv() == 0) {
    diagnostics.add({Severity::error, robot.file, 0, "", "nothing of this robot moves",
                     "Give it joints that move, or a scene with `base: floating`."});
    return control;
  }
  leave_out_singular(robot, control, true, diagnostics);
  return control;
}

Scene link_scene(const Robot& robot, const Scene& control) {
  Scene scene = control;
  scene.name = control.name + "_links";
  scene.damped.reset();
  scene.loops.clear();
  scene.couplings.clear();
  scene.passive.clear();
  scene.operational_points.clear();
  scene.functions = {Function::forward_kinematics, Function::inverse_dynamics};
  if (robot.links.size() > kMostLinks) return scene;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (static_cast<int>(i) == robot.root && control.base == Base::fixed) continue;
    ScenePoint point;
    point.name = fmt::format("link{}", i);
    point.link = robot.links[i].name;
    scene.operational_points.push_back(point);
  }
  scene.external_forces = scene.operational_points;
  return scene;
}

}  // namespace treeline
