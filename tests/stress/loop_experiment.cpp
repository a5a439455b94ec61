#include <fmt/format.h>

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>

#include "drift.hpp"
#include "experiments.hpp"
#include "recursion/looped_robot.hpp"

namespace treeline::stress {
namespace {

using interpreter::Vector;

constexpr double kStep = 2e-4;  ///< s

/// How a loop is kept closed: by gains on its errors, and by going to the nearest closed pose and
/// the nearest permitted velocity after each step; and the order of the Runge-Kutta method, 4 or 8.
struct Keeping {
  std::vector<double> gains{0, 0};
  bool projected = false;
  int order = 4;
};

/// A step of eighth order (Fehlberg 1968), of a robot without quaternions.
void step_eighth_order(const tests::LoopedRobot& robot, const Keeping& keeping, Vector<double>& q,
                       Vector<double>& qd) {
  using State = std::vector<double>;
  const auto n = q.size();
  State state(q.begin(), q.end());
  state.insert(state.end(), qd.begin(), qd.end());
  const auto rates = [&](const State& at, State& rate, double) {
    const Vector<double> v = Vector<double>::Map(at.data() + n, n);
    const auto qdd = robot.motion(Vector<double>::Map(at.data(), n), v, keeping.gains).qdd;
    rate.assign(v.begin(), v.end());
    rate.insert(rate.end(), qdd.begin(), qdd.end());
  };
  boost::numeric::odeint::runge_kutta_fehlberg78<State>().do_step(rates, state, 0.0, kStep);
  q = Vector<double>::Map(state.data(), n);
  qd = Vector<double>::Map(state.data() + n, n);
}

/// Angles within half a turn of zero, which keep their last digits however long the loop turns.
Vector<double> unwound(const Vector<double>& q) {
  constexpr double kTurn = 6.283185307179586;
  return q.unaryExpr([](double angle) { return angle - kTurn * std::round(angle / kTurn); });
}

/// A loop under gravity, its first joint at `speed` where it begins. How far it opens, m, and the
/// change of its energy over the largest kinetic energy.
struct LoopDrift {
  LoopDrift(const tests::LoopedRobot& robot, const Vector<double>& near, double speed,
            const Keeping& keeping, int steps) {
    Vector<double> q = robot.closed(near);
    Vector<double> asked = Vector<double>::Zero(robot.model().nv);
    asked(0) = speed;
    Vector<double> qd = robot.permitted(q, asked);
    const double start = robot.energy(q, qd);
    double size = 0;
    const auto step = [&](int) {
      if (keeping.order == 8) {
        step_eighth_order(robot, keeping, q, qd);
        q = unwound(q);
      } else {
        robot.step(kStep, keeping.gains, q, qd);
      }
      if (!keeping.projected) return;
      q = robot.closed(q);
      qd = robot.permitted(q, qd);
    };
    loop = run(steps, step, [&] {
      const double change = std::abs(robot.energy(q, qd) - start);
      largest_energy = std::max(largest_energy, change);
      size = std::max(size, interpreter::kinetic_energy<double>(robot.model(), q, qd));
      return robot.errors(q).cwiseAbs().maxCoeff();
    });
    largest_energy /= size;
  }
  Drift loop;
  double largest_energy = 0;
};

double digits(double change) {
  return std::log10(std::max(change, 1e-17));
}

Finding loop(const Effort& effort) {
  const int steps = effort.quick ? 2000 : 1000000;
  const tests::LoopedRobot robot = tests::four_bar();
  const auto drift = [&](const Keeping& keeping) {
    return LoopDrift(robot, tests::kAssembled, 5, keeping, steps);
  };
  const LoopDrift plain = drift({});
  const LoopDrift stabilised = drift({{40, 400}, false});
  const LoopDrift projected = drift({{0, 0}, true});
  Finding finding{
      "loop",
      "A four-bar turns: steps of 0.2 ms, Runge-Kutta",
      "log10 of the number of steps",
      "log10 of m",
      plain.loop.at,
      {{"how far the loop opens", "as it stands", plain.loop.y, false},
       {"how far the loop opens", "stabilised, 40/s and 400/s^2", stabilised.loop.y, false},
       {"how far the loop opens", "projected", projected.loop.y, false}},
      {},
      {}};
  finding.said.push_back(fmt::format(
      "log10 after {} steps: loop {:.1f}, stabilised {:.1f}, projected {:.1f}; energy {:.1f}, "
      "{:.1f}, {:.1f}",
      steps, plain.loop.y.back(), stabilised.loop.y.back(), projected.loop.y.back(),
      digits(plain.largest_energy), digits(stabilised.largest_energy),
      digits(projected.largest_energy)));
  claim(stabilised.loop.y.back() < -11, "gains keep the loop closed to 1e-11 m", finding);
  claim(projected.loop.y.back() < -12, "the nearest closed pose keeps the loop to 1e-12 m",
        finding);
  claim(digits(projected.largest_energy) < std::log10(steps * 1e-15) + 2,
        "the energy stays as the integrator keeps it", finding);
  return finding;
}

/// Steps whose own error is below rounding: what is left is that of the recursion and of the ways
/// to keep loops closed.
Finding precise_loops(const Effort& effort) {
  const int steps = effort.quick ? 2000 : 100000;
  Finding finding{"precise_loops",
                  "Loops turn: steps of 0.2 ms, Runge-Kutta of eighth order",
                  "log10 of the number of steps",
                  "log10 of m",
                  {},
                  {},
                  {},
                  {}};
  const auto add = [&](const char* name, const LoopDrift& drift, double kept = 1e-12) {
    finding.x = drift.loop.at;
    finding.curves.push_back({"how far the loop opens", name, drift.loop.y, false});
    finding.said.push_back(fmt::format("log10 after {} steps, {}: loop {:.1f}, energy {:.1f}",
                                       steps, name, drift.loop.y.back(),
                                       digits(drift.largest_energy)));
    claim(drift.loop.y.back() < -12, fmt::format("{}: closed to 1e-12 m", name), finding);
    claim(drift.largest_energy < kept, fmt::format("{}: energy kept to {}", name, kept), finding);
  };
  const tests::LoopedRobot plane = tests::four_bar(), space = tests::spatial_four_bar();
  const Keeping stabilised{{40, 400}, false, 8}, projected{{0, 0}, true, 8};
  add("plane, stabilised", {plane, tests::kAssembled, 5, stabilised, steps});
  add("plane, projected", {plane, tests::kAssembled, 5, projected, steps});
  add("space, stabilised", {space, tests::kAssembledInSpace, 5, stabilised, steps});
  add("space, projected", {space, tests::kAssembledInSpace, 5, projected, steps}, 1e-11);
  return finding;
}

}  // namespace

std::vector<Experiment> loop_experiments() {
  return {{"loop", loop}, {"precise_loops", precise_loops}};
}

}  // namespace treeline::stress
