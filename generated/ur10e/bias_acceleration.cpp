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

  // link 3 (forearm), outward
  const Real w3_z = qd[1] + qd[2];
  const Real a5_x_p1 = 0.6127 * s2;

  // link 1 (shoulder), outward
  const Real a3_x_p1 = qd[0] * qd[0];

  // link 2 (upper_arm), outward
  const Real a3_x_p2 = qd[1] * qd[1];
  const Real w4_x_p1 = c2 * c3 - s2 * s3;
  const Real w4_x_p2 = s2 * c3 + c2 * s3;

  // link 3 (forearm), outward
  const Real a4_x_p1 = w3_z * w3_z;

  // link 4 (wrist_1), outward
  const Real w4_z = w3_z + qd[3];

  // link 3 (forearm), outward
  const Real a3_y = a3_x_p2 * a5_x_p1;
  const Real a5_x_p2 = 0.57155 * w4_x_p2;
  const Real a3_x = (a3_x_p1 + a3_x_p2) * (0.6127 * c2);
  const Real w4_x_p3 = w4_x_p2 * c4 + w4_x_p1 * s4;
  const Real w4_y_p1 = w4_x_p1 * c4 - w4_x_p2 * s4;

  // link 4 (wrist_1), outward
  const Real w4_x = w4_x_p3 * qd[0];
  const Real w4_y = w4_y_p1 * qd[0];

  // link 4 (wrist_1), pose
  const Real bias_3_p1 = w4_y_p1 * c1;
  const Real bias_4_p1 = w4_y_p1 * s1;
  const Real bias_3_p2 = w4_x_p3 * c1;
  const Real bias_4_p2 = w4_x_p3 * s1;

  // link 5 (wrist_2), pose
  const Real bias_5_p1 = c5 * w4_x_p3;
  const Real bias_5_p2 = s5 * w4_x_p3;

  // link 4 (wrist_1), outward
  const Real a4_x_p2 = a3_x + (a3_x_p1 + a4_x_p1) * (0.57155 * w4_x_p1);
  const Real a4_x_p3 = a3_y + a4_x_p1 * a5_x_p2;
  const Real wd4_x = w4_y * w4_z;

  // link 5 (wrist_2), outward
  const Real w5_z = qd[4] - w4_y;

  // link 4 (wrist_1), outward
  const Real minus_wd4_y = w4_x * w4_z;

  // link 5 (wrist_2), outward
  const Real w5_x = c5 * w4_x + s5 * w4_z;
  const Real w5_y = c5 * w4_z - s5 * w4_x;

  // link 4 (wrist_1), outward
  const Real a4_x = w4_y_p1 * a4_x_p2 + w4_x_p3 * a4_x_p3;
  const Real a4_y = w4_y_p1 * a4_x_p3 - w4_x_p3 * a4_x_p2;

  // link 5 (wrist_2), pose
  const Real bias_3_p3 = c5 * bias_3_p1 + s5 * s1;
  const Real bias_4_p3 = c5 * bias_4_p1 - s5 * c1;

  // link 5 (wrist_2), outward
  const Real minus_a6_y_p1 = w5_x * w5_x;
  const Real bias_0_p1 = w5_y * w5_z;
  const Real a5_x_p3 = 0.17415 * a3_x_p1 + 2.0 * ((qd[1] * a5_x_p1 + w3_z * a5_x_p2) * qd[0]);

  // link 6 (wrist_3), outward
  const Real w6_z = w5_y + qd[5];

  // link 5 (wrist_2), pose
  const Real bias_3_p4 = c5 * s1 - s5 * bias_3_p1;
  const Real bias_4_p4 = s5 * bias_4_p1 + c5 * c1;

  // link 5 (wrist_2), outward
  const Real minus_wd5_y = s5 * wd4_x + w5_x * qd[4];
  const Real wd5_x = c5 * wd4_x + w5_y * qd[4];
  const Real bias_0_p2 = w5_x * w5_y - minus_wd4_y;
  const Real bias_0_p3 = bias_0_p1 + wd5_x;
  const Real a5_x = c5 * a4_x - s5 * a5_x_p3;
  const Real minus_a5_y = s5 * a4_x + c5 * a5_x_p3;

  // link 6 (wrist_3), outward
  const Real wd6_y = w5_x * w6_z - bias_0_p2;
  const Real minus_a6_y = a4_y + 0.11985 * (minus_a6_y_p1 + w5_y * w5_y);
  const Real wd6_x = w5_z * w6_z - bias_0_p3;
  const Real minus_a6_x = a5_x + 0.11985 * (w5_x * w5_z - minus_wd5_y);
  const Real bias_0_p4 = 0.11655 * bias_0_p3 - minus_a6_y;
  const Real a6_z = 0.11985 * (bias_0_p1 - wd5_x) - minus_a5_y;
  const Real bias_0_p5 = minus_a6_x + 0.11655 * bias_0_p2;
  const Real bias_0_p6 = a6_z - 0.11655 * (minus_a6_y_p1 + w5_z * w5_z);
  bias[3] = bias_3_p2 * wd6_y - bias_3_p3 * wd6_x - bias_3_p4 * minus_wd5_y;
  bias[4] = bias_4_p2 * wd6_y - bias_4_p3 * wd6_x + bias_4_p4 * minus_wd5_y;
  bias[5] = bias_5_p2 * minus_wd5_y - (bias_5_p1 * wd6_x + w4_y_p1 * wd6_y);
  bias[0] = bias_3_p3 * bias_0_p5 + bias_3_p2 * bias_0_p4 + bias_3_p4 * bias_0_p6;
  bias[1] = bias_4_p3 * bias_0_p5 + bias_4_p2 * bias_0_p4 - bias_4_p4 * bias_0_p6;
  bias[2] = bias_5_p1 * bias_0_p5 - w4_y_p1 * bias_0_p4 - bias_5_p2 * bias_0_p6;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
