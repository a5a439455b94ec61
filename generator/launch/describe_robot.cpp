#include "launch/describe_robot.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "description/robot_queries.hpp"
#include "description/rotation.hpp"
#include "description/scene_queries.hpp"
#include "launch/print_robot.hpp"

namespace treeline {
namespace {

using drive::DrivenCoordinate;
using drive::Measure;

constexpr std::array kFloatingNames = {"x", "y", "z", "qx", "qy", "qz", "qw"};
constexpr std::array kPlanarNames = {"x", "y", "theta"};

void take_limits(const Joint& joint, const Coordinate& coordinate, DrivenCoordinate& driven) {
  driven.lower = coordinate.lower;
  driven.upper = coordinate.upper;
  if (!joint.limits) return;
  driven.velocity = joint.limits->velocity;
  driven.effort = joint.limits->effort;
}

/// The coordinates of one link's joint; `axis` counts the axes of a planar joint.
void describe_link(const Robot& robot, const Mechanism& mechanism, const MovingLink& link, int axis,
                   bool is_passive, drive::RobotDescription& description) {
  const Joint* joint = find_joint(robot, link.joint);
  const std::string name = joint != nullptr ? link.joint : "base";
  const bool floats = link.kind == JointKind::floating;
  for (std::size_t i = 0; i < (floats ? kFloatingNames.size() : 1); ++i) {
    DrivenCoordinate driven;
    driven.joint = name;
    if (floats) {
      driven.name = name + "." + kFloatingNames[i];
      driven.measure = static_cast<Measure>(static_cast<std::size_t>(Measure::x) + i);
    } else if (joint != nullptr && joint->type == JointType::planar) {
      driven.name = name + "." + kPlanarNames[static_cast<std::size_t>(axis)];
      driven.measure = static_cast<Measure>(static_cast<int>(Measure::planar_x) + axis);
    } else {
      driven.name = name;
      driven.measure = link.kind == JointKind::revolute ? Measure::angle : Measure::length;
    }
    if (!floats) driven.velocity_index = link.v_index;
    const std::size_t q = static_cast<std::size_t>(link.q_index) + i;
    if (joint != nullptr && !floats) take_limits(*joint, mechanism.coordinates[q], driven);
    driven.passive = is_passive;
    description.coordinates[q] = driven;
  }
}

drive::DrivenPoint describe_point(const ScenePoint& point) {
  drive::DrivenPoint driven;
  driven.name = point.name;
  driven.link = point.link;
  driven.position = point.origin.xyz;
  const Eigen::Quaterniond turn(rotation_from_rpy<double>(point.origin.rpy));
  driven.rotation = {turn.x(), turn.y(), turn.z(), turn.w()};
  for (std::size_t i = 0; i < kRowNames.size(); ++i) {
    if (point.rows[i]) driven.rows.emplace_back(kRowNames[i]);
  }
  driven.local_axes = point.axes == Axes::local;
  return driven;
}

}  // namespace

std::vector<int> floating_joints(const Mechanism& mechanism) {
  std::vector<int> first;
  for (const MovingLink& link : mechanism.links) {
    if (link.kind == JointKind::floating && !link.mimics) first.push_back(link.q_index);
  }
  return first;
}

drive::RobotDescription describe_robot(const Robot& robot, const Scene& control, const Scene& links,
                                       const Mechanism& mechanism) {
  drive::RobotDescription description;
  description.name = robot.name;
  description.held = control.base == Base::floating && is_held_to_world(control);
  description.floating = control.base == Base::floating && !description.held;
  description.velocities = mechanism.nv();
  description.coordinates.resize(static_cast<std::size_t>(mechanism.nq()));
  const std::vector<int> passive = unmotored_velocities(control, mechanism);
  std::string last;
  int axis = 0;
  for (const MovingLink& link : mechanism.links) {
    if (link.mimics) continue;
    axis = link.joint == last ? axis + 1 : 0;
    last = link.joint;
    const bool is_passive =
        std::find(passive.begin(), passive.end(), link.v_index) != passive.end();
    describe_link(robot, mechanism, link, axis, is_passive, description);
  }
  for (const ScenePoint& point : control.operational_points) {
    description.points.push_back(describe_point(point));
  }
  for (const ScenePoint& point : links.operational_points) description.links.push_back(point.link);
  description.locked.assign(control.locked.begin(), control.locked.end());
  const double mass = total_mass(robot);
  description.mass = mass > 0 ? mass : 1;
  return description;
}

}  // namespace treeline
