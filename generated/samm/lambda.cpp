// lambda: Lambda = (J M^-1 J^T)^-1
// By force propagation with branching (Chang table 5.3), in the axes of link 9 (link6) at the points.
// 948 flops (add 413, mul 523, div 12), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "samm.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

template <int count>
using Lanes = detail::Pack<Real, count>;
void lambda(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
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
  const Real Lambda_5_5_p1 = inverse_D1 * inverse_D1_p2;
  const Real Lambda_5_5_p2 = inverse_D2 + inverse_D1_p2 * Lambda_5_5_p1;

  // link 4 (link1), mobility
  const Real Lambda_5_5_p3 = inverse_D2_p1 * (inverse_D1 - Lambda_5_5_p2) + inverse_D2_p3 *
      Lambda_5_5_p1;
  const Real Lambda_5_5_p4 = inverse_D2_p1 * Lambda_5_5_p3;
  const Real Lambda_5_5_p5 = inverse_D1 - Lambda_5_5_p4;
  const Real Lambda_5_5_p6 = Lambda_5_5_p1 - inverse_D2_p2 * Lambda_5_5_p3;
  const Real Lambda_5_5_p7 = Lambda_5_5_p2 + Lambda_5_5_p4;
  const Real Lambda_5_5_p8 = Lambda_5_5_p6 * inverse_D2_p10 - Lambda_5_5_p5 * inverse_D2_p9;
  const Real Lambda_5_5_p9 = Lambda_5_5_p7 * inverse_D2_p10 - Lambda_5_5_p6 * inverse_D2_p9;

  // link 7 (link4), mobility
  const Real Lambda_5_5_p10 = 2.0 * c7;

  // link 5 (link2), mobility
  const Real Lambda_5_5_p11 = Lambda_5_5_p5 * inverse_D2_p5 + Lambda_5_5_p6 * inverse_D2_p6 +
      Lambda_5_5_p8 * inverse_D4_p32;
  const Real Lambda_5_5_p12 = Lambda_5_5_p6 * inverse_D2_p5 + Lambda_5_5_p7 * inverse_D2_p6 +
      Lambda_5_5_p9 * inverse_D4_p32;

  // link 4 (link1), mobility
  const Real Lambda_5_5_p13 = inverse_D4 + (inverse_D2_p10 * Lambda_5_5_p9 - inverse_D2_p9 *
      Lambda_5_5_p8);

  // link 8 (link5), mobility
  const Real Lambda_5_5_p14 = 2.0 * c8;

  // link 5 (link2), mobility
  const Real Lambda_5_5_p15 = Lambda_5_5_p8 * inverse_D2_p5 + Lambda_5_5_p9 * inverse_D2_p6 +
      Lambda_5_5_p13 * inverse_D4_p32;

  // link 6 (link3), mobility
  const Real Lambda_5_5_p16 = inverse_D5_p1 * Lambda_5_5_p13 - Lambda_5_5_p9;
  const Real Lambda_5_5_p17 = inverse_D5_p1 * Lambda_5_5_p15;

  // link 7 (link4), mobility
  const Real Lambda_5_5_p18 = Lambda_5_5_p16 + inverse_D4_p4 * Lambda_5_5_p13;

  // link 6 (link3), mobility
  const Real Lambda_5_5_p19 = Lambda_5_5_p12 - Lambda_5_5_p17;

  // link 5 (link2), mobility
  const Real Lambda_5_5_p20 = inverse_D5 + (inverse_D2_p5 * Lambda_5_5_p11 + inverse_D2_p6 *
      Lambda_5_5_p12 + inverse_D4_p32 * Lambda_5_5_p15);

  // link 6 (link3), mobility
  const Real Lambda_5_5_p21 = Lambda_5_5_p8 - (inverse_D5_p2 * Lambda_5_5_p15 - 0.1501 *
      Lambda_5_5_p13);
  const Real Lambda_5_5_p22 = inverse_D5_p1 * Lambda_5_5_p19;
  const Real Lambda_5_5_p23 = Lambda_5_5_p7 + inverse_D5_p1 * (Lambda_5_5_p16 - Lambda_5_5_p9);
  const Real Lambda_5_5_p24 = inverse_D5_p1 * Lambda_5_5_p20;

  // link 7 (link4), mobility
  const Real Lambda_5_5_p25 = Lambda_5_5_p23 + inverse_D4_p4 * (Lambda_5_5_p16 + Lambda_5_5_p18);

  // link 6 (link3), mobility
  const Real Lambda_5_5_p26 = inverse_D5_p1 * Lambda_5_5_p24;
  const Real Lambda_5_5_p27 = inverse_D5_p2 * Lambda_5_5_p19 + inverse_D5_p1 * Lambda_5_5_p8 +
      0.1501 * Lambda_5_5_p16 - Lambda_5_5_p6;
  const Real Lambda_5_5_p28 = 0.1501 * Lambda_5_5_p17 + inverse_D5_p1 * Lambda_5_5_p11 -
      inverse_D5_p2 * Lambda_5_5_p24;

  // link 7 (link4), mobility
  const Real Lambda_5_5_p29 = inverse_D4_p1 * (inverse_D4_p1 * Lambda_5_5_p13);

  // link 6 (link3), mobility
  const Real Lambda_5_5_p30 = Lambda_5_5_p21 * inverse_D5_p6 - Lambda_5_5_p17 * inverse_D5_p5 +
      Lambda_5_5_p16 * inverse_D4_p20 + Lambda_5_5_p13 * inverse_D4_p21;
  const Real Lambda_5_5_p31 = 0.1501 * (Lambda_5_5_p8 + Lambda_5_5_p21) - inverse_D5_p2 *
      (0.1501 * Lambda_5_5_p15 - inverse_D5_p2 * Lambda_5_5_p20 + 2.0 * Lambda_5_5_p11);

  // link 7 (link4), mobility
  const Real Lambda_5_5_p32 = inverse_D4_p4 * Lambda_5_5_p30;

  // link 6 (link3), mobility
  const Real Lambda_5_5_p33 = Lambda_5_5_p5 + Lambda_5_5_p31;

  // link 7 (link4), mobility
  const Real Lambda_5_5_p34 = Lambda_5_5_p21 + inverse_D4_p3 * Lambda_5_5_p30;

  // link 6 (link3), mobility
  const Real Lambda_5_5_p35 = Lambda_5_5_p27 * inverse_D5_p6 + Lambda_5_5_p22 * inverse_D5_p5 +
      Lambda_5_5_p23 * inverse_D4_p20 + Lambda_5_5_p16 * inverse_D4_p21;
  const Real Lambda_5_5_p36 = Lambda_5_5_p28 * inverse_D5_p6 - Lambda_5_5_p26 * inverse_D5_p5 -
      Lambda_5_5_p22 * inverse_D4_p20 + Lambda_5_5_p17 * inverse_D4_p21;

  // link 7 (link4), mobility
  const Real Lambda_5_5_p37 = Lambda_5_5_p35 + Lambda_5_5_p32;
  const Real Lambda_5_5_p38 = inverse_D6_p6 * Lambda_5_5_p34 - inverse_D4_p1 *
      (Lambda_5_5_p17 + Lambda_5_5_p32);
  const Real Lambda_5_5_p39 = inverse_D4_p1 * Lambda_5_5_p38;

  // link 6 (link3), mobility
  const Real Lambda_5_5_p40 = Lambda_5_5_p33 * inverse_D5_p6 - Lambda_5_5_p28 * inverse_D5_p5 +
      Lambda_5_5_p27 * inverse_D4_p20 + Lambda_5_5_p21 * inverse_D4_p21;

  // link 7 (link4), mobility
  const Real Lambda_5_5_p41 = Lambda_5_5_p27 + (inverse_D4_p3 * Lambda_5_5_p37 + inverse_D4_p4 *
      Lambda_5_5_p21);
  const Real Lambda_5_5_p42 = inverse_D4_p4 * (Lambda_5_5_p17 + Lambda_5_5_p37) - Lambda_5_5_p22;
  const Real Lambda_5_5_p43 = inverse_D6_p6 * Lambda_5_5_p41 - inverse_D4_p1 * Lambda_5_5_p42;
  const Real Lambda_5_5_p44 = inverse_D4_p1 * Lambda_5_5_p41 + inverse_D6_p6 * Lambda_5_5_p42;

  // link 6 (link3), mobility
  const Real Lambda_5_5_p45 = inverse_D6 + (inverse_D5_p6 * Lambda_5_5_p40 - inverse_D5_p5 *
      Lambda_5_5_p36 + inverse_D4_p20 * Lambda_5_5_p35 + inverse_D4_p21 * Lambda_5_5_p30);

  // link 7 (link4), mobility
  const Real Lambda_5_5_p46 = Lambda_5_5_p40 + inverse_D4_p3 * Lambda_5_5_p45;
  const Real Lambda_5_5_p47 = Lambda_5_5_p36 + inverse_D4_p4 * Lambda_5_5_p45;
  const Real Lambda_5_5_p48 = inverse_D4_p1 * Lambda_5_5_p47 - inverse_D6_p6 * Lambda_5_5_p46;
  const Real Lambda_5_5_p49 = Lambda_5_5_p33 + inverse_D4_p3 * (Lambda_5_5_p40 + Lambda_5_5_p46);
  const Real Lambda_5_5_p50 = Lambda_5_5_p26 + inverse_D4_p4 * (Lambda_5_5_p36 + Lambda_5_5_p47);
  const Real Lambda_5_5_p51 = Lambda_5_5_p28 + (inverse_D4_p4 * Lambda_5_5_p40 + inverse_D4_p3 *
      Lambda_5_5_p47);
  const Real Lambda_5_5_p52 = Lambda_5_5_p29 + s7 *
      (Lambda_5_5_p10 * inverse_D4_p1 * Lambda_5_5_p30 - s7 * (Lambda_5_5_p29 - Lambda_5_5_p45));
  const Real Lambda_5_5_p53 = s7 * (inverse_D4_p1 * Lambda_5_5_p46 + inverse_D6_p6 *
      Lambda_5_5_p47) - c7 * (inverse_D6_p6 * Lambda_5_5_p38 - Lambda_5_5_p34);
  const Real Lambda_5_5_p54 = c7 * (Lambda_5_5_p48 - inverse_D4_p1 * Lambda_5_5_p18) - s7 *
      (Lambda_5_5_p37 - Lambda_5_5_p39);
  const Real Lambda_5_5_p55 = inverse_D4_p1 * (Lambda_5_5_p49 - Lambda_5_5_p50) + inverse_D6_p8 *
      Lambda_5_5_p51;
  const Real Lambda_5_5_p56 = inverse_D4_p1 * Lambda_5_5_p55;
  const Real Lambda_5_5_p57 = c7 * Lambda_5_5_p54 - Lambda_5_5_p48;
  const Real Lambda_5_5_p58 = s7 * Lambda_5_5_p54 - Lambda_5_5_p39;
  const Real Lambda_5_5_p59 = Lambda_5_5_p49 - Lambda_5_5_p56;
  const Real Lambda_5_5_p60 = inverse_D6_p6 * Lambda_5_5_p55 - Lambda_5_5_p51;
  const Real Lambda_5_5_p61 = Lambda_5_5_p50 + Lambda_5_5_p56;
  const Real Lambda_5_5_p62 = Lambda_5_5_p57 * inverse_D6_p10 - Lambda_5_5_p52 * inverse_D6_p11;
  const Real Lambda_5_5_p63 = c7 * Lambda_5_5_p60 + s7 * Lambda_5_5_p44;
  const Real Lambda_5_5_p64 = s7 * Lambda_5_5_p60 - c7 * Lambda_5_5_p44;
  const Real Lambda_5_5_p65 = Lambda_5_5_p10 * Lambda_5_5_p43 - s7 *
      (Lambda_5_5_p59 - Lambda_5_5_p25);
  const Real Lambda_5_5_p66 = s7 * Lambda_5_5_p65;
  const Real Lambda_5_5_p67 = Lambda_5_5_p59 + Lambda_5_5_p66;
  const Real Lambda_5_5_p68 = Lambda_5_5_p25 - Lambda_5_5_p66;
  const Real Lambda_5_5_p69 = c7 * Lambda_5_5_p65 - Lambda_5_5_p43;
  const Real Lambda_5_5_p70 = Lambda_5_5_p68 * inverse_D6_p10 - Lambda_5_5_p57 * inverse_D6_p11;
  const Real Lambda_5_5_p71 = Lambda_5_5_p69 * inverse_D6_p10 - Lambda_5_5_p58 * inverse_D6_p11;

  // link 8 (link5), mobility
  const Real Lambda_5_5_p72 = c8 * Lambda_5_5_p69 - s8 * Lambda_5_5_p64;
  const Real Lambda_5_5_p73 = s8 * (Lambda_5_5_p67 - Lambda_5_5_p61) - Lambda_5_5_p14 *
      Lambda_5_5_p63;
  const Real Lambda_5_5_p74 = s8 * Lambda_5_5_p73;
  const Real Lambda_5_5_p75 = c8 * Lambda_5_5_p57 + s8 * Lambda_5_5_p70;
  const Real Lambda_5_5_p76 = Lambda_5_5_p67 - Lambda_5_5_p74;
  const Real Lambda_5_5_p77 = c8 * Lambda_5_5_p73 + Lambda_5_5_p63;
  const Real Lambda_5_5_p78 = s8 * (Lambda_5_5_p58 +
      (Lambda_5_5_p64 * inverse_D6_p10 - Lambda_5_5_p53 * inverse_D6_p11)) - c8 *
      (Lambda_5_5_p71 - Lambda_5_5_p53);
  const Real Lambda_5_5_p79 = Lambda_5_5_p61 + Lambda_5_5_p74;
  const Real Lambda_5_5_p80 = 20.114001379640452 * Lambda_5_5_p76;
  const Real Lambda_5_5_p81 = 4.484863585399276 * Lambda_5_5_p77;
  const Real Lambda_5_5_p82 = Lambda_5_5_p58 - s8 * Lambda_5_5_p78;
  const Real Lambda_5_5_p83 = c8 * Lambda_5_5_p78 + Lambda_5_5_p71;
  const Real Lambda_5_5_p84 = s8 * (Lambda_5_5_p52 -
      (inverse_D7 + (inverse_D6_p10 * Lambda_5_5_p70 - inverse_D6_p11 * Lambda_5_5_p62))) -
      Lambda_5_5_p14 * Lambda_5_5_p62;

  // link 9 (link6), mobility
  const Real Lambda_5_5_p85 = 0.7477264233212907 * Lambda_5_5_p82;
  const Real Lambda_5_5_p86 = 0.05625 * (1557.24430048586 + Lambda_5_5_p80) - 4.484863585399276 *
      Lambda_5_5_p76;
  const Real Lambda_5_5_p87 = 0.7477264233212907 * Lambda_5_5_p72 - 0.0420596113118226 *
      Lambda_5_5_p82;
  const Real Lambda_5_5_p88 = s8 * Lambda_5_5_p69 + c8 * Lambda_5_5_p64 - 0.05625 * Lambda_5_5_p83;
  const Real Lambda_5_5_p89 = 0.2522735766787093 * Lambda_5_5_p82 - 4.484863585399276 *
      Lambda_5_5_p72;

  // link 8 (link5), mobility
  const Real Lambda_5_5_p90 = Lambda_5_5_p52 - s8 * Lambda_5_5_p84;

  // link 8 (link5), turn
  const Real Lambda_5_5_p91 = c8 * Lambda_5_5_p83 - s8 * Lambda_5_5_p85;

  // link 9 (link6), mobility
  const Real Lambda_5_5_p92 = 0.7477264233212907 * Lambda_5_5_p76 + 0.05625 * Lambda_5_5_p86;

  // link 8 (link5), turn
  const Real Lambda_5_5_p93 = s8 * Lambda_5_5_p81 - c8 * Lambda_5_5_p86;
  const Real Lambda_5_5_p94 = s8 * Lambda_5_5_p86 + c8 * Lambda_5_5_p81;
  const Real Lambda_5_5_p95 = c8 * Lambda_5_5_p87 + s8 * Lambda_5_5_p88;
  const Real Lambda_5_5_p96 = s8 * Lambda_5_5_p91;
  const Real Lambda_5_5_p97 = c8 * Lambda_5_5_p88 - s8 * Lambda_5_5_p87;
  const Real Lambda_5_5_p98 = c8 * Lambda_5_5_p91;

  // link 9 (link6), mobility
  const Real Lambda_5_5_p99 = Lambda_5_5_p75 - 0.05625 * Lambda_5_5_p90;

  // link 8 (link5), turn
  const Real Lambda_5_5_p100 = Lambda_5_5_p85 + Lambda_5_5_p96;
  const Real Lambda_5_5_p101 = Lambda_5_5_p83 - Lambda_5_5_p98;
  const Real Lambda_5_5_p102 = c8 * Lambda_5_5_p99;
  const Real Lambda_5_5_p103 = s8 * Lambda_5_5_p99;

  // link 7 (link4), turn
  const Real Lambda_5_5_p104 = c7 * Lambda_5_5_p98 + s7 * Lambda_5_5_p94;
  const Real Lambda_5_5_p105 = s7 * Lambda_5_5_p98 - c7 * Lambda_5_5_p94;

  // link 8 (link5), turn
  const Real Lambda_5_5_p106 = c8 * (1.4954528466425814 * Lambda_5_5_p77) - s8 *
      (Lambda_5_5_p92 - Lambda_5_5_p79);

  // link 9 (link6), turn
  const Real Lambda_5_5_p107 = 1557.2443004858615 + Lambda_5_5_p80;

  // link 8 (link5), turn
  const Real Lambda_5_5_p108 = s8 * Lambda_5_5_p106;

  // link 9 (link6), mobility
  const Real Lambda_5_5_p109 = Lambda_5_5_p68 - 0.05625 * (Lambda_5_5_p75 + Lambda_5_5_p99);

  // link 7 (link4), turn
  const Real Lambda_5_5_p110 = s7 * Lambda_5_5_p103 - c7 * Lambda_5_5_p101;
  const Real Lambda_5_5_p111 = s7 * Lambda_5_5_p101 + c7 * Lambda_5_5_p103;

  // link 8 (link5), turn
  const Real Lambda_5_5_p112 = s8 * (Lambda_5_5_p90 - 24999.999999999996);

  // link 8 (link5), mobility
  const Real Lambda_5_5_p113 = 4.484863585399276 * Lambda_5_5_p82;

  // link 8 (link5), turn
  const Real Lambda_5_5_p114 = Lambda_5_5_p92 + Lambda_5_5_p108;
  const Real Lambda_5_5_p115 = 0.7477264233212907 * Lambda_5_5_p77 - c8 * Lambda_5_5_p106;
  const Real Lambda_5_5_p116 = Lambda_5_5_p79 - Lambda_5_5_p108;

  // link 7 (link4), turn
  const Real Lambda_5_5_p117 = s7 * (Lambda_5_5_p100 - Lambda_5_5_p89) + c7 *
      (Lambda_5_5_p102 - Lambda_5_5_p93);

  // link 8 (link5), turn
  const Real Lambda_5_5_p118 = s8 * Lambda_5_5_p112;
  const Real Lambda_5_5_p119 = c8 * Lambda_5_5_p113;
  const Real Lambda_5_5_p120 = s8 * Lambda_5_5_p113;
  const Real Lambda_5_5_p121 = c8 * Lambda_5_5_p112;

  // link 7 (link4), turn
  const Real Lambda_5_5_p122 = s7 * Lambda_5_5_p117;
  const Real Lambda_5_5_p123 = c7 * Lambda_5_5_p117;

  // link 8 (link5), turn
  const Real Lambda_5_5_p124 = Lambda_5_5_p90 - Lambda_5_5_p118;
  const Real Lambda_5_5_p125 = 24999.999999999996 + Lambda_5_5_p118;

  // link 7 (link4), turn
  const Real Lambda_5_5_p126 = c7 * Lambda_5_5_p115 + s7 * Lambda_5_5_p97;
  const Real Lambda_5_5_p127 = c7 * Lambda_5_5_p97 - s7 * Lambda_5_5_p115;
  const Real Lambda_5_5_p128 = Lambda_5_5_p100 - Lambda_5_5_p122;
  const Real Lambda_5_5_p129 = Lambda_5_5_p89 + Lambda_5_5_p122;
  const Real Lambda_5_5_p130 = Lambda_5_5_p123 + Lambda_5_5_p93;
  const Real Lambda_5_5_p131 = Lambda_5_5_p123 - Lambda_5_5_p102;
  const Real Lambda_5_5_p132 = s7 * (Lambda_5_5_p114 - Lambda_5_5_p109) + Lambda_5_5_p10 *
      Lambda_5_5_p95;
  const Real Lambda_5_5_p133 = c7 * Lambda_5_5_p121 + s7 * Lambda_5_5_p120;
  const Real Lambda_5_5_p134 = s7 * Lambda_5_5_p132;
  const Real Lambda_5_5_p135 = c7 * Lambda_5_5_p120 - s7 * Lambda_5_5_p121;
  const Real Lambda_5_5_p136 = inverse_D6_p6 * Lambda_5_5_p130 + inverse_D4_p1 * Lambda_5_5_p111;
  const Real Lambda_5_5_p137 = inverse_D6_p6 * Lambda_5_5_p131 - inverse_D4_p1 * Lambda_5_5_p105;
  const Real Lambda_5_5_p138 = inverse_D6_p6 * Lambda_5_5_p111 - inverse_D4_p1 * Lambda_5_5_p130;
  const Real Lambda_5_5_p139 = s7 * (Lambda_5_5_p124 - Lambda_5_5_p107) - Lambda_5_5_p10 *
      Lambda_5_5_p119;
  const Real Lambda_5_5_p140 = inverse_D4_p1 * Lambda_5_5_p131 + inverse_D6_p6 * Lambda_5_5_p105;
  const Real Lambda_5_5_p141 = Lambda_5_5_p114 - Lambda_5_5_p134;
  const Real Lambda_5_5_p142 = c7 * Lambda_5_5_p132 - Lambda_5_5_p95;
  const Real Lambda_5_5_p143 = Lambda_5_5_p109 + Lambda_5_5_p134;
  const Real Lambda_5_5_p144 = inverse_D4_p1 * (Lambda_5_5_p128 + Lambda_5_5_p96) + inverse_D6_p6 *
      (Lambda_5_5_p104 + Lambda_5_5_p110);
  const Real Lambda_5_5_p145 = s7 * Lambda_5_5_p139;
  const Real Lambda_5_5_p146 = inverse_D4_p1 * Lambda_5_5_p144;
  const Real Lambda_5_5_p147 = inverse_D6_p6 * Lambda_5_5_p144;
  const Real Lambda_5_5_p148 = Lambda_5_5_p124 - Lambda_5_5_p145;
  const Real Lambda_5_5_p149 = c7 * Lambda_5_5_p139 + Lambda_5_5_p119;
  const Real Lambda_5_5_p150 = Lambda_5_5_p107 + Lambda_5_5_p145;
  const Real Lambda_5_5_p151 = inverse_D6_p6 * Lambda_5_5_p142 - inverse_D4_p1 * Lambda_5_5_p127;
  const Real Lambda_5_5_p152 = Lambda_5_5_p128 - Lambda_5_5_p146;
  const Real Lambda_5_5_p153 = Lambda_5_5_p104 - Lambda_5_5_p147;
  const Real Lambda_5_5_p154 = Lambda_5_5_p110 - Lambda_5_5_p147;
  const Real Lambda_5_5_p155 = inverse_D4_p1 * Lambda_5_5_p142 + inverse_D6_p6 * Lambda_5_5_p127;
  const Real Lambda_5_5_p156 = inverse_D6_p8 * Lambda_5_5_p126 - inverse_D4_p1 *
      (Lambda_5_5_p141 - Lambda_5_5_p116);
  const Real Lambda_5_5_p157 = inverse_D4_p1 * Lambda_5_5_p156;
  const Real Lambda_5_5_p158 = inverse_D6_p6 * Lambda_5_5_p149 - inverse_D4_p1 * Lambda_5_5_p135;
  const Real Lambda_5_5_p159 = inverse_D4_p1 * Lambda_5_5_p149 + inverse_D6_p6 * Lambda_5_5_p135;
  const Real Lambda_5_5_p160 = inverse_D6_p8 * Lambda_5_5_p133 - inverse_D4_p1 *
      (Lambda_5_5_p148 - Lambda_5_5_p125);
  const Real Lambda_5_5_p161 = Lambda_5_5_p141 + Lambda_5_5_p157;

  // link 4 (link1), turn
  const Real Lambda_5_5_p162 = inverse_D2_p1 * (Lambda_5_5_p152 - Lambda_5_5_p129) - inverse_D2_p2 *
      (Lambda_5_5_p136 + Lambda_5_5_p137);

  // link 7 (link4), turn
  const Real Lambda_5_5_p163 = inverse_D6_p6 * Lambda_5_5_p156 - Lambda_5_5_p126;

  // link 1 (base_x), turn
  const Real Lambda_5_5_p164 = -(inverse_D2_p2 * Lambda_5_5_p153 + inverse_D2_p1 * Lambda_5_5_p138);

  // link 7 (link4), turn
  const Real Lambda_5_5_p165 = inverse_D4_p1 * Lambda_5_5_p160;

  // link 4 (link1), turn
  const Real Lambda_5_5_p166 = inverse_D2_p2 * Lambda_5_5_p162;
  const Real Lambda_5_5_p167 = inverse_D2_p1 * Lambda_5_5_p162;

  // link 7 (link4), turn
  const Real Lambda_5_5_p168 = Lambda_5_5_p148 + Lambda_5_5_p165;
  const Real Lambda_5_5_p169 = inverse_D6_p6 * Lambda_5_5_p160 - Lambda_5_5_p133;

  // link 4 (link1), turn
  const Real Lambda_5_5_p170 = Lambda_5_5_p166 + Lambda_5_5_p136;
  const Real Lambda_5_5_p171 = Lambda_5_5_p152 - Lambda_5_5_p167;
  const Real Lambda_5_5_p172 = inverse_D2_p1 * Lambda_5_5_p155 - inverse_D2_p2 * Lambda_5_5_p163;
  const Real Lambda_5_5_p173 = inverse_D2_p1 * (Lambda_5_5_p161 - Lambda_5_5_p143) - inverse_D2_p3 *
      Lambda_5_5_p151;
  const Real Lambda_5_5_p174 = inverse_D2_p1 * Lambda_5_5_p173;
  const Real Lambda_5_5_p175 = inverse_D2_p1 * (Lambda_5_5_p168 - Lambda_5_5_p150) - inverse_D2_p3 *
      Lambda_5_5_p158;
  const Real Lambda_5_5_p176 = inverse_D2_p2 * Lambda_5_5_p173 + Lambda_5_5_p151;
  const Real Lambda_5_5_p177 = inverse_D2_p1 * Lambda_5_5_p175;

  // link 1 (base_x), turn
  const Real Lambda_5_5_p178 = 1.0 / (Lambda_5_5_p161 - Lambda_5_5_p174);
  const Real Lambda_5_5_p179 = Lambda_5_5_p164 * Lambda_5_5_p178;
  const Real Lambda_5_5_p180 = Lambda_5_5_p170 * Lambda_5_5_p178;
  const Real Lambda_5_5_p181 = Lambda_5_5_p171 * Lambda_5_5_p178;
  const Real Lambda_5_5_p182 = Lambda_5_5_p172 * Lambda_5_5_p178;
  const Real Lambda_5_5_p183 = Lambda_5_5_p176 * Lambda_5_5_p178;
  const Lanes<8> Lambda_5_5_p203_lanes = detail::make_pack<Real>(Lambda_5_5_p143 + Lambda_5_5_p174,
      Lambda_5_5_p143 + Lambda_5_5_p174, -(inverse_D2_p1 * Lambda_5_5_p163 + inverse_D2_p2 *
      Lambda_5_5_p155), Lambda_5_5_p166 + Lambda_5_5_p137, Lambda_5_5_p129 + Lambda_5_5_p167,
      inverse_D2_p2 * Lambda_5_5_p138 - inverse_D2_p1 * Lambda_5_5_p153, Lambda_5_5_p143 +
      Lambda_5_5_p174, Lambda_5_5_p143 + Lambda_5_5_p174) -
      detail::make_pack<Real>(Lambda_5_5_p183, Lambda_5_5_p183, Lambda_5_5_p182, Lambda_5_5_p181,
      Lambda_5_5_p180, Lambda_5_5_p179, Lambda_5_5_p183, Lambda_5_5_p183) * Lambda_5_5_p176;
  const Real Lambda_5_5_p208 = 1.0 / Lambda_5_5_p203_lanes[1];
  const Lanes<8> Lambda_5_5_p209_lanes = Lambda_5_5_p203_lanes * Lambda_5_5_p208;
  const Real Lambda_0_0_p1 = Lambda_5_5_p183 * Lambda_5_5_p208;
  const Lanes<8> Lambda_5_5_p220_lanes = detail::make_pack<Real>(Lambda_5_5_p116 - Lambda_5_5_p157,
      Lambda_5_5_p116 - Lambda_5_5_p157, Lambda_5_5_p116 - Lambda_5_5_p157, inverse_D2_p1 *
      Lambda_5_5_p140 - inverse_D2_p2 * Lambda_5_5_p154,
      -(inverse_D2_p1 * Lambda_5_5_p154 + inverse_D2_p2 * Lambda_5_5_p140), Lambda_5_5_p146 -
      Lambda_5_5_p96, Lambda_5_5_p116 - Lambda_5_5_p157, Lambda_5_5_p116 - Lambda_5_5_p157) -
      detail::make_pack<Real>(Lambda_5_5_p182, Lambda_5_5_p182, Lambda_5_5_p182, Lambda_5_5_p181,
      Lambda_5_5_p180, Lambda_5_5_p179, Lambda_5_5_p182, Lambda_5_5_p182) * Lambda_5_5_p172 -
      Lambda_5_5_p209_lanes * Lambda_5_5_p203_lanes[2];
  const Real Lambda_5_5_p227 = -(inverse_D2_p1 * Lambda_5_5_p169 + inverse_D2_p2 *
      Lambda_5_5_p159) - Lambda_5_5_p179 * Lambda_5_5_p170 - Lambda_5_5_p209_lanes[5] *
      Lambda_5_5_p203_lanes[4];
  const Real Lambda_0_0_p2 = Lambda_5_5_p209_lanes[2] * Lambda_5_5_p183 - Lambda_5_5_p182;
  const Real Lambda_5_5_p228 = 1.0 / Lambda_5_5_p220_lanes[2];
  const Lanes<8> Lambda_5_5_p229_lanes = Lambda_5_5_p220_lanes * Lambda_5_5_p228;
  const Real Lambda_0_0_p3 = Lambda_0_0_p2 * Lambda_5_5_p228;
  const Real Lambda_0_1_p1 = Lambda_5_5_p209_lanes[2] * Lambda_5_5_p228;
  const Lanes<8> Lambda_5_5_p235_lanes = detail::make_pack<Real>(Lambda_5_5_p168 - Lambda_5_5_p177,
      Lambda_5_5_p168 - Lambda_5_5_p177, Lambda_5_5_p168 - Lambda_5_5_p177, Lambda_5_5_p168 -
      Lambda_5_5_p177, inverse_D2_p2 * Lambda_5_5_p175 + Lambda_5_5_p158, inverse_D2_p1 *
      Lambda_5_5_p159 - inverse_D2_p2 * Lambda_5_5_p169, Lambda_5_5_p168 - Lambda_5_5_p177,
      Lambda_5_5_p168 - Lambda_5_5_p177) - detail::make_pack<Real>(Lambda_5_5_p181, Lambda_5_5_p181,
      Lambda_5_5_p181, Lambda_5_5_p181, Lambda_5_5_p180, Lambda_5_5_p179, Lambda_5_5_p181,
      Lambda_5_5_p181) * Lambda_5_5_p171 - Lambda_5_5_p209_lanes * Lambda_5_5_p203_lanes[3] -
      Lambda_5_5_p229_lanes * Lambda_5_5_p220_lanes[3];
  const Real Lambda_0_0_p4 = Lambda_5_5_p209_lanes[3] * Lambda_5_5_p183 - Lambda_5_5_p181 -
      Lambda_5_5_p229_lanes[3] * Lambda_0_0_p2;
  const Real Lambda_0_1_p2 = Lambda_5_5_p229_lanes[3] * Lambda_5_5_p209_lanes[2] -
      Lambda_5_5_p209_lanes[3];
  const Real Lambda_5_5_p238 = 1.0 / Lambda_5_5_p235_lanes[3];
  const Real Lambda_5_5_p239 = Lambda_5_5_p235_lanes[4] * Lambda_5_5_p238;
  const Real Lambda_5_5_p240 = Lambda_5_5_p235_lanes[5] * Lambda_5_5_p238;
  const Real Lambda_0_0_p5 = Lambda_0_0_p4 * Lambda_5_5_p238;
  const Real Lambda_0_1_p3 = Lambda_0_1_p2 * Lambda_5_5_p238;
  const Real Lambda_0_2_p1 = Lambda_5_5_p229_lanes[3] * Lambda_5_5_p238;
  const Real Lambda_5_5_p241 = Lambda_5_5_p150 + Lambda_5_5_p177 - Lambda_5_5_p180 *
      Lambda_5_5_p170 - Lambda_5_5_p209_lanes[4] * Lambda_5_5_p203_lanes[4] -
      Lambda_5_5_p229_lanes[4] * Lambda_5_5_p220_lanes[4] - Lambda_5_5_p239 *
      Lambda_5_5_p235_lanes[4];
  const Real Lambda_5_5_p242 = Lambda_5_5_p227 - Lambda_5_5_p229_lanes[5] *
      Lambda_5_5_p220_lanes[4] - Lambda_5_5_p240 * Lambda_5_5_p235_lanes[4];
  const Real Lambda_5_5_p243 = Lambda_5_5_p125 - Lambda_5_5_p165 - Lambda_5_5_p179 *
      Lambda_5_5_p164 - Lambda_5_5_p209_lanes[5] * Lambda_5_5_p203_lanes[5] -
      Lambda_5_5_p229_lanes[5] * Lambda_5_5_p220_lanes[5] - Lambda_5_5_p240 *
      Lambda_5_5_p235_lanes[5];
  const Real Lambda_0_0_p6 = Lambda_5_5_p209_lanes[4] * Lambda_5_5_p183 - Lambda_5_5_p180 -
      Lambda_5_5_p229_lanes[4] * Lambda_0_0_p2 - Lambda_5_5_p239 * Lambda_0_0_p4;
  const Real Lambda_0_1_p4 = Lambda_5_5_p229_lanes[4] * Lambda_5_5_p209_lanes[2] -
      Lambda_5_5_p209_lanes[4] - Lambda_5_5_p239 * Lambda_0_1_p2;
  const Real Lambda_0_2_p2 = Lambda_5_5_p239 * Lambda_5_5_p229_lanes[3] - Lambda_5_5_p229_lanes[4];
  const Real Lambda_5_5_p244 = 1.0 / Lambda_5_5_p241;
  const Real Lambda_5_5_p245 = Lambda_5_5_p242 * Lambda_5_5_p244;
  const Real Lambda_0_0_p7 = Lambda_0_0_p6 * Lambda_5_5_p244;
  const Real Lambda_0_1_p5 = Lambda_0_1_p4 * Lambda_5_5_p244;
  const Real Lambda_0_2_p3 = Lambda_0_2_p2 * Lambda_5_5_p244;
  const Real Lambda_0_3_p1 = Lambda_5_5_p239 * Lambda_5_5_p244;
  const Real Lambda_0_5_p1 = Lambda_5_5_p209_lanes[5] * Lambda_5_5_p183 - Lambda_5_5_p179 -
      Lambda_5_5_p229_lanes[5] * Lambda_0_0_p2 - Lambda_5_5_p240 * Lambda_0_0_p4 - Lambda_5_5_p245 *
      Lambda_0_0_p6;
  const Real Lambda_1_5_p1 = Lambda_5_5_p229_lanes[5] * Lambda_5_5_p209_lanes[2] -
      Lambda_5_5_p209_lanes[5] - Lambda_5_5_p240 * Lambda_0_1_p2 - Lambda_5_5_p245 * Lambda_0_1_p4;
  const Real Lambda_2_5_p1 = Lambda_5_5_p240 * Lambda_5_5_p229_lanes[3] - Lambda_5_5_p229_lanes[5] -
      Lambda_5_5_p245 * Lambda_0_2_p2;
  const Real Lambda_3_5_p1 = Lambda_5_5_p245 * Lambda_5_5_p239 - Lambda_5_5_p240;
  const Real Lambda_0_0_p8 = Lambda_5_5_p178 + Lambda_0_0_p1 * Lambda_5_5_p183 + Lambda_0_0_p3 *
      Lambda_0_0_p2 + Lambda_0_0_p5 * Lambda_0_0_p4 + Lambda_0_0_p7 * Lambda_0_0_p6;
  const Real Lambda_5_5 = 1.0 / (Lambda_5_5_p243 - Lambda_5_5_p245 * Lambda_5_5_p242);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5 = Lambda_0_5_p1 * Lambda_5_5;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_1_5 = Lambda_1_5_p1 * Lambda_5_5;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_2_5 = Lambda_2_5_p1 * Lambda_5_5;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_3_5 = Lambda_3_5_p1 * Lambda_5_5;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_4_5 = Lambda_5_5_p245 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  Lambda[0] = Lambda_0_0_p8 + Lambda_0_5 * Lambda_0_5_p1;
  const Real Lambda_0_1 = Lambda_0_1_p3 * Lambda_0_0_p4 -
      (Lambda_0_0_p1 + Lambda_0_1_p1 * Lambda_0_0_p2) + Lambda_0_1_p5 * Lambda_0_0_p6 + Lambda_1_5 *
      Lambda_0_5_p1;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_0_2 = Lambda_0_0_p3 - Lambda_0_2_p1 * Lambda_0_0_p4 + Lambda_0_2_p3 *
      Lambda_0_0_p6 + Lambda_2_5 * Lambda_0_5_p1;
  Lambda[2] = Lambda_0_2;
  Lambda[12] = Lambda_0_2;
  const Real Lambda_0_3 = Lambda_0_0_p5 - Lambda_0_3_p1 * Lambda_0_0_p6 + Lambda_3_5 *
      Lambda_0_5_p1;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_0_4 = Lambda_0_0_p7 - Lambda_4_5 * Lambda_0_5_p1;
  Lambda[4] = Lambda_0_4;
  Lambda[24] = Lambda_0_4;
  Lambda[7] = Lambda_5_5_p208 + Lambda_0_1_p1 * Lambda_5_5_p209_lanes[2] + Lambda_0_1_p3 *
      Lambda_0_1_p2 + Lambda_0_1_p5 * Lambda_0_1_p4 + Lambda_1_5 * Lambda_1_5_p1;
  const Real Lambda_1_2 = Lambda_0_2_p3 * Lambda_0_1_p4 -
      (Lambda_0_1_p1 + Lambda_0_2_p1 * Lambda_0_1_p2) + Lambda_2_5 * Lambda_1_5_p1;
  Lambda[8] = Lambda_1_2;
  Lambda[13] = Lambda_1_2;
  const Real Lambda_1_3 = Lambda_0_1_p3 - Lambda_0_3_p1 * Lambda_0_1_p4 + Lambda_3_5 *
      Lambda_1_5_p1;
  Lambda[9] = Lambda_1_3;
  Lambda[19] = Lambda_1_3;
  const Real Lambda_1_4 = Lambda_0_1_p5 - Lambda_4_5 * Lambda_1_5_p1;
  Lambda[10] = Lambda_1_4;
  Lambda[25] = Lambda_1_4;
  Lambda[14] = Lambda_5_5_p228 + Lambda_0_2_p1 * Lambda_5_5_p229_lanes[3] + Lambda_0_2_p3 *
      Lambda_0_2_p2 + Lambda_2_5 * Lambda_2_5_p1;
  const Real Lambda_2_3 = Lambda_3_5 * Lambda_2_5_p1 -
      (Lambda_0_2_p1 + Lambda_0_3_p1 * Lambda_0_2_p2);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = Lambda_0_2_p3 - Lambda_4_5 * Lambda_2_5_p1;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = Lambda_5_5_p238 + Lambda_0_3_p1 * Lambda_5_5_p239 + Lambda_3_5 * Lambda_3_5_p1;
  const Real Lambda_3_4 = Lambda_0_3_p1 + Lambda_4_5 * Lambda_3_5_p1;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = Lambda_5_5_p244 + Lambda_4_5 * Lambda_5_5_p245;
}

}  // namespace samm

#undef TREELINE_RESTRICT
