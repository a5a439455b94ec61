// Would catch: a limit, a start, an outcome or a row of states by which C++ and C differ: both in
// one program, with the same bits.
#include <cmath>
#include <cstdio>
#include <cstring>

#include "arm_batch.hpp"
#include "arm_limited.hpp"
#include "inc_batch.h"
#include "inc_limited.h"

namespace {

constexpr int n = arm::kVelocities, states = 300;

double draw(int state, int i) {
  return 2 * std::sin(12.9898 * state + 78.233 * i);
}

int compare_limited() {
  arm::LimitedTorque limited{};  // from cycle to cycle
  inc_limited_torque inc_limited{};
  arm::TorqueLimits limits = arm::kTorqueLimits;
  inc_torque_limits inc_limits = inc_default_limits;
  int cut = 0, warm = 0;
  for (int i = 0; i < n; ++i) {
    limits.torque[i] *= 0.9;
    inc_limits.torque[i] *= 0.9;
  }
  for (int state = 0; state < states; ++state) {
    double q[n], qd[n], qdd_0[n], xdd_cmd[arm::kTaskRows], f_wanted[INC_HELD_ROWS];
    double tau[n], inc_tau[n], f[INC_HELD_ROWS], inc_f[INC_HELD_ROWS];
    for (int i = 0; i < n; ++i) {
      q[i] = draw(state / 3, i);  // slowly, so that cycles start from the last
      qd[i] = draw(state, i + n);
      qdd_0[i] = 4 * draw(state, i + 2 * n);
    }
    for (int i = 0; i < arm::kTaskRows; ++i) xdd_cmd[i] = 10 * draw(state, i + 30);
    for (int i = 0; i < INC_HELD_ROWS; ++i) f_wanted[i] = 20 * draw(state, i + 40);
    arm::limited_control_torque(q, qd, qdd_0, xdd_cmd, f_wanted, tau, f, limited, limits);
    inc_limited_control_torque(q, qd, qdd_0, xdd_cmd, f_wanted, inc_tau, inc_f, &inc_limited,
                               &inc_limits);
    if (std::memcmp(tau, inc_tau, sizeof tau) != 0 || std::memcmp(f, inc_f, sizeof f) != 0 ||
        std::memcmp(limited.lost, inc_limited.lost, sizeof limited.lost) != 0 ||
        std::memcmp(limited.sides, inc_limited.sides, sizeof limited.sides) != 0 ||
        limited.limited != inc_limited.limited || limited.status != inc_limited.status ||
        limited.iterations != inc_limited.iterations || limited.warm != inc_limited.warm ||
        limited.slack != inc_limited.slack) {
      std::printf("limited control differs in state %d\n", state);
      return 1;
    }
    cut += limited.limited;
    warm += limited.warm;
  }
  return cut > states / 2 && warm > 0 ? 0 : 1;
}

int compare_batch() {
  constexpr int rows = arm::batch::kStates;
  double q[n][rows], M[n * n][rows], inc_M[n * n][rows];
  for (int i = 0; i < n * rows; ++i) q[i / rows][i % rows] = draw(7, i);
  arm::batch::mass_matrix(q, M);
  inc_batch_mass_matrix(q[0], inc_M[0]);
  if (std::memcmp(M, inc_M, sizeof M) != 0 || M[0][0] == M[0][1]) {
    std::printf("batches differ\n");
    return 1;
  }
  return 0;
}

}  // namespace

int main() {
  return compare_limited() != 0 || compare_batch() != 0;
}
