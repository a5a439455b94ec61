#pragma once

#include <string>
#include <vector>

#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Names of all targets, as scenes and `--target` write them.
std::vector<std::string> target_names();

/// Bytes of one number of this type.
int bytes_of(Real real);

/// Sets what follows from the scene's language, profile and target: its lanes, if the author does
/// not ask for any. C has lanes only through an extension of GCC and Clang, and gets none unasked.
void follow_target(Scene& scene);

/// Warns if the target emulates the scene's `real`, and what that costs, or has no registers for
/// lanes that the author has chosen.
void warn_of_target(const Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
