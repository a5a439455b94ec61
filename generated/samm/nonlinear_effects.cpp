// nonlinear_effects: h = b + g: the joint forces at qdd = 0
// By recursive Newton-Euler, Chang table 4.1.
// 322 flops (add 137, mul 185, div 0), sine and cosine of 7 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void nonlinear_effects(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    Real (&TREELINE_RESTRICT h)[9]) noexcept {
  const Real angles[7] = {q[2], q[3], q[4], q[5], q[6], q[7], q[8]};
  Real sines[7];
  Real cosines[7];
  detail::sin_cos(angles, sines, cosines);
  const Real s3 = sines[0];
  const Real c3 = cosines[0];
  const Real s4 = sines[1];
  const Real c4 = cosines[1];
  const Real s5 = sines[2];
  const Real c5 = cosines[2];
  const Real s6 = sines[3];
  const Real c6 = cosines[3];
  const Real s7 = sines[4];
  const Real c7 = cosines[4];
  const Real s8 = sines[5];
  const Real c8 = cosines[5];
  const Real s9 = sines[6];
  const Real c9 = cosines[6];

  // link 4 (link1), outward
  const Real w4_z = qd[2] + qd[3];

  // link 5 (link2), outward
  const Real minus_w5_y = c5 * w4_z;
  const Real minus_w5_x = s5 * w4_z;

  // link 6 (link3), outward
  const Real minus_w6_y = c6 * minus_w5_y - s6 * minus_w5_x;

  // link 7 (link4), outward
  const Real w7_z = qd[6] + minus_w6_y;

  // link 6 (link3), outward
  const Real minus_w6_x = s6 * minus_w5_y + c6 * minus_w5_x;
  const Real w6_z = qd[4] + qd[5];

  // link 7 (link4), outward
  const Real w7_x = s7 * w6_z - c7 * minus_w6_x;

  // link 8 (link5), outward
  const Real minus_w8_x = s8 * w7_z - c8 * w7_x;

  // link 7 (link4), outward
  const Real w7_y = c7 * w6_z + s7 * minus_w6_x;

  // link 8 (link5), outward
  const Real w8_z = qd[7] + w7_y;

  // link 8 (link5), inertial wrench
  const Real f8_y = 0.0028799999999999997 * (minus_w8_x * minus_w8_x + w8_z * w8_z);

  // link 8 (link5), outward
  const Real minus_w8_y = c8 * w7_z + s8 * w7_x;
  const Real minus_f8_x_p1 = minus_w8_x * minus_w8_y;

  // link 5 (link2), outward
  const Real wd5_y = qd[4] * minus_w5_x;
  const Real minus_wd5_x = qd[4] * minus_w5_y;

  // link 6 (link3), outward
  const Real wd6_x = s6 * wd5_y - c6 * minus_wd5_x - qd[5] * minus_w6_y;

  // link 7 (link4), outward
  const Real minus_wd7_y = s7 * wd6_x + qd[6] * w7_x;

  // link 8 (link5), inertial wrench
  const Real minus_f8_x = 0.0028799999999999997 * (minus_wd7_y + minus_f8_x_p1);

  // link 8 (link5), inward
  const Real minus_f7_z = c8 * f8_y - s8 * minus_f8_x;

  // link 6 (link3), outward
  const Real f6_y_p1 = minus_w6_x * minus_w6_x;
  const Real f6_y_p2 = w6_z * w6_z;

  // link 7 (link4), outward
  const Real f6_y_p3 = f6_y_p1 + f6_y_p2;

  // link 6 (link3), outward
  const Real f6_y_p4 = minus_w6_x * minus_w6_y;

  // link 7 (link4), inward
  const Real f6_y = minus_f7_z + (0.861795 * f6_y_p3 - 0.025374999999999998 * f6_y_p4);

  // link 8 (link5), inward
  const Real minus_f7_x = s8 * f8_y + c8 * minus_f8_x;

  // link 6 (link3), outward
  const Real wd6_y = c6 * wd5_y + s6 * minus_wd5_x + qd[5] * minus_w6_x;

  // link 7 (link4), outward
  const Real wd7_x = c7 * wd6_x + qd[6] * w7_y;

  // link 8 (link5), outward
  const Real wd8_x = s8 * wd6_y + c8 * wd7_x - qd[7] * minus_w8_y;
  const Real minus_f8_z_p1 = wd8_x - minus_w8_y * w8_z;

  // link 8 (link5), inertial wrench
  const Real minus_f8_z = 0.0028799999999999997 * minus_f8_z_p1;

  // link 7 (link4), inward
  const Real f6_x_p1 = s7 * minus_f8_z - c7 * minus_f7_x;

  // link 6 (link3), outward
  const Real f6_x_p2 = minus_w6_y * minus_w6_y;

  // link 7 (link4), outward
  const Real f6_x_p3 = f6_x_p2 + f6_y_p2;

  // link 7 (link4), inward
  const Real f6_x = f6_x_p1 - (0.861795 * f6_y_p4 - 0.025374999999999998 * f6_x_p3);

  // link 6 (link3), inward
  const Real f5_y_p1 = c6 * f6_y + s6 * f6_x;

  // link 5 (link2), outward
  const Real f5_y_p2 = minus_w5_x * minus_w5_x;
  const Real f5_y_p3 = qd[4] * qd[4];
  const Real f5_y_p4 = minus_w5_x * minus_w5_y;

  // link 6 (link3), inward
  const Real f5_y = f5_y_p1 - (0.10439999999999999 * (f5_y_p2 + f5_y_p3) - 3.79559 * f5_y_p4);
  const Real minus_f5_x_p1 = s6 * f6_y - c6 * f6_x;

  // link 5 (link2), outward
  const Real minus_f5_x_p2 = minus_w5_y * minus_w5_y;

  // link 6 (link3), outward
  const Real minus_f5_x_p3 = minus_f5_x_p2 + f5_y_p3;

  // link 6 (link3), inward
  const Real minus_f5_x = minus_f5_x_p1 - (0.10439999999999999 * f5_y_p4 - 3.79559 * minus_f5_x_p3);

  // link 5 (link2), inward
  const Real minus_f4_x = s5 * f5_y + c5 * minus_f5_x;

  // link 7 (link4), inward
  const Real minus_f6_z_p1 = c7 * minus_f8_z + s7 * minus_f7_x;

  // link 6 (link3), outward
  const Real minus_f6_z_p2 = wd6_x - minus_w6_y * w6_z;
  const Real minus_f6_z_p3 = minus_w6_x * w6_z;
  const Real minus_f6_z_p4 = wd6_y + minus_f6_z_p3;

  // link 7 (link4), inward
  const Real minus_f6_z = minus_f6_z_p1 + (0.861795 * minus_f6_z_p2 - 0.025374999999999998 *
      minus_f6_z_p4);

  // link 5 (link2), inward
  const Real minus_f4_y = minus_f6_z + (w4_z * (4.9338049999999996 * w4_z) + 0.20879999999999999 *
      minus_wd5_x + 7.59118 * wd5_y);

  // link 4 (link1), inward
  const Real minus_f3_y = c4 * minus_f4_y + s4 * minus_f4_x;
  const Real f3_x = s4 * minus_f4_y - c4 * minus_f4_x;

  // link 3 (base), inward
  const Real f2_x = s3 * minus_f3_y + c3 * f3_x;
  h[0] = f2_x;
  const Real minus_f2_z = c3 * minus_f3_y - s3 * f3_x;
  h[1] = -minus_f2_z;

  // link 6 (link3), inward
  const Real n5_y_p1 = 0.690314699 * (f5_y_p2 - f5_y_p3) + 0.0141984 * minus_wd5_x +
      0.023750999999999998 * f5_y_p4 + 3.349975204 * wd5_y;

  // link 6 (link3), outward
  const Real minus_a6_z = 0.1501 * (f5_y_p2 + minus_f5_x_p2) + 0.8636 * wd5_y;

  // link 7 (link4), outward
  const Real minus_a7_y_p1 = minus_a6_z + 0.4331 * minus_f6_z_p2 - 0.0203 * minus_f6_z_p4;

  // link 6 (link3), outward
  const Real minus_a6_x_p1 = 9.81 * c5 - 0.4318 * f5_y_p4;
  const Real minus_a6_x_p2 = 9.81 * s5 + 0.4318 * minus_f5_x_p3;
  const Real minus_a6_x = s6 * minus_a6_x_p1 + c6 * minus_a6_x_p2;

  // link 7 (link4), outward
  const Real minus_a7_y_p2 = minus_a6_x + 0.4331 * f6_y_p4 - 0.0203 * f6_x_p3;
  const Real minus_a7_y = c7 * minus_a7_y_p1 - s7 * minus_a7_y_p2;

  // link 9 (link6), outward
  const Real w9_x = s9 * w8_z - c9 * minus_w8_x;
  const Real w9_z = qd[8] + minus_w8_y;
  const Real minus_n9_y_p1 = qd[8] + w9_z;

  // link 9 (link6), inertial wrench
  const Real minus_n9_y = 2e-05 * (w9_x * minus_n9_y_p1 + (c9 * minus_wd7_y + s9 * wd8_x));

  // link 9 (link6), outward
  const Real w9_y = c9 * w8_z + s9 * minus_w8_x;

  // link 9 (link6), inertial wrench
  const Real n9_x = 2e-05 * (w9_y * minus_n9_y_p1 - (s9 * minus_wd7_y - c9 * wd8_x));

  // link 9 (link6), inward
  const Real n8_x = 0.00042216 * minus_f8_z_p1 + 0.0028799999999999997 * minus_a7_y + s9 *
      minus_n9_y + c9 * n9_x;

  // link 8 (link5), outward
  const Real wd8_y = c8 * wd6_y - s8 * wd7_x + qd[7] * minus_w8_x;

  // link 9 (link6), inertial wrench
  const Real minus_n9_z = 4e-05 * wd8_y;
  h[8] = -minus_n9_z;

  // link 9 (link6), inward
  const Real n8_y = minus_n9_z + 2e-04 * (wd8_y + minus_w8_x * w8_z);

  // link 8 (link5), inward
  const Real minus_n7_z = 0.0013999999999999998 * wd6_y + w7_y * (9.999999999999994e-05 * w7_x) +
      c8 * n8_y + s8 * n8_x;
  h[6] = -minus_n7_z;

  // link 7 (link4), inward
  const Real n6_y_p1 = minus_n7_z - (0.010673638499999999 * minus_f6_z_p2 + 0.004704000000000001 *
      f6_y_p4 - 0.0067651125 * minus_f6_z_p4 + 0.025374999999999998 * minus_a6_z);
  const Real n6_y = n6_y_p1 - 0.0203 * minus_f6_z_p1;

  // link 7 (link4), outward
  const Real minus_a7_x = s7 * minus_a7_y_p1 + c7 * minus_a7_y_p2;

  // link 6 (link3), outward
  const Real minus_a6_y = c6 * minus_a6_x_p1 - s6 * minus_a6_x_p2;

  // link 7 (link4), outward
  const Real a7_z = minus_a6_y - 0.4331 * f6_y_p3 + 0.0203 * f6_y_p4;

  // link 8 (link5), outward
  const Real minus_a8_x = s8 * a7_z + c8 * minus_a7_x;

  // link 9 (link6), inward
  const Real minus_n8_z = 0.00062216 * minus_wd7_y + 0.00022215999999999997 * minus_f8_x_p1 +
      0.0028799999999999997 * minus_a8_x + c9 * minus_n9_y - s9 * n9_x;
  h[7] = -minus_n8_z;

  // link 8 (link5), inward
  const Real minus_n7_y = minus_n8_z + 0.00065 * (minus_wd7_y + w7_x * w7_z);

  // link 7 (link4), inward
  const Real n6_x_p1 = 0.004704000000000001 * (f6_x_p2 - f6_y_p2) - 0.010673638499999999 *
      minus_f6_z_p4 + 0.3056901365 * minus_f6_z_p2 + 0.861795 * minus_a6_z;

  // link 8 (link5), inward
  const Real n7_x = 0.0007499999999999999 * (wd7_x + w7_y * w7_z) - s8 * n8_y + c8 * n8_x;

  // link 7 (link4), inward
  const Real n6_x = n6_x_p1 + 0.4331 * minus_f6_z_p1 + s7 * minus_n7_y + c7 * n7_x;

  // link 6 (link3), inward
  const Real n5_y = n5_y_p1 + 0.4318 * minus_f6_z - 0.1501 * minus_f5_x_p1 + c6 * n6_y + s6 * n6_x;
  const Real minus_n5_x_p1 = 0.023750999999999998 * (minus_f5_x_p2 - f5_y_p3) + 0.690314699 *
      f5_y_p4 + 0.0141984 * wd5_y + 0.14625280000000002 * minus_wd5_x;
  const Real minus_n5_x = minus_n5_x_p1 + 0.1501 * f5_y_p1 + s6 * n6_y - c6 * n6_x;

  // link 5 (link2), inward
  const Real minus_n4_z = c5 * n5_y - s5 * minus_n5_x;
  h[2] = -minus_n4_z;
  h[3] = -minus_n4_z;

  // link 7 (link4), inward
  const Real minus_n6_z_p1 = 0.010673638499999999 * (f6_y_p1 - f6_x_p2) - 0.004704000000000001 *
      (wd6_y - minus_f6_z_p3) + 0.298925024 * f6_y_p4 + 0.861795 * minus_a6_x;
  const Real minus_n6_z_p2 = minus_n6_z_p1 - 0.025374999999999998 * minus_a6_y - 0.4331 * f6_x_p1 +
      0.0203 * minus_f7_z + c7 * minus_n7_y;
  const Real minus_n6_z = minus_n6_z_p2 - s7 * n7_x;
  h[5] = -minus_n6_z;

  // link 6 (link3), inward
  const Real minus_n5_z_p1 = 0.0070992 * (f5_y_p2 - minus_f5_x_p2) - 1.601861202 * f5_y_p4 -
      1.024164 * s5 + 37.2347379 * c5;
  const Real minus_n5_z = minus_n6_z + minus_n5_z_p1 - 0.4318 * f5_y_p1;
  h[4] = -minus_n5_z;
}

}  // namespace samm

#undef TREELINE_RESTRICT
