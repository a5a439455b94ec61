// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J from poses, in the axes of link 1 (link1) at link origins.
// 602 flops (add 255, mul 343, div 4), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
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
  const Real angles[5] = {q[2], q[1], q[3], q[4], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real s2 = sines[1];
  const Real s3 = sines[0];
  const Real c2 = cosines[1];
  const Real s4 = sines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];
  const Real c4 = cosines[2];
  const Real s1 = sines[4];
  const Real c1 = cosines[4];

  // link 5 (link5), composite inertia
  const Real Lambda_inv_5_5_p1 = 0.00020215999999999998 * s5;

  // link 6 (link6), mass matrix
  const Real Lambda_inv_5_5_p2 = 4e-05 * c5;

  // link 5 (link5), composite inertia
  const Real Lambda_inv_5_5_p3 = 0.0028799999999999997 * s5;
  const Real Lambda_inv_5_5_p4 = 0.0028799999999999997 * c5;

  // link 6 (link6), mass matrix
  const Real Lambda_inv_5_5_p5 = 4e-05 * s5;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p6 = 0.9999999999999999 * c5;

  // link 5 (link5), composite inertia
  const Real Lambda_inv_5_5_p7 = s5 * Lambda_inv_5_5_p1;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p8 = c4 * Lambda_inv_5_5_p3;

  // link 5 (link5), composite inertia
  const Real Lambda_inv_5_5_p9 = c5 * Lambda_inv_5_5_p1;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p10 = c4 * Lambda_inv_5_5_p4;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p11 = s4 * Lambda_inv_5_5_p3;
  const Real Lambda_inv_5_5_p12 = 0.861795 + Lambda_inv_5_5_p4;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p13 = s4 * Lambda_inv_5_5_p4;

  // link 6 (link6), mass matrix
  const Real Lambda_inv_5_5_p14 = c4 * Lambda_inv_5_5_p5;

  // link 5 (link5), composite inertia
  const Real Lambda_inv_5_5_p15 = 0.00164 + Lambda_inv_5_5_p7;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p16 = 0.0203 * Lambda_inv_5_5_p8;

  // link 6 (link6), mass matrix
  const Real Lambda_inv_5_5_p17 = s4 * Lambda_inv_5_5_p5;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p18 = s4 * (0.00010000000000000026 + Lambda_inv_5_5_p7);
  const Real Lambda_inv_5_5_p19 = Lambda_inv_5_5_p8 - 0.025374999999999998;

  // link 4 (link4), mass matrix
  const Real Lambda_inv_5_5_p20 = s3 * Lambda_inv_5_5_p11;
  const Real Lambda_inv_5_5_p21 = c4 * Lambda_inv_5_5_p9 + 0.4331 * Lambda_inv_5_5_p8;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p22 = 1.0 / (Lambda_inv_5_5_p15 - Lambda_inv_5_5_p6 *
      Lambda_inv_5_5_p2);

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p23 = s4 * Lambda_inv_5_5_p9 + 0.4331 * Lambda_inv_5_5_p11;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p24 = 24999.999999999996 * Lambda_inv_5_5_p17;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p25 = s4 * Lambda_inv_5_5_p18;
  const Real Lambda_inv_5_5_p26 = 0.0067651125 + (Lambda_inv_5_5_p15 - 0.0406 * Lambda_inv_5_5_p8);

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p27 = s3 * Lambda_inv_5_5_p10 + c3 * Lambda_inv_5_5_p3;
  const Real Lambda_inv_5_5_p28 = 0.00064216 * c4 +
      (0.4331 * Lambda_inv_5_5_p10 - 5.846399999999999e-05 * s5);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p29 = Lambda_inv_5_5_p23 + Lambda_inv_5_5_p6 * Lambda_inv_5_5_p17;

  // link 4 (link4), mass matrix
  const Real Lambda_inv_5_5_p30 = 0.1501 * Lambda_inv_5_5_p11;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p31 = 0.0203 * Lambda_inv_5_5_p13;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p32 = Lambda_inv_5_5_p21 - 5.846399999999999e-05 * c5 -
      0.010673638499999999;

  // link 3 (link3), mass matrix
  const Real Lambda_inv_5_5_p33 = s3 * Lambda_inv_5_5_p12 + c3 * Lambda_inv_5_5_p19;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p34 = 1557.24430048586 * Lambda_inv_5_5_p28;

  // link 3 (link3), mass matrix
  const Real Lambda_inv_5_5_p35 = c3 * Lambda_inv_5_5_p12 - s3 * Lambda_inv_5_5_p19;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p36 = 0.0203 * Lambda_inv_5_5_p11 - c4 * Lambda_inv_5_5_p18;
  const Real Lambda_inv_5_5_p37 = 0.004704000000000001 + Lambda_inv_5_5_p23;

  // link 4 (link4), mass matrix
  const Real Lambda_inv_5_5_p38 = Lambda_inv_5_5_p16 - Lambda_inv_5_5_p15;

  // link 3 (link3), mass matrix
  const Real Lambda_inv_5_5_p39 = 0.4318 * Lambda_inv_5_5_p33;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p40 = 0.00064216 * s4 + 0.4331 * Lambda_inv_5_5_p13;
  const Real Lambda_inv_5_5_p41 = Lambda_inv_5_5_p28 + 0.4318 * Lambda_inv_5_5_p27;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p42 = 0.3056901365 + (0.0011921599999999998 - Lambda_inv_5_5_p7 +
      Lambda_inv_5_5_p25 + 0.0024946559999999996 * c5);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p43 = Lambda_inv_5_5_p29 * Lambda_inv_5_5_p22;
  const Real Lambda_inv_5_5_p44 = 0.312455249 + (0.00129216 - Lambda_inv_5_5_p25 + 2.0 *
      (0.0012473279999999998 * c5 - Lambda_inv_5_5_p16)) - Lambda_inv_5_5_p24 * Lambda_inv_5_5_p17;
  const Real Lambda_inv_5_5_p45 = Lambda_inv_5_5_p29 + 0.4318 * Lambda_inv_5_5_p20;

  // link 3 (link3), composite inertia
  const Real Lambda_inv_5_5_p46 = s3 * (Lambda_inv_5_5_p42 - Lambda_inv_5_5_p26) + c3 *
      (2.0 * Lambda_inv_5_5_p32);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p47 = 1557.24430048586 * Lambda_inv_5_5_p41;

  // link 3 (link3), composite inertia
  const Real Lambda_inv_5_5_p48 = s3 * Lambda_inv_5_5_p46;

  // link 3 (link3), mass matrix
  const Real Lambda_inv_5_5_p49 = c3 * Lambda_inv_5_5_p36 - s3 * Lambda_inv_5_5_p37 - 0.1501 *
      Lambda_inv_5_5_p33;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p50 = 1.0 / (Lambda_inv_5_5_p44 - Lambda_inv_5_5_p34 *
      Lambda_inv_5_5_p28 - Lambda_inv_5_5_p43 * Lambda_inv_5_5_p29);

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p51 = c3 * Lambda_inv_5_5_p31 - s3 * Lambda_inv_5_5_p40 +
      (0.1501 * (c3 * Lambda_inv_5_5_p10 - s3 * Lambda_inv_5_5_p3) - 0.4318 * Lambda_inv_5_5_p13);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p52 = Lambda_inv_5_5_p44 + Lambda_inv_5_5_p39 - Lambda_inv_5_5_p34 *
      Lambda_inv_5_5_p41 - Lambda_inv_5_5_p43 * Lambda_inv_5_5_p45;
  const Real Lambda_inv_5_5_p53 = Lambda_inv_5_5_p45 * Lambda_inv_5_5_p22;

  // link 3 (link3), mass matrix
  const Real Lambda_inv_5_5_p54 = s3 * Lambda_inv_5_5_p36 + c3 * Lambda_inv_5_5_p37 + 0.1501 *
      Lambda_inv_5_5_p35;

  // link 6 (link6), mass matrix
  const Real Lambda_inv_5_5_p55 = s2 * (c3 * Lambda_inv_5_5_p14 + s3 * Lambda_inv_5_5_p2) + c2 *
      (s3 * Lambda_inv_5_5_p14 - c3 * Lambda_inv_5_5_p2);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p56 = Lambda_inv_5_5_p24 * Lambda_inv_5_5_p55;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p57 = s2 * (c3 * Lambda_inv_5_5_p40 + s3 * Lambda_inv_5_5_p31 + 0.1501 *
      Lambda_inv_5_5_p27) - c2 * Lambda_inv_5_5_p51;

  // link 4 (link4), mass matrix
  const Real Lambda_inv_5_5_p58 = s2 * (0.1501 * Lambda_inv_5_5_p20 -
      (c3 * Lambda_inv_5_5_p21 + s3 * Lambda_inv_5_5_p38)) + c2 *
      ((Lambda_inv_5_5_p38 - Lambda_inv_5_5_p30) * c3 -
      (s3 * Lambda_inv_5_5_p21 + 0.4318 * Lambda_inv_5_5_p8));

  // link 3 (link3), composite inertia
  const Real Lambda_inv_5_5_p59 = 1.674987602 + (Lambda_inv_5_5_p26 + Lambda_inv_5_5_p48 + 2.0 *
      (Lambda_inv_5_5_p39 + Lambda_inv_5_5_p30));

  // link 5 (link5), pose
  const Real Lambda_inv_5_5_p60 = s5 * c4;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p61 = Lambda_inv_5_5_p6 * Lambda_inv_5_5_p55 - Lambda_inv_5_5_p58;

  // link 3 (link3), pose
  const Real Lambda_inv_5_5_p62 = c3 * s2 + s3 * c2;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p63 = Lambda_inv_5_5_p52 * Lambda_inv_5_5_p50;
  const Real Lambda_inv_5_5_p64 = 24999.999999999996 * Lambda_inv_5_5_p55;
  const Real Lambda_inv_5_5_p65 = 1557.24430048586 * Lambda_inv_5_5_p57;

  // link 5 (link5), pose
  const Real Lambda_inv_0_0_p1 = s5 * s4;

  // link 3 (link3), pose
  const Real Lambda_inv_5_5_p66 = s3 * s2 - c3 * c2;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p67 = Lambda_inv_5_5_p56 -
      (s2 * (Lambda_inv_5_5_p49 - 0.4318 * Lambda_inv_5_5_p11 - 0.690314699) + c2 *
      (Lambda_inv_5_5_p54 - 0.023750999999999998));
  const Real Lambda_inv_5_5_p68 = Lambda_inv_5_5_p61 * Lambda_inv_5_5_p22;

  // link 4 (link4), pose
  const Real Lambda_inv_5_5_p69 = s4 * Lambda_inv_5_5_p62;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p70 = Lambda_inv_5_5_p56 -
      (s2 * Lambda_inv_5_5_p49 + c2 * Lambda_inv_5_5_p54) - Lambda_inv_5_5_p34 *
      Lambda_inv_5_5_p57 + Lambda_inv_5_5_p43 * Lambda_inv_5_5_p61;
  const Real Lambda_inv_0_0_p2 = Lambda_inv_5_5_p6 * Lambda_inv_0_0_p1;
  const Real Lambda_inv_0_0_p3 = 24999.999999999996 * Lambda_inv_0_0_p1;

  // link 2 (link2), composite inertia
  const Real Lambda_inv_5_5_p71 = s2 * (0.07312640000000001 +
      (Lambda_inv_5_5_p42 - Lambda_inv_5_5_p48 + 0.3002 * Lambda_inv_5_5_p11) -
      Lambda_inv_5_5_p59) + c2 * (2.0 * (c3 * Lambda_inv_5_5_p46 - Lambda_inv_5_5_p32 + 0.4318 *
      Lambda_inv_5_5_p35 - 0.0070992));

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p72 = 1.7481140020000001 + Lambda_inv_5_5_p44 + 0.8636 *
      Lambda_inv_5_5_p33 - Lambda_inv_5_5_p47 * Lambda_inv_5_5_p41 - Lambda_inv_5_5_p53 *
      Lambda_inv_5_5_p45 - Lambda_inv_5_5_p63 * Lambda_inv_5_5_p52;

  // link 5 (link5), pose
  const Real Lambda_inv_5_5_p73 = Lambda_inv_5_5_p60 * Lambda_inv_5_5_p62 + c5 * Lambda_inv_5_5_p66;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p74 = Lambda_inv_5_5_p70 * Lambda_inv_5_5_p50;
  const Real Lambda_inv_0_0_p4 = 1.0 - Lambda_inv_5_5_p24 * Lambda_inv_0_0_p1;
  const Real Lambda_inv_5_5_p75 = 1557.24430048586 * Lambda_inv_5_5_p69;
  const Real Lambda_inv_5_5_p76 = 1.0 / Lambda_inv_5_5_p72;
  const Real Lambda_inv_5_5_p77 = Lambda_inv_5_5_p24 * Lambda_inv_5_5_p73;
  const Real Lambda_inv_5_5_p78 = Lambda_inv_5_5_p67 - Lambda_inv_5_5_p47 * Lambda_inv_5_5_p57 +
      Lambda_inv_5_5_p53 * Lambda_inv_5_5_p61 - Lambda_inv_5_5_p63 * Lambda_inv_5_5_p70;
  const Real Lambda_inv_5_5_p79 = 24999.999999999996 * Lambda_inv_5_5_p73;

  // link 4 (link4), pose
  const Real Lambda_inv_0_0_p5 = s4 * Lambda_inv_5_5_p66;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p6 = 1557.24430048586 * c4;
  const Real Lambda_inv_5_5_p80 = Lambda_inv_5_5_p6 * Lambda_inv_5_5_p73 - Lambda_inv_5_5_p66;
  const Real Lambda_inv_0_0_p7 = Lambda_inv_0_0_p4 - Lambda_inv_5_5_p34 * c4 - Lambda_inv_5_5_p43 *
      Lambda_inv_0_0_p2;

  // link 5 (link5), pose
  const Real Lambda_inv_0_0_p8 = c5 * Lambda_inv_5_5_p62 - Lambda_inv_5_5_p60 * Lambda_inv_5_5_p66;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p9 = Lambda_inv_5_5_p24 * Lambda_inv_0_0_p8;
  const Real Lambda_inv_5_5_p81 = Lambda_inv_5_5_p80 * Lambda_inv_5_5_p22;
  const Real Lambda_inv_0_0_p10 = Lambda_inv_0_0_p2 * Lambda_inv_5_5_p22;
  const Real Lambda_inv_5_5_p82 = Lambda_inv_5_5_p77 - Lambda_inv_5_5_p34 * Lambda_inv_5_5_p69 +
      Lambda_inv_5_5_p43 * Lambda_inv_5_5_p80;
  const Real Lambda_inv_0_0_p11 = Lambda_inv_0_0_p4 - Lambda_inv_5_5_p47 * c4 - Lambda_inv_5_5_p53 *
      Lambda_inv_0_0_p2 - Lambda_inv_5_5_p63 * Lambda_inv_0_0_p7;
  const Real Lambda_inv_0_0_p12 = Lambda_inv_5_5_p62 - Lambda_inv_5_5_p6 * Lambda_inv_0_0_p8;
  const Real Lambda_inv_5_5_p83 = Lambda_inv_5_5_p78 * Lambda_inv_5_5_p76;
  const Real Lambda_inv_5_5_p84 = 1.4717295504999999 +
      (Lambda_inv_5_5_p59 + s2 * Lambda_inv_5_5_p71) - Lambda_inv_5_5_p64 * Lambda_inv_5_5_p55 -
      Lambda_inv_5_5_p65 * Lambda_inv_5_5_p57 - Lambda_inv_5_5_p68 * Lambda_inv_5_5_p61;
  const Real Lambda_inv_5_5_p85 = Lambda_inv_5_5_p82 * Lambda_inv_5_5_p50;
  const Real Lambda_inv_5_5_p86 = Lambda_inv_5_5_p77 - Lambda_inv_5_5_p47 * Lambda_inv_5_5_p69 +
      Lambda_inv_5_5_p53 * Lambda_inv_5_5_p80 - Lambda_inv_5_5_p63 * Lambda_inv_5_5_p82;
  const Real Lambda_inv_5_5_p87 = 1.0 - Lambda_inv_5_5_p64 * Lambda_inv_5_5_p73 -
      Lambda_inv_5_5_p65 * Lambda_inv_5_5_p69 - Lambda_inv_5_5_p68 * Lambda_inv_5_5_p80 -
      Lambda_inv_5_5_p74 * Lambda_inv_5_5_p82;
  const Real Lambda_inv_0_0_p13 = Lambda_inv_5_5_p43 * Lambda_inv_0_0_p12 -
      (Lambda_inv_5_5_p34 * Lambda_inv_0_0_p5 + Lambda_inv_0_0_p9);

  // link 4 (link4), pose
  const Real Lambda_inv_0_0_p14 = 0.0203 * Lambda_inv_5_5_p62 - 0.4331 * Lambda_inv_5_5_p66;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p15 = Lambda_inv_0_0_p7 * Lambda_inv_5_5_p50;
  const Real Lambda_inv_0_0_p16 = Lambda_inv_0_0_p13 * Lambda_inv_5_5_p50;
  const Real Lambda_inv_5_5_p88 = 1.0 / (Lambda_inv_5_5_p84 - Lambda_inv_5_5_p74 *
      Lambda_inv_5_5_p70 - Lambda_inv_5_5_p83 * Lambda_inv_5_5_p78);
  const Real Lambda_inv_5_5_p89 = Lambda_inv_5_5_p86 * Lambda_inv_5_5_p76;
  const Real Lambda_inv_0_0_p17 = Lambda_inv_5_5_p64 * Lambda_inv_0_0_p1 - Lambda_inv_5_5_p65 * c4 +
      Lambda_inv_5_5_p68 * Lambda_inv_0_0_p2 - Lambda_inv_5_5_p74 * Lambda_inv_0_0_p7 -
      Lambda_inv_5_5_p83 * Lambda_inv_0_0_p11;
  const Real Lambda_inv_5_5_p90 = Lambda_inv_5_5_p87 - Lambda_inv_5_5_p83 * Lambda_inv_5_5_p86;
  const Real Lambda_inv_0_0_p18 = Lambda_inv_0_0_p11 * Lambda_inv_5_5_p76;
  const Real Lambda_inv_0_0_p19 = Lambda_inv_5_5_p53 * Lambda_inv_0_0_p12 -
      (Lambda_inv_5_5_p47 * Lambda_inv_0_0_p5 + Lambda_inv_0_0_p9) - Lambda_inv_5_5_p63 *
      Lambda_inv_0_0_p13;
  const Real Lambda_inv_0_0_p20 = Lambda_inv_0_0_p19 * Lambda_inv_5_5_p76;
  const Real Lambda_inv_0_0_p21 = 24999.999999999996 * Lambda_inv_0_0_p8 * Lambda_inv_0_0_p8 +
      1557.24430048586 * Lambda_inv_0_0_p5 * Lambda_inv_0_0_p5 + Lambda_inv_0_0_p12 *
      Lambda_inv_5_5_p22 * Lambda_inv_0_0_p12;
  const Real Lambda_inv_0_0_p22 = (1.0 - Lambda_inv_5_5_p63) * Lambda_inv_0_0_p14 - 0.4318 * s2;
  const Real Lambda_inv_0_0_p23 = Lambda_inv_5_5_p64 * Lambda_inv_0_0_p8 - Lambda_inv_5_5_p65 *
      Lambda_inv_0_0_p5 - Lambda_inv_5_5_p68 * Lambda_inv_0_0_p12 - Lambda_inv_5_5_p74 *
      Lambda_inv_0_0_p13 - Lambda_inv_5_5_p83 * Lambda_inv_0_0_p19;
  const Real Lambda_inv_5_5_p91 = Lambda_inv_5_5_p79 * Lambda_inv_5_5_p73 + Lambda_inv_5_5_p75 *
      Lambda_inv_5_5_p69 + Lambda_inv_5_5_p81 * Lambda_inv_5_5_p80 + Lambda_inv_5_5_p85 *
      Lambda_inv_5_5_p82 + Lambda_inv_5_5_p89 * Lambda_inv_5_5_p86;
  const Real Lambda_inv_0_0_p24 = Lambda_inv_5_5_p75 * c4 - Lambda_inv_5_5_p79 * Lambda_inv_0_0_p1 -
      Lambda_inv_5_5_p81 * Lambda_inv_0_0_p2 + Lambda_inv_5_5_p85 * Lambda_inv_0_0_p7 +
      Lambda_inv_5_5_p89 * Lambda_inv_0_0_p11;
  const Real Lambda_inv_0_0_p25 = Lambda_inv_0_0_p3 * Lambda_inv_0_0_p1 + Lambda_inv_0_0_p6 * c4 +
      Lambda_inv_0_0_p10 * Lambda_inv_0_0_p2 + Lambda_inv_0_0_p15 * Lambda_inv_0_0_p7 +
      Lambda_inv_0_0_p18 * Lambda_inv_0_0_p11;
  const Real Lambda_inv_0_0_p26 = Lambda_inv_5_5_p81 * Lambda_inv_0_0_p12 -
      (Lambda_inv_5_5_p79 * Lambda_inv_0_0_p8 - Lambda_inv_5_5_p75 * Lambda_inv_0_0_p5) +
      Lambda_inv_5_5_p85 * Lambda_inv_0_0_p13 + Lambda_inv_5_5_p89 * Lambda_inv_0_0_p19;
  const Real Lambda_inv_0_0_p27 = 0.05625 * Lambda_inv_0_0_p1;
  const Real Lambda_inv_0_0_p28 = 0.05625 * Lambda_inv_5_5_p73;
  const Real Lambda_inv_0_0_p29 = 0.05625 * Lambda_inv_0_0_p8;
  const Real Lambda_inv_5_5_p92 = Lambda_inv_5_5_p90 * Lambda_inv_5_5_p88;
  const Real Lambda_inv_0_0_p30 = Lambda_inv_0_0_p17 * Lambda_inv_5_5_p88;
  const Real Lambda_inv_0_0_p31 = Lambda_inv_0_0_p23 * Lambda_inv_5_5_p88;

  // link 4 (link4), pose
  const Real Lambda_inv_0_2_p1 = 0.4331 * Lambda_inv_5_5_p62 + 0.0203 * Lambda_inv_5_5_p66;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p32 = 0.1501 + Lambda_inv_5_5_p74 * Lambda_inv_0_0_p14 +
      Lambda_inv_5_5_p83 * Lambda_inv_0_0_p22;

  // link 3 (link3), Jacobian
  const Real Lambda_inv_0_0_p33 = Lambda_inv_0_2_p1 + 0.4318 * c2;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p34 = Lambda_inv_0_0_p3 * Lambda_inv_0_0_p8 + Lambda_inv_0_0_p6 *
      Lambda_inv_0_0_p5 - Lambda_inv_0_0_p10 * Lambda_inv_0_0_p12 + Lambda_inv_0_0_p15 *
      Lambda_inv_0_0_p13 + Lambda_inv_0_0_p18 * Lambda_inv_0_0_p19;
  const Real Lambda_inv_5_5 = Lambda_inv_5_5_p91 + Lambda_inv_5_5_p92 * Lambda_inv_5_5_p90;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real Lambda_inv_0_0_p35 = Lambda_inv_0_0_p24 + Lambda_inv_5_5_p92 * Lambda_inv_0_0_p17;
  const Real Lambda_inv_0_0_p36 = Lambda_inv_0_0_p25 + Lambda_inv_0_0_p30 * Lambda_inv_0_0_p17;
  const Real Lambda_inv_0_0_p37 = Lambda_inv_0_0_p21 + Lambda_inv_0_0_p16 * Lambda_inv_0_0_p13 +
      Lambda_inv_0_0_p20 * Lambda_inv_0_0_p19 + Lambda_inv_0_0_p31 * Lambda_inv_0_0_p23;
  const Real Lambda_inv_0_0_p38 = Lambda_inv_0_0_p26 + Lambda_inv_5_5_p92 * Lambda_inv_0_0_p23;
  const Real Lambda_inv_0_0_p39 = Lambda_inv_0_0_p31 * Lambda_inv_0_0_p33;
  const Real Lambda_inv_0_0_p40 = Lambda_inv_5_5_p92 * Lambda_inv_0_0_p33;
  const Real Lambda_inv_0_0_p41 = Lambda_inv_0_0_p34 + Lambda_inv_0_0_p30 * Lambda_inv_0_0_p23;
  const Real Lambda_inv_0_2_p2 = Lambda_inv_5_5_p63 * Lambda_inv_0_2_p1 - Lambda_inv_0_0_p33;
  const Real Lambda_inv_0_0_p42 = Lambda_inv_5_5_p85 * Lambda_inv_0_0_p14 + Lambda_inv_5_5_p89 *
      Lambda_inv_0_0_p22 - Lambda_inv_5_5_p92 * Lambda_inv_0_0_p32;
  const Real Lambda_inv_0_0_p43 = Lambda_inv_0_0_p15 * Lambda_inv_0_0_p14 + Lambda_inv_0_0_p18 *
      Lambda_inv_0_0_p22 - Lambda_inv_0_0_p30 * Lambda_inv_0_0_p32;
  const Real Lambda_inv_0_0_p44 = Lambda_inv_0_0_p38 * Lambda_inv_0_0_p27;
  const Real Lambda_inv_0_0_p45 = Lambda_inv_0_0_p41 * Lambda_inv_0_0_p28;
  const Real Lambda_inv_0_0_p46 = Lambda_inv_0_0_p33 * Lambda_inv_5_5_p88;
  const Real Lambda_inv_0_2_p3 = Lambda_inv_0_2_p2 * Lambda_inv_5_5_p76;
  const Real Lambda_inv_0_2_p4 = Lambda_inv_0_2_p1 * Lambda_inv_5_5_p50;
  const Real Lambda_inv_0_2_p5 = Lambda_inv_5_5_p74 * Lambda_inv_0_2_p1 - Lambda_inv_5_5_p83 *
      Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_0_p47 = Lambda_inv_0_0_p30 * Lambda_inv_0_0_p33;
  const Real Lambda_inv_0_0_p48 = Lambda_inv_0_0_p42 -
      (Lambda_inv_5_5 * Lambda_inv_0_0_p27 + Lambda_inv_0_0_p35 * Lambda_inv_0_0_p28);
  const Real Lambda_inv_0_0_p49 = Lambda_inv_0_0_p43 -
      (Lambda_inv_0_0_p35 * Lambda_inv_0_0_p27 + Lambda_inv_0_0_p36 * Lambda_inv_0_0_p28);
  const Real Lambda_inv_0_0_p50 = Lambda_inv_0_0_p39 +
      (Lambda_inv_0_0_p37 * Lambda_inv_0_0_p28 + Lambda_inv_0_0_p38 * Lambda_inv_0_0_p29);
  const Real Lambda_inv_0_0_p51 = Lambda_inv_0_0_p40 +
      (Lambda_inv_0_0_p38 * Lambda_inv_0_0_p28 + Lambda_inv_5_5 * Lambda_inv_0_0_p29);
  const Real Lambda_inv_0_0_p52 = Lambda_inv_0_0_p16 * Lambda_inv_0_0_p14 + Lambda_inv_0_0_p20 *
      Lambda_inv_0_0_p22 - Lambda_inv_0_0_p31 * Lambda_inv_0_0_p32 -
      (Lambda_inv_0_0_p44 + Lambda_inv_0_0_p45);
  const Real Lambda_inv_0_2_p6 = Lambda_inv_0_2_p5 * Lambda_inv_5_5_p88;
  const Real Lambda_inv_0_2_p7 = Lambda_inv_0_0_p35 * Lambda_inv_0_0_p29;
  const Real Lambda_inv_0_0_p53 = Lambda_inv_0_0_p14 * Lambda_inv_5_5_p50 * Lambda_inv_0_0_p14 +
      Lambda_inv_0_0_p22 * Lambda_inv_5_5_p76 * Lambda_inv_0_0_p22 + Lambda_inv_0_0_p32 *
      Lambda_inv_5_5_p88 * Lambda_inv_0_0_p32;
  const Real Lambda_inv_0_2_p8 = Lambda_inv_0_0_p18 * Lambda_inv_0_2_p2 - Lambda_inv_0_0_p15 *
      Lambda_inv_0_2_p1 + Lambda_inv_0_0_p30 * Lambda_inv_0_2_p5;
  const Real Lambda_inv_0_2_p9 = Lambda_inv_5_5_p89 * Lambda_inv_0_2_p2 - Lambda_inv_5_5_p85 *
      Lambda_inv_0_2_p1 + Lambda_inv_5_5_p92 * Lambda_inv_0_2_p5;
  const Real Lambda_inv_0_2_p10 = Lambda_inv_0_0_p20 * Lambda_inv_0_2_p2 - Lambda_inv_0_0_p16 *
      Lambda_inv_0_2_p1 + Lambda_inv_0_0_p31 * Lambda_inv_0_2_p5;
  const Real Lambda_inv_0_0_p54 = Lambda_inv_0_0_p53 -
      (Lambda_inv_0_0_p27 * (Lambda_inv_0_0_p42 + Lambda_inv_0_0_p48) + Lambda_inv_0_0_p28 *
      (Lambda_inv_0_0_p43 + Lambda_inv_0_0_p49));
  const Real Lambda_inv_0_2_p11 = Lambda_inv_0_0_p47 + (Lambda_inv_0_0_p45 + Lambda_inv_0_2_p7);
  const Real Lambda_inv_0_0_p55 = Lambda_inv_0_0_p46 * Lambda_inv_0_0_p33 +
      (Lambda_inv_0_0_p28 * (Lambda_inv_0_0_p39 + Lambda_inv_0_0_p50) + Lambda_inv_0_0_p29 *
      (Lambda_inv_0_0_p40 + Lambda_inv_0_0_p51));

  // link 1 (link1), turn
  const Real Lambda_inv_0_0_p56 = 2.0 * c1;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_0_p57 = Lambda_inv_0_0_p46 * Lambda_inv_0_0_p32 + Lambda_inv_0_0_p27 *
      Lambda_inv_0_0_p40 - Lambda_inv_0_0_p29 * Lambda_inv_0_0_p48 +
      (Lambda_inv_0_0_p47 - Lambda_inv_0_0_p52) * Lambda_inv_0_0_p28;
  const Real Lambda_inv_2_2_p1 = Lambda_inv_0_2_p8 -
      (Lambda_inv_0_0_p36 * Lambda_inv_0_0_p29 - Lambda_inv_0_0_p41 * Lambda_inv_0_0_p27);
  const Real Lambda_inv_2_2_p2 = Lambda_inv_0_2_p10 -
      (Lambda_inv_0_0_p41 * Lambda_inv_0_0_p29 - Lambda_inv_0_0_p37 * Lambda_inv_0_0_p27);
  const Real Lambda_inv_0_2_p12 = Lambda_inv_0_2_p3 * Lambda_inv_0_0_p22 - Lambda_inv_0_2_p4 *
      Lambda_inv_0_0_p14 - Lambda_inv_0_2_p6 * Lambda_inv_0_0_p32 - Lambda_inv_0_0_p28 *
      Lambda_inv_0_2_p8 - Lambda_inv_0_0_p29 * Lambda_inv_0_0_p49;
  const Real Lambda_inv_0_2_p13 = Lambda_inv_0_2_p12 + (Lambda_inv_0_0_p52 - Lambda_inv_0_2_p9) *
      Lambda_inv_0_0_p27;
  const Real Lambda_inv_0_2_p14 = Lambda_inv_0_2_p6 * Lambda_inv_0_0_p33 + Lambda_inv_0_0_p27 *
      Lambda_inv_0_0_p50 + Lambda_inv_0_0_p28 * Lambda_inv_0_2_p10 +
      (Lambda_inv_0_2_p9 - Lambda_inv_0_2_p11) * Lambda_inv_0_0_p29;

  // link 1 (link1), turn
  const Real Lambda_inv_0_3_p1 = s1 * (Lambda_inv_0_0_p52 - Lambda_inv_0_2_p11) + c1 *
      (Lambda_inv_0_0_p50 + Lambda_inv_0_0_p49);
  const Real Lambda_inv_0_0_p58 = s1 * (Lambda_inv_0_0_p54 - Lambda_inv_0_0_p55) -
      Lambda_inv_0_0_p56 * Lambda_inv_0_0_p57;
  const Real Lambda_inv_3_3_p1 = s1 * (Lambda_inv_0_0_p37 - Lambda_inv_0_0_p36) +
      Lambda_inv_0_0_p56 * Lambda_inv_0_0_p41;
  const Real Lambda_inv_0_3_p2 = s1 * Lambda_inv_0_3_p1;
  const Real Lambda_inv_0_4_p1 = c1 * Lambda_inv_0_3_p1;
  const Real Lambda_inv_0_0_p59 = s1 * Lambda_inv_0_0_p58;
  const Real Lambda_inv_3_3_p2 = s1 * Lambda_inv_3_3_p1;
  const Real Lambda_inv_0_2 = c1 * Lambda_inv_0_2_p13 - s1 * Lambda_inv_0_2_p14;
  Lambda_inv[2] = Lambda_inv_0_2;
  Lambda_inv[12] = Lambda_inv_0_2;
  const Real Lambda_inv_0_3 = Lambda_inv_0_0_p52 - Lambda_inv_0_3_p2;
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;
  const Real Lambda_inv_0_4 = Lambda_inv_0_4_p1 - Lambda_inv_0_0_p50;
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[24] = Lambda_inv_0_4;
  const Real Lambda_inv_0_5 = c1 * Lambda_inv_0_0_p48 - s1 * Lambda_inv_0_0_p51;
  Lambda_inv[5] = Lambda_inv_0_5;
  Lambda_inv[30] = Lambda_inv_0_5;
  Lambda_inv[0] = Lambda_inv_0_0_p54 - Lambda_inv_0_0_p59;
  const Real Lambda_inv_0_1 = c1 * Lambda_inv_0_0_p58 + Lambda_inv_0_0_p57;
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;
  Lambda_inv[7] = Lambda_inv_0_0_p55 + Lambda_inv_0_0_p59;
  const Real Lambda_inv_1_2 = s1 * Lambda_inv_0_2_p13 + c1 * Lambda_inv_0_2_p14;
  Lambda_inv[8] = Lambda_inv_1_2;
  Lambda_inv[13] = Lambda_inv_1_2;
  const Real Lambda_inv_1_3 = Lambda_inv_0_4_p1 - Lambda_inv_0_0_p49;
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  const Real Lambda_inv_1_4 = Lambda_inv_0_2_p11 + Lambda_inv_0_3_p2;
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_1_5 = s1 * Lambda_inv_0_0_p48 + c1 * Lambda_inv_0_0_p51;
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;

  // link 1 (link1), mass matrix
  Lambda_inv[14] = Lambda_inv_0_2_p4 * Lambda_inv_0_2_p1 + Lambda_inv_0_2_p3 * Lambda_inv_0_2_p2 +
      Lambda_inv_0_2_p6 * Lambda_inv_0_2_p5 - (Lambda_inv_0_0_p29 *
      (Lambda_inv_0_2_p8 + Lambda_inv_2_2_p1) - Lambda_inv_0_0_p27 *
      (Lambda_inv_0_2_p10 + Lambda_inv_2_2_p2));

  // link 1 (link1), turn
  const Real Lambda_inv_2_3 = c1 * Lambda_inv_2_2_p2 - s1 * Lambda_inv_2_2_p1;
  Lambda_inv[15] = Lambda_inv_2_3;
  Lambda_inv[20] = Lambda_inv_2_3;
  const Real Lambda_inv_2_4 = s1 * Lambda_inv_2_2_p2 + c1 * Lambda_inv_2_2_p1;
  Lambda_inv[16] = Lambda_inv_2_4;
  Lambda_inv[26] = Lambda_inv_2_4;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_2_5 = Lambda_inv_0_2_p9 - (Lambda_inv_0_2_p7 - Lambda_inv_0_0_p44);
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;

  // link 1 (link1), turn
  Lambda_inv[21] = Lambda_inv_0_0_p37 - Lambda_inv_3_3_p2;
  const Real Lambda_inv_3_4 = c1 * Lambda_inv_3_3_p1 - Lambda_inv_0_0_p41;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;
  const Real Lambda_inv_3_5 = c1 * Lambda_inv_0_0_p38 - s1 * Lambda_inv_0_0_p35;
  Lambda_inv[23] = Lambda_inv_3_5;
  Lambda_inv[33] = Lambda_inv_3_5;
  Lambda_inv[28] = Lambda_inv_0_0_p36 + Lambda_inv_3_3_p2;
  const Real Lambda_inv_4_5 = s1 * Lambda_inv_0_0_p38 + c1 * Lambda_inv_0_0_p35;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
