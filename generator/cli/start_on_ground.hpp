#pragma once

#include <optional>
#include <vector>

#include "cli/simulate_motion.hpp"
#include "mechanism/coordinate.hpp"

namespace treeline {

/// The ground, if there is one, for a model, on whose bodies the shapes are found by their links;
/// and, with `stops`, the ends of its joints' ranges.
std::optional<simulation::Ground> make_ground(const simulation::Model& model,
                                              const std::vector<Coordinate>& coordinates,
                                              const std::optional<GroundOfRobot>& ground,
                                              bool stops);

/// Whether any link can touch the ground; else with an error.
bool can_touch(const simulation::Ground& ground, Diagnostics& diagnostics);

/// How the ground, if there is one, answers in steps of so many seconds: what gravity makes in four
/// of them does not bounce, nor rounding.
std::optional<simulation::Surface> make_surface(const simulation::Model& model,
                                                const std::optional<GroundOfRobot>& ground,
                                                double step);

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
