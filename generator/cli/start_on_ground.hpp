#pragma once

#include <optional>
#include <vector>

#include "cli/simulate_motion.hpp"

namespace treeline {

/// The ground for a model, on whose bodies the shapes are found by their links.
std::optional<simulation::Ground> make_ground(const simulation::Model& model,
                                              std::vector<simulation::GroundShape> shapes);

/// Moves a start so that no point is in the ground: floating robots up by what the lowest point
/// lacks, with a note, or to the height that is asked for. Errors: a start in the ground that was
/// given or of a robot that does not float; no shape that could touch the ground.
bool start_on_ground(const simulation::Model& model, const simulation::Ground& ground,
                     const MotionSettings& settings, simulation::State& state,
                     Diagnostics& diagnostics);

}  // namespace treeline
