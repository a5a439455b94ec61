#include <algorithm>

#include "description/robot_queries.hpp"
#include "mechanism/build_steps.hpp"
#include "mechanism/digits50_from_file.hpp"

namespace treeline {
namespace {

std::size_t index_of_point(const std::vector<ScenePoint>& points, const std::string& name) {
  const auto found = std::find_if(points.begin(), points.end(),
                                  [&](const ScenePoint& point) { return point.name == name; });
  return static_cast<std::size_t>(found - points.begin());
}

/// `points`: those of the scene that the tools are among.
std::vector<MechanismTool> place_tools(const std::vector<SceneTool>& tools,
                                       const std::vector<ScenePoint>& points, const Robot& robot,
                                       const std::vector<MechanismPoint>& frames) {
  std::vector<MechanismTool> placed;
  for (const SceneTool& tool : tools) {
    const std::size_t k = index_of_point(points, tool.point);
    placed.push_back({k, frames[index_of_link(robot, points[k].link)],
                      digits50_pose(points[k].origin).p, tool.orientation});
  }
  return placed;
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
    inputs.parameters.push_back({frames[i], own ? digits50_inertia(*own) : Inertia{}});
  }
  inputs.tools = place_tools(scene.inputs.tools, scene.operational_points, robot, frames);
  inputs.contacts = place_tools(scene.inputs.contacts, scene.contacts, robot, frames);
  inputs.active = find_active_rows(scene);
  for (const std::string& name : scene.inputs.active_tasks) {
    inputs.active_tasks.push_back(index_of_point(scene.operational_points, name));
  }
  return inputs;
}

Inertia nominal_inertia(const Mechanism& mechanism, int link) {
  Inertia inertia = mechanism.links[static_cast<std::size_t>(link)].inertia;
  for (const MechanismInertia& own : mechanism.inputs.parameters) {
    if (own.frame.link == link) inertia = inertia + transformed(own.nominal, own.frame.pose);
  }
  for (const MechanismInertia& own : mechanism.inputs.base) {
    if (own.frame.link == link) inertia = inertia + transformed(own.nominal, own.frame.pose);
  }
  return inertia;
}

void take_base_parameters(Mechanism& mechanism) {
  for (std::size_t f = 0; f < mechanism.link_frames.size(); ++f) {
    mechanism.inputs.base.push_back({mechanism.link_frames[f], mechanism.link_matter[f]});
    mechanism.link_matter[f] = {};
  }
  for (MovingLink& link : mechanism.links) {
    if (!link.spins) link.inertia = {};
  }
}

namespace {

/// Value of a joint in the map; nothing by default.
template <class Value>
Value value_of(const std::map<std::string, Value>& values, const std::string& joint) {
  const auto found = values.find(joint);
  return found == values.end() ? Value{} : found->second;
}

JointDrive drive_of(const MovingLink& link, const Scene& scene) {
  const Digits50 m = link.multiplier;
  const SceneFriction friction = value_of(scene.joint_friction, link.joint);
  const SceneSpring spring = value_of(scene.joint_springs, link.joint);
  JointDrive drive;
  drive.inertia = m * m * Digits50(value_of(scene.armature, link.joint));
  drive.damping = m * m * Digits50(friction.damping);
  if (friction.friction > 0) {
    drive.friction = m * Digits50(friction.friction);
    drive.sharpness = m / Digits50(friction.width);
  }
  if (spring.stiffness > 0 && m != 0) {
    drive.stiffness = m * m * Digits50(spring.stiffness);
    drive.rest = (Digits50(spring.rest) - link.offset) / m;
  }
  return drive;
}

}  // namespace

void add_drives(const Scene& scene, Mechanism& mechanism) {
  for (MovingLink& link : mechanism.links) {
    if (link.has_one_coordinate())
      link.drive = drive_of(link, scene);  // no base called like a joint
  }
}

}  // namespace treeline
