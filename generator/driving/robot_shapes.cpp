#include "driving/robot_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "description/robot_queries.hpp"

namespace treeline {
namespace {

constexpr double kClear = 0.005;  // m

/// Marks for each link itself and all links that at most two joints connect with it; fixed joints
/// do not count.
std::vector<std::vector<bool>> find_near(const Robot& robot) {
  const std::size_t count = robot.links.size();
  std::vector<std::vector<int>> joints(count, std::vector<int>(count, 3));
  for (std::size_t i = 0; i < count; ++i) joints[i][i] = 0;
  const auto connect = [&](int a, int b, int cost) {
    auto& way = joints[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    way = std::min(way, cost);
  };
  for (const Joint& joint : robot.joints) {
    const int cost = joint.type == JointType::fixed ? 0 : 1;
    connect(joint.parent, joint.child, cost);
    connect(joint.child, joint.parent, cost);
  }
  for (std::size_t via = 0; via < count; ++via) {  // Floyd and Warshall
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < count; ++j) {
        joints[i][j] = std::min(joints[i][j], joints[i][via] + joints[via][j]);
      }
    }
  }
  std::vector<std::vector<bool>> near(count, std::vector<bool>(count));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) near[i][j] = joints[i][j] <= 2;
  }
  return near;
}

/// Radius of a ball about a shape's middle that holds it, m.
double reach_of(const Visual& shape) {
  if (shape.kind == VisualKind::box) return 0.5 * shape.size.norm();
  if (shape.kind == VisualKind::sphere) return shape.size.x();
  return std::hypot(shape.size.x(), 0.5 * shape.size.y());
}

/// The height of the lowest point of what may touch the ground, of a link at `pose`, m.
double lowest_of(const SceneTouch& touch, const Eigen::Isometry3d& pose) {
  const Eigen::Vector3d axis(touch.axis.data());
  const double slope = (pose.linear() * axis).z();
  const double below = touch.radius * std::sqrt(std::max(0.0, 1 - slope * slope));
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& point : touch.points) {
    lowest = std::min(lowest, (pose * Eigen::Vector3d(point.data())).z() - below);
  }
  return lowest;
}

}  // namespace

RobotShapes::RobotShapes(const LaunchedRobot& robot) : placer_(robot.robot, robot.scene) {
  Diagnostics diagnostics;  // they have been said of the robot
  const auto& links = robot.robot.links;
  for (const Visual& shape :
       read_collisions(robot.description.urdf, robot.robot.file, diagnostics)) {
    const std::size_t link = index_of_link(robot.robot, shape.link);
    if (link == links.size() || shape.kind == VisualKind::mesh || shape.size.isZero()) continue;
    shapes_.push_back(shape);
    links_.push_back(link);
  }
  for (const SceneTouch& touch : robot.scene.touches) {
    const std::size_t link = index_of_link(robot.robot, touch.link);
    if (link == links.size()) continue;
    touches_.push_back(touch);
    touched_links_.push_back(link);
  }
  const auto near = find_near(robot.robot);
  for (std::size_t j = 0; j < shapes_.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if (!near[links_[i]][links_[j]]) pairs_.emplace_back(i, j);
    }
  }
}

std::vector<Visual> RobotShapes::place(const std::vector<double>& q) const {
  const auto poses = placer_.place(q);
  std::vector<Visual> placed = shapes_;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    placed[i].pose = poses[links_[i]] * placed[i].pose;
  }
  return placed;
}

double RobotShapes::least_distance(const std::vector<double>& q) const {
  const std::vector<Visual> placed = place(q);
  double least = kClear;
  for (const auto& [i, j] : pairs_) {
    const double apart = (placed[i].pose.translation() - placed[j].pose.translation()).norm() -
                         reach_of(placed[i]) - reach_of(placed[j]);
    if (apart < least) least = std::min(least, convex_distance(placed[i], placed[j]));
  }
  return least;
}

bool RobotShapes::is_clear(const std::vector<double>& q, const std::vector<double>& other) const {
  return pairs_.empty() || least_distance(q) >= std::min(kClear, least_distance(other));
}

double RobotShapes::lowest(const std::vector<double>& q) const {
  double lowest = std::numeric_limits<double>::infinity();
  const auto poses = placer_.place(q);
  for (std::size_t i = 0; i < touches_.size(); ++i) {
    lowest = std::min(lowest, lowest_of(touches_[i], poses[touched_links_[i]]));
  }
  if (!touches_.empty()) return lowest;
  for (const Eigen::Isometry3d& pose : poses) {
    lowest = std::min(lowest, pose.translation().z());
  }
  for (const Visual& shape : place(q)) lowest = std::min(lowest, lowest_of(shape));
  return lowest;
}

}  // namespace treeline
