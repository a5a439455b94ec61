// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J carried inward, in the axes asked for at link origins.
// 812 flops (add 328, mul 474, div 10), sine and cosine of 5 angles
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
  const Real angles[5] = {q[1], q[2], q[0], q[3], q[4]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real c1 = cosines[2];
  const Real s4 = sines[3];
  const Real s5 = sines[4];
  const Real c4 = cosines[3];
  const Real c5 = cosines[4];
  const Real s1 = sines[2];

  // link 5 (link5), composite inertia
  const Real Lambda_5_5_p1 = 0.0028799999999999997 * s5;
  const Real Lambda_5_5_p2 = 0.0028799999999999997 * c5;
  const Real Lambda_5_5_p3 = 0.00020215999999999998 * s5;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p4 = 0.9999999999999999 * c5;

  // link 6 (link6), mass matrix
  const Real Lambda_5_5_p5 = 4e-05 * c5;
  const Real Lambda_5_5_p6 = 4e-05 * s5;
  const Real Lambda_5_5_p7 = 0.4318 * c2;
  const Real Lambda_5_5_p8 = 0.4318 * s2;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p9 = c4 * Lambda_5_5_p1;
  const Real Lambda_5_5_p10 = s2 * s3 - c2 * c3;
  const Real Lambda_5_5_p11 = s4 * Lambda_5_5_p1;
  const Real Lambda_5_5_p12 = s2 * c3 + c2 * s3;

  // link 5 (link5), mass matrix
  const Real Lambda_5_5_p13 = c4 * Lambda_5_5_p2;

  // link 5 (link5), composite inertia
  const Real Lambda_5_5_p14 = s5 * Lambda_5_5_p3;
  const Real Lambda_5_5_p15 = c5 * Lambda_5_5_p3;

  // link 6 (link6), mass matrix
  const Real Lambda_5_5_p16 = s4 * Lambda_5_5_p6;

  // link 5 (link5), composite inertia
  const Real Lambda_5_5_p17 = 0.00164 + Lambda_5_5_p14;

  // link 4 (link4), mass matrix
  const Real Lambda_5_5_p18 = Lambda_5_5_p10 * Lambda_5_5_p11;
  const Real Lambda_5_5_p19 = Lambda_5_5_p12 * Lambda_5_5_p11;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p20 = s4 * Lambda_5_5_p15;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p21 = 24999.999999999996 * Lambda_5_5_p16;
  const Real Lambda_5_5_p22 = 0.0203 * Lambda_5_5_p10 + 0.4331 * Lambda_5_5_p12;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p23 = Lambda_5_5_p10 * Lambda_5_5_p9 - Lambda_5_5_p12 * Lambda_5_5_p2;
  const Real Lambda_5_5_p24 = 0.0203 * Lambda_5_5_p12 - 0.4331 * Lambda_5_5_p10;
  const Real Lambda_5_5_p25 = Lambda_5_5_p12 * Lambda_5_5_p9 + Lambda_5_5_p10 * Lambda_5_5_p2;

  // link 5 (link5), mass matrix
  const Real Lambda_5_5_p26 = Lambda_5_5_p10 * Lambda_5_5_p1 - Lambda_5_5_p12 * Lambda_5_5_p13;
  const Real Lambda_5_5_p27 = Lambda_5_5_p10 * Lambda_5_5_p13 + Lambda_5_5_p12 * Lambda_5_5_p1;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p28 = s4 * (0.00010000000000000026 + Lambda_5_5_p14);
  const Real Lambda_5_5_p29 = Lambda_5_5_p22 * Lambda_5_5_p23;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p30 = 1.0 / (Lambda_5_5_p17 - Lambda_5_5_p4 * Lambda_5_5_p5);

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p31 = s4 * Lambda_5_5_p28;
  const Real Lambda_5_5_p32 = Lambda_5_5_p12 * c4;
  const Real Lambda_5_5_p33 = c4 * Lambda_5_5_p15;

  // link 5 (link5), mass matrix
  const Real Lambda_5_5_p34 = Lambda_5_5_p12 * s4;

  // link 4 (link4), composite inertia
  const Real Lambda_5_5_p35 = 0.025374999999999998 * Lambda_5_5_p12 - 0.861795 * Lambda_5_5_p10 -
      Lambda_5_5_p25;

  // link 5 (link5), mass matrix
  const Real Lambda_5_5_p36 = 0.00064216 * c4 - (Lambda_5_5_p22 * Lambda_5_5_p26 + Lambda_5_5_p24 *
      Lambda_5_5_p27);

  // link 3 (link3), composite inertia
  const Real Lambda_5_5_p37 = Lambda_5_5_p7 * (Lambda_5_5_p23 -
      (0.025374999999999998 * Lambda_5_5_p10 + 0.861795 * Lambda_5_5_p12));

  // link 3 (link3), Jacobian
  const Real Lambda_5_5_p38 = Lambda_5_5_p22 + Lambda_5_5_p7;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p39 = Lambda_5_5_p24 * Lambda_5_5_p18 - Lambda_5_5_p22 * Lambda_5_5_p19 -
      Lambda_5_5_p20 - Lambda_5_5_p4 * Lambda_5_5_p16;
  const Real Lambda_5_5_p40 = 1557.24430048586 * Lambda_5_5_p36;

  // link 5 (link5), mass matrix
  const Real Lambda_5_5_p41 = Lambda_5_5_p36 + (Lambda_5_5_p8 * Lambda_5_5_p27 - Lambda_5_5_p7 *
      Lambda_5_5_p26);

  // link 6 (link6), mass matrix
  const Real Lambda_5_5_p42 = Lambda_5_5_p32 * Lambda_5_5_p6 + Lambda_5_5_p10 * Lambda_5_5_p5;

  // link 3 (link3), composite inertia
  const Real Lambda_5_5_p43 = Lambda_5_5_p37 + Lambda_5_5_p8 * Lambda_5_5_p35;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p44 = Lambda_5_5_p39 * Lambda_5_5_p30;
  const Real Lambda_5_5_p45 = 1557.24430048586 * Lambda_5_5_p41;
  const Real Lambda_5_5_p46 = Lambda_5_5_p39 - Lambda_5_5_p7 * Lambda_5_5_p19 - Lambda_5_5_p8 *
      Lambda_5_5_p18;

  // link 3 (link3), mass matrix
  const Real Lambda_5_5_p47 = Lambda_5_5_p32 * Lambda_5_5_p28 - Lambda_5_5_p24 * Lambda_5_5_p11 +
      (0.004704000000000001 + Lambda_5_5_p20) * Lambda_5_5_p10 - 0.1501 * Lambda_5_5_p35;

  // link 5 (link5), mass matrix
  const Real Lambda_5_5_p48 = 0.00064216 * Lambda_5_5_p34 + 0.1501 * Lambda_5_5_p27 +
      Lambda_5_5_p38 * (s4 * Lambda_5_5_p2);

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p49 = 0.312455249 + (0.00129216 - Lambda_5_5_p31 - 2.0 *
      (Lambda_5_5_p29 + Lambda_5_5_p24 * Lambda_5_5_p25)) - Lambda_5_5_p21 * Lambda_5_5_p16;
  const Real Lambda_5_5_p50 = Lambda_5_5_p46 * Lambda_5_5_p30;

  // link 4 (link4), pose
  const Real Lambda_5_5_p51 = Lambda_5_5_p10 * s1;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p52 = Lambda_5_5_p47 + Lambda_5_5_p21 * Lambda_5_5_p42;
  const Real Lambda_5_5_p53 = Lambda_5_5_p12 * Lambda_5_5_p33 - Lambda_5_5_p10 * Lambda_5_5_p17 -
      0.1501 * Lambda_5_5_p18 + Lambda_5_5_p4 * Lambda_5_5_p42 + Lambda_5_5_p38 * Lambda_5_5_p9;
  const Real Lambda_5_5_p54 = 24999.999999999996 * Lambda_5_5_p42;

  // link 4 (link4), pose
  const Real Lambda_5_5_p55 = Lambda_5_5_p12 * s1;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p56 = 1557.24430048586 * Lambda_5_5_p48;
  const Real Lambda_5_5_p57 = Lambda_5_5_p53 * Lambda_5_5_p30;
  const Real Lambda_5_5_p58 = 1.0 / (Lambda_5_5_p49 - Lambda_5_5_p40 * Lambda_5_5_p36 -
      Lambda_5_5_p44 * Lambda_5_5_p39);
  const Real Lambda_5_5_p59 = Lambda_5_5_p49 - Lambda_5_5_p43 - Lambda_5_5_p40 * Lambda_5_5_p41 -
      Lambda_5_5_p44 * Lambda_5_5_p46;
  const Real Lambda_5_5_p60 = Lambda_5_5_p52 - Lambda_5_5_p40 * Lambda_5_5_p48 - Lambda_5_5_p44 *
      Lambda_5_5_p53;
  const Real Lambda_5_5_p61 = 0.690314699 * s2 + 0.023750999999999998 * c2 + Lambda_5_5_p52 +
      Lambda_5_5_p8 * Lambda_5_5_p11 - Lambda_5_5_p45 * Lambda_5_5_p48;

  // link 5 (link5), pose
  const Real Lambda_5_5_p62 = s5 * Lambda_5_5_p32 + c5 * Lambda_5_5_p10;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p63 = 3.153482265 - s2 * (1.601861202 * s2 + 0.0141984 * c2) +
      Lambda_5_5_p17 - Lambda_5_5_p54 * Lambda_5_5_p42;
  const Real Lambda_5_5_p64 = Lambda_5_5_p21 * Lambda_5_5_p62;

  // link 3 (link3), Jacobian
  const Real Lambda_5_5_p65 = Lambda_5_5_p24 * s1;

  // link 5 (link5), pose
  const Real Lambda_5_5_p66 = s5 * (s4 * c1 - c4 * Lambda_5_5_p51) + c5 * Lambda_5_5_p55;

  // link 4 (link4), pose
  const Real Lambda_5_5_p67 = s4 * Lambda_5_5_p51 + c4 * c1;

  // link 3 (link3), Jacobian
  const Real Lambda_5_5_p68 = Lambda_5_5_p24 - Lambda_5_5_p8;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p69 = Lambda_5_5_p4 * Lambda_5_5_p62 - Lambda_5_5_p10;
  const Real Lambda_5_5_p70 = 24999.999999999996 * Lambda_5_5_p62;
  const Real Lambda_5_5_p71 = 1557.24430048586 * Lambda_5_5_p34;
  const Real Lambda_5_5_p72 = Lambda_5_5_p59 * Lambda_5_5_p58;
  const Real Lambda_5_5_p73 = Lambda_5_5_p60 * Lambda_5_5_p58;
  const Real Lambda_5_5_p74 = 0.298925024 * Lambda_5_5_p12 + 0.021347276999999998 * Lambda_5_5_p10 -
      (Lambda_5_5_p10 * (2.0 * Lambda_5_5_p33) - Lambda_5_5_p12 *
      (0.0011921599999999998 - Lambda_5_5_p14 + Lambda_5_5_p31 - Lambda_5_5_p17));
  const Real Lambda_5_5_p75 = Lambda_5_5_p55 - Lambda_5_5_p4 * Lambda_5_5_p66;
  const Real Lambda_5_5_p76 = c1 - Lambda_5_5_p21 * Lambda_5_5_p66;
  const Real Lambda_5_5_p77 = 24999.999999999996 * Lambda_5_5_p66;
  const Real Lambda_5_5_p78 = 1557.24430048586 * Lambda_5_5_p67;
  const Real Lambda_5_5_p79 = Lambda_5_5_p69 * Lambda_5_5_p30;
  const Real Lambda_5_5_p80 = Lambda_5_5_p64 - Lambda_5_5_p40 * Lambda_5_5_p34 - Lambda_5_5_p44 *
      Lambda_5_5_p69;

  // link 4 (link4), pose
  const Real Lambda_5_5_p84 = Lambda_5_5_p10 * c1;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p85 = Lambda_5_5_p75 * Lambda_5_5_p30;
  const Real Lambda_5_5_p86 = 1.7481140020000001 + Lambda_5_5_p49 - 2.0 * Lambda_5_5_p43 -
      Lambda_5_5_p45 * Lambda_5_5_p41 - Lambda_5_5_p50 * Lambda_5_5_p46 - Lambda_5_5_p72 *
      Lambda_5_5_p59;
  const Real Lambda_5_5_p87 = Lambda_5_5_p61 - Lambda_5_5_p50 * Lambda_5_5_p53 - Lambda_5_5_p72 *
      Lambda_5_5_p60;
  const Real Lambda_5_5_p88 = Lambda_5_5_p76 - Lambda_5_5_p40 * Lambda_5_5_p67 - Lambda_5_5_p44 *
      Lambda_5_5_p75;

  // link 3 (link3), Jacobian
  const Real Lambda_5_5_p92 = Lambda_5_5_p24 * c1;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p93 = 1.0 / Lambda_5_5_p86;
  const Lanes<8> Lambda_5_5_p100_lanes = detail::make_pack<Real>(Lambda_5_5_p65, Lambda_5_5_p65,
      Lambda_5_5_p65, Lambda_5_5_p65, Lambda_5_5_p88, Lambda_5_5_p80, Lambda_5_5_p65,
      Lambda_5_5_p65) * Lambda_5_5_p58;

  // link 4 (link4), pose
  const Real Lambda_5_5_p103 = Lambda_5_5_p12 * c1;

  // link 1 (link1), mass matrix
  const Lanes<8> Lambda_5_5_p104_lanes = detail::make_pack<Real>(Lambda_5_5_p68 * s1,
      Lambda_5_5_p68 * s1, Lambda_5_5_p68 * s1, Lambda_5_5_p68 * s1, Lambda_5_5_p76 -
      Lambda_5_5_p45 * Lambda_5_5_p67 - Lambda_5_5_p50 * Lambda_5_5_p75, Lambda_5_5_p64 -
      Lambda_5_5_p45 * Lambda_5_5_p34 - Lambda_5_5_p50 * Lambda_5_5_p69, Lambda_5_5_p68 * s1,
      Lambda_5_5_p68 * s1) - Lambda_5_5_p72 * detail::make_pack<Real>(Lambda_5_5_p65,
      Lambda_5_5_p65, Lambda_5_5_p65, Lambda_5_5_p65, Lambda_5_5_p88, Lambda_5_5_p80,
      Lambda_5_5_p65, Lambda_5_5_p65);
  const Real Lambda_5_5_p110 = Lambda_5_5_p68 * c1 - Lambda_5_5_p72 * Lambda_5_5_p92;
  const Real Lambda_5_5_p111 = 0.05625 * Lambda_5_5_p66;
  const Real Lambda_5_5_p112 = 0.05625 * Lambda_5_5_p62;

  // link 4 (link4), pose
  const Real Lambda_5_5_p113 = s4 * Lambda_5_5_p84 - c4 * s1;

  // link 5 (link5), pose
  const Real Lambda_5_5_p117 = s5 * (c4 * Lambda_5_5_p84 + s4 * s1) - c5 * Lambda_5_5_p103;

  // link 1 (link1), mass matrix
  const Real Lambda_5_5_p118 = Lambda_5_5_p87 * Lambda_5_5_p93;
  const Lanes<8> Lambda_5_5_p119_lanes = Lambda_5_5_p104_lanes * Lambda_5_5_p93;
  const Real Lambda_5_5_p122 = 0.05625 * Lambda_5_5_p117;
  const Real Lambda_5_5_p126 = Lambda_5_5_p103 + Lambda_5_5_p4 * Lambda_5_5_p117;
  const Real Lambda_5_5_p127 = Lambda_5_5_p21 * Lambda_5_5_p117 - s1;
  const Real Lambda_5_5_p128 = Lambda_5_5_p63 - Lambda_5_5_p56 * Lambda_5_5_p48 - Lambda_5_5_p57 *
      Lambda_5_5_p53 - Lambda_5_5_p73 * Lambda_5_5_p60 - Lambda_5_5_p118 * Lambda_5_5_p87;
  const Lanes<8> Lambda_5_5_p129_lanes = detail::make_pack<Real>(Lambda_5_5_p38 * c1,
      Lambda_5_5_p38 * c1, Lambda_5_5_p38 * c1, Lambda_5_5_p38 * c1, Lambda_5_5_p54 *
      Lambda_5_5_p66 - Lambda_5_5_p56 * Lambda_5_5_p67, 1.0 - Lambda_5_5_p54 * Lambda_5_5_p62 -
      Lambda_5_5_p56 * Lambda_5_5_p34, Lambda_5_5_p38 * c1, Lambda_5_5_p38 * c1) -
      detail::make_pack<Real>(0.1501, 0.1501, 0.1501, 0.1501, Lambda_5_5_p57, Lambda_5_5_p57,
      0.1501, 0.1501) * detail::make_pack<Real>(s1, s1, s1, s1, Lambda_5_5_p75, Lambda_5_5_p69, s1,
      s1) - Lambda_5_5_p73 * detail::make_pack<Real>(Lambda_5_5_p65, Lambda_5_5_p65, Lambda_5_5_p65,
      Lambda_5_5_p65, Lambda_5_5_p88, Lambda_5_5_p80, Lambda_5_5_p65, Lambda_5_5_p65) -
      Lambda_5_5_p118 * Lambda_5_5_p104_lanes;
  const Real Lambda_5_5_p132 = Lambda_5_5_p70 * Lambda_5_5_p62 + Lambda_5_5_p71 * Lambda_5_5_p34 +
      Lambda_5_5_p79 * Lambda_5_5_p69 + Lambda_5_5_p100_lanes[5] * Lambda_5_5_p80 +
      Lambda_5_5_p119_lanes[5] * Lambda_5_5_p104_lanes[5];
  const Real Lambda_5_5_p133 = Lambda_5_5_p71 * Lambda_5_5_p67 - Lambda_5_5_p70 * Lambda_5_5_p66 +
      Lambda_5_5_p79 * Lambda_5_5_p75 + Lambda_5_5_p100_lanes[5] * Lambda_5_5_p88 +
      Lambda_5_5_p119_lanes[5] * Lambda_5_5_p104_lanes[4];
  const Real Lambda_5_5_p134 = Lambda_5_5_p77 * Lambda_5_5_p66 + Lambda_5_5_p78 * Lambda_5_5_p67 +
      Lambda_5_5_p85 * Lambda_5_5_p75 + Lambda_5_5_p100_lanes[4] * Lambda_5_5_p88 +
      Lambda_5_5_p119_lanes[4] * Lambda_5_5_p104_lanes[4];
  const Real Lambda_5_5_p135 = Lambda_5_5_p38 * s1 + 0.1501 * c1 + Lambda_5_5_p73 * Lambda_5_5_p92 +
      Lambda_5_5_p118 * Lambda_5_5_p110;
  const Real Lambda_5_5_p139 = Lambda_5_5_p127 - Lambda_5_5_p40 * Lambda_5_5_p113 - Lambda_5_5_p44 *
      Lambda_5_5_p126;
  const Real Lambda_5_5_p140 = Lambda_5_5_p22 * Lambda_5_5_p58;
  const Real Lambda_5_5_p141 = 1.0 / (Lambda_5_5_p128 + 2.0 *
      (0.1501 * Lambda_5_5_p11 - Lambda_5_5_p37 - Lambda_5_5_p29) + Lambda_5_5_p74 *
      Lambda_5_5_p12);
  const Real Lambda_5_5_p142 = Lambda_5_5_p139 * Lambda_5_5_p58;
  const Real Lambda_5_5_p146 = Lambda_5_5_p72 * Lambda_5_5_p22 - Lambda_5_5_p38;
  const Real Lambda_5_5_p147 = 24999.999999999996 * Lambda_5_5_p117 * Lambda_5_5_p117 +
      1557.24430048586 * Lambda_5_5_p113 * Lambda_5_5_p113 + Lambda_5_5_p126 * Lambda_5_5_p30 *
      Lambda_5_5_p126;
  const Real Lambda_5_5_p148 = Lambda_5_5_p127 - Lambda_5_5_p45 * Lambda_5_5_p113 - Lambda_5_5_p50 *
      Lambda_5_5_p126 - Lambda_5_5_p72 * Lambda_5_5_p139;
  const Real Lambda_5_5_p149 = Lambda_5_5_p146 * Lambda_5_5_p93;
  const Real Lambda_5_5_p150 = Lambda_5_5_p148 * Lambda_5_5_p93;
  const Real Lambda_5_5_p151 = Lambda_5_5_p73 * Lambda_5_5_p22 - Lambda_5_5_p118 * Lambda_5_5_p146;
  const Real Lambda_5_5_p152 = Lambda_5_5_p54 * Lambda_5_5_p117 + Lambda_5_5_p56 * Lambda_5_5_p113 +
      Lambda_5_5_p57 * Lambda_5_5_p126 + Lambda_5_5_p73 * Lambda_5_5_p139 + Lambda_5_5_p118 *
      Lambda_5_5_p148;
  const Real Lambda_5_5_p153 = Lambda_5_5_p70 * Lambda_5_5_p117 + Lambda_5_5_p71 * Lambda_5_5_p113 +
      Lambda_5_5_p79 * Lambda_5_5_p126 + Lambda_5_5_p100_lanes[5] * Lambda_5_5_p139 +
      Lambda_5_5_p119_lanes[5] * Lambda_5_5_p148;
  const Real Lambda_5_5_p154 = Lambda_5_5_p78 * Lambda_5_5_p113 - Lambda_5_5_p77 * Lambda_5_5_p117 +
      Lambda_5_5_p85 * Lambda_5_5_p126 + Lambda_5_5_p100_lanes[4] * Lambda_5_5_p139 +
      Lambda_5_5_p119_lanes[4] * Lambda_5_5_p148;
  const Lanes<8> Lambda_5_5_p155_lanes = Lambda_5_5_p129_lanes * Lambda_5_5_p141;
  const Real Lambda_5_5_p158 = Lambda_5_5_p151 * Lambda_5_5_p141;
  const Real Lambda_5_5_p159 = Lambda_5_5_p152 * Lambda_5_5_p141;
  const Real Lambda_5_5_p163 = Lambda_5_5_p132 + Lambda_5_5_p155_lanes[5] *
      Lambda_5_5_p129_lanes[5];
  const Real Lambda_5_5_p164 = Lambda_5_5_p133 + Lambda_5_5_p155_lanes[5] *
      Lambda_5_5_p129_lanes[4];
  const Real Lambda_5_5_p165 = Lambda_5_5_p134 + Lambda_5_5_p155_lanes[4] *
      Lambda_5_5_p129_lanes[4];
  const Real Lambda_5_5_p166 = Lambda_5_5_p100_lanes[5] * Lambda_5_5_p92 +
      Lambda_5_5_p119_lanes[5] * Lambda_5_5_p110 - Lambda_5_5_p155_lanes[5] * Lambda_5_5_p135;
  const Real Lambda_5_5_p167 = Lambda_5_5_p100_lanes[4] * Lambda_5_5_p92 +
      Lambda_5_5_p119_lanes[4] * Lambda_5_5_p110 - Lambda_5_5_p155_lanes[4] * Lambda_5_5_p135;
  const Real Lambda_5_5_p168 = Lambda_5_5_p92 * Lambda_5_5_p58 * Lambda_5_5_p92 + Lambda_5_5_p110 *
      Lambda_5_5_p93 * Lambda_5_5_p110 + Lambda_5_5_p135 * Lambda_5_5_p141 * Lambda_5_5_p135;
  const Real Lambda_5_5_p169 = Lambda_5_5_p153 - Lambda_5_5_p155_lanes[5] * Lambda_5_5_p152;
  const Real Lambda_5_5_p170 = Lambda_5_5_p154 - Lambda_5_5_p155_lanes[4] * Lambda_5_5_p152;
  const Real Lambda_5_5_p171 = Lambda_5_5_p147 + Lambda_5_5_p142 * Lambda_5_5_p139 +
      Lambda_5_5_p150 * Lambda_5_5_p148 + Lambda_5_5_p159 * Lambda_5_5_p152;
  const Lanes<8> Lambda_5_5_p172_lanes = Lambda_5_5_p100_lanes * Lambda_5_5_p65 +
      Lambda_5_5_p119_lanes * Lambda_5_5_p104_lanes[1] + Lambda_5_5_p155_lanes *
      Lambda_5_5_p129_lanes[1];
  const Real Lambda_5_5_p175 = Lambda_5_5_p169 * Lambda_5_5_p111;
  const Real Lambda_5_5_p176 = Lambda_5_5_p170 * Lambda_5_5_p112;
  const Real Lambda_5_5_p177 = Lambda_5_5_p142 * Lambda_5_5_p65 + Lambda_5_5_p150 *
      Lambda_5_5_p104_lanes[1] - Lambda_5_5_p159 * Lambda_5_5_p129_lanes[1];
  const Real Lambda_5_5_p178 = Lambda_5_5_p119_lanes[4] * Lambda_5_5_p146 -
      Lambda_5_5_p100_lanes[4] * Lambda_5_5_p22 + Lambda_5_5_p155_lanes[4] * Lambda_5_5_p151;
  const Real Lambda_5_5_p179 = Lambda_5_5_p119_lanes[5] * Lambda_5_5_p146 -
      Lambda_5_5_p100_lanes[5] * Lambda_5_5_p22 + Lambda_5_5_p155_lanes[5] * Lambda_5_5_p151;
  const Real Lambda_5_5_p180 = Lambda_5_5_p164 * Lambda_5_5_p122;
  const Real Lambda_5_5_p181 = Lambda_5_5_p166 - (Lambda_5_5_p163 * Lambda_5_5_p111 +
      Lambda_5_5_p164 * Lambda_5_5_p112);
  const Real Lambda_5_5_p182 = Lambda_5_5_p167 - (Lambda_5_5_p164 * Lambda_5_5_p111 +
      Lambda_5_5_p165 * Lambda_5_5_p112);
  const Real Lambda_5_5_p183 = Lambda_5_5_p150 * Lambda_5_5_p146 - Lambda_5_5_p142 *
      Lambda_5_5_p22 - Lambda_5_5_p159 * Lambda_5_5_p151;
  const Real Lambda_5_5_p184 = Lambda_5_5_p142 * Lambda_5_5_p92 + Lambda_5_5_p150 *
      Lambda_5_5_p110 + Lambda_5_5_p159 * Lambda_5_5_p135 - (Lambda_5_5_p175 + Lambda_5_5_p176);
  const Real Lambda_5_5_p185 = Lambda_5_5_p172_lanes[5] -
      (Lambda_5_5_p163 * Lambda_5_5_p122 - Lambda_5_5_p169 * Lambda_5_5_p112);
  const Real Lambda_5_5_p186 = Lambda_5_5_p177 - (Lambda_5_5_p169 * Lambda_5_5_p122 -
      Lambda_5_5_p171 * Lambda_5_5_p112);
  const Real Lambda_5_5_p187 = Lambda_5_5_p172_lanes[4] - (Lambda_5_5_p180 - Lambda_5_5_p176);
  const Real Lambda_5_5_p188 = Lambda_5_5_p178 + (Lambda_5_5_p165 * Lambda_5_5_p122 +
      Lambda_5_5_p170 * Lambda_5_5_p111);
  const Real Lambda_5_5_p189 = Lambda_5_5_p100_lanes[1] * Lambda_5_5_p92 +
      Lambda_5_5_p119_lanes[1] * Lambda_5_5_p110 - Lambda_5_5_p155_lanes[1] * Lambda_5_5_p135 -
      Lambda_5_5_p111 * Lambda_5_5_p172_lanes[5] - Lambda_5_5_p122 * Lambda_5_5_p181;
  const Real Lambda_5_5_p190 = Lambda_5_5_p149 * Lambda_5_5_p110 - Lambda_5_5_p140 *
      Lambda_5_5_p92 - Lambda_5_5_p158 * Lambda_5_5_p135 - Lambda_5_5_p112 * Lambda_5_5_p178 +
      Lambda_5_5_p122 * Lambda_5_5_p182;
  const Real Lambda_5_5_p191 = Lambda_5_5_p183 + (Lambda_5_5_p170 * Lambda_5_5_p122 +
      Lambda_5_5_p171 * Lambda_5_5_p111);
  const Real Lambda_5_5_p192 = Lambda_5_5_p189 + (Lambda_5_5_p184 - Lambda_5_5_p172_lanes[4]) *
      Lambda_5_5_p112;
  const Real Lambda_5_5_p193 = Lambda_5_5_p190 + (Lambda_5_5_p184 - Lambda_5_5_p179) *
      Lambda_5_5_p111;
  const Real Lambda_5_5_p194 = Lambda_5_5_p149 * Lambda_5_5_p104_lanes[1] - Lambda_5_5_p140 *
      Lambda_5_5_p65 + Lambda_5_5_p158 * Lambda_5_5_p129_lanes[1] + Lambda_5_5_p112 *
      Lambda_5_5_p183 + Lambda_5_5_p111 * Lambda_5_5_p186;
  const Real Lambda_5_5_p195 = Lambda_5_5_p168 - (Lambda_5_5_p111 *
      (Lambda_5_5_p166 + Lambda_5_5_p181) + Lambda_5_5_p112 * (Lambda_5_5_p167 + Lambda_5_5_p182));
  const Real Lambda_5_5_p196 = Lambda_5_5_p195 * Lambda_5_5_p195;
  const Real Lambda_5_5_p197 = Lambda_5_5_p196 * Lambda_5_5_p195;
  const Real Lambda_5_5_p198 = Lambda_5_5_p140 * Lambda_5_5_p22 + Lambda_5_5_p149 *
      Lambda_5_5_p146 + Lambda_5_5_p158 * Lambda_5_5_p151 +
      (Lambda_5_5_p122 * (Lambda_5_5_p178 + Lambda_5_5_p188) + Lambda_5_5_p111 *
      (Lambda_5_5_p183 + Lambda_5_5_p191));
  const Real Lambda_5_5_p199 = Lambda_5_5_p197 * Lambda_5_5_p196 /
      (1.262177448353619e-29 + Lambda_5_5_p197 * Lambda_5_5_p197);
  const Real Lambda_5_5_p200 = Lambda_5_5_p192 * Lambda_5_5_p199;
  const Real Lambda_5_5_p201 = Lambda_5_5_p193 * Lambda_5_5_p199;
  const Real Lambda_5_5_p202 = Lambda_5_5_p181 * Lambda_5_5_p199;
  const Real Lambda_5_5_p203 = Lambda_5_5_p182 * Lambda_5_5_p199;
  const Real Lambda_5_5_p204 = Lambda_5_5_p184 * Lambda_5_5_p199;
  const Real Lambda_5_5_p212 = Lambda_5_5_p172_lanes[1] -
      (Lambda_5_5_p122 * (Lambda_5_5_p172_lanes[5] + Lambda_5_5_p185) - Lambda_5_5_p112 *
      (Lambda_5_5_p177 + Lambda_5_5_p186)) - Lambda_5_5_p200 * Lambda_5_5_p192;
  const Real Lambda_5_5_p213 = Lambda_5_5_p185 - Lambda_5_5_p202 * Lambda_5_5_p192;
  const Real Lambda_5_5_p214 = Lambda_5_5_p187 - Lambda_5_5_p203 * Lambda_5_5_p192;
  const Real Lambda_5_5_p215 = Lambda_5_5_p186 - Lambda_5_5_p204 * Lambda_5_5_p192;
  const Real Lambda_5_5_p223 = Lambda_5_5_p212 * Lambda_5_5_p212;
  const Real Lambda_5_5_p224 = Lambda_5_5_p194 - Lambda_5_5_p201 * Lambda_5_5_p192 +
      (Lambda_5_5_p187 - Lambda_5_5_p179) * Lambda_5_5_p122;
  const Real Lambda_5_5_p225 = Lambda_5_5_p223 * Lambda_5_5_p212;
  const Real Lambda_5_5_p226 = Lambda_5_5_p225 * Lambda_5_5_p223 /
      (1.9721522630525295e-31 + Lambda_5_5_p225 * Lambda_5_5_p225);
  const Real Lambda_5_5_p227 = Lambda_5_5_p213 * Lambda_5_5_p226;
  const Real Lambda_5_5_p228 = Lambda_5_5_p214 * Lambda_5_5_p226;
  const Real Lambda_5_5_p229 = Lambda_5_5_p215 * Lambda_5_5_p226;
  const Real Lambda_5_5_p230 = Lambda_5_5_p224 * Lambda_5_5_p226;
  const Real Lambda_0_0_p1 = Lambda_5_5_p200 * Lambda_5_5_p226;
  const Lanes<8> Lambda_5_5_p238_lanes = detail::make_pack<Real>(Lambda_5_5_p198, Lambda_5_5_p198,
      Lambda_5_5_p198, Lambda_5_5_p191, Lambda_5_5_p188, Lambda_5_5_p179 +
      (Lambda_5_5_p180 + Lambda_5_5_p175), Lambda_5_5_p198, Lambda_5_5_p198) -
      detail::make_pack<Real>(Lambda_5_5_p201, Lambda_5_5_p201, Lambda_5_5_p201, Lambda_5_5_p204,
      Lambda_5_5_p203, Lambda_5_5_p202, Lambda_5_5_p201, Lambda_5_5_p201) * Lambda_5_5_p193 -
      detail::make_pack<Real>(Lambda_5_5_p230, Lambda_5_5_p230, Lambda_5_5_p230, Lambda_5_5_p229,
      Lambda_5_5_p228, Lambda_5_5_p227, Lambda_5_5_p230, Lambda_5_5_p230) * Lambda_5_5_p224;
  const Real Lambda_0_0_p2 = Lambda_5_5_p230 * Lambda_5_5_p200 - Lambda_5_5_p201;
  const Real Lambda_5_5_p245 = Lambda_5_5_p238_lanes[2] * Lambda_5_5_p238_lanes[2];
  const Real Lambda_5_5_p246 = Lambda_5_5_p245 * Lambda_5_5_p238_lanes[2];
  const Real Lambda_5_5_p247 = Lambda_5_5_p246 * Lambda_5_5_p245 /
      (1.262177448353619e-29 + Lambda_5_5_p246 * Lambda_5_5_p246);
  const Lanes<8> Lambda_5_5_p248_lanes = Lambda_5_5_p238_lanes * Lambda_5_5_p247;
  const Real Lambda_0_0_p3 = Lambda_0_0_p2 * Lambda_5_5_p247;
  const Real Lambda_0_1_p1 = Lambda_5_5_p230 * Lambda_5_5_p247;
  const Lanes<8> Lambda_5_5_p254_lanes = detail::make_pack<Real>(Lambda_5_5_p171, Lambda_5_5_p171,
      Lambda_5_5_p171, Lambda_5_5_p171, Lambda_5_5_p170, Lambda_5_5_p169, Lambda_5_5_p171,
      Lambda_5_5_p171) - detail::make_pack<Real>(Lambda_5_5_p204, Lambda_5_5_p204, Lambda_5_5_p204,
      Lambda_5_5_p204, Lambda_5_5_p203, Lambda_5_5_p202, Lambda_5_5_p204, Lambda_5_5_p204) *
      Lambda_5_5_p184 - detail::make_pack<Real>(Lambda_5_5_p229, Lambda_5_5_p229, Lambda_5_5_p229,
      Lambda_5_5_p229, Lambda_5_5_p228, Lambda_5_5_p227, Lambda_5_5_p229, Lambda_5_5_p229) *
      Lambda_5_5_p215 - Lambda_5_5_p248_lanes * Lambda_5_5_p238_lanes[3];
  const Real Lambda_0_0_p4 = Lambda_5_5_p229 * Lambda_5_5_p200 - Lambda_5_5_p204 -
      Lambda_5_5_p248_lanes[3] * Lambda_0_0_p2;
  const Real Lambda_0_1_p2 = Lambda_5_5_p248_lanes[3] * Lambda_5_5_p230 - Lambda_5_5_p229;
  const Real Lambda_5_5_p257 = Lambda_5_5_p254_lanes[3] * Lambda_5_5_p254_lanes[3];
  const Real Lambda_5_5_p258 = Lambda_5_5_p257 * Lambda_5_5_p254_lanes[3];
  const Real Lambda_5_5_p259 = Lambda_5_5_p258 * Lambda_5_5_p257 /
      (9.313225746154785e-10 + Lambda_5_5_p258 * Lambda_5_5_p258);
  const Real Lambda_5_5_p260 = Lambda_5_5_p254_lanes[4] * Lambda_5_5_p259;
  const Real Lambda_5_5_p261 = Lambda_5_5_p254_lanes[5] * Lambda_5_5_p259;
  const Real Lambda_0_0_p5 = Lambda_0_0_p4 * Lambda_5_5_p259;
  const Real Lambda_0_1_p3 = Lambda_0_1_p2 * Lambda_5_5_p259;
  const Real Lambda_0_2_p1 = Lambda_5_5_p248_lanes[3] * Lambda_5_5_p259;
  const Real Lambda_5_5_p262 = Lambda_5_5_p165 - Lambda_5_5_p203 * Lambda_5_5_p182 -
      Lambda_5_5_p228 * Lambda_5_5_p214 - Lambda_5_5_p248_lanes[4] * Lambda_5_5_p238_lanes[4] -
      Lambda_5_5_p260 * Lambda_5_5_p254_lanes[4];
  const Real Lambda_5_5_p263 = Lambda_5_5_p164 - Lambda_5_5_p202 * Lambda_5_5_p182 -
      Lambda_5_5_p227 * Lambda_5_5_p214 - Lambda_5_5_p248_lanes[5] * Lambda_5_5_p238_lanes[4] -
      Lambda_5_5_p261 * Lambda_5_5_p254_lanes[4];
  const Real Lambda_5_5_p264 = Lambda_5_5_p163 - Lambda_5_5_p202 * Lambda_5_5_p181 -
      Lambda_5_5_p227 * Lambda_5_5_p213 - Lambda_5_5_p248_lanes[5] * Lambda_5_5_p238_lanes[5] -
      Lambda_5_5_p261 * Lambda_5_5_p254_lanes[5];
  const Real Lambda_0_0_p6 = Lambda_5_5_p228 * Lambda_5_5_p200 - Lambda_5_5_p203 -
      Lambda_5_5_p248_lanes[4] * Lambda_0_0_p2 - Lambda_5_5_p260 * Lambda_0_0_p4;
  const Real Lambda_0_1_p4 = Lambda_5_5_p248_lanes[4] * Lambda_5_5_p230 - Lambda_5_5_p228 -
      Lambda_5_5_p260 * Lambda_0_1_p2;
  const Real Lambda_0_2_p2 = Lambda_5_5_p260 * Lambda_5_5_p248_lanes[3] - Lambda_5_5_p248_lanes[4];
  const Real Lambda_5_5_p265 = Lambda_5_5_p262 * Lambda_5_5_p262;
  const Real Lambda_5_5_p266 = Lambda_5_5_p265 * Lambda_5_5_p262;
  const Real Lambda_5_5_p267 = Lambda_5_5_p266 * Lambda_5_5_p265 /
      (8.673617379884035e-19 + Lambda_5_5_p266 * Lambda_5_5_p266);
  const Real Lambda_5_5_p268 = Lambda_5_5_p263 * Lambda_5_5_p267;
  const Real Lambda_0_0_p7 = Lambda_0_0_p6 * Lambda_5_5_p267;
  const Real Lambda_0_1_p5 = Lambda_0_1_p4 * Lambda_5_5_p267;
  const Real Lambda_0_2_p3 = Lambda_0_2_p2 * Lambda_5_5_p267;
  const Real Lambda_0_3_p1 = Lambda_5_5_p260 * Lambda_5_5_p267;
  const Real Lambda_5_5_p269 = Lambda_5_5_p264 - Lambda_5_5_p268 * Lambda_5_5_p263;
  const Real Lambda_0_5_p1 = Lambda_5_5_p227 * Lambda_5_5_p200 - Lambda_5_5_p202 -
      Lambda_5_5_p248_lanes[5] * Lambda_0_0_p2 - Lambda_5_5_p261 * Lambda_0_0_p4 - Lambda_5_5_p268 *
      Lambda_0_0_p6;
  const Real Lambda_1_5_p1 = Lambda_5_5_p248_lanes[5] * Lambda_5_5_p230 - Lambda_5_5_p227 -
      Lambda_5_5_p261 * Lambda_0_1_p2 - Lambda_5_5_p268 * Lambda_0_1_p4;
  const Real Lambda_2_5_p1 = Lambda_5_5_p261 * Lambda_5_5_p248_lanes[3] - Lambda_5_5_p248_lanes[5] -
      Lambda_5_5_p268 * Lambda_0_2_p2;
  const Real Lambda_3_5_p1 = Lambda_5_5_p268 * Lambda_5_5_p260 - Lambda_5_5_p261;
  const Real Lambda_0_0_p8 = Lambda_5_5_p199 + Lambda_0_0_p1 * Lambda_5_5_p200 + Lambda_0_0_p3 *
      Lambda_0_0_p2 + Lambda_0_0_p5 * Lambda_0_0_p4 + Lambda_0_0_p7 * Lambda_0_0_p6;
  const Real Lambda_5_5_p270 = Lambda_5_5_p269 * Lambda_5_5_p269;
  const Real Lambda_5_5_p271 = Lambda_5_5_p270 * Lambda_5_5_p269;
  const Real Lambda_5_5 = Lambda_5_5_p271 * Lambda_5_5_p270 /
      (2.117582368135751e-22 + Lambda_5_5_p271 * Lambda_5_5_p271);
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
  const Real Lambda_4_5 = Lambda_5_5_p268 * Lambda_5_5;
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
  Lambda[7] = Lambda_5_5_p226 + Lambda_0_1_p1 * Lambda_5_5_p230 + Lambda_0_1_p3 * Lambda_0_1_p2 +
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
  Lambda[14] = Lambda_5_5_p247 + Lambda_0_2_p1 * Lambda_5_5_p248_lanes[3] + Lambda_0_2_p3 *
      Lambda_0_2_p2 + Lambda_2_5 * Lambda_2_5_p1;
  const Real Lambda_2_3 = Lambda_3_5 * Lambda_2_5_p1 -
      (Lambda_0_2_p1 + Lambda_0_3_p1 * Lambda_0_2_p2);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p3 - Lambda_4_5 * Lambda_2_5_p1;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_5_5_p259 + Lambda_0_3_p1 * Lambda_5_5_p260 + Lambda_3_5 * Lambda_3_5_p1;
  const Real Lambda_3_4 = Lambda_0_3_p1 + Lambda_4_5 * Lambda_3_5_p1;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_5_5_p267 + Lambda_4_5 * Lambda_5_5_p268;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
