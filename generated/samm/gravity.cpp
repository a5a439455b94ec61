// gravity: g: the joint forces that hold the robot at rest
// By recursive Newton-Euler, Chang table 4.1.
// 35 flops (add 10, mul 25, div 0), sine and cosine of 4 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void gravity(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT g)[9]) noexcept {
  g[0] = 0.0;
  g[1] = 0.0;
  g[8] = 0.0;
  const Real angles[4] = {q[4], q[5], q[6], q[7]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s5 = sines[0];
  const Real c6 = cosines[1];
  const Real c5 = cosines[0];
  const Real s6 = sines[1];
  const Real c7 = cosines[2];
  const Real c8 = cosines[3];
  const Real s7 = sines[2];
  const Real s8 = sines[3];
  const Real minus_a6_x_p1 = s5 * c6 + c5 * s6;
  const Real a6_y_p1 = s5 * s6 - c5 * c6;

  // link 6 (link3), outward
  const Real minus_a6_x = 9.81 * minus_a6_x_p1;
  const Real a6_y = 9.81 * a6_y_p1;

  // link 7 (link4), outward
  const Real minus_a7_x = c7 * minus_a6_x;
  const Real a7_y = s7 * minus_a6_x;

  // link 8 (link5), inertial wrench
  const Real minus_n8_x = 0.0028799999999999997 * a7_y;

  // link 8 (link5), outward
  const Real a8_x = s8 * a6_y - c8 * minus_a7_x;

  // link 8 (link5), inward
  const Real minus_n7_x = c8 * minus_n8_x;
  const Real n7_z = s8 * minus_n8_x;
  g[6] = n7_z;

  // link 8 (link5), inertial wrench
  const Real n8_z = 0.0028799999999999997 * a8_x;
  g[7] = n8_z;

  // link 7 (link4), inward
  const Real minus_n6_x = c7 * minus_n7_x + s7 * n8_z;
  const Real n6_z = c7 * n8_z - s7 * minus_n7_x - (0.24892875 * a6_y_p1 + 8.45420895 *
      minus_a6_x_p1);
  g[5] = n6_z;

  // link 6 (link3), inward
  const Real n5_z = 9.81 * (0.10439999999999999 * s5 - 3.79559 * c5) + n6_z;
  g[4] = n5_z;
  const Real n5_y = minus_a6_x_p1 * minus_n6_x - a6_y_p1 * n7_z;
  g[2] = n5_y;
  g[3] = n5_y;
}

}  // namespace samm

#undef TREELINE_RESTRICT
