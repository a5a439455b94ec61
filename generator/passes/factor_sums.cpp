#include "passes/factor_sums.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "passes/rebuild.hpp"
#include "passes/rewriter.hpp"

namespace treeline {
namespace {

/// Signed product of nodes. Without factors it is 1.
struct Term {
  std::vector<std::uint32_t> factors;
  bool negative = false;
};

bool has_factor(const Term& term, std::uint32_t factor) {
  return std::find(term.factors.begin(), term.factors.end(), factor) != term.factors.end();
}

/// Finds the factor that most terms share (the first of several) and the number of these terms.
std::pair<std::uint32_t, std::ptrdiff_t> find_common_factor(const std::vector<Term>& terms) {
  std::pair<std::uint32_t, std::ptrdiff_t> best{0, 1};
  for (const Term& term : terms) {
    for (const std::uint32_t factor : term.factors) {
      const auto count = std::count_if(terms.begin(), terms.end(),
                                       [&](const Term& t) { return has_factor(t, factor); });
      if (count > best.second) {
        best = {factor, count};
      }
    }
  }
  return best;
}

Expression product_of(const Term& term, const Rewriter& rewriter) {
  Expression product(1);
  for (const std::uint32_t factor : term.factors) {
    product *= rewriter.value(factor);
  }
  return term.negative ? -product : product;
}

/// Builds the sum of the terms with common factors taken out.
Expression factored_sum(std::vector<Term> terms, const Rewriter& rewriter) {
  const auto [factor, count] = find_common_factor(terms);
  if (count < 2) {
    Expression sum;
    for (const Term& term : terms) {
      sum += product_of(term, rewriter);
    }
    return sum;
  }
  std::vector<Term> with;
  std::vector<Term> without;
  for (Term& term : terms) {
    if (has_factor(term, factor)) {
      term.factors.erase(std::find(term.factors.begin(), term.factors.end(), factor));
      with.push_back(std::move(term));
    } else {
      without.push_back(std::move(term));
    }
  }
  const Expression product = factored_sum(std::move(with), rewriter) * rewriter.value(factor);
  return without.empty() ? product : factored_sum(std::move(without), rewriter) + product;
}

/// Finds the sums that have a common factor. Every other node is copied as it is.
class Factoring {
 public:
  explicit Factoring(const Program& program)
      : nodes_(program.graph.nodes()),
        uses_(count_uses(program)),
        is_part_(nodes_.size(), false),
        sums_(nodes_.size()) {
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (uses_[i] > 0 && operation(nodes_[i].op).operands == 2) {
        for (const std::uint32_t operand : {nodes_[i].a, nodes_[i].b}) {
          is_part_[operand] =
              uses_[operand] == 1 && is_sum(nodes_[operand].op) && is_sum(nodes_[i].op);
        }
      }
    }
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (uses_[i] > 0 && is_sum(nodes_[i].op) && !is_part_[i]) {
        collect_terms(i, false, sums_[i]);
        if (find_common_factor(sums_[i]).second < 2) {
          sums_[i].clear();
        }
      }
    }
  }

  Expression replace(std::uint32_t node, const Rewriter& rewriter) const {
    return sums_[node].empty() ? rewriter.copy(node) : factored_sum(sums_[node], rewriter);
  }

 private:
  /// Collects the factors of a product, including those of operands that are products without
  /// another use.
  void collect_factors(std::uint32_t node, Term& term) const {
    if (nodes_[node].op == Op::mul && uses_[node] == 1) {
      collect_factors(nodes_[node].a, term);
      collect_factors(nodes_[node].b, term);
    } else {
      term.factors.push_back(node);
    }
  }

  void collect_terms(std::uint32_t node, bool negative, std::vector<Term>& terms) const {
    for (const auto& [operand, minus] : {std::pair{nodes_[node].a, false},
                                         std::pair{nodes_[node].b, nodes_[node].op == Op::sub}}) {
      if (is_part_[operand]) {
        collect_terms(operand, negative != minus, terms);
      } else {
        terms.push_back({{}, negative != minus});
        collect_factors(operand, terms.back());
      }
    }
  }

  const std::vector<Node>& nodes_;
  std::vector<int> uses_;
  std::vector<bool> is_part_;            // the node's only user is a sum that it is part of
  std::vector<std::vector<Term>> sums_;  // by node: the terms, if the node is a sum to factor
};

}  // namespace

Program factor_sums(const Program& program) {
  const Factoring factoring(program);
  return Rewriter(program).run([&](std::uint32_t node, const Rewriter& rewriter) {
    return factoring.replace(node, rewriter);
  });
}

}  // namespace treeline
