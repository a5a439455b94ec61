#include "simulation/simulate.hpp"

#include <algorithm>
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

namespace {

void fly(Simulation& simulation, const Coordinates& coordinates) {
  const auto step_flight = simulation.settings.stepper == Stepper::runge_kutta
                               ? step_runge_kutta
                               : step_semi_implicit_euler;
  step_flight(coordinates, simulation.acceleration, simulation.time, simulation.settings.step,
              simulation.state);
}

/// Applies a blow and adds it to the energy account.
Blow struck(Simulation& simulation, const std::vector<Touch>& touches, const Surface& surface) {
  Blow blow = strike(simulation.model, touches, surface, simulation.state);
  simulation.energy.by_blows += blow.work;
  simulation.worst_account = std::max(simulation.worst_account, std::abs(blow.work - blow.energy));
  return blow;
}

/// Whether two touching shapes would approach each other with these velocities.
bool approaches(const Model& model, const std::vector<Touch>& touches, const State& state) {
  State copy = state;
  const Blow blow = strike(model, touches, {}, copy);
  return blow.impulses.size() > 0 && blow.impulses.norm() > 0;
}

}  // namespace

std::vector<Blow> step(Simulation& simulation) {
  const SimulationSettings& settings = simulation.settings;
  const Coordinates coordinates = coordinates_of(simulation.model);
  State& state = simulation.state;
  std::vector<Blow> blows;
  const auto touches = simulation.scene.touches(simulation.model, state.q);
  if (touches.empty()) {
    fly(simulation, coordinates);
  } else {
    blows.push_back(struck(simulation, touches, settings.surface));
    ++simulation.blows;
    State ahead = state;
    ahead.qd += settings.step * simulation.acceleration(simulation.time, state);
    if (approaches(simulation.model, touches, ahead)) {
      state.qd = ahead.qd;
      Surface resting = settings.surface;
      resting.restitution = 0;
      blows.push_back(struck(simulation, touches, resting));
      move(coordinates, state.qd, settings.step, state.q);
    } else {
      fly(simulation, coordinates);
    }
  }
  simulation.time += settings.step;
  simulation.energy.now = mechanical_energy(simulation.model, state);
  return blows;
}

}  // namespace treeline::simulation
