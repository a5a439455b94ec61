#include "mechanism/place_inputs.hpp"

#include <algorithm>

#include "mechanism/exact_from_file.hpp"

namespace treeline {
namespace {

/// Index of a link of the robot, which the scene's reader has found there.
std::size_t index_of_link(const Robot& robot, const std::string& name) {
  const auto found = std::find_if(robot.links.begin(), robot.links.end(),
                                  [&](const Link& link) { return link.name == name; });
  return static_cast<std::size_t>(found - robot.links.begin());
}

std::size_t index_of_point(const Scene& scene, const std::string& name) {
  const auto& points = scene.operational_points;
  const auto found = std::find_if(points.begin(), points.end(),
                                  [&](const ScenePoint& point) { return point.name == name; });
  return static_cast<std::size_t>(found - points.begin());
}

}  // namespace

bool has_parameters_as_input(const Scene& scene, const std::string& link) {
  const auto& named = scene.inputs.parameters;
  return std::any_of(named.begin(), named.end(),
                     [&](const SceneInertia& each) { return each.link == link; });
}

MechanismInputs place_inputs(const Robot& robot, const Scene& scene,
                             const std::vector<MechanismPoint>& frames) {
  MechanismInputs inputs;
  inputs.gravity = scene.inputs.gravity;
  for (const SceneInertia& payload : scene.inputs.payloads) {
    inputs.payloads.push_back({frames[index_of_link(robot, payload.link)], {}});
  }
  for (const SceneInertia& named : scene.inputs.parameters) {
    const std::size_t i = index_of_link(robot, named.link);
    const auto& own = robot.links[i].inertial;
    inputs.parameters.push_back({frames[i], own ? exact_inertia(*own) : Inertia{}});
  }
  for (const SceneTool& tool : scene.inputs.tools) {
    const std::size_t k = index_of_point(scene, tool.point);
    const ScenePoint& point = scene.operational_points[k];
    inputs.tools.push_back(
        {k, frames[index_of_link(robot, point.link)], exact_pose(point.origin).p});
  }
  return inputs;
}

Inertia nominal_inertia(const Mechanism& mechanism, int link) {
  Inertia inertia = mechanism.links[static_cast<std::size_t>(link)].inertia;
  for (const MechanismInertia& own : mechanism.inputs.parameters) {
    if (own.frame.link == link) inertia = inertia + transformed(own.nominal, own.frame.pose);
  }
  return inertia;
}

}  // namespace treeline
