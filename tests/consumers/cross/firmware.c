#include "arm_c.h"

void tick_c(const float q[6], float tau[6]) {
  const float zero[6] = {0};
  arm_c_inverse_dynamics(q, zero, zero, tau);
}
