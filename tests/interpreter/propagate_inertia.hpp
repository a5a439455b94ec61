#pragma once

#include <algorithm>
#include <vector>

#include "interpreter/lambda_inverse.hpp"

namespace treeline::interpreter {

/// Whether Chang table 5.1 applies: all points are on one body, and there are no mimic joints.
template <class Scalar>
bool permits_inertia_propagation(const Model<Scalar>& model, const Points<Scalar>& points) {
  return !points.empty() && !model.has_mimics() &&
         std::all_of(points.begin(), points.end(),
                     [&](const auto& point) { return point.body == points.front().body; });
}

namespace detail {

/// Contribution of a body to the inertia felt beyond it: its own inertia and that of all branches
/// on it, except the one that leads to `next` (kWorld: no exception).
template <class Scalar>
Matrix6<Scalar> inertia_beside_path(const Model<Scalar>& model, const Kinematics<Scalar>& k,
                                    const ArticulatedInertia<Scalar>& inertia, int body, int next) {
  Matrix6<Scalar> own = body_inertia(model.body(body));
  for (int j = body + 1; j < model.size(); ++j) {
    if (model.body(j).parent != body || j == next) continue;
    Matrix6<Scalar> felt = inertia.IA[j];
    if (k.S[j].cols() > 0) {
      felt -= inertia.U[j] * inertia.D_inverse[j] * inertia.U[j].transpose();
    }
    own += k.X[j] * felt * k.X[j].transpose();
  }
  return own;
}

/// The inertia `N` as felt through a free joint: N - N S D^-1 S^T N with D = S^T N S + armature.
/// Through a joint of six degrees of freedom nothing is felt.
template <class Scalar>
Matrix6<Scalar> felt_through_joint(const Matrix6<Scalar>& N, const JointMatrix<Scalar>& S,
                                   const Scalar& armature) {
  if (S.cols() == 0) return N;
  if (S.cols() == 6) return Matrix6<Scalar>::Zero();
  const JointMatrix<Scalar> NS = N * S;
  Matrix<Scalar> D = S.transpose() * NS;
  D.diagonal().array() += armature;
  return N - NS * inverse_of_positive_definite<Scalar>(D) * NS.transpose();
}

/// Inverse of X, which maps forces to the parent: maps forces from the parent to the body.
template <class Scalar>
Matrix6<Scalar> inverse_force_transform(const Matrix6<Scalar>& X) {
  Matrix6<Scalar> inverse = Matrix6<Scalar>::Zero();
  inverse.template topLeftCorner<3, 3>() = X.template topLeftCorner<3, 3>().transpose();
  inverse.template bottomLeftCorner<3, 3>() = X.template bottomLeftCorner<3, 3>().transpose();
  inverse.template bottomRightCorner<3, 3>() = X.template topLeftCorner<3, 3>().transpose();
  return inverse;
}

}  // namespace detail

/// Inertia felt at a body's frame, in its axes, by inertia propagation (Chang table 5.1): Lambda_i
/// = I_i + N - N S (S^T N S)^-1 S^T N outward along the body's path, with N = X^-1 Lambda_h X^-T.
/// Here I_i includes the branches beside the path, so trees are covered, too. A fixed base is a
/// "big base" whose inertia is `base_size` (kg, kg m^2) times the unit matrix; the result has an
/// error of about 1 / base_size, and of rounding times base_size. Behind a floating joint the base
/// is not felt and the result is exact. Precondition: no mimic joints.
template <class Scalar>
Matrix6<Scalar> body_inertia_by_propagation(const Model<Scalar>& model, int body,
                                            VectorArg<Scalar> q,
                                            const std::type_identity_t<Scalar>& base_size) {
  assert(!model.has_mimics());
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  const auto inertia = articulated_inertia(model, k);
  std::vector<int> path = detail::path_to_root(model, body);
  std::reverse(path.begin(), path.end());
  Matrix6<Scalar> Lambda = base_size * Matrix6<Scalar>::Identity();
  for (std::size_t at = 0; at < path.size(); ++at) {
    const int i = path[at];
    const int next = at + 1 < path.size() ? path[at + 1] : kWorld;
    const Matrix6<Scalar> X_inverse = detail::inverse_force_transform(k.X[i]);
    const Matrix6<Scalar> N = X_inverse * Lambda * X_inverse.transpose();
    Lambda = detail::inertia_beside_path(model, k, inertia, i, next) +
             detail::felt_through_joint(N, k.S[i], model.body(i).armature);
  }
  return Lambda;
}

/// Lambda^-1 of points on one body by inertia propagation; for `base_size` see
/// `body_inertia_by_propagation`. Precondition: `permits_inertia_propagation`.
template <class Scalar>
Matrix<Scalar> lambda_inverse_by_inertia_propagation(
    const Model<Scalar>& model, PointsArg<Scalar> points, VectorArg<Scalar> q,
    const std::type_identity_t<Scalar>& base_size) {
  assert(permits_inertia_propagation(model, points));
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  const Matrix<Scalar> Omega = inverse_of_positive_definite<Scalar>(
      body_inertia_by_propagation(model, points.front().body, q, base_size));
  Matrix<Scalar> X(6, 6 * static_cast<int>(points.size()));
  int column = 0;
  for (const auto& point : points) {
    X.template middleCols<6>(column) = point_transform(point, k);
    column += 6;
  }
  const std::vector<int> rows = controlled_rows<Scalar>(points);
  const Matrix<Scalar> all = X.transpose() * Omega * X;
  return all(rows, rows);
}

/// Lambda_i of every body at its frame, in its axes, in O(n) by Chang table 8.1: articulated
/// inertias inward, then outward the inertia of everything except the body's subtree, N = Lambda_h
/// - X (IA - U D^-1 U^T) X^T moved to the body's frame, and Lambda_i = IA_i + N - N S (S^T N S)^-1
/// S^T N. The loss in the subtraction grows with the square of the distance between bodies relative
/// to their size. Through a floating joint nothing of the rest is felt, so Lambda = IA there, where
/// the table begins. A fixed base is a "big base" whose inertia is `base_size` (kg, kg m^2) times
/// the unit matrix, which causes an error of about 1 / base_size and a loss of digits due to its
/// size. Precondition: no mimic joints.
template <class Scalar>
PerBody<Matrix6<Scalar>> link_inertias(const Model<Scalar>& model, VectorArg<Scalar> q,
                                       const std::type_identity_t<Scalar>& base_size) {
  assert(!model.has_mimics());
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  const auto inertia = articulated_inertia(model, k);
  const auto& [IA, U, D_inverse] = inertia;
  PerBody<Matrix6<Scalar>> Lambda = IA;
  Lambda[kWorld] += base_size * Matrix6<Scalar>::Identity();
  for (int i = 0; i < model.size(); ++i) {
    Matrix6<Scalar> subtree = IA[i];
    if (k.S[i].cols() > 0) subtree -= U[i] * D_inverse[i] * U[i].transpose();
    const Matrix6<Scalar> rest =
        Lambda[model.body(i).parent] - k.X[i] * subtree * k.X[i].transpose();
    const Matrix6<Scalar> X_inverse = detail::inverse_force_transform(k.X[i]);
    const Matrix6<Scalar> N = X_inverse * rest * X_inverse.transpose();
    Lambda[i] += detail::felt_through_joint(N, k.S[i], model.body(i).armature);
  }
  return Lambda;
}

}  // namespace treeline::interpreter
