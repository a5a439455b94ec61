#pragma once

#include <map>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/emission_context.hpp"
#include "generation/generate_code.hpp"

namespace treeline {

/// Counts what each argument that is of the robot costs, by function: how many operations more than
/// in a scene that does not list it under `inputs`. Empty if the scene lists nothing there.
std::map<std::string, std::vector<EmissionContext::InputCost>> count_inputs(
    const Robot& robot, const Scene& scene, const std::vector<GeneratedFunction>& functions);

}  // namespace treeline
