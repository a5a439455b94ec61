#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Calls `visit(pose, owner, element)` for the pose of each mass of a robot; the owner is the
/// link's name.
template <class AnyRobot, class Visit>
void for_each_inertial_pose(AnyRobot& robot, Visit visit) {
  for (auto& link : robot.links) {
    if (!link.inertial) continue;
    visit(link.inertial->origin, link.name,
          fmt::format("robot/link[{}]/inertial/origin", link.name));
  }
}

/// Calls `visit(pose, owner, element)` for the pose of each joint; the owner is its name.
template <class AnyRobot, class Visit>
void for_each_joint_pose(AnyRobot& robot, Visit visit) {
  for (auto& joint : robot.joints) {
    visit(joint.origin, joint.name, fmt::format("robot/joint[{}]/origin", joint.name));
  }
}

template <class AnyRobot, class Visit>
void for_each_pose(AnyRobot& robot, Visit visit) {
  for_each_inertial_pose(robot, visit);
  for_each_joint_pose(robot, visit);
}

/// Calls `visit(pose, element)` for every pose that a scene gives: of points, constraints,
/// objects and grasps.
template <class Visit>
void for_each_point_pose(Scene& scene, Visit visit) {
  for (auto& [key, points] : {std::pair{"operational_points", &scene.operational_points},
                              {"external_forces", &scene.external_forces},
                              {"contacts", &scene.contacts},
                              {"constraints", &scene.constraints}}) {
    for (ScenePoint& point : *points) {
      visit(point.origin, fmt::format("{}[{}]/origin", key, point.name));
    }
  }
  for (SceneLoop& loop : scene.loops) {
    visit(loop.first.origin, fmt::format("constraints[{}]/origin", loop.first.name));
    visit(loop.second.origin, fmt::format("constraints[{}]/other_origin", loop.first.name));
  }
  for (SceneObject& object : scene.objects) {
    visit(object.inertial.origin, fmt::format("objects[{}]/inertial/origin", object.name));
    for (SceneGrasp& grasp : object.grasps) {
      visit(grasp.origin, fmt::format("objects[{}]/grasps[{}]/origin", object.name, grasp.point));
    }
  }
}

}  // namespace treeline
