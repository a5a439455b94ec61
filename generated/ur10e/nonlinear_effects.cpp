// SPDX-License-Identifier: 0BSD
// nonlinear_effects: h = b + g: the joint forces at qdd = 0
// By recursive Newton-Euler, Chang table 4.1.
// 200 flops (add 76, mul 124, div 0), sine and cosine of 4 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void nonlinear_effects(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    Real (&TREELINE_RESTRICT h)[6]) noexcept {
  // constants
  const Real minus_link2_to_3_x = 0.6127;
  const Real minus_link3_to_4_x = 0.57155;
  const Real minus_gravity_z = 9.81;
  const Real link4_to_5_z = 0.17415;
  const Real J_2_xz = 1.156008191975;
  const Real h_5_y = 0.09132825;
  const Real J_3_xz = 0.5656542411875001;
  const Real minus_J_5_yz = 0.0106962107625;
  const Real J_5_zz = 0.008210591037500001;
  const Real J_5_xx = 0.0069705910375000004;
  const Real minus_h_3_x = 4.0059802;
  const Real minus_h_4_y = 0.33495075;
  const Real J_5_yy = 0.00124;
  const Real J_6_zz = 0.000623;
  const Real J_4_yz = 0.0585962731125;

  // sines and cosines
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real c2 = cosines[0];
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];

  // links 1 to 3, outward
  const Real w3_z = qd[1] + qd[2];
  const Real t1 = qd[0] * qd[0];
  const Real t2 = qd[1] * qd[1];
  const Real t3 = minus_link2_to_3_x * s2;
  const Real t4 = minus_link2_to_3_x * c2;
  const Real t5 = 2.0 * qd[0];
  const Real s23 = s2 * c3 + c2 * s3;

  // links 2 to 4, outward
  const Real c23 = c2 * c3 - s2 * s3;
  const Real w4_z = w3_z + qd[3];
  const Real t6 = w3_z * w3_z;
  const Real t7 = t5 * w3_z;
  const Real t8 = t5 * qd[1];

  // links 3 (forearm) and 4 (wrist_1), outward
  const Real t9 = c2 * (4.36318718615 * s2);
  const Real t10 = minus_link3_to_4_x * c23;
  const Real t11 = minus_link3_to_4_x * s23;
  const Real t12 = t1 + t6;
  const Real wd4_x = qd[0] * w4_z;
  const Real a3_x = (t1 + t2) * t4;
  const Real a3_y = minus_gravity_z + t2 * t3;
  const Real minus_a3_z = t8 * t3;
  const Real s234 = s23 * c4 + c23 * s4;
  const Real c234 = c23 * c4 - s23 * s4;
  const Real t13 = w4_z * w4_z;
  const Real t14 = minus_h_3_x * c23;
  const Real t15 = 2.0 * wd4_x;

  // link 5 (wrist_2), outward
  const Real t16 = minus_h_3_x * s23;
  const Real t17 = s234 * qd[0];
  const Real wd5_z = s234 * wd4_x;
  const Real t18 = c234 * wd4_x;
  const Real t19 = c23 * (2.07831527531 * s23);

  // link 4 (wrist_1), outward
  const Real a4_x = a3_x + t12 * t10;
  const Real a4_y = a3_y + t6 * t11;
  const Real minus_a4_z = minus_a3_z + t7 * t11;
  const Real t20 = minus_h_4_y * s234;
  const Real t21 = minus_h_4_y * c234;

  // link 5 (wrist_2), outward; link 3 (forearm), inward
  const Real w5_z = qd[4] - c234 * qd[0];
  const Real t22 = w5_z * w5_z;
  const Real t23 = c234 * (0.037099816387500005 * s234);
  const Real w5_x = c5 * t17 + s5 * w4_z;
  const Real w5_y = c5 * w4_z - s5 * t17;
  const Real minus_a5_z = c234 * a4_y - s234 * a4_x;
  const Real t24 = J_2_xz * t2 * c2 - t8 * t9 + J_3_xz * t6 * c23 - t7 * t19;
  const Real t25 = w5_x * w5_y;

  // links 5 (wrist_2) and 6 (wrist_3), outward
  const Real w6_z = w5_y + qd[5];
  const Real t26 = w5_x * w5_z;
  const Real t27 = 2.0 * w6_z;
  const Real t28 = t25 - wd5_z;
  const Real minus_wd5_y = s5 * t18 + w5_x * qd[4];
  const Real t29 = c5 * t18 + (w5_z + qd[4]) * w5_y;
  const Real a5_x = c5 * (c234 * a4_x + s234 * a4_y) - s5 * (minus_a4_z + link4_to_5_z * t1);

  // links 5 (wrist_2) and 6 (wrist_3), inertial wrench; link 5 (wrist_2), inward
  const Real minus_f5_y = h_5_y * (w5_x * w5_x + t22);
  const Real f5_x = h_5_y * t28;
  const Real f5_z = h_5_y * t29;
  const Real minus_n6_z = J_6_zz * minus_wd5_y;
  h[5] = -minus_n6_z;
  const Real n6_x = 0.0003115 * (t27 * w5_z - t29);
  const Real t30 = c5 * f5_x + s5 * minus_f5_y;
  const Real n6_y = 0.0003115 * (t27 * w5_x - t28);
  const Real t31 = J_5_zz * wd5_z - 0.005730591037500001 * t25 - minus_J_5_yz *
      (t26 - minus_wd5_y) - h_5_y * a5_x;

  // links 5 (wrist_2) and 6 (wrist_3), inward
  const Real n5_x = J_5_xx * t29 + minus_J_5_yz * (t22 - w5_y * w5_y) - h_5_y * minus_a5_z - n6_x;
  const Real n5_y = minus_J_5_yz * t28 - J_5_yy * (t26 + minus_wd5_y) - minus_n6_z;
  const Real f4_z = s5 * f5_x - c5 * minus_f5_y - t15 * t21;
  const Real n5_z = t31 + n6_y;
  h[4] = n5_z;
  const Real t32 = c234 * t30 + s234 * f5_z;

  // links 3 to 5, inward
  const Real f3_z = f4_z - t7 * t16;
  const Real f4_x = t32 - (t1 + t13) * t20;
  const Real f4_y = t13 * t21 + (s234 * t30 - c234 * f5_z);
  const Real t33 = t24 - t14 * minus_a3_z + t15 * t23 + t20 * minus_a4_z - c234 * n5_z;
  const Real f3_x = t12 * t14 + f4_x;
  const Real f3_y = t6 * t16 + f4_y;
  const Real n4_z = t20 * a4_y + t21 * a4_x - t1 * t23 + (s5 * n5_x + c5 * n5_y);
  h[3] = n4_z;
  const Real n3_z = t1 * t19 + (t16 * a3_x - t14 * a3_y) + (n4_z + (t11 * f4_x - t10 * f4_y));
  h[2] = n3_z;
  const Real n2_y = t33 + link4_to_5_z * t32 + t10 * f4_z + t4 * f3_z +
      (c5 * n5_x - s5 * n5_y - J_4_yz * t13) * s234;
  h[0] = n2_y;
  const Real n2_z = t1 * t9 - 81.988590645 * c2 + (n3_z + (t3 * f3_x - t4 * f3_y));
  h[1] = n2_z;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
