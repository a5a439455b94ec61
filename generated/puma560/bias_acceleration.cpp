// bias_acceleration: xdd = J qdd + Jd qd: the term Jd qd
// By outward recursion, Chang eq. 6.11.
// 240 flops (add 87, mul 153, div 0), sine and cosine of 6 angles
// Generated; see puma560.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
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
  const Real angles[6] = {q[5], q[4], q[3], q[2], q[1], q[0]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c6 = cosines[0];
  const Real c5 = cosines[1];
  const Real c4 = cosines[2];
  const Real c3 = cosines[3];
  const Real c2 = cosines[4];
  const Real c1 = cosines[5];
  const Real s3 = sines[3];
  const Real s2 = sines[4];
  const Real s4 = sines[2];
  const Real s1 = sines[5];
  const Real s5 = sines[1];
  const Real s6 = sines[0];

  // link 2 (link2), outward
  const Real minus_w2_x = s2 * qd[0];
  const Real minus_w2_y = c2 * qd[0];

  // link 3 (link3), outward
  const Real w3_z = qd[1] + qd[2];

  // link 2 (link2), pose
  const Real bias_3_p1 = c2 * c1;
  const Real bias_3_p2 = s2 * c1;

  // link 3 (link3), outward
  const Real a4_x_p1 = w3_z * w3_z;

  // link 2 (link2), outward
  const Real minus_wd2_x = minus_w2_y * qd[1];
  const Real wd2_y = minus_w2_x * qd[1];
  const Real a3_x_p1 = minus_w2_y * minus_w2_y;

  // link 3 (link3), outward
  const Real w3_y = s3 * minus_w2_x - c3 * minus_w2_y;
  const Real minus_w3_x = c3 * minus_w2_x + s3 * minus_w2_y;
  const Real a3_x_p2 = 0.4318 * (minus_w2_x * minus_w2_y);
  const Real a4_x_p2 = minus_w3_x * w3_y;
  const Real a3_x_p3 = 0.4318 * (a3_x_p1 + qd[1] * qd[1]);

  // link 4 (link4), outward
  const Real w4_z = qd[3] - w3_y;

  // link 2 (link2), pose
  const Real bias_4_p1 = c2 * s1;

  // link 4 (link4), outward
  const Real w4_y = s4 * minus_w3_x + c4 * w3_z;

  // link 2 (link2), pose
  const Real bias_4_p2 = s2 * s1;

  // link 3 (link3), outward
  const Real wd3_y = s3 * minus_wd2_x + c3 * wd2_y + minus_w3_x * qd[2];
  const Real wd3_x = s3 * wd2_y - c3 * minus_wd2_x + w3_y * qd[2];

  // link 4 (link4), outward
  const Real w4_x = s4 * w3_z - c4 * minus_w3_x;

  // link 3 (link3), outward
  const Real minus_a3_z = 0.8636 * wd2_y + 0.1501 * (minus_w2_x * minus_w2_x + a3_x_p1);
  const Real a3_x = s3 * a3_x_p2 - c3 * a3_x_p3;

  // link 5 (link5), outward
  const Real w5_z = w4_y + qd[4];

  // link 4 (link4), outward
  const Real wd4_x = c4 * wd3_x + w4_y * qd[3];

  // link 5 (link5), outward
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;
  const Real w5_x = c5 * w4_x - s5 * w4_z;

  // link 3 (link3), pose
  const Real bias_3_p3 = c3 * bias_3_p1 - s3 * bias_3_p2;

  // link 4 (link4), outward
  const Real a4_x_p3 = a3_x + (0.0203 * (w3_y * w3_y + a4_x_p1) + 0.4331 * a4_x_p2);

  // link 3 (link3), pose
  const Real bias_4_p3 = c3 * bias_4_p1 - s3 * bias_4_p2;

  // link 3 (link3), outward
  const Real a3_y = s3 * a3_x_p3 + c3 * a3_x_p2;

  // link 4 (link4), outward
  const Real minus_wd4_y = s4 * wd3_x + w4_x * qd[3];
  const Real a4_x_p4 = 0.0203 * (minus_w3_x * w3_z + wd3_y) - 0.4331 * (w3_y * w3_z + wd3_x) -
      minus_a3_z;

  // link 3 (link3), pose
  const Real bias_5_p1 = c3 * s2 + s3 * c2;

  // link 4 (link4), outward
  const Real minus_a4_z = a3_y + (0.0203 * a4_x_p2 + 0.4331 * (minus_w3_x * minus_w3_x + a4_x_p1));

  // link 6 (link6), outward
  const Real w6_x = c6 * w5_x + s6 * w5_z;
  const Real w6_y = c6 * w5_z - s6 * w5_x;
  const Real w6_z = minus_w5_y + qd[5];

  // link 4 (link4), pose
  const Real bias_3_p4 = c4 * bias_3_p3 - s4 * s1;

  // link 5 (link5), outward
  const Real wd5_x = c5 * wd4_x + s5 * wd3_y - minus_w5_y * qd[4];

  // link 4 (link4), pose
  const Real bias_5_p2 = c4 * bias_5_p1;

  // link 3 (link3), pose
  const Real bias_3_p5 = s3 * bias_3_p1 + c3 * bias_3_p2;

  // link 4 (link4), pose
  const Real bias_4_p4 = c4 * bias_4_p3 + s4 * c1;

  // link 3 (link3), pose
  const Real bias_4_p5 = s3 * bias_4_p1 + c3 * bias_4_p2;
  const Real bias_5_p3 = s3 * s2 - c3 * c2;

  // link 4 (link4), outward
  const Real a4_x = c4 * a4_x_p3 + s4 * a4_x_p4;
  const Real a4_y = c4 * a4_x_p4 - s4 * a4_x_p3;

  // link 4 (link4), pose
  const Real bias_5_p4 = s4 * bias_5_p1;

  // link 5 (link5), pose
  const Real bias_3_p6 = c5 * bias_3_p4 - s5 * bias_3_p5;

  // link 4 (link4), pose
  const Real bias_3_p7 = s4 * bias_3_p3 + c4 * s1;

  // link 5 (link5), pose
  const Real bias_4_p6 = c5 * bias_4_p4 - s5 * bias_4_p5;

  // link 4 (link4), pose
  const Real bias_4_p7 = c4 * c1 - s4 * bias_4_p3;

  // link 5 (link5), pose
  const Real bias_5_p5 = s5 * bias_5_p3 - c5 * bias_5_p2;

  // link 5 (link5), outward
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;

  // link 6 (link6), outward
  const Real minus_wd6_y = s6 * wd5_x + c6 * minus_wd4_y + w6_x * qd[5];
  const Real wd6_x = c6 * wd5_x - s6 * minus_wd4_y + w6_y * qd[5];
  const Real a6_x = c6 * a5_x + s6 * a4_y;
  const Real a6_y = c6 * a4_y - s6 * a5_x;

  // link 6 (link6), pose
  const Real bias_3_p8 = c6 * bias_3_p6 - s6 * bias_3_p7;
  const Real bias_3_p9 = s6 * bias_3_p6 + c6 * bias_3_p7;

  // link 5 (link5), outward
  const Real a5_y = c5 * minus_a4_z - s5 * a4_x;

  // link 6 (link6), pose
  const Real bias_4_p8 = c6 * bias_4_p6 + s6 * bias_4_p7;
  const Real bias_4_p9 = c6 * bias_4_p7 - s6 * bias_4_p6;
  const Real bias_5_p6 = c6 * bias_5_p5 + s6 * bias_5_p4;
  const Real bias_2_p1 = c6 * bias_5_p4 - s6 * bias_5_p5;

  // link 6 (link6), outward
  const Real bias_0_p1 = a6_x + 0.05625 * (w6_x * w6_z - minus_wd6_y);
  const Real bias_0_p2 = a6_y + 0.05625 * (w6_y * w6_z - wd6_x);

  // link 5 (link5), pose
  const Real bias_0_p3 = s5 * bias_3_p4 + c5 * bias_3_p5;

  // link 6 (link6), outward
  const Real bias_0_p4 = a5_y + 0.05625 * (w6_x * w6_x + w6_y * w6_y);

  // link 5 (link5), pose
  const Real bias_1_p1 = s5 * bias_4_p4 + c5 * bias_4_p5;
  const Real bias_2_p2 = s5 * bias_5_p2 + c5 * bias_5_p3;

  // link 5 (link5), outward
  const Real wd5_y = c5 * wd3_y - s5 * wd4_x - w5_x * qd[4];

  // link 6 (link6), outward
  bias[0] = bias_3_p8 * bias_0_p1 - bias_3_p9 * bias_0_p2 - bias_0_p3 * bias_0_p4;
  bias[1] = bias_4_p8 * bias_0_p1 + bias_4_p9 * bias_0_p2 - bias_1_p1 * bias_0_p4;
  bias[2] = bias_5_p6 * bias_0_p1 + bias_2_p1 * bias_0_p2 + bias_2_p2 * bias_0_p4;
  bias[3] = bias_3_p8 * wd6_x + bias_3_p9 * minus_wd6_y - bias_0_p3 * wd5_y;
  bias[4] = bias_4_p8 * wd6_x - bias_4_p9 * minus_wd6_y - bias_1_p1 * wd5_y;
  bias[5] = bias_5_p6 * wd6_x - bias_2_p1 * minus_wd6_y + bias_2_p2 * wd5_y;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
