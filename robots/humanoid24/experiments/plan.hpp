#pragma once

#include <array>
#include <string>
#include <vector>

#include "servo/safety.hpp"

namespace treeline::experiments {

/// Content of touch_floor.yaml, put_box.yaml or hit_wall.yaml. Joints are in the generated code's
/// order; SI units.
struct Plan {
  std::vector<std::string> joints;
  std::vector<double> start;              ///< q at rest, and the desired posture
  std::vector<double> posture_stiffness;  ///< per joint, 1/s^2; critically damped
  double spring = 0.0;                    ///< one for all joints, N m/rad; 0: none is given
  double limit_margin = 0.0;              ///< where limits begin to push, rad
  double limit_strength = 0.0;            ///< of that push at a limit, N m
  std::array<double, 3> target{};         ///< position of what moves, world axes, m
  double duration = 0.0;                  ///< of the spline, s
  double settle = 0.0;                    ///< time after the spline, s
  double rate = 0.0;                      ///< Hz
  double stiffness = 0.0;                 ///< of the task, 1/s^2
  double damping = 0.0;                   ///< of the task, 1/s
};

/// Reads the plan at `path`. `mover` is the name of the section about what moves; if it is empty,
/// only the start and the springs are read. Returns false, with the reason in `error`, if something
/// is missing or of the wrong kind, or if the two lists of joints differ.
bool read_plan(const std::string& path, Plan& plan, std::string& error,
               const std::string& mover = "left_hand");

/// Compares the number of the plan's joints with the robot's. Returns false, with the reason in
/// `error`, if they differ. `path` is the plan's file.
bool count_joints(const std::string& path, const Plan& plan, int robot_joints, std::string& error);

/// Why the loop stopped, with the joint's name; empty if there was no fault.
std::string stopped(const servo::Fault& fault, const Plan& plan);

/// Limits of the plan's joints, for the safety check of the servo loop.
struct JointLimits {
  std::vector<double> lower;     ///< rad
  std::vector<double> upper;     ///< rad
  std::vector<double> velocity;  ///< rad/s
  std::vector<double> effort;    ///< N m
};

/// Reads the limits of `joints` from the URDF at `path`. Returns false, with the reason in `error`,
/// if the file cannot be read or lacks one of them.
bool read_limits(const std::string& path, const std::vector<std::string>& joints,
                 JointLimits& limits, std::string& error);

}  // namespace treeline::experiments
