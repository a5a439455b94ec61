#pragma once

#include <utility>
#include <vector>

#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/methods/forward_kinematics.hpp"
#include "recursion/methods/link_velocities.hpp"
#include "recursion/methods/outward_motion.hpp"

namespace treeline {

/// Share of the robot's mass in everything beyond a joint, and the first moment of that share at
/// the link's frame. Regrouping moves matter only along joint axes, which does not affect the
/// centre of mass or its motion.
template <class Scalar>
struct MassShare {
  Scalar mass{};
  Vector3<Scalar> h;
};

template <class Scalar>
MassShare<Scalar> to_parent(const JointTransform<Scalar>& X, const MassShare<Scalar>& share) {
  return {share.mass, X.to_parent(share.h) + X.p * share.mass};
}

/// The shares of the links alone.
template <class Scalar>
std::vector<MassShare<Scalar>> link_shares(const Tree<Scalar>& tree) {
  std::vector<MassShare<Scalar>> shares;
  for (const TreeLink<Scalar>& link : tree.links) {
    shares.push_back(
        {link.inertia.mass * tree.inverse_total_mass, link.inertia.h * tree.inverse_total_mass});
  }
  return shares;
}

template <class Scalar>
std::vector<MassShare<Scalar>> composite_shares(const Tree<Scalar>& tree,
                                                const std::vector<JointTransform<Scalar>>& X) {
  std::vector<MassShare<Scalar>> shares = link_shares(tree);
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "first moment");
    if (link.parent < 0) {
      continue;
    }
    MassShare<Scalar>& parent = shares[static_cast<std::size_t>(link.parent)];
    const MassShare<Scalar> moved = to_parent(X[i], shares[i]);
    parent = {parent.mass + moved.mass, parent.h + moved.h};
  }
  return shares;
}

/// Centre of mass of all links in the world, including links that do not move, m.
template <class Scalar>
Vector3<Scalar> center_of_mass(const Tree<Scalar>& tree,
                               const std::vector<JointTransform<Scalar>>& X) {
  const auto shares = composite_shares(tree, X);
  Vector3<Scalar> center = tree.world_moment * tree.inverse_total_mass;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    if (tree.links[i].parent < 0) {
      center = center + to_parent(X[i], shares[i]).h;
    }
  }
  return center;
}

/// Pose of an operational point's frame in the world. The centre of mass has the world's axes.
template <class Scalar>
WorldPose<Scalar> pose_of(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
                          const std::vector<WorldPose<Scalar>>& poses,
                          const TreePoint<Scalar>& point) {
  if (!point.center_of_mass) return point_pose(poses, point);
  return {identity3<Scalar>(), center_of_mass(tree, X), {}};
}

/// Jacobian of the centre of mass, 3 x nv, world axes. A joint moves everything beyond it: a
/// revolute joint by the cross product of its axis with the first moment, a prismatic joint along
/// its axis by the mass.
template <class Scalar>
DenseMatrix<Scalar> center_of_mass_jacobian(const Tree<Scalar>& tree,
                                            const std::vector<JointTransform<Scalar>>& X) {
  const auto shares = composite_shares(tree, X);
  const auto poses = world_poses(tree, X);
  const Scalar zero(0.0);
  const Scalar one(1.0);
  const Vector3<Scalar> axes[3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
  DenseMatrix<Scalar> J(3, static_cast<std::size_t>(tree.nv));
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "motion of the centre of mass");
    for (int k = 0; k < link.velocities(); ++k) {
      const Vector3<Scalar>& e = axes[link.axis(k)];
      const Vector3<Scalar> own = link.is_angular(k) ? cross(e, shares[i].h) : e * shares[i].mass;
      const Vector3<Scalar> moved = poses[i].R * (own * link.multiplier);
      const auto column = static_cast<std::size_t>(link.v_index + k);
      J(0, column) = J(0, column) + moved.x;
      J(1, column) = J(1, column) + moved.y;
      J(2, column) = J(2, column) + moved.z;
    }
  }
  return J;
}

/// The mean over the mass of all links of vectors that are times the masses of each, in its axes:
/// summed inward, in world axes.
template <class Scalar>
Vector3<Scalar> mean_over_mass(const Tree<Scalar>& tree,
                               const std::vector<JointTransform<Scalar>>& X,
                               std::vector<Vector3<Scalar>> vectors) {
  Vector3<Scalar> sum;
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "inward");
    Vector3<Scalar>& parent =
        link.parent < 0 ? sum : vectors[static_cast<std::size_t>(link.parent)];
    parent = parent + X[i].to_parent(vectors[i]);
  }
  return sum * tree.inverse_total_mass;
}

/// Acceleration of the centre of mass, m/s^2, world axes, where what does not move has none.
template <class Scalar>
Vector3<Scalar> center_of_mass_acceleration(const Tree<Scalar>& tree,
                                            const std::vector<JointTransform<Scalar>>& X,
                                            const std::vector<LinkMotion<Scalar>>& motions) {
  std::vector<Vector3<Scalar>> forces;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeInertia<Scalar>& inertia = tree.links[i].inertia;
    forces.push_back(motions[i].a * inertia.mass + motions[i].U.matrix() * inertia.h);
  }
  return mean_over_mass(tree, X, std::move(forces));
}

/// Velocity of the centre of mass, m/s, world axes.
template <class Scalar>
Vector3<Scalar> center_of_mass_velocity(const Tree<Scalar>& tree,
                                        const std::vector<JointTransform<Scalar>>& X,
                                        const std::vector<LinkVelocity<Scalar>>& velocities) {
  std::vector<Vector3<Scalar>> momenta;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeInertia<Scalar>& inertia = tree.links[i].inertia;
    momenta.push_back(velocities[i].v * inertia.mass + cross(velocities[i].w, inertia.h));
  }
  return mean_over_mass(tree, X, std::move(momenta));
}

}  // namespace treeline
