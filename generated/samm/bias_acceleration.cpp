// SPDX-License-Identifier: 0BSD
// bias_acceleration: xdd = J qdd + Jd qd: the term Jd qd
// By outward recursion, Chang eq. 6.11.
// 177 flops (add 63, mul 114, div 0), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void bias_acceleration(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    Real (&TREELINE_RESTRICT bias)[6]) noexcept {
  // constants
  const Real minus_link6_to_7_x = 0.0203;
  const Real minus_link6_to_7_y = 0.4331;
  const Real link5_to_6_x = 0.4318;
  const Real link5_to_6_z = 0.1501;
  const Real link9_to_tool_z = 0.05625;

  // sines and cosines
  const Real angles[6] = {q[6], q[4], q[5], q[2], q[3], q[7]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real s7 = sines[0];
  const Real s5 = sines[1];
  const Real s6 = sines[2];
  const Real c5 = cosines[1];
  const Real c6 = cosines[2];
  const Real c3 = cosines[3];
  const Real c4 = cosines[4];
  const Real s3 = sines[3];
  const Real s4 = sines[4];
  const Real c7 = cosines[0];
  const Real s8 = sines[5];
  const Real c8 = cosines[5];

  // links 4 to 6, outward
  const Real w4_z = qd[2] + qd[3];
  const Real w6_z = qd[4] + qd[5];
  const Real t1 = qd[4] * qd[4];
  const Real t2 = link5_to_6_x * s5;
  const Real s56 = s5 * c6 + c5 * s6;
  const Real minus_c56 = s5 * s6 - c5 * c6;
  const Real t3 = w4_z * w4_z;
  const Real t4 = w6_z * w6_z;
  const Real wd6_x = w4_z * w6_z;
  const Real wd5_x = w4_z * qd[4];

  // links 6 (link3) and 7 (link4), outward
  const Real a6_y = t1 * t2;
  const Real c34 = c3 * c4 - s3 * s4;
  const Real t5 = s56 * w4_z;
  const Real t6 = minus_c56 * wd6_x;
  const Real minus_wd7_z = s56 * wd6_x;

  // link 7 (link4), pose; link 6 (link3), outward
  const Real s34 = s3 * c4 + c3 * s4;
  const Real t7 = minus_c56 * c34;
  const Real t8 = s56 * c34;
  const Real a6_x = (t3 + t1) * (link5_to_6_x * c5);
  const Real t9 = minus_link6_to_7_x * s56 - minus_link6_to_7_y * minus_c56;

  // link 7 (link4), outward and pose
  const Real w7_z = qd[6] - minus_c56 * w4_z;
  const Real t10 = c7 * s56;
  const Real t11 = minus_c56 * s34;
  const Real t12 = s56 * s34;
  const Real w7_y = s7 * t5 + c7 * w6_z;
  const Real w7_x = s7 * w6_z - c7 * t5;
  const Real t13 = a6_x + (t3 + t4) * (minus_link6_to_7_x * minus_c56 + minus_link6_to_7_y * s56);
  const Real t14 = a6_y - t4 * t9;

  // links 7 (link4) and 8 (link5), outward; link 7 (link4), pose
  const Real w8_z = w7_y + qd[7];
  const Real t15 = c7 * t7 + s7 * s34;
  const Real t16 = s7 * c34 - c7 * t11;
  const Real wd7_x = c7 * t6 + w7_y * qd[6];
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real w8_x = c8 * w7_x - s8 * w7_z;
  const Real minus_wd7_y = s7 * t6 + w7_x * qd[6];

  // links 7 (link4) and 9 (link6), outward; link 7 (link4), pose
  const Real w9_z = minus_w8_y + qd[8];
  const Real t17 = minus_c56 * t13 - s56 * t14;
  const Real t18 = 2.0 * (wd6_x * t9 - wd5_x * t2) - link5_to_6_z * t3;
  const Real minus_a7_z = s56 * t13 + minus_c56 * t14;
  const Real t19 = s7 * s56;
  const Real minus_wd9_y = minus_wd7_y + w8_x * qd[8];

  // links 7 (link4) and 8 (link5), pose; link 8 (link5), outward
  const Real t20 = c8 * t15 + s8 * t8;
  const Real t21 = s7 * t7 - c7 * s34;
  const Real wd8_x = c8 * wd7_x + s8 * minus_wd7_z - minus_w8_y * qd[7];
  const Real t22 = c8 * t16 - s8 * t12;
  const Real t23 = s7 * t11 + c7 * c34;

  // link 8 (link5), pose; link 7 (link4), outward
  const Real t24 = s8 * minus_c56 - c8 * t10;
  const Real a7_x = c7 * t17 + s7 * t18;
  const Real t25 = s8 * t15 - c8 * t8;
  const Real a7_y = c7 * t18 - s7 * t17;
  const Real t26 = s8 * t16 + c8 * t12;
  const Real t27 = s8 * t10 + c8 * minus_c56;

  // links 8 (link5) and 9 (link6), outward
  const Real wd9_x = wd8_x + w8_z * qd[8];
  const Real wd8_y = c8 * minus_wd7_z - s8 * wd7_x - w8_x * qd[7];
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;
  const Real a8_y = c8 * minus_a7_z - s8 * a7_x;
  const Real t28 = a8_x + link9_to_tool_z * (w8_x * w9_z - minus_wd9_y);

  // link 9 (link6), outward
  const Real t29 = a8_y + link9_to_tool_z * (w8_x * w8_x + w8_z * w8_z);
  const Real t30 = a7_y + link9_to_tool_z * (w8_z * w9_z - wd9_x);
  bias[3] = t25 * wd8_y - (t20 * wd9_x + t21 * minus_wd9_y);
  bias[4] = t22 * wd9_x - t23 * minus_wd9_y - t26 * wd8_y;
  bias[5] = t24 * wd9_x - t19 * minus_wd9_y + t27 * wd8_y;
  bias[0] = t21 * t30 - t20 * t28 + t25 * t29;
  bias[1] = t22 * t28 + t23 * t30 - t26 * t29;
  bias[2] = t24 * t28 + t19 * t30 + t27 * t29;
}

}  // namespace samm

#undef TREELINE_RESTRICT
