#pragma once

#include <utility>

#include "program/expression.hpp"

namespace treeline {

/// An expression whose operators make the operations as written, as a processor executes them. The
/// operators of `Expression` simplify by rules of real arithmetic, which changes rounding. Here
/// only sums with 0, products with 0, 1 and -1, and quotients of 0 vanish, which are exact.
class PlainExpression {
 public:
  PlainExpression() = default;
  explicit PlainExpression(double value) : value_(value) {}
  explicit PlainExpression(Expression value) : value_(value) {}

  [[nodiscard]] Expression value() const { return value_; }

  PlainExpression operator-() const { return PlainExpression(-value_); }
  friend PlainExpression operator+(const PlainExpression& a, const PlainExpression& b) {
    return PlainExpression(sum(a.value_, b.value_));
  }
  friend PlainExpression operator-(const PlainExpression& a, const PlainExpression& b) {
    return PlainExpression(sum(a.value_, -b.value_));
  }
  friend PlainExpression operator*(const PlainExpression& a, const PlainExpression& b) {
    return PlainExpression(product(a.value_, b.value_));
  }
  friend PlainExpression operator/(const PlainExpression& a, const PlainExpression& b) {
    if (a.value_.is_zero()) return {};
    const bool negative = a.value_.negative() != b.value_.negative();
    return PlainExpression(make(Op::div, a.value_, b.value_, negative));
  }
  friend void sin_cos(const PlainExpression& angle, PlainExpression& sine,
                      PlainExpression& cosine) {
    sine.value_ = sin(angle.value_);
    cosine.value_ = cos(angle.value_);
  }

 private:
  static Expression make(Op op, Expression a, Expression b, bool negative) {
    return {Graph::current().intern({op, a.node(), b.node(), 0}), negative};
  }
  static Expression sum(Expression a, Expression b) {
    if (a.is_zero()) return b;
    if (b.is_zero()) return a;
    if (a.negative() == b.negative()) return make(Op::add, a, b, a.negative());
    if (a.negative()) std::swap(a, b);
    return make(Op::sub, a, b, false);
  }
  static Expression product(Expression a, Expression b) {
    if (!a.is_constant()) std::swap(a, b);  // a constant comes first
    const bool negative = a.negative() != b.negative();
    if (a.is_zero() || b.is_zero()) return {};
    for (const auto& [one, other] : {std::pair{a, b}, std::pair{b, a}}) {
      if (one.is_constant() && (one.constant() == 1 || one.constant() == -1)) {
        return {other.node(), negative};
      }
    }
    return make(Op::mul, a, b, negative);
  }

  Expression value_;
};

}  // namespace treeline
