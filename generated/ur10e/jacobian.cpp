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
  const Real J_0_4_p1 = 0.11655 * s5;
  const Real J_0_0_p1 = 0.11655 * c5;

  // link 6 (wrist_3), pose
  J[30] = 1.0;
  const Real J_2_3_p1 = s2 * c3 + c2 * s3;
  const Real J_2_3_p2 = c2 * c3 - s2 * s3;

  // link 5 (wrist_2), Jacobian
  const Real J_0_0_p2 = 0.17415 + J_0_0_p1;
  const Real J_2_3_p3 = J_2_3_p1 * c4 + J_2_3_p2 * s4;
  const Real J_5_4 = J_2_3_p2 * c4 - J_2_3_p1 * s4;
  J[34] = -J_5_4;

  // link 5 (wrist_2), pose
  const Real J_0_4_p2 = J_5_4 * c1;
  const Real J_1_4_p1 = J_5_4 * s1;

  // link 5 (wrist_2), Jacobian
  J[16] = -(J_0_0_p1 * J_2_3_p3);

  // link 5 (wrist_2), pose
  J[22] = J_2_3_p3 * c1;
  J[28] = J_2_3_p3 * s1;

  // link 6 (wrist_3), pose
  J[35] = -(s5 * J_2_3_p3);

  // link 5 (wrist_2), Jacobian
  const Real J_2_3 = 0.11985 * J_2_3_p3 - J_5_4 * J_0_4_p1;
  J[15] = J_2_3;
  const Real J_0_1_p1 = J_2_3_p3 * J_0_4_p1 + 0.11985 * J_5_4;

  // link 4 (wrist_1), Jacobian
  const Real J_2_2 = J_2_3 - 0.57155 * J_2_3_p2;
  J[14] = J_2_2;
  const Real J_0_1_p2 = J_0_1_p1 + 0.57155 * J_2_3_p1;
  J[3] = J_0_1_p1 * c1;
  J[9] = J_0_1_p1 * s1;

  // link 5 (wrist_2), Jacobian
  J[4] = -(J_0_4_p1 * s1 + J_0_0_p1 * J_0_4_p2);
  J[10] = J_0_4_p1 * c1 - J_0_0_p1 * J_1_4_p1;

  // link 6 (wrist_3), pose
  J[23] = -(s5 * J_0_4_p2 - c5 * s1);
  J[29] = -(s5 * J_1_4_p1 + c5 * c1);

  // link 3 (forearm), Jacobian
  const Real J_2_1 = J_2_2 - 0.6127 * c2;
  J[13] = J_2_1;
  const Real J_0_1_p3 = J_0_1_p2 + 0.6127 * s2;
  J[2] = J_0_1_p2 * c1;
  J[8] = J_0_1_p2 * s1;

  // link 2 (upper_arm), Jacobian
  J[1] = J_0_1_p3 * c1;
  J[7] = J_0_1_p3 * s1;

  // link 1 (shoulder), Jacobian
  J[0] = J_0_0_p2 * c1 - J_2_1 * s1;
  J[6] = J_2_1 * c1 + J_0_0_p2 * s1;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
