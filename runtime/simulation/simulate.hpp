#pragma once

#include "simulation/integrate.hpp"
#include "simulation/strike.hpp"

namespace treeline::simulation {

enum class Stepper { semi_implicit_euler, runge_kutta };

/// How contacts and flight alternate.
struct SimulationSettings {
  double step = 1e-3;  ///< s
  Stepper stepper = Stepper::runge_kutta;
  Surface surface;
};

/// Where energy went.
struct EnergyAccount {
  double start = 0;     ///< J
  double now = 0;       ///< J, of the state
  double by_blows = 0;  ///< J, sum of what blows gained, from their impulses alone
  /// What neither blows nor joint torques account for: the integrator's own. Without torques.
  [[nodiscard]] double drift() const { return now - start - by_blows; }
};

/// A simulation under way.
struct Simulation {
  const Model& model;
  const CollisionScene& scene;
  SimulationSettings settings;
  Acceleration acceleration;  ///< in flight; empty: forward dynamics without joint torques
  double time = 0;
  State state;
  EnergyAccount energy;
  int blows = 0;
  double worst_account = 0;  ///< J, largest difference of a blow's energy and its impulses' work
};

Simulation start_simulation(const Model& model, const CollisionScene& scene,
                            const SimulationSettings& settings, State state);

/// One step: detect at the coordinates, strike where shapes approach, then integrate. Where
/// everything then parts, or would by the end of the step, that is a step of flight. Where
/// something stays in touch it is Moreau's: velocities first as in free flight, then a second blow,
/// without restitution, then coordinates with what came of it, so that what rests does not sink.
/// Returns the blows: none, one or two.
std::vector<Blow> step(Simulation& simulation);

}  // namespace treeline::simulation
