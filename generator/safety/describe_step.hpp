#pragma once

#include <string>

#include "generation/generate_code.hpp"

namespace treeline {

/// How the controller's step behaves, as a point of the list about the code's behaviour.
std::string describe_step_behaviour(const std::string& name);

/// Describes the controller's step for a reviewer, as Markdown: the safe state, faults with
/// reactions and times, what the settings guard and which of them guard nothing, limits that do not
/// exist, and what it takes from the surrounding program. `generation` has a controller.
std::string describe_step(const Scene& scene, const Generation& generation);

}  // namespace treeline
