#pragma once

#include <cmath>
#include <limits>

namespace treeline::test {

/// Distance of `value` from `exact` in units of the last place of Real at `exact`, that is, the
/// spacing of Real in the binade of `exact`, at least the smallest subnormal. Wide is any type with
/// more digits.
template <class Real, class Wide>
double ulps(Real value, const Wide& exact) {
  using std::abs;
  using std::ilogb;
  using std::ldexp;
  const Wide magnitude = abs(exact);
  constexpr int kDigits = std::numeric_limits<Real>::digits;
  constexpr int kLowest = std::numeric_limits<Real>::min_exponent - 1;
  int exponent = kLowest;
  if (magnitude > Wide(std::numeric_limits<Real>::min())) {
    exponent = static_cast<int>(ilogb(magnitude));
  }
  const Wide unit = ldexp(Wide(1), exponent - kDigits + 1);
  return static_cast<double>(abs(Wide(value) - exact) / unit);
}

}  // namespace treeline::test
