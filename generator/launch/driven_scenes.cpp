#include "launch/driven_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "description/follow_target.hpp"
#include "description/robot_queries.hpp"
#include "description/scene_inputs.hpp"
#include "description/scene_queries.hpp"
#include "launch/print_robot.hpp"
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
  add(has_center_of_mass(scene), kCenterOfMass);
  add(scene.batch > 0, "batch");
  add(scene.has_limits(), "limits of torque and friction");
  add(!scene.passive.empty() && !is_closed(scene), "passive (every joint of a tree is moved)");
  add(scene.controller.has_value(), "controller");
  add(scene.ground_step.has_value(), "the step on the ground");
  add(scene.real == Real::float32, "real: float");
  add(scene.sin_cos == Sines::given, "sin_cos: given");
  add(scene.implicit_friction, "implicit friction");
  add(scene.language != Language::cpp, "language");
  add(scene.target != "generic", "target");
  if (left.empty()) return;
  diagnostics.add(
      {Severity::note, scene.file, 0, "", "left out while the robot is driven: " + left, ""});
}

/// Checks the links that are held to the world. Finding their places takes the links' frames.
void check_held_links(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  if (scene.constraints.empty()) return;
  if (robot.links.size() > kMostLinks) {
    diagnostics.add({Severity::error, scene.file, 0, "constraints",
                     fmt::format("a robot of more than {} links that is held to the world cannot "
                                 "be driven",
                                 kMostLinks),
                     "remove links behind fixed joints, or the constraints"});
  }
  const std::string& root = robot.links[static_cast<std::size_t>(robot.root)].name;
  for (const ScenePoint& point : scene.constraints) {
    if (scene.base != Base::fixed || point.link != root) continue;
    diagnostics.add({Severity::error, scene.file, 0, "constraints/" + point.name,
                     fmt::format("\"{}\" stands still already", point.link),
                     "remove the constraint, or write `base: floating`"});
  }
}

void check_constraints(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  if (!is_closed(scene)) return;
  check_held_links(robot, scene, diagnostics);
  if (scene.passive.empty() && !(scene.loops.empty() && scene.couplings.empty())) {
    diagnostics.add(
        {Severity::note, scene.file, 0, "passive",
         "every joint of the closed loops has a motor: where goals of joints contradict "
         "each other they meet in the middle",
         "list joints without a motor, and the loops lead them"});
  }
  const Mechanism mechanism = build_mechanism(robot, scene);
  if (static_cast<int>(unmotored_velocities(scene, mechanism).size()) < mechanism.nv()) return;
  diagnostics.add({Severity::error, scene.file, 0, "passive", "no joint has a motor",
                   "leave out the joints that motors move"});
}

std::vector<Function> functions_for(const Scene& scene, const Robot& robot) {
  std::vector<Function> functions = {Function::inverse_dynamics, Function::forward_dynamics};
  if (is_closed(scene)) {
    functions = {Function::inverse_dynamics, Function::constrained_forward_dynamics,
                 Function::constraint_jacobian};
    if (!scene.loops.empty() || !scene.couplings.empty()) {
      functions.push_back(Function::constraint_errors);
    }
  }
  if (!scene.operational_points.empty()) {
    functions.insert(functions.end(), {Function::forward_kinematics, Function::jacobian});
    const auto& points = scene.operational_points;
    if (std::any_of(points.begin(), points.end(),
                    [](const ScenePoint& point) { return point.axes == Axes::local; })) {
      functions.push_back(Function::point_velocity);  // by which the axes of rows turn
    }
    if (is_closed(scene)) {
      functions.insert(functions.end(), {Function::mass_matrix, Function::bias_acceleration});
    } else if (scene.damped) {
      functions.insert(functions.end(), kDampedFunctions.begin(), kDampedFunctions.end());
    } else {
      functions.push_back(Function::control_torque);
    }
    const Mechanism mechanism = build_mechanism(robot, scene);
    if (mechanism.nv() > mechanism.task_rows()) functions.push_back(Function::mass_matrix);
  }
  if (total_mass(robot) > 0) functions.push_back(Function::center_of_mass);
  std::sort(functions.begin(), functions.end());
  functions.erase(std::unique(functions.begin(), functions.end()), functions.end());
  return functions;
}

/// Refuses what a robot that is driven on a ground does not have.
void check_ground(const Robot& robot, const Scene& control, const SceneGround& ground,
                  Diagnostics& diagnostics) {
  const auto refuse = [&](const char* element, std::string fault, const char* remedy) {
    diagnostics.add({Severity::error, control.file, 0, element, std::move(fault), remedy});
  };
  if (!control.loops.empty() || !control.couplings.empty() ||
      build_mechanism(robot, control).has_mimics()) {
    refuse("ground", "on a ground no robot with closed loops or followers can be driven",
           "leave out `ground`, or lock joints that follow others");
  }
  if (control.base == Base::floating && control.constraints.empty()) {
    refuse("ground", "nothing says on which links the robot stands",
           "list its feet in `constraints`, each between the foot and the world: its motors then "
           "carry it by these");
  }
  for (const ScenePoint& hold : control.constraints) {
    if (has_sole(robot, hold.link, control.touches)) continue;
    refuse("ground", fmt::format("\"{}\" has nothing that could touch the ground", hold.link),
           "give it a <collision>: a box, cylinder, capsule, sphere or mesh, whose file is there");
  }
  if (ground.restitution > 0) {
    diagnostics.add({Severity::note, control.file, 0, "ground",
                     "left out while the robot is driven: restitution", ""});
  }
}

/// The robot's tree alone, without what holds or leads it.
Scene scene_of_tree(const Scene& control, const char* ending) {
  Scene scene = control;
  scene.name = control.name + ending;
  scene.damped.reset();
  scene.constraints.clear();
  scene.loops.clear();
  scene.couplings.clear();
  scene.passive.clear();
  scene.operational_points.clear();
  return scene;
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
  std::erase_if(control.operational_points, is_center_of_mass);
  if (!is_closed(scene)) control.passive.clear();  // of a tree every joint is moved
  assume_damping(robot, control, diagnostics);
  control.remove_limits();
  control.controller.reset();
  control.ground_step.reset();
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
  require_accelerations(robot, control, diagnostics);
  return control;
}

Scene link_scene(const Robot& robot, const Scene& control) {
  Scene scene = scene_of_tree(control, "_links");
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

Scene ground_scene(const Robot& robot, const Scene& control, const SceneGround& ground,
                   Diagnostics& diagnostics) {
  check_ground(robot, control, ground, diagnostics);
  Scene scene = scene_of_tree(control, "_standing");
  scene.functions = {Function::forward_dynamics};
  scene.ground_step = ground;
  return scene;
}

}  // namespace treeline
