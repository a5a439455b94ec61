// SPDX-License-Identifier: 0BSD
// nonlinear_effects: h = b + g: the joint forces at qdd = 0
// By recursive Newton-Euler, Chang table 4.1.
// 246 flops (add 96, mul 150, div 0), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void nonlinear_effects(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    Real (&TREELINE_RESTRICT h)[9]) noexcept {
  // constants
  const Real minus_link6_to_7_x = 0.0203;
  const Real minus_link6_to_7_y = 0.4331;
  const Real link5_to_6_x = 0.4318;
  const Real minus_gravity_z = 9.81;
  const Real link5_to_6_z = 0.1501;
  const Real minus_h_8_y = 0.0028799999999999997;
  const Real J_8_xx = 0.00042216;
  const Real minus_h_6_x = 0.025374999999999998;
  const Real minus_h_6_y = 0.861795;
  const Real h_5_y = 0.10439999999999999;
  const Real h_5_x = 3.79559;
  const Real h_4_y = 4.9338049999999996;
  const Real J_9_zz = 4e-05;
  const Real J_8_yy = 2e-04;
  const Real J_7_zz = 0.0014;
  const Real minus_J_6_xy = 0.010673638499999999;
  const Real J_8_zz = 0.00062216;
  const Real J_7_xx = 0.0007499999999999999;
  const Real J_7_yy = 0.00065;
  const Real minus_J_5_yz = 0.023750999999999998;
  const Real minus_J_5_xz = 0.690314699;
  const Real minus_J_5_xy = 0.0070992;
  const Real J_6_yz = 0.004704000000000001;

  // sines and cosines
  const Real angles[6] = {q[2], q[3], q[4], q[5], q[6], q[7]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s5 = sines[2];
  const Real s6 = sines[3];
  const Real c5 = cosines[2];
  const Real c6 = cosines[3];
  const Real s7 = sines[4];
  const Real s8 = sines[5];
  const Real c7 = cosines[4];
  const Real c8 = cosines[5];
  const Real s4 = sines[1];
  const Real s3 = sines[0];

  // links 4 to 6, outward
  const Real w4_z = qd[2] + qd[3];
  const Real w6_z = qd[4] + qd[5];
  const Real t1 = qd[4] * qd[4];
  const Real t2 = link5_to_6_x * s5;
  const Real t3 = link5_to_6_x * c5;
  const Real s56 = s5 * c6 + c5 * s6;
  const Real minus_c56 = s5 * s6 - c5 * c6;
  const Real t4 = w4_z * w4_z;
  const Real t5 = w6_z * w6_z;
  const Real wd6_x = w4_z * w6_z;
  const Real wd5_x = w4_z * qd[4];

  // links 5 to 7, outward
  const Real t6 = s56 * w4_z;
  const Real t7 = t4 + t5;
  const Real t8 = t4 + t1;
  const Real t9 = minus_c56 * wd6_x;
  const Real t10 = 2.0 * wd5_x;

  // links 6 (link3) and 7 (link4), outward
  const Real t11 = 2.0 * wd6_x;
  const Real minus_wd7_z = s56 * wd6_x;
  const Real a6_y = minus_gravity_z + t1 * t2;
  const Real t12 = minus_link6_to_7_x * s56 - minus_link6_to_7_y * minus_c56;
  const Real a6_x = t8 * t3;
  const Real t13 = minus_link6_to_7_x * minus_c56 + minus_link6_to_7_y * s56;
  const Real w7_z = qd[6] - minus_c56 * w4_z;
  const Real w7_x = s7 * w6_z - c7 * t6;
  const Real w7_y = s7 * t6 + c7 * w6_z;
  const Real t14 = minus_h_6_x * minus_c56 + minus_h_6_y * s56;
  const Real minus_a6_z = t10 * t2 + link5_to_6_z * t4;
  const Real t15 = w7_x * w7_y;
  const Real t16 = a6_y - t5 * t12;
  const Real t17 = a6_x + t7 * t13;

  // links 7 (link4) and 8 (link5), outward
  const Real w8_z = w7_y + qd[7];
  const Real t18 = t11 * t12 - minus_a6_z;
  const Real t19 = minus_h_6_x * s56 - minus_h_6_y * minus_c56;
  const Real t20 = minus_c56 * (0.298925024 * s56 + 0.021347276999999998 * minus_c56) -
      minus_J_6_xy;
  const Real t21 = h_5_y * s5 - h_5_x * c5;
  const Real t22 = t15 + minus_wd7_z;
  const Real t23 = c7 * t9 + (w7_z + qd[6]) * w7_y;
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real w8_x = c8 * w7_x - s8 * w7_z;
  const Real t24 = 2.0 * w8_z;
  const Real minus_wd7_y = s7 * t9 + w7_x * qd[6];
  const Real t25 = minus_c56 * t17 - s56 * t16;
  const Real t26 = w8_x * minus_w8_y;

  // links 7 to 9, outward
  const Real w9_z = minus_w8_y + qd[8];
  const Real t27 = w8_x * w8_z;
  const Real minus_a7_z = s56 * t17 + minus_c56 * t16;
  const Real t28 = minus_wd7_y - t26;
  const Real t29 = s8 * t22 + c8 * t23 - t24 * minus_w8_y;
  const Real wd8_y = c8 * t22 - s8 * t23 - t27;
  const Real a7_y = c7 * t18 - s7 * t25;

  // links 8 (link5) and 9 (link6), inertial wrench; link 7 (link4), outward
  const Real minus_f8_x = minus_h_8_y * t28;
  const Real f8_y = minus_h_8_y * (w8_x * w8_x + w8_z * w8_z);
  const Real a7_x = c7 * t25 + s7 * t18;
  const Real minus_n9_z = J_9_zz * wd8_y;
  h[8] = -minus_n9_z;
  const Real minus_f8_z = minus_h_8_y * t29;
  const Real n9_x = 2e-05 * (t29 + t24 * w9_z);

  // links 8 (link5) and 9 (link6), inward; link 8 (link5), outward; link 9 (link6), inertial
  //   wrench
  const Real minus_f7_x = c8 * minus_f8_x + s8 * f8_y;
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;
  const Real minus_n9_y = 2e-05 * (t28 + 2.0 * (w8_x * w9_z));
  const Real n8_y = minus_n9_z - J_8_yy * (t27 - wd8_y);
  const Real f7_z = s8 * minus_f8_x - c8 * f8_y;

  // links 7 (link4) and 9 (link6), inward
  const Real n8_x = J_8_xx * t29 - minus_h_8_y * a7_y + n9_x;
  const Real t30 = c5 * (1.601861202 * s5 + 0.0141984 * c5) - minus_J_5_xy;
  const Real t31 = s7 * minus_f8_z - c7 * minus_f7_x;
  const Real t32 = s7 * minus_f7_x + c7 * minus_f8_z;
  const Real n8_z = 0.00022215999999999997 * t26 - J_8_zz * minus_wd7_y + minus_h_8_y * a8_x -
      minus_n9_y;
  h[7] = n8_z;
  const Real f6_z = t11 * t19 - t32;

  // links 6 (link3) and 8 (link5), inward
  const Real minus_n7_z = 9.999999999999996e-05 * t15 + J_7_zz * minus_wd7_z +
      (s8 * n8_x + c8 * n8_y);
  h[6] = -minus_n7_z;
  const Real n7_x = J_7_xx * t23 - (s8 * n8_y - c8 * n8_x);
  const Real n7_y = n8_z - J_7_yy * (w7_x * w7_z + minus_wd7_y);
  const Real f5_z = f6_z - t10 * (h_5_x * s5 + h_5_y * c5);

  // links 5 (link2) and 7 (link4), inward
  const Real t33 = minus_c56 * t31 - s56 * f7_z;
  const Real t34 = s56 * t31 + minus_c56 * f7_z;
  const Real f4_y = f5_z - h_4_y * t4;
  const Real f6_x = t7 * t14 + t33;
  const Real minus_f6_y = t5 * t19 + t34;

  // links 4, 6 and 7, inward
  const Real f5_x = f6_x - t8 * t21;
  const Real t35 = minus_c56 * minus_n7_z - (t11 * t20 + t14 * minus_a6_z) - t13 * t32 +
      link5_to_6_z * f6_x;
  const Real minus_f3_x = c4 * f5_x + s4 * f4_y;
  const Real f3_y = c4 * f4_y - s4 * f5_x;
  const Real n6_z = t4 * t20 - (t14 * a6_y + t19 * a6_x) +
      (s7 * n7_x + c7 * n7_y + (t13 * t34 - t12 * t33));
  h[5] = n6_z;

  // links 3 (base) and 6 (link3), inward
  const Real t36 = t35 + t3 * f6_z - t10 * t30 - t1 * (minus_J_5_yz * s5 - minus_J_5_xz * c5);
  const Real minus_f2_x = c3 * minus_f3_x + s3 * f3_y;
  h[0] = -minus_f2_x;
  const Real f2_z = c3 * f3_y - s3 * minus_f3_x;
  h[1] = f2_z;
  const Real n5_z = t4 * t30 + minus_gravity_z * t21 + (n6_z + (t3 * minus_f6_y + t2 * f6_x));
  h[4] = n5_z;
  const Real n5_y = t36 + (J_6_yz * t5 - (c7 * n7_x - s7 * n7_y)) * s56;
  h[2] = n5_y;
  h[3] = n5_y;
}

}  // namespace samm

#undef TREELINE_RESTRICT
