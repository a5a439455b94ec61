#include "carry_object.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/command_laws.hpp"
#include "pair_functions.hpp"
#include "samm_pair_joints.hpp"
#include "servo/clock.hpp"
#include "servo/run_for.hpp"
#include "servo/safety.hpp"
#include "servo/simulated_robot.hpp"

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

double largest_difference(const report::Table& table, std::size_t a, std::size_t b) {
  double result = 0.0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    result = std::max(result, std::abs(table.at(row, a) - table.at(row, b)));
  }
  return result;
}

using State = servo::StateOf<Pair>;

/// The object follows the plan, the bases are advised to go with it.
class CarryController {
 public:
  CarryController(const CarryPlan& plan, const PairState& start) : plan_(plan), start_(start) {}

  void start(double, const State&) noexcept {}
  void apply(double, const servo::Message&) noexcept {}
  void control(double time, const State& measured, double (&tau)[Pair::kVelocities]) noexcept {
    const PairState state = Pair::state_of(measured.q, measured.qd);
    wanted = wanted_at(plan_, time);
    seen = see_object(state);
    core::pose_error(seen.position, seen.rotation, wanted.position, wanted.rotation, error);
    double xdd[6];
    double qdd_0[2][kJoints];
    core::tracking_law<6, double>({plan_.stiffness, plan_.damping}, error, seen.velocity,
                                  wanted.velocity, wanted.acceleration, xdd);
    advise(plan_, start_, state, wanted, qdd_0);
    const PairTorques torques = control_pair(state, xdd, wanted.internal, qdd_0);
    std::copy(&torques.tau[0][0], &torques.tau[0][0] + Pair::kVelocities, tau);
  }

  // Of the last call of `control`.
  Wanted wanted;
  ObjectSeen seen;
  double error[6] = {};

 private:
  const CarryPlan& plan_;
  const PairState& start_;
};

/// What acts in a cycle is decided in the one before.
struct Held {
  double tau[Pair::kVelocities] = {};
  double commanded[6] = {};
  bool any = false;

  void take(const servo::Report<Pair>& report, const Wanted& wanted) {
    std::copy(std::begin(report.tau), std::end(report.tau), tau);
    std::copy(std::begin(wanted.internal), std::end(wanted.internal), commanded);
    any = true;
  }
};

/// Appends a cycle. Internal forces are those at its beginning under `held`, the torque of the
/// previous cycle, where the effect of holding it is largest.
void record(const servo::Report<Pair>& report, const CarryController& controller, const Held& held,
            report::Table& table) {
  PairTorques torques;
  std::copy(std::begin(held.tau), std::end(held.tau), &torques.tau[0][0]);
  const PairMotion motion = move_pair(Pair::state_of(report.state.q, report.state.qd), torques);
  const Wanted& wanted = controller.wanted;
  const ObjectSeen& seen = controller.seen;
  double row[kColumns];
  row[kTime] = report.time;
  for (std::size_t i = 0; i < 3; ++i) {
    row[kWanted + i] = wanted.position[i];
    row[kActual + i] = seen.position[i];
  }
  row[kErrors] = norm(controller.error);
  row[kErrors + 1] = norm(controller.error + 3);
  row[kDrift] = norm(seen.drift);
  row[kDrift + 1] = norm(seen.drift + 3);
  for (std::size_t i = 0; i < 6; ++i) {
    row[kCommanded + i] = held.commanded[i];
    row[kActing + i] = motion.internal[i];
  }
  row[kControl] = 1e-3 * static_cast<double>(report.control_nanoseconds);
  std::copy(std::begin(report.state.q), std::end(report.state.q), row + kCoordinates);
  std::copy(std::begin(report.tau), std::end(report.tau), row + kTau);
  table.append(row);
}

}  // namespace

CarryOutcome::CarryOutcome(std::size_t rows) : table(names(), rows) {}

CarryOutcome carry_object(const CarryPlan& plan) {
  const PairState start = start_state();
  State state;
  std::copy(&start.q[0][0], &start.q[0][0] + Pair::kCoordinates, std::begin(state.q));
  servo::SimulatedRobot<Pair> robot(state, plan.substeps);
  CarryController controller(plan, start);
  servo::SimulatedClock clock;
  servo::Mailbox mailbox;
  servo::LoopSettings settings;
  settings.rate = plan.rate;
  const double total = plan.lead + plan.duration + plan.settle;
  CarryOutcome outcome(static_cast<std::size_t>(std::lround(total * plan.rate)) + 1);
  Held held;
  const servo::RunEnd end = servo::run_for<Pair>(
      total, settings,
      servo::limits_of(samm_pair::kLowerLimits, samm_pair::kUpperLimits, samm_pair::kVelocityLimits,
                       samm_pair::kEffortLimits),
      robot, controller, clock, mailbox, [&](const servo::Report<Pair>& report) {
        if (!held.any) held.take(report, controller.wanted);
        record(report, controller, held, outcome.table);
        held.take(report, controller.wanted);
      });
  outcome.fault = end.fault;
  outcome.control = end.control;
  return outcome;
}

CarryErrors largest_errors(const CarryOutcome& outcome) {
  const report::Table& table = outcome.table;
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

bool within_bounds(const CarryOutcome& outcome) {
  const CarryErrors errors = largest_errors(outcome);
  return !outcome.fault && errors.position < 1e-4 && errors.rotation < 1e-3 &&
         errors.tension < 0.1 && errors.moments < 0.1 && errors.drift < 1e-10 &&
         errors.drift_rotation < 1e-10;
}

std::string summary(const CarryOutcome& outcome) {
  const CarryErrors errors = largest_errors(outcome);
  const servo::DurationStatistics& control = outcome.control;
  return (outcome.fault ? "stopped      " + servo::describe(outcome.fault) + "\n" : std::string()) +
         fmt::format(
             "object       largest tracking error {:.2e} m, {:.2e} rad (bounds 1e-4, 1e-3)\n"
             "internal     tension off by at most {:.2e} N, moments by {:.2e} N m (bounds 0.1)\n"
             "drift        of the second grasp against the first: {:.2e} m, {:.2e} rad (bounds "
             "1e-10)\n"
             "bases        moved up to {:.2f} m\n"
             "control      of both robots: median {:.2f} us, 99 % {:.2f} us over {} cycles\n"
             "bounds       {}\n",
             errors.position, errors.rotation, errors.tension, errors.moments, errors.drift,
             errors.drift_rotation, errors.travel, 1e-3 * control.median(),
             1e-3 * control.quantile(0.99), control.count(),
             within_bounds(outcome) ? "kept" : "BROKEN");
}

report::Plot figure(const CarryOutcome& outcome) {
  const report::Table& table = outcome.table;
  report::Plot plot;
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
  report::PlotPanel object{"Object", "position (m)", {}, 0.1};
  report::PlotPanel bases{"Bases", "position (m)", {}, 0.1};
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
