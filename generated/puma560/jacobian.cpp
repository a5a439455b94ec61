// SPDX-License-Identifier: 0BSD
// jacobian: xd = J qd, rows stacked over operational points
// By rows carried inward from each point.
// 72 flops (add 21, mul 51, div 0), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void jacobian(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT J)[36]) noexcept {
  J[5] = 0.0;
  J[11] = 0.0;
  J[12] = 0.0;
  J[17] = 0.0;
  J[18] = 0.0;
  J[24] = 0.0;
  J[31] = 0.0;
  J[32] = 0.0;

  // constants
  const Real link6_to_tool_z = 0.05625;
  const Real minus_link3_to_4_x = 0.0203;
  const Real minus_link3_to_4_y = 0.4331;
  const Real link2_to_3_x = 0.4318;
  const Real link2_to_3_z = 0.1501;

  // sines and cosines
  const Real angles[5] = {q[1], q[2], q[3], q[4], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real s3 = sines[1];
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real c4 = cosines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];
  const Real s1 = sines[4];
  J[19] = -s1;
  J[20] = -s1;
  const Real s4 = sines[2];
  const Real c1 = cosines[4];
  J[25] = c1;
  J[26] = c1;

  // link 6 (link6), Jacobian
  const Real t1 = link6_to_tool_z * s5;
  const Real t2 = link6_to_tool_z * c5;
  J[30] = 1.0;
  const Real minus_c23 = s2 * s3 - c2 * c3;
  J[33] = -minus_c23;
  const Real s23 = s2 * c3 + c2 * s3;

  // link 4 (link4), Jacobian and pose
  const Real t3 = minus_link3_to_4_y + t2;
  const Real t4 = minus_c23 * c1;
  const Real t5 = minus_c23 * s1;
  const Real t6 = c4 * t1 - minus_link3_to_4_x;
  const Real J_3_3 = s23 * c1;
  J[21] = J_3_3;
  const Real J_4_3 = s23 * s1;
  J[27] = J_4_3;
  const Real t7 = c4 * s23;

  // links 3 (link3) and 4 (link4), Jacobian; link 4 (link4), pose
  const Real t8 = link2_to_3_z + s4 * t1;
  const Real J_5_4 = s4 * s23;
  J[34] = J_5_4;
  J[15] = t1 * J_5_4;
  const Real J_2_2 = t6 * minus_c23 - t3 * s23;
  J[14] = J_2_2;
  const Real t9 = t3 * minus_c23 + t6 * s23;

  // link 4 (link4), pose; link 5 (link5), Jacobian
  const Real t10 = c4 * t4 + s4 * s1;
  const Real t11 = s4 * c1 - c4 * t5;
  const Real J_3_4 = s4 * t4 - c4 * s1;
  J[22] = J_3_4;
  const Real J_4_4 = s4 * t5 + c4 * c1;
  J[28] = J_4_4;
  J[16] = t1 * minus_c23 - t2 * t7;

  // links 3 (link3) and 4 (link4), Jacobian
  const Real J_2_1 = J_2_2 - link2_to_3_x * c2;
  J[13] = J_2_1;
  const Real t12 = t9 + link2_to_3_x * s2;
  J[2] = -(t9 * c1);
  J[3] = t1 * J_3_4;
  J[8] = -(t9 * s1);
  J[9] = t1 * J_4_4;

  // link 6 (link6), pose; links 1 and 2, 5, Jacobian
  J[35] = -(s5 * t7 + c5 * minus_c23);
  J[1] = -(t12 * c1);
  J[7] = -(t12 * s1);
  J[4] = -(t1 * J_3_3 + t2 * t10);
  J[10] = t2 * t11 - t1 * J_4_3;
  J[23] = -(s5 * t10 - c5 * J_3_3);
  J[29] = s5 * t11 + c5 * J_4_3;
  J[0] = J_2_1 * s1 - t8 * c1;
  J[6] = -(J_2_1 * c1 + t8 * s1);
}

}  // namespace puma560

#undef TREELINE_RESTRICT
