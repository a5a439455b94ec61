// SPDX-License-Identifier: 0BSD
// forward_kinematics: x_world = R x_point + p, for every operational point
// By outward recursion.
// 73 flops (add 25, mul 48, div 0), sine and cosine of 6 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void forward_kinematics(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT position)[3],
    Real (&TREELINE_RESTRICT rotation)[9]) noexcept {
  // constants
  const Real minus_link2_to_3_x = 0.6127;
  const Real minus_link3_to_4_x = 0.57155;
  const Real link5_to_6_z = 0.11985;
  const Real link4_to_5_z = 0.17415;
  const Real base_to_1_z = 0.1807;
  const Real link6_to_tool_z = 0.11655;

  // sines and cosines
  const Real angles[6] = {q[0], q[1], q[2], q[3], q[4], q[5]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real s1 = sines[0];
  const Real c1 = cosines[0];
  const Real c2 = cosines[1];
  const Real c3 = cosines[2];
  const Real s2 = sines[1];
  const Real s3 = sines[2];
  const Real c4 = cosines[3];
  const Real s4 = sines[3];
  const Real c5 = cosines[4];
  const Real s5 = sines[4];
  const Real c6 = cosines[5];
  const Real s6 = sines[5];
  const Real s23 = s2 * c3 + c2 * s3;

  // links 3 (forearm) and 6 (wrist_3), pose
  const Real c23 = c2 * c3 - s2 * s3;
  const Real p3_z = base_to_1_z - minus_link2_to_3_x * s2;
  const Real c234 = c23 * c4 - s23 * s4;
  const Real s234 = s23 * c4 + c23 * s4;
  const Real t1 = minus_link2_to_3_x * c2 + minus_link3_to_4_x * c23;

  // link 4 (wrist_1), pose
  const Real p4_z = p3_z - minus_link3_to_4_x * s23;
  const Real t2 = c234 * c1;
  const Real t3 = c234 * s1;
  const Real t4 = s234 * c1;
  const Real t5 = s234 * s1;

  // links 5 (wrist_2) and 6 (wrist_3), pose
  const Real rotation_8 = s5 * s234;
  rotation[8] = -rotation_8;
  const Real t6 = c5 * s234;
  const Real p6_z = p4_z - link5_to_6_z * c234;
  const Real rotation_2 = c5 * s1 - s5 * t2;
  rotation[2] = rotation_2;
  const Real rotation_5 = s5 * t3 + c5 * c1;
  rotation[5] = -rotation_5;
  const Real t7 = c5 * t2 + s5 * s1;
  const Real t8 = c5 * t3 - s5 * c1;

  // link 6 (wrist_3), pose
  position[2] = p6_z - link6_to_tool_z * rotation_8;
  rotation[6] = c6 * t6 + s6 * c234;
  rotation[7] = c6 * c234 - s6 * t6;
  rotation[0] = c6 * t7 - s6 * t4;
  rotation[1] = -(s6 * t7 + c6 * t4);
  rotation[3] = c6 * t8 - s6 * t5;
  rotation[4] = -(s6 * t8 + c6 * t5);
  position[0] = link4_to_5_z * s1 + link5_to_6_z * t4 + link6_to_tool_z * rotation_2 - t1 * c1;
  position[1] = link5_to_6_z * t5 - link4_to_5_z * c1 - link6_to_tool_z * rotation_5 - t1 * s1;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
