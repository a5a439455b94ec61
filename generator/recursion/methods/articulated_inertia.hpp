#pragma once

#include <utility>
#include <vector>

#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/algebra/factor_ldlt.hpp"
#include "recursion/methods/inverse_dynamics.hpp"
#include "recursion/methods/joint_clusters.hpp"

namespace treeline {

/// Articulated-body inertia [A B; B^T C] at a link's frame: f = A a + B wd, n = B^T a + C wd.
template <class Scalar>
struct ArticulatedInertia {
  Symmetric3<Scalar> A;
  Matrix3<Scalar> B;
  Symmetric3<Scalar> C;
};

/// Articulated-body inertia of a single link. f = m a - h x wd, so B = -[h]x.
template <class Scalar>
ArticulatedInertia<Scalar> articulated_inertia(const TreeInertia<Scalar>& inertia) {
  const Scalar zero(0.0);
  const Scalar& m = inertia.mass;
  const Vector3<Scalar>& h = inertia.h;
  return {{m, zero, zero, m, zero, m},
          {{zero, h.z, -h.y}, {-h.z, zero, h.x}, {h.y, -h.x, zero}},
          inertia.J};
}

template <class Scalar>
ArticulatedInertia<Scalar> operator+(const ArticulatedInertia<Scalar>& a,
                                     const ArticulatedInertia<Scalar>& b) {
  return {
      a.A + b.A, {a.B.row_x + b.B.row_x, a.B.row_y + b.B.row_y, a.B.row_z + b.B.row_z}, a.C + b.C};
}

/// U = IA S, D = S^T U + rotor and u = U / D of a joint of one degree of freedom, whose rotor has
/// this inertia. `held` = rotor / D is the share of a force along the joint that the rotor's
/// inertia resists, so that the joint passes it on: 0 without a rotor, and then u is 1 along the
/// joint.
template <class Scalar>
struct JointProjection {
  Wrench<Scalar> U;
  Wrench<Scalar> u;
  Scalar inverse_D{};
  Scalar held{};
};

/// I S, the wrench that accelerates a joint of one degree of freedom by one unit.
template <class Scalar>
Wrench<Scalar> along_joint(JointKind kind, const ArticulatedInertia<Scalar>& I) {
  switch (kind) {
    case JointKind::revolute:
      return {{I.B.row_x.z, I.B.row_y.z, I.B.row_z.z}, {I.C.xz, I.C.yz, I.C.zz}};
    case JointKind::prismatic:
      return {{I.A.xz, I.A.yz, I.A.zz}, I.B.row_z};
    case JointKind::floating:
      break;
  }
  return {};
}

template <class Scalar>
JointProjection<Scalar> joint_projection(JointKind kind, const ArticulatedInertia<Scalar>& I,
                                         const Scalar& rotor) {
  JointProjection<Scalar> joint;
  if (kind == JointKind::floating) return joint;
  joint.U = along_joint(kind, I);
  joint.inverse_D = Scalar(1.0) / (along_axis(kind, joint.U.f, joint.U.n) + rotor);
  joint.u = {joint.U.f * joint.inverse_D, joint.U.n * joint.inverse_D};
  joint.held = rotor * joint.inverse_D;
  if (rotor == Scalar(0.0)) along_axis(kind, joint.u.f, joint.u.n) = Scalar(1.0);
  return joint;
}

/// I - U u^T, which is symmetric.
template <class Scalar>
ArticulatedInertia<Scalar> without_share(const ArticulatedInertia<Scalar>& I,
                                         const Wrench<Scalar>& U, const Wrench<Scalar>& u) {
  return {{I.A.xx - U.f.x * u.f.x, I.A.xy - U.f.x * u.f.y, I.A.xz - U.f.x * u.f.z,
           I.A.yy - U.f.y * u.f.y, I.A.yz - U.f.y * u.f.z, I.A.zz - U.f.z * u.f.z},
          {I.B.row_x - U.n * u.f.x, I.B.row_y - U.n * u.f.y, I.B.row_z - U.n * u.f.z},
          {I.C.xx - U.n.x * u.n.x, I.C.xy - U.n.x * u.n.y, I.C.xz - U.n.x * u.n.z,
           I.C.yy - U.n.y * u.n.y, I.C.yz - U.n.y * u.n.z, I.C.zz - U.n.z * u.n.z}};
}

/// IA - U D^-1 U^T, the inertia that the joint passes on. Of the joint's own row and column the
/// share is left that the rotor holds; without a rotor they are exact zeros.
template <class Scalar>
ArticulatedInertia<Scalar> without_joint(JointKind kind, const ArticulatedInertia<Scalar>& I,
                                         const JointProjection<Scalar>& joint) {
  Wrench<Scalar> U = joint.U;
  Wrench<Scalar> u = joint.u;
  ArticulatedInertia<Scalar> left = I;
  const Scalar zero(0.0);
  switch (kind) {
    case JointKind::revolute:
      U.n.z = u.n.z = zero;
      left.B.row_x.z = left.B.row_x.z * joint.held;
      left.B.row_y.z = left.B.row_y.z * joint.held;
      left.B.row_z.z = left.B.row_z.z * joint.held;
      left.C.xz = left.C.xz * joint.held;
      left.C.yz = left.C.yz * joint.held;
      left.C.zz = left.C.zz * joint.held;
      break;
    case JointKind::prismatic:
      U.f.z = u.f.z = zero;
      left.A.xz = left.A.xz * joint.held;
      left.A.yz = left.A.yz * joint.held;
      left.A.zz = left.A.zz * joint.held;
      left.B.row_z = left.B.row_z * joint.held;
      break;
    case JointKind::floating:  // passes no inertia
      return {};
  }
  return without_share(left, U, u);
}

/// Inertia at the origin of a frame in which its own frame has origin p, with the same axes. With
/// B' = B - A [p]x, C gains [p]x B' + ([p]x B)^T, written out so that only six entries are formed.
template <class Scalar>
ArticulatedInertia<Scalar> shifted(const ArticulatedInertia<Scalar>& I, const Vector3<Scalar>& p) {
  const auto& [A, B, C] = I;
  const Matrix3<Scalar> H{
      {B.row_x.x - (p.z * A.xy - p.y * A.xz), B.row_x.y - (p.x * A.xz - p.z * A.xx),
       B.row_x.z - (p.y * A.xx - p.x * A.xy)},
      {B.row_y.x - (p.z * A.yy - p.y * A.yz), B.row_y.y - (p.x * A.yz - p.z * A.xy),
       B.row_y.z - (p.y * A.xy - p.x * A.yy)},
      {B.row_z.x - (p.z * A.yz - p.y * A.zz), B.row_z.y - (p.x * A.zz - p.z * A.xz),
       B.row_z.z - (p.y * A.xz - p.x * A.yz)}};
  const Symmetric3<Scalar> gain{p.y * (B.row_z.x + H.row_z.x) - p.z * (B.row_y.x + H.row_y.x),
                                p.z * (B.row_x.x - H.row_y.y) - p.x * B.row_z.x + p.y * H.row_z.y,
                                p.y * (H.row_z.z - B.row_x.x) + p.x * B.row_y.x - p.z * H.row_y.z,
                                p.z * (B.row_x.y + H.row_x.y) - p.x * (B.row_z.y + H.row_z.y),
                                p.x * (B.row_y.y - H.row_z.z) - p.y * B.row_x.y + p.z * H.row_x.z,
                                p.x * (B.row_y.z + H.row_y.z) - p.y * (B.row_x.z + H.row_x.z)};
  return {A, H, C + gain};
}

/// X I X^T, the inertia at the parent's origin, in the parent's axes.
template <class Scalar>
ArticulatedInertia<Scalar> to_parent(const JointTransform<Scalar>& X,
                                     const ArticulatedInertia<Scalar>& I) {
  return shifted<Scalar>(
      {X.lone_matrix_to_parent(I.A), X.matrix_to_parent(I.B), X.lone_matrix_to_parent(I.C)}, X.p);
}

/// X^-1 I X^-T, the inertia of the parent at a link's origin, in the link's axes.
template <class Scalar>
ArticulatedInertia<Scalar> to_child(const JointTransform<Scalar>& X,
                                    const ArticulatedInertia<Scalar>& I) {
  const ArticulatedInertia<Scalar> at_child = shifted(I, -X.p);
  return {X.matrix_to_child(at_child.A), X.matrix_to_child(at_child.B),
          X.matrix_to_child(at_child.C)};
}

/// The inertia as a 6x6 matrix, linear over angular.
template <class Scalar>
DenseMatrix<Scalar> dense(const ArticulatedInertia<Scalar>& I) {
  const Scalar A[3][3] = {
      {I.A.xx, I.A.xy, I.A.xz}, {I.A.xy, I.A.yy, I.A.yz}, {I.A.xz, I.A.yz, I.A.zz}};
  const Scalar C[3][3] = {
      {I.C.xx, I.C.xy, I.C.xz}, {I.C.xy, I.C.yy, I.C.yz}, {I.C.xz, I.C.yz, I.C.zz}};
  const Vector3<Scalar> rows[3] = {I.B.row_x, I.B.row_y, I.B.row_z};
  DenseMatrix<Scalar> matrix(6, 6);
  for (std::size_t i = 0; i < 3; ++i) {
    const Scalar B[3] = {rows[i].x, rows[i].y, rows[i].z};
    for (std::size_t j = 0; j < 3; ++j) {
      matrix(i, j) = A[i][j];
      matrix(i, 3 + j) = matrix(3 + j, i) = B[j];
      matrix(3 + i, 3 + j) = C[i][j];
    }
  }
  return matrix;
}

/// Effect of a cluster of joints on its anchor. With J the motion of its links for one unit of
/// their coordinate: D = J^T I J + rotors, U = I J, u = U / D, where I is the inertia of the links
/// with the bodies that they carry, at the anchor.
template <class Scalar>
struct ClusterProjection {
  ArticulatedInertia<Scalar> I;
  Wrench<Scalar> U, u;
  Scalar D{}, inverse_D{};
};

/// Result of the inward recursion of Chang table 4.2, which all articulated-body methods share.
template <class Scalar>
struct ArticulatedTree {
  std::vector<JointProjection<Scalar>> joints;  ///< for joints of one degree of freedom
  std::vector<LdltFactor<Scalar>> floating;     ///< of IA at floating joints; otherwise empty
  /// By velocity, of coordinates that several joints share.
  std::vector<ClusterProjection<Scalar>> clusters;
  std::vector<JointCluster> shapes;  ///< by velocity
};

/// The inward recursion of Chang table 4.2.
template <class Scalar>
class Articulation {
 public:
  Articulation(const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
               std::vector<JointCluster> shapes)
      : tree_(tree), X_(X), column_(tree.links.size()) {
    const std::size_t n = tree.links.size(), nv = shapes.size();
    result_ = {std::vector<JointProjection<Scalar>>(n), std::vector<LdltFactor<Scalar>>(n),
               std::vector<ClusterProjection<Scalar>>(nv), std::move(shapes)};
    for (const TreeLink<Scalar>& link : tree.links) {
      IA_.push_back(articulated_inertia(link.inertia));
    }
  }

  ArticulatedTree<Scalar> run() {
    for (std::size_t i = tree_.links.size(); i-- > 0;) {
      const TreeLink<Scalar>& link = tree_.links[i];
      section(link, i, "articulated inertia");
      if (link.is_floating()) {
        result_.floating[i] = factor_ldlt(dense(IA_[i]));
      } else if (shape_of(link).is_shared()) {
        add_to_cluster(i);
      } else {
        project_joint(i);
      }
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] const JointCluster& shape_of(const TreeLink<Scalar>& link) const {
    return result_.shapes[static_cast<std::size_t>(link.v_index)];
  }

  void project_joint(std::size_t i) {
    const TreeLink<Scalar>& link = tree_.links[i];
    JointProjection<Scalar>& joint = result_.joints[i];
    joint = joint_projection(link.kind, IA_[i], link.drive.inertia);
    label(joint.inverse_D, "inverse_D", i);
    if (link.parent < 0) return;
    auto& parent = IA_[static_cast<std::size_t>(link.parent)];
    parent = parent + to_parent(X_[i], without_joint(link.kind, IA_[i], joint));
  }

  /// Inward through a cluster its links are as if they were fixed to each other.
  void add_to_cluster(std::size_t i) {
    const TreeLink<Scalar>& link = tree_.links[i];
    const JointCluster& shape = shape_of(link);
    auto& cluster = result_.clusters[static_cast<std::size_t>(link.v_index)];
    const Wrench<Scalar> along = along_joint(link.kind, IA_[i]);
    const Wrench<Scalar> own{along.f * link.multiplier, along.n * link.multiplier};
    const Wrench<Scalar>& behind = column_[i];
    const Scalar resisted = along_axis(link.kind, own.f, own.n) +
                            Scalar(2.0) * along_axis(link.kind, behind.f, behind.n);
    cluster.D = cluster.D + (link.multiplier * resisted + link.drive.inertia);
    if (link.parent >= 0) {
      const auto parent = static_cast<std::size_t>(link.parent);
      const bool at_anchor = link.parent == shape.anchor;
      Wrench<Scalar>& U = at_anchor ? cluster.U : column_[parent];
      U = U + to_parent(X_[i], behind + own);
      ArticulatedInertia<Scalar>& I = at_anchor ? cluster.I : IA_[parent];
      I = I + to_parent(X_[i], IA_[i]);
    }
    if (shape.begins_at(i)) project_cluster(i, cluster);
  }

  void project_cluster(std::size_t i, ClusterProjection<Scalar>& cluster) {
    cluster.inverse_D = Scalar(1.0) / cluster.D;
    label(cluster.inverse_D, "inverse_D", i);
    const int anchor = shape_of(tree_.links[i]).anchor;
    if (anchor < 0) return;
    cluster.u = {cluster.U.f * cluster.inverse_D, cluster.U.n * cluster.inverse_D};
    auto& carrier = IA_[static_cast<std::size_t>(anchor)];
    carrier = carrier + without_share(cluster.I, cluster.U, cluster.u);
  }

  const Tree<Scalar>& tree_;
  const std::vector<JointTransform<Scalar>>& X_;
  std::vector<ArticulatedInertia<Scalar>> IA_;
  /// By link, what moving the links behind it in its cluster by one unit takes.
  std::vector<Wrench<Scalar>> column_;
  ArticulatedTree<Scalar> result_;
};

/// Computes articulated-body inertias inward (Chang table 4.2). A floating joint passes no inertia
/// to its parent: IA - IA IA^-1 IA = 0. Joints that share a coordinate are one joint of the link
/// that carries them (constraint embedding: Jain, Robot and Multibody Dynamics, 2011, chapter 15).
/// The tree must have clusters, see `find_clusters`.
template <class Scalar>
ArticulatedTree<Scalar> articulate(const Tree<Scalar>& tree,
                                   const std::vector<JointTransform<Scalar>>& X) {
  return Articulation<Scalar>(tree, X, find_clusters(tree).value()).run();
}

}  // namespace treeline
