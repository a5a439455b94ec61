#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "description/rotation.hpp"
#include "launch/describe_robot.hpp"

namespace treeline {
namespace {

drive::DrivenObstacle describe_obstacle(const SceneObstacle& obstacle) {
  drive::DrivenObstacle driven;
  driven.name = obstacle.name;
  const Eigen::Matrix3d R = rotation_from_rpy<double>(obstacle.origin.rpy);
  const Eigen::Quaterniond turn(R);
  driven.rotation = {turn.x(), turn.y(), turn.z(), turn.w()};
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    driven.shape.center[i] = obstacle.origin.xyz[at];
    driven.shape.half[i] = 0.5 * obstacle.size[at];
    for (int j = 0; j < 3; ++j) driven.shape.rotation[3 * i + j] = R(i, j);
  }
  driven.shape.radius = obstacle.radius;
  driven.shape.avoided = obstacle.avoided;
  return driven;
}

/// Index among the links that forces can act on; -1: none.
int find_link(const drive::RobotDescription& description, const std::string& name) {
  const auto found = std::find(description.links.begin(), description.links.end(), name);
  return found == description.links.end() ? -1
                                          : static_cast<int>(found - description.links.begin());
}

void guard(int link, int point, const std::array<double, 3>& xyz,
           drive::RobotDescription& description) {
  description.guarded.push_back({link, point, {xyz[0], xyz[1], xyz[2]}});
}

}  // namespace

std::vector<drive::DrivenObstacle> describe_obstacles(const std::vector<SceneObstacle>& obstacles) {
  std::vector<drive::DrivenObstacle> described;
  for (const SceneObstacle& obstacle : obstacles) described.push_back(describe_obstacle(obstacle));
  return described;
}

bool describe_surroundings(const SceneSurroundings& surroundings, const Scene& control,
                           drive::RobotDescription& description, Diagnostics& diagnostics) {
  if (surroundings.obstacles.empty()) return true;
  const auto refuse = [&](const std::string& element, std::string fault, std::string remedy) {
    diagnostics.add(
        {Severity::error, control.file, 0, element, std::move(fault), std::move(remedy)});
    return false;
  };
  if (description.links.empty()) {
    return refuse("obstacles", "the robot has too many links for obstacles to act on them",
                  "remove the obstacles, or links behind fixed joints");
  }
  description.obstacles = describe_obstacles(surroundings.obstacles);
  const SceneAvoidance& avoidance = surroundings.avoidance;
  description.repulsion.reach = avoidance.reach;
  description.repulsion.clearance = avoidance.clearance;
  description.repulsion.eta = avoidance.strength;
  constexpr int kMostPoints = drive::kMostGuardedPoints / 2;  // the others are the scene's own
  for (std::size_t k = 0; k < control.operational_points.size(); ++k) {
    const ScenePoint& point = control.operational_points[k];
    const int link = find_link(description, point.link);
    if (link < 0) continue;  // on the base, which nothing pushes away
    if (static_cast<int>(description.guarded.size()) == kMostPoints) {
      return refuse(
          "obstacles",
          fmt::format("more than {} operational points would have to keep away", kMostPoints),
          "list fewer, or drive without obstacles");
    }
    guard(link, static_cast<int>(k), point.origin.xyz, description);
  }
  for (const SceneGuard& point : avoidance.points) {
    const int link = find_link(description, point.link);
    if (link < 0) {
      return refuse("avoidance/points", fmt::format("the link \"{}\" does not move", point.link),
                    "remove the point, or name a link that can keep away");
    }
    guard(link, -1, point.xyz, description);
  }
  return true;
}

}  // namespace treeline
