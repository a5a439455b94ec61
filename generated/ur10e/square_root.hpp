#pragma once
// Square root, because no library is at hand. C++17, freestanding.

#include <cstdint>

#include "sin_cos.hpp"

namespace ur10e::detail {

/// Square root of x >= 0 within 1 ulp; 0 for 0. Newton's method on 1/sqrt(x) from the halved
/// exponent, then one step on the root itself.
inline double square_root(double x) noexcept {
  std::uint64_t bits = 0;
  OneLane::to_bits(x, bits);
  bits = std::uint64_t{0x5fe6eb50c7b537a9} - (bits >> 1);
  double inverse = 0.0;
  OneLane::from_bits(bits, inverse);
  const double half = 0.5 * x;
  for (int i = 0; i < 4; ++i) {
    inverse *= 1.5 - half * inverse * inverse;
  }
  const double root = x * inverse;
  return root + 0.5 * inverse * (x - root * root);
}

}  // namespace ur10e::detail
