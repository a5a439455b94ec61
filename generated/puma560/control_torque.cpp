// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J
//   qdd_0)
// By resolved acceleration, spherical wrist, by pivots, J in the axes of link 1 (link1) and the
//   axes of link 5 (link5).
// 468 flops (add 191, mul 274, div 3), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void control_torque(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&/*qdd_0*/)[6], const Real (&TREELINE_RESTRICT xdd_cmd)[6],
    Real (&TREELINE_RESTRICT tau)[6]) noexcept {
  const Real angles[5] = {q[1], q[2], q[0], q[4], q[3]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real s3 = sines[1];
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real c1 = cosines[2];
  const Real s1 = sines[2];
  const Real c5 = cosines[3];
  const Real s4 = sines[4];
  const Real c4 = cosines[4];
  const Real s5 = sines[3];

  // link 3 (link3), outward
  const Real w3_z = qd[1] + qd[2];
  const Real a3_y_p1 = 0.4318 * s2;

  // link 1 (link1), outward
  const Real a3_x_p1 = qd[0] * qd[0];

  // link 2 (link2), outward
  const Real a3_x_p2 = qd[1] * qd[1];
  const Real a3_x_p3 = 0.4318 * c2;
  const Real wd2_x = qd[0] * qd[1];

  // link 5 (link5), pose
  const Real wd2_z_p1 = c5 * s4;
  const Real w4_y_p1 = s2 * c3 + c2 * s3;
  const Real a4_x_p1 = s2 * s3 - c2 * c3;

  // link 3 (link3), outward
  const Real a4_x_p2 = w3_z * w3_z;
  const Real wd3_x = qd[0] * w3_z;

  // link 2 (link2), outward
  const Real minus_a3_z_p1 = 2.0 * wd2_x;

  // link 5 (link5), pose
  const Real wd2_z_p2 = s5 * s4;

  // link 4 (link4), outward
  const Real w4_y_p2 = w4_y_p1 * qd[0];

  // link 3 (link3), outward
  const Real a4_x_p3 = a3_x_p1 + a4_x_p2;
  const Real a3_x = (a3_x_p1 + a3_x_p2) * a3_x_p3;

  // link 4 (link4), outward
  const Real wd6_x_p1 = a4_x_p1 * wd3_x;

  // link 3 (link3), outward
  const Real a3_y = 9.81 + a3_x_p2 * a3_y_p1;
  const Real a4_x_p4 = 2.0 * wd3_x;

  // link 4 (link4), outward
  const Real minus_wd4_z = w4_y_p1 * wd3_x;

  // link 4 (link4), pose
  const Real wd1_z_p1 = c4 * a4_x_p1;
  const Real wd1_z_p2 = c4 * w4_y_p1;
  const Real a4_x_p5 = 0.0203 * w4_y_p1 - 0.4331 * a4_x_p1;
  const Real a4_x_p6 = 0.0203 * a4_x_p1 + 0.4331 * w4_y_p1;

  // link 4 (link4), outward
  const Real w4_z = qd[3] - a4_x_p1 * qd[0];

  // link 4 (link4), pose
  const Real wd1_z_p3 = s4 * a4_x_p1;
  const Real wd1_z_p4 = s4 * w4_y_p1;

  // link 4 (link4), outward
  const Real a4_x_p7 = a4_x_p2 * a4_x_p5;
  const Real a4_x_p8 = a4_x_p4 * a4_x_p5;

  // link 3 (link3), outward
  const Real minus_a3_z = minus_a3_z_p1 * a3_y_p1 + 0.1501 * a3_x_p1;

  // link 4 (link4), outward
  const Real w4_y = s4 * w4_y_p2 + c4 * w3_z;
  const Real a4_x_p9 = a4_x_p3 * a4_x_p6;
  const Real w4_x = s4 * w3_z - c4 * w4_y_p2;

  // link 3 (link3), Jacobian
  const Real wd1_z_p5 = a4_x_p6 + a3_x_p3;

  // link 4 (link4), pose
  const Real wd2_z_p3 = a4_x_p5 - a3_y_p1;

  // link 4 (link4), outward
  const Real a4_x_p10 = a3_y - a4_x_p7;
  const Real a4_x_p11 = a3_x + a4_x_p9;
  const Real wd6_x_p2 = w4_x * w4_y;

  // link 5 (link5), outward
  const Real w5_z = w4_y + qd[4];

  // link 4 (link4), outward
  const Real a4_x_p12 = a4_x_p8 - minus_a3_z;
  const Real minus_wd4_y_p1 = w4_x * qd[3];

  // link 1 (link1), Jacobian
  const Real wd1_z_p6 = wd1_z_p5 * wd1_z_p5;

  // link 5 (link5), pose
  const Real wd1_z_p7 = c5 * wd1_z_p1 + s5 * w4_y_p1;
  const Real wd1_z_p8 = s5 * a4_x_p1 - c5 * wd1_z_p2;
  const Real wd1_z_p9 = s5 * wd1_z_p1 - c5 * w4_y_p1;

  // link 4 (link4), outward
  const Real wd6_x_p3 = w4_y * w4_z + w4_y * qd[3];

  // link 5 (link5), outward
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;

  // link 4 (link4), outward
  const Real wd6_x_p4 = wd6_x_p2 + minus_wd4_z;

  // link 5 (link5), outward
  const Real w5_x = c5 * w4_x - s5 * w4_z;

  // link 4 (link4), outward
  const Real minus_wd4_y = s4 * wd6_x_p1 + minus_wd4_y_p1;

  // link 1 (link1), Jacobian
  const Real wd1_z_p10 = wd1_z_p6 * wd1_z_p6;

  // link 5 (link5), pose
  const Real wd1_z_p11 = s5 * wd1_z_p2 + c5 * a4_x_p1;

  // link 4 (link4), outward
  const Real wd6_x_p5 = wd6_x_p3 + c4 * wd6_x_p1;

  // link 6 (link6), outward
  const Real w6_z = minus_w5_y + qd[5];

  // link 4 (link4), outward
  const Real a4_x_p13 = a4_x_p1 * a4_x_p11 - w4_y_p1 * a4_x_p10;

  // link 5 (link5), outward
  const Real minus_wd6_y_p1 = w5_x * minus_w5_y;

  // link 4 (link4), outward
  const Real minus_a4_z = w4_y_p1 * a4_x_p11 + a4_x_p1 * a4_x_p10;

  // link 5 (link5), outward
  const Real wd5_y_p1 = w5_x * w5_z;

  // link 6 (link6), outward
  const Real minus_wd6_y_p2 = w5_x * w6_z;
  const Real wd6_x_p6 = w5_z * w6_z;

  // link 5 (link5), outward
  const Real wd6_x_p7 = 2.0 * (minus_w5_y * w5_z);
  const Real minus_wd6_y_p3 = minus_wd4_y - minus_wd6_y_p1;
  const Real wd1_z_p12 = w5_x * w5_x + w5_z * w5_z;

  // link 6 (link6), pose
  const Real wd1_z_p13 = 0.05625 * wd1_z_p11;
  const Real wd1_z_p14 = 0.05625 * wd1_z_p9;

  // link 4 (link4), outward
  const Real a4_x = c4 * a4_x_p13 + s4 * a4_x_p12;

  // link 6 (link6), outward
  const Real minus_wd6_y = minus_wd6_y_p3 + minus_wd6_y_p2;

  // link 4 (link4), outward
  const Real a4_y = c4 * a4_x_p12 - s4 * a4_x_p13;

  // link 1 (link1), Jacobian
  const Real wd2_z_p4 = wd2_z_p3 * a4_x_p6 - wd1_z_p5 * a4_x_p5;

  // link 5 (link5), outward
  const Real wd6_x_p8 = s5 * wd6_x_p4 + c5 * wd6_x_p5 - wd6_x_p7;
  const Real wd5_y = c5 * wd6_x_p4 - s5 * wd6_x_p5 - wd5_y_p1;

  // link 6 (link6), pose
  const Real wd2_z_p5 = 0.05625 * wd2_z_p2;

  // link 1 (link1), Jacobian
  const Real wd2_z_p6 = wd2_z_p4 * wd2_z_p4;

  // link 6 (link6), outward
  const Real wd6_x = wd6_x_p6 + wd6_x_p8;

  // link 5 (link5), outward
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;
  const Real a5_y = c5 * minus_a4_z - s5 * a4_x;

  // link 1 (link1), Jacobian
  const Real minus_wd4_z_p1 = s5 * s5;
  const Real wd2_z_p7 = wd2_z_p6 * wd2_z_p6;

  // link 6 (link6), pose
  const Real wd1_z_p15 = a4_y - 0.05625 * wd6_x_p8;
  const Real wd1_z_p16 = a5_x - 0.05625 * minus_wd6_y_p3;
  const Real wd1_z_p17 = a5_y + 0.05625 * wd1_z_p12;

  // link 1 (link1), Jacobian
  const Real minus_wd4_z_p2 = minus_wd4_z_p1 * minus_wd4_z_p1;

  // link 6 (link6), pose
  const Real wd1_z_p18 = xdd_cmd[5] - (wd1_z_p8 * wd6_x - wd1_z_p4 * minus_wd6_y + wd1_z_p11 *
      wd5_y);
  const Real wd1_z_p19 = c1 * xdd_cmd[3] + s1 * xdd_cmd[4] -
      (wd1_z_p9 * wd5_y - (wd1_z_p7 * wd6_x + wd1_z_p3 * minus_wd6_y));
  const Real wd2_z_p8 = c1 * xdd_cmd[4] - s1 * xdd_cmd[3] -
      (wd2_z_p1 * wd6_x - c4 * minus_wd6_y - wd2_z_p2 * wd5_y);
  const Real wd1_z_p20 = c1 * xdd_cmd[1] - s1 * xdd_cmd[0] -
      (wd2_z_p1 * wd1_z_p16 + c4 * wd1_z_p15 - wd2_z_p2 * wd1_z_p17);
  const Real wd2_z_p9 = c1 * xdd_cmd[0] + s1 * xdd_cmd[1] -
      (wd1_z_p3 * wd1_z_p15 - wd1_z_p7 * wd1_z_p16 + wd1_z_p9 * wd1_z_p17);
  const Real n1_z_p1 = 1.601861202 * s2 + 0.0141984 * c2;
  const Real n1_z_p2 = 0.690314699 * s2 + 0.023750999999999998 * c2;
  const Real n1_z_p3 = 0.004704000000000001 * a4_x_p1;

  // link 5 (link5), inertial wrench
  const Real f5_y = 0.0028799999999999997 * wd1_z_p12;
  const Real n1_z_p4 = 0.298925024 * w4_y_p1 + 0.021347276999999998 * a4_x_p1;

  // link 6 (link6), pose
  const Real wd2_z_p10 = 9.81 + xdd_cmd[2] - (wd1_z_p8 * wd1_z_p16 + wd1_z_p4 * wd1_z_p15 +
      wd1_z_p11 * wd1_z_p17) - (wd1_z_p19 * wd2_z_p5 + wd2_z_p8 * wd1_z_p14);

  // link 1 (link1), Jacobian
  const Real wd1_z = wd1_z_p10 * (wd1_z_p6 * wd1_z_p5) /
      (3.2311742677852644e-27 + wd1_z_p10 * wd1_z_p10) *
      (wd1_z_p20 - (wd1_z_p19 * wd1_z_p13 - wd1_z_p18 * wd1_z_p14));
  const Real n1_z_p5 = c2 * n1_z_p1 - 0.0070992;
  const Real f3_x_p1 = 0.025374999999999998 * a4_x_p1 + 0.861795 * w4_y_p1;
  const Real wd2_z_p11 = 0.1501 * wd1_z;
  const Real minus_wd4_z_p3 = wd1_z_p18 - wd1_z;
  const Real n1_z_p6 = a4_x_p1 * n1_z_p4 - 0.010673638499999999;
  const Real f3_z_p1 = 0.025374999999999998 * w4_y_p1 - 0.861795 * a4_x_p1;
  const Real wd2_z_p12 = wd2_z_p9 + (wd2_z_p8 * wd1_z_p13 + wd1_z_p18 * wd2_z_p5) + wd2_z_p11;

  // link 4 (link4), outward
  const Real wd5_y_p2 = wd6_x_p1 - w4_y_p1 * wd1_z;

  // link 3 (link3), outward
  const Real a3_z = wd1_z * a3_x_p3 - minus_a3_z;

  // link 1 (link1), Jacobian
  const Real minus_wd4_z_p4 = a4_x_p1 * wd1_z_p19 + w4_y_p1 * minus_wd4_z_p3;
  const Real minus_wd4_z_p5 = a4_x_p1 * minus_wd4_z_p3 - w4_y_p1 * wd1_z_p19;

  // link 4 (link4), outward
  const Real a4_y_p1 = a3_z + (wd1_z * a4_x_p6 + a4_x_p8);

  // link 1 (link1), Jacobian
  const Real wd2_z = wd2_z_p7 * (wd2_z_p6 * wd2_z_p4) /
      (4.930380657631324e-32 + wd2_z_p7 * wd2_z_p7) * (wd2_z_p10 * a4_x_p5 + wd2_z_p12 * a4_x_p6);

  // link 3 (link3), outward
  const Real a3_y_2 = a3_y - wd2_z * a3_x_p3;
  const Real a3_x_2 = a3_x + wd2_z * a3_y_p1 + wd2_z_p11;

  // link 2 (link2), inward
  const Real n1_z_p7 = wd2_z * n1_z_p2 - minus_a3_z_p1 * n1_z_p5 - a3_x_p2 *
      (0.023750999999999998 * s2 - 0.690314699 * c2);

  // link 1 (link1), Jacobian
  const Real wd3_z_p1 = 5.319496967088805 * ((wd2_z_p12 - wd2_z_p3 * wd2_z) * a4_x_p5 -
      (wd2_z_p10 + wd1_z_p5 * wd2_z) * a4_x_p6);

  // link 3 (link3), outward
  const Real wd3_z = wd2_z + wd3_z_p1;

  // link 1 (link1), Jacobian
  const Real minus_wd4_z_p6 = wd2_z_p8 - wd3_z;

  // link 4 (link4), outward
  const Real wd5_y_p3 = wd6_x_p3 + c4 * wd5_y_p2 + s4 * wd3_z;

  // link 1 (link1), Jacobian
  const Real minus_wd4_z_p7 = s4 * minus_wd4_z_p6 - c4 * minus_wd4_z_p4;

  // link 4 (link4), outward
  const Real a4_y_p2 = a3_x_2 + (a4_x_p9 - wd3_z * a4_x_p5);
  const Real a4_y_p3 = a3_y_2 - (wd3_z * a4_x_p6 + a4_x_p7);
  const Real wd4_y = c4 * wd3_z - s4 * wd5_y_p2 - minus_wd4_y_p1;

  // link 5 (link5), outward
  const Real wd5_z = wd4_y + (s4 * minus_wd4_z_p4 + c4 * minus_wd4_z_p6);

  // link 3 (link3), inertial wrench
  const Real n3_z_p1 = 0.312455249 * wd3_z + wd1_z * n1_z_p3 + a3_x_p1 * n1_z_p6 -
      (f3_x_p1 * a3_y_2 + f3_z_p1 * a3_x_2);

  // link 4 (link4), outward
  const Real a4_y_p4 = a4_x_p1 * a4_y_p2 - w4_y_p1 * a4_y_p3;

  // link 5 (link5), outward
  const Real f5_x_p1 = minus_wd6_y_p1 + wd5_z;

  // link 4 (link4), outward
  const Real minus_a4_z_2 = w4_y_p1 * a4_y_p2 + a4_x_p1 * a4_y_p3;

  // link 1 (link1), Jacobian
  const Real minus_wd4_z_p8 = minus_wd4_z_p2 * (minus_wd4_z_p1 * s5) /
      (8.271806125530277e-25 + minus_wd4_z_p2 * minus_wd4_z_p2) *
      (c5 * minus_wd4_z_p7 + s5 * minus_wd4_z_p5);

  // link 5 (link5), inertial wrench
  const Real f5_x = 0.0028799999999999997 * f5_x_p1;

  // link 2 (link2), inertial wrench
  const Real n2_z_p1 = 1.7481140020000001 * wd2_z + wd1_z * n1_z_p2 + a3_x_p1 * n1_z_p5 + 9.81 *
      (0.10439999999999999 * s2 - 3.79559 * c2);

  // link 4 (link4), outward
  const Real minus_wd4_z_2 = minus_wd4_z + a4_x_p1 * wd1_z + minus_wd4_z_p8;
  const Real a4_y_2 = c4 * a4_y_p1 - s4 * a4_y_p4;
  const Real a4_x_2 = c4 * a4_y_p4 + s4 * a4_y_p1;

  // link 6 (link6), inertial wrench
  const Real minus_n6_y = 2e-05 * (2.0 * minus_wd6_y_p2 - f5_x_p1);

  // link 4 (link4), outward
  const Real wd5_y_p4 = wd6_x_p2 + minus_wd4_z_2;

  // link 5 (link5), inward
  const Real minus_f4_x = s5 * f5_y - c5 * f5_x;
  const Real minus_f4_z = s5 * f5_x + c5 * f5_y;

  // link 5 (link5), outward
  const Real a5_x_2 = c5 * a4_x_2 + s5 * minus_a4_z_2;
  const Real wd5_y_2 = c5 * wd5_y_p4 - s5 * wd5_y_p3 - wd5_y_p1;
  const Real n5_x_p1 = s5 * wd5_y_p4 + c5 * wd5_y_p3 - wd6_x_p7;

  // link 5 (link5), inertial wrench
  const Real minus_f5_z = 0.0028799999999999997 * n5_x_p1;

  // link 6 (link6), inward
  const Real n5_z = 0.00022215999999999997 * minus_wd6_y_p1 + 0.00062216 * wd5_z +
      0.0028799999999999997 * a5_x_2 - minus_n6_y;
  tau[4] = n5_z;

  // link 6 (link6), outward
  const Real minus_wd6_z = wd5_y_2 - s5 * minus_wd4_z_p7 + (minus_wd4_z_p5 - minus_wd4_z_p8) * c5;

  // link 6 (link6), inertial wrench
  const Real n6_x = 2e-05 * (n5_x_p1 + 2.0 * wd6_x_p6);

  // link 5 (link5), inward
  const Real n4_y = n5_z - 0.00065 * (w4_x * w4_z - wd4_y);

  // link 6 (link6), inertial wrench
  const Real minus_n6_z = 4e-05 * minus_wd6_z;
  tau[5] = -minus_n6_z;

  // link 6 (link6), inward
  const Real n5_x = 0.00042216 * n5_x_p1 - 0.0028799999999999997 * a4_y_2 + n6_x;

  // link 4 (link4), inward
  const Real f3_x_p2 = s4 * minus_f5_z - c4 * minus_f4_x;
  const Real n1_z_p8 = s4 * minus_f4_x + c4 * minus_f5_z;

  // link 6 (link6), inward
  const Real n5_y = minus_n6_z - 2e-04 * (wd5_y_p1 - wd5_y_2);

  // link 4 (link4), inward
  const Real f3_z = wd1_z * f3_x_p1 + a4_x_p4 * f3_z_p1 - n1_z_p8;
  const Real f3_x_p3 = a4_x_p1 * f3_x_p2 + w4_y_p1 * minus_f4_z;
  const Real n3_z_p2 = a4_x_p1 * minus_f4_z - w4_y_p1 * f3_x_p2;
  const Real f3_x = a4_x_p3 * f3_x_p1 - wd3_z * f3_z_p1 + f3_x_p3;
  const Real f3_y = n3_z_p2 - (wd3_z * f3_x_p1 + a4_x_p2 * f3_z_p1);

  // link 5 (link5), inward
  const Real minus_n4_z = 9.999999999999994e-05 * wd6_x_p2 + 0.0014 * minus_wd4_z_2 +
      (s5 * n5_x + c5 * n5_y);
  tau[3] = -minus_n4_z;
  const Real n4_x = 0.0007499999999999999 * wd5_y_p3 - (s5 * n5_y - c5 * n5_x);

  // link 2 (link2), inward
  const Real n1_z_p9 = n1_z_p7 + wd3_z * n1_z_p3 - a4_x_p4 * n1_z_p6 + f3_x_p1 * a3_z + a4_x_p1 *
      minus_n4_z;

  // link 4 (link4), inward
  const Real n3_z = n3_z_p1 + (s4 * n4_x + c4 * n4_y - (a4_x_p6 * n3_z_p2 + a4_x_p5 * f3_x_p3));
  tau[2] = n3_z;

  // link 2 (link2), inward
  const Real n1_z_p10 = n1_z_p9 - a4_x_p6 * n1_z_p8 + 0.1501 * f3_x + a3_x_p3 * f3_z +
      (0.004704000000000001 * a4_x_p2 - (c4 * n4_x - s4 * n4_y)) * w4_y_p1;

  // link 3 (link3), inward
  const Real n2_z = n2_z_p1 + (n3_z + (a3_y_p1 * f3_x - a3_x_p3 * f3_y));
  tau[1] = n2_z;

  // link 2 (link2), inward
  const Real n1_z = n1_z_p10 + (3.1467171525 - s2 * n1_z_p1 + (0.0067651125 + w4_y_p1 * n1_z_p4)) *
      wd1_z;
  tau[0] = n1_z;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
