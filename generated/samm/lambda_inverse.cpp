// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J in world axes, in the axes asked for at link origins.
// 986 flops (add 411, mul 569, div 6), sine and cosine of 6 angles
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
  const Real Lambda_inv_0_4_p1 = 0.0028799999999999997 * s8;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_0_4_p2 = c7 * Lambda_inv_0_4_p1;
  const Real Lambda_inv_0_4_p3 = 0.4331 * Lambda_inv_0_4_p2;

  // link 8 (link5), composite inertia
  const Real Lambda_inv_0_4_p4 = 0.00020215999999999998 * s8;
  const Real Lambda_inv_0_4_p5 = c8 * Lambda_inv_0_4_p4;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_0_4_p6 = c7 * Lambda_inv_0_4_p5;
  const Real Lambda_inv_0_4_p7 = Lambda_inv_0_4_p6 -
      (0.010673638499999999 - Lambda_inv_0_4_p3 + 5.846399999999999e-05 * c8);

  // link 8 (link5), composite inertia
  const Real Lambda_inv_0_4_p8 = 0.0028799999999999997 * c8;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_0_4_p9 = 0.861795 + Lambda_inv_0_4_p8;
  const Real Lambda_inv_0_4_p10 = 0.025374999999999998 - Lambda_inv_0_4_p2;

  // link 6 (link3), composite inertia
  const Real Lambda_inv_0_4_p11 = c6 * Lambda_inv_0_4_p9 + s6 * Lambda_inv_0_4_p10;

  // link 8 (link5), composite inertia
  const Real Lambda_inv_0_4_p12 = s8 * Lambda_inv_0_4_p4;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_0_4_p13 = s7 * (0.00010000000000000026 + Lambda_inv_0_4_p12);
  const Real Lambda_inv_0_4_p14 = s7 * Lambda_inv_0_4_p13;
  const Real Lambda_inv_0_4_p15 = Lambda_inv_0_4_p14 +
      (0.0011921599999999998 - (Lambda_inv_0_4_p12 - (0.3056901365 + 0.0024946559999999996 * c8)));
  const Real Lambda_inv_0_4_p16 = 0.008405112499999999 + Lambda_inv_0_4_p12 - 0.0406 *
      Lambda_inv_0_4_p2;

  // link 6 (link3), composite inertia
  const Real Lambda_inv_0_4_p17 = Lambda_inv_0_4_p7 * (2.0 * c6) + s6 *
      (Lambda_inv_0_4_p15 - Lambda_inv_0_4_p16);
  const Real Lambda_inv_0_4_p18 = s6 * Lambda_inv_0_4_p17;
  const Real Lambda_inv_0_4_p19 = s6 * Lambda_inv_0_4_p9 - c6 * Lambda_inv_0_4_p10;
  const Real Lambda_inv_0_4_p20 = 0.4318 * Lambda_inv_0_4_p19;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_0_4_p21 = s7 * Lambda_inv_0_4_p1;

  // link 6 (link3), composite inertia
  const Real Lambda_inv_0_4_p22 = Lambda_inv_0_4_p18 +
      (Lambda_inv_0_4_p16 + (1.674987602 + 2.0 * (Lambda_inv_0_4_p20 + 0.1501 *
      Lambda_inv_0_4_p21)));

  // link 5 (link2), composite inertia
  const Real Lambda_inv_0_4_p23 = (Lambda_inv_0_4_p7 + (0.0070992 - 0.4318 * Lambda_inv_0_4_p11) -
      c6 * Lambda_inv_0_4_p17) * (2.0 * c5) + s5 * (Lambda_inv_0_4_p22 +
      (Lambda_inv_0_4_p18 - (Lambda_inv_0_4_p15 + (0.07312640000000001 + 0.3002 *
      Lambda_inv_0_4_p21))));

  // link 9 (link6), mass matrix
  const Real Lambda_inv_0_4_p24 = 4e-05 * c8;
  const Real Lambda_inv_0_4_p25 = 4e-05 * s8;
  const Real Lambda_inv_0_4_p26 = c7 * Lambda_inv_0_4_p25;
  const Real Lambda_inv_0_4_p27 = c5 * (c6 * Lambda_inv_0_4_p24 - s6 * Lambda_inv_0_4_p26) - s5 *
      (s6 * Lambda_inv_0_4_p24 + c6 * Lambda_inv_0_4_p26);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p28 = 24999.999999999996 * Lambda_inv_0_4_p27;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_0_4_p29 = c7 * Lambda_inv_0_4_p8;
  const Real Lambda_inv_0_4_p30 = s6 * Lambda_inv_0_4_p1 - c6 * Lambda_inv_0_4_p29;
  const Real Lambda_inv_0_4_p31 = s7 * Lambda_inv_0_4_p8;
  const Real Lambda_inv_0_4_p32 = 0.0203 * Lambda_inv_0_4_p31;
  const Real Lambda_inv_0_4_p33 = 0.4331 * Lambda_inv_0_4_p31 + 0.00064216 * s7;
  const Real Lambda_inv_0_4_p34 = c5 * (0.4318 * Lambda_inv_0_4_p31 + 0.1501 * Lambda_inv_0_4_p30 -
      c6 * Lambda_inv_0_4_p32 + s6 * Lambda_inv_0_4_p33);
  const Real Lambda_inv_0_4_p35 = c6 * Lambda_inv_0_4_p1 + s6 * Lambda_inv_0_4_p29;
  const Real Lambda_inv_0_4_p36 = Lambda_inv_0_4_p34 + s5 *
      (0.1501 * Lambda_inv_0_4_p35 + s6 * Lambda_inv_0_4_p32 + c6 * Lambda_inv_0_4_p33);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p37 = 1557.24430048586 * Lambda_inv_0_4_p36;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_0_4_p38 = c6 * Lambda_inv_0_4_p21;

  // link 8 (link5), composite inertia
  const Real Lambda_inv_0_4_p39 = 0.00164 + Lambda_inv_0_4_p12;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_0_4_p40 = 0.0203 * Lambda_inv_0_4_p2;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_0_4_p41 = Lambda_inv_0_4_p39 - Lambda_inv_0_4_p40;
  const Real Lambda_inv_0_4_p42 = Lambda_inv_0_4_p3 + Lambda_inv_0_4_p6;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p43 = c5 * (0.4318 * Lambda_inv_0_4_p2 + 0.1501 * Lambda_inv_0_4_p38 +
      c6 * Lambda_inv_0_4_p41 + s6 * Lambda_inv_0_4_p42);

  // link 7 (link4), mass matrix
  const Real Lambda_inv_0_4_p44 = s6 * Lambda_inv_0_4_p21;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p45 = 0.9999999999999999 * c8;
  const Real Lambda_inv_0_4_p46 = Lambda_inv_0_4_p43 - s5 *
      (0.1501 * Lambda_inv_0_4_p44 + s6 * Lambda_inv_0_4_p41 - c6 * Lambda_inv_0_4_p42) -
      Lambda_inv_0_4_p27 * Lambda_inv_0_4_p45;
  const Real Lambda_inv_0_4_p47 = 1.0 / (Lambda_inv_0_4_p39 - Lambda_inv_0_4_p24 *
      Lambda_inv_0_4_p45);
  const Real Lambda_inv_0_4_p48 = Lambda_inv_0_4_p46 * Lambda_inv_0_4_p47;
  const Real Lambda_inv_0_4_p49 = 1.4717295504999999 + Lambda_inv_0_4_p22 - s5 *
      Lambda_inv_0_4_p23 - Lambda_inv_0_4_p27 * Lambda_inv_0_4_p28 - Lambda_inv_0_4_p36 *
      Lambda_inv_0_4_p37 - Lambda_inv_0_4_p46 * Lambda_inv_0_4_p48;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_0_4_p50 = 0.4331 * Lambda_inv_0_4_p21 + s7 * Lambda_inv_0_4_p5;
  const Real Lambda_inv_0_4_p51 = 0.004704000000000001 + Lambda_inv_0_4_p50;
  const Real Lambda_inv_0_4_p52 = 0.0203 * Lambda_inv_0_4_p21 - c7 * Lambda_inv_0_4_p13;

  // link 6 (link3), composite inertia
  const Real Lambda_inv_0_4_p53 = 0.1501 * Lambda_inv_0_4_p11 + c6 * Lambda_inv_0_4_p51 + s6 *
      Lambda_inv_0_4_p52;
  const Real Lambda_inv_0_4_p54 = s6 * Lambda_inv_0_4_p51 - c6 * Lambda_inv_0_4_p52;
  const Real Lambda_inv_0_4_p55 = 0.1501 * Lambda_inv_0_4_p19;

  // link 9 (link6), mass matrix
  const Real Lambda_inv_0_4_p56 = s7 * Lambda_inv_0_4_p25;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p57 = 24999.999999999996 * Lambda_inv_0_4_p56;
  const Real Lambda_inv_0_4_p58 = Lambda_inv_0_4_p27 * Lambda_inv_0_4_p57;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_0_4_p59 = 0.4331 * Lambda_inv_0_4_p29 - 5.846399999999999e-05 * s8 +
      0.00064216 * c7;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p60 = 1557.24430048586 * Lambda_inv_0_4_p59;
  const Real Lambda_inv_0_4_p61 = Lambda_inv_0_4_p56 * Lambda_inv_0_4_p45;
  const Real Lambda_inv_0_4_p62 = Lambda_inv_0_4_p50 + Lambda_inv_0_4_p61;
  const Real Lambda_inv_0_4_p63 = Lambda_inv_0_4_p62 * Lambda_inv_0_4_p47;
  const Real Lambda_inv_0_4_p64 = Lambda_inv_0_4_p58 +
      (c5 * Lambda_inv_0_4_p53 - s5 * (Lambda_inv_0_4_p55 + Lambda_inv_0_4_p54)) +
      Lambda_inv_0_4_p36 * Lambda_inv_0_4_p60 - Lambda_inv_0_4_p46 * Lambda_inv_0_4_p63;

  // link 7 (link4), composite inertia
  const Real Lambda_inv_0_4_p65 = Lambda_inv_0_4_p14 +
      (2.0 * (Lambda_inv_0_4_p40 - 0.0012473279999999998 * c8) - 0.313747409);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p66 = Lambda_inv_0_4_p56 * Lambda_inv_0_4_p57;
  const Real Lambda_inv_0_4_p67 = 1.0 / (Lambda_inv_0_4_p65 + Lambda_inv_0_4_p66 +
      Lambda_inv_0_4_p59 * Lambda_inv_0_4_p60 + Lambda_inv_0_4_p62 * Lambda_inv_0_4_p63);
  const Real Lambda_inv_0_4_p68 = Lambda_inv_0_4_p64 * Lambda_inv_0_4_p67;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_0_4_p69 = Lambda_inv_0_4_p59 + 0.4318 * Lambda_inv_0_4_p35;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p70 = Lambda_inv_0_4_p61 +
      (Lambda_inv_0_4_p50 + 0.4318 * Lambda_inv_0_4_p44);
  const Real Lambda_inv_0_4_p71 = Lambda_inv_0_4_p66 + (Lambda_inv_0_4_p65 - Lambda_inv_0_4_p20) +
      Lambda_inv_0_4_p69 * Lambda_inv_0_4_p60 + Lambda_inv_0_4_p70 * Lambda_inv_0_4_p63;
  const Real Lambda_inv_0_4_p72 = Lambda_inv_0_4_p71 * Lambda_inv_0_4_p67;
  const Real Lambda_inv_0_4_p73 = c5 * (0.023750999999999998 - Lambda_inv_0_4_p53) + s5 *
      (Lambda_inv_0_4_p54 + (0.690314699 + Lambda_inv_0_4_p55 + 0.4318 * Lambda_inv_0_4_p21));
  const Real Lambda_inv_0_4_p74 = 1557.24430048586 * Lambda_inv_0_4_p69;
  const Real Lambda_inv_0_4_p75 = Lambda_inv_0_4_p70 * Lambda_inv_0_4_p47;
  const Real Lambda_inv_0_4_p76 = Lambda_inv_0_4_p58 - Lambda_inv_0_4_p73 + Lambda_inv_0_4_p36 *
      Lambda_inv_0_4_p74 - Lambda_inv_0_4_p46 * Lambda_inv_0_4_p75 - Lambda_inv_0_4_p64 *
      Lambda_inv_0_4_p72;
  const Real Lambda_inv_0_4_p77 = Lambda_inv_0_4_p66 -
      (1.7481140020000001 - Lambda_inv_0_4_p65 + 0.8636 * Lambda_inv_0_4_p19) + Lambda_inv_0_4_p69 *
      Lambda_inv_0_4_p74 + Lambda_inv_0_4_p70 * Lambda_inv_0_4_p75;
  const Real Lambda_inv_0_4_p78 = 1.0 / (Lambda_inv_0_4_p77 - Lambda_inv_0_4_p71 *
      Lambda_inv_0_4_p72);
  const Real Lambda_inv_0_4_p79 = Lambda_inv_0_4_p76 * Lambda_inv_0_4_p78;
  const Real Lambda_inv_0_4_p80 = 1.0 / (Lambda_inv_0_4_p49 + Lambda_inv_0_4_p64 *
      Lambda_inv_0_4_p68 + Lambda_inv_0_4_p76 * Lambda_inv_0_4_p79);

  // link 4 (link1), pose
  const Real Lambda_inv_0_4_p81 = s3 * c4 + c3 * s4;

  // link 5 (link2), pose
  const Real Lambda_inv_0_4_p82 = s5 * Lambda_inv_0_4_p81;
  const Real Lambda_inv_0_4_p83 = c5 * Lambda_inv_0_4_p81;

  // link 6 (link3), pose
  const Real Lambda_inv_0_4_p84 = c6 * Lambda_inv_0_4_p82 + s6 * Lambda_inv_0_4_p83;
  const Real Lambda_inv_0_4_p85 = s6 * Lambda_inv_0_4_p82 - c6 * Lambda_inv_0_4_p83;

  // link 4 (link1), pose
  const Real Lambda_inv_0_4_p86 = s3 * s4 - c3 * c4;

  // link 8 (link5), pose
  const Real Lambda_inv_0_4_p87 = c8 * Lambda_inv_0_4_p84 - s8 *
      (s7 * Lambda_inv_0_4_p86 + c7 * Lambda_inv_0_4_p85);

  // link 7 (link4), pose
  const Real Lambda_inv_0_4_p88 = c7 * Lambda_inv_0_4_p86 - s7 * Lambda_inv_0_4_p85;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p89 = Lambda_inv_0_4_p84 - Lambda_inv_0_4_p87 * Lambda_inv_0_4_p45;
  const Real Lambda_inv_0_4_p90 = Lambda_inv_0_4_p86 + Lambda_inv_0_4_p87 * Lambda_inv_0_4_p57;
  const Real Lambda_inv_0_4_p91 = Lambda_inv_0_4_p90 - Lambda_inv_0_4_p88 * Lambda_inv_0_4_p60 -
      Lambda_inv_0_4_p63 * Lambda_inv_0_4_p89;
  const Real Lambda_inv_0_4_p92 = Lambda_inv_0_4_p90 - Lambda_inv_0_4_p88 * Lambda_inv_0_4_p74 -
      Lambda_inv_0_4_p75 * Lambda_inv_0_4_p89 - Lambda_inv_0_4_p72 * Lambda_inv_0_4_p91;
  const Real Lambda_inv_0_4_p93 = Lambda_inv_0_4_p87 * Lambda_inv_0_4_p28 - Lambda_inv_0_4_p88 *
      Lambda_inv_0_4_p37 + Lambda_inv_0_4_p48 * Lambda_inv_0_4_p89 - Lambda_inv_0_4_p68 *
      Lambda_inv_0_4_p91 - Lambda_inv_0_4_p79 * Lambda_inv_0_4_p92;
  const Real Lambda_inv_0_4_p94 = Lambda_inv_0_4_p80 * Lambda_inv_0_4_p93;

  // link 6 (link3), pose
  const Real Lambda_inv_0_4_p95 = c5 * c6 - s5 * s6;
  const Real Lambda_inv_0_4_p96 = c5 * s6 + s5 * c6;

  // link 7 (link4), pose
  const Real Lambda_inv_0_4_p97 = 0.4331 * Lambda_inv_0_4_p95 + 0.0203 * Lambda_inv_0_4_p96;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_0_4_p98 = Lambda_inv_0_4_p86 * Lambda_inv_0_4_p97;

  // link 5 (link2), Jacobian
  const Real Lambda_inv_0_4_p99 = Lambda_inv_0_4_p97 - 0.4318 * s5;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p100 = Lambda_inv_0_4_p86 * Lambda_inv_0_4_p99 - Lambda_inv_0_4_p98 *
      Lambda_inv_0_4_p72;

  // link 7 (link4), pose
  const Real Lambda_inv_0_4_p101 = 0.4331 * Lambda_inv_0_4_p84 + 0.0203 * Lambda_inv_0_4_p85;

  // link 5 (link2), Jacobian
  const Real Lambda_inv_0_4_p102 = Lambda_inv_0_4_p101 -
      (0.1501 * Lambda_inv_0_4_p86 - 0.4318 * Lambda_inv_0_4_p83);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p103 = Lambda_inv_0_4_p102 - Lambda_inv_0_4_p98 * Lambda_inv_0_4_p68 -
      Lambda_inv_0_4_p79 * Lambda_inv_0_4_p100;
  const Real Lambda_inv_0_4_p104 = Lambda_inv_0_4_p78 * Lambda_inv_0_4_p92;
  const Real Lambda_inv_0_4_p105 = Lambda_inv_0_4_p67 * Lambda_inv_0_4_p91;

  // link 6 (link3), mass matrix
  const Real Lambda_inv_0_4_p106 = s5 * Lambda_inv_0_4_p19 - c5 * Lambda_inv_0_4_p11;
  const Real Lambda_inv_0_4_p107 = s4 * Lambda_inv_0_4_p106;
  const Real Lambda_inv_0_4_p108 = c4 * Lambda_inv_0_4_p106;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_0_4_p109 = s5 * Lambda_inv_0_4_p35 + c5 * Lambda_inv_0_4_p30;
  const Real Lambda_inv_0_4_p110 = c4 * Lambda_inv_0_4_p31 - s4 * Lambda_inv_0_4_p109;
  const Real Lambda_inv_0_4_p111 = s4 * Lambda_inv_0_4_p31 + c4 * Lambda_inv_0_4_p109;
  const Real Lambda_inv_0_4_p112 = c3 * Lambda_inv_0_4_p110 - s3 * Lambda_inv_0_4_p111;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_0_4_p113 = s5 * Lambda_inv_0_4_p44 - c5 * Lambda_inv_0_4_p38;
  const Real Lambda_inv_0_4_p114 = c4 * Lambda_inv_0_4_p2 + s4 * Lambda_inv_0_4_p113;
  const Real Lambda_inv_0_4_p115 = s4 * Lambda_inv_0_4_p2 - c4 * Lambda_inv_0_4_p113;
  const Real Lambda_inv_0_4_p116 = c3 * Lambda_inv_0_4_p114 - s3 * Lambda_inv_0_4_p115;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p117 = c3 * Lambda_inv_0_4_p107 + s3 * Lambda_inv_0_4_p108 +
      Lambda_inv_0_4_p112 * Lambda_inv_0_4_p60 - Lambda_inv_0_4_p116 * Lambda_inv_0_4_p63;

  // link 6 (link3), composite inertia
  const Real Lambda_inv_0_4_p118 = 0.10439999999999999 - Lambda_inv_0_4_p11;
  const Real Lambda_inv_0_4_p119 = 3.79559 + Lambda_inv_0_4_p19;

  // link 5 (link2), composite inertia
  const Real Lambda_inv_0_4_p120 = c5 * Lambda_inv_0_4_p118 + s5 * Lambda_inv_0_4_p119;

  // link 5 (link2), mass matrix
  const Real Lambda_inv_0_4_p121 = s4 * Lambda_inv_0_4_p120;
  const Real Lambda_inv_0_4_p122 = c4 * Lambda_inv_0_4_p120;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p123 = c3 * Lambda_inv_0_4_p121 + s3 * Lambda_inv_0_4_p122 +
      Lambda_inv_0_4_p112 * Lambda_inv_0_4_p74 - Lambda_inv_0_4_p116 * Lambda_inv_0_4_p75 -
      Lambda_inv_0_4_p117 * Lambda_inv_0_4_p72;

  // link 5 (link2), composite inertia
  const Real Lambda_inv_0_4_p124 = s5 * Lambda_inv_0_4_p118 - c5 * Lambda_inv_0_4_p119;
  const Real Lambda_inv_0_4_p125 = 4.9338049999999996 + Lambda_inv_0_4_p21;

  // link 4 (link1), composite inertia
  const Real Lambda_inv_0_4_p126 = c4 * Lambda_inv_0_4_p125 - s4 * Lambda_inv_0_4_p124;
  const Real Lambda_inv_0_4_p127 = s4 * Lambda_inv_0_4_p125 + c4 * Lambda_inv_0_4_p124;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p128 = s3 * Lambda_inv_0_4_p126 + c3 * Lambda_inv_0_4_p127 +
      Lambda_inv_0_4_p112 * Lambda_inv_0_4_p37 + Lambda_inv_0_4_p116 * Lambda_inv_0_4_p48 -
      Lambda_inv_0_4_p117 * Lambda_inv_0_4_p68;
  const Real Lambda_inv_0_4_p129 = Lambda_inv_0_4_p128 - Lambda_inv_0_4_p123 * Lambda_inv_0_4_p79;
  const Real Lambda_inv_0_4_p130 = Lambda_inv_0_4_p129 * Lambda_inv_0_4_p80;
  const Real Lambda_inv_0_4_p131 = Lambda_inv_0_4_p123 * Lambda_inv_0_4_p78;
  const Real Lambda_inv_0_4_p132 = Lambda_inv_0_4_p117 * Lambda_inv_0_4_p67;
  const Real Lambda_inv_0_4_p133 = 1557.24430048586 * Lambda_inv_0_4_p112;
  const Real Lambda_inv_0_4_p134 = Lambda_inv_0_4_p116 * Lambda_inv_0_4_p47;
  const Real Lambda_inv_0_4_p135 = Lambda_inv_0_4_p88 * Lambda_inv_0_4_p133 - Lambda_inv_0_4_p134 *
      Lambda_inv_0_4_p89 + Lambda_inv_0_4_p132 * Lambda_inv_0_4_p91 + Lambda_inv_0_4_p131 *
      Lambda_inv_0_4_p92 - Lambda_inv_0_4_p130 * Lambda_inv_0_4_p93;
  const Real Lambda_inv_0_4_p136 = 186.45 - Lambda_inv_0_4_p112 * Lambda_inv_0_4_p133 -
      Lambda_inv_0_4_p116 * Lambda_inv_0_4_p134 + Lambda_inv_0_4_p117 * Lambda_inv_0_4_p132 +
      Lambda_inv_0_4_p123 * Lambda_inv_0_4_p131;
  const Real Lambda_inv_0_4_p137 = 1.0 / (Lambda_inv_0_4_p136 - Lambda_inv_0_4_p129 *
      Lambda_inv_0_4_p130);
  const Real Lambda_inv_0_4_p138 = Lambda_inv_0_4_p137 * Lambda_inv_0_4_p135;
  const Real Lambda_inv_0_4_p139 = Lambda_inv_0_4_p98 * Lambda_inv_0_4_p132 + Lambda_inv_0_4_p131 *
      Lambda_inv_0_4_p100 - Lambda_inv_0_4_p130 * Lambda_inv_0_4_p103;

  // link 8 (link5), mass matrix
  const Real Lambda_inv_0_4_p140 = s3 * Lambda_inv_0_4_p110 + c3 * Lambda_inv_0_4_p111;

  // link 7 (link4), mass matrix
  const Real Lambda_inv_0_4_p141 = s3 * Lambda_inv_0_4_p114 + c3 * Lambda_inv_0_4_p115;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p142 = s3 * Lambda_inv_0_4_p107 - c3 * Lambda_inv_0_4_p108 +
      Lambda_inv_0_4_p140 * Lambda_inv_0_4_p60 - Lambda_inv_0_4_p141 * Lambda_inv_0_4_p63;
  const Real Lambda_inv_0_4_p143 = s3 * Lambda_inv_0_4_p121 - c3 * Lambda_inv_0_4_p122 +
      Lambda_inv_0_4_p140 * Lambda_inv_0_4_p74 - Lambda_inv_0_4_p141 * Lambda_inv_0_4_p75 -
      Lambda_inv_0_4_p142 * Lambda_inv_0_4_p72;
  const Real Lambda_inv_0_4_p144 = c3 * Lambda_inv_0_4_p126 - s3 * Lambda_inv_0_4_p127 -
      Lambda_inv_0_4_p140 * Lambda_inv_0_4_p37 - Lambda_inv_0_4_p141 * Lambda_inv_0_4_p48 +
      Lambda_inv_0_4_p142 * Lambda_inv_0_4_p68;
  const Real Lambda_inv_0_4_p145 = Lambda_inv_0_4_p144 + Lambda_inv_0_4_p143 * Lambda_inv_0_4_p79;
  const Real Lambda_inv_0_4_p146 = Lambda_inv_0_4_p140 * Lambda_inv_0_4_p133 + Lambda_inv_0_4_p141 *
      Lambda_inv_0_4_p134 - Lambda_inv_0_4_p142 * Lambda_inv_0_4_p132 - Lambda_inv_0_4_p143 *
      Lambda_inv_0_4_p131 - Lambda_inv_0_4_p145 * Lambda_inv_0_4_p130;
  const Real Lambda_inv_0_4_p147 = Lambda_inv_0_4_p146 * Lambda_inv_0_4_p137;
  const Real Lambda_inv_0_4_p148 = Lambda_inv_0_4_p145 * Lambda_inv_0_4_p80;
  const Real Lambda_inv_0_4_p149 = Lambda_inv_0_4_p143 * Lambda_inv_0_4_p78;
  const Real Lambda_inv_0_4_p150 = Lambda_inv_0_4_p142 * Lambda_inv_0_4_p67;
  const Real Lambda_inv_0_4_p151 = 1557.24430048586 * Lambda_inv_0_4_p140;
  const Real Lambda_inv_0_4_p152 = Lambda_inv_0_4_p141 * Lambda_inv_0_4_p47;
  const Real Lambda_inv_0_4_p153 = Lambda_inv_0_4_p88 * Lambda_inv_0_4_p151 - Lambda_inv_0_4_p152 *
      Lambda_inv_0_4_p89 + Lambda_inv_0_4_p150 * Lambda_inv_0_4_p91 + Lambda_inv_0_4_p149 *
      Lambda_inv_0_4_p92 + Lambda_inv_0_4_p148 * Lambda_inv_0_4_p93;
  const Real Lambda_inv_0_4_p154 = Lambda_inv_0_4_p153 + Lambda_inv_0_4_p147 * Lambda_inv_0_4_p135;
  const Real Lambda_inv_0_4_p155 = 186.45 - Lambda_inv_0_4_p140 * Lambda_inv_0_4_p151 -
      Lambda_inv_0_4_p141 * Lambda_inv_0_4_p152 + Lambda_inv_0_4_p142 * Lambda_inv_0_4_p150 +
      Lambda_inv_0_4_p143 * Lambda_inv_0_4_p149;
  const Real Lambda_inv_0_4_p156 = 1.0 / (Lambda_inv_0_4_p155 - Lambda_inv_0_4_p145 *
      Lambda_inv_0_4_p148 - Lambda_inv_0_4_p146 * Lambda_inv_0_4_p147);
  const Real Lambda_inv_0_4_p157 = Lambda_inv_0_4_p156 * Lambda_inv_0_4_p154;
  const Real Lambda_inv_0_4_p158 = 1.0 - Lambda_inv_0_4_p98 * Lambda_inv_0_4_p150 -
      Lambda_inv_0_4_p149 * Lambda_inv_0_4_p100 - Lambda_inv_0_4_p148 * Lambda_inv_0_4_p103 -
      Lambda_inv_0_4_p147 * Lambda_inv_0_4_p139;
  const Real Lambda_inv_0_4_p159 = Lambda_inv_0_4_p98 * Lambda_inv_0_4_p105 + Lambda_inv_0_4_p100 *
      Lambda_inv_0_4_p104 - Lambda_inv_0_4_p103 * Lambda_inv_0_4_p94 - Lambda_inv_0_4_p139 *
      Lambda_inv_0_4_p138 + Lambda_inv_0_4_p158 * Lambda_inv_0_4_p157;
  const Real Lambda_inv_4_4_p1 = 24999.999999999996 * Lambda_inv_0_4_p87;
  const Real Lambda_inv_4_4_p2 = 1557.24430048586 * Lambda_inv_0_4_p88;
  const Real Lambda_inv_4_4_p3 = Lambda_inv_0_4_p47 * Lambda_inv_0_4_p89;
  const Real Lambda_inv_4_4_p4 = Lambda_inv_0_4_p87 * Lambda_inv_4_4_p1 + Lambda_inv_0_4_p88 *
      Lambda_inv_4_4_p2 + Lambda_inv_0_4_p89 * Lambda_inv_4_4_p3 - Lambda_inv_0_4_p91 *
      Lambda_inv_0_4_p105 - Lambda_inv_0_4_p92 * Lambda_inv_0_4_p104;
  const Real Lambda_inv_4_4 = Lambda_inv_4_4_p4 + Lambda_inv_0_4_p93 * Lambda_inv_0_4_p94 +
      Lambda_inv_0_4_p135 * Lambda_inv_0_4_p138 + Lambda_inv_0_4_p154 * Lambda_inv_0_4_p157;
  Lambda_inv[28] = Lambda_inv_4_4;

  // link 8 (link5), pose
  const Real Lambda_inv_0_4_p160 = c8 * Lambda_inv_0_4_p95 - Lambda_inv_0_4_p96 * (c7 * s8);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_4_p161 = 0.05625 * Lambda_inv_0_4_p160;
  const Real Lambda_inv_4_5_p1 = Lambda_inv_0_4_p160 * Lambda_inv_0_4_p57;

  // link 7 (link4), pose
  const Real Lambda_inv_4_5_p2 = s7 * Lambda_inv_0_4_p96;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_4_5_p3 = Lambda_inv_0_4_p95 - Lambda_inv_0_4_p160 * Lambda_inv_0_4_p45;
  const Real Lambda_inv_4_5_p4 = Lambda_inv_4_5_p1 + Lambda_inv_4_5_p2 * Lambda_inv_0_4_p60 -
      Lambda_inv_0_4_p63 * Lambda_inv_4_5_p3;
  const Real Lambda_inv_4_5_p5 = Lambda_inv_4_5_p1 + Lambda_inv_4_5_p2 * Lambda_inv_0_4_p74 -
      Lambda_inv_0_4_p75 * Lambda_inv_4_5_p3 - Lambda_inv_0_4_p72 * Lambda_inv_4_5_p4;
  const Real Lambda_inv_4_5_p6 = 1.0 - Lambda_inv_0_4_p160 * Lambda_inv_0_4_p28 -
      Lambda_inv_4_5_p2 * Lambda_inv_0_4_p37 - Lambda_inv_0_4_p48 * Lambda_inv_4_5_p3 +
      Lambda_inv_0_4_p68 * Lambda_inv_4_5_p4;
  const Real Lambda_inv_4_5_p7 = Lambda_inv_4_5_p6 + Lambda_inv_0_4_p79 * Lambda_inv_4_5_p5;
  const Real Lambda_inv_4_5_p8 = Lambda_inv_4_5_p2 * Lambda_inv_0_4_p133 + Lambda_inv_0_4_p134 *
      Lambda_inv_4_5_p3 - Lambda_inv_0_4_p132 * Lambda_inv_4_5_p4 - Lambda_inv_0_4_p131 *
      Lambda_inv_4_5_p5 - Lambda_inv_0_4_p130 * Lambda_inv_4_5_p7;
  const Real Lambda_inv_4_5_p9 = Lambda_inv_4_5_p2 * Lambda_inv_0_4_p151 + Lambda_inv_0_4_p152 *
      Lambda_inv_4_5_p3 - Lambda_inv_0_4_p150 * Lambda_inv_4_5_p4 - Lambda_inv_0_4_p149 *
      Lambda_inv_4_5_p5 + Lambda_inv_0_4_p148 * Lambda_inv_4_5_p7;
  const Real Lambda_inv_4_5_p10 = Lambda_inv_4_5_p9 + Lambda_inv_0_4_p147 * Lambda_inv_4_5_p8;
  const Real Lambda_inv_4_5_p11 = Lambda_inv_0_4_p156 * Lambda_inv_4_5_p10;
  const Real Lambda_inv_4_5_p12 = Lambda_inv_0_4_p137 * Lambda_inv_4_5_p8;
  const Real Lambda_inv_4_5_p13 = Lambda_inv_0_4_p80 * Lambda_inv_4_5_p7;
  const Real Lambda_inv_4_5_p14 = Lambda_inv_0_4_p78 * Lambda_inv_4_5_p5;
  const Real Lambda_inv_4_5_p15 = Lambda_inv_0_4_p67 * Lambda_inv_4_5_p4;
  const Real Lambda_inv_4_5_p16 = 24999.999999999996 * Lambda_inv_0_4_p160;
  const Real Lambda_inv_4_5_p17 = 1557.24430048586 * Lambda_inv_4_5_p2;
  const Real Lambda_inv_4_5_p18 = Lambda_inv_0_4_p47 * Lambda_inv_4_5_p3;
  const Real Lambda_inv_4_5_p19 = Lambda_inv_0_4_p87 * Lambda_inv_4_5_p16 - Lambda_inv_0_4_p88 *
      Lambda_inv_4_5_p17 + Lambda_inv_0_4_p89 * Lambda_inv_4_5_p18 - Lambda_inv_0_4_p91 *
      Lambda_inv_4_5_p15 - Lambda_inv_0_4_p92 * Lambda_inv_4_5_p14;
  const Real Lambda_inv_4_5 = Lambda_inv_4_5_p19 - Lambda_inv_0_4_p93 * Lambda_inv_4_5_p13 -
      Lambda_inv_0_4_p135 * Lambda_inv_4_5_p12 - Lambda_inv_0_4_p154 * Lambda_inv_4_5_p11;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
  const Real Lambda_inv_0_4_p162 = 0.05625 * Lambda_inv_0_4_p87;
  const Real Lambda_inv_0_4 = Lambda_inv_0_4_p159 - Lambda_inv_4_4 * Lambda_inv_0_4_p161 +
      Lambda_inv_4_5 * Lambda_inv_0_4_p162;
  Lambda_inv[4] = -Lambda_inv_0_4;
  Lambda_inv[24] = -Lambda_inv_0_4;
  const Real Lambda_inv_0_0_p1 = Lambda_inv_0_4_p67 * (Lambda_inv_0_4_p98 * Lambda_inv_0_4_p98) +
      Lambda_inv_0_4_p100 * (Lambda_inv_0_4_p78 * Lambda_inv_0_4_p100) - Lambda_inv_0_4_p103 *
      (Lambda_inv_0_4_p80 * Lambda_inv_0_4_p103);
  const Real Lambda_inv_0_0_p2 = Lambda_inv_0_0_p1 - Lambda_inv_0_4_p139 *
      (Lambda_inv_0_4_p137 * Lambda_inv_0_4_p139) - Lambda_inv_0_4_p158 *
      (Lambda_inv_0_4_p156 * Lambda_inv_0_4_p158) + Lambda_inv_0_4_p161 *
      (Lambda_inv_0_4_p159 + Lambda_inv_0_4);
  const Real Lambda_inv_0_5_p1 = Lambda_inv_0_4_p98 * Lambda_inv_4_5_p15 + Lambda_inv_0_4_p100 *
      Lambda_inv_4_5_p14 + Lambda_inv_0_4_p103 * Lambda_inv_4_5_p13 + Lambda_inv_0_4_p139 *
      Lambda_inv_4_5_p12 - Lambda_inv_0_4_p158 * Lambda_inv_4_5_p11;
  const Real Lambda_inv_5_5_p1 = Lambda_inv_0_4_p160 * Lambda_inv_4_5_p16 + Lambda_inv_4_5_p2 *
      Lambda_inv_4_5_p17 + Lambda_inv_4_5_p3 * Lambda_inv_4_5_p18 - Lambda_inv_4_5_p4 *
      Lambda_inv_4_5_p15 - Lambda_inv_4_5_p5 * Lambda_inv_4_5_p14;
  const Real Lambda_inv_5_5 = Lambda_inv_5_5_p1 + Lambda_inv_4_5_p7 * Lambda_inv_4_5_p13 +
      Lambda_inv_4_5_p8 * Lambda_inv_4_5_p12 + Lambda_inv_4_5_p10 * Lambda_inv_4_5_p11;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real Lambda_inv_0_5 = Lambda_inv_0_5_p1 - Lambda_inv_4_5 * Lambda_inv_0_4_p161 +
      Lambda_inv_5_5 * Lambda_inv_0_4_p162;
  Lambda_inv[5] = -Lambda_inv_0_5;
  Lambda_inv[30] = -Lambda_inv_0_5;
  Lambda_inv[0] = -(Lambda_inv_0_0_p2 - Lambda_inv_0_4_p162 * (Lambda_inv_0_5_p1 + Lambda_inv_0_5));

  // link 5 (link2), pose
  const Real Lambda_inv_3_4_p1 = s5 * Lambda_inv_0_4_p86;
  const Real Lambda_inv_3_4_p2 = c5 * Lambda_inv_0_4_p86;

  // link 6 (link3), pose
  const Real Lambda_inv_3_4_p3 = c6 * Lambda_inv_3_4_p1 + s6 * Lambda_inv_3_4_p2;
  const Real Lambda_inv_3_4_p4 = s6 * Lambda_inv_3_4_p1 - c6 * Lambda_inv_3_4_p2;

  // link 8 (link5), pose
  const Real Lambda_inv_3_4_p5 = c8 * Lambda_inv_3_4_p3 + s8 *
      (s7 * Lambda_inv_0_4_p81 - c7 * Lambda_inv_3_4_p4);

  // link 7 (link4), pose
  const Real Lambda_inv_3_4_p6 = c7 * Lambda_inv_0_4_p81 + s7 * Lambda_inv_3_4_p4;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_3_4_p7 = Lambda_inv_3_4_p3 - Lambda_inv_3_4_p5 * Lambda_inv_0_4_p45;
  const Real Lambda_inv_3_4_p8 = Lambda_inv_0_4_p81 - Lambda_inv_3_4_p5 * Lambda_inv_0_4_p57;
  const Real Lambda_inv_3_4_p9 = Lambda_inv_3_4_p8 - Lambda_inv_3_4_p6 * Lambda_inv_0_4_p60 +
      Lambda_inv_0_4_p63 * Lambda_inv_3_4_p7;
  const Real Lambda_inv_3_4_p10 = Lambda_inv_3_4_p8 - Lambda_inv_3_4_p6 * Lambda_inv_0_4_p74 +
      Lambda_inv_0_4_p75 * Lambda_inv_3_4_p7 - Lambda_inv_0_4_p72 * Lambda_inv_3_4_p9;
  const Real Lambda_inv_3_4_p11 = Lambda_inv_3_4_p5 * Lambda_inv_0_4_p28 + Lambda_inv_3_4_p6 *
      Lambda_inv_0_4_p37 + Lambda_inv_0_4_p48 * Lambda_inv_3_4_p7 + Lambda_inv_0_4_p68 *
      Lambda_inv_3_4_p9 + Lambda_inv_0_4_p79 * Lambda_inv_3_4_p10;
  const Real Lambda_inv_3_4_p12 = Lambda_inv_3_4_p6 * Lambda_inv_0_4_p133 + Lambda_inv_0_4_p134 *
      Lambda_inv_3_4_p7 + Lambda_inv_0_4_p132 * Lambda_inv_3_4_p9 + Lambda_inv_0_4_p131 *
      Lambda_inv_3_4_p10 + Lambda_inv_0_4_p130 * Lambda_inv_3_4_p11;
  const Real Lambda_inv_3_4_p13 = Lambda_inv_3_4_p6 * Lambda_inv_0_4_p151 + Lambda_inv_0_4_p152 *
      Lambda_inv_3_4_p7 + Lambda_inv_0_4_p150 * Lambda_inv_3_4_p9 + Lambda_inv_0_4_p149 *
      Lambda_inv_3_4_p10 - Lambda_inv_0_4_p148 * Lambda_inv_3_4_p11;
  const Real Lambda_inv_3_4_p14 = Lambda_inv_3_4_p13 + Lambda_inv_0_4_p147 * Lambda_inv_3_4_p12;
  const Real Lambda_inv_3_4_p15 = Lambda_inv_3_4_p5 * Lambda_inv_4_4_p1 - Lambda_inv_3_4_p6 *
      Lambda_inv_4_4_p2 + Lambda_inv_3_4_p7 * Lambda_inv_4_4_p3 + Lambda_inv_3_4_p9 *
      Lambda_inv_0_4_p105 + Lambda_inv_3_4_p10 * Lambda_inv_0_4_p104;
  const Real Lambda_inv_3_4 = Lambda_inv_3_4_p15 + Lambda_inv_3_4_p11 * Lambda_inv_0_4_p94 -
      Lambda_inv_3_4_p12 * Lambda_inv_0_4_p138 - Lambda_inv_3_4_p14 * Lambda_inv_0_4_p157;
  Lambda_inv[22] = -Lambda_inv_3_4;
  Lambda_inv[27] = -Lambda_inv_3_4;
  const Real Lambda_inv_0_3_p1 = Lambda_inv_3_4 * Lambda_inv_0_4_p161;
  const Real Lambda_inv_0_3_p2 = Lambda_inv_0_4_p80 * Lambda_inv_3_4_p11;
  const Real Lambda_inv_0_3_p3 = Lambda_inv_0_4_p78 * Lambda_inv_3_4_p10;
  const Real Lambda_inv_0_3_p4 = Lambda_inv_0_4_p67 * Lambda_inv_3_4_p9;
  const Real Lambda_inv_0_3_p5 = Lambda_inv_0_4_p137 * Lambda_inv_3_4_p12;
  const Real Lambda_inv_0_3_p6 = Lambda_inv_0_4_p156 * Lambda_inv_3_4_p14;
  const Real Lambda_inv_0_3_p7 = Lambda_inv_0_4_p98 * Lambda_inv_0_3_p4 + Lambda_inv_0_4_p100 *
      Lambda_inv_0_3_p3 + Lambda_inv_0_4_p103 * Lambda_inv_0_3_p2 - Lambda_inv_0_4_p139 *
      Lambda_inv_0_3_p5 + Lambda_inv_0_4_p158 * Lambda_inv_0_3_p6;
  const Real Lambda_inv_3_5_p1 = Lambda_inv_3_4_p5 * Lambda_inv_4_5_p16 + Lambda_inv_3_4_p6 *
      Lambda_inv_4_5_p17 + Lambda_inv_3_4_p7 * Lambda_inv_4_5_p18 + Lambda_inv_3_4_p9 *
      Lambda_inv_4_5_p15 + Lambda_inv_3_4_p10 * Lambda_inv_4_5_p14;
  const Real Lambda_inv_3_5 = Lambda_inv_3_5_p1 - Lambda_inv_3_4_p11 * Lambda_inv_4_5_p13 +
      Lambda_inv_3_4_p12 * Lambda_inv_4_5_p12 + Lambda_inv_3_4_p14 * Lambda_inv_4_5_p11;
  Lambda_inv[23] = -Lambda_inv_3_5;
  Lambda_inv[33] = -Lambda_inv_3_5;
  const Real Lambda_inv_0_3_p8 = Lambda_inv_3_5 * Lambda_inv_0_4_p162;
  const Real Lambda_inv_0_3 = Lambda_inv_0_3_p8 - (Lambda_inv_0_3_p1 + Lambda_inv_0_3_p7);
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_0_1_p1 = Lambda_inv_0_4_p81 * Lambda_inv_0_4_p97;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_1_p2 = Lambda_inv_0_4_p81 * Lambda_inv_0_4_p99 - Lambda_inv_0_1_p1 *
      Lambda_inv_0_4_p72;

  // link 7 (link4), pose
  const Real Lambda_inv_0_1_p3 = 0.4331 * Lambda_inv_3_4_p3 + 0.0203 * Lambda_inv_3_4_p4;

  // link 5 (link2), Jacobian
  const Real Lambda_inv_0_1_p4 = Lambda_inv_0_1_p3 +
      (0.1501 * Lambda_inv_0_4_p81 + 0.4318 * Lambda_inv_3_4_p2);

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_1_p5 = Lambda_inv_0_1_p4 + Lambda_inv_0_1_p1 * Lambda_inv_0_4_p68 +
      Lambda_inv_0_4_p79 * Lambda_inv_0_1_p2;
  const Real Lambda_inv_0_1_p6 = 1.0 - Lambda_inv_0_1_p1 * Lambda_inv_0_4_p132 -
      Lambda_inv_0_4_p131 * Lambda_inv_0_1_p2 - Lambda_inv_0_4_p130 * Lambda_inv_0_1_p5;
  const Real Lambda_inv_0_1_p7 = Lambda_inv_0_1_p1 * Lambda_inv_0_4_p150 + Lambda_inv_0_4_p149 *
      Lambda_inv_0_1_p2 - Lambda_inv_0_4_p148 * Lambda_inv_0_1_p5 - Lambda_inv_0_4_p147 *
      Lambda_inv_0_1_p6;
  const Real Lambda_inv_0_1_p8 = Lambda_inv_0_1_p1 * Lambda_inv_0_4_p105 + Lambda_inv_0_1_p2 *
      Lambda_inv_0_4_p104 + Lambda_inv_0_1_p5 * Lambda_inv_0_4_p94 + Lambda_inv_0_1_p6 *
      Lambda_inv_0_4_p138 - Lambda_inv_0_1_p7 * Lambda_inv_0_4_p157;
  const Real Lambda_inv_0_1_p9 = 0.05625 * Lambda_inv_3_4_p5;
  const Real Lambda_inv_0_1_p10 = Lambda_inv_0_4_p156 * Lambda_inv_0_1_p7;
  const Real Lambda_inv_0_1_p11 = Lambda_inv_0_4_p137 * Lambda_inv_0_1_p6;
  const Real Lambda_inv_0_1_p12 = Lambda_inv_0_4_p80 * Lambda_inv_0_1_p5;
  const Real Lambda_inv_0_1_p13 = Lambda_inv_0_4_p78 * Lambda_inv_0_1_p2;
  const Real Lambda_inv_0_1_p14 = Lambda_inv_0_1_p1 * Lambda_inv_0_4_p67;
  const Real Lambda_inv_0_1_p15 = Lambda_inv_0_4_p98 * Lambda_inv_0_1_p14 + Lambda_inv_0_4_p100 *
      Lambda_inv_0_1_p13 + Lambda_inv_0_4_p103 * Lambda_inv_0_1_p12 + Lambda_inv_0_4_p139 *
      Lambda_inv_0_1_p11 + Lambda_inv_0_4_p158 * Lambda_inv_0_1_p10;
  const Real Lambda_inv_0_1_p16 = Lambda_inv_0_1_p1 * Lambda_inv_4_5_p15 + Lambda_inv_0_1_p2 *
      Lambda_inv_4_5_p14 - Lambda_inv_0_1_p5 * Lambda_inv_4_5_p13 - Lambda_inv_0_1_p6 *
      Lambda_inv_4_5_p12 + Lambda_inv_0_1_p7 * Lambda_inv_4_5_p11;
  const Real Lambda_inv_0_1 = Lambda_inv_0_4_p161 * (Lambda_inv_0_1_p8 - Lambda_inv_0_3) +
      (Lambda_inv_0_1_p15 + Lambda_inv_0_1_p9 * Lambda_inv_0_5 - Lambda_inv_0_1_p16 *
      Lambda_inv_0_4_p162);
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;

  // link 6 (link3), Jacobian
  const Real Lambda_inv_0_2_p1 = Lambda_inv_0_4_p86 * Lambda_inv_0_1_p3 + Lambda_inv_0_4_p81 *
      Lambda_inv_0_4_p101;

  // link 1 (base_x), mass matrix
  const Real Lambda_inv_0_2_p2 = Lambda_inv_0_4_p86 * Lambda_inv_0_1_p4 + Lambda_inv_0_4_p81 *
      Lambda_inv_0_4_p102 - Lambda_inv_0_2_p1 * Lambda_inv_0_4_p72;
  const Real Lambda_inv_0_2_p3 = Lambda_inv_0_2_p1 * Lambda_inv_0_4_p68 + Lambda_inv_0_4_p79 *
      Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_2_p4 = Lambda_inv_0_2_p1 * Lambda_inv_0_4_p132 + Lambda_inv_0_4_p131 *
      Lambda_inv_0_2_p2 + Lambda_inv_0_4_p130 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_2_p5 = Lambda_inv_0_2_p1 * Lambda_inv_0_4_p150 + Lambda_inv_0_4_p149 *
      Lambda_inv_0_2_p2 - Lambda_inv_0_4_p148 * Lambda_inv_0_2_p3 + Lambda_inv_0_4_p147 *
      Lambda_inv_0_2_p4;
  const Real Lambda_inv_0_2_p6 = Lambda_inv_0_2_p1 * Lambda_inv_4_5_p15 + Lambda_inv_0_2_p2 *
      Lambda_inv_4_5_p14 - Lambda_inv_0_2_p3 * Lambda_inv_4_5_p13 + Lambda_inv_0_2_p4 *
      Lambda_inv_4_5_p12 + Lambda_inv_0_2_p5 * Lambda_inv_4_5_p11;
  const Real Lambda_inv_0_2_p7 = Lambda_inv_0_4_p156 * Lambda_inv_0_2_p5;
  const Real Lambda_inv_0_2_p8 = Lambda_inv_0_4_p137 * Lambda_inv_0_2_p4;
  const Real Lambda_inv_0_2_p9 = Lambda_inv_0_4_p80 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_2_p10 = Lambda_inv_0_4_p78 * Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_2_p11 = Lambda_inv_0_2_p1 * Lambda_inv_0_4_p67;
  const Real Lambda_inv_0_2_p12 = Lambda_inv_0_4_p98 * Lambda_inv_0_2_p11 + Lambda_inv_0_4_p100 *
      Lambda_inv_0_2_p10 + Lambda_inv_0_4_p103 * Lambda_inv_0_2_p9 - Lambda_inv_0_4_p139 *
      Lambda_inv_0_2_p8 + Lambda_inv_0_4_p158 * Lambda_inv_0_2_p7;
  const Real Lambda_inv_0_2_p13 = Lambda_inv_0_2_p1 * Lambda_inv_0_4_p105 + Lambda_inv_0_2_p2 *
      Lambda_inv_0_4_p104 + Lambda_inv_0_2_p3 * Lambda_inv_0_4_p94 - Lambda_inv_0_2_p4 *
      Lambda_inv_0_4_p138 - Lambda_inv_0_2_p5 * Lambda_inv_0_4_p157;
  const Real Lambda_inv_0_2 = Lambda_inv_0_4_p162 * (Lambda_inv_0_2_p6 + Lambda_inv_0_3) -
      (Lambda_inv_0_2_p12 + Lambda_inv_0_1_p9 * Lambda_inv_0_4 + Lambda_inv_0_2_p13 *
      Lambda_inv_0_4_p161);
  Lambda_inv[2] = Lambda_inv_0_2;
  Lambda_inv[12] = Lambda_inv_0_2;
  const Real Lambda_inv_1_5 = Lambda_inv_0_1_p16 - Lambda_inv_5_5 * Lambda_inv_0_1_p9 +
      Lambda_inv_3_5 * Lambda_inv_0_4_p161;
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real Lambda_inv_1_1_p1 = Lambda_inv_0_1_p1 * Lambda_inv_0_1_p14 + Lambda_inv_0_1_p2 *
      Lambda_inv_0_1_p13 - Lambda_inv_0_1_p5 * Lambda_inv_0_1_p12 - Lambda_inv_0_1_p6 *
      Lambda_inv_0_1_p11 - Lambda_inv_0_1_p7 * Lambda_inv_0_1_p10;
  const Real Lambda_inv_1_3_p1 = Lambda_inv_0_1_p1 * Lambda_inv_0_3_p4 + Lambda_inv_0_1_p2 *
      Lambda_inv_0_3_p3 - Lambda_inv_0_1_p5 * Lambda_inv_0_3_p2 + Lambda_inv_0_1_p6 *
      Lambda_inv_0_3_p5 - Lambda_inv_0_1_p7 * Lambda_inv_0_3_p6;
  const Real Lambda_inv_3_3_p1 = Lambda_inv_3_4_p5 * (24999.999999999996 * Lambda_inv_3_4_p5) +
      Lambda_inv_3_4_p6 * (1557.24430048586 * Lambda_inv_3_4_p6) + Lambda_inv_3_4_p7 *
      (Lambda_inv_0_4_p47 * Lambda_inv_3_4_p7);
  const Real Lambda_inv_3_3_p2 = Lambda_inv_3_3_p1 - Lambda_inv_3_4_p9 * Lambda_inv_0_3_p4 -
      Lambda_inv_3_4_p10 * Lambda_inv_0_3_p3 + Lambda_inv_3_4_p11 * Lambda_inv_0_3_p2 +
      Lambda_inv_3_4_p12 * Lambda_inv_0_3_p5;
  const Real Lambda_inv_3_3 = Lambda_inv_3_3_p2 + Lambda_inv_3_4_p14 * Lambda_inv_0_3_p6;
  Lambda_inv[21] = Lambda_inv_3_3;
  const Real Lambda_inv_1_3 = Lambda_inv_1_3_p1 + Lambda_inv_3_5 * Lambda_inv_0_1_p9 -
      Lambda_inv_3_3 * Lambda_inv_0_4_p161;
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  Lambda_inv[7] = -(Lambda_inv_1_1_p1 + Lambda_inv_0_1_p9 * (Lambda_inv_0_1_p16 + Lambda_inv_1_5) +
      Lambda_inv_0_4_p161 * (Lambda_inv_1_3_p1 + Lambda_inv_1_3));
  const Real Lambda_inv_1_4_p1 = Lambda_inv_4_5 * Lambda_inv_0_1_p9;
  const Real Lambda_inv_1_4 = Lambda_inv_1_4_p1 - (Lambda_inv_0_1_p8 + Lambda_inv_0_3_p1);
  Lambda_inv[10] = -Lambda_inv_1_4;
  Lambda_inv[25] = -Lambda_inv_1_4;
  const Real Lambda_inv_1_2_p1 = Lambda_inv_0_1_p1 * Lambda_inv_0_2_p11 + Lambda_inv_0_1_p2 *
      Lambda_inv_0_2_p10 - Lambda_inv_0_1_p5 * Lambda_inv_0_2_p9 + Lambda_inv_0_1_p6 *
      Lambda_inv_0_2_p8 - Lambda_inv_0_1_p7 * Lambda_inv_0_2_p7;
  const Real Lambda_inv_1_2_p2 = Lambda_inv_0_2_p1 * Lambda_inv_0_3_p4 + Lambda_inv_0_2_p2 *
      Lambda_inv_0_3_p3 - Lambda_inv_0_2_p3 * Lambda_inv_0_3_p2 - Lambda_inv_0_2_p4 *
      Lambda_inv_0_3_p5 - Lambda_inv_0_2_p5 * Lambda_inv_0_3_p6;
  const Real Lambda_inv_1_2 = Lambda_inv_0_1_p9 * (Lambda_inv_0_2_p6 - Lambda_inv_1_4) +
      (Lambda_inv_1_2_p1 + Lambda_inv_0_4_p162 * Lambda_inv_1_3 + Lambda_inv_1_2_p2 *
      Lambda_inv_0_4_p161);
  Lambda_inv[8] = Lambda_inv_1_2;
  Lambda_inv[13] = Lambda_inv_1_2;
  const Real Lambda_inv_2_3 = Lambda_inv_1_2_p2 - Lambda_inv_3_3 * Lambda_inv_0_4_p162 +
      Lambda_inv_3_4 * Lambda_inv_0_1_p9;
  Lambda_inv[15] = -Lambda_inv_2_3;
  Lambda_inv[20] = -Lambda_inv_2_3;
  const Real Lambda_inv_2_2_p1 = Lambda_inv_0_2_p1 * Lambda_inv_0_2_p11 + Lambda_inv_0_2_p2 *
      Lambda_inv_0_2_p10 - Lambda_inv_0_2_p3 * Lambda_inv_0_2_p9 - Lambda_inv_0_2_p4 *
      Lambda_inv_0_2_p8 - Lambda_inv_0_2_p5 * Lambda_inv_0_2_p7;
  const Real Lambda_inv_2_4 = Lambda_inv_0_2_p13 + Lambda_inv_3_4 * Lambda_inv_0_4_p162 -
      Lambda_inv_4_4 * Lambda_inv_0_1_p9;
  Lambda_inv[16] = -Lambda_inv_2_4;
  Lambda_inv[26] = -Lambda_inv_2_4;
  Lambda_inv[14] = -(Lambda_inv_2_2_p1 + Lambda_inv_0_4_p162 *
      (Lambda_inv_1_2_p2 + Lambda_inv_2_3) + Lambda_inv_0_1_p9 *
      (Lambda_inv_0_2_p13 + Lambda_inv_2_4));
  const Real Lambda_inv_2_5 = Lambda_inv_1_4_p1 - (Lambda_inv_0_2_p6 + Lambda_inv_0_3_p8);
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;
}

}  // namespace samm

#undef TREELINE_RESTRICT
