#pragma once

#include <optional>
#include <vector>

#include "cli/simulate_motion.hpp"
#include "mechanism/coordinate.hpp"

namespace treeline {

/// The ground, if there is one, for a model, on whose bodies the shapes are found by their links;
/// and, if `settings` says so, the stops of its joints.
std::optional<simulation::Ground> make_ground(const simulation::Model& model,
                                              const std::vector<Coordinate>& coordinates,
                                              const std::optional<GroundOfRobot>& ground,
                                              const MotionSettings& settings);

/// Whether a start is between the stops; else with an error that names the first joint that is not.
bool starts_between_stops(const std::vector<Coordinate>& coordinates,
                          const simulation::State& start, Diagnostics& diagnostics);

/// Moves a start so that no point is in the ground: floating robots up by what the lowest point
/// lacks, with a note, or to the height that is asked for. Errors: a start in the ground that was
/// given or of a robot that does not float; no shape that could touch the ground.
bool start_on_ground(const simulation::Model& model, const simulation::Ground& ground,
                     const MotionSettings& settings, simulation::State& state,
                     Diagnostics& diagnostics);

}  // namespace treeline
