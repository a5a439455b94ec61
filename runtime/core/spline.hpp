#pragma once
// Cubic motion of a vector between two states. C++17, freestanding, fixed size.

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"  // of array bounds that are template parameters
#endif

namespace treeline::core {

/// Position, velocity and acceleration of N numbers.
template <int N, class Real>
struct Motion {
  Real position[N];
  Real velocity[N];
  Real acceleration[N];
};

/// x(t) = c0 + c1 t + c2 t^2 + c3 t^3 for 0 <= t <= duration, each component by itself; at rest
/// where it begins before, and where it ends after.
template <int N, class Real>
struct CubicSegment {
  Real coefficients[4][N];
  Real duration = Real(0);  ///< s, positive

  /// The state at `t` seconds. Outside the segment: the position of the nearer end, velocity and
  /// acceleration zero.
  Motion<N, Real> at(Real t) const noexcept {
    const bool inside = t >= Real(0) && t <= duration;
    const Real time = t < Real(0) ? Real(0) : (t > duration ? duration : t);
    Motion<N, Real> motion;
    for (int i = 0; i < N; ++i) {
      const Real c1 = coefficients[1][i];
      const Real c2 = coefficients[2][i];
      const Real c3 = coefficients[3][i];
      motion.position[i] = coefficients[0][i] + time * (c1 + time * (c2 + time * c3));
      motion.velocity[i] = inside ? c1 + time * (Real(2) * c2 + time * (Real(3) * c3)) : Real(0);
      motion.acceleration[i] = inside ? Real(2) * c2 + Real(6) * c3 * time : Real(0);
    }
    return motion;
  }
};

namespace steps {

/// `hermite_segment` with velocities that are functions of the component.
template <int N, class Real, class Leaving, class Arriving>
inline CubicSegment<N, Real> join(const Real (&x0)[N], const Leaving& v0, const Real (&x1)[N],
                                  const Arriving& v1, Real duration) noexcept {
  CubicSegment<N, Real> segment;
  segment.duration = duration;
  const Real rate = Real(1) / duration;
  for (int i = 0; i < N; ++i) {
    const Real slope = (x1[i] - x0[i]) * rate;
    segment.coefficients[0][i] = x0[i];
    segment.coefficients[1][i] = v0(i);
    segment.coefficients[2][i] = (Real(3) * slope - Real(2) * v0(i) - v1(i)) * rate;
    segment.coefficients[3][i] = (v0(i) + v1(i) - Real(2) * slope) * rate * rate;
  }
  return segment;
}

}  // namespace steps

/// The segment that leaves `x0` with velocity `v0` and arrives at `x1` with velocity `v1` after
/// `duration` > 0 seconds (Hermite).
template <int N, class Real>
inline CubicSegment<N, Real> hermite_segment(const Real (&x0)[N], const Real (&v0)[N],
                                             const Real (&x1)[N], const Real (&v1)[N],
                                             Real duration) noexcept {
  return steps::join(
      x0, [&v0](int i) noexcept { return v0[i]; }, x1, [&v1](int i) noexcept { return v1[i]; },
      duration);
}

/// From rest at `x0` to rest at `x1` (the spline of Chang fig. 6.4).
template <int N, class Real>
inline CubicSegment<N, Real> rest_to_rest(const Real (&x0)[N], const Real (&x1)[N],
                                          Real duration) noexcept {
  const auto rest = [](int) noexcept { return Real(0); };
  return steps::join(x0, rest, x1, rest, duration);
}

}  // namespace treeline::core

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif
