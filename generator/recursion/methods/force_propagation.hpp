#pragma once

#include <map>
#include <utility>
#include <vector>

#include "recursion/methods/articulated_inertia.hpp"
#include "recursion/methods/lambda_inverse.hpp"

namespace treeline {

/// Motion of a link: acceleration of its origin and angular acceleration, in its axes.
template <class Scalar>
struct Twist {
  Vector3<Scalar> v, w;
};
template <class Scalar>
Scalar dot(const Wrench<Scalar>& wrench, const Twist<Scalar>& twist) {
  return dot(wrench.f, twist.v) + dot(wrench.n, twist.w);
}
template <class Scalar>
Twist<Scalar> to_child(const JointTransform<Scalar>& X, const Twist<Scalar>& twist) {
  return {X.to_child(twist.v + cross(twist.w, X.p)), X.to_child(twist.w)};
}

/// Inverse operational-space inertia of a link, Omega = [A B; B^T C]: the acceleration of its frame
/// per force there, v = A f + B n, w = B^T f + C n.
template <class Scalar>
struct Mobility {
  Symmetric3<Scalar> A;
  Matrix3<Scalar> B;
  Symmetric3<Scalar> C;

  [[nodiscard]] Twist<Scalar> operator*(const Wrench<Scalar>& wrench) const {
    return {A * wrench.f + B * wrench.n, transposed_times(B, wrench.f) + C * wrench.n};
  }
};

/// X^T Omega X, the parent's Omega at the link's origin, in the link's axes. Motions transform like
/// forces with linear and angular parts exchanged, in the opposite direction.
template <class Scalar>
Mobility<Scalar> to_child(const JointTransform<Scalar>& X, const Mobility<Scalar>& Omega) {
  const auto [C, Bt, A] = shifted<Scalar>({Omega.C, transposed(Omega.B), Omega.A}, -X.p);
  return {X.matrix_to_child(A), X.matrix_to_child(transposed(Bt)), X.matrix_to_child(C)};
}

/// Omega = L^T N L + S D^-1 S^T of the link beyond a joint, with N = X^T Omega_h X. Only the
/// joint's own row and column n change. With u = U D^-1 without its own entry, which is 1 - held,
/// they become held n - N u and D^-1 + u^T N u + held (held n - 2 N u); without a rotor the entries
/// that N had there drop out.
template <class Scalar>
Mobility<Scalar> through_joint(JointKind kind, const JointProjection<Scalar>& joint,
                               Mobility<Scalar> N) {
  Wrench<Scalar> u = joint.u;
  along_axis(kind, u.f, u.n) = Scalar(0.0);
  const Twist<Scalar> Nu = N * u;
  const auto change = [&held = joint.held](Scalar& entry, const Scalar& moved) {
    entry = held * entry - moved;
  };
  const auto change_own = [&](Scalar& entry, const Scalar& moved) {
    entry = joint.inverse_D + dot(u, Nu) + joint.held * (joint.held * entry - Scalar(2.0) * moved);
  };
  switch (kind) {
    case JointKind::revolute:
      change(N.B.row_x.z, Nu.v.x);
      change(N.B.row_y.z, Nu.v.y);
      change(N.B.row_z.z, Nu.v.z);
      change(N.C.xz, Nu.w.x);
      change(N.C.yz, Nu.w.y);
      change_own(N.C.zz, Nu.w.z);
      break;
    case JointKind::prismatic:
      change(N.A.xz, Nu.v.x);
      change(N.A.yz, Nu.v.y);
      change_own(N.A.zz, Nu.v.z);
      change(N.B.row_z.x, Nu.w.x);
      change(N.B.row_z.y, Nu.w.y);
      change(N.B.row_z.z, Nu.w.z);
      break;
    case JointKind::floating:  // has an Omega of its own, see `propagate_mobilities`
      break;
  }
  return N;
}

template <class Scalar>
Mobility<Scalar> mobility(const LdltFactor<Scalar>& IA) {
  const DenseMatrix<Scalar> O = inverse(IA);
  return {{O(0, 0), O(0, 1), O(0, 2), O(1, 1), O(1, 2), O(2, 2)},
          {{O(0, 3), O(0, 4), O(0, 5)}, {O(1, 3), O(1, 4), O(1, 5)}, {O(2, 3), O(2, 4), O(2, 5)}},
          {O(3, 3), O(3, 4), O(3, 5), O(4, 4), O(4, 5), O(5, 5)}};
}

/// Omega of the links that carry a point, by an outward recursion (Chang table 5.2). It is zero at
/// a fixed base, and IA^-1 behind a floating joint.
template <class Scalar>
std::vector<Mobility<Scalar>> propagate_mobilities(const Tree<Scalar>& tree,
                                                   const std::vector<JointTransform<Scalar>>& X,
                                                   const ArticulatedTree<Scalar>& bodies,
                                                   const std::vector<TaskPoint<Scalar>>& tasks) {
  const std::size_t n = tree.links.size();
  std::vector<bool> carries(n);
  for (const TaskPoint<Scalar>& task : tasks) {
    for (int i = task.link; i >= 0; i = tree.links[static_cast<std::size_t>(i)].parent) {
      carries[static_cast<std::size_t>(i)] = true;
    }
  }
  std::vector<Mobility<Scalar>> Omega(n);
  for (std::size_t i = 0; i < n; ++i) {
    const TreeLink<Scalar>& link = tree.links[i];
    if (!carries[i]) {
      continue;
    }
    section(link, i, "mobility");
    if (link.is_floating()) {
      Omega[i] = mobility(bodies.floating[i]);
      continue;
    }
    const Mobility<Scalar> N = link.parent < 0
                                   ? Mobility<Scalar>{}
                                   : to_child(X[i], Omega[static_cast<std::size_t>(link.parent)]);
    Omega[i] = through_joint(link.kind, bodies.joints[i], N);
  }
  return Omega;
}

/// Outermost link that carries both links, or -1.
template <class Scalar>
int nearest_common_ancestor(const Tree<Scalar>& tree, int i, int j) {
  while (i != j) {
    int& outer = i > j ? i : j;
    outer = tree.links[static_cast<std::size_t>(outer)].parent;
  }
  return i;
}

/// Acceleration of a link farther out that results from an acceleration of link `h` with free
/// joints: L_(h->link)^T times the twist, joint by joint.
template <class Scalar>
Twist<Scalar> propagated_outward(const Tree<Scalar>& tree,
                                 const std::vector<JointTransform<Scalar>>& X,
                                 const ArticulatedTree<Scalar>& bodies, int h, int link,
                                 const Twist<Scalar>& twist) {
  if (link == h) {
    return twist;
  }
  const auto i = static_cast<std::size_t>(link);
  const TreeLink<Scalar>& outer = tree.links[i];
  if (outer.is_floating()) {
    return {};
  }
  Twist<Scalar> moved = to_child(X[i], propagated_outward(tree, X, bodies, h, outer.parent, twist));
  Scalar& own = along_axis(outer.kind, moved.v, moved.w);
  own = own - dot(bodies.joints[i].u, moved);
  return moved;
}

/// A row of a point with its unit force. Rows are in the order of Lambda^-1.
template <class Scalar>
struct LinkRow {
  int link;
  Wrench<Scalar> K;
};
template <class Scalar>
std::vector<LinkRow<Scalar>> link_rows(const std::vector<TaskPoint<Scalar>>& tasks) {
  std::vector<LinkRow<Scalar>> rows;
  for (const TaskPoint<Scalar>& task : tasks) {
    for (const TaskRow<Scalar>& row : task.rows) {
      rows.push_back({task.link, unit_wrench(task, row)});
    }
  }
  return rows;
}

/// Omega_ij = L_(h->i)^T Omega_hh L_(h->j), 6x6: the acceleration of link i per force on link j. h
/// is their nearest common ancestor. Each factor is applied joint by joint.
template <class Scalar>
DenseMatrix<Scalar> coupling_mobility(const Tree<Scalar>& tree,
                                      const std::vector<JointTransform<Scalar>>& X,
                                      const ArticulatedTree<Scalar>& bodies,
                                      const std::vector<Mobility<Scalar>>& Omega, int i, int j) {
  DenseMatrix<Scalar> coupling(6, 6);
  const int h = nearest_common_ancestor(tree, i, j);
  if (h < 0) {
    return coupling;
  }
  const auto set = [](const Twist<Scalar>& twist, auto entry) {
    const Scalar parts[6] = {twist.v.x, twist.v.y, twist.v.z, twist.w.x, twist.w.y, twist.w.z};
    for (std::size_t k = 0; k < 6; ++k) {
      entry(k) = parts[k];
    }
  };
  const Matrix3<Scalar> one = identity3<Scalar>();
  const Vector3<Scalar> e[3] = {one.row_x, one.row_y, one.row_z};
  for (std::size_t c = 0; c < 6; ++c) {  // columns: accelerations of i
    const Wrench<Scalar> unit = c < 3 ? Wrench<Scalar>{e[c], {}} : Wrench<Scalar>{{}, e[c - 3]};
    const Twist<Scalar> at_h = Omega[static_cast<std::size_t>(h)] * unit;
    set(propagated_outward(tree, X, bodies, h, i, at_h),
        [&](std::size_t r) -> Scalar& { return coupling(r, c); });
  }
  for (std::size_t r = 0; r < 6; ++r) {  // rows: accelerations of h, then of j
    const Twist<Scalar> at_h{{coupling(r, 0), coupling(r, 1), coupling(r, 2)},
                             {coupling(r, 3), coupling(r, 4), coupling(r, 5)}};
    set(propagated_outward(tree, X, bodies, h, j, at_h),
        [&](std::size_t c) -> Scalar& { return coupling(r, c); });
  }
  return coupling;
}

/// Lambda^-1 by force propagation with branching (Chang tables 5.2, 5.3): its entries are K_r^T
/// Omega_ij K_s for the unit forces K of rows r and s.
template <class Scalar>
DenseMatrix<Scalar> lambda_inverse_by_branching(const Tree<Scalar>& tree,
                                                const std::vector<JointTransform<Scalar>>& X,
                                                const std::vector<TaskPoint<Scalar>>& tasks) {
  const ArticulatedTree<Scalar> bodies = articulate(tree, X);
  const auto Omega = propagate_mobilities(tree, X, bodies, tasks);
  const auto rows = link_rows(tasks);
  DenseMatrix<Scalar> Lambda_inv(rows.size(), rows.size());
  std::map<std::pair<int, int>, DenseMatrix<Scalar>> couplings;
  const auto moved_by = [&](int i, int j, const Wrench<Scalar>& K) {  // Omega_ij K
    if (i == j) {
      return Omega[static_cast<std::size_t>(i)] * K;
    }
    const auto [at, made] = couplings.try_emplace({i, j});
    if (made) {
      at->second = coupling_mobility(tree, X, bodies, Omega, i, j);
    }
    const DenseMatrix<Scalar>& O = at->second;
    const auto row = [&](std::size_t r) {
      return O(r, 0) * K.f.x + O(r, 1) * K.f.y + O(r, 2) * K.f.z + O(r, 3) * K.n.x +
             O(r, 4) * K.n.y + O(r, 5) * K.n.z;
    };
    return Twist<Scalar>{{row(0), row(1), row(2)}, {row(3), row(4), row(5)}};
  };
  for (std::size_t s = 0; s < rows.size(); ++s) {
    for (std::size_t r = s; r < rows.size(); ++r) {
      if (rows[r].link >= 0 && rows[s].link >= 0) {
        Lambda_inv(r, s) = Lambda_inv(s, r) =
            dot(rows[r].K, moved_by(rows[r].link, rows[s].link, rows[s].K));
      }
    }
  }
  return Lambda_inv;
}

}  // namespace treeline
