#pragma once

#include <optional>
#include <string>

#include "simulation/step_on_ground.hpp"

namespace treeline::experiments {

/// Loads the robot of a URDF as a freely falling one. Returns nothing, with the reason in `error`,
/// if it cannot be read.
std::optional<simulation::Model> load_floating(const std::string& urdf, std::string& error);

/// Index of the body with this name, which must exist.
int body_named(const simulation::Model& model, const std::string& name);

/// Initial state: limbs splayed, tilted and rotating, with the torso's centre at `height` (m).
simulation::State tumbler_start(const simulation::Model& model, double height);

/// Position of the centre of mass, m.
simulation::Vector3 center_of_mass(const simulation::Model& model, const simulation::Vector& q);

}  // namespace treeline::experiments
