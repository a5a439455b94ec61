#pragma once

#include <algorithm>

#include "drive/imperfect_robot.hpp"
#include "drive/robot_library.hpp"

namespace treeline::drive {

/// The robot of a loop: simulated by its generated forward dynamics, or outside the library.
template <class F>
class DrivenRobot {
 public:
  using Floating = typename ImperfectRobot<F>::Floating;

  DrivenRobot(const servo::StateOf<F>& start, const Floating& floating,
              const LoopOptions& options) noexcept
      : simulated_(start, options.substeps, floating, options.simulation, options.surroundings,
                   options.lower, options.upper, options.torque),
        external_(options.robot) {}

  bool connected() const noexcept {
    return external_.connected == nullptr || external_.connected(external_.self);
  }
  void read(servo::StateOf<F>& state) const noexcept {
    if (external_.connected != nullptr) {
      external_.read(external_.self, state.q, state.qd);
    } else {
      simulated_.read(state);
    }
  }
  void write(const double (&tau)[F::kVelocities]) noexcept {
    if (external_.connected != nullptr) {
      external_.write(external_.self, tau);
      std::copy_n(tau, F::kVelocities, torque_);
    } else {
      simulated_.write(tau);
      std::copy_n(simulated_.given(), F::kVelocities, torque_);
    }
  }
  void pass_time(double seconds) noexcept {
    if (external_.connected == nullptr) {
      simulated_.pass_time(seconds);
    }
  }
  /// Whether a simulated robot on a ground lies.
  bool has_fallen() const noexcept { return is_simulated() && simulated_.has_fallen(); }
  /// Puts a simulated robot that was lost, or fell, where it began.
  void restore() noexcept {
    if (is_simulated()) simulated_.restore();
  }
  const ImperfectRobot<F>& simulated() const noexcept { return simulated_; }
  ImperfectRobot<F>& simulated() noexcept { return simulated_; }
  bool is_simulated() const noexcept { return external_.connected == nullptr; }
  /// Torque that the robot was given last: what was written, on a ground less what its feet cannot
  /// bear.
  const double (&torque() const noexcept)[F::kVelocities] { return torque_; }

 private:
  ImperfectRobot<F> simulated_;
  ExternalRobot external_;
  double torque_[F::kVelocities] = {};
};

}  // namespace treeline::drive
