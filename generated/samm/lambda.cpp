// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J from poses, in the axes asked for at link origins.
// 1198 flops (add 497, mul 689, div 12), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
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
  const Real Lambda_5_5_p1 = 0.00020215999999999998 * s8;

  // link 9 (link6), mass matrix
  const Real Lambda_5_5_p2 = 4e-05 * c8;

  // link 8 (link5), composite inertia
  const Real Lambda_5_5_p3 = 0.0028799999999999997 * s8;
  const Real Lambda_5_5_p4 = 0.0028799999999999997 * c8;

  // link 9 (link6), mass matrix
  const Real Lambda_5_5_p5 = 4e-05 * s8;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p6 = 0.9999999999999999 * c8;

  // link 8 (link5), composite inertia
  const Real Lambda_5_5_p7 = s8 * Lambda_5_5_p1;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p8 = c7 * Lambda_5_5_p3;

  // link 8 (link5), composite inertia
  const Real Lambda_5_5_p9 = c8 * Lambda_5_5_p1;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p10 = c7 * Lambda_5_5_p4;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p11 = s7 * Lambda_5_5_p3;
  const Real Lambda_5_5_p12 = 0.861795 + Lambda_5_5_p4;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p13 = s7 * Lambda_5_5_p4;

  // link 9 (link6), mass matrix
  const Real Lambda_5_5_p14 = c7 * Lambda_5_5_p5;

  // link 8 (link5), composite inertia
  const Real Lambda_5_5_p15 = 0.00164 + Lambda_5_5_p7;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p16 = 0.0203 * Lambda_5_5_p8;

  // link 9 (link6), mass matrix
  const Real Lambda_5_5_p17 = s7 * Lambda_5_5_p5;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p18 = s7 * (0.00010000000000000026 + Lambda_5_5_p7);
  const Real Lambda_5_5_p19 = Lambda_5_5_p8 - 0.025374999999999998;

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p20 = s6 * Lambda_5_5_p11;
  const Real Lambda_5_5_p21 = c7 * Lambda_5_5_p9 + 0.4331 * Lambda_5_5_p8;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p22 = 1.0 / (Lambda_5_5_p15 - Lambda_5_5_p6 * Lambda_5_5_p2);

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p23 = s7 * Lambda_5_5_p9 + 0.4331 * Lambda_5_5_p11;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p24 = 24999.999999999996 * Lambda_5_5_p17;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p25 = s7 * Lambda_5_5_p18;
  const Real Lambda_5_5_p26 = 0.0067651125 + (Lambda_5_5_p15 - 0.0406 * Lambda_5_5_p8);

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p27 = s6 * Lambda_5_5_p10 + c6 * Lambda_5_5_p3;
  const Real Lambda_5_5_p28 = 0.00064216 * c7 + (0.4331 * Lambda_5_5_p10 - 5.846399999999999e-05 *
      s8);

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p29 = Lambda_5_5_p23 + Lambda_5_5_p6 * Lambda_5_5_p17;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p30 = 0.0203 * Lambda_5_5_p13;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p31 = Lambda_5_5_p21 - 5.846399999999999e-05 * c8 - 0.010673638499999999;

  // link 6 (link3), mass matrix
  const Real Lambda_5_5_p32 = s6 * Lambda_5_5_p12 + c6 * Lambda_5_5_p19;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p33 = 1557.24430048586 * Lambda_5_5_p28;

  // link 6 (link3), mass matrix
  const Real Lambda_5_5_p34 = c6 * Lambda_5_5_p12 - s6 * Lambda_5_5_p19;

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p35 = c6 * Lambda_5_5_p11;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p36 = 0.0203 * Lambda_5_5_p11 - c7 * Lambda_5_5_p18;
  const Real Lambda_5_5_p37 = 0.004704000000000001 + Lambda_5_5_p23;

  // link 6 (link3), mass matrix
  const Real Lambda_5_5_p38 = 0.4318 * Lambda_5_5_p32;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p39 = 0.00064216 * s7 + 0.4331 * Lambda_5_5_p13;
  const Real Lambda_5_5_p40 = c6 * Lambda_5_5_p10 - s6 * Lambda_5_5_p3;

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p41 = Lambda_5_5_p16 - Lambda_5_5_p15;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p42 = Lambda_5_5_p28 + 0.4318 * Lambda_5_5_p27;

  // link 7 (link4), composite inertia
  const Real Lambda_5_5_p43 = 0.3056901365 + (0.0011921599999999998 - Lambda_5_5_p7 +
      Lambda_5_5_p25 + 0.0024946559999999996 * c8);

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p44 = Lambda_5_5_p29 * Lambda_5_5_p22;
  const Real Lambda_5_5_p45 = 0.312455249 + (0.00129216 - Lambda_5_5_p25 + 2.0 *
      (0.0012473279999999998 * c8 - Lambda_5_5_p16)) - Lambda_5_5_p24 * Lambda_5_5_p17;
  const Real Lambda_5_5_p46 = Lambda_5_5_p29 + 0.4318 * Lambda_5_5_p20;

  // link 6 (link3), composite inertia
  const Real Lambda_5_5_p47 = s6 * (Lambda_5_5_p43 - Lambda_5_5_p26) + c6 * (2.0 * Lambda_5_5_p31);

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p48 = 1557.24430048586 * Lambda_5_5_p42;

  // link 6 (link3), composite inertia
  const Real Lambda_5_5_p49 = s6 * Lambda_5_5_p47;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p50 = 1.0 / (Lambda_5_5_p45 - Lambda_5_5_p33 * Lambda_5_5_p28 -
      Lambda_5_5_p44 * Lambda_5_5_p29);

  // link 6 (link3), mass matrix
  const Real Lambda_5_5_p51 = c6 * Lambda_5_5_p36 - s6 * Lambda_5_5_p37 - 0.1501 * Lambda_5_5_p32;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p52 = Lambda_5_5_p45 + Lambda_5_5_p38 - Lambda_5_5_p33 * Lambda_5_5_p42 -
      Lambda_5_5_p44 * Lambda_5_5_p46;
  const Real Lambda_5_5_p53 = Lambda_5_5_p46 * Lambda_5_5_p22;

  // link 6 (link3), mass matrix
  const Real Lambda_5_5_p54 = s6 * Lambda_5_5_p36 + c6 * Lambda_5_5_p37 + 0.1501 * Lambda_5_5_p34;

  // link 9 (link6), mass matrix
  const Real Lambda_5_5_p55 = s5 * (c6 * Lambda_5_5_p14 + s6 * Lambda_5_5_p2) + c5 *
      (s6 * Lambda_5_5_p14 - c6 * Lambda_5_5_p2);

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p56 = c5 * (c6 * Lambda_5_5_p30 - s6 * Lambda_5_5_p39 +
      (0.1501 * Lambda_5_5_p40 - 0.4318 * Lambda_5_5_p13));

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p57 = c5 * (c6 * Lambda_5_5_p41 - s6 * Lambda_5_5_p21 -
      (0.1501 * Lambda_5_5_p35 + 0.4318 * Lambda_5_5_p8));

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p58 = s5 * (c6 * Lambda_5_5_p39 + s6 * Lambda_5_5_p30 + 0.1501 *
      Lambda_5_5_p27) - Lambda_5_5_p56;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p59 = Lambda_5_5_p24 * Lambda_5_5_p55;

  // link 6 (link3), composite inertia
  const Real Lambda_5_5_p60 = 1.674987602 + (Lambda_5_5_p26 + Lambda_5_5_p49 + 2.0 *
      (Lambda_5_5_p38 + 0.1501 * Lambda_5_5_p11));

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p61 = Lambda_5_5_p6 * Lambda_5_5_p55 -
      (s5 * (0.1501 * Lambda_5_5_p20 - (c6 * Lambda_5_5_p21 + s6 * Lambda_5_5_p41)) +
      Lambda_5_5_p57);

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p62 = s5 * Lambda_5_5_p27 - c5 * Lambda_5_5_p40;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p63 = Lambda_5_5_p52 * Lambda_5_5_p50;

  // link 6 (link3), composite inertia
  const Real Lambda_5_5_p64 = 0.10439999999999999 - Lambda_5_5_p34;
  const Real Lambda_5_5_p65 = 3.79559 + Lambda_5_5_p32;

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p66 = c5 * Lambda_5_5_p35 - s5 * Lambda_5_5_p20;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p67 = 24999.999999999996 * Lambda_5_5_p55;
  const Real Lambda_5_5_p68 = Lambda_5_5_p59 - (s5 *
      (Lambda_5_5_p51 - 0.4318 * Lambda_5_5_p11 - 0.690314699) + c5 *
      (Lambda_5_5_p54 - 0.023750999999999998));

  // link 6 (link3), mass matrix
  const Real Lambda_5_5_p69 = s5 * Lambda_5_5_p32 - c5 * Lambda_5_5_p34;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p70 = Lambda_5_5_p59 - (s5 * Lambda_5_5_p51 + c5 * Lambda_5_5_p54) -
      Lambda_5_5_p33 * Lambda_5_5_p58 + Lambda_5_5_p44 * Lambda_5_5_p61;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p71 = c4 * Lambda_5_5_p13 - s4 * Lambda_5_5_p62;

  // link 5 (link2), composite inertia
  const Real Lambda_5_5_p72 = s5 * (0.07312640000000001 +
      (Lambda_5_5_p43 - Lambda_5_5_p49 + 0.3002 * Lambda_5_5_p11) - Lambda_5_5_p60) + c5 *
      (2.0 * (c6 * Lambda_5_5_p47 - Lambda_5_5_p31 + 0.4318 * Lambda_5_5_p34 - 0.0070992));

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p73 = c4 * Lambda_5_5_p62 + s4 * Lambda_5_5_p13;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p74 = 1557.24430048586 * Lambda_5_5_p58;
  const Real Lambda_5_5_p75 = 1.7481140020000001 + Lambda_5_5_p45 + 0.8636 * Lambda_5_5_p32 -
      Lambda_5_5_p48 * Lambda_5_5_p42 - Lambda_5_5_p53 * Lambda_5_5_p46 - Lambda_5_5_p63 *
      Lambda_5_5_p52;

  // link 6 (link3), mass matrix
  const Real Lambda_5_5_p76 = c4 * Lambda_5_5_p69;
  const Real Lambda_5_5_p77 = s4 * Lambda_5_5_p69;

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p78 = c4 * Lambda_5_5_p8 - s4 * Lambda_5_5_p66;
  const Real Lambda_5_5_p79 = c4 * Lambda_5_5_p66 + s4 * Lambda_5_5_p8;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p80 = 1.0 / Lambda_5_5_p75;
  const Real Lambda_5_5_p81 = Lambda_5_5_p61 * Lambda_5_5_p22;

  // link 5 (link2), mass matrix
  const Real Lambda_5_5_p82 = c5 * Lambda_5_5_p64 + s5 * Lambda_5_5_p65;

  // link 5 (link2), composite inertia
  const Real Lambda_5_5_p83 = s5 * Lambda_5_5_p64 - c5 * Lambda_5_5_p65;
  const Real Lambda_5_5_p84 = 4.9338049999999996 + Lambda_5_5_p11;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p85 = Lambda_5_5_p70 * Lambda_5_5_p50;
  const Real Lambda_5_5_p86 = Lambda_5_5_p68 - Lambda_5_5_p48 * Lambda_5_5_p58 + Lambda_5_5_p53 *
      Lambda_5_5_p61 - Lambda_5_5_p63 * Lambda_5_5_p70;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p87 = c3 * Lambda_5_5_p71 - s3 * Lambda_5_5_p73;

  // link 5 (link2), mass matrix
  const Real Lambda_5_5_p88 = c4 * Lambda_5_5_p82;
  const Real Lambda_5_5_p89 = s4 * Lambda_5_5_p82;

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p90 = c3 * Lambda_5_5_p78 - s3 * Lambda_5_5_p79;

  // link 4 (link1), mass matrix
  const Real Lambda_5_5_p91 = s4 * Lambda_5_5_p83 - c4 * Lambda_5_5_p84;
  const Real Lambda_5_5_p92 = s4 * Lambda_5_5_p84 + c4 * Lambda_5_5_p83;

  // link 4 (link1), pose
  const Real Lambda_5_5_p93 = c4 * s3 + s4 * c3;
  const Real Lambda_5_5_p94 = c4 * c3 - s4 * s3;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p95 = 1557.24430048586 * Lambda_5_5_p87;
  const Real Lambda_5_5_p96 = Lambda_5_5_p86 * Lambda_5_5_p80;

  // link 5 (link2), pose
  const Real Lambda_5_5_p97 = c5 * Lambda_5_5_p94;
  const Real Lambda_5_5_p98 = s5 * Lambda_5_5_p94;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p99 = Lambda_5_5_p44 * Lambda_5_5_p90 -
      (s3 * Lambda_5_5_p76 + c3 * Lambda_5_5_p77 + Lambda_5_5_p33 * Lambda_5_5_p87);
  const Real Lambda_5_5_p100 = 1.4717295504999999 + (Lambda_5_5_p60 + s5 * Lambda_5_5_p72) -
      Lambda_5_5_p67 * Lambda_5_5_p55 - Lambda_5_5_p74 * Lambda_5_5_p58 - Lambda_5_5_p81 *
      Lambda_5_5_p61;

  // link 8 (link5), mass matrix
  const Real Lambda_5_5_p101 = c3 * Lambda_5_5_p73 + s3 * Lambda_5_5_p71;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p102 = Lambda_5_5_p90 * Lambda_5_5_p22;

  // link 5 (link2), pose
  const Real Lambda_5_5_p103 = c5 * Lambda_5_5_p93;
  const Real Lambda_5_5_p104 = s5 * Lambda_5_5_p93;

  // link 6 (link3), pose
  const Real Lambda_5_5_p105 = c6 * s5 + s6 * c5;

  // link 7 (link4), mass matrix
  const Real Lambda_5_5_p106 = c3 * Lambda_5_5_p79 + s3 * Lambda_5_5_p78;

  // link 6 (link3), pose
  const Real Lambda_5_5_p107 = c6 * Lambda_5_5_p97 - s6 * Lambda_5_5_p98;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p108 = Lambda_5_5_p53 * Lambda_5_5_p90 -
      (s3 * Lambda_5_5_p88 + c3 * Lambda_5_5_p89 + Lambda_5_5_p48 * Lambda_5_5_p87) -
      Lambda_5_5_p63 * Lambda_5_5_p99;
  const Real Lambda_5_5_p109 = Lambda_5_5_p99 * Lambda_5_5_p50;
  const Real Lambda_5_5_p110 = 1.0 / (Lambda_5_5_p100 - Lambda_5_5_p85 * Lambda_5_5_p70 -
      Lambda_5_5_p96 * Lambda_5_5_p86);
  const Real Lambda_5_5_p111 = s3 * Lambda_5_5_p91 - c3 * Lambda_5_5_p92 - Lambda_5_5_p74 *
      Lambda_5_5_p87 - Lambda_5_5_p81 * Lambda_5_5_p90 - Lambda_5_5_p85 * Lambda_5_5_p99;

  // link 6 (link3), pose
  const Real Lambda_5_5_p112 = s6 * s5 - c6 * c5;
  const Real Lambda_5_5_p113 = s6 * Lambda_5_5_p97 + c6 * Lambda_5_5_p98;
  const Real Lambda_5_5_p114 = c6 * Lambda_5_5_p103 - s6 * Lambda_5_5_p104;
  const Real Lambda_5_5_p115 = s6 * Lambda_5_5_p103 + c6 * Lambda_5_5_p104;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p116 = Lambda_5_5_p108 * Lambda_5_5_p80;
  const Real Lambda_5_5_p117 = Lambda_5_5_p111 - Lambda_5_5_p96 * Lambda_5_5_p108;
  const Real Lambda_5_5_p118 = s3 * Lambda_5_5_p77 - c3 * Lambda_5_5_p76 + Lambda_5_5_p33 *
      Lambda_5_5_p101 - Lambda_5_5_p44 * Lambda_5_5_p106;

  // link 7 (link4), pose
  const Real Lambda_5_5_p119 = s7 * Lambda_5_5_p105;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p120 = 1557.24430048586 * Lambda_5_5_p101;
  const Real Lambda_5_5_p121 = Lambda_5_5_p106 * Lambda_5_5_p22;
  const Real Lambda_5_5_p122 = 186.45 - Lambda_5_5_p95 * Lambda_5_5_p87 - Lambda_5_5_p102 *
      Lambda_5_5_p90 - Lambda_5_5_p109 * Lambda_5_5_p99 - Lambda_5_5_p116 * Lambda_5_5_p108;
  const Real Lambda_5_5_p123 = Lambda_5_5_p118 * Lambda_5_5_p50;

  // link 8 (link5), pose
  const Real Lambda_5_5_p124 = s8 * (c7 * Lambda_5_5_p105) + c8 * Lambda_5_5_p112;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p125 = s3 * Lambda_5_5_p89 - c3 * Lambda_5_5_p88 + Lambda_5_5_p48 *
      Lambda_5_5_p101 - Lambda_5_5_p53 * Lambda_5_5_p106 - Lambda_5_5_p63 * Lambda_5_5_p118;
  const Real Lambda_5_5_p126 = Lambda_5_5_p117 * Lambda_5_5_p110;

  // link 7 (link4), pose
  const Real Lambda_5_5_p127 = 0.0203 * Lambda_5_5_p105 - 0.4331 * Lambda_5_5_p112;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p128 = Lambda_5_5_p24 * Lambda_5_5_p124;
  const Real Lambda_5_5_p129 = c3 * Lambda_5_5_p91 + s3 * Lambda_5_5_p92 + Lambda_5_5_p74 *
      Lambda_5_5_p101 + Lambda_5_5_p81 * Lambda_5_5_p106 - Lambda_5_5_p85 * Lambda_5_5_p118;

  // link 6 (link3), Jacobian
  const Real Lambda_5_5_p130 = Lambda_5_5_p94 * Lambda_5_5_p127;
  const Real Lambda_5_5_p131 = Lambda_5_5_p127 - 0.4318 * s5;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p132 = Lambda_5_5_p125 * Lambda_5_5_p80;
  const Real Lambda_5_5_p133 = Lambda_5_5_p6 * Lambda_5_5_p124 - Lambda_5_5_p112;
  const Real Lambda_5_5_p134 = Lambda_5_5_p129 - Lambda_5_5_p96 * Lambda_5_5_p125;

  // link 7 (link4), pose
  const Real Lambda_5_5_p135 = c7 * Lambda_5_5_p94 - s7 * Lambda_5_5_p114;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p136 = Lambda_5_5_p134 * Lambda_5_5_p110;
  const Real Lambda_5_5_p137 = 1.0 / (Lambda_5_5_p122 - Lambda_5_5_p126 * Lambda_5_5_p117);

  // link 7 (link4), pose
  const Real Lambda_5_5_p138 = 0.4331 * Lambda_5_5_p115 - 0.0203 * Lambda_5_5_p114;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p139 = Lambda_5_5_p128 - Lambda_5_5_p33 * Lambda_5_5_p119 + Lambda_5_5_p44 *
      Lambda_5_5_p133;
  const Real Lambda_5_5_p140 = Lambda_5_5_p95 * Lambda_5_5_p101 + Lambda_5_5_p102 *
      Lambda_5_5_p106 - Lambda_5_5_p109 * Lambda_5_5_p118 - Lambda_5_5_p116 * Lambda_5_5_p125 -
      Lambda_5_5_p126 * Lambda_5_5_p134;

  // link 8 (link5), pose
  const Real Lambda_5_5_p141 = s8 * (c7 * Lambda_5_5_p114 + s7 * Lambda_5_5_p94) + c8 *
      Lambda_5_5_p115;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p142 = Lambda_5_5_p94 * Lambda_5_5_p131 - Lambda_5_5_p63 * Lambda_5_5_p130;

  // link 6 (link3), Jacobian
  const Real Lambda_5_5_p143 = Lambda_5_5_p138 + (0.4318 * Lambda_5_5_p103 + 0.1501 *
      Lambda_5_5_p94);

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p144 = 186.45 - Lambda_5_5_p120 * Lambda_5_5_p101 - Lambda_5_5_p121 *
      Lambda_5_5_p106 - Lambda_5_5_p123 * Lambda_5_5_p118 - Lambda_5_5_p132 * Lambda_5_5_p125;
  const Real Lambda_5_5_p145 = Lambda_5_5_p128 - Lambda_5_5_p48 * Lambda_5_5_p119 + Lambda_5_5_p53 *
      Lambda_5_5_p133 - Lambda_5_5_p63 * Lambda_5_5_p139;
  const Real Lambda_5_5_p146 = 1.0 - Lambda_5_5_p67 * Lambda_5_5_p124 - Lambda_5_5_p74 *
      Lambda_5_5_p119 - Lambda_5_5_p81 * Lambda_5_5_p133 - Lambda_5_5_p85 * Lambda_5_5_p139;
  const Real Lambda_5_5_p147 = Lambda_5_5_p115 - Lambda_5_5_p6 * Lambda_5_5_p141;
  const Real Lambda_5_5_p148 = Lambda_5_5_p94 - Lambda_5_5_p24 * Lambda_5_5_p141;

  // link 7 (link4), pose
  const Real Lambda_5_5_p149 = s7 * Lambda_5_5_p107 + c7 * Lambda_5_5_p93;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p150 = Lambda_5_5_p143 + Lambda_5_5_p85 * Lambda_5_5_p130 + Lambda_5_5_p96 *
      Lambda_5_5_p142;
  const Real Lambda_5_5_p151 = Lambda_5_5_p140 * Lambda_5_5_p137;

  // link 8 (link5), pose
  const Real Lambda_5_5_p152 = s8 * (c7 * Lambda_5_5_p107 - s7 * Lambda_5_5_p93) + c8 *
      Lambda_5_5_p113;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p153 = Lambda_5_5_p146 - Lambda_5_5_p96 * Lambda_5_5_p145;
  const Real Lambda_5_5_p154 = Lambda_5_5_p148 - Lambda_5_5_p33 * Lambda_5_5_p135 + Lambda_5_5_p44 *
      Lambda_5_5_p147;
  const Real Lambda_5_5_p155 = Lambda_5_5_p113 - Lambda_5_5_p6 * Lambda_5_5_p152;
  const Real Lambda_5_5_p156 = Lambda_5_5_p93 + Lambda_5_5_p24 * Lambda_5_5_p152;
  const Real Lambda_5_5_p157 = 24999.999999999996 * Lambda_5_5_p124;
  const Real Lambda_5_5_p158 = Lambda_5_5_p148 - Lambda_5_5_p48 * Lambda_5_5_p135 + Lambda_5_5_p53 *
      Lambda_5_5_p147 - Lambda_5_5_p63 * Lambda_5_5_p154;
  const Real Lambda_5_5_p159 = 1557.24430048586 * Lambda_5_5_p119;
  const Real Lambda_5_5_p160 = Lambda_5_5_p133 * Lambda_5_5_p22;
  const Real Lambda_5_5_p161 = 1.0 / (Lambda_5_5_p144 - Lambda_5_5_p136 * Lambda_5_5_p134 -
      Lambda_5_5_p151 * Lambda_5_5_p140);
  const Real Lambda_5_5_p162 = Lambda_5_5_p139 * Lambda_5_5_p50;
  const Real Lambda_5_5_p163 = Lambda_5_5_p33 * Lambda_5_5_p149 - Lambda_5_5_p156 + Lambda_5_5_p44 *
      Lambda_5_5_p155;
  const Real Lambda_5_5_p164 = Lambda_5_5_p67 * Lambda_5_5_p141 - Lambda_5_5_p74 * Lambda_5_5_p135 -
      Lambda_5_5_p81 * Lambda_5_5_p147 - Lambda_5_5_p85 * Lambda_5_5_p154 - Lambda_5_5_p96 *
      Lambda_5_5_p158;
  const Real Lambda_5_5_p165 = Lambda_5_5_p126 * Lambda_5_5_p150 -
      (Lambda_5_5_p109 * Lambda_5_5_p130 + Lambda_5_5_p116 * Lambda_5_5_p142);
  const Real Lambda_5_5_p166 = Lambda_5_5_p95 * Lambda_5_5_p119 + Lambda_5_5_p102 *
      Lambda_5_5_p133 + Lambda_5_5_p109 * Lambda_5_5_p139 + Lambda_5_5_p116 * Lambda_5_5_p145 +
      Lambda_5_5_p126 * Lambda_5_5_p153;
  const Real Lambda_5_5_p167 = Lambda_5_5_p145 * Lambda_5_5_p80;
  const Real Lambda_5_5_p168 = Lambda_5_5_p48 * Lambda_5_5_p149 - Lambda_5_5_p156 + Lambda_5_5_p53 *
      Lambda_5_5_p155 - Lambda_5_5_p63 * Lambda_5_5_p163;
  const Real Lambda_5_5_p169 = Lambda_5_5_p95 * Lambda_5_5_p135 + Lambda_5_5_p102 *
      Lambda_5_5_p147 + Lambda_5_5_p109 * Lambda_5_5_p154 + Lambda_5_5_p116 * Lambda_5_5_p158 +
      Lambda_5_5_p126 * Lambda_5_5_p164;
  const Real Lambda_5_5_p170 = Lambda_5_5_p120 * Lambda_5_5_p119 + Lambda_5_5_p121 *
      Lambda_5_5_p133 - Lambda_5_5_p123 * Lambda_5_5_p139 - Lambda_5_5_p132 * Lambda_5_5_p145 -
      Lambda_5_5_p136 * Lambda_5_5_p153;
  const Real Lambda_5_5_p171 = 24999.999999999996 * Lambda_5_5_p141;
  const Real Lambda_5_5_p172 = Lambda_5_5_p120 * Lambda_5_5_p135 + Lambda_5_5_p121 *
      Lambda_5_5_p147 - Lambda_5_5_p123 * Lambda_5_5_p154 - Lambda_5_5_p132 * Lambda_5_5_p158 -
      Lambda_5_5_p136 * Lambda_5_5_p164;
  const Real Lambda_5_5_p173 = 1557.24430048586 * Lambda_5_5_p135;
  const Real Lambda_5_5_p174 = Lambda_5_5_p147 * Lambda_5_5_p22;
  const Real Lambda_5_5_p175 = Lambda_5_5_p154 * Lambda_5_5_p50;
  const Real Lambda_5_5_p176 = Lambda_5_5_p153 * Lambda_5_5_p110;
  const Real Lambda_5_5_p177 = Lambda_5_5_p164 * Lambda_5_5_p110;
  const Real Lambda_5_5_p178 = Lambda_5_5_p158 * Lambda_5_5_p80;

  // link 6 (link3), Jacobian
  const Real Lambda_5_5_p179 = Lambda_5_5_p93 * Lambda_5_5_p127;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p180 = Lambda_5_5_p67 * Lambda_5_5_p152 + Lambda_5_5_p74 * Lambda_5_5_p149 -
      Lambda_5_5_p81 * Lambda_5_5_p155 - Lambda_5_5_p85 * Lambda_5_5_p163 - Lambda_5_5_p96 *
      Lambda_5_5_p168;
  const Real Lambda_5_5_p181 = 1.0 - Lambda_5_5_p123 * Lambda_5_5_p130 - Lambda_5_5_p132 *
      Lambda_5_5_p142 + Lambda_5_5_p136 * Lambda_5_5_p150 - Lambda_5_5_p151 * Lambda_5_5_p165;
  const Real Lambda_5_5_p182 = Lambda_5_5_p170 + Lambda_5_5_p151 * Lambda_5_5_p166;
  const Real Lambda_5_5_p183 = Lambda_5_5_p172 + Lambda_5_5_p151 * Lambda_5_5_p169;
  const Real Lambda_5_5_p184 = Lambda_5_5_p166 * Lambda_5_5_p137;
  const Real Lambda_5_5_p185 = Lambda_5_5_p169 * Lambda_5_5_p137;

  // link 7 (link4), pose
  const Real Lambda_5_5_p186 = 0.4331 * Lambda_5_5_p113 - 0.0203 * Lambda_5_5_p107;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p187 = Lambda_5_5_p159 * Lambda_5_5_p135 - Lambda_5_5_p157 *
      Lambda_5_5_p141 + Lambda_5_5_p160 * Lambda_5_5_p147 + Lambda_5_5_p162 * Lambda_5_5_p154 +
      Lambda_5_5_p167 * Lambda_5_5_p158;
  const Real Lambda_5_5_p188 = Lambda_5_5_p157 * Lambda_5_5_p124 + Lambda_5_5_p159 *
      Lambda_5_5_p119 + Lambda_5_5_p160 * Lambda_5_5_p133 + Lambda_5_5_p162 * Lambda_5_5_p139 +
      Lambda_5_5_p167 * Lambda_5_5_p145;
  const Real Lambda_5_5_p189 = Lambda_5_5_p95 * Lambda_5_5_p149 - Lambda_5_5_p102 *
      Lambda_5_5_p155 - Lambda_5_5_p109 * Lambda_5_5_p163 - Lambda_5_5_p116 * Lambda_5_5_p168 -
      Lambda_5_5_p126 * Lambda_5_5_p180;
  const Real Lambda_5_5_p190 = Lambda_5_5_p121 * Lambda_5_5_p155 - Lambda_5_5_p120 *
      Lambda_5_5_p149 - Lambda_5_5_p123 * Lambda_5_5_p163 - Lambda_5_5_p132 * Lambda_5_5_p168 -
      Lambda_5_5_p136 * Lambda_5_5_p180;
  const Real Lambda_5_5_p191 = Lambda_5_5_p93 * Lambda_5_5_p131 - Lambda_5_5_p63 * Lambda_5_5_p179;

  // link 6 (link3), Jacobian
  const Real Lambda_5_5_p192 = Lambda_5_5_p186 + (0.4318 * Lambda_5_5_p97 - 0.1501 *
      Lambda_5_5_p93);

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p193 = Lambda_5_5_p163 * Lambda_5_5_p50;
  const Real Lambda_5_5_p194 = Lambda_5_5_p190 - Lambda_5_5_p151 * Lambda_5_5_p189;
  const Lanes<8> Lambda_5_5_p195_lanes = detail::make_pack<Real>(Lambda_5_5_p181, Lambda_5_5_p181,
      Lambda_5_5_p181, Lambda_5_5_p194, Lambda_5_5_p183, Lambda_5_5_p182, Lambda_5_5_p181,
      Lambda_5_5_p181) * Lambda_5_5_p161;
  const Real Lambda_5_5_p199 = 0.05625 * Lambda_5_5_p141;
  const Real Lambda_5_5_p200 = 0.05625 * Lambda_5_5_p124;
  const Real Lambda_5_5_p201 = Lambda_5_5_p168 * Lambda_5_5_p80;
  const Real Lambda_5_5_p202 = 24999.999999999996 * Lambda_5_5_p152 * Lambda_5_5_p152 +
      1557.24430048586 * Lambda_5_5_p149 * Lambda_5_5_p149 + Lambda_5_5_p155 * Lambda_5_5_p22 *
      Lambda_5_5_p155;
  const Real Lambda_5_5_p203 = Lambda_5_5_p192 - Lambda_5_5_p85 * Lambda_5_5_p179 - Lambda_5_5_p96 *
      Lambda_5_5_p191;
  const Real Lambda_5_5_p204 = Lambda_5_5_p180 * Lambda_5_5_p110;
  const Lanes<8> Lambda_5_5_p205_lanes = Lambda_5_5_p195_lanes * Lambda_5_5_p181;
  const Real Lambda_5_5_p209 = Lambda_5_5_p171 * Lambda_5_5_p141 + Lambda_5_5_p173 *
      Lambda_5_5_p135 + Lambda_5_5_p174 * Lambda_5_5_p147 + Lambda_5_5_p175 * Lambda_5_5_p154 +
      Lambda_5_5_p178 * Lambda_5_5_p158;
  const Real Lambda_5_5_p210 = Lambda_5_5_p187 + Lambda_5_5_p176 * Lambda_5_5_p164 +
      Lambda_5_5_p184 * Lambda_5_5_p169 + Lambda_5_5_p195_lanes[5] * Lambda_5_5_p183;
  const Real Lambda_5_5_p211 = Lambda_5_5_p188 + Lambda_5_5_p176 * Lambda_5_5_p153 +
      Lambda_5_5_p184 * Lambda_5_5_p166 + Lambda_5_5_p195_lanes[5] * Lambda_5_5_p182;
  const Real Lambda_5_5_p212 = Lambda_5_5_p189 * Lambda_5_5_p137;
  const Real Lambda_5_5_p213 = Lambda_5_5_p162 * Lambda_5_5_p130 + Lambda_5_5_p167 *
      Lambda_5_5_p142 - Lambda_5_5_p176 * Lambda_5_5_p150 - Lambda_5_5_p184 * Lambda_5_5_p165 +
      Lambda_5_5_p205_lanes[5];
  const Real Lambda_5_5_p214 = Lambda_5_5_p160 * Lambda_5_5_p155 -
      (Lambda_5_5_p157 * Lambda_5_5_p152 + Lambda_5_5_p159 * Lambda_5_5_p149) + Lambda_5_5_p162 *
      Lambda_5_5_p163 + Lambda_5_5_p167 * Lambda_5_5_p168;
  const Real Lambda_5_5_p215 = Lambda_5_5_p171 * Lambda_5_5_p152 - Lambda_5_5_p173 *
      Lambda_5_5_p149 + Lambda_5_5_p174 * Lambda_5_5_p155 + Lambda_5_5_p175 * Lambda_5_5_p163 +
      Lambda_5_5_p178 * Lambda_5_5_p168;
  const Real Lambda_5_5_p216 = Lambda_5_5_p175 * Lambda_5_5_p130 + Lambda_5_5_p178 *
      Lambda_5_5_p142 - Lambda_5_5_p177 * Lambda_5_5_p150 - Lambda_5_5_p185 * Lambda_5_5_p165 +
      Lambda_5_5_p205_lanes[4];
  const Real Lambda_5_5_p217 = 1.0 - Lambda_5_5_p109 * Lambda_5_5_p179 - Lambda_5_5_p116 *
      Lambda_5_5_p191 - Lambda_5_5_p126 * Lambda_5_5_p203;
  const Real Lambda_5_5_p218 = Lambda_5_5_p209 + Lambda_5_5_p177 * Lambda_5_5_p164 +
      Lambda_5_5_p185 * Lambda_5_5_p169 + Lambda_5_5_p195_lanes[4] * Lambda_5_5_p183;
  const Real Lambda_5_5_p219 = Lambda_5_5_p191 * Lambda_5_5_p80;
  const Real Lambda_5_5_p220 = Lambda_5_5_p179 * Lambda_5_5_p50;

  // link 6 (link3), Jacobian
  const Real Lambda_5_5_p221 = Lambda_5_5_p93 * Lambda_5_5_p138 + Lambda_5_5_p94 * Lambda_5_5_p186;

  // link 1 (base_x), mass matrix
  const Real Lambda_5_5_p222 = Lambda_5_5_p213 - (Lambda_5_5_p211 * Lambda_5_5_p199 +
      Lambda_5_5_p210 * Lambda_5_5_p200);
  const Real Lambda_5_5_p226 = Lambda_5_5_p203 * Lambda_5_5_p110;
  const Real Lambda_5_5_p227 = Lambda_5_5_p202 + Lambda_5_5_p193 * Lambda_5_5_p163 +
      Lambda_5_5_p201 * Lambda_5_5_p168 + Lambda_5_5_p204 * Lambda_5_5_p180 + Lambda_5_5_p212 *
      Lambda_5_5_p189;
  const Real Lambda_5_5_p228 = Lambda_5_5_p63 * Lambda_5_5_p221 -
      (Lambda_5_5_p93 * Lambda_5_5_p143 + Lambda_5_5_p94 * Lambda_5_5_p192);
  const Real Lambda_5_5_p229 = Lambda_5_5_p216 - (Lambda_5_5_p210 * Lambda_5_5_p199 +
      Lambda_5_5_p218 * Lambda_5_5_p200);
  const Real Lambda_5_5_p230 = Lambda_5_5_p130 * Lambda_5_5_p50 * Lambda_5_5_p130 +
      Lambda_5_5_p142 * Lambda_5_5_p80 * Lambda_5_5_p142 + Lambda_5_5_p150 * Lambda_5_5_p110 *
      Lambda_5_5_p150;
  const Real Lambda_5_5_p231 = Lambda_5_5_p123 * Lambda_5_5_p179 + Lambda_5_5_p132 *
      Lambda_5_5_p191 + Lambda_5_5_p136 * Lambda_5_5_p203 + Lambda_5_5_p151 * Lambda_5_5_p217;
  const Real Lambda_5_5_p232 = Lambda_5_5_p217 * Lambda_5_5_p137;
  const Lanes<8> Lambda_5_5_p233_lanes = detail::make_pack<Real>(Lambda_5_5_p227, Lambda_5_5_p227,
      Lambda_5_5_p227, Lambda_5_5_p227, Lambda_5_5_p215 + Lambda_5_5_p177 * Lambda_5_5_p180 -
      Lambda_5_5_p185 * Lambda_5_5_p189, Lambda_5_5_p214 + Lambda_5_5_p176 * Lambda_5_5_p180 -
      Lambda_5_5_p184 * Lambda_5_5_p189, Lambda_5_5_p227, Lambda_5_5_p227) + Lambda_5_5_p195_lanes *
      Lambda_5_5_p194;
  const Real Lambda_5_5_p236 = Lambda_5_5_p85 * Lambda_5_5_p221 - Lambda_5_5_p96 * Lambda_5_5_p228;
  const Real Lambda_5_5_p237 = Lambda_5_5_p231 * Lambda_5_5_p161;
  const Real Lambda_5_5_p238 = Lambda_5_5_p233_lanes[5] * Lambda_5_5_p199;
  const Real Lambda_5_5_p239 = Lambda_5_5_p233_lanes[4] * Lambda_5_5_p200;
  const Real Lambda_5_5_p240 = 0.05625 * Lambda_5_5_p152;
  const Real Lambda_5_5_p241 = Lambda_5_5_p228 * Lambda_5_5_p80;
  const Real Lambda_5_5_p242 = Lambda_5_5_p221 * Lambda_5_5_p50;
  const Real Lambda_5_5_p243 = Lambda_5_5_p109 * Lambda_5_5_p221 - Lambda_5_5_p116 *
      Lambda_5_5_p228 - Lambda_5_5_p126 * Lambda_5_5_p236;
  const Real Lambda_5_5_p244 = Lambda_5_5_p162 * Lambda_5_5_p179 + Lambda_5_5_p167 *
      Lambda_5_5_p191 + Lambda_5_5_p176 * Lambda_5_5_p203 - Lambda_5_5_p184 * Lambda_5_5_p217 -
      Lambda_5_5_p195_lanes[5] * Lambda_5_5_p231;
  const Real Lambda_5_5_p245 = Lambda_5_5_p193 * Lambda_5_5_p130 + Lambda_5_5_p201 *
      Lambda_5_5_p142 - Lambda_5_5_p204 * Lambda_5_5_p150 + Lambda_5_5_p212 * Lambda_5_5_p165 +
      Lambda_5_5_p205_lanes[3];
  const Real Lambda_5_5_p246 = Lambda_5_5_p230 + Lambda_5_5_p165 * Lambda_5_5_p137 *
      Lambda_5_5_p165 + Lambda_5_5_p205_lanes[0] - (Lambda_5_5_p199 *
      (Lambda_5_5_p213 + Lambda_5_5_p222) + Lambda_5_5_p200 * (Lambda_5_5_p216 + Lambda_5_5_p229));
  const Real Lambda_5_5_p247 = Lambda_5_5_p236 * Lambda_5_5_p110;
  const Real Lambda_5_5_p248 = Lambda_5_5_p245 - (Lambda_5_5_p238 + Lambda_5_5_p239);
  const Real Lambda_5_5_p249 = Lambda_5_5_p175 * Lambda_5_5_p179 + Lambda_5_5_p178 *
      Lambda_5_5_p191 + Lambda_5_5_p177 * Lambda_5_5_p203 - Lambda_5_5_p185 * Lambda_5_5_p217 -
      Lambda_5_5_p195_lanes[4] * Lambda_5_5_p231;
  const Real Lambda_5_5_p250 = 1.0 / Lambda_5_5_p246;
  const Real Lambda_5_5_p251 = Lambda_5_5_p243 * Lambda_5_5_p137;
  const Real Lambda_5_5_p252 = Lambda_5_5_p123 * Lambda_5_5_p221 - Lambda_5_5_p132 *
      Lambda_5_5_p228 - Lambda_5_5_p136 * Lambda_5_5_p236 - Lambda_5_5_p151 * Lambda_5_5_p243;
  const Real Lambda_5_5_p253 = Lambda_5_5_p220 * Lambda_5_5_p130 + Lambda_5_5_p219 *
      Lambda_5_5_p142 - Lambda_5_5_p226 * Lambda_5_5_p150 + Lambda_5_5_p232 * Lambda_5_5_p165 -
      Lambda_5_5_p237 * Lambda_5_5_p181;
  const Real Lambda_5_5_p254 = Lambda_5_5_p193 * Lambda_5_5_p179 + Lambda_5_5_p201 *
      Lambda_5_5_p191 + Lambda_5_5_p204 * Lambda_5_5_p203 + Lambda_5_5_p212 * Lambda_5_5_p217 -
      Lambda_5_5_p195_lanes[3] * Lambda_5_5_p231;
  const Real Lambda_5_5_p255 = Lambda_5_5_p252 * Lambda_5_5_p161;
  const Real Lambda_5_5_p256 = Lambda_5_5_p254 + (Lambda_5_5_p233_lanes[3] * Lambda_5_5_p200 +
      Lambda_5_5_p233_lanes[5] * Lambda_5_5_p240);
  const Real Lambda_5_5_p257 = Lambda_5_5_p244 + (Lambda_5_5_p233_lanes[5] * Lambda_5_5_p200 +
      Lambda_5_5_p211 * Lambda_5_5_p240);
  const Real Lambda_5_5_p258 = Lambda_5_5_p178 * Lambda_5_5_p228 - Lambda_5_5_p175 *
      Lambda_5_5_p221 + Lambda_5_5_p177 * Lambda_5_5_p236 - Lambda_5_5_p185 * Lambda_5_5_p243 +
      Lambda_5_5_p195_lanes[4] * Lambda_5_5_p252;
  const Real Lambda_5_5_p259 = Lambda_5_5_p253 - Lambda_5_5_p199 * Lambda_5_5_p244 +
      Lambda_5_5_p240 * Lambda_5_5_p222 + (Lambda_5_5_p248 - Lambda_5_5_p249) * Lambda_5_5_p200;
  const Real Lambda_5_5_p260 = Lambda_5_5_p167 * Lambda_5_5_p228 - Lambda_5_5_p162 *
      Lambda_5_5_p221 + Lambda_5_5_p176 * Lambda_5_5_p236 - Lambda_5_5_p184 * Lambda_5_5_p243 +
      Lambda_5_5_p195_lanes[5] * Lambda_5_5_p252;
  const Real Lambda_5_5_p261 = Lambda_5_5_p241 * Lambda_5_5_p142 - Lambda_5_5_p242 *
      Lambda_5_5_p130 - Lambda_5_5_p247 * Lambda_5_5_p150 + Lambda_5_5_p251 * Lambda_5_5_p165 +
      Lambda_5_5_p255 * Lambda_5_5_p181;
  const Real Lambda_5_5_p262 = Lambda_5_5_p259 * Lambda_5_5_p250;
  const Real Lambda_5_5_p263 = Lambda_5_5_p210 * Lambda_5_5_p240;
  const Real Lambda_5_5_p264 = Lambda_5_5_p220 * Lambda_5_5_p179 + Lambda_5_5_p219 *
      Lambda_5_5_p191 + Lambda_5_5_p226 * Lambda_5_5_p203 + Lambda_5_5_p232 * Lambda_5_5_p217 +
      Lambda_5_5_p237 * Lambda_5_5_p231;
  const Real Lambda_5_5_p265 = Lambda_5_5_p222 * Lambda_5_5_p250;
  const Real Lambda_5_5_p266 = Lambda_5_5_p229 * Lambda_5_5_p250;
  const Real Lambda_5_5_p267 = Lambda_5_5_p248 * Lambda_5_5_p250;
  const Real Lambda_5_5_p268 = Lambda_5_5_p261 - Lambda_5_5_p200 * Lambda_5_5_p258 -
      Lambda_5_5_p240 * Lambda_5_5_p229 + (Lambda_5_5_p248 - Lambda_5_5_p260) * Lambda_5_5_p199;
  const Real Lambda_5_5_p269 = Lambda_5_5_p264 + (Lambda_5_5_p200 *
      (Lambda_5_5_p254 + Lambda_5_5_p256) + Lambda_5_5_p240 * (Lambda_5_5_p244 + Lambda_5_5_p257)) -
      Lambda_5_5_p262 * Lambda_5_5_p259;
  const Real Lambda_5_5_p270 = Lambda_5_5_p249 + (Lambda_5_5_p239 + Lambda_5_5_p263);
  const Real Lambda_5_5_p271 = Lambda_5_5_p201 * Lambda_5_5_p228 - Lambda_5_5_p193 *
      Lambda_5_5_p221 + Lambda_5_5_p204 * Lambda_5_5_p236 + Lambda_5_5_p212 * Lambda_5_5_p243 +
      Lambda_5_5_p195_lanes[3] * Lambda_5_5_p252;
  const Real Lambda_5_5_p272 = Lambda_5_5_p241 * Lambda_5_5_p191 - Lambda_5_5_p242 *
      Lambda_5_5_p179 + Lambda_5_5_p247 * Lambda_5_5_p203 + Lambda_5_5_p251 * Lambda_5_5_p217 -
      Lambda_5_5_p255 * Lambda_5_5_p231;
  const Real Lambda_5_5_p273 = Lambda_5_5_p258 - (Lambda_5_5_p218 * Lambda_5_5_p240 -
      Lambda_5_5_p233_lanes[4] * Lambda_5_5_p199);
  const Real Lambda_5_5_p274 = Lambda_5_5_p268 * Lambda_5_5_p250;
  const Real Lambda_5_5_p275 = 1.0 / Lambda_5_5_p269;
  const Real Lambda_5_5_p276 = Lambda_5_5_p271 - (Lambda_5_5_p233_lanes[4] * Lambda_5_5_p240 -
      Lambda_5_5_p233_lanes[3] * Lambda_5_5_p199);
  const Real Lambda_5_5_p280 = Lambda_5_5_p257 - Lambda_5_5_p265 * Lambda_5_5_p259;
  const Real Lambda_5_5_p281 = Lambda_5_5_p270 - Lambda_5_5_p266 * Lambda_5_5_p259;
  const Real Lambda_5_5_p286 = Lambda_5_5_p256 - Lambda_5_5_p267 * Lambda_5_5_p259;
  const Real Lambda_5_5_p290 = Lambda_5_5_p242 * Lambda_5_5_p221 + Lambda_5_5_p241 *
      Lambda_5_5_p228 + Lambda_5_5_p247 * Lambda_5_5_p236 + Lambda_5_5_p251 * Lambda_5_5_p243 +
      Lambda_5_5_p255 * Lambda_5_5_p252;
  const Real Lambda_5_5_p291 = Lambda_5_5_p272 + Lambda_5_5_p199 * Lambda_5_5_p256 +
      Lambda_5_5_p200 * Lambda_5_5_p271 - Lambda_5_5_p274 * Lambda_5_5_p259 +
      (Lambda_5_5_p260 - Lambda_5_5_p270) * Lambda_5_5_p240;
  const Real Lambda_5_5_p292 = Lambda_5_5_p280 * Lambda_5_5_p275;
  const Real Lambda_5_5_p293 = Lambda_5_5_p281 * Lambda_5_5_p275;
  const Real Lambda_5_5_p294 = Lambda_5_5_p286 * Lambda_5_5_p275;
  const Real Lambda_0_0_p1 = Lambda_5_5_p262 * Lambda_5_5_p275;
  const Real Lambda_5_5_p295 = Lambda_5_5_p291 * Lambda_5_5_p275;
  const Lanes<8> Lambda_5_5_p310_lanes = detail::make_pack<Real>(Lambda_5_5_p290 -
      (Lambda_5_5_p240 * (Lambda_5_5_p258 + Lambda_5_5_p273) - Lambda_5_5_p199 *
      (Lambda_5_5_p271 + Lambda_5_5_p276)), Lambda_5_5_p290 -
      (Lambda_5_5_p240 * (Lambda_5_5_p258 + Lambda_5_5_p273) - Lambda_5_5_p199 *
      (Lambda_5_5_p271 + Lambda_5_5_p276)), Lambda_5_5_p290 -
      (Lambda_5_5_p240 * (Lambda_5_5_p258 + Lambda_5_5_p273) - Lambda_5_5_p199 *
      (Lambda_5_5_p271 + Lambda_5_5_p276)), Lambda_5_5_p276, Lambda_5_5_p273, Lambda_5_5_p260 -
      (Lambda_5_5_p263 - Lambda_5_5_p238), Lambda_5_5_p290 -
      (Lambda_5_5_p240 * (Lambda_5_5_p258 + Lambda_5_5_p273) - Lambda_5_5_p199 *
      (Lambda_5_5_p271 + Lambda_5_5_p276)), Lambda_5_5_p290 -
      (Lambda_5_5_p240 * (Lambda_5_5_p258 + Lambda_5_5_p273) - Lambda_5_5_p199 *
      (Lambda_5_5_p271 + Lambda_5_5_p276))) - detail::make_pack<Real>(Lambda_5_5_p274,
      Lambda_5_5_p274, Lambda_5_5_p274, Lambda_5_5_p267, Lambda_5_5_p266, Lambda_5_5_p265,
      Lambda_5_5_p274, Lambda_5_5_p274) * Lambda_5_5_p268 -
      detail::make_pack<Real>(Lambda_5_5_p295, Lambda_5_5_p295, Lambda_5_5_p295, Lambda_5_5_p294,
      Lambda_5_5_p293, Lambda_5_5_p292, Lambda_5_5_p295, Lambda_5_5_p295) * Lambda_5_5_p291;
  const Real Lambda_0_0_p2 = Lambda_5_5_p295 * Lambda_5_5_p262 - Lambda_5_5_p274;
  const Real Lambda_5_5_p314 = 1.0 / Lambda_5_5_p310_lanes[2];
  const Lanes<8> Lambda_5_5_p315_lanes = Lambda_5_5_p310_lanes * Lambda_5_5_p314;
  const Real Lambda_0_0_p3 = Lambda_0_0_p2 * Lambda_5_5_p314;
  const Real Lambda_0_1_p1 = Lambda_5_5_p295 * Lambda_5_5_p314;
  const Lanes<8> Lambda_5_5_p321_lanes = Lambda_5_5_p233_lanes -
      detail::make_pack<Real>(Lambda_5_5_p267, Lambda_5_5_p267, Lambda_5_5_p267, Lambda_5_5_p267,
      Lambda_5_5_p266, Lambda_5_5_p265, Lambda_5_5_p267, Lambda_5_5_p267) * Lambda_5_5_p248 -
      detail::make_pack<Real>(Lambda_5_5_p294, Lambda_5_5_p294, Lambda_5_5_p294, Lambda_5_5_p294,
      Lambda_5_5_p293, Lambda_5_5_p292, Lambda_5_5_p294, Lambda_5_5_p294) * Lambda_5_5_p286 -
      Lambda_5_5_p315_lanes * Lambda_5_5_p310_lanes[3];
  const Real Lambda_0_0_p4 = Lambda_5_5_p294 * Lambda_5_5_p262 - Lambda_5_5_p267 -
      Lambda_5_5_p315_lanes[3] * Lambda_0_0_p2;
  const Real Lambda_0_1_p2 = Lambda_5_5_p315_lanes[3] * Lambda_5_5_p295 - Lambda_5_5_p294;
  const Real Lambda_5_5_p324 = 1.0 / Lambda_5_5_p321_lanes[3];
  const Real Lambda_5_5_p325 = Lambda_5_5_p321_lanes[4] * Lambda_5_5_p324;
  const Real Lambda_5_5_p326 = Lambda_5_5_p321_lanes[5] * Lambda_5_5_p324;
  const Real Lambda_0_0_p5 = Lambda_0_0_p4 * Lambda_5_5_p324;
  const Real Lambda_0_1_p3 = Lambda_0_1_p2 * Lambda_5_5_p324;
  const Real Lambda_0_2_p1 = Lambda_5_5_p315_lanes[3] * Lambda_5_5_p324;
  const Real Lambda_5_5_p327 = Lambda_5_5_p218 - Lambda_5_5_p266 * Lambda_5_5_p229 -
      Lambda_5_5_p293 * Lambda_5_5_p281 - Lambda_5_5_p315_lanes[4] * Lambda_5_5_p310_lanes[4] -
      Lambda_5_5_p325 * Lambda_5_5_p321_lanes[4];
  const Real Lambda_5_5_p328 = Lambda_5_5_p210 - Lambda_5_5_p265 * Lambda_5_5_p229 -
      Lambda_5_5_p292 * Lambda_5_5_p281 - Lambda_5_5_p315_lanes[5] * Lambda_5_5_p310_lanes[4] -
      Lambda_5_5_p326 * Lambda_5_5_p321_lanes[4];
  const Real Lambda_5_5_p329 = Lambda_5_5_p211 - Lambda_5_5_p265 * Lambda_5_5_p222 -
      Lambda_5_5_p292 * Lambda_5_5_p280 - Lambda_5_5_p315_lanes[5] * Lambda_5_5_p310_lanes[5] -
      Lambda_5_5_p326 * Lambda_5_5_p321_lanes[5];
  const Real Lambda_0_0_p6 = Lambda_5_5_p293 * Lambda_5_5_p262 - Lambda_5_5_p266 -
      Lambda_5_5_p315_lanes[4] * Lambda_0_0_p2 - Lambda_5_5_p325 * Lambda_0_0_p4;
  const Real Lambda_0_1_p4 = Lambda_5_5_p315_lanes[4] * Lambda_5_5_p295 - Lambda_5_5_p293 -
      Lambda_5_5_p325 * Lambda_0_1_p2;
  const Real Lambda_0_2_p2 = Lambda_5_5_p325 * Lambda_5_5_p315_lanes[3] - Lambda_5_5_p315_lanes[4];
  const Real Lambda_5_5_p330 = 1.0 / Lambda_5_5_p327;
  const Real Lambda_5_5_p331 = Lambda_5_5_p328 * Lambda_5_5_p330;
  const Real Lambda_0_0_p7 = Lambda_0_0_p6 * Lambda_5_5_p330;
  const Real Lambda_0_1_p5 = Lambda_0_1_p4 * Lambda_5_5_p330;
  const Real Lambda_0_2_p3 = Lambda_0_2_p2 * Lambda_5_5_p330;
  const Real Lambda_0_3_p1 = Lambda_5_5_p325 * Lambda_5_5_p330;
  const Real Lambda_0_5_p1 = Lambda_5_5_p292 * Lambda_5_5_p262 - Lambda_5_5_p265 -
      Lambda_5_5_p315_lanes[5] * Lambda_0_0_p2 - Lambda_5_5_p326 * Lambda_0_0_p4 - Lambda_5_5_p331 *
      Lambda_0_0_p6;
  const Real Lambda_1_5_p1 = Lambda_5_5_p315_lanes[5] * Lambda_5_5_p295 - Lambda_5_5_p292 -
      Lambda_5_5_p326 * Lambda_0_1_p2 - Lambda_5_5_p331 * Lambda_0_1_p4;
  const Real Lambda_2_5_p1 = Lambda_5_5_p326 * Lambda_5_5_p315_lanes[3] - Lambda_5_5_p315_lanes[5] -
      Lambda_5_5_p331 * Lambda_0_2_p2;
  const Real Lambda_3_5_p1 = Lambda_5_5_p331 * Lambda_5_5_p325 - Lambda_5_5_p326;
  const Real Lambda_0_0_p8 = Lambda_5_5_p250 + Lambda_0_0_p1 * Lambda_5_5_p262 + Lambda_0_0_p3 *
      Lambda_0_0_p2 + Lambda_0_0_p5 * Lambda_0_0_p4 + Lambda_0_0_p7 * Lambda_0_0_p6;
  const Real Lambda_5_5 = 1.0 / (Lambda_5_5_p329 - Lambda_5_5_p331 * Lambda_5_5_p328);
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
  const Real Lambda_4_5 = Lambda_5_5_p331 * Lambda_5_5;
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
  Lambda[7] = Lambda_5_5_p275 + Lambda_0_1_p1 * Lambda_5_5_p295 + Lambda_0_1_p3 * Lambda_0_1_p2 +
      Lambda_0_1_p5 * Lambda_0_1_p4 + Lambda_1_5 * Lambda_1_5_p1;
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
  Lambda[14] = Lambda_5_5_p314 + Lambda_0_2_p1 * Lambda_5_5_p315_lanes[3] + Lambda_0_2_p3 *
      Lambda_0_2_p2 + Lambda_2_5 * Lambda_2_5_p1;
  const Real Lambda_2_3 = Lambda_3_5 * Lambda_2_5_p1 -
      (Lambda_0_2_p1 + Lambda_0_3_p1 * Lambda_0_2_p2);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p3 - Lambda_4_5 * Lambda_2_5_p1;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_5_5_p324 + Lambda_0_3_p1 * Lambda_5_5_p325 + Lambda_3_5 * Lambda_3_5_p1;
  const Real Lambda_3_4 = Lambda_0_3_p1 + Lambda_4_5 * Lambda_3_5_p1;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_5_5_p330 + Lambda_4_5 * Lambda_5_5_p331;
}

}  // namespace samm

#undef TREELINE_RESTRICT
