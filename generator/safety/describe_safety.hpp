#pragma once

#include <string>
#include <vector>

#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "safety/evidence.hpp"

namespace treeline {

/// Writes what a reviewer of functional safety has to know of generated code, as Markdown: tool,
/// inputs and outputs with digests, assumptions that the surrounding program must meet, bounds of
/// errors, stack and size, deviations from MISRA, evidence, and what is not covered. The
/// same inputs give the same bytes.
std::string describe_safety(const Scene& scene, const Generation& generation,
                            const Provenance& provenance, const std::vector<Evidence>& evidence);

/// Lists the rules of MISRA C:2012 or MISRA C++:2023 from which the code of the scene's language
/// and profile deviates, why, and how that is known, as Markdown.
std::string describe_deviations(const Scene& scene);

/// How the controller's step behaves, as a point of the list about the code's behaviour.
std::string describe_step_behaviour(const std::string& name);

/// Describes the controller's step for a reviewer, as Markdown: the safe state, faults with
/// reactions and times, what the settings guard and which of them guard nothing, limits that do not
/// exist, and what it takes from the surrounding program. `generation` has a controller.
std::string describe_step(const Scene& scene, const Generation& generation);

}  // namespace treeline
