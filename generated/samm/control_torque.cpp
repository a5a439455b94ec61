// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at link origins.
// 1472 flops (add 621, mul 840, div 11), sine and cosine of 7 angles
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
  const Real f9_z_p1 = 0.861795 + inverse_D6_p17;

  // link 6 (link3), articulated inertia
  const Real f9_z_p2 = f9_z_p1 * inverse_D6;

  // link 7 (link4), articulated inertia
  const Real f9_z_p3 = s7 * inverse_D6_p5;
  const Real f9_z_p4 = c7 * inverse_D6_p12;
  const Real f9_z_p5 = f9_z_p3 + 0.4331 * f9_z_p4;
  const Real f9_z_p6 = s7 * inverse_D6_p15;
  const Real f9_z_p7 = 0.0203 * f9_z_p6;
  const Real f9_z_p8 = f9_z_p5 + f9_z_p7;
  const Real f9_z_p9 = 0.004704000000000001 + 0.0203 * f9_z_p8;

  // link 6 (link3), articulated inertia
  const Real f9_z_p10 = 0.0203 * f9_z_p4 - f9_z_p9 * f9_z_p2;

  // link 7 (link4), articulated inertia
  const Real f9_z_p11 = 0.025374999999999998 + inverse_D6_p18;

  // link 6 (link3), articulated inertia
  const Real f9_z_p12 = f9_z_p11 * inverse_D6;

  // link 7 (link4), articulated inertia
  const Real f9_z_p13 = c7 * inverse_D6_p21 - 0.4331 * (f9_z_p8 + f9_z_p3);

  // link 6 (link3), articulated inertia
  const Real f9_z_p14 = 0.4331 * f9_z_p6 + f9_z_p13 * f9_z_p12;
  const Real f9_z_p15 = f9_z_p5 + f9_z_p13 * f9_z_p2;
  const Real f9_z_p16 = f9_z_p9 * f9_z_p12 - f9_z_p7;
  const Real f9_z_p17 = c6 * (f9_z_p10 + f9_z_p14) - s6 * (f9_z_p15 + f9_z_p16);
  const Real f9_z_p18 = s6 * f9_z_p17;
  const Real f9_z_p19 = f9_z_p8 * inverse_D6;
  const Real f9_z_p20 = f9_z_p4 - f9_z_p1 * f9_z_p19;
  const Real f9_z_p21 = f9_z_p11 * f9_z_p19 - f9_z_p6;
  const Real f9_z_p22 = s6 * f9_z_p20 + c6 * f9_z_p21;
  const Real f9_z_p23 = 0.4318 * f9_z_p22;
  const Real f9_z_p24 = f9_z_p16 + f9_z_p18 - f9_z_p23;
  const Real f9_z_p25 = inverse_D6_p14 - f9_z_p1 * f9_z_p2;
  const Real f9_z_p26 = inverse_D6_p10 + f9_z_p11 * f9_z_p12;
  const Real f9_z_p27 = f9_z_p1 * f9_z_p12 - inverse_D6_p16;
  const Real f9_z_p28 = 2.0 * c6;
  const Real f9_z_p29 = s6 * (f9_z_p25 + f9_z_p26) + f9_z_p28 * f9_z_p27;
  const Real f9_z_p30 = c6 * f9_z_p29 - f9_z_p27;
  const Real f9_z_p31 = 0.1501 * f9_z_p30;
  const Real f9_z_p32 = f9_z_p15 + f9_z_p18 + (f9_z_p24 + f9_z_p31);
  const Real f9_z_p33 = c6 * f9_z_p17;
  const Real f9_z_p34 = f9_z_p33 - f9_z_p10;
  const Real f9_z_p35 = s6 * f9_z_p29;
  const Real f9_z_p36 = f9_z_p35 - f9_z_p26;
  const Real f9_z_p37 = 0.4318 * f9_z_p34 - 0.06481318000000001 * f9_z_p36 - 0.690314699;
  const Real f9_z_p38 = 0.4318 * f9_z_p30 - 0.10439999999999999;

  // link 5 (link2), articulated inertia
  const Real inverse_D5 = 1.0 / (1.7481140020000001 + 0.18645124000000002 * f9_z_p36);
  const Real f9_z_p39 = f9_z_p38 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real f9_z_p40 = 0.4318 * f9_z_p24 + 0.06481318000000001 * f9_z_p30 - 0.023750999999999998;
  const Real f9_z_p41 = 3.79559 + 0.4318 * f9_z_p36;

  // link 5 (link2), articulated inertia
  const Real f9_z_p42 = f9_z_p41 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real f9_z_p43 = f9_z_p33 - f9_z_p14;
  const Real f9_z_p44 = c6 * f9_z_p20 - s6 * f9_z_p21;
  const Real f9_z_p45 = f9_z_p25 - f9_z_p35;
  const Real f9_z_p46 = f9_z_p43 - (0.4318 * f9_z_p44 - 0.1501 * f9_z_p45);
  const Real f9_z_p47 = f9_z_p34 - 0.1501 * f9_z_p36;

  // link 5 (link2), articulated inertia
  const Real f9_z_p48 = f9_z_p47 - f9_z_p37 * f9_z_p42;
  const Real f9_z_p49 = s5 * (f9_z_p32 + f9_z_p31 + f9_z_p37 * f9_z_p39 - f9_z_p40 * f9_z_p42) -
      c5 * (f9_z_p46 - f9_z_p40 * f9_z_p39 + f9_z_p48);
  const Real f9_z_p50 = c5 * f9_z_p49 + f9_z_p48 - 4.9338049999999996;

  // link 7 (link4), articulated inertia
  const Real inverse_D4_p1 = inverse_D6_p13 - inverse_D6_p8;
  const Real inverse_D4_p2 = inverse_D6_p6 - 0.4331 * inverse_D4_p1;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p3 = f9_z_p13 * inverse_D6;
  const Real inverse_D4_p4 = 0.3056901365 + (inverse_D6_p20 - inverse_D6_p22 - 0.4331 *
      (inverse_D6_p6 + inverse_D4_p2)) - f9_z_p13 * inverse_D4_p3;
  const Real inverse_D4_p5 = f9_z_p9 * inverse_D6;
  const Real inverse_D4_p6 = 0.0067651125 + 0.00041208999999999994 * inverse_D4_p1 - f9_z_p9 *
      inverse_D4_p5;
  const Real inverse_D4_p7 = 0.0203 * inverse_D6_p6 - 0.00879193 * inverse_D4_p1 -
      0.010673638499999999 - f9_z_p13 * inverse_D4_p5;
  const Real inverse_D4_p8 = s6 * (inverse_D4_p4 - inverse_D4_p6) + f9_z_p28 * inverse_D4_p7;
  const Real inverse_D4_p9 = s6 * inverse_D4_p8;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p10 = f9_z_p37 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p11 = inverse_D4_p2 - 0.861795 - f9_z_p13 * f9_z_p19;
  const Real inverse_D4_p12 = 0.025374999999999998 + 0.0203 * inverse_D4_p1 - f9_z_p9 * f9_z_p19;
  const Real inverse_D4_p13 = s6 * inverse_D4_p11 + c6 * inverse_D4_p12;
  const Real inverse_D4_p14 = inverse_D4_p1 - f9_z_p8 * f9_z_p19;
  const Real inverse_D4_p15 = inverse_D4_p13 - (0.4318 * inverse_D4_p14 - 0.1501 * f9_z_p44);
  const Real inverse_D4_p16 = 1.674987602 + (inverse_D4_p6 + inverse_D4_p9 +
      (0.1501 * (f9_z_p43 + f9_z_p46) - 0.4318 * (inverse_D4_p13 + inverse_D4_p15)));

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p17 = f9_z_p40 * inverse_D5;
  const Real inverse_D4_p18 = inverse_D4_p16 - f9_z_p40 * inverse_D4_p17;
  const Real inverse_D4_p19 = 0.07312640000000001 +
      (inverse_D4_p4 - inverse_D4_p9 - 0.1501 * (f9_z_p34 + f9_z_p47)) - f9_z_p37 * inverse_D4_p10 -
      inverse_D4_p18;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p20 = c6 * inverse_D4_p11 - s6 * inverse_D4_p12;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p21 = c6 * inverse_D4_p8 - inverse_D4_p7 -
      (0.1501 * f9_z_p32 + 0.4318 * inverse_D4_p20) - 0.0070992 - f9_z_p37 * inverse_D4_p17;
  const Real inverse_D4_p22 = 2.0 * c5;

  // link 4 (link1), articulated inertia
  const Real inverse_D4 = 1.0 / (1.4717295504999999 +
      (inverse_D4_p18 + s5 * (s5 * inverse_D4_p19 + inverse_D4_p22 * inverse_D4_p21)));
  const Real f9_z_p51 = f9_z_p50 * inverse_D4;

  // link 5 (link2), articulated inertia
  const Real f9_z_p52 = f9_z_p45 - f9_z_p38 * f9_z_p39;
  const Real f9_z_p53 = s5 * (f9_z_p52 - (f9_z_p36 - f9_z_p41 * f9_z_p42)) + inverse_D4_p22 *
      (f9_z_p30 - f9_z_p38 * f9_z_p42);

  // link 4 (link1), articulated inertia
  const Real f9_z_p54 = f9_z_p52 - s5 * f9_z_p53 - f9_z_p50 * f9_z_p51;

  // link 5 (link2), articulated inertia
  const Real f9_z_p55 = f9_z_p23 * inverse_D5;
  const Real f9_z_p56 = s5 * (0.10439999999999999 + (inverse_D4_p20 - 0.1501 * f9_z_p22) -
      f9_z_p37 * f9_z_p55) + c5 * (inverse_D4_p15 - 3.79559 - f9_z_p40 * f9_z_p55);

  // link 4 (link1), articulated inertia
  const Real f9_z_p57 = f9_z_p56 * inverse_D4;
  const Real f9_z_p58 = inverse_D4_p14 - f9_z_p23 * f9_z_p55 - f9_z_p56 * f9_z_p57;
  const Real f9_z_p59 = f9_z_p50 * f9_z_p57 - (s5 * (f9_z_p22 - f9_z_p41 * f9_z_p55) - c5 *
      (f9_z_p44 - f9_z_p38 * f9_z_p55));
  const Real f9_z_p60 = s4 * (f9_z_p54 - f9_z_p58) + c4 * (2.0 * f9_z_p59);
  const Real f9_z_p61 = s4 * f9_z_p60;
  const Real f9_z_p62 = f9_z_p54 - f9_z_p61;
  const Real f9_z_p63 = f9_z_p58 + f9_z_p61;
  const Real f9_z_p64 = c4 * f9_z_p60 - f9_z_p59;

  // link 3 (base), articulated inertia
  const Real f9_z_p65 = s3 * (f9_z_p62 - f9_z_p63) + c3 * (2.0 * f9_z_p64);
  const Real f9_z_p66 = c3 * f9_z_p65 - f9_z_p64;
  const Real inverse_D2_p1 = s3 * f9_z_p65;

  // link 2 (base_y), articulated inertia
  const Real inverse_D2 = 1.0 / (186.45 + (f9_z_p63 + inverse_D2_p1));
  const Real f9_z_p67 = f9_z_p66 * inverse_D2;

  // link 8 (link5), force propagation
  const Real neg_s9 = -s9;

  // link 7 (link4), force propagation
  const Real f9_z_p68 = -(s8 * neg_s9);

  // link 8 (link5), force propagation
  const Real f9_z_p69 = c8 * neg_s9;

  // link 7 (link4), force propagation
  const Real f9_z_p70 = f9_z_p69 + inverse_D6_p19 * f9_z_p68;
  const Real f9_z_p71 = -(s8 * c9);

  // link 8 (link5), force propagation
  const Real f9_z_p72 = c8 * c9;

  // link 7 (link4), force propagation
  const Real f9_z_p73 = f9_z_p72 + inverse_D6_p19 * f9_z_p71;
  const Lanes f9_z_p74_lanes = detail::make_lanes<Real>(0.0203, 0.0203, 0.0203, s7, s7, 0.0203,
      0.0203, 0.0203) * detail::make_lanes<Real>(f9_z_p71, f9_z_p68, c8, f9_z_p73, f9_z_p70,
      f9_z_p71, f9_z_p71, f9_z_p71);
  const Real f9_z_p79 = inverse_D6_p2 * f9_z_p68;

  // link 8 (link5), force propagation
  const Real f9_z_p80 = 4.484863585399276 * c9;

  // link 7 (link4), force propagation
  const Real f9_z_p81 = -(c8 * f9_z_p80);
  const Real f9_z_p82 = c7 * f9_z_p81 + s7 * f9_z_p79;

  // link 8 (link5), force propagation
  const Real f9_z_p83 = s8 * f9_z_p80;

  // link 7 (link4), force propagation
  const Real f9_z_p84 = inverse_D6_p2 * f9_z_p71;

  // link 8 (link5), force propagation
  const Real f9_z_p85 = 4.484863585399276 * s9;

  // link 7 (link4), force propagation
  const Real f9_z_p86 = -(c8 * f9_z_p85);
  const Real f9_z_p87 = c7 * f9_z_p86 + s7 * f9_z_p84;

  // link 8 (link5), force propagation
  const Real f9_z_p88 = s8 * f9_z_p85;

  // link 7 (link4), force propagation
  const Real f9_z_p89 = c7 * s8;
  const Real f9_z_p90 = c7 * f9_z_p69 - s7 * c9;
  const Real f9_z_p91 = c7 * f9_z_p72 - s7 * s9;
  const Lanes f9_z_p92_lanes = f9_z_p74_lanes + detail::make_lanes<Real>(0.4331 * f9_z_p91, 0.4331 *
      f9_z_p90, 0.4331 * f9_z_p89, 0.0203 * f9_z_p88 + 0.4331 * f9_z_p87, 0.0203 * f9_z_p83 +
      0.4331 * f9_z_p82, 0.4331 * f9_z_p91, 0.4331 * f9_z_p91, 0.4331 * f9_z_p91);

  // link 6 (link3), force propagation
  const Lanes f9_z_p97_lanes = inverse_D4_p3 * f9_z_p92_lanes;

  // link 7 (link4), force propagation
  const Real f9_z_p102 = s7 * f9_z_p81 - c7 * f9_z_p79;
  const Real f9_z_p103 = s7 * f9_z_p86 - c7 * f9_z_p84;
  const Real f9_z_p104 = s7 * s8;
  const Real f9_z_p105 = s7 * f9_z_p69 + c7 * c9;
  const Real f9_z_p106 = s7 * f9_z_p72 + c7 * s9;

  // link 6 (link3), force propagation
  const Lanes f9_z_p107_lanes = detail::make_lanes<Real>(-(0.4331 * f9_z_p106),
      -(0.4331 * f9_z_p105), -(0.4331 * f9_z_p104), c7 * f9_z_p73 - 0.4331 * f9_z_p103, c7 *
      f9_z_p70 - 0.4331 * f9_z_p102, -(0.4331 * f9_z_p106), -(0.4331 * f9_z_p106),
      -(0.4331 * f9_z_p106)) - f9_z_p97_lanes;
  const Lanes f9_z_p112_lanes = c6 * f9_z_p107_lanes;
  const Lanes f9_z_p117_lanes = inverse_D4_p5 * f9_z_p92_lanes;

  // link 7 (link4), force propagation
  const Lanes f9_z_p122_lanes = 0.0203 * detail::make_lanes<Real>(f9_z_p106, f9_z_p105, f9_z_p104,
      f9_z_p103, f9_z_p102, f9_z_p106, f9_z_p106, f9_z_p106);

  // link 6 (link3), force propagation
  const Lanes f9_z_p127_lanes = f9_z_p122_lanes - f9_z_p117_lanes;
  const Lanes f9_z_p132_lanes = s6 * f9_z_p127_lanes;
  const Lanes f9_z_p137_lanes = f9_z_p112_lanes - f9_z_p132_lanes;
  const Lanes f9_z_p142_lanes = f9_z_p2 * f9_z_p92_lanes;
  const Lanes f9_z_p147_lanes = detail::make_lanes<Real>(f9_z_p91, f9_z_p90, f9_z_p89, f9_z_p87,
      f9_z_p82, f9_z_p91, f9_z_p91, f9_z_p91) - f9_z_p142_lanes;
  const Lanes f9_z_p152_lanes = s6 * f9_z_p147_lanes;
  const Lanes f9_z_p157_lanes = f9_z_p12 * f9_z_p92_lanes;
  const Lanes f9_z_p162_lanes = detail::make_lanes<Real>(-f9_z_p71, -f9_z_p68, -c8, -f9_z_p88,
      -f9_z_p83, -f9_z_p71, -f9_z_p71, -f9_z_p71) + f9_z_p157_lanes;
  const Lanes f9_z_p167_lanes = c6 * f9_z_p162_lanes;
  const Lanes f9_z_p172_lanes = f9_z_p152_lanes + f9_z_p167_lanes;
  const Lanes f9_z_p177_lanes = 0.1501 * f9_z_p172_lanes;
  const Lanes f9_z_p182_lanes = f9_z_p137_lanes - f9_z_p177_lanes;
  const Lanes f9_z_p187_lanes = 0.4318 * f9_z_p172_lanes;
  const Lanes f9_z_p192_lanes = s6 * f9_z_p107_lanes;
  const Lanes f9_z_p197_lanes = c6 * f9_z_p127_lanes;
  const Lanes f9_z_p202_lanes = f9_z_p192_lanes + f9_z_p197_lanes;
  const Lanes f9_z_p207_lanes = c6 * f9_z_p147_lanes;
  const Lanes f9_z_p212_lanes = s6 * f9_z_p162_lanes;
  const Lanes f9_z_p217_lanes = f9_z_p207_lanes - f9_z_p212_lanes;
  const Lanes f9_z_p222_lanes = 0.1501 * f9_z_p217_lanes;
  const Lanes f9_z_p227_lanes = f9_z_p19 * f9_z_p92_lanes;
  const Lanes f9_z_p232_lanes = detail::make_lanes<Real>(f9_z_p106, f9_z_p105, f9_z_p104, f9_z_p103,
      f9_z_p102, f9_z_p106, f9_z_p106, f9_z_p106) - f9_z_p227_lanes;
  const Lanes f9_z_p237_lanes = 0.4318 * f9_z_p232_lanes;
  const Lanes f9_z_p242_lanes = f9_z_p222_lanes - f9_z_p237_lanes;
  const Lanes f9_z_p247_lanes = f9_z_p202_lanes + f9_z_p242_lanes;

  // link 4 (link1), force propagation
  const Real f9_z_p252 = -(s5 * (f9_z_p182_lanes[4] - inverse_D4_p10 * f9_z_p187_lanes[4]) + c5 *
      (f9_z_p247_lanes[4] - inverse_D4_p17 * f9_z_p187_lanes[4]));
  const Real f9_z_p253 = -(s5 * (f9_z_p182_lanes[3] - inverse_D4_p10 * f9_z_p187_lanes[3]) + c5 *
      (f9_z_p247_lanes[3] - inverse_D4_p17 * f9_z_p187_lanes[3]));
  const Real f9_z_p254 = -(s5 * (f9_z_p182_lanes[2] - inverse_D4_p10 * f9_z_p187_lanes[2]) + c5 *
      (f9_z_p247_lanes[2] - inverse_D4_p17 * f9_z_p187_lanes[2]));
  const Real f9_z_p255 = -(s5 * (f9_z_p182_lanes[1] - inverse_D4_p10 * f9_z_p187_lanes[1]) + c5 *
      (f9_z_p247_lanes[1] - inverse_D4_p17 * f9_z_p187_lanes[1]));
  const Real f9_z_p256 = -(s5 * (f9_z_p182_lanes[0] - inverse_D4_p10 * f9_z_p187_lanes[0]) + c5 *
      (f9_z_p247_lanes[0] - inverse_D4_p17 * f9_z_p187_lanes[0]));
  const Lanes f9_z_p257_lanes = f9_z_p51 * detail::make_lanes<Real>(f9_z_p256, f9_z_p255, f9_z_p254,
      f9_z_p253, f9_z_p252, f9_z_p256, f9_z_p256, f9_z_p256);
  const Real f9_z_p262 = -(s5 * (f9_z_p172_lanes[4] - f9_z_p42 * f9_z_p187_lanes[4]) - c5 *
      (f9_z_p217_lanes[4] - f9_z_p39 * f9_z_p187_lanes[4]));
  const Real f9_z_p263 = -(s5 * (f9_z_p172_lanes[3] - f9_z_p42 * f9_z_p187_lanes[3]) - c5 *
      (f9_z_p217_lanes[3] - f9_z_p39 * f9_z_p187_lanes[3]));
  const Real f9_z_p264 = -(s5 * (f9_z_p172_lanes[2] - f9_z_p42 * f9_z_p187_lanes[2]) - c5 *
      (f9_z_p217_lanes[2] - f9_z_p39 * f9_z_p187_lanes[2]));
  const Real f9_z_p265 = -(s5 * (f9_z_p172_lanes[1] - f9_z_p42 * f9_z_p187_lanes[1]) - c5 *
      (f9_z_p217_lanes[1] - f9_z_p39 * f9_z_p187_lanes[1]));
  const Real f9_z_p266 = -(s5 * (f9_z_p172_lanes[0] - f9_z_p42 * f9_z_p187_lanes[0]) - c5 *
      (f9_z_p217_lanes[0] - f9_z_p39 * f9_z_p187_lanes[0]));
  const Lanes f9_z_p267_lanes = detail::make_lanes<Real>(f9_z_p266, f9_z_p265, f9_z_p264, f9_z_p263,
      f9_z_p262, f9_z_p266, f9_z_p266, f9_z_p266) - f9_z_p257_lanes;
  const Lanes f9_z_p272_lanes = c4 * f9_z_p267_lanes;
  const Lanes f9_z_p277_lanes = f9_z_p57 * detail::make_lanes<Real>(f9_z_p256, f9_z_p255, f9_z_p254,
      f9_z_p253, f9_z_p252, f9_z_p256, f9_z_p256, f9_z_p256);

  // link 5 (link2), force propagation
  const Lanes f9_z_p282_lanes = f9_z_p55 * f9_z_p187_lanes;
  const Lanes f9_z_p287_lanes = f9_z_p232_lanes - f9_z_p282_lanes;

  // link 4 (link1), force propagation
  const Lanes f9_z_p292_lanes = f9_z_p287_lanes + f9_z_p277_lanes;
  const Lanes f9_z_p297_lanes = s4 * f9_z_p292_lanes;
  const Lanes f9_z_p302_lanes = f9_z_p272_lanes - f9_z_p297_lanes;

  // link 3 (base), force propagation
  const Lanes f9_z_p307_lanes = s3 * f9_z_p302_lanes;

  // link 4 (link1), force propagation
  const Lanes f9_z_p312_lanes = s4 * f9_z_p267_lanes;
  const Lanes f9_z_p317_lanes = c4 * f9_z_p292_lanes;
  const Lanes f9_z_p322_lanes = f9_z_p312_lanes + f9_z_p317_lanes;

  // link 3 (base), force propagation
  const Lanes f9_z_p327_lanes = c3 * f9_z_p322_lanes;
  const Lanes f9_z_p332_lanes = f9_z_p307_lanes + f9_z_p327_lanes;

  // link 2 (base_y), force propagation
  const Lanes f9_z_p337_lanes = f9_z_p67 * f9_z_p332_lanes;

  // link 3 (base), force propagation
  const Lanes f9_z_p342_lanes = c3 * f9_z_p302_lanes;
  const Lanes f9_z_p347_lanes = s3 * f9_z_p322_lanes;
  const Lanes f9_z_p352_lanes = f9_z_p342_lanes - f9_z_p347_lanes;

  // link 2 (base_y), force propagation
  const Lanes f9_z_p357_lanes = f9_z_p352_lanes - f9_z_p337_lanes;

  // link 1 (base_x), articulated inertia
  const Real inverse_D1 = 1.0 / (186.45 + (f9_z_p62 - inverse_D2_p1) - f9_z_p66 * f9_z_p67);

  // link 1 (base_x), force propagation
  const Lanes f9_z_p362_lanes = f9_z_p357_lanes * inverse_D1;
  const Lanes f9_z_p367_lanes = f9_z_p362_lanes * f9_z_p357_lanes[0];

  // link 2 (base_y), force propagation
  const Lanes f9_z_p372_lanes = f9_z_p332_lanes * inverse_D2;
  const Lanes f9_z_p377_lanes = f9_z_p372_lanes * f9_z_p332_lanes[0];

  // link 4 (link1), force propagation
  const Lanes f9_z_p382_lanes = detail::make_lanes<Real>(f9_z_p256, f9_z_p255, f9_z_p254, f9_z_p253,
      f9_z_p252, f9_z_p256, f9_z_p256, f9_z_p256) * inverse_D4;
  const Lanes f9_z_p387_lanes = f9_z_p382_lanes * f9_z_p256;

  // link 5 (link2), force propagation
  const Lanes f9_z_p392_lanes = f9_z_p187_lanes * inverse_D5;
  const Lanes f9_z_p397_lanes = f9_z_p392_lanes * f9_z_p187_lanes[0];

  // link 6 (link3), force propagation
  const Lanes f9_z_p402_lanes = f9_z_p92_lanes * inverse_D6;
  const Lanes f9_z_p407_lanes = f9_z_p402_lanes * f9_z_p92_lanes[0];

  // link 5 (link2), force propagation
  const Lanes f9_z_p412_lanes = f9_z_p407_lanes + f9_z_p397_lanes;

  // link 4 (link1), force propagation
  const Lanes f9_z_p417_lanes = f9_z_p412_lanes + f9_z_p387_lanes;

  // link 2 (base_y), force propagation
  const Lanes f9_z_p422_lanes = f9_z_p417_lanes + f9_z_p377_lanes;

  // link 1 (base_x), force propagation
  const Lanes f9_z_p427_lanes = f9_z_p422_lanes + f9_z_p367_lanes;
  const Real f9_z_p432 = 1.0 / f9_z_p427_lanes[0];
  const Lanes f9_z_p433_lanes = f9_z_p427_lanes * f9_z_p432;
  const Lanes f9_z_p437_lanes = f9_z_p433_lanes * f9_z_p427_lanes[1];
  const Lanes f9_z_p441_lanes = f9_z_p362_lanes * f9_z_p357_lanes[1];

  // link 2 (base_y), force propagation
  const Lanes f9_z_p445_lanes = f9_z_p372_lanes * f9_z_p332_lanes[1];

  // link 4 (link1), force propagation
  const Lanes f9_z_p449_lanes = f9_z_p382_lanes * f9_z_p255;

  // link 5 (link2), force propagation
  const Lanes f9_z_p453_lanes = f9_z_p392_lanes * f9_z_p187_lanes[1];

  // link 6 (link3), force propagation
  const Lanes f9_z_p457_lanes = f9_z_p402_lanes * f9_z_p92_lanes[1];

  // link 5 (link2), force propagation
  const Lanes f9_z_p461_lanes = f9_z_p457_lanes + f9_z_p453_lanes;

  // link 4 (link1), force propagation
  const Lanes f9_z_p465_lanes = f9_z_p461_lanes + f9_z_p449_lanes;

  // link 2 (base_y), force propagation
  const Lanes f9_z_p469_lanes = f9_z_p465_lanes + f9_z_p445_lanes;

  // link 1 (base_x), force propagation
  const Lanes f9_z_p473_lanes = f9_z_p469_lanes + f9_z_p441_lanes;
  const Lanes f9_z_p477_lanes = f9_z_p473_lanes - f9_z_p437_lanes;
  const Real f9_z_p481 = 1.0 / f9_z_p477_lanes[1];
  const Lanes f9_z_p482_lanes = f9_z_p477_lanes * f9_z_p481;
  const Lanes f9_z_p485_lanes = f9_z_p482_lanes * f9_z_p477_lanes[2];
  const Lanes f9_z_p488_lanes = f9_z_p433_lanes * f9_z_p427_lanes[2];
  const Lanes f9_z_p491_lanes = f9_z_p362_lanes * f9_z_p357_lanes[2];

  // link 2 (base_y), force propagation
  const Lanes f9_z_p494_lanes = f9_z_p372_lanes * f9_z_p332_lanes[2];

  // link 4 (link1), force propagation
  const Lanes f9_z_p497_lanes = f9_z_p382_lanes * f9_z_p254;

  // link 5 (link2), force propagation
  const Lanes f9_z_p500_lanes = f9_z_p392_lanes * f9_z_p187_lanes[2];

  // link 6 (link3), force propagation
  const Lanes f9_z_p503_lanes = f9_z_p402_lanes * f9_z_p92_lanes[2];

  // link 5 (link2), force propagation
  const Lanes f9_z_p506_lanes = f9_z_p503_lanes + f9_z_p500_lanes;

  // link 4 (link1), force propagation
  const Lanes f9_z_p509_lanes = f9_z_p506_lanes + f9_z_p497_lanes;

  // link 2 (base_y), force propagation
  const Lanes f9_z_p512_lanes = f9_z_p509_lanes + f9_z_p494_lanes;

  // link 1 (base_x), force propagation
  const Lanes f9_z_p515_lanes = f9_z_p512_lanes + f9_z_p491_lanes;
  const Lanes f9_z_p518_lanes = f9_z_p515_lanes - f9_z_p488_lanes;
  const Lanes f9_z_p521_lanes = f9_z_p518_lanes - f9_z_p485_lanes;
  const Real f9_z_p524 = 1.0 / f9_z_p521_lanes[2];
  const Real f9_z_p525 = f9_z_p521_lanes[4] * f9_z_p524;

  // link 7 (link4), force propagation
  const Real f9_z_p526 = f9_z_p68 * inverse_D7;

  // link 8 (link5), force propagation
  const Real f9_z_p527 = 1557.24430048586 * c9;

  // link 4 (link1), force propagation
  const Real f9_z_p528 = f9_z_p527 * s9 + f9_z_p526 * f9_z_p71 + f9_z_p402_lanes[4] *
      f9_z_p92_lanes[3] + f9_z_p392_lanes[4] * f9_z_p187_lanes[3] + f9_z_p382_lanes[4] * f9_z_p253;

  // link 1 (base_x), force propagation
  const Real f9_z_p529 = f9_z_p528 + f9_z_p372_lanes[4] * f9_z_p332_lanes[3] + f9_z_p362_lanes[4] *
      f9_z_p357_lanes[3] - f9_z_p433_lanes[4] * f9_z_p427_lanes[3] - f9_z_p482_lanes[4] *
      f9_z_p477_lanes[3];
  const Real f9_z_p530 = f9_z_p529 - f9_z_p525 * f9_z_p521_lanes[3];
  const Real f9_z_p531 = f9_z_p521_lanes[3] * f9_z_p524;

  // link 5 (link2), force propagation
  const Real f9_z_p532 = 1557.24430048586 * s9 * s9 + f9_z_p71 * inverse_D7 * f9_z_p71 +
      f9_z_p402_lanes[3] * f9_z_p92_lanes[3] + f9_z_p392_lanes[3] * f9_z_p187_lanes[3];

  // link 1 (base_x), force propagation
  const Real f9_z_p533 = f9_z_p532 + f9_z_p382_lanes[3] * f9_z_p253 + f9_z_p372_lanes[3] *
      f9_z_p332_lanes[3] + f9_z_p362_lanes[3] * f9_z_p357_lanes[3] - f9_z_p433_lanes[3] *
      f9_z_p427_lanes[3];
  const Real f9_z_p534 = 1.0 / (f9_z_p533 - f9_z_p482_lanes[3] * f9_z_p477_lanes[3] - f9_z_p531 *
      f9_z_p521_lanes[3]);
  const Real f9_z_p535 = f9_z_p530 * f9_z_p534;

  // link 3 (base), outward
  const Real a3_y = c3 * qdd_0[1] - s3 * qdd_0[0];
  const Real a3_x = c3 * qdd_0[0] + s3 * qdd_0[1];

  // link 4 (link1), outward
  const Real a4_y = c4 * a3_y - s4 * a3_x;
  const Real w4_z = qd[2] + qd[3];

  // link 5 (link2), outward
  const Real minus_w5_x = s5 * w4_z;
  const Real a6_z_p1 = minus_w5_x * minus_w5_x;
  const Real minus_w5_y = c5 * w4_z;
  const Real a6_z_p2 = minus_w5_y * minus_w5_y;
  const Real wd5_y_p1 = minus_w5_x * qd[4];

  // link 4 (link1), outward
  const Real wd4_z = qdd_0[2] + qdd_0[3];

  // link 5 (link2), outward
  const Real wd5_y_p2 = c5 * wd4_z;
  const Real wd5_y = wd5_y_p1 - wd5_y_p2;
  const Real a6_z_p3 = wd5_y_p1 + wd5_y;

  // link 6 (link3), outward
  const Real a6_z = a4_y - (0.4318 * a6_z_p3 + 0.1501 * (a6_z_p1 + a6_z_p2));

  // link 5 (link2), outward
  const Real minus_wd5_x_p1 = s5 * wd4_z;
  const Real minus_wd5_x_p2 = minus_w5_y * qd[4];
  const Real minus_wd5_x = minus_wd5_x_p1 + minus_wd5_x_p2;

  // link 6 (link3), outward
  const Real minus_w6_x = c6 * minus_w5_x + s6 * minus_w5_y;
  const Real wd6_y = s6 * minus_wd5_x + c6 * wd5_y + minus_w6_x * qd[5];
  const Real w6_z = qd[4] + qd[5];
  const Real a7_y_p1 = minus_w6_x * w6_z;
  const Real a7_y_p2 = a7_y_p1 + wd6_y;
  const Real w6_y = s6 * minus_w5_x - c6 * minus_w5_y;
  const Real wd6_x = s6 * wd5_y - c6 * minus_wd5_x + w6_y * qd[5];
  const Real a7_y_p3 = w6_y * w6_z + wd6_x;

  // link 7 (link4), outward
  const Real a7_y_p4 = a6_z + (0.0203 * a7_y_p2 - 0.4331 * a7_y_p3);

  // link 4 (link1), outward
  const Real a4_x = c4 * a3_x + s4 * a3_y;

  // link 5 (link2), outward
  const Real a5_x = c5 * a4_x - 9.81 * s5;
  const Real a6_x_p1 = qd[4] * qd[4];

  // link 6 (link3), outward
  const Real a6_x_p2 = a6_z_p2 + a6_x_p1;
  const Real a6_x_p3 = a5_x - (0.4318 * a6_x_p2 + 0.1501 * wd5_y_p2);

  // link 5 (link2), outward
  const Real minus_a5_y = s5 * a4_x + 9.81 * c5;
  const Real a6_x_p4 = minus_w5_x * minus_w5_y;
  const Real a6_x_p5 = a6_x_p4 + qdd_0[4];

  // link 6 (link3), outward
  const Real a6_x_p6 = 0.4318 * a6_x_p5 + 0.1501 * minus_wd5_x_p1 - minus_a5_y;
  const Real a6_x = c6 * a6_x_p3 + s6 * a6_x_p6;
  const Real a7_y_p5 = w6_y * w6_y;
  const Real a7_y_p6 = w6_z * w6_z;

  // link 7 (link4), outward
  const Real a7_y_p7 = a7_y_p5 + a7_y_p6;

  // link 6 (link3), outward
  const Real a7_y_p8 = minus_w6_x * w6_y;
  const Real wd6_z = qdd_0[4] + qdd_0[5];
  const Real a7_y_p9 = a7_y_p8 + wd6_z;

  // link 7 (link4), outward
  const Real a7_y_p10 = a6_x + (0.0203 * a7_y_p7 + 0.4331 * a7_y_p9);
  const Real a7_y = c7 * a7_y_p4 - s7 * a7_y_p10;

  // link 9 (link6), outward
  const Real f9_z_p536 = c3 * xdd_cmd[0] + s3 * xdd_cmd[1];
  const Real f9_z_p537 = c3 * xdd_cmd[1] - s3 * xdd_cmd[0];
  const Real f9_z_p538 = c4 * f9_z_p536 + s4 * f9_z_p537;
  const Real f9_z_p539 = 9.81 + xdd_cmd[2];
  const Real f9_z_p540 = c5 * f9_z_p538 - s5 * f9_z_p539;
  const Real f9_z_p541 = s5 * f9_z_p538 + c5 * f9_z_p539;
  const Real f9_z_p542 = c6 * f9_z_p540 - s6 * f9_z_p541;
  const Real f9_z_p543 = c4 * f9_z_p537 - s4 * f9_z_p536;
  const Real f9_z_p544 = c7 * f9_z_p543 - s7 * f9_z_p542 - a7_y;
  const Real f9_z_p545 = c3 * xdd_cmd[3] + s3 * xdd_cmd[4];
  const Real f9_z_p546 = c3 * xdd_cmd[4] - s3 * xdd_cmd[3];
  const Real f9_z_p547 = c4 * f9_z_p545 + s4 * f9_z_p546;
  const Real f9_z_p548 = c5 * f9_z_p547 - s5 * xdd_cmd[5];
  const Real f9_z_p549 = s5 * f9_z_p547 + c5 * xdd_cmd[5];
  const Real f9_z_p550 = c6 * f9_z_p548 - s6 * f9_z_p549;
  const Real f9_z_p551 = c4 * f9_z_p546 - s4 * f9_z_p545;
  const Real f9_z_p552 = c7 * f9_z_p550 + s7 * f9_z_p551;
  const Real f9_z_p553 = s6 * f9_z_p548 + c6 * f9_z_p549;
  const Real f9_z_p554 = c8 * f9_z_p552 - s8 * f9_z_p553;
  const Real f9_z_p555 = c7 * f9_z_p551 - s7 * f9_z_p550;
  const Real f9_z_p556 = c9 * f9_z_p555 - s9 * f9_z_p554;

  // link 7 (link4), outward
  const Real w7_x = s7 * w6_z - c7 * minus_w6_x;
  const Real w7_z = qd[6] - w6_y;

  // link 8 (link5), outward
  const Real w8_x = c8 * w7_x - s8 * w7_z;

  // link 7 (link4), outward
  const Real w7_y = s7 * minus_w6_x + c7 * w6_z;

  // link 8 (link5), outward
  const Real w8_z = w7_y + qd[7];

  // link 9 (link6), outward
  const Real w9_x = c9 * w8_x + s9 * w8_z;

  // link 8 (link5), outward
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;

  // link 9 (link6), outward
  const Real w9_z = minus_w8_y + qd[8];
  const Real f9_z_p557 = w9_x * w9_z;

  // link 7 (link4), outward
  const Real a7_x = c7 * a7_y_p10 + s7 * a7_y_p4;

  // link 6 (link3), outward
  const Real a6_y = c6 * a6_x_p6 - s6 * a6_x_p3;
  const Real minus_a7_z_p1 = minus_w6_x * minus_w6_x;

  // link 7 (link4), outward
  const Real minus_a7_z_p2 = minus_a7_z_p1 + a7_y_p6;

  // link 6 (link3), outward
  const Real minus_a7_z_p3 = wd6_z - a7_y_p8;

  // link 7 (link4), outward
  const Real minus_a7_z = a6_y + (0.4331 * minus_a7_z_p2 - 0.0203 * minus_a7_z_p3);

  // link 8 (link5), outward
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;

  // link 9 (link6), outward
  const Real f9_z_p558 = c7 * f9_z_p542 + s7 * f9_z_p543;
  const Real f9_z_p559 = s6 * f9_z_p540 + c6 * f9_z_p541;
  const Real f9_z_p560 = c8 * f9_z_p558 - s8 * f9_z_p559 - a8_x;
  const Real f9_z_p561 = f9_z_p544 * s9 - 0.05625 * (f9_z_p557 + f9_z_p556) + f9_z_p560 * c9;
  const Real f9_z_p562 = c9 * f9_z_p554 + s9 * f9_z_p555;
  const Real w9_y = c9 * w8_z - s9 * w8_x;
  const Real f9_z_p563 = w9_y * w9_z;

  // link 1 (base_x), force propagation
  const Real f9_z_p564 = 0.05625 * (f9_z_p562 - f9_z_p563) - f9_z_p433_lanes[1] * f9_z_p561 -
      f9_z_p560 * s9 + f9_z_p544 * c9;
  const Real f9_z_p565 = 0.05625 * (w9_x * w9_x + w9_y * w9_y) - f9_z_p433_lanes[2] * f9_z_p561 -
      f9_z_p482_lanes[2] * f9_z_p564;
  const Real f9_z_p566 = f9_z_p565 + (f9_z_p559 + minus_a7_z) * c8 + (f9_z_p558 - a7_x) * s8;

  // link 7 (link4), outward
  const Real wd7_x = c7 * wd6_x + s7 * wd6_z + w7_y * qd[6];
  const Real wd7_z = qdd_0[6] - wd6_y;

  // link 8 (link5), outward
  const Real wd8_x = c8 * wd7_x - s8 * wd7_z - minus_w8_y * qd[7];

  // link 7 (link4), outward
  const Real wd7_y = c7 * wd6_z - s7 * wd6_x - w7_x * qd[6];

  // link 8 (link5), outward
  const Real wd8_z = wd7_y + qdd_0[7];

  // link 9 (link6), outward
  const Real wd9_x = c9 * wd8_x + s9 * wd8_z + w9_y * qd[8];

  // link 1 (base_x), force propagation
  const Real f9_z_p567 = f9_z_p562 - wd9_x - f9_z_p433_lanes[3] * f9_z_p561 - f9_z_p482_lanes[3] *
      f9_z_p564 - f9_z_p531 * f9_z_p566;

  // link 9 (link6), outward
  const Real wd9_y = c9 * wd8_z - s9 * wd8_x - w9_x * qd[8];

  // link 1 (base_x), force propagation
  const Real f9_z_p568 = f9_z_p556 - wd9_y - f9_z_p433_lanes[4] * f9_z_p561 - f9_z_p482_lanes[4] *
      f9_z_p564 - f9_z_p525 * f9_z_p566 - f9_z_p535 * f9_z_p567;

  // link 4 (link1), force propagation
  const Real f9_z_p569 = f9_z_p527 * c9 + f9_z_p526 * f9_z_p68 + f9_z_p402_lanes[4] *
      f9_z_p92_lanes[4] + f9_z_p392_lanes[4] * f9_z_p187_lanes[4] + f9_z_p382_lanes[4] * f9_z_p252;

  // link 1 (base_x), force propagation
  const Real f9_z_p570 = f9_z_p569 + f9_z_p372_lanes[4] * f9_z_p332_lanes[4] + f9_z_p362_lanes[4] *
      f9_z_p357_lanes[4] - f9_z_p433_lanes[4] * f9_z_p427_lanes[4] - f9_z_p482_lanes[4] *
      f9_z_p477_lanes[4];
  const Real f9_z_p571 = f9_z_p568 * (1.0 / (f9_z_p570 - f9_z_p525 * f9_z_p521_lanes[4] -
      f9_z_p535 * f9_z_p530));
  const Real f9_z_p572 = f9_z_p567 * f9_z_p534 - f9_z_p535 * f9_z_p571;
  const Real f9_z = f9_z_p566 * f9_z_p524 - f9_z_p531 * f9_z_p572 - f9_z_p525 * f9_z_p571;
  const Real f9_y = f9_z_p564 * f9_z_p481 - f9_z_p482_lanes[2] * f9_z - f9_z_p482_lanes[3] *
      f9_z_p572 - f9_z_p482_lanes[4] * f9_z_p571;
  const Real f9_x = f9_z_p561 * f9_z_p432 - f9_z_p433_lanes[1] * f9_y - f9_z_p433_lanes[2] * f9_z -
      f9_z_p433_lanes[3] * f9_z_p572 - f9_z_p433_lanes[4] * f9_z_p571;

  // link 8 (link5), outward
  const Real f8_x_p1 = w8_x * minus_w8_y;

  // link 9 (link6), inward
  const Real f8_x = 0.0028799999999999997 * (f8_x_p1 + wd8_z) + (c9 * f9_x - s9 * f9_y);
  const Real f8_y = 0.0028799999999999997 * (w8_x * w8_x + w8_z * w8_z) - f9_z;

  // link 8 (link5), inward
  const Real minus_f7_x = s8 * f8_y - c8 * f8_x;

  // link 8 (link5), outward
  const Real f8_z_p1 = wd8_x - minus_w8_y * w8_z;

  // link 9 (link6), inward
  const Real f8_z = s9 * f9_x + c9 * f9_y - 0.0028799999999999997 * f8_z_p1;

  // link 7 (link4), inward
  const Real f6_x_p1 = c7 * minus_f7_x + s7 * f8_z;
  const Real f6_x = 0.025374999999999998 * a7_y_p7 + 0.861795 * a7_y_p9 - f6_x_p1;

  // link 8 (link5), inward
  const Real minus_f7_z = s8 * f8_x + c8 * f8_y;

  // link 7 (link4), inward
  const Real f6_y = 0.861795 * minus_a7_z_p2 - 0.025374999999999998 * minus_a7_z_p3 + minus_f7_z;

  // link 6 (link3), inward
  const Real f5_y_p1 = s6 * f6_x + c6 * f6_y;
  const Real f5_y = 3.79559 * a6_x_p5 - 0.10439999999999999 * (a6_z_p1 + a6_x_p1) + f5_y_p1;
  const Real f5_x_p1 = c6 * f6_x - s6 * f6_y;

  // link 5 (link2), outward
  const Real f5_x_p2 = a6_x_p4 - qdd_0[4];

  // link 6 (link3), inward
  const Real f5_x = 0.10439999999999999 * f5_x_p2 - 3.79559 * a6_x_p2 + f5_x_p1;

  // link 5 (link2), inward
  const Real minus_f4_x = 4.9338049999999996 * wd4_z + (s5 * f5_y - c5 * f5_x);

  // link 7 (link4), inward
  const Real f6_z_p1 = c7 * f8_z - s7 * minus_f7_x;
  const Real f6_z = 0.025374999999999998 * a7_y_p2 - 0.861795 * a7_y_p3 + f6_z_p1;

  // link 5 (link2), outward
  const Real f5_z_p1 = minus_wd5_x_p2 + minus_wd5_x;

  // link 6 (link3), inward
  const Real f5_z = f6_z - (3.79559 * a6_z_p3 + 0.10439999999999999 * f5_z_p1);

  // link 5 (link2), inward
  const Real f4_y = f5_z - 4.9338049999999996 * (w4_z * w4_z);

  // link 4 (link1), inward
  const Real minus_f3_x = c4 * minus_f4_x + s4 * f4_y;
  const Real f3_y = c4 * f4_y - s4 * minus_f4_x;

  // link 3 (base), inward
  const Real f2_x = 186.45 * qdd_0[0] - (c3 * minus_f3_x + s3 * f3_y);
  tau[0] = f2_x;
  const Real f2_z = 186.45 * qdd_0[1] + (c3 * f3_y - s3 * minus_f3_x);
  tau[1] = f2_z;

  // link 9 (link6), inertial wrench
  const Real n9_x = 2e-05 * (f9_z_p563 + wd9_x) + f9_z_p572;
  const Real n9_y = f9_z_p571 - 2e-05 * (f9_z_p557 - wd9_y);

  // link 9 (link6), inward
  const Real n8_x = 0.00042216 * f8_z_p1 - 0.0028799999999999997 * a7_y + (c9 * n9_x - s9 * n9_y);

  // link 9 (link6), inertial wrench
  const Real n9_z = 4e-05 * (s8 * f9_z_p552 + c8 * f9_z_p553);
  tau[8] = n9_z;

  // link 8 (link5), outward
  const Real minus_wd8_y = s8 * wd7_x + c8 * wd7_z + w8_x * qd[7];

  // link 9 (link6), inward
  const Real minus_n8_y = 2e-04 * (w8_x * w8_z + minus_wd8_y) + n9_z;

  // link 8 (link5), inward
  const Real n7_x = 0.0007499999999999999 * (w7_y * w7_z + wd7_x) + (c8 * n8_x + s8 * minus_n8_y);

  // link 9 (link6), inward
  const Real n8_z = 0.00022215999999999997 * f8_x_p1 + 0.00062216 * wd8_z + 0.0028799999999999997 *
      a8_x + (s9 * n9_x + c9 * n9_y);
  tau[7] = n8_z;

  // link 8 (link5), inward
  const Real n7_y = n8_z - 0.00065 * (w7_x * w7_z - wd7_y);

  // link 6 (link3), inertial wrench
  const Real n6_x_p1 = 0.3056901365 * a7_y_p3 - 0.010673638499999999 * a7_y_p2 -
      0.004704000000000001 * (a7_y_p6 - a7_y_p5) - 0.861795 * a6_z;

  // link 7 (link4), inward
  const Real n6_x = n6_x_p1 + (c7 * n7_x - s7 * n7_y - 0.4331 * f6_z_p1);

  // link 8 (link5), inward
  const Real n7_z = 0.0013999999999999998 * wd7_z - 9.999999999999994e-05 * (w7_x * w7_y) +
      (c8 * minus_n8_y - s8 * n8_x);
  tau[6] = n7_z;

  // link 7 (link4), inward
  const Real n6_y = 0.0067651125 * a7_y_p2 + 0.004704000000000001 * a7_y_p9 - 0.010673638499999999 *
      a7_y_p3 + 0.025374999999999998 * a6_z + (0.0203 * f6_z_p1 - n7_z);

  // link 5 (link2), inertial wrench
  const Real n5_y_p1 = 1.674987602 * a6_z_p3 + 0.023750999999999998 * f5_x_p2 + 0.0070992 *
      f5_z_p1 + 0.690314699 * (a6_z_p1 - a6_x_p1);

  // link 6 (link3), inward
  const Real n5_y = n5_y_p1 - 3.79559 * a4_y + (s6 * n6_x + c6 * n6_y +
      (0.1501 * f5_x_p1 - 0.4318 * f6_z));

  // link 5 (link2), inertial wrench
  const Real n5_x_p1 = 0.023750999999999998 * (a6_x_p1 - a6_z_p2) -
      (0.07312640000000001 * f5_z_p1 + 0.0070992 * a6_z_p3 + 0.690314699 * a6_x_p5);

  // link 6 (link3), inward
  const Real n5_x = n5_x_p1 + 0.10439999999999999 * a4_y +
      (c6 * n6_x - s6 * n6_y - 0.1501 * f5_y_p1);

  // link 5 (link2), inward
  const Real n4_z = 1.4717295504999999 * wd4_z - 4.9338049999999996 * a4_x -
      (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

  // link 4 (link1), inward
  const Real n3_z = 7.2 * qdd_0[2] + n4_z;
  tau[2] = n3_z;

  // link 6 (link3), inertial wrench
  const Real n6_z_p1 = 0.298925024 * a7_y_p8 + 0.312455249 * wd6_z + 0.004704000000000001 *
      (wd6_y - a7_y_p1) + 0.010673638499999999 * (a7_y_p5 - minus_a7_z_p1);

  // link 7 (link4), inward
  const Real n6_z = n6_z_p1 + (0.861795 * a6_x - 0.025374999999999998 * a6_y) +
      (s7 * n7_x + c7 * n7_y - (0.0203 * minus_f7_z + 0.4331 * f6_x_p1));
  tau[5] = n6_z;

  // link 5 (link2), inertial wrench
  const Real n5_z_p1 = 1.601861202 * a6_x_p4 + 1.7481140020000001 * qdd_0[4] + 0.690314699 *
      minus_wd5_x_p1 + 0.023750999999999998 * wd5_y_p2 + 0.0070992 * (a6_z_p2 - a6_z_p1);

  // link 6 (link3), inward
  const Real n5_z = n5_z_p1 - (3.79559 * minus_a5_y + 0.10439999999999999 * a5_x) +
      (n6_z + 0.4318 * f5_y_p1);
  tau[4] = n5_z;
}

}  // namespace samm

#undef TREELINE_RESTRICT
