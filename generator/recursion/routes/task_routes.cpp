#include <fmt/format.h>

#include "recursion/methods/operational_quantities.hpp"
#include "recursion/methods/resolved_by_pivots.hpp"
#include "recursion/routes/describe_choice.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/routes_of_groups.hpp"

namespace treeline {
namespace {

/// Adds routes for as many joints as rows: by cofactors, or by pivots that may yield.
void append_resolved_routes(const Mechanism& mechanism, const Tree<Expression>& tree,
                            TaskLaws& laws, std::vector<Route>& routes) {
  if (!permits_resolved_acceleration(tree)) {
    return;
  }
  const auto inputs = [](const Trace& trace) -> ControlInputs<Expression> {
    return {{trace.qd(), trace.qdd()}, trace.in[Quantity::xdd_cmd], trace.applied()};
  };
  if (mechanism.singular == SingularTasks::exact) {
    for (const int link : axes_links(tree)) {
      routes.push_back({{"resolved", "resolved acceleration, spherical wrist", axes_key(link),
                         fmt::format("J in {}", axes_name(link, tree))},
                        [link, inputs](const Trace& trace) {
                          return vector_output("tau",
                                               trace.with_unit("joint forces", Quantity::tau),
                                               control_torque_by_resolved_acceleration<Expression>(
                                                   trace.tree, trace.X, inputs(trace), link));
                        }});
    }
    return;
  }
  for (int link = 0; link < 3; ++link) {
    const auto law = laws.resolved(link);
    if (!law) continue;
    routes.push_back({{"resolved-pivots", "resolved acceleration, spherical wrist, by pivots",
                       fmt::format("{}+{}", axes_key(link), axes_key(law->angular_axes_link)),
                       fmt::format("J in {} and {}", axes_name(link, tree),
                                   axes_name(law->angular_axes_link, tree))},
                      [law, inputs](const Trace& trace) {
                        return vector_output("tau", trace.with_unit("joint forces", Quantity::tau),
                                             control_torque_by_pivots<Expression>(
                                                 trace.tree, trace.X, inputs(trace), *law));
                      },
                      law});
  }
}

DenseMatrix<Expression> jacobian_by(LambdaRoute route, const Trace& trace) {
  const auto poses = trace.poses();
  return route == LambdaRoute::factors_world
             ? jacobian_world(trace.tree, poses, {}, trace.rows())
             : jacobian_inward(trace.tree, trace.X, task_points(trace.tree, {}, poses),
                               trace.rows(), poses);
}

}  // namespace

std::vector<Route> lambda_routes(const Tree<Expression>& tree, bool invert, TaskLaws& laws) {
  std::vector<Route> routes;
  const auto law =
      invert ? laws.find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {}) : nullptr;
  for (const LambdaChoice& choice : lambda_choices(tree)) {
    routes.push_back({route_id(choice, tree),
                      [choice, invert](const Trace& trace) {
                        const auto Lambda_inv =
                            lambda_inverse_as_asked(trace.tree, trace.X, choice, trace.rows());
                        return invert
                                   ? matrix_output("Lambda", "operational-space inertia",
                                                   inverse(factor_ldlt(Lambda_inv, trace.rule)))
                                   : matrix_output("Lambda_inv",
                                                   "inverse operational-space inertia", Lambda_inv);
                      },
                      law});
  }
  return routes;
}

std::vector<Route> control_routes(const Mechanism& mechanism, const Tree<Expression>& tree,
                                  TaskLaws& laws) {
  std::vector<Route> routes;
  const auto kind =
      has_priorities(tree) ? TaskLaw::Kind::priorities : TaskLaw::Kind::inverse_inertia;
  for (const LambdaChoice& choice : control_choices(tree)) {
    // Table 5.1 gives Lambda itself, behind a floating joint, where nothing can be lost.
    const bool solves = choice.route != LambdaRoute::inertia_propagation || has_priorities(tree);
    routes.push_back(
        {has_priorities(tree)
             ? on_top_of(route_id(choice, tree), "fused-by-priority",
                         "Chang table 6.1, fused, LDL^T in order of priority")
             : on_top_of(route_id(choice, tree), "fused", "Chang table 6.1, fused"),
         [choice](const Trace& trace) {
           return vector_output(
               "tau", trace.with_unit("joint forces", Quantity::tau),
               control_torque<Expression>(
                   trace.tree, trace.X,
                   {{trace.qd(), trace.qdd()}, trace.in[Quantity::xdd_cmd], trace.applied()},
                   choice, trace.rows(), trace.rule));
         },
         solves ? laws.find(kind, LawPoints::operational, control_basis(tree, choice)) : nullptr});
  }
  append_resolved_routes(mechanism, tree, laws, routes);
  return routes;
}

std::vector<Route> consistent_inverse_routes(const Tree<Expression>& tree, bool project,
                                             TaskLaws& laws) {
  const auto law = laws.find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {});
  std::vector<Route> routes;
  for (const LambdaRoute route : {LambdaRoute::factors_inward, LambdaRoute::factors_world}) {
    if (!permits(tree, {}, route)) continue;
    routes.push_back(
        {route_id(LambdaChoice{{}, route}, tree),
         [route, project](const Trace& trace) {
           const auto J = jacobian_by(route, trace);
           const auto Jbar = dynamically_consistent_inverse(trace.tree, trace.X, J, trace.rule);
           return project ? matrix_output("N", "null-space projector 1 - Jbar J",
                                          null_space_projector(Jbar, J))
                          : matrix_output("Jbar", "dynamically consistent inverse of J", Jbar);
         },
         law});
  }
  return routes;
}

std::vector<Route> operational_force_routes(const Tree<Expression>& tree, bool of_gravity,
                                            TaskLaws& laws) {
  const auto law = laws.find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {});
  std::vector<Route> routes;
  for (const LambdaChoice& choice : lambda_choices(tree)) {
    routes.push_back(
        {on_top_of(route_id(choice, tree), "released",
                   "from the acceleration of the released task"),
         [choice, of_gravity](const Trace& trace) {
           return of_gravity ? vector_output("p", "forces of gravity in the task rows, N, N m",
                                             operational_gravity(trace.tree, trace.X, choice,
                                                                 trace.rows(), trace.rule))
                             : vector_output("mu", "forces of velocities in the task rows, N, N m",
                                             operational_bias_force<Expression>(
                                                 trace.tree, trace.X, choice, trace.rows(),
                                                 trace.rule, trace.qd()));
         },
         law});
  }
  return routes;
}

}  // namespace treeline
