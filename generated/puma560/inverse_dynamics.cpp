// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1.
// 277 flops (add 119, mul 158, div 0), sine and cosine of 4 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void inverse_dynamics(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT qdd)[6], Real (&TREELINE_RESTRICT tau)[6]) noexcept {
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real c3 = cosines[1];
  const Real s4 = sines[2];
  const Real c4 = cosines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];

  // link 3 (link3), outward
  const Real w3_z = qd[1] + qd[2];

  // link 1 (link1), outward
  const Real a3_x_p1 = qd[0] * qd[0];

  // link 2 (link2), outward
  const Real a3_x_p2 = qd[1] * qd[1];
  const Real a3_x_p3 = 0.4318 * c2;
  const Real a3_x_p4 = 0.4318 * s2;
  const Real wd2_x = qd[0] * qd[1];

  // link 3 (link3), outward
  const Real wd3_z = qdd[1] + qdd[2];
  const Real w3_y_p1 = s2 * s3 - c2 * c3;
  const Real minus_w3_x_p1 = s2 * c3 + c2 * s3;
  const Real a4_y_p1 = w3_z * w3_z;

  // link 2 (link2), outward
  const Real a3_z_p1 = 2.0 * wd2_x;

  // link 3 (link3), outward
  const Real w3_y = w3_y_p1 * qd[0];
  const Real minus_w3_x = minus_w3_x_p1 * qd[0];
  const Real wd3_y_p1 = w3_y_p1 * qdd[0];
  const Real wd3_y_p2 = minus_w3_x * w3_z;
  const Real wd5_y_p1 = minus_w3_x * w3_y;

  // link 4 (link4), outward
  const Real w4_z = qd[3] - w3_y;

  // link 3 (link3), outward
  const Real a4_y_p2 = w3_y * w3_y;
  const Real a3_x_p5 = 9.81 + (a3_x_p2 * a3_x_p4 - qdd[1] * a3_x_p3);
  const Real minus_a4_z_p1 = minus_w3_x * minus_w3_x;
  const Real n1_z_p1 = 1.601861202 * s2 + 0.0141984 * c2;
  const Real n1_z_p2 = 0.690314699 * s2 + 0.023750999999999998 * c2;

  // link 4 (link4), outward
  const Real w4_y = s4 * minus_w3_x + c4 * w3_z;

  // link 3 (link3), outward
  const Real wd3_y = wd3_y_p1 + wd3_y_p2;
  const Real wd5_y_p2 = wd5_y_p1 + wd3_z;

  // link 4 (link4), outward
  const Real w4_x = s4 * w3_z - c4 * minus_w3_x;

  // link 3 (link3), outward
  const Real a3_x_p6 = (a3_x_p1 + a3_x_p2) * a3_x_p3 + qdd[1] * a3_x_p4 + 0.1501 * qdd[0];
  const Real a4_y_p3 = a4_y_p2 + a4_y_p1;
  const Real a3_z = qdd[0] * a3_x_p3 - a3_z_p1 * a3_x_p4 - 0.1501 * a3_x_p1;
  const Real minus_a4_z_p2 = minus_a4_z_p1 + a4_y_p1;
  const Real a4_y_p4 = wd3_y_p2 + wd3_y;
  const Real wd5_y_p3 = 2.0 * (w3_y * w3_z) - minus_w3_x_p1 * qdd[0];

  // link 4 (link4), outward
  const Real wd5_y_p4 = w4_x * w4_y;
  const Real wd4_z = qdd[3] - wd3_y;

  // link 5 (link5), outward
  const Real w5_z = w4_y + qd[4];

  // link 3 (link3), outward
  const Real minus_a4_z_p3 = wd3_z - wd5_y_p1;

  // link 4 (link4), outward
  const Real wd4_y_p1 = w4_x * w4_z;
  const Real wd5_y_p5 = wd5_y_p4 - wd4_z;

  // link 3 (link3), outward
  const Real a3_x = w3_y_p1 * a3_x_p6 - minus_w3_x_p1 * a3_x_p5;

  // link 5 (link5), outward
  const Real n5_x_p1 = 2.0 * w5_z;
  const Real w5_x = c5 * w4_x - s5 * w4_z;
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;

  // link 4 (link4), outward
  const Real a4_y_p5 = a3_x + (0.0203 * a4_y_p3 + 0.4331 * wd5_y_p2);

  // link 5 (link5), outward
  const Real wd5_y_p6 = w5_x * w5_z;

  // link 6 (link6), outward
  const Real w6_z = minus_w5_y + qd[5];

  // link 3 (link3), outward
  const Real a3_y = minus_w3_x_p1 * a3_x_p6 + w3_y_p1 * a3_x_p5;

  // link 5 (link5), outward
  const Real n5_z_p1 = w5_x * minus_w5_y;

  // link 4 (link4), outward
  const Real wd5_y_p7 = s4 * wd5_y_p2 + c4 * wd5_y_p3 + 2.0 * (w4_y * w4_z);
  const Real a4_y_p6 = a3_z + (0.0203 * a4_y_p4 - 0.4331 * wd5_y_p3);
  const Real wd4_y = c4 * wd5_y_p2 - s4 * wd5_y_p3 - wd4_y_p1;

  // link 5 (link5), outward
  const Real wd5_z = wd4_y + qdd[4];

  // link 4 (link4), outward
  const Real minus_a4_z = a3_y + (0.4331 * minus_a4_z_p2 - 0.0203 * minus_a4_z_p3);
  const Real a4_y = c4 * a4_y_p6 - s4 * a4_y_p5;
  const Real a4_x = c4 * a4_y_p5 + s4 * a4_y_p6;

  // link 5 (link5), outward
  const Real f5_x_p1 = n5_z_p1 + wd5_z;

  // link 5 (link5), inertial wrench
  const Real f5_y = 0.0028799999999999997 * (w5_x * w5_x + w5_z * w5_z);

  // link 5 (link5), outward
  const Real wd5_y = c5 * wd5_y_p5 - s5 * wd5_y_p7 - wd5_y_p6;
  const Real n5_x_p2 = s5 * wd5_y_p5 + c5 * wd5_y_p7 - n5_x_p1 * minus_w5_y;

  // link 5 (link5), inertial wrench
  const Real f5_x = 0.0028799999999999997 * f5_x_p1;

  // link 6 (link6), outward
  const Real wd6_z = qdd[5] - wd5_y;

  // link 5 (link5), outward
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;

  // link 5 (link5), inertial wrench
  const Real minus_f5_z = 0.0028799999999999997 * n5_x_p2;

  // link 6 (link6), inertial wrench
  const Real minus_n6_y = 2e-05 * (2.0 * (w5_x * w6_z) - f5_x_p1);
  const Real n1_z_p3 = c2 * n1_z_p1 - 0.0070992;
  const Real n6_z = 4e-05 * wd6_z;
  tau[5] = n6_z;
  const Real n6_x = 2e-05 * (n5_x_p2 + n5_x_p1 * w6_z);

  // link 5 (link5), inward
  const Real minus_f4_x = s5 * f5_y - c5 * f5_x;
  const Real minus_f4_z = s5 * f5_x + c5 * f5_y;

  // link 6 (link6), inward
  const Real minus_n5_y = 2e-04 * (wd5_y_p6 - wd5_y) + n6_z;
  const Real n5_x = 0.00042216 * n5_x_p2 - 0.0028799999999999997 * a4_y + n6_x;

  // link 4 (link4), inward
  const Real f3_y = 0.861795 * minus_a4_z_p2 - 0.025374999999999998 * minus_a4_z_p3 + minus_f4_z;

  // link 6 (link6), inward
  const Real n5_z = 0.00022215999999999997 * n5_z_p1 + 0.00062216 * wd5_z + 0.0028799999999999997 *
      a5_x - minus_n6_y;
  tau[4] = n5_z;

  // link 3 (link3), inertial wrench
  const Real n3_x_p1 = 0.3056901365 * wd5_y_p3 - 0.010673638499999999 * a4_y_p4 -
      0.004704000000000001 * (a4_y_p1 - a4_y_p2) - 0.861795 * a3_z;

  // link 4 (link4), inward
  const Real n3_y_p1 = s4 * minus_f4_x + c4 * minus_f5_z;
  const Real f3_x_p1 = s4 * minus_f5_z - c4 * minus_f4_x;

  // link 5 (link5), inward
  const Real n4_y = n5_z - 0.00065 * (wd4_y_p1 - wd4_y);

  // link 2 (link2), inward
  const Real n1_z_p4 = qdd[1] * n1_z_p2 - a3_z_p1 * n1_z_p3 - a3_x_p2 *
      (0.023750999999999998 * s2 - 0.690314699 * c2);

  // link 4 (link4), inward
  const Real f3_x = 0.025374999999999998 * a4_y_p3 + 0.861795 * wd5_y_p2 + f3_x_p1;

  // link 5 (link5), inward
  const Real n4_x = 0.0007499999999999999 * wd5_y_p7 + (c5 * n5_x + s5 * minus_n5_y);
  const Real n4_z = 0.0014 * wd4_z - 9.999999999999994e-05 * wd5_y_p4 +
      (c5 * minus_n5_y - s5 * n5_x);
  tau[3] = n4_z;

  // link 3 (link3), inertial wrench
  const Real n3_z_p1 = 0.298925024 * wd5_y_p1 + 0.312455249 * wd3_z + 0.004704000000000001 *
      wd3_y_p1 + 0.010673638499999999 * (a4_y_p2 - minus_a4_z_p1);

  // link 4 (link4), inward
  const Real f3_z = 0.025374999999999998 * a4_y_p4 - 0.861795 * wd5_y_p3 - n3_y_p1;
  const Real n3_y = 0.0067651125 * a4_y_p4 + 0.004704000000000001 * wd5_y_p2 -
      0.010673638499999999 * wd5_y_p3 + 0.025374999999999998 * a3_z - (n4_z + 0.0203 * n3_y_p1);

  // link 3 (link3), inward
  const Real n1_z_p5 = w3_y_p1 * f3_x + minus_w3_x_p1 * f3_y;

  // link 2 (link2), inertial wrench
  const Real n2_z_p1 = 1.7481140020000001 * qdd[1] + qdd[0] * n1_z_p2 + a3_x_p1 * n1_z_p3 + 9.81 *
      (0.10439999999999999 * s2 - 3.79559 * c2);

  // link 4 (link4), inward
  const Real n3_x = n3_x_p1 + (c4 * n4_x - s4 * n4_y + 0.4331 * n3_y_p1);
  const Real n3_z = n3_z_p1 + (0.861795 * a3_x - 0.025374999999999998 * a3_y) +
      (s4 * n4_x + c4 * n4_y + (0.4331 * f3_x_p1 - 0.0203 * minus_f4_z));
  tau[2] = n3_z;

  // link 3 (link3), inward
  const Real n2_z = n2_z_p1 + (n3_z + (a3_x_p4 * n1_z_p5 - a3_x_p3 *
      (w3_y_p1 * f3_y - minus_w3_x_p1 * f3_x)));
  tau[1] = n2_z;

  // link 2 (link2), inward
  const Real n1_z_p6 = n1_z_p4 + w3_y_p1 * n3_y - minus_w3_x_p1 * n3_x + 0.1501 * n1_z_p5 +
      a3_x_p3 * f3_z;
  const Real n1_z = n1_z_p6 + (3.1467171525 - s2 * n1_z_p1) * qdd[0];
  tau[0] = n1_z;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
