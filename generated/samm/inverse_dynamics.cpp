// SPDX-License-Identifier: 0BSD
// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1.
// 326 flops (add 142, mul 184, div 0), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void inverse_dynamics(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    const Real (&TREELINE_RESTRICT qdd)[9], Real (&TREELINE_RESTRICT tau)[9]) noexcept {
  // constants
  const Real minus_h_8_y = 0.0028799999999999997;
  const Real h_4_y = 4.9338049999999996;
  const Real minus_h_6_x = 0.025374999999999998;
  const Real minus_h_6_y = 0.861795;
  const Real h_5_y = 0.10439999999999999;
  const Real J_8_yy = 2e-04;
  const Real J_9_zz = 4e-05;
  const Real h_5_x = 3.79559;
  const Real link5_to_6_x = 0.4318;
  const Real link5_to_6_z = 0.1501;
  const Real minus_link6_to_7_x = 0.0203;
  const Real minus_link6_to_7_y = 0.4331;
  const Real minus_gravity_z = 9.81;
  const Real J_8_xx = 0.00042216;
  const Real J_7_zz = 0.0014;
  const Real J_6_yy = 0.0067651125;
  const Real minus_J_5_xz = 0.690314699;
  const Real minus_J_5_yz = 0.023750999999999998;
  const Real J_8_zz = 0.00062216;
  const Real J_7_xx = 0.0007499999999999999;
  const Real J_7_yy = 0.00065;
  const Real J_6_yz = 0.004704000000000001;
  const Real minus_J_6_xy = 0.010673638499999999;
  const Real J_6_xx = 0.3056901365;
  const Real minus_J_5_xy = 0.0070992;
  const Real J_6_zz = 0.312455249;
  const Real J_5_zz = 1.7481140020000001;
  const Real mass_2 = 186.45;
  const Real J_3_zz = 7.2;

  // sines and cosines
  const Real angles[6] = {q[2], q[3], q[4], q[5], q[6], q[7]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s3 = sines[0];
  const Real s4 = sines[1];
  const Real s5 = sines[2];
  const Real c5 = cosines[2];
  const Real s6 = sines[3];
  const Real c6 = cosines[3];
  const Real s7 = sines[4];
  const Real s8 = sines[5];
  const Real c7 = cosines[4];
  const Real c8 = cosines[5];

  // links 4 to 6, outward
  const Real w4_z = qd[2] + qd[3];
  const Real t1 = qd[4] * qd[4];
  const Real w6_z = qd[4] + qd[5];
  const Real wd4_z = qdd[2] + qdd[3];
  const Real t2 = w4_z * w4_z;
  const Real wd5_x = w4_z * qd[4];

  // link 6 (link3), outward
  const Real wd6_z = qdd[4] + qdd[5];
  const Real minus_c56 = s5 * s6 - c5 * c6;
  const Real t3 = w6_z * w6_z;
  const Real s56 = s5 * c6 + c5 * s6;
  const Real t4 = link5_to_6_x * c5;
  const Real c34 = c3 * c4 - s3 * s4;
  const Real t5 = link5_to_6_x * s5;
  const Real s34 = s3 * c4 + c3 * s4;
  const Real w6_y = minus_c56 * w4_z;

  // links 5 to 7, outward
  const Real t6 = t2 + t1;
  const Real t7 = minus_c56 * wd4_z;
  const Real t8 = 2.0 * wd5_x;
  const Real minus_w6_x = s56 * w4_z;
  const Real w7_z = qd[6] - w6_y;

  // links 4 (link1) and 6 (link3), outward
  const Real t9 = w6_y * w6_y;
  const Real t10 = minus_w6_x * w6_z;
  const Real t11 = minus_w6_x * w6_y;
  const Real a4_x = c34 * qdd[0] + s34 * qdd[1];
  const Real t12 = minus_w6_x * minus_w6_x;
  const Real a4_y = c34 * qdd[1] - s34 * qdd[0];
  const Real t13 = t9 + t3;
  const Real t14 = h_5_y * s5 - h_5_x * c5;
  const Real t15 = h_5_x * s5 + h_5_y * c5;

  // links 6 (link3) and 7 (link4), outward
  const Real w7_y = s7 * minus_w6_x + c7 * w6_z;
  const Real wd6_y = t7 + t10;
  const Real t16 = t11 + wd6_z;
  const Real w7_x = s7 * w6_z - c7 * minus_w6_x;
  const Real t17 = t12 + t3;
  const Real t18 = wd6_z - t11;
  const Real t19 = 2.0 * (w6_y * w6_z) - s56 * wd4_z;
  const Real t20 = t10 + wd6_y;
  const Real t21 = t6 * t4 + qdd[4] * t5 + link5_to_6_z * wd4_z - a4_x;
  const Real t22 = minus_gravity_z + (t1 * t5 - qdd[4] * t4);
  const Real t23 = w7_x * w7_y;
  const Real wd7_z = qdd[6] - wd6_y;

  // links 6 to 8, outward
  const Real w8_z = w7_y + qd[7];
  const Real t24 = t23 - wd7_z;
  const Real a6_z = a4_y + (wd4_z * t4 - t8 * t5 - link5_to_6_z * t2);
  const Real t25 = 2.0 * w8_z;
  const Real t26 = w7_x * w7_z;
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real w8_x = c8 * w7_x - s8 * w7_z;
  const Real a6_x = minus_c56 * t21 - s56 * t22;

  // links 7 (link4) and 9 (link6), outward
  const Real w9_z = minus_w8_y + qd[8];
  const Real t27 = s7 * t16 + c7 * t19 + 2.0 * (w7_y * w7_z);
  const Real t28 = a6_z + (minus_link6_to_7_x * t20 - minus_link6_to_7_y * t19);
  const Real t29 = a6_x + (minus_link6_to_7_x * t13 + minus_link6_to_7_y * t16);
  const Real wd7_y = c7 * t16 - s7 * t19 - t26;

  // links 6 to 8, outward
  const Real t30 = w8_x * w8_z;
  const Real t31 = w8_x * minus_w8_y;
  const Real a6_y = s56 * t21 + minus_c56 * t22;
  const Real wd8_z = wd7_y + qdd[7];
  const Real t32 = 1.601861202 * s5 + 0.0141984 * c5;
  const Real a7_y = c7 * t28 - s7 * t29;
  const Real a7_x = c7 * t29 + s7 * t28;
  const Real minus_a7_z = a6_y + (minus_link6_to_7_y * t17 - minus_link6_to_7_x * t18);
  const Real t33 = t31 + wd8_z;

  // link 8 (link5), inertial wrench; links 8 (link5) and 9 (link6), outward
  const Real f8_y = minus_h_8_y * (w8_x * w8_x + w8_z * w8_z);
  const Real t34 = s8 * t24 + c8 * t27 - t25 * minus_w8_y;
  const Real wd8_y = c8 * t24 - s8 * t27 - t30;
  const Real f8_x = minus_h_8_y * t33;
  const Real t35 = minus_J_5_xz * s5 + minus_J_5_yz * c5;
  const Real wd9_z = qdd[8] - wd8_y;
  const Real minus_f8_z = minus_h_8_y * t34;
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;

  // link 9 (link6), inertial wrench; link 8 (link5), inward
  const Real n9_z = J_9_zz * wd9_z;
  tau[8] = n9_z;
  const Real n9_x = 2e-05 * (t34 + t25 * w9_z);
  const Real minus_n9_y = 2e-05 * (2.0 * (w8_x * w9_z) - t33);
  const Real minus_f7_x = s8 * f8_y - c8 * f8_x;

  // link 9 (link6), inward
  const Real t36 = c5 * t32 - minus_J_5_xy;
  const Real minus_n8_y = J_8_yy * (t30 - wd8_y) + n9_z;
  const Real n8_x = J_8_xx * t34 - minus_h_8_y * a7_y + n9_x;
  const Real n8_z = 0.00022215999999999997 * t31 + J_8_zz * wd8_z + minus_h_8_y * a8_x - minus_n9_y;
  tau[7] = n8_z;

  // links 7 (link4) and 8 (link5), inward
  const Real minus_f7_z = s8 * f8_x + c8 * f8_y;
  const Real t37 = s7 * minus_f7_x + c7 * minus_f8_z;
  const Real t38 = s7 * minus_f8_z - c7 * minus_f7_x;
  const Real n7_y = n8_z - J_7_yy * (t26 - wd7_y);
  const Real f6_x = minus_h_6_x * t13 + minus_h_6_y * t16 + t38;
  const Real f6_y = minus_h_6_y * t17 - minus_h_6_x * t18 + minus_f7_z;
  const Real n7_x = J_7_xx * t27 + (c8 * n8_x + s8 * minus_n8_y);
  const Real n7_z = J_7_zz * wd7_z - 9.999999999999996e-05 * t23 + (c8 * minus_n8_y - s8 * n8_x);
  tau[6] = n7_z;

  // link 6 (link3), inertial wrench; links 5 to 7, inward
  const Real t39 = J_6_xx * t19 - minus_J_6_xy * t20 - J_6_yz * (t3 - t9) - minus_h_6_y * a6_z;
  const Real t40 = qdd[4] * t35 - h_4_y * a4_x - t8 * t36 - t1 *
      (minus_J_5_yz * s5 - minus_J_5_xz * c5);
  const Real n6_y = J_6_yy * t20 + J_6_yz * t16 - minus_J_6_xy * t19 + minus_h_6_x * a6_z -
      (n7_z + minus_link6_to_7_x * t37);
  const Real t41 = minus_c56 * f6_x + s56 * f6_y;
  const Real f6_z = minus_h_6_x * t20 - minus_h_6_y * t19 - t37;
  const Real f5_x = qdd[4] * t15 - t6 * t14 + t41;
  const Real f5_z = f6_z - (wd4_z * t14 + t8 * t15);
  const Real t42 = 0.298925024 * t11 + J_6_zz * wd6_z + J_6_yz * t7 + minus_J_6_xy * (t9 - t12);
  const Real n6_x = t39 + (c7 * n7_x - s7 * n7_y + minus_link6_to_7_y * t37);
  const Real minus_f4_x = h_4_y * wd4_z + f5_x;
  const Real f4_y = f5_z - h_4_y * t2;

  // links 4 (link1) and 7 (link4), inward; link 5 (link2), inertial wrench
  const Real n6_z = t42 + (minus_h_6_y * a6_x - minus_h_6_x * a6_y) +
      (s7 * n7_x + c7 * n7_y + (minus_link6_to_7_y * t38 - minus_link6_to_7_x * minus_f7_z));
  tau[5] = n6_z;
  const Real minus_f3_x = c34 * minus_f4_x + s34 * f4_y;
  const Real f3_y = c34 * f4_y - s34 * minus_f4_x;
  const Real t43 = J_5_zz * qdd[4] + wd4_z * t35 + t2 * t36 + (minus_gravity_z * t14 - t15 * a4_x);

  // links 3 (base) and 5 (link2), inward
  const Real t44 = t40 - t14 * a4_y + minus_c56 * n6_y - s56 * n6_x + link5_to_6_z * t41;
  const Real f2_x = mass_2 * qdd[0] - minus_f3_x;
  tau[0] = f2_x;
  const Real f2_z = mass_2 * qdd[1] + f3_y;
  tau[1] = f2_z;

  // links 4 to 6, inward
  const Real n5_z = t43 + (n6_z + (t5 * t41 - t4 * (minus_c56 * f6_y - s56 * f6_x)));
  tau[4] = n5_z;
  const Real n4_z = t44 + t4 * f6_z + (3.1467171525 - s5 * t32) * wd4_z;
  tau[3] = n4_z;
  const Real n3_z = J_3_zz * qdd[2] + n4_z;
  tau[2] = n3_z;
}

}  // namespace samm

#undef TREELINE_RESTRICT
