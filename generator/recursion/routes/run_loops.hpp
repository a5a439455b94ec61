#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "functions/function.hpp"
#include "program/emitted_links.hpp"
#include "program/link_loops.hpp"

namespace treeline {

/// The table in another kind of number, as arguments of the function change it.
template <class Number>
class LiftedTable {
 public:
  using Loops = EmittedLinks<Number>;
  using Table = typename Loops::TlLinkTable;

  LiftedTable(const LinkTableData& from, Loops& loops) : from_(from), loops_(loops) {
    for (const double g : from.gravity) gravity_.push_back(Number(g));
    for (const LinkTypes::TlLink& link : from.links) links_.push_back(lifted(link));
    for (const LinkTypes::TlLinkPoint& point : from.points) points_.push_back(lifted(point));
    for (const LinkTypes::TlPointRow& row : from.rows) {
      rows_.push_back({row.point, row.axis, row.angular});
    }
    for (const LinkTypes::TlLinkPoint& point : from.pushed_points) {
      pushed_points_.push_back(lifted(point));
    }
    for (const LinkTypes::TlLinkDrive& drive : from.drives) {
      drives_.push_back({Number(drive.damping), Number(drive.stiffness), Number(drive.rest)});
    }
    for (const LinkTypes::TlLinkFriction& friction : from.frictions) {
      frictions_.push_back({Number(friction.force), Number(friction.sharpness)});
    }
    for (const LinkTypes::TlLinkCoupling& coupling : from.couplings) {
      couplings_.push_back(
          {coupling.joint, Number(coupling.multiplier), coupling.spins, coupling.own_sine});
    }
    lift_joints();
    row_entries_ = from.row_entries;
    for (auto r = row_entries_.size(); r < from.rows.size(); ++r) {
      row_entries_.push_back(static_cast<std::int16_t>(r));
    }
    bodies_.resize(from.loaded_links.size());
    loops_.tl_copy_bodies(links_.data(), from.loaded_links.data(), count(bodies_), bodies_.data());
  }

  void set_gravity(const std::vector<Number>& given) { gravity_ = given; }
  void set_external_forces(const std::vector<Number>& given) { f_ext_ = given; }

  /// Applies the run-time argument that `input` describes to the table.
  void take(const LinkInput& input, const std::vector<Number>& given) {
    std::vector<typename Loops::TlInputFrame> frames;
    for (const LinkTypes::TlInputFrame& from : input.frames) {
      typename Loops::TlInputFrame frame{from.of, from.at, {}, {}};
      lift(from.R.Q, frame.R.Q);
      lift(from.p, frame.p);
      frames.push_back(frame);
    }
    switch (input.gives) {
      case LinkInput::Gives::bodies:
        if (input.entries.empty()) {
          return loops_.tl_add_bodies(frames.data(), count(frames), given.data(), bodies_.data());
        }
        return loops_.tl_add_parts_of_bodies(frames.data(), count(frames), input.entries.data(),
                                             count(input.entries), given.data(), bodies_.data());
      case LinkInput::Gives::origins:
        return loops_.tl_move_points(frames.data(), count(frames), given.data(), points_.data());
      case LinkInput::Gives::axes:
        return loops_.tl_turn_points(frames.data(), count(frames), given.data(), points_.data());
      case LinkInput::Gives::rotors:
      case LinkInput::Gives::dampings:
      case LinkInput::Gives::frictions:
        return take_numbers(input, given);
    }
  }

  [[nodiscard]] Table view() const {
    return {links_.data(),
            count(links_),
            from_.slots,
            {gravity_[0], gravity_[1], gravity_[2]},
            points_.data(),
            count(points_),
            rows_.data(),
            count(rows_),
            couplings_.data(),
            from_.joints,
            row_entries_.data(),
            rotors_.empty() ? nullptr : rotors_.data(),
            nullptr,
            drives_.empty() ? nullptr : drives_.data(),
            frictions_.empty() ? nullptr : frictions_.data(),
            balls_.data(),
            pushed_points_.data(),
            count(pushed_points_),
            f_ext_.empty() ? nullptr : f_ext_.data(),
            bodies_.data(),
            from_.loaded_links.data(),
            count(bodies_)};
  }

 private:
  template <class Each>
  static std::int32_t count(const std::vector<Each>& of) {
    return static_cast<std::int32_t>(of.size());
  }

  /// Applies a run-time argument about joints to the table.
  void take_numbers(const LinkInput& input, const std::vector<Number>& given) {
    std::vector<typename Loops::TlInputNumber> numbers;
    for (const LinkTypes::TlInputNumber& from : input.numbers) {
      numbers.push_back({from.of, from.at, Number(from.factor)});
    }
    if (input.gives == LinkInput::Gives::dampings) {
      return loops_.tl_give_dampings(numbers.data(), count(numbers), given.data(), drives_.data());
    }
    if (input.gives == LinkInput::Gives::frictions) {
      return loops_.tl_give_frictions(numbers.data(), count(numbers), given.data(),
                                      frictions_.data());
    }
    rotors_.resize(links_.size());
    loops_.tl_copy_rotors(links_.data(), count(links_), rotors_.data());
    loops_.tl_give_rotors(numbers.data(), count(numbers), given.data(), rotors_.data());
  }

  static typename Loops::TlTurn lifted(const LinkTypes::TlTurn& r) {
    return {Number(r.c), Number(r.s)};
  }

  template <int size>
  static void lift(const double (&from)[size], Number (&to)[size]) {
    std::transform(std::begin(from), std::end(from), to, [](double x) { return Number(x); });
  }

  static typename Loops::TlLink lifted(const LinkTypes::TlLink& from) {
    typename Loops::TlLink to{from.parent,
                              from.slot,
                              from.end,
                              from.slides,
                              from.starts,
                              lifted(from.a),
                              lifted(from.alpha),
                              lifted(from.b),
                              {},
                              Number(from.rotor),
                              {Number(from.body.mass), {}, {}}};
    lift(from.p, to.p);
    lift(from.body.h, to.body.h);
    lift(from.body.J, to.body.J);
    return to;
  }

  /// Places of the joints' coordinates, which only a table with ball joints lists.
  void lift_joints() {
    for (const LinkTypes::TlLinkBall& ball : from_.balls) {
      balls_.push_back({ball.axis, ball.rotation, ball.q});
    }
    for (std::size_t i = balls_.size(); i < links_.size(); ++i) {
      const int joint = couplings_.empty() ? static_cast<int>(i) : couplings_[i].joint;
      const int at = from_.floats && joint > 0 ? joint + 6 : joint;
      balls_.push_back({0, 0, static_cast<std::int16_t>(at)});
    }
  }

  static typename Loops::TlLinkPoint lifted(const LinkTypes::TlLinkPoint& from) {
    typename Loops::TlLinkPoint to{from.link, from.world, {}, {}};
    lift(from.axes, to.axes);
    lift(from.p, to.p);
    return to;
  }

  const LinkTableData& from_;
  Loops& loops_;
  std::vector<Number> gravity_;
  std::vector<typename Loops::TlLink> links_;
  std::vector<typename Loops::TlLinkPoint> points_, pushed_points_;
  std::vector<typename Loops::TlPointRow> rows_;
  std::vector<Number> f_ext_;
  std::vector<typename Loops::TlLinkDrive> drives_;
  std::vector<typename Loops::TlLinkFriction> frictions_;
  std::vector<typename Loops::TlLinkCoupling> couplings_;
  std::vector<typename Loops::TlLinkBall> balls_;
  std::vector<std::int16_t> row_entries_;
  std::vector<typename Loops::TlLinkBody> bodies_;
  std::vector<Number> rotors_;  ///< inertias of rotors that an argument gives
};

/// Arguments of a function that loops, and its result.
template <class Number>
struct LoopArguments {
  std::vector<Number> q, qd, qdd, tau, xdd_cmd, result;
  std::vector<Number> sin_q, cos_q;         ///< empty: they are computed
  std::vector<Number> f_ext;                ///< empty: none
  std::vector<Number> gravity;              ///< empty: as the table says
  std::vector<std::vector<Number>> inputs;  ///< of the table's
  std::vector<Number> step;                 ///< empty: none
};

/// The loops, and the work space that they need for a robot.
template <class Number>
struct LoopTrace {
  using Loops = EmittedLinks<Number>;

  LoopTrace(const LinkLoops& plan, bool given_sines)
      : loops{.TL_FLOATS = plan.table.floats,
              .TL_COUPLED = !plan.table.couplings.empty(),
              .TL_GIVEN_SINES = given_sines},
        table(plan.table, loops) {
    const LinkTableData& of = plan.table;
    for (const double yield : plan.yields) yields.push_back(Number(yield));
    const auto n = of.links.size();
    const auto slots = static_cast<std::size_t>(of.slots);
    const std::size_t count = of.rows.size();
    motions.poses.joints.resize(n);
    motions.poses.rotations.resize(static_cast<std::size_t>(of.rotations));
    motions.wrenches.resize(n);
    motions.motions.resize(slots);
    inertias.inertias.resize(slots);
    inertias.projections.resize(n);
    auto& matrix = inertias.matrix;
    matrix.frames.resize(n);
    matrix.bodies.resize(n);
    for (auto* each :
         {&matrix.f_x, &matrix.f_y, &matrix.f_z, &matrix.n_x, &matrix.n_y, &matrix.n_z}) {
      each->resize(n);
    }
    const auto nv = static_cast<std::size_t>(of.joints) + 6;
    inertias.base.resize(nv * (nv + count));
    rows.link_axes.resize(of.points.size());
    rows.point_motions.resize(of.points.size());
    rows.forces.resize(count);
    rows.links.resize(count);
    rows.errors.resize(count);
    rows.Lambda_inv.resize(count * count);
    rows.inverse_borders.resize(count);
  }

  Loops loops;
  LiftedTable<Number> table;
  std::vector<Number> yields;
  typename Loops::TlMotionWork motions;
  typename Loops::TlFactorWork inertias;
  typename Loops::TlRowWork rows;
};

template <class Number>
void run(Function function, int power, const typename EmittedLinks<Number>::TlLinkTable& table,
         LoopTrace<Number>& trace, LoopArguments<Number>& with) {
  auto& [loops, lifted, yields, motions, inertias, rows] = trace;
  const Number* const q = with.q.data();
  const Number* const qd = with.qd.data();
  Number* const result = with.result.data();
  switch (function) {
    case Function::inverse_dynamics:
      return loops.tl_inverse_dynamics(&table, q, qd, with.qdd.data(), result, &motions);
    case Function::nonlinear_effects:
      return loops.tl_nonlinear_effects(&table, q, qd, result, &motions);
    case Function::gravity:
      return loops.tl_gravity(&table, q, result, &motions);
    case Function::mass_matrix:
      return loops.tl_mass_matrix(&table, q, result, &motions, &inertias.matrix);
    case Function::forward_dynamics:
      return loops.tl_forward_dynamics(&table, q, qd, with.tau.data(), result, &motions, &inertias);
    case Function::lambda_inverse:
      return loops.tl_lambda_inverse(&table, q, result, &motions, &inertias, &rows);
    case Function::lambda:
      return loops.tl_lambda(power, &table, yields.data(), q, result, &motions, &inertias, &rows);
    default:
      return loops.tl_control_torque(power, &table, yields.data(), q, qd, with.qdd.data(),
                                     with.xdd_cmd.data(), result, &motions, &inertias, &rows);
  }
}

template <class Number>
void run(Function function, const LinkLoops& plan, LoopArguments<Number>& with) {
  LoopTrace<Number> trace(plan, !with.sin_q.empty());
  if (!with.f_ext.empty()) trace.table.set_external_forces(with.f_ext);
  if (!with.gravity.empty()) trace.table.set_gravity(with.gravity);
  for (std::size_t i = 0; i < with.inputs.size(); ++i) {
    trace.table.take(plan.table.inputs[i], with.inputs[i]);
  }
  trace.motions.poses.sin_q = with.sin_q.data();
  trace.motions.poses.cos_q = with.cos_q.data();
  auto table = trace.table.view();
  std::vector<Number> rotors(with.step.empty() ? 0 : plan.table.links.size());
  if (!with.step.empty()) {
    table.step = with.step.data();
    trace.loops.tl_find_rotors(&table, with.qd.data(), rotors.data());
    table.rotors = rotors.data();
  }
  run(function, plan.power, table, trace, with);
}

}  // namespace treeline
