// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1.
// 386 flops (add 173, mul 213, div 0), sine and cosine of 7 angles
// Generated; see samm.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void inverse_dynamics(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    const Real (&TREELINE_RESTRICT qdd)[9], Real (&TREELINE_RESTRICT tau)[9]) noexcept {
  const Real angles[7] = {q[2], q[3], q[4], q[5], q[6], q[7], q[8]};
  Real sines[7];
  Real cosines[7];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s5 = sines[2];
  const Real c5 = cosines[2];
  const Real s6 = sines[3];
  const Real c6 = cosines[3];
  const Real s7 = sines[4];
  const Real c8 = cosines[5];
  const Real c7 = cosines[4];
  const Real s8 = sines[5];
  const Real s4 = sines[1];
  const Real s3 = sines[0];
  const Real c9 = cosines[6];
  const Real s9 = sines[6];

  // link 4 (link1), outward
  const Real w4_z = qd[2] + qd[3];
  const Real wd4_z = qdd[2] + qdd[3];

  // link 6 (link3), outward
  const Real w6_z = qd[4] + qd[5];
  const Real wd6_z = qdd[4] + qdd[5];

  // link 5 (link2), outward
  const Real a6_x_p1 = qd[4] * qd[4];
  const Real minus_w5_x = s5 * w4_z;
  const Real minus_w5_y = c5 * w4_z;
  const Real wd5_y_p1 = c5 * wd4_z;
  const Real minus_wd5_x_p1 = s5 * wd4_z;

  // link 6 (link3), outward
  const Real a7_y_p1 = w6_z * w6_z;

  // link 5 (link2), outward
  const Real wd5_y_p2 = minus_w5_x * qd[4];
  const Real minus_wd5_x_p2 = minus_w5_y * qd[4];
  const Real a6_x_p2 = minus_w5_x * minus_w5_y;
  const Real a6_x_p3 = minus_w5_y * minus_w5_y;
  const Real a6_z_p1 = minus_w5_x * minus_w5_x;
  const Real wd5_y = wd5_y_p2 - wd5_y_p1;
  const Real minus_wd5_x = minus_wd5_x_p1 + minus_wd5_x_p2;

  // link 6 (link3), outward
  const Real w6_y = s6 * minus_w5_x - c6 * minus_w5_y;
  const Real minus_w6_x = c6 * minus_w5_x + s6 * minus_w5_y;

  // link 5 (link2), outward
  const Real a6_x_p4 = a6_x_p2 + qdd[4];

  // link 6 (link3), outward
  const Real a6_x_p5 = a6_x_p3 + a6_x_p1;

  // link 3 (base), outward
  const Real a3_y = c3 * qdd[1] - s3 * qdd[0];
  const Real a3_x = c3 * qdd[0] + s3 * qdd[1];

  // link 7 (link4), outward
  const Real w7_z = qd[6] - w6_y;

  // link 6 (link3), outward
  const Real a7_y_p2 = w6_y * w6_y;
  const Real a7_y_p3 = minus_w6_x * w6_y;
  const Real a7_y_p4 = minus_w6_x * w6_z;

  // link 5 (link2), outward
  const Real a6_z_p2 = wd5_y_p2 + wd5_y;

  // link 7 (link4), outward
  const Real w7_y = s7 * minus_w6_x + c7 * w6_z;
  const Real w7_x = s7 * w6_z - c7 * minus_w6_x;

  // link 6 (link3), outward
  const Real wd6_x = s6 * wd5_y - c6 * minus_wd5_x + w6_y * qd[5];

  // link 7 (link4), outward
  const Real a7_y_p5 = a7_y_p2 + a7_y_p1;

  // link 6 (link3), outward
  const Real wd6_y = s6 * minus_wd5_x + c6 * wd5_y + minus_w6_x * qd[5];

  // link 8 (link5), outward
  const Real w8_z = w7_y + qd[7];

  // link 4 (link1), outward
  const Real a4_x = c4 * a3_x + s4 * a3_y;

  // link 6 (link3), outward
  const Real a7_y_p6 = a7_y_p3 + wd6_z;
  const Real a7_y_p7 = w6_y * w6_z + wd6_x;

  // link 7 (link4), outward
  const Real wd7_z = qdd[6] - wd6_y;

  // link 6 (link3), outward
  const Real a7_y_p8 = a7_y_p4 + wd6_y;

  // link 8 (link5), outward
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real w8_x = c8 * w7_x - s8 * w7_z;

  // link 6 (link3), outward
  const Real minus_a7_z_p1 = minus_w6_x * minus_w6_x;

  // link 5 (link2), outward
  const Real a5_x = c5 * a4_x - 9.81 * s5;
  const Real minus_a5_y = s5 * a4_x + 9.81 * c5;

  // link 7 (link4), outward
  const Real wd7_x = c7 * wd6_x + s7 * wd6_z + w7_y * qd[6];
  const Real wd7_y = c7 * wd6_z - s7 * wd6_x - w7_x * qd[6];

  // link 9 (link6), outward
  const Real w9_z = minus_w8_y + qd[8];

  // link 4 (link1), outward
  const Real a4_y = c4 * a3_y - s4 * a3_x;

  // link 6 (link3), outward
  const Real minus_a7_z_p2 = wd6_z - a7_y_p3;
  const Real a6_x_p6 = a5_x - (0.4318 * a6_x_p5 + 0.1501 * wd5_y_p1);
  const Real a6_x_p7 = 0.4318 * a6_x_p4 + 0.1501 * minus_wd5_x_p1 - minus_a5_y;

  // link 7 (link4), outward
  const Real minus_a7_z_p3 = minus_a7_z_p1 + a7_y_p1;

  // link 8 (link5), outward
  const Real wd8_z = wd7_y + qdd[7];

  // link 9 (link6), outward
  const Real w9_y = c9 * w8_z - s9 * w8_x;
  const Real n9_x_p1 = w9_z + qd[8];
  const Real w9_x = c9 * w8_x + s9 * w8_z;

  // link 6 (link3), outward
  const Real a6_z = a4_y - (0.4318 * a6_z_p2 + 0.1501 * (a6_z_p1 + a6_x_p3));

  // link 7 (link4), outward
  const Real a7_y_p9 = a6_z + (0.0203 * a7_y_p8 - 0.4331 * a7_y_p7);

  // link 6 (link3), outward
  const Real a6_x = c6 * a6_x_p6 + s6 * a6_x_p7;

  // link 8 (link5), outward
  const Real f8_x_p1 = w8_x * minus_w8_y;
  const Real wd8_x = c8 * wd7_x - s8 * wd7_z - minus_w8_y * qd[7];

  // link 6 (link3), outward
  const Real a6_y = c6 * a6_x_p7 - s6 * a6_x_p6;

  // link 7 (link4), outward
  const Real a7_y_p10 = a6_x + (0.0203 * a7_y_p5 + 0.4331 * a7_y_p6);

  // link 8 (link5), outward
  const Real minus_wd8_y = s8 * wd7_x + c8 * wd7_z + w8_x * qd[7];
  const Real n8_x_p1 = wd8_x - minus_w8_y * w8_z;

  // link 7 (link4), outward
  const Real minus_a7_z = a6_y + (0.4331 * minus_a7_z_p3 - 0.0203 * minus_a7_z_p2);

  // link 9 (link6), outward
  const Real wd9_z = minus_wd8_y + qdd[8];

  // link 8 (link5), inertial wrench
  const Real f8_y = 0.0028799999999999997 * (w8_x * w8_x + w8_z * w8_z);
  const Real minus_f8_z = 0.0028799999999999997 * n8_x_p1;
  const Real f8_x = 0.0028799999999999997 * (f8_x_p1 + wd8_z);

  // link 7 (link4), outward
  const Real a7_y = c7 * a7_y_p9 - s7 * a7_y_p10;
  const Real a7_x = c7 * a7_y_p10 + s7 * a7_y_p9;

  // link 9 (link6), inertial wrench
  const Real n9_z = 4e-05 * wd9_z;
  tau[8] = n9_z;
  const Real n9_x = 2e-05 * (c9 * wd8_x + s9 * wd8_z + n9_x_p1 * w9_y);
  const Real minus_n9_y = 2e-05 * (n9_x_p1 * w9_x - (c9 * wd8_z - s9 * wd8_x));

  // link 9 (link6), inward
  const Real minus_n8_y = 2e-04 * (w8_x * w8_z + minus_wd8_y) + n9_z;

  // link 8 (link5), inward
  const Real minus_f7_x = s8 * f8_y - c8 * f8_x;
  const Real minus_f7_z = s8 * f8_x + c8 * f8_y;

  // link 8 (link5), outward
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;

  // link 7 (link4), inward
  const Real f6_y = 0.861795 * minus_a7_z_p3 - 0.025374999999999998 * minus_a7_z_p2 + minus_f7_z;

  // link 5 (link2), outward
  const Real f5_x_p1 = a6_x_p2 - qdd[4];

  // link 7 (link4), inward
  const Real f6_x_p1 = s7 * minus_f8_z - c7 * minus_f7_x;
  const Real n6_x_p1 = s7 * minus_f7_x + c7 * minus_f8_z;

  // link 9 (link6), inward
  const Real n8_x = 0.00042216 * n8_x_p1 - 0.0028799999999999997 * a7_y +
      (c9 * n9_x + s9 * minus_n9_y);

  // link 7 (link4), inward
  const Real f6_x = 0.025374999999999998 * a7_y_p5 + 0.861795 * a7_y_p6 + f6_x_p1;

  // link 9 (link6), inward
  const Real n8_z = 0.00022215999999999997 * f8_x_p1 + 0.00062216 * wd8_z + 0.0028799999999999997 *
      a8_x + (s9 * n9_x - c9 * minus_n9_y);
  tau[7] = n8_z;

  // link 5 (link2), outward
  const Real n5_x_p1 = minus_wd5_x_p2 + minus_wd5_x;

  // link 8 (link5), inward
  const Real n7_y = n8_z - 0.00065 * (w7_x * w7_z - wd7_y);

  // link 6 (link3), inertial wrench
  const Real n6_x_p2 = 0.3056901365 * a7_y_p7 - 0.010673638499999999 * a7_y_p8 -
      0.004704000000000001 * (a7_y_p1 - a7_y_p2) - 0.861795 * a6_z;

  // link 7 (link4), inward
  const Real f6_z = 0.025374999999999998 * a7_y_p8 - 0.861795 * a7_y_p7 - n6_x_p1;

  // link 6 (link3), inward
  const Real f5_y_p1 = s6 * f6_x + c6 * f6_y;
  const Real f5_x_p2 = c6 * f6_x - s6 * f6_y;

  // link 8 (link5), inward
  const Real n7_x = 0.0007499999999999999 * (w7_y * w7_z + wd7_x) + (c8 * n8_x + s8 * minus_n8_y);
  const Real n7_z = 0.0013999999999999998 * wd7_z - 9.999999999999994e-05 * (w7_x * w7_y) +
      (c8 * minus_n8_y - s8 * n8_x);
  tau[6] = n7_z;

  // link 6 (link3), inward
  const Real f5_y = 3.79559 * a6_x_p4 - 0.10439999999999999 * (a6_z_p1 + a6_x_p1) + f5_y_p1;
  const Real f5_x = 0.10439999999999999 * f5_x_p1 - 3.79559 * a6_x_p5 + f5_x_p2;
  const Real f5_z = f6_z - (3.79559 * a6_z_p2 + 0.10439999999999999 * n5_x_p1);

  // link 5 (link2), inertial wrench
  const Real n5_x_p2 = 0.023750999999999998 * (a6_x_p1 - a6_x_p3) -
      (0.07312640000000001 * n5_x_p1 + 0.0070992 * a6_z_p2 + 0.690314699 * a6_x_p4);

  // link 7 (link4), inward
  const Real n6_y = 0.0067651125 * a7_y_p8 + 0.004704000000000001 * a7_y_p6 - 0.010673638499999999 *
      a7_y_p7 + 0.025374999999999998 * a6_z - (n7_z + 0.0203 * n6_x_p1);

  // link 5 (link2), inertial wrench
  const Real n5_y_p1 = 1.674987602 * a6_z_p2 + 0.023750999999999998 * f5_x_p1 + 0.0070992 *
      n5_x_p1 + 0.690314699 * (a6_z_p1 - a6_x_p1);

  // link 5 (link2), inward
  const Real f4_y = f5_z - 4.9338049999999996 * (w4_z * w4_z);
  const Real minus_f4_x = 4.9338049999999996 * wd4_z + (s5 * f5_y - c5 * f5_x);

  // link 7 (link4), inward
  const Real n6_x = n6_x_p2 + (c7 * n7_x - s7 * n7_y + 0.4331 * n6_x_p1);

  // link 6 (link3), inertial wrench
  const Real n6_z_p1 = 0.298925024 * a7_y_p3 + 0.312455249 * wd6_z + 0.004704000000000001 *
      (wd6_y - a7_y_p4) + 0.010673638499999999 * (a7_y_p2 - minus_a7_z_p1);

  // link 4 (link1), inward
  const Real minus_f3_x = c4 * minus_f4_x + s4 * f4_y;
  const Real f3_y = c4 * f4_y - s4 * minus_f4_x;

  // link 7 (link4), inward
  const Real n6_z = n6_z_p1 + (0.861795 * a6_x - 0.025374999999999998 * a6_y) +
      (s7 * n7_x + c7 * n7_y + (0.4331 * f6_x_p1 - 0.0203 * minus_f7_z));
  tau[5] = n6_z;

  // link 5 (link2), inertial wrench
  const Real n5_z_p1 = 1.601861202 * a6_x_p2 + 1.7481140020000001 * qdd[4] + 0.690314699 *
      minus_wd5_x_p1 + 0.023750999999999998 * wd5_y_p1 + 0.0070992 * (a6_x_p3 - a6_z_p1);

  // link 6 (link3), inward
  const Real n5_x = n5_x_p2 + 0.10439999999999999 * a4_y +
      (c6 * n6_x - s6 * n6_y - 0.1501 * f5_y_p1);
  const Real n5_y = n5_y_p1 - 3.79559 * a4_y + (s6 * n6_x + c6 * n6_y +
      (0.1501 * f5_x_p2 - 0.4318 * f6_z));

  // link 3 (base), inward
  const Real f2_x = 186.45 * qdd[0] - (c3 * minus_f3_x + s3 * f3_y);
  tau[0] = f2_x;
  const Real f2_z = 186.45 * qdd[1] + (c3 * f3_y - s3 * minus_f3_x);
  tau[1] = f2_z;

  // link 6 (link3), inward
  const Real n5_z = n5_z_p1 - (3.79559 * minus_a5_y + 0.10439999999999999 * a5_x) +
      (n6_z + 0.4318 * f5_y_p1);
  tau[4] = n5_z;

  // link 5 (link2), inward
  const Real n4_z = 1.4717295504999999 * wd4_z - 4.9338049999999996 * a4_x -
      (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

  // link 4 (link1), inward
  const Real n3_z = 7.2 * qdd[2] + n4_z;
  tau[2] = n3_z;
}

}  // namespace samm

#undef TREELINE_RESTRICT
