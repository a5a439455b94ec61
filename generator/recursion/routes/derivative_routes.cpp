#include "recursion/routes/derivative_routes.hpp"

#include <string>

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

}  // namespace

std::vector<Route> derivative_routes(const RouteQuery& query) {
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

}  // namespace treeline
