#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "interpreter/lambda_inverse.hpp"

namespace treeline::interpreter {

namespace detail {

/// One column for each controlled row of all points: its unit force at the frame of the point's
/// body if that is `body`, otherwise zero.
template <class Scalar>
Matrix<Scalar> unit_forces(const Points<Scalar>& points, const Kinematics<Scalar>& k, int body) {
  Matrix<Scalar> K = Matrix<Scalar>::Zero(6, 6 * static_cast<int>(points.size()));
  int column = 0;
  for (const auto& point : points) {
    if (point.body == body) K.template middleCols<6>(column) = point_transform(point, k);
    column += 6;
  }
  return K(Eigen::all, controlled_rows<Scalar>(points));
}

/// Unit forces propagated through a run of joints: their values at its beginning, the map of forces
/// from beginning to end, and the work done by the joints between.
template <class Scalar>
struct ForceSegment {
  Matrix<Scalar> K;                                    ///< 6 x rows
  Matrix6<Scalar> chi = Matrix6<Scalar>::Identity();   ///< maps forces from beginning to end
  Matrix6<Scalar> mobility = Matrix6<Scalar>::Zero();  ///< sum of chi^T S D^-1 S^T chi
};

}  // namespace detail

/// Lambda^-1 = sum over joints of (S^T K)^T D^-1 (S^T K), where K are the unit forces of the rows,
/// propagated inward by K_h = sum L K (PV-OSIM: Sathya et al. 2023). Precondition: no mimic joints.
template <class Scalar>
Matrix<Scalar> lambda_inverse_by_unit_forces(const Model<Scalar>& model, PointsArg<Scalar> points,
                                             VectorArg<Scalar> q) {
  assert(!model.has_mimics());
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  const auto inertia = articulated_inertia(model, k);
  const int rows = row_count<Scalar>(points);
  PerBody<Matrix<Scalar>> K(model.size(), Matrix<Scalar>::Zero(6, rows));
  Matrix<Scalar> Lambda_inverse = Matrix<Scalar>::Zero(rows, rows);
  for (int i = model.size() - 1; i >= 0; --i) {
    K[i] += detail::unit_forces(points, k, i);
    Matrix<Scalar> passed_on = K[i];
    if (k.S[i].cols() > 0) {
      const Matrix<Scalar> work = k.S[i].transpose() * K[i];
      const Matrix<Scalar> motion = inertia.D_inverse[i] * work;
      Lambda_inverse += work.transpose() * motion;
      passed_on -= inertia.U[i] * motion;
    }
    K[model.body(i).parent] += k.X[i] * passed_on;
  }
  return Lambda_inverse;
}

/// Lambda^-1 by unit forces in reduced form (PV-OSIMr). Along a run of joints without branches or
/// points only two 6x6 matrices are updated, however many rows there are; the rows are updated only
/// where runs meet. Precondition: no mimic joints.
template <class Scalar>
Matrix<Scalar> lambda_inverse_by_reduced_unit_forces(const Model<Scalar>& model,
                                                     PointsArg<Scalar> points,
                                                     VectorArg<Scalar> q) {
  assert(!model.has_mimics());
  using Segment = detail::ForceSegment<Scalar>;
  const auto k = kinematics<Scalar>(model, q, Vector<Scalar>::Zero(model.nv));
  const detail::ForcePropagation<Scalar> forces(model, k);
  const auto inertia = articulated_inertia(model, k);
  const int rows = row_count<Scalar>(points);
  PerBody<std::vector<Segment>> arriving(model.size(), {});
  Matrix<Scalar> Lambda_inverse = Matrix<Scalar>::Zero(rows, rows);
  const auto close = [&](const Segment& segment) {
    Lambda_inverse += segment.K.transpose() * segment.mobility * segment.K;
    return Matrix<Scalar>(segment.chi * segment.K);
  };
  for (int i = model.size() - 1; i >= 0; --i) {
    Matrix<Scalar> own = detail::unit_forces(points, k, i);
    const bool has_points = std::any_of(points.begin(), points.end(),
                                        [i](const auto& point) { return point.body == i; });
    if (!has_points && arriving[i].empty()) continue;
    Segment segment;
    if (!has_points && arriving[i].size() == 1) {
      segment = std::move(arriving[i].front());
    } else {
      for (const Segment& arrived : arriving[i]) own += close(arrived);
      segment.K = std::move(own);
    }
    if (k.S[i].cols() > 0) {
      const Matrix<Scalar> work = k.S[i].transpose() * segment.chi;
      segment.mobility += work.transpose() * inertia.D_inverse[i] * work;
    }
    segment.chi = (forces.L[i] * segment.chi).eval();
    arriving[model.body(i).parent].push_back(std::move(segment));
  }
  for (const Segment& segment : arriving[kWorld]) close(segment);
  return Lambda_inverse;
}

}  // namespace treeline::interpreter
