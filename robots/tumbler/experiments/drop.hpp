#pragma once

#include <string>
#include <vector>

#include "report/plot.hpp"
#include "report/table.hpp"
#include "tumbler.hpp"

/// Chang chapter 8, impulse-based simulation: the tumbler falls onto the ground and bounces.
namespace treeline::experiments {

struct DropSettings {
  double restitution = 1;
  double friction = 0;
  double height = 1.2;    ///< of the torso's centre, m
  double duration = 2.5;  ///< s
  double step = 2.5e-4;   ///< s
};

struct DropRun {
  DropSettings settings;
  report::Table table;  ///< one row per 2 ms
  int blows = 0;
  int most_touches = 0;       ///< largest number at once
  double lost = 0;            ///< in all blows, J
  double start = 0;           ///< J
  double drift = 0;           ///< error of the integrator, J
  double worst_loss = 0;      ///< largest deviation of a blow's loss from restitution's, J
  double worst_account = 0;   ///< between energies by velocities and by impulses, J
  double worst_momentum = 0;  ///< between a blow's change of momentum and its impulses, N s and N m
                              ///< s
  double sideways = 0;        ///< largest change of horizontal momentum in a blow, N s
  double deepest = 0;         ///< largest depth of a ball in the ground, m
  double worst_quaternion = 0;
  int unconverged = 0;
};

DropRun run_drop(const simulation::Model& model, const DropSettings& settings);

/// Simulates the three runs of the experiment.
std::vector<DropRun> run_drops(const simulation::Model& model, double duration);

std::string drop_summary(const DropRun& run);
report::Plot drop_figure(const std::vector<DropRun>& runs);

/// Whether the claims of README.md hold.
bool drop_claims_hold(const DropRun& run);

}  // namespace treeline::experiments
