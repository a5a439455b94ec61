#pragma once

#include <algorithm>
#include <iterator>

#include "servo/robot_proxy.hpp"
#include "two_robots.hpp"

namespace treeline::experiments {

/// Both robots and the object as one robot of 18 joints.
struct Pair {
  static constexpr int kCoordinates = 2 * kJoints;
  static constexpr int kVelocities = 2 * kJoints;

  static PairState state_of(const double (&q)[kCoordinates], const double (&qd)[kVelocities]) {
    PairState state;
    std::copy(std::begin(q), std::end(q), &state.q[0][0]);
    std::copy(std::begin(qd), std::end(qd), &state.qd[0][0]);
    return state;
  }
  /// The object is held, too.
  static void inverse_dynamics(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                               const double (&qdd)[kVelocities],
                               double (&tau)[kVelocities]) noexcept {
    const double rest[6] = {};
    double qdd_0[2][kJoints];
    std::copy(std::begin(qdd), std::end(qdd), &qdd_0[0][0]);
    const PairTorques torques = control_pair(state_of(q, qd), rest, rest, qdd_0);
    std::copy(&torques.tau[0][0], &torques.tau[0][0] + kVelocities, tau);
  }
  static void forward_dynamics(const double (&q)[kCoordinates], const double (&qd)[kVelocities],
                               const double (&tau)[kVelocities],
                               double (&qdd)[kVelocities]) noexcept {
    PairTorques torques;
    std::copy(std::begin(tau), std::end(tau), &torques.tau[0][0]);
    const PairMotion motion = move_pair(state_of(q, qd), torques);
    std::copy(&motion.qdd[0][0], &motion.qdd[0][0] + kVelocities, qdd);
  }
};

}  // namespace treeline::experiments
