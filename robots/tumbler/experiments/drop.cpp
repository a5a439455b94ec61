#include "drop.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "interpreter/instances.hpp"
#include "simulation/integrate.hpp"

namespace treeline::experiments {
namespace {

using simulation::GroundShape;
using simulation::Vector3;

GroundShape ball(const simulation::Model& model, const std::string& link, double radius,
                 double down) {
  return {body_named(model, link), link, {{0, 0, -down}}, radius};
}

std::vector<GroundShape> shapes_of(const simulation::Model& model) {
  std::vector<GroundShape> shapes{ball(model, "torso", 0.12, 0)};
  for (const char* limb : {"front_left", "front_right", "hind_left", "hind_right"}) {
    shapes.push_back(ball(model, std::string(limb) + "_shank", 0.03, 0));
    shapes.push_back(ball(model, std::string(limb) + "_shank", 0.03, 0.18));
  }
  return shapes;
}

/// Energy that a blow without friction gains according to its restitution, -(1 - e) / 2 sum y
/// (-v_n), less what it takes of an approach that it leaves. What is slower than `slow` (m/s) does
/// not bounce.
double gain_by_restitution(const simulation::Blow& blow, double slow) {
  double gain = 0;
  for (std::size_t i = 0; i < blow.touches.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const Vector3& n = blow.touches[i].normal;
    const double y = n.dot(blow.impulses.segment<3>(row));
    const double v = n.dot(blow.before.segment<3>(row));
    const double e = std::abs(v) >= slow ? blow.restitution : 0;
    gain += 0.5 * y * ((1 - e) * v - blow.touches[i].allowed);
  }
  return gain;
}

/// What gravity makes in four steps does not bounce, m/s.
double slow_of(const DropSettings& settings) {
  return 4 * 9.81 * settings.step;
}

/// Sum of the impulses and of their moments about the world's origin.
interpreter::Vector6<double> given_by(const simulation::Blow& blow) {
  interpreter::Vector6<double> total = interpreter::Vector6<double>::Zero();
  for (std::size_t i = 0; i < blow.touches.size(); ++i) {
    const Vector3 y = blow.impulses.segment<3>(3 * static_cast<int>(i));
    total += interpreter::stack<double>(y, blow.touches[i].position.cross(y));
  }
  return total;
}

void account(const simulation::Blow& blow, DropRun& run) {
  run.lost -= blow.work;
  run.worst_account = std::max(run.worst_account, std::abs(blow.work - blow.energy));
  run.most_touches = std::max(run.most_touches, static_cast<int>(blow.touches.size()));
  run.worst_momentum = std::max(run.worst_momentum, (blow.momentum - given_by(blow)).norm());
  if (run.settings.friction == 0) {
    const double off = std::abs(blow.energy - gain_by_restitution(blow, slow_of(run.settings)));
    run.worst_loss = std::max(run.worst_loss, off);
    run.sideways = std::max(run.sideways, blow.momentum.head<2>().norm());
  }
}

double quaternion_error(const simulation::Model& model, const simulation::Vector& q) {
  double worst = 0;
  for (const auto& joint : simulation::coordinates_of(model).quaternions) {
    worst = std::max(worst, std::abs(q.segment<4>(joint.quaternion()).norm() - 1));
  }
  return worst;
}

std::string run_name(const DropSettings& settings) {
  return settings.friction > 0
             ? fmt::format("e = {}, friction {}", settings.restitution, settings.friction)
             : fmt::format("e = {}", settings.restitution);
}

}  // namespace

DropRun run_drop(const simulation::Model& model, const DropSettings& settings) {
  const auto coordinates = simulation::coordinates_of(model);
  const simulation::Acceleration free = [&model](double, const simulation::State& at) {
    return interpreter::forward_dynamics<double>(model, at.q, at.qd,
                                                 simulation::Vector::Zero(model.nv));
  };
  const int steps = static_cast<int>(settings.duration / settings.step);
  auto state = tumbler_start(model, settings.height);
  DropRun run{settings,
              report::Table(report::with_coordinates({"time", "height", "kinetic", "energy",
                                                      "drift", "blows", "touches"},
                                                     static_cast<int>(state.q.size())),
                            static_cast<std::size_t>(steps) + 1)};
  run.start = simulation::mechanical_energy(model, state);
  const simulation::Ground ground(model, shapes_of(model));
  simulation::OnGround robot{
      model, ground, {settings.restitution, settings.friction, slow_of(settings)}, {}};
  robot.flight = [&](double time, double dt, simulation::State& at) {
    step_runge_kutta(coordinates, free, time, dt, at);
    return true;
  };
  std::size_t touches = 0;
  robot.on_blow = [&](const simulation::Blow& blow) {
    account(blow, run);
    touches = blow.touches.size();
  };
  simulation::GroundAccount totals;
  for (int i = 0; i < steps; ++i) {
    touches = 0;
    step_on_ground(robot, i * settings.step, settings.step, state, totals);
    run.blows += touches > 0 ? 1 : 0;
    run.worst_quaternion = std::max(run.worst_quaternion, quaternion_error(model, state.q));
    const double energy = simulation::mechanical_energy(model, state);
    run.drift = energy - run.start - totals.energy;
    if (i % 8 != 0) continue;
    std::vector<double> row = {(i + 1) * settings.step,
                               center_of_mass(model, state.q).z(),
                               simulation::kinetic_energy(model, state),
                               energy,
                               run.drift,
                               static_cast<double>(run.blows),
                               static_cast<double>(touches)};
    row.insert(row.end(), state.q.begin(), state.q.end());
    run.table.append(row.data());
  }
  run.deepest = totals.deepest;
  run.unconverged = totals.unconverged;
  return run;
}

std::vector<DropRun> run_drops(const simulation::Model& model, double duration) {
  std::vector<DropRun> runs;
  for (const auto& [restitution, friction] :
       {std::pair{1.0, 0.0}, std::pair{0.5, 0.0}, std::pair{0.5, 0.6}}) {
    DropSettings settings;
    settings.restitution = restitution;
    settings.friction = friction;
    settings.duration = duration;
    runs.push_back(run_drop(model, settings));
  }
  return runs;
}

std::string drop_summary(const DropRun& run) {
  std::string text = fmt::format(
      "{}\n  {} steps with blows, up to {} balls at once, {} not converged; deepest {:.1e} m\n"
      "  energy {:.4f} J at first, blows took {:.4f} J, integration made {:+.2e} J of it\n"
      "  worst blow: {:.1e} J between velocities and impulses, {:.1e} N s of momentum\n",
      run_name(run.settings), run.blows, run.most_touches, run.unconverged, run.deepest, run.start,
      run.lost, run.drift, run.worst_account, run.worst_momentum);
  if (run.settings.friction == 0) {
    text += fmt::format(
        "  worst blow: {:.1e} J from what restitution says; sideways momentum within {:.1e} N s\n",
        run.worst_loss, run.sideways);
  }
  return text;
}

report::Plot drop_figure(const std::vector<DropRun>& runs) {
  report::Plot plot;
  plot.title = "A falling tree of nine links bounces (Chang chapter 8)";
  plot.x_label = "time (s)";
  plot.x = runs.front().table.column(0);
  plot.panels = {{"Height of the centre of mass", "height (m)", {}, 0.1},
                 {"Mechanical energy", "energy (J)", {}, 1.0},
                 {"Steps in which something touched", "count", {}, 1.0},
                 {"Energy that neither blows nor gravity account for", "energy (J)", {}, 1e-3}};
  constexpr std::size_t kColumns[] = {1, 3, 5, 4};
  for (const DropRun& run : runs) {
    for (std::size_t i = 0; i < 4; ++i) {
      plot.panels[i].lines.push_back(
          {run_name(run.settings), run.table.column(kColumns[i]), false});
    }
  }
  return plot;
}

bool drop_claims_hold(const DropRun& run) {
  // Allowance for rounding at the size of the energy, and for integration over the whole run.
  const double small = 1e-9 * std::abs(run.start);
  bool hold = run.blows > 0 && run.unconverged == 0 && run.worst_account < small &&
              run.worst_momentum < 1e-8 && run.worst_quaternion < 1e-12 && run.deepest < 0.01;
  hold = hold && std::abs(run.drift) < 0.05 * std::abs(run.start);
  if (run.settings.friction == 0) {
    hold = hold && run.worst_loss < small && run.sideways < 1e-8;
  }
  if (run.settings.friction == 0 && run.settings.restitution == 1) {
    hold = hold && std::abs(run.lost) < small;
  }
  return hold;
}

}  // namespace treeline::experiments
