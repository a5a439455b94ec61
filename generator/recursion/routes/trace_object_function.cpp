#include "recursion/routes/trace_object_function.hpp"

#include <fmt/format.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "recursion/methods/object_forward_dynamics.hpp"
#include "recursion/methods/operational_quantities.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/describe_choice.hpp"
#include "recursion/routes/trace_parts.hpp"
#include "recursion/tree/deferred_rotations.hpp"

namespace treeline {
namespace {

using Expressions = std::vector<Expression>;
using Objects = std::vector<TreeObject<Expression>>;

/// What a trace has at hand.
struct Trace {
  Tree<Expression> tree;  ///< its points are the grasps
  Objects objects;
  Expressions q, qd, qdd_0, tau, xdd_object, internal, stabilisation;
  std::vector<JointTransform<Expression>> X;
  PivotRule rule = {};
};

struct Route {
  RouteId id;
  std::function<std::vector<Result>(const Trace&)> body;
  std::shared_ptr<const TaskLaw> law = nullptr;
};

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
         const auto state = object_state<Expression>(trace.tree, trace.objects, trace.X, trace.qd);
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
                                trace.tree, trace.objects, trace.X, {trace.qd, trace.qdd_0},
                                {trace.xdd_object, trace.internal}, choice, trace.rule))};
                      },
                      choice.route == LambdaRoute::inertia_propagation
                          ? nullptr
                          : laws.find(TaskLaw::Kind::inverse_inertia, LawPoints::grasps,
                                      control_basis(tree, choice))});
  }
  return routes;
}

ClosedChainMotion<Expression> traced_motion(const Trace& trace, const LambdaChoice& choice,
                                            GraspSolution solution) {
  const ObjectDynamicsInputs<Expression> inputs{trace.qd, trace.tau, trace.stabilisation};
  return object_forward_dynamics<Expression>(
      trace.tree, trace.objects, trace.X, inputs, choice, solution,
      [&](const Expressions& forces) {
        return accelerate(trace.tree, trace.X, choice.route, forces);
      },
      trace.rule);
}

/// The augmented object needs Lambda_e, which is not finite where a hand cannot move; the system
/// for the grasps' forces needs its inverse only.
std::vector<GraspSolution> solutions(const Mechanism& mechanism) {
  if (mechanism.singular == SingularTasks::smooth) return {GraspSolution::grasp_forces};
  return {GraspSolution::grasp_forces, GraspSolution::augmented_object};
}

std::vector<Route> dynamics_routes(const Mechanism& mechanism, const Tree<Expression>& tree,
                                   TaskLaws& laws) {
  std::vector<Route> routes;
  const auto law = laws.find(TaskLaw::Kind::grasp_forces, LawPoints::grasps, {});
  for (const LambdaChoice& choice : lambda_choices(tree)) {
    for (const GraspSolution solution : solutions(mechanism)) {
      const bool augmented = solution == GraspSolution::augmented_object;
      const RouteId id =
          on_top_of(route_id(choice), augmented ? "augmented-object" : "one-system",
                    augmented ? "Chang table 7.2, augmented object"
                              : "Chang table 7.2, one system for the grasps' forces");
      routes.push_back(
          {id,
           [choice, solution](const Trace& trace) {
             const auto motion = traced_motion(trace, choice, solution);
             std::vector<Result> results{
                 vector_result("qdd", "joint accelerations", motion.qdd),
                 vector_result(
                     "xdd_object",
                     "accelerations of the objects' origins over angular ones, world axes",
                     motion.xdd_object),
                 vector_result("f_grasp",
                               "force and moment of each hand on its object at the hand's point, "
                               "world axes",
                               motion.f_grasp)};
             if (!motion.internal.empty()) {
               results.push_back(vector_result(
                   "internal", "internal forces of the virtual linkages", motion.internal));
             }
             return results;
           },
           law});
    }
  }
  return routes;
}

std::vector<Route> routes_of(Function function, const Mechanism& mechanism,
                             const Tree<Expression>& tree) {
  TaskLaws laws(mechanism);
  switch (function) {
    case Function::object_state:
      return state_routes();
    case Function::object_control_torque:
      return control_routes(tree, laws);
    case Function::object_forward_dynamics:
      return dynamics_routes(mechanism, tree, laws);
    default:
      throw std::logic_error(std::string(function_name(function)) + " is not about objects");
  }
}

void take_inputs(const Mechanism& mechanism, Function function, Program& program, Trace& trace) {
  const TracedInputs inputs(mechanism, function, program);
  apply_inputs(mechanism, inputs, trace.tree);
  trace.q = inputs[Quantity::q];
  trace.qd = inputs[Quantity::qd];
  trace.qdd_0 = inputs[Quantity::qdd_0];
  trace.tau = inputs[Quantity::tau];
  trace.xdd_object = inputs[Quantity::xdd_object];
  trace.internal = inputs[Quantity::internal];
  trace.stabilisation = inputs[Quantity::stabilisation];
}

Program trace_route(const Mechanism& mechanism, Function function, const Route& route, int lanes) {
  Program program;
  program.name = function_name(function);
  program.equation = info_of(function).equation;
  program.route = route.id;
  program.graph = Graph::for_trace(lanes);
  const Graph::Scope scope(program.graph);
  Trace trace;
  trace.objects = objects_of<Expression>(mechanism);
  trace.tree = holding_tree(constant_tree<Expression>(mechanism), trace.objects);
  take_inputs(mechanism, function, program, trace);
  trace.X = joint_transforms<Expression>(trace.tree, trace.q);
  defer_rotations(trace.tree, trace.X);
  follow_points(trace.tree, trace.objects);
  if (route.law) {
    trace.rule = route.law->rule;
    program.singular = describe(*route.law);
  } else if (mechanism.singular == SingularTasks::exact && function != Function::object_state) {
    program.singular = kBareSolve;
  }
  program.law = route.law;
  program.results = route.body(trace);
  return program;
}

}  // namespace

std::vector<Program> trace_object_function(const Mechanism& mechanism, Function function,
                                           int lanes) {
  Program scratch;  // routes depend on the tree's structure alone
  const Graph::Scope scope(scratch.graph);
  const auto objects = objects_of<Expression>(mechanism);
  const auto tree = holding_tree(structure_of(mechanism, function, scratch), objects);
  std::vector<Program> programs;
  for (const Route& route : routes_of(function, mechanism, tree)) {
    programs.push_back(trace_route(mechanism, function, route, lanes));
  }
  return programs;
}

}  // namespace treeline
