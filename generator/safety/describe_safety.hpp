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

}  // namespace treeline
