#pragma once

#include <vector>

#include "recursion/methods/link_velocities.hpp"
#include "recursion/tree/joint_axes.hpp"

// Motions of links in the axes and at the origins of other frames that are fixed to them.

namespace treeline {

/// The velocity of the frame's origin and the link's angular velocity, in the frame's axes.
template <class Scalar>
LinkVelocity<Scalar> velocity_of_frame(const LinkVelocity<Scalar>& link,
                                       const TreePoint<Scalar>& frame) {
  return {transposed_times(frame.R, link.v + cross(link.w, frame.p)),
          transposed_times(frame.R, link.w)};
}

template <class Scalar>
LinkMotion<Scalar> motion_of_frame(const LinkMotion<Scalar>& link, const TreePoint<Scalar>& frame) {
  LinkMotion<Scalar> motion;
  motion.w = transposed_times(frame.R, link.w);
  motion.wd = transposed_times(frame.R, link.wd);
  motion.a = transposed_times(frame.R, acceleration_at(link, frame.p));
  motion.U = angular_matrix(motion.w, motion.wd);
  return motion;
}

/// Motion of a link per unit of one velocity, in the link's axes.
template <class Scalar>
struct MotionByVelocity {
  std::size_t v = 0;  ///< index of the velocity; mimic joints have that of the joint they follow
  LinkVelocity<Scalar> motion;
};

/// Computes for every link its motion per unit of each velocity that moves it, outward.
template <class Scalar>
std::vector<std::vector<MotionByVelocity<Scalar>>> motions_by_velocity(
    const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X) {
  std::vector<std::vector<MotionByVelocity<Scalar>>> all;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "axes of the joints before");
    std::vector<MotionByVelocity<Scalar>> motions;
    if (link.parent >= 0) motions = all[static_cast<std::size_t>(link.parent)];
    for (auto& [v, motion] : motions) {
      motion = {X[i].to_child(motion.v + cross(motion.w, X[i].p)), X[i].to_child(motion.w)};
    }
    for (int k = 0; k < link.velocities(); ++k) {
      const UnitMotion<Scalar> own = unit_motion(link, k);
      motions.push_back({static_cast<std::size_t>(link.v_index + k),
                         {own.v * link.multiplier, own.w * link.multiplier}});
    }
    all.push_back(std::move(motions));
  }
  return all;
}

}  // namespace treeline
