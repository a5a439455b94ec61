#pragma once

#include <vector>

#include "recursion/methods/articulated_inertia.hpp"
#include "recursion/methods/task_basis.hpp"

namespace treeline {

/// Whether Chang table 5.1 applies without a big base: all points are on one link behind a floating
/// joint, and there are no mimics.
template <class Scalar>
bool permits_inertia_propagation(const Tree<Scalar>& tree) {
  const auto& points = tree.operational_points;
  if (points.empty() || tree.has_mimics) {
    return false;
  }
  for (const TreePoint<Scalar>& point : points) {
    if (point.link != points.front().link) {
      return false;
    }
  }
  for (int i = points.front().link; i >= 0; i = tree.links[static_cast<std::size_t>(i)].parent) {
    if (tree.links[static_cast<std::size_t>(i)].is_floating()) {
      return true;
    }
  }
  return false;
}

/// Inertia of the whole robot as felt at a link (Chang table 5.1), by the outward recursion
/// Lambda_i = I_i + N - N S (S^T N S)^-1 S^T N with N = X^-1 Lambda_h X^-T. It starts at a link
/// behind a floating joint, through which nothing is felt. I_i includes the branches beside the
/// path.
template <class Scalar>
ArticulatedInertia<Scalar> propagated_inertia(const Tree<Scalar>& tree,
                                              const std::vector<JointTransform<Scalar>>& X,
                                              int tip) {
  const std::size_t n = tree.links.size();
  std::vector<bool> on_path(n);
  for (int i = tip; i >= 0; i = tree.links[static_cast<std::size_t>(i)].parent) {
    on_path[static_cast<std::size_t>(i)] = true;
  }
  std::vector<ArticulatedInertia<Scalar>> I;
  for (const TreeLink<Scalar>& link : tree.links) {
    I.push_back(articulated_inertia(link.inertia));
  }
  for (std::size_t i = n; i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    if (!on_path[i] && link.parent >= 0 && !link.is_floating()) {
      section(link, i, "articulated inertia");
      auto& parent = I[static_cast<std::size_t>(link.parent)];
      const auto joint = joint_projection(link.kind, I[i], link.drive.inertia);
      parent = parent + to_parent(X[i], without_joint(link.kind, I[i], joint));
    }
  }
  ArticulatedInertia<Scalar> Lambda;
  bool felt = false;
  for (std::size_t i = 0; i < n; ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    if (!on_path[i]) {
      continue;
    }
    section(link, i, "felt inertia");
    if (link.is_floating()) {
      Lambda = I[i];
      felt = true;
    } else if (felt) {
      const ArticulatedInertia<Scalar> N = to_child(X[i], Lambda);
      const auto joint = joint_projection(link.kind, N, link.drive.inertia);
      Lambda = I[i] + without_joint(link.kind, N, joint);
    }
  }
  return Lambda;
}

/// Lambda^-1 of points on one link behind a floating joint: the inverse of the inertia felt there.
template <class Scalar>
DenseMatrix<Scalar> lambda_inverse_by_inertia_propagation(
    const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X,
    const std::vector<TaskPoint<Scalar>>& tasks, std::size_t rows) {
  const auto Lambda = factor_ldlt(dense(propagated_inertia(tree, X, tasks.front().link)));
  DenseMatrix<Scalar> Lambda_inv(rows, rows);
  std::vector<std::vector<Scalar>> Y;  // L^-1 K
  for (const TaskPoint<Scalar>& task : tasks) {
    for (const TaskRow<Scalar>& row : task.rows) {
      const Wrench<Scalar> K = unit_wrench(task, row);
      Y.push_back(solve_lower(Lambda, {K.f.x, K.f.y, K.f.z, K.n.x, K.n.y, K.n.z}));
    }
  }
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t s = 0; s <= r; ++s) {
      Scalar entry(0.0);
      for (std::size_t k = 0; k < 6; ++k) {
        entry = entry + Y[r][k] * Lambda.inverse_D[k] * Y[s][k];
      }
      Lambda_inv(r, s) = Lambda_inv(s, r) = entry;
    }
  }
  return Lambda_inv;
}

}  // namespace treeline
