#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "choice/choose_loops.hpp"
#include "choice/function_mechanisms.hpp"
#include "description/read_keys.hpp"
#include "description/robot_queries.hpp"
#include "description/scene_inputs.hpp"
#include "generation/compose.hpp"
#include "generation/generate_code.hpp"
#include "passes/count_operations.hpp"
#include "passes/passes.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline {
namespace {

Program named(Program program, const char* name) {
  program.name = name;
  return program;
}

/// The scene with the operational points as places of forces in world axes.
Scene scene_of_forces(const Scene& scene) {
  Scene forces = scene;
  forces.external_forces = scene.operational_points;
  for (ScenePoint& point : forces.external_forces) {
    point.axes = Axes::world;
    point.rows.fill(true);
  }
  forces.operational_points.clear();
  forces.inputs = {};
  return forces;
}

/// Passes that a program of given sines goes through.
Program finish(Program program, const char* name) {
  std::vector<PassReport> log;
  program = reduce_operations(take_sines(canonicalize(program)), log);
  return put_in_order(named(std::move(program), name), log);
}

Program trace_push(const Robot& robot, const Scene& scene) {
  const Scene forces = scene_of_forces(scene);
  FunctionMechanisms mechanisms(robot, forces);
  Program program = trace_against_forces(mechanisms.of(Function::inverse_dynamics), scene.lanes);
  program.equation = "tau = -J^T f_ext, for [force; moment] on the operational points, world axes";
  return finish(std::move(program), "controller_push_torque");
}

constexpr const char* kKinematics = "controller_kinematics";
constexpr const char* kOwnGravity = "controller_gravity";
constexpr const char* kPoses = "poses and velocities [v; w] of the operational points";
constexpr const char* kGravity = "g: the joint forces that hold the robot at rest";

Program trace_kinematics(const Robot& robot, const Scene& scene,
                         const std::vector<Function>& functions, const std::string& equation) {
  FunctionMechanisms mechanisms(robot, scene);
  const Mechanism& mechanism = mechanisms.of(functions[functions.size() > 1 ? 1 : 0]);
  Program program = trace_together(mechanism, functions, scene.lanes);
  program.equation = equation;
  return finish(std::move(program), kKinematics);
}

Program trace_poses(const Robot& robot, const Scene& scene) {
  return trace_kinematics(robot, scene, {Function::forward_kinematics, Function::point_velocity},
                          kPoses);
}

Program trace_gravity(const Robot& robot, const Scene& scene) {
  return trace_kinematics(robot, scene, {Function::gravity}, kGravity);
}

/// Whether g depends on what the caller tells of the robot, which poses do not.
bool is_gravity_told(const Scene& scene) {
  return std::any_of(kQuantities.begin(), kQuantities.end(), [&](const QuantityInfo& row) {
    return is_of_model(row.quantity) && takes_input(scene, Function::gravity, row.quantity);
  });
}

/// All that a step measures.
void add_kinematics(const Robot& robot, const Scene& scene, ControllerUnit& unit) {
  if (!scene.controller->task) {
    unit.kinematics = trace_gravity(robot, scene);
  } else if (is_gravity_told(scene)) {
    unit.kinematics = trace_poses(robot, scene);
    unit.gravity = named(trace_gravity(robot, scene), kOwnGravity);
  } else {
    unit.kinematics = trace_kinematics(
        robot, scene, {Function::forward_kinematics, Function::point_velocity, Function::gravity},
        fmt::format("{}, and the joint forces g that hold the robot at rest", kPoses));
  }
}

/// Makes dynamics loops over links where the code is smaller so.
void loop_over_links(const Robot& robot, const Scene& scene, ControllerUnit& unit) {
  FunctionMechanisms mechanisms(robot, scene);
  const Mechanism& mechanism = mechanisms.whole();
  const bool task = unit.task_torque.has_value();
  const auto flops = [](const Program& program) { return count_operations(program).flops(); };
  const Program poses = task ? trace_poses(robot, scene) : Program();
  // Without a task the kinematics are gravity alone.
  const Program gravity = task ? trace_gravity(robot, scene) : unit.kinematics;
  const auto of_gravity =
      unit.gravity ? flops(*unit.gravity) : flops(unit.kinematics) - (task ? flops(poses) : 0);
  std::vector<LoopCandidate> candidates = {
      {Function::gravity, &gravity, of_gravity},
      {Function::inverse_dynamics, &unit.joint_torque, flops(unit.joint_torque)}};
  if (task) {
    candidates.push_back({Function::control_torque, &*unit.task_torque, flops(*unit.task_torque)});
  }
  std::vector<Program> loops = choose_loops_together(mechanism, scene, candidates);
  if (loops.empty()) return;
  if (task) {
    unit.kinematics = poses;
    unit.gravity = named(std::move(loops[0]), kOwnGravity);
    unit.task_torque = std::move(loops[2]);
  } else {
    unit.kinematics = std::move(loops[0]);
  }
  unit.joint_torque = std::move(loops[1]);
}

Program trace_torque(const Robot& robot, const Scene& scene, Function function, const char* name) {
  FunctionMechanisms mechanisms(robot, scene);
  RouteOptions options = route_options(scene);
  options.sin_cos = Sines::given;
  return named(generate_function(mechanisms.of(function), function, options).program, name);
}

std::vector<ControllerUnit::Joint> list_joints(const Robot& robot, const Scene& scene,
                                               const Mechanism& mechanism) {
  std::vector<ControllerUnit::Joint> joints;
  for (const Coordinate& coordinate : mechanism.coordinates) {
    const Joint& joint = *find_joint(robot, coordinate.joint);
    const Limits limits = limits_in_controller(joint, *scene.controller);
    const bool led = std::any_of(robot.joints.begin(), robot.joints.end(), [&](const Joint& each) {
      return each.mimic && &robot.joints[static_cast<std::size_t>(each.mimic->joint)] == &joint;
    });
    const auto motor = scene.controller->motors.find(coordinate.joint);
    const bool told = motor != scene.controller->motors.end();
    joints.push_back({coordinate.joint, coordinate.kind == CoordinateKind::displacement,
                      limits.lower, limits.upper, limits.velocity, limits.effort, led,
                      told ? motor->second.ratio * motor->second.constant : 0});
  }
  return joints;
}

}  // namespace

ControllerUnit compose_controller(const Robot& robot, const Scene& given,
                                  const Mechanism& mechanism) {
  Scene scene = given;
  scene.singular = SingularTasks::early;  // so that joints are not thrown
  ControllerUnit unit;
  unit.settings = *scene.controller;
  unit.joints = list_joints(robot, scene, mechanism);
  unit.settings.speed_rise =
      std::max(unit.settings.speed_rise, find_speed_rise(mechanism, unit.joints));
  add_kinematics(robot, scene, unit);
  unit.joint_torque =
      trace_torque(robot, scene, Function::inverse_dynamics, "controller_joint_torque");
  if (scene.controller->task) {
    unit.task_torque =
        trace_torque(robot, scene, Function::control_torque, "controller_task_torque");
  }
  if (scene.optimize == Optimize::size) loop_over_links(robot, scene, unit);
  if (!scene.controller->task) return unit;
  if (scene.controller->force) unit.push_torque = trace_push(robot, scene);
  const std::vector<std::string>& shared = scene.inputs.active_tasks;
  for (const ScenePoint& point : scene.operational_points) {
    const auto share = std::find(shared.begin(), shared.end(), point.name);
    unit.points.push_back({point.name, point.rows, point.axes == Axes::local,
                           share == shared.end() ? -1 : static_cast<int>(share - shared.begin())});
    unit.rows += static_cast<int>(std::count(point.rows.begin(), point.rows.end(), true));
  }
  return unit;
}

}  // namespace treeline
