#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>

#include "functions/function_table.hpp"
#include "recursion/methods/object_forward_dynamics.hpp"
#include "recursion/methods/operational_quantities.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/describe_choice.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/routes_of_groups.hpp"

namespace treeline {
namespace {

using Expressions = std::vector<Expression>;
/// The points of Lambda^-1 are the objects' origins, its axes the world's.
RouteId route_id(const LambdaChoice& choice) {
  const TaskBasis& basis = choice.basis;
  const bool turned = basis.axes_link >= 0;
  RouteId id = treeline::route_id(choice.route);
  id.coordinates = (turned               ? axes_key(basis.axes_link)
                    : basis.in_link_axes ? "own"
                                         : "world") +
                   std::string(basis.at_link_origin ? "/origins" : "/objects");
  id.coordinates_words = fmt::format("in {} at {}",
                                     turned ? fmt::format("axes of link {}", basis.axes_link + 1)
                                     : basis.in_link_axes ? "link axes"
                                                          : "world axes",
                                     basis.at_link_origin ? "link origins" : "the objects");
  return id;
}

std::vector<Route> state_routes() {
  return {
      {{"outward", "outward recursion"}, [](const Trace& trace) {
         const auto state =
             object_state<Expression>(trace.tree, trace.objects, trace.X, trace.qd());
         std::vector<Result> results{
             vector_result("position", "of the objects' origins in the world, m, 3 an object",
                           state.position),
             vector_result("rotation", "object's axes to world, row-major, 9 an object",
                           state.rotation),
             vector_result("velocity",
                           "of the objects' origins over angular velocity, world axes, 6 an object",
                           state.velocity)};
         if (!state.drift.empty()) {
           results.push_back(vector_result(
               "drift",
               "pose in which each further grasp has its object less that of the first: "
               "position, m, over turn, rad, world axes",
               state.drift));
           results.push_back(
               vector_result("drift_rate", "the same of velocities", state.drift_rate));
         }
         return results;
       }}};
}

std::vector<Route> control_routes(const Tree<Expression>& tree, TaskLaws& laws) {
  std::vector<Route> routes;
  for (const LambdaChoice& choice : control_choices(tree)) {
    routes.push_back({on_top_of(route_id(choice), "fused", "Chang table 7.1, fused"),
                      [choice](const Trace& trace) {
                        return std::vector<Result>{vector_result(
                            "tau", "joint forces",
                            object_control_torque<Expression>(
                                trace.tree, trace.objects, trace.X, {trace.qd(), trace.qdd()},
                                {trace.in[Quantity::xdd_object], trace.in[Quantity::internal]},
                                choice, trace.rule))};
                      },
                      choice.route == LambdaRoute::inertia_propagation
                          ? nullptr
                          : laws.find(TaskLaw::Kind::inverse_inertia, LawPoints::grasps,
                                      control_basis(tree, choice))});
  }
  return routes;
}

ClosedChainMotion<Expression> traced_motion(const Trace& trace, const LambdaChoice& choice) {
  const ObjectDynamicsInputs<Expression> inputs{trace.qd(), trace.tau(),
                                                trace.in[Quantity::stabilisation]};
  return object_forward_dynamics<Expression>(
      trace.tree, trace.objects, trace.X, inputs, choice,
      [&](const Expressions& forces) {
        return accelerate(trace.tree, trace.X, choice.route, forces);
      },
      trace.rule);
}

std::vector<Result> trace_dynamics(const Trace& trace, const LambdaChoice& choice) {
  const auto motion = traced_motion(trace, choice);
  std::vector<Result> results{
      vector_result("qdd", "joint accelerations", motion.qdd),
      vector_result("xdd_object",
                    "accelerations of the objects' origins over angular ones, world axes",
                    motion.xdd_object),
      vector_result("f_grasp",
                    "force and moment of each hand on its object at the hand's point, world axes",
                    motion.f_grasp)};
  if (!motion.internal.empty()) {
    results.push_back(
        vector_result("internal", "internal forces of the virtual linkages", motion.internal));
  }
  return results;
}

std::vector<Route> dynamics_routes(const Tree<Expression>& tree, TaskLaws& laws) {
  std::vector<Route> routes;
  const auto law = laws.find(TaskLaw::Kind::grasp_forces, LawPoints::grasps, {});
  for (const LambdaChoice& choice : lambda_choices(tree)) {
    routes.push_back({on_top_of(route_id(choice), "one-system",
                                "Chang table 7.2, one system for the grasps' forces"),
                      [choice](const Trace& trace) { return trace_dynamics(trace, choice); }, law});
  }
  return routes;
}

struct ObjectRow {
  Function function;
  std::vector<Route> (*routes)(const Tree<Expression>& tree, TaskLaws& laws);
};

constexpr auto kObjects = std::to_array<ObjectRow>(
    {{Function::object_state, [](const Tree<Expression>&, TaskLaws&) { return state_routes(); }},
     {Function::object_control_torque, control_routes},
     {Function::object_forward_dynamics, dynamics_routes}});
static_assert(covers<is_about<FunctionGroup::objects>>(kObjects));

}  // namespace

std::vector<Route> object_routes(const RouteQuery& query) {
  TaskLaws laws(query.mechanism);
  return find_row(kObjects, query.function)->routes(query.tree, laws);
}

}  // namespace treeline
