#pragma once

#include "description/scene.hpp"
#include "functions/quantity.hpp"

namespace treeline {

/// Whether the scene makes this quantity of the robot an argument.
inline bool has_input(const Scene& scene, Quantity quantity) {
  switch (quantity) {
    case Quantity::gravity:
      return scene.inputs.gravity;
    case Quantity::payload:
      return !scene.inputs.payloads.empty();
    case Quantity::parameters:
      return !scene.inputs.parameters.empty();
    case Quantity::tool:
      return !scene.inputs.tools.empty();
    default:
      return false;
  }
}

/// Leaves this quantity of the robot as the files have it.
inline void remove_input(Quantity quantity, Scene& scene) {
  if (quantity == Quantity::gravity) scene.inputs.gravity = false;
  if (quantity == Quantity::payload) scene.inputs.payloads.clear();
  if (quantity == Quantity::parameters) scene.inputs.parameters.clear();
  if (quantity == Quantity::tool) scene.inputs.tools.clear();
}

}  // namespace treeline
