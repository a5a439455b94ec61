#include "cli/simulate_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/option_values.hpp"
#include "interpreter/instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "simulation/integrate.hpp"

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

simulation::Acceleration acceleration_of(const simulation::Model& model,
                                         const MotionSettings& settings) {
  return [&model, &settings](double, const simulation::State& state) {
    Vector tau = -settings.damping * state.qd;
    if (settings.holds_weight) {
      const Vector rest = Vector::Zero(model.nv);
      tau += interpreter::inverse_dynamics<double>(model, state.q, rest, rest);
    }
    return interpreter::forward_dynamics<double>(model, state.q, state.qd, tau);
  };
}

std::vector<std::string> column_names(const simulation::Model& model) {
  std::vector<std::string> names = {"time_s"};
  for (int i = 0; i < model.nq; ++i) names.push_back(fmt::format("q{}", i));
  for (int i = 0; i < model.nv; ++i) names.push_back(fmt::format("qd{}", i));
  names.emplace_back("energy_J");
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

/// Records a row; false where the motion has left the finite and the credible.
bool record(const simulation::Model& model, const simulation::Coordinates& coordinates, double time,
            const simulation::State& state, Motion& motion) {
  const double energy = simulation::mechanical_energy(model, state);
  if (!std::isfinite(energy) || !state.q.allFinite() || !is_credible(energy, motion)) return false;
  if (motion.table.rows() == 0) motion.start_energy = energy;
  motion.energy_change = energy - motion.start_energy;
  motion.largest_change = std::max(motion.largest_change, std::abs(motion.energy_change));
  motion.quaternion_error =
      std::max(motion.quaternion_error, quaternion_error(coordinates, state.q));
  std::vector<double> row = {time};
  row.insert(row.end(), state.q.begin(), state.q.end());
  row.insert(row.end(), state.qd.begin(), state.qd.end());
  row.push_back(energy);
  return motion.table.append(row.data());
}

/// One row's time further; false where an adaptive step became too short.
bool advance(const simulation::Coordinates& coordinates, const simulation::Acceleration& qdd,
             double time, const MotionSettings& settings, simulation::AdaptiveSettings& adaptive,
             simulation::State& state, Motion& motion) {
  switch (settings.integrator) {
    case Integrator::semi_implicit_euler:
      simulation::step_semi_implicit_euler(coordinates, qdd, time, settings.step, state);
      return true;
    case Integrator::runge_kutta:
      simulation::step_runge_kutta(coordinates, qdd, time, settings.step, state);
      return true;
    case Integrator::adaptive:
      break;
  }
  const auto report = simulation::integrate_adaptively(coordinates, qdd, time, time + settings.step,
                                                       adaptive, state);
  motion.adaptive_steps += report.steps;
  motion.rejected_steps += report.rejected;
  adaptive.first_step = report.next_step;
  return report.arrived;
}

/// Rows after the first; nothing, with an error, where they make no table.
std::optional<int> count_steps(const simulation::Model& model, const MotionSettings& settings,
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
  const auto columns = static_cast<double>(column_names(model).size());
  if ((steps + 1) * columns <= kMostNumbers) return static_cast<int>(steps);
  return reject(fmt::format("{:.3g} rows of {} numbers are more than {:g} numbers", steps + 1,
                            columns, kMostNumbers),
                "give a longer --step or fewer --seconds");
}

}  // namespace

std::optional<Motion> simulate_motion(const Robot& robot, const Scene& scene,
                                      const MotionSettings& settings, Diagnostics& diagnostics) {
  const auto model = model_from_robot<double>(robot, scene);
  auto state = start_state(model, reduced_mechanism(robot, scene), settings, diagnostics);
  if (!state) return std::nullopt;
  const auto coordinates = simulation::coordinates_of(model);
  const auto qdd = acceleration_of(model, settings);
  const auto steps = count_steps(model, settings, diagnostics);
  if (!steps) return std::nullopt;
  Motion motion{report::Table(column_names(model), static_cast<std::size_t>(*steps) + 1),
                *steps + 1};
  motion.has_quaternions = !coordinates.quaternions.empty();
  simulation::AdaptiveSettings adaptive{settings.tolerance, settings.tolerance,
                                        std::min(1e-3, settings.step)};
  for (int i = 0; record(model, coordinates, i * settings.step, *state, motion) && i < *steps;
       ++i) {
    if (!advance(coordinates, qdd, i * settings.step, settings, adaptive, *state, motion)) break;
  }
  return motion;
}

report::Plot plot_motion(const std::string& robot, const Motion& motion) {
  const auto& names = motion.table.names();
  report::Plot plot{robot + ", let go", "time, s", motion.table.column(0), {}};
  report::PlotPanel positions{"coordinates", "rad, m", {}};
  report::PlotPanel rates{"velocities", "rad/s, m/s", {}};
  for (std::size_t i = 1; i + 1 < names.size(); ++i) {
    (names[i].starts_with("qd") ? rates : positions)
        .lines.push_back({names.size() < 16 ? names[i] : "", motion.table.column(i)});
  }
  std::vector<double> change = motion.table.column(names.size() - 1);
  for (double& energy : change) energy -= motion.start_energy;
  report::PlotPanel energy{"energy since the start", "J", {{"", std::move(change)}}};
  plot.panels = {std::move(positions), std::move(rates), std::move(energy)};
  return plot;
}

}  // namespace treeline
