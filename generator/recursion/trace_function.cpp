#include "recursion/trace_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <utility>

#include "recursion/control_torque.hpp"
#include "recursion/describe_choice.hpp"
#include "recursion/forward_dynamics.hpp"
#include "recursion/late_turns.hpp"
#include "recursion/resolved_acceleration.hpp"
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
};

enum Inputs : unsigned { kQd = 1, kQdd = 2, kTau = 4, kXddCmd = 8, kForces = 16, kPosture = 32 };

/// What all routes of a function have in common.
struct Signature {
  std::string equation;
  unsigned inputs = 0;
};

Signature signature(Function function) {
  switch (function) {
    case Function::forward_kinematics:
      return {"x_world = R x_point + p, for every operational point", 0};
    case Function::jacobian:
      return {"xd = J qd, rows stacked over operational points", 0};
    case Function::bias_acceleration:
      return {"xdd = J qdd + Jd qd: the term Jd qd", kQd};
    case Function::inverse_dynamics:
      return {"tau = M qdd + b + g - J_ext^T f_ext", kQd | kQdd | kForces};
    case Function::gravity:
      return {"g: the joint forces that hold the robot at rest", 0};
    case Function::nonlinear_effects:
      return {"h = b + g: the joint forces at qdd = 0", kQd};
    case Function::mass_matrix:
      return {"tau = M qdd + b + g: the matrix M", 0};
    case Function::forward_dynamics:
      return {"qdd = M^-1 (tau - b - g + J_ext^T f_ext)", kQd | kTau | kForces};
    case Function::lambda_inverse:
      return {"Lambda^-1 = J M^-1 J^T", 0};
    case Function::lambda:
      return {"Lambda = (J M^-1 J^T)^-1", 0};
    case Function::control_torque:
      return {
          "tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, "
          "F = Lambda (xdd_cmd - Jd qd - J qdd_0)",
          kQd | kPosture | kXddCmd | kForces};
    default:  // those of contacts and objects are traced apart
      break;
  }
  return {};
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
  enum class Names { kept, forgotten };

  Tracer(const Mechanism& mechanism, int lanes, Names names = Names::kept)
      : mechanism_(mechanism), lanes_(lanes), names_(names) {}

  Program trace(Function function, const Route& route) const {
    const Signature common = signature(function);
    Program program;
    program.name = function_name(function);
    program.equation = common.equation;
    program.source = route.source;
    program.graph = Graph::for_trace(lanes_);
    if (names_ == Names::forgotten) program.graph.forget_names();
    const Graph::Scope scope(program.graph);
    Trace trace;
    trace.tree = tree_of<Expression>(mechanism_);
    if (function == Function::control_torque && has_priorities(trace.tree)) {
      program.equation += priorities_of(trace.tree);
    }
    trace.rows = static_cast<std::size_t>(mechanism_.task_rows());
    declare_inputs(common.inputs, program, trace);
    trace.X = joint_transforms<Expression>(trace.tree, trace.q);
    turn_late(trace.tree, trace.X);
    program.results = route.body(trace);
    return program;
  }

 private:
  void declare_inputs(unsigned inputs, Program& program, Trace& trace) const {
    const int nv = mechanism_.nv();
    trace.q = declare(program, "q", mechanism_.nq(), "joint coordinates");
    if ((inputs & kQd) != 0) {
      trace.qd = declare(program, "qd", nv, "joint velocities");
    }
    if ((inputs & kQdd) != 0) {
      trace.qdd = declare(program, "qdd", nv, "joint accelerations");
    }
    if ((inputs & kPosture) != 0) {
      trace.qdd = declare(program, "qdd_0", nv, "joint accelerations that the posture asks for");
    }
    if ((inputs & kTau) != 0) {
      trace.tau = declare(program, "tau", nv, "joint forces");
    }
    if ((inputs & kXddCmd) != 0) {
      trace.xdd_cmd = declare(program, "xdd_cmd", mechanism_.task_rows(),
                              "commanded accelerations of the task rows");
    }
    if ((inputs & kForces) != 0 && !mechanism_.external_forces.empty()) {
      trace.f_ext =
          declare(program, "f_ext", 6 * static_cast<int>(mechanism_.external_forces.size()),
                  "force and moment on the robot at each external force's point");
    }
  }

  const Mechanism& mechanism_;
  int lanes_;
  Names names_;
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

std::vector<Route> lambda_routes(const TracedTree& tree, bool invert) {
  std::vector<Route> routes;
  for (const LambdaChoice& choice : lambda_choices(tree)) {
    routes.push_back({describe(choice, tree), [choice, invert](const Trace& trace) {
                        const auto Lambda_inv =
                            lambda_inverse_as_asked(trace.tree, trace.X, choice, trace.rows);
                        return invert
                                   ? matrix_output("Lambda", "operational-space inertia",
                                                   inverse(factor_ldlt(Lambda_inv)))
                                   : matrix_output("Lambda_inv",
                                                   "inverse operational-space inertia", Lambda_inv);
                      }});
  }
  return routes;
}

void append_resolved_routes(const TracedTree& tree, std::vector<Route>& routes) {
  if (!permits_resolved_acceleration(tree)) {
    return;
  }
  for (const int link : axes_links(tree)) {
    routes.push_back(
        {fmt::format("resolved acceleration, spherical wrist, J in {}", axes_name(link, tree)),
         [link](const Trace& trace) {
           return vector_output("tau", "joint forces",
                                control_torque_by_resolved_acceleration<Expression>(
                                    trace.tree, trace.X,
                                    {{trace.qd, trace.qdd}, trace.xdd_cmd, trace.applied()}, link));
         }});
  }
}

std::vector<Route> control_routes(const TracedTree& tree) {
  std::vector<Route> routes;
  for (const LambdaChoice& choice : control_choices(tree)) {
    routes.push_back(
        {(has_priorities(tree) ? "Chang table 6.1, fused, LDL^T in order of priority; Lambda^-1: "
                               : "Chang table 6.1, fused; Lambda^-1: ") +
             describe(choice, tree),
         [choice](const Trace& trace) {
           return vector_output(
               "tau", "joint forces",
               control_torque<Expression>(trace.tree, trace.X,
                                          {{trace.qd, trace.qdd}, trace.xdd_cmd, trace.applied()},
                                          choice, trace.rows));
         }});
  }
  append_resolved_routes(tree, routes);
  return routes;
}

std::vector<Route> newton_euler_route(const char* name, const char* meaning) {
  return {{"recursive Newton-Euler, Chang table 4.1", [name, meaning](const Trace& trace) {
             return vector_output(name, meaning,
                                  inverse_dynamics<Expression>(
                                      trace.tree, trace.X, {trace.qd, trace.qdd}, trace.applied()));
           }}};
}

std::vector<Route> routes_of(Function function, const TracedTree& tree) {
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
      return lambda_routes(tree, false);
    case Function::lambda:
      return lambda_routes(tree, true);
    case Function::control_torque:
      return control_routes(tree);
    default:
      break;
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
  if (std::find(kContactFunctions.begin(), kContactFunctions.end(), function) !=
      kContactFunctions.end()) {
    return trace_contact_function(mechanism, function, lanes);
  }
  if (needs_objects(function)) {
    return trace_object_function(mechanism, function, lanes);
  }
  if (is_about_posture(function)) {
    return trace_posture_function(mechanism, function, lanes);
  }
  if (is_derivative(function)) {
    return trace_derivative_function(mechanism, function, lanes);
  }
  Graph graph;
  const TracedTree tree = structure_of(mechanism, graph);
  const Tracer tracer(mechanism, lanes);
  std::vector<Program> programs;
  for (const Route& route : routes_of(function, tree)) {
    programs.push_back(tracer.trace(function, route));
  }
  return programs;
}

Program trace_route(const Mechanism& mechanism, Function function, const std::string& source) {
  Graph graph;
  const TracedTree tree = structure_of(mechanism, graph);
  for (const Route& route : routes_of(function, tree)) {
    if (route.source == source) {
      return Tracer(mechanism, 1, Tracer::Names::forgotten).trace(function, route);
    }
  }
  for (Program& program : trace_function(mechanism, function)) {  // of another kind
    if (program.source == source) return std::move(program);
  }
  throw std::logic_error("no such route: " + source);
}

}  // namespace treeline
