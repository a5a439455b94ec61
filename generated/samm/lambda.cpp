// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J in world axes, in the axes asked for at link origins.
// 1202 flops (add 501, mul 689, div 12), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void lambda(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
  const Real angles[6] = {q[2], q[3], q[4], q[5], q[6], q[7]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real s3 = sines[0];
  const Real c3 = cosines[0];
  const Real s4 = sines[1];
  const Real c4 = cosines[1];
  const Real s5 = sines[2];
  const Real c5 = cosines[2];
  const Real s6 = sines[3];
  const Real c6 = cosines[3];
  const Real s7 = sines[4];
  const Real c7 = cosines[4];
  const Real s8 = sines[5];
  const Real c8 = cosines[5];

  // link 8 (link5), composite inertia
  const Real Lambda_5_5_p1 = 0.0028799999999999997 * s8;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p2 = c7 * Lambda_5_5_p1;
  const Real Lambda_5_5_p3 = 0.4331 * Lambda_5_5_p2;

  // link 8 (link5), composite inertia
  const Real Lambda_5_5_p4 = 0.00020215999999999998 * s8;
  const Real Lambda_5_5_p5 = c8 * Lambda_5_5_p4;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p6 = c7 * Lambda_5_5_p5;
  const Real Lambda_5_5_p7 = Lambda_5_5_p6 - (0.010673638499999999 - Lambda_5_5_p3 +
      5.846399999999999e-05 * c8);

  // link 8 (link5), composite inertia
  const Real Lambda_5_5_p8 = 0.0028799999999999997 * c8;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p9 = 0.861795 + Lambda_5_5_p8;
  const Real Lambda_5_5_p10 = 0.025374999999999998 - Lambda_5_5_p2;

  // link 6 (link3), composite inertia
  const Real Lambda_5_5_p11 = c6 * Lambda_5_5_p9 + s6 * Lambda_5_5_p10;

  // link 8 (link5), composite inertia
  const Real Lambda_5_5_p12 = s8 * Lambda_5_5_p4;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p13 = s7 * (0.00010000000000000026 + Lambda_5_5_p12);
  const Real Lambda_5_5_p14 = s7 * Lambda_5_5_p13;
  const Real Lambda_5_5_p15 = Lambda_5_5_p14 + (0.0011921599999999998 -
      (Lambda_5_5_p12 - (0.3056901365 + 0.0024946559999999996 * c8)));
  const Real Lambda_5_5_p16 = 0.008405112499999999 + Lambda_5_5_p12 - 0.0406 * Lambda_5_5_p2;

  // link 6 (link3), composite inertia
  const Real Lambda_5_5_p17 = Lambda_5_5_p7 * (2.0 * c6) + s6 * (Lambda_5_5_p15 - Lambda_5_5_p16);
  const Real Lambda_5_5_p18 = s6 * Lambda_5_5_p17;
  const Real Lambda_5_5_p19 = s6 * Lambda_5_5_p9 - c6 * Lambda_5_5_p10;
  const Real Lambda_5_5_p20 = 0.4318 * Lambda_5_5_p19;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p21 = s7 * Lambda_5_5_p1;

  // link 6 (link3), composite inertia
  const Real Lambda_5_5_p22 = Lambda_5_5_p18 + (Lambda_5_5_p16 +
      (1.674987602 + 2.0 * (Lambda_5_5_p20 + 0.1501 * Lambda_5_5_p21)));

  // link 5 (link2), composite inertia
  const Real Lambda_5_5_p23 = (Lambda_5_5_p7 + (0.0070992 - 0.4318 * Lambda_5_5_p11) - c6 *
      Lambda_5_5_p17) * (2.0 * c5) + s5 * (Lambda_5_5_p22 +
      (Lambda_5_5_p18 - (Lambda_5_5_p15 + (0.07312640000000001 + 0.3002 * Lambda_5_5_p21))));

  // link 9 (link6), mass matrix
  const Real Lambda_5_5_p24 = 4e-05 * c8;
  const Real Lambda_5_5_p25 = 4e-05 * s8;
  const Real Lambda_5_5_p26 = c7 * Lambda_5_5_p25;
  const Real Lambda_5_5_p27 = c5 * (c6 * Lambda_5_5_p24 - s6 * Lambda_5_5_p26) - s5 *
      (s6 * Lambda_5_5_p24 + c6 * Lambda_5_5_p26);

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p28 = 24999.999999999996 * Lambda_5_5_p27;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p29 = c7 * Lambda_5_5_p8;
  const Real Lambda_5_5_p30 = s6 * Lambda_5_5_p1 - c6 * Lambda_5_5_p29;
  const Real Lambda_5_5_p31 = s7 * Lambda_5_5_p8;
  const Real Lambda_5_5_p32 = 0.0203 * Lambda_5_5_p31;
  const Real Lambda_5_5_p33 = 0.4331 * Lambda_5_5_p31 + 0.00064216 * s7;
  const Real Lambda_5_5_p34 = c5 * (0.4318 * Lambda_5_5_p31 + 0.1501 * Lambda_5_5_p30 - c6 *
      Lambda_5_5_p32 + s6 * Lambda_5_5_p33);
  const Real Lambda_5_5_p35 = c6 * Lambda_5_5_p1 + s6 * Lambda_5_5_p29;
  const Real Lambda_5_5_p36 = Lambda_5_5_p34 + s5 *
      (0.1501 * Lambda_5_5_p35 + s6 * Lambda_5_5_p32 + c6 * Lambda_5_5_p33);

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p37 = 1557.24430048586 * Lambda_5_5_p36;

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p38 = c6 * Lambda_5_5_p21;

  // link 8 (link5), composite inertia
  const Real Lambda_5_5_p39 = 0.00164 + Lambda_5_5_p12;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p40 = 0.0203 * Lambda_5_5_p2;

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p41 = Lambda_5_5_p39 - Lambda_5_5_p40;
  const Real Lambda_5_5_p42 = Lambda_5_5_p3 + Lambda_5_5_p6;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p43 = c5 * (0.4318 * Lambda_5_5_p2 + 0.1501 * Lambda_5_5_p38 + c6 *
      Lambda_5_5_p41 + s6 * Lambda_5_5_p42);

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p44 = s6 * Lambda_5_5_p21;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p45 = 0.9999999999999999 * c8;
  const Real Lambda_5_5_p46 = Lambda_5_5_p43 - s5 *
      (0.1501 * Lambda_5_5_p44 + s6 * Lambda_5_5_p41 - c6 * Lambda_5_5_p42) - Lambda_5_5_p27 *
      Lambda_5_5_p45;
  const Real Lambda_5_5_p47 = 1.0 / (Lambda_5_5_p39 - Lambda_5_5_p24 * Lambda_5_5_p45);
  const Real Lambda_5_5_p48 = Lambda_5_5_p46 * Lambda_5_5_p47;
  const Real Lambda_5_5_p49 = 1.4717295504999999 + Lambda_5_5_p22 - s5 * Lambda_5_5_p23 -
      Lambda_5_5_p27 * Lambda_5_5_p28 - Lambda_5_5_p36 * Lambda_5_5_p37 - Lambda_5_5_p46 *
      Lambda_5_5_p48;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p50 = 0.4331 * Lambda_5_5_p21 + s7 * Lambda_5_5_p5;
  const Real Lambda_5_5_p51 = 0.004704000000000001 + Lambda_5_5_p50;
  const Real Lambda_5_5_p52 = 0.0203 * Lambda_5_5_p21 - c7 * Lambda_5_5_p13;

  // link 6 (link3), composite inertia
  const Real Lambda_5_5_p53 = 0.1501 * Lambda_5_5_p11 + c6 * Lambda_5_5_p51 + s6 * Lambda_5_5_p52;
  const Real Lambda_5_5_p54 = s6 * Lambda_5_5_p51 - c6 * Lambda_5_5_p52;
  const Real Lambda_5_5_p55 = 0.1501 * Lambda_5_5_p19;

  // link 9 (link6), mass matrix
  const Real Lambda_5_5_p56 = s7 * Lambda_5_5_p25;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p57 = 24999.999999999996 * Lambda_5_5_p56;
  const Real Lambda_5_5_p58 = Lambda_5_5_p27 * Lambda_5_5_p57;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p59 = 0.4331 * Lambda_5_5_p29 - 5.846399999999999e-05 * s8 + 0.00064216 *
      c7;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p60 = 1557.24430048586 * Lambda_5_5_p59;
  const Real Lambda_5_5_p61 = Lambda_5_5_p56 * Lambda_5_5_p45;
  const Real Lambda_5_5_p62 = Lambda_5_5_p50 + Lambda_5_5_p61;
  const Real Lambda_5_5_p63 = Lambda_5_5_p62 * Lambda_5_5_p47;
  const Real Lambda_5_5_p64 = Lambda_5_5_p58 + (c5 * Lambda_5_5_p53 - s5 *
      (Lambda_5_5_p55 + Lambda_5_5_p54)) + Lambda_5_5_p36 * Lambda_5_5_p60 - Lambda_5_5_p46 *
      Lambda_5_5_p63;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p65 = Lambda_5_5_p14 + (2.0 *
      (Lambda_5_5_p40 - 0.0012473279999999998 * c8) - 0.313747409);

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p66 = Lambda_5_5_p56 * Lambda_5_5_p57;
  const Real Lambda_5_5_p67 = 1.0 / (Lambda_5_5_p65 + Lambda_5_5_p66 + Lambda_5_5_p59 *
      Lambda_5_5_p60 + Lambda_5_5_p62 * Lambda_5_5_p63);
  const Real Lambda_5_5_p68 = Lambda_5_5_p64 * Lambda_5_5_p67;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p69 = Lambda_5_5_p59 + 0.4318 * Lambda_5_5_p35;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p70 = Lambda_5_5_p61 + (Lambda_5_5_p50 + 0.4318 * Lambda_5_5_p44);
  const Real Lambda_5_5_p71 = Lambda_5_5_p66 + (Lambda_5_5_p65 - Lambda_5_5_p20) + Lambda_5_5_p69 *
      Lambda_5_5_p60 + Lambda_5_5_p70 * Lambda_5_5_p63;
  const Real Lambda_5_5_p72 = Lambda_5_5_p71 * Lambda_5_5_p67;
  const Real Lambda_5_5_p73 = c5 * (0.023750999999999998 - Lambda_5_5_p53) + s5 *
      (Lambda_5_5_p54 + (0.690314699 + Lambda_5_5_p55 + 0.4318 * Lambda_5_5_p21));
  const Real Lambda_5_5_p74 = 1557.24430048586 * Lambda_5_5_p69;
  const Real Lambda_5_5_p75 = Lambda_5_5_p70 * Lambda_5_5_p47;
  const Real Lambda_5_5_p76 = Lambda_5_5_p58 - Lambda_5_5_p73 + Lambda_5_5_p36 * Lambda_5_5_p74 -
      Lambda_5_5_p46 * Lambda_5_5_p75 - Lambda_5_5_p64 * Lambda_5_5_p72;
  const Real Lambda_5_5_p77 = Lambda_5_5_p66 - (1.7481140020000001 - Lambda_5_5_p65 + 0.8636 *
      Lambda_5_5_p19) + Lambda_5_5_p69 * Lambda_5_5_p74 + Lambda_5_5_p70 * Lambda_5_5_p75;
  const Real Lambda_5_5_p78 = 1.0 / (Lambda_5_5_p77 - Lambda_5_5_p71 * Lambda_5_5_p72);
  const Real Lambda_5_5_p79 = Lambda_5_5_p76 * Lambda_5_5_p78;
  const Real Lambda_5_5_p80 = 1.0 / (Lambda_5_5_p49 + Lambda_5_5_p64 * Lambda_5_5_p68 +
      Lambda_5_5_p76 * Lambda_5_5_p79);

  // link 6 (link3), mass matrix
  const Real Lambda_5_5_p81 = s5 * Lambda_5_5_p19 - c5 * Lambda_5_5_p11;
  const Real Lambda_5_5_p82 = s4 * Lambda_5_5_p81;
  const Real Lambda_5_5_p83 = c4 * Lambda_5_5_p81;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p84 = s5 * Lambda_5_5_p35 + c5 * Lambda_5_5_p30;
  const Real Lambda_5_5_p85 = c4 * Lambda_5_5_p31 - s4 * Lambda_5_5_p84;
  const Real Lambda_5_5_p86 = s4 * Lambda_5_5_p31 + c4 * Lambda_5_5_p84;
  const Real Lambda_5_5_p87 = c3 * Lambda_5_5_p85 - s3 * Lambda_5_5_p86;

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p88 = s5 * Lambda_5_5_p44 - c5 * Lambda_5_5_p38;
  const Real Lambda_5_5_p89 = c4 * Lambda_5_5_p2 + s4 * Lambda_5_5_p88;
  const Real Lambda_5_5_p90 = s4 * Lambda_5_5_p2 - c4 * Lambda_5_5_p88;
  const Real Lambda_5_5_p91 = c3 * Lambda_5_5_p89 - s3 * Lambda_5_5_p90;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p92 = c3 * Lambda_5_5_p82 + s3 * Lambda_5_5_p83 + Lambda_5_5_p87 *
      Lambda_5_5_p60 - Lambda_5_5_p91 * Lambda_5_5_p63;

  // link 6 (link3), composite inertia
  const Real Lambda_5_5_p93 = 0.10439999999999999 - Lambda_5_5_p11;
  const Real Lambda_5_5_p94 = 3.79559 + Lambda_5_5_p19;

  // link 5 (link2), composite inertia
  const Real Lambda_5_5_p95 = c5 * Lambda_5_5_p93 + s5 * Lambda_5_5_p94;

  // link 5 (link2), mass matrix
  const Real Lambda_5_5_p96 = s4 * Lambda_5_5_p95;
  const Real Lambda_5_5_p97 = c4 * Lambda_5_5_p95;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p98 = c3 * Lambda_5_5_p96 + s3 * Lambda_5_5_p97 + Lambda_5_5_p87 *
      Lambda_5_5_p74 - Lambda_5_5_p91 * Lambda_5_5_p75 - Lambda_5_5_p92 * Lambda_5_5_p72;

  // link 5 (link2), composite inertia
  const Real Lambda_5_5_p99 = s5 * Lambda_5_5_p93 - c5 * Lambda_5_5_p94;
  const Real Lambda_5_5_p100 = 4.9338049999999996 + Lambda_5_5_p21;

  // link 4 (link1), composite inertia
  const Real Lambda_5_5_p101 = c4 * Lambda_5_5_p100 - s4 * Lambda_5_5_p99;
  const Real Lambda_5_5_p102 = s4 * Lambda_5_5_p100 + c4 * Lambda_5_5_p99;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p103 = s3 * Lambda_5_5_p101 + c3 * Lambda_5_5_p102 + Lambda_5_5_p87 *
      Lambda_5_5_p37 + Lambda_5_5_p91 * Lambda_5_5_p48 - Lambda_5_5_p92 * Lambda_5_5_p68;
  const Real Lambda_5_5_p104 = Lambda_5_5_p103 - Lambda_5_5_p98 * Lambda_5_5_p79;
  const Real Lambda_5_5_p105 = Lambda_5_5_p104 * Lambda_5_5_p80;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p106 = s3 * Lambda_5_5_p85 + c3 * Lambda_5_5_p86;

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p107 = s3 * Lambda_5_5_p89 + c3 * Lambda_5_5_p90;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p108 = s3 * Lambda_5_5_p82 - c3 * Lambda_5_5_p83 + Lambda_5_5_p106 *
      Lambda_5_5_p60 - Lambda_5_5_p107 * Lambda_5_5_p63;
  const Real Lambda_5_5_p109 = s3 * Lambda_5_5_p96 - c3 * Lambda_5_5_p97 + Lambda_5_5_p106 *
      Lambda_5_5_p74 - Lambda_5_5_p107 * Lambda_5_5_p75 - Lambda_5_5_p108 * Lambda_5_5_p72;
  const Real Lambda_5_5_p110 = c3 * Lambda_5_5_p101 - s3 * Lambda_5_5_p102 - Lambda_5_5_p106 *
      Lambda_5_5_p37 - Lambda_5_5_p107 * Lambda_5_5_p48 + Lambda_5_5_p108 * Lambda_5_5_p68;
  const Real Lambda_5_5_p111 = Lambda_5_5_p110 + Lambda_5_5_p109 * Lambda_5_5_p79;
  const Real Lambda_5_5_p112 = Lambda_5_5_p98 * Lambda_5_5_p78;
  const Real Lambda_5_5_p113 = Lambda_5_5_p92 * Lambda_5_5_p67;
  const Real Lambda_5_5_p114 = 1557.24430048586 * Lambda_5_5_p87;
  const Real Lambda_5_5_p115 = Lambda_5_5_p91 * Lambda_5_5_p47;
  const Real Lambda_5_5_p116 = Lambda_5_5_p106 * Lambda_5_5_p114 + Lambda_5_5_p107 *
      Lambda_5_5_p115 - Lambda_5_5_p108 * Lambda_5_5_p113 - Lambda_5_5_p109 * Lambda_5_5_p112 -
      Lambda_5_5_p111 * Lambda_5_5_p105;
  const Real Lambda_5_5_p117 = 186.45 - Lambda_5_5_p87 * Lambda_5_5_p114 - Lambda_5_5_p91 *
      Lambda_5_5_p115 + Lambda_5_5_p92 * Lambda_5_5_p113 + Lambda_5_5_p98 * Lambda_5_5_p112;
  const Real Lambda_5_5_p118 = 1.0 / (Lambda_5_5_p117 - Lambda_5_5_p104 * Lambda_5_5_p105);
  const Real Lambda_5_5_p119 = Lambda_5_5_p116 * Lambda_5_5_p118;

  // link 4 (link1), pose
  const Real Lambda_5_5_p120 = s3 * s4 - c3 * c4;

  // link 5 (link2), pose
  const Real Lambda_5_5_p121 = s5 * Lambda_5_5_p120;
  const Real Lambda_5_5_p122 = c5 * Lambda_5_5_p120;

  // link 6 (link3), pose
  const Real Lambda_5_5_p123 = c6 * Lambda_5_5_p121 + s6 * Lambda_5_5_p122;
  const Real Lambda_5_5_p124 = s6 * Lambda_5_5_p121 - c6 * Lambda_5_5_p122;

  // link 4 (link1), pose
  const Real Lambda_5_5_p125 = s3 * c4 + c3 * s4;

  // link 8 (link5), pose
  const Real Lambda_5_5_p126 = c8 * Lambda_5_5_p123 + s8 *
      (s7 * Lambda_5_5_p125 - c7 * Lambda_5_5_p124);

  // link 7 (link4), pose
  const Real Lambda_5_5_p127 = c7 * Lambda_5_5_p125 + s7 * Lambda_5_5_p124;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p128 = Lambda_5_5_p123 - Lambda_5_5_p126 * Lambda_5_5_p45;
  const Real Lambda_5_5_p129 = Lambda_5_5_p125 - Lambda_5_5_p126 * Lambda_5_5_p57;
  const Real Lambda_5_5_p130 = Lambda_5_5_p129 - Lambda_5_5_p127 * Lambda_5_5_p60 + Lambda_5_5_p63 *
      Lambda_5_5_p128;
  const Real Lambda_5_5_p131 = Lambda_5_5_p129 - Lambda_5_5_p127 * Lambda_5_5_p74 + Lambda_5_5_p75 *
      Lambda_5_5_p128 - Lambda_5_5_p72 * Lambda_5_5_p130;
  const Real Lambda_5_5_p132 = Lambda_5_5_p126 * Lambda_5_5_p28 + Lambda_5_5_p127 * Lambda_5_5_p37 +
      Lambda_5_5_p48 * Lambda_5_5_p128 + Lambda_5_5_p68 * Lambda_5_5_p130 + Lambda_5_5_p79 *
      Lambda_5_5_p131;
  const Real Lambda_5_5_p133 = Lambda_5_5_p127 * Lambda_5_5_p114 + Lambda_5_5_p115 *
      Lambda_5_5_p128 + Lambda_5_5_p113 * Lambda_5_5_p130 + Lambda_5_5_p112 * Lambda_5_5_p131 +
      Lambda_5_5_p105 * Lambda_5_5_p132;
  const Real Lambda_5_5_p134 = Lambda_5_5_p111 * Lambda_5_5_p80;
  const Real Lambda_5_5_p135 = Lambda_5_5_p109 * Lambda_5_5_p78;
  const Real Lambda_5_5_p136 = Lambda_5_5_p108 * Lambda_5_5_p67;
  const Real Lambda_5_5_p137 = 1557.24430048586 * Lambda_5_5_p106;
  const Real Lambda_5_5_p138 = Lambda_5_5_p107 * Lambda_5_5_p47;
  const Real Lambda_5_5_p139 = Lambda_5_5_p127 * Lambda_5_5_p137 + Lambda_5_5_p138 *
      Lambda_5_5_p128 + Lambda_5_5_p136 * Lambda_5_5_p130 + Lambda_5_5_p135 * Lambda_5_5_p131 -
      Lambda_5_5_p134 * Lambda_5_5_p132;
  const Real Lambda_5_5_p140 = Lambda_5_5_p139 + Lambda_5_5_p119 * Lambda_5_5_p133;

  // link 5 (link2), pose
  const Real Lambda_5_5_p141 = s5 * Lambda_5_5_p125;
  const Real Lambda_5_5_p142 = c5 * Lambda_5_5_p125;

  // link 6 (link3), pose
  const Real Lambda_5_5_p143 = c6 * Lambda_5_5_p141 + s6 * Lambda_5_5_p142;
  const Real Lambda_5_5_p144 = s6 * Lambda_5_5_p141 - c6 * Lambda_5_5_p142;

  // link 8 (link5), pose
  const Real Lambda_5_5_p145 = c8 * Lambda_5_5_p143 - s8 *
      (s7 * Lambda_5_5_p120 + c7 * Lambda_5_5_p144);

  // link 7 (link4), pose
  const Real Lambda_5_5_p146 = c7 * Lambda_5_5_p120 - s7 * Lambda_5_5_p144;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p147 = Lambda_5_5_p143 - Lambda_5_5_p145 * Lambda_5_5_p45;
  const Real Lambda_5_5_p148 = Lambda_5_5_p120 + Lambda_5_5_p145 * Lambda_5_5_p57;
  const Real Lambda_5_5_p149 = Lambda_5_5_p148 - Lambda_5_5_p146 * Lambda_5_5_p60 - Lambda_5_5_p63 *
      Lambda_5_5_p147;
  const Real Lambda_5_5_p150 = Lambda_5_5_p148 - Lambda_5_5_p146 * Lambda_5_5_p74 - Lambda_5_5_p75 *
      Lambda_5_5_p147 - Lambda_5_5_p72 * Lambda_5_5_p149;
  const Real Lambda_5_5_p151 = Lambda_5_5_p145 * Lambda_5_5_p28 - Lambda_5_5_p146 * Lambda_5_5_p37 +
      Lambda_5_5_p48 * Lambda_5_5_p147 - Lambda_5_5_p68 * Lambda_5_5_p149 - Lambda_5_5_p79 *
      Lambda_5_5_p150;
  const Real Lambda_5_5_p152 = Lambda_5_5_p146 * Lambda_5_5_p114 - Lambda_5_5_p115 *
      Lambda_5_5_p147 + Lambda_5_5_p113 * Lambda_5_5_p149 + Lambda_5_5_p112 * Lambda_5_5_p150 -
      Lambda_5_5_p105 * Lambda_5_5_p151;
  const Real Lambda_5_5_p153 = Lambda_5_5_p146 * Lambda_5_5_p137 - Lambda_5_5_p138 *
      Lambda_5_5_p147 + Lambda_5_5_p136 * Lambda_5_5_p149 + Lambda_5_5_p135 * Lambda_5_5_p150 +
      Lambda_5_5_p134 * Lambda_5_5_p151;
  const Real Lambda_5_5_p154 = Lambda_5_5_p153 + Lambda_5_5_p119 * Lambda_5_5_p152;
  const Real Lambda_5_5_p155 = 186.45 - Lambda_5_5_p106 * Lambda_5_5_p137 - Lambda_5_5_p107 *
      Lambda_5_5_p138 + Lambda_5_5_p108 * Lambda_5_5_p136 + Lambda_5_5_p109 * Lambda_5_5_p135;
  const Real Lambda_5_5_p156 = 1.0 / (Lambda_5_5_p155 - Lambda_5_5_p111 * Lambda_5_5_p134 -
      Lambda_5_5_p116 * Lambda_5_5_p119);
  const Real Lambda_5_5_p157 = Lambda_5_5_p156 * Lambda_5_5_p154;
  const Real Lambda_5_5_p158 = Lambda_5_5_p118 * Lambda_5_5_p152;
  const Real Lambda_5_5_p159 = Lambda_5_5_p80 * Lambda_5_5_p151;
  const Real Lambda_5_5_p160 = 24999.999999999996 * Lambda_5_5_p145;
  const Real Lambda_5_5_p161 = 1557.24430048586 * Lambda_5_5_p146;
  const Real Lambda_5_5_p162 = Lambda_5_5_p47 * Lambda_5_5_p147;
  const Real Lambda_5_5_p163 = Lambda_5_5_p67 * Lambda_5_5_p149;
  const Real Lambda_5_5_p164 = Lambda_5_5_p78 * Lambda_5_5_p150;
  const Real Lambda_5_5_p165 = Lambda_5_5_p126 * Lambda_5_5_p160 - Lambda_5_5_p127 *
      Lambda_5_5_p161 + Lambda_5_5_p128 * Lambda_5_5_p162 + Lambda_5_5_p130 * Lambda_5_5_p163 +
      Lambda_5_5_p131 * Lambda_5_5_p164;
  const Real Lambda_5_5_p166 = Lambda_5_5_p165 + Lambda_5_5_p132 * Lambda_5_5_p159 -
      Lambda_5_5_p133 * Lambda_5_5_p158 - Lambda_5_5_p140 * Lambda_5_5_p157;

  // link 6 (link3), pose
  const Real Lambda_5_5_p167 = c5 * c6 - s5 * s6;
  const Real Lambda_5_5_p168 = c5 * s6 + s5 * c6;

  // link 8 (link5), pose
  const Real Lambda_5_5_p169 = c8 * Lambda_5_5_p167 - Lambda_5_5_p168 * (c7 * s8);

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p170 = 0.05625 * Lambda_5_5_p169;
  const Real Lambda_5_5_p171 = Lambda_5_5_p166 * Lambda_5_5_p170;
  const Real Lambda_5_5_p172 = Lambda_5_5_p80 * Lambda_5_5_p132;

  // link 7 (link4), pose
  const Real Lambda_5_5_p173 = 0.4331 * Lambda_5_5_p167 + 0.0203 * Lambda_5_5_p168;

  // link 6 (link3), Jacobian
  const Real Lambda_5_5_p174 = Lambda_5_5_p120 * Lambda_5_5_p173;

  // link 5 (link2), Jacobian
  const Real Lambda_5_5_p175 = Lambda_5_5_p173 - 0.4318 * s5;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p176 = Lambda_5_5_p120 * Lambda_5_5_p175 - Lambda_5_5_p174 * Lambda_5_5_p72;

  // link 7 (link4), pose
  const Real Lambda_5_5_p177 = 0.4331 * Lambda_5_5_p143 + 0.0203 * Lambda_5_5_p144;

  // link 5 (link2), Jacobian
  const Real Lambda_5_5_p178 = Lambda_5_5_p177 - (0.1501 * Lambda_5_5_p120 - 0.4318 *
      Lambda_5_5_p142);

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p179 = Lambda_5_5_p178 - Lambda_5_5_p174 * Lambda_5_5_p68 - Lambda_5_5_p79 *
      Lambda_5_5_p176;
  const Real Lambda_5_5_p180 = Lambda_5_5_p78 * Lambda_5_5_p131;
  const Real Lambda_5_5_p181 = Lambda_5_5_p67 * Lambda_5_5_p130;
  const Real Lambda_5_5_p182 = Lambda_5_5_p118 * Lambda_5_5_p133;
  const Real Lambda_5_5_p183 = Lambda_5_5_p174 * Lambda_5_5_p113 + Lambda_5_5_p112 *
      Lambda_5_5_p176 - Lambda_5_5_p105 * Lambda_5_5_p179;
  const Real Lambda_5_5_p184 = Lambda_5_5_p156 * Lambda_5_5_p140;
  const Real Lambda_5_5_p185 = 1.0 - Lambda_5_5_p174 * Lambda_5_5_p136 - Lambda_5_5_p135 *
      Lambda_5_5_p176 - Lambda_5_5_p134 * Lambda_5_5_p179 - Lambda_5_5_p119 * Lambda_5_5_p183;
  const Real Lambda_5_5_p186 = Lambda_5_5_p174 * Lambda_5_5_p181 + Lambda_5_5_p176 *
      Lambda_5_5_p180 + Lambda_5_5_p179 * Lambda_5_5_p172 - Lambda_5_5_p183 * Lambda_5_5_p182 +
      Lambda_5_5_p185 * Lambda_5_5_p184;
  const Real Lambda_5_5_p187 = Lambda_5_5_p169 * Lambda_5_5_p57;

  // link 7 (link4), pose
  const Real Lambda_5_5_p188 = s7 * Lambda_5_5_p168;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p189 = Lambda_5_5_p167 - Lambda_5_5_p169 * Lambda_5_5_p45;
  const Real Lambda_5_5_p190 = Lambda_5_5_p187 + Lambda_5_5_p188 * Lambda_5_5_p60 - Lambda_5_5_p63 *
      Lambda_5_5_p189;
  const Real Lambda_5_5_p191 = Lambda_5_5_p187 + Lambda_5_5_p188 * Lambda_5_5_p74 - Lambda_5_5_p75 *
      Lambda_5_5_p189 - Lambda_5_5_p72 * Lambda_5_5_p190;
  const Real Lambda_5_5_p192 = 1.0 - Lambda_5_5_p169 * Lambda_5_5_p28 - Lambda_5_5_p188 *
      Lambda_5_5_p37 - Lambda_5_5_p48 * Lambda_5_5_p189 + Lambda_5_5_p68 * Lambda_5_5_p190;
  const Real Lambda_5_5_p193 = Lambda_5_5_p192 + Lambda_5_5_p79 * Lambda_5_5_p191;
  const Real Lambda_5_5_p194 = Lambda_5_5_p188 * Lambda_5_5_p114 + Lambda_5_5_p115 *
      Lambda_5_5_p189 - Lambda_5_5_p113 * Lambda_5_5_p190 - Lambda_5_5_p112 * Lambda_5_5_p191 -
      Lambda_5_5_p105 * Lambda_5_5_p193;
  const Real Lambda_5_5_p195 = Lambda_5_5_p188 * Lambda_5_5_p137 + Lambda_5_5_p138 *
      Lambda_5_5_p189 - Lambda_5_5_p136 * Lambda_5_5_p190 - Lambda_5_5_p135 * Lambda_5_5_p191 +
      Lambda_5_5_p134 * Lambda_5_5_p193;
  const Real Lambda_5_5_p196 = Lambda_5_5_p195 + Lambda_5_5_p119 * Lambda_5_5_p194;
  const Real Lambda_5_5_p197 = Lambda_5_5_p156 * Lambda_5_5_p196;
  const Real Lambda_5_5_p198 = Lambda_5_5_p118 * Lambda_5_5_p194;
  const Real Lambda_5_5_p199 = Lambda_5_5_p80 * Lambda_5_5_p193;
  const Real Lambda_5_5_p200 = Lambda_5_5_p78 * Lambda_5_5_p191;
  const Real Lambda_5_5_p201 = Lambda_5_5_p67 * Lambda_5_5_p190;
  const Real Lambda_5_5_p202 = 24999.999999999996 * Lambda_5_5_p169;
  const Real Lambda_5_5_p203 = 1557.24430048586 * Lambda_5_5_p188;
  const Real Lambda_5_5_p204 = Lambda_5_5_p47 * Lambda_5_5_p189;
  const Real Lambda_5_5_p205 = Lambda_5_5_p126 * Lambda_5_5_p202 + Lambda_5_5_p127 *
      Lambda_5_5_p203 + Lambda_5_5_p128 * Lambda_5_5_p204 + Lambda_5_5_p130 * Lambda_5_5_p201 +
      Lambda_5_5_p131 * Lambda_5_5_p200;
  const Real Lambda_5_5_p206 = Lambda_5_5_p205 - Lambda_5_5_p132 * Lambda_5_5_p199 +
      Lambda_5_5_p133 * Lambda_5_5_p198 + Lambda_5_5_p140 * Lambda_5_5_p197;
  const Real Lambda_5_5_p207 = 0.05625 * Lambda_5_5_p145;
  const Real Lambda_5_5_p208 = Lambda_5_5_p206 * Lambda_5_5_p207;
  const Real Lambda_5_5_p209 = Lambda_5_5_p208 - (Lambda_5_5_p171 + Lambda_5_5_p186);

  // link 7 (link4), pose
  const Real Lambda_5_5_p210 = 0.4331 * Lambda_5_5_p123 + 0.0203 * Lambda_5_5_p124;

  // link 6 (link3), Jacobian
  const Real Lambda_5_5_p211 = Lambda_5_5_p120 * Lambda_5_5_p210 + Lambda_5_5_p125 *
      Lambda_5_5_p177;

  // link 5 (link2), Jacobian
  const Real Lambda_5_5_p212 = Lambda_5_5_p210 + (0.1501 * Lambda_5_5_p125 + 0.4318 *
      Lambda_5_5_p122);

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p213 = Lambda_5_5_p120 * Lambda_5_5_p212 + Lambda_5_5_p125 *
      Lambda_5_5_p178 - Lambda_5_5_p211 * Lambda_5_5_p72;
  const Real Lambda_5_5_p214 = Lambda_5_5_p211 * Lambda_5_5_p68 + Lambda_5_5_p79 * Lambda_5_5_p213;
  const Real Lambda_5_5_p215 = Lambda_5_5_p211 * Lambda_5_5_p113 + Lambda_5_5_p112 *
      Lambda_5_5_p213 + Lambda_5_5_p105 * Lambda_5_5_p214;
  const Real Lambda_5_5_p216 = Lambda_5_5_p211 * Lambda_5_5_p136 + Lambda_5_5_p135 *
      Lambda_5_5_p213 - Lambda_5_5_p134 * Lambda_5_5_p214 + Lambda_5_5_p119 * Lambda_5_5_p215;
  const Real Lambda_5_5_p217 = Lambda_5_5_p211 * Lambda_5_5_p201 + Lambda_5_5_p213 *
      Lambda_5_5_p200 - Lambda_5_5_p214 * Lambda_5_5_p199 + Lambda_5_5_p215 * Lambda_5_5_p198 +
      Lambda_5_5_p216 * Lambda_5_5_p197;
  const Real Lambda_5_5_p218 = Lambda_5_5_p174 * Lambda_5_5_p163 + Lambda_5_5_p176 *
      Lambda_5_5_p164 - Lambda_5_5_p179 * Lambda_5_5_p159 - Lambda_5_5_p183 * Lambda_5_5_p158 +
      Lambda_5_5_p185 * Lambda_5_5_p157;
  const Real Lambda_5_5_p219 = Lambda_5_5_p145 * Lambda_5_5_p160 + Lambda_5_5_p146 *
      Lambda_5_5_p161 + Lambda_5_5_p147 * Lambda_5_5_p162 - Lambda_5_5_p149 * Lambda_5_5_p163 -
      Lambda_5_5_p150 * Lambda_5_5_p164;
  const Real Lambda_5_5_p220 = Lambda_5_5_p219 + Lambda_5_5_p151 * Lambda_5_5_p159 +
      Lambda_5_5_p152 * Lambda_5_5_p158 + Lambda_5_5_p154 * Lambda_5_5_p157;
  const Real Lambda_5_5_p221 = Lambda_5_5_p145 * Lambda_5_5_p202 - Lambda_5_5_p146 *
      Lambda_5_5_p203 + Lambda_5_5_p147 * Lambda_5_5_p204 - Lambda_5_5_p149 * Lambda_5_5_p201 -
      Lambda_5_5_p150 * Lambda_5_5_p200;
  const Real Lambda_5_5_p222 = Lambda_5_5_p221 - Lambda_5_5_p151 * Lambda_5_5_p199 -
      Lambda_5_5_p152 * Lambda_5_5_p198 - Lambda_5_5_p154 * Lambda_5_5_p197;
  const Real Lambda_5_5_p223 = Lambda_5_5_p218 - Lambda_5_5_p220 * Lambda_5_5_p170 +
      Lambda_5_5_p222 * Lambda_5_5_p207;
  const Real Lambda_5_5_p224 = 0.05625 * Lambda_5_5_p126;
  const Real Lambda_5_5_p225 = Lambda_5_5_p156 * Lambda_5_5_p216;
  const Real Lambda_5_5_p226 = Lambda_5_5_p118 * Lambda_5_5_p215;
  const Real Lambda_5_5_p227 = Lambda_5_5_p80 * Lambda_5_5_p214;
  const Real Lambda_5_5_p228 = Lambda_5_5_p78 * Lambda_5_5_p213;
  const Real Lambda_5_5_p229 = Lambda_5_5_p211 * Lambda_5_5_p67;
  const Real Lambda_5_5_p230 = Lambda_5_5_p174 * Lambda_5_5_p229 + Lambda_5_5_p176 *
      Lambda_5_5_p228 + Lambda_5_5_p179 * Lambda_5_5_p227 - Lambda_5_5_p183 * Lambda_5_5_p226 +
      Lambda_5_5_p185 * Lambda_5_5_p225;
  const Real Lambda_5_5_p231 = Lambda_5_5_p211 * Lambda_5_5_p163 + Lambda_5_5_p213 *
      Lambda_5_5_p164 + Lambda_5_5_p214 * Lambda_5_5_p159 - Lambda_5_5_p215 * Lambda_5_5_p158 -
      Lambda_5_5_p216 * Lambda_5_5_p157;
  const Real Lambda_5_5_p232 = Lambda_5_5_p207 * (Lambda_5_5_p217 + Lambda_5_5_p209) -
      (Lambda_5_5_p230 + Lambda_5_5_p224 * Lambda_5_5_p223 + Lambda_5_5_p231 * Lambda_5_5_p170);
  const Real Lambda_5_5_p233 = Lambda_5_5_p67 * (Lambda_5_5_p174 * Lambda_5_5_p174) +
      Lambda_5_5_p176 * (Lambda_5_5_p78 * Lambda_5_5_p176) - Lambda_5_5_p179 *
      (Lambda_5_5_p80 * Lambda_5_5_p179);
  const Real Lambda_5_5_p234 = Lambda_5_5_p233 - Lambda_5_5_p183 *
      (Lambda_5_5_p118 * Lambda_5_5_p183) - Lambda_5_5_p185 * (Lambda_5_5_p156 * Lambda_5_5_p185) +
      Lambda_5_5_p170 * (Lambda_5_5_p218 + Lambda_5_5_p223);
  const Real Lambda_5_5_p235 = Lambda_5_5_p174 * Lambda_5_5_p201 + Lambda_5_5_p176 *
      Lambda_5_5_p200 + Lambda_5_5_p179 * Lambda_5_5_p199 + Lambda_5_5_p183 * Lambda_5_5_p198 -
      Lambda_5_5_p185 * Lambda_5_5_p197;
  const Real Lambda_5_5_p236 = Lambda_5_5_p169 * Lambda_5_5_p202 + Lambda_5_5_p188 *
      Lambda_5_5_p203 + Lambda_5_5_p189 * Lambda_5_5_p204 - Lambda_5_5_p190 * Lambda_5_5_p201 -
      Lambda_5_5_p191 * Lambda_5_5_p200;
  const Real Lambda_5_5_p237 = Lambda_5_5_p236 + Lambda_5_5_p193 * Lambda_5_5_p199 +
      Lambda_5_5_p194 * Lambda_5_5_p198 + Lambda_5_5_p196 * Lambda_5_5_p197;
  const Real Lambda_5_5_p238 = Lambda_5_5_p235 - Lambda_5_5_p222 * Lambda_5_5_p170 +
      Lambda_5_5_p237 * Lambda_5_5_p207;
  const Real Lambda_5_5_p239 = 1.0 / (Lambda_5_5_p234 - Lambda_5_5_p207 *
      (Lambda_5_5_p235 + Lambda_5_5_p238));
  const Real Lambda_5_5_p240 = Lambda_5_5_p209 * Lambda_5_5_p239;
  const Real Lambda_5_5_p241 = Lambda_5_5_p211 * Lambda_5_5_p181 + Lambda_5_5_p213 *
      Lambda_5_5_p180 - Lambda_5_5_p214 * Lambda_5_5_p172 - Lambda_5_5_p215 * Lambda_5_5_p182 -
      Lambda_5_5_p216 * Lambda_5_5_p184;
  const Real Lambda_5_5_p242 = Lambda_5_5_p126 * (24999.999999999996 * Lambda_5_5_p126) +
      Lambda_5_5_p127 * (1557.24430048586 * Lambda_5_5_p127) + Lambda_5_5_p128 *
      (Lambda_5_5_p47 * Lambda_5_5_p128);
  const Real Lambda_5_5_p243 = Lambda_5_5_p242 - Lambda_5_5_p130 * Lambda_5_5_p181 -
      Lambda_5_5_p131 * Lambda_5_5_p180 + Lambda_5_5_p132 * Lambda_5_5_p172 + Lambda_5_5_p133 *
      Lambda_5_5_p182;
  const Real Lambda_5_5_p244 = Lambda_5_5_p243 + Lambda_5_5_p140 * Lambda_5_5_p184;
  const Real Lambda_5_5_p245 = Lambda_5_5_p241 - Lambda_5_5_p244 * Lambda_5_5_p207 +
      Lambda_5_5_p166 * Lambda_5_5_p224;

  // link 6 (link3), Jacobian
  const Real Lambda_5_5_p246 = Lambda_5_5_p125 * Lambda_5_5_p173;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p247 = Lambda_5_5_p125 * Lambda_5_5_p175 - Lambda_5_5_p246 * Lambda_5_5_p72;
  const Real Lambda_5_5_p248 = Lambda_5_5_p212 + Lambda_5_5_p246 * Lambda_5_5_p68 + Lambda_5_5_p79 *
      Lambda_5_5_p247;
  const Real Lambda_5_5_p249 = 1.0 - Lambda_5_5_p246 * Lambda_5_5_p113 - Lambda_5_5_p112 *
      Lambda_5_5_p247 - Lambda_5_5_p105 * Lambda_5_5_p248;
  const Real Lambda_5_5_p250 = Lambda_5_5_p246 * Lambda_5_5_p136 + Lambda_5_5_p135 *
      Lambda_5_5_p247 - Lambda_5_5_p134 * Lambda_5_5_p248 - Lambda_5_5_p119 * Lambda_5_5_p249;
  const Real Lambda_5_5_p251 = Lambda_5_5_p246 * Lambda_5_5_p201 + Lambda_5_5_p247 *
      Lambda_5_5_p200 - Lambda_5_5_p248 * Lambda_5_5_p199 - Lambda_5_5_p249 * Lambda_5_5_p198 +
      Lambda_5_5_p250 * Lambda_5_5_p197;
  const Real Lambda_5_5_p252 = Lambda_5_5_p251 - Lambda_5_5_p237 * Lambda_5_5_p224 +
      Lambda_5_5_p206 * Lambda_5_5_p170;
  const Real Lambda_5_5_p253 = Lambda_5_5_p156 * Lambda_5_5_p250;
  const Real Lambda_5_5_p254 = Lambda_5_5_p118 * Lambda_5_5_p249;
  const Real Lambda_5_5_p255 = Lambda_5_5_p80 * Lambda_5_5_p248;
  const Real Lambda_5_5_p256 = Lambda_5_5_p78 * Lambda_5_5_p247;
  const Real Lambda_5_5_p257 = Lambda_5_5_p246 * Lambda_5_5_p67;
  const Real Lambda_5_5_p258 = Lambda_5_5_p246 * Lambda_5_5_p257 + Lambda_5_5_p247 *
      Lambda_5_5_p256 - Lambda_5_5_p248 * Lambda_5_5_p255 - Lambda_5_5_p249 * Lambda_5_5_p254 -
      Lambda_5_5_p250 * Lambda_5_5_p253;
  const Real Lambda_5_5_p259 = Lambda_5_5_p246 * Lambda_5_5_p181 + Lambda_5_5_p247 *
      Lambda_5_5_p180 - Lambda_5_5_p248 * Lambda_5_5_p172 + Lambda_5_5_p249 * Lambda_5_5_p182 -
      Lambda_5_5_p250 * Lambda_5_5_p184;
  const Real Lambda_5_5_p260 = Lambda_5_5_p259 + Lambda_5_5_p206 * Lambda_5_5_p224 -
      Lambda_5_5_p244 * Lambda_5_5_p170;
  const Real Lambda_5_5_p261 = Lambda_5_5_p246 * Lambda_5_5_p163 + Lambda_5_5_p247 *
      Lambda_5_5_p164 + Lambda_5_5_p248 * Lambda_5_5_p159 + Lambda_5_5_p249 * Lambda_5_5_p158 -
      Lambda_5_5_p250 * Lambda_5_5_p157;
  const Real Lambda_5_5_p262 = Lambda_5_5_p174 * Lambda_5_5_p257 + Lambda_5_5_p176 *
      Lambda_5_5_p256 + Lambda_5_5_p179 * Lambda_5_5_p255 + Lambda_5_5_p183 * Lambda_5_5_p254 +
      Lambda_5_5_p185 * Lambda_5_5_p253;
  const Real Lambda_5_5_p263 = Lambda_5_5_p170 * (Lambda_5_5_p261 - Lambda_5_5_p209) +
      (Lambda_5_5_p262 + Lambda_5_5_p224 * Lambda_5_5_p238 - Lambda_5_5_p251 * Lambda_5_5_p207);
  const Real Lambda_5_5_p264 = Lambda_5_5_p263 * Lambda_5_5_p239;
  const Real Lambda_5_5_p265 = Lambda_5_5_p258 + Lambda_5_5_p224 *
      (Lambda_5_5_p251 + Lambda_5_5_p252) + Lambda_5_5_p170 * (Lambda_5_5_p259 + Lambda_5_5_p260) -
      Lambda_5_5_p263 * Lambda_5_5_p264;
  const Real Lambda_5_5_p266 = 1.0 / Lambda_5_5_p265;
  const Real Lambda_5_5_p267 = Lambda_5_5_p260 + Lambda_5_5_p263 * Lambda_5_5_p240;
  const Real Lambda_5_5_p268 = Lambda_5_5_p267 * Lambda_5_5_p266;
  const Real Lambda_5_5_p269 = Lambda_5_5_p232 * Lambda_5_5_p239;
  const Real Lambda_5_5_p270 = Lambda_5_5_p246 * Lambda_5_5_p229 + Lambda_5_5_p247 *
      Lambda_5_5_p228 - Lambda_5_5_p248 * Lambda_5_5_p227 + Lambda_5_5_p249 * Lambda_5_5_p226 -
      Lambda_5_5_p250 * Lambda_5_5_p225;
  const Real Lambda_5_5_p271 = Lambda_5_5_p222 * Lambda_5_5_p224;
  const Real Lambda_5_5_p272 = Lambda_5_5_p271 - (Lambda_5_5_p261 + Lambda_5_5_p171);
  const Real Lambda_5_5_p273 = Lambda_5_5_p224 * (Lambda_5_5_p217 - Lambda_5_5_p272) +
      (Lambda_5_5_p270 + Lambda_5_5_p207 * Lambda_5_5_p260 + Lambda_5_5_p241 * Lambda_5_5_p170 +
      Lambda_5_5_p263 * Lambda_5_5_p269);
  const Real Lambda_5_5_p274 = Lambda_5_5_p245 - Lambda_5_5_p232 * Lambda_5_5_p240 -
      Lambda_5_5_p273 * Lambda_5_5_p268;
  const Real Lambda_5_5_p275 = Lambda_5_5_p211 * Lambda_5_5_p229 + Lambda_5_5_p213 *
      Lambda_5_5_p228 - Lambda_5_5_p214 * Lambda_5_5_p227 - Lambda_5_5_p215 * Lambda_5_5_p226 -
      Lambda_5_5_p216 * Lambda_5_5_p225;
  const Real Lambda_5_5_p276 = Lambda_5_5_p231 + Lambda_5_5_p166 * Lambda_5_5_p207 -
      Lambda_5_5_p220 * Lambda_5_5_p224;
  const Real Lambda_5_5_p277 = Lambda_5_5_p275 + Lambda_5_5_p207 *
      (Lambda_5_5_p241 + Lambda_5_5_p245) + Lambda_5_5_p224 * (Lambda_5_5_p231 + Lambda_5_5_p276) -
      Lambda_5_5_p232 * Lambda_5_5_p269;
  const Real Lambda_5_5_p278 = Lambda_5_5_p273 * Lambda_5_5_p266;
  const Real Lambda_5_5_p279 = 1.0 / (Lambda_5_5_p277 - Lambda_5_5_p273 * Lambda_5_5_p278);
  const Real Lambda_5_5_p280 = Lambda_5_5_p238 * Lambda_5_5_p239;
  const Real Lambda_5_5_p281 = Lambda_5_5_p252 - Lambda_5_5_p263 * Lambda_5_5_p280;
  const Real Lambda_5_5_p282 = Lambda_5_5_p281 * Lambda_5_5_p266;
  const Real Lambda_5_5_p283 = Lambda_5_5_p271 - (Lambda_5_5_p217 + Lambda_5_5_p208) -
      Lambda_5_5_p232 * Lambda_5_5_p280 + Lambda_5_5_p273 * Lambda_5_5_p282;
  const Real Lambda_5_5_p284 = Lambda_5_5_p283 * Lambda_5_5_p279;
  const Real Lambda_5_5_p285 = Lambda_5_5_p206 + Lambda_5_5_p209 * Lambda_5_5_p280 -
      Lambda_5_5_p267 * Lambda_5_5_p282 + Lambda_5_5_p274 * Lambda_5_5_p284;
  const Real Lambda_5_5_p286 = Lambda_5_5_p274 * Lambda_5_5_p279;
  const Real Lambda_5_5_p287 = 1.0 / (Lambda_5_5_p244 + Lambda_5_5_p209 * Lambda_5_5_p240 +
      Lambda_5_5_p267 * Lambda_5_5_p268 + Lambda_5_5_p274 * Lambda_5_5_p286);
  const Real Lambda_5_5_p288 = Lambda_5_5_p285 * Lambda_5_5_p287;
  const Real Lambda_5_5_p289 = Lambda_5_5_p223 * Lambda_5_5_p239;
  const Real Lambda_5_5_p290 = Lambda_5_5_p272 + Lambda_5_5_p263 * Lambda_5_5_p289;
  const Real Lambda_5_5_p291 = Lambda_5_5_p290 * Lambda_5_5_p266;
  const Real Lambda_5_5_p292 = Lambda_5_5_p276 + Lambda_5_5_p232 * Lambda_5_5_p289 +
      Lambda_5_5_p273 * Lambda_5_5_p291;
  const Real Lambda_5_5_p293 = Lambda_5_5_p292 * Lambda_5_5_p279;
  const Real Lambda_5_5_p294 = Lambda_5_5_p166 + Lambda_5_5_p209 * Lambda_5_5_p289 +
      Lambda_5_5_p267 * Lambda_5_5_p291 - Lambda_5_5_p274 * Lambda_5_5_p293;
  const Real Lambda_5_5_p295 = Lambda_5_5_p222 + Lambda_5_5_p223 * Lambda_5_5_p280 -
      Lambda_5_5_p290 * Lambda_5_5_p282 - Lambda_5_5_p292 * Lambda_5_5_p284 - Lambda_5_5_p294 *
      Lambda_5_5_p288;
  const Real Lambda_5_5_p296 = Lambda_5_5_p294 * Lambda_5_5_p287;
  const Real Lambda_5_5_p297 = Lambda_5_5_p220 + Lambda_5_5_p223 * Lambda_5_5_p289 +
      Lambda_5_5_p290 * Lambda_5_5_p291 + Lambda_5_5_p292 * Lambda_5_5_p293 - Lambda_5_5_p294 *
      Lambda_5_5_p296;
  const Real Lambda_5_5_p298 = 1.0 / Lambda_5_5_p297;
  const Real Lambda_5_5_p299 = Lambda_5_5_p295 * Lambda_5_5_p298;
  const Real Lambda_5_5_p300 = Lambda_5_5_p237 + Lambda_5_5_p238 * Lambda_5_5_p280 +
      Lambda_5_5_p281 * Lambda_5_5_p282 + Lambda_5_5_p283 * Lambda_5_5_p284 - Lambda_5_5_p285 *
      Lambda_5_5_p288;
  const Real Lambda_5_5 = 1.0 / (Lambda_5_5_p300 - Lambda_5_5_p295 * Lambda_5_5_p299);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5_p1 = Lambda_5_5_p269 + Lambda_5_5_p264 * Lambda_5_5_p278;
  const Real Lambda_0_5_p2 = Lambda_5_5_p240 + Lambda_5_5_p264 * Lambda_5_5_p268 - Lambda_5_5_p286 *
      Lambda_0_5_p1;
  const Real Lambda_0_5_p3 = Lambda_5_5_p289 + Lambda_5_5_p264 * Lambda_5_5_p291 + Lambda_5_5_p293 *
      Lambda_0_5_p1 - Lambda_5_5_p296 * Lambda_0_5_p2;
  const Real Lambda_0_5_p4 = Lambda_5_5_p280 - Lambda_5_5_p264 * Lambda_5_5_p282 - Lambda_5_5_p284 *
      Lambda_0_5_p1 - Lambda_5_5_p288 * Lambda_0_5_p2 - Lambda_5_5_p299 * Lambda_0_5_p3;
  const Real Lambda_0_5 = Lambda_5_5 * Lambda_0_5_p4;
  Lambda[5] = -Lambda_0_5;
  Lambda[30] = -Lambda_0_5;
  const Real Lambda_0_0_p1 = Lambda_5_5_p298 * Lambda_0_5_p3;
  const Real Lambda_0_0_p2 = Lambda_5_5_p287 * Lambda_0_5_p2;
  const Real Lambda_0_0_p3 = Lambda_5_5_p279 * Lambda_0_5_p1;
  const Real Lambda_0_0_p4 = Lambda_5_5_p264 * Lambda_5_5_p266;
  const Real Lambda_0_0_p5 = Lambda_5_5_p239 + Lambda_5_5_p264 * Lambda_0_0_p4 + Lambda_0_5_p1 *
      Lambda_0_0_p3 - Lambda_0_5_p2 * Lambda_0_0_p2 - Lambda_0_5_p3 * Lambda_0_0_p1;
  Lambda[0] = -(Lambda_0_0_p5 - Lambda_0_5_p4 * Lambda_0_5);
  const Real Lambda_1_5_p1 = Lambda_5_5_p268 - Lambda_5_5_p278 * Lambda_5_5_p286;
  const Real Lambda_1_5_p2 = Lambda_5_5_p291 + Lambda_5_5_p278 * Lambda_5_5_p293 - Lambda_5_5_p296 *
      Lambda_1_5_p1;
  const Real Lambda_1_5_p3 = Lambda_5_5_p282 + Lambda_5_5_p278 * Lambda_5_5_p284 + Lambda_5_5_p288 *
      Lambda_1_5_p1 + Lambda_5_5_p299 * Lambda_1_5_p2;
  const Real Lambda_1_5 = Lambda_5_5 * Lambda_1_5_p3;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_0_1_p1 = Lambda_5_5_p298 * Lambda_1_5_p2;
  const Real Lambda_0_1_p2 = Lambda_5_5_p287 * Lambda_1_5_p1;
  const Real Lambda_0_1_p3 = Lambda_5_5_p278 * Lambda_5_5_p279;
  const Real Lambda_0_1 = Lambda_0_0_p4 + Lambda_0_5_p1 * Lambda_0_1_p3 - Lambda_0_5_p2 *
      Lambda_0_1_p2 - Lambda_0_5_p3 * Lambda_0_1_p1 + Lambda_0_5_p4 * Lambda_1_5;
  Lambda[1] = -Lambda_0_1;
  Lambda[6] = -Lambda_0_1;
  const Real Lambda_2_5_p1 = Lambda_5_5_p293 + Lambda_5_5_p286 * Lambda_5_5_p296;
  const Real Lambda_2_5_p2 = Lambda_5_5_p284 - Lambda_5_5_p286 * Lambda_5_5_p288 + Lambda_5_5_p299 *
      Lambda_2_5_p1;
  const Real Lambda_2_5 = Lambda_5_5 * Lambda_2_5_p2;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_0_2_p1 = Lambda_5_5_p298 * Lambda_2_5_p1;
  const Real Lambda_0_2_p2 = Lambda_5_5_p286 * Lambda_5_5_p287;
  const Real Lambda_0_2 = Lambda_0_0_p3 + Lambda_0_5_p2 * Lambda_0_2_p2 - Lambda_0_5_p3 *
      Lambda_0_2_p1 + Lambda_0_5_p4 * Lambda_2_5;
  Lambda[2] = -Lambda_0_2;
  Lambda[12] = -Lambda_0_2;
  const Real Lambda_3_5_p1 = Lambda_5_5_p288 - Lambda_5_5_p296 * Lambda_5_5_p299;
  const Real Lambda_3_5 = Lambda_5_5 * Lambda_3_5_p1;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_0_3_p1 = Lambda_5_5_p296 * Lambda_5_5_p298;
  const Real Lambda_0_3 = Lambda_0_0_p2 - Lambda_0_5_p3 * Lambda_0_3_p1 - Lambda_0_5_p4 *
      Lambda_3_5;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_4_5 = Lambda_5_5_p299 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  const Real Lambda_0_4 = Lambda_0_0_p1 - Lambda_0_5_p4 * Lambda_4_5;
  Lambda[4] = -Lambda_0_4;
  Lambda[24] = -Lambda_0_4;
  Lambda[7] = -(Lambda_5_5_p266 + Lambda_5_5_p278 * Lambda_0_1_p3 - Lambda_1_5_p1 * Lambda_0_1_p2 -
      Lambda_1_5_p2 * Lambda_0_1_p1 - Lambda_1_5_p3 * Lambda_1_5);
  const Real Lambda_1_2 = Lambda_0_1_p3 + Lambda_1_5_p1 * Lambda_0_2_p2 - Lambda_1_5_p2 *
      Lambda_0_2_p1 - Lambda_1_5_p3 * Lambda_2_5;
  Lambda[8] = -Lambda_1_2;
  Lambda[13] = -Lambda_1_2;
  const Real Lambda_1_3 = Lambda_0_1_p2 - Lambda_1_5_p2 * Lambda_0_3_p1 + Lambda_1_5_p3 *
      Lambda_3_5;
  Lambda[9] = Lambda_1_3;
  Lambda[19] = Lambda_1_3;
  const Real Lambda_1_4 = Lambda_0_1_p1 + Lambda_1_5_p3 * Lambda_4_5;
  Lambda[10] = -Lambda_1_4;
  Lambda[25] = -Lambda_1_4;
  Lambda[14] = -(Lambda_5_5_p279 - Lambda_5_5_p286 * Lambda_0_2_p2 - Lambda_2_5_p1 * Lambda_0_2_p1 -
      Lambda_2_5_p2 * Lambda_2_5);
  const Real Lambda_2_3 = Lambda_0_2_p2 + Lambda_2_5_p1 * Lambda_0_3_p1 - Lambda_2_5_p2 *
      Lambda_3_5;
  Lambda[15] = -Lambda_2_3;
  Lambda[20] = -Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p1 + Lambda_2_5_p2 * Lambda_4_5;
  Lambda[16] = -Lambda_2_4;
  Lambda[26] = -Lambda_2_4;
  Lambda[21] = Lambda_5_5_p287 + Lambda_5_5_p296 * Lambda_0_3_p1 + Lambda_3_5_p1 * Lambda_3_5;
  const Real Lambda_3_4 = Lambda_0_3_p1 - Lambda_3_5_p1 * Lambda_4_5;
  Lambda[22] = Lambda_3_4;
  Lambda[27] = Lambda_3_4;
  Lambda[28] = Lambda_5_5_p298 + Lambda_5_5_p299 * Lambda_4_5;
}

}  // namespace samm

#undef TREELINE_RESTRICT
