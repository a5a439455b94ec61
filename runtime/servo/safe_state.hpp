#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/emitted_braking.hpp"
#include "servo/motion_coordinates.hpp"
#include "servo/safety.hpp"

namespace treeline::servo {

/// How a robot is braked and held, see emitted/controller_braking.h. Rates are lowered to a fifth
/// of the loop's own where that is slow.
struct BrakeSettings {
  double damping = 20.0;       ///< 1/s, of the reference along which the robot is braked
  double frequency = 60.0;     ///< rad/s: how stiffly it is led along that, and held
  double reach = 0.05;         ///< rad or m that the reference leaves a joint behind
  double rest_speed = 1e-3;    ///< rad/s or m/s: a slower reference stands
  double torque_rise = 0.025;  ///< s in which a torque may rise from 0 to its limit
  double blind_time = 0.1;     ///< s that a joint of which nothing is measured is held
};

/// A robot F as the braking of emitted controllers knows robots. Coordinates are counted by
/// velocities: those of a floating joint are its way from an anchor. F may have
/// `braking_dynamics` beside `inverse_dynamics`, by which it is braked.
template <class F>
struct SafeRobot {
  using Real = double;
  static constexpr int kJoints = F::kVelocities;
  struct Turns {
    constexpr bool operator[](int velocity) const noexcept {
      return turns_without_end<F>(velocity);
    }
  };
  static constexpr Turns kTurns{};

  struct Config {
    double period = 1e-3;
    double lower[kJoints], upper[kJoints], speed[kJoints], torque[kJoints], torque_rate[kJoints];
    double brake_damping = 0.0, hold_frequency = 0.0, hold_reach = 0.0, rest_speed = 0.0;
    int blind_ticks = 0;
  };
  struct Input {
    double q[kJoints] = {};
    double anchor[F::kCoordinates] = {};  ///< poses of floating joints, else 0
  };
  struct State {
    int posed = 0, braking = 0, blind_ticks = 0, known = 0, cut = 0;
    double sound_q[kJoints] = {}, sound_qd[kJoints] = {};
    double brake_share = 0.0;
    double brake_q[kJoints] = {}, brake_qd[kJoints] = {}, stand_q[kJoints] = {};
    double load[kJoints] = {};
    double softness[kJoints] = {}, swing[kJoints] = {};
    double swing_peak[kJoints] = {}, last_peak[kJoints] = {};
    int swing_ticks[kJoints] = {};
    double tau[kJoints] = {};
  };
  struct Measured {
    double q[kJoints];
    double qd[kJoints];
    bool lost[kJoints];  ///< neither of both is finite
  };

  static void joint_torque(const Input& input, const Measured& at, const double (&qdd)[kJoints],
                           double (&tau)[kJoints]) noexcept {
    double q[F::kCoordinates];
    go_from<F>(input.anchor, at.q, q);
    if constexpr (requires { F::braking_dynamics(q, at.qd, qdd, tau); }) {
      F::braking_dynamics(q, at.qd, qdd, tau);
    } else {
      F::inverse_dynamics(q, at.qd, qdd, tau);
    }
  }
};

/// Brakes a robot to rest and holds it there, by the law of emitted controllers. Joints whose
/// torque has no limit are held by a spring of what accelerates their own inertia by 100 rad/s^2
/// and twice what they bear where the braking begins. Nothing is allocated.
template <RobotFunctions F>
class SafeState {
 public:
  static constexpr int nq = F::kCoordinates;
  static constexpr int nv = F::kVelocities;
  using Limits = SafetyLimits<nq, nv>;

  SafeState(const BrakeSettings& settings, double period, const Limits& limits) noexcept {
    const double fastest = 0.2 / period;
    config_.period = period;
    config_.brake_damping = std::fmin(settings.damping, fastest);
    config_.hold_frequency = std::fmin(settings.frequency, fastest);
    config_.hold_reach = settings.reach;
    config_.rest_speed = settings.rest_speed;
    config_.blind_ticks = static_cast<int>(std::ceil(settings.blind_time / period));
    take_limits(settings, limits);
    strengths_ = config_;
    for_each_joint<F>([](int, int) {}, [&](int iq, int) { input_.anchor[iq + 6] = 1.0; });
  }

  /// Takes what was measured. Where numbers are not finite, what stands for them is put into
  /// `state`. Returns whether there is a state to compute with.
  bool see(StateOf<F>& state) noexcept {
    express(state);
    const bool seen = Braking::tl_are_numbers(input_.q, nv) && Braking::tl_are_numbers(at_.qd, nv);
    known_ = Braking::tl_complete_state(&config_, &input_, seen, &state_, &at_);
    if (known_ && !seen) {
      go_from<F>(input_.anchor, at_.q, state.q);
      std::copy(std::begin(at_.qd), std::end(at_.qd), state.qd);
    }
    return known_;
  }

  /// A joint jumped by so much, and is taken to be where it was until `believe`.
  void set_back(int velocity, double leap) noexcept {
    offset_[velocity] += leap;
    at_.q[velocity] -= leap;
    state_.sound_q[velocity] = at_.q[velocity];
  }

  /// Believes what is measured, wherever that is, and brakes anew.
  void believe() noexcept {
    for (int i = 0; i < nv; ++i) {
      state_.sound_q[i] += offset_[i];
      offset_[i] = 0.0;
    }
    state_.braking = 0;
  }

  /// Somebody else moves the robot, by `tau`.
  void release(const double (&tau)[nv]) noexcept {
    state_.braking = 0;
    state_.cut = 0;
    state_.known = 1;
    std::copy(std::begin(tau), std::end(tau), state_.tau);
  }

  /// Torque that brakes the robot and holds it, within limits and rates. Returns whether a joint
  /// that should stand was dragged away.
  bool brake(double (&tau)[nv]) noexcept {
    bool dragged = false;
    bool finite = known_;
    if (known_) {
      if (state_.braking == 0) find_strengths();
      dragged = Braking::tl_brake_torque(&strengths_, &input_, &at_, &state_, tau);
      finite = Braking::tl_are_numbers(tau, nv);
    }
    if (!finite) {
      std::fill(std::begin(tau), std::end(tau), 0.0);
      state_.braking = 0;
    }
    state_.cut = Braking::tl_limit_rate(&config_, &state_, tau) ? 1 : 0;
    return dragged && finite;
  }

  /// Whether the robot is held at rest.
  bool rests() const noexcept {
    return known_ && state_.braking != 0 && Braking::tl_rests(&config_, &at_, &state_);
  }

 private:
  using Robot = SafeRobot<F>;
  using Braking = core::EmittedBraking<Robot>;
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr double kLargest = 1e6;  ///< N m or N: a larger limit is none

  void take_limits(const BrakeSettings& settings, const Limits& limits) noexcept {
    const auto take = [&](int i, double lower, double upper) {
      const auto at = static_cast<std::size_t>(i);
      config_.lower[i] = lower;
      config_.upper[i] = upper;
      config_.speed[i] = limits.velocity[at];
      config_.torque[i] = limits.torque[at];
      config_.torque_rate[i] = limits.torque[at] / settings.torque_rise;
    };
    for_each_joint<F>(
        [&](int iq, int iv) {
          const auto at = static_cast<std::size_t>(iq);
          take(iv, limits.lower[at], limits.upper[at]);
        },
        [&](int, int iv) {
          for (int i = iv; i < iv + 6; ++i) take(i, -kInfinity, kInfinity);
        });
  }

  /// Coordinates by velocities. The anchor follows a robot that is not braked.
  void express(const StateOf<F>& state) noexcept {
    const auto is_finite = [&](int iq) {
      return std::all_of(state.q + iq, state.q + iq + 7, [](double x) { return std::isfinite(x); });
    };
    for_each_joint<F>([](int, int) {},
                      [&](int iq, int) {
                        if (state_.braking != 0 || !is_finite(iq)) return;
                        std::copy_n(state.q + iq, 7, input_.anchor + iq);
                      });
    way_between<F>(input_.anchor, state.q, input_.q);
    for_each_joint<F>([&](int iq, int iv) { input_.q[iv] = state.q[iq]; },
                      [&](int iq, int iv) {
                        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
                        if (!is_finite(iq)) std::fill_n(input_.q + iv, 6, kNone);
                      });
    for (int i = 0; i < nv; ++i) {
      input_.q[i] -= offset_[i];
      at_.qd[i] = state.qd[i];
    }
  }

  /// Torque (N m or N) that holds each joint, and torque by which its inertia accelerates at 1
  /// rad/s^2.
  void measure_joints(double (&weight)[nv], double (&inertia)[nv]) const noexcept {
    typename Robot::Measured still = at_;
    std::fill(std::begin(still.qd), std::end(still.qd), 0.0);
    double qdd[nv] = {};
    Robot::joint_torque(input_, still, qdd, weight);
    for (int i = 0; i < nv; ++i) {
      double moved[nv];
      qdd[i] = 1.0;
      Robot::joint_torque(input_, still, qdd, moved);
      qdd[i] = 0.0;
      inertia[i] = std::fabs(moved[i] - weight[i]);
    }
  }

  /// What joints without a limit of torque are held by; those without a motor are not. Motors that
  /// are weak for what they move would swing about a stiff reference, torque always at its limits:
  /// they are led so softly that 0.02 rad or m beside it need no more torque, nor a faster change
  /// of it, than there is.
  void find_strengths() noexcept {
    constexpr double kAcceleration = 100.0;  // rad/s^2
    constexpr double kSwing = 0.02;          // rad or m
    constexpr double kSoftest = 5.0;         // rad/s
    double weight[nv];
    double inertia[nv];
    measure_joints(weight, inertia);
    double frequency = config_.hold_frequency;
    for (int i = 0; i < nv; ++i) {
      const double limit = config_.torque[i];
      const double free = 2.0 * std::fabs(weight[i]) + kAcceleration * inertia[i];
      const double strength = limit < kLargest ? limit : free;
      const bool holds = has_motor<F>(i) && std::isfinite(strength) && strength > 0.0;
      strengths_.torque[i] = holds ? strength : 0.0;
      strengths_.torque_rate[i] = holds && limit < kLargest ? config_.torque_rate[i] : kInfinity;
      const double room = limit - std::fabs(weight[i]);
      if (!holds || !(room > 0.0) || !(inertia[i] > 0.0)) continue;
      frequency = std::fmin(frequency, std::sqrt(room / (kSwing * inertia[i])));
      frequency = std::fmin(frequency, std::cbrt(config_.torque_rate[i] / (kSwing * inertia[i])));
    }
    strengths_.hold_frequency = std::fmax(frequency, kSoftest);
  }

  typename Robot::Config config_;
  typename Robot::Config strengths_;  ///< with torques that hold, also of joints without a limit
  typename Robot::Input input_;
  typename Robot::State state_;
  typename Robot::Measured at_{};
  double offset_[nv] = {};
  bool known_ = false;
};

}  // namespace treeline::servo
