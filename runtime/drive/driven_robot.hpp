#pragma once

#include <algorithm>

#include "drive/imperfect_robot.hpp"
#include "drive/robot_library.hpp"
#include "servo/safety.hpp"

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

  /// A robot that has its own controller may be gone for a while: that is a fault.
  bool connected() noexcept {
    is_there_ = is_simulated() || external_.connected(external_.self);
    return is_there_ || external_.has_controller();
  }
  void read(servo::StateOf<F>& state) const noexcept {
    if (external_.connected != nullptr) {
      external_.read(external_.self, state.q, state.qd);
    } else {
      simulated_.read(state);
    }
  }
  void write(const double (&tau)[F::kVelocities]) noexcept {
    if (external_.has_controller()) {
      external_.show(external_.self, torque_, shown_);
    } else if (external_.connected != nullptr) {
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
  /// Why it cannot be controlled: a simulated robot on a ground lies, or the controller of another
  /// one is silent.
  servo::Fault fault() const noexcept {
    if (!is_there_) return {servo::FaultKind::robot_gone};
    return {is_simulated() && simulated_.has_fallen() ? servo::FaultKind::fell
                                                      : servo::FaultKind::none};
  }
  /// Puts a simulated robot that was lost, or fell, where it began.
  void restore() noexcept {
    if (is_simulated()) simulated_.restore();
  }
  const ImperfectRobot<F>& simulated() const noexcept { return simulated_; }
  ImperfectRobot<F>& simulated() noexcept { return simulated_; }
  bool is_simulated() const noexcept { return external_.connected == nullptr; }
  /// Whether it has a controller of its own, which gets goals by `lead`.
  bool has_controller() const noexcept { return external_.has_controller(); }
  void lead(const double* goal) noexcept { external_.lead(external_.self, goal); }
  const Shown& shown() const noexcept { return shown_; }
  /// Torque that the robot was given last: what was written, on a ground less what its feet cannot
  /// bear; where it has a controller of its own, what that exerts.
  const double (&torque() const noexcept)[F::kVelocities] { return torque_; }

 private:
  ImperfectRobot<F> simulated_;
  ExternalRobot external_;
  bool is_there_ = true;
  Shown shown_;
  double torque_[F::kVelocities] = {};
};

}  // namespace treeline::drive
