// The headers of runtime/emitted for loops over links as they stand, in C, of a robot that has all
// that they know: a base that floats, a joint that turns and one that slides.
#include "emitted_links.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define TL_INLINE static inline
#define TL_FOLDED static inline
#define TL_SHARED static inline
#define TL_NONE NULL
#define TL_REAL(number) number
#define TL_ZERO 0.0
#define TL_ONE 1.0
#define TL_FLOATS 1
#define TL_SLIDING 1
#define TL_DRIVEN 1
#define TL_RUBBING 1
#define TL_COUPLED 1
#define TL_ARTICULATED 1
#define TL_OWN_SINES 1
#define TL_BALLS 1
#define TL_PUSHED 1
#define TL_LOADED 1
#define TL_SORTED 1
#define TL_STEPPED 1
#define TL_GROUNDED 1
#define TL_FREED 1
#define TL_TURNING 1
#define TL_GIVEN_SINES 1

typedef double real;

enum {
  TL_LINKS = 9,
  TL_SLOTS = 2,
  TL_TURNED = 2,
  TL_POINTS = 1,
  TL_ROWS = 2,
  TL_RANKED = 2,
  TL_BASE_ENTRIES = 80
};

static inline void tl_sin_cos_of(real x, real* sine, real* cosine) {
  *sine = sin(x);
  *cosine = cos(x);
}

#include "emitted/link_types.h"
//
#include "emitted/link_work.h"
//
#include "emitted/link_vectors.h"
//
#include "emitted/link_joints.h"
//
#include "emitted/link_pose.h"
//
#include "emitted/link_friction.h"
//
#include "emitted/link_motion.h"
//
#include "emitted/link_inertia.h"
//
#include "emitted/link_inputs.h"
//
#include "emitted/link_matrix.h"
//
#include "emitted/link_factors.h"
//
#include "emitted/link_articulation.h"
//
#include "emitted/link_points.h"
//
#include "emitted/link_rows.h"
//
#include "emitted/link_factored.h"
//
#include "emitted/link_functions.h"

static const TlLink kLinks[3] = {{-1,
                                  0,
                                  3,
                                  false,
                                  true,
                                  {1, 0},
                                  {1, 0},
                                  {1, 0},
                                  {0, 0, 0},
                                  0,
                                  {3, {0.1, 0.2, -0.1}, {1, 0.1, 0, 1.2, 0, 0.9}}},
                                 {0,
                                  1,
                                  3,
                                  false,
                                  false,
                                  {0.8, 0.6},
                                  {0, 1},
                                  {1, 0},
                                  {0.1, 0.3, 0.2},
                                  0.4,
                                  {2, {0.3, 0, 0.1}, {0.5, 0, 0.1, 0.6, 0, 0.4}}},
                                 {1,
                                  1,
                                  3,
                                  true,
                                  true,
                                  {1, 0},
                                  {0.6, -0.8},
                                  {1, 0},
                                  {0.4, 0, 0.1},
                                  0,
                                  {1, {0, 0.1, 0.2}, {0.3, 0, 0, 0.3, 0.05, 0.2}}}};
static const TlLinkDrive kDrives[3] = {{0, 0, 0}, {1, 2, 0.1}, {3, 0, 0}};
static const TlLinkFriction kFrictions[3] = {{0, 0}, {1, 10}, {2, 20}};
static const TlLinkCoupling kCouplings[3] = {
    {0, 1, false, false}, {1, 1, false, false}, {2, 1, false, false}};
static const TlLinkBall kBalls[3] = {{0, 0, 0}, {0, 0, 7}, {0, 0, 8}};
static const TlLinkPoint kPoints[1] = {{2, true, {0}, {0.1, 0.2, 0.3}}};
static const TlPointRow kRows[2] = {{0, 0, false}, {0, 1, true}};
static const int16_t kEntries[2] = {1, 0};
static const TlLinkTable kTable = {&kLinks[0],
                                   3,
                                   2,
                                   {0, 0, -9.81},
                                   &kPoints[0],
                                   1,
                                   &kRows[0],
                                   2,
                                   &kCouplings[0],
                                   3,
                                   &kEntries[0],
                                   NULL,
                                   NULL,
                                   &kDrives[0],
                                   &kFrictions[0],
                                   &kBalls[0],
                                   NULL,
                                   0,
                                   NULL,
                                   NULL,
                                   NULL,
                                   0};

void links_in_c(const struct LinkState* state, struct LinkDynamics* dynamics) {
  TlMotionWork motions;
  TlMatrixWork matrix;
  TlFactorWork factors;
  TlRowWork rows;
  const double none[2] = {0, 0};
  TlLinkTable without_points = kTable;
  without_points.point_count = 0;
  without_points.rows = 0;
  motions.poses.sin_q = state->sin_q;
  motions.poses.cos_q = state->cos_q;
  tl_inverse_dynamics(&without_points, state->q, state->qd, state->qdd, dynamics->tau, &motions);
  tl_nonlinear_effects(&without_points, state->q, state->qd, dynamics->h, &motions);
  tl_gravity(&without_points, state->q, dynamics->g, &motions);
  tl_mass_matrix(&without_points, state->q, dynamics->M, &motions, &matrix);
  tl_forward_dynamics(&without_points, state->q, state->qd, dynamics->tau, dynamics->qdd, &motions,
                      &factors);
  tl_lambda_inverse(&kTable, state->q, dynamics->Lambda_inv, &motions, &factors, &rows);
  tl_lambda(0, &kTable, none, state->q, dynamics->Lambda, &motions, &factors, &rows);
  tl_control_torque(0, &kTable, none, state->q, state->qd, state->qdd, state->xdd_cmd,
                    dynamics->torque, &motions, &factors, &rows);
}
