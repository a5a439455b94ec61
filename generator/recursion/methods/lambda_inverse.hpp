#pragma once

#include <array>
#include <map>
#include <vector>

#include "recursion/methods/articulated_inertia.hpp"
#include "recursion/methods/factor_mass_matrix.hpp"
#include "recursion/methods/jacobian.hpp"
#include "recursion/methods/mass_matrix.hpp"

namespace treeline {

/// A unit force of one task row on its way to the base: the row's index and what is left of the
/// force.
template <class Scalar>
struct PropagatedForce {
  std::size_t row;
  Wrench<Scalar> K;
};

/// Adds work_r work_s inverse_D for all pairs of forces to the lower triangle of Lambda^-1.
template <class Scalar>
void add_outer_product(const std::vector<PropagatedForce<Scalar>>& forces,
                       const std::vector<Scalar>& work, const Scalar& inverse_D,
                       DenseMatrix<Scalar>& Lambda_inv) {
  for (std::size_t r = 0; r < forces.size(); ++r) {
    const Scalar scaled = work[r] * inverse_D;
    for (std::size_t s = 0; s < forces.size(); ++s) {
      if (forces[s].row <= forces[r].row) {
        Scalar& entry = Lambda_inv(forces[r].row, forces[s].row);
        entry = entry + scaled * work[s];
      }
    }
  }
}

/// Aligns the forces of all rows at one link, on which the same operations are done: one lane per
/// row.
template <class Scalar>
void align_lanes(std::vector<PropagatedForce<Scalar>>& forces, std::size_t rows) {
  constexpr std::array<Scalar Vector3<Scalar>::*, 3> kParts{
      &Vector3<Scalar>::x, &Vector3<Scalar>::y, &Vector3<Scalar>::z};
  for (const auto triple : {&Wrench<Scalar>::f, &Wrench<Scalar>::n}) {
    for (const auto part : kParts) {
      std::vector<Scalar> lanes(rows, Scalar(0.0));
      for (const PropagatedForce<Scalar>& force : forces) {
        lanes[force.row] = force.K.*triple.*part;
      }
      align_lanes(lanes);
      for (PropagatedForce<Scalar>& force : forces) {
        force.K.*triple.*part = lanes[force.row];
      }
    }
  }
}

/// Removes unit forces that reach a floating joint, which passes none on. Lambda^-1 gains K^T IA^-1
/// K.
template <class Scalar>
void absorb_in_floating_joint(const LdltFactor<Scalar>& IA,
                              std::vector<PropagatedForce<Scalar>>& forces,
                              DenseMatrix<Scalar>& Lambda_inv) {
  std::vector<std::vector<Scalar>> Y;
  for (const PropagatedForce<Scalar>& force : forces) {
    const Wrench<Scalar>& K = force.K;
    Y.push_back(solve_lower(IA, {K.f.x, K.f.y, K.f.z, K.n.x, K.n.y, K.n.z}));
  }
  for (std::size_t k = 0; k < 6; ++k) {
    std::vector<Scalar> work;
    for (const std::vector<Scalar>& y : Y) {
      work.push_back(y[k]);
    }
    add_outer_product(forces, work, IA.inverse_D[k], Lambda_inv);
  }
  forces.clear();
}

/// The part K - U D^-1 (S^T K) of a force that the joint passes on. Its component along the joint
/// is what the rotor holds, without a rotor an exact zero.
template <class Scalar>
Wrench<Scalar> without_work(JointKind kind, const JointProjection<Scalar>& joint,
                            const Wrench<Scalar>& K) {
  const Scalar work = along_axis(kind, K.f, K.n);
  Wrench<Scalar> left = K - Wrench<Scalar>{joint.u.f * work, joint.u.n * work};
  along_axis(kind, left.f, left.n) = joint.held * work;
  return left;
}

/// Removes from unit forces the part that moves the joint, and adds its work to Lambda^-1.
template <class Scalar>
void absorb_in_joint(JointKind kind, const JointProjection<Scalar>& joint,
                     std::vector<PropagatedForce<Scalar>>& forces,
                     DenseMatrix<Scalar>& Lambda_inv) {
  std::vector<Scalar> work;
  for (const PropagatedForce<Scalar>& force : forces) {
    work.push_back(along_axis(kind, force.K.f, force.K.n));
  }
  add_outer_product(forces, work, joint.inverse_D, Lambda_inv);
  for (PropagatedForce<Scalar>& force : forces) {
    force.K = without_work(kind, joint, force.K);
  }
}

/// Work of unit forces along the coordinates of clusters of joints, by velocity and row.
template <class Scalar>
using ClusterWork = std::vector<std::map<std::size_t, Scalar>>;

/// Adds the work of the forces at a link of a cluster, which they pass unchanged.
template <class Scalar>
void work_in_cluster(const TreeLink<Scalar>& link,
                     const std::vector<PropagatedForce<Scalar>>& forces,
                     std::map<std::size_t, Scalar>& work) {
  for (const PropagatedForce<Scalar>& force : forces) {
    Scalar& own = work.try_emplace(force.row, Scalar(0.0)).first->second;
    own = own + link.multiplier * along_axis(link.kind, force.K.f, force.K.n);
  }
}

/// Removes from unit forces at the anchor of a cluster the part that moves it, and adds its work to
/// Lambda^-1.
template <class Scalar>
void absorb_in_cluster(const ClusterProjection<Scalar>& cluster,
                       const std::map<std::size_t, Scalar>& work,
                       std::vector<PropagatedForce<Scalar>>& at_anchor,
                       DenseMatrix<Scalar>& Lambda_inv) {
  std::vector<PropagatedForce<Scalar>> rows;
  std::vector<Scalar> works;
  for (const auto& [row, own] : work) {
    rows.push_back({row, {}});
    works.push_back(own);
  }
  add_outer_product(rows, works, cluster.inverse_D, Lambda_inv);
  for (PropagatedForce<Scalar>& force : at_anchor) {
    const auto own = work.find(force.row);
    if (own == work.end()) continue;
    force.K = force.K - Wrench<Scalar>{cluster.u.f * own->second, cluster.u.n * own->second};
  }
}

/// Adds what arrives at a link of a unit force, of which a part may be there already.
template <class Scalar>
void add_force(const PropagatedForce<Scalar>& force, std::vector<PropagatedForce<Scalar>>& forces) {
  for (PropagatedForce<Scalar>& there : forces) {
    if (there.row != force.row) continue;
    there.K = there.K + force.K;
    return;
  }
  forces.push_back(force);
}

/// The unit forces of all rows at the links where their points are.
template <class Scalar>
std::vector<std::vector<PropagatedForce<Scalar>>> unit_forces_on_links(
    const std::vector<TaskPoint<Scalar>>& tasks, std::size_t links) {
  std::vector<std::vector<PropagatedForce<Scalar>>> forces(links);
  std::size_t row = 0;
  for (const TaskPoint<Scalar>& task : tasks) {
    for (const TaskRow<Scalar>& direction : task.rows) {
      if (task.link >= 0) {
        forces[static_cast<std::size_t>(task.link)].push_back({row, unit_wrench(task, direction)});
      }
      ++row;
    }
    for (const TaskPart<Scalar>& part : task.parts) {
      for (std::size_t k = 0; k < task.rows.size(); ++k) {
        forces[part.link].push_back(
            {row - task.rows.size() + k, wrench_on_part(part, part.directions[k])});
      }
    }
  }
  return forces;
}

/// Lambda^-1 = sum over joints of (S^T K)^T D^-1 (S^T K), where K are the unit forces of the rows,
/// propagated inward (PV-OSIM: Sathya et al. 2023). A cluster of joints counts as one joint of its
/// anchor.
template <class Scalar>
DenseMatrix<Scalar> lambda_inverse_by_unit_forces(const Tree<Scalar>& tree,
                                                  const std::vector<JointTransform<Scalar>>& X,
                                                  const std::vector<TaskPoint<Scalar>>& tasks,
                                                  std::size_t rows) {
  const ArticulatedTree<Scalar> bodies = articulate(tree, X);
  auto forces = unit_forces_on_links(tasks, tree.links.size());
  ClusterWork<Scalar> work(bodies.shapes.size());
  std::vector<PropagatedForce<Scalar>> on_world;
  DenseMatrix<Scalar> Lambda_inv(rows, rows);
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    const auto at = static_cast<std::size_t>(link.v_index);
    const JointCluster& shape = bodies.shapes[at];
    section(link, i, "force propagation");
    align_lanes(forces[i], rows);
    if (link.is_floating()) {
      absorb_in_floating_joint(bodies.floating[i], forces[i], Lambda_inv);
    } else if (!shape.is_shared()) {
      absorb_in_joint(link.kind, bodies.joints[i], forces[i], Lambda_inv);
    } else {
      work_in_cluster(link, forces[i], work[at]);
    }
    if (link.parent >= 0) {
      for (const PropagatedForce<Scalar>& force : forces[i]) {
        add_force({force.row, to_parent(X[i], force.K)},
                  forces[static_cast<std::size_t>(link.parent)]);
      }
    }
    if (shape.begins_at(i)) {
      auto& at_anchor =
          shape.anchor < 0 ? on_world : forces[static_cast<std::size_t>(shape.anchor)];
      absorb_in_cluster(bodies.clusters[at], work[at], at_anchor, Lambda_inv);
    }
    align_lower_columns(Lambda_inv, 0);
  }
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t s = 0; s < r; ++s) {
      Lambda_inv(s, r) = Lambda_inv(r, s);
    }
  }
  return Lambda_inv;
}

/// Lambda^-1 = (J L^-1) D^-1 (J L^-1)^T with M = L^T D L (Featherstone 2010).
template <class Scalar>
DenseMatrix<Scalar> lambda_inverse_by_factors(const Tree<Scalar>& tree,
                                              const std::vector<JointTransform<Scalar>>& X,
                                              const DenseMatrix<Scalar>& J) {
  return inverse_inertia_in_rows(factor_ltdl(mass_matrix(tree, X)), J);
}

}  // namespace treeline
