#include <algorithm>
#include <utility>
#include <vector>

#include "passes/passes.hpp"
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
        is_part_(nodes_.size(), 0),
        last_term_(nodes_.size(), 0),
        sums_(nodes_.size()) {
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      if (uses_[i] > 0 && operation(nodes_[i].op).operands == 2) {
        for (const std::uint32_t operand : {nodes_[i].a, nodes_[i].b}) {
          const bool is_part =
              uses_[operand] == 1 && is_sum(nodes_[operand].op) && is_sum(nodes_[i].op);
          is_part_[operand] = is_part ? 1 : 0;
        }
      }
    }
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
      const bool is_whole = uses_[i] > 0 && is_sum(nodes_[i].op) && is_part_[i] == 0;
      if (is_whole && has_common_factor(i)) sums_[i] = collect_terms(i);
    }
  }

  Expression replace(std::uint32_t node, const Rewriter& rewriter) const {
    return sums_[node].empty() ? rewriter.copy(node) : factored_sum(sums_[node], rewriter);
  }

 private:
  /// Visits the factors of a product, including those of operands that are products without
  /// another use.
  template <class Visit>
  void for_each_factor(std::uint32_t node, Visit& visit) const {
    if (nodes_[node].op == Op::mul && uses_[node] == 1) {
      for_each_factor(nodes_[node].a, visit);
      for_each_factor(nodes_[node].b, visit);
    } else {
      visit(node);
    }
  }

  /// Calls `visit` with the node of each term of a sum, and whether it is subtracted.
  template <class Visit>
  void for_each_term(std::uint32_t node, bool negative, Visit& visit) const {
    for (const auto& [operand, minus] : {std::pair{nodes_[node].a, false},
                                         std::pair{nodes_[node].b, nodes_[node].op == Op::sub}}) {
      if (is_part_[operand] != 0) {
        for_each_term(operand, negative != minus, visit);
      } else {
        visit(operand, negative != minus);
      }
    }
  }

  /// Whether terms of the sum share a factor. Most sums have no such terms.
  bool has_common_factor(std::uint32_t sum) {
    const std::uint32_t first = terms_ + 1;
    bool found = false;
    auto of_term = [&](std::uint32_t factor) {
      std::uint32_t& last = last_term_[factor];
      found = found || (last >= first && last != terms_);
      last = terms_;
    };
    auto of_sum = [&](std::uint32_t term, bool) {
      ++terms_;
      for_each_factor(term, of_term);
    };
    for_each_term(sum, false, of_sum);
    return found;
  }

  [[nodiscard]] std::vector<Term> collect_terms(std::uint32_t sum) const {
    std::vector<Term> terms;
    auto of_term = [&terms](std::uint32_t factor) { terms.back().factors.push_back(factor); };
    auto of_sum = [&](std::uint32_t term, bool negative) {
      terms.push_back({{}, negative});
      for_each_factor(term, of_term);
    };
    for_each_term(sum, false, of_sum);
    return terms;
  }

  const std::vector<Node>& nodes_;
  std::vector<int> uses_;
  Marks is_part_;                         // the node's only user is a sum that it is part of
  std::vector<std::uint32_t> last_term_;  // by node: the last term it was a factor of
  std::uint32_t terms_ = 0;               // that were looked at
  std::vector<std::vector<Term>> sums_;   // by node: the terms, if the node is a sum to factor
};

}  // namespace

Program factor_sums(const Program& program) {
  const Factoring factoring(program);
  return Rewriter(program).run([&](std::uint32_t node, const Rewriter& rewriter) {
    return factoring.replace(node, rewriter);
  });
}

}  // namespace treeline
