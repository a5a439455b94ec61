// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J from poses, in the axes asked for at link origins.
// 982 flops (add 407, mul 569, div 6), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void lambda_inverse(const Real (&TREELINE_RESTRICT q)[9],
    Real (&TREELINE_RESTRICT Lambda_inv)[36]) noexcept {
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
  const Real Lambda_inv_4_5_p1 = 0.00020215999999999998 * s8;

  // link 9 (link6), mass matrix
  const Real Lambda_inv_4_5_p2 = 4e-05 * c8;

  // link 8 (link5), composite inertia
  const Real Lambda_inv_4_5_p3 = 0.0028799999999999997 * s8;
  const Real Lambda_inv_4_5_p4 = 0.0028799999999999997 * c8;

  // link 9 (link6), mass matrix
  const Real Lambda_inv_4_5_p5 = 4e-05 * s8;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p6 = 0.9999999999999999 * c8;

  // link 8 (link5), composite inertia
  const Real Lambda_inv_4_5_p7 = s8 * Lambda_inv_4_5_p1;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p8 = c7 * Lambda_inv_4_5_p3;

  // link 8 (link5), composite inertia
  const Real Lambda_inv_4_5_p9 = c8 * Lambda_inv_4_5_p1;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p10 = c7 * Lambda_inv_4_5_p4;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p11 = s7 * Lambda_inv_4_5_p3;
  const Real Lambda_inv_4_5_p12 = 0.861795 + Lambda_inv_4_5_p4;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p13 = s7 * Lambda_inv_4_5_p4;

  // link 9 (link6), mass matrix
  const Real Lambda_inv_4_5_p14 = c7 * Lambda_inv_4_5_p5;

  // link 8 (link5), composite inertia
  const Real Lambda_inv_4_5_p15 = 0.00164 + Lambda_inv_4_5_p7;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p16 = 0.0203 * Lambda_inv_4_5_p8;

  // link 9 (link6), mass matrix
  const Real Lambda_inv_4_5_p17 = s7 * Lambda_inv_4_5_p5;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p18 = s7 * (0.00010000000000000026 + Lambda_inv_4_5_p7);
  const Real Lambda_inv_4_5_p19 = Lambda_inv_4_5_p8 - 0.025374999999999998;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p20 = s6 * Lambda_inv_4_5_p11;
  const Real Lambda_inv_4_5_p21 = c7 * Lambda_inv_4_5_p9 + 0.4331 * Lambda_inv_4_5_p8;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p22 = 1.0 / (Lambda_inv_4_5_p15 - Lambda_inv_4_5_p6 *
      Lambda_inv_4_5_p2);

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p23 = s7 * Lambda_inv_4_5_p9 + 0.4331 * Lambda_inv_4_5_p11;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p24 = 24999.999999999996 * Lambda_inv_4_5_p17;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p25 = s7 * Lambda_inv_4_5_p18;
  const Real Lambda_inv_4_5_p26 = 0.0067651125 + (Lambda_inv_4_5_p15 - 0.0406 * Lambda_inv_4_5_p8);

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p27 = s6 * Lambda_inv_4_5_p10 + c6 * Lambda_inv_4_5_p3;
  const Real Lambda_inv_4_5_p28 = 0.00064216 * c7 +
      (0.4331 * Lambda_inv_4_5_p10 - 5.846399999999999e-05 * s8);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p29 = Lambda_inv_4_5_p23 + Lambda_inv_4_5_p6 * Lambda_inv_4_5_p17;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p30 = 0.0203 * Lambda_inv_4_5_p13;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p31 = Lambda_inv_4_5_p21 - 5.846399999999999e-05 * c8 -
      0.010673638499999999;

  // link 6 (link3), mass matrix
  const Real Lambda_inv_4_5_p32 = s6 * Lambda_inv_4_5_p12 + c6 * Lambda_inv_4_5_p19;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p33 = 1557.24430048586 * Lambda_inv_4_5_p28;

  // link 6 (link3), mass matrix
  const Real Lambda_inv_4_5_p34 = c6 * Lambda_inv_4_5_p12 - s6 * Lambda_inv_4_5_p19;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p35 = c6 * Lambda_inv_4_5_p11;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p36 = 0.0203 * Lambda_inv_4_5_p11 - c7 * Lambda_inv_4_5_p18;
  const Real Lambda_inv_4_5_p37 = 0.004704000000000001 + Lambda_inv_4_5_p23;

  // link 6 (link3), mass matrix
  const Real Lambda_inv_4_5_p38 = 0.4318 * Lambda_inv_4_5_p32;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p39 = 0.00064216 * s7 + 0.4331 * Lambda_inv_4_5_p13;
  const Real Lambda_inv_4_5_p40 = c6 * Lambda_inv_4_5_p10 - s6 * Lambda_inv_4_5_p3;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p41 = Lambda_inv_4_5_p16 - Lambda_inv_4_5_p15;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p42 = Lambda_inv_4_5_p28 + 0.4318 * Lambda_inv_4_5_p27;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p43 = 0.3056901365 + (0.0011921599999999998 - Lambda_inv_4_5_p7 +
      Lambda_inv_4_5_p25 + 0.0024946559999999996 * c8);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p44 = Lambda_inv_4_5_p29 * Lambda_inv_4_5_p22;
  const Real Lambda_inv_4_5_p45 = 0.312455249 + (0.00129216 - Lambda_inv_4_5_p25 + 2.0 *
      (0.0012473279999999998 * c8 - Lambda_inv_4_5_p16)) - Lambda_inv_4_5_p24 * Lambda_inv_4_5_p17;
  const Real Lambda_inv_4_5_p46 = Lambda_inv_4_5_p29 + 0.4318 * Lambda_inv_4_5_p20;

  // link 6 (link3), composite inertia
  const Real Lambda_inv_4_5_p47 = s6 * (Lambda_inv_4_5_p43 - Lambda_inv_4_5_p26) + c6 *
      (2.0 * Lambda_inv_4_5_p31);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p48 = 1557.24430048586 * Lambda_inv_4_5_p42;

  // link 6 (link3), composite inertia
  const Real Lambda_inv_4_5_p49 = s6 * Lambda_inv_4_5_p47;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p50 = 1.0 / (Lambda_inv_4_5_p45 - Lambda_inv_4_5_p33 *
      Lambda_inv_4_5_p28 - Lambda_inv_4_5_p44 * Lambda_inv_4_5_p29);

  // link 6 (link3), mass matrix
  const Real Lambda_inv_4_5_p51 = c6 * Lambda_inv_4_5_p36 - s6 * Lambda_inv_4_5_p37 - 0.1501 *
      Lambda_inv_4_5_p32;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p52 = Lambda_inv_4_5_p45 + Lambda_inv_4_5_p38 - Lambda_inv_4_5_p33 *
      Lambda_inv_4_5_p42 - Lambda_inv_4_5_p44 * Lambda_inv_4_5_p46;
  const Real Lambda_inv_4_5_p53 = Lambda_inv_4_5_p46 * Lambda_inv_4_5_p22;

  // link 6 (link3), mass matrix
  const Real Lambda_inv_4_5_p54 = s6 * Lambda_inv_4_5_p36 + c6 * Lambda_inv_4_5_p37 + 0.1501 *
      Lambda_inv_4_5_p34;

  // link 9 (link6), mass matrix
  const Real Lambda_inv_4_5_p55 = s5 * (c6 * Lambda_inv_4_5_p14 + s6 * Lambda_inv_4_5_p2) + c5 *
      (s6 * Lambda_inv_4_5_p14 - c6 * Lambda_inv_4_5_p2);

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p56 = c5 * (c6 * Lambda_inv_4_5_p30 - s6 * Lambda_inv_4_5_p39 +
      (0.1501 * Lambda_inv_4_5_p40 - 0.4318 * Lambda_inv_4_5_p13));

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p57 = c5 * (c6 * Lambda_inv_4_5_p41 - s6 * Lambda_inv_4_5_p21 -
      (0.1501 * Lambda_inv_4_5_p35 + 0.4318 * Lambda_inv_4_5_p8));

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p58 = s5 * (c6 * Lambda_inv_4_5_p39 + s6 * Lambda_inv_4_5_p30 + 0.1501 *
      Lambda_inv_4_5_p27) - Lambda_inv_4_5_p56;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p59 = Lambda_inv_4_5_p24 * Lambda_inv_4_5_p55;

  // link 6 (link3), composite inertia
  const Real Lambda_inv_4_5_p60 = 1.674987602 + (Lambda_inv_4_5_p26 + Lambda_inv_4_5_p49 + 2.0 *
      (Lambda_inv_4_5_p38 + 0.1501 * Lambda_inv_4_5_p11));

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p61 = Lambda_inv_4_5_p6 * Lambda_inv_4_5_p55 -
      (s5 * (0.1501 * Lambda_inv_4_5_p20 - (c6 * Lambda_inv_4_5_p21 + s6 * Lambda_inv_4_5_p41)) +
      Lambda_inv_4_5_p57);

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p62 = s5 * Lambda_inv_4_5_p27 - c5 * Lambda_inv_4_5_p40;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p63 = Lambda_inv_4_5_p52 * Lambda_inv_4_5_p50;

  // link 6 (link3), composite inertia
  const Real Lambda_inv_4_5_p64 = 0.10439999999999999 - Lambda_inv_4_5_p34;
  const Real Lambda_inv_4_5_p65 = 3.79559 + Lambda_inv_4_5_p32;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p66 = c5 * Lambda_inv_4_5_p35 - s5 * Lambda_inv_4_5_p20;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p67 = 24999.999999999996 * Lambda_inv_4_5_p55;
  const Real Lambda_inv_4_5_p68 = Lambda_inv_4_5_p59 -
      (s5 * (Lambda_inv_4_5_p51 - 0.4318 * Lambda_inv_4_5_p11 - 0.690314699) + c5 *
      (Lambda_inv_4_5_p54 - 0.023750999999999998));

  // link 6 (link3), mass matrix
  const Real Lambda_inv_4_5_p69 = s5 * Lambda_inv_4_5_p32 - c5 * Lambda_inv_4_5_p34;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p70 = Lambda_inv_4_5_p59 -
      (s5 * Lambda_inv_4_5_p51 + c5 * Lambda_inv_4_5_p54) - Lambda_inv_4_5_p33 *
      Lambda_inv_4_5_p58 + Lambda_inv_4_5_p44 * Lambda_inv_4_5_p61;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p71 = c4 * Lambda_inv_4_5_p13 - s4 * Lambda_inv_4_5_p62;

  // link 5 (link2), composite inertia
  const Real Lambda_inv_4_5_p72 = s5 * (0.07312640000000001 +
      (Lambda_inv_4_5_p43 - Lambda_inv_4_5_p49 + 0.3002 * Lambda_inv_4_5_p11) -
      Lambda_inv_4_5_p60) + c5 * (2.0 * (c6 * Lambda_inv_4_5_p47 - Lambda_inv_4_5_p31 + 0.4318 *
      Lambda_inv_4_5_p34 - 0.0070992));

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p73 = c4 * Lambda_inv_4_5_p62 + s4 * Lambda_inv_4_5_p13;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p74 = 1557.24430048586 * Lambda_inv_4_5_p58;
  const Real Lambda_inv_4_5_p75 = 1.7481140020000001 + Lambda_inv_4_5_p45 + 0.8636 *
      Lambda_inv_4_5_p32 - Lambda_inv_4_5_p48 * Lambda_inv_4_5_p42 - Lambda_inv_4_5_p53 *
      Lambda_inv_4_5_p46 - Lambda_inv_4_5_p63 * Lambda_inv_4_5_p52;

  // link 6 (link3), mass matrix
  const Real Lambda_inv_4_5_p76 = c4 * Lambda_inv_4_5_p69;
  const Real Lambda_inv_4_5_p77 = s4 * Lambda_inv_4_5_p69;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p78 = c4 * Lambda_inv_4_5_p8 - s4 * Lambda_inv_4_5_p66;
  const Real Lambda_inv_4_5_p79 = c4 * Lambda_inv_4_5_p66 + s4 * Lambda_inv_4_5_p8;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p80 = 1.0 / Lambda_inv_4_5_p75;
  const Real Lambda_inv_4_5_p81 = Lambda_inv_4_5_p61 * Lambda_inv_4_5_p22;

  // link 5 (link2), mass matrix
  const Real Lambda_inv_4_5_p82 = c5 * Lambda_inv_4_5_p64 + s5 * Lambda_inv_4_5_p65;

  // link 5 (link2), composite inertia
  const Real Lambda_inv_4_5_p83 = s5 * Lambda_inv_4_5_p64 - c5 * Lambda_inv_4_5_p65;
  const Real Lambda_inv_4_5_p84 = 4.9338049999999996 + Lambda_inv_4_5_p11;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p85 = Lambda_inv_4_5_p70 * Lambda_inv_4_5_p50;
  const Real Lambda_inv_4_5_p86 = Lambda_inv_4_5_p68 - Lambda_inv_4_5_p48 * Lambda_inv_4_5_p58 +
      Lambda_inv_4_5_p53 * Lambda_inv_4_5_p61 - Lambda_inv_4_5_p63 * Lambda_inv_4_5_p70;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p87 = c3 * Lambda_inv_4_5_p71 - s3 * Lambda_inv_4_5_p73;

  // link 5 (link2), mass matrix
  const Real Lambda_inv_4_5_p88 = c4 * Lambda_inv_4_5_p82;
  const Real Lambda_inv_4_5_p89 = s4 * Lambda_inv_4_5_p82;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p90 = c3 * Lambda_inv_4_5_p78 - s3 * Lambda_inv_4_5_p79;

  // link 4 (link1), mass matrix
  const Real Lambda_inv_4_5_p91 = s4 * Lambda_inv_4_5_p83 - c4 * Lambda_inv_4_5_p84;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p92 = 1557.24430048586 * Lambda_inv_4_5_p87;

  // link 4 (link1), mass matrix
  const Real Lambda_inv_4_5_p93 = s4 * Lambda_inv_4_5_p84 + c4 * Lambda_inv_4_5_p83;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p94 = c3 * Lambda_inv_4_5_p73 + s3 * Lambda_inv_4_5_p71;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p95 = Lambda_inv_4_5_p86 * Lambda_inv_4_5_p80;
  const Real Lambda_inv_4_5_p96 = Lambda_inv_4_5_p44 * Lambda_inv_4_5_p90 -
      (s3 * Lambda_inv_4_5_p76 + c3 * Lambda_inv_4_5_p77 + Lambda_inv_4_5_p33 * Lambda_inv_4_5_p87);
  const Real Lambda_inv_4_5_p97 = Lambda_inv_4_5_p90 * Lambda_inv_4_5_p22;

  // link 6 (link3), pose
  const Real Lambda_inv_4_5_p98 = c6 * s5 + s6 * c5;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p99 = 1.4717295504999999 +
      (Lambda_inv_4_5_p60 + s5 * Lambda_inv_4_5_p72) - Lambda_inv_4_5_p67 * Lambda_inv_4_5_p55 -
      Lambda_inv_4_5_p74 * Lambda_inv_4_5_p58 - Lambda_inv_4_5_p81 * Lambda_inv_4_5_p61;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p100 = c3 * Lambda_inv_4_5_p79 + s3 * Lambda_inv_4_5_p78;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p101 = Lambda_inv_4_5_p96 * Lambda_inv_4_5_p50;

  // link 4 (link1), pose
  const Real Lambda_inv_4_4_p1 = c4 * s3 + s4 * c3;

  // link 6 (link3), pose
  const Real Lambda_inv_4_5_p102 = s6 * s5 - c6 * c5;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p103 = Lambda_inv_4_5_p53 * Lambda_inv_4_5_p90 -
      (s3 * Lambda_inv_4_5_p88 + c3 * Lambda_inv_4_5_p89 + Lambda_inv_4_5_p48 *
      Lambda_inv_4_5_p87) - Lambda_inv_4_5_p63 * Lambda_inv_4_5_p96;

  // link 4 (link1), pose
  const Real Lambda_inv_4_4_p2 = c4 * c3 - s4 * s3;

  // link 5 (link2), pose
  const Real Lambda_inv_4_4_p3 = c5 * Lambda_inv_4_4_p1;
  const Real Lambda_inv_4_4_p4 = s5 * Lambda_inv_4_4_p1;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p104 = 1.0 / (Lambda_inv_4_5_p99 - Lambda_inv_4_5_p85 *
      Lambda_inv_4_5_p70 - Lambda_inv_4_5_p95 * Lambda_inv_4_5_p86);
  const Real Lambda_inv_4_5_p105 = Lambda_inv_4_5_p103 * Lambda_inv_4_5_p80;
  const Real Lambda_inv_4_5_p106 = s3 * Lambda_inv_4_5_p91 - c3 * Lambda_inv_4_5_p93 -
      Lambda_inv_4_5_p74 * Lambda_inv_4_5_p87 - Lambda_inv_4_5_p81 * Lambda_inv_4_5_p90 -
      Lambda_inv_4_5_p85 * Lambda_inv_4_5_p96;
  const Real Lambda_inv_4_5_p107 = s3 * Lambda_inv_4_5_p77 - c3 * Lambda_inv_4_5_p76 +
      Lambda_inv_4_5_p33 * Lambda_inv_4_5_p94 - Lambda_inv_4_5_p44 * Lambda_inv_4_5_p100;
  const Real Lambda_inv_4_5_p108 = Lambda_inv_4_5_p106 - Lambda_inv_4_5_p95 * Lambda_inv_4_5_p103;

  // link 8 (link5), pose
  const Real Lambda_inv_4_5_p109 = s8 * (c7 * Lambda_inv_4_5_p98) + c8 * Lambda_inv_4_5_p102;

  // link 7 (link4), pose
  const Real Lambda_inv_4_5_p110 = s7 * Lambda_inv_4_5_p98;

  // link 6 (link3), pose
  const Real Lambda_inv_4_4_p5 = c6 * Lambda_inv_4_4_p3 - s6 * Lambda_inv_4_4_p4;
  const Real Lambda_inv_4_4_p6 = s6 * Lambda_inv_4_4_p3 + c6 * Lambda_inv_4_4_p4;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p111 = 186.45 - Lambda_inv_4_5_p92 * Lambda_inv_4_5_p87 -
      Lambda_inv_4_5_p97 * Lambda_inv_4_5_p90 - Lambda_inv_4_5_p101 * Lambda_inv_4_5_p96 -
      Lambda_inv_4_5_p105 * Lambda_inv_4_5_p103;
  const Real Lambda_inv_4_5_p112 = 1557.24430048586 * Lambda_inv_4_5_p94;
  const Real Lambda_inv_4_5_p113 = Lambda_inv_4_5_p24 * Lambda_inv_4_5_p109;
  const Real Lambda_inv_4_5_p114 = s3 * Lambda_inv_4_5_p89 - c3 * Lambda_inv_4_5_p88 +
      Lambda_inv_4_5_p48 * Lambda_inv_4_5_p94 - Lambda_inv_4_5_p53 * Lambda_inv_4_5_p100 -
      Lambda_inv_4_5_p63 * Lambda_inv_4_5_p107;
  const Real Lambda_inv_4_5_p115 = Lambda_inv_4_5_p100 * Lambda_inv_4_5_p22;
  const Real Lambda_inv_4_5_p116 = Lambda_inv_4_5_p107 * Lambda_inv_4_5_p50;
  const Real Lambda_inv_4_5_p117 = Lambda_inv_4_5_p6 * Lambda_inv_4_5_p109 - Lambda_inv_4_5_p102;
  const Real Lambda_inv_4_5_p118 = Lambda_inv_4_5_p108 * Lambda_inv_4_5_p104;
  const Real Lambda_inv_4_5_p119 = c3 * Lambda_inv_4_5_p91 + s3 * Lambda_inv_4_5_p93 +
      Lambda_inv_4_5_p74 * Lambda_inv_4_5_p94 + Lambda_inv_4_5_p81 * Lambda_inv_4_5_p100 -
      Lambda_inv_4_5_p85 * Lambda_inv_4_5_p107;

  // link 7 (link4), pose
  const Real Lambda_inv_4_4_p7 = c7 * Lambda_inv_4_4_p2 - s7 * Lambda_inv_4_4_p5;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p120 = Lambda_inv_4_5_p114 * Lambda_inv_4_5_p80;
  const Real Lambda_inv_4_5_p121 = Lambda_inv_4_5_p119 - Lambda_inv_4_5_p95 * Lambda_inv_4_5_p114;
  const Real Lambda_inv_4_5_p122 = Lambda_inv_4_5_p113 - Lambda_inv_4_5_p33 * Lambda_inv_4_5_p110 +
      Lambda_inv_4_5_p44 * Lambda_inv_4_5_p117;
  const Real Lambda_inv_4_5_p123 = Lambda_inv_4_5_p121 * Lambda_inv_4_5_p104;

  // link 8 (link5), pose
  const Real Lambda_inv_4_4_p8 = s8 * (c7 * Lambda_inv_4_4_p5 + s7 * Lambda_inv_4_4_p2) + c8 *
      Lambda_inv_4_4_p6;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p124 = Lambda_inv_4_5_p92 * Lambda_inv_4_5_p94 + Lambda_inv_4_5_p97 *
      Lambda_inv_4_5_p100 - Lambda_inv_4_5_p101 * Lambda_inv_4_5_p107 - Lambda_inv_4_5_p105 *
      Lambda_inv_4_5_p114 - Lambda_inv_4_5_p118 * Lambda_inv_4_5_p121;
  const Real Lambda_inv_4_5_p125 = 1.0 / (Lambda_inv_4_5_p111 - Lambda_inv_4_5_p118 *
      Lambda_inv_4_5_p108);
  const Real Lambda_inv_4_5_p126 = Lambda_inv_4_5_p113 - Lambda_inv_4_5_p48 * Lambda_inv_4_5_p110 +
      Lambda_inv_4_5_p53 * Lambda_inv_4_5_p117 - Lambda_inv_4_5_p63 * Lambda_inv_4_5_p122;

  // link 7 (link4), pose
  const Real Lambda_inv_0_4_p1 = 0.0203 * Lambda_inv_4_5_p98 - 0.4331 * Lambda_inv_4_5_p102;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p127 = 186.45 - Lambda_inv_4_5_p112 * Lambda_inv_4_5_p94 -
      Lambda_inv_4_5_p115 * Lambda_inv_4_5_p100 - Lambda_inv_4_5_p116 * Lambda_inv_4_5_p107 -
      Lambda_inv_4_5_p120 * Lambda_inv_4_5_p114;
  const Real Lambda_inv_4_5_p128 = 1.0 - Lambda_inv_4_5_p67 * Lambda_inv_4_5_p109 -
      Lambda_inv_4_5_p74 * Lambda_inv_4_5_p110 - Lambda_inv_4_5_p81 * Lambda_inv_4_5_p117 -
      Lambda_inv_4_5_p85 * Lambda_inv_4_5_p122;
  const Real Lambda_inv_4_4_p9 = Lambda_inv_4_4_p6 - Lambda_inv_4_5_p6 * Lambda_inv_4_4_p8;
  const Real Lambda_inv_4_4_p10 = Lambda_inv_4_4_p2 - Lambda_inv_4_5_p24 * Lambda_inv_4_4_p8;
  const Real Lambda_inv_4_5_p129 = 24999.999999999996 * Lambda_inv_4_5_p109;

  // link 7 (link4), pose
  const Real Lambda_inv_0_4_p2 = 0.4331 * Lambda_inv_4_4_p6 - 0.0203 * Lambda_inv_4_4_p5;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_0_4_p3 = Lambda_inv_4_4_p2 * Lambda_inv_0_4_p1;
  const Real Lambda_inv_0_4_p4 = Lambda_inv_0_4_p1 - 0.4318 * s5;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p130 = 1557.24430048586 * Lambda_inv_4_5_p110;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_0_4_p5 = Lambda_inv_0_4_p2 +
      (0.4318 * Lambda_inv_4_4_p3 + 0.1501 * Lambda_inv_4_4_p2);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_4_p11 = 24999.999999999996 * Lambda_inv_4_4_p8;
  const Real Lambda_inv_4_4_p12 = 1557.24430048586 * Lambda_inv_4_4_p7;
  const Real Lambda_inv_4_5_p131 = Lambda_inv_4_5_p128 - Lambda_inv_4_5_p95 * Lambda_inv_4_5_p126;
  const Real Lambda_inv_4_4_p13 = Lambda_inv_4_4_p10 - Lambda_inv_4_5_p33 * Lambda_inv_4_4_p7 +
      Lambda_inv_4_5_p44 * Lambda_inv_4_4_p9;
  const Real Lambda_inv_4_5_p132 = Lambda_inv_4_5_p117 * Lambda_inv_4_5_p22;
  const Real Lambda_inv_4_4_p14 = Lambda_inv_4_4_p9 * Lambda_inv_4_5_p22;
  const Real Lambda_inv_4_5_p133 = Lambda_inv_4_5_p124 * Lambda_inv_4_5_p125;
  const Real Lambda_inv_0_4_p6 = Lambda_inv_4_4_p2 * Lambda_inv_0_4_p4 - Lambda_inv_4_5_p63 *
      Lambda_inv_0_4_p3;
  const Real Lambda_inv_4_5_p134 = Lambda_inv_4_5_p122 * Lambda_inv_4_5_p50;
  const Real Lambda_inv_4_4_p15 = Lambda_inv_4_4_p13 * Lambda_inv_4_5_p50;
  const Real Lambda_inv_4_4_p16 = Lambda_inv_4_4_p10 - Lambda_inv_4_5_p48 * Lambda_inv_4_4_p7 +
      Lambda_inv_4_5_p53 * Lambda_inv_4_4_p9 - Lambda_inv_4_5_p63 * Lambda_inv_4_4_p13;
  const Real Lambda_inv_4_5_p135 = Lambda_inv_4_5_p92 * Lambda_inv_4_5_p110 + Lambda_inv_4_5_p97 *
      Lambda_inv_4_5_p117 + Lambda_inv_4_5_p101 * Lambda_inv_4_5_p122 + Lambda_inv_4_5_p105 *
      Lambda_inv_4_5_p126 + Lambda_inv_4_5_p118 * Lambda_inv_4_5_p131;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_1_5_p1 = Lambda_inv_4_4_p1 * Lambda_inv_0_4_p1;

  // link 5 (link2), pose
  const Real Lambda_inv_1_5_p2 = c5 * Lambda_inv_4_4_p2;
  const Real Lambda_inv_1_5_p3 = s5 * Lambda_inv_4_4_p2;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p136 = Lambda_inv_4_5_p126 * Lambda_inv_4_5_p80;
  const Real Lambda_inv_4_4_p17 = Lambda_inv_4_4_p16 * Lambda_inv_4_5_p80;
  const Real Lambda_inv_4_5_p137 = 1.0 / (Lambda_inv_4_5_p127 - Lambda_inv_4_5_p123 *
      Lambda_inv_4_5_p121 - Lambda_inv_4_5_p133 * Lambda_inv_4_5_p124);
  const Real Lambda_inv_4_4_p18 = Lambda_inv_4_5_p67 * Lambda_inv_4_4_p8 - Lambda_inv_4_5_p74 *
      Lambda_inv_4_4_p7 - Lambda_inv_4_5_p81 * Lambda_inv_4_4_p9 - Lambda_inv_4_5_p85 *
      Lambda_inv_4_4_p13 - Lambda_inv_4_5_p95 * Lambda_inv_4_4_p16;
  const Real Lambda_inv_1_5_p4 = Lambda_inv_4_4_p1 * Lambda_inv_0_4_p4 - Lambda_inv_4_5_p63 *
      Lambda_inv_1_5_p1;

  // link 6 (link3), pose
  const Real Lambda_inv_1_5_p5 = c6 * Lambda_inv_1_5_p2 - s6 * Lambda_inv_1_5_p3;
  const Real Lambda_inv_1_5_p6 = s6 * Lambda_inv_1_5_p2 + c6 * Lambda_inv_1_5_p3;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p138 = Lambda_inv_4_5_p112 * Lambda_inv_4_5_p110 + Lambda_inv_4_5_p115 *
      Lambda_inv_4_5_p117 - Lambda_inv_4_5_p116 * Lambda_inv_4_5_p122 - Lambda_inv_4_5_p120 *
      Lambda_inv_4_5_p126 - Lambda_inv_4_5_p123 * Lambda_inv_4_5_p131;
  const Real Lambda_inv_4_5_p139 = Lambda_inv_4_5_p131 * Lambda_inv_4_5_p104;
  const Real Lambda_inv_4_4_p19 = Lambda_inv_4_4_p18 * Lambda_inv_4_5_p104;
  const Real Lambda_inv_0_4_p7 = Lambda_inv_0_4_p5 + Lambda_inv_4_5_p85 * Lambda_inv_0_4_p3 +
      Lambda_inv_4_5_p95 * Lambda_inv_0_4_p6;
  const Real Lambda_inv_4_4_p20 = Lambda_inv_4_5_p92 * Lambda_inv_4_4_p7 + Lambda_inv_4_5_p97 *
      Lambda_inv_4_4_p9 + Lambda_inv_4_5_p101 * Lambda_inv_4_4_p13 + Lambda_inv_4_5_p105 *
      Lambda_inv_4_4_p16 + Lambda_inv_4_5_p118 * Lambda_inv_4_4_p18;
  const Real Lambda_inv_4_4_p21 = Lambda_inv_4_5_p112 * Lambda_inv_4_4_p7 + Lambda_inv_4_5_p115 *
      Lambda_inv_4_4_p9 - Lambda_inv_4_5_p116 * Lambda_inv_4_4_p13 - Lambda_inv_4_5_p120 *
      Lambda_inv_4_4_p16 - Lambda_inv_4_5_p123 * Lambda_inv_4_4_p18;
  const Real Lambda_inv_4_5_p140 = Lambda_inv_4_5_p138 + Lambda_inv_4_5_p133 * Lambda_inv_4_5_p135;

  // link 7 (link4), pose
  const Real Lambda_inv_1_5_p7 = 0.4331 * Lambda_inv_1_5_p6 - 0.0203 * Lambda_inv_1_5_p5;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p141 = Lambda_inv_4_5_p135 * Lambda_inv_4_5_p125;
  const Real Lambda_inv_4_4_p22 = Lambda_inv_4_4_p20 * Lambda_inv_4_5_p125;
  const Real Lambda_inv_4_4_p23 = Lambda_inv_4_4_p21 + Lambda_inv_4_5_p133 * Lambda_inv_4_4_p20;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_1_5_p8 = Lambda_inv_1_5_p7 +
      (0.4318 * Lambda_inv_1_5_p2 - 0.1501 * Lambda_inv_4_4_p1);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p142 = Lambda_inv_4_5_p130 * Lambda_inv_4_4_p7 - Lambda_inv_4_5_p129 *
      Lambda_inv_4_4_p8 + Lambda_inv_4_5_p132 * Lambda_inv_4_4_p9 + Lambda_inv_4_5_p134 *
      Lambda_inv_4_4_p13 + Lambda_inv_4_5_p136 * Lambda_inv_4_4_p16;
  const Real Lambda_inv_4_4_p24 = Lambda_inv_4_4_p11 * Lambda_inv_4_4_p8 + Lambda_inv_4_4_p12 *
      Lambda_inv_4_4_p7 + Lambda_inv_4_4_p14 * Lambda_inv_4_4_p9 + Lambda_inv_4_4_p15 *
      Lambda_inv_4_4_p13 + Lambda_inv_4_4_p17 * Lambda_inv_4_4_p16;

  // link 7 (link4), pose
  const Real Lambda_inv_3_3_p1 = s7 * Lambda_inv_1_5_p5 + c7 * Lambda_inv_4_4_p1;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_5_5_p1 = Lambda_inv_4_5_p129 * Lambda_inv_4_5_p109 + Lambda_inv_4_5_p130 *
      Lambda_inv_4_5_p110 + Lambda_inv_4_5_p132 * Lambda_inv_4_5_p117 + Lambda_inv_4_5_p134 *
      Lambda_inv_4_5_p122 + Lambda_inv_4_5_p136 * Lambda_inv_4_5_p126;
  const Real Lambda_inv_4_5_p143 = Lambda_inv_4_5_p140 * Lambda_inv_4_5_p137;
  const Real Lambda_inv_4_4_p25 = Lambda_inv_4_4_p23 * Lambda_inv_4_5_p137;
  const Real Lambda_inv_0_4_p8 = Lambda_inv_4_5_p118 * Lambda_inv_0_4_p7 -
      (Lambda_inv_4_5_p101 * Lambda_inv_0_4_p3 + Lambda_inv_4_5_p105 * Lambda_inv_0_4_p6);

  // link 8 (link5), pose
  const Real Lambda_inv_3_3_p2 = s8 * (c7 * Lambda_inv_1_5_p5 - s7 * Lambda_inv_4_4_p1) + c8 *
      Lambda_inv_1_5_p6;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_1_5_p9 = Lambda_inv_1_5_p8 - Lambda_inv_4_5_p85 * Lambda_inv_1_5_p1 -
      Lambda_inv_4_5_p95 * Lambda_inv_1_5_p4;
  const Real Lambda_inv_3_3_p3 = Lambda_inv_1_5_p6 - Lambda_inv_4_5_p6 * Lambda_inv_3_3_p2;
  const Real Lambda_inv_3_3_p4 = Lambda_inv_4_4_p1 + Lambda_inv_4_5_p24 * Lambda_inv_3_3_p2;
  const Real Lambda_inv_1_5_p10 = 1.0 - Lambda_inv_4_5_p101 * Lambda_inv_1_5_p1 -
      Lambda_inv_4_5_p105 * Lambda_inv_1_5_p4 - Lambda_inv_4_5_p118 * Lambda_inv_1_5_p9;
  const Real Lambda_inv_0_1_p1 = Lambda_inv_1_5_p4 * Lambda_inv_4_5_p80;
  const Real Lambda_inv_0_1_p2 = Lambda_inv_1_5_p1 * Lambda_inv_4_5_p50;
  const Real Lambda_inv_0_4_p9 = 0.05625 * Lambda_inv_4_4_p8;
  const Real Lambda_inv_3_3_p5 = Lambda_inv_4_5_p33 * Lambda_inv_3_3_p1 - Lambda_inv_3_3_p4 +
      Lambda_inv_4_5_p44 * Lambda_inv_3_3_p3;
  const Real Lambda_inv_0_4_p10 = 0.05625 * Lambda_inv_4_5_p109;
  const Real Lambda_inv_1_3_p1 = 0.05625 * Lambda_inv_3_3_p2;
  const Real Lambda_inv_4_5 = Lambda_inv_4_5_p142 + Lambda_inv_4_5_p139 * Lambda_inv_4_4_p18 +
      Lambda_inv_4_5_p141 * Lambda_inv_4_4_p20 + Lambda_inv_4_5_p143 * Lambda_inv_4_4_p23;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
  const Real Lambda_inv_0_3_p1 = Lambda_inv_3_3_p5 * Lambda_inv_4_5_p50;
  const Real Lambda_inv_4_4 = Lambda_inv_4_4_p24 + Lambda_inv_4_4_p19 * Lambda_inv_4_4_p18 +
      Lambda_inv_4_4_p22 * Lambda_inv_4_4_p20 + Lambda_inv_4_4_p25 * Lambda_inv_4_4_p23;
  Lambda_inv[28] = Lambda_inv_4_4;
  const Real Lambda_inv_0_4_p11 = 1.0 - Lambda_inv_4_5_p116 * Lambda_inv_0_4_p3 -
      Lambda_inv_4_5_p120 * Lambda_inv_0_4_p6 + Lambda_inv_4_5_p123 * Lambda_inv_0_4_p7 -
      Lambda_inv_4_5_p133 * Lambda_inv_0_4_p8;
  const Real Lambda_inv_5_5 = Lambda_inv_5_5_p1 + Lambda_inv_4_5_p139 * Lambda_inv_4_5_p131 +
      Lambda_inv_4_5_p141 * Lambda_inv_4_5_p135 + Lambda_inv_4_5_p143 * Lambda_inv_4_5_p140;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real Lambda_inv_3_3_p6 = Lambda_inv_4_5_p48 * Lambda_inv_3_3_p1 - Lambda_inv_3_3_p4 +
      Lambda_inv_4_5_p53 * Lambda_inv_3_3_p3 - Lambda_inv_4_5_p63 * Lambda_inv_3_3_p5;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_2_4_p1 = Lambda_inv_4_4_p1 * Lambda_inv_0_4_p2 + Lambda_inv_4_4_p2 *
      Lambda_inv_1_5_p7;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_1_5_p11 = Lambda_inv_4_5_p116 * Lambda_inv_1_5_p1 + Lambda_inv_4_5_p120 *
      Lambda_inv_1_5_p4 + Lambda_inv_4_5_p123 * Lambda_inv_1_5_p9 + Lambda_inv_4_5_p133 *
      Lambda_inv_1_5_p10;
  const Real Lambda_inv_0_1_p3 = Lambda_inv_1_5_p9 * Lambda_inv_4_5_p104;
  const Real Lambda_inv_0_3_p2 = Lambda_inv_3_3_p6 * Lambda_inv_4_5_p80;
  const Real Lambda_inv_3_3_p7 = Lambda_inv_4_5_p67 * Lambda_inv_3_3_p2 + Lambda_inv_4_5_p74 *
      Lambda_inv_3_3_p1 - Lambda_inv_4_5_p81 * Lambda_inv_3_3_p3 - Lambda_inv_4_5_p85 *
      Lambda_inv_3_3_p5 - Lambda_inv_4_5_p95 * Lambda_inv_3_3_p6;
  const Real Lambda_inv_2_4_p2 = Lambda_inv_4_5_p63 * Lambda_inv_2_4_p1 -
      (Lambda_inv_4_4_p1 * Lambda_inv_0_4_p5 + Lambda_inv_4_4_p2 * Lambda_inv_1_5_p8);
  const Real Lambda_inv_3_5_p1 = Lambda_inv_4_5_p132 * Lambda_inv_3_3_p3 -
      (Lambda_inv_4_5_p129 * Lambda_inv_3_3_p2 + Lambda_inv_4_5_p130 * Lambda_inv_3_3_p1) +
      Lambda_inv_4_5_p134 * Lambda_inv_3_3_p5 + Lambda_inv_4_5_p136 * Lambda_inv_3_3_p6;
  const Real Lambda_inv_0_2_p1 = Lambda_inv_2_4_p1 * Lambda_inv_4_5_p50;
  const Real Lambda_inv_3_4_p1 = Lambda_inv_4_4_p11 * Lambda_inv_3_3_p2 - Lambda_inv_4_4_p12 *
      Lambda_inv_3_3_p1 + Lambda_inv_4_4_p14 * Lambda_inv_3_3_p3 + Lambda_inv_4_4_p15 *
      Lambda_inv_3_3_p5 + Lambda_inv_4_4_p17 * Lambda_inv_3_3_p6;
  const Real Lambda_inv_3_3_p8 = Lambda_inv_3_3_p7 * Lambda_inv_4_5_p104;
  const Real Lambda_inv_0_2_p2 = Lambda_inv_2_4_p2 * Lambda_inv_4_5_p80;
  const Real Lambda_inv_3_3_p9 = Lambda_inv_4_5_p92 * Lambda_inv_3_3_p1 - Lambda_inv_4_5_p97 *
      Lambda_inv_3_3_p3 - Lambda_inv_4_5_p101 * Lambda_inv_3_3_p5 - Lambda_inv_4_5_p105 *
      Lambda_inv_3_3_p6 - Lambda_inv_4_5_p118 * Lambda_inv_3_3_p7;
  const Real Lambda_inv_3_3_p10 = Lambda_inv_4_5_p115 * Lambda_inv_3_3_p3 - Lambda_inv_4_5_p112 *
      Lambda_inv_3_3_p1 - Lambda_inv_4_5_p116 * Lambda_inv_3_3_p5 - Lambda_inv_4_5_p120 *
      Lambda_inv_3_3_p6 - Lambda_inv_4_5_p123 * Lambda_inv_3_3_p7;
  const Real Lambda_inv_2_4_p3 = Lambda_inv_4_5_p85 * Lambda_inv_2_4_p1 - Lambda_inv_4_5_p95 *
      Lambda_inv_2_4_p2;
  const Real Lambda_inv_3_3_p11 = Lambda_inv_3_3_p9 * Lambda_inv_4_5_p125;
  const Real Lambda_inv_0_2_p3 = Lambda_inv_2_4_p3 * Lambda_inv_4_5_p104;
  const Real Lambda_inv_3_3_p12 = Lambda_inv_3_3_p10 - Lambda_inv_4_5_p133 * Lambda_inv_3_3_p9;
  const Real Lambda_inv_2_4_p4 = Lambda_inv_4_5_p101 * Lambda_inv_2_4_p1 - Lambda_inv_4_5_p105 *
      Lambda_inv_2_4_p2 - Lambda_inv_4_5_p118 * Lambda_inv_2_4_p3;
  const Real Lambda_inv_3_3_p13 = 24999.999999999996 * Lambda_inv_3_3_p2 * Lambda_inv_3_3_p2 +
      1557.24430048586 * Lambda_inv_3_3_p1 * Lambda_inv_3_3_p1 + Lambda_inv_3_3_p3 *
      Lambda_inv_4_5_p22 * Lambda_inv_3_3_p3;
  const Real Lambda_inv_3_3_p14 = Lambda_inv_3_3_p12 * Lambda_inv_4_5_p137;
  const Real Lambda_inv_3_5 = Lambda_inv_3_5_p1 + Lambda_inv_4_5_p139 * Lambda_inv_3_3_p7 -
      Lambda_inv_4_5_p141 * Lambda_inv_3_3_p9 + Lambda_inv_4_5_p143 * Lambda_inv_3_3_p12;
  Lambda_inv[23] = Lambda_inv_3_5;
  Lambda_inv[33] = Lambda_inv_3_5;
  const Real Lambda_inv_3_4 = Lambda_inv_3_4_p1 + Lambda_inv_4_4_p19 * Lambda_inv_3_3_p7 -
      Lambda_inv_4_4_p22 * Lambda_inv_3_3_p9 + Lambda_inv_4_4_p25 * Lambda_inv_3_3_p12;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;
  const Real Lambda_inv_2_4_p5 = Lambda_inv_4_5_p116 * Lambda_inv_2_4_p1 - Lambda_inv_4_5_p120 *
      Lambda_inv_2_4_p2 - Lambda_inv_4_5_p123 * Lambda_inv_2_4_p3 - Lambda_inv_4_5_p133 *
      Lambda_inv_2_4_p4;
  const Real Lambda_inv_0_1_p4 = Lambda_inv_1_5_p10 * Lambda_inv_4_5_p125;
  const Real Lambda_inv_0_2_p4 = Lambda_inv_2_4_p4 * Lambda_inv_4_5_p125;
  const Real Lambda_inv_3_3_p15 = Lambda_inv_3_3_p13 + Lambda_inv_0_3_p1 * Lambda_inv_3_3_p5 +
      Lambda_inv_0_3_p2 * Lambda_inv_3_3_p6 + Lambda_inv_3_3_p8 * Lambda_inv_3_3_p7 +
      Lambda_inv_3_3_p11 * Lambda_inv_3_3_p9;
  const Real Lambda_inv_0_1_p5 = Lambda_inv_1_5_p11 * Lambda_inv_4_5_p137;
  const Real Lambda_inv_0_3_p3 = Lambda_inv_3_5 * Lambda_inv_0_4_p9;
  const Real Lambda_inv_3_3 = Lambda_inv_3_3_p15 + Lambda_inv_3_3_p14 * Lambda_inv_3_3_p12;
  Lambda_inv[21] = Lambda_inv_3_3;
  const Real Lambda_inv_0_3_p4 = Lambda_inv_3_4 * Lambda_inv_0_4_p10;
  const Real Lambda_inv_0_2_p5 = Lambda_inv_2_4_p5 * Lambda_inv_4_5_p137;
  const Real Lambda_inv_1_4_p1 = Lambda_inv_4_5 * Lambda_inv_1_3_p1;
  const Real Lambda_inv_0_4_p12 = Lambda_inv_4_4_p15 * Lambda_inv_0_4_p3 + Lambda_inv_4_4_p17 *
      Lambda_inv_0_4_p6 - Lambda_inv_4_4_p19 * Lambda_inv_0_4_p7 - Lambda_inv_4_4_p22 *
      Lambda_inv_0_4_p8 + Lambda_inv_4_4_p25 * Lambda_inv_0_4_p11;
  const Real Lambda_inv_0_5_p1 = Lambda_inv_4_5_p134 * Lambda_inv_0_4_p3 + Lambda_inv_4_5_p136 *
      Lambda_inv_0_4_p6 - Lambda_inv_4_5_p139 * Lambda_inv_0_4_p7 - Lambda_inv_4_5_p141 *
      Lambda_inv_0_4_p8 + Lambda_inv_4_5_p143 * Lambda_inv_0_4_p11;
  const Real Lambda_inv_1_5_p12 = Lambda_inv_4_5_p134 * Lambda_inv_1_5_p1 + Lambda_inv_4_5_p136 *
      Lambda_inv_1_5_p4 + Lambda_inv_4_5_p139 * Lambda_inv_1_5_p9 - Lambda_inv_4_5_p141 *
      Lambda_inv_1_5_p10 - Lambda_inv_4_5_p143 * Lambda_inv_1_5_p11;
  const Real Lambda_inv_2_4_p6 = Lambda_inv_4_4_p17 * Lambda_inv_2_4_p2 - Lambda_inv_4_4_p15 *
      Lambda_inv_2_4_p1 + Lambda_inv_4_4_p19 * Lambda_inv_2_4_p3 - Lambda_inv_4_4_p22 *
      Lambda_inv_2_4_p4 + Lambda_inv_4_4_p25 * Lambda_inv_2_4_p5;
  const Real Lambda_inv_1_3_p2 = Lambda_inv_0_3_p1 * Lambda_inv_1_5_p1 + Lambda_inv_0_3_p2 *
      Lambda_inv_1_5_p4 + Lambda_inv_3_3_p8 * Lambda_inv_1_5_p9 + Lambda_inv_3_3_p11 *
      Lambda_inv_1_5_p10 - Lambda_inv_3_3_p14 * Lambda_inv_1_5_p11;
  const Real Lambda_inv_2_3_p1 = Lambda_inv_0_3_p2 * Lambda_inv_2_4_p2 - Lambda_inv_0_3_p1 *
      Lambda_inv_2_4_p1 + Lambda_inv_3_3_p8 * Lambda_inv_2_4_p3 + Lambda_inv_3_3_p11 *
      Lambda_inv_2_4_p4 + Lambda_inv_3_3_p14 * Lambda_inv_2_4_p5;
  const Real Lambda_inv_0_4 = Lambda_inv_0_4_p12 - (Lambda_inv_4_5 * Lambda_inv_0_4_p9 +
      Lambda_inv_4_4 * Lambda_inv_0_4_p10);
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[24] = Lambda_inv_0_4;
  const Real Lambda_inv_0_5 = Lambda_inv_0_5_p1 - (Lambda_inv_5_5 * Lambda_inv_0_4_p9 +
      Lambda_inv_4_5 * Lambda_inv_0_4_p10);
  Lambda_inv[5] = Lambda_inv_0_5;
  Lambda_inv[30] = Lambda_inv_0_5;
  const Real Lambda_inv_0_3_p5 = Lambda_inv_0_3_p1 * Lambda_inv_0_4_p3 + Lambda_inv_0_3_p2 *
      Lambda_inv_0_4_p6 - Lambda_inv_3_3_p8 * Lambda_inv_0_4_p7 + Lambda_inv_3_3_p11 *
      Lambda_inv_0_4_p8 + Lambda_inv_3_3_p14 * Lambda_inv_0_4_p11;
  const Real Lambda_inv_1_4_p2 = Lambda_inv_4_4_p15 * Lambda_inv_1_5_p1 + Lambda_inv_4_4_p17 *
      Lambda_inv_1_5_p4 + Lambda_inv_4_4_p19 * Lambda_inv_1_5_p9 - Lambda_inv_4_4_p22 *
      Lambda_inv_1_5_p10 - Lambda_inv_4_4_p25 * Lambda_inv_1_5_p11;
  const Real Lambda_inv_1_3 = Lambda_inv_1_3_p2 + (Lambda_inv_3_3 * Lambda_inv_0_4_p10 +
      Lambda_inv_3_5 * Lambda_inv_1_3_p1);
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  const Real Lambda_inv_1_5 = Lambda_inv_1_5_p12 + (Lambda_inv_3_5 * Lambda_inv_0_4_p10 +
      Lambda_inv_5_5 * Lambda_inv_1_3_p1);
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real Lambda_inv_2_4 = Lambda_inv_2_4_p6 - (Lambda_inv_4_4 * Lambda_inv_1_3_p1 -
      Lambda_inv_3_4 * Lambda_inv_0_4_p9);
  Lambda_inv[16] = Lambda_inv_2_4;
  Lambda_inv[26] = Lambda_inv_2_4;
  const Real Lambda_inv_2_3 = Lambda_inv_2_3_p1 - (Lambda_inv_3_4 * Lambda_inv_1_3_p1 -
      Lambda_inv_3_3 * Lambda_inv_0_4_p9);
  Lambda_inv[15] = Lambda_inv_2_3;
  Lambda_inv[20] = Lambda_inv_2_3;
  const Real Lambda_inv_0_3 = Lambda_inv_0_3_p5 - (Lambda_inv_0_3_p3 + Lambda_inv_0_3_p4);
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;
  const Real Lambda_inv_0_2_p6 = Lambda_inv_4_5_p136 * Lambda_inv_2_4_p2 - Lambda_inv_4_5_p134 *
      Lambda_inv_2_4_p1 + Lambda_inv_4_5_p139 * Lambda_inv_2_4_p3 - Lambda_inv_4_5_p141 *
      Lambda_inv_2_4_p4 + Lambda_inv_4_5_p143 * Lambda_inv_2_4_p5;
  const Real Lambda_inv_1_4 = Lambda_inv_1_4_p2 + (Lambda_inv_0_3_p4 + Lambda_inv_1_4_p1);
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_0_0_p1 = Lambda_inv_0_4_p3 * Lambda_inv_4_5_p50 * Lambda_inv_0_4_p3 +
      Lambda_inv_0_4_p6 * Lambda_inv_4_5_p80 * Lambda_inv_0_4_p6 + Lambda_inv_0_4_p7 *
      Lambda_inv_4_5_p104 * Lambda_inv_0_4_p7;
  const Real Lambda_inv_0_1_p6 = Lambda_inv_0_1_p2 * Lambda_inv_0_4_p3 + Lambda_inv_0_1_p1 *
      Lambda_inv_0_4_p6 - Lambda_inv_0_1_p3 * Lambda_inv_0_4_p7 + Lambda_inv_0_1_p4 *
      Lambda_inv_0_4_p8 - Lambda_inv_0_1_p5 * Lambda_inv_0_4_p11;
  const Real Lambda_inv_0_2_p7 = Lambda_inv_0_2_p2 * Lambda_inv_0_4_p6 - Lambda_inv_0_2_p1 *
      Lambda_inv_0_4_p3 - Lambda_inv_0_2_p3 * Lambda_inv_0_4_p7 + Lambda_inv_0_2_p4 *
      Lambda_inv_0_4_p8 + Lambda_inv_0_2_p5 * Lambda_inv_0_4_p11;
  const Real Lambda_inv_1_2_p1 = Lambda_inv_0_2_p2 * Lambda_inv_1_5_p4 - Lambda_inv_0_2_p1 *
      Lambda_inv_1_5_p1 + Lambda_inv_0_2_p3 * Lambda_inv_1_5_p9 + Lambda_inv_0_2_p4 *
      Lambda_inv_1_5_p10 - Lambda_inv_0_2_p5 * Lambda_inv_1_5_p11;
  const Real Lambda_inv_1_1_p1 = Lambda_inv_0_1_p2 * Lambda_inv_1_5_p1 + Lambda_inv_0_1_p1 *
      Lambda_inv_1_5_p4 + Lambda_inv_0_1_p3 * Lambda_inv_1_5_p9 + Lambda_inv_0_1_p4 *
      Lambda_inv_1_5_p10 + Lambda_inv_0_1_p5 * Lambda_inv_1_5_p11;
  const Real Lambda_inv_2_2_p1 = Lambda_inv_0_2_p1 * Lambda_inv_2_4_p1 + Lambda_inv_0_2_p2 *
      Lambda_inv_2_4_p2 + Lambda_inv_0_2_p3 * Lambda_inv_2_4_p3 + Lambda_inv_0_2_p4 *
      Lambda_inv_2_4_p4 + Lambda_inv_0_2_p5 * Lambda_inv_2_4_p5;
  Lambda_inv[0] = Lambda_inv_0_0_p1 + Lambda_inv_0_4_p8 * Lambda_inv_4_5_p125 * Lambda_inv_0_4_p8 +
      Lambda_inv_0_4_p11 * Lambda_inv_4_5_p137 * Lambda_inv_0_4_p11 -
      (Lambda_inv_0_4_p9 * (Lambda_inv_0_5_p1 + Lambda_inv_0_5) + Lambda_inv_0_4_p10 *
      (Lambda_inv_0_4_p12 + Lambda_inv_0_4));
  const Real Lambda_inv_0_1 = Lambda_inv_0_1_p6 - Lambda_inv_0_4_p9 * Lambda_inv_1_5_p12 +
      Lambda_inv_1_3_p1 * Lambda_inv_0_5 + (Lambda_inv_0_3 - Lambda_inv_1_4_p2) *
      Lambda_inv_0_4_p10;
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;
  const Real Lambda_inv_2_5 = Lambda_inv_0_2_p6 - (Lambda_inv_1_4_p1 - Lambda_inv_0_3_p3);
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;
  const Real Lambda_inv_0_2 = Lambda_inv_0_2_p7 - Lambda_inv_0_4_p10 * Lambda_inv_2_4_p6 -
      Lambda_inv_1_3_p1 * Lambda_inv_0_4 + (Lambda_inv_0_3 - Lambda_inv_0_2_p6) * Lambda_inv_0_4_p9;
  Lambda_inv[2] = Lambda_inv_0_2;
  Lambda_inv[12] = Lambda_inv_0_2;
  Lambda_inv[7] = Lambda_inv_1_1_p1 + (Lambda_inv_0_4_p10 * (Lambda_inv_1_3_p2 + Lambda_inv_1_3) +
      Lambda_inv_1_3_p1 * (Lambda_inv_1_5_p12 + Lambda_inv_1_5));
  const Real Lambda_inv_1_2 = Lambda_inv_1_2_p1 + Lambda_inv_0_4_p9 * Lambda_inv_1_3 +
      Lambda_inv_0_4_p10 * Lambda_inv_2_3_p1 + (Lambda_inv_0_2_p6 - Lambda_inv_1_4) *
      Lambda_inv_1_3_p1;
  Lambda_inv[8] = Lambda_inv_1_2;
  Lambda_inv[13] = Lambda_inv_1_2;
  Lambda_inv[14] = Lambda_inv_2_2_p1 - (Lambda_inv_1_3_p1 * (Lambda_inv_2_4_p6 + Lambda_inv_2_4) -
      Lambda_inv_0_4_p9 * (Lambda_inv_2_3_p1 + Lambda_inv_2_3));
}

}  // namespace samm

#undef TREELINE_RESTRICT
