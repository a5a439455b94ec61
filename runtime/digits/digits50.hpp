#pragma once

#include <Eigen/Core>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <iosfwd>
#include <limits>
#include <type_traits>

#include "digits/strided_product.hpp"

namespace treeline {

/// A floating-point number of 50 decimal digits (168 bits): the precision of the references with
/// which errors are measured, and of a mechanism's constants.
///
/// It wraps Boost's `cpp_bin_float<50>`, whose arithmetic is compiled once, in `digits50.cpp`.
/// Inlining it into every Eigen kernel took minutes of compile time each. A call costs little
/// compared with an operation on 168 bits.
class Digits50 {
 public:
  Digits50() noexcept : Digits50(0.0) {}
  template <std::integral Integer>
  Digits50(Integer value) noexcept {  // NOLINT: implicit on purpose, because it is a scalar
    if constexpr (std::is_signed_v<Integer>) {
      assign(static_cast<long long>(value));
    } else {
      assign(static_cast<unsigned long long>(value));
    }
  }
  Digits50(float value) noexcept : Digits50(static_cast<double>(value)) {}  // NOLINT: as above
  Digits50(double value) noexcept;                                          // NOLINT: as above
  Digits50(long double value) noexcept;                                     // NOLINT: as above
  /// Converts decimal digits, as in "1e-30".
  explicit Digits50(const char* digits);

  /// Rounds to nearest.
  explicit operator float() const noexcept;
  explicit operator double() const noexcept;
  explicit operator long double() const noexcept;
  /// Rounds towards zero.
  explicit operator int() const noexcept;

  Digits50& operator+=(const Digits50& other) noexcept;
  Digits50& operator-=(const Digits50& other) noexcept;
  Digits50& operator*=(const Digits50& other) noexcept;
  Digits50& operator/=(const Digits50& other) noexcept;
  Digits50 operator-() const noexcept;

  friend Digits50 operator+(const Digits50& a, const Digits50& b) noexcept { return sum(a, b); }
  friend Digits50 operator-(const Digits50& a, const Digits50& b) noexcept {
    return difference(a, b);
  }
  friend Digits50 operator*(const Digits50& a, const Digits50& b) noexcept { return product(a, b); }
  friend Digits50 operator/(Digits50 a, const Digits50& b) noexcept { return a /= b; }
  friend bool operator==(const Digits50& a, const Digits50& b) noexcept { return equal(a, b); }
  friend bool operator!=(const Digits50& a, const Digits50& b) noexcept { return !equal(a, b); }
  friend bool operator<(const Digits50& a, const Digits50& b) noexcept { return less(a, b); }
  friend bool operator>(const Digits50& a, const Digits50& b) noexcept { return less(b, a); }
  friend bool operator<=(const Digits50& a, const Digits50& b) noexcept { return at_most(a, b); }
  friend bool operator>=(const Digits50& a, const Digits50& b) noexcept { return at_most(b, a); }

 private:
  friend struct Digits50Access;
  void assign(long long value) noexcept;
  void assign(unsigned long long value) noexcept;
  static Digits50 sum(const Digits50& a, const Digits50& b) noexcept;
  static Digits50 difference(const Digits50& a, const Digits50& b) noexcept;
  static Digits50 product(const Digits50& a, const Digits50& b) noexcept;
  static bool equal(const Digits50& a, const Digits50& b) noexcept;
  static bool less(const Digits50& a, const Digits50& b) noexcept;
  static bool at_most(const Digits50& a, const Digits50& b) noexcept;

#if defined(__SIZEOF_INT128__)
  alignas(16) std::byte storage_[64];
#else  // limbs of half the width
  alignas(8) std::byte storage_[40];
#endif
};

Digits50 abs(const Digits50& x) noexcept;
inline Digits50 fabs(const Digits50& x) noexcept {
  return abs(x);
}
Digits50 sqrt(const Digits50& x);
Digits50 sin(const Digits50& x);
Digits50 cos(const Digits50& x);
Digits50 atan2(const Digits50& y, const Digits50& x);
Digits50 exp(const Digits50& x);
Digits50 log(const Digits50& x);
Digits50 pow(const Digits50& x, const Digits50& y);
/// Rounds to the nearest integer, halves away from zero.
Digits50 round(const Digits50& x);
Digits50 floor(const Digits50& x);
Digits50 ceil(const Digits50& x);
bool isfinite(const Digits50& x) noexcept;
bool isnan(const Digits50& x) noexcept;
bool isinf(const Digits50& x) noexcept;
std::ostream& operator<<(std::ostream& out, const Digits50& x);
/// pi / 2.
const Digits50& half_pi();

template <>
inline constexpr bool kHasStridedProducts<Digits50> = true;
extern template void strided_product<Digits50>(const ProductSize&, Strided<const Digits50>,
                                               Strided<const Digits50>, Strided<Digits50>, Enter);

}  // namespace treeline

// The standard library and Eigen prescribe these names.
// NOLINTBEGIN(readability-identifier-naming)
template <>
class std::numeric_limits<treeline::Digits50> {
 public:
  static constexpr bool is_specialized = true;
  static constexpr bool is_signed = true;
  static constexpr bool is_integer = false;
  static constexpr bool is_exact = false;
  static constexpr bool has_infinity = true;
  static constexpr bool has_quiet_NaN = true;
  static constexpr int radix = 2;
  static constexpr int digits = 168;
  static constexpr int digits10 = 50;
  static constexpr int max_digits10 = 52;
  static treeline::Digits50 epsilon();
  static treeline::Digits50 min();
  static treeline::Digits50 max();
  static treeline::Digits50 lowest();
  static treeline::Digits50 infinity();
  static treeline::Digits50 quiet_NaN();
};

namespace Eigen {

template <>
struct NumTraits<treeline::Digits50> : GenericNumTraits<treeline::Digits50> {
  using Real = treeline::Digits50;
  using NonInteger = treeline::Digits50;
  using Literal = treeline::Digits50;
  using Nested = treeline::Digits50;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 4,
    MulCost = 8
  };
  static Real epsilon() { return std::numeric_limits<Real>::epsilon(); }
  static Real dummy_precision() { return 1000 * epsilon(); }
  static Real highest() { return std::numeric_limits<Real>::max(); }
  static Real lowest() { return std::numeric_limits<Real>::lowest(); }
  static int digits10() { return std::numeric_limits<Real>::digits10; }
};
// NOLINTEND(readability-identifier-naming)

namespace internal {

/// Used for eigenvalues. No exponent of these numbers overflows.
template <>
inline treeline::Digits50 positive_real_hypot(const treeline::Digits50& x,
                                              const treeline::Digits50& y) {
  return sqrt(x * x + y * y);
}

}  // namespace internal
}  // namespace Eigen
