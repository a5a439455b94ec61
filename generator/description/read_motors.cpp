#include <fmt/format.h>

#include <cmath>

#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"

namespace treeline {
namespace {

constexpr const char* kExample = "write joint: {ratio: 100, torque_constant: 0.05, current: 10}";

/// A number of a motor; absent: what it was.
void read_motor_number(const SceneFields& fields, const char* key, bool signed_number,
                       const char* unit, double& number) {
  const auto found = fields.find(key);
  if (found == fields.end()) return;
  const auto read = found->second.number();
  if (!read) return;
  if (!(signed_number ? *read != 0 : *read > 0)) {
    found->second.error(fmt::format("{} is {}", *read, signed_number ? "no ratio" : "not positive"),
                        fmt::format("write it in {}", unit));
    return;
  }
  number = *read;
}

}  // namespace

void read_motors(const SceneElement& element, const Robot& robot, const Scene& scene,
                 SceneController& controller) {
  for (const auto& [name, value] : element.entries(kExample)) {
    const Joint* const joint = find_joint(value, name, robot);
    if (joint == nullptr) continue;
    if (!is_driven(*joint, scene)) {
      value.error("no motor drives this joint", "remove this line");
      continue;
    }
    const auto fields = value.fields({"ratio", "torque_constant", "current"});
    SceneMotor& motor = controller.motors[name];
    read_motor_number(fields, "ratio", true, "turns of the motor for one of the joint",
                      motor.ratio);
    read_motor_number(fields, "torque_constant", false, "N m/A", motor.constant);
    read_motor_number(fields, "current", false, "A", motor.current);
    if (!fields.contains("torque_constant")) {
      value.error("the key \"torque_constant\" is missing", kExample);
    }
  }
}

void check_motors(const SceneElement& top, const Robot& robot, const Scene& scene) {
  const auto& motors = scene.controller->motors;
  if (motors.empty()) return;
  for (const Joint& joint : robot.joints) {
    if (!is_driven(joint, scene)) continue;
    if (motors.contains(joint.name)) {
      const double torque = limits_in_controller(joint, *scene.controller).effort;
      if (std::isfinite(torque)) continue;
      top.error(
          fmt::format("the torque of joint \"{}\" has no limit, so its current has none",
                      joint.name),
          fmt::format("state one: controller: {{motors: {{{}: {{current: 10}}}}}}", joint.name));
      continue;
    }
    top.error(fmt::format("the controller tells currents, but not of joint \"{}\"", joint.name),
              fmt::format("list its motor too, controller: {{motors: {{{}: ...}}}}, or none",
                          joint.name));
  }
}

}  // namespace treeline
