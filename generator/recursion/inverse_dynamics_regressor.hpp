#pragma once

#include <array>
#include <vector>

#include "recursion/dense_matrix.hpp"
#include "recursion/frame_motion.hpp"
#include "recursion/model_parameter.hpp"

namespace treeline {

template <class Scalar>
using InertialRow = std::array<Scalar, kInertialParameters>;

/// The power of a body's inertial force in a unit motion, per unit of each of its ten parameters:
/// the column of J in n = J wd + w x J w along the turn, f = m a + U h and n = h x a along both.
template <class Scalar>
InertialRow<Scalar> inertial_row(const LinkMotion<Scalar>& body, const LinkVelocity<Scalar>& unit) {
  const AngularMatrix<Scalar>& U = body.U;
  const Vector3<Scalar>& wd = body.wd;
  const Vector3<Scalar> h = transposed_times(U.matrix(), unit.v) + cross(body.a, unit.w);
  const auto along = [&](const Scalar& x, const Scalar& y, const Scalar& z) {
    return dot(unit.w, Vector3<Scalar>{x, y, z});
  };
  return {dot(unit.v, body.a),
          h.x,
          h.y,
          h.z,
          along(wd.x, U.wxwz, -U.wxwy),
          along(-U.zx, U.zy, U.wx2 - U.wy2),
          along(-U.wywz, wd.y, U.wxwy),
          along(U.yx, U.wz2 - U.wx2, -U.yz),
          along(U.wy2 - U.wz2, -U.xy, U.xz),
          along(U.wywz, -U.wxwz, wd.z)};
}

/// Adds the entries of a frame's row to its columns.
template <class Scalar>
void add_to_columns(std::size_t frame, const InertialRow<Scalar>& entries,
                    const std::vector<ModelParameter>& columns, std::size_t row,
                    DenseMatrix<Scalar>& matrix) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const ModelParameter& column = columns[k];
    if (column.kind != ModelParameter::Kind::inertial || column.frame != frame) continue;
    matrix(row, k) = matrix(row, k) + entries[static_cast<std::size_t>(column.entry)];
  }
}

/// Y of M qdd + b + g = Y p, nv x columns: for every frame of a link the inertial forces of unit
/// parameters there along the unit motions of all velocities that move it (Atkeson, An & Hollerbach
/// 1986, in the frames of the file). Of a rotor its joint's acceleration, of viscous friction its
/// velocity.
template <class Scalar>
DenseMatrix<Scalar> inverse_dynamics_regressor(const Tree<Scalar>& tree,
                                               const std::vector<JointTransform<Scalar>>& X,
                                               const JointRates<Scalar>& rates,
                                               const std::vector<ModelParameter>& columns) {
  const auto motions = outward_motion(tree, X, rates, -tree.gravity);
  const auto by_velocity = motions_by_velocity(tree, X);
  DenseMatrix<Scalar> Y(static_cast<std::size_t>(tree.nv), columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const auto v = static_cast<std::size_t>(columns[k].v);
    if (columns[k].kind == ModelParameter::Kind::rotor) Y(v, k) = rates.acceleration(v);
    if (columns[k].kind == ModelParameter::Kind::viscous) Y(v, k) = rates.velocity(v);
  }
  for (std::size_t f = 0; f < tree.link_frames.size(); ++f) {
    const TreePoint<Scalar>& frame = tree.link_frames[f];
    const auto link = static_cast<std::size_t>(frame.link);
    section(tree.links[link], link, "columns");
    const LinkMotion<Scalar> body = motion_of_frame(motions[link], frame);
    for (const auto& [v, motion] : by_velocity[link]) {
      add_to_columns(f, inertial_row(body, velocity_of_frame(motion, frame)), columns, v, Y);
    }
  }
  return Y;
}

}  // namespace treeline
