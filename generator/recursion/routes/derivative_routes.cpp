#include "recursion/routes/derivative_routes.hpp"

#include <string>
#include <utility>

#include "recursion/methods/forward_dynamics_derivatives.hpp"
#include "recursion/routes/result_parts.hpp"

namespace treeline {
namespace {

/// Each column of the lower triangles with its row, from the last freedom to the first, all results
/// together: what is carried inward is then in use from beginning to end and nothing else is.
std::vector<ResultPlace> order_inward(const Mechanism& mechanism, std::size_t results) {
  const auto nv = static_cast<std::size_t>(mechanism.nv());
  std::vector<ResultPlace> order;
  for (std::size_t i = nv; i-- > 0;) {
    for (std::size_t j = i + 1; j-- > 0;) {
      for (std::size_t k = 0; k < results; ++k) {
        order.push_back({k, i * nv + j});
        order.push_back({k, j * nv + i});
      }
    }
  }
  return order;
}

std::vector<Result> trace_inverse(const Trace& trace) {
  const auto d = inverse_dynamics_derivatives<Expression>(
      trace.tree, trace.X, {trace.qd(), trace.qdd()}, trace.in[Quantity::f_ext]);
  return {matrix_result("dtau_dq", by_displacements(*trace.mechanism), d.dq),
          matrix_result("dtau_dqd", "by qd", d.dqd),
          matrix_result("dtau_dqdd", "by qdd: M", d.dqdd)};
}

std::vector<Result> trace_forward(const Trace& trace, DerivativeRoute route) {
  const auto d = forward_dynamics_derivatives<Expression>(
      trace.tree, trace.X, trace.qd(), trace.tau(), trace.in[Quantity::f_ext], route);
  return {matrix_result("dqdd_dq", by_displacements(*trace.mechanism), d.dq),
          matrix_result("dqdd_dqd", "by qd", d.dqd),
          matrix_result("dqdd_dtau", "by tau: M^-1", d.dtau)};
}

/// Lists which rows L^-T and L^-1 subtract from which, and returns the entries of L that may not be
/// 0, column by column.
std::vector<Expression> list_factors(const DenseMatrix<Expression>& L, ColumnSolve& columns) {
  const std::size_t n = L.rows();
  std::vector<Expression> factors;
  DenseMatrix<std::int16_t> places(n, n);
  const auto add = [](RowSums& sums, std::size_t row, std::int16_t place) {
    sums.entries.insert(sums.entries.end(), {static_cast<std::int16_t>(row), place});
  };
  const auto end = [](RowSums& sums) {
    sums.ends.push_back(static_cast<std::int16_t>(sums.entries.size() / 2));
  };
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = n; k-- > i + 1;) {
      if (L(k, i).is_zero()) continue;
      places(k, i) = static_cast<std::int16_t>(factors.size());
      factors.push_back(L(k, i));
      add(columns.above, k, places(k, i));
    }
    end(columns.above);
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      if (!L(k, i).is_zero()) add(columns.below, i, places(k, i));
    }
    end(columns.below);
  }
  if (factors.empty()) factors.emplace_back(0.0);  // arrays have at least one
  return factors;
}

/// Derivatives of joint forces as straight lines, then the solve.
ColumnSolve solve_forward(const Trace& trace) {
  const auto& f_ext = trace.in[Quantity::f_ext];
  const auto [factor, qdd] =
      solve_motion<Expression>(trace.tree, trace.X, trace.qd(), trace.tau(), f_ext);
  const auto d =
      inverse_dynamics_derivatives<Expression>(trace.tree, trace.X, {trace.qd(), qdd}, f_ext);
  const auto argument = [&](const char* name, const std::string& meaning) {
    return Argument{name, trace.tree.nv, trace.tree.nv, meaning};
  };
  ColumnSolve columns;
  columns.velocities = trace.tree.nv;
  columns.results = {argument("dqdd_dq", by_displacements(*trace.mechanism)),
                     argument("dqdd_dqd", "by qd"), argument("dqdd_dtau", "by tau: M^-1")};
  columns.lines.results = {{columns.results[0], (-d.dq).values()},
                           {columns.results[1], (-d.dqd).values()},
                           vector_result(kColumnFactors, "", list_factors(factor.L, columns)),
                           vector_result(kColumnPivots, "", factor.inverse_D)};
  return columns;
}

std::vector<Route> list_line_routes(const RouteQuery& query) {
  if (query.function == Function::inverse_dynamics_derivatives) {
    Route route{{"unit-changes", "unit changes of motion and of wrenches carried inward", "own",
                 "in link axes"},
                trace_inverse};
    route.order = order_inward;
    return {route};
  }
  return {{{"ltdl", "-M^-1 times those of inverse dynamics, M = L^T D L, sparse solves"},
           [](const Trace& trace) { return trace_forward(trace, DerivativeRoute::solve); }},
          {{"inverse", "-M^-1 times those of inverse dynamics, M^-1 by L^T D L"},
           [](const Trace& trace) { return trace_forward(trace, DerivativeRoute::multiply); }}};
}

/// The route that solves for all columns together, whose rows are computed in lanes.
Route column_route() {
  Route route{
      {"columns", "-M^-1 times those of inverse dynamics, M = L^T D L, all columns together"}, {}};
  route.columns = solve_forward;
  return route;
}

}  // namespace

std::vector<Route> derivative_routes(const RouteQuery& query) {
  std::vector<Route> routes = list_line_routes(query);
  const bool forward = query.function == Function::forward_dynamics_derivatives;
  if (forward && query.lanes > 1) routes.push_back(column_route());
  return routes;
}

}  // namespace treeline
