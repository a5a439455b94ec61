#include "simulation/integrate.hpp"

#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <vector>

namespace treeline::simulation {
namespace {

State moved(const State& from, double dt, const Vector& rates, const Vector& acceleration) {
  return {from.q + dt * rates, from.qd + dt * acceleration};
}

/// State in the form of Odeint: [q; qd].
std::vector<double> joined(const State& state) {
  std::vector<double> x(state.q.begin(), state.q.end());
  x.insert(x.end(), state.qd.begin(), state.qd.end());
  return x;
}

State split(const Coordinates& coordinates, const std::vector<double>& x) {
  return {Vector::Map(x.data(), coordinates.nq),
          Vector::Map(x.data() + coordinates.nq, coordinates.nv)};
}

}  // namespace

void step_semi_implicit_euler(const Coordinates& coordinates, const Acceleration& acceleration,
                              double time, double dt, State& state) {
  state.qd += dt * acceleration(time, state);
  move(coordinates, state.qd, dt, state.q);
}

void step_runge_kutta(const Coordinates& coordinates, const Acceleration& acceleration, double time,
                      double dt, State& state) {
  constexpr double kFractions[] = {0.0, 0.5, 0.5, 1.0};
  constexpr double kWeights[] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
  State sum = state;
  Vector rates = Vector::Zero(coordinates.nq);
  Vector qdd = Vector::Zero(coordinates.nv);
  for (int stage = 0; stage < 4; ++stage) {
    const double ahead = kFractions[stage] * dt;
    const State at = moved(state, ahead, rates, qdd);
    rates = coordinate_rates(coordinates, at.q, at.qd);
    qdd = acceleration(time + ahead, at);
    sum = moved(sum, kWeights[stage] * dt, rates, qdd);
  }
  normalise_quaternions(coordinates, sum.q);
  state = sum;
}

AdaptiveReport integrate_adaptively(const Coordinates& coordinates,
                                    const Acceleration& acceleration, double start, double end,
                                    const AdaptiveSettings& settings, State& state) {
  namespace odeint = boost::numeric::odeint;
  const auto system = [&](const std::vector<double>& x, std::vector<double>& rates, double time) {
    const State at = split(coordinates, x);
    rates = joined({coordinate_rates(coordinates, at.q, at.qd), acceleration(time, at)});
  };
  auto stepper = odeint::make_controlled<odeint::runge_kutta_cash_karp54<std::vector<double>>>(
      settings.absolute, settings.relative);
  AdaptiveReport report;
  report.next_step = settings.first_step;
  double time = start;
  while (end - time > settings.least_step && report.next_step >= settings.least_step) {
    double dt = std::min(report.next_step, end - time);
    const bool cut = dt < report.next_step;
    std::vector<double> x = joined(state);
    if (stepper.try_step(system, x, time, dt) == odeint::fail) {
      ++report.rejected;
      report.next_step = dt;
      continue;
    }
    ++report.steps;
    report.next_step = cut ? std::max(dt, report.next_step) : dt;
    state = split(coordinates, x);
    normalise_quaternions(coordinates, state.q);
  }
  report.arrived = end - time <= settings.least_step;
  return report;
}

}  // namespace treeline::simulation
