// bias_acceleration: xdd = J qdd + Jd qd: the term Jd qd
// By outward recursion, Chang eq. 6.11.
// 247 flops (add 90, mul 157, div 0), sine and cosine of 7 angles
// Generated; see samm.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
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
  const Real angles[7] = {q[8], q[7], q[6], q[5], q[4], q[3], q[2]};
  Real sines[7];
  Real cosines[7];
  detail::sin_cos(angles, sines, cosines);
  const Real c9 = cosines[0];
  const Real c8 = cosines[1];
  const Real c7 = cosines[2];
  const Real c6 = cosines[3];
  const Real c5 = cosines[4];
  const Real c4 = cosines[5];
  const Real c3 = cosines[6];
  const Real s4 = sines[5];
  const Real s3 = sines[6];
  const Real s6 = sines[3];
  const Real s5 = sines[4];
  const Real s7 = sines[2];
  const Real s8 = sines[1];
  const Real s9 = sines[0];

  // link 4 (link1), outward
  const Real w4_z = qd[2] + qd[3];

  // link 6 (link3), outward
  const Real w6_z = qd[4] + qd[5];

  // link 5 (link2), outward
  const Real minus_w5_x = s5 * w4_z;
  const Real minus_w5_y = c5 * w4_z;

  // link 6 (link3), outward
  const Real a7_x_p1 = w6_z * w6_z;

  // link 4 (link1), pose
  const Real bias_3_p1 = c4 * c3 - s4 * s3;
  const Real bias_3_p2 = s4 * c3 + c4 * s3;

  // link 5 (link2), outward
  const Real minus_wd5_x = minus_w5_y * qd[4];
  const Real wd5_y = minus_w5_x * qd[4];
  const Real a6_x_p1 = minus_w5_y * minus_w5_y;

  // link 5 (link2), pose
  const Real bias_3_p3 = c5 * bias_3_p1;
  const Real bias_3_p4 = s5 * bias_3_p1;

  // link 6 (link3), outward
  const Real w6_y = s6 * minus_w5_x - c6 * minus_w5_y;
  const Real minus_w6_x = c6 * minus_w5_x + s6 * minus_w5_y;
  const Real a6_x_p2 = 0.4318 * (minus_w5_x * minus_w5_y);
  const Real a7_x_p2 = minus_w6_x * w6_y;
  const Real a6_x_p3 = 0.4318 * (a6_x_p1 + qd[4] * qd[4]);

  // link 7 (link4), outward
  const Real w7_z = qd[6] - w6_y;

  // link 5 (link2), pose
  const Real bias_1_p1 = c5 * bias_3_p2;

  // link 7 (link4), outward
  const Real w7_y = s7 * minus_w6_x + c7 * w6_z;

  // link 5 (link2), pose
  const Real bias_1_p2 = s5 * bias_3_p2;

  // link 6 (link3), outward
  const Real wd6_y = s6 * minus_wd5_x + c6 * wd5_y + minus_w6_x * qd[5];
  const Real wd6_x = s6 * wd5_y - c6 * minus_wd5_x + w6_y * qd[5];

  // link 7 (link4), outward
  const Real w7_x = s7 * w6_z - c7 * minus_w6_x;

  // link 6 (link3), outward
  const Real minus_a6_z = 0.8636 * wd5_y + 0.1501 * (minus_w5_x * minus_w5_x + a6_x_p1);
  const Real a6_x = s6 * a6_x_p2 - c6 * a6_x_p3;

  // link 7 (link4), outward
  const Real wd7_x = c7 * wd6_x + w7_y * qd[6];

  // link 8 (link5), outward
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real w8_z = w7_y + qd[7];
  const Real w8_x = c8 * w7_x - s8 * w7_z;

  // link 7 (link4), outward
  const Real a7_x_p3 = a6_x + (0.0203 * (w6_y * w6_y + a7_x_p1) + 0.4331 * a7_x_p2);

  // link 6 (link3), pose
  const Real bias_3_p5 = c6 * bias_3_p3 - s6 * bias_3_p4;
  const Real bias_1_p3 = c6 * bias_1_p1 - s6 * bias_1_p2;

  // link 6 (link3), outward
  const Real a6_y = s6 * a6_x_p3 + c6 * a6_x_p2;

  // link 7 (link4), outward
  const Real minus_wd7_y = s7 * wd6_x + w7_x * qd[6];
  const Real a7_x_p4 = 0.0203 * (minus_w6_x * w6_z + wd6_y) - 0.4331 * (w6_y * w6_z + wd6_x) -
      minus_a6_z;

  // link 6 (link3), pose
  const Real bias_2_p1 = c6 * s5 + s6 * c5;

  // link 7 (link4), outward
  const Real minus_a7_z = a6_y + (0.0203 * a7_x_p2 + 0.4331 * (minus_w6_x * minus_w6_x + a7_x_p1));

  // link 9 (link6), outward
  const Real w9_x = c9 * w8_x + s9 * w8_z;
  const Real w9_y = c9 * w8_z - s9 * w8_x;

  // link 8 (link5), outward
  const Real wd8_x = c8 * wd7_x + s8 * wd6_y - minus_w8_y * qd[7];

  // link 9 (link6), outward
  const Real w9_z = minus_w8_y + qd[8];

  // link 7 (link4), pose
  const Real bias_2_p2 = c7 * bias_2_p1;
  const Real bias_3_p6 = c7 * bias_3_p5 - s7 * bias_3_p2;

  // link 6 (link3), pose
  const Real bias_3_p7 = s6 * bias_3_p3 + c6 * bias_3_p4;

  // link 7 (link4), pose
  const Real bias_1_p4 = c7 * bias_1_p3 + s7 * bias_3_p1;

  // link 6 (link3), pose
  const Real bias_1_p5 = s6 * bias_1_p1 + c6 * bias_1_p2;

  // link 7 (link4), outward
  const Real a7_x = c7 * a7_x_p3 + s7 * a7_x_p4;

  // link 6 (link3), pose
  const Real bias_2_p3 = s6 * s5 - c6 * c5;

  // link 7 (link4), outward
  const Real a7_y = c7 * a7_x_p4 - s7 * a7_x_p3;

  // link 7 (link4), pose
  const Real bias_2_p4 = s7 * bias_2_p1;
  const Real bias_3_p8 = s7 * bias_3_p5 + c7 * bias_3_p2;

  // link 8 (link5), pose
  const Real bias_3_p9 = c8 * bias_3_p6 - s8 * bias_3_p7;
  const Real bias_1_p6 = c8 * bias_1_p4 - s8 * bias_1_p5;

  // link 8 (link5), outward
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;

  // link 9 (link6), outward
  const Real minus_wd9_y = s9 * wd8_x + c9 * minus_wd7_y + w9_x * qd[8];
  const Real wd9_x = c9 * wd8_x - s9 * minus_wd7_y + w9_y * qd[8];

  // link 7 (link4), pose
  const Real bias_1_p7 = c7 * bias_3_p1 - s7 * bias_1_p3;

  // link 8 (link5), pose
  const Real bias_2_p5 = s8 * bias_2_p3 - c8 * bias_2_p2;

  // link 9 (link6), outward
  const Real a9_x = c9 * a8_x + s9 * a7_y;
  const Real a9_y = c9 * a7_y - s9 * a8_x;

  // link 9 (link6), pose
  const Real bias_3_p10 = c9 * bias_3_p9 - s9 * bias_3_p8;
  const Real bias_0_p1 = s9 * bias_3_p9 + c9 * bias_3_p8;

  // link 8 (link5), outward
  const Real a8_y = c8 * minus_a7_z - s8 * a7_x;

  // link 9 (link6), outward
  const Real bias_0_p2 = a9_x + 0.05625 * (w9_x * w9_z - minus_wd9_y);
  const Real bias_0_p3 = a9_y + 0.05625 * (w9_y * w9_z - wd9_x);

  // link 9 (link6), pose
  const Real bias_1_p8 = c9 * bias_1_p6 + s9 * bias_1_p7;
  const Real bias_1_p9 = c9 * bias_1_p7 - s9 * bias_1_p6;
  const Real bias_2_p6 = c9 * bias_2_p5 + s9 * bias_2_p4;
  const Real bias_2_p7 = c9 * bias_2_p4 - s9 * bias_2_p5;

  // link 8 (link5), pose
  const Real bias_0_p4 = s8 * bias_3_p6 + c8 * bias_3_p7;

  // link 9 (link6), outward
  const Real bias_0_p5 = a8_y + 0.05625 * (w9_x * w9_x + w9_y * w9_y);

  // link 8 (link5), pose
  const Real bias_1_p10 = s8 * bias_1_p4 + c8 * bias_1_p5;
  const Real bias_2_p8 = s8 * bias_2_p2 + c8 * bias_2_p3;

  // link 8 (link5), outward
  const Real wd8_y = c8 * wd6_y - s8 * wd7_x - w8_x * qd[7];

  // link 9 (link6), outward
  bias[0] = bias_3_p10 * bias_0_p2 - bias_0_p1 * bias_0_p3 - bias_0_p4 * bias_0_p5;
  bias[1] = bias_1_p8 * bias_0_p2 + bias_1_p9 * bias_0_p3 - bias_1_p10 * bias_0_p5;
  bias[2] = bias_2_p6 * bias_0_p2 + bias_2_p7 * bias_0_p3 + bias_2_p8 * bias_0_p5;
  bias[3] = bias_3_p10 * wd9_x + bias_0_p1 * minus_wd9_y - bias_0_p4 * wd8_y;
  bias[4] = bias_1_p8 * wd9_x - bias_1_p9 * minus_wd9_y - bias_1_p10 * wd8_y;
  bias[5] = bias_2_p6 * wd9_x - bias_2_p7 * minus_wd9_y + bias_2_p8 * wd8_y;
}

}  // namespace samm

#undef TREELINE_RESTRICT
