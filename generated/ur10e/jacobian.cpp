// SPDX-License-Identifier: 0BSD
// jacobian: xd = J qd, rows stacked over operational points
// By rows carried inward from each point.
// 59 flops (add 17, mul 42, div 0), sine and cosine of 5 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void jacobian(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT J)[36]) noexcept {
  J[5] = 0.0;
  J[11] = 0.0;
  J[12] = 0.0;
  J[17] = 0.0;
  J[18] = 0.0;
  J[24] = 0.0;
  J[31] = 0.0;
  J[32] = 0.0;
  J[33] = 0.0;

  // constants
  const Real link6_to_tool_z = 0.11655;
  const Real link5_to_6_z = 0.11985;
  const Real minus_link3_to_4_x = 0.57155;
  const Real minus_link2_to_3_x = 0.6127;
  const Real link4_to_5_z = 0.17415;

  // sines and cosines
  const Real angles[5] = {q[4], q[0], q[1], q[2], q[3]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real c5 = cosines[0];
  const Real c1 = cosines[1];
  J[25] = -c1;
  J[26] = -c1;
  J[27] = -c1;
  const Real s2 = sines[2];
  const Real c3 = cosines[3];
  const Real c2 = cosines[2];
  const Real s3 = sines[3];
  const Real c4 = cosines[4];
  const Real s4 = sines[4];
  const Real s5 = sines[0];
  const Real s1 = sines[1];
  J[19] = s1;
  J[20] = s1;
  J[21] = s1;

  // link 6 (wrist_3), Jacobian
  const Real t1 = link6_to_tool_z * s5;
  const Real t2 = link6_to_tool_z * c5;
  J[30] = 1.0;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real c23 = c2 * c3 - s2 * s3;

  // link 5 (wrist_2), Jacobian and pose
  const Real t3 = link4_to_5_z + t2;
  const Real s234 = s23 * c4 + c23 * s4;
  const Real c234 = c23 * c4 - s23 * s4;
  J[34] = -c234;
  const Real t4 = c234 * c1;
  const Real t5 = c234 * s1;
  J[16] = -(t2 * s234);
  J[22] = s234 * c1;
  J[28] = s234 * s1;

  // link 6 (wrist_3), pose; links 4 (wrist_1) and 5 (wrist_2), Jacobian
  J[35] = -(s5 * s234);
  const Real J_2_3 = link5_to_6_z * s234 - c234 * t1;
  J[15] = J_2_3;
  const Real t6 = s234 * t1 + link5_to_6_z * c234;
  const Real J_2_2 = J_2_3 - minus_link3_to_4_x * c23;
  J[14] = J_2_2;
  const Real t7 = t6 + minus_link3_to_4_x * s23;
  J[3] = t6 * c1;
  J[9] = t6 * s1;
  J[4] = -(t1 * s1 + t2 * t4);
  J[10] = t1 * c1 - t2 * t5;
  J[23] = -(s5 * t4 - c5 * s1);
  J[29] = -(s5 * t5 + c5 * c1);

  // links 1 to 3, Jacobian
  const Real J_2_1 = J_2_2 - minus_link2_to_3_x * c2;
  J[13] = J_2_1;
  const Real t8 = t7 + minus_link2_to_3_x * s2;
  J[2] = t7 * c1;
  J[8] = t7 * s1;
  J[1] = t8 * c1;
  J[7] = t8 * s1;
  J[0] = t3 * c1 - J_2_1 * s1;
  J[6] = J_2_1 * c1 + t3 * s1;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
