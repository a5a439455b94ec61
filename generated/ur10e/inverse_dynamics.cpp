// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1.
// 262 flops (add 110, mul 152, div 0), sine and cosine of 4 angles
// Generated; see ur10e.hpp for the contract.
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
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];

  // link 3 (forearm), outward
  const Real w3_z = qd[1] + qd[2];

  // link 2 (upper_arm), outward
  const Real a3_y_p1 = qd[1] * qd[1];
  const Real a3_y_p2 = 0.6127 * s2;
  const Real a3_y_p3 = 0.6127 * c2;

  // link 1 (shoulder), outward
  const Real a3_x_p1 = qd[0] * qd[0];

  // link 3 (forearm), outward
  const Real wd3_z = qdd[1] + qdd[2];

  // link 2 (upper_arm), outward
  const Real a4_z_p1 = 2.0 * qd[0];
  const Real n1_z_p1 = 4.36318718615 * s2;
  const Real n1_z_p2 = 1.156008191975 * s2;
  const Real w4_y_p1 = s2 * c3 + c2 * s3;
  const Real w4_y_p2 = c2 * c3 - s2 * s3;

  // link 4 (wrist_1), outward
  const Real w4_z = w3_z + qd[3];

  // link 3 (forearm), outward
  const Real a4_y_p1 = w3_z * w3_z;

  // link 4 (wrist_1), outward
  const Real wd4_z = wd3_z + qdd[3];

  // link 3 (forearm), outward
  const Real a4_z_p2 = a4_z_p1 * w3_z;

  // link 2 (upper_arm), outward
  const Real a3_z_p1 = a4_z_p1 * qd[1];
  const Real a4_y_p2 = 0.57155 * w4_y_p1;
  const Real a4_y_p3 = 0.57155 * w4_y_p2;

  // link 3 (forearm), outward
  const Real a4_y_p4 = a3_x_p1 + a4_y_p1;
  const Real n1_z_p3 = c2 * n1_z_p1;

  // link 4 (wrist_1), outward
  const Real n4_x_p1 = w4_z * w4_z;
  const Real w4_y_p3 = w4_y_p2 * c4 - w4_y_p1 * s4;
  const Real w4_x_p1 = w4_y_p1 * c4 + w4_y_p2 * s4;
  const Real n1_z_p4 = 2.07831527531 * w4_y_p1;

  // link 3 (forearm), outward
  const Real a3_y = 9.81 + (a3_y_p1 * a3_y_p2 - qdd[1] * a3_y_p3);
  const Real a3_x = (a3_x_p1 + a3_y_p1) * a3_y_p3 + qdd[1] * a3_y_p2;

  // link 4 (wrist_1), outward
  const Real w4_y = w4_y_p3 * qd[0];
  const Real w4_x = w4_x_p1 * qd[0];
  const Real minus_a5_z_p1 = w4_x_p1 * qdd[0];
  const Real a5_x_p1 = w4_y_p3 * qdd[0];

  // link 3 (forearm), outward
  const Real a3_z = qdd[0] * a3_y_p3 - a3_z_p1 * a3_y_p2;
  const Real n1_z_p5 = 0.5656542411875001 * w4_y_p1;
  const Real n1_z_p6 = w4_y_p2 * n1_z_p4;
  const Real f3_x_p1 = 4.0059802 * w4_y_p2;
  const Real f3_x_p2 = 4.0059802 * w4_y_p1;

  // link 4 (wrist_1), outward
  const Real n5_x_p1 = w4_x * w4_y;

  // link 5 (wrist_2), outward
  const Real w5_z = qd[4] - w4_y;

  // link 4 (wrist_1), outward
  const Real a4_y_p5 = a3_y + (a4_y_p1 * a4_y_p2 - wd3_z * a4_y_p3);
  const Real a4_y_p6 = a3_x + (a4_y_p4 * a4_y_p3 + wd3_z * a4_y_p2);
  const Real wd4_y_p1 = w4_x * w4_z;
  const Real a4_z = a3_z + (qdd[0] * a4_y_p3 - a4_z_p2 * a4_y_p2);

  // link 5 (wrist_2), outward
  const Real n5_x_p2 = 2.0 * w5_z;
  const Real n5_x_p3 = w5_z * w5_z;

  // link 4 (wrist_1), outward
  const Real n5_x_p4 = n5_x_p1 - wd4_z;

  // link 5 (wrist_2), outward
  const Real w5_y = c5 * w4_z - s5 * w4_x;
  const Real w5_x = c5 * w4_x + s5 * w4_z;

  // link 4 (wrist_1), outward
  const Real wd4_y = a5_x_p1 - wd4_y_p1;
  const Real n5_x_p5 = minus_a5_z_p1 + 2.0 * (w4_y * w4_z);

  // link 5 (wrist_2), outward
  const Real minus_wd5_y_p1 = w5_x * w5_z;

  // link 6 (wrist_3), outward
  const Real w6_z = w5_y + qd[5];

  // link 5 (wrist_2), outward
  const Real n5_y_p1 = w5_x * w5_y;

  // link 4 (wrist_1), outward
  const Real a4_y = w4_y_p3 * a4_y_p5 - w4_x_p1 * a4_y_p6;

  // link 5 (wrist_2), outward
  const Real wd5_z = qdd[4] - wd4_y;

  // link 4 (wrist_1), outward
  const Real a4_x = w4_y_p3 * a4_y_p6 + w4_x_p1 * a4_y_p5;

  // link 5 (wrist_2), outward
  const Real minus_a5_z = a4_y - 0.17415 * minus_a5_z_p1;
  const Real n5_y_p2 = n5_y_p1 - wd5_z;
  const Real minus_wd5_y_p2 = c5 * n5_x_p4 + s5 * n5_x_p5;

  // link 5 (wrist_2), inertial wrench
  const Real f5_x = 0.09132825 * n5_y_p2;
  const Real minus_f5_y = 0.09132825 * (w5_x * w5_x + n5_x_p3);

  // link 5 (wrist_2), outward
  const Real n5_x_p6 = n5_x_p2 * w5_y - (s5 * n5_x_p4 - c5 * n5_x_p5);
  const Real minus_wd5_y = minus_wd5_y_p2 + minus_wd5_y_p1;

  // link 2 (upper_arm), inward
  const Real n1_z_p7 = qdd[1] * n1_z_p2 - a3_z_p1 * n1_z_p3 + 1.156008191975 * a3_y_p1 * c2 +
      wd3_z * n1_z_p5;

  // link 5 (wrist_2), outward
  const Real a5_x = c5 * (a4_x + 0.17415 * a5_x_p1) + s5 * (a4_z - 0.17415 * a3_x_p1);

  // link 6 (wrist_3), outward
  const Real wd6_z = qdd[5] - minus_wd5_y;

  // link 5 (wrist_2), inertial wrench
  const Real f5_z = 0.09132825 * n5_x_p6;

  // link 6 (wrist_3), inertial wrench
  const Real n6_y = 0.0003115 * (2.0 * (w5_x * w6_z) - n5_y_p2);
  const Real n6_x = 0.0003115 * (n5_x_p2 * w6_z - n5_x_p6);
  const Real n6_z = 0.000623 * wd6_z;
  tau[5] = n6_z;

  // link 5 (wrist_2), inward
  const Real f4_x_p1 = c5 * f5_x + s5 * minus_f5_y;
  const Real f4_y = 0.33495075 * (w4_x * w4_x + n4_x_p1) - f5_z;
  const Real f4_x = f4_x_p1 - 0.33495075 * n5_x_p4;

  // link 6 (wrist_3), inward
  const Real n5_z = 0.008210591037500001 * wd5_z - 0.005730591037500001 * n5_y_p1 +
      0.0106962107625 * minus_wd5_y_p2 - 0.09132825 * a5_x + n6_y;
  tau[4] = n5_z;
  const Real n5_x = 0.0069705910375000004 * n5_x_p6 + 0.0106962107625 * (n5_x_p3 - w5_y * w5_y) -
      0.09132825 * minus_a5_z - n6_x;
  const Real n5_y = 0.0106962107625 * n5_y_p2 - 0.00124 * (minus_wd5_y_p1 + minus_wd5_y) + n6_z;

  // link 4 (wrist_1), inward
  const Real n3_z_p1 = w4_y_p3 * f4_x - w4_x_p1 * f4_y;
  const Real n3_z_p2 = w4_x_p1 * f4_x + w4_y_p3 * f4_y;

  // link 5 (wrist_2), inward
  const Real n4_y = 0.17415 * f4_x_p1 - n5_z - (0.001315 * (wd4_y_p1 - wd4_y) + 0.0585962731125 *
      n5_x_p4);
  const Real f4_z = s5 * f5_x - c5 * minus_f5_y - 0.33495075 * n5_x_p5;

  // link 4 (wrist_1), inward
  const Real f3_x = a4_y_p4 * f3_x_p1 + wd3_z * f3_x_p2 + n3_z_p1;
  const Real f3_y = a4_y_p1 * f3_x_p2 - wd3_z * f3_x_p1 + n3_z_p2;

  // link 5 (wrist_2), inward
  const Real n4_z = 0.0397298163875 * wd4_z - 0.037099816387500005 * n5_x_p1 + 0.0585962731125 *
      a5_x_p1 + 0.33495075 * a4_x + (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

  // link 4 (wrist_1), inward
  const Real f3_z = qdd[0] * f3_x_p1 - a4_z_p2 * f3_x_p2 + f4_z;

  // link 3 (forearm), inertial wrench
  const Real n3_z_p3 = 2.08330527531 * wd3_z + qdd[0] * n1_z_p5 + a3_x_p1 * n1_z_p6 +
      (f3_x_p2 * a3_x - f3_x_p1 * a3_y);

  // link 5 (wrist_2), inward
  const Real n4_x = 0.0384148163875 * n5_x_p5 - 0.0585962731125 * (n4_x_p1 - w4_y * w4_y) -
      0.33495075 * a4_z + (c5 * n5_x - s5 * n5_y + 0.0159048147375 * n5_x_p6);

  // link 4 (wrist_1), inward
  const Real n3_z = n3_z_p3 + (n4_z + (a4_y_p2 * n3_z_p1 - a4_y_p3 * n3_z_p2));
  tau[2] = n3_z;

  // link 2 (upper_arm), inward
  const Real n1_z_p8 = n1_z_p7 - a4_z_p2 * n1_z_p6 + 0.5656542411875001 * a4_y_p1 * w4_y_p2 +
      f3_x_p1 * a3_z + w4_x_p1 * n4_x;

  // link 3 (forearm), inward
  const Real n2_z = 4.3866871861500005 * qdd[1] + qdd[0] * n1_z_p2 + a3_x_p1 * n1_z_p3 -
      81.98859064500002 * c2 + (n3_z + (a3_y_p2 * f3_x - a3_y_p3 * f3_y));
  tau[1] = n2_z;

  // link 2 (upper_arm), inward
  const Real n1_z = n1_z_p8 + w4_y_p3 * n4_y + a4_y_p3 * f4_z + a3_y_p3 * f3_z +
      (4.910283130787501 - s2 * n1_z_p1 + (2.08081027531 - w4_y_p1 * n1_z_p4)) * qdd[0];
  tau[0] = n1_z;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
