#include <algorithm>

#include "drawing/scene_solids.hpp"

namespace treeline {
namespace {

constexpr Color kRod = {0.55, 0.62, 0.72};
constexpr Color kJoint = {0.93, 0.55, 0.24};
constexpr double kRodShare = 0.012;    // of the robot's size: radius of a rod
constexpr double kJointShare = 0.018;  // and of the ball at a joint that moves

/// Nothing if it has no area.
void add_triangle(const Triangle& triangle, const Color& color, Solids& solids) {
  const auto& [a, b, c] = triangle.corners;
  const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
  if (!normal.isZero()) solids.faces.push_back({{a, b, c}, normal, triangle.color.value_or(color)});
}

/// `size` is that of the robot, m.
void add_visual(const Visual& visual, const Eigen::Isometry3d& link, double size, Solids& solids) {
  constexpr double kThin = 0.06;  // radius, of the robot's size
  const Eigen::Isometry3d pose = link * visual.pose;
  switch (visual.kind) {
    case VisualKind::box:
      return add_box(visual.size, pose, visual.color, solids);
    case VisualKind::cylinder:
      return add_cylinder(visual.size[0], visual.size[1],
                          visual.size[0] < kThin * size ? kThinSides : kThickSides, pose,
                          visual.color, solids);
    case VisualKind::sphere:
      solids.balls.push_back({pose.translation(), visual.size[0], visual.color});
      return;
    case VisualKind::mesh:
      for (const Triangle& triangle : visual.triangles) {
        add_triangle(moved(triangle, Eigen::Affine3d(pose)), visual.color, solids);
      }
      return;
  }
}

/// Whether each link has a shape that is drawn.
std::vector<bool> find_shaped(const Robot& robot, const std::vector<Visual>& visuals) {
  std::vector<bool> shaped;
  for (const Link& link : robot.links) {
    shaped.push_back(std::any_of(visuals.begin(), visuals.end(), [&](const Visual& visual) {
      return visual.link == link.name &&
             (visual.kind != VisualKind::mesh || !visual.triangles.empty());
    }));
  }
  return shaped;
}

/// Frames: links that weigh nothing and have no shape, where others have one.
std::vector<bool> find_frames(const Robot& robot, const std::vector<bool>& shaped) {
  const bool any = std::ranges::count(shaped, true) > 0;
  std::vector<bool> frames;
  for (std::size_t i = 0; i < shaped.size(); ++i) {
    const auto& inertial = robot.links[i].inertial;
    frames.push_back(any && !shaped[i] && (!inertial || inertial->mass == 0));
  }
  return frames;
}

bool carries_none(const Robot& robot, int link) {
  return std::none_of(robot.joints.begin(), robot.joints.end(),
                      [&](const Joint& joint) { return joint.parent == link; });
}

/// A link at the end, from its origin to its centre of mass.
void add_end(const Link& link, const Eigen::Isometry3d& pose, double radius, Solids& solids) {
  if (!link.inertial) return;
  const Eigen::Vector3d center = Eigen::Vector3d::Map(link.inertial->origin.xyz.data());
  add_rod(pose.translation(), pose * center, radius, kRod, solids);
}

}  // namespace

double size_of(const std::vector<Eigen::Isometry3d>& links) {
  constexpr double kLeast = 1e-3;
  Eigen::AlignedBox3d box;
  for (const Eigen::Isometry3d& link : links) box.extend(link.translation());
  return std::max(kLeast, box.sizes().maxCoeff());
}

Solids robot_solids(const Robot& robot, const std::vector<Visual>& visuals,
                    const std::vector<Eigen::Isometry3d>& links, double size) {
  Solids solids;
  const std::vector<bool> shaped = find_shaped(robot, visuals);
  const std::vector<bool> frames = find_frames(robot, shaped);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    for (const Visual& visual : visuals) {
      if (visual.link == robot.links[i].name) add_visual(visual, links[i], size, solids);
    }
    if (!shaped[i] && !frames[i] && carries_none(robot, static_cast<int>(i))) {
      add_end(robot.links[i], links[i], kRodShare * size, solids);
    }
  }
  for (const Joint& joint : robot.joints) {
    const auto parent = static_cast<std::size_t>(joint.parent);
    const auto child = static_cast<std::size_t>(joint.child);
    const Eigen::Vector3d at = links[child].translation();
    const bool is_from_world = !robot.parts.empty() && joint.parent == robot.root;
    if (!is_from_world && !shaped[parent] && !frames[parent]) {
      add_rod(links[parent].translation(), at, kRodShare * size, kRod, solids);
    }
    if (joint.type != JointType::fixed && !shaped[child] && !frames[child]) {
      solids.balls.push_back({at, kJointShare * size, kJoint});
    }
  }
  return solids;
}

}  // namespace treeline
