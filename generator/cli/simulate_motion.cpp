#include "cli/simulate_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "interpreter/instances.hpp"
#include "interpreter/joint_forces.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "simulation/integrate.hpp"
#include "terminal/option_values.hpp"

namespace treeline {
namespace {

using simulation::Vector;

/// The middle of a joint's range: where neither limit is near.
double middle(const Coordinate& coordinate) {
  const bool limited = std::isfinite(coordinate.lower) && std::isfinite(coordinate.upper);
  return limited ? (coordinate.lower + coordinate.upper) / 2 : coordinate.neutral();
}

std::optional<simulation::State> start_state(const simulation::Model& model,
                                             const Mechanism& mechanism,
                                             const MotionSettings& settings,
                                             Diagnostics& diagnostics) {
  const bool q_fits = has_size("--q", settings.q, model.nq, diagnostics);
  if (!has_size("--qd", settings.qd, model.nv, diagnostics) || !q_fits) return std::nullopt;
  simulation::State state{Vector::Zero(model.nq), Vector::Zero(model.nv)};
  for (int i = 0; i < model.nq; ++i) {
    const auto k = static_cast<std::size_t>(i);
    state.q[i] = settings.q.empty() ? middle(mechanism.coordinates[k]) : settings.q[k];
  }
  if (!settings.qd.empty()) state.qd = Vector::Map(settings.qd.data(), model.nv);
  simulation::normalise_quaternions(simulation::coordinates_of(model), state.q);
  return state;
}

/// Joint forces that someone asked for, at a state.
using JointForces = std::function<Vector(const simulation::State&)>;

/// On a ground nothing but the ground holds a floating base.
JointForces joint_forces_of(const simulation::Model& model, bool holds_weight, bool on_ground,
                            const JointSprings& springs) {
  return [&model, holds_weight, on_ground, springs](const simulation::State& state) {
    Vector tau = force_of(springs, state);
    if (!holds_weight) return tau;
    const Vector rest = Vector::Zero(model.nv);
    Vector weight = interpreter::inverse_dynamics<double>(model, state.q, rest, rest);
    for (const auto& body : model.bodies) {
      const bool floats = body.kind == interpreter::JointKind::floating;
      if (floats && on_ground) weight.segment<6>(body.v).setZero();
    }
    return Vector(tau + weight);
  };
}

/// The power that friction of the joints takes, W.
double friction_power(const simulation::Model& model, const simulation::State& state) {
  double power = 0;
  for (const auto& body : model.bodies) {
    if (interpreter::velocity_count(body.kind) != 1) continue;
    const double rate = interpreter::joint_velocity<double>(body, state.qd)(0);
    power += rate * interpreter::friction_force<double>(body, rate);
  }
  return power;
}

bool has_friction(const simulation::Model& model) {
  return std::any_of(model.bodies.begin(), model.bodies.end(),
                     [](const auto& body) { return body.damping != 0 || body.friction != 0; });
}

/// Integrates the work of joint forces and friction along with a motion: it is one more velocity,
/// so that its error is of the same order as theirs.
class CountedFlight {
 public:
  /// With contacts the energy of flights is counted apart from theirs.
  CountedFlight(const simulation::Model& model, JointForces forces, bool has_contacts)
      : model_(model),
        forces_(std::move(forces)),
        has_contacts_(has_contacts),
        coordinates_(simulation::coordinates_of(model)) {
    ++coordinates_.nq;
    ++coordinates_.nv;
  }

  [[nodiscard]] const simulation::Coordinates& coordinates() const { return coordinates_; }

  [[nodiscard]] simulation::Acceleration acceleration() const {
    return [this](double, const simulation::State& counted) {
      const simulation::State state = without_work(counted);
      const Vector tau = forces_(state);
      return with_number(interpreter::forward_dynamics<double>(model_, state.q, state.qd, tau),
                         state.qd.dot(tau) - friction_power(model_, state));
    };
  }

  /// Flies by `integrate(state)`, whose answer it returns.
  template <class Integrate>
  bool fly(simulation::State& state, const Integrate& integrate) const {
    const double before = energy_of(state);
    simulation::State counted{with_number(state.q, 0), with_number(state.qd, 0)};
    const bool arrived = integrate(counted);
    const simulation::FlightAccount flown = state.flown;
    state = without_work(counted);
    state.flown.work = flown.work + counted.qd[model_.nv];
    state.flown.change = flown.change + energy_of(state) - before;
    return arrived;
  }

 private:
  [[nodiscard]] double energy_of(const simulation::State& state) const {
    return has_contacts_ ? simulation::mechanical_energy(model_, state) : 0;
  }

  [[nodiscard]] simulation::State without_work(const simulation::State& counted) const {
    return {counted.q.head(model_.nq), counted.qd.head(model_.nv)};
  }

  static Vector with_number(const Vector& numbers, double last) {
    Vector longer(numbers.size() + 1);
    longer << numbers, last;
    return longer;
  }

  const simulation::Model& model_;
  JointForces forces_;
  bool has_contacts_;
  simulation::Coordinates coordinates_;
};

std::vector<std::string> column_names(const simulation::Model& model, bool on_ground) {
  std::vector<std::string> names = {"time_s"};
  for (int i = 0; i < model.nq; ++i) names.push_back(fmt::format("q{}", i));
  for (int i = 0; i < model.nv; ++i) names.push_back(fmt::format("qd{}", i));
  names.emplace_back("energy_J");
  if (on_ground) {
    names.insert(names.end(), {"contacts", "ground_x_N", "ground_y_N", "ground_z_N"});
  }
  return names;
}

double quaternion_error(const simulation::Coordinates& coordinates, const Vector& q) {
  double worst = 0;
  for (const auto& joint : coordinates.quaternions) {
    worst = std::max(worst, std::abs(q.segment(joint.quaternion(), 4).norm() - 1));
  }
  return worst;
}

/// No force here makes energy by the million: steps that are too long do.
bool is_credible(double energy, const Motion& motion) {
  constexpr double kGain = 1e6;
  return motion.table.rows() == 0 ||
         energy < motion.start_energy + kGain * (1 + std::abs(motion.start_energy));
}

/// Steps after the first row; nothing, with an error, where they make no table.
std::optional<int> count_steps(std::size_t columns, const MotionSettings& settings,
                               Diagnostics& diagnostics) {
  constexpr double kMostNumbers = 1e8;  // 800 MB
  const auto reject = [&](std::string fault, std::string remedy) {
    diagnostics.add({Severity::error, "", 0, "--step", std::move(fault), std::move(remedy)});
    return std::nullopt;
  };
  if (settings.step > settings.seconds) {
    return reject(fmt::format("a step of {:g} s is longer than the motion of {:g} s", settings.step,
                              settings.seconds),
                  "give a shorter --step or more --seconds");
  }
  const double steps = std::ceil(settings.seconds / settings.step - 1e-9);
  if ((steps + 1) * static_cast<double>(columns) <= kMostNumbers) return static_cast<int>(steps);
  return reject(fmt::format("{:.3g} rows of {} numbers are more than {:g} numbers", steps + 1,
                            columns, kMostNumbers),
                "give a longer --step or fewer --seconds");
}

/// A robot that is let go, and what is recorded of it.
class Run {
 public:
  /// `surface` is of the ground; there may be stops alone.
  Run(const simulation::Model& model, const MotionSettings& settings,
      const std::optional<simulation::Ground>& ground,
      const std::optional<simulation::Surface>& surface, const JointSprings& springs,
      simulation::State start)
      : model_(model),
        settings_(settings),
        ground_(ground),
        surface_(surface),
        counted_(model, joint_forces_of(model, settings.holds_weight, surface.has_value(), springs),
                 ground.has_value()),
        qdd_(counted_.acceleration()),
        adaptive_{settings.tolerance, settings.tolerance, std::min(1e-3, settings.step)},
        state_(std::move(start)) {}

  [[nodiscard]] Motion run(int steps) {
    const auto names = column_names(model_, surface_.has_value());
    Motion motion{report::Table(names, static_cast<std::size_t>(steps) + 1)};
    motion.rows_planned = steps + 1;
    motion.has_quaternions = !counted_.coordinates().quaternions.empty();
    motion.has_contacts = ground_.has_value();
    motion.has_joint_forces = settings_.has_joint_forces() || has_friction(model_);
    if (surface_) motion.ground.emplace();
    for (int i = 0; record(i * settings_.step, motion) && i < steps; ++i) {
      if (!advance(i * settings_.step, motion)) break;
    }
    return motion;
  }

 private:
  /// Records a row; false where the motion has left the finite and the credible.
  bool record(double time, Motion& motion) {
    const double energy = simulation::mechanical_energy(model_, state_);
    const bool finite = std::isfinite(energy) && state_.q.allFinite();
    if (!finite || !is_credible(energy, motion)) return false;
    if (motion.table.rows() == 0) motion.start_energy = energy;
    motion.energy_change = energy - motion.start_energy;
    motion.joint_work = state_.flown.work;
    if (ground_) motion.contact_energy = motion.energy_change - state_.flown.change;
    motion.largest_change = std::max(motion.largest_change, std::abs(motion.energy_change));
    motion.quaternion_error =
        std::max(motion.quaternion_error, quaternion_error(counted_.coordinates(), state_.q));
    std::vector<double> row = {time};
    row.insert(row.end(), state_.q.begin(), state_.q.end());
    row.insert(row.end(), state_.qd.begin(), state_.qd.end());
    row.push_back(energy);
    if (motion.ground) {
      const simulation::Vector3 force = (motion.ground->impulse - impulse_) / settings_.step;
      impulse_ = motion.ground->impulse;
      row.push_back(motion.ground->contacts);
      row.insert(row.end(), force.begin(), force.end());
    }
    return motion.table.append(row.data());
  }

  /// One row's time further; false where an adaptive step became too short.
  bool advance(double time, Motion& motion) {
    const simulation::Flight flight = [&](double from, double dt, simulation::State& state) {
      return fly(from, dt, state, motion);
    };
    if (!ground_) return flight(time, settings_.step, state_);
    const bool whole = settings_.integrator == Integrator::semi_implicit_euler;
    const simulation::OnGround robot{model_, *ground_, surface_.value_or(simulation::Surface{}),
                                     flight, whole};
    const bool flew = step_on_ground(robot, time, settings_.step, state_, account_);
    if (motion.ground) motion.ground = account_;
    return flew;
  }

  bool fly(double time, double dt, simulation::State& state, Motion& motion) {
    return counted_.fly(
        state, [&](simulation::State& counted) { return integrate(time, dt, counted, motion); });
  }

  bool integrate(double time, double dt, simulation::State& state, Motion& motion) {
    const simulation::Coordinates& coordinates = counted_.coordinates();
    switch (settings_.integrator) {
      case Integrator::semi_implicit_euler:
        simulation::step_semi_implicit_euler(coordinates, qdd_, time, dt, state);
        return true;
      case Integrator::runge_kutta:
        simulation::step_runge_kutta(coordinates, qdd_, time, dt, state);
        return true;
      case Integrator::adaptive:
        break;
    }
    const auto report =
        simulation::integrate_adaptively(coordinates, qdd_, time, time + dt, adaptive_, state);
    motion.adaptive_steps += report.steps;
    motion.rejected_steps += report.rejected;
    adaptive_.first_step = report.next_step;
    return report.arrived;
  }

  const simulation::Model& model_;
  const MotionSettings& settings_;
  const std::optional<simulation::Ground>& ground_;
  const std::optional<simulation::Surface> surface_;
  const CountedFlight counted_;
  const simulation::Acceleration qdd_;
  simulation::AdaptiveSettings adaptive_;
  simulation::State state_;
  simulation::GroundAccount account_;
  simulation::Vector3 impulse_ = simulation::Vector3::Zero();  ///< of the rows before
};

}  // namespace

std::optional<Motion> simulate_motion(const Robot& robot, const Scene& scene,
                                      const MotionSettings& settings,
                                      const std::optional<GroundOfRobot>& ground,
                                      Diagnostics& diagnostics) {
  const auto model = model_from_robot<double>(robot, scene);
  const Mechanism mechanism = reduced_mechanism(robot, scene);
  auto state = start_state(model, mechanism, settings, diagnostics);
  if (!state) return std::nullopt;
  const auto steps =
      count_steps(column_names(model, ground.has_value()).size(), settings, diagnostics);
  const auto below = make_ground(model, mechanism.coordinates, ground, settings.stops);
  const bool starts =
      (!ground || start_on_ground(model, *below, settings, *state, diagnostics)) &&
      (!settings.stops || starts_between_stops(mechanism.coordinates, *state, diagnostics));
  if (!starts || !steps) return std::nullopt;
  const auto surface = make_surface(model, ground, settings.step);
  const JointSprings springs =
      make_springs(model, mechanism.coordinates, settings, *state, ground.has_value(), diagnostics);
  return Run(model, settings, below, surface, springs, std::move(*state)).run(*steps);
}

report::Plot plot_motion(const std::string& robot, const Motion& motion) {
  const auto& names = motion.table.names();
  report::Plot plot{robot + ", let go", "time, s", motion.table.column(0), {}};
  report::PlotPanel positions{"coordinates", "rad, m", {}};
  report::PlotPanel rates{"velocities", "rad/s, m/s", {}};
  report::PlotPanel forces{"force of the ground", "N", {}};
  report::PlotPanel energies{"energy since the start", "J", {}};
  for (std::size_t i = 1; i < names.size(); ++i) {
    const std::string& name = names[i];
    std::vector<double> column = motion.table.column(i);
    if (name == "energy_J") {
      for (double& energy : column) energy -= motion.start_energy;
      energies.lines.push_back({"", std::move(column)});
    } else if (name.starts_with("ground")) {
      forces.lines.push_back({name.substr(7, 1), std::move(column)});
    } else if (name.starts_with("q")) {
      (name.starts_with("qd") ? rates : positions)
          .lines.push_back({names.size() < 16 ? name : "", std::move(column)});
    }
  }
  plot.panels = {std::move(positions), std::move(rates), std::move(energies)};
  if (!forces.lines.empty()) plot.panels.push_back(std::move(forces));
  return plot;
}

}  // namespace treeline
