#pragma once
// M^-1 by loops over a table of links: articulated bodies. C++17, freestanding.

#include "core/link_factors.hpp"
#include "core/link_matrix.hpp"

namespace treeline::core::loops {

/// u = IA S / D without its own entry, and 1 / D of a joint; D includes its rotor.
template <class Real>
struct LinkProjection {
  Spatial<Real> u;
  Real inverse_D;
};

template <class Real, size_t links, size_t slots, size_t base_entries>
struct InertiaWork {
  LinkInertia<Real> inertias[slots];
  LinkProjection<Real> projections[links];
  /// Factors of the articulated inertia of a floating base, see `factor`; else one entry.
  Real base[base_entries];
};

/// Passes the inertia in the slot of link `i` on to that of its parent. Where both share one, the
/// parent has no other yet.
template <class Table, class Real, class Motions, class Inertias>
void pass_on(const Table& table, int i, const Motions& motions, LinkInertia<Real>& inertia,
             Inertias& inertias) noexcept {
  const Link<Real>& link = table.links[i];
  if (link.parent < 0) {
    clear_inertia(inertia);
  } else {
    inertia_to_parent(table, i, motions.poses, inertia);
    const int16_t slot = table.links[link.parent].slot;
    if (slot != link.slot) {
      add_inertia(inertia, inertias.inertias[slot]);
      clear_inertia(inertia);
    }
  }
}

/// U = I S of the joint of link `i`.
template <class Table, class Real>
TREELINE_LINK_INLINE void find_column(const Table& table, int i, const LinkInertia<Real>& inertia,
                                      Spatial<Real>& U) noexcept {
  const Real(&A)[6] = inertia.A;
  const Real(&B)[9] = inertia.B;
  const Real(&C)[6] = inertia.C;
  if (slides(table, i)) {
    U.linear[0] = A[2];
    U.linear[1] = A[4];
    U.linear[2] = A[5];
    U.angular[0] = B[6];
    U.angular[1] = B[7];
    U.angular[2] = B[8];
  } else {
    U.linear[0] = B[2];
    U.linear[1] = B[5];
    U.linear[2] = B[8];
    U.angular[0] = C[2];
    U.angular[1] = C[4];
    U.angular[2] = C[5];
  }
}

/// Multiplies the row and column of the joint of link `i` by what its rotor holds.
template <class Table, class Real>
TREELINE_LINK_INLINE void hold_column(const Table& table, int i, const Real& held,
                                      LinkInertia<Real>& inertia) noexcept {
  Real(&A)[6] = inertia.A;
  Real(&B)[9] = inertia.B;
  Real(&C)[6] = inertia.C;
  if (slides(table, i)) {
    A[2] = A[2] * held;
    A[4] = A[4] * held;
    A[5] = A[5] * held;
    B[6] = B[6] * held;
    B[7] = B[7] * held;
    B[8] = B[8] * held;
  } else {
    B[2] = B[2] * held;
    B[5] = B[5] * held;
    B[8] = B[8] * held;
    C[2] = C[2] * held;
    C[4] = C[4] * held;
    C[5] = C[5] * held;
  }
}

/// M - U u^T of a symmetric M.
template <class Real>
TREELINE_LINK_INLINE void take_symmetric(const Real (&U)[3], const Real (&u)[3],
                                         Real (&M)[6]) noexcept {
  M[0] = M[0] - (U[0] * u[0]);
  M[1] = M[1] - (U[0] * u[1]);
  M[2] = M[2] - (U[0] * u[2]);
  M[3] = M[3] - (U[1] * u[1]);
  M[4] = M[4] - (U[1] * u[2]);
  M[5] = M[5] - (U[2] * u[2]);
}

template <class Real>
TREELINE_LINK_INLINE void take_square(const Real (&U)[3], const Real (&u)[3],
                                      Real (&M)[9]) noexcept {
  M[0] = M[0] - (U[0] * u[0]);
  M[1] = M[1] - (U[0] * u[1]);
  M[2] = M[2] - (U[0] * u[2]);
  M[3] = M[3] - (U[1] * u[0]);
  M[4] = M[4] - (U[1] * u[1]);
  M[5] = M[5] - (U[1] * u[2]);
  M[6] = M[6] - (U[2] * u[0]);
  M[7] = M[7] - (U[2] * u[1]);
  M[8] = M[8] - (U[2] * u[2]);
}

/// Makes IA what the joint passes on, IA - U D^-1 U^T. Of the joint's own row and column the share
/// rotor / D is left; without a rotor they are exact zeros.
template <class Table, class Real>
TREELINE_LINK_INLINE void release_joint(const Table& table, int i, LinkInertia<Real>& IA,
                                        LinkProjection<Real>& joint) noexcept {
  Spatial<Real> U;
  find_column(table, i, IA, U);
  Real& own = along_joint(table, i, U);
  const Real rotor = rotor_of(table, i);
  const Real inverse_D = Real(1.0) / (own + rotor);
  own = Real(0.0);
  Spatial<Real> u;
  scale_spatial(inverse_D, U, u);
  take_symmetric(U.linear, u.linear, IA.A);
  take_square(U.linear, u.angular, IA.B);
  take_symmetric(U.angular, u.angular, IA.C);
  hold_column(table, i, rotor * inverse_D, IA);
  joint.inverse_D = inverse_D;
  copy_spatial(u, joint.u);
}

/// Inward pass of articulated bodies: u and 1 / D of joints, factors of a floating base. Not where
/// joints share coordinates: see `factor_mass_matrix`.
template <class Table, class Motions, class Inertias, class Real = typename Table::Real>
void articulate(const Table& table, const Motions& motions, Inertias& inertias) noexcept {
  for (int k = 0; k < table.slots; ++k) {
    clear_inertia(inertias.inertias[k]);
  }
  for (int i = table.count - 1; i >= 0; --i) {
    const Link<Real>& link = table.links[i];
    LinkInertia<Real>& sum = inertias.inertias[link.slot];
    LinkInertia<Real> IA;
    copy_inertia(sum, IA);
    add_own(body_of(table, i), IA);
    if (is_floating<Table>(i)) {
      copy_to(IA, &inertias.base[0], 6);
      const Real* const none = nullptr;
      factor<0>(&inertias.base[0], 6, none);
    } else {
      release_joint(table, i, IA, inertias.projections[i]);
      copy_inertia(IA, sum);
      pass_on(table, i, motions, sum, inertias);
    }
  }
}

/// Factors of M to `base` of `inertias`, where joints share coordinates.
template <class Table, class Motions, class Inertias, class Real = typename Table::Real>
void factor_mass_matrix(const Table& table, const Motions& motions, Inertias& inertias) noexcept {
  const Real* const none = nullptr;
  find_mass_matrix(table, motions, inertias, &inertias.base[0]);
  factor<0>(&inertias.base[0], velocity_at<Table>(count_joints(table)), none);
}

/// qdd of joint forces `tau` by factors of M. On entry qdd has the forces at qdd = 0.
template <class Table, class Real, class Inertias>
void solve_accelerations(const Table& table, const Real* tau, const Inertias& inertias,
                         Real* qdd) noexcept {
  const int nv = velocity_at<Table>(count_joints(table));
  for (int k = 0; k < nv; ++k) {
    qdd[k] = tau[k] - qdd[k];
  }
  solve(&inertias.base[0], nv, qdd);
}

/// qdd of joint forces `tau` by articulated bodies, once `inertias` is articulated. On entry qdd
/// has the forces at qdd = 0. Uses `wrenches` of `motions`.
template <class Table, class Real, class Motions, class Inertias>
void find_accelerations(const Table& table, const Real* tau, Motions& motions,
                        const Inertias& inertias, Real* qdd) noexcept {
  for (int i = 0; i < table.count; ++i) {
    clear_spatial(motions.wrenches[i]);
  }
  for (int i = table.count - 1; i >= 0; --i) {
    const Link<Real>& link = table.links[i];
    const LinkProjection<Real>& joint = inertias.projections[i];
    Spatial<Real> wrench;
    copy_spatial(motions.wrenches[i], wrench);
    if (is_floating<Table>(i)) {
      for (int k = 0; k < 3; ++k) {
        qdd[k] = tau[k] - qdd[k] - wrench.linear[k];
        qdd[k + 3] = tau[k + 3] - qdd[k + 3] - wrench.angular[k];
      }
      solve(&inertias.base[0], 6, qdd);
    } else {
      const int at = velocity_at<Table>(i);
      Real& along = along_joint(table, i, wrench);
      const Real missing = tau[at] - qdd[at];
      const Real left = missing - along;
      qdd[at] = left;
      if (link.parent >= 0) {
        add_scaled(joint.u, left, wrench);
        along = missing - (rotor_of(table, i) * joint.inverse_D * left);
        wrench_to_parent(table, i, motions.poses, wrench);
        add(wrench, motions.wrenches[link.parent]);
      }
    }
  }
  for (int i = 0; i < table.count; ++i) {
    const Link<Real>& link = table.links[i];
    const LinkProjection<Real>& joint = inertias.projections[i];
    Spatial<Real> twist;  // acceleration without what velocities add
    if (is_floating<Table>(i)) {
      for (int k = 0; k < 3; ++k) {
        twist.linear[k] = qdd[k];
        twist.angular[k] = qdd[k + 3];
      }
    } else {
      const int at = velocity_at<Table>(i);
      if (link.parent < 0) {
        clear_spatial(twist);
      } else {
        copy_spatial(motions.wrenches[link.parent], twist);
        twist_to_child(table, i, motions.poses, twist);
      }
      Real& along = along_joint(table, i, twist);
      const Real held = rotor_of(table, i) * joint.inverse_D;
      qdd[at] = (joint.inverse_D * qdd[at]) - dot(joint.u.linear, twist.linear) -
                dot(joint.u.angular, twist.angular) - (along - (held * along));
      along = along + qdd[at];
    }
    copy_spatial(twist, motions.wrenches[i]);
  }
}

}  // namespace treeline::core::loops
