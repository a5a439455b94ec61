#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <memory_resource>
#include <unordered_map>
#include <utility>

#include "bounds/trig_polynomial.hpp"

namespace treeline::bounds {
namespace {

using Polynomials = std::vector<std::optional<TrigPolynomial>>;

/// A product of something that turns with one angle (any, if the wanted angle is 0), and something
/// that does not.
struct Turned {
  std::uint32_t turn = 0, other = 0;
};
std::optional<Turned> as_turned(const Node& node, const Polynomials& polynomials, Angle angle) {
  if (node.op != Op::mul) return std::nullopt;
  for (const auto& [turn, other] : {std::pair{node.a, node.b}, std::pair{node.b, node.a}}) {
    const auto &by = polynomials[turn], &of = polynomials[other];
    const bool turns = by && !by->is_constant() && (angle == 0 || by->angle == angle);
    if (turns && (!of || (!of->is_constant() && of->angle != by->angle))) {
      return Turned{turn, other};
    }
  }
  return std::nullopt;
}

bool is_sum(const Node& node) {
  return node.op == Op::add || node.op == Op::sub || node.op == Op::neg;
}

class Expansion {
 public:
  Expansion(const Graph& graph, const Polynomials& polynomials, Angle angle)
      : nodes_(graph.nodes()), polynomials_(polynomials), angle_(angle) {}

  /// Whether a term of the sum turns with the angle. Large sums are not searched to the end.
  bool turns(std::uint32_t node) {
    const Found found = search(node);
    visits_ = std::min(visits_ + found.visits, kMostVisits + 1);
    return found.turns && visits_ <= kMostVisits;
  }

  void expand(std::uint32_t node, const TrigPolynomial& factor) {
    const Node& n = nodes_[node];
    if (is_sum(n) && !polynomials_[node] && turns(node)) {
      if (n.op != Op::neg) form.operations.push_back({node, factor.magnitude()});
      expand(n.a, n.op == Op::neg ? -factor : factor);
      if (n.op != Op::neg) expand(n.b, n.op == Op::sub ? -factor : factor);
      return;
    }
    if (const auto turned = as_turned(n, polynomials_, angle_)) {
      if (const auto product = multiply(factor, *polynomials_[turned->turn])) {
        form.operations.push_back({node, factor.magnitude()});
        expand(turned->other, *product);
        return;
      }
    }
    add(node, factor);
  }

  LinearForm form;

 private:
  static constexpr int kMostVisits = 20000;

  /// Result of a search through a sum: whether a term turns, and how many values were visited up to
  /// the first such term.
  struct Found {
    bool turns = false;
    int visits = 1;
  };
  /// Searches the sum below `node`. Sums share terms, so results are remembered.
  Found search(std::uint32_t node) {
    const Node& n = nodes_[node];
    if (as_turned(n, polynomials_, angle_)) return {true, 1};
    if (!is_sum(n)) return {};
    if (const auto known = found_.find(node); known != found_.end()) return known->second;
    Found found = search(n.a);
    if (n.op != Op::neg && !found.turns) {
      const Found second = search(n.b);
      found = {second.turns, found.visits + second.visits};
    }
    found.visits = std::min(found.visits + 1, kMostVisits + 1);
    found_.emplace(node, found);
    return found;
  }

  void add(std::uint32_t node, TrigPolynomial factor) {
    const Node& n = nodes_[node];
    const bool doubled =
        n.op == Op::mul && nodes_[n.a].op == Op::constant && nodes_[n.a].value == 2;
    if (doubled && !factor.is_constant()) {  // exact: 2 b of a symmetric matrix
      for (double& x : factor.c) x *= 2;
      node = n.b;
    }
    (factor.is_constant() ? form.rest : form.turned).push_back({node, factor});
  }

  const std::vector<Node>& nodes_;
  const Polynomials& polynomials_;
  Angle angle_;
  int visits_ = 0;
  std::array<std::byte, 8192> first_memory_;
  std::pmr::monotonic_buffer_resource memory_{first_memory_.data(), first_memory_.size()};
  std::pmr::unordered_map<std::uint32_t, Found> found_{&memory_};
};

bool contains(const std::vector<LinearTerm>& terms, std::uint32_t node) {
  return std::any_of(terms.begin(), terms.end(),
                     [node](const LinearTerm& term) { return term.node == node; });
}

/// Whether the value is a term of some sum of the set.
bool has_term(const std::vector<LinearForm>& forms, std::uint32_t node) {
  return std::any_of(forms.begin(), forms.end(), [node](const LinearForm& form) {
    return contains(form.turned, node) || contains(form.rest, node);
  });
}

}  // namespace

Angle find_turn(const Graph& graph, const Polynomials& polynomials, std::uint32_t node) {
  constexpr std::size_t kMostNodes = 64;
  std::deque<std::uint32_t> next{node};
  for (std::size_t seen = 0; !next.empty() && seen < kMostNodes; ++seen) {
    const Node& n = graph.nodes()[next.front()];
    next.pop_front();
    if (const auto turned = as_turned(n, polynomials, 0)) return polynomials[turned->turn]->angle;
    if (!is_sum(n)) continue;
    next.push_back(n.a);
    if (n.op != Op::neg) next.push_back(n.b);
  }
  return 0;
}

std::optional<LinearForm> expand_linear(const Graph& graph, const Polynomials& polynomials,
                                        std::uint32_t node, Angle angle) {
  Expansion expansion(graph, polynomials, angle);
  if (!expansion.turns(node)) return std::nullopt;
  expansion.expand(node, constant(1));
  return std::move(expansion.form);
}

void split_sums(const Graph& graph, std::vector<LinearForm>& forms) {
  for (LinearForm& form : forms) {
    for (std::size_t i = 0; i < form.turned.size(); ++i) {
      const LinearTerm term = form.turned[i];
      const Node& n = graph.nodes()[term.node];
      const bool is_split =
          (n.op == Op::add || n.op == Op::sub) && (has_term(forms, n.a) || has_term(forms, n.b));
      if (!is_split) continue;
      form.operations.push_back({term.node, term.factor.magnitude()});
      form.turned[i] = {n.a, term.factor};
      form.turned.push_back({n.b, n.op == Op::sub ? -term.factor : term.factor});
    }
  }
}

void gather_turned(std::vector<LinearForm>& forms) {
  const auto is_turned = [&forms](const LinearTerm& rest) {
    return std::any_of(forms.begin(), forms.end(), [&rest](const LinearForm& form) {
      return contains(form.turned, rest.node);
    });
  };
  for (LinearForm& form : forms) {
    const auto kept = std::stable_partition(form.rest.begin(), form.rest.end(),
                                            [&](const LinearTerm& t) { return !is_turned(t); });
    form.turned.insert(form.turned.end(), kept, form.rest.end());
    form.rest.erase(kept, form.rest.end());
  }
}

}  // namespace treeline::bounds
