// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
// By resolved acceleration, spherical wrist, J in the axes of link 1 (link1).
// 577 flops (add 245, mul 330, div 2), sine and cosine of 6 angles
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

void control_torque(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&/*qdd_0*/)[6], const Real (&TREELINE_RESTRICT xdd_cmd)[6],
    Real (&TREELINE_RESTRICT tau)[6]) noexcept {
  const Real angles[6] = {q[0], q[5], q[4], q[3], q[2], q[1]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c1 = cosines[0];
  const Real s1 = sines[0];
  const Real c6 = cosines[1];
  const Real c5 = cosines[2];
  const Real s4 = sines[3];
  const Real s6 = sines[1];
  const Real c4 = cosines[3];
  const Real s3 = sines[4];
  const Real s2 = sines[5];
  const Real c2 = cosines[5];
  const Real c3 = cosines[4];
  const Real s5 = sines[2];

  // link 2 (link2), outward
  const Real minus_w2_x = s2 * qd[0];
  const Real minus_w2_y = c2 * qd[0];
  const Real a3_x_p1 = qd[1] * qd[1];

  // link 3 (link3), outward
  const Real w3_z = qd[1] + qd[2];

  // link 2 (link2), outward
  const Real minus_a2_y = 9.81 * c2;
  const Real minus_a2_x = 9.81 * s2;

  // link 3 (link3), outward
  const Real a4_x_p1 = w3_z * w3_z;

  // link 2 (link2), outward
  const Real minus_wd2_x = minus_w2_y * qd[1];
  const Real wd2_y = minus_w2_x * qd[1];
  const Real a3_x_p2 = minus_w2_y * minus_w2_y;
  const Real a3_x_p3 = minus_w2_x * minus_w2_y;
  const Real minus_a3_z_p1 = minus_w2_x * minus_w2_x;

  // link 3 (link3), pose
  const Real wd2_z_p1 = s3 * s2 - c3 * c2;
  const Real wd2_z_p2 = c3 * s2 + s3 * c2;

  // link 3 (link3), outward
  const Real w3_y = s3 * minus_w2_x - c3 * minus_w2_y;
  const Real minus_w3_x = c3 * minus_w2_x + s3 * minus_w2_y;
  const Real wd3_y_p1 = minus_w3_x * qd[2];
  const Real wd3_x_p1 = w3_y * qd[2];
  const Real a4_x_p2 = w3_y * w3_y;
  const Real a4_x_p3 = minus_w3_x * w3_z;
  const Real a4_x_p4 = w3_y * w3_z;
  const Real a4_x_p5 = minus_w3_x * w3_y;

  // link 4 (link4), outward
  const Real w4_z = qd[3] - w3_y;

  // link 3 (link3), outward
  const Real a3_x_p4 = 0.4318 * a3_x_p3 - minus_a2_y;
  const Real minus_a3_z_p2 = 0.1501 * (minus_a3_z_p1 + a3_x_p2);
  const Real minus_a4_z_p1 = minus_w3_x * minus_w3_x;

  // link 4 (link4), pose
  const Real wd2_z_p3 = c4 * wd2_z_p1;

  // link 4 (link4), outward
  const Real w4_y = s4 * minus_w3_x + c4 * w3_z;
  const Real a4_x_p6 = a4_x_p2 + a4_x_p1;

  // link 4 (link4), pose
  const Real wd2_z_p4 = s4 * wd2_z_p1;

  // link 3 (link3), outward
  const Real wd3_y = s3 * minus_wd2_x + c3 * wd2_y + wd3_y_p1;
  const Real wd3_x = s3 * wd2_y - c3 * minus_wd2_x + wd3_x_p1;

  // link 4 (link4), outward
  const Real w4_x = s4 * w3_z - c4 * minus_w3_x;

  // link 3 (link3), outward
  const Real a3_x_p5 = minus_a2_x + 0.4318 * (a3_x_p2 + a3_x_p1);

  // link 4 (link4), outward
  const Real wd4_x_p1 = w4_y * qd[3];
  const Real a4_x_p7 = 0.0203 * a4_x_p6;

  // link 3 (link3), outward
  const Real minus_a3_z = 0.8636 * wd2_y + minus_a3_z_p2;

  // link 4 (link4), outward
  const Real minus_a4_z_p2 = minus_a4_z_p1 + a4_x_p1;
  const Real minus_a4_z_p3 = 0.4331 * minus_a4_z_p2;

  // link 5 (link5), outward
  const Real w5_z = w4_y + qd[4];

  // link 4 (link4), outward
  const Real wd4_x = c4 * wd3_x + wd4_x_p1;

  // link 5 (link5), outward
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;

  // link 4 (link4), outward
  const Real minus_wd4_y_p1 = w4_x * qd[3];

  // link 4 (link4), pose
  const Real wd2_z_p5 = c4 * wd2_z_p2;

  // link 3 (link3), outward
  const Real a3_x = s3 * a3_x_p4 - c3 * a3_x_p5;

  // link 5 (link5), outward
  const Real w5_x = c5 * w4_x - s5 * w4_z;

  // link 3 (link3), outward
  const Real a3_y = s3 * a3_x_p5 + c3 * a3_x_p4;

  // link 5 (link5), outward
  const Real wd5_x_p1 = minus_w5_y * qd[4];

  // link 5 (link5), pose
  const Real wd2_z_p6 = c5 * s4;

  // link 4 (link4), outward
  const Real a4_x_p8 = a3_x + (a4_x_p7 + 0.4331 * a4_x_p5);
  const Real minus_wd4_y = s4 * wd3_x + minus_wd4_y_p1;
  const Real minus_a4_z = a3_y + (0.0203 * a4_x_p5 + minus_a4_z_p3);

  // link 4 (link4), pose
  const Real wd2_z_p7 = s4 * wd2_z_p2;

  // link 6 (link6), outward
  const Real w6_z = minus_w5_y + qd[5];

  // link 4 (link4), outward
  const Real a4_x_p9 = 0.0203 * (a4_x_p3 + wd3_y) - 0.4331 * (a4_x_p4 + wd3_x) - minus_a3_z;

  // link 5 (link5), pose
  const Real wd2_z_p8 = c5 * wd2_z_p3 + s5 * wd2_z_p2;

  // link 6 (link6), outward
  const Real w6_x = c6 * w5_x + s6 * w5_z;
  const Real w6_y = c6 * w5_z - s6 * w5_x;

  // link 5 (link5), pose
  const Real wd2_z_p9 = s5 * wd2_z_p1 - c5 * wd2_z_p5;

  // link 5 (link5), outward
  const Real wd5_x = c5 * wd4_x + s5 * wd3_y - wd5_x_p1;

  // link 6 (link6), outward
  const Real minus_wd6_y_p1 = w6_x * qd[5];
  const Real wd6_x_p1 = w6_y * qd[5];
  const Real wd2_z_p10 = w6_x * w6_z;
  const Real wd2_z_p11 = w6_y * w6_z;

  // link 4 (link4), outward
  const Real a4_x = c4 * a4_x_p8 + s4 * a4_x_p9;
  const Real a4_y = c4 * a4_x_p9 - s4 * a4_x_p8;

  // link 5 (link5), outward
  const Real wd5_y_p1 = w5_x * qd[4];

  // link 6 (link6), pose
  const Real wd2_z_p12 = s6 * wd2_z_p4 - c6 * wd2_z_p8;
  const Real wd2_z_p13 = s6 * wd2_z_p8 + c6 * wd2_z_p4;
  const Real wd2_z_p14 = c6 * wd2_z_p6 + s6 * c4;
  const Real wd2_z_p15 = c6 * c4 - s6 * wd2_z_p6;
  const Real wd2_z_p16 = c6 * wd2_z_p9 + s6 * wd2_z_p7;
  const Real wd2_z_p17 = c6 * wd2_z_p7 - s6 * wd2_z_p9;

  // link 5 (link5), pose
  const Real wd2_z_p18 = s5 * s4;

  // link 5 (link5), outward
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;

  // link 6 (link6), outward
  const Real minus_wd6_y = s6 * wd5_x + c6 * minus_wd4_y + minus_wd6_y_p1;
  const Real wd6_x = c6 * wd5_x - s6 * minus_wd4_y + wd6_x_p1;

  // link 5 (link5), pose
  const Real wd2_z_p19 = c5 * wd2_z_p2 - s5 * wd2_z_p3;

  // link 5 (link5), outward
  const Real wd5_y = c5 * wd3_y - s5 * wd4_x - wd5_y_p1;

  // link 5 (link5), pose
  const Real wd2_z_p20 = s5 * wd2_z_p5 + c5 * wd2_z_p1;

  // link 6 (link6), outward
  const Real a6_x = c6 * a5_x + s6 * a4_y;
  const Real a6_y = c6 * a4_y - s6 * a5_x;

  // link 4 (link4), pose
  const Real wd1_z_p1 = 0.4331 * wd2_z_p2 + 0.0203 * wd2_z_p1;
  const Real wd1_z_p2 = 0.0203 * wd2_z_p2 - 0.4331 * wd2_z_p1;

  // link 5 (link5), outward
  const Real a5_y = c5 * minus_a4_z - s5 * a4_x;

  // link 6 (link6), outward
  const Real wd2_z_p21 = a6_x + 0.05625 * (wd2_z_p10 - minus_wd6_y);
  const Real wd2_z_p22 = a6_y + 0.05625 * (wd2_z_p11 - wd6_x);

  // link 3 (link3), Jacobian
  const Real wd1_z_p3 = wd1_z_p1 + 0.4318 * c2;

  // link 6 (link6), outward
  const Real wd2_z_p23 = 0.05625 * wd2_z_p20;
  const Real wd2_z_p24 = 0.05625 * wd2_z_p18;

  // link 4 (link4), pose
  const Real wd1_z_p4 = wd1_z_p2 - 0.4318 * s2;

  // link 6 (link6), outward
  const Real wd2_z_p25 = a5_y + 0.05625 * (w6_x * w6_x + w6_y * w6_y);
  const Real wd2_z_p26 = 0.05625 * wd2_z_p19;
  const Real wd2_z_p27 = c1 * xdd_cmd[4] - s1 * xdd_cmd[3] -
      (wd2_z_p14 * wd6_x - wd2_z_p15 * minus_wd6_y - wd2_z_p18 * wd5_y);
  const Real wd2_z_p28 = xdd_cmd[5] - (wd2_z_p16 * wd6_x - wd2_z_p17 * minus_wd6_y + wd2_z_p20 *
      wd5_y);
  const Real wd2_z_p29 = c1 * xdd_cmd[3] + s1 * xdd_cmd[4] -
      (wd2_z_p12 * wd6_x - wd2_z_p13 * minus_wd6_y - wd2_z_p19 * wd5_y);

  // link 1 (link1), Jacobian
  const Real wd1_z_p5 = wd1_z_p4 * wd1_z_p1 - wd1_z_p3 * wd1_z_p2;

  // link 6 (link6), outward
  const Real wd2_z_p30 = c1 * xdd_cmd[0] + s1 * xdd_cmd[1] -
      (wd2_z_p12 * wd2_z_p21 + wd2_z_p13 * wd2_z_p22 - wd2_z_p19 * wd2_z_p25);
  const Real wd2_z_p31 = c1 * xdd_cmd[1] - s1 * xdd_cmd[0] -
      (wd2_z_p14 * wd2_z_p21 + wd2_z_p15 * wd2_z_p22 - wd2_z_p18 * wd2_z_p25);

  // link 1 (link1), Jacobian
  const Real wd1_z_p6 = 1.0 / (wd1_z_p3 * wd1_z_p5);
  const Real wd4_z_p1 = c4 * wd2_z_p20 + wd2_z_p7 * wd2_z_p18;

  // link 6 (link6), outward
  const Real wd2_z_p32 = wd2_z_p31 - (wd2_z_p28 * wd2_z_p26 + wd2_z_p29 * wd2_z_p23);

  // link 1 (link1), Jacobian
  const Real wd4_z_p2 = c4 * wd2_z_p19 - wd2_z_p4 * wd2_z_p18;

  // link 6 (link6), outward
  const Real wd2_z_p33 = 9.81 + xdd_cmd[2] - (wd2_z_p16 * wd2_z_p21 + wd2_z_p17 * wd2_z_p22 +
      wd2_z_p20 * wd2_z_p25) - (wd2_z_p29 * wd2_z_p24 - wd2_z_p27 * wd2_z_p26);

  // link 1 (link1), Jacobian
  const Real wd2_z_p34 = wd2_z_p33 * wd1_z_p3;
  const Real wd2_z_p35 = (wd2_z_p30 + (wd2_z_p27 * wd2_z_p23 + wd2_z_p28 * wd2_z_p24)) * wd1_z_p3 +
      0.1501 * wd2_z_p32;

  // link 5 (link5), outward
  const Real n5_z_p1 = w5_x * minus_w5_y;

  // link 1 (link1), Jacobian
  const Real wd4_z_p3 = 1.0 / (wd2_z_p1 * wd4_z_p2 - wd2_z_p2 * wd4_z_p1);
  const Real wd1_z = wd2_z_p32 * wd1_z_p5 * wd1_z_p6;

  // link 2 (link2), outward
  const Real wd2_y_p1 = c2 * wd1_z;
  const Real minus_wd2_x_p1 = s2 * wd1_z;

  // link 1 (link1), Jacobian
  const Real wd4_z_p4 = wd2_z_p28 - wd1_z;
  const Real wd2_z = (wd1_z_p2 * wd2_z_p34 + wd1_z_p1 * wd2_z_p35) * wd1_z_p6;

  // link 2 (link2), outward
  const Real wd2_y_2 = wd2_y - wd2_y_p1;
  const Real minus_wd2_x_2 = minus_wd2_x_p1 + minus_wd2_x;

  // link 3 (link3), outward
  const Real wd3_z = wd2_z - (wd1_z_p4 * wd2_z_p34 + wd1_z_p3 * wd2_z_p35) * wd1_z_p6;

  // link 2 (link2), outward
  const Real a3_x_p6 = a3_x_p3 + wd2_z;

  // link 1 (link1), Jacobian
  const Real wd5_z_p1 = wd4_z_p4 * wd2_z_p2 + wd2_z_p29 * wd2_z_p1;

  // link 2 (link2), outward
  const Real minus_a3_z_p3 = wd2_y + wd2_y_2;

  // link 3 (link3), outward
  const Real a3_x_p7 = a3_x_p5 + 0.1501 * wd2_y_p1;

  // link 1 (link1), Jacobian
  const Real wd4_z_p5 = wd2_z_p27 - wd3_z;

  // link 3 (link3), outward
  const Real a4_y_p1 = a4_x_p5 + wd3_z;
  const Real minus_a4_z_p4 = wd3_z - a4_x_p5;

  // link 1 (link1), Jacobian
  const Real wd5_z_p2 = wd4_z_p5 * wd2_z_p1;
  const Real wd5_z_p3 = wd4_z_p5 * wd2_z_p2;

  // link 3 (link3), outward
  const Real wd3_x_2 = s3 * wd2_y_2 - c3 * minus_wd2_x_2 + wd3_x_p1;
  const Real wd3_y_2 = s3 * minus_wd2_x_2 + c3 * wd2_y_2 + wd3_y_p1;
  const Real minus_a3_z_2 = 0.4318 * minus_a3_z_p3 + minus_a3_z_p2;
  const Real a3_x_p8 = 0.4318 * a3_x_p6 + 0.1501 * minus_wd2_x_p1 - minus_a2_y;
  const Real a4_y_p2 = a4_x_p3 + wd3_y_2;
  const Real a4_y_p3 = a4_x_p4 + wd3_x_2;

  // link 1 (link1), Jacobian
  const Real wd4_z_p6 = wd4_z_p5 * (wd2_z_p7 * wd2_z_p19 + wd2_z_p4 * wd2_z_p20) - wd2_z_p29 *
      wd4_z_p1 - wd4_z_p4 * wd4_z_p2;

  // link 5 (link5), inertial wrench
  const Real f5_y = 0.0028799999999999997 * (w5_x * w5_x + w5_z * w5_z);

  // link 3 (link3), outward
  const Real a3_x_2 = s3 * a3_x_p8 - c3 * a3_x_p7;
  const Real a3_y_2 = s3 * a3_x_p7 + c3 * a3_x_p8;

  // link 4 (link4), outward
  const Real wd4_x_2 = c4 * wd3_x_2 + s4 * wd3_z + wd4_x_p1;
  const Real wd4_y = c4 * wd3_z - s4 * wd3_x_2 - minus_wd4_y_p1;
  const Real wd4_z = wd4_z_p6 * wd4_z_p3 - wd3_y_2;
  const Real a4_y_p4 = a3_x_2 + (a4_x_p7 + 0.4331 * a4_y_p1);
  const Real minus_a4_z_2 = a3_y_2 + (minus_a4_z_p3 - 0.0203 * minus_a4_z_p4);
  const Real a4_y_p5 = 0.0203 * a4_y_p2 - 0.4331 * a4_y_p3 - minus_a3_z_2;

  // link 5 (link5), outward
  const Real wd5_z = wd4_y - (wd2_z_p18 * wd5_z_p1 - wd2_z_p19 * wd5_z_p2 + wd2_z_p20 * wd5_z_p3) *
      wd4_z_p3;

  // link 4 (link4), outward
  const Real a4_y_2 = c4 * a4_y_p5 - s4 * a4_y_p4;
  const Real a4_x_2 = c4 * a4_y_p4 + s4 * a4_y_p5;

  // link 5 (link5), outward
  const Real wd5_x_2 = c5 * wd4_x_2 - s5 * wd4_z - wd5_x_p1;
  const Real minus_wd5_y = s5 * wd4_x_2 + c5 * wd4_z + wd5_y_p1;

  // link 5 (link5), inertial wrench
  const Real f5_x = 0.0028799999999999997 * (n5_z_p1 + wd5_z);

  // link 2 (link2), outward
  const Real n2_x_p1 = minus_wd2_x + minus_wd2_x_2;

  // link 5 (link5), outward
  const Real n5_x_p1 = wd5_x_2 - minus_w5_y * w5_z;

  // link 6 (link6), outward
  const Real wd6_z = minus_wd5_y + (c4 * wd5_z_p1 - wd2_z_p4 * wd5_z_p2 - wd2_z_p7 * wd5_z_p3) *
      wd4_z_p3;

  // link 3 (link3), inertial wrench
  const Real n3_x_p1 = 0.3056901365 * a4_y_p3 - 0.010673638499999999 * a4_y_p2 -
      0.004704000000000001 * (a4_x_p1 - a4_x_p2) + 0.861795 * minus_a3_z_2;

  // link 5 (link5), outward
  const Real a5_x_2 = c5 * a4_x_2 + s5 * minus_a4_z_2;

  // link 6 (link6), inertial wrench
  const Real n6_z = 4e-05 * wd6_z;
  tau[5] = n6_z;

  // link 5 (link5), inertial wrench
  const Real minus_f5_z = 0.0028799999999999997 * n5_x_p1;

  // link 5 (link5), inward
  const Real minus_f4_x = s5 * f5_y - c5 * f5_x;
  const Real minus_f4_z = s5 * f5_x + c5 * f5_y;

  // link 6 (link6), outward
  const Real wd6_x_2 = c6 * wd5_x_2 + s6 * wd5_z + wd6_x_p1;
  const Real wd6_y = c6 * wd5_z - s6 * wd5_x_2 - minus_wd6_y_p1;

  // link 6 (link6), inward
  const Real minus_n5_y = 2e-04 * (w5_x * w5_z + minus_wd5_y) + n6_z;

  // link 4 (link4), inward
  const Real f3_y = 0.861795 * minus_a4_z_p2 - 0.025374999999999998 * minus_a4_z_p4 + minus_f4_z;

  // link 6 (link6), inertial wrench
  const Real n6_x = 2e-05 * (wd2_z_p11 + wd6_x_2);
  const Real minus_n6_y = 2e-05 * (wd2_z_p10 - wd6_y);

  // link 4 (link4), inward
  const Real n3_x_p2 = s4 * minus_f4_x + c4 * minus_f5_z;
  const Real f3_x_p1 = s4 * minus_f5_z - c4 * minus_f4_x;
  const Real f3_x = 0.025374999999999998 * a4_x_p6 + 0.861795 * a4_y_p1 + f3_x_p1;
  const Real f3_z = 0.025374999999999998 * a4_y_p2 - 0.861795 * a4_y_p3 - n3_x_p2;

  // link 2 (link2), inertial wrench
  const Real n2_x_p2 = 0.023750999999999998 * (a3_x_p1 - a3_x_p2) -
      (0.07312640000000001 * n2_x_p1 + 0.0070992 * minus_a3_z_p3 + 0.690314699 * a3_x_p6);
  const Real n2_y_p1 = 1.674987602 * minus_a3_z_p3 + 0.023750999999999998 * (a3_x_p3 - wd2_z) +
      0.0070992 * n2_x_p1 + 0.690314699 * (minus_a3_z_p1 - a3_x_p1);

  // link 3 (link3), inertial wrench
  const Real n3_z_p1 = 0.298925024 * a4_x_p5 + 0.312455249 * wd3_z + 0.004704000000000001 *
      (wd3_y_2 - a4_x_p3) + 0.010673638499999999 * (a4_x_p2 - minus_a4_z_p1);

  // link 3 (link3), inward
  const Real n2_x_p3 = s3 * f3_x + c3 * f3_y;

  // link 6 (link6), inward
  const Real n5_x = 0.00042216 * n5_x_p1 - 0.0028799999999999997 * a4_y_2 +
      (c6 * n6_x + s6 * minus_n6_y);
  const Real n5_z = 0.00022215999999999997 * n5_z_p1 + 0.00062216 * wd5_z + 0.0028799999999999997 *
      a5_x_2 + (s6 * n6_x - c6 * minus_n6_y);
  tau[4] = n5_z;

  // link 5 (link5), inward
  const Real n4_y = n5_z - 0.00065 * (w4_x * w4_z - wd4_y);

  // link 2 (link2), inertial wrench
  const Real n2_z_p1 = 1.601861202 * a3_x_p3 + 1.7481140020000001 * wd2_z + 0.690314699 *
      minus_wd2_x_p1 + 0.023750999999999998 * wd2_y_p1 + 0.0070992 * (a3_x_p2 - minus_a3_z_p1);

  // link 5 (link5), inward
  const Real n4_x = 0.0007499999999999999 * (w4_y * w4_z + wd4_x_2) + (c5 * n5_x + s5 * minus_n5_y);
  const Real n4_z = 0.0013999999999999998 * wd4_z - 9.999999999999994e-05 * (w4_x * w4_y) +
      (c5 * minus_n5_y - s5 * n5_x);
  tau[3] = n4_z;

  // link 4 (link4), inward
  const Real n3_y = 0.0067651125 * a4_y_p2 + 0.004704000000000001 * a4_y_p1 - 0.010673638499999999 *
      a4_y_p3 - 0.025374999999999998 * minus_a3_z_2 - (n4_z + 0.0203 * n3_x_p2);
  const Real n3_x = n3_x_p1 + (c4 * n4_x - s4 * n4_y + 0.4331 * n3_x_p2);
  const Real n3_z = n3_z_p1 + (0.861795 * a3_x_2 - 0.025374999999999998 * a3_y_2) +
      (s4 * n4_x + c4 * n4_y + (0.4331 * f3_x_p1 - 0.0203 * minus_f4_z));
  tau[2] = n3_z;

  // link 3 (link3), inward
  const Real n2_z = n2_z_p1 + (1.024164 * s2 - 37.2347379 * c2) + (n3_z + 0.4318 * n2_x_p3);
  tau[1] = n2_z;
  const Real n2_y_p2 = s3 * n3_x + c3 * n3_y + (0.1501 * (c3 * f3_x - s3 * f3_y) - 0.4318 * f3_z);
  const Real n2_x = n2_x_p2 + (c3 * n3_x - s3 * n3_y - 0.1501 * n2_x_p3);
  const Real n2_y = n2_y_p1 + n2_y_p2;

  // link 2 (link2), inward
  const Real n1_z = 1.4717295504999999 * wd1_z - (s2 * n2_x + c2 * n2_y);
  tau[0] = n1_z;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
