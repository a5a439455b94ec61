// nonlinear_effects: h = b + g: the joint forces at qdd = 0
// By recursive Newton-Euler, Chang table 4.1.
// 200 flops (add 76, mul 124, div 0), sine and cosine of 4 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void nonlinear_effects(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    Real (&TREELINE_RESTRICT h)[6]) noexcept {
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real c2 = cosines[0];
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];

  // link 3 (forearm), outward
  const Real w3_z = qd[1] + qd[2];

  // link 1 (shoulder), outward
  const Real a3_x_p1 = qd[0] * qd[0];

  // link 2 (upper_arm), outward
  const Real a3_x_p2 = qd[1] * qd[1];
  const Real a3_y_p1 = 0.6127 * s2;
  const Real a3_x_p3 = 0.6127 * c2;
  const Real minus_a4_z_p1 = 2.0 * qd[0];
  const Real w5_x_p1 = s2 * c3 + c2 * s3;
  const Real w5_x_p2 = c2 * c3 - s2 * s3;

  // link 4 (wrist_1), outward
  const Real w4_z = w3_z + qd[3];

  // link 3 (forearm), outward
  const Real a4_x_p1 = w3_z * w3_z;
  const Real minus_a4_z_p2 = minus_a4_z_p1 * w3_z;

  // link 2 (upper_arm), outward
  const Real minus_a3_z_p1 = minus_a4_z_p1 * qd[1];
  const Real n2_y_p1 = c2 * (4.36318718615 * s2);
  const Real a4_x_p2 = 0.57155 * w5_x_p2;
  const Real a4_y_p1 = 0.57155 * w5_x_p1;

  // link 3 (forearm), outward
  const Real a4_x_p3 = a3_x_p1 + a4_x_p1;

  // link 4 (wrist_1), outward
  const Real wd4_x = qd[0] * w4_z;

  // link 3 (forearm), outward
  const Real a3_x = (a3_x_p1 + a3_x_p2) * a3_x_p3;
  const Real a3_y = 9.81 + a3_x_p2 * a3_y_p1;
  const Real minus_a3_z = minus_a3_z_p1 * a3_y_p1;
  const Real w5_x_p3 = w5_x_p1 * c4 + w5_x_p2 * s4;
  const Real w5_z_p1 = w5_x_p2 * c4 - w5_x_p1 * s4;

  // link 4 (wrist_1), outward
  const Real f4_x_p1 = w4_z * w4_z;
  const Real n2_y_p2 = 4.0059802 * w5_x_p2;
  const Real f4_z_p1 = 2.0 * wd4_x;
  const Real f3_y_p1 = 4.0059802 * w5_x_p1;

  // link 5 (wrist_2), outward
  const Real w5_x_p4 = w5_x_p3 * qd[0];
  const Real wd5_z = w5_x_p3 * wd4_x;
  const Real minus_wd5_y_p1 = w5_z_p1 * wd4_x;
  const Real n2_y_p3 = w5_x_p2 * (2.07831527531 * w5_x_p1);

  // link 4 (wrist_1), outward
  const Real a4_x = a3_x + a4_x_p3 * a4_x_p2;
  const Real a4_y = a3_y + a4_x_p1 * a4_y_p1;
  const Real minus_a4_z = minus_a3_z + minus_a4_z_p2 * a4_y_p1;
  const Real f4_x_p2 = 0.33495075 * w5_x_p3;
  const Real f4_y_p1 = 0.33495075 * w5_z_p1;

  // link 5 (wrist_2), outward
  const Real w5_z = qd[4] - w5_z_p1 * qd[0];
  const Real minus_f5_y_p1 = w5_z * w5_z;
  const Real n2_y_p4 = w5_z_p1 * (0.037099816387500005 * w5_x_p3);
  const Real w5_x = c5 * w5_x_p4 + s5 * w4_z;
  const Real w5_y = c5 * w4_z - s5 * w5_x_p4;
  const Real minus_a5_z = w5_z_p1 * a4_y - w5_x_p3 * a4_x;

  // link 3 (forearm), inward
  const Real n2_y_p5 = 1.156008191975 * a3_x_p2 * c2 - minus_a3_z_p1 * n2_y_p1 +
      0.5656542411875001 * a4_x_p1 * w5_x_p2 - minus_a4_z_p2 * n2_y_p3;

  // link 5 (wrist_2), outward
  const Real f5_x_p1 = w5_x * w5_y;

  // link 6 (wrist_3), outward
  const Real w6_z = w5_y + qd[5];

  // link 5 (wrist_2), outward
  const Real n5_z_p1 = w5_x * w5_z;

  // link 6 (wrist_3), outward
  const Real n6_x_p1 = 2.0 * w6_z;

  // link 5 (wrist_2), outward
  const Real f5_x_p2 = f5_x_p1 - wd5_z;
  const Real minus_wd5_y = s5 * minus_wd5_y_p1 + w5_x * qd[4];
  const Real n5_x_p1 = c5 * minus_wd5_y_p1 + (w5_z + qd[4]) * w5_y;
  const Real a5_x = c5 * (w5_z_p1 * a4_x + w5_x_p3 * a4_y) - s5 * (minus_a4_z + 0.17415 * a3_x_p1);

  // link 5 (wrist_2), inertial wrench
  const Real minus_f5_y = 0.09132825 * (w5_x * w5_x + minus_f5_y_p1);
  const Real f5_x = 0.09132825 * f5_x_p2;
  const Real f5_z = 0.09132825 * n5_x_p1;

  // link 6 (wrist_3), inertial wrench
  const Real minus_n6_z = 0.000623 * minus_wd5_y;
  h[5] = -minus_n6_z;
  const Real n6_x = 0.0003115 * (n6_x_p1 * w5_z - n5_x_p1);

  // link 5 (wrist_2), inward
  const Real f4_x_p3 = c5 * f5_x + s5 * minus_f5_y;

  // link 6 (wrist_3), inertial wrench
  const Real n6_y = 0.0003115 * (n6_x_p1 * w5_x - f5_x_p2);

  // link 5 (wrist_2), inertial wrench
  const Real n5_z_p2 = 0.008210591037500001 * wd5_z - 0.005730591037500001 * f5_x_p1 -
      0.0106962107625 * (n5_z_p1 - minus_wd5_y) - 0.09132825 * a5_x;

  // link 6 (wrist_3), inward
  const Real n5_x = 0.0069705910375000004 * n5_x_p1 + 0.0106962107625 *
      (minus_f5_y_p1 - w5_y * w5_y) - 0.09132825 * minus_a5_z - n6_x;
  const Real n5_y = 0.0106962107625 * f5_x_p2 - 0.00124 * (n5_z_p1 + minus_wd5_y) - minus_n6_z;

  // link 5 (wrist_2), inward
  const Real f4_z = s5 * f5_x - c5 * minus_f5_y - f4_z_p1 * f4_y_p1;

  // link 6 (wrist_3), inward
  const Real n5_z = n5_z_p2 + n6_y;
  h[4] = n5_z;

  // link 5 (wrist_2), inward
  const Real f4_x_p4 = w5_z_p1 * f4_x_p3 + w5_x_p3 * f5_z;

  // link 4 (wrist_1), inward
  const Real f3_z = f4_z - minus_a4_z_p2 * f3_y_p1;

  // link 5 (wrist_2), inward
  const Real f4_x = f4_x_p4 - (a3_x_p1 + f4_x_p1) * f4_x_p2;
  const Real f4_y = f4_x_p1 * f4_y_p1 + (w5_x_p3 * f4_x_p3 - w5_z_p1 * f5_z);

  // link 3 (forearm), inward
  const Real n2_y_p6 = n2_y_p5 - n2_y_p2 * minus_a3_z + f4_z_p1 * n2_y_p4 + f4_x_p2 * minus_a4_z -
      w5_z_p1 * n5_z;

  // link 4 (wrist_1), inward
  const Real f3_x = a4_x_p3 * n2_y_p2 + f4_x;
  const Real f3_y = a4_x_p1 * f3_y_p1 + f4_y;

  // link 5 (wrist_2), inward
  const Real n4_z = f4_x_p2 * a4_y + f4_y_p1 * a4_x - a3_x_p1 * n2_y_p4 + (s5 * n5_x + c5 * n5_y);
  h[3] = n4_z;

  // link 4 (wrist_1), inward
  const Real n3_z = a3_x_p1 * n2_y_p3 + (f3_y_p1 * a3_x - n2_y_p2 * a3_y) +
      (n4_z + (a4_y_p1 * f4_x - a4_x_p2 * f4_y));
  h[2] = n3_z;

  // link 3 (forearm), inward
  const Real n2_y = n2_y_p6 + 0.17415 * f4_x_p4 + a4_x_p2 * f4_z + a3_x_p3 * f3_z +
      (c5 * n5_x - s5 * n5_y - 0.0585962731125 * f4_x_p1) * w5_x_p3;
  h[0] = n2_y;
  const Real n2_z = a3_x_p1 * n2_y_p1 - 81.98859064500002 * c2 +
      (n3_z + (a3_y_p1 * f3_x - a3_x_p3 * f3_y));
  h[1] = n2_z;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
