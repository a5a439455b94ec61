#pragma once

#include <functional>

#include "simulation/state.hpp"

namespace treeline::simulation {

/// Accelerations qdd at a time and a state.
using Acceleration = std::function<Vector(double time, const State& state)>;

/// One step of `dt` seconds by the semi-implicit Euler method, which is of first order and
/// symplectic for integrable systems: velocities first, then coordinates with the new velocities.
/// Energy oscillates by O(dt) and does not drift.
void step_semi_implicit_euler(const Coordinates& coordinates, const Acceleration& acceleration,
                              double time, double dt, State& state);

/// One step of `dt` seconds by the classical fourth-order Runge-Kutta method. Quaternions are
/// normalized afterwards.
void step_runge_kutta(const Coordinates& coordinates, const Acceleration& acceleration, double time,
                      double dt, State& state);

struct AdaptiveSettings {
  double relative = 1e-10;  ///< error allowed in each step, relative to each entry
  double absolute = 1e-10;
  double first_step = 1e-3;   ///< s
  double least_step = 1e-12;  ///< s; if shorter steps are needed, integration fails
};

struct AdaptiveReport {
  int steps = 0;         ///< taken
  int rejected = 0;      ///< tried and found too long
  double next_step = 0;  ///< s, for continuing
  bool arrived = false;  ///< the end was reached; false if steps became too short
};

/// Integrates from time `start` to `end` with steps as long as the error permits, by the
/// fifth-order Runge-Kutta method of Cash & Karp (Boost.Odeint). Quaternions are normalized after
/// each step.
AdaptiveReport integrate_adaptively(const Coordinates& coordinates,
                                    const Acceleration& acceleration, double start, double end,
                                    const AdaptiveSettings& settings, State& state);

}  // namespace treeline::simulation
