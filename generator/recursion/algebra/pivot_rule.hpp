#pragma once

#include <cstddef>
#include <vector>

#include "description/scene.hpp"

namespace treeline {

/// Shape of the law that inverts a pivot which may fall to zero. With t = c / border,
///
///     1/c becomes t^power / (1 + t^power) / c = c^(power - 1) / (c^power + border^power):
///
/// this is smooth and branch-free, at most 0.7 / border, and zero at c = 0 as well as next to it on
/// either side. The power is even, so the divisor is positive for every c. If c is many times the
/// border, the result is 1/c up to a relative error of (border / c)^power.
struct BoundedInverseShape {
  int power;     ///< 4, 6 or 8
  double share;  ///< border as a share of the pivot in an ordinary state
  double least;  ///< border whose power is a normal number: less would be 0, and 0 / 0 at c = 0
};

/// Shape for pivots of Lambda^-1, which fall as the square of the distance from a singularity. The
/// share of 1/c that is lost is below the effect of c's rounding errors as long as c is at least a
/// thousandth (float: a thirtieth) of its ordinary value, that is, about 2 (10) degrees from a
/// singularity. The larger power costs one operation; in float it would exceed the range of numbers
/// for small robots.
/// With `early` the border is at least 2^-13 of what is ordinary: joints move at most some seventy
/// times as fast for a motion of the task as in an ordinary state.
constexpr BoundedInverseShape inverse_inertia_shape(Real real,
                                                    SingularTasks tasks = SingularTasks::smooth) {
  if (real == Real::float32) return {4, 0x1p-11, 0x1p-31};
  return {6, tasks == SingularTasks::early ? 0x1p-13 : 0x1p-17, 0x1p-170};
}

/// Shape for pivots of a Jacobian, which fall as the distance from a singularity.
constexpr BoundedInverseShape jacobian_shape(Real real,
                                             SingularTasks tasks = SingularTasks::smooth) {
  if (real == Real::float32) return {6, 0x1p-7, 0x1p-21};
  return {8, tasks == SingularTasks::early ? 0x1p-7 : 0x1p-10, 0x1p-127};
}

/// From this border on, which only bodies of milligrams have, powers of c exceed the range of
/// float: those of c / border, a power of two, are taken in their place. That costs one product.
inline constexpr double kLargeBorder = 4;

/// x^exponent, which is 3, 5 or 7.
template <class Scalar>
Scalar odd_power(const Scalar& x, int exponent) {
  const Scalar x2 = x * x;
  Scalar power = x2 * x;
  for (int i = 3; i < exponent; i += 2) power = power * x2;
  return power;
}

/// c^(power - 1) / (c^power + border^power).
template <class Scalar>
Scalar bounded_inverse(const Scalar& c, double border, int power) {
  if (border > kLargeBorder) {
    const Scalar below = odd_power(c * Scalar(1 / border), power - 1);
    return below / (c * below + Scalar(border));
  }
  const double border3 = border * border * border;
  const Scalar c2 = c * c;
  const Scalar c3 = c2 * c;
  if (power == 4) return c3 / (c2 * c2 + Scalar(border3 * border));
  if (power == 6) return c3 * c2 / (c3 * c3 + Scalar(border3 * border3));
  const Scalar c4 = c2 * c2;
  return c4 * c3 / (c4 * c4 + Scalar(border3 * border3 * border * border));
}

/// Inverts the pivots of an elimination, in its order. Without borders, or if the border is 0, the
/// inverse is 1 / c.
struct PivotRule {
  int power = 2;
  std::vector<double> borders;

  template <class Scalar>
  Scalar operator()(std::size_t k, const Scalar& c) const {
    if (borders.empty() || borders[k] == 0) return Scalar(1.0) / c;
    return bounded_inverse(c, borders[k], power);
  }
};

}  // namespace treeline
