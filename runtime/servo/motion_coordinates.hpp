#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/coordinates.hpp"
#include "core/emitted_braking.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::servo {

/// What a robot F says beyond its functions, each only where it applies:
///   kFloating   index in q of the first of the 7 coordinates of each floating joint, ascending
///   kTurns      of each velocity: whether its joint turns without end
///   kPassive    of each velocity: whether its joint has no motor
template <class F>
constexpr bool turns_without_end(int velocity) noexcept {
  if constexpr (requires { F::kTurns; }) {
    return F::kTurns[velocity];
  } else {
    (void)velocity;
    return false;
  }
}
template <class F>
constexpr bool has_motor(int velocity) noexcept {
  if constexpr (requires { F::kPassive; }) {
    return !F::kPassive[velocity];
  } else {
    (void)velocity;
    return true;
  }
}

/// Calls single(coordinate, velocity) for each joint of one coordinate and floating(coordinate,
/// velocity), of the first ones, for each floating joint.
template <class F, class Single, class Floating>
constexpr void for_each_joint(Single&& single, Floating&& floating) noexcept {
  constexpr int kCount = F::kCoordinates - F::kVelocities;
  static_assert(
      kCount == 0 || requires { F::kFloating; }, "F has to say where floating joints are");
  int iq = 0;
  int iv = 0;
  for (int k = 0; k <= kCount; ++k) {
    int end = F::kCoordinates;
    if constexpr (kCount > 0) {
      if (k < kCount) end = F::kFloating[static_cast<std::size_t>(k)];
    }
    for (; iq < end; ++iq, ++iv) {
      single(iq, iv);
    }
    if (k < kCount) {
      floating(iq, iv);
      iq += 7;
      iv += 6;
    }
  }
}

/// The way from one q to another by velocities, of a second. Joints that turn without end go the
/// short way round, floating ones in their own axes, see `core::difference`.
template <class F>
void way_between(const double (&from)[F::kCoordinates], const double (&to)[F::kCoordinates],
                 double (&way)[F::kVelocities]) noexcept {
  if constexpr (F::kCoordinates == F::kVelocities) {
    core::difference(from, to, way);
  } else {
    core::QuaternionJoint joints[F::kCoordinates - F::kVelocities];
    int count = 0;
    for_each_joint<F>([](int, int) {}, [&](int iq, int) { joints[count++] = {iq, true}; });
    core::difference(joints, from, to, way);
  }
  for (int i = 0; i < F::kVelocities; ++i) {
    way[i] = turns_without_end<F>(i) ? core::shortest_turn(way[i]) : way[i];
  }
}

/// Moves a q for one second at the constant velocities `way`.
template <class F>
void go_from(const double (&from)[F::kCoordinates], const double (&way)[F::kVelocities],
             double (&to)[F::kCoordinates]) noexcept {
  if constexpr (F::kCoordinates == F::kVelocities) {
    core::integrate(from, way, 1.0, to);
  } else {
    core::QuaternionJoint joints[F::kCoordinates - F::kVelocities];
    int count = 0;
    for_each_joint<F>([](int, int) {}, [&](int iq, int) { joints[count++] = {iq, true}; });
    core::integrate(joints, from, way, 1.0, to);
  }
}

}  // namespace treeline::servo
