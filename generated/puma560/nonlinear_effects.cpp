// SPDX-License-Identifier: 0BSD
// nonlinear_effects: h = b + g: the joint forces at qdd = 0
// By recursive Newton-Euler, Chang table 4.1.
// 224 flops (add 87, mul 137, div 0), sine and cosine of 4 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void nonlinear_effects(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    Real (&TREELINE_RESTRICT h)[6]) noexcept {
  // constants
  const Real minus_link3_to_4_x = 0.0203;
  const Real minus_link3_to_4_y = 0.4331;
  const Real link2_to_3_x = 0.4318;
  const Real minus_gravity_z = 9.81;
  const Real link2_to_3_z = 0.1501;
  const Real minus_h_5_y = 0.0028799999999999997;
  const Real J_5_xx = 0.00042216;
  const Real J_6_zz = 4e-05;
  const Real J_5_yy = 2e-04;
  const Real J_4_zz = 0.0014;
  const Real minus_h_3_x = 0.025374999999999998;
  const Real minus_h_3_y = 0.861795;
  const Real minus_J_3_xy = 0.010673638499999999;
  const Real J_4_xx = 0.0007499999999999999;
  const Real J_5_zz = 0.00062216;
  const Real minus_J_2_yz = 0.023750999999999998;
  const Real J_4_yy = 0.00065;
  const Real minus_J_2_xz = 0.690314699;
  const Real h_2_y = 0.10439999999999999;
  const Real h_2_x = 3.79559;
  const Real minus_J_2_xy = 0.0070992;
  const Real J_3_yz = 0.004704000000000001;

  // sines and cosines
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real s4 = sines[2];
  const Real c4 = cosines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];

  // links 1 to 3, outward
  const Real w3_z = qd[1] + qd[2];
  const Real t1 = qd[0] * qd[0];
  const Real t2 = qd[1] * qd[1];
  const Real t3 = link2_to_3_x * s2;
  const Real t4 = link2_to_3_x * c2;
  const Real wd2_x = qd[0] * qd[1];
  const Real s23 = s2 * c3 + c2 * s3;
  const Real minus_c23 = s2 * s3 - c2 * c3;
  const Real t5 = w3_z * w3_z;
  const Real wd3_x = qd[0] * w3_z;
  const Real t6 = 2.0 * wd2_x;

  // links 3 (link3) and 4 (link4), outward
  const Real t7 = s23 * qd[0];
  const Real t8 = t1 + t5;
  const Real t9 = minus_c23 * wd3_x;
  const Real a3_x = (t1 + t2) * t4;
  const Real a3_y = minus_gravity_z + t2 * t3;
  const Real t10 = 2.0 * wd3_x;
  const Real minus_wd4_z = s23 * wd3_x;
  const Real t11 = minus_link3_to_4_x * minus_c23 + minus_link3_to_4_y * s23;
  const Real t12 = minus_link3_to_4_x * s23 - minus_link3_to_4_y * minus_c23;
  const Real w4_z = qd[3] - minus_c23 * qd[0];
  const Real minus_a3_z = t6 * t3 + link2_to_3_z * t1;
  const Real w4_x = s4 * w3_z - c4 * t7;
  const Real w4_y = s4 * t7 + c4 * w3_z;
  const Real t13 = minus_h_3_x * minus_c23 + minus_h_3_y * s23;
  const Real t14 = minus_h_3_x * s23 - minus_h_3_y * minus_c23;
  const Real t15 = w4_x * w4_y;
  const Real t16 = a3_x + t8 * t11;
  const Real t17 = a3_y - t5 * t12;

  // links 4 (link4) and 5 (link5), outward
  const Real w5_z = w4_y + qd[4];
  const Real t18 = t10 * t12 - minus_a3_z;
  const Real t19 = minus_c23 * (0.298925024 * s23 + 0.021347276999999998 * minus_c23) -
      minus_J_3_xy;
  const Real t20 = t15 + minus_wd4_z;
  const Real t21 = c4 * t9 + (w4_z + qd[3]) * w4_y;
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;
  const Real w5_x = c5 * w4_x - s5 * w4_z;
  const Real t22 = 2.0 * w5_z;
  const Real minus_wd4_y = s4 * t9 + w4_x * qd[3];
  const Real t23 = minus_c23 * t16 - s23 * t17;
  const Real t24 = w5_x * minus_w5_y;

  // links 4 to 6, outward
  const Real w6_z = minus_w5_y + qd[5];
  const Real t25 = w5_x * w5_z;
  const Real minus_a4_z = s23 * t16 + minus_c23 * t17;
  const Real t26 = minus_wd4_y - t24;
  const Real t27 = s5 * t20 + c5 * t21 - t22 * minus_w5_y;
  const Real wd5_y = c5 * t20 - s5 * t21 - t25;
  const Real a4_y = c4 * t18 - s4 * t23;

  // links 5 (link5) and 6 (link6), inertial wrench; link 4 (link4), outward
  const Real minus_f5_x = minus_h_5_y * t26;
  const Real f5_y = minus_h_5_y * (w5_x * w5_x + w5_z * w5_z);
  const Real a4_x = c4 * t23 + s4 * t18;
  const Real minus_n6_z = J_6_zz * wd5_y;
  h[5] = -minus_n6_z;
  const Real minus_f5_z = minus_h_5_y * t27;

  // link 6 (link6), inertial wrench; link 5 (link5), inward and outward
  const Real t28 = c2 * (1.601861202 * s2 + 0.0141984 * c2) - minus_J_2_xy;
  const Real n6_x = 2e-05 * (t27 + t22 * w6_z);
  const Real minus_f4_x = c5 * minus_f5_x + s5 * f5_y;
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;
  const Real minus_n6_y = 2e-05 * (t26 + 2.0 * (w5_x * w6_z));

  // links 4 to 6, inward
  const Real n5_y = minus_n6_z - J_5_yy * (t25 - wd5_y);
  const Real f4_z = s5 * minus_f5_x - c5 * f5_y;
  const Real n5_x = J_5_xx * t27 - minus_h_5_y * a4_y + n6_x;
  const Real t29 = s4 * minus_f5_z - c4 * minus_f4_x;
  const Real t30 = s4 * minus_f4_x + c4 * minus_f5_z;
  const Real n5_z = 0.00022215999999999997 * t24 - J_5_zz * minus_wd4_y + minus_h_5_y * a5_x -
      minus_n6_y;
  h[4] = n5_z;
  const Real f3_z = t10 * t14 - t30;
  const Real minus_n4_z = 9.999999999999996e-05 * t15 + J_4_zz * minus_wd4_z +
      (s5 * n5_x + c5 * n5_y);
  h[3] = -minus_n4_z;
  const Real n4_x = J_4_xx * t21 - (s5 * n5_y - c5 * n5_x);
  const Real n4_y = n5_z - J_4_yy * (w4_x * w4_z + minus_wd4_y);

  // links 3 (link3) and 4 (link4), inward
  const Real t31 = minus_c23 * t29 - s23 * f4_z;
  const Real t32 = s23 * t29 + minus_c23 * f4_z;
  const Real f3_x = t8 * t13 + t31;
  const Real minus_f3_y = t5 * t14 + t32;
  const Real t33 = minus_c23 * minus_n4_z - (t10 * t19 + t13 * minus_a3_z) - t11 * t30 +
      link2_to_3_z * f3_x;
  const Real n3_z = t1 * t19 - (t13 * a3_y + t14 * a3_x) +
      (s4 * n4_x + c4 * n4_y + (t11 * t32 - t12 * t31));
  h[2] = n3_z;
  const Real n2_z = t1 * t28 + minus_gravity_z * (h_2_y * s2 - h_2_x * c2) +
      (n3_z + (t4 * minus_f3_y + t3 * f3_x));
  h[1] = n2_z;
  const Real t34 = t33 + t4 * f3_z - t6 * t28 - t2 * (minus_J_2_yz * s2 - minus_J_2_xz * c2);
  const Real n2_y = t34 + (J_3_yz * t5 - (c4 * n4_x - s4 * n4_y)) * s23;
  h[0] = n2_y;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
