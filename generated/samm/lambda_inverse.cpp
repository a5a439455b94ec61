// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points.
// 1289 flops (add 517, mul 766, div 6), sine and cosine of 7 angles
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
void lambda_inverse(const Real (&TREELINE_RESTRICT q)[9],
    Real (&TREELINE_RESTRICT Lambda_inv)[36]) noexcept {
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
  const Real Lambda_inv_0_0_p1 = 0.861795 + inverse_D6_p17;

  // link 6 (link3), articulated inertia
  const Real Lambda_inv_0_0_p2 = Lambda_inv_0_0_p1 * inverse_D6;

  // link 7 (link4), articulated inertia
  const Real Lambda_inv_0_0_p3 = s7 * inverse_D6_p5;
  const Real Lambda_inv_0_0_p4 = c7 * inverse_D6_p12;
  const Real Lambda_inv_0_0_p5 = Lambda_inv_0_0_p3 + 0.4331 * Lambda_inv_0_0_p4;
  const Real Lambda_inv_0_0_p6 = s7 * inverse_D6_p15;
  const Real Lambda_inv_0_0_p7 = 0.0203 * Lambda_inv_0_0_p6;
  const Real Lambda_inv_0_0_p8 = Lambda_inv_0_0_p5 + Lambda_inv_0_0_p7;
  const Real Lambda_inv_0_0_p9 = 0.004704000000000001 + 0.0203 * Lambda_inv_0_0_p8;

  // link 6 (link3), articulated inertia
  const Real Lambda_inv_0_0_p10 = 0.0203 * Lambda_inv_0_0_p4 - Lambda_inv_0_0_p9 *
      Lambda_inv_0_0_p2;

  // link 7 (link4), articulated inertia
  const Real Lambda_inv_0_0_p11 = 0.025374999999999998 + inverse_D6_p18;

  // link 6 (link3), articulated inertia
  const Real Lambda_inv_0_0_p12 = Lambda_inv_0_0_p11 * inverse_D6;

  // link 7 (link4), articulated inertia
  const Real Lambda_inv_0_0_p13 = c7 * inverse_D6_p21 - 0.4331 *
      (Lambda_inv_0_0_p8 + Lambda_inv_0_0_p3);

  // link 6 (link3), articulated inertia
  const Real Lambda_inv_0_0_p14 = 0.4331 * Lambda_inv_0_0_p6 + Lambda_inv_0_0_p13 *
      Lambda_inv_0_0_p12;
  const Real Lambda_inv_0_0_p15 = Lambda_inv_0_0_p5 + Lambda_inv_0_0_p13 * Lambda_inv_0_0_p2;
  const Real Lambda_inv_0_0_p16 = Lambda_inv_0_0_p9 * Lambda_inv_0_0_p12 - Lambda_inv_0_0_p7;
  const Real Lambda_inv_0_0_p17 = c6 * (Lambda_inv_0_0_p10 + Lambda_inv_0_0_p14) - s6 *
      (Lambda_inv_0_0_p15 + Lambda_inv_0_0_p16);
  const Real Lambda_inv_0_0_p18 = s6 * Lambda_inv_0_0_p17;
  const Real Lambda_inv_0_0_p19 = Lambda_inv_0_0_p8 * inverse_D6;
  const Real Lambda_inv_0_0_p20 = Lambda_inv_0_0_p4 - Lambda_inv_0_0_p1 * Lambda_inv_0_0_p19;
  const Real Lambda_inv_0_0_p21 = Lambda_inv_0_0_p11 * Lambda_inv_0_0_p19 - Lambda_inv_0_0_p6;
  const Real Lambda_inv_0_0_p22 = s6 * Lambda_inv_0_0_p20 + c6 * Lambda_inv_0_0_p21;
  const Real Lambda_inv_0_0_p23 = 0.4318 * Lambda_inv_0_0_p22;
  const Real Lambda_inv_0_0_p24 = Lambda_inv_0_0_p16 + Lambda_inv_0_0_p18 - Lambda_inv_0_0_p23;
  const Real Lambda_inv_0_0_p25 = inverse_D6_p14 - Lambda_inv_0_0_p1 * Lambda_inv_0_0_p2;
  const Real Lambda_inv_0_0_p26 = inverse_D6_p10 + Lambda_inv_0_0_p11 * Lambda_inv_0_0_p12;
  const Real Lambda_inv_0_0_p27 = Lambda_inv_0_0_p1 * Lambda_inv_0_0_p12 - inverse_D6_p16;
  const Real Lambda_inv_0_0_p28 = 2.0 * c6;
  const Real Lambda_inv_0_0_p29 = s6 * (Lambda_inv_0_0_p25 + Lambda_inv_0_0_p26) +
      Lambda_inv_0_0_p28 * Lambda_inv_0_0_p27;
  const Real Lambda_inv_0_0_p30 = c6 * Lambda_inv_0_0_p29 - Lambda_inv_0_0_p27;
  const Real Lambda_inv_0_0_p31 = 0.1501 * Lambda_inv_0_0_p30;
  const Real Lambda_inv_0_0_p32 = Lambda_inv_0_0_p15 + Lambda_inv_0_0_p18 +
      (Lambda_inv_0_0_p24 + Lambda_inv_0_0_p31);
  const Real Lambda_inv_0_0_p33 = c6 * Lambda_inv_0_0_p17;
  const Real Lambda_inv_0_0_p34 = Lambda_inv_0_0_p33 - Lambda_inv_0_0_p10;
  const Real Lambda_inv_0_0_p35 = s6 * Lambda_inv_0_0_p29;
  const Real Lambda_inv_0_0_p36 = Lambda_inv_0_0_p35 - Lambda_inv_0_0_p26;
  const Real Lambda_inv_0_0_p37 = 0.4318 * Lambda_inv_0_0_p34 - 0.06481318000000001 *
      Lambda_inv_0_0_p36 - 0.690314699;
  const Real Lambda_inv_0_0_p38 = 0.4318 * Lambda_inv_0_0_p30 - 0.10439999999999999;

  // link 5 (link2), articulated inertia
  const Real inverse_D5 = 1.0 / (1.7481140020000001 + 0.18645124000000002 * Lambda_inv_0_0_p36);
  const Real Lambda_inv_0_0_p39 = Lambda_inv_0_0_p38 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real Lambda_inv_0_0_p40 = 0.4318 * Lambda_inv_0_0_p24 + 0.06481318000000001 *
      Lambda_inv_0_0_p30 - 0.023750999999999998;
  const Real Lambda_inv_0_0_p41 = 3.79559 + 0.4318 * Lambda_inv_0_0_p36;

  // link 5 (link2), articulated inertia
  const Real Lambda_inv_0_0_p42 = Lambda_inv_0_0_p41 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real Lambda_inv_0_0_p43 = Lambda_inv_0_0_p33 - Lambda_inv_0_0_p14;
  const Real Lambda_inv_0_0_p44 = c6 * Lambda_inv_0_0_p20 - s6 * Lambda_inv_0_0_p21;
  const Real Lambda_inv_0_0_p45 = Lambda_inv_0_0_p25 - Lambda_inv_0_0_p35;
  const Real Lambda_inv_0_0_p46 = Lambda_inv_0_0_p43 -
      (0.4318 * Lambda_inv_0_0_p44 - 0.1501 * Lambda_inv_0_0_p45);
  const Real Lambda_inv_0_0_p47 = Lambda_inv_0_0_p34 - 0.1501 * Lambda_inv_0_0_p36;

  // link 5 (link2), articulated inertia
  const Real Lambda_inv_0_0_p48 = Lambda_inv_0_0_p47 - Lambda_inv_0_0_p37 * Lambda_inv_0_0_p42;
  const Real Lambda_inv_0_0_p49 = s5 * (Lambda_inv_0_0_p32 + Lambda_inv_0_0_p31 +
      Lambda_inv_0_0_p37 * Lambda_inv_0_0_p39 - Lambda_inv_0_0_p40 * Lambda_inv_0_0_p42) - c5 *
      (Lambda_inv_0_0_p46 - Lambda_inv_0_0_p40 * Lambda_inv_0_0_p39 + Lambda_inv_0_0_p48);
  const Real Lambda_inv_0_0_p50 = c5 * Lambda_inv_0_0_p49 + Lambda_inv_0_0_p48 - 4.9338049999999996;

  // link 7 (link4), articulated inertia
  const Real inverse_D4_p1 = inverse_D6_p13 - inverse_D6_p8;
  const Real inverse_D4_p2 = inverse_D6_p6 - 0.4331 * inverse_D4_p1;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p3 = Lambda_inv_0_0_p13 * inverse_D6;
  const Real inverse_D4_p4 = 0.3056901365 + (inverse_D6_p20 - inverse_D6_p22 - 0.4331 *
      (inverse_D6_p6 + inverse_D4_p2)) - Lambda_inv_0_0_p13 * inverse_D4_p3;
  const Real inverse_D4_p5 = Lambda_inv_0_0_p9 * inverse_D6;
  const Real inverse_D4_p6 = 0.0067651125 + 0.00041208999999999994 * inverse_D4_p1 -
      Lambda_inv_0_0_p9 * inverse_D4_p5;
  const Real inverse_D4_p7 = 0.0203 * inverse_D6_p6 - 0.00879193 * inverse_D4_p1 -
      0.010673638499999999 - Lambda_inv_0_0_p13 * inverse_D4_p5;
  const Real inverse_D4_p8 = s6 * (inverse_D4_p4 - inverse_D4_p6) + Lambda_inv_0_0_p28 *
      inverse_D4_p7;
  const Real inverse_D4_p9 = s6 * inverse_D4_p8;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p10 = Lambda_inv_0_0_p37 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p11 = inverse_D4_p2 - 0.861795 - Lambda_inv_0_0_p13 * Lambda_inv_0_0_p19;
  const Real inverse_D4_p12 = 0.025374999999999998 + 0.0203 * inverse_D4_p1 - Lambda_inv_0_0_p9 *
      Lambda_inv_0_0_p19;
  const Real inverse_D4_p13 = s6 * inverse_D4_p11 + c6 * inverse_D4_p12;
  const Real inverse_D4_p14 = inverse_D4_p1 - Lambda_inv_0_0_p8 * Lambda_inv_0_0_p19;
  const Real inverse_D4_p15 = inverse_D4_p13 - (0.4318 * inverse_D4_p14 - 0.1501 *
      Lambda_inv_0_0_p44);
  const Real inverse_D4_p16 = 1.674987602 + (inverse_D4_p6 + inverse_D4_p9 +
      (0.1501 * (Lambda_inv_0_0_p43 + Lambda_inv_0_0_p46) - 0.4318 *
      (inverse_D4_p13 + inverse_D4_p15)));

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p17 = Lambda_inv_0_0_p40 * inverse_D5;
  const Real inverse_D4_p18 = inverse_D4_p16 - Lambda_inv_0_0_p40 * inverse_D4_p17;
  const Real inverse_D4_p19 = 0.07312640000000001 +
      (inverse_D4_p4 - inverse_D4_p9 - 0.1501 * (Lambda_inv_0_0_p34 + Lambda_inv_0_0_p47)) -
      Lambda_inv_0_0_p37 * inverse_D4_p10 - inverse_D4_p18;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p20 = c6 * inverse_D4_p11 - s6 * inverse_D4_p12;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p21 = c6 * inverse_D4_p8 - inverse_D4_p7 -
      (0.1501 * Lambda_inv_0_0_p32 + 0.4318 * inverse_D4_p20) - 0.0070992 - Lambda_inv_0_0_p37 *
      inverse_D4_p17;
  const Real inverse_D4_p22 = 2.0 * c5;

  // link 4 (link1), articulated inertia
  const Real inverse_D4 = 1.0 / (1.4717295504999999 +
      (inverse_D4_p18 + s5 * (s5 * inverse_D4_p19 + inverse_D4_p22 * inverse_D4_p21)));
  const Real Lambda_inv_0_0_p51 = Lambda_inv_0_0_p50 * inverse_D4;

  // link 5 (link2), articulated inertia
  const Real Lambda_inv_0_0_p52 = Lambda_inv_0_0_p45 - Lambda_inv_0_0_p38 * Lambda_inv_0_0_p39;
  const Real Lambda_inv_0_0_p53 = s5 * (Lambda_inv_0_0_p52 -
      (Lambda_inv_0_0_p36 - Lambda_inv_0_0_p41 * Lambda_inv_0_0_p42)) + inverse_D4_p22 *
      (Lambda_inv_0_0_p30 - Lambda_inv_0_0_p38 * Lambda_inv_0_0_p42);

  // link 4 (link1), articulated inertia
  const Real Lambda_inv_0_0_p54 = Lambda_inv_0_0_p52 - s5 * Lambda_inv_0_0_p53 -
      Lambda_inv_0_0_p50 * Lambda_inv_0_0_p51;

  // link 5 (link2), articulated inertia
  const Real Lambda_inv_0_0_p55 = Lambda_inv_0_0_p23 * inverse_D5;
  const Real Lambda_inv_0_0_p56 = s5 * (0.10439999999999999 +
      (inverse_D4_p20 - 0.1501 * Lambda_inv_0_0_p22) - Lambda_inv_0_0_p37 * Lambda_inv_0_0_p55) +
      c5 * (inverse_D4_p15 - 3.79559 - Lambda_inv_0_0_p40 * Lambda_inv_0_0_p55);

  // link 4 (link1), articulated inertia
  const Real Lambda_inv_0_0_p57 = Lambda_inv_0_0_p56 * inverse_D4;
  const Real Lambda_inv_0_0_p58 = inverse_D4_p14 - Lambda_inv_0_0_p23 * Lambda_inv_0_0_p55 -
      Lambda_inv_0_0_p56 * Lambda_inv_0_0_p57;
  const Real Lambda_inv_0_0_p59 = Lambda_inv_0_0_p50 * Lambda_inv_0_0_p57 -
      (s5 * (Lambda_inv_0_0_p22 - Lambda_inv_0_0_p41 * Lambda_inv_0_0_p55) - c5 *
      (Lambda_inv_0_0_p44 - Lambda_inv_0_0_p38 * Lambda_inv_0_0_p55));
  const Real Lambda_inv_0_0_p60 = s4 * (Lambda_inv_0_0_p54 - Lambda_inv_0_0_p58) + c4 *
      (2.0 * Lambda_inv_0_0_p59);
  const Real Lambda_inv_0_0_p61 = s4 * Lambda_inv_0_0_p60;
  const Real Lambda_inv_0_0_p62 = Lambda_inv_0_0_p54 - Lambda_inv_0_0_p61;
  const Real Lambda_inv_0_0_p63 = Lambda_inv_0_0_p58 + Lambda_inv_0_0_p61;
  const Real Lambda_inv_0_0_p64 = c4 * Lambda_inv_0_0_p60 - Lambda_inv_0_0_p59;

  // link 3 (base), articulated inertia
  const Real Lambda_inv_0_0_p65 = s3 * (Lambda_inv_0_0_p62 - Lambda_inv_0_0_p63) + c3 *
      (2.0 * Lambda_inv_0_0_p64);
  const Real Lambda_inv_0_0_p66 = c3 * Lambda_inv_0_0_p65 - Lambda_inv_0_0_p64;
  const Real inverse_D2_p1 = s3 * Lambda_inv_0_0_p65;

  // link 2 (base_y), articulated inertia
  const Real inverse_D2 = 1.0 / (186.45 + (Lambda_inv_0_0_p63 + inverse_D2_p1));
  const Real Lambda_inv_0_0_p67 = Lambda_inv_0_0_p66 * inverse_D2;

  // link 6 (link3), pose
  const Real Lambda_inv_0_5_p1 = s6 * s5 - c6 * c5;
  const Real Lambda_inv_0_5_p2 = c6 * s5 + s6 * c5;

  // link 7 (link4), pose
  const Real Lambda_inv_0_5_p3 = c7 * Lambda_inv_0_5_p2;

  // link 8 (link5), pose
  const Real Lambda_inv_0_5_p4 = s8 * Lambda_inv_0_5_p1 - c8 * Lambda_inv_0_5_p3;

  // link 7 (link4), pose
  const Real Lambda_inv_0_5_p5 = s7 * Lambda_inv_0_5_p2;

  // link 9 (link6), pose
  const Real Lambda_inv_0_5_p6 = c9 * Lambda_inv_0_5_p4 + s9 * Lambda_inv_0_5_p5;

  // link 4 (link1), pose
  const Real Lambda_inv_0_4_p1 = s4 * c3 + c4 * s3;

  // link 5 (link2), pose
  const Real Lambda_inv_0_4_p2 = c5 * Lambda_inv_0_4_p1;
  const Real Lambda_inv_0_4_p3 = s5 * Lambda_inv_0_4_p1;

  // link 6 (link3), pose
  const Real Lambda_inv_0_4_p4 = c6 * Lambda_inv_0_4_p2 - s6 * Lambda_inv_0_4_p3;

  // link 4 (link1), pose
  const Real Lambda_inv_0_4_p5 = c4 * c3 - s4 * s3;

  // link 7 (link4), pose
  const Real Lambda_inv_0_4_p6 = c7 * Lambda_inv_0_4_p4 + s7 * Lambda_inv_0_4_p5;

  // link 6 (link3), pose
  const Real Lambda_inv_0_4_p7 = s6 * Lambda_inv_0_4_p2 + c6 * Lambda_inv_0_4_p3;

  // link 8 (link5), pose
  const Real Lambda_inv_0_4_p8 = c8 * Lambda_inv_0_4_p6 - s8 * Lambda_inv_0_4_p7;

  // link 7 (link4), pose
  const Real Lambda_inv_0_4_p9 = c7 * Lambda_inv_0_4_p5 - s7 * Lambda_inv_0_4_p4;

  // link 9 (link6), pose
  const Real Lambda_inv_0_4_p10 = c9 * Lambda_inv_0_4_p8 + s9 * Lambda_inv_0_4_p9;

  // link 5 (link2), pose
  const Real Lambda_inv_0_3_p1 = c5 * Lambda_inv_0_4_p5;
  const Real Lambda_inv_0_3_p2 = s5 * Lambda_inv_0_4_p5;

  // link 6 (link3), pose
  const Real Lambda_inv_0_3_p3 = c6 * Lambda_inv_0_3_p1 - s6 * Lambda_inv_0_3_p2;

  // link 7 (link4), pose
  const Real Lambda_inv_0_3_p4 = c7 * Lambda_inv_0_3_p3 - s7 * Lambda_inv_0_4_p1;

  // link 6 (link3), pose
  const Real Lambda_inv_0_3_p5 = s6 * Lambda_inv_0_3_p1 + c6 * Lambda_inv_0_3_p2;

  // link 8 (link5), pose
  const Real Lambda_inv_0_3_p6 = c8 * Lambda_inv_0_3_p4 - s8 * Lambda_inv_0_3_p5;

  // link 7 (link4), pose
  const Real Lambda_inv_0_3_p7 = s7 * Lambda_inv_0_3_p3 + c7 * Lambda_inv_0_4_p1;

  // link 9 (link6), pose
  const Real Lambda_inv_0_3_p8 = c9 * Lambda_inv_0_3_p6 - s9 * Lambda_inv_0_3_p7;

  // link 9 (link6), force propagation
  const Lanes Lambda_inv_0_3_p9_lanes = c9 * detail::make_lanes<Real>(Lambda_inv_0_3_p8,
      Lambda_inv_0_4_p10, Lambda_inv_0_5_p6, Lambda_inv_0_3_p8, Lambda_inv_0_3_p8,
      Lambda_inv_0_3_p8, Lambda_inv_0_3_p8, Lambda_inv_0_3_p8);

  // link 9 (link6), pose
  const Real Lambda_inv_0_5_p8 = c9 * Lambda_inv_0_5_p5 - s9 * Lambda_inv_0_5_p4;
  const Real Lambda_inv_0_4_p12 = c9 * Lambda_inv_0_4_p9 - s9 * Lambda_inv_0_4_p8;
  const Real Lambda_inv_0_3_p10 = s9 * Lambda_inv_0_3_p6 + c9 * Lambda_inv_0_3_p7;

  // link 9 (link6), force propagation
  const Real Lambda_inv_0_3_p11 = -Lambda_inv_0_3_p10;
  const Lanes Lambda_inv_0_3_p12_lanes = s9 * detail::make_lanes<Real>(Lambda_inv_0_3_p11,
      Lambda_inv_0_4_p12, Lambda_inv_0_5_p8, Lambda_inv_0_3_p11, Lambda_inv_0_3_p11,
      Lambda_inv_0_3_p11, Lambda_inv_0_3_p11, Lambda_inv_0_3_p11);
  const Lanes Lambda_inv_0_3_p13_lanes = Lambda_inv_0_3_p9_lanes - Lambda_inv_0_3_p12_lanes;
  const Real Lambda_inv_0_2_p1 = -(0.05625 * Lambda_inv_0_5_p8);
  const Real Lambda_inv_0_1_p1 = -(0.05625 * Lambda_inv_0_4_p12);

  // link 1 (base_x), articulated inertia
  const Real Lambda_inv_0_0_p68 = 0.05625 * Lambda_inv_0_3_p10;

  // link 9 (link6), force propagation
  const Lanes Lambda_inv_0_0_p69_lanes = c9 * detail::make_lanes<Real>(Lambda_inv_0_0_p68,
      Lambda_inv_0_1_p1, Lambda_inv_0_2_p1, Lambda_inv_0_0_p68, Lambda_inv_0_0_p68,
      Lambda_inv_0_0_p68, Lambda_inv_0_0_p68, Lambda_inv_0_0_p68);

  // link 1 (base_x), articulated inertia
  const Lanes Lambda_inv_0_0_p70_lanes = 0.05625 * detail::make_lanes<Real>(Lambda_inv_0_3_p8,
      Lambda_inv_0_4_p10, Lambda_inv_0_5_p6, Lambda_inv_0_3_p8, Lambda_inv_0_3_p8,
      Lambda_inv_0_3_p8, Lambda_inv_0_3_p8, Lambda_inv_0_3_p8);

  // link 9 (link6), force propagation
  const Lanes Lambda_inv_0_0_p71_lanes = s9 * Lambda_inv_0_0_p70_lanes;
  const Lanes Lambda_inv_0_0_p72_lanes = Lambda_inv_0_0_p69_lanes - Lambda_inv_0_0_p71_lanes;

  // link 8 (link5), force propagation
  const Lanes Lambda_inv_0_0_p73_lanes = c8 * detail::make_lanes<Real>(Lambda_inv_0_0_p72_lanes[0],
      Lambda_inv_0_0_p72_lanes[1], Lambda_inv_0_0_p72_lanes[2], Lambda_inv_0_3_p13_lanes[0],
      Lambda_inv_0_3_p13_lanes[1], Lambda_inv_0_3_p13_lanes[2], Lambda_inv_0_0_p72_lanes[0],
      Lambda_inv_0_0_p72_lanes[0]);

  // link 7 (link4), force propagation
  const Real Lambda_inv_0_5_p12 = -(s8 * Lambda_inv_0_3_p13_lanes[2]);
  const Real Lambda_inv_0_4_p16 = -(s8 * Lambda_inv_0_3_p13_lanes[1]);
  const Real Lambda_inv_0_3_p15 = -(s8 * Lambda_inv_0_3_p13_lanes[0]);
  const Real Lambda_inv_0_2_p7 = -(s8 * Lambda_inv_0_0_p72_lanes[2]);
  const Real Lambda_inv_0_1_p7 = -(s8 * Lambda_inv_0_0_p72_lanes[1]);
  const Real Lambda_inv_0_0_p74 = -(s8 * Lambda_inv_0_0_p72_lanes[0]);
  const Lanes Lambda_inv_0_0_p75_lanes = inverse_D6_p19 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p74, Lambda_inv_0_1_p7, Lambda_inv_0_2_p7,
      Lambda_inv_0_3_p15, Lambda_inv_0_4_p16, Lambda_inv_0_5_p12, Lambda_inv_0_0_p74,
      Lambda_inv_0_0_p74);
  const Lanes Lambda_inv_0_0_p76_lanes = Lambda_inv_0_0_p73_lanes + Lambda_inv_0_0_p75_lanes;
  const Lanes Lambda_inv_0_0_p77_lanes = c7 * Lambda_inv_0_0_p76_lanes;

  // link 9 (link6), force propagation
  const Lanes Lambda_inv_0_3_p19_lanes = s9 * detail::make_lanes<Real>(Lambda_inv_0_3_p8,
      Lambda_inv_0_4_p10, Lambda_inv_0_5_p6, Lambda_inv_0_3_p8, Lambda_inv_0_3_p8,
      Lambda_inv_0_3_p8, Lambda_inv_0_3_p8, Lambda_inv_0_3_p8);
  const Lanes Lambda_inv_0_3_p20_lanes = c9 * detail::make_lanes<Real>(Lambda_inv_0_3_p11,
      Lambda_inv_0_4_p12, Lambda_inv_0_5_p8, Lambda_inv_0_3_p11, Lambda_inv_0_3_p11,
      Lambda_inv_0_3_p11, Lambda_inv_0_3_p11, Lambda_inv_0_3_p11);
  const Lanes Lambda_inv_0_3_p21_lanes = Lambda_inv_0_3_p19_lanes + Lambda_inv_0_3_p20_lanes;

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_5_p19 = 4.484863585399276 * Lambda_inv_0_3_p21_lanes[2];

  // link 7 (link4), force propagation
  const Real Lambda_inv_0_5_p20 = -(c8 * Lambda_inv_0_5_p19);
  const Real Lambda_inv_0_5_p21 = inverse_D6_p2 * Lambda_inv_0_5_p12;
  const Real Lambda_inv_0_5_p22 = s7 * Lambda_inv_0_5_p20 - c7 * Lambda_inv_0_5_p21;

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_4_p23 = 4.484863585399276 * Lambda_inv_0_3_p21_lanes[1];

  // link 7 (link4), force propagation
  const Real Lambda_inv_0_4_p24 = -(c8 * Lambda_inv_0_4_p23);
  const Real Lambda_inv_0_4_p25 = inverse_D6_p2 * Lambda_inv_0_4_p16;
  const Real Lambda_inv_0_4_p26 = s7 * Lambda_inv_0_4_p24 - c7 * Lambda_inv_0_4_p25;

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_3_p22 = 4.484863585399276 * Lambda_inv_0_3_p21_lanes[0];

  // link 7 (link4), force propagation
  const Real Lambda_inv_0_3_p23 = -(c8 * Lambda_inv_0_3_p22);
  const Real Lambda_inv_0_3_p24 = inverse_D6_p2 * Lambda_inv_0_3_p15;
  const Real Lambda_inv_0_3_p25 = s7 * Lambda_inv_0_3_p23 - c7 * Lambda_inv_0_3_p24;

  // link 9 (link6), force propagation
  const Lanes Lambda_inv_0_0_p78_lanes = s9 * detail::make_lanes<Real>(Lambda_inv_0_0_p68,
      Lambda_inv_0_1_p1, Lambda_inv_0_2_p1, Lambda_inv_0_0_p68, Lambda_inv_0_0_p68,
      Lambda_inv_0_0_p68, Lambda_inv_0_0_p68, Lambda_inv_0_0_p68);
  const Lanes Lambda_inv_0_0_p79_lanes = c9 * Lambda_inv_0_0_p70_lanes;
  const Lanes Lambda_inv_0_0_p80_lanes = Lambda_inv_0_0_p78_lanes + Lambda_inv_0_0_p79_lanes;

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_2_p14 = Lambda_inv_0_3_p13_lanes[2] - 4.484863585399276 *
      Lambda_inv_0_0_p80_lanes[2];

  // link 9 (link6), force propagation
  const Real Lambda_inv_0_2_p15 = -(s8 * Lambda_inv_0_5_p3 + c8 * Lambda_inv_0_5_p1);

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_2_p16 = -Lambda_inv_0_2_p15;

  // link 7 (link4), force propagation
  const Real Lambda_inv_0_2_p17 = -(s8 * Lambda_inv_0_2_p16 - c8 * Lambda_inv_0_2_p14);

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_1_p14 = Lambda_inv_0_3_p13_lanes[1] - 4.484863585399276 *
      Lambda_inv_0_0_p80_lanes[1];

  // link 8 (link5), pose
  const Real Lambda_inv_0_1_p15 = s8 * Lambda_inv_0_4_p6 + c8 * Lambda_inv_0_4_p7;

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_1_p16 = -Lambda_inv_0_1_p15;

  // link 7 (link4), force propagation
  const Real Lambda_inv_0_1_p17 = -(s8 * Lambda_inv_0_1_p16 - c8 * Lambda_inv_0_1_p14);

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_0_p81 = Lambda_inv_0_3_p13_lanes[0] - 4.484863585399276 *
      Lambda_inv_0_0_p80_lanes[0];

  // link 8 (link5), pose
  const Real Lambda_inv_0_0_p82 = s8 * Lambda_inv_0_3_p4 + c8 * Lambda_inv_0_3_p5;

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_0_p83 = -Lambda_inv_0_0_p82;

  // link 7 (link4), force propagation
  const Real Lambda_inv_0_0_p84 = -(s8 * Lambda_inv_0_0_p83 - c8 * Lambda_inv_0_0_p81);
  const Lanes Lambda_inv_0_0_p85_lanes = s7 * detail::make_lanes<Real>(Lambda_inv_0_0_p84,
      Lambda_inv_0_1_p17, Lambda_inv_0_2_p17, Lambda_inv_0_0_p84, Lambda_inv_0_0_p84,
      Lambda_inv_0_0_p84, Lambda_inv_0_0_p84, Lambda_inv_0_0_p84);
  const Lanes Lambda_inv_0_0_p86_lanes = inverse_D6_p2 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p74, Lambda_inv_0_1_p7, Lambda_inv_0_2_p7,
      Lambda_inv_0_0_p74, Lambda_inv_0_0_p74, Lambda_inv_0_0_p74, Lambda_inv_0_0_p74,
      Lambda_inv_0_0_p74);
  const Lanes Lambda_inv_0_0_p87_lanes = Lambda_inv_0_3_p21_lanes - Lambda_inv_0_0_p86_lanes;
  const Lanes Lambda_inv_0_0_p88_lanes = c7 * Lambda_inv_0_0_p87_lanes;
  const Lanes Lambda_inv_0_0_p89_lanes = Lambda_inv_0_0_p85_lanes + Lambda_inv_0_0_p88_lanes;
  const Lanes Lambda_inv_0_0_p90_lanes = 0.4331 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p89_lanes[0], Lambda_inv_0_0_p89_lanes[1],
      Lambda_inv_0_0_p89_lanes[2], Lambda_inv_0_3_p25, Lambda_inv_0_4_p26, Lambda_inv_0_5_p22,
      Lambda_inv_0_0_p89_lanes[0], Lambda_inv_0_0_p89_lanes[0]);
  const Lanes Lambda_inv_0_0_p91_lanes = Lambda_inv_0_0_p77_lanes - Lambda_inv_0_0_p90_lanes;
  const Lanes Lambda_inv_0_0_p92_lanes = s7 * Lambda_inv_0_0_p76_lanes;
  const Lanes Lambda_inv_0_3_p29_lanes = c7 * detail::make_lanes<Real>(Lambda_inv_0_3_p23,
      Lambda_inv_0_3_p23, Lambda_inv_0_3_p23, Lambda_inv_0_3_p23, Lambda_inv_0_4_p24,
      Lambda_inv_0_5_p20, Lambda_inv_0_3_p23, Lambda_inv_0_3_p23);
  const Lanes Lambda_inv_0_3_p30_lanes = s7 * detail::make_lanes<Real>(Lambda_inv_0_3_p24,
      Lambda_inv_0_3_p24, Lambda_inv_0_3_p24, Lambda_inv_0_3_p24, Lambda_inv_0_4_p25,
      Lambda_inv_0_5_p21, Lambda_inv_0_3_p24, Lambda_inv_0_3_p24);
  const Lanes Lambda_inv_0_3_p31_lanes = Lambda_inv_0_3_p29_lanes + Lambda_inv_0_3_p30_lanes;
  const Real Lambda_inv_0_2_p26 = c7 * Lambda_inv_0_2_p17 - s7 * Lambda_inv_0_0_p87_lanes[2];
  const Real Lambda_inv_0_1_p26 = c7 * Lambda_inv_0_1_p17 - s7 * Lambda_inv_0_0_p87_lanes[1];
  const Real Lambda_inv_0_0_p93 = c7 * Lambda_inv_0_0_p84 - s7 * Lambda_inv_0_0_p87_lanes[0];
  const Lanes Lambda_inv_0_0_p94_lanes = 0.4331 * detail::make_lanes<Real>(Lambda_inv_0_0_p93,
      Lambda_inv_0_1_p26, Lambda_inv_0_2_p26, Lambda_inv_0_3_p31_lanes[3],
      Lambda_inv_0_3_p31_lanes[4], Lambda_inv_0_3_p31_lanes[5], Lambda_inv_0_0_p93,
      Lambda_inv_0_0_p93);

  // link 8 (link5), force propagation
  const Real Lambda_inv_0_5_p30 = s8 * Lambda_inv_0_5_p19;
  const Real Lambda_inv_0_4_p34 = s8 * Lambda_inv_0_4_p23;
  const Real Lambda_inv_0_3_p33 = s8 * Lambda_inv_0_3_p22;

  // link 7 (link4), force propagation
  const Real Lambda_inv_0_2_p28 = -(s8 * Lambda_inv_0_2_p14 + c8 * Lambda_inv_0_2_p16);
  const Real Lambda_inv_0_1_p28 = -(s8 * Lambda_inv_0_1_p14 + c8 * Lambda_inv_0_1_p16);
  const Real Lambda_inv_0_0_p95 = -(s8 * Lambda_inv_0_0_p81 + c8 * Lambda_inv_0_0_p83);
  const Lanes Lambda_inv_0_0_p96_lanes = 0.0203 * detail::make_lanes<Real>(Lambda_inv_0_0_p95,
      Lambda_inv_0_1_p28, Lambda_inv_0_2_p28, Lambda_inv_0_3_p33, Lambda_inv_0_4_p34,
      Lambda_inv_0_5_p30, Lambda_inv_0_0_p95, Lambda_inv_0_0_p95);
  const Lanes Lambda_inv_0_0_p97_lanes = Lambda_inv_0_0_p96_lanes + Lambda_inv_0_0_p94_lanes;
  const Lanes Lambda_inv_0_0_p98_lanes = Lambda_inv_0_0_p92_lanes + Lambda_inv_0_0_p97_lanes;

  // link 6 (link3), force propagation
  const Lanes Lambda_inv_0_0_p99_lanes = inverse_D4_p3 * Lambda_inv_0_0_p98_lanes;
  const Lanes Lambda_inv_0_0_p100_lanes = Lambda_inv_0_0_p91_lanes - Lambda_inv_0_0_p99_lanes;
  const Lanes Lambda_inv_0_0_p101_lanes = c6 * Lambda_inv_0_0_p100_lanes;
  const Lanes Lambda_inv_0_0_p102_lanes = inverse_D4_p5 * Lambda_inv_0_0_p98_lanes;

  // link 7 (link4), force propagation
  const Lanes Lambda_inv_0_0_p103_lanes = 0.0203 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p89_lanes[0], Lambda_inv_0_0_p89_lanes[1],
      Lambda_inv_0_0_p89_lanes[2], Lambda_inv_0_3_p25, Lambda_inv_0_4_p26, Lambda_inv_0_5_p22,
      Lambda_inv_0_0_p89_lanes[0], Lambda_inv_0_0_p89_lanes[0]);

  // link 6 (link3), force propagation
  const Lanes Lambda_inv_0_0_p104_lanes = Lambda_inv_0_0_p103_lanes - Lambda_inv_0_0_p102_lanes;
  const Lanes Lambda_inv_0_0_p105_lanes = s6 * Lambda_inv_0_0_p104_lanes;
  const Lanes Lambda_inv_0_0_p106_lanes = Lambda_inv_0_0_p101_lanes - Lambda_inv_0_0_p105_lanes;
  const Lanes Lambda_inv_0_0_p107_lanes = Lambda_inv_0_0_p2 * Lambda_inv_0_0_p98_lanes;
  const Lanes Lambda_inv_0_0_p108_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p93,
      Lambda_inv_0_1_p26, Lambda_inv_0_2_p26, Lambda_inv_0_3_p31_lanes[3],
      Lambda_inv_0_3_p31_lanes[4], Lambda_inv_0_3_p31_lanes[5], Lambda_inv_0_0_p93,
      Lambda_inv_0_0_p93) - Lambda_inv_0_0_p107_lanes;
  const Lanes Lambda_inv_0_0_p109_lanes = s6 * Lambda_inv_0_0_p108_lanes;
  const Lanes Lambda_inv_0_0_p110_lanes = Lambda_inv_0_0_p12 * Lambda_inv_0_0_p98_lanes;
  const Lanes Lambda_inv_0_0_p111_lanes = detail::make_lanes<Real>(-Lambda_inv_0_0_p95,
      -Lambda_inv_0_1_p28, -Lambda_inv_0_2_p28, -Lambda_inv_0_3_p33, -Lambda_inv_0_4_p34,
      -Lambda_inv_0_5_p30, -Lambda_inv_0_0_p95, -Lambda_inv_0_0_p95) + Lambda_inv_0_0_p110_lanes;
  const Lanes Lambda_inv_0_0_p112_lanes = c6 * Lambda_inv_0_0_p111_lanes;
  const Lanes Lambda_inv_0_0_p113_lanes = Lambda_inv_0_0_p109_lanes + Lambda_inv_0_0_p112_lanes;
  const Lanes Lambda_inv_0_0_p114_lanes = 0.1501 * Lambda_inv_0_0_p113_lanes;
  const Lanes Lambda_inv_0_0_p115_lanes = Lambda_inv_0_0_p106_lanes - Lambda_inv_0_0_p114_lanes;
  const Lanes Lambda_inv_0_0_p116_lanes = 0.4318 * Lambda_inv_0_0_p113_lanes;
  const Lanes Lambda_inv_0_0_p117_lanes = s6 * Lambda_inv_0_0_p100_lanes;
  const Lanes Lambda_inv_0_0_p118_lanes = c6 * Lambda_inv_0_0_p104_lanes;
  const Lanes Lambda_inv_0_0_p119_lanes = Lambda_inv_0_0_p117_lanes + Lambda_inv_0_0_p118_lanes;
  const Lanes Lambda_inv_0_0_p120_lanes = c6 * Lambda_inv_0_0_p108_lanes;
  const Lanes Lambda_inv_0_0_p121_lanes = s6 * Lambda_inv_0_0_p111_lanes;
  const Lanes Lambda_inv_0_0_p122_lanes = Lambda_inv_0_0_p120_lanes - Lambda_inv_0_0_p121_lanes;
  const Lanes Lambda_inv_0_0_p123_lanes = 0.1501 * Lambda_inv_0_0_p122_lanes;
  const Lanes Lambda_inv_0_0_p124_lanes = Lambda_inv_0_0_p19 * Lambda_inv_0_0_p98_lanes;
  const Lanes Lambda_inv_0_0_p125_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p89_lanes[0],
      Lambda_inv_0_0_p89_lanes[1], Lambda_inv_0_0_p89_lanes[2], Lambda_inv_0_3_p25,
      Lambda_inv_0_4_p26, Lambda_inv_0_5_p22, Lambda_inv_0_0_p89_lanes[0],
      Lambda_inv_0_0_p89_lanes[0]) - Lambda_inv_0_0_p124_lanes;
  const Lanes Lambda_inv_0_0_p126_lanes = 0.4318 * Lambda_inv_0_0_p125_lanes;
  const Lanes Lambda_inv_0_0_p127_lanes = Lambda_inv_0_0_p123_lanes - Lambda_inv_0_0_p126_lanes;
  const Lanes Lambda_inv_0_0_p128_lanes = Lambda_inv_0_0_p119_lanes + Lambda_inv_0_0_p127_lanes;

  // link 4 (link1), force propagation
  const Real Lambda_inv_0_5_p64 = -(s5 * (Lambda_inv_0_0_p115_lanes[5] - inverse_D4_p10 *
      Lambda_inv_0_0_p116_lanes[5]) + c5 * (Lambda_inv_0_0_p128_lanes[5] - inverse_D4_p17 *
      Lambda_inv_0_0_p116_lanes[5]));
  const Real Lambda_inv_0_4_p68 = -(s5 * (Lambda_inv_0_0_p115_lanes[4] - inverse_D4_p10 *
      Lambda_inv_0_0_p116_lanes[4]) + c5 * (Lambda_inv_0_0_p128_lanes[4] - inverse_D4_p17 *
      Lambda_inv_0_0_p116_lanes[4]));
  const Real Lambda_inv_0_3_p67 = -(s5 * (Lambda_inv_0_0_p115_lanes[3] - inverse_D4_p10 *
      Lambda_inv_0_0_p116_lanes[3]) + c5 * (Lambda_inv_0_0_p128_lanes[3] - inverse_D4_p17 *
      Lambda_inv_0_0_p116_lanes[3]));
  const Real Lambda_inv_0_2_p62 = -(s5 * (Lambda_inv_0_0_p115_lanes[2] - inverse_D4_p10 *
      Lambda_inv_0_0_p116_lanes[2]) + c5 * (Lambda_inv_0_0_p128_lanes[2] - inverse_D4_p17 *
      Lambda_inv_0_0_p116_lanes[2]));
  const Real Lambda_inv_0_1_p62 = -(s5 * (Lambda_inv_0_0_p115_lanes[1] - inverse_D4_p10 *
      Lambda_inv_0_0_p116_lanes[1]) + c5 * (Lambda_inv_0_0_p128_lanes[1] - inverse_D4_p17 *
      Lambda_inv_0_0_p116_lanes[1]));
  const Real Lambda_inv_0_0_p129 = -(s5 * (Lambda_inv_0_0_p115_lanes[0] - inverse_D4_p10 *
      Lambda_inv_0_0_p116_lanes[0]) + c5 * (Lambda_inv_0_0_p128_lanes[0] - inverse_D4_p17 *
      Lambda_inv_0_0_p116_lanes[0]));
  const Lanes Lambda_inv_0_0_p130_lanes = Lambda_inv_0_0_p51 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p129, Lambda_inv_0_1_p62, Lambda_inv_0_2_p62,
      Lambda_inv_0_3_p67, Lambda_inv_0_4_p68, Lambda_inv_0_5_p64, Lambda_inv_0_0_p129,
      Lambda_inv_0_0_p129);
  const Real Lambda_inv_0_5_p66 = -(s5 * (Lambda_inv_0_0_p113_lanes[5] - Lambda_inv_0_0_p42 *
      Lambda_inv_0_0_p116_lanes[5]) - c5 * (Lambda_inv_0_0_p122_lanes[5] - Lambda_inv_0_0_p39 *
      Lambda_inv_0_0_p116_lanes[5]));
  const Real Lambda_inv_0_4_p70 = -(s5 * (Lambda_inv_0_0_p113_lanes[4] - Lambda_inv_0_0_p42 *
      Lambda_inv_0_0_p116_lanes[4]) - c5 * (Lambda_inv_0_0_p122_lanes[4] - Lambda_inv_0_0_p39 *
      Lambda_inv_0_0_p116_lanes[4]));
  const Real Lambda_inv_0_3_p69 = -(s5 * (Lambda_inv_0_0_p113_lanes[3] - Lambda_inv_0_0_p42 *
      Lambda_inv_0_0_p116_lanes[3]) - c5 * (Lambda_inv_0_0_p122_lanes[3] - Lambda_inv_0_0_p39 *
      Lambda_inv_0_0_p116_lanes[3]));
  const Real Lambda_inv_0_2_p64 = -(s5 * (Lambda_inv_0_0_p113_lanes[2] - Lambda_inv_0_0_p42 *
      Lambda_inv_0_0_p116_lanes[2]) - c5 * (Lambda_inv_0_0_p122_lanes[2] - Lambda_inv_0_0_p39 *
      Lambda_inv_0_0_p116_lanes[2]));
  const Real Lambda_inv_0_1_p64 = -(s5 * (Lambda_inv_0_0_p113_lanes[1] - Lambda_inv_0_0_p42 *
      Lambda_inv_0_0_p116_lanes[1]) - c5 * (Lambda_inv_0_0_p122_lanes[1] - Lambda_inv_0_0_p39 *
      Lambda_inv_0_0_p116_lanes[1]));
  const Real Lambda_inv_0_0_p131 = -(s5 * (Lambda_inv_0_0_p113_lanes[0] - Lambda_inv_0_0_p42 *
      Lambda_inv_0_0_p116_lanes[0]) - c5 * (Lambda_inv_0_0_p122_lanes[0] - Lambda_inv_0_0_p39 *
      Lambda_inv_0_0_p116_lanes[0]));
  const Lanes Lambda_inv_0_0_p132_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p131,
      Lambda_inv_0_1_p64, Lambda_inv_0_2_p64, Lambda_inv_0_3_p69, Lambda_inv_0_4_p70,
      Lambda_inv_0_5_p66, Lambda_inv_0_0_p131, Lambda_inv_0_0_p131) - Lambda_inv_0_0_p130_lanes;
  const Lanes Lambda_inv_0_0_p133_lanes = c4 * Lambda_inv_0_0_p132_lanes;
  const Lanes Lambda_inv_0_0_p134_lanes = Lambda_inv_0_0_p57 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p129, Lambda_inv_0_1_p62, Lambda_inv_0_2_p62,
      Lambda_inv_0_3_p67, Lambda_inv_0_4_p68, Lambda_inv_0_5_p64, Lambda_inv_0_0_p129,
      Lambda_inv_0_0_p129);

  // link 5 (link2), force propagation
  const Lanes Lambda_inv_0_0_p135_lanes = Lambda_inv_0_0_p55 * Lambda_inv_0_0_p116_lanes;
  const Lanes Lambda_inv_0_0_p136_lanes = Lambda_inv_0_0_p125_lanes - Lambda_inv_0_0_p135_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_inv_0_0_p137_lanes = Lambda_inv_0_0_p136_lanes + Lambda_inv_0_0_p134_lanes;
  const Lanes Lambda_inv_0_0_p138_lanes = s4 * Lambda_inv_0_0_p137_lanes;
  const Lanes Lambda_inv_0_0_p139_lanes = Lambda_inv_0_0_p133_lanes - Lambda_inv_0_0_p138_lanes;

  // link 3 (base), force propagation
  const Lanes Lambda_inv_0_0_p140_lanes = s3 * Lambda_inv_0_0_p139_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_inv_0_0_p141_lanes = s4 * Lambda_inv_0_0_p132_lanes;
  const Lanes Lambda_inv_0_0_p142_lanes = c4 * Lambda_inv_0_0_p137_lanes;
  const Lanes Lambda_inv_0_0_p143_lanes = Lambda_inv_0_0_p141_lanes + Lambda_inv_0_0_p142_lanes;

  // link 3 (base), force propagation
  const Lanes Lambda_inv_0_0_p144_lanes = c3 * Lambda_inv_0_0_p143_lanes;
  const Lanes Lambda_inv_0_0_p145_lanes = Lambda_inv_0_0_p140_lanes + Lambda_inv_0_0_p144_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_inv_0_0_p146_lanes = Lambda_inv_0_0_p67 * Lambda_inv_0_0_p145_lanes;

  // link 3 (base), force propagation
  const Lanes Lambda_inv_0_0_p147_lanes = c3 * Lambda_inv_0_0_p139_lanes;
  const Lanes Lambda_inv_0_0_p148_lanes = s3 * Lambda_inv_0_0_p143_lanes;
  const Lanes Lambda_inv_0_0_p149_lanes = Lambda_inv_0_0_p147_lanes - Lambda_inv_0_0_p148_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_inv_0_0_p150_lanes = Lambda_inv_0_0_p149_lanes - Lambda_inv_0_0_p146_lanes;

  // link 1 (base_x), articulated inertia
  const Real inverse_D1 = 1.0 / (186.45 + (Lambda_inv_0_0_p62 - inverse_D2_p1) -
      Lambda_inv_0_0_p66 * Lambda_inv_0_0_p67);

  // link 1 (base_x), force propagation
  const Lanes Lambda_inv_0_0_p151_lanes = Lambda_inv_0_0_p150_lanes * inverse_D1;
  const Lanes Lambda_inv_0_0_p152_lanes = Lambda_inv_0_0_p151_lanes * Lambda_inv_0_0_p150_lanes[0];

  // link 2 (base_y), force propagation
  const Lanes Lambda_inv_0_0_p153_lanes = Lambda_inv_0_0_p145_lanes * inverse_D2;
  const Lanes Lambda_inv_0_0_p154_lanes = Lambda_inv_0_0_p153_lanes * Lambda_inv_0_0_p145_lanes[0];

  // link 4 (link1), force propagation
  const Lanes Lambda_inv_0_0_p155_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p129,
      Lambda_inv_0_1_p62, Lambda_inv_0_2_p62, Lambda_inv_0_3_p67, Lambda_inv_0_4_p68,
      Lambda_inv_0_5_p64, Lambda_inv_0_0_p129, Lambda_inv_0_0_p129) * inverse_D4;
  const Lanes Lambda_inv_0_0_p156_lanes = Lambda_inv_0_0_p155_lanes * Lambda_inv_0_0_p129;

  // link 5 (link2), force propagation
  const Lanes Lambda_inv_0_0_p157_lanes = Lambda_inv_0_0_p116_lanes * inverse_D5;
  const Lanes Lambda_inv_0_0_p158_lanes = Lambda_inv_0_0_p157_lanes * Lambda_inv_0_0_p116_lanes[0];

  // link 6 (link3), force propagation
  const Lanes Lambda_inv_0_0_p159_lanes = Lambda_inv_0_0_p98_lanes * inverse_D6;
  const Lanes Lambda_inv_0_0_p160_lanes = Lambda_inv_0_0_p159_lanes * Lambda_inv_0_0_p98_lanes[0];

  // link 8 (link5), force propagation
  const Lanes Lambda_inv_0_0_p161_lanes = 1557.24430048586 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p80_lanes[0], Lambda_inv_0_0_p80_lanes[1],
      Lambda_inv_0_0_p80_lanes[2], Lambda_inv_0_3_p21_lanes[0], Lambda_inv_0_3_p21_lanes[1],
      Lambda_inv_0_3_p21_lanes[2], Lambda_inv_0_0_p80_lanes[0], Lambda_inv_0_0_p80_lanes[0]);
  const Lanes Lambda_inv_0_0_p162_lanes = Lambda_inv_0_0_p161_lanes * Lambda_inv_0_0_p80_lanes[0];

  // link 7 (link4), force propagation
  const Lanes Lambda_inv_0_0_p163_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p74,
      Lambda_inv_0_1_p7, Lambda_inv_0_2_p7, Lambda_inv_0_3_p15, Lambda_inv_0_4_p16,
      Lambda_inv_0_5_p12, Lambda_inv_0_0_p74, Lambda_inv_0_0_p74) * inverse_D7;
  const Lanes Lambda_inv_0_0_p164_lanes = Lambda_inv_0_0_p163_lanes * Lambda_inv_0_0_p74;
  const Lanes Lambda_inv_0_0_p165_lanes = Lambda_inv_0_0_p162_lanes + Lambda_inv_0_0_p164_lanes;

  // link 6 (link3), force propagation
  const Lanes Lambda_inv_0_0_p166_lanes = Lambda_inv_0_0_p165_lanes + Lambda_inv_0_0_p160_lanes;

  // link 5 (link2), force propagation
  const Lanes Lambda_inv_0_0_p167_lanes = Lambda_inv_0_0_p166_lanes + Lambda_inv_0_0_p158_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_inv_0_0_p168_lanes = Lambda_inv_0_0_p167_lanes + Lambda_inv_0_0_p156_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_inv_0_0_p169_lanes = Lambda_inv_0_0_p168_lanes + Lambda_inv_0_0_p154_lanes;

  // link 1 (base_x), force propagation
  const Lanes Lambda_inv_0_0_lanes = Lambda_inv_0_0_p169_lanes + Lambda_inv_0_0_p152_lanes;
  Lambda_inv[0] = Lambda_inv_0_0_lanes[0];
  Lambda_inv[1] = Lambda_inv_0_0_lanes[1];
  Lambda_inv[6] = Lambda_inv_0_0_lanes[1];
  Lambda_inv[2] = Lambda_inv_0_0_lanes[2];
  Lambda_inv[12] = Lambda_inv_0_0_lanes[2];
  Lambda_inv[3] = Lambda_inv_0_0_lanes[3];
  Lambda_inv[18] = Lambda_inv_0_0_lanes[3];
  Lambda_inv[4] = Lambda_inv_0_0_lanes[4];
  Lambda_inv[24] = Lambda_inv_0_0_lanes[4];
  Lambda_inv[5] = Lambda_inv_0_0_lanes[5];
  Lambda_inv[30] = Lambda_inv_0_0_lanes[5];
  const Lanes Lambda_inv_1_1_p1_lanes = Lambda_inv_0_0_p151_lanes * Lambda_inv_0_0_p150_lanes[1];

  // link 2 (base_y), force propagation
  const Lanes Lambda_inv_1_1_p2_lanes = Lambda_inv_0_0_p153_lanes * Lambda_inv_0_0_p145_lanes[1];

  // link 4 (link1), force propagation
  const Lanes Lambda_inv_1_1_p3_lanes = Lambda_inv_0_0_p155_lanes * Lambda_inv_0_1_p62;

  // link 5 (link2), force propagation
  const Lanes Lambda_inv_1_1_p4_lanes = Lambda_inv_0_0_p157_lanes * Lambda_inv_0_0_p116_lanes[1];

  // link 6 (link3), force propagation
  const Lanes Lambda_inv_1_1_p5_lanes = Lambda_inv_0_0_p159_lanes * Lambda_inv_0_0_p98_lanes[1];

  // link 8 (link5), force propagation
  const Lanes Lambda_inv_1_1_p6_lanes = Lambda_inv_0_0_p161_lanes * Lambda_inv_0_0_p80_lanes[1];

  // link 7 (link4), force propagation
  const Lanes Lambda_inv_1_1_p7_lanes = Lambda_inv_0_0_p163_lanes * Lambda_inv_0_1_p7;
  const Lanes Lambda_inv_1_1_p8_lanes = Lambda_inv_1_1_p6_lanes + Lambda_inv_1_1_p7_lanes;

  // link 6 (link3), force propagation
  const Lanes Lambda_inv_1_1_p9_lanes = Lambda_inv_1_1_p8_lanes + Lambda_inv_1_1_p5_lanes;

  // link 5 (link2), force propagation
  const Lanes Lambda_inv_1_1_p10_lanes = Lambda_inv_1_1_p9_lanes + Lambda_inv_1_1_p4_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_inv_1_1_p11_lanes = Lambda_inv_1_1_p10_lanes + Lambda_inv_1_1_p3_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_inv_1_1_p12_lanes = Lambda_inv_1_1_p11_lanes + Lambda_inv_1_1_p2_lanes;

  // link 1 (base_x), force propagation
  const Lanes Lambda_inv_1_1_lanes = Lambda_inv_1_1_p12_lanes + Lambda_inv_1_1_p1_lanes;
  Lambda_inv[7] = Lambda_inv_1_1_lanes[1];
  Lambda_inv[8] = Lambda_inv_1_1_lanes[2];
  Lambda_inv[13] = Lambda_inv_1_1_lanes[2];
  Lambda_inv[9] = Lambda_inv_1_1_lanes[3];
  Lambda_inv[19] = Lambda_inv_1_1_lanes[3];
  Lambda_inv[10] = Lambda_inv_1_1_lanes[4];
  Lambda_inv[25] = Lambda_inv_1_1_lanes[4];
  Lambda_inv[11] = Lambda_inv_1_1_lanes[5];
  Lambda_inv[31] = Lambda_inv_1_1_lanes[5];
  const Lanes Lambda_inv_2_2_p1_lanes = Lambda_inv_0_0_p151_lanes * Lambda_inv_0_0_p150_lanes[2];

  // link 2 (base_y), force propagation
  const Lanes Lambda_inv_2_2_p2_lanes = Lambda_inv_0_0_p153_lanes * Lambda_inv_0_0_p145_lanes[2];

  // link 4 (link1), force propagation
  const Lanes Lambda_inv_2_2_p3_lanes = Lambda_inv_0_0_p155_lanes * Lambda_inv_0_2_p62;

  // link 5 (link2), force propagation
  const Lanes Lambda_inv_2_2_p4_lanes = Lambda_inv_0_0_p157_lanes * Lambda_inv_0_0_p116_lanes[2];

  // link 6 (link3), force propagation
  const Lanes Lambda_inv_2_2_p5_lanes = Lambda_inv_0_0_p159_lanes * Lambda_inv_0_0_p98_lanes[2];

  // link 8 (link5), force propagation
  const Lanes Lambda_inv_2_2_p6_lanes = Lambda_inv_0_0_p161_lanes * Lambda_inv_0_0_p80_lanes[2];

  // link 7 (link4), force propagation
  const Lanes Lambda_inv_2_2_p7_lanes = Lambda_inv_0_0_p163_lanes * Lambda_inv_0_2_p7;
  const Lanes Lambda_inv_2_2_p8_lanes = Lambda_inv_2_2_p6_lanes + Lambda_inv_2_2_p7_lanes;

  // link 6 (link3), force propagation
  const Lanes Lambda_inv_2_2_p9_lanes = Lambda_inv_2_2_p8_lanes + Lambda_inv_2_2_p5_lanes;

  // link 5 (link2), force propagation
  const Lanes Lambda_inv_2_2_p10_lanes = Lambda_inv_2_2_p9_lanes + Lambda_inv_2_2_p4_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_inv_2_2_p11_lanes = Lambda_inv_2_2_p10_lanes + Lambda_inv_2_2_p3_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_inv_2_2_p12_lanes = Lambda_inv_2_2_p11_lanes + Lambda_inv_2_2_p2_lanes;

  // link 1 (base_x), force propagation
  const Lanes Lambda_inv_2_2_lanes = Lambda_inv_2_2_p12_lanes + Lambda_inv_2_2_p1_lanes;
  Lambda_inv[14] = Lambda_inv_2_2_lanes[2];
  Lambda_inv[15] = Lambda_inv_2_2_lanes[3];
  Lambda_inv[20] = Lambda_inv_2_2_lanes[3];
  Lambda_inv[16] = Lambda_inv_2_2_lanes[4];
  Lambda_inv[26] = Lambda_inv_2_2_lanes[4];
  Lambda_inv[17] = Lambda_inv_2_2_lanes[5];
  Lambda_inv[32] = Lambda_inv_2_2_lanes[5];
  const Lanes Lambda_inv_3_3_p1_lanes = Lambda_inv_0_0_p151_lanes * Lambda_inv_0_0_p150_lanes[3];

  // link 2 (base_y), force propagation
  const Lanes Lambda_inv_3_3_p2_lanes = Lambda_inv_0_0_p153_lanes * Lambda_inv_0_0_p145_lanes[3];

  // link 4 (link1), force propagation
  const Lanes Lambda_inv_3_3_p3_lanes = Lambda_inv_0_0_p155_lanes * Lambda_inv_0_3_p67;

  // link 5 (link2), force propagation
  const Lanes Lambda_inv_3_3_p4_lanes = Lambda_inv_0_0_p157_lanes * Lambda_inv_0_0_p116_lanes[3];

  // link 6 (link3), force propagation
  const Lanes Lambda_inv_3_3_p5_lanes = Lambda_inv_0_0_p159_lanes * Lambda_inv_0_0_p98_lanes[3];

  // link 8 (link5), force propagation
  const Lanes Lambda_inv_3_3_p6_lanes = Lambda_inv_0_0_p161_lanes * Lambda_inv_0_3_p21_lanes[0];

  // link 9 (link6), force propagation
  const Lanes Lambda_inv_3_3_p7_lanes = 24999.999999999996 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p82, Lambda_inv_0_0_p82, Lambda_inv_0_0_p82,
      Lambda_inv_0_0_p82, Lambda_inv_0_1_p15, Lambda_inv_0_2_p15, Lambda_inv_0_0_p82,
      Lambda_inv_0_0_p82);
  const Lanes Lambda_inv_3_3_p8_lanes = Lambda_inv_3_3_p7_lanes * Lambda_inv_0_0_p82;

  // link 8 (link5), force propagation
  const Lanes Lambda_inv_3_3_p9_lanes = Lambda_inv_3_3_p8_lanes + Lambda_inv_3_3_p6_lanes;

  // link 7 (link4), force propagation
  const Lanes Lambda_inv_3_3_p10_lanes = Lambda_inv_0_0_p163_lanes * Lambda_inv_0_3_p15;
  const Lanes Lambda_inv_3_3_p11_lanes = Lambda_inv_3_3_p9_lanes + Lambda_inv_3_3_p10_lanes;

  // link 6 (link3), force propagation
  const Lanes Lambda_inv_3_3_p12_lanes = Lambda_inv_3_3_p11_lanes + Lambda_inv_3_3_p5_lanes;

  // link 5 (link2), force propagation
  const Lanes Lambda_inv_3_3_p13_lanes = Lambda_inv_3_3_p12_lanes + Lambda_inv_3_3_p4_lanes;

  // link 4 (link1), force propagation
  const Lanes Lambda_inv_3_3_p14_lanes = Lambda_inv_3_3_p13_lanes + Lambda_inv_3_3_p3_lanes;

  // link 2 (base_y), force propagation
  const Lanes Lambda_inv_3_3_p15_lanes = Lambda_inv_3_3_p14_lanes + Lambda_inv_3_3_p2_lanes;

  // link 1 (base_x), force propagation
  const Lanes Lambda_inv_3_3_lanes = Lambda_inv_3_3_p15_lanes + Lambda_inv_3_3_p1_lanes;
  Lambda_inv[21] = Lambda_inv_3_3_lanes[3];
  Lambda_inv[22] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[27] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[23] = Lambda_inv_3_3_lanes[5];
  Lambda_inv[33] = Lambda_inv_3_3_lanes[5];

  // link 9 (link6), force propagation
  const Lanes Lambda_inv_4_4_p1_lanes = Lambda_inv_3_3_p7_lanes * Lambda_inv_0_1_p15;

  // link 8 (link5), force propagation
  const Lanes Lambda_inv_4_4_p2_lanes = Lambda_inv_4_4_p1_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p161_lanes[4] * Lambda_inv_0_3_p21_lanes[1],
      Lambda_inv_0_0_p161_lanes[4] * Lambda_inv_0_3_p21_lanes[1], Lambda_inv_0_0_p161_lanes[4] *
      Lambda_inv_0_3_p21_lanes[1], Lambda_inv_0_0_p161_lanes[4] * Lambda_inv_0_3_p21_lanes[1],
      Lambda_inv_0_0_p161_lanes[4] * Lambda_inv_0_3_p21_lanes[1], Lambda_inv_0_0_p161_lanes[5] *
      Lambda_inv_0_3_p21_lanes[1], Lambda_inv_0_0_p161_lanes[4] * Lambda_inv_0_3_p21_lanes[1],
      Lambda_inv_0_0_p161_lanes[4] * Lambda_inv_0_3_p21_lanes[1]);

  // link 7 (link4), force propagation
  const Lanes Lambda_inv_4_4_p3_lanes = Lambda_inv_4_4_p2_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p163_lanes[4] * Lambda_inv_0_4_p16,
      Lambda_inv_0_0_p163_lanes[4] * Lambda_inv_0_4_p16, Lambda_inv_0_0_p163_lanes[4] *
      Lambda_inv_0_4_p16, Lambda_inv_0_0_p163_lanes[4] * Lambda_inv_0_4_p16,
      Lambda_inv_0_0_p163_lanes[4] * Lambda_inv_0_4_p16, Lambda_inv_0_0_p163_lanes[5] *
      Lambda_inv_0_4_p16, Lambda_inv_0_0_p163_lanes[4] * Lambda_inv_0_4_p16,
      Lambda_inv_0_0_p163_lanes[4] * Lambda_inv_0_4_p16);

  // link 6 (link3), force propagation
  const Lanes Lambda_inv_4_4_p4_lanes = Lambda_inv_4_4_p3_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p159_lanes[4] * Lambda_inv_0_0_p98_lanes[4],
      Lambda_inv_0_0_p159_lanes[4] * Lambda_inv_0_0_p98_lanes[4], Lambda_inv_0_0_p159_lanes[4] *
      Lambda_inv_0_0_p98_lanes[4], Lambda_inv_0_0_p159_lanes[4] * Lambda_inv_0_0_p98_lanes[4],
      Lambda_inv_0_0_p159_lanes[4] * Lambda_inv_0_0_p98_lanes[4], Lambda_inv_0_0_p159_lanes[5] *
      Lambda_inv_0_0_p98_lanes[4], Lambda_inv_0_0_p159_lanes[4] * Lambda_inv_0_0_p98_lanes[4],
      Lambda_inv_0_0_p159_lanes[4] * Lambda_inv_0_0_p98_lanes[4]);

  // link 5 (link2), force propagation
  const Lanes Lambda_inv_4_4_p5_lanes = Lambda_inv_4_4_p4_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p157_lanes[4] * Lambda_inv_0_0_p116_lanes[4],
      Lambda_inv_0_0_p157_lanes[4] * Lambda_inv_0_0_p116_lanes[4], Lambda_inv_0_0_p157_lanes[4] *
      Lambda_inv_0_0_p116_lanes[4], Lambda_inv_0_0_p157_lanes[4] * Lambda_inv_0_0_p116_lanes[4],
      Lambda_inv_0_0_p157_lanes[4] * Lambda_inv_0_0_p116_lanes[4], Lambda_inv_0_0_p157_lanes[5] *
      Lambda_inv_0_0_p116_lanes[4], Lambda_inv_0_0_p157_lanes[4] * Lambda_inv_0_0_p116_lanes[4],
      Lambda_inv_0_0_p157_lanes[4] * Lambda_inv_0_0_p116_lanes[4]);

  // link 4 (link1), force propagation
  const Lanes Lambda_inv_4_4_p6_lanes = Lambda_inv_4_4_p5_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p155_lanes[4] * Lambda_inv_0_4_p68,
      Lambda_inv_0_0_p155_lanes[4] * Lambda_inv_0_4_p68, Lambda_inv_0_0_p155_lanes[4] *
      Lambda_inv_0_4_p68, Lambda_inv_0_0_p155_lanes[4] * Lambda_inv_0_4_p68,
      Lambda_inv_0_0_p155_lanes[4] * Lambda_inv_0_4_p68, Lambda_inv_0_0_p155_lanes[5] *
      Lambda_inv_0_4_p68, Lambda_inv_0_0_p155_lanes[4] * Lambda_inv_0_4_p68,
      Lambda_inv_0_0_p155_lanes[4] * Lambda_inv_0_4_p68);

  // link 2 (base_y), force propagation
  const Lanes Lambda_inv_4_4_p7_lanes = Lambda_inv_4_4_p6_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p153_lanes[4] * Lambda_inv_0_0_p145_lanes[4],
      Lambda_inv_0_0_p153_lanes[4] * Lambda_inv_0_0_p145_lanes[4], Lambda_inv_0_0_p153_lanes[4] *
      Lambda_inv_0_0_p145_lanes[4], Lambda_inv_0_0_p153_lanes[4] * Lambda_inv_0_0_p145_lanes[4],
      Lambda_inv_0_0_p153_lanes[4] * Lambda_inv_0_0_p145_lanes[4], Lambda_inv_0_0_p153_lanes[5] *
      Lambda_inv_0_0_p145_lanes[4], Lambda_inv_0_0_p153_lanes[4] * Lambda_inv_0_0_p145_lanes[4],
      Lambda_inv_0_0_p153_lanes[4] * Lambda_inv_0_0_p145_lanes[4]);

  // link 1 (base_x), force propagation
  const Lanes Lambda_inv_4_4_lanes = Lambda_inv_4_4_p7_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p151_lanes[4] * Lambda_inv_0_0_p150_lanes[4],
      Lambda_inv_0_0_p151_lanes[4] * Lambda_inv_0_0_p150_lanes[4], Lambda_inv_0_0_p151_lanes[4] *
      Lambda_inv_0_0_p150_lanes[4], Lambda_inv_0_0_p151_lanes[4] * Lambda_inv_0_0_p150_lanes[4],
      Lambda_inv_0_0_p151_lanes[4] * Lambda_inv_0_0_p150_lanes[4], Lambda_inv_0_0_p151_lanes[5] *
      Lambda_inv_0_0_p150_lanes[4], Lambda_inv_0_0_p151_lanes[4] * Lambda_inv_0_0_p150_lanes[4],
      Lambda_inv_0_0_p151_lanes[4] * Lambda_inv_0_0_p150_lanes[4]);
  Lambda_inv[28] = Lambda_inv_4_4_lanes[4];
  Lambda_inv[29] = Lambda_inv_4_4_lanes[5];
  Lambda_inv[34] = Lambda_inv_4_4_lanes[5];

  // link 5 (link2), force propagation
  const Real Lambda_inv_5_5_p1 = Lambda_inv_3_3_p7_lanes[5] * Lambda_inv_0_2_p15 +
      Lambda_inv_0_0_p161_lanes[5] * Lambda_inv_0_3_p21_lanes[2] + Lambda_inv_0_0_p163_lanes[5] *
      Lambda_inv_0_5_p12 + Lambda_inv_0_0_p159_lanes[5] * Lambda_inv_0_0_p98_lanes[5] +
      Lambda_inv_0_0_p157_lanes[5] * Lambda_inv_0_0_p116_lanes[5];

  // link 1 (base_x), force propagation
  Lambda_inv[35] = Lambda_inv_5_5_p1 + Lambda_inv_0_0_p155_lanes[5] * Lambda_inv_0_5_p64 +
      Lambda_inv_0_0_p153_lanes[5] * Lambda_inv_0_0_p145_lanes[5] + Lambda_inv_0_0_p151_lanes[5] *
      Lambda_inv_0_0_p150_lanes[5];
}

}  // namespace samm

#undef TREELINE_RESTRICT
