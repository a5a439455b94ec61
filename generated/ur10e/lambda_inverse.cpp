// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J carried inward, in the axes of link 4 (wrist_1) at link origins.
// 541 flops (add 234, mul 303, div 4), sine and cosine of 5 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void lambda_inverse(const Real (&TREELINE_RESTRICT q)[6],
    Real (&TREELINE_RESTRICT Lambda_inv)[36]) noexcept {
  const Real angles[5] = {q[1], q[2], q[3], q[4], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real s2 = sines[0];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];
  const Real s1 = sines[4];
  const Real c1 = cosines[4];

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p1 = 0.0054190910375000005 * s5;
  const Real Lambda_inv_0_0_p2 = 0.09132825 * s5;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p3 = c5 * c5;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p4 = 0.09132825 * c5;
  const Real Lambda_inv_0_0_p5 = 0.0106962107625 * c5;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p6 = 1.2551157591996094 * c5;
  const Real Lambda_inv_0_0_p7 = 0.6127 * s2;
  const Real Lambda_inv_0_0_p8 = 0.6127 * c2;
  const Real Lambda_inv_0_0_p9 = c2 * c3 - s2 * s3;
  const Real Lambda_inv_0_0_p10 = s2 * c3 + c2 * s3;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p11 = s5 * Lambda_inv_0_0_p1;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p12 = 0.000623 * Lambda_inv_0_0_p3;
  const Real Lambda_inv_0_0_p13 = 1.0 - Lambda_inv_0_0_p3;
  const Real Lambda_inv_0_0_p14 = 0.57155 * Lambda_inv_0_0_p10;
  const Real Lambda_inv_0_0_p15 = 0.57155 * Lambda_inv_0_0_p9;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p16 = 0.041592816387499995 + Lambda_inv_0_0_p11;
  const Real Lambda_inv_0_0_p17 = Lambda_inv_0_0_p9 * c4 - Lambda_inv_0_0_p10 * s4;
  const Real Lambda_inv_0_0_p18 = Lambda_inv_0_0_p10 * c4 + Lambda_inv_0_0_p9 * s4;
  const Real Lambda_inv_0_0_p19 = Lambda_inv_0_0_p18 * Lambda_inv_0_0_p2;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_inv_0_0_p20 = Lambda_inv_0_0_p18 * Lambda_inv_0_0_p4;
  const Real Lambda_inv_0_0_p21 = Lambda_inv_0_0_p17 * Lambda_inv_0_0_p4;

  // link 6 (wrist_3), mass matrix
  const Real Lambda_inv_0_0_p22 = s5 * Lambda_inv_0_0_p18;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p23 = Lambda_inv_0_0_p17 * s5;
  const Real Lambda_inv_0_0_p24 = 0.33495075 * Lambda_inv_0_0_p17 + Lambda_inv_0_0_p19;
  const Real Lambda_inv_0_0_p25 = 0.33495075 * Lambda_inv_0_0_p18 - Lambda_inv_0_0_p17 *
      Lambda_inv_0_0_p2;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p26 = 1.0 / (Lambda_inv_0_0_p16 - Lambda_inv_0_0_p12 -
      Lambda_inv_0_0_p6 * Lambda_inv_0_0_p5);

  // link 6 (wrist_3), mass matrix
  const Real Lambda_inv_0_0_p27 = 0.000623 * Lambda_inv_0_0_p22;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_inv_0_0_p28 = Lambda_inv_0_0_p15 * Lambda_inv_0_0_p25;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_5_5_p1 = Lambda_inv_0_0_p22 * c5;
  const Real Lambda_inv_0_0_p29 = c5 * Lambda_inv_0_0_p27;

  // link 4 (wrist_1), composite inertia
  const Real Lambda_inv_0_0_p30 = Lambda_inv_0_0_p14 * Lambda_inv_0_0_p24 - Lambda_inv_0_0_p28;

  // link 3 (forearm), composite inertia
  const Real Lambda_inv_0_0_p31 = Lambda_inv_0_0_p8 *
      (Lambda_inv_0_0_p25 - 4.0059802 * Lambda_inv_0_0_p9);

  // link 5 (wrist_2), mass matrix
  const Real Lambda_inv_0_0_p32 = Lambda_inv_0_0_p15 * Lambda_inv_0_0_p20 - Lambda_inv_0_0_p14 *
      Lambda_inv_0_0_p21 - Lambda_inv_0_0_p5;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p33 = 1605.1364365971108 * c5;

  // link 5 (wrist_2), composite inertia
  const Real Lambda_inv_0_0_p34 = Lambda_inv_0_0_p18 * c5 * Lambda_inv_0_0_p1 + 0.17415 *
      Lambda_inv_0_0_p19 + (0.0585962731125 + Lambda_inv_0_0_p5) * Lambda_inv_0_0_p17;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p35 = 0.11655 * Lambda_inv_0_0_p22;
  const Real Lambda_inv_0_0_p36 = 0.0098370910375 +
      (6.991093406097501 - s2 * (4.36318718615 * s2) - Lambda_inv_0_0_p10 *
      (2.07831527531 * Lambda_inv_0_0_p10)) + 0.031809629475 * c5;
  const Real Lambda_inv_0_0_p37 = 117.34209310833121 * Lambda_inv_0_0_p32;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_inv_0_0_p38 = Lambda_inv_0_0_p32 +
      (Lambda_inv_0_0_p8 * Lambda_inv_0_0_p20 - Lambda_inv_0_0_p7 * Lambda_inv_0_0_p21);

  // link 3 (forearm), composite inertia
  const Real Lambda_inv_0_0_p39 = Lambda_inv_0_0_p7 *
      (4.0059802 * Lambda_inv_0_0_p10 + Lambda_inv_0_0_p24) - Lambda_inv_0_0_p31;

  // link 5 (wrist_2), mass matrix
  const Real Lambda_inv_0_0_p40 = 0.0106962107625 * Lambda_inv_0_0_p22 - 0.0085220910375 *
      Lambda_inv_0_0_p17 - 0.17415 * Lambda_inv_0_0_p21 - (Lambda_inv_0_0_p15 + Lambda_inv_0_0_p8) *
      Lambda_inv_0_0_p2;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p41 = Lambda_inv_0_0_p16 + Lambda_inv_0_0_p30 - Lambda_inv_0_0_p12;
  const Real Lambda_inv_5_5_p2 = Lambda_inv_5_5_p1 - Lambda_inv_0_0_p6 * Lambda_inv_0_0_p17;
  const Real Lambda_inv_0_0_p42 = 117.34209310833121 * Lambda_inv_0_0_p38;
  const Real Lambda_inv_0_0_p43 = Lambda_inv_0_0_p41 + Lambda_inv_0_0_p6 * Lambda_inv_0_0_p32;
  const Real Lambda_inv_0_0_p44 = 117.34209310833121 * Lambda_inv_0_0_p40;
  const Real Lambda_inv_0_0_p45 = 0.5656542411875001 * Lambda_inv_0_0_p10 +
      (Lambda_inv_0_0_p34 + Lambda_inv_0_0_p14 * Lambda_inv_0_0_p4) + Lambda_inv_0_0_p29;
  const Real Lambda_inv_0_0_p46 = Lambda_inv_0_0_p43 * Lambda_inv_0_0_p26;
  const Real Lambda_inv_0_0_p47 = Lambda_inv_0_0_p34 + Lambda_inv_0_0_p29 + Lambda_inv_0_0_p6 *
      Lambda_inv_0_0_p40;
  const Real Lambda_inv_0_0_p48 = 2.08330527531 + (Lambda_inv_0_0_p16 + 2.0 * Lambda_inv_0_0_p30) -
      Lambda_inv_0_0_p12;

  // link 6 (wrist_3), pose
  const Real Lambda_inv_0_0_p49 = 0.11985 * Lambda_inv_0_0_p17;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_5_5_p3 = 1605.1364365971108 * Lambda_inv_0_0_p22;
  const Real Lambda_inv_0_0_p50 = Lambda_inv_0_0_p41 + Lambda_inv_0_0_p7 * Lambda_inv_0_0_p24 -
      Lambda_inv_0_0_p8 * Lambda_inv_0_0_p25 + Lambda_inv_0_0_p6 * Lambda_inv_0_0_p38;
  const Real Lambda_inv_0_0_p51 = Lambda_inv_0_0_p47 * Lambda_inv_0_0_p26;
  const Real Lambda_inv_5_5_p4 = 117.34209310833121 * Lambda_inv_0_0_p17;
  const Real Lambda_inv_0_0_p52 = Lambda_inv_0_0_p50 * Lambda_inv_0_0_p26;
  const Real Lambda_inv_0_0_p53 = (1.0 - Lambda_inv_0_0_p46) * Lambda_inv_0_0_p13;
  const Real Lambda_inv_0_0_p54 = Lambda_inv_0_0_p45 - Lambda_inv_0_0_p37 * Lambda_inv_0_0_p40 -
      Lambda_inv_0_0_p46 * Lambda_inv_0_0_p47;
  const Real Lambda_inv_0_0_p55 = Lambda_inv_0_0_p13 * Lambda_inv_0_0_p26;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_inv_0_0_p56 = Lambda_inv_0_0_p49 + Lambda_inv_0_0_p14;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p57 = Lambda_inv_0_0_p48 + Lambda_inv_0_0_p39 - Lambda_inv_0_0_p37 *
      Lambda_inv_0_0_p38 - Lambda_inv_0_0_p46 * Lambda_inv_0_0_p50;
  const Real Lambda_inv_0_0_p58 = 1.0 / (Lambda_inv_0_0_p48 - Lambda_inv_0_0_p37 *
      Lambda_inv_0_0_p32 - Lambda_inv_0_0_p46 * Lambda_inv_0_0_p43);
  const Real Lambda_inv_0_0_p59 = c5 * Lambda_inv_0_0_p23;
  const Real Lambda_inv_5_5_p5 = Lambda_inv_5_5_p1 + Lambda_inv_0_0_p37 * Lambda_inv_0_0_p17 -
      Lambda_inv_0_0_p46 * Lambda_inv_5_5_p2;
  const Real Lambda_inv_5_5_p6 = Lambda_inv_5_5_p2 * Lambda_inv_0_0_p26;
  const Real Lambda_inv_0_0_p60 = 1.156008191975 * s2 + Lambda_inv_0_0_p45 + Lambda_inv_0_0_p7 *
      Lambda_inv_0_0_p4 - Lambda_inv_0_0_p42 * Lambda_inv_0_0_p40 - Lambda_inv_0_0_p52 *
      Lambda_inv_0_0_p47;
  const Real Lambda_inv_0_0_p61 = Lambda_inv_0_0_p59 + Lambda_inv_0_0_p6 * Lambda_inv_0_0_p18;
  const Real Lambda_inv_0_0_p62 = Lambda_inv_0_0_p56 - Lambda_inv_0_0_p46 * Lambda_inv_0_0_p49;

  // link 6 (wrist_3), pose
  const Real Lambda_inv_0_2_p1 = 0.11985 * Lambda_inv_0_0_p18;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p63 = Lambda_inv_0_0_p59 - Lambda_inv_0_0_p37 * Lambda_inv_0_0_p18 -
      Lambda_inv_0_0_p46 * Lambda_inv_0_0_p61;
  const Real Lambda_inv_0_0_p64 = Lambda_inv_0_0_p57 * Lambda_inv_0_0_p58;
  const Real Lambda_inv_0_0_p65 = Lambda_inv_0_0_p54 * Lambda_inv_0_0_p58;
  const Real Lambda_inv_0_0_p66 = Lambda_inv_0_0_p61 * Lambda_inv_0_0_p26;
  const Real Lambda_inv_0_0_p67 = Lambda_inv_0_0_p53 * Lambda_inv_0_0_p58;
  const Real Lambda_inv_5_5_p7 = Lambda_inv_5_5_p5 * Lambda_inv_0_0_p58;
  const Real Lambda_inv_0_0_p68 = Lambda_inv_0_0_p63 * Lambda_inv_0_0_p58;

  // link 4 (wrist_1), Jacobian
  const Real Lambda_inv_0_2_p2 = Lambda_inv_0_2_p1 - Lambda_inv_0_0_p15;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p69 = 0.11655 * c5;
  const Real Lambda_inv_0_0_p70 = 0.11655 * Lambda_inv_0_0_p23;
  const Real Lambda_inv_0_0_p71 = 4.3866871861500005 + Lambda_inv_0_0_p48 + 2.0 *
      Lambda_inv_0_0_p39 - Lambda_inv_0_0_p42 * Lambda_inv_0_0_p38 - Lambda_inv_0_0_p52 *
      Lambda_inv_0_0_p50 - Lambda_inv_0_0_p64 * Lambda_inv_0_0_p57;
  const Real Lambda_inv_0_0_p72 = Lambda_inv_0_0_p60 - Lambda_inv_0_0_p64 * Lambda_inv_0_0_p54;
  const Real Lambda_inv_0_0_p73 = Lambda_inv_0_0_p36 - Lambda_inv_0_0_p22 * Lambda_inv_0_0_p27 -
      Lambda_inv_0_0_p44 * Lambda_inv_0_0_p40 - Lambda_inv_0_0_p51 * Lambda_inv_0_0_p47 -
      Lambda_inv_0_0_p65 * Lambda_inv_0_0_p54;
  const Real Lambda_inv_0_0_p74 = (1.0 - Lambda_inv_0_0_p52) * Lambda_inv_0_0_p13 -
      Lambda_inv_0_0_p64 * Lambda_inv_0_0_p53;
  const Real Lambda_inv_5_5_p8 = Lambda_inv_5_5_p1 + Lambda_inv_0_0_p42 * Lambda_inv_0_0_p17 -
      Lambda_inv_0_0_p52 * Lambda_inv_5_5_p2 - Lambda_inv_0_0_p64 * Lambda_inv_5_5_p5;
  const Real Lambda_inv_0_0_p75 = Lambda_inv_0_0_p59 - Lambda_inv_0_0_p42 * Lambda_inv_0_0_p18 -
      Lambda_inv_0_0_p52 * Lambda_inv_0_0_p61 - Lambda_inv_0_0_p64 * Lambda_inv_0_0_p63;
  const Real Lambda_inv_5_5_p9 = 1.0 - Lambda_inv_0_0_p22 * Lambda_inv_0_0_p22 +
      Lambda_inv_0_0_p44 * Lambda_inv_0_0_p17 - Lambda_inv_0_0_p51 * Lambda_inv_5_5_p2 -
      Lambda_inv_0_0_p65 * Lambda_inv_5_5_p5;
  const Real Lambda_inv_0_0_p76 = Lambda_inv_0_0_p56 + Lambda_inv_0_0_p7 - Lambda_inv_0_0_p52 *
      Lambda_inv_0_0_p49 - Lambda_inv_0_0_p64 * Lambda_inv_0_0_p62;
  const Real Lambda_inv_0_0_p77 = 1.0 / Lambda_inv_0_0_p71;

  // link 3 (forearm), Jacobian
  const Real Lambda_inv_0_2_p3 = Lambda_inv_0_2_p2 - Lambda_inv_0_0_p8;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_0_p78 = 1605.1364365971108 * Lambda_inv_0_0_p23 * Lambda_inv_0_0_p23 +
      117.34209310833121 * Lambda_inv_0_0_p18 * Lambda_inv_0_0_p18 + Lambda_inv_0_0_p66 *
      Lambda_inv_0_0_p61 + Lambda_inv_0_0_p68 * Lambda_inv_0_0_p63;

  // link 1 (shoulder), turn
  const Real Lambda_inv_3_3_p1 = 2.0 * c1;

  // link 1 (shoulder), mass matrix
  const Real Lambda_inv_0_2_p4 = Lambda_inv_0_2_p2 - Lambda_inv_0_0_p46 * Lambda_inv_0_2_p1;
  const Real Lambda_inv_0_2_p5 = Lambda_inv_0_2_p1 * Lambda_inv_0_0_p26;
  const Real Lambda_inv_0_2_p6 = Lambda_inv_0_2_p4 * Lambda_inv_0_0_p58;
  const Real Lambda_inv_0_0_p79 = Lambda_inv_0_0_p72 * Lambda_inv_0_0_p77;
  const Real Lambda_inv_0_0_p80 = Lambda_inv_0_0_p74 * Lambda_inv_0_0_p77;
  const Real Lambda_inv_5_5_p10 = Lambda_inv_5_5_p8 * Lambda_inv_0_0_p77;
  const Real Lambda_inv_0_0_p81 = Lambda_inv_0_0_p75 * Lambda_inv_0_0_p77;
  const Real Lambda_inv_0_2_p7 = Lambda_inv_0_2_p3 - Lambda_inv_0_0_p52 * Lambda_inv_0_2_p1 -
      Lambda_inv_0_0_p64 * Lambda_inv_0_2_p4;
  const Real Lambda_inv_0_0_p82 = Lambda_inv_5_5_p1 - Lambda_inv_0_0_p51 * Lambda_inv_0_0_p13 -
      Lambda_inv_0_0_p65 * Lambda_inv_0_0_p53 - Lambda_inv_0_0_p79 * Lambda_inv_0_0_p74;
  const Real Lambda_inv_5_5_p11 = Lambda_inv_5_5_p9 - Lambda_inv_0_0_p79 * Lambda_inv_5_5_p8;
  const Real Lambda_inv_0_0_p83 = Lambda_inv_0_0_p22 * Lambda_inv_0_0_p23 + Lambda_inv_0_0_p44 *
      Lambda_inv_0_0_p18 + Lambda_inv_0_0_p51 * Lambda_inv_0_0_p61 + Lambda_inv_0_0_p65 *
      Lambda_inv_0_0_p63 + Lambda_inv_0_0_p79 * Lambda_inv_0_0_p75;
  const Real Lambda_inv_5_5_p12 = Lambda_inv_5_5_p3 * Lambda_inv_0_0_p22 + Lambda_inv_5_5_p4 *
      Lambda_inv_0_0_p17 + Lambda_inv_5_5_p6 * Lambda_inv_5_5_p2 + Lambda_inv_5_5_p7 *
      Lambda_inv_5_5_p5 + Lambda_inv_5_5_p10 * Lambda_inv_5_5_p8;
  const Real Lambda_inv_0_0_p84 = Lambda_inv_5_5_p3 * Lambda_inv_0_0_p23 - Lambda_inv_5_5_p4 *
      Lambda_inv_0_0_p18 + Lambda_inv_5_5_p6 * Lambda_inv_0_0_p61 + Lambda_inv_5_5_p7 *
      Lambda_inv_0_0_p63 + Lambda_inv_5_5_p10 * Lambda_inv_0_0_p75;
  const Real Lambda_inv_0_0_p85 = 0.17415 - Lambda_inv_0_0_p51 * Lambda_inv_0_0_p49 -
      Lambda_inv_0_0_p65 * Lambda_inv_0_0_p62 - Lambda_inv_0_0_p79 * Lambda_inv_0_0_p76;
  const Real Lambda_inv_0_2_p8 = Lambda_inv_0_0_p51 * Lambda_inv_0_2_p1 + Lambda_inv_0_0_p65 *
      Lambda_inv_0_2_p4 + Lambda_inv_0_0_p79 * Lambda_inv_0_2_p7;
  const Real Lambda_inv_0_2_p9 = Lambda_inv_0_2_p7 * Lambda_inv_0_0_p77;
  const Real Lambda_inv_0_0_p86 = Lambda_inv_0_0_p73 - Lambda_inv_0_0_p79 * Lambda_inv_0_0_p72 -
      2.0 * (Lambda_inv_0_0_p28 + Lambda_inv_0_0_p31) +
      (0.037099816387500005 * Lambda_inv_0_0_p18 - (Lambda_inv_0_0_p18 *
      (0.0012399999999999998 + Lambda_inv_0_0_p11) + 0.021392421525 * Lambda_inv_0_0_p23)) *
      Lambda_inv_0_0_p18;
  const Real Lambda_inv_0_0_p87 = Lambda_inv_0_0_p49 * Lambda_inv_0_0_p26 * Lambda_inv_0_0_p49 +
      Lambda_inv_0_0_p62 * Lambda_inv_0_0_p58 * Lambda_inv_0_0_p62 + Lambda_inv_0_0_p76 *
      Lambda_inv_0_0_p77 * Lambda_inv_0_0_p76;
  const Real Lambda_inv_0_0_p88 = 1.0 / Lambda_inv_0_0_p86;
  const Real Lambda_inv_0_0_p89 = Lambda_inv_0_0_p82 * Lambda_inv_0_0_p88;
  const Real Lambda_inv_5_5_p13 = Lambda_inv_5_5_p11 * Lambda_inv_0_0_p88;
  const Real Lambda_inv_0_0_p90 = Lambda_inv_0_0_p83 * Lambda_inv_0_0_p88;
  const Real Lambda_inv_0_0_p91 = Lambda_inv_0_2_p3 * Lambda_inv_0_0_p88;
  const Real Lambda_inv_0_2_p10 = Lambda_inv_0_2_p8 * Lambda_inv_0_0_p88;
  const Real Lambda_inv_0_0_p92 = Lambda_inv_5_5_p13 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_0_p93 = Lambda_inv_0_0_p90 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_3_p1 = Lambda_inv_0_0_p89 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_0_p94 = Lambda_inv_0_0_p33 * c5 + Lambda_inv_0_0_p55 *
      Lambda_inv_0_0_p13 + Lambda_inv_0_0_p67 * Lambda_inv_0_0_p53 + Lambda_inv_0_0_p80 *
      Lambda_inv_0_0_p74 + Lambda_inv_0_0_p89 * Lambda_inv_0_0_p82;
  const Real Lambda_inv_0_0_p95 = Lambda_inv_0_0_p55 * Lambda_inv_5_5_p2 - Lambda_inv_0_0_p33 *
      Lambda_inv_0_0_p22 + Lambda_inv_0_0_p67 * Lambda_inv_5_5_p5 + Lambda_inv_0_0_p80 *
      Lambda_inv_5_5_p8 + Lambda_inv_0_0_p89 * Lambda_inv_5_5_p11;
  const Real Lambda_inv_5_5 = Lambda_inv_5_5_p12 + Lambda_inv_5_5_p13 * Lambda_inv_5_5_p11;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real Lambda_inv_0_0_p96 = Lambda_inv_0_0_p84 - Lambda_inv_5_5_p13 * Lambda_inv_0_0_p83;
  const Real Lambda_inv_0_0_p97 = Lambda_inv_0_0_p78 + Lambda_inv_0_0_p81 * Lambda_inv_0_0_p75 +
      Lambda_inv_0_0_p90 * Lambda_inv_0_0_p83;
  const Real Lambda_inv_0_0_p98 = Lambda_inv_0_0_p55 * Lambda_inv_0_0_p61 - Lambda_inv_0_0_p33 *
      Lambda_inv_0_0_p23 + Lambda_inv_0_0_p67 * Lambda_inv_0_0_p63 + Lambda_inv_0_0_p80 *
      Lambda_inv_0_0_p75 - Lambda_inv_0_0_p89 * Lambda_inv_0_0_p83;
  const Real Lambda_inv_0_0_p99 = Lambda_inv_0_0_p55 * Lambda_inv_0_0_p49 + Lambda_inv_0_0_p67 *
      Lambda_inv_0_0_p62 + Lambda_inv_0_0_p80 * Lambda_inv_0_0_p76 + Lambda_inv_0_0_p89 *
      Lambda_inv_0_0_p85;
  const Real Lambda_inv_0_0_p100 = Lambda_inv_5_5_p6 * Lambda_inv_0_0_p49 + Lambda_inv_5_5_p7 *
      Lambda_inv_0_0_p62 + Lambda_inv_5_5_p10 * Lambda_inv_0_0_p76 + Lambda_inv_5_5_p13 *
      Lambda_inv_0_0_p85;
  const Real Lambda_inv_0_0_p101 = Lambda_inv_0_0_p98 * Lambda_inv_0_0_p35;
  const Real Lambda_inv_0_0_p102 = Lambda_inv_0_0_p96 * Lambda_inv_0_0_p69;
  const Real Lambda_inv_2_5_p1 = Lambda_inv_0_0_p95 * Lambda_inv_0_0_p70;
  const Real Lambda_inv_2_5_p2 = Lambda_inv_5_5_p6 * Lambda_inv_0_2_p1 + Lambda_inv_5_5_p7 *
      Lambda_inv_0_2_p4 + Lambda_inv_5_5_p10 * Lambda_inv_0_2_p7 - Lambda_inv_5_5_p13 *
      Lambda_inv_0_2_p8;
  const Real Lambda_inv_0_2_p11 = Lambda_inv_0_0_p66 * Lambda_inv_0_2_p1 + Lambda_inv_0_0_p68 *
      Lambda_inv_0_2_p4 + Lambda_inv_0_0_p81 * Lambda_inv_0_2_p7 + Lambda_inv_0_0_p90 *
      Lambda_inv_0_2_p8;
  const Real Lambda_inv_0_2_p12 = Lambda_inv_0_0_p55 * Lambda_inv_0_2_p1 + Lambda_inv_0_0_p67 *
      Lambda_inv_0_2_p4 + Lambda_inv_0_0_p80 * Lambda_inv_0_2_p7 - Lambda_inv_0_0_p89 *
      Lambda_inv_0_2_p8;
  const Real Lambda_inv_0_0_p103 = Lambda_inv_0_0_p99 +
      (Lambda_inv_0_0_p94 * Lambda_inv_0_0_p35 + Lambda_inv_0_0_p95 * Lambda_inv_0_0_p69);
  const Real Lambda_inv_0_0_p104 = Lambda_inv_0_0_p100 +
      (Lambda_inv_0_0_p95 * Lambda_inv_0_0_p35 + Lambda_inv_5_5 * Lambda_inv_0_0_p69);
  const Real Lambda_inv_0_0_p105 = Lambda_inv_0_0_p92 +
      (Lambda_inv_0_0_p96 * Lambda_inv_0_0_p35 - Lambda_inv_5_5 * Lambda_inv_0_0_p70);
  const Real Lambda_inv_0_0_p106 = Lambda_inv_0_0_p93 -
      (Lambda_inv_0_0_p97 * Lambda_inv_0_0_p35 - Lambda_inv_0_0_p96 * Lambda_inv_0_0_p70);
  const Real Lambda_inv_0_0_p107 = Lambda_inv_0_0_p66 * Lambda_inv_0_0_p49 + Lambda_inv_0_0_p68 *
      Lambda_inv_0_0_p62 + Lambda_inv_0_0_p81 * Lambda_inv_0_0_p76 - Lambda_inv_0_0_p90 *
      Lambda_inv_0_0_p85 + (Lambda_inv_0_0_p101 + Lambda_inv_0_0_p102);
  const Real Lambda_inv_0_2_p13 = Lambda_inv_0_2_p11 -
      (Lambda_inv_0_0_p97 * Lambda_inv_0_0_p69 + Lambda_inv_0_0_p98 * Lambda_inv_0_0_p70);
  const Real Lambda_inv_2_5 = Lambda_inv_2_5_p2 - (Lambda_inv_0_0_p102 + Lambda_inv_2_5_p1);
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;
  const Real Lambda_inv_0_3_p2 = Lambda_inv_0_3_p1 + (Lambda_inv_0_0_p101 - Lambda_inv_2_5_p1);
  const Real Lambda_inv_0_2_p14 = Lambda_inv_0_2_p5 * Lambda_inv_0_0_p49 + Lambda_inv_0_2_p6 *
      Lambda_inv_0_0_p62 + Lambda_inv_0_2_p9 * Lambda_inv_0_0_p76 - Lambda_inv_0_2_p10 *
      Lambda_inv_0_0_p85 - Lambda_inv_0_0_p70 * Lambda_inv_0_0_p103;
  const Real Lambda_inv_2_2_p1 = Lambda_inv_0_2_p12 -
      (Lambda_inv_0_0_p98 * Lambda_inv_0_0_p69 + Lambda_inv_0_0_p94 * Lambda_inv_0_0_p70);
  const Real Lambda_inv_0_0_p108 = Lambda_inv_0_0_p91 * Lambda_inv_0_0_p85 + Lambda_inv_0_0_p69 *
      Lambda_inv_0_0_p92 - Lambda_inv_0_0_p70 * Lambda_inv_0_0_p104 +
      (Lambda_inv_0_3_p1 + Lambda_inv_0_0_p107) * Lambda_inv_0_0_p35;
  const Real Lambda_inv_0_0_p109 = Lambda_inv_0_0_p87 + Lambda_inv_0_0_p85 * Lambda_inv_0_0_p88 *
      Lambda_inv_0_0_p85 + (Lambda_inv_0_0_p35 * (Lambda_inv_0_0_p99 + Lambda_inv_0_0_p103) +
      Lambda_inv_0_0_p69 * (Lambda_inv_0_0_p100 + Lambda_inv_0_0_p104));
  const Real Lambda_inv_0_0_p110 = Lambda_inv_0_0_p91 * Lambda_inv_0_2_p3 -
      (Lambda_inv_0_0_p70 * (Lambda_inv_0_0_p92 + Lambda_inv_0_0_p105) + Lambda_inv_0_0_p35 *
      (Lambda_inv_0_0_p93 + Lambda_inv_0_0_p106));
  const Real Lambda_inv_0_2_p15 = Lambda_inv_0_2_p14 + Lambda_inv_0_0_p35 * Lambda_inv_0_2_p12 +
      (Lambda_inv_2_5_p2 - Lambda_inv_0_0_p107) * Lambda_inv_0_0_p69;
  const Real Lambda_inv_0_2_p16 = Lambda_inv_0_0_p91 * Lambda_inv_0_2_p8 - Lambda_inv_0_0_p69 *
      Lambda_inv_0_0_p93 - Lambda_inv_0_0_p35 * Lambda_inv_0_2_p13 +
      (Lambda_inv_0_3_p1 + Lambda_inv_2_5) * Lambda_inv_0_0_p70;

  // link 1 (shoulder), turn
  const Real Lambda_inv_3_3_p2 = s1 * (Lambda_inv_0_0_p97 - Lambda_inv_0_0_p94) -
      Lambda_inv_3_3_p1 * Lambda_inv_0_0_p98;
  const Real Lambda_inv_0_3_p3 = s1 * (Lambda_inv_0_0_p107 + Lambda_inv_0_3_p2) - c1 *
      (Lambda_inv_0_0_p106 + Lambda_inv_0_0_p103);
  const Real Lambda_inv_0_3_p4 = s1 * Lambda_inv_0_3_p3;
  const Real Lambda_inv_0_4_p1 = c1 * Lambda_inv_0_3_p3;
  const Real Lambda_inv_3_3_p3 = s1 * Lambda_inv_3_3_p2;
  const Real Lambda_inv_0_2 = c1 * Lambda_inv_0_2_p15 + s1 * Lambda_inv_0_2_p16;
  Lambda_inv[2] = Lambda_inv_0_2;
  Lambda_inv[12] = Lambda_inv_0_2;
  const Real Lambda_inv_0_3 = Lambda_inv_0_0_p107 - Lambda_inv_0_3_p4;
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;
  const Real Lambda_inv_0_4 = Lambda_inv_0_4_p1 + Lambda_inv_0_0_p106;
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[24] = Lambda_inv_0_4;
  const Real Lambda_inv_0_5 = c1 * Lambda_inv_0_0_p104 - s1 * Lambda_inv_0_0_p105;
  Lambda_inv[5] = Lambda_inv_0_5;
  Lambda_inv[30] = Lambda_inv_0_5;
  const Real Lambda_inv_1_2 = s1 * Lambda_inv_0_2_p15 - c1 * Lambda_inv_0_2_p16;
  Lambda_inv[8] = Lambda_inv_1_2;
  Lambda_inv[13] = Lambda_inv_1_2;
  const Real Lambda_inv_1_3 = Lambda_inv_0_4_p1 + Lambda_inv_0_0_p103;
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  const Real Lambda_inv_1_4 = Lambda_inv_0_3_p4 - Lambda_inv_0_3_p2;
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_1_5 = s1 * Lambda_inv_0_0_p104 + c1 * Lambda_inv_0_0_p105;
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real Lambda_inv_0_0_p111 = s1 * (Lambda_inv_0_0_p109 - Lambda_inv_0_0_p110) +
      Lambda_inv_3_3_p1 * Lambda_inv_0_0_p108;

  // link 1 (shoulder), mass matrix
  Lambda_inv[14] = Lambda_inv_0_2_p5 * Lambda_inv_0_2_p1 + Lambda_inv_0_2_p6 * Lambda_inv_0_2_p4 +
      Lambda_inv_0_2_p9 * Lambda_inv_0_2_p7 + Lambda_inv_0_2_p10 * Lambda_inv_0_2_p8 -
      (Lambda_inv_0_0_p69 * (Lambda_inv_0_2_p11 + Lambda_inv_0_2_p13) + Lambda_inv_0_0_p70 *
      (Lambda_inv_0_2_p12 + Lambda_inv_2_2_p1));

  // link 1 (shoulder), turn
  const Real Lambda_inv_2_3 = c1 * Lambda_inv_0_2_p13 + s1 * Lambda_inv_2_2_p1;
  Lambda_inv[15] = Lambda_inv_2_3;
  Lambda_inv[20] = Lambda_inv_2_3;
  const Real Lambda_inv_2_4 = s1 * Lambda_inv_0_2_p13 - c1 * Lambda_inv_2_2_p1;
  Lambda_inv[16] = Lambda_inv_2_4;
  Lambda_inv[26] = Lambda_inv_2_4;
  Lambda_inv[21] = Lambda_inv_0_0_p97 - Lambda_inv_3_3_p3;
  const Real Lambda_inv_3_4 = c1 * Lambda_inv_3_3_p2 + Lambda_inv_0_0_p98;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;
  const Real Lambda_inv_3_5 = c1 * Lambda_inv_0_0_p96 + s1 * Lambda_inv_0_0_p95;
  Lambda_inv[23] = Lambda_inv_3_5;
  Lambda_inv[33] = Lambda_inv_3_5;
  Lambda_inv[28] = Lambda_inv_0_0_p94 + Lambda_inv_3_3_p3;
  const Real Lambda_inv_4_5 = s1 * Lambda_inv_0_0_p96 - c1 * Lambda_inv_0_0_p95;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
  const Real Lambda_inv_0_0_p112 = s1 * Lambda_inv_0_0_p111;
  Lambda_inv[0] = Lambda_inv_0_0_p109 - Lambda_inv_0_0_p112;
  const Real Lambda_inv_0_1 = c1 * Lambda_inv_0_0_p111 - Lambda_inv_0_0_p108;
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;
  Lambda_inv[7] = Lambda_inv_0_0_p110 + Lambda_inv_0_0_p112;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
