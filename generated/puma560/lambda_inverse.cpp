// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J in world axes, in the axes asked for at link origins.
// 634 flops (add 266, mul 364, div 4), sine and cosine of 5 angles
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
  const Real angles[5] = {q[0], q[1], q[2], q[3], q[4]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s1 = sines[0];
  const Real c1 = cosines[0];
  const Real s2 = sines[1];
  const Real c2 = cosines[1];
  const Real s3 = sines[2];
  const Real c3 = cosines[2];
  const Real s4 = sines[3];
  const Real c4 = cosines[3];
  const Real s5 = sines[4];
  const Real c5 = cosines[4];

  // link 5 (link5), composite inertia
  const Real Lambda_inv_0_4_p1 = 0.0028799999999999997 * s5;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_4_p2 = c4 * Lambda_inv_0_4_p1;
  const Real Lambda_inv_0_4_p3 = 0.4331 * Lambda_inv_0_4_p2;

  // link 5 (link5), composite inertia
  const Real Lambda_inv_0_4_p4 = 0.00020215999999999998 * s5;
  const Real Lambda_inv_0_4_p5 = c5 * Lambda_inv_0_4_p4;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_4_p6 = c4 * Lambda_inv_0_4_p5;
  const Real Lambda_inv_0_4_p7 = Lambda_inv_0_4_p6 -
      (0.010673638499999999 - Lambda_inv_0_4_p3 + 5.846399999999999e-05 * c5);

  // link 5 (link5), composite inertia
  const Real Lambda_inv_0_4_p8 = 0.0028799999999999997 * c5;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_4_p9 = 0.861795 + Lambda_inv_0_4_p8;
  const Real Lambda_inv_0_4_p10 = 0.025374999999999998 - Lambda_inv_0_4_p2;

  // link 3 (link3), composite inertia
  const Real Lambda_inv_0_4_p11 = c3 * Lambda_inv_0_4_p9 + s3 * Lambda_inv_0_4_p10;

  // link 5 (link5), composite inertia
  const Real Lambda_inv_0_4_p12 = s5 * Lambda_inv_0_4_p4;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_4_p13 = s4 * (0.00010000000000000026 + Lambda_inv_0_4_p12);
  const Real Lambda_inv_0_4_p14 = s4 * Lambda_inv_0_4_p13;
  const Real Lambda_inv_0_4_p15 = Lambda_inv_0_4_p14 +
      (0.0011921599999999998 - (Lambda_inv_0_4_p12 - (0.3056901365 + 0.0024946559999999996 * c5)));
  const Real Lambda_inv_0_4_p16 = 0.008405112499999999 + Lambda_inv_0_4_p12 - 0.0406 *
      Lambda_inv_0_4_p2;

  // link 3 (link3), composite inertia
  const Real Lambda_inv_0_4_p17 = Lambda_inv_0_4_p7 * (2.0 * c3) + s3 *
      (Lambda_inv_0_4_p15 - Lambda_inv_0_4_p16);
  const Real Lambda_inv_0_4_p18 = s3 * Lambda_inv_0_4_p17;
  const Real Lambda_inv_0_4_p19 = s3 * Lambda_inv_0_4_p9 - c3 * Lambda_inv_0_4_p10;
  const Real Lambda_inv_0_4_p20 = 0.4318 * Lambda_inv_0_4_p19;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_4_p21 = s4 * Lambda_inv_0_4_p1;

  // link 3 (link3), composite inertia
  const Real Lambda_inv_0_4_p22 = 0.1501 * Lambda_inv_0_4_p21;
  const Real Lambda_inv_0_4_p23 = Lambda_inv_0_4_p18 +
      (Lambda_inv_0_4_p16 + (1.674987602 + 2.0 * (Lambda_inv_0_4_p20 + Lambda_inv_0_4_p22)));

  // link 2 (link2), composite inertia
  const Real Lambda_inv_0_4_p24 = (Lambda_inv_0_4_p7 + (0.0070992 - 0.4318 * Lambda_inv_0_4_p11) -
      c3 * Lambda_inv_0_4_p17) * (2.0 * c2) + s2 * (Lambda_inv_0_4_p23 +
      (Lambda_inv_0_4_p18 - (Lambda_inv_0_4_p15 + (0.07312640000000001 + 0.3002 *
      Lambda_inv_0_4_p21))));

  // link 6 (link6), mass matrix
  const Real Lambda_inv_0_4_p25 = 4e-05 * c5;
  const Real Lambda_inv_0_4_p26 = 4e-05 * s5;
  const Real Lambda_inv_0_4_p27 = c4 * Lambda_inv_0_4_p26;
  const Real Lambda_inv_0_4_p28 = c2 * (c3 * Lambda_inv_0_4_p25 - s3 * Lambda_inv_0_4_p27) - s2 *
      (s3 * Lambda_inv_0_4_p25 + c3 * Lambda_inv_0_4_p27);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p29 = 24999.999999999996 * Lambda_inv_0_4_p28;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_0_4_p30 = c4 * Lambda_inv_0_4_p8;
  const Real Lambda_inv_0_4_p31 = s4 * Lambda_inv_0_4_p8;
  const Real Lambda_inv_0_4_p32 = 0.0203 * Lambda_inv_0_4_p31;
  const Real Lambda_inv_0_4_p33 = 0.4318 * Lambda_inv_0_4_p31 + 0.1501 *
      (s3 * Lambda_inv_0_4_p1 - c3 * Lambda_inv_0_4_p30) - c3 * Lambda_inv_0_4_p32;
  const Real Lambda_inv_0_4_p34 = 0.4331 * Lambda_inv_0_4_p31 + 0.00064216 * s4;
  const Real Lambda_inv_0_4_p35 = c3 * Lambda_inv_0_4_p1 + s3 * Lambda_inv_0_4_p30;
  const Real Lambda_inv_0_4_p36 = c2 * (Lambda_inv_0_4_p33 + s3 * Lambda_inv_0_4_p34) + s2 *
      (0.1501 * Lambda_inv_0_4_p35 + s3 * Lambda_inv_0_4_p32 + c3 * Lambda_inv_0_4_p34);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p37 = 1557.24430048586 * Lambda_inv_0_4_p36;

  // link 5 (link5), composite inertia
  const Real Lambda_inv_0_4_p38 = 0.00164 + Lambda_inv_0_4_p12;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_4_p39 = 0.0203 * Lambda_inv_0_4_p2;

  // link 4 (link4), mass matrix
  const Real Lambda_inv_0_4_p40 = Lambda_inv_0_4_p38 - Lambda_inv_0_4_p39;
  const Real Lambda_inv_0_4_p41 = Lambda_inv_0_4_p3 + Lambda_inv_0_4_p6;
  const Real Lambda_inv_0_4_p42 = s3 * Lambda_inv_0_4_p21;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p43 = c2 * (c3 * (Lambda_inv_0_4_p22 + Lambda_inv_0_4_p40) +
      (0.4318 * Lambda_inv_0_4_p2 + s3 * Lambda_inv_0_4_p41)) - s2 *
      (0.1501 * Lambda_inv_0_4_p42 + s3 * Lambda_inv_0_4_p40 - c3 * Lambda_inv_0_4_p41);
  const Real Lambda_inv_0_4_p44 = 0.9999999999999999 * c5;
  const Real Lambda_inv_0_4_p45 = Lambda_inv_0_4_p43 - Lambda_inv_0_4_p28 * Lambda_inv_0_4_p44;
  const Real Lambda_inv_0_4_p46 = 1.0 / (Lambda_inv_0_4_p38 - Lambda_inv_0_4_p25 *
      Lambda_inv_0_4_p44);
  const Real Lambda_inv_0_4_p47 = Lambda_inv_0_4_p45 * Lambda_inv_0_4_p46;
  const Real Lambda_inv_0_4_p48 = 1.4717295504999999 + Lambda_inv_0_4_p23 - s2 *
      Lambda_inv_0_4_p24 - Lambda_inv_0_4_p28 * Lambda_inv_0_4_p29 - Lambda_inv_0_4_p36 *
      Lambda_inv_0_4_p37 - Lambda_inv_0_4_p45 * Lambda_inv_0_4_p47;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_4_p49 = 0.4331 * Lambda_inv_0_4_p21 + s4 * Lambda_inv_0_4_p5;
  const Real Lambda_inv_0_4_p50 = 0.004704000000000001 + Lambda_inv_0_4_p49;
  const Real Lambda_inv_0_4_p51 = 0.0203 * Lambda_inv_0_4_p21 - c4 * Lambda_inv_0_4_p13;

  // link 3 (link3), composite inertia
  const Real Lambda_inv_0_4_p52 = 0.1501 * Lambda_inv_0_4_p11 + c3 * Lambda_inv_0_4_p50 + s3 *
      Lambda_inv_0_4_p51;
  const Real Lambda_inv_0_4_p53 = s3 * Lambda_inv_0_4_p50 - c3 * Lambda_inv_0_4_p51;
  const Real Lambda_inv_0_4_p54 = 0.1501 * Lambda_inv_0_4_p19;

  // link 6 (link6), mass matrix
  const Real Lambda_inv_0_4_p55 = s4 * Lambda_inv_0_4_p26;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p56 = 24999.999999999996 * Lambda_inv_0_4_p55;
  const Real Lambda_inv_0_4_p57 = Lambda_inv_0_4_p28 * Lambda_inv_0_4_p56;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_0_4_p58 = 0.4331 * Lambda_inv_0_4_p30 - 5.846399999999999e-05 * s5 +
      0.00064216 * c4;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p59 = 1557.24430048586 * Lambda_inv_0_4_p58;
  const Real Lambda_inv_0_4_p60 = Lambda_inv_0_4_p55 * Lambda_inv_0_4_p44;
  const Real Lambda_inv_0_4_p61 = Lambda_inv_0_4_p49 + Lambda_inv_0_4_p60;
  const Real Lambda_inv_0_4_p62 = Lambda_inv_0_4_p61 * Lambda_inv_0_4_p46;
  const Real Lambda_inv_0_4_p63 = Lambda_inv_0_4_p57 +
      (c2 * Lambda_inv_0_4_p52 - s2 * (Lambda_inv_0_4_p54 + Lambda_inv_0_4_p53)) +
      Lambda_inv_0_4_p36 * Lambda_inv_0_4_p59 - Lambda_inv_0_4_p45 * Lambda_inv_0_4_p62;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_0_4_p64 = Lambda_inv_0_4_p14 +
      (2.0 * (Lambda_inv_0_4_p39 - 0.0012473279999999998 * c5) - 0.313747409);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p65 = Lambda_inv_0_4_p55 * Lambda_inv_0_4_p56;
  const Real Lambda_inv_0_4_p66 = 1.0 / (Lambda_inv_0_4_p64 + Lambda_inv_0_4_p65 +
      Lambda_inv_0_4_p58 * Lambda_inv_0_4_p59 + Lambda_inv_0_4_p61 * Lambda_inv_0_4_p62);
  const Real Lambda_inv_0_4_p67 = Lambda_inv_0_4_p63 * Lambda_inv_0_4_p66;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_0_4_p68 = Lambda_inv_0_4_p58 + 0.4318 * Lambda_inv_0_4_p35;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p69 = Lambda_inv_0_4_p60 +
      (Lambda_inv_0_4_p49 + 0.4318 * Lambda_inv_0_4_p42);
  const Real Lambda_inv_0_4_p70 = Lambda_inv_0_4_p65 + (Lambda_inv_0_4_p64 - Lambda_inv_0_4_p20) +
      Lambda_inv_0_4_p68 * Lambda_inv_0_4_p59 + Lambda_inv_0_4_p69 * Lambda_inv_0_4_p62;
  const Real Lambda_inv_0_4_p71 = Lambda_inv_0_4_p70 * Lambda_inv_0_4_p66;
  const Real Lambda_inv_0_4_p72 = c2 * (0.023750999999999998 - Lambda_inv_0_4_p52) + s2 *
      (Lambda_inv_0_4_p53 + (0.690314699 + Lambda_inv_0_4_p54 + 0.4318 * Lambda_inv_0_4_p21));
  const Real Lambda_inv_0_4_p73 = 1557.24430048586 * Lambda_inv_0_4_p68;
  const Real Lambda_inv_0_4_p74 = Lambda_inv_0_4_p69 * Lambda_inv_0_4_p46;
  const Real Lambda_inv_0_4_p75 = Lambda_inv_0_4_p57 - Lambda_inv_0_4_p72 + Lambda_inv_0_4_p36 *
      Lambda_inv_0_4_p73 - Lambda_inv_0_4_p45 * Lambda_inv_0_4_p74 - Lambda_inv_0_4_p63 *
      Lambda_inv_0_4_p71;
  const Real Lambda_inv_0_4_p76 = Lambda_inv_0_4_p65 -
      (1.7481140020000001 - Lambda_inv_0_4_p64 + 0.8636 * Lambda_inv_0_4_p19) + Lambda_inv_0_4_p68 *
      Lambda_inv_0_4_p73 + Lambda_inv_0_4_p69 * Lambda_inv_0_4_p74;
  const Real Lambda_inv_0_4_p77 = 1.0 / (Lambda_inv_0_4_p76 - Lambda_inv_0_4_p70 *
      Lambda_inv_0_4_p71);
  const Real Lambda_inv_0_4_p78 = Lambda_inv_0_4_p75 * Lambda_inv_0_4_p77;
  const Real Lambda_inv_0_4_p79 = 1.0 / (Lambda_inv_0_4_p48 + Lambda_inv_0_4_p63 *
      Lambda_inv_0_4_p67 + Lambda_inv_0_4_p75 * Lambda_inv_0_4_p78);

  // link 2 (link2), pose
  const Real Lambda_inv_0_4_p80 = s1 * s2;
  const Real Lambda_inv_0_4_p81 = s1 * c2;

  // link 3 (link3), pose
  const Real Lambda_inv_0_4_p82 = c3 * Lambda_inv_0_4_p80 + s3 * Lambda_inv_0_4_p81;
  const Real Lambda_inv_0_4_p83 = s3 * Lambda_inv_0_4_p80 - c3 * Lambda_inv_0_4_p81;

  // link 5 (link5), pose
  const Real Lambda_inv_0_4_p84 = c5 * Lambda_inv_0_4_p82 + s5 *
      (c1 * s4 - c4 * Lambda_inv_0_4_p83);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p85 = c1 - Lambda_inv_0_4_p84 * Lambda_inv_0_4_p56;

  // link 4 (link4), pose
  const Real Lambda_inv_0_4_p86 = c1 * c4 + s4 * Lambda_inv_0_4_p83;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p87 = Lambda_inv_0_4_p82 - Lambda_inv_0_4_p84 * Lambda_inv_0_4_p44;
  const Real Lambda_inv_0_4_p88 = Lambda_inv_0_4_p85 - Lambda_inv_0_4_p86 * Lambda_inv_0_4_p59 +
      Lambda_inv_0_4_p62 * Lambda_inv_0_4_p87;
  const Real Lambda_inv_0_4_p89 = Lambda_inv_0_4_p85 - Lambda_inv_0_4_p86 * Lambda_inv_0_4_p73 +
      Lambda_inv_0_4_p74 * Lambda_inv_0_4_p87 - Lambda_inv_0_4_p71 * Lambda_inv_0_4_p88;
  const Real Lambda_inv_0_4_p90 = Lambda_inv_0_4_p84 * Lambda_inv_0_4_p29 + Lambda_inv_0_4_p86 *
      Lambda_inv_0_4_p37 + Lambda_inv_0_4_p47 * Lambda_inv_0_4_p87 + Lambda_inv_0_4_p67 *
      Lambda_inv_0_4_p88 + Lambda_inv_0_4_p78 * Lambda_inv_0_4_p89;
  const Real Lambda_inv_0_4_p91 = Lambda_inv_0_4_p79 * Lambda_inv_0_4_p90;

  // link 3 (link3), pose
  const Real Lambda_inv_0_4_p92 = c2 * c3 - s2 * s3;
  const Real Lambda_inv_0_4_p93 = c2 * s3 + s2 * c3;

  // link 4 (link4), pose
  const Real Lambda_inv_0_4_p94 = 0.4331 * Lambda_inv_0_4_p92 + 0.0203 * Lambda_inv_0_4_p93;

  // link 3 (link3), Jacobian
  const Real Lambda_inv_0_4_p95 = c1 * Lambda_inv_0_4_p94;

  // link 2 (link2), Jacobian
  const Real Lambda_inv_0_4_p96 = Lambda_inv_0_4_p94 - 0.4318 * s2;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p97 = c1 * Lambda_inv_0_4_p96 - Lambda_inv_0_4_p95 * Lambda_inv_0_4_p71;

  // link 4 (link4), pose
  const Real p4_y_p1 = 0.4331 * Lambda_inv_0_4_p82 + 0.0203 * Lambda_inv_0_4_p83;
  const Real p4_y = p4_y_p1 + (0.1501 * c1 + 0.4318 * Lambda_inv_0_4_p81);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p98 = p4_y + Lambda_inv_0_4_p95 * Lambda_inv_0_4_p67 +
      Lambda_inv_0_4_p78 * Lambda_inv_0_4_p97;
  const Real Lambda_inv_0_4_p99 = Lambda_inv_0_4_p77 * Lambda_inv_0_4_p89;
  const Real Lambda_inv_0_4_p100 = Lambda_inv_0_4_p66 * Lambda_inv_0_4_p88;
  const Real Lambda_inv_0_4_p101 = Lambda_inv_0_4_p95 * Lambda_inv_0_4_p100 + Lambda_inv_0_4_p97 *
      Lambda_inv_0_4_p99 - Lambda_inv_0_4_p98 * Lambda_inv_0_4_p91;
  const Real Lambda_inv_4_4_p1 = 24999.999999999996 * Lambda_inv_0_4_p84;
  const Real Lambda_inv_4_4_p2 = 1557.24430048586 * Lambda_inv_0_4_p86;
  const Real Lambda_inv_4_4_p3 = Lambda_inv_0_4_p46 * Lambda_inv_0_4_p87;
  const Real Lambda_inv_4_4_p4 = Lambda_inv_0_4_p84 * Lambda_inv_4_4_p1 + Lambda_inv_0_4_p86 *
      Lambda_inv_4_4_p2 + Lambda_inv_0_4_p87 * Lambda_inv_4_4_p3 - Lambda_inv_0_4_p88 *
      Lambda_inv_0_4_p100 - Lambda_inv_0_4_p89 * Lambda_inv_0_4_p99;
  const Real Lambda_inv_4_4 = Lambda_inv_4_4_p4 + Lambda_inv_0_4_p90 * Lambda_inv_0_4_p91;
  Lambda_inv[28] = Lambda_inv_4_4;

  // link 5 (link5), pose
  const Real Lambda_inv_0_4_p102 = c5 * Lambda_inv_0_4_p92 - Lambda_inv_0_4_p93 * (c4 * s5);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_4_p103 = 0.05625 * Lambda_inv_0_4_p102;
  const Real Lambda_inv_4_5_p1 = Lambda_inv_0_4_p102 * Lambda_inv_0_4_p56;

  // link 4 (link4), pose
  const Real Lambda_inv_4_5_p2 = s4 * Lambda_inv_0_4_p93;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_4_5_p3 = Lambda_inv_0_4_p92 - Lambda_inv_0_4_p102 * Lambda_inv_0_4_p44;
  const Real Lambda_inv_4_5_p4 = Lambda_inv_4_5_p1 + Lambda_inv_4_5_p2 * Lambda_inv_0_4_p59 -
      Lambda_inv_0_4_p62 * Lambda_inv_4_5_p3;
  const Real Lambda_inv_4_5_p5 = Lambda_inv_4_5_p1 + Lambda_inv_4_5_p2 * Lambda_inv_0_4_p73 -
      Lambda_inv_0_4_p74 * Lambda_inv_4_5_p3 - Lambda_inv_0_4_p71 * Lambda_inv_4_5_p4;
  const Real Lambda_inv_4_5_p6 = 1.0 - Lambda_inv_0_4_p102 * Lambda_inv_0_4_p29 -
      Lambda_inv_4_5_p2 * Lambda_inv_0_4_p37 - Lambda_inv_0_4_p47 * Lambda_inv_4_5_p3 +
      Lambda_inv_0_4_p67 * Lambda_inv_4_5_p4;
  const Real Lambda_inv_4_5_p7 = Lambda_inv_4_5_p6 + Lambda_inv_0_4_p78 * Lambda_inv_4_5_p5;
  const Real Lambda_inv_4_5_p8 = Lambda_inv_0_4_p79 * Lambda_inv_4_5_p7;
  const Real Lambda_inv_4_5_p9 = Lambda_inv_0_4_p77 * Lambda_inv_4_5_p5;
  const Real Lambda_inv_4_5_p10 = Lambda_inv_0_4_p66 * Lambda_inv_4_5_p4;
  const Real Lambda_inv_4_5_p11 = 24999.999999999996 * Lambda_inv_0_4_p102;
  const Real Lambda_inv_4_5_p12 = 1557.24430048586 * Lambda_inv_4_5_p2;
  const Real Lambda_inv_4_5_p13 = Lambda_inv_0_4_p46 * Lambda_inv_4_5_p3;
  const Real Lambda_inv_4_5_p14 = Lambda_inv_0_4_p84 * Lambda_inv_4_5_p11 + Lambda_inv_0_4_p86 *
      Lambda_inv_4_5_p12 + Lambda_inv_0_4_p87 * Lambda_inv_4_5_p13 + Lambda_inv_0_4_p88 *
      Lambda_inv_4_5_p10 + Lambda_inv_0_4_p89 * Lambda_inv_4_5_p9;
  const Real Lambda_inv_4_5 = Lambda_inv_4_5_p14 - Lambda_inv_0_4_p90 * Lambda_inv_4_5_p8;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
  const Real Lambda_inv_0_4_p104 = 0.05625 * Lambda_inv_0_4_p84;
  const Real Lambda_inv_0_4 = Lambda_inv_0_4_p101 - Lambda_inv_4_4 * Lambda_inv_0_4_p103 +
      Lambda_inv_4_5 * Lambda_inv_0_4_p104;
  Lambda_inv[4] = -Lambda_inv_0_4;
  Lambda_inv[24] = -Lambda_inv_0_4;
  const Real Lambda_inv_0_0_p1 = Lambda_inv_0_4_p66 * (Lambda_inv_0_4_p95 * Lambda_inv_0_4_p95) +
      Lambda_inv_0_4_p97 * (Lambda_inv_0_4_p77 * Lambda_inv_0_4_p97) - Lambda_inv_0_4_p98 *
      (Lambda_inv_0_4_p79 * Lambda_inv_0_4_p98);
  const Real Lambda_inv_0_5_p1 = Lambda_inv_0_4_p95 * Lambda_inv_4_5_p10 + Lambda_inv_0_4_p97 *
      Lambda_inv_4_5_p9 - Lambda_inv_0_4_p98 * Lambda_inv_4_5_p8;
  const Real Lambda_inv_5_5_p1 = Lambda_inv_0_4_p102 * Lambda_inv_4_5_p11 + Lambda_inv_4_5_p2 *
      Lambda_inv_4_5_p12 + Lambda_inv_4_5_p3 * Lambda_inv_4_5_p13 - Lambda_inv_4_5_p4 *
      Lambda_inv_4_5_p10 - Lambda_inv_4_5_p5 * Lambda_inv_4_5_p9;
  const Real Lambda_inv_5_5 = Lambda_inv_5_5_p1 + Lambda_inv_4_5_p7 * Lambda_inv_4_5_p8;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real Lambda_inv_0_5 = Lambda_inv_0_5_p1 + Lambda_inv_4_5 * Lambda_inv_0_4_p103 -
      Lambda_inv_5_5 * Lambda_inv_0_4_p104;
  Lambda_inv[5] = Lambda_inv_0_5;
  Lambda_inv[30] = Lambda_inv_0_5;
  Lambda_inv[0] = -(Lambda_inv_0_0_p1 + Lambda_inv_0_4_p103 *
      (Lambda_inv_0_4_p101 + Lambda_inv_0_4) + Lambda_inv_0_4_p104 *
      (Lambda_inv_0_5_p1 + Lambda_inv_0_5));

  // link 2 (link2), pose
  const Real Lambda_inv_3_4_p1 = c1 * s2;
  const Real Lambda_inv_3_4_p2 = c1 * c2;

  // link 3 (link3), pose
  const Real Lambda_inv_3_4_p3 = c3 * Lambda_inv_3_4_p1 + s3 * Lambda_inv_3_4_p2;
  const Real Lambda_inv_3_4_p4 = s3 * Lambda_inv_3_4_p1 - c3 * Lambda_inv_3_4_p2;

  // link 5 (link5), pose
  const Real Lambda_inv_3_4_p5 = c5 * Lambda_inv_3_4_p3 - s5 * (s1 * s4 + c4 * Lambda_inv_3_4_p4);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_3_4_p6 = s1 + Lambda_inv_3_4_p5 * Lambda_inv_0_4_p56;

  // link 4 (link4), pose
  const Real Lambda_inv_3_4_p7 = s1 * c4 - s4 * Lambda_inv_3_4_p4;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_3_4_p8 = Lambda_inv_3_4_p3 - Lambda_inv_3_4_p5 * Lambda_inv_0_4_p44;
  const Real Lambda_inv_3_4_p9 = Lambda_inv_3_4_p6 - Lambda_inv_3_4_p7 * Lambda_inv_0_4_p59 -
      Lambda_inv_0_4_p62 * Lambda_inv_3_4_p8;
  const Real Lambda_inv_3_4_p10 = Lambda_inv_3_4_p6 - Lambda_inv_3_4_p7 * Lambda_inv_0_4_p73 -
      Lambda_inv_0_4_p74 * Lambda_inv_3_4_p8 - Lambda_inv_0_4_p71 * Lambda_inv_3_4_p9;
  const Real Lambda_inv_3_4_p11 = Lambda_inv_3_4_p5 * Lambda_inv_0_4_p29 - Lambda_inv_3_4_p7 *
      Lambda_inv_0_4_p37 + Lambda_inv_0_4_p47 * Lambda_inv_3_4_p8 - Lambda_inv_0_4_p67 *
      Lambda_inv_3_4_p9 - Lambda_inv_0_4_p78 * Lambda_inv_3_4_p10;
  const Real Lambda_inv_3_4_p12 = Lambda_inv_3_4_p5 * Lambda_inv_4_4_p1 - Lambda_inv_3_4_p7 *
      Lambda_inv_4_4_p2 + Lambda_inv_3_4_p8 * Lambda_inv_4_4_p3 + Lambda_inv_3_4_p9 *
      Lambda_inv_0_4_p100 + Lambda_inv_3_4_p10 * Lambda_inv_0_4_p99;
  const Real Lambda_inv_3_4 = Lambda_inv_3_4_p12 + Lambda_inv_3_4_p11 * Lambda_inv_0_4_p91;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;
  const Real Lambda_inv_0_3_p1 = Lambda_inv_3_4 * Lambda_inv_0_4_p103;
  const Real Lambda_inv_0_3_p2 = Lambda_inv_0_4_p79 * Lambda_inv_3_4_p11;
  const Real Lambda_inv_0_3_p3 = Lambda_inv_0_4_p77 * Lambda_inv_3_4_p10;
  const Real Lambda_inv_0_3_p4 = Lambda_inv_0_4_p66 * Lambda_inv_3_4_p9;
  const Real Lambda_inv_3_5_p1 = Lambda_inv_3_4_p5 * Lambda_inv_4_5_p11 - Lambda_inv_3_4_p7 *
      Lambda_inv_4_5_p12 + Lambda_inv_3_4_p8 * Lambda_inv_4_5_p13 - Lambda_inv_3_4_p9 *
      Lambda_inv_4_5_p10 - Lambda_inv_3_4_p10 * Lambda_inv_4_5_p9;
  const Real Lambda_inv_3_5 = Lambda_inv_3_5_p1 - Lambda_inv_3_4_p11 * Lambda_inv_4_5_p8;
  Lambda_inv[23] = Lambda_inv_3_5;
  Lambda_inv[33] = Lambda_inv_3_5;
  const Real Lambda_inv_0_3_p5 = Lambda_inv_3_5 * Lambda_inv_0_4_p104;
  const Real Lambda_inv_0_3 = Lambda_inv_0_3_p5 - (Lambda_inv_0_3_p1 +
      (Lambda_inv_0_4_p95 * Lambda_inv_0_3_p4 + Lambda_inv_0_4_p97 * Lambda_inv_0_3_p3 +
      Lambda_inv_0_4_p98 * Lambda_inv_0_3_p2));
  Lambda_inv[3] = -Lambda_inv_0_3;
  Lambda_inv[18] = -Lambda_inv_0_3;

  // link 3 (link3), Jacobian
  const Real Lambda_inv_0_1_p1 = s1 * Lambda_inv_0_4_p94;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_1_p2 = s1 * Lambda_inv_0_4_p96 - Lambda_inv_0_1_p1 * Lambda_inv_0_4_p71;

  // link 4 (link4), pose
  const Real p4_x_p1 = 0.4331 * Lambda_inv_3_4_p3 + 0.0203 * Lambda_inv_3_4_p4;
  const Real p4_x = p4_x_p1 - (0.1501 * s1 - 0.4318 * Lambda_inv_3_4_p2);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_1_p3 = p4_x - Lambda_inv_0_1_p1 * Lambda_inv_0_4_p67 -
      Lambda_inv_0_4_p78 * Lambda_inv_0_1_p2;
  const Real Lambda_inv_0_1_p4 = Lambda_inv_0_1_p1 * Lambda_inv_0_4_p100 + Lambda_inv_0_1_p2 *
      Lambda_inv_0_4_p99 + Lambda_inv_0_1_p3 * Lambda_inv_0_4_p91;
  const Real Lambda_inv_0_1_p5 = 0.05625 * Lambda_inv_3_4_p5;
  const Real Lambda_inv_0_1_p6 = Lambda_inv_0_4_p79 * Lambda_inv_0_1_p3;
  const Real Lambda_inv_0_1_p7 = Lambda_inv_0_4_p77 * Lambda_inv_0_1_p2;
  const Real Lambda_inv_0_1_p8 = Lambda_inv_0_1_p1 * Lambda_inv_0_4_p66;
  const Real Lambda_inv_0_1_p9 = Lambda_inv_0_1_p1 * Lambda_inv_4_5_p10 + Lambda_inv_0_1_p2 *
      Lambda_inv_4_5_p9 + Lambda_inv_0_1_p3 * Lambda_inv_4_5_p8;
  const Real Lambda_inv_0_1_p10 = Lambda_inv_0_4_p95 * Lambda_inv_0_1_p8 + Lambda_inv_0_4_p97 *
      Lambda_inv_0_1_p7 + Lambda_inv_0_4_p98 * Lambda_inv_0_1_p6 - Lambda_inv_0_1_p5 *
      Lambda_inv_0_5 + Lambda_inv_0_1_p9 * Lambda_inv_0_4_p104;
  const Real Lambda_inv_0_1 = Lambda_inv_0_4_p103 * (Lambda_inv_0_1_p4 - Lambda_inv_0_3) +
      Lambda_inv_0_1_p10;
  Lambda_inv[1] = -Lambda_inv_0_1;
  Lambda_inv[6] = -Lambda_inv_0_1;

  // link 3 (link3), Jacobian
  const Real Lambda_inv_0_2_p1 = c1 * p4_x_p1 + s1 * p4_y_p1;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_2_p2 = c1 * p4_x + s1 * p4_y - Lambda_inv_0_2_p1 * Lambda_inv_0_4_p71;
  const Real Lambda_inv_0_2_p3 = Lambda_inv_0_2_p1 * Lambda_inv_0_4_p67 + Lambda_inv_0_4_p78 *
      Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_2_p4 = Lambda_inv_0_2_p1 * Lambda_inv_4_5_p10 + Lambda_inv_0_2_p2 *
      Lambda_inv_4_5_p9 - Lambda_inv_0_2_p3 * Lambda_inv_4_5_p8;
  const Real Lambda_inv_0_2_p5 = Lambda_inv_0_4_p79 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_2_p6 = Lambda_inv_0_4_p77 * Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_2_p7 = Lambda_inv_0_2_p1 * Lambda_inv_0_4_p66;
  const Real Lambda_inv_0_2_p8 = Lambda_inv_0_2_p1 * Lambda_inv_0_4_p100 + Lambda_inv_0_2_p2 *
      Lambda_inv_0_4_p99 - Lambda_inv_0_2_p3 * Lambda_inv_0_4_p91;
  const Real Lambda_inv_0_2_p9 = Lambda_inv_0_4_p95 * Lambda_inv_0_2_p7 + Lambda_inv_0_4_p97 *
      Lambda_inv_0_2_p6 - Lambda_inv_0_4_p98 * Lambda_inv_0_2_p5 + Lambda_inv_0_1_p5 *
      Lambda_inv_0_4 + Lambda_inv_0_2_p8 * Lambda_inv_0_4_p103;
  const Real Lambda_inv_0_2 = Lambda_inv_0_4_p104 * (Lambda_inv_0_2_p4 - Lambda_inv_0_3) +
      Lambda_inv_0_2_p9;
  Lambda_inv[2] = Lambda_inv_0_2;
  Lambda_inv[12] = Lambda_inv_0_2;
  const Real Lambda_inv_1_5 = Lambda_inv_0_1_p9 + Lambda_inv_5_5 * Lambda_inv_0_1_p5 -
      Lambda_inv_3_5 * Lambda_inv_0_4_p103;
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real Lambda_inv_1_1_p1 = Lambda_inv_0_1_p1 * Lambda_inv_0_1_p8 + Lambda_inv_0_1_p2 *
      Lambda_inv_0_1_p7 - Lambda_inv_0_1_p3 * Lambda_inv_0_1_p6 - Lambda_inv_0_1_p5 *
      (Lambda_inv_0_1_p9 + Lambda_inv_1_5);
  const Real Lambda_inv_1_3_p1 = Lambda_inv_0_1_p1 * Lambda_inv_0_3_p4 + Lambda_inv_0_1_p2 *
      Lambda_inv_0_3_p3 - Lambda_inv_0_1_p3 * Lambda_inv_0_3_p2;
  const Real Lambda_inv_3_3_p1 = Lambda_inv_3_4_p5 * (24999.999999999996 * Lambda_inv_3_4_p5) +
      Lambda_inv_3_4_p7 * (1557.24430048586 * Lambda_inv_3_4_p7) + Lambda_inv_3_4_p8 *
      (Lambda_inv_0_4_p46 * Lambda_inv_3_4_p8);
  const Real Lambda_inv_3_3 = Lambda_inv_3_3_p1 - Lambda_inv_3_4_p9 * Lambda_inv_0_3_p4 -
      Lambda_inv_3_4_p10 * Lambda_inv_0_3_p3 + Lambda_inv_3_4_p11 * Lambda_inv_0_3_p2;
  Lambda_inv[21] = Lambda_inv_3_3;
  const Real Lambda_inv_1_3 = Lambda_inv_1_3_p1 + Lambda_inv_3_5 * Lambda_inv_0_1_p5 -
      Lambda_inv_3_3 * Lambda_inv_0_4_p103;
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  Lambda_inv[7] = -(Lambda_inv_1_1_p1 + Lambda_inv_0_4_p103 * (Lambda_inv_1_3_p1 + Lambda_inv_1_3));
  const Real Lambda_inv_1_4_p1 = Lambda_inv_4_5 * Lambda_inv_0_1_p5;
  const Real Lambda_inv_1_4 = Lambda_inv_1_4_p1 - (Lambda_inv_0_1_p4 + Lambda_inv_0_3_p1);
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_1_2_p1 = Lambda_inv_0_2_p1 * Lambda_inv_0_3_p4 + Lambda_inv_0_2_p2 *
      Lambda_inv_0_3_p3 + Lambda_inv_0_2_p3 * Lambda_inv_0_3_p2;
  const Real Lambda_inv_1_2_p2 = Lambda_inv_0_1_p1 * Lambda_inv_0_2_p7 + Lambda_inv_0_1_p2 *
      Lambda_inv_0_2_p6 + Lambda_inv_0_1_p3 * Lambda_inv_0_2_p5 + Lambda_inv_0_4_p104 *
      Lambda_inv_1_3 + Lambda_inv_1_2_p1 * Lambda_inv_0_4_p103;
  const Real Lambda_inv_1_2 = Lambda_inv_0_1_p5 * (Lambda_inv_0_2_p4 + Lambda_inv_1_4) -
      Lambda_inv_1_2_p2;
  Lambda_inv[8] = -Lambda_inv_1_2;
  Lambda_inv[13] = -Lambda_inv_1_2;
  const Real Lambda_inv_2_3 = Lambda_inv_1_2_p1 - Lambda_inv_3_3 * Lambda_inv_0_4_p104 +
      Lambda_inv_3_4 * Lambda_inv_0_1_p5;
  Lambda_inv[15] = -Lambda_inv_2_3;
  Lambda_inv[20] = -Lambda_inv_2_3;
  const Real Lambda_inv_2_2_p1 = Lambda_inv_0_2_p1 * Lambda_inv_0_2_p7 + Lambda_inv_0_2_p2 *
      Lambda_inv_0_2_p6 - Lambda_inv_0_2_p3 * Lambda_inv_0_2_p5 + Lambda_inv_0_4_p104 *
      (Lambda_inv_1_2_p1 + Lambda_inv_2_3);
  const Real Lambda_inv_2_4 = Lambda_inv_0_2_p8 + Lambda_inv_3_4 * Lambda_inv_0_4_p104 -
      Lambda_inv_4_4 * Lambda_inv_0_1_p5;
  Lambda_inv[16] = Lambda_inv_2_4;
  Lambda_inv[26] = Lambda_inv_2_4;
  Lambda_inv[14] = -(Lambda_inv_2_2_p1 + Lambda_inv_0_1_p5 * (Lambda_inv_0_2_p8 + Lambda_inv_2_4));
  const Real Lambda_inv_2_5 = Lambda_inv_1_4_p1 + (Lambda_inv_0_2_p4 - Lambda_inv_0_3_p5);
  Lambda_inv[17] = -Lambda_inv_2_5;
  Lambda_inv[32] = -Lambda_inv_2_5;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
