#pragma once

#include <array>
#include <string>
#include <vector>

namespace treeline::experiments {

/// What touch_floor.yaml or put_box.yaml says. Joints in the generated code's order; SI units.
struct Plan {
  std::vector<std::string> joints;
  std::vector<double> start;              ///< q at rest, and the advised posture
  std::vector<double> posture_stiffness;  ///< 1/s^2; critically damped
  std::array<double, 3> target{};         ///< of what moves, world
  double duration = 0.0;                  ///< s, of the spline
  double settle = 0.0;                    ///< s afterwards
  double rate = 0.0;                      ///< Hz
  double stiffness = 0.0;                 ///< 1/s^2, of the task
  double damping = 0.0;                   ///< 1/s
};

/// Reads the plan at `path`; `mover` is the section about what moves. False, with the reason in
/// `error`, when something is missing, of the wrong kind, or when the two lists of joints differ.
bool read_plan(const std::string& path, Plan& plan, std::string& error,
               const std::string& mover = "left_hand");

/// Limits of the plan's joints, for the servo loop's safety check.
struct JointLimits {
  std::vector<double> lower;     ///< rad
  std::vector<double> upper;     ///< rad
  std::vector<double> velocity;  ///< rad/s
  std::vector<double> effort;    ///< N m
};

/// Reads the limits of `joints` from the URDF at `path`. False, with the reason in `error`, when
/// the file cannot be read or lacks one of them.
bool read_limits(const std::string& path, const std::vector<std::string>& joints,
                 JointLimits& limits, std::string& error);

}  // namespace treeline::experiments
