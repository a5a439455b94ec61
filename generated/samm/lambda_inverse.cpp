// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J from poses, in the axes asked for at link origins.
// 982 flops (add 407, mul 569, div 6), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
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
  const Real Lambda_inv_4_5_p2 = s8 * Lambda_inv_4_5_p1;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p3 = s7 * (0.00010000000000000026 + Lambda_inv_4_5_p2);
  const Real Lambda_inv_4_5_p4 = s7 * Lambda_inv_4_5_p3;
  const Real Lambda_inv_4_5_p5 = 0.3056901365 + (0.0011921599999999998 - Lambda_inv_4_5_p2 +
      Lambda_inv_4_5_p4 + 0.0024946559999999996 * c8);

  // link 8 (link5), composite inertia
  const Real Lambda_inv_4_5_p6 = 0.00164 + Lambda_inv_4_5_p2;
  const Real Lambda_inv_4_5_p7 = 0.0028799999999999997 * s8;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p8 = c7 * Lambda_inv_4_5_p7;
  const Real Lambda_inv_4_5_p9 = 0.0067651125 + (Lambda_inv_4_5_p6 - 0.0406 * Lambda_inv_4_5_p8);

  // link 8 (link5), composite inertia
  const Real Lambda_inv_4_5_p10 = c8 * Lambda_inv_4_5_p1;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p11 = c7 * Lambda_inv_4_5_p10 + 0.4331 * Lambda_inv_4_5_p8;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p12 = Lambda_inv_4_5_p11 - 5.846399999999999e-05 * c8 -
      0.010673638499999999;

  // link 6 (link3), composite inertia
  const Real Lambda_inv_4_5_p13 = s6 * (Lambda_inv_4_5_p5 - Lambda_inv_4_5_p9) + c6 *
      (2.0 * Lambda_inv_4_5_p12);
  const Real Lambda_inv_4_5_p14 = s6 * Lambda_inv_4_5_p13;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p15 = s7 * Lambda_inv_4_5_p7;

  // link 8 (link5), composite inertia
  const Real Lambda_inv_4_5_p16 = 0.0028799999999999997 * c8;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p17 = 0.861795 + Lambda_inv_4_5_p16;
  const Real Lambda_inv_4_5_p18 = Lambda_inv_4_5_p8 - 0.025374999999999998;

  // link 6 (link3), mass matrix
  const Real Lambda_inv_4_5_p19 = s6 * Lambda_inv_4_5_p17 + c6 * Lambda_inv_4_5_p18;
  const Real Lambda_inv_4_5_p20 = 0.4318 * Lambda_inv_4_5_p19;

  // link 6 (link3), composite inertia
  const Real Lambda_inv_4_5_p21 = 1.674987602 + (Lambda_inv_4_5_p9 + Lambda_inv_4_5_p14 + 2.0 *
      (Lambda_inv_4_5_p20 + 0.1501 * Lambda_inv_4_5_p15));

  // link 6 (link3), mass matrix
  const Real Lambda_inv_4_5_p22 = c6 * Lambda_inv_4_5_p17 - s6 * Lambda_inv_4_5_p18;

  // link 5 (link2), composite inertia
  const Real Lambda_inv_4_5_p23 = s5 * (0.07312640000000001 +
      (Lambda_inv_4_5_p5 - Lambda_inv_4_5_p14 + 0.3002 * Lambda_inv_4_5_p15) - Lambda_inv_4_5_p21) +
      c5 * (2.0 * (c6 * Lambda_inv_4_5_p13 - Lambda_inv_4_5_p12 + 0.4318 * Lambda_inv_4_5_p22 -
      0.0070992));

  // link 9 (link6), mass matrix
  const Real Lambda_inv_4_5_p24 = 4e-05 * s8;
  const Real Lambda_inv_4_5_p25 = c7 * Lambda_inv_4_5_p24;
  const Real Lambda_inv_4_5_p26 = 4e-05 * c8;
  const Real Lambda_inv_4_5_p27 = s5 * (c6 * Lambda_inv_4_5_p25 + s6 * Lambda_inv_4_5_p26) + c5 *
      (s6 * Lambda_inv_4_5_p25 - c6 * Lambda_inv_4_5_p26);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p28 = 24999.999999999996 * Lambda_inv_4_5_p27;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p29 = s7 * Lambda_inv_4_5_p16;
  const Real Lambda_inv_4_5_p30 = 0.00064216 * s7 + 0.4331 * Lambda_inv_4_5_p29;
  const Real Lambda_inv_4_5_p31 = 0.0203 * Lambda_inv_4_5_p29;
  const Real Lambda_inv_4_5_p32 = c7 * Lambda_inv_4_5_p16;
  const Real Lambda_inv_4_5_p33 = s6 * Lambda_inv_4_5_p32 + c6 * Lambda_inv_4_5_p7;
  const Real Lambda_inv_4_5_p34 = c6 * Lambda_inv_4_5_p32 - s6 * Lambda_inv_4_5_p7;
  const Real Lambda_inv_4_5_p35 = c5 * (c6 * Lambda_inv_4_5_p31 - s6 * Lambda_inv_4_5_p30 +
      (0.1501 * Lambda_inv_4_5_p34 - 0.4318 * Lambda_inv_4_5_p29));
  const Real Lambda_inv_4_5_p36 = s5 * (c6 * Lambda_inv_4_5_p30 + s6 * Lambda_inv_4_5_p31 + 0.1501 *
      Lambda_inv_4_5_p33) - Lambda_inv_4_5_p35;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p37 = 1557.24430048586 * Lambda_inv_4_5_p36;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p38 = 0.0203 * Lambda_inv_4_5_p8;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p39 = Lambda_inv_4_5_p38 - Lambda_inv_4_5_p6;
  const Real Lambda_inv_4_5_p40 = s6 * Lambda_inv_4_5_p15;
  const Real Lambda_inv_4_5_p41 = c6 * Lambda_inv_4_5_p15;
  const Real Lambda_inv_4_5_p42 = c5 * (c6 * Lambda_inv_4_5_p39 - s6 * Lambda_inv_4_5_p11 -
      (0.1501 * Lambda_inv_4_5_p41 + 0.4318 * Lambda_inv_4_5_p8));

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p43 = 0.9999999999999999 * c8;
  const Real Lambda_inv_4_5_p44 = Lambda_inv_4_5_p43 * Lambda_inv_4_5_p27 -
      (s5 * (0.1501 * Lambda_inv_4_5_p40 - (c6 * Lambda_inv_4_5_p11 + s6 * Lambda_inv_4_5_p39)) +
      Lambda_inv_4_5_p42);
  const Real Lambda_inv_4_5_p45 = 1.0 / (Lambda_inv_4_5_p6 - Lambda_inv_4_5_p43 *
      Lambda_inv_4_5_p26);
  const Real Lambda_inv_4_5_p46 = Lambda_inv_4_5_p44 * Lambda_inv_4_5_p45;
  const Real Lambda_inv_4_5_p47 = 1.4717295504999999 +
      (Lambda_inv_4_5_p21 + s5 * Lambda_inv_4_5_p23) - Lambda_inv_4_5_p28 * Lambda_inv_4_5_p27 -
      Lambda_inv_4_5_p37 * Lambda_inv_4_5_p36 - Lambda_inv_4_5_p46 * Lambda_inv_4_5_p44;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_4_5_p48 = 0.0203 * Lambda_inv_4_5_p15 - c7 * Lambda_inv_4_5_p3;
  const Real Lambda_inv_4_5_p49 = s7 * Lambda_inv_4_5_p10 + 0.4331 * Lambda_inv_4_5_p15;
  const Real Lambda_inv_4_5_p50 = 0.004704000000000001 + Lambda_inv_4_5_p49;

  // link 6 (link3), mass matrix
  const Real Lambda_inv_4_5_p51 = c6 * Lambda_inv_4_5_p48 - s6 * Lambda_inv_4_5_p50 - 0.1501 *
      Lambda_inv_4_5_p19;
  const Real Lambda_inv_4_5_p52 = s6 * Lambda_inv_4_5_p48 + c6 * Lambda_inv_4_5_p50 + 0.1501 *
      Lambda_inv_4_5_p22;

  // link 9 (link6), mass matrix
  const Real Lambda_inv_4_5_p53 = s7 * Lambda_inv_4_5_p24;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p54 = 24999.999999999996 * Lambda_inv_4_5_p53;
  const Real Lambda_inv_4_5_p55 = Lambda_inv_4_5_p54 * Lambda_inv_4_5_p27;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p56 = 0.00064216 * c7 +
      (0.4331 * Lambda_inv_4_5_p32 - 5.846399999999999e-05 * s8);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p57 = 1557.24430048586 * Lambda_inv_4_5_p56;
  const Real Lambda_inv_4_5_p58 = Lambda_inv_4_5_p49 + Lambda_inv_4_5_p43 * Lambda_inv_4_5_p53;
  const Real Lambda_inv_4_5_p59 = Lambda_inv_4_5_p58 * Lambda_inv_4_5_p45;
  const Real Lambda_inv_4_5_p60 = Lambda_inv_4_5_p55 -
      (s5 * Lambda_inv_4_5_p51 + c5 * Lambda_inv_4_5_p52) - Lambda_inv_4_5_p57 *
      Lambda_inv_4_5_p36 + Lambda_inv_4_5_p59 * Lambda_inv_4_5_p44;
  const Real Lambda_inv_4_5_p61 = 0.312455249 + (0.00129216 - Lambda_inv_4_5_p4 + 2.0 *
      (0.0012473279999999998 * c8 - Lambda_inv_4_5_p38)) - Lambda_inv_4_5_p54 * Lambda_inv_4_5_p53;
  const Real Lambda_inv_4_5_p62 = 1.0 / (Lambda_inv_4_5_p61 - Lambda_inv_4_5_p57 *
      Lambda_inv_4_5_p56 - Lambda_inv_4_5_p59 * Lambda_inv_4_5_p58);
  const Real Lambda_inv_4_5_p63 = Lambda_inv_4_5_p60 * Lambda_inv_4_5_p62;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p64 = Lambda_inv_4_5_p56 + 0.4318 * Lambda_inv_4_5_p33;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p65 = Lambda_inv_4_5_p58 + 0.4318 * Lambda_inv_4_5_p40;
  const Real Lambda_inv_4_5_p66 = Lambda_inv_4_5_p61 + Lambda_inv_4_5_p20 - Lambda_inv_4_5_p57 *
      Lambda_inv_4_5_p64 - Lambda_inv_4_5_p59 * Lambda_inv_4_5_p65;
  const Real Lambda_inv_4_5_p67 = Lambda_inv_4_5_p66 * Lambda_inv_4_5_p62;
  const Real Lambda_inv_4_5_p68 = Lambda_inv_4_5_p55 -
      (s5 * (Lambda_inv_4_5_p51 - 0.4318 * Lambda_inv_4_5_p15 - 0.690314699) + c5 *
      (Lambda_inv_4_5_p52 - 0.023750999999999998));
  const Real Lambda_inv_4_5_p69 = 1557.24430048586 * Lambda_inv_4_5_p64;
  const Real Lambda_inv_4_5_p70 = Lambda_inv_4_5_p65 * Lambda_inv_4_5_p45;
  const Real Lambda_inv_4_5_p71 = Lambda_inv_4_5_p68 - Lambda_inv_4_5_p69 * Lambda_inv_4_5_p36 +
      Lambda_inv_4_5_p70 * Lambda_inv_4_5_p44 - Lambda_inv_4_5_p67 * Lambda_inv_4_5_p60;
  const Real Lambda_inv_4_5_p72 = 1.7481140020000001 + Lambda_inv_4_5_p61 + 0.8636 *
      Lambda_inv_4_5_p19 - Lambda_inv_4_5_p69 * Lambda_inv_4_5_p64 - Lambda_inv_4_5_p70 *
      Lambda_inv_4_5_p65 - Lambda_inv_4_5_p67 * Lambda_inv_4_5_p66;
  const Real Lambda_inv_4_5_p73 = 1.0 / Lambda_inv_4_5_p72;
  const Real Lambda_inv_4_5_p74 = Lambda_inv_4_5_p71 * Lambda_inv_4_5_p73;
  const Real Lambda_inv_4_5_p75 = 1.0 / (Lambda_inv_4_5_p47 - Lambda_inv_4_5_p63 *
      Lambda_inv_4_5_p60 - Lambda_inv_4_5_p74 * Lambda_inv_4_5_p71);

  // link 6 (link3), mass matrix
  const Real Lambda_inv_4_5_p76 = s5 * Lambda_inv_4_5_p19 - c5 * Lambda_inv_4_5_p22;
  const Real Lambda_inv_4_5_p77 = c4 * Lambda_inv_4_5_p76;
  const Real Lambda_inv_4_5_p78 = s4 * Lambda_inv_4_5_p76;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p79 = s5 * Lambda_inv_4_5_p33 - c5 * Lambda_inv_4_5_p34;
  const Real Lambda_inv_4_5_p80 = c4 * Lambda_inv_4_5_p29 - s4 * Lambda_inv_4_5_p79;
  const Real Lambda_inv_4_5_p81 = c4 * Lambda_inv_4_5_p79 + s4 * Lambda_inv_4_5_p29;
  const Real Lambda_inv_4_5_p82 = c3 * Lambda_inv_4_5_p80 - s3 * Lambda_inv_4_5_p81;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p83 = c5 * Lambda_inv_4_5_p41 - s5 * Lambda_inv_4_5_p40;
  const Real Lambda_inv_4_5_p84 = c4 * Lambda_inv_4_5_p8 - s4 * Lambda_inv_4_5_p83;
  const Real Lambda_inv_4_5_p85 = c4 * Lambda_inv_4_5_p83 + s4 * Lambda_inv_4_5_p8;
  const Real Lambda_inv_4_5_p86 = c3 * Lambda_inv_4_5_p84 - s3 * Lambda_inv_4_5_p85;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p87 = Lambda_inv_4_5_p59 * Lambda_inv_4_5_p86 -
      (s3 * Lambda_inv_4_5_p77 + c3 * Lambda_inv_4_5_p78 + Lambda_inv_4_5_p57 * Lambda_inv_4_5_p82);

  // link 6 (link3), composite inertia
  const Real Lambda_inv_4_5_p88 = 0.10439999999999999 - Lambda_inv_4_5_p22;
  const Real Lambda_inv_4_5_p89 = 3.79559 + Lambda_inv_4_5_p19;

  // link 5 (link2), mass matrix
  const Real Lambda_inv_4_5_p90 = c5 * Lambda_inv_4_5_p88 + s5 * Lambda_inv_4_5_p89;
  const Real Lambda_inv_4_5_p91 = c4 * Lambda_inv_4_5_p90;
  const Real Lambda_inv_4_5_p92 = s4 * Lambda_inv_4_5_p90;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p93 = Lambda_inv_4_5_p70 * Lambda_inv_4_5_p86 -
      (s3 * Lambda_inv_4_5_p91 + c3 * Lambda_inv_4_5_p92 + Lambda_inv_4_5_p69 *
      Lambda_inv_4_5_p82) - Lambda_inv_4_5_p67 * Lambda_inv_4_5_p87;

  // link 5 (link2), composite inertia
  const Real Lambda_inv_4_5_p94 = s5 * Lambda_inv_4_5_p88 - c5 * Lambda_inv_4_5_p89;
  const Real Lambda_inv_4_5_p95 = 4.9338049999999996 + Lambda_inv_4_5_p15;

  // link 4 (link1), mass matrix
  const Real Lambda_inv_4_5_p96 = s4 * Lambda_inv_4_5_p94 - c4 * Lambda_inv_4_5_p95;
  const Real Lambda_inv_4_5_p97 = s4 * Lambda_inv_4_5_p95 + c4 * Lambda_inv_4_5_p94;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p98 = s3 * Lambda_inv_4_5_p96 - c3 * Lambda_inv_4_5_p97 -
      Lambda_inv_4_5_p37 * Lambda_inv_4_5_p82 - Lambda_inv_4_5_p46 * Lambda_inv_4_5_p86 -
      Lambda_inv_4_5_p63 * Lambda_inv_4_5_p87;
  const Real Lambda_inv_4_5_p99 = Lambda_inv_4_5_p98 - Lambda_inv_4_5_p74 * Lambda_inv_4_5_p93;
  const Real Lambda_inv_4_5_p100 = Lambda_inv_4_5_p99 * Lambda_inv_4_5_p75;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_4_5_p101 = c3 * Lambda_inv_4_5_p81 + s3 * Lambda_inv_4_5_p80;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_4_5_p102 = c3 * Lambda_inv_4_5_p85 + s3 * Lambda_inv_4_5_p84;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p103 = s3 * Lambda_inv_4_5_p78 - c3 * Lambda_inv_4_5_p77 +
      Lambda_inv_4_5_p57 * Lambda_inv_4_5_p101 - Lambda_inv_4_5_p59 * Lambda_inv_4_5_p102;
  const Real Lambda_inv_4_5_p104 = s3 * Lambda_inv_4_5_p92 - c3 * Lambda_inv_4_5_p91 +
      Lambda_inv_4_5_p69 * Lambda_inv_4_5_p101 - Lambda_inv_4_5_p70 * Lambda_inv_4_5_p102 -
      Lambda_inv_4_5_p67 * Lambda_inv_4_5_p103;
  const Real Lambda_inv_4_5_p105 = c3 * Lambda_inv_4_5_p96 + s3 * Lambda_inv_4_5_p97 +
      Lambda_inv_4_5_p37 * Lambda_inv_4_5_p101 + Lambda_inv_4_5_p46 * Lambda_inv_4_5_p102 -
      Lambda_inv_4_5_p63 * Lambda_inv_4_5_p103;
  const Real Lambda_inv_4_5_p106 = Lambda_inv_4_5_p105 - Lambda_inv_4_5_p74 * Lambda_inv_4_5_p104;
  const Real Lambda_inv_4_5_p107 = Lambda_inv_4_5_p93 * Lambda_inv_4_5_p73;
  const Real Lambda_inv_4_5_p108 = Lambda_inv_4_5_p87 * Lambda_inv_4_5_p62;
  const Real Lambda_inv_4_5_p109 = 1557.24430048586 * Lambda_inv_4_5_p82;
  const Real Lambda_inv_4_5_p110 = Lambda_inv_4_5_p86 * Lambda_inv_4_5_p45;
  const Real Lambda_inv_4_5_p111 = Lambda_inv_4_5_p109 * Lambda_inv_4_5_p101 + Lambda_inv_4_5_p110 *
      Lambda_inv_4_5_p102 - Lambda_inv_4_5_p108 * Lambda_inv_4_5_p103 - Lambda_inv_4_5_p107 *
      Lambda_inv_4_5_p104 - Lambda_inv_4_5_p100 * Lambda_inv_4_5_p106;
  const Real Lambda_inv_4_5_p112 = 186.45 - Lambda_inv_4_5_p109 * Lambda_inv_4_5_p82 -
      Lambda_inv_4_5_p110 * Lambda_inv_4_5_p86 - Lambda_inv_4_5_p108 * Lambda_inv_4_5_p87 -
      Lambda_inv_4_5_p107 * Lambda_inv_4_5_p93;
  const Real Lambda_inv_4_5_p113 = 1.0 / (Lambda_inv_4_5_p112 - Lambda_inv_4_5_p100 *
      Lambda_inv_4_5_p99);
  const Real Lambda_inv_4_5_p114 = Lambda_inv_4_5_p111 * Lambda_inv_4_5_p113;

  // link 6 (link3), pose
  const Real Lambda_inv_4_5_p115 = c6 * s5 + s6 * c5;
  const Real Lambda_inv_4_5_p116 = s6 * s5 - c6 * c5;

  // link 8 (link5), pose
  const Real Lambda_inv_4_5_p117 = s8 * (c7 * Lambda_inv_4_5_p115) + c8 * Lambda_inv_4_5_p116;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p118 = Lambda_inv_4_5_p54 * Lambda_inv_4_5_p117;

  // link 7 (link4), pose
  const Real Lambda_inv_4_5_p119 = s7 * Lambda_inv_4_5_p115;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p120 = Lambda_inv_4_5_p43 * Lambda_inv_4_5_p117 - Lambda_inv_4_5_p116;
  const Real Lambda_inv_4_5_p121 = Lambda_inv_4_5_p118 - Lambda_inv_4_5_p57 * Lambda_inv_4_5_p119 +
      Lambda_inv_4_5_p59 * Lambda_inv_4_5_p120;
  const Real Lambda_inv_4_5_p122 = Lambda_inv_4_5_p118 - Lambda_inv_4_5_p69 * Lambda_inv_4_5_p119 +
      Lambda_inv_4_5_p70 * Lambda_inv_4_5_p120 - Lambda_inv_4_5_p67 * Lambda_inv_4_5_p121;
  const Real Lambda_inv_4_5_p123 = 1.0 - Lambda_inv_4_5_p28 * Lambda_inv_4_5_p117 -
      Lambda_inv_4_5_p37 * Lambda_inv_4_5_p119 - Lambda_inv_4_5_p46 * Lambda_inv_4_5_p120 -
      Lambda_inv_4_5_p63 * Lambda_inv_4_5_p121;
  const Real Lambda_inv_4_5_p124 = Lambda_inv_4_5_p123 - Lambda_inv_4_5_p74 * Lambda_inv_4_5_p122;
  const Real Lambda_inv_4_5_p125 = Lambda_inv_4_5_p109 * Lambda_inv_4_5_p119 + Lambda_inv_4_5_p110 *
      Lambda_inv_4_5_p120 + Lambda_inv_4_5_p108 * Lambda_inv_4_5_p121 + Lambda_inv_4_5_p107 *
      Lambda_inv_4_5_p122 + Lambda_inv_4_5_p100 * Lambda_inv_4_5_p124;
  const Real Lambda_inv_4_5_p126 = Lambda_inv_4_5_p106 * Lambda_inv_4_5_p75;
  const Real Lambda_inv_4_5_p127 = Lambda_inv_4_5_p104 * Lambda_inv_4_5_p73;
  const Real Lambda_inv_4_5_p128 = Lambda_inv_4_5_p103 * Lambda_inv_4_5_p62;
  const Real Lambda_inv_4_5_p129 = 1557.24430048586 * Lambda_inv_4_5_p101;
  const Real Lambda_inv_4_5_p130 = Lambda_inv_4_5_p102 * Lambda_inv_4_5_p45;
  const Real Lambda_inv_4_5_p131 = Lambda_inv_4_5_p129 * Lambda_inv_4_5_p119 + Lambda_inv_4_5_p130 *
      Lambda_inv_4_5_p120 - Lambda_inv_4_5_p128 * Lambda_inv_4_5_p121 - Lambda_inv_4_5_p127 *
      Lambda_inv_4_5_p122 - Lambda_inv_4_5_p126 * Lambda_inv_4_5_p124;
  const Real Lambda_inv_4_5_p132 = Lambda_inv_4_5_p131 + Lambda_inv_4_5_p114 * Lambda_inv_4_5_p125;
  const Real Lambda_inv_4_5_p133 = 186.45 - Lambda_inv_4_5_p129 * Lambda_inv_4_5_p101 -
      Lambda_inv_4_5_p130 * Lambda_inv_4_5_p102 - Lambda_inv_4_5_p128 * Lambda_inv_4_5_p103 -
      Lambda_inv_4_5_p127 * Lambda_inv_4_5_p104;
  const Real Lambda_inv_4_5_p134 = 1.0 / (Lambda_inv_4_5_p133 - Lambda_inv_4_5_p126 *
      Lambda_inv_4_5_p106 - Lambda_inv_4_5_p114 * Lambda_inv_4_5_p111);
  const Real Lambda_inv_4_5_p135 = Lambda_inv_4_5_p132 * Lambda_inv_4_5_p134;

  // link 4 (link1), pose
  const Real Lambda_inv_4_5_p136 = c4 * s3 + s4 * c3;

  // link 5 (link2), pose
  const Real Lambda_inv_4_5_p137 = c5 * Lambda_inv_4_5_p136;
  const Real Lambda_inv_4_5_p138 = s5 * Lambda_inv_4_5_p136;

  // link 6 (link3), pose
  const Real Lambda_inv_4_5_p139 = c6 * Lambda_inv_4_5_p137 - s6 * Lambda_inv_4_5_p138;

  // link 4 (link1), pose
  const Real Lambda_inv_4_5_p140 = c4 * c3 - s4 * s3;

  // link 6 (link3), pose
  const Real Lambda_inv_4_5_p141 = s6 * Lambda_inv_4_5_p137 + c6 * Lambda_inv_4_5_p138;

  // link 8 (link5), pose
  const Real Lambda_inv_4_5_p142 = s8 * (c7 * Lambda_inv_4_5_p139 + s7 * Lambda_inv_4_5_p140) + c8 *
      Lambda_inv_4_5_p141;

  // link 7 (link4), pose
  const Real Lambda_inv_4_5_p143 = c7 * Lambda_inv_4_5_p140 - s7 * Lambda_inv_4_5_p139;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p144 = Lambda_inv_4_5_p141 - Lambda_inv_4_5_p43 * Lambda_inv_4_5_p142;
  const Real Lambda_inv_4_5_p145 = Lambda_inv_4_5_p140 - Lambda_inv_4_5_p54 * Lambda_inv_4_5_p142;
  const Real Lambda_inv_4_5_p146 = Lambda_inv_4_5_p145 - Lambda_inv_4_5_p57 * Lambda_inv_4_5_p143 +
      Lambda_inv_4_5_p59 * Lambda_inv_4_5_p144;
  const Real Lambda_inv_4_5_p147 = Lambda_inv_4_5_p145 - Lambda_inv_4_5_p69 * Lambda_inv_4_5_p143 +
      Lambda_inv_4_5_p70 * Lambda_inv_4_5_p144 - Lambda_inv_4_5_p67 * Lambda_inv_4_5_p146;
  const Real Lambda_inv_4_5_p148 = Lambda_inv_4_5_p28 * Lambda_inv_4_5_p142 - Lambda_inv_4_5_p37 *
      Lambda_inv_4_5_p143 - Lambda_inv_4_5_p46 * Lambda_inv_4_5_p144 - Lambda_inv_4_5_p63 *
      Lambda_inv_4_5_p146 - Lambda_inv_4_5_p74 * Lambda_inv_4_5_p147;
  const Real Lambda_inv_4_5_p149 = Lambda_inv_4_5_p109 * Lambda_inv_4_5_p143 + Lambda_inv_4_5_p110 *
      Lambda_inv_4_5_p144 + Lambda_inv_4_5_p108 * Lambda_inv_4_5_p146 + Lambda_inv_4_5_p107 *
      Lambda_inv_4_5_p147 + Lambda_inv_4_5_p100 * Lambda_inv_4_5_p148;
  const Real Lambda_inv_4_5_p150 = Lambda_inv_4_5_p129 * Lambda_inv_4_5_p143 + Lambda_inv_4_5_p130 *
      Lambda_inv_4_5_p144 - Lambda_inv_4_5_p128 * Lambda_inv_4_5_p146 - Lambda_inv_4_5_p127 *
      Lambda_inv_4_5_p147 - Lambda_inv_4_5_p126 * Lambda_inv_4_5_p148;
  const Real Lambda_inv_4_5_p151 = Lambda_inv_4_5_p150 + Lambda_inv_4_5_p114 * Lambda_inv_4_5_p149;
  const Real Lambda_inv_4_5_p152 = Lambda_inv_4_5_p125 * Lambda_inv_4_5_p113;
  const Real Lambda_inv_4_5_p153 = Lambda_inv_4_5_p124 * Lambda_inv_4_5_p75;
  const Real Lambda_inv_4_5_p154 = Lambda_inv_4_5_p122 * Lambda_inv_4_5_p73;
  const Real Lambda_inv_4_5_p155 = Lambda_inv_4_5_p121 * Lambda_inv_4_5_p62;
  const Real Lambda_inv_4_5_p156 = 24999.999999999996 * Lambda_inv_4_5_p117;
  const Real Lambda_inv_4_5_p157 = 1557.24430048586 * Lambda_inv_4_5_p119;
  const Real Lambda_inv_4_5_p158 = Lambda_inv_4_5_p120 * Lambda_inv_4_5_p45;
  const Real Lambda_inv_4_5_p159 = Lambda_inv_4_5_p157 * Lambda_inv_4_5_p143 - Lambda_inv_4_5_p156 *
      Lambda_inv_4_5_p142 + Lambda_inv_4_5_p158 * Lambda_inv_4_5_p144 + Lambda_inv_4_5_p155 *
      Lambda_inv_4_5_p146 + Lambda_inv_4_5_p154 * Lambda_inv_4_5_p147;
  const Real Lambda_inv_4_5 = Lambda_inv_4_5_p159 + Lambda_inv_4_5_p153 * Lambda_inv_4_5_p148 +
      Lambda_inv_4_5_p152 * Lambda_inv_4_5_p149 + Lambda_inv_4_5_p135 * Lambda_inv_4_5_p151;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
  const Real Lambda_inv_0_4_p1 = 0.05625 * Lambda_inv_4_5_p142;
  const Real Lambda_inv_4_4_p1 = Lambda_inv_4_5_p151 * Lambda_inv_4_5_p134;
  const Real Lambda_inv_4_4_p2 = Lambda_inv_4_5_p149 * Lambda_inv_4_5_p113;
  const Real Lambda_inv_4_4_p3 = Lambda_inv_4_5_p148 * Lambda_inv_4_5_p75;
  const Real Lambda_inv_4_4_p4 = 24999.999999999996 * Lambda_inv_4_5_p142;
  const Real Lambda_inv_4_4_p5 = 1557.24430048586 * Lambda_inv_4_5_p143;
  const Real Lambda_inv_4_4_p6 = Lambda_inv_4_5_p144 * Lambda_inv_4_5_p45;
  const Real Lambda_inv_4_4_p7 = Lambda_inv_4_5_p146 * Lambda_inv_4_5_p62;
  const Real Lambda_inv_4_4_p8 = Lambda_inv_4_5_p147 * Lambda_inv_4_5_p73;
  const Real Lambda_inv_4_4_p9 = Lambda_inv_4_4_p4 * Lambda_inv_4_5_p142 + Lambda_inv_4_4_p5 *
      Lambda_inv_4_5_p143 + Lambda_inv_4_4_p6 * Lambda_inv_4_5_p144 + Lambda_inv_4_4_p7 *
      Lambda_inv_4_5_p146 + Lambda_inv_4_4_p8 * Lambda_inv_4_5_p147;
  const Real Lambda_inv_4_4 = Lambda_inv_4_4_p9 + Lambda_inv_4_4_p3 * Lambda_inv_4_5_p148 +
      Lambda_inv_4_4_p2 * Lambda_inv_4_5_p149 + Lambda_inv_4_4_p1 * Lambda_inv_4_5_p151;
  Lambda_inv[28] = Lambda_inv_4_4;
  const Real Lambda_inv_0_4_p2 = 0.05625 * Lambda_inv_4_5_p117;

  // link 7 (link4), pose
  const Real Lambda_inv_0_4_p3 = 0.0203 * Lambda_inv_4_5_p115 - 0.4331 * Lambda_inv_4_5_p116;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_0_4_p4 = Lambda_inv_4_5_p140 * Lambda_inv_0_4_p3;
  const Real Lambda_inv_0_4_p5 = Lambda_inv_0_4_p3 - 0.4318 * s5;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p6 = Lambda_inv_4_5_p140 * Lambda_inv_0_4_p5 - Lambda_inv_4_5_p67 *
      Lambda_inv_0_4_p4;

  // link 7 (link4), pose
  const Real Lambda_inv_0_4_p7 = 0.4331 * Lambda_inv_4_5_p141 - 0.0203 * Lambda_inv_4_5_p139;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_0_4_p8 = Lambda_inv_0_4_p7 +
      (0.4318 * Lambda_inv_4_5_p137 + 0.1501 * Lambda_inv_4_5_p140);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p9 = Lambda_inv_0_4_p8 + Lambda_inv_4_5_p63 * Lambda_inv_0_4_p4 +
      Lambda_inv_4_5_p74 * Lambda_inv_0_4_p6;
  const Real Lambda_inv_0_4_p10 = Lambda_inv_4_5_p100 * Lambda_inv_0_4_p9 -
      (Lambda_inv_4_5_p108 * Lambda_inv_0_4_p4 + Lambda_inv_4_5_p107 * Lambda_inv_0_4_p6);
  const Real Lambda_inv_0_4_p11 = 1.0 - Lambda_inv_4_5_p128 * Lambda_inv_0_4_p4 -
      Lambda_inv_4_5_p127 * Lambda_inv_0_4_p6 + Lambda_inv_4_5_p126 * Lambda_inv_0_4_p9 -
      Lambda_inv_4_5_p114 * Lambda_inv_0_4_p10;
  const Real Lambda_inv_0_4_p12 = Lambda_inv_4_4_p7 * Lambda_inv_0_4_p4 + Lambda_inv_4_4_p8 *
      Lambda_inv_0_4_p6 - Lambda_inv_4_4_p3 * Lambda_inv_0_4_p9 - Lambda_inv_4_4_p2 *
      Lambda_inv_0_4_p10 + Lambda_inv_4_4_p1 * Lambda_inv_0_4_p11;
  const Real Lambda_inv_0_4 = Lambda_inv_0_4_p12 - (Lambda_inv_4_5 * Lambda_inv_0_4_p1 +
      Lambda_inv_4_4 * Lambda_inv_0_4_p2);
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[24] = Lambda_inv_0_4;
  const Real Lambda_inv_5_5_p1 = Lambda_inv_4_5_p156 * Lambda_inv_4_5_p117 + Lambda_inv_4_5_p157 *
      Lambda_inv_4_5_p119 + Lambda_inv_4_5_p158 * Lambda_inv_4_5_p120 + Lambda_inv_4_5_p155 *
      Lambda_inv_4_5_p121 + Lambda_inv_4_5_p154 * Lambda_inv_4_5_p122;
  const Real Lambda_inv_5_5 = Lambda_inv_5_5_p1 + Lambda_inv_4_5_p153 * Lambda_inv_4_5_p124 +
      Lambda_inv_4_5_p152 * Lambda_inv_4_5_p125 + Lambda_inv_4_5_p135 * Lambda_inv_4_5_p132;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real Lambda_inv_0_5_p1 = Lambda_inv_4_5_p155 * Lambda_inv_0_4_p4 + Lambda_inv_4_5_p154 *
      Lambda_inv_0_4_p6 - Lambda_inv_4_5_p153 * Lambda_inv_0_4_p9 - Lambda_inv_4_5_p152 *
      Lambda_inv_0_4_p10 + Lambda_inv_4_5_p135 * Lambda_inv_0_4_p11;
  const Real Lambda_inv_0_5 = Lambda_inv_0_5_p1 - (Lambda_inv_5_5 * Lambda_inv_0_4_p1 +
      Lambda_inv_4_5 * Lambda_inv_0_4_p2);
  Lambda_inv[5] = Lambda_inv_0_5;
  Lambda_inv[30] = Lambda_inv_0_5;
  const Real Lambda_inv_0_0_p1 = Lambda_inv_0_4_p4 * Lambda_inv_4_5_p62 * Lambda_inv_0_4_p4 +
      Lambda_inv_0_4_p6 * Lambda_inv_4_5_p73 * Lambda_inv_0_4_p6 + Lambda_inv_0_4_p9 *
      Lambda_inv_4_5_p75 * Lambda_inv_0_4_p9;
  Lambda_inv[0] = Lambda_inv_0_0_p1 + Lambda_inv_0_4_p10 * Lambda_inv_4_5_p113 *
      Lambda_inv_0_4_p10 + Lambda_inv_0_4_p11 * Lambda_inv_4_5_p134 * Lambda_inv_0_4_p11 -
      (Lambda_inv_0_4_p1 * (Lambda_inv_0_5_p1 + Lambda_inv_0_5) + Lambda_inv_0_4_p2 *
      (Lambda_inv_0_4_p12 + Lambda_inv_0_4));

  // link 6 (link3), Jacobian
  const Real Lambda_inv_0_1_p1 = Lambda_inv_4_5_p136 * Lambda_inv_0_4_p3;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_1_p2 = Lambda_inv_4_5_p136 * Lambda_inv_0_4_p5 - Lambda_inv_4_5_p67 *
      Lambda_inv_0_1_p1;

  // link 5 (link2), pose
  const Real Lambda_inv_0_1_p3 = c5 * Lambda_inv_4_5_p140;
  const Real Lambda_inv_0_1_p4 = s5 * Lambda_inv_4_5_p140;

  // link 6 (link3), pose
  const Real Lambda_inv_0_1_p5 = s6 * Lambda_inv_0_1_p3 + c6 * Lambda_inv_0_1_p4;
  const Real Lambda_inv_0_1_p6 = c6 * Lambda_inv_0_1_p3 - s6 * Lambda_inv_0_1_p4;

  // link 7 (link4), pose
  const Real Lambda_inv_0_1_p7 = 0.4331 * Lambda_inv_0_1_p5 - 0.0203 * Lambda_inv_0_1_p6;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_0_1_p8 = Lambda_inv_0_1_p7 +
      (0.4318 * Lambda_inv_0_1_p3 - 0.1501 * Lambda_inv_4_5_p136);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_1_p9 = Lambda_inv_0_1_p8 - Lambda_inv_4_5_p63 * Lambda_inv_0_1_p1 -
      Lambda_inv_4_5_p74 * Lambda_inv_0_1_p2;
  const Real Lambda_inv_0_1_p10 = 1.0 - Lambda_inv_4_5_p108 * Lambda_inv_0_1_p1 -
      Lambda_inv_4_5_p107 * Lambda_inv_0_1_p2 - Lambda_inv_4_5_p100 * Lambda_inv_0_1_p9;
  const Real Lambda_inv_0_1_p11 = Lambda_inv_4_5_p128 * Lambda_inv_0_1_p1 + Lambda_inv_4_5_p127 *
      Lambda_inv_0_1_p2 + Lambda_inv_4_5_p126 * Lambda_inv_0_1_p9 + Lambda_inv_4_5_p114 *
      Lambda_inv_0_1_p10;
  const Real Lambda_inv_0_1_p12 = Lambda_inv_0_1_p11 * Lambda_inv_4_5_p134;
  const Real Lambda_inv_0_1_p13 = Lambda_inv_0_1_p10 * Lambda_inv_4_5_p113;
  const Real Lambda_inv_0_1_p14 = Lambda_inv_0_1_p9 * Lambda_inv_4_5_p75;
  const Real Lambda_inv_0_1_p15 = Lambda_inv_0_1_p2 * Lambda_inv_4_5_p73;
  const Real Lambda_inv_0_1_p16 = Lambda_inv_0_1_p1 * Lambda_inv_4_5_p62;
  const Real Lambda_inv_0_1_p17 = Lambda_inv_0_1_p16 * Lambda_inv_0_4_p4 + Lambda_inv_0_1_p15 *
      Lambda_inv_0_4_p6 - Lambda_inv_0_1_p14 * Lambda_inv_0_4_p9 + Lambda_inv_0_1_p13 *
      Lambda_inv_0_4_p10 - Lambda_inv_0_1_p12 * Lambda_inv_0_4_p11;
  const Real Lambda_inv_0_1_p18 = Lambda_inv_4_5_p155 * Lambda_inv_0_1_p1 + Lambda_inv_4_5_p154 *
      Lambda_inv_0_1_p2 + Lambda_inv_4_5_p153 * Lambda_inv_0_1_p9 - Lambda_inv_4_5_p152 *
      Lambda_inv_0_1_p10 - Lambda_inv_4_5_p135 * Lambda_inv_0_1_p11;

  // link 8 (link5), pose
  const Real Lambda_inv_0_1_p19 = s8 * (c7 * Lambda_inv_0_1_p6 - s7 * Lambda_inv_4_5_p136) + c8 *
      Lambda_inv_0_1_p5;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_1_p20 = 0.05625 * Lambda_inv_0_1_p19;

  // link 7 (link4), pose
  const Real Lambda_inv_3_5_p1 = s7 * Lambda_inv_0_1_p6 + c7 * Lambda_inv_4_5_p136;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_3_5_p2 = Lambda_inv_0_1_p5 - Lambda_inv_4_5_p43 * Lambda_inv_0_1_p19;
  const Real Lambda_inv_3_5_p3 = Lambda_inv_4_5_p136 + Lambda_inv_4_5_p54 * Lambda_inv_0_1_p19;
  const Real Lambda_inv_3_5_p4 = Lambda_inv_4_5_p57 * Lambda_inv_3_5_p1 - Lambda_inv_3_5_p3 +
      Lambda_inv_4_5_p59 * Lambda_inv_3_5_p2;
  const Real Lambda_inv_3_5_p5 = Lambda_inv_4_5_p69 * Lambda_inv_3_5_p1 - Lambda_inv_3_5_p3 +
      Lambda_inv_4_5_p70 * Lambda_inv_3_5_p2 - Lambda_inv_4_5_p67 * Lambda_inv_3_5_p4;
  const Real Lambda_inv_3_5_p6 = Lambda_inv_4_5_p28 * Lambda_inv_0_1_p19 + Lambda_inv_4_5_p37 *
      Lambda_inv_3_5_p1 - Lambda_inv_4_5_p46 * Lambda_inv_3_5_p2 - Lambda_inv_4_5_p63 *
      Lambda_inv_3_5_p4 - Lambda_inv_4_5_p74 * Lambda_inv_3_5_p5;
  const Real Lambda_inv_3_5_p7 = Lambda_inv_4_5_p109 * Lambda_inv_3_5_p1 - Lambda_inv_4_5_p110 *
      Lambda_inv_3_5_p2 - Lambda_inv_4_5_p108 * Lambda_inv_3_5_p4 - Lambda_inv_4_5_p107 *
      Lambda_inv_3_5_p5 - Lambda_inv_4_5_p100 * Lambda_inv_3_5_p6;
  const Real Lambda_inv_3_5_p8 = Lambda_inv_4_5_p130 * Lambda_inv_3_5_p2 - Lambda_inv_4_5_p129 *
      Lambda_inv_3_5_p1 - Lambda_inv_4_5_p128 * Lambda_inv_3_5_p4 - Lambda_inv_4_5_p127 *
      Lambda_inv_3_5_p5 - Lambda_inv_4_5_p126 * Lambda_inv_3_5_p6;
  const Real Lambda_inv_3_5_p9 = Lambda_inv_3_5_p8 - Lambda_inv_4_5_p114 * Lambda_inv_3_5_p7;
  const Real Lambda_inv_3_5_p10 = Lambda_inv_4_5_p158 * Lambda_inv_3_5_p2 -
      (Lambda_inv_4_5_p156 * Lambda_inv_0_1_p19 + Lambda_inv_4_5_p157 * Lambda_inv_3_5_p1) +
      Lambda_inv_4_5_p155 * Lambda_inv_3_5_p4 + Lambda_inv_4_5_p154 * Lambda_inv_3_5_p5;
  const Real Lambda_inv_3_5 = Lambda_inv_3_5_p10 + Lambda_inv_4_5_p153 * Lambda_inv_3_5_p6 -
      Lambda_inv_4_5_p152 * Lambda_inv_3_5_p7 + Lambda_inv_4_5_p135 * Lambda_inv_3_5_p9;
  Lambda_inv[23] = Lambda_inv_3_5;
  Lambda_inv[33] = Lambda_inv_3_5;
  const Real Lambda_inv_0_3_p1 = Lambda_inv_3_5 * Lambda_inv_0_4_p1;
  const Real Lambda_inv_3_4_p1 = Lambda_inv_4_4_p4 * Lambda_inv_0_1_p19 - Lambda_inv_4_4_p5 *
      Lambda_inv_3_5_p1 + Lambda_inv_4_4_p6 * Lambda_inv_3_5_p2 + Lambda_inv_4_4_p7 *
      Lambda_inv_3_5_p4 + Lambda_inv_4_4_p8 * Lambda_inv_3_5_p5;
  const Real Lambda_inv_3_4 = Lambda_inv_3_4_p1 + Lambda_inv_4_4_p3 * Lambda_inv_3_5_p6 -
      Lambda_inv_4_4_p2 * Lambda_inv_3_5_p7 + Lambda_inv_4_4_p1 * Lambda_inv_3_5_p9;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;
  const Real Lambda_inv_0_3_p2 = Lambda_inv_3_4 * Lambda_inv_0_4_p2;
  const Real Lambda_inv_0_3_p3 = Lambda_inv_3_5_p6 * Lambda_inv_4_5_p75;
  const Real Lambda_inv_0_3_p4 = Lambda_inv_3_5_p5 * Lambda_inv_4_5_p73;
  const Real Lambda_inv_0_3_p5 = Lambda_inv_3_5_p4 * Lambda_inv_4_5_p62;
  const Real Lambda_inv_0_3_p6 = Lambda_inv_3_5_p7 * Lambda_inv_4_5_p113;
  const Real Lambda_inv_0_3_p7 = Lambda_inv_3_5_p9 * Lambda_inv_4_5_p134;
  const Real Lambda_inv_0_3_p8 = Lambda_inv_0_3_p5 * Lambda_inv_0_4_p4 + Lambda_inv_0_3_p4 *
      Lambda_inv_0_4_p6 - Lambda_inv_0_3_p3 * Lambda_inv_0_4_p9 + Lambda_inv_0_3_p6 *
      Lambda_inv_0_4_p10 + Lambda_inv_0_3_p7 * Lambda_inv_0_4_p11;
  const Real Lambda_inv_0_3 = Lambda_inv_0_3_p8 - (Lambda_inv_0_3_p1 + Lambda_inv_0_3_p2);
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;
  const Real Lambda_inv_0_1_p21 = Lambda_inv_4_4_p7 * Lambda_inv_0_1_p1 + Lambda_inv_4_4_p8 *
      Lambda_inv_0_1_p2 + Lambda_inv_4_4_p3 * Lambda_inv_0_1_p9 - Lambda_inv_4_4_p2 *
      Lambda_inv_0_1_p10 - Lambda_inv_4_4_p1 * Lambda_inv_0_1_p11;
  const Real Lambda_inv_0_1 = Lambda_inv_0_1_p17 - Lambda_inv_0_4_p1 * Lambda_inv_0_1_p18 +
      Lambda_inv_0_1_p20 * Lambda_inv_0_5 + (Lambda_inv_0_3 - Lambda_inv_0_1_p21) *
      Lambda_inv_0_4_p2;
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_0_2_p1 = Lambda_inv_4_5_p136 * Lambda_inv_0_4_p7 + Lambda_inv_4_5_p140 *
      Lambda_inv_0_1_p7;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_2_p2 = Lambda_inv_4_5_p67 * Lambda_inv_0_2_p1 -
      (Lambda_inv_4_5_p136 * Lambda_inv_0_4_p8 + Lambda_inv_4_5_p140 * Lambda_inv_0_1_p8);
  const Real Lambda_inv_0_2_p3 = Lambda_inv_4_5_p63 * Lambda_inv_0_2_p1 - Lambda_inv_4_5_p74 *
      Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_2_p4 = Lambda_inv_4_5_p108 * Lambda_inv_0_2_p1 - Lambda_inv_4_5_p107 *
      Lambda_inv_0_2_p2 - Lambda_inv_4_5_p100 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_2_p5 = Lambda_inv_4_5_p128 * Lambda_inv_0_2_p1 - Lambda_inv_4_5_p127 *
      Lambda_inv_0_2_p2 - Lambda_inv_4_5_p126 * Lambda_inv_0_2_p3 - Lambda_inv_4_5_p114 *
      Lambda_inv_0_2_p4;
  const Real Lambda_inv_0_2_p6 = Lambda_inv_4_4_p8 * Lambda_inv_0_2_p2 - Lambda_inv_4_4_p7 *
      Lambda_inv_0_2_p1 + Lambda_inv_4_4_p3 * Lambda_inv_0_2_p3 - Lambda_inv_4_4_p2 *
      Lambda_inv_0_2_p4 + Lambda_inv_4_4_p1 * Lambda_inv_0_2_p5;
  const Real Lambda_inv_0_2_p7 = Lambda_inv_0_2_p5 * Lambda_inv_4_5_p134;
  const Real Lambda_inv_0_2_p8 = Lambda_inv_0_2_p4 * Lambda_inv_4_5_p113;
  const Real Lambda_inv_0_2_p9 = Lambda_inv_0_2_p3 * Lambda_inv_4_5_p75;
  const Real Lambda_inv_0_2_p10 = Lambda_inv_0_2_p2 * Lambda_inv_4_5_p73;
  const Real Lambda_inv_0_2_p11 = Lambda_inv_0_2_p1 * Lambda_inv_4_5_p62;
  const Real Lambda_inv_0_2_p12 = Lambda_inv_0_2_p10 * Lambda_inv_0_4_p6 - Lambda_inv_0_2_p11 *
      Lambda_inv_0_4_p4 - Lambda_inv_0_2_p9 * Lambda_inv_0_4_p9 + Lambda_inv_0_2_p8 *
      Lambda_inv_0_4_p10 + Lambda_inv_0_2_p7 * Lambda_inv_0_4_p11;
  const Real Lambda_inv_0_2_p13 = Lambda_inv_4_5_p154 * Lambda_inv_0_2_p2 - Lambda_inv_4_5_p155 *
      Lambda_inv_0_2_p1 + Lambda_inv_4_5_p153 * Lambda_inv_0_2_p3 - Lambda_inv_4_5_p152 *
      Lambda_inv_0_2_p4 + Lambda_inv_4_5_p135 * Lambda_inv_0_2_p5;
  const Real Lambda_inv_0_2 = Lambda_inv_0_2_p12 - Lambda_inv_0_4_p2 * Lambda_inv_0_2_p6 -
      Lambda_inv_0_1_p20 * Lambda_inv_0_4 + (Lambda_inv_0_3 - Lambda_inv_0_2_p13) *
      Lambda_inv_0_4_p1;
  Lambda_inv[2] = Lambda_inv_0_2;
  Lambda_inv[12] = Lambda_inv_0_2;
  const Real Lambda_inv_3_3_p1 = 24999.999999999996 * Lambda_inv_0_1_p19 * Lambda_inv_0_1_p19 +
      1557.24430048586 * Lambda_inv_3_5_p1 * Lambda_inv_3_5_p1 + Lambda_inv_3_5_p2 *
      Lambda_inv_4_5_p45 * Lambda_inv_3_5_p2;
  const Real Lambda_inv_3_3_p2 = Lambda_inv_3_3_p1 + Lambda_inv_0_3_p5 * Lambda_inv_3_5_p4 +
      Lambda_inv_0_3_p4 * Lambda_inv_3_5_p5 + Lambda_inv_0_3_p3 * Lambda_inv_3_5_p6 +
      Lambda_inv_0_3_p6 * Lambda_inv_3_5_p7;
  const Real Lambda_inv_3_3 = Lambda_inv_3_3_p2 + Lambda_inv_0_3_p7 * Lambda_inv_3_5_p9;
  Lambda_inv[21] = Lambda_inv_3_3;
  const Real Lambda_inv_1_3_p1 = Lambda_inv_0_3_p5 * Lambda_inv_0_1_p1 + Lambda_inv_0_3_p4 *
      Lambda_inv_0_1_p2 + Lambda_inv_0_3_p3 * Lambda_inv_0_1_p9 + Lambda_inv_0_3_p6 *
      Lambda_inv_0_1_p10 - Lambda_inv_0_3_p7 * Lambda_inv_0_1_p11;
  const Real Lambda_inv_1_3 = Lambda_inv_1_3_p1 + (Lambda_inv_3_3 * Lambda_inv_0_4_p2 +
      Lambda_inv_3_5 * Lambda_inv_0_1_p20);
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  const Real Lambda_inv_1_5 = Lambda_inv_0_1_p18 + (Lambda_inv_3_5 * Lambda_inv_0_4_p2 +
      Lambda_inv_5_5 * Lambda_inv_0_1_p20);
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real Lambda_inv_1_1_p1 = Lambda_inv_0_1_p16 * Lambda_inv_0_1_p1 + Lambda_inv_0_1_p15 *
      Lambda_inv_0_1_p2 + Lambda_inv_0_1_p14 * Lambda_inv_0_1_p9 + Lambda_inv_0_1_p13 *
      Lambda_inv_0_1_p10 + Lambda_inv_0_1_p12 * Lambda_inv_0_1_p11;
  Lambda_inv[7] = Lambda_inv_1_1_p1 + (Lambda_inv_0_4_p2 * (Lambda_inv_1_3_p1 + Lambda_inv_1_3) +
      Lambda_inv_0_1_p20 * (Lambda_inv_0_1_p18 + Lambda_inv_1_5));
  const Real Lambda_inv_1_2_p1 = Lambda_inv_0_2_p10 * Lambda_inv_0_1_p2 - Lambda_inv_0_2_p11 *
      Lambda_inv_0_1_p1 + Lambda_inv_0_2_p9 * Lambda_inv_0_1_p9 + Lambda_inv_0_2_p8 *
      Lambda_inv_0_1_p10 - Lambda_inv_0_2_p7 * Lambda_inv_0_1_p11;
  const Real Lambda_inv_1_2_p2 = Lambda_inv_0_3_p4 * Lambda_inv_0_2_p2 - Lambda_inv_0_3_p5 *
      Lambda_inv_0_2_p1 + Lambda_inv_0_3_p3 * Lambda_inv_0_2_p3 + Lambda_inv_0_3_p6 *
      Lambda_inv_0_2_p4 + Lambda_inv_0_3_p7 * Lambda_inv_0_2_p5;
  const Real Lambda_inv_1_4_p1 = Lambda_inv_4_5 * Lambda_inv_0_1_p20;
  const Real Lambda_inv_1_4 = Lambda_inv_0_1_p21 + (Lambda_inv_0_3_p2 + Lambda_inv_1_4_p1);
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_1_2 = Lambda_inv_1_2_p1 + Lambda_inv_0_4_p1 * Lambda_inv_1_3 +
      Lambda_inv_0_4_p2 * Lambda_inv_1_2_p2 + (Lambda_inv_0_2_p13 - Lambda_inv_1_4) *
      Lambda_inv_0_1_p20;
  Lambda_inv[8] = Lambda_inv_1_2;
  Lambda_inv[13] = Lambda_inv_1_2;
  const Real Lambda_inv_2_4 = Lambda_inv_0_2_p6 - (Lambda_inv_4_4 * Lambda_inv_0_1_p20 -
      Lambda_inv_3_4 * Lambda_inv_0_4_p1);
  Lambda_inv[16] = Lambda_inv_2_4;
  Lambda_inv[26] = Lambda_inv_2_4;
  const Real Lambda_inv_2_3 = Lambda_inv_1_2_p2 - (Lambda_inv_3_4 * Lambda_inv_0_1_p20 -
      Lambda_inv_3_3 * Lambda_inv_0_4_p1);
  Lambda_inv[15] = Lambda_inv_2_3;
  Lambda_inv[20] = Lambda_inv_2_3;
  const Real Lambda_inv_2_2_p1 = Lambda_inv_0_2_p11 * Lambda_inv_0_2_p1 + Lambda_inv_0_2_p10 *
      Lambda_inv_0_2_p2 + Lambda_inv_0_2_p9 * Lambda_inv_0_2_p3 + Lambda_inv_0_2_p8 *
      Lambda_inv_0_2_p4 + Lambda_inv_0_2_p7 * Lambda_inv_0_2_p5;
  Lambda_inv[14] = Lambda_inv_2_2_p1 - (Lambda_inv_0_1_p20 * (Lambda_inv_0_2_p6 + Lambda_inv_2_4) -
      Lambda_inv_0_4_p1 * (Lambda_inv_1_2_p2 + Lambda_inv_2_3));
  const Real Lambda_inv_2_5 = Lambda_inv_0_2_p13 - (Lambda_inv_1_4_p1 - Lambda_inv_0_3_p1);
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;
}

}  // namespace samm

#undef TREELINE_RESTRICT
