#pragma once

#include <vector>

#include "recursion/methods/mass_matrix.hpp"

namespace treeline {

/// Twice the moments of velocity of everything beyond a joint, about the link's origin and in its
/// axes, with velocities relative to that origin: P = 2 integral of v dm, C = 2 integral of v r^T
/// dm. If the angular velocity that carries the bodies changes by alpha, the Coriolis force changes
/// by alpha x P and its moment by (tr C) alpha - C alpha.
template <class Scalar>
struct CompositeMomentum {
  Vector3<Scalar> P;
  Matrix3<Scalar> C;
};

/// (tr C) e - C e = 2 integral of r x (e x v) dm.
template <class Scalar>
Vector3<Scalar> turned_moment(const Matrix3<Scalar>& C, const Vector3<Scalar>& e) {
  return {(C.row_y.y + C.row_z.z) * e.x - C.row_x.y * e.y - C.row_x.z * e.z,
          (C.row_x.x + C.row_z.z) * e.y - C.row_y.x * e.x - C.row_y.z * e.z,
          (C.row_x.x + C.row_y.y) * e.z - C.row_z.x * e.x - C.row_z.y * e.y};
}

template <class Scalar>
Matrix3<Scalar> operator+(const Matrix3<Scalar>& A, const Matrix3<Scalar>& B) {
  return {A.row_x + B.row_x, A.row_y + B.row_y, A.row_z + B.row_z};
}
/// Outer product a b^T.
template <class Scalar>
Matrix3<Scalar> outer(const Vector3<Scalar>& a, const Vector3<Scalar>& b) {
  return {b * a.x, b * a.y, b * a.z};
}

/// Twice the velocity of a link's origin relative to its parent, in the parent's axes.
template <class Scalar>
Vector3<Scalar> twice_relative_velocity(const TreeLink<Scalar>& link,
                                        const JointTransform<Scalar>& X,
                                        const Vector3<Scalar>& w_parent,
                                        const JointRates<Scalar>& rates) {
  const Scalar zero(0.0);
  const Scalar two(2.0);
  const auto at = static_cast<std::size_t>(link.v_index);
  const Vector3<Scalar> carried = cross(w_parent * two, X.p);
  Vector3<Scalar> slide;
  switch (link.kind) {
    case JointKind::revolute:
      return carried;
    case JointKind::prismatic:
      slide = {zero, zero, link.multiplier * rates.velocity(at)};
      break;
    case JointKind::floating:
      slide = velocity_triple(rates, at);
      break;
  }
  return carried + X.to_parent(slide * two);
}

/// 2 w x h and 2 [w]x Sigma of one link.
template <class Scalar>
CompositeMomentum<Scalar> own_momentum(const TreeInertia<Scalar>& inertia,
                                       const Vector3<Scalar>& w) {
  const Vector3<Scalar> w2 = w * Scalar(2.0);
  const Symmetric3<Scalar>& S = inertia.Sigma;
  const Vector3<Scalar> x = cross(w2, Vector3<Scalar>{S.xx, S.xy, S.xz});
  const Vector3<Scalar> y = cross(w2, Vector3<Scalar>{S.xy, S.yy, S.yz});
  const Vector3<Scalar> z = cross(w2, Vector3<Scalar>{S.xz, S.yz, S.zz});
  return {cross(w2, inertia.h), transposed(Matrix3<Scalar>{x, y, z})};
}

/// Computes the composites' moments of velocity inward. `velocities` are those of
/// `twice_relative_velocity` for each link, `w` the angular velocities.
template <class Scalar>
std::vector<CompositeMomentum<Scalar>> composite_momenta(
    const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
    const std::vector<CompositeInertia<Scalar>>& inertias,
    const std::vector<LinkMotion<Scalar>>& motions,
    const std::vector<Vector3<Scalar>>& velocities) {
  std::vector<CompositeMomentum<Scalar>> momenta;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    momenta.push_back(own_momentum(tree.links[i].inertia, motions[i].w));
  }
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "composite momentum");
    if (link.parent < 0) {
      continue;
    }
    CompositeMomentum<Scalar>& parent = momenta[static_cast<std::size_t>(link.parent)];
    const Vector3<Scalar> P = X[i].to_parent(momenta[i].P);
    const Vector3<Scalar> h =
        X[i].to_parent(inertias[i].h) + X[i].p * inertias[i].mass;  // as in composite inertias
    const Matrix3<Scalar> shift = outer(P, X[i].p) + outer(velocities[i], h);
    parent.P = parent.P + P + velocities[i] * inertias[i].mass;
    parent.C = parent.C + X[i].matrix_to_parent(momenta[i].C) + shift;
  }
  return momenta;
}

}  // namespace treeline
