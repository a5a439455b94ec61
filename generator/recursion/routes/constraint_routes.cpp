#include <memory>
#include <string>
#include <utility>

#include "recursion/methods/eliminated_control_torque.hpp"
#include "recursion/methods/eliminated_forward_dynamics.hpp"
#include "recursion/methods/operational_quantities.hpp"
#include "recursion/methods/supported_control_torque.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/describe_choice.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/routes_of_groups.hpp"
#include "recursion/tree/supported_mechanism.hpp"

namespace treeline {
namespace {

/// Shares to which rows are held; empty where no constraint comes and goes.
std::vector<Expression> held_shares(const Trace& trace) {
  return shares_of_rows<Expression>(trace.mechanism->inputs.active,
                                    static_cast<std::size_t>(trace.mechanism->held_rows()),
                                    trace.in[Quantity::active]);
}

ConstrainedInputs<Expression> motion_inputs(const Trace& trace) {
  return {trace.q(),
          trace.qd(),
          trace.tau(),
          trace.in[Quantity::stabilisation],
          trace.in[Quantity::drift],
          trace.applied(),
          held_shares(trace)};
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

template <class Velocities>
std::vector<Result> trace_eliminated_motion(const Trace& trace, const Velocities& velocities) {
  return motion_results(eliminated_forward_dynamics<Expression>(trace.tree, trace.X,
                                                                motion_inputs(trace), velocities));
}

std::vector<Expression> asked_of_tasks(const Trace& trace) {
  const auto& asked = trace.in[Quantity::xdd_cmd];
  std::vector<Expression> xdd_cmd;
  for (const std::size_t row : task_row_order(*trace.mechanism)) xdd_cmd.push_back(asked[row]);
  return xdd_cmd;
}

SupportedInputs<Expression> torque_inputs(const Trace& trace,
                                          const std::vector<Expression>& xdd_cmd) {
  return {{trace.qd(), trace.qdd()},
          xdd_cmd,
          trace.in[Quantity::f_wanted],
          trace.applied(),
          held_shares(trace)};
}

std::vector<Result> torque_results(const SupportedTorque<Expression>& torque) {
  std::vector<Result> results{
      vector_result("tau", "joint forces, 0 where no motor is", torque.tau)};
  if (!torque.f.empty()) {
    results.push_back(vector_result(
        "f", "forces of the constraints on the robot, in their rows, N, N m", torque.f));
  }
  return results;
}

std::vector<Result> trace_supported_torque(const Trace& trace, const LambdaChoice& choice,
                                           const SupportRules& rules,
                                           const std::vector<int>& passive) {
  const auto xdd_cmd = asked_of_tasks(trace);
  return torque_results(supported_control_torque<Expression>(
      trace.tree, trace.X, torque_inputs(trace, xdd_cmd), passive, choice, rules));
}

std::vector<Result> trace_eliminated_torque(const Trace& trace, const LoopedVelocities& looped,
                                            const PivotRule& rule) {
  const auto xdd_cmd = asked_of_tasks(trace);
  return torque_results(eliminated_control_torque<Expression>(
      trace.tree, trace.X, torque_inputs(trace, xdd_cmd), looped, rule));
}

std::vector<Result> trace_constraint_jacobian(const Trace& trace) {
  const auto tasks = task_points(trace.tree, {}, world_poses(trace.tree, trace.X));
  std::size_t anchored = 0;
  for (const auto& task : tasks) anchored += task.rows.size();
  return {matrix_result("J_s", "Jacobian of the rows that are held",
                        jacobian_with_loops(trace.tree, trace.X, tasks, anchored,
                                            loop_jacobian(trace.tree, trace.X)))};
}

std::vector<Result> trace_constraint_errors(const Trace& trace) {
  const std::vector<Expression> rest(static_cast<std::size_t>(trace.tree.nv), Expression(0.0));
  return {vector_result("error", "how far loops and couplings are from closed, m, 1, rad",
                        loop_rows<Expression>(trace.tree, trace.X, trace.q(), rest).errors)};
}

using Law = std::shared_ptr<const TaskLaw>;

constexpr const char* kEliminatedWords = "passive joints of loops eliminated, M = L^T D L";

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

/// By which passive velocities yield, then the rows of tasks.
TaskLaw law_of(const LoopedVelocities& looped, const Mechanism& seen) {
  TaskLaw law;
  law.kind = TaskLaw::Kind::eliminated;
  law.mechanism = std::make_shared<const Mechanism>(seen);
  law.rule = looped.rule;
  for (std::size_t k = 0; k < looped.rows.size(); ++k) {
    law.pivots.push_back({looped.rows[k], looped.dependent[k]});
  }
  return law;
}

void append_loop_elimination(const RouteQuery& query, std::vector<Route>& routes) {
  const LoopDependents chosen = choose_loop_dependents(query.seen);
  if (!chosen.velocities) return;
  TaskLaw law = law_of(*chosen.velocities, query.seen);
  law.only_by_name = !chosen.velocities->follows;
  routes.push_back({{kEliminatedKey, kEliminatedWords},
                    [looped = *chosen.velocities](const Trace& trace) {
                      return trace_eliminated_motion(trace, looped);
                    },
                    std::make_shared<const TaskLaw>(std::move(law))});
}

/// Adds elimination for torques, where loops determine every joint without a motor and every row is
/// needed: then forces are unique. Where passive joints do not follow, no forces are a solution.
void append_eliminated_torque(const RouteQuery& query, const TaskLaw& supported,
                              std::vector<Route>& routes) {
  if (!why_not_eliminated(query.seen, query.function).empty()) return;
  const LoopDependents chosen = choose_loop_dependents(query.seen);
  const std::size_t rows = chosen.velocities->rows.size();
  TaskLaw law = law_of(*chosen.velocities, query.seen);
  const PivotRule of_rows = split_rules(supported).rows;
  const PivotRule of_tasks{
      of_rows.power,
      {of_rows.borders.begin() + static_cast<std::ptrdiff_t>(rows), of_rows.borders.end()}};
  law.rule.borders.insert(law.rule.borders.end(), of_tasks.borders.begin(), of_tasks.borders.end());
  const std::string singular = describe(law) + " Rows of tasks yield likewise.";
  routes.push_back({{kEliminatedKey, kEliminatedWords},
                    [looped = *chosen.velocities, of_tasks](const Trace& trace) {
                      return trace_eliminated_torque(trace, looped, of_tasks);
                    },
                    std::make_shared<const TaskLaw>(std::move(law)),
                    singular});
}

/// Rows that are constant, and those of loops that determine passive joints, may give velocities in
/// place of forces.
void append_elimination(const RouteQuery& query, const Law& law, std::vector<Route>& routes) {
  if (!query.seen.inputs.active.empty()) return;
  if (!query.seen.loops.empty()) append_loop_elimination(query, routes);
  const auto coupled = choose_dependents(query.seen);
  if (!coupled) return;
  routes.push_back(
      {{kEliminatedKey, "joints that couplings move eliminated, M = L^T D L"},
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
  if (supports && !query.seen.loops.empty()) append_eliminated_torque(query, *law, routes);
  if (!supports) append_elimination(query, law, routes);
  return routes;
}

}  // namespace

std::string why_not_eliminated(const Mechanism& mechanism, Function function) {
  if (!mechanism.inputs.active.empty()) return "Leave out the input `active`.";
  if (function == Function::constrained_forward_dynamics) {
    return choose_dependents(mechanism) ? "" : choose_loop_dependents(mechanism).obstacle;
  }
  if (function != Function::supported_control_torque) return "Nothing is held.";
  if (!mechanism.inputs.active_tasks.empty()) return "Leave out tasks of the input `active`.";
  if (mechanism.singular == SingularTasks::exact) return "Write `singular: smooth`.";
  const LoopDependents chosen = choose_loop_dependents(mechanism);
  if (!chosen.velocities) return chosen.obstacle;
  if (chosen.velocities->rows.size() != mechanism.passive.size()) {
    return "Other passive joints move by themselves.";
  }
  return chosen.velocities->rows.size() == static_cast<std::size_t>(mechanism.held_rows())
             ? ""
             : "Leave out rows that the rest of the loop prevents.";
}

std::vector<Route> constraint_routes(const RouteQuery& query) {
  if (query.function == Function::constraint_jacobian) {
    return {{{"inward", "rows carried inward"}, trace_constraint_jacobian}};
  }
  if (query.function == Function::constraint_errors) {
    return {{{"around", "frames carried around the loop"}, trace_constraint_errors}};
  }
  return solving_routes(query);
}

}  // namespace treeline
