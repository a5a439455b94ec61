#include "carry_object.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>

#include "core/command_laws.hpp"

namespace treeline::experiments {
namespace {

constexpr double kHeight = 1.35;  // of the object at the start, m
constexpr double kPi = 3.14159265358979323846;

/// Start of the first robot: elbow up, flange 0.4 m behind the object. The second robot stands
/// opposite.
constexpr double kStart[kJoints] = {-1.15511, -0.302958, 0.0,       0.210695, -0.728762,
                                    2.549732, 0.712486,  -0.325648, -0.685896};

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

/// A function that goes from 0 at `begin` to 1 at `end`, at rest at both ends, and its rates.
struct Ramp {
  double s, sd, sdd;
};
Ramp ramp(double time, double begin, double end) {
  const double T = end - begin;
  const double x = std::clamp((time - begin) / T, 0.0, 1.0);
  const bool moves = time > begin && time < end;
  return {x * x * (3 - 2 * x), moves ? 6 * x * (1 - x) / T : 0.0,
          moves ? 6 * (1 - 2 * x) / (T * T) : 0.0};
}

PairState start_state() {
  PairState state;
  for (int i = 0; i < kJoints; ++i) {
    state.q[0][i] = kStart[i];
    state.q[1][i] = i < 2 ? -kStart[i] : kStart[i];
  }
  state.q[1][2] = kPi;
  constexpr double kPosition[3] = {0.0, 0.0, kHeight};
  constexpr double kUpright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  grasp_object(kPosition, kUpright, state);
  return state;
}

/// Computes the desired posture: the bases move with the object as if all were one body, the arms
/// stay.
void advise(const CarryPlan& plan, const PairState& start, const PairState& state,
            const Wanted& wanted, double (&qdd_0)[2][kJoints]) {
  const double c = std::cos(wanted.yaw), s = std::sin(wanted.yaw);
  for (int robot = 0; robot < 2; ++robot) {
    double advised[kJoints];
    double rate[kJoints] = {};
    std::copy(std::begin(start.q[robot]), std::end(start.q[robot]), advised);
    const double arm[2] = {c * advised[0] - s * advised[1], s * advised[0] + c * advised[1]};
    advised[0] = wanted.position[0] + arm[0];
    advised[1] = wanted.position[1] + arm[1];
    advised[2] += wanted.yaw;
    rate[0] = wanted.velocity[0] - wanted.yaw_rate * arm[1];
    rate[1] = wanted.velocity[1] + wanted.yaw_rate * arm[0];
    rate[2] = wanted.yaw_rate;
    for (int i = 0; i < kJoints; ++i) {
      qdd_0[robot][i] = plan.posture * (advised[i] - state.q[robot][i]) +
                        2.0 * std::sqrt(plan.posture) * (rate[i] - state.qd[robot][i]);
    }
  }
}

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
    for (int robot = 1; robot <= 2; ++robot) {
      for (int i = 1; i <= kJoints; ++i) {
        names.push_back(fmt::format("{}_{}_{}", quantity, robot, i));
      }
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
  return control_pair(state, seen, xdd, wanted.internal, qdd_0);
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

Wanted wanted_at(const CarryPlan& plan, double time) {
  const Ramp round = ramp(time, plan.lead, plan.lead + plan.duration);
  const double angle = 2 * kPi * round.s, rate = 2 * kPi * round.sd;
  const double growth = 2 * kPi * round.sdd;
  const double s = std::sin(angle), c = std::cos(angle);
  // First and second time derivatives of sin and of 1 - cos.
  const double of_sin[3] = {s, c * rate, c * growth - s * rate * rate};
  const double of_cos[3] = {1 - c, s * rate, s * growth + c * rate * rate};
  Wanted wanted;
  const auto set = [&](int axis, double factor, const double(&terms)[3]) {
    wanted.position[axis] += factor * terms[0];
    wanted.velocity[axis] += factor * terms[1];
    wanted.acceleration[axis] += factor * terms[2];
  };
  wanted.position[2] = kHeight;
  set(0, plan.radius, of_sin);
  set(1, plan.radius, of_cos);
  set(2, plan.rise, of_cos);
  wanted.yaw = plan.yaw * of_sin[0];
  wanted.yaw_rate = plan.yaw * of_sin[1];
  wanted.velocity[5] = wanted.yaw_rate;
  wanted.acceleration[5] = plan.yaw * of_sin[2];
  const double vector[3] = {0.0, 0.0, wanted.yaw};
  core::rotation_from_vector(vector, wanted.rotation);
  wanted.internal[0] =
      -plan.squeeze_from - (plan.squeeze_to - plan.squeeze_from) * ramp(time, 3.0, 4.0).s;
  wanted.internal[1] = plan.torsion * ramp(time, 5.0, 6.0).s;
  return wanted;
}

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
