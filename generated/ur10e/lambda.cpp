// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J carried inward, in the axes of link 1 (shoulder) at link origins.
// 838 flops (add 357, mul 471, div 10), sine and cosine of 5 angles
// Generated; see ur10e.hpp for the contract.
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
  const Real Lambda_0_5_p1 = 0.0054190910375000005 * s5;
  const Real Lambda_0_5_p2 = s5 * Lambda_0_5_p1;
  const Real Lambda_0_5_p3 = 0.031809629475 * c5;
  const Real Lambda_0_5_p4 = 0.0384148163875 + (0.007282091037500001 - Lambda_0_5_p2 +
      Lambda_0_5_p3);
  const Real Lambda_0_5_p5 = 0.0098370910375 + Lambda_0_5_p3;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_0_5_p6 = s4 * (Lambda_0_5_p4 - Lambda_0_5_p5) - c4 * (0.021392421525 * s5);
  const Real Lambda_0_5_p7 = s4 * Lambda_0_5_p6;
  const Real Lambda_0_5_p8 = 0.002495 + (Lambda_0_5_p4 - Lambda_0_5_p7);

  // link 5 (wrist_2), composite inertia
  const Real Lambda_0_5_p9 = 0.09132825 * s5;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_0_5_p10 = 0.33495075 * s4 - c4 * Lambda_0_5_p9;
  const Real Lambda_0_5_p11 = 1.1431 * Lambda_0_5_p10;
  const Real Lambda_0_5_p12 = 2.08081027531 + (Lambda_0_5_p5 + Lambda_0_5_p7 - Lambda_0_5_p11);

  // link 5 (wrist_2), composite inertia
  const Real Lambda_0_5_p13 = 0.0106962107625 * s5;

  // link 4 (wrist_1), mass matrix
  const Real Lambda_0_5_p14 = 0.33495075 * c4 + s4 * Lambda_0_5_p9;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_0_5_p15 = c4 * Lambda_0_5_p6 + Lambda_0_5_p13 - 0.57155 * Lambda_0_5_p14;

  // link 3 (forearm), composite inertia
  const Real Lambda_0_5_p16 = s3 * (Lambda_0_5_p8 - Lambda_0_5_p12) + c3 * (2.0 * Lambda_0_5_p15);
  const Real Lambda_0_5_p17 = s3 * Lambda_0_5_p16;

  // link 4 (wrist_1), mass matrix
  const Real Lambda_0_5_p18 = s3 * Lambda_0_5_p14;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_0_5_p19 = Lambda_0_5_p10 - 4.0059802;

  // link 3 (forearm), mass matrix
  const Real Lambda_0_5_p20 = Lambda_0_5_p18 + c3 * Lambda_0_5_p19;

  // link 3 (forearm), composite inertia
  const Real Lambda_0_5_p21 = 1.2254 * Lambda_0_5_p20;
  const Real Lambda_0_5_p22 = 4.37493718615 + (Lambda_0_5_p12 + Lambda_0_5_p17 - Lambda_0_5_p21);

  // link 2 (upper_arm), composite inertia
  const Real Lambda_0_5_p23 = 2.0 * (c3 * Lambda_0_5_p16 - Lambda_0_5_p15 + 0.6127 *
      (s3 * Lambda_0_5_p19 - c3 * Lambda_0_5_p14));
  const Real Lambda_0_5_p24 = Lambda_0_5_p22 + s2 *
      (s2 * (0.01175 + (Lambda_0_5_p8 - Lambda_0_5_p17) - Lambda_0_5_p22) + c2 * Lambda_0_5_p23);

  // link 6 (wrist_3), mass matrix
  const Real Lambda_0_5_p25 = 0.000623 * s5;
  const Real Lambda_0_5_p26 = s4 * Lambda_0_5_p25;
  const Real Lambda_0_5_p27 = c4 * Lambda_0_5_p25;
  const Real Lambda_0_5_p28 = s2 * (s3 * Lambda_0_5_p26 - c3 * Lambda_0_5_p27) - c2 *
      (s3 * Lambda_0_5_p27 + c3 * Lambda_0_5_p26);

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p29 = 1605.1364365971108 * Lambda_0_5_p28;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_0_5_p30 = 0.0085220910375 + 0.0159048147375 * c5;
  const Real Lambda_0_5_p31 = c4 * Lambda_0_5_p13 + s4 * Lambda_0_5_p30;
  const Real Lambda_0_5_p32 = s4 * Lambda_0_5_p13 - c4 * Lambda_0_5_p30 - 0.0521986612875 * s5;
  const Real Lambda_0_5_p33 = s2 * (c3 * Lambda_0_5_p31 - s3 * Lambda_0_5_p32) + c2 *
      (s3 * Lambda_0_5_p31 + c3 * Lambda_0_5_p32 - 0.055956818775 * s5);

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p34 = 117.34209310833121 * Lambda_0_5_p33;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_0_5_p35 = c5 * Lambda_0_5_p1 + 0.0159048147375 * s5;
  const Real Lambda_0_5_p36 = 0.0106962107625 * c5;
  const Real Lambda_0_5_p37 = 0.0585962731125 + Lambda_0_5_p36;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_0_5_p38 = c4 * Lambda_0_5_p35 - s4 * Lambda_0_5_p37;
  const Real Lambda_0_5_p39 = s4 * Lambda_0_5_p35 + c4 * Lambda_0_5_p37;

  // link 3 (forearm), composite inertia
  const Real Lambda_0_5_p40 = s3 * Lambda_0_5_p39;
  const Real Lambda_0_5_p41 = c3 * Lambda_0_5_p39;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p42 = c5 * Lambda_0_5_p28;
  const Real Lambda_0_5_p43 = s2 * (c3 * Lambda_0_5_p38 - Lambda_0_5_p40) + c2 *
      (s3 * Lambda_0_5_p38 + Lambda_0_5_p41) - Lambda_0_5_p42;
  const Real Lambda_0_5_p44 = 1.2551157591996094 * c5;
  const Real Lambda_0_5_p45 = Lambda_0_5_p43 + Lambda_0_5_p44 * Lambda_0_5_p33;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_0_5_p46 = 0.041592816387499995 + Lambda_0_5_p2;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p47 = c5 * c5;
  const Real Lambda_0_5_p48 = 0.000623 * Lambda_0_5_p47;
  const Real Lambda_0_5_p49 = 1.0 / (Lambda_0_5_p46 - Lambda_0_5_p48 - Lambda_0_5_p44 *
      Lambda_0_5_p36);
  const Real Lambda_0_5_p50 = Lambda_0_5_p45 * Lambda_0_5_p49;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_0_5_p51 = 0.5656542411875001 + (Lambda_0_5_p38 + 0.0521986612875 * c5);

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p52 = Lambda_0_5_p42 - c2 * (s3 * Lambda_0_5_p51 + Lambda_0_5_p41);

  // link 3 (forearm), composite inertia
  const Real Lambda_0_5_p53 = c3 * Lambda_0_5_p51 - Lambda_0_5_p40;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_0_5_p54 = 0.09132825 * c5;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_0_5_p55 = s4 * Lambda_0_5_p54;
  const Real Lambda_0_5_p56 = 0.57155 * Lambda_0_5_p55 - Lambda_0_5_p36;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p57 = 117.34209310833121 * Lambda_0_5_p56;
  const Real Lambda_0_5_p58 = Lambda_0_5_p46 - 0.57155 * Lambda_0_5_p10 - Lambda_0_5_p48;
  const Real Lambda_0_5_p59 = Lambda_0_5_p58 + Lambda_0_5_p44 * Lambda_0_5_p56;
  const Real Lambda_0_5_p60 = Lambda_0_5_p59 * Lambda_0_5_p49;
  const Real Lambda_0_5_p61 = s2 * Lambda_0_5_p53 - Lambda_0_5_p52 - Lambda_0_5_p57 *
      Lambda_0_5_p33 - Lambda_0_5_p60 * Lambda_0_5_p45;
  const Real Lambda_0_5_p62 = 2.08330527531 + (Lambda_0_5_p46 - Lambda_0_5_p11) - Lambda_0_5_p48;
  const Real Lambda_0_5_p63 = 1.0 / (Lambda_0_5_p62 - Lambda_0_5_p57 * Lambda_0_5_p56 -
      Lambda_0_5_p60 * Lambda_0_5_p59);
  const Real Lambda_0_5_p64 = Lambda_0_5_p61 * Lambda_0_5_p63;
  const Real Lambda_0_5_p65 = 0.5353459446375001 + Lambda_0_5_p24 - Lambda_0_5_p29 *
      Lambda_0_5_p28 - Lambda_0_5_p34 * Lambda_0_5_p33 - Lambda_0_5_p50 * Lambda_0_5_p45 -
      Lambda_0_5_p64 * Lambda_0_5_p61;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_0_5_p66 = Lambda_0_5_p56 + 0.6127 *
      (s3 * (c4 * Lambda_0_5_p54) + c3 * Lambda_0_5_p55);

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p67 = 117.34209310833121 * Lambda_0_5_p66;
  const Real Lambda_0_5_p68 = Lambda_0_5_p58 - 0.6127 * (Lambda_0_5_p18 + c3 * Lambda_0_5_p10) +
      Lambda_0_5_p44 * Lambda_0_5_p66;
  const Real Lambda_0_5_p69 = Lambda_0_5_p68 * Lambda_0_5_p49;
  const Real Lambda_0_5_p70 = s2 * (1.156008191975 + (Lambda_0_5_p53 + 0.055956818775 * c5)) -
      Lambda_0_5_p52 - Lambda_0_5_p67 * Lambda_0_5_p33 - Lambda_0_5_p69 * Lambda_0_5_p45;
  const Real Lambda_0_5_p71 = Lambda_0_5_p62 - 0.6127 * Lambda_0_5_p20 - Lambda_0_5_p57 *
      Lambda_0_5_p66 - Lambda_0_5_p60 * Lambda_0_5_p68;
  const Real Lambda_0_5_p72 = Lambda_0_5_p71 * Lambda_0_5_p63;
  const Real Lambda_0_5_p73 = Lambda_0_5_p70 - Lambda_0_5_p72 * Lambda_0_5_p61;
  const Real Lambda_0_5_p74 = 4.3866871861500005 + Lambda_0_5_p62 - Lambda_0_5_p21 -
      Lambda_0_5_p67 * Lambda_0_5_p66 - Lambda_0_5_p69 * Lambda_0_5_p68 - Lambda_0_5_p72 *
      Lambda_0_5_p71;
  const Real Lambda_0_5_p75 = 1.0 / Lambda_0_5_p74;
  const Real Lambda_0_5_p76 = Lambda_0_5_p73 * Lambda_0_5_p75;
  const Real Lambda_0_5_p77 = 1.0 / (Lambda_0_5_p65 - Lambda_0_5_p76 * Lambda_0_5_p73);
  const Real Lambda_0_5_p78 = Lambda_0_5_p47 - 1.0;
  const Real Lambda_0_5_p79 = (1.0 - Lambda_0_5_p60) * Lambda_0_5_p78;
  const Real Lambda_0_5_p80 = (1.0 - Lambda_0_5_p69) * Lambda_0_5_p78 - Lambda_0_5_p72 *
      Lambda_0_5_p79;
  const Real Lambda_0_5_p81 = Lambda_0_5_p29 * c5 - Lambda_0_5_p50 * Lambda_0_5_p78 -
      Lambda_0_5_p64 * Lambda_0_5_p79 - Lambda_0_5_p76 * Lambda_0_5_p80;
  const Real Lambda_0_5_p82 = Lambda_0_5_p81 * Lambda_0_5_p77;
  const Real Lambda_0_5_p83 = Lambda_0_5_p80 * Lambda_0_5_p75;
  const Real Lambda_0_5_p84 = Lambda_0_5_p79 * Lambda_0_5_p63;
  const Real Lambda_0_5_p85 = Lambda_0_5_p78 * Lambda_0_5_p49;
  const Real Lambda_0_5_p86 = 1605.1364365971108 * c5;
  const Real Lambda_0_5_p87 = Lambda_0_5_p86 * c5 + Lambda_0_5_p85 * Lambda_0_5_p78 +
      Lambda_0_5_p84 * Lambda_0_5_p79 + Lambda_0_5_p83 * Lambda_0_5_p80 + Lambda_0_5_p82 *
      Lambda_0_5_p81;

  // link 3 (forearm), pose
  const Real Lambda_0_5_p88 = s3 * c2 + c3 * s2;
  const Real Lambda_0_5_p89 = c3 * c2 - s3 * s2;

  // link 4 (wrist_1), pose
  const Real Lambda_0_5_p90 = c4 * Lambda_0_5_p88 + s4 * Lambda_0_5_p89;

  // link 5 (wrist_2), pose
  const Real Lambda_0_5_p91 = s5 * Lambda_0_5_p90;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p92 = 0.11655 * Lambda_0_5_p91;

  // link 4 (wrist_1), pose
  const Real Lambda_0_5_p93 = c4 * Lambda_0_5_p89 - s4 * Lambda_0_5_p88;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p94 = c5 * Lambda_0_5_p91;
  const Real Lambda_0_5_p95 = Lambda_0_5_p94 - Lambda_0_5_p44 * Lambda_0_5_p93;
  const Real Lambda_0_5_p96 = Lambda_0_5_p94 + Lambda_0_5_p57 * Lambda_0_5_p93 - Lambda_0_5_p60 *
      Lambda_0_5_p95;
  const Real Lambda_0_5_p97 = 1.0 + Lambda_0_5_p29 * Lambda_0_5_p91 + Lambda_0_5_p34 *
      Lambda_0_5_p93 - Lambda_0_5_p50 * Lambda_0_5_p95 - Lambda_0_5_p64 * Lambda_0_5_p96;
  const Real Lambda_0_5_p98 = Lambda_0_5_p94 + Lambda_0_5_p67 * Lambda_0_5_p93 - Lambda_0_5_p69 *
      Lambda_0_5_p95 - Lambda_0_5_p72 * Lambda_0_5_p96;
  const Real Lambda_0_5_p99 = Lambda_0_5_p97 - Lambda_0_5_p76 * Lambda_0_5_p98;
  const Real Lambda_0_5_p100 = Lambda_0_5_p99 * Lambda_0_5_p77;
  const Real Lambda_0_5_p101 = Lambda_0_5_p98 * Lambda_0_5_p75;
  const Real Lambda_0_5_p102 = Lambda_0_5_p96 * Lambda_0_5_p63;
  const Real Lambda_0_5_p103 = Lambda_0_5_p95 * Lambda_0_5_p49;
  const Real Lambda_0_5_p104 = 1605.1364365971108 * Lambda_0_5_p91;
  const Real Lambda_0_5_p105 = Lambda_0_5_p104 * c5 + Lambda_0_5_p103 * Lambda_0_5_p78 +
      Lambda_0_5_p102 * Lambda_0_5_p79 + Lambda_0_5_p101 * Lambda_0_5_p80 + Lambda_0_5_p100 *
      Lambda_0_5_p81;
  const Real Lambda_0_5_p106 = 0.11655 * c5;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_0_5_p107 = 0.11985 * Lambda_0_5_p93;
  const Real Lambda_0_5_p108 = 0.11985 * c4;
  const Real Lambda_0_5_p109 = 0.11985 * s4 - 0.57155;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p110 = Lambda_0_5_p108 * Lambda_0_5_p89 - Lambda_0_5_p109 * Lambda_0_5_p88 -
      Lambda_0_5_p60 * Lambda_0_5_p107;

  // link 3 (forearm), Jacobian
  const Real Lambda_0_5_p111 = c3 * Lambda_0_5_p109 + s3 * Lambda_0_5_p108 - 0.6127;
  const Real Lambda_0_5_p112 = s3 * Lambda_0_5_p109 - c3 * Lambda_0_5_p108;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p113 = Lambda_0_5_p111 * s2 + Lambda_0_5_p112 * c2 + Lambda_0_5_p69 *
      Lambda_0_5_p107 + Lambda_0_5_p72 * Lambda_0_5_p110;
  const Real Lambda_0_5_p114 = 0.17415 - Lambda_0_5_p50 * Lambda_0_5_p107 - Lambda_0_5_p64 *
      Lambda_0_5_p110 + Lambda_0_5_p76 * Lambda_0_5_p113;
  const Real Lambda_0_5_p115 = Lambda_0_5_p85 * Lambda_0_5_p107 + Lambda_0_5_p84 * Lambda_0_5_p110 -
      Lambda_0_5_p83 * Lambda_0_5_p113 + Lambda_0_5_p82 * Lambda_0_5_p114;
  const Real Lambda_0_5_p116 = Lambda_0_5_p115 - (Lambda_0_5_p87 * Lambda_0_5_p92 -
      Lambda_0_5_p105 * Lambda_0_5_p106);
  const Real Lambda_0_5_p117 = 117.34209310833121 * Lambda_0_5_p93;
  const Real Lambda_0_5_p118 = Lambda_0_5_p104 * Lambda_0_5_p91 + Lambda_0_5_p117 * Lambda_0_5_p93 +
      Lambda_0_5_p103 * Lambda_0_5_p95 + Lambda_0_5_p102 * Lambda_0_5_p96 + Lambda_0_5_p101 *
      Lambda_0_5_p98;
  const Real Lambda_0_5_p119 = Lambda_0_5_p118 + Lambda_0_5_p100 * Lambda_0_5_p99;
  const Real Lambda_0_5_p120 = Lambda_0_5_p103 * Lambda_0_5_p107 + Lambda_0_5_p102 *
      Lambda_0_5_p110 - Lambda_0_5_p101 * Lambda_0_5_p113 + Lambda_0_5_p100 * Lambda_0_5_p114;
  const Real Lambda_0_5_p121 = Lambda_0_5_p120 - (Lambda_0_5_p105 * Lambda_0_5_p92 -
      Lambda_0_5_p119 * Lambda_0_5_p106);
  const Real Lambda_0_5_p122 = Lambda_0_5_p107 * Lambda_0_5_p49 * Lambda_0_5_p107 +
      Lambda_0_5_p110 * Lambda_0_5_p63 * Lambda_0_5_p110 + Lambda_0_5_p113 * Lambda_0_5_p75 *
      Lambda_0_5_p113;
  const Real Lambda_0_5_p123 = Lambda_0_5_p122 + Lambda_0_5_p114 * Lambda_0_5_p77 *
      Lambda_0_5_p114 - (Lambda_0_5_p92 * (Lambda_0_5_p115 + Lambda_0_5_p116) - Lambda_0_5_p106 *
      (Lambda_0_5_p120 + Lambda_0_5_p121));

  // link 5 (wrist_2), pose
  const Real Lambda_0_5_p124 = s5 * Lambda_0_5_p93;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p125 = 0.11655 * Lambda_0_5_p124;
  const Real Lambda_0_5_p126 = c5 * Lambda_0_5_p124;
  const Real Lambda_0_5_p127 = Lambda_0_5_p126 + Lambda_0_5_p44 * Lambda_0_5_p90;
  const Real Lambda_0_5_p128 = Lambda_0_5_p126 - Lambda_0_5_p57 * Lambda_0_5_p90 - Lambda_0_5_p60 *
      Lambda_0_5_p127;
  const Real Lambda_0_5_p129 = Lambda_0_5_p126 - Lambda_0_5_p67 * Lambda_0_5_p90 - Lambda_0_5_p69 *
      Lambda_0_5_p127 - Lambda_0_5_p72 * Lambda_0_5_p128;
  const Real Lambda_0_5_p130 = Lambda_0_5_p29 * Lambda_0_5_p124 - Lambda_0_5_p34 * Lambda_0_5_p90 -
      Lambda_0_5_p50 * Lambda_0_5_p127 - Lambda_0_5_p64 * Lambda_0_5_p128 - Lambda_0_5_p76 *
      Lambda_0_5_p129;
  const Real Lambda_0_5_p131 = Lambda_0_5_p104 * Lambda_0_5_p124 - Lambda_0_5_p117 *
      Lambda_0_5_p90 + Lambda_0_5_p103 * Lambda_0_5_p127 + Lambda_0_5_p102 * Lambda_0_5_p128 +
      Lambda_0_5_p101 * Lambda_0_5_p129;
  const Real Lambda_0_5_p132 = Lambda_0_5_p131 + Lambda_0_5_p100 * Lambda_0_5_p130;

  // link 2 (upper_arm), Jacobian
  const Real Lambda_0_5_p133 = c2 * Lambda_0_5_p111 - s2 * Lambda_0_5_p112;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p134 = Lambda_0_5_p100 * Lambda_0_5_p133;
  const Real Lambda_0_5_p135 = Lambda_0_5_p134 - (Lambda_0_5_p119 * Lambda_0_5_p125 -
      Lambda_0_5_p132 * Lambda_0_5_p92);
  const Real Lambda_0_5_p136 = Lambda_0_5_p130 * Lambda_0_5_p77;
  const Real Lambda_0_5_p137 = Lambda_0_5_p127 * Lambda_0_5_p49;
  const Real Lambda_0_5_p138 = Lambda_0_5_p128 * Lambda_0_5_p63;
  const Real Lambda_0_5_p139 = 1605.1364365971108 * Lambda_0_5_p124 * Lambda_0_5_p124 +
      117.34209310833121 * Lambda_0_5_p90 * Lambda_0_5_p90 + Lambda_0_5_p137 * Lambda_0_5_p127 +
      Lambda_0_5_p138 * Lambda_0_5_p128;
  const Real Lambda_0_5_p140 = Lambda_0_5_p129 * Lambda_0_5_p75;
  const Real Lambda_0_5_p141 = Lambda_0_5_p139 + Lambda_0_5_p140 * Lambda_0_5_p129 +
      Lambda_0_5_p136 * Lambda_0_5_p130;
  const Real Lambda_0_5_p142 = Lambda_0_5_p136 * Lambda_0_5_p133;
  const Real Lambda_0_5_p143 = Lambda_0_5_p142 - (Lambda_0_5_p132 * Lambda_0_5_p125 -
      Lambda_0_5_p141 * Lambda_0_5_p92);
  const Real Lambda_0_5_p144 = Lambda_0_5_p133 * Lambda_0_5_p77;
  const Real Lambda_0_5_p145 = Lambda_0_5_p144 * Lambda_0_5_p133 -
      (Lambda_0_5_p125 * (Lambda_0_5_p134 + Lambda_0_5_p135) - Lambda_0_5_p92 *
      (Lambda_0_5_p142 + Lambda_0_5_p143));
  const Real Lambda_0_5_p146 = Lambda_0_5_p86 * Lambda_0_5_p124 + Lambda_0_5_p85 * Lambda_0_5_p127 +
      Lambda_0_5_p84 * Lambda_0_5_p128 + Lambda_0_5_p83 * Lambda_0_5_p129 + Lambda_0_5_p82 *
      Lambda_0_5_p130;
  const Real Lambda_0_5_p147 = Lambda_0_5_p146 * Lambda_0_5_p92;
  const Real Lambda_0_5_p148 = Lambda_0_5_p132 * Lambda_0_5_p106;
  const Real Lambda_0_5_p149 = Lambda_0_5_p137 * Lambda_0_5_p107 + Lambda_0_5_p138 *
      Lambda_0_5_p110 - Lambda_0_5_p140 * Lambda_0_5_p113 + Lambda_0_5_p136 * Lambda_0_5_p114 -
      (Lambda_0_5_p147 - Lambda_0_5_p148);
  const Real Lambda_0_5_p150 = Lambda_0_5_p82 * Lambda_0_5_p133;
  const Real Lambda_0_5_p151 = Lambda_0_5_p144 * Lambda_0_5_p114 + Lambda_0_5_p106 *
      Lambda_0_5_p134 - Lambda_0_5_p125 * Lambda_0_5_p121 + (Lambda_0_5_p149 - Lambda_0_5_p150) *
      Lambda_0_5_p92;

  // link 1 (shoulder), turn
  const Real Lambda_0_5_p152 = 2.0 * c1;
  const Real Lambda_0_5_p153 = s1 * (Lambda_0_5_p123 - Lambda_0_5_p145) + Lambda_0_5_p152 *
      Lambda_0_5_p151;
  const Real Lambda_0_5_p154 = s1 * Lambda_0_5_p153;
  const Real Lambda_0_5_p155 = 1.0 / (Lambda_0_5_p123 - Lambda_0_5_p154);
  const Real Lambda_0_5_p156 = c1 * Lambda_0_5_p121 - s1 * Lambda_0_5_p135;
  const Real Lambda_0_5_p157 = Lambda_0_5_p156 * Lambda_0_5_p155;
  const Real Lambda_0_5_p158 = c1 * Lambda_0_5_p153 - Lambda_0_5_p151;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p159 = Lambda_0_5_p105 * Lambda_0_5_p125;
  const Real Lambda_0_5_p160 = Lambda_0_5_p150 - (Lambda_0_5_p159 - Lambda_0_5_p147);

  // link 1 (shoulder), turn
  const Real Lambda_0_5_p161 = s1 * (Lambda_0_5_p149 - Lambda_0_5_p160) + c1 *
      (Lambda_0_5_p143 + Lambda_0_5_p116);
  const Real Lambda_0_5_p162 = c1 * Lambda_0_5_p161;
  const Real Lambda_0_5_p163 = Lambda_0_5_p162 - Lambda_0_5_p143;
  const Real Lambda_0_5_p164 = Lambda_0_5_p163 * Lambda_0_5_p155;
  const Real Lambda_0_5_p165 = s1 * Lambda_0_5_p161;
  const Real Lambda_0_5_p166 = Lambda_0_5_p149 - Lambda_0_5_p165;
  const Real Lambda_0_5_p167 = Lambda_0_5_p166 * Lambda_0_5_p155;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_0_5_p168 = 0.11985 * Lambda_0_5_p90;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p169 = Lambda_0_5_p109 * Lambda_0_5_p89 + Lambda_0_5_p108 * Lambda_0_5_p88 -
      Lambda_0_5_p60 * Lambda_0_5_p168;
  const Real Lambda_0_5_p170 = Lambda_0_5_p133 - Lambda_0_5_p69 * Lambda_0_5_p168 - Lambda_0_5_p72 *
      Lambda_0_5_p169;
  const Real Lambda_0_5_p171 = Lambda_0_5_p50 * Lambda_0_5_p168 + Lambda_0_5_p64 * Lambda_0_5_p169 +
      Lambda_0_5_p76 * Lambda_0_5_p170;
  const Real Lambda_0_5_p172 = Lambda_0_5_p171 * Lambda_0_5_p77;
  const Real Lambda_0_5_p173 = Lambda_0_5_p170 * Lambda_0_5_p75;
  const Real Lambda_0_5_p174 = Lambda_0_5_p169 * Lambda_0_5_p63;
  const Real Lambda_0_5_p175 = Lambda_0_5_p168 * Lambda_0_5_p49;
  const Real Lambda_0_5_p176 = Lambda_0_5_p85 * Lambda_0_5_p168 + Lambda_0_5_p84 * Lambda_0_5_p169 +
      Lambda_0_5_p83 * Lambda_0_5_p170 - Lambda_0_5_p82 * Lambda_0_5_p171;
  const Real Lambda_0_5_p177 = Lambda_0_5_p175 * Lambda_0_5_p107 + Lambda_0_5_p174 *
      Lambda_0_5_p110 - Lambda_0_5_p173 * Lambda_0_5_p113 - Lambda_0_5_p172 * Lambda_0_5_p114 -
      Lambda_0_5_p92 * Lambda_0_5_p176;
  const Real Lambda_0_5_p178 = Lambda_0_5_p103 * Lambda_0_5_p168 + Lambda_0_5_p102 *
      Lambda_0_5_p169 + Lambda_0_5_p101 * Lambda_0_5_p170 - Lambda_0_5_p100 * Lambda_0_5_p171;
  const Real Lambda_0_5_p179 = Lambda_0_5_p177 + Lambda_0_5_p125 * Lambda_0_5_p116 +
      (Lambda_0_5_p178 - Lambda_0_5_p149) * Lambda_0_5_p106;
  const Real Lambda_0_5_p180 = Lambda_0_5_p137 * Lambda_0_5_p168 + Lambda_0_5_p138 *
      Lambda_0_5_p169 + Lambda_0_5_p140 * Lambda_0_5_p170 - Lambda_0_5_p136 * Lambda_0_5_p171;
  const Real Lambda_0_5_p181 = Lambda_0_5_p172 * Lambda_0_5_p133 - Lambda_0_5_p92 *
      Lambda_0_5_p180 + Lambda_0_5_p106 * Lambda_0_5_p143 + (Lambda_0_5_p178 - Lambda_0_5_p160) *
      Lambda_0_5_p125;

  // link 1 (shoulder), turn
  const Real Lambda_0_5_p182 = c1 * Lambda_0_5_p179 + s1 * Lambda_0_5_p181;
  const Real Lambda_0_5_p183 = Lambda_0_5_p182 * Lambda_0_5_p155;
  const Real Lambda_0_5_p184 = Lambda_0_5_p158 * Lambda_0_5_p155;
  const Lanes<8> Lambda_0_5_p190_lanes = detail::make_pack<Real>(Lambda_0_5_p145 + Lambda_0_5_p154,
      Lambda_0_5_p145 + Lambda_0_5_p154, s1 * Lambda_0_5_p179 - c1 * Lambda_0_5_p181,
      Lambda_0_5_p162 - Lambda_0_5_p116, Lambda_0_5_p160 + Lambda_0_5_p165, s1 * Lambda_0_5_p121 +
      c1 * Lambda_0_5_p135, Lambda_0_5_p145 + Lambda_0_5_p154, Lambda_0_5_p145 + Lambda_0_5_p154) -
      detail::make_pack<Real>(Lambda_0_5_p184, Lambda_0_5_p184, Lambda_0_5_p183, Lambda_0_5_p167,
      Lambda_0_5_p164, Lambda_0_5_p157, Lambda_0_5_p184, Lambda_0_5_p184) * Lambda_0_5_p158;
  const Real Lambda_0_5_p195 = 1.0 / Lambda_0_5_p190_lanes[1];
  const Lanes<8> Lambda_0_5_p196_lanes = Lambda_0_5_p190_lanes * Lambda_0_5_p195;

  // link 1 (shoulder), mass matrix
  const Real Lambda_0_5_p208 = Lambda_0_5_p180 - (Lambda_0_5_p141 * Lambda_0_5_p106 -
      Lambda_0_5_p146 * Lambda_0_5_p125);
  const Real Lambda_0_5_p209 = Lambda_0_5_p176 - (Lambda_0_5_p146 * Lambda_0_5_p106 -
      Lambda_0_5_p87 * Lambda_0_5_p125);
  const Real Lambda_0_5_p210 = Lambda_0_5_p175 * Lambda_0_5_p168 + Lambda_0_5_p174 *
      Lambda_0_5_p169 + Lambda_0_5_p173 * Lambda_0_5_p170 + Lambda_0_5_p172 * Lambda_0_5_p171 -
      (Lambda_0_5_p106 * (Lambda_0_5_p180 + Lambda_0_5_p208) - Lambda_0_5_p125 *
      (Lambda_0_5_p176 + Lambda_0_5_p209));

  // link 1 (shoulder), turn
  const Lanes<8> Lambda_0_5_p215_lanes = detail::make_pack<Real>(Lambda_0_5_p210, Lambda_0_5_p210,
      Lambda_0_5_p210, c1 * Lambda_0_5_p208 - s1 * Lambda_0_5_p209, s1 * Lambda_0_5_p208 + c1 *
      Lambda_0_5_p209, Lambda_0_5_p178 - (Lambda_0_5_p148 - Lambda_0_5_p159), Lambda_0_5_p210,
      Lambda_0_5_p210) - detail::make_pack<Real>(Lambda_0_5_p183, Lambda_0_5_p183, Lambda_0_5_p183,
      Lambda_0_5_p167, Lambda_0_5_p164, Lambda_0_5_p157, Lambda_0_5_p183, Lambda_0_5_p183) *
      Lambda_0_5_p182 - Lambda_0_5_p196_lanes * Lambda_0_5_p190_lanes[2];
  const Real Lambda_0_5_p219 = 1.0 / Lambda_0_5_p215_lanes[2];
  const Lanes<8> Lambda_0_5_p220_lanes = Lambda_0_5_p215_lanes * Lambda_0_5_p219;
  const Real Lambda_0_5_p232 = s1 * (Lambda_0_5_p141 - Lambda_0_5_p87) + Lambda_0_5_p152 *
      Lambda_0_5_p146;
  const Real Lambda_0_5_p233 = s1 * Lambda_0_5_p232;
  const Lanes<8> Lambda_0_5_p240_lanes = detail::make_pack<Real>(Lambda_0_5_p141 - Lambda_0_5_p233,
      Lambda_0_5_p141 - Lambda_0_5_p233, Lambda_0_5_p141 - Lambda_0_5_p233, Lambda_0_5_p141 -
      Lambda_0_5_p233, c1 * Lambda_0_5_p232 - Lambda_0_5_p146, c1 * Lambda_0_5_p132 - s1 *
      Lambda_0_5_p105, Lambda_0_5_p141 - Lambda_0_5_p233, Lambda_0_5_p141 - Lambda_0_5_p233) -
      detail::make_pack<Real>(Lambda_0_5_p167, Lambda_0_5_p167, Lambda_0_5_p167, Lambda_0_5_p167,
      Lambda_0_5_p164, Lambda_0_5_p157, Lambda_0_5_p167, Lambda_0_5_p167) * Lambda_0_5_p166 -
      Lambda_0_5_p196_lanes * Lambda_0_5_p190_lanes[3] - Lambda_0_5_p220_lanes *
      Lambda_0_5_p215_lanes[3];
  const Real Lambda_0_5_p243 = 1.0 / Lambda_0_5_p240_lanes[3];
  const Real Lambda_0_5_p244 = Lambda_0_5_p240_lanes[5] * Lambda_0_5_p243;
  const Real Lambda_0_5_p245 = s1 * Lambda_0_5_p132 + c1 * Lambda_0_5_p105 - Lambda_0_5_p157 *
      Lambda_0_5_p163 - Lambda_0_5_p196_lanes[5] * Lambda_0_5_p190_lanes[4] -
      Lambda_0_5_p220_lanes[5] * Lambda_0_5_p215_lanes[4];
  const Real Lambda_0_5_p246 = Lambda_0_5_p245 - Lambda_0_5_p244 * Lambda_0_5_p240_lanes[4];
  const Real Lambda_0_5_p247 = Lambda_0_5_p240_lanes[4] * Lambda_0_5_p243;
  const Real Lambda_0_5_p248 = Lambda_0_5_p87 + Lambda_0_5_p233 - Lambda_0_5_p164 *
      Lambda_0_5_p163 - Lambda_0_5_p196_lanes[4] * Lambda_0_5_p190_lanes[4] -
      Lambda_0_5_p220_lanes[4] * Lambda_0_5_p215_lanes[4] - Lambda_0_5_p247 *
      Lambda_0_5_p240_lanes[4];
  const Real Lambda_0_5_p249 = 1.0 / Lambda_0_5_p248;
  const Real Lambda_0_5_p250 = Lambda_0_5_p246 * Lambda_0_5_p249;
  const Real Lambda_0_5_p251 = Lambda_0_5_p196_lanes[2] * Lambda_0_5_p184 - Lambda_0_5_p183;
  const Real Lambda_0_5_p252 = Lambda_0_5_p196_lanes[3] * Lambda_0_5_p184 - Lambda_0_5_p167 -
      Lambda_0_5_p220_lanes[3] * Lambda_0_5_p251;
  const Real Lambda_0_5_p253 = Lambda_0_5_p196_lanes[4] * Lambda_0_5_p184 - Lambda_0_5_p164 -
      Lambda_0_5_p220_lanes[4] * Lambda_0_5_p251 - Lambda_0_5_p247 * Lambda_0_5_p252;
  const Real Lambda_0_5_p254 = Lambda_0_5_p196_lanes[5] * Lambda_0_5_p184 - Lambda_0_5_p157 -
      Lambda_0_5_p220_lanes[5] * Lambda_0_5_p251 - Lambda_0_5_p244 * Lambda_0_5_p252 -
      Lambda_0_5_p250 * Lambda_0_5_p253;
  const Real Lambda_5_5_p1 = Lambda_0_5_p119 - Lambda_0_5_p157 * Lambda_0_5_p156 -
      Lambda_0_5_p196_lanes[5] * Lambda_0_5_p190_lanes[5] - Lambda_0_5_p220_lanes[5] *
      Lambda_0_5_p215_lanes[5] - Lambda_0_5_p244 * Lambda_0_5_p240_lanes[5];
  const Real Lambda_5_5 = 1.0 / (Lambda_5_5_p1 - Lambda_0_5_p250 * Lambda_0_5_p246);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5 = Lambda_0_5_p254 * Lambda_5_5;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_0_0_p1 = Lambda_0_5_p253 * Lambda_0_5_p249;
  const Real Lambda_0_0_p2 = Lambda_0_5_p252 * Lambda_0_5_p243;
  const Real Lambda_0_0_p3 = Lambda_0_5_p251 * Lambda_0_5_p219;
  const Real Lambda_0_0_p4 = Lambda_0_5_p184 * Lambda_0_5_p195;
  const Real Lambda_0_0_p5 = Lambda_0_5_p155 + Lambda_0_0_p4 * Lambda_0_5_p184 + Lambda_0_0_p3 *
      Lambda_0_5_p251 + Lambda_0_0_p2 * Lambda_0_5_p252 + Lambda_0_0_p1 * Lambda_0_5_p253;
  Lambda[0] = Lambda_0_0_p5 + Lambda_0_5 * Lambda_0_5_p254;
  const Real Lambda_1_5_p1 = Lambda_0_5_p220_lanes[3] * Lambda_0_5_p196_lanes[2] -
      Lambda_0_5_p196_lanes[3];
  const Real Lambda_1_5_p2 = Lambda_0_5_p220_lanes[4] * Lambda_0_5_p196_lanes[2] -
      Lambda_0_5_p196_lanes[4] - Lambda_0_5_p247 * Lambda_1_5_p1;
  const Real Lambda_1_5_p3 = Lambda_0_5_p220_lanes[5] * Lambda_0_5_p196_lanes[2] -
      Lambda_0_5_p196_lanes[5] - Lambda_0_5_p244 * Lambda_1_5_p1 - Lambda_0_5_p250 * Lambda_1_5_p2;
  const Real Lambda_1_5 = Lambda_1_5_p3 * Lambda_5_5;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_0_1_p1 = Lambda_1_5_p2 * Lambda_0_5_p249;
  const Real Lambda_0_1_p2 = Lambda_1_5_p1 * Lambda_0_5_p243;
  const Real Lambda_0_1_p3 = Lambda_0_5_p196_lanes[2] * Lambda_0_5_p219;
  const Real Lambda_0_1 = Lambda_0_1_p2 * Lambda_0_5_p252 -
      (Lambda_0_0_p4 + Lambda_0_1_p3 * Lambda_0_5_p251) + Lambda_0_1_p1 * Lambda_0_5_p253 +
      Lambda_1_5 * Lambda_0_5_p254;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_2_5_p1 = Lambda_0_5_p247 * Lambda_0_5_p220_lanes[3] - Lambda_0_5_p220_lanes[4];
  const Real Lambda_2_5_p2 = Lambda_0_5_p244 * Lambda_0_5_p220_lanes[3] - Lambda_0_5_p220_lanes[5] -
      Lambda_0_5_p250 * Lambda_2_5_p1;
  const Real Lambda_2_5 = Lambda_2_5_p2 * Lambda_5_5;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_0_2_p1 = Lambda_2_5_p1 * Lambda_0_5_p249;
  const Real Lambda_0_2_p2 = Lambda_0_5_p220_lanes[3] * Lambda_0_5_p243;
  const Real Lambda_0_2 = Lambda_0_0_p3 - Lambda_0_2_p2 * Lambda_0_5_p252 + Lambda_0_2_p1 *
      Lambda_0_5_p253 + Lambda_2_5 * Lambda_0_5_p254;
  Lambda[2] = Lambda_0_2;
  Lambda[12] = Lambda_0_2;
  const Real Lambda_3_5_p1 = Lambda_0_5_p250 * Lambda_0_5_p247 - Lambda_0_5_p244;
  const Real Lambda_3_5 = Lambda_3_5_p1 * Lambda_5_5;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_0_3_p1 = Lambda_0_5_p247 * Lambda_0_5_p249;
  const Real Lambda_0_3 = Lambda_0_0_p2 - Lambda_0_3_p1 * Lambda_0_5_p253 + Lambda_3_5 *
      Lambda_0_5_p254;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_4_5 = Lambda_0_5_p250 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  const Real Lambda_0_4 = Lambda_0_0_p1 - Lambda_4_5 * Lambda_0_5_p254;
  Lambda[4] = Lambda_0_4;
  Lambda[24] = Lambda_0_4;
  Lambda[7] = Lambda_0_5_p195 + Lambda_0_1_p3 * Lambda_0_5_p196_lanes[2] + Lambda_0_1_p2 *
      Lambda_1_5_p1 + Lambda_0_1_p1 * Lambda_1_5_p2 + Lambda_1_5 * Lambda_1_5_p3;
  const Real Lambda_1_2 = Lambda_0_2_p1 * Lambda_1_5_p2 -
      (Lambda_0_1_p3 + Lambda_0_2_p2 * Lambda_1_5_p1) + Lambda_2_5 * Lambda_1_5_p3;
  Lambda[8] = Lambda_1_2;
  Lambda[13] = Lambda_1_2;
  const Real Lambda_1_3 = Lambda_0_1_p2 - Lambda_0_3_p1 * Lambda_1_5_p2 + Lambda_3_5 *
      Lambda_1_5_p3;
  Lambda[9] = Lambda_1_3;
  Lambda[19] = Lambda_1_3;
  const Real Lambda_1_4 = Lambda_0_1_p1 - Lambda_4_5 * Lambda_1_5_p3;
  Lambda[10] = Lambda_1_4;
  Lambda[25] = Lambda_1_4;
  Lambda[14] = Lambda_0_5_p219 + Lambda_0_2_p2 * Lambda_0_5_p220_lanes[3] + Lambda_0_2_p1 *
      Lambda_2_5_p1 + Lambda_2_5 * Lambda_2_5_p2;
  const Real Lambda_2_3 = Lambda_3_5 * Lambda_2_5_p2 -
      (Lambda_0_2_p2 + Lambda_0_3_p1 * Lambda_2_5_p1);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p1 - Lambda_4_5 * Lambda_2_5_p2;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_0_5_p243 + Lambda_0_3_p1 * Lambda_0_5_p247 + Lambda_3_5 * Lambda_3_5_p1;
  const Real Lambda_3_4 = Lambda_0_3_p1 + Lambda_4_5 * Lambda_3_5_p1;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_0_5_p249 + Lambda_4_5 * Lambda_0_5_p250;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
