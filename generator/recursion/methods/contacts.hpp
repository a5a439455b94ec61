#pragma once

#include <span>
#include <vector>

#include "recursion/algebra/capped_inverse.hpp"
#include "recursion/methods/forward_dynamics.hpp"
#include "recursion/methods/lambda_inverse.hpp"

namespace treeline {

/// Returns the three entries of a contact in a list as a vector.
template <class Scalar>
Vector3<Scalar> contact_entry(std::span<const Scalar> entries, std::size_t contact) {
  return {entries[3 * contact], entries[3 * contact + 1], entries[3 * contact + 2]};
}

/// Positions and velocities of the contacts, world axes, three entries per contact.
template <class Scalar>
struct ContactMotion {
  std::vector<Scalar> position, velocity;
};

/// Computes positions and velocities of the contacts: v_link + w x p for each contact's link, by an
/// outward recursion.
template <class Scalar>
ContactMotion<Scalar> contact_motion(const Tree<Scalar>& tree,
                                     const std::vector<JointTransform<Scalar>>& X,
                                     const std::vector<WorldPose<Scalar>>& poses,
                                     std::span<const Scalar> qd) {
  std::vector<LinkAcceleration<Scalar>> velocities;  // velocities have the same shape
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "velocity");
    LinkAcceleration<Scalar> v;
    if (link.parent >= 0) {
      v = to_child(X[i], velocities[static_cast<std::size_t>(link.parent)]);
    }
    const auto at = static_cast<std::size_t>(link.v_index);
    if (link.is_floating()) {
      v = {v.a + Vector3<Scalar>{qd[at], qd[at + 1], qd[at + 2]},
           v.wd + Vector3<Scalar>{qd[at + 3], qd[at + 4], qd[at + 5]}};
    } else {
      Scalar& own = along_axis(link.kind, v.a, v.wd);
      own = own + link.multiplier * qd[at];
    }
    velocities.push_back(v);
  }
  ContactMotion<Scalar> motion;
  for (const TreePoint<Scalar>& contact : tree.contacts) {
    const Vector3<Scalar> p = point_pose(poses, contact).p;
    motion.position.insert(motion.position.end(), {p.x, p.y, p.z});
    Vector3<Scalar> v;
    if (contact.link >= 0) {
      const auto i = static_cast<std::size_t>(contact.link);
      v = poses[i].R * (velocities[i].a + cross(velocities[i].wd, contact.p));
    }
    motion.velocity.insert(motion.velocity.end(), {v.x, v.y, v.z});
  }
  return motion;
}

/// Treats each contact as a task of one row, along its normal in the world.
template <class Scalar>
std::vector<TaskPoint<Scalar>> normal_tasks(const Tree<Scalar>& tree,
                                            const std::vector<WorldPose<Scalar>>& poses,
                                            std::span<const Scalar> normals) {
  std::vector<TaskPoint<Scalar>> tasks;
  for (std::size_t k = 0; k < tree.contacts.size(); ++k) {
    const TreePoint<Scalar>& contact = tree.contacts[k];
    const Vector3<Scalar> n = contact_entry(normals, k);
    const Vector3<Scalar> in_link =
        contact.link < 0 ? n : transposed_times(poses[static_cast<std::size_t>(contact.link)].R, n);
    tasks.push_back({contact.link, contact.p, {{false, in_link}}});
  }
  return tasks;
}

/// Effective masses 1 / (n^T Lambda_c^-1 n), one per row of `Lambda_inv` (Chang eq. 8.1), each with
/// a cap of 1 / border if there are `borders`.
template <class Scalar>
std::vector<Scalar> masses_along(const DenseMatrix<Scalar>& Lambda_inv,
                                 const std::vector<double>& borders = {}) {
  std::vector<Scalar> masses;
  for (std::size_t i = 0; i < Lambda_inv.rows(); ++i) {
    const Scalar& c = Lambda_inv(i, i);
    masses.push_back(borders.empty() ? Scalar(1.0) / c : capped_inverse(c, borders[i]));
  }
  return masses;
}

/// Sums up impulses at the contacts for each link, at the link's origin and in its axes.
template <class Scalar>
std::vector<Wrench<Scalar>> impulses_on_links(const Tree<Scalar>& tree,
                                              const std::vector<WorldPose<Scalar>>& poses,
                                              std::span<const Scalar> impulses) {
  std::vector<Wrench<Scalar>> on_links(tree.links.size());
  for (std::size_t k = 0; k < tree.contacts.size(); ++k) {
    const TreePoint<Scalar>& contact = tree.contacts[k];
    if (contact.link >= 0) {
      const auto i = static_cast<std::size_t>(contact.link);
      const Vector3<Scalar> y = transposed_times(poses[i].R, contact_entry(impulses, k));
      on_links[i] = on_links[i] + wrench_at(y, Vector3<Scalar>{}, contact.p);
    }
  }
  return on_links;
}

/// Jump dqd of the velocities by impulse propagation (Chang table 8.2): inward y_h = L y_i, where
/// the component along the joint is an exact zero, then outward like accelerations. Links beside
/// the struck paths receive no impulse inward, which costs nothing in a trace. A cluster of joints
/// takes its part at its anchor.
template <class Scalar>
std::vector<Scalar> impulse_response(const Tree<Scalar>& tree,
                                     const std::vector<JointTransform<Scalar>>& X,
                                     std::vector<Wrench<Scalar>> y) {
  const ArticulatedTree<Scalar> bodies = articulate(tree, X);
  std::vector<Scalar> along(static_cast<std::size_t>(tree.nv), Scalar(0.0));
  for (std::size_t i = tree.links.size(); i-- > 0;) {
    const TreeLink<Scalar>& link = tree.links[i];
    section(link, i, "impulse");
    const auto at = static_cast<std::size_t>(link.v_index);
    const JointCluster& shape = bodies.shapes[at];
    if (link.is_floating()) {
      const Scalar parts[6] = {y[i].f.x, y[i].f.y, y[i].f.z, y[i].n.x, y[i].n.y, y[i].n.z};
      for (std::size_t k = 0; k < 6; ++k) along[at + k] = parts[k];
      continue;
    }
    along[at] = along[at] + link.multiplier * along_axis(link.kind, y[i].f, y[i].n);
    if (link.parent >= 0) {
      Wrench<Scalar>& parent = y[static_cast<std::size_t>(link.parent)];
      parent = parent + to_parent(X[i], shape.is_shared()
                                            ? y[i]
                                            : without_work(link.kind, bodies.joints[i], y[i]));
    }
    if (shape.begins_at(i) && shape.anchor >= 0) {
      const Wrench<Scalar>& u = bodies.clusters[at].u;
      Wrench<Scalar>& anchor = y[static_cast<std::size_t>(shape.anchor)];
      anchor = anchor - Wrench<Scalar>{u.f * along[at], u.n * along[at]};
    }
  }
  return accelerate_outward(tree, X, bodies, along);
}

/// Jump dqd = M^-1 J^T y of the velocities, for trees whose joints share a coordinate.
template <class Scalar>
std::vector<Scalar> impulse_response_by_factors(const Tree<Scalar>& tree,
                                                const std::vector<JointTransform<Scalar>>& X,
                                                std::vector<Wrench<Scalar>> y) {
  return solve(factor_ltdl(mass_matrix(tree, X)), inward_forces(tree, X, std::move(y)));
}

}  // namespace treeline
