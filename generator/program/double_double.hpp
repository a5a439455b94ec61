#pragma once

namespace treeline {

/// A number of about 32 decimal digits: the sum of two doubles, of which the first is the sum
/// rounded to nearest. Constants of a graph are combined in it, so that each is rounded once, as it
/// is emitted. It does not need the 50 digits of a mechanism: what cancels in constants of a robot
/// is far less than half of its digits.
///
/// Source: T. J. Dekker, A floating-point technique for extending the available precision, 1971; M.
/// Joldes, J.-M. Muller, V. Popescu, Tight and rigorous error bounds for basic building blocks of
/// double-word arithmetic, 2017.
struct DoubleDouble {
  double value = 0;  ///< rounded
  double rest = 0;   ///< what rounding left

  DoubleDouble() = default;
  DoubleDouble(double x) : value(x) {}  // NOLINT: implicit on purpose, because it is a scalar
  /// The sum of both; the second must be the smaller one. Without a rest if it is not finite.
  DoubleDouble(double larger, double smaller);

  /// Rounds a wider number.
  template <class Wide>
  static DoubleDouble from(const Wide& x) {
    const auto first = static_cast<double>(x);
    return {first, static_cast<double>(Wide(x - Wide(first)))};
  }

  DoubleDouble operator-() const { return {-value, -rest}; }
};

/// a + b. It is 0 where less than 2^-70 of the terms is left: constants cancel exactly, and what
/// seems to be left is of their rounding to 32 digits.
DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b);
DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b);
DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b);

}  // namespace treeline
