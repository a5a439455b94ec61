// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
// By Chang table 6.1, fused; Lambda^-1: force propagation with branching (Chang table 5.3), in link axes at link origins.
// 1327 flops (add 605, mul 711, div 11), sine and cosine of 7 angles
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
void control_torque(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    const Real (&TREELINE_RESTRICT qdd_0)[9], const Real (&TREELINE_RESTRICT xdd_cmd)[6],
    Real (&TREELINE_RESTRICT tau)[9]) noexcept {
  const Real angles[7] = {q[2], q[3], q[4], q[5], q[6], q[7], q[8]};
  Real sines[7];
  Real cosines[7];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s5 = sines[2];
  const Real c5 = cosines[2];
  const Real s6 = sines[3];
  const Real c6 = cosines[3];
  const Real c7 = cosines[4];
  const Real s8 = sines[5];
  const Real c8 = cosines[5];
  const Real s7 = sines[4];
  const Real s3 = sines[0];
  const Real s4 = sines[1];
  const Real c9 = cosines[6];
  const Real s9 = sines[6];

  // link 8 (link5), articulated inertia
  const Real inverse_D7_p1 = 0.00024215999999999997 * s8;
  const Real inverse_D6_p1 = 0.0028799999999999997 * s8;
  const Real inverse_D6_p2 = 0.012916407125949915 * s8;

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p1 = 2.0 * c6;

  // link 8 (link5), articulated inertia
  const Real inverse_D7_p2 = s8 * inverse_D7_p1;
  const Real inverse_D6_p3 = s8 * inverse_D6_p2;
  const Real inverse_D6_p4 = c8 * inverse_D7_p1;
  const Real inverse_D6_p5 = c8 * inverse_D6_p2;
  const Real inverse_D6_p6 = inverse_D6_p3 - 0.012916407125949915;

  // link 7 (link4), articulated inertia
  const Real inverse_D6_p7 = c7 * inverse_D6_p5;
  const Real inverse_D4_p1 = s7 * inverse_D6_p5;
  const Real inverse_D7 = 1.0 / (0.0016 + inverse_D7_p2);
  const Real inverse_D4_p2 = 0.0203 * inverse_D4_p1;
  const Real inverse_D6_p8 = 0.4331 * inverse_D6_p7 - 0.0203 * inverse_D6_p3;
  const Real inverse_D5_p2 = 0.025374999999999998 + inverse_D6_p8;
  const Real inverse_D6_p9 = inverse_D6_p1 * inverse_D7;
  const Real inverse_D6_p10 = inverse_D6_p4 * inverse_D7;
  const Real inverse_D6_p11 = inverse_D6_p1 * inverse_D6_p9;
  const Real inverse_D6_p12 = inverse_D6_p4 * inverse_D6_p9 - 0.0028799999999999997 * c8;
  const Real inverse_D6_p13 = 0.0011921599999999998 - inverse_D7_p2 - inverse_D6_p4 *
      inverse_D6_p10;
  const Real inverse_D6_p14 = s7 * (inverse_D6_p6 + inverse_D6_p11);
  const Real inverse_D6_p15 = c7 * inverse_D6_p12;
  const Real inverse_D6_p16 = s7 * (inverse_D6_p13 - 0.00065);
  const Real inverse_D6_p17 = s7 * inverse_D6_p14;
  const Real inverse_D6_p18 = c7 * inverse_D6_p15;
  const Real inverse_D4_p3 = c7 * inverse_D6_p14;
  const Real inverse_D4_p4 = s7 * inverse_D6_p15;
  const Real inverse_D6_p19 = s7 * inverse_D6_p16;
  const Real inverse_D6_p20 = inverse_D6_p6 - inverse_D6_p17;
  const Real inverse_D6_p21 = inverse_D6_p18 - inverse_D6_p12;
  const Real inverse_D4_p5 = inverse_D6_p17 - inverse_D6_p11;
  const Real inverse_D4_p6 = inverse_D4_p4 + 0.4331 * inverse_D4_p3;
  const Real inverse_D4_p7 = inverse_D4_p6 + inverse_D4_p2;
  const Real inverse_D4_p8 = inverse_D6_p18 - 0.4331 * inverse_D4_p5;
  const Real inverse_D6_p22 = inverse_D6_p21 + (0.4331 * inverse_D6_p20 + 0.0203 * inverse_D6_p7);
  const Real inverse_D5_p3 = 0.861795 + inverse_D6_p22;
  const Real inverse_D4_p9 = 0.004704000000000001 + 0.0203 * inverse_D4_p7;
  const Real inverse_D4_p10 = c7 * inverse_D6_p16 - 0.4331 * (inverse_D4_p7 + inverse_D4_p4);

  // link 6 (link3), articulated inertia
  const Real inverse_D6 = 1.0 / (0.312455249 + (0.00065 + inverse_D6_p19 +
      (0.0203 * inverse_D6_p8 + 0.4331 * (inverse_D6_p21 + inverse_D6_p22))));
  const Real inverse_D5_p4 = inverse_D5_p3 * inverse_D6;
  const Real inverse_D5_p5 = inverse_D5_p2 * inverse_D6;
  const Real inverse_D4_p11 = inverse_D4_p7 * inverse_D6;
  const Real inverse_D4_p12 = inverse_D4_p10 * inverse_D6;
  const Real inverse_D4_p13 = inverse_D4_p9 * inverse_D6;
  const Real inverse_D5_p6 = inverse_D6_p20 - inverse_D5_p3 * inverse_D5_p4;
  const Real inverse_D5_p7 = inverse_D6_p3 + inverse_D5_p2 * inverse_D5_p5;
  const Real inverse_D5_p8 = inverse_D5_p3 * inverse_D5_p5 - inverse_D6_p7;
  const Real inverse_D4_p14 = 0.0203 * inverse_D4_p3 - inverse_D4_p9 * inverse_D5_p4;
  const Real inverse_D4_p15 = 0.4331 * inverse_D4_p1 + inverse_D4_p10 * inverse_D5_p5;
  const Real inverse_D4_p16 = inverse_D4_p6 + inverse_D4_p10 * inverse_D5_p4;
  const Real inverse_D4_p17 = inverse_D4_p9 * inverse_D5_p5 - inverse_D4_p2;
  const Real inverse_D4_p18 = inverse_D4_p3 - inverse_D5_p3 * inverse_D4_p11;
  const Real inverse_D4_p19 = inverse_D5_p2 * inverse_D4_p11 - inverse_D4_p1;
  const Real inverse_D4_p20 = inverse_D4_p8 - 0.861795 - inverse_D4_p10 * inverse_D4_p11;
  const Real inverse_D4_p21 = 0.025374999999999998 + 0.0203 * inverse_D4_p5 - inverse_D4_p9 *
      inverse_D4_p11;
  const Real inverse_D4_p22 = inverse_D4_p5 - inverse_D4_p7 * inverse_D4_p11;
  const Real inverse_D4_p23 = 0.3056901365 + (inverse_D6_p13 - inverse_D6_p19 - 0.4331 *
      (inverse_D6_p18 + inverse_D4_p8)) - inverse_D4_p10 * inverse_D4_p12;
  const Real inverse_D4_p24 = 0.0067651125 + 0.00041208999999999994 * inverse_D4_p5 -
      inverse_D4_p9 * inverse_D4_p13;
  const Real inverse_D4_p25 = 0.0203 * inverse_D6_p18 - 0.00879193 * inverse_D4_p5 -
      0.010673638499999999 - inverse_D4_p10 * inverse_D4_p13;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p26 = 2.0 * c5;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p27 = c6 * inverse_D4_p18 - s6 * inverse_D4_p19;
  const Real inverse_D4_p28 = s6 * inverse_D4_p18 + c6 * inverse_D4_p19;
  const Real inverse_D4_p29 = s6 * inverse_D4_p20 + c6 * inverse_D4_p21;
  const Real inverse_D5_p9 = s6 * (inverse_D5_p6 + inverse_D5_p7) + inverse_D5_p1 * inverse_D5_p8;
  const Real inverse_D4_p30 = c6 * (inverse_D4_p14 + inverse_D4_p15) - s6 *
      (inverse_D4_p16 + inverse_D4_p17);
  const Real inverse_D4_p31 = c6 * inverse_D4_p20 - s6 * inverse_D4_p21;
  const Real inverse_D4_p32 = 0.4318 * inverse_D4_p28;
  const Real inverse_D5_p10 = s6 * inverse_D5_p9;
  const Real inverse_D4_p33 = s6 * inverse_D4_p30;
  const Real inverse_D4_p34 = c6 * inverse_D4_p30;
  const Real inverse_D4_p35 = s6 * (inverse_D4_p23 - inverse_D4_p24) + inverse_D5_p1 *
      inverse_D4_p25;

  // link 4 (link1), articulated inertia
  const Real inverse_D2_p1 = 2.0 * c4;

  // link 6 (link3), articulated inertia
  const Real inverse_D5_p11 = inverse_D5_p10 - inverse_D5_p7;
  const Real inverse_D4_p36 = inverse_D5_p6 - inverse_D5_p10;
  const Real inverse_D4_p37 = c6 * inverse_D5_p9 - inverse_D5_p8;
  const Real inverse_D4_p38 = s6 * inverse_D4_p35;
  const Real inverse_D4_p39 = inverse_D4_p34 - inverse_D4_p15;
  const Real inverse_D4_p40 = inverse_D4_p34 - inverse_D4_p14;
  const Real inverse_D4_p41 = inverse_D4_p29 - (0.4318 * inverse_D4_p22 - 0.1501 * inverse_D4_p27);

  // link 3 (base), articulated inertia
  const Real inverse_D2_p2 = 2.0 * c3;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p42 = 0.1501 * inverse_D4_p37;
  const Real inverse_D4_p43 = inverse_D4_p17 + inverse_D4_p33 - inverse_D4_p32;
  const Real inverse_D4_p44 = inverse_D4_p40 - 0.1501 * inverse_D5_p11;
  const Real inverse_D2_p3 = 0.4318 * inverse_D4_p37 - 0.10439999999999999;

  // link 5 (link2), articulated inertia
  const Real inverse_D5 = 1.0 / (1.7481140020000001 + 0.18645124000000002 * inverse_D5_p11);

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p45 = inverse_D4_p39 - (0.4318 * inverse_D4_p27 - 0.1501 * inverse_D4_p36);

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p46 = inverse_D4_p16 + inverse_D4_p33 + (inverse_D4_p43 + inverse_D4_p42);

  // link 6 (link3), articulated inertia
  const Real inverse_D2_p4 = 3.79559 + 0.4318 * inverse_D5_p11;
  const Real inverse_D4_p47 = 0.4318 * inverse_D4_p40 - 0.06481318000000001 * inverse_D5_p11 -
      0.690314699;
  const Real inverse_D4_p48 = 0.4318 * inverse_D4_p43 + 0.06481318000000001 * inverse_D4_p37 -
      0.023750999999999998;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p49 = inverse_D4_p47 * inverse_D5;
  const Real inverse_D4_p50 = inverse_D4_p48 * inverse_D5;
  const Real inverse_D2_p5 = inverse_D2_p3 * inverse_D5;
  const Real inverse_D2_p6 = inverse_D2_p4 * inverse_D5;
  const Real inverse_D2_p7 = inverse_D4_p32 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p51 = 1.674987602 + (inverse_D4_p24 + inverse_D4_p38 +
      (0.1501 * (inverse_D4_p39 + inverse_D4_p45) - 0.4318 * (inverse_D4_p29 + inverse_D4_p41)));

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p52 = inverse_D4_p51 - inverse_D4_p48 * inverse_D4_p50;
  const Real inverse_D4_p53 = c6 * inverse_D4_p35 - inverse_D4_p25 -
      (0.1501 * inverse_D4_p46 + 0.4318 * inverse_D4_p31) - 0.0070992 - inverse_D4_p47 *
      inverse_D4_p50;
  const Real inverse_D2_p8 = inverse_D4_p44 - inverse_D4_p47 * inverse_D2_p6;
  const Real inverse_D2_p9 = inverse_D4_p36 - inverse_D2_p3 * inverse_D2_p5;
  const Real inverse_D4_p54 = 0.07312640000000001 +
      (inverse_D4_p23 - inverse_D4_p38 - 0.1501 * (inverse_D4_p40 + inverse_D4_p44)) -
      inverse_D4_p47 * inverse_D4_p49 - inverse_D4_p52;
  const Real inverse_D2_p10 = s5 * (0.10439999999999999 +
      (inverse_D4_p31 - 0.1501 * inverse_D4_p28) - inverse_D4_p47 * inverse_D2_p7) + c5 *
      (inverse_D4_p41 - 3.79559 - inverse_D4_p48 * inverse_D2_p7);
  const Real inverse_D2_p11 = s5 * (inverse_D4_p46 + inverse_D4_p42 + inverse_D4_p47 *
      inverse_D2_p5 - inverse_D4_p48 * inverse_D2_p6) - c5 *
      (inverse_D4_p45 - inverse_D4_p48 * inverse_D2_p5 + inverse_D2_p8);
  const Real inverse_D2_p12 = s5 * (inverse_D2_p9 -
      (inverse_D5_p11 - inverse_D2_p4 * inverse_D2_p6)) + inverse_D4_p26 *
      (inverse_D4_p37 - inverse_D2_p3 * inverse_D2_p6);
  const Real inverse_D2_p13 = c5 * inverse_D2_p11 + inverse_D2_p8 - 4.9338049999999996;

  // link 4 (link1), articulated inertia
  const Real inverse_D4 = 1.0 / (1.4717295504999999 +
      (inverse_D4_p52 + s5 * (s5 * inverse_D4_p54 + inverse_D4_p26 * inverse_D4_p53)));
  const Real inverse_D2_p14 = inverse_D2_p13 * inverse_D4;
  const Real inverse_D2_p15 = inverse_D2_p10 * inverse_D4;
  const Real inverse_D2_p16 = inverse_D2_p9 - s5 * inverse_D2_p12 - inverse_D2_p13 * inverse_D2_p14;
  const Real inverse_D2_p17 = inverse_D4_p22 - inverse_D4_p32 * inverse_D2_p7 - inverse_D2_p10 *
      inverse_D2_p15;
  const Real inverse_D2_p18 = inverse_D2_p13 * inverse_D2_p15 -
      (s5 * (inverse_D4_p28 - inverse_D2_p4 * inverse_D2_p7) - c5 *
      (inverse_D4_p27 - inverse_D2_p3 * inverse_D2_p7));
  const Real inverse_D2_p19 = s4 * (inverse_D2_p16 - inverse_D2_p17) + inverse_D2_p1 *
      inverse_D2_p18;
  const Real inverse_D2_p20 = s4 * inverse_D2_p19;
  const Real inverse_D2_p21 = inverse_D2_p16 - inverse_D2_p20;
  const Real inverse_D2_p22 = inverse_D2_p17 + inverse_D2_p20;
  const Real inverse_D2_p23 = c4 * inverse_D2_p19 - inverse_D2_p18;

  // link 3 (base), articulated inertia
  const Real inverse_D2_p24 = s3 * (inverse_D2_p21 - inverse_D2_p22) + inverse_D2_p2 *
      inverse_D2_p23;
  const Real inverse_D2_p25 = s3 * inverse_D2_p24;
  const Real inverse_D1_p1 = c3 * inverse_D2_p24 - inverse_D2_p23;

  // link 2 (base_y), articulated inertia
  const Real inverse_D2 = 1.0 / (186.45 + (inverse_D2_p22 + inverse_D2_p25));
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D2;

  // link 1 (base_x), articulated inertia
  const Real inverse_D1 = 1.0 / (186.45 + (inverse_D2_p21 - inverse_D2_p25) - inverse_D1_p1 *
      inverse_D1_p2);

  // link 2 (base_y), mobility
  const Real f9_z_p1 = inverse_D1 * inverse_D1_p2;
  const Real f9_z_p2 = inverse_D2 + inverse_D1_p2 * f9_z_p1;

  // link 3 (base), mobility
  const Real f9_z_p3 = s3 * (inverse_D1 - f9_z_p2) + inverse_D2_p2 * f9_z_p1;
  const Real f9_z_p4 = s3 * f9_z_p3;
  const Real f9_z_p5 = inverse_D1 - f9_z_p4;
  const Real f9_z_p6 = f9_z_p2 + f9_z_p4;
  const Real f9_z_p7 = f9_z_p1 - c3 * f9_z_p3;

  // link 4 (link1), mobility
  const Real f9_z_p8 = inverse_D2_p1 * f9_z_p7 - s4 * (f9_z_p5 - f9_z_p6);
  const Real f9_z_p9 = s4 * f9_z_p8;
  const Real f9_z_p10 = f9_z_p5 + f9_z_p9;
  const Real f9_z_p11 = c4 * f9_z_p8 - f9_z_p7;
  const Real f9_z_p12 = f9_z_p6 - f9_z_p9;

  // link 5 (link2), mobility
  const Real f9_z_p13 = s5 * f9_z_p10;
  const Real f9_z_p14 = c5 * f9_z_p11;
  const Real f9_z_p15 = s5 * f9_z_p11;

  // link 4 (link1), mobility
  const Real f9_z_p16 = f9_z_p10 * inverse_D2_p14 - f9_z_p11 * inverse_D2_p15;
  const Real f9_z_p17 = f9_z_p11 * inverse_D2_p14 - f9_z_p12 * inverse_D2_p15;

  // link 5 (link2), mobility
  const Real f9_z_p18 = s5 * f9_z_p13;
  const Real f9_z_p19 = c5 * f9_z_p13;
  const Real f9_z_p20 = c5 * f9_z_p16;
  const Real f9_z_p21 = s5 * f9_z_p17;
  const Real f9_z_p22 = c5 * f9_z_p17;
  const Real f9_z_p23 = f9_z_p10 - f9_z_p18;
  const Real f9_z_p24 = c5 * f9_z_p20;
  const Real f9_z_p25 = s5 * f9_z_p20;

  // link 4 (link1), mobility
  const Real f9_z_p26 = inverse_D4 + (inverse_D2_p14 * f9_z_p16 - inverse_D2_p15 * f9_z_p17);

  // link 5 (link2), mobility
  const Real f9_z_p27 = f9_z_p24 - f9_z_p16;
  const Real f9_z_p28 = s5 * f9_z_p26;
  const Real f9_z_p29 = f9_z_p14 * inverse_D2_p5 - f9_z_p15 * inverse_D2_p6 + f9_z_p12 *
      inverse_D2_p7 + (f9_z_p21 * inverse_D4_p49 + f9_z_p22 * inverse_D4_p50);
  const Real f9_z_p30 = s5 * f9_z_p28;
  const Real f9_z_p31 = c5 * f9_z_p28;
  const Real f9_z_p32 = f9_z_p23 * inverse_D2_p5 - f9_z_p19 * inverse_D2_p6 + f9_z_p14 *
      inverse_D2_p7 + (f9_z_p25 * inverse_D4_p49 + f9_z_p24 * inverse_D4_p50);
  const Real f9_z_p33 = f9_z_p26 - f9_z_p30;
  const Real f9_z_p34 = f9_z_p18 * inverse_D2_p6 - f9_z_p19 * inverse_D2_p5 - f9_z_p15 *
      inverse_D2_p7 + (f9_z_p27 * inverse_D4_p49 - f9_z_p25 * inverse_D4_p50);

  // link 6 (link3), mobility
  const Real f9_z_p35 = 0.1501 * f9_z_p31;
  const Real f9_z_p36 = f9_z_p21 - 0.4318 * f9_z_p31;
  const Real f9_z_p37 = f9_z_p25 + f9_z_p35;

  // link 5 (link2), mobility
  const Real f9_z_p38 = f9_z_p25 * inverse_D2_p5 + f9_z_p27 * inverse_D2_p6 + f9_z_p21 *
      inverse_D2_p7 + (f9_z_p30 * inverse_D4_p49 + f9_z_p31 * inverse_D4_p50);

  // link 6 (link3), mobility
  const Real f9_z_p39 = f9_z_p24 + 0.1501 * f9_z_p33;
  const Real f9_z_p40 = f9_z_p22 - 0.4318 * f9_z_p33;

  // link 5 (link2), mobility
  const Real f9_z_p41 = f9_z_p24 * inverse_D2_p5 - f9_z_p25 * inverse_D2_p6 + f9_z_p22 *
      inverse_D2_p7 + (f9_z_p31 * inverse_D4_p49 + f9_z_p33 * inverse_D4_p50);

  // link 6 (link3), mobility
  const Real f9_z_p42 = inverse_D5_p1 * f9_z_p31 - s6 * (f9_z_p30 - f9_z_p33);
  const Real f9_z_p43 = s6 * f9_z_p42;
  const Real f9_z_p44 = c6 * f9_z_p36 + s6 * f9_z_p40;
  const Real f9_z_p45 = c6 * f9_z_p40 - s6 * f9_z_p36;
  const Real f9_z_p46 = f9_z_p27 - (0.4318 * f9_z_p38 + 0.1501 * f9_z_p30);
  const Real f9_z_p47 = f9_z_p25 + 0.4318 * f9_z_p41;
  const Real f9_z_p48 = f9_z_p23 + 0.1501 * (f9_z_p24 + f9_z_p39);
  const Real f9_z_p49 = f9_z_p14 + (0.1501 * f9_z_p40 - 0.4318 * f9_z_p24);
  const Real f9_z_p50 = f9_z_p12 - 0.4318 * (f9_z_p22 + f9_z_p40);
  const Real f9_z_p51 = f9_z_p30 + f9_z_p43;
  const Real f9_z_p52 = c6 * f9_z_p42 - f9_z_p31;
  const Real f9_z_p53 = f9_z_p33 - f9_z_p43;

  // link 5 (link2), mobility
  const Real f9_z_p54 = inverse_D2_p5 * f9_z_p32 + inverse_D2_p6 * f9_z_p34 + inverse_D2_p7 *
      f9_z_p29 + (inverse_D4_p49 * f9_z_p38 + inverse_D4_p50 * f9_z_p41);

  // link 6 (link3), mobility
  const Real f9_z_p55 = f9_z_p47 + f9_z_p35;

  // link 7 (link4), mobility
  const Real f9_z_p56 = 2.0 * c7;

  // link 6 (link3), mobility
  const Real f9_z_p57 = 0.4318 * (f9_z_p47 - f9_z_p29) - 0.1501 * f9_z_p36 - f9_z_p15;
  const Real f9_z_p58 = c6 * (f9_z_p39 + f9_z_p46) - s6 * (f9_z_p37 + f9_z_p55);

  // link 8 (link5), mobility
  const Real f9_z_p59 = 2.0 * c8;

  // link 7 (link4), mobility
  const Real f9_z_p60 = f9_z_p44 - (0.4331 * f9_z_p51 - 0.0203 * f9_z_p52);

  // link 6 (link3), mobility
  const Real f9_z_p61 = f9_z_p19 + (0.1501 * (f9_z_p25 + f9_z_p55) + 0.4318 * f9_z_p32);
  const Real f9_z_p62 = s6 * f9_z_p58;
  const Real f9_z_p63 = c6 * f9_z_p58;
  const Real f9_z_p64 = c6 * f9_z_p49 + s6 * f9_z_p57;
  const Real f9_z_p65 = c6 * f9_z_p57 - s6 * f9_z_p49;
  const Real f9_z_p66 = f9_z_p37 + f9_z_p62;
  const Real f9_z_p67 = f9_z_p63 - f9_z_p46;
  const Real f9_z_p68 = f9_z_p63 - f9_z_p39;
  const Real f9_z_p69 = f9_z_p55 + f9_z_p62;
  const Real f9_z_p70 = 0.4318 * (0.4318 * (inverse_D5 + f9_z_p54) + 0.1501 * f9_z_p38 - 2.0 *
      f9_z_p34) - 0.1501 * (f9_z_p27 + f9_z_p46);
  const Real f9_z_p71 = f9_z_p18 + f9_z_p70;

  // link 7 (link4), mobility
  const Real f9_z_p72 = 0.0203 * (2.0 * f9_z_p45 - (0.4331 * f9_z_p52 - 0.0203 * f9_z_p53)) -
      0.4331 * (f9_z_p44 + f9_z_p60);
  const Real f9_z_p73 = f9_z_p50 + f9_z_p72;

  // link 6 (link3), mobility
  const Real f9_z_p74 = f9_z_p64 * inverse_D5_p4 - f9_z_p65 * inverse_D5_p5 + f9_z_p50 *
      inverse_D4_p11 + (f9_z_p44 * inverse_D4_p12 + f9_z_p45 * inverse_D4_p13);
  const Real f9_z_p75 = f9_z_p66 * inverse_D5_p4 - f9_z_p68 * inverse_D5_p5 + f9_z_p44 *
      inverse_D4_p11 + (f9_z_p51 * inverse_D4_p12 + f9_z_p52 * inverse_D4_p13);
  const Real f9_z_p76 = s6 * (f9_z_p48 - f9_z_p71) + inverse_D5_p1 * f9_z_p61;
  const Real f9_z_p77 = f9_z_p67 * inverse_D5_p4 + f9_z_p69 * inverse_D5_p5 + f9_z_p45 *
      inverse_D4_p11 + (f9_z_p52 * inverse_D4_p12 + f9_z_p53 * inverse_D4_p13);

  // link 7 (link4), mobility
  const Real f9_z_p78 = 0.4331 * f9_z_p75;

  // link 6 (link3), mobility
  const Real f9_z_p79 = s6 * f9_z_p76;

  // link 7 (link4), mobility
  const Real f9_z_p80 = f9_z_p66 - f9_z_p78;

  // link 6 (link3), mobility
  const Real f9_z_p81 = f9_z_p48 - f9_z_p79;
  const Real f9_z_p82 = f9_z_p61 - c6 * f9_z_p76;
  const Real f9_z_p83 = f9_z_p71 + f9_z_p79;

  // link 7 (link4), mobility
  const Real f9_z_p84 = f9_z_p74 + (0.0203 * f9_z_p77 - f9_z_p78);

  // link 6 (link3), mobility
  const Real f9_z_p85 = f9_z_p81 * inverse_D5_p4 - f9_z_p82 * inverse_D5_p5 + f9_z_p64 *
      inverse_D4_p11 + (f9_z_p66 * inverse_D4_p12 + f9_z_p67 * inverse_D4_p13);
  const Real f9_z_p86 = f9_z_p82 * inverse_D5_p4 - f9_z_p83 * inverse_D5_p5 + f9_z_p65 *
      inverse_D4_p11 + (f9_z_p68 * inverse_D4_p12 - f9_z_p69 * inverse_D4_p13);

  // link 7 (link4), mobility
  const Real f9_z_p87 = f9_z_p64 + (0.0203 * f9_z_p67 - 0.4331 * (f9_z_p84 + f9_z_p66));
  const Real f9_z_p88 = f9_z_p65 + (0.0203 * (f9_z_p84 - f9_z_p69) - 0.4331 * f9_z_p68);

  // link 6 (link3), mobility
  const Real f9_z_p89 = inverse_D5_p4 * f9_z_p85 - inverse_D5_p5 * f9_z_p86 + inverse_D4_p11 *
      f9_z_p74 + (inverse_D4_p12 * f9_z_p75 + inverse_D4_p13 * f9_z_p77);
  const Real f9_z_p90 = inverse_D6 + f9_z_p89;

  // link 7 (link4), mobility
  const Real f9_z_p91 = 0.4331 * f9_z_p90 - f9_z_p85;
  const Real f9_z_p92 = f9_z_p86 + 0.0203 * f9_z_p90;
  const Real f9_z_p93 = s7 * f9_z_p92 - c7 * (f9_z_p68 + 0.0203 * f9_z_p75);
  const Real f9_z_p94 = f9_z_p81 + 0.4331 * (f9_z_p91 - f9_z_p85);
  const Real f9_z_p95 = f9_z_p82 + (0.0203 * f9_z_p85 - 0.4331 * f9_z_p92);
  const Real f9_z_p96 = c7 * (f9_z_p91 + f9_z_p60) - s7 * (f9_z_p80 + f9_z_p84);
  const Real f9_z_p97 = f9_z_p83 + 0.0203 * (f9_z_p86 + f9_z_p92);
  const Real f9_z_p98 = f9_z_p51 - s7 * (s7 * (f9_z_p51 - f9_z_p90) + f9_z_p56 * f9_z_p75);
  const Real f9_z_p99 = c7 * f9_z_p95 + s7 * f9_z_p88;
  const Real f9_z_p100 = s7 * f9_z_p95 - c7 * f9_z_p88;
  const Real f9_z_p101 = f9_z_p80 + s7 * f9_z_p96;
  const Real f9_z_p102 = c7 * f9_z_p96 - f9_z_p91;
  const Real f9_z_p103 = f9_z_p56 * f9_z_p87 - s7 * (f9_z_p94 - f9_z_p73);
  const Real f9_z_p104 = s7 * f9_z_p103;

  // link 4 (link1), outward
  const Real w4_z = qd[2] + qd[3];

  // link 5 (link2), outward
  const Real minus_w5_x = s5 * w4_z;
  const Real minus_w5_y = c5 * w4_z;

  // link 3 (base), outward
  const Real a3_y = c3 * qdd_0[1] - s3 * qdd_0[0];
  const Real a3_x = c3 * qdd_0[0] + s3 * qdd_0[1];

  // link 7 (link4), mobility
  const Real f9_z_p105 = f9_z_p94 + f9_z_p104;
  const Real f9_z_p106 = c7 * f9_z_p103 - f9_z_p87;
  const Real f9_z_p107 = f9_z_p73 - f9_z_p104;

  // link 4 (link1), outward
  const Real wd4_z = qdd_0[2] + qdd_0[3];

  // link 7 (link4), mobility
  const Real f9_z_p108 = f9_z_p102 * inverse_D6_p9 - f9_z_p98 * inverse_D6_p10;

  // link 5 (link2), outward
  const Real wd5_y_p1 = minus_w5_x * qd[4];
  const Real wd5_y_p2 = c5 * wd4_z;
  const Real minus_wd5_x_p1 = s5 * wd4_z;
  const Real minus_wd5_x_p2 = minus_w5_y * qd[4];
  const Real a6_x_p1 = minus_w5_y * minus_w5_y;
  const Real a6_z_p1 = minus_w5_x * minus_w5_x;

  // link 7 (link4), mobility
  const Real f9_z_p109 = f9_z_p106 * inverse_D6_p9 - f9_z_p101 * inverse_D6_p10;

  // link 8 (link5), mobility
  const Real f9_z_p110 = c8 * f9_z_p106 - s8 * f9_z_p100;

  // link 7 (link4), mobility
  const Real f9_z_p111 = f9_z_p107 * inverse_D6_p9 - f9_z_p102 * inverse_D6_p10;

  // link 8 (link5), mobility
  const Real f9_z_p112 = s8 * f9_z_p106 + c8 * f9_z_p100;

  // link 5 (link2), outward
  const Real wd5_y = wd5_y_p1 - wd5_y_p2;

  // link 6 (link3), outward
  const Real w6_z = qd[4] + qd[5];

  // link 5 (link2), outward
  const Real minus_wd5_x = minus_wd5_x_p1 + minus_wd5_x_p2;

  // link 4 (link1), outward
  const Real a4_y = c4 * a3_y - s4 * a3_x;

  // link 8 (link5), mobility
  const Real f9_z_p113 = s8 * (f9_z_p105 - f9_z_p97) - f9_z_p59 * f9_z_p99;
  const Real f9_z_p114 = 4.484863585399276 * f9_z_p110;

  // link 5 (link2), outward
  const Real a6_x_p2 = qd[4] * qd[4];

  // link 8 (link5), mobility
  const Real f9_z_p115 = s8 * f9_z_p113;
  const Real f9_z_p116 = c8 * f9_z_p102 + s8 * f9_z_p111;

  // link 6 (link3), outward
  const Real minus_w6_x = c6 * minus_w5_x + s6 * minus_w5_y;

  // link 5 (link2), outward
  const Real a6_x_p3 = minus_w5_x * minus_w5_y;

  // link 6 (link3), outward
  const Real w6_y = s6 * minus_w5_x - c6 * minus_w5_y;

  // link 4 (link1), outward
  const Real a4_x = c4 * a3_x + s4 * a3_y;

  // link 6 (link3), outward
  const Real a6_x_p4 = a6_x_p1 + a6_x_p2;

  // link 8 (link5), mobility
  const Real f9_z_p117 = f9_z_p105 - f9_z_p115;
  const Real f9_z_p118 = s8 * (f9_z_p101 + (f9_z_p100 * inverse_D6_p9 - f9_z_p93 *
      inverse_D6_p10)) - c8 * (f9_z_p109 - f9_z_p93);
  const Real f9_z_p119 = c8 * f9_z_p113 + f9_z_p99;

  // link 5 (link2), outward
  const Real a6_x_p5 = a6_x_p3 + qdd_0[4];

  // link 8 (link5), mobility
  const Real f9_z_p120 = 4.484863585399276 * f9_z_p117;

  // link 6 (link3), outward
  const Real a7_x_p1 = minus_w6_x * w6_z;

  // link 8 (link5), mobility
  const Real f9_z_p121 = f9_z_p101 - s8 * f9_z_p118;

  // link 9 (link6), mobility
  const Real f9_z_p122 = c9 * f9_z_p119 + s9 * f9_z_p112;

  // link 6 (link3), outward
  const Real a7_x_p2 = w6_y * w6_y;

  // link 9 (link6), outward
  const Real f9_z_p123 = c3 * xdd_cmd[0] + s3 * xdd_cmd[1];
  const Real f9_z_p124 = c3 * xdd_cmd[1] - s3 * xdd_cmd[0];

  // link 6 (link3), outward
  const Real a7_x_p3 = w6_z * w6_z;
  const Real a7_x_p4 = minus_w6_x * w6_y;

  // link 9 (link6), outward
  const Real f9_z_p125 = 9.81 + xdd_cmd[2];

  // link 9 (link6), mobility
  const Real f9_z_p126 = c9 * (2.0 * f9_z_p110) - s9 * (f9_z_p117 - f9_z_p107);

  // link 5 (link2), outward
  const Real a6_z_p2 = wd5_y_p1 + wd5_y;

  // link 6 (link3), outward
  const Real wd6_y = s6 * minus_wd5_x + c6 * wd5_y + minus_w6_x * qd[5];

  // link 9 (link6), mobility
  const Real f9_z_p127 = s9 * f9_z_p126;

  // link 9 (link6), outward
  const Real f9_z_p128 = c3 * xdd_cmd[3] + s3 * xdd_cmd[4];

  // link 6 (link3), outward
  const Real wd6_x = s6 * wd5_y - c6 * minus_wd5_x + w6_y * qd[5];

  // link 5 (link2), outward
  const Real a5_x = c5 * a4_x - 9.81 * s5;

  // link 9 (link6), outward
  const Real f9_z_p129 = c3 * xdd_cmd[4] - s3 * xdd_cmd[3];
  const Real f9_z_p130 = c4 * f9_z_p123 + s4 * f9_z_p124;

  // link 5 (link2), outward
  const Real minus_a5_y = s5 * a4_x + 9.81 * c5;

  // link 6 (link3), outward
  const Real wd6_z = qdd_0[4] + qdd_0[5];

  // link 8 (link5), mobility
  const Real f9_z_p131 = 4.484863585399276 * f9_z_p119;

  // link 9 (link6), mobility
  const Real f9_z_p132 = c9 * (f9_z_p116 - f9_z_p120) - s9 * (f9_z_p121 + f9_z_p114);
  const Real f9_z_p133 = c9 * f9_z_p126 - f9_z_p110;
  const Real f9_z_p134 = 1.0 / (f9_z_p117 + f9_z_p127);
  const Real f9_z_p135 = c9 * f9_z_p132;
  const Real f9_z_p136 = s9 * f9_z_p132;

  // link 8 (link5), mobility
  const Real f9_z_p137 = c8 * f9_z_p118 + f9_z_p109;

  // link 6 (link3), outward
  const Real a7_x_p5 = a7_x_p1 + wd6_y;

  // link 9 (link6), outward
  const Real f9_z_p138 = c4 * f9_z_p128 + s4 * f9_z_p129;

  // link 6 (link3), outward
  const Real a7_x_p6 = w6_y * w6_z + wd6_x;
  const Real a6_x_p6 = a5_x - (0.4318 * a6_x_p4 + 0.1501 * wd5_y_p2);
  const Real a6_x_p7 = 0.4318 * a6_x_p5 + 0.1501 * minus_wd5_x_p1 - minus_a5_y;

  // link 7 (link4), outward
  const Real a7_x_p7 = a7_x_p2 + a7_x_p3;

  // link 6 (link3), outward
  const Real a7_x_p8 = a7_x_p4 + wd6_z;

  // link 9 (link6), outward
  const Real f9_z_p139 = c4 * f9_z_p129 - s4 * f9_z_p128;

  // link 9 (link6), mobility
  const Real f9_z_p140 = f9_z_p135 - f9_z_p116;
  const Real f9_z_p141 = f9_z_p121 + f9_z_p136;

  // link 9 (link6), outward
  const Real f9_z_p142 = c5 * f9_z_p130 - s5 * f9_z_p125;
  const Real f9_z_p143 = s5 * f9_z_p130 + c5 * f9_z_p125;

  // link 7 (link4), outward
  const Real w7_x = s7 * w6_z - c7 * minus_w6_x;
  const Real w7_z = qd[6] - w6_y;

  // link 9 (link6), outward
  const Real f9_z_p144 = c5 * f9_z_p138 - s5 * xdd_cmd[5];
  const Real f9_z_p145 = s5 * f9_z_p138 + c5 * xdd_cmd[5];

  // link 6 (link3), outward
  const Real minus_a7_z_p1 = minus_w6_x * minus_w6_x;

  // link 8 (link5), mobility
  const Real f9_z_p146 = s8 * (f9_z_p98 - (inverse_D7 +
      (inverse_D6_p9 * f9_z_p111 - inverse_D6_p10 * f9_z_p108))) - f9_z_p59 * f9_z_p108;

  // link 9 (link6), mobility
  const Real f9_z_p147 = f9_z_p140 * f9_z_p134;
  const Real f9_z_p148 = f9_z_p141 * f9_z_p134;
  const Real f9_z_p149 = f9_z_p122 * f9_z_p134;
  const Real f9_z_p150 = f9_z_p133 * f9_z_p134;

  // link 6 (link3), outward
  const Real a6_z = a4_y - (0.4318 * a6_z_p2 + 0.1501 * (a6_z_p1 + a6_x_p1));

  // link 9 (link6), outward
  const Real f9_z_p151 = c6 * f9_z_p144 - s6 * f9_z_p145;

  // link 6 (link3), outward
  const Real a6_x = c6 * a6_x_p6 + s6 * a6_x_p7;

  // link 9 (link6), outward
  const Real f9_z_p152 = s6 * f9_z_p144 + c6 * f9_z_p145;

  // link 7 (link4), outward
  const Real w7_y = s7 * minus_w6_x + c7 * w6_z;
  const Real minus_a7_z_p2 = minus_a7_z_p1 + a7_x_p3;

  // link 6 (link3), outward
  const Real minus_a7_z_p3 = wd6_z - a7_x_p4;

  // link 7 (link4), outward
  const Real a7_x_p9 = a6_z + (0.0203 * a7_x_p5 - 0.4331 * a7_x_p6);

  // link 9 (link6), outward
  const Real f9_z_p160 = c6 * f9_z_p142 - s6 * f9_z_p143;
  const Real f9_z_p161 = c4 * f9_z_p124 - s4 * f9_z_p123;

  // link 7 (link4), outward
  const Real a7_x_p10 = a6_x + (0.0203 * a7_x_p7 + 0.4331 * a7_x_p8);

  // link 8 (link5), outward
  const Real w8_x = c8 * w7_x - s8 * w7_z;
  const Real w8_z = w7_y + qd[7];

  // link 9 (link6), mobility
  const Lanes<8> f9_z_p162_lanes = detail::make_pack<Real>(f9_z_p107 - f9_z_p127, f9_z_p107 -
      f9_z_p127, c9 * f9_z_p112 - s9 * f9_z_p119, f9_z_p135 + f9_z_p120, -(f9_z_p114 + f9_z_p136),
      f9_z_p107 - f9_z_p127, f9_z_p107 - f9_z_p127, f9_z_p107 - f9_z_p127) -
      detail::make_pack<Real>(f9_z_p150, f9_z_p150, f9_z_p149, f9_z_p148, f9_z_p147, f9_z_p150,
      f9_z_p150, f9_z_p150) * f9_z_p133;

  // link 8 (link5), mobility
  const Real f9_z_p169 = f9_z_p98 - s8 * f9_z_p146;

  // link 9 (link6), outward
  const Real f9_z_p170 = c7 * f9_z_p151 + s7 * f9_z_p139;

  // link 8 (link5), mobility
  const Real f9_z_p171 = 1557.24430048586 + 20.114001379640452 * f9_z_p117;

  // link 9 (link6), mobility
  const Real f9_z_p172 = 1.0 / f9_z_p162_lanes[1];

  // link 9 (link6), outward
  const Real f9_z_p173 = c7 * f9_z_p139 - s7 * f9_z_p151;

  // link 8 (link5), outward
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;

  // link 6 (link3), outward
  const Real a6_y = c6 * a6_x_p7 - s6 * a6_x_p6;

  // link 9 (link6), outward
  const Real w9_x = c9 * w8_x + s9 * w8_z;
  const Real w9_z = minus_w8_y + qd[8];

  // link 7 (link4), outward
  const Real a7_x = c7 * a7_x_p10 + s7 * a7_x_p9;

  // link 9 (link6), outward
  const Real f9_z_p174 = c8 * f9_z_p170 - s8 * f9_z_p152;

  // link 7 (link4), outward
  const Real minus_a7_z = a6_y + (0.4331 * minus_a7_z_p2 - 0.0203 * minus_a7_z_p3);

  // link 9 (link6), outward
  const Real f9_z_p175 = c7 * f9_z_p160 + s7 * f9_z_p161;
  const Real f9_z_p176 = s6 * f9_z_p142 + c6 * f9_z_p143;
  const Real f9_z_p177 = w9_x * w9_z;

  // link 7 (link4), outward
  const Real a7_y = c7 * a7_x_p9 - s7 * a7_x_p10;

  // link 9 (link6), mobility
  const Real f9_z_p178 = s9 * (f9_z_p169 - f9_z_p171) + c9 * (8.969727170798553 * f9_z_p121);

  // link 9 (link6), outward
  const Real f9_z_p179 = c7 * f9_z_p161 - s7 * f9_z_p160 - a7_y;
  const Real w9_y = c9 * w8_z - s9 * w8_x;

  // link 7 (link4), outward
  const Real wd7_z = qdd_0[6] - wd6_y;

  // link 9 (link6), mobility
  const Lanes<8> f9_z_p180_lanes = f9_z_p162_lanes * f9_z_p172;

  // link 9 (link6), outward
  const Real f9_z_p183 = c9 * f9_z_p173 - s9 * f9_z_p174;

  // link 9 (link6), mobility
  const Real f9_z_p184 = s9 * f9_z_p178;

  // link 8 (link5), outward
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;

  // link 9 (link6), outward
  const Real f9_z_p185 = w9_y * w9_z;
  const Real f9_z_p186 = c9 * f9_z_p174 + s9 * f9_z_p173;
  const Real f9_z_p190 = c8 * f9_z_p175 - s8 * f9_z_p176 - a8_x;

  // link 7 (link4), outward
  const Real wd7_x = c7 * wd6_x + s7 * wd6_z + w7_y * qd[6];
  const Real wd7_y = c7 * wd6_z - s7 * wd6_x - w7_x * qd[6];

  // link 9 (link6), mobility
  const Lanes<8> f9_z_p191_lanes = detail::make_pack<Real>(f9_z_p97 + f9_z_p115, f9_z_p97 +
      f9_z_p115, f9_z_p97 + f9_z_p115, c9 * f9_z_p137 - s9 * f9_z_p131,
      -(s9 * f9_z_p137 + c9 * f9_z_p131), f9_z_p97 + f9_z_p115, f9_z_p97 + f9_z_p115, f9_z_p97 +
      f9_z_p115) - detail::make_pack<Real>(f9_z_p149, f9_z_p149, f9_z_p149, f9_z_p148, f9_z_p147,
      f9_z_p149, f9_z_p149, f9_z_p149) * f9_z_p122 - f9_z_p180_lanes * f9_z_p162_lanes[2];

  // link 8 (link5), outward
  const Real wd8_z = wd7_y + qdd_0[7];

  // link 9 (link6), mobility
  const Real f9_z_p194 = 1.0 / f9_z_p191_lanes[2];

  // link 9 (link6), outward
  const Real f9_z_p195 = f9_z_p179 * s9 - 0.05625 * (f9_z_p177 + f9_z_p183) + f9_z_p190 * c9;

  // link 8 (link5), outward
  const Real f8_x_p1 = w8_x * minus_w8_y;
  const Real wd8_x = c8 * wd7_x - s8 * wd7_z - minus_w8_y * qd[7];
  const Real f8_z_p1 = wd8_x - minus_w8_y * w8_z;

  // link 5 (link2), outward
  const Real f5_x_p1 = a6_x_p3 - qdd_0[4];
  const Real f5_z_p1 = minus_wd5_x_p2 + minus_wd5_x;

  // link 9 (link6), mobility
  const Real f9_z_p196 = f9_z_p191_lanes[3] * f9_z_p194;
  const Real f9_z_p197 = f9_z_p191_lanes[4] * f9_z_p194;

  // link 9 (link6), outward
  const Real wd9_x = c9 * wd8_x + s9 * wd8_z + w9_y * qd[8];
  const Real wd9_y = c9 * wd8_z - s9 * wd8_x - w9_x * qd[8];

  // link 9 (link6), mobility
  const Real f9_z_p198 = 0.05625 * (f9_z_p186 - f9_z_p185) - f9_z_p150 * f9_z_p195 - f9_z_p190 *
      s9 + f9_z_p179 * c9;
  const Real f9_z_p199 = 4.484863585399276 * f9_z_p121 - c9 * f9_z_p178 - f9_z_p147 * f9_z_p141 -
      f9_z_p180_lanes[4] * f9_z_p162_lanes[3] - f9_z_p197 * f9_z_p191_lanes[3];
  const Real f9_z_p200 = 0.05625 * (w9_x * w9_x + w9_y * w9_y) - f9_z_p149 * f9_z_p195 -
      f9_z_p180_lanes[2] * f9_z_p198;

  // link 8 (link5), outward
  const Real minus_wd8_y = s8 * wd7_x + c8 * wd7_z + w8_x * qd[7];

  // link 9 (link6), inertial wrench
  const Real n9_z = 4e-05 * (s8 * f9_z_p170 + c8 * f9_z_p152);
  tau[8] = n9_z;

  // link 9 (link6), mobility
  const Real f9_z_p201 = 1.0 / (f9_z_p169 - f9_z_p184 - f9_z_p148 * f9_z_p141 - f9_z_p180_lanes[3] *
      f9_z_p162_lanes[3] - f9_z_p196 * f9_z_p191_lanes[3]);
  const Real f9_z_p202 = f9_z_p200 + (f9_z_p176 + minus_a7_z) * c8 + (f9_z_p175 - a7_x) * s8;

  // link 9 (link6), inward
  const Real minus_n8_y = 2e-04 * (w8_x * w8_z + minus_wd8_y) + n9_z;

  // link 9 (link6), mobility
  const Real f9_z_p203 = f9_z_p186 - wd9_x - f9_z_p148 * f9_z_p195 - f9_z_p180_lanes[3] *
      f9_z_p198 - f9_z_p196 * f9_z_p202;
  const Real f9_z_p204 = f9_z_p199 * f9_z_p201;

  // link 6 (link3), inertial wrench
  const Real n6_x_p1 = 0.3056901365 * a7_x_p6 - 0.010673638499999999 * a7_x_p5 -
      0.004704000000000001 * (a7_x_p3 - a7_x_p2) - 0.861795 * a6_z;

  // link 9 (link6), mobility
  const Real f9_z_p205 = f9_z_p171 + f9_z_p184 - f9_z_p147 * f9_z_p140 - f9_z_p180_lanes[4] *
      f9_z_p162_lanes[4] - f9_z_p197 * f9_z_p191_lanes[4] - f9_z_p204 * f9_z_p199;
  const Real f9_z_p206 = f9_z_p183 - wd9_y - f9_z_p147 * f9_z_p195 - f9_z_p180_lanes[4] *
      f9_z_p198 - f9_z_p197 * f9_z_p202 - f9_z_p204 * f9_z_p203;

  // link 5 (link2), inertial wrench
  const Real n5_y_p1 = 1.674987602 * a6_z_p2 + 0.023750999999999998 * f5_x_p1 + 0.0070992 *
      f5_z_p1 + 0.690314699 * (a6_z_p1 - a6_x_p2);
  const Real n5_x_p1 = 0.023750999999999998 * (a6_x_p2 - a6_x_p1) -
      (0.07312640000000001 * f5_z_p1 + 0.0070992 * a6_z_p2 + 0.690314699 * a6_x_p5);

  // link 6 (link3), inertial wrench
  const Real n6_z_p1 = 0.298925024 * a7_x_p4 + 0.312455249 * wd6_z + 0.004704000000000001 *
      (wd6_y - a7_x_p1) + 0.010673638499999999 * (a7_x_p2 - minus_a7_z_p1);

  // link 9 (link6), mobility
  const Real f9_z_p207 = f9_z_p206 * (1.0 / f9_z_p205);

  // link 9 (link6), inertial wrench
  const Real n9_y = f9_z_p207 - 2e-05 * (f9_z_p177 - wd9_y);

  // link 9 (link6), mobility
  const Real f9_z_p208 = f9_z_p203 * f9_z_p201 - f9_z_p204 * f9_z_p207;

  // link 9 (link6), inertial wrench
  const Real n9_x = 2e-05 * (f9_z_p185 + wd9_x) + f9_z_p208;

  // link 9 (link6), mobility
  const Real f9_z = f9_z_p202 * f9_z_p194 - f9_z_p196 * f9_z_p208 - f9_z_p197 * f9_z_p207;

  // link 5 (link2), inertial wrench
  const Real n5_z_p1 = 1.601861202 * a6_x_p3 + 1.7481140020000001 * qdd_0[4] + 0.690314699 *
      minus_wd5_x_p1 + 0.023750999999999998 * wd5_y_p2 + 0.0070992 * (a6_x_p1 - a6_z_p1);

  // link 9 (link6), inward
  const Real f8_y = 0.0028799999999999997 * (w8_x * w8_x + w8_z * w8_z) - f9_z;
  const Real n8_x = 0.00042216 * f8_z_p1 - 0.0028799999999999997 * a7_y + (c9 * n9_x - s9 * n9_y);
  const Real n8_z = 0.00022215999999999997 * f8_x_p1 + 0.00062216 * wd8_z + 0.0028799999999999997 *
      a8_x + (s9 * n9_x + c9 * n9_y);
  tau[7] = n8_z;

  // link 8 (link5), inward
  const Real n7_y = n8_z - 0.00065 * (w7_x * w7_z - wd7_y);

  // link 9 (link6), mobility
  const Real f9_y = f9_z_p198 * f9_z_p172 - f9_z_p180_lanes[2] * f9_z - f9_z_p180_lanes[3] *
      f9_z_p208 - f9_z_p180_lanes[4] * f9_z_p207;

  // link 8 (link5), inward
  const Real n7_x = 0.0007499999999999999 * (w7_y * w7_z + wd7_x) + (c8 * n8_x + s8 * minus_n8_y);
  const Real n7_z = 0.0013999999999999998 * wd7_z - 9.999999999999994e-05 * (w7_x * w7_y) +
      (c8 * minus_n8_y - s8 * n8_x);
  tau[6] = n7_z;

  // link 9 (link6), mobility
  const Real f9_x = f9_z_p195 * f9_z_p134 - f9_z_p150 * f9_y - f9_z_p149 * f9_z - f9_z_p148 *
      f9_z_p208 - f9_z_p147 * f9_z_p207;

  // link 9 (link6), inward
  const Real f8_x = 0.0028799999999999997 * (f8_x_p1 + wd8_z) + (c9 * f9_x - s9 * f9_y);
  const Real f8_z = s9 * f9_x + c9 * f9_y - 0.0028799999999999997 * f8_z_p1;

  // link 8 (link5), inward
  const Real minus_f7_x = s8 * f8_y - c8 * f8_x;
  const Real minus_f7_z = s8 * f8_x + c8 * f8_y;

  // link 7 (link4), inward
  const Real f6_y = 0.861795 * minus_a7_z_p2 - 0.025374999999999998 * minus_a7_z_p3 + minus_f7_z;
  const Real f6_x_p1 = c7 * minus_f7_x + s7 * f8_z;
  const Real n6_x_p2 = c7 * f8_z - s7 * minus_f7_x;
  const Real f6_x = 0.025374999999999998 * a7_x_p7 + 0.861795 * a7_x_p8 - f6_x_p1;
  const Real f6_z = 0.025374999999999998 * a7_x_p5 - 0.861795 * a7_x_p6 + n6_x_p2;

  // link 6 (link3), inward
  const Real f5_z = f6_z - (3.79559 * a6_z_p2 + 0.10439999999999999 * f5_z_p1);

  // link 5 (link2), inward
  const Real f4_y = f5_z - 4.9338049999999996 * (w4_z * w4_z);

  // link 6 (link3), inward
  const Real f5_y_p1 = s6 * f6_x + c6 * f6_y;
  const Real f5_x_p2 = c6 * f6_x - s6 * f6_y;

  // link 7 (link4), inward
  const Real n6_x = n6_x_p1 + (c7 * n7_x - s7 * n7_y - 0.4331 * n6_x_p2);
  const Real n6_y = 0.0067651125 * a7_x_p5 + 0.004704000000000001 * a7_x_p8 - 0.010673638499999999 *
      a7_x_p6 + 0.025374999999999998 * a6_z + (0.0203 * n6_x_p2 - n7_z);

  // link 6 (link3), inward
  const Real f5_y = 3.79559 * a6_x_p5 - 0.10439999999999999 * (a6_z_p1 + a6_x_p2) + f5_y_p1;
  const Real f5_x = 0.10439999999999999 * f5_x_p1 - 3.79559 * a6_x_p4 + f5_x_p2;

  // link 7 (link4), inward
  const Real n6_z = n6_z_p1 + (0.861795 * a6_x - 0.025374999999999998 * a6_y) +
      (s7 * n7_x + c7 * n7_y - (0.0203 * minus_f7_z + 0.4331 * f6_x_p1));
  tau[5] = n6_z;

  // link 6 (link3), inward
  const Real n5_z = n5_z_p1 - (3.79559 * minus_a5_y + 0.10439999999999999 * a5_x) +
      (n6_z + 0.4318 * f5_y_p1);
  tau[4] = n5_z;

  // link 5 (link2), inward
  const Real minus_f4_x = 4.9338049999999996 * wd4_z + (s5 * f5_y - c5 * f5_x);

  // link 6 (link3), inward
  const Real n5_y = n5_y_p1 - 3.79559 * a4_y + (s6 * n6_x + c6 * n6_y +
      (0.1501 * f5_x_p2 - 0.4318 * f6_z));
  const Real n5_x = n5_x_p1 + 0.10439999999999999 * a4_y +
      (c6 * n6_x - s6 * n6_y - 0.1501 * f5_y_p1);

  // link 4 (link1), inward
  const Real minus_f3_x = c4 * minus_f4_x + s4 * f4_y;
  const Real f3_y = c4 * f4_y - s4 * minus_f4_x;

  // link 5 (link2), inward
  const Real n4_z = 1.4717295504999999 * wd4_z - 4.9338049999999996 * a4_x -
      (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

  // link 4 (link1), inward
  const Real n3_z = 7.2 * qdd_0[2] + n4_z;
  tau[2] = n3_z;

  // link 3 (base), inward
  const Real f2_x = 186.45 * qdd_0[0] - (c3 * minus_f3_x + s3 * f3_y);
  tau[0] = f2_x;
  const Real f2_z = 186.45 * qdd_0[1] + (c3 * f3_y - s3 * minus_f3_x);
  tau[1] = f2_z;
}

}  // namespace samm

#undef TREELINE_RESTRICT
