#include "bounds/quadratic_form.hpp"

#include <algorithm>
#include <cmath>

namespace treeline::bounds {
namespace {

constexpr std::size_t kMostSquares = 12;

QuadraticForm as_it_is(std::uint32_t node) {
  return {{{{0, node}, constant(1), 1}}, 0};
}

}  // namespace

bool QuadraticForm::is_linear() const {
  return std::all_of(terms.begin(), terms.end(),
                     [](const FormTerm& term) { return term.of.is_linear(); });
}

void collect_terms(std::vector<FormTerm>& terms) {
  std::stable_sort(terms.begin(), terms.end(),
                   [](const FormTerm& x, const FormTerm& y) { return x.of < y.of; });
  std::size_t kept = 0;
  for (std::size_t i = 1; i < terms.size(); ++i) {
    if (terms[i].of == terms[kept].of) {
      terms[kept].factor = *bounds::add(terms[kept].factor, terms[i].factor);
      terms[kept].summed += terms[i].summed;
    } else {
      terms[++kept] = terms[i];
    }
  }
  if (!terms.empty()) terms.resize(kept + 1);
}

QuadraticForms::QuadraticForms(const NodeBounds& known)
    : known_(known), forms_(known.graph.nodes().size()), turns_(known.graph.nodes().size()) {}

void QuadraticForms::add(std::uint32_t node) {
  turns_[node] = known_.polynomials[node] ? 0 : find_turn(known_.graph.nodes()[node]);
  forms_[node] = expand(node);
  if (forms_[node].terms.size() > kMostSquares) forms_[node] = as_it_is(node);
}

Angle QuadraticForms::find_turn(const Node& node) const {
  if (node.op == Op::neg) return turns_[node.a];
  if (is_sum(node.op)) {
    return turns_[node.a] == turns_[node.b] ? turns_[node.a] : 0;
  }
  if (node.op != Op::mul) return 0;
  for (const std::uint32_t factor : {node.a, node.b}) {
    const auto& polynomial = known_.polynomials[factor];
    if (polynomial && !polynomial->is_constant()) return polynomial->angle;
  }
  return 0;
}

QuadraticForm QuadraticForms::expand(std::uint32_t node) const {
  const Node& n = known_.graph.nodes()[node];
  if (known_.polynomials[node] || turns_[node] != 0) return as_it_is(node);
  if (n.op == Op::add || n.op == Op::sub || n.op == Op::neg) return sum(node);
  if (n.op != Op::mul) return as_it_is(node);
  return known_.polynomials[n.a] || known_.polynomials[n.b] ? scaled(node) : product_of(node);
}

QuadraticForm QuadraticForms::sum(std::uint32_t node) const {
  const Node& n = known_.graph.nodes()[node];
  QuadraticForm form = forms_[n.a];
  if (n.op == Op::neg) {
    for (FormTerm& term : form.terms) term.factor = -term.factor;
    return form;
  }
  for (FormTerm term : forms_[n.b].terms) {
    if (n.op == Op::sub) term.factor = -term.factor;
    form.terms.push_back(term);
  }
  collect_terms(form.terms);
  form.error += forms_[n.b].error + known_.computed(node);
  return form;
}

/// Form of a constant times a value.
QuadraticForm QuadraticForms::scaled(std::uint32_t node) const {
  const Node& n = known_.graph.nodes()[node];
  const bool first = known_.polynomials[n.a].has_value();
  const std::uint32_t other = first ? n.b : n.a;
  const TrigPolynomial& factor = *known_.polynomials[first ? n.a : n.b];
  QuadraticForm form = forms_[other];
  for (FormTerm& term : form.terms) {
    term.factor = *multiply(term.factor, factor);
    term.summed *= std::abs(factor.c[0]);
  }
  form.error = std::abs(factor.c[0]) * form.error + known_.local_error({node, 1});
  return form;
}

/// Form of x y. With x = X + u e, the computed product is X Y + u (e_X y + X e_Y) plus its own
/// rounding.
QuadraticForm QuadraticForms::product_of(std::uint32_t node) const {
  const Node& n = known_.graph.nodes()[node];
  const QuadraticForm &x = forms_[n.a], &y = forms_[n.b];
  if (!x.is_linear() || !y.is_linear()) return as_it_is(node);
  QuadraticForm form;
  for (const FormTerm& p : x.terms) {
    for (const FormTerm& q : y.terms) {
      form.terms.push_back(
          {product(p.of.b, q.of.b), *multiply(p.factor, q.factor), p.summed * q.summed});
    }
  }
  collect_terms(form.terms);
  form.error = x.error * known_.computed(n.b) +
               y.error * (known_.computed(n.a) + known_.unit * x.error) + known_.computed(node);
  return form;
}

std::optional<QuadraticForm> QuadraticForms::turned(std::uint32_t node, bool linear) const {
  const auto expanded = expand_linear(known_.graph, known_.polynomials, node, turns_[node]);
  if (!expanded) return std::nullopt;
  QuadraticForm form;
  for (const auto* some : {&expanded->turned, &expanded->rest}) {
    for (const LinearTerm& part : *some) {
      const QuadraticForm& of = forms_[part.node];
      if (linear && !of.is_linear()) {
        form.terms.push_back({{0, part.node}, part.factor, part.factor.magnitude()});
        continue;
      }
      for (const FormTerm& term : of.terms) {
        form.terms.push_back(
            {term.of, *multiply(part.factor, term.factor), part.factor.magnitude() * term.summed});
      }
      form.error += part.factor.magnitude() * of.error;
    }
  }
  for (const ExpandedOperation& operation : expanded->operations) {
    form.error += known_.local_error(operation);
  }
  collect_terms(form.terms);
  return form;
}

}  // namespace treeline::bounds
