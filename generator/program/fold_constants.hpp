#pragma once

#include "program/expression.hpp"

namespace treeline {

/// The node of `e`, whose sign is ignored. The reference is valid until a node is added.
inline const Node& look(Expression e) {
  return Graph::current().nodes()[e.node()];
}

inline Expression with_sign(Expression e, bool negative) {
  return negative ? -e : e;
}
inline Expression unsigned_of(Expression e) {
  return {e.node(), false};
}

/// Whether `e` is a constant that does not belong to a limb, so that its value may be used.
bool is_ordinary_constant(Expression e);

/// a + b, a b and a / b of constants, as a constant. It belongs to a limb if a or b does.
Expression fold_sum(Expression a, Expression b);
Expression fold_product(Expression a, Expression b);
Expression fold_quotient(Expression a, Expression b);

}  // namespace treeline
