// mass_matrix: tau = M qdd + b + g: the matrix M
// By composite rigid bodies, RBDA table 6.2.
// 239 flops (add 98, mul 141, div 0), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void mass_matrix(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT M)[81]) noexcept {
  M[1] = 0.0;
  M[8] = 0.0;
  M[9] = 0.0;
  M[17] = 0.0;
  M[61] = 0.0;
  M[69] = 0.0;
  M[71] = 0.0;
  M[72] = 0.0;
  M[73] = 0.0;
  M[79] = 0.0;
  const Real angles[6] = {q[2], q[3], q[4], q[5], q[6], q[7]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real s3 = sines[0];
  const Real c4 = cosines[1];
  const Real s5 = sines[2];
  const Real s6 = sines[3];
  const Real c7 = cosines[4];
  const Real s8 = sines[5];
  const Real c6 = cosines[3];
  const Real c8 = cosines[5];
  const Real c5 = cosines[2];
  const Real s4 = sines[1];
  const Real s7 = sines[4];
  const Real c3 = cosines[0];

  // link 8 (link5), composite inertia
  const Real M_2_2_p1 = 0.00020215999999999998 * s8;
  const Real M_2_2_p2 = 0.0028799999999999997 * s8;
  const Real M_2_2_p3 = 0.0028799999999999997 * c8;
  M[0] = 186.45;
  M[10] = 186.45;
  const Real M_2_2_p4 = s8 * M_2_2_p1;

  // link 7 (link4), composite inertia
  const Real M_2_2_p5 = c7 * M_2_2_p2;

  // link 8 (link5), composite inertia
  const Real M_2_2_p6 = c8 * M_2_2_p1;

  // link 7 (link4), composite inertia
  const Real M_2_2_p7 = s7 * M_2_2_p2;
  const Real M_2_2_p8 = 0.861795 + M_2_2_p3;

  // link 8 (link5), mass matrix
  const Real M_0_7_p1 = c7 * M_2_2_p3;
  const Real M_2_7_p1 = s7 * M_2_2_p3;

  // link 8 (link5), composite inertia
  const Real M_6_6 = 0.00164 + M_2_2_p4;
  M[60] = M_6_6;

  // link 7 (link4), composite inertia
  const Real M_2_2_p9 = M_2_2_p5 - 0.025374999999999998;
  const Real M_2_2_p10 = s7 * (0.00010000000000000026 + M_2_2_p4);
  const Real M_2_2_p11 = c7 * M_2_2_p6 + 0.4331 * M_2_2_p5;

  // link 7 (link4), mass matrix
  const Real M_0_6_p1 = c6 * M_2_2_p7;
  const Real M_0_6_p2 = s6 * M_2_2_p7;

  // link 5 (link2), composite inertia
  const Real M_0_2_p1 = 4.9338049999999996 + M_2_2_p7;

  // link 7 (link4), composite inertia
  const Real M_5_6 = s7 * M_2_2_p6 + 0.4331 * M_2_2_p7;
  M[51] = -M_5_6;
  M[59] = -M_5_6;
  const Real M_2_2_p12 = s7 * M_2_2_p10;

  // link 8 (link5), mass matrix
  const Real M_0_7_p2 = s6 * M_0_7_p1 + c6 * M_2_2_p2;

  // link 7 (link4), composite inertia
  const Real M_2_2_p13 = 0.0067651125 + (M_6_6 - 0.0406 * M_2_2_p5);

  // link 6 (link3), composite inertia
  const Real M_2_2_p14 = c6 * M_2_2_p9 + s6 * M_2_2_p8;
  const Real M_2_2_p15 = s6 * M_2_2_p9 - c6 * M_2_2_p8;

  // link 8 (link5), mass matrix
  const Real M_0_7_p3 = c6 * M_0_7_p1 - s6 * M_2_2_p2;

  // link 7 (link4), composite inertia
  const Real M_2_4_p1 = 0.004704000000000001 + M_5_6;
  const Real M_2_6_p1 = 0.0203 * M_2_2_p5;
  const Real M_2_2_p16 = M_2_2_p11 - 5.846399999999999e-05 * c8 - 0.010673638499999999;

  // link 6 (link3), composite inertia
  const Real M_2_2_p17 = 0.4318 * M_2_2_p14;

  // link 7 (link4), composite inertia
  const Real M_2_4_p2 = 0.0203 * M_2_2_p7 - c7 * M_2_2_p10;

  // link 6 (link3), composite inertia
  const Real M_0_2_p2 = 0.10439999999999999 + M_2_2_p15;
  const Real M_0_2_p3 = 3.79559 + M_2_2_p14;
  M[70] = 0.00064216;

  // link 8 (link5), mass matrix
  const Real M_2_7_p2 = 0.0203 * M_2_7_p1;

  // link 7 (link4), mass matrix
  const Real M_2_6_p2 = M_2_6_p1 - M_6_6;

  // link 8 (link5), mass matrix
  const Real M_2_7_p3 = 0.00064216 * s7 + 0.4331 * M_2_7_p1;

  // link 7 (link4), composite inertia
  const Real M_2_2_p18 = 0.3056901365 + (0.0011921599999999998 - M_2_2_p4 + M_2_2_p12 +
      0.0024946559999999996 * c8);

  // link 6 (link3), composite inertia
  M[80] = 4e-05;

  // link 9 (link6), mass matrix
  const Real M_2_8_p1 = 4e-05 * s8;
  const Real M_6_8 = 4e-05 * c8;
  M[62] = M_6_8;
  M[78] = M_6_8;

  // link 5 (link2), composite inertia
  const Real M_0_2_p4 = s5 * M_0_2_p2 - c5 * M_0_2_p3;

  // link 7 (link4), mass matrix
  const Real M_0_6_p3 = c5 * M_0_6_p1 - s5 * M_0_6_p2;

  // link 8 (link5), mass matrix
  const Real M_0_7_p4 = s5 * M_0_7_p2 - c5 * M_0_7_p3;

  // link 9 (link6), mass matrix
  const Real M_2_8_p2 = c7 * M_2_8_p1;

  // link 6 (link3), composite inertia
  const Real M_2_4_p3 = c6 * M_2_4_p2 - s6 * M_2_4_p1 - 0.1501 * M_2_2_p14;

  // link 5 (link2), mass matrix
  const Real M_0_4_p1 = c5 * M_0_2_p2 + s5 * M_0_2_p3;

  // link 6 (link3), mass matrix
  const Real M_0_5_p1 = s5 * M_2_2_p14 + c5 * M_2_2_p15;

  // link 6 (link3), composite inertia
  const Real M_2_2_p19 = s6 * (M_2_2_p18 - M_2_2_p13) + c6 * (2.0 * M_2_2_p16);
  const Real M_2_4_p4 = s6 * M_2_4_p2 + c6 * M_2_4_p1 - 0.1501 * M_2_2_p15;
  const Real M_2_2_p20 = s6 * M_2_2_p19;

  // link 5 (link2), mass matrix
  const Real M_0_4_p2 = s4 * M_0_4_p1;
  const Real M_0_4_p3 = c4 * M_0_4_p1;

  // link 6 (link3), mass matrix
  const Real M_0_5_p2 = s4 * M_0_5_p1;
  const Real M_0_5_p3 = c4 * M_0_5_p1;

  // link 4 (link1), composite inertia
  const Real M_0_2_p5 = c4 * M_0_2_p4 + s4 * M_0_2_p1;
  const Real M_0_2_p6 = c4 * M_0_2_p1 - s4 * M_0_2_p4;

  // link 7 (link4), mass matrix
  const Real M_0_6_p4 = c4 * M_0_6_p3 + s4 * M_2_2_p5;
  const Real M_0_6_p5 = c4 * M_2_2_p5 - s4 * M_0_6_p3;

  // link 8 (link5), mass matrix
  const Real M_0_7_p5 = c4 * M_0_7_p4 + s4 * M_2_7_p1;
  const Real M_0_7_p6 = c4 * M_2_7_p1 - s4 * M_0_7_p4;

  // link 7 (link4), composite inertia
  const Real M_5_5 = 0.312455249 + (0.00129216 - M_2_2_p12 + 2.0 *
      (0.0012473279999999998 * c8 - M_2_6_p1));
  M[50] = M_5_5;

  // link 6 (link3), composite inertia
  const Real M_2_2_p21 = 1.674987602 + (M_2_2_p13 + M_2_2_p20 + 2.0 *
      (M_2_2_p17 + 0.1501 * M_2_2_p7));

  // link 7 (link4), mass matrix
  const Real M_2_6_p3 = c5 * (c6 * M_2_6_p2 - s6 * M_2_2_p11 -
      (0.1501 * M_0_6_p1 + 0.4318 * M_2_2_p5));

  // link 8 (link5), mass matrix
  const Real M_2_7_p4 = c5 * (c6 * M_2_7_p2 - s6 * M_2_7_p3 +
      (0.1501 * M_0_7_p3 - 0.4318 * M_2_7_p1));
  const Real M_5_7 = 0.00064216 * c7 + (0.4331 * M_0_7_p1 - 5.846399999999999e-05 * s8);
  M[52] = M_5_7;
  M[68] = M_5_7;

  // link 9 (link6), mass matrix
  const Real M_4_8 = s7 * M_2_8_p1;
  M[44] = M_4_8;
  M[53] = M_4_8;
  M[76] = M_4_8;
  M[77] = M_4_8;

  // link 3 (base), mass matrix
  const Real M_0_2 = s3 * M_0_2_p5 - c3 * M_0_2_p6;
  M[2] = M_0_2;
  M[3] = M_0_2;
  M[18] = M_0_2;
  M[27] = M_0_2;

  // link 5 (link2), mass matrix
  const Real M_0_4 = s3 * M_0_4_p2 - c3 * M_0_4_p3;
  M[4] = M_0_4;
  M[36] = M_0_4;

  // link 6 (link3), mass matrix
  const Real M_0_5 = s3 * M_0_5_p2 - c3 * M_0_5_p3;
  M[5] = M_0_5;
  M[45] = M_0_5;

  // link 5 (link2), composite inertia
  const Real M_2_2_p22 = s5 * (0.07312640000000001 + (M_2_2_p18 - M_2_2_p20 + 0.3002 * M_2_2_p7) -
      M_2_2_p21) + c5 * (2.0 * (c6 * M_2_2_p19 - M_2_2_p16 - 0.4318 * M_2_2_p15 - 0.0070992));

  // link 7 (link4), mass matrix
  const Real M_0_6 = c3 * M_0_6_p4 + s3 * M_0_6_p5;
  M[6] = -M_0_6;
  M[54] = -M_0_6;

  // link 8 (link5), mass matrix
  const Real M_0_7 = c3 * M_0_7_p5 + s3 * M_0_7_p6;
  M[7] = -M_0_7;
  M[63] = -M_0_7;

  // link 3 (base), mass matrix
  const Real M_1_2 = s3 * M_0_2_p6 + c3 * M_0_2_p5;
  M[11] = -M_1_2;
  M[12] = -M_1_2;
  M[19] = -M_1_2;
  M[28] = -M_1_2;

  // link 5 (link2), mass matrix
  const Real M_1_4 = s3 * M_0_4_p3 + c3 * M_0_4_p2;
  M[13] = -M_1_4;
  M[37] = -M_1_4;

  // link 6 (link3), mass matrix
  const Real M_1_5 = s3 * M_0_5_p3 + c3 * M_0_5_p2;
  M[14] = -M_1_5;
  M[46] = -M_1_5;

  // link 7 (link4), mass matrix
  const Real M_1_6 = c3 * M_0_6_p5 - s3 * M_0_6_p4;
  M[15] = M_1_6;
  M[55] = M_1_6;

  // link 8 (link5), mass matrix
  const Real M_1_7 = c3 * M_0_7_p6 - s3 * M_0_7_p5;
  M[16] = M_1_7;
  M[64] = M_1_7;

  // link 5 (link2), composite inertia
  const Real M_2_4 = s5 * (M_2_4_p3 - 0.4318 * M_2_2_p7 - 0.690314699) + c5 *
      (M_2_4_p4 - 0.023750999999999998);
  M[22] = -M_2_4;
  M[31] = -M_2_4;
  M[38] = -M_2_4;
  M[39] = -M_2_4;

  // link 6 (link3), mass matrix
  const Real M_2_5 = s5 * M_2_4_p3 + c5 * M_2_4_p4;
  M[23] = -M_2_5;
  M[32] = -M_2_5;
  M[47] = -M_2_5;
  M[48] = -M_2_5;

  // link 7 (link4), mass matrix
  const Real M_2_6 = s5 * (0.1501 * M_0_6_p2 - (c6 * M_2_2_p11 + s6 * M_2_6_p2)) + M_2_6_p3;
  M[24] = -M_2_6;
  M[33] = -M_2_6;
  M[56] = -M_2_6;
  M[57] = -M_2_6;

  // link 8 (link5), mass matrix
  const Real M_2_7 = s5 * (c6 * M_2_7_p3 + s6 * M_2_7_p2 + 0.1501 * M_0_7_p2) - M_2_7_p4;
  M[25] = M_2_7;
  M[34] = M_2_7;
  M[65] = M_2_7;
  M[66] = M_2_7;

  // link 9 (link6), mass matrix
  const Real M_2_8 = s5 * (c6 * M_2_8_p2 + s6 * M_6_8) + c5 * (s6 * M_2_8_p2 - c6 * M_6_8);
  M[26] = -M_2_8;
  M[35] = -M_2_8;
  M[74] = -M_2_8;
  M[75] = -M_2_8;

  // link 6 (link3), composite inertia
  M[40] = 1.7481140020000001 + (M_5_5 + 0.8636 * M_2_2_p14);

  // link 6 (link3), mass matrix
  const Real M_4_5 = M_5_5 + M_2_2_p17;
  M[41] = M_4_5;
  M[49] = M_4_5;

  // link 7 (link4), mass matrix
  const Real M_4_6 = M_5_6 + 0.4318 * M_0_6_p2;
  M[42] = -M_4_6;
  M[58] = -M_4_6;

  // link 8 (link5), mass matrix
  const Real M_4_7 = M_5_7 + 0.4318 * M_0_7_p2;
  M[43] = M_4_7;
  M[67] = M_4_7;

  // link 5 (link2), composite inertia
  const Real M_2_2_p23 = M_2_2_p21 + s5 * M_2_2_p22;

  // link 4 (link1), composite inertia
  M[20] = 8.6717295505 + M_2_2_p23;

  // link 5 (link2), composite inertia
  const Real M_2_3 = 1.4717295504999999 + M_2_2_p23;
  M[21] = M_2_3;
  M[29] = M_2_3;
  M[30] = M_2_3;
}

}  // namespace samm

#undef TREELINE_RESTRICT
