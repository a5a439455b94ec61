// nonlinear_effects: h = b + g: the joint forces at qdd = 0
// By recursive Newton-Euler, Chang table 4.1.
// 246 flops (add 96, mul 150, div 0), sine and cosine of 6 angles
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
  const Real angles[6] = {q[2], q[3], q[4], q[5], q[6], q[7]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s5 = sines[2];
  const Real s6 = sines[3];
  const Real c5 = cosines[2];
  const Real c6 = cosines[3];
  const Real s7 = sines[4];
  const Real s8 = sines[5];
  const Real c7 = cosines[4];
  const Real c8 = cosines[5];
  const Real s4 = sines[1];
  const Real s3 = sines[0];

  // link 4 (link1), outward
  const Real w4_z = qd[2] + qd[3];

  // link 6 (link3), outward
  const Real w6_z = qd[4] + qd[5];

  // link 5 (link2), outward
  const Real a6_y_p1 = qd[4] * qd[4];
  const Real a6_y_p2 = 0.4318 * s5;
  const Real a6_x_p1 = 0.4318 * c5;
  const Real w7_x_p1 = s5 * c6 + c5 * s6;
  const Real a7_y_p1 = s5 * s6 - c5 * c6;

  // link 4 (link1), outward
  const Real a7_y_p2 = w4_z * w4_z;

  // link 6 (link3), outward
  const Real a7_y_p3 = w6_z * w6_z;
  const Real wd6_x = w4_z * w6_z;

  // link 5 (link2), outward
  const Real wd5_x = w4_z * qd[4];

  // link 7 (link4), outward
  const Real w7_x_p2 = w7_x_p1 * w4_z;

  // link 6 (link3), outward
  const Real a7_y_p4 = a7_y_p2 + a7_y_p3;

  // link 5 (link2), outward
  const Real a6_x_p2 = a7_y_p2 + a6_y_p1;

  // link 7 (link4), outward
  const Real n8_x_p1 = a7_y_p1 * wd6_x;

  // link 5 (link2), outward
  const Real minus_a6_z_p1 = 2.0 * wd5_x;

  // link 6 (link3), outward
  const Real a7_y_p5 = 2.0 * wd6_x;

  // link 7 (link4), outward
  const Real minus_wd7_z = w7_x_p1 * wd6_x;

  // link 6 (link3), outward
  const Real a6_y = 9.81 + a6_y_p1 * a6_y_p2;
  const Real a7_y_p6 = 0.0203 * w7_x_p1 - 0.4331 * a7_y_p1;
  const Real a6_x = a6_x_p2 * a6_x_p1;
  const Real a7_y_p7 = 0.0203 * a7_y_p1 + 0.4331 * w7_x_p1;

  // link 7 (link4), outward
  const Real w7_z = qd[6] - a7_y_p1 * w4_z;
  const Real w7_x = s7 * w6_z - c7 * w7_x_p2;
  const Real w7_y = s7 * w7_x_p2 + c7 * w6_z;
  const Real n5_y_p1 = 0.025374999999999998 * a7_y_p1 + 0.861795 * w7_x_p1;

  // link 6 (link3), outward
  const Real minus_a6_z = minus_a6_z_p1 * a6_y_p2 + 0.1501 * a7_y_p2;

  // link 7 (link4), outward
  const Real n8_x_p2 = w7_x * w7_y;
  const Real a7_y_p8 = a6_y - a7_y_p3 * a7_y_p6;
  const Real a7_y_p9 = a6_x + a7_y_p4 * a7_y_p7;

  // link 8 (link5), outward
  const Real w8_z = w7_y + qd[7];

  // link 7 (link4), outward
  const Real a7_y_p10 = a7_y_p5 * a7_y_p6 - minus_a6_z;
  const Real f6_z_p1 = 0.025374999999999998 * w7_x_p1 - 0.861795 * a7_y_p1;
  const Real n5_y_p2 = a7_y_p1 * (0.298925024 * w7_x_p1 + 0.021347276999999998 * a7_y_p1) -
      0.010673638499999999;
  const Real f5_x_p1 = 0.10439999999999999 * s5 - 3.79559 * c5;
  const Real n8_x_p3 = n8_x_p2 + minus_wd7_z;
  const Real n8_x_p4 = c7 * n8_x_p1 + (w7_z + qd[6]) * w7_y;

  // link 8 (link5), outward
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real w8_x = c8 * w7_x - s8 * w7_z;
  const Real n8_x_p5 = 2.0 * w8_z;

  // link 7 (link4), outward
  const Real minus_wd7_y = s7 * n8_x_p1 + w7_x * qd[6];
  const Real a7_y_p11 = a7_y_p1 * a7_y_p9 - w7_x_p1 * a7_y_p8;

  // link 8 (link5), outward
  const Real minus_f8_x_p1 = w8_x * minus_w8_y;

  // link 9 (link6), outward
  const Real w9_z = minus_w8_y + qd[8];

  // link 8 (link5), outward
  const Real wd8_y_p1 = w8_x * w8_z;

  // link 7 (link4), outward
  const Real minus_a7_z = w7_x_p1 * a7_y_p9 + a7_y_p1 * a7_y_p8;

  // link 8 (link5), outward
  const Real minus_f8_x_p2 = minus_wd7_y - minus_f8_x_p1;
  const Real n8_x_p6 = s8 * n8_x_p3 + c8 * n8_x_p4 - n8_x_p5 * minus_w8_y;
  const Real wd8_y = c8 * n8_x_p3 - s8 * n8_x_p4 - wd8_y_p1;

  // link 7 (link4), outward
  const Real a7_y = c7 * a7_y_p10 - s7 * a7_y_p11;

  // link 8 (link5), inertial wrench
  const Real minus_f8_x = 0.0028799999999999997 * minus_f8_x_p2;
  const Real f8_y = 0.0028799999999999997 * (w8_x * w8_x + w8_z * w8_z);

  // link 7 (link4), outward
  const Real a7_x = c7 * a7_y_p11 + s7 * a7_y_p10;

  // link 9 (link6), inertial wrench
  const Real minus_n9_z = 4e-05 * wd8_y;
  h[8] = -minus_n9_z;

  // link 8 (link5), inertial wrench
  const Real minus_f8_z = 0.0028799999999999997 * n8_x_p6;

  // link 9 (link6), inertial wrench
  const Real n9_x = 2e-05 * (n8_x_p6 + n8_x_p5 * w9_z);

  // link 8 (link5), inward
  const Real minus_f7_x = c8 * minus_f8_x + s8 * f8_y;

  // link 8 (link5), outward
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;

  // link 9 (link6), inertial wrench
  const Real minus_n9_y = 2e-05 * (minus_f8_x_p2 + 2.0 * (w8_x * w9_z));

  // link 9 (link6), inward
  const Real n8_y = minus_n9_z - 2e-04 * (wd8_y_p1 - wd8_y);

  // link 8 (link5), inward
  const Real f7_z = s8 * minus_f8_x - c8 * f8_y;

  // link 9 (link6), inward
  const Real n8_x = 0.00042216 * n8_x_p6 - 0.0028799999999999997 * a7_y + n9_x;
  const Real n5_y_p3 = c5 * (1.601861202 * s5 + 0.0141984 * c5) - 0.0070992;

  // link 7 (link4), inward
  const Real f6_x_p1 = s7 * minus_f8_z - c7 * minus_f7_x;
  const Real f6_z_p2 = s7 * minus_f7_x + c7 * minus_f8_z;

  // link 9 (link6), inward
  const Real n8_z = 0.00022215999999999997 * minus_f8_x_p1 - 0.00062216 * minus_wd7_y +
      0.0028799999999999997 * a8_x - minus_n9_y;
  h[7] = n8_z;

  // link 7 (link4), inward
  const Real f6_z = a7_y_p5 * f6_z_p1 - f6_z_p2;

  // link 8 (link5), inward
  const Real minus_n7_z = 9.999999999999994e-05 * n8_x_p2 + 0.0014 * minus_wd7_z +
      (s8 * n8_x + c8 * n8_y);
  h[6] = -minus_n7_z;
  const Real n7_x = 0.0007499999999999999 * n8_x_p4 - (s8 * n8_y - c8 * n8_x);
  const Real n7_y = n8_z - 0.00065 * (w7_x * w7_z + minus_wd7_y);

  // link 6 (link3), inward
  const Real f5_z = f6_z - minus_a6_z_p1 * (3.79559 * s5 + 0.10439999999999999 * c5);

  // link 7 (link4), inward
  const Real f6_x_p2 = a7_y_p1 * f6_x_p1 - w7_x_p1 * f7_z;
  const Real n6_z_p1 = w7_x_p1 * f6_x_p1 + a7_y_p1 * f7_z;

  // link 5 (link2), inward
  const Real f4_y = f5_z - 4.9338049999999996 * a7_y_p2;

  // link 7 (link4), inward
  const Real f6_x = a7_y_p4 * n5_y_p1 + f6_x_p2;
  const Real minus_f6_y = a7_y_p3 * f6_z_p1 + n6_z_p1;

  // link 6 (link3), inward
  const Real f5_x = f6_x - a6_x_p2 * f5_x_p1;
  const Real n5_y_p4 = a7_y_p1 * minus_n7_z - (a7_y_p5 * n5_y_p2 + n5_y_p1 * minus_a6_z) - a7_y_p7 *
      f6_z_p2 + 0.1501 * f6_x;

  // link 4 (link1), inward
  const Real minus_f3_x = c4 * f5_x + s4 * f4_y;
  const Real f3_y = c4 * f4_y - s4 * f5_x;

  // link 7 (link4), inward
  const Real n6_z = a7_y_p2 * n5_y_p2 - (n5_y_p1 * a6_y + f6_z_p1 * a6_x) +
      (s7 * n7_x + c7 * n7_y + (a7_y_p7 * n6_z_p1 - a7_y_p6 * f6_x_p2));
  h[5] = n6_z;

  // link 6 (link3), inward
  const Real n5_y_p5 = n5_y_p4 + a6_x_p1 * f6_z - minus_a6_z_p1 * n5_y_p3 - a6_y_p1 *
      (0.023750999999999998 * s5 - 0.690314699 * c5);

  // link 3 (base), inward
  const Real minus_f2_x = c3 * minus_f3_x + s3 * f3_y;
  h[0] = -minus_f2_x;
  const Real f2_z = c3 * f3_y - s3 * minus_f3_x;
  h[1] = f2_z;

  // link 6 (link3), inward
  const Real n5_z = a7_y_p2 * n5_y_p3 + 9.81 * f5_x_p1 +
      (n6_z + (a6_x_p1 * minus_f6_y + a6_y_p2 * f6_x));
  h[4] = n5_z;
  const Real n5_y = n5_y_p5 + (0.004704000000000001 * a7_y_p3 - (c7 * n7_x - s7 * n7_y)) * w7_x_p1;
  h[2] = n5_y;
  h[3] = n5_y;
}

}  // namespace samm

#undef TREELINE_RESTRICT
