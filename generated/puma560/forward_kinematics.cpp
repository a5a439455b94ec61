// SPDX-License-Identifier: 0BSD
// forward_kinematics: x_world = R x_point + p, for every operational point
// By outward recursion.
// 83 flops (add 28, mul 55, div 0), sine and cosine of 6 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void forward_kinematics(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT position)[3],
    Real (&TREELINE_RESTRICT rotation)[9]) noexcept {
  // constants
  const Real minus_link3_to_4_x = 0.0203;
  const Real minus_link3_to_4_y = 0.4331;
  const Real link2_to_3_x = 0.4318;
  const Real link6_to_tool_z = 0.05625;
  const Real link2_to_3_z = 0.1501;
  const Real base_to_1_z = 0.6718;

  // sines and cosines
  const Real angles[6] = {q[0], q[1], q[2], q[4], q[3], q[5]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c1 = cosines[0];
  const Real c2 = cosines[1];
  const Real s1 = sines[0];
  const Real s2 = sines[1];
  const Real s3 = sines[2];
  const Real c3 = cosines[2];
  const Real s5 = sines[3];
  const Real c4 = cosines[4];
  const Real s4 = sines[4];
  const Real c5 = cosines[3];
  const Real s6 = sines[5];
  const Real c6 = cosines[5];
  const Real minus_c23 = s2 * s3 - c2 * c3;
  const Real s23 = s2 * c3 + c2 * s3;

  // links 3 (link3) and 4 (link4), pose
  const Real p3_z = base_to_1_z - link2_to_3_x * s2;
  const Real t1 = minus_c23 * c1;
  const Real t2 = minus_c23 * s1;
  const Real t3 = s23 * c1;
  const Real t4 = s23 * s1;
  const Real t5 = c4 * s23;
  const Real t6 = s4 * s23;
  const Real t7 = c4 * t1 + s4 * s1;
  const Real t8 = s4 * c1 - c4 * t2;

  // links 4 to 6, pose
  const Real t9 = link2_to_3_x * c2 + (minus_link3_to_4_x * minus_c23 + minus_link3_to_4_y * s23);
  const Real rotation_8 = s5 * t5 + c5 * minus_c23;
  rotation[8] = -rotation_8;
  const Real t10 = s4 * t1 - c4 * s1;
  const Real p4_z = p3_z + (minus_link3_to_4_x * s23 - minus_link3_to_4_y * minus_c23);
  const Real t11 = s4 * t2 + c4 * c1;

  // link 5 (link5), pose
  const Real t12 = s5 * minus_c23 - c5 * t5;
  const Real rotation_2 = s5 * t7 - c5 * t3;
  rotation[2] = -rotation_2;
  const Real rotation_5 = s5 * t8 + c5 * t4;
  rotation[5] = rotation_5;
  const Real t13 = c5 * t7 + s5 * t3;
  const Real t14 = c5 * t8 - s5 * t4;

  // link 6 (link6), pose
  position[2] = p4_z - link6_to_tool_z * rotation_8;
  rotation[6] = c6 * t12 + s6 * t6;
  rotation[7] = c6 * t6 - s6 * t12;
  rotation[0] = s6 * t10 - c6 * t13;
  rotation[1] = s6 * t13 + c6 * t10;
  rotation[3] = c6 * t14 + s6 * t11;
  rotation[4] = c6 * t11 - s6 * t14;
  position[0] = t9 * c1 - (link2_to_3_z * s1 + link6_to_tool_z * rotation_2);
  position[1] = link2_to_3_z * c1 + link6_to_tool_z * rotation_5 + t9 * s1;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
