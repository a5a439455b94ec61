// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J carried inward, in the axes asked for at link origins.
// 566 flops (add 232, mul 330, div 4), sine and cosine of 5 angles
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
  const Real Lambda_inv_5_5_p1 = 0.0028799999999999997 * s5;
  const Real Lambda_inv_5_5_p2 = 0.0028799999999999997 * c5;
  const Real Lambda_inv_5_5_p3 = 0.00020215999999999998 * s5;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p4 = 0.9999999999999999 * c5;

  // link 6 (link6), mass matrix
  const Real Lambda_inv_5_5_p5 = 4e-05 * c5;
  const Real Lambda_inv_5_5_p6 = 4e-05 * s5;
  const Real Lambda_inv_5_5_p7 = 0.4318 * c2;
  const Real Lambda_inv_5_5_p8 = 0.4318 * s2;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p9 = c4 * Lambda_inv_5_5_p1;
  const Real Lambda_inv_5_5_p10 = s2 * s3 - c2 * c3;
  const Real Lambda_inv_5_5_p11 = s4 * Lambda_inv_5_5_p1;
  const Real Lambda_inv_5_5_p12 = s2 * c3 + c2 * s3;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p13 = c4 * Lambda_inv_5_5_p2;

  // link 5 (link5), composite inertia
  const Real Lambda_inv_5_5_p14 = s5 * Lambda_inv_5_5_p3;
  const Real Lambda_inv_5_5_p15 = c5 * Lambda_inv_5_5_p3;

  // link 6 (link6), mass matrix
  const Real Lambda_inv_5_5_p16 = s4 * Lambda_inv_5_5_p6;

  // link 5 (link5), composite inertia
  const Real Lambda_inv_5_5_p17 = 0.00164 + Lambda_inv_5_5_p14;

  // link 4 (link4), mass matrix
  const Real Lambda_inv_5_5_p18 = Lambda_inv_5_5_p10 * Lambda_inv_5_5_p11;
  const Real Lambda_inv_5_5_p19 = Lambda_inv_5_5_p12 * Lambda_inv_5_5_p11;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p20 = s4 * Lambda_inv_5_5_p15;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p21 = 24999.999999999996 * Lambda_inv_5_5_p16;
  const Real Lambda_inv_5_5_p22 = 0.0203 * Lambda_inv_5_5_p10 + 0.4331 * Lambda_inv_5_5_p12;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p23 = Lambda_inv_5_5_p10 * Lambda_inv_5_5_p9 - Lambda_inv_5_5_p12 *
      Lambda_inv_5_5_p2;
  const Real Lambda_inv_5_5_p24 = 0.0203 * Lambda_inv_5_5_p12 - 0.4331 * Lambda_inv_5_5_p10;
  const Real Lambda_inv_5_5_p25 = Lambda_inv_5_5_p12 * Lambda_inv_5_5_p9 + Lambda_inv_5_5_p10 *
      Lambda_inv_5_5_p2;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p26 = Lambda_inv_5_5_p10 * Lambda_inv_5_5_p1 - Lambda_inv_5_5_p12 *
      Lambda_inv_5_5_p13;
  const Real Lambda_inv_5_5_p27 = Lambda_inv_5_5_p10 * Lambda_inv_5_5_p13 + Lambda_inv_5_5_p12 *
      Lambda_inv_5_5_p1;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p28 = s4 * (0.00010000000000000026 + Lambda_inv_5_5_p14);
  const Real Lambda_inv_5_5_p29 = Lambda_inv_5_5_p22 * Lambda_inv_5_5_p23;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p30 = 1.0 / (Lambda_inv_5_5_p17 - Lambda_inv_5_5_p4 *
      Lambda_inv_5_5_p5);

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p31 = s4 * Lambda_inv_5_5_p28;
  const Real Lambda_inv_5_5_p32 = Lambda_inv_5_5_p12 * c4;
  const Real Lambda_inv_5_5_p33 = c4 * Lambda_inv_5_5_p15;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p34 = Lambda_inv_5_5_p12 * s4;

  // link 4 (link4), composite inertia
  const Real Lambda_inv_5_5_p35 = 0.025374999999999998 * Lambda_inv_5_5_p12 - 0.861795 *
      Lambda_inv_5_5_p10 - Lambda_inv_5_5_p25;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p36 = 0.00064216 * c4 -
      (Lambda_inv_5_5_p22 * Lambda_inv_5_5_p26 + Lambda_inv_5_5_p24 * Lambda_inv_5_5_p27);

  // link 3 (link3), composite inertia
  const Real Lambda_inv_5_5_p37 = Lambda_inv_5_5_p7 *
      (Lambda_inv_5_5_p23 - (0.025374999999999998 * Lambda_inv_5_5_p10 + 0.861795 *
      Lambda_inv_5_5_p12));

  // link 3 (link3), Jacobian
  const Real Lambda_inv_5_5_p38 = Lambda_inv_5_5_p22 + Lambda_inv_5_5_p7;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p39 = Lambda_inv_5_5_p24 * Lambda_inv_5_5_p18 - Lambda_inv_5_5_p22 *
      Lambda_inv_5_5_p19 - Lambda_inv_5_5_p20 - Lambda_inv_5_5_p4 * Lambda_inv_5_5_p16;
  const Real Lambda_inv_5_5_p40 = 1557.24430048586 * Lambda_inv_5_5_p36;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p41 = Lambda_inv_5_5_p36 +
      (Lambda_inv_5_5_p8 * Lambda_inv_5_5_p27 - Lambda_inv_5_5_p7 * Lambda_inv_5_5_p26);

  // link 6 (link6), mass matrix
  const Real Lambda_inv_5_5_p42 = Lambda_inv_5_5_p32 * Lambda_inv_5_5_p6 + Lambda_inv_5_5_p10 *
      Lambda_inv_5_5_p5;

  // link 3 (link3), composite inertia
  const Real Lambda_inv_5_5_p43 = Lambda_inv_5_5_p37 + Lambda_inv_5_5_p8 * Lambda_inv_5_5_p35;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p44 = Lambda_inv_5_5_p39 * Lambda_inv_5_5_p30;
  const Real Lambda_inv_5_5_p45 = 1557.24430048586 * Lambda_inv_5_5_p41;
  const Real Lambda_inv_5_5_p46 = Lambda_inv_5_5_p39 - Lambda_inv_5_5_p7 * Lambda_inv_5_5_p19 -
      Lambda_inv_5_5_p8 * Lambda_inv_5_5_p18;

  // link 3 (link3), mass matrix
  const Real Lambda_inv_5_5_p47 = Lambda_inv_5_5_p32 * Lambda_inv_5_5_p28 - Lambda_inv_5_5_p24 *
      Lambda_inv_5_5_p11 + (0.004704000000000001 + Lambda_inv_5_5_p20) * Lambda_inv_5_5_p10 -
      0.1501 * Lambda_inv_5_5_p35;

  // link 5 (link5), mass matrix
  const Real Lambda_inv_5_5_p48 = 0.00064216 * Lambda_inv_5_5_p34 + 0.1501 * Lambda_inv_5_5_p27 +
      Lambda_inv_5_5_p38 * (s4 * Lambda_inv_5_5_p2);

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p49 = 0.312455249 + (0.00129216 - Lambda_inv_5_5_p31 - 2.0 *
      (Lambda_inv_5_5_p29 + Lambda_inv_5_5_p24 * Lambda_inv_5_5_p25)) - Lambda_inv_5_5_p21 *
      Lambda_inv_5_5_p16;
  const Real Lambda_inv_5_5_p50 = Lambda_inv_5_5_p46 * Lambda_inv_5_5_p30;

  // link 4 (link4), pose
  const Real Lambda_inv_4_4_p1 = Lambda_inv_5_5_p10 * s1;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p51 = 24999.999999999996 * Lambda_inv_5_5_p42;
  const Real Lambda_inv_5_5_p52 = Lambda_inv_5_5_p47 + Lambda_inv_5_5_p21 * Lambda_inv_5_5_p42;
  const Real Lambda_inv_5_5_p53 = Lambda_inv_5_5_p12 * Lambda_inv_5_5_p33 - Lambda_inv_5_5_p10 *
      Lambda_inv_5_5_p17 - 0.1501 * Lambda_inv_5_5_p18 + Lambda_inv_5_5_p4 * Lambda_inv_5_5_p42 +
      Lambda_inv_5_5_p38 * Lambda_inv_5_5_p9;
  const Real Lambda_inv_5_5_p54 = 1557.24430048586 * Lambda_inv_5_5_p48;

  // link 4 (link4), pose
  const Real Lambda_inv_4_4_p2 = Lambda_inv_5_5_p12 * s1;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p55 = Lambda_inv_5_5_p53 * Lambda_inv_5_5_p30;
  const Real Lambda_inv_5_5_p56 = 1.0 / (Lambda_inv_5_5_p49 - Lambda_inv_5_5_p40 *
      Lambda_inv_5_5_p36 - Lambda_inv_5_5_p44 * Lambda_inv_5_5_p39);
  const Real Lambda_inv_5_5_p57 = Lambda_inv_5_5_p49 - Lambda_inv_5_5_p43 - Lambda_inv_5_5_p40 *
      Lambda_inv_5_5_p41 - Lambda_inv_5_5_p44 * Lambda_inv_5_5_p46;
  const Real Lambda_inv_5_5_p58 = Lambda_inv_5_5_p52 - Lambda_inv_5_5_p40 * Lambda_inv_5_5_p48 -
      Lambda_inv_5_5_p44 * Lambda_inv_5_5_p53;
  const Real Lambda_inv_5_5_p59 = 0.690314699 * s2 + 0.023750999999999998 * c2 +
      Lambda_inv_5_5_p52 + Lambda_inv_5_5_p8 * Lambda_inv_5_5_p11 - Lambda_inv_5_5_p45 *
      Lambda_inv_5_5_p48;

  // link 5 (link5), pose
  const Real Lambda_inv_5_5_p60 = s5 * Lambda_inv_5_5_p32 + c5 * Lambda_inv_5_5_p10;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p61 = 3.153482265 - s2 * (1.601861202 * s2 + 0.0141984 * c2) +
      Lambda_inv_5_5_p17 - Lambda_inv_5_5_p51 * Lambda_inv_5_5_p42;
  const Real Lambda_inv_5_5_p62 = Lambda_inv_5_5_p21 * Lambda_inv_5_5_p60;

  // link 5 (link5), pose
  const Real Lambda_inv_4_4_p3 = s5 * (s4 * c1 - c4 * Lambda_inv_4_4_p1) + c5 * Lambda_inv_4_4_p2;

  // link 4 (link4), pose
  const Real Lambda_inv_4_4_p4 = s4 * Lambda_inv_4_4_p1 + c4 * c1;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p63 = 24999.999999999996 * Lambda_inv_5_5_p60;
  const Real Lambda_inv_5_5_p64 = 1557.24430048586 * Lambda_inv_5_5_p34;

  // link 3 (link3), Jacobian
  const Real Lambda_inv_0_0_p1 = Lambda_inv_5_5_p24 * c1;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p65 = Lambda_inv_5_5_p4 * Lambda_inv_5_5_p60 - Lambda_inv_5_5_p10;

  // link 3 (link3), Jacobian
  const Real Lambda_inv_0_0_p2 = Lambda_inv_5_5_p24 - Lambda_inv_5_5_p8;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p66 = Lambda_inv_5_5_p57 * Lambda_inv_5_5_p56;
  const Real Lambda_inv_5_5_p67 = Lambda_inv_5_5_p58 * Lambda_inv_5_5_p56;
  const Real Lambda_inv_5_5_p68 = 0.298925024 * Lambda_inv_5_5_p12 + 0.021347276999999998 *
      Lambda_inv_5_5_p10 - (Lambda_inv_5_5_p10 * (2.0 * Lambda_inv_5_5_p33) - Lambda_inv_5_5_p12 *
      (0.0011921599999999998 - Lambda_inv_5_5_p14 + Lambda_inv_5_5_p31 - Lambda_inv_5_5_p17));
  const Real Lambda_inv_4_4_p5 = Lambda_inv_4_4_p2 - Lambda_inv_5_5_p4 * Lambda_inv_4_4_p3;
  const Real Lambda_inv_4_4_p6 = c1 - Lambda_inv_5_5_p21 * Lambda_inv_4_4_p3;
  const Real Lambda_inv_4_4_p7 = 24999.999999999996 * Lambda_inv_4_4_p3;
  const Real Lambda_inv_4_4_p8 = 1557.24430048586 * Lambda_inv_4_4_p4;
  const Real Lambda_inv_5_5_p69 = Lambda_inv_5_5_p65 * Lambda_inv_5_5_p30;
  const Real Lambda_inv_5_5_p70 = Lambda_inv_5_5_p62 - Lambda_inv_5_5_p40 * Lambda_inv_5_5_p34 -
      Lambda_inv_5_5_p44 * Lambda_inv_5_5_p65;
  const Real Lambda_inv_4_4_p9 = Lambda_inv_4_4_p5 * Lambda_inv_5_5_p30;
  const Real Lambda_inv_5_5_p71 = 1.7481140020000001 + Lambda_inv_5_5_p49 - 2.0 *
      Lambda_inv_5_5_p43 - Lambda_inv_5_5_p45 * Lambda_inv_5_5_p41 - Lambda_inv_5_5_p50 *
      Lambda_inv_5_5_p46 - Lambda_inv_5_5_p66 * Lambda_inv_5_5_p57;
  const Real Lambda_inv_5_5_p72 = Lambda_inv_5_5_p59 - Lambda_inv_5_5_p50 * Lambda_inv_5_5_p53 -
      Lambda_inv_5_5_p66 * Lambda_inv_5_5_p58;

  // link 4 (link4), pose
  const Real Lambda_inv_3_3_p1 = Lambda_inv_5_5_p10 * c1;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_4_4_p10 = Lambda_inv_4_4_p6 - Lambda_inv_5_5_p40 * Lambda_inv_4_4_p4 -
      Lambda_inv_5_5_p44 * Lambda_inv_4_4_p5;

  // link 4 (link4), pose
  const Real Lambda_inv_3_3_p2 = Lambda_inv_5_5_p12 * c1;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p73 = 1.0 / Lambda_inv_5_5_p71;
  const Real Lambda_inv_5_5_p74 = Lambda_inv_5_5_p62 - Lambda_inv_5_5_p45 * Lambda_inv_5_5_p34 -
      Lambda_inv_5_5_p50 * Lambda_inv_5_5_p65 - Lambda_inv_5_5_p66 * Lambda_inv_5_5_p70;

  // link 3 (link3), Jacobian
  const Real Lambda_inv_0_1_p1 = Lambda_inv_5_5_p24 * s1;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_5_5_p75 = 1.0 - Lambda_inv_5_5_p51 * Lambda_inv_5_5_p60 -
      Lambda_inv_5_5_p54 * Lambda_inv_5_5_p34 - Lambda_inv_5_5_p55 * Lambda_inv_5_5_p65 -
      Lambda_inv_5_5_p67 * Lambda_inv_5_5_p70;
  const Real Lambda_inv_5_5_p76 = Lambda_inv_5_5_p70 * Lambda_inv_5_5_p56;
  const Real Lambda_inv_4_4_p11 = Lambda_inv_4_4_p10 * Lambda_inv_5_5_p56;

  // link 4 (link4), pose
  const Real Lambda_inv_3_3_p3 = s4 * Lambda_inv_3_3_p1 - c4 * s1;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_4_4_p12 = Lambda_inv_4_4_p6 - Lambda_inv_5_5_p45 * Lambda_inv_4_4_p4 -
      Lambda_inv_5_5_p50 * Lambda_inv_4_4_p5 - Lambda_inv_5_5_p66 * Lambda_inv_4_4_p10;
  const Real Lambda_inv_0_0_p3 = Lambda_inv_0_0_p2 * c1 - Lambda_inv_5_5_p66 * Lambda_inv_0_0_p1;
  const Real Lambda_inv_0_1_p2 = Lambda_inv_0_0_p2 * s1 - Lambda_inv_5_5_p66 * Lambda_inv_0_1_p1;

  // link 5 (link5), pose
  const Real Lambda_inv_3_3_p4 = s5 * (c4 * Lambda_inv_3_3_p1 + s4 * s1) - c5 * Lambda_inv_3_3_p2;

  // link 1 (link1), mass matrix
  const Real Lambda_inv_0_5_p1 = 0.05625 * Lambda_inv_4_4_p3;
  const Real Lambda_inv_0_5_p2 = 0.05625 * Lambda_inv_5_5_p60;
  const Real Lambda_inv_5_5_p77 = Lambda_inv_5_5_p72 * Lambda_inv_5_5_p73;
  const Real Lambda_inv_5_5_p78 = Lambda_inv_5_5_p74 * Lambda_inv_5_5_p73;
  const Real Lambda_inv_4_4_p13 = Lambda_inv_4_4_p12 * Lambda_inv_5_5_p73;
  const Real Lambda_inv_1_5_p1 = 0.05625 * Lambda_inv_3_3_p4;
  const Real Lambda_inv_3_3_p5 = Lambda_inv_3_3_p2 + Lambda_inv_5_5_p4 * Lambda_inv_3_3_p4;
  const Real Lambda_inv_3_3_p6 = Lambda_inv_5_5_p21 * Lambda_inv_3_3_p4 - s1;
  const Real Lambda_inv_5_5_p79 = Lambda_inv_5_5_p61 - Lambda_inv_5_5_p54 * Lambda_inv_5_5_p48 -
      Lambda_inv_5_5_p55 * Lambda_inv_5_5_p53 - Lambda_inv_5_5_p67 * Lambda_inv_5_5_p58 -
      Lambda_inv_5_5_p77 * Lambda_inv_5_5_p72;
  const Real Lambda_inv_5_5_p80 = Lambda_inv_5_5_p75 - Lambda_inv_5_5_p77 * Lambda_inv_5_5_p74;
  const Real Lambda_inv_4_4_p14 = Lambda_inv_5_5_p51 * Lambda_inv_4_4_p3 - Lambda_inv_5_5_p54 *
      Lambda_inv_4_4_p4 - Lambda_inv_5_5_p55 * Lambda_inv_4_4_p5 - Lambda_inv_5_5_p67 *
      Lambda_inv_4_4_p10 - Lambda_inv_5_5_p77 * Lambda_inv_4_4_p12;
  const Real Lambda_inv_0_2_p1 = Lambda_inv_5_5_p66 * Lambda_inv_5_5_p22 - Lambda_inv_5_5_p38;
  const Real Lambda_inv_5_5_p81 = Lambda_inv_5_5_p63 * Lambda_inv_5_5_p60 + Lambda_inv_5_5_p64 *
      Lambda_inv_5_5_p34 + Lambda_inv_5_5_p69 * Lambda_inv_5_5_p65 + Lambda_inv_5_5_p76 *
      Lambda_inv_5_5_p70 + Lambda_inv_5_5_p78 * Lambda_inv_5_5_p74;
  const Real Lambda_inv_4_5_p1 = Lambda_inv_5_5_p64 * Lambda_inv_4_4_p4 - Lambda_inv_5_5_p63 *
      Lambda_inv_4_4_p3 + Lambda_inv_5_5_p69 * Lambda_inv_4_4_p5 + Lambda_inv_5_5_p76 *
      Lambda_inv_4_4_p10 + Lambda_inv_5_5_p78 * Lambda_inv_4_4_p12;
  const Real Lambda_inv_4_4_p15 = Lambda_inv_4_4_p7 * Lambda_inv_4_4_p3 + Lambda_inv_4_4_p8 *
      Lambda_inv_4_4_p4 + Lambda_inv_4_4_p9 * Lambda_inv_4_4_p5 + Lambda_inv_4_4_p11 *
      Lambda_inv_4_4_p10 + Lambda_inv_4_4_p13 * Lambda_inv_4_4_p12;
  const Real Lambda_inv_0_0_p4 = Lambda_inv_5_5_p38 * s1 + 0.1501 * c1 + Lambda_inv_5_5_p67 *
      Lambda_inv_0_0_p1 + Lambda_inv_5_5_p77 * Lambda_inv_0_0_p3;
  const Real Lambda_inv_0_1_p3 = Lambda_inv_5_5_p38 * c1 - 0.1501 * s1 - Lambda_inv_5_5_p67 *
      Lambda_inv_0_1_p1 - Lambda_inv_5_5_p77 * Lambda_inv_0_1_p2;
  const Real Lambda_inv_3_3_p7 = Lambda_inv_3_3_p6 - Lambda_inv_5_5_p40 * Lambda_inv_3_3_p3 -
      Lambda_inv_5_5_p44 * Lambda_inv_3_3_p5;
  const Real Lambda_inv_0_2_p2 = Lambda_inv_5_5_p67 * Lambda_inv_5_5_p22 - Lambda_inv_5_5_p77 *
      Lambda_inv_0_2_p1;
  const Real Lambda_inv_3_3_p8 = Lambda_inv_3_3_p7 * Lambda_inv_5_5_p56;
  const Real Lambda_inv_5_5_p82 = 1.0 / (Lambda_inv_5_5_p79 + 2.0 *
      (0.1501 * Lambda_inv_5_5_p11 - Lambda_inv_5_5_p37 - Lambda_inv_5_5_p29) + Lambda_inv_5_5_p68 *
      Lambda_inv_5_5_p12);
  const Real Lambda_inv_0_1_p4 = Lambda_inv_0_1_p2 * Lambda_inv_5_5_p73;
  const Real Lambda_inv_0_1_p5 = Lambda_inv_0_1_p1 * Lambda_inv_5_5_p56;
  const Real Lambda_inv_0_2_p3 = Lambda_inv_0_2_p1 * Lambda_inv_5_5_p73;
  const Real Lambda_inv_0_2_p4 = Lambda_inv_5_5_p22 * Lambda_inv_5_5_p56;
  const Real Lambda_inv_3_3_p9 = Lambda_inv_3_3_p6 - Lambda_inv_5_5_p45 * Lambda_inv_3_3_p3 -
      Lambda_inv_5_5_p50 * Lambda_inv_3_3_p5 - Lambda_inv_5_5_p66 * Lambda_inv_3_3_p7;
  const Real Lambda_inv_3_3_p10 = Lambda_inv_3_3_p9 * Lambda_inv_5_5_p73;
  const Real Lambda_inv_3_3_p11 = 24999.999999999996 * Lambda_inv_3_3_p4 * Lambda_inv_3_3_p4 +
      1557.24430048586 * Lambda_inv_3_3_p3 * Lambda_inv_3_3_p3 + Lambda_inv_3_3_p5 *
      Lambda_inv_5_5_p30 * Lambda_inv_3_3_p5;
  const Real Lambda_inv_3_3_p12 = Lambda_inv_5_5_p51 * Lambda_inv_3_3_p4 + Lambda_inv_5_5_p54 *
      Lambda_inv_3_3_p3 + Lambda_inv_5_5_p55 * Lambda_inv_3_3_p5 + Lambda_inv_5_5_p67 *
      Lambda_inv_3_3_p7 + Lambda_inv_5_5_p77 * Lambda_inv_3_3_p9;
  const Real Lambda_inv_3_5_p1 = Lambda_inv_5_5_p63 * Lambda_inv_3_3_p4 + Lambda_inv_5_5_p64 *
      Lambda_inv_3_3_p3 + Lambda_inv_5_5_p69 * Lambda_inv_3_3_p5 + Lambda_inv_5_5_p76 *
      Lambda_inv_3_3_p7 + Lambda_inv_5_5_p78 * Lambda_inv_3_3_p9;
  const Real Lambda_inv_3_4_p1 = Lambda_inv_4_4_p8 * Lambda_inv_3_3_p3 - Lambda_inv_4_4_p7 *
      Lambda_inv_3_3_p4 + Lambda_inv_4_4_p9 * Lambda_inv_3_3_p5 + Lambda_inv_4_4_p11 *
      Lambda_inv_3_3_p7 + Lambda_inv_4_4_p13 * Lambda_inv_3_3_p9;
  const Real Lambda_inv_5_5_p83 = Lambda_inv_5_5_p80 * Lambda_inv_5_5_p82;
  const Real Lambda_inv_4_4_p16 = Lambda_inv_4_4_p14 * Lambda_inv_5_5_p82;
  const Real Lambda_inv_3_3_p13 = Lambda_inv_3_3_p12 * Lambda_inv_5_5_p82;
  const Real Lambda_inv_0_1_p6 = Lambda_inv_0_1_p3 * Lambda_inv_5_5_p82;
  const Real Lambda_inv_0_2_p5 = Lambda_inv_0_2_p2 * Lambda_inv_5_5_p82;
  const Real Lambda_inv_5_5 = Lambda_inv_5_5_p81 + Lambda_inv_5_5_p83 * Lambda_inv_5_5_p80;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real Lambda_inv_4_5 = Lambda_inv_4_5_p1 + Lambda_inv_5_5_p83 * Lambda_inv_4_4_p14;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
  const Real Lambda_inv_4_4 = Lambda_inv_4_4_p15 + Lambda_inv_4_4_p16 * Lambda_inv_4_4_p14;
  Lambda_inv[28] = Lambda_inv_4_4;
  const Real Lambda_inv_3_5 = Lambda_inv_3_5_p1 - Lambda_inv_5_5_p83 * Lambda_inv_3_3_p12;
  Lambda_inv[23] = Lambda_inv_3_5;
  Lambda_inv[33] = Lambda_inv_3_5;
  const Real Lambda_inv_3_4 = Lambda_inv_3_4_p1 - Lambda_inv_4_4_p16 * Lambda_inv_3_3_p12;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;
  const Real Lambda_inv_3_3 = Lambda_inv_3_3_p11 + Lambda_inv_3_3_p8 * Lambda_inv_3_3_p7 +
      Lambda_inv_3_3_p10 * Lambda_inv_3_3_p9 + Lambda_inv_3_3_p13 * Lambda_inv_3_3_p12;
  Lambda_inv[21] = Lambda_inv_3_3;
  const Real Lambda_inv_0_5_p3 = Lambda_inv_5_5_p76 * Lambda_inv_0_0_p1 + Lambda_inv_5_5_p78 *
      Lambda_inv_0_0_p3 - Lambda_inv_5_5_p83 * Lambda_inv_0_0_p4;
  const Real Lambda_inv_0_4_p1 = Lambda_inv_4_4_p11 * Lambda_inv_0_0_p1 + Lambda_inv_4_4_p13 *
      Lambda_inv_0_0_p3 - Lambda_inv_4_4_p16 * Lambda_inv_0_0_p4;
  const Real Lambda_inv_0_1_p7 = Lambda_inv_5_5_p76 * Lambda_inv_0_1_p1 + Lambda_inv_5_5_p78 *
      Lambda_inv_0_1_p2 + Lambda_inv_5_5_p83 * Lambda_inv_0_1_p3;
  const Real Lambda_inv_0_2_p6 = Lambda_inv_4_4_p13 * Lambda_inv_0_2_p1 - Lambda_inv_4_4_p11 *
      Lambda_inv_5_5_p22 + Lambda_inv_4_4_p16 * Lambda_inv_0_2_p2;
  const Real Lambda_inv_1_3_p1 = Lambda_inv_3_3_p8 * Lambda_inv_0_1_p1 + Lambda_inv_3_3_p10 *
      Lambda_inv_0_1_p2 - Lambda_inv_3_3_p13 * Lambda_inv_0_1_p3;
  const Real Lambda_inv_1_2_p1 = Lambda_inv_3_3_p10 * Lambda_inv_0_2_p1 - Lambda_inv_3_3_p8 *
      Lambda_inv_5_5_p22 - Lambda_inv_3_3_p13 * Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_3_p1 = Lambda_inv_3_5 * Lambda_inv_0_5_p1;
  const Real Lambda_inv_0_3_p2 = Lambda_inv_3_4 * Lambda_inv_0_5_p2;
  const Real Lambda_inv_1_4_p1 = Lambda_inv_4_5 * Lambda_inv_1_5_p1;
  const Real Lambda_inv_1_4_p2 = Lambda_inv_4_4_p11 * Lambda_inv_0_1_p1 + Lambda_inv_4_4_p13 *
      Lambda_inv_0_1_p2 + Lambda_inv_4_4_p16 * Lambda_inv_0_1_p3;
  const Real Lambda_inv_0_2_p7 = Lambda_inv_5_5_p78 * Lambda_inv_0_2_p1 - Lambda_inv_5_5_p76 *
      Lambda_inv_5_5_p22 + Lambda_inv_5_5_p83 * Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_5 = Lambda_inv_0_5_p3 - (Lambda_inv_5_5 * Lambda_inv_0_5_p1 +
      Lambda_inv_4_5 * Lambda_inv_0_5_p2);
  Lambda_inv[5] = Lambda_inv_0_5;
  Lambda_inv[30] = Lambda_inv_0_5;
  const Real Lambda_inv_0_4 = Lambda_inv_0_4_p1 - (Lambda_inv_4_5 * Lambda_inv_0_5_p1 +
      Lambda_inv_4_4 * Lambda_inv_0_5_p2);
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[24] = Lambda_inv_0_4;
  const Real Lambda_inv_1_5 = Lambda_inv_0_1_p7 - (Lambda_inv_5_5 * Lambda_inv_1_5_p1 -
      Lambda_inv_3_5 * Lambda_inv_0_5_p2);
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real Lambda_inv_1_3 = Lambda_inv_1_3_p1 - (Lambda_inv_3_5 * Lambda_inv_1_5_p1 -
      Lambda_inv_3_3 * Lambda_inv_0_5_p2);
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  const Real Lambda_inv_2_4 = Lambda_inv_0_2_p6 + (Lambda_inv_4_4 * Lambda_inv_1_5_p1 +
      Lambda_inv_3_4 * Lambda_inv_0_5_p1);
  Lambda_inv[16] = Lambda_inv_2_4;
  Lambda_inv[26] = Lambda_inv_2_4;
  const Real Lambda_inv_2_3 = Lambda_inv_1_2_p1 + (Lambda_inv_3_4 * Lambda_inv_1_5_p1 +
      Lambda_inv_3_3 * Lambda_inv_0_5_p1);
  Lambda_inv[15] = Lambda_inv_2_3;
  Lambda_inv[20] = Lambda_inv_2_3;
  const Real Lambda_inv_0_3 = Lambda_inv_3_3_p8 * Lambda_inv_0_0_p1 + Lambda_inv_3_3_p10 *
      Lambda_inv_0_0_p3 + Lambda_inv_3_3_p13 * Lambda_inv_0_0_p4 -
      (Lambda_inv_0_3_p1 + Lambda_inv_0_3_p2);
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;
  const Real Lambda_inv_1_4 = Lambda_inv_1_4_p2 - (Lambda_inv_1_4_p1 - Lambda_inv_0_3_p2);
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_0_0_p5 = Lambda_inv_0_0_p1 * Lambda_inv_5_5_p56 * Lambda_inv_0_0_p1 +
      Lambda_inv_0_0_p3 * Lambda_inv_5_5_p73 * Lambda_inv_0_0_p3 + Lambda_inv_0_0_p4 *
      Lambda_inv_5_5_p82 * Lambda_inv_0_0_p4;
  const Real Lambda_inv_0_1_p8 = Lambda_inv_0_1_p5 * Lambda_inv_0_0_p1 + Lambda_inv_0_1_p4 *
      Lambda_inv_0_0_p3 - Lambda_inv_0_1_p6 * Lambda_inv_0_0_p4 - Lambda_inv_0_5_p1 *
      Lambda_inv_0_1_p7 - Lambda_inv_1_5_p1 * Lambda_inv_0_5;
  const Real Lambda_inv_0_2_p8 = Lambda_inv_0_2_p3 * Lambda_inv_0_0_p3 - Lambda_inv_0_2_p4 *
      Lambda_inv_0_0_p1 - Lambda_inv_0_2_p5 * Lambda_inv_0_0_p4 - Lambda_inv_0_5_p2 *
      Lambda_inv_0_2_p6 + Lambda_inv_1_5_p1 * Lambda_inv_0_4;
  const Real Lambda_inv_1_2_p2 = Lambda_inv_0_2_p3 * Lambda_inv_0_1_p2 - Lambda_inv_0_2_p4 *
      Lambda_inv_0_1_p1 + Lambda_inv_0_2_p5 * Lambda_inv_0_1_p3 + Lambda_inv_0_5_p2 *
      Lambda_inv_1_2_p1 + Lambda_inv_0_5_p1 * Lambda_inv_1_3;
  const Real Lambda_inv_2_5 = Lambda_inv_0_2_p7 + (Lambda_inv_1_4_p1 + Lambda_inv_0_3_p1);
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;
  Lambda_inv[0] = Lambda_inv_0_0_p5 - (Lambda_inv_0_5_p1 * (Lambda_inv_0_5_p3 + Lambda_inv_0_5) +
      Lambda_inv_0_5_p2 * (Lambda_inv_0_4_p1 + Lambda_inv_0_4));
  const Real Lambda_inv_0_1 = Lambda_inv_0_1_p8 + (Lambda_inv_0_3 - Lambda_inv_1_4_p2) *
      Lambda_inv_0_5_p2;
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;
  const Real Lambda_inv_0_2 = Lambda_inv_0_2_p8 + (Lambda_inv_0_3 - Lambda_inv_0_2_p7) *
      Lambda_inv_0_5_p1;
  Lambda_inv[2] = Lambda_inv_0_2;
  Lambda_inv[12] = Lambda_inv_0_2;
  Lambda_inv[7] = Lambda_inv_0_1_p5 * Lambda_inv_0_1_p1 + Lambda_inv_0_1_p4 * Lambda_inv_0_1_p2 +
      Lambda_inv_0_1_p6 * Lambda_inv_0_1_p3 - (Lambda_inv_1_5_p1 *
      (Lambda_inv_0_1_p7 + Lambda_inv_1_5) - Lambda_inv_0_5_p2 *
      (Lambda_inv_1_3_p1 + Lambda_inv_1_3));
  const Real Lambda_inv_1_2 = Lambda_inv_1_2_p2 + (Lambda_inv_1_4 - Lambda_inv_0_2_p7) *
      Lambda_inv_1_5_p1;
  Lambda_inv[8] = Lambda_inv_1_2;
  Lambda_inv[13] = Lambda_inv_1_2;
  Lambda_inv[14] = Lambda_inv_0_2_p4 * Lambda_inv_5_5_p22 + Lambda_inv_0_2_p3 * Lambda_inv_0_2_p1 +
      Lambda_inv_0_2_p5 * Lambda_inv_0_2_p2 + (Lambda_inv_1_5_p1 *
      (Lambda_inv_0_2_p6 + Lambda_inv_2_4) + Lambda_inv_0_5_p1 *
      (Lambda_inv_1_2_p1 + Lambda_inv_2_3));
}

}  // namespace puma560

#undef TREELINE_RESTRICT
