#pragma once

#include <string>
#include <vector>

#include "servo/plot.hpp"
#include "servo/table.hpp"
#include "tumbler.hpp"

/// Chang chapter 8, impulse-based simulation: the tumbler falls onto the ground and bounces.
namespace treeline::experiments {

struct DropSettings {
  double restitution = 1;
  double friction = 0;
  double height = 1.2;    ///< m, of the torso's centre
  double duration = 2.5;  ///< s
  double step = 2.5e-4;   ///< s
};

struct DropRun {
  DropSettings settings;
  servo::Table table;  ///< a row for each 2 ms
  int blows = 0;
  int most_touches = 0;       ///< at once
  double lost = 0;            ///< J, by all blows
  double start = 0;           ///< J
  double drift = 0;           ///< J, what the integrator made of energy
  double worst_loss = 0;      ///< J, of a blow from what restitution says; without friction
  double worst_account = 0;   ///< J, between velocities and impulses
  double worst_momentum = 0;  ///< N s, N m s, between a blow's change of momentum and its impulses
  double sideways = 0;        ///< N s, largest change of horizontal momentum by a blow
  double deepest = 0;         ///< m, of any ball in the ground
  double worst_quaternion = 0;
  int unconverged = 0;
};

DropRun run_drop(const simulation::Model& model, const DropSettings& settings);

/// The three runs of the experiment.
std::vector<DropRun> run_drops(const simulation::Model& model, double duration);

std::string drop_summary(const DropRun& run);
servo::Plot drop_figure(const std::vector<DropRun>& runs);

/// What README.md claims.
bool drop_claims_hold(const DropRun& run);

}  // namespace treeline::experiments
