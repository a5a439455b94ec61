#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "description/scene.hpp"
#include "program/program.hpp"

namespace treeline {

/// Parts of NAME_controller.h and controller.cpp: functions that share the sines that a step
/// computes once, and the configuration's defaults.
struct ControllerUnit {
  SceneController settings;            ///< without the limits, which are below
  Program kinematics;                  ///< poses, velocities, gravity: `controller_kinematics`
  std::optional<Program> gravity;      ///< of its own where it loops: `controller_gravity`
  Program joint_torque;                ///< inverse dynamics: `controller_joint_torque`
  std::optional<Program> task_torque;  ///< of a law of tasks: `controller_task_torque`
  std::optional<Program> push_torque;  ///< of a law of forces: `controller_push_torque`

  /// One coordinate; limits are infinite where there are none.
  struct Joint {
    std::string name;
    bool slides = false;
    double lower = 0, upper = 0, speed = 0, torque = 0;
    bool led = false;              ///< other joints follow it
    double torque_per_ampere = 0;  ///< of its motor behind its gear; 0: not told

    /// Whether the joint turns without end, so that angles a turn apart are the same pose.
    [[nodiscard]] bool turns() const {
      return !slides && !led && std::isinf(lower) && std::isinf(upper);
    }
  };
  std::vector<Joint> joints;

  /// One operational point of the laws of tasks.
  struct Point {
    std::string name;
    std::array<bool, 6> rows{};
    bool own_axes = false;
    int share = -1;  ///< place among the points whose tasks come and go; -1: it is always done
  };
  std::vector<Point> points;
  int rows = 0;  ///< of all points

  /// How many points there are whose tasks come and go.
  [[nodiscard]] std::size_t count_shares() const {
    return static_cast<std::size_t>(std::count_if(
        points.begin(), points.end(), [](const Point& point) { return point.share >= 0; }));
  }
  /// Whether commands choose between behaviours.
  [[nodiscard]] bool behaves() const { return !settings.behaviours.empty(); }
  /// Whether the output has currents beside torques.
  [[nodiscard]] bool tells_currents() const { return !settings.motors.empty(); }
  [[nodiscard]] std::vector<const Program*> programs() const {
    std::vector<const Program*> all = {&kinematics, &joint_torque};
    if (gravity) all.push_back(&*gravity);
    if (task_torque) all.push_back(&*task_torque);
    if (push_torque) all.push_back(&*push_torque);
    return all;
  }
};

}  // namespace treeline
