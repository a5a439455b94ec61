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
  const Real J_2_5_p1 = 0.05625 * s8;
  const Real J_2_5_p2 = 0.05625 * c8;
  J[0] = 1.0;
  J[10] = 1.0;
  J[47] = 1.0;
  J[48] = 1.0;
  const Real J_5_6 = s5 * s6 - c5 * c6;
  J[51] = -J_5_6;
  const Real J_3_4 = s3 * c4 + c3 * s4;
  J[31] = -J_3_4;
  J[32] = -J_3_4;
  const Real J_4_4 = c3 * c4 - s3 * s4;
  J[40] = J_4_4;
  J[41] = J_4_4;
  const Real J_2_5_p3 = s5 * c6 + c5 * s6;

  // link 7 (link4), Jacobian
  const Real J_2_5_p4 = 0.4331 + J_2_5_p2;
  const Real J_2_5_p5 = c7 * J_2_5_p1 - 0.0203;

  // link 7 (link4), pose
  const Real J_0_7_p1 = J_5_6 * J_4_4;
  const Real J_1_7_p1 = J_5_6 * J_3_4;
  const Real J_3_6 = J_2_5_p3 * J_4_4;
  J[33] = J_3_6;
  const Real J_4_6 = J_2_5_p3 * J_3_4;
  J[42] = J_4_6;
  const Real J_2_7_p1 = c7 * J_2_5_p3;

  // link 6 (link3), Jacobian
  const Real J_0_2_p1 = 0.1501 + s7 * J_2_5_p1;

  // link 7 (link4), pose
  const Real J_5_7 = s7 * J_2_5_p3;
  J[52] = J_5_7;

  // link 7 (link4), Jacobian
  const Real J_2_5 = J_2_5_p5 * J_5_6 - J_2_5_p4 * J_2_5_p3;
  J[23] = J_2_5;
  const Real J_0_4_p1 = J_2_5_p4 * J_5_6 + J_2_5_p5 * J_2_5_p3;

  // link 7 (link4), pose
  const Real J_0_7_p2 = c7 * J_0_7_p1 + s7 * J_3_4;
  const Real J_1_7_p2 = s7 * J_4_4 - c7 * J_1_7_p1;
  const Real J_3_7 = s7 * J_0_7_p1 - c7 * J_3_4;
  J[34] = J_3_7;
  const Real J_4_7 = s7 * J_1_7_p1 + c7 * J_4_4;
  J[43] = J_4_7;

  // link 7 (link4), Jacobian
  J[24] = J_2_5_p1 * J_5_7;

  // link 6 (link3), Jacobian
  const Real J_2_4 = J_2_5 - 0.4318 * c5;
  J[22] = J_2_4;
  const Real J_0_4_p2 = J_0_4_p1 + 0.4318 * s5;
  J[5] = -(J_0_4_p1 * J_4_4);
  J[14] = -(J_0_4_p1 * J_3_4);

  // link 7 (link4), Jacobian
  J[6] = J_2_5_p1 * J_3_7;
  J[15] = J_2_5_p1 * J_4_7;

  // link 8 (link5), Jacobian
  J[25] = J_2_5_p1 * J_5_6 - J_2_5_p2 * J_2_7_p1;

  // link 5 (link2), Jacobian
  J[4] = -(J_0_4_p2 * J_4_4);
  J[13] = -(J_0_4_p2 * J_3_4);

  // link 9 (link6), pose
  J[53] = -(s8 * J_2_7_p1 + c8 * J_5_6);

  // link 8 (link5), Jacobian
  J[7] = -(J_2_5_p1 * J_3_6 + J_2_5_p2 * J_0_7_p2);
  J[16] = J_2_5_p2 * J_1_7_p2 - J_2_5_p1 * J_4_6;

  // link 9 (link6), pose
  J[35] = -(s8 * J_0_7_p2 - c8 * J_3_6);
  J[44] = s8 * J_1_7_p2 + c8 * J_4_6;

  // link 5 (link2), Jacobian
  const Real J_0_2 = J_4_4 * J_0_2_p1 - J_3_4 * J_2_4;
  J[2] = -J_0_2;
  J[3] = -J_0_2;
  const Real J_1_2 = J_4_4 * J_2_4 + J_3_4 * J_0_2_p1;
  J[11] = -J_1_2;
  J[12] = -J_1_2;
}

}  // namespace samm

#undef TREELINE_RESTRICT
