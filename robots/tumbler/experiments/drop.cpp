#include "drop.hpp"

#include <fmt/core.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace treeline::experiments {
namespace {

using simulation::Shape;
using simulation::ShapeKind;
using simulation::Vector3;

Shape ball(const simulation::Model& model, const std::string& link, double radius, double down) {
  Shape shape;
  shape.name = link;
  shape.kind = ShapeKind::sphere;
  shape.size.x() = radius;
  shape.body = body_named(model, link);
  shape.p.z() = -down;
  return shape;
}

std::vector<Shape> shapes_of(const simulation::Model& model) {
  std::vector<Shape> shapes{ball(model, "torso", 0.12, 0)};
  for (const char* limb : {"front_left", "front_right", "hind_left", "hind_right"}) {
    shapes.push_back(ball(model, std::string(limb) + "_shank", 0.03, 0));
    shapes.push_back(ball(model, std::string(limb) + "_shank", 0.03, 0.18));
  }
  Shape ground;
  ground.name = "ground";
  ground.kind = ShapeKind::half_space;
  shapes.push_back(ground);
  return shapes;
}

/// Energy that a blow without friction gains according to its restitution: -(1 - e) / 2 sum y
/// (-v_n).
double gain_by_restitution(const simulation::Blow& blow) {
  return 0.5 * (1 - blow.restitution) * blow.impulses.dot(blow.before);
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
  run.most_touches = std::max(run.most_touches, static_cast<int>(blow.touches.size()));
  run.unconverged += blow.solution.converged ? 0 : 1;
  for (const auto& touch : blow.touches) {
    run.deepest = std::max(run.deepest, touch.depth);
  }
  run.worst_momentum = std::max(run.worst_momentum, (blow.momentum - given_by(blow)).norm());
  if (run.settings.friction == 0) {
    const double off = std::abs(blow.energy - gain_by_restitution(blow));
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
  const simulation::CollisionScene scene(model, shapes_of(model));
  simulation::SimulationSettings how;
  how.step = settings.step;
  how.surface = {settings.restitution, settings.friction, 0};
  auto simulation = start_simulation(model, scene, how, tumbler_start(model, settings.height));
  const int steps = static_cast<int>(settings.duration / settings.step);
  DropRun run{settings,
              report::Table(report::with_coordinates({"time", "height", "kinetic", "energy",
                                                      "drift", "blows", "touches"},
                                                     static_cast<int>(simulation.state.q.size())),
                            static_cast<std::size_t>(steps) + 1)};
  run.start = simulation.energy.start;
  for (int i = 0; i < steps; ++i) {
    std::size_t touches = 0;
    for (const simulation::Blow& blow : step(simulation)) {
      account(blow, run);
      touches = blow.touches.size();
    }
    run.worst_quaternion =
        std::max(run.worst_quaternion, quaternion_error(model, simulation.state.q));
    if (i % 8 == 0) {
      std::vector<double> row = {simulation.time,
                                 center_of_mass(model, simulation.state.q).z(),
                                 simulation::kinetic_energy(model, simulation.state),
                                 simulation.energy.now,
                                 simulation.energy.drift(),
                                 static_cast<double>(simulation.blows),
                                 static_cast<double>(touches)};
      const simulation::Vector& q = simulation.state.q;
      row.insert(row.end(), q.begin(), q.end());
      run.table.append(row.data());
    }
  }
  run.blows = simulation.blows;
  run.drift = simulation.energy.drift();
  run.worst_account = simulation.worst_account;
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
