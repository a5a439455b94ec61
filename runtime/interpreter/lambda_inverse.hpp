#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "interpreter/articulated_inertia.hpp"
#include "interpreter/jacobian.hpp"
#include "interpreter/mass_matrix.hpp"
#include "interpreter/task_law.hpp"

namespace treeline::interpreter {

namespace detail {

/// Force propagators and inverse inertias of the bodies that carry points (Chang tables 5.2, 5.3).
template <class Scalar>
struct ForcePropagation {
  ForcePropagation(const Model<Scalar>& model, const Kinematics<Scalar>& k)
      : L(model.size(), Matrix6<Scalar>::Zero()), Omega(model.size(), Matrix6<Scalar>::Zero()) {
    const auto inertia = articulated_inertia(model, k);
    for (int i = 0; i < model.size(); ++i) {
      const int h = model.body(i).parent;
      const JointMatrix<Scalar>& S = k.S[i];
      L[i] = k.X[i];
      Matrix6<Scalar> moved_by_joint = Matrix6<Scalar>::Zero();
      if (S.cols() > 0) {
        const Matrix<Scalar> D_inverse_S = inertia.D_inverse[i] * S.transpose();
        L[i] = k.X[i] * (Matrix6<Scalar>::Identity() - inertia.U[i] * D_inverse_S);
        moved_by_joint = S * D_inverse_S;
      }
      Omega[i] = moved_by_joint;
      if (h != kWorld) Omega[i] += L[i].transpose() * Omega[h] * L[i];
    }
  }

  PerBody<Matrix6<Scalar>> L;      ///< maps forces from a body to its parent, joints free (Chang
                                   ///< eq. 3.17)
  PerBody<Matrix6<Scalar>> Omega;  ///< acceleration of a body per force on it (Chang table 5.2)
};

/// The bodies from `body` to the root.
template <class Scalar>
std::vector<int> path_to_root(const Model<Scalar>& model, int body) {
  std::vector<int> path;
  for (int i = body; i != kWorld; i = model.body(i).parent) path.push_back(i);
  return path;
}

/// Outermost body that carries both bodies, or the world.
template <class Scalar>
int nearest_common_ancestor(const Model<Scalar>& model, int i, int j) {
  while (i != j) {
    if (i > j) {
      i = model.body(i).parent;
    } else {
      j = model.body(j).parent;
    }
  }
  return i;
}

/// Omega_ij = L_(h->i)^T Omega_hh L_(h->j), where h is the nearest common ancestor, joint by joint
/// (Chang table 5.3): the acceleration of body i per force on body j.
template <class Scalar>
Matrix6<Scalar> cross_omega(const Model<Scalar>& model, const ForcePropagation<Scalar>& forces,
                            int i, int j) {
  const int h = nearest_common_ancestor(model, i, j);
  if (h == kWorld) return Matrix6<Scalar>::Zero();
  Matrix6<Scalar> Omega = forces.Omega[h];
  const auto apply_path = [&](int tip, const auto& step) {
    const auto path = path_to_root(model, tip);
    const auto end = std::find(path.begin(), path.end(), h);
    for (auto at = std::make_reverse_iterator(end); at != path.rend(); ++at) step(forces.L[*at]);
  };
  apply_path(i, [&](const Matrix6<Scalar>& L) { Omega = (L.transpose() * Omega).eval(); });
  apply_path(j, [&](const Matrix6<Scalar>& L) { Omega = (Omega * L).eval(); });
  return Omega;
}

template <class Scalar>
Matrix<Scalar> lambda_inverse_by_mass_matrix(const Model<Scalar>& model,
                                             const Points<Scalar>& points, VectorArg<Scalar> q) {
  const Matrix<Scalar> J = jacobian<Scalar>(model, points, q);
  const Matrix<Scalar> M = mass_matrix<Scalar>(model, q);
  return J * Matrix<Scalar>(M.ldlt().solve(Matrix<Scalar>(J.transpose())));
}

}  // namespace detail

/// Lambda^-1 = J M^-1 J^T, rows x rows over the controlled rows of all points, by force propagation
/// with branching (Chang table 5.3): the acceleration of each point per force at each point. A
/// floating base needs no special rule, because its joint with S = 1 gives Omega = IA^-1. With
/// mimic joints, to which the table does not apply, it is J G (G^T M G)^-1 G^T J^T, and likewise
/// with the centre of mass, which is on all bodies.
template <class Scalar>
Matrix<Scalar> lambda_inverse(const Model<Scalar>& model, PointsArg<Scalar> points,
                              VectorArg<Scalar> q) {
  if (model.has_mimics() || has_center_of_mass(points)) {
    return detail::lambda_inverse_by_mass_matrix<Scalar>(model, points, q);
  }
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  const detail::ForcePropagation<Scalar> forces(model, k);
  const int blocks = static_cast<int>(points.size());
  Matrix<Scalar> all(6 * blocks, 6 * blocks);
  const auto point = [&](int i) { return points[static_cast<std::size_t>(i)]; };
  for (int i = 0; i < blocks; ++i) {
    const Matrix6<Scalar> X_i = point_transform(point(i), k);
    for (int j = 0; j <= i; ++j) {
      const Matrix6<Scalar> X_j = point_transform(point(j), k);
      const Matrix6<Scalar> Omega =
          detail::cross_omega(model, forces, point(i).body, point(j).body);
      const Matrix6<Scalar> block = X_i.transpose() * Omega * X_j;
      all.template block<6, 6>(6 * i, 6 * j) = block;
      all.template block<6, 6>(6 * j, 6 * i) = block.transpose();
    }
  }
  const std::vector<int> rows = controlled_rows<Scalar>(points);
  return all(rows, rows);
}

/// Lambda, the inertia at the points, by LDL^T of its inverse. It is not finite, or meaningless, if
/// the controlled rows depend on each other.
template <class Scalar>
Matrix<Scalar> lambda(const Model<Scalar>& model, PointsArg<Scalar> points, VectorArg<Scalar> q) {
  return inverse_of_positive_definite<Scalar>(lambda_inverse<Scalar>(model, points, q));
}

/// Lambda, where `law` relaxes rows that cannot be moved: finite at every state.
template <class Scalar>
Matrix<Scalar> lambda(const Model<Scalar>& model, PointsArg<Scalar> points, VectorArg<Scalar> q,
                      const TaskLaw<Scalar>& law) {
  return bordered_inverse<Scalar>(lambda_inverse<Scalar>(model, points, q), law);
}

}  // namespace treeline::interpreter
