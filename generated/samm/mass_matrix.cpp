// mass_matrix: tau = M qdd + b + g: the matrix M
// By composite rigid bodies, RBDA table 6.2.
// 177 flops (add 73, mul 104, div 0), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
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
  const Real c5 = cosines[4];
  const Real s6 = sines[5];
  const Real c6 = cosines[5];
  const Real c7 = cosines[2];
  const Real c8 = cosines[3];

  // link 8 (link5), composite inertia
  const Real M_2_2_p1 = 0.00020215999999999998 * s8;
  const Real M_2_2_p2 = 0.0028799999999999997 * s8;
  const Real M_2_2_p3 = 0.0028799999999999997 * c8;
  const Real M_2_2_p4 = 0.4318 * c5;
  const Real M_4_4_p1 = 0.4318 * s5;
  M[70] = 0.00064216;
  const Real M_2_2_p5 = s8 * M_2_2_p1;

  // link 7 (link4), composite inertia
  const Real M_2_2_p6 = c7 * M_2_2_p2;

  // link 8 (link5), composite inertia
  const Real M_2_2_p7 = c8 * M_2_2_p1;

  // link 7 (link4), composite inertia
  const Real M_5_6_p1 = s7 * M_2_2_p2;
  const Real M_4_4_p2 = s5 * s6 - c5 * c6;
  const Real M_2_2_p8 = s5 * c6 + c5 * s6;
  M[80] = 4e-05;

  // link 9 (link6), mass matrix
  const Real M_2_8_p1 = 4e-05 * s8;

  // link 7 (link4), composite inertia
  const Real M_2_2_p9 = 0.861795 + M_2_2_p3;

  // link 8 (link5), mass matrix
  const Real M_2_7_p1 = c7 * M_2_2_p3;
  const Real M_2_7_p2 = s7 * M_2_2_p3;

  // link 8 (link5), composite inertia
  const Real M_6_6 = 0.00164 + M_2_2_p5;
  M[60] = M_6_6;

  // link 7 (link4), composite inertia
  const Real M_2_2_p10 = M_2_2_p6 - 0.025374999999999998;
  const Real M_2_2_p11 = s7 * (0.00010000000000000026 + M_2_2_p5);
  const Real M_5_5_p1 = 0.0203 * M_2_2_p6;
  const Real M_2_2_p12 = c7 * M_2_2_p7 + 0.4331 * M_2_2_p6;
  const Real M_5_6 = s7 * M_2_2_p7 + 0.4331 * M_5_6_p1;
  M[51] = -M_5_6;
  M[59] = -M_5_6;

  // link 7 (link4), mass matrix
  const Real M_2_6_p1 = M_4_4_p2 * M_5_6_p1;

  // link 7 (link4), composite inertia
  const Real M_2_2_p13 = s7 * M_2_2_p11;
  const Real M_2_2_p14 = 0.0067651125 + (M_6_6 - 0.0406 * M_2_2_p6);

  // link 6 (link3), composite inertia
  const Real M_2_2_p15 = M_4_4_p2 * M_2_2_p10 - M_2_2_p8 * M_2_2_p9;
  const Real M_4_4_p3 = M_2_2_p8 * M_2_2_p10 + M_4_4_p2 * M_2_2_p9;

  // link 8 (link5), mass matrix
  const Real M_2_7_p3 = M_4_4_p2 * M_2_7_p1 + M_2_2_p8 * M_2_2_p2;

  // link 6 (link3), composite inertia
  const Real M_2_2_p16 = M_2_2_p4 * M_2_2_p15;
  const Real M_4_4_p4 = M_4_4_p1 * M_4_4_p3 - M_2_2_p16;

  // link 9 (link6), mass matrix
  const Real M_6_8 = 4e-05 * c8;
  M[62] = M_6_8;
  M[78] = M_6_8;

  // link 6 (link3), composite inertia
  const Real M_0_2_p1 = 0.10439999999999999 * s5 - 3.79559 * c5 + M_2_2_p15;
  const Real M_0_2_p2 = s3 * c4 + c3 * s4;
  const Real M_0_2_p3 = c3 * c4 - s3 * s4;

  // link 5 (link2), composite inertia
  const Real M_0_2_p4 = 4.9338049999999996 + M_5_6_p1;

  // link 6 (link3), composite inertia
  const Real M_2_5 = M_4_4_p2 * (0.004704000000000001 + M_5_6) - M_2_2_p8 *
      (0.0203 * M_5_6_p1 - c7 * M_2_2_p11) + 0.1501 * M_4_4_p3;
  M[23] = M_2_5;
  M[32] = M_2_5;
  M[47] = M_2_5;
  M[48] = M_2_5;

  // link 7 (link4), composite inertia
  const Real M_5_5 = 0.312455249 + (0.00129216 - M_2_2_p13 + 2.0 *
      (0.0012473279999999998 * c8 - M_5_5_p1));
  M[50] = M_5_5;

  // link 6 (link3), composite inertia
  const Real M_0_4_p1 = 3.79559 * s5 + 0.10439999999999999 * c5 + M_4_4_p3;
  const Real M_2_2_p17 = M_4_4_p2 * (2.0 * (M_2_2_p12 - 5.846399999999999e-05 * c8 -
      0.010673638499999999)) - M_2_2_p8 * (0.3056901365 +
      (0.0011921599999999998 - M_2_2_p5 + M_2_2_p13 + 0.0024946559999999996 * c8) - M_2_2_p14);

  // link 8 (link5), mass matrix
  const Real M_5_7 = 0.00064216 * c7 + (0.4331 * M_2_7_p1 - 5.846399999999999e-05 * s8);
  M[52] = M_5_7;
  M[68] = M_5_7;

  // link 5 (link2), mass matrix
  const Real M_0_4 = M_0_2_p3 * M_0_4_p1;
  M[4] = -M_0_4;
  M[36] = -M_0_4;

  // link 6 (link3), mass matrix
  const Real M_0_5 = M_0_2_p3 * M_4_4_p3;
  M[5] = -M_0_5;
  M[45] = -M_0_5;

  // link 5 (link2), mass matrix
  const Real M_1_4 = M_0_2_p2 * M_0_4_p1;
  M[13] = -M_1_4;
  M[37] = -M_1_4;

  // link 6 (link3), mass matrix
  const Real M_1_5 = M_0_2_p2 * M_4_4_p3;
  M[14] = -M_1_5;
  M[46] = -M_1_5;

  // link 9 (link6), mass matrix
  const Real M_4_8 = s7 * M_2_8_p1;
  M[44] = M_4_8;
  M[53] = M_4_8;
  M[76] = M_4_8;
  M[77] = M_4_8;

  // link 4 (link1), composite inertia
  const Real M_0_2 = M_0_2_p3 * M_0_2_p4 - M_0_2_p2 * M_0_2_p1;
  M[2] = -M_0_2;
  M[3] = -M_0_2;
  M[18] = -M_0_2;
  M[27] = -M_0_2;

  // link 7 (link4), mass matrix
  const Real M_0_6 = M_0_2_p3 * M_2_6_p1 - M_0_2_p2 * M_2_2_p6;
  M[6] = M_0_6;
  M[54] = M_0_6;

  // link 8 (link5), mass matrix
  const Real M_0_7 = M_0_2_p3 * M_2_7_p3 + M_0_2_p2 * M_2_7_p2;
  M[7] = -M_0_7;
  M[63] = -M_0_7;

  // link 4 (link1), composite inertia
  const Real M_1_2 = M_0_2_p3 * M_0_2_p1 + M_0_2_p2 * M_0_2_p4;
  M[11] = -M_1_2;
  M[12] = -M_1_2;
  M[19] = -M_1_2;
  M[28] = -M_1_2;

  // link 7 (link4), mass matrix
  const Real M_1_6 = M_0_2_p2 * M_2_6_p1 + M_0_2_p3 * M_2_2_p6;
  M[15] = M_1_6;
  M[55] = M_1_6;

  // link 8 (link5), mass matrix
  const Real M_1_7 = M_0_2_p3 * M_2_7_p2 - M_0_2_p2 * M_2_7_p3;
  M[16] = M_1_7;
  M[64] = M_1_7;

  // link 6 (link3), composite inertia
  const Real M_2_4 = 0.690314699 * s5 + 0.023750999999999998 * c5 + M_2_5 + M_4_4_p1 * M_5_6_p1;
  M[22] = M_2_4;
  M[31] = M_2_4;
  M[38] = M_2_4;
  M[39] = M_2_4;

  // link 7 (link4), mass matrix
  const Real M_2_6 = M_2_2_p8 * M_2_2_p12 + M_4_4_p2 * (M_5_5_p1 - M_6_6) +
      (M_2_2_p4 * M_2_2_p6 - 0.1501 * M_2_6_p1);
  M[24] = M_2_6;
  M[33] = M_2_6;
  M[56] = M_2_6;
  M[57] = M_2_6;

  // link 8 (link5), mass matrix
  const Real M_2_7 = M_2_2_p8 * (0.00064216 * s7 + 0.4331 * M_2_7_p2) + 0.1501 * M_2_7_p3 +
      (0.0203 * M_4_4_p2 + M_2_2_p4) * M_2_7_p2;
  M[25] = M_2_7;
  M[34] = M_2_7;
  M[65] = M_2_7;
  M[66] = M_2_7;

  // link 9 (link6), mass matrix
  const Real M_2_8 = M_2_2_p8 * (c7 * M_2_8_p1) + M_4_4_p2 * M_6_8;
  M[26] = -M_2_8;
  M[35] = -M_2_8;
  M[74] = -M_2_8;
  M[75] = -M_2_8;

  // link 6 (link3), composite inertia
  M[40] = 1.7481140020000001 + (M_5_5 + 2.0 * M_4_4_p4);

  // link 6 (link3), mass matrix
  const Real M_4_5 = M_5_5 + M_4_4_p4;
  M[41] = M_4_5;
  M[49] = M_4_5;

  // link 7 (link4), mass matrix
  const Real M_4_6 = M_5_6 + (M_2_2_p4 * (M_2_2_p8 * M_5_6_p1) + M_4_4_p1 * M_2_6_p1);
  M[42] = -M_4_6;
  M[58] = -M_4_6;

  // link 8 (link5), mass matrix
  const Real M_4_7 = M_5_7 + (M_4_4_p1 * M_2_7_p3 - M_2_2_p4 *
      (M_4_4_p2 * M_2_2_p2 - M_2_2_p8 * M_2_7_p1));
  M[43] = M_4_7;
  M[67] = M_4_7;
  M[0] = 186.45;
  M[10] = 186.45;

  // link 6 (link3), composite inertia
  const Real M_2_2_p18 = 1.674987602 - s5 * (1.601861202 * s5 + 0.0141984 * c5) +
      (M_2_2_p14 - M_2_2_p8 * M_2_2_p17 + 2.0 * (0.1501 * M_5_6_p1 - M_2_2_p16));

  // link 4 (link1), composite inertia
  M[20] = 8.6717295505 + M_2_2_p18;

  // link 5 (link2), composite inertia
  const Real M_2_3 = 1.4717295504999999 + M_2_2_p18;
  M[21] = M_2_3;
  M[29] = M_2_3;
  M[30] = M_2_3;
}

}  // namespace samm

#undef TREELINE_RESTRICT
