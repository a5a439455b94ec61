#pragma once

#include <array>
#include <cstddef>

#include "servo/gear_backlash.hpp"
#include "servo/joint_friction.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::servo {

/// Drive of one joint: a rotor behind a gear. All quantities are seen from the joint's side of the
/// gear, in N m and rad or in N and m.
struct Drive {
  double rotor =
      0.0;  ///< kg m^2 or kg: inertia of the rotor times the square of the gear ratio; positive
  JointFriction friction;
  GearBacklash gear;
};

template <int nv>
using Drives = std::array<Drive, static_cast<std::size_t>(nv)>;

/// Functions of the links alone: no joint of theirs has a rotor (`armature` of the scene) or
/// friction
/// (`joint_friction`), which a `Drive` would count a second time. F must say so:
/// `static constexpr bool kDrivesInJoints = false`.
template <class F>
concept DrivenFunctions = SimulatedFunctions<F> && requires {
  requires !F::kDrivesInJoints;
};

/// A simulated robot whose motors drive the links of F through gears. Torques act on the rotors,
/// against friction, and on the links where teeth touch. It is read through encoders at the motors,
/// as on a real robot; `links` returns the state of the links. Only for robots whose joints have
/// one degree of freedom.
template <DrivenFunctions F>
class GearedRobot {
 public:
  static constexpr int nv = F::kVelocities;
  static_assert(F::kCoordinates == nv, "joints of one degree only");

  /// Starts with every motor at the position of its joint in `initial`, plus its lead from `leads`
  /// (rad or m).
  GearedRobot(const StateOf<F>& initial, const Drives<nv>& drives, int substeps = 8,
              const std::array<double, static_cast<std::size_t>(nv)>& leads = {}) noexcept
      : links_(initial), motors_(initial), drives_(drives), substeps_(substeps) {
    for (int i = 0; i < nv; ++i) {
      motors_.q[i] += leads[static_cast<std::size_t>(i)];
    }
  }

  bool connected() const noexcept { return true; }
  void read(StateOf<F>& state) const noexcept { state = motors_; }
  const StateOf<F>& links() const noexcept { return links_; }
  void write(const double (&tau)[nv]) noexcept {
    for (int i = 0; i < nv; ++i) {
      tau_[i] = tau[i];
    }
  }

  /// Advances time by classical fourth-order Runge-Kutta steps with constant torques. If teeth meet
  /// or separate within a step, the order of accuracy is lost, but steps are small.
  void pass_time(double seconds) noexcept {
    for (int step = 0; step < substeps_; ++step) {
      integrate(seconds / substeps_);
    }
  }

 private:
  void accelerations(const StateOf<F>& links, const StateOf<F>& motors, double (&of_links)[nv],
                     double (&of_motors)[nv]) const noexcept {
    double torques[nv];
    for (int i = 0; i < nv; ++i) {
      const Drive& drive = drives_[static_cast<std::size_t>(i)];
      torques[i] = gear_torque(drive.gear, motors.q[i] - links.q[i], motors.qd[i] - links.qd[i]);
      of_motors[i] =
          (tau_[i] - friction_torque(drive.friction, motors.qd[i]) - torques[i]) / drive.rotor;
    }
    F::forward_dynamics(links.q, links.qd, torques, of_links);
  }

  /// Returns state + fraction dt (qd, qdd) for a Runge-Kutta stage.
  static StateOf<F> moved(const StateOf<F>& state, double dt, const double (&qd)[nv],
                          const double (&qdd)[nv]) noexcept {
    StateOf<F> at = state;
    for (int i = 0; i < nv; ++i) {
      at.q[i] += dt * qd[i];
      at.qd[i] += dt * qdd[i];
    }
    return at;
  }

  void integrate(double dt) noexcept {
    constexpr double kFractions[4] = {0.0, 0.5, 0.5, 1.0};
    constexpr double kWeights[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    StateOf<F> link_at = links_;
    StateOf<F> motor_at = motors_;
    StateOf<F> link_sum = links_;
    StateOf<F> motor_sum = motors_;
    double link_qdd[nv] = {};
    double motor_qdd[nv] = {};
    for (int stage = 0; stage < 4; ++stage) {
      const StateOf<F> link_before = link_at;
      const StateOf<F> motor_before = motor_at;
      link_at = moved(links_, kFractions[stage] * dt, link_before.qd, link_qdd);
      motor_at = moved(motors_, kFractions[stage] * dt, motor_before.qd, motor_qdd);
      accelerations(link_at, motor_at, link_qdd, motor_qdd);
      link_sum = moved(link_sum, kWeights[stage] * dt, link_at.qd, link_qdd);
      motor_sum = moved(motor_sum, kWeights[stage] * dt, motor_at.qd, motor_qdd);
    }
    links_ = link_sum;
    motors_ = motor_sum;
  }

  StateOf<F> links_;
  StateOf<F> motors_;
  Drives<nv> drives_;
  double tau_[nv] = {};
  int substeps_;
};

}  // namespace treeline::servo
