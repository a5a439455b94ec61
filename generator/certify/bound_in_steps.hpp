#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "bounds/domain.hpp"
#include "certify/ask_gappa.hpp"
#include "certify/unit_pairs.hpp"

namespace treeline {

/// Thrown where a proof ends: Gappa does not prove a step, or the time is over.
struct ProofEnded : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Proven bounds of a node: of its exact value, its error, and the rounding of its own operation.
struct NodeBound {
  GappaNumber size, error, rounding;
};

/// Kind of values in a set: exact values of nodes, or their errors.
enum class Values { exact, errors };

/// Bounds the exact value and the error of every node of a graph, node by node, in small steps that
/// Gappa proves. Nothing of this class has to be believed but that a hypothesis is an assumption or
/// the goal of an earlier step, and that goals are about the nodes that they name.
///
/// A node is bounded by its operands. In addition, sums that turn a vector are bounded by its norm:
/// of the rows P x + Q y and Q x - P y with P^2 + Q^2 = 1 the squares add up to x^2 + y^2, a row
/// alone has a square of at most that. What is added to a row counts by |v + t| <= |v| + |t| for
/// vectors. This is done for exact values, and for errors, of which what is added are roundings.
class StepBounds {
 public:
  using Clock = std::chrono::steady_clock;

  StepBounds(const Program& program, const Domain& domain, const Gappa& gappa,
             Clock::time_point end);

  /// Bounds all nodes that results need. Throws ProofEnded.
  void prove();
  [[nodiscard]] const NodeBound& of(std::uint32_t node) const { return bounds_[node]; }
  [[nodiscard]] const std::vector<ProofStep>& steps() const { return steps_; }

 private:
  friend class TurnedSet;
  using Rows = std::vector<LinearRow>;

  void prove_unit(const UnitPair& pair);
  void bound_node(std::uint32_t node);
  void bound_operation(std::uint32_t node);
  void bound_sine(std::uint32_t node);
  void bound_turned_product(std::uint32_t node);
  /// Bound of the sum of the rows' squares.
  GappaNumber bound_squares(const Rows& rows, Values values);
  GappaNumber bound_squares_alone(const Rows& rows, Values values);
  /// Bound of the row's magnitude, from its square.
  GappaNumber bound_by_square(const LinearRow& row, Values values);
  GappaNumber prove_root(const std::string& of, const GappaNumber& square);
  /// Lets Gappa bound one expression.
  GappaNumber bound(std::string meaning, std::vector<std::string> hypotheses,
                    std::string expression, std::vector<std::string> rewritings = {});
  void solve(ProofStep& step);

  [[nodiscard]] std::string exact(std::uint32_t node) const;
  [[nodiscard]] std::string computed(std::uint32_t node) const;
  [[nodiscard]] std::string print(const LinearRow& row, Values values) const;
  [[nodiscard]] std::string print_squares(const Rows& rows, Values values) const;
  [[nodiscard]] bool is_exact(std::uint32_t node) const { return bounds_[node].error.value == 0; }
  [[nodiscard]] LinearRow keep_inexact(LinearRow row, Values values) const;
  void add_size(std::uint32_t node, std::vector<std::string>& hypotheses) const;
  void add_error(std::uint32_t node, std::vector<std::string>& hypotheses) const;
  void add_values(const LinearRow& row, Values values, std::vector<std::string>& hypotheses) const;

  const Program& program_;
  const std::vector<Node>& nodes_;
  const Domain& domain_;
  const Gappa& gappa_;
  Clock::time_point end_;
  UnitPairs pairs_;
  std::vector<NodeBound> bounds_;
  std::vector<ProofStep> steps_;
  std::map<std::pair<Values, Rows>, GappaNumber> squares_;
};

}  // namespace treeline
