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
  const Real J_2_2_p1 = 0.05625 * s5;
  const Real J_2_2_p2 = 0.05625 * c5;

  // link 4 (link4), pose
  J[30] = 1.0;
  const Real J_5_3 = s2 * s3 - c2 * c3;
  J[33] = -J_5_3;
  const Real J_2_2_p3 = s2 * c3 + c2 * s3;

  // link 4 (link4), Jacobian
  const Real J_2_2_p4 = 0.4331 + J_2_2_p2;

  // link 4 (link4), pose
  const Real J_0_4_p1 = J_5_3 * c1;
  const Real J_1_4_p1 = J_5_3 * s1;

  // link 4 (link4), Jacobian
  const Real J_2_2_p5 = c4 * J_2_2_p1 - 0.0203;

  // link 4 (link4), pose
  const Real J_3_3 = J_2_2_p3 * c1;
  J[21] = J_3_3;
  const Real J_4_3 = J_2_2_p3 * s1;
  J[27] = J_4_3;
  const Real J_2_4_p1 = c4 * J_2_2_p3;

  // link 3 (link3), Jacobian
  const Real J_0_0_p1 = 0.1501 + s4 * J_2_2_p1;

  // link 4 (link4), pose
  const Real J_5_4 = s4 * J_2_2_p3;
  J[34] = J_5_4;

  // link 4 (link4), Jacobian
  J[15] = J_2_2_p1 * J_5_4;
  const Real J_2_2 = J_2_2_p5 * J_5_3 - J_2_2_p4 * J_2_2_p3;
  J[14] = J_2_2;
  const Real J_0_1_p1 = J_2_2_p4 * J_5_3 + J_2_2_p5 * J_2_2_p3;

  // link 4 (link4), pose
  const Real J_0_4_p2 = c4 * J_0_4_p1 + s4 * s1;
  const Real J_1_4_p2 = s4 * c1 - c4 * J_1_4_p1;
  const Real J_3_4 = s4 * J_0_4_p1 - c4 * s1;
  J[22] = J_3_4;
  const Real J_4_4 = s4 * J_1_4_p1 + c4 * c1;
  J[28] = J_4_4;

  // link 5 (link5), Jacobian
  J[16] = J_2_2_p1 * J_5_3 - J_2_2_p2 * J_2_4_p1;

  // link 3 (link3), Jacobian
  const Real J_2_1 = J_2_2 - 0.4318 * c2;
  J[13] = J_2_1;
  const Real J_0_1_p2 = J_0_1_p1 + 0.4318 * s2;
  J[2] = -(J_0_1_p1 * c1);

  // link 4 (link4), Jacobian
  J[3] = J_2_2_p1 * J_3_4;

  // link 3 (link3), Jacobian
  J[8] = -(J_0_1_p1 * s1);

  // link 4 (link4), Jacobian
  J[9] = J_2_2_p1 * J_4_4;

  // link 6 (link6), pose
  J[35] = -(s5 * J_2_4_p1 + c5 * J_5_3);

  // link 2 (link2), Jacobian
  J[1] = -(J_0_1_p2 * c1);
  J[7] = -(J_0_1_p2 * s1);

  // link 5 (link5), Jacobian
  J[4] = -(J_2_2_p1 * J_3_3 + J_2_2_p2 * J_0_4_p2);
  J[10] = J_2_2_p2 * J_1_4_p2 - J_2_2_p1 * J_4_3;

  // link 6 (link6), pose
  J[23] = -(s5 * J_0_4_p2 - c5 * J_3_3);
  J[29] = s5 * J_1_4_p2 + c5 * J_4_3;

  // link 1 (link1), Jacobian
  J[0] = J_2_1 * s1 - J_0_0_p1 * c1;
  J[6] = -(J_2_1 * c1 + J_0_0_p1 * s1);
}

}  // namespace puma560

#undef TREELINE_RESTRICT
