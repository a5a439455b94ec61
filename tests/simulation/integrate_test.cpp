#include "simulation/integrate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>

#include "core/coordinates.hpp"
#include "simulation/sample.hpp"

// Would catch: a wrong order of an integrator, quaternions that lose unit length, a body whose
// velocity is not rotated into the world, and energy or momentum that is not conserved.

namespace treeline::tests {
namespace {

using namespace simulation;  // NOLINT(google-build-using-namespace)
using simulation::State;

Acceleration free_motion(const Model& model) {
  return [&model](double, const State& at) {
    return interpreter::forward_dynamics<double>(model, at.q, at.qd, Vector::Zero(model.nv));
  };
}

const RandomOptions kFloatingTree{
    .joints = 6, .branching = 0.4, .mix = {5, 1, 1, 0, 0.5, 0.5}, .floating_base = true};

template <class Step>
State after(const Sample& sample, double duration, int steps, Step step) {
  const Coordinates coordinates = coordinates_of(sample.model);
  const Acceleration acceleration = free_motion(sample.model);
  State state = sample.state;
  for (int i = 0; i < steps; ++i) {
    const double dt = duration / steps;
    step(coordinates, acceleration, i * dt, dt, state);
  }
  return state;
}

double distance(const State& a, const State& b) {
  return (a.q - b.q).norm() + (a.qd - b.qd).norm();
}

double worst_quaternion(const Model& model, const State& state) {
  double worst = 0;
  for (const auto& joint : coordinates_of(model).quaternions) {
    worst = std::max(worst, std::abs(state.q.segment<4>(joint.quaternion()).norm() - 1));
  }
  return worst;
}

// Halving the step divides the error by 2 to the power of the order.
TEST(Integrators, HaveTheirOrder) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const Sample sample = random_sample(seed, kFloatingTree);
    const State exact = after(sample, 0.3, 3000, step_runge_kutta);
    const auto error = [&](auto step, int steps) {
      return distance(after(sample, 0.3, steps, step), exact);
    };
    EXPECT_NEAR(
        std::log2(error(step_semi_implicit_euler, 400) / error(step_semi_implicit_euler, 800)), 1,
        0.2);
    EXPECT_NEAR(std::log2(error(step_runge_kutta, 30) / error(step_runge_kutta, 60)), 4, 0.5);
  }
}

TEST(Integrators, KeepQuaternionsUnitAndReportTheirDrift) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const Sample sample = random_sample(seed, kFloatingTree);
    const double start = mechanical_energy(sample.model, sample.state);
    const double kinetic = 1 + kinetic_energy(sample.model, sample.state);
    const auto drift = [&](const State& state) {
      EXPECT_LT(worst_quaternion(sample.model, state), 1e-14);
      return (mechanical_energy(sample.model, state) - start) / kinetic;
    };
    const double euler = drift(after(sample, 0.5, 1000, step_semi_implicit_euler));
    const double runge_kutta = drift(after(sample, 0.5, 1000, step_runge_kutta));
    State adaptive = sample.state;
    const AdaptiveReport report =
        integrate_adaptively(coordinates_of(sample.model), free_motion(sample.model), 0, 0.5,
                             AdaptiveSettings{}, adaptive);
    const double by_adaptive = drift(adaptive);
    std::cout << "energy drift over 0.5 s of the kinetic energy: semi-implicit Euler " << euler
              << ", Runge-Kutta " << runge_kutta << " (1000 steps each), adaptive " << by_adaptive
              << " (" << report.steps << " steps, " << report.rejected << " rejected)\n";
    EXPECT_TRUE(report.arrived);
    EXPECT_LT(std::abs(euler), 0.05);
    EXPECT_LT(std::abs(runge_kutta), 1e-6);
    EXPECT_LT(std::abs(by_adaptive), 1e-7);
  }
}

// Nothing but gravity acts on it, which only the total momentum shows.
// What controllers integrate with and what moves the simulated robot are the same.
TEST(Integrators, MoveAsTheCoreDoes) {
  const Sample sample = random_sample(11, {.joints = 0, .floating_base = true}, 4);
  ASSERT_EQ(sample.model.nq, 7);
  simulation::Vector moved = sample.state.q;
  move(simulation::coordinates_of(sample.model), sample.state.qd, 0.2, moved);
  double q[7], qd[6], next[7];
  std::copy(sample.state.q.begin(), sample.state.q.end(), q);
  std::copy(sample.state.qd.begin(), sample.state.qd.end(), qd);
  const core::QuaternionJoint base[] = {{0, true}};
  core::integrate(base, q, qd, 0.2, next);
  for (int i = 0; i < 7; ++i) EXPECT_NEAR(next[i], moved(i), 4e-15) << i;
}

TEST(Integrators, KeepTheMomentumOfWhatFallsFreely) {
  const Sample sample = random_sample(5, kFloatingTree);
  const auto before = momentum(sample.model, sample.state);
  const State fallen = after(sample, 0.2, 1000, step_runge_kutta);
  double mass = 0;
  for (const auto& body : sample.model.bodies) mass += body.mass;
  const interpreter::Vector6<double> gained = momentum(sample.model, fallen) - before;
  EXPECT_NEAR(gained(0), 0, 1e-7 * mass);
  EXPECT_NEAR(gained(1), 0, 1e-7 * mass);
  EXPECT_NEAR(gained(2), -9.81 * 0.2 * mass, 1e-7 * mass);
}

TEST(AdaptiveIntegrator, TakesShorterStepsForLessError) {
  const Sample sample = random_sample(2, kFloatingTree);
  const State exact = after(sample, 0.2, 4000, step_runge_kutta);
  double error_before = 1;
  int steps_before = 0;
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    State state = sample.state;
    AdaptiveSettings settings;
    settings.relative = settings.absolute = tolerance;
    const auto report = integrate_adaptively(coordinates_of(sample.model),
                                             free_motion(sample.model), 0, 0.2, settings, state);
    EXPECT_TRUE(report.arrived);
    EXPECT_GT(report.steps, steps_before);
    EXPECT_LT(distance(state, exact), error_before);
    error_before = distance(state, exact);
    steps_before = report.steps;
  }
  EXPECT_LT(error_before, 1e-6);
}

// In a state from which integration is impossible, it reports that instead of continuing forever.
TEST(AdaptiveIntegrator, GivesUpWhereNoStepIsShortEnough) {
  const Sample sample = random_sample(2, kFloatingTree);
  State state = sample.state;
  const Acceleration jumps = [&](double time, const State&) -> Vector {
    return Vector::Constant(sample.model.nv, 1 / std::max(1e-300, (0.1 - time) * (0.1 - time)));
  };
  const auto report =
      integrate_adaptively(coordinates_of(sample.model), jumps, 0, 0.2, AdaptiveSettings{}, state);
  EXPECT_FALSE(report.arrived);
}

// A spring along it would have energy: half its square changes by it times the velocities. Would
// catch ways in other axes than the velocities', and turns the long way round.
TEST(Displacement, IsThatOfAConservativeSpring) {
  RandomOptions options = kFloatingTree;
  options.mix.ball = 1;
  int balls = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Sample sample = random_sample(seed, options);
    const Coordinates coordinates = coordinates_of(sample.model);
    Rng rng(seed);
    for (const double size : {1e-12, 0.1, 1.0}) {
      const Vector start = sample.state.q;
      Vector q = start;
      move(coordinates, random_entries<double>(rng, sample.model.nv, size), 1, q);
      const Vector way = displacement(coordinates, start, q);
      const auto energy = [&](double time) {
        Vector moved = q;
        move(coordinates, sample.state.qd, time, moved);
        return 0.5 * displacement(coordinates, start, moved).squaredNorm();
      };
      const double rate = (energy(1e-5) - energy(-1e-5)) / 2e-5;
      EXPECT_NEAR(rate, way.dot(sample.state.qd), 1e-8 * (1 + size)) << seed;
      for (const auto& joint : coordinates.quaternions) {
        q.segment<4>(joint.quaternion()) *= -1;  // the same rotations
        balls += joint.has_position ? 0 : 1;
      }
      EXPECT_LT((displacement(coordinates, start, q) - way).norm(), 1e-15 + 1e-12 * size) << seed;
    }
  }
  EXPECT_GT(balls, 0);
}

}  // namespace
}  // namespace treeline::tests
