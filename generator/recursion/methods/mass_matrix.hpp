#pragma once

#include <vector>

#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/algebra/parallel_axes.hpp"
#include "recursion/methods/inverse_dynamics.hpp"

namespace treeline {

/// Composite inertia: that of everything beyond a joint, at the link's frame.
template <class Scalar>
struct CompositeInertia {
  Scalar mass{};
  Vector3<Scalar> h;
  Symmetric3<Scalar> J;
};

/// Composite inertia at the parent's origin, in the parent's axes (parallel axes).
template <class Scalar>
CompositeInertia<Scalar> to_parent(const JointTransform<Scalar>& X,
                                   const CompositeInertia<Scalar>& inertia) {
  const Vector3<Scalar> h = X.to_parent(inertia.h);
  const Vector3<Scalar>& p = X.p;
  const Symmetric3<Scalar> shift = parallel_axes_shift(inertia.mass, h, p);
  return {inertia.mass, h + p * inertia.mass, X.matrix_to_parent(inertia.J) + shift};
}

/// Wrench for a unit acceleration of the composite by degree of freedom `k` of the link's joint.
template <class Scalar>
Wrench<Scalar> unit_acceleration_wrench(const TreeLink<Scalar>& link,
                                        const CompositeInertia<Scalar>& inertia, int k) {
  const Vector3<Scalar>& h = inertia.h;
  const Symmetric3<Scalar>& J = inertia.J;
  const Scalar zero(0.0);
  const Scalar one(1.0);
  const Vector3<Scalar> axes[3] = {{one, zero, zero}, {zero, one, zero}, {zero, zero, one}};
  const Vector3<Scalar>& e = axes[link.axis(k)];
  if (link.is_angular(k)) {
    return {cross(e, h), J * e};
  }
  return {e * inertia.mass, cross(h, e)};
}

template <class Scalar>
std::vector<CompositeInertia<Scalar>> composite_inertias(
    const Tree<Scalar>& tree, const std::vector<JointTransform<Scalar>>& X) {
  std::vector<CompositeInertia<Scalar>> composites;
  for (const TreeLink<Scalar>& link : tree.links) {
    composites.push_back({link.inertia.mass, link.inertia.h, link.inertia.J});
  }
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "composite inertia");
    if (link.parent < 0) {
      continue;
    }
    CompositeInertia<Scalar>& parent = composites[static_cast<std::size_t>(link.parent)];
    const CompositeInertia<Scalar> moved = to_parent(X[i], composites[i]);
    parent = {parent.mass + moved.mass, parent.h + moved.h, parent.J + moved.J};
  }
  return composites;
}

/// Adds the entries of M between velocity `column`, whose unit acceleration needs this wrench, and
/// the joint of `ancestor`. In the joint's own rows only the entries up to degree `k` are new.
template <class Scalar, class Add>
void add_mass_entries(const TreeLink<Scalar>& ancestor, const Wrench<Scalar>& wrench,
                      std::size_t column, const Scalar& multiplier, bool own, int k, Add add) {
  const auto at = static_cast<std::size_t>(ancestor.v_index);
  if (!ancestor.is_floating()) {
    const Scalar force = along_axis(ancestor.kind, wrench.f, wrench.n);
    const Scalar entry = multiplier * (ancestor.multiplier * force);
    // If two joints share a coordinate, their product counts twice on the diagonal.
    add(at, column, !own && at == column ? Scalar(2.0) * entry : entry);
    return;
  }
  const Scalar parts[6] = {wrench.f.x, wrench.f.y, wrench.f.z, wrench.n.x, wrench.n.y, wrench.n.z};
  for (int row = 0; row < (own ? k + 1 : 6); ++row) {
    add(at + static_cast<std::size_t>(row), column,
        multiplier * parts[static_cast<std::size_t>(row)]);
  }
}

/// M by the composite-rigid-body algorithm (RBDA table 6.2): nv x nv, symmetric. A coordinate that
/// several joints share collects the terms of all of them. Rotors add to the diagonal.
template <class Scalar>
DenseMatrix<Scalar> mass_matrix(const Tree<Scalar>& tree,
                                const std::vector<JointTransform<Scalar>>& X) {
  const auto n = static_cast<std::size_t>(tree.nv);
  const auto composites = composite_inertias(tree, X);
  DenseMatrix<Scalar> M(n, n);
  const auto add = [&M](std::size_t a, std::size_t b, const Scalar& value) {
    M(a, b) = M(a, b) + value;
    if (a != b) {
      M(b, a) = M(b, a) + value;
    }
  };
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "mass matrix");
    for (int k = 0; k < link.velocities(); ++k) {
      const auto column = static_cast<std::size_t>(link.v_index + k);
      Wrench<Scalar> wrench = unit_acceleration_wrench(link, composites[i], k);
      for (std::size_t j = i;;) {
        const TreeLink<Scalar>& ancestor = tree.links[j];
        add_mass_entries(ancestor, wrench, column, link.multiplier, j == i, k, add);
        if (ancestor.parent < 0) {
          break;
        }
        wrench = to_parent(X[j], wrench);
        j = static_cast<std::size_t>(ancestor.parent);
      }
    }
  }
  for (const TreeLink<Scalar>& link : tree.links) {
    const auto at = static_cast<std::size_t>(link.v_index);
    M(at, at) = M(at, at) + link.drive.inertia;
  }
  return M;
}

}  // namespace treeline
