#pragma once

#include <Eigen/Core>
#include <cmath>
#include <type_traits>

#include "digits/strided_product.hpp"

namespace treeline::interpreter {

/// A number and its derivative along one direction. Arithmetic on such numbers differentiates
/// whatever is computed with them, exactly. Comparisons use the number alone.
template <class T>
struct Dual {
  T value{};
  T slope{};

  Dual() = default;
  Dual(const T& x) : value(x), slope(0) {}  // NOLINT: implicit on purpose, for constants
  Dual(const T& x, const T& dx) : value(x), slope(dx) {}
  template <class Number>
  requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, T>) explicit Dual(Number x)
      : value(static_cast<T>(x)), slope(0) {}

  // In place, since a copy of a number of 50 digits takes as long as its sum.
  Dual& operator+=(const Dual& b) {
    value += b.value;
    slope += b.slope;
    return *this;
  }
  Dual& operator-=(const Dual& b) {
    value -= b.value;
    slope -= b.slope;
    return *this;
  }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend Dual operator-(const Dual& a) { return {T(-a.value), T(-a.slope)}; }
  friend Dual operator+(Dual a, const Dual& b) {
    a += b;
    return a;
  }
  friend Dual operator-(Dual a, const Dual& b) {
    a -= b;
    return a;
  }
  friend Dual operator*(Dual a, const Dual& b) {
    a.slope *= b.value;
    a.slope += a.value * b.slope;
    a.value *= b.value;
    return a;
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const T ratio = a.value / b.value;
    return {ratio, T((a.slope - ratio * b.slope) / b.value)};
  }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend bool operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }

  friend Dual sin(const Dual& a) {
    using std::cos;
    using std::sin;
    return {T(sin(a.value)), T(cos(a.value) * a.slope)};
  }
  friend Dual cos(const Dual& a) {
    using std::cos;
    using std::sin;
    return {T(cos(a.value)), T(-sin(a.value) * a.slope)};
  }
  friend Dual sqrt(const Dual& a) {
    using std::sqrt;
    const T root = sqrt(a.value);
    return {root, T(a.slope / (T(2) * root))};
  }
};

}  // namespace treeline::interpreter

template <class T>
inline constexpr bool treeline::kHasStridedProducts<treeline::interpreter::Dual<T>> = true;

namespace Eigen {

/// Properties of a scalar that Eigen needs, by names that it prescribes.
// NOLINTBEGIN(readability-identifier-naming)
template <class T>
struct NumTraits<treeline::interpreter::Dual<T>> : NumTraits<T> {
  using Real = treeline::interpreter::Dual<T>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum { RequireInitialization = 1, IsComplex = 0, IsInteger = 0, IsSigned = 1 };
};
// NOLINTEND(readability-identifier-naming)

}  // namespace Eigen
