// Motors carry the arm's weight and nothing else, and a hand leads its tool.
#include <cmath>
#include <cstdio>

#include "arm.hpp"

int main() {
  double q[6] = {0, -0.9, 1.5, -0.6, 1.2, 0}, qd[6] = {}, tau[6], qdd[6];
  const double period[1] = {1e-3};  // s
  double fastest = 0;
  std::printf("time_s,q0,q1,q2,q3,q4,q5\n");
  for (int step = 0; step <= 5000; ++step) {
    // The whole law.
    arm::gravity(q, tau);

    // The plant has friction, as the scene says, and for a second a hand: 30 N to the side and up.
    const bool led = step >= 500 && step < 1500;
    const double hand[6] = {0, led ? 30.0 : 0.0, led ? 30.0 : 0.0, 0, 0, 0};  // N, N m
    arm::forward_dynamics(q, qd, tau, hand, period, qdd);
    if (step % 40 == 0) {
      std::printf("%.3f", period[0] * step);
      for (const double coordinate : q) std::printf(",%.9f", coordinate);
      std::printf("\n");
    }
    fastest = 0;
    for (int i = 0; i < 6; ++i) {
      qd[i] += period[0] * qdd[i];
      q[i] += period[0] * qd[i];
      fastest = std::fmax(fastest, std::fabs(qd[i]));
    }
  }
  std::fprintf(stderr, "3.5 s after the hand let go: %.0e rad/s\n", fastest);
  return fastest < 1e-3 ? 0 : 1;
}
