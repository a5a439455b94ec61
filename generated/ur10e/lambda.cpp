// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J carried inward, in the axes of link 1 (shoulder) at link origins.
// 838 flops (add 357, mul 471, div 10), sine and cosine of 5 angles
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
void lambda(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
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
  const Real Lambda_5_5_p1 = 0.0054190910375000005 * s5;
  const Real Lambda_5_5_p2 = 0.031809629475 * c5;
  const Real Lambda_5_5_p3 = 0.09132825 * s5;
  const Real Lambda_5_5_p4 = 0.0106962107625 * c5;
  const Real Lambda_5_5_p5 = 0.0106962107625 * s5;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p6 = 1.2551157591996094 * c5;
  const Real Lambda_5_5_p7 = c5 * c5;

  // link 6 (wrist_3), mass matrix
  const Real Lambda_5_5_p8 = 0.000623 * s5;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p9 = s5 * Lambda_5_5_p1;
  const Real Lambda_5_5_p10 = 0.0098370910375 + Lambda_5_5_p2;
  const Real Lambda_5_5_p11 = 0.0585962731125 + Lambda_5_5_p4;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p12 = 0.000623 * Lambda_5_5_p7;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p13 = 0.09132825 * c5;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p14 = 0.0085220910375 + 0.0159048147375 * c5;

  // link 6 (wrist_3), mass matrix
  const Real Lambda_5_5_p15 = s4 * Lambda_5_5_p8;
  const Real Lambda_5_5_p16 = c4 * Lambda_5_5_p8;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p17 = 0.041592816387499995 + Lambda_5_5_p9;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p18 = 0.33495075 * s4 - c4 * Lambda_5_5_p3;

  // link 4 (wrist_1), mass matrix
  const Real Lambda_5_5_p19 = 0.33495075 * c4 + s4 * Lambda_5_5_p3;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p20 = c5 * Lambda_5_5_p1 + 0.0159048147375 * s5;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p21 = s4 * Lambda_5_5_p13;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p22 = 1.1431 * Lambda_5_5_p18;

  // link 4 (wrist_1), mass matrix
  const Real Lambda_5_5_p23 = s3 * Lambda_5_5_p19;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p24 = Lambda_5_5_p18 - 4.0059802;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p25 = c4 * Lambda_5_5_p5 + s4 * Lambda_5_5_p14;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p26 = 0.0384148163875 + (0.007282091037500001 - Lambda_5_5_p9 +
      Lambda_5_5_p2);

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p27 = s4 * Lambda_5_5_p5 - c4 * Lambda_5_5_p14 - 0.0521986612875 * s5;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p28 = c4 * Lambda_5_5_p20 - s4 * Lambda_5_5_p11;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p29 = 1.0 / (Lambda_5_5_p17 - Lambda_5_5_p12 - Lambda_5_5_p6 *
      Lambda_5_5_p4);

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p30 = 0.57155 * Lambda_5_5_p21 - Lambda_5_5_p4;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p31 = Lambda_5_5_p17 - 0.57155 * Lambda_5_5_p18 - Lambda_5_5_p12;

  // link 3 (forearm), mass matrix
  const Real Lambda_5_5_p32 = Lambda_5_5_p23 + c3 * Lambda_5_5_p24;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p33 = s4 * Lambda_5_5_p20 + c4 * Lambda_5_5_p11;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p34 = 117.34209310833121 * Lambda_5_5_p30;
  const Real Lambda_5_5_p35 = 2.08330527531 + (Lambda_5_5_p17 - Lambda_5_5_p22) - Lambda_5_5_p12;

  // link 3 (forearm), composite inertia
  const Real Lambda_5_5_p36 = 1.2254 * Lambda_5_5_p32;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p37 = s4 * (Lambda_5_5_p26 - Lambda_5_5_p10) - c4 * (0.021392421525 * s5);

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p38 = Lambda_5_5_p31 + Lambda_5_5_p6 * Lambda_5_5_p30;

  // link 3 (forearm), composite inertia
  const Real Lambda_5_5_p39 = s3 * Lambda_5_5_p33;
  const Real Lambda_5_5_p40 = c3 * Lambda_5_5_p33;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p41 = 0.5656542411875001 + (Lambda_5_5_p28 + 0.0521986612875 * c5);
  const Real Lambda_5_5_p42 = s4 * Lambda_5_5_p37;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p43 = Lambda_5_5_p30 + 0.6127 *
      (s3 * (c4 * Lambda_5_5_p13) + c3 * Lambda_5_5_p21);

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p44 = Lambda_5_5_p38 * Lambda_5_5_p29;
  const Real Lambda_5_5_p45 = 117.34209310833121 * Lambda_5_5_p43;

  // link 6 (wrist_3), mass matrix
  const Real Lambda_5_5_p46 = s2 * (s3 * Lambda_5_5_p15 - c3 * Lambda_5_5_p16) - c2 *
      (s3 * Lambda_5_5_p16 + c3 * Lambda_5_5_p15);

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p47 = c4 * Lambda_5_5_p37 + Lambda_5_5_p5 - 0.57155 * Lambda_5_5_p19;
  const Real Lambda_5_5_p48 = 0.002495 + (Lambda_5_5_p26 - Lambda_5_5_p42);

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p49 = Lambda_5_5_p31 - 0.6127 * (Lambda_5_5_p23 + c3 * Lambda_5_5_p18) +
      Lambda_5_5_p6 * Lambda_5_5_p43;

  // link 3 (forearm), composite inertia
  const Real Lambda_5_5_p50 = c3 * Lambda_5_5_p41 - Lambda_5_5_p39;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p51 = s2 * (c3 * Lambda_5_5_p25 - s3 * Lambda_5_5_p27) + c2 *
      (s3 * Lambda_5_5_p25 + c3 * Lambda_5_5_p27 - 0.055956818775 * s5);

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p52 = c5 * Lambda_5_5_p46;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p53 = 2.08081027531 + (Lambda_5_5_p10 + Lambda_5_5_p42 - Lambda_5_5_p22);

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p54 = Lambda_5_5_p49 * Lambda_5_5_p29;
  const Real Lambda_5_5_p55 = s2 * (c3 * Lambda_5_5_p28 - Lambda_5_5_p39) + c2 *
      (s3 * Lambda_5_5_p28 + Lambda_5_5_p40) - Lambda_5_5_p52;
  const Real Lambda_5_5_p56 = 1.0 / (Lambda_5_5_p35 - Lambda_5_5_p34 * Lambda_5_5_p30 -
      Lambda_5_5_p44 * Lambda_5_5_p38);
  const Real Lambda_5_5_p57 = Lambda_5_5_p52 - c2 * (s3 * Lambda_5_5_p41 + Lambda_5_5_p40);
  const Real Lambda_5_5_p58 = Lambda_5_5_p35 - 0.6127 * Lambda_5_5_p32 - Lambda_5_5_p34 *
      Lambda_5_5_p43 - Lambda_5_5_p44 * Lambda_5_5_p49;

  // link 3 (forearm), pose
  const Real Lambda_5_5_p59 = s3 * c2 + c3 * s2;
  const Real Lambda_5_5_p60 = c3 * c2 - s3 * s2;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p61 = Lambda_5_5_p55 + Lambda_5_5_p6 * Lambda_5_5_p51;
  const Real Lambda_5_5_p62 = 1605.1364365971108 * Lambda_5_5_p46;
  const Real Lambda_5_5_p63 = 117.34209310833121 * Lambda_5_5_p51;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_5_5_p64 = 0.11985 * c4;

  // link 3 (forearm), composite inertia
  const Real Lambda_5_5_p65 = s3 * (Lambda_5_5_p48 - Lambda_5_5_p53) + c3 * (2.0 * Lambda_5_5_p47);

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p66 = Lambda_5_5_p61 * Lambda_5_5_p29;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_5_5_p67 = 0.11985 * s4 - 0.57155;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p68 = Lambda_5_5_p7 - 1.0;

  // link 3 (forearm), composite inertia
  const Real Lambda_5_5_p69 = s3 * Lambda_5_5_p65;

  // link 4 (wrist_1), pose
  const Real Lambda_5_5_p70 = c4 * Lambda_5_5_p59 + s4 * Lambda_5_5_p60;
  const Real Lambda_5_5_p71 = c4 * Lambda_5_5_p60 - s4 * Lambda_5_5_p59;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p72 = s2 * Lambda_5_5_p50 - Lambda_5_5_p57 - Lambda_5_5_p34 *
      Lambda_5_5_p51 - Lambda_5_5_p44 * Lambda_5_5_p61;
  const Real Lambda_5_5_p73 = (1.0 - Lambda_5_5_p44) * Lambda_5_5_p68;

  // link 5 (wrist_2), pose
  const Real Lambda_5_5_p74 = s5 * Lambda_5_5_p70;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p75 = Lambda_5_5_p58 * Lambda_5_5_p56;
  const Real Lambda_5_5_p76 = s2 * (1.156008191975 + (Lambda_5_5_p50 + 0.055956818775 * c5)) -
      Lambda_5_5_p57 - Lambda_5_5_p45 * Lambda_5_5_p51 - Lambda_5_5_p54 * Lambda_5_5_p61;
  const Real Lambda_5_5_p77 = Lambda_5_5_p72 * Lambda_5_5_p56;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_5_5_p78 = 0.11985 * Lambda_5_5_p71;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p79 = c5 * Lambda_5_5_p74;
  const Real Lambda_5_5_p80 = 1605.1364365971108 * Lambda_5_5_p74;

  // link 3 (forearm), composite inertia
  const Real Lambda_5_5_p81 = 4.37493718615 + (Lambda_5_5_p53 + Lambda_5_5_p69 - Lambda_5_5_p36);

  // link 2 (upper_arm), composite inertia
  const Real Lambda_5_5_p82 = 2.0 * (c3 * Lambda_5_5_p65 - Lambda_5_5_p47 + 0.6127 *
      (s3 * Lambda_5_5_p24 - c3 * Lambda_5_5_p19));

  // link 3 (forearm), Jacobian
  const Real Lambda_5_5_p83 = c3 * Lambda_5_5_p67 + s3 * Lambda_5_5_p64 - 0.6127;
  const Real Lambda_5_5_p84 = s3 * Lambda_5_5_p67 - c3 * Lambda_5_5_p64;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p85 = Lambda_5_5_p79 - Lambda_5_5_p6 * Lambda_5_5_p71;
  const Real Lambda_5_5_p86 = 117.34209310833121 * Lambda_5_5_p71;
  const Real Lambda_5_5_p87 = 4.3866871861500005 + Lambda_5_5_p35 - Lambda_5_5_p36 -
      Lambda_5_5_p45 * Lambda_5_5_p43 - Lambda_5_5_p54 * Lambda_5_5_p49 - Lambda_5_5_p75 *
      Lambda_5_5_p58;
  const Real Lambda_5_5_p88 = Lambda_5_5_p76 - Lambda_5_5_p75 * Lambda_5_5_p72;
  const Real Lambda_5_5_p89 = (1.0 - Lambda_5_5_p54) * Lambda_5_5_p68 - Lambda_5_5_p75 *
      Lambda_5_5_p73;

  // link 5 (wrist_2), pose
  const Real Lambda_5_5_p90 = s5 * Lambda_5_5_p71;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p91 = 1.0 / Lambda_5_5_p87;
  const Real Lambda_5_5_p92 = Lambda_5_5_p68 * Lambda_5_5_p29;
  const Real Lambda_5_5_p93 = c5 * Lambda_5_5_p90;
  const Real Lambda_5_5_p94 = 1605.1364365971108 * c5;
  const Real Lambda_5_5_p95 = Lambda_5_5_p85 * Lambda_5_5_p29;
  const Real Lambda_5_5_p96 = Lambda_5_5_p79 + Lambda_5_5_p34 * Lambda_5_5_p71 - Lambda_5_5_p44 *
      Lambda_5_5_p85;
  const Real Lambda_5_5_p97 = Lambda_5_5_p93 + Lambda_5_5_p6 * Lambda_5_5_p70;
  const Real Lambda_5_5_p98 = Lambda_5_5_p73 * Lambda_5_5_p56;
  const Real Lambda_5_5_p99 = Lambda_5_5_p96 * Lambda_5_5_p56;
  const Real Lambda_5_5_p100 = Lambda_5_5_p64 * Lambda_5_5_p60 - Lambda_5_5_p67 * Lambda_5_5_p59 -
      Lambda_5_5_p44 * Lambda_5_5_p78;
  const Real Lambda_5_5_p101 = Lambda_5_5_p79 + Lambda_5_5_p45 * Lambda_5_5_p71 - Lambda_5_5_p54 *
      Lambda_5_5_p85 - Lambda_5_5_p75 * Lambda_5_5_p96;
  const Real Lambda_5_5_p102 = 1.0 + Lambda_5_5_p62 * Lambda_5_5_p74 + Lambda_5_5_p63 *
      Lambda_5_5_p71 - Lambda_5_5_p66 * Lambda_5_5_p85 - Lambda_5_5_p77 * Lambda_5_5_p96;

  // link 2 (upper_arm), composite inertia
  const Real Lambda_5_5_p103 = Lambda_5_5_p81 + s2 *
      (s2 * (0.01175 + (Lambda_5_5_p48 - Lambda_5_5_p69) - Lambda_5_5_p81) + c2 * Lambda_5_5_p82);

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p104 = Lambda_5_5_p97 * Lambda_5_5_p29;
  const Real Lambda_5_5_p105 = Lambda_5_5_p88 * Lambda_5_5_p91;
  const Real Lambda_5_5_p106 = Lambda_5_5_p93 - Lambda_5_5_p34 * Lambda_5_5_p70 - Lambda_5_5_p44 *
      Lambda_5_5_p97;
  const Real Lambda_5_5_p107 = Lambda_5_5_p89 * Lambda_5_5_p91;
  const Real Lambda_5_5_p108 = Lambda_5_5_p101 * Lambda_5_5_p91;
  const Real Lambda_5_5_p109 = Lambda_5_5_p106 * Lambda_5_5_p56;
  const Real Lambda_5_5_p110 = Lambda_5_5_p93 - Lambda_5_5_p45 * Lambda_5_5_p70 - Lambda_5_5_p54 *
      Lambda_5_5_p97 - Lambda_5_5_p75 * Lambda_5_5_p106;
  const Real Lambda_5_5_p111 = Lambda_5_5_p62 * c5 - Lambda_5_5_p66 * Lambda_5_5_p68 -
      Lambda_5_5_p77 * Lambda_5_5_p73 - Lambda_5_5_p105 * Lambda_5_5_p89;
  const Real Lambda_5_5_p112 = Lambda_5_5_p102 - Lambda_5_5_p105 * Lambda_5_5_p101;
  const Real Lambda_5_5_p113 = Lambda_5_5_p110 * Lambda_5_5_p91;
  const Real Lambda_5_5_p114 = Lambda_5_5_p83 * s2 + Lambda_5_5_p84 * c2 + Lambda_5_5_p54 *
      Lambda_5_5_p78 + Lambda_5_5_p75 * Lambda_5_5_p100;
  const Real Lambda_5_5_p115 = 1605.1364365971108 * Lambda_5_5_p90 * Lambda_5_5_p90 +
      117.34209310833121 * Lambda_5_5_p70 * Lambda_5_5_p70 + Lambda_5_5_p104 * Lambda_5_5_p97 +
      Lambda_5_5_p109 * Lambda_5_5_p106;
  const Real Lambda_5_5_p116 = 0.5353459446375001 + Lambda_5_5_p103 - Lambda_5_5_p62 *
      Lambda_5_5_p46 - Lambda_5_5_p63 * Lambda_5_5_p51 - Lambda_5_5_p66 * Lambda_5_5_p61 -
      Lambda_5_5_p77 * Lambda_5_5_p72;
  const Real Lambda_5_5_p117 = Lambda_5_5_p62 * Lambda_5_5_p90 - Lambda_5_5_p63 * Lambda_5_5_p70 -
      Lambda_5_5_p66 * Lambda_5_5_p97 - Lambda_5_5_p77 * Lambda_5_5_p106 - Lambda_5_5_p105 *
      Lambda_5_5_p110;
  const Real Lambda_5_5_p118 = Lambda_5_5_p80 * Lambda_5_5_p74 + Lambda_5_5_p86 * Lambda_5_5_p71 +
      Lambda_5_5_p95 * Lambda_5_5_p85 + Lambda_5_5_p99 * Lambda_5_5_p96 + Lambda_5_5_p108 *
      Lambda_5_5_p101;
  const Real Lambda_5_5_p119 = Lambda_5_5_p80 * Lambda_5_5_p90 - Lambda_5_5_p86 * Lambda_5_5_p70 +
      Lambda_5_5_p95 * Lambda_5_5_p97 + Lambda_5_5_p99 * Lambda_5_5_p106 + Lambda_5_5_p108 *
      Lambda_5_5_p110;
  const Real Lambda_5_5_p120 = 0.11655 * Lambda_5_5_p74;
  const Real Lambda_5_5_p121 = 0.11655 * c5;
  const Real Lambda_5_5_p122 = 0.11655 * Lambda_5_5_p90;
  const Real Lambda_5_5_p123 = 0.17415 - Lambda_5_5_p66 * Lambda_5_5_p78 - Lambda_5_5_p77 *
      Lambda_5_5_p100 + Lambda_5_5_p105 * Lambda_5_5_p114;
  const Real Lambda_5_5_p124 = 1.0 / (Lambda_5_5_p116 - Lambda_5_5_p105 * Lambda_5_5_p88);

  // link 4 (wrist_1), Jacobian
  const Real Lambda_5_5_p125 = 0.11985 * Lambda_5_5_p70;

  // link 2 (upper_arm), Jacobian
  const Real Lambda_5_5_p126 = c2 * Lambda_5_5_p83 - s2 * Lambda_5_5_p84;

  // link 1 (shoulder), turn
  const Real Lambda_5_5_p127 = 2.0 * c1;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p128 = Lambda_5_5_p125 * Lambda_5_5_p29;
  const Real Lambda_5_5_p129 = Lambda_5_5_p67 * Lambda_5_5_p60 + Lambda_5_5_p64 * Lambda_5_5_p59 -
      Lambda_5_5_p44 * Lambda_5_5_p125;
  const Real Lambda_5_5_p130 = Lambda_5_5_p129 * Lambda_5_5_p56;
  const Real Lambda_5_5_p131 = Lambda_5_5_p111 * Lambda_5_5_p124;
  const Real Lambda_5_5_p132 = Lambda_5_5_p112 * Lambda_5_5_p124;
  const Real Lambda_5_5_p133 = Lambda_5_5_p117 * Lambda_5_5_p124;
  const Real Lambda_5_5_p134 = Lambda_5_5_p126 * Lambda_5_5_p124;
  const Real Lambda_5_5_p135 = Lambda_5_5_p78 * Lambda_5_5_p29 * Lambda_5_5_p78 + Lambda_5_5_p100 *
      Lambda_5_5_p56 * Lambda_5_5_p100 + Lambda_5_5_p114 * Lambda_5_5_p91 * Lambda_5_5_p114;
  const Real Lambda_5_5_p136 = Lambda_5_5_p126 - Lambda_5_5_p54 * Lambda_5_5_p125 - Lambda_5_5_p75 *
      Lambda_5_5_p129;
  const Real Lambda_5_5_p137 = Lambda_5_5_p132 * Lambda_5_5_p126;
  const Real Lambda_5_5_p138 = Lambda_5_5_p133 * Lambda_5_5_p126;
  const Real Lambda_5_5_p139 = Lambda_5_5_p131 * Lambda_5_5_p126;
  const Real Lambda_5_5_p140 = Lambda_5_5_p94 * c5 + Lambda_5_5_p92 * Lambda_5_5_p68 +
      Lambda_5_5_p98 * Lambda_5_5_p73 + Lambda_5_5_p107 * Lambda_5_5_p89 + Lambda_5_5_p131 *
      Lambda_5_5_p111;
  const Real Lambda_5_5_p141 = Lambda_5_5_p80 * c5 + Lambda_5_5_p95 * Lambda_5_5_p68 +
      Lambda_5_5_p99 * Lambda_5_5_p73 + Lambda_5_5_p108 * Lambda_5_5_p89 + Lambda_5_5_p132 *
      Lambda_5_5_p111;
  const Real Lambda_5_5_p142 = Lambda_5_5_p118 + Lambda_5_5_p132 * Lambda_5_5_p112;
  const Real Lambda_5_5_p143 = Lambda_5_5_p119 + Lambda_5_5_p132 * Lambda_5_5_p117;
  const Real Lambda_5_5_p144 = Lambda_5_5_p115 + Lambda_5_5_p113 * Lambda_5_5_p110 +
      Lambda_5_5_p133 * Lambda_5_5_p117;
  const Real Lambda_5_5_p145 = Lambda_5_5_p94 * Lambda_5_5_p90 + Lambda_5_5_p92 * Lambda_5_5_p97 +
      Lambda_5_5_p98 * Lambda_5_5_p106 + Lambda_5_5_p107 * Lambda_5_5_p110 + Lambda_5_5_p131 *
      Lambda_5_5_p117;
  const Real Lambda_5_5_p146 = Lambda_5_5_p92 * Lambda_5_5_p78 + Lambda_5_5_p98 * Lambda_5_5_p100 -
      Lambda_5_5_p107 * Lambda_5_5_p114 + Lambda_5_5_p131 * Lambda_5_5_p123;
  const Real Lambda_5_5_p147 = Lambda_5_5_p95 * Lambda_5_5_p78 + Lambda_5_5_p99 * Lambda_5_5_p100 -
      Lambda_5_5_p108 * Lambda_5_5_p114 + Lambda_5_5_p132 * Lambda_5_5_p123;
  const Real Lambda_5_5_p148 = Lambda_5_5_p136 * Lambda_5_5_p91;
  const Real Lambda_5_5_p149 = Lambda_5_5_p145 * Lambda_5_5_p120;
  const Real Lambda_5_5_p150 = Lambda_5_5_p143 * Lambda_5_5_p121;
  const Real Lambda_5_5_p151 = Lambda_5_5_p66 * Lambda_5_5_p125 + Lambda_5_5_p77 * Lambda_5_5_p129 +
      Lambda_5_5_p105 * Lambda_5_5_p136;
  const Real Lambda_5_5_p152 = Lambda_5_5_p141 * Lambda_5_5_p122;
  const Real Lambda_5_5_p153 = Lambda_5_5_p151 * Lambda_5_5_p124;
  const Real Lambda_5_5_p154 = Lambda_5_5_p146 - (Lambda_5_5_p140 * Lambda_5_5_p120 -
      Lambda_5_5_p141 * Lambda_5_5_p121);
  const Real Lambda_5_5_p155 = Lambda_5_5_p147 - (Lambda_5_5_p141 * Lambda_5_5_p120 -
      Lambda_5_5_p142 * Lambda_5_5_p121);
  const Real Lambda_5_5_p156 = Lambda_5_5_p137 - (Lambda_5_5_p142 * Lambda_5_5_p122 -
      Lambda_5_5_p143 * Lambda_5_5_p120);
  const Real Lambda_5_5_p157 = Lambda_5_5_p138 - (Lambda_5_5_p143 * Lambda_5_5_p122 -
      Lambda_5_5_p144 * Lambda_5_5_p120);
  const Real Lambda_5_5_p158 = Lambda_5_5_p104 * Lambda_5_5_p78 + Lambda_5_5_p109 *
      Lambda_5_5_p100 - Lambda_5_5_p113 * Lambda_5_5_p114 + Lambda_5_5_p133 * Lambda_5_5_p123 -
      (Lambda_5_5_p149 - Lambda_5_5_p150);
  const Real Lambda_5_5_p159 = Lambda_5_5_p92 * Lambda_5_5_p125 + Lambda_5_5_p98 * Lambda_5_5_p129 +
      Lambda_5_5_p107 * Lambda_5_5_p136 - Lambda_5_5_p131 * Lambda_5_5_p151;
  const Real Lambda_5_5_p160 = Lambda_5_5_p104 * Lambda_5_5_p125 + Lambda_5_5_p109 *
      Lambda_5_5_p129 + Lambda_5_5_p113 * Lambda_5_5_p136 - Lambda_5_5_p133 * Lambda_5_5_p151;
  const Real Lambda_5_5_p161 = Lambda_5_5_p139 - (Lambda_5_5_p152 - Lambda_5_5_p149);
  const Real Lambda_5_5_p162 = Lambda_5_5_p95 * Lambda_5_5_p125 + Lambda_5_5_p99 * Lambda_5_5_p129 +
      Lambda_5_5_p108 * Lambda_5_5_p136 - Lambda_5_5_p132 * Lambda_5_5_p151;
  const Real Lambda_5_5_p163 = Lambda_5_5_p128 * Lambda_5_5_p78 + Lambda_5_5_p130 *
      Lambda_5_5_p100 - Lambda_5_5_p148 * Lambda_5_5_p114 - Lambda_5_5_p153 * Lambda_5_5_p123 -
      Lambda_5_5_p120 * Lambda_5_5_p159;
  const Real Lambda_5_5_p164 = Lambda_5_5_p134 * Lambda_5_5_p123 + Lambda_5_5_p121 *
      Lambda_5_5_p137 - Lambda_5_5_p122 * Lambda_5_5_p155 + (Lambda_5_5_p158 - Lambda_5_5_p139) *
      Lambda_5_5_p120;
  const Real Lambda_5_5_p165 = Lambda_5_5_p135 + Lambda_5_5_p123 * Lambda_5_5_p124 *
      Lambda_5_5_p123 - (Lambda_5_5_p120 * (Lambda_5_5_p146 + Lambda_5_5_p154) - Lambda_5_5_p121 *
      (Lambda_5_5_p147 + Lambda_5_5_p155));
  const Real Lambda_5_5_p166 = Lambda_5_5_p134 * Lambda_5_5_p126 -
      (Lambda_5_5_p122 * (Lambda_5_5_p137 + Lambda_5_5_p156) - Lambda_5_5_p120 *
      (Lambda_5_5_p138 + Lambda_5_5_p157));

  // link 1 (shoulder), turn
  const Real Lambda_5_5_p167 = c1 * Lambda_5_5_p155 - s1 * Lambda_5_5_p156;
  const Real Lambda_5_5_p168 = s1 * (Lambda_5_5_p158 - Lambda_5_5_p161) + c1 *
      (Lambda_5_5_p157 + Lambda_5_5_p154);

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p169 = Lambda_5_5_p163 + Lambda_5_5_p122 * Lambda_5_5_p154 +
      (Lambda_5_5_p162 - Lambda_5_5_p158) * Lambda_5_5_p121;
  const Real Lambda_5_5_p170 = Lambda_5_5_p153 * Lambda_5_5_p126 - Lambda_5_5_p120 *
      Lambda_5_5_p160 + Lambda_5_5_p121 * Lambda_5_5_p157 + (Lambda_5_5_p162 - Lambda_5_5_p161) *
      Lambda_5_5_p122;

  // link 1 (shoulder), turn
  const Real Lambda_5_5_p171 = c1 * Lambda_5_5_p168;
  const Real Lambda_5_5_p172 = s1 * Lambda_5_5_p168;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p173 = Lambda_5_5_p160 - (Lambda_5_5_p144 * Lambda_5_5_p121 -
      Lambda_5_5_p145 * Lambda_5_5_p122);
  const Real Lambda_5_5_p174 = Lambda_5_5_p159 - (Lambda_5_5_p145 * Lambda_5_5_p121 -
      Lambda_5_5_p140 * Lambda_5_5_p122);

  // link 1 (shoulder), turn
  const Real Lambda_5_5_p175 = Lambda_5_5_p171 - Lambda_5_5_p157;
  const Real Lambda_5_5_p176 = Lambda_5_5_p158 - Lambda_5_5_p172;
  const Real Lambda_5_5_p177 = c1 * Lambda_5_5_p169 + s1 * Lambda_5_5_p170;
  const Real Lambda_5_5_p178 = s1 * (Lambda_5_5_p165 - Lambda_5_5_p166) + Lambda_5_5_p127 *
      Lambda_5_5_p164;
  const Real Lambda_5_5_p179 = s1 * (Lambda_5_5_p144 - Lambda_5_5_p140) + Lambda_5_5_p127 *
      Lambda_5_5_p145;
  const Real Lambda_5_5_p180 = s1 * Lambda_5_5_p178;
  const Real Lambda_5_5_p181 = s1 * Lambda_5_5_p179;
  const Real Lambda_5_5_p182 = c1 * Lambda_5_5_p178 - Lambda_5_5_p164;
  const Real Lambda_5_5_p183 = 1.0 / (Lambda_5_5_p165 - Lambda_5_5_p180);

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p184 = Lambda_5_5_p128 * Lambda_5_5_p125 + Lambda_5_5_p130 *
      Lambda_5_5_p129 + Lambda_5_5_p148 * Lambda_5_5_p136 + Lambda_5_5_p153 * Lambda_5_5_p151 -
      (Lambda_5_5_p121 * (Lambda_5_5_p160 + Lambda_5_5_p173) - Lambda_5_5_p122 *
      (Lambda_5_5_p159 + Lambda_5_5_p174));

  // link 1 (shoulder), turn
  const Real Lambda_5_5_p185 = Lambda_5_5_p167 * Lambda_5_5_p183;
  const Real Lambda_5_5_p186 = Lambda_5_5_p175 * Lambda_5_5_p183;
  const Real Lambda_5_5_p187 = Lambda_5_5_p176 * Lambda_5_5_p183;
  const Real Lambda_5_5_p188 = Lambda_5_5_p177 * Lambda_5_5_p183;
  const Real Lambda_5_5_p189 = Lambda_5_5_p182 * Lambda_5_5_p183;
  const Lanes<8> Lambda_5_5_p209_lanes = detail::make_pack<Real>(Lambda_5_5_p166 + Lambda_5_5_p180,
      Lambda_5_5_p166 + Lambda_5_5_p180, s1 * Lambda_5_5_p169 - c1 * Lambda_5_5_p170,
      Lambda_5_5_p171 - Lambda_5_5_p154, Lambda_5_5_p161 + Lambda_5_5_p172, s1 * Lambda_5_5_p155 +
      c1 * Lambda_5_5_p156, Lambda_5_5_p166 + Lambda_5_5_p180, Lambda_5_5_p166 + Lambda_5_5_p180) -
      detail::make_pack<Real>(Lambda_5_5_p189, Lambda_5_5_p189, Lambda_5_5_p188, Lambda_5_5_p187,
      Lambda_5_5_p186, Lambda_5_5_p185, Lambda_5_5_p189, Lambda_5_5_p189) * Lambda_5_5_p182;
  const Real Lambda_5_5_p214 = 1.0 / Lambda_5_5_p209_lanes[1];
  const Lanes<8> Lambda_5_5_p215_lanes = Lambda_5_5_p209_lanes * Lambda_5_5_p214;
  const Real Lambda_0_0_p1 = Lambda_5_5_p189 * Lambda_5_5_p214;
  const Lanes<8> Lambda_5_5_p226_lanes = detail::make_pack<Real>(Lambda_5_5_p184, Lambda_5_5_p184,
      Lambda_5_5_p184, c1 * Lambda_5_5_p173 - s1 * Lambda_5_5_p174, s1 * Lambda_5_5_p173 + c1 *
      Lambda_5_5_p174, Lambda_5_5_p162 - (Lambda_5_5_p150 - Lambda_5_5_p152), Lambda_5_5_p184,
      Lambda_5_5_p184) - detail::make_pack<Real>(Lambda_5_5_p188, Lambda_5_5_p188, Lambda_5_5_p188,
      Lambda_5_5_p187, Lambda_5_5_p186, Lambda_5_5_p185, Lambda_5_5_p188, Lambda_5_5_p188) *
      Lambda_5_5_p177 - Lambda_5_5_p215_lanes * Lambda_5_5_p209_lanes[2];
  const Real Lambda_0_0_p2 = Lambda_5_5_p215_lanes[2] * Lambda_5_5_p189 - Lambda_5_5_p188;
  const Real Lambda_5_5_p233 = 1.0 / Lambda_5_5_p226_lanes[2];
  const Lanes<8> Lambda_5_5_p234_lanes = Lambda_5_5_p226_lanes * Lambda_5_5_p233;
  const Real Lambda_0_0_p3 = Lambda_0_0_p2 * Lambda_5_5_p233;
  const Real Lambda_0_1_p1 = Lambda_5_5_p215_lanes[2] * Lambda_5_5_p233;
  const Lanes<8> Lambda_5_5_p240_lanes = detail::make_pack<Real>(Lambda_5_5_p144 - Lambda_5_5_p181,
      Lambda_5_5_p144 - Lambda_5_5_p181, Lambda_5_5_p144 - Lambda_5_5_p181, Lambda_5_5_p144 -
      Lambda_5_5_p181, c1 * Lambda_5_5_p179 - Lambda_5_5_p145, c1 * Lambda_5_5_p143 - s1 *
      Lambda_5_5_p141, Lambda_5_5_p144 - Lambda_5_5_p181, Lambda_5_5_p144 - Lambda_5_5_p181) -
      detail::make_pack<Real>(Lambda_5_5_p187, Lambda_5_5_p187, Lambda_5_5_p187, Lambda_5_5_p187,
      Lambda_5_5_p186, Lambda_5_5_p185, Lambda_5_5_p187, Lambda_5_5_p187) * Lambda_5_5_p176 -
      Lambda_5_5_p215_lanes * Lambda_5_5_p209_lanes[3] - Lambda_5_5_p234_lanes *
      Lambda_5_5_p226_lanes[3];
  const Real Lambda_5_5_p243 = s1 * Lambda_5_5_p143 + c1 * Lambda_5_5_p141 - Lambda_5_5_p185 *
      Lambda_5_5_p175 - Lambda_5_5_p215_lanes[5] * Lambda_5_5_p209_lanes[4] -
      Lambda_5_5_p234_lanes[5] * Lambda_5_5_p226_lanes[4];
  const Real Lambda_0_0_p4 = Lambda_5_5_p215_lanes[3] * Lambda_5_5_p189 - Lambda_5_5_p187 -
      Lambda_5_5_p234_lanes[3] * Lambda_0_0_p2;
  const Real Lambda_0_1_p2 = Lambda_5_5_p234_lanes[3] * Lambda_5_5_p215_lanes[2] -
      Lambda_5_5_p215_lanes[3];
  const Real Lambda_5_5_p244 = 1.0 / Lambda_5_5_p240_lanes[3];
  const Real Lambda_5_5_p245 = Lambda_5_5_p240_lanes[4] * Lambda_5_5_p244;
  const Real Lambda_5_5_p246 = Lambda_5_5_p240_lanes[5] * Lambda_5_5_p244;
  const Real Lambda_0_0_p5 = Lambda_0_0_p4 * Lambda_5_5_p244;
  const Real Lambda_0_1_p3 = Lambda_0_1_p2 * Lambda_5_5_p244;
  const Real Lambda_0_2_p1 = Lambda_5_5_p234_lanes[3] * Lambda_5_5_p244;
  const Real Lambda_5_5_p247 = Lambda_5_5_p140 + Lambda_5_5_p181 - Lambda_5_5_p186 *
      Lambda_5_5_p175 - Lambda_5_5_p215_lanes[4] * Lambda_5_5_p209_lanes[4] -
      Lambda_5_5_p234_lanes[4] * Lambda_5_5_p226_lanes[4] - Lambda_5_5_p245 *
      Lambda_5_5_p240_lanes[4];
  const Real Lambda_5_5_p248 = Lambda_5_5_p243 - Lambda_5_5_p246 * Lambda_5_5_p240_lanes[4];
  const Real Lambda_5_5_p249 = Lambda_5_5_p142 - Lambda_5_5_p185 * Lambda_5_5_p167 -
      Lambda_5_5_p215_lanes[5] * Lambda_5_5_p209_lanes[5] - Lambda_5_5_p234_lanes[5] *
      Lambda_5_5_p226_lanes[5] - Lambda_5_5_p246 * Lambda_5_5_p240_lanes[5];
  const Real Lambda_0_0_p6 = Lambda_5_5_p215_lanes[4] * Lambda_5_5_p189 - Lambda_5_5_p186 -
      Lambda_5_5_p234_lanes[4] * Lambda_0_0_p2 - Lambda_5_5_p245 * Lambda_0_0_p4;
  const Real Lambda_0_1_p4 = Lambda_5_5_p234_lanes[4] * Lambda_5_5_p215_lanes[2] -
      Lambda_5_5_p215_lanes[4] - Lambda_5_5_p245 * Lambda_0_1_p2;
  const Real Lambda_0_2_p2 = Lambda_5_5_p245 * Lambda_5_5_p234_lanes[3] - Lambda_5_5_p234_lanes[4];
  const Real Lambda_5_5_p250 = 1.0 / Lambda_5_5_p247;
  const Real Lambda_5_5_p251 = Lambda_5_5_p248 * Lambda_5_5_p250;
  const Real Lambda_0_0_p7 = Lambda_0_0_p6 * Lambda_5_5_p250;
  const Real Lambda_0_1_p5 = Lambda_0_1_p4 * Lambda_5_5_p250;
  const Real Lambda_0_2_p3 = Lambda_0_2_p2 * Lambda_5_5_p250;
  const Real Lambda_0_3_p1 = Lambda_5_5_p245 * Lambda_5_5_p250;
  const Real Lambda_0_5_p1 = Lambda_5_5_p215_lanes[5] * Lambda_5_5_p189 - Lambda_5_5_p185 -
      Lambda_5_5_p234_lanes[5] * Lambda_0_0_p2 - Lambda_5_5_p246 * Lambda_0_0_p4 - Lambda_5_5_p251 *
      Lambda_0_0_p6;
  const Real Lambda_1_5_p1 = Lambda_5_5_p234_lanes[5] * Lambda_5_5_p215_lanes[2] -
      Lambda_5_5_p215_lanes[5] - Lambda_5_5_p246 * Lambda_0_1_p2 - Lambda_5_5_p251 * Lambda_0_1_p4;
  const Real Lambda_2_5_p1 = Lambda_5_5_p246 * Lambda_5_5_p234_lanes[3] - Lambda_5_5_p234_lanes[5] -
      Lambda_5_5_p251 * Lambda_0_2_p2;
  const Real Lambda_3_5_p1 = Lambda_5_5_p251 * Lambda_5_5_p245 - Lambda_5_5_p246;
  const Real Lambda_0_0_p8 = Lambda_5_5_p183 + Lambda_0_0_p1 * Lambda_5_5_p189 + Lambda_0_0_p3 *
      Lambda_0_0_p2 + Lambda_0_0_p5 * Lambda_0_0_p4 + Lambda_0_0_p7 * Lambda_0_0_p6;
  const Real Lambda_5_5 = 1.0 / (Lambda_5_5_p249 - Lambda_5_5_p251 * Lambda_5_5_p248);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5 = Lambda_0_5_p1 * Lambda_5_5;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_1_5 = Lambda_1_5_p1 * Lambda_5_5;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_2_5 = Lambda_2_5_p1 * Lambda_5_5;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_3_5 = Lambda_3_5_p1 * Lambda_5_5;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_4_5 = Lambda_5_5_p251 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  Lambda[0] = Lambda_0_0_p8 + Lambda_0_5 * Lambda_0_5_p1;
  const Real Lambda_0_1 = Lambda_0_1_p3 * Lambda_0_0_p4 -
      (Lambda_0_0_p1 + Lambda_0_1_p1 * Lambda_0_0_p2) + Lambda_0_1_p5 * Lambda_0_0_p6 + Lambda_1_5 *
      Lambda_0_5_p1;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_0_2 = Lambda_0_0_p3 - Lambda_0_2_p1 * Lambda_0_0_p4 + Lambda_0_2_p3 *
      Lambda_0_0_p6 + Lambda_2_5 * Lambda_0_5_p1;
  Lambda[2] = Lambda_0_2;
  Lambda[12] = Lambda_0_2;
  const Real Lambda_0_3 = Lambda_0_0_p5 - Lambda_0_3_p1 * Lambda_0_0_p6 + Lambda_3_5 *
      Lambda_0_5_p1;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_0_4 = Lambda_0_0_p7 - Lambda_4_5 * Lambda_0_5_p1;
  Lambda[4] = Lambda_0_4;
  Lambda[24] = Lambda_0_4;
  Lambda[7] = Lambda_5_5_p214 + Lambda_0_1_p1 * Lambda_5_5_p215_lanes[2] + Lambda_0_1_p3 *
      Lambda_0_1_p2 + Lambda_0_1_p5 * Lambda_0_1_p4 + Lambda_1_5 * Lambda_1_5_p1;
  const Real Lambda_1_2 = Lambda_0_2_p3 * Lambda_0_1_p4 -
      (Lambda_0_1_p1 + Lambda_0_2_p1 * Lambda_0_1_p2) + Lambda_2_5 * Lambda_1_5_p1;
  Lambda[8] = Lambda_1_2;
  Lambda[13] = Lambda_1_2;
  const Real Lambda_1_3 = Lambda_0_1_p3 - Lambda_0_3_p1 * Lambda_0_1_p4 + Lambda_3_5 *
      Lambda_1_5_p1;
  Lambda[9] = Lambda_1_3;
  Lambda[19] = Lambda_1_3;
  const Real Lambda_1_4 = Lambda_0_1_p5 - Lambda_4_5 * Lambda_1_5_p1;
  Lambda[10] = Lambda_1_4;
  Lambda[25] = Lambda_1_4;
  Lambda[14] = Lambda_5_5_p233 + Lambda_0_2_p1 * Lambda_5_5_p234_lanes[3] + Lambda_0_2_p3 *
      Lambda_0_2_p2 + Lambda_2_5 * Lambda_2_5_p1;
  const Real Lambda_2_3 = Lambda_3_5 * Lambda_2_5_p1 -
      (Lambda_0_2_p1 + Lambda_0_3_p1 * Lambda_0_2_p2);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p3 - Lambda_4_5 * Lambda_2_5_p1;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_5_5_p244 + Lambda_0_3_p1 * Lambda_5_5_p245 + Lambda_3_5 * Lambda_3_5_p1;
  const Real Lambda_3_4 = Lambda_0_3_p1 + Lambda_4_5 * Lambda_3_5_p1;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_5_5_p250 + Lambda_4_5 * Lambda_5_5_p251;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
