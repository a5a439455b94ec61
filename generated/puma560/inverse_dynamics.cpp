// SPDX-License-Identifier: 0BSD
// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1.
// 277 flops (add 119, mul 158, div 0), sine and cosine of 4 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void inverse_dynamics(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT qdd)[6], Real (&TREELINE_RESTRICT tau)[6]) noexcept {
  // constants
  const Real link2_to_3_x = 0.4318;
  const Real link2_to_3_z = 0.1501;
  const Real minus_gravity_z = 9.81;
  const Real minus_link3_to_4_x = 0.0203;
  const Real minus_link3_to_4_y = 0.4331;
  const Real J_5_xx = 0.00042216;
  const Real minus_h_5_y = 0.0028799999999999997;
  const Real J_5_yy = 2e-04;
  const Real J_6_zz = 4e-05;
  const Real J_4_zz = 0.0014;
  const Real J_3_yy = 0.0067651125;
  const Real J_3_yz = 0.004704000000000001;
  const Real minus_J_3_xy = 0.010673638499999999;
  const Real minus_h_3_x = 0.025374999999999998;
  const Real minus_J_2_xz = 0.690314699;
  const Real minus_J_2_yz = 0.023750999999999998;
  const Real minus_J_2_xy = 0.0070992;
  const Real J_4_xx = 0.0007499999999999999;
  const Real J_5_zz = 0.00062216;
  const Real J_4_yy = 0.00065;
  const Real J_3_xx = 0.3056901365;
  const Real minus_h_3_y = 0.861795;
  const Real J_3_zz = 0.312455249;
  const Real h_2_y = 0.10439999999999999;
  const Real h_2_x = 3.79559;
  const Real J_2_zz = 1.7481140020000001;

  // sines and cosines
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real c3 = cosines[1];
  const Real s4 = sines[2];
  const Real c4 = cosines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];

  // links 1 to 3, outward
  const Real w3_z = qd[1] + qd[2];
  const Real t1 = qd[0] * qd[0];
  const Real t2 = qd[1] * qd[1];
  const Real t3 = link2_to_3_x * c2;
  const Real t4 = link2_to_3_x * s2;
  const Real wd2_x = qd[0] * qd[1];
  const Real wd3_z = qdd[1] + qdd[2];
  const Real minus_c23 = s2 * s3 - c2 * c3;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real t5 = w3_z * w3_z;
  const Real t6 = 2.0 * wd2_x;

  // links 3 (link3) and 4 (link4), outward
  const Real w3_y = minus_c23 * qd[0];
  const Real minus_w3_x = s23 * qd[0];
  const Real t7 = minus_c23 * qdd[0];
  const Real t8 = minus_w3_x * w3_z;
  const Real t9 = minus_w3_x * w3_y;
  const Real w4_z = qd[3] - w3_y;
  const Real t10 = w3_y * w3_y;
  const Real t11 = minus_gravity_z + (t2 * t4 - qdd[1] * t3);
  const Real t12 = minus_w3_x * minus_w3_x;
  const Real t13 = 1.601861202 * s2 + 0.0141984 * c2;
  const Real t14 = minus_J_2_xz * s2 + minus_J_2_yz * c2;
  const Real w4_y = s4 * minus_w3_x + c4 * w3_z;
  const Real wd3_y = t7 + t8;
  const Real t15 = t9 + wd3_z;
  const Real w4_x = s4 * w3_z - c4 * minus_w3_x;
  const Real t16 = (t1 + t2) * t3 + qdd[1] * t4 + link2_to_3_z * qdd[0];
  const Real t17 = t10 + t5;
  const Real a3_z = qdd[0] * t3 - t6 * t4 - link2_to_3_z * t1;
  const Real t18 = t12 + t5;
  const Real t19 = t8 + wd3_y;
  const Real t20 = 2.0 * (w3_y * w3_z) - s23 * qdd[0];
  const Real t21 = w4_x * w4_y;
  const Real wd4_z = qdd[3] - wd3_y;

  // links 3 to 6, outward
  const Real w5_z = w4_y + qd[4];
  const Real t22 = wd3_z - t9;
  const Real t23 = w4_x * w4_z;
  const Real t24 = t21 - wd4_z;
  const Real a3_x = minus_c23 * t16 - s23 * t11;
  const Real t25 = 2.0 * w5_z;
  const Real w5_x = c5 * w4_x - s5 * w4_z;
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;
  const Real t26 = a3_x + (minus_link3_to_4_x * t17 + minus_link3_to_4_y * t15);
  const Real t27 = w5_x * w5_z;
  const Real w6_z = minus_w5_y + qd[5];
  const Real a3_y = s23 * t16 + minus_c23 * t11;

  // links 4 (link4) and 5 (link5), outward
  const Real t28 = w5_x * minus_w5_y;
  const Real t29 = s4 * t15 + c4 * t20 + 2.0 * (w4_y * w4_z);
  const Real t30 = a3_z + (minus_link3_to_4_x * t19 - minus_link3_to_4_y * t20);
  const Real wd4_y = c4 * t15 - s4 * t20 - t23;
  const Real wd5_z = wd4_y + qdd[4];
  const Real minus_a4_z = a3_y + (minus_link3_to_4_y * t18 - minus_link3_to_4_x * t22);
  const Real a4_y = c4 * t30 - s4 * t26;
  const Real a4_x = c4 * t26 + s4 * t30;
  const Real t31 = t28 + wd5_z;

  // link 5 (link5), inertial wrench; links 5 (link5) and 6 (link6), outward
  const Real f5_y = minus_h_5_y * (w5_x * w5_x + w5_z * w5_z);
  const Real wd5_y = c5 * t24 - s5 * t29 - t27;
  const Real t32 = s5 * t24 + c5 * t29 - t25 * minus_w5_y;
  const Real f5_x = minus_h_5_y * t31;
  const Real wd6_z = qdd[5] - wd5_y;
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;
  const Real minus_f5_z = minus_h_5_y * t32;

  // link 6 (link6), inertial wrench; link 5 (link5), inward
  const Real minus_n6_y = 2e-05 * (2.0 * (w5_x * w6_z) - t31);
  const Real t33 = c2 * t13 - minus_J_2_xy;
  const Real n6_z = J_6_zz * wd6_z;
  tau[5] = n6_z;
  const Real n6_x = 2e-05 * (t32 + t25 * w6_z);
  const Real minus_f4_x = s5 * f5_y - c5 * f5_x;
  const Real minus_f4_z = s5 * f5_x + c5 * f5_y;

  // links 4 (link4) and 6 (link6), inward
  const Real minus_n5_y = J_5_yy * (t27 - wd5_y) + n6_z;
  const Real n5_x = J_5_xx * t32 - minus_h_5_y * a4_y + n6_x;
  const Real f3_y = minus_h_3_y * t18 - minus_h_3_x * t22 + minus_f4_z;
  const Real n5_z = 0.00022215999999999997 * t28 + J_5_zz * wd5_z + minus_h_5_y * a5_x - minus_n6_y;
  tau[4] = n5_z;

  // link 3 (link3), inertial wrench; links 2, 4 and 5, inward
  const Real t34 = J_3_xx * t20 - minus_J_3_xy * t19 - J_3_yz * (t5 - t10) - minus_h_3_y * a3_z;
  const Real t35 = s4 * minus_f4_x + c4 * minus_f5_z;
  const Real t36 = s4 * minus_f5_z - c4 * minus_f4_x;
  const Real n4_y = n5_z - J_4_yy * (t23 - wd4_y);
  const Real t37 = qdd[1] * t14 - t6 * t33 - t2 * (minus_J_2_yz * s2 - minus_J_2_xz * c2);
  const Real f3_x = minus_h_3_x * t17 + minus_h_3_y * t15 + t36;
  const Real n4_x = J_4_xx * t29 + (c5 * n5_x + s5 * minus_n5_y);
  const Real n4_z = J_4_zz * wd4_z - 9.999999999999996e-05 * t21 + (c5 * minus_n5_y - s5 * n5_x);
  tau[3] = n4_z;
  const Real t38 = 0.298925024 * t9 + J_3_zz * wd3_z + J_3_yz * t7 + minus_J_3_xy * (t10 - t12);

  // links 3 (link3) and 4 (link4), inward; link 2 (link2), inertial wrench
  const Real f3_z = minus_h_3_x * t19 - minus_h_3_y * t20 - t35;
  const Real n3_y = J_3_yy * t19 + J_3_yz * t15 - minus_J_3_xy * t20 + minus_h_3_x * a3_z -
      (n4_z + minus_link3_to_4_x * t35);
  const Real t39 = minus_c23 * f3_x + s23 * f3_y;
  const Real t40 = J_2_zz * qdd[1] + qdd[0] * t14 + t1 * t33 + minus_gravity_z *
      (h_2_y * s2 - h_2_x * c2);
  const Real n3_x = t34 + (c4 * n4_x - s4 * n4_y + minus_link3_to_4_y * t35);
  const Real n3_z = t38 + (minus_h_3_y * a3_x - minus_h_3_x * a3_y) +
      (s4 * n4_x + c4 * n4_y + (minus_link3_to_4_y * t36 - minus_link3_to_4_x * minus_f4_z));
  tau[2] = n3_z;

  // links 2 (link2) and 3 (link3), inward
  const Real n2_z = t40 + (n3_z + (t4 * t39 - t3 * (minus_c23 * f3_y - s23 * f3_x)));
  tau[1] = n2_z;
  const Real t41 = t37 + minus_c23 * n3_y - s23 * n3_x + link2_to_3_z * t39 + t3 * f3_z;
  const Real n1_z = t41 + (3.1467171525 - s2 * t13) * qdd[0];
  tau[0] = n1_z;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
