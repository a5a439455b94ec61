// mass_matrix: tau = M qdd + b + g: the matrix M
// By composite rigid bodies, RBDA table 6.2.
// 166 flops (add 73, mul 93, div 0), sine and cosine of 4 angles
// Generated; see puma560.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void mass_matrix(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT M)[36]) noexcept {
  M[22] = 0.0;
  M[27] = 0.0;
  M[29] = 0.0;
  M[34] = 0.0;
  const Real angles[4] = {q[4], q[3], q[2], q[1]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s5 = sines[0];
  const Real c4 = cosines[1];
  const Real s3 = sines[2];
  const Real s4 = sines[1];
  const Real c5 = cosines[0];
  const Real c3 = cosines[2];
  const Real s2 = sines[3];
  const Real c2 = cosines[3];

  // link 5 (link5), composite inertia
  const Real M_0_0_p1 = 0.00020215999999999998 * s5;
  const Real M_0_0_p2 = 0.0028799999999999997 * s5;
  const Real M_0_0_p3 = 0.0028799999999999997 * c5;
  M[28] = 0.00064216;

  // link 5 (link5), mass matrix
  M[35] = 4e-05;

  // link 6 (link6), mass matrix
  const Real M_0_5_p1 = 4e-05 * s5;

  // link 5 (link5), composite inertia
  const Real M_0_0_p4 = s5 * M_0_0_p1;

  // link 4 (link4), composite inertia
  const Real M_0_0_p5 = c4 * M_0_0_p2;

  // link 5 (link5), composite inertia
  const Real M_0_0_p6 = c5 * M_0_0_p1;

  // link 4 (link4), composite inertia
  const Real M_0_3_p1 = s4 * M_0_0_p2;
  const Real M_0_0_p7 = 0.861795 + M_0_0_p3;

  // link 5 (link5), mass matrix
  const Real M_0_4_p1 = s4 * M_0_0_p3;
  const Real M_0_4_p2 = c4 * M_0_0_p3;

  // link 6 (link6), mass matrix
  const Real M_0_5_p2 = c4 * M_0_5_p1;
  const Real M_3_5 = 4e-05 * c5;
  M[23] = M_3_5;
  M[33] = M_3_5;

  // link 5 (link5), composite inertia
  const Real M_3_3 = 0.00164 + M_0_0_p4;
  M[21] = M_3_3;

  // link 4 (link4), composite inertia
  const Real M_0_0_p8 = M_0_0_p5 - 0.025374999999999998;

  // link 3 (link3), composite inertia
  const Real M_0_3_p2 = 0.1501 * M_0_3_p1;

  // link 4 (link4), composite inertia
  const Real M_0_0_p9 = s4 * (0.00010000000000000026 + M_0_0_p4);
  const Real M_0_3_p3 = 0.0203 * M_0_0_p5;
  const Real M_0_0_p10 = c4 * M_0_0_p6 + 0.4331 * M_0_0_p5;

  // link 5 (link5), mass matrix
  const Real M_0_4_p3 = 0.0203 * M_0_4_p1;

  // link 4 (link4), composite inertia
  const Real M_2_3 = s4 * M_0_0_p6 + 0.4331 * M_0_3_p1;
  M[15] = -M_2_3;
  M[20] = -M_2_3;

  // link 4 (link4), mass matrix
  const Real M_0_3_p4 = s3 * M_0_3_p1;

  // link 4 (link4), composite inertia
  const Real M_0_0_p11 = s4 * M_0_0_p9;

  // link 4 (link4), mass matrix
  const Real M_0_3_p5 = M_0_3_p3 - M_3_3;

  // link 4 (link4), composite inertia
  const Real M_0_0_p12 = 0.0067651125 + (M_3_3 - 0.0406 * M_0_0_p5);

  // link 3 (link3), composite inertia
  const Real M_0_0_p13 = c3 * M_0_0_p8 + s3 * M_0_0_p7;
  const Real M_0_0_p14 = s3 * M_0_0_p8 - c3 * M_0_0_p7;

  // link 5 (link5), mass matrix
  const Real M_0_4_p4 = 0.00064216 * s4 + 0.4331 * M_0_4_p1;

  // link 4 (link4), composite inertia
  const Real M_0_1_p1 = 0.004704000000000001 + M_2_3;
  const Real M_0_0_p15 = M_0_0_p10 - 5.846399999999999e-05 * c5 - 0.010673638499999999;

  // link 3 (link3), composite inertia
  const Real M_0_0_p16 = 0.4318 * M_0_0_p13;

  // link 4 (link4), composite inertia
  const Real M_0_1_p2 = 0.0203 * M_0_3_p1 - c4 * M_0_0_p9;

  // link 5 (link5), mass matrix
  const Real M_0_4_p5 = s3 * M_0_4_p2 + c3 * M_0_0_p2;

  // link 4 (link4), composite inertia
  const Real M_0_0_p17 = 0.3056901365 + (0.0011921599999999998 - M_0_0_p4 + M_0_0_p11 +
      0.0024946559999999996 * c5);

  // link 3 (link3), composite inertia
  const Real M_0_1_p3 = c3 * M_0_1_p2 - s3 * M_0_1_p1 - 0.1501 * M_0_0_p13;
  const Real M_0_1_p4 = s3 * M_0_1_p2 + c3 * M_0_1_p1 - 0.1501 * M_0_0_p14;

  // link 5 (link5), mass matrix
  const Real M_0_4_p6 = c3 * M_0_4_p3 - s3 * M_0_4_p4 +
      (0.1501 * (c3 * M_0_4_p2 - s3 * M_0_0_p2) - 0.4318 * M_0_4_p1);

  // link 4 (link4), composite inertia
  const Real M_2_2 = 0.312455249 + (0.00129216 - M_0_0_p11 + 2.0 *
      (0.0012473279999999998 * c5 - M_0_3_p3));
  M[14] = M_2_2;

  // link 3 (link3), composite inertia
  const Real M_0_0_p18 = s3 * (M_0_0_p17 - M_0_0_p12) + c3 * (2.0 * M_0_0_p15);

  // link 5 (link5), mass matrix
  const Real M_2_4 = 0.00064216 * c4 + (0.4331 * M_0_4_p2 - 5.846399999999999e-05 * s5);
  M[16] = M_2_4;
  M[26] = M_2_4;

  // link 6 (link6), mass matrix
  const Real M_1_5 = s4 * M_0_5_p1;
  M[11] = M_1_5;
  M[17] = M_1_5;
  M[31] = M_1_5;
  M[32] = M_1_5;

  // link 3 (link3), mass matrix
  const Real M_0_2 = s2 * M_0_1_p3 + c2 * M_0_1_p4;
  M[2] = -M_0_2;
  M[12] = -M_0_2;
  const Real M_1_2 = M_2_2 + M_0_0_p16;
  M[8] = M_1_2;
  M[13] = M_1_2;

  // link 3 (link3), composite inertia
  const Real M_0_0_p19 = s3 * M_0_0_p18;

  // link 4 (link4), mass matrix
  const Real M_0_3 = s2 * (0.1501 * M_0_3_p4 - (c3 * M_0_0_p10 + s3 * M_0_3_p5)) + c2 *
      ((M_0_3_p5 - M_0_3_p2) * c3 - (s3 * M_0_0_p10 + 0.4318 * M_0_0_p5));
  M[3] = -M_0_3;
  M[18] = -M_0_3;

  // link 5 (link5), mass matrix
  const Real M_0_4 = s2 * (c3 * M_0_4_p4 + s3 * M_0_4_p3 + 0.1501 * M_0_4_p5) - c2 * M_0_4_p6;
  M[4] = M_0_4;
  M[24] = M_0_4;

  // link 3 (link3), composite inertia
  M[7] = 1.7481140020000001 + (M_2_2 + 0.8636 * M_0_0_p13);

  // link 6 (link6), mass matrix
  const Real M_0_5 = s2 * (c3 * M_0_5_p2 + s3 * M_3_5) + c2 * (s3 * M_0_5_p2 - c3 * M_3_5);
  M[5] = -M_0_5;
  M[30] = -M_0_5;

  // link 4 (link4), mass matrix
  const Real M_1_3 = M_2_3 + 0.4318 * M_0_3_p4;
  M[9] = -M_1_3;
  M[19] = -M_1_3;

  // link 5 (link5), mass matrix
  const Real M_1_4 = M_2_4 + 0.4318 * M_0_4_p5;
  M[10] = M_1_4;
  M[25] = M_1_4;

  // link 2 (link2), composite inertia
  const Real M_0_1 = s2 * (M_0_1_p3 - 0.4318 * M_0_3_p1 - 0.690314699) + c2 *
      (M_0_1_p4 - 0.023750999999999998);
  M[1] = -M_0_1;
  M[6] = -M_0_1;

  // link 3 (link3), composite inertia
  const Real M_0_0_p20 = 1.674987602 + (M_0_0_p12 + M_0_0_p19 + 2.0 * (M_0_0_p16 + M_0_3_p2));

  // link 2 (link2), composite inertia
  const Real M_0_0_p21 = s2 * (0.07312640000000001 + (M_0_0_p17 - M_0_0_p19 + 0.3002 * M_0_3_p1) -
      M_0_0_p20) + c2 * (2.0 * (c3 * M_0_0_p18 - M_0_0_p15 - 0.4318 * M_0_0_p14 - 0.0070992));
  M[0] = 1.4717295504999999 + (M_0_0_p20 + s2 * M_0_0_p21);
}

}  // namespace puma560

#undef TREELINE_RESTRICT
