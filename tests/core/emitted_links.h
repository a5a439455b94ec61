#pragma once

// Arguments and results of a robot with a floating base and two joints: emitted_links.c.

#ifdef __cplusplus
extern "C" {
#endif

struct LinkState {
  double q[9], sin_q[9], cos_q[9], qd[8], qdd[8], xdd_cmd[2];
};

struct LinkDynamics {
  double tau[8], h[8], g[8], M[64], qdd[8], Lambda_inv[4], Lambda[4], torque[8];
};

void links_in_c(const struct LinkState* state, struct LinkDynamics* dynamics);

#ifdef __cplusplus
}
#endif
