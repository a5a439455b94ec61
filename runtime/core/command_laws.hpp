#pragma once
// Laws that turn errors into commanded accelerations: inputs xdd_cmd and qdd_0 of control_torque.
// C++17, freestanding, fixed size. Gains: kp in 1/s^2, kv in 1/s (kv = 2 sqrt(kp) damps
// critically).

#include "core/orientation.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// Stiffness and damping of a law.
template <class Real>
struct Gains {
  Real kp = Real(0);  ///< 1/s^2
  Real kv = Real(0);  ///< 1/s
};

/// xdd = xdd_wanted + kv (xd_wanted - xd) + kp error: N joints, or N task rows with `error` from
/// `pose_error` and velocities linear over angular.
template <int N, class Real>
constexpr void tracking_law(const Gains<Real>& gains, const Real (&error)[N],
                            const Real (&velocity)[N], const Real (&velocity_wanted)[N],
                            const Real (&acceleration_wanted)[N],
                            Real (&acceleration)[N]) noexcept {
  for (int i = 0; i < N; ++i) {
    acceleration[i] = acceleration_wanted[i] + gains.kv * (velocity_wanted[i] - velocity[i]) +
                      gains.kp * error[i];
  }
}

/// Joint PD about a posture at rest: qdd = kp (q_wanted - q) - kv qd. One-degree joints only, whose
/// coordinates are angles or displacements.
template <int N, class Real>
constexpr void joint_law(const Gains<Real>& gains, const Real (&q_wanted)[N], const Real (&q)[N],
                         const Real (&qd)[N], Real (&qdd)[N]) noexcept {
  for (int i = 0; i < N; ++i) {
    qdd[i] = gains.kp * (q_wanted[i] - q[i]) - gains.kv * qd[i];
  }
}

/// Goal at rest with the speed limited: the wanted velocity kp/kv * error is shortened to
/// `largest_speed`, keeping its direction, and the law damps towards it (Khatib 1987),
/// a = kv (v_wanted - v). Linear and angular parts each have their limit; m/s and rad/s, positive.
template <class Real>
inline void saturated_goal_law(const Gains<Real>& gains, const Real (&error)[6],
                               const Real (&velocity)[6], Real largest_linear_speed,
                               Real largest_angular_speed, Real (&acceleration)[6]) noexcept {
  const Real limits[2] = {largest_linear_speed, largest_angular_speed};
  for (int part = 0; part < 2; ++part) {
    const Real rate = gains.kp / gains.kv;
    const Real wanted[3] = {rate * error[3 * part], rate * error[3 * part + 1],
                            rate * error[3 * part + 2]};
    const Real speed = square_root(steps::squared_norm(wanted));
    const Real factor = speed > limits[part] ? limits[part] / speed : Real(1);
    for (int i = 0; i < 3; ++i) {
      acceleration[3 * part + i] = gains.kv * (factor * wanted[i] - velocity[3 * part + i]);
    }
  }
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
