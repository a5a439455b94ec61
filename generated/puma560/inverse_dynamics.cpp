// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1.
// 322 flops (add 144, mul 178, div 0), sine and cosine of 5 angles
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

  // link 2 (link2), outward
  const Real minus_w2_x = s2 * qd[0];
  const Real minus_w2_y = c2 * qd[0];
  const Real a3_x_p1 = c2 * qdd[0];
  const Real a3_x_p2 = s2 * qdd[0];

  // link 3 (link3), outward
  const Real w3_z = qd[1] + qd[2];
  const Real wd3_z = qdd[1] + qdd[2];

  // link 2 (link2), outward
  const Real a3_x_p3 = qd[1] * qd[1];
  const Real minus_a2_y = 9.81 * c2;
  const Real minus_a2_x = 9.81 * s2;
  const Real wd2_y_p1 = minus_w2_x * qd[1];
  const Real minus_wd2_x_p1 = minus_w2_y * qd[1];
  const Real a3_x_p4 = minus_w2_y * minus_w2_y;
  const Real a3_x_p5 = minus_w2_x * minus_w2_y;
  const Real minus_a3_z_p1 = minus_w2_x * minus_w2_x;

  // link 3 (link3), outward
  const Real a4_y_p1 = w3_z * w3_z;

  // link 2 (link2), outward
  const Real wd2_y = wd2_y_p1 - a3_x_p1;
  const Real minus_wd2_x = a3_x_p2 + minus_wd2_x_p1;

  // link 3 (link3), outward
  const Real w3_y = s3 * minus_w2_x - c3 * minus_w2_y;
  const Real minus_w3_x = c3 * minus_w2_x + s3 * minus_w2_y;

  // link 2 (link2), outward
  const Real a3_x_p6 = a3_x_p5 + qdd[1];

  // link 4 (link4), outward
  const Real w4_z = qd[3] - w3_y;

  // link 3 (link3), outward
  const Real a4_y_p2 = minus_w3_x * w3_z;
  const Real a4_y_p3 = w3_y * w3_y;
  const Real a4_y_p4 = minus_w3_x * w3_y;

  // link 2 (link2), outward
  const Real minus_a3_z_p2 = wd2_y_p1 + wd2_y;

  // link 3 (link3), outward
  const Real minus_a4_z_p1 = minus_w3_x * minus_w3_x;

  // link 4 (link4), outward
  const Real w4_y = s4 * minus_w3_x + c4 * w3_z;
  const Real w4_x = s4 * w3_z - c4 * minus_w3_x;

  // link 3 (link3), outward
  const Real wd3_x = s3 * wd2_y - c3 * minus_wd2_x + w3_y * qd[2];

  // link 4 (link4), outward
  const Real a4_y_p5 = a4_y_p3 + a4_y_p1;

  // link 3 (link3), outward
  const Real a4_y_p6 = a4_y_p4 + wd3_z;
  const Real wd3_y = s3 * minus_wd2_x + c3 * wd2_y + minus_w3_x * qd[2];

  // link 5 (link5), outward
  const Real w5_z = w4_y + qd[4];

  // link 3 (link3), outward
  const Real a3_x_p7 = 0.4318 * a3_x_p6 + 0.1501 * a3_x_p2 - minus_a2_y;
  const Real a3_x_p8 = minus_a2_x + (0.4318 * (a3_x_p4 + a3_x_p3) + 0.1501 * a3_x_p1);
  const Real a4_y_p7 = w3_y * w3_z + wd3_x;

  // link 4 (link4), outward
  const Real wd4_z = qdd[3] - wd3_y;

  // link 3 (link3), outward
  const Real a4_y_p8 = a4_y_p2 + wd3_y;
  const Real minus_a3_z = 0.4318 * minus_a3_z_p2 + 0.1501 * (minus_a3_z_p1 + a3_x_p4);

  // link 5 (link5), outward
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;
  const Real w5_x = c5 * w4_x - s5 * w4_z;

  // link 4 (link4), outward
  const Real minus_a4_z_p2 = minus_a4_z_p1 + a4_y_p1;

  // link 6 (link6), outward
  const Real w6_z = minus_w5_y + qd[5];

  // link 3 (link3), outward
  const Real minus_a4_z_p3 = wd3_z - a4_y_p4;

  // link 4 (link4), outward
  const Real wd4_x = c4 * wd3_x + s4 * wd3_z + w4_y * qd[3];
  const Real wd4_y = c4 * wd3_z - s4 * wd3_x - w4_x * qd[3];

  // link 3 (link3), outward
  const Real a3_x = s3 * a3_x_p7 - c3 * a3_x_p8;

  // link 6 (link6), outward
  const Real n6_x_p1 = w6_z + qd[5];
  const Real w6_y = c6 * w5_z - s6 * w5_x;
  const Real w6_x = c6 * w5_x + s6 * w5_z;

  // link 5 (link5), outward
  const Real wd5_z = wd4_y + qdd[4];

  // link 4 (link4), outward
  const Real a4_y_p9 = a3_x + (0.0203 * a4_y_p5 + 0.4331 * a4_y_p6);
  const Real a4_y_p10 = 0.0203 * a4_y_p8 - 0.4331 * a4_y_p7 - minus_a3_z;

  // link 5 (link5), outward
  const Real f5_x_p1 = w5_x * minus_w5_y;

  // link 3 (link3), outward
  const Real a3_y = s3 * a3_x_p8 + c3 * a3_x_p7;

  // link 5 (link5), outward
  const Real wd5_x = c5 * wd4_x - s5 * wd4_z - minus_w5_y * qd[4];
  const Real minus_wd5_y = s5 * wd4_x + c5 * wd4_z + w5_x * qd[4];

  // link 4 (link4), outward
  const Real a4_y = c4 * a4_y_p10 - s4 * a4_y_p9;
  const Real a4_x = c4 * a4_y_p9 + s4 * a4_y_p10;
  const Real minus_a4_z = a3_y + (0.4331 * minus_a4_z_p2 - 0.0203 * minus_a4_z_p3);

  // link 5 (link5), inertial wrench
  const Real f5_x = 0.0028799999999999997 * (f5_x_p1 + wd5_z);
  const Real f5_y = 0.0028799999999999997 * (w5_x * w5_x + w5_z * w5_z);

  // link 5 (link5), outward
  const Real n5_x_p1 = wd5_x - minus_w5_y * w5_z;

  // link 6 (link6), outward
  const Real wd6_z = minus_wd5_y + qdd[5];

  // link 5 (link5), inertial wrench
  const Real minus_f5_z = 0.0028799999999999997 * n5_x_p1;

  // link 6 (link6), inertial wrench
  const Real n6_z = 4e-05 * wd6_z;
  tau[5] = n6_z;

  // link 5 (link5), outward
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;

  // link 5 (link5), inward
  const Real minus_f4_x = s5 * f5_y - c5 * f5_x;

  // link 6 (link6), inward
  const Real minus_n5_y = 2e-04 * (w5_x * w5_z + minus_wd5_y) + n6_z;

  // link 6 (link6), inertial wrench
  const Real n6_x = 2e-05 * (c6 * wd5_x + s6 * wd5_z + n6_x_p1 * w6_y);
  const Real minus_n6_y = 2e-05 * (n6_x_p1 * w6_x - (c6 * wd5_z - s6 * wd5_x));

  // link 5 (link5), inward
  const Real minus_f4_z = s5 * f5_x + c5 * f5_y;

  // link 4 (link4), inward
  const Real n3_x_p1 = s4 * minus_f4_x + c4 * minus_f5_z;
  const Real f3_x_p1 = s4 * minus_f5_z - c4 * minus_f4_x;
  const Real f3_y = 0.861795 * minus_a4_z_p2 - 0.025374999999999998 * minus_a4_z_p3 + minus_f4_z;

  // link 2 (link2), outward
  const Real n2_x_p1 = minus_wd2_x_p1 + minus_wd2_x;

  // link 4 (link4), inward
  const Real f3_x = 0.025374999999999998 * a4_y_p5 + 0.861795 * a4_y_p6 + f3_x_p1;

  // link 3 (link3), inertial wrench
  const Real n3_x_p2 = 0.3056901365 * a4_y_p7 - 0.010673638499999999 * a4_y_p8 -
      0.004704000000000001 * (a4_y_p1 - a4_y_p3) + 0.861795 * minus_a3_z;

  // link 6 (link6), inward
  const Real n5_x = 0.00042216 * n5_x_p1 - 0.0028799999999999997 * a4_y +
      (c6 * n6_x + s6 * minus_n6_y);
  const Real n5_z = 0.00022215999999999997 * f5_x_p1 + 0.00062216 * wd5_z + 0.0028799999999999997 *
      a5_x + (s6 * n6_x - c6 * minus_n6_y);
  tau[4] = n5_z;

  // link 4 (link4), inward
  const Real f3_z = 0.025374999999999998 * a4_y_p8 - 0.861795 * a4_y_p7 - n3_x_p1;

  // link 5 (link5), inward
  const Real n4_y = n5_z - 0.00065 * (w4_x * w4_z - wd4_y);

  // link 3 (link3), inward
  const Real n2_x_p2 = s3 * f3_x + c3 * f3_y;

  // link 5 (link5), inward
  const Real n4_x = 0.0007499999999999999 * (w4_y * w4_z + wd4_x) + (c5 * n5_x + s5 * minus_n5_y);
  const Real n4_z = 0.0013999999999999998 * wd4_z - 9.999999999999994e-05 * (w4_x * w4_y) +
      (c5 * minus_n5_y - s5 * n5_x);
  tau[3] = n4_z;

  // link 2 (link2), inertial wrench
  const Real n2_x_p3 = 0.023750999999999998 * (a3_x_p3 - a3_x_p4) -
      (0.07312640000000001 * n2_x_p1 + 0.0070992 * minus_a3_z_p2 + 0.690314699 * a3_x_p6);
  const Real n2_y_p1 = 1.674987602 * minus_a3_z_p2 + 0.023750999999999998 * (a3_x_p5 - qdd[1]) +
      0.0070992 * n2_x_p1 + 0.690314699 * (minus_a3_z_p1 - a3_x_p3);

  // link 3 (link3), inertial wrench
  const Real n3_z_p1 = 0.298925024 * a4_y_p4 + 0.312455249 * wd3_z + 0.004704000000000001 *
      (wd3_y - a4_y_p2) + 0.010673638499999999 * (a4_y_p3 - minus_a4_z_p1);

  // link 4 (link4), inward
  const Real n3_y = 0.0067651125 * a4_y_p8 + 0.004704000000000001 * a4_y_p6 - 0.010673638499999999 *
      a4_y_p7 - 0.025374999999999998 * minus_a3_z - (n4_z + 0.0203 * n3_x_p1);

  // link 2 (link2), inertial wrench
  const Real n2_z_p1 = 1.601861202 * a3_x_p5 + 1.7481140020000001 * qdd[1] + 0.690314699 * a3_x_p2 +
      0.023750999999999998 * a3_x_p1 + 0.0070992 * (a3_x_p4 - minus_a3_z_p1);

  // link 4 (link4), inward
  const Real n3_x = n3_x_p2 + (c4 * n4_x - s4 * n4_y + 0.4331 * n3_x_p1);
  const Real n3_z = n3_z_p1 + (0.861795 * a3_x - 0.025374999999999998 * a3_y) +
      (s4 * n4_x + c4 * n4_y + (0.4331 * f3_x_p1 - 0.0203 * minus_f4_z));
  tau[2] = n3_z;

  // link 3 (link3), inward
  const Real n2_z = n2_z_p1 + (1.024164 * s2 - 37.2347379 * c2) + (n3_z + 0.4318 * n2_x_p2);
  tau[1] = n2_z;
  const Real n2_y_p2 = s3 * n3_x + c3 * n3_y + (0.1501 * (c3 * f3_x - s3 * f3_y) - 0.4318 * f3_z);
  const Real n2_x = n2_x_p3 + (c3 * n3_x - s3 * n3_y - 0.1501 * n2_x_p2);
  const Real n2_y = n2_y_p1 + n2_y_p2;

  // link 2 (link2), inward
  const Real n1_z = 1.4717295504999999 * qdd[0] - (s2 * n2_x + c2 * n2_y);
  tau[0] = n1_z;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
