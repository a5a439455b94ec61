#pragma once

#include <functional>

#include "simulation/state.hpp"

namespace treeline::simulation {

/// qdd at a time and a state.
using Acceleration = std::function<Vector(double time, const State& state)>;

/// One step of `dt` seconds, first order, symplectic for what is integrable: velocities first, then
/// coordinates with the new ones. Energy oscillates by O(dt) and does not drift away.
void step_semi_implicit_euler(const Coordinates& coordinates, const Acceleration& acceleration,
                              double time, double dt, State& state);

/// One step of the classical Runge-Kutta method, fourth order; quaternions made unit afterwards.
void step_runge_kutta(const Coordinates& coordinates, const Acceleration& acceleration, double time,
                      double dt, State& state);

struct AdaptiveSettings {
  double relative = 1e-10;  ///< error allowed to each step, of each entry's size
  double absolute = 1e-10;
  double first_step = 1e-3;   ///< s
  double least_step = 1e-12;  ///< s: below that the motion is given up
};

struct AdaptiveReport {
  int steps = 0;         ///< taken
  int rejected = 0;      ///< tried and found too long
  double next_step = 0;  ///< s, to go on with
  bool arrived = false;  ///< at the end; false where steps became too short
};

/// From `start` to `end` by steps as long as the error allows, Cash & Karp's Runge-Kutta method of
/// fifth order (Boost.Odeint); quaternions made unit after each.
AdaptiveReport integrate_adaptively(const Coordinates& coordinates,
                                    const Acceleration& acceleration, double start, double end,
                                    const AdaptiveSettings& settings, State& state);

}  // namespace treeline::simulation
