// jacobian: xd = J qd, rows stacked over operational points
// By from the poses of all links.
// 112 flops (add 40, mul 72, div 0), sine and cosine of 5 angles
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
  J[12] = 0.0;
  J[18] = 0.0;
  J[24] = 0.0;
  J[31] = 0.0;
  J[32] = 0.0;
  const Real angles[5] = {q[0], q[1], q[2], q[3], q[4]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s1 = sines[0];
  J[19] = -s1;
  J[20] = -s1;
  const Real c1 = cosines[0];
  J[25] = c1;
  J[26] = c1;
  const Real s2 = sines[1];
  const Real c2 = cosines[1];
  const Real s3 = sines[2];
  const Real c3 = cosines[2];
  const Real s4 = sines[3];
  const Real c4 = cosines[3];
  const Real s5 = sines[4];
  const Real c5 = cosines[4];

  // link 2 (link2), pose
  const Real J_4_3_p1 = s1 * s2;
  const Real J_4_3_p2 = s1 * c2;

  // link 3 (link3), pose
  const Real J_4_3 = c3 * J_4_3_p1 + s3 * J_4_3_p2;
  J[27] = J_4_3;
  const Real J_4_5_p1 = s3 * J_4_3_p1 - c3 * J_4_3_p2;

  // link 5 (link5), pose
  const Real J_4_5 = c5 * J_4_3 + s5 * (c1 * s4 - c4 * J_4_5_p1);
  J[29] = J_4_5;

  // link 6 (link6), pose
  const Real J_0_0_p1 = 0.05625 * J_4_5;

  // link 3 (link3), pose
  const Real p3_y = 0.1501 * c1 + 0.4318 * J_4_3_p2;

  // link 6 (link6), pose
  const Real J_0_0 = J_0_0_p1 + (p3_y + 0.4331 * J_4_3 + 0.0203 * J_4_5_p1);
  J[0] = -J_0_0;

  // link 3 (link3), pose
  const Real J_5_3 = c2 * c3 - s2 * s3;
  J[33] = J_5_3;
  const Real J_5_5_p1 = c2 * s3 + s2 * c3;

  // link 5 (link5), pose
  const Real J_5_5 = c5 * J_5_3 - J_5_5_p1 * (c4 * s5);
  J[35] = J_5_5;

  // link 6 (link6), pose
  const Real J_0_1_p1 = 0.05625 * J_5_5;

  // link 3 (link3), pose
  const Real p3_z = 0.6718 - 0.4318 * s2;

  // link 6 (link6), pose
  const Real J_0_1_p2 = J_0_1_p1 + (p3_z + 0.4331 * J_5_3 + 0.0203 * J_5_5_p1);

  // link 2 (link2), Jacobian
  const Real J_0_1_p3 = 0.6718 - J_0_1_p2;
  J[1] = -(c1 * J_0_1_p3);

  // link 3 (link3), Jacobian
  const Real J_0_2_p1 = p3_z - J_0_1_p2;
  J[2] = -(c1 * J_0_2_p1);

  // link 4 (link4), Jacobian
  J[3] = -(J_5_3 * J_0_0_p1 - J_4_3 * J_0_1_p1);

  // link 4 (link4), pose
  const Real J_5_4 = s4 * J_5_5_p1;
  J[34] = J_5_4;
  const Real J_4_4 = c1 * c4 + s4 * J_4_5_p1;
  J[28] = J_4_4;

  // link 5 (link5), Jacobian
  J[4] = -(J_5_4 * J_0_0_p1 - J_4_4 * J_0_1_p1);

  // link 6 (link6), Jacobian
  J[5] = -(J_5_5 * J_0_0_p1 - J_4_5 * J_0_1_p1);

  // link 2 (link2), pose
  const Real J_3_3_p1 = c1 * s2;
  const Real J_3_3_p2 = c1 * c2;

  // link 3 (link3), pose
  const Real J_3_3 = c3 * J_3_3_p1 + s3 * J_3_3_p2;
  J[21] = J_3_3;
  const Real J_3_5_p1 = s3 * J_3_3_p1 - c3 * J_3_3_p2;

  // link 5 (link5), pose
  const Real J_3_5 = c5 * J_3_3 - s5 * (s1 * s4 + c4 * J_3_5_p1);
  J[23] = J_3_5;

  // link 6 (link6), pose
  const Real J_1_0_p1 = 0.05625 * J_3_5;

  // link 3 (link3), pose
  const Real minus_p3_x = 0.1501 * s1 - 0.4318 * J_3_3_p2;

  // link 6 (link6), pose
  const Real J_1_0 = J_1_0_p1 - (minus_p3_x - 0.4331 * J_3_3 - 0.0203 * J_3_5_p1);
  J[6] = J_1_0;

  // link 2 (link2), Jacobian
  J[7] = -(s1 * J_0_1_p3);

  // link 3 (link3), Jacobian
  J[8] = -(s1 * J_0_2_p1);

  // link 4 (link4), Jacobian
  J[9] = -(J_3_3 * J_0_1_p1 - J_5_3 * J_1_0_p1);

  // link 4 (link4), pose
  const Real J_3_4 = s1 * c4 - s4 * J_3_5_p1;
  J[22] = -J_3_4;

  // link 5 (link5), Jacobian
  J[10] = J_3_4 * J_0_1_p1 + J_5_4 * J_1_0_p1;

  // link 6 (link6), Jacobian
  J[11] = -(J_3_5 * J_0_1_p1 - J_5_5 * J_1_0_p1);

  // link 2 (link2), Jacobian
  J[13] = -(c1 * J_1_0 + s1 * J_0_0);

  // link 3 (link3), Jacobian
  J[14] = -(c1 * (minus_p3_x + J_1_0) - s1 * (p3_y - J_0_0));

  // link 4 (link4), Jacobian
  J[15] = -(J_4_3 * J_1_0_p1 - J_3_3 * J_0_0_p1);

  // link 5 (link5), Jacobian
  J[16] = -(J_4_4 * J_1_0_p1 + J_3_4 * J_0_0_p1);

  // link 6 (link6), Jacobian
  J[17] = -(J_4_5 * J_1_0_p1 - J_3_5 * J_0_0_p1);
  J[30] = 1.0;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
