#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "emission/backend.hpp"
#include "emission/controller_unit.hpp"
#include "emission/costs.hpp"
#include "emission/descriptions.hpp"
#include "passes/count_operations.hpp"
#include "text/printable.hpp"

namespace treeline {

std::vector<std::string> list_controller_sources(Language language, const ControllerUnit& unit) {
  const std::string ending(backend_of(language).source);
  std::vector<std::string> sources = {"controller" + ending};
  for (const Program* const program : unit.programs()) sources.push_back(program->name + ending);
  return sources;
}

std::size_t count_step_stack(const ControllerUnit& unit, bool misra, int bytes_of_number) {
  constexpr std::size_t kOfAJoint = 15;  // measured, sines, gravity, references, accelerations
  constexpr std::size_t kOfAPoint = 18;  // pose and velocity
  constexpr std::size_t kOfTheLaw = 80;  // motion of the point at work, its errors
  std::size_t values = 0;
  for (const Program* const program : unit.programs()) {
    values = std::max(values, count_stack_values(*program, misra));
  }
  values += kOfAJoint * unit.joints.size();
  if (!unit.points.empty()) values += (kOfAPoint * unit.points.size()) + kOfTheLaw;
  return values * static_cast<std::size_t>(bytes_of_number);
}

std::string describe_laws(const ControllerUnit& unit) {
  std::string text =
      "MOVE_JOINTS and START: joint impedance with computed torque, tau = M qdd + b + g with qdd = "
      "a + 2 z w (v - qd) + w^2 (p - q) for a reference p, v, a, frequency w and ratio z; gravity "
      "is compensated, and every joint behaves alike whatever its inertia. ";
  if (unit.task_torque) {
    text +=
        "MOVE_POINT: task impedance (Khatib 1987), xdd = a + 2 z w (v - xd) + w^2 e with the pose "
        "error e, a rotation vector in its angular part, through the operational-space inertia; "
        "the posture is where joints were led last. Rows that a singularity leaves immovable "
        "yield, "
        "see control_torque; the torque stays finite. ";
  }
  if (unit.settings.force) {
    text +=
        "PRESS: along a direction n the point moves as a damped mass under the force that is "
        "missing, xdd . n = force_gain (f_wanted - f + integral) - force_damping xd . n, and the "
        "measured force f is compensated, tau += J^T n f. The integral rests while the torque is "
        "cut. The other directions follow their task. ";
  }
  if (unit.behaves()) {
    text +=
        "BEHAVE: the tasks of another behaviour are done. Within the duration the share to which "
        "each is done moves by a quintic, see control_torque, and the torque with it. A point "
        "whose task comes is held where it is; of one whose task is not done whole the error is "
        "no fault, and commands that would move or press it are refused. ";
  }
  text += "COMPLY: springs and dampers, tau = g + K (p - q) + (D + c M) (v - qd)";
  text += unit.settings.force ? " + sum J^T (K e + D (v - xd))" : "";
  text +=
      ", about the pose where it was told, with joint_stiffness in N m/rad and so on; D of a joint "
      "is its viscosity and what joint_damping_ratio asks for. It is passive";
  if (unit.settings.force) text += ", where the three stiffnesses that turn a point are the same";
  text += ", and without stiffness the robot is led by hand. LEAD_JOINTS";
  text += unit.settings.force ? " and LEAD_POINT move" : " moves";
  text += " p along a quintic. At the ends of their range springs turn joints back.";
  return text;
}

std::string describe_step_cost(const ControllerUnit& unit) {
  std::string text;
  for (const Program* const program : unit.programs()) {
    text += fmt::format("{}{} {} flops", text.empty() ? "" : ", ", program->name,
                        count_operations(*program).flops());
  }
  return fmt::format("{}; sine and cosine of {} angles, and the law's own.", text,
                     unit.joints.size());
}

std::string list_joint_names(const ControllerUnit& unit) {
  std::string text = "Joints:";
  for (std::size_t i = 0; i < unit.joints.size(); ++i) {
    text += fmt::format("{} {} {}", i == 0 ? "" : ",", i, printable(unit.joints[i].name));
  }
  for (std::size_t i = 0; i < unit.points.size(); ++i) {
    text += fmt::format("{} {} {}", i == 0 ? ". Points:" : ",", i, printable(unit.points[i].name));
  }
  return text + ".";
}

std::string describe_files(const EmissionContext& context, const ControllerUnit& unit) {
  return fmt::format("Files to compile, as {}: {}. No other source of this folder is needed.",
                     backend_of(context.language).standard,
                     fmt::join(list_controller_sources(context.language, unit), ", "));
}

std::string describe_step_stack(const ControllerUnit& unit, bool misra, int bytes_of_number) {
  return fmt::format(
      "Stack, an estimate: {} bytes. `treeline check --target` measures stack and instructions.",
      count_step_stack(unit, misra, bytes_of_number));
}

}  // namespace treeline
