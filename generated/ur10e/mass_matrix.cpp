// mass_matrix: tau = M qdd + b + g: the matrix M
// By composite rigid bodies, RBDA table 6.2.
// 107 flops (add 44, mul 63, div 0), sine and cosine of 4 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void mass_matrix(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT M)[36]) noexcept {
  M[29] = 0.0;
  M[34] = 0.0;
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];

  // link 5 (wrist_2), composite inertia
  const Real M_2_2_p1 = 0.09132825 * s5;
  const Real M_0_0_p1 = 0.0054190910375000005 * s5;
  const Real M_3_4 = 0.0106962107625 * c5;
  M[22] = -M_3_4;
  M[27] = -M_3_4;
  const Real M_0_4_p1 = 0.6127 * c2;
  const Real M_0_1_p1 = 0.09132825 * c5;
  const Real M_0_1_p2 = 0.6127 * s2;
  M[28] = 0.0085220910375;
  M[35] = 0.000623;

  // link 6 (wrist_3), mass matrix
  const Real M_1_5 = 0.000623 * c5;
  M[11] = M_1_5;
  M[17] = M_1_5;
  M[23] = M_1_5;
  M[31] = M_1_5;
  M[32] = M_1_5;
  M[33] = M_1_5;
  const Real M_2_2_p2 = s2 * c3 + c2 * s3;
  const Real M_2_2_p3 = c2 * c3 - s2 * s3;

  // link 5 (wrist_2), composite inertia
  const Real M_0_0_p2 = s5 * M_0_0_p1;
  const Real M_0_4_p2 = 0.57155 * M_2_2_p3;
  const Real M_0_2_p1 = 0.57155 * M_2_2_p2;
  const Real M_3_3 = 0.041592816387499995 + M_0_0_p2;
  M[21] = M_3_3;
  const Real M_2_2_p4 = M_2_2_p2 * c4 + M_2_2_p3 * s4;
  const Real M_2_2_p5 = M_2_2_p3 * c4 - M_2_2_p2 * s4;
  const Real M_2_2_p6 = M_2_2_p4 * M_2_2_p1;

  // link 5 (wrist_2), mass matrix
  const Real M_0_4_p3 = M_2_2_p4 * s5;
  const Real M_2_4_p1 = M_2_2_p5 * M_0_1_p1;
  const Real M_2_4_p2 = M_2_2_p4 * M_0_1_p1;

  // link 5 (wrist_2), composite inertia
  const Real M_2_2_p7 = 0.33495075 * M_2_2_p4 - M_2_2_p5 * M_2_2_p1;
  const Real M_2_2_p8 = 0.33495075 * M_2_2_p5 + M_2_2_p6;

  // link 4 (wrist_1), composite inertia
  const Real M_2_2_p9 = M_0_4_p2 * M_2_2_p7;

  // link 2 (upper_arm), composite inertia
  const Real M_0_0_p3 = 0.0098370910375 + (6.991093406097501 - s2 * (4.36318718615 * s2) -
      M_2_2_p2 * (2.07831527531 * M_2_2_p2)) + 0.031809629475 * c5;

  // link 3 (forearm), composite inertia
  const Real M_0_0_p4 = M_0_4_p1 * (M_2_2_p7 - 4.0059802 * M_2_2_p3);

  // link 4 (wrist_1), composite inertia
  const Real M_2_2_p10 = M_0_2_p1 * M_2_2_p8 - M_2_2_p9;

  // link 2 (upper_arm), composite inertia
  const Real M_0_0_p5 = (0.037099816387500005 * M_2_2_p4 -
      (M_2_2_p4 * (0.0012399999999999998 + M_0_0_p2) + M_2_2_p5 * (0.021392421525 * s5))) *
      M_2_2_p4;

  // link 6 (wrist_3), mass matrix
  const Real M_0_5 = 0.000623 * M_0_4_p3;
  M[5] = -M_0_5;
  M[30] = -M_0_5;

  // link 5 (wrist_2), composite inertia
  const Real M_0_3 = M_2_2_p4 * c5 * M_0_0_p1 + 0.17415 * M_2_2_p6 + (0.0585962731125 + M_3_4) *
      M_2_2_p5;
  M[3] = M_0_3;
  M[18] = M_0_3;

  // link 5 (wrist_2), mass matrix
  const Real M_2_4 = M_0_4_p2 * M_2_4_p2 - M_0_2_p1 * M_2_4_p1 - M_3_4;
  M[16] = M_2_4;
  M[26] = M_2_4;

  // link 3 (forearm), composite inertia
  const Real M_1_1_p1 = M_0_1_p2 * (4.0059802 * M_2_2_p2 + M_2_2_p8) - M_0_0_p4;

  // link 4 (wrist_1), mass matrix
  const Real M_2_3 = M_3_3 + M_2_2_p10;
  M[15] = M_2_3;
  M[20] = M_2_3;

  // link 5 (wrist_2), mass matrix
  const Real M_0_4 = 0.0106962107625 * M_0_4_p3 - 0.0085220910375 * M_2_2_p5 - 0.17415 * M_2_4_p1 -
      (M_0_4_p2 + M_0_4_p1) * M_2_2_p1;
  M[4] = M_0_4;
  M[24] = M_0_4;
  const Real M_1_4 = M_2_4 + (M_0_4_p1 * M_2_4_p2 - M_0_1_p2 * M_2_4_p1);
  M[10] = M_1_4;
  M[25] = M_1_4;

  // link 4 (wrist_1), mass matrix
  const Real M_1_3 = M_2_3 + (M_0_1_p2 * M_2_2_p8 - M_0_4_p1 * M_2_2_p7);
  M[9] = M_1_3;
  M[19] = M_1_3;

  // link 4 (wrist_1), composite inertia
  const Real M_0_2 = 0.5656542411875001 * M_2_2_p2 + (M_0_3 + M_0_2_p1 * M_0_1_p1);
  M[2] = M_0_2;
  M[12] = M_0_2;
  const Real M_2_2 = 2.08330527531 + (M_3_3 + 2.0 * M_2_2_p10);
  M[14] = M_2_2;

  // link 2 (upper_arm), composite inertia
  M[0] = M_0_0_p3 - 2.0 * (M_2_2_p9 + M_0_0_p4) + M_0_0_p5;

  // link 3 (forearm), composite inertia
  const Real M_0_1 = 1.156008191975 * s2 + (M_0_2 + M_0_1_p2 * M_0_1_p1);
  M[1] = M_0_1;
  M[6] = M_0_1;

  // link 3 (forearm), mass matrix
  const Real M_1_2 = M_2_2 + M_1_1_p1;
  M[8] = M_1_2;
  M[13] = M_1_2;

  // link 3 (forearm), composite inertia
  M[7] = 4.3866871861500005 + (M_2_2 + 2.0 * M_1_1_p1);
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
