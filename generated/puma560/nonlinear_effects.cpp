// nonlinear_effects: h = b + g: the joint forces at qdd = 0
// By recursive Newton-Euler, Chang table 4.1.
// 290 flops (add 123, mul 167, div 0), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void nonlinear_effects(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    Real (&TREELINE_RESTRICT h)[6]) noexcept {
  const Real angles[5] = {q[1], q[2], q[3], q[4], q[5]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real c3 = cosines[1];
  const Real s4 = sines[2];
  const Real c4 = cosines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];
  const Real s6 = sines[4];
  const Real c6 = cosines[4];

  // link 2 (link2), outward
  const Real minus_w2_y = qd[0] * c2;
  const Real minus_w2_x = qd[0] * s2;

  // link 3 (link3), outward
  const Real minus_w3_y = c3 * minus_w2_y - s3 * minus_w2_x;

  // link 4 (link4), outward
  const Real w4_z = qd[3] + minus_w3_y;

  // link 3 (link3), outward
  const Real minus_w3_x = s3 * minus_w2_y + c3 * minus_w2_x;
  const Real w3_z = qd[1] + qd[2];

  // link 4 (link4), outward
  const Real w4_x = s4 * w3_z - c4 * minus_w3_x;

  // link 5 (link5), outward
  const Real minus_w5_x = s5 * w4_z - c5 * w4_x;

  // link 4 (link4), outward
  const Real w4_y = c4 * w3_z + s4 * minus_w3_x;

  // link 5 (link5), outward
  const Real w5_z = qd[4] + w4_y;

  // link 5 (link5), inertial wrench
  const Real f5_y = 0.0028799999999999997 * (minus_w5_x * minus_w5_x + w5_z * w5_z);

  // link 5 (link5), outward
  const Real minus_w5_y = c5 * w4_z + s5 * w4_x;
  const Real minus_f5_x_p1 = minus_w5_x * minus_w5_y;

  // link 2 (link2), outward
  const Real wd2_y = qd[1] * minus_w2_x;
  const Real minus_wd2_x = qd[1] * minus_w2_y;

  // link 3 (link3), outward
  const Real wd3_x = s3 * wd2_y - c3 * minus_wd2_x - qd[2] * minus_w3_y;

  // link 4 (link4), outward
  const Real minus_wd4_y = s4 * wd3_x + qd[3] * w4_x;

  // link 5 (link5), inertial wrench
  const Real minus_f5_x = 0.0028799999999999997 * (minus_wd4_y + minus_f5_x_p1);

  // link 5 (link5), inward
  const Real minus_f4_z = c5 * f5_y - s5 * minus_f5_x;

  // link 3 (link3), outward
  const Real f3_y_p1 = minus_w3_x * minus_w3_x;
  const Real f3_y_p2 = w3_z * w3_z;

  // link 4 (link4), outward
  const Real f3_y_p3 = f3_y_p1 + f3_y_p2;

  // link 3 (link3), outward
  const Real f3_y_p4 = minus_w3_x * minus_w3_y;

  // link 4 (link4), inward
  const Real f3_y = minus_f4_z + (0.861795 * f3_y_p3 - 0.025374999999999998 * f3_y_p4);

  // link 5 (link5), inward
  const Real minus_f4_x = s5 * f5_y + c5 * minus_f5_x;

  // link 3 (link3), outward
  const Real wd3_y = c3 * wd2_y + s3 * minus_wd2_x + qd[2] * minus_w3_x;

  // link 4 (link4), outward
  const Real wd4_x = c4 * wd3_x + qd[3] * w4_y;

  // link 5 (link5), outward
  const Real wd5_x = s5 * wd3_y + c5 * wd4_x - qd[4] * minus_w5_y;
  const Real minus_f5_z_p1 = wd5_x - minus_w5_y * w5_z;

  // link 5 (link5), inertial wrench
  const Real minus_f5_z = 0.0028799999999999997 * minus_f5_z_p1;

  // link 4 (link4), inward
  const Real f3_x_p1 = s4 * minus_f5_z - c4 * minus_f4_x;

  // link 3 (link3), outward
  const Real f3_x_p2 = minus_w3_y * minus_w3_y;

  // link 4 (link4), outward
  const Real f3_x_p3 = f3_x_p2 + f3_y_p2;

  // link 4 (link4), inward
  const Real f3_x = f3_x_p1 - (0.861795 * f3_y_p4 - 0.025374999999999998 * f3_x_p3);
  const Real minus_f3_z_p1 = c4 * minus_f5_z + s4 * minus_f4_x;

  // link 3 (link3), outward
  const Real minus_f3_z_p2 = wd3_x - minus_w3_y * w3_z;
  const Real minus_f3_z_p3 = minus_w3_x * w3_z;
  const Real minus_f3_z_p4 = wd3_y + minus_f3_z_p3;

  // link 4 (link4), inward
  const Real minus_f3_z = minus_f3_z_p1 + (0.861795 * minus_f3_z_p2 - 0.025374999999999998 *
      minus_f3_z_p4);

  // link 2 (link2), outward
  const Real n2_y_p1 = minus_w2_x * minus_w2_x;
  const Real n2_y_p2 = qd[1] * qd[1];
  const Real n2_y_p3 = minus_w2_x * minus_w2_y;

  // link 3 (link3), inward
  const Real n2_y_p4 = 0.690314699 * (n2_y_p1 - n2_y_p2) + 0.0141984 * minus_wd2_x +
      0.023750999999999998 * n2_y_p3 + 3.349975204 * wd2_y;

  // link 2 (link2), outward
  const Real minus_a3_z_p1 = minus_w2_y * minus_w2_y;

  // link 3 (link3), outward
  const Real minus_a3_z = 0.1501 * (n2_y_p1 + minus_a3_z_p1) + 0.8636 * wd2_y;

  // link 4 (link4), outward
  const Real minus_a4_y_p1 = minus_a3_z + 0.4331 * minus_f3_z_p2 - 0.0203 * minus_f3_z_p4;

  // link 3 (link3), outward
  const Real minus_a3_x_p1 = 9.81 * c2 - 0.4318 * n2_y_p3;
  const Real minus_a3_x_p2 = 9.81 * s2 + 0.4318 * (minus_a3_z_p1 + n2_y_p2);
  const Real minus_a3_x = s3 * minus_a3_x_p1 + c3 * minus_a3_x_p2;

  // link 4 (link4), outward
  const Real minus_a4_y_p2 = minus_a3_x + 0.4331 * f3_y_p4 - 0.0203 * f3_x_p3;
  const Real minus_a4_y = c4 * minus_a4_y_p1 - s4 * minus_a4_y_p2;

  // link 6 (link6), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_x;
  const Real w6_z = qd[5] + minus_w5_y;
  const Real minus_n6_y_p1 = qd[5] + w6_z;

  // link 6 (link6), inertial wrench
  const Real minus_n6_y = 2e-05 * (w6_x * minus_n6_y_p1 + (c6 * minus_wd4_y + s6 * wd5_x));

  // link 6 (link6), outward
  const Real w6_y = c6 * w5_z + s6 * minus_w5_x;

  // link 6 (link6), inertial wrench
  const Real n6_x = 2e-05 * (w6_y * minus_n6_y_p1 - (s6 * minus_wd4_y - c6 * wd5_x));

  // link 6 (link6), inward
  const Real n5_x = 0.00042216 * minus_f5_z_p1 + 0.0028799999999999997 * minus_a4_y + s6 *
      minus_n6_y + c6 * n6_x;

  // link 5 (link5), outward
  const Real wd5_y = c5 * wd3_y - s5 * wd4_x + qd[4] * minus_w5_x;

  // link 6 (link6), inertial wrench
  const Real minus_n6_z = 4e-05 * wd5_y;
  h[5] = -minus_n6_z;

  // link 6 (link6), inward
  const Real n5_y = minus_n6_z + 2e-04 * (wd5_y + minus_w5_x * w5_z);

  // link 5 (link5), inward
  const Real minus_n4_z = 0.0013999999999999998 * wd3_y + w4_y * (9.999999999999994e-05 * w4_x) +
      c5 * n5_y + s5 * n5_x;
  h[3] = -minus_n4_z;

  // link 4 (link4), inward
  const Real n3_y_p1 = minus_n4_z - (0.010673638499999999 * minus_f3_z_p2 + 0.004704000000000001 *
      f3_y_p4 - 0.0067651125 * minus_f3_z_p4 + 0.025374999999999998 * minus_a3_z);
  const Real n3_y = n3_y_p1 - 0.0203 * minus_f3_z_p1;

  // link 3 (link3), inward
  const Real n2_y_p5 = n2_y_p4 + 0.4318 * minus_f3_z - 0.1501 * (s3 * f3_y - c3 * f3_x) + c3 * n3_y;

  // link 4 (link4), outward
  const Real minus_a4_x = s4 * minus_a4_y_p1 + c4 * minus_a4_y_p2;

  // link 3 (link3), outward
  const Real minus_a3_y = c3 * minus_a3_x_p1 - s3 * minus_a3_x_p2;

  // link 4 (link4), outward
  const Real a4_z = minus_a3_y - 0.4331 * f3_y_p3 + 0.0203 * f3_y_p4;

  // link 5 (link5), outward
  const Real minus_a5_x = s5 * a4_z + c5 * minus_a4_x;

  // link 6 (link6), inward
  const Real minus_n5_z = 0.00062216 * minus_wd4_y + 0.00022215999999999997 * minus_f5_x_p1 +
      0.0028799999999999997 * minus_a5_x + c6 * minus_n6_y - s6 * n6_x;
  h[4] = -minus_n5_z;

  // link 5 (link5), inward
  const Real minus_n4_y = minus_n5_z + 0.00065 * (minus_wd4_y + w4_x * w4_z);

  // link 4 (link4), inward
  const Real n3_x_p1 = 0.004704000000000001 * (f3_x_p2 - f3_y_p2) - 0.010673638499999999 *
      minus_f3_z_p4 + 0.3056901365 * minus_f3_z_p2 + 0.861795 * minus_a3_z;

  // link 5 (link5), inward
  const Real n4_x = 0.0007499999999999999 * (wd4_x + w4_y * w4_z) - s5 * n5_y + c5 * n5_x;

  // link 4 (link4), inward
  const Real n3_x = n3_x_p1 + 0.4331 * minus_f3_z_p1 + s4 * minus_n4_y + c4 * n4_x;

  // link 3 (link3), inward
  const Real n2_y = n2_y_p5 + s3 * n3_x;
  const Real minus_n2_x_p1 = c3 * f3_y + s3 * f3_x;
  const Real minus_n2_x_p2 = 0.023750999999999998 * (minus_a3_z_p1 - n2_y_p2) + 0.690314699 *
      n2_y_p3 + 0.0141984 * wd2_y + 0.14625280000000002 * minus_wd2_x;
  const Real minus_n2_x = minus_n2_x_p2 + 0.1501 * minus_n2_x_p1 + s3 * n3_y - c3 * n3_x;

  // link 2 (link2), inward
  const Real minus_n1_z = c2 * n2_y - s2 * minus_n2_x;
  h[0] = -minus_n1_z;

  // link 4 (link4), inward
  const Real minus_n3_z_p1 = 0.010673638499999999 * (f3_y_p1 - f3_x_p2) - 0.004704000000000001 *
      (wd3_y - minus_f3_z_p3) + 0.298925024 * f3_y_p4 + 0.861795 * minus_a3_x;
  const Real minus_n3_z_p2 = minus_n3_z_p1 - 0.025374999999999998 * minus_a3_y - 0.4331 * f3_x_p1 +
      0.0203 * minus_f4_z + c4 * minus_n4_y;
  const Real minus_n3_z = minus_n3_z_p2 - s4 * n4_x;
  h[2] = -minus_n3_z;

  // link 3 (link3), inward
  const Real minus_n2_z_p1 = 0.0070992 * (n2_y_p1 - minus_a3_z_p1) - 1.601861202 * n2_y_p3 -
      1.024164 * s2 + 37.2347379 * c2;
  const Real minus_n2_z = minus_n3_z + minus_n2_z_p1 - 0.4318 * minus_n2_x_p1;
  h[1] = -minus_n2_z;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
