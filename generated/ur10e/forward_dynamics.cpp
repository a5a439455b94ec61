// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 560 flops (add 245, mul 311, div 4), sine and cosine of 5 angles
// Generated; see ur10e.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
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
  const Real c5 = cosines[3];
  const Real s5 = sines[3];
  const Real c6 = cosines[4];
  const Real s6 = sines[4];

  // link 2 (upper_arm), outward
  const Real w2_x = s2 * qd[0];
  const Real w2_y = c2 * qd[0];

  // link 3 (forearm), outward
  const Real w3_z = qd[1] + qd[2];

  // link 2 (upper_arm), outward
  const Real a3_y_p1 = qd[1] * qd[1];
  const Real a2_y = 9.81 * c2;
  const Real a2_x = 9.81 * s2;

  // link 4 (wrist_1), outward
  const Real w4_z = w3_z + qd[3];

  // link 3 (forearm), outward
  const Real a4_y_p1 = w3_z * w3_z;

  // link 2 (upper_arm), outward
  const Real wd2_x = w2_y * qd[1];
  const Real minus_wd2_y = w2_x * qd[1];
  const Real a3_y_p2 = w2_x * w2_y;

  // link 4 (wrist_1), outward
  const Real n4_x_p1 = w4_z * w4_z;

  // link 3 (forearm), outward
  const Real w3_x = c3 * w2_x + s3 * w2_y;
  const Real w3_y = c3 * w2_y - s3 * w2_x;
  const Real minus_a3_z = 1.2254 * minus_wd2_y;
  const Real a4_y_p2 = w3_x * w3_y;
  const Real a3_y_p3 = a2_y - 0.6127 * a3_y_p2;

  // link 4 (wrist_1), outward
  const Real w4_x = c4 * w3_x + s4 * w3_y;

  // link 3 (forearm), outward
  const Real wd3_x = c3 * wd2_x - s3 * minus_wd2_y + w3_y * qd[2];
  const Real minus_wd3_y = s3 * wd2_x + c3 * minus_wd2_y + w3_x * qd[2];

  // link 4 (wrist_1), outward
  const Real w4_y = c4 * w3_y - s4 * w3_x;
  const Real a4_y_p3 = w3_y * w3_y + a4_y_p1;

  // link 3 (forearm), outward
  const Real a3_y_p4 = a2_x + 0.6127 * (w2_y * w2_y + a3_y_p1);

  // link 4 (wrist_1), outward
  const Real a5_x_p1 = w4_x * w4_z;

  // link 5 (wrist_2), outward
  const Real w5_z = qd[4] - w4_y;

  // link 4 (wrist_1), outward
  const Real minus_a5_z_p1 = w4_y * w4_z;
  const Real a5_x_p2 = w4_y * w4_y;
  const Real a5_x_p3 = w4_x * w4_x;

  // link 5 (wrist_2), outward
  const Real w5_y = c5 * w4_z - s5 * w4_x;
  const Real w5_x = c5 * w4_x + s5 * w4_z;

  // link 3 (forearm), outward
  const Real minus_a4_z_p1 = w3_x * w3_z + minus_wd3_y;

  // link 4 (wrist_1), outward
  const Real n4_y_p1 = w4_x * w4_y;

  // link 5 (wrist_2), outward
  const Real n5_x_p1 = w5_z * w5_z;

  // link 3 (forearm), outward
  const Real a3_y = c3 * a3_y_p3 - s3 * a3_y_p4;
  const Real a3_x = c3 * a3_y_p4 + s3 * a3_y_p3;
  const Real n3_x_p1 = w3_y * w3_z;

  // link 6 (wrist_3), outward
  const Real w6_z = w5_y + qd[5];

  // link 4 (wrist_1), outward
  const Real wd4_x = c4 * wd3_x - s4 * minus_wd3_y + w4_y * qd[3];
  const Real minus_wd4_y = s4 * wd3_x + c4 * minus_wd3_y + w4_x * qd[3];
  const Real a4_y_p4 = a3_y - 0.57155 * a4_y_p2;
  const Real a4_y_p5 = a3_x + 0.57155 * a4_y_p3;

  // link 6 (wrist_3), outward
  const Real n6_x_p1 = qd[5] + w6_z;

  // link 5 (wrist_2), outward
  const Real n5_y_p1 = w5_x * w5_y;
  const Real n5_y_p2 = w5_x * w5_z;

  // link 6 (wrist_3), outward
  const Real minus_w6_y = s6 * w5_x + c6 * w5_z;
  const Real w6_x = c6 * w5_x - s6 * w5_z;

  // link 4 (wrist_1), outward
  const Real a5_x_p4 = a5_x_p1 - minus_wd4_y;

  // link 5 (wrist_2), outward
  const Real wd5_x = c5 * wd4_x + w5_y * qd[4];

  // link 4 (wrist_1), outward
  const Real minus_a4_z = minus_a3_z + 0.57155 * minus_a4_z_p1;
  const Real a4_y = c4 * a4_y_p4 - s4 * a4_y_p5;

  // link 5 (wrist_2), outward
  const Real n5_y_p3 = n5_y_p1 - minus_wd4_y;
  const Real minus_wd5_y = s5 * wd4_x + w5_x * qd[4];

  // link 4 (wrist_1), outward
  const Real a4_x = c4 * a4_y_p5 + s4 * a4_y_p4;

  // link 6 (wrist_3), mass matrix
  const Real qdd_0_p1 = 0.000623 * s5;

  // link 5 (wrist_2), outward
  const Real n5_x_p2 = w5_y * w5_z + wd5_x;
  const Real minus_a5_z = a4_y + 0.17415 * (minus_a5_z_p1 - wd4_x);

  // link 5 (wrist_2), inertial wrench
  const Real f5_x = 0.09132825 * n5_y_p3;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p2 = 0.0106962107625 * s5;

  // link 6 (wrist_3), inertial wrench
  const Real minus_n6_z = 0.000623 * minus_wd5_y;

  // link 5 (wrist_2), inertial wrench
  const Real minus_f5_y = 0.09132825 * (w5_x * w5_x + n5_x_p1);

  // link 4 (wrist_1), outward
  const Real n4_x_p2 = minus_a5_z_p1 + wd4_x;

  // link 5 (wrist_2), mass matrix
  const Real qdd_0_p3 = 0.0085220910375 + 0.0159048147375 * c5;

  // link 6 (wrist_3), mass matrix
  const Real qdd_0_p4 = s4 * qdd_0_p1;

  // link 5 (wrist_2), outward
  const Real a5_x = c5 * (a4_x + 0.17415 * a5_x_p4) - s5 *
      (minus_a4_z + 0.17415 * (a5_x_p3 + a5_x_p2));

  // link 6 (wrist_3), inertial wrench
  const Real n6_x = 0.0003115 * (c6 * wd5_x - s6 * minus_wd4_y - n6_x_p1 * minus_w6_y);
  const Real minus_n6_y = 0.0003115 * (s6 * wd5_x + c6 * minus_wd4_y + n6_x_p1 * w6_x);

  // link 6 (wrist_3), mass matrix
  const Real qdd_0_p5 = c4 * qdd_0_p1;

  // link 6 (wrist_3), inward
  const Real n5_y = 0.0106962107625 * n5_y_p3 - 0.00124 * (n5_y_p2 + minus_wd5_y) - minus_n6_z;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p6 = 1.2551157591996094 * c5;

  // link 5 (wrist_2), inward
  const Real n4_y_p2 = c5 * f5_x + s5 * minus_f5_y;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p7 = 0.0054190910375000005 * s5;
  const Real qdd_0_p8 = 0.0106962107625 * c5;

  // link 5 (wrist_2), mass matrix
  const Real qdd_0_p9 = c4 * qdd_0_p2 + s4 * qdd_0_p3;

  // link 5 (wrist_2), inertial wrench
  const Real n5_z_p1 = 0.008210591037500001 * minus_wd4_y - 0.005730591037500001 * n5_y_p1 -
      0.0106962107625 * (n5_y_p2 - minus_wd5_y) - 0.09132825 * a5_x;

  // link 5 (wrist_2), mass matrix
  const Real qdd_0_p10 = s4 * qdd_0_p2 - c4 * qdd_0_p3 - 0.0521986612875 * s5;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p11 = 0.0585962731125 + qdd_0_p8;
  const Real qdd_0_p12 = s5 * qdd_0_p7;
  const Real qdd_0_p13 = c5 * qdd_0_p7 + 0.0159048147375 * s5;

  // link 6 (wrist_3), inward
  const Real n5_x = 0.0069705910375000004 * n5_x_p2 + 0.0106962107625 * (n5_x_p1 - w5_y * w5_y) -
      0.09132825 * minus_a5_z + (c6 * n6_x + s6 * minus_n6_y);
  const Real n5_z = n5_z_p1 + (c6 * minus_n6_y - s6 * n6_x);

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p14 = c5 * (0.000623 * c5);

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p15 = 0.041592816387499995 + qdd_0_p12;
  const Real qdd_0_p16 = 0.09132825 * c5;

  // link 4 (wrist_1), composite inertia
  const Real qdd_0_p17 = c4 * qdd_0_p13 - s4 * qdd_0_p11;
  const Real qdd_0_p18 = s4 * qdd_0_p13 + c4 * qdd_0_p11;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p19 = 0.09132825 * s5;

  // link 5 (wrist_2), inward
  const Real n4_y = 0.17415 * n4_y_p2 - n5_z - (0.001315 * (a5_x_p1 + minus_wd4_y) +
      0.0585962731125 * n4_y_p1);

  // link 3 (forearm), composite inertia
  const Real qdd_0_p20 = s3 * qdd_0_p18;

  // link 5 (wrist_2), mass matrix
  const Real qdd_0_p21 = s4 * qdd_0_p16;

  // link 3 (forearm), composite inertia
  const Real qdd_0_p22 = c3 * qdd_0_p18;

  // link 5 (wrist_2), inward
  const Real f4_z = s5 * f5_x - c5 * minus_f5_y - 0.33495075 * n4_x_p2;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p23 = 1.0 / (qdd_0_p15 - qdd_0_p14 - qdd_0_p6 * qdd_0_p8);

  // link 6 (wrist_3), mass matrix
  const Real qdd_0_p24 = s2 * (s3 * qdd_0_p4 - c3 * qdd_0_p5) - c2 *
      (s3 * qdd_0_p5 + c3 * qdd_0_p4);

  // link 5 (wrist_2), inward
  const Real n4_x = 0.0384148163875 * n4_x_p2 - 0.0585962731125 * (n4_x_p1 - a5_x_p2) + 0.33495075 *
      minus_a4_z + (c5 * n5_x - s5 * n5_y + 0.0159048147375 * n5_x_p2);

  // link 5 (wrist_2), inertial wrench
  const Real f5_z = 0.09132825 * n5_x_p2;

  // link 4 (wrist_1), composite inertia
  const Real qdd_0_p25 = 0.33495075 * s4 - c4 * qdd_0_p19;
  const Real qdd_0_p26 = 0.5656542411875001 + (qdd_0_p17 + 0.0521986612875 * c5);

  // link 5 (wrist_2), mass matrix
  const Real qdd_0_p27 = s2 * (c3 * qdd_0_p9 - s3 * qdd_0_p10) + c2 *
      (s3 * qdd_0_p9 + c3 * qdd_0_p10 - 0.055956818775 * s5);
  const Real qdd_0_p28 = 0.57155 * qdd_0_p21 - qdd_0_p8;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p29 = c5 * qdd_0_p24;

  // link 5 (wrist_2), inward
  const Real f4_x = n4_y_p2 - 0.33495075 * n4_y_p1;

  // link 4 (wrist_1), composite inertia
  const Real qdd_0_p30 = 1.1431 * qdd_0_p25;

  // link 5 (wrist_2), inward
  const Real f4_y = 0.33495075 * (a5_x_p3 + n4_x_p1) - f5_z;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p31 = 117.34209310833121 * qdd_0_p28;

  // link 3 (forearm), composite inertia
  const Real qdd_0_p32 = c3 * qdd_0_p26 - qdd_0_p20;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p33 = s2 * (c3 * qdd_0_p17 - qdd_0_p20) + c2 * (s3 * qdd_0_p17 + qdd_0_p22) -
      qdd_0_p29;
  const Real qdd_0_p34 = qdd_0_p15 - 0.57155 * qdd_0_p25 - qdd_0_p14;

  // link 4 (wrist_1), composite inertia
  const Real qdd_0_p35 = qdd_0_p25 - 4.0059802;

  // link 4 (wrist_1), mass matrix
  const Real qdd_0_p36 = 0.33495075 * c4 + s4 * qdd_0_p19;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p37 = qdd_0_p34 + qdd_0_p6 * qdd_0_p28;
  const Real qdd_0_p38 = 2.08330527531 + (qdd_0_p15 - qdd_0_p30) - qdd_0_p14;

  // link 4 (wrist_1), inward
  const Real n3_x = 0.002495 * (n3_x_p1 + wd3_x) + 0.5656542411875001 * a4_y_p2 +
      (c4 * n4_x - s4 * n4_y);

  // link 4 (wrist_1), mass matrix
  const Real qdd_0_p39 = s3 * qdd_0_p36;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p40 = qdd_0_p29 - c2 * (s3 * qdd_0_p26 + qdd_0_p22);

  // link 4 (wrist_1), inward
  const Real n3_y = s4 * n4_x + c4 * n4_y + 0.57155 * f4_z -
      (2.08081027531 * minus_a4_z_p1 + 0.5656542411875001 * (w3_x * w3_x - a4_y_p1) +
      4.90892813708 * minus_wd2_y);

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p41 = qdd_0_p37 * qdd_0_p23;
  const Real qdd_0_p42 = qdd_0_p33 + qdd_0_p6 * qdd_0_p27;

  // link 4 (wrist_1), inward
  const Real n3_z_p1 = s4 * f4_x + c4 * f4_y;

  // link 3 (forearm), mass matrix
  const Real qdd_0_p43 = qdd_0_p39 + c3 * qdd_0_p35;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p44 = 0.031809629475 * c5;

  // link 5 (wrist_2), mass matrix
  const Real qdd_0_p45 = qdd_0_p28 + 0.6127 * (s3 * (c4 * qdd_0_p16) + c3 * qdd_0_p21);

  // link 4 (wrist_1), inward
  const Real f3_z = f4_z - 4.0059802 * minus_a4_z_p1;

  // link 3 (forearm), composite inertia
  const Real qdd_0_p46 = 1.2254 * qdd_0_p43;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p47 = 0.0098370910375 + qdd_0_p44;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p48 = 117.34209310833121 * qdd_0_p45;

  // link 5 (wrist_2), composite inertia
  const Real qdd_0_p49 = 0.0384148163875 + (0.007282091037500001 - qdd_0_p12 + qdd_0_p44);

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p50 = 1.0 / (qdd_0_p38 - qdd_0_p31 * qdd_0_p28 - qdd_0_p41 * qdd_0_p37);
  const Real qdd_0_p51 = 1605.1364365971108 * qdd_0_p24;
  const Real qdd_0_p52 = qdd_0_p34 - 0.6127 * (qdd_0_p39 + c3 * qdd_0_p25) + qdd_0_p6 * qdd_0_p45;
  const Real qdd_0_p53 = qdd_0_p52 * qdd_0_p23;

  // link 5 (wrist_2), inward
  const Real n4_z = 0.0585962731125 * a5_x_p4 - 0.037099816387500005 * n4_y_p1 + 0.33495075 * a4_x +
      (s5 * n5_x + c5 * n5_y);

  // link 1 (shoulder), inward
  const Real qdd_1_p1 = tau[5] + minus_n6_z;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p54 = s2 * qdd_0_p32 - qdd_0_p40 - qdd_0_p31 * qdd_0_p27 - qdd_0_p41 * qdd_0_p42;
  const Real qdd_0_p55 = 117.34209310833121 * qdd_0_p27;

  // link 4 (wrist_1), inward
  const Real f3_x = 4.0059802 * a4_y_p3 + (c4 * f4_x - s4 * f4_y);

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p56 = qdd_0_p38 - 0.6127 * qdd_0_p43 - qdd_0_p31 * qdd_0_p45 - qdd_0_p41 *
      qdd_0_p52;

  // link 4 (wrist_1), inward
  const Real f3_y = n3_z_p1 - 4.0059802 * a4_y_p2;

  // link 4 (wrist_1), composite inertia
  const Real qdd_0_p57 = s4 * (qdd_0_p49 - qdd_0_p47) - c4 * (0.021392421525 * s5);

  // link 1 (shoulder), inward
  const Real qdd_1_p2 = tau[4] - n5_z;
  const Real qdd_1_p3 = c5 * qdd_1_p1;

  // link 4 (wrist_1), composite inertia
  const Real qdd_0_p58 = s4 * qdd_0_p57;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p59 = qdd_0_p56 * qdd_0_p50;
  const Real qdd_0_p60 = qdd_0_p42 * qdd_0_p23;
  const Real qdd_0_p61 = s2 * (1.156008191975 + (qdd_0_p32 + 0.055956818775 * c5)) - qdd_0_p40 -
      qdd_0_p48 * qdd_0_p27 - qdd_0_p53 * qdd_0_p42;

  // link 4 (wrist_1), inward
  const Real n3_z = 2.07831527531 * a4_y_p2 - 0.5656542411875001 * (n3_x_p1 - wd3_x) - 4.0059802 *
      a3_y + (n4_z - 0.57155 * n3_z_p1);

  // link 3 (forearm), inward
  const Real n2_x = 0.0235 * wd2_x + 1.156008191975 * a3_y_p2 + (c3 * n3_x - s3 * n3_y);
  const Real n2_y = s3 * n3_x + c3 * n3_y + 0.6127 * f3_z -
      (8.7498743723 * minus_wd2_y + 1.156008191975 * (w2_x * w2_x - a3_y_p1));

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p62 = qdd_0_p54 * qdd_0_p50;

  // link 1 (shoulder), inward
  const Real qdd_1_p4 = qdd_1_p3 + n3_z;

  // link 4 (wrist_1), composite inertia
  const Real qdd_0_p63 = c4 * qdd_0_p57 + qdd_0_p2 - 0.57155 * qdd_0_p36;
  const Real qdd_0_p64 = 0.002495 + (qdd_0_p49 - qdd_0_p58);

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p65 = 4.3866871861500005 + qdd_0_p38 - qdd_0_p46 - qdd_0_p48 * qdd_0_p45 -
      qdd_0_p53 * qdd_0_p52 - qdd_0_p59 * qdd_0_p56;

  // link 1 (shoulder), inward
  const Real qdd_1_p5 = tau[3] - n4_z - qdd_1_p3 + qdd_0_p6 * qdd_1_p2;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p66 = qdd_0_p61 - qdd_0_p59 * qdd_0_p54;

  // link 4 (wrist_1), composite inertia
  const Real qdd_0_p67 = 2.08081027531 + (qdd_0_p47 + qdd_0_p58 - qdd_0_p30);

  // link 2 (upper_arm), inward
  const Real n1_z = s2 * n2_x + c2 * n2_y;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p68 = 1.0 / qdd_0_p65;

  // link 1 (shoulder), inward
  const Real qdd_1_p6 = tau[1] - 4.36318718615 * a3_y_p2 + 81.98859064500002 * c2 - qdd_1_p4 +
      0.6127 * (s3 * f3_x + c3 * f3_y);
  const Real qdd_1_p7 = tau[2] - qdd_1_p4 - qdd_0_p31 * qdd_1_p2 - qdd_0_p41 * qdd_1_p5;

  // link 3 (forearm), composite inertia
  const Real qdd_0_p69 = s3 * (qdd_0_p64 - qdd_0_p67) + c3 * (2.0 * qdd_0_p63);

  // link 1 (shoulder), inward
  const Real qdd_1_p8 = qdd_1_p6 - qdd_0_p48 * qdd_1_p2 - qdd_0_p53 * qdd_1_p5 - qdd_0_p59 *
      qdd_1_p7;

  // link 3 (forearm), composite inertia
  const Real qdd_0_p70 = s3 * qdd_0_p69;

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p71 = qdd_0_p66 * qdd_0_p68;

  // link 1 (shoulder), inward
  const Real qdd_0_p72 = tau[0] - n1_z - qdd_0_p51 * qdd_1_p1 - qdd_0_p55 * qdd_1_p2 - qdd_0_p60 *
      qdd_1_p5 - qdd_0_p62 * qdd_1_p7;

  // link 3 (forearm), composite inertia
  const Real qdd_0_p73 = 4.37493718615 + (qdd_0_p67 + qdd_0_p70 - qdd_0_p46);

  // link 2 (upper_arm), composite inertia
  const Real qdd_0_p74 = 2.0 * (c3 * qdd_0_p69 - qdd_0_p63 + 0.6127 *
      (s3 * qdd_0_p35 - c3 * qdd_0_p36));
  const Real qdd_0_p75 = qdd_0_p73 + s2 * (s2 * (0.01175 + (qdd_0_p64 - qdd_0_p70) - qdd_0_p73) +
      c2 * qdd_0_p74);

  // link 1 (shoulder), mass matrix
  const Real qdd_0_p76 = 0.5353459446375001 + qdd_0_p75 - qdd_0_p51 * qdd_0_p24 - qdd_0_p55 *
      qdd_0_p27 - qdd_0_p60 * qdd_0_p42 - qdd_0_p62 * qdd_0_p54;

  // link 1 (shoulder), inward
  const Real qdd_0 = (qdd_0_p72 - qdd_0_p71 * qdd_1_p8) *
      (1.0 / (qdd_0_p76 - qdd_0_p71 * qdd_0_p66));
  qdd[0] = qdd_0;
  const Real qdd_1 = qdd_1_p8 * qdd_0_p68 - qdd_0_p71 * qdd_0;
  qdd[1] = qdd_1;
  const Real qdd_2 = qdd_1_p7 * qdd_0_p50 - qdd_0_p62 * qdd_0 - qdd_0_p59 * qdd_1;
  qdd[2] = qdd_2;
  const Real qdd_3 = qdd_1_p5 * qdd_0_p23 - qdd_0_p60 * qdd_0 - qdd_0_p53 * qdd_1 - qdd_0_p41 *
      qdd_2;
  qdd[3] = qdd_3;
  qdd[4] = 117.34209310833121 * qdd_1_p2 - qdd_0_p55 * qdd_0 - qdd_0_p48 * qdd_1 - qdd_0_p31 *
      qdd_2 + qdd_0_p6 * qdd_3;
  qdd[5] = 1605.1364365971108 * qdd_1_p1 - qdd_0_p51 * qdd_0 - (qdd_1 + qdd_2 + qdd_3) * c5;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
