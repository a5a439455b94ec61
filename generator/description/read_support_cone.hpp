#pragma once

#include <string>

#include "description/scene.hpp"
#include "description/scene_element.hpp"

namespace treeline {

/// The keys of a constraint that limit its forces.
inline constexpr std::array kConeKeys = {"friction", "torsional", "half_extents", "sides",
                                         "least_force"};

/// Reads the limits of the forces of a constraint to the world, if it has some, into `scene`.
void read_support_cone(const SceneElement& item, const SceneFields& fields, const ScenePoint& held,
                       Scene& scene);

}  // namespace treeline
