// SPDX-License-Identifier: 0BSD
// jacobian: xd = J qd, rows stacked over operational points
// By rows carried inward from each point.
// 78 flops (add 23, mul 55, div 0), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void jacobian(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT J)[54]) noexcept {
  J[1] = 0.0;
  J[8] = 0.0;
  J[9] = 0.0;
  J[17] = 0.0;
  J[18] = 0.0;
  J[19] = 0.0;
  J[20] = 0.0;
  J[21] = 0.0;
  J[26] = 0.0;
  J[27] = 0.0;
  J[28] = 0.0;
  J[29] = 0.0;
  J[30] = 0.0;
  J[36] = 0.0;
  J[37] = 0.0;
  J[38] = 0.0;
  J[39] = 0.0;
  J[45] = 0.0;
  J[46] = 0.0;
  J[49] = 0.0;
  J[50] = 0.0;

  // constants
  const Real link9_to_tool_z = 0.05625;
  const Real minus_link6_to_7_x = 0.0203;
  const Real minus_link6_to_7_y = 0.4331;
  const Real link5_to_6_x = 0.4318;
  const Real link5_to_6_z = 0.1501;

  // sines and cosines
  const Real angles[6] = {q[2], q[3], q[6], q[7], q[4], q[5]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s3 = sines[0];
  const Real s4 = sines[1];
  const Real s7 = sines[2];
  const Real s8 = sines[3];
  const Real s5 = sines[4];
  const Real s6 = sines[5];
  const Real c5 = cosines[4];
  const Real c6 = cosines[5];
  const Real c7 = cosines[2];
  const Real c8 = cosines[3];

  // link 9 (link6), Jacobian
  const Real t1 = link9_to_tool_z * s8;
  const Real t2 = link9_to_tool_z * c8;
  J[0] = 1.0;
  J[10] = 1.0;
  J[47] = 1.0;
  J[48] = 1.0;
  const Real minus_c56 = s5 * s6 - c5 * c6;
  J[51] = -minus_c56;
  const Real s34 = s3 * c4 + c3 * s4;
  J[31] = -s34;
  J[32] = -s34;
  const Real c34 = c3 * c4 - s3 * s4;

  // link 7 (link4), Jacobian
  J[40] = c34;
  J[41] = c34;
  const Real s56 = s5 * c6 + c5 * s6;
  const Real t3 = minus_link6_to_7_y + t2;
  const Real t4 = c7 * t1 - minus_link6_to_7_x;

  // link 7 (link4), pose; link 6 (link3), Jacobian
  const Real t5 = minus_c56 * c34;
  const Real t6 = minus_c56 * s34;
  const Real J_3_6 = s56 * c34;
  J[33] = J_3_6;
  const Real J_4_6 = s56 * s34;
  J[42] = J_4_6;
  const Real t7 = c7 * s56;
  const Real t8 = link5_to_6_z + s7 * t1;
  const Real J_5_7 = s7 * s56;
  J[52] = J_5_7;

  // link 7 (link4), Jacobian and pose
  const Real J_2_5 = t4 * minus_c56 - t3 * s56;
  J[23] = J_2_5;
  const Real t9 = t3 * minus_c56 + t4 * s56;
  const Real t10 = c7 * t5 + s7 * s34;
  const Real t11 = s7 * c34 - c7 * t6;
  const Real J_3_7 = s7 * t5 - c7 * s34;
  J[34] = J_3_7;
  const Real J_4_7 = s7 * t6 + c7 * c34;
  J[43] = J_4_7;
  J[24] = t1 * J_5_7;

  // link 6 (link3), Jacobian
  const Real J_2_4 = J_2_5 - link5_to_6_x * c5;
  J[22] = J_2_4;
  const Real t12 = t9 + link5_to_6_x * s5;
  J[5] = -(t9 * c34);
  J[14] = -(t9 * s34);

  // links 5, 7 and 8, Jacobian
  J[6] = t1 * J_3_7;
  J[15] = t1 * J_4_7;
  J[25] = t1 * minus_c56 - t2 * t7;
  J[4] = -(t12 * c34);
  J[13] = -(t12 * s34);

  // link 9 (link6), pose; link 8 (link5), Jacobian
  J[53] = -(s8 * t7 + c8 * minus_c56);
  J[7] = -(t1 * J_3_6 + t2 * t10);
  J[16] = t2 * t11 - t1 * J_4_6;
  J[35] = -(s8 * t10 - c8 * J_3_6);
  J[44] = s8 * t11 + c8 * J_4_6;

  // link 5 (link2), Jacobian
  const Real J_0_2 = c34 * t8 - s34 * J_2_4;
  J[2] = -J_0_2;
  J[3] = -J_0_2;
  const Real J_1_2 = c34 * J_2_4 + s34 * t8;
  J[11] = -J_1_2;
  J[12] = -J_1_2;
}

}  // namespace samm

#undef TREELINE_RESTRICT
