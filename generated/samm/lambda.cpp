// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J from poses, in the axes asked for at link origins.
// 1198 flops (add 497, mul 689, div 12), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

template <int count>
using Lanes = detail::Pack<Real, count>;
void lambda(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
  const Real angles[6] = {q[3], q[2], q[5], q[4], q[6], q[7]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c4 = cosines[0];
  const Real c3 = cosines[1];
  const Real s4 = sines[0];
  const Real s3 = sines[1];
  const Real c6 = cosines[2];
  const Real s5 = sines[3];
  const Real s6 = sines[2];
  const Real c5 = cosines[3];
  const Real s7 = sines[4];
  const Real s8 = sines[5];
  const Real c8 = cosines[5];
  const Real c7 = cosines[4];

  // link 8 (link5), composite inertia
  const Real Lambda_0_5_p1 = 0.00020215999999999998 * s8;
  const Real Lambda_0_5_p2 = s8 * Lambda_0_5_p1;

  // link 7 (link4), composite inertia
  const Real Lambda_0_5_p3 = s7 * (0.00010000000000000026 + Lambda_0_5_p2);
  const Real Lambda_0_5_p4 = s7 * Lambda_0_5_p3;
  const Real Lambda_0_5_p5 = 0.3056901365 + (0.0011921599999999998 - Lambda_0_5_p2 + Lambda_0_5_p4 +
      0.0024946559999999996 * c8);

  // link 8 (link5), composite inertia
  const Real Lambda_0_5_p6 = 0.00164 + Lambda_0_5_p2;
  const Real Lambda_0_5_p7 = 0.0028799999999999997 * s8;

  // link 7 (link4), composite inertia
  const Real Lambda_0_5_p8 = c7 * Lambda_0_5_p7;
  const Real Lambda_0_5_p9 = 0.0067651125 + (Lambda_0_5_p6 - 0.0406 * Lambda_0_5_p8);

  // link 8 (link5), composite inertia
  const Real Lambda_0_5_p10 = c8 * Lambda_0_5_p1;

  // link 7 (link4), mass matrix
  const Real Lambda_0_5_p11 = c7 * Lambda_0_5_p10 + 0.4331 * Lambda_0_5_p8;

  // link 7 (link4), composite inertia
  const Real Lambda_0_5_p12 = Lambda_0_5_p11 - 5.846399999999999e-05 * c8 - 0.010673638499999999;

  // link 6 (link3), composite inertia
  const Real Lambda_0_5_p13 = s6 * (Lambda_0_5_p5 - Lambda_0_5_p9) + c6 * (2.0 * Lambda_0_5_p12);
  const Real Lambda_0_5_p14 = s6 * Lambda_0_5_p13;

  // link 7 (link4), composite inertia
  const Real Lambda_0_5_p15 = s7 * Lambda_0_5_p7;

  // link 8 (link5), composite inertia
  const Real Lambda_0_5_p16 = 0.0028799999999999997 * c8;

  // link 7 (link4), composite inertia
  const Real Lambda_0_5_p17 = 0.861795 + Lambda_0_5_p16;
  const Real Lambda_0_5_p18 = Lambda_0_5_p8 - 0.025374999999999998;

  // link 6 (link3), mass matrix
  const Real Lambda_0_5_p19 = s6 * Lambda_0_5_p17 + c6 * Lambda_0_5_p18;
  const Real Lambda_0_5_p20 = 0.4318 * Lambda_0_5_p19;

  // link 6 (link3), composite inertia
  const Real Lambda_0_5_p21 = 1.674987602 + (Lambda_0_5_p9 + Lambda_0_5_p14 + 2.0 *
      (Lambda_0_5_p20 + 0.1501 * Lambda_0_5_p15));

  // link 6 (link3), mass matrix
  const Real Lambda_0_5_p22 = c6 * Lambda_0_5_p17 - s6 * Lambda_0_5_p18;

  // link 5 (link2), composite inertia
  const Real Lambda_0_5_p23 = s5 * (0.07312640000000001 +
      (Lambda_0_5_p5 - Lambda_0_5_p14 + 0.3002 * Lambda_0_5_p15) - Lambda_0_5_p21) + c5 *
      (2.0 * (c6 * Lambda_0_5_p13 - Lambda_0_5_p12 + 0.4318 * Lambda_0_5_p22 - 0.0070992));

  // link 9 (link6), mass matrix
  const Real Lambda_0_5_p24 = 4e-05 * s8;
  const Real Lambda_0_5_p25 = c7 * Lambda_0_5_p24;
  const Real Lambda_0_5_p26 = 4e-05 * c8;
  const Real Lambda_0_5_p27 = s5 * (c6 * Lambda_0_5_p25 + s6 * Lambda_0_5_p26) + c5 *
      (s6 * Lambda_0_5_p25 - c6 * Lambda_0_5_p26);

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p28 = 24999.999999999996 * Lambda_0_5_p27;

  // link 8 (link5), mass matrix
  const Real Lambda_0_5_p29 = s7 * Lambda_0_5_p16;
  const Real Lambda_0_5_p30 = 0.00064216 * s7 + 0.4331 * Lambda_0_5_p29;
  const Real Lambda_0_5_p31 = 0.0203 * Lambda_0_5_p29;
  const Real Lambda_0_5_p32 = c7 * Lambda_0_5_p16;
  const Real Lambda_0_5_p33 = s6 * Lambda_0_5_p32 + c6 * Lambda_0_5_p7;
  const Real Lambda_0_5_p34 = c6 * Lambda_0_5_p32 - s6 * Lambda_0_5_p7;
  const Real Lambda_0_5_p35 = c5 * (c6 * Lambda_0_5_p31 - s6 * Lambda_0_5_p30 +
      (0.1501 * Lambda_0_5_p34 - 0.4318 * Lambda_0_5_p29));
  const Real Lambda_0_5_p36 = s5 * (c6 * Lambda_0_5_p30 + s6 * Lambda_0_5_p31 + 0.1501 *
      Lambda_0_5_p33) - Lambda_0_5_p35;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p37 = 1557.24430048586 * Lambda_0_5_p36;

  // link 7 (link4), composite inertia
  const Real Lambda_0_5_p38 = 0.0203 * Lambda_0_5_p8;

  // link 7 (link4), mass matrix
  const Real Lambda_0_5_p39 = Lambda_0_5_p38 - Lambda_0_5_p6;
  const Real Lambda_0_5_p40 = s6 * Lambda_0_5_p15;
  const Real Lambda_0_5_p41 = c6 * Lambda_0_5_p15;
  const Real Lambda_0_5_p42 = c5 * (c6 * Lambda_0_5_p39 - s6 * Lambda_0_5_p11 -
      (0.1501 * Lambda_0_5_p41 + 0.4318 * Lambda_0_5_p8));

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p43 = 0.9999999999999999 * c8;
  const Real Lambda_0_5_p44 = Lambda_0_5_p43 * Lambda_0_5_p27 -
      (s5 * (0.1501 * Lambda_0_5_p40 - (c6 * Lambda_0_5_p11 + s6 * Lambda_0_5_p39)) +
      Lambda_0_5_p42);
  const Real Lambda_0_5_p45 = 1.0 / (Lambda_0_5_p6 - Lambda_0_5_p43 * Lambda_0_5_p26);
  const Real Lambda_0_5_p46 = Lambda_0_5_p44 * Lambda_0_5_p45;
  const Real Lambda_0_5_p47 = 1.4717295504999999 + (Lambda_0_5_p21 + s5 * Lambda_0_5_p23) -
      Lambda_0_5_p28 * Lambda_0_5_p27 - Lambda_0_5_p37 * Lambda_0_5_p36 - Lambda_0_5_p46 *
      Lambda_0_5_p44;

  // link 7 (link4), composite inertia
  const Real Lambda_0_5_p48 = 0.0203 * Lambda_0_5_p15 - c7 * Lambda_0_5_p3;
  const Real Lambda_0_5_p49 = s7 * Lambda_0_5_p10 + 0.4331 * Lambda_0_5_p15;
  const Real Lambda_0_5_p50 = 0.004704000000000001 + Lambda_0_5_p49;

  // link 6 (link3), mass matrix
  const Real Lambda_0_5_p51 = c6 * Lambda_0_5_p48 - s6 * Lambda_0_5_p50 - 0.1501 * Lambda_0_5_p19;
  const Real Lambda_0_5_p52 = s6 * Lambda_0_5_p48 + c6 * Lambda_0_5_p50 + 0.1501 * Lambda_0_5_p22;

  // link 9 (link6), mass matrix
  const Real Lambda_0_5_p53 = s7 * Lambda_0_5_p24;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p54 = 24999.999999999996 * Lambda_0_5_p53;
  const Real Lambda_0_5_p55 = Lambda_0_5_p54 * Lambda_0_5_p27;

  // link 8 (link5), mass matrix
  const Real Lambda_0_5_p56 = 0.00064216 * c7 + (0.4331 * Lambda_0_5_p32 - 5.846399999999999e-05 *
      s8);

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p57 = 1557.24430048586 * Lambda_0_5_p56;
  const Real Lambda_0_5_p58 = Lambda_0_5_p49 + Lambda_0_5_p43 * Lambda_0_5_p53;
  const Real Lambda_0_5_p59 = Lambda_0_5_p58 * Lambda_0_5_p45;
  const Real Lambda_0_5_p60 = Lambda_0_5_p55 - (s5 * Lambda_0_5_p51 + c5 * Lambda_0_5_p52) -
      Lambda_0_5_p57 * Lambda_0_5_p36 + Lambda_0_5_p59 * Lambda_0_5_p44;
  const Real Lambda_0_5_p61 = 0.312455249 + (0.00129216 - Lambda_0_5_p4 + 2.0 *
      (0.0012473279999999998 * c8 - Lambda_0_5_p38)) - Lambda_0_5_p54 * Lambda_0_5_p53;
  const Real Lambda_0_5_p62 = 1.0 / (Lambda_0_5_p61 - Lambda_0_5_p57 * Lambda_0_5_p56 -
      Lambda_0_5_p59 * Lambda_0_5_p58);
  const Real Lambda_0_5_p63 = Lambda_0_5_p60 * Lambda_0_5_p62;

  // link 8 (link5), mass matrix
  const Real Lambda_0_5_p64 = Lambda_0_5_p56 + 0.4318 * Lambda_0_5_p33;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p65 = Lambda_0_5_p58 + 0.4318 * Lambda_0_5_p40;
  const Real Lambda_0_5_p66 = Lambda_0_5_p61 + Lambda_0_5_p20 - Lambda_0_5_p57 * Lambda_0_5_p64 -
      Lambda_0_5_p59 * Lambda_0_5_p65;
  const Real Lambda_0_5_p67 = Lambda_0_5_p66 * Lambda_0_5_p62;
  const Real Lambda_0_5_p68 = Lambda_0_5_p55 - (s5 *
      (Lambda_0_5_p51 - 0.4318 * Lambda_0_5_p15 - 0.690314699) + c5 *
      (Lambda_0_5_p52 - 0.023750999999999998));
  const Real Lambda_0_5_p69 = 1557.24430048586 * Lambda_0_5_p64;
  const Real Lambda_0_5_p70 = Lambda_0_5_p65 * Lambda_0_5_p45;
  const Real Lambda_0_5_p71 = Lambda_0_5_p68 - Lambda_0_5_p69 * Lambda_0_5_p36 + Lambda_0_5_p70 *
      Lambda_0_5_p44 - Lambda_0_5_p67 * Lambda_0_5_p60;
  const Real Lambda_0_5_p72 = 1.7481140020000001 + Lambda_0_5_p61 + 0.8636 * Lambda_0_5_p19 -
      Lambda_0_5_p69 * Lambda_0_5_p64 - Lambda_0_5_p70 * Lambda_0_5_p65 - Lambda_0_5_p67 *
      Lambda_0_5_p66;
  const Real Lambda_0_5_p73 = 1.0 / Lambda_0_5_p72;
  const Real Lambda_0_5_p74 = Lambda_0_5_p71 * Lambda_0_5_p73;
  const Real Lambda_0_5_p75 = 1.0 / (Lambda_0_5_p47 - Lambda_0_5_p63 * Lambda_0_5_p60 -
      Lambda_0_5_p74 * Lambda_0_5_p71);

  // link 6 (link3), mass matrix
  const Real Lambda_0_5_p76 = s5 * Lambda_0_5_p19 - c5 * Lambda_0_5_p22;
  const Real Lambda_0_5_p77 = c4 * Lambda_0_5_p76;
  const Real Lambda_0_5_p78 = s4 * Lambda_0_5_p76;

  // link 8 (link5), mass matrix
  const Real Lambda_0_5_p79 = s5 * Lambda_0_5_p33 - c5 * Lambda_0_5_p34;
  const Real Lambda_0_5_p80 = c4 * Lambda_0_5_p29 - s4 * Lambda_0_5_p79;
  const Real Lambda_0_5_p81 = c4 * Lambda_0_5_p79 + s4 * Lambda_0_5_p29;
  const Real Lambda_0_5_p82 = c3 * Lambda_0_5_p80 - s3 * Lambda_0_5_p81;

  // link 7 (link4), mass matrix
  const Real Lambda_0_5_p83 = c5 * Lambda_0_5_p41 - s5 * Lambda_0_5_p40;
  const Real Lambda_0_5_p84 = c4 * Lambda_0_5_p8 - s4 * Lambda_0_5_p83;
  const Real Lambda_0_5_p85 = c4 * Lambda_0_5_p83 + s4 * Lambda_0_5_p8;
  const Real Lambda_0_5_p86 = c3 * Lambda_0_5_p84 - s3 * Lambda_0_5_p85;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p87 = Lambda_0_5_p59 * Lambda_0_5_p86 -
      (s3 * Lambda_0_5_p77 + c3 * Lambda_0_5_p78 + Lambda_0_5_p57 * Lambda_0_5_p82);

  // link 6 (link3), composite inertia
  const Real Lambda_0_5_p88 = 0.10439999999999999 - Lambda_0_5_p22;
  const Real Lambda_0_5_p89 = 3.79559 + Lambda_0_5_p19;

  // link 5 (link2), mass matrix
  const Real Lambda_0_5_p90 = c5 * Lambda_0_5_p88 + s5 * Lambda_0_5_p89;
  const Real Lambda_0_5_p91 = c4 * Lambda_0_5_p90;
  const Real Lambda_0_5_p92 = s4 * Lambda_0_5_p90;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p93 = Lambda_0_5_p70 * Lambda_0_5_p86 -
      (s3 * Lambda_0_5_p91 + c3 * Lambda_0_5_p92 + Lambda_0_5_p69 * Lambda_0_5_p82) -
      Lambda_0_5_p67 * Lambda_0_5_p87;

  // link 5 (link2), composite inertia
  const Real Lambda_0_5_p94 = s5 * Lambda_0_5_p88 - c5 * Lambda_0_5_p89;
  const Real Lambda_0_5_p95 = 4.9338049999999996 + Lambda_0_5_p15;

  // link 4 (link1), mass matrix
  const Real Lambda_0_5_p96 = s4 * Lambda_0_5_p94 - c4 * Lambda_0_5_p95;
  const Real Lambda_0_5_p97 = s4 * Lambda_0_5_p95 + c4 * Lambda_0_5_p94;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p98 = s3 * Lambda_0_5_p96 - c3 * Lambda_0_5_p97 - Lambda_0_5_p37 *
      Lambda_0_5_p82 - Lambda_0_5_p46 * Lambda_0_5_p86 - Lambda_0_5_p63 * Lambda_0_5_p87;
  const Real Lambda_0_5_p99 = Lambda_0_5_p98 - Lambda_0_5_p74 * Lambda_0_5_p93;
  const Real Lambda_0_5_p100 = Lambda_0_5_p99 * Lambda_0_5_p75;

  // link 8 (link5), mass matrix
  const Real Lambda_0_5_p101 = c3 * Lambda_0_5_p81 + s3 * Lambda_0_5_p80;

  // link 7 (link4), mass matrix
  const Real Lambda_0_5_p102 = c3 * Lambda_0_5_p85 + s3 * Lambda_0_5_p84;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p103 = s3 * Lambda_0_5_p78 - c3 * Lambda_0_5_p77 + Lambda_0_5_p57 *
      Lambda_0_5_p101 - Lambda_0_5_p59 * Lambda_0_5_p102;
  const Real Lambda_0_5_p104 = s3 * Lambda_0_5_p92 - c3 * Lambda_0_5_p91 + Lambda_0_5_p69 *
      Lambda_0_5_p101 - Lambda_0_5_p70 * Lambda_0_5_p102 - Lambda_0_5_p67 * Lambda_0_5_p103;
  const Real Lambda_0_5_p105 = c3 * Lambda_0_5_p96 + s3 * Lambda_0_5_p97 + Lambda_0_5_p37 *
      Lambda_0_5_p101 + Lambda_0_5_p46 * Lambda_0_5_p102 - Lambda_0_5_p63 * Lambda_0_5_p103;
  const Real Lambda_0_5_p106 = Lambda_0_5_p105 - Lambda_0_5_p74 * Lambda_0_5_p104;
  const Real Lambda_0_5_p107 = Lambda_0_5_p93 * Lambda_0_5_p73;
  const Real Lambda_0_5_p108 = Lambda_0_5_p87 * Lambda_0_5_p62;
  const Real Lambda_0_5_p109 = 1557.24430048586 * Lambda_0_5_p82;
  const Real Lambda_0_5_p110 = Lambda_0_5_p86 * Lambda_0_5_p45;
  const Real Lambda_0_5_p111 = Lambda_0_5_p109 * Lambda_0_5_p101 + Lambda_0_5_p110 *
      Lambda_0_5_p102 - Lambda_0_5_p108 * Lambda_0_5_p103 - Lambda_0_5_p107 * Lambda_0_5_p104 -
      Lambda_0_5_p100 * Lambda_0_5_p106;
  const Real Lambda_0_5_p112 = 186.45 - Lambda_0_5_p109 * Lambda_0_5_p82 - Lambda_0_5_p110 *
      Lambda_0_5_p86 - Lambda_0_5_p108 * Lambda_0_5_p87 - Lambda_0_5_p107 * Lambda_0_5_p93;
  const Real Lambda_0_5_p113 = 1.0 / (Lambda_0_5_p112 - Lambda_0_5_p100 * Lambda_0_5_p99);
  const Real Lambda_0_5_p114 = Lambda_0_5_p111 * Lambda_0_5_p113;

  // link 6 (link3), pose
  const Real Lambda_0_5_p115 = c6 * s5 + s6 * c5;
  const Real Lambda_0_5_p116 = s6 * s5 - c6 * c5;

  // link 7 (link4), pose
  const Real Lambda_0_5_p117 = 0.0203 * Lambda_0_5_p115 - 0.4331 * Lambda_0_5_p116;

  // link 4 (link1), pose
  const Real Lambda_0_5_p118 = c4 * s3 + s4 * c3;

  // link 6 (link3), Jacobian
  const Real Lambda_0_5_p119 = Lambda_0_5_p118 * Lambda_0_5_p117;
  const Real Lambda_0_5_p120 = Lambda_0_5_p117 - 0.4318 * s5;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p121 = Lambda_0_5_p118 * Lambda_0_5_p120 - Lambda_0_5_p67 * Lambda_0_5_p119;

  // link 4 (link1), pose
  const Real Lambda_0_5_p122 = c4 * c3 - s4 * s3;

  // link 5 (link2), pose
  const Real Lambda_0_5_p123 = c5 * Lambda_0_5_p122;
  const Real Lambda_0_5_p124 = s5 * Lambda_0_5_p122;

  // link 6 (link3), pose
  const Real Lambda_0_5_p125 = s6 * Lambda_0_5_p123 + c6 * Lambda_0_5_p124;
  const Real Lambda_0_5_p126 = c6 * Lambda_0_5_p123 - s6 * Lambda_0_5_p124;

  // link 7 (link4), pose
  const Real Lambda_0_5_p127 = 0.4331 * Lambda_0_5_p125 - 0.0203 * Lambda_0_5_p126;

  // link 6 (link3), Jacobian
  const Real Lambda_0_5_p128 = Lambda_0_5_p127 + (0.4318 * Lambda_0_5_p123 - 0.1501 *
      Lambda_0_5_p118);

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p129 = Lambda_0_5_p128 - Lambda_0_5_p63 * Lambda_0_5_p119 - Lambda_0_5_p74 *
      Lambda_0_5_p121;
  const Real Lambda_0_5_p130 = 1.0 - Lambda_0_5_p108 * Lambda_0_5_p119 - Lambda_0_5_p107 *
      Lambda_0_5_p121 - Lambda_0_5_p100 * Lambda_0_5_p129;
  const Real Lambda_0_5_p131 = Lambda_0_5_p106 * Lambda_0_5_p75;
  const Real Lambda_0_5_p132 = Lambda_0_5_p104 * Lambda_0_5_p73;
  const Real Lambda_0_5_p133 = Lambda_0_5_p103 * Lambda_0_5_p62;
  const Real Lambda_0_5_p134 = Lambda_0_5_p133 * Lambda_0_5_p119 + Lambda_0_5_p132 *
      Lambda_0_5_p121 + Lambda_0_5_p131 * Lambda_0_5_p129 + Lambda_0_5_p114 * Lambda_0_5_p130;
  const Real Lambda_0_5_p135 = 1557.24430048586 * Lambda_0_5_p101;
  const Real Lambda_0_5_p136 = Lambda_0_5_p102 * Lambda_0_5_p45;
  const Real Lambda_0_5_p137 = 186.45 - Lambda_0_5_p135 * Lambda_0_5_p101 - Lambda_0_5_p136 *
      Lambda_0_5_p102 - Lambda_0_5_p133 * Lambda_0_5_p103 - Lambda_0_5_p132 * Lambda_0_5_p104;
  const Real Lambda_0_5_p138 = 1.0 / (Lambda_0_5_p137 - Lambda_0_5_p131 * Lambda_0_5_p106 -
      Lambda_0_5_p114 * Lambda_0_5_p111);
  const Real Lambda_0_5_p139 = Lambda_0_5_p134 * Lambda_0_5_p138;

  // link 6 (link3), Jacobian
  const Real Lambda_0_5_p140 = Lambda_0_5_p122 * Lambda_0_5_p117;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p141 = Lambda_0_5_p122 * Lambda_0_5_p120 - Lambda_0_5_p67 * Lambda_0_5_p140;

  // link 5 (link2), pose
  const Real Lambda_0_5_p142 = c5 * Lambda_0_5_p118;
  const Real Lambda_0_5_p143 = s5 * Lambda_0_5_p118;

  // link 6 (link3), pose
  const Real Lambda_0_5_p144 = s6 * Lambda_0_5_p142 + c6 * Lambda_0_5_p143;
  const Real Lambda_0_5_p145 = c6 * Lambda_0_5_p142 - s6 * Lambda_0_5_p143;

  // link 7 (link4), pose
  const Real Lambda_0_5_p146 = 0.4331 * Lambda_0_5_p144 - 0.0203 * Lambda_0_5_p145;

  // link 6 (link3), Jacobian
  const Real Lambda_0_5_p147 = Lambda_0_5_p146 + (0.4318 * Lambda_0_5_p142 + 0.1501 *
      Lambda_0_5_p122);

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p148 = Lambda_0_5_p147 + Lambda_0_5_p63 * Lambda_0_5_p140 + Lambda_0_5_p74 *
      Lambda_0_5_p141;
  const Real Lambda_0_5_p149 = Lambda_0_5_p100 * Lambda_0_5_p148 -
      (Lambda_0_5_p108 * Lambda_0_5_p140 + Lambda_0_5_p107 * Lambda_0_5_p141);
  const Real Lambda_0_5_p150 = 1.0 - Lambda_0_5_p133 * Lambda_0_5_p140 - Lambda_0_5_p132 *
      Lambda_0_5_p141 + Lambda_0_5_p131 * Lambda_0_5_p148 - Lambda_0_5_p114 * Lambda_0_5_p149;
  const Real Lambda_0_5_p151 = Lambda_0_5_p130 * Lambda_0_5_p113;
  const Real Lambda_0_5_p152 = Lambda_0_5_p129 * Lambda_0_5_p75;
  const Real Lambda_0_5_p153 = Lambda_0_5_p121 * Lambda_0_5_p73;
  const Real Lambda_0_5_p154 = Lambda_0_5_p119 * Lambda_0_5_p62;
  const Real Lambda_0_5_p155 = Lambda_0_5_p154 * Lambda_0_5_p140 + Lambda_0_5_p153 *
      Lambda_0_5_p141 - Lambda_0_5_p152 * Lambda_0_5_p148 + Lambda_0_5_p151 * Lambda_0_5_p149 -
      Lambda_0_5_p139 * Lambda_0_5_p150;

  // link 8 (link5), pose
  const Real Lambda_0_5_p156 = s8 * (c7 * Lambda_0_5_p115) + c8 * Lambda_0_5_p116;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p157 = Lambda_0_5_p54 * Lambda_0_5_p156;

  // link 7 (link4), pose
  const Real Lambda_0_5_p158 = s7 * Lambda_0_5_p115;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p159 = Lambda_0_5_p43 * Lambda_0_5_p156 - Lambda_0_5_p116;
  const Real Lambda_0_5_p160 = Lambda_0_5_p157 - Lambda_0_5_p57 * Lambda_0_5_p158 + Lambda_0_5_p59 *
      Lambda_0_5_p159;
  const Real Lambda_0_5_p161 = Lambda_0_5_p157 - Lambda_0_5_p69 * Lambda_0_5_p158 + Lambda_0_5_p70 *
      Lambda_0_5_p159 - Lambda_0_5_p67 * Lambda_0_5_p160;
  const Real Lambda_0_5_p162 = 1.0 - Lambda_0_5_p28 * Lambda_0_5_p156 - Lambda_0_5_p37 *
      Lambda_0_5_p158 - Lambda_0_5_p46 * Lambda_0_5_p159 - Lambda_0_5_p63 * Lambda_0_5_p160;
  const Real Lambda_0_5_p163 = Lambda_0_5_p162 - Lambda_0_5_p74 * Lambda_0_5_p161;
  const Real Lambda_0_5_p164 = Lambda_0_5_p109 * Lambda_0_5_p158 + Lambda_0_5_p110 *
      Lambda_0_5_p159 + Lambda_0_5_p108 * Lambda_0_5_p160 + Lambda_0_5_p107 * Lambda_0_5_p161 +
      Lambda_0_5_p100 * Lambda_0_5_p163;
  const Real Lambda_0_5_p165 = Lambda_0_5_p135 * Lambda_0_5_p158 + Lambda_0_5_p136 *
      Lambda_0_5_p159 - Lambda_0_5_p133 * Lambda_0_5_p160 - Lambda_0_5_p132 * Lambda_0_5_p161 -
      Lambda_0_5_p131 * Lambda_0_5_p163;
  const Real Lambda_0_5_p166 = Lambda_0_5_p165 + Lambda_0_5_p114 * Lambda_0_5_p164;

  // link 8 (link5), pose
  const Real Lambda_0_5_p167 = s8 * (c7 * Lambda_0_5_p145 + s7 * Lambda_0_5_p122) + c8 *
      Lambda_0_5_p144;

  // link 7 (link4), pose
  const Real Lambda_0_5_p168 = c7 * Lambda_0_5_p122 - s7 * Lambda_0_5_p145;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p169 = Lambda_0_5_p144 - Lambda_0_5_p43 * Lambda_0_5_p167;
  const Real Lambda_0_5_p170 = Lambda_0_5_p122 - Lambda_0_5_p54 * Lambda_0_5_p167;
  const Real Lambda_0_5_p171 = Lambda_0_5_p170 - Lambda_0_5_p57 * Lambda_0_5_p168 + Lambda_0_5_p59 *
      Lambda_0_5_p169;
  const Real Lambda_0_5_p172 = Lambda_0_5_p170 - Lambda_0_5_p69 * Lambda_0_5_p168 + Lambda_0_5_p70 *
      Lambda_0_5_p169 - Lambda_0_5_p67 * Lambda_0_5_p171;
  const Real Lambda_0_5_p173 = Lambda_0_5_p28 * Lambda_0_5_p167 - Lambda_0_5_p37 * Lambda_0_5_p168 -
      Lambda_0_5_p46 * Lambda_0_5_p169 - Lambda_0_5_p63 * Lambda_0_5_p171 - Lambda_0_5_p74 *
      Lambda_0_5_p172;
  const Real Lambda_0_5_p174 = Lambda_0_5_p109 * Lambda_0_5_p168 + Lambda_0_5_p110 *
      Lambda_0_5_p169 + Lambda_0_5_p108 * Lambda_0_5_p171 + Lambda_0_5_p107 * Lambda_0_5_p172 +
      Lambda_0_5_p100 * Lambda_0_5_p173;
  const Real Lambda_0_5_p175 = Lambda_0_5_p135 * Lambda_0_5_p168 + Lambda_0_5_p136 *
      Lambda_0_5_p169 - Lambda_0_5_p133 * Lambda_0_5_p171 - Lambda_0_5_p132 * Lambda_0_5_p172 -
      Lambda_0_5_p131 * Lambda_0_5_p173;
  const Real Lambda_0_5_p176 = Lambda_0_5_p175 + Lambda_0_5_p114 * Lambda_0_5_p174;

  // link 8 (link5), pose
  const Real Lambda_0_5_p177 = s8 * (c7 * Lambda_0_5_p126 - s7 * Lambda_0_5_p118) + c8 *
      Lambda_0_5_p125;

  // link 7 (link4), pose
  const Real Lambda_0_5_p178 = s7 * Lambda_0_5_p126 + c7 * Lambda_0_5_p118;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p179 = Lambda_0_5_p125 - Lambda_0_5_p43 * Lambda_0_5_p177;
  const Real Lambda_0_5_p180 = Lambda_0_5_p118 + Lambda_0_5_p54 * Lambda_0_5_p177;
  const Real Lambda_0_5_p181 = Lambda_0_5_p57 * Lambda_0_5_p178 - Lambda_0_5_p180 + Lambda_0_5_p59 *
      Lambda_0_5_p179;
  const Real Lambda_0_5_p182 = Lambda_0_5_p69 * Lambda_0_5_p178 - Lambda_0_5_p180 + Lambda_0_5_p70 *
      Lambda_0_5_p179 - Lambda_0_5_p67 * Lambda_0_5_p181;
  const Real Lambda_0_5_p183 = Lambda_0_5_p28 * Lambda_0_5_p177 + Lambda_0_5_p37 * Lambda_0_5_p178 -
      Lambda_0_5_p46 * Lambda_0_5_p179 - Lambda_0_5_p63 * Lambda_0_5_p181 - Lambda_0_5_p74 *
      Lambda_0_5_p182;
  const Real Lambda_0_5_p184 = Lambda_0_5_p109 * Lambda_0_5_p178 - Lambda_0_5_p110 *
      Lambda_0_5_p179 - Lambda_0_5_p108 * Lambda_0_5_p181 - Lambda_0_5_p107 * Lambda_0_5_p182 -
      Lambda_0_5_p100 * Lambda_0_5_p183;
  const Real Lambda_0_5_p185 = Lambda_0_5_p136 * Lambda_0_5_p179 - Lambda_0_5_p135 *
      Lambda_0_5_p178 - Lambda_0_5_p133 * Lambda_0_5_p181 - Lambda_0_5_p132 * Lambda_0_5_p182 -
      Lambda_0_5_p131 * Lambda_0_5_p183;
  const Real Lambda_0_5_p186 = Lambda_0_5_p185 - Lambda_0_5_p114 * Lambda_0_5_p184;
  const Lanes<8> Lambda_0_5_p187_lanes = detail::make_pack<Real>(Lambda_0_5_p150, Lambda_0_5_p150,
      Lambda_0_5_p150, Lambda_0_5_p186, Lambda_0_5_p176, Lambda_0_5_p166, Lambda_0_5_p150,
      Lambda_0_5_p150) * Lambda_0_5_p138;
  const Real Lambda_0_5_p191 = Lambda_0_5_p164 * Lambda_0_5_p113;
  const Real Lambda_0_5_p192 = Lambda_0_5_p163 * Lambda_0_5_p75;
  const Real Lambda_0_5_p193 = Lambda_0_5_p161 * Lambda_0_5_p73;
  const Real Lambda_0_5_p194 = Lambda_0_5_p160 * Lambda_0_5_p62;
  const Real Lambda_0_5_p195 = Lambda_0_5_p194 * Lambda_0_5_p119 + Lambda_0_5_p193 *
      Lambda_0_5_p121 + Lambda_0_5_p192 * Lambda_0_5_p129 - Lambda_0_5_p191 * Lambda_0_5_p130 -
      Lambda_0_5_p187_lanes[5] * Lambda_0_5_p134;
  const Real Lambda_0_5_p196 = 0.05625 * Lambda_0_5_p167;
  const Real Lambda_0_5_p197 = 24999.999999999996 * Lambda_0_5_p156;
  const Real Lambda_0_5_p198 = 1557.24430048586 * Lambda_0_5_p158;
  const Real Lambda_0_5_p199 = Lambda_0_5_p159 * Lambda_0_5_p45;
  const Real Lambda_0_5_p200 = Lambda_0_5_p198 * Lambda_0_5_p168 - Lambda_0_5_p197 *
      Lambda_0_5_p167 + Lambda_0_5_p199 * Lambda_0_5_p169 + Lambda_0_5_p194 * Lambda_0_5_p171 +
      Lambda_0_5_p193 * Lambda_0_5_p172;
  const Real Lambda_0_5_p201 = Lambda_0_5_p200 + Lambda_0_5_p192 * Lambda_0_5_p173 +
      Lambda_0_5_p191 * Lambda_0_5_p174 + Lambda_0_5_p187_lanes[5] * Lambda_0_5_p176;
  const Real Lambda_0_5_p202 = 0.05625 * Lambda_0_5_p156;
  const Real Lambda_0_5_p203 = Lambda_0_5_p197 * Lambda_0_5_p156 + Lambda_0_5_p198 *
      Lambda_0_5_p158 + Lambda_0_5_p199 * Lambda_0_5_p159 + Lambda_0_5_p194 * Lambda_0_5_p160 +
      Lambda_0_5_p193 * Lambda_0_5_p161;
  const Real Lambda_0_5_p204 = Lambda_0_5_p203 + Lambda_0_5_p192 * Lambda_0_5_p163 +
      Lambda_0_5_p191 * Lambda_0_5_p164 + Lambda_0_5_p187_lanes[5] * Lambda_0_5_p166;
  const Lanes<8> Lambda_0_5_p205_lanes = Lambda_0_5_p187_lanes * Lambda_0_5_p150;
  const Real Lambda_0_5_p209 = Lambda_0_5_p194 * Lambda_0_5_p140 + Lambda_0_5_p193 *
      Lambda_0_5_p141 - Lambda_0_5_p192 * Lambda_0_5_p148 - Lambda_0_5_p191 * Lambda_0_5_p149 +
      Lambda_0_5_p205_lanes[5];
  const Real Lambda_0_5_p210 = Lambda_0_5_p209 - (Lambda_0_5_p204 * Lambda_0_5_p196 +
      Lambda_0_5_p201 * Lambda_0_5_p202);
  const Real Lambda_0_5_p211 = 0.05625 * Lambda_0_5_p177;
  const Real Lambda_0_5_p215 = Lambda_0_5_p199 * Lambda_0_5_p179 -
      (Lambda_0_5_p197 * Lambda_0_5_p177 + Lambda_0_5_p198 * Lambda_0_5_p178) + Lambda_0_5_p194 *
      Lambda_0_5_p181 + Lambda_0_5_p193 * Lambda_0_5_p182;
  const Real Lambda_0_5_p216 = Lambda_0_5_p174 * Lambda_0_5_p113;
  const Real Lambda_0_5_p217 = Lambda_0_5_p173 * Lambda_0_5_p75;
  const Real Lambda_0_5_p218 = 24999.999999999996 * Lambda_0_5_p167;
  const Real Lambda_0_5_p219 = 1557.24430048586 * Lambda_0_5_p168;
  const Real Lambda_0_5_p220 = Lambda_0_5_p169 * Lambda_0_5_p45;
  const Real Lambda_0_5_p221 = Lambda_0_5_p171 * Lambda_0_5_p62;
  const Real Lambda_0_5_p222 = Lambda_0_5_p172 * Lambda_0_5_p73;
  const Real Lambda_0_5_p223 = Lambda_0_5_p218 * Lambda_0_5_p177 - Lambda_0_5_p219 *
      Lambda_0_5_p178 + Lambda_0_5_p220 * Lambda_0_5_p179 + Lambda_0_5_p221 * Lambda_0_5_p181 +
      Lambda_0_5_p222 * Lambda_0_5_p182;
  const Real Lambda_0_5_p224 = Lambda_0_5_p184 * Lambda_0_5_p113;
  const Real Lambda_0_5_p225 = Lambda_0_5_p183 * Lambda_0_5_p75;
  const Real Lambda_0_5_p226 = 24999.999999999996 * Lambda_0_5_p177 * Lambda_0_5_p177 +
      1557.24430048586 * Lambda_0_5_p178 * Lambda_0_5_p178 + Lambda_0_5_p179 * Lambda_0_5_p45 *
      Lambda_0_5_p179;
  const Real Lambda_0_5_p227 = Lambda_0_5_p181 * Lambda_0_5_p62;
  const Real Lambda_0_5_p228 = Lambda_0_5_p182 * Lambda_0_5_p73;
  const Real Lambda_0_5_p229 = Lambda_0_5_p226 + Lambda_0_5_p227 * Lambda_0_5_p181 +
      Lambda_0_5_p228 * Lambda_0_5_p182 + Lambda_0_5_p225 * Lambda_0_5_p183 + Lambda_0_5_p224 *
      Lambda_0_5_p184;
  const Lanes<8> Lambda_0_5_p230_lanes = detail::make_pack<Real>(Lambda_0_5_p229, Lambda_0_5_p229,
      Lambda_0_5_p229, Lambda_0_5_p229, Lambda_0_5_p223 + Lambda_0_5_p217 * Lambda_0_5_p183 -
      Lambda_0_5_p216 * Lambda_0_5_p184, Lambda_0_5_p215 + Lambda_0_5_p192 * Lambda_0_5_p183 -
      Lambda_0_5_p191 * Lambda_0_5_p184, Lambda_0_5_p229, Lambda_0_5_p229) + Lambda_0_5_p187_lanes *
      Lambda_0_5_p186;
  const Real Lambda_0_5_p233 = Lambda_0_5_p230_lanes[5] * Lambda_0_5_p196;
  const Real Lambda_0_5_p234 = Lambda_0_5_p230_lanes[4] * Lambda_0_5_p202;
  const Real Lambda_0_5_p235 = Lambda_0_5_p227 * Lambda_0_5_p140 + Lambda_0_5_p228 *
      Lambda_0_5_p141 - Lambda_0_5_p225 * Lambda_0_5_p148 + Lambda_0_5_p224 * Lambda_0_5_p149 +
      Lambda_0_5_p205_lanes[3];
  const Real Lambda_0_5_p236 = Lambda_0_5_p235 - (Lambda_0_5_p233 + Lambda_0_5_p234);
  const Real Lambda_0_5_p237 = Lambda_0_5_p221 * Lambda_0_5_p119 + Lambda_0_5_p222 *
      Lambda_0_5_p121 + Lambda_0_5_p217 * Lambda_0_5_p129 - Lambda_0_5_p216 * Lambda_0_5_p130 -
      Lambda_0_5_p187_lanes[4] * Lambda_0_5_p134;
  const Real Lambda_0_5_p238 = Lambda_0_5_p155 - Lambda_0_5_p196 * Lambda_0_5_p195 +
      Lambda_0_5_p211 * Lambda_0_5_p210 + (Lambda_0_5_p236 - Lambda_0_5_p237) * Lambda_0_5_p202;
  const Real Lambda_0_5_p239 = Lambda_0_5_p218 * Lambda_0_5_p167 + Lambda_0_5_p219 *
      Lambda_0_5_p168 + Lambda_0_5_p220 * Lambda_0_5_p169 + Lambda_0_5_p221 * Lambda_0_5_p171 +
      Lambda_0_5_p222 * Lambda_0_5_p172;
  const Real Lambda_0_5_p240 = Lambda_0_5_p239 + Lambda_0_5_p217 * Lambda_0_5_p173 +
      Lambda_0_5_p216 * Lambda_0_5_p174 + Lambda_0_5_p187_lanes[4] * Lambda_0_5_p176;
  const Real Lambda_0_5_p241 = Lambda_0_5_p221 * Lambda_0_5_p140 + Lambda_0_5_p222 *
      Lambda_0_5_p141 - Lambda_0_5_p217 * Lambda_0_5_p148 - Lambda_0_5_p216 * Lambda_0_5_p149 +
      Lambda_0_5_p205_lanes[4];
  const Real Lambda_0_5_p242 = Lambda_0_5_p241 - (Lambda_0_5_p201 * Lambda_0_5_p196 +
      Lambda_0_5_p240 * Lambda_0_5_p202);
  const Real Lambda_0_5_p243 = Lambda_0_5_p140 * Lambda_0_5_p62 * Lambda_0_5_p140 +
      Lambda_0_5_p141 * Lambda_0_5_p73 * Lambda_0_5_p141 + Lambda_0_5_p148 * Lambda_0_5_p75 *
      Lambda_0_5_p148;
  const Real Lambda_0_5_p244 = Lambda_0_5_p243 + Lambda_0_5_p149 * Lambda_0_5_p113 *
      Lambda_0_5_p149 + Lambda_0_5_p205_lanes[0] - (Lambda_0_5_p196 *
      (Lambda_0_5_p209 + Lambda_0_5_p210) + Lambda_0_5_p202 * (Lambda_0_5_p241 + Lambda_0_5_p242));
  const Real Lambda_0_5_p245 = 1.0 / Lambda_0_5_p244;
  const Real Lambda_0_5_p246 = Lambda_0_5_p238 * Lambda_0_5_p245;
  const Real Lambda_0_5_p247 = Lambda_0_5_p227 * Lambda_0_5_p119 + Lambda_0_5_p228 *
      Lambda_0_5_p121 + Lambda_0_5_p225 * Lambda_0_5_p129 + Lambda_0_5_p224 * Lambda_0_5_p130 -
      Lambda_0_5_p187_lanes[3] * Lambda_0_5_p134;
  const Real Lambda_0_5_p248 = Lambda_0_5_p247 + (Lambda_0_5_p230_lanes[3] * Lambda_0_5_p202 +
      Lambda_0_5_p230_lanes[5] * Lambda_0_5_p211);
  const Real Lambda_0_5_p249 = Lambda_0_5_p195 + (Lambda_0_5_p230_lanes[5] * Lambda_0_5_p202 +
      Lambda_0_5_p204 * Lambda_0_5_p211);
  const Real Lambda_0_5_p250 = Lambda_0_5_p154 * Lambda_0_5_p119 + Lambda_0_5_p153 *
      Lambda_0_5_p121 + Lambda_0_5_p152 * Lambda_0_5_p129 + Lambda_0_5_p151 * Lambda_0_5_p130 +
      Lambda_0_5_p139 * Lambda_0_5_p134;
  const Real Lambda_0_5_p251 = Lambda_0_5_p250 + (Lambda_0_5_p202 *
      (Lambda_0_5_p247 + Lambda_0_5_p248) + Lambda_0_5_p211 * (Lambda_0_5_p195 + Lambda_0_5_p249)) -
      Lambda_0_5_p246 * Lambda_0_5_p238;
  const Real Lambda_0_5_p252 = 1.0 / Lambda_0_5_p251;
  const Real Lambda_0_5_p253 = Lambda_0_5_p210 * Lambda_0_5_p245;
  const Real Lambda_0_5_p254 = Lambda_0_5_p249 - Lambda_0_5_p253 * Lambda_0_5_p238;
  const Real Lambda_0_5_p255 = Lambda_0_5_p254 * Lambda_0_5_p252;

  // link 6 (link3), Jacobian
  const Real Lambda_0_5_p256 = Lambda_0_5_p118 * Lambda_0_5_p146 + Lambda_0_5_p122 *
      Lambda_0_5_p127;

  // link 1 (base_x), mass matrix
  const Real Lambda_0_5_p257 = Lambda_0_5_p67 * Lambda_0_5_p256 -
      (Lambda_0_5_p118 * Lambda_0_5_p147 + Lambda_0_5_p122 * Lambda_0_5_p128);
  const Real Lambda_0_5_p258 = Lambda_0_5_p63 * Lambda_0_5_p256 - Lambda_0_5_p74 * Lambda_0_5_p257;
  const Real Lambda_0_5_p259 = Lambda_0_5_p108 * Lambda_0_5_p256 - Lambda_0_5_p107 *
      Lambda_0_5_p257 - Lambda_0_5_p100 * Lambda_0_5_p258;
  const Real Lambda_0_5_p260 = Lambda_0_5_p133 * Lambda_0_5_p256 - Lambda_0_5_p132 *
      Lambda_0_5_p257 - Lambda_0_5_p131 * Lambda_0_5_p258 - Lambda_0_5_p114 * Lambda_0_5_p259;
  const Real Lambda_0_5_p261 = Lambda_0_5_p222 * Lambda_0_5_p257 - Lambda_0_5_p221 *
      Lambda_0_5_p256 + Lambda_0_5_p217 * Lambda_0_5_p258 - Lambda_0_5_p216 * Lambda_0_5_p259 +
      Lambda_0_5_p187_lanes[4] * Lambda_0_5_p260;
  const Real Lambda_0_5_p262 = Lambda_0_5_p260 * Lambda_0_5_p138;
  const Real Lambda_0_5_p263 = Lambda_0_5_p259 * Lambda_0_5_p113;
  const Real Lambda_0_5_p264 = Lambda_0_5_p258 * Lambda_0_5_p75;
  const Real Lambda_0_5_p265 = Lambda_0_5_p257 * Lambda_0_5_p73;
  const Real Lambda_0_5_p266 = Lambda_0_5_p256 * Lambda_0_5_p62;
  const Real Lambda_0_5_p267 = Lambda_0_5_p265 * Lambda_0_5_p141 - Lambda_0_5_p266 *
      Lambda_0_5_p140 - Lambda_0_5_p264 * Lambda_0_5_p148 + Lambda_0_5_p263 * Lambda_0_5_p149 +
      Lambda_0_5_p262 * Lambda_0_5_p150;
  const Real Lambda_0_5_p268 = Lambda_0_5_p193 * Lambda_0_5_p257 - Lambda_0_5_p194 *
      Lambda_0_5_p256 + Lambda_0_5_p192 * Lambda_0_5_p258 - Lambda_0_5_p191 * Lambda_0_5_p259 +
      Lambda_0_5_p187_lanes[5] * Lambda_0_5_p260;
  const Real Lambda_0_5_p269 = Lambda_0_5_p267 - Lambda_0_5_p202 * Lambda_0_5_p261 -
      Lambda_0_5_p211 * Lambda_0_5_p242 + (Lambda_0_5_p236 - Lambda_0_5_p268) * Lambda_0_5_p196;
  const Real Lambda_0_5_p270 = Lambda_0_5_p269 * Lambda_0_5_p245;
  const Real Lambda_0_5_p271 = Lambda_0_5_p265 * Lambda_0_5_p121 - Lambda_0_5_p266 *
      Lambda_0_5_p119 + Lambda_0_5_p264 * Lambda_0_5_p129 + Lambda_0_5_p263 * Lambda_0_5_p130 -
      Lambda_0_5_p262 * Lambda_0_5_p134;
  const Real Lambda_0_5_p272 = Lambda_0_5_p228 * Lambda_0_5_p257 - Lambda_0_5_p227 *
      Lambda_0_5_p256 + Lambda_0_5_p225 * Lambda_0_5_p258 + Lambda_0_5_p224 * Lambda_0_5_p259 +
      Lambda_0_5_p187_lanes[3] * Lambda_0_5_p260;
  const Real Lambda_0_5_p273 = Lambda_0_5_p201 * Lambda_0_5_p211;
  const Real Lambda_0_5_p274 = Lambda_0_5_p237 + (Lambda_0_5_p234 + Lambda_0_5_p273);
  const Real Lambda_0_5_p275 = Lambda_0_5_p271 + Lambda_0_5_p196 * Lambda_0_5_p248 +
      Lambda_0_5_p202 * Lambda_0_5_p272 - Lambda_0_5_p270 * Lambda_0_5_p238 +
      (Lambda_0_5_p268 - Lambda_0_5_p274) * Lambda_0_5_p211;
  const Real Lambda_0_5_p276 = Lambda_0_5_p242 * Lambda_0_5_p245;
  const Real Lambda_0_5_p277 = Lambda_0_5_p274 - Lambda_0_5_p276 * Lambda_0_5_p238;
  const Real Lambda_0_5_p278 = Lambda_0_5_p277 * Lambda_0_5_p252;
  const Real Lambda_0_5_p279 = Lambda_0_5_p236 * Lambda_0_5_p245;
  const Real Lambda_0_5_p280 = Lambda_0_5_p248 - Lambda_0_5_p279 * Lambda_0_5_p238;
  const Real Lambda_0_5_p281 = Lambda_0_5_p280 * Lambda_0_5_p252;
  const Real Lambda_0_5_p282 = Lambda_0_5_p275 * Lambda_0_5_p252;
  const Real Lambda_0_5_p291 = Lambda_0_5_p261 - (Lambda_0_5_p240 * Lambda_0_5_p211 -
      Lambda_0_5_p230_lanes[4] * Lambda_0_5_p196);
  const Real Lambda_0_5_p292 = Lambda_0_5_p272 - (Lambda_0_5_p230_lanes[4] * Lambda_0_5_p211 -
      Lambda_0_5_p230_lanes[3] * Lambda_0_5_p196);
  const Real Lambda_0_5_p293 = Lambda_0_5_p266 * Lambda_0_5_p256 + Lambda_0_5_p265 *
      Lambda_0_5_p257 + Lambda_0_5_p264 * Lambda_0_5_p258 + Lambda_0_5_p263 * Lambda_0_5_p259 +
      Lambda_0_5_p262 * Lambda_0_5_p260;
  const Lanes<8> Lambda_0_5_p298_lanes = detail::make_pack<Real>(Lambda_0_5_p293 -
      (Lambda_0_5_p211 * (Lambda_0_5_p261 + Lambda_0_5_p291) - Lambda_0_5_p196 *
      (Lambda_0_5_p272 + Lambda_0_5_p292)), Lambda_0_5_p293 -
      (Lambda_0_5_p211 * (Lambda_0_5_p261 + Lambda_0_5_p291) - Lambda_0_5_p196 *
      (Lambda_0_5_p272 + Lambda_0_5_p292)), Lambda_0_5_p293 -
      (Lambda_0_5_p211 * (Lambda_0_5_p261 + Lambda_0_5_p291) - Lambda_0_5_p196 *
      (Lambda_0_5_p272 + Lambda_0_5_p292)), Lambda_0_5_p292, Lambda_0_5_p291, Lambda_0_5_p268 -
      (Lambda_0_5_p273 - Lambda_0_5_p233), Lambda_0_5_p293 -
      (Lambda_0_5_p211 * (Lambda_0_5_p261 + Lambda_0_5_p291) - Lambda_0_5_p196 *
      (Lambda_0_5_p272 + Lambda_0_5_p292)), Lambda_0_5_p293 -
      (Lambda_0_5_p211 * (Lambda_0_5_p261 + Lambda_0_5_p291) - Lambda_0_5_p196 *
      (Lambda_0_5_p272 + Lambda_0_5_p292))) - detail::make_pack<Real>(Lambda_0_5_p270,
      Lambda_0_5_p270, Lambda_0_5_p270, Lambda_0_5_p279, Lambda_0_5_p276, Lambda_0_5_p253,
      Lambda_0_5_p270, Lambda_0_5_p270) * Lambda_0_5_p269 -
      detail::make_pack<Real>(Lambda_0_5_p282, Lambda_0_5_p282, Lambda_0_5_p282, Lambda_0_5_p281,
      Lambda_0_5_p278, Lambda_0_5_p255, Lambda_0_5_p282, Lambda_0_5_p282) * Lambda_0_5_p275;
  const Real Lambda_0_5_p302 = 1.0 / Lambda_0_5_p298_lanes[2];
  const Lanes<8> Lambda_0_5_p303_lanes = Lambda_0_5_p298_lanes * Lambda_0_5_p302;
  const Lanes<8> Lambda_0_5_p321_lanes = Lambda_0_5_p230_lanes -
      detail::make_pack<Real>(Lambda_0_5_p279, Lambda_0_5_p279, Lambda_0_5_p279, Lambda_0_5_p279,
      Lambda_0_5_p276, Lambda_0_5_p253, Lambda_0_5_p279, Lambda_0_5_p279) * Lambda_0_5_p236 -
      detail::make_pack<Real>(Lambda_0_5_p281, Lambda_0_5_p281, Lambda_0_5_p281, Lambda_0_5_p281,
      Lambda_0_5_p278, Lambda_0_5_p255, Lambda_0_5_p281, Lambda_0_5_p281) * Lambda_0_5_p280 -
      Lambda_0_5_p303_lanes * Lambda_0_5_p298_lanes[3];
  const Real Lambda_0_5_p324 = 1.0 / Lambda_0_5_p321_lanes[3];
  const Real Lambda_0_5_p325 = Lambda_0_5_p321_lanes[5] * Lambda_0_5_p324;
  const Real Lambda_0_5_p326 = Lambda_0_5_p201 - Lambda_0_5_p253 * Lambda_0_5_p242 -
      Lambda_0_5_p255 * Lambda_0_5_p277 - Lambda_0_5_p303_lanes[5] * Lambda_0_5_p298_lanes[4] -
      Lambda_0_5_p325 * Lambda_0_5_p321_lanes[4];
  const Real Lambda_0_5_p327 = Lambda_0_5_p321_lanes[4] * Lambda_0_5_p324;
  const Real Lambda_0_5_p328 = Lambda_0_5_p240 - Lambda_0_5_p276 * Lambda_0_5_p242 -
      Lambda_0_5_p278 * Lambda_0_5_p277 - Lambda_0_5_p303_lanes[4] * Lambda_0_5_p298_lanes[4] -
      Lambda_0_5_p327 * Lambda_0_5_p321_lanes[4];
  const Real Lambda_0_5_p329 = 1.0 / Lambda_0_5_p328;
  const Real Lambda_0_5_p330 = Lambda_0_5_p326 * Lambda_0_5_p329;
  const Real Lambda_0_5_p331 = Lambda_0_5_p282 * Lambda_0_5_p246 - Lambda_0_5_p270;
  const Real Lambda_0_5_p332 = Lambda_0_5_p281 * Lambda_0_5_p246 - Lambda_0_5_p279 -
      Lambda_0_5_p303_lanes[3] * Lambda_0_5_p331;
  const Real Lambda_0_5_p333 = Lambda_0_5_p278 * Lambda_0_5_p246 - Lambda_0_5_p276 -
      Lambda_0_5_p303_lanes[4] * Lambda_0_5_p331 - Lambda_0_5_p327 * Lambda_0_5_p332;
  const Real Lambda_0_5_p334 = Lambda_0_5_p255 * Lambda_0_5_p246 - Lambda_0_5_p253 -
      Lambda_0_5_p303_lanes[5] * Lambda_0_5_p331 - Lambda_0_5_p325 * Lambda_0_5_p332 -
      Lambda_0_5_p330 * Lambda_0_5_p333;
  const Real Lambda_5_5_p1 = Lambda_0_5_p204 - Lambda_0_5_p253 * Lambda_0_5_p210 - Lambda_0_5_p255 *
      Lambda_0_5_p254 - Lambda_0_5_p303_lanes[5] * Lambda_0_5_p298_lanes[5] - Lambda_0_5_p325 *
      Lambda_0_5_p321_lanes[5];
  const Real Lambda_5_5 = 1.0 / (Lambda_5_5_p1 - Lambda_0_5_p330 * Lambda_0_5_p326);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5 = Lambda_0_5_p334 * Lambda_5_5;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_0_0_p1 = Lambda_0_5_p333 * Lambda_0_5_p329;
  const Real Lambda_0_0_p2 = Lambda_0_5_p332 * Lambda_0_5_p324;
  const Real Lambda_0_0_p3 = Lambda_0_5_p331 * Lambda_0_5_p302;
  const Real Lambda_0_0_p4 = Lambda_0_5_p246 * Lambda_0_5_p252;
  const Real Lambda_0_0_p5 = Lambda_0_5_p245 + Lambda_0_0_p4 * Lambda_0_5_p246 + Lambda_0_0_p3 *
      Lambda_0_5_p331 + Lambda_0_0_p2 * Lambda_0_5_p332 + Lambda_0_0_p1 * Lambda_0_5_p333;
  Lambda[0] = Lambda_0_0_p5 + Lambda_0_5 * Lambda_0_5_p334;
  const Real Lambda_1_5_p1 = Lambda_0_5_p303_lanes[3] * Lambda_0_5_p282 - Lambda_0_5_p281;
  const Real Lambda_1_5_p2 = Lambda_0_5_p303_lanes[4] * Lambda_0_5_p282 - Lambda_0_5_p278 -
      Lambda_0_5_p327 * Lambda_1_5_p1;
  const Real Lambda_1_5_p3 = Lambda_0_5_p303_lanes[5] * Lambda_0_5_p282 - Lambda_0_5_p255 -
      Lambda_0_5_p325 * Lambda_1_5_p1 - Lambda_0_5_p330 * Lambda_1_5_p2;
  const Real Lambda_1_5 = Lambda_1_5_p3 * Lambda_5_5;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_0_1_p1 = Lambda_1_5_p2 * Lambda_0_5_p329;
  const Real Lambda_0_1_p2 = Lambda_1_5_p1 * Lambda_0_5_p324;
  const Real Lambda_0_1_p3 = Lambda_0_5_p282 * Lambda_0_5_p302;
  const Real Lambda_0_1 = Lambda_0_1_p2 * Lambda_0_5_p332 -
      (Lambda_0_0_p4 + Lambda_0_1_p3 * Lambda_0_5_p331) + Lambda_0_1_p1 * Lambda_0_5_p333 +
      Lambda_1_5 * Lambda_0_5_p334;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_2_5_p1 = Lambda_0_5_p327 * Lambda_0_5_p303_lanes[3] - Lambda_0_5_p303_lanes[4];
  const Real Lambda_2_5_p2 = Lambda_0_5_p325 * Lambda_0_5_p303_lanes[3] - Lambda_0_5_p303_lanes[5] -
      Lambda_0_5_p330 * Lambda_2_5_p1;
  const Real Lambda_2_5 = Lambda_2_5_p2 * Lambda_5_5;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_0_2_p1 = Lambda_2_5_p1 * Lambda_0_5_p329;
  const Real Lambda_0_2_p2 = Lambda_0_5_p303_lanes[3] * Lambda_0_5_p324;
  const Real Lambda_0_2 = Lambda_0_0_p3 - Lambda_0_2_p2 * Lambda_0_5_p332 + Lambda_0_2_p1 *
      Lambda_0_5_p333 + Lambda_2_5 * Lambda_0_5_p334;
  Lambda[2] = Lambda_0_2;
  Lambda[12] = Lambda_0_2;
  const Real Lambda_3_5_p1 = Lambda_0_5_p330 * Lambda_0_5_p327 - Lambda_0_5_p325;
  const Real Lambda_3_5 = Lambda_3_5_p1 * Lambda_5_5;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_0_3_p1 = Lambda_0_5_p327 * Lambda_0_5_p329;
  const Real Lambda_0_3 = Lambda_0_0_p2 - Lambda_0_3_p1 * Lambda_0_5_p333 + Lambda_3_5 *
      Lambda_0_5_p334;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_4_5 = Lambda_0_5_p330 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  const Real Lambda_0_4 = Lambda_0_0_p1 - Lambda_4_5 * Lambda_0_5_p334;
  Lambda[4] = Lambda_0_4;
  Lambda[24] = Lambda_0_4;
  Lambda[7] = Lambda_0_5_p252 + Lambda_0_1_p3 * Lambda_0_5_p282 + Lambda_0_1_p2 * Lambda_1_5_p1 +
      Lambda_0_1_p1 * Lambda_1_5_p2 + Lambda_1_5 * Lambda_1_5_p3;
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
  Lambda[14] = Lambda_0_5_p302 + Lambda_0_2_p2 * Lambda_0_5_p303_lanes[3] + Lambda_0_2_p1 *
      Lambda_2_5_p1 + Lambda_2_5 * Lambda_2_5_p2;
  const Real Lambda_2_3 = Lambda_3_5 * Lambda_2_5_p2 -
      (Lambda_0_2_p2 + Lambda_0_3_p1 * Lambda_2_5_p1);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p1 - Lambda_4_5 * Lambda_2_5_p2;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_0_5_p324 + Lambda_0_3_p1 * Lambda_0_5_p327 + Lambda_3_5 * Lambda_3_5_p1;
  const Real Lambda_3_4 = Lambda_0_3_p1 + Lambda_4_5 * Lambda_3_5_p1;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_0_5_p329 + Lambda_4_5 * Lambda_0_5_p330;
}

}  // namespace samm

#undef TREELINE_RESTRICT
