#pragma once

#include "description/scene.hpp"

namespace treeline {

/// Cap of an inverse as a share: the largest inverse is 1 / (share * what c is ordinarily).
/// `least` is the least border whose power is a normal number.
struct CappedInverseShape {
  double share;
  double least;
};

/// Shape for effective masses. Rounding of c, 2^-52 (float: 2^-23) of what is ordinary, moves the
/// cap itself by 2^-18 (2^-10) of it: the cap is as far out as c has digits.
constexpr CappedInverseShape effective_mass_shape(Real real) {
  return real == Real::float32 ? CappedInverseShape{0x1p-13, 0x1p-31}
                               : CappedInverseShape{0x1p-34, 0x1p-255};
}

/// Beyond this border, that of bodies of grams, c^4 exceeds the range of float where normals are a
/// thousand times as long as they should be. The law is then computed as it stands, by two
/// divisions.
inline constexpr double kLargestBorderOfCap = 0x1p-4;

/// 1 / c of a c >= 0, below a cap of 1 / border. With t = c / border,
///
///     1 / (c + border / (1 + t^3)) = (c^3 + border^3) / (c (c^3 + border^3) + border^4):
///
/// it grows all the way as c falls to 0, since border / (1 + t^3) falls by less than c grows, never
/// exceeds 1/c or 1/border, and lacks (border / c)^4 of 1/c far above the border. Smooth, without
/// branch or pole, also where rounding makes a vanishing c negative.
template <class Scalar>
Scalar capped_inverse(const Scalar& c, double border) {
  if (border > kLargestBorderOfCap) {
    const Scalar t = c * Scalar(1 / border);
    return Scalar(1.0) / (c + Scalar(border) / (Scalar(1.0) + t * t * t));
  }
  const double border3 = border * border * border;
  const Scalar sum = c * c * c + Scalar(border3);
  return sum / (c * sum + Scalar(border3 * border));
}

}  // namespace treeline
