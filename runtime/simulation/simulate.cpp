#include "simulation/simulate.hpp"

#include <cmath>

#include "interpreter/instances.hpp"

namespace treeline::simulation {

Simulation start_simulation(const Model& model, const CollisionScene& scene,
                            const SimulationSettings& settings, State state) {
  Simulation simulation{model, scene, settings, {}, 0, std::move(state), {}, 0, 0};
  simulation.acceleration = [&model](double, const State& at) {
    return interpreter::forward_dynamics<double>(model, at.q, at.qd, Vector::Zero(model.nv));
  };
  simulation.energy.start = mechanical_energy(model, simulation.state);
  simulation.energy.now = simulation.energy.start;
  return simulation;
}

Blow step(Simulation& simulation) {
  const Model& model = simulation.model;
  const SimulationSettings& settings = simulation.settings;
  const Coordinates coordinates = coordinates_of(model);
  State& state = simulation.state;
  const double dt = settings.step;
  Blow blow;
  auto touches = simulation.scene.touches(model, state.q);
  if (!touches.empty()) {
    state.qd += dt * simulation.acceleration(simulation.time, state);
    blow = strike(model, std::move(touches), settings.surface, state);
    move(coordinates, state.qd, dt, state.q);
    simulation.energy.by_blows += blow.work;
    simulation.worst_account =
        std::max(simulation.worst_account, std::abs(blow.work - blow.energy));
    ++simulation.blows;
  } else if (settings.stepper == Stepper::runge_kutta) {
    step_runge_kutta(coordinates, simulation.acceleration, simulation.time, dt, state);
  } else {
    step_semi_implicit_euler(coordinates, simulation.acceleration, simulation.time, dt, state);
  }
  simulation.time += dt;
  simulation.energy.now = mechanical_energy(model, state);
  return blow;
}

}  // namespace treeline::simulation
