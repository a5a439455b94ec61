#pragma once
// States of a humanoid that stands on two feet, and what is asked of its hands.
#include <algorithm>
#include <random>

#include "humanoid24_limits_joints.hpp"
#include "humanoid24_limits_limited.hpp"

namespace treeline::test {

namespace humanoid = humanoid24_limits;
inline constexpr int kPositions = humanoid::kCoordinates;
inline constexpr int kRates = humanoid::kVelocities;
inline constexpr int kHeldRows = 12;

/// Arguments of limited_control_torque.
struct Asked {
  double q[kPositions] = {}, qd[kRates] = {}, qdd_0[kRates] = {};
  double xdd_cmd[humanoid::kTaskRows] = {}, f_wanted[kHeldRows] = {};
};

/// Joints about bent knees and elbows, in rad 0.4 times `size` around it, and hands accelerated by
/// 5 times `size` in m/s^2 and rad/s^2: with 0.2 much as in a controller at work, with 3 at random.
inline Asked draw_humanoid(std::mt19937_64& engine, double size) {
  std::normal_distribution<double> normal;
  Asked asked;
  asked.q[6] = 1;
  for (int i = 3; i < 6; ++i) asked.q[i] = 0.01 * normal(engine);
  double around[kPositions] = {};
  around[7] = 0.25;                // ankle
  around[8] = -0.45;               // knee
  around[9] = 0.2;                 // hip
  around[16] = around[23] = -0.8;  // elbows
  for (int i = 7; i < kPositions; ++i) {
    asked.q[i] = std::clamp(around[i] + 0.4 * size * normal(engine), humanoid::kLowerLimits[i],
                            humanoid::kUpperLimits[i]);
    asked.qd[i - 1] = 0.5 * size * normal(engine);
    asked.qdd_0[i - 1] = 20 * size * normal(engine) - 20 * asked.qd[i - 1];
  }
  for (double& each : asked.xdd_cmd) each = 5 * size * normal(engine);
  asked.f_wanted[2] = asked.f_wanted[8] = 75 * 9.81 / 2;
  return asked;
}

}  // namespace treeline::test
