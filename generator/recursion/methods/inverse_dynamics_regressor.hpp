#pragma once

#include <array>
#include <vector>

#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/methods/frame_motion.hpp"
#include "recursion/parameters/model_parameter.hpp"
#include "recursion/tree/joint_drive.hpp"

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

/// A frame in which ten of the columns are: that of a link, or of a body added to one.
template <class Scalar>
struct ColumnFrame {
  ModelParameter::Kind kind = ModelParameter::Kind::inertial;
  std::size_t index = 0;
  TreePoint<Scalar> place;
};

template <class Scalar>
std::vector<ColumnFrame<Scalar>> column_frames(const Tree<Scalar>& tree) {
  std::vector<ColumnFrame<Scalar>> frames;
  for (std::size_t f = 0; f < tree.link_frames.size(); ++f) {
    frames.push_back({ModelParameter::Kind::inertial, f, tree.link_frames[f]});
  }
  for (std::size_t f = 0; f < tree.payload_frames.size(); ++f) {
    frames.push_back({ModelParameter::Kind::payload, f, tree.payload_frames[f]});
  }
  return frames;
}

/// Adds the entries of a frame's row to its columns.
template <class Scalar>
void add_to_columns(const ColumnFrame<Scalar>& frame, const InertialRow<Scalar>& entries,
                    const std::vector<ModelParameter>& columns, std::size_t row,
                    DenseMatrix<Scalar>& matrix) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const ModelParameter& column = columns[k];
    if (column.kind != frame.kind || column.frame != frame.index) continue;
    matrix(row, k) = matrix(row, k) + entries[static_cast<std::size_t>(column.entry)];
  }
}

/// The force at its velocity of a rotor, or of friction, per unit of its parameter.
template <class Scalar>
Scalar drive_column(const ModelParameter& column, const JointRates<Scalar>& rates) {
  const auto v = static_cast<std::size_t>(column.v);
  const auto factor = rounded<Scalar>(column.factor);
  if (column.kind == ModelParameter::Kind::rotor) return factor * rates.acceleration(v);
  if (column.kind == ModelParameter::Kind::viscous) return factor * rates.velocity(v);
  return factor * smooth_sign<Scalar>(rounded<Scalar>(column.sharpness) * rates.velocity(v)).value;
}

/// Y of M qdd + b + g = Y p, nv x columns: for every frame of a link the inertial forces of unit
/// parameters there along the unit motions of all velocities that move it (Atkeson, An & Hollerbach
/// 1986, in the frames of the file). Of a rotor its joint's acceleration, of viscous friction its
/// velocity, of Coulomb friction the smooth sign of its velocity; of a joint that follows another
/// times its multiplier.
template <class Scalar>
DenseMatrix<Scalar> inverse_dynamics_regressor(const Tree<Scalar>& tree,
                                               const std::vector<JointTransform<Scalar>>& X,
                                               const JointRates<Scalar>& rates,
                                               const std::vector<ModelParameter>& columns) {
  const auto motions = outward_motion(tree, X, rates, -tree.gravity);
  const auto by_velocity = motions_by_velocity(tree, X);
  DenseMatrix<Scalar> Y(static_cast<std::size_t>(tree.nv), columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].is_of_body()) continue;
    Y(static_cast<std::size_t>(columns[k].v), k) = drive_column(columns[k], rates);
  }
  for (const ColumnFrame<Scalar>& frame : column_frames(tree)) {
    const auto link = static_cast<std::size_t>(frame.place.link);
    section(tree.links[link], link, "columns");
    const LinkMotion<Scalar> body = motion_of_frame(motions[link], frame.place);
    for (const auto& [v, motion] : by_velocity[link]) {
      add_to_columns(frame, inertial_row(body, velocity_of_frame(motion, frame.place)), columns, v,
                     Y);
    }
  }
  return Y;
}

}  // namespace treeline
