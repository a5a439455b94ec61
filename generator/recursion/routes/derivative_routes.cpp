#include <algorithm>
#include <string>
#include <utility>

#include "recursion/methods/forward_dynamics_derivatives.hpp"
#include "recursion/methods/kinetic_energy_derivatives.hpp"
#include "recursion/methods/point_motion_derivatives.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/routes_of_groups.hpp"
#include "recursion/routes/tree_paths.hpp"

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

/// L as the solve has it: rows of what carries each freedom.
std::vector<Expression> list_factors(const DenseMatrix<Expression>& L, const TreePaths& paths) {
  std::vector<Expression> factors;
  for (std::size_t k = 0; k < L.rows(); ++k) {
    for (const int i : paths.path_of(static_cast<int>(k))) {
      factors.push_back(L(k, static_cast<std::size_t>(i)));
    }
    factors.resize((k + 1) * static_cast<std::size_t>(paths.row_length()), Expression(0.0));
  }
  return factors;
}

/// Columns of two matrices as the solve has them: strips of eight of each.
std::vector<Expression> list_strips(const DenseMatrix<Expression>& A,
                                    const DenseMatrix<Expression>& B) {
  std::vector<Expression> strips;
  for (std::size_t column = 0; column < A.cols(); column += 8) {
    for (std::size_t i = 0; i < A.rows(); ++i) {
      const std::size_t begin = strips.size();
      strips.resize(begin + 24, Expression(0.0));
      for (std::size_t j = column; j < std::min(column + 8, A.cols()); ++j) {
        strips[begin + j - column] = A(i, j);
        strips[begin + 8 + j - column] = B(i, j);
      }
    }
  }
  return strips;
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
  const auto is_there = [](const DenseMatrix<Expression>& matrix, int i, int j) {
    return !matrix(static_cast<std::size_t>(i), static_cast<std::size_t>(j)).is_zero();
  };
  const TreePaths paths(trace.tree.nv,
                        [&, &L = factor.L](int k, int i) { return is_there(L, k, i); });
  Ending ending;
  ending.routine = Routine::solve_columns;
  ending.velocities = trace.tree.nv;
  ending.path = paths.row_length();
  ending.work = static_cast<std::size_t>(24 * ending.path);
  ending.results = {argument("dqdd_dq", by_displacements(*trace.mechanism)),
                    argument("dqdd_dqd", "by qd"), argument("dqdd_dtau", "by tau: M^-1")};
  paths.append_to(ending.tables,
                  [&](int i, int j) { return is_there(d.dq, i, j) || is_there(d.dqd, i, j); });
  ending.lines.results = {vector_result("L", "", list_factors(factor.L, paths)),
                          vector_result("inverse_D", "", factor.inverse_D),
                          vector_result("X", "", list_strips(-d.dq, -d.dqd))};
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

std::vector<Route> kinetic_energy_derivative_routes() {
  return {{{"carried-momentum", "momentum of what each joint carries"}, [](const Trace& trace) {
             const auto d =
                 kinetic_energy_derivatives<Expression>(trace.tree, trace.X, {trace.qd(), {}});
             return std::vector<Result>{
                 vector_result("dT_dq", by_displacements(*trace.mechanism), d.dq),
                 vector_result("dT_dqd", "by qd: M qd", d.dqd)};
           }}};
}

std::vector<Route> point_velocity_derivative_routes() {
  return {
      {{"inward", "inward from each point, as carriers see it"}, [](const Trace& trace) {
         const auto d = point_motion_derivatives<Expression>(trace.tree, trace.X, {trace.qd(), {}});
         return std::vector<Result>{
             matrix_result("dv_dq", by_displacements(*trace.mechanism), d.dv_dq),
             matrix_result("dv_dqd", "by qd: six rows of J a point", d.J)};
       }}};
}

std::vector<Route> point_acceleration_derivative_routes() {
  return {{{"inward", "inward from each point, as carriers see it"}, [](const Trace& trace) {
             const auto d = point_motion_derivatives<Expression>(trace.tree, trace.X,
                                                                 {trace.qd(), trace.qdd()});
             return std::vector<Result>{
                 matrix_result("da_dq", by_displacements(*trace.mechanism), d.da_dq),
                 matrix_result("da_dqd", "by qd", d.da_dqd),
                 matrix_result("da_dqdd", "by qdd: six rows of J a point", d.J)};
           }}};
}

}  // namespace treeline
