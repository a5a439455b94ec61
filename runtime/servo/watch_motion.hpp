#pragma once

#include <algorithm>
#include <cmath>

#include "servo/motion_coordinates.hpp"
#include "servo/safety.hpp"

namespace treeline::servo {

/// Compares how coordinates move with their velocities, and finds those that jump or are frozen.
template <class F>
class MotionWatch {
 public:
  static constexpr int nv = F::kVelocities;

  /// `jump` is how far a coordinate may leave its velocity, rad or m.
  explicit MotionWatch(double jump) noexcept : jump_(jump) {}

  /// Takes a state whose numbers are finite, which came between `least` and `most` seconds after
  /// the last one. A state that is that of before to the bit is taken for one that is late: it says
  /// nothing for 0.1 s. Drift fades within a tenth of a second. The fault is that of the joint that
  /// is farthest off.
  Fault see(const StateOf<F>& state, double least, double most) noexcept {
    least_ += least;
    most_ += most;
    if (known_ && same(state) && most_ < kLatest) {
      return {};
    }
    double way[nv] = {};
    if (known_) way_between<F>(last_.q, state.q, way);
    const double kept = std::fmax(0.0, 1.0 - 10.0 * least_);
    int worst = 0;
    for (int i = 0; i < nv; ++i) {
      const double speed = 0.5 * (last_.qd[i] + state.qd[i]);
      const double told = std::fmin(std::fmax(way[i], std::fmin(least_ * speed, most_ * speed)),
                                    std::fmax(least_ * speed, most_ * speed));
      leap_[i] = known_ ? way[i] - told : 0.0;
      drift_[i] = kept * drift_[i] + leap_[i];
      worst = std::fabs(drift_[i]) > std::fabs(drift_[worst]) ? i : worst;
    }
    last_ = state;
    known_ = true;
    least_ = most_ = 0.0;
    if (std::fabs(drift_[worst]) <= jump_) {
      return {};
    }
    return {FaultKind::jump, worst, drift_[worst], jump_};
  }

  /// How far a coordinate jumped with the last state; 0 where its velocity explains the way.
  double leap(int velocity) const noexcept {
    return std::fabs(leap_[velocity]) > jump_ ? leap_[velocity] : 0.0;
  }

  /// Believes the next state, wherever it is.
  void forget() noexcept { *this = MotionWatch(jump_); }

 private:
  static constexpr double kLatest = 0.1;  ///< s

  bool same(const StateOf<F>& state) const noexcept {
    return std::equal(std::begin(state.q), std::end(state.q), last_.q) &&
           std::equal(std::begin(state.qd), std::end(state.qd), last_.qd);
  }

  double jump_;
  bool known_ = false;
  double least_ = 0.0;
  double most_ = 0.0;
  StateOf<F> last_{};
  double leap_[nv] = {};
  double drift_[nv] = {};
};

}  // namespace treeline::servo
