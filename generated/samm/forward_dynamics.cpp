// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 638 flops (add 266, mul 366, div 6), sine and cosine of 6 angles
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
  const Real angles[6] = {q[2], q[3], q[4], q[5], q[6], q[7]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s3 = sines[0];
  const Real s4 = sines[1];
  const Real s5 = sines[2];
  const Real s6 = sines[3];
  const Real c5 = cosines[2];
  const Real c6 = cosines[3];
  const Real s7 = sines[4];
  const Real s8 = sines[5];
  const Real c7 = cosines[4];
  const Real c8 = cosines[5];
  const Real a6_x_p1 = 0.4318 * c5;
  const Real a6_y_p1 = 0.4318 * s5;

  // link 4 (link1), outward
  const Real w4_z = qd[2] + qd[3];

  // link 6 (link3), outward
  const Real w6_z = qd[4] + qd[5];

  // link 5 (link2), outward
  const Real a6_y_p2 = qd[4] * qd[4];
  const Real a7_x_p1 = s5 * c6 + c5 * s6;
  const Real a7_x_p2 = s5 * s6 - c5 * c6;

  // link 4 (link1), outward
  const Real a7_x_p3 = w4_z * w4_z;

  // link 6 (link3), outward
  const Real a7_x_p4 = w6_z * w6_z;
  const Real wd6_x = w4_z * w6_z;

  // link 5 (link2), outward
  const Real wd5_x = w4_z * qd[4];
  const Real qdd_0_p1 = c3 * c4 - s3 * s4;

  // link 8 (link5), composite inertia
  const Real qdd_0_p2 = 0.0028799999999999997 * c8;
  const Real qdd_0_p3 = 0.0028799999999999997 * s8;

  // link 7 (link4), outward
  const Real w7_x_p1 = a7_x_p1 * w4_z;

  // link 6 (link3), outward
  const Real a7_x_p5 = a7_x_p3 + a7_x_p4;

  // link 8 (link5), mass matrix
  const Real qdd_0_p4 = c7 * qdd_0_p2;
  const Real qdd_0_p5 = s7 * qdd_0_p2;

  // link 5 (link2), outward
  const Real a6_x_p2 = a7_x_p3 + a6_y_p2;

  // link 7 (link4), outward
  const Real n8_x_p1 = a7_x_p2 * wd6_x;
  const Real a7_x_p6 = 0.0203 * a7_x_p2 + 0.4331 * a7_x_p1;

  // link 5 (link2), outward
  const Real minus_a6_z_p1 = 2.0 * wd5_x;

  // link 6 (link3), outward
  const Real a6_y = 9.81 + a6_y_p2 * a6_y_p1;
  const Real a7_x_p7 = 0.0203 * a7_x_p1 - 0.4331 * a7_x_p2;
  const Real qdd_0_p6 = 0.025374999999999998 * a7_x_p2 + 0.861795 * a7_x_p1;
  const Real a7_x_p8 = 2.0 * wd6_x;

  // link 7 (link4), outward
  const Real minus_wd7_z = a7_x_p1 * wd6_x;
  const Real qdd_0_p7 = 0.025374999999999998 * a7_x_p1 - 0.861795 * a7_x_p2;
  const Real w7_z = qd[6] - a7_x_p2 * w4_z;

  // link 6 (link3), outward
  const Real a6_x = a6_x_p2 * a6_x_p1;

  // link 7 (link4), outward
  const Real w7_x = s7 * w6_z - c7 * w7_x_p1;
  const Real w7_y = s7 * w7_x_p1 + c7 * w6_z;
  const Real qdd_0_p8 = s3 * c4 + c3 * s4;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p9 = 0.9999999999999999 * c8;

  // link 8 (link5), mass matrix
  const Real qdd_0_p10 = a7_x_p2 * qdd_0_p4 + a7_x_p1 * qdd_0_p3;

  // link 7 (link4), outward
  const Real a7_x_p9 = a6_x + a7_x_p5 * a7_x_p6;

  // link 7 (link4), composite inertia
  const Real qdd_0_p11 = s7 * qdd_0_p3;
  const Real qdd_0_p12 = 3.79559 * s5 + 0.10439999999999999 * c5;

  // link 7 (link4), outward
  const Real a7_x_p10 = a6_y - a7_x_p4 * a7_x_p7;

  // link 7 (link4), composite inertia
  const Real qdd_0_p13 = c7 * qdd_0_p3;

  // link 6 (link3), outward
  const Real minus_a6_z = minus_a6_z_p1 * a6_y_p1 + 0.1501 * a7_x_p3;

  // link 9 (link6), mass matrix
  const Real qdd_0_p14 = 4e-05 * c8;

  // link 8 (link5), composite inertia
  const Real qdd_0_p15 = 0.00020215999999999998 * s8;

  // link 7 (link4), outward
  const Real n8_x_p2 = w7_x * w7_y;

  // link 8 (link5), outward
  const Real w8_z = w7_y + qd[7];

  // link 7 (link4), mass matrix
  const Real qdd_0_p16 = a7_x_p2 * qdd_0_p11;

  // link 7 (link4), outward
  const Real a7_x_p11 = a7_x_p8 * a7_x_p7 - minus_a6_z;
  const Real qdd_0_p17 = 0.10439999999999999 * s5 - 3.79559 * c5;

  // link 8 (link5), composite inertia
  const Real qdd_0_p18 = s8 * qdd_0_p15;

  // link 8 (link5), outward
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real w8_x = c8 * w7_x - s8 * w7_z;

  // link 7 (link4), outward
  const Real n8_x_p3 = n8_x_p2 + minus_wd7_z;
  const Real n8_x_p4 = c7 * n8_x_p1 + (w7_z + qd[6]) * w7_y;

  // link 8 (link5), outward
  const Real n8_x_p5 = 2.0 * w8_z;

  // link 7 (link4), outward
  const Real minus_wd7_y = s7 * n8_x_p1 + w7_x * qd[6];
  const Real a7_x_p12 = a7_x_p2 * a7_x_p9 - a7_x_p1 * a7_x_p10;

  // link 8 (link5), outward
  const Real minus_f8_x_p1 = w8_x * minus_w8_y;

  // link 8 (link5), composite inertia
  const Real qdd_0_p19 = 0.00164 + qdd_0_p18;

  // link 9 (link6), outward
  const Real w9_z = minus_w8_y + qd[8];

  // link 9 (link6), mass matrix
  const Real qdd_0_p20 = 4e-05 * s8;

  // link 8 (link5), outward
  const Real wd8_y_p1 = w8_x * w8_z;

  // link 7 (link4), outward
  const Real minus_a7_z = a7_x_p1 * a7_x_p9 + a7_x_p2 * a7_x_p10;

  // link 8 (link5), outward
  const Real minus_f8_x_p2 = minus_wd7_y - minus_f8_x_p1;

  // link 9 (link6), mass matrix
  const Real qdd_0_p21 = s7 * qdd_0_p20;

  // link 7 (link4), mass matrix
  const Real qdd_0_p22 = a7_x_p1 * qdd_0_p11;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p23 = 1.0 / (qdd_0_p19 - qdd_0_p9 * qdd_0_p14);

  // link 8 (link5), inertial wrench
  const Real minus_f8_x = 0.0028799999999999997 * minus_f8_x_p2;

  // link 8 (link5), composite inertia
  const Real qdd_0_p24 = c8 * qdd_0_p15;

  // link 8 (link5), mass matrix
  const Real qdd_0_p25 = a7_x_p2 * qdd_0_p3 - a7_x_p1 * qdd_0_p4;

  // link 8 (link5), inertial wrench
  const Real f8_y = 0.0028799999999999997 * (w8_x * w8_x + w8_z * w8_z);

  // link 8 (link5), outward
  const Real n8_x_p6 = s8 * n8_x_p3 + c8 * n8_x_p4 - n8_x_p5 * minus_w8_y;

  // link 7 (link4), outward
  const Real a7_x = c7 * a7_x_p12 + s7 * a7_x_p11;
  const Real a7_y = c7 * a7_x_p11 - s7 * a7_x_p12;

  // link 8 (link5), outward
  const Real wd8_y = c8 * n8_x_p3 - s8 * n8_x_p4 - wd8_y_p1;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p26 = 24999.999999999996 * qdd_0_p21;

  // link 7 (link4), composite inertia
  const Real qdd_0_p27 = s7 * qdd_0_p24;
  const Real qdd_0_p28 = a7_x_p2 * qdd_0_p13 - a7_x_p1 * qdd_0_p2;

  // link 8 (link5), inertial wrench
  const Real minus_f8_z = 0.0028799999999999997 * n8_x_p6;

  // link 7 (link4), composite inertia
  const Real qdd_0_p29 = a7_x_p1 * qdd_0_p13 + a7_x_p2 * qdd_0_p2;
  const Real qdd_0_p30 = s7 * (0.00010000000000000026 + qdd_0_p18);

  // link 8 (link5), inward
  const Real minus_f7_x = c8 * minus_f8_x + s8 * f8_y;

  // link 9 (link6), inertial wrench
  const Real n9_x = 2e-05 * (n8_x_p6 + n8_x_p5 * w9_z);
  const Real minus_n9_z = 4e-05 * wd8_y;

  // link 7 (link4), composite inertia
  const Real qdd_0_p31 = a7_x_p6 * qdd_0_p28;

  // link 8 (link5), outward
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;

  // link 8 (link5), mass matrix
  const Real qdd_0_p32 = 0.00064216 * c7 - (a7_x_p6 * qdd_0_p25 + a7_x_p7 * qdd_0_p10);

  // link 7 (link4), composite inertia
  const Real qdd_0_p33 = qdd_0_p7 - qdd_0_p29;
  const Real qdd_0_p34 = s7 * qdd_0_p30;
  const Real qdd_1_p1 = 0.298925024 * a7_x_p1 + 0.021347276999999998 * a7_x_p2;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p35 = 1557.24430048586 * qdd_0_p32;
  const Real qdd_0_p36 = a7_x_p7 * qdd_0_p16 - a7_x_p6 * qdd_0_p22 - qdd_0_p27 - qdd_0_p9 *
      qdd_0_p21;
  const Real qdd_1_p2 = 1.601861202 * s5 + 0.0141984 * c5;

  // link 9 (link6), inward
  const Real n8_x = 0.00042216 * n8_x_p6 - 0.0028799999999999997 * a7_y + n9_x;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p37 = qdd_0_p36 * qdd_0_p23;

  // link 9 (link6), inward
  const Real n8_y = minus_n9_z - 2e-04 * (wd8_y_p1 - wd8_y);

  // link 7 (link4), composite inertia
  const Real qdd_0_p38 = qdd_0_p28 - qdd_0_p6;

  // link 7 (link4), inward
  const Real n6_z_p1 = s7 * minus_f8_z - c7 * minus_f7_x;

  // link 8 (link5), inward
  const Real f7_z = s8 * minus_f8_x - c8 * f8_y;

  // link 9 (link6), inertial wrench
  const Real minus_n9_y = 2e-05 * (minus_f8_x_p2 + 2.0 * (w8_x * w9_z));

  // link 6 (link3), composite inertia
  const Real qdd_0_p39 = a6_x_p1 * qdd_0_p38;

  // link 8 (link5), mass matrix
  const Real qdd_0_p40 = qdd_0_p32 + (a6_y_p1 * qdd_0_p10 - a6_x_p1 * qdd_0_p25);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p41 = qdd_0_p36 - a6_x_p1 * qdd_0_p22 - a6_y_p1 * qdd_0_p16;

  // link 9 (link6), inward
  const Real n8_z = 0.00022215999999999997 * minus_f8_x_p1 - 0.00062216 * minus_wd7_y +
      0.0028799999999999997 * a8_x - minus_n9_y;

  // link 6 (link3), composite inertia
  const Real qdd_0_p42 = qdd_0_p33 - qdd_0_p12;
  const Real qdd_0_p43 = qdd_0_p39 + a6_y_p1 * qdd_0_p33;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p44 = 1557.24430048586 * qdd_0_p40;
  const Real qdd_0_p45 = qdd_0_p41 * qdd_0_p23;
  const Real qdd_1_p3 = a7_x_p2 * qdd_1_p1 - 0.010673638499999999;
  const Real qdd_0_p46 = 0.312455249 + (0.00129216 - qdd_0_p34 - 2.0 *
      (qdd_0_p31 + a7_x_p7 * qdd_0_p29)) - qdd_0_p26 * qdd_0_p21;

  // link 7 (link4), inward
  const Real n6_z_p2 = a7_x_p2 * n6_z_p1 - a7_x_p1 * f7_z;

  // link 8 (link5), inward
  const Real n7_x = 0.0007499999999999999 * n8_x_p4 - (s8 * n8_y - c8 * n8_x);
  const Real n7_y = n8_z - 0.00065 * (w7_x * w7_z + minus_wd7_y);

  // link 7 (link4), inward
  const Real n6_z_p3 = a7_x_p1 * n6_z_p1 + a7_x_p2 * f7_z;

  // link 9 (link6), mass matrix
  const Real qdd_0_p47 = a7_x_p1 * c7;

  // link 8 (link5), mass matrix
  const Real qdd_0_p48 = a7_x_p6 + a6_x_p1;
  const Real qdd_0_p49 = qdd_0_p1 * qdd_0_p10 + qdd_0_p8 * qdd_0_p5;

  // link 7 (link4), composite inertia
  const Real qdd_0_p50 = c7 * qdd_0_p24;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p51 = 1.0 / (qdd_0_p46 - qdd_0_p35 * qdd_0_p32 - qdd_0_p37 * qdd_0_p36);
  const Real qdd_0_p52 = qdd_0_p46 - qdd_0_p43 - qdd_0_p35 * qdd_0_p40 - qdd_0_p37 * qdd_0_p41;

  // link 9 (link6), mass matrix
  const Real qdd_0_p53 = qdd_0_p47 * qdd_0_p20 + a7_x_p2 * qdd_0_p14;

  // link 8 (link5), inward
  const Real minus_n7_z = 9.999999999999994e-05 * n8_x_p2 + 0.0014 * minus_wd7_z +
      (s8 * n8_x + c8 * n8_y);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p54 = 24999.999999999996 * qdd_0_p53;

  // link 8 (link5), mass matrix
  const Real qdd_0_p55 = 0.00064216 * a7_x_p1 * s7 + 0.1501 * qdd_0_p10 + qdd_0_p48 * qdd_0_p5;

  // link 7 (link4), mass matrix
  const Real qdd_0_p56 = qdd_0_p1 * qdd_0_p16 - qdd_0_p8 * qdd_0_p13;
  const Real qdd_1_p4 = c5 * qdd_1_p2 - 0.0070992;

  // link 7 (link4), inward
  const Real qdd_1_p5 = s7 * minus_f7_x + c7 * minus_f8_z;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p57 = 1557.24430048586 * qdd_0_p55;

  // link 6 (link3), composite inertia
  const Real qdd_0_p58 = qdd_0_p17 + qdd_0_p38;

  // link 5 (link2), composite inertia
  const Real qdd_0_p59 = 4.9338049999999996 + qdd_0_p11;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p60 = qdd_0_p52 * qdd_0_p51;

  // link 6 (link3), mass matrix
  const Real qdd_0_p61 = qdd_0_p47 * qdd_0_p30 - a7_x_p7 * qdd_0_p11 +
      (0.004704000000000001 + qdd_0_p27) * a7_x_p2 - 0.1501 * qdd_0_p33;

  // link 1 (base_x), inward
  const Real qdd_1_p6 = tau[8] + minus_n9_z;

  // link 7 (link4), inward
  const Real f6_x = a7_x_p5 * qdd_0_p6 + n6_z_p2;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p62 = a7_x_p1 * qdd_0_p50 - a7_x_p2 * qdd_0_p19 - 0.1501 * qdd_0_p16 + qdd_0_p9 *
      qdd_0_p53 + qdd_0_p48 * qdd_0_p13;
  const Real qdd_0_p63 = qdd_0_p61 + qdd_0_p26 * qdd_0_p53;
  const Real qdd_0_p64 = qdd_0_p62 * qdd_0_p23;
  const Real qdd_0_p65 = 1.7481140020000001 + qdd_0_p46 - 2.0 * qdd_0_p43 - qdd_0_p44 * qdd_0_p40 -
      qdd_0_p45 * qdd_0_p41 - qdd_0_p60 * qdd_0_p52;
  const Real qdd_0_p66 = qdd_0_p63 - qdd_0_p35 * qdd_0_p55 - qdd_0_p37 * qdd_0_p62;

  // link 7 (link4), inward
  const Real f6_z = a7_x_p8 * qdd_0_p7 - qdd_1_p5;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p67 = 1.0 / qdd_0_p65;

  // link 7 (link4), inward
  const Real n6_z = a7_x_p3 * qdd_1_p3 - (qdd_0_p6 * a6_y + qdd_0_p7 * a6_x) +
      (s7 * n7_x + c7 * n7_y + (a7_x_p6 * n6_z_p3 - a7_x_p7 * n6_z_p2));

  // link 1 (base_x), mass matrix
  const Real qdd_0_p68 = 0.690314699 * s5 + 0.023750999999999998 * c5 + qdd_0_p63 + a6_y_p1 *
      qdd_0_p11 - qdd_0_p44 * qdd_0_p55;
  const Real qdd_0_p69 = qdd_0_p66 * qdd_0_p51;
  const Real qdd_0_p70 = qdd_0_p1 * qdd_0_p33 + qdd_0_p35 * qdd_0_p49 - qdd_0_p37 * qdd_0_p56;

  // link 8 (link5), mass matrix
  const Real qdd_0_p71 = qdd_0_p1 * qdd_0_p5 - qdd_0_p8 * qdd_0_p10;

  // link 1 (base_x), inward
  const Real qdd_1_p7 = tau[3] + a7_x_p8 * qdd_1_p3 + qdd_0_p6 * minus_a6_z - a7_x_p2 * minus_n7_z +
      a7_x_p6 * qdd_1_p5;

  // link 7 (link4), mass matrix
  const Real qdd_0_p72 = qdd_0_p8 * qdd_0_p16 + qdd_0_p1 * qdd_0_p13;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p73 = 1557.24430048586 * qdd_0_p71;
  const Real qdd_0_p74 = qdd_0_p68 - qdd_0_p45 * qdd_0_p62 - qdd_0_p60 * qdd_0_p66;
  const Real qdd_0_p75 = 3.153482265 - s5 * qdd_1_p2 + qdd_0_p19 - qdd_0_p54 * qdd_0_p53 -
      qdd_0_p57 * qdd_0_p55 - qdd_0_p64 * qdd_0_p62;

  // link 7 (link4), inward
  const Real minus_f6_y = a7_x_p4 * qdd_0_p7 + n6_z_p3;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p76 = qdd_0_p72 * qdd_0_p23;
  const Real qdd_0_p77 = qdd_1_p1 - (a7_x_p2 * (2.0 * qdd_0_p50) - a7_x_p1 *
      (0.0011921599999999998 - qdd_0_p18 + qdd_0_p34 - qdd_0_p19));

  // link 1 (base_x), inward
  const Real qdd_1_p8 = n6_z + qdd_0_p26 * qdd_1_p6;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p78 = qdd_0_p74 * qdd_0_p67;
  const Real qdd_0_p79 = qdd_0_p8 * qdd_0_p33 - qdd_0_p35 * qdd_0_p71 - qdd_0_p37 * qdd_0_p72;

  // link 1 (base_x), inward
  const Real qdd_1_p9 = tau[7] - n8_z;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p80 = qdd_0_p79 * qdd_0_p51;

  // link 1 (base_x), inward
  const Real qdd_1_p10 = tau[6] + minus_n7_z - qdd_0_p9 * qdd_1_p6;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p81 = qdd_0_p1 * qdd_0_p42 + qdd_0_p44 * qdd_0_p49 - qdd_0_p45 * qdd_0_p56 -
      qdd_0_p60 * qdd_0_p70;
  const Real qdd_0_p82 = qdd_0_p8 * qdd_0_p42 - qdd_0_p44 * qdd_0_p71 - qdd_0_p45 * qdd_0_p72 -
      qdd_0_p60 * qdd_0_p79;
  const Real qdd_0_p83 = qdd_0_p8 * qdd_0_p59 + qdd_0_p1 * qdd_0_p58 + qdd_0_p57 * qdd_0_p71 +
      qdd_0_p64 * qdd_0_p72 + qdd_0_p69 * qdd_0_p79;
  const Real qdd_0_p84 = qdd_0_p82 * qdd_0_p67;
  const Real qdd_0_p85 = qdd_0_p75 - qdd_0_p69 * qdd_0_p66 - qdd_0_p78 * qdd_0_p74 + 2.0 *
      (0.1501 * qdd_0_p11 - qdd_0_p39 - qdd_0_p31);
  const Real qdd_0_p86 = 1557.24430048586 * qdd_0_p49;

  // link 6 (link3), inward
  const Real f5_z = f6_z - minus_a6_z_p1 * qdd_0_p12;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p87 = qdd_0_p8 * qdd_0_p58 - qdd_0_p1 * qdd_0_p59 + qdd_0_p57 * qdd_0_p49 -
      qdd_0_p64 * qdd_0_p56 - qdd_0_p69 * qdd_0_p70;
  const Real qdd_0_p88 = qdd_0_p83 + qdd_0_p78 * qdd_0_p82;
  const Real qdd_0_p89 = qdd_0_p56 * qdd_0_p23;

  // link 1 (base_x), inward
  const Real qdd_1_p11 = tau[4] - a7_x_p3 * qdd_1_p4 - 9.81 * qdd_0_p17 - qdd_1_p8 - a6_x_p1 *
      minus_f6_y - a6_y_p1 * f6_x;

  // link 6 (link3), inward
  const Real f5_x = f6_x - a6_x_p2 * qdd_0_p17;

  // link 5 (link2), inward
  const Real f4_y = f5_z - 4.9338049999999996 * a7_x_p3;

  // link 1 (base_x), inward
  const Real qdd_1_p12 = qdd_1_p7 - 0.1501 * f6_x - a6_x_p1 * f6_z + minus_a6_z_p1 * qdd_1_p4 +
      a6_y_p2 * (0.023750999999999998 * s5 - 0.690314699 * c5);

  // link 1 (base_x), mass matrix
  const Real qdd_0_p90 = 1.0 / (qdd_0_p85 + qdd_0_p77 * a7_x_p1);

  // link 1 (base_x), inward
  const Real qdd_1_p13 = tau[5] - qdd_1_p8 - qdd_0_p35 * qdd_1_p9 - qdd_0_p37 * qdd_1_p10;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p91 = qdd_0_p87 - qdd_0_p78 * qdd_0_p81;
  const Real qdd_0_p92 = 186.45 - qdd_0_p73 * qdd_0_p71 - qdd_0_p76 * qdd_0_p72 - qdd_0_p80 *
      qdd_0_p79 - qdd_0_p84 * qdd_0_p82;
  const Real qdd_0_p93 = qdd_0_p70 * qdd_0_p51;
  const Real qdd_0_p94 = qdd_0_p81 * qdd_0_p67;

  // link 4 (link1), inward
  const Real f3_y = qdd_0_p1 * f4_y - qdd_0_p8 * f5_x;

  // link 1 (base_x), inward
  const Real qdd_1_p14 = qdd_1_p11 - qdd_0_p44 * qdd_1_p9 - qdd_0_p45 * qdd_1_p10 - qdd_0_p60 *
      qdd_1_p13;

  // link 4 (link1), inward
  const Real minus_f3_x = qdd_0_p1 * f5_x + qdd_0_p8 * f4_y;

  // link 1 (base_x), inward
  const Real qdd_1_p15 = qdd_1_p12 + qdd_0_p54 * qdd_1_p6 - qdd_0_p57 * qdd_1_p9 - qdd_0_p64 *
      qdd_1_p10 - qdd_0_p69 * qdd_1_p13;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p95 = qdd_0_p88 * qdd_0_p90;
  const Real qdd_0_p96 = qdd_0_p91 * qdd_0_p90;
  const Real qdd_0_p97 = 186.45 - qdd_0_p86 * qdd_0_p49 - qdd_0_p89 * qdd_0_p56 - qdd_0_p93 *
      qdd_0_p70 - qdd_0_p94 * qdd_0_p81;

  // link 1 (base_x), inward
  const Real qdd_1_p16 = qdd_1_p15 - qdd_0_p78 * qdd_1_p14 +
      (c7 * n7_x - s7 * n7_y - 0.004704000000000001 * a7_x_p4) * a7_x_p1;
  const Real qdd_2 = 0.1388888888888889 * (tau[2] - tau[3]);
  qdd[2] = qdd_2;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p98 = qdd_0_p73 * qdd_0_p49 - qdd_0_p76 * qdd_0_p56 - qdd_0_p80 * qdd_0_p70 -
      qdd_0_p84 * qdd_0_p81 + qdd_0_p95 * qdd_0_p91;

  // link 1 (base_x), inward
  const Real qdd_1_p17 = tau[1] - f3_y - qdd_0_p73 * qdd_1_p9 - qdd_0_p76 * qdd_1_p10 - qdd_0_p80 *
      qdd_1_p13 - qdd_0_p84 * qdd_1_p14;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p99 = 1.0 / (qdd_0_p92 - qdd_0_p95 * qdd_0_p88);

  // link 1 (base_x), inward
  const Real qdd_1_p18 = qdd_1_p17 + qdd_0_p95 * qdd_1_p16;
  const Real qdd_0_p100 = tau[0] + minus_f3_x + qdd_0_p86 * qdd_1_p9 - qdd_0_p89 * qdd_1_p10 -
      qdd_0_p93 * qdd_1_p13 - qdd_0_p94 * qdd_1_p14;

  // link 1 (base_x), mass matrix
  const Real qdd_0_p101 = qdd_0_p98 * qdd_0_p99;

  // link 1 (base_x), inward
  const Real qdd_0 = (qdd_0_p100 - qdd_0_p96 * qdd_1_p16 - qdd_0_p101 * qdd_1_p18) *
      (1.0 / (qdd_0_p97 - qdd_0_p96 * qdd_0_p91 - qdd_0_p101 * qdd_0_p98));
  qdd[0] = qdd_0;
  const Real qdd_1 = qdd_1_p18 * qdd_0_p99 - qdd_0_p101 * qdd_0;
  qdd[1] = qdd_1;
  const Real qdd_4_p1 = qdd_1_p16 * qdd_0_p90 - qdd_0_p96 * qdd_0 + qdd_0_p95 * qdd_1;
  qdd[3] = qdd_4_p1 - qdd_2;
  const Real qdd_4 = qdd_1_p14 * qdd_0_p67 - qdd_0_p94 * qdd_0 - qdd_0_p84 * qdd_1 - qdd_4_p1 *
      qdd_0_p78;
  qdd[4] = qdd_4;
  const Real qdd_5 = qdd_1_p13 * qdd_0_p51 - qdd_0_p93 * qdd_0 - qdd_0_p80 * qdd_1 - qdd_0_p60 *
      qdd_4 - qdd_4_p1 * qdd_0_p69;
  qdd[5] = qdd_5;
  const Real qdd_6_p1 = qdd_1_p10 * qdd_0_p23 - qdd_0_p89 * qdd_0 - qdd_0_p76 * qdd_1 - qdd_0_p45 *
      qdd_4 - qdd_0_p37 * qdd_5;
  const Real qdd_7_p1 = 1557.24430048586 * qdd_1_p9 + qdd_0_p86 * qdd_0 - qdd_0_p73 * qdd_1 -
      qdd_0_p44 * qdd_4 - qdd_0_p35 * qdd_5;
  const Real qdd_6 = qdd_6_p1 - qdd_4_p1 * qdd_0_p64;
  qdd[6] = qdd_6;
  qdd[7] = qdd_7_p1 - qdd_4_p1 * qdd_0_p57;
  qdd[8] = 24999.999999999996 * qdd_1_p6 - qdd_0_p9 * qdd_6 - (qdd_4 + qdd_5) * qdd_0_p26 +
      qdd_4_p1 * qdd_0_p54;
}

}  // namespace samm

#undef TREELINE_RESTRICT
