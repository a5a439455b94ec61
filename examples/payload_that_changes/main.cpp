// An arm grips a load on its way and lets go of it: once the law is told, and once it is not.
#include <cmath>
#include <cstdio>

#include "arm.hpp"

// Moves for four seconds; returns the largest error of a joint, rad.
double carry(bool told, std::FILE* motion) {
  const double from[6] = {-0.8, -0.6, 0.6, 0, 0.8, 0}, to[6] = {0.8, -1.1, 0.9, 0, 0.9, 0};
  // 4 kg in the gripper, 0.15 m before the flange: m, m c, and the tensor about the flange.
  const double load[10] = {4, 0, 0, 0.6, 0.11, 0, 0.11, 0, 0, 0.01}, none[10] = {};
  double q[6], qd[6] = {}, worst = 0;
  for (int i = 0; i < 6; ++i) q[i] = from[i];
  for (int step = 0; step <= 4000; ++step) {
    const double time = 1e-3 * step, turn = std::acos(-1.0) / 4;  // rad/s of the cosine
    const bool loaded = time >= 1 && time < 3;
    double qdd[6], tau[6];
    for (int i = 0; i < 6; ++i) {  // the wanted motion, and what leads back to it
      const double half = (to[i] - from[i]) / 2;
      const double error = from[i] + half * (1 - std::cos(turn * time)) - q[i];
      const double rate = half * turn * std::sin(turn * time) - qd[i];
      qdd[i] = half * turn * turn * std::cos(turn * time) + 100 * error + 20 * rate;
      worst = std::fmax(worst, std::fabs(error));
    }
    arm::inverse_dynamics(q, qd, qdd, loaded && told ? load : none, tau);  // the law
    arm::forward_dynamics(q, qd, tau, loaded ? load : none, qdd);          // the plant
    if (motion && step % 50 == 0) {
      std::fprintf(motion, "%.3f", time);
      for (const double coordinate : q) std::fprintf(motion, ",%.9f", coordinate);
      std::fprintf(motion, "\n");
    }
    for (int i = 0; i < 6; ++i) {
      qd[i] += 1e-3 * qdd[i];
      q[i] += 1e-3 * qd[i];
    }
  }
  return worst;
}

int main() {
  std::printf("time_s,q0,q1,q2,q3,q4,q5\n");
  const double untold = carry(false, stdout), told = carry(true, nullptr);
  std::fprintf(stderr, "largest error of a joint: %.1f mrad, and %.1f mrad where the law is told\n",
               1e3 * untold, 1e3 * told);
  return told < untold / 10 ? 0 : 1;
}
