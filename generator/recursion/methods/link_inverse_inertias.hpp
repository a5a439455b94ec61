#pragma once

#include <vector>

#include "recursion/methods/force_propagation.hpp"

namespace treeline {

namespace detail {

/// Omega at a frame on the link, in the frame's axes: X_f^T Omega X_f.
template <class Scalar>
Mobility<Scalar> at_frame(const Mobility<Scalar>& Omega, const TreePoint<Scalar>& frame) {
  const auto [C, Bt, A] = shifted<Scalar>({Omega.C, transposed(Omega.B), Omega.A}, -frame.p);
  const Matrix3<Scalar> Rt = transposed(frame.R);
  const Matrix3<Scalar> BR = transposed(Bt) * frame.R;
  return {congruent(Rt, A), Rt * BR, congruent(Rt, C)};
}

template <class Scalar>
void append_rows(const DenseMatrix<Scalar>& Omega, std::vector<Scalar>& entries) {
  entries.insert(entries.end(), Omega.values().begin(), Omega.values().end());
}

}  // namespace detail

/// Lambda_i^-1 of every link that moves relative to its parent, 6x6 row-major, one after the other,
/// at the link's URDF frame and in its axes. Outward recursion Omega_i = L^T Omega_h L + S D^-1 S^T
/// in O(n). It is the inverse of Chang table 8.1, without the subtraction there and for any base.
/// For trees without mimic joints.
template <class Scalar>
std::vector<Scalar> link_inverse_inertias(const Tree<Scalar>& tree,
                                          const std::vector<JointTransform<Scalar>>& X) {
  std::vector<TaskPoint<Scalar>> all_links;
  for (const TreePoint<Scalar>& frame : tree.link_frames) {
    all_links.push_back({frame.link, frame.p, {}});
  }
  const auto Omega = propagate_mobilities(tree, X, articulate(tree, X), all_links);
  std::vector<Scalar> entries;
  for (const TreePoint<Scalar>& frame : tree.link_frames) {
    const auto i = static_cast<std::size_t>(frame.link);
    section(tree.links[i], i, "inverse inertia");
    const auto [A, B, C] = detail::at_frame(Omega[i], frame);
    detail::append_rows(dense(ArticulatedInertia<Scalar>{A, B, C}), entries);
  }
  return entries;
}

/// Lambda_i^-1 of every link that moves relative to its parent, 6x6 row-major, as J M^-1 J^T link
/// by link in O(n^3). For trees whose joints share a coordinate.
template <class Scalar>
std::vector<Scalar> link_inverse_inertias_by_factors(const Tree<Scalar>& tree,
                                                     const std::vector<JointTransform<Scalar>>& X,
                                                     const std::vector<WorldPose<Scalar>>& poses) {
  const auto factor = factor_ltdl(mass_matrix(tree, X));
  std::vector<Scalar> entries;
  for (const TreePoint<Scalar>& frame : tree.link_frames) {
    const auto J = jacobian_inward(tree, X, {task_point(frame, {}, poses)}, 6, poses);
    detail::append_rows(inverse_inertia_in_rows(factor, J), entries);
  }
  return entries;
}

}  // namespace treeline
