#include "recursion/routes/trace_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#include "recursion/routes/pruned_algorithms.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/routes_of_groups.hpp"
#include "recursion/tree/lift_tree.hpp"
#include "recursion/tree/supported_mechanism.hpp"

namespace treeline {
namespace {

using TracedTree = Tree<Expression>;

/// The mechanism as the function sees it: itself, or, for functions about constraints, a copy that
/// has these as points.
std::shared_ptr<const Mechanism> seen_by(Function function, const Mechanism& mechanism) {
  if (info_of(function).group != FunctionGroup::constraints)
    return {std::shared_ptr<const Mechanism>(), &mechanism};
  if (function == Function::supported_control_torque) {
    return std::make_shared<const Mechanism>(with_supports(mechanism));
  }
  Mechanism seen = with_constraints_only(mechanism);
  // Rows of constraints may depend on each other, whatever the scene asks of tasks.
  seen.singular = SingularTasks::smooth;
  return std::make_shared<const Mechanism>(std::move(seen));
}

/// Derivatives put three values together.
int lanes_of(Function function, int lanes) {
  constexpr int kMostOfDerivatives = 4;
  const bool few = info_of(function).group == FunctionGroup::derivatives;
  return few ? std::min(lanes, kMostOfDerivatives) : lanes;
}

/// Whether the bare solve, for which a scene may ask, divides by what can vanish.
bool may_divide_by_zero(Function function) {
  return solve_of(function) == Solve::lambda_inverse || function == Function::effective_mass;
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

/// Parts that a function about impulses ignores of a robot that is held or holds something.
std::string left_out_of(Function function, const Mechanism& mechanism) {
  const FunctionGroup group = info_of(function).group;
  const bool about_impulses = (group == FunctionGroup::contacts || group == FunctionGroup::links) &&
                              solve_of(function) != Solve::none;
  if (!about_impulses) return {};
  const bool holds = !mechanism.objects.empty();
  const bool is_held = mechanism.held_rows() > 0;
  if (!holds && !is_held) return {};
  const char* const what = !holds ? "constraints" : is_held ? "constraints and objects" : "objects";
  return fmt::format(", of the robot alone: {} of the scene are not held", what);
}

/// Added where constraints come and go.
constexpr const char* kSharedRows =
    ", but rows that are held to a share w of active have a compliance, (1 - w) / w of their own "
    "inverse inertia";

/// Added where a torque is chosen for them. It is no motion of rows with such compliances: of what
/// is held in part, the torque keeps Newton's law and the task.
constexpr const char* kSharedSupports =
    ", but of rows that are held to a share w of active J_s qdd + Jd_s qd is 0 at w = 1, and free "
    "at w = 0, where f is 0; both change smoothly between";

/// Added where tasks come and go.
constexpr const char* kSharedTasks =
    ", but the task of a point that is done to a share s of active_tasks acts and sees s-fold, and "
    "has a compliance, (1 - s^2) / s^2 of its own inverse inertia";

/// The equation with an argument `step`.
std::string implicit_equation(Function function) {
  const std::string equation =
      info_of(function).group == FunctionGroup::constraints
          ? "(M + step D + step^2 K) qdd + b + g + step K qd = tau + J_s^T f + J_ext^T f_ext, "
            "J_s qdd + Jd_s qd = -stabilisation[0] J_s qd - stabilisation[1] drift"
          : "(M + step D + step^2 K) qdd = tau - b - g - step K qd + J_ext^T f_ext";
  return equation + kImplicitTerms;
}

std::vector<Route> list_routes(const RouteQuery& query) {
  switch (info_of(query.function).group) {
    case FunctionGroup::contacts:
    case FunctionGroup::links:
      return contact_routes(query);
    case FunctionGroup::objects:
      return object_routes(query);
    case FunctionGroup::constraints:
      return constraint_routes(query);
    case FunctionGroup::center_of_mass:
      return posture_routes(query);
    case FunctionGroup::derivatives:
      return derivative_routes(query);
    case FunctionGroup::robot:
    case FunctionGroup::points:
      break;
  }
  return robot_routes(query);
}

/// The row's equation, without what the scene has not: held rows, tasks, joints without a motor.
std::string supported_equation(const Mechanism& mechanism) {
  const bool held = mechanism.held_rows() > 0;
  std::string text = "M qdd + b + g = tau + ";
  text += held ? "J_s^T f + J_ext^T f_ext, J_s qdd + Jd_s qd = 0, " : "J_ext^T f_ext, ";
  if (!mechanism.operational_points.empty()) text += "J qdd + Jd qd = xdd_cmd, ";
  if (!mechanism.passive.empty()) text += "tau = 0 at passive joints, ";
  return text + "qdd nearest to qdd_0";
}

/// Traces any function by any of its routes.
class Tracer {
 public:
  Tracer(const Mechanism& mechanism, Function function, int lanes)
      : mechanism_(mechanism),
        function_(function),
        lanes_(lanes_of(function, lanes)),
        constants_(constant_tree<DoubleDouble>(*seen_by(function, mechanism))),
        names_(std::make_shared<const ConstantNames>(name_constants(constants_))) {}

  [[nodiscard]] std::vector<Route> routes() const {
    Program scratch;  // to be thrown away: routes depend on the tree's structure alone
    const Graph::Scope scope(scratch.graph);
    const auto seen = seen_by(function_, mechanism_);
    Trace trace = begin(*seen);
    trace.in = TracedInputs(mechanism_, function_, scratch);
    apply_inputs(*seen, trace.in, trace.tree);
    return list_routes({function_, mechanism_, *seen, trace.tree, lanes_});
  }

  /// `nodes`: about as many as the graph will have.
  [[nodiscard]] Program trace(const Route& route, Names names, std::size_t nodes) const {
    Ending ending;
    Program program = trace_lines(route, names, nodes, ending);
    if (!route.ending) return program;
    ending.lines = std::move(program);
    return end_lines(std::move(ending));
  }

 private:
  /// The straight lines; what comes behind them goes to `ending`.
  [[nodiscard]] Program trace_lines(const Route& route, Names names, std::size_t nodes,
                                    Ending& ending) const {
    Program program;
    program.name = function_name(function_);
    program.equation = info_of(function_).equation;
    program.route = route.id;
    program.law = route.law;
    program.graph = Graph::for_trace(lanes_);
    program.graph.reserve(nodes);
    if (names == Names::forgotten) {
      program.graph.forget_names();
    } else {
      program.constants = names_;
    }
    const Graph::Scope scope(program.graph);
    const auto seen = seen_by(function_, mechanism_);
    Trace trace = begin(*seen);
    if (function_ == Function::control_torque && has_priorities(trace.tree)) {
      program.equation += priorities_of(trace.tree);
    }
    if (function_ == Function::supported_control_torque) {
      program.equation = supported_equation(mechanism_);
    }
    program.equation += left_out_of(function_, mechanism_);
    take_inputs(*seen, program, trace);
    find_transforms(trace, !route.keeps_inertias);
    describe_singular(route, program);
    if (route.law) trace.rule = route.law->rule;
    if (route.ending) {
      ending = route.ending(trace);
      program.results = std::move(ending.lines.results);
      return program;
    }
    program.results = route.body(trace);
    if (route.order) program.order = route.order(mechanism_, program.results.size());
    return program;
  }

  /// A trace in the open graph that knows no inputs.
  [[nodiscard]] Trace begin(const Mechanism& seen) const {
    Trace trace;
    trace.mechanism = &mechanism_;
    const bool about_objects = info_of(function_).group == FunctionGroup::objects;
    if (about_objects) trace.objects = objects_of<Expression>(mechanism_);
    trace.tree = lift_tree(constants_, seen);
    if (about_objects) trace.tree = holding_tree(std::move(trace.tree), trace.objects);
    return trace;
  }

  void take_inputs(const Mechanism& seen, Program& program, Trace& trace) const {
    trace.in = TracedInputs(mechanism_, function_, program);
    apply_inputs(seen, trace.in, trace.tree);
    if (const auto& step = trace.in[Quantity::step]; !step.empty()) {
      make_drives_implicit<Expression>(trace.qd(), step.front(), trace.tree);
      program.equation = implicit_equation(function_);
    }
    if (!trace.in[Quantity::active].empty()) {
      program.equation +=
          function_ == Function::supported_control_torque ? kSharedSupports : kSharedRows;
    }
    if (!trace.in[Quantity::active_tasks].empty()) program.equation += kSharedTasks;
  }

  void describe_singular(const Route& route, Program& program) const {
    if (!route.singular.empty()) {
      program.singular = route.singular;
    } else if (route.law) {
      program.singular = describe(*route.law);
      if (function_ == Function::lambda) program.singular += kYieldingLambda;
    } else if (mechanism_.singular == SingularTasks::exact && may_divide_by_zero(function_)) {
      program.singular = kBareSolve;
    }
  }

  const Mechanism& mechanism_;
  Function function_;
  int lanes_;
  Tree<DoubleDouble> constants_;
  std::shared_ptr<const ConstantNames> names_;
};

}  // namespace

std::vector<Program> trace_function(const Mechanism& mechanism, Function function, int lanes) {
  const Tracer tracer(mechanism, function, lanes);
  std::vector<Program> programs;
  PrunedAlgorithms pruned;
  for (const Route& route : tracer.routes()) {
    if (pruned.has(route.id)) continue;
    const std::size_t nodes = programs.empty() ? 0 : programs.back().graph.nodes().size();
    programs.push_back(tracer.trace(route, Names::kept, nodes));
    pruned.look_at(programs.back());
  }
  return programs;
}

std::function<Program(Names)> prepare_route(const Mechanism& mechanism, Function function,
                                            const RouteId& id) {
  const Tracer tracer(mechanism, function, 1);
  for (const Route& route : tracer.routes()) {
    if (key_of(route.id) != key_of(id)) continue;
    return [tracer, route, nodes = std::size_t{0}](Names names) mutable {
      Program program = tracer.trace(route, names, nodes);
      nodes = program.graph.nodes().size();
      return program;
    };
  }
  throw std::logic_error("no such route: " + key_of(id));
}

}  // namespace treeline
