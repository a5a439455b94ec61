#pragma once
// Inertia of bodies at a link's frame: turned, moved and added. C++17, freestanding.

#include "core/link_pose.hpp"

namespace treeline::core::loops {

/// Inertia of bodies at a link's frame, [A B; B^T C]: f = A a + B wd, n = B^T a + C wd. A and C are
/// symmetric, with entries xx xy xz yy yz zz, B is row-major 3x3. What is done with all of these is
/// written in straight lines, of which compilers keep much in registers.
template <class Real>
struct LinkInertia {
  Real A[6];
  Real B[9];
  Real C[6];
};

/// R M R^T for a rotation in the plane of two axes, of a symmetric M: its entries of the plane, and
/// those of the plane's axes with the third.
template <class Real>
TREELINE_LINK_INLINE void turn_symmetric(const Turn<Real>& r, Real& xx, Real& xy, Real& yy,
                                         Real& xz, Real& yz) noexcept {
  const Real t = (r.s * (xx - yy)) + (r.c * (xy + xy));
  const Real st = r.s * t;
  xx = xx - st;
  yy = yy + st;
  xy = (r.c * t) - xy;
  turn_plane(r, xz, yz);
}

/// R M R^T for a rotation in the plane of two axes, of any M.
template <class Real>
TREELINE_LINK_INLINE void turn_square(const Turn<Real>& r, Real& xx, Real& xy, Real& yx, Real& yy,
                                      Real& xz, Real& yz, Real& zx, Real& zy) noexcept {
  const Real t = (r.s * (xx - yy)) + (r.c * (xy + yx));
  const Real st = r.s * t;
  const Real ct = r.c * t;
  const Real old = xy;
  xx = xx - st;
  yy = yy + st;
  xy = ct - yx;
  yx = ct - old;
  turn_plane(r, xz, yz);
  turn_plane(r, zx, zy);
}

template <class Real>
TREELINE_LINK_INLINE void turn_about_z(const Turn<Real>& r, LinkInertia<Real>& inertia) noexcept {
  Real(&A)[6] = inertia.A;
  Real(&B)[9] = inertia.B;
  Real(&C)[6] = inertia.C;
  turn_symmetric(r, A[0], A[1], A[3], A[2], A[4]);
  turn_square(r, B[0], B[1], B[3], B[4], B[2], B[5], B[6], B[7]);
  turn_symmetric(r, C[0], C[1], C[3], C[2], C[4]);
}

template <class Real>
TREELINE_LINK_INLINE void turn_about_x(const Turn<Real>& r, LinkInertia<Real>& inertia) noexcept {
  Real(&A)[6] = inertia.A;
  Real(&B)[9] = inertia.B;
  Real(&C)[6] = inertia.C;
  turn_symmetric(r, A[3], A[4], A[5], A[1], A[2]);
  turn_square(r, B[4], B[5], B[7], B[8], B[3], B[6], B[1], B[2]);
  turn_symmetric(r, C[3], C[4], C[5], C[1], C[2]);
}

/// The rows of B - A [p]x.
template <class Real>
TREELINE_LINK_INLINE void shift_moments(const Real (&p)[3], const Real (&A)[6],
                                        Real (&B)[9]) noexcept {
  B[0] = B[0] - ((A[1] * p[2]) - (A[2] * p[1]));
  B[1] = B[1] - ((A[2] * p[0]) - (A[0] * p[2]));
  B[2] = B[2] - ((A[0] * p[1]) - (A[1] * p[0]));
  B[3] = B[3] - ((A[3] * p[2]) - (A[4] * p[1]));
  B[4] = B[4] - ((A[4] * p[0]) - (A[1] * p[2]));
  B[5] = B[5] - ((A[1] * p[1]) - (A[3] * p[0]));
  B[6] = B[6] - ((A[4] * p[2]) - (A[5] * p[1]));
  B[7] = B[7] - ((A[5] * p[0]) - (A[2] * p[2]));
  B[8] = B[8] - ((A[2] * p[1]) - (A[4] * p[0]));
}

/// Moves an inertia from the origin of its frame to where that has origin p: B becomes
/// H = B - A [p]x and C gains [p]x H - B^T [p]x.
template <class Real>
TREELINE_LINK_INLINE void shift_inertia(const Real (&p)[3], LinkInertia<Real>& inertia) noexcept {
  Real(&B)[9] = inertia.B;
  Real(&C)[6] = inertia.C;
  C[0] = C[0] - ((B[3] * p[2]) - (B[6] * p[1]));
  C[1] = C[1] - ((B[6] * p[0]) - (B[0] * p[2]));
  C[2] = C[2] - ((B[0] * p[1]) - (B[3] * p[0]));
  C[3] = C[3] - ((B[7] * p[0]) - (B[1] * p[2]));
  C[4] = C[4] - ((B[1] * p[1]) - (B[4] * p[0]));
  C[5] = C[5] - ((B[2] * p[1]) - (B[5] * p[0]));
  shift_moments(p, inertia.A, B);
  C[0] = C[0] + ((p[1] * B[6]) - (p[2] * B[3]));
  C[1] = C[1] + ((p[1] * B[7]) - (p[2] * B[4]));
  C[2] = C[2] + ((p[1] * B[8]) - (p[2] * B[5]));
  C[3] = C[3] + ((p[2] * B[1]) - (p[0] * B[7]));
  C[4] = C[4] + ((p[2] * B[2]) - (p[0] * B[8]));
  C[5] = C[5] + ((p[0] * B[5]) - (p[1] * B[2]));
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

template <class Real>
void turn_symmetric_by(const LinkRotation<Real>& rotation, Real (&M)[6]) noexcept {
  Real full[9] = {M[0], M[1], M[2], M[1], M[3], M[4], M[2], M[4], M[5]};
  turn_matrix_by(rotation, full);
  for (int k = 0; k < 3; ++k) {
    M[k] = full[k];
  }
  M[3] = full[4];
  M[4] = full[5];
  M[5] = full[8];
}

/// Makes the inertia that link `i` passes on one of its parent.
template <class Table, class Poses, class Real>
void inertia_to_parent(const Table& table, int i, const Poses& poses,
                       LinkInertia<Real>& inertia) noexcept {
  Real p[3];
  find_origin(table, i, poses, p);
  if (turns_freely(table, i)) {
    const LinkRotation<Real>& rotation = rotation_of(table, i, poses);
    turn_symmetric_by(rotation, inertia.A);
    turn_matrix_by(rotation, inertia.B);
    turn_symmetric_by(rotation, inertia.C);
  } else {
    LinkTurns<Real> turns;
    find_turns(table.links[i], poses.joints[i], turns);
    turn_about_z(turns.joint, inertia);
    turn_about_x(turns.alpha, inertia);
    turn_about_z(turns.a, inertia);
  }
  shift_inertia(p, inertia);
}

template <class Real>
TREELINE_LINK_INLINE void add_six(const Real (&more)[6], Real (&sum)[6]) noexcept {
  sum[0] = sum[0] + more[0];
  sum[1] = sum[1] + more[1];
  sum[2] = sum[2] + more[2];
  sum[3] = sum[3] + more[3];
  sum[4] = sum[4] + more[4];
  sum[5] = sum[5] + more[5];
}

/// Inertia of a link alone, added to that of the links that it carries.
template <class Real>
TREELINE_LINK_INLINE void add_own(const LinkBody<Real>& body, LinkInertia<Real>& sum) noexcept {
  const Real mass = body.mass;
  const Real h[3] = {body.h[0], body.h[1], body.h[2]};
  Real(&A)[6] = sum.A;
  Real(&B)[9] = sum.B;
  A[0] = A[0] + mass;
  A[3] = A[3] + mass;
  A[5] = A[5] + mass;
  B[1] = B[1] + h[2];  // B = -[h]x
  B[2] = B[2] - h[1];
  B[3] = B[3] - h[2];
  B[5] = B[5] + h[0];
  B[6] = B[6] + h[1];
  B[7] = B[7] - h[0];
  add_six(body.J, sum.C);
}

template <class Real>
TREELINE_LINK_INLINE void copy_inertia(const LinkInertia<Real>& from,
                                       LinkInertia<Real>& to) noexcept {
  to.A[0] = from.A[0];
  to.A[1] = from.A[1];
  to.A[2] = from.A[2];
  to.A[3] = from.A[3];
  to.A[4] = from.A[4];
  to.A[5] = from.A[5];
  to.B[0] = from.B[0];
  to.B[1] = from.B[1];
  to.B[2] = from.B[2];
  to.B[3] = from.B[3];
  to.B[4] = from.B[4];
  to.B[5] = from.B[5];
  to.B[6] = from.B[6];
  to.B[7] = from.B[7];
  to.B[8] = from.B[8];
  to.C[0] = from.C[0];
  to.C[1] = from.C[1];
  to.C[2] = from.C[2];
  to.C[3] = from.C[3];
  to.C[4] = from.C[4];
  to.C[5] = from.C[5];
}

template <class Real>
void clear_inertia(LinkInertia<Real>& inertia) noexcept {
  for (int k = 0; k < 6; ++k) {
    inertia.A[k] = Real(0.0);
    inertia.C[k] = Real(0.0);
  }
  for (int k = 0; k < 9; ++k) {
    inertia.B[k] = Real(0.0);
  }
}

template <class Real>
void add_inertia(const LinkInertia<Real>& more, LinkInertia<Real>& sum) noexcept {
  for (int k = 0; k < 6; ++k) {
    sum.A[k] = sum.A[k] + more.A[k];
    sum.C[k] = sum.C[k] + more.C[k];
  }
  for (int k = 0; k < 9; ++k) {
    sum.B[k] = sum.B[k] + more.B[k];
  }
}

/// The inertia as the first rows and columns of a row-major matrix of `columns` columns.
template <class Real>
void copy_to(const LinkInertia<Real>& inertia, Real* matrix, int columns) noexcept {
  int at = 0;
  for (int k = 0; k < 3; ++k) {
    for (int l = 0; l < 3; ++l) {
      matrix[(k * columns) + l + 3] = inertia.B[(3 * k) + l];
      matrix[((l + 3) * columns) + k] = inertia.B[(3 * k) + l];
    }
    for (int l = k; l < 3; ++l) {
      matrix[(k * columns) + l] = inertia.A[at];
      matrix[(l * columns) + k] = inertia.A[at];
      matrix[((k + 3) * columns) + l + 3] = inertia.C[at];
      matrix[((l + 3) * columns) + k + 3] = inertia.C[at];
      ++at;
    }
  }
}

}  // namespace treeline::core::loops
