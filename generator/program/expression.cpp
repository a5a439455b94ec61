#include "program/expression.hpp"

#include <cmath>
#include <utility>

#include "program/fold_constants.hpp"

// The constructors. Each tries its rules in the order written, from special to general. What no
// rule covers becomes a node. A rule is here only if it never costs an operation, even if the
// operands that it dissolves have other uses. Rewriting that depends on the number of uses is in
// passes/. The rules hold in real arithmetic. Emission and evaluation both use the simplified
// graph, and agree on it to the bit.

namespace treeline {
namespace {

Expression make(Op op, Expression a, Expression b) {
  return {Graph::current().intern({op, a.node(), b.node(), 0}), false};
}

/// Orders the operands of a commutative operation: a constant comes first.
void order(Expression& a, Expression& b) {
  if (!a.is_constant() && b.is_constant()) {
    std::swap(a, b);
  }
}

/// Makes a op b, or returns b op a if that node exists already.
Expression make_commuting(Op op, Expression a, Expression b) {
  const Graph& graph = Graph::current();
  return graph.merges_commuted() && graph.contains({op, b.node(), a.node(), 0}) ? make(op, b, a)
                                                                                : make(op, a, b);
}

/// An expression as coefficient * base. Anything but a product with an ordinary constant is its own
/// base.
struct Multiple {
  double coefficient;  // rounded
  Expression base;
  std::uint32_t factor = kNoNode;  // the constant; none where the coefficient is 1 or -1
};

/// Sums and differences take most of the time that a trace takes. This is what they call most.
Multiple as_multiple(const std::vector<Node>& nodes, Expression e) {
  const Node& node = nodes[e.node()];
  const double sign = e.negative() ? -1 : 1;
  if (node.op == Op::mul) {
    const Node& factor = nodes[node.a];
    if (factor.op == Op::constant && limb_constant(factor).slot == 0) {
      return {sign * factor.value, {node.b, false}, node.a};
    }
  }
  return {sign, unsigned_of(e)};
}

Multiple as_multiple(Expression e) {
  return as_multiple(Graph::current().nodes(), e);
}

DoubleDouble exact_coefficient(const Multiple& multiple) {
  if (multiple.factor == kNoNode) return multiple.coefficient;
  return Expression(multiple.factor, multiple.coefficient < 0).exact_constant();
}

/// The two signed terms of a sum or difference.
struct Terms {
  Expression first, second;
};

bool is_sum(Expression e) {
  return is_sum(look(e).op);
}

Terms terms_of(Expression e) {
  const Node& node = look(e);
  return {{node.a, e.negative()}, {node.b, e.negative() != (node.op == Op::sub)}};
}

/// Node of the angle of `e`, if `e` is the square of a sine or cosine (as `function` says), else
/// 0.
std::uint32_t angle_of_square(Expression e, Op function) {
  const Node& node = look(e);
  if (node.op != Op::mul || node.a != node.b) {
    return 0;
  }
  const Node& factor = look({node.a, false});
  return factor.op == function ? factor.a : 0;
}

/// Whether a + b is sin^2 x + cos^2 x.
bool is_pythagorean(Expression a, Expression b) {
  const std::uint32_t angle = angle_of_square(a, Op::sin);
  return angle != 0 && angle == angle_of_square(b, Op::cos);
}

/// A term that is to be added, and what it is a multiple of.
struct Added {
  Expression term;
  Multiple multiple;
};

/// Adds two terms if that takes no operation: (x - x), constants, (2 x - x). Returns false
/// otherwise.
bool add_for_free(Expression a, const Added& b, Expression& result) {
  const std::vector<Node>& nodes = Graph::current().nodes();
  if (nodes[a.node()].op == Op::constant && nodes[b.term.node()].op == Op::constant) {
    result = fold_sum(a, b.term);
    return true;
  }
  const Multiple m = as_multiple(nodes, a);
  if (m.base != b.multiple.base) return false;
  const DoubleDouble coefficient = exact_coefficient(m) + exact_coefficient(b.multiple);
  if (coefficient.value != 0 && std::fabs(coefficient.value) != 1) return false;
  result = Expression(coefficient) * m.base;
  return true;
}

/// Adds `term` to `sum` if it merges with one of the sum's terms: (x - y) + y -> x; (x + c) + d ->
/// x + (c + d); (x + 2 y) - y -> x + y. Returns false otherwise.
bool merge_into_sum(Expression sum, const Added& term, Expression& merged) {
  if (!is_sum(sum)) {
    return false;
  }
  const Terms terms = terms_of(sum);
  Expression both;
  if (add_for_free(terms.first, term, both)) {
    merged = terms.second + both;
    return true;
  }
  if (add_for_free(terms.second, term, both)) {
    merged = terms.first + both;
    return true;
  }
  return false;
}

/// Adds two sums if a term of one cancels a term of the other: (x + y) + (z - y) -> x + z. Returns
/// false otherwise.
bool cancel_between_sums(Expression a, Expression b, Expression& merged) {
  if (!is_sum(a) || !is_sum(b)) {
    return false;
  }
  const Terms s = terms_of(a);
  const Terms t = terms_of(b);
  for (const auto& [own, rest] : {std::pair{s.first, s.second}, std::pair{s.second, s.first}}) {
    if (own == -t.first) {
      merged = rest + t.second;
      return true;
    }
    if (own == -t.second) {
      merged = rest + t.first;
      return true;
    }
  }
  return false;
}

/// Makes the node of a + b, where neither is zero and not both are constants. Terms of equal sign
/// are added, with the sign taken outside. Terms of different signs are subtracted; x - y and y - x
/// are one node.
Expression make_sum(Expression a, Expression b) {
  if (a.negative() == b.negative()) {
    order(a, b);
    return with_sign(make_commuting(Op::add, a, b), a.negative());
  }
  if (a.negative()) {
    std::swap(a, b);
  }
  const Graph& graph = Graph::current();
  if (graph.merges_commuted() && graph.contains({Op::sub, b.node(), a.node(), 0})) {
    std::swap(a, b);
  }
  return with_sign(make(Op::sub, a, b), a.negative());
}

/// Removes the factor `known` from a product: x y, x -> y. Returns false if it is not a factor.
bool remove_factor(const Node& product, Expression known, Expression& other) {
  if (product.op != Op::mul || (product.a != known.node() && product.b != known.node())) {
    return false;
  }
  other = {product.a == known.node() ? product.b : product.a, false};
  return true;
}

/// c * x for a constant c >= 0 and an x without sign that is not a constant.
Expression scale(Expression c, Expression x) {
  if (is_ordinary_constant(c) && c.constant() == 1) {
    return x;
  }
  const Node node = look(x);
  const Expression a(node.a, false);
  if (node.op == Op::mul && a.is_constant()) {  // c (d y) -> (c d) y
    return fold_product(c, a) * Expression(node.b, false);
  }
  if (node.op == Op::div && a.is_constant()) {  // c (d / y) -> (c d) / y
    return fold_product(c, a) / Expression(node.b, false);
  }
  return make(Op::mul, c, x);
}

/// c / x for a constant c > 0 and an x without sign that is not a constant.
Expression divide_constant(Expression c, Expression x) {
  const Node node = look(x);
  const Expression a(node.a, false);
  const Expression b(node.b, false);
  if (node.op == Op::mul && a.is_constant()) {  // c / (d y) -> (c / d) / y
    return fold_quotient(c, a) / b;
  }
  if (node.op == Op::div && a.is_constant()) {  // c / (d / y) -> (c / d) y
    return fold_quotient(c, a) * b;
  }
  if (node.op == Op::div && is_ordinary_constant(c) && c.constant() == 1) {  // 1 / (x / y) -> y / x
    return b / a;
  }
  return make(Op::div, c, x);
}

}  // namespace

/// Constants are stored without sign. Both zeros are node 0, which has no sign: a zero that is
/// known while generating is structural and not the outcome of a rounding.
Expression::Expression(const DoubleDouble& value) {
  if (value.value != 0) {
    negative_ = std::signbit(value.value);
    node_ = Graph::current().intern({Op::constant, 0, 0, std::fabs(value.value)},
                                    negative_ ? -value.rest : value.rest);
  }
}

Expression::Expression(double value) : Expression(DoubleDouble(value)) {}

LimbConstant limb_constant(const Node& node) {
  constexpr std::uint32_t kLowHalf = 0xffff;
  return node.op == Op::constant ? LimbConstant{node.a, node.b & kLowHalf, node.b >> 16}
                                 : LimbConstant{};
}

Node make_limb_constant(LimbConstant what, double value) {
  return {Op::constant, what.slot, what.limb | what.limbs << 16, value};
}

bool Expression::is_limb_constant() const {
  return limb_constant(look(*this)).slot != 0;
}

bool Expression::is_constant() const {
  return is_zero() || look(*this).op == Op::constant;
}

double Expression::constant() const {
  return is_zero() ? 0 : (negative_ ? -1 : 1) * look(*this).value;
}

DoubleDouble Expression::exact_constant() const {
  if (is_zero()) return 0;
  const DoubleDouble size(look(*this).value, Graph::current().rest_of(node_));
  return negative_ ? -size : size;
}

Expression operator+(Expression a, Expression b) {
  if (a.is_zero()) {  // 0 + x -> x
    return b;
  }
  if (b.is_zero()) {
    return a;
  }
  if (a.is_constant() && b.is_constant()) {
    return fold_sum(a, b);
  }
  const Multiple m = as_multiple(a);
  const Multiple n = as_multiple(b);
  if (m.base == n.base) {  // c x + d x -> (c + d) x; so x - x -> 0, x + x -> 2 x
    return Expression(exact_coefficient(m) + exact_coefficient(n)) * m.base;
  }
  if (m.coefficient == n.coefficient &&
      (is_pythagorean(m.base, n.base) || is_pythagorean(n.base, m.base))) {
    return exact_coefficient(m);  // c sin^2 x + c cos^2 x -> c
  }
  Expression merged;
  if (merge_into_sum(a, {b, n}, merged) || merge_into_sum(b, {a, m}, merged) ||
      cancel_between_sums(a, b, merged)) {
    return merged;
  }
  return make_sum(a, b);
}

Expression operator*(Expression a, Expression b) {
  if (a.is_zero() || b.is_zero()) {  // 0 x -> 0
    return {};
  }
  if (a.is_constant() && b.is_constant()) {
    return fold_product(a, b);
  }
  const bool negative = a.negative() != b.negative();
  a = unsigned_of(a);
  b = unsigned_of(b);
  order(a, b);
  if (a.is_constant()) {
    return with_sign(scale(a, b), negative);
  }
  const Node& left = look(a);
  const Node& right = look(b);
  if (left.op == Op::div && left.b == b.node()) {  // (x / y) y -> x
    return {left.a, negative};
  }
  if (right.op == Op::div && right.b == a.node()) {
    return {right.a, negative};
  }
  return with_sign(make_commuting(Op::mul, a, b), negative);
}

/// Division by a constant is multiplication by its reciprocal. That is several times faster and
/// costs at most one more rounding (1.5 ulp instead of 0.5), and none for powers of two. Division
/// by a structural zero stays in the graph, so that it can be found and reported.
Expression operator/(Expression a, Expression b) {
  const bool negative = a.negative() != b.negative();
  a = unsigned_of(a);
  b = unsigned_of(b);
  if (b.is_zero()) {
    return with_sign(make(Op::div, a, b), negative);
  }
  if (a.is_zero()) {  // 0 / x -> 0
    return {};
  }
  if (a.is_constant() && b.is_constant()) {
    return with_sign(fold_quotient(a, b), negative);
  }
  if (b.is_constant()) {
    return with_sign(fold_quotient(1, b) * a, negative);
  }
  if (a.is_constant()) {
    return with_sign(divide_constant(a, b), negative);
  }
  const Multiple m = as_multiple(a);
  const Multiple n = as_multiple(b);
  if (m.base == n.base) {  // (c x) / (d x) -> c / d
    return with_sign(exact_coefficient(m) / exact_coefficient(n), negative);
  }
  Expression other;
  if (remove_factor(look(a), b, other)) {  // (x y) / y -> x
    return with_sign(other, negative);
  }
  return with_sign(make(Op::div, a, b), negative);
}

Expression sin(Expression a) {
  if (a.is_constant()) {
    return {std::sin(a.constant())};
  }
  return with_sign(make(Op::sin, unsigned_of(a), {}), a.negative());  // odd function
}

Expression cos(Expression a) {
  if (a.is_constant()) {
    return {std::cos(a.constant())};
  }
  return make(Op::cos, unsigned_of(a), {});  // even function
}

}  // namespace treeline
