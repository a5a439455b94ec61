#include "recursion/routes/constraint_routes.hpp"

#include <memory>
#include <string>
#include <utility>

#include "recursion/methods/eliminated_forward_dynamics.hpp"
#include "recursion/methods/operational_quantities.hpp"
#include "recursion/methods/supported_control_torque.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/describe_choice.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/tree/supported_mechanism.hpp"

namespace treeline {
namespace {

ConstrainedInputs<Expression> motion_inputs(const Trace& trace) {
  return {trace.q(),
          trace.qd(),
          trace.tau(),
          trace.in[Quantity::stabilisation],
          trace.in[Quantity::drift],
          trace.applied()};
}

std::vector<Result> motion_results(const ConstrainedMotion<Expression>& motion) {
  return {vector_result("qdd", "joint accelerations", motion.qdd),
          vector_result("f", "forces of the constraints on the robot, in their rows, N, N m",
                        motion.f)};
}

std::vector<Result> trace_constrained_motion(const Trace& trace, const LambdaChoice& choice,
                                             const PivotRule& rule) {
  const auto inputs = motion_inputs(trace);
  return motion_results(has_loops(trace.tree)
                            ? looped_forward_dynamics<Expression>(trace.tree, trace.X, inputs, rule)
                            : constrained_forward_dynamics<Expression>(
                                  trace.tree, trace.X, inputs, choice,
                                  [&](const std::vector<Expression>& forces) {
                                    return accelerate(trace.tree, trace.X, choice.route, forces);
                                  },
                                  rule));
}

std::vector<Result> trace_eliminated_motion(const Trace& trace, const CoupledVelocities& coupled) {
  return motion_results(
      eliminated_forward_dynamics<Expression>(trace.tree, trace.X, motion_inputs(trace), coupled));
}

std::vector<Result> trace_supported_torque(const Trace& trace, const LambdaChoice& choice,
                                           const SupportRules& rules,
                                           const std::vector<int>& passive) {
  const auto& asked = trace.in[Quantity::xdd_cmd];
  std::vector<Expression> xdd_cmd;
  for (const std::size_t row : task_row_order(*trace.mechanism)) xdd_cmd.push_back(asked[row]);
  const auto torque = supported_control_torque<Expression>(
      trace.tree, trace.X,
      {{trace.qd(), trace.qdd()}, xdd_cmd, trace.in[Quantity::f_wanted], trace.applied()}, passive,
      choice, rules);
  std::vector<Result> results{
      vector_result("tau", "joint forces, 0 where no motor is", torque.tau)};
  if (!torque.f.empty()) {
    results.push_back(vector_result(
        "f", "forces of the constraints on the robot, in their rows, N, N m", torque.f));
  }
  return results;
}

std::vector<Result> trace_jacobian(const Trace& trace) {
  const auto tasks = task_points(trace.tree, {}, world_poses(trace.tree, trace.X));
  std::size_t anchored = 0;
  for (const auto& task : tasks) anchored += task.rows.size();
  return {matrix_result("J_s", "Jacobian of the rows that are held",
                        jacobian_with_loops(trace.tree, trace.X, tasks, anchored,
                                            loop_jacobian(trace.tree, trace.X)))};
}

std::vector<Result> trace_errors(const Trace& trace) {
  const std::vector<Expression> rest(static_cast<std::size_t>(trace.tree.nv), Expression(0.0));
  return {vector_result("error", "how far loops and couplings are from closed, m, 1, rad",
                        loop_rows<Expression>(trace.tree, trace.X, trace.q(), rest).errors)};
}

using Law = std::shared_ptr<const TaskLaw>;

Route supported_route(const RouteQuery& query, const LambdaChoice& choice, const Law& law) {
  return {on_top_of(route_id(choice, query.tree), "supported", "support-consistent, one system"),
          [choice, rules = split_rules(*law), passive = query.seen.passive](const Trace& trace) {
            return trace_supported_torque(trace, choice, rules, passive);
          },
          law};
}

Route constrained_route(const RouteQuery& query, const LambdaChoice& choice, const Law& law) {
  return {
      on_top_of(route_id(choice, query.tree), "constrained",
                "forces of the constraints by Lambda^-1"),
      [choice](const Trace& trace) { return trace_constrained_motion(trace, choice, trace.rule); },
      law};
}

/// Rows that are constant may give velocities in place of forces.
void append_elimination(const RouteQuery& query, const Law& law, std::vector<Route>& routes) {
  const auto coupled = choose_dependents(query.seen);
  if (!coupled) return;
  routes.push_back(
      {{"eliminated", "joints that couplings move eliminated, M = L^T D L"},
       [coupled = *coupled](const Trace& trace) { return trace_eliminated_motion(trace, coupled); },
       law,
       "finite everywhere; couplings hold exactly, and one that depends on those "
       "before it has force 0."});
}

/// Functions that solve for the forces of the constraints.
std::vector<Route> solving_routes(const RouteQuery& query) {
  const bool supports = query.function == Function::supported_control_torque;
  TaskLaws laws(query.seen);
  const Law law = supports ? laws.supported()
                           : laws.find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {});
  // Rows of loops are rows of J alone, which only solves with the factors of M take.
  const auto choices = has_loops(query.tree)
                           ? std::vector<LambdaChoice>{{{}, LambdaRoute::factors_inward}}
                           : lambda_choices(query.tree);
  std::vector<Route> routes;
  for (const LambdaChoice& choice : choices) {
    routes.push_back(supports ? supported_route(query, choice, law)
                              : constrained_route(query, choice, law));
  }
  if (!supports) append_elimination(query, law, routes);
  return routes;
}

}  // namespace

std::vector<Route> constraint_routes(const RouteQuery& query) {
  if (query.function == Function::constraint_jacobian) {
    return {{{"inward", "rows carried inward"}, trace_jacobian}};
  }
  if (query.function == Function::constraint_errors) {
    return {{{"around", "frames carried around the loop"}, trace_errors}};
  }
  return solving_routes(query);
}

}  // namespace treeline
