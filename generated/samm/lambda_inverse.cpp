// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By force propagation with branching (Chang table 5.3), in the axes of link 9 (link6) at the points.
// 732 flops (add 323, mul 403, div 6), sine and cosine of 6 angles
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
  const Real angles[6] = {q[7], q[6], q[4], q[5], q[2], q[3]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real s8 = sines[0];
  const Real s7 = sines[1];
  const Real s5 = sines[2];
  const Real c6 = cosines[3];
  const Real c5 = cosines[2];
  const Real s6 = sines[3];
  const Real c7 = cosines[1];
  const Real c8 = cosines[0];
  const Real s3 = sines[4];
  const Real c4 = cosines[5];
  const Real c3 = cosines[4];
  const Real s4 = sines[5];

  // link 8 (link5), articulated inertia
  const Real inverse_D7_p1 = 0.00024215999999999997 * s8;
  const Real inverse_D6_p1 = 0.0028799999999999997 * s8;
  const Real inverse_D6_p2 = 0.012916407125949915 * s8;
  const Real inverse_D5_p1 = 0.4318 * c5;
  const Real inverse_D5_p2 = 0.4318 * s5;
  const Real inverse_D7_p2 = s8 * inverse_D7_p1;
  const Real inverse_D6_p3 = s8 * inverse_D6_p2;
  const Real inverse_D6_p4 = c8 * inverse_D6_p2;
  const Real inverse_D6_p5 = c8 * inverse_D7_p1;
  const Real inverse_D6_p6 = s5 * s6 - c5 * c6;
  const Real inverse_D4_p1 = s5 * c6 + c5 * s6;
  const Real inverse_D6_p7 = inverse_D6_p3 - 0.012916407125949915;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p8 = 2.0 * inverse_D6_p6;
  const Real inverse_D6_p9 = c7 * inverse_D6_p4;
  const Real inverse_D4_p2 = s7 * inverse_D6_p4;
  const Real inverse_D7 = 1.0 / (0.0016 + inverse_D7_p2);
  const Real inverse_D4_p3 = 0.0203 * inverse_D4_p1 - 0.4331 * inverse_D6_p6;
  const Real inverse_D4_p4 = 0.0203 * inverse_D6_p6 + 0.4331 * inverse_D4_p1;
  const Real inverse_D4_p5 = 0.025374999999999998 * inverse_D6_p6 + 0.861795 * inverse_D4_p1;
  const Real inverse_D6_p10 = inverse_D6_p1 * inverse_D7;
  const Real inverse_D6_p11 = inverse_D6_p5 * inverse_D7;
  const Real inverse_D6_p12 = inverse_D6_p1 * inverse_D6_p10;
  const Real inverse_D6_p13 = inverse_D6_p5 * inverse_D6_p10 - 0.0028799999999999997 * c8;
  const Real inverse_D6_p14 = 0.0011921599999999998 - inverse_D7_p2 - inverse_D6_p5 *
      inverse_D6_p11;
  const Real inverse_D6_p15 = s7 * (inverse_D6_p7 + inverse_D6_p12);
  const Real inverse_D6_p16 = c7 * inverse_D6_p13;
  const Real inverse_D6_p17 = s7 * (inverse_D6_p14 - 0.00065);
  const Real inverse_D6_p18 = s7 * inverse_D6_p15;
  const Real inverse_D6_p19 = c7 * inverse_D6_p16;
  const Real inverse_D4_p6 = c7 * inverse_D6_p15;
  const Real inverse_D4_p7 = s7 * inverse_D6_p16;
  const Real inverse_D6_p20 = s7 * inverse_D6_p17;
  const Real inverse_D6_p21 = inverse_D6_p7 - inverse_D6_p18;
  const Real inverse_D6_p22 = inverse_D6_p19 - inverse_D6_p13;
  const Real inverse_D4_p8 = inverse_D4_p1 * inverse_D4_p7;
  const Real inverse_D4_p9 = inverse_D6_p18 - inverse_D6_p12;
  const Real inverse_D4_p10 = inverse_D4_p1 * inverse_D6_p19;
  const Real inverse_D6_p23 = inverse_D4_p1 * inverse_D6_p22;
  const Real inverse_D6_p24 = inverse_D6_p6 * inverse_D6_p22;
  const Real inverse_D4_p11 = inverse_D6_p6 * inverse_D4_p6 - inverse_D4_p1 * inverse_D4_p2;
  const Real inverse_D4_p12 = inverse_D4_p1 * inverse_D4_p6 + inverse_D6_p6 * inverse_D4_p2;
  const Real inverse_D4_p13 = inverse_D4_p1 * inverse_D4_p8;
  const Real inverse_D4_p14 = inverse_D6_p6 * inverse_D4_p8;
  const Real inverse_D4_p15 = inverse_D4_p4 * inverse_D4_p12;
  const Real inverse_D4_p16 = inverse_D4_p4 * inverse_D4_p9 - inverse_D4_p10;
  const Real inverse_D6_p25 = inverse_D4_p1 * (inverse_D6_p21 + inverse_D6_p3) + inverse_D6_p8 *
      inverse_D6_p9;
  const Real inverse_D2_p1 = s3 * c4 + c3 * s4;
  const Real inverse_D6_p26 = inverse_D4_p1 * inverse_D6_p25;
  const Real inverse_D4_p17 = inverse_D4_p7 - (inverse_D4_p3 * inverse_D4_p11 - inverse_D4_p15);
  const Real inverse_D2_p2 = c3 * c4 - s3 * s4;
  const Real inverse_D6_p27 = inverse_D6_p9 - inverse_D6_p6 * inverse_D6_p25;
  const Real inverse_D6_p28 = inverse_D6_p26 - inverse_D6_p3;
  const Real inverse_D6_p29 = inverse_D6_p21 - inverse_D6_p26;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p18 = 3.153482265 - s5 * (1.601861202 * s5 + 0.0141984 * c5) +
      inverse_D4_p4 * (inverse_D4_p16 - inverse_D4_p10);

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p3 = 2.0 * inverse_D2_p2;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p30 = inverse_D6_p23 + (inverse_D4_p3 * inverse_D6_p27 + inverse_D4_p4 *
      inverse_D6_p28);
  const Real inverse_D6_p31 = inverse_D6_p24 - (inverse_D4_p3 * inverse_D6_p29 + inverse_D4_p4 *
      inverse_D6_p27);
  const Real inverse_D5_p3 = inverse_D4_p5 + inverse_D6_p30;
  const Real inverse_D5_p4 = inverse_D6_p31 - (0.025374999999999998 * inverse_D4_p1 - 0.861795 *
      inverse_D6_p6);
  const Real inverse_D4_p19 = 0.004704000000000001 * inverse_D6_p6 +
      (inverse_D4_p4 * (inverse_D4_p13 + inverse_D4_p17) - inverse_D4_p3 * inverse_D4_p14 -
      inverse_D4_p1 * (c7 * inverse_D6_p17));
  const Real inverse_D6_p32 = 0.312455249 + (0.00065 + inverse_D6_p20 +
      (inverse_D4_p4 * (inverse_D6_p23 + inverse_D6_p30) - inverse_D4_p3 *
      (inverse_D6_p24 + inverse_D6_p31)));

  // link 6 (link3), articulated inertia
  const Real inverse_D6 = 1.0 / inverse_D6_p32;
  const Real inverse_D5_p5 = inverse_D5_p3 * inverse_D6;
  const Real inverse_D5_p6 = inverse_D5_p4 * inverse_D6;
  const Real inverse_D4_p20 = inverse_D4_p17 * inverse_D6;
  const Real inverse_D4_p21 = inverse_D4_p19 * inverse_D6;
  const Real inverse_D5_p7 = inverse_D6_p27 + inverse_D5_p4 * inverse_D5_p5;
  const Real inverse_D5_p8 = inverse_D6_p29 - inverse_D5_p4 * inverse_D5_p6;
  const Real inverse_D4_p22 = inverse_D4_p11 - inverse_D5_p4 * inverse_D4_p20;
  const Real inverse_D4_p23 = inverse_D4_p14 + inverse_D4_p4 * inverse_D4_p11 - inverse_D4_p19 *
      inverse_D5_p6;
  const Real inverse_D4_p24 = inverse_D4_p9 - inverse_D4_p17 * inverse_D4_p20;
  const Real inverse_D4_p25 = inverse_D4_p5 + inverse_D4_p16 - inverse_D4_p19 * inverse_D4_p20;
  const Real inverse_D5_p9 = inverse_D5_p1 * inverse_D5_p7 - inverse_D5_p2 * inverse_D5_p8;
  const Real inverse_D4_p26 = inverse_D5_p1 * (inverse_D5_p3 * inverse_D4_p20 - inverse_D4_p12) -
      inverse_D5_p2 * inverse_D4_p22;
  const Real inverse_D2_p4 = 3.79559 * s5 + 0.10439999999999999 * c5 - inverse_D5_p9;
  const Real inverse_D4_p27 = inverse_D4_p23 + (inverse_D5_p1 * inverse_D4_p22 + 0.1501 *
      inverse_D5_p8);
  const Real inverse_D4_p28 = inverse_D4_p25 + (inverse_D5_p1 * inverse_D4_p24 + 0.1501 *
      inverse_D4_p22);
  const Real inverse_D5_p10 = inverse_D5_p1 * (inverse_D5_p1 *
      (inverse_D6_p28 - inverse_D5_p3 * inverse_D5_p5) - inverse_D5_p2 * inverse_D5_p7) -
      inverse_D5_p2 * inverse_D5_p9;

  // link 5 (link2), articulated inertia
  const Real inverse_D5 = 1.0 / (1.7481140020000001 + inverse_D5_p10);

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p29 = inverse_D5_p2 * inverse_D4_p23 - inverse_D5_p1 *
      (inverse_D4_p19 * inverse_D5_p5 - (inverse_D4_p13 + inverse_D4_p15) + inverse_D4_p26) -
      0.1501 * inverse_D5_p9;
  const Real inverse_D4_p30 = 0.690314699 * s5 + 0.023750999999999998 * c5 + inverse_D4_p29;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p31 = inverse_D4_p18 - inverse_D4_p19 * inverse_D4_p21 + 0.1501 *
      (inverse_D4_p23 + inverse_D4_p27) + inverse_D5_p1 * (inverse_D4_p25 + inverse_D4_p28);
  const Real inverse_D4_p32 = inverse_D4_p30 * inverse_D5;
  const Real inverse_D2_p5 = inverse_D2_p4 * inverse_D5;
  const Real inverse_D2_p6 = inverse_D4_p26 * inverse_D5;
  const Real inverse_D2_p7 = inverse_D4_p28 - (0.10439999999999999 * s5 - 3.79559 * c5) +
      inverse_D4_p30 * inverse_D2_p6;
  const Real inverse_D4_p33 = inverse_D4_p31 - inverse_D4_p30 * inverse_D4_p32 +
      (0.298925024 * inverse_D4_p1 + 0.021347276999999998 * inverse_D6_p6 + inverse_D4_p1 *
      (inverse_D6_p14 - inverse_D6_p20)) * inverse_D4_p1;
  const Real inverse_D2_p8 = 4.9338049999999996 + (inverse_D4_p27 - inverse_D4_p30 * inverse_D2_p5);

  // link 4 (link1), articulated inertia
  const Real inverse_D4 = 1.0 / inverse_D4_p33;
  const Real inverse_D2_p9 = inverse_D2_p8 * inverse_D4;
  const Real inverse_D2_p10 = inverse_D2_p7 * inverse_D4;
  const Real inverse_D2_p11 = inverse_D5_p8 - inverse_D2_p4 * inverse_D2_p5 - inverse_D2_p8 *
      inverse_D2_p9;
  const Real inverse_D2_p12 = inverse_D4_p24 - inverse_D4_p26 * inverse_D2_p6 - inverse_D2_p7 *
      inverse_D2_p10;
  const Real inverse_D2_p13 = inverse_D2_p8 * inverse_D2_p10 -
      (inverse_D4_p22 + inverse_D2_p4 * inverse_D2_p6);
  const Real inverse_D2_p14 = inverse_D2_p1 * (inverse_D2_p11 - inverse_D2_p12) + inverse_D2_p3 *
      inverse_D2_p13;
  const Real inverse_D2_p15 = inverse_D2_p1 * inverse_D2_p14;
  const Real inverse_D1_p1 = inverse_D2_p2 * inverse_D2_p14 - inverse_D2_p13;

  // link 2 (base_y), articulated inertia
  const Real inverse_D2 = 1.0 / (186.45 + (inverse_D2_p12 + inverse_D2_p15));
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 1 (base_x), articulated inertia
  const Real inverse_D1 = 1.0 / (186.45 + (inverse_D2_p11 - inverse_D2_p15) - inverse_D1_p1 *
      inverse_D1_p2);

  // link 2 (base_y), mobility
  const Real Lambda_inv_0_0_p1 = inverse_D1 * inverse_D1_p2;
  const Real Lambda_inv_0_0_p2 = inverse_D2 + inverse_D1_p2 * Lambda_inv_0_0_p1;

  // link 4 (link1), mobility
  const Real Lambda_inv_0_0_p3 = inverse_D2_p1 * (inverse_D1 - Lambda_inv_0_0_p2) + inverse_D2_p3 *
      Lambda_inv_0_0_p1;
  const Real Lambda_inv_0_0_p4 = inverse_D2_p1 * Lambda_inv_0_0_p3;
  const Real Lambda_inv_0_0_p5 = inverse_D1 - Lambda_inv_0_0_p4;
  const Real Lambda_inv_0_0_p6 = Lambda_inv_0_0_p1 - inverse_D2_p2 * Lambda_inv_0_0_p3;
  const Real Lambda_inv_0_0_p7 = Lambda_inv_0_0_p2 + Lambda_inv_0_0_p4;
  const Real Lambda_inv_0_0_p8 = Lambda_inv_0_0_p6 * inverse_D2_p10 - Lambda_inv_0_0_p5 *
      inverse_D2_p9;
  const Real Lambda_inv_0_0_p9 = Lambda_inv_0_0_p7 * inverse_D2_p10 - Lambda_inv_0_0_p6 *
      inverse_D2_p9;

  // link 7 (link4), mobility
  const Real Lambda_inv_0_0_p10 = 2.0 * c7;

  // link 5 (link2), mobility
  const Real Lambda_inv_0_0_p11 = Lambda_inv_0_0_p5 * inverse_D2_p5 + Lambda_inv_0_0_p6 *
      inverse_D2_p6 + Lambda_inv_0_0_p8 * inverse_D4_p32;
  const Real Lambda_inv_0_0_p12 = Lambda_inv_0_0_p6 * inverse_D2_p5 + Lambda_inv_0_0_p7 *
      inverse_D2_p6 + Lambda_inv_0_0_p9 * inverse_D4_p32;

  // link 4 (link1), mobility
  const Real Lambda_inv_0_0_p13 = inverse_D4 + (inverse_D2_p10 * Lambda_inv_0_0_p9 - inverse_D2_p9 *
      Lambda_inv_0_0_p8);

  // link 8 (link5), mobility
  const Real Lambda_inv_0_0_p14 = 2.0 * c8;

  // link 5 (link2), mobility
  const Real Lambda_inv_0_0_p15 = Lambda_inv_0_0_p8 * inverse_D2_p5 + Lambda_inv_0_0_p9 *
      inverse_D2_p6 + Lambda_inv_0_0_p13 * inverse_D4_p32;

  // link 6 (link3), mobility
  const Real Lambda_inv_0_0_p16 = inverse_D5_p1 * Lambda_inv_0_0_p13 - Lambda_inv_0_0_p9;
  const Real Lambda_inv_0_0_p17 = inverse_D5_p1 * Lambda_inv_0_0_p15;

  // link 7 (link4), mobility
  const Real Lambda_inv_0_0_p18 = Lambda_inv_0_0_p16 + inverse_D4_p4 * Lambda_inv_0_0_p13;

  // link 6 (link3), mobility
  const Real Lambda_inv_0_0_p19 = Lambda_inv_0_0_p12 - Lambda_inv_0_0_p17;

  // link 5 (link2), mobility
  const Real Lambda_inv_0_0_p20 = inverse_D5 + (inverse_D2_p5 * Lambda_inv_0_0_p11 + inverse_D2_p6 *
      Lambda_inv_0_0_p12 + inverse_D4_p32 * Lambda_inv_0_0_p15);

  // link 6 (link3), mobility
  const Real Lambda_inv_0_0_p21 = Lambda_inv_0_0_p8 -
      (inverse_D5_p2 * Lambda_inv_0_0_p15 - 0.1501 * Lambda_inv_0_0_p13);
  const Real Lambda_inv_0_0_p22 = inverse_D5_p1 * Lambda_inv_0_0_p19;
  const Real Lambda_inv_0_0_p23 = Lambda_inv_0_0_p7 + inverse_D5_p1 *
      (Lambda_inv_0_0_p16 - Lambda_inv_0_0_p9);
  const Real Lambda_inv_0_0_p24 = inverse_D5_p1 * Lambda_inv_0_0_p20;

  // link 7 (link4), mobility
  const Real Lambda_inv_0_0_p25 = Lambda_inv_0_0_p23 + inverse_D4_p4 *
      (Lambda_inv_0_0_p16 + Lambda_inv_0_0_p18);

  // link 6 (link3), mobility
  const Real Lambda_inv_0_0_p26 = inverse_D5_p1 * Lambda_inv_0_0_p24;
  const Real Lambda_inv_0_0_p27 = inverse_D5_p2 * Lambda_inv_0_0_p19 + inverse_D5_p1 *
      Lambda_inv_0_0_p8 + 0.1501 * Lambda_inv_0_0_p16 - Lambda_inv_0_0_p6;
  const Real Lambda_inv_0_0_p28 = 0.1501 * Lambda_inv_0_0_p17 + inverse_D5_p1 * Lambda_inv_0_0_p11 -
      inverse_D5_p2 * Lambda_inv_0_0_p24;

  // link 7 (link4), mobility
  const Real Lambda_inv_0_0_p29 = inverse_D4_p1 * (inverse_D4_p1 * Lambda_inv_0_0_p13);

  // link 6 (link3), mobility
  const Real Lambda_inv_0_0_p30 = Lambda_inv_0_0_p21 * inverse_D5_p6 - Lambda_inv_0_0_p17 *
      inverse_D5_p5 + Lambda_inv_0_0_p16 * inverse_D4_p20 + Lambda_inv_0_0_p13 * inverse_D4_p21;
  const Real Lambda_inv_0_0_p31 = 0.1501 * (Lambda_inv_0_0_p8 + Lambda_inv_0_0_p21) -
      inverse_D5_p2 * (0.1501 * Lambda_inv_0_0_p15 - inverse_D5_p2 * Lambda_inv_0_0_p20 + 2.0 *
      Lambda_inv_0_0_p11);

  // link 7 (link4), mobility
  const Real Lambda_inv_0_0_p32 = inverse_D4_p4 * Lambda_inv_0_0_p30;

  // link 6 (link3), mobility
  const Real Lambda_inv_0_0_p33 = Lambda_inv_0_0_p5 + Lambda_inv_0_0_p31;

  // link 7 (link4), mobility
  const Real Lambda_inv_0_0_p34 = Lambda_inv_0_0_p21 + inverse_D4_p3 * Lambda_inv_0_0_p30;

  // link 6 (link3), mobility
  const Real Lambda_inv_0_0_p35 = Lambda_inv_0_0_p27 * inverse_D5_p6 + Lambda_inv_0_0_p22 *
      inverse_D5_p5 + Lambda_inv_0_0_p23 * inverse_D4_p20 + Lambda_inv_0_0_p16 * inverse_D4_p21;
  const Real Lambda_inv_0_0_p36 = Lambda_inv_0_0_p28 * inverse_D5_p6 - Lambda_inv_0_0_p26 *
      inverse_D5_p5 - Lambda_inv_0_0_p22 * inverse_D4_p20 + Lambda_inv_0_0_p17 * inverse_D4_p21;

  // link 7 (link4), mobility
  const Real Lambda_inv_0_0_p37 = Lambda_inv_0_0_p35 + Lambda_inv_0_0_p32;
  const Real Lambda_inv_0_0_p38 = inverse_D6_p6 * Lambda_inv_0_0_p34 - inverse_D4_p1 *
      (Lambda_inv_0_0_p17 + Lambda_inv_0_0_p32);
  const Real Lambda_inv_0_0_p39 = inverse_D4_p1 * Lambda_inv_0_0_p38;

  // link 6 (link3), mobility
  const Real Lambda_inv_0_0_p40 = Lambda_inv_0_0_p33 * inverse_D5_p6 - Lambda_inv_0_0_p28 *
      inverse_D5_p5 + Lambda_inv_0_0_p27 * inverse_D4_p20 + Lambda_inv_0_0_p21 * inverse_D4_p21;

  // link 7 (link4), mobility
  const Real Lambda_inv_0_0_p41 = Lambda_inv_0_0_p27 +
      (inverse_D4_p3 * Lambda_inv_0_0_p37 + inverse_D4_p4 * Lambda_inv_0_0_p21);
  const Real Lambda_inv_0_0_p42 = inverse_D4_p4 * (Lambda_inv_0_0_p17 + Lambda_inv_0_0_p37) -
      Lambda_inv_0_0_p22;
  const Real Lambda_inv_0_0_p43 = inverse_D6_p6 * Lambda_inv_0_0_p41 - inverse_D4_p1 *
      Lambda_inv_0_0_p42;
  const Real Lambda_inv_0_0_p44 = inverse_D4_p1 * Lambda_inv_0_0_p41 + inverse_D6_p6 *
      Lambda_inv_0_0_p42;

  // link 6 (link3), mobility
  const Real Lambda_inv_0_0_p45 = inverse_D6 + (inverse_D5_p6 * Lambda_inv_0_0_p40 - inverse_D5_p5 *
      Lambda_inv_0_0_p36 + inverse_D4_p20 * Lambda_inv_0_0_p35 + inverse_D4_p21 *
      Lambda_inv_0_0_p30);

  // link 7 (link4), mobility
  const Real Lambda_inv_0_0_p46 = Lambda_inv_0_0_p40 + inverse_D4_p3 * Lambda_inv_0_0_p45;
  const Real Lambda_inv_0_0_p47 = Lambda_inv_0_0_p36 + inverse_D4_p4 * Lambda_inv_0_0_p45;
  const Real Lambda_inv_0_0_p48 = inverse_D4_p1 * Lambda_inv_0_0_p47 - inverse_D6_p6 *
      Lambda_inv_0_0_p46;
  const Real Lambda_inv_0_0_p49 = Lambda_inv_0_0_p33 + inverse_D4_p3 *
      (Lambda_inv_0_0_p40 + Lambda_inv_0_0_p46);
  const Real Lambda_inv_0_0_p50 = Lambda_inv_0_0_p26 + inverse_D4_p4 *
      (Lambda_inv_0_0_p36 + Lambda_inv_0_0_p47);
  const Real Lambda_inv_0_0_p51 = Lambda_inv_0_0_p28 +
      (inverse_D4_p4 * Lambda_inv_0_0_p40 + inverse_D4_p3 * Lambda_inv_0_0_p47);
  const Real Lambda_inv_0_0_p52 = Lambda_inv_0_0_p29 + s7 *
      (Lambda_inv_0_0_p10 * inverse_D4_p1 * Lambda_inv_0_0_p30 - s7 *
      (Lambda_inv_0_0_p29 - Lambda_inv_0_0_p45));
  const Real Lambda_inv_0_3_p1 = s7 * (inverse_D4_p1 * Lambda_inv_0_0_p46 + inverse_D6_p6 *
      Lambda_inv_0_0_p47) - c7 * (inverse_D6_p6 * Lambda_inv_0_0_p38 - Lambda_inv_0_0_p34);
  const Real Lambda_inv_0_0_p53 = c7 * (Lambda_inv_0_0_p48 - inverse_D4_p1 * Lambda_inv_0_0_p18) -
      s7 * (Lambda_inv_0_0_p37 - Lambda_inv_0_0_p39);
  const Real Lambda_inv_0_0_p54 = inverse_D4_p1 * (Lambda_inv_0_0_p49 - Lambda_inv_0_0_p50) +
      inverse_D6_p8 * Lambda_inv_0_0_p51;
  const Real Lambda_inv_0_0_p55 = inverse_D4_p1 * Lambda_inv_0_0_p54;
  const Real Lambda_inv_0_0_p56 = c7 * Lambda_inv_0_0_p53 - Lambda_inv_0_0_p48;
  const Real Lambda_inv_0_3_p2 = s7 * Lambda_inv_0_0_p53 - Lambda_inv_0_0_p39;
  const Real Lambda_inv_0_0_p57 = Lambda_inv_0_0_p49 - Lambda_inv_0_0_p55;
  const Real Lambda_inv_0_0_p58 = inverse_D6_p6 * Lambda_inv_0_0_p54 - Lambda_inv_0_0_p51;
  const Real Lambda_inv_0_0_p59 = Lambda_inv_0_0_p50 + Lambda_inv_0_0_p55;
  const Real Lambda_inv_0_0_p60 = Lambda_inv_0_0_p56 * inverse_D6_p10 - Lambda_inv_0_0_p52 *
      inverse_D6_p11;
  const Real Lambda_inv_0_0_p61 = c7 * Lambda_inv_0_0_p58 + s7 * Lambda_inv_0_0_p44;
  const Real Lambda_inv_0_3_p3 = s7 * Lambda_inv_0_0_p58 - c7 * Lambda_inv_0_0_p44;
  const Real Lambda_inv_0_0_p62 = Lambda_inv_0_0_p10 * Lambda_inv_0_0_p43 - s7 *
      (Lambda_inv_0_0_p57 - Lambda_inv_0_0_p25);
  const Real Lambda_inv_0_0_p63 = s7 * Lambda_inv_0_0_p62;
  const Real Lambda_inv_0_0_p64 = Lambda_inv_0_0_p57 + Lambda_inv_0_0_p63;
  const Real Lambda_inv_0_0_p65 = Lambda_inv_0_0_p25 - Lambda_inv_0_0_p63;
  const Real Lambda_inv_0_3_p4 = c7 * Lambda_inv_0_0_p62 - Lambda_inv_0_0_p43;
  const Real Lambda_inv_0_0_p66 = Lambda_inv_0_0_p65 * inverse_D6_p10 - Lambda_inv_0_0_p56 *
      inverse_D6_p11;
  const Real Lambda_inv_0_3_p5 = Lambda_inv_0_3_p4 * inverse_D6_p10 - Lambda_inv_0_3_p2 *
      inverse_D6_p11;

  // link 8 (link5), mobility
  const Real Lambda_inv_0_0_p67 = c8 * Lambda_inv_0_3_p4 - s8 * Lambda_inv_0_3_p3;
  const Real Lambda_inv_0_0_p68 = s8 * (Lambda_inv_0_0_p64 - Lambda_inv_0_0_p59) -
      Lambda_inv_0_0_p14 * Lambda_inv_0_0_p61;
  const Real Lambda_inv_0_0_p69 = s8 * Lambda_inv_0_0_p68;
  const Real Lambda_inv_0_0_p70 = c8 * Lambda_inv_0_0_p56 + s8 * Lambda_inv_0_0_p66;
  const Real Lambda_inv_0_0_p71 = Lambda_inv_0_0_p64 - Lambda_inv_0_0_p69;
  const Real Lambda_inv_0_3_p6 = s8 * (Lambda_inv_0_3_p2 +
      (Lambda_inv_0_3_p3 * inverse_D6_p10 - Lambda_inv_0_3_p1 * inverse_D6_p11)) - c8 *
      (Lambda_inv_0_3_p5 - Lambda_inv_0_3_p1);
  const Real Lambda_inv_0_0_p72 = c8 * Lambda_inv_0_0_p68 + Lambda_inv_0_0_p61;
  const Real Lambda_inv_0_0_p73 = Lambda_inv_0_0_p59 + Lambda_inv_0_0_p69;
  const Real Lambda_inv_0_0_p74 = 20.114001379640452 * Lambda_inv_0_0_p71;
  const Real Lambda_inv_0_3_p7 = 4.484863585399276 * Lambda_inv_0_0_p72;
  const Real Lambda_inv_0_3_p8 = Lambda_inv_0_3_p2 - s8 * Lambda_inv_0_3_p6;
  const Real Lambda_inv_0_3_p9 = c8 * Lambda_inv_0_3_p6 + Lambda_inv_0_3_p5;
  const Real Lambda_inv_0_0_p75 = s8 * (Lambda_inv_0_0_p52 -
      (inverse_D7 + (inverse_D6_p10 * Lambda_inv_0_0_p66 - inverse_D6_p11 * Lambda_inv_0_0_p60))) -
      Lambda_inv_0_0_p14 * Lambda_inv_0_0_p60;

  // link 9 (link6), mobility
  const Real Lambda_inv_0_3_p10 = 0.7477264233212907 * Lambda_inv_0_3_p8;
  const Real Lambda_inv_0_0_p76 = 0.05625 * (1557.24430048586 + Lambda_inv_0_0_p74) -
      4.484863585399276 * Lambda_inv_0_0_p71;
  const Real Lambda_inv_0_0_p77 = 0.7477264233212907 * Lambda_inv_0_0_p67 - 0.0420596113118226 *
      Lambda_inv_0_3_p8;
  const Real Lambda_inv_0_0_p78 = s8 * Lambda_inv_0_3_p4 + c8 * Lambda_inv_0_3_p3 - 0.05625 *
      Lambda_inv_0_3_p9;
  const Real Lambda_inv_0_3_p11 = 0.2522735766787093 * Lambda_inv_0_3_p8 - 4.484863585399276 *
      Lambda_inv_0_0_p67;

  // link 8 (link5), mobility
  const Real Lambda_inv_0_0_p79 = Lambda_inv_0_0_p52 - s8 * Lambda_inv_0_0_p75;

  // link 8 (link5), turn
  const Real Lambda_inv_0_3_p12 = c8 * Lambda_inv_0_3_p9 - s8 * Lambda_inv_0_3_p10;

  // link 9 (link6), mobility
  const Real Lambda_inv_0_0_p80 = 0.7477264233212907 * Lambda_inv_0_0_p71 + 0.05625 *
      Lambda_inv_0_0_p76;

  // link 8 (link5), turn
  const Real Lambda_inv_0_3_p13 = s8 * Lambda_inv_0_3_p12;
  const Real Lambda_inv_0_3_p14 = s8 * Lambda_inv_0_3_p7 - c8 * Lambda_inv_0_0_p76;
  const Real Lambda_inv_0_3_p15 = c8 * Lambda_inv_0_3_p12;
  const Real Lambda_inv_0_0_p81 = c8 * Lambda_inv_0_0_p77 + s8 * Lambda_inv_0_0_p78;
  const Real Lambda_inv_0_3_p16 = s8 * Lambda_inv_0_0_p76 + c8 * Lambda_inv_0_3_p7;
  const Real Lambda_inv_0_0_p82 = c8 * Lambda_inv_0_0_p78 - s8 * Lambda_inv_0_0_p77;

  // link 9 (link6), mobility
  const Real Lambda_inv_0_0_p83 = Lambda_inv_0_0_p70 - 0.05625 * Lambda_inv_0_0_p79;

  // link 8 (link5), turn
  const Real Lambda_inv_0_3_p17 = Lambda_inv_0_3_p10 + Lambda_inv_0_3_p13;
  const Real Lambda_inv_0_3_p18 = Lambda_inv_0_3_p9 - Lambda_inv_0_3_p15;

  // link 9 (link6), turn
  const Real Lambda_inv_3_3_p1 = 1557.2443004858615 + Lambda_inv_0_0_p74;

  // link 8 (link5), mobility
  const Real Lambda_inv_3_3_p2 = 4.484863585399276 * Lambda_inv_0_3_p8;

  // link 8 (link5), turn
  const Real Lambda_inv_3_3_p3 = s8 * (Lambda_inv_0_0_p79 - 24999.999999999996);
  const Real Lambda_inv_0_3_p19 = c8 * Lambda_inv_0_0_p83;
  const Real Lambda_inv_0_3_p20 = s8 * Lambda_inv_0_0_p83;
  const Real Lambda_inv_3_3_p4 = c8 * Lambda_inv_3_3_p2;
  const Real Lambda_inv_3_3_p5 = s8 * Lambda_inv_3_3_p2;

  // link 7 (link4), turn
  const Real Lambda_inv_0_3_p21 = c7 * Lambda_inv_0_3_p15 + s7 * Lambda_inv_0_3_p16;

  // link 8 (link5), turn
  const Real Lambda_inv_0_0_p84 = c8 * (1.4954528466425814 * Lambda_inv_0_0_p72) - s8 *
      (Lambda_inv_0_0_p80 - Lambda_inv_0_0_p73);
  const Real Lambda_inv_3_3_p6 = s8 * Lambda_inv_3_3_p3;
  const Real Lambda_inv_3_3_p7 = c8 * Lambda_inv_3_3_p3;

  // link 7 (link4), turn
  const Real Lambda_inv_0_3_p22 = s7 * Lambda_inv_0_3_p15 - c7 * Lambda_inv_0_3_p16;

  // link 8 (link5), turn
  const Real Lambda_inv_0_0_p85 = s8 * Lambda_inv_0_0_p84;

  // link 9 (link6), mobility
  const Real Lambda_inv_0_0_p86 = Lambda_inv_0_0_p65 - 0.05625 *
      (Lambda_inv_0_0_p70 + Lambda_inv_0_0_p83);

  // link 8 (link5), turn
  const Real Lambda_inv_3_3_p8 = Lambda_inv_0_0_p79 - Lambda_inv_3_3_p6;
  const Real Lambda_inv_3_3_p9 = 24999.999999999996 + Lambda_inv_3_3_p6;

  // link 7 (link4), turn
  const Real Lambda_inv_0_3_p23 = s7 * Lambda_inv_0_3_p20 - c7 * Lambda_inv_0_3_p18;
  const Real Lambda_inv_0_3_p24 = s7 * Lambda_inv_0_3_p18 + c7 * Lambda_inv_0_3_p20;

  // link 8 (link5), turn
  const Real Lambda_inv_0_0_p87 = Lambda_inv_0_0_p80 + Lambda_inv_0_0_p85;

  // link 7 (link4), turn
  const Real Lambda_inv_0_3_p25 = s7 * (Lambda_inv_0_3_p17 - Lambda_inv_0_3_p11) + c7 *
      (Lambda_inv_0_3_p19 - Lambda_inv_0_3_p14);

  // link 8 (link5), turn
  const Real Lambda_inv_0_0_p88 = Lambda_inv_0_0_p73 - Lambda_inv_0_0_p85;
  const Real Lambda_inv_0_0_p89 = 0.7477264233212907 * Lambda_inv_0_0_p72 - c8 * Lambda_inv_0_0_p84;

  // link 7 (link4), turn
  const Real Lambda_inv_3_3_p10 = c7 * Lambda_inv_3_3_p7 + s7 * Lambda_inv_3_3_p5;
  const Real Lambda_inv_3_3_p11 = c7 * Lambda_inv_3_3_p5 - s7 * Lambda_inv_3_3_p7;
  const Real Lambda_inv_0_3_p26 = s7 * Lambda_inv_0_3_p25;
  const Real Lambda_inv_0_3_p27 = c7 * Lambda_inv_0_3_p25;
  const Real Lambda_inv_3_3_p12 = s7 * (Lambda_inv_3_3_p8 - Lambda_inv_3_3_p1) -
      Lambda_inv_0_0_p10 * Lambda_inv_3_3_p4;
  const Real Lambda_inv_0_3_p28 = Lambda_inv_0_3_p17 - Lambda_inv_0_3_p26;
  const Real Lambda_inv_0_3_p29 = Lambda_inv_0_3_p27 + Lambda_inv_0_3_p14;
  const Real Lambda_inv_0_3_p30 = Lambda_inv_0_3_p27 - Lambda_inv_0_3_p19;
  const Real Lambda_inv_0_0_p90 = c7 * Lambda_inv_0_0_p89 + s7 * Lambda_inv_0_0_p82;
  const Real Lambda_inv_0_0_p91 = c7 * Lambda_inv_0_0_p82 - s7 * Lambda_inv_0_0_p89;
  const Real Lambda_inv_0_3_p31 = Lambda_inv_0_3_p11 + Lambda_inv_0_3_p26;
  const Real Lambda_inv_0_0_p92 = s7 * (Lambda_inv_0_0_p87 - Lambda_inv_0_0_p86) +
      Lambda_inv_0_0_p10 * Lambda_inv_0_0_p81;
  const Real Lambda_inv_3_3_p13 = s7 * Lambda_inv_3_3_p12;
  const Real Lambda_inv_0_0_p93 = s7 * Lambda_inv_0_0_p92;
  const Real Lambda_inv_3_3_p14 = Lambda_inv_3_3_p8 - Lambda_inv_3_3_p13;
  const Real Lambda_inv_3_3_p15 = c7 * Lambda_inv_3_3_p12 + Lambda_inv_3_3_p4;
  const Real Lambda_inv_3_3_p16 = Lambda_inv_3_3_p1 + Lambda_inv_3_3_p13;
  const Real Lambda_inv_0_3_p32 = inverse_D6_p6 * Lambda_inv_0_3_p29 + inverse_D4_p1 *
      Lambda_inv_0_3_p24;
  const Real Lambda_inv_0_3_p33 = inverse_D6_p6 * Lambda_inv_0_3_p30 - inverse_D4_p1 *
      Lambda_inv_0_3_p22;
  const Real Lambda_inv_0_5_p1 = inverse_D6_p6 * Lambda_inv_0_3_p24 - inverse_D4_p1 *
      Lambda_inv_0_3_p29;
  const Real Lambda_inv_2_3_p1 = inverse_D4_p1 * Lambda_inv_0_3_p30 + inverse_D6_p6 *
      Lambda_inv_0_3_p22;
  const Real Lambda_inv_0_0_p94 = Lambda_inv_0_0_p87 - Lambda_inv_0_0_p93;
  const Real Lambda_inv_0_3_p34 = inverse_D4_p1 * (Lambda_inv_0_3_p28 + Lambda_inv_0_3_p13) +
      inverse_D6_p6 * (Lambda_inv_0_3_p21 + Lambda_inv_0_3_p23);
  const Real Lambda_inv_0_0_p95 = c7 * Lambda_inv_0_0_p92 - Lambda_inv_0_0_p81;
  const Real Lambda_inv_0_0_p96 = Lambda_inv_0_0_p86 + Lambda_inv_0_0_p93;
  const Real Lambda_inv_0_3_p35 = inverse_D4_p1 * Lambda_inv_0_3_p34;
  const Real Lambda_inv_0_5_p2 = inverse_D6_p6 * Lambda_inv_0_3_p34;
  const Real Lambda_inv_3_3_p17 = inverse_D6_p6 * Lambda_inv_3_3_p15 - inverse_D4_p1 *
      Lambda_inv_3_3_p11;
  const Real Lambda_inv_3_5_p1 = inverse_D4_p1 * Lambda_inv_3_3_p15 + inverse_D6_p6 *
      Lambda_inv_3_3_p11;
  const Real Lambda_inv_3_3_p18 = inverse_D6_p8 * Lambda_inv_3_3_p10 - inverse_D4_p1 *
      (Lambda_inv_3_3_p14 - Lambda_inv_3_3_p9);
  const Real Lambda_inv_0_3_p36 = Lambda_inv_0_3_p28 - Lambda_inv_0_3_p35;
  const Real Lambda_inv_0_0_p97 = inverse_D6_p6 * Lambda_inv_0_0_p95 - inverse_D4_p1 *
      Lambda_inv_0_0_p91;
  const Real Lambda_inv_2_5 = Lambda_inv_0_3_p35 - Lambda_inv_0_3_p13;
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;
  const Real Lambda_inv_0_2_p1 = inverse_D4_p1 * Lambda_inv_0_0_p95 + inverse_D6_p6 *
      Lambda_inv_0_0_p91;
  const Real Lambda_inv_0_5_p3 = Lambda_inv_0_3_p21 - Lambda_inv_0_5_p2;
  const Real Lambda_inv_2_3_p2 = Lambda_inv_0_3_p23 - Lambda_inv_0_5_p2;
  const Real Lambda_inv_0_0_p98 = inverse_D6_p8 * Lambda_inv_0_0_p90 - inverse_D4_p1 *
      (Lambda_inv_0_0_p94 - Lambda_inv_0_0_p88);
  const Real Lambda_inv_3_3_p19 = inverse_D4_p1 * Lambda_inv_3_3_p18;
  const Real Lambda_inv_0_0_p99 = inverse_D4_p1 * Lambda_inv_0_0_p98;
  const Real Lambda_inv_3_3_p20 = Lambda_inv_3_3_p14 + Lambda_inv_3_3_p19;
  Lambda_inv[35] = Lambda_inv_3_3_p9 - Lambda_inv_3_3_p19;
  const Real Lambda_inv_3_5_p2 = inverse_D6_p6 * Lambda_inv_3_3_p18 - Lambda_inv_3_3_p10;

  // link 4 (link1), turn
  const Real Lambda_inv_0_5 = inverse_D2_p2 * Lambda_inv_0_5_p3 + inverse_D2_p1 * Lambda_inv_0_5_p1;
  Lambda_inv[5] = -Lambda_inv_0_5;
  Lambda_inv[30] = -Lambda_inv_0_5;
  const Real Lambda_inv_1_5 = inverse_D2_p2 * Lambda_inv_0_5_p1 - inverse_D2_p1 * Lambda_inv_0_5_p3;
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real Lambda_inv_2_3 = inverse_D2_p1 * Lambda_inv_2_3_p1 - inverse_D2_p2 * Lambda_inv_2_3_p2;
  Lambda_inv[15] = Lambda_inv_2_3;
  Lambda_inv[20] = Lambda_inv_2_3;
  const Real Lambda_inv_2_4 = inverse_D2_p1 * Lambda_inv_2_3_p2 + inverse_D2_p2 * Lambda_inv_2_3_p1;
  Lambda_inv[16] = -Lambda_inv_2_4;
  Lambda_inv[26] = -Lambda_inv_2_4;

  // link 7 (link4), turn
  const Real Lambda_inv_0_0_p100 = Lambda_inv_0_0_p94 + Lambda_inv_0_0_p99;
  const Real Lambda_inv_0_2_p2 = inverse_D6_p6 * Lambda_inv_0_0_p98 - Lambda_inv_0_0_p90;

  // link 4 (link1), turn
  const Real Lambda_inv_0_3_p37 = inverse_D2_p1 * (Lambda_inv_0_3_p36 - Lambda_inv_0_3_p31) -
      inverse_D2_p2 * (Lambda_inv_0_3_p32 + Lambda_inv_0_3_p33);

  // link 7 (link4), turn
  Lambda_inv[14] = Lambda_inv_0_0_p88 - Lambda_inv_0_0_p99;

  // link 4 (link1), turn
  const Real Lambda_inv_0_3_p38 = inverse_D2_p1 * Lambda_inv_0_3_p37;
  const Real Lambda_inv_0_4_p1 = inverse_D2_p2 * Lambda_inv_0_3_p37;
  const Real Lambda_inv_3_5 = inverse_D2_p1 * Lambda_inv_3_5_p1 - inverse_D2_p2 * Lambda_inv_3_5_p2;
  Lambda_inv[23] = Lambda_inv_3_5;
  Lambda_inv[33] = Lambda_inv_3_5;
  const Real Lambda_inv_4_5 = inverse_D2_p1 * Lambda_inv_3_5_p2 + inverse_D2_p2 * Lambda_inv_3_5_p1;
  Lambda_inv[29] = -Lambda_inv_4_5;
  Lambda_inv[34] = -Lambda_inv_4_5;
  const Real Lambda_inv_3_3_p21 = inverse_D2_p1 * (Lambda_inv_3_3_p20 - Lambda_inv_3_3_p16) -
      inverse_D2_p3 * Lambda_inv_3_3_p17;
  const Real Lambda_inv_0_2 = inverse_D2_p1 * Lambda_inv_0_2_p1 - inverse_D2_p2 * Lambda_inv_0_2_p2;
  Lambda_inv[2] = Lambda_inv_0_2;
  Lambda_inv[12] = Lambda_inv_0_2;
  const Real Lambda_inv_0_3 = Lambda_inv_0_3_p36 - Lambda_inv_0_3_p38;
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;
  const Real Lambda_inv_1_4 = Lambda_inv_0_3_p31 + Lambda_inv_0_3_p38;
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_0_4 = Lambda_inv_0_4_p1 + Lambda_inv_0_3_p32;
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[24] = Lambda_inv_0_4;
  const Real Lambda_inv_1_2 = inverse_D2_p1 * Lambda_inv_0_2_p2 + inverse_D2_p2 * Lambda_inv_0_2_p1;
  Lambda_inv[8] = -Lambda_inv_1_2;
  Lambda_inv[13] = -Lambda_inv_1_2;
  const Real Lambda_inv_1_3 = Lambda_inv_0_4_p1 + Lambda_inv_0_3_p33;
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  const Real Lambda_inv_0_0_p101 = inverse_D2_p1 * (Lambda_inv_0_0_p100 - Lambda_inv_0_0_p96) -
      inverse_D2_p3 * Lambda_inv_0_0_p97;
  const Real Lambda_inv_3_3_p22 = inverse_D2_p1 * Lambda_inv_3_3_p21;
  const Real Lambda_inv_0_0_p102 = inverse_D2_p1 * Lambda_inv_0_0_p101;
  Lambda_inv[21] = Lambda_inv_3_3_p20 - Lambda_inv_3_3_p22;
  const Real Lambda_inv_3_4 = inverse_D2_p2 * Lambda_inv_3_3_p21 + Lambda_inv_3_3_p17;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;
  Lambda_inv[28] = Lambda_inv_3_3_p16 + Lambda_inv_3_3_p22;
  Lambda_inv[0] = Lambda_inv_0_0_p100 - Lambda_inv_0_0_p102;
  const Real Lambda_inv_0_1 = inverse_D2_p2 * Lambda_inv_0_0_p101 + Lambda_inv_0_0_p97;
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;
  Lambda_inv[7] = Lambda_inv_0_0_p96 + Lambda_inv_0_0_p102;
}

}  // namespace samm

#undef TREELINE_RESTRICT
