// nonlinear_effects: h = b + g: the joint forces at qdd = 0
// By recursive Newton-Euler, Chang table 4.1.
// 224 flops (add 87, mul 137, div 0), sine and cosine of 4 angles
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
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real s4 = sines[2];
  const Real c4 = cosines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];

  // link 3 (link3), outward
  const Real w3_z = qd[1] + qd[2];

  // link 1 (link1), outward
  const Real a3_x_p1 = qd[0] * qd[0];

  // link 2 (link2), outward
  const Real a3_x_p2 = qd[1] * qd[1];
  const Real a3_y_p1 = 0.4318 * s2;
  const Real a3_x_p3 = 0.4318 * c2;
  const Real wd2_x = qd[0] * qd[1];
  const Real w4_x_p1 = s2 * c3 + c2 * s3;
  const Real a4_y_p1 = s2 * s3 - c2 * c3;

  // link 3 (link3), outward
  const Real a4_y_p2 = w3_z * w3_z;
  const Real wd3_x = qd[0] * w3_z;

  // link 2 (link2), outward
  const Real minus_a3_z_p1 = 2.0 * wd2_x;

  // link 4 (link4), outward
  const Real w4_x_p2 = w4_x_p1 * qd[0];

  // link 3 (link3), outward
  const Real a4_y_p3 = a3_x_p1 + a4_y_p2;

  // link 4 (link4), outward
  const Real n5_x_p1 = a4_y_p1 * wd3_x;

  // link 3 (link3), outward
  const Real a3_x = (a3_x_p1 + a3_x_p2) * a3_x_p3;
  const Real a3_y = 9.81 + a3_x_p2 * a3_y_p1;
  const Real a4_y_p4 = 2.0 * wd3_x;

  // link 4 (link4), outward
  const Real minus_wd4_z = w4_x_p1 * wd3_x;
  const Real a4_y_p5 = 0.0203 * a4_y_p1 + 0.4331 * w4_x_p1;
  const Real a4_y_p6 = 0.0203 * w4_x_p1 - 0.4331 * a4_y_p1;
  const Real w4_z = qd[3] - a4_y_p1 * qd[0];

  // link 3 (link3), outward
  const Real minus_a3_z = minus_a3_z_p1 * a3_y_p1 + 0.1501 * a3_x_p1;

  // link 4 (link4), outward
  const Real w4_x = s4 * w3_z - c4 * w4_x_p2;
  const Real w4_y = s4 * w4_x_p2 + c4 * w3_z;
  const Real n2_y_p1 = 0.025374999999999998 * a4_y_p1 + 0.861795 * w4_x_p1;
  const Real f3_z_p1 = 0.025374999999999998 * w4_x_p1 - 0.861795 * a4_y_p1;
  const Real n5_x_p2 = w4_x * w4_y;
  const Real a4_y_p7 = a3_x + a4_y_p3 * a4_y_p5;
  const Real a4_y_p8 = a3_y - a4_y_p2 * a4_y_p6;

  // link 5 (link5), outward
  const Real w5_z = w4_y + qd[4];

  // link 4 (link4), outward
  const Real a4_y_p9 = a4_y_p4 * a4_y_p6 - minus_a3_z;
  const Real n2_y_p2 = a4_y_p1 * (0.298925024 * w4_x_p1 + 0.021347276999999998 * a4_y_p1) -
      0.010673638499999999;
  const Real n5_x_p3 = n5_x_p2 + minus_wd4_z;
  const Real n5_x_p4 = c4 * n5_x_p1 + (w4_z + qd[3]) * w4_y;

  // link 5 (link5), outward
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;
  const Real w5_x = c5 * w4_x - s5 * w4_z;
  const Real n5_x_p5 = 2.0 * w5_z;

  // link 4 (link4), outward
  const Real minus_wd4_y = s4 * n5_x_p1 + w4_x * qd[3];
  const Real a4_y_p10 = a4_y_p1 * a4_y_p7 - w4_x_p1 * a4_y_p8;

  // link 5 (link5), outward
  const Real minus_f5_x_p1 = w5_x * minus_w5_y;

  // link 6 (link6), outward
  const Real w6_z = minus_w5_y + qd[5];

  // link 5 (link5), outward
  const Real wd5_y_p1 = w5_x * w5_z;

  // link 4 (link4), outward
  const Real minus_a4_z = w4_x_p1 * a4_y_p7 + a4_y_p1 * a4_y_p8;

  // link 5 (link5), outward
  const Real minus_f5_x_p2 = minus_wd4_y - minus_f5_x_p1;
  const Real n5_x_p6 = s5 * n5_x_p3 + c5 * n5_x_p4 - n5_x_p5 * minus_w5_y;
  const Real wd5_y = c5 * n5_x_p3 - s5 * n5_x_p4 - wd5_y_p1;

  // link 4 (link4), outward
  const Real a4_y = c4 * a4_y_p9 - s4 * a4_y_p10;

  // link 5 (link5), inertial wrench
  const Real minus_f5_x = 0.0028799999999999997 * minus_f5_x_p2;
  const Real f5_y = 0.0028799999999999997 * (w5_x * w5_x + w5_z * w5_z);

  // link 4 (link4), outward
  const Real a4_x = c4 * a4_y_p10 + s4 * a4_y_p9;

  // link 6 (link6), inertial wrench
  const Real minus_n6_z = 4e-05 * wd5_y;
  h[5] = -minus_n6_z;

  // link 5 (link5), inertial wrench
  const Real minus_f5_z = 0.0028799999999999997 * n5_x_p6;
  const Real n2_y_p3 = c2 * (1.601861202 * s2 + 0.0141984 * c2) - 0.0070992;

  // link 6 (link6), inertial wrench
  const Real n6_x = 2e-05 * (n5_x_p6 + n5_x_p5 * w6_z);

  // link 5 (link5), inward
  const Real minus_f4_x = c5 * minus_f5_x + s5 * f5_y;

  // link 5 (link5), outward
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;

  // link 6 (link6), inertial wrench
  const Real minus_n6_y = 2e-05 * (minus_f5_x_p2 + 2.0 * (w5_x * w6_z));

  // link 6 (link6), inward
  const Real n5_y = minus_n6_z - 2e-04 * (wd5_y_p1 - wd5_y);

  // link 5 (link5), inward
  const Real f4_z = s5 * minus_f5_x - c5 * f5_y;

  // link 6 (link6), inward
  const Real n5_x = 0.00042216 * n5_x_p6 - 0.0028799999999999997 * a4_y + n6_x;

  // link 4 (link4), inward
  const Real f3_x_p1 = s4 * minus_f5_z - c4 * minus_f4_x;
  const Real n2_y_p4 = s4 * minus_f4_x + c4 * minus_f5_z;

  // link 6 (link6), inward
  const Real n5_z = 0.00022215999999999997 * minus_f5_x_p1 - 0.00062216 * minus_wd4_y +
      0.0028799999999999997 * a5_x - minus_n6_y;
  h[4] = n5_z;

  // link 4 (link4), inward
  const Real f3_z = a4_y_p4 * f3_z_p1 - n2_y_p4;

  // link 5 (link5), inward
  const Real minus_n4_z = 9.999999999999994e-05 * n5_x_p2 + 0.0014 * minus_wd4_z +
      (s5 * n5_x + c5 * n5_y);
  h[3] = -minus_n4_z;
  const Real n4_x = 0.0007499999999999999 * n5_x_p4 - (s5 * n5_y - c5 * n5_x);
  const Real n4_y = n5_z - 0.00065 * (w4_x * w4_z + minus_wd4_y);

  // link 4 (link4), inward
  const Real f3_x_p2 = a4_y_p1 * f3_x_p1 - w4_x_p1 * f4_z;
  const Real n3_z_p1 = w4_x_p1 * f3_x_p1 + a4_y_p1 * f4_z;
  const Real f3_x = a4_y_p3 * n2_y_p1 + f3_x_p2;
  const Real minus_f3_y = a4_y_p2 * f3_z_p1 + n3_z_p1;

  // link 3 (link3), inward
  const Real n2_y_p5 = a4_y_p1 * minus_n4_z - (a4_y_p4 * n2_y_p2 + n2_y_p1 * minus_a3_z) - a4_y_p5 *
      n2_y_p4 + 0.1501 * f3_x;

  // link 4 (link4), inward
  const Real n3_z = a3_x_p1 * n2_y_p2 - (n2_y_p1 * a3_y + f3_z_p1 * a3_x) +
      (s4 * n4_x + c4 * n4_y + (a4_y_p5 * n3_z_p1 - a4_y_p6 * f3_x_p2));
  h[2] = n3_z;

  // link 3 (link3), inward
  const Real n2_z = a3_x_p1 * n2_y_p3 + 9.81 * (0.10439999999999999 * s2 - 3.79559 * c2) +
      (n3_z + (a3_x_p3 * minus_f3_y + a3_y_p1 * f3_x));
  h[1] = n2_z;
  const Real n2_y_p6 = n2_y_p5 + a3_x_p3 * f3_z - minus_a3_z_p1 * n2_y_p3 - a3_x_p2 *
      (0.023750999999999998 * s2 - 0.690314699 * c2);
  const Real n2_y = n2_y_p6 + (0.004704000000000001 * a4_y_p2 - (c4 * n4_x - s4 * n4_y)) * w4_x_p1;
  h[0] = n2_y;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
