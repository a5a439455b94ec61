// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J in world axes, in the axes asked for at link origins.
// 850 flops (add 356, mul 484, div 10), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void lambda(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
  const Real angles[5] = {q[0], q[1], q[2], q[3], q[4]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s1 = sines[0];
  const Real c1 = cosines[0];
  const Real s2 = sines[1];
  const Real c2 = cosines[1];
  const Real s3 = sines[2];
  const Real c3 = cosines[2];
  const Real s4 = sines[3];
  const Real c4 = cosines[3];
  const Real s5 = sines[4];
  const Real c5 = cosines[4];

  // link 5 (link5), composite inertia
  const Real Lambda_5_5_p1 = 0.0028799999999999997 * s5;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p2 = c4 * Lambda_5_5_p1;
  const Real Lambda_5_5_p3 = 0.4331 * Lambda_5_5_p2;

  // link 5 (link5), composite inertia
  const Real Lambda_5_5_p4 = 0.00020215999999999998 * s5;
  const Real Lambda_5_5_p5 = c5 * Lambda_5_5_p4;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p6 = c4 * Lambda_5_5_p5;
  const Real Lambda_5_5_p7 = Lambda_5_5_p6 - (0.010673638499999999 - Lambda_5_5_p3 +
      5.846399999999999e-05 * c5);

  // link 5 (link5), composite inertia
  const Real Lambda_5_5_p8 = 0.0028799999999999997 * c5;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p9 = 0.861795 + Lambda_5_5_p8;
  const Real Lambda_5_5_p10 = 0.025374999999999998 - Lambda_5_5_p2;

  // link 3 (link3), composite inertia
  const Real Lambda_5_5_p11 = c3 * Lambda_5_5_p9 + s3 * Lambda_5_5_p10;

  // link 5 (link5), composite inertia
  const Real Lambda_5_5_p12 = s5 * Lambda_5_5_p4;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p13 = s4 * (0.00010000000000000026 + Lambda_5_5_p12);
  const Real Lambda_5_5_p14 = s4 * Lambda_5_5_p13;
  const Real Lambda_5_5_p15 = Lambda_5_5_p14 + (0.0011921599999999998 -
      (Lambda_5_5_p12 - (0.3056901365 + 0.0024946559999999996 * c5)));
  const Real Lambda_5_5_p16 = 0.008405112499999999 + Lambda_5_5_p12 - 0.0406 * Lambda_5_5_p2;

  // link 3 (link3), composite inertia
  const Real Lambda_5_5_p17 = Lambda_5_5_p7 * (2.0 * c3) + s3 * (Lambda_5_5_p15 - Lambda_5_5_p16);
  const Real Lambda_5_5_p18 = s3 * Lambda_5_5_p17;
  const Real Lambda_5_5_p19 = s3 * Lambda_5_5_p9 - c3 * Lambda_5_5_p10;
  const Real Lambda_5_5_p20 = 0.4318 * Lambda_5_5_p19;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p21 = s4 * Lambda_5_5_p1;

  // link 3 (link3), composite inertia
  const Real Lambda_5_5_p22 = 0.1501 * Lambda_5_5_p21;
  const Real Lambda_5_5_p23 = Lambda_5_5_p18 + (Lambda_5_5_p16 +
      (1.674987602 + 2.0 * (Lambda_5_5_p20 + Lambda_5_5_p22)));

  // link 2 (link2), composite inertia
  const Real Lambda_5_5_p24 = (Lambda_5_5_p7 + (0.0070992 - 0.4318 * Lambda_5_5_p11) - c3 *
      Lambda_5_5_p17) * (2.0 * c2) + s2 * (Lambda_5_5_p23 +
      (Lambda_5_5_p18 - (Lambda_5_5_p15 + (0.07312640000000001 + 0.3002 * Lambda_5_5_p21))));

  // link 6 (link6), mass matrix
  const Real Lambda_5_5_p25 = 4e-05 * c5;
  const Real Lambda_5_5_p26 = 4e-05 * s5;
  const Real Lambda_5_5_p27 = c4 * Lambda_5_5_p26;
  const Real Lambda_5_5_p28 = c2 * (c3 * Lambda_5_5_p25 - s3 * Lambda_5_5_p27) - s2 *
      (s3 * Lambda_5_5_p25 + c3 * Lambda_5_5_p27);

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p29 = 24999.999999999996 * Lambda_5_5_p28;

  // link 5 (link5), mass matrix
  const Real Lambda_5_5_p30 = c4 * Lambda_5_5_p8;
  const Real Lambda_5_5_p31 = s4 * Lambda_5_5_p8;
  const Real Lambda_5_5_p32 = 0.0203 * Lambda_5_5_p31;
  const Real Lambda_5_5_p33 = 0.4318 * Lambda_5_5_p31 + 0.1501 *
      (s3 * Lambda_5_5_p1 - c3 * Lambda_5_5_p30) - c3 * Lambda_5_5_p32;
  const Real Lambda_5_5_p34 = 0.4331 * Lambda_5_5_p31 + 0.00064216 * s4;
  const Real Lambda_5_5_p35 = c3 * Lambda_5_5_p1 + s3 * Lambda_5_5_p30;
  const Real Lambda_5_5_p36 = c2 * (Lambda_5_5_p33 + s3 * Lambda_5_5_p34) + s2 *
      (0.1501 * Lambda_5_5_p35 + s3 * Lambda_5_5_p32 + c3 * Lambda_5_5_p34);

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p37 = 1557.24430048586 * Lambda_5_5_p36;

  // link 5 (link5), composite inertia
  const Real Lambda_5_5_p38 = 0.00164 + Lambda_5_5_p12;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p39 = 0.0203 * Lambda_5_5_p2;

  // link 4 (link4), mass matrix
  const Real Lambda_5_5_p40 = Lambda_5_5_p38 - Lambda_5_5_p39;
  const Real Lambda_5_5_p41 = Lambda_5_5_p3 + Lambda_5_5_p6;
  const Real Lambda_5_5_p42 = s3 * Lambda_5_5_p21;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p43 = c2 * (c3 * (Lambda_5_5_p22 + Lambda_5_5_p40) +
      (0.4318 * Lambda_5_5_p2 + s3 * Lambda_5_5_p41)) - s2 *
      (0.1501 * Lambda_5_5_p42 + s3 * Lambda_5_5_p40 - c3 * Lambda_5_5_p41);
  const Real Lambda_5_5_p44 = 0.9999999999999999 * c5;
  const Real Lambda_5_5_p45 = Lambda_5_5_p43 - Lambda_5_5_p28 * Lambda_5_5_p44;
  const Real Lambda_5_5_p46 = 1.0 / (Lambda_5_5_p38 - Lambda_5_5_p25 * Lambda_5_5_p44);
  const Real Lambda_5_5_p47 = Lambda_5_5_p45 * Lambda_5_5_p46;
  const Real Lambda_5_5_p48 = 1.4717295504999999 + Lambda_5_5_p23 - s2 * Lambda_5_5_p24 -
      Lambda_5_5_p28 * Lambda_5_5_p29 - Lambda_5_5_p36 * Lambda_5_5_p37 - Lambda_5_5_p45 *
      Lambda_5_5_p47;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p49 = 0.4331 * Lambda_5_5_p21 + s4 * Lambda_5_5_p5;
  const Real Lambda_5_5_p50 = 0.004704000000000001 + Lambda_5_5_p49;
  const Real Lambda_5_5_p51 = 0.0203 * Lambda_5_5_p21 - c4 * Lambda_5_5_p13;

  // link 3 (link3), composite inertia
  const Real Lambda_5_5_p52 = 0.1501 * Lambda_5_5_p11 + c3 * Lambda_5_5_p50 + s3 * Lambda_5_5_p51;
  const Real Lambda_5_5_p53 = s3 * Lambda_5_5_p50 - c3 * Lambda_5_5_p51;
  const Real Lambda_5_5_p54 = 0.1501 * Lambda_5_5_p19;

  // link 6 (link6), mass matrix
  const Real Lambda_5_5_p55 = s4 * Lambda_5_5_p26;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p56 = 24999.999999999996 * Lambda_5_5_p55;
  const Real Lambda_5_5_p57 = Lambda_5_5_p28 * Lambda_5_5_p56;

  // link 5 (link5), mass matrix
  const Real Lambda_5_5_p58 = 0.4331 * Lambda_5_5_p30 - 5.846399999999999e-05 * s5 + 0.00064216 *
      c4;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p59 = 1557.24430048586 * Lambda_5_5_p58;
  const Real Lambda_5_5_p60 = Lambda_5_5_p55 * Lambda_5_5_p44;
  const Real Lambda_5_5_p61 = Lambda_5_5_p49 + Lambda_5_5_p60;
  const Real Lambda_5_5_p62 = Lambda_5_5_p61 * Lambda_5_5_p46;
  const Real Lambda_5_5_p63 = Lambda_5_5_p57 + (c2 * Lambda_5_5_p52 - s2 *
      (Lambda_5_5_p54 + Lambda_5_5_p53)) + Lambda_5_5_p36 * Lambda_5_5_p59 - Lambda_5_5_p45 *
      Lambda_5_5_p62;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p64 = Lambda_5_5_p14 + (2.0 *
      (Lambda_5_5_p39 - 0.0012473279999999998 * c5) - 0.313747409);

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p65 = Lambda_5_5_p55 * Lambda_5_5_p56;
  const Real Lambda_5_5_p66 = 1.0 / (Lambda_5_5_p64 + Lambda_5_5_p65 + Lambda_5_5_p58 *
      Lambda_5_5_p59 + Lambda_5_5_p61 * Lambda_5_5_p62);
  const Real Lambda_5_5_p67 = Lambda_5_5_p63 * Lambda_5_5_p66;

  // link 5 (link5), mass matrix
  const Real Lambda_5_5_p68 = Lambda_5_5_p58 + 0.4318 * Lambda_5_5_p35;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p69 = Lambda_5_5_p60 + (Lambda_5_5_p49 + 0.4318 * Lambda_5_5_p42);
  const Real Lambda_5_5_p70 = Lambda_5_5_p65 + (Lambda_5_5_p64 - Lambda_5_5_p20) + Lambda_5_5_p68 *
      Lambda_5_5_p59 + Lambda_5_5_p69 * Lambda_5_5_p62;
  const Real Lambda_5_5_p71 = Lambda_5_5_p70 * Lambda_5_5_p66;
  const Real Lambda_5_5_p72 = c2 * (0.023750999999999998 - Lambda_5_5_p52) + s2 *
      (Lambda_5_5_p53 + (0.690314699 + Lambda_5_5_p54 + 0.4318 * Lambda_5_5_p21));
  const Real Lambda_5_5_p73 = 1557.24430048586 * Lambda_5_5_p68;
  const Real Lambda_5_5_p74 = Lambda_5_5_p69 * Lambda_5_5_p46;
  const Real Lambda_5_5_p75 = Lambda_5_5_p57 - Lambda_5_5_p72 + Lambda_5_5_p36 * Lambda_5_5_p73 -
      Lambda_5_5_p45 * Lambda_5_5_p74 - Lambda_5_5_p63 * Lambda_5_5_p71;
  const Real Lambda_5_5_p76 = Lambda_5_5_p65 - (1.7481140020000001 - Lambda_5_5_p64 + 0.8636 *
      Lambda_5_5_p19) + Lambda_5_5_p68 * Lambda_5_5_p73 + Lambda_5_5_p69 * Lambda_5_5_p74;
  const Real Lambda_5_5_p77 = 1.0 / (Lambda_5_5_p76 - Lambda_5_5_p70 * Lambda_5_5_p71);
  const Real Lambda_5_5_p78 = Lambda_5_5_p75 * Lambda_5_5_p77;
  const Real Lambda_5_5_p79 = 1.0 / (Lambda_5_5_p48 + Lambda_5_5_p63 * Lambda_5_5_p67 +
      Lambda_5_5_p75 * Lambda_5_5_p78);

  // link 2 (link2), pose
  const Real Lambda_5_5_p80 = s1 * s2;
  const Real Lambda_5_5_p81 = s1 * c2;

  // link 3 (link3), pose
  const Real Lambda_5_5_p82 = c3 * Lambda_5_5_p80 + s3 * Lambda_5_5_p81;
  const Real Lambda_5_5_p83 = s3 * Lambda_5_5_p80 - c3 * Lambda_5_5_p81;

  // link 5 (link5), pose
  const Real Lambda_5_5_p84 = c5 * Lambda_5_5_p82 + s5 * (c1 * s4 - c4 * Lambda_5_5_p83);

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p85 = c1 - Lambda_5_5_p84 * Lambda_5_5_p56;

  // link 4 (link4), pose
  const Real Lambda_5_5_p86 = c1 * c4 + s4 * Lambda_5_5_p83;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p87 = Lambda_5_5_p82 - Lambda_5_5_p84 * Lambda_5_5_p44;
  const Real Lambda_5_5_p88 = Lambda_5_5_p85 - Lambda_5_5_p86 * Lambda_5_5_p59 + Lambda_5_5_p62 *
      Lambda_5_5_p87;
  const Real Lambda_5_5_p89 = Lambda_5_5_p85 - Lambda_5_5_p86 * Lambda_5_5_p73 + Lambda_5_5_p74 *
      Lambda_5_5_p87 - Lambda_5_5_p71 * Lambda_5_5_p88;
  const Real Lambda_5_5_p90 = Lambda_5_5_p84 * Lambda_5_5_p29 + Lambda_5_5_p86 * Lambda_5_5_p37 +
      Lambda_5_5_p47 * Lambda_5_5_p87 + Lambda_5_5_p67 * Lambda_5_5_p88 + Lambda_5_5_p78 *
      Lambda_5_5_p89;
  const Real Lambda_5_5_p91 = Lambda_5_5_p79 * Lambda_5_5_p90;

  // link 2 (link2), pose
  const Real Lambda_5_5_p92 = c1 * s2;
  const Real Lambda_5_5_p93 = c1 * c2;

  // link 3 (link3), pose
  const Real Lambda_5_5_p94 = c3 * Lambda_5_5_p92 + s3 * Lambda_5_5_p93;
  const Real Lambda_5_5_p95 = s3 * Lambda_5_5_p92 - c3 * Lambda_5_5_p93;

  // link 5 (link5), pose
  const Real Lambda_5_5_p96 = c5 * Lambda_5_5_p94 - s5 * (s1 * s4 + c4 * Lambda_5_5_p95);

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p97 = s1 + Lambda_5_5_p96 * Lambda_5_5_p56;

  // link 4 (link4), pose
  const Real Lambda_5_5_p98 = s1 * c4 - s4 * Lambda_5_5_p95;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p99 = Lambda_5_5_p94 - Lambda_5_5_p96 * Lambda_5_5_p44;
  const Real Lambda_5_5_p100 = Lambda_5_5_p97 - Lambda_5_5_p98 * Lambda_5_5_p59 - Lambda_5_5_p62 *
      Lambda_5_5_p99;
  const Real Lambda_5_5_p101 = Lambda_5_5_p97 - Lambda_5_5_p98 * Lambda_5_5_p73 - Lambda_5_5_p74 *
      Lambda_5_5_p99 - Lambda_5_5_p71 * Lambda_5_5_p100;
  const Real Lambda_5_5_p102 = Lambda_5_5_p96 * Lambda_5_5_p29 - Lambda_5_5_p98 * Lambda_5_5_p37 +
      Lambda_5_5_p47 * Lambda_5_5_p99 - Lambda_5_5_p67 * Lambda_5_5_p100 - Lambda_5_5_p78 *
      Lambda_5_5_p101;
  const Real Lambda_5_5_p103 = Lambda_5_5_p77 * Lambda_5_5_p89;
  const Real Lambda_5_5_p104 = Lambda_5_5_p66 * Lambda_5_5_p88;
  const Real Lambda_5_5_p105 = 24999.999999999996 * Lambda_5_5_p84;
  const Real Lambda_5_5_p106 = 1557.24430048586 * Lambda_5_5_p86;
  const Real Lambda_5_5_p107 = Lambda_5_5_p46 * Lambda_5_5_p87;
  const Real Lambda_5_5_p108 = Lambda_5_5_p96 * Lambda_5_5_p105 - Lambda_5_5_p98 * Lambda_5_5_p106 +
      Lambda_5_5_p99 * Lambda_5_5_p107 + Lambda_5_5_p100 * Lambda_5_5_p104 + Lambda_5_5_p101 *
      Lambda_5_5_p103;
  const Real Lambda_5_5_p109 = Lambda_5_5_p108 + Lambda_5_5_p102 * Lambda_5_5_p91;

  // link 3 (link3), pose
  const Real Lambda_5_5_p110 = c2 * c3 - s2 * s3;
  const Real Lambda_5_5_p111 = c2 * s3 + s2 * c3;

  // link 5 (link5), pose
  const Real Lambda_5_5_p112 = c5 * Lambda_5_5_p110 - Lambda_5_5_p111 * (c4 * s5);

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p113 = 0.05625 * Lambda_5_5_p112;
  const Real Lambda_5_5_p114 = Lambda_5_5_p109 * Lambda_5_5_p113;
  const Real Lambda_5_5_p115 = Lambda_5_5_p79 * Lambda_5_5_p102;

  // link 4 (link4), pose
  const Real Lambda_5_5_p116 = 0.4331 * Lambda_5_5_p110 + 0.0203 * Lambda_5_5_p111;

  // link 3 (link3), Jacobian
  const Real Lambda_5_5_p117 = c1 * Lambda_5_5_p116;

  // link 2 (link2), Jacobian
  const Real Lambda_5_5_p118 = Lambda_5_5_p116 - 0.4318 * s2;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p119 = c1 * Lambda_5_5_p118 - Lambda_5_5_p117 * Lambda_5_5_p71;

  // link 4 (link4), pose
  const Real p4_y_p1 = 0.4331 * Lambda_5_5_p82 + 0.0203 * Lambda_5_5_p83;
  const Real p4_y = p4_y_p1 + (0.1501 * c1 + 0.4318 * Lambda_5_5_p81);

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p120 = p4_y + Lambda_5_5_p117 * Lambda_5_5_p67 + Lambda_5_5_p78 *
      Lambda_5_5_p119;
  const Real Lambda_5_5_p121 = Lambda_5_5_p77 * Lambda_5_5_p101;
  const Real Lambda_5_5_p122 = Lambda_5_5_p66 * Lambda_5_5_p100;
  const Real Lambda_5_5_p123 = Lambda_5_5_p112 * Lambda_5_5_p56;

  // link 4 (link4), pose
  const Real Lambda_5_5_p124 = s4 * Lambda_5_5_p111;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p125 = Lambda_5_5_p110 - Lambda_5_5_p112 * Lambda_5_5_p44;
  const Real Lambda_5_5_p126 = Lambda_5_5_p123 + Lambda_5_5_p124 * Lambda_5_5_p59 - Lambda_5_5_p62 *
      Lambda_5_5_p125;
  const Real Lambda_5_5_p127 = Lambda_5_5_p123 + Lambda_5_5_p124 * Lambda_5_5_p73 - Lambda_5_5_p74 *
      Lambda_5_5_p125 - Lambda_5_5_p71 * Lambda_5_5_p126;
  const Real Lambda_5_5_p128 = 1.0 - Lambda_5_5_p112 * Lambda_5_5_p29 - Lambda_5_5_p124 *
      Lambda_5_5_p37 - Lambda_5_5_p47 * Lambda_5_5_p125 + Lambda_5_5_p67 * Lambda_5_5_p126;
  const Real Lambda_5_5_p129 = Lambda_5_5_p128 + Lambda_5_5_p78 * Lambda_5_5_p127;
  const Real Lambda_5_5_p130 = Lambda_5_5_p79 * Lambda_5_5_p129;
  const Real Lambda_5_5_p131 = Lambda_5_5_p77 * Lambda_5_5_p127;
  const Real Lambda_5_5_p132 = Lambda_5_5_p66 * Lambda_5_5_p126;
  const Real Lambda_5_5_p133 = 24999.999999999996 * Lambda_5_5_p112;
  const Real Lambda_5_5_p134 = 1557.24430048586 * Lambda_5_5_p124;
  const Real Lambda_5_5_p135 = Lambda_5_5_p46 * Lambda_5_5_p125;
  const Real Lambda_5_5_p136 = Lambda_5_5_p96 * Lambda_5_5_p133 - Lambda_5_5_p98 * Lambda_5_5_p134 +
      Lambda_5_5_p99 * Lambda_5_5_p135 - Lambda_5_5_p100 * Lambda_5_5_p132 - Lambda_5_5_p101 *
      Lambda_5_5_p131;
  const Real Lambda_5_5_p137 = Lambda_5_5_p136 - Lambda_5_5_p102 * Lambda_5_5_p130;
  const Real Lambda_5_5_p138 = 0.05625 * Lambda_5_5_p84;
  const Real Lambda_5_5_p139 = Lambda_5_5_p137 * Lambda_5_5_p138;
  const Real Lambda_5_5_p140 = Lambda_5_5_p139 - (Lambda_5_5_p114 +
      (Lambda_5_5_p117 * Lambda_5_5_p122 + Lambda_5_5_p119 * Lambda_5_5_p121 + Lambda_5_5_p120 *
      Lambda_5_5_p115));

  // link 3 (link3), Jacobian
  const Real Lambda_5_5_p141 = s1 * Lambda_5_5_p116;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p142 = s1 * Lambda_5_5_p118 - Lambda_5_5_p141 * Lambda_5_5_p71;

  // link 4 (link4), pose
  const Real p4_x_p1 = 0.4331 * Lambda_5_5_p94 + 0.0203 * Lambda_5_5_p95;
  const Real p4_x = p4_x_p1 - (0.1501 * s1 - 0.4318 * Lambda_5_5_p93);

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p143 = p4_x - Lambda_5_5_p141 * Lambda_5_5_p67 - Lambda_5_5_p78 *
      Lambda_5_5_p142;
  const Real Lambda_5_5_p144 = Lambda_5_5_p141 * Lambda_5_5_p104 + Lambda_5_5_p142 *
      Lambda_5_5_p103 + Lambda_5_5_p143 * Lambda_5_5_p91;
  const Real Lambda_5_5_p145 = Lambda_5_5_p117 * Lambda_5_5_p132 + Lambda_5_5_p119 *
      Lambda_5_5_p131 - Lambda_5_5_p120 * Lambda_5_5_p130;
  const Real Lambda_5_5_p146 = Lambda_5_5_p84 * Lambda_5_5_p133 + Lambda_5_5_p86 * Lambda_5_5_p134 +
      Lambda_5_5_p87 * Lambda_5_5_p135 + Lambda_5_5_p88 * Lambda_5_5_p132 + Lambda_5_5_p89 *
      Lambda_5_5_p131;
  const Real Lambda_5_5_p147 = Lambda_5_5_p146 - Lambda_5_5_p90 * Lambda_5_5_p130;
  const Real Lambda_5_5_p148 = Lambda_5_5_p112 * Lambda_5_5_p133 + Lambda_5_5_p124 *
      Lambda_5_5_p134 + Lambda_5_5_p125 * Lambda_5_5_p135 - Lambda_5_5_p126 * Lambda_5_5_p132 -
      Lambda_5_5_p127 * Lambda_5_5_p131;
  const Real Lambda_5_5_p149 = Lambda_5_5_p148 + Lambda_5_5_p129 * Lambda_5_5_p130;
  const Real Lambda_5_5_p150 = Lambda_5_5_p145 + Lambda_5_5_p147 * Lambda_5_5_p113 -
      Lambda_5_5_p149 * Lambda_5_5_p138;
  const Real Lambda_5_5_p151 = 0.05625 * Lambda_5_5_p96;
  const Real Lambda_5_5_p152 = Lambda_5_5_p79 * Lambda_5_5_p143;
  const Real Lambda_5_5_p153 = Lambda_5_5_p77 * Lambda_5_5_p142;
  const Real Lambda_5_5_p154 = Lambda_5_5_p141 * Lambda_5_5_p66;
  const Real Lambda_5_5_p155 = Lambda_5_5_p141 * Lambda_5_5_p132 + Lambda_5_5_p142 *
      Lambda_5_5_p131 + Lambda_5_5_p143 * Lambda_5_5_p130;
  const Real Lambda_5_5_p156 = Lambda_5_5_p117 * Lambda_5_5_p154 + Lambda_5_5_p119 *
      Lambda_5_5_p153 + Lambda_5_5_p120 * Lambda_5_5_p152 - Lambda_5_5_p151 * Lambda_5_5_p150 +
      Lambda_5_5_p155 * Lambda_5_5_p138;
  const Real Lambda_5_5_p157 = Lambda_5_5_p113 * (Lambda_5_5_p144 - Lambda_5_5_p140) +
      Lambda_5_5_p156;
  const Real Lambda_5_5_p158 = Lambda_5_5_p117 * Lambda_5_5_p104 + Lambda_5_5_p119 *
      Lambda_5_5_p103 - Lambda_5_5_p120 * Lambda_5_5_p91;
  const Real Lambda_5_5_p159 = Lambda_5_5_p84 * Lambda_5_5_p105 + Lambda_5_5_p86 * Lambda_5_5_p106 +
      Lambda_5_5_p87 * Lambda_5_5_p107 - Lambda_5_5_p88 * Lambda_5_5_p104 - Lambda_5_5_p89 *
      Lambda_5_5_p103;
  const Real Lambda_5_5_p160 = Lambda_5_5_p159 + Lambda_5_5_p90 * Lambda_5_5_p91;
  const Real Lambda_5_5_p161 = Lambda_5_5_p158 - Lambda_5_5_p160 * Lambda_5_5_p113 +
      Lambda_5_5_p147 * Lambda_5_5_p138;
  const Real Lambda_5_5_p162 = Lambda_5_5_p66 * (Lambda_5_5_p117 * Lambda_5_5_p117) +
      Lambda_5_5_p119 * (Lambda_5_5_p77 * Lambda_5_5_p119) - Lambda_5_5_p120 *
      (Lambda_5_5_p79 * Lambda_5_5_p120);
  const Real Lambda_5_5_p163 = 1.0 / (Lambda_5_5_p162 + Lambda_5_5_p113 *
      (Lambda_5_5_p158 + Lambda_5_5_p161) + Lambda_5_5_p138 * (Lambda_5_5_p145 + Lambda_5_5_p150));
  const Real Lambda_5_5_p164 = Lambda_5_5_p150 * Lambda_5_5_p163;
  const Real Lambda_5_5_p165 = Lambda_5_5_p155 + Lambda_5_5_p149 * Lambda_5_5_p151 -
      Lambda_5_5_p137 * Lambda_5_5_p113;
  const Real Lambda_5_5_p166 = Lambda_5_5_p165 - Lambda_5_5_p157 * Lambda_5_5_p164;
  const Real Lambda_5_5_p167 = Lambda_5_5_p157 * Lambda_5_5_p163;
  const Real Lambda_5_5_p168 = Lambda_5_5_p141 * Lambda_5_5_p154 + Lambda_5_5_p142 *
      Lambda_5_5_p153 - Lambda_5_5_p143 * Lambda_5_5_p152 - Lambda_5_5_p151 *
      (Lambda_5_5_p155 + Lambda_5_5_p165);
  const Real Lambda_5_5_p169 = Lambda_5_5_p141 * Lambda_5_5_p122 + Lambda_5_5_p142 *
      Lambda_5_5_p121 - Lambda_5_5_p143 * Lambda_5_5_p115;
  const Real Lambda_5_5_p170 = Lambda_5_5_p96 * (24999.999999999996 * Lambda_5_5_p96) +
      Lambda_5_5_p98 * (1557.24430048586 * Lambda_5_5_p98) + Lambda_5_5_p99 *
      (Lambda_5_5_p46 * Lambda_5_5_p99);
  const Real Lambda_5_5_p171 = Lambda_5_5_p170 - Lambda_5_5_p100 * Lambda_5_5_p122 -
      Lambda_5_5_p101 * Lambda_5_5_p121 + Lambda_5_5_p102 * Lambda_5_5_p115;
  const Real Lambda_5_5_p172 = Lambda_5_5_p169 + Lambda_5_5_p137 * Lambda_5_5_p151 -
      Lambda_5_5_p171 * Lambda_5_5_p113;
  const Real Lambda_5_5_p173 = 1.0 / (Lambda_5_5_p168 + Lambda_5_5_p113 *
      (Lambda_5_5_p169 + Lambda_5_5_p172) - Lambda_5_5_p157 * Lambda_5_5_p167);
  const Real Lambda_5_5_p174 = Lambda_5_5_p166 * Lambda_5_5_p173;

  // link 3 (link3), Jacobian
  const Real Lambda_5_5_p175 = c1 * p4_x_p1 + s1 * p4_y_p1;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p176 = c1 * p4_x + s1 * p4_y - Lambda_5_5_p175 * Lambda_5_5_p71;
  const Real Lambda_5_5_p177 = Lambda_5_5_p175 * Lambda_5_5_p67 + Lambda_5_5_p78 * Lambda_5_5_p176;
  const Real Lambda_5_5_p178 = Lambda_5_5_p175 * Lambda_5_5_p132 + Lambda_5_5_p176 *
      Lambda_5_5_p131 - Lambda_5_5_p177 * Lambda_5_5_p130;
  const Real Lambda_5_5_p179 = Lambda_5_5_p79 * Lambda_5_5_p177;
  const Real Lambda_5_5_p180 = Lambda_5_5_p77 * Lambda_5_5_p176;
  const Real Lambda_5_5_p181 = Lambda_5_5_p175 * Lambda_5_5_p66;
  const Real Lambda_5_5_p182 = Lambda_5_5_p175 * Lambda_5_5_p104 + Lambda_5_5_p176 *
      Lambda_5_5_p103 - Lambda_5_5_p177 * Lambda_5_5_p91;
  const Real Lambda_5_5_p183 = Lambda_5_5_p117 * Lambda_5_5_p181 + Lambda_5_5_p119 *
      Lambda_5_5_p180 - Lambda_5_5_p120 * Lambda_5_5_p179 + Lambda_5_5_p151 * Lambda_5_5_p161 +
      Lambda_5_5_p182 * Lambda_5_5_p113;
  const Real Lambda_5_5_p184 = Lambda_5_5_p138 * (Lambda_5_5_p178 - Lambda_5_5_p140) +
      Lambda_5_5_p183;
  const Real Lambda_5_5_p185 = Lambda_5_5_p184 * Lambda_5_5_p163;
  const Real Lambda_5_5_p186 = Lambda_5_5_p175 * Lambda_5_5_p122 + Lambda_5_5_p176 *
      Lambda_5_5_p121 + Lambda_5_5_p177 * Lambda_5_5_p115;
  const Real Lambda_5_5_p187 = Lambda_5_5_p141 * Lambda_5_5_p181 + Lambda_5_5_p142 *
      Lambda_5_5_p180 + Lambda_5_5_p143 * Lambda_5_5_p179 + Lambda_5_5_p138 * Lambda_5_5_p172 +
      Lambda_5_5_p186 * Lambda_5_5_p113;
  const Real Lambda_5_5_p188 = Lambda_5_5_p147 * Lambda_5_5_p151;
  const Real Lambda_5_5_p189 = Lambda_5_5_p188 - (Lambda_5_5_p144 + Lambda_5_5_p114);
  const Real Lambda_5_5_p190 = Lambda_5_5_p151 * (Lambda_5_5_p178 + Lambda_5_5_p189) -
      (Lambda_5_5_p187 - Lambda_5_5_p157 * Lambda_5_5_p185);
  const Real Lambda_5_5_p191 = Lambda_5_5_p188 + (Lambda_5_5_p178 - Lambda_5_5_p139) -
      Lambda_5_5_p184 * Lambda_5_5_p164 + Lambda_5_5_p190 * Lambda_5_5_p174;
  const Real Lambda_5_5_p192 = Lambda_5_5_p190 * Lambda_5_5_p173;
  const Real Lambda_5_5_p193 = Lambda_5_5_p186 - Lambda_5_5_p171 * Lambda_5_5_p138 +
      Lambda_5_5_p109 * Lambda_5_5_p151;
  const Real Lambda_5_5_p194 = Lambda_5_5_p175 * Lambda_5_5_p181 + Lambda_5_5_p176 *
      Lambda_5_5_p180 - Lambda_5_5_p177 * Lambda_5_5_p179 + Lambda_5_5_p138 *
      (Lambda_5_5_p186 + Lambda_5_5_p193);
  const Real Lambda_5_5_p195 = Lambda_5_5_p182 + Lambda_5_5_p109 * Lambda_5_5_p138 -
      Lambda_5_5_p160 * Lambda_5_5_p151;
  const Real Lambda_5_5_p196 = 1.0 / (Lambda_5_5_p194 + Lambda_5_5_p151 *
      (Lambda_5_5_p182 + Lambda_5_5_p195) - Lambda_5_5_p184 * Lambda_5_5_p185 - Lambda_5_5_p190 *
      Lambda_5_5_p192);
  const Real Lambda_5_5_p197 = Lambda_5_5_p191 * Lambda_5_5_p196;
  const Real Lambda_5_5_p198 = Lambda_5_5_p140 * Lambda_5_5_p163;
  const Real Lambda_5_5_p199 = Lambda_5_5_p172 + Lambda_5_5_p157 * Lambda_5_5_p198;
  const Real Lambda_5_5_p200 = Lambda_5_5_p199 * Lambda_5_5_p173;
  const Real Lambda_5_5_p201 = Lambda_5_5_p193 + Lambda_5_5_p184 * Lambda_5_5_p198 +
      Lambda_5_5_p190 * Lambda_5_5_p200;
  const Real Lambda_5_5_p202 = Lambda_5_5_p137 - Lambda_5_5_p140 * Lambda_5_5_p164 +
      Lambda_5_5_p199 * Lambda_5_5_p174 + Lambda_5_5_p201 * Lambda_5_5_p197;
  const Real Lambda_5_5_p203 = Lambda_5_5_p201 * Lambda_5_5_p196;
  const Real Lambda_5_5_p204 = 1.0 / (Lambda_5_5_p171 + Lambda_5_5_p140 * Lambda_5_5_p198 +
      Lambda_5_5_p199 * Lambda_5_5_p200 + Lambda_5_5_p201 * Lambda_5_5_p203);
  const Real Lambda_5_5_p205 = Lambda_5_5_p202 * Lambda_5_5_p204;
  const Real Lambda_5_5_p206 = Lambda_5_5_p161 * Lambda_5_5_p163;
  const Real Lambda_5_5_p207 = Lambda_5_5_p189 + Lambda_5_5_p157 * Lambda_5_5_p206;
  const Real Lambda_5_5_p208 = Lambda_5_5_p207 * Lambda_5_5_p173;
  const Real Lambda_5_5_p209 = Lambda_5_5_p195 - Lambda_5_5_p184 * Lambda_5_5_p206 -
      Lambda_5_5_p190 * Lambda_5_5_p208;
  const Real Lambda_5_5_p210 = Lambda_5_5_p209 * Lambda_5_5_p196;
  const Real Lambda_5_5_p211 = Lambda_5_5_p109 + Lambda_5_5_p140 * Lambda_5_5_p206 +
      Lambda_5_5_p199 * Lambda_5_5_p208 - Lambda_5_5_p201 * Lambda_5_5_p210;
  const Real Lambda_5_5_p212 = Lambda_5_5_p147 - Lambda_5_5_p161 * Lambda_5_5_p164 +
      Lambda_5_5_p207 * Lambda_5_5_p174 - Lambda_5_5_p209 * Lambda_5_5_p197 - Lambda_5_5_p211 *
      Lambda_5_5_p205;
  const Real Lambda_5_5_p213 = Lambda_5_5_p211 * Lambda_5_5_p204;
  const Real Lambda_5_5_p214 = Lambda_5_5_p160 + Lambda_5_5_p161 * Lambda_5_5_p206 +
      Lambda_5_5_p207 * Lambda_5_5_p208 + Lambda_5_5_p209 * Lambda_5_5_p210 - Lambda_5_5_p211 *
      Lambda_5_5_p213;
  const Real Lambda_5_5_p215 = 1.0 / Lambda_5_5_p214;
  const Real Lambda_5_5_p216 = Lambda_5_5_p212 * Lambda_5_5_p215;
  const Real Lambda_5_5_p217 = Lambda_5_5_p149 + Lambda_5_5_p150 * Lambda_5_5_p164 +
      Lambda_5_5_p166 * Lambda_5_5_p174 + Lambda_5_5_p191 * Lambda_5_5_p197 - Lambda_5_5_p202 *
      Lambda_5_5_p205;
  const Real Lambda_5_5 = 1.0 / (Lambda_5_5_p217 - Lambda_5_5_p212 * Lambda_5_5_p216);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5_p1 = Lambda_5_5_p185 + Lambda_5_5_p167 * Lambda_5_5_p192;
  const Real Lambda_0_5_p2 = Lambda_5_5_p198 + Lambda_5_5_p167 * Lambda_5_5_p200 + Lambda_5_5_p203 *
      Lambda_0_5_p1;
  const Real Lambda_0_5_p3 = Lambda_5_5_p206 + Lambda_5_5_p167 * Lambda_5_5_p208 - Lambda_5_5_p210 *
      Lambda_0_5_p1 - Lambda_5_5_p213 * Lambda_0_5_p2;
  const Real Lambda_0_5_p4 = Lambda_5_5_p164 - Lambda_5_5_p167 * Lambda_5_5_p174 - Lambda_5_5_p197 *
      Lambda_0_5_p1 + Lambda_5_5_p205 * Lambda_0_5_p2 + Lambda_5_5_p216 * Lambda_0_5_p3;
  const Real Lambda_0_5 = Lambda_5_5 * Lambda_0_5_p4;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_0_0_p1 = Lambda_5_5_p215 * Lambda_0_5_p3;
  const Real Lambda_0_0_p2 = Lambda_5_5_p204 * Lambda_0_5_p2;
  const Real Lambda_0_0_p3 = Lambda_5_5_p196 * Lambda_0_5_p1;
  const Real Lambda_0_0_p4 = Lambda_5_5_p167 * Lambda_5_5_p173;
  const Real Lambda_0_0_p5 = Lambda_5_5_p163 + Lambda_5_5_p167 * Lambda_0_0_p4 + Lambda_0_5_p1 *
      Lambda_0_0_p3 - Lambda_0_5_p2 * Lambda_0_0_p2 - Lambda_0_5_p3 * Lambda_0_0_p1;
  Lambda[0] = -(Lambda_0_0_p5 - Lambda_0_5_p4 * Lambda_0_5);
  const Real Lambda_1_5_p1 = Lambda_5_5_p200 + Lambda_5_5_p192 * Lambda_5_5_p203;
  const Real Lambda_1_5_p2 = Lambda_5_5_p208 - Lambda_5_5_p192 * Lambda_5_5_p210 - Lambda_5_5_p213 *
      Lambda_1_5_p1;
  const Real Lambda_1_5_p3 = Lambda_5_5_p174 + Lambda_5_5_p192 * Lambda_5_5_p197 - Lambda_5_5_p205 *
      Lambda_1_5_p1 - Lambda_5_5_p216 * Lambda_1_5_p2;
  const Real Lambda_1_5 = Lambda_5_5 * Lambda_1_5_p3;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_0_1_p1 = Lambda_5_5_p215 * Lambda_1_5_p2;
  const Real Lambda_0_1_p2 = Lambda_5_5_p204 * Lambda_1_5_p1;
  const Real Lambda_0_1_p3 = Lambda_5_5_p192 * Lambda_5_5_p196;
  const Real Lambda_0_1 = Lambda_0_0_p4 + Lambda_0_5_p1 * Lambda_0_1_p3 - Lambda_0_5_p2 *
      Lambda_0_1_p2 - Lambda_0_5_p3 * Lambda_0_1_p1 + Lambda_0_5_p4 * Lambda_1_5;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_2_5_p1 = Lambda_5_5_p210 + Lambda_5_5_p203 * Lambda_5_5_p213;
  const Real Lambda_2_5_p2 = Lambda_5_5_p197 - Lambda_5_5_p203 * Lambda_5_5_p205 + Lambda_5_5_p216 *
      Lambda_2_5_p1;
  const Real Lambda_2_5 = Lambda_5_5 * Lambda_2_5_p2;
  Lambda[17] = -Lambda_2_5;
  Lambda[32] = -Lambda_2_5;
  const Real Lambda_0_2_p1 = Lambda_5_5_p215 * Lambda_2_5_p1;
  const Real Lambda_0_2_p2 = Lambda_5_5_p203 * Lambda_5_5_p204;
  const Real Lambda_0_2 = Lambda_0_0_p3 - Lambda_0_5_p2 * Lambda_0_2_p2 + Lambda_0_5_p3 *
      Lambda_0_2_p1 + Lambda_0_5_p4 * Lambda_2_5;
  Lambda[2] = -Lambda_0_2;
  Lambda[12] = -Lambda_0_2;
  const Real Lambda_3_5_p1 = Lambda_5_5_p205 - Lambda_5_5_p213 * Lambda_5_5_p216;
  const Real Lambda_3_5 = Lambda_5_5 * Lambda_3_5_p1;
  Lambda[23] = -Lambda_3_5;
  Lambda[33] = -Lambda_3_5;
  const Real Lambda_0_3_p1 = Lambda_5_5_p213 * Lambda_5_5_p215;
  const Real Lambda_0_3 = Lambda_0_0_p2 - Lambda_0_5_p3 * Lambda_0_3_p1 + Lambda_0_5_p4 *
      Lambda_3_5;
  Lambda[3] = -Lambda_0_3;
  Lambda[18] = -Lambda_0_3;
  const Real Lambda_4_5 = Lambda_5_5_p216 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  const Real Lambda_0_4 = Lambda_0_0_p1 + Lambda_0_5_p4 * Lambda_4_5;
  Lambda[4] = -Lambda_0_4;
  Lambda[24] = -Lambda_0_4;
  Lambda[7] = -(Lambda_5_5_p173 + Lambda_5_5_p192 * Lambda_0_1_p3 - Lambda_1_5_p1 * Lambda_0_1_p2 -
      Lambda_1_5_p2 * Lambda_0_1_p1 - Lambda_1_5_p3 * Lambda_1_5);
  const Real Lambda_1_2 = Lambda_0_1_p3 - Lambda_1_5_p1 * Lambda_0_2_p2 + Lambda_1_5_p2 *
      Lambda_0_2_p1 - Lambda_1_5_p3 * Lambda_2_5;
  Lambda[8] = Lambda_1_2;
  Lambda[13] = Lambda_1_2;
  const Real Lambda_1_3 = Lambda_0_1_p2 - Lambda_1_5_p2 * Lambda_0_3_p1 - Lambda_1_5_p3 *
      Lambda_3_5;
  Lambda[9] = Lambda_1_3;
  Lambda[19] = Lambda_1_3;
  const Real Lambda_1_4 = Lambda_0_1_p1 - Lambda_1_5_p3 * Lambda_4_5;
  Lambda[10] = Lambda_1_4;
  Lambda[25] = Lambda_1_4;
  Lambda[14] = -(Lambda_5_5_p196 - Lambda_5_5_p203 * Lambda_0_2_p2 - Lambda_2_5_p1 * Lambda_0_2_p1 -
      Lambda_2_5_p2 * Lambda_2_5);
  const Real Lambda_2_3 = Lambda_0_2_p2 + Lambda_2_5_p1 * Lambda_0_3_p1 - Lambda_2_5_p2 *
      Lambda_3_5;
  Lambda[15] = -Lambda_2_3;
  Lambda[20] = -Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p1 + Lambda_2_5_p2 * Lambda_4_5;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_5_5_p204 + Lambda_5_5_p213 * Lambda_0_3_p1 + Lambda_3_5_p1 * Lambda_3_5;
  const Real Lambda_3_4 = Lambda_0_3_p1 - Lambda_3_5_p1 * Lambda_4_5;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_5_5_p215 + Lambda_5_5_p216 * Lambda_4_5;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
