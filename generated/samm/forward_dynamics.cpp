// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 819 flops (add 353, mul 460, div 6), sine and cosine of 7 angles
// Generated; see samm.hpp for the contract.
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

  // link 6 (link3), outward
  const Real minus_a6_z = 0.1501 * (f5_y_p2 + minus_f5_x_p2) + 0.8636 * wd5_y;

  // link 7 (link4), outward
  const Real minus_a7_x_p1 = minus_a6_z + 0.4331 * minus_f6_z_p2 - 0.0203 * minus_f6_z_p4;

  // link 6 (link3), outward
  const Real minus_a6_x_p1 = 9.81 * c5 - 0.4318 * f5_y_p4;
  const Real minus_a6_x_p2 = 9.81 * s5 + 0.4318 * minus_f5_x_p3;
  const Real minus_a6_x = s6 * minus_a6_x_p1 + c6 * minus_a6_x_p2;

  // link 7 (link4), outward
  const Real minus_a7_x_p2 = minus_a6_x + 0.4331 * f6_y_p4 - 0.0203 * f6_x_p3;
  const Real minus_a7_x = s7 * minus_a7_x_p1 + c7 * minus_a7_x_p2;

  // link 6 (link3), outward
  const Real minus_a6_y = c6 * minus_a6_x_p1 - s6 * minus_a6_x_p2;

  // link 7 (link4), outward
  const Real a7_z = minus_a6_y - 0.4331 * f6_y_p3 + 0.0203 * f6_y_p4;

  // link 8 (link5), outward
  const Real minus_a8_x = s8 * a7_z + c8 * minus_a7_x;

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
  const Real minus_n8_z = 0.00062216 * minus_wd7_y + 0.00022215999999999997 * minus_f8_x_p1 +
      0.0028799999999999997 * minus_a8_x + c9 * minus_n9_y - s9 * n9_x;

  // link 1 (base_x), inward
  const Real qdd_0_p1 = tau[7] + minus_n8_z;

  // link 8 (link5), composite inertia
  const Real qdd_0_p2 = 0.0028799999999999997 * s8;
  const Real qdd_0_p3 = 0.0028799999999999997 * c8;

  // link 8 (link5), mass matrix
  const Real qdd_0_p4 = c7 * qdd_0_p3;
  const Real qdd_0_p5 = c6 * qdd_0_p2 + s6 * qdd_0_p4;
  const Real qdd_0_p6 = s6 * qdd_0_p2 - c6 * qdd_0_p4;
  const Real qdd_0_p7 = s5 * qdd_0_p5 + c5 * qdd_0_p6;
  const Real qdd_0_p8 = s7 * qdd_0_p3;
  const Real qdd_0_p9 = c4 * qdd_0_p8 - s4 * qdd_0_p7;
  const Real qdd_0_p10 = s4 * qdd_0_p8 + c4 * qdd_0_p7;
  const Real qdd_0_p11 = s3 * qdd_0_p9 + c3 * qdd_0_p10;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p12 = 1557.24430048586 * qdd_0_p11;

  // link 7 (link4), outward
  const Real minus_a7_y = c7 * minus_a7_x_p1 - s7 * minus_a7_x_p2;

  // link 9 (link6), inward
  const Real n8_x = 0.00042216 * minus_f8_z_p1 + 0.0028799999999999997 * minus_a7_y + s9 *
      minus_n9_y + c9 * n9_x;

  // link 8 (link5), outward
  const Real wd8_y = c8 * wd6_y - s8 * wd7_x + qd[7] * minus_w8_x;

  // link 9 (link6), inertial wrench
  const Real minus_n9_z = 4e-05 * wd8_y;

  // link 9 (link6), inward
  const Real n8_y = minus_n9_z + 2e-04 * (wd8_y + minus_w8_x * w8_z);

  // link 8 (link5), inward
  const Real minus_n7_z = 0.0013999999999999998 * wd6_y + w7_y * (9.999999999999994e-05 * w7_x) +
      c8 * n8_y + s8 * n8_x;

  // link 1 (base_x), inward
  const Real qdd_0_p13 = tau[8] + minus_n9_z;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p14 = 0.9999999999999999 * c8;

  // link 1 (base_x), inward
  const Real qdd_0_p15 = tau[6] + minus_n7_z - qdd_0_p14 * qdd_0_p13;

  // link 7 (link4), composite inertia
  const Real qdd_0_p16 = s7 * qdd_0_p2;

  // link 7 (link4), mass matrix
  const Real qdd_0_p17 = s6 * qdd_0_p16;
  const Real qdd_0_p18 = c6 * qdd_0_p16;
  const Real qdd_0_p19 = s5 * qdd_0_p17 - c5 * qdd_0_p18;

  // link 7 (link4), composite inertia
  const Real qdd_0_p20 = c7 * qdd_0_p2;

  // link 7 (link4), mass matrix
  const Real qdd_0_p21 = c4 * qdd_0_p20 + s4 * qdd_0_p19;
  const Real qdd_0_p22 = s4 * qdd_0_p20 - c4 * qdd_0_p19;
  const Real qdd_0_p23 = s3 * qdd_0_p21 + c3 * qdd_0_p22;

  // link 9 (link6), mass matrix
  const Real qdd_0_p24 = 4e-05 * c8;

  // link 8 (link5), composite inertia
  const Real qdd_0_p25 = 0.00020215999999999998 * s8;
  const Real qdd_0_p26 = s8 * qdd_0_p25;
  const Real qdd_0_p27 = 0.00164 + qdd_0_p26;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p28 = 1.0 / (qdd_0_p27 - qdd_0_p24 * qdd_0_p14);
  const Real qdd_0_p29 = qdd_0_p23 * qdd_0_p28;

  // link 1 (base_x), inward
  const Real qdd_0_p30 = tau[0] - s3 * minus_f3_y - c3 * f3_x + qdd_0_p12 * qdd_0_p1 + qdd_0_p29 *
      qdd_0_p15;

  // link 7 (link4), inward
  const Real minus_n6_z_p1 = 0.010673638499999999 * (f6_y_p1 - f6_x_p2) - 0.004704000000000001 *
      (wd6_y - minus_f6_z_p3) + 0.298925024 * f6_y_p4 + 0.861795 * minus_a6_x;

  // link 8 (link5), inward
  const Real minus_n7_y = minus_n8_z + 0.00065 * (minus_wd7_y + w7_x * w7_z);

  // link 7 (link4), inward
  const Real minus_n6_z_p2 = minus_n6_z_p1 - 0.025374999999999998 * minus_a6_y - 0.4331 * f6_x_p1 +
      0.0203 * minus_f7_z + c7 * minus_n7_y;

  // link 8 (link5), inward
  const Real n7_x = 0.0007499999999999999 * (wd7_x + w7_y * w7_z) - s8 * n8_y + c8 * n8_x;

  // link 7 (link4), inward
  const Real minus_n6_z = minus_n6_z_p2 - s7 * n7_x;

  // link 9 (link6), mass matrix
  const Real qdd_0_p31 = 4e-05 * s8;
  const Real qdd_0_p32 = s7 * qdd_0_p31;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p33 = 24999.999999999996 * qdd_0_p32;

  // link 1 (base_x), inward
  const Real qdd_0_p34 = qdd_0_p33 * qdd_0_p13;

  // link 8 (link5), mass matrix
  const Real qdd_0_p35 = 0.4331 * qdd_0_p4 - 5.846399999999999e-05 * s8 + 0.00064216 * c7;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p36 = 1557.24430048586 * qdd_0_p35;

  // link 8 (link5), composite inertia
  const Real qdd_0_p37 = c8 * qdd_0_p25;

  // link 7 (link4), composite inertia
  const Real qdd_0_p38 = 0.4331 * qdd_0_p16 + s7 * qdd_0_p37;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p39 = qdd_0_p32 * qdd_0_p14;
  const Real qdd_0_p40 = qdd_0_p38 + qdd_0_p39;
  const Real qdd_0_p41 = qdd_0_p40 * qdd_0_p28;

  // link 1 (base_x), inward
  const Real qdd_0_p42 = qdd_0_p34 - (tau[5] + minus_n6_z) + qdd_0_p36 * qdd_0_p1 - qdd_0_p41 *
      qdd_0_p15;

  // link 7 (link4), composite inertia
  const Real qdd_0_p43 = 0.861795 + qdd_0_p3;
  const Real qdd_0_p44 = 0.025374999999999998 - qdd_0_p20;

  // link 6 (link3), composite inertia
  const Real qdd_0_p45 = s6 * qdd_0_p43 - c6 * qdd_0_p44;
  const Real qdd_0_p46 = c6 * qdd_0_p43 + s6 * qdd_0_p44;

  // link 6 (link3), mass matrix
  const Real qdd_0_p47 = s5 * qdd_0_p45 - c5 * qdd_0_p46;
  const Real qdd_0_p48 = s4 * qdd_0_p47;
  const Real qdd_0_p49 = c4 * qdd_0_p47;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p50 = s3 * qdd_0_p48 - c3 * qdd_0_p49 + qdd_0_p11 * qdd_0_p36 - qdd_0_p23 *
      qdd_0_p41;

  // link 7 (link4), composite inertia
  const Real qdd_0_p51 = 0.0203 * qdd_0_p20;
  const Real qdd_0_p52 = s7 * (0.00010000000000000026 + qdd_0_p26);
  const Real qdd_0_p53 = s7 * qdd_0_p52;
  const Real qdd_0_p54 = qdd_0_p53 + (2.0 * (qdd_0_p51 - 0.0012473279999999998 * c8) - 0.313747409);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p55 = qdd_0_p32 * qdd_0_p33;
  const Real qdd_0_p56 = 1.0 / (qdd_0_p54 + qdd_0_p55 + qdd_0_p35 * qdd_0_p36 + qdd_0_p40 *
      qdd_0_p41);
  const Real qdd_0_p57 = qdd_0_p50 * qdd_0_p56;

  // link 1 (base_x), inward
  const Real qdd_0_p58 = tau[4] + 0.0070992 * (f5_y_p2 - minus_f5_x_p2) - 1.601861202 * f5_y_p4 -
      1.024164 * s5 + 37.2347379 * c5;

  // link 8 (link5), mass matrix
  const Real qdd_0_p59 = qdd_0_p35 + 0.4318 * qdd_0_p5;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p60 = 1557.24430048586 * qdd_0_p59;
  const Real qdd_0_p61 = qdd_0_p39 + (qdd_0_p38 + 0.4318 * qdd_0_p17);
  const Real qdd_0_p62 = qdd_0_p61 * qdd_0_p28;

  // link 1 (base_x), inward
  const Real qdd_0_p63 = qdd_0_p34 - (minus_n6_z + qdd_0_p58 - 0.4318 * f5_y_p1) + qdd_0_p60 *
      qdd_0_p1 - qdd_0_p62 * qdd_0_p15;

  // link 6 (link3), composite inertia
  const Real qdd_0_p64 = 0.4318 * qdd_0_p45;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p65 = qdd_0_p55 + (qdd_0_p54 - qdd_0_p64) + qdd_0_p59 * qdd_0_p36 + qdd_0_p61 *
      qdd_0_p41;
  const Real qdd_0_p66 = qdd_0_p65 * qdd_0_p56;

  // link 1 (base_x), inward
  const Real qdd_0_p67 = qdd_0_p63 - qdd_0_p66 * qdd_0_p42;

  // link 6 (link3), composite inertia
  const Real qdd_0_p68 = 0.10439999999999999 - qdd_0_p46;
  const Real qdd_0_p69 = 3.79559 + qdd_0_p45;

  // link 5 (link2), composite inertia
  const Real qdd_0_p70 = c5 * qdd_0_p68 + s5 * qdd_0_p69;

  // link 5 (link2), mass matrix
  const Real qdd_0_p71 = s4 * qdd_0_p70;
  const Real qdd_0_p72 = c4 * qdd_0_p70;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p73 = s3 * qdd_0_p71 - c3 * qdd_0_p72 + qdd_0_p11 * qdd_0_p60 - qdd_0_p23 *
      qdd_0_p62 - qdd_0_p50 * qdd_0_p66;
  const Real qdd_0_p74 = qdd_0_p55 - (1.7481140020000001 - qdd_0_p54 + 0.8636 * qdd_0_p45) +
      qdd_0_p59 * qdd_0_p60 + qdd_0_p61 * qdd_0_p62;
  const Real qdd_0_p75 = 1.0 / (qdd_0_p74 - qdd_0_p65 * qdd_0_p66);
  const Real qdd_0_p76 = qdd_0_p73 * qdd_0_p75;

  // link 6 (link3), inward
  const Real n5_y_p1 = 0.690314699 * (f5_y_p2 - f5_y_p3) + 0.0141984 * minus_wd5_x +
      0.023750999999999998 * f5_y_p4 + 3.349975204 * wd5_y;

  // link 7 (link4), inward
  const Real n6_y_p1 = minus_n7_z - (0.010673638499999999 * minus_f6_z_p2 + 0.004704000000000001 *
      f6_y_p4 - 0.0067651125 * minus_f6_z_p4 + 0.025374999999999998 * minus_a6_z);
  const Real n6_y = n6_y_p1 - 0.0203 * minus_f6_z_p1;
  const Real n6_x_p1 = 0.004704000000000001 * (f6_x_p2 - f6_y_p2) - 0.010673638499999999 *
      minus_f6_z_p4 + 0.3056901365 * minus_f6_z_p2 + 0.861795 * minus_a6_z;
  const Real n6_x = n6_x_p1 + 0.4331 * minus_f6_z_p1 + s7 * minus_n7_y + c7 * n7_x;

  // link 6 (link3), inward
  const Real n5_y = n5_y_p1 + 0.4318 * minus_f6_z - 0.1501 * minus_f5_x_p1 + c6 * n6_y + s6 * n6_x;
  const Real minus_n5_x_p1 = 0.023750999999999998 * (minus_f5_x_p2 - f5_y_p3) + 0.690314699 *
      f5_y_p4 + 0.0141984 * wd5_y + 0.14625280000000002 * minus_wd5_x;
  const Real minus_n5_x = minus_n5_x_p1 + 0.1501 * f5_y_p1 + s6 * n6_y - c6 * n6_x;

  // link 9 (link6), mass matrix
  const Real qdd_0_p77 = c7 * qdd_0_p31;
  const Real qdd_0_p78 = c5 * (c6 * qdd_0_p24 - s6 * qdd_0_p77) - s5 *
      (s6 * qdd_0_p24 + c6 * qdd_0_p77);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p79 = 24999.999999999996 * qdd_0_p78;

  // link 8 (link5), mass matrix
  const Real qdd_0_p80 = 0.0203 * qdd_0_p8;
  const Real qdd_0_p81 = 0.4331 * qdd_0_p8 + 0.00064216 * s7;
  const Real qdd_0_p82 = c5 * (0.4318 * qdd_0_p8 + 0.1501 * qdd_0_p6 - c6 * qdd_0_p80 + s6 *
      qdd_0_p81);
  const Real qdd_0_p83 = qdd_0_p82 + s5 * (0.1501 * qdd_0_p5 + s6 * qdd_0_p80 + c6 * qdd_0_p81);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p84 = 1557.24430048586 * qdd_0_p83;

  // link 1 (base_x), inward
  const Real qdd_0_p85 = tau[3] + c5 * n5_y - s5 * minus_n5_x - qdd_0_p79 * qdd_0_p13 - qdd_0_p84 *
      qdd_0_p1;

  // link 7 (link4), mass matrix
  const Real qdd_0_p86 = qdd_0_p27 - qdd_0_p51;

  // link 7 (link4), composite inertia
  const Real qdd_0_p87 = 0.4331 * qdd_0_p20;
  const Real qdd_0_p88 = c7 * qdd_0_p37;

  // link 7 (link4), mass matrix
  const Real qdd_0_p89 = qdd_0_p87 + qdd_0_p88;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p90 = c5 * (0.4318 * qdd_0_p20 + 0.1501 * qdd_0_p18 + c6 * qdd_0_p86 + s6 *
      qdd_0_p89);
  const Real qdd_0_p91 = qdd_0_p90 - s5 * (0.1501 * qdd_0_p17 + s6 * qdd_0_p86 - c6 * qdd_0_p89) -
      qdd_0_p78 * qdd_0_p14;
  const Real qdd_0_p92 = qdd_0_p91 * qdd_0_p28;

  // link 7 (link4), composite inertia
  const Real qdd_0_p93 = 0.004704000000000001 + qdd_0_p38;
  const Real qdd_0_p94 = 0.0203 * qdd_0_p16 - c7 * qdd_0_p52;

  // link 6 (link3), composite inertia
  const Real qdd_0_p95 = 0.1501 * qdd_0_p46 + c6 * qdd_0_p93 + s6 * qdd_0_p94;
  const Real qdd_0_p96 = s6 * qdd_0_p93 - c6 * qdd_0_p94;
  const Real qdd_0_p97 = 0.1501 * qdd_0_p45;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p98 = qdd_0_p78 * qdd_0_p33;
  const Real qdd_0_p99 = qdd_0_p98 + (c5 * qdd_0_p95 - s5 * (qdd_0_p97 + qdd_0_p96)) + qdd_0_p83 *
      qdd_0_p36 - qdd_0_p91 * qdd_0_p41;
  const Real qdd_0_p100 = qdd_0_p99 * qdd_0_p56;
  const Real qdd_0_p101 = c5 * (0.023750999999999998 - qdd_0_p95) + s5 *
      (qdd_0_p96 + (0.690314699 + qdd_0_p97 + 0.4318 * qdd_0_p16));
  const Real qdd_0_p102 = qdd_0_p98 - qdd_0_p101 + qdd_0_p83 * qdd_0_p60 - qdd_0_p91 * qdd_0_p62 -
      qdd_0_p99 * qdd_0_p66;
  const Real qdd_0_p103 = qdd_0_p102 * qdd_0_p75;

  // link 1 (base_x), inward
  const Real qdd_0_p104 = qdd_0_p85 - qdd_0_p92 * qdd_0_p15 + qdd_0_p100 * qdd_0_p42 + qdd_0_p103 *
      qdd_0_p67;

  // link 7 (link4), composite inertia
  const Real qdd_0_p105 = qdd_0_p88 - (0.010673638499999999 - qdd_0_p87 + 5.846399999999999e-05 *
      c8);
  const Real qdd_0_p106 = qdd_0_p53 + (0.0011921599999999998 -
      (qdd_0_p26 - (0.3056901365 + 0.0024946559999999996 * c8)));
  const Real qdd_0_p107 = 0.008405112499999999 + qdd_0_p26 - 0.0406 * qdd_0_p20;

  // link 6 (link3), composite inertia
  const Real qdd_0_p108 = qdd_0_p105 * (2.0 * c6) + s6 * (qdd_0_p106 - qdd_0_p107);
  const Real qdd_0_p109 = s6 * qdd_0_p108;
  const Real qdd_0_p110 = qdd_0_p109 + (qdd_0_p107 +
      (1.674987602 + 2.0 * (qdd_0_p64 + 0.1501 * qdd_0_p16)));

  // link 5 (link2), composite inertia
  const Real qdd_0_p111 = (qdd_0_p105 + (0.0070992 - 0.4318 * qdd_0_p46) - c6 * qdd_0_p108) *
      (2.0 * c5) + s5 * (qdd_0_p110 + (qdd_0_p109 - (qdd_0_p106 +
      (0.07312640000000001 + 0.3002 * qdd_0_p16))));

  // link 1 (base_x), mass matrix
  const Real qdd_0_p112 = 1.4717295504999999 + qdd_0_p110 - s5 * qdd_0_p111 - qdd_0_p78 *
      qdd_0_p79 - qdd_0_p83 * qdd_0_p84 - qdd_0_p91 * qdd_0_p92;
  const Real qdd_0_p113 = 1.0 / (qdd_0_p112 + qdd_0_p99 * qdd_0_p100 + qdd_0_p102 * qdd_0_p103);

  // link 5 (link2), composite inertia
  const Real qdd_0_p114 = s5 * qdd_0_p68 - c5 * qdd_0_p69;
  const Real qdd_0_p115 = 4.9338049999999996 + qdd_0_p16;

  // link 4 (link1), composite inertia
  const Real qdd_0_p116 = c4 * qdd_0_p115 - s4 * qdd_0_p114;
  const Real qdd_0_p117 = s4 * qdd_0_p115 + c4 * qdd_0_p114;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p118 = c3 * qdd_0_p116 - s3 * qdd_0_p117 - qdd_0_p11 * qdd_0_p84 - qdd_0_p23 *
      qdd_0_p92 + qdd_0_p50 * qdd_0_p100;
  const Real qdd_0_p119 = qdd_0_p118 + qdd_0_p73 * qdd_0_p103;
  const Real qdd_0_p120 = qdd_0_p119 * qdd_0_p113;

  // link 8 (link5), mass matrix
  const Real qdd_0_p121 = c3 * qdd_0_p9 - s3 * qdd_0_p10;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p122 = 1557.24430048586 * qdd_0_p121;

  // link 7 (link4), mass matrix
  const Real qdd_0_p123 = c3 * qdd_0_p21 - s3 * qdd_0_p22;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p124 = qdd_0_p123 * qdd_0_p28;

  // link 1 (base_x), inward
  const Real qdd_0_p125 = tau[1] + c3 * minus_f3_y - s3 * f3_x - qdd_0_p122 * qdd_0_p1 -
      qdd_0_p124 * qdd_0_p15;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p126 = c3 * qdd_0_p48 + s3 * qdd_0_p49 + qdd_0_p121 * qdd_0_p36 - qdd_0_p123 *
      qdd_0_p41;
  const Real qdd_0_p127 = qdd_0_p126 * qdd_0_p56;
  const Real qdd_0_p128 = c3 * qdd_0_p71 + s3 * qdd_0_p72 + qdd_0_p121 * qdd_0_p60 - qdd_0_p123 *
      qdd_0_p62 - qdd_0_p126 * qdd_0_p66;
  const Real qdd_0_p129 = qdd_0_p128 * qdd_0_p75;
  const Real qdd_0_p130 = s3 * qdd_0_p116 + c3 * qdd_0_p117 + qdd_0_p121 * qdd_0_p84 + qdd_0_p123 *
      qdd_0_p92 - qdd_0_p126 * qdd_0_p100;
  const Real qdd_0_p131 = qdd_0_p130 - qdd_0_p128 * qdd_0_p103;
  const Real qdd_0_p132 = qdd_0_p131 * qdd_0_p113;

  // link 1 (base_x), inward
  const Real qdd_0_p133 = qdd_0_p125 + qdd_0_p127 * qdd_0_p42 + qdd_0_p129 * qdd_0_p67 +
      qdd_0_p132 * qdd_0_p104;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p134 = qdd_0_p11 * qdd_0_p122 + qdd_0_p23 * qdd_0_p124 - qdd_0_p50 * qdd_0_p127 -
      qdd_0_p73 * qdd_0_p129 - qdd_0_p119 * qdd_0_p132;
  const Real qdd_0_p135 = 186.45 - qdd_0_p121 * qdd_0_p122 - qdd_0_p123 * qdd_0_p124 + qdd_0_p126 *
      qdd_0_p127 + qdd_0_p128 * qdd_0_p129;
  const Real qdd_0_p136 = 1.0 / (qdd_0_p135 - qdd_0_p131 * qdd_0_p132);
  const Real qdd_0_p137 = qdd_0_p134 * qdd_0_p136;

  // link 1 (base_x), inward
  const Real qdd_0_p138 = qdd_0_p30 - qdd_0_p57 * qdd_0_p42 - qdd_0_p76 * qdd_0_p67 + qdd_0_p120 *
      qdd_0_p104 - qdd_0_p137 * qdd_0_p133;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p139 = 186.45 - qdd_0_p11 * qdd_0_p12 - qdd_0_p23 * qdd_0_p29 + qdd_0_p50 *
      qdd_0_p57 + qdd_0_p73 * qdd_0_p76;

  // link 1 (base_x), inward
  const Real qdd_0 = 1.0 / (qdd_0_p139 - qdd_0_p119 * qdd_0_p120 - qdd_0_p134 * qdd_0_p137) *
      qdd_0_p138;
  qdd[0] = qdd_0;
  const Real qdd_1 = qdd_0_p136 * qdd_0_p133 - qdd_0_p137 * qdd_0;
  qdd[1] = qdd_1;
  const Real qdd_2 = 0.1388888888888889 * (tau[2] - tau[3]);
  qdd[2] = qdd_2;
  const Real qdd_3 = qdd_2 - qdd_0_p113 * qdd_0_p104 - qdd_0_p120 * qdd_0 - qdd_0_p132 * qdd_1;
  qdd[3] = -qdd_3;
  const Real qdd_4_p1 = qdd_2 - qdd_3;
  const Real qdd_4 = qdd_0_p103 * qdd_4_p1 - (qdd_0_p75 * qdd_0_p67 + qdd_0_p76 * qdd_0 -
      qdd_0_p129 * qdd_1);
  qdd[4] = -qdd_4;
  const Real qdd_5 = qdd_0_p100 * qdd_4_p1 - (qdd_0_p56 * qdd_0_p42 + qdd_0_p57 * qdd_0 -
      qdd_0_p127 * qdd_1 + qdd_0_p66 * qdd_4);
  qdd[5] = -qdd_5;
  const Real qdd_6_p1 = qdd_0_p28 * qdd_0_p15 + qdd_0_p29 * qdd_0 - qdd_0_p124 * qdd_1 - qdd_0_p62 *
      qdd_4 - qdd_0_p41 * qdd_5;
  const Real qdd_6 = qdd_0_p92 * qdd_4_p1 - qdd_6_p1;
  qdd[6] = -qdd_6;
  const Real qdd_7_p1 = 1557.24430048586 * qdd_0_p1 + qdd_0_p12 * qdd_0 - qdd_0_p122 * qdd_1 +
      qdd_0_p60 * qdd_4 + qdd_0_p36 * qdd_5;
  qdd[7] = -(qdd_0_p84 * qdd_4_p1 - qdd_7_p1);
  qdd[8] = -(qdd_0_p79 * qdd_4_p1 - (qdd_0_p33 * (qdd_4 + qdd_5) +
      (24999.999999999996 * qdd_0_p13 + qdd_0_p14 * qdd_6)));
}

}  // namespace samm

#undef TREELINE_RESTRICT
