#include "cooperation.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "core/command_laws.hpp"
#include "core/orientation.hpp"
#include "pair_functions.hpp"
#include "servo/run_for.hpp"
#include "servo/simulated_robot.hpp"
#include "share_law.hpp"

namespace treeline::experiments {
namespace {

constexpr double kSettled = 0.5;  // s
constexpr double kLost = 1.0;     // m

double norm(const double* v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

struct Internal {
  double values[6] = {};
};

/// Values that arrive some cycles after they are sent; before the first arrival the first of them.
template <class Value>
class Delayed {
 public:
  explicit Delayed(std::size_t cycles) : cycles_(cycles) {}
  Value pass(const Value& value) {
    line_.push_back(value);
    if (line_.size() > cycles_ + 1) line_.pop_front();
    return line_.front();
  }

 private:
  std::size_t cycles_;
  std::deque<Value> line_;
};

/// The controllers of both robots, wherever they run.
class Controllers {
 public:
  Controllers(const CarryPlan& plan, Law law, const Trouble& trouble, const PairState& start)
      : plan_(plan),
        law_(law),
        start_(start),
        torques_(cycles(trouble.delay)),
        felt_(cycles(trouble.delay)),
        exchange_(std::max<std::size_t>(1, cycles(kExchangePeriod))) {}

  /// `believed` is the state as the robots' sensors and maps tell it, `felt` the internal forces
  /// that the sensors of both hands make out.
  PairTorques update(std::size_t cycle, const PairState& believed, const Wanted& wanted,
                     const Internal& felt) {
    double qdd_0[2][kJoints];
    advise(plan_, start_, believed, wanted, qdd_0);
    if (law_ == Law::central) {
      const ObjectSeen seen = see_object(believed);
      double error[6], xdd[6];
      core::pose_error(seen.position, seen.rotation, wanted.position, wanted.rotation, error);
      core::tracking_law<6, double>({plan_.stiffness, plan_.damping}, error, seen.velocity,
                                    wanted.velocity, wanted.acceleration, xdd);
      return torques_.pass(control_pair(believed, xdd, wanted.internal, qdd_0));
    }
    if (law_ == Law::hybrid) exchange(cycle, wanted, felt_.pass(felt));
    double internal[6];
    for (int i = 0; i < 6; ++i) internal[i] = wanted.internal[i] + correction_.values[i];
    PairTorques torques;
    for (int robot = 0; robot < 2; ++robot) {
      control_share(robot, plan_, wanted, internal, believed.q[robot], believed.qd[robot],
                    qdd_0[robot], torques.tau[robot]);
    }
    return torques;
  }

 private:
  [[nodiscard]] std::size_t cycles(double seconds) const {
    return static_cast<std::size_t>(std::lround(seconds * plan_.rate));
  }

  void exchange(std::size_t cycle, const Wanted& wanted, const Internal& felt) {
    if (cycle % exchange_ != 0 || cycle == 0) return;
    for (int i = 0; i < 6; ++i) {
      correction_.values[i] += kExchangeShare * (wanted.internal[i] - felt.values[i]);
    }
  }

  const CarryPlan& plan_;
  Law law_;
  const PairState& start_;
  Delayed<PairTorques> torques_;
  Delayed<Internal> felt_;
  std::size_t exchange_;
  Internal correction_;
};

PairState believed_from(const PairState& state, const Trouble& trouble) {
  PairState believed = state;
  believed.q[1][0] += trouble.shift;
  believed.q[1][2] += trouble.turn;
  return believed;
}

void note(const double (&error)[6], const Wanted& wanted, const Internal& felt,
          CooperationErrors& errors) {
  errors.position = std::max(errors.position, norm(error));
  errors.rotation = std::max(errors.rotation, norm(error + 3));
  errors.tension = std::max(errors.tension, std::abs(felt.values[0] - wanted.internal[0]));
  for (int i = 1; i < 6; ++i) {
    errors.moments = std::max(errors.moments, std::abs(felt.values[i] - wanted.internal[i]));
  }
}

}  // namespace

const std::array<Trouble, 4> kTroubles = {
    Trouble{}, Trouble{"second base 1 mm, 1 mrad off", 1e-3, 1e-3, 0},
    Trouble{"messages 10 ms late", 0, 0, 0.01}, Trouble{"both", 1e-3, 1e-3, 0.01}};

const char* name_of(Law law) {
  constexpr std::array kNames = {"central", "decentral", "hybrid"};
  return kNames[static_cast<std::size_t>(law)];
}

Cooperation cooperate(const CarryPlan& plan, Law law, const Trouble& trouble) {
  const PairState start = start_state();
  const auto cycles =
      static_cast<std::size_t>(std::lround((plan.lead + plan.duration + plan.settle) * plan.rate));
  Cooperation run{{}, report::Table({"time", "position_error", "tension", "commanded"}, cycles)};
  Controllers controllers(plan, law, trouble, start);
  servo::StateOf<Pair> begin;
  std::copy(&start.q[0][0], &start.q[0][0] + Pair::kCoordinates, begin.q);
  std::copy(&start.qd[0][0], &start.qd[0][0] + Pair::kVelocities, begin.qd);
  servo::SimulatedRobot<Pair> robots(begin, plan.substeps);
  PairTorques held;
  Wanted before;
  Internal felt;
  std::size_t cycle = 0;
  const auto step = [&](double time, const servo::StateOf<Pair>& measured,
                        double(&tau)[Pair::kVelocities]) {
    const PairState state = Pair::state_of(measured.q, measured.qd);
    const Wanted wanted = wanted_at(plan, time);
    if (cycle == 0) {  // the hands squeeze as commanded when the run begins
      std::copy(std::begin(wanted.internal), std::end(wanted.internal), felt.values);
      before = wanted;
    } else {
      const PairMotion motion = move_pair(state, held);
      std::copy(std::begin(motion.internal), std::end(motion.internal), felt.values);
    }
    const ObjectSeen seen = see_object(state);
    double error[6];
    core::pose_error(seen.position, seen.rotation, wanted.position, wanted.rotation, error);
    if (time >= kSettled) note(error, before, felt, run.errors);
    const double row[4] = {time, norm(error), felt.values[0], before.internal[0]};
    run.table.append(row);
    held = controllers.update(cycle++, believed_from(state, trouble), wanted, felt);
    std::copy(&held.tau[0][0], &held.tau[0][0] + Pair::kVelocities, tau);
    before = wanted;
    return norm(error) < kLost;
  };
  servo::run_law<Pair>(static_cast<double>(cycles - 1) / plan.rate, plan.rate, {}, robots, step);
  return run;
}

Comparison compare_laws(const CarryPlan& plan) {
  Comparison comparison;
  for (const Trouble& trouble : kTroubles) {
    comparison.runs.emplace_back();
    for (const Law law : kLaws) comparison.runs.back().push_back(cooperate(plan, law, trouble));
  }
  return comparison;
}

bool claims_hold(const Comparison& comparison) {
  const auto errors = [&](std::size_t trouble, Law law) {
    return comparison.runs[trouble][static_cast<std::size_t>(law)].errors;
  };
  for (const Law law : kLaws) {
    const CooperationErrors own = errors(0, law);
    if (!(own.position < 1e-4 && own.rotation < 1e-3 && own.tension < 0.1 && own.moments < 0.1)) {
      return false;
    }
  }
  return errors(1, Law::hybrid).tension < 0.1 * errors(1, Law::decentral).tension &&
         errors(2, Law::central).position > 10 * errors(0, Law::central).position &&
         errors(2, Law::hybrid).position < 2 * errors(0, Law::hybrid).position;
}

std::string summary(const Comparison& comparison) {
  std::string text = fmt::format("{:<30} {:<10} {:>10} {:>10} {:>10} {:>10}\n", "trouble", "law",
                                 "object, m", "rad", "tension, N", "N m");
  for (std::size_t i = 0; i < kTroubles.size(); ++i) {
    for (const Law law : kLaws) {
      const CooperationErrors& own = comparison.runs[i][static_cast<std::size_t>(law)].errors;
      text +=
          fmt::format("{:<30} {:<10} {:>10.1e} {:>10.1e} {:>10.1e} {:>10.1e}\n", kTroubles[i].name,
                      name_of(law), own.position, own.rotation, own.tension, own.moments);
    }
  }
  return text + fmt::format("claims {}\n", claims_hold(comparison) ? "hold" : "BROKEN");
}

std::string csv_text(const Comparison& comparison) {
  std::string text = "trouble,law,position_m,rotation_rad,tension_n,moments_nm\n";
  for (std::size_t i = 0; i < kTroubles.size(); ++i) {
    for (const Law law : kLaws) {
      const CooperationErrors& own = comparison.runs[i][static_cast<std::size_t>(law)].errors;
      text += fmt::format("\"{}\",{},{},{},{},{}\n", kTroubles[i].name, name_of(law), own.position,
                          own.rotation, own.tension, own.moments);
    }
  }
  return text;
}

report::Plot figure(const Comparison& comparison) {
  report::Plot plot;
  plot.title = "Two mobile manipulators with one object: who computes (Chang section 7.3.1)";
  plot.x_label = "time (s)";
  plot.x = comparison.runs[0][0].table.column(0);
  for (std::size_t i = 0; i < kTroubles.size(); ++i) {
    report::PlotPanel tension{
        fmt::format("Tension; trouble: {}", kTroubles[i].name), "force (N)", {}, 1.0};
    report::PlotPanel error{
        fmt::format("Object; trouble: {}", kTroubles[i].name), "distance (mm)", {}, 0.01};
    for (const Law law : kLaws) {
      const report::Table& table = comparison.runs[i][static_cast<std::size_t>(law)].table;
      std::vector<double> distance = table.column(1);
      for (double& value : distance) value *= 1e3;
      error.lines.push_back({name_of(law), distance, false});
      tension.lines.push_back({name_of(law), table.column(2), false});
      if (law == Law::hybrid) tension.lines.push_back({"commanded", table.column(3), true});
    }
    plot.panels.push_back(std::move(tension));
    plot.panels.push_back(std::move(error));
  }
  return plot;
}

}  // namespace treeline::experiments
