// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
// By Chang table 6.1, fused; Lambda^-1: M = L^T D L, J from poses, in the axes of link 4 (wrist_1) at link origins.
// 1059 flops (add 447, mul 601, div 11), sine and cosine of 6 angles
// Generated; see ur10e.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "ur10e.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

template <int count>
using Lanes = detail::Pack<Real, count>;
void control_torque(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT qdd_0)[6], const Real (&TREELINE_RESTRICT xdd_cmd)[6],
    Real (&TREELINE_RESTRICT tau)[6]) noexcept {
  const Real angles[6] = {q[1], q[2], q[3], q[4], q[0], q[5]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];
  const Real c1 = cosines[4];
  const Real s1 = sines[4];
  const Real c6 = cosines[5];
  const Real s6 = sines[5];

  // link 5 (wrist_2), composite inertia
  const Real f6_y_p1 = 0.0054190910375000005 * s5;
  const Real f6_y_p2 = 0.031809629475 * c5;
  const Real f6_y_p3 = 0.09132825 * s5;
  const Real f6_y_p4 = 0.0106962107625 * c5;
  const Real f6_y_p5 = 0.0106962107625 * s5;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p6 = 1.2551157591996094 * c5;
  const Real f6_y_p7 = c5 * c5;

  // link 6 (wrist_3), mass matrix
  const Real f6_y_p8 = 0.000623 * s5;

  // link 5 (wrist_2), composite inertia
  const Real f6_y_p9 = s5 * f6_y_p1;
  const Real f6_y_p10 = 0.0098370910375 + f6_y_p2;
  const Real f6_y_p11 = 0.0585962731125 + f6_y_p4;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p12 = 0.000623 * f6_y_p7;

  // link 5 (wrist_2), composite inertia
  const Real f6_y_p13 = 0.09132825 * c5;

  // link 5 (wrist_2), mass matrix
  const Real f6_y_p14 = 0.0085220910375 + 0.0159048147375 * c5;

  // link 6 (wrist_3), mass matrix
  const Real f6_y_p15 = s4 * f6_y_p8;
  const Real f6_y_p16 = c4 * f6_y_p8;

  // link 5 (wrist_2), composite inertia
  const Real f6_y_p17 = 0.041592816387499995 + f6_y_p9;

  // link 4 (wrist_1), composite inertia
  const Real f6_y_p18 = 0.33495075 * s4 - c4 * f6_y_p3;
  const Real f6_y_p19 = s4 * f6_y_p3 + 0.33495075 * c4;

  // link 5 (wrist_2), composite inertia
  const Real f6_y_p20 = c5 * f6_y_p1 + 0.0159048147375 * s5;

  // link 5 (wrist_2), mass matrix
  const Real f6_y_p21 = s4 * f6_y_p13;

  // link 4 (wrist_1), composite inertia
  const Real f6_y_p22 = 1.1431 * f6_y_p18;

  // link 3 (forearm), composite inertia
  const Real f6_y_p23 = s3 * f6_y_p19;

  // link 4 (wrist_1), composite inertia
  const Real f6_y_p24 = f6_y_p18 - 4.0059802;

  // link 5 (wrist_2), mass matrix
  const Real f6_y_p25 = c4 * f6_y_p5 + s4 * f6_y_p14;
  const Real f6_y_p26 = s3 * c4;

  // link 5 (wrist_2), composite inertia
  const Real f6_y_p27 = 0.0384148163875 + (0.007282091037500001 - f6_y_p9 + f6_y_p2);

  // link 1 (shoulder), mass matrix
  const Real f6_y_p28 = f6_y_p17 - f6_y_p12 - f6_y_p6 * f6_y_p4;

  // link 5 (wrist_2), mass matrix
  const Real f6_y_p29 = s4 * f6_y_p5 - c4 * f6_y_p14 - 0.0521986612875 * s5;

  // link 4 (wrist_1), composite inertia
  const Real f6_y_p30 = c4 * f6_y_p20 - s4 * f6_y_p11;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p31 = 1.0 / f6_y_p28;

  // link 5 (wrist_2), mass matrix
  const Real f6_y_p32 = 0.57155 * f6_y_p21 - f6_y_p4;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p33 = f6_y_p17 - 0.57155 * f6_y_p18 - f6_y_p12;

  // link 3 (forearm), mass matrix
  const Real f6_y_p34 = f6_y_p23 + c3 * f6_y_p24;

  // link 4 (wrist_1), composite inertia
  const Real f6_y_p35 = s4 * f6_y_p20 + c4 * f6_y_p11;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p36 = 117.34209310833121 * f6_y_p32;
  const Real f6_y_p37 = 2.08330527531 + (f6_y_p17 - f6_y_p22) - f6_y_p12;

  // link 3 (forearm), composite inertia
  const Real f6_y_p38 = 1.2254 * f6_y_p34;

  // link 4 (wrist_1), composite inertia
  const Real f6_y_p39 = s4 * (f6_y_p27 - f6_y_p10) - c4 * (0.021392421525 * s5);

  // link 1 (shoulder), mass matrix
  const Real f6_y_p40 = f6_y_p33 + f6_y_p6 * f6_y_p32;

  // link 3 (forearm), composite inertia
  const Real f6_y_p41 = s3 * f6_y_p35;
  const Real f6_y_p42 = c3 * f6_y_p35;

  // link 4 (wrist_1), composite inertia
  const Real f6_y_p43 = 0.5656542411875001 + (f6_y_p30 + 0.0521986612875 * c5);
  const Real f6_y_p44 = s4 * f6_y_p39;

  // link 5 (wrist_2), mass matrix
  const Real f6_y_p45 = f6_y_p32 + 0.6127 * (f6_y_p26 * f6_y_p13 + c3 * f6_y_p21);

  // link 1 (shoulder), mass matrix
  const Real f6_y_p46 = f6_y_p40 * f6_y_p31;
  const Real f6_y_p47 = 117.34209310833121 * f6_y_p45;

  // link 6 (wrist_3), mass matrix
  const Real f6_y_p48 = s2 * (s3 * f6_y_p15 - c3 * f6_y_p16) - c2 * (s3 * f6_y_p16 + c3 * f6_y_p15);

  // link 4 (wrist_1), composite inertia
  const Real f6_y_p49 = c4 * f6_y_p39 + f6_y_p5 - 0.57155 * f6_y_p19;
  const Real f6_y_p50 = 0.002495 + (f6_y_p27 - f6_y_p44);

  // link 1 (shoulder), mass matrix
  const Real f6_y_p51 = f6_y_p33 - 0.6127 * (f6_y_p23 + c3 * f6_y_p18) + f6_y_p6 * f6_y_p45;

  // link 3 (forearm), composite inertia
  const Real f6_y_p52 = c3 * f6_y_p43 - f6_y_p41;

  // link 5 (wrist_2), mass matrix
  const Real f6_y_p53 = s2 * (c3 * f6_y_p25 - s3 * f6_y_p29) + c2 *
      (s3 * f6_y_p25 + c3 * f6_y_p29 - 0.055956818775 * s5);

  // link 1 (shoulder), mass matrix
  const Real f6_y_p54 = c5 * f6_y_p48;

  // link 4 (wrist_1), composite inertia
  const Real f6_y_p55 = 2.08081027531 + (f6_y_p10 + f6_y_p44 - f6_y_p22);

  // link 1 (shoulder), mass matrix
  const Real f6_y_p56 = f6_y_p51 * f6_y_p31;
  const Real f6_y_p57 = s2 * (c3 * f6_y_p30 - f6_y_p41) + c2 * (s3 * f6_y_p30 + f6_y_p42) -
      f6_y_p54;
  const Real f6_y_p58 = 1605.1364365971108 * f6_y_p48;
  const Real f6_y_p59 = 1.0 / (f6_y_p37 - f6_y_p36 * f6_y_p32 - f6_y_p46 * f6_y_p40);
  const Real f6_y_p60 = f6_y_p54 - c2 * (s3 * f6_y_p43 + f6_y_p42);
  const Real f6_y_p61 = 117.34209310833121 * f6_y_p53;
  const Real f6_y_p62 = f6_y_p37 - 0.6127 * f6_y_p34 - f6_y_p36 * f6_y_p45 - f6_y_p46 * f6_y_p51;
  const Real f6_y_p63 = f6_y_p57 + f6_y_p6 * f6_y_p53;
  const Real f6_y_p64 = c5 * s5;
  const Real f6_y_p65 = 1.0 - f6_y_p46;
  const Real f6_y_p66 = f6_y_p63 * f6_y_p31;

  // link 3 (forearm), composite inertia
  const Real f6_y_p67 = s3 * (f6_y_p50 - f6_y_p55) + c3 * (2.0 * f6_y_p49);

  // link 3 (forearm), pose
  const Real f6_y_p68 = c3 * c4 - s3 * s4;
  const Real f6_y_p69 = c3 * s4 + f6_y_p26;

  // link 4 (wrist_1), Jacobian
  const Real f6_y_p70 = 0.57155 * s4 - 0.11985;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p71 = f6_y_p65 * f6_y_p64;

  // link 4 (wrist_1), pose
  const Real f6_y_p72 = 0.57155 * c4;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p73 = 1.0 - f6_y_p56;
  const Real f6_y_p74 = f6_y_p36 + f6_y_p46 * f6_y_p6;

  // link 3 (forearm), composite inertia
  const Real f6_y_p75 = s3 * f6_y_p67;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p76 = s2 * f6_y_p52 - f6_y_p60 - f6_y_p36 * f6_y_p53 - f6_y_p46 * f6_y_p63;
  const Real f6_y_p77 = f6_y_p70 + 0.11985 * f6_y_p46;
  const Real f6_y_p78 = f6_y_p62 * f6_y_p59;
  const Real f6_y_p79 = s2 * (1.156008191975 + (f6_y_p52 + 0.055956818775 * c5)) - f6_y_p60 -
      f6_y_p47 * f6_y_p53 - f6_y_p56 * f6_y_p63;
  const Real f6_y_p80 = f6_y_p76 * f6_y_p59;

  // link 3 (forearm), Jacobian
  const Real f6_y_p81 = f6_y_p70 + 0.6127 * f6_y_p69;

  // link 2 (upper_arm), pose
  const Real f6_y_p82 = c2 * f6_y_p68 - s2 * f6_y_p69;
  const Real f6_y_p83 = s2 * f6_y_p68 + c2 * f6_y_p69;

  // link 3 (forearm), pose
  const Real f6_y_p84 = f6_y_p72 + 0.6127 * f6_y_p68;

  // link 3 (forearm), composite inertia
  const Real f6_y_p85 = 4.37493718615 + (f6_y_p55 + f6_y_p75 - f6_y_p38);

  // link 2 (upper_arm), composite inertia
  const Real f6_y_p86 = 2.0 * (c3 * f6_y_p67 - f6_y_p49 + 0.6127 * (s3 * f6_y_p24 - c3 * f6_y_p19));

  // link 1 (shoulder), mass matrix
  const Real f6_y_p90 = 4.3866871861500005 + f6_y_p37 - f6_y_p38 - f6_y_p47 * f6_y_p45 - f6_y_p56 *
      f6_y_p51 - f6_y_p78 * f6_y_p62;
  const Real f6_y_p91 = f6_y_p79 - f6_y_p78 * f6_y_p76;
  const Real f6_y_p92 = f6_y_p47 + f6_y_p56 * f6_y_p6 - f6_y_p78 * f6_y_p74;
  const Real f6_y_p93 = f6_y_p73 * f6_y_p64 - f6_y_p78 * f6_y_p71;
  const Real f6_y_p94 = f6_y_p78 * f6_y_p72 - f6_y_p84;
  const Real f6_y_p95 = f6_y_p78 * f6_y_p77 - (f6_y_p81 + 0.11985 * f6_y_p56);
  const Real f6_y_p96 = 1.0 / f6_y_p90;
  const Real f6_y_p97 = 1.0 - f6_y_p7;
  const Real f6_y_p98 = f6_y_p74 * f6_y_p59;
  const Real f6_y_p99 = f6_y_p6 * f6_y_p31;
  const Real f6_y_p100 = f6_y_p71 * f6_y_p59;
  const Lanes<8> f6_y_p101_lanes = detail::make_pack<Real>(f6_y_p80 * f6_y_p72, f6_y_p80 * f6_y_p72,
      f6_y_p80 * f6_y_p72, f6_y_p83 + f6_y_p58 * s5 - f6_y_p66 * f6_y_p64, f6_y_p82 + f6_y_p61 +
      f6_y_p66 * f6_y_p6, f6_y_p80 * f6_y_p72, f6_y_p80 * f6_y_p72, f6_y_p80 * f6_y_p72) -
      detail::make_pack<Real>(0.17415, 0.17415, 0.17415, f6_y_p80, f6_y_p80, 0.17415, 0.17415,
      0.17415) * detail::make_pack<Real>(f6_y_p83, f6_y_p83, f6_y_p83, f6_y_p71, f6_y_p74, f6_y_p83,
      f6_y_p83, f6_y_p83);
  const Real f6_y_p104 = f6_y_p64 * f6_y_p31;
  const Real f6_y_p105 = f6_y_p65 * f6_y_p97;
  const Real f6_y_p106 = f6_y_p97 * f6_y_p31;
  const Real f6_y_p107 = f6_y_p72 * f6_y_p59;
  const Real f6_y_p108 = 1605.1364365971108 * c5;
  const Real f6_y_p109 = f6_y_p105 * f6_y_p59;

  // link 1 (shoulder), Jacobian
  const Real f6_y_p110 = f6_y_p83 * f6_y_p81 + f6_y_p82 * f6_y_p84;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p111 = f6_y_p73 * f6_y_p97 - f6_y_p78 * f6_y_p105;

  // link 2 (upper_arm), composite inertia
  const Real f6_y_p112 = f6_y_p85 + s2 * (s2 * (0.01175 + (f6_y_p50 - f6_y_p75) - f6_y_p85) + c2 *
      f6_y_p86);

  // link 1 (shoulder), mass matrix
  const Real f6_y_p113 = f6_y_p91 * f6_y_p96;
  const Real f6_y_p114 = f6_y_p94 * f6_y_p96;
  const Real f6_y_p115 = f6_y_p92 * f6_y_p96;
  const Real f6_y_p116 = f6_y_p111 * f6_y_p96;
  const Real f6_y_p117 = f6_y_p93 * f6_y_p96;

  // link 2 (upper_arm), outward
  const Real w2_y = c2 * qd[0];
  const Real a3_x_p1 = qd[1] * qd[1];
  const Real a2_x = 9.81 * s2;
  const Real w2_x = s2 * qd[0];
  const Real a3_x_p2 = w2_x * w2_y;

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p122_lanes = detail::make_pack<Real>(0.17415 * f6_y_p82 - 0.11985 * f6_y_p66 +
      f6_y_p80 * f6_y_p77, f6_y_p101_lanes[1], 0.17415 * f6_y_p82 - 0.11985 * f6_y_p66 + f6_y_p80 *
      f6_y_p77, f6_y_p101_lanes[3], f6_y_p101_lanes[4], 0.17415 * f6_y_p82 - 0.11985 * f6_y_p66 +
      f6_y_p80 * f6_y_p77, 0.17415 * f6_y_p82 - 0.11985 * f6_y_p66 + f6_y_p80 * f6_y_p77, 0.17415 *
      f6_y_p82 - 0.11985 * f6_y_p66 + f6_y_p80 * f6_y_p77) - f6_y_p113 *
      detail::make_pack<Real>(f6_y_p95, f6_y_p94, f6_y_p95, f6_y_p93, f6_y_p92, f6_y_p95, f6_y_p95,
      f6_y_p95);
  const Real f6_y_p126 = f6_y_p58 * c5 + f6_y_p66 * f6_y_p97 + f6_y_p80 * f6_y_p105 + f6_y_p113 *
      f6_y_p111;

  // link 2 (upper_arm), outward
  const Real wd2_y_p1 = w2_x * qd[1];
  const Real wd2_x_p1 = s2 * qdd_0[0];
  const Real wd2_x_p2 = w2_y * qd[1];
  const Real a3_x_p3 = a3_x_p2 + qdd_0[1];

  // link 3 (forearm), outward
  const Real w3_y = c3 * w2_y - s3 * w2_x;

  // link 2 (upper_arm), outward
  const Real a2_y = 9.81 * c2;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p127 = 0.5353459446375001 + f6_y_p112 - f6_y_p58 * f6_y_p48 - f6_y_p61 *
      f6_y_p53 - f6_y_p66 * f6_y_p63 - f6_y_p80 * f6_y_p76;

  // link 3 (forearm), outward
  const Real w3_z = qd[1] + qd[2];
  const Real wd3_z = qdd_0[1] + qdd_0[2];
  const Real w3_x = c3 * w2_x + s3 * w2_y;

  // link 2 (upper_arm), outward
  const Real wd2_y = c2 * qdd_0[0] - wd2_y_p1;
  const Real wd2_x = wd2_x_p1 + wd2_x_p2;

  // link 3 (forearm), outward
  const Real a4_x_p1 = w3_z * w3_z;
  const Real a4_x_p2 = w3_x * w3_y;

  // link 4 (wrist_1), outward
  const Real w4_z = w3_z + qd[3];

  // link 1 (shoulder), mass matrix
  const Real f6_y_p128 = 1.0 / (f6_y_p127 - f6_y_p113 * f6_y_p91);

  // link 3 (forearm), outward
  const Real a3_x_p4 = a2_x + 0.6127 * (w2_y * w2_y + a3_x_p1);
  const Real a3_x_p5 = a2_y - 0.6127 * a3_x_p3;

  // link 4 (wrist_1), outward
  const Real a4_x_p3 = w3_y * w3_y + a4_x_p1;

  // link 2 (upper_arm), outward
  const Real minus_a3_z_p1 = wd2_y_p1 - wd2_y;

  // link 3 (forearm), outward
  const Real a4_x_p4 = a4_x_p2 + wd3_z;

  // link 4 (wrist_1), outward
  const Real w4_x = c4 * w3_x + s4 * w3_y;
  const Real w4_y = c4 * w3_y - s4 * w3_x;
  const Real a5_x_p1 = w4_x * w4_z;
  const Real a5_x_p2 = w4_x * w4_x;
  const Real a5_x_p3 = w4_y * w4_y;

  // link 3 (forearm), outward
  const Real wd3_y = c3 * wd2_y - s3 * wd2_x - w3_x * qd[2];
  const Real wd3_x = c3 * wd2_x + s3 * wd2_y + w3_y * qd[2];

  // link 4 (wrist_1), outward
  const Real wd4_z = wd3_z + qdd_0[3];

  // link 3 (forearm), outward
  const Real minus_a3_z = 0.6127 * minus_a3_z_p1;
  const Real a3_x = c3 * a3_x_p4 + s3 * a3_x_p5;
  const Real a3_y = c3 * a3_x_p5 - s3 * a3_x_p4;

  // link 5 (wrist_2), outward
  const Real w5_z = qd[4] - w4_y;

  // link 4 (wrist_1), outward
  const Real minus_a5_z_p1 = w4_y * w4_z;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p129 = 1605.1364365971108 * s5 * s5 + f6_y_p104 * f6_y_p64 + f6_y_p100 *
      f6_y_p71 + f6_y_p117 * f6_y_p93;

  // link 4 (wrist_1), outward
  const Real a4_x_p5 = a3_x + 0.57155 * a4_x_p3;
  const Real a4_x_p6 = a3_y - 0.57155 * a4_x_p4;

  // link 3 (forearm), outward
  const Real minus_a4_z_p1 = w3_x * w3_z - wd3_y;

  // link 5 (wrist_2), outward
  const Real w5_x = c5 * w4_x + s5 * w4_z;

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p130_lanes = f6_y_p122_lanes * f6_y_p128;
  const Real f6_y_p134 = f6_y_p126 * f6_y_p128;
  const Real f6_y_p135 = f6_y_p110 * f6_y_p128;

  // link 5 (wrist_2), outward
  const Real w5_y = c5 * w4_z - s5 * w4_x;
  const Real a6_x_p1 = w5_x * w5_z;
  const Real a6_x_p2 = w5_x * w5_x;

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p136_lanes = f6_y_p130_lanes * f6_y_p122_lanes[0];
  const Real f6_y_p140 = f6_y_p135 * f6_y_p122_lanes[0];

  // link 4 (wrist_1), outward
  const Real wd4_y = c4 * wd3_y - s4 * wd3_x - w4_x * qd[3];
  const Real wd4_x = c4 * wd3_x + s4 * wd3_y + w4_y * qd[3];

  // link 1 (shoulder), mass matrix
  const Real f6_y_p144 = 0.0143640225 / f6_y_p28 + f6_y_p77 * f6_y_p59 * f6_y_p77 + f6_y_p95 *
      f6_y_p96 * f6_y_p95 + f6_y_p136_lanes[0];
  const Real f6_y_p145 = 0.11985 * f6_y_p106 - f6_y_p109 * f6_y_p77 + f6_y_p116 * f6_y_p95 -
      f6_y_p134 * f6_y_p122_lanes[0];
  const Real f6_y_p146 = f6_y_p107 * f6_y_p77 + f6_y_p114 * f6_y_p95 + f6_y_p136_lanes[1];
  const Real f6_y_p147 = f6_y_p115 * f6_y_p95 - (0.11985 * f6_y_p99 + f6_y_p98 * f6_y_p77) +
      f6_y_p136_lanes[4];
  const Real f6_y_p148 = 0.11985 * f6_y_p104 - f6_y_p100 * f6_y_p77 + f6_y_p117 * f6_y_p95 +
      f6_y_p136_lanes[3];
  const Lanes<8> f6_y_p149_lanes = detail::make_pack<Real>(f6_y_p107 * f6_y_p72 + f6_y_p114 *
      f6_y_p94, f6_y_p107 * f6_y_p72 + f6_y_p114 * f6_y_p94, f6_y_p107 * f6_y_p72 + f6_y_p114 *
      f6_y_p94, f6_y_p117 * f6_y_p94 - f6_y_p100 * f6_y_p72, f6_y_p115 * f6_y_p94 - f6_y_p98 *
      f6_y_p72, f6_y_p107 * f6_y_p72 + f6_y_p114 * f6_y_p94, f6_y_p107 * f6_y_p72 + f6_y_p114 *
      f6_y_p94, f6_y_p107 * f6_y_p72 + f6_y_p114 * f6_y_p94) + f6_y_p130_lanes * f6_y_p122_lanes[1];

  // link 4 (wrist_1), outward
  const Real a5_x_p4 = a5_x_p1 + wd4_y;
  const Real a4_x = c4 * a4_x_p5 + s4 * a4_x_p6;
  const Real minus_a4_z = minus_a3_z + 0.57155 * minus_a4_z_p1;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p152 = 1.0 / f6_y_p144;

  // link 5 (wrist_2), outward
  const Real a6_x_p3 = w5_y * w5_y;
  const Real a5_x_p5 = minus_a4_z + 0.17415 * (a5_x_p2 + a5_x_p3);
  const Real wd5_z = qdd_0[4] - wd4_y;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p153 = f6_y_p106 * f6_y_p64 - f6_y_p108 * s5 + f6_y_p109 * f6_y_p71 + f6_y_p116 *
      f6_y_p93 - f6_y_p134 * f6_y_p122_lanes[3];

  // link 6 (wrist_3), outward
  const Real w6_x = c6 * w5_x - s6 * w5_z;
  const Real minus_w6_y = s6 * w5_x + c6 * w5_z;

  // link 5 (wrist_2), outward
  const Real a5_x_p6 = a4_x + 0.17415 * a5_x_p4;
  const Real wd5_y = c5 * wd4_z - s5 * wd4_x - w5_x * qd[4];
  const Real wd5_x = c5 * wd4_x + s5 * wd4_z + w5_y * qd[4];

  // link 4 (wrist_1), outward
  const Real a4_y = c4 * a4_x_p6 - s4 * a4_x_p5;

  // link 6 (wrist_3), outward
  const Real w6_z = w5_y + qd[5];

  // link 5 (wrist_2), outward
  const Real a6_x_p4 = a6_x_p1 + wd5_y;
  const Real minus_a5_z = a4_y + 0.17415 * (minus_a5_z_p1 - wd4_x);
  const Real a6_z_p1 = w5_y * w5_z;

  // link 6 (wrist_3), outward
  const Real f6_y_p154 = c1 * xdd_cmd[0] + s1 * xdd_cmd[1];
  const Real f6_y_p155 = 9.81 + xdd_cmd[2];
  const Real f6_y_p156 = c1 * xdd_cmd[3] + s1 * xdd_cmd[4];
  const Real f6_y_p157 = w6_x * w6_z;
  const Real f6_y_p158 = minus_w6_y * w6_z;

  // link 5 (wrist_2), outward
  const Real a5_x = c5 * a5_x_p6 - s5 * a5_x_p5;

  // link 6 (wrist_3), outward
  const Real a6_x_p5 = minus_a5_z + 0.11985 * (a6_x_p2 + a6_x_p3);

  // link 1 (shoulder), mass matrix
  const Real f6_y_p159 = f6_y_p145 * f6_y_p152;
  const Real f6_y_p160 = f6_y_p147 * f6_y_p152;
  const Real f6_y_p161 = f6_y_p148 * f6_y_p152;
  const Real f6_y_p162 = f6_y_p140 * f6_y_p152;
  const Real f6_y_p163 = f6_y_p146 * f6_y_p152;

  // link 6 (wrist_3), outward
  const Real a6_x_p6 = a5_x + 0.11985 * a6_x_p4;
  const Real minus_wd6_y = s6 * wd5_x + c6 * wd5_z + w6_x * qd[5];
  const Real wd6_x = c6 * wd5_x - s6 * wd5_z - minus_w6_y * qd[5];
  const Real f6_y_p176 = c2 * xdd_cmd[5] - s2 * f6_y_p156;
  const Real f6_y_p177 = c2 * f6_y_p156 + s2 * xdd_cmd[5];

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p185_lanes = detail::make_pack<Real>(f6_y_p149_lanes[1], f6_y_p149_lanes[1],
      f6_y_p135 * f6_y_p122_lanes[1], f6_y_p149_lanes[3], f6_y_p149_lanes[4], f6_y_p116 * f6_y_p94 -
      f6_y_p109 * f6_y_p72 - f6_y_p134 * f6_y_p122_lanes[1], f6_y_p149_lanes[1],
      f6_y_p149_lanes[1]) - detail::make_pack<Real>(f6_y_p163, f6_y_p163, f6_y_p162, f6_y_p161,
      f6_y_p160, f6_y_p159, f6_y_p163, f6_y_p163) * f6_y_p146;

  // link 6 (wrist_3), pose
  const Real f6_y_p190 = c6 * c5;
  const Real f6_y_p191 = s6 * c5;

  // link 6 (wrist_3), outward
  const Real f6_y_p192 = c2 * f6_y_p154 + s2 * f6_y_p155;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p193 = 1.0 / f6_y_p185_lanes[1];

  // link 6 (wrist_3), outward
  const Real f6_y_p194 = c2 * f6_y_p155 - s2 * f6_y_p154;

  // link 6 (wrist_3), pose
  const Real f6_y_p195 = c6 * s5;
  const Real f6_y_p196 = s6 * s5;

  // link 6 (wrist_3), outward
  const Real a6_x = c6 * a6_x_p6 + s6 * a6_x_p5;
  const Real a6_y = c6 * a6_x_p5 - s6 * a6_x_p6;

  // link 5 (wrist_2), outward
  const Real minus_a5_y = s5 * a5_x_p6 + c5 * a5_x_p5;

  // link 6 (wrist_3), outward
  const Real f6_y_p197 = c3 * f6_y_p176 - s3 * f6_y_p177;
  const Real f6_y_p198 = c3 * f6_y_p177 + s3 * f6_y_p176;
  const Real f6_y_p199 = a6_x + 0.11655 * (f6_y_p157 - minus_wd6_y);
  const Real f6_y_p200 = a6_y - 0.11655 * (f6_y_p158 + wd6_x);
  const Real a6_z = 0.11985 * (a6_z_p1 - wd5_x) - minus_a5_y;
  const Real wd6_z = wd5_y + qdd_0[5];

  // link 1 (shoulder), mass matrix
  const Real f6_y_p201 = 117.34209310833121 + f6_y_p99 * f6_y_p6 + f6_y_p98 * f6_y_p74 + f6_y_p115 *
      f6_y_p92 + f6_y_p130_lanes[4] * f6_y_p122_lanes[4];

  // link 6 (wrist_3), outward
  const Real f6_y_p202 = a6_z - 0.11655 * (w6_x * w6_x + minus_w6_y * minus_w6_y);
  const Real f6_y_p203 = c3 * f6_y_p192 + s3 * f6_y_p194;
  const Real f6_y_p204 = c3 * f6_y_p194 - s3 * f6_y_p192;

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p205_lanes = f6_y_p185_lanes * f6_y_p193;

  // link 6 (wrist_3), outward
  const Real f6_y_p209 = 0.11655 * c5;
  const Real f6_y_p210 = 0.11655 * s5;
  const Real f6_y_p211 = c4 * f6_y_p197 - s4 * f6_y_p198 - (s6 * wd6_x - c6 * minus_wd6_y);
  const Real f6_y_p219 = c1 * xdd_cmd[4] - s1 * xdd_cmd[3] +
      (f6_y_p195 * wd6_x + f6_y_p196 * minus_wd6_y + c5 * wd6_z);
  const Real f6_y_p220 = c4 * f6_y_p198 + s4 * f6_y_p197 -
      (f6_y_p190 * wd6_x + f6_y_p191 * minus_wd6_y - s5 * wd6_z);
  const Real f6_y_p221 = c4 * f6_y_p203 + s4 * f6_y_p204 -
      (f6_y_p190 * f6_y_p199 - f6_y_p191 * f6_y_p200 - s5 * f6_y_p202);

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p222_lanes = detail::make_pack<Real>(f6_y_p135 * f6_y_p110, f6_y_p135 *
      f6_y_p110, f6_y_p135 * f6_y_p110, f6_y_p130_lanes[3] * f6_y_p110, f6_y_p130_lanes[4] *
      f6_y_p110, -(f6_y_p134 * f6_y_p110), f6_y_p135 * f6_y_p110, f6_y_p135 * f6_y_p110) -
      detail::make_pack<Real>(f6_y_p162, f6_y_p162, f6_y_p162, f6_y_p161, f6_y_p160, f6_y_p159,
      f6_y_p162, f6_y_p162) * f6_y_p140 - f6_y_p205_lanes * f6_y_p185_lanes[2];
  const Real f6_y_p229 = 1.0 / f6_y_p222_lanes[2];

  // link 6 (wrist_3), outward
  const Real f6_y_p230 = f6_y_p221 - f6_y_p211 * f6_y_p209;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p231 = f6_y_p109 * f6_y_p74 - f6_y_p106 * f6_y_p6 + f6_y_p116 * f6_y_p92 -
      f6_y_p134 * f6_y_p122_lanes[4] - f6_y_p159 * f6_y_p147;

  // link 6 (wrist_3), outward
  const Real f6_y_p232 = c4 * f6_y_p204 - s4 * f6_y_p203 - (s6 * f6_y_p199 + c6 * f6_y_p200) -
      (f6_y_p219 * f6_y_p210 - f6_y_p220 * f6_y_p209);
  const Real f6_y_p233 = c1 * xdd_cmd[1] - s1 * xdd_cmd[0] +
      (f6_y_p195 * f6_y_p199 - f6_y_p196 * f6_y_p200 + c5 * f6_y_p202);

  // link 5 (wrist_2), outward
  const Real n5_y_p1 = w5_x * w5_y;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p234 = f6_y_p232 - f6_y_p163 * f6_y_p230;
  const Real f6_y_p235 = f6_y_p108 * c5 + f6_y_p106 * f6_y_p97 + f6_y_p109 * f6_y_p105 + f6_y_p116 *
      f6_y_p111 + f6_y_p134 * f6_y_p126;

  // link 5 (wrist_2), outward
  const Real n5_x_p1 = a6_z_p1 + wd5_x;
  const Real n5_x_p2 = w5_z * w5_z;
  const Real n5_y_p2 = n5_y_p1 - wd5_z;

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p236_lanes = f6_y_p222_lanes * f6_y_p229;

  // link 4 (wrist_1), outward
  const Real n4_x_p1 = minus_a5_z_p1 + wd4_x;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p239 = f6_y_p233 + f6_y_p211 * f6_y_p210 + f6_y_p162 * f6_y_p230 +
      f6_y_p205_lanes[2] * f6_y_p234;

  // link 4 (wrist_1), outward
  const Real n4_x_p2 = w4_z * w4_z;

  // link 1 (shoulder), mass matrix
  const Lanes<8> f6_y_p243_lanes = detail::make_pack<Real>(f6_y_p129 + f6_y_p130_lanes[3] *
      f6_y_p122_lanes[3], f6_y_p129 + f6_y_p130_lanes[3] * f6_y_p122_lanes[3], f6_y_p129 +
      f6_y_p130_lanes[3] * f6_y_p122_lanes[3], f6_y_p129 + f6_y_p130_lanes[3] * f6_y_p122_lanes[3],
      f6_y_p98 * f6_y_p71 - f6_y_p99 * f6_y_p64 + f6_y_p115 * f6_y_p93 + f6_y_p130_lanes[4] *
      f6_y_p122_lanes[3], f6_y_p153, f6_y_p129 + f6_y_p130_lanes[3] * f6_y_p122_lanes[3],
      f6_y_p129 + f6_y_p130_lanes[3] * f6_y_p122_lanes[3]) -
      detail::make_pack<Real>(f6_y_p161, f6_y_p161, f6_y_p161, f6_y_p161, f6_y_p160, f6_y_p159,
      f6_y_p161, f6_y_p161) * f6_y_p148 - f6_y_p205_lanes * f6_y_p185_lanes[3] - f6_y_p236_lanes *
      f6_y_p222_lanes[3];
  const Real f6_y_p246 = f6_y_p220 - f6_y_p161 * f6_y_p230 - f6_y_p205_lanes[3] * f6_y_p234 +
      f6_y_p236_lanes[3] * f6_y_p239;

  // link 4 (wrist_1), outward
  const Real n4_y_p1 = w4_x * w4_y;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p247 = 1.0 / f6_y_p243_lanes[3];

  // link 3 (forearm), outward
  const Real n3_x_p1 = w3_y * w3_z;

  // link 4 (wrist_1), outward
  const Real n4_y_p2 = n4_y_p1 - wd4_z;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p248 = f6_y_p243_lanes[4] * f6_y_p247;
  const Real f6_y_p249 = f6_y_p243_lanes[5] * f6_y_p247;
  const Real f6_y_p250 = f6_y_p201 - f6_y_p160 * f6_y_p147 - f6_y_p205_lanes[4] *
      f6_y_p185_lanes[4] - f6_y_p236_lanes[4] * f6_y_p222_lanes[4] - f6_y_p248 * f6_y_p243_lanes[4];
  const Real f6_y_p251 = f6_y_p231 - f6_y_p205_lanes[5] * f6_y_p185_lanes[4] - f6_y_p236_lanes[5] *
      f6_y_p222_lanes[4] - f6_y_p249 * f6_y_p243_lanes[4];
  const Real f6_y_p252 = f6_y_p235 - f6_y_p159 * f6_y_p145 - f6_y_p205_lanes[5] *
      f6_y_p185_lanes[5] - f6_y_p236_lanes[5] * f6_y_p222_lanes[5] - f6_y_p249 * f6_y_p243_lanes[5];
  const Real f6_y_p253 = f6_y_p211 - f6_y_p160 * f6_y_p230 - f6_y_p205_lanes[4] * f6_y_p234 +
      f6_y_p236_lanes[4] * f6_y_p239 - f6_y_p248 * f6_y_p246;
  const Real f6_y_p254 = f6_y_p236_lanes[5] * f6_y_p239 -
      (f6_y_p219 + f6_y_p159 * f6_y_p230 + f6_y_p205_lanes[5] * f6_y_p234) - f6_y_p249 * f6_y_p246;
  const Real f6_y_p255 = 1.0 / f6_y_p250;
  const Real f6_y_p256 = f6_y_p251 * f6_y_p255;
  const Real f6_y_p257 = (f6_y_p254 - f6_y_p256 * f6_y_p253) *
      (1.0 / (f6_y_p252 - f6_y_p256 * f6_y_p251));
  const Real f6_y_p258 = f6_y_p253 * f6_y_p255 - f6_y_p256 * f6_y_p257;
  const Real f6_y_p259 = f6_y_p246 * f6_y_p247 - f6_y_p248 * f6_y_p258 - f6_y_p249 * f6_y_p257;

  // link 6 (wrist_3), inertial wrench
  const Real n6_z = 0.000623 * wd6_z + (c5 * f6_y_p257 - s5 * f6_y_p259);
  tau[5] = n6_z;

  // link 3 (forearm), inertial wrench
  const Real n3_z_p1 = 2.07831527531 * a4_x_p2 + 2.0833052753100003 * wd3_z - 0.5656542411875001 *
      (n3_x_p1 - wd3_x) - 4.0059802 * a3_y;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p260 = f6_y_p239 * f6_y_p229 + f6_y_p236_lanes[3] * f6_y_p259 +
      f6_y_p236_lanes[4] * f6_y_p258 + f6_y_p236_lanes[5] * f6_y_p257;

  // link 6 (wrist_3), inertial wrench
  const Real n6_y = c6 * f6_y_p258 - f6_y_p191 * f6_y_p259 - f6_y_p196 * f6_y_p257 - 0.0003115 *
      (f6_y_p157 + minus_wd6_y);
  const Real n6_x = 0.0003115 * (wd6_x - f6_y_p158) +
      (f6_y_p190 * f6_y_p259 + s6 * f6_y_p258 + f6_y_p195 * f6_y_p257);

  // link 6 (wrist_3), inward
  const Real n5_z = 0.008210591037500001 * wd5_z - 0.005730591037500001 * n5_y_p1 -
      0.0106962107625 * a6_x_p4 - 0.09132825 * a5_x - (s6 * n6_x + c6 * n6_y);
  tau[4] = n5_z;

  // link 1 (shoulder), mass matrix
  const Real f6_y_p261 = f6_y_p234 * f6_y_p193 + f6_y_p205_lanes[2] * f6_y_p260 -
      f6_y_p205_lanes[3] * f6_y_p259 - f6_y_p205_lanes[4] * f6_y_p258 - f6_y_p205_lanes[5] *
      f6_y_p257;
  const Real f6_y_p262 = f6_y_p230 * f6_y_p152 - f6_y_p163 * f6_y_p261 + f6_y_p162 * f6_y_p260 -
      f6_y_p161 * f6_y_p259 - f6_y_p160 * f6_y_p258;
  const Real f6_y_p263 = f6_y_p262 - f6_y_p159 * f6_y_p257;

  // link 6 (wrist_3), inertial wrench
  const Real minus_f6_z = s5 * f6_y_p263 + c5 * f6_y_p260;
  const Real f6_y = c6 * f6_y_p261 - f6_y_p191 * f6_y_p263 + f6_y_p196 * f6_y_p260;
  const Real f6_x = f6_y_p190 * f6_y_p263 + s6 * f6_y_p261 - f6_y_p195 * f6_y_p260;

  // link 6 (wrist_3), inward
  const Real minus_f5_y = 0.09132825 * (a6_x_p2 + n5_x_p2) + minus_f6_z;
  const Real n5_y_p3 = s6 * f6_y - c6 * f6_x;
  const Real n5_x = 0.0069705910375000004 * n5_x_p1 + 0.0106962107625 * (n5_x_p2 - a6_x_p3) -
      0.09132825 * minus_a5_z + (0.11985 * minus_f6_z - (s6 * n6_y - c6 * n6_x));
  const Real f5_x = 0.09132825 * n5_y_p2 - n5_y_p3;
  const Real f5_z = 0.09132825 * n5_x_p1 - (s6 * f6_x + c6 * f6_y);

  // link 5 (wrist_2), inward
  const Real f4_y = 0.33495075 * (a5_x_p2 + n4_x_p2) - f5_z;

  // link 6 (wrist_3), inward
  const Real n5_y = 0.0106962107625 * n5_y_p2 - 0.00124 * (a6_x_p1 - wd5_y) +
      (n6_z - 0.11985 * n5_y_p3);

  // link 5 (wrist_2), inward
  const Real n4_y_p3 = c5 * f5_x + s5 * minus_f5_y;
  const Real f4_z = s5 * f5_x - c5 * minus_f5_y - 0.33495075 * n4_x_p1;
  const Real f4_x = n4_y_p3 - 0.33495075 * n4_y_p2;

  // link 4 (wrist_1), inward
  const Real f3_z = f4_z - 4.0059802 * minus_a4_z_p1;

  // link 5 (wrist_2), inward
  const Real n4_y = 0.17415 * n4_y_p3 - n5_z - (0.001315 * (a5_x_p1 - wd4_y) + 0.0585962731125 *
      n4_y_p2);

  // link 4 (wrist_1), inward
  const Real f3_y_p1 = s4 * f4_x + c4 * f4_y;

  // link 5 (wrist_2), inward
  const Real n4_z = 0.0397298163875 * wd4_z - 0.037099816387500005 * n4_y_p1 + 0.0585962731125 *
      a5_x_p4 + 0.33495075 * a4_x + (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;
  const Real n4_x = 0.0384148163875 * n4_x_p1 - 0.0585962731125 * (n4_x_p2 - a5_x_p3) + 0.33495075 *
      minus_a4_z + (c5 * n5_x - s5 * n5_y + 0.17415 * f5_z);

  // link 4 (wrist_1), inward
  const Real f3_x = 4.0059802 * a4_x_p3 + (c4 * f4_x - s4 * f4_y);
  const Real f3_y = f3_y_p1 - 4.0059802 * a4_x_p4;
  const Real n3_z = n3_z_p1 + (n4_z - 0.57155 * f3_y_p1);
  tau[2] = n3_z;
  const Real n3_x = 0.002495 * (n3_x_p1 + wd3_x) + 0.5656542411875001 * a4_x_p4 +
      (c4 * n4_x - s4 * n4_y);
  const Real n3_y = s4 * n4_x + c4 * n4_y + 0.57155 * f4_z -
      (2.08081027531 * minus_a4_z_p1 + 0.5656542411875001 * (w3_x * w3_x - a4_x_p1) +
      2.45446406854 * minus_a3_z_p1);

  // link 3 (forearm), inward
  const Real n2_z = 4.36318718615 * a3_x_p2 + 4.3866871861500005 * qdd_0[1] + 1.156008191975 *
      wd2_x_p1 - 81.98859064500002 * c2 + (n3_z - 0.6127 * (s3 * f3_x + c3 * f3_y));
  tau[1] = n2_z;
  const Real n2_x = 0.01175 * (wd2_x_p2 + wd2_x) + 1.156008191975 * a3_x_p3 +
      (c3 * n3_x - s3 * n3_y);
  const Real n2_y = s3 * n3_x + c3 * n3_y + 0.6127 * f3_z -
      (4.37493718615 * minus_a3_z_p1 + 1.156008191975 * (w2_x * w2_x - a3_x_p1));

  // link 2 (upper_arm), inward
  const Real n1_z = 0.5353459446375 * qdd_0[0] + (s2 * n2_x + c2 * n2_y);
  tau[0] = n1_z;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
