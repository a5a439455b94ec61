#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "program/link_loops.hpp"
#include "recursion/methods/prioritized_task_force.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/make_link_table.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/run_loops.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/tree/counted.hpp"
#include "recursion/tree/declare_inputs.hpp"
#include "recursion/tree/plain_expression.hpp"

namespace treeline {

namespace {

/// A function that loops can compute, the words for its method, and the work that it needs.
struct LoopForm {
  Function function;
  const char* words;
  bool factors = false, rows = false, solves = false;
};
constexpr LoopForm kForms[] = {
    {Function::inverse_dynamics, "recursive Newton-Euler"},
    {Function::nonlinear_effects, "recursive Newton-Euler"},
    {Function::gravity, "recursive Newton-Euler"},
    {Function::mass_matrix, "composite rigid bodies"},
    {Function::forward_dynamics, "recursive Newton-Euler, articulated bodies", true},
    {Function::lambda_inverse, "unit forces propagated inward (PV-OSIM)", true, true},
    {Function::lambda, "unit forces propagated inward (PV-OSIM), LDL^T", true, true, true},
    {Function::control_torque, "Chang table 6.1, fused; unit forces propagated inward (PV-OSIM)",
     true, true, true}};

const LoopForm* find_form(Function function) {
  const auto* const at = std::find_if(std::begin(kForms), std::end(kForms),
                                      [&](const auto& form) { return form.function == function; });
  return at == std::end(kForms) ? nullptr : at;
}

/// Inputs of the sines and cosines of coordinates that are angles.
void give_sines(const Mechanism& mechanism, Graph& graph, LoopArguments<PlainExpression>& with) {
  for (std::size_t i = 0; i < with.q.size(); ++i) {
    const bool turns = mechanism.coordinates[i].is_angle();
    const auto input = [&](const char* name) {
      return turns ? PlainExpression(graph.input(fmt::format("{}[{}]", name, i)))
                   : PlainExpression();
    };
    with.sin_q.push_back(input("sin_q"));
    with.cos_q.push_back(input("cos_q"));
  }
}

/// Place of row `r` of the table in the scene's order.
std::size_t entry_of(const LinkTableData& table, std::size_t r) {
  return table.row_entries.empty() ? r : static_cast<std::size_t>(table.row_entries[r]);
}

/// Rows in the order of priority yield by what their points have left, be it with a law or without.
void take_floors(const Tree<double>& tree, LinkLoops& plan, const TaskLaw* law) {
  constexpr double kLargest = 0x1p100;  // of rows that nothing moves: they yield completely
  plan.power = kPowerOfPriorities;
  for (std::size_t r = 0; r < plan.table.rows.size(); ++r) {
    const LinkTypes::TlPointRow& row = plan.table.rows[r];
    const int link = tree.operational_points[static_cast<std::size_t>(row.point)].link;
    const double floor = law == nullptr ? 0 : law->rule.borders[entry_of(plan.table, r)];
    plan.yields.push_back(may_move(tree, link, row.angular) ? floor : kLargest);
  }
}

void take_law(const Mechanism& mechanism, Function function, LinkLoops& plan, Program& program) {
  const auto tree = constant_tree<double>(mechanism);
  const bool ranked = function == Function::control_torque && has_priorities(tree);
  program.law =
      TaskLaws(mechanism).find(ranked ? TaskLaw::Kind::priorities : TaskLaw::Kind::inverse_inertia,
                               LawPoints::operational, {});
  program.singular = program.law ? describe(*program.law) : kBareSolve;
  if (ranked) return take_floors(tree, plan, program.law.get());
  if (!program.law) return;
  plan.power = program.law->rule.power;
  for (const double border : program.law->rule.borders) {
    const double cube = border * border * border;
    plan.yields.push_back(plan.power == 4 ? cube * border : cube * cube);
  }
}

/// Counts the operations that the loops execute, constants 0 and 1 included.
void count(Function function, const LoopArguments<PlainExpression>& with, LinkLoops& plan) {
  const auto numbers = [](const auto& from) { return std::vector<Counted>(from.size()); };
  LoopArguments<Counted> counted{numbers(with.q),
                                 numbers(with.qd),
                                 numbers(with.qdd),
                                 numbers(with.tau),
                                 numbers(with.xdd_cmd),
                                 numbers(with.result),
                                 numbers(with.sin_q),
                                 numbers(with.cos_q),
                                 numbers(with.f_ext),
                                 numbers(with.gravity),
                                 {},
                                 numbers(with.step)};
  for (const auto& input : with.inputs) counted.inputs.push_back(numbers(input));
  const CountedOperations operations;
  run(function, plan, counted);
  plan.adds = operations.since().add;
  plan.muls = operations.since().mul;
  plan.divs = operations.since().div;
  plan.sines = operations.since().sin_cos;
}

}  // namespace

bool has_loop_form(Function function) {
  return find_form(function) != nullptr;
}

std::optional<Program> trace_loops(const Mechanism& mechanism, Function function,
                                   const Program& lines, bool given_sines) {
  const LoopForm* const form = find_form(function);
  const bool shares_tasks = takes(function, Quantity::active_tasks);
  if (form == nullptr || (shares_tasks && !mechanism.inputs.active_tasks.empty()) ||
      (form->rows && has_center_of_mass(mechanism))) {
    return std::nullopt;
  }
  Program program;
  program.name = lines.name;
  program.equation = lines.equation;
  program.route = {kLoopsKey, fmt::format("loops over a table of links: {}", form->words)};
  program.graph = Graph::for_trace(1);
  program.graph.forget_names();
  const Graph::Scope scope(program.graph);
  const TracedInputs inputs(mechanism, function, program);
  const auto plan = std::make_shared<LinkLoops>();
  plan->function = function_name(function);
  plan->table = make_link_table(mechanism, form->rows);
  plan->uses_factors = form->factors;
  plan->uses_matrix = form->function == Function::mass_matrix;
  plan->uses_rows = form->rows;
  plan->solves = form->solves;
  plan->uses_friction = takes(function, Quantity::qd);
  if (form->solves) take_law(mechanism, function, *plan, program);
  const Result& result = lines.results.front();
  const auto plain = [&](Quantity quantity) {
    std::vector<PlainExpression> entries;
    for (const Expression& entry : inputs[quantity]) entries.emplace_back(entry);
    return entries;
  };
  LoopArguments<PlainExpression> with{
      plain(Quantity::q),
      plain(Quantity::qd),
      plain(takes(function, Quantity::qdd_0) ? Quantity::qdd_0 : Quantity::qdd),
      plain(Quantity::tau),
      plain(Quantity::xdd_cmd),
      std::vector<PlainExpression>(result.values.size()),
      {},
      {},
      plain(Quantity::f_ext),
      plain(Quantity::gravity),
      {},
      plain(Quantity::step)};
  if (!with.f_ext.empty()) plan->f_ext = symbol_of(Quantity::f_ext);
  if (!with.gravity.empty()) plan->gravity = symbol_of(Quantity::gravity);
  if (!with.step.empty()) plan->step = symbol_of(Quantity::step);
  for (const LinkInput& input : plan->table.inputs) {
    with.inputs.push_back(plain(find_quantity(input.argument).value()));
  }
  if (given_sines) give_sines(mechanism, program.graph, with);
  run(function, *plan, with);
  count(function, with, *plan);
  program.results = {{result.argument, {}}};
  for (const PlainExpression& each : with.result) {
    program.results.front().values.push_back(each.value());
  }
  program.loops = plan;
  return program;
}

}  // namespace treeline
