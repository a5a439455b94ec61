#pragma once
// M, M^-1 and Lambda^-1 by loops over a table of links: composite and articulated bodies, unit
// forces propagated inward. C++17, freestanding.

#include "core/link_factors.hpp"
#include "core/link_motion.hpp"

namespace treeline::core::loops {

/// Inertia of bodies at a link's frame, [A B; B^T C]: f = A a + B wd, n = B^T a + C wd. All three
/// are row-major 3x3, A and C symmetric.
template <class Real>
struct LinkInertia {
  Real A[9];
  Real B[9];
  Real C[9];
};

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
  /// Factors of the articulated inertia of a floating base, see `factor`; else one entry. Where
  /// joints share coordinates, those of M, and joint forces of the rows of the task behind them.
  Real base[base_entries];
};

/// R M R^T for the rotation in the plane of the axes i and j.
template <class Real>
void turn_matrix(const Turn<Real>& r, int i, int j, Real (&M)[9]) noexcept {
  const int k = 3 - i - j;
  Real& a = M[4 * i];
  Real& b = M[(3 * i) + j];
  Real& b2 = M[(3 * j) + i];
  Real& d = M[4 * j];
  const Real t = (r.s * (a - d)) + (r.c * (b + b2));
  const Real st = r.s * t;
  const Real ct = r.c * t;
  const Real old = b;
  a = a - st;
  d = d + st;
  b = ct - b2;
  b2 = ct - old;
  turn_plane(r, M[(3 * i) + k], M[(3 * j) + k]);
  turn_plane(r, M[(3 * k) + i], M[(3 * k) + j]);
}

/// Moves an inertia from the origin of its frame to where that has origin p: B becomes
/// H = B - A [p]x and C gains [p]x H - B^T [p]x.
template <class Real>
void shift_inertia(const Real (&p)[3], LinkInertia<Real>& inertia) noexcept {
  Real(&A)[9] = inertia.A;
  Real(&B)[9] = inertia.B;
  Real(&C)[9] = inertia.C;
  for (int r = 0; r < 3; ++r) {
    const int s = (r + 1) % 3;
    const int t = (r + 2) % 3;
    for (int k = 0; k < 3; ++k) {
      C[(3 * k) + r] = C[(3 * k) + r] - ((B[(3 * s) + k] * p[t]) - (B[(3 * t) + k] * p[s]));
    }
  }
  for (int r = 0; r < 3; ++r) {
    const int s = (r + 1) % 3;
    const int t = (r + 2) % 3;
    for (int k = 0; k < 3; ++k) {
      B[(3 * k) + r] = B[(3 * k) + r] - ((A[(3 * k) + s] * p[t]) - (A[(3 * k) + t] * p[s]));
    }
  }
  for (int r = 0; r < 3; ++r) {
    const int s = (r + 1) % 3;
    const int t = (r + 2) % 3;
    for (int k = 0; k < 3; ++k) {
      C[(3 * r) + k] = C[(3 * r) + k] + ((p[s] * B[(3 * t) + k]) - (p[t] * B[(3 * s) + k]));
    }
  }
}

template <class Real>
void turn_matrix_by_planes(const Link<Real>& link, const LinkPose<Real>& pose,
                           Real (&M)[9]) noexcept {
  turn_matrix(pose.turn, 0, 1, M);
  turn_matrix(link.alpha, 1, 2, M);
  turn_matrix(link.a, 0, 1, M);
}

/// Q M Q^T
template <class Real>
void turn_matrix_by(const LinkRotation<Real>& rotation, Real (&M)[9]) noexcept {
  for (int k = 0; k < 3; ++k) {
    Real column[3] = {M[k], M[3 + k], M[6 + k]};
    turn_by(rotation, column);
    for (int l = 0; l < 3; ++l) {
      M[(3 * l) + k] = column[l];
    }
  }
  for (int k = 0; k < 3; ++k) {
    Real row[3] = {M[3 * k], M[(3 * k) + 1], M[(3 * k) + 2]};
    turn_by(rotation, row);
    for (int l = 0; l < 3; ++l) {
      M[(3 * k) + l] = row[l];
    }
  }
}

/// A matrix in the axes of the link's parent.
template <class Table, class Poses, class Real>
void matrix_to_parent(const Table& table, int i, const Poses& poses, Real (&M)[9]) noexcept {
  if constexpr (Table::kBalls) {
    if (ball_axis(table, i) == 1) {
      turn_matrix_by(poses.rotations[table.ball_axes[i].rotation], M);
    } else {
      turn_matrix_by_planes(table.links[i], poses.joints[i], M);
    }
  } else {
    turn_matrix_by_planes(table.links[i], poses.joints[i], M);
  }
}

/// Makes the inertia that link `i` passes on one of its parent.
template <class Table, class Poses, class Real>
void inertia_to_parent(const Table& table, int i, const Poses& poses,
                       LinkInertia<Real>& inertia) noexcept {
  Real p[3];
  find_origin(table, i, poses, p);
  matrix_to_parent(table, i, poses, inertia.A);
  matrix_to_parent(table, i, poses, inertia.B);
  matrix_to_parent(table, i, poses, inertia.C);
  shift_inertia(p, inertia);
}

/// Inertia of a link alone, added to that of the links that it carries.
template <class Real>
void add_own(const LinkBody<Real>& body, LinkInertia<Real>& sum) noexcept {
  const Real(&J)[6] = body.J;
  const Real rows[9] = {J[0], J[1], J[2], J[1], J[3], J[4], J[2], J[4], J[5]};
  for (int k = 0; k < 9; ++k) {
    sum.C[k] = sum.C[k] + rows[k];
  }
  for (int k = 0; k < 3; ++k) {  // B = -[h]x
    sum.A[4 * k] = sum.A[4 * k] + body.mass;
    const int l = (k + 1) % 3;
    const int m = (k + 2) % 3;
    sum.B[(3 * k) + l] = sum.B[(3 * k) + l] + body.h[m];
    sum.B[(3 * l) + k] = sum.B[(3 * l) + k] - body.h[m];
  }
}

template <class Real>
void clear_inertia(LinkInertia<Real>& inertia) noexcept {
  for (int k = 0; k < 9; ++k) {
    inertia.A[k] = Real(0.0);
    inertia.B[k] = Real(0.0);
    inertia.C[k] = Real(0.0);
  }
}

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
      LinkInertia<Real>& parent = inertias.inertias[slot];
      for (int k = 0; k < 9; ++k) {
        parent.A[k] = parent.A[k] + inertia.A[k];
        parent.B[k] = parent.B[k] + inertia.B[k];
        parent.C[k] = parent.C[k] + inertia.C[k];
      }
      clear_inertia(inertia);
    }
  }
}

/// U = I S of the joint of link `i`.
template <class Table, class Real>
void find_column(const Table& table, int i, const LinkInertia<Real>& inertia,
                 Spatial<Real>& U) noexcept {
  const bool along = slides(table, i);
  for (int k = 0; k < 3; ++k) {
    U.linear[k] = along ? inertia.A[(3 * k) + 2] : inertia.B[(3 * k) + 2];
    U.angular[k] = along ? inertia.B[6 + k] : inertia.C[(3 * k) + 2];
  }
}

/// The inertia as the first rows and columns of a row-major matrix of `columns` columns.
template <class Real>
void copy_to(const LinkInertia<Real>& inertia, Real* matrix, int columns) noexcept {
  for (int k = 0; k < 3; ++k) {
    for (int l = 0; l < 3; ++l) {
      matrix[(k * columns) + l] = inertia.A[(3 * k) + l];
      matrix[(k * columns) + l + 3] = inertia.B[(3 * k) + l];
      matrix[((k + 3) * columns) + l] = inertia.B[(3 * l) + k];
      matrix[((k + 3) * columns) + l + 3] = inertia.C[(3 * k) + l];
    }
  }
}

/// Makes IA what the joint passes on, IA - U D^-1 U^T. Of the joint's own row and column the share
/// rotor / D is left; without a rotor they are exact zeros.
template <class Table, class Real>
void release_joint(const Table& table, int i, LinkInertia<Real>& IA,
                   LinkProjection<Real>& joint) noexcept {
  Spatial<Real> U;
  find_column(table, i, IA, U);
  Real& own = along_joint(table, i, U);
  const Real rotor = rotor_of(table, i);
  joint.inverse_D = Real(1.0) / (own + rotor);
  own = Real(0.0);
  const Real held = rotor * joint.inverse_D;
  const bool along = slides(table, i);
  for (int k = 0; k < 3; ++k) {
    joint.u.linear[k] = U.linear[k] * joint.inverse_D;
    joint.u.angular[k] = U.angular[k] * joint.inverse_D;
  }
  for (int k = 0; k < 3; ++k) {
    for (int l = 0; l < 3; ++l) {
      IA.A[(3 * k) + l] = IA.A[(3 * k) + l] - (U.linear[k] * joint.u.linear[l]);
      IA.B[(3 * k) + l] = IA.B[(3 * k) + l] - (U.linear[k] * joint.u.angular[l]);
      IA.C[(3 * k) + l] = IA.C[(3 * k) + l] - (U.angular[k] * joint.u.angular[l]);
    }
  }
  Real(&own_rows)[9] = along ? IA.A : IA.C;
  for (int k = 0; k < 3; ++k) {
    int at = (3 * k) + 2;
    if (along) {
      at = 6 + k;
    }
    IA.B[at] = IA.B[at] * held;
    Real& column = own_rows[(3 * k) + 2];
    column = column * held;
    own_rows[6 + k] = column;
  }
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
    LinkInertia<Real>& IA = inertias.inertias[link.slot];
    add_own(body_of(table, i), IA);
    if (is_floating<Table>(i)) {
      copy_to(IA, &inertias.base[0], 6);
      const Real* const none = nullptr;
      factor<0>(&inertias.base[0], 6, none);
    } else {
      release_joint(table, i, IA, inertias.projections[i]);
      pass_on(table, i, motions, IA, inertias);
    }
  }
}

/// M by composite bodies. Uses `inertias.inertias` alone.
template <class Table, class Real, class Motions, class Inertias>
void find_mass_matrix(const Table& table, const Motions& motions, Inertias& inertias,
                      Real* M) noexcept {
  const int nv = velocity_at<Table>(count_joints(table));
  for (int k = 0; k < (nv * nv); ++k) {
    M[k] = Real(0.0);
  }
  for (int k = 0; k < table.slots; ++k) {
    clear_inertia(inertias.inertias[k]);
  }
  for (int i = table.count - 1; i >= 0; --i) {
    const Link<Real>& link = table.links[i];
    LinkInertia<Real>& inertia = inertias.inertias[link.slot];
    add_own(body_of(table, i), inertia);
    if (is_floating<Table>(i)) {
      copy_to(inertia, M, nv);
    } else {
      const int at = velocity_at<Table>(joint_of(table, i));
      Spatial<Real> wrench;
      find_column(table, i, inertia, wrench);
      const Real own = scale(table, i, scale(table, i, along_joint(table, i, wrench)));
      enter<Table>(own + rotor_of(table, i), M[(at * nv) + at]);
      int j = i;
      while (table.links[j].parent >= 0) {
        wrench_to_parent(table, j, motions.poses, wrench);
        j = table.links[j].parent;
        const int entries = is_floating<Table>(j) ? 6 : 1;
        for (int k = 0; k < entries; ++k) {
          Real force = along_joint(table, j, wrench);
          if (entries == 6) {
            force = (k < 3) ? wrench.linear[k] : wrench.angular[k - 3];
          }
          force = scale(table, i, scale(table, j, force));
          const int other = velocity_at<Table>(joint_of(table, j)) + k;
          enter<Table>(force, M[(at * nv) + other]);
          enter<Table>(force, M[(other * nv) + at]);
        }
      }
      pass_on(table, i, motions, inertia, inertias);
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
    Spatial<Real>& wrench = motions.wrenches[i];
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
        for (int k = 0; k < 3; ++k) {
          wrench.linear[k] = wrench.linear[k] + (joint.u.linear[k] * left);
          wrench.angular[k] = wrench.angular[k] + (joint.u.angular[k] * left);
        }
        along = missing - (rotor_of(table, i) * joint.inverse_D * left);
        wrench_to_parent(table, i, motions.poses, wrench);
        add(wrench, motions.wrenches[link.parent]);
      }
    }
  }
  for (int i = 0; i < table.count; ++i) {
    const Link<Real>& link = table.links[i];
    const LinkProjection<Real>& joint = inertias.projections[i];
    Spatial<Real>& twist = motions.wrenches[i];  // acceleration without what velocities add
    if (is_floating<Table>(i)) {
      for (int k = 0; k < 3; ++k) {
        twist.linear[k] = qdd[k];
        twist.angular[k] = qdd[k + 3];
      }
    } else {
      const int at = velocity_at<Table>(i);
      clear_spatial(twist);
      if (link.parent >= 0) {
        add(motions.wrenches[link.parent], twist);
        Real p[3];
        find_origin(table, i, motions.poses, p);
        add_cross(twist.angular, p, twist.linear);
        turn_to_child(table, i, motions.poses, twist.linear);
        turn_to_child(table, i, motions.poses, twist.angular);
      }
      Real& along = along_joint(table, i, twist);
      const Real held = rotor_of(table, i) * joint.inverse_D;
      qdd[at] = (joint.inverse_D * qdd[at]) - dot(joint.u.linear, twist.linear) -
                dot(joint.u.angular, twist.angular) - (along - (held * along));
      along = along + qdd[at];
    }
  }
}

}  // namespace treeline::core::loops
