#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "description/read_keys.hpp"
#include "description/read_scene_point.hpp"

namespace treeline {
namespace {

const std::vector<std::string> kLaws = {"joint_impedance", "task_impedance", "force"};

void read_laws(const SceneElement& element, SceneController& controller) {
  const std::vector<SceneElement> items =
      element.is_list() ? element.items() : std::vector<SceneElement>{element};
  if (items.empty()) element.error("no law is listed", "list one of joint_impedance and others");
  std::vector<std::size_t> seen;
  for (const SceneElement& item : items) {
    const auto law = item.choice(kLaws);
    if (!law) continue;
    if (std::count(seen.begin(), seen.end(), *law) > 0) {
      item.error(fmt::format("{} is listed twice", kLaws[*law]), "list it once");
    }
    seen.push_back(*law);
    controller.task = controller.task || *law > 0;
    controller.force = controller.force || *law == 2;
  }
}

/// A number of the map from `least` to `most`.
struct NumberKey {
  const char* key;
  double SceneController::*value;
  double least, most;
  const char* remedy;
};

const std::vector<NumberKey> kNumbers = {
    {"period", &SceneController::period, 1e-6, 1, "seconds between two steps, such as 0.001"},
    {"joint_frequency", &SceneController::joint_frequency, 0, 1e4, "rad/s, such as 20"},
    {"task_frequency", &SceneController::task_frequency, 0, 1e4, "rad/s, such as 20"},
    {"posture_frequency", &SceneController::posture_frequency, 0, 1e4, "rad/s, such as 5"},
    {"damping_ratio", &SceneController::damping_ratio, 0, 10, "1 damps critically"},
    {"brake_damping", &SceneController::brake_damping, 1e-3, 1e4, "1/s, such as 20"},
    {"hold_frequency", &SceneController::hold_frequency, 1e-3, 1e4, "rad/s, such as 60"},
    {"observer", &SceneController::observer, 1e-3, 1e4, "rad/s, such as 300"},
    {"hold_reach", &SceneController::hold_reach, 1e-6, 10, "rad or m, such as 0.05"},
    {"jump", &SceneController::jump, 1e-6, 1e9, "rad or m, such as 0.05"},
    {"following", &SceneController::following, 1e-6, 1e9, "rad or m, such as 0.3"},
    {"speed_rise", &SceneController::speed_rise, 0, 10, "seconds, such as 0.15"},
    {"torque_rise", &SceneController::torque_rise, 1e-6, 10, "seconds, such as 0.025"},
    {"point_speed", &SceneController::point_speed, 1e-6, 1e3, "m/s, such as 0.25"},
    {"point_turn", &SceneController::point_turn, 1e-6, 1e3, "rad/s, such as 1"},
    {"position_margin", &SceneController::position_margin, 0, 10, "rad or m, such as 0.05"},
    {"speed_margin", &SceneController::speed_margin, 0, 10, "a share of the limit, such as 0.1"},
    {"fade", &SceneController::fade, 0, 10, "seconds, such as 0.1"},
    {"force_gain", &SceneController::force_gain, 0, 100, "1/kg, such as 0.05"},
    {"force_rate", &SceneController::force_rate, 0, 1e4, "1/s, such as 2"},
    {"force_damping", &SceneController::force_damping, 0, 1e4, "1/s, such as 60"},
    {"largest_force", &SceneController::largest_force, 0, 1e6, "N, such as 50"},
};

void read_ticks(const SceneFields& fields, const char* key, int& ticks) {
  const auto found = fields.find(key);
  if (found == fields.end()) return;
  const auto number = found->second.number();
  if (!number) return;
  if (*number < 0 || *number > 1e9 || *number != static_cast<double>(static_cast<int>(*number))) {
    found->second.error(fmt::format("{} is no number of steps", *number),
                        "write a whole number from 0 to 1000000000");
    return;
  }
  ticks = static_cast<int>(*number);
}

void read_numbers(const SceneFields& fields, SceneController& controller) {
  for (const NumberKey& row : kNumbers) {
    const auto found = fields.find(row.key);
    if (found == fields.end()) continue;
    const auto number = found->second.number();
    if (!number) continue;
    if (*number < row.least || *number > row.most) {
      found->second.error(fmt::format("{} is not between {} and {}", *number, row.least, row.most),
                          fmt::format("write {}", row.remedy));
      continue;
    }
    controller.*row.value = *number;
  }
  const auto rise = fields.find("speed_rise");
  if (rise != fields.end()) controller.speed_rise_line = rise->second.line();
  read_ticks(fields, "stale_ticks", controller.stale_ticks);
  read_ticks(fields, "blind_ticks", controller.blind_ticks);
}

/// `none`, the infinity, where the scene waives the limit.
void read_bound(const SceneFields& fields, const char* key, double none, bool positive,
                std::optional<double>& bound) {
  const auto found = fields.find(key);
  if (found == fields.end()) return;
  if (found->second.is("none")) {
    bound = none;
    return;
  }
  bound = found->second.number();
  if (bound && positive && !(*bound > 0)) {
    found->second.error(fmt::format("{} is not positive", *bound), "write none for no limit");
  }
}

bool can_have_limits(const SceneElement& value, const Joint& joint, const Scene& scene) {
  if (scene.locked.contains(joint.name)) {
    value.error("the joint is locked", "remove this line");
  } else if (!info_of(joint.type).has_one_freedom()) {
    value.error("the joint has not one degree of freedom", "remove this line");
  } else if (joint.mimic) {
    value.error("the joint follows another", "limit the joint that it follows");
  } else {
    return true;
  }
  return false;
}

void read_limits(const SceneElement& element, const Robot& robot, const Scene& scene,
                 SceneController& controller) {
  for (const auto& [name, value] : element.entries("write joint: {speed: rad/s, torque: N m}")) {
    const Joint* const joint = find_joint(value, name, robot);
    if (joint == nullptr || !can_have_limits(value, *joint, scene)) continue;
    const auto fields = value.fields({"lower", "upper", "speed", "torque"});
    SceneJointLimits& limits = controller.limits[name];
    constexpr double kWaived = std::numeric_limits<double>::infinity();
    read_bound(fields, "lower", -kWaived, false, limits.lower);
    read_bound(fields, "upper", kWaived, false, limits.upper);
    read_bound(fields, "speed", kWaived, true, limits.speed);
    read_bound(fields, "torque", kWaived, true, limits.torque);
    if (limits.lower && limits.upper && !(*limits.lower < *limits.upper)) {
      value.error(fmt::format("lower, {}, is not below upper, {}", *limits.lower, *limits.upper),
                  "exchange them");
    }
  }
}

/// A sampled law moves what it controls by a share of about frequency times period a step.
void check_frequencies(const SceneElement& element, const SceneController& controller) {
  constexpr double kMost = 0.5;
  const auto check = [&](const char* key, double rate) {
    if (rate * controller.period <= kMost) return;
    element.error(
        fmt::format("{} is {} a second, which a period of {} s cannot follow", key, rate,
                    controller.period),
        fmt::format("keep it at {} or below, or shorten the period", kMost / controller.period));
  };
  check("joint_frequency", controller.joint_frequency);
  if (controller.task) check("task_frequency", controller.task_frequency);
  if (controller.task) check("posture_frequency", controller.posture_frequency);
  check("brake_damping", controller.brake_damping);
  check("hold_frequency", controller.hold_frequency);
  if (controller.force) check("force_damping", controller.force_damping);
  check("observer", controller.observer);
  if (controller.observer > 0 && controller.observer < 4 * controller.hold_frequency) {
    element.error(fmt::format("what an observer of {} rad/s finds is too late for a hold_frequency "
                              "of {} rad/s",
                              controller.observer, controller.hold_frequency),
                  fmt::format("let observer be {} rad/s or more, or lower hold_frequency",
                              4 * controller.hold_frequency));
  }
  if (controller.force && !(controller.force_rate < controller.force_damping)) {
    element.error(
        fmt::format("with force_rate {} and force_damping {} the force swings ever more against "
                    "whatever is stiff",
                    controller.force_rate, controller.force_damping),
        "keep force_rate below force_damping");
  }
}

}  // namespace

std::string find_unfit_joint(const Robot& robot, const Scene& scene) {
  for (const Joint& joint : robot.joints) {
    const JointTypeInfo& type = info_of(joint.type);
    if (!type.moves() || scene.locked.contains(joint.name)) continue;
    if (!type.has_one_freedom()) {
      return fmt::format("joint \"{}\" is {} and has several degrees of freedom", joint.name,
                         joint_type_name(joint.type));
    }
  }
  if (!scene.passive.empty()) return fmt::format("joint \"{}\" is passive", scene.passive.front());
  return {};
}

void read_controller(const SceneElement& element, const Robot& robot, Scene& scene) {
  std::vector<std::string> keys = {"laws",   "saturation", "stale_ticks", "blind_ticks",
                                   "limits", "motors",     "behaviours"};
  for (const NumberKey& row : kNumbers) keys.emplace_back(row.key);
  const auto fields = element.fields(keys);
  SceneController controller;
  if (const auto laws = fields.find("laws"); laws != fields.end()) {
    read_laws(laws->second, controller);
  } else {
    element.error("the key \"laws\" is missing",
                  "list some of joint_impedance, task_impedance, force");
  }
  if (const auto saturation = fields.find("saturation"); saturation != fields.end()) {
    controller.clamps = saturation->second.choice({"scale", "clamp"}) == 1;
  }
  read_numbers(fields, controller);
  if (!fields.contains("hold_frequency")) {
    // Two steps of delay then leave a phase margin of 60 degrees.
    controller.hold_frequency = std::min(controller.hold_frequency, 0.06 / controller.period);
  }
  if (const auto limits = fields.find("limits"); limits != fields.end()) {
    read_limits(limits->second, robot, scene, controller);
  }
  if (const auto motors = fields.find("motors"); motors != fields.end()) {
    read_motors(motors->second, robot, scene, controller);
  }
  if (const auto behaviours = fields.find("behaviours"); behaviours != fields.end()) {
    read_behaviours(behaviours->second, scene, controller);
  }
  check_frequencies(element, controller);
  scene.controller = controller;
}

std::vector<Function> list_controller_functions(const Scene& scene) {
  if (!scene.controller) return {};
  std::vector<Function> functions = {Function::gravity, Function::inverse_dynamics};
  if (scene.controller->task) {
    functions.insert(functions.end(), {Function::forward_kinematics, Function::point_velocity,
                                       Function::control_torque});
  }
  return functions;
}

void check_controller(const SceneElement& scene_top, const Robot& robot,
                      const std::string& singular, const Scene& scene) {
  if (!scene.controller) return;
  const SceneElement top = scene_top.at("controller");
  const char* const kRemedy =
      "remove controller, and use the functions with a loop of your own (supported_control_torque "
      "where not every joint has a motor)";
  if (scene.base == Base::floating) {
    top.error("a controller drives every coordinate, but no motor moves the floating base",
              kRemedy);
  } else if (const std::string unfit = find_unfit_joint(robot, scene); !unfit.empty()) {
    top.error(fmt::format("a controller drives every coordinate by a motor, but {}", unfit),
              kRemedy);
  } else if (scene.holds_rows()) {
    top.error("a controller drives the open tree, but constraints or couplings are listed",
              kRemedy);
  }
  check_controller_limits(top, robot, scene);
  check_motors(top, robot, scene);
  check_behaviours(top, scene);
  if (scene.controller->task && scene.operational_points.empty()) {
    top.error("the controller has a law of tasks, but there is no operational point",
              "add a list operational_points, or keep to laws: [joint_impedance]");
  }
  if (scene.controller->task && !singular.empty()) {
    top.error(
        fmt::format("nothing beyond {} has mass: the mass matrix is singular, and laws of "
                    "tasks need its inverse",
                    singular),
        "give it mass in the robot's file, lock the joint, or keep to laws: [joint_impedance]");
  }
  if (scene.controller->task && scene.singular == SingularTasks::exact) {
    top.error("the controller's torque is not finite at singularities with singular: exact",
              "leave out singular, so that rows yield");
  }
}

}  // namespace treeline
