// SPDX-License-Identifier: 0BSD
// forward_kinematics: x_world = R x_point + p, for every operational point
// By outward recursion.
// 91 flops (add 32, mul 59, div 0), sine and cosine of 7 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void forward_kinematics(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT position)[3],
    Real (&TREELINE_RESTRICT rotation)[9]) noexcept {
  // constants
  const Real minus_link6_to_7_x = 0.0203;
  const Real minus_link6_to_7_y = 0.4331;
  const Real link5_to_6_x = 0.4318;
  const Real link5_to_6_z = 0.1501;
  const Real link9_to_tool_z = 0.05625;
  const Real link3_to_4_z = 1.15;

  // sines and cosines
  const Real angles[7] = {q[2], q[3], q[4], q[5], q[7], q[6], q[8]};
  Real sines[7];
  Real cosines[7];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s3 = sines[0];
  const Real s4 = sines[1];
  const Real c5 = cosines[2];
  const Real s5 = sines[2];
  const Real s6 = sines[3];
  const Real c6 = cosines[3];
  const Real s8 = sines[4];
  const Real c7 = cosines[5];
  const Real s7 = sines[5];
  const Real c8 = cosines[4];
  const Real s9 = sines[6];
  const Real c9 = cosines[6];

  // link 6 (link3), pose
  const Real minus_c56 = s5 * s6 - c5 * c6;
  const Real c34 = c3 * c4 - s3 * s4;
  const Real s34 = s3 * c4 + c3 * s4;
  const Real s56 = s5 * c6 + c5 * s6;
  const Real p6_z = link3_to_4_z - link5_to_6_x * s5;

  // link 7 (link4), pose
  const Real t1 = minus_c56 * c34;
  const Real t2 = minus_c56 * s34;
  const Real t3 = s56 * c34;
  const Real t4 = s56 * s34;
  const Real t5 = c7 * s56;
  const Real t6 = s7 * s56;
  const Real t7 = c7 * t1 + s7 * s34;
  const Real t8 = s7 * t1 - c7 * s34;
  const Real t9 = s7 * c34 - c7 * t2;

  // links 7 to 9, pose
  const Real t10 = link5_to_6_x * c5 + (minus_link6_to_7_x * minus_c56 + minus_link6_to_7_y * s56);
  const Real rotation_8 = s8 * t5 + c8 * minus_c56;
  rotation[8] = -rotation_8;
  const Real t11 = s7 * t2 + c7 * c34;
  const Real t12 = s8 * minus_c56 - c8 * t5;
  const Real p7_z = p6_z + (minus_link6_to_7_x * s56 - minus_link6_to_7_y * minus_c56);

  // link 8 (link5), pose
  const Real rotation_2 = s8 * t7 - c8 * t3;
  rotation[2] = -rotation_2;
  const Real t13 = c8 * t7 + s8 * t3;
  const Real rotation_5 = s8 * t9 + c8 * t4;
  rotation[5] = rotation_5;
  const Real t14 = c8 * t9 - s8 * t4;

  // link 9 (link6), pose
  position[2] = p7_z - link9_to_tool_z * rotation_8;
  rotation[6] = c9 * t12 + s9 * t6;
  rotation[7] = c9 * t6 - s9 * t12;
  rotation[0] = s9 * t8 - c9 * t13;
  rotation[1] = s9 * t13 + c9 * t8;
  rotation[3] = c9 * t14 + s9 * t11;
  rotation[4] = c9 * t11 - s9 * t14;
  position[0] = q[0] - link5_to_6_z * s34 - link9_to_tool_z * rotation_2 + t10 * c34;
  position[1] = q[1] + link5_to_6_z * c34 + link9_to_tool_z * rotation_5 + t10 * s34;
}

}  // namespace samm

#undef TREELINE_RESTRICT
