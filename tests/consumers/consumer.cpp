// A program that uses generated code: it holds the arm at rest and checks that the joint forces are
// those that it was given.
#include <cmath>
#include <cstdio>

#include "puma560.hpp"

int main() {
  const puma560::Real q[puma560::kCoordinates] = {0.1, -0.7, 0.4, 1.2, -0.3, 0.8};
  const puma560::Real zero[puma560::kVelocities] = {};
  puma560::Real g[puma560::kVelocities];
  puma560::Real tau[puma560::kVelocities];
  puma560::gravity(q, g);
  puma560::inverse_dynamics(q, zero, zero, tau);
  for (int i = 0; i < puma560::kVelocities; ++i) {
    std::printf("%g\n", tau[i]);
    if (!(std::fabs(tau[i] - g[i]) <= 1e-12 * 100)) {  // 100 Nm: the arm's weight at full reach
      return 1;
    }
  }
  return std::fabs(tau[1]) > 1 ? 0 : 1;
}
