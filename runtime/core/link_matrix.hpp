#pragma once
// M by loops over a table of links: composite bodies in common axes, those of the root, which is
// the world or a floating base. There bodies only add up, and an entry of M is a product of six
// numbers by six, where a wrench that is carried from link to link takes several times as many
// operations. Compilers make the rows of M of vector instructions. Links are placed from where
// their limb starts: far from the root they would lose digits. C++17, freestanding.

#include "core/link_inertia.hpp"
#include "core/link_motion.hpp"

namespace treeline::core::loops {

/// Where a link is in the axes of the root: rows of the rotation from the link's axes; its origin
/// from that of its parent, and from where its limb starts.
template <class Real>
struct LinkFrame {
  Real x[3];
  Real y[3];
  Real z[3];
  Real step[3];
  Real p[3];
};

/// What M needs of each link, in the axes of the root. A body is that of a link with those that it
/// carries, about the link's origin. A wrench is what the joint needs to move them at unit
/// acceleration: the force f, and the moment n about where the limb starts. `base` has factors of M
/// where joints share coordinates, and behind them joint forces of the rows of the task; else one
/// entry.
template <class Real, size_t links, size_t base_entries>
struct MatrixWork {
  LinkFrame<Real> frames[links];
  LinkBody<Real> bodies[links];
  Real f_x[links];
  Real f_y[links];
  Real f_z[links];
  Real n_x[links];
  Real n_y[links];
  Real n_z[links];
  Real base[base_entries];
};

template <class Real>
TREELINE_LINK_INLINE void copy_vector(const Real (&from)[3], Real (&to)[3]) noexcept {
  to[0] = from[0];
  to[1] = from[1];
  to[2] = from[2];
}

/// sum += v
template <class Real>
TREELINE_LINK_INLINE void add_vector(const Real (&v)[3], Real (&sum)[3]) noexcept {
  sum[0] = sum[0] + v[0];
  sum[1] = sum[1] + v[1];
  sum[2] = sum[2] + v[2];
}

/// The frame of the root itself.
template <class Real>
void set_root(LinkFrame<Real>& frame) noexcept {
  clear(frame.x);
  clear(frame.y);
  clear(frame.z);
  clear(frame.step);
  clear(frame.p);
  frame.x[0] = Real(1.0);
  frame.y[1] = Real(1.0);
  frame.z[2] = Real(1.0);
}

/// A link's body in the axes of the root, about the link's origin. The frame is read in a copy, of
/// which a compiler knows that it is no other.
template <class Real>
TREELINE_LINK_INLINE void turn_body(const LinkBody<Real>& from, const LinkFrame<Real>& frame,
                                    LinkBody<Real>& to) noexcept {
  Real x[3];
  Real y[3];
  Real z[3];
  copy_vector(frame.x, x);
  copy_vector(frame.y, y);
  copy_vector(frame.z, z);
  to.mass = from.mass;
  to.h[0] = dot(x, from.h);
  to.h[1] = dot(y, from.h);
  to.h[2] = dot(z, from.h);
  Real row[3];  // of R J
  multiply_symmetric(from.J, x, row);
  to.J[0] = dot(row, x);
  to.J[1] = dot(row, y);
  to.J[2] = dot(row, z);
  multiply_symmetric(from.J, y, row);
  to.J[3] = dot(row, y);
  to.J[4] = dot(row, z);
  multiply_symmetric(from.J, z, row);
  to.J[5] = dot(row, z);
}

/// Adds a body, whose origin is at p of the sum's, to this. With g = h + m p the moment becomes g,
/// and J grows by (p . (h + g)) 1 - h p^T - p g^T.
template <class Real>
TREELINE_LINK_INLINE void add_shifted(const LinkBody<Real>& body, const Real (&p)[3],
                                      LinkBody<Real>& sum) noexcept {
  const Real(&h)[3] = body.h;
  const Real g[3] = {h[0] + (body.mass * p[0]), h[1] + (body.mass * p[1]),
                     h[2] + (body.mass * p[2])};
  const Real xx = p[0] * (h[0] + g[0]);
  const Real yy = p[1] * (h[1] + g[1]);
  const Real zz = p[2] * (h[2] + g[2]);
  sum.mass = sum.mass + body.mass;
  sum.h[0] = sum.h[0] + g[0];
  sum.h[1] = sum.h[1] + g[1];
  sum.h[2] = sum.h[2] + g[2];
  sum.J[0] = sum.J[0] + (body.J[0] + (yy + zz));
  sum.J[1] = sum.J[1] + (body.J[1] - ((p[0] * h[1]) + (p[1] * g[0])));
  sum.J[2] = sum.J[2] + (body.J[2] - ((p[0] * h[2]) + (p[2] * g[0])));
  sum.J[3] = sum.J[3] + (body.J[3] + (xx + zz));
  sum.J[4] = sum.J[4] + (body.J[4] - ((p[1] * h[2]) + (p[2] * g[1])));
  sum.J[5] = sum.J[5] + (body.J[5] + (xx + yy));
}

/// The frame of link `i` before it turns.
template <class Table, class Poses, class Real>
void place_frame(const Table& table, int i, const Poses& poses, const LinkFrame<Real>& parent,
                 LinkFrame<Real>& frame) noexcept {
  Real p[3];
  find_origin(table, i, poses, p);
  frame.step[0] = dot(parent.x, p);
  frame.step[1] = dot(parent.y, p);
  frame.step[2] = dot(parent.z, p);
  if (table.links[i].starts) {
    clear(frame.p);
  } else {
    copy_vector(parent.p, frame.p);
    add_vector(frame.step, frame.p);
  }
  copy_vector(parent.x, frame.x);
  copy_vector(parent.y, frame.y);
  copy_vector(parent.z, frame.z);
}

/// Frames of all links, and their bodies, each alone.
template <class Table, class Poses, class Matrices, class Real = typename Table::Real>
void place_bodies(const Table& table, const Poses& poses, Matrices& matrices) noexcept {
  for (int i = 0; i < table.count; ++i) {
    const int parent = table.links[i].parent;
    LinkFrame<Real>& frame = matrices.frames[i];
    if (parent < 0) {
      set_root(frame);
    } else {
      place_frame(table, i, poses, matrices.frames[parent], frame);
    }
    if (!is_floating<Table>(i)) {
      turn_axes_to_link(table, i, poses, frame.x, frame.y, frame.z);
    }
    turn_body(body_of(table, i), frame, matrices.bodies[i]);
  }
}

/// Adds to the bodies of links those that they carry.
template <class Table, class Matrices, class Real = typename Table::Real>
void compose_bodies(const Table& table, Matrices& matrices) noexcept {
  for (int i = table.count - 1; i > 0; --i) {
    const int parent = table.links[i].parent;
    if (parent >= 0) {
      add_shifted(matrices.bodies[i], matrices.frames[i].step, matrices.bodies[parent]);
    }
  }
}

/// The wrenches that joints need.
template <class Table, class Matrices, class Real = typename Table::Real>
void find_joint_wrenches(const Table& table, Matrices& matrices) noexcept {
  for (int i = 0; i < table.count; ++i) {
    const LinkFrame<Real>& frame = matrices.frames[i];
    const LinkBody<Real>& body = matrices.bodies[i];
    const Real axis[3] = {frame.x[2], frame.y[2], frame.z[2]};
    Real f[3];
    Real n[3];
    if (slides(table, i)) {
      f[0] = body.mass * axis[0];
      f[1] = body.mass * axis[1];
      f[2] = body.mass * axis[2];
      find_cross(body.h, axis, n);
    } else {
      find_cross(axis, body.h, f);
      multiply_symmetric(body.J, axis, n);
    }
    add_cross(frame.p, f, n);
    matrices.f_x[i] = f[0];
    matrices.f_y[i] = f[1];
    matrices.f_z[i] = f[2];
    matrices.n_x[i] = n[0];
    matrices.n_y[i] = n[1];
    matrices.n_z[i] = n[2];
  }
}

/// The twist of a joint at unit rate, about where its limb starts.
template <class Table, class Real>
void find_joint_twist(const Table& table, int i, const LinkFrame<Real>& frame,
                      Spatial<Real>& twist) noexcept {
  const Real axis[3] = {frame.x[2], frame.y[2], frame.z[2]};
  if (slides(table, i)) {
    copy_vector(axis, twist.linear);
    clear(twist.angular);
  } else {
    find_cross(frame.p, axis, twist.linear);
    copy_vector(axis, twist.angular);
  }
}

/// The force along a joint, by its twist, that joint `j` needs.
template <class Real, class Matrices>
TREELINE_LINK_INLINE Real find_force(const Spatial<Real>& twist, const Matrices& matrices,
                                     int j) noexcept {
  return ((twist.angular[0] * matrices.n_x[j]) + (twist.angular[1] * matrices.n_y[j]) +
          (twist.angular[2] * matrices.n_z[j])) +
         ((twist.linear[0] * matrices.f_x[j]) + (twist.linear[1] * matrices.f_y[j]) +
          (twist.linear[2] * matrices.f_z[j]));
}

/// The row of the joint of link `i` in M from the diagonal on. Where joints share coordinates it
/// adds to M, and to the column as well.
template <class Table, class Real, class Matrices>
void find_joint_row(const Table& table, int i, const Matrices& matrices, Real* M) noexcept {
  const int nv = velocity_at<Table>(count_joints(table));
  const int at = velocity_at<Table>(joint_of(table, i));
  const int end = table.links[i].end;
  Spatial<Real> twist;
  find_joint_twist(table, i, matrices.frames[i], twist);
  if constexpr (Table::kCoupled) {
    for (int j = i; j < end; ++j) {
      const Real force = scale(table, i, scale(table, j, find_force(twist, matrices, j)));
      const int other = velocity_at<Table>(joint_of(table, j));
      M[(at * nv) + other] = M[(at * nv) + other] + force;
      if (j > i) {
        M[(other * nv) + at] = M[(other * nv) + at] + force;
      }
    }
  } else {
    Real* const row = &M[(at * nv) + (at - i)];
    for (int j = i; j < end; ++j) {
      row[j] = find_force(twist, matrices, j);
    }
  }
  M[(at * nv) + at] = M[(at * nv) + at] + rotor_of(table, i);
}

/// The rows of a floating base in M: its own inertia, and what joints take of it.
template <class Table, class Real, class Matrices>
void find_base_rows(const Table& table, const Matrices& matrices, Real* M) noexcept {
  const int nv = velocity_at<Table>(count_joints(table));
  LinkInertia<Real> inertia;
  clear_inertia(inertia);
  add_own(matrices.bodies[0], inertia);
  copy_to(inertia, M, nv);
  for (int j = 1; j < table.count; ++j) {
    const Real wrench[6] = {matrices.f_x[j], matrices.f_y[j], matrices.f_z[j],
                            matrices.n_x[j], matrices.n_y[j], matrices.n_z[j]};
    const int at = velocity_at<Table>(joint_of(table, j));
    for (int k = 0; k < 6; ++k) {
      const Real force = scale(table, j, wrench[k]);
      enter<Table>(force, M[(k * nv) + at]);
      enter<Table>(force, M[(at * nv) + k]);
    }
  }
}

/// Makes moments of what the limb that link `i` starts carries those about where the limb before
/// it starts.
template <class Table, class Matrices, class Real = typename Table::Real>
void move_moments(const Table& table, int i, Matrices& matrices) noexcept {
  Real p[3];
  copy_vector(matrices.frames[table.links[i].parent].p, p);
  add_vector(matrices.frames[i].step, p);
  const int end = table.links[i].end;
  for (int j = i; j < end; ++j) {
    const Real f[3] = {matrices.f_x[j], matrices.f_y[j], matrices.f_z[j]};
    matrices.n_x[j] = matrices.n_x[j] + ((p[1] * f[2]) - (p[2] * f[1]));
    matrices.n_y[j] = matrices.n_y[j] + ((p[2] * f[0]) - (p[0] * f[2]));
    matrices.n_z[j] = matrices.n_z[j] + ((p[0] * f[1]) - (p[1] * f[0]));
  }
}

/// Copies the upper triangle of M to the lower, unless that is done.
template <class Table, class Real>
void mirror(const Table& table, Real* M) noexcept {
  if constexpr (Table::kCoupled) {
    static_cast<void>(table);
    static_cast<void>(M);
  } else {
    const int nv = velocity_at<Table>(count_joints(table));
    for (int k = 1; k < nv; ++k) {
      for (int l = 0; l < k; ++l) {
        M[(k * nv) + l] = M[(l * nv) + k];
      }
    }
  }
}

/// M by composite bodies. Uses `matrices` alone.
template <class Table, class Real, class Motions, class Matrices>
void find_mass_matrix(const Table& table, const Motions& motions, Matrices& matrices,
                      Real* M) noexcept {
  const int nv = velocity_at<Table>(count_joints(table));
  for (int k = 0; k < (nv * nv); ++k) {
    M[k] = Real(0.0);
  }
  place_bodies(table, motions.poses, matrices);
  compose_bodies(table, matrices);
  find_joint_wrenches(table, matrices);
  for (int i = table.count - 1; i >= 0; --i) {
    if (is_floating<Table>(i)) {
      find_base_rows(table, matrices, M);
    } else {
      find_joint_row(table, i, matrices, M);
      if (table.links[i].starts && (table.links[i].parent >= 0)) {
        move_moments(table, i, matrices);
      }
    }
  }
  mirror(table, M);
}

}  // namespace treeline::core::loops
