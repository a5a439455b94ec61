// lambda: Lambda = (J M^-1 J^T)^-1
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points.
// 1505 flops (add 607, mul 886, div 12), sine and cosine of 7 angles
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

using Lanes = detail::Lanes<Real, 8>;
void lambda(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
  const Real angles[7] = {q[8], q[7], q[6], q[5], q[4], q[3], q[2]};
  Real sines[7];
  Real cosines[7];
  detail::sin_cos(angles, sines, cosines);
  const Real s9 = sines[0];
  const Real c8 = cosines[1];
  const Real c7 = cosines[2];
  const Real c6 = cosines[3];
  const Real c5 = cosines[4];
  const Real c4 = cosines[5];
  const Real c3 = cosines[6];
  const Real s4 = sines[5];
  const Real s3 = sines[6];
  const Real s6 = sines[3];
  const Real s5 = sines[4];
  const Real s7 = sines[2];
  const Real s8 = sines[1];
  const Real c9 = cosines[0];

  // link 8 (link5), articulated inertia
  const Real inverse_D6_p1 = 0.0028799999999999997 * s8;
  const Real inverse_D7_p1 = 0.00024215999999999997 * s8;
  const Real inverse_D7_p2 = s8 * inverse_D7_p1;

  // link 7 (link4), articulated inertia
  const Real inverse_D7 = 1.0 / (0.0016 + inverse_D7_p2);
  const Real inverse_D6_p2 = inverse_D6_p1 * inverse_D7;

  // link 8 (link5), articulated inertia
  const Real inverse_D6_p3 = c8 * inverse_D7_p1;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p4 = inverse_D6_p3 * inverse_D6_p2 - 0.0028799999999999997 * c8;
  const Real inverse_D6_p5 = c7 * inverse_D6_p4;
  const Real inverse_D6_p6 = c7 * inverse_D6_p5;
  const Real inverse_D6_p7 = inverse_D6_p6 - inverse_D6_p4;
  const Real inverse_D6_p8 = inverse_D6_p1 * inverse_D6_p2;

  // link 8 (link5), articulated inertia
  const Real inverse_D6_p9 = 0.012916407125949915 * s8;
  const Real inverse_D6_p10 = s8 * inverse_D6_p9;
  const Real inverse_D6_p11 = inverse_D6_p10 - 0.012916407125949915;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p12 = s7 * (inverse_D6_p11 + inverse_D6_p8);
  const Real inverse_D6_p13 = s7 * inverse_D6_p12;
  const Real inverse_D6_p14 = inverse_D6_p11 - inverse_D6_p13;

  // link 8 (link5), articulated inertia
  const Real inverse_D6_p15 = c8 * inverse_D6_p9;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p16 = c7 * inverse_D6_p15;
  const Real inverse_D6_p17 = inverse_D6_p7 + (0.4331 * inverse_D6_p14 + 0.0203 * inverse_D6_p16);
  const Real inverse_D6_p18 = 0.4331 * inverse_D6_p16 - 0.0203 * inverse_D6_p10;
  const Real inverse_D6_p19 = inverse_D6_p3 * inverse_D7;
  const Real inverse_D6_p20 = 0.0011921599999999998 - inverse_D7_p2 - inverse_D6_p3 *
      inverse_D6_p19;
  const Real inverse_D6_p21 = s7 * (inverse_D6_p20 - 0.00065);
  const Real inverse_D6_p22 = s7 * inverse_D6_p21;

  // link 6 (link3), articulated inertia
  const Real inverse_D6 = 1.0 / (0.312455249 + (0.00065 + inverse_D6_p22 +
      (0.0203 * inverse_D6_p18 + 0.4331 * (inverse_D6_p7 + inverse_D6_p17))));

  // link 7 (link4), articulated inertia
  const Real Lambda_0_5_p1 = 0.861795 + inverse_D6_p17;

  // link 6 (link3), articulated inertia
  const Real Lambda_0_5_p2 = Lambda_0_5_p1 * inverse_D6;

  // link 7 (link4), articulated inertia
  const Real Lambda_0_5_p3 = s7 * inverse_D6_p5;
  const Real Lambda_0_5_p4 = c7 * inverse_D6_p12;
  const Real Lambda_0_5_p5 = Lambda_0_5_p3 + 0.4331 * Lambda_0_5_p4;
  const Real Lambda_0_5_p6 = s7 * inverse_D6_p15;
  const Real Lambda_0_5_p7 = 0.0203 * Lambda_0_5_p6;
  const Real Lambda_0_5_p8 = Lambda_0_5_p5 + Lambda_0_5_p7;
  const Real Lambda_0_5_p9 = 0.004704000000000001 + 0.0203 * Lambda_0_5_p8;

  // link 6 (link3), articulated inertia
  const Real Lambda_0_5_p10 = 0.0203 * Lambda_0_5_p4 - Lambda_0_5_p9 * Lambda_0_5_p2;

  // link 7 (link4), articulated inertia
  const Real Lambda_0_5_p11 = 0.025374999999999998 + inverse_D6_p18;

  // link 6 (link3), articulated inertia
  const Real Lambda_0_5_p12 = Lambda_0_5_p11 * inverse_D6;

  // link 7 (link4), articulated inertia
  const Real Lambda_0_5_p13 = c7 * inverse_D6_p21 - 0.4331 * (Lambda_0_5_p8 + Lambda_0_5_p3);

  // link 6 (link3), articulated inertia
  const Real Lambda_0_5_p14 = 0.4331 * Lambda_0_5_p6 + Lambda_0_5_p13 * Lambda_0_5_p12;
  const Real Lambda_0_5_p15 = Lambda_0_5_p5 + Lambda_0_5_p13 * Lambda_0_5_p2;
  const Real Lambda_0_5_p16 = Lambda_0_5_p9 * Lambda_0_5_p12 - Lambda_0_5_p7;
  const Real Lambda_0_5_p17 = c6 * (Lambda_0_5_p10 + Lambda_0_5_p14) - s6 *
      (Lambda_0_5_p15 + Lambda_0_5_p16);
  const Real Lambda_0_5_p18 = s6 * Lambda_0_5_p17;
  const Real Lambda_0_5_p19 = Lambda_0_5_p8 * inverse_D6;
  const Real Lambda_0_5_p20 = Lambda_0_5_p4 - Lambda_0_5_p1 * Lambda_0_5_p19;
  const Real Lambda_0_5_p21 = Lambda_0_5_p11 * Lambda_0_5_p19 - Lambda_0_5_p6;
  const Real Lambda_0_5_p22 = s6 * Lambda_0_5_p20 + c6 * Lambda_0_5_p21;
  const Real Lambda_0_5_p23 = 0.4318 * Lambda_0_5_p22;
  const Real Lambda_0_5_p24 = Lambda_0_5_p16 + Lambda_0_5_p18 - Lambda_0_5_p23;
  const Real Lambda_0_5_p25 = inverse_D6_p14 - Lambda_0_5_p1 * Lambda_0_5_p2;
  const Real Lambda_0_5_p26 = inverse_D6_p10 + Lambda_0_5_p11 * Lambda_0_5_p12;
  const Real Lambda_0_5_p27 = Lambda_0_5_p1 * Lambda_0_5_p12 - inverse_D6_p16;
  const Real Lambda_0_5_p28 = 2.0 * c6;
  const Real Lambda_0_5_p29 = s6 * (Lambda_0_5_p25 + Lambda_0_5_p26) + Lambda_0_5_p28 *
      Lambda_0_5_p27;
  const Real Lambda_0_5_p30 = c6 * Lambda_0_5_p29 - Lambda_0_5_p27;
  const Real Lambda_0_5_p31 = 0.1501 * Lambda_0_5_p30;
  const Real Lambda_0_5_p32 = Lambda_0_5_p15 + Lambda_0_5_p18 + (Lambda_0_5_p24 + Lambda_0_5_p31);
  const Real Lambda_0_5_p33 = c6 * Lambda_0_5_p17;
  const Real Lambda_0_5_p34 = Lambda_0_5_p33 - Lambda_0_5_p10;
  const Real Lambda_0_5_p35 = s6 * Lambda_0_5_p29;
  const Real Lambda_0_5_p36 = Lambda_0_5_p35 - Lambda_0_5_p26;
  const Real Lambda_0_5_p37 = 0.4318 * Lambda_0_5_p34 - 0.06481318000000001 * Lambda_0_5_p36 -
      0.690314699;
  const Real Lambda_0_5_p38 = 0.4318 * Lambda_0_5_p30 - 0.10439999999999999;

  // link 5 (link2), articulated inertia
  const Real inverse_D5 = 1.0 / (1.7481140020000001 + 0.18645124000000002 * Lambda_0_5_p36);
  const Real Lambda_0_5_p39 = Lambda_0_5_p38 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real Lambda_0_5_p40 = 0.4318 * Lambda_0_5_p24 + 0.06481318000000001 * Lambda_0_5_p30 -
      0.023750999999999998;
  const Real Lambda_0_5_p41 = 3.79559 + 0.4318 * Lambda_0_5_p36;

  // link 5 (link2), articulated inertia
  const Real Lambda_0_5_p42 = Lambda_0_5_p41 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real Lambda_0_5_p43 = Lambda_0_5_p33 - Lambda_0_5_p14;
  const Real Lambda_0_5_p44 = c6 * Lambda_0_5_p20 - s6 * Lambda_0_5_p21;
  const Real Lambda_0_5_p45 = Lambda_0_5_p25 - Lambda_0_5_p35;
  const Real Lambda_0_5_p46 = Lambda_0_5_p43 - (0.4318 * Lambda_0_5_p44 - 0.1501 * Lambda_0_5_p45);
  const Real Lambda_0_5_p47 = Lambda_0_5_p34 - 0.1501 * Lambda_0_5_p36;

  // link 5 (link2), articulated inertia
  const Real Lambda_0_5_p48 = Lambda_0_5_p47 - Lambda_0_5_p37 * Lambda_0_5_p42;
  const Real Lambda_0_5_p49 = s5 * (Lambda_0_5_p32 + Lambda_0_5_p31 + Lambda_0_5_p37 *
      Lambda_0_5_p39 - Lambda_0_5_p40 * Lambda_0_5_p42) - c5 *
      (Lambda_0_5_p46 - Lambda_0_5_p40 * Lambda_0_5_p39 + Lambda_0_5_p48);
  const Real Lambda_0_5_p50 = c5 * Lambda_0_5_p49 + Lambda_0_5_p48 - 4.9338049999999996;

  // link 7 (link4), articulated inertia
  const Real inverse_D4_p1 = inverse_D6_p13 - inverse_D6_p8;
  const Real inverse_D4_p2 = inverse_D6_p6 - 0.4331 * inverse_D4_p1;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p3 = Lambda_0_5_p13 * inverse_D6;
  const Real inverse_D4_p4 = 0.3056901365 + (inverse_D6_p20 - inverse_D6_p22 - 0.4331 *
      (inverse_D6_p6 + inverse_D4_p2)) - Lambda_0_5_p13 * inverse_D4_p3;
  const Real inverse_D4_p5 = Lambda_0_5_p9 * inverse_D6;
  const Real inverse_D4_p6 = 0.0067651125 + 0.00041208999999999994 * inverse_D4_p1 - Lambda_0_5_p9 *
      inverse_D4_p5;
  const Real inverse_D4_p7 = 0.0203 * inverse_D6_p6 - 0.00879193 * inverse_D4_p1 -
      0.010673638499999999 - Lambda_0_5_p13 * inverse_D4_p5;
  const Real inverse_D4_p8 = s6 * (inverse_D4_p4 - inverse_D4_p6) + Lambda_0_5_p28 * inverse_D4_p7;
  const Real inverse_D4_p9 = s6 * inverse_D4_p8;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p10 = Lambda_0_5_p37 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p11 = inverse_D4_p2 - 0.861795 - Lambda_0_5_p13 * Lambda_0_5_p19;
  const Real inverse_D4_p12 = 0.025374999999999998 + 0.0203 * inverse_D4_p1 - Lambda_0_5_p9 *
      Lambda_0_5_p19;
  const Real inverse_D4_p13 = s6 * inverse_D4_p11 + c6 * inverse_D4_p12;
  const Real inverse_D4_p14 = inverse_D4_p1 - Lambda_0_5_p8 * Lambda_0_5_p19;
  const Real inverse_D4_p15 = inverse_D4_p13 - (0.4318 * inverse_D4_p14 - 0.1501 * Lambda_0_5_p44);
  const Real inverse_D4_p16 = 1.674987602 + (inverse_D4_p6 + inverse_D4_p9 +
      (0.1501 * (Lambda_0_5_p43 + Lambda_0_5_p46) - 0.4318 * (inverse_D4_p13 + inverse_D4_p15)));

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p17 = Lambda_0_5_p40 * inverse_D5;
  const Real inverse_D4_p18 = inverse_D4_p16 - Lambda_0_5_p40 * inverse_D4_p17;
  const Real inverse_D4_p19 = 0.07312640000000001 +
      (inverse_D4_p4 - inverse_D4_p9 - 0.1501 * (Lambda_0_5_p34 + Lambda_0_5_p47)) -
      Lambda_0_5_p37 * inverse_D4_p10 - inverse_D4_p18;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p20 = c6 * inverse_D4_p11 - s6 * inverse_D4_p12;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p21 = c6 * inverse_D4_p8 - inverse_D4_p7 -
      (0.1501 * Lambda_0_5_p32 + 0.4318 * inverse_D4_p20) - 0.0070992 - Lambda_0_5_p37 *
      inverse_D4_p17;
  const Real inverse_D4_p22 = 2.0 * c5;

  // link 4 (link1), articulated inertia
  const Real inverse_D4 = 1.0 / (1.4717295504999999 +
      (inverse_D4_p18 + s5 * (s5 * inverse_D4_p19 + inverse_D4_p22 * inverse_D4_p21)));
  const Real Lambda_0_5_p51 = Lambda_0_5_p50 * inverse_D4;

  // link 5 (link2), articulated inertia
  const Real Lambda_0_5_p52 = Lambda_0_5_p45 - Lambda_0_5_p38 * Lambda_0_5_p39;
  const Real Lambda_0_5_p53 = s5 * (Lambda_0_5_p52 -
      (Lambda_0_5_p36 - Lambda_0_5_p41 * Lambda_0_5_p42)) + inverse_D4_p22 *
      (Lambda_0_5_p30 - Lambda_0_5_p38 * Lambda_0_5_p42);

  // link 4 (link1), articulated inertia
  const Real Lambda_0_5_p54 = Lambda_0_5_p52 - s5 * Lambda_0_5_p53 - Lambda_0_5_p50 *
      Lambda_0_5_p51;

  // link 5 (link2), articulated inertia
  const Real Lambda_0_5_p55 = Lambda_0_5_p23 * inverse_D5;
  const Real Lambda_0_5_p56 = s5 * (0.10439999999999999 +
      (inverse_D4_p20 - 0.1501 * Lambda_0_5_p22) - Lambda_0_5_p37 * Lambda_0_5_p55) + c5 *
      (inverse_D4_p15 - 3.79559 - Lambda_0_5_p40 * Lambda_0_5_p55);

  // link 4 (link1), articulated inertia
  const Real Lambda_0_5_p57 = Lambda_0_5_p56 * inverse_D4;
  const Real Lambda_0_5_p58 = inverse_D4_p14 - Lambda_0_5_p23 * Lambda_0_5_p55 - Lambda_0_5_p56 *
      Lambda_0_5_p57;
  const Real Lambda_0_5_p59 = Lambda_0_5_p50 * Lambda_0_5_p57 -
      (s5 * (Lambda_0_5_p22 - Lambda_0_5_p41 * Lambda_0_5_p55) - c5 *
      (Lambda_0_5_p44 - Lambda_0_5_p38 * Lambda_0_5_p55));
  const Real Lambda_0_5_p60 = s4 * (Lambda_0_5_p54 - Lambda_0_5_p58) + c4 * (2.0 * Lambda_0_5_p59);
  const Real Lambda_0_5_p61 = s4 * Lambda_0_5_p60;
  const Real Lambda_0_5_p62 = Lambda_0_5_p54 - Lambda_0_5_p61;
  const Real Lambda_0_5_p63 = Lambda_0_5_p58 + Lambda_0_5_p61;
  const Real Lambda_0_5_p64 = c4 * Lambda_0_5_p60 - Lambda_0_5_p59;

  // link 3 (base), articulated inertia
  const Real Lambda_0_5_p65 = s3 * (Lambda_0_5_p62 - Lambda_0_5_p63) + c3 * (2.0 * Lambda_0_5_p64);
  const Real Lambda_0_5_p66 = c3 * Lambda_0_5_p65 - Lambda_0_5_p64;
  const Real inverse_D2_p1 = s3 * Lambda_0_5_p65;

  // link 2 (base_y), articulated inertia
  const Real inverse_D2 = 1.0 / (186.45 + (Lambda_0_5_p63 + inverse_D2_p1));
  const Real Lambda_0_5_p67 = Lambda_0_5_p66 * inverse_D2;

  // link 6 (link3), pose
  const Real Lambda_0_5_p68 = s6 * s5 - c6 * c5;
  const Real Lambda_0_5_p69 = c6 * s5 + s6 * c5;

  // link 7 (link4), pose
  const Real Lambda_0_5_p70 = c7 * Lambda_0_5_p69;

  // link 8 (link5), pose
  const Real Lambda_0_5_p71 = s8 * Lambda_0_5_p68 - c8 * Lambda_0_5_p70;

  // link 7 (link4), pose
  const Real Lambda_0_5_p72 = s7 * Lambda_0_5_p69;

  // link 9 (link6), pose
  const Real Lambda_0_5_p73 = c9 * Lambda_0_5_p71 + s9 * Lambda_0_5_p72;

  // link 4 (link1), pose
  const Real Lambda_0_5_p74 = s4 * c3 + c4 * s3;

  // link 5 (link2), pose
  const Real Lambda_0_5_p75 = c5 * Lambda_0_5_p74;
  const Real Lambda_0_5_p76 = s5 * Lambda_0_5_p74;

  // link 6 (link3), pose
  const Real Lambda_0_5_p77 = c6 * Lambda_0_5_p75 - s6 * Lambda_0_5_p76;

  // link 4 (link1), pose
  const Real Lambda_0_5_p78 = c4 * c3 - s4 * s3;

  // link 7 (link4), pose
  const Real Lambda_0_5_p79 = c7 * Lambda_0_5_p77 + s7 * Lambda_0_5_p78;

  // link 6 (link3), pose
  const Real Lambda_0_5_p80 = s6 * Lambda_0_5_p75 + c6 * Lambda_0_5_p76;

  // link 8 (link5), pose
  const Real Lambda_0_5_p81 = c8 * Lambda_0_5_p79 - s8 * Lambda_0_5_p80;

  // link 7 (link4), pose
  const Real Lambda_0_5_p82 = c7 * Lambda_0_5_p78 - s7 * Lambda_0_5_p77;

  // link 9 (link6), pose
  const Real Lambda_0_5_p83 = c9 * Lambda_0_5_p81 + s9 * Lambda_0_5_p82;

  // link 5 (link2), pose
  const Real Lambda_0_5_p84 = c5 * Lambda_0_5_p78;
  const Real Lambda_0_5_p85 = s5 * Lambda_0_5_p78;

  // link 6 (link3), pose
  const Real Lambda_0_5_p86 = c6 * Lambda_0_5_p84 - s6 * Lambda_0_5_p85;

  // link 7 (link4), pose
  const Real Lambda_0_5_p87 = c7 * Lambda_0_5_p86 - s7 * Lambda_0_5_p74;

  // link 6 (link3), pose
  const Real Lambda_0_5_p88 = s6 * Lambda_0_5_p84 + c6 * Lambda_0_5_p85;

  // link 8 (link5), pose
  const Real Lambda_0_5_p89 = c8 * Lambda_0_5_p87 - s8 * Lambda_0_5_p88;

  // link 7 (link4), pose
  const Real Lambda_0_5_p90 = s7 * Lambda_0_5_p86 + c7 * Lambda_0_5_p74;

  // link 9 (link6), pose
  const Real Lambda_0_5_p91 = c9 * Lambda_0_5_p89 - s9 * Lambda_0_5_p90;

  // link 9 (link6), force propagation
  const Lanes Lambda_0_5_p92_lanes = c9 * detail::make_lanes<Real>(Lambda_0_5_p91, Lambda_0_5_p83,
      Lambda_0_5_p73, Lambda_0_5_p91, Lambda_0_5_p91, Lambda_0_5_p91, Lambda_0_5_p91,
      Lambda_0_5_p91);

  // link 9 (link6), pose
  const Real Lambda_0_5_p95 = c9 * Lambda_0_5_p72 - s9 * Lambda_0_5_p71;
  const Real Lambda_0_5_p96 = c9 * Lambda_0_5_p82 - s9 * Lambda_0_5_p81;
  const Real Lambda_0_5_p97 = s9 * Lambda_0_5_p89 + c9 * Lambda_0_5_p90;

  // link 9 (link6), force propagation
  const Real Lambda_0_5_p98 = -Lambda_0_5_p97;
  const Lanes Lambda_0_5_p99_lanes = s9 * detail::make_lanes<Real>(Lambda_0_5_p98, Lambda_0_5_p96,
      Lambda_0_5_p95, Lambda_0_5_p98, Lambda_0_5_p98, Lambda_0_5_p98, Lambda_0_5_p98,
      Lambda_0_5_p98);
  const Lanes Lambda_0_5_p102_lanes = Lambda_0_5_p92_lanes - Lambda_0_5_p99_lanes;
  const Real Lambda_0_5_p105 = -(0.05625 * Lambda_0_5_p95);
  const Real Lambda_0_5_p106 = -(0.05625 * Lambda_0_5_p96);

  // link 1 (base_x), articulated inertia
  const Real Lambda_0_5_p107 = 0.05625 * Lambda_0_5_p97;

  // link 9 (link6), force propagation
  const Lanes Lambda_0_5_p108_lanes = c9 * detail::make_lanes<Real>(Lambda_0_5_p107,
      Lambda_0_5_p106, Lambda_0_5_p105, Lambda_0_5_p107, Lambda_0_5_p107, Lambda_0_5_p107,
      Lambda_0_5_p107, Lambda_0_5_p107);

  // link 1 (base_x), articulated inertia
  const Lanes Lambda_0_5_p111_lanes = 0.05625 * detail::make_lanes<Real>(Lambda_0_5_p91,
      Lambda_0_5_p83, Lambda_0_5_p73, Lambda_0_5_p91, Lambda_0_5_p91, Lambda_0_5_p91,
      Lambda_0_5_p91, Lambda_0_5_p91);

  // link 9 (link6), force propagation
  const Lanes Lambda_0_5_p114_lanes = s9 * Lambda_0_5_p111_lanes;
  const Lanes Lambda_0_5_p117_lanes = Lambda_0_5_p108_lanes - Lambda_0_5_p114_lanes;

  // link 8 (link5), force propagation
  const Lanes Lambda_0_5_p120_lanes = c8 * detail::make_lanes<Real>(Lambda_0_5_p117_lanes[0],
      Lambda_0_5_p117_lanes[1], Lambda_0_5_p117_lanes[2], Lambda_0_5_p102_lanes[0],
      Lambda_0_5_p102_lanes[1], Lambda_0_5_p102_lanes[2], Lambda_0_5_p117_lanes[0],
      Lambda_0_5_p117_lanes[0]);

  // link 7 (link4), force propagation
  const Real Lambda_0_5_p126 = -(s8 * Lambda_0_5_p102_lanes[2]);
  const Real Lambda_0_5_p127 = -(s8 * Lambda_0_5_p102_lanes[1]);
  const Real Lambda_0_5_p128 = -(s8 * Lambda_0_5_p102_lanes[0]);
  const Real Lambda_0_5_p129 = -(s8 * Lambda_0_5_p117_lanes[2]);
  const Real Lambda_0_5_p130 = -(s8 * Lambda_0_5_p117_lanes[1]);
  const Real Lambda_0_5_p131 = -(s8 * Lambda_0_5_p117_lanes[0]);
  const Lanes Lambda_0_5_p132_lanes = inverse_D6_p19 *
      detail::make_lanes<Real>(Lambda_0_5_p131, Lambda_0_5_p130, Lambda_0_5_p129, Lambda_0_5_p128,
      Lambda_0_5_p127, Lambda_0_5_p126, Lambda_0_5_p131, Lambda_0_5_p131);
  const Lanes Lambda_0_5_p138_lanes = Lambda_0_5_p120_lanes + Lambda_0_5_p132_lanes;
  const Lanes Lambda_0_5_p144_lanes = c7 * Lambda_0_5_p138_lanes;

  // link 9 (link6), force propagation
  const Lanes Lambda_0_5_p150_lanes = s9 * detail::make_lanes<Real>(Lambda_0_5_p91, Lambda_0_5_p83,
      Lambda_0_5_p73, Lambda_0_5_p91, Lambda_0_5_p91, Lambda_0_5_p91, Lambda_0_5_p91,
      Lambda_0_5_p91);
  const Lanes Lambda_0_5_p153_lanes = c9 * detail::make_lanes<Real>(Lambda_0_5_p98, Lambda_0_5_p96,
      Lambda_0_5_p95, Lambda_0_5_p98, Lambda_0_5_p98, Lambda_0_5_p98, Lambda_0_5_p98,
      Lambda_0_5_p98);
  const Lanes Lambda_0_5_p156_lanes = Lambda_0_5_p150_lanes + Lambda_0_5_p153_lanes;

  // link 8 (link5), force propagation
  const Real Lambda_0_5_p159 = 4.484863585399276 * Lambda_0_5_p156_lanes[2];

  // link 7 (link4), force propagation
  const Real Lambda_0_5_p160 = -(c8 * Lambda_0_5_p159);
  const Real Lambda_0_5_p161 = inverse_D6_p2 * Lambda_0_5_p126;
  const Real Lambda_0_5_p162 = s7 * Lambda_0_5_p160 - c7 * Lambda_0_5_p161;

  // link 8 (link5), force propagation
  const Real Lambda_0_5_p163 = 4.484863585399276 * Lambda_0_5_p156_lanes[1];

  // link 7 (link4), force propagation
  const Real Lambda_0_5_p164 = -(c8 * Lambda_0_5_p163);
  const Real Lambda_0_5_p165 = inverse_D6_p2 * Lambda_0_5_p127;
  const Real Lambda_0_5_p166 = s7 * Lambda_0_5_p164 - c7 * Lambda_0_5_p165;

  // link 8 (link5), force propagation
  const Real Lambda_0_5_p167 = 4.484863585399276 * Lambda_0_5_p156_lanes[0];

  // link 7 (link4), force propagation
  const Real Lambda_0_5_p168 = -(c8 * Lambda_0_5_p167);
  const Real Lambda_0_5_p169 = inverse_D6_p2 * Lambda_0_5_p128;
  const Real Lambda_0_5_p170 = s7 * Lambda_0_5_p168 - c7 * Lambda_0_5_p169;

  // link 9 (link6), force propagation
  const Lanes Lambda_0_5_p171_lanes = s9 * detail::make_lanes<Real>(Lambda_0_5_p107,
      Lambda_0_5_p106, Lambda_0_5_p105, Lambda_0_5_p107, Lambda_0_5_p107, Lambda_0_5_p107,
      Lambda_0_5_p107, Lambda_0_5_p107);
  const Lanes Lambda_0_5_p174_lanes = c9 * Lambda_0_5_p111_lanes;
  const Lanes Lambda_0_5_p177_lanes = Lambda_0_5_p171_lanes + Lambda_0_5_p174_lanes;

  // link 8 (link5), force propagation
  const Real Lambda_0_5_p180 = Lambda_0_5_p102_lanes[2] - 4.484863585399276 *
      Lambda_0_5_p177_lanes[2];

  // link 9 (link6), force propagation
  const Real Lambda_0_5_p181 = -(s8 * Lambda_0_5_p70 + c8 * Lambda_0_5_p68);

  // link 8 (link5), force propagation
  const Real Lambda_0_5_p182 = -Lambda_0_5_p181;

  // link 7 (link4), force propagation
  const Real Lambda_0_5_p183 = -(s8 * Lambda_0_5_p182 - c8 * Lambda_0_5_p180);

  // link 8 (link5), force propagation
  const Real Lambda_0_5_p184 = Lambda_0_5_p102_lanes[1] - 4.484863585399276 *
      Lambda_0_5_p177_lanes[1];

  // link 8 (link5), pose
  const Real Lambda_0_5_p185 = s8 * Lambda_0_5_p79 + c8 * Lambda_0_5_p80;

  // link 8 (link5), force propagation
  const Real Lambda_0_5_p186 = -Lambda_0_5_p185;

  // link 7 (link4), force propagation
  const Real Lambda_0_5_p187 = -(s8 * Lambda_0_5_p186 - c8 * Lambda_0_5_p184);

  // link 8 (link5), force propagation
  const Real Lambda_0_5_p188 = Lambda_0_5_p102_lanes[0] - 4.484863585399276 *
      Lambda_0_5_p177_lanes[0];

  // link 8 (link5), pose
  const Real Lambda_0_5_p189 = s8 * Lambda_0_5_p87 + c8 * Lambda_0_5_p88;

  // link 8 (link5), force propagation
  const Real Lambda_0_5_p190 = -Lambda_0_5_p189;

  // link 7 (link4), force propagation
  const Real Lambda_0_5_p191 = -(s8 * Lambda_0_5_p190 - c8 * Lambda_0_5_p188);
  const Lanes Lambda_0_5_p192_lanes = s7 * detail::make_lanes<Real>(Lambda_0_5_p191,
      Lambda_0_5_p187, Lambda_0_5_p183, Lambda_0_5_p191, Lambda_0_5_p191, Lambda_0_5_p191,
      Lambda_0_5_p191, Lambda_0_5_p191);
  const Lanes Lambda_0_5_p195_lanes = inverse_D6_p2 *
      detail::make_lanes<Real>(Lambda_0_5_p131, Lambda_0_5_p130, Lambda_0_5_p129, Lambda_0_5_p131,
      Lambda_0_5_p131, Lambda_0_5_p131, Lambda_0_5_p131, Lambda_0_5_p131);
  const Lanes Lambda_0_5_p198_lanes = Lambda_0_5_p156_lanes - Lambda_0_5_p195_lanes;
  const Lanes Lambda_0_5_p201_lanes = c7 * Lambda_0_5_p198_lanes;
  const Lanes Lambda_0_5_p204_lanes = Lambda_0_5_p192_lanes + Lambda_0_5_p201_lanes;
  const Lanes Lambda_0_5_p207_lanes = 0.4331 * detail::make_lanes<Real>(Lambda_0_5_p204_lanes[0],
      Lambda_0_5_p204_lanes[1], Lambda_0_5_p204_lanes[2], Lambda_0_5_p170, Lambda_0_5_p166,
      Lambda_0_5_p162, Lambda_0_5_p204_lanes[0], Lambda_0_5_p204_lanes[0]);
  const Lanes Lambda_0_5_p213_lanes = Lambda_0_5_p144_lanes - Lambda_0_5_p207_lanes;
  const Lanes Lambda_0_5_p219_lanes = s7 * Lambda_0_5_p138_lanes;
  const Lanes Lambda_0_5_p225_lanes = c7 * detail::make_lanes<Real>(Lambda_0_5_p168,
      Lambda_0_5_p168, Lambda_0_5_p168, Lambda_0_5_p168, Lambda_0_5_p164, Lambda_0_5_p160,
      Lambda_0_5_p168, Lambda_0_5_p168);
  const Lanes Lambda_0_5_p228_lanes = s7 * detail::make_lanes<Real>(Lambda_0_5_p169,
      Lambda_0_5_p169, Lambda_0_5_p169, Lambda_0_5_p169, Lambda_0_5_p165, Lambda_0_5_p161,
      Lambda_0_5_p169, Lambda_0_5_p169);
  const Lanes Lambda_0_5_p231_lanes = Lambda_0_5_p225_lanes + Lambda_0_5_p228_lanes;
  const Real Lambda_0_5_p234 = c7 * Lambda_0_5_p183 - s7 * Lambda_0_5_p198_lanes[2];
  const Real Lambda_0_5_p235 = c7 * Lambda_0_5_p187 - s7 * Lambda_0_5_p198_lanes[1];
  const Real Lambda_0_5_p236 = c7 * Lambda_0_5_p191 - s7 * Lambda_0_5_p198_lanes[0];
  const Lanes Lambda_0_5_p237_lanes = 0.4331 * detail::make_lanes<Real>(Lambda_0_5_p236,
      Lambda_0_5_p235, Lambda_0_5_p234, Lambda_0_5_p231_lanes[3], Lambda_0_5_p231_lanes[4],
      Lambda_0_5_p231_lanes[5], Lambda_0_5_p236, Lambda_0_5_p236);

  // link 8 (link5), force propagation
  const Real Lambda_0_5_p243 = s8 * Lambda_0_5_p159;
  const Real Lambda_0_5_p244 = s8 * Lambda_0_5_p163;
  const Real Lambda_0_5_p245 = s8 * Lambda_0_5_p167;

  // link 7 (link4), force propagation
  const Real Lambda_0_5_p246 = -(s8 * Lambda_0_5_p180 + c8 * Lambda_0_5_p182);
  const Real Lambda_0_5_p247 = -(s8 * Lambda_0_5_p184 + c8 * Lambda_0_5_p186);
  const Real Lambda_0_5_p248 = -(s8 * Lambda_0_5_p188 + c8 * Lambda_0_5_p190);
  const Lanes Lambda_0_5_p249_lanes = 0.0203 * detail::make_lanes<Real>(Lambda_0_5_p248,
      Lambda_0_5_p247, Lambda_0_5_p246, Lambda_0_5_p245, Lambda_0_5_p244, Lambda_0_5_p243,
      Lambda_0_5_p248, Lambda_0_5_p248);
  const Lanes Lambda_0_5_p255_lanes = Lambda_0_5_p249_lanes + Lambda_0_5_p237_lanes;
  const Lanes Lambda_0_5_p261_lanes = Lambda_0_5_p219_lanes + Lambda_0_5_p255_lanes;

  // link 6 (link3), force propagation
  const Lanes Lambda_0_5_p267_lanes = inverse_D4_p3 * Lambda_0_5_p261_lanes;
  const Lanes Lambda_0_5_p273_lanes = Lambda_0_5_p213_lanes - Lambda_0_5_p267_lanes;
  const Lanes Lambda_0_5_p279_lanes = c6 * Lambda_0_5_p273_lanes;
  const Lanes Lambda_0_5_p285_lanes = inverse_D4_p5 * Lambda_0_5_p261_lanes;

  // link 7 (link4), force propagation
  const Lanes Lambda_0_5_p291_lanes = 0.0203 * detail::make_lanes<Real>(Lambda_0_5_p204_lanes[0],
      Lambda_0_5_p204_lanes[1], Lambda_0_5_p204_lanes[2], Lambda_0_5_p170, Lambda_0_5_p166,
      Lambda_0_5_p162, Lambda_0_5_p204_lanes[0], Lambda_0_5_p204_lanes[0]);

  // link 6 (link3), force propagation
  const Lanes Lambda_0_5_p297_lanes = Lambda_0_5_p291_lanes - Lambda_0_5_p285_lanes;
  const Lanes Lambda_0_5_p303_lanes = s6 * Lambda_0_5_p297_lanes;
  const Lanes Lambda_0_5_p309_lanes = Lambda_0_5_p279_lanes - Lambda_0_5_p303_lanes;
  const Lanes Lambda_0_5_p315_lanes = Lambda_0_5_p2 * Lambda_0_5_p261_lanes;
  const Lanes Lambda_0_5_p321_lanes = detail::make_lanes<Real>(Lambda_0_5_p236, Lambda_0_5_p235,
      Lambda_0_5_p234, Lambda_0_5_p231_lanes[3], Lambda_0_5_p231_lanes[4], Lambda_0_5_p231_lanes[5],
      Lambda_0_5_p236, Lambda_0_5_p236) - Lambda_0_5_p315_lanes;
  const Lanes Lambda_0_5_p327_lanes = s6 * Lambda_0_5_p321_lanes;
  const Lanes Lambda_0_5_p333_lanes = Lambda_0_5_p12 * Lambda_0_5_p261_lanes;
  const Lanes Lambda_0_5_p339_lanes = detail::make_lanes<Real>(-Lambda_0_5_p248, -Lambda_0_5_p247,
      -Lambda_0_5_p246, -Lambda_0_5_p245, -Lambda_0_5_p244, -Lambda_0_5_p243, -Lambda_0_5_p248,
      -Lambda_0_5_p248) + Lambda_0_5_p333_lanes;
  const Lanes Lambda_0_5_p345_lanes = c6 * Lambda_0_5_p339_lanes;
  const Lanes Lambda_0_5_p351_lanes = Lambda_0_5_p327_lanes + Lambda_0_5_p345_lanes;
  const Lanes Lambda_0_5_p357_lanes = 0.1501 * Lambda_0_5_p351_lanes;
  const Lanes Lambda_0_5_p363_lanes = Lambda_0_5_p309_lanes - Lambda_0_5_p357_lanes;
  const Lanes Lambda_0_5_p369_lanes = 0.4318 * Lambda_0_5_p351_lanes;
  const Lanes Lambda_0_5_p375_lanes = s6 * Lambda_0_5_p273_lanes;
  const Lanes Lambda_0_5_p381_lanes = c6 * Lambda_0_5_p297_lanes;
  const Lanes Lambda_0_5_p387_lanes = Lambda_0_5_p375_lanes + Lambda_0_5_p381_lanes;
  const Lanes Lambda_0_5_p393_lanes = c6 * Lambda_0_5_p321_lanes;
  const Lanes Lambda_0_5_p399_lanes = s6 * Lambda_0_5_p339_lanes;
  const Lanes Lambda_0_5_p405_lanes = Lambda_0_5_p393_lanes - Lambda_0_5_p399_lanes;
  const Lanes Lambda_0_5_p411_lanes = 0.1501 * Lambda_0_5_p405_lanes;
  const Lanes Lambda_0_5_p417_lanes = Lambda_0_5_p19 * Lambda_0_5_p261_lanes;
  const Lanes Lambda_0_5_p423_lanes = detail::make_lanes<Real>(Lambda_0_5_p204_lanes[0],
      Lambda_0_5_p204_lanes[1], Lambda_0_5_p204_lanes[2], Lambda_0_5_p170, Lambda_0_5_p166,
      Lambda_0_5_p162, Lambda_0_5_p204_lanes[0], Lambda_0_5_p204_lanes[0]) - Lambda_0_5_p417_lanes;
  const Lanes Lambda_0_5_p429_lanes = 0.4318 * Lambda_0_5_p423_lanes;
  const Lanes Lambda_0_5_p435_lanes = Lambda_0_5_p411_lanes - Lambda_0_5_p429_lanes;
  const Lanes Lambda_0_5_p441_lanes = Lambda_0_5_p387_lanes + Lambda_0_5_p435_lanes;

  // link 4 (link1), force propagation
  const Real Lambda_0_5_p447 = -(s5 * (Lambda_0_5_p363_lanes[5] - inverse_D4_p10 *
      Lambda_0_5_p369_lanes[5]) + c5 * (Lambda_0_5_p441_lanes[5] - inverse_D4_p17 *
      Lambda_0_5_p369_lanes[5]));
  const Real Lambda_0_5_p448 = -(s5 * (Lambda_0_5_p363_lanes[4] - inverse_D4_p10 *
      Lambda_0_5_p369_lanes[4]) + c5 * (Lambda_0_5_p441_lanes[4] - inverse_D4_p17 *
      Lambda_0_5_p369_lanes[4]));
  const Real Lambda_0_5_p449 = -(s5 * (Lambda_0_5_p363_lanes[3] - inverse_D4_p10 *
      Lambda_0_5_p369_lanes[3]) + c5 * (Lambda_0_5_p441_lanes[3] - inverse_D4_p17 *
      Lambda_0_5_p369_lanes[3]));
  const Real Lambda_0_5_p450 = -(s5 * (Lambda_0_5_p363_lanes[2] - inverse_D4_p10 *
      Lambda_0_5_p369_lanes[2]) + c5 * (Lambda_0_5_p441_lanes[2] - inverse_D4_p17 *
      Lambda_0_5_p369_lanes[2]));
  const Real Lambda_0_5_p451 = -(s5 * (Lambda_0_5_p363_lanes[1] - inverse_D4_p10 *
      Lambda_0_5_p369_lanes[1]) + c5 * (Lambda_0_5_p441_lanes[1] - inverse_D4_p17 *
      Lambda_0_5_p369_lanes[1]));
  const Real Lambda_0_5_p452 = -(s5 * (Lambda_0_5_p363_lanes[0] - inverse_D4_p10 *
      Lambda_0_5_p369_lanes[0]) + c5 * (Lambda_0_5_p441_lanes[0] - inverse_D4_p17 *
      Lambda_0_5_p369_lanes[0]));
  const Lanes Lambda_0_5_p453_lanes = Lambda_0_5_p51 *
      detail::make_lanes<Real>(Lambda_0_5_p452, Lambda_0_5_p451, Lambda_0_5_p450, Lambda_0_5_p449,
      Lambda_0_5_p448, Lambda_0_5_p447, Lambda_0_5_p452, Lambda_0_5_p452);
  const Real Lambda_0_5_p459 = -(s5 * (Lambda_0_5_p351_lanes[5] - Lambda_0_5_p42 *
      Lambda_0_5_p369_lanes[5]) - c5 * (Lambda_0_5_p405_lanes[5] - Lambda_0_5_p39 *
      Lambda_0_5_p369_lanes[5]));
  const Real Lambda_0_5_p460 = -(s5 * (Lambda_0_5_p351_lanes[4] - Lambda_0_5_p42 *
      Lambda_0_5_p369_lanes[4]) - c5 * (Lambda_0_5_p405_lanes[4] - Lambda_0_5_p39 *
      Lambda_0_5_p369_lanes[4]));
  const Real Lambda_0_5_p461 = -(s5 * (Lambda_0_5_p351_lanes[3] - Lambda_0_5_p42 *
      Lambda_0_5_p369_lanes[3]) - c5 * (Lambda_0_5_p405_lanes[3] - Lambda_0_5_p39 *
      Lambda_0_5_p369_lanes[3]));
  const Real Lambda_0_5_p462 = -(s5 * (Lambda_0_5_p351_lanes[2] - Lambda_0_5_p42 *
      Lambda_0_5_p369_lanes[2]) - c5 * (Lambda_0_5_p405_lanes[2] - Lambda_0_5_p39 *
      Lambda_0_5_p369_lanes[2]));
  const Real Lambda_0_5_p463 = -(s5 * (Lambda_0_5_p351_lanes[1] - Lambda_0_5_p42 *
      Lambda_0_5_p369_lanes[1]) - c5 * (Lambda_0_5_p405_lanes[1] - Lambda_0_5_p39 *
      Lambda_0_5_p369_lanes[1]));
  const Real Lambda_0_5_p464 = -(s5 * (Lambda_0_5_p351_lanes[0] - Lambda_0_5_p42 *
      Lambda_0_5_p369_lanes[0]) - c5 * (Lambda_0_5_p405_lanes[0] - Lambda_0_5_p39 *
      Lambda_0_5_p369_lanes[0]));
  const Lanes Lambda_0_5_p465_lanes = detail::make_lanes<Real>(Lambda_0_5_p464, Lambda_0_5_p463,
      Lambda_0_5_p462, Lambda_0_5_p461, Lambda_0_5_p460, Lambda_0_5_p459, Lambda_0_5_p464,
      Lambda_0_5_p464) - Lambda_0_5_p453_lanes;
  const Lanes Lambda_0_5_p471_lanes = c4 * Lambda_0_5_p465_lanes;
  const Lanes Lambda_0_5_p477_lanes = Lambda_0_5_p57 *
      detail::make_lanes<Real>(Lambda_0_5_p452, Lambda_0_5_p451, Lambda_0_5_p450, Lambda_0_5_p449,
      Lambda_0_5_p448, Lambda_0_5_p447, Lambda_0_5_p452, Lambda_0_5_p452);

  // link 5 (link2), force propagation
  const Lanes Lambda_0_5_p483_lanes = Lambda_0_5_p55 * Lambda_0_5_p369_lanes;
  const Lanes Lambda_0_5_p489_lanes = Lambda_0_5_p423_lanes - Lambda_0_5_p483_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_0_5_p495_lanes = Lambda_0_5_p489_lanes + Lambda_0_5_p477_lanes;
  const Lanes Lambda_0_5_p501_lanes = s4 * Lambda_0_5_p495_lanes;
  const Lanes Lambda_0_5_p507_lanes = Lambda_0_5_p471_lanes - Lambda_0_5_p501_lanes;

  // link 3 (base), force propagation
  const Lanes Lambda_0_5_p513_lanes = s3 * Lambda_0_5_p507_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_0_5_p519_lanes = s4 * Lambda_0_5_p465_lanes;
  const Lanes Lambda_0_5_p525_lanes = c4 * Lambda_0_5_p495_lanes;
  const Lanes Lambda_0_5_p531_lanes = Lambda_0_5_p519_lanes + Lambda_0_5_p525_lanes;

  // link 3 (base), force propagation
  const Lanes Lambda_0_5_p537_lanes = c3 * Lambda_0_5_p531_lanes;
  const Lanes Lambda_0_5_p543_lanes = Lambda_0_5_p513_lanes + Lambda_0_5_p537_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_0_5_p549_lanes = Lambda_0_5_p67 * Lambda_0_5_p543_lanes;

  // link 3 (base), force propagation
  const Lanes Lambda_0_5_p555_lanes = c3 * Lambda_0_5_p507_lanes;
  const Lanes Lambda_0_5_p561_lanes = s3 * Lambda_0_5_p531_lanes;
  const Lanes Lambda_0_5_p567_lanes = Lambda_0_5_p555_lanes - Lambda_0_5_p561_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_0_5_p573_lanes = Lambda_0_5_p567_lanes - Lambda_0_5_p549_lanes;

  // link 1 (base_x), articulated inertia
  const Real inverse_D1 = 1.0 / (186.45 + (Lambda_0_5_p62 - inverse_D2_p1) - Lambda_0_5_p66 *
      Lambda_0_5_p67);

  // link 1 (base_x), force propagation
  const Lanes Lambda_0_5_p579_lanes = Lambda_0_5_p573_lanes * inverse_D1;
  const Lanes Lambda_0_5_p585_lanes = Lambda_0_5_p579_lanes * Lambda_0_5_p573_lanes[0];

  // link 2 (base_y), force propagation
  const Lanes Lambda_0_5_p591_lanes = Lambda_0_5_p543_lanes * inverse_D2;
  const Lanes Lambda_0_5_p597_lanes = Lambda_0_5_p591_lanes * Lambda_0_5_p543_lanes[0];

  // link 4 (link1), force propagation
  const Lanes Lambda_0_5_p603_lanes = detail::make_lanes<Real>(Lambda_0_5_p452, Lambda_0_5_p451,
      Lambda_0_5_p450, Lambda_0_5_p449, Lambda_0_5_p448, Lambda_0_5_p447, Lambda_0_5_p452,
      Lambda_0_5_p452) * inverse_D4;
  const Lanes Lambda_0_5_p609_lanes = Lambda_0_5_p603_lanes * Lambda_0_5_p452;

  // link 5 (link2), force propagation
  const Lanes Lambda_0_5_p615_lanes = Lambda_0_5_p369_lanes * inverse_D5;
  const Lanes Lambda_0_5_p621_lanes = Lambda_0_5_p615_lanes * Lambda_0_5_p369_lanes[0];

  // link 6 (link3), force propagation
  const Lanes Lambda_0_5_p627_lanes = Lambda_0_5_p261_lanes * inverse_D6;
  const Lanes Lambda_0_5_p633_lanes = Lambda_0_5_p627_lanes * Lambda_0_5_p261_lanes[0];

  // link 8 (link5), force propagation
  const Lanes Lambda_0_5_p639_lanes = 1557.24430048586 *
      detail::make_lanes<Real>(Lambda_0_5_p177_lanes[0], Lambda_0_5_p177_lanes[1],
      Lambda_0_5_p177_lanes[2], Lambda_0_5_p156_lanes[0], Lambda_0_5_p156_lanes[1],
      Lambda_0_5_p156_lanes[2], Lambda_0_5_p177_lanes[0], Lambda_0_5_p177_lanes[0]);
  const Lanes Lambda_0_5_p645_lanes = Lambda_0_5_p639_lanes * Lambda_0_5_p177_lanes[0];

  // link 7 (link4), force propagation
  const Lanes Lambda_0_5_p651_lanes = detail::make_lanes<Real>(Lambda_0_5_p131, Lambda_0_5_p130,
      Lambda_0_5_p129, Lambda_0_5_p128, Lambda_0_5_p127, Lambda_0_5_p126, Lambda_0_5_p131,
      Lambda_0_5_p131) * inverse_D7;
  const Lanes Lambda_0_5_p657_lanes = Lambda_0_5_p651_lanes * Lambda_0_5_p131;
  const Lanes Lambda_0_5_p663_lanes = Lambda_0_5_p645_lanes + Lambda_0_5_p657_lanes;

  // link 6 (link3), force propagation
  const Lanes Lambda_0_5_p669_lanes = Lambda_0_5_p663_lanes + Lambda_0_5_p633_lanes;

  // link 5 (link2), force propagation
  const Lanes Lambda_0_5_p675_lanes = Lambda_0_5_p669_lanes + Lambda_0_5_p621_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_0_5_p681_lanes = Lambda_0_5_p675_lanes + Lambda_0_5_p609_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_0_5_p687_lanes = Lambda_0_5_p681_lanes + Lambda_0_5_p597_lanes;

  // link 1 (base_x), force propagation
  const Lanes Lambda_0_5_p693_lanes = Lambda_0_5_p687_lanes + Lambda_0_5_p585_lanes;
  const Real Lambda_0_5_p699 = 1.0 / Lambda_0_5_p693_lanes[0];
  const Lanes Lambda_0_5_p700_lanes = Lambda_0_5_p693_lanes * Lambda_0_5_p699;
  const Lanes Lambda_0_5_p705_lanes = Lambda_0_5_p700_lanes * Lambda_0_5_p693_lanes[1];
  const Lanes Lambda_0_5_p710_lanes = Lambda_0_5_p579_lanes * Lambda_0_5_p573_lanes[1];

  // link 2 (base_y), force propagation
  const Lanes Lambda_0_5_p715_lanes = Lambda_0_5_p591_lanes * Lambda_0_5_p543_lanes[1];

  // link 4 (link1), force propagation
  const Lanes Lambda_0_5_p720_lanes = Lambda_0_5_p603_lanes * Lambda_0_5_p451;

  // link 5 (link2), force propagation
  const Lanes Lambda_0_5_p725_lanes = Lambda_0_5_p615_lanes * Lambda_0_5_p369_lanes[1];

  // link 6 (link3), force propagation
  const Lanes Lambda_0_5_p730_lanes = Lambda_0_5_p627_lanes * Lambda_0_5_p261_lanes[1];

  // link 8 (link5), force propagation
  const Lanes Lambda_0_5_p735_lanes = Lambda_0_5_p639_lanes * Lambda_0_5_p177_lanes[1];

  // link 7 (link4), force propagation
  const Lanes Lambda_0_5_p740_lanes = Lambda_0_5_p651_lanes * Lambda_0_5_p130;
  const Lanes Lambda_0_5_p745_lanes = Lambda_0_5_p735_lanes + Lambda_0_5_p740_lanes;

  // link 6 (link3), force propagation
  const Lanes Lambda_0_5_p750_lanes = Lambda_0_5_p745_lanes + Lambda_0_5_p730_lanes;

  // link 5 (link2), force propagation
  const Lanes Lambda_0_5_p755_lanes = Lambda_0_5_p750_lanes + Lambda_0_5_p725_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_0_5_p760_lanes = Lambda_0_5_p755_lanes + Lambda_0_5_p720_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_0_5_p765_lanes = Lambda_0_5_p760_lanes + Lambda_0_5_p715_lanes;

  // link 1 (base_x), force propagation
  const Lanes Lambda_0_5_p770_lanes = Lambda_0_5_p765_lanes + Lambda_0_5_p710_lanes;
  const Lanes Lambda_0_5_p775_lanes = Lambda_0_5_p770_lanes - Lambda_0_5_p705_lanes;
  const Real Lambda_0_5_p780 = 1.0 / Lambda_0_5_p775_lanes[1];
  const Lanes Lambda_0_5_p781_lanes = Lambda_0_5_p775_lanes * Lambda_0_5_p780;
  const Lanes Lambda_0_5_p785_lanes = Lambda_0_5_p781_lanes * Lambda_0_5_p775_lanes[2];
  const Lanes Lambda_0_5_p789_lanes = Lambda_0_5_p700_lanes * Lambda_0_5_p693_lanes[2];
  const Lanes Lambda_0_5_p793_lanes = Lambda_0_5_p579_lanes * Lambda_0_5_p573_lanes[2];

  // link 2 (base_y), force propagation
  const Lanes Lambda_0_5_p797_lanes = Lambda_0_5_p591_lanes * Lambda_0_5_p543_lanes[2];

  // link 4 (link1), force propagation
  const Lanes Lambda_0_5_p801_lanes = Lambda_0_5_p603_lanes * Lambda_0_5_p450;

  // link 5 (link2), force propagation
  const Lanes Lambda_0_5_p805_lanes = Lambda_0_5_p615_lanes * Lambda_0_5_p369_lanes[2];

  // link 6 (link3), force propagation
  const Lanes Lambda_0_5_p809_lanes = Lambda_0_5_p627_lanes * Lambda_0_5_p261_lanes[2];

  // link 8 (link5), force propagation
  const Lanes Lambda_0_5_p813_lanes = Lambda_0_5_p639_lanes * Lambda_0_5_p177_lanes[2];

  // link 7 (link4), force propagation
  const Lanes Lambda_0_5_p817_lanes = Lambda_0_5_p651_lanes * Lambda_0_5_p129;
  const Lanes Lambda_0_5_p821_lanes = Lambda_0_5_p813_lanes + Lambda_0_5_p817_lanes;

  // link 6 (link3), force propagation
  const Lanes Lambda_0_5_p825_lanes = Lambda_0_5_p821_lanes + Lambda_0_5_p809_lanes;

  // link 5 (link2), force propagation
  const Lanes Lambda_0_5_p829_lanes = Lambda_0_5_p825_lanes + Lambda_0_5_p805_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_0_5_p833_lanes = Lambda_0_5_p829_lanes + Lambda_0_5_p801_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_0_5_p837_lanes = Lambda_0_5_p833_lanes + Lambda_0_5_p797_lanes;

  // link 1 (base_x), force propagation
  const Lanes Lambda_0_5_p841_lanes = Lambda_0_5_p837_lanes + Lambda_0_5_p793_lanes;
  const Lanes Lambda_0_5_p845_lanes = Lambda_0_5_p841_lanes - Lambda_0_5_p789_lanes;
  const Lanes Lambda_0_5_p849_lanes = Lambda_0_5_p845_lanes - Lambda_0_5_p785_lanes;
  const Real Lambda_0_5_p853 = 1.0 / Lambda_0_5_p849_lanes[2];
  const Lanes Lambda_0_5_p854_lanes = Lambda_0_5_p849_lanes * Lambda_0_5_p853;
  const Lanes Lambda_0_5_p857_lanes = Lambda_0_5_p854_lanes * Lambda_0_5_p849_lanes[3];
  const Lanes Lambda_0_5_p860_lanes = Lambda_0_5_p781_lanes * Lambda_0_5_p775_lanes[3];
  const Lanes Lambda_0_5_p863_lanes = Lambda_0_5_p700_lanes * Lambda_0_5_p693_lanes[3];
  const Lanes Lambda_0_5_p866_lanes = Lambda_0_5_p579_lanes * Lambda_0_5_p573_lanes[3];

  // link 2 (base_y), force propagation
  const Lanes Lambda_0_5_p869_lanes = Lambda_0_5_p591_lanes * Lambda_0_5_p543_lanes[3];

  // link 4 (link1), force propagation
  const Lanes Lambda_0_5_p872_lanes = Lambda_0_5_p603_lanes * Lambda_0_5_p449;

  // link 5 (link2), force propagation
  const Lanes Lambda_0_5_p875_lanes = Lambda_0_5_p615_lanes * Lambda_0_5_p369_lanes[3];

  // link 6 (link3), force propagation
  const Lanes Lambda_0_5_p878_lanes = Lambda_0_5_p627_lanes * Lambda_0_5_p261_lanes[3];

  // link 8 (link5), force propagation
  const Lanes Lambda_0_5_p881_lanes = Lambda_0_5_p639_lanes * Lambda_0_5_p156_lanes[0];

  // link 9 (link6), force propagation
  const Lanes Lambda_0_5_p884_lanes = 24999.999999999996 *
      detail::make_lanes<Real>(Lambda_0_5_p189, Lambda_0_5_p189, Lambda_0_5_p189, Lambda_0_5_p189,
      Lambda_0_5_p185, Lambda_0_5_p181, Lambda_0_5_p189, Lambda_0_5_p189);
  const Lanes Lambda_0_5_p887_lanes = Lambda_0_5_p884_lanes * Lambda_0_5_p189;

  // link 8 (link5), force propagation
  const Lanes Lambda_0_5_p890_lanes = Lambda_0_5_p887_lanes + Lambda_0_5_p881_lanes;

  // link 7 (link4), force propagation
  const Lanes Lambda_0_5_p893_lanes = Lambda_0_5_p651_lanes * Lambda_0_5_p128;
  const Lanes Lambda_0_5_p896_lanes = Lambda_0_5_p890_lanes + Lambda_0_5_p893_lanes;

  // link 6 (link3), force propagation
  const Lanes Lambda_0_5_p899_lanes = Lambda_0_5_p896_lanes + Lambda_0_5_p878_lanes;

  // link 5 (link2), force propagation
  const Lanes Lambda_0_5_p902_lanes = Lambda_0_5_p899_lanes + Lambda_0_5_p875_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_0_5_p905_lanes = Lambda_0_5_p902_lanes + Lambda_0_5_p872_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_0_5_p908_lanes = Lambda_0_5_p905_lanes + Lambda_0_5_p869_lanes;

  // link 1 (base_x), force propagation
  const Lanes Lambda_0_5_p911_lanes = Lambda_0_5_p908_lanes + Lambda_0_5_p866_lanes;
  const Lanes Lambda_0_5_p914_lanes = Lambda_0_5_p911_lanes - Lambda_0_5_p863_lanes;
  const Lanes Lambda_0_5_p917_lanes = Lambda_0_5_p914_lanes - Lambda_0_5_p860_lanes;
  const Lanes Lambda_0_5_p920_lanes = Lambda_0_5_p917_lanes - Lambda_0_5_p857_lanes;
  const Real Lambda_0_5_p923 = 1.0 / Lambda_0_5_p920_lanes[3];
  const Real Lambda_0_5_p924 = Lambda_0_5_p920_lanes[5] * Lambda_0_5_p923;

  // link 9 (link6), force propagation
  const Lanes Lambda_0_5_p925_lanes = Lambda_0_5_p884_lanes * Lambda_0_5_p185;

  // link 5 (link2), force propagation
  const Real Lambda_0_5_p927 = Lambda_0_5_p925_lanes[5] + Lambda_0_5_p639_lanes[5] *
      Lambda_0_5_p156_lanes[1] + Lambda_0_5_p651_lanes[5] * Lambda_0_5_p127 +
      Lambda_0_5_p627_lanes[5] * Lambda_0_5_p261_lanes[4] + Lambda_0_5_p615_lanes[5] *
      Lambda_0_5_p369_lanes[4];

  // link 1 (base_x), force propagation
  const Real Lambda_0_5_p928 = Lambda_0_5_p927 + Lambda_0_5_p603_lanes[5] * Lambda_0_5_p448 +
      Lambda_0_5_p591_lanes[5] * Lambda_0_5_p543_lanes[4] + Lambda_0_5_p579_lanes[5] *
      Lambda_0_5_p573_lanes[4] - Lambda_0_5_p700_lanes[5] * Lambda_0_5_p693_lanes[4];
  const Real Lambda_0_5_p929 = Lambda_0_5_p928 - Lambda_0_5_p781_lanes[5] *
      Lambda_0_5_p775_lanes[4] - Lambda_0_5_p854_lanes[5] * Lambda_0_5_p849_lanes[4] -
      Lambda_0_5_p924 * Lambda_0_5_p920_lanes[4];
  const Real Lambda_0_5_p930 = Lambda_0_5_p920_lanes[4] * Lambda_0_5_p923;

  // link 5 (link2), force propagation
  const Real Lambda_0_5_p931 = Lambda_0_5_p925_lanes[4] + Lambda_0_5_p639_lanes[4] *
      Lambda_0_5_p156_lanes[1] + Lambda_0_5_p651_lanes[4] * Lambda_0_5_p127 +
      Lambda_0_5_p627_lanes[4] * Lambda_0_5_p261_lanes[4] + Lambda_0_5_p615_lanes[4] *
      Lambda_0_5_p369_lanes[4];

  // link 1 (base_x), force propagation
  const Real Lambda_0_5_p932 = Lambda_0_5_p931 + Lambda_0_5_p603_lanes[4] * Lambda_0_5_p448 +
      Lambda_0_5_p591_lanes[4] * Lambda_0_5_p543_lanes[4] + Lambda_0_5_p579_lanes[4] *
      Lambda_0_5_p573_lanes[4] - Lambda_0_5_p700_lanes[4] * Lambda_0_5_p693_lanes[4];
  const Real Lambda_0_5_p933 = 1.0 / (Lambda_0_5_p932 - Lambda_0_5_p781_lanes[4] *
      Lambda_0_5_p775_lanes[4] - Lambda_0_5_p854_lanes[4] * Lambda_0_5_p849_lanes[4] -
      Lambda_0_5_p930 * Lambda_0_5_p920_lanes[4]);
  const Real Lambda_0_5_p934 = Lambda_0_5_p929 * Lambda_0_5_p933;
  const Real Lambda_0_5_p935 = Lambda_0_5_p781_lanes[2] * Lambda_0_5_p700_lanes[1] -
      Lambda_0_5_p700_lanes[2];
  const Real Lambda_0_5_p936 = Lambda_0_5_p781_lanes[3] * Lambda_0_5_p700_lanes[1] -
      Lambda_0_5_p700_lanes[3] - Lambda_0_5_p854_lanes[3] * Lambda_0_5_p935;
  const Real Lambda_0_5_p937 = Lambda_0_5_p781_lanes[4] * Lambda_0_5_p700_lanes[1] -
      Lambda_0_5_p700_lanes[4] - Lambda_0_5_p854_lanes[4] * Lambda_0_5_p935 - Lambda_0_5_p930 *
      Lambda_0_5_p936;
  const Real Lambda_0_5_p938 = Lambda_0_5_p781_lanes[5] * Lambda_0_5_p700_lanes[1] -
      Lambda_0_5_p700_lanes[5] - Lambda_0_5_p854_lanes[5] * Lambda_0_5_p935 - Lambda_0_5_p924 *
      Lambda_0_5_p936 - Lambda_0_5_p934 * Lambda_0_5_p937;

  // link 5 (link2), force propagation
  const Real Lambda_5_5_p1 = Lambda_0_5_p884_lanes[5] * Lambda_0_5_p181 + Lambda_0_5_p639_lanes[5] *
      Lambda_0_5_p156_lanes[2] + Lambda_0_5_p651_lanes[5] * Lambda_0_5_p126 +
      Lambda_0_5_p627_lanes[5] * Lambda_0_5_p261_lanes[5] + Lambda_0_5_p615_lanes[5] *
      Lambda_0_5_p369_lanes[5];

  // link 1 (base_x), force propagation
  const Real Lambda_5_5_p2 = Lambda_5_5_p1 + Lambda_0_5_p603_lanes[5] * Lambda_0_5_p447 +
      Lambda_0_5_p591_lanes[5] * Lambda_0_5_p543_lanes[5] + Lambda_0_5_p579_lanes[5] *
      Lambda_0_5_p573_lanes[5] - Lambda_0_5_p700_lanes[5] * Lambda_0_5_p693_lanes[5];
  const Real Lambda_5_5_p3 = Lambda_5_5_p2 - Lambda_0_5_p781_lanes[5] * Lambda_0_5_p775_lanes[5] -
      Lambda_0_5_p854_lanes[5] * Lambda_0_5_p849_lanes[5] - Lambda_0_5_p924 *
      Lambda_0_5_p920_lanes[5] - Lambda_0_5_p934 * Lambda_0_5_p929;
  const Real Lambda_5_5 = 1.0 / Lambda_5_5_p3;
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5 = Lambda_0_5_p938 * Lambda_5_5;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_0_0_p1 = Lambda_0_5_p937 * Lambda_0_5_p933;
  const Real Lambda_0_0_p2 = Lambda_0_5_p936 * Lambda_0_5_p923;
  const Real Lambda_0_0_p3 = Lambda_0_5_p935 * Lambda_0_5_p853;
  const Real Lambda_0_0_p4 = Lambda_0_5_p700_lanes[1] * Lambda_0_5_p780;
  const Real Lambda_0_0_p5 = Lambda_0_5_p699 + Lambda_0_0_p4 * Lambda_0_5_p700_lanes[1] +
      Lambda_0_0_p3 * Lambda_0_5_p935 + Lambda_0_0_p2 * Lambda_0_5_p936 + Lambda_0_0_p1 *
      Lambda_0_5_p937;
  Lambda[0] = Lambda_0_0_p5 + Lambda_0_5 * Lambda_0_5_p938;
  const Real Lambda_1_5_p1 = Lambda_0_5_p854_lanes[3] * Lambda_0_5_p781_lanes[2] -
      Lambda_0_5_p781_lanes[3];
  const Real Lambda_1_5_p2 = Lambda_0_5_p854_lanes[4] * Lambda_0_5_p781_lanes[2] -
      Lambda_0_5_p781_lanes[4] - Lambda_0_5_p930 * Lambda_1_5_p1;
  const Real Lambda_1_5_p3 = Lambda_0_5_p854_lanes[5] * Lambda_0_5_p781_lanes[2] -
      Lambda_0_5_p781_lanes[5] - Lambda_0_5_p924 * Lambda_1_5_p1 - Lambda_0_5_p934 * Lambda_1_5_p2;
  const Real Lambda_1_5 = Lambda_1_5_p3 * Lambda_5_5;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_0_1_p1 = Lambda_1_5_p2 * Lambda_0_5_p933;
  const Real Lambda_0_1_p2 = Lambda_1_5_p1 * Lambda_0_5_p923;
  const Real Lambda_0_1_p3 = Lambda_0_5_p781_lanes[2] * Lambda_0_5_p853;
  const Real Lambda_0_1 = Lambda_0_1_p2 * Lambda_0_5_p936 -
      (Lambda_0_0_p4 + Lambda_0_1_p3 * Lambda_0_5_p935) + Lambda_0_1_p1 * Lambda_0_5_p937 +
      Lambda_1_5 * Lambda_0_5_p938;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_2_5_p1 = Lambda_0_5_p930 * Lambda_0_5_p854_lanes[3] - Lambda_0_5_p854_lanes[4];
  const Real Lambda_2_5_p2 = Lambda_0_5_p924 * Lambda_0_5_p854_lanes[3] - Lambda_0_5_p854_lanes[5] -
      Lambda_0_5_p934 * Lambda_2_5_p1;
  const Real Lambda_2_5 = Lambda_2_5_p2 * Lambda_5_5;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_0_2_p1 = Lambda_2_5_p1 * Lambda_0_5_p933;
  const Real Lambda_0_2_p2 = Lambda_0_5_p854_lanes[3] * Lambda_0_5_p923;
  const Real Lambda_0_2 = Lambda_0_0_p3 - Lambda_0_2_p2 * Lambda_0_5_p936 + Lambda_0_2_p1 *
      Lambda_0_5_p937 + Lambda_2_5 * Lambda_0_5_p938;
  Lambda[2] = Lambda_0_2;
  Lambda[12] = Lambda_0_2;
  const Real Lambda_3_5_p1 = Lambda_0_5_p934 * Lambda_0_5_p930 - Lambda_0_5_p924;
  const Real Lambda_3_5 = Lambda_3_5_p1 * Lambda_5_5;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_0_3_p1 = Lambda_0_5_p930 * Lambda_0_5_p933;
  const Real Lambda_0_3 = Lambda_0_0_p2 - Lambda_0_3_p1 * Lambda_0_5_p937 + Lambda_3_5 *
      Lambda_0_5_p938;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_4_5 = Lambda_0_5_p934 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  const Real Lambda_0_4 = Lambda_0_0_p1 - Lambda_4_5 * Lambda_0_5_p938;
  Lambda[4] = Lambda_0_4;
  Lambda[24] = Lambda_0_4;
  Lambda[7] = Lambda_0_5_p780 + Lambda_0_1_p3 * Lambda_0_5_p781_lanes[2] + Lambda_0_1_p2 *
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
  Lambda[14] = Lambda_0_5_p853 + Lambda_0_2_p2 * Lambda_0_5_p854_lanes[3] + Lambda_0_2_p1 *
      Lambda_2_5_p1 + Lambda_2_5 * Lambda_2_5_p2;
  const Real Lambda_2_3 = Lambda_3_5 * Lambda_2_5_p2 -
      (Lambda_0_2_p2 + Lambda_0_3_p1 * Lambda_2_5_p1);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p1 - Lambda_4_5 * Lambda_2_5_p2;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_0_5_p923 + Lambda_0_3_p1 * Lambda_0_5_p930 + Lambda_3_5 * Lambda_3_5_p1;
  const Real Lambda_3_4 = Lambda_0_3_p1 + Lambda_4_5 * Lambda_3_5_p1;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_0_5_p933 + Lambda_4_5 * Lambda_0_5_p934;
}

}  // namespace samm

#undef TREELINE_RESTRICT
