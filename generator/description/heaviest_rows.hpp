#pragma once

#include <vector>

#include "description/scene.hpp"

namespace treeline {

/// The heaviest motion (kg; kg m^2 in rows of rotation) of each row of the task, as the emitted
/// code's Real has it; empty where the scene does not ask for damping.
std::vector<double> heaviest_rows(const Scene& scene);

}  // namespace treeline
