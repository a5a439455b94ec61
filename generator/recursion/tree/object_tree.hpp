#pragma once

#include <vector>

#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/tree/tree.hpp"
#include "recursion/tree/virtual_linkage.hpp"

namespace treeline {

/// Grasp of an object by a hand on a link. As long as the hand holds the object, these are constant
/// in the link.
template <class Scalar>
struct TreeGrasp {
  int link = -1;
  Matrix3<Scalar> R;  ///< from object's axes to link's axes
  Vector3<Scalar> p;  ///< object's origin in the link's frame
  Vector3<Scalar> r;  ///< the hand's point, in the object's frame
};

/// Constants of an object in its own frame, rounded once.
template <class Scalar>
struct TreeObject {
  std::string name;
  TreeInertia<Scalar> inertia;
  Vector3<Scalar> center;              ///< centre of mass
  Symmetric3<Scalar> central_inverse;  ///< inverse of the inertia about the centre of mass
  Scalar inverse_mass{};
  std::vector<TreeGrasp<Scalar>> grasps;
  DenseMatrix<Scalar> split;  ///< see VirtualLinkage
  DenseMatrix<Scalar> read;
};

template <class Scalar>
DenseMatrix<Scalar> rounded_dense(const VirtualLinkage::Matrix& A) {
  DenseMatrix<Scalar> result(static_cast<std::size_t>(A.rows()),
                             static_cast<std::size_t>(A.cols()));
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) {
      result(static_cast<std::size_t>(i), static_cast<std::size_t>(j)) = rounded<Scalar>(A(i, j));
    }
  }
  return result;
}

/// Inverse of a symmetric matrix by its adjugate. Entries that are residue compared with the
/// largest are zero.
inline Digits50Matrix3 inverse_of_symmetric(const Digits50Matrix3& A) {
  Digits50Matrix3 adjugate;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      adjugate(j, i) = A(a, c) * A(b, d) - A(a, d) * A(b, c);
    }
  }
  const Digits50 determinant = A.row(0).dot(adjugate.col(0));
  const Digits50 scale = adjugate.cwiseAbs().maxCoeff();
  return adjugate.unaryExpr(
      [&](const Digits50& x) { return Digits50(snapped(x, scale) / determinant); });
}

template <class Scalar>
TreeObject<Scalar> tree_object(const Mechanism& mechanism, const MechanismObject& object) {
  const Inertia& inertia = object.inertia;
  const Digits50Vector3 center = inertia.h / inertia.mass;
  const Digits50Matrix3 J = rotational_inertia(inertia);
  const Inertia about_center =
      resolved(transformed(inertia, {Digits50Matrix3::Identity(), -center}), mechanism.resolution);
  TreeObject<Scalar> result;
  result.name = object.name;
  result.inertia = {rounded<Scalar>(inertia.mass), rounded<Scalar>(inertia.h),
                    rounded_symmetric<Scalar>(inertia.Sigma), rounded_symmetric<Scalar>(J)};
  result.center = rounded<Scalar>(center);
  result.central_inverse =
      rounded_symmetric<Scalar>(inverse_of_symmetric(rotational_inertia(about_center)));
  result.inverse_mass = rounded<Scalar>(Digits50(1 / inertia.mass));
  std::vector<Digits50Vector3> points;
  for (const MechanismGrasp& grasp : object.grasps) {
    const MechanismPoint& hand = mechanism.operational_points[grasp.point];
    const Digits50Pose held = resolved(hand.pose * grasp.object, mechanism.resolution);
    points.push_back(resolved(inverse(grasp.object), mechanism.resolution).p);
    result.grasps.push_back({hand.link, rounded<Scalar>(held.R), rounded<Scalar>(held.p),
                             rounded<Scalar>(points.back())});
  }
  const VirtualLinkage linkage = virtual_linkage(points);
  result.split = rounded_dense<Scalar>(linkage.split);
  result.read = rounded_dense<Scalar>(linkage.read);
  return result;
}

template <class Scalar>
std::vector<TreeObject<Scalar>> objects_of(const Mechanism& mechanism) {
  std::vector<TreeObject<Scalar>> objects;
  for (const MechanismObject& object : mechanism.objects) {
    objects.push_back(tree_object<Scalar>(mechanism, object));
  }
  return objects;
}

/// Copies the tree with the grasps, in the order of objects, as operational points: each at the
/// object's origin with all rows in world axes. There C stacks identities (Chang eq. 7.3).
template <class Scalar>
Tree<Scalar> holding_tree(Tree<Scalar> tree, const std::vector<TreeObject<Scalar>>& objects) {
  tree.operational_points.clear();
  for (const TreeObject<Scalar>& object : objects) {
    for (const TreeGrasp<Scalar>& grasp : object.grasps) {
      tree.operational_points.push_back({object.name,
                                         grasp.link,
                                         grasp.R,
                                         grasp.p,
                                         Axes::world,
                                         {true, true, true, true, true, true}});
    }
  }
  return tree;
}

/// Updates the objects' grasps with the points of a `holding_tree`, which `defer_rotations` may
/// have rotated.
template <class Scalar>
void follow_points(const Tree<Scalar>& tree, std::vector<TreeObject<Scalar>>& objects) {
  auto point = tree.operational_points.begin();
  for (TreeObject<Scalar>& object : objects) {
    for (TreeGrasp<Scalar>& grasp : object.grasps) {
      grasp.R = point->R;
      grasp.p = point->p;
      ++point;
    }
  }
}

}  // namespace treeline
