// SPDX-License-Identifier: 0BSD
// bias_acceleration: xdd = J qdd + Jd qd: the term Jd qd
// By outward recursion, Chang eq. 6.11.
// 142 flops (add 52, mul 90, div 0), sine and cosine of 5 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void bias_acceleration(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    Real (&TREELINE_RESTRICT bias)[6]) noexcept {
  // constants
  const Real minus_link3_to_4_x = 0.57155;
  const Real minus_link2_to_3_x = 0.6127;
  const Real link4_to_5_z = 0.17415;
  const Real link5_to_6_z = 0.11985;
  const Real link6_to_tool_z = 0.11655;

  // sines and cosines
  const Real angles[5] = {q[4], q[1], q[2], q[3], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real c5 = cosines[0];
  const Real c2 = cosines[1];
  const Real c3 = cosines[2];
  const Real s2 = sines[1];
  const Real s3 = sines[2];
  const Real c4 = cosines[3];
  const Real s4 = sines[3];
  const Real c1 = cosines[4];
  const Real s5 = sines[0];
  const Real s1 = sines[4];

  // links 1 to 3, outward
  const Real w3_z = qd[1] + qd[2];
  const Real t1 = minus_link2_to_3_x * s2;
  const Real t2 = qd[0] * qd[0];
  const Real t3 = qd[1] * qd[1];
  const Real c23 = c2 * c3 - s2 * s3;

  // links 3 (forearm) and 4 (wrist_1), outward
  const Real s23 = s2 * c3 + c2 * s3;
  const Real t4 = w3_z * w3_z;
  const Real w4_z = w3_z + qd[3];
  const Real a3_y = t3 * t1;
  const Real t5 = minus_link3_to_4_x * s23;
  const Real a3_x = (t2 + t3) * (minus_link2_to_3_x * c2);
  const Real s234 = s23 * c4 + c23 * s4;
  const Real c234 = c23 * c4 - s23 * s4;
  const Real w4_x = s234 * qd[0];
  const Real w4_y = c234 * qd[0];

  // links 4 (wrist_1) and 5 (wrist_2), pose
  const Real t6 = c234 * c1;
  const Real t7 = c234 * s1;
  const Real t8 = s234 * c1;
  const Real t9 = s234 * s1;
  const Real t10 = c5 * s234;
  const Real t11 = s5 * s234;

  // links 4 (wrist_1) and 5 (wrist_2), outward
  const Real t12 = a3_x + (t2 + t4) * (minus_link3_to_4_x * c23);
  const Real t13 = a3_y + t4 * t5;
  const Real wd4_x = w4_y * w4_z;
  const Real w5_z = qd[4] - w4_y;
  const Real minus_wd4_y = w4_x * w4_z;
  const Real w5_x = c5 * w4_x + s5 * w4_z;
  const Real w5_y = c5 * w4_z - s5 * w4_x;
  const Real a4_x = c234 * t12 + s234 * t13;
  const Real a4_y = c234 * t13 - s234 * t12;

  // link 5 (wrist_2), pose; links 5 (wrist_2) and 6 (wrist_3), outward
  const Real t14 = c5 * t6 + s5 * s1;
  const Real t15 = c5 * t7 - s5 * c1;
  const Real t16 = w5_x * w5_x;
  const Real t17 = w5_y * w5_z;
  const Real t18 = link4_to_5_z * t2 + 2.0 * ((qd[1] * t1 + w3_z * t5) * qd[0]);
  const Real w6_z = w5_y + qd[5];
  const Real t19 = c5 * s1 - s5 * t6;
  const Real t20 = s5 * t7 + c5 * c1;

  // link 5 (wrist_2), outward
  const Real minus_wd5_y = s5 * wd4_x + w5_x * qd[4];
  const Real wd5_x = c5 * wd4_x + w5_y * qd[4];
  const Real t21 = w5_x * w5_y - minus_wd4_y;
  const Real t22 = t17 + wd5_x;
  const Real a5_x = c5 * a4_x - s5 * t18;
  const Real minus_a5_y = s5 * a4_x + c5 * t18;

  // link 6 (wrist_3), outward
  const Real wd6_y = w5_x * w6_z - t21;
  const Real minus_a6_y = a4_y + link5_to_6_z * (t16 + w5_y * w5_y);
  const Real wd6_x = w5_z * w6_z - t22;
  const Real minus_a6_x = a5_x + link5_to_6_z * (w5_x * w5_z - minus_wd5_y);
  const Real t23 = link6_to_tool_z * t22 - minus_a6_y;
  const Real a6_z = link5_to_6_z * (t17 - wd5_x) - minus_a5_y;
  const Real t24 = minus_a6_x + link6_to_tool_z * t21;
  const Real t25 = a6_z - link6_to_tool_z * (t16 + w5_z * w5_z);
  bias[3] = t8 * wd6_y - t14 * wd6_x - t19 * minus_wd5_y;
  bias[4] = t9 * wd6_y - t15 * wd6_x + t20 * minus_wd5_y;
  bias[5] = t11 * minus_wd5_y - (t10 * wd6_x + c234 * wd6_y);
  bias[0] = t14 * t24 + t8 * t23 + t19 * t25;
  bias[1] = t15 * t24 + t9 * t23 - t20 * t25;
  bias[2] = t10 * t24 - c234 * t23 - t11 * t25;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
