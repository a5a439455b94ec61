// SPDX-License-Identifier: 0BSD
// bias_acceleration: xdd = J qdd + Jd qd: the term Jd qd
// By outward recursion, Chang eq. 6.11.
// 170 flops (add 60, mul 110, div 0), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void bias_acceleration(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    Real (&TREELINE_RESTRICT bias)[6]) noexcept {
  // constants
  const Real minus_link3_to_4_x = 0.0203;
  const Real minus_link3_to_4_y = 0.4331;
  const Real link2_to_3_x = 0.4318;
  const Real link2_to_3_z = 0.1501;
  const Real link6_to_tool_z = 0.05625;

  // sines and cosines
  const Real angles[5] = {q[3], q[1], q[2], q[0], q[4]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s4 = sines[0];
  const Real s2 = sines[1];
  const Real s3 = sines[2];
  const Real c2 = cosines[1];
  const Real c3 = cosines[2];
  const Real c1 = cosines[3];
  const Real c4 = cosines[0];
  const Real s1 = sines[3];
  const Real s5 = sines[4];
  const Real c5 = cosines[4];

  // links 1 to 3, outward
  const Real w3_z = qd[1] + qd[2];
  const Real t1 = qd[0] * qd[0];
  const Real t2 = qd[1] * qd[1];
  const Real t3 = link2_to_3_x * s2;
  const Real wd2_x = qd[0] * qd[1];

  // links 3 (link3) and 4 (link4), outward
  const Real s23 = s2 * c3 + c2 * s3;
  const Real minus_c23 = s2 * s3 - c2 * c3;
  const Real t4 = w3_z * w3_z;
  const Real wd3_x = qd[0] * w3_z;
  const Real a3_y = t2 * t3;
  const Real t5 = s23 * qd[0];
  const Real t6 = minus_c23 * wd3_x;
  const Real a3_x = (t1 + t2) * (link2_to_3_x * c2);
  const Real minus_wd4_z = s23 * wd3_x;

  // link 4 (link4), pose and outward
  const Real t7 = minus_c23 * c1;
  const Real t8 = minus_c23 * s1;
  const Real t9 = s23 * c1;
  const Real t10 = s23 * s1;
  const Real t11 = c4 * s23;
  const Real t12 = s4 * s23;
  const Real t13 = minus_link3_to_4_x * s23 - minus_link3_to_4_y * minus_c23;
  const Real w4_z = qd[3] - minus_c23 * qd[0];
  const Real w4_y = s4 * t5 + c4 * w3_z;
  const Real w4_x = s4 * w3_z - c4 * t5;
  const Real t14 = c4 * t7 + s4 * s1;
  const Real t15 = s4 * c1 - c4 * t8;
  const Real t16 = a3_x + (t1 + t4) * (minus_link3_to_4_x * minus_c23 + minus_link3_to_4_y * s23);
  const Real t17 = a3_y - t4 * t13;

  // links 4 (link4) and 5 (link5), outward
  const Real w5_z = w4_y + qd[4];
  const Real wd4_x = c4 * t6 + w4_y * qd[3];
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;
  const Real w5_x = c5 * w4_x - s5 * w4_z;
  const Real minus_wd4_y = s4 * t6 + w4_x * qd[3];

  // links 4 (link4) and 5 (link5), pose; links 4 (link4) and 6 (link6), outward
  const Real t18 = c5 * t14 + s5 * t9;
  const Real t19 = s4 * t7 - c4 * s1;
  const Real t20 = c5 * t15 - s5 * t10;
  const Real w6_z = minus_w5_y + qd[5];
  const Real t21 = minus_c23 * t16 - s23 * t17;
  const Real t22 = 2.0 * (wd3_x * t13 - wd2_x * t3) - link2_to_3_z * t1;
  const Real minus_a4_z = s23 * t16 + minus_c23 * t17;
  const Real t23 = s4 * t8 + c4 * c1;

  // link 5 (link5), pose; link 6 (link6), outward
  const Real t24 = s5 * minus_c23 - c5 * t11;
  const Real t25 = s5 * t14 - c5 * t9;
  const Real t26 = s5 * t15 + c5 * t10;
  const Real minus_wd6_y = minus_wd4_y + w5_x * qd[5];
  const Real t27 = s5 * t11 + c5 * minus_c23;

  // links 4 to 6, outward
  const Real wd5_x = c5 * wd4_x + s5 * minus_wd4_z - minus_w5_y * qd[4];
  const Real a4_x = c4 * t21 + s4 * t22;
  const Real a4_y = c4 * t22 - s4 * t21;
  const Real wd5_y = c5 * minus_wd4_z - s5 * wd4_x - w5_x * qd[4];
  const Real wd6_x = wd5_x + w5_z * qd[5];
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;
  const Real a5_y = c5 * minus_a4_z - s5 * a4_x;

  // link 6 (link6), outward
  const Real t28 = a5_x + link6_to_tool_z * (w5_x * w6_z - minus_wd6_y);
  const Real t29 = a5_y + link6_to_tool_z * (w5_x * w5_x + w5_z * w5_z);
  const Real t30 = a4_y + link6_to_tool_z * (w5_z * w6_z - wd6_x);
  bias[3] = t25 * wd5_y - (t18 * wd6_x + t19 * minus_wd6_y);
  bias[4] = t20 * wd6_x - t23 * minus_wd6_y - t26 * wd5_y;
  bias[5] = t24 * wd6_x - t12 * minus_wd6_y + t27 * wd5_y;
  bias[0] = t19 * t30 - t18 * t28 + t25 * t29;
  bias[1] = t20 * t28 + t23 * t30 - t26 * t29;
  bias[2] = t24 * t28 + t12 * t30 + t27 * t29;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
