#include "cli/stepped_robot.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "choice/for_each_index.hpp"
#include "cli/find_all_meshes.hpp"
#include "cli/simulate_motion.hpp"
#include "cli/simulated_scene.hpp"
#include "description/read_surroundings.hpp"
#include "interpreter/instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/interpreted_robot.hpp"
#include "oracle/leave_out_singular.hpp"
#include "oracle/model_from_robot.hpp"
#include "simulation/integrate.hpp"

namespace treeline {
namespace {

using simulation::Vector;

/// Constant joint forces act on a robot that flies by steps of the fourth order.
simulation::Flight fly_by(const simulation::Model& model, const Vector& tau) {
  const simulation::Acceleration qdd = [&model, &tau](double, const simulation::State& state) {
    return interpreter::forward_dynamics<double>(model, state.q, state.qd, tau);
  };
  return [&model, qdd](double time, double dt, simulation::State& state) {
    simulation::step_runge_kutta(simulation::coordinates_of(model), qdd, time, dt, state);
    return state.q.allFinite() && state.qd.allFinite();
  };
}

/// What of a robot stays the same from step to step.
struct Surrounded {
  const simulation::Model& model;
  const std::optional<simulation::Ground>& ground;
  const std::optional<simulation::Surface>& surface;  ///< of the ground; there may be stops alone
  const simulation::Flight& flight;
};

/// Makes all steps; false where a state leaves the finite.
bool advance(const StepSettings& settings, const Surrounded& robot, simulation::State& state,
             simulation::GroundAccount& account) {
  simulation::normalise_quaternions(simulation::coordinates_of(robot.model), state.q);
  for (int k = 0; k < settings.steps; ++k) {
    const double time = k * settings.seconds;
    if (!robot.ground) {
      if (!robot.flight(time, settings.seconds, state)) return false;
      continue;
    }
    const simulation::OnGround on{robot.model, *robot.ground,
                                  robot.surface.value_or(simulation::Surface{}), robot.flight};
    if (!step_on_ground(on, time, settings.seconds, state, account)) return false;
  }
  return true;
}

}  // namespace

SteppedRobot::SteppedRobot(const Robot& robot, const Scene& scene,
                           std::optional<GroundOfRobot> ground)
    : model_(model_from_robot<double>(robot, scene)),
      coordinates_(reduced_mechanism(robot, scene).coordinates),
      ground_(std::move(ground)) {
  arguments_ = {{"q", model_.nq, 1, "joint positions"},
                {"qd", model_.nv, 1, "joint velocities"},
                {"tau", model_.nv, 1, "joint forces, constant"}};
  results_ = {{"q", model_.nq, 1, "joint positions"},
              {"qd", model_.nv, 1, "joint velocities"},
              {"force", 3, 1, "mean force of the ground, N, world"},
              {"contacts", 1, 1, "points that the ground pressed in the last step"}};
}

std::vector<double> SteppedRobot::step(const StepSettings& settings, std::size_t states,
                                       const std::vector<double>& numbers) const {
  const std::size_t inputs = count_numbers(arguments_);
  const std::size_t outputs = count_numbers(results_);
  std::vector<double> results(states * outputs, std::numeric_limits<double>::quiet_NaN());
  const auto below = make_ground(model_, coordinates_, ground_, settings.stops);
  const auto surface = make_surface(model_, ground_, settings.seconds);
  const auto step_one = [&](std::size_t i) {
    const double* const given = numbers.data() + i * inputs;
    const Vector all = Vector::Map(given, static_cast<Eigen::Index>(inputs));
    if (!all.allFinite()) return;
    simulation::State state{all.head(model_.nq), all.segment(model_.nq, model_.nv)};
    const Vector tau = all.tail(model_.nv);
    const simulation::Flight flight = fly_by(model_, tau);
    simulation::GroundAccount account;
    if (!advance(settings, {model_, below, surface, flight}, state, account)) return;
    const simulation::Vector3 force = account.impulse / (settings.steps * settings.seconds);
    double* at = results.data() + i * outputs;
    at = std::copy(state.q.begin(), state.q.end(), at);
    at = std::copy(state.qd.begin(), state.qd.end(), at);
    at = std::copy(force.begin(), force.end(), at);
    *at = account.contacts;
  };
  for_each_index(states, step_one, states > 1 ? 0 : 1);
  return results;
}

std::optional<SteppedRobot> make_stepped_robot(const RobotAndScene& inputs,
                                               Diagnostics& diagnostics) {
  const Robot& robot = inputs.robot;
  const Scene& scene = inputs.scene;
  refuse_unheld(robot, scene, diagnostics);
  if (diagnostics.has_errors() || !has_accelerations(robot, scene, diagnostics)) return {};
  std::optional<GroundOfRobot> ground;
  if (const auto law = surroundings_of(inputs.files.scene_text, robot).ground) {
    const auto places = read_mesh_places({}, diagnostics);
    if (!places) return std::nullopt;
    ground = {*law, read_ground_shapes(inputs.files, *places, diagnostics)};
    const auto model = model_from_robot<double>(robot, scene);
    if (!can_touch(*make_ground(model, {}, ground, false), diagnostics)) return std::nullopt;
  }
  if (diagnostics.has_errors()) return std::nullopt;
  return SteppedRobot(robot, scene, std::move(ground));
}

}  // namespace treeline
