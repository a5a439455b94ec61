// A motor turns the crank of a four-bar, whose loop the scene closes.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "four_bar.hpp"

// Newton's method: moves the joints without a motor until the loop is closed.
void close_loop(double (&q)[3]) {
  for (int round = 0; round < 10; ++round) {
    double e[2], J[6];
    four_bar::constraint_errors(q, e);
    four_bar::constraint_jacobian(q, J);
    const double determinant = J[1] * J[5] - J[2] * J[4];
    q[1] -= (J[5] * e[0] - J[2] * e[1]) / determinant;
    q[2] -= (J[1] * e[1] - J[4] * e[0]) / determinant;
  }
}

int main() {
  double q[3] = {0, -0.5, 0}, qd[3] = {};
  close_loop(q);
  const double closing[2] = {100, 2500};  // 1/s, 1/s^2: leads back what integration lets drift
  double least = q[2], most = q[2], open = 0;
  std::printf("time_s,q0,q1,q2\n");
  for (int step = 0; step <= 20000; ++step) {
    const double tau[3] = {5 * (3 - qd[0]), 0, 0};  // a motor that holds 3 rad/s
    double qdd[3], f[2], e[2];
    four_bar::constrained_forward_dynamics(q, qd, tau, closing, qdd, f);
    four_bar::constraint_errors(q, e);
    least = std::min(least, q[2]);
    most = std::max(most, q[2]);
    open = std::max({open, std::fabs(e[0]), std::fabs(e[1])});
    if (step % 200 == 0) std::printf("%.3f,%.9f,%.9f,%.9f\n", 2e-4 * step, q[0], q[1], q[2]);
    for (int i = 0; i < 3; ++i) {
      qd[i] += 2e-4 * qdd[i];
      q[i] += 2e-4 * qd[i];
    }
  }
  // Where crank and coupler are in line, 0.35 +- 0.12 m reach from the crank's pivot to the
  // rocker's end.
  const auto turned = [](double reach) { return std::acos(1 - reach * reach / (2 * 0.3 * 0.3)); };
  const double degrees = 180 / std::acos(-1.0);
  std::fprintf(stderr, "the rocker swings by %.2f deg, by geometry %.2f deg\n",
               degrees * (most - least), degrees * (turned(0.47) - turned(0.23)));
  std::fprintf(stderr, "the loop is open by %.0e m at most\n", open);
  return open < 1e-4 ? 0 : 1;
}
