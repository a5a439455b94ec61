#pragma once
// Contacts in axes of their own: the normal first, then two across it. Each contact's
// numbers are scaled by a power of two, so that its own inverse inertia is about 1
// whatever masses meet there; friction cones keep their shape.

#include <stdbool.h>
#include <stdint.h>

#include "contact_sizes.h"
#include "square_root.h"

/// Contact law at one contact. The normal is a unit vector out of the touched body,
/// world axes.
struct TlContactLaw {
  real normal[3];
  real restitution;  // 0: the approach ends; 1: it is reversed
  real friction;  // Coulomb's coefficient, both sticking and sliding
};
typedef struct TlContactLaw TlContactLaw;

/// What one contact does: nothing, hold, or slide.
enum { TL_PARTS, TL_STICKS, TL_SLIDES };

/// Contacts and what is found for them: impulses y and velocities u = free + G y.
struct TlContacts {
  real G[TL_CONTACT_ROWS * TL_CONTACT_ROWS];  // inverse inertia, scaled
  real before[TL_CONTACT_ROWS];  // velocities without impulses
  real free[TL_CONTACT_ROWS];  // the same, less the speeds wanted along normals
  real u[TL_CONTACT_ROWS];
  real y[TL_CONTACT_ROWS];
  real best[TL_CONTACT_ROWS];  // the impulses that came nearest to the laws
  real best_miss;
  real axes[TL_CONTACTS * 9];  // rows: normal and two across, world axes
  real scales[TL_CONTACTS];
  real restitution[TL_CONTACTS];
  real friction[TL_CONTACTS];
  real across[TL_CONTACTS * 2];  // 1 / inertia across, while the normal speed stays
  real rates[TL_CONTACTS];  // speed across per impulse across, of the last slide
  int32_t states[TL_CONTACTS];
  real factors[TL_CONTACT_ROWS * TL_CONTACT_ROWS];
  real step[TL_CONTACT_ROWS];
  int32_t pivots[TL_CONTACT_ROWS];
  int32_t count;  // of contacts
  int32_t steps;
  real speed;  // the largest before
  real tolerance;  // of speeds, beside that
};
typedef struct TlContacts TlContacts;

TL_INLINE real tl_magnitude(real x) {
  return (x < TL_ZERO) ? -x : x;
}

TL_INLINE real tl_larger(real a, real b) {
  return (a > b) ? a : b;
}

TL_INLINE real tl_product(const real* a, const real* b) {
  return (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);
}

/// Rows of contacts in eights: loops of eight become SIMD.
TL_INLINE int32_t tl_rows_in_eights(const TlContacts* all) {
  return (((3 * all->count) + 7) / 8) * 8;
}

/// x += sum of three factors times rows of G. Rows are added in an array of its own,
/// which no pointer can reach.
TL_INLINE void tl_add_three_rows(
    const real* factors, const real* rows, int32_t size, real* x) {
  real sum[TL_CONTACT_ROWS];
  for (int32_t i = 0; i < size; i += 8) {
    for (int32_t k = 0; k < 8; ++k) {
      sum[i + k] = x[i + k] + (factors[0] * rows[i + k]) +
          (factors[1] * rows[TL_CONTACT_ROWS + i + k]) +
          (factors[2] * rows[(2 * TL_CONTACT_ROWS) + i + k]);
    }
  }
  for (int32_t i = 0; i < size; ++i) {
    x[i] = sum[i];
  }
}

/// u = free + G y
TL_FUNCTION void tl_find_velocities(TlContacts* all) {
  const int32_t size = tl_rows_in_eights(all);
  for (int32_t i = 0; i < size; ++i) {
    all->u[i] = all->free[i];
  }
  for (int32_t c = 0; c < all->count; ++c) {
    const real* const y = &all->y[3 * c];
    if ((y[0] != TL_ZERO) || (y[1] != TL_ZERO) || (y[2] != TL_ZERO)) {
      tl_add_three_rows(y, &all->G[3 * c * TL_CONTACT_ROWS], size, &all->u[0]);
    }
  }
}

/// a^T A b of a block of a matrix.
TL_INLINE real tl_between(
    const real* a, const real* A, int32_t stride, const real* b) {
  return (a[0] * tl_product(&A[0], b)) + (a[1] * tl_product(&A[stride], b)) +
      (a[2] * tl_product(&A[2 * stride], b));
}

/// Two unit vectors across the normal, along which motion with the normal speed held
/// is not coupled: one Jacobi rotation of two by two.
TL_FUNCTION void tl_choose_axes(
    const real* normal, const real* A, int32_t stride, real* axes) {
  int32_t least = (tl_magnitude(normal[1]) < tl_magnitude(normal[0])) ? 1 : 0;
  least = (tl_magnitude(normal[2]) < tl_magnitude(normal[least])) ? 2 : least;
  real first[3];
  real second[3];
  for (int32_t i = 0; i < 3; ++i) {
    first[i] = ((i == least) ? TL_ONE : TL_ZERO) - (normal[least] * normal[i]);
  }
  const real length = tl_square_root(tl_product(&first[0], &first[0]));
  for (int32_t i = 0; i < 3; ++i) {
    first[i] /= length;
  }
  for (int32_t i = 0; i < 3; ++i) {
    const int32_t j = (i + 1) % 3;
    const int32_t k = (i + 2) % 3;
    second[i] = (normal[j] * first[k]) - (normal[k] * first[j]);
  }
  const real along = tl_between(normal, A, stride, normal);
  const real n1 = tl_between(normal, A, stride, &first[0]);
  const real n2 = tl_between(normal, A, stride, &second[0]);
  const real share = (along > TL_ZERO) ? (TL_ONE / along) : TL_ZERO;
  const real a = tl_between(&first[0], A, stride, &first[0]) - (n1 * n1 * share);
  const real b = tl_between(&first[0], A, stride, &second[0]) - (n1 * n2 * share);
  const real d = tl_between(&second[0], A, stride, &second[0]) - (n2 * n2 * share);
  real cosine = TL_ONE;
  real sine = TL_ZERO;
  if (b != TL_ZERO) {
    const real theta = (d - a) / (TL_TWO * b);
    const real size = tl_magnitude(theta) + tl_square_root((theta * theta) + TL_ONE);
    const real tangent = ((theta < TL_ZERO) ? -TL_ONE : TL_ONE) / size;
    cosine = TL_ONE / tl_square_root((tangent * tangent) + TL_ONE);
    sine = tangent * cosine;
  }
  for (int32_t i = 0; i < 3; ++i) {
    axes[i] = normal[i];
    axes[3 + i] = (cosine * first[i]) - (sine * second[i]);
    axes[6 + i] = (sine * first[i]) + (cosine * second[i]);
  }
}

/// The power of two by which the trace of a contact's inverse inertia, times its
/// square, comes to lie between 1 and 4; 1 where nothing moves.
TL_INLINE real tl_scale_of(real trace) {
  const real four = TL_TWO * TL_TWO;
  real scale = TL_ONE;
  if ((trace > TL_ZERO) && ((TL_ONE / trace) > TL_ZERO)) {
    for (int32_t k = 0; (k < 512) && ((trace * scale * scale) >= four); ++k) {
      scale *= TL_HALF;
    }
    for (int32_t k = 0; (k < 512) && ((trace * scale * scale) < TL_ONE); ++k) {
      scale *= TL_TWO;
    }
  }
  return scale;
}

/// The block of two contacts in G: axes and scales.
TL_INLINE void tl_enter_block(
    TlContacts* all, const real* A, int32_t one, int32_t other) {
  const int32_t size = 3 * all->count;
  const real scale = all->scales[one] * all->scales[other];
  const real* const own = &all->axes[9 * one];
  for (int32_t j = 0; j < 3; ++j) {
    real turned[3];
    for (int32_t i = 0; i < 3; ++i) {
      turned[i] = scale *
          tl_product(&A[(((3 * one) + i) * size) + (3 * other)],
              &all->axes[(9 * other) + (3 * j)]);
    }
    for (int32_t i = 0; i < 3; ++i) {
      const real entry = tl_product(&own[3 * i], &turned[0]);
      all->G[(((3 * one) + i) * TL_CONTACT_ROWS) + (3 * other) + j] = entry;
      all->G[(((3 * other) + j) * TL_CONTACT_ROWS) + (3 * one) + i] = entry;
    }
  }
}

/// Takes over the contacts' own axes and scales, G, and velocities before.
TL_FUNCTION void tl_enter_contacts(
    TlContacts* all, const real* A, const TlContactLaw* laws, const real* v) {
  const int32_t size = 3 * all->count;
  for (int32_t c = 0; c < all->count; ++c) {
    const real* const own = &A[(3 * c * size) + (3 * c)];
    real* const axes = &all->axes[9 * c];
    tl_choose_axes(&laws[c].normal[0], own, size, axes);
    all->scales[c] = tl_scale_of(own[0] + own[size + 1] + own[(2 * size) + 2]);
    all->restitution[c] = laws[c].restitution;
    all->friction[c] = (laws[c].friction < TL_LARGEST_FRICTION) ? laws[c].friction
                                                                : TL_LARGEST_FRICTION;
    for (int32_t other = 0; other <= c; ++other) {
      tl_enter_block(all, A, c, other);
    }
    for (int32_t i = 0; i < 3; ++i) {
      all->before[(3 * c) + i] = all->scales[c] * tl_product(&axes[3 * i], &v[3 * c]);
    }
    const real* const W = &all->G[(3 * c * TL_CONTACT_ROWS) + (3 * c)];
    for (int32_t i = 1; i < 3; ++i) {
      const real coupled = (W[0] > TL_ZERO) ? (W[i] * W[i] / W[0]) : TL_ZERO;
      all->across[(2 * c) + i - 1] =
          tl_larger(W[(i * TL_CONTACT_ROWS) + i] - coupled, TL_ZERO);
    }
    all->rates[c] = TL_ZERO;
  }
  for (int32_t row = 0; row < size; ++row) {
    for (int32_t i = size; i < tl_rows_in_eights(all); ++i) {
      all->G[(row * TL_CONTACT_ROWS) + i] = TL_ZERO;
    }
  }
}

/// Speeds wanted along the normals: -e v_n before, with a share of each e.
TL_INLINE void tl_want_speeds(TlContacts* all, real share) {
  all->speed = TL_ZERO;
  for (int32_t i = 0; i < tl_rows_in_eights(all); ++i) {
    const bool real_row = i < (3 * all->count);
    const real before = real_row ? all->before[i] : TL_ZERO;
    const bool along = real_row && ((i % 3) == 0);
    all->free[i] =
        before + (along ? (share * all->restitution[i / 3] * before) : TL_ZERO);
    all->speed = real_row
        ? tl_larger(all->speed, tl_magnitude(before) / all->scales[i / 3])
        : all->speed;
  }
}
