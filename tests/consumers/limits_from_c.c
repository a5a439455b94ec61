/* Would catch: limits, a start, an outcome or a row of states that the header for C beside C++
   passes on wrongly: C++ called from C, and the same in C, in one program, with the same bits. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "arm_batch.h"
#include "arm_limited.h"
#include "inc_batch.h"
#include "inc_limited.h"

enum { n = ARM_VELOCITIES, states = 300 };

static double draw(int state, int i) {
  return 2 * sin(12.9898 * state + 78.233 * i);
}

static int compare_limited(void) {
  static arm_limited_torque limited; /* zeros, then from cycle to cycle */
  static inc_limited_torque inc_limited;
  arm_torque_limits limits = arm_default_limits;
  inc_torque_limits inc_limits = inc_default_limits;
  int state, i, cut = 0, warm = 0;
  for (i = 0; i < n; ++i) {
    limits.torque[i] *= 0.9;
    inc_limits.torque[i] *= 0.9;
  }
  for (state = 0; state < states; ++state) {
    double q[n], qd[n], qdd_0[n], xdd_cmd[ARM_TASK_ROWS], f_wanted[ARM_HELD_ROWS];
    double tau[n], inc_tau[n], f[ARM_HELD_ROWS], inc_f[ARM_HELD_ROWS];
    for (i = 0; i < n; ++i) {
      q[i] = draw(state / 3, i); /* slowly, so that cycles start from the last */
      qd[i] = draw(state, i + n);
      qdd_0[i] = 4 * draw(state, i + 2 * n);
    }
    for (i = 0; i < ARM_TASK_ROWS; ++i) xdd_cmd[i] = 10 * draw(state, i + 30);
    for (i = 0; i < ARM_HELD_ROWS; ++i) f_wanted[i] = 20 * draw(state, i + 40);
    arm_limited_control_torque(q, qd, qdd_0, xdd_cmd, f_wanted, tau, f, &limited, &limits);
    inc_limited_control_torque(q, qd, qdd_0, xdd_cmd, f_wanted, inc_tau, inc_f, &inc_limited,
                               &inc_limits);
    if (memcmp(tau, inc_tau, sizeof tau) != 0 || memcmp(f, inc_f, sizeof f) != 0 ||
        memcmp(limited.lost, inc_limited.lost, sizeof limited.lost) != 0 ||
        memcmp(limited.sides, inc_limited.sides, sizeof limited.sides) != 0 ||
        limited.limited != inc_limited.limited || limited.status != inc_limited.status ||
        limited.iterations != inc_limited.iterations || limited.warm != inc_limited.warm ||
        limited.slack != inc_limited.slack) {
      printf("limited control differs in state %d\n", state);
      return 1;
    }
    cut += limited.limited;
    warm += limited.warm;
  }
  return cut > states / 2 && warm > 0 ? 0 : 1;
}

static int compare_batch(void) {
  double q[n * ARM_STATES], M[n * n * ARM_STATES], inc_M[n * n * ARM_STATES];
  int i;
  for (i = 0; i < n * ARM_STATES; ++i) q[i] = draw(7, i);
  arm_batch_mass_matrix(q, M);
  inc_batch_mass_matrix(q, inc_M);
  if (memcmp(M, inc_M, sizeof M) != 0 || M[0] == M[1]) {
    printf("batches differ\n");
    return 1;
  }
  return 0;
}

int main(void) {
  return compare_limited() != 0 || compare_batch() != 0;
}
