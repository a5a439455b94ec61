// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1.
// 322 flops (add 144, mul 178, div 0), sine and cosine of 5 angles
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
  const Real f5_x_p1 = minus_w5_x * minus_w5_y;

  // link 2 (link2), outward
  const Real minus_wd2_y_p1 = qdd[0] * c2;
  const Real minus_wd2_y_p2 = qd[1] * minus_w2_x;
  const Real minus_wd2_y = minus_wd2_y_p1 - minus_wd2_y_p2;
  const Real minus_wd2_x_p1 = qdd[0] * s2;
  const Real minus_wd2_x_p2 = qd[1] * minus_w2_y;
  const Real minus_wd2_x = minus_wd2_x_p1 + minus_wd2_x_p2;

  // link 3 (link3), outward
  const Real minus_wd3_x = s3 * minus_wd2_y + c3 * minus_wd2_x + qd[2] * minus_w3_y;
  const Real wd3_z = qdd[1] + qdd[2];

  // link 4 (link4), outward
  const Real wd4_y = c4 * wd3_z + s4 * minus_wd3_x - qd[3] * w4_x;

  // link 5 (link5), outward
  const Real wd5_z = qdd[4] + wd4_y;

  // link 5 (link5), inertial wrench
  const Real f5_x = 0.0028799999999999997 * (wd5_z - f5_x_p1);

  // link 5 (link5), inward
  const Real minus_f4_z = c5 * f5_y + s5 * f5_x;

  // link 3 (link3), outward
  const Real f3_y_p1 = minus_w3_x * minus_w3_x;
  const Real f3_y_p2 = w3_z * w3_z;

  // link 4 (link4), outward
  const Real f3_y_p3 = f3_y_p1 + f3_y_p2;

  // link 3 (link3), outward
  const Real f3_y_p4 = minus_w3_x * minus_w3_y;
  const Real f3_y_p5 = wd3_z + f3_y_p4;

  // link 4 (link4), inward
  const Real f3_y = minus_f4_z + (0.861795 * f3_y_p3 - 0.025374999999999998 * f3_y_p5);

  // link 5 (link5), inward
  const Real minus_f4_x = s5 * f5_y - c5 * f5_x;

  // link 3 (link3), outward
  const Real minus_wd3_y = c3 * minus_wd2_y - s3 * minus_wd2_x - qd[2] * minus_w3_x;

  // link 4 (link4), outward
  const Real wd4_z = qdd[3] + minus_wd3_y;
  const Real wd4_x = s4 * wd3_z - c4 * minus_wd3_x + qd[3] * w4_y;

  // link 5 (link5), outward
  const Real minus_wd5_x = s5 * wd4_z - c5 * wd4_x + qd[4] * minus_w5_y;
  const Real f5_z_p1 = minus_wd5_x + minus_w5_y * w5_z;

  // link 5 (link5), inertial wrench
  const Real f5_z = 0.0028799999999999997 * f5_z_p1;

  // link 4 (link4), inward
  const Real minus_f3_x_p1 = s4 * f5_z + c4 * minus_f4_x;

  // link 3 (link3), outward
  const Real minus_f3_x_p2 = wd3_z - f3_y_p4;
  const Real minus_f3_x_p3 = minus_w3_y * minus_w3_y;

  // link 4 (link4), outward
  const Real minus_f3_x_p4 = minus_f3_x_p3 + f3_y_p2;

  // link 4 (link4), inward
  const Real minus_f3_x = minus_f3_x_p1 - (0.861795 * minus_f3_x_p2 + 0.025374999999999998 *
      minus_f3_x_p4);
  const Real f3_z_p1 = c4 * f5_z - s4 * minus_f4_x;

  // link 3 (link3), outward
  const Real f3_z_p2 = minus_wd3_x + minus_w3_y * w3_z;
  const Real f3_z_p3 = minus_w3_x * w3_z;
  const Real f3_z_p4 = minus_wd3_y - f3_z_p3;

  // link 4 (link4), inward
  const Real f3_z = f3_z_p1 + (0.861795 * f3_z_p2 - 0.025374999999999998 * f3_z_p4);

  // link 2 (link2), outward
  const Real n2_y_p1 = minus_w2_x * minus_w2_x;
  const Real n2_y_p2 = qd[1] * qd[1];
  const Real n2_y_p3 = minus_wd2_x_p2 + minus_wd2_x;
  const Real n2_y_p4 = minus_w2_x * minus_w2_y;
  const Real n2_y_p5 = minus_wd2_y_p2 - minus_wd2_y;

  // link 3 (link3), inward
  const Real n2_y_p6 = 0.690314699 * (n2_y_p1 - n2_y_p2) + 0.0070992 * n2_y_p3 -
      0.023750999999999998 * (qdd[1] - n2_y_p4) + 1.674987602 * n2_y_p5;

  // link 2 (link2), outward
  const Real minus_a3_z_p1 = minus_w2_y * minus_w2_y;

  // link 3 (link3), outward
  const Real minus_a3_z = 0.1501 * (n2_y_p1 + minus_a3_z_p1) + 0.4318 * n2_y_p5;

  // link 4 (link4), outward
  const Real minus_a4_y_p1 = minus_a3_z - 0.4331 * f3_z_p2 + 0.0203 * f3_z_p4;

  // link 2 (link2), outward
  const Real minus_a3_x_p1 = qdd[1] + n2_y_p4;

  // link 3 (link3), outward
  const Real minus_a3_x_p2 = 9.81 * c2 - 0.1501 * minus_wd2_x_p1 - 0.4318 * minus_a3_x_p1;
  const Real minus_a3_x_p3 = 9.81 * s2 + 0.1501 * minus_wd2_y_p1 + 0.4318 *
      (minus_a3_z_p1 + n2_y_p2);
  const Real minus_a3_x = s3 * minus_a3_x_p2 + c3 * minus_a3_x_p3;

  // link 4 (link4), outward
  const Real minus_a4_y_p2 = minus_a3_x - 0.4331 * minus_f3_x_p2 - 0.0203 * minus_f3_x_p4;
  const Real minus_a4_y = c4 * minus_a4_y_p1 - s4 * minus_a4_y_p2;

  // link 6 (link6), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_x;
  const Real w6_z = qd[5] + minus_w5_y;
  const Real minus_n6_y_p1 = qd[5] + w6_z;

  // link 6 (link6), inertial wrench
  const Real minus_n6_y = 2e-05 * (w6_x * minus_n6_y_p1 - (c6 * wd5_z + s6 * minus_wd5_x));

  // link 6 (link6), outward
  const Real w6_y = c6 * w5_z + s6 * minus_w5_x;

  // link 6 (link6), inertial wrench
  const Real n6_x = 2e-05 * (w6_y * minus_n6_y_p1 + (s6 * wd5_z - c6 * minus_wd5_x));

  // link 6 (link6), inward
  const Real minus_n5_x = 0.00042216 * f5_z_p1 - 0.0028799999999999997 * minus_a4_y - s6 *
      minus_n6_y - c6 * n6_x;

  // link 5 (link5), outward
  const Real minus_wd5_y = c5 * wd4_z + s5 * wd4_x - qd[4] * minus_w5_x;

  // link 6 (link6), outward
  const Real wd6_z = qdd[5] + minus_wd5_y;

  // link 6 (link6), inertial wrench
  const Real n6_z = 4e-05 * wd6_z;
  tau[5] = n6_z;

  // link 6 (link6), inward
  const Real minus_n5_y = n6_z + 2e-04 * (minus_wd5_y - minus_w5_x * w5_z);

  // link 5 (link5), inward
  const Real n4_z = 0.0013999999999999998 * wd4_z - w4_y * (9.999999999999994e-05 * w4_x) + c5 *
      minus_n5_y + s5 * minus_n5_x;
  tau[3] = n4_z;

  // link 4 (link4), inward
  const Real minus_n3_y_p1 = n4_z - (0.010673638499999999 * f3_z_p2 + 0.004704000000000001 *
      minus_f3_x_p2 - 0.0067651125 * f3_z_p4 - 0.025374999999999998 * minus_a3_z);
  const Real minus_n3_y = minus_n3_y_p1 - 0.0203 * f3_z_p1;

  // link 3 (link3), inward
  const Real n2_y_p7 = n2_y_p6 - 0.4318 * f3_z - 0.1501 * (s3 * f3_y + c3 * minus_f3_x) - c3 *
      minus_n3_y;

  // link 4 (link4), outward
  const Real minus_a4_x = s4 * minus_a4_y_p1 + c4 * minus_a4_y_p2;

  // link 3 (link3), outward
  const Real minus_a3_y = c3 * minus_a3_x_p2 - s3 * minus_a3_x_p3;

  // link 4 (link4), outward
  const Real a4_z = minus_a3_y - 0.4331 * f3_y_p3 + 0.0203 * f3_y_p5;

  // link 5 (link5), outward
  const Real minus_a5_x = s5 * a4_z + c5 * minus_a4_x;

  // link 6 (link6), inward
  const Real n5_z = 0.00062216 * wd5_z - 0.00022215999999999997 * f5_x_p1 - 0.0028799999999999997 *
      minus_a5_x - c6 * minus_n6_y + s6 * n6_x;
  tau[4] = n5_z;

  // link 5 (link5), inward
  const Real n4_y = n5_z + 0.00065 * (wd4_y - w4_x * w4_z);

  // link 4 (link4), inward
  const Real n3_x_p1 = 0.004704000000000001 * (minus_f3_x_p3 - f3_y_p2) + 0.010673638499999999 *
      f3_z_p4 - 0.3056901365 * f3_z_p2 + 0.861795 * minus_a3_z;

  // link 5 (link5), inward
  const Real n4_x = 0.0007499999999999999 * (wd4_x + w4_y * w4_z) + s5 * minus_n5_y - c5 *
      minus_n5_x;

  // link 4 (link4), inward
  const Real n3_x = n3_x_p1 - 0.4331 * f3_z_p1 - s4 * n4_y + c4 * n4_x;

  // link 3 (link3), inward
  const Real n2_y = n2_y_p7 + s3 * n3_x;
  const Real minus_n2_x_p1 = c3 * f3_y - s3 * minus_f3_x;
  const Real minus_n2_x_p2 = 0.023750999999999998 * (minus_a3_z_p1 - n2_y_p2) + 0.690314699 *
      minus_a3_x_p1 + 0.0070992 * n2_y_p5 + 0.07312640000000001 * n2_y_p3;
  const Real minus_n2_x = minus_n2_x_p2 + 0.1501 * minus_n2_x_p1 - s3 * minus_n3_y - c3 * n3_x;

  // link 2 (link2), inward
  const Real n1_z = 1.4717295504999999 * qdd[0] - c2 * n2_y + s2 * minus_n2_x;
  tau[0] = n1_z;

  // link 4 (link4), inward
  const Real minus_n3_z_p1 = 0.010673638499999999 * (f3_y_p1 - minus_f3_x_p3) +
      0.004704000000000001 * (minus_wd3_y + f3_z_p3) - 0.312455249 * wd3_z + 0.298925024 * f3_y_p4;
  const Real minus_n3_z_p2 = minus_n3_z_p1 + 0.861795 * minus_a3_x - 0.025374999999999998 *
      minus_a3_y + 0.4331 * minus_f3_x_p1 + 0.0203 * minus_f4_z;
  const Real minus_n3_z = minus_n3_z_p2 - c4 * n4_y - s4 * n4_x;
  tau[2] = -minus_n3_z;

  // link 3 (link3), inward
  const Real minus_n2_z_p1 = 0.0070992 * (n2_y_p1 - minus_a3_z_p1) - 0.023750999999999998 *
      minus_wd2_y_p1 - 0.690314699 * minus_wd2_x_p1 - 1.7481140020000001 * qdd[1];
  const Real minus_n2_z = minus_n3_z + (minus_n2_z_p1 - 1.601861202 * n2_y_p4 - 1.024164 * s2 +
      37.2347379 * c2) - 0.4318 * minus_n2_x_p1;
  tau[1] = -minus_n2_z;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
