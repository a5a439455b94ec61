// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 410 flops (add 175, mul 231, div 4), sine and cosine of 4 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void forward_dynamics(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT tau)[6], Real (&TREELINE_RESTRICT qdd)[6]) noexcept {
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real c2 = cosines[0];
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p1 = 0.0054190910375000005 * s5;
  const Real qdd_0_p2 = 0.09132825 * s5;
  const Real qdd_0_p3 = 0.09132825 * c5;
  const Real qdd_0_p4 = 0.0106962107625 * c5;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p5 = 1.2551157591996094 * c5;
  const Real qdd_0_p6 = 0.6127 * s2;
  const Real qdd_0_p7 = 0.6127 * c2;

  // link 3 (forearm), outward
  const Real w3_z = qd[1] + qd[2];
  const Real qdd_0_p8 = c2 * c3 - s2 * s3;
  const Real qdd_0_p9 = s2 * c3 + c2 * s3;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p10 = s5 * qdd_0_p1;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p11 = c5 * (0.000623 * c5);

  // link 4 (wrist_1), outward
  const Real w4_z = w3_z + qd[3];
  const Real a4_y_p1 = 0.57155 * qdd_0_p9;
  const Real qdd_0_p12 = 0.57155 * qdd_0_p8;

  // link 3 (forearm), outward
  const Real a4_y_p2 = w3_z * w3_z;
  const Real qdd_0_p13 = 4.0059802 * qdd_0_p9;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p14 = 0.041592816387499995 + qdd_0_p10;

  // link 2 (upper_arm), outward
  const Real a3_y_p1 = qd[1] * qd[1];
  const Real qdd_0_p15 = 4.0059802 * qdd_0_p8;

  // link 4 (wrist_1), outward
  const Real wd4_x = qd[0] * w4_z;

  // link 1 (shoulder), outward
  const Real a4_x_p1 = qd[0] * qd[0];
  const Real qdd_0_p16 = qdd_0_p8 * c4 - qdd_0_p9 * s4;
  const Real qdd_0_p17 = qdd_0_p9 * c4 + qdd_0_p8 * s4;
  const Real qdd_0_p18 = 0.33495075 * qdd_0_p16;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p19 = qdd_0_p17 * qdd_0_p2;
  const Real qdd_0_p20 = 0.33495075 * qdd_0_p17;

  // link 5 (wrist_2), mass matrix
  const Real qdd_0_p21 = qdd_0_p17 * qdd_0_p3;
  const Real qdd_0_p22 = qdd_0_p16 * qdd_0_p3;

  // link 5 (wrist_2), outward
  const Real w5_y_p1 = qdd_0_p17 * qd[0];

  // link 3 (forearm), outward
  const Real a4_x_p2 = a4_x_p1 + a4_y_p2;

  // link 5 (wrist_2), outward
  const Real n5_x_p1 = qdd_0_p16 * wd4_x;

  // link 3 (forearm), outward
  const Real a3_y = 9.81 + a3_y_p1 * qdd_0_p6;

  // link 6 (wrist_3), mass matrix
  const Real qdd_0_p23 = qdd_0_p17 * s5;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p24 = qdd_0_p18 + qdd_0_p19;
  const Real qdd_0_p25 = qdd_0_p20 - qdd_0_p16 * qdd_0_p2;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p26 = 1.0 / (qdd_0_p14 - qdd_0_p11 - qdd_0_p5 * qdd_0_p4);

  // link 5 (wrist_2), outward
  const Real wd5_z = qdd_0_p17 * wd4_x;
  const Real w5_z = qd[4] - qdd_0_p16 * qd[0];

  // link 4 (wrist_1), composite inertia
  const Real qdd_0_p27 = qdd_0_p12 * qdd_0_p25;

  // link 3 (forearm), outward
  const Real a3_x = (a4_x_p1 + a3_y_p1) * qdd_0_p7;

  // link 5 (wrist_2), outward
  const Real w5_y = c5 * w4_z - s5 * w5_y_p1;
  const Real w5_x = c5 * w5_y_p1 + s5 * w4_z;
  const Real minus_f5_y_p1 = w5_z * w5_z;

  // link 4 (wrist_1), outward
  const Real a4_y = a3_y + a4_y_p2 * a4_y_p1;

  // link 4 (wrist_1), composite inertia
  const Real qdd_0_p28 = a4_y_p1 * qdd_0_p24 - qdd_0_p27;

  // link 3 (forearm), composite inertia
  const Real qdd_0_p29 = qdd_0_p7 * (qdd_0_p25 - qdd_0_p15);

  // link 5 (wrist_2), mass matrix
  const Real qdd_0_p30 = qdd_0_p12 * qdd_0_p21 - a4_y_p1 * qdd_0_p22 - qdd_0_p4;

  // link 5 (wrist_2), outward
  const Real f5_x_p1 = w5_x * w5_y;

  // link 6 (wrist_3), outward
  const Real w6_z = w5_y + qd[5];

  // link 4 (wrist_1), outward
  const Real a4_x = a3_x + a4_x_p2 * qdd_0_p12;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p31 = 117.34209310833121 * qdd_0_p30;

  // link 5 (wrist_2), mass matrix
  const Real qdd_0_p32 = qdd_0_p30 + (qdd_0_p7 * qdd_0_p21 - qdd_0_p6 * qdd_0_p22);

  // link 3 (forearm), composite inertia
  const Real qdd_0_p33 = qdd_0_p6 * (qdd_0_p13 + qdd_0_p24) - qdd_0_p29;

  // link 5 (wrist_2), outward
  const Real f5_x_p2 = f5_x_p1 - wd5_z;

  // link 6 (wrist_3), outward
  const Real n6_x_p1 = 2.0 * w6_z;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p34 = qdd_0_p14 + qdd_0_p28 - qdd_0_p11;

  // link 5 (wrist_2), outward
  const Real n5_y_p1 = w5_x * w5_z;
  const Real n5_x_p2 = c5 * n5_x_p1 + (w5_z + qd[4]) * w5_y;

  // link 5 (wrist_2), inertial wrench
  const Real minus_f5_y = 0.09132825 * (w5_x * w5_x + minus_f5_y_p1);
  const Real f5_x = 0.09132825 * f5_x_p2;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p35 = qdd_0_p34 + qdd_0_p5 * qdd_0_p30;

  // link 5 (wrist_2), outward
  const Real minus_wd5_y = s5 * n5_x_p1 + w5_x * qd[4];

  // link 2 (upper_arm), outward
  const Real minus_a4_z_p1 = 2.0 * qd[0];

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p36 = 117.34209310833121 * qdd_0_p32;
  const Real qdd_0_p37 = qdd_0_p35 * qdd_0_p26;
  const Real qdd_0_p38 = 2.08330527531 + (qdd_0_p14 + 2.0 * qdd_0_p28) - qdd_0_p11;

  // link 5 (wrist_2), outward
  const Real minus_a5_z = qdd_0_p16 * a4_y - qdd_0_p17 * a4_x;

  // link 3 (forearm), outward
  const Real minus_a4_z_p2 = minus_a4_z_p1 * w3_z;

  // link 2 (upper_arm), outward
  const Real minus_a3_z_p1 = minus_a4_z_p1 * qd[1];

  // link 6 (wrist_3), mass matrix
  const Real qdd_0_p39 = 0.000623 * qdd_0_p23;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p40 = qdd_0_p34 + qdd_0_p6 * qdd_0_p24 - qdd_0_p7 * qdd_0_p25 + qdd_0_p5 *
      qdd_0_p32;

  // link 5 (wrist_2), inertial wrench
  const Real f5_z = 0.09132825 * n5_x_p2;

  // link 4 (wrist_1), outward
  const Real f4_x_p1 = w4_z * w4_z;
  const Real qdd_0_p41 = 4.36318718615 * s2;

  // link 3 (forearm), outward
  const Real minus_a3_z = minus_a3_z_p1 * qdd_0_p6;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p42 = qdd_0_p40 * qdd_0_p26;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p43 = qdd_0_p17 * c5 * qdd_0_p1 + 0.17415 * qdd_0_p19 +
      (0.0585962731125 + qdd_0_p4) * qdd_0_p16;

  // link 5 (wrist_2), inward
  const Real f4_x_p2 = c5 * f5_x + s5 * minus_f5_y;
  const Real qdd_0_p44 = c2 * qdd_0_p41;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p45 = qdd_0_p38 + qdd_0_p33 - qdd_0_p31 * qdd_0_p32 - qdd_0_p37 * qdd_0_p40;

  // link 4 (wrist_1), outward
  const Real minus_a4_z = minus_a3_z + minus_a4_z_p2 * a4_y_p1;
  const Real n4_z_p1 = 0.037099816387500005 * qdd_0_p17;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p46 = 1.0 / (qdd_0_p38 - qdd_0_p31 * qdd_0_p30 - qdd_0_p37 * qdd_0_p35);
  const Real qdd_0_p47 = c5 * qdd_0_p39;

  // link 5 (wrist_2), mass matrix
  const Real qdd_0_p48 = 0.0106962107625 * qdd_0_p23 - 0.0085220910375 * qdd_0_p16 - 0.17415 *
      qdd_0_p22 - (qdd_0_p12 + qdd_0_p7) * qdd_0_p2;

  // link 6 (wrist_3), inertial wrench
  const Real n6_x = 0.0003115 * (n6_x_p1 * w5_z - n5_x_p2);
  const Real minus_n6_z = 0.000623 * minus_wd5_y;
  const Real qdd_0_p49 = 2.07831527531 * qdd_0_p9;
  const Real n4_z_p2 = qdd_0_p16 * n4_z_p1;

  // link 6 (wrist_3), inward
  const Real n5_x = 0.0069705910375000004 * n5_x_p2 + 0.0106962107625 *
      (minus_f5_y_p1 - w5_y * w5_y) - 0.09132825 * minus_a5_z - n6_x;
  const Real n5_y = 0.0106962107625 * f5_x_p2 - 0.00124 * (n5_y_p1 + minus_wd5_y) - minus_n6_z;

  // link 5 (wrist_2), inward
  const Real f4_x_p3 = qdd_0_p16 * f4_x_p2 + qdd_0_p17 * f5_z;
  const Real qdd_0_p50 = qdd_0_p8 * qdd_0_p49;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p51 = 0.5656542411875001 * qdd_0_p9 + (qdd_0_p43 + a4_y_p1 * qdd_0_p3) +
      qdd_0_p47;
  const Real qdd_0_p52 = qdd_0_p43 + qdd_0_p47 + qdd_0_p5 * qdd_0_p48;

  // link 5 (wrist_2), inward
  const Real f4_x = f4_x_p3 - (a4_x_p1 + f4_x_p1) * qdd_0_p20;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p53 = qdd_0_p45 * qdd_0_p46;

  // link 5 (wrist_2), inward
  const Real f4_y = f4_x_p1 * qdd_0_p18 + (qdd_0_p17 * f4_x_p2 - qdd_0_p16 * f5_z);

  // link 5 (wrist_2), outward
  const Real a5_x = c5 * (qdd_0_p16 * a4_x + qdd_0_p17 * a4_y) - s5 *
      (minus_a4_z + 0.17415 * a4_x_p1);

  // link 1 (shoulder), inward
  const Real qdd_0_p54 = tau[0] - 1.156008191975 * a3_y_p1 * c2 + minus_a3_z_p1 * qdd_0_p44 -
      0.5656542411875001 * a4_y_p2 * qdd_0_p8;

  // link 4 (wrist_1), outward
  const Real qdd_0_p55 = 2.0 * wd4_x;

  // link 6 (wrist_3), inertial wrench
  const Real n6_y = 0.0003115 * (n6_x_p1 * w5_x - f5_x_p2);

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p56 = 4.3866871861500005 + qdd_0_p38 + 2.0 * qdd_0_p33 - qdd_0_p36 * qdd_0_p32 -
      qdd_0_p42 * qdd_0_p40 - qdd_0_p53 * qdd_0_p45;
  const Real qdd_0_p57 = qdd_0_p51 - qdd_0_p31 * qdd_0_p48 - qdd_0_p37 * qdd_0_p52;

  // link 5 (wrist_2), inward
  const Real n4_z = qdd_0_p20 * a4_y + qdd_0_p18 * a4_x - a4_x_p1 * n4_z_p2 +
      (s5 * n5_x + c5 * n5_y);

  // link 5 (wrist_2), inertial wrench
  const Real n5_z_p1 = 0.008210591037500001 * wd5_z - 0.005730591037500001 * f5_x_p1 -
      0.0106962107625 * (n5_y_p1 - minus_wd5_y) - 0.09132825 * a5_x;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p58 = 1.0 / qdd_0_p56;
  const Real qdd_0_p59 = 117.34209310833121 * qdd_0_p48;

  // link 1 (shoulder), inward
  const Real qdd_0_p60 = tau[5] + minus_n6_z;

  // link 6 (wrist_3), inward
  const Real n5_z = n5_z_p1 + n6_y;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p61 = 1.156008191975 * s2 + qdd_0_p51 + qdd_0_p6 * qdd_0_p3 - qdd_0_p36 *
      qdd_0_p48 - qdd_0_p42 * qdd_0_p52;
  const Real qdd_0_p62 = qdd_0_p52 * qdd_0_p26;

  // link 1 (shoulder), inward
  const Real qdd_0_p63 = c5 * qdd_0_p60;

  // link 4 (wrist_1), inward
  const Real n3_z = a4_x_p1 * qdd_0_p50 + (qdd_0_p13 * a3_x - qdd_0_p15 * a3_y) +
      (n4_z + (a4_y_p1 * f4_x - qdd_0_p12 * f4_y));

  // link 1 (shoulder), inward
  const Real qdd_0_p64 = tau[4] - n5_z;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p65 = 0.0098370910375 + (6.991093406097501 - s2 * qdd_0_p41 - qdd_0_p9 *
      qdd_0_p49) + 0.031809629475 * c5 - qdd_0_p23 * qdd_0_p39;
  const Real qdd_0_p66 = qdd_0_p61 - qdd_0_p53 * qdd_0_p57;

  // link 1 (shoulder), inward
  const Real qdd_0_p67 = qdd_0_p54 + minus_a4_z_p2 * qdd_0_p50 + qdd_0_p15 * minus_a3_z -
      qdd_0_p55 * n4_z_p2 - qdd_0_p20 * minus_a4_z;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p68 = qdd_0_p57 * qdd_0_p46;

  // link 4 (wrist_1), inward
  const Real f3_x = a4_x_p2 * qdd_0_p15 + f4_x;

  // link 1 (shoulder), inward
  const Real qdd_0_p69 = qdd_0_p63 + n3_z;

  // link 5 (wrist_2), inward
  const Real f4_z = s5 * f5_x - c5 * minus_f5_y - qdd_0_p55 * qdd_0_p18;

  // link 4 (wrist_1), inward
  const Real f3_y = a4_y_p2 * qdd_0_p13 + f4_y;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p70 = qdd_0_p66 * qdd_0_p58;

  // link 4 (wrist_1), inward
  const Real f3_z = f4_z - minus_a4_z_p2 * qdd_0_p13;

  // link 1 (shoulder), inward
  const Real qdd_0_p71 = tau[3] - n4_z - qdd_0_p63 + qdd_0_p5 * qdd_0_p64;
  const Real qdd_0_p72 = tau[1] - a4_x_p1 * qdd_0_p44 + 81.98859064500002 * c2 - qdd_0_p69 -
      qdd_0_p6 * f3_x + qdd_0_p7 * f3_y;
  const Real qdd_0_p73 = qdd_0_p67 + qdd_0_p16 * n5_z - 0.17415 * f4_x_p3 - qdd_0_p12 * f4_z -
      qdd_0_p7 * f3_z;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p74 = qdd_0_p65 - qdd_0_p59 * qdd_0_p48 - qdd_0_p62 * qdd_0_p52 - qdd_0_p68 *
      qdd_0_p57 - qdd_0_p70 * qdd_0_p66;

  // link 1 (shoulder), inward
  const Real qdd_0_p75 = tau[2] - qdd_0_p69 - qdd_0_p31 * qdd_0_p64 - qdd_0_p37 * qdd_0_p71;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p76 = qdd_0_p74 - 2.0 * (qdd_0_p27 + qdd_0_p29) +
      (n4_z_p1 - (qdd_0_p17 * (0.0012399999999999998 + qdd_0_p10) + qdd_0_p16 *
      (0.021392421525 * s5))) * qdd_0_p17;

  // link 1 (shoulder), inward
  const Real qdd_0_p77 = qdd_0_p72 - qdd_0_p36 * qdd_0_p64 - qdd_0_p42 * qdd_0_p71 - qdd_0_p53 *
      qdd_0_p75;
  const Real qdd_0_p78 = qdd_0_p73 + qdd_0_p23 * qdd_0_p60 - qdd_0_p59 * qdd_0_p64 - qdd_0_p62 *
      qdd_0_p71 - qdd_0_p68 * qdd_0_p75;
  const Real qdd_0_p79 = qdd_0_p78 - qdd_0_p70 * qdd_0_p77 +
      (0.0585962731125 * f4_x_p1 - (c5 * n5_x - s5 * n5_y)) * qdd_0_p17;
  const Real qdd_0 = qdd_0_p79 * (1.0 / qdd_0_p76);
  qdd[0] = qdd_0;
  const Real qdd_1 = qdd_0_p77 * qdd_0_p58 - qdd_0_p70 * qdd_0;
  qdd[1] = qdd_1;
  const Real qdd_2 = qdd_0_p75 * qdd_0_p46 - qdd_0_p68 * qdd_0 - qdd_0_p53 * qdd_1;
  qdd[2] = qdd_2;
  const Real qdd_3 = qdd_0_p71 * qdd_0_p26 - qdd_0_p62 * qdd_0 - qdd_0_p42 * qdd_1 - qdd_0_p37 *
      qdd_2;
  qdd[3] = qdd_3;
  qdd[4] = 117.34209310833121 * qdd_0_p64 - qdd_0_p59 * qdd_0 - qdd_0_p36 * qdd_1 - qdd_0_p31 *
      qdd_2 + qdd_0_p5 * qdd_3;
  qdd[5] = 1605.1364365971108 * qdd_0_p60 + qdd_0_p23 * qdd_0 - (qdd_1 + qdd_2 + qdd_3) * c5;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
