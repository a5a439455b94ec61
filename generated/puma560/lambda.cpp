// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J from poses, in the axes of link 1 (link1) at link origins.
// 818 flops (add 345, mul 463, div 10), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

template <int count>
using Lanes = detail::Pack<Real, count>;
void lambda(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
  const Real angles[5] = {q[2], q[1], q[3], q[4], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real s2 = sines[1];
  const Real s3 = sines[0];
  const Real c2 = cosines[1];
  const Real s4 = sines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];
  const Real c4 = cosines[2];
  const Real s1 = sines[4];
  const Real c1 = cosines[4];

  // link 5 (link5), composite inertia
  const Real Lambda_0_5_p1 = 0.00020215999999999998 * s5;
  const Real Lambda_0_5_p2 = s5 * Lambda_0_5_p1;

  // link 4 (link4), composite inertia
  const Real Lambda_0_5_p3 = s4 * (0.00010000000000000026 + Lambda_0_5_p2);
  const Real Lambda_0_5_p4 = s4 * Lambda_0_5_p3;
  const Real Lambda_0_5_p5 = 0.3056901365 + (0.0011921599999999998 - Lambda_0_5_p2 + Lambda_0_5_p4 +
      0.0024946559999999996 * c5);

  // link 5 (link5), composite inertia
  const Real Lambda_0_5_p6 = 0.00164 + Lambda_0_5_p2;
  const Real Lambda_0_5_p7 = 0.0028799999999999997 * s5;

  // link 4 (link4), composite inertia
  const Real Lambda_0_5_p8 = c4 * Lambda_0_5_p7;
  const Real Lambda_0_5_p9 = 0.0067651125 + (Lambda_0_5_p6 - 0.0406 * Lambda_0_5_p8);

  // link 5 (link5), composite inertia
  const Real Lambda_0_5_p10 = c5 * Lambda_0_5_p1;

  // link 4 (link4), mass matrix
  const Real Lambda_0_5_p11 = c4 * Lambda_0_5_p10 + 0.4331 * Lambda_0_5_p8;

  // link 4 (link4), composite inertia
  const Real Lambda_0_5_p12 = Lambda_0_5_p11 - 5.846399999999999e-05 * c5 - 0.010673638499999999;

  // link 3 (link3), composite inertia
  const Real Lambda_0_5_p13 = s3 * (Lambda_0_5_p5 - Lambda_0_5_p9) + c3 * (2.0 * Lambda_0_5_p12);
  const Real Lambda_0_5_p14 = s3 * Lambda_0_5_p13;

  // link 4 (link4), composite inertia
  const Real Lambda_0_5_p15 = s4 * Lambda_0_5_p7;

  // link 5 (link5), composite inertia
  const Real Lambda_0_5_p16 = 0.0028799999999999997 * c5;

  // link 4 (link4), composite inertia
  const Real Lambda_0_5_p17 = 0.861795 + Lambda_0_5_p16;
  const Real Lambda_0_5_p18 = Lambda_0_5_p8 - 0.025374999999999998;

  // link 3 (link3), mass matrix
  const Real Lambda_0_5_p19 = s3 * Lambda_0_5_p17 + c3 * Lambda_0_5_p18;
  const Real Lambda_0_5_p20 = 0.4318 * Lambda_0_5_p19;

  // link 4 (link4), mass matrix
  const Real Lambda_0_5_p21 = 0.1501 * Lambda_0_5_p15;

  // link 3 (link3), composite inertia
  const Real Lambda_0_5_p22 = 1.674987602 + (Lambda_0_5_p9 + Lambda_0_5_p14 + 2.0 *
      (Lambda_0_5_p20 + Lambda_0_5_p21));

  // link 3 (link3), mass matrix
  const Real Lambda_0_5_p23 = c3 * Lambda_0_5_p17 - s3 * Lambda_0_5_p18;

  // link 2 (link2), composite inertia
  const Real Lambda_0_5_p24 = s2 * (0.07312640000000001 +
      (Lambda_0_5_p5 - Lambda_0_5_p14 + 0.3002 * Lambda_0_5_p15) - Lambda_0_5_p22) + c2 *
      (2.0 * (c3 * Lambda_0_5_p13 - Lambda_0_5_p12 + 0.4318 * Lambda_0_5_p23 - 0.0070992));

  // link 6 (link6), mass matrix
  const Real Lambda_0_5_p25 = 4e-05 * s5;
  const Real Lambda_0_5_p26 = c4 * Lambda_0_5_p25;
  const Real Lambda_0_5_p27 = 4e-05 * c5;
  const Real Lambda_0_5_p28 = s2 * (c3 * Lambda_0_5_p26 + s3 * Lambda_0_5_p27) + c2 *
      (s3 * Lambda_0_5_p26 - c3 * Lambda_0_5_p27);

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p29 = 24999.999999999996 * Lambda_0_5_p28;

  // link 5 (link5), mass matrix
  const Real Lambda_0_5_p30 = s4 * Lambda_0_5_p16;
  const Real Lambda_0_5_p31 = 0.00064216 * s4 + 0.4331 * Lambda_0_5_p30;
  const Real Lambda_0_5_p32 = 0.0203 * Lambda_0_5_p30;
  const Real Lambda_0_5_p33 = c4 * Lambda_0_5_p16;
  const Real Lambda_0_5_p34 = s3 * Lambda_0_5_p33 + c3 * Lambda_0_5_p7;
  const Real Lambda_0_5_p35 = c3 * Lambda_0_5_p32 - s3 * Lambda_0_5_p31 +
      (0.1501 * (c3 * Lambda_0_5_p33 - s3 * Lambda_0_5_p7) - 0.4318 * Lambda_0_5_p30);
  const Real Lambda_0_5_p36 = s2 * (c3 * Lambda_0_5_p31 + s3 * Lambda_0_5_p32 + 0.1501 *
      Lambda_0_5_p34) - c2 * Lambda_0_5_p35;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p37 = 1557.24430048586 * Lambda_0_5_p36;

  // link 4 (link4), composite inertia
  const Real Lambda_0_5_p38 = 0.0203 * Lambda_0_5_p8;

  // link 4 (link4), mass matrix
  const Real Lambda_0_5_p39 = Lambda_0_5_p38 - Lambda_0_5_p6;
  const Real Lambda_0_5_p40 = s3 * Lambda_0_5_p15;
  const Real Lambda_0_5_p41 = s2 * (0.1501 * Lambda_0_5_p40 -
      (c3 * Lambda_0_5_p11 + s3 * Lambda_0_5_p39)) + c2 *
      ((Lambda_0_5_p39 - Lambda_0_5_p21) * c3 - (s3 * Lambda_0_5_p11 + 0.4318 * Lambda_0_5_p8));

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p42 = 0.9999999999999999 * c5;
  const Real Lambda_0_5_p43 = Lambda_0_5_p42 * Lambda_0_5_p28 - Lambda_0_5_p41;
  const Real Lambda_0_5_p44 = 1.0 / (Lambda_0_5_p6 - Lambda_0_5_p42 * Lambda_0_5_p27);
  const Real Lambda_0_5_p45 = Lambda_0_5_p43 * Lambda_0_5_p44;
  const Real Lambda_0_5_p46 = 1.4717295504999999 + (Lambda_0_5_p22 + s2 * Lambda_0_5_p24) -
      Lambda_0_5_p29 * Lambda_0_5_p28 - Lambda_0_5_p37 * Lambda_0_5_p36 - Lambda_0_5_p45 *
      Lambda_0_5_p43;

  // link 4 (link4), composite inertia
  const Real Lambda_0_5_p47 = 0.0203 * Lambda_0_5_p15 - c4 * Lambda_0_5_p3;
  const Real Lambda_0_5_p48 = s4 * Lambda_0_5_p10 + 0.4331 * Lambda_0_5_p15;
  const Real Lambda_0_5_p49 = 0.004704000000000001 + Lambda_0_5_p48;

  // link 3 (link3), mass matrix
  const Real Lambda_0_5_p50 = c3 * Lambda_0_5_p47 - s3 * Lambda_0_5_p49 - 0.1501 * Lambda_0_5_p19;
  const Real Lambda_0_5_p51 = s3 * Lambda_0_5_p47 + c3 * Lambda_0_5_p49 + 0.1501 * Lambda_0_5_p23;

  // link 6 (link6), mass matrix
  const Real Lambda_0_5_p52 = s4 * Lambda_0_5_p25;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p53 = 24999.999999999996 * Lambda_0_5_p52;
  const Real Lambda_0_5_p54 = Lambda_0_5_p53 * Lambda_0_5_p28;

  // link 5 (link5), mass matrix
  const Real Lambda_0_5_p55 = 0.00064216 * c4 + (0.4331 * Lambda_0_5_p33 - 5.846399999999999e-05 *
      s5);

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p56 = 1557.24430048586 * Lambda_0_5_p55;
  const Real Lambda_0_5_p57 = Lambda_0_5_p48 + Lambda_0_5_p42 * Lambda_0_5_p52;
  const Real Lambda_0_5_p58 = Lambda_0_5_p57 * Lambda_0_5_p44;
  const Real Lambda_0_5_p59 = Lambda_0_5_p54 - (s2 * Lambda_0_5_p50 + c2 * Lambda_0_5_p51) -
      Lambda_0_5_p56 * Lambda_0_5_p36 + Lambda_0_5_p58 * Lambda_0_5_p43;
  const Real Lambda_0_5_p60 = 0.312455249 + (0.00129216 - Lambda_0_5_p4 + 2.0 *
      (0.0012473279999999998 * c5 - Lambda_0_5_p38)) - Lambda_0_5_p53 * Lambda_0_5_p52;
  const Real Lambda_0_5_p61 = 1.0 / (Lambda_0_5_p60 - Lambda_0_5_p56 * Lambda_0_5_p55 -
      Lambda_0_5_p58 * Lambda_0_5_p57);
  const Real Lambda_0_5_p62 = Lambda_0_5_p59 * Lambda_0_5_p61;

  // link 5 (link5), mass matrix
  const Real Lambda_0_5_p63 = Lambda_0_5_p55 + 0.4318 * Lambda_0_5_p34;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p64 = Lambda_0_5_p57 + 0.4318 * Lambda_0_5_p40;
  const Real Lambda_0_5_p65 = Lambda_0_5_p60 + Lambda_0_5_p20 - Lambda_0_5_p56 * Lambda_0_5_p63 -
      Lambda_0_5_p58 * Lambda_0_5_p64;
  const Real Lambda_0_5_p66 = Lambda_0_5_p65 * Lambda_0_5_p61;
  const Real Lambda_0_5_p67 = Lambda_0_5_p54 - (s2 *
      (Lambda_0_5_p50 - 0.4318 * Lambda_0_5_p15 - 0.690314699) + c2 *
      (Lambda_0_5_p51 - 0.023750999999999998));
  const Real Lambda_0_5_p68 = 1557.24430048586 * Lambda_0_5_p63;
  const Real Lambda_0_5_p69 = Lambda_0_5_p64 * Lambda_0_5_p44;
  const Real Lambda_0_5_p70 = Lambda_0_5_p67 - Lambda_0_5_p68 * Lambda_0_5_p36 + Lambda_0_5_p69 *
      Lambda_0_5_p43 - Lambda_0_5_p66 * Lambda_0_5_p59;
  const Real Lambda_0_5_p71 = 1.7481140020000001 + Lambda_0_5_p60 + 0.8636 * Lambda_0_5_p19 -
      Lambda_0_5_p68 * Lambda_0_5_p63 - Lambda_0_5_p69 * Lambda_0_5_p64 - Lambda_0_5_p66 *
      Lambda_0_5_p65;
  const Real Lambda_0_5_p72 = 1.0 / Lambda_0_5_p71;
  const Real Lambda_0_5_p73 = Lambda_0_5_p70 * Lambda_0_5_p72;
  const Real Lambda_0_5_p74 = 1.0 / (Lambda_0_5_p46 - Lambda_0_5_p62 * Lambda_0_5_p59 -
      Lambda_0_5_p73 * Lambda_0_5_p70);

  // link 3 (link3), pose
  const Real Lambda_0_5_p75 = c3 * s2 + s3 * c2;

  // link 5 (link5), pose
  const Real Lambda_0_5_p76 = s5 * c4;

  // link 3 (link3), pose
  const Real Lambda_0_5_p77 = s3 * s2 - c3 * c2;

  // link 5 (link5), pose
  const Real Lambda_0_5_p78 = Lambda_0_5_p76 * Lambda_0_5_p75 + c5 * Lambda_0_5_p77;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p79 = Lambda_0_5_p53 * Lambda_0_5_p78;

  // link 4 (link4), pose
  const Real Lambda_0_5_p80 = s4 * Lambda_0_5_p75;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p81 = Lambda_0_5_p42 * Lambda_0_5_p78 - Lambda_0_5_p77;
  const Real Lambda_0_5_p82 = Lambda_0_5_p79 - Lambda_0_5_p56 * Lambda_0_5_p80 + Lambda_0_5_p58 *
      Lambda_0_5_p81;
  const Real Lambda_0_5_p83 = Lambda_0_5_p79 - Lambda_0_5_p68 * Lambda_0_5_p80 + Lambda_0_5_p69 *
      Lambda_0_5_p81 - Lambda_0_5_p66 * Lambda_0_5_p82;
  const Real Lambda_0_5_p84 = 1.0 - Lambda_0_5_p29 * Lambda_0_5_p78 - Lambda_0_5_p37 *
      Lambda_0_5_p80 - Lambda_0_5_p45 * Lambda_0_5_p81 - Lambda_0_5_p62 * Lambda_0_5_p82;
  const Real Lambda_0_5_p85 = Lambda_0_5_p84 - Lambda_0_5_p73 * Lambda_0_5_p83;
  const Real Lambda_0_5_p86 = Lambda_0_5_p85 * Lambda_0_5_p74;
  const Real Lambda_0_5_p87 = Lambda_0_5_p83 * Lambda_0_5_p72;
  const Real Lambda_0_5_p88 = Lambda_0_5_p82 * Lambda_0_5_p61;
  const Real Lambda_0_5_p89 = 24999.999999999996 * Lambda_0_5_p78;
  const Real Lambda_0_5_p90 = 1557.24430048586 * Lambda_0_5_p80;
  const Real Lambda_0_5_p91 = Lambda_0_5_p81 * Lambda_0_5_p44;
  const Real Lambda_0_5_p92 = Lambda_0_5_p89 * Lambda_0_5_p78 + Lambda_0_5_p90 * Lambda_0_5_p80 +
      Lambda_0_5_p91 * Lambda_0_5_p81 + Lambda_0_5_p88 * Lambda_0_5_p82 + Lambda_0_5_p87 *
      Lambda_0_5_p83;
  const Real Lambda_0_5_p93 = Lambda_0_5_p92 + Lambda_0_5_p86 * Lambda_0_5_p85;

  // link 5 (link5), pose
  const Real Lambda_0_5_p94 = s5 * s4;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p95 = 0.05625 * Lambda_0_5_p94;
  const Real Lambda_0_5_p96 = 1.0 - Lambda_0_5_p53 * Lambda_0_5_p94;
  const Real Lambda_0_5_p97 = Lambda_0_5_p42 * Lambda_0_5_p94;
  const Real Lambda_0_5_p98 = Lambda_0_5_p96 - Lambda_0_5_p56 * c4 - Lambda_0_5_p58 *
      Lambda_0_5_p97;
  const Real Lambda_0_5_p99 = Lambda_0_5_p96 - Lambda_0_5_p68 * c4 - Lambda_0_5_p69 *
      Lambda_0_5_p97 - Lambda_0_5_p66 * Lambda_0_5_p98;
  const Real Lambda_0_5_p100 = Lambda_0_5_p29 * Lambda_0_5_p94 - Lambda_0_5_p37 * c4 +
      Lambda_0_5_p45 * Lambda_0_5_p97 - Lambda_0_5_p62 * Lambda_0_5_p98 - Lambda_0_5_p73 *
      Lambda_0_5_p99;
  const Real Lambda_0_5_p101 = Lambda_0_5_p90 * c4 - Lambda_0_5_p89 * Lambda_0_5_p94 -
      Lambda_0_5_p91 * Lambda_0_5_p97 + Lambda_0_5_p88 * Lambda_0_5_p98 + Lambda_0_5_p87 *
      Lambda_0_5_p99;
  const Real Lambda_0_5_p102 = Lambda_0_5_p101 + Lambda_0_5_p86 * Lambda_0_5_p100;
  const Real Lambda_0_5_p103 = 0.05625 * Lambda_0_5_p78;

  // link 4 (link4), pose
  const Real Lambda_0_5_p104 = 0.0203 * Lambda_0_5_p75 - 0.4331 * Lambda_0_5_p77;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p105 = (1.0 - Lambda_0_5_p66) * Lambda_0_5_p104 - 0.4318 * s2;
  const Real Lambda_0_5_p106 = 0.1501 + Lambda_0_5_p62 * Lambda_0_5_p104 + Lambda_0_5_p73 *
      Lambda_0_5_p105;
  const Real Lambda_0_5_p107 = Lambda_0_5_p88 * Lambda_0_5_p104 + Lambda_0_5_p87 * Lambda_0_5_p105 -
      Lambda_0_5_p86 * Lambda_0_5_p106;
  const Real Lambda_0_5_p108 = Lambda_0_5_p107 - (Lambda_0_5_p93 * Lambda_0_5_p95 +
      Lambda_0_5_p102 * Lambda_0_5_p103);
  const Real Lambda_0_5_p109 = Lambda_0_5_p100 * Lambda_0_5_p74;
  const Real Lambda_0_5_p110 = Lambda_0_5_p99 * Lambda_0_5_p72;
  const Real Lambda_0_5_p111 = Lambda_0_5_p98 * Lambda_0_5_p61;
  const Real Lambda_0_5_p112 = Lambda_0_5_p97 * Lambda_0_5_p44;
  const Real Lambda_0_5_p113 = 24999.999999999996 * Lambda_0_5_p94;
  const Real Lambda_0_5_p114 = 1557.24430048586 * c4;
  const Real Lambda_0_5_p115 = Lambda_0_5_p113 * Lambda_0_5_p94 + Lambda_0_5_p114 * c4 +
      Lambda_0_5_p112 * Lambda_0_5_p97 + Lambda_0_5_p111 * Lambda_0_5_p98 + Lambda_0_5_p110 *
      Lambda_0_5_p99;
  const Real Lambda_0_5_p116 = Lambda_0_5_p115 + Lambda_0_5_p109 * Lambda_0_5_p100;
  const Real Lambda_0_5_p117 = Lambda_0_5_p111 * Lambda_0_5_p104 + Lambda_0_5_p110 *
      Lambda_0_5_p105 - Lambda_0_5_p109 * Lambda_0_5_p106;
  const Real Lambda_0_5_p118 = Lambda_0_5_p117 - (Lambda_0_5_p102 * Lambda_0_5_p95 +
      Lambda_0_5_p116 * Lambda_0_5_p103);
  const Real Lambda_0_5_p119 = Lambda_0_5_p104 * Lambda_0_5_p61 * Lambda_0_5_p104 +
      Lambda_0_5_p105 * Lambda_0_5_p72 * Lambda_0_5_p105 + Lambda_0_5_p106 * Lambda_0_5_p74 *
      Lambda_0_5_p106;
  const Real Lambda_0_5_p120 = Lambda_0_5_p119 - (Lambda_0_5_p95 *
      (Lambda_0_5_p107 + Lambda_0_5_p108) + Lambda_0_5_p103 * (Lambda_0_5_p117 + Lambda_0_5_p118));

  // link 5 (link5), pose
  const Real Lambda_0_5_p121 = c5 * Lambda_0_5_p75 - Lambda_0_5_p76 * Lambda_0_5_p77;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p122 = Lambda_0_5_p75 - Lambda_0_5_p42 * Lambda_0_5_p121;

  // link 4 (link4), pose
  const Real Lambda_0_5_p123 = s4 * Lambda_0_5_p77;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p124 = Lambda_0_5_p53 * Lambda_0_5_p121;
  const Real Lambda_0_5_p125 = Lambda_0_5_p58 * Lambda_0_5_p122 -
      (Lambda_0_5_p56 * Lambda_0_5_p123 + Lambda_0_5_p124);
  const Real Lambda_0_5_p126 = Lambda_0_5_p69 * Lambda_0_5_p122 -
      (Lambda_0_5_p68 * Lambda_0_5_p123 + Lambda_0_5_p124) - Lambda_0_5_p66 * Lambda_0_5_p125;
  const Real Lambda_0_5_p127 = Lambda_0_5_p29 * Lambda_0_5_p121 - Lambda_0_5_p37 * Lambda_0_5_p123 -
      Lambda_0_5_p45 * Lambda_0_5_p122 - Lambda_0_5_p62 * Lambda_0_5_p125 - Lambda_0_5_p73 *
      Lambda_0_5_p126;
  const Real Lambda_0_5_p128 = Lambda_0_5_p127 * Lambda_0_5_p74;
  const Real Lambda_0_5_p129 = Lambda_0_5_p126 * Lambda_0_5_p72;
  const Real Lambda_0_5_p130 = Lambda_0_5_p125 * Lambda_0_5_p61;
  const Real Lambda_0_5_p131 = 24999.999999999996 * Lambda_0_5_p121 * Lambda_0_5_p121 +
      1557.24430048586 * Lambda_0_5_p123 * Lambda_0_5_p123 + Lambda_0_5_p122 * Lambda_0_5_p44 *
      Lambda_0_5_p122;
  const Real Lambda_0_5_p132 = Lambda_0_5_p131 + Lambda_0_5_p130 * Lambda_0_5_p125 +
      Lambda_0_5_p129 * Lambda_0_5_p126 + Lambda_0_5_p128 * Lambda_0_5_p127;
  const Real Lambda_0_5_p133 = Lambda_0_5_p91 * Lambda_0_5_p122 -
      (Lambda_0_5_p89 * Lambda_0_5_p121 - Lambda_0_5_p90 * Lambda_0_5_p123) + Lambda_0_5_p88 *
      Lambda_0_5_p125 + Lambda_0_5_p87 * Lambda_0_5_p126;
  const Real Lambda_0_5_p134 = Lambda_0_5_p133 + Lambda_0_5_p86 * Lambda_0_5_p127;
  const Real Lambda_0_5_p135 = 0.05625 * Lambda_0_5_p121;

  // link 4 (link4), pose
  const Real Lambda_0_5_p136 = 0.4331 * Lambda_0_5_p75 + 0.0203 * Lambda_0_5_p77;

  // link 3 (link3), Jacobian
  const Real Lambda_0_5_p137 = Lambda_0_5_p136 + 0.4318 * c2;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p138 = Lambda_0_5_p128 * Lambda_0_5_p137;
  const Real Lambda_0_5_p139 = Lambda_0_5_p138 + (Lambda_0_5_p132 * Lambda_0_5_p103 +
      Lambda_0_5_p134 * Lambda_0_5_p135);
  const Real Lambda_0_5_p140 = Lambda_0_5_p86 * Lambda_0_5_p137;
  const Real Lambda_0_5_p141 = Lambda_0_5_p140 + (Lambda_0_5_p134 * Lambda_0_5_p103 +
      Lambda_0_5_p93 * Lambda_0_5_p135);
  const Real Lambda_0_5_p142 = Lambda_0_5_p137 * Lambda_0_5_p74;
  const Real Lambda_0_5_p143 = Lambda_0_5_p142 * Lambda_0_5_p137 +
      (Lambda_0_5_p103 * (Lambda_0_5_p138 + Lambda_0_5_p139) + Lambda_0_5_p135 *
      (Lambda_0_5_p140 + Lambda_0_5_p141));
  const Real Lambda_0_5_p144 = Lambda_0_5_p134 * Lambda_0_5_p95;
  const Real Lambda_0_5_p145 = Lambda_0_5_p113 * Lambda_0_5_p121 + Lambda_0_5_p114 *
      Lambda_0_5_p123 - Lambda_0_5_p112 * Lambda_0_5_p122 + Lambda_0_5_p111 * Lambda_0_5_p125 +
      Lambda_0_5_p110 * Lambda_0_5_p126;
  const Real Lambda_0_5_p146 = Lambda_0_5_p145 + Lambda_0_5_p109 * Lambda_0_5_p127;
  const Real Lambda_0_5_p147 = Lambda_0_5_p146 * Lambda_0_5_p103;
  const Real Lambda_0_5_p148 = Lambda_0_5_p130 * Lambda_0_5_p104 + Lambda_0_5_p129 *
      Lambda_0_5_p105 - Lambda_0_5_p128 * Lambda_0_5_p106 - (Lambda_0_5_p144 + Lambda_0_5_p147);
  const Real Lambda_0_5_p149 = Lambda_0_5_p109 * Lambda_0_5_p137;
  const Real Lambda_0_5_p150 = Lambda_0_5_p142 * Lambda_0_5_p106 + Lambda_0_5_p95 *
      Lambda_0_5_p140 - Lambda_0_5_p135 * Lambda_0_5_p108 + (Lambda_0_5_p149 - Lambda_0_5_p148) *
      Lambda_0_5_p103;

  // link 1 (link1), turn
  const Real Lambda_0_5_p151 = 2.0 * c1;
  const Real Lambda_0_5_p152 = s1 * (Lambda_0_5_p120 - Lambda_0_5_p143) - Lambda_0_5_p151 *
      Lambda_0_5_p150;
  const Real Lambda_0_5_p153 = s1 * Lambda_0_5_p152;
  const Real Lambda_0_5_p154 = 1.0 / (Lambda_0_5_p120 - Lambda_0_5_p153);
  const Real Lambda_0_5_p155 = c1 * Lambda_0_5_p108 - s1 * Lambda_0_5_p141;
  const Real Lambda_0_5_p156 = Lambda_0_5_p155 * Lambda_0_5_p154;
  const Real Lambda_0_5_p157 = c1 * Lambda_0_5_p152 + Lambda_0_5_p150;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p158 = Lambda_0_5_p102 * Lambda_0_5_p135;
  const Real Lambda_0_5_p159 = Lambda_0_5_p149 + (Lambda_0_5_p147 + Lambda_0_5_p158);

  // link 1 (link1), turn
  const Real Lambda_0_5_p160 = s1 * (Lambda_0_5_p148 - Lambda_0_5_p159) + c1 *
      (Lambda_0_5_p139 + Lambda_0_5_p118);
  const Real Lambda_0_5_p161 = c1 * Lambda_0_5_p160;
  const Real Lambda_0_5_p162 = Lambda_0_5_p161 - Lambda_0_5_p139;
  const Real Lambda_0_5_p163 = Lambda_0_5_p162 * Lambda_0_5_p154;
  const Real Lambda_0_5_p164 = s1 * Lambda_0_5_p160;
  const Real Lambda_0_5_p165 = Lambda_0_5_p148 - Lambda_0_5_p164;
  const Real Lambda_0_5_p166 = Lambda_0_5_p165 * Lambda_0_5_p154;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p167 = Lambda_0_5_p66 * Lambda_0_5_p136 - Lambda_0_5_p137;
  const Real Lambda_0_5_p168 = Lambda_0_5_p62 * Lambda_0_5_p136 - Lambda_0_5_p73 * Lambda_0_5_p167;
  const Real Lambda_0_5_p169 = Lambda_0_5_p168 * Lambda_0_5_p74;
  const Real Lambda_0_5_p170 = Lambda_0_5_p167 * Lambda_0_5_p72;
  const Real Lambda_0_5_p171 = Lambda_0_5_p136 * Lambda_0_5_p61;
  const Real Lambda_0_5_p172 = Lambda_0_5_p110 * Lambda_0_5_p167 - Lambda_0_5_p111 *
      Lambda_0_5_p136 + Lambda_0_5_p109 * Lambda_0_5_p168;
  const Real Lambda_0_5_p173 = Lambda_0_5_p170 * Lambda_0_5_p105 - Lambda_0_5_p171 *
      Lambda_0_5_p104 - Lambda_0_5_p169 * Lambda_0_5_p106 - Lambda_0_5_p103 * Lambda_0_5_p172 -
      Lambda_0_5_p135 * Lambda_0_5_p118;
  const Real Lambda_0_5_p174 = Lambda_0_5_p87 * Lambda_0_5_p167 - Lambda_0_5_p88 * Lambda_0_5_p136 +
      Lambda_0_5_p86 * Lambda_0_5_p168;
  const Real Lambda_0_5_p175 = Lambda_0_5_p173 + (Lambda_0_5_p148 - Lambda_0_5_p174) *
      Lambda_0_5_p95;
  const Real Lambda_0_5_p176 = Lambda_0_5_p129 * Lambda_0_5_p167 - Lambda_0_5_p130 *
      Lambda_0_5_p136 + Lambda_0_5_p128 * Lambda_0_5_p168;
  const Real Lambda_0_5_p177 = Lambda_0_5_p169 * Lambda_0_5_p137 + Lambda_0_5_p95 *
      Lambda_0_5_p139 + Lambda_0_5_p103 * Lambda_0_5_p176 + (Lambda_0_5_p174 - Lambda_0_5_p159) *
      Lambda_0_5_p135;

  // link 1 (link1), turn
  const Real Lambda_0_5_p178 = c1 * Lambda_0_5_p175 - s1 * Lambda_0_5_p177;
  const Real Lambda_0_5_p179 = Lambda_0_5_p178 * Lambda_0_5_p154;
  const Real Lambda_0_5_p180 = Lambda_0_5_p157 * Lambda_0_5_p154;
  const Lanes<8> Lambda_0_5_p186_lanes = detail::make_pack<Real>(Lambda_0_5_p143 + Lambda_0_5_p153,
      Lambda_0_5_p143 + Lambda_0_5_p153, s1 * Lambda_0_5_p175 + c1 * Lambda_0_5_p177,
      Lambda_0_5_p161 - Lambda_0_5_p118, Lambda_0_5_p159 + Lambda_0_5_p164, s1 * Lambda_0_5_p108 +
      c1 * Lambda_0_5_p141, Lambda_0_5_p143 + Lambda_0_5_p153, Lambda_0_5_p143 + Lambda_0_5_p153) -
      detail::make_pack<Real>(Lambda_0_5_p180, Lambda_0_5_p180, Lambda_0_5_p179, Lambda_0_5_p166,
      Lambda_0_5_p163, Lambda_0_5_p156, Lambda_0_5_p180, Lambda_0_5_p180) * Lambda_0_5_p157;
  const Real Lambda_0_5_p191 = 1.0 / Lambda_0_5_p186_lanes[1];
  const Lanes<8> Lambda_0_5_p192_lanes = Lambda_0_5_p186_lanes * Lambda_0_5_p191;

  // link 1 (link1), mass matrix
  const Real Lambda_0_5_p204 = Lambda_0_5_p176 - (Lambda_0_5_p146 * Lambda_0_5_p135 -
      Lambda_0_5_p132 * Lambda_0_5_p95);
  const Real Lambda_0_5_p205 = Lambda_0_5_p172 - (Lambda_0_5_p116 * Lambda_0_5_p135 -
      Lambda_0_5_p146 * Lambda_0_5_p95);
  const Real Lambda_0_5_p206 = Lambda_0_5_p171 * Lambda_0_5_p136 + Lambda_0_5_p170 *
      Lambda_0_5_p167 + Lambda_0_5_p169 * Lambda_0_5_p168 -
      (Lambda_0_5_p135 * (Lambda_0_5_p172 + Lambda_0_5_p205) - Lambda_0_5_p95 *
      (Lambda_0_5_p176 + Lambda_0_5_p204));

  // link 1 (link1), turn
  const Lanes<8> Lambda_0_5_p211_lanes = detail::make_pack<Real>(Lambda_0_5_p206, Lambda_0_5_p206,
      Lambda_0_5_p206, c1 * Lambda_0_5_p204 - s1 * Lambda_0_5_p205, s1 * Lambda_0_5_p204 + c1 *
      Lambda_0_5_p205, Lambda_0_5_p174 - (Lambda_0_5_p158 - Lambda_0_5_p144), Lambda_0_5_p206,
      Lambda_0_5_p206) - detail::make_pack<Real>(Lambda_0_5_p179, Lambda_0_5_p179, Lambda_0_5_p179,
      Lambda_0_5_p166, Lambda_0_5_p163, Lambda_0_5_p156, Lambda_0_5_p179, Lambda_0_5_p179) *
      Lambda_0_5_p178 - Lambda_0_5_p192_lanes * Lambda_0_5_p186_lanes[2];
  const Real Lambda_0_5_p215 = 1.0 / Lambda_0_5_p211_lanes[2];
  const Lanes<8> Lambda_0_5_p216_lanes = Lambda_0_5_p211_lanes * Lambda_0_5_p215;
  const Real Lambda_0_5_p228 = s1 * (Lambda_0_5_p132 - Lambda_0_5_p116) + Lambda_0_5_p151 *
      Lambda_0_5_p146;
  const Real Lambda_0_5_p229 = s1 * Lambda_0_5_p228;
  const Lanes<8> Lambda_0_5_p236_lanes = detail::make_pack<Real>(Lambda_0_5_p132 - Lambda_0_5_p229,
      Lambda_0_5_p132 - Lambda_0_5_p229, Lambda_0_5_p132 - Lambda_0_5_p229, Lambda_0_5_p132 -
      Lambda_0_5_p229, c1 * Lambda_0_5_p228 - Lambda_0_5_p146, c1 * Lambda_0_5_p134 - s1 *
      Lambda_0_5_p102, Lambda_0_5_p132 - Lambda_0_5_p229, Lambda_0_5_p132 - Lambda_0_5_p229) -
      detail::make_pack<Real>(Lambda_0_5_p166, Lambda_0_5_p166, Lambda_0_5_p166, Lambda_0_5_p166,
      Lambda_0_5_p163, Lambda_0_5_p156, Lambda_0_5_p166, Lambda_0_5_p166) * Lambda_0_5_p165 -
      Lambda_0_5_p192_lanes * Lambda_0_5_p186_lanes[3] - Lambda_0_5_p216_lanes *
      Lambda_0_5_p211_lanes[3];
  const Real Lambda_0_5_p239 = 1.0 / Lambda_0_5_p236_lanes[3];
  const Real Lambda_0_5_p240 = Lambda_0_5_p236_lanes[5] * Lambda_0_5_p239;
  const Real Lambda_0_5_p241 = s1 * Lambda_0_5_p134 + c1 * Lambda_0_5_p102 - Lambda_0_5_p156 *
      Lambda_0_5_p162 - Lambda_0_5_p192_lanes[5] * Lambda_0_5_p186_lanes[4] -
      Lambda_0_5_p216_lanes[5] * Lambda_0_5_p211_lanes[4];
  const Real Lambda_0_5_p242 = Lambda_0_5_p241 - Lambda_0_5_p240 * Lambda_0_5_p236_lanes[4];
  const Real Lambda_0_5_p243 = Lambda_0_5_p236_lanes[4] * Lambda_0_5_p239;
  const Real Lambda_0_5_p244 = Lambda_0_5_p116 + Lambda_0_5_p229 - Lambda_0_5_p163 *
      Lambda_0_5_p162 - Lambda_0_5_p192_lanes[4] * Lambda_0_5_p186_lanes[4] -
      Lambda_0_5_p216_lanes[4] * Lambda_0_5_p211_lanes[4] - Lambda_0_5_p243 *
      Lambda_0_5_p236_lanes[4];
  const Real Lambda_0_5_p245 = 1.0 / Lambda_0_5_p244;
  const Real Lambda_0_5_p246 = Lambda_0_5_p242 * Lambda_0_5_p245;
  const Real Lambda_0_5_p247 = Lambda_0_5_p192_lanes[2] * Lambda_0_5_p180 - Lambda_0_5_p179;
  const Real Lambda_0_5_p248 = Lambda_0_5_p192_lanes[3] * Lambda_0_5_p180 - Lambda_0_5_p166 -
      Lambda_0_5_p216_lanes[3] * Lambda_0_5_p247;
  const Real Lambda_0_5_p249 = Lambda_0_5_p192_lanes[4] * Lambda_0_5_p180 - Lambda_0_5_p163 -
      Lambda_0_5_p216_lanes[4] * Lambda_0_5_p247 - Lambda_0_5_p243 * Lambda_0_5_p248;
  const Real Lambda_0_5_p250 = Lambda_0_5_p192_lanes[5] * Lambda_0_5_p180 - Lambda_0_5_p156 -
      Lambda_0_5_p216_lanes[5] * Lambda_0_5_p247 - Lambda_0_5_p240 * Lambda_0_5_p248 -
      Lambda_0_5_p246 * Lambda_0_5_p249;
  const Real Lambda_5_5_p1 = Lambda_0_5_p93 - Lambda_0_5_p156 * Lambda_0_5_p155 -
      Lambda_0_5_p192_lanes[5] * Lambda_0_5_p186_lanes[5] - Lambda_0_5_p216_lanes[5] *
      Lambda_0_5_p211_lanes[5] - Lambda_0_5_p240 * Lambda_0_5_p236_lanes[5];
  const Real Lambda_5_5 = 1.0 / (Lambda_5_5_p1 - Lambda_0_5_p246 * Lambda_0_5_p242);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5 = Lambda_0_5_p250 * Lambda_5_5;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_0_0_p1 = Lambda_0_5_p249 * Lambda_0_5_p245;
  const Real Lambda_0_0_p2 = Lambda_0_5_p248 * Lambda_0_5_p239;
  const Real Lambda_0_0_p3 = Lambda_0_5_p247 * Lambda_0_5_p215;
  const Real Lambda_0_0_p4 = Lambda_0_5_p180 * Lambda_0_5_p191;
  const Real Lambda_0_0_p5 = Lambda_0_5_p154 + Lambda_0_0_p4 * Lambda_0_5_p180 + Lambda_0_0_p3 *
      Lambda_0_5_p247 + Lambda_0_0_p2 * Lambda_0_5_p248 + Lambda_0_0_p1 * Lambda_0_5_p249;
  Lambda[0] = Lambda_0_0_p5 + Lambda_0_5 * Lambda_0_5_p250;
  const Real Lambda_1_5_p1 = Lambda_0_5_p216_lanes[3] * Lambda_0_5_p192_lanes[2] -
      Lambda_0_5_p192_lanes[3];
  const Real Lambda_1_5_p2 = Lambda_0_5_p216_lanes[4] * Lambda_0_5_p192_lanes[2] -
      Lambda_0_5_p192_lanes[4] - Lambda_0_5_p243 * Lambda_1_5_p1;
  const Real Lambda_1_5_p3 = Lambda_0_5_p216_lanes[5] * Lambda_0_5_p192_lanes[2] -
      Lambda_0_5_p192_lanes[5] - Lambda_0_5_p240 * Lambda_1_5_p1 - Lambda_0_5_p246 * Lambda_1_5_p2;
  const Real Lambda_1_5 = Lambda_1_5_p3 * Lambda_5_5;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_0_1_p1 = Lambda_1_5_p2 * Lambda_0_5_p245;
  const Real Lambda_0_1_p2 = Lambda_1_5_p1 * Lambda_0_5_p239;
  const Real Lambda_0_1_p3 = Lambda_0_5_p192_lanes[2] * Lambda_0_5_p215;
  const Real Lambda_0_1 = Lambda_0_1_p2 * Lambda_0_5_p248 -
      (Lambda_0_0_p4 + Lambda_0_1_p3 * Lambda_0_5_p247) + Lambda_0_1_p1 * Lambda_0_5_p249 +
      Lambda_1_5 * Lambda_0_5_p250;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_2_5_p1 = Lambda_0_5_p243 * Lambda_0_5_p216_lanes[3] - Lambda_0_5_p216_lanes[4];
  const Real Lambda_2_5_p2 = Lambda_0_5_p240 * Lambda_0_5_p216_lanes[3] - Lambda_0_5_p216_lanes[5] -
      Lambda_0_5_p246 * Lambda_2_5_p1;
  const Real Lambda_2_5 = Lambda_2_5_p2 * Lambda_5_5;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_0_2_p1 = Lambda_2_5_p1 * Lambda_0_5_p245;
  const Real Lambda_0_2_p2 = Lambda_0_5_p216_lanes[3] * Lambda_0_5_p239;
  const Real Lambda_0_2 = Lambda_0_0_p3 - Lambda_0_2_p2 * Lambda_0_5_p248 + Lambda_0_2_p1 *
      Lambda_0_5_p249 + Lambda_2_5 * Lambda_0_5_p250;
  Lambda[2] = Lambda_0_2;
  Lambda[12] = Lambda_0_2;
  const Real Lambda_3_5_p1 = Lambda_0_5_p246 * Lambda_0_5_p243 - Lambda_0_5_p240;
  const Real Lambda_3_5 = Lambda_3_5_p1 * Lambda_5_5;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_0_3_p1 = Lambda_0_5_p243 * Lambda_0_5_p245;
  const Real Lambda_0_3 = Lambda_0_0_p2 - Lambda_0_3_p1 * Lambda_0_5_p249 + Lambda_3_5 *
      Lambda_0_5_p250;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_4_5 = Lambda_0_5_p246 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  const Real Lambda_0_4 = Lambda_0_0_p1 - Lambda_4_5 * Lambda_0_5_p250;
  Lambda[4] = Lambda_0_4;
  Lambda[24] = Lambda_0_4;
  Lambda[7] = Lambda_0_5_p191 + Lambda_0_1_p3 * Lambda_0_5_p192_lanes[2] + Lambda_0_1_p2 *
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
  Lambda[14] = Lambda_0_5_p215 + Lambda_0_2_p2 * Lambda_0_5_p216_lanes[3] + Lambda_0_2_p1 *
      Lambda_2_5_p1 + Lambda_2_5 * Lambda_2_5_p2;
  const Real Lambda_2_3 = Lambda_3_5 * Lambda_2_5_p2 -
      (Lambda_0_2_p2 + Lambda_0_3_p1 * Lambda_2_5_p1);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p1 - Lambda_4_5 * Lambda_2_5_p2;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_0_5_p239 + Lambda_0_3_p1 * Lambda_0_5_p243 + Lambda_3_5 * Lambda_3_5_p1;
  const Real Lambda_3_4 = Lambda_0_3_p1 + Lambda_4_5 * Lambda_3_5_p1;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_0_5_p245 + Lambda_4_5 * Lambda_0_5_p246;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
