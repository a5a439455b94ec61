#include "launch/print_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "emission/fill_template.hpp"
#include "launch/describe_robot.hpp"
#include "launch/print_closed_loops.hpp"
#include "launch/templates.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

std::string print_alias(const std::string& name, const std::string& from,
                        const std::string& function) {
  return fmt::format("  static constexpr auto& {} = {}::{};\n", name, from, function);
}

/// Tells for each velocity whether its joint turns without end, and no other follows it.
std::string print_turns(const Mechanism& mechanism) {
  std::vector<std::string> turns(static_cast<std::size_t>(mechanism.nv()), "false");
  for (const MovingLink& link : mechanism.links) {
    if (link.kind != JointKind::revolute || link.mimics) continue;
    const Coordinate& coordinate = mechanism.coordinates[static_cast<std::size_t>(link.q_index)];
    const bool ends = std::isfinite(coordinate.lower) || std::isfinite(coordinate.upper);
    const bool leads = std::any_of(
        mechanism.links.begin(), mechanism.links.end(),
        [&](const MovingLink& other) { return other.mimics && other.q_index == link.q_index; });
    if (!ends && !leads) turns[static_cast<std::size_t>(link.v_index)] = "true";
  }
  return fmt::format("  static constexpr bool kTurns[] = {{{}}};\n", fmt::join(turns, ", "));
}

std::string print_rows(const Scene& scene) {
  std::string rows;
  std::string local;
  for (std::size_t k = 0; k < scene.operational_points.size(); ++k) {
    const ScenePoint& point = scene.operational_points[k];
    for (std::size_t axis = 0; axis < point.rows.size(); ++axis) {
      if (point.rows[axis]) rows += fmt::format("{{{}, {}}}, ", k, axis);
    }
    local += point.axes == Axes::local ? "true, " : "false, ";
  }
  return fmt::format(
      "  static constexpr treeline::drive::TaskRow kRows[] = {{{}}};\n"
      "  static constexpr bool kLocalAxes[] = {{{}}};\n",
      rows, local);
}

/// `damped_control_torque` returns a number; a struct hides that.
std::string print_control_torque(const Scene& scene) {
  if (!scene.damped) return print_alias("control_torque", scene.name, "control_torque");
  return fmt::format(
      "  template <class... Arguments>\n"
      "  static void control_torque(Arguments&... arguments) noexcept {{\n"
      "    (void){}::damped_control_torque(arguments...);\n"
      "  }}\n",
      scene.name);
}

bool has(const Generation& generation, Function function) {
  return std::any_of(generation.functions.begin(), generation.functions.end(),
                     [function](const GeneratedFunction& f) { return f.function == function; });
}

/// Functions of the tree that `drive::ClosedLoops` builds on, and what it makes of them.
std::string print_closed(const Scene& control, const Generation& generation, const Scene& links) {
  std::string text = print_alias("tree_inverse_dynamics", control.name, "inverse_dynamics");
  for (const Function function :
       {Function::mass_matrix, Function::constrained_forward_dynamics,
        Function::constraint_jacobian, Function::constraint_errors, Function::bias_acceleration}) {
    if (!has(generation, function)) continue;
    text += print_alias(function_name(function), control.name, function_name(function));
  }
  return text + print_closed_loops(control, generation.mechanism, links);
}

std::string print_functions(const Scene& control, const Generation& generation,
                            const Scene& links) {
  std::string text = print_turns(generation.mechanism);
  text += is_closed(control)
              ? print_closed(control, generation, links)
              : print_alias("inverse_dynamics", control.name, "inverse_dynamics") +
                    print_alias("forward_dynamics", control.name, "forward_dynamics");
  if (!control.operational_points.empty()) {
    text += print_rows(control) +
            print_alias("forward_kinematics", control.name, "forward_kinematics") +
            print_alias("jacobian", control.name, "jacobian");
    if (has(generation, Function::point_velocity)) {
      text += print_alias("point_velocity", control.name, "point_velocity");
    }
    if (!is_closed(control)) text += print_control_torque(control);
    if (!is_closed(control) && has(generation, Function::mass_matrix)) {
      text += print_alias("mass_matrix", control.name, "mass_matrix");
    }
  }
  if (has(generation, Function::center_of_mass)) {
    text += print_alias("center_of_mass", control.name, "center_of_mass");
  }
  if (!links.operational_points.empty()) {
    text += print_alias("link_frames", links.name, "forward_kinematics") +
            print_alias("link_inverse_dynamics", links.name, "inverse_dynamics");
  }
  text.pop_back();
  return text;
}

}  // namespace

std::string print_robot(const Robot& robot, const Scene& control, const Generation& generation,
                        const Scene& links) {
  std::string includes = fmt::format("#include \"{}.hpp\"", control.name);
  const bool is_damped = control.damped && !is_closed(control);
  if (is_damped) includes += fmt::format("\n#include \"{}_damped.hpp\"", control.name);
  if (!links.operational_points.empty()) {
    includes += fmt::format("\n#include \"{}.hpp\"", links.name);
  }
  const Mechanism& mechanism = generation.mechanism;
  return fill_template(
      launch_templates::kRobot,
      {{"robot", printable(robot.name)},
       {"includes", includes},
       {"nq", std::to_string(mechanism.nq())},
       {"nv", std::to_string(mechanism.nv())},
       {"points", std::to_string(control.operational_points.size())},
       {"rows", std::to_string(mechanism.task_rows())},
       {"links", std::to_string(links.operational_points.size())},
       {"has_center_of_mass", has(generation, Function::center_of_mass) ? "true" : "false"},
       {"floating", fmt::format("{{{}}}", fmt::join(floating_joints(mechanism), ", "))},
       {"functions", print_functions(control, generation, links)}});
}

namespace {

GeneratedFile file(const char* name, std::string_view text) {
  return {name, std::string(text)};
}

/// What headers of the runtime's core include.
std::vector<GeneratedFile> emitted_headers() {
  namespace t = launch_templates;
  return {file("emitted/controller_braking.h", t::kEmittedControllerBraking),
          file("emitted/controller_measurement.h", t::kEmittedControllerMeasurement),
          file("emitted/controller_numbers.h", t::kEmittedControllerNumbers),
          file("emitted/controller_robot.h", t::kEmittedControllerRobot),
          file("emitted/controller_safety.h", t::kEmittedControllerSafety),
          file("emitted/damped_sizes.h", t::kEmittedDampedSizes),
          file("emitted/damped_solve.h", t::kEmittedDampedSolve),
          file("emitted/ldlt.h", t::kEmittedLdlt),
          file("emitted/orientation.h", t::kEmittedOrientation),
          file("emitted/quarter_turns.h", t::kEmittedQuarterTurns),
          file("emitted/remainder_in_double.h", t::kEmittedRemainderInDouble),
          file("emitted/remainder_in_float.h", t::kEmittedRemainderInFloat),
          file("emitted/angle_format.h", t::kEmittedAngleFormat),
          file("emitted/sin_cos_in_double.h", t::kEmittedSinCosInDouble),
          file("emitted/sin_cos_in_float.h", t::kEmittedSinCosInFloat),
          file("emitted/sin_cos.h", t::kEmittedSinCos),
          file("emitted/square_root.h", t::kEmittedSquareRoot),
          file("emitted/symmetric_eigen.h", t::kEmittedSymmetricEigen),
          file("emitted/turn_motion.h", t::kEmittedTurnMotion)};
}

}  // namespace

std::vector<GeneratedFile> runtime_headers() {
  namespace t = launch_templates;
  std::vector<GeneratedFile> headers = {
      file("core/command_laws.hpp", t::kCoreCommandLaws),
      file("core/coordinates.hpp", t::kCoreCoordinates),
      file("core/damped_solve.hpp", t::kCoreDampedSolve),
      file("core/emitted_braking.hpp", t::kCoreEmittedBraking),
      file("core/emitted_damped.hpp", t::kCoreEmittedDamped),
      file("core/ldlt.hpp", t::kCoreLdlt),
      file("core/message_queue.hpp", t::kCoreMessageQueue),
      file("core/mode.hpp", t::kCoreMode),
      file("core/orientation.hpp", t::kCoreOrientation),
      file("core/sin_cos.hpp", t::kCoreSinCos),
      file("core/square_root.hpp", t::kCoreSquareRoot),
      file("core/symmetric_eigen.hpp", t::kCoreSymmetricEigen),
      file("servo/clock.hpp", t::kServoClock),
      file("servo/cycle.hpp", t::kServoCycle),
      file("servo/integrate.hpp", t::kServoIntegrate),
      file("servo/gear_backlash.hpp", t::kServoGearBacklash),
      file("servo/joint_friction.hpp", t::kServoJointFriction),
      file("servo/loop.hpp", t::kServoLoop),
      file("servo/message.hpp", t::kServoMessage),
      file("servo/motion_coordinates.hpp", t::kServoMotionCoordinates),
      file("servo/robot_proxy.hpp", t::kServoRobotProxy),
      file("servo/safe_state.hpp", t::kServoSafeState),
      file("servo/safety.hpp", t::kServoSafety),
      file("servo/state_machine.hpp", t::kServoStateMachine),
      file("servo/statistics.hpp", t::kServoStatistics),
      file("servo/watch_motion.hpp", t::kServoWatchMotion),
      file("drive/avoidance.hpp", t::kDriveAvoidance),
      file("drive/closed_loops.hpp", t::kDriveClosedLoops),
      file("drive/drive_bounds.hpp", t::kDriveBounds),
      file("drive/drive_controller.hpp", t::kDriveController),
      file("drive/drive_controller_body.hpp", t::kDriveControllerBody),
      file("drive/drive_goals.hpp", t::kDriveGoals),
      file("drive/end_stops.hpp", t::kDriveEndStops),
      file("drive/held_places.hpp", t::kDriveHeldPlaces),
      file("drive/imperfect_robot.hpp", t::kDriveImperfectRobot),
      file("drive/imperfect_robot_body.hpp", t::kDriveImperfectRobotBody),
      file("drive/link_forces.hpp", t::kDriveLinkForces),
      file("drive/drive_loop.hpp", t::kDriveLoop),
      file("drive/obstacle.hpp", t::kDriveObstacle),
      file("drive/drive_task_law.hpp", t::kDriveTaskLaw),
      file("drive/driven_robot.hpp", t::kDriveRobot),
      file("drive/instruction.hpp", t::kDriveInstruction),
      file("drive/robot_library.hpp", t::kDriveLibrary),
      file("drive/reference_motion.hpp", t::kDriveRecordedMotion),
      file("drive/smooth_reference.hpp", t::kDriveReference)};
  for (GeneratedFile& each : emitted_headers()) headers.push_back(std::move(each));
  return headers;
}

}  // namespace treeline
