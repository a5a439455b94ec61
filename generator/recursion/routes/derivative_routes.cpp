#include "recursion/routes/derivative_routes.hpp"

#include <string>
#include <utility>

#include "core/in_eights.hpp"
#include "recursion/methods/forward_dynamics_derivatives.hpp"
#include "recursion/routes/common_frame.hpp"
#include "recursion/routes/list_row_sums.hpp"
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

/// Returns the entries of L that may not be 0, column by column, and lists them for the solve.
std::vector<Expression> list_factors(const DenseMatrix<Expression>& L, Ending& ending) {
  const int n = ending.velocities;
  std::vector<Expression> factors;
  DenseMatrix<int> places(L.rows(), L.rows());
  const auto entry = [](auto& matrix, int k, int i) -> decltype(auto) {
    return matrix(static_cast<std::size_t>(k), static_cast<std::size_t>(i));
  };
  for (int i = 0; i < n; ++i) {
    for (int k = n; k-- > i + 1;) {
      entry(places, k, i) = entry(L, k, i).is_zero() ? -1 : static_cast<int>(factors.size());
      if (entry(places, k, i) >= 0) factors.push_back(entry(L, k, i));
    }
  }
  if (factors.empty()) factors.emplace_back(0.0);  // arrays have at least one
  list_row_sums([&](int k, int i) { return entry(places, k, i); }, ending);
  return factors;
}

/// Derivatives of joint forces as straight lines, then the solve.
Ending solve_forward(const Trace& trace) {
  const auto& f_ext = trace.in[Quantity::f_ext];
  const auto [factor, qdd] =
      solve_motion<Expression>(trace.tree, trace.X, trace.qd(), trace.tau(), f_ext);
  const auto d =
      inverse_dynamics_derivatives<Expression>(trace.tree, trace.X, {trace.qd(), qdd}, f_ext);
  const auto argument = [&](const char* name, const std::string& meaning) {
    return Argument{name, trace.tree.nv, trace.tree.nv, meaning};
  };
  Ending ending;
  ending.routine = Routine::solve_columns;
  ending.velocities = trace.tree.nv;
  ending.work = static_cast<std::size_t>(trace.tree.nv * core::column_stride(trace.tree.nv));
  ending.results = {argument("dqdd_dq", by_displacements(*trace.mechanism)),
                    argument("dqdd_dqd", "by qd"), argument("dqdd_dtau", "by tau: M^-1")};
  ending.lines.results = {{ending.results[0], (-d.dq).values()},
                          {ending.results[1], (-d.dqd).values()},
                          vector_result("L", "", list_factors(factor.L, ending)),
                          vector_result("inverse_D", "", factor.inverse_D)};
  return ending;
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
  route.ending = solve_forward;
  return route;
}

/// The route in one common frame, where joints stand side by side.
Route common_frame_route(bool forward) {
  Route route{
      {"common-frame", "changes of motion and wrenches in the base's frame, joints side by side"},
      {}};
  if (forward) route.id.algorithm_words += "; M = L^T D L, all columns together";
  route.ending = forward ? end_with_acceleration_derivatives : end_with_force_derivatives;
  route.keeps_inertias = true;
  return route;
}

}  // namespace

std::vector<Route> derivative_routes(const RouteQuery& query) {
  std::vector<Route> routes = list_line_routes(query);
  const bool forward = query.function == Function::forward_dynamics_derivatives;
  if (query.lanes == 1) return routes;
  if (forward) routes.push_back(column_route());
  if (suits_common_frame(query.tree) && query.mechanism.external_forces.empty()) {
    routes.push_back(common_frame_route(forward));
  }
  return routes;
}

}  // namespace treeline
