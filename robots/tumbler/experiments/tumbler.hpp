#pragma once

#include <optional>
#include <string>

#include "simulation/simulate.hpp"

namespace treeline::experiments {

/// The robot of a URDF as it falls freely; nothing, with the reason in `error`, if it cannot be
/// read.
std::optional<simulation::Model> load_floating(const std::string& urdf, std::string& error);

/// The index of the body of this name; the robot has one.
int body_named(const simulation::Model& model, const std::string& name);

/// Splayed, tilted and turning, its torso's centre at `height`.
simulation::State tumbler_start(const simulation::Model& model, double height);

/// Height of the centre of mass, m.
simulation::Vector3 center_of_mass(const simulation::Model& model, const simulation::Vector& q);

}  // namespace treeline::experiments
