#pragma once

#include <span>
#include <vector>

#include "recursion/methods/inverse_dynamics_regressor.hpp"

namespace treeline {

/// m v.v / 2 + h.(v x w) + w.J w / 2, per unit of each of the ten parameters.
template <class Scalar>
InertialRow<Scalar> kinetic_row(const LinkVelocity<Scalar>& body) {
  const auto& [v, w] = body;
  const Scalar half(0.5);
  const Vector3<Scalar> h = cross(v, w);
  return {half * dot(v, v),
          h.x,
          h.y,
          h.z,
          half * (w.x * w.x),
          w.x * w.y,
          half * (w.y * w.y),
          w.x * w.z,
          w.y * w.z,
          half * (w.z * w.z)};
}

/// Gravity in the axes of a link, and minus its product with the place of the link's origin.
template <class Scalar>
struct LinkWeight {
  Vector3<Scalar> gravity;
  Scalar potential{};
};

/// Outward.
template <class Scalar>
std::vector<LinkWeight<Scalar>> link_weights(const Tree<Scalar>& tree,
                                             const std::vector<JointTransform<Scalar>>& X) {
  std::vector<LinkWeight<Scalar>> weights;
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "weight");
    const LinkWeight<Scalar> parent = link.parent < 0
                                          ? LinkWeight<Scalar>{tree.gravity, Scalar(0.0)}
                                          : weights[static_cast<std::size_t>(link.parent)];
    weights.push_back(
        {X[i].to_child(parent.gravity), parent.potential - dot(parent.gravity, X[i].p)});
  }
  return weights;
}

/// -m g.x - h.g, per unit of each of the ten parameters of a body whose frame is fixed to a link.
template <class Scalar>
InertialRow<Scalar> potential_row(const LinkWeight<Scalar>& link, const TreePoint<Scalar>& frame) {
  const Vector3<Scalar> h = -transposed_times(frame.R, link.gravity);
  InertialRow<Scalar> row;
  row.fill(Scalar(0.0));
  row[0] = link.potential - dot(link.gravity, frame.p);
  row[1] = h.x;
  row[2] = h.y;
  row[3] = h.z;
  return row;
}

/// E of [T; U] = E p, 2 x columns: kinetic energy in the first row, potential energy, zero with all
/// mass at the world's origin, in the second. Columns of friction are zero.
template <class Scalar>
DenseMatrix<Scalar> energy_regressor(const Tree<Scalar>& tree,
                                     const std::vector<JointTransform<Scalar>>& X,
                                     std::span<const Scalar> qd,
                                     const std::vector<ModelParameter>& columns) {
  const JointRates<Scalar> rates{qd, {}};
  const auto velocities = link_velocities(tree, X, rates);
  const auto weights = link_weights(tree, X);
  DenseMatrix<Scalar> E(2, columns.size());
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].kind != ModelParameter::Kind::rotor) continue;
    const Scalar rate = rates.velocity(static_cast<std::size_t>(columns[k].v));
    E(0, k) = rounded<Scalar>(Digits50(columns[k].factor / 2)) * (rate * rate);
  }
  for (const ColumnFrame<Scalar>& frame : column_frames(tree)) {
    const auto link = static_cast<std::size_t>(frame.place.link);
    section(tree.links[link], link, "columns");
    add_to_columns(frame, kinetic_row(velocity_of_frame(velocities[link], frame.place)), columns, 0,
                   E);
    add_to_columns(frame, potential_row(weights[link], frame.place), columns, 1, E);
  }
  return E;
}

}  // namespace treeline
