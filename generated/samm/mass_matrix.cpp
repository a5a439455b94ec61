// SPDX-License-Identifier: 0BSD
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

  // constants
  const Real minus_h_8_y = 0.0028799999999999997;
  const Real minus_link6_to_7_y = 0.4331;
  const Real minus_h_6_x = 0.025374999999999998;
  const Real minus_h_6_y = 0.861795;
  const Real minus_J_6_xy = 0.010673638499999999;
  const Real J_6_xx = 0.3056901365;
  const Real J_6_yy = 0.0067651125;
  const Real link5_to_6_x = 0.4318;
  const Real minus_link6_to_7_x = 0.0203;
  const Real link5_to_6_z = 0.1501;
  const Real J_6_yz = 0.004704000000000001;
  const Real h_5_y = 0.10439999999999999;
  const Real h_5_x = 3.79559;
  const Real J_9_zz = 4e-05;
  const Real minus_J_5_xz = 0.690314699;
  const Real minus_J_5_yz = 0.023750999999999998;
  const Real h_4_y = 4.9338049999999996;
  const Real J_5_yy = 1.674987602;
  const Real J_6_zz = 0.312455249;
  const Real J_4_zz = 1.4717295504999999;
  const Real J_5_zz = 1.7481140020000001;
  const Real mass_2 = 186.45;

  // sines and cosines
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

  // links 7 (link4) and 8 (link5), composite inertia
  const Real t1 = 0.00020215999999999998 * s8;
  const Real t2 = minus_h_8_y * s8;
  const Real t3 = minus_h_8_y * c8;
  const Real t4 = link5_to_6_x * c5;
  const Real t5 = link5_to_6_x * s5;
  M[70] = 0.00064216;
  const Real t6 = s8 * t1;
  const Real t7 = c7 * t2;
  const Real t8 = c8 * t1;
  const Real t9 = s7 * t2;
  const Real minus_c56 = s5 * s6 - c5 * c6;
  const Real s56 = s5 * c6 + c5 * s6;
  M[80] = J_9_zz;

  // links 8 (link5) and 9 (link6), mass matrix; links 7 (link4) and 8 (link5), composite inertia
  const Real t10 = J_9_zz * s8;
  const Real t11 = minus_h_6_y + t3;
  const Real t12 = c7 * t3;
  const Real t13 = s7 * t3;
  const Real M_6_6 = 0.00164 + t6;
  M[60] = M_6_6;

  // link 7 (link4), composite inertia and mass matrix
  const Real t14 = t7 - minus_h_6_x;
  const Real t15 = s7 * (0.00010000000000000005 + t6);
  const Real t16 = minus_link6_to_7_x * t7;
  const Real t17 = c7 * t8 + minus_link6_to_7_y * t7;
  const Real M_5_6 = s7 * t8 + minus_link6_to_7_y * t9;
  M[51] = -M_5_6;
  M[59] = -M_5_6;
  const Real t18 = minus_c56 * t9;
  const Real t19 = s7 * t15;
  const Real t20 = J_6_yy + (M_6_6 - 0.0406 * t7);

  // link 6 (link3), composite inertia; link 8 (link5), mass matrix
  const Real t21 = minus_c56 * t14 - s56 * t11;
  const Real t22 = s56 * t14 + minus_c56 * t11;
  const Real t23 = minus_c56 * t12 + s56 * t2;
  const Real t24 = t4 * t21;
  const Real t25 = t5 * t22 - t24;

  // link 9 (link6), mass matrix; links 5 (link2) and 6 (link3), composite inertia
  const Real M_6_8 = J_9_zz * c8;
  M[62] = M_6_8;
  M[78] = M_6_8;
  const Real t26 = h_5_y * s5 - h_5_x * c5 + t21;
  const Real s34 = s3 * c4 + c3 * s4;
  const Real c34 = c3 * c4 - s3 * s4;
  const Real t27 = h_4_y + t9;

  // links 6 (link3) and 7 (link4), composite inertia
  const Real M_2_5 = minus_c56 * (J_6_yz + M_5_6) - s56 * (minus_link6_to_7_x * t9 - c7 * t15) +
      link5_to_6_z * t22;
  M[23] = M_2_5;
  M[32] = M_2_5;
  M[47] = M_2_5;
  M[48] = M_2_5;
  const Real M_5_5 = J_6_zz + (0.0012921599999999999 - t19 + 2.0 * (0.001247328 * c8 - t16));
  M[50] = M_5_5;
  const Real t28 = h_5_x * s5 + h_5_y * c5 + t22;
  const Real t29 = minus_c56 * (2.0 * (t17 - 5.8463999999999995e-05 * c8 - minus_J_6_xy)) - s56 *
      (J_6_xx + (0.0011921599999999998 - t6 + t19 + 0.002494656 * c8) - t20);

  // links 5 (link2) and 8 (link5), mass matrix
  const Real M_5_7 = 0.00064216 * c7 + (minus_link6_to_7_y * t12 - 5.8463999999999995e-05 * s8);
  M[52] = M_5_7;
  M[68] = M_5_7;
  const Real M_0_4 = c34 * t28;
  M[4] = -M_0_4;
  M[36] = -M_0_4;

  // links 5 (link2) and 6 (link3), mass matrix
  const Real M_0_5 = c34 * t22;
  M[5] = -M_0_5;
  M[45] = -M_0_5;
  const Real M_1_4 = s34 * t28;
  M[13] = -M_1_4;
  M[37] = -M_1_4;
  const Real M_1_5 = s34 * t22;
  M[14] = -M_1_5;
  M[46] = -M_1_5;

  // link 9 (link6), mass matrix
  const Real M_4_8 = s7 * t10;
  M[44] = M_4_8;
  M[53] = M_4_8;
  M[76] = M_4_8;
  M[77] = M_4_8;

  // link 4 (link1), composite inertia
  const Real M_0_2 = c34 * t27 - s34 * t26;
  M[2] = -M_0_2;
  M[3] = -M_0_2;
  M[18] = -M_0_2;
  M[27] = -M_0_2;

  // links 7 (link4) and 8 (link5), mass matrix
  const Real M_0_6 = c34 * t18 - s34 * t7;
  M[6] = M_0_6;
  M[54] = M_0_6;
  const Real M_0_7 = c34 * t23 + s34 * t13;
  M[7] = -M_0_7;
  M[63] = -M_0_7;

  // link 4 (link1), composite inertia
  const Real M_1_2 = c34 * t26 + s34 * t27;
  M[11] = -M_1_2;
  M[12] = -M_1_2;
  M[19] = -M_1_2;
  M[28] = -M_1_2;

  // links 7 (link4) and 8 (link5), mass matrix
  const Real M_1_6 = s34 * t18 + c34 * t7;
  M[15] = M_1_6;
  M[55] = M_1_6;
  const Real M_1_7 = c34 * t13 - s34 * t23;
  M[16] = M_1_7;
  M[64] = M_1_7;

  // link 6 (link3), composite inertia
  const Real M_2_4 = minus_J_5_xz * s5 + minus_J_5_yz * c5 + M_2_5 + t5 * t9;
  M[22] = M_2_4;
  M[31] = M_2_4;
  M[38] = M_2_4;
  M[39] = M_2_4;

  // link 7 (link4), mass matrix
  const Real M_2_6 = s56 * t17 + minus_c56 * (t16 - M_6_6) + (t4 * t7 - link5_to_6_z * t18);
  M[24] = M_2_6;
  M[33] = M_2_6;
  M[56] = M_2_6;
  M[57] = M_2_6;

  // link 8 (link5), mass matrix
  const Real M_2_7 = s56 * (0.00064216 * s7 + minus_link6_to_7_y * t13) + link5_to_6_z * t23 +
      (minus_link6_to_7_x * minus_c56 + t4) * t13;
  M[25] = M_2_7;
  M[34] = M_2_7;
  M[65] = M_2_7;
  M[66] = M_2_7;

  // link 9 (link6), mass matrix; link 6 (link3), composite inertia
  const Real M_2_8 = s56 * (c7 * t10) + minus_c56 * M_6_8;
  M[26] = -M_2_8;
  M[35] = -M_2_8;
  M[74] = -M_2_8;
  M[75] = -M_2_8;
  M[40] = J_5_zz + (M_5_5 + 2.0 * t25);

  // links 6 (link3) and 7 (link4), mass matrix
  const Real M_4_5 = M_5_5 + t25;
  M[41] = M_4_5;
  M[49] = M_4_5;
  const Real M_4_6 = M_5_6 + (t4 * (s56 * t9) + t5 * t18);
  M[42] = -M_4_6;
  M[58] = -M_4_6;

  // link 8 (link5), mass matrix; link 6 (link3), composite inertia
  const Real M_4_7 = M_5_7 + (t5 * t23 - t4 * (minus_c56 * t2 - s56 * t12));
  M[43] = M_4_7;
  M[67] = M_4_7;
  M[0] = mass_2;
  M[10] = mass_2;
  const Real t30 = J_5_yy - s5 * (1.601861202 * s5 + 0.0141984 * c5) +
      (t20 - s56 * t29 + 2.0 * (link5_to_6_z * t9 - t24));

  // links 4 (link1) and 5 (link2), composite inertia
  M[20] = 8.6717295505 + t30;
  const Real M_2_3 = J_4_zz + t30;
  M[21] = M_2_3;
  M[29] = M_2_3;
  M[30] = M_2_3;
}

}  // namespace samm

#undef TREELINE_RESTRICT
