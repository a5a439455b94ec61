#include "launch/print_soles.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <vector>

#include "description/isometry_of.hpp"

namespace treeline {
namespace {

/// A link's frame in that of the first link before which a joint moves.
struct Carried {
  int by = -1;  ///< index of that link; -1: no link has the name
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
};

Carried carry(const Robot& robot, const std::string& link) {
  Carried carried;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (robot.links[i].name == link) carried.by = static_cast<int>(i);
  }
  for (bool found = true; found;) {
    found = false;
    for (const Joint& joint : robot.joints) {
      if (joint.child != carried.by || joint.type != JointType::fixed) continue;
      carried = {joint.parent, isometry_of(joint.origin) * carried.pose};
      found = true;
      break;
    }
  }
  return carried;
}

/// The points of a shape that matter for how far a sole reaches: of a disk four of its rim.
std::vector<Eigen::Vector3d> corners_of(const SceneTouch& touch) {
  const Eigen::Vector3d axis(touch.axis.data());
  std::vector<Eigen::Vector3d> corners;
  for (const auto& point : touch.points) {
    const Eigen::Vector3d middle(point.data());
    if (axis.isZero()) {
      corners.push_back(middle);
      continue;
    }
    const Eigen::Vector3d across = touch.radius * axis.unitOrthogonal();
    const Eigen::Vector3d along = axis.cross(across);
    corners.insert(corners.end(),
                   {middle + across, middle - across, middle + along, middle - along});
  }
  return corners;
}

}  // namespace

bool has_sole(const Robot& robot, const std::string& link, const std::vector<SceneTouch>& touches) {
  const int by = carry(robot, link).by;
  return std::any_of(touches.begin(), touches.end(), [&](const SceneTouch& touch) {
    return !touch.points.empty() && carry(robot, touch.link).by == by;
  });
}

std::string print_soles(const Robot& robot, const Scene& ground, const Scene& control) {
  std::string points;
  std::string ends;
  int count = 0;
  for (const ScenePoint& hold : control.constraints) {
    const Carried held = carry(robot, hold.link);
    const Eigen::Isometry3d frame = held.pose * isometry_of(hold.origin);
    for (const SceneTouch& touch : ground.touches) {
      const Carried touching = carry(robot, touch.link);
      if (touching.by != held.by) continue;
      const double radius = touch.axis == std::array<double, 3>{} ? touch.radius : 0;
      for (const Eigen::Vector3d& corner : corners_of(touch)) {
        const Eigen::Vector3d at = frame.inverse() * (touching.pose * corner);
        points += fmt::format("      {{{{{}, {}, {}}}, {}}},\n", at.x(), at.y(), at.z(), radius);
        ++count;
      }
    }
    ends += fmt::format("{}, ", count);
  }
  return fmt::format(
      "\n  static constexpr treeline::drive::SolePoint kSolePoints[] = {{\n{}  }};\n"
      "  static constexpr int kSoleEnds[] = {{{}}};\n"
      "  static constexpr double kFriction = {};",
      points, ends, ground.ground_step->friction);
}

}  // namespace treeline
