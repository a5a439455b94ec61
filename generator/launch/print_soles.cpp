#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "description/group_bodies.hpp"
#include "description/robot_queries.hpp"
#include "launch/print_robot.hpp"

namespace treeline {
namespace {

/// Whether a link moves as one with that at `index`.
bool moves_with(const Robot& robot, const BodyTree& tree, std::size_t index,
                const std::string& link) {
  const auto other = static_cast<int>(index_of_link(robot, link));
  return std::any_of(tree.bodies.begin(), tree.bodies.end(), [&](const Body& body) {
    const auto has = [&](int one) { return std::count(body.links.begin(), body.links.end(), one); };
    return has(static_cast<int>(index)) > 0 && has(other) > 0;
  });
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
  const BodyTree tree = group_bodies(robot);
  const std::size_t held = index_of_link(robot, link);
  return std::any_of(touches.begin(), touches.end(), [&](const SceneTouch& touch) {
    return !touch.points.empty() && moves_with(robot, tree, held, touch.link);
  });
}

std::string print_soles(const Robot& robot, const Scene& ground, const Scene& control) {
  const BodyTree tree = group_bodies(robot);
  std::string points;
  std::string ends;
  int count = 0;
  for (const ScenePoint& hold : control.constraints) {
    const std::size_t held = index_of_link(robot, hold.link);
    const Eigen::Isometry3d frame = tree.frames[held] * isometry_of(hold.origin);
    for (const SceneTouch& touch : ground.touches) {
      if (!moves_with(robot, tree, held, touch.link)) continue;
      const auto& own = tree.frames[index_of_link(robot, touch.link)];
      const double radius = touch.axis == std::array<double, 3>{} ? touch.radius : 0;
      for (const Eigen::Vector3d& corner : corners_of(touch)) {
        const Eigen::Vector3d at = frame.inverse() * (own * corner);
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
