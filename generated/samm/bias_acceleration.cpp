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

  // link 4 (link1), outward
  const Real w4_z = qd[2] + qd[3];

  // link 6 (link3), outward
  const Real w6_z = qd[4] + qd[5];

  // link 5 (link2), outward
  const Real a6_y_p1 = qd[4] * qd[4];
  const Real a6_y_p2 = 0.4318 * s5;
  const Real w7_y_p1 = s5 * c6 + c5 * s6;
  const Real a7_x_p1 = s5 * s6 - c5 * c6;

  // link 4 (link1), outward
  const Real a7_x_p2 = w4_z * w4_z;

  // link 6 (link3), outward
  const Real a7_x_p3 = w6_z * w6_z;
  const Real wd6_x = w4_z * w6_z;

  // link 5 (link2), outward
  const Real wd5_x = w4_z * qd[4];

  // link 6 (link3), outward
  const Real a6_y = a6_y_p1 * a6_y_p2;
  const Real bias_3_p1 = c3 * c4 - s3 * s4;

  // link 7 (link4), outward
  const Real w7_y_p2 = w7_y_p1 * w4_z;
  const Real wd7_x_p1 = a7_x_p1 * wd6_x;
  const Real minus_wd7_z = w7_y_p1 * wd6_x;
  const Real bias_4_p1 = s3 * c4 + c3 * s4;

  // link 7 (link4), pose
  const Real bias_3_p2 = a7_x_p1 * bias_3_p1;
  const Real bias_3_p3 = w7_y_p1 * bias_3_p1;

  // link 6 (link3), outward
  const Real a6_x = (a7_x_p2 + a6_y_p1) * (0.4318 * c5);
  const Real a7_x_p4 = 0.0203 * w7_y_p1 - 0.4331 * a7_x_p1;

  // link 7 (link4), outward
  const Real w7_z = qd[6] - a7_x_p1 * w4_z;

  // link 7 (link4), pose
  const Real bias_5_p1 = c7 * w7_y_p1;
  const Real bias_4_p2 = a7_x_p1 * bias_4_p1;
  const Real bias_4_p3 = w7_y_p1 * bias_4_p1;

  // link 7 (link4), outward
  const Real w7_y = s7 * w7_y_p2 + c7 * w6_z;
  const Real w7_x = s7 * w6_z - c7 * w7_y_p2;
  const Real a7_x_p5 = a6_x + (a7_x_p2 + a7_x_p3) * (0.0203 * a7_x_p1 + 0.4331 * w7_y_p1);
  const Real a7_x_p6 = a6_y - a7_x_p3 * a7_x_p4;

  // link 8 (link5), outward
  const Real w8_z = w7_y + qd[7];

  // link 7 (link4), pose
  const Real bias_3_p4 = c7 * bias_3_p2 + s7 * bias_4_p1;
  const Real bias_4_p4 = s7 * bias_3_p1 - c7 * bias_4_p2;

  // link 7 (link4), outward
  const Real wd7_x = c7 * wd7_x_p1 + w7_y * qd[6];

  // link 8 (link5), outward
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real w8_x = c8 * w7_x - s8 * w7_z;

  // link 7 (link4), outward
  const Real minus_wd7_y = s7 * wd7_x_p1 + w7_x * qd[6];

  // link 9 (link6), outward
  const Real w9_z = minus_w8_y + qd[8];

  // link 7 (link4), outward
  const Real a7_x_p7 = a7_x_p1 * a7_x_p5 - w7_y_p1 * a7_x_p6;
  const Real a7_x_p8 = 2.0 * (wd6_x * a7_x_p4 - wd5_x * a6_y_p2) - 0.1501 * a7_x_p2;
  const Real minus_a7_z = w7_y_p1 * a7_x_p5 + a7_x_p1 * a7_x_p6;

  // link 7 (link4), pose
  const Real bias_5_p2 = s7 * w7_y_p1;

  // link 9 (link6), outward
  const Real minus_wd9_y = minus_wd7_y + w8_x * qd[8];

  // link 8 (link5), pose
  const Real bias_3_p5 = c8 * bias_3_p4 + s8 * bias_3_p3;

  // link 7 (link4), pose
  const Real bias_3_p6 = s7 * bias_3_p2 - c7 * bias_4_p1;

  // link 8 (link5), outward
  const Real wd8_x = c8 * wd7_x + s8 * minus_wd7_z - minus_w8_y * qd[7];

  // link 8 (link5), pose
  const Real bias_4_p5 = c8 * bias_4_p4 - s8 * bias_4_p3;

  // link 7 (link4), pose
  const Real bias_4_p6 = s7 * bias_4_p2 + c7 * bias_3_p1;

  // link 8 (link5), pose
  const Real bias_5_p3 = s8 * a7_x_p1 - c8 * bias_5_p1;

  // link 7 (link4), outward
  const Real a7_x = c7 * a7_x_p7 + s7 * a7_x_p8;

  // link 8 (link5), pose
  const Real bias_3_p7 = s8 * bias_3_p4 - c8 * bias_3_p3;

  // link 7 (link4), outward
  const Real a7_y = c7 * a7_x_p8 - s7 * a7_x_p7;

  // link 8 (link5), pose
  const Real bias_4_p7 = s8 * bias_4_p4 + c8 * bias_4_p3;
  const Real bias_5_p4 = s8 * bias_5_p1 + c8 * a7_x_p1;

  // link 9 (link6), outward
  const Real wd9_x = wd8_x + w8_z * qd[8];

  // link 8 (link5), outward
  const Real wd8_y = c8 * minus_wd7_z - s8 * wd7_x - w8_x * qd[7];
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;
  const Real a8_y = c8 * minus_a7_z - s8 * a7_x;

  // link 9 (link6), outward
  const Real bias_0_p1 = a8_x + 0.05625 * (w8_x * w9_z - minus_wd9_y);
  const Real bias_0_p2 = a8_y + 0.05625 * (w8_x * w8_x + w8_z * w8_z);
  const Real bias_0_p3 = a7_y + 0.05625 * (w8_z * w9_z - wd9_x);
  bias[3] = bias_3_p7 * wd8_y - (bias_3_p5 * wd9_x + bias_3_p6 * minus_wd9_y);
  bias[4] = bias_4_p5 * wd9_x - bias_4_p6 * minus_wd9_y - bias_4_p7 * wd8_y;
  bias[5] = bias_5_p3 * wd9_x - bias_5_p2 * minus_wd9_y + bias_5_p4 * wd8_y;
  bias[0] = bias_3_p6 * bias_0_p3 - bias_3_p5 * bias_0_p1 + bias_3_p7 * bias_0_p2;
  bias[1] = bias_4_p5 * bias_0_p1 + bias_4_p6 * bias_0_p3 - bias_4_p7 * bias_0_p2;
  bias[2] = bias_5_p3 * bias_0_p1 + bias_5_p2 * bias_0_p3 + bias_5_p4 * bias_0_p2;
}

}  // namespace samm

#undef TREELINE_RESTRICT
