#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/ldlt.hpp"
#include "servo/pose_task_controller.hpp"
#include "servo/safety.hpp"

namespace treeline::servo {

/// How well the rows of the task can be moved at q: the logarithm of det(J J^T + 1e-4), less ten
/// times the share of a motor's torque, beyond a half, that its part of the weight takes.
template <PoseTaskFunctions F>
double dexterity(const SafetyLimits<F::kCoordinates, F::kVelocities>& limits,
                 const double (&q)[F::kCoordinates]) {
  constexpr int rows = F::kTaskRows;
  constexpr int nv = F::kVelocities;
  const double none[nv] = {};
  double weight[nv];
  F::inverse_dynamics(q, none, none, weight);
  double sum = 0.0;
  for (int i = 0; i < nv; ++i) {
    const double share = std::fabs(weight[i]) / limits.torque[static_cast<std::size_t>(i)];
    if (share > 0.5) sum -= 10 * (std::fmin(share, 10.0) - 0.5);
  }
  double J[rows * nv];
  double A[rows * rows];
  F::jacobian(q, J);
  for (int a = 0; a < rows; ++a) {
    for (int b = 0; b < rows; ++b) {
      A[a * rows + b] = a == b ? 1e-4 : 0.0;
      for (int i = 0; i < nv; ++i) A[a * rows + b] += J[a * nv + i] * J[b * nv + i];
    }
  }
  core::ldlt_factor<rows>(A);
  for (int a = 0; a < rows; ++a) sum += std::log(A[a * rows + a]);
  return sum;
}

/// Places of a joint that `bent_pose` compares.
struct JointPlaces {
  double home, lower, upper;
};

/// Within 1.6 rad or m of `home`, and a tenth of the range away from limits.
inline JointPlaces places_near(double home, double lower, double upper) noexcept {
  constexpr double kMostWay = 1.6;
  const double range = upper - lower;
  const double margin = std::isfinite(range) ? 0.1 * range : 0.0;
  home = std::fmin(std::fmax(home, lower + margin), upper - margin);
  return {home, std::fmax(lower + margin, home - kMostWay),
          std::fmin(upper - margin, home + kMostWay)};
}

/// A pose near `home` to begin a task from: an arm whose joints are all 0 is often stretched, and
/// some rows of its task cannot be moved. Joint after joint takes the place within its limits where
/// `dexterity` is largest, less 0.3 for each rad or m of way. It knows no obstacles: look at it
/// before a real robot moves there.
template <PoseTaskFunctions F>
StateOf<F> bent_pose(const double (&home)[F::kCoordinates],
                     const SafetyLimits<F::kCoordinates, F::kVelocities>& limits) {
  constexpr int kPlaces = 12;
  constexpr int kRounds = 3;  // over all joints
  std::array<JointPlaces, F::kCoordinates> joints;
  StateOf<F> state{};
  for (std::size_t i = 0; i < joints.size(); ++i) {
    joints[i] = places_near(home[i], limits.lower[i], limits.upper[i]);
    state.q[i] = joints[i].home;
  }
  for (int turn = 0; turn < kRounds * F::kCoordinates; ++turn) {
    const JointPlaces& joint = joints[static_cast<std::size_t>(turn % F::kCoordinates)];
    double& q = state.q[turn % F::kCoordinates];
    const auto merit = [&] {
      return dexterity<F>(limits, state.q) - 0.3 * std::fabs(q - joint.home);
    };
    double best = q;
    double most = merit();
    for (int place = 0; place <= kPlaces; ++place) {
      q = joint.lower + (joint.upper - joint.lower) * place / kPlaces;
      const double here = merit();
      if (here > most + 1e-6) {
        most = here;
        best = q;
      }
    }
    q = best;
  }
  return state;
}

}  // namespace treeline::servo
