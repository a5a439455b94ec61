#pragma once

#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Seconds that a compiler takes for a function of so many operations as straight lines, by the
/// flags of the emitted CMakeLists.txt; an estimate.
double estimate_compile_seconds(int flops);

/// A warning where the functions are so long that compiling them by the emitted CMakeLists.txt is
/// felt: how much source there is, how long a compiler takes, and what makes less of it.
void warn_of_size(const Scene& scene, const Generation& generation, Diagnostics& diagnostics);

/// A warning where the scene's controller states a `speed_rise` and motors need a longer one, which
/// is emitted.
void warn_of_speed_rise(const Scene& scene, const Generation& generation, Diagnostics& diagnostics);

}  // namespace treeline
