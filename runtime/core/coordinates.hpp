#pragma once
// Coordinates that have their velocities as steps: q + qd dt, and the qd that leads from one q to
// another, where joints have quaternions (x, y, z, w) too. C++17, freestanding.

#include "core/orientation.hpp"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// A joint of which q has a quaternion: floating (position and quaternion, 7 coordinates and 6
/// velocities) or a ball (quaternion, 4 and 3). `first` is the index in q of its first coordinate.
struct QuaternionJoint {
  int first;
  bool has_position;
};

namespace steps {

/// The quaternion of unit length in the same direction. One too short to have a direction does not
/// rotate.
template <class Real>
inline void normalise(const Real* q, Real (&unit)[4]) noexcept {
  Real largest = Real(0);
  for (int i = 0; i < 4; ++i) {
    const Real size = q[i] < Real(0) ? -q[i] : q[i];
    largest = size > largest ? size : largest;
  }
  const Real least = sizeof(Real) < sizeof(double) ? Real(1e-37F) : static_cast<Real>(1e-300);
  const Real scale = largest > least ? Real(1) / largest : Real(0);
  Real square = Real(0);
  for (int i = 0; i < 4; ++i) {
    unit[i] = scale * q[i];
    square += unit[i] * unit[i];
  }
  if (!(square > Real(0))) unit[3] = square = Real(1);
  const Real inverse = Real(1) / square_root(square);
  for (Real& entry : unit) entry *= inverse;
}

/// Quaternion product a b: the rotation b followed by a.
template <class Real>
inline void multiply(const Real (&a)[4], const Real (&b)[4], Real (&product)[4]) noexcept {
  product[0] = a[3] * b[0] + b[3] * a[0] + (a[1] * b[2] - a[2] * b[1]);
  product[1] = a[3] * b[1] + b[3] * a[1] + (a[2] * b[0] - a[0] * b[2]);
  product[2] = a[3] * b[2] + b[3] * a[2] + (a[0] * b[1] - a[1] * b[0]);
  product[3] = a[3] * b[3] - (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

/// exp(vector / 2): the quaternion of a rotation vector.
template <class Real>
inline void quaternion_from_vector(const Real (&vector)[3], Real (&q)[4]) noexcept {
  const Real square = squared_norm(vector);
  const Real angle = square_root(square);
  Real s;
  sin_cos(Real(0.5) * angle, s, q[3]);
  const Real half_ratio = angle < Real(1e-4) ? Real(0.5) - square / Real(48) : s / angle;
  for (int i = 0; i < 3; ++i) q[i] = half_ratio * vector[i];
}

/// R of the orientation halfway from `unit` through the rotation by `turn`.
template <class Real>
inline void rotation_halfway(const Real (&unit)[4], const Real (&turn)[3], Real (&R)[9]) noexcept {
  const Real half[3] = {Real(0.5) * turn[0], Real(0.5) * turn[1], Real(0.5) * turn[2]};
  Real by[4];
  Real middle[4];
  quaternion_from_vector(half, by);
  multiply(unit, by, middle);
  rotation_from_quaternion(middle, R);
}

/// Calls on_run(q, v, count) for coordinates that are displacements or angles, each with its own
/// velocity, and on_quaternion(q, v, has_position) for the joints with a quaternion.
template <int nq, class OnRun, class OnQuaternion>
inline void visit_coordinates(const QuaternionJoint* joints, int count, OnRun on_run,
                              OnQuaternion on_quaternion) noexcept {
  int q = 0;
  int v = 0;
  for (int i = 0; i < count; ++i) {
    const int run = joints[i].first - q;
    on_run(q, v, run);
    q += run;
    v += run;
    on_quaternion(q, v, joints[i].has_position);
    q += joints[i].has_position ? 7 : 4;
    v += joints[i].has_position ? 6 : 3;
  }
  on_run(q, v, nq - q);
}

template <class Real, int nq, int nv>
inline void integrate(const QuaternionJoint* joints, int count, const Real (&q)[nq],
                      const Real (&qd)[nv], Real dt, Real (&next)[nq]) noexcept {
  visit_coordinates<nq>(
      joints, count,
      [&](int iq, int iv, int run) {
        for (int i = 0; i < run; ++i) next[iq + i] = q[iq + i] + dt * qd[iv + i];
      },
      [&](int iq, int iv, bool has_position) {
        const int quaternion = has_position ? iq + 3 : iq;
        const Real* w = qd + (has_position ? iv + 3 : iv);
        const Real turn[3] = {dt * w[0], dt * w[1], dt * w[2]};
        Real unit[4];
        normalise(q + quaternion, unit);
        for (int i = 0; has_position && i < 3; ++i) {
          Real R[9];
          rotation_halfway(unit, turn, R);
          next[iq + i] = q[iq + i] + dt * (R[3 * i] * qd[iv] + R[3 * i + 1] * qd[iv + 1] +
                                           R[3 * i + 2] * qd[iv + 2]);
        }
        Real by[4];
        Real turned[4];
        Real normal[4];
        quaternion_from_vector(turn, by);
        multiply(unit, by, turned);
        normalise(turned, normal);
        for (int i = 0; i < 4; ++i) next[quaternion + i] = normal[i];
      });
}

template <class Real, int nq, int nv>
inline void difference(const QuaternionJoint* joints, int count, const Real (&from)[nq],
                       const Real (&to)[nq], Real (&qd)[nv]) noexcept {
  visit_coordinates<nq>(
      joints, count,
      [&](int iq, int iv, int run) {
        for (int i = 0; i < run; ++i) qd[iv + i] = to[iq + i] - from[iq + i];
      },
      [&](int iq, int iv, bool has_position) {
        const int quaternion = has_position ? iq + 3 : iq;
        Real unit[4];
        Real end[4];
        Real relative[4];
        Real normal[4];
        Real turn[3];
        normalise(from + quaternion, unit);
        normalise(to + quaternion, end);
        const Real back[4] = {-unit[0], -unit[1], -unit[2], unit[3]};
        multiply(back, end, relative);
        normalise(relative, normal);
        rotation_vector_from_quaternion(normal, turn);
        for (int i = 0; i < 3; ++i) qd[(has_position ? iv + 3 : iv) + i] = turn[i];
        if (!has_position) return;
        Real R[9];
        rotation_halfway(unit, turn, R);
        const Real way[3] = {to[iq] - from[iq], to[iq + 1] - from[iq + 1],
                             to[iq + 2] - from[iq + 2]};
        for (int i = 0; i < 3; ++i) {
          qd[iv + i] = R[i] * way[0] + R[3 + i] * way[1] + R[6 + i] * way[2];
        }
      });
}

}  // namespace steps

/// q after `dt` seconds at the constant velocities qd. Rotations are exact, exp(w dt), for
/// quaternions of any length; the result has unit length. Angles and displacements, those of a
/// planar joint too, are q + dt qd. A floating joint moves by its velocity in the axes halfway
/// through its rotation, which is of second order in dt, exact if it does not turn or turns about
/// its velocity, and what `treeline simulate` does. `joints` in ascending order.
template <class Real, int nq, int nv, int count>
inline void integrate(const QuaternionJoint (&joints)[count], const Real (&q)[nq],
                      const Real (&qd)[nv], Real dt, Real (&next)[nq]) noexcept {
  steps::integrate(joints, count, q, qd, dt, next);
}

/// Moves q by `dt` seconds at the constant velocities qd, for a robot without quaternions.
template <class Real, int n>
inline void integrate(const Real (&q)[n], const Real (&qd)[n], Real dt, Real (&next)[n]) noexcept {
  steps::integrate(static_cast<const QuaternionJoint*>(nullptr), 0, q, qd, dt, next);
}

/// The velocities that lead `from` to `to` in one second: integrate(from, qd, 1) is `to`, of
/// quaternions up to length and sign. Rotations are the shortest, at most pi. Angles are subtracted
/// as they are, without full turns.
template <class Real, int nq, int nv, int count>
inline void difference(const QuaternionJoint (&joints)[count], const Real (&from)[nq],
                       const Real (&to)[nq], Real (&qd)[nv]) noexcept {
  steps::difference(joints, count, from, to, qd);
}

/// Velocities that lead `from` to `to` in one second, for a robot without quaternions.
template <class Real, int n>
inline void difference(const Real (&from)[n], const Real (&to)[n], Real (&qd)[n]) noexcept {
  steps::difference(static_cast<const QuaternionJoint*>(nullptr), 0, from, to, qd);
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
