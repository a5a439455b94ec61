#include "recursion/routes/trace_derivatives.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "recursion/methods/forward_dynamics_derivatives.hpp"
#include "recursion/routes/trace_parts.hpp"
#include "recursion/tree/deferred_rotations.hpp"

namespace treeline {
namespace {

constexpr int kMostLanes = 4;  // three values go together

/// Each column of the lower triangles with its row, from the last freedom to the first, all results
/// together: what is carried inward is then in use from beginning to end and nothing else is.
std::vector<ResultPlace> order_inward(std::size_t nv, std::size_t results) {
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

Program trace_inverse(const Mechanism& mechanism, Program program) {
  const Graph::Scope scope(program.graph);
  program.route = {"unit-changes", "unit changes of motion and of wrenches carried inward", "own",
                   "in link axes"};
  const TracedInputs in(mechanism, Function::inverse_dynamics_derivatives, program);
  auto tree = constant_tree<Expression>(mechanism);
  apply_inputs(mechanism, in, tree);
  auto X = joint_transforms<Expression>(tree, in[Quantity::q]);
  defer_rotations(tree, X);
  const auto d = inverse_dynamics_derivatives<Expression>(
      tree, X, {in[Quantity::qd], in[Quantity::qdd]}, in[Quantity::f_ext]);
  program.results = {matrix_result("dtau_dq", by_displacements(mechanism), d.dq),
                     matrix_result("dtau_dqd", "by qd", d.dqd),
                     matrix_result("dtau_dqdd", "by qdd: M", d.dqdd)};
  program.order = order_inward(static_cast<std::size_t>(mechanism.nv()), program.results.size());
  return program;
}

Program trace_forward(const Mechanism& mechanism, Program program, DerivativeRoute route) {
  const Graph::Scope scope(program.graph);
  if (route == DerivativeRoute::solve) {
    program.route = {"ltdl", "-M^-1 times those of inverse dynamics, M = L^T D L, sparse solves"};
  } else {
    program.route = {"inverse", "-M^-1 times those of inverse dynamics, M^-1 by L^T D L"};
  }
  const TracedInputs in(mechanism, Function::forward_dynamics_derivatives, program);
  auto tree = constant_tree<Expression>(mechanism);
  apply_inputs(mechanism, in, tree);
  auto X = joint_transforms<Expression>(tree, in[Quantity::q]);
  defer_rotations(tree, X);
  const auto d = forward_dynamics_derivatives<Expression>(
      tree, X, in[Quantity::qd], in[Quantity::tau], in[Quantity::f_ext], route);
  program.results = {matrix_result("dqdd_dq", by_displacements(mechanism), d.dq),
                     matrix_result("dqdd_dqd", "by qd", d.dqd),
                     matrix_result("dqdd_dtau", "by tau: M^-1", d.dtau)};
  return program;
}

}  // namespace

std::vector<Program> trace_derivative_function(const Mechanism& mechanism, Function function,
                                               int lanes) {
  Program empty;
  empty.name = function_name(function);
  empty.equation = info_of(function).equation;
  empty.graph = Graph::for_trace(std::min(lanes, kMostLanes));
  if (function == Function::inverse_dynamics_derivatives) {
    return {trace_inverse(mechanism, std::move(empty))};
  }
  return {trace_forward(mechanism, empty, DerivativeRoute::solve),
          trace_forward(mechanism, empty, DerivativeRoute::multiply)};
}

}  // namespace treeline
