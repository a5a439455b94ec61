// mass_matrix: tau = M qdd + b + g: the matrix M
// By composite rigid bodies, RBDA table 6.2.
// 154 flops (add 69, mul 85, div 0), sine and cosine of 4 angles
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

void mass_matrix(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT M)[36]) noexcept {
  M[29] = 0.0;
  M[34] = 0.0;
  const Real angles[4] = {q[4], q[3], q[2], q[1]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real c5 = cosines[0];
  const Real s4 = sines[1];
  const Real s5 = sines[0];
  const Real c4 = cosines[1];
  const Real s3 = sines[2];
  const Real c3 = cosines[2];
  const Real s2 = sines[3];
  const Real c2 = cosines[3];

  // link 5 (wrist_2), composite inertia
  const Real M_0_0_p1 = 0.0054190910375000005 * s5;
  const Real M_0_0_p2 = 0.031809629475 * c5;
  const Real M_2_2_p1 = 0.09132825 * s5;
  const Real M_0_4_p1 = 0.0106962107625 * s5;
  const Real M_3_4 = 0.0106962107625 * c5;
  M[22] = -M_3_4;
  M[27] = -M_3_4;

  // link 4 (wrist_1), composite inertia
  M[28] = 0.0085220910375;

  // link 5 (wrist_2), mass matrix
  M[35] = 0.000623;

  // link 6 (wrist_3), mass matrix
  const Real M_0_5_p1 = 0.000623 * s5;

  // link 5 (wrist_2), composite inertia
  const Real M_1_4_p1 = 0.09132825 * c5;
  const Real M_0_0_p3 = s5 * M_0_0_p1;
  const Real M_0_0_p4 = 0.0098370910375 + M_0_0_p2;
  const Real M_0_1_p1 = 0.0585962731125 + M_3_4;

  // link 5 (wrist_2), mass matrix
  const Real M_0_4_p2 = 0.0085220910375 + 0.0159048147375 * c5;

  // link 6 (wrist_3), mass matrix
  const Real M_1_5 = 0.000623 * c5;
  M[11] = M_1_5;
  M[17] = M_1_5;
  M[23] = M_1_5;
  M[31] = M_1_5;
  M[32] = M_1_5;
  M[33] = M_1_5;
  const Real M_0_5_p2 = s4 * M_0_5_p1;
  const Real M_0_5_p3 = c4 * M_0_5_p1;

  // link 5 (wrist_2), mass matrix
  const Real M_1_4_p2 = s4 * M_1_4_p1;

  // link 4 (wrist_1), composite inertia
  const Real M_2_2_p2 = 0.33495075 * s4 - c4 * M_2_2_p1;

  // link 5 (wrist_2), composite inertia
  const Real M_3_3 = 0.041592816387499995 + M_0_0_p3;
  M[21] = M_3_3;

  // link 4 (wrist_1), composite inertia
  const Real M_0_0_p5 = s4 * M_2_2_p1 + 0.33495075 * c4;

  // link 5 (wrist_2), composite inertia
  const Real M_0_1_p2 = c5 * M_0_0_p1 + 0.0159048147375 * s5;

  // link 4 (wrist_1), composite inertia
  const Real M_2_2_p3 = 1.1431 * M_2_2_p2;
  const Real M_1_1_p1 = M_2_2_p2 - 4.0059802;

  // link 3 (forearm), composite inertia
  const Real M_1_1_p2 = s3 * M_0_0_p5;

  // link 5 (wrist_2), composite inertia
  const Real M_0_0_p6 = 0.0384148163875 + (0.007282091037500001 - M_0_0_p3 + M_0_0_p2);

  // link 5 (wrist_2), mass matrix
  const Real M_0_4_p3 = c4 * M_0_4_p1 + s4 * M_0_4_p2;

  // link 4 (wrist_1), composite inertia
  const Real M_0_1_p3 = c4 * M_0_1_p2 - s4 * M_0_1_p1;
  const Real M_0_3_p1 = s4 * M_0_1_p2 + c4 * M_0_1_p1;

  // link 5 (wrist_2), mass matrix
  const Real M_0_4_p4 = s4 * M_0_4_p1 - c4 * M_0_4_p2 - 0.0521986612875 * s5;

  // link 3 (forearm), composite inertia
  const Real M_1_1_p3 = c3 * M_1_1_p1 + M_1_1_p2;
  const Real M_0_3_p2 = s3 * M_0_3_p1;
  const Real M_0_3_p3 = c3 * M_0_3_p1;
  const Real M_1_1_p4 = 1.2254 * M_1_1_p3;

  // link 4 (wrist_1), composite inertia
  const Real M_0_1_p4 = 0.5656542411875001 + (M_0_1_p3 + 0.0521986612875 * c5);
  const Real M_2_2 = 2.08330527531 + (M_3_3 - M_2_2_p3);
  M[14] = M_2_2;

  // link 4 (wrist_1), mass matrix
  const Real M_2_3 = M_3_3 - 0.57155 * M_2_2_p2;
  M[15] = M_2_3;
  M[20] = M_2_3;

  // link 5 (wrist_2), mass matrix
  const Real M_2_4 = 0.57155 * M_1_4_p2 - M_3_4;
  M[16] = M_2_4;
  M[26] = M_2_4;

  // link 4 (wrist_1), composite inertia
  const Real M_0_0_p7 = s4 * (M_0_0_p6 - M_0_0_p4) - c4 * (0.021392421525 * s5);
  const Real M_0_0_p8 = s4 * M_0_0_p7;

  // link 6 (wrist_3), mass matrix
  const Real M_0_5 = s2 * (s3 * M_0_5_p2 - c3 * M_0_5_p3) - c2 * (s3 * M_0_5_p3 + c3 * M_0_5_p2);
  M[5] = M_0_5;
  M[30] = M_0_5;

  // link 3 (forearm), mass matrix
  const Real M_1_2 = M_2_2 - 0.6127 * M_1_1_p3;
  M[8] = M_1_2;
  M[13] = M_1_2;

  // link 3 (forearm), composite inertia
  const Real M_0_1_p5 = c3 * M_0_1_p4 - M_0_3_p2;
  M[7] = 4.3866871861500005 + (M_2_2 - M_1_1_p4);

  // link 4 (wrist_1), mass matrix
  const Real M_1_3 = M_2_3 - 0.6127 * (M_1_1_p2 + c3 * M_2_2_p2);
  M[9] = M_1_3;
  M[19] = M_1_3;

  // link 5 (wrist_2), mass matrix
  const Real M_1_4 = M_2_4 + 0.6127 * (s3 * (c4 * M_1_4_p1) + c3 * M_1_4_p2);
  M[10] = M_1_4;
  M[25] = M_1_4;

  // link 2 (upper_arm), composite inertia
  const Real M_0_2_p1 = c2 * (s3 * M_0_1_p4 + M_0_3_p3);

  // link 4 (wrist_1), mass matrix
  const Real M_0_3 = s2 * (c3 * M_0_1_p3 - M_0_3_p2) + c2 * (s3 * M_0_1_p3 + M_0_3_p3);
  M[3] = M_0_3;
  M[18] = M_0_3;

  // link 4 (wrist_1), composite inertia
  const Real M_0_0_p9 = c4 * M_0_0_p7 + M_0_4_p1 - 0.57155 * M_0_0_p5;
  const Real M_0_0_p10 = 0.002495 + (M_0_0_p6 - M_0_0_p8);

  // link 5 (wrist_2), mass matrix
  const Real M_0_4 = s2 * (c3 * M_0_4_p3 - s3 * M_0_4_p4) + c2 *
      (s3 * M_0_4_p3 + c3 * M_0_4_p4 - 0.055956818775 * s5);
  M[4] = M_0_4;
  M[24] = M_0_4;

  // link 3 (forearm), mass matrix
  const Real M_0_2 = s2 * M_0_1_p5 + M_0_2_p1;
  M[2] = M_0_2;
  M[12] = M_0_2;

  // link 4 (wrist_1), composite inertia
  const Real M_0_0_p11 = 2.08081027531 + (M_0_0_p4 + M_0_0_p8 - M_2_2_p3);

  // link 2 (upper_arm), composite inertia
  const Real M_0_1 = s2 * (1.156008191975 + (M_0_1_p5 + 0.055956818775 * c5)) + M_0_2_p1;
  M[1] = M_0_1;
  M[6] = M_0_1;

  // link 3 (forearm), composite inertia
  const Real M_0_0_p12 = s3 * (M_0_0_p10 - M_0_0_p11) + c3 * (2.0 * M_0_0_p9);
  const Real M_0_0_p13 = s3 * M_0_0_p12;
  const Real M_0_0_p14 = 4.37493718615 + (M_0_0_p11 + M_0_0_p13 - M_1_1_p4);

  // link 2 (upper_arm), composite inertia
  const Real M_0_0_p15 = 2.0 * (c3 * M_0_0_p12 - M_0_0_p9 + 0.6127 *
      (s3 * M_1_1_p1 - c3 * M_0_0_p5));
  const Real M_0_0_p16 = M_0_0_p14 + s2 * (s2 * (0.01175 + (M_0_0_p10 - M_0_0_p13) - M_0_0_p14) +
      c2 * M_0_0_p15);
  M[0] = 0.5353459446375001 + M_0_0_p16;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
