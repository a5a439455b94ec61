// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 813 flops (add 347, mul 460, div 6), sine and cosine of 7 angles
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

void forward_dynamics(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    const Real (&TREELINE_RESTRICT tau)[9], Real (&TREELINE_RESTRICT qdd)[9]) noexcept {
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
  const Real s9 = sines[6];
  const Real c9 = cosines[6];

  // link 4 (link1), outward
  const Real w4_z = qd[2] + qd[3];

  // link 6 (link3), outward
  const Real w6_z = qd[4] + qd[5];

  // link 5 (link2), outward
  const Real a6_x_p1 = qd[4] * qd[4];
  const Real minus_w5_x = s5 * w4_z;
  const Real minus_w5_y = c5 * w4_z;

  // link 6 (link3), outward
  const Real a7_x_p1 = w6_z * w6_z;

  // link 5 (link2), outward
  const Real wd5_y = minus_w5_x * qd[4];
  const Real minus_wd5_x = minus_w5_y * qd[4];
  const Real a6_x_p2 = minus_w5_y * minus_w5_y;
  const Real f5_y_p1 = minus_w5_x * minus_w5_y;
  const Real f5_y_p2 = minus_w5_x * minus_w5_x;

  // link 6 (link3), outward
  const Real minus_w6_x = c6 * minus_w5_x + s6 * minus_w5_y;
  const Real w6_y = s6 * minus_w5_x - c6 * minus_w5_y;
  const Real a6_x_p3 = a6_x_p2 + a6_x_p1;

  // link 7 (link4), outward
  const Real w7_z = qd[6] - w6_y;

  // link 6 (link3), outward
  const Real a7_x_p2 = w6_y * w6_y;
  const Real a7_x_p3 = minus_w6_x * w6_z;

  // link 5 (link2), outward
  const Real minus_a5_y = 9.81 * c5;
  const Real minus_a5_x = 9.81 * s5;

  // link 7 (link4), outward
  const Real w7_y = s7 * minus_w6_x + c7 * w6_z;
  const Real w7_x = s7 * w6_z - c7 * minus_w6_x;

  // link 6 (link3), outward
  const Real a7_x_p4 = minus_w6_x * w6_y;
  const Real wd6_x = s6 * wd5_y - c6 * minus_wd5_x + w6_y * qd[5];
  const Real wd6_y = s6 * minus_wd5_x + c6 * wd5_y + minus_w6_x * qd[5];

  // link 7 (link4), outward
  const Real a7_x_p5 = a7_x_p2 + a7_x_p1;

  // link 6 (link3), outward
  const Real minus_a7_z_p1 = minus_w6_x * minus_w6_x;
  const Real a6_x_p4 = 0.4318 * f5_y_p1 - minus_a5_y;

  // link 8 (link5), outward
  const Real w8_z = w7_y + qd[7];

  // link 6 (link3), outward
  const Real a7_x_p6 = a7_x_p3 + wd6_y;
  const Real a7_x_p7 = w6_y * w6_z + wd6_x;
  const Real a6_x_p5 = minus_a5_x + 0.4318 * a6_x_p3;

  // link 8 (link5), composite inertia
  const Real qdd_0_p1 = 0.0028799999999999997 * c8;
  const Real qdd_0_p2 = 0.0028799999999999997 * s8;

  // link 8 (link5), outward
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real w8_x = c8 * w7_x - s8 * w7_z;

  // link 7 (link4), outward
  const Real wd7_x = c7 * wd6_x + w7_y * qd[6];
  const Real minus_wd7_y = s7 * wd6_x + w7_x * qd[6];
  const Real minus_a7_z_p2 = minus_a7_z_p1 + a7_x_p1;

  // link 8 (link5), mass matrix
  const Real qdd_0_p3 = c7 * qdd_0_p1;
  const Real qdd_0_p4 = s7 * qdd_0_p1;

  // link 9 (link6), outward
  const Real w9_z = minus_w8_y + qd[8];

  // link 6 (link3), outward
  const Real a6_x = s6 * a6_x_p4 - c6 * a6_x_p5;
  const Real minus_a6_z = 0.8636 * wd5_y + 0.1501 * (f5_y_p2 + a6_x_p2);

  // link 9 (link6), outward
  const Real w9_y = c9 * w8_z - s9 * w8_x;
  const Real n9_x_p1 = w9_z + qd[8];
  const Real w9_x = c9 * w8_x + s9 * w8_z;

  // link 7 (link4), outward
  const Real a7_x_p8 = a6_x + (0.0203 * a7_x_p5 + 0.4331 * a7_x_p4);
  const Real a7_x_p9 = 0.0203 * a7_x_p6 - 0.4331 * a7_x_p7 - minus_a6_z;

  // link 8 (link5), mass matrix
  const Real qdd_0_p5 = s6 * qdd_0_p3 + c6 * qdd_0_p2;
  const Real qdd_0_p6 = c6 * qdd_0_p3 - s6 * qdd_0_p2;

  // link 8 (link5), outward
  const Real wd8_x = c8 * wd7_x + s8 * wd6_y - minus_w8_y * qd[7];

  // link 6 (link3), outward
  const Real a6_y = s6 * a6_x_p5 + c6 * a6_x_p4;

  // link 8 (link5), outward
  const Real minus_f8_x_p1 = w8_x * minus_w8_y;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p7 = 0.9999999999999999 * c8;

  // link 7 (link4), composite inertia
  const Real qdd_0_p8 = s7 * qdd_0_p2;

  // link 8 (link5), outward
  const Real n8_x_p1 = wd8_x - minus_w8_y * w8_z;

  // link 7 (link4), outward
  const Real a7_x = c7 * a7_x_p8 + s7 * a7_x_p9;
  const Real minus_a7_z = a6_y + (0.0203 * a7_x_p4 + 0.4331 * minus_a7_z_p2);

  // link 8 (link5), outward
  const Real wd8_y = c8 * wd6_y - s8 * wd7_x - w8_x * qd[7];

  // link 7 (link4), composite inertia
  const Real qdd_0_p9 = c7 * qdd_0_p2;

  // link 7 (link4), outward
  const Real a7_y = c7 * a7_x_p9 - s7 * a7_x_p8;

  // link 9 (link6), mass matrix
  const Real qdd_0_p10 = 4e-05 * c8;

  // link 7 (link4), mass matrix
  const Real qdd_0_p11 = s6 * qdd_0_p8;

  // link 8 (link5), composite inertia
  const Real qdd_0_p12 = 0.00020215999999999998 * s8;

  // link 7 (link4), mass matrix
  const Real qdd_0_p13 = c6 * qdd_0_p8;

  // link 8 (link5), mass matrix
  const Real qdd_0_p14 = s5 * qdd_0_p5 - c5 * qdd_0_p6;

  // link 9 (link6), inertial wrench
  const Real minus_n9_z = 4e-05 * wd8_y;

  // link 8 (link5), composite inertia
  const Real qdd_0_p15 = s8 * qdd_0_p12;

  // link 9 (link6), inertial wrench
  const Real n9_x = 2e-05 * (c9 * wd8_x - s9 * minus_wd7_y + n9_x_p1 * w9_y);
  const Real minus_n9_y = 2e-05 * (s9 * wd8_x + c9 * minus_wd7_y + n9_x_p1 * w9_x);

  // link 8 (link5), outward
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;

  // link 8 (link5), inertial wrench
  const Real minus_f8_x = 0.0028799999999999997 * (minus_wd7_y - minus_f8_x_p1);
  const Real f8_y = 0.0028799999999999997 * (w8_x * w8_x + w8_z * w8_z);

  // link 8 (link5), composite inertia
  const Real qdd_0_p16 = 0.00164 + qdd_0_p15;

  // link 7 (link4), mass matrix
  const Real qdd_0_p17 = c5 * qdd_0_p13 - s5 * qdd_0_p11;

  // link 8 (link5), inertial wrench
  const Real minus_f8_z = 0.0028799999999999997 * n8_x_p1;

  // link 8 (link5), mass matrix
  const Real qdd_0_p18 = c4 * qdd_0_p14 + s4 * qdd_0_p4;
  const Real qdd_0_p19 = c4 * qdd_0_p4 - s4 * qdd_0_p14;

  // link 9 (link6), mass matrix
  const Real qdd_0_p20 = 4e-05 * s8;

  // link 9 (link6), inward
  const Real n8_y = minus_n9_z - 2e-04 * (w8_x * w8_z - wd8_y);

  // link 8 (link5), composite inertia
  const Real qdd_0_p21 = c8 * qdd_0_p12;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p22 = 1.0 / (qdd_0_p16 - qdd_0_p7 * qdd_0_p10);

  // link 9 (link6), mass matrix
  const Real qdd_0_p23 = s7 * qdd_0_p20;

  // link 7 (link4), mass matrix
  const Real qdd_0_p24 = c4 * qdd_0_p17 + s4 * qdd_0_p9;
  const Real qdd_0_p25 = c4 * qdd_0_p9 - s4 * qdd_0_p17;

  // link 7 (link4), composite inertia
  const Real qdd_0_p26 = 0.861795 + qdd_0_p1;
  const Real qdd_0_p27 = qdd_0_p9 - 0.025374999999999998;

  // link 9 (link6), inward
  const Real n8_x = 0.00042216 * n8_x_p1 - 0.0028799999999999997 * a7_y +
      (c9 * n9_x + s9 * minus_n9_y);

  // link 8 (link5), inward
  const Real minus_f7_x = c8 * minus_f8_x + s8 * f8_y;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p28 = 24999.999999999996 * qdd_0_p23;

  // link 8 (link5), mass matrix
  const Real qdd_0_p29 = 0.00064216 * c7 + (0.4331 * qdd_0_p3 - 5.846399999999999e-05 * s8);

  // link 7 (link4), composite inertia
  const Real qdd_0_p30 = 0.0203 * qdd_0_p9;
  const Real qdd_0_p31 = s7 * qdd_0_p21 + 0.4331 * qdd_0_p8;

  // link 9 (link6), inward
  const Real n8_z = 0.00022215999999999997 * minus_f8_x_p1 - 0.00062216 * minus_wd7_y +
      0.0028799999999999997 * a8_x + (s9 * n9_x - c9 * minus_n9_y);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p32 = 1557.24430048586 * qdd_0_p29;

  // link 6 (link3), mass matrix
  const Real qdd_0_p33 = s6 * qdd_0_p26 + c6 * qdd_0_p27;

  // link 7 (link4), composite inertia
  const Real qdd_0_p34 = s7 * (0.00010000000000000026 + qdd_0_p15);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p35 = qdd_0_p31 + qdd_0_p7 * qdd_0_p23;

  // link 6 (link3), mass matrix
  const Real qdd_0_p36 = c6 * qdd_0_p26 - s6 * qdd_0_p27;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p37 = qdd_0_p35 * qdd_0_p22;

  // link 7 (link4), composite inertia
  const Real qdd_0_p38 = s7 * qdd_0_p34;

  // link 8 (link5), inward
  const Real n7_x = 0.0007499999999999999 * (w7_y * w7_z + wd7_x) - (s8 * n8_y - c8 * n8_x);
  const Real n7_y = n8_z - 0.00065 * (w7_x * w7_z + minus_wd7_y);

  // link 7 (link4), inward
  const Real f6_x_p1 = s7 * minus_f8_z - c7 * minus_f7_x;

  // link 8 (link5), inward
  const Real f7_z = s8 * minus_f8_x - c8 * f8_y;

  // link 7 (link4), inward
  const Real n6_x_p1 = s7 * minus_f7_x + c7 * minus_f8_z;

  // link 6 (link3), mass matrix
  const Real qdd_0_p39 = s5 * qdd_0_p33 - c5 * qdd_0_p36;
  const Real qdd_0_p40 = 0.4318 * qdd_0_p33;

  // link 7 (link4), inward
  const Real f6_x = 0.025374999999999998 * a7_x_p5 + 0.861795 * a7_x_p4 + f6_x_p1;

  // link 8 (link5), mass matrix
  const Real qdd_0_p41 = qdd_0_p29 + 0.4318 * qdd_0_p5;

  // link 7 (link4), inward
  const Real f6_y = 0.025374999999999998 * a7_x_p4 + 0.861795 * minus_a7_z_p2 - f7_z;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p42 = qdd_0_p35 + 0.4318 * qdd_0_p11;

  // link 6 (link3), composite inertia
  const Real qdd_0_p43 = 0.10439999999999999 - qdd_0_p36;
  const Real qdd_0_p44 = 3.79559 + qdd_0_p33;

  // link 6 (link3), mass matrix
  const Real qdd_0_p45 = s4 * qdd_0_p39;
  const Real qdd_0_p46 = c4 * qdd_0_p39;

  // link 8 (link5), inward
  const Real minus_n7_z = 9.999999999999994e-05 * (w7_x * w7_y) + 0.0013999999999999998 * wd6_y +
      (s8 * n8_x + c8 * n8_y);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p47 = 1557.24430048586 * qdd_0_p41;
  const Real qdd_0_p48 = qdd_0_p42 * qdd_0_p22;

  // link 8 (link5), mass matrix
  const Real qdd_0_p49 = c3 * qdd_0_p18 + s3 * qdd_0_p19;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p50 = 0.312455249 + (0.00129216 - qdd_0_p38 + 2.0 *
      (0.0012473279999999998 * c8 - qdd_0_p30)) - qdd_0_p28 * qdd_0_p23;

  // link 5 (link2), mass matrix
  const Real qdd_0_p51 = c5 * qdd_0_p43 + s5 * qdd_0_p44;
  const Real qdd_0_p52 = s4 * qdd_0_p51;
  const Real qdd_0_p53 = c4 * qdd_0_p51;

  // link 6 (link3), inward
  const Real n5_y_p1 = c6 * f6_x - s6 * f6_y;

  // link 7 (link4), inward
  const Real f6_z = 0.025374999999999998 * a7_x_p6 - 0.861795 * a7_x_p7 - n6_x_p1;

  // link 7 (link4), mass matrix
  const Real qdd_0_p54 = c3 * qdd_0_p24 + s3 * qdd_0_p25;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p55 = 1.0 / (qdd_0_p50 - qdd_0_p32 * qdd_0_p29 - qdd_0_p37 * qdd_0_p35);
  const Real qdd_0_p56 = qdd_0_p50 + qdd_0_p40 - qdd_0_p32 * qdd_0_p41 - qdd_0_p37 * qdd_0_p42;

  // link 6 (link3), inertial wrench
  const Real n6_x_p2 = 0.3056901365 * a7_x_p7 - 0.010673638499999999 * a7_x_p6 -
      0.004704000000000001 * (a7_x_p1 - a7_x_p2) + 0.861795 * minus_a6_z;

  // link 9 (link6), mass matrix
  const Real qdd_0_p57 = c7 * qdd_0_p20;

  // link 6 (link3), inward
  const Real f5_y_p3 = s6 * f6_x + c6 * f6_y;

  // link 7 (link4), inward
  const Real n6_x = n6_x_p2 + (c7 * n7_x - s7 * n7_y + 0.4331 * n6_x_p1);
  const Real n6_y = 0.0067651125 * a7_x_p6 + 0.004704000000000001 * a7_x_p4 - 0.010673638499999999 *
      a7_x_p7 - 0.025374999999999998 * minus_a6_z + (minus_n7_z - 0.0203 * n6_x_p1);

  // link 8 (link5), mass matrix
  const Real qdd_0_p58 = 0.0203 * qdd_0_p4;
  const Real qdd_0_p59 = 0.00064216 * s7 + 0.4331 * qdd_0_p4;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p60 = qdd_0_p56 * qdd_0_p55;

  // link 7 (link4), mass matrix
  const Real qdd_0_p61 = qdd_0_p30 - qdd_0_p16;
  const Real qdd_0_p62 = c7 * qdd_0_p21 + 0.4331 * qdd_0_p9;

  // link 7 (link4), composite inertia
  const Real qdd_0_p63 = 0.004704000000000001 + qdd_0_p31;

  // link 9 (link6), mass matrix
  const Real qdd_0_p64 = s5 * (c6 * qdd_0_p57 + s6 * qdd_0_p10) + c5 *
      (s6 * qdd_0_p57 - c6 * qdd_0_p10);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p65 = 1.7481140020000001 + qdd_0_p50 + 0.8636 * qdd_0_p33 - qdd_0_p47 *
      qdd_0_p41 - qdd_0_p48 * qdd_0_p42 - qdd_0_p60 * qdd_0_p56;

  // link 6 (link3), inward
  const Real f5_y = 3.79559 * f5_y_p1 - 0.10439999999999999 * (f5_y_p2 + a6_x_p1) + f5_y_p3;
  const Real f5_x = 0.10439999999999999 * f5_y_p1 - 3.79559 * a6_x_p3 + n5_y_p1;

  // link 7 (link4), composite inertia
  const Real qdd_0_p66 = 0.0203 * qdd_0_p8 - c7 * qdd_0_p34;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p67 = qdd_0_p28 * qdd_0_p64;

  // link 8 (link5), mass matrix
  const Real qdd_0_p68 = c5 * (c6 * qdd_0_p58 - s6 * qdd_0_p59 +
      (0.1501 * qdd_0_p6 - 0.4318 * qdd_0_p4));

  // link 1 (base_x), mass matrix
  const Real qdd_0_p69 = 1.0 / qdd_0_p65;
  const Real qdd_0_p70 = 24999.999999999996 * qdd_0_p64;

  // link 8 (link5), mass matrix
  const Real qdd_0_p71 = s5 * (c6 * qdd_0_p59 + s6 * qdd_0_p58 + 0.1501 * qdd_0_p5) - qdd_0_p68;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p72 = s3 * qdd_0_p45 - c3 * qdd_0_p46 + qdd_0_p32 * qdd_0_p49 - qdd_0_p37 *
      qdd_0_p54;

  // link 7 (link4), mass matrix
  const Real qdd_0_p73 = c5 * (c6 * qdd_0_p61 - s6 * qdd_0_p62 -
      (0.1501 * qdd_0_p13 + 0.4318 * qdd_0_p9));

  // link 6 (link3), mass matrix
  const Real qdd_0_p74 = c6 * qdd_0_p66 - s6 * qdd_0_p63 - 0.1501 * qdd_0_p33;
  const Real qdd_0_p75 = s6 * qdd_0_p66 + c6 * qdd_0_p63 + 0.1501 * qdd_0_p36;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p76 = 1557.24430048586 * qdd_0_p71;

  // link 1 (base_x), inward
  const Real qdd_4_p1 = tau[8] + minus_n9_z;

  // link 7 (link4), composite inertia
  const Real qdd_0_p77 = 0.3056901365 + (0.0011921599999999998 - qdd_0_p15 + qdd_0_p38 +
      0.0024946559999999996 * c8);
  const Real qdd_0_p78 = 0.0067651125 + (qdd_0_p16 - 0.0406 * qdd_0_p9);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p79 = qdd_0_p7 * qdd_0_p64 - (s5 *
      (0.1501 * qdd_0_p11 - (c6 * qdd_0_p62 + s6 * qdd_0_p61)) + qdd_0_p73);

  // link 7 (link4), composite inertia
  const Real qdd_0_p80 = qdd_0_p62 - 5.846399999999999e-05 * c8 - 0.010673638499999999;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p81 = qdd_0_p79 * qdd_0_p22;

  // link 5 (link2), composite inertia
  const Real qdd_0_p82 = 4.9338049999999996 + qdd_0_p8;

  // link 6 (link3), inertial wrench
  const Real n6_z_p1 = 0.298925024 * a7_x_p4 + 0.004704000000000001 * (wd6_y - a7_x_p3) +
      0.010673638499999999 * (a7_x_p2 - minus_a7_z_p1) +
      (0.861795 * a6_x - 0.025374999999999998 * a6_y);

  // link 6 (link3), inward
  const Real f5_z = f6_z - (7.59118 * wd5_y + 0.20879999999999999 * minus_wd5_x);

  // link 5 (link2), composite inertia
  const Real qdd_0_p83 = s5 * qdd_0_p43 - c5 * qdd_0_p44;

  // link 5 (link2), inertial wrench
  const Real n5_x_p1 = 0.023750999999999998 * (a6_x_p1 - a6_x_p2) -
      (0.14625280000000002 * minus_wd5_x + 0.0141984 * wd5_y + 0.690314699 * f5_y_p1);
  const Real n5_y_p2 = 3.349975204 * wd5_y + 0.023750999999999998 * f5_y_p1 + 0.0141984 *
      minus_wd5_x + 0.690314699 * (f5_y_p2 - a6_x_p1);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p84 = qdd_0_p67 - (s5 * (qdd_0_p74 - 0.4318 * qdd_0_p8 - 0.690314699) + c5 *
      (qdd_0_p75 - 0.023750999999999998));
  const Real qdd_0_p85 = qdd_0_p67 - (s5 * qdd_0_p74 + c5 * qdd_0_p75) - qdd_0_p32 * qdd_0_p71 +
      qdd_0_p37 * qdd_0_p79;

  // link 6 (link3), composite inertia
  const Real qdd_0_p86 = s6 * (qdd_0_p77 - qdd_0_p78) + c6 * (2.0 * qdd_0_p80);

  // link 7 (link4), inward
  const Real n6_z = n6_z_p1 + (s7 * n7_x + c7 * n7_y + (0.0203 * f7_z + 0.4331 * f6_x_p1));

  // link 1 (base_x), mass matrix
  const Real qdd_0_p87 = qdd_0_p85 * qdd_0_p55;

  // link 6 (link3), composite inertia
  const Real qdd_0_p88 = s6 * qdd_0_p86;

  // link 8 (link5), mass matrix
  const Real qdd_0_p89 = c3 * qdd_0_p19 - s3 * qdd_0_p18;

  // link 7 (link4), mass matrix
  const Real qdd_0_p90 = c3 * qdd_0_p25 - s3 * qdd_0_p24;

  // link 4 (link1), mass matrix
  const Real qdd_0_p91 = s4 * qdd_0_p83 - c4 * qdd_0_p82;
  const Real qdd_0_p92 = s4 * qdd_0_p82 + c4 * qdd_0_p83;

  // link 5 (link2), inward
  const Real minus_f4_x = s5 * f5_y - c5 * f5_x;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p93 = 1557.24430048586 * qdd_0_p89;
  const Real qdd_0_p94 = qdd_0_p84 - qdd_0_p47 * qdd_0_p71 + qdd_0_p48 * qdd_0_p79 - qdd_0_p60 *
      qdd_0_p85;
  const Real qdd_0_p95 = qdd_0_p94 * qdd_0_p69;
  const Real qdd_0_p96 = qdd_0_p90 * qdd_0_p22;

  // link 5 (link2), inward
  const Real f4_y = f5_z - 4.9338049999999996 * (w4_z * w4_z);

  // link 6 (link3), composite inertia
  const Real qdd_0_p97 = 1.674987602 + (qdd_0_p78 + qdd_0_p88 + 2.0 *
      (qdd_0_p40 + 0.1501 * qdd_0_p8));

  // link 1 (base_x), mass matrix
  const Real qdd_0_p98 = qdd_0_p37 * qdd_0_p90 - (s3 * qdd_0_p46 + c3 * qdd_0_p45 + qdd_0_p32 *
      qdd_0_p89);

  // link 6 (link3), inward
  const Real n5_x = n5_x_p1 + (c6 * n6_x - s6 * n6_y - 0.1501 * f5_y_p3);
  const Real n5_y = n5_y_p2 + (s6 * n6_x + c6 * n6_y + (0.1501 * n5_y_p1 - 0.4318 * f6_z));

  // link 1 (base_x), inward
  const Real qdd_4_p2 = tau[7] - n8_z;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p99 = qdd_0_p98 * qdd_0_p55;
  const Real qdd_0_p100 = s3 * qdd_0_p52 - c3 * qdd_0_p53 + qdd_0_p47 * qdd_0_p49 - qdd_0_p48 *
      qdd_0_p54 - qdd_0_p60 * qdd_0_p72;

  // link 1 (base_x), inward
  const Real qdd_4_p3 = n6_z + qdd_0_p28 * qdd_4_p1;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p101 = qdd_0_p48 * qdd_0_p90 - (s3 * qdd_0_p53 + c3 * qdd_0_p52 + qdd_0_p47 *
      qdd_0_p89) - qdd_0_p60 * qdd_0_p98;
  const Real qdd_0_p102 = 1557.24430048586 * qdd_0_p49;

  // link 1 (base_x), inward
  const Real qdd_4_p4 = tau[4] - 1.601861202 * f5_y_p1 - 0.0070992 * (a6_x_p2 - f5_y_p2) -
      1.024164 * s5 + 37.2347379 * c5;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p103 = s3 * qdd_0_p91 - c3 * qdd_0_p92 - qdd_0_p76 * qdd_0_p89 - qdd_0_p81 *
      qdd_0_p90 - qdd_0_p87 * qdd_0_p98;
  const Real qdd_0_p104 = qdd_0_p101 * qdd_0_p69;

  // link 5 (link2), composite inertia
  const Real qdd_0_p105 = s5 * (0.07312640000000001 + (qdd_0_p77 - qdd_0_p88 + 0.3002 * qdd_0_p8) -
      qdd_0_p97) + c5 * (2.0 * (c6 * qdd_0_p86 - qdd_0_p80 + 0.4318 * qdd_0_p36 - 0.0070992));

  // link 1 (base_x), inward
  const Real qdd_4_p5 = tau[6] + minus_n7_z - qdd_0_p7 * qdd_4_p1;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p106 = c3 * qdd_0_p91 + s3 * qdd_0_p92 + qdd_0_p76 * qdd_0_p49 + qdd_0_p81 *
      qdd_0_p54 - qdd_0_p87 * qdd_0_p72;
  const Real qdd_0_p107 = qdd_0_p54 * qdd_0_p22;
  const Real qdd_0_p108 = qdd_0_p103 - qdd_0_p95 * qdd_0_p101;

  // link 4 (link1), inward
  const Real minus_f3_x = c4 * minus_f4_x + s4 * f4_y;
  const Real f3_y = c4 * f4_y - s4 * minus_f4_x;

  // link 5 (link2), inward
  const Real minus_n4_z = s5 * n5_x + c5 * n5_y;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p109 = qdd_0_p106 - qdd_0_p95 * qdd_0_p100;
  const Real qdd_0_p110 = qdd_0_p72 * qdd_0_p55;
  const Real qdd_0_p111 = 186.45 - qdd_0_p93 * qdd_0_p89 - qdd_0_p96 * qdd_0_p90 - qdd_0_p99 *
      qdd_0_p98 - qdd_0_p104 * qdd_0_p101;

  // link 1 (base_x), inward
  const Real qdd_4_p6 = tau[5] - qdd_4_p3 - qdd_0_p32 * qdd_4_p2 + qdd_0_p37 * qdd_4_p5;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p112 = qdd_0_p100 * qdd_0_p69;

  // link 3 (base), inward
  const Real f2_z = c3 * f3_y - s3 * minus_f3_x;
  const Real minus_f2_x = c3 * minus_f3_x + s3 * f3_y;

  // link 1 (base_x), inward
  const Real qdd_4_p7 = qdd_4_p4 - qdd_4_p3 - 0.4318 * f5_y_p3 - qdd_0_p47 * qdd_4_p2 + qdd_0_p48 *
      qdd_4_p5 - qdd_0_p60 * qdd_4_p6;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p113 = 186.45 - qdd_0_p102 * qdd_0_p49 - qdd_0_p107 * qdd_0_p54 - qdd_0_p110 *
      qdd_0_p72 - qdd_0_p112 * qdd_0_p100;
  const Real qdd_0_p114 = 1.4717295504999999 + (qdd_0_p97 + s5 * qdd_0_p105) - qdd_0_p70 *
      qdd_0_p64 - qdd_0_p76 * qdd_0_p71 - qdd_0_p81 * qdd_0_p79;

  // link 1 (base_x), inward
  const Real qdd_4_p8 = tau[3] + minus_n4_z + qdd_0_p70 * qdd_4_p1 - qdd_0_p76 * qdd_4_p2 -
      qdd_0_p81 * qdd_4_p5 - qdd_0_p87 * qdd_4_p6;
  const Real qdd_2 = 0.1388888888888889 * (tau[2] - tau[3]);
  qdd[2] = qdd_2;
  const Real qdd_4_p9 = qdd_4_p8 - qdd_0_p95 * qdd_4_p7;
  const Real qdd_1_p1 = tau[1] - f2_z - qdd_0_p93 * qdd_4_p2 - qdd_0_p96 * qdd_4_p5 - qdd_0_p99 *
      qdd_4_p6 - qdd_0_p104 * qdd_4_p7;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p115 = 1.0 / (qdd_0_p114 - qdd_0_p87 * qdd_0_p85 - qdd_0_p95 * qdd_0_p94);

  // link 1 (base_x), inward
  const Real qdd_0_p116 = tau[0] + minus_f2_x + qdd_0_p102 * qdd_4_p2 + qdd_0_p107 * qdd_4_p5 -
      qdd_0_p110 * qdd_4_p6 - qdd_0_p112 * qdd_4_p7;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p117 = qdd_0_p108 * qdd_0_p115;
  const Real qdd_0_p118 = qdd_0_p109 * qdd_0_p115;
  const Real qdd_0_p119 = qdd_0_p93 * qdd_0_p49 + qdd_0_p96 * qdd_0_p54 - qdd_0_p99 * qdd_0_p72 -
      qdd_0_p104 * qdd_0_p100 - qdd_0_p117 * qdd_0_p109;

  // link 1 (base_x), inward
  const Real qdd_1_p2 = qdd_1_p1 - qdd_0_p117 * qdd_4_p9;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p120 = 1.0 / (qdd_0_p111 - qdd_0_p117 * qdd_0_p108);
  const Real qdd_0_p121 = qdd_0_p119 * qdd_0_p120;

  // link 1 (base_x), inward
  const Real qdd_0 = (qdd_0_p116 - qdd_0_p118 * qdd_4_p9 - qdd_0_p121 * qdd_1_p2) *
      (1.0 / (qdd_0_p113 - qdd_0_p118 * qdd_0_p109 - qdd_0_p121 * qdd_0_p119));
  qdd[0] = qdd_0;
  const Real qdd_1 = qdd_1_p2 * qdd_0_p120 - qdd_0_p121 * qdd_0;
  qdd[1] = qdd_1;
  const Real qdd_4_p10 = qdd_4_p9 * qdd_0_p115 - qdd_0_p118 * qdd_0 - qdd_0_p117 * qdd_1;
  qdd[3] = qdd_4_p10 - qdd_2;
  const Real qdd_4 = qdd_4_p7 * qdd_0_p69 - qdd_0_p112 * qdd_0 - qdd_0_p104 * qdd_1 - qdd_4_p10 *
      qdd_0_p95;
  qdd[4] = qdd_4;
  const Real qdd_5 = qdd_4_p6 * qdd_0_p55 - qdd_0_p110 * qdd_0 - qdd_0_p99 * qdd_1 - qdd_0_p60 *
      qdd_4 - qdd_4_p10 * qdd_0_p87;
  qdd[5] = qdd_5;
  const Real qdd_6_p1 = qdd_4_p5 * qdd_0_p22 + qdd_0_p107 * qdd_0 - qdd_0_p96 * qdd_1 + qdd_0_p48 *
      qdd_4 + qdd_0_p37 * qdd_5;
  const Real qdd_7_p1 = 1557.24430048586 * qdd_4_p2 + qdd_0_p102 * qdd_0 - qdd_0_p93 * qdd_1 -
      qdd_0_p47 * qdd_4 - qdd_0_p32 * qdd_5;
  const Real qdd_6 = qdd_6_p1 - qdd_4_p10 * qdd_0_p81;
  qdd[6] = qdd_6;
  qdd[7] = qdd_7_p1 - qdd_4_p10 * qdd_0_p76;
  qdd[8] = 24999.999999999996 * qdd_4_p1 - qdd_0_p7 * qdd_6 - (qdd_4 + qdd_5) * qdd_0_p28 +
      qdd_4_p10 * qdd_0_p70;
}

}  // namespace samm

#undef TREELINE_RESTRICT
