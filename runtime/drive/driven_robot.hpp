#pragma once

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
                   options.lower, options.upper),
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
    for (int i = 0; i < F::kVelocities; ++i) {
      torque_[i] = tau[i];
    }
    if (external_.connected != nullptr) {
      external_.write(external_.self, tau);
    } else {
      simulated_.write(tau);
    }
  }
  void pass_time(double seconds) noexcept {
    if (external_.connected == nullptr) {
      simulated_.pass_time(seconds);
    }
  }
  /// Puts a simulated robot that was lost where it began.
  void restore() noexcept {
    if (is_simulated()) simulated_.restore();
  }
  const ImperfectRobot<F>& simulated() const noexcept { return simulated_; }
  ImperfectRobot<F>& simulated() noexcept { return simulated_; }
  bool is_simulated() const noexcept { return external_.connected == nullptr; }
  /// Torque that was written last.
  const double (&torque() const noexcept)[F::kVelocities] { return torque_; }

 private:
  ImperfectRobot<F> simulated_;
  ExternalRobot external_;
  double torque_[F::kVelocities] = {};
};

}  // namespace treeline::drive
