// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1.
// 326 flops (add 142, mul 184, div 0), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
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
  const Real angles[6] = {q[2], q[3], q[4], q[5], q[6], q[7]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s3 = sines[0];
  const Real s4 = sines[1];
  const Real s5 = sines[2];
  const Real c5 = cosines[2];
  const Real s6 = sines[3];
  const Real c6 = cosines[3];
  const Real s7 = sines[4];
  const Real s8 = sines[5];
  const Real c7 = cosines[4];
  const Real c8 = cosines[5];

  // link 4 (link1), outward
  const Real w4_z = qd[2] + qd[3];

  // link 5 (link2), outward
  const Real a6_x_p1 = qd[4] * qd[4];

  // link 6 (link3), outward
  const Real w6_z = qd[4] + qd[5];

  // link 4 (link1), outward
  const Real wd4_z = qdd[2] + qdd[3];
  const Real a6_x_p2 = w4_z * w4_z;

  // link 5 (link2), outward
  const Real wd5_x = w4_z * qd[4];

  // link 6 (link3), outward
  const Real wd6_z = qdd[4] + qdd[5];
  const Real w6_y_p1 = s5 * s6 - c5 * c6;
  const Real a7_y_p1 = w6_z * w6_z;
  const Real minus_w6_x_p1 = s5 * c6 + c5 * s6;
  const Real a6_x_p3 = 0.4318 * c5;
  const Real a4_y_p1 = c3 * c4 - s3 * s4;
  const Real a6_x_p4 = 0.4318 * s5;
  const Real a4_x_p1 = s3 * c4 + c3 * s4;
  const Real w6_y = w6_y_p1 * w4_z;

  // link 5 (link2), outward
  const Real a6_x_p5 = a6_x_p2 + a6_x_p1;

  // link 6 (link3), outward
  const Real wd6_y_p1 = w6_y_p1 * wd4_z;

  // link 5 (link2), outward
  const Real a6_z_p1 = 2.0 * wd5_x;

  // link 6 (link3), outward
  const Real minus_w6_x = minus_w6_x_p1 * w4_z;

  // link 7 (link4), outward
  const Real w7_z = qd[6] - w6_y;

  // link 6 (link3), outward
  const Real a7_y_p2 = w6_y * w6_y;
  const Real wd6_y_p2 = minus_w6_x * w6_z;
  const Real n8_x_p1 = minus_w6_x * w6_y;

  // link 4 (link1), outward
  const Real a4_x = a4_y_p1 * qdd[0] + a4_x_p1 * qdd[1];

  // link 6 (link3), outward
  const Real minus_a7_z_p1 = minus_w6_x * minus_w6_x;

  // link 4 (link1), outward
  const Real a4_y = a4_y_p1 * qdd[1] - a4_x_p1 * qdd[0];

  // link 6 (link3), outward
  const Real a7_y_p3 = a7_y_p2 + a7_y_p1;
  const Real f5_x_p1 = 0.10439999999999999 * s5 - 3.79559 * c5;
  const Real f5_x_p2 = 3.79559 * s5 + 0.10439999999999999 * c5;

  // link 7 (link4), outward
  const Real w7_y = s7 * minus_w6_x + c7 * w6_z;

  // link 6 (link3), outward
  const Real wd6_y = wd6_y_p1 + wd6_y_p2;
  const Real n8_x_p2 = n8_x_p1 + wd6_z;

  // link 7 (link4), outward
  const Real w7_x = s7 * w6_z - c7 * minus_w6_x;

  // link 6 (link3), outward
  const Real minus_a7_z_p2 = minus_a7_z_p1 + a7_y_p1;
  const Real minus_a7_z_p3 = wd6_z - n8_x_p1;
  const Real n8_x_p3 = 2.0 * (w6_y * w6_z) - minus_w6_x_p1 * wd4_z;
  const Real a7_y_p4 = wd6_y_p2 + wd6_y;
  const Real a6_x_p6 = a6_x_p5 * a6_x_p3 + qdd[4] * a6_x_p4 + 0.1501 * wd4_z - a4_x;
  const Real a6_x_p7 = 9.81 + (a6_x_p1 * a6_x_p4 - qdd[4] * a6_x_p3);

  // link 7 (link4), outward
  const Real n8_x_p4 = w7_x * w7_y;
  const Real wd7_z = qdd[6] - wd6_y;

  // link 8 (link5), outward
  const Real w8_z = w7_y + qd[7];

  // link 7 (link4), outward
  const Real n8_x_p5 = n8_x_p4 - wd7_z;

  // link 6 (link3), outward
  const Real a6_z = a4_y + (wd4_z * a6_x_p3 - a6_z_p1 * a6_x_p4 - 0.1501 * a6_x_p2);

  // link 8 (link5), outward
  const Real n8_x_p6 = 2.0 * w8_z;

  // link 7 (link4), outward
  const Real wd7_y_p1 = w7_x * w7_z;

  // link 8 (link5), outward
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real w8_x = c8 * w7_x - s8 * w7_z;

  // link 6 (link3), outward
  const Real a6_x = w6_y_p1 * a6_x_p6 - minus_w6_x_p1 * a6_x_p7;

  // link 9 (link6), outward
  const Real w9_z = minus_w8_y + qd[8];

  // link 7 (link4), outward
  const Real n8_x_p7 = s7 * n8_x_p2 + c7 * n8_x_p3 + 2.0 * (w7_y * w7_z);
  const Real a7_y_p5 = a6_z + (0.0203 * a7_y_p4 - 0.4331 * n8_x_p3);
  const Real a7_y_p6 = a6_x + (0.0203 * a7_y_p3 + 0.4331 * n8_x_p2);
  const Real wd7_y = c7 * n8_x_p2 - s7 * n8_x_p3 - wd7_y_p1;

  // link 8 (link5), outward
  const Real wd8_y_p1 = w8_x * w8_z;
  const Real n8_z_p1 = w8_x * minus_w8_y;

  // link 6 (link3), outward
  const Real a6_y = minus_w6_x_p1 * a6_x_p6 + w6_y_p1 * a6_x_p7;

  // link 8 (link5), outward
  const Real wd8_z = wd7_y + qdd[7];
  const Real n4_z_p1 = 1.601861202 * s5 + 0.0141984 * c5;

  // link 7 (link4), outward
  const Real a7_y = c7 * a7_y_p5 - s7 * a7_y_p6;
  const Real a7_x = c7 * a7_y_p6 + s7 * a7_y_p5;
  const Real minus_a7_z = a6_y + (0.4331 * minus_a7_z_p2 - 0.0203 * minus_a7_z_p3);

  // link 8 (link5), outward
  const Real f8_x_p1 = n8_z_p1 + wd8_z;

  // link 8 (link5), inertial wrench
  const Real f8_y = 0.0028799999999999997 * (w8_x * w8_x + w8_z * w8_z);

  // link 8 (link5), outward
  const Real n8_x_p8 = s8 * n8_x_p5 + c8 * n8_x_p7 - n8_x_p6 * minus_w8_y;
  const Real wd8_y = c8 * n8_x_p5 - s8 * n8_x_p7 - wd8_y_p1;

  // link 8 (link5), inertial wrench
  const Real f8_x = 0.0028799999999999997 * f8_x_p1;
  const Real n4_z_p2 = 0.690314699 * s5 + 0.023750999999999998 * c5;

  // link 9 (link6), outward
  const Real wd9_z = qdd[8] - wd8_y;

  // link 8 (link5), inertial wrench
  const Real minus_f8_z = 0.0028799999999999997 * n8_x_p8;

  // link 8 (link5), outward
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;

  // link 9 (link6), inertial wrench
  const Real n9_z = 4e-05 * wd9_z;
  tau[8] = n9_z;
  const Real n9_x = 2e-05 * (n8_x_p8 + n8_x_p6 * w9_z);
  const Real minus_n9_y = 2e-05 * (2.0 * (w8_x * w9_z) - f8_x_p1);

  // link 8 (link5), inward
  const Real minus_f7_x = s8 * f8_y - c8 * f8_x;
  const Real n4_z_p3 = c5 * n4_z_p1 - 0.0070992;

  // link 9 (link6), inward
  const Real minus_n8_y = 2e-04 * (wd8_y_p1 - wd8_y) + n9_z;
  const Real n8_x = 0.00042216 * n8_x_p8 - 0.0028799999999999997 * a7_y + n9_x;
  const Real n8_z = 0.00022215999999999997 * n8_z_p1 + 0.00062216 * wd8_z + 0.0028799999999999997 *
      a8_x - minus_n9_y;
  tau[7] = n8_z;

  // link 8 (link5), inward
  const Real minus_f7_z = s8 * f8_x + c8 * f8_y;

  // link 7 (link4), inward
  const Real n6_y_p1 = s7 * minus_f7_x + c7 * minus_f8_z;
  const Real f6_x_p1 = s7 * minus_f8_z - c7 * minus_f7_x;

  // link 8 (link5), inward
  const Real n7_y = n8_z - 0.00065 * (wd7_y_p1 - wd7_y);

  // link 7 (link4), inward
  const Real f6_x = 0.025374999999999998 * a7_y_p3 + 0.861795 * n8_x_p2 + f6_x_p1;
  const Real f6_y = 0.861795 * minus_a7_z_p2 - 0.025374999999999998 * minus_a7_z_p3 + minus_f7_z;

  // link 8 (link5), inward
  const Real n7_x = 0.0007499999999999999 * n8_x_p7 + (c8 * n8_x + s8 * minus_n8_y);
  const Real n7_z = 0.0014 * wd7_z - 9.999999999999994e-05 * n8_x_p4 +
      (c8 * minus_n8_y - s8 * n8_x);
  tau[6] = n7_z;

  // link 6 (link3), inertial wrench
  const Real n6_x_p1 = 0.3056901365 * n8_x_p3 - 0.010673638499999999 * a7_y_p4 -
      0.004704000000000001 * (a7_y_p1 - a7_y_p2) - 0.861795 * a6_z;

  // link 5 (link2), inward
  const Real n4_z_p4 = qdd[4] * n4_z_p2 - 4.9338049999999996 * a4_x - a6_z_p1 * n4_z_p3 - a6_x_p1 *
      (0.023750999999999998 * s5 - 0.690314699 * c5);

  // link 7 (link4), inward
  const Real n6_y = 0.0067651125 * a7_y_p4 + 0.004704000000000001 * n8_x_p2 - 0.010673638499999999 *
      n8_x_p3 + 0.025374999999999998 * a6_z - (n7_z + 0.0203 * n6_y_p1);

  // link 6 (link3), inward
  const Real f5_x_p3 = w6_y_p1 * f6_x + minus_w6_x_p1 * f6_y;

  // link 7 (link4), inward
  const Real f6_z = 0.025374999999999998 * a7_y_p4 - 0.861795 * n8_x_p3 - n6_y_p1;

  // link 6 (link3), inward
  const Real f5_x = qdd[4] * f5_x_p2 - a6_x_p5 * f5_x_p1 + f5_x_p3;
  const Real f5_z = f6_z - (wd4_z * f5_x_p1 + a6_z_p1 * f5_x_p2);

  // link 6 (link3), inertial wrench
  const Real n6_z_p1 = 0.298925024 * n8_x_p1 + 0.312455249 * wd6_z + 0.004704000000000001 *
      wd6_y_p1 + 0.010673638499999999 * (a7_y_p2 - minus_a7_z_p1);

  // link 7 (link4), inward
  const Real n6_x = n6_x_p1 + (c7 * n7_x - s7 * n7_y + 0.4331 * n6_y_p1);

  // link 5 (link2), inward
  const Real minus_f4_x = 4.9338049999999996 * wd4_z + f5_x;
  const Real f4_y = f5_z - 4.9338049999999996 * a6_x_p2;

  // link 7 (link4), inward
  const Real n6_z = n6_z_p1 + (0.861795 * a6_x - 0.025374999999999998 * a6_y) +
      (s7 * n7_x + c7 * n7_y + (0.4331 * f6_x_p1 - 0.0203 * minus_f7_z));
  tau[5] = n6_z;

  // link 4 (link1), inward
  const Real minus_f3_x = a4_y_p1 * minus_f4_x + a4_x_p1 * f4_y;
  const Real f3_y = a4_y_p1 * f4_y - a4_x_p1 * minus_f4_x;

  // link 5 (link2), inertial wrench
  const Real n5_z_p1 = 1.7481140020000001 * qdd[4] + wd4_z * n4_z_p2 + a6_x_p2 * n4_z_p3 +
      (9.81 * f5_x_p1 - f5_x_p2 * a4_x);

  // link 5 (link2), inward
  const Real n4_z_p5 = n4_z_p4 - f5_x_p1 * a4_y + w6_y_p1 * n6_y - minus_w6_x_p1 * n6_x + 0.1501 *
      f5_x_p3;

  // link 3 (base), inward
  const Real f2_x = 186.45 * qdd[0] - minus_f3_x;
  tau[0] = f2_x;
  const Real f2_z = 186.45 * qdd[1] + f3_y;
  tau[1] = f2_z;

  // link 6 (link3), inward
  const Real n5_z = n5_z_p1 + (n6_z + (a6_x_p4 * f5_x_p3 - a6_x_p3 *
      (w6_y_p1 * f6_y - minus_w6_x_p1 * f6_x)));
  tau[4] = n5_z;

  // link 5 (link2), inward
  const Real n4_z = n4_z_p5 + a6_x_p3 * f6_z + (3.1467171525 - s5 * n4_z_p1) * wd4_z;
  tau[3] = n4_z;

  // link 4 (link1), inward
  const Real n3_z = 7.2 * qdd[2] + n4_z;
  tau[2] = n3_z;
}

}  // namespace samm

#undef TREELINE_RESTRICT
