// bias_acceleration: xdd = J qdd + Jd qd: the term Jd qd
// By outward recursion, Chang eq. 6.11.
// 252 flops (add 92, mul 160, div 0), sine and cosine of 6 angles
// Generated; see ur10e.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
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
  const Real s5 = sines[1];
  const Real s1 = sines[5];
  const Real s6 = sines[0];

  // link 2 (upper_arm), outward
  const Real w2_y = c2 * qd[0];
  const Real w2_x = s2 * qd[0];

  // link 3 (forearm), outward
  const Real w3_z = qd[1] + qd[2];

  // link 2 (upper_arm), pose
  const Real bias_3_p1 = c2 * c1;
  const Real bias_3_p2 = s2 * c1;

  // link 4 (wrist_1), outward
  const Real w4_z = w3_z + qd[3];

  // link 2 (upper_arm), outward
  const Real wd2_x = w2_y * qd[1];
  const Real minus_wd2_y = w2_x * qd[1];

  // link 3 (forearm), outward
  const Real w3_y = c3 * w2_y - s3 * w2_x;
  const Real w3_x = c3 * w2_x + s3 * w2_y;
  const Real a3_x_p1 = 0.6127 * (w2_x * w2_y);
  const Real minus_a3_z = 1.2254 * minus_wd2_y;

  // link 3 (forearm), pose
  const Real bias_3_p3 = c3 * bias_3_p1 - s3 * bias_3_p2;

  // link 3 (forearm), outward
  const Real a3_x_p2 = 0.6127 * (w2_y * w2_y + qd[1] * qd[1]);

  // link 3 (forearm), pose
  const Real bias_3_p4 = s3 * bias_3_p1 + c3 * bias_3_p2;

  // link 3 (forearm), outward
  const Real wd3_x = c3 * wd2_x - s3 * minus_wd2_y + w3_y * qd[2];
  const Real minus_wd3_y = s3 * wd2_x + c3 * minus_wd2_y + w3_x * qd[2];

  // link 4 (wrist_1), outward
  const Real w4_x = c4 * w3_x + s4 * w3_y;
  const Real w4_y = c4 * w3_y - s4 * w3_x;

  // link 2 (upper_arm), pose
  const Real bias_4_p1 = c2 * s1;
  const Real bias_4_p2 = s2 * s1;

  // link 3 (forearm), outward
  const Real a3_x = c3 * a3_x_p2 - s3 * a3_x_p1;
  const Real minus_a3_y = s3 * a3_x_p2 + c3 * a3_x_p1;

  // link 5 (wrist_2), outward
  const Real w5_z = qd[4] - w4_y;

  // link 4 (wrist_1), outward
  const Real a4_x_p1 = a3_x + 0.57155 * (w3_y * w3_y + w3_z * w3_z);
  const Real a4_x_p2 = minus_a3_y + 0.57155 * (w3_x * w3_y);

  // link 5 (wrist_2), outward
  const Real w5_x = c5 * w4_x + s5 * w4_z;

  // link 4 (wrist_1), outward
  const Real minus_wd4_y = s4 * wd3_x + c4 * minus_wd3_y + w4_x * qd[3];

  // link 5 (wrist_2), outward
  const Real w5_y = c5 * w4_z - s5 * w4_x;

  // link 4 (wrist_1), outward
  const Real wd4_x = c4 * wd3_x - s4 * minus_wd3_y + w4_y * qd[3];
  const Real minus_a4_z = minus_a3_z + 0.57155 * (w3_x * w3_z + minus_wd3_y);
  const Real a4_x = c4 * a4_x_p1 - s4 * a4_x_p2;

  // link 3 (forearm), pose
  const Real bias_4_p3 = c3 * bias_4_p1 - s3 * bias_4_p2;
  const Real bias_4_p4 = s3 * bias_4_p1 + c3 * bias_4_p2;

  // link 5 (wrist_2), outward
  const Real a5_x_p1 = minus_a4_z + 0.17415 * (w4_x * w4_x + w4_y * w4_y);

  // link 3 (forearm), pose
  const Real bias_2_p1 = c3 * s2 + s3 * c2;
  const Real bias_2_p2 = c3 * c2 - s3 * s2;

  // link 5 (wrist_2), outward
  const Real minus_wd5_y = s5 * wd4_x + w5_x * qd[4];
  const Real wd5_x = c5 * wd4_x + w5_y * qd[4];

  // link 6 (wrist_3), outward
  const Real w6_x = c6 * w5_x - s6 * w5_z;

  // link 5 (wrist_2), outward
  const Real a5_x_p2 = a4_x + 0.17415 * (w4_x * w4_z - minus_wd4_y);

  // link 6 (wrist_3), outward
  const Real minus_w6_y = s6 * w5_x + c6 * w5_z;

  // link 4 (wrist_1), outward
  const Real minus_a4_y = s4 * a4_x_p1 + c4 * a4_x_p2;

  // link 6 (wrist_3), outward
  const Real w6_z = w5_y + qd[5];

  // link 4 (wrist_1), pose
  const Real bias_3_p5 = c4 * bias_3_p3 - s4 * bias_3_p4;
  const Real bias_4_p5 = c4 * bias_4_p3 - s4 * bias_4_p4;

  // link 5 (wrist_2), outward
  const Real minus_a5_z = 0.17415 * (w4_y * w4_z - wd4_x) - minus_a4_y;
  const Real a5_x = c5 * a5_x_p2 - s5 * a5_x_p1;

  // link 4 (wrist_1), pose
  const Real bias_2_p3 = c4 * bias_2_p1 + s4 * bias_2_p2;

  // link 6 (wrist_3), outward
  const Real a6_x_p1 = minus_a5_z + 0.11985 * (w5_x * w5_x + w5_y * w5_y);
  const Real minus_wd6_y = s6 * wd5_x + c6 * minus_wd4_y + w6_x * qd[5];
  const Real wd6_x = c6 * wd5_x - s6 * minus_wd4_y - minus_w6_y * qd[5];

  // link 4 (wrist_1), pose
  const Real bias_3_p6 = s4 * bias_3_p3 + c4 * bias_3_p4;

  // link 6 (wrist_3), outward
  const Real a6_x_p2 = a5_x + 0.11985 * (w5_x * w5_z - minus_wd5_y);

  // link 5 (wrist_2), pose
  const Real bias_2_p4 = c5 * bias_2_p3;
  const Real bias_3_p7 = c5 * bias_3_p5 + s5 * s1;
  const Real bias_4_p6 = c5 * bias_4_p5 - s5 * c1;

  // link 4 (wrist_1), pose
  const Real bias_4_p7 = s4 * bias_4_p3 + c4 * bias_4_p4;
  const Real bias_2_p5 = c4 * bias_2_p2 - s4 * bias_2_p1;

  // link 6 (wrist_3), outward
  const Real a6_x = c6 * a6_x_p2 + s6 * a6_x_p1;
  const Real a6_y = c6 * a6_x_p1 - s6 * a6_x_p2;

  // link 5 (wrist_2), outward
  const Real minus_a5_y = s5 * a5_x_p2 + c5 * a5_x_p1;

  // link 6 (wrist_3), pose
  const Real bias_3_p8 = c6 * bias_3_p7 - s6 * bias_3_p6;
  const Real bias_3_p9 = s6 * bias_3_p7 + c6 * bias_3_p6;
  const Real bias_4_p8 = c6 * bias_4_p6 - s6 * bias_4_p7;

  // link 6 (wrist_3), outward
  const Real bias_0_p1 = a6_x + 0.11655 * (w6_x * w6_z - minus_wd6_y);
  const Real bias_0_p2 = a6_y - 0.11655 * (minus_w6_y * w6_z + wd6_x);

  // link 6 (wrist_3), pose
  const Real bias_1_p1 = s6 * bias_4_p6 + c6 * bias_4_p7;
  const Real bias_2_p6 = c6 * bias_2_p4 + s6 * bias_2_p5;

  // link 6 (wrist_3), outward
  const Real a6_z = 0.11985 * (w5_y * w5_z - wd5_x) - minus_a5_y;

  // link 6 (wrist_3), pose
  const Real bias_2_p7 = c6 * bias_2_p5 - s6 * bias_2_p4;

  // link 5 (wrist_2), pose
  const Real bias_5_p1 = s5 * bias_2_p3;
  const Real bias_3_p10 = c5 * s1 - s5 * bias_3_p5;

  // link 6 (wrist_3), outward
  const Real bias_0_p3 = a6_z - 0.11655 * (w6_x * w6_x + minus_w6_y * minus_w6_y);

  // link 5 (wrist_2), pose
  const Real bias_1_p2 = s5 * bias_4_p5 + c5 * c1;

  // link 6 (wrist_3), outward
  bias[3] = bias_3_p8 * wd6_x + bias_3_p9 * minus_wd6_y - bias_3_p10 * minus_wd5_y;
  bias[0] = bias_3_p8 * bias_0_p1 - bias_3_p9 * bias_0_p2 + bias_3_p10 * bias_0_p3;
  bias[1] = bias_4_p8 * bias_0_p1 - bias_1_p1 * bias_0_p2 - bias_1_p2 * bias_0_p3;
  bias[2] = bias_2_p6 * bias_0_p1 + bias_2_p7 * bias_0_p2 - bias_5_p1 * bias_0_p3;
  bias[4] = bias_4_p8 * wd6_x + bias_1_p1 * minus_wd6_y + bias_1_p2 * minus_wd5_y;
  bias[5] = bias_2_p6 * wd6_x - bias_2_p7 * minus_wd6_y + bias_5_p1 * minus_wd5_y;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
