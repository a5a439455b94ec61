// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1.
// 306 flops (add 135, mul 171, div 0), sine and cosine of 5 angles
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

void inverse_dynamics(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT qdd)[6], Real (&TREELINE_RESTRICT tau)[6]) noexcept {
  const Real angles[5] = {q[1], q[2], q[3], q[4], q[5]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];
  const Real c6 = cosines[4];
  const Real s6 = sines[4];

  // link 2 (upper_arm), outward
  const Real w2_x = s2 * qd[0];
  const Real w2_y = c2 * qd[0];
  const Real wd2_x_p1 = s2 * qdd[0];

  // link 3 (forearm), outward
  const Real w3_z = qd[1] + qd[2];

  // link 2 (upper_arm), outward
  const Real a3_y_p1 = qd[1] * qd[1];

  // link 3 (forearm), outward
  const Real wd3_z = qdd[1] + qdd[2];

  // link 2 (upper_arm), outward
  const Real a2_y = 9.81 * c2;
  const Real a2_x = 9.81 * s2;
  const Real wd2_x_p2 = w2_y * qd[1];
  const Real wd2_y_p1 = w2_x * qd[1];
  const Real a3_y_p2 = w2_x * w2_y;

  // link 4 (wrist_1), outward
  const Real w4_z = w3_z + qd[3];
  const Real wd4_z = wd3_z + qdd[3];

  // link 3 (forearm), outward
  const Real a4_y_p1 = w3_z * w3_z;

  // link 2 (upper_arm), outward
  const Real wd2_x = wd2_x_p1 + wd2_x_p2;
  const Real wd2_y = c2 * qdd[0] - wd2_y_p1;

  // link 3 (forearm), outward
  const Real w3_x = c3 * w2_x + s3 * w2_y;
  const Real w3_y = c3 * w2_y - s3 * w2_x;

  // link 2 (upper_arm), outward
  const Real a3_y_p3 = a3_y_p2 + qdd[1];

  // link 4 (wrist_1), outward
  const Real n4_x_p1 = w4_z * w4_z;

  // link 3 (forearm), outward
  const Real a4_y_p2 = w3_x * w3_y;

  // link 2 (upper_arm), outward
  const Real minus_a3_z_p1 = wd2_y_p1 - wd2_y;

  // link 4 (wrist_1), outward
  const Real w4_y = c4 * w3_y - s4 * w3_x;
  const Real w4_x = c4 * w3_x + s4 * w3_y;

  // link 3 (forearm), outward
  const Real a3_y_p4 = a2_y - 0.6127 * a3_y_p3;
  const Real a3_y_p5 = a2_x + 0.6127 * (w2_y * w2_y + a3_y_p1);
  const Real minus_a3_z = 0.6127 * minus_a3_z_p1;
  const Real wd3_x = c3 * wd2_x + s3 * wd2_y + w3_y * qd[2];
  const Real wd3_y = c3 * wd2_y - s3 * wd2_x - w3_x * qd[2];
  const Real a4_y_p3 = a4_y_p2 + wd3_z;

  // link 4 (wrist_1), outward
  const Real a4_y_p4 = w3_y * w3_y + a4_y_p1;

  // link 5 (wrist_2), outward
  const Real w5_z = qd[4] - w4_y;

  // link 4 (wrist_1), outward
  const Real minus_a5_z_p1 = w4_y * w4_z;
  const Real n4_x_p2 = w4_y * w4_y;
  const Real a5_x_p1 = w4_x * w4_z;

  // link 5 (wrist_2), outward
  const Real w5_y = c5 * w4_z - s5 * w4_x;
  const Real w5_x = c5 * w4_x + s5 * w4_z;

  // link 4 (wrist_1), outward
  const Real a5_x_p2 = w4_x * w4_x;

  // link 3 (forearm), outward
  const Real minus_a4_z_p1 = w3_x * w3_z - wd3_y;

  // link 5 (wrist_2), outward
  const Real n5_x_p1 = w5_z * w5_z;

  // link 4 (wrist_1), outward
  const Real n4_y_p1 = w4_x * w4_y;

  // link 3 (forearm), outward
  const Real a3_y = c3 * a3_y_p4 - s3 * a3_y_p5;
  const Real a3_x = c3 * a3_y_p5 + s3 * a3_y_p4;
  const Real n3_x_p1 = w3_y * w3_z;

  // link 6 (wrist_3), outward
  const Real w6_z = w5_y + qd[5];

  // link 4 (wrist_1), outward
  const Real wd4_x = c4 * wd3_x + s4 * wd3_y + w4_y * qd[3];
  const Real wd4_y = c4 * wd3_y - s4 * wd3_x - w4_x * qd[3];
  const Real a4_y_p5 = a3_y - 0.57155 * a4_y_p3;
  const Real a4_y_p6 = a3_x + 0.57155 * a4_y_p4;

  // link 6 (wrist_3), outward
  const Real n6_x_p1 = qd[5] + w6_z;

  // link 5 (wrist_2), outward
  const Real n5_y_p1 = w5_x * w5_y;
  const Real n5_y_p2 = w5_x * w5_z;
  const Real wd5_z = qdd[4] - wd4_y;

  // link 6 (wrist_3), outward
  const Real minus_w6_y = s6 * w5_x + c6 * w5_z;
  const Real w6_x = c6 * w5_x - s6 * w5_z;

  // link 4 (wrist_1), outward
  const Real a5_x_p3 = a5_x_p1 + wd4_y;
  const Real minus_a4_z = minus_a3_z + 0.57155 * minus_a4_z_p1;
  const Real a4_y = c4 * a4_y_p5 - s4 * a4_y_p6;
  const Real a4_x = c4 * a4_y_p6 + s4 * a4_y_p5;

  // link 5 (wrist_2), outward
  const Real n5_y_p3 = n5_y_p1 - wd5_z;
  const Real wd5_x = c5 * wd4_x + s5 * wd4_z + w5_y * qd[4];

  // link 4 (wrist_1), outward
  const Real n4_x_p3 = minus_a5_z_p1 + wd4_x;

  // link 5 (wrist_2), outward
  const Real wd5_y = c5 * wd4_z - s5 * wd4_x - w5_x * qd[4];
  const Real minus_a5_z = a4_y + 0.17415 * (minus_a5_z_p1 - wd4_x);

  // link 5 (wrist_2), inertial wrench
  const Real f5_x = 0.09132825 * n5_y_p3;

  // link 5 (wrist_2), outward
  const Real n5_x_p2 = w5_y * w5_z + wd5_x;

  // link 6 (wrist_3), outward
  const Real wd6_z = wd5_y + qdd[5];

  // link 5 (wrist_2), inertial wrench
  const Real minus_f5_y = 0.09132825 * (w5_x * w5_x + n5_x_p1);

  // link 4 (wrist_1), outward
  const Real n4_y_p2 = n4_y_p1 - wd4_z;

  // link 6 (wrist_3), inertial wrench
  const Real n6_z = 0.000623 * wd6_z;
  tau[5] = n6_z;

  // link 5 (wrist_2), outward
  const Real a5_x = c5 * (a4_x + 0.17415 * a5_x_p3) - s5 *
      (minus_a4_z + 0.17415 * (a5_x_p2 + n4_x_p2));

  // link 6 (wrist_3), inertial wrench
  const Real n6_x = 0.0003115 * (c6 * wd5_x - s6 * wd5_z - n6_x_p1 * minus_w6_y);
  const Real minus_n6_y = 0.0003115 * (s6 * wd5_x + c6 * wd5_z + n6_x_p1 * w6_x);

  // link 5 (wrist_2), inward
  const Real n4_y_p3 = c5 * f5_x + s5 * minus_f5_y;

  // link 6 (wrist_3), inward
  const Real n5_y = 0.0106962107625 * n5_y_p3 - 0.00124 * (n5_y_p2 - wd5_y) + n6_z;

  // link 5 (wrist_2), inertial wrench
  const Real f5_z = 0.09132825 * n5_x_p2;
  const Real n5_z_p1 = 0.008210591037500001 * wd5_z - 0.005730591037500001 * n5_y_p1 -
      0.0106962107625 * (n5_y_p2 + wd5_y) - 0.09132825 * a5_x;

  // link 5 (wrist_2), inward
  const Real f4_z = s5 * f5_x - c5 * minus_f5_y - 0.33495075 * n4_x_p3;
  const Real f4_x = n4_y_p3 - 0.33495075 * n4_y_p2;
  const Real f4_y = 0.33495075 * (a5_x_p2 + n4_x_p1) - f5_z;

  // link 6 (wrist_3), inward
  const Real n5_x = 0.0069705910375000004 * n5_x_p2 + 0.0106962107625 * (n5_x_p1 - w5_y * w5_y) -
      0.09132825 * minus_a5_z + (c6 * n6_x + s6 * minus_n6_y);
  const Real n5_z = n5_z_p1 + (c6 * minus_n6_y - s6 * n6_x);
  tau[4] = n5_z;

  // link 4 (wrist_1), inward
  const Real f3_z = f4_z - 4.0059802 * minus_a4_z_p1;
  const Real f3_y_p1 = s4 * f4_x + c4 * f4_y;
  const Real f3_y = f3_y_p1 - 4.0059802 * a4_y_p3;

  // link 5 (wrist_2), inward
  const Real n4_y = 0.17415 * n4_y_p3 - n5_z - (0.001315 * (a5_x_p1 - wd4_y) + 0.0585962731125 *
      n4_y_p2);

  // link 4 (wrist_1), inward
  const Real f3_x = 4.0059802 * a4_y_p4 + (c4 * f4_x - s4 * f4_y);

  // link 5 (wrist_2), inward
  const Real n4_z = 0.0397298163875 * wd4_z - 0.037099816387500005 * n4_y_p1 + 0.0585962731125 *
      a5_x_p3 + 0.33495075 * a4_x + (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;
  const Real n4_x = 0.0384148163875 * n4_x_p3 - 0.0585962731125 * (n4_x_p1 - n4_x_p2) + 0.33495075 *
      minus_a4_z + (c5 * n5_x - s5 * n5_y + 0.0159048147375 * n5_x_p2);

  // link 3 (forearm), inertial wrench
  const Real n3_z_p1 = 2.07831527531 * a4_y_p2 + 2.0833052753100003 * wd3_z - 0.5656542411875001 *
      (n3_x_p1 - wd3_x) - 4.0059802 * a3_y;

  // link 4 (wrist_1), inward
  const Real n3_z = n3_z_p1 + (n4_z - 0.57155 * f3_y_p1);
  tau[2] = n3_z;
  const Real n3_x = 0.002495 * (n3_x_p1 + wd3_x) + 0.5656542411875001 * a4_y_p3 +
      (c4 * n4_x - s4 * n4_y);

  // link 3 (forearm), inward
  const Real n2_z = 4.36318718615 * a3_y_p2 + 4.3866871861500005 * qdd[1] + 1.156008191975 *
      wd2_x_p1 - 81.98859064500002 * c2 + (n3_z - 0.6127 * (s3 * f3_x + c3 * f3_y));
  tau[1] = n2_z;

  // link 4 (wrist_1), inward
  const Real n3_y = s4 * n4_x + c4 * n4_y + 0.57155 * f4_z -
      (2.08081027531 * minus_a4_z_p1 + 0.5656542411875001 * (w3_x * w3_x - a4_y_p1) +
      2.45446406854 * minus_a3_z_p1);

  // link 3 (forearm), inward
  const Real n2_x = 0.01175 * (wd2_x_p2 + wd2_x) + 1.156008191975 * a3_y_p3 +
      (c3 * n3_x - s3 * n3_y);
  const Real n2_y = s3 * n3_x + c3 * n3_y + 0.6127 * f3_z -
      (4.37493718615 * minus_a3_z_p1 + 1.156008191975 * (w2_x * w2_x - a3_y_p1));

  // link 2 (upper_arm), inward
  const Real n1_z = 0.5353459446375 * qdd[0] + (s2 * n2_x + c2 * n2_y);
  tau[0] = n1_z;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
