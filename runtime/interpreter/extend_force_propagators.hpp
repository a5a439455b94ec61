#pragma once

#include <map>
#include <vector>

#include "interpreter/lambda_inverse.hpp"

namespace treeline::interpreter {

namespace detail {

/// chi of one point, for each body that carries it: maps a force at the point to that body's frame,
/// with all joints between free.
template <class Scalar>
using ExtendedPropagators = std::map<int, Matrix6<Scalar>>;

template <class Scalar>
ExtendedPropagators<Scalar> extended_propagators(const Model<Scalar>& model,
                                                 const ForcePropagation<Scalar>& forces, int body,
                                                 const Matrix6<Scalar>& X_point) {
  ExtendedPropagators<Scalar> chi;
  Matrix6<Scalar> from_point = X_point;
  for (int i = body; i != kWorld; i = model.body(i).parent) {
    chi.emplace(i, from_point);
    from_point = (forces.L[i] * from_point).eval();
  }
  return chi;
}

}  // namespace detail

/// Lambda^-1 by the extended-force-propagator algorithm (EFPA: Wensing, Featherstone & Orin, ICRA
/// 2012). Every block is one product at the nearest common ancestor, chi_i^T Omega_h chi_j, whereas
/// table 5.3 goes joint by joint for every pair. O(n + m d + m^2) for m points at depth d.
/// Precondition: no mimic joints.
template <class Scalar>
Matrix<Scalar> lambda_inverse_by_extended_propagators(const Model<Scalar>& model,
                                                      PointsArg<Scalar> points,
                                                      VectorArg<Scalar> q) {
  assert(!model.has_mimics());
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  const detail::ForcePropagation<Scalar> forces(model, k);
  const int blocks = static_cast<int>(points.size());
  Matrix<Scalar> all = Matrix<Scalar>::Zero(6 * blocks, 6 * blocks);
  std::vector<detail::ExtendedPropagators<Scalar>> chi;
  for (int i = 0; i < blocks; ++i) {
    const int body = points[static_cast<std::size_t>(i)].body;
    chi.push_back(detail::extended_propagators(
        model, forces, body, point_transform(points[static_cast<std::size_t>(i)], k)));
    for (int j = 0; j <= i; ++j) {
      const int h =
          detail::nearest_common_ancestor(model, body, points[static_cast<std::size_t>(j)].body);
      if (h == kWorld) continue;
      const Matrix6<Scalar> block =
          chi.back().at(h).transpose() * forces.Omega[h] * chi[static_cast<std::size_t>(j)].at(h);
      all.template block<6, 6>(6 * i, 6 * j) = block;
      all.template block<6, 6>(6 * j, 6 * i) = block.transpose();
    }
  }
  const std::vector<int> rows = controlled_rows<Scalar>(points);
  return all(rows, rows);
}

}  // namespace treeline::interpreter
