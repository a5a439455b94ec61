#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Whether the link's inertial parameters are an argument, so that no link contains those of the
/// file.
bool has_parameters_as_input(const Scene& scene, const std::string& link);

/// Finds what the scene's `inputs` name in the robot. `frames`: where the frames of all links of
/// the URDF are, in its order.
MechanismInputs place_inputs(const Robot& robot, const Scene& scene,
                             const std::vector<MechanismPoint>& frames);

/// Takes all that moves out of the mechanism's links: base parameters stand in its place.
void take_base_parameters(Mechanism& mechanism);

/// Inertia of a moving link together with those parameters of the file that are arguments.
Inertia nominal_inertia(const Mechanism& mechanism, int link);

}  // namespace treeline
