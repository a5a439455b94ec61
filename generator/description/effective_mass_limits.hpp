#pragma once

#include <vector>

#include "description/scene.hpp"

namespace treeline {

/// The effective mass (kg; kg m^2 in rows of rotation) beyond which each row is relaxed of the
/// task, as the emitted code's Real has it; empty where the scene does not ask for damping.
std::vector<double> effective_mass_limits(const Scene& scene);

}  // namespace treeline
