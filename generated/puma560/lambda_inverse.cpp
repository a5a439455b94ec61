// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J carried inward, in the axes of link 2 (link2) at link origins.
// 560 flops (add 233, mul 323, div 4), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void lambda_inverse(const Real (&TREELINE_RESTRICT q)[6],
    Real (&TREELINE_RESTRICT Lambda_inv)[36]) noexcept {
  const Real angles[5] = {q[1], q[2], q[3], q[4], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real s4 = sines[2];
  const Real s5 = sines[3];
  const Real c4 = cosines[2];
  const Real c5 = cosines[3];
  const Real s1 = sines[4];
  const Real c1 = cosines[4];

  // link 5 (link5), composite inertia
  const Real Lambda_inv_0_0_p1 = 0.0028799999999999997 * s5;
  const Real Lambda_inv_0_0_p2 = 0.0028799999999999997 * c5;
  const Real Lambda_inv_0_0_p3 = 0.00020215999999999998 * s5;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p4 = 0.9999999999999999 * c5;

  // link 6 (link6), mass matrix
  const Real Lambda_inv_0_0_p5 = 4e-05 * c5;
  const Real Lambda_inv_0_0_p6 = 4e-05 * s5;
  const Real Lambda_inv_0_0_p7 = 0.4318 * c2;
  const Real Lambda_inv_0_0_p8 = 0.4318 * s2;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_0_p9 = c4 * Lambda_inv_0_0_p1;
  const Real Lambda_inv_0_0_p10 = s2 * s3 - c2 * c3;
  const Real Lambda_inv_0_0_p11 = s4 * Lambda_inv_0_0_p1;
  const Real Lambda_inv_0_0_p12 = s2 * c3 + c2 * s3;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_0_0_p13 = c4 * Lambda_inv_0_0_p2;

  // link 5 (link5), composite inertia
  const Real Lambda_inv_0_0_p14 = s5 * Lambda_inv_0_0_p3;
  const Real Lambda_inv_0_0_p15 = c5 * Lambda_inv_0_0_p3;

  // link 6 (link6), mass matrix
  const Real Lambda_inv_0_0_p16 = s4 * Lambda_inv_0_0_p6;

  // link 5 (link5), composite inertia
  const Real Lambda_inv_0_0_p17 = 0.00164 + Lambda_inv_0_0_p14;

  // link 4 (link4), mass matrix
  const Real Lambda_inv_0_0_p18 = Lambda_inv_0_0_p10 * Lambda_inv_0_0_p11;
  const Real Lambda_inv_0_0_p19 = Lambda_inv_0_0_p12 * Lambda_inv_0_0_p11;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_0_p20 = s4 * Lambda_inv_0_0_p15;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p21 = 24999.999999999996 * Lambda_inv_0_0_p16;
  const Real Lambda_inv_0_0_p22 = 0.0203 * Lambda_inv_0_0_p10 + 0.4331 * Lambda_inv_0_0_p12;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_0_p23 = Lambda_inv_0_0_p10 * Lambda_inv_0_0_p9 - Lambda_inv_0_0_p12 *
      Lambda_inv_0_0_p2;
  const Real Lambda_inv_0_0_p24 = 0.0203 * Lambda_inv_0_0_p12 - 0.4331 * Lambda_inv_0_0_p10;
  const Real Lambda_inv_0_0_p25 = Lambda_inv_0_0_p12 * Lambda_inv_0_0_p9 + Lambda_inv_0_0_p10 *
      Lambda_inv_0_0_p2;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_0_0_p26 = Lambda_inv_0_0_p10 * Lambda_inv_0_0_p1 - Lambda_inv_0_0_p12 *
      Lambda_inv_0_0_p13;
  const Real Lambda_inv_0_0_p27 = Lambda_inv_0_0_p10 * Lambda_inv_0_0_p13 + Lambda_inv_0_0_p12 *
      Lambda_inv_0_0_p1;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_0_p28 = s4 * (0.00010000000000000026 + Lambda_inv_0_0_p14);
  const Real Lambda_inv_0_0_p29 = Lambda_inv_0_0_p22 * Lambda_inv_0_0_p23;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p30 = 1.0 / (Lambda_inv_0_0_p17 - Lambda_inv_0_0_p4 *
      Lambda_inv_0_0_p5);

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_0_p31 = s4 * Lambda_inv_0_0_p28;
  const Real Lambda_inv_0_0_p32 = Lambda_inv_0_0_p12 * c4;
  const Real Lambda_inv_0_0_p33 = c4 * Lambda_inv_0_0_p15;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_0_0_p34 = Lambda_inv_0_0_p12 * s4;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_0_p35 = 0.025374999999999998 * Lambda_inv_0_0_p12 - 0.861795 *
      Lambda_inv_0_0_p10 - Lambda_inv_0_0_p25;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_0_0_p36 = 0.00064216 * c4 -
      (Lambda_inv_0_0_p22 * Lambda_inv_0_0_p26 + Lambda_inv_0_0_p24 * Lambda_inv_0_0_p27);

  // link 3 (link3), composite inertia
  const Real Lambda_inv_0_0_p37 = Lambda_inv_0_0_p7 *
      (Lambda_inv_0_0_p23 - (0.025374999999999998 * Lambda_inv_0_0_p10 + 0.861795 *
      Lambda_inv_0_0_p12));

  // link 5 (link5), mass matrix
  const Real Lambda_inv_0_0_p38 = Lambda_inv_0_0_p22 + Lambda_inv_0_0_p7;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p39 = Lambda_inv_0_0_p24 * Lambda_inv_0_0_p18 - Lambda_inv_0_0_p22 *
      Lambda_inv_0_0_p19 - Lambda_inv_0_0_p20 - Lambda_inv_0_0_p4 * Lambda_inv_0_0_p16;
  const Real Lambda_inv_0_0_p40 = 1557.24430048586 * Lambda_inv_0_0_p36;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_0_0_p41 = Lambda_inv_0_0_p36 +
      (Lambda_inv_0_0_p8 * Lambda_inv_0_0_p27 - Lambda_inv_0_0_p7 * Lambda_inv_0_0_p26);

  // link 6 (link6), mass matrix
  const Real Lambda_inv_0_0_p42 = Lambda_inv_0_0_p32 * Lambda_inv_0_0_p6 + Lambda_inv_0_0_p10 *
      Lambda_inv_0_0_p5;

  // link 3 (link3), composite inertia
  const Real Lambda_inv_0_0_p43 = Lambda_inv_0_0_p37 + Lambda_inv_0_0_p8 * Lambda_inv_0_0_p35;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p44 = Lambda_inv_0_0_p39 * Lambda_inv_0_0_p30;
  const Real Lambda_inv_0_0_p45 = 1557.24430048586 * Lambda_inv_0_0_p41;
  const Real Lambda_inv_0_0_p46 = Lambda_inv_0_0_p39 - Lambda_inv_0_0_p7 * Lambda_inv_0_0_p19 -
      Lambda_inv_0_0_p8 * Lambda_inv_0_0_p18;

  // link 3 (link3), mass matrix
  const Real Lambda_inv_0_0_p47 = Lambda_inv_0_0_p32 * Lambda_inv_0_0_p28 - Lambda_inv_0_0_p24 *
      Lambda_inv_0_0_p11 + (0.004704000000000001 + Lambda_inv_0_0_p20) * Lambda_inv_0_0_p10 -
      0.1501 * Lambda_inv_0_0_p35;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_0_0_p48 = 0.00064216 * Lambda_inv_0_0_p34 + 0.1501 * Lambda_inv_0_0_p27 +
      Lambda_inv_0_0_p38 * (s4 * Lambda_inv_0_0_p2);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p49 = 0.312455249 + (0.00129216 - Lambda_inv_0_0_p31 - 2.0 *
      (Lambda_inv_0_0_p29 + Lambda_inv_0_0_p24 * Lambda_inv_0_0_p25)) - Lambda_inv_0_0_p21 *
      Lambda_inv_0_0_p16;
  const Real Lambda_inv_0_0_p50 = Lambda_inv_0_0_p46 * Lambda_inv_0_0_p30;
  const Real Lambda_inv_0_0_p51 = 24999.999999999996 * Lambda_inv_0_0_p42;
  const Real Lambda_inv_0_0_p52 = Lambda_inv_0_0_p47 + Lambda_inv_0_0_p21 * Lambda_inv_0_0_p42;
  const Real Lambda_inv_0_0_p53 = Lambda_inv_0_0_p12 * Lambda_inv_0_0_p33 - Lambda_inv_0_0_p10 *
      Lambda_inv_0_0_p17 - 0.1501 * Lambda_inv_0_0_p18 + Lambda_inv_0_0_p4 * Lambda_inv_0_0_p42 +
      Lambda_inv_0_0_p38 * Lambda_inv_0_0_p9;
  const Real Lambda_inv_0_0_p54 = 1557.24430048586 * Lambda_inv_0_0_p48;
  const Real Lambda_inv_0_0_p55 = Lambda_inv_0_0_p53 * Lambda_inv_0_0_p30;
  const Real Lambda_inv_0_0_p56 = 1.0 / (Lambda_inv_0_0_p49 - Lambda_inv_0_0_p40 *
      Lambda_inv_0_0_p36 - Lambda_inv_0_0_p44 * Lambda_inv_0_0_p39);
  const Real Lambda_inv_0_0_p57 = Lambda_inv_0_0_p49 - Lambda_inv_0_0_p43 - Lambda_inv_0_0_p40 *
      Lambda_inv_0_0_p41 - Lambda_inv_0_0_p44 * Lambda_inv_0_0_p46;
  const Real Lambda_inv_0_0_p58 = Lambda_inv_0_0_p52 - Lambda_inv_0_0_p40 * Lambda_inv_0_0_p48 -
      Lambda_inv_0_0_p44 * Lambda_inv_0_0_p53;

  // link 5 (link5), pose
  const Real Lambda_inv_0_0_p59 = s5 * s4;
  const Real Lambda_inv_5_5_p1 = s5 * Lambda_inv_0_0_p32 + c5 * Lambda_inv_0_0_p10;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p60 = 0.690314699 * s2 + 0.023750999999999998 * c2 +
      Lambda_inv_0_0_p52 + Lambda_inv_0_0_p8 * Lambda_inv_0_0_p11 - Lambda_inv_0_0_p45 *
      Lambda_inv_0_0_p48;
  const Real Lambda_inv_5_5_p2 = Lambda_inv_0_0_p21 * Lambda_inv_5_5_p1;
  const Real Lambda_inv_0_0_p61 = Lambda_inv_0_0_p4 * Lambda_inv_0_0_p59;
  const Real Lambda_inv_0_0_p62 = 3.153482265 - s2 * (1.601861202 * s2 + 0.0141984 * c2) +
      Lambda_inv_0_0_p17 - Lambda_inv_0_0_p51 * Lambda_inv_0_0_p42;
  const Real Lambda_inv_5_5_p3 = Lambda_inv_0_0_p4 * Lambda_inv_5_5_p1 - Lambda_inv_0_0_p10;
  const Real Lambda_inv_0_0_p63 = 24999.999999999996 * Lambda_inv_0_0_p59;
  const Real Lambda_inv_0_0_p64 = 1.0 - Lambda_inv_0_0_p21 * Lambda_inv_0_0_p59;
  const Real Lambda_inv_0_0_p65 = 0.298925024 * Lambda_inv_0_0_p12 + 0.021347276999999998 *
      Lambda_inv_0_0_p10 - (Lambda_inv_0_0_p10 * (2.0 * Lambda_inv_0_0_p33) - Lambda_inv_0_0_p12 *
      (0.0011921599999999998 - Lambda_inv_0_0_p14 + Lambda_inv_0_0_p31 - Lambda_inv_0_0_p17));

  // link 4 (link4), pose
  const Real Lambda_inv_0_0_p66 = s4 * Lambda_inv_0_0_p10;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p67 = Lambda_inv_0_0_p57 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_0_p68 = Lambda_inv_0_0_p58 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_0_p69 = 1557.24430048586 * c4;
  const Real Lambda_inv_5_5_p4 = 24999.999999999996 * Lambda_inv_5_5_p1;
  const Real Lambda_inv_0_0_p70 = Lambda_inv_0_0_p64 - Lambda_inv_0_0_p40 * c4 +
      Lambda_inv_0_0_p44 * Lambda_inv_0_0_p61;
  const Real Lambda_inv_5_5_p5 = Lambda_inv_5_5_p2 - Lambda_inv_0_0_p40 * Lambda_inv_0_0_p34 -
      Lambda_inv_0_0_p44 * Lambda_inv_5_5_p3;
  const Real Lambda_inv_5_5_p6 = 1557.24430048586 * Lambda_inv_0_0_p34;
  const Real Lambda_inv_0_0_p71 = Lambda_inv_0_0_p61 * Lambda_inv_0_0_p30;
  const Real Lambda_inv_5_5_p7 = Lambda_inv_5_5_p3 * Lambda_inv_0_0_p30;

  // link 5 (link5), pose
  const Real Lambda_inv_0_0_p72 = c5 * Lambda_inv_0_0_p12 - s5 * (c4 * Lambda_inv_0_0_p10);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p73 = 1.7481140020000001 + Lambda_inv_0_0_p49 - 2.0 *
      Lambda_inv_0_0_p43 - Lambda_inv_0_0_p45 * Lambda_inv_0_0_p41 - Lambda_inv_0_0_p50 *
      Lambda_inv_0_0_p46 - Lambda_inv_0_0_p67 * Lambda_inv_0_0_p57;
  const Real Lambda_inv_0_0_p74 = Lambda_inv_0_0_p60 - Lambda_inv_0_0_p50 * Lambda_inv_0_0_p53 -
      Lambda_inv_0_0_p67 * Lambda_inv_0_0_p58;
  const Real Lambda_inv_0_0_p75 = Lambda_inv_0_0_p64 - Lambda_inv_0_0_p45 * c4 +
      Lambda_inv_0_0_p50 * Lambda_inv_0_0_p61 - Lambda_inv_0_0_p67 * Lambda_inv_0_0_p70;
  const Real Lambda_inv_5_5_p8 = Lambda_inv_5_5_p2 - Lambda_inv_0_0_p45 * Lambda_inv_0_0_p34 -
      Lambda_inv_0_0_p50 * Lambda_inv_5_5_p3 - Lambda_inv_0_0_p67 * Lambda_inv_5_5_p5;
  const Real Lambda_inv_0_0_p76 = Lambda_inv_0_0_p21 * Lambda_inv_0_0_p72;
  const Real Lambda_inv_0_0_p77 = 1.0 / Lambda_inv_0_0_p73;
  const Real Lambda_inv_0_0_p78 = Lambda_inv_0_0_p70 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_5_5_p9 = 1.0 - Lambda_inv_0_0_p51 * Lambda_inv_5_5_p1 - Lambda_inv_0_0_p54 *
      Lambda_inv_0_0_p34 - Lambda_inv_0_0_p55 * Lambda_inv_5_5_p3 - Lambda_inv_0_0_p68 *
      Lambda_inv_5_5_p5;
  const Real Lambda_inv_5_5_p10 = Lambda_inv_5_5_p5 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_0_p79 = Lambda_inv_0_0_p4 * Lambda_inv_0_0_p72 - Lambda_inv_0_0_p12;
  const Real Lambda_inv_0_0_p80 = Lambda_inv_0_0_p8 + (Lambda_inv_0_0_p67 - 1.0) *
      Lambda_inv_0_0_p24;
  const Real Lambda_inv_0_0_p81 = Lambda_inv_0_0_p76 + Lambda_inv_0_0_p40 * Lambda_inv_0_0_p66 -
      Lambda_inv_0_0_p44 * Lambda_inv_0_0_p79;
  const Real Lambda_inv_0_0_p82 = 0.05625 * Lambda_inv_5_5_p1;
  const Real Lambda_inv_0_0_p83 = 0.05625 * Lambda_inv_0_0_p59;
  const Real Lambda_inv_0_0_p84 = Lambda_inv_0_0_p74 * Lambda_inv_0_0_p77;
  const Real Lambda_inv_0_0_p85 = Lambda_inv_0_0_p81 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_0_p86 = Lambda_inv_0_0_p75 * Lambda_inv_0_0_p77;
  const Real Lambda_inv_5_5_p11 = Lambda_inv_5_5_p8 * Lambda_inv_0_0_p77;
  const Real Lambda_inv_0_0_p87 = 24999.999999999996 * Lambda_inv_0_0_p72 * Lambda_inv_0_0_p72 +
      1557.24430048586 * Lambda_inv_0_0_p66 * Lambda_inv_0_0_p66 + Lambda_inv_0_0_p79 *
      Lambda_inv_0_0_p30 * Lambda_inv_0_0_p79;
  const Real Lambda_inv_0_0_p88 = 0.05625 * Lambda_inv_0_0_p72;
  const Real Lambda_inv_0_0_p89 = Lambda_inv_0_0_p76 + Lambda_inv_0_0_p45 * Lambda_inv_0_0_p66 -
      Lambda_inv_0_0_p50 * Lambda_inv_0_0_p79 - Lambda_inv_0_0_p67 * Lambda_inv_0_0_p81;
  const Real Lambda_inv_0_0_p90 = Lambda_inv_0_0_p89 * Lambda_inv_0_0_p77;
  const Real Lambda_inv_0_0_p91 = Lambda_inv_0_0_p62 - Lambda_inv_0_0_p54 * Lambda_inv_0_0_p48 -
      Lambda_inv_0_0_p55 * Lambda_inv_0_0_p53 - Lambda_inv_0_0_p68 * Lambda_inv_0_0_p58 -
      Lambda_inv_0_0_p84 * Lambda_inv_0_0_p74;
  const Real Lambda_inv_0_0_p92 = Lambda_inv_0_0_p51 * Lambda_inv_0_0_p59 - Lambda_inv_0_0_p54 *
      c4 + Lambda_inv_0_0_p55 * Lambda_inv_0_0_p61 - Lambda_inv_0_0_p68 * Lambda_inv_0_0_p70 -
      Lambda_inv_0_0_p84 * Lambda_inv_0_0_p75;
  const Real Lambda_inv_5_5_p12 = Lambda_inv_5_5_p9 - Lambda_inv_0_0_p84 * Lambda_inv_5_5_p8;
  const Real Lambda_inv_0_0_p93 = Lambda_inv_0_0_p63 * Lambda_inv_0_0_p59 + Lambda_inv_0_0_p69 *
      c4 + Lambda_inv_0_0_p71 * Lambda_inv_0_0_p61 + Lambda_inv_0_0_p78 * Lambda_inv_0_0_p70 +
      Lambda_inv_0_0_p86 * Lambda_inv_0_0_p75;
  const Real Lambda_inv_0_0_p94 = Lambda_inv_0_0_p69 * Lambda_inv_0_0_p34 - Lambda_inv_0_0_p63 *
      Lambda_inv_5_5_p1 - Lambda_inv_0_0_p71 * Lambda_inv_5_5_p3 + Lambda_inv_0_0_p78 *
      Lambda_inv_5_5_p5 + Lambda_inv_0_0_p86 * Lambda_inv_5_5_p8;
  const Real Lambda_inv_5_5_p13 = Lambda_inv_5_5_p4 * Lambda_inv_5_5_p1 + Lambda_inv_5_5_p6 *
      Lambda_inv_0_0_p34 + Lambda_inv_5_5_p7 * Lambda_inv_5_5_p3 + Lambda_inv_5_5_p10 *
      Lambda_inv_5_5_p5 + Lambda_inv_5_5_p11 * Lambda_inv_5_5_p8;
  const Real Lambda_inv_0_0_p95 = 0.1501 + Lambda_inv_0_0_p68 * Lambda_inv_0_0_p24 -
      Lambda_inv_0_0_p84 * Lambda_inv_0_0_p80;
  const Real Lambda_inv_0_0_p96 = Lambda_inv_0_0_p54 * Lambda_inv_0_0_p66 - Lambda_inv_0_0_p51 *
      Lambda_inv_0_0_p72 - Lambda_inv_0_0_p55 * Lambda_inv_0_0_p79 - Lambda_inv_0_0_p68 *
      Lambda_inv_0_0_p81 - Lambda_inv_0_0_p84 * Lambda_inv_0_0_p89;
  const Real Lambda_inv_0_0_p97 = Lambda_inv_5_5_p4 * Lambda_inv_0_0_p72 - Lambda_inv_5_5_p6 *
      Lambda_inv_0_0_p66 + Lambda_inv_5_5_p7 * Lambda_inv_0_0_p79 + Lambda_inv_5_5_p10 *
      Lambda_inv_0_0_p81 + Lambda_inv_5_5_p11 * Lambda_inv_0_0_p89;
  const Real Lambda_inv_0_0_p98 = Lambda_inv_0_0_p78 * Lambda_inv_0_0_p81 -
      (Lambda_inv_0_0_p63 * Lambda_inv_0_0_p72 + Lambda_inv_0_0_p69 * Lambda_inv_0_0_p66 +
      Lambda_inv_0_0_p71 * Lambda_inv_0_0_p79) + Lambda_inv_0_0_p86 * Lambda_inv_0_0_p89;
  const Real Lambda_inv_0_2_p1 = Lambda_inv_0_0_p67 * Lambda_inv_0_0_p22 - Lambda_inv_0_0_p38;
  const Real Lambda_inv_0_2_p2 = Lambda_inv_0_0_p22 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_2_p3 = Lambda_inv_0_2_p1 * Lambda_inv_0_0_p77;

  // link 1 (link1), turn
  const Real Lambda_inv_3_3_p1 = 2.0 * c1;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p99 = 1.0 / (Lambda_inv_0_0_p91 + 2.0 *
      (0.1501 * Lambda_inv_0_0_p11 - Lambda_inv_0_0_p37 - Lambda_inv_0_0_p29) + Lambda_inv_0_0_p65 *
      Lambda_inv_0_0_p12);
  const Real Lambda_inv_0_2_p4 = Lambda_inv_0_0_p68 * Lambda_inv_0_0_p22 - Lambda_inv_0_0_p84 *
      Lambda_inv_0_2_p1;
  const Real Lambda_inv_0_0_p100 = Lambda_inv_0_0_p92 * Lambda_inv_0_0_p99;
  const Real Lambda_inv_5_5_p14 = Lambda_inv_5_5_p12 * Lambda_inv_0_0_p99;
  const Real Lambda_inv_0_0_p101 = Lambda_inv_0_0_p96 * Lambda_inv_0_0_p99;
  const Real Lambda_inv_0_0_p102 = Lambda_inv_0_0_p38 * Lambda_inv_0_0_p99;
  const Real Lambda_inv_0_2_p5 = Lambda_inv_0_2_p4 * Lambda_inv_0_0_p99;
  const Real Lambda_inv_0_2_p6 = Lambda_inv_0_0_p101 * Lambda_inv_0_0_p38;
  const Real Lambda_inv_0_0_p103 = Lambda_inv_5_5_p14 * Lambda_inv_0_0_p38;
  const Real Lambda_inv_0_3_p1 = Lambda_inv_0_0_p100 * Lambda_inv_0_0_p38;
  const Real Lambda_inv_0_0_p104 = Lambda_inv_0_0_p93 + Lambda_inv_0_0_p100 * Lambda_inv_0_0_p92;
  const Real Lambda_inv_0_0_p105 = Lambda_inv_0_0_p94 + Lambda_inv_0_0_p100 * Lambda_inv_5_5_p12;
  const Real Lambda_inv_5_5 = Lambda_inv_5_5_p13 + Lambda_inv_5_5_p14 * Lambda_inv_5_5_p12;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real Lambda_inv_0_0_p106 = Lambda_inv_0_0_p87 + Lambda_inv_0_0_p85 * Lambda_inv_0_0_p81 +
      Lambda_inv_0_0_p90 * Lambda_inv_0_0_p89 + Lambda_inv_0_0_p101 * Lambda_inv_0_0_p96;
  const Real Lambda_inv_0_0_p107 = Lambda_inv_0_0_p97 + Lambda_inv_5_5_p14 * Lambda_inv_0_0_p96;
  const Real Lambda_inv_0_0_p108 = Lambda_inv_0_0_p98 + Lambda_inv_0_0_p100 * Lambda_inv_0_0_p96;
  const Real Lambda_inv_0_0_p109 = Lambda_inv_0_0_p86 * Lambda_inv_0_0_p80 - Lambda_inv_0_0_p78 *
      Lambda_inv_0_0_p24 + Lambda_inv_0_0_p100 * Lambda_inv_0_0_p95;
  const Real Lambda_inv_0_0_p110 = Lambda_inv_5_5_p11 * Lambda_inv_0_0_p80 - Lambda_inv_5_5_p10 *
      Lambda_inv_0_0_p24 + Lambda_inv_5_5_p14 * Lambda_inv_0_0_p95;
  const Real Lambda_inv_0_0_p111 = Lambda_inv_0_0_p108 * Lambda_inv_0_0_p82;
  const Real Lambda_inv_0_0_p112 = Lambda_inv_0_0_p107 * Lambda_inv_0_0_p83;
  const Real Lambda_inv_2_5_p1 = Lambda_inv_0_0_p105 * Lambda_inv_0_0_p88;
  const Real Lambda_inv_0_0_p113 = Lambda_inv_0_0_p24 * Lambda_inv_0_0_p56 * Lambda_inv_0_0_p24 +
      Lambda_inv_0_0_p80 * Lambda_inv_0_0_p77 * Lambda_inv_0_0_p80 + Lambda_inv_0_0_p95 *
      Lambda_inv_0_0_p99 * Lambda_inv_0_0_p95;
  const Real Lambda_inv_2_5_p2 = Lambda_inv_5_5_p11 * Lambda_inv_0_2_p1 - Lambda_inv_5_5_p10 *
      Lambda_inv_0_0_p22 + Lambda_inv_5_5_p14 * Lambda_inv_0_2_p4;
  const Real Lambda_inv_0_2_p7 = Lambda_inv_0_0_p90 * Lambda_inv_0_2_p1 - Lambda_inv_0_0_p85 *
      Lambda_inv_0_0_p22 + Lambda_inv_0_0_p101 * Lambda_inv_0_2_p4;
  const Real Lambda_inv_0_2_p8 = Lambda_inv_0_0_p86 * Lambda_inv_0_2_p1 - Lambda_inv_0_0_p78 *
      Lambda_inv_0_0_p22 + Lambda_inv_0_0_p100 * Lambda_inv_0_2_p4;
  const Real Lambda_inv_0_0_p114 = Lambda_inv_0_0_p109 +
      (Lambda_inv_0_0_p104 * Lambda_inv_0_0_p82 + Lambda_inv_0_0_p105 * Lambda_inv_0_0_p83);
  const Real Lambda_inv_0_0_p115 = Lambda_inv_0_0_p110 +
      (Lambda_inv_0_0_p105 * Lambda_inv_0_0_p82 + Lambda_inv_5_5 * Lambda_inv_0_0_p83);
  const Real Lambda_inv_0_0_p116 = Lambda_inv_0_2_p6 -
      (Lambda_inv_0_0_p106 * Lambda_inv_0_0_p82 - Lambda_inv_0_0_p107 * Lambda_inv_0_0_p88);
  const Real Lambda_inv_0_0_p117 = Lambda_inv_0_0_p103 -
      (Lambda_inv_0_0_p107 * Lambda_inv_0_0_p82 - Lambda_inv_5_5 * Lambda_inv_0_0_p88);
  const Real Lambda_inv_0_0_p118 = Lambda_inv_0_0_p90 * Lambda_inv_0_0_p80 - Lambda_inv_0_0_p85 *
      Lambda_inv_0_0_p24 + Lambda_inv_0_0_p101 * Lambda_inv_0_0_p95 +
      (Lambda_inv_0_0_p111 + Lambda_inv_0_0_p112);
  const Real Lambda_inv_0_2_p9 = Lambda_inv_0_2_p7 -
      (Lambda_inv_0_0_p106 * Lambda_inv_0_0_p83 + Lambda_inv_0_0_p108 * Lambda_inv_0_0_p88);
  const Real Lambda_inv_2_5 = Lambda_inv_2_5_p2 - (Lambda_inv_0_0_p112 + Lambda_inv_2_5_p1);
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;
  const Real Lambda_inv_0_3_p2 = Lambda_inv_0_3_p1 - (Lambda_inv_0_0_p111 - Lambda_inv_2_5_p1);
  const Real Lambda_inv_2_2_p1 = Lambda_inv_0_2_p8 -
      (Lambda_inv_0_0_p108 * Lambda_inv_0_0_p83 + Lambda_inv_0_0_p104 * Lambda_inv_0_0_p88);
  const Real Lambda_inv_0_2_p10 = Lambda_inv_0_2_p2 * Lambda_inv_0_0_p24 + Lambda_inv_0_2_p3 *
      Lambda_inv_0_0_p80 + Lambda_inv_0_2_p5 * Lambda_inv_0_0_p95 - Lambda_inv_0_0_p88 *
      Lambda_inv_0_0_p114 + Lambda_inv_0_0_p82 * Lambda_inv_0_2_p8;
  const Real Lambda_inv_0_0_p119 = Lambda_inv_0_0_p113 +
      (Lambda_inv_0_0_p82 * (Lambda_inv_0_0_p109 + Lambda_inv_0_0_p114) + Lambda_inv_0_0_p83 *
      (Lambda_inv_0_0_p110 + Lambda_inv_0_0_p115));
  const Real Lambda_inv_0_0_p120 = Lambda_inv_0_0_p102 * Lambda_inv_0_0_p95 + Lambda_inv_0_0_p88 *
      Lambda_inv_0_0_p115 + Lambda_inv_0_0_p83 * Lambda_inv_0_0_p103 +
      (Lambda_inv_0_3_p1 - Lambda_inv_0_0_p118) * Lambda_inv_0_0_p82;

  // link 1 (link1), turn
  const Real Lambda_inv_3_3_p2 = s1 * (Lambda_inv_0_0_p106 - Lambda_inv_0_0_p104) -
      Lambda_inv_3_3_p1 * Lambda_inv_0_0_p108;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p121 = Lambda_inv_0_0_p102 * Lambda_inv_0_0_p38 -
      (Lambda_inv_0_0_p82 * (Lambda_inv_0_2_p6 + Lambda_inv_0_0_p116) - Lambda_inv_0_0_p88 *
      (Lambda_inv_0_0_p103 + Lambda_inv_0_0_p117));
  const Real Lambda_inv_0_2_p11 = Lambda_inv_0_2_p10 + (Lambda_inv_2_5_p2 - Lambda_inv_0_0_p118) *
      Lambda_inv_0_0_p83;
  const Real Lambda_inv_0_2_p12 = Lambda_inv_0_0_p102 * Lambda_inv_0_2_p4 - Lambda_inv_0_0_p83 *
      Lambda_inv_0_2_p6 - Lambda_inv_0_0_p82 * Lambda_inv_0_2_p9 +
      (Lambda_inv_2_5 - Lambda_inv_0_3_p1) * Lambda_inv_0_0_p88;

  // link 1 (link1), turn
  const Real Lambda_inv_0_3_p3 = s1 * (Lambda_inv_0_0_p118 - Lambda_inv_0_3_p2) - c1 *
      (Lambda_inv_0_0_p116 + Lambda_inv_0_0_p114);
  const Real Lambda_inv_0_3_p4 = s1 * Lambda_inv_0_3_p3;
  const Real Lambda_inv_0_4_p1 = c1 * Lambda_inv_0_3_p3;
  const Real Lambda_inv_3_3_p3 = s1 * Lambda_inv_3_3_p2;
  const Real Lambda_inv_0_2 = c1 * Lambda_inv_0_2_p11 + s1 * Lambda_inv_0_2_p12;
  Lambda_inv[2] = -Lambda_inv_0_2;
  Lambda_inv[12] = -Lambda_inv_0_2;
  const Real Lambda_inv_0_5 = c1 * Lambda_inv_0_0_p115 + s1 * Lambda_inv_0_0_p117;
  Lambda_inv[5] = -Lambda_inv_0_5;
  Lambda_inv[30] = -Lambda_inv_0_5;
  const Real Lambda_inv_0_3 = Lambda_inv_0_0_p118 - Lambda_inv_0_3_p4;
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;
  const Real Lambda_inv_0_4 = Lambda_inv_0_4_p1 + Lambda_inv_0_0_p116;
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[24] = Lambda_inv_0_4;
  const Real Lambda_inv_1_2 = c1 * Lambda_inv_0_2_p12 - s1 * Lambda_inv_0_2_p11;
  Lambda_inv[8] = Lambda_inv_1_2;
  Lambda_inv[13] = Lambda_inv_1_2;
  const Real Lambda_inv_1_3 = Lambda_inv_0_4_p1 + Lambda_inv_0_0_p114;
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  const Real Lambda_inv_1_4 = Lambda_inv_0_3_p2 + Lambda_inv_0_3_p4;
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_1_5 = c1 * Lambda_inv_0_0_p117 - s1 * Lambda_inv_0_0_p115;
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real Lambda_inv_2_3 = c1 * Lambda_inv_0_2_p9 + s1 * Lambda_inv_2_2_p1;
  Lambda_inv[15] = -Lambda_inv_2_3;
  Lambda_inv[20] = -Lambda_inv_2_3;
  const Real Lambda_inv_2_4 = c1 * Lambda_inv_2_2_p1 - s1 * Lambda_inv_0_2_p9;
  Lambda_inv[16] = Lambda_inv_2_4;
  Lambda_inv[26] = Lambda_inv_2_4;
  const Real Lambda_inv_0_0_p122 = s1 * (Lambda_inv_0_0_p119 - Lambda_inv_0_0_p121) -
      Lambda_inv_3_3_p1 * Lambda_inv_0_0_p120;

  // link 1 (link1), mass matrix
  Lambda_inv[14] = Lambda_inv_0_2_p2 * Lambda_inv_0_0_p22 + Lambda_inv_0_2_p3 * Lambda_inv_0_2_p1 +
      Lambda_inv_0_2_p5 * Lambda_inv_0_2_p4 - (Lambda_inv_0_0_p83 *
      (Lambda_inv_0_2_p7 + Lambda_inv_0_2_p9) + Lambda_inv_0_0_p88 *
      (Lambda_inv_0_2_p8 + Lambda_inv_2_2_p1));

  // link 1 (link1), turn
  Lambda_inv[21] = Lambda_inv_0_0_p106 - Lambda_inv_3_3_p3;
  const Real Lambda_inv_3_4 = c1 * Lambda_inv_3_3_p2 + Lambda_inv_0_0_p108;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;
  const Real Lambda_inv_3_5 = c1 * Lambda_inv_0_0_p107 + s1 * Lambda_inv_0_0_p105;
  Lambda_inv[23] = -Lambda_inv_3_5;
  Lambda_inv[33] = -Lambda_inv_3_5;
  Lambda_inv[28] = Lambda_inv_0_0_p104 + Lambda_inv_3_3_p3;
  const Real Lambda_inv_4_5 = c1 * Lambda_inv_0_0_p105 - s1 * Lambda_inv_0_0_p107;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
  const Real Lambda_inv_0_0_p123 = s1 * Lambda_inv_0_0_p122;
  Lambda_inv[0] = Lambda_inv_0_0_p119 - Lambda_inv_0_0_p123;
  const Real Lambda_inv_0_1 = c1 * Lambda_inv_0_0_p122 + Lambda_inv_0_0_p120;
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;
  Lambda_inv[7] = Lambda_inv_0_0_p121 + Lambda_inv_0_0_p123;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
