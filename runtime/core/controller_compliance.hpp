#pragma once
// Compliance of an emitted controller: springs and dampers in N m/rad and N/m about the pose where
// it was told to comply; without springs the robot is led by hand. C++17, freestanding, fixed size.
//
//   tau = g + K (p - q) - D qd - c M qd + sum J^T (K e - D xd)
//
// The damping c M, by inertias, is one that a sampled law can have however light a joint is. No
// motion is compensated, so the robot is passive: it gives back no more than it was given. (Of
// orientations this holds where the three stiffnesses of a point are equal.)

#include "core/controller_braking.hpp"

namespace treeline::core {

/// Torque that turns a joint back at the ends of its range: a spring that begins `hold_reach`
/// before them.
template <class Robot>
inline RealOf<Robot> guard_range(const typename Robot::Config& config, RealOf<Robot> q,
                                 int i) noexcept {
  using Real = RealOf<Robot>;
  const Real above = q - (config.upper[i] - config.hold_reach);
  const Real below = (config.lower[i] + config.hold_reach) - q;
  const Real up = firm_torque<Robot>(
      config, i, within((above > Real(0)) ? (above / config.hold_reach) : Real(0), Real(1)));
  const Real down = firm_torque<Robot>(
      config, i, within((below > Real(0)) ? (below / config.hold_reach) : Real(0), Real(1)));
  return down - up;
}

/// Adds springs and dampers of the points.
template <class Robot>
inline void add_point_springs(const typename Robot::Config& config,
                              const typename Robot::Input& input, const Measured<Robot>& at,
                              const typename Robot::State& state,
                              RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  Real against[6 * Robot::kPoints];
  for (int point = 0; point < Robot::kPoints; ++point) {
    PointMotion<Real> wanted;
    PointMotion<Real> now;
    Real error[6];
    compare_point<Robot>(config, at, state, point, wanted, now, error);
    for (int i = 0; i < 6; ++i) {
      const int row = (6 * point) + i;
      against[row] = (config.point_viscosity[row] * now.velocity[i]) -
                     (config.point_stiffness[row] * error[i]);
    }
  }
  add_push_torque<Robot>(input, at, state, against, tau);
}

/// Torque of a robot that complies.
template <class Robot>
inline void compliant_torque(const typename Robot::Config& config,
                             const typename Robot::Input& input, const Measured<Robot>& at,
                             const typename Robot::State& state,
                             RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  Measured<Robot> still;  // as far as joint_torque reads it: a copy of all would call memcpy
  Real qdd[Robot::kJoints];
  for (int i = 0; i < Robot::kJoints; ++i) {
    still.q[i] = at.q[i] + Real(0);
    still.sin_q[i] = at.sin_q[i] + Real(0);
    still.cos_q[i] = at.cos_q[i] + Real(0);
    still.qd[i] = Real(0) * at.qd[i];
    qdd[i] = -config.comply_damping * at.qd[i];
  }
  Robot::joint_torque(input, state, still, qdd, tau);
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real way = way_to<Robot>(i, at.q[i], state.joint_motion[i]);
    tau[i] += (config.joint_stiffness[i] * way) - (config.joint_viscosity[i] * at.qd[i]) +
              guard_range<Robot>(config, at.q[i], i);
  }
  if constexpr (Robot::kForce) {
    add_point_springs<Robot>(config, input, at, state, tau);
  }
}

}  // namespace treeline::core
