#include "recursion/routes/trace_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "recursion/routes/pruned_algorithms.hpp"
#include "recursion/routes/robot_routes.hpp"
#include "recursion/routes/trace_constraint_function.hpp"
#include "recursion/routes/trace_contacts.hpp"
#include "recursion/routes/trace_derivatives.hpp"
#include "recursion/routes/trace_object_function.hpp"
#include "recursion/routes/trace_parts.hpp"
#include "recursion/routes/trace_posture.hpp"
#include "recursion/tree/deferred_rotations.hpp"
#include "recursion/tree/lift_tree.hpp"

namespace treeline {
namespace {

using TracedTree = Tree<Expression>;

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
      : mechanism_(mechanism), constants_(constant_tree<double>(mechanism)), lanes_(lanes) {}

  /// `nodes`: about as many as the graph will have.
  Program trace(Function function, const RobotRoute& route, Names names, std::size_t nodes) const {
    Program program;
    program.name = function_name(function);
    program.equation = info_of(function).equation;
    program.route = route.id;
    program.graph = Graph::for_trace(lanes_);
    program.graph.reserve(nodes);
    if (names == Names::forgotten) program.graph.forget_names();
    const Graph::Scope scope(program.graph);
    RobotTrace trace;
    trace.mechanism = &mechanism_;
    trace.tree = lift_tree(constants_, mechanism_);
    if (function == Function::control_torque && has_priorities(trace.tree)) {
      program.equation += priorities_of(trace.tree);
    }
    trace.rows = static_cast<std::size_t>(mechanism_.task_rows());
    take_inputs(function, program, trace);
    trace.X = joint_transforms<Expression>(trace.tree, trace.q);
    defer_rotations(trace.tree, trace.X);
    if (route.law) {
      trace.rule = route.law->rule;
      program.law = route.law;
      program.singular = describe(*route.law);
    } else if (mechanism_.singular == SingularTasks::exact && has_lambda(function)) {
      program.singular = kBareSolve;
    }
    program.results = route.body(trace);
    return program;
  }

 private:
  void take_inputs(Function function, Program& program, RobotTrace& trace) const {
    const TracedInputs inputs(mechanism_, function, program);
    apply_inputs(mechanism_, inputs, trace.tree);
    trace.q = inputs[Quantity::q];
    trace.qd = inputs[Quantity::qd];
    trace.qdd = inputs[takes(function, Quantity::qdd_0) ? Quantity::qdd_0 : Quantity::qdd];
    trace.tau = inputs[Quantity::tau];
    trace.xdd_cmd = inputs[Quantity::xdd_cmd];
    trace.f_ext = inputs[Quantity::f_ext];
    if (const auto& step = inputs[Quantity::step]; !step.empty()) {
      make_drives_implicit<Expression>(trace.qd, step.front(), trace.tree);
      program.equation =
          "(M + step D + step^2 K) qdd = tau - b - g - step K qd + J_ext^T f_ext" + kImplicitTerms;
    }
  }

  const Mechanism& mechanism_;
  Tree<double> constants_;
  int lanes_;
};

/// Which routes there are depends on the tree's structure alone.
TracedTree structure_in(Program& scratch, const Mechanism& mechanism, Function function) {
  const Graph::Scope scope(scratch.graph);
  return structure_of(mechanism, function, scratch);
}

}  // namespace

std::vector<Program> trace_function(const Mechanism& mechanism, Function function, int lanes) {
  switch (info_of(function).group) {
    case FunctionGroup::contacts:
    case FunctionGroup::links:
      return trace_contact_function(mechanism, function, lanes);
    case FunctionGroup::objects:
      return trace_object_function(mechanism, function, lanes);
    case FunctionGroup::constraints:
      return trace_constraint_function(mechanism, function, lanes);
    case FunctionGroup::center_of_mass:
      return trace_posture_function(mechanism, function, lanes);
    case FunctionGroup::derivatives:
      return trace_derivative_function(mechanism, function, lanes);
    case FunctionGroup::robot:
    case FunctionGroup::points:
      break;
  }
  Program scratch;
  const TracedTree tree = structure_in(scratch, mechanism, function);
  const Tracer tracer(mechanism, lanes);
  std::vector<Program> programs;
  PrunedAlgorithms pruned;
  for (const RobotRoute& route : robot_routes(function, mechanism, tree)) {
    if (pruned.has(route.id)) continue;
    const std::size_t nodes = programs.empty() ? 0 : programs.back().graph.nodes().size();
    programs.push_back(tracer.trace(function, route, Names::kept, nodes));
    pruned.look_at(programs.back());
  }
  return programs;
}

std::function<Program(Names)> prepare_route(const Mechanism& mechanism, Function function,
                                            const RouteId& id) {
  Program scratch;
  const TracedTree tree = structure_in(scratch, mechanism, function);
  for (const RobotRoute& route : robot_routes(function, mechanism, tree)) {
    if (key_of(route.id) != key_of(id)) continue;
    return [tracer = Tracer(mechanism, 1), function, route,
            nodes = std::size_t{0}](Names names) mutable {
      Program program = tracer.trace(function, route, names, nodes);
      nodes = program.graph.nodes().size();
      return program;
    };
  }
  return [&mechanism, function, id](Names) {  // of another kind
    for (Program& program : trace_function(mechanism, function)) {
      if (key_of(program.route) == key_of(id)) return std::move(program);
    }
    throw std::logic_error("no such route: " + key_of(id));
  };
}

}  // namespace treeline
