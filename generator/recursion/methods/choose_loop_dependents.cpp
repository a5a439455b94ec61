#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "recursion/algebra/factor_ldlt.hpp"
#include "recursion/algebra/orthogonal_columns.hpp"
#include "recursion/methods/choose_dependents.hpp"
#include "recursion/methods/lambda_inverse.hpp"
#include "recursion/methods/loop_rows.hpp"
#include "recursion/methods/ordinary_states.hpp"

namespace treeline {
namespace {

constexpr int kClosings = 127;     ///< states from which a closed pose is looked for
constexpr int kFewestClosed = 31;  ///< closed poses that say enough
constexpr int kMostSteps = 40;     ///< of Newton's method
constexpr double kClosed = 1e-9;   ///< m, and the sine of an angle
constexpr double kLongestStep = 0.5;
/// Least pivot in closed poses, beside its median: a quarter of the usual distance from poses where
/// passive joints do not follow, so that at most a digit is lost.
constexpr double kFollows = 0x1p-4;

using Columns = std::vector<std::size_t>;

DenseMatrix<double> chosen_block(const DenseMatrix<double>& J, const Columns& rows,
                                 const Columns& columns) {
  DenseMatrix<double> block(rows.size(), columns.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) block(i, j) = J(rows[i], columns[j]);
  }
  return block;
}

/// J J^T.
DenseMatrix<double> square_of_rows(const DenseMatrix<double>& J) {
  DenseMatrix<double> A(J.rows(), J.rows());
  for (std::size_t i = 0; i < J.rows(); ++i) {
    for (std::size_t j = 0; j < J.rows(); ++j) {
      for (std::size_t v = 0; v < J.cols(); ++v) A(i, j) += J(i, v) * J(j, v);
    }
  }
  return A;
}

/// J in ordinary states, and the rows of it that do not depend on rows before them.
struct OrdinaryRows {
  std::vector<DenseMatrix<double>> J;
  Columns rows;
};

OrdinaryRows find_ordinary_rows(const Mechanism& mechanism) {
  OrdinaryRows found;
  OrdinaryPivots pivots;
  const auto constants = unposed<double>(mechanism, LawPoints::operational);
  for (int state = 0; state < kOrdinaryStates; ++state) {
    const auto posed = pose(constants, LawPoints::operational, ordinary_state(mechanism, state));
    found.J.push_back(loop_jacobian(posed.tree, posed.X));
    pivots.add(lambda_inverse_by_factors(posed.tree, posed.X, found.J.back()));
  }
  for (std::size_t r = 0; r < pivots.rows(); ++r) {
    if (!pivots.is_dependent(r)) found.rows.push_back(r);
  }
  return found;
}

/// The rows that velocity `v` moves in some state.
Columns rows_moved(const OrdinaryRows& ordinary, std::size_t v) {
  Columns moved;
  for (const std::size_t r : ordinary.rows) {
    const bool moves = std::any_of(ordinary.J.begin(), ordinary.J.end(),
                                   [&](const auto& J) { return J(r, v) != 0; });
    if (moves) moved.push_back(r);
  }
  return moved;
}

/// Passive velocities that move rows, those that share them with the fewest others first.
Columns passive_in_loops(const Mechanism& mechanism, const OrdinaryRows& ordinary) {
  std::vector<std::pair<Columns, std::size_t>> moving;
  for (const int v : mechanism.passive) {
    Columns rows = rows_moved(ordinary, static_cast<std::size_t>(v));
    if (!rows.empty()) moving.emplace_back(std::move(rows), static_cast<std::size_t>(v));
  }
  const auto shares = [](const Columns& a, const Columns& b) {
    return std::any_of(a.begin(), a.end(), [&](std::size_t row) {
      return std::find(b.begin(), b.end(), row) != b.end();
    });
  };
  std::vector<std::pair<std::ptrdiff_t, std::size_t>> order;
  for (const auto& [rows, v] : moving) {
    const auto others =
        std::count_if(moving.begin(), moving.end(),
                      [&, own = &rows](const auto& other) { return shares(*own, other.first); });
    order.emplace_back(others, v);
  }
  std::sort(order.begin(), order.end());
  Columns velocities;
  for (const auto& each : order) velocities.push_back(each.second);
  return velocities;
}

OrdinaryPivots pivots_of(const OrdinaryRows& ordinary, const Columns& dependent) {
  OrdinaryPivots pivots;
  for (const DenseMatrix<double>& J : ordinary.J) {
    const DenseMatrix<double> J_D = chosen_block(J, ordinary.rows, dependent);
    DenseMatrix<double> columns(J_D.cols(), J_D.rows());
    for (std::size_t i = 0; i < J_D.rows(); ++i) {
      for (std::size_t j = 0; j < J_D.cols(); ++j) columns(j, i) = J_D(i, j);
    }
    pivots.add(square_of_rows(columns));
  }
  return pivots;
}

/// Finds closed poses of a robot whose coordinates are all angles and displacements.
class LoopCloser {
 public:
  explicit LoopCloser(const Mechanism& mechanism)
      : mechanism_(mechanism),
        constants_(unposed<double>(mechanism, LawPoints::operational)),
        rest_(static_cast<std::size_t>(mechanism.nv()), 0),
        coordinates_(rest_.size()) {
    for (const MovingLink& link : mechanism.links) {
      coordinates_[static_cast<std::size_t>(link.v_index)] = static_cast<std::size_t>(link.q_index);
    }
  }

  /// J in the closed pose that Newton's method leads to; nothing if that is none, or beyond limits.
  [[nodiscard]] std::optional<DenseMatrix<double>> jacobian_from(std::vector<double> q) const {
    for (int step = 0; step < kMostSteps; ++step) {
      const auto posed = pose(constants_, LawPoints::operational, q);
      const auto rows = loop_rows<double>(posed.tree, posed.X, q, rest_);
      if (std::all_of(rows.errors.begin(), rows.errors.end(),
                      [](double error) { return std::abs(error) < kClosed; })) {
        if (!is_within_limits(q)) return std::nullopt;
        return rows.J;
      }
      move_towards(rows, q);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool is_within_limits(const std::vector<double>& q) const {
    for (std::size_t i = 0; i < q.size(); ++i) {
      const Coordinate& coordinate = mechanism_.coordinates[i];
      if (!(q[i] >= coordinate.lower && q[i] <= coordinate.upper)) return false;
    }
    return true;
  }

  /// The shortest step that closes the rows as far as they are linear, or a part of it.
  void move_towards(const LoopRows<double>& rows, std::vector<double>& q) const {
    const DenseMatrix<double> A = square_of_rows(rows.J);
    const auto factor = factor_ldlt(
        A, [&](std::size_t k, double c) { return c > kDependent * A(k, k) ? 1 / c : 0; });
    const auto y = solve(factor, rows.errors);
    std::vector<double> change(rest_.size(), 0);
    double length = 0;
    for (std::size_t v = 0; v < change.size(); ++v) {
      for (std::size_t i = 0; i < y.size(); ++i) change[v] -= rows.J(i, v) * y[i];
      length = std::max(length, std::abs(change[v]));
    }
    const double part = std::min(1.0, kLongestStep / length);
    for (std::size_t v = 0; v < change.size(); ++v) q[coordinates_[v]] += part * change[v];
  }

  const Mechanism& mechanism_;
  Posed<double> constants_;
  std::vector<double> rest_;
  Columns coordinates_;  ///< of each velocity
};

/// Whether what is left of each column of J_D stays near its median in closed poses. Not where
/// there are quaternions, which Newton's method here does not move.
bool follows_where_closed(const Mechanism& mechanism, const LoopedVelocities& looped) {
  if (mechanism.nq() != mechanism.nv()) return false;
  const LoopCloser closer(mechanism);
  std::vector<std::vector<double>> pivots(looped.dependent.size());
  for (int state = 0; state < kClosings; ++state) {
    const auto J = closer.jacobian_from(ordinary_state(mechanism, state));
    if (!J) continue;
    const OrthogonalColumns<double> eliminated(chosen_block(*J, looped.rows, looped.dependent),
                                               [&](std::size_t k, double square) {
                                                 pivots[k].push_back(square);
                                                 return 1 / square;
                                               });
  }
  return std::all_of(pivots.begin(), pivots.end(), [](const std::vector<double>& each) {
    if (each.size() < static_cast<std::size_t>(kFewestClosed)) return false;
    const double least = kFollows * median(each);
    return std::all_of(each.begin(), each.end(), [&](double square) { return square >= least; });
  });
}

/// Property of the mechanism that prevents the elimination of loops.
std::string obstacle_of(const Mechanism& mechanism) {
  if (!mechanism.constraints.empty()) return "Constraints to the world are held by forces alone.";
  for (const MechanismLoop& loop : mechanism.loops) {
    if (loop.rolling) return "Contacts that roll are held by forces alone.";
  }
  return mechanism.loops.empty() ? "There are no loops." : "";
}

}  // namespace

LoopDependents choose_loop_dependents(const Mechanism& mechanism) {
  if (std::string obstacle = obstacle_of(mechanism); !obstacle.empty()) {
    return {std::nullopt, std::move(obstacle)};
  }
  const OrdinaryRows ordinary = find_ordinary_rows(mechanism);
  LoopedVelocities looped;
  looped.rows = ordinary.rows;
  looped.dependent = passive_in_loops(mechanism, ordinary);
  const std::size_t asked = looped.rows.size(), passive = looped.dependent.size();
  if (passive != asked) {
    return {std::nullopt,
            fmt::format("Name under `passive` the joints that the loops determine: they hold {} "
                        "velocities, and {} of passive joints move{} them.",
                        asked, passive, passive == 1 ? "s" : "")};
  }
  const OrdinaryPivots pivots = pivots_of(ordinary, looped.dependent);
  if (pivots.has_dependent()) {
    return {std::nullopt,
            "Name others under `passive`: the loops do not determine those from the other joints."};
  }
  const BoundedInverseShape shape = inverse_inertia_shape(mechanism.real);
  looped.rule = {shape.power, pivots.borders(shape)};
  for (std::size_t v = 0; v < static_cast<std::size_t>(mechanism.nv()); ++v) {
    if (std::count(looped.dependent.begin(), looped.dependent.end(), v) == 0) {
      looped.independent.push_back(v);
    }
  }
  looped.follows = follows_where_closed(mechanism, looped);
  return {std::move(looped), {}};
}

}  // namespace treeline
