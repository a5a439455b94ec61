#include <cmath>

#include "arm.hpp"
#include "report/ticks.hpp"

/// Fails where the stretched arm of a UR5 does not need torque in its shoulder to stay there, and
/// where the part that prints is not linked with this system's fmt.
int main() {
  const double q[6] = {};
  double torques[6];
  arm::gravity(q, torques);
  const bool rests = std::abs(torques[0]) < 1e-12 && std::abs(torques[1]) > 50;
  return rests && treeline::report::tick_label(2, 1) == "2.0" ? 0 : 1;
}
