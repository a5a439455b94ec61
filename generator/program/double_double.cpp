#include "program/double_double.hpp"

#include <algorithm>
#include <cmath>

namespace treeline {
namespace {

constexpr double kLeast = 0x1p-70;

/// The sum of any two doubles, exactly (Knuth, The Art of Computer Programming 4.2.2).
DoubleDouble exact_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

/// The product of two doubles, exactly.
DoubleDouble exact_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

}  // namespace

DoubleDouble::DoubleDouble(double larger, double smaller)
    : value(larger + smaller), rest(smaller - (value - larger)) {
  if (!std::isfinite(rest)) {
    value = larger;
    rest = 0;
  }
}

DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble values = exact_sum(a.value, b.value);
  const DoubleDouble rests = exact_sum(a.rest, b.rest);
  const DoubleDouble upper(values.value, values.rest + rests.value);
  const DoubleDouble sum(upper.value, upper.rest + rests.rest);
  const double most = std::max(std::fabs(a.value), std::fabs(b.value));
  return std::fabs(sum.value) <= kLeast * most ? DoubleDouble() : sum;
}

DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble values = exact_product(a.value, b.value);
  return {values.value, values.rest + (a.value * b.rest + a.rest * b.value)};
}

DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double first = a.value / b.value;
  if (!std::isfinite(first) || b.value == 0) return first;
  const DoubleDouble left = a + -(b * first);
  const double second = left.value / b.value;
  const DoubleDouble last = left + -(b * second);
  return DoubleDouble(first, second + last.value / b.value);
}

}  // namespace treeline
