#include "carry_object.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "core/command_laws.hpp"
#include "samm_pair_joints.hpp"

namespace treeline::experiments {
namespace {

enum Column : std::size_t {
  kTime,
  kWanted,
  kActual = kWanted + 3,
  kErrors = kActual + 3,
  kDrift = kErrors + 2,
  kCommanded = kDrift + 2,
  kActing = kCommanded + 6,
  kControl = kActing + 6,
  kCoordinates,
  kTau = kCoordinates + 2 * kJoints,
  kColumns = kTau + 2 * kJoints
};

double norm(const double* v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

std::vector<std::string> names() {
  std::vector<std::string> names = {
      "time",           "x_wanted",       "y_wanted", "z_wanted",      "x", "y", "z",
      "position_error", "rotation_error", "drift",    "drift_rotation"};
  for (const char* which : {"commanded", "acting"}) {
    for (const char* force :
         {"tension", "torsion", "moment_1y", "moment_1z", "moment_2y", "moment_2z"}) {
      names.push_back(fmt::format("{}_{}", force, which));
    }
  }
  names.emplace_back("control_us");
  for (const char* quantity : {"q", "tau"}) {
    for (const char* joint : samm_pair::kCoordinateJoints) {
      names.push_back(fmt::format("{}_{}", quantity, joint));
    }
  }
  return names;
}

double largest(const std::vector<double>& values) {
  double result = 0.0;
  for (const double value : values) {
    result = std::max(result, std::abs(value));
  }
  return result;
}

double largest_difference(const servo::Table& table, std::size_t a, std::size_t b) {
  double result = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    result = std::max(result, std::abs(table.at(row, a) - table.at(row, b)));
  }
  return result;
}

/// Control of one cycle, with its time measured.
PairTorques control(const CarryPlan& plan, const PairState& start, const PairState& state,
                    const ObjectSeen& seen, const Wanted& wanted, double (&error)[6]) {
  core::pose_error(seen.position, seen.rotation, wanted.position, wanted.rotation, error);
  double xdd[6];
  double qdd_0[2][kJoints];
  core::tracking_law<6, double>({plan.stiffness, plan.damping}, error, seen.velocity,
                                wanted.velocity, wanted.acceleration, xdd);
  advise(plan, start, state, wanted, qdd_0);
  return control_pair(state, xdd, wanted.internal, qdd_0);
}

void record(double time, const PairState& state, const PairTorques& torques, const Wanted& wanted,
            const ObjectSeen& seen, const double (&error)[6], const double (&commanded)[6],
            const double (&acting)[6], double control_us, servo::Table& table) {
  double row[kColumns];
  row[kTime] = time;
  for (std::size_t i = 0; i < 3; ++i) {
    row[kWanted + i] = wanted.position[i];
    row[kActual + i] = seen.position[i];
  }
  row[kErrors] = norm(error);
  row[kErrors + 1] = norm(error + 3);
  row[kDrift] = norm(seen.drift);
  row[kDrift + 1] = norm(seen.drift + 3);
  for (std::size_t i = 0; i < 6; ++i) {
    row[kCommanded + i] = commanded[i];
    row[kActing + i] = acting[i];
  }
  row[kControl] = control_us;
  std::copy(&state.q[0][0], &state.q[0][0] + 2 * kJoints, row + kCoordinates);
  std::copy(&torques.tau[0][0], &torques.tau[0][0] + 2 * kJoints, row + kTau);
  table.append(row);
}

}  // namespace

CarryOutcome::CarryOutcome(std::size_t rows) : table(names(), rows) {}

CarryOutcome carry_object(const CarryPlan& plan) {
  const PairState start = start_state();
  PairState state = start;
  const double dt = 1.0 / plan.rate;
  const int cycles =
      static_cast<int>(std::lround((plan.lead + plan.duration + plan.settle) * plan.rate));
  CarryOutcome outcome(static_cast<std::size_t>(cycles));
  PairTorques held;
  double commanded[6];
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const double time = cycle * dt;
    const auto begin = std::chrono::steady_clock::now();
    const Wanted wanted = wanted_at(plan, time);
    const ObjectSeen seen = see_object(state);
    double error[6];
    const PairTorques torques = control(plan, start, state, seen, wanted, error);
    const auto spent = std::chrono::steady_clock::now() - begin;
    const auto ns = std::chrono::duration_cast<std::chrono::nanoseconds>(spent).count();
    outcome.control.record(ns);
    // Internal forces under the torque of the previous cycle, where the effect of holding it is
    // largest.
    if (cycle == 0) {
      held = torques;
      std::copy(std::begin(wanted.internal), std::end(wanted.internal), commanded);
    }
    const PairMotion motion = move_pair(state, held);
    record(time, state, torques, wanted, seen, error, commanded, motion.internal,
           1e-3 * static_cast<double>(ns), outcome.table);
    held = torques;
    std::copy(std::begin(wanted.internal), std::end(wanted.internal), commanded);
    for (int step = 0; step < plan.substeps; ++step) {
      integrate_pair(torques, dt / plan.substeps, state);
    }
  }
  return outcome;
}

CarryErrors largest_errors(const CarryOutcome& outcome) {
  const servo::Table& table = outcome.table;
  CarryErrors errors;
  errors.position = largest(table.column(kErrors));
  errors.rotation = largest(table.column(kErrors + 1));
  errors.drift = largest(table.column(kDrift));
  errors.drift_rotation = largest(table.column(kDrift + 1));
  errors.tension = largest_difference(table, kCommanded, kActing);
  for (std::size_t i = 1; i < 6; ++i) {
    errors.moments =
        std::max(errors.moments, largest_difference(table, kCommanded + i, kActing + i));
  }
  for (std::size_t row = 0; row < table.rows(); ++row) {
    errors.travel = std::max(
        errors.travel, std::hypot(table.at(row, kCoordinates) - table.at(0, kCoordinates),
                                  table.at(row, kCoordinates + 1) - table.at(0, kCoordinates + 1)));
  }
  return errors;
}

bool within_bounds(const CarryErrors& errors) {
  return errors.position < 1e-4 && errors.rotation < 1e-3 && errors.tension < 0.1 &&
         errors.moments < 0.1 && errors.drift < 1e-10 && errors.drift_rotation < 1e-10;
}

std::string summary(const CarryOutcome& outcome) {
  const CarryErrors errors = largest_errors(outcome);
  const servo::DurationStatistics& control = outcome.control;
  return fmt::format(
      "object       largest tracking error {:.2e} m, {:.2e} rad (bounds 1e-4, 1e-3)\n"
      "internal     tension off by at most {:.2e} N, moments by {:.2e} N m (bounds 0.1)\n"
      "drift        of the second grasp against the first: {:.2e} m, {:.2e} rad (bounds 1e-10)\n"
      "bases        moved up to {:.2f} m\n"
      "control      of both robots: median {:.2f} us, 99 % {:.2f} us over {} cycles\n"
      "bounds       {}\n",
      errors.position, errors.rotation, errors.tension, errors.moments, errors.drift,
      errors.drift_rotation, errors.travel, 1e-3 * control.median(), 1e-3 * control.quantile(0.99),
      control.count(), within_bounds(errors) ? "kept" : "BROKEN");
}

servo::Plot figure(const CarryOutcome& outcome) {
  const servo::Table& table = outcome.table;
  servo::Plot plot;
  plot.title = "Two mobile manipulators carry one object (Chang section 7.2.2)";
  plot.x_label = "time (s)";
  plot.x = table.column(kTime);
  const auto scaled = [&](std::size_t column, double factor) {
    std::vector<double> values = table.column(column);
    for (double& value : values) {
      value *= factor;
    }
    return values;
  };
  servo::PlotPanel object{"Object", "position (m)", {}, 0.1};
  servo::PlotPanel bases{"Bases", "position (m)", {}, 0.1};
  constexpr std::array kNames = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    object.lines.push_back({kNames[i], table.column(kActual + i), false});
  }
  for (std::size_t i = 0; i < 3; ++i) {
    object.lines.push_back({i == 0 ? "wanted" : "", table.column(kWanted + i), true});
  }
  for (std::size_t robot = 0; robot < 2; ++robot) {
    for (std::size_t i = 0; i < 2; ++i) {
      bases.lines.push_back({fmt::format("{} of robot {}", kNames[i], robot + 1),
                             table.column(kCoordinates + robot * kJoints + i), false});
    }
  }
  plot.panels.push_back(std::move(object));
  plot.panels.push_back({"Distance between wanted and actual position",
                         "distance (\u00b5m)",
                         {{"object", scaled(kErrors, 1e6), false}},
                         0.0});
  plot.panels.push_back(
      {"Internal force: tension",
       "force (N)",
       {{"acting", table.column(kActing), false}, {"commanded", table.column(kCommanded), true}},
       10.0});
  plot.panels.push_back({"Internal moment: torsion",
                         "moment (N m)",
                         {{"acting", table.column(kActing + 1), false},
                          {"commanded", table.column(kCommanded + 1), true}},
                         1.0});
  plot.panels.push_back(
      {"Drift of the second grasp against the first",
       "(fm, 1e-15 rad)",
       {{"position", scaled(kDrift, 1e15), false}, {"rotation", scaled(kDrift + 1, 1e15), false}},
       0.0});
  plot.panels.push_back(std::move(bases));
  return plot;
}

}  // namespace treeline::experiments
