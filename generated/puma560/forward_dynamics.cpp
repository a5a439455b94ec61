// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 460 flops (add 189, mul 267, div 4), sine and cosine of 4 angles
// Generated; see puma560.hpp for the contract.
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
  const Real a4_y_p1 = s2 * c3 + c2 * s3;
  const Real a4_y_p2 = s2 * s3 - c2 * c3;

  // link 3 (link3), outward
  const Real a4_y_p3 = w3_z * w3_z;
  const Real wd3_x = qd[0] * w3_z;

  // link 2 (link2), outward
  const Real minus_a3_z_p1 = 2.0 * wd2_x;

  // link 4 (link4), outward
  const Real w4_x_p1 = a4_y_p1 * qd[0];

  // link 3 (link3), outward
  const Real a4_y_p4 = a3_x_p1 + a4_y_p3;
  const Real a3_x = (a3_x_p1 + a3_x_p2) * a3_x_p3;

  // link 4 (link4), outward
  const Real wd5_y_p1 = a4_y_p2 * wd3_x;

  // link 3 (link3), outward
  const Real a3_y = 9.81 + a3_x_p2 * a3_y_p1;
  const Real a4_y_p5 = 2.0 * wd3_x;

  // link 4 (link4), outward
  const Real minus_wd4_z = a4_y_p1 * wd3_x;
  const Real a4_y_p6 = 0.0203 * a4_y_p2 + 0.4331 * a4_y_p1;
  const Real a4_y_p7 = 0.0203 * a4_y_p1 - 0.4331 * a4_y_p2;
  const Real w4_z = qd[3] - a4_y_p2 * qd[0];

  // link 6 (link6), mass matrix
  const Real qdd_0_p1 = 4e-05 * s5;

  // link 3 (link3), outward
  const Real minus_a3_z = minus_a3_z_p1 * a3_y_p1 + 0.1501 * a3_x_p1;
  const Real n3_z_p1 = 0.025374999999999998 * a4_y_p2 + 0.861795 * a4_y_p1;

  // link 6 (link6), mass matrix
  const Real qdd_0_p2 = s4 * qdd_0_p1;

  // link 4 (link4), outward
  const Real w4_x = s4 * w3_z - c4 * w4_x_p1;
  const Real w4_y = s4 * w4_x_p1 + c4 * w3_z;
  const Real qdd_0_p3 = 0.025374999999999998 * a4_y_p1 - 0.861795 * a4_y_p2;
  const Real qdd_0_p4 = 0.298925024 * a4_y_p1 + 0.021347276999999998 * a4_y_p2;
  const Real a4_y_p8 = a3_x + a4_y_p4 * a4_y_p6;
  const Real a4_y_p9 = a3_y - a4_y_p3 * a4_y_p7;
  const Real a4_y_p10 = a4_y_p5 * a4_y_p7 - minus_a3_z;
  const Real wd5_y_p2 = w4_x * w4_y;

  // link 5 (link5), composite inertia
  const Real qdd_0_p5 = 0.0028799999999999997 * s5;

  // link 1 (link1), mass matrix
  const Real qdd_0_p6 = 24999.999999999996 * qdd_0_p2;

  // link 5 (link5), composite inertia
  const Real qdd_0_p7 = 0.0028799999999999997 * c5;

  // link 5 (link5), outward
  const Real w5_z = w4_y + qd[4];
  const Real w5_x = c5 * w4_x - s5 * w4_z;
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;

  // link 5 (link5), mass matrix
  const Real qdd_0_p8 = c4 * qdd_0_p7;

  // link 4 (link4), outward
  const Real wd5_y_p3 = wd5_y_p2 + minus_wd4_z;
  const Real wd5_y_p4 = c4 * wd5_y_p1 + (w4_z + qd[3]) * w4_y;

  // link 5 (link5), outward
  const Real n5_x_p1 = 2.0 * w5_z;

  // link 4 (link4), outward
  const Real minus_wd4_y = s4 * wd5_y_p1 + w4_x * qd[3];
  const Real a4_y_p11 = a4_y_p2 * a4_y_p8 - a4_y_p1 * a4_y_p9;

  // link 5 (link5), outward
  const Real minus_f5_x_p1 = w5_x * minus_w5_y;
  const Real wd5_y_p5 = w5_x * w5_z;

  // link 6 (link6), outward
  const Real w6_z = minus_w5_y + qd[5];

  // link 1 (link1), mass matrix
  const Real qdd_0_p9 = 0.9999999999999999 * c5;

  // link 4 (link4), composite inertia
  const Real qdd_0_p10 = s4 * qdd_0_p5;

  // link 5 (link5), composite inertia
  const Real qdd_0_p11 = 0.00020215999999999998 * s5;

  // link 5 (link5), outward
  const Real minus_f5_x_p2 = minus_wd4_y - minus_f5_x_p1;

  // link 4 (link4), outward
  const Real minus_a4_z = a4_y_p1 * a4_y_p8 + a4_y_p2 * a4_y_p9;

  // link 4 (link4), mass matrix
  const Real qdd_0_p12 = a4_y_p2 * qdd_0_p10;
  const Real qdd_0_p13 = a4_y_p1 * qdd_0_p10;

  // link 6 (link6), mass matrix
  const Real qdd_0_p14 = 4e-05 * c5;

  // link 5 (link5), mass matrix
  const Real qdd_0_p15 = a4_y_p2 * qdd_0_p5 - a4_y_p1 * qdd_0_p8;
  const Real qdd_0_p16 = a4_y_p2 * qdd_0_p8 + a4_y_p1 * qdd_0_p5;

  // link 5 (link5), inertial wrench
  const Real minus_f5_x = 0.0028799999999999997 * minus_f5_x_p2;
  const Real f5_y = 0.0028799999999999997 * (w5_x * w5_x + w5_z * w5_z);

  // link 5 (link5), composite inertia
  const Real qdd_0_p17 = s5 * qdd_0_p11;
  const Real qdd_0_p18 = c5 * qdd_0_p11;

  // link 5 (link5), outward
  const Real wd5_y = c5 * wd5_y_p3 - s5 * wd5_y_p4 - wd5_y_p5;

  // link 4 (link4), outward
  const Real a4_y = c4 * a4_y_p10 - s4 * a4_y_p11;
  const Real a4_x = c4 * a4_y_p11 + s4 * a4_y_p10;

  // link 4 (link4), composite inertia
  const Real qdd_0_p19 = c4 * qdd_0_p5;

  // link 5 (link5), composite inertia
  const Real qdd_0_p20 = 0.00164 + qdd_0_p17;

  // link 4 (link4), composite inertia
  const Real qdd_0_p21 = s4 * qdd_0_p18;

  // link 5 (link5), outward
  const Real n5_x_p2 = s5 * wd5_y_p3 + c5 * wd5_y_p4 - n5_x_p1 * minus_w5_y;

  // link 4 (link4), composite inertia
  const Real qdd_0_p22 = s4 * (0.00010000000000000026 + qdd_0_p17);

  // link 5 (link5), mass matrix
  const Real qdd_0_p23 = 0.00064216 * c4 - (a4_y_p6 * qdd_0_p15 + a4_y_p7 * qdd_0_p16);

  // link 5 (link5), inertial wrench
  const Real minus_f5_z = 0.0028799999999999997 * n5_x_p2;

  // link 6 (link6), inertial wrench
  const Real minus_n6_z = 4e-05 * wd5_y;

  // link 4 (link4), composite inertia
  const Real qdd_0_p24 = a4_y_p2 * qdd_0_p19 - a4_y_p1 * qdd_0_p7;
  const Real qdd_0_p25 = a4_y_p1 * qdd_0_p19 + a4_y_p2 * qdd_0_p7;

  // link 1 (link1), mass matrix
  const Real qdd_0_p26 = 1.0 / (qdd_0_p20 - qdd_0_p9 * qdd_0_p14);

  // link 6 (link6), inertial wrench
  const Real n6_x = 2e-05 * (n5_x_p2 + n5_x_p1 * w6_z);

  // link 5 (link5), inward
  const Real minus_f4_x = c5 * minus_f5_x + s5 * f5_y;

  // link 4 (link4), composite inertia
  const Real qdd_0_p27 = s4 * qdd_0_p22;

  // link 1 (link1), mass matrix
  const Real qdd_0_p28 = 1557.24430048586 * qdd_0_p23;

  // link 5 (link5), mass matrix
  const Real qdd_0_p29 = qdd_0_p23 + (a3_y_p1 * qdd_0_p16 - a3_x_p3 * qdd_0_p15);

  // link 4 (link4), composite inertia
  const Real qdd_0_p30 = a4_y_p6 * qdd_0_p24;

  // link 1 (link1), mass matrix
  const Real qdd_0_p31 = a4_y_p7 * qdd_0_p12 - a4_y_p6 * qdd_0_p13 - qdd_0_p21 - qdd_0_p9 *
      qdd_0_p2;

  // link 4 (link4), composite inertia
  const Real qdd_0_p32 = qdd_0_p3 - qdd_0_p25;

  // link 5 (link5), outward
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;

  // link 1 (link1), mass matrix
  const Real qdd_0_p33 = 1557.24430048586 * qdd_0_p29;

  // link 3 (link3), composite inertia
  const Real qdd_0_p34 = a3_x_p3 * (qdd_0_p24 - n3_z_p1);

  // link 6 (link6), mass matrix
  const Real qdd_0_p35 = a4_y_p1 * c4;

  // link 1 (link1), mass matrix
  const Real qdd_0_p36 = qdd_0_p31 - a3_x_p3 * qdd_0_p13 - a3_y_p1 * qdd_0_p12;

  // link 6 (link6), inward
  const Real n5_y = minus_n6_z - 2e-04 * (wd5_y_p5 - wd5_y);
  const Real n5_x = 0.00042216 * n5_x_p2 - 0.0028799999999999997 * a4_y + n6_x;

  // link 4 (link4), composite inertia
  const Real qdd_0_p37 = c4 * qdd_0_p18;

  // link 3 (link3), composite inertia
  const Real qdd_0_p38 = qdd_0_p34 + a3_y_p1 * qdd_0_p32;

  // link 5 (link5), mass matrix
  const Real qdd_0_p39 = a4_y_p6 + a3_x_p3;

  // link 1 (link1), mass matrix
  const Real qdd_0_p40 = qdd_0_p31 * qdd_0_p26;
  const Real qdd_0_p41 = qdd_0_p36 * qdd_0_p26;

  // link 6 (link6), mass matrix
  const Real qdd_0_p42 = qdd_0_p35 * qdd_0_p1 + a4_y_p2 * qdd_0_p14;

  // link 6 (link6), inertial wrench
  const Real minus_n6_y = 2e-05 * (minus_f5_x_p2 + 2.0 * (w5_x * w6_z));

  // link 4 (link4), inward
  const Real n3_z_p2 = s4 * minus_f5_z - c4 * minus_f4_x;

  // link 5 (link5), inward
  const Real f4_z = s5 * minus_f5_x - c5 * f5_y;

  // link 1 (link1), mass matrix
  const Real qdd_0_p43 = 0.312455249 + (0.00129216 - qdd_0_p27 - 2.0 *
      (qdd_0_p30 + a4_y_p7 * qdd_0_p25)) - qdd_0_p6 * qdd_0_p2;

  // link 3 (link3), mass matrix
  const Real qdd_0_p44 = qdd_0_p35 * qdd_0_p22 - a4_y_p7 * qdd_0_p10 +
      (0.004704000000000001 + qdd_0_p21) * a4_y_p2 - 0.1501 * qdd_0_p32;

  // link 6 (link6), inward
  const Real n5_z = 0.00022215999999999997 * minus_f5_x_p1 - 0.00062216 * minus_wd4_y +
      0.0028799999999999997 * a5_x - minus_n6_y;

  // link 5 (link5), mass matrix
  const Real qdd_0_p45 = 0.00064216 * a4_y_p1 * s4 + 0.1501 * qdd_0_p16 + qdd_0_p39 *
      (s4 * qdd_0_p7);
  const Real qdd_0_p46 = a4_y_p2 * qdd_0_p4 - 0.010673638499999999;
  const Real qdd_0_p47 = 1.601861202 * s2 + 0.0141984 * c2;

  // link 1 (link1), mass matrix
  const Real qdd_0_p48 = qdd_0_p44 + qdd_0_p6 * qdd_0_p42;

  // link 5 (link5), inward
  const Real n4_x = 0.0007499999999999999 * wd5_y_p4 - (s5 * n5_y - c5 * n5_x);
  const Real n4_y = n5_z - 0.00065 * (w4_x * w4_z + minus_wd4_y);

  // link 4 (link4), inward
  const Real n3_z_p3 = a4_y_p1 * n3_z_p2 + a4_y_p2 * f4_z;
  const Real n3_z_p4 = a4_y_p2 * n3_z_p2 - a4_y_p1 * f4_z;

  // link 1 (link1), mass matrix
  const Real qdd_0_p49 = 1.0 / (qdd_0_p43 - qdd_0_p28 * qdd_0_p23 - qdd_0_p40 * qdd_0_p31);
  const Real qdd_0_p50 = qdd_0_p43 - qdd_0_p38 - qdd_0_p28 * qdd_0_p29 - qdd_0_p40 * qdd_0_p36;
  const Real qdd_0_p51 = a4_y_p1 * qdd_0_p37 - a4_y_p2 * qdd_0_p20 - 0.1501 * qdd_0_p12 + qdd_0_p9 *
      qdd_0_p42 + qdd_0_p39 * qdd_0_p19;

  // link 5 (link5), inward
  const Real minus_n4_z = 9.999999999999994e-05 * wd5_y_p2 + 0.0014 * minus_wd4_z +
      (s5 * n5_x + c5 * n5_y);

  // link 1 (link1), mass matrix
  const Real qdd_0_p52 = 24999.999999999996 * qdd_0_p42;
  const Real qdd_0_p53 = c2 * qdd_0_p47 - 0.0070992;
  const Real qdd_0_p54 = qdd_0_p48 - qdd_0_p28 * qdd_0_p45 - qdd_0_p40 * qdd_0_p51;

  // link 4 (link4), inward
  const Real qdd_0_p55 = s4 * minus_f4_x + c4 * minus_f5_z;

  // link 1 (link1), mass matrix
  const Real qdd_0_p56 = 0.690314699 * s2 + 0.023750999999999998 * c2 + qdd_0_p48 + a3_y_p1 *
      qdd_0_p10 - qdd_0_p33 * qdd_0_p45;
  const Real qdd_0_p57 = 1557.24430048586 * qdd_0_p45;

  // link 1 (link1), inward
  const Real qdd_0_p58 = tau[5] + minus_n6_z;

  // link 4 (link4), inward
  const Real f3_x = a4_y_p4 * n3_z_p1 + n3_z_p4;

  // link 1 (link1), mass matrix
  const Real qdd_0_p59 = qdd_0_p50 * qdd_0_p49;
  const Real qdd_0_p60 = qdd_0_p51 * qdd_0_p26;

  // link 4 (link4), inward
  const Real n3_z = a3_x_p1 * qdd_0_p46 - (n3_z_p1 * a3_y + qdd_0_p3 * a3_x) +
      (s4 * n4_x + c4 * n4_y + (a4_y_p6 * n3_z_p3 - a4_y_p7 * n3_z_p4));
  const Real f3_z = a4_y_p5 * qdd_0_p3 - qdd_0_p55;

  // link 1 (link1), mass matrix
  const Real qdd_0_p61 = qdd_0_p54 * qdd_0_p49;

  // link 1 (link1), inward
  const Real qdd_0_p62 = tau[0] + a4_y_p5 * qdd_0_p46 + n3_z_p1 * minus_a3_z - a4_y_p2 *
      minus_n4_z + a4_y_p6 * qdd_0_p55;

  // link 4 (link4), inward
  const Real minus_f3_y = a4_y_p3 * qdd_0_p3 + n3_z_p3;

  // link 1 (link1), inward
  const Real qdd_0_p63 = n3_z + qdd_0_p6 * qdd_0_p58;
  const Real qdd_0_p64 = tau[4] - n5_z;

  // link 1 (link1), mass matrix
  const Real qdd_0_p65 = 1.7481140020000001 + qdd_0_p43 - 2.0 * qdd_0_p38 - qdd_0_p33 * qdd_0_p29 -
      qdd_0_p41 * qdd_0_p36 - qdd_0_p59 * qdd_0_p50;
  const Real qdd_0_p66 = qdd_0_p56 - qdd_0_p41 * qdd_0_p51 - qdd_0_p59 * qdd_0_p54;

  // link 1 (link1), inward
  const Real qdd_0_p67 = tau[1] - a3_x_p1 * qdd_0_p53 - 9.81 *
      (0.10439999999999999 * s2 - 3.79559 * c2) - qdd_0_p63;

  // link 1 (link1), mass matrix
  const Real qdd_0_p68 = 3.153482265 - s2 * qdd_0_p47 + qdd_0_p20 - qdd_0_p52 * qdd_0_p42 -
      qdd_0_p57 * qdd_0_p45 - qdd_0_p60 * qdd_0_p51;
  const Real qdd_0_p69 = 1.0 / qdd_0_p65;

  // link 1 (link1), inward
  const Real qdd_0_p70 = tau[3] + minus_n4_z - qdd_0_p9 * qdd_0_p58;

  // link 1 (link1), mass matrix
  const Real qdd_0_p71 = qdd_0_p4 - (a4_y_p2 * (2.0 * qdd_0_p37) - a4_y_p1 *
      (0.0011921599999999998 - qdd_0_p17 + qdd_0_p27 - qdd_0_p20));

  // link 1 (link1), inward
  const Real qdd_0_p72 = qdd_0_p62 - 0.1501 * f3_x - a3_x_p3 * f3_z + minus_a3_z_p1 * qdd_0_p53 +
      a3_x_p2 * (0.023750999999999998 * s2 - 0.690314699 * c2);
  const Real qdd_0_p73 = tau[2] - qdd_0_p63 - qdd_0_p28 * qdd_0_p64 - qdd_0_p40 * qdd_0_p70;
  const Real qdd_0_p74 = qdd_0_p67 - a3_x_p3 * minus_f3_y - a3_y_p1 * f3_x - qdd_0_p33 * qdd_0_p64 -
      qdd_0_p41 * qdd_0_p70;

  // link 1 (link1), mass matrix
  const Real qdd_0_p75 = qdd_0_p66 * qdd_0_p69;

  // link 1 (link1), inward
  const Real qdd_0_p76 = qdd_0_p74 - qdd_0_p59 * qdd_0_p73;
  const Real qdd_0_p77 = qdd_0_p72 + qdd_0_p52 * qdd_0_p58 - qdd_0_p57 * qdd_0_p64 - qdd_0_p60 *
      qdd_0_p70 - qdd_0_p61 * qdd_0_p73;

  // link 1 (link1), mass matrix
  const Real qdd_0_p78 = qdd_0_p68 - qdd_0_p61 * qdd_0_p54 - qdd_0_p75 * qdd_0_p66 + 2.0 *
      (0.1501 * qdd_0_p10 - qdd_0_p34 - qdd_0_p30);

  // link 1 (link1), inward
  const Real qdd_0_p79 = qdd_0_p77 - qdd_0_p75 * qdd_0_p76 +
      (c4 * n4_x - s4 * n4_y - 0.004704000000000001 * a4_y_p3) * a4_y_p1;
  const Real qdd_0 = qdd_0_p79 * (1.0 / (qdd_0_p78 + qdd_0_p71 * a4_y_p1));
  qdd[0] = qdd_0;
  const Real qdd_1 = qdd_0_p76 * qdd_0_p69 - qdd_0_p75 * qdd_0;
  qdd[1] = qdd_1;
  const Real qdd_2 = qdd_0_p73 * qdd_0_p49 - qdd_0_p61 * qdd_0 - qdd_0_p59 * qdd_1;
  qdd[2] = qdd_2;
  const Real qdd_3 = qdd_0_p70 * qdd_0_p26 - qdd_0_p60 * qdd_0 - qdd_0_p41 * qdd_1 - qdd_0_p40 *
      qdd_2;
  qdd[3] = qdd_3;
  qdd[4] = 1557.24430048586 * qdd_0_p64 - qdd_0_p57 * qdd_0 - qdd_0_p33 * qdd_1 - qdd_0_p28 * qdd_2;
  qdd[5] = 24999.999999999996 * qdd_0_p58 + qdd_0_p52 * qdd_0 - qdd_0_p9 * qdd_3 - (qdd_1 + qdd_2) *
      qdd_0_p6;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
