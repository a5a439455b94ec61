#pragma once

#include "core/orientation.hpp"

namespace treeline::drive {

/// A point of a held link that may touch the ground, in the frame that is held, m: the middle of a
/// ball, of radius 0 for a corner.
struct SolePoint {
  double at[3];
  double radius;
};

/// Whether a robot F is simulated on a ground: it has a step of time there, and what that keeps.
template <class F>
inline constexpr bool kIsOnGround = requires {
  typename F::GroundMemory;
};

/// What a simulated robot on a ground has beside its motion.
template <class F, bool is_there = kIsOnGround<F>>
struct OnGround {
  typename F::GroundMemory memory{};
  typename F::GroundReport report{};  ///< of the last step
  double dt = 1.0;                    ///< s: how long that was
  double push[F::kVelocities] = {};   ///< of a hand, as joint forces, N m or N
  bool fell = false;
};

/// A robot without a ground has nothing more.
template <class F>
struct OnGround<F, false> {};

/// Whether a robot with a floating base, the first joint, no longer stands as at `start`: the base
/// is tilted by more than 60 degrees, or the centre of mass at less than half its height.
template <class F>
bool is_down(const double (&start)[F::kCoordinates], const double (&q)[F::kCoordinates]) noexcept {
  if constexpr (F::kCoordinates == F::kVelocities || !F::kHasCenterOfMass) {
    return false;
  } else {
    if (F::kFloating[0] != 0) return false;
    double stood[3];
    double center[3];
    F::center_of_mass(start, stood);
    F::center_of_mass(q, center);
    double before[9];
    double now[9];
    core::rotation_from_quaternion({start[3], start[4], start[5], start[6]}, before);
    core::rotation_from_quaternion({q[3], q[4], q[5], q[6]}, now);
    const double upright = now[6] * before[6] + now[7] * before[7] + now[8] * before[8];
    return upright < 0.5 || center[2] < 0.5 * stood[2];
  }
}

/// Joint forces by which a robot that stands on a ground is braked and held: those that carry it by
/// its feet, and for accelerations those of its limbs alone. Its feet may have left the ground, and
/// forces that would move all of the robot by a limb then throw the limb about.
template <class F>
void brake_standing(const double (&q)[F::kCoordinates], const double (&qdd)[F::kVelocities],
                    double (&tau)[F::kVelocities]) noexcept {
  constexpr int nv = F::kVelocities;
  const double none[nv] = {};
  double of_joints[nv];
  double still[nv];
  double moved[nv];
  for (int i = 0; i < nv; ++i) of_joints[i] = F::kPassive[i] ? 0.0 : qdd[i];
  F::inverse_dynamics(q, none, none, tau);
  F::tree_inverse_dynamics(q, none, none, still);
  F::tree_inverse_dynamics(q, none, of_joints, moved);
  for (int i = 0; i < nv; ++i) {
    if (!F::kPassive[i]) tau[i] += moved[i] - still[i];
  }
}

}  // namespace treeline::drive
