// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 578 flops (add 250, mul 324, div 4), sine and cosine of 5 angles
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

void forward_dynamics(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT tau)[6], Real (&TREELINE_RESTRICT qdd)[6]) noexcept {
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
  const Real s5 = sines[3];
  const Real c5 = cosines[3];
  const Real c6 = cosines[4];
  const Real s6 = sines[4];

  // link 2 (link2), outward
  const Real minus_w2_x = s2 * qd[0];
  const Real minus_w2_y = c2 * qd[0];

  // link 3 (link3), outward
  const Real w3_z = qd[1] + qd[2];

  // link 2 (link2), outward
  const Real a3_x_p1 = qd[1] * qd[1];
  const Real minus_a2_y = 9.81 * c2;
  const Real minus_a2_x = 9.81 * s2;

  // link 3 (link3), outward
  const Real a4_y_p1 = w3_z * w3_z;

  // link 2 (link2), outward
  const Real wd2_y = minus_w2_x * qd[1];
  const Real minus_wd2_x = minus_w2_y * qd[1];
  const Real a3_x_p2 = minus_w2_y * minus_w2_y;
  const Real a3_x_p3 = minus_w2_x * minus_w2_y;
  const Real minus_a3_z_p1 = minus_w2_x * minus_w2_x;

  // link 3 (link3), outward
  const Real w3_y = s3 * minus_w2_x - c3 * minus_w2_y;
  const Real minus_w3_x = c3 * minus_w2_x + s3 * minus_w2_y;

  // link 4 (link4), outward
  const Real w4_z = qd[3] - w3_y;

  // link 3 (link3), outward
  const Real a4_y_p2 = w3_y * w3_y;
  const Real a4_y_p3 = minus_w3_x * w3_z;
  const Real a4_y_p4 = minus_w3_x * w3_y;
  const Real a3_x_p4 = 0.4318 * a3_x_p3 - minus_a2_y;
  const Real wd3_x = s3 * wd2_y - c3 * minus_wd2_x + w3_y * qd[2];

  // link 4 (link4), outward
  const Real a4_y_p5 = a4_y_p2 + a4_y_p1;

  // link 3 (link3), outward
  const Real minus_a4_z_p1 = minus_w3_x * minus_w3_x;

  // link 4 (link4), outward
  const Real w4_y = s4 * minus_w3_x + c4 * w3_z;
  const Real w4_x = s4 * w3_z - c4 * minus_w3_x;

  // link 3 (link3), outward
  const Real wd3_y = s3 * minus_wd2_x + c3 * wd2_y + minus_w3_x * qd[2];
  const Real a3_x_p5 = minus_a2_x + 0.4318 * (a3_x_p2 + a3_x_p1);
  const Real a4_y_p6 = w3_y * w3_z + wd3_x;

  // link 5 (link5), outward
  const Real w5_z = w4_y + qd[4];

  // link 3 (link3), outward
  const Real a4_y_p7 = a4_y_p3 + wd3_y;
  const Real minus_a3_z = 0.8636 * wd2_y + 0.1501 * (minus_a3_z_p1 + a3_x_p2);

  // link 4 (link4), outward
  const Real minus_a4_z_p2 = minus_a4_z_p1 + a4_y_p1;
  const Real wd4_x = c4 * wd3_x + w4_y * qd[3];

  // link 5 (link5), outward
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;
  const Real w5_x = c5 * w4_x - s5 * w4_z;

  // link 4 (link4), outward
  const Real minus_wd4_y = s4 * wd3_x + w4_x * qd[3];

  // link 3 (link3), outward
  const Real a3_x = s3 * a3_x_p4 - c3 * a3_x_p5;

  // link 6 (link6), outward
  const Real w6_z = minus_w5_y + qd[5];

  // link 4 (link4), outward
  const Real a4_y_p8 = a3_x + (0.0203 * a4_y_p5 + 0.4331 * a4_y_p4);

  // link 3 (link3), outward
  const Real a3_y = s3 * a3_x_p5 + c3 * a3_x_p4;

  // link 5 (link5), outward
  const Real minus_f5_x_p1 = w5_x * minus_w5_y;

  // link 6 (link6), outward
  const Real n6_x_p1 = w6_z + qd[5];
  const Real w6_y = c6 * w5_z - s6 * w5_x;
  const Real w6_x = c6 * w5_x + s6 * w5_z;

  // link 4 (link4), outward
  const Real a4_y_p9 = 0.0203 * a4_y_p7 - 0.4331 * a4_y_p6 - minus_a3_z;
  const Real minus_a4_z = a3_y + (0.0203 * a4_y_p4 + 0.4331 * minus_a4_z_p2);

  // link 5 (link5), outward
  const Real wd5_x = c5 * wd4_x + s5 * wd3_y - minus_w5_y * qd[4];
  const Real wd5_y = c5 * wd3_y - s5 * wd4_x - w5_x * qd[4];
  const Real n5_x_p1 = wd5_x - minus_w5_y * w5_z;

  // link 5 (link5), inertial wrench
  const Real minus_f5_x = 0.0028799999999999997 * (minus_wd4_y - minus_f5_x_p1);

  // link 4 (link4), outward
  const Real a4_y = c4 * a4_y_p9 - s4 * a4_y_p8;
  const Real a4_x = c4 * a4_y_p8 + s4 * a4_y_p9;

  // link 6 (link6), inertial wrench
  const Real minus_n6_z = 4e-05 * wd5_y;

  // link 5 (link5), inertial wrench
  const Real f5_y = 0.0028799999999999997 * (w5_x * w5_x + w5_z * w5_z);
  const Real minus_f5_z = 0.0028799999999999997 * n5_x_p1;

  // link 6 (link6), mass matrix
  const Real qdd_0_p1 = 4e-05 * s5;
  const Real qdd_0_p2 = 4e-05 * c5;
  const Real qdd_0_p3 = c4 * qdd_0_p1;

  // link 5 (link5), composite inertia
  const Real qdd_0_p4 = 0.0028799999999999997 * c5;

  // link 5 (link5), outward
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;

  // link 6 (link6), inward
  const Real n5_y = minus_n6_z - 2e-04 * (w5_x * w5_z - wd5_y);

  // link 6 (link6), inertial wrench
  const Real n6_x = 2e-05 * (c6 * wd5_x - s6 * minus_wd4_y + n6_x_p1 * w6_y);
  const Real minus_n6_y = 2e-05 * (s6 * wd5_x + c6 * minus_wd4_y + n6_x_p1 * w6_x);

  // link 5 (link5), inward
  const Real minus_f4_x = c5 * minus_f5_x + s5 * f5_y;

  // link 5 (link5), composite inertia
  const Real qdd_0_p5 = 0.0028799999999999997 * s5;

  // link 5 (link5), mass matrix
  const Real qdd_0_p6 = c4 * qdd_0_p4;
  const Real qdd_0_p7 = s4 * qdd_0_p4;

  // link 1 (link1), mass matrix
  const Real qdd_0_p8 = 0.9999999999999999 * c5;

  // link 5 (link5), mass matrix
  const Real qdd_0_p9 = 0.0203 * qdd_0_p7;

  // link 5 (link5), composite inertia
  const Real qdd_0_p10 = 0.00020215999999999998 * s5;

  // link 4 (link4), composite inertia
  const Real qdd_0_p11 = c4 * qdd_0_p5;

  // link 4 (link4), inward
  const Real n3_x_p1 = s4 * minus_f4_x + c4 * minus_f5_z;

  // link 5 (link5), mass matrix
  const Real qdd_0_p12 = s3 * qdd_0_p6 + c3 * qdd_0_p5;
  const Real qdd_0_p13 = 0.00064216 * s4 + 0.4331 * qdd_0_p7;

  // link 4 (link4), composite inertia
  const Real qdd_0_p14 = s4 * qdd_0_p5;

  // link 5 (link5), composite inertia
  const Real qdd_0_p15 = s5 * qdd_0_p10;
  const Real qdd_0_p16 = c5 * qdd_0_p10;

  // link 6 (link6), inward
  const Real n5_x = 0.00042216 * n5_x_p1 - 0.0028799999999999997 * a4_y +
      (c6 * n6_x + s6 * minus_n6_y);

  // link 4 (link4), composite inertia
  const Real qdd_0_p17 = 0.0203 * qdd_0_p11;

  // link 6 (link6), inward
  const Real n5_z = 0.00022215999999999997 * minus_f5_x_p1 - 0.00062216 * minus_wd4_y +
      0.0028799999999999997 * a5_x + (s6 * n6_x - c6 * minus_n6_y);

  // link 4 (link4), mass matrix
  const Real qdd_0_p18 = s3 * qdd_0_p14;
  const Real qdd_0_p19 = 0.1501 * qdd_0_p14;

  // link 5 (link5), composite inertia
  const Real qdd_0_p20 = 0.00164 + qdd_0_p15;

  // link 5 (link5), inward
  const Real n4_y = n5_z - 0.00065 * (w4_x * w4_z + minus_wd4_y);

  // link 4 (link4), mass matrix
  const Real qdd_0_p21 = qdd_0_p17 - qdd_0_p20;
  const Real qdd_0_p22 = c4 * qdd_0_p16 + 0.4331 * qdd_0_p11;

  // link 4 (link4), inward
  const Real f3_x_p1 = s4 * minus_f5_z - c4 * minus_f4_x;

  // link 5 (link5), inward
  const Real f4_z = s5 * minus_f5_x - c5 * f5_y;

  // link 5 (link5), mass matrix
  const Real qdd_0_p23 = c3 * qdd_0_p9 - s3 * qdd_0_p13 +
      (0.1501 * (c3 * qdd_0_p6 - s3 * qdd_0_p5) - 0.4318 * qdd_0_p7);

  // link 1 (link1), mass matrix
  const Real qdd_0_p24 = 1.0 / (qdd_0_p20 - qdd_0_p8 * qdd_0_p2);

  // link 6 (link6), mass matrix
  const Real qdd_0_p25 = s4 * qdd_0_p1;

  // link 5 (link5), inward
  const Real n4_x = 0.0007499999999999999 * (w4_y * w4_z + wd4_x) - (s5 * n5_y - c5 * n5_x);

  // link 1 (link1), mass matrix
  const Real qdd_0_p26 = 24999.999999999996 * qdd_0_p25;

  // link 4 (link4), composite inertia
  const Real qdd_0_p27 = s4 * qdd_0_p16 + 0.4331 * qdd_0_p14;

  // link 4 (link4), inward
  const Real f3_x = 0.025374999999999998 * a4_y_p5 + 0.861795 * a4_y_p4 + f3_x_p1;

  // link 4 (link4), composite inertia
  const Real qdd_0_p28 = 0.861795 + qdd_0_p4;
  const Real qdd_0_p29 = s4 * (0.00010000000000000026 + qdd_0_p15);

  // link 5 (link5), mass matrix
  const Real qdd_0_p30 = 0.00064216 * c4 + (0.4331 * qdd_0_p6 - 5.846399999999999e-05 * s5);

  // link 4 (link4), composite inertia
  const Real qdd_0_p31 = qdd_0_p11 - 0.025374999999999998;

  // link 4 (link4), inward
  const Real f3_y = 0.025374999999999998 * a4_y_p4 + 0.861795 * minus_a4_z_p2 - f4_z;

  // link 1 (link1), mass matrix
  const Real qdd_0_p32 = qdd_0_p27 + qdd_0_p8 * qdd_0_p25;

  // link 4 (link4), composite inertia
  const Real qdd_0_p33 = 0.004704000000000001 + qdd_0_p27;

  // link 1 (link1), mass matrix
  const Real qdd_0_p34 = 1557.24430048586 * qdd_0_p30;

  // link 6 (link6), mass matrix
  const Real qdd_0_p35 = s2 * (c3 * qdd_0_p3 + s3 * qdd_0_p2) + c2 *
      (s3 * qdd_0_p3 - c3 * qdd_0_p2);

  // link 1 (link1), mass matrix
  const Real qdd_0_p36 = qdd_0_p32 * qdd_0_p24;

  // link 4 (link4), composite inertia
  const Real qdd_0_p37 = s4 * qdd_0_p29;

  // link 3 (link3), mass matrix
  const Real qdd_0_p38 = s3 * qdd_0_p28 + c3 * qdd_0_p31;
  const Real qdd_0_p39 = c3 * qdd_0_p28 - s3 * qdd_0_p31;

  // link 5 (link5), inward
  const Real minus_n4_z = 9.999999999999994e-05 * (w4_x * w4_y) + 0.0013999999999999998 * wd3_y +
      (s5 * n5_x + c5 * n5_y);

  // link 4 (link4), composite inertia
  const Real qdd_0_p40 = 0.0203 * qdd_0_p14 - c4 * qdd_0_p29;

  // link 3 (link3), inertial wrench
  const Real n3_x_p2 = 0.3056901365 * a4_y_p6 - 0.010673638499999999 * a4_y_p7 -
      0.004704000000000001 * (a4_y_p1 - a4_y_p2) + 0.861795 * minus_a3_z;

  // link 5 (link5), mass matrix
  const Real qdd_0_p41 = s2 * (c3 * qdd_0_p13 + s3 * qdd_0_p9 + 0.1501 * qdd_0_p12) - c2 *
      qdd_0_p23;

  // link 4 (link4), mass matrix
  const Real qdd_0_p42 = s2 * (0.1501 * qdd_0_p18 - (c3 * qdd_0_p22 + s3 * qdd_0_p21)) + c2 *
      ((qdd_0_p21 - qdd_0_p19) * c3 - (s3 * qdd_0_p22 + 0.4318 * qdd_0_p11));

  // link 1 (link1), mass matrix
  const Real qdd_0_p43 = qdd_0_p26 * qdd_0_p35;

  // link 3 (link3), mass matrix
  const Real qdd_0_p44 = 0.4318 * qdd_0_p38;

  // link 4 (link4), inward
  const Real n3_x = n3_x_p2 + (c4 * n4_x - s4 * n4_y + 0.4331 * n3_x_p1);
  const Real n3_y = 0.0067651125 * a4_y_p7 + 0.004704000000000001 * a4_y_p4 - 0.010673638499999999 *
      a4_y_p6 - 0.025374999999999998 * minus_a3_z + (minus_n4_z - 0.0203 * n3_x_p1);

  // link 5 (link5), mass matrix
  const Real qdd_0_p45 = qdd_0_p30 + 0.4318 * qdd_0_p12;

  // link 1 (link1), mass matrix
  const Real qdd_0_p46 = qdd_0_p32 + 0.4318 * qdd_0_p18;

  // link 3 (link3), mass matrix
  const Real qdd_0_p47 = c3 * qdd_0_p40 - s3 * qdd_0_p33 - 0.1501 * qdd_0_p38;
  const Real qdd_0_p48 = s3 * qdd_0_p40 + c3 * qdd_0_p33 + 0.1501 * qdd_0_p39;

  // link 4 (link4), inward
  const Real f3_z = 0.025374999999999998 * a4_y_p7 - 0.861795 * a4_y_p6 - n3_x_p1;

  // link 1 (link1), mass matrix
  const Real qdd_0_p49 = 1557.24430048586 * qdd_0_p45;
  const Real qdd_0_p50 = qdd_0_p8 * qdd_0_p35 - qdd_0_p42;
  const Real qdd_0_p51 = qdd_0_p46 * qdd_0_p24;
  const Real qdd_0_p52 = 0.312455249 + (0.00129216 - qdd_0_p37 + 2.0 *
      (0.0012473279999999998 * c5 - qdd_0_p17)) - qdd_0_p26 * qdd_0_p25;
  const Real qdd_0_p53 = 1.0 / (qdd_0_p52 - qdd_0_p34 * qdd_0_p30 - qdd_0_p36 * qdd_0_p32);
  const Real qdd_0_p54 = qdd_0_p52 + qdd_0_p44 - qdd_0_p34 * qdd_0_p45 - qdd_0_p36 * qdd_0_p46;

  // link 4 (link4), composite inertia
  const Real qdd_0_p55 = 0.0067651125 + (qdd_0_p20 - 0.0406 * qdd_0_p11);

  // link 3 (link3), inward
  const Real n2_x_p1 = s3 * f3_x + c3 * f3_y;

  // link 4 (link4), composite inertia
  const Real qdd_0_p56 = qdd_0_p22 - 5.846399999999999e-05 * c5 - 0.010673638499999999;
  const Real qdd_0_p57 = 0.3056901365 + (0.0011921599999999998 - qdd_0_p15 + qdd_0_p37 +
      0.0024946559999999996 * c5);

  // link 1 (link1), mass matrix
  const Real qdd_0_p58 = 24999.999999999996 * qdd_0_p35;
  const Real qdd_0_p59 = qdd_0_p43 - (s2 * (qdd_0_p47 - 0.4318 * qdd_0_p14 - 0.690314699) + c2 *
      (qdd_0_p48 - 0.023750999999999998));
  const Real qdd_0_p60 = qdd_0_p43 - (s2 * qdd_0_p47 + c2 * qdd_0_p48) - qdd_0_p34 * qdd_0_p41 +
      qdd_0_p36 * qdd_0_p50;

  // link 1 (link1), inward
  const Real qdd_1_p1 = tau[5] + minus_n6_z;

  // link 1 (link1), mass matrix
  const Real qdd_0_p61 = 1557.24430048586 * qdd_0_p41;

  // link 3 (link3), composite inertia
  const Real qdd_0_p62 = s3 * (qdd_0_p57 - qdd_0_p55) + c3 * (2.0 * qdd_0_p56);

  // link 1 (link1), mass matrix
  const Real qdd_0_p63 = qdd_0_p54 * qdd_0_p53;

  // link 3 (link3), inertial wrench
  const Real n3_z_p1 = 0.298925024 * a4_y_p4 + 0.004704000000000001 * (wd3_y - a4_y_p3) +
      0.010673638499999999 * (a4_y_p2 - minus_a4_z_p1) +
      (0.861795 * a3_x - 0.025374999999999998 * a3_y);

  // link 2 (link2), inertial wrench
  const Real n2_x_p2 = 0.023750999999999998 * (a3_x_p1 - a3_x_p2) -
      (0.14625280000000002 * minus_wd2_x + 0.0141984 * wd2_y + 0.690314699 * a3_x_p3);

  // link 3 (link3), inward
  const Real n2_y_p1 = s3 * n3_x + c3 * n3_y + (0.1501 * (c3 * f3_x - s3 * f3_y) - 0.4318 * f3_z);

  // link 2 (link2), inertial wrench
  const Real n2_y_p2 = 3.349975204 * wd2_y + 0.023750999999999998 * a3_x_p3 + 0.0141984 *
      minus_wd2_x + 0.690314699 * (minus_a3_z_p1 - a3_x_p1);

  // link 1 (link1), mass matrix
  const Real qdd_0_p64 = qdd_0_p50 * qdd_0_p24;

  // link 3 (link3), composite inertia
  const Real qdd_0_p65 = s3 * qdd_0_p62;

  // link 4 (link4), inward
  const Real n3_z = n3_z_p1 + (s4 * n4_x + c4 * n4_y + (0.0203 * f4_z + 0.4331 * f3_x_p1));

  // link 3 (link3), inward
  const Real n2_x = n2_x_p2 + (c3 * n3_x - s3 * n3_y - 0.1501 * n2_x_p1);
  const Real n2_y = n2_y_p2 + n2_y_p1;

  // link 1 (link1), inward
  const Real qdd_1_p2 = tau[4] - n5_z;

  // link 1 (link1), mass matrix
  const Real qdd_0_p66 = qdd_0_p60 * qdd_0_p53;

  // link 1 (link1), inward
  const Real qdd_1_p3 = n3_z + qdd_0_p26 * qdd_1_p1;

  // link 1 (link1), mass matrix
  const Real qdd_0_p67 = 1.7481140020000001 + qdd_0_p52 + 0.8636 * qdd_0_p38 - qdd_0_p49 *
      qdd_0_p45 - qdd_0_p51 * qdd_0_p46 - qdd_0_p63 * qdd_0_p54;
  const Real qdd_0_p68 = qdd_0_p59 - qdd_0_p49 * qdd_0_p41 + qdd_0_p51 * qdd_0_p50 - qdd_0_p63 *
      qdd_0_p60;

  // link 1 (link1), inward
  const Real qdd_1_p4 = tau[1] - 1.601861202 * a3_x_p3 - 0.0070992 * (a3_x_p2 - minus_a3_z_p1) -
      1.024164 * s2 + 37.2347379 * c2;
  const Real qdd_1_p5 = tau[3] + minus_n4_z - qdd_0_p8 * qdd_1_p1;

  // link 1 (link1), mass matrix
  const Real qdd_0_p69 = 1.0 / qdd_0_p67;

  // link 3 (link3), composite inertia
  const Real qdd_0_p70 = 1.674987602 + (qdd_0_p55 + qdd_0_p65 + 2.0 * (qdd_0_p44 + qdd_0_p19));

  // link 2 (link2), inward
  const Real minus_n1_z = s2 * n2_x + c2 * n2_y;

  // link 1 (link1), inward
  const Real qdd_1_p6 = tau[2] - qdd_1_p3 - qdd_0_p34 * qdd_1_p2 + qdd_0_p36 * qdd_1_p5;

  // link 2 (link2), composite inertia
  const Real qdd_0_p71 = s2 * (0.07312640000000001 + (qdd_0_p57 - qdd_0_p65 + 0.3002 * qdd_0_p14) -
      qdd_0_p70) + c2 * (2.0 * (c3 * qdd_0_p62 - qdd_0_p56 + 0.4318 * qdd_0_p39 - 0.0070992));

  // link 1 (link1), mass matrix
  const Real qdd_0_p72 = qdd_0_p68 * qdd_0_p69;

  // link 1 (link1), inward
  const Real qdd_1_p7 = qdd_1_p4 - qdd_1_p3 - 0.4318 * n2_x_p1 - qdd_0_p49 * qdd_1_p2 + qdd_0_p51 *
      qdd_1_p5 - qdd_0_p63 * qdd_1_p6;
  const Real qdd_0_p73 = tau[0] + minus_n1_z + qdd_0_p58 * qdd_1_p1 - qdd_0_p61 * qdd_1_p2 -
      qdd_0_p64 * qdd_1_p5 - qdd_0_p66 * qdd_1_p6;

  // link 1 (link1), mass matrix
  const Real qdd_0_p74 = 1.4717295504999999 + (qdd_0_p70 + s2 * qdd_0_p71) - qdd_0_p58 * qdd_0_p35 -
      qdd_0_p61 * qdd_0_p41 - qdd_0_p64 * qdd_0_p50;

  // link 1 (link1), inward
  const Real qdd_0 = (qdd_0_p73 - qdd_0_p72 * qdd_1_p7) *
      (1.0 / (qdd_0_p74 - qdd_0_p66 * qdd_0_p60 - qdd_0_p72 * qdd_0_p68));
  qdd[0] = qdd_0;
  const Real qdd_1 = qdd_1_p7 * qdd_0_p69 - qdd_0_p72 * qdd_0;
  qdd[1] = qdd_1;
  const Real qdd_2 = qdd_1_p6 * qdd_0_p53 - qdd_0_p66 * qdd_0 - qdd_0_p63 * qdd_1;
  qdd[2] = qdd_2;
  const Real qdd_3 = qdd_1_p5 * qdd_0_p24 - qdd_0_p64 * qdd_0 + qdd_0_p51 * qdd_1 + qdd_0_p36 *
      qdd_2;
  qdd[3] = qdd_3;
  qdd[4] = 1557.24430048586 * qdd_1_p2 - qdd_0_p61 * qdd_0 - qdd_0_p49 * qdd_1 - qdd_0_p34 * qdd_2;
  qdd[5] = 24999.999999999996 * qdd_1_p1 + qdd_0_p58 * qdd_0 - qdd_0_p8 * qdd_3 - (qdd_1 + qdd_2) *
      qdd_0_p26;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
