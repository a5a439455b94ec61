#pragma once

#include "simulation/integrate.hpp"
#include "simulation/strike.hpp"

namespace treeline::simulation {

enum class Stepper { semi_implicit_euler, runge_kutta };

/// Settings for the alternation of contact and flight.
struct SimulationSettings {
  double step = 1e-3;  ///< s
  Stepper stepper = Stepper::runge_kutta;
  Surface surface;
};

/// Account of the energy.
struct EnergyAccount {
  double start = 0;     ///< J
  double now = 0;       ///< J, of the present state
  double by_blows = 0;  ///< J, gained in all blows, computed from their impulses
  /// Energy (J) that neither blows nor joint torques explain: the integrator's error. Valid without
  /// torques.
  [[nodiscard]] double drift() const { return now - start - by_blows; }
};

/// State of a running simulation.
struct Simulation {
  const Model& model;
  const CollisionScene& scene;
  SimulationSettings settings;
  Acceleration acceleration;  ///< during flight; empty: forward dynamics without joint torques
  double time = 0;
  State state;
  EnergyAccount energy;
  int blows = 0;
  double worst_account = 0;  ///< J, largest difference between the energy of a blow and the work of
                             ///< its impulses
};

Simulation start_simulation(const Model& model, const CollisionScene& scene,
                            const SimulationSettings& settings, State state);

/// Advances the simulation by one step: detects touches at the coordinates, applies a blow where
/// shapes approach, and integrates. If all shapes separate, or would by the end of the step, this
/// is a step of flight. If some stay in touch, it is a step by Moreau's method: velocities first as
/// in free flight, then a second blow without restitution, then coordinates with the resulting
/// velocities, so that resting bodies do not sink. Returns the blows: none, one or two.
std::vector<Blow> step(Simulation& simulation);

}  // namespace treeline::simulation
