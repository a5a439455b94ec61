#include "digits/digits50.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <new>
#include <ostream>
#include <type_traits>
#include <utility>

#include "digits/binary168.hpp"
#include "digits/sin_cos.hpp"

namespace treeline {

using Number = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                             boost::multiprecision::et_off>;

// A number of fixed precision owns no memory and contains no pointer, so its bytes are its value,
// and a copy of the bytes is a copy of the number.
static_assert(sizeof(Number) <= sizeof(Digits50) && alignof(Number) <= alignof(Digits50));
static_assert(std::is_trivially_destructible_v<Number>);

struct Digits50Access {
  static Number& of(Digits50& x) { return *std::launder(reinterpret_cast<Number*>(x.storage_)); }
  static const Number& of(const Digits50& x) {
    return *std::launder(reinterpret_cast<const Number*>(x.storage_));
  }
  template <class Value>
  static void start(Digits50& x, const Value& value) {
    ::new (static_cast<void*>(x.storage_)) Number(value);
  }
};

namespace {

const Number& of(const Digits50& x) {
  return Digits50Access::of(x);
}
Number& of(Digits50& x) {
  return Digits50Access::of(x);
}
Digits50 wrapped(const Number& value) {
  Digits50 result;
  of(result) = value;
  return result;
}

using Limb = std::remove_cvref_t<decltype(*std::declval<Number&>().backend().bits().limbs())>;
#if defined(__SIZEOF_INT128__)
constexpr bool kHasFastLimbs = sizeof(Limb) == sizeof(std::uint64_t);
#else
constexpr bool kHasFastLimbs = false;
#endif

/// Whether the number is not zero, infinite or NaN, whose exponents are out of this range. Sums of
/// two such numbers stay in the range of Number.
bool is_common(const Number& x) {
  constexpr int kMost = 1 << 28;
  return x.backend().exponent() > -kMost && x.backend().exponent() < kMost;
}

bool is_zero(const Number& x) {
  return x.backend().exponent() == Number::backend_type::exponent_zero;
}

/// Whether one of them is zero, and neither infinite, NaN or out of the range above.
bool has_zero(const Number& a, const Number& b) {
  return is_zero(a) ? is_zero(b) || is_common(b) : is_zero(b) && is_common(a);
}

/// to = a + b or a - b where `has_zero(a, b)`: half of the sums of sparse matrices.
void add_zero(Number& to, const Number& a, const Number& b, bool minus) {
  const bool a_is_zero = is_zero(a), a_negative = a.backend().sign();
  const bool b_negative = b.backend().sign() != minus;
  to = a_is_zero ? b : a;
  if (a_is_zero) to.backend().sign() = b_negative && (a_negative || !is_zero(to));
}

digits::Binary168 parts_of(const Number& x) {
  const auto* const limbs = x.backend().bits().limbs();
  return {{limbs[0], limbs[1], limbs[2]}, x.backend().exponent(), x.backend().sign()};
}

void assign_parts(Number& x, const digits::Binary168& parts) {
  auto& bits = x.backend().bits();
  bits.resize(3, 3);
  std::copy_n(parts.limbs.begin(), 3, bits.limbs());
  x.backend().exponent() = static_cast<int>(parts.exponent);
  x.backend().sign() = parts.negative;
}

/// to = a + b or a - b with the same bits as `Number`, but several times faster. Returns false if
/// nothing was done.
bool add_fast(Number& to, const Number& a, const Number& b, bool minus) {
  if constexpr (kHasFastLimbs) {
    if (has_zero(a, b)) {
      add_zero(to, a, b, minus);
      return true;
    }
    if (!is_common(a) || !is_common(b)) return false;
    const int apart = a.backend().exponent() - b.backend().exponent();
    if (apart > digits::kFarthest || apart < -digits::kFarthest) return false;
    digits::Binary168 other = parts_of(b), sum;
    other.negative = other.negative != minus;
    if (digits::add(parts_of(a), other, sum)) {
      assign_parts(to, sum);
    } else {
      to = Number();
    }
    return true;
  }
  return false;
}

/// to = a b with the same bits as `Number`, but several times faster. Returns false if nothing was
/// done.
bool multiply_fast(Number& to, const Number& a, const Number& b) {
  if constexpr (kHasFastLimbs) {
    if (has_zero(a, b)) {
      const bool negative = a.backend().sign() != b.backend().sign();
      to = Number();
      to.backend().sign() = negative;
      return true;
    }
    if (!is_common(a) || !is_common(b)) return false;
    assign_parts(to, digits::multiply(parts_of(a), parts_of(b)));
    return true;
  }
  return false;
}

/// x = value, if that is finite, where x is zero: its 53 bits are the highest. Returns false if
/// nothing was done.
bool assign_fast(Number& x, double value) {
  if constexpr (kHasFastLimbs) {
    if (!std::isfinite(value)) return false;
    if (value == 0) {
      x.backend().sign() = std::signbit(value);
      return true;
    }
    int exponent = 0;
    const double fraction = std::frexp(std::abs(value), &exponent);
    const auto bits = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    assign_parts(x, {{0, bits << 51, bits >> 13}, exponent - 1, value < 0});
    return true;
  }
  return false;
}

}  // namespace

Digits50::Digits50(double value) noexcept {
  ::new (static_cast<void*>(storage_)) Number();
  if (!assign_fast(of(*this), value)) of(*this) = value;
}
Digits50::Digits50(long double value) noexcept {
  Digits50Access::start(*this, value);
}
Digits50::Digits50(const char* digits) {
  Digits50Access::start(*this, digits);
}
void Digits50::assign(long long value) noexcept {
  constexpr long long kMostInDouble = 1LL << std::numeric_limits<double>::digits;
  ::new (static_cast<void*>(storage_)) Number();
  const bool is_double = -kMostInDouble <= value && value <= kMostInDouble;
  if (!is_double || !assign_fast(of(*this), static_cast<double>(value))) of(*this) = value;
}
void Digits50::assign(unsigned long long value) noexcept {
  Digits50Access::start(*this, value);
}

Digits50::operator float() const noexcept {
  return static_cast<float>(of(*this));
}
Digits50::operator double() const noexcept {
  return static_cast<double>(of(*this));
}
Digits50::operator long double() const noexcept {
  return static_cast<long double>(of(*this));
}
Digits50::operator int() const noexcept {
  return static_cast<int>(of(*this));
}

Digits50& Digits50::operator+=(const Digits50& other) noexcept {
  if (!add_fast(of(*this), of(*this), of(other), false)) of(*this) += of(other);
  return *this;
}
Digits50& Digits50::operator-=(const Digits50& other) noexcept {
  if (!add_fast(of(*this), of(*this), of(other), true)) of(*this) -= of(other);
  return *this;
}
Digits50& Digits50::operator*=(const Digits50& other) noexcept {
  if (!multiply_fast(of(*this), of(*this), of(other))) of(*this) *= of(other);
  return *this;
}
Digits50& Digits50::operator/=(const Digits50& other) noexcept {
  of(*this) /= of(other);
  return *this;
}
Digits50 Digits50::operator-() const noexcept {
  Digits50 result = *this;
  of(result).backend().negate();
  return result;
}

// Into a number of its own: copies of operands wait for their limbs to be stored.
Digits50 Digits50::sum(const Digits50& a, const Digits50& b) noexcept {
  Digits50 result;
  if (!add_fast(of(result), of(a), of(b), false)) of(result) = of(a) + of(b);
  return result;
}
Digits50 Digits50::difference(const Digits50& a, const Digits50& b) noexcept {
  Digits50 result;
  if (!add_fast(of(result), of(a), of(b), true)) of(result) = of(a) - of(b);
  return result;
}
Digits50 Digits50::product(const Digits50& a, const Digits50& b) noexcept {
  Digits50 result;
  if (!multiply_fast(of(result), of(a), of(b))) of(result) = of(a) * of(b);
  return result;
}

bool Digits50::equal(const Digits50& a, const Digits50& b) noexcept {
  return of(a) == of(b);
}
bool Digits50::less(const Digits50& a, const Digits50& b) noexcept {
  return of(a) < of(b);
}
bool Digits50::at_most(const Digits50& a, const Digits50& b) noexcept {
  return of(a) <= of(b);
}

Digits50 abs(const Digits50& x) noexcept {
  return wrapped(abs(of(x)));
}
Digits50 sqrt(const Digits50& x) {
  return wrapped(sqrt(of(x)));
}
Digits50 sin(const Digits50& x) {
  return digits::is_reducible(x) ? digits::sine(x) : wrapped(sin(of(x)));
}
Digits50 cos(const Digits50& x) {
  return digits::is_reducible(x) ? digits::cosine(x) : wrapped(cos(of(x)));
}
Digits50 atan2(const Digits50& y, const Digits50& x) {
  return wrapped(atan2(of(y), of(x)));
}
Digits50 exp(const Digits50& x) {
  return wrapped(exp(of(x)));
}
Digits50 log(const Digits50& x) {
  return wrapped(log(of(x)));
}
Digits50 pow(const Digits50& x, const Digits50& y) {
  return wrapped(pow(of(x), of(y)));
}
Digits50 round(const Digits50& x) {
  return wrapped(round(of(x)));
}
Digits50 floor(const Digits50& x) {
  return wrapped(floor(of(x)));
}
Digits50 ceil(const Digits50& x) {
  return wrapped(ceil(of(x)));
}
bool isfinite(const Digits50& x) noexcept {
  return boost::multiprecision::isfinite(of(x));
}
bool isnan(const Digits50& x) noexcept {
  return boost::multiprecision::isnan(of(x));
}
bool isinf(const Digits50& x) noexcept {
  return boost::multiprecision::isinf(of(x));
}
std::ostream& operator<<(std::ostream& out, const Digits50& x) {
  return out << of(x);
}
const Digits50& half_pi() {
  static const Digits50 value = wrapped(boost::math::constants::half_pi<Number>());
  return value;
}

template void strided_product<Digits50>(const ProductSize&, Strided<const Digits50>,
                                        Strided<const Digits50>, Strided<Digits50>, Enter);

}  // namespace treeline

using treeline::Digits50;
using Limits = std::numeric_limits<treeline::Number>;

Digits50 std::numeric_limits<Digits50>::epsilon() {
  return treeline::wrapped(Limits::epsilon());
}
Digits50 std::numeric_limits<Digits50>::min() {
  return treeline::wrapped(Limits::min());
}
Digits50 std::numeric_limits<Digits50>::max() {
  return treeline::wrapped(Limits::max());
}
Digits50 std::numeric_limits<Digits50>::lowest() {
  return treeline::wrapped(Limits::lowest());
}
Digits50 std::numeric_limits<Digits50>::infinity() {
  return treeline::wrapped(Limits::infinity());
}
Digits50 std::numeric_limits<Digits50>::quiet_NaN() {
  return treeline::wrapped(Limits::quiet_NaN());
}
