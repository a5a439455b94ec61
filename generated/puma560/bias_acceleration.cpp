// bias_acceleration: xdd = J qdd + Jd qd: the term Jd qd
// By outward recursion, Chang eq. 6.11.
// 240 flops (add 87, mul 153, div 0), sine and cosine of 6 angles
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
  const Real angles[6] = {q[0], q[1], q[2], q[3], q[4], q[5]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real s1 = sines[0];
  const Real c1 = cosines[0];
  const Real s2 = sines[1];
  const Real c2 = cosines[1];
  const Real s3 = sines[2];
  const Real c3 = cosines[2];
  const Real s4 = sines[3];
  const Real c4 = cosines[3];
  const Real s5 = sines[4];
  const Real c5 = cosines[4];
  const Real s6 = sines[5];
  const Real c6 = cosines[5];

  // link 2 (link2), outward
  const Real minus_w2_y = qd[0] * c2;
  const Real minus_a4_x_p1 = minus_w2_y * minus_w2_y;
  const Real minus_w2_x = qd[0] * s2;
  const Real wd2_y = qd[1] * minus_w2_x;
  const Real minus_wd2_x = qd[1] * minus_w2_y;

  // link 3 (link3), outward
  const Real minus_w3_y = c3 * minus_w2_y - s3 * minus_w2_x;
  const Real wd3_x = s3 * wd2_y - c3 * minus_wd2_x - qd[2] * minus_w3_y;
  const Real w3_z = qd[1] + qd[2];

  // link 4 (link4), outward
  const Real minus_a4_x_p2 = 0.1501 * (minus_a4_x_p1 + minus_w2_x * minus_w2_x) + 0.8636 * wd2_y +
      0.4331 * (wd3_x - minus_w3_y * w3_z);

  // link 3 (link3), outward
  const Real minus_w3_x = s3 * minus_w2_y + c3 * minus_w2_x;
  const Real wd3_y = c3 * wd2_y + s3 * minus_wd2_x + qd[2] * minus_w3_x;

  // link 4 (link4), outward
  const Real minus_a4_x_p3 = minus_a4_x_p2 - 0.0203 * (wd3_y + minus_w3_x * w3_z);

  // link 3 (link3), outward
  const Real minus_a4_x_p4 = minus_w2_y * (0.4318 * minus_w2_x);
  const Real minus_a4_x_p5 = 0.4318 * (minus_a4_x_p1 + qd[1] * qd[1]);
  const Real minus_a4_x_p6 = minus_w3_x * minus_w3_y;
  const Real minus_a4_x_p7 = w3_z * w3_z;

  // link 4 (link4), outward
  const Real minus_a4_x_p8 = s3 * minus_a4_x_p4 - c3 * minus_a4_x_p5 - 0.4331 * minus_a4_x_p6 +
      0.0203 * (minus_a4_x_p7 + minus_w3_y * minus_w3_y);
  const Real minus_a4_x = s4 * minus_a4_x_p3 - c4 * minus_a4_x_p8;
  const Real minus_a4_z = c3 * minus_a4_x_p4 + s3 * minus_a4_x_p5 + 0.4331 *
      (minus_a4_x_p7 + minus_w3_x * minus_w3_x) - 0.0203 * minus_a4_x_p6;
  const Real w4_z = qd[3] + minus_w3_y;
  const Real w4_x = s4 * w3_z - c4 * minus_w3_x;

  // link 5 (link5), outward
  const Real minus_w5_x = s5 * w4_z - c5 * w4_x;

  // link 4 (link4), outward
  const Real w4_y = c4 * w3_z + s4 * minus_w3_x;

  // link 5 (link5), outward
  const Real w5_z = qd[4] + w4_y;

  // link 6 (link6), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_x;
  const Real w6_y = c6 * w5_z + s6 * minus_w5_x;
  const Real bias_0_p1 = c5 * minus_a4_z + s5 * minus_a4_x + 0.05625 * (w6_x * w6_x + w6_y * w6_y);

  // link 2 (link2), pose
  const Real bias_0_p2 = c1 * s2;
  const Real bias_0_p3 = c1 * c2;

  // link 3 (link3), pose
  const Real bias_0_p4 = c3 * bias_0_p2 + s3 * bias_0_p3;
  const Real bias_0_p5 = s3 * bias_0_p2 - c3 * bias_0_p3;

  // link 4 (link4), pose
  const Real bias_0_p6 = s1 * s4 + c4 * bias_0_p5;

  // link 5 (link5), pose
  const Real bias_0_p7 = c5 * bias_0_p4 - s5 * bias_0_p6;

  // link 4 (link4), outward
  const Real minus_a4_y = c4 * minus_a4_x_p3 + s4 * minus_a4_x_p8;

  // link 5 (link5), outward
  const Real a5_x = s5 * minus_a4_z - c5 * minus_a4_x;

  // link 4 (link4), outward
  const Real wd4_x = c4 * wd3_x + qd[3] * w4_y;

  // link 5 (link5), outward
  const Real minus_w5_y = c5 * w4_z + s5 * w4_x;
  const Real wd5_x = s5 * wd3_y + c5 * wd4_x - qd[4] * minus_w5_y;

  // link 4 (link4), outward
  const Real minus_wd4_y = s4 * wd3_x + qd[3] * w4_x;

  // link 6 (link6), outward
  const Real minus_wd6_x = s6 * minus_wd4_y - c6 * wd5_x - qd[5] * w6_y;
  const Real w6_z = qd[5] + minus_w5_y;
  const Real bias_0_p8 = c6 * minus_a4_y + s6 * a5_x - 0.05625 * (minus_wd6_x + w6_y * w6_z);

  // link 5 (link5), pose
  const Real bias_0_p9 = s5 * bias_0_p4 + c5 * bias_0_p6;

  // link 4 (link4), pose
  const Real bias_0_p10 = s1 * c4 - s4 * bias_0_p5;

  // link 6 (link6), pose
  const Real bias_0_p11 = c6 * bias_0_p10 - s6 * bias_0_p9;

  // link 6 (link6), outward
  const Real minus_wd6_y = c6 * minus_wd4_y + s6 * wd5_x + qd[5] * w6_x;
  const Real bias_0_p12 = s6 * minus_a4_y - c6 * a5_x + 0.05625 * (minus_wd6_y - w6_x * w6_z);

  // link 6 (link6), pose
  const Real bias_0_p13 = s6 * bias_0_p10 + c6 * bias_0_p9;

  // link 6 (link6), outward
  bias[0] = -(bias_0_p7 * bias_0_p1 - bias_0_p11 * bias_0_p8 - bias_0_p13 * bias_0_p12);

  // link 2 (link2), pose
  const Real bias_1_p1 = s1 * s2;
  const Real bias_1_p2 = s1 * c2;

  // link 3 (link3), pose
  const Real bias_1_p3 = c3 * bias_1_p1 + s3 * bias_1_p2;
  const Real bias_1_p4 = s3 * bias_1_p1 - c3 * bias_1_p2;

  // link 4 (link4), pose
  const Real bias_1_p5 = c1 * s4 - c4 * bias_1_p4;

  // link 5 (link5), pose
  const Real bias_1_p6 = c5 * bias_1_p3 + s5 * bias_1_p5;
  const Real bias_1_p7 = s5 * bias_1_p3 - c5 * bias_1_p5;

  // link 4 (link4), pose
  const Real bias_1_p8 = c1 * c4 + s4 * bias_1_p4;

  // link 6 (link6), pose
  const Real bias_1_p9 = c6 * bias_1_p8 + s6 * bias_1_p7;
  const Real bias_1_p10 = s6 * bias_1_p8 - c6 * bias_1_p7;

  // link 6 (link6), outward
  bias[1] = -(bias_1_p6 * bias_0_p1 + bias_1_p9 * bias_0_p8 + bias_1_p10 * bias_0_p12);

  // link 3 (link3), pose
  const Real bias_2_p1 = c2 * c3 - s2 * s3;
  const Real bias_2_p2 = c2 * s3 + s2 * c3;

  // link 4 (link4), pose
  const Real bias_2_p3 = c4 * bias_2_p2;

  // link 5 (link5), pose
  const Real bias_2_p4 = c5 * bias_2_p1 - s5 * bias_2_p3;
  const Real bias_2_p5 = s5 * bias_2_p1 + c5 * bias_2_p3;

  // link 4 (link4), pose
  const Real bias_2_p6 = s4 * bias_2_p2;

  // link 6 (link6), pose
  const Real bias_2_p7 = c6 * bias_2_p6 + s6 * bias_2_p5;
  const Real bias_2_p8 = s6 * bias_2_p6 - c6 * bias_2_p5;

  // link 6 (link6), outward
  bias[2] = -(bias_2_p4 * bias_0_p1 + bias_2_p7 * bias_0_p8 + bias_2_p8 * bias_0_p12);

  // link 5 (link5), outward
  const Real wd5_y = c5 * wd3_y - s5 * wd4_x + qd[4] * minus_w5_x;

  // link 6 (link6), outward
  bias[3] = -(bias_0_p7 * wd5_y - bias_0_p11 * minus_wd6_y - bias_0_p13 * minus_wd6_x);
  bias[4] = -(bias_1_p6 * wd5_y + bias_1_p9 * minus_wd6_y + bias_1_p10 * minus_wd6_x);
  bias[5] = -(bias_2_p4 * wd5_y + bias_2_p7 * minus_wd6_y + bias_2_p8 * minus_wd6_x);
}

}  // namespace puma560

#undef TREELINE_RESTRICT
