#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "description/read_keys.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

/// A limit that the controller reads: where files and where the scene have it.
struct ControllerLimit {
  const char* key;
  Limit Limits::*of_file;
  std::optional<double> SceneJointLimits::*of_scene;
};

/// Limits that are told together.
struct ControllerGuard {
  const char* what;
  std::vector<ControllerLimit> limits;
  const char* stated;
  const char* waived;
};

const std::array<ControllerGuard, 3> kGuards = {
    {{"range of positions",
      {{"lower", &Limits::lower, &SceneJointLimits::lower},
       {"upper", &Limits::upper, &SceneJointLimits::upper}},
      "lower: -1, upper: 1",
      "lower: none, upper: none"},
     {"limit of speed",
      {{"velocity", &Limits::velocity, &SceneJointLimits::speed}},
      "speed: 1",
      "speed: none"},
     {"limit of torque",
      {{"effort", &Limits::effort, &SceneJointLimits::torque}},
      "torque: 10",
      "torque: none"}}};

/// What the largest current of a joint's motor gives, N m or N; infinite where it states none.
double torque_of_current(const Joint& joint, const SceneController& controller) {
  constexpr double kUnlimited = std::numeric_limits<double>::infinity();
  const auto motor = controller.motors.find(joint.name);
  if (motor == controller.motors.end() || !(motor->second.current > 0)) return kUnlimited;
  return std::abs(motor->second.ratio) * motor->second.constant * motor->second.current;
}

/// Limits that a joint lacks, with the placeholders that stand in their place; empty where none is
/// missing.
std::string describe_missing(const Joint& joint, const SceneController& controller,
                             const ControllerGuard& guard) {
  const auto stated = controller.limits.find(joint.name);
  const SceneJointLimits own =
      stated == controller.limits.end() ? SceneJointLimits{} : stated->second;
  bool missing = false;
  std::string placeholders;
  for (const ControllerLimit& each : guard.limits) {
    const Limit limit = joint.limits.value_or(Limits{}).*each.of_file;
    if ((own.*each.of_scene).has_value() || limit.is_stated()) continue;
    if (each.of_file == &Limits::effort && std::isfinite(torque_of_current(joint, controller))) {
      continue;
    }
    missing = true;
    if (limit.state() != LimitState::implausible) continue;
    placeholders +=
        fmt::format("{}{}={:g}", placeholders.empty() ? "" : " ", each.key, limit.written());
  }
  if (!missing) return {};
  return fmt::format("\"{}\"{}", joint.name,
                     placeholders.empty() ? "" : " (" + placeholders + " is a placeholder)");
}

void check_guard(const SceneElement& top, const std::vector<const Joint*>& joints,
                 const SceneController& controller, const ControllerGuard& guard) {
  constexpr std::size_t kMostJointsNamed = 4;
  std::vector<std::string> missing;
  std::string first;
  for (const Joint* joint : joints) {
    if (guard.limits.size() > 1 && !info_of(joint->type).has_range) continue;
    const std::string what = describe_missing(*joint, controller, guard);
    if (what.empty()) continue;
    if (missing.empty()) first = joint->name;
    missing.push_back(what);
  }
  if (missing.empty()) return;
  top.error(fmt::format("the controller has no {} of {}", guard.what,
                        list_first(missing, kMostJointsNamed)),
            fmt::format("state it: controller: {{limits: {{{0}: {{{1}}}}}}}; or waive it by name: "
                        "{{{0}: {{{2}}}}}",
                        first, guard.stated, guard.waived));
}

/// One end may be the scene's, the other the URDF's.
void check_ends(const SceneElement& top, const Joint& joint, const SceneController& controller) {
  const Limits limits = limits_in_controller(joint, controller);
  if (limits.lower < limits.upper) return;
  top.error(fmt::format("the controller has an empty range of \"{}\": lower, {}, is not below "
                        "upper, {}",
                        joint.name, limits.lower.value(), limits.upper.value()),
            "state both under controller: limits");
}

}  // namespace

bool is_driven(const Joint& joint, const Scene& scene) {
  return info_of(joint.type).has_one_freedom() && !joint.mimic &&
         !scene.locked.contains(joint.name);
}

Limits limits_in_controller(const Joint& joint, const SceneController& controller) {
  Limits limits = joint.limits.value_or(Limits{});
  const auto own = controller.limits.find(joint.name);
  for (const ControllerGuard& guard : kGuards) {
    for (const ControllerLimit& each : guard.limits) {
      if (own == controller.limits.end()) break;
      if (const auto stated = own->second.*each.of_scene) limits.*each.of_file = *stated;
    }
  }
  const double most = torque_of_current(joint, controller);
  if (most < limits.effort) limits.effort = most;
  return limits;
}

void check_controller_limits(const SceneElement& top, const Robot& robot, const Scene& scene) {
  std::vector<const Joint*> joints;
  for (const Joint& joint : robot.joints) {
    if (is_driven(joint, scene)) joints.push_back(&joint);
  }
  for (const ControllerGuard& guard : kGuards) check_guard(top, joints, *scene.controller, guard);
  for (const Joint* joint : joints) check_ends(top, *joint, *scene.controller);
}

}  // namespace treeline
