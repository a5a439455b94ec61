#include "recursion/routes/trace_loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "program/link_loops.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/make_link_table.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/tree/counted.hpp"
#include "recursion/tree/declare_inputs.hpp"
#include "recursion/tree/plain_expression.hpp"

// Vectors stand here where emitted code has arrays, which indices of any sign may index.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include "core/link_functions.hpp"
#pragma GCC diagnostic pop

namespace treeline {

namespace loops = core::loops;

namespace {

/// What is asked of a function that has this form.
struct LoopForm {
  Function function;
  const char* words;
  bool inertias = false, rows = false, solves = false;
};
constexpr LoopForm kForms[] = {
    {Function::inverse_dynamics, "recursive Newton-Euler"},
    {Function::nonlinear_effects, "recursive Newton-Euler"},
    {Function::gravity, "recursive Newton-Euler"},
    {Function::mass_matrix, "composite rigid bodies", true},
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

bool has_arguments(const MechanismInputs& inputs) {
  return inputs.gravity || !inputs.payloads.empty() || !inputs.parameters.empty() ||
         !inputs.base.empty() || !inputs.tools.empty();
}

/// What of a link the table has no place for; empty: nothing.
std::string find_obstacle(const MovingLink& link, bool is_first, bool given_sines) {
  const auto says = [&](const char* what) {
    return fmt::format("joint `{}` {}", link.joint, what);
  };
  if (link.is_of_ball()) return says("is a ball joint");
  if (link.is_floating()) return is_first ? "" : says("is floating, and not the base");
  const bool needs_sine = link.kind == JointKind::revolute && !link.spins;
  if (given_sines && needs_sine && link.multiplier != 1)
    return says("turns by a multiple of its coordinate");
  return {};
}

std::string find_obstacle(const Mechanism& mechanism, const LoopForm& form, bool given_sines) {
  if (has_arguments(mechanism.inputs)) return "what `inputs` of the scene makes arguments";
  if (!mechanism.external_forces.empty()) return "external forces";
  if (mechanism.implicit_friction && form.function == Function::forward_dynamics) {
    return "friction and springs at the end of a step (`implicit`)";
  }
  if (mechanism.links.empty()) return "a robot without joints";
  for (const MovingLink& link : mechanism.links) {
    const bool is_first = &link == &mechanism.links.front();
    const std::string found = find_obstacle(link, is_first, given_sines);
    if (!found.empty()) return found;
  }
  if (!form.rows) return {};
  for (const MechanismPoint& point : mechanism.operational_points) {
    if (point.link < 0) return fmt::format("point `{}` is fixed to the world", point.name);
    if (form.solves && point.priority != mechanism.operational_points.front().priority) {
      return "points of several priorities";
    }
  }
  return {};
}

template <class Number>
loops::Turn<Number> lifted(const loops::Turn<double>& r) {
  return {Number(r.c), Number(r.s)};
}

template <class Number, int size>
void lift(const double (&from)[size], Number (&to)[size]) {
  std::transform(std::begin(from), std::end(from), to, [](double x) { return Number(x); });
}

/// The table and work space of loops in another kind of number.
template <class Number>
struct LoopTrace {
  struct Motions {
    std::vector<loops::LinkPose<Number>> poses;
    loops::BasePose<Number> base;
    std::vector<loops::Spatial<Number>> wrenches;
    std::vector<loops::LinkMotion<Number>> motions;
  };
  struct Inertias {
    std::vector<loops::LinkInertia<Number>> inertias;
    std::vector<loops::LinkProjection<Number>> projections;
    std::vector<Number> base;
  };
  struct Rows {
    std::vector<loops::LinkAxes<Number>> link_axes;
    std::vector<loops::LinkMotion<Number>> point_motions;
    std::vector<loops::Spatial<Number>> forces;
    std::vector<std::int16_t> links;
    std::vector<Number> errors, Lambda_inv;
  };

  explicit LoopTrace(const LinkLoops& plan) {
    const LinkTableData& table = plan.table;
    for (const loops::Link<double>& from : table.links) {
      loops::Link<Number> to{from.parent,
                             from.slot,
                             from.slides,
                             lifted<Number>(from.a),
                             lifted<Number>(from.alpha),
                             lifted<Number>(from.b),
                             {},
                             Number(from.rotor),
                             Number(from.mass),
                             {},
                             {}};
      lift(from.p, to.p);
      lift(from.h, to.h);
      lift(from.J, to.J);
      links.push_back(to);
    }
    for (const loops::LinkPoint<double>& from : table.points) {
      loops::LinkPoint<Number> to{from.link, from.world, {}, {}};
      lift(from.axes, to.axes);
      lift(from.p, to.p);
      points.push_back(to);
    }
    for (const loops::LinkDrive<double>& from : table.drives) {
      drives.push_back({Number(from.damping), Number(from.stiffness), Number(from.rest)});
    }
    for (const loops::LinkFriction<double>& from : table.frictions) {
      frictions.push_back({Number(from.force), Number(from.sharpness)});
    }
    for (const loops::LinkCoupling<double>& from : table.couplings) {
      couplings.push_back({from.joint, Number(from.multiplier), from.spins});
    }
    joints = table.joints;
    for (const double yield : plan.yields) yields.push_back(Number(yield));
    const auto n = table.links.size();
    const auto slots = static_cast<std::size_t>(table.slots);
    const std::size_t count = table.rows.size();
    motions.poses.resize(n);
    motions.wrenches.resize(n);
    motions.motions.resize(slots);
    inertias.inertias.resize(slots);
    inertias.projections.resize(n);
    const auto nv = static_cast<std::size_t>(table.joints) + 6;
    inertias.base.resize(nv * (nv + count));
    rows.link_axes.resize(table.points.size());
    rows.point_motions.resize(table.points.size());
    rows.forces.resize(count);
    rows.links.resize(count);
    rows.errors.resize(count);
    rows.Lambda_inv.resize(count * count);
  }

  template <bool floats, bool coupled>
  [[nodiscard]] loops::LinkTable<Number, floats, true, true, true, coupled> table_of(
      const LinkTableData& from) const {
    const auto& g = from.gravity;
    return {links.data(),
            static_cast<int>(links.size()),
            from.slots,
            {Number(g[0]), Number(g[1]), Number(g[2])},
            points.data(),
            static_cast<int>(points.size()),
            from.rows.data(),
            static_cast<int>(from.rows.size()),
            drives.empty() ? nullptr : drives.data(),
            frictions.empty() ? nullptr : frictions.data(),
            couplings.data(),
            joints};
  }

  std::vector<loops::Link<Number>> links;
  std::vector<loops::LinkPoint<Number>> points;
  std::vector<loops::LinkDrive<Number>> drives;
  std::vector<loops::LinkFriction<Number>> frictions;
  std::vector<loops::LinkCoupling<Number>> couplings;
  int joints = 0;
  std::vector<Number> yields;
  Motions motions;
  Inertias inertias;
  Rows rows;
};

/// Sines as the function takes them: `GivenSines` of the headers, or else `ComputedSines`.
template <class Number>
struct TracedSines {
  const Number* sin_q;  ///< null: they are computed
  const Number* cos_q;

  void operator()(int i, const Number& angle, Number& sine, Number& cosine) const {
    if (sin_q == nullptr) {
      loops::ComputedSines{}(i, angle, sine, cosine);
    } else {
      loops::GivenSines<Number>{sin_q, cos_q}(i, angle, sine, cosine);
    }
  }
};

/// Arguments of a function that loops, and its result.
template <class Number>
struct LoopArguments {
  std::vector<Number> q, qd, qdd, tau, xdd_cmd, result;
  std::vector<Number> sin_q, cos_q;  ///< empty: they are computed

  [[nodiscard]] TracedSines<Number> sines() const {
    return {sin_q.empty() ? nullptr : sin_q.data(), cos_q.data()};
  }
};

template <int power, class Number, class Table>
void run_law(Function function, const Table& table, LoopTrace<Number>& trace,
             LoopArguments<Number>& with) {
  const TracedSines<Number> sines = with.sines();
  if (function == Function::lambda) {
    loops::lambda<power>(table, trace.yields.data(), with.q.data(), sines, with.result.data(),
                         trace.motions, trace.inertias, trace.rows);
  } else {
    loops::control_torque<power>(table, trace.yields.data(), with.q.data(), sines, with.qd.data(),
                                 with.qdd.data(), with.xdd_cmd.data(), with.result.data(),
                                 trace.motions, trace.inertias, trace.rows);
  }
}

template <class Number, class Table>
void run(Function function, int power, const Table& table, LoopTrace<Number>& trace,
         LoopArguments<Number>& with) {
  const TracedSines<Number> sines = with.sines();
  const Number* const q = with.q.data();
  const Number* const qd = with.qd.data();
  Number* const result = with.result.data();
  switch (function) {
    case Function::inverse_dynamics:
      return loops::inverse_dynamics(table, q, sines, qd, std::as_const(with.qdd).data(), result,
                                     trace.motions);
    case Function::nonlinear_effects:
      return loops::nonlinear_effects(table, q, sines, qd, result, trace.motions);
    case Function::gravity:
      return loops::gravity(table, q, sines, result, trace.motions);
    case Function::mass_matrix:
      return loops::mass_matrix(table, q, sines, result, trace.motions, trace.inertias);
    case Function::forward_dynamics:
      return loops::forward_dynamics(table, q, sines, qd, std::as_const(with.tau).data(), result,
                                     trace.motions, trace.inertias);
    case Function::lambda_inverse:
      return loops::lambda_inverse(table, q, sines, result, trace.motions, trace.inertias,
                                   trace.rows);
    default:
      if (power == 0) return run_law<0>(function, table, trace, with);
      if (power == 4) return run_law<4>(function, table, trace, with);
      return run_law<6>(function, table, trace, with);
  }
}

template <class Number>
void run(Function function, const LinkLoops& plan, LoopArguments<Number>& with) {
  LoopTrace<Number> trace(plan);
  const auto run_on = [&](const auto& table) { run(function, plan.power, table, trace, with); };
  const bool coupled = !plan.table.couplings.empty();
  if (plan.table.floats && coupled) {
    run_on(trace.template table_of<true, true>(plan.table));
  } else if (plan.table.floats) {
    run_on(trace.template table_of<true, false>(plan.table));
  } else if (coupled) {
    run_on(trace.template table_of<false, true>(plan.table));
  } else {
    run_on(trace.template table_of<false, false>(plan.table));
  }
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

void take_law(const Mechanism& mechanism, LinkLoops& plan, Program& program) {
  program.law =
      TaskLaws(mechanism).find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {});
  program.singular = program.law ? describe(*program.law) : kBareSolve;
  if (!program.law) return;
  plan.power = program.law->rule.power;
  for (const double border : program.law->rule.borders) {
    const double cube = border * border * border;
    plan.yields.push_back(plan.power == 4 ? cube * border : cube * cube);
  }
}

/// What the loops execute, constants 0 and 1 included.
void count(Function function, const LoopArguments<PlainExpression>& with, LinkLoops& plan) {
  const auto numbers = [](const auto& from) { return std::vector<Counted>(from.size()); };
  LoopArguments<Counted> counted{numbers(with.q),     numbers(with.qd),      numbers(with.qdd),
                                 numbers(with.tau),   numbers(with.xdd_cmd), numbers(with.result),
                                 numbers(with.sin_q), numbers(with.cos_q)};
  const CountedOperations operations;
  run(function, plan, counted);
  plan.adds = operations.since().add;
  plan.muls = operations.since().mul;
  plan.divs = operations.since().div;
  plan.sines = operations.since().sin_cos;
}

}  // namespace

TracedLoops trace_loops(const Mechanism& mechanism, Function function, const Program& lines,
                        bool given_sines) {
  const LoopForm* const form = find_form(function);
  if (form == nullptr) return {};
  if (auto obstacle = find_obstacle(mechanism, *form, given_sines); !obstacle.empty()) {
    return {std::nullopt, std::move(obstacle)};
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
  plan->uses_inertias = form->inertias;
  plan->uses_rows = form->rows;
  plan->solves = form->solves;
  if (form->solves) take_law(mechanism, *plan, program);
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
      {}};
  if (given_sines) give_sines(mechanism, program.graph, with);
  run(function, *plan, with);
  count(function, with, *plan);
  program.results = {{result.argument, {}}};
  for (const PlainExpression& each : with.result) {
    program.results.front().values.push_back(each.value());
  }
  program.loops = plan;
  return {std::move(program), {}};
}

}  // namespace treeline
