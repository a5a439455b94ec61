// SPDX-License-Identifier: 0BSD
// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1.
// 262 flops (add 110, mul 152, div 0), sine and cosine of 4 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void inverse_dynamics(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT qdd)[6], Real (&TREELINE_RESTRICT tau)[6]) noexcept {
  // constants
  const Real minus_link2_to_3_x = 0.6127;
  const Real minus_link3_to_4_x = 0.57155;
  const Real minus_gravity_z = 9.81;
  const Real link4_to_5_z = 0.17415;
  const Real J_5_xx = 0.0069705910375000004;
  const Real minus_J_5_yz = 0.0106962107625;
  const Real h_5_y = 0.09132825;
  const Real J_5_yy = 0.00124;
  const Real J_2_xz = 1.156008191975;
  const Real J_6_zz = 0.000623;
  const Real J_3_xz = 0.5656542411875001;
  const Real minus_h_4_y = 0.33495075;
  const Real J_4_xx = 0.0384148163875;
  const Real J_4_yz = 0.0585962731125;
  const Real minus_h_3_x = 4.0059802;
  const Real J_5_zz = 0.008210591037500001;
  const Real J_4_yy = 0.001315;
  const Real J_4_zz = 0.0397298163875;
  const Real J_3_zz = 2.08330527531;
  const Real J_2_zz = 4.3866871861500005;
  const Real J_3_yy = 2.08081027531;

  // sines and cosines
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];

  // links 1 to 3, outward
  const Real w3_z = qd[1] + qd[2];
  const Real t1 = qd[1] * qd[1];
  const Real t2 = minus_link2_to_3_x * s2;
  const Real t3 = minus_link2_to_3_x * c2;
  const Real t4 = qd[0] * qd[0];
  const Real wd3_z = qdd[1] + qdd[2];

  // link 2 (upper_arm), outward
  const Real t5 = 2.0 * qd[0];
  const Real t6 = 4.36318718615 * s2;
  const Real t7 = J_2_xz * s2;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real c23 = c2 * c3 - s2 * s3;

  // links 2 to 4, outward
  const Real w4_z = w3_z + qd[3];
  const Real t8 = w3_z * w3_z;
  const Real wd4_z = wd3_z + qdd[3];
  const Real t9 = t5 * w3_z;
  const Real t10 = t5 * qd[1];

  // links 3 (forearm) and 4 (wrist_1), outward
  const Real t11 = minus_link3_to_4_x * s23;
  const Real t12 = minus_link3_to_4_x * c23;
  const Real t13 = t4 + t8;
  const Real t14 = c2 * t6;
  const Real t15 = w4_z * w4_z;
  const Real c234 = c23 * c4 - s23 * s4;
  const Real s234 = s23 * c4 + c23 * s4;
  const Real t16 = 2.07831527531 * s23;
  const Real a3_y = minus_gravity_z + (t1 * t2 - qdd[1] * t3);
  const Real a3_x = (t4 + t1) * t3 + qdd[1] * t2;
  const Real w4_y = c234 * qd[0];
  const Real w4_x = s234 * qd[0];
  const Real t17 = s234 * qdd[0];
  const Real t18 = c234 * qdd[0];
  const Real a3_z = qdd[0] * t3 - t10 * t2;
  const Real t19 = J_3_xz * s23;
  const Real t20 = c23 * t16;
  const Real t21 = minus_h_3_x * c23;
  const Real t22 = minus_h_3_x * s23;
  const Real t23 = w4_x * w4_y;

  // links 4 (wrist_1) and 5 (wrist_2), outward
  const Real w5_z = qd[4] - w4_y;
  const Real t24 = a3_y + (t8 * t11 - wd3_z * t12);
  const Real t25 = a3_x + (t13 * t12 + wd3_z * t11);
  const Real t26 = w4_x * w4_z;
  const Real a4_z = a3_z + (qdd[0] * t12 - t9 * t11);
  const Real t27 = 2.0 * w5_z;
  const Real t28 = w5_z * w5_z;
  const Real t29 = t23 - wd4_z;
  const Real w5_y = c5 * w4_z - s5 * w4_x;
  const Real w5_x = c5 * w4_x + s5 * w4_z;
  const Real wd4_y = t18 - t26;
  const Real t30 = t17 + 2.0 * (w4_y * w4_z);
  const Real t31 = w5_x * w5_z;

  // links 4 to 6, outward
  const Real w6_z = w5_y + qd[5];
  const Real t32 = w5_x * w5_y;
  const Real a4_y = c234 * t24 - s234 * t25;
  const Real wd5_z = qdd[4] - wd4_y;
  const Real a4_x = c234 * t25 + s234 * t24;

  // link 5 (wrist_2), outward and inertial wrench
  const Real minus_a5_z = a4_y - link4_to_5_z * t17;
  const Real t33 = t32 - wd5_z;
  const Real t34 = c5 * t29 + s5 * t30;
  const Real f5_x = h_5_y * t33;
  const Real minus_f5_y = h_5_y * (w5_x * w5_x + t28);

  // links 5 (wrist_2) and 6 (wrist_3), outward; link 2 (upper_arm), inward
  const Real t35 = t27 * w5_y - (s5 * t29 - c5 * t30);
  const Real minus_wd5_y = t34 + t31;
  const Real t36 = qdd[1] * t7 - t10 * t14 + J_2_xz * t1 * c2 + wd3_z * t19;
  const Real a5_x = c5 * (a4_x + link4_to_5_z * t18) + s5 * (a4_z - link4_to_5_z * t4);
  const Real wd6_z = qdd[5] - minus_wd5_y;

  // links 5 (wrist_2) and 6 (wrist_3), inertial wrench
  const Real f5_z = h_5_y * t35;
  const Real n6_y = 0.0003115 * (2.0 * (w5_x * w6_z) - t33);
  const Real n6_x = 0.0003115 * (t27 * w6_z - t35);
  const Real n6_z = J_6_zz * wd6_z;
  tau[5] = n6_z;

  // links 5 (wrist_2) and 6 (wrist_3), inward
  const Real t37 = c5 * f5_x + s5 * minus_f5_y;
  const Real f4_y = minus_h_4_y * (w4_x * w4_x + t15) - f5_z;
  const Real f4_x = t37 - minus_h_4_y * t29;
  const Real n5_z = J_5_zz * wd5_z - 0.005730591037500001 * t32 + minus_J_5_yz * t34 - h_5_y *
      a5_x + n6_y;
  tau[4] = n5_z;
  const Real n5_x = J_5_xx * t35 + minus_J_5_yz * (t28 - w5_y * w5_y) - h_5_y * minus_a5_z - n6_x;
  const Real n5_y = minus_J_5_yz * t33 - J_5_yy * (t31 + minus_wd5_y) + n6_z;

  // links 4 (wrist_1) and 5 (wrist_2), inward
  const Real t38 = c234 * f4_x - s234 * f4_y;
  const Real t39 = s234 * f4_x + c234 * f4_y;
  const Real n4_y = link4_to_5_z * t37 - n5_z - (J_4_yy * (t26 - wd4_y) + J_4_yz * t29);
  const Real f4_z = s5 * f5_x - c5 * minus_f5_y - minus_h_4_y * t30;
  const Real f3_x = t13 * t21 + wd3_z * t22 + t38;
  const Real f3_y = t8 * t22 - wd3_z * t21 + t39;
  const Real n4_z = J_4_zz * wd4_z - 0.037099816387500005 * t23 + J_4_yz * t18 + minus_h_4_y *
      a4_x + (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

  // links 4 (wrist_1) and 5 (wrist_2), inward; link 3 (forearm), inertial wrench
  const Real f3_z = qdd[0] * t21 - t9 * t22 + f4_z;
  const Real t40 = J_3_zz * wd3_z + qdd[0] * t19 + t4 * t20 + (t22 * a3_x - t21 * a3_y);
  const Real n4_x = J_4_xx * t30 - J_4_yz * (t15 - w4_y * w4_y) - minus_h_4_y * a4_z +
      (c5 * n5_x - s5 * n5_y + 0.0159048147375 * t35);
  const Real n3_z = t40 + (n4_z + (t11 * t38 - t12 * t39));
  tau[2] = n3_z;

  // links 2 (upper_arm) and 3 (forearm), inward
  const Real t41 = t36 - t9 * t20 + J_3_xz * t8 * c23 + t21 * a3_z + s234 * n4_x;
  const Real n2_z = J_2_zz * qdd[1] + qdd[0] * t7 + t4 * t14 - 81.988590645 * c2 +
      (n3_z + (t2 * f3_x - t3 * f3_y));
  tau[1] = n2_z;
  const Real n1_z = t41 + c234 * n4_y + t12 * f4_z + t3 * f3_z +
      (4.910283130787501 - s2 * t6 + (J_3_yy - s23 * t16)) * qdd[0];
  tau[0] = n1_z;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
