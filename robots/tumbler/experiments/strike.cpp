#include "strike.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "interpreter/instances.hpp"

namespace treeline::experiments {
namespace {

using simulation::Model;
using simulation::State;
using simulation::Vector;
using simulation::Vector3;
using Vector6 = interpreter::Vector6<double>;

/// A direction that is not special for the robot.
const Vector3 kDirection = Vector3(0.3, -0.5, 0.8).normalized();

/// The point to strike: the lower end of a limb's link, or a point on the torso's skin.
Vector3 struck_point(const std::string& link) {
  return link == "torso" ? Vector3(0.12, 0, 0) : Vector3(0, 0, -0.18);
}

struct Strike {
  const Model& model;
  interpreter::Points<double> point;
  State state;

  [[nodiscard]] interpreter::ContactMotion<double> motion() const {
    return interpreter::contact_motion<double>(model, point, state.q, state.qd);
  }
};

void apply(const Vector3& y, Strike& strike, StruckLink& struck) {
  const Model& model = strike.model;
  State& state = strike.state;
  const auto before = strike.motion();
  const Vector6 momentum = simulation::momentum(model, state);
  const double energy = simulation::kinetic_energy(model, state);
  state.qd += interpreter::impulse_response<double>(model, strike.point, state.q, y).dqd;
  const auto after = strike.motion();
  struck.energy = simulation::kinetic_energy(model, state) - energy;
  struck.work = 0.5 * y.dot(before.velocity + after.velocity);
  const Vector3 at = before.position;
  const Vector6 given = interpreter::stack<double>(y, at.cross(y));
  struck.momentum_error = (simulation::momentum(model, state) - momentum - given).norm();
}

void fly(Strike& strike, double duration, StruckLink& struck) {
  const Model& model = strike.model;
  const auto coordinates = simulation::coordinates_of(model);
  const simulation::Acceleration free = [&](double, const State& at) {
    return interpreter::forward_dynamics<double>(model, at.q, at.qd, Vector::Zero(model.nv));
  };
  const Vector6 momentum = simulation::momentum(model, strike.state);
  const double energy = simulation::kinetic_energy(model, strike.state);
  simulation::AdaptiveSettings settings;
  constexpr double kReport = 5e-3;
  for (int i = 0; i * kReport < duration; ++i) {
    const auto report = simulation::integrate_adaptively(coordinates, free, i * kReport,
                                                         (i + 1) * kReport, settings, strike.state);
    settings.first_step = report.next_step;
    struck.steps += report.steps;
    const Vector6 now = simulation::momentum(model, strike.state);
    const double kinetic = simulation::kinetic_energy(model, strike.state);
    struck.flight_momentum = std::max(struck.flight_momentum, (now - momentum).norm());
    struck.flight_energy = std::max(struck.flight_energy, std::abs(kinetic - energy));
    const double row[] = {(i + 1) * kReport, strike.motion().velocity.norm(), kinetic,
                          kDirection.dot(now.head<3>())};
    struck.flight.append(row);
  }
}

}  // namespace

StrikeRun run_strikes(const Model& robot, double impulse, double flight) {
  Model model = robot;
  model.gravity.setZero();
  StrikeRun run{impulse, {}};
  const auto rows = static_cast<std::size_t>(flight / 5e-3) + 2;
  for (int i = 0; i < model.size(); ++i) {
    const std::string& link = model.body(i).name;
    StruckLink struck{
        link, 0, 0, 0, 0, 0, 0, 0, report::Table({"time", "speed", "kinetic", "momentum"}, rows)};
    Strike strike{model,
                  {interpreter::contact_point<double>(i, struck_point(link))},
                  tumbler_start(model, 0)};
    struck.mass =
        interpreter::effective_masses<double>(model, strike.point, strike.state.q, kDirection)(0);
    apply(impulse * kDirection, strike, struck);
    fly(strike, flight, struck);
    run.links.push_back(std::move(struck));
  }
  return run;
}

std::string strike_summary(const StrikeRun& run) {
  std::string text = fmt::format(
      "{} N s at each link in turn\n{:18} {:>9} {:>10} {:>10} {:>9} {:>14} {:>13}\n", run.impulse,
      "link", "mass kg", "energy J", "work J", "momentum", "kept in flight", "energy kept J");
  for (const StruckLink& s : run.links) {
    text +=
        fmt::format("{:18} {:9.4f} {:10.5f} {:10.5f} {:9.1e} {:14.1e} {:13.1e}\n", s.link, s.mass,
                    s.energy, s.work, s.momentum_error, s.flight_momentum, s.flight_energy);
  }
  return text;
}

std::string strike_csv(const StrikeRun& run) {
  std::string text = "link,mass,energy,work,momentum_error,flight_momentum,flight_energy\n";
  for (const StruckLink& s : run.links) {
    text += fmt::format("{},{},{},{},{},{},{}\n", s.link, s.mass, s.energy, s.work,
                        s.momentum_error, s.flight_momentum, s.flight_energy);
  }
  return text;
}

report::Plot strike_figure(const StrikeRun& run) {
  report::Plot plot;
  plot.title = fmt::format("A free tree of nine links, struck with {} N s", run.impulse);
  plot.x_label = "time after the blow (s)";
  plot.x = run.links.front().flight.column(0);
  plot.panels = {{"Speed of the struck point", "speed (m/s)", {}, 0.1},
                 {"Kinetic energy: stays", "energy (J)", {}, 0.1},
                 {"Momentum along the blow: the same wherever it struck", "N s", {}, 0.1}};
  for (const StruckLink& s : run.links) {
    if (s.link.find("right") != std::string::npos) continue;  // five lines suffice
    std::string name = s.link;
    std::replace(name.begin(), name.end(), '_', ' ');
    for (std::size_t i = 0; i < 3; ++i) {
      plot.panels[i].lines.push_back({name, s.flight.column(i + 1), false});
    }
  }
  return plot;
}

bool strike_claims_hold(const StrikeRun& run) {
  return std::all_of(run.links.begin(), run.links.end(), [](const StruckLink& s) {
    return s.momentum_error < 1e-12 && std::abs(s.energy - s.work) < 1e-10 * std::abs(s.work) &&
           s.flight_momentum < 1e-6 && s.flight_energy < 1e-6 * s.work && s.mass > 0;
  });
}

}  // namespace treeline::experiments
