#include <algorithm>

#include "inspect/propose_scene.hpp"

namespace treeline {
namespace {

constexpr double kLevel = 0.005;  ///< m: shapes that stand on the ground together
constexpr double kBelow = 0.4;  ///< of the way from the joint: how far down a foot touches at least

/// A place where a shape may touch, in the root's frame.
struct Touch {
  bool is_ball = false;
  Eigen::Vector3d place;
};

/// The lowest point of a ball, and the middles of a box's sides.
void add_touches(const TouchShape& shape, const Eigen::Isometry3d& link, const Eigen::Vector3d& up,
                 std::vector<Touch>& touches) {
  const Eigen::Isometry3d pose = link * shape.pose;
  if (shape.size.isZero()) {
    touches.push_back({true, pose.translation() - shape.radius * up});
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      touches.push_back({false, pose * (side * shape.size[axis] * Eigen::Vector3d::Unit(axis))});
    }
  }
}

}  // namespace

std::optional<FootPlace> place_foot(const Robot& robot, const BodyTree& tree, const Body& body,
                                    const Eigen::Vector3d& up,
                                    const std::vector<TouchShape>& shapes) {
  const auto frame = [&](int link) { return tree.frames[static_cast<std::size_t>(link)]; };
  std::vector<Touch> touches;
  for (const TouchShape& shape : shapes) {
    for (const int link : body.links) {
      const bool own = robot.links[static_cast<std::size_t>(link)].name == shape.link;
      if (own) add_touches(shape, frame(link), up, touches);
    }
  }
  const bool balls =
      std::any_of(touches.begin(), touches.end(), [](const Touch& touch) { return touch.is_ball; });
  std::erase_if(touches, [&](const Touch& touch) { return touch.is_ball != balls; });
  if (touches.empty()) return std::nullopt;
  const auto height = [&](const Touch& touch) { return touch.place.dot(up); };
  const auto lowest =
      std::min_element(touches.begin(), touches.end(),
                       [&](const Touch& a, const Touch& b) { return height(a) < height(b); });
  const double floor = height(*lowest);
  const Eigen::Vector3d joint = frame(body.links.front()).translation();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int number = 0;
  for (const Touch& touch : touches) {
    if (height(touch) > floor + kLevel) continue;
    sum += touch.place;
    ++number;
  }
  Eigen::Vector3d way = sum / number - joint;
  way += (floor - (joint + way).dot(up)) * up;
  const double least = balls ? -kLevel : kBelow * way.norm();  // a leg may be drawn as it lies
  if (way.norm() < kLevel || -way.dot(up) < least) return std::nullopt;
  return FootPlace{joint + way, balls};
}

}  // namespace treeline
