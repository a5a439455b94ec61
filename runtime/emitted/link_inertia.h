#pragma once
// Inertia of bodies at a link's frame: turned, moved and added.

/// R M R^T for a rotation in the plane of two axes, of a symmetric M: its entries of
/// the plane, and those of the plane's axes with the third.
TL_FOLDED void tl_turn_symmetric(
    const TlTurn* r, real* xx, real* xy, real* yy, real* xz, real* yz) {
  const real t = (r->s * ((*xx) - (*yy))) + (r->c * ((*xy) + (*xy)));
  const real st = r->s * t;
  *xx = (*xx) - st;
  *yy = (*yy) + st;
  *xy = (r->c * t) - (*xy);
  tl_turn_plane(r, xz, yz);
}

/// R M R^T for a rotation in the plane of two axes, of any M.
TL_FOLDED void tl_turn_square(const TlTurn* r, real* xx, real* xy, real* yx, real* yy,
    real* xz, real* yz, real* zx, real* zy) {
  const real t = (r->s * ((*xx) - (*yy))) + (r->c * ((*xy) + (*yx)));
  const real st = r->s * t;
  const real ct = r->c * t;
  const real old = *xy;
  *xx = (*xx) - st;
  *yy = (*yy) + st;
  *xy = ct - (*yx);
  *yx = ct - old;
  tl_turn_plane(r, xz, yz);
  tl_turn_plane(r, zx, zy);
}

TL_FOLDED void tl_turn_about_z(const TlTurn* r, TlLinkInertia* inertia) {
  real* const A = &inertia->A[0];
  real* const B = &inertia->B[0];
  real* const C = &inertia->C[0];
  tl_turn_symmetric(r, &A[0], &A[1], &A[3], &A[2], &A[4]);
  tl_turn_square(r, &B[0], &B[1], &B[3], &B[4], &B[2], &B[5], &B[6], &B[7]);
  tl_turn_symmetric(r, &C[0], &C[1], &C[3], &C[2], &C[4]);
}

TL_FOLDED void tl_turn_about_x(const TlTurn* r, TlLinkInertia* inertia) {
  real* const A = &inertia->A[0];
  real* const B = &inertia->B[0];
  real* const C = &inertia->C[0];
  tl_turn_symmetric(r, &A[3], &A[4], &A[5], &A[1], &A[2]);
  tl_turn_square(r, &B[4], &B[5], &B[7], &B[8], &B[3], &B[6], &B[1], &B[2]);
  tl_turn_symmetric(r, &C[3], &C[4], &C[5], &C[1], &C[2]);
}

/// The rows of B - A [p]x.
TL_FOLDED void tl_shift_moments(const real* p, const real* A, real* B) {
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

/// Moves an inertia from the origin of its frame to where that has origin p: B
/// becomes H = B - A [p]x and C gains [p]x H - B^T [p]x.
TL_FOLDED void tl_shift_inertia(const real* p, TlLinkInertia* inertia) {
  real* const B = &inertia->B[0];
  real* const C = &inertia->C[0];
  C[0] = C[0] - ((B[3] * p[2]) - (B[6] * p[1]));
  C[1] = C[1] - ((B[6] * p[0]) - (B[0] * p[2]));
  C[2] = C[2] - ((B[0] * p[1]) - (B[3] * p[0]));
  C[3] = C[3] - ((B[7] * p[0]) - (B[1] * p[2]));
  C[4] = C[4] - ((B[1] * p[1]) - (B[4] * p[0]));
  C[5] = C[5] - ((B[2] * p[1]) - (B[5] * p[0]));
  tl_shift_moments(p, &inertia->A[0], B);
  C[0] = C[0] + ((p[1] * B[6]) - (p[2] * B[3]));
  C[1] = C[1] + ((p[1] * B[7]) - (p[2] * B[4]));
  C[2] = C[2] + ((p[1] * B[8]) - (p[2] * B[5]));
  C[3] = C[3] + ((p[2] * B[1]) - (p[0] * B[7]));
  C[4] = C[4] + ((p[2] * B[2]) - (p[0] * B[8]));
  C[5] = C[5] + ((p[0] * B[5]) - (p[1] * B[2]));
}

/// Q M Q^T
TL_INLINE void tl_turn_matrix_by(const TlLinkRotation* rotation, real* M) {
  for (int32_t k = 0; k < 3; ++k) {
    real column[3] = {M[k], M[3 + k], M[6 + k]};
    tl_turn_by(rotation, &column[0]);
    for (int32_t l = 0; l < 3; ++l) {
      M[(3 * l) + k] = column[l];
    }
  }
  for (int32_t k = 0; k < 3; ++k) {
    real row[3] = {M[3 * k], M[(3 * k) + 1], M[(3 * k) + 2]};
    tl_turn_by(rotation, &row[0]);
    for (int32_t l = 0; l < 3; ++l) {
      M[(3 * k) + l] = row[l];
    }
  }
}

TL_INLINE void tl_turn_symmetric_by(const TlLinkRotation* rotation, real* M) {
  real full[9] = {M[0], M[1], M[2], M[1], M[3], M[4], M[2], M[4], M[5]};
  tl_turn_matrix_by(rotation, &full[0]);
  for (int32_t k = 0; k < 3; ++k) {
    M[k] = full[k];
  }
  M[3] = full[4];
  M[4] = full[5];
  M[5] = full[8];
}

/// Makes the inertia that link `i` passes on one of its parent.
TL_INLINE void tl_inertia_to_parent(const TlLinkTable* table, int32_t i,
    const TlLinkPoses* poses, TlLinkInertia* inertia) {
  real p[3];
  tl_find_origin(table, i, poses, &p[0]);
  if (tl_turns_freely(table, i)) {
    const TlLinkRotation* const rotation = tl_rotation_of(table, i, poses);
    tl_turn_symmetric_by(rotation, &inertia->A[0]);
    tl_turn_matrix_by(rotation, &inertia->B[0]);
    tl_turn_symmetric_by(rotation, &inertia->C[0]);
  } else {
    TlLinkTurns turns;
    tl_find_turns(&table->links[i], &poses->joints[i], &turns);
    tl_turn_about_z(&turns.joint, inertia);
    tl_turn_about_x(&turns.alpha, inertia);
    tl_turn_about_z(&turns.a, inertia);
  }
  tl_shift_inertia(&p[0], inertia);
}

TL_FOLDED void tl_add_six(const real* more, real* sum) {
  sum[0] = sum[0] + more[0];
  sum[1] = sum[1] + more[1];
  sum[2] = sum[2] + more[2];
  sum[3] = sum[3] + more[3];
  sum[4] = sum[4] + more[4];
  sum[5] = sum[5] + more[5];
}

/// Inertia of a link alone, added to that of the links that it carries.
TL_FOLDED void tl_add_own(const TlLinkBody* body, TlLinkInertia* sum) {
  const real mass = body->mass;
  const real h[3] = {body->h[0], body->h[1], body->h[2]};
  real* const A = &sum->A[0];
  real* const B = &sum->B[0];
  A[0] = A[0] + mass;
  A[3] = A[3] + mass;
  A[5] = A[5] + mass;
  B[1] = B[1] + h[2];  // B = -[h]x
  B[2] = B[2] - h[1];
  B[3] = B[3] - h[2];
  B[5] = B[5] + h[0];
  B[6] = B[6] + h[1];
  B[7] = B[7] - h[0];
  tl_add_six(&body->J[0], &sum->C[0]);
}

TL_FOLDED void tl_copy_inertia(const TlLinkInertia* from, TlLinkInertia* to) {
  to->A[0] = from->A[0];
  to->A[1] = from->A[1];
  to->A[2] = from->A[2];
  to->A[3] = from->A[3];
  to->A[4] = from->A[4];
  to->A[5] = from->A[5];
  to->B[0] = from->B[0];
  to->B[1] = from->B[1];
  to->B[2] = from->B[2];
  to->B[3] = from->B[3];
  to->B[4] = from->B[4];
  to->B[5] = from->B[5];
  to->B[6] = from->B[6];
  to->B[7] = from->B[7];
  to->B[8] = from->B[8];
  to->C[0] = from->C[0];
  to->C[1] = from->C[1];
  to->C[2] = from->C[2];
  to->C[3] = from->C[3];
  to->C[4] = from->C[4];
  to->C[5] = from->C[5];
}

TL_INLINE void tl_clear_inertia(TlLinkInertia* inertia) {
  for (int32_t k = 0; k < 6; ++k) {
    inertia->A[k] = TL_ZERO;
    inertia->C[k] = TL_ZERO;
  }
  for (int32_t k = 0; k < 9; ++k) {
    inertia->B[k] = TL_ZERO;
  }
}

TL_INLINE void tl_add_inertia(const TlLinkInertia* more, TlLinkInertia* sum) {
  for (int32_t k = 0; k < 6; ++k) {
    sum->A[k] = sum->A[k] + more->A[k];
    sum->C[k] = sum->C[k] + more->C[k];
  }
  for (int32_t k = 0; k < 9; ++k) {
    sum->B[k] = sum->B[k] + more->B[k];
  }
}

/// The inertia as the first rows and columns of a row-major matrix of `columns`
/// columns.
TL_INLINE void tl_copy_to(
    const TlLinkInertia* inertia, real* matrix, int32_t columns) {
  int32_t at = 0;
  for (int32_t k = 0; k < 3; ++k) {
    for (int32_t l = 0; l < 3; ++l) {
      matrix[(k * columns) + l + 3] = inertia->B[(3 * k) + l];
      matrix[((l + 3) * columns) + k] = inertia->B[(3 * k) + l];
    }
    for (int32_t l = k; l < 3; ++l) {
      matrix[(k * columns) + l] = inertia->A[at];
      matrix[(l * columns) + k] = inertia->A[at];
      matrix[((k + 3) * columns) + l + 3] = inertia->C[at];
      matrix[((l + 3) * columns) + k + 3] = inertia->C[at];
      ++at;
    }
  }
}
