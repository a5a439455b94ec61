// SPDX-License-Identifier: 0BSD
// mass_matrix: tau = M qdd + b + g: the matrix M
// By composite rigid bodies, RBDA table 6.2.
// 139 flops (add 59, mul 80, div 0), sine and cosine of 4 angles
// Generated; see puma560.hpp for the contract.
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

  // constants
  const Real minus_h_5_y = 0.0028799999999999997;
  const Real minus_link3_to_4_y = 0.4331;
  const Real minus_J_3_xy = 0.010673638499999999;
  const Real minus_h_3_x = 0.025374999999999998;
  const Real minus_h_3_y = 0.861795;
  const Real J_3_xx = 0.3056901365;
  const Real J_3_yy = 0.0067651125;
  const Real link2_to_3_x = 0.4318;
  const Real minus_link3_to_4_x = 0.0203;
  const Real link2_to_3_z = 0.1501;
  const Real J_3_yz = 0.004704000000000001;
  const Real J_6_zz = 4e-05;
  const Real minus_J_2_xz = 0.690314699;
  const Real minus_J_2_yz = 0.023750999999999998;
  const Real J_2_yy = 1.674987602;
  const Real J_3_zz = 0.312455249;
  const Real J_1_zz = 1.4717295504999999;
  const Real J_2_zz = 1.7481140020000001;

  // sines and cosines
  const Real angles[4] = {q[1], q[4], q[3], q[2]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real s5 = sines[1];
  const Real c4 = cosines[2];
  const Real c3 = cosines[3];
  const Real s3 = sines[3];
  const Real c5 = cosines[1];
  const Real s4 = sines[2];

  // link 5 (link5), composite inertia; link 6 (link6), mass matrix
  const Real t1 = 0.00020215999999999998 * s5;
  const Real t2 = minus_h_5_y * s5;
  const Real t3 = minus_h_5_y * c5;
  const Real t4 = link2_to_3_x * c2;
  const Real t5 = link2_to_3_x * s2;
  M[28] = 0.00064216;
  M[35] = J_6_zz;
  const Real t6 = J_6_zz * s5;
  const Real t7 = s5 * t1;
  const Real t8 = c5 * t1;

  // link 4 (link4), composite inertia; link 5 (link5), mass matrix
  const Real t9 = c4 * t2;
  const Real t10 = s4 * t2;
  const Real minus_c23 = s2 * s3 - c2 * c3;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real t11 = minus_h_3_y + t3;
  const Real t12 = s4 * t3;
  const Real t13 = c4 * t3;

  // link 6 (link6), mass matrix; link 5 (link5), composite inertia
  const Real M_3_5 = J_6_zz * c5;
  M[23] = M_3_5;
  M[33] = M_3_5;
  const Real M_3_3 = 0.00164 + t7;
  M[21] = M_3_3;

  // link 4 (link4), composite inertia and mass matrix
  const Real t14 = t9 - minus_h_3_x;
  const Real t15 = s4 * (0.00010000000000000005 + t7);
  const Real t16 = minus_link3_to_4_x * t9;
  const Real t17 = c4 * t8 + minus_link3_to_4_y * t9;
  const Real M_2_3 = s4 * t8 + minus_link3_to_4_y * t10;
  M[15] = -M_2_3;
  M[20] = -M_2_3;
  const Real t18 = minus_c23 * t10;
  const Real t19 = s4 * t15;
  const Real t20 = J_3_yy + (M_3_3 - 0.0406 * t9);

  // links 3 (link3) and 4 (link4), composite inertia; link 5 (link5), mass matrix
  const Real t21 = s23 * t14 + minus_c23 * t11;
  const Real t22 = minus_c23 * t13 + s23 * t2;
  const Real t23 = t4 * (minus_c23 * t14 - s23 * t11);
  const Real t24 = t5 * t21 - t23;
  const Real M_2_2 = J_3_zz + (0.0012921599999999999 - t19 + 2.0 * (0.001247328 * c5 - t16));
  M[14] = M_2_2;
  const Real M_0_2 = minus_c23 * (J_3_yz + M_2_3) - s23 * (minus_link3_to_4_x * t10 - c4 * t15) +
      link2_to_3_z * t21;
  M[2] = M_0_2;
  M[12] = M_0_2;
  const Real M_2_4 = 0.00064216 * c4 + (minus_link3_to_4_y * t13 - 5.8463999999999995e-05 * s5);
  M[16] = M_2_4;
  M[26] = M_2_4;

  // links 3 (link3) and 6 (link6), mass matrix
  const Real M_1_5 = s4 * t6;
  M[11] = M_1_5;
  M[17] = M_1_5;
  M[31] = M_1_5;
  M[32] = M_1_5;
  const Real M_1_2 = M_2_2 + t24;
  M[8] = M_1_2;
  M[13] = M_1_2;

  // links 4 (link4) and 5 (link5), mass matrix
  const Real M_0_3 = s23 * t17 + minus_c23 * (t16 - M_3_3) + (t4 * t9 - link2_to_3_z * t18);
  M[3] = M_0_3;
  M[18] = M_0_3;
  const Real M_0_4 = s23 * (0.00064216 * s4 + minus_link3_to_4_y * t12) + link2_to_3_z * t22 +
      (minus_link3_to_4_x * minus_c23 + t4) * t12;
  M[4] = M_0_4;
  M[24] = M_0_4;

  // links 4 (link4) and 6 (link6), mass matrix
  const Real M_0_5 = s23 * (c4 * t6) + minus_c23 * M_3_5;
  M[5] = -M_0_5;
  M[30] = -M_0_5;
  const Real M_1_3 = M_2_3 + (t4 * (s23 * t10) + t5 * t18);
  M[9] = -M_1_3;
  M[19] = -M_1_3;

  // link 3 (link3), composite inertia; link 5 (link5), mass matrix
  M[7] = J_2_zz + (M_2_2 + 2.0 * t24);
  const Real M_1_4 = M_2_4 + (t5 * t22 - t4 * (minus_c23 * t2 - s23 * t13));
  M[10] = M_1_4;
  M[25] = M_1_4;
  const Real t25 = minus_c23 * (2.0 * (t17 - 5.8463999999999995e-05 * c5 - minus_J_3_xy)) - s23 *
      (J_3_xx + (0.0011921599999999998 - t7 + t19 + 0.002494656 * c5) - t20);

  // links 2 (link2) and 3 (link3), composite inertia
  const Real M_0_1 = minus_J_2_xz * s2 + minus_J_2_yz * c2 + M_0_2 + t5 * t10;
  M[1] = M_0_1;
  M[6] = M_0_1;
  const Real t26 = J_2_yy - s2 * (1.601861202 * s2 + 0.0141984 * c2) +
      (t20 - s23 * t25 + 2.0 * (link2_to_3_z * t10 - t23));
  M[0] = J_1_zz + t26;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
