#include "recursion/trace_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "recursion/control_torque.hpp"
#include "recursion/describe_choice.hpp"
#include "recursion/forward_dynamics.hpp"
#include "recursion/hopeless_algorithms.hpp"
#include "recursion/late_turns.hpp"
#include "recursion/lift_tree.hpp"
#include "recursion/resolved_by_pivots.hpp"
#include "recursion/task_law.hpp"
#include "recursion/trace_contacts.hpp"
#include "recursion/trace_derivatives.hpp"
#include "recursion/trace_object_function.hpp"
#include "recursion/trace_parts.hpp"
#include "recursion/trace_posture.hpp"

namespace treeline {
namespace {

using Expressions = std::vector<Expression>;
using TracedTree = Tree<Expression>;

/// What a trace has at hand: the tree, its transforms for the inputs q, and the other inputs.
struct Trace {
  TracedTree tree;
  std::size_t rows = 0;
  Expressions q, qd, qdd, tau, xdd_cmd, f_ext;
  std::vector<JointTransform<Expression>> X;
  PivotRule rule;

  [[nodiscard]] std::vector<Wrench<Expression>> applied() const {
    return f_ext.empty() ? std::vector<Wrench<Expression>>{}
                         : applied_wrenches<Expression>(tree, X, f_ext);
  }
  [[nodiscard]] std::vector<WorldPose<Expression>> poses() const { return world_poses(tree, X); }
};

/// A result before it is named.
using Outputs = std::vector<Result>;
using Body = std::function<Outputs(const Trace&)>;

/// One way to compute a function.
struct Route {
  std::string source;
  Body body;
  std::shared_ptr<const TaskLaw> law = nullptr;
};

bool solves_for_forces(Function function) {
  return function == Function::lambda || function == Function::control_torque;
}

/// `, in strict priority: left_hand (1), right_hand (2)`, the most important first.
std::string priorities_of(const TracedTree& tree) {
  std::vector<TreePoint<Expression>> points = tree.operational_points;
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.priority < b.priority; });
  std::string text;
  for (const TreePoint<Expression>& point : points) {
    text += fmt::format("{}{} ({})", text.empty() ? ", in strict priority: " : ", ", point.name,
                        point.priority);
  }
  return text;
}

class Tracer {
 public:
  Tracer(const Mechanism& mechanism, int lanes)
      : mechanism_(mechanism), constants_(tree_of<double>(mechanism)), lanes_(lanes) {}

  Program trace(Function function, const Route& route, Names names = Names::kept) const {
    Program program;
    program.name = function_name(function);
    program.equation = info_of(function).equation;
    program.source = route.source;
    program.graph = Graph::for_trace(lanes_);
    if (names == Names::forgotten) program.graph.forget_names();
    const Graph::Scope scope(program.graph);
    Trace trace;
    trace.tree = lift_tree(constants_, mechanism_);
    if (function == Function::control_torque && has_priorities(trace.tree)) {
      program.equation += priorities_of(trace.tree);
    }
    trace.rows = static_cast<std::size_t>(mechanism_.task_rows());
    take_inputs(function, program, trace);
    trace.X = joint_transforms<Expression>(trace.tree, trace.q);
    turn_late(trace.tree, trace.X);
    if (route.law) {
      trace.rule = route.law->rule;
      program.law = route.law;
      program.singular = describe(*route.law);
    } else if (mechanism_.singular == SingularTasks::exact && solves_for_forces(function)) {
      program.singular = kBareSolve;
    }
    program.results = route.body(trace);
    return program;
  }

 private:
  void take_inputs(Function function, Program& program, Trace& trace) const {
    const TracedInputs inputs(mechanism_, function, program);
    trace.q = inputs[Quantity::q];
    trace.qd = inputs[Quantity::qd];
    trace.qdd = inputs[takes(function, Quantity::qdd_0) ? Quantity::qdd_0 : Quantity::qdd];
    trace.tau = inputs[Quantity::tau];
    trace.xdd_cmd = inputs[Quantity::xdd_cmd];
    trace.f_ext = inputs[Quantity::f_ext];
  }

  const Mechanism& mechanism_;
  Tree<double> constants_;
  int lanes_;
};

Outputs vector_output(const char* name, const char* meaning, Expressions values) {
  return {vector_result(name, meaning, std::move(values))};
}
Outputs matrix_output(const char* name, const char* meaning,
                      const DenseMatrix<Expression>& matrix) {
  return {matrix_result(name, meaning, matrix)};
}

Outputs point_poses(const Trace& trace) {
  const auto poses = trace.poses();
  Expressions positions;
  Expressions rotations;
  for (const TreePoint<Expression>& point : trace.tree.operational_points) {
    const WorldPose<Expression> pose = point_pose(poses, point);
    positions.insert(positions.end(), {pose.p.x, pose.p.y, pose.p.z});
    for (const auto& row : {pose.R.row_x, pose.R.row_y, pose.R.row_z}) {
      rotations.insert(rotations.end(), {row.x, row.y, row.z});
    }
  }
  const int count = static_cast<int>(trace.tree.operational_points.size());
  return {{{"position", 3 * count, 1, "positions in the world, m, one point after the other"},
           positions},
          {{"rotation", 9 * count, 1,
            "rotation matrices, row-major, point's axes to world, one point after the other"},
           rotations}};
}

std::vector<Route> jacobian_routes(const TracedTree& tree) {
  std::vector<Route> routes{{"rows carried inward from each point", [](const Trace& trace) {
                               const auto poses = trace.poses();
                               const auto tasks = task_points(trace.tree, {}, poses);
                               return matrix_output(
                                   "J", "Jacobian",
                                   jacobian_inward(trace.tree, trace.X, tasks, trace.rows, poses));
                             }}};
  if (permits(tree, {}, LambdaRoute::factors_world)) {
    routes.push_back({"from the poses of all links", [](const Trace& trace) {
                        return matrix_output(
                            "J", "Jacobian",
                            jacobian_world(trace.tree, trace.poses(), {}, trace.rows));
                      }});
  }
  return routes;
}

Expressions net_forces(const Trace& trace) {
  const auto h = inverse_dynamics<Expression>(trace.tree, trace.X, {trace.qd, {}}, trace.applied());
  Expressions net = trace.tau;
  for (std::size_t i = 0; i < net.size(); ++i) {
    net[i] = net[i] - h[i];
  }
  return net;
}

std::vector<Route> forward_dynamics_routes(const TracedTree& tree) {
  const char* meaning = "joint accelerations";
  std::vector<Route> routes{{"M = L^T D L by composite bodies, sparse solve (RBDA section 6.5)",
                             [meaning](const Trace& trace) {
                               const auto factor = factor_ltdl(mass_matrix(trace.tree, trace.X));
                               return vector_output("qdd", meaning,
                                                    solve(factor, net_forces(trace)));
                             }}};
  if (!tree.has_mimics) {
    routes.push_back({"articulated bodies, Chang table 4.2", [meaning](const Trace& trace) {
                        return vector_output(
                            "qdd", meaning,
                            solve_articulated(trace.tree, trace.X, articulate(trace.tree, trace.X),
                                              net_forces(trace)));
                      }});
  }
  return routes;
}

std::vector<Route> lambda_routes(const TracedTree& tree, bool invert, TaskLaws& laws) {
  std::vector<Route> routes;
  const auto law =
      invert ? laws.find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {}) : nullptr;
  for (const LambdaChoice& choice : lambda_choices(tree)) {
    routes.push_back({describe(choice, tree),
                      [choice, invert](const Trace& trace) {
                        const auto Lambda_inv =
                            lambda_inverse_as_asked(trace.tree, trace.X, choice, trace.rows);
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

/// As many joints as rows: by cofactors, or by pivots that may yield.
void append_resolved_routes(const Mechanism& mechanism, const TracedTree& tree, TaskLaws& laws,
                            std::vector<Route>& routes) {
  if (!permits_resolved_acceleration(tree)) {
    return;
  }
  const auto inputs = [](const Trace& trace) -> ControlInputs<Expression> {
    return {{trace.qd, trace.qdd}, trace.xdd_cmd, trace.applied()};
  };
  if (mechanism.singular == SingularTasks::exact) {
    for (const int link : axes_links(tree)) {
      routes.push_back(
          {fmt::format("resolved acceleration, spherical wrist, J in {}", axes_name(link, tree)),
           [link, inputs](const Trace& trace) {
             return vector_output("tau", "joint forces",
                                  control_torque_by_resolved_acceleration<Expression>(
                                      trace.tree, trace.X, inputs(trace), link));
           }});
    }
    return;
  }
  for (int link = 0; link < 3; ++link) {
    const auto law = laws.resolved(link);
    if (!law) continue;
    routes.push_back(
        {fmt::format("resolved acceleration, spherical wrist, by pivots, J in {} and {}",
                     axes_name(link, tree), axes_name(law->angular_axes_link, tree)),
         [law, inputs](const Trace& trace) {
           return vector_output(
               "tau", "joint forces",
               control_torque_by_pivots<Expression>(trace.tree, trace.X, inputs(trace), *law));
         },
         law});
  }
}

std::vector<Route> control_routes(const Mechanism& mechanism, const TracedTree& tree,
                                  TaskLaws& laws) {
  std::vector<Route> routes;
  const auto kind =
      has_priorities(tree) ? TaskLaw::Kind::priorities : TaskLaw::Kind::inverse_inertia;
  for (const LambdaChoice& choice : control_choices(tree)) {
    // Table 5.1 gives Lambda itself, behind a floating joint, where nothing can be lost.
    const bool solves = choice.route != LambdaRoute::inertia_propagation || has_priorities(tree);
    routes.push_back(
        {(has_priorities(tree) ? "Chang table 6.1, fused, LDL^T in order of priority; Lambda^-1: "
                               : "Chang table 6.1, fused; Lambda^-1: ") +
             describe(choice, tree),
         [choice](const Trace& trace) {
           return vector_output(
               "tau", "joint forces",
               control_torque<Expression>(trace.tree, trace.X,
                                          {{trace.qd, trace.qdd}, trace.xdd_cmd, trace.applied()},
                                          choice, trace.rows, trace.rule));
         },
         solves ? laws.find(kind, LawPoints::operational, control_basis(tree, choice)) : nullptr});
  }
  append_resolved_routes(mechanism, tree, laws, routes);
  return routes;
}

std::vector<Route> newton_euler_route(const char* name, const char* meaning) {
  return {{"recursive Newton-Euler, Chang table 4.1", [name, meaning](const Trace& trace) {
             return vector_output(name, meaning,
                                  inverse_dynamics<Expression>(
                                      trace.tree, trace.X, {trace.qd, trace.qdd}, trace.applied()));
           }}};
}

std::vector<Route> routes_of(Function function, const Mechanism& mechanism,
                             const TracedTree& tree) {
  TaskLaws laws(mechanism);
  switch (function) {
    case Function::forward_kinematics:
      return {{"outward recursion", point_poses}};
    case Function::jacobian:
      return jacobian_routes(tree);
    case Function::bias_acceleration:
      return {{"outward recursion, Chang eq. 6.11", [](const Trace& trace) {
                 const auto tasks = task_points(trace.tree, {}, trace.poses());
                 return vector_output(
                     "bias", "accelerations of the task rows at qdd = 0",
                     bias_acceleration<Expression>(trace.tree, trace.X, tasks, trace.qd));
               }}};
    case Function::inverse_dynamics:
      return newton_euler_route("tau", "joint forces");
    case Function::gravity:
      return newton_euler_route("g", "joint forces");
    case Function::nonlinear_effects:
      return newton_euler_route("h", "joint forces");
    case Function::mass_matrix:
      return {{"composite rigid bodies, RBDA table 6.2", [](const Trace& trace) {
                 return matrix_output("M", "joint-space inertia", mass_matrix(trace.tree, trace.X));
               }}};
    case Function::forward_dynamics:
      return forward_dynamics_routes(tree);
    case Function::lambda_inverse:
      return lambda_routes(tree, false, laws);
    case Function::lambda:
      return lambda_routes(tree, true, laws);
    case Function::control_torque:
      return control_routes(mechanism, tree, laws);
    case Function::object_state:
    case Function::object_control_torque:
    case Function::object_forward_dynamics:
    case Function::contact_motion:
    case Function::contact_inverse_inertia:
    case Function::effective_mass:
    case Function::impulse_response:
    case Function::link_inverse_inertias:
    case Function::center_of_mass:
    case Function::center_of_mass_jacobian:
    case Function::inverse_dynamics_derivatives:
    case Function::forward_dynamics_derivatives:
    case Function::damped_control_torque:
      break;  // traced elsewhere
  }
  return {};
}

/// Which routes there are depends on the tree's structure alone; a throw-away graph holds it.
TracedTree structure_of(const Mechanism& mechanism, Graph& graph) {
  const Graph::Scope scope(graph);
  return tree_of<Expression>(mechanism);
}

}  // namespace

std::vector<Program> trace_function(const Mechanism& mechanism, Function function, int lanes) {
  switch (info_of(function).group) {
    case FunctionGroup::contacts:
    case FunctionGroup::links:
      return trace_contact_function(mechanism, function, lanes);
    case FunctionGroup::objects:
      return trace_object_function(mechanism, function, lanes);
    case FunctionGroup::center_of_mass:
      return trace_posture_function(mechanism, function, lanes);
    case FunctionGroup::derivatives:
      return trace_derivative_function(mechanism, function, lanes);
    case FunctionGroup::robot:
    case FunctionGroup::points:
      break;
  }
  Graph graph;
  const TracedTree tree = structure_of(mechanism, graph);
  const Tracer tracer(mechanism, lanes);
  std::vector<Program> programs;
  HopelessAlgorithms hopeless;
  for (const Route& route : routes_of(function, mechanism, tree)) {
    if (hopeless.has(route.source)) continue;
    programs.push_back(tracer.trace(function, route));
    hopeless.look_at(programs.back());
  }
  return programs;
}

std::function<Program(Names)> prepare_route(const Mechanism& mechanism, Function function,
                                            const std::string& source) {
  Graph graph;
  const TracedTree tree = structure_of(mechanism, graph);
  for (const Route& route : routes_of(function, mechanism, tree)) {
    if (route.source != source) continue;
    return [tracer = Tracer(mechanism, 1), function, route](Names names) {
      return tracer.trace(function, route, names);
    };
  }
  return [&mechanism, function, source](Names) {  // of another kind
    for (Program& program : trace_function(mechanism, function)) {
      if (program.source == source) return std::move(program);
    }
    throw std::logic_error("no such route: " + source);
  };
}

}  // namespace treeline
