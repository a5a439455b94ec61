#pragma once

#include <string>
#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Says for the contract which parameter each column of the regressors belongs to, if the scene
/// asks for regressors.
void append_regressor_notes(const Scene& scene, const Mechanism& mechanism,
                            std::vector<std::string>& notes);

}  // namespace treeline
