#pragma once

#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Notes what the scene's language, profile and name leave out of the code though it has a meaning
/// without: the header for C beside C++, and loops over links.
void note_left_out(const Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
