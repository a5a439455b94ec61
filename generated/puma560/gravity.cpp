// SPDX-License-Identifier: 0BSD
// gravity: g: the joint forces that hold the robot at rest
// By recursive Newton-Euler, Chang table 4.1.
// 35 flops (add 10, mul 25, div 0), sine and cosine of 4 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void gravity(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT g)[6]) noexcept {
  g[5] = 0.0;

  // constants; sines and cosines
  const Real minus_gravity_z = 9.81;
  const Real minus_h_5_y = 0.0028799999999999997;
  const Real h_2_y = 0.10439999999999999;
  const Real h_2_x = 3.79559;
  const Real angles[4] = {q[1], q[2], q[3], q[4]};

  // sines and cosines
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real c5 = cosines[3];
  const Real s4 = sines[2];
  const Real s5 = sines[3];
  const Real s23 = s2 * c3 + c2 * s3;

  // links 3 (link3) and 4 (link4), outward
  const Real minus_c23 = s2 * s3 - c2 * c3;
  const Real minus_a3_x = minus_gravity_z * s23;
  const Real a3_y = minus_gravity_z * minus_c23;
  const Real minus_a4_x = c4 * minus_a3_x;
  const Real a4_y = s4 * minus_a3_x;

  // link 5 (link5), inertial wrench and outward and inward
  const Real minus_n5_x = minus_h_5_y * a4_y;
  const Real a5_x = s5 * a3_y - c5 * minus_a4_x;
  const Real minus_n4_x = c5 * minus_n5_x;
  const Real n4_z = s5 * minus_n5_x;
  g[3] = n4_z;
  const Real n5_z = minus_h_5_y * a5_x;
  g[4] = n5_z;

  // links 3 (link3) and 4 (link4), inward
  const Real minus_n3_x = c4 * minus_n4_x + s4 * n5_z;
  const Real n3_z = c4 * n5_z - s4 * minus_n4_x - (0.24892874999999998 * minus_c23 + 8.45420895 *
      s23);
  g[2] = n3_z;
  const Real n2_z = minus_gravity_z * (h_2_y * s2 - h_2_x * c2) + n3_z;
  g[1] = n2_z;
  const Real n2_y = s23 * minus_n3_x - minus_c23 * n4_z;
  g[0] = n2_y;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
