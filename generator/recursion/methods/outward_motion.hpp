#pragma once

#include <vector>

#include "recursion/tree/joint_drive.hpp"

namespace treeline {

/// The matrix U = [wd]x + [w]x [w]x, which gives accelerations of points of a link as a + U r (Luh,
/// Walker & Paul; Khalil). Moments need differences of the squares on its diagonal.
template <class Scalar>
struct AngularMatrix {
  Scalar xx{}, xy{}, xz{}, yx{}, yy{}, yz{}, zx{}, zy{}, zz{};
  Scalar wx2{}, wy2{}, wz2{};
  Scalar wxwy{}, wxwz{}, wywz{};

  [[nodiscard]] Matrix3<Scalar> matrix() const {
    return {{xx, xy, xz}, {yx, yy, yz}, {zx, zy, zz}};
  }
};

template <class Scalar>
AngularMatrix<Scalar> angular_matrix(const Vector3<Scalar>& w, const Vector3<Scalar>& wd) {
  const Scalar xy = w.x * w.y;
  const Scalar xz = w.x * w.z;
  const Scalar yz = w.y * w.z;
  const Scalar xx = w.x * w.x;
  const Scalar yy = w.y * w.y;
  const Scalar zz = w.z * w.z;
  return {-(yy + zz), xy - wd.z, xz + wd.y, xy + wd.z, -(xx + zz), yz - wd.x, xz - wd.y, yz + wd.x,
          -(xx + yy), xx,        yy,        zz,        xy,         xz,        yz};
}

/// Motion of a link's frame in its own axes. `a` is the conventional acceleration of the origin; if
/// gravity is given as an acceleration of the base, it is the true acceleration minus g.
template <class Scalar>
struct LinkMotion {
  Vector3<Scalar> w, wd, a;
  AngularMatrix<Scalar> U;
  /// Angular velocity of the link that carries the joint, as a whole, by which this link moves.
  Vector3<Scalar> w_carrier;
};

template <class Scalar>
Vector3<Scalar> velocity_triple(const JointRates<Scalar>& rates, std::size_t at) {
  return {rates.velocity(at), rates.velocity(at + 1), rates.velocity(at + 2)};
}
template <class Scalar>
Vector3<Scalar> acceleration_triple(const JointRates<Scalar>& rates, std::size_t at) {
  return {rates.acceleration(at), rates.acceleration(at + 1), rates.acceleration(at + 2)};
}

template <class Scalar>
LinkMotion<Scalar> motion_behind_joint(const TreeLink<Scalar>& link,
                                       const JointTransform<Scalar>& X,
                                       const LinkMotion<Scalar>& parent,
                                       const JointRates<Scalar>& rates) {
  const auto at = static_cast<std::size_t>(link.v_index);
  const Vector3<Scalar> w_parent = X.to_child(parent.w);
  // The axes of a ball joint turn with its last link, as if only the carrier turned them further.
  const Vector3<Scalar> w_carrier =
      link.continues_joint() ? X.to_child(parent.w_carrier) : w_parent;
  LinkMotion<Scalar> motion;
  motion.w = w_parent;
  motion.w_carrier = w_carrier;
  motion.wd = X.to_child(parent.wd);
  motion.a = X.to_child(parent.a + parent.U.matrix() * X.p);
  switch (link.kind) {
    case JointKind::revolute: {
      const Scalar qd = link.multiplier * rates.velocity(at);
      motion.w.z = w_parent.z + qd;
      motion.wd.x = motion.wd.x + w_carrier.y * qd;
      motion.wd.y = motion.wd.y - w_carrier.x * qd;
      motion.wd.z = motion.wd.z + link.multiplier * rates.acceleration(at);
      break;
    }
    case JointKind::prismatic: {
      const Scalar twice_qd = Scalar(2.0) * (link.multiplier * rates.velocity(at));
      motion.a.x = motion.a.x + w_parent.y * twice_qd;
      motion.a.y = motion.a.y - w_parent.x * twice_qd;
      motion.a.z = motion.a.z + link.multiplier * rates.acceleration(at);
      break;
    }
    case JointKind::floating: {
      // qd has components in the axes of the rotating child, so their derivative lacks w_rel x
      // v_rel.
      const Vector3<Scalar> v_rel = velocity_triple(rates, at);
      const Vector3<Scalar> w_rel = velocity_triple(rates, at + 3);
      motion.w = w_parent + w_rel;
      motion.wd = motion.wd + cross(w_parent, w_rel) + acceleration_triple(rates, at + 3);
      motion.a = motion.a + cross(w_parent + motion.w, v_rel) + acceleration_triple(rates, at);
      break;
    }
  }
  return motion;
}

/// Computes wd and U of a link behind a revolute joint by carrying U z over from the parent: a
/// point on the joint's axis has the same acceleration on both links. The components of wd across
/// the axis follow from it.
template <class Scalar>
void carry_column(const JointTransform<Scalar>& X, const AngularMatrix<Scalar>& parent,
                  LinkMotion<Scalar>& motion) {
  const Vector3<Scalar> axis = X.to_parent({Scalar(0.0), Scalar(0.0), Scalar(1.0)});
  const Vector3<Scalar> column = X.to_child(parent.matrix() * axis);
  AngularMatrix<Scalar>& U = motion.U;
  motion.wd.x = U.wywz - column.y;
  motion.wd.y = column.x - U.wxwz;
  U.xz = column.x;
  U.yz = column.y;
  U.zz = column.z;
  U.zx = U.wxwz - motion.wd.y;
  U.zy = U.wywz + motion.wd.x;
}

/// Outward pass of the recursive Newton-Euler algorithm (Chang table 4.1), in link frames.
/// `base_acceleration` is -g to include gravity, and 0 for bias accelerations.
template <class Scalar>
std::vector<LinkMotion<Scalar>> outward_motion(const Tree<Scalar>& tree,
                                               const std::vector<JointTransform<Scalar>>& X,
                                               const JointRates<Scalar>& rates,
                                               const Vector3<Scalar>& base_acceleration) {
  LinkMotion<Scalar> base;
  base.a = base_acceleration;
  std::vector<LinkMotion<Scalar>> motions;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "outward");
    const LinkMotion<Scalar>& parent =
        link.parent < 0 ? base : motions[static_cast<std::size_t>(link.parent)];
    LinkMotion<Scalar> motion = motion_behind_joint(link, X[i], parent, rates);
    motion.U = angular_matrix(motion.w, motion.wd);
    if (link.carries_column && link.turns_by_angle()) {
      carry_column(X[i], parent.U, motion);
    }
    label(motion.w, "w", i);
    label(motion.wd, "wd", i);
    label(motion.a, "a", i);
    motions.push_back(motion);
  }
  return motions;
}

/// Conventional acceleration of the point at r, in the link's axes.
template <class Scalar>
Vector3<Scalar> acceleration_at(const LinkMotion<Scalar>& motion, const Vector3<Scalar>& r) {
  return motion.a + motion.U.matrix() * r;
}

}  // namespace treeline
