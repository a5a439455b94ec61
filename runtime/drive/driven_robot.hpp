#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <type_traits>

#include "drive/flat_feet.hpp"
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
        external_(options.robot) {
    if constexpr (kStands) feet_.emplace(start.q);
    std::copy_n(options.torque, F::kVelocities, limit_);
  }

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
    std::copy(std::begin(tau), std::end(tau), torque_);
    if (external_.connected != nullptr) {
      external_.write(external_.self, tau);
      return;
    }
    if constexpr (kStands) stand();
    simulated_.write(torque_);
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
  static constexpr bool kStands = kIsOnGround<F> && HeldPlaces<F>::kIsHeld;
  struct Nothing {};

  /// Cuts the torque to what the feet bear. Motors of a robot that lies are short-circuited: they
  /// drag with their largest torque at 200 rad/s or m/s.
  void stand() noexcept {
    constexpr double kShorted = 0.005;  // s/rad or s/m
    const auto& now = simulated_.links();
    if (!has_fallen()) feet_->keep(now.q, now.qd, torque_);
    for (int i = 0; i < F::kVelocities; ++i) {
      const double limit = limit_[i];
      if (has_fallen()) torque_[i] = limit < kUnlimited ? -kShorted * limit * now.qd[i] : 0.0;
      torque_[i] = std::clamp(torque_[i], -limit, limit);
    }
  }

  static constexpr double kUnlimited = 1e6;  ///< N m or N: a larger limit is none
  ImperfectRobot<F> simulated_;
  ExternalRobot external_;
  std::conditional_t<kStands, std::optional<FlatFeet<F>>, Nothing> feet_;
  double torque_[F::kVelocities] = {};
  double limit_[F::kVelocities];
};

}  // namespace treeline::drive
