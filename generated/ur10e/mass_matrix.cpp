// SPDX-License-Identifier: 0BSD
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

  // constants
  const Real h_5_y = 0.09132825;
  const Real minus_h_4_y = 0.33495075;
  const Real minus_link3_to_4_x = 0.57155;
  const Real minus_J_5_yz = 0.0106962107625;
  const Real minus_h_3_x = 4.0059802;
  const Real link4_to_5_z = 0.17415;
  const Real J_4_yz = 0.0585962731125;
  const Real minus_link2_to_3_x = 0.6127;
  const Real J_5_yy = 0.00124;
  const Real J_3_xz = 0.5656542411875001;
  const Real J_3_zz = 2.08330527531;
  const Real J_2_xz = 1.156008191975;
  const Real J_6_zz = 0.000623;
  const Real J_2_zz = 4.3866871861500005;

  // sines and cosines
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
  const Real t1 = h_5_y * s5;
  const Real t2 = 0.0054190910375000005 * s5;
  const Real M_3_4 = minus_J_5_yz * c5;
  M[22] = -M_3_4;
  M[27] = -M_3_4;
  const Real t3 = minus_link2_to_3_x * c2;
  const Real t4 = h_5_y * c5;
  const Real t5 = minus_link2_to_3_x * s2;
  M[28] = 0.0085220910375;
  M[35] = J_6_zz;

  // link 6 (wrist_3), mass matrix
  const Real M_1_5 = J_6_zz * c5;
  M[11] = M_1_5;
  M[17] = M_1_5;
  M[23] = M_1_5;
  M[31] = M_1_5;
  M[32] = M_1_5;
  M[33] = M_1_5;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real c23 = c2 * c3 - s2 * s3;

  // link 5 (wrist_2), composite inertia
  const Real t6 = s5 * t2;
  const Real t7 = minus_link3_to_4_x * c23;
  const Real t8 = minus_link3_to_4_x * s23;
  const Real M_3_3 = 0.0415928163875 + t6;
  M[21] = M_3_3;
  const Real s234 = s23 * c4 + c23 * s4;
  const Real c234 = c23 * c4 - s23 * s4;
  const Real t9 = s234 * t1;

  // link 5 (wrist_2), mass matrix and composite inertia
  const Real t10 = s234 * s5;
  const Real t11 = c234 * t4;
  const Real t12 = s234 * t4;
  const Real t13 = minus_h_4_y * s234 - c234 * t1;
  const Real t14 = minus_h_4_y * c234 + t9;

  // links 2 to 4, composite inertia
  const Real t15 = t7 * t13;
  const Real t16 = 0.0098370910375 + (6.9910934060975 - s2 * (4.36318718615 * s2) - s23 *
      (2.07831527531 * s23)) + 0.031809629475 * c5;
  const Real t17 = t3 * (t13 - minus_h_3_x * c23);
  const Real t18 = t8 * t14 - t15;
  const Real t19 = (0.037099816387500005 * s234 - (s234 * (J_5_yy + t6) + c234 *
      (0.021392421525 * s5))) * s234;

  // link 6 (wrist_3), mass matrix; link 5 (wrist_2), composite inertia
  const Real M_0_5 = J_6_zz * t10;
  M[5] = -M_0_5;
  M[30] = -M_0_5;
  const Real M_0_3 = s234 * c5 * t2 + link4_to_5_z * t9 + (J_4_yz + M_3_4) * c234;
  M[3] = M_0_3;
  M[18] = M_0_3;

  // links 4 (wrist_1) and 5 (wrist_2), mass matrix; link 3 (forearm), composite inertia
  const Real M_2_4 = t7 * t12 - t8 * t11 - M_3_4;
  M[16] = M_2_4;
  M[26] = M_2_4;
  const Real t20 = t5 * (minus_h_3_x * s23 + t14) - t17;
  const Real M_2_3 = M_3_3 + t18;

  // links 4 (wrist_1) and 5 (wrist_2), mass matrix
  M[15] = M_2_3;
  M[20] = M_2_3;
  const Real M_0_4 = minus_J_5_yz * t10 - 0.0085220910375 * c234 - link4_to_5_z * t11 - (t7 + t3) *
      t1;
  M[4] = M_0_4;
  M[24] = M_0_4;
  const Real M_1_4 = M_2_4 + (t3 * t12 - t5 * t11);
  M[10] = M_1_4;
  M[25] = M_1_4;
  const Real M_1_3 = M_2_3 + (t5 * t14 - t3 * t13);
  M[9] = M_1_3;
  M[19] = M_1_3;

  // links 2 (upper_arm) and 4 (wrist_1), composite inertia
  const Real M_0_2 = J_3_xz * s23 + (M_0_3 + t8 * t4);
  M[2] = M_0_2;
  M[12] = M_0_2;
  const Real M_2_2 = J_3_zz + (M_3_3 + 2.0 * t18);
  M[14] = M_2_2;
  M[0] = t16 - 2.0 * (t15 + t17) + t19;

  // link 3 (forearm), composite inertia and mass matrix
  const Real M_0_1 = J_2_xz * s2 + (M_0_2 + t5 * t4);
  M[1] = M_0_1;
  M[6] = M_0_1;
  const Real M_1_2 = M_2_2 + t20;
  M[8] = M_1_2;
  M[13] = M_1_2;
  M[7] = J_2_zz + (M_2_2 + 2.0 * t20);
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
