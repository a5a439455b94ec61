#pragma once

#include <algorithm>

#include "description/scene.hpp"
#include "functions/quantity.hpp"

namespace treeline {

inline bool has_orientation(const SceneTool& tool) {
  return tool.orientation;
}

/// Whether the scene makes this quantity of the robot an argument.
inline bool has_input(const Scene& scene, Quantity quantity) {
  const auto& tools = scene.inputs.tools;
  switch (quantity) {
    case Quantity::gravity:
      return scene.inputs.gravity;
    case Quantity::payload:
      return !scene.inputs.payloads.empty();
    case Quantity::parameters:
      return !scene.inputs.parameters.empty();
    case Quantity::base_parameters:
      return scene.inputs.base_parameters;
    case Quantity::tool:
      return !tools.empty();
    case Quantity::tool_orientation:
      return std::any_of(tools.begin(), tools.end(), has_orientation);
    case Quantity::contact:
      return !scene.inputs.contacts.empty();
    case Quantity::active:
      return !scene.inputs.active.empty();
    case Quantity::active_tasks:
      return !scene.inputs.active_tasks.empty();
    default:
      return false;
  }
}

/// Whether rows of an operational point are in axes that are an argument.
inline bool has_rows_in_given_axes(const Scene& scene) {
  const auto& points = scene.operational_points;
  return std::any_of(points.begin(), points.end(), [&scene](const ScenePoint& point) {
    const auto& tools = scene.inputs.tools;
    return point.axes == Axes::local &&
           std::any_of(tools.begin(), tools.end(), [&point](const SceneTool& tool) {
             return tool.orientation && tool.point == point.name;
           });
  });
}

inline bool has_center_of_mass(const Scene& scene) {
  const auto& points = scene.operational_points;
  return std::any_of(points.begin(), points.end(), is_center_of_mass);
}

/// Whether the function depends on inertia. The motion of points does only where one is the centre
/// of mass.
inline bool depends_on_inertia(const Scene& scene, Function function) {
  const bool is_motion_of_points = needs_points(function) && solve_of(function) == Solve::none;
  return takes(function, Quantity::parameters) &&
         (!is_motion_of_points || has_center_of_mass(scene));
}

/// Whether the function of this scene takes this quantity of the robot as an argument. The axes of
/// a point count for its pose, and else only where its rows are in them.
inline bool takes_input(const Scene& scene, Function function, Quantity quantity) {
  if (!takes(function, quantity) || !has_input(scene, quantity)) return false;
  if (quantity == Quantity::payload || quantity == Quantity::parameters) {
    return depends_on_inertia(scene, function);
  }
  if (quantity == Quantity::base_parameters && depends_on_mass(function)) {
    return scene.base == Base::floating;  // M has the whole mass and its centre
  }
  return quantity != Quantity::tool_orientation || function == Function::forward_kinematics ||
         has_rows_in_given_axes(scene);
}

/// Leaves this quantity of the robot as the files have it.
inline void remove_input(Quantity quantity, Scene& scene) {
  if (quantity == Quantity::gravity) scene.inputs.gravity = false;
  if (quantity == Quantity::payload) scene.inputs.payloads.clear();
  if (quantity == Quantity::parameters) scene.inputs.parameters.clear();
  if (quantity == Quantity::base_parameters) scene.inputs.base_parameters = false;
  if (quantity == Quantity::tool) scene.inputs.tools.clear();
  if (quantity == Quantity::tool_orientation) {
    for (SceneTool& tool : scene.inputs.tools) tool.orientation = false;
  }
  if (quantity == Quantity::contact) scene.inputs.contacts.clear();
  if (quantity == Quantity::active) scene.inputs.active.clear();
  if (quantity == Quantity::active_tasks) scene.inputs.active_tasks.clear();
}

}  // namespace treeline
