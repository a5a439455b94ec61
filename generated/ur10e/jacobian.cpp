// jacobian: xd = J qd, rows stacked over operational points
// By from the poses of all links.
// 105 flops (add 34, mul 71, div 0), sine and cosine of 5 angles
// Generated; see ur10e.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void jacobian(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT J)[36]) noexcept {
  J[12] = 0.0;
  J[18] = 0.0;
  J[24] = 0.0;
  J[31] = 0.0;
  J[32] = 0.0;
  J[33] = 0.0;
  const Real angles[5] = {q[3], q[2], q[1], q[0], q[4]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s4 = sines[0];
  const Real c3 = cosines[1];
  const Real c2 = cosines[2];
  const Real s1 = sines[3];
  J[19] = s1;
  J[20] = s1;
  J[21] = s1;
  const Real s3 = sines[1];
  const Real s2 = sines[2];
  const Real c4 = cosines[0];
  const Real s5 = sines[4];
  const Real c5 = cosines[4];
  const Real c1 = cosines[3];
  J[25] = -c1;
  J[26] = -c1;
  J[27] = -c1;

  // link 2 (upper_arm), pose
  const Real J_4_5_p1 = c2 * s1;
  const Real J_4_5_p2 = s2 * s1;
  const Real J_3_5_p1 = c2 * c1;
  const Real J_3_5_p2 = s2 * c1;

  // link 3 (forearm), pose
  J[30] = 1.0;
  const Real J_5_5_p1 = c3 * s2 + s3 * c2;
  const Real J_5_5_p2 = c3 * c2 - s3 * s2;
  const Real minus_p3_y = 0.6127 * J_4_5_p1;
  const Real minus_p3_x = 0.6127 * J_3_5_p1;
  const Real J_4_5_p3 = c3 * J_4_5_p1 - s3 * J_4_5_p2;
  const Real J_4_5_p4 = s3 * J_4_5_p1 + c3 * J_4_5_p2;
  const Real J_3_5_p3 = c3 * J_3_5_p1 - s3 * J_3_5_p2;
  const Real J_3_5_p4 = s3 * J_3_5_p1 + c3 * J_3_5_p2;

  // link 4 (wrist_1), pose
  const Real J_5_4 = c4 * J_5_5_p2 - s4 * J_5_5_p1;
  J[34] = -J_5_4;
  const Real J_4_4 = s4 * J_4_5_p3 + c4 * J_4_5_p4;
  J[28] = J_4_4;
  const Real J_3_4 = s4 * J_3_5_p3 + c4 * J_3_5_p4;
  J[22] = J_3_4;

  // link 5 (wrist_2), pose
  const Real J_5_5 = s5 * (c4 * J_5_5_p1 + s4 * J_5_5_p2);
  J[35] = -J_5_5;

  // link 6 (wrist_3), pose
  const Real J_0_1_p1 = 0.11655 * J_5_5;

  // link 5 (wrist_2), pose
  const Real J_4_5 = s5 * (c4 * J_4_5_p3 - s4 * J_4_5_p4) + c5 * c1;
  J[29] = -J_4_5;
  const Real J_3_5 = c5 * s1 - s5 * (c4 * J_3_5_p3 - s4 * J_3_5_p4);
  J[23] = J_3_5;

  // link 6 (wrist_3), Jacobian
  const Real J_0_1_p2 = J_0_1_p1 + 0.11985 * J_5_4;

  // link 6 (wrist_3), pose
  const Real J_0_0_p1 = 0.11655 * J_4_5;
  const Real J_1_0_p1 = 0.11655 * J_3_5;

  // link 4 (wrist_1), Jacobian
  const Real J_0_1_p3 = J_0_1_p2 + 0.57155 * J_5_5_p1;
  J[3] = c1 * J_0_1_p2;
  J[9] = s1 * J_0_1_p2;

  // link 6 (wrist_3), Jacobian
  const Real J_0_0_p2 = 0.11985 * J_4_4 - J_0_0_p1;
  const Real J_1_0_p2 = J_1_0_p1 + 0.11985 * J_3_4;

  // link 3 (forearm), Jacobian
  const Real J_0_1_p4 = J_0_1_p3 + 0.6127 * s2;
  J[2] = c1 * J_0_1_p3;
  J[8] = s1 * J_0_1_p3;

  // link 5 (wrist_2), Jacobian
  const Real J_0_0_p3 = J_0_0_p2 - 0.17415 * c1;
  const Real J_1_0_p3 = J_1_0_p2 + 0.17415 * s1;

  // link 2 (upper_arm), Jacobian
  J[1] = c1 * J_0_1_p4;
  J[7] = s1 * J_0_1_p4;

  // link 6 (wrist_3), Jacobian
  J[5] = J_4_5 * J_0_1_p1 - J_5_5 * J_0_0_p1;
  J[11] = J_3_5 * J_0_1_p1 - J_5_5 * J_1_0_p1;
  J[17] = J_4_5 * J_1_0_p1 - J_3_5 * J_0_0_p1;

  // link 4 (wrist_1), Jacobian
  const Real J_0_0_p4 = J_0_0_p3 - 0.57155 * J_4_5_p3;
  const Real J_1_0_p4 = J_1_0_p3 - 0.57155 * J_3_5_p3;

  // link 5 (wrist_2), Jacobian
  J[4] = J_5_4 * J_0_0_p2 - J_4_4 * J_0_1_p2;
  J[10] = J_3_4 * J_0_1_p2 - J_5_4 * J_1_0_p2;
  J[16] = J_3_4 * J_0_0_p2 - J_4_4 * J_1_0_p2;

  // link 3 (forearm), Jacobian
  const Real J_0_0 = J_0_0_p4 - minus_p3_y;
  J[0] = -J_0_0;
  const Real J_1_0 = J_1_0_p4 - minus_p3_x;
  J[6] = J_1_0;

  // link 4 (wrist_1), Jacobian
  J[15] = s1 * J_0_0_p3 + c1 * J_1_0_p3;

  // link 3 (forearm), Jacobian
  J[14] = s1 * J_0_0_p4 + c1 * J_1_0_p4;

  // link 2 (upper_arm), Jacobian
  J[13] = s1 * J_0_0 + c1 * J_1_0;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
