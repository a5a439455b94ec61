// A program in C that uses generated code: it controls the arm to stay at rest and checks that the
// joint forces are those that carry its weight.
#include <math.h>
#include <stdio.h>

#include "puma560.h"
#include "puma560_joints.h"

int main(void) {
  const puma560_real q[PUMA560_COORDINATES] = {0.1, -0.7, 0.4, 1.2, -0.3, 0.8};
  const puma560_real zero[PUMA560_VELOCITIES] = {0};
  const puma560_real command[PUMA560_TASK_ROWS] = {0};
  puma560_real g[PUMA560_VELOCITIES];
  puma560_real tau[PUMA560_VELOCITIES];
  puma560_gravity(q, g);
  puma560_control_torque(q, zero, zero, command, tau);
  for (int i = 0; i < PUMA560_VELOCITIES; ++i) {
    printf("%s: %g\n", puma560_velocity_names[i], tau[i]);
    // 100 Nm: the arm's weight at full reach.
    if (!(fabs(tau[i] - g[i]) <= 1e-12 * 100) || fabs(tau[i]) > puma560_effort_limits[i]) {
      return 1;
    }
  }
  return fabs(tau[1]) > 1 ? 0 : 1;
}
