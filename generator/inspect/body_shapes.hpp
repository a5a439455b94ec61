#pragma once

#include <algorithm>
#include <vector>

#include "description/group_bodies.hpp"
#include "description/robot.hpp"

namespace treeline {

/// Where the bodies of a robot are at q = 0, in the axes of the root, m.
struct BodyShapes {
  const Robot& robot;
  const BodyTree& tree;

  [[nodiscard]] const Body& body(int b) const { return tree.bodies[static_cast<std::size_t>(b)]; }
  [[nodiscard]] const Joint& joint_of(int b) const {
    return robot.joints[static_cast<std::size_t>(body(b).joint)];
  }
  [[nodiscard]] const Link& link(int l) const { return robot.links[static_cast<std::size_t>(l)]; }
  [[nodiscard]] const Eigen::Isometry3d& frame(int l) const {
    return tree.frames[static_cast<std::size_t>(l)];
  }
  /// Origin of the joint of a body.
  [[nodiscard]] Eigen::Vector3d origin(int b) const {
    return frame(body(b).links.front()).translation();
  }
  /// Axis of the joint of a body.
  [[nodiscard]] Eigen::Vector3d axis(int b) const {
    const auto& xyz = joint_of(b).axis;
    return frame(joint_of(b).child).linear() * Eigen::Vector3d(xyz[0], xyz[1], xyz[2]);
  }

  /// Whether a body is another one or hangs from it.
  [[nodiscard]] bool is_on(int b, int other) const {
    while (b > other) b = body(b).parent;
    return b == other;
  }

  /// Centres of mass and origins of the links of a body.
  [[nodiscard]] std::vector<Eigen::Vector3d> places(int b) const {
    std::vector<Eigen::Vector3d> places;
    for (const int l : body(b).links) {
      places.push_back(frame(l).translation());
      if (link(l).inertial && link(l).inertial->mass > 0) {
        const auto& xyz = link(l).inertial->origin.xyz;
        places.push_back(frame(l) * Eigen::Vector3d(xyz[0], xyz[1], xyz[2]));
      }
    }
    return places;
  }

  /// How far anything that a body and those beyond it hold lies from the body's joint.
  [[nodiscard]] double reach_of(int first) const {
    double reach = 0;
    std::vector<int> stack{first};
    while (!stack.empty()) {
      const int b = stack.back();
      stack.pop_back();
      for (const Eigen::Vector3d& place : places(b)) {
        reach = std::max(reach, (place - origin(first)).norm());
      }
      stack.insert(stack.end(), body(b).children.begin(), body(b).children.end());
    }
    return reach;
  }
};

}  // namespace treeline
