#pragma once

#include <string>

#include "generation/generate_code.hpp"

namespace treeline {

/// How the controller's step behaves, as a point of the list about the code's behaviour.
std::string describe_step_behaviour(const std::string& name);

/// What a reviewer has to know of the controller's step, as Markdown: the safe state, faults with
/// reactions and times, what the settings guard and which of them guard nothing, limits that there
/// are not, and what it takes from the surrounding program. `generation` has a controller.
std::string describe_step(const Scene& scene, const Generation& generation);

}  // namespace treeline
