#include "recursion/methods/order_pivots.hpp"

#include <algorithm>
#include <cmath>

#include "recursion/methods/resolved_by_pivots.hpp"
#include "recursion/tree/deferred_rotations.hpp"

namespace treeline {
namespace {

/// Three equations on their way to being solved.
class Ordering {
 public:
  explicit Ordering(DenseMatrix<Expression> A) : A_(std::move(A)) {}

  /// Appends three pivots; false where none can be had.
  bool append_to(PivotOrder& order) {
    for (int k = 0; k < 3; ++k) {
      const auto pivot = next();
      if (!pivot) return false;
      order.order.push_back(*pivot);
      order.constant.push_back(A_(pivot->row, pivot->column).is_constant());
      take(*pivot);
    }
    return true;
  }

 private:
  [[nodiscard]] std::optional<Pivot> next() const {
    std::optional<Pivot> best;
    double largest = 0;
    for (const std::size_t r : rows_) {
      for (const std::size_t c : columns_) {
        const Expression entry = A_(r, c);
        if (entry.is_zero()) continue;
        if (in_row(r) == 1 || in_column(c) == 1) return Pivot{r, c};
        if (!entry.is_constant() || std::abs(entry.constant()) <= largest) continue;
        largest = std::abs(entry.constant());
        best = Pivot{r, c};
      }
    }
    return best;
  }

  [[nodiscard]] std::ptrdiff_t in_row(std::size_t r) const {
    return std::count_if(columns_.begin(), columns_.end(),
                         [&](std::size_t c) { return !A_(r, c).is_zero(); });
  }
  [[nodiscard]] std::ptrdiff_t in_column(std::size_t c) const {
    return std::count_if(rows_.begin(), rows_.end(),
                         [&](std::size_t r) { return !A_(r, c).is_zero(); });
  }

  void take(const Pivot& pivot) {
    std::erase(rows_, pivot.row);
    std::erase(columns_, pivot.column);
    for (const std::size_t r : rows_) {
      const Expression factor = A_(r, pivot.column) / A_(pivot.row, pivot.column);
      for (const std::size_t c : columns_) A_(r, c) -= factor * A_(pivot.row, c);
    }
  }

  DenseMatrix<Expression> A_;
  std::vector<std::size_t> rows_{0, 1, 2}, columns_{0, 1, 2};
};

/// Traces the wrist's Jacobian into a temporary graph, which must be open.
DenseMatrix<Expression> trace_jacobian(const Mechanism& mechanism, Graph& graph, int axes_link) {
  auto tree = tree_of<Expression>(mechanism);
  std::vector<Expression> q;
  for (int i = 0; i < mechanism.nq(); ++i) q.push_back(graph.input("q[" + std::to_string(i) + "]"));
  auto X = joint_transforms<Expression>(tree, q);
  defer_rotations(tree, X);
  return wrist_jacobian(tree, X, axes_link);
}

}  // namespace

std::optional<PivotOrder> order_wrist_pivots(const Mechanism& mechanism) {
  for (const int axes_link : {4, 3}) {
    Graph graph;
    const Graph::Scope scope(graph);
    PivotOrder order;
    order.axes_link = axes_link;
    Ordering wrist(block_of(trace_jacobian(mechanism, graph, axes_link), 3, 3));
    if (wrist.append_to(order)) return order;
  }
  return std::nullopt;
}

std::optional<std::size_t> find_lone_row(const Mechanism& mechanism, int axes_link) {
  const bool parallel = mechanism.links[1].turns_by_angle() && mechanism.links[2].turns_by_angle();
  if (!parallel) return std::nullopt;
  Graph graph;
  const Graph::Scope scope(graph);
  const auto J = trace_jacobian(mechanism, graph, axes_link);
  for (std::size_t row = 0; row < 3; ++row) {
    if (!J(row, 0).is_zero() && J(row, 1).is_zero() && J(row, 2).is_zero()) return row;
  }
  return std::nullopt;
}

}  // namespace treeline
