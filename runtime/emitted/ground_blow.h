#pragma once
// A blow on a robot at points in the ground: impulses by the contact solver, and the
// velocities that they change. With M = L^T D L, whose factor has an entry for each
// two velocities of one path from the root, rows of J and of L^-T J^T have the
// velocities of one path alone.

#include "contact_solver.h"
#include "ground_points.h"

/// What a blow is computed with.
struct TlGroundBlow {
  TlContacts contacts;
  TlContactLaw laws[TL_CONTACTS];
  real columns[TL_CONTACTS * 3 * TL_GROUND_VELOCITIES];  // L^-T J^T: of each contact
  real shares[TL_CONTACTS * 3 * TL_GROUND_VELOCITIES];  // the same by D
  real A[TL_CONTACTS * 3 * TL_CONTACTS * 3];  // J M^-1 J^T
  real v[TL_CONTACTS * 3];
  real y[TL_CONTACTS * 3];  // N s
  real dqd[TL_GROUND_VELOCITIES];
};
typedef struct TlGroundBlow TlGroundBlow;

/// The velocity of a point near the ground.
TL_FUNCTION void tl_velocity_of(
    const TlGroundPose* at, const real* qd, const TlGroundTouch* touch, real* v) {
  real twist[6];
  tl_twist_of(at, qd, touch->group, &twist[0]);
  v[0] = TL_ZERO;
  v[1] = TL_ZERO;
  v[2] = TL_ZERO;
  tl_add_motion(&twist[0], &touch->arm[0], TL_ONE, v);
}

/// The columns L^-T J^T of a contact: of each velocity of its path three entries, x y
/// z.
TL_FUNCTION void tl_enter_columns(
    const TlGroundPose* at, const TlGroundTouch* touch, real* columns, real* shares) {
  const int32_t tip = TL_GROUND_TIPS[touch->group];
  const int32_t length = tl_path_length(tip);
  for (int32_t k = 0; k < length; ++k) {
    real* const own = &columns[3 * k];
    own[0] = TL_ZERO;
    own[1] = TL_ZERO;
    own[2] = TL_ZERO;
    tl_add_motion(&at->motion[6 * tl_on_path(tip, k)], &touch->arm[0], TL_ONE, own);
  }
  for (int32_t k = length - 1; k >= 0; --k) {
    const int32_t velocity = tl_on_path(tip, k);
    const real* const row = &at->factor[TL_GROUND_FACTOR_AT[velocity]];
    const real own[3] = {columns[3 * k], columns[(3 * k) + 1], columns[(3 * k) + 2]};
    for (int32_t i = 0; i < k; ++i) {
      columns[3 * i] -= row[i] * own[0];
      columns[(3 * i) + 1] -= row[i] * own[1];
      columns[(3 * i) + 2] -= row[i] * own[2];
    }
    for (int32_t i = 0; i < 3; ++i) {
      shares[(3 * k) + i] = at->inverse[velocity] * own[i];
    }
  }
}

/// The block of two contacts of J M^-1 J^T: what the velocities add that move both.
TL_INLINE void tl_fill_block(
    const real* columns, const real* shares, int32_t length, real* block) {
  real sum[9] = {TL_ZERO, TL_ZERO, TL_ZERO, TL_ZERO, TL_ZERO, TL_ZERO, TL_ZERO,
      TL_ZERO, TL_ZERO};
  for (int32_t k = 0; k < (3 * length); k += 3) {
    for (int32_t i = 0; i < 3; ++i) {
      sum[3 * i] += columns[k + i] * shares[k];
      sum[(3 * i) + 1] += columns[k + i] * shares[k + 1];
      sum[(3 * i) + 2] += columns[k + i] * shares[k + 2];
    }
  }
  for (int32_t i = 0; i < 9; ++i) {
    block[i] = sum[i];
  }
}

/// J M^-1 J^T of all contacts.
TL_FUNCTION void tl_fill_inverse_inertia(
    const TlGroundTouches* found, TlGroundBlow* blow) {
  const int32_t size = 3 * found->count;
  for (int32_t c = 0; c < found->count; ++c) {
    for (int32_t d = 0; d <= c; ++d) {
      const int32_t pair =
          (TL_GROUND_GROUPS * found->list[c].group) + found->list[d].group;
      real block[9];
      tl_fill_block(&blow->columns[3 * TL_GROUND_VELOCITIES * c],
          &blow->shares[3 * TL_GROUND_VELOCITIES * d], TL_GROUND_SHARED[pair],
          &block[0]);
      for (int32_t i = 0; i < 3; ++i) {
        for (int32_t k = 0; k < 3; ++k) {
          blow->A[(((3 * c) + i) * size) + (3 * d) + k] = block[(3 * i) + k];
          blow->A[(((3 * d) + k) * size) + (3 * c) + i] = block[(3 * i) + k];
        }
      }
    }
  }
}

/// Whether an impulse at a contact can move it upward.
TL_INLINE bool tl_can_rise(const real* columns, const real* shares, int32_t length) {
  real block[9];
  tl_fill_block(columns, shares, length, &block[0]);
  return block[8] > (TL_ROUNDING * (block[0] + block[4] + block[8]));
}

/// Enters the columns of all points, and leaves out those that no impulse can move
/// upward.
TL_FUNCTION void tl_enter_touches(
    const TlGroundPose* at, TlGroundTouches* found, TlGroundBlow* blow) {
  int32_t kept = 0;
  for (int32_t c = 0; c < found->count; ++c) {
    real* const columns = &blow->columns[3 * TL_GROUND_VELOCITIES * kept];
    real* const shares = &blow->shares[3 * TL_GROUND_VELOCITIES * kept];
    tl_enter_columns(at, &found->list[c], columns, shares);
    found->list[kept] = found->list[c];
    kept += tl_can_rise(
                columns, shares, tl_path_length(TL_GROUND_TIPS[found->list[c].group]))
        ? 1
        : 0;
  }
  found->count = kept;
}

/// dqd = M^-1 J^T y = L^-1 D^-1 (L^-T J^T) y.
TL_FUNCTION void tl_respond(
    const TlGroundPose* at, const TlGroundTouches* found, TlGroundBlow* blow) {
  for (int32_t i = 0; i < TL_GROUND_VELOCITIES; ++i) {
    blow->dqd[i] = TL_ZERO;
  }
  for (int32_t c = 0; c < found->count; ++c) {
    const int32_t tip = TL_GROUND_TIPS[found->list[c].group];
    const real* const shares = &blow->shares[3 * TL_GROUND_VELOCITIES * c];
    for (int32_t k = 0; k < tl_path_length(tip); ++k) {
      blow->dqd[tl_on_path(tip, k)] += tl_product(&shares[3 * k], &blow->y[3 * c]);
    }
  }
  for (int32_t i = 0; i < TL_GROUND_VELOCITIES; ++i) {
    real sum = blow->dqd[i];
    for (int32_t k = TL_GROUND_FACTOR_AT[i]; k < TL_GROUND_FACTOR_AT[i + 1]; ++k) {
      sum -= at->factor[k] * blow->dqd[TL_GROUND_BEFORE[k]];
    }
    blow->dqd[i] = sum;
  }
}

/// The impulse with which a point starts: that of the last blow.
TL_INLINE void tl_start_from(const TlGroundMemory* memory, int32_t id, real* y) {
  y[0] = TL_ZERO;
  y[1] = TL_ZERO;
  y[2] = TL_ZERO;
  for (int32_t i = 0; i < memory->count; ++i) {
    if (memory->points[i] == id) {
      y[0] = memory->impulses[3 * i];
      y[1] = memory->impulses[(3 * i) + 1];
      y[2] = memory->impulses[(3 * i) + 2];
    }
  }
}

/// Enters what presses a point, if anything does.
TL_INLINE void tl_report_touch(const TlGroundPose* at, const TlGroundTouch* touch,
    const real* y, TlGroundReport* report) {
  real* const entry = &report->touches[6 * report->contacts];
  if (y[2] > TL_ZERO) {
    for (int32_t i = 0; i < 3; ++i) {
      entry[i] = at->origin[i] + touch->arm[i];
      entry[3 + i] = y[i];
    }
    report->contacts += 1;
  }
}

/// Impulses at the points, of which those above the ground may come as near as their
/// height within `dt`, and what they change of the velocities.
TL_FUNCTION void tl_strike(const TlGround* ground, const TlGroundPose* at, real dt,
    const real* qd, TlGroundTouches* found, TlGroundMemory* memory,
    TlGroundBlow* blow, TlGroundReport* report) {
  tl_enter_touches(at, found, blow);
  tl_fill_inverse_inertia(found, blow);
  for (int32_t c = 0; c < found->count; ++c) {
    TlContactLaw* const law = &blow->laws[c];
    law->normal[0] = TL_ZERO;
    law->normal[1] = TL_ZERO;
    law->normal[2] = TL_ONE;
    law->restitution = TL_ZERO;
    law->friction = ground->friction;
    real* const v = &blow->v[3 * c];
    tl_velocity_of(at, qd, &found->list[c], v);
    const real allowed = -((found->list[c].depth / dt) + v[2]);
    v[2] += (allowed > TL_ZERO) ? allowed : TL_ZERO;
    tl_start_from(memory, found->list[c].id, &blow->y[3 * c]);
  }
  const TlContactResult result = tl_solve_contacts(&blow->contacts, found->count,
      &blow->A[0], &blow->laws[0], &blow->v[0], &blow->y[0]);
  tl_respond(at, found, blow);
  memory->count = found->count;
  for (int32_t c = 0; c < found->count; ++c) {
    memory->points[c] = found->list[c].id;
    for (int32_t i = 0; i < 3; ++i) {
      memory->impulses[(3 * c) + i] = blow->y[(3 * c) + i];
      report->impulse[i] += blow->y[(3 * c) + i];
    }
    tl_report_touch(at, &found->list[c], &blow->y[3 * c], report);
  }
  report->miss = result.miss;
  report->converged = (result.converged || (found->count == 0)) ? 1 : 0;
}
