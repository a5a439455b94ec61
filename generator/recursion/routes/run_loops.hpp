#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "functions/function.hpp"
#include "program/link_loops.hpp"

// Vectors stand here where emitted code has arrays, which indices of any sign may index.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include "core/link_functions.hpp"
#include "core/link_inputs.hpp"
#pragma GCC diagnostic pop

namespace treeline {

namespace loops = core::loops;

/// The table in another kind of number, as arguments of the function change it.
template <class Number>
class LiftedTable {
 public:
  explicit LiftedTable(const LinkTableData& from) : from_(from) {
    for (const double g : from.gravity) gravity_.push_back(Number(g));
    for (const loops::Link<double>& link : from.links) links_.push_back(lifted(link));
    for (const loops::LinkPoint<double>& point : from.points) points_.push_back(lifted(point));
    for (const loops::LinkPoint<double>& point : from.pushed_points) {
      pushed_points_.push_back(lifted(point));
    }
    for (const loops::LinkDrive<double>& drive : from.drives) {
      drives_.push_back({Number(drive.damping), Number(drive.stiffness), Number(drive.rest)});
    }
    for (const loops::LinkFriction<double>& friction : from.frictions) {
      frictions_.push_back({Number(friction.force), Number(friction.sharpness)});
    }
    for (const loops::LinkCoupling<double>& coupling : from.couplings) {
      couplings_.push_back(
          {coupling.joint, Number(coupling.multiplier), coupling.spins, coupling.own_sine});
    }
    balls_ = from.balls.empty() ? other_joints(from) : from.balls;
    row_entries_ = from.row_entries;
    for (auto r = row_entries_.size(); r < from.rows.size(); ++r) {
      row_entries_.push_back(static_cast<std::int16_t>(r));
    }
    bodies_.resize(from.loaded_links.size());
    loops::copy_bodies(links_.data(), from.loaded_links.data(), static_cast<int>(bodies_.size()),
                       bodies_.data());
  }

  void set_gravity(const std::vector<Number>& given) { gravity_ = given; }
  void set_external_forces(const std::vector<Number>& given) { f_ext_ = given; }

  /// Applies the run-time argument that `input` describes to the table.
  void take(const LinkInput& input, const std::vector<Number>& given) {
    std::vector<loops::InputFrame<Number>> frames;
    for (const loops::InputFrame<double>& from : input.frames) {
      loops::InputFrame<Number> frame{from.of, from.at, {}, {}};
      lift(from.R.Q, frame.R.Q);
      lift(from.p, frame.p);
      frames.push_back(frame);
    }
    const auto count = static_cast<int>(frames.size());
    switch (input.gives) {
      case LinkInput::Gives::bodies:
        if (input.entries.empty()) {
          return loops::add_bodies(frames.data(), count, given.data(), bodies_.data());
        }
        return loops::add_parts_of_bodies(frames.data(), count, input.entries.data(),
                                          static_cast<int>(input.entries.size()), given.data(),
                                          bodies_.data());
      case LinkInput::Gives::origins:
        return loops::move_points(frames.data(), count, given.data(), points_.data());
      case LinkInput::Gives::axes:
        return loops::turn_points(frames.data(), count, given.data(), points_.data());
      case LinkInput::Gives::rotors:
      case LinkInput::Gives::dampings:
      case LinkInput::Gives::frictions:
        return take_numbers(input, given);
    }
  }

  template <bool floats, bool coupled>
  [[nodiscard]] loops::LinkTable<Number, floats, true, true, true, coupled, coupled, true, true,
                                 true, true, true, true, true, true>
  view() const {
    return {links_.data(),
            static_cast<int>(links_.size()),
            from_.slots,
            {gravity_[0], gravity_[1], gravity_[2]},
            points_.data(),
            static_cast<int>(points_.size()),
            from_.rows.data(),
            static_cast<int>(from_.rows.size()),
            drives_.empty() ? nullptr : drives_.data(),
            frictions_.empty() ? nullptr : frictions_.data(),
            couplings_.data(),
            from_.joints,
            balls_.data(),
            row_entries_.data(),
            pushed_points_.data(),
            static_cast<int>(pushed_points_.size()),
            f_ext_.empty() ? nullptr : f_ext_.data(),
            bodies_.data(),
            from_.loaded_links.data(),
            static_cast<int>(bodies_.size()),
            rotors_.empty() ? nullptr : rotors_.data()};
  }

 private:
  /// Applies a run-time argument about joints to the table.
  void take_numbers(const LinkInput& input, const std::vector<Number>& given) {
    const loops::InputNumber* const numbers = input.numbers.data();
    const auto count = static_cast<int>(input.numbers.size());
    if (input.gives == LinkInput::Gives::dampings) {
      return loops::give_dampings(numbers, count, given.data(), drives_.data());
    }
    if (input.gives == LinkInput::Gives::frictions) {
      return loops::give_frictions(numbers, count, given.data(), frictions_.data());
    }
    rotors_.resize(links_.size());
    loops::copy_rotors(links_.data(), static_cast<int>(links_.size()), rotors_.data());
    loops::give_rotors(numbers, count, given.data(), rotors_.data());
  }

  static loops::Turn<Number> lifted(const loops::Turn<double>& r) {
    return {Number(r.c), Number(r.s)};
  }

  template <int size>
  static void lift(const double (&from)[size], Number (&to)[size]) {
    std::transform(std::begin(from), std::end(from), to, [](double x) { return Number(x); });
  }

  static loops::Link<Number> lifted(const loops::Link<double>& from) {
    loops::Link<Number> to{from.parent,
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

  /// Places of the joints' coordinates in a table without ball joints.
  static std::vector<loops::LinkBall> other_joints(const LinkTableData& from) {
    std::vector<loops::LinkBall> joints;
    for (std::size_t i = 0; i < from.links.size(); ++i) {
      const int joint = from.couplings.empty() ? static_cast<int>(i) : from.couplings[i].joint;
      const int at = from.floats && joint > 0 ? joint + 6 : joint;
      joints.push_back({0, 0, static_cast<std::int16_t>(at)});
    }
    return joints;
  }

  static loops::LinkPoint<Number> lifted(const loops::LinkPoint<double>& from) {
    loops::LinkPoint<Number> to{from.link, from.world, {}, {}};
    lift(from.axes, to.axes);
    lift(from.p, to.p);
    return to;
  }

  const LinkTableData& from_;
  std::vector<Number> gravity_;
  std::vector<loops::Link<Number>> links_;
  std::vector<loops::LinkPoint<Number>> points_, pushed_points_;
  std::vector<Number> f_ext_;
  std::vector<loops::LinkDrive<Number>> drives_;
  std::vector<loops::LinkFriction<Number>> frictions_;
  std::vector<loops::LinkCoupling<Number>> couplings_;
  std::vector<loops::LinkBall> balls_;
  std::vector<std::int16_t> row_entries_;
  std::vector<loops::LinkBody<Number>> bodies_;
  std::vector<Number> rotors_;  ///< those that an argument gives
};

/// The table and work space of loops in another kind of number.
template <class Number>
struct LoopTrace {
  struct Poses {
    std::vector<loops::LinkPose<Number>> joints;
    std::vector<loops::LinkRotation<Number>> rotations;
  };
  struct Motions {
    Poses poses;
    std::vector<loops::Spatial<Number>> wrenches;
    std::vector<loops::LinkMotion<Number>> motions;
  };
  struct Inertias {
    std::vector<loops::LinkInertia<Number>> inertias;
    std::vector<loops::LinkProjection<Number>> projections;
    std::vector<loops::LinkFrame<Number>> frames;
    std::vector<loops::LinkBody<Number>> bodies;
    std::vector<Number> f_x, f_y, f_z, n_x, n_y, n_z;
    std::vector<Number> base;
  };
  struct Rows {
    std::vector<loops::LinkAxes<Number>> link_axes;
    std::vector<loops::LinkMotion<Number>> point_motions;
    std::vector<loops::Spatial<Number>> forces;
    std::vector<std::int16_t> links;
    std::vector<Number> errors, Lambda_inv, inverse_borders;
  };

  explicit LoopTrace(const LinkLoops& plan) : table(plan.table) {
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
    inertias.frames.resize(n);
    inertias.bodies.resize(n);
    for (auto* each : {&inertias.f_x, &inertias.f_y, &inertias.f_z, &inertias.n_x, &inertias.n_y,
                       &inertias.n_z}) {
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

  LiftedTable<Number> table;
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

  template <class Table>
  void operator()(const Table& table, int i, int at, const Number& angle,
                  loops::Turn<Number>& turn) const {
    if (sin_q == nullptr) {
      loops::ComputedSines{}(table, i, at, angle, turn);
    } else {
      loops::GivenSines<Number>{sin_q, cos_q}(table, i, at, angle, turn);
    }
  }
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

  [[nodiscard]] TracedSines<Number> sines() const {
    return {sin_q.empty() ? nullptr : sin_q.data(), cos_q.data()};
  }
};

template <int power, class Number, class Table>
void run_law(Function function, const Table& table, LoopTrace<Number>& trace,
             LoopArguments<Number>& with) {
  const TracedSines<Number> sines = with.sines();
  if (function == Function::control_torque) {
    loops::control_torque<power>(table, trace.yields.data(), with.q.data(), sines, with.qd.data(),
                                 with.qdd.data(), with.xdd_cmd.data(), with.result.data(),
                                 trace.motions, trace.inertias, trace.rows);
  } else if constexpr (power != kPowerOfPriorities) {
    loops::lambda<power>(table, trace.yields.data(), with.q.data(), sines, with.result.data(),
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
      if (power == kPowerOfPriorities) {
        return run_law<kPowerOfPriorities>(function, table, trace, with);
      }
      return run_law<6>(function, table, trace, with);
  }
}

/// Calls `run_on` with the table, whose kind is that of the robot.
template <class Number, class RunOn>
void run_on_view(const LinkLoops& plan, const LiftedTable<Number>& table, const RunOn& run_on) {
  const bool coupled = !plan.table.couplings.empty();
  if (plan.table.floats && coupled) {
    run_on(table.template view<true, true>());
  } else if (plan.table.floats) {
    run_on(table.template view<true, false>());
  } else if (coupled) {
    run_on(table.template view<false, true>());
  } else {
    run_on(table.template view<false, false>());
  }
}

template <class Number>
void run(Function function, const LinkLoops& plan, LoopArguments<Number>& with) {
  LoopTrace<Number> trace(plan);
  if (!with.f_ext.empty()) trace.table.set_external_forces(with.f_ext);
  if (!with.gravity.empty()) trace.table.set_gravity(with.gravity);
  for (std::size_t i = 0; i < with.inputs.size(); ++i) {
    trace.table.take(plan.table.inputs[i], with.inputs[i]);
  }
  run_on_view(plan, trace.table, [&](const auto& table) {
    if (with.step.empty()) return run(function, plan.power, table, trace, with);
    std::vector<Number> rotors(plan.table.links.size());
    auto stepped = table;
    stepped.step = with.step.data();
    loops::find_rotors(stepped, std::as_const(with.qd).data(), rotors.data());
    stepped.rotors = rotors.data();
    run(function, plan.power, stepped, trace, with);
  });
}

}  // namespace treeline
