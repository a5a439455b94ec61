#include <core/spline.hpp>

#include "arm.hpp"

extern "C" void tick(const float (&q)[6], float (&tau)[6]) {
  const float zero[6] = {};
  arm::inverse_dynamics(q, zero, zero, tau);
}
