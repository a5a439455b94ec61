// SPDX-License-Identifier: 0BSD
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

  // constants; sines and cosines
  const Real minus_gravity_z = 9.81;
  const Real minus_h_8_y = 0.0028799999999999997;
  const Real h_5_y = 0.10439999999999999;
  const Real h_5_x = 3.79559;
  const Real angles[4] = {q[4], q[5], q[6], q[7]};

  // sines and cosines
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
  const Real s56 = s5 * c6 + c5 * s6;

  // links 6 (link3) and 7 (link4), outward
  const Real minus_c56 = s5 * s6 - c5 * c6;
  const Real minus_a6_x = minus_gravity_z * s56;
  const Real a6_y = minus_gravity_z * minus_c56;
  const Real minus_a7_x = c7 * minus_a6_x;
  const Real a7_y = s7 * minus_a6_x;

  // link 8 (link5), inertial wrench and outward and inward
  const Real minus_n8_x = minus_h_8_y * a7_y;
  const Real a8_x = s8 * a6_y - c8 * minus_a7_x;
  const Real minus_n7_x = c8 * minus_n8_x;
  const Real n7_z = s8 * minus_n8_x;
  g[6] = n7_z;
  const Real n8_z = minus_h_8_y * a8_x;
  g[7] = n8_z;

  // links 6 (link3) and 7 (link4), inward
  const Real minus_n6_x = c7 * minus_n7_x + s7 * n8_z;
  const Real n6_z = c7 * n8_z - s7 * minus_n7_x - (0.24892874999999998 * minus_c56 + 8.45420895 *
      s56);
  g[5] = n6_z;
  const Real n5_z = minus_gravity_z * (h_5_y * s5 - h_5_x * c5) + n6_z;
  g[4] = n5_z;
  const Real n5_y = s56 * minus_n6_x - minus_c56 * n7_z;
  g[2] = n5_y;
  g[3] = n5_y;
}

}  // namespace samm

#undef TREELINE_RESTRICT
