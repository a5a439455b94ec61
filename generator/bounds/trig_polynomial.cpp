#include "bounds/trig_polynomial.hpp"

#include <cmath>
#include <map>

#include "functions/quantity.hpp"

namespace treeline::bounds {
namespace {

bool is_first_degree(const TrigPolynomial& p) {
  return p.c[3] == 0 && p.c[4] == 0;
}

/// Angles of inputs `sin_q[3]` and `cos_q[3]`. They are numbered downward from the largest number.
struct GivenAngles {
  std::map<std::string, Angle> of;

  std::optional<TrigPolynomial> find(const std::string& input) {
    const auto quantity = quantity_of_input(input);
    const bool sine = quantity == Quantity::sin_q;
    if (!sine && quantity != Quantity::cos_q) return std::nullopt;
    const auto next = static_cast<Angle>(~of.size());
    TrigPolynomial p;
    p.angle = of.try_emplace(input.substr(input.find('[')), next).first->second;
    p.c[sine ? 2 : 1] = 1;
    return p;
  }
};

std::optional<TrigPolynomial> combine(const Node& node, const std::optional<TrigPolynomial>& a,
                                      const std::optional<TrigPolynomial>& b) {
  if (!a || !b) return std::nullopt;
  if (node.op == Op::add) return add(*a, *b);
  if (node.op == Op::sub) return add(*a, -*b);
  if (node.op == Op::mul) return multiply(*a, *b);
  return std::nullopt;
}

}  // namespace

double TrigPolynomial::magnitude() const {
  return std::abs(c[0]) + std::hypot(c[1], c[2]) + std::hypot(c[3], c[4]);
}

TrigPolynomial constant(double value) {
  TrigPolynomial p;
  p.c[0] = value;
  return p;
}

TrigPolynomial operator-(TrigPolynomial p) {
  for (double& x : p.c) x = -x;
  return p;
}

std::optional<TrigPolynomial> add(const TrigPolynomial& a, const TrigPolynomial& b) {
  if (!a.is_constant() && !b.is_constant() && a.angle != b.angle) return std::nullopt;
  TrigPolynomial sum = a.is_constant() ? b : a;
  for (std::size_t i = 0; i < sum.c.size(); ++i) sum.c[i] = a.c[i] + b.c[i];
  return sum;
}

std::optional<TrigPolynomial> multiply(const TrigPolynomial& a, const TrigPolynomial& b) {
  if (a.is_constant() || b.is_constant()) {
    TrigPolynomial product = a.is_constant() ? b : a;
    const double factor = a.is_constant() ? a.c[0] : b.c[0];
    for (double& x : product.c) x *= factor;
    return product;
  }
  if (a.angle != b.angle || !is_first_degree(a) || !is_first_degree(b)) return std::nullopt;
  TrigPolynomial product;
  product.angle = a.angle;
  const double cc = a.c[1] * b.c[1];
  const double ss = a.c[2] * b.c[2];
  product.c = {a.c[0] * b.c[0] + (cc + ss) / 2, a.c[0] * b.c[1] + a.c[1] * b.c[0],
               a.c[0] * b.c[2] + a.c[2] * b.c[0], (cc - ss) / 2,
               (a.c[1] * b.c[2] + a.c[2] * b.c[1]) / 2};
  return product;
}

std::vector<std::optional<TrigPolynomial>> find_polynomials(const Graph& graph) {
  const std::vector<Node>& nodes = graph.nodes();
  std::vector<std::optional<TrigPolynomial>> found(nodes.size());
  GivenAngles given;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node& node = nodes[i];
    if (node.op == Op::constant) {
      found[i] = constant(node.value);
    } else if (node.op == Op::sin || node.op == Op::cos) {
      found[i].emplace().angle = node.a;
      found[i]->c[node.op == Op::sin ? 2 : 1] = 1;
    } else if (node.op == Op::neg) {
      if (found[node.a]) found[i] = -*found[node.a];
    } else if (node.op == Op::input) {
      found[i] = given.find(graph.inputs()[node.a]);
    } else {
      found[i] = combine(node, found[node.a], found[node.b]);
    }
  }
  return found;
}

}  // namespace treeline::bounds
