#include "launch/print_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "emission/emitted_text.hpp"
#include "launch/describe_robot.hpp"
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

/// The step of time on a ground, how the robot moves where nothing touches it, and how one that
/// stands by its feet is braked.
std::string print_ground_step(const std::string& name, bool stands) {
  const char* const braking =
      "\n  static void braking_dynamics(const double (&q)[kCoordinates], const double "
      "(&)[kVelocities],\n"
      "                               const double (&qdd)[kVelocities], double "
      "(&tau)[kVelocities]) noexcept {\n"
      "    treeline::drive::brake_standing<Robot>(q, qdd, tau);\n  }";
  return fmt::format(
      "\n{1}"
      "  using GroundMemory = {0}_ground_memory;\n"
      "  using GroundReport = {0}_ground_report;\n"
      "  static void ground_step(double dt, const double (&tau)[kVelocities], double "
      "(&q)[kCoordinates],\n"
      "                          double (&qd)[kVelocities], GroundMemory& memory,\n"
      "                          GroundReport& report) noexcept {{\n"
      "    {0}_ground ground;\n"
      "    {0}_default_ground(&ground);\n"
      "    {0}_ground_step(&ground, dt, tau, q, qd, &memory, &report);\n"
      "  }}{2}",
      name, print_alias("flight_dynamics", name, "forward_dynamics"), stands ? braking : "");
}

}  // namespace

std::string print_robot(const Robot& robot, const Scene& control, const Generation& generation,
                        const Scene& links, const std::optional<Scene>& ground) {
  std::string includes = fmt::format("#include \"{}.hpp\"", control.name);
  const bool is_damped = control.damped && !is_closed(control);
  if (is_damped) includes += fmt::format("\n#include \"{}_damped.hpp\"", control.name);
  if (!links.operational_points.empty()) {
    includes += fmt::format("\n#include \"{}.hpp\"", links.name);
  }
  if (ground) {
    includes += fmt::format("\n#include \"{0}.hpp\"\n#include \"{0}_ground.h\"", ground->name);
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
       {"functions",
        print_functions(control, generation, links) +
            (ground ? print_ground_step(ground->name, is_closed(control)) : std::string()) +
            (ground && is_closed(control) ? print_soles(robot, *ground, control)
                                          : std::string())}});
}

}  // namespace treeline
