// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J carried inward, in the axes of link 1 (shoulder) at link origins.
// 622 flops (add 267, mul 351, div 4), sine and cosine of 5 angles
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

void lambda_inverse(const Real (&TREELINE_RESTRICT q)[6],
    Real (&TREELINE_RESTRICT Lambda_inv)[36]) noexcept {
  const Real angles[5] = {q[3], q[2], q[1], q[4], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real c4 = cosines[0];
  const Real c3 = cosines[1];
  const Real c2 = cosines[2];
  const Real s3 = sines[1];
  const Real s2 = sines[2];
  const Real s4 = sines[0];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];
  const Real s1 = sines[4];
  const Real c1 = cosines[4];

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p1 = 0.0054190910375000005 * s5;
  const Real Lambda_inv_0_0_p2 = 0.031809629475 * c5;
  const Real Lambda_inv_0_0_p3 = 0.09132825 * s5;
  const Real Lambda_inv_0_0_p4 = 0.0106962107625 * c5;
  const Real Lambda_inv_0_0_p5 = 0.0106962107625 * s5;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p6 = 1.2551157591996094 * c5;
  const Real Lambda_inv_0_0_p7 = c5 * c5;

  // link 6 (wrist_3), mass matrix
  const Real Lambda_inv_0_0_p8 = 0.000623 * s5;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p9 = s5 * Lambda_inv_0_0_p1;
  const Real Lambda_inv_0_0_p10 = 0.0098370910375 + Lambda_inv_0_0_p2;
  const Real Lambda_inv_0_0_p11 = 0.0585962731125 + Lambda_inv_0_0_p4;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p12 = 0.000623 * Lambda_inv_0_0_p7;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p13 = 0.09132825 * c5;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_inv_0_0_p14 = 0.0085220910375 + 0.0159048147375 * c5;

  // link 6 (wrist_3), mass matrix
  const Real Lambda_inv_0_0_p15 = s4 * Lambda_inv_0_0_p8;
  const Real Lambda_inv_0_0_p16 = c4 * Lambda_inv_0_0_p8;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p17 = 0.041592816387499995 + Lambda_inv_0_0_p9;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_inv_0_0_p18 = 0.33495075 * s4 - c4 * Lambda_inv_0_0_p3;

  // link 4 (wrist_1), mass matrix
  const Real Lambda_inv_0_0_p19 = 0.33495075 * c4 + s4 * Lambda_inv_0_0_p3;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p20 = c5 * Lambda_inv_0_0_p1 + 0.0159048147375 * s5;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_inv_0_0_p21 = s4 * Lambda_inv_0_0_p13;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_inv_0_0_p22 = 1.1431 * Lambda_inv_0_0_p18;

  // link 4 (wrist_1), mass matrix
  const Real Lambda_inv_0_0_p23 = s3 * Lambda_inv_0_0_p19;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_inv_0_0_p24 = Lambda_inv_0_0_p18 - 4.0059802;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_inv_0_0_p25 = c4 * Lambda_inv_0_0_p5 + s4 * Lambda_inv_0_0_p14;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p26 = 0.0384148163875 +
      (0.007282091037500001 - Lambda_inv_0_0_p9 + Lambda_inv_0_0_p2);

  // link 5 (wrist_2), mass matrix
  const Real Lambda_inv_0_0_p27 = s4 * Lambda_inv_0_0_p5 - c4 * Lambda_inv_0_0_p14 -
      0.0521986612875 * s5;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_inv_0_0_p28 = c4 * Lambda_inv_0_0_p20 - s4 * Lambda_inv_0_0_p11;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p29 = 1.0 / (Lambda_inv_0_0_p17 - Lambda_inv_0_0_p12 -
      Lambda_inv_0_0_p6 * Lambda_inv_0_0_p4);

  // link 5 (wrist_2), mass matrix
  const Real Lambda_inv_0_0_p30 = 0.57155 * Lambda_inv_0_0_p21 - Lambda_inv_0_0_p4;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p31 = Lambda_inv_0_0_p17 - 0.57155 * Lambda_inv_0_0_p18 -
      Lambda_inv_0_0_p12;

  // link 3 (forearm), mass matrix
  const Real Lambda_inv_0_0_p32 = Lambda_inv_0_0_p23 + c3 * Lambda_inv_0_0_p24;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_inv_0_0_p33 = s4 * Lambda_inv_0_0_p20 + c4 * Lambda_inv_0_0_p11;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p34 = 117.34209310833121 * Lambda_inv_0_0_p30;
  const Real Lambda_inv_0_0_p35 = 2.08330527531 + (Lambda_inv_0_0_p17 - Lambda_inv_0_0_p22) -
      Lambda_inv_0_0_p12;

  // link 3 (forearm), composite inertia
  const Real Lambda_inv_0_0_p36 = 1.2254 * Lambda_inv_0_0_p32;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_inv_0_0_p37 = s4 * (Lambda_inv_0_0_p26 - Lambda_inv_0_0_p10) - c4 *
      (0.021392421525 * s5);

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p38 = Lambda_inv_0_0_p31 + Lambda_inv_0_0_p6 * Lambda_inv_0_0_p30;

  // link 3 (forearm), composite inertia
  const Real Lambda_inv_0_0_p39 = s3 * Lambda_inv_0_0_p33;
  const Real Lambda_inv_0_0_p40 = c3 * Lambda_inv_0_0_p33;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_inv_0_0_p41 = 0.5656542411875001 + (Lambda_inv_0_0_p28 + 0.0521986612875 * c5);
  const Real Lambda_inv_0_0_p42 = s4 * Lambda_inv_0_0_p37;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_inv_0_0_p43 = Lambda_inv_0_0_p30 + 0.6127 *
      (s3 * (c4 * Lambda_inv_0_0_p13) + c3 * Lambda_inv_0_0_p21);

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p44 = Lambda_inv_0_0_p38 * Lambda_inv_0_0_p29;
  const Real Lambda_inv_0_0_p45 = 117.34209310833121 * Lambda_inv_0_0_p43;

  // link 6 (wrist_3), mass matrix
  const Real Lambda_inv_0_0_p46 = s2 * (s3 * Lambda_inv_0_0_p15 - c3 * Lambda_inv_0_0_p16) - c2 *
      (s3 * Lambda_inv_0_0_p16 + c3 * Lambda_inv_0_0_p15);

  // link 4 (wrist_1), composite inertia
  const Real Lambda_inv_0_0_p47 = c4 * Lambda_inv_0_0_p37 + Lambda_inv_0_0_p5 - 0.57155 *
      Lambda_inv_0_0_p19;
  const Real Lambda_inv_0_0_p48 = 0.002495 + (Lambda_inv_0_0_p26 - Lambda_inv_0_0_p42);

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p49 = Lambda_inv_0_0_p31 - 0.6127 *
      (Lambda_inv_0_0_p23 + c3 * Lambda_inv_0_0_p18) + Lambda_inv_0_0_p6 * Lambda_inv_0_0_p43;

  // link 3 (forearm), composite inertia
  const Real Lambda_inv_0_0_p50 = c3 * Lambda_inv_0_0_p41 - Lambda_inv_0_0_p39;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_inv_0_0_p51 = s2 * (c3 * Lambda_inv_0_0_p25 - s3 * Lambda_inv_0_0_p27) + c2 *
      (s3 * Lambda_inv_0_0_p25 + c3 * Lambda_inv_0_0_p27 - 0.055956818775 * s5);

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p52 = c5 * Lambda_inv_0_0_p46;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_inv_0_0_p53 = 2.08081027531 + (Lambda_inv_0_0_p10 + Lambda_inv_0_0_p42 -
      Lambda_inv_0_0_p22);

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p54 = Lambda_inv_0_0_p49 * Lambda_inv_0_0_p29;
  const Real Lambda_inv_0_0_p55 = s2 * (c3 * Lambda_inv_0_0_p28 - Lambda_inv_0_0_p39) + c2 *
      (s3 * Lambda_inv_0_0_p28 + Lambda_inv_0_0_p40) - Lambda_inv_0_0_p52;
  const Real Lambda_inv_0_0_p56 = 1.0 / (Lambda_inv_0_0_p35 - Lambda_inv_0_0_p34 *
      Lambda_inv_0_0_p30 - Lambda_inv_0_0_p44 * Lambda_inv_0_0_p38);
  const Real Lambda_inv_0_0_p57 = Lambda_inv_0_0_p52 - c2 *
      (s3 * Lambda_inv_0_0_p41 + Lambda_inv_0_0_p40);
  const Real Lambda_inv_0_0_p58 = Lambda_inv_0_0_p35 - 0.6127 * Lambda_inv_0_0_p32 -
      Lambda_inv_0_0_p34 * Lambda_inv_0_0_p43 - Lambda_inv_0_0_p44 * Lambda_inv_0_0_p49;

  // link 3 (forearm), pose
  const Real Lambda_inv_0_0_p59 = s3 * c2 + c3 * s2;
  const Real Lambda_inv_0_0_p60 = c3 * c2 - s3 * s2;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p61 = Lambda_inv_0_0_p55 + Lambda_inv_0_0_p6 * Lambda_inv_0_0_p51;
  const Real Lambda_inv_0_0_p62 = 1605.1364365971108 * Lambda_inv_0_0_p46;
  const Real Lambda_inv_0_0_p63 = 117.34209310833121 * Lambda_inv_0_0_p51;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_inv_0_0_p64 = 0.11985 * c4;

  // link 3 (forearm), composite inertia
  const Real Lambda_inv_0_0_p65 = s3 * (Lambda_inv_0_0_p48 - Lambda_inv_0_0_p53) + c3 *
      (2.0 * Lambda_inv_0_0_p47);

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p66 = Lambda_inv_0_0_p61 * Lambda_inv_0_0_p29;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_inv_0_0_p67 = 0.11985 * s4 - 0.57155;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p68 = Lambda_inv_0_0_p7 - 1.0;

  // link 3 (forearm), composite inertia
  const Real Lambda_inv_0_0_p69 = s3 * Lambda_inv_0_0_p65;

  // link 4 (wrist_1), pose
  const Real Lambda_inv_0_0_p70 = c4 * Lambda_inv_0_0_p59 + s4 * Lambda_inv_0_0_p60;
  const Real Lambda_inv_0_0_p71 = c4 * Lambda_inv_0_0_p60 - s4 * Lambda_inv_0_0_p59;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p72 = s2 * Lambda_inv_0_0_p50 - Lambda_inv_0_0_p57 -
      Lambda_inv_0_0_p34 * Lambda_inv_0_0_p51 - Lambda_inv_0_0_p44 * Lambda_inv_0_0_p61;
  const Real Lambda_inv_0_0_p73 = (1.0 - Lambda_inv_0_0_p44) * Lambda_inv_0_0_p68;

  // link 5 (wrist_2), pose
  const Real Lambda_inv_0_0_p74 = s5 * Lambda_inv_0_0_p70;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p75 = Lambda_inv_0_0_p58 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_0_p76 = s2 * (1.156008191975 +
      (Lambda_inv_0_0_p50 + 0.055956818775 * c5)) - Lambda_inv_0_0_p57 - Lambda_inv_0_0_p45 *
      Lambda_inv_0_0_p51 - Lambda_inv_0_0_p54 * Lambda_inv_0_0_p61;
  const Real Lambda_inv_0_0_p77 = Lambda_inv_0_0_p72 * Lambda_inv_0_0_p56;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_inv_0_0_p78 = 0.11985 * Lambda_inv_0_0_p71;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p79 = c5 * Lambda_inv_0_0_p74;
  const Real Lambda_inv_5_5_p1 = 1605.1364365971108 * Lambda_inv_0_0_p74;

  // link 3 (forearm), composite inertia
  const Real Lambda_inv_0_0_p80 = 4.37493718615 + (Lambda_inv_0_0_p53 + Lambda_inv_0_0_p69 -
      Lambda_inv_0_0_p36);

  // link 2 (upper_arm), composite inertia
  const Real Lambda_inv_0_0_p81 = 2.0 * (c3 * Lambda_inv_0_0_p65 - Lambda_inv_0_0_p47 + 0.6127 *
      (s3 * Lambda_inv_0_0_p24 - c3 * Lambda_inv_0_0_p19));

  // link 3 (forearm), Jacobian
  const Real Lambda_inv_0_0_p82 = c3 * Lambda_inv_0_0_p67 + s3 * Lambda_inv_0_0_p64 - 0.6127;
  const Real Lambda_inv_0_0_p83 = s3 * Lambda_inv_0_0_p67 - c3 * Lambda_inv_0_0_p64;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p84 = Lambda_inv_0_0_p79 - Lambda_inv_0_0_p6 * Lambda_inv_0_0_p71;
  const Real Lambda_inv_5_5_p2 = 117.34209310833121 * Lambda_inv_0_0_p71;
  const Real Lambda_inv_0_0_p85 = 4.3866871861500005 + Lambda_inv_0_0_p35 - Lambda_inv_0_0_p36 -
      Lambda_inv_0_0_p45 * Lambda_inv_0_0_p43 - Lambda_inv_0_0_p54 * Lambda_inv_0_0_p49 -
      Lambda_inv_0_0_p75 * Lambda_inv_0_0_p58;
  const Real Lambda_inv_0_0_p86 = Lambda_inv_0_0_p76 - Lambda_inv_0_0_p75 * Lambda_inv_0_0_p72;
  const Real Lambda_inv_0_0_p87 = (1.0 - Lambda_inv_0_0_p54) * Lambda_inv_0_0_p68 -
      Lambda_inv_0_0_p75 * Lambda_inv_0_0_p73;

  // link 5 (wrist_2), pose
  const Real Lambda_inv_0_0_p88 = s5 * Lambda_inv_0_0_p71;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p89 = 1.0 / Lambda_inv_0_0_p85;
  const Real Lambda_inv_0_0_p90 = Lambda_inv_0_0_p68 * Lambda_inv_0_0_p29;
  const Real Lambda_inv_0_0_p91 = c5 * Lambda_inv_0_0_p88;
  const Real Lambda_inv_0_0_p92 = 1605.1364365971108 * c5;
  const Real Lambda_inv_0_0_p93 = Lambda_inv_0_0_p84 * Lambda_inv_0_0_p29;
  const Real Lambda_inv_0_0_p94 = Lambda_inv_0_0_p79 + Lambda_inv_0_0_p34 * Lambda_inv_0_0_p71 -
      Lambda_inv_0_0_p44 * Lambda_inv_0_0_p84;
  const Real Lambda_inv_0_0_p95 = Lambda_inv_0_0_p91 + Lambda_inv_0_0_p6 * Lambda_inv_0_0_p70;
  const Real Lambda_inv_0_0_p96 = Lambda_inv_0_0_p73 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_0_p97 = Lambda_inv_0_0_p94 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_0_p98 = Lambda_inv_0_0_p64 * Lambda_inv_0_0_p60 - Lambda_inv_0_0_p67 *
      Lambda_inv_0_0_p59 - Lambda_inv_0_0_p44 * Lambda_inv_0_0_p78;
  const Real Lambda_inv_0_0_p99 = Lambda_inv_0_0_p79 + Lambda_inv_0_0_p45 * Lambda_inv_0_0_p71 -
      Lambda_inv_0_0_p54 * Lambda_inv_0_0_p84 - Lambda_inv_0_0_p75 * Lambda_inv_0_0_p94;
  const Real Lambda_inv_0_0_p100 = 1.0 + Lambda_inv_0_0_p62 * Lambda_inv_0_0_p74 +
      Lambda_inv_0_0_p63 * Lambda_inv_0_0_p71 - Lambda_inv_0_0_p66 * Lambda_inv_0_0_p84 -
      Lambda_inv_0_0_p77 * Lambda_inv_0_0_p94;

  // link 2 (upper_arm), composite inertia
  const Real Lambda_inv_0_0_p101 = Lambda_inv_0_0_p80 + s2 *
      (s2 * (0.01175 + (Lambda_inv_0_0_p48 - Lambda_inv_0_0_p69) - Lambda_inv_0_0_p80) + c2 *
      Lambda_inv_0_0_p81);

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p102 = Lambda_inv_0_0_p95 * Lambda_inv_0_0_p29;
  const Real Lambda_inv_0_0_p103 = Lambda_inv_0_0_p86 * Lambda_inv_0_0_p89;
  const Real Lambda_inv_0_0_p104 = Lambda_inv_0_0_p91 - Lambda_inv_0_0_p34 * Lambda_inv_0_0_p70 -
      Lambda_inv_0_0_p44 * Lambda_inv_0_0_p95;
  const Real Lambda_inv_0_0_p105 = Lambda_inv_0_0_p87 * Lambda_inv_0_0_p89;
  const Real Lambda_inv_0_0_p106 = Lambda_inv_0_0_p99 * Lambda_inv_0_0_p89;
  const Real Lambda_inv_0_0_p107 = Lambda_inv_0_0_p104 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_0_p108 = Lambda_inv_0_0_p91 - Lambda_inv_0_0_p45 * Lambda_inv_0_0_p70 -
      Lambda_inv_0_0_p54 * Lambda_inv_0_0_p95 - Lambda_inv_0_0_p75 * Lambda_inv_0_0_p104;
  const Real Lambda_inv_0_0_p109 = Lambda_inv_0_0_p62 * c5 - Lambda_inv_0_0_p66 *
      Lambda_inv_0_0_p68 - Lambda_inv_0_0_p77 * Lambda_inv_0_0_p73 - Lambda_inv_0_0_p103 *
      Lambda_inv_0_0_p87;
  const Real Lambda_inv_0_0_p110 = Lambda_inv_0_0_p100 - Lambda_inv_0_0_p103 * Lambda_inv_0_0_p99;
  const Real Lambda_inv_0_0_p111 = Lambda_inv_0_0_p108 * Lambda_inv_0_0_p89;
  const Real Lambda_inv_0_0_p112 = Lambda_inv_0_0_p82 * s2 + Lambda_inv_0_0_p83 * c2 +
      Lambda_inv_0_0_p54 * Lambda_inv_0_0_p78 + Lambda_inv_0_0_p75 * Lambda_inv_0_0_p98;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_inv_0_2_p1 = 0.11985 * Lambda_inv_0_0_p70;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p113 = 0.5353459446375001 + Lambda_inv_0_0_p101 - Lambda_inv_0_0_p62 *
      Lambda_inv_0_0_p46 - Lambda_inv_0_0_p63 * Lambda_inv_0_0_p51 - Lambda_inv_0_0_p66 *
      Lambda_inv_0_0_p61 - Lambda_inv_0_0_p77 * Lambda_inv_0_0_p72;
  const Real Lambda_inv_0_0_p114 = Lambda_inv_0_0_p62 * Lambda_inv_0_0_p88 - Lambda_inv_0_0_p63 *
      Lambda_inv_0_0_p70 - Lambda_inv_0_0_p66 * Lambda_inv_0_0_p95 - Lambda_inv_0_0_p77 *
      Lambda_inv_0_0_p104 - Lambda_inv_0_0_p103 * Lambda_inv_0_0_p108;
  const Real Lambda_inv_0_0_p115 = 1605.1364365971108 * Lambda_inv_0_0_p88 * Lambda_inv_0_0_p88 +
      117.34209310833121 * Lambda_inv_0_0_p70 * Lambda_inv_0_0_p70 + Lambda_inv_0_0_p102 *
      Lambda_inv_0_0_p95 + Lambda_inv_0_0_p107 * Lambda_inv_0_0_p104;
  const Real Lambda_inv_5_5_p3 = Lambda_inv_5_5_p1 * Lambda_inv_0_0_p74 + Lambda_inv_5_5_p2 *
      Lambda_inv_0_0_p71 + Lambda_inv_0_0_p93 * Lambda_inv_0_0_p84 + Lambda_inv_0_0_p97 *
      Lambda_inv_0_0_p94 + Lambda_inv_0_0_p106 * Lambda_inv_0_0_p99;
  const Real Lambda_inv_0_0_p116 = Lambda_inv_5_5_p1 * Lambda_inv_0_0_p88 - Lambda_inv_5_5_p2 *
      Lambda_inv_0_0_p70 + Lambda_inv_0_0_p93 * Lambda_inv_0_0_p95 + Lambda_inv_0_0_p97 *
      Lambda_inv_0_0_p104 + Lambda_inv_0_0_p106 * Lambda_inv_0_0_p108;
  const Real Lambda_inv_0_0_p117 = 0.11655 * Lambda_inv_0_0_p74;
  const Real Lambda_inv_0_0_p118 = 1.0 / (Lambda_inv_0_0_p113 - Lambda_inv_0_0_p103 *
      Lambda_inv_0_0_p86);
  const Real Lambda_inv_0_0_p119 = 0.11655 * c5;
  const Real Lambda_inv_0_0_p120 = 0.11655 * Lambda_inv_0_0_p88;
  const Real Lambda_inv_0_2_p2 = Lambda_inv_0_0_p67 * Lambda_inv_0_0_p60 + Lambda_inv_0_0_p64 *
      Lambda_inv_0_0_p59 - Lambda_inv_0_0_p44 * Lambda_inv_0_2_p1;
  const Real Lambda_inv_0_0_p121 = 0.17415 - Lambda_inv_0_0_p66 * Lambda_inv_0_0_p78 -
      Lambda_inv_0_0_p77 * Lambda_inv_0_0_p98 + Lambda_inv_0_0_p103 * Lambda_inv_0_0_p112;

  // link 2 (upper_arm), Jacobian
  const Real Lambda_inv_0_2_p3 = c2 * Lambda_inv_0_0_p82 - s2 * Lambda_inv_0_0_p83;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_2_p4 = Lambda_inv_0_2_p2 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_2_p5 = Lambda_inv_0_2_p1 * Lambda_inv_0_0_p29;
  const Real Lambda_inv_0_2_p6 = Lambda_inv_0_2_p3 - Lambda_inv_0_0_p54 * Lambda_inv_0_2_p1 -
      Lambda_inv_0_0_p75 * Lambda_inv_0_2_p2;

  // link 1 (shoulder), turn
  const Real Lambda_inv_3_3_p1 = 2.0 * c1;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_2_p7 = Lambda_inv_0_2_p6 * Lambda_inv_0_0_p89;
  const Real Lambda_inv_0_0_p122 = Lambda_inv_0_0_p109 * Lambda_inv_0_0_p118;
  const Real Lambda_inv_0_0_p123 = Lambda_inv_0_0_p110 * Lambda_inv_0_0_p118;
  const Real Lambda_inv_0_0_p124 = Lambda_inv_0_0_p114 * Lambda_inv_0_0_p118;
  const Real Lambda_inv_0_0_p125 = Lambda_inv_0_2_p3 * Lambda_inv_0_0_p118;
  const Real Lambda_inv_0_2_p8 = Lambda_inv_0_0_p66 * Lambda_inv_0_2_p1 + Lambda_inv_0_0_p77 *
      Lambda_inv_0_2_p2 + Lambda_inv_0_0_p103 * Lambda_inv_0_2_p6;
  const Real Lambda_inv_0_0_p126 = Lambda_inv_0_0_p78 * Lambda_inv_0_0_p29 * Lambda_inv_0_0_p78 +
      Lambda_inv_0_0_p98 * Lambda_inv_0_0_p56 * Lambda_inv_0_0_p98 + Lambda_inv_0_0_p112 *
      Lambda_inv_0_0_p89 * Lambda_inv_0_0_p112;
  const Real Lambda_inv_0_0_p127 = Lambda_inv_0_0_p123 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_0_p128 = Lambda_inv_0_0_p124 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_2_p9 = Lambda_inv_0_0_p122 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_2_p10 = Lambda_inv_0_2_p8 * Lambda_inv_0_0_p118;
  const Real Lambda_inv_0_0_p129 = Lambda_inv_0_0_p92 * c5 + Lambda_inv_0_0_p90 *
      Lambda_inv_0_0_p68 + Lambda_inv_0_0_p96 * Lambda_inv_0_0_p73 + Lambda_inv_0_0_p105 *
      Lambda_inv_0_0_p87 + Lambda_inv_0_0_p122 * Lambda_inv_0_0_p109;
  const Real Lambda_inv_0_0_p130 = Lambda_inv_5_5_p1 * c5 + Lambda_inv_0_0_p93 *
      Lambda_inv_0_0_p68 + Lambda_inv_0_0_p97 * Lambda_inv_0_0_p73 + Lambda_inv_0_0_p106 *
      Lambda_inv_0_0_p87 + Lambda_inv_0_0_p123 * Lambda_inv_0_0_p109;
  const Real Lambda_inv_5_5 = Lambda_inv_5_5_p3 + Lambda_inv_0_0_p123 * Lambda_inv_0_0_p110;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real Lambda_inv_0_0_p131 = Lambda_inv_0_0_p116 + Lambda_inv_0_0_p123 * Lambda_inv_0_0_p114;
  const Real Lambda_inv_0_0_p132 = Lambda_inv_0_0_p115 + Lambda_inv_0_0_p111 * Lambda_inv_0_0_p108 +
      Lambda_inv_0_0_p124 * Lambda_inv_0_0_p114;
  const Real Lambda_inv_0_0_p133 = Lambda_inv_0_0_p92 * Lambda_inv_0_0_p88 + Lambda_inv_0_0_p90 *
      Lambda_inv_0_0_p95 + Lambda_inv_0_0_p96 * Lambda_inv_0_0_p104 + Lambda_inv_0_0_p105 *
      Lambda_inv_0_0_p108 + Lambda_inv_0_0_p122 * Lambda_inv_0_0_p114;
  const Real Lambda_inv_0_0_p134 = Lambda_inv_0_0_p90 * Lambda_inv_0_0_p78 + Lambda_inv_0_0_p96 *
      Lambda_inv_0_0_p98 - Lambda_inv_0_0_p105 * Lambda_inv_0_0_p112 + Lambda_inv_0_0_p122 *
      Lambda_inv_0_0_p121;
  const Real Lambda_inv_0_0_p135 = Lambda_inv_0_0_p93 * Lambda_inv_0_0_p78 + Lambda_inv_0_0_p97 *
      Lambda_inv_0_0_p98 - Lambda_inv_0_0_p106 * Lambda_inv_0_0_p112 + Lambda_inv_0_0_p123 *
      Lambda_inv_0_0_p121;
  const Real Lambda_inv_0_0_p136 = Lambda_inv_0_0_p133 * Lambda_inv_0_0_p117;
  const Real Lambda_inv_0_0_p137 = Lambda_inv_0_0_p131 * Lambda_inv_0_0_p119;
  const Real Lambda_inv_0_2_p11 = Lambda_inv_0_0_p130 * Lambda_inv_0_0_p120;
  const Real Lambda_inv_0_2_p12 = Lambda_inv_0_0_p90 * Lambda_inv_0_2_p1 + Lambda_inv_0_0_p96 *
      Lambda_inv_0_2_p2 + Lambda_inv_0_0_p105 * Lambda_inv_0_2_p6 - Lambda_inv_0_0_p122 *
      Lambda_inv_0_2_p8;
  const Real Lambda_inv_0_2_p13 = Lambda_inv_0_0_p102 * Lambda_inv_0_2_p1 + Lambda_inv_0_0_p107 *
      Lambda_inv_0_2_p2 + Lambda_inv_0_0_p111 * Lambda_inv_0_2_p6 - Lambda_inv_0_0_p124 *
      Lambda_inv_0_2_p8;
  const Real Lambda_inv_0_0_p138 = Lambda_inv_0_0_p134 -
      (Lambda_inv_0_0_p129 * Lambda_inv_0_0_p117 - Lambda_inv_0_0_p130 * Lambda_inv_0_0_p119);
  const Real Lambda_inv_0_0_p139 = Lambda_inv_0_0_p135 -
      (Lambda_inv_0_0_p130 * Lambda_inv_0_0_p117 - Lambda_inv_5_5 * Lambda_inv_0_0_p119);
  const Real Lambda_inv_0_0_p140 = Lambda_inv_0_0_p127 -
      (Lambda_inv_5_5 * Lambda_inv_0_0_p120 - Lambda_inv_0_0_p131 * Lambda_inv_0_0_p117);
  const Real Lambda_inv_0_0_p141 = Lambda_inv_0_0_p128 -
      (Lambda_inv_0_0_p131 * Lambda_inv_0_0_p120 - Lambda_inv_0_0_p132 * Lambda_inv_0_0_p117);
  const Real Lambda_inv_0_2_p14 = Lambda_inv_0_0_p93 * Lambda_inv_0_2_p1 + Lambda_inv_0_0_p97 *
      Lambda_inv_0_2_p2 + Lambda_inv_0_0_p106 * Lambda_inv_0_2_p6 - Lambda_inv_0_0_p123 *
      Lambda_inv_0_2_p8;
  const Real Lambda_inv_0_0_p142 = Lambda_inv_0_0_p102 * Lambda_inv_0_0_p78 + Lambda_inv_0_0_p107 *
      Lambda_inv_0_0_p98 - Lambda_inv_0_0_p111 * Lambda_inv_0_0_p112 + Lambda_inv_0_0_p124 *
      Lambda_inv_0_0_p121 - (Lambda_inv_0_0_p136 - Lambda_inv_0_0_p137);
  const Real Lambda_inv_0_2_p15 = Lambda_inv_0_2_p9 - (Lambda_inv_0_2_p11 - Lambda_inv_0_0_p136);
  const Real Lambda_inv_0_2_p16 = Lambda_inv_0_2_p5 * Lambda_inv_0_0_p78 + Lambda_inv_0_2_p4 *
      Lambda_inv_0_0_p98 - Lambda_inv_0_2_p7 * Lambda_inv_0_0_p112 - Lambda_inv_0_2_p10 *
      Lambda_inv_0_0_p121 - Lambda_inv_0_0_p117 * Lambda_inv_0_2_p12;
  const Real Lambda_inv_2_2_p1 = Lambda_inv_0_2_p13 -
      (Lambda_inv_0_0_p132 * Lambda_inv_0_0_p119 - Lambda_inv_0_0_p133 * Lambda_inv_0_0_p120);
  const Real Lambda_inv_2_2_p2 = Lambda_inv_0_2_p12 -
      (Lambda_inv_0_0_p133 * Lambda_inv_0_0_p119 - Lambda_inv_0_0_p129 * Lambda_inv_0_0_p120);
  const Real Lambda_inv_0_0_p143 = Lambda_inv_0_0_p125 * Lambda_inv_0_0_p121 + Lambda_inv_0_0_p119 *
      Lambda_inv_0_0_p127 - Lambda_inv_0_0_p120 * Lambda_inv_0_0_p139 +
      (Lambda_inv_0_0_p142 - Lambda_inv_0_2_p9) * Lambda_inv_0_0_p117;
  const Real Lambda_inv_0_0_p144 = Lambda_inv_0_0_p126 + Lambda_inv_0_0_p121 * Lambda_inv_0_0_p118 *
      Lambda_inv_0_0_p121 - (Lambda_inv_0_0_p117 * (Lambda_inv_0_0_p134 + Lambda_inv_0_0_p138) -
      Lambda_inv_0_0_p119 * (Lambda_inv_0_0_p135 + Lambda_inv_0_0_p139));
  const Real Lambda_inv_0_0_p145 = Lambda_inv_0_0_p125 * Lambda_inv_0_2_p3 -
      (Lambda_inv_0_0_p120 * (Lambda_inv_0_0_p127 + Lambda_inv_0_0_p140) - Lambda_inv_0_0_p117 *
      (Lambda_inv_0_0_p128 + Lambda_inv_0_0_p141));
  const Real Lambda_inv_0_2_p17 = Lambda_inv_0_2_p16 + Lambda_inv_0_0_p120 * Lambda_inv_0_0_p138 +
      (Lambda_inv_0_2_p14 - Lambda_inv_0_0_p142) * Lambda_inv_0_0_p119;

  // link 1 (shoulder), turn
  const Real Lambda_inv_0_3_p1 = s1 * (Lambda_inv_0_0_p142 - Lambda_inv_0_2_p15) + c1 *
      (Lambda_inv_0_0_p141 + Lambda_inv_0_0_p138);

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_2_p18 = Lambda_inv_0_2_p10 * Lambda_inv_0_2_p3 - Lambda_inv_0_0_p117 *
      Lambda_inv_0_2_p13 + Lambda_inv_0_0_p119 * Lambda_inv_0_0_p141 +
      (Lambda_inv_0_2_p14 - Lambda_inv_0_2_p15) * Lambda_inv_0_0_p120;

  // link 1 (shoulder), turn
  const Real Lambda_inv_3_3_p2 = s1 * (Lambda_inv_0_0_p132 - Lambda_inv_0_0_p129) +
      Lambda_inv_3_3_p1 * Lambda_inv_0_0_p133;
  const Real Lambda_inv_0_3_p2 = s1 * Lambda_inv_0_3_p1;
  const Real Lambda_inv_0_4_p1 = c1 * Lambda_inv_0_3_p1;
  const Real Lambda_inv_3_3_p3 = s1 * Lambda_inv_3_3_p2;
  const Real Lambda_inv_0_2 = c1 * Lambda_inv_0_2_p17 + s1 * Lambda_inv_0_2_p18;
  Lambda_inv[2] = Lambda_inv_0_2;
  Lambda_inv[12] = Lambda_inv_0_2;
  const Real Lambda_inv_0_3 = Lambda_inv_0_0_p142 - Lambda_inv_0_3_p2;
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;
  const Real Lambda_inv_0_4 = Lambda_inv_0_4_p1 - Lambda_inv_0_0_p141;
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[24] = Lambda_inv_0_4;
  const Real Lambda_inv_0_5 = c1 * Lambda_inv_0_0_p139 - s1 * Lambda_inv_0_0_p140;
  Lambda_inv[5] = Lambda_inv_0_5;
  Lambda_inv[30] = Lambda_inv_0_5;
  const Real Lambda_inv_1_2 = s1 * Lambda_inv_0_2_p17 - c1 * Lambda_inv_0_2_p18;
  Lambda_inv[8] = Lambda_inv_1_2;
  Lambda_inv[13] = Lambda_inv_1_2;
  const Real Lambda_inv_1_3 = Lambda_inv_0_4_p1 - Lambda_inv_0_0_p138;
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  const Real Lambda_inv_0_0_p146 = s1 * (Lambda_inv_0_0_p144 - Lambda_inv_0_0_p145) +
      Lambda_inv_3_3_p1 * Lambda_inv_0_0_p143;
  const Real Lambda_inv_1_4 = Lambda_inv_0_2_p15 + Lambda_inv_0_3_p2;
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_1_5 = s1 * Lambda_inv_0_0_p139 + c1 * Lambda_inv_0_0_p140;
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real Lambda_inv_2_3 = c1 * Lambda_inv_2_2_p1 - s1 * Lambda_inv_2_2_p2;
  Lambda_inv[15] = Lambda_inv_2_3;
  Lambda_inv[20] = Lambda_inv_2_3;

  // link 1 (shoulder), mass matrix
  Lambda_inv[14] = Lambda_inv_0_2_p5 * Lambda_inv_0_2_p1 + Lambda_inv_0_2_p4 * Lambda_inv_0_2_p2 +
      Lambda_inv_0_2_p7 * Lambda_inv_0_2_p6 + Lambda_inv_0_2_p10 * Lambda_inv_0_2_p8 -
      (Lambda_inv_0_0_p119 * (Lambda_inv_0_2_p13 + Lambda_inv_2_2_p1) - Lambda_inv_0_0_p120 *
      (Lambda_inv_0_2_p12 + Lambda_inv_2_2_p2));

  // link 1 (shoulder), turn
  const Real Lambda_inv_2_4 = s1 * Lambda_inv_2_2_p1 + c1 * Lambda_inv_2_2_p2;
  Lambda_inv[16] = Lambda_inv_2_4;
  Lambda_inv[26] = Lambda_inv_2_4;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_2_5 = Lambda_inv_0_2_p14 - (Lambda_inv_0_0_p137 - Lambda_inv_0_2_p11);
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;

  // link 1 (shoulder), turn
  Lambda_inv[21] = Lambda_inv_0_0_p132 - Lambda_inv_3_3_p3;
  const Real Lambda_inv_3_4 = c1 * Lambda_inv_3_3_p2 - Lambda_inv_0_0_p133;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;
  const Real Lambda_inv_3_5 = c1 * Lambda_inv_0_0_p131 - s1 * Lambda_inv_0_0_p130;
  Lambda_inv[23] = Lambda_inv_3_5;
  Lambda_inv[33] = Lambda_inv_3_5;
  Lambda_inv[28] = Lambda_inv_0_0_p129 + Lambda_inv_3_3_p3;
  const Real Lambda_inv_4_5 = s1 * Lambda_inv_0_0_p131 + c1 * Lambda_inv_0_0_p130;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
  const Real Lambda_inv_0_0_p147 = s1 * Lambda_inv_0_0_p146;
  Lambda_inv[0] = Lambda_inv_0_0_p144 - Lambda_inv_0_0_p147;
  const Real Lambda_inv_0_1 = c1 * Lambda_inv_0_0_p146 - Lambda_inv_0_0_p143;
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;
  Lambda_inv[7] = Lambda_inv_0_0_p145 + Lambda_inv_0_0_p147;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
