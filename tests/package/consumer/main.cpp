#include <cmath>

#include "arm.hpp"

/// Fails where the stretched arm of a UR5 does not need torque in its shoulder to stay there.
int main() {
  const double q[6] = {};
  double torques[6];
  arm::gravity(q, torques);
  return std::abs(torques[0]) < 1e-12 && std::abs(torques[1]) > 50 ? 0 : 1;
}
