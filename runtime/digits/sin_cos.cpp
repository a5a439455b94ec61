#include "digits/sin_cos.hpp"

#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>

// Taylor series on the eighth of a turn around zero, with the arithmetic of `Digits50`, which is
// several times faster than that of the series in Boost.

namespace treeline {
namespace {

/// pi / 2 in two parts. The first has 120 bits, so its product with a number of quarter turns is
/// exact.
struct QuarterTurn {
  Digits50 high, low;
};

const QuarterTurn& quarter_turn() {
  static const QuarterTurn both = [] {
    using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                               boost::multiprecision::et_off>;
    constexpr int kBits = 119;
    const Long all = boost::math::constants::half_pi<Long>();
    const Long high = ldexp(Long(floor(ldexp(all, kBits))), -kBits);
    const auto digits = [](const Long& x) { return Digits50(x.str(70).c_str()); };
    const Digits50 rounded = digits(high);
    // The text is rounded. The part itself is an integer multiple of its last bit.
    Digits50 scale = 1;
    for (int i = 0; i < kBits; ++i) scale *= 2;
    return QuarterTurn{round(rounded * scale) / scale, digits(Long(all - high))};
  }();
  return both;
}

/// An angle of at most an eighth of a turn, and the number of quarter turns that were subtracted.
struct Reduced {
  Digits50 angle;
  int quarters = 0;  ///< 0 to 3
};

Reduced reduced(const Digits50& x) {
  const Digits50 turns = round(x / half_pi());
  const Digits50 angle = x - turns * quarter_turn().high - turns * quarter_turn().low;
  const auto quarters = static_cast<long long>(static_cast<double>(turns)) % 4;
  return {angle, static_cast<int>(quarters < 0 ? quarters + 4 : quarters)};
}

constexpr std::size_t kTerms = 22;

/// The coefficients 1/first!, -1/(first + 2)!, 1/(first + 4)! ...
std::array<Digits50, kTerms> coefficients(int first) {
  std::array<Digits50, kTerms> all;
  Digits50 coefficient = 1;
  for (std::size_t i = 0; i < kTerms; ++i) {
    all[i] = coefficient;
    const int next = first + 2 * static_cast<int>(i) + 1;
    coefficient /= Digits50(-next * (next + 1));
  }
  return all;
}

Digits50 sum_up(const std::array<Digits50, kTerms>& coefficients, const Digits50& square) {
  Digits50 sum = coefficients.back();
  for (std::size_t i = kTerms - 1; i-- > 0;) sum = sum * square + coefficients[i];
  return sum;
}

Digits50 sine_near_zero(const Digits50& x) {
  static const auto all = coefficients(1);
  return x * sum_up(all, x * x);
}

Digits50 cosine_near_zero(const Digits50& x) {
  static const auto all = coefficients(0);
  return sum_up(all, x * x);
}

/// Sine of the angle plus this many quarter turns.
Digits50 sine_ahead(const Reduced& x, int quarters) {
  const int all = (x.quarters + quarters) % 4;
  const Digits50 value = all % 2 == 0 ? sine_near_zero(x.angle) : cosine_near_zero(x.angle);
  return all < 2 ? value : -value;
}

}  // namespace

namespace digits {

bool is_reducible(const Digits50& angle) {
  static const Digits50 kMost(1e12);
  return abs(angle) < kMost;
}
Digits50 sine(const Digits50& angle) {
  return sine_ahead(reduced(angle), 0);
}
Digits50 cosine(const Digits50& angle) {
  return sine_ahead(reduced(angle), 1);
}

}  // namespace digits
}  // namespace treeline
