#pragma once
// Vectors, rotations about coordinate axes, wrenches and twists of the links of a
// table.

// Arrays and structs are filled and copied by their numbers: of initializers and
// assignments compilers make calls of memset and memcpy.
TL_INLINE void tl_clear(real* v) {
  for (int32_t k = 0; k < 3; ++k) {
    v[k] = TL_ZERO;
  }
}

TL_FOLDED void tl_turn_plane(const TlTurn* r, real* x, real* y) {
  const real old = *x;
  *x = (r->c * old) - (r->s * (*y));
  *y = (r->s * old) + (r->c * (*y));
}

TL_FOLDED void tl_turn_plane_back(const TlTurn* r, real* x, real* y) {
  const real old = *x;
  *x = (r->c * old) + (r->s * (*y));
  *y = (r->c * (*y)) - (r->s * old);
}

TL_FOLDED real tl_dot(const real* a, const real* b) {
  return (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);
}

/// product = a x b
TL_FOLDED void tl_find_cross(const real* a, const real* b, real* product) {
  product[0] = (a[1] * b[2]) - (a[2] * b[1]);
  product[1] = (a[2] * b[0]) - (a[0] * b[2]);
  product[2] = (a[0] * b[1]) - (a[1] * b[0]);
}

/// sum += a x b
TL_FOLDED void tl_add_cross(const real* a, const real* b, real* sum) {
  sum[0] = sum[0] + ((a[1] * b[2]) - (a[2] * b[1]));
  sum[1] = sum[1] + ((a[2] * b[0]) - (a[0] * b[2]));
  sum[2] = sum[2] + ((a[0] * b[1]) - (a[1] * b[0]));
}

TL_FOLDED void tl_add(const TlSpatial* more, TlSpatial* sum) {
  sum->linear[0] = sum->linear[0] + more->linear[0];
  sum->linear[1] = sum->linear[1] + more->linear[1];
  sum->linear[2] = sum->linear[2] + more->linear[2];
  sum->angular[0] = sum->angular[0] + more->angular[0];
  sum->angular[1] = sum->angular[1] + more->angular[1];
  sum->angular[2] = sum->angular[2] + more->angular[2];
}

/// sum += factor more
TL_FOLDED void tl_add_scaled(const TlSpatial* more, real factor, TlSpatial* sum) {
  sum->linear[0] = sum->linear[0] + (more->linear[0] * factor);
  sum->linear[1] = sum->linear[1] + (more->linear[1] * factor);
  sum->linear[2] = sum->linear[2] + (more->linear[2] * factor);
  sum->angular[0] = sum->angular[0] + (more->angular[0] * factor);
  sum->angular[1] = sum->angular[1] + (more->angular[1] * factor);
  sum->angular[2] = sum->angular[2] + (more->angular[2] * factor);
}

/// scaled = factor spatial
TL_FOLDED void tl_scale_spatial(
    real factor, const TlSpatial* spatial, TlSpatial* scaled) {
  scaled->linear[0] = spatial->linear[0] * factor;
  scaled->linear[1] = spatial->linear[1] * factor;
  scaled->linear[2] = spatial->linear[2] * factor;
  scaled->angular[0] = spatial->angular[0] * factor;
  scaled->angular[1] = spatial->angular[1] * factor;
  scaled->angular[2] = spatial->angular[2] * factor;
}

TL_FOLDED void tl_copy_spatial(const TlSpatial* from, TlSpatial* to) {
  to->linear[0] = from->linear[0];
  to->linear[1] = from->linear[1];
  to->linear[2] = from->linear[2];
  to->angular[0] = from->angular[0];
  to->angular[1] = from->angular[1];
  to->angular[2] = from->angular[2];
}

TL_INLINE void tl_clear_spatial(TlSpatial* spatial) {
  tl_clear(&spatial->linear[0]);
  tl_clear(&spatial->angular[0]);
}
