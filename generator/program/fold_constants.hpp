#pragma once

#include "program/expression.hpp"

namespace treeline {

/// Without the sign. The reference holds until a node is added.
inline const Node& look(Expression e) {
  return Graph::current().nodes()[e.node()];
}

inline Expression with_sign(Expression e, bool negative) {
  return negative ? -e : e;
}
inline Expression unsigned_of(Expression e) {
  return {e.node(), false};
}

/// A constant, and not one of a limb: its value may be reckoned with.
bool is_ordinary_constant(Expression e);

/// a + b, a b and a / b of constants, as a constant: of a limb where a or b is.
Expression fold_sum(Expression a, Expression b);
Expression fold_product(Expression a, Expression b);
Expression fold_quotient(Expression a, Expression b);

}  // namespace treeline
