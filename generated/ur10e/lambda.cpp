// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J carried inward, in the axes of link 4 (wrist_1) at link origins.
// 757 flops (add 324, mul 423, div 10), sine and cosine of 5 angles
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
  const Real angles[5] = {q[1], q[2], q[3], q[4], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real s2 = sines[0];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];
  const Real s1 = sines[4];
  const Real c1 = cosines[4];

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p1 = 0.0054190910375000005 * s5;
  const Real Lambda_5_5_p2 = 0.09132825 * s5;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p3 = c5 * c5;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p4 = 0.09132825 * c5;
  const Real Lambda_5_5_p5 = 0.0106962107625 * c5;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p6 = 1.2551157591996094 * c5;
  const Real Lambda_5_5_p7 = 0.6127 * s2;
  const Real Lambda_5_5_p8 = 0.6127 * c2;
  const Real Lambda_5_5_p9 = c2 * c3 - s2 * s3;
  const Real Lambda_5_5_p10 = s2 * c3 + c2 * s3;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p11 = s5 * Lambda_5_5_p1;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p12 = 0.000623 * Lambda_5_5_p3;
  const Real Lambda_5_5_p13 = 1.0 - Lambda_5_5_p3;
  const Real Lambda_5_5_p14 = 0.57155 * Lambda_5_5_p10;
  const Real Lambda_5_5_p15 = 0.57155 * Lambda_5_5_p9;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p16 = 0.041592816387499995 + Lambda_5_5_p11;
  const Real Lambda_5_5_p17 = Lambda_5_5_p9 * c4 - Lambda_5_5_p10 * s4;
  const Real Lambda_5_5_p18 = Lambda_5_5_p10 * c4 + Lambda_5_5_p9 * s4;
  const Real Lambda_5_5_p19 = Lambda_5_5_p18 * Lambda_5_5_p2;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p20 = Lambda_5_5_p18 * Lambda_5_5_p4;
  const Real Lambda_5_5_p21 = Lambda_5_5_p17 * Lambda_5_5_p4;

  // link 6 (wrist_3), mass matrix
  const Real Lambda_5_5_p22 = s5 * Lambda_5_5_p18;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p23 = Lambda_5_5_p17 * s5;
  const Real Lambda_5_5_p24 = 0.33495075 * Lambda_5_5_p17 + Lambda_5_5_p19;
  const Real Lambda_5_5_p25 = 0.33495075 * Lambda_5_5_p18 - Lambda_5_5_p17 * Lambda_5_5_p2;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p26 = 1.0 / (Lambda_5_5_p16 - Lambda_5_5_p12 - Lambda_5_5_p6 *
      Lambda_5_5_p5);

  // link 6 (wrist_3), mass matrix
  const Real Lambda_5_5_p27 = 0.000623 * Lambda_5_5_p22;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p28 = Lambda_5_5_p15 * Lambda_5_5_p25;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p29 = Lambda_5_5_p22 * c5;
  const Real Lambda_5_5_p30 = c5 * Lambda_5_5_p27;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_5_5_p31 = Lambda_5_5_p14 * Lambda_5_5_p24 - Lambda_5_5_p28;

  // link 3 (forearm), composite inertia
  const Real Lambda_5_5_p32 = Lambda_5_5_p8 * (Lambda_5_5_p25 - 4.0059802 * Lambda_5_5_p9);

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p33 = Lambda_5_5_p15 * Lambda_5_5_p20 - Lambda_5_5_p14 * Lambda_5_5_p21 -
      Lambda_5_5_p5;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p34 = 1605.1364365971108 * c5;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_5_5_p35 = Lambda_5_5_p18 * c5 * Lambda_5_5_p1 + 0.17415 * Lambda_5_5_p19 +
      (0.0585962731125 + Lambda_5_5_p5) * Lambda_5_5_p17;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p36 = 0.11655 * Lambda_5_5_p22;
  const Real Lambda_5_5_p37 = 0.0098370910375 + (6.991093406097501 - s2 * (4.36318718615 * s2) -
      Lambda_5_5_p10 * (2.07831527531 * Lambda_5_5_p10)) + 0.031809629475 * c5;
  const Real Lambda_5_5_p38 = 117.34209310833121 * Lambda_5_5_p33;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p39 = Lambda_5_5_p33 + (Lambda_5_5_p8 * Lambda_5_5_p20 - Lambda_5_5_p7 *
      Lambda_5_5_p21);

  // link 3 (forearm), composite inertia
  const Real Lambda_5_5_p40 = Lambda_5_5_p7 * (4.0059802 * Lambda_5_5_p10 + Lambda_5_5_p24) -
      Lambda_5_5_p32;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_5_5_p41 = 0.0106962107625 * Lambda_5_5_p22 - 0.0085220910375 * Lambda_5_5_p17 -
      0.17415 * Lambda_5_5_p21 - (Lambda_5_5_p15 + Lambda_5_5_p8) * Lambda_5_5_p2;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p42 = Lambda_5_5_p16 + Lambda_5_5_p31 - Lambda_5_5_p12;
  const Real Lambda_5_5_p43 = Lambda_5_5_p29 - Lambda_5_5_p6 * Lambda_5_5_p17;
  const Real Lambda_5_5_p44 = 117.34209310833121 * Lambda_5_5_p39;
  const Real Lambda_5_5_p45 = Lambda_5_5_p42 + Lambda_5_5_p6 * Lambda_5_5_p33;
  const Real Lambda_5_5_p46 = 117.34209310833121 * Lambda_5_5_p41;
  const Real Lambda_5_5_p47 = 0.5656542411875001 * Lambda_5_5_p10 +
      (Lambda_5_5_p35 + Lambda_5_5_p14 * Lambda_5_5_p4) + Lambda_5_5_p30;
  const Real Lambda_5_5_p48 = Lambda_5_5_p45 * Lambda_5_5_p26;
  const Real Lambda_5_5_p49 = Lambda_5_5_p35 + Lambda_5_5_p30 + Lambda_5_5_p6 * Lambda_5_5_p41;
  const Real Lambda_5_5_p50 = 2.08330527531 + (Lambda_5_5_p16 + 2.0 * Lambda_5_5_p31) -
      Lambda_5_5_p12;

  // link 6 (wrist_3), pose
  const Real Lambda_5_5_p51 = 0.11985 * Lambda_5_5_p17;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p52 = 1605.1364365971108 * Lambda_5_5_p22;
  const Real Lambda_5_5_p53 = Lambda_5_5_p42 + Lambda_5_5_p7 * Lambda_5_5_p24 - Lambda_5_5_p8 *
      Lambda_5_5_p25 + Lambda_5_5_p6 * Lambda_5_5_p39;
  const Real Lambda_5_5_p54 = Lambda_5_5_p49 * Lambda_5_5_p26;
  const Real Lambda_5_5_p55 = 117.34209310833121 * Lambda_5_5_p17;
  const Real Lambda_5_5_p56 = Lambda_5_5_p53 * Lambda_5_5_p26;
  const Real Lambda_5_5_p57 = (1.0 - Lambda_5_5_p48) * Lambda_5_5_p13;
  const Real Lambda_5_5_p58 = Lambda_5_5_p47 - Lambda_5_5_p38 * Lambda_5_5_p41 - Lambda_5_5_p48 *
      Lambda_5_5_p49;
  const Real Lambda_5_5_p59 = Lambda_5_5_p13 * Lambda_5_5_p26;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_5_5_p60 = Lambda_5_5_p51 + Lambda_5_5_p14;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p61 = Lambda_5_5_p50 + Lambda_5_5_p40 - Lambda_5_5_p38 * Lambda_5_5_p39 -
      Lambda_5_5_p48 * Lambda_5_5_p53;
  const Real Lambda_5_5_p62 = 1.0 / (Lambda_5_5_p50 - Lambda_5_5_p38 * Lambda_5_5_p33 -
      Lambda_5_5_p48 * Lambda_5_5_p45);
  const Real Lambda_5_5_p63 = c5 * Lambda_5_5_p23;
  const Real Lambda_5_5_p64 = Lambda_5_5_p29 + Lambda_5_5_p38 * Lambda_5_5_p17 - Lambda_5_5_p48 *
      Lambda_5_5_p43;
  const Real Lambda_5_5_p65 = Lambda_5_5_p43 * Lambda_5_5_p26;
  const Real Lambda_5_5_p66 = 1.156008191975 * s2 + Lambda_5_5_p47 + Lambda_5_5_p7 * Lambda_5_5_p4 -
      Lambda_5_5_p44 * Lambda_5_5_p41 - Lambda_5_5_p56 * Lambda_5_5_p49;
  const Real Lambda_5_5_p67 = Lambda_5_5_p63 + Lambda_5_5_p6 * Lambda_5_5_p18;
  const Real Lambda_5_5_p68 = Lambda_5_5_p60 - Lambda_5_5_p48 * Lambda_5_5_p51;

  // link 6 (wrist_3), pose
  const Real Lambda_5_5_p69 = 0.11985 * Lambda_5_5_p18;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p70 = Lambda_5_5_p63 - Lambda_5_5_p38 * Lambda_5_5_p18 - Lambda_5_5_p48 *
      Lambda_5_5_p67;
  const Real Lambda_5_5_p71 = Lambda_5_5_p61 * Lambda_5_5_p62;
  const Real Lambda_5_5_p72 = Lambda_5_5_p58 * Lambda_5_5_p62;
  const Real Lambda_5_5_p73 = Lambda_5_5_p67 * Lambda_5_5_p26;
  const Real Lambda_5_5_p74 = Lambda_5_5_p57 * Lambda_5_5_p62;
  const Real Lambda_5_5_p75 = Lambda_5_5_p64 * Lambda_5_5_p62;
  const Real Lambda_5_5_p76 = Lambda_5_5_p70 * Lambda_5_5_p62;
  const Real Lambda_5_5_p77 = 0.11655 * c5;
  const Real Lambda_5_5_p78 = 0.11655 * Lambda_5_5_p23;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_5_5_p79 = Lambda_5_5_p69 - Lambda_5_5_p15;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p80 = 4.3866871861500005 + Lambda_5_5_p50 + 2.0 * Lambda_5_5_p40 -
      Lambda_5_5_p44 * Lambda_5_5_p39 - Lambda_5_5_p56 * Lambda_5_5_p53 - Lambda_5_5_p71 *
      Lambda_5_5_p61;
  const Real Lambda_5_5_p81 = Lambda_5_5_p66 - Lambda_5_5_p71 * Lambda_5_5_p58;
  const Real Lambda_5_5_p82 = Lambda_5_5_p37 - Lambda_5_5_p22 * Lambda_5_5_p27 - Lambda_5_5_p46 *
      Lambda_5_5_p41 - Lambda_5_5_p54 * Lambda_5_5_p49 - Lambda_5_5_p72 * Lambda_5_5_p58;
  const Real Lambda_5_5_p83 = (1.0 - Lambda_5_5_p56) * Lambda_5_5_p13 - Lambda_5_5_p71 *
      Lambda_5_5_p57;
  const Real Lambda_5_5_p84 = Lambda_5_5_p29 + Lambda_5_5_p44 * Lambda_5_5_p17 - Lambda_5_5_p56 *
      Lambda_5_5_p43 - Lambda_5_5_p71 * Lambda_5_5_p64;
  const Real Lambda_5_5_p85 = Lambda_5_5_p63 - Lambda_5_5_p44 * Lambda_5_5_p18 - Lambda_5_5_p56 *
      Lambda_5_5_p67 - Lambda_5_5_p71 * Lambda_5_5_p70;
  const Real Lambda_5_5_p86 = 1.0 - Lambda_5_5_p22 * Lambda_5_5_p22 + Lambda_5_5_p46 *
      Lambda_5_5_p17 - Lambda_5_5_p54 * Lambda_5_5_p43 - Lambda_5_5_p72 * Lambda_5_5_p64;
  const Real Lambda_5_5_p87 = Lambda_5_5_p60 + Lambda_5_5_p7 - Lambda_5_5_p56 * Lambda_5_5_p51 -
      Lambda_5_5_p71 * Lambda_5_5_p68;
  const Real Lambda_5_5_p88 = 1.0 / Lambda_5_5_p80;

  // link 3 (forearm), Jacobian
  const Real Lambda_5_5_p89 = Lambda_5_5_p79 - Lambda_5_5_p8;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p90 = 1605.1364365971108 * Lambda_5_5_p23 * Lambda_5_5_p23 +
      117.34209310833121 * Lambda_5_5_p18 * Lambda_5_5_p18 + Lambda_5_5_p73 * Lambda_5_5_p67 +
      Lambda_5_5_p76 * Lambda_5_5_p70;

  // link 1 (shoulder), turn
  const Real Lambda_5_5_p91 = 2.0 * c1;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p92 = Lambda_5_5_p81 * Lambda_5_5_p88;
  const Real Lambda_5_5_p93 = Lambda_5_5_p83 * Lambda_5_5_p88;
  const Real Lambda_5_5_p94 = Lambda_5_5_p84 * Lambda_5_5_p88;
  const Real Lambda_5_5_p95 = Lambda_5_5_p85 * Lambda_5_5_p88;
  const Real Lambda_5_5_p96 = Lambda_5_5_p29 - Lambda_5_5_p54 * Lambda_5_5_p13 - Lambda_5_5_p72 *
      Lambda_5_5_p57 - Lambda_5_5_p92 * Lambda_5_5_p83;
  const Real Lambda_5_5_p97 = Lambda_5_5_p86 - Lambda_5_5_p92 * Lambda_5_5_p84;
  const Real Lambda_5_5_p98 = Lambda_5_5_p22 * Lambda_5_5_p23 + Lambda_5_5_p46 * Lambda_5_5_p18 +
      Lambda_5_5_p54 * Lambda_5_5_p67 + Lambda_5_5_p72 * Lambda_5_5_p70 + Lambda_5_5_p92 *
      Lambda_5_5_p85;
  const Real Lambda_5_5_p99 = Lambda_5_5_p52 * Lambda_5_5_p22 + Lambda_5_5_p55 * Lambda_5_5_p17 +
      Lambda_5_5_p65 * Lambda_5_5_p43 + Lambda_5_5_p75 * Lambda_5_5_p64 + Lambda_5_5_p94 *
      Lambda_5_5_p84;
  const Real Lambda_5_5_p100 = Lambda_5_5_p52 * Lambda_5_5_p23 - Lambda_5_5_p55 * Lambda_5_5_p18 +
      Lambda_5_5_p65 * Lambda_5_5_p67 + Lambda_5_5_p75 * Lambda_5_5_p70 + Lambda_5_5_p94 *
      Lambda_5_5_p85;
  const Real Lambda_5_5_p101 = 0.17415 - Lambda_5_5_p54 * Lambda_5_5_p51 - Lambda_5_5_p72 *
      Lambda_5_5_p68 - Lambda_5_5_p92 * Lambda_5_5_p87;
  const Real Lambda_5_5_p102 = Lambda_5_5_p79 - Lambda_5_5_p48 * Lambda_5_5_p69;
  const Real Lambda_5_5_p103 = Lambda_5_5_p69 * Lambda_5_5_p26;
  const Real Lambda_5_5_p104 = Lambda_5_5_p82 - Lambda_5_5_p92 * Lambda_5_5_p81 - 2.0 *
      (Lambda_5_5_p28 + Lambda_5_5_p32) + (0.037099816387500005 * Lambda_5_5_p18 -
      (Lambda_5_5_p18 * (0.0012399999999999998 + Lambda_5_5_p11) + 0.021392421525 *
      Lambda_5_5_p23)) * Lambda_5_5_p18;
  const Real Lambda_5_5_p105 = Lambda_5_5_p102 * Lambda_5_5_p62;
  const Real Lambda_5_5_p106 = Lambda_5_5_p51 * Lambda_5_5_p26 * Lambda_5_5_p51 + Lambda_5_5_p68 *
      Lambda_5_5_p62 * Lambda_5_5_p68 + Lambda_5_5_p87 * Lambda_5_5_p88 * Lambda_5_5_p87;
  const Real Lambda_5_5_p107 = 1.0 / Lambda_5_5_p104;
  const Real Lambda_5_5_p108 = Lambda_5_5_p89 - Lambda_5_5_p56 * Lambda_5_5_p69 - Lambda_5_5_p71 *
      Lambda_5_5_p102;
  const Real Lambda_5_5_p109 = Lambda_5_5_p108 * Lambda_5_5_p88;
  const Real Lambda_5_5_p110 = Lambda_5_5_p54 * Lambda_5_5_p69 + Lambda_5_5_p72 * Lambda_5_5_p102 +
      Lambda_5_5_p92 * Lambda_5_5_p108;
  const Real Lambda_5_5_p111 = Lambda_5_5_p96 * Lambda_5_5_p107;
  const Real Lambda_5_5_p112 = Lambda_5_5_p97 * Lambda_5_5_p107;
  const Real Lambda_5_5_p113 = Lambda_5_5_p98 * Lambda_5_5_p107;
  const Real Lambda_5_5_p114 = Lambda_5_5_p89 * Lambda_5_5_p107;
  const Real Lambda_5_5_p115 = Lambda_5_5_p110 * Lambda_5_5_p107;
  const Real Lambda_5_5_p116 = Lambda_5_5_p112 * Lambda_5_5_p89;
  const Real Lambda_5_5_p117 = Lambda_5_5_p113 * Lambda_5_5_p89;
  const Real Lambda_5_5_p118 = Lambda_5_5_p111 * Lambda_5_5_p89;
  const Real Lambda_5_5_p119 = Lambda_5_5_p34 * c5 + Lambda_5_5_p59 * Lambda_5_5_p13 +
      Lambda_5_5_p74 * Lambda_5_5_p57 + Lambda_5_5_p93 * Lambda_5_5_p83 + Lambda_5_5_p111 *
      Lambda_5_5_p96;
  const Real Lambda_5_5_p120 = Lambda_5_5_p59 * Lambda_5_5_p43 - Lambda_5_5_p34 * Lambda_5_5_p22 +
      Lambda_5_5_p74 * Lambda_5_5_p64 + Lambda_5_5_p93 * Lambda_5_5_p84 + Lambda_5_5_p111 *
      Lambda_5_5_p97;
  const Real Lambda_5_5_p121 = Lambda_5_5_p99 + Lambda_5_5_p112 * Lambda_5_5_p97;
  const Real Lambda_5_5_p122 = Lambda_5_5_p100 - Lambda_5_5_p112 * Lambda_5_5_p98;
  const Real Lambda_5_5_p123 = Lambda_5_5_p90 + Lambda_5_5_p95 * Lambda_5_5_p85 + Lambda_5_5_p113 *
      Lambda_5_5_p98;
  const Real Lambda_5_5_p124 = Lambda_5_5_p59 * Lambda_5_5_p67 - Lambda_5_5_p34 * Lambda_5_5_p23 +
      Lambda_5_5_p74 * Lambda_5_5_p70 + Lambda_5_5_p93 * Lambda_5_5_p85 - Lambda_5_5_p111 *
      Lambda_5_5_p98;
  const Real Lambda_5_5_p125 = Lambda_5_5_p59 * Lambda_5_5_p51 + Lambda_5_5_p74 * Lambda_5_5_p68 +
      Lambda_5_5_p93 * Lambda_5_5_p87 + Lambda_5_5_p111 * Lambda_5_5_p101;
  const Real Lambda_5_5_p126 = Lambda_5_5_p65 * Lambda_5_5_p51 + Lambda_5_5_p75 * Lambda_5_5_p68 +
      Lambda_5_5_p94 * Lambda_5_5_p87 + Lambda_5_5_p112 * Lambda_5_5_p101;
  const Real Lambda_5_5_p127 = Lambda_5_5_p124 * Lambda_5_5_p36;
  const Real Lambda_5_5_p128 = Lambda_5_5_p122 * Lambda_5_5_p77;
  const Real Lambda_5_5_p129 = Lambda_5_5_p120 * Lambda_5_5_p78;
  const Real Lambda_5_5_p130 = Lambda_5_5_p65 * Lambda_5_5_p69 + Lambda_5_5_p75 * Lambda_5_5_p102 +
      Lambda_5_5_p94 * Lambda_5_5_p108 - Lambda_5_5_p112 * Lambda_5_5_p110;
  const Real Lambda_5_5_p131 = Lambda_5_5_p73 * Lambda_5_5_p69 + Lambda_5_5_p76 * Lambda_5_5_p102 +
      Lambda_5_5_p95 * Lambda_5_5_p108 + Lambda_5_5_p113 * Lambda_5_5_p110;
  const Real Lambda_5_5_p132 = Lambda_5_5_p59 * Lambda_5_5_p69 + Lambda_5_5_p74 * Lambda_5_5_p102 +
      Lambda_5_5_p93 * Lambda_5_5_p108 - Lambda_5_5_p111 * Lambda_5_5_p110;
  const Real Lambda_5_5_p133 = Lambda_5_5_p125 + (Lambda_5_5_p119 * Lambda_5_5_p36 +
      Lambda_5_5_p120 * Lambda_5_5_p77);
  const Real Lambda_5_5_p134 = Lambda_5_5_p126 + (Lambda_5_5_p120 * Lambda_5_5_p36 +
      Lambda_5_5_p121 * Lambda_5_5_p77);
  const Real Lambda_5_5_p135 = Lambda_5_5_p116 + (Lambda_5_5_p122 * Lambda_5_5_p36 -
      Lambda_5_5_p121 * Lambda_5_5_p78);
  const Real Lambda_5_5_p136 = Lambda_5_5_p117 - (Lambda_5_5_p123 * Lambda_5_5_p36 -
      Lambda_5_5_p122 * Lambda_5_5_p78);
  const Real Lambda_5_5_p137 = Lambda_5_5_p73 * Lambda_5_5_p51 + Lambda_5_5_p76 * Lambda_5_5_p68 +
      Lambda_5_5_p95 * Lambda_5_5_p87 - Lambda_5_5_p113 * Lambda_5_5_p101 +
      (Lambda_5_5_p127 + Lambda_5_5_p128);
  const Real Lambda_5_5_p138 = Lambda_5_5_p118 + (Lambda_5_5_p127 - Lambda_5_5_p129);
  const Real Lambda_5_5_p139 = Lambda_5_5_p130 - (Lambda_5_5_p128 + Lambda_5_5_p129);
  const Real Lambda_5_5_p140 = Lambda_5_5_p131 - (Lambda_5_5_p123 * Lambda_5_5_p77 +
      Lambda_5_5_p124 * Lambda_5_5_p78);
  const Real Lambda_5_5_p141 = Lambda_5_5_p103 * Lambda_5_5_p51 + Lambda_5_5_p105 * Lambda_5_5_p68 +
      Lambda_5_5_p109 * Lambda_5_5_p87 - Lambda_5_5_p115 * Lambda_5_5_p101 - Lambda_5_5_p78 *
      Lambda_5_5_p133;
  const Real Lambda_5_5_p142 = Lambda_5_5_p114 * Lambda_5_5_p101 + Lambda_5_5_p77 *
      Lambda_5_5_p116 - Lambda_5_5_p78 * Lambda_5_5_p134 + (Lambda_5_5_p118 + Lambda_5_5_p137) *
      Lambda_5_5_p36;

  // link 1 (shoulder), turn
  const Real Lambda_5_5_p143 = s1 * (Lambda_5_5_p137 + Lambda_5_5_p138) - c1 *
      (Lambda_5_5_p136 + Lambda_5_5_p133);

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p144 = Lambda_5_5_p106 + Lambda_5_5_p101 * Lambda_5_5_p107 *
      Lambda_5_5_p101 + (Lambda_5_5_p36 * (Lambda_5_5_p125 + Lambda_5_5_p133) + Lambda_5_5_p77 *
      (Lambda_5_5_p126 + Lambda_5_5_p134));

  // link 1 (shoulder), turn
  const Real Lambda_5_5_p145 = c1 * Lambda_5_5_p134 - s1 * Lambda_5_5_p135;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p146 = Lambda_5_5_p132 - (Lambda_5_5_p124 * Lambda_5_5_p77 +
      Lambda_5_5_p119 * Lambda_5_5_p78);
  const Real Lambda_5_5_p147 = Lambda_5_5_p114 * Lambda_5_5_p89 -
      (Lambda_5_5_p78 * (Lambda_5_5_p116 + Lambda_5_5_p135) + Lambda_5_5_p36 *
      (Lambda_5_5_p117 + Lambda_5_5_p136));
  const Real Lambda_5_5_p148 = Lambda_5_5_p141 + Lambda_5_5_p36 * Lambda_5_5_p132 +
      (Lambda_5_5_p130 - Lambda_5_5_p137) * Lambda_5_5_p77;
  const Real Lambda_5_5_p149 = Lambda_5_5_p114 * Lambda_5_5_p110 - Lambda_5_5_p77 *
      Lambda_5_5_p117 - Lambda_5_5_p36 * Lambda_5_5_p140 + (Lambda_5_5_p118 + Lambda_5_5_p139) *
      Lambda_5_5_p78;

  // link 1 (shoulder), turn
  const Real Lambda_5_5_p150 = c1 * Lambda_5_5_p143;
  const Real Lambda_5_5_p151 = s1 * Lambda_5_5_p143;
  const Real Lambda_5_5_p152 = Lambda_5_5_p150 + Lambda_5_5_p136;
  const Real Lambda_5_5_p153 = Lambda_5_5_p137 - Lambda_5_5_p151;
  const Real Lambda_5_5_p154 = c1 * Lambda_5_5_p148 + s1 * Lambda_5_5_p149;
  const Real Lambda_5_5_p155 = s1 * (Lambda_5_5_p144 - Lambda_5_5_p147) + Lambda_5_5_p91 *
      Lambda_5_5_p142;
  const Real Lambda_5_5_p156 = s1 * Lambda_5_5_p155;

  // link 1 (shoulder), mass matrix
  const Real Lambda_5_5_p157 = Lambda_5_5_p103 * Lambda_5_5_p69 + Lambda_5_5_p105 *
      Lambda_5_5_p102 + Lambda_5_5_p109 * Lambda_5_5_p108 + Lambda_5_5_p115 * Lambda_5_5_p110 -
      (Lambda_5_5_p77 * (Lambda_5_5_p131 + Lambda_5_5_p140) + Lambda_5_5_p78 *
      (Lambda_5_5_p132 + Lambda_5_5_p146));

  // link 1 (shoulder), turn
  const Real Lambda_5_5_p158 = s1 * (Lambda_5_5_p123 - Lambda_5_5_p119) - Lambda_5_5_p91 *
      Lambda_5_5_p124;
  const Real Lambda_5_5_p159 = s1 * Lambda_5_5_p158;
  const Real Lambda_5_5_p160 = c1 * Lambda_5_5_p155 - Lambda_5_5_p142;
  const Real Lambda_5_5_p161 = 1.0 / (Lambda_5_5_p144 - Lambda_5_5_p156);
  const Real Lambda_5_5_p162 = Lambda_5_5_p145 * Lambda_5_5_p161;
  const Real Lambda_5_5_p163 = Lambda_5_5_p152 * Lambda_5_5_p161;
  const Real Lambda_5_5_p164 = Lambda_5_5_p153 * Lambda_5_5_p161;
  const Real Lambda_5_5_p165 = Lambda_5_5_p154 * Lambda_5_5_p161;
  const Real Lambda_5_5_p166 = Lambda_5_5_p160 * Lambda_5_5_p161;
  const Lanes<8> Lambda_5_5_p186_lanes = detail::make_pack<Real>(Lambda_5_5_p147 + Lambda_5_5_p156,
      Lambda_5_5_p147 + Lambda_5_5_p156, s1 * Lambda_5_5_p148 - c1 * Lambda_5_5_p149,
      Lambda_5_5_p150 + Lambda_5_5_p133, Lambda_5_5_p151 - Lambda_5_5_p138, s1 * Lambda_5_5_p134 +
      c1 * Lambda_5_5_p135, Lambda_5_5_p147 + Lambda_5_5_p156, Lambda_5_5_p147 + Lambda_5_5_p156) -
      detail::make_pack<Real>(Lambda_5_5_p166, Lambda_5_5_p166, Lambda_5_5_p165, Lambda_5_5_p164,
      Lambda_5_5_p163, Lambda_5_5_p162, Lambda_5_5_p166, Lambda_5_5_p166) * Lambda_5_5_p160;
  const Real Lambda_5_5_p191 = 1.0 / Lambda_5_5_p186_lanes[1];
  const Lanes<8> Lambda_5_5_p192_lanes = Lambda_5_5_p186_lanes * Lambda_5_5_p191;
  const Real Lambda_0_0_p1 = Lambda_5_5_p166 * Lambda_5_5_p191;
  const Lanes<8> Lambda_5_5_p203_lanes = detail::make_pack<Real>(Lambda_5_5_p157, Lambda_5_5_p157,
      Lambda_5_5_p157, c1 * Lambda_5_5_p140 + s1 * Lambda_5_5_p146, s1 * Lambda_5_5_p140 - c1 *
      Lambda_5_5_p146, Lambda_5_5_p139, Lambda_5_5_p157, Lambda_5_5_p157) -
      detail::make_pack<Real>(Lambda_5_5_p165, Lambda_5_5_p165, Lambda_5_5_p165, Lambda_5_5_p164,
      Lambda_5_5_p163, Lambda_5_5_p162, Lambda_5_5_p165, Lambda_5_5_p165) * Lambda_5_5_p154 -
      Lambda_5_5_p192_lanes * Lambda_5_5_p186_lanes[2];
  const Real Lambda_0_0_p2 = Lambda_5_5_p192_lanes[2] * Lambda_5_5_p166 - Lambda_5_5_p165;
  const Real Lambda_5_5_p210 = 1.0 / Lambda_5_5_p203_lanes[2];
  const Lanes<8> Lambda_5_5_p211_lanes = Lambda_5_5_p203_lanes * Lambda_5_5_p210;
  const Real Lambda_0_0_p3 = Lambda_0_0_p2 * Lambda_5_5_p210;
  const Real Lambda_0_1_p1 = Lambda_5_5_p192_lanes[2] * Lambda_5_5_p210;
  const Lanes<8> Lambda_5_5_p217_lanes = detail::make_pack<Real>(Lambda_5_5_p123 - Lambda_5_5_p159,
      Lambda_5_5_p123 - Lambda_5_5_p159, Lambda_5_5_p123 - Lambda_5_5_p159, Lambda_5_5_p123 -
      Lambda_5_5_p159, c1 * Lambda_5_5_p158 + Lambda_5_5_p124, c1 * Lambda_5_5_p122 + s1 *
      Lambda_5_5_p120, Lambda_5_5_p123 - Lambda_5_5_p159, Lambda_5_5_p123 - Lambda_5_5_p159) -
      detail::make_pack<Real>(Lambda_5_5_p164, Lambda_5_5_p164, Lambda_5_5_p164, Lambda_5_5_p164,
      Lambda_5_5_p163, Lambda_5_5_p162, Lambda_5_5_p164, Lambda_5_5_p164) * Lambda_5_5_p153 -
      Lambda_5_5_p192_lanes * Lambda_5_5_p186_lanes[3] - Lambda_5_5_p211_lanes *
      Lambda_5_5_p203_lanes[3];
  const Real Lambda_5_5_p220 = s1 * Lambda_5_5_p122 - c1 * Lambda_5_5_p120 - Lambda_5_5_p162 *
      Lambda_5_5_p152 - Lambda_5_5_p192_lanes[5] * Lambda_5_5_p186_lanes[4] -
      Lambda_5_5_p211_lanes[5] * Lambda_5_5_p203_lanes[4];
  const Real Lambda_0_0_p4 = Lambda_5_5_p192_lanes[3] * Lambda_5_5_p166 - Lambda_5_5_p164 -
      Lambda_5_5_p211_lanes[3] * Lambda_0_0_p2;
  const Real Lambda_0_1_p2 = Lambda_5_5_p211_lanes[3] * Lambda_5_5_p192_lanes[2] -
      Lambda_5_5_p192_lanes[3];
  const Real Lambda_5_5_p221 = 1.0 / Lambda_5_5_p217_lanes[3];
  const Real Lambda_5_5_p222 = Lambda_5_5_p217_lanes[4] * Lambda_5_5_p221;
  const Real Lambda_5_5_p223 = Lambda_5_5_p217_lanes[5] * Lambda_5_5_p221;
  const Real Lambda_0_0_p5 = Lambda_0_0_p4 * Lambda_5_5_p221;
  const Real Lambda_0_1_p3 = Lambda_0_1_p2 * Lambda_5_5_p221;
  const Real Lambda_0_2_p1 = Lambda_5_5_p211_lanes[3] * Lambda_5_5_p221;
  const Real Lambda_5_5_p224 = Lambda_5_5_p119 + Lambda_5_5_p159 - Lambda_5_5_p163 *
      Lambda_5_5_p152 - Lambda_5_5_p192_lanes[4] * Lambda_5_5_p186_lanes[4] -
      Lambda_5_5_p211_lanes[4] * Lambda_5_5_p203_lanes[4] - Lambda_5_5_p222 *
      Lambda_5_5_p217_lanes[4];
  const Real Lambda_5_5_p225 = Lambda_5_5_p220 - Lambda_5_5_p223 * Lambda_5_5_p217_lanes[4];
  const Real Lambda_5_5_p226 = Lambda_5_5_p121 - Lambda_5_5_p162 * Lambda_5_5_p145 -
      Lambda_5_5_p192_lanes[5] * Lambda_5_5_p186_lanes[5] - Lambda_5_5_p211_lanes[5] *
      Lambda_5_5_p203_lanes[5] - Lambda_5_5_p223 * Lambda_5_5_p217_lanes[5];
  const Real Lambda_0_0_p6 = Lambda_5_5_p192_lanes[4] * Lambda_5_5_p166 - Lambda_5_5_p163 -
      Lambda_5_5_p211_lanes[4] * Lambda_0_0_p2 - Lambda_5_5_p222 * Lambda_0_0_p4;
  const Real Lambda_0_1_p4 = Lambda_5_5_p211_lanes[4] * Lambda_5_5_p192_lanes[2] -
      Lambda_5_5_p192_lanes[4] - Lambda_5_5_p222 * Lambda_0_1_p2;
  const Real Lambda_0_2_p2 = Lambda_5_5_p222 * Lambda_5_5_p211_lanes[3] - Lambda_5_5_p211_lanes[4];
  const Real Lambda_5_5_p227 = 1.0 / Lambda_5_5_p224;
  const Real Lambda_5_5_p228 = Lambda_5_5_p225 * Lambda_5_5_p227;
  const Real Lambda_0_0_p7 = Lambda_0_0_p6 * Lambda_5_5_p227;
  const Real Lambda_0_1_p5 = Lambda_0_1_p4 * Lambda_5_5_p227;
  const Real Lambda_0_2_p3 = Lambda_0_2_p2 * Lambda_5_5_p227;
  const Real Lambda_0_3_p1 = Lambda_5_5_p222 * Lambda_5_5_p227;
  const Real Lambda_0_5_p1 = Lambda_5_5_p192_lanes[5] * Lambda_5_5_p166 - Lambda_5_5_p162 -
      Lambda_5_5_p211_lanes[5] * Lambda_0_0_p2 - Lambda_5_5_p223 * Lambda_0_0_p4 - Lambda_5_5_p228 *
      Lambda_0_0_p6;
  const Real Lambda_1_5_p1 = Lambda_5_5_p211_lanes[5] * Lambda_5_5_p192_lanes[2] -
      Lambda_5_5_p192_lanes[5] - Lambda_5_5_p223 * Lambda_0_1_p2 - Lambda_5_5_p228 * Lambda_0_1_p4;
  const Real Lambda_2_5_p1 = Lambda_5_5_p223 * Lambda_5_5_p211_lanes[3] - Lambda_5_5_p211_lanes[5] -
      Lambda_5_5_p228 * Lambda_0_2_p2;
  const Real Lambda_3_5_p1 = Lambda_5_5_p228 * Lambda_5_5_p222 - Lambda_5_5_p223;
  const Real Lambda_0_0_p8 = Lambda_5_5_p161 + Lambda_0_0_p1 * Lambda_5_5_p166 + Lambda_0_0_p3 *
      Lambda_0_0_p2 + Lambda_0_0_p5 * Lambda_0_0_p4 + Lambda_0_0_p7 * Lambda_0_0_p6;
  const Real Lambda_5_5 = 1.0 / (Lambda_5_5_p226 - Lambda_5_5_p228 * Lambda_5_5_p225);
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
  const Real Lambda_4_5 = Lambda_5_5_p228 * Lambda_5_5;
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
  Lambda[7] = Lambda_5_5_p191 + Lambda_0_1_p1 * Lambda_5_5_p192_lanes[2] + Lambda_0_1_p3 *
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
  Lambda[14] = Lambda_5_5_p210 + Lambda_0_2_p1 * Lambda_5_5_p211_lanes[3] + Lambda_0_2_p3 *
      Lambda_0_2_p2 + Lambda_2_5 * Lambda_2_5_p1;
  const Real Lambda_2_3 = Lambda_3_5 * Lambda_2_5_p1 -
      (Lambda_0_2_p1 + Lambda_0_3_p1 * Lambda_0_2_p2);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p3 - Lambda_4_5 * Lambda_2_5_p1;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_5_5_p221 + Lambda_0_3_p1 * Lambda_5_5_p222 + Lambda_3_5 * Lambda_3_5_p1;
  const Real Lambda_3_4 = Lambda_0_3_p1 + Lambda_4_5 * Lambda_3_5_p1;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_5_5_p227 + Lambda_4_5 * Lambda_5_5_p228;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
