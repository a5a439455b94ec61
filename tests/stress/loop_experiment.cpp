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

/// A four-bar swings under gravity from a slow turn. Its loop, m, and its energy over its size.
struct FourBarDrift {
  FourBarDrift(const Keeping& keeping, int steps) {
    const tests::LoopedRobot robot = tests::four_bar();
    Vector<double> q = robot.closed(tests::kAssembled);
    Vector<double> qd = robot.permitted(q, (Vector<double>(3) << 5, 0, 0).finished());
    const double start = robot.energy(q, qd);
    const auto step = [&](int) {
      if (keeping.order == 8) {
        step_eighth_order(robot, keeping, q, qd);
      } else {
        robot.step(kStep, keeping.gains, q, qd);
      }
      if (!keeping.projected) return;
      q = robot.closed(q);
      qd = robot.permitted(q, qd);
    };
    largest_energy = 0;
    loop = run(steps, step, [&] {
      largest_energy = std::max(largest_energy, std::abs(robot.energy(q, qd) / start - 1));
      return robot.errors(q).cwiseAbs().maxCoeff();
    });
  }
  Drift loop;
  double largest_energy = 0;
};

Finding loop(const Effort& effort) {
  const int steps = effort.quick ? 2000 : 1000000;
  const FourBarDrift plain({}, steps);
  const FourBarDrift stabilised({{40, 400}, false}, steps);
  const FourBarDrift projected({{0, 0}, true}, steps);
  const FourBarDrift precise({{0, 0}, true, 8}, steps);
  Finding finding{
      "loop",
      "A four-bar turns: steps of 0.2 ms, Runge-Kutta",
      "log10 of the number of steps",
      "log10 of m",
      plain.loop.at,
      {{"how far the loop opens", "as it stands", plain.loop.y, false},
       {"how far the loop opens", "stabilised, 40/s and 400/s^2", stabilised.loop.y, false},
       {"how far the loop opens", "projected", projected.loop.y, false},
       {"how far the loop opens", "projected, eighth order", precise.loop.y, false}},
      {},
      {}};
  const auto digits = [](double change) { return std::log10(std::max(change, 1e-17)); };
  finding.said.push_back(fmt::format(
      "log10 after {} steps: loop {:.1f}, stabilised {:.1f}, projected {:.1f}, of eighth order "
      "{:.1f}; energy {:.1f}, {:.1f}, {:.1f}, {:.1f}",
      steps, plain.loop.y.back(), stabilised.loop.y.back(), projected.loop.y.back(),
      precise.loop.y.back(), digits(plain.largest_energy), digits(stabilised.largest_energy),
      digits(projected.largest_energy), digits(precise.largest_energy)));
  claim(stabilised.loop.y.back() < -11, "gains keep the loop closed to 1e-11 m", finding);
  claim(projected.loop.y.back() < -12, "the nearest closed pose keeps the loop to 1e-12 m",
        finding);
  claim(digits(projected.largest_energy) < std::log10(steps * 1e-15) + 2,
        "the energy stays as the integrator keeps it", finding);
  return finding;
}

}  // namespace

std::vector<Experiment> loop_experiments() {
  return {{"loop", loop}};
}

}  // namespace treeline::stress
