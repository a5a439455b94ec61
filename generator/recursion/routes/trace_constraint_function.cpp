#include "recursion/routes/trace_constraint_function.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "recursion/methods/eliminated_forward_dynamics.hpp"
#include "recursion/methods/operational_quantities.hpp"
#include "recursion/methods/supported_control_torque.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/describe_choice.hpp"
#include "recursion/routes/pruned_algorithms.hpp"
#include "recursion/routes/trace_parts.hpp"
#include "recursion/tree/deferred_rotations.hpp"
#include "recursion/tree/supported_mechanism.hpp"

namespace treeline {
namespace {

/// What a trace of a function about constraints has at hand.
struct ConstraintTrace {
  Tree<Expression> tree;  ///< its points are the constraints, and the tasks if there are any
  std::vector<JointTransform<Expression>> X;
  std::vector<Expression> q, qd, qdd_0, tau, xdd_cmd, f_wanted, stabilisation, drift;
  std::vector<Wrench<Expression>> applied;
};

using ConstraintBody = std::function<std::vector<Result>(const ConstraintTrace&)>;

struct ConstraintRoute {
  RouteId id;
  ConstraintBody body;
  std::string singular = {};  ///< for users; empty: what the law says
};

ConstrainedInputs<Expression> motion_inputs(const ConstraintTrace& trace) {
  return {trace.q, trace.qd, trace.tau, trace.stabilisation, trace.drift, trace.applied};
}

std::vector<Result> motion_results(const ConstrainedMotion<Expression>& motion) {
  return {vector_result("qdd", "joint accelerations", motion.qdd),
          vector_result("f", "forces of the constraints on the robot, in their rows, N, N m",
                        motion.f)};
}

std::vector<Result> trace_constrained_motion(const ConstraintTrace& trace,
                                             const LambdaChoice& choice, const PivotRule& rule) {
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

std::vector<Result> trace_eliminated_motion(const ConstraintTrace& trace,
                                            const CoupledVelocities& coupled) {
  return motion_results(
      eliminated_forward_dynamics<Expression>(trace.tree, trace.X, motion_inputs(trace), coupled));
}

std::vector<Result> trace_supported_torque(const ConstraintTrace& trace, const LambdaChoice& choice,
                                           const SupportRules& rules,
                                           const std::vector<int>& passive) {
  const auto torque = supported_control_torque<Expression>(
      trace.tree, trace.X, {{trace.qd, trace.qdd_0}, trace.xdd_cmd, trace.f_wanted, trace.applied},
      passive, choice, rules);
  std::vector<Result> results{
      vector_result("tau", "joint forces, 0 where no motor is", torque.tau)};
  if (!torque.f.empty()) {
    results.push_back(vector_result(
        "f", "forces of the constraints on the robot, in their rows, N, N m", torque.f));
  }
  return results;
}

std::vector<Result> trace_jacobian(const ConstraintTrace& trace) {
  const auto tasks = task_points(trace.tree, {}, world_poses(trace.tree, trace.X));
  std::size_t anchored = 0;
  for (const auto& task : tasks) anchored += task.rows.size();
  return {matrix_result("J_s", "Jacobian of the rows that are held",
                        jacobian_with_loops(trace.tree, trace.X, tasks, anchored,
                                            loop_jacobian(trace.tree, trace.X)))};
}

std::vector<Result> trace_errors(const ConstraintTrace& trace) {
  const std::vector<Expression> rest(static_cast<std::size_t>(trace.tree.nv), Expression(0.0));
  return {vector_result("error", "how far loops and couplings are from closed, m, 1, rad",
                        loop_rows<Expression>(trace.tree, trace.X, trace.q, rest).errors)};
}

class ConstraintTracer {
 public:
  ConstraintTracer(const Mechanism& mechanism, Function function, int lanes)
      : mechanism_(mechanism),
        function_(function),
        lanes_(lanes),
        supports_(function == Function::supported_control_torque),
        seen_(supports_ ? with_supports(mechanism) : with_constraints_only(mechanism)) {
    // Rows of constraints may depend on each other, whatever the scene asks of tasks.
    if (!supports_) seen_.singular = SingularTasks::smooth;
    if (solve_of(function) == Solve::none) return;
    TaskLaws laws(seen_);
    law_ = supports_ ? laws.supported()
                     : laws.find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {});
  }

  [[nodiscard]] std::vector<ConstraintRoute> routes() const {
    if (function_ == Function::constraint_jacobian) {
      return {{{"inward", "rows carried inward"}, trace_jacobian}};
    }
    if (function_ == Function::constraint_errors) {
      return {{{"around", "frames carried around the loop"}, trace_errors}};
    }
    return solving_routes();
  }

  /// Functions that solve for the forces of the constraints.
  [[nodiscard]] std::vector<ConstraintRoute> solving_routes() const {
    Program scratch;  // to be thrown away: routes depend on the tree's structure alone
    const Graph::Scope scope(scratch.graph);
    auto tree = constant_tree<Expression>(seen_);
    apply_inputs(seen_, TracedInputs(mechanism_, function_, scratch), tree);
    std::vector<ConstraintRoute> routes;
    // Rows of loops are rows of J alone, which only solves with the factors of M take.
    const auto choices = has_loops(tree)
                             ? std::vector<LambdaChoice>{{{}, LambdaRoute::factors_inward}}
                             : lambda_choices(tree);
    for (const LambdaChoice& choice : choices) {
      const RouteId own = route_id(choice, tree);
      if (supports_) {
        routes.push_back({on_top_of(own, "supported", "support-consistent, one system"),
                          [choice, rules = split_rules(*law_),
                           passive = seen_.passive](const ConstraintTrace& trace) {
                            return trace_supported_torque(trace, choice, rules, passive);
                          }});
      } else {
        routes.push_back({on_top_of(own, "constrained", "forces of the constraints by Lambda^-1"),
                          [choice, rule = law_->rule](const ConstraintTrace& trace) {
                            return trace_constrained_motion(trace, choice, rule);
                          }});
      }
    }
    if (!supports_) append_elimination(routes);
    return routes;
  }

  /// Rows that are constant may give velocities in place of forces.
  void append_elimination(std::vector<ConstraintRoute>& routes) const {
    const auto coupled = choose_dependents(seen_);
    if (!coupled) return;
    routes.push_back({{"eliminated", "joints that couplings move eliminated, M = L^T D L"},
                      [coupled = *coupled](const ConstraintTrace& trace) {
                        return trace_eliminated_motion(trace, coupled);
                      },
                      "finite everywhere; couplings hold exactly, and one that depends on those "
                      "before it has force 0."});
  }

  [[nodiscard]] Program trace(const ConstraintRoute& route) const {
    Program program;
    program.name = function_name(function_);
    program.equation = info_of(function_).equation;
    program.route = route.id;
    program.graph = Graph::for_trace(lanes_);
    const Graph::Scope scope(program.graph);
    ConstraintTrace trace;
    trace.tree = constant_tree<Expression>(seen_);
    take_inputs(program, trace);
    program.law = law_;
    if (law_) program.singular = route.singular.empty() ? describe(*law_) : route.singular;
    program.results = route.body(trace);
    return program;
  }

 private:
  void take_inputs(Program& program, ConstraintTrace& trace) const {
    const TracedInputs inputs(mechanism_, function_, program);
    apply_inputs(seen_, inputs, trace.tree);
    trace.q = inputs[Quantity::q];
    trace.qd = inputs[Quantity::qd];
    trace.qdd_0 = inputs[Quantity::qdd_0];
    trace.tau = inputs[Quantity::tau];
    trace.f_wanted = inputs[Quantity::f_wanted];
    trace.stabilisation = inputs[Quantity::stabilisation];
    trace.drift = inputs[Quantity::drift];
    if (const auto& step = inputs[Quantity::step]; !step.empty()) {
      make_drives_implicit<Expression>(trace.qd, step.front(), trace.tree);
      program.equation =
          "(M + step D + step^2 K) qdd + b + g + step K qd = tau + J_s^T f + J_ext^T f_ext, "
          "J_s qdd + Jd_s qd = -stabilisation[0] J_s qd - stabilisation[1] drift" +
          kImplicitTerms;
    }
    if (supports_) {
      const auto& asked = inputs[Quantity::xdd_cmd];
      for (const std::size_t row : task_row_order(mechanism_)) trace.xdd_cmd.push_back(asked[row]);
    }
    trace.X = joint_transforms<Expression>(trace.tree, inputs[Quantity::q]);
    defer_rotations(trace.tree, trace.X);
    const auto& f_ext = inputs[Quantity::f_ext];
    if (!f_ext.empty()) trace.applied = applied_wrenches<Expression>(trace.tree, trace.X, f_ext);
  }

  const Mechanism& mechanism_;
  Function function_;
  int lanes_;
  bool supports_;
  Mechanism seen_;
  std::shared_ptr<const TaskLaw> law_;
};

}  // namespace

std::vector<Program> trace_constraint_function(const Mechanism& mechanism, Function function,
                                               int lanes) {
  const ConstraintTracer tracer(mechanism, function, lanes);
  std::vector<Program> programs;
  PrunedAlgorithms pruned;
  for (const ConstraintRoute& route : tracer.routes()) {
    if (pruned.has(route.id)) continue;
    programs.push_back(tracer.trace(route));
    pruned.look_at(programs.back());
  }
  return programs;
}

}  // namespace treeline
