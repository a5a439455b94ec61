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

  // link 3 (link3), outward
  const Real w3_z = qd[1] + qd[2];

  // link 1 (link1), outward
  const Real a3_x_p1 = qd[0] * qd[0];

  // link 2 (link2), outward
  const Real a3_x_p2 = qd[1] * qd[1];
  const Real a3_y_p1 = 0.4318 * s2;
  const Real wd2_x = qd[0] * qd[1];
  const Real w4_y_p1 = s2 * c3 + c2 * s3;
  const Real a4_x_p1 = s2 * s3 - c2 * c3;

  // link 3 (link3), outward
  const Real a4_x_p2 = w3_z * w3_z;
  const Real wd3_x = qd[0] * w3_z;
  const Real a3_y = a3_x_p2 * a3_y_p1;

  // link 4 (link4), outward
  const Real w4_y_p2 = w4_y_p1 * qd[0];
  const Real wd4_x_p1 = a4_x_p1 * wd3_x;

  // link 3 (link3), outward
  const Real a3_x = (a3_x_p1 + a3_x_p2) * (0.4318 * c2);

  // link 4 (link4), outward
  const Real minus_wd4_z = w4_y_p1 * wd3_x;

  // link 4 (link4), pose
  const Real bias_3_p1 = a4_x_p1 * c1;
  const Real bias_4_p1 = a4_x_p1 * s1;
  const Real bias_3_p2 = w4_y_p1 * c1;
  const Real bias_4_p2 = w4_y_p1 * s1;
  const Real bias_5_p1 = c4 * w4_y_p1;
  const Real bias_5_p2 = s4 * w4_y_p1;
  const Real a4_x_p3 = 0.0203 * w4_y_p1 - 0.4331 * a4_x_p1;

  // link 4 (link4), outward
  const Real w4_z = qd[3] - a4_x_p1 * qd[0];
  const Real w4_y = s4 * w4_y_p2 + c4 * w3_z;
  const Real w4_x = s4 * w3_z - c4 * w4_y_p2;

  // link 4 (link4), pose
  const Real bias_3_p3 = c4 * bias_3_p1 + s4 * s1;
  const Real bias_4_p3 = s4 * c1 - c4 * bias_4_p1;

  // link 4 (link4), outward
  const Real a4_x_p4 = a3_x + (a3_x_p1 + a4_x_p2) * (0.0203 * a4_x_p1 + 0.4331 * w4_y_p1);
  const Real a4_x_p5 = a3_y - a4_x_p2 * a4_x_p3;

  // link 5 (link5), outward
  const Real w5_z = w4_y + qd[4];

  // link 4 (link4), outward
  const Real wd4_x = c4 * wd4_x_p1 + w4_y * qd[3];

  // link 5 (link5), outward
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;
  const Real w5_x = c5 * w4_x - s5 * w4_z;

  // link 4 (link4), outward
  const Real minus_wd4_y = s4 * wd4_x_p1 + w4_x * qd[3];

  // link 5 (link5), pose
  const Real bias_3_p4 = c5 * bias_3_p3 + s5 * bias_3_p2;

  // link 4 (link4), pose
  const Real bias_3_p5 = s4 * bias_3_p1 - c4 * s1;

  // link 5 (link5), pose
  const Real bias_4_p4 = c5 * bias_4_p3 - s5 * bias_4_p2;

  // link 6 (link6), outward
  const Real w6_z = minus_w5_y + qd[5];

  // link 4 (link4), outward
  const Real a4_x_p6 = a4_x_p1 * a4_x_p4 - w4_y_p1 * a4_x_p5;
  const Real a4_x_p7 = 2.0 * (wd3_x * a4_x_p3 - wd2_x * a3_y_p1) - 0.1501 * a3_x_p1;
  const Real minus_a4_z = w4_y_p1 * a4_x_p4 + a4_x_p1 * a4_x_p5;

  // link 4 (link4), pose
  const Real bias_4_p5 = s4 * bias_4_p1 + c4 * c1;

  // link 5 (link5), pose
  const Real bias_5_p3 = s5 * a4_x_p1 - c5 * bias_5_p1;
  const Real bias_3_p6 = s5 * bias_3_p3 - c5 * bias_3_p2;
  const Real bias_4_p6 = s5 * bias_4_p3 + c5 * bias_4_p2;

  // link 6 (link6), outward
  const Real minus_wd6_y = minus_wd4_y + w5_x * qd[5];

  // link 5 (link5), pose
  const Real bias_5_p4 = s5 * bias_5_p1 + c5 * a4_x_p1;

  // link 5 (link5), outward
  const Real wd5_x = c5 * wd4_x + s5 * minus_wd4_z - minus_w5_y * qd[4];

  // link 4 (link4), outward
  const Real a4_x = c4 * a4_x_p6 + s4 * a4_x_p7;
  const Real a4_y = c4 * a4_x_p7 - s4 * a4_x_p6;

  // link 5 (link5), outward
  const Real wd5_y = c5 * minus_wd4_z - s5 * wd4_x - w5_x * qd[4];

  // link 6 (link6), outward
  const Real wd6_x = wd5_x + w5_z * qd[5];

  // link 5 (link5), outward
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;
  const Real a5_y = c5 * minus_a4_z - s5 * a4_x;

  // link 6 (link6), outward
  const Real bias_0_p1 = a5_x + 0.05625 * (w5_x * w6_z - minus_wd6_y);
  const Real bias_0_p2 = a5_y + 0.05625 * (w5_x * w5_x + w5_z * w5_z);
  const Real bias_0_p3 = a4_y + 0.05625 * (w5_z * w6_z - wd6_x);
  bias[3] = bias_3_p6 * wd5_y - (bias_3_p4 * wd6_x + bias_3_p5 * minus_wd6_y);
  bias[4] = bias_4_p4 * wd6_x - bias_4_p5 * minus_wd6_y - bias_4_p6 * wd5_y;
  bias[5] = bias_5_p3 * wd6_x - bias_5_p2 * minus_wd6_y + bias_5_p4 * wd5_y;
  bias[0] = bias_3_p5 * bias_0_p3 - bias_3_p4 * bias_0_p1 + bias_3_p6 * bias_0_p2;
  bias[1] = bias_4_p4 * bias_0_p1 + bias_4_p5 * bias_0_p3 - bias_4_p6 * bias_0_p2;
  bias[2] = bias_5_p3 * bias_0_p1 + bias_5_p2 * bias_0_p3 + bias_5_p4 * bias_0_p2;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
