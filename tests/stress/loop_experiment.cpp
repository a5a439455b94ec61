#include <fmt/format.h>

#include <cmath>

#include "drift.hpp"
#include "experiments.hpp"
#include "precise_loops.hpp"
#include "recursion/looped_robot.hpp"

namespace treeline::stress {
namespace {

using interpreter::Vector;

constexpr double kStep = 2e-4;  ///< s

/// How a loop is kept closed: by gains on its errors, and by going to the nearest closed pose and
/// the nearest permitted velocity after each step.
struct Keeping {
  std::vector<double> gains{0, 0};
  bool projected = false;
};

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
      robot.step(kStep, keeping.gains, q, qd);
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

}  // namespace

std::vector<Experiment> loop_experiments() {
  return {{"loop", loop}, {"precise_loops", precise_loops}};
}

}  // namespace treeline::stress
