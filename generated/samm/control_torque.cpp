// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at link origins.
// 1478 flops (add 627, mul 840, div 11), sine and cosine of 7 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void control_torque(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    const Real (&TREELINE_RESTRICT qdd_0)[9], const Real (&TREELINE_RESTRICT xdd_cmd)[6],
    Real (&TREELINE_RESTRICT tau)[9]) noexcept {
  const Real angles[7] = {q[2], q[3], q[4], q[5], q[6], q[7], q[8]};
  Real sines[7];
  Real cosines[7];
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
  const Real s9 = sines[6];
  const Real c9 = cosines[6];

  // link 8 (link5), articulated inertia
  const Real minus_inverse_D6_p1 = 0.0028799999999999997 * s8;
  const Real inverse_D7_p1 = 0.00024215999999999997 * s8;
  const Real inverse_D7_p2 = s8 * inverse_D7_p1;

  // link 7 (link4), articulated inertia
  const Real inverse_D7 = 1.0 / (0.0016 + inverse_D7_p2);
  const Real minus_inverse_D6_p2 = minus_inverse_D6_p1 * inverse_D7;

  // link 8 (link5), articulated inertia
  const Real minus_inverse_D6_p3 = c8 * inverse_D7_p1;

  // link 7 (link4), articulated inertia
  const Real minus_inverse_D6_p4 = 0.0028799999999999997 * c8 - minus_inverse_D6_p3 *
      minus_inverse_D6_p2;
  const Real minus_inverse_D6_p5 = c7 * minus_inverse_D6_p4;
  const Real minus_inverse_D6_p6 = c7 * minus_inverse_D6_p5;
  const Real minus_inverse_D6_p7 = minus_inverse_D6_p4 - minus_inverse_D6_p6;

  // link 8 (link5), articulated inertia
  const Real minus_inverse_D6_p8 = 0.012916407125949915 * s8;
  const Real minus_inverse_D6_p9 = c8 * minus_inverse_D6_p8;

  // link 7 (link4), articulated inertia
  const Real minus_inverse_D6_p10 = c7 * minus_inverse_D6_p9;
  const Real minus_inverse_D6_p11 = minus_inverse_D6_p1 * minus_inverse_D6_p2;

  // link 8 (link5), articulated inertia
  const Real minus_inverse_D6_p12 = s8 * minus_inverse_D6_p8;
  const Real minus_inverse_D6_p13 = 0.012916407125949915 - minus_inverse_D6_p12;

  // link 7 (link4), articulated inertia
  const Real minus_inverse_D6_p14 = s7 * (minus_inverse_D6_p13 - minus_inverse_D6_p11);
  const Real minus_inverse_D6_p15 = s7 * minus_inverse_D6_p14;
  const Real minus_inverse_D6_p16 = minus_inverse_D6_p13 - minus_inverse_D6_p15;
  const Real minus_inverse_D6_p17 = minus_inverse_D6_p7 + 0.0203 * minus_inverse_D6_p10 - 0.4331 *
      minus_inverse_D6_p16;
  const Real minus_inverse_D6_p18 = minus_inverse_D6_p3 * inverse_D7;
  const Real minus_inverse_D6_p19 = inverse_D7_p2 - 0.0011921599999999998 + minus_inverse_D6_p3 *
      minus_inverse_D6_p18;
  const Real minus_inverse_D6_p20 = s7 * (0.00065 + minus_inverse_D6_p19);
  const Real minus_inverse_D6_p21 = s7 * minus_inverse_D6_p20;
  const Real minus_inverse_D6_p22 = 0.0203 * minus_inverse_D6_p12 - 0.4331 * minus_inverse_D6_p10;

  // link 6 (link3), articulated inertia
  const Real minus_inverse_D6 = 1.0 / (minus_inverse_D6_p21 - 0.313105249 - 0.4331 *
      (minus_inverse_D6_p7 + minus_inverse_D6_p17) + 0.0203 * minus_inverse_D6_p22);

  // link 7 (link4), articulated inertia
  const Real inverse_D1_p1 = 0.861795 + minus_inverse_D6_p17;

  // link 6 (link3), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * minus_inverse_D6;

  // link 7 (link4), articulated inertia
  const Real inverse_D1_p3 = s7 * minus_inverse_D6_p5;
  const Real inverse_D1_p4 = c7 * minus_inverse_D6_p14;
  const Real inverse_D1_p5 = inverse_D1_p3 + 0.4331 * inverse_D1_p4;
  const Real inverse_D1_p6 = s7 * minus_inverse_D6_p9;
  const Real inverse_D1_p7 = 0.0203 * inverse_D1_p6;
  const Real inverse_D1_p8 = inverse_D1_p7 - inverse_D1_p5;
  const Real inverse_D1_p9 = 0.004704000000000001 + 0.0203 * inverse_D1_p8;

  // link 6 (link3), articulated inertia
  const Real inverse_D1_p10 = 0.0203 * inverse_D1_p4 - inverse_D1_p9 * inverse_D1_p2;

  // link 7 (link4), articulated inertia
  const Real inverse_D1_p11 = 0.025374999999999998 - minus_inverse_D6_p22;

  // link 6 (link3), articulated inertia
  const Real inverse_D1_p12 = inverse_D1_p11 * minus_inverse_D6;

  // link 7 (link4), articulated inertia
  const Real inverse_D1_p13 = c7 * minus_inverse_D6_p20 - 0.4331 * (inverse_D1_p3 - inverse_D1_p8);

  // link 6 (link3), articulated inertia
  const Real inverse_D1_p14 = 0.4331 * inverse_D1_p6 + inverse_D1_p13 * inverse_D1_p12;
  const Real inverse_D1_p15 = inverse_D1_p5 - inverse_D1_p13 * inverse_D1_p2;
  const Real inverse_D1_p16 = inverse_D1_p7 + inverse_D1_p9 * inverse_D1_p12;
  const Real inverse_D1_p17 = c6 * (inverse_D1_p10 - inverse_D1_p14) - s6 *
      (inverse_D1_p15 + inverse_D1_p16);
  const Real inverse_D1_p18 = c6 * inverse_D1_p17;
  const Real inverse_D1_p19 = inverse_D1_p10 - inverse_D1_p18;
  const Real inverse_D1_p20 = minus_inverse_D6_p16 - inverse_D1_p1 * inverse_D1_p2;
  const Real inverse_D1_p21 = minus_inverse_D6_p12 - inverse_D1_p11 * inverse_D1_p12;
  const Real inverse_D1_p22 = minus_inverse_D6_p10 + inverse_D1_p1 * inverse_D1_p12;
  const Real inverse_D1_p23 = 2.0 * c6;
  const Real inverse_D1_p24 = inverse_D1_p22 * inverse_D1_p23 + s6 *
      (inverse_D1_p20 - inverse_D1_p21);
  const Real inverse_D1_p25 = s6 * inverse_D1_p24;
  const Real inverse_D1_p26 = inverse_D1_p21 + inverse_D1_p25;
  const Real inverse_D1_p27 = 0.690314699 - 0.06481318000000001 * inverse_D1_p26 - 0.4318 *
      inverse_D1_p19;
  const Real inverse_D1_p28 = 3.79559 - 0.4318 * inverse_D1_p26;

  // link 5 (link2), articulated inertia
  const Real inverse_D5 = 1.0 / (1.7481140020000001 - 0.18645124000000002 * inverse_D1_p26);
  const Real inverse_D1_p29 = inverse_D1_p28 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real inverse_D1_p30 = inverse_D1_p19 + 0.1501 * inverse_D1_p26;

  // link 5 (link2), articulated inertia
  const Real inverse_D1_p31 = inverse_D1_p30 + inverse_D1_p27 * inverse_D1_p29;

  // link 6 (link3), articulated inertia
  const Real inverse_D1_p32 = s6 * inverse_D1_p17;
  const Real inverse_D1_p33 = inverse_D1_p16 + inverse_D1_p32;
  const Real inverse_D1_p34 = inverse_D1_p8 * minus_inverse_D6;
  const Real inverse_D1_p35 = inverse_D1_p6 + inverse_D1_p11 * inverse_D1_p34;
  const Real inverse_D1_p36 = inverse_D1_p4 - inverse_D1_p1 * inverse_D1_p34;
  const Real inverse_D1_p37 = c6 * inverse_D1_p35 + s6 * inverse_D1_p36;
  const Real inverse_D1_p38 = 0.4318 * inverse_D1_p37;
  const Real inverse_D1_p39 = inverse_D1_p22 - c6 * inverse_D1_p24;
  const Real inverse_D1_p40 = 0.023750999999999998 - 0.06481318000000001 * inverse_D1_p39 + 0.4318 *
      (inverse_D1_p33 - inverse_D1_p38);
  const Real inverse_D1_p41 = 0.10439999999999999 - 0.4318 * inverse_D1_p39;

  // link 5 (link2), articulated inertia
  const Real inverse_D1_p42 = inverse_D1_p41 * inverse_D5;

  // link 6 (link3), articulated inertia
  const Real inverse_D1_p43 = inverse_D1_p14 + inverse_D1_p18;
  const Real inverse_D1_p44 = inverse_D1_p20 - inverse_D1_p25;
  const Real inverse_D1_p45 = s6 * inverse_D1_p35 - c6 * inverse_D1_p36;
  const Real inverse_D1_p46 = inverse_D1_p43 + 0.1501 * inverse_D1_p44 + 0.4318 * inverse_D1_p45;
  const Real inverse_D1_p47 = inverse_D1_p15 + inverse_D1_p32;
  const Real inverse_D1_p48 = 0.1501 * inverse_D1_p39;
  const Real inverse_D1_p49 = inverse_D1_p38 - (inverse_D1_p33 - inverse_D1_p48);

  // link 5 (link2), articulated inertia
  const Real inverse_D1_p50 = c5 * (inverse_D1_p31 -
      (inverse_D1_p46 + inverse_D1_p40 * inverse_D1_p42)) - s5 *
      (inverse_D1_p49 - (inverse_D1_p47 - inverse_D1_p48 - inverse_D1_p27 * inverse_D1_p42) +
      inverse_D1_p40 * inverse_D1_p29);
  const Real inverse_D1_p51 = 4.9338049999999996 - inverse_D1_p31 + c5 * inverse_D1_p50;

  // link 7 (link4), articulated inertia
  const Real inverse_D4_p1 = minus_inverse_D6_p11 + minus_inverse_D6_p15;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p2 = 0.025374999999999998 - 0.0203 * inverse_D4_p1 + inverse_D1_p9 *
      inverse_D1_p34;

  // link 7 (link4), articulated inertia
  const Real inverse_D4_p3 = minus_inverse_D6_p6 - 0.4331 * inverse_D4_p1;

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p4 = 0.861795 + inverse_D4_p3 + inverse_D1_p13 * inverse_D1_p34;
  const Real inverse_D4_p5 = c6 * inverse_D4_p2 - s6 * inverse_D4_p4;
  const Real inverse_D4_p6 = inverse_D4_p1 - inverse_D1_p8 * inverse_D1_p34;
  const Real inverse_D4_p7 = inverse_D4_p5 + 0.1501 * inverse_D1_p45 + 0.4318 * inverse_D4_p6;
  const Real inverse_D4_p8 = inverse_D1_p13 * minus_inverse_D6;
  const Real inverse_D4_p9 = minus_inverse_D6_p21 + (0.3056901365 - minus_inverse_D6_p19) + 0.4331 *
      (minus_inverse_D6_p6 + inverse_D4_p3) + inverse_D1_p13 * inverse_D4_p8;
  const Real inverse_D4_p10 = inverse_D1_p9 * minus_inverse_D6;
  const Real inverse_D4_p11 = 0.0067651125 - 0.00041208999999999994 * inverse_D4_p1 +
      inverse_D1_p9 * inverse_D4_p10;
  const Real inverse_D4_p12 = 0.010673638499999999 - 0.00879193 * inverse_D4_p1 + 0.0203 *
      minus_inverse_D6_p6 + inverse_D1_p13 * inverse_D4_p10;
  const Real inverse_D4_p13 = inverse_D4_p12 * inverse_D1_p23 - s6 *
      (inverse_D4_p9 - inverse_D4_p11);
  const Real inverse_D4_p14 = s6 * inverse_D4_p13;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p15 = inverse_D4_p14 - (1.674987602 + inverse_D4_p11) + 0.4318 *
      (inverse_D4_p5 + inverse_D4_p7) + 0.1501 * (inverse_D1_p43 + inverse_D1_p46);
  const Real inverse_D4_p16 = inverse_D1_p40 * inverse_D5;
  const Real inverse_D4_p17 = inverse_D4_p15 + inverse_D1_p40 * inverse_D4_p16;
  const Real inverse_D4_p18 = inverse_D1_p27 * inverse_D5;
  const Real inverse_D4_p19 = inverse_D4_p17 + (inverse_D4_p14 +
      (0.07312640000000001 + inverse_D4_p9) - 0.1501 * (inverse_D1_p19 + inverse_D1_p30) -
      inverse_D1_p27 * inverse_D4_p18);

  // link 6 (link3), articulated inertia
  const Real inverse_D4_p20 = s6 * inverse_D4_p2 + c6 * inverse_D4_p4;

  // link 5 (link2), articulated inertia
  const Real inverse_D4_p21 = 0.0070992 - inverse_D4_p12 + c6 * inverse_D4_p13 - 0.4318 *
      inverse_D4_p20 - 0.1501 * (inverse_D1_p47 - inverse_D1_p49);
  const Real inverse_D4_p22 = 2.0 * c5;
  const Real inverse_D4_p23 = 1.4717295504999999 - inverse_D4_p17 - s5 *
      ((inverse_D4_p21 + inverse_D1_p27 * inverse_D4_p16) * inverse_D4_p22 - s5 * inverse_D4_p19);

  // link 4 (link1), articulated inertia
  const Real inverse_D4 = 1.0 / inverse_D4_p23;

  // link 5 (link2), articulated inertia
  const Real inverse_D1_p52 = inverse_D1_p38 * inverse_D5;
  const Real inverse_D1_p53 = c5 * (3.79559 - inverse_D4_p7 + inverse_D1_p40 * inverse_D1_p52) -
      s5 * (0.10439999999999999 - inverse_D4_p20 + 0.1501 * inverse_D1_p37 - inverse_D1_p27 *
      inverse_D1_p52);

  // link 4 (link1), articulated inertia
  const Real inverse_D1_p54 = inverse_D1_p53 * inverse_D4;
  const Real inverse_D1_p55 = s5 * (inverse_D1_p37 - inverse_D1_p28 * inverse_D1_p52) + c5 *
      (inverse_D1_p45 - inverse_D1_p41 * inverse_D1_p52) + inverse_D1_p51 * inverse_D1_p54;
  const Real inverse_D1_p56 = inverse_D1_p51 * inverse_D4;

  // link 5 (link2), articulated inertia
  const Real inverse_D1_p57 = inverse_D1_p44 + inverse_D1_p41 * inverse_D1_p42;
  const Real inverse_D1_p58 = (inverse_D1_p39 + inverse_D1_p41 * inverse_D1_p29) * inverse_D4_p22 +
      s5 * (inverse_D1_p26 - inverse_D1_p57 + inverse_D1_p28 * inverse_D1_p29);

  // link 4 (link1), articulated inertia
  const Real inverse_D1_p59 = inverse_D1_p57 + s5 * inverse_D1_p58 + inverse_D1_p51 *
      inverse_D1_p56;
  const Real inverse_D1_p60 = inverse_D4_p6 + inverse_D1_p38 * inverse_D1_p52 + inverse_D1_p53 *
      inverse_D1_p54;
  const Real inverse_D1_p61 = inverse_D1_p55 * (2.0 * c4) - s4 * (inverse_D1_p59 - inverse_D1_p60);
  const Real inverse_D1_p62 = s4 * inverse_D1_p61;
  const Real inverse_D1_p63 = inverse_D1_p59 + inverse_D1_p62;
  const Real inverse_D1_p64 = inverse_D1_p60 - inverse_D1_p62;
  const Real inverse_D1_p65 = inverse_D1_p55 - c4 * inverse_D1_p61;

  // link 3 (base), articulated inertia
  const Real inverse_D1_p66 = inverse_D1_p65 * (2.0 * c3) + s3 * (inverse_D1_p63 - inverse_D1_p64);
  const Real inverse_D1_p67 = inverse_D1_p65 - c3 * inverse_D1_p66;
  const Real minus_inverse_D2_p1 = s3 * inverse_D1_p66;

  // link 2 (base_y), articulated inertia
  const Real minus_inverse_D2 = 1.0 / (minus_inverse_D2_p1 - (186.45 - inverse_D1_p64));
  const Real inverse_D1_p68 = inverse_D1_p67 * minus_inverse_D2;

  // link 1 (base_x), articulated inertia
  const Real inverse_D1 = 1.0 / (minus_inverse_D2_p1 + (186.45 - inverse_D1_p63) + inverse_D1_p67 *
      inverse_D1_p68);

  // link 8 (link5), force propagation
  const Real f9_z_p1 = s8 * s9;

  // link 7 (link4), force propagation
  const Real f9_z_p2 = minus_inverse_D6_p2 * f9_z_p1;

  // link 8 (link5), force propagation
  const Real f9_z_p3 = 4.484863585399276 * c9;
  const Real f9_z_p4 = c8 * f9_z_p3;

  // link 7 (link4), force propagation
  const Real f9_z_p5 = s7 * f9_z_p2 - c7 * f9_z_p4;

  // link 8 (link5), force propagation
  const Real f9_z_p6 = s8 * f9_z_p3;
  const Real f9_z_p7 = c8 * s9;

  // link 7 (link4), force propagation
  const Real f9_z_p8 = f9_z_p7 - minus_inverse_D6_p18 * f9_z_p1;
  const Real f9_z_p9 = 0.4331 * f9_z_p5 + 0.0203 * f9_z_p6 - s7 * f9_z_p8;

  // link 6 (link3), force propagation
  const Real f9_z_p10 = f9_z_p6 + inverse_D1_p12 * f9_z_p9;
  const Real f9_z_p11 = f9_z_p5 + inverse_D1_p2 * f9_z_p9;
  const Real f9_z_p12 = c6 * f9_z_p10 - s6 * f9_z_p11;
  const Real f9_z_p13 = 0.4318 * f9_z_p12;
  const Real f9_z_p14 = s6 * f9_z_p10 + c6 * f9_z_p11;

  // link 7 (link4), force propagation
  const Real f9_z_p15 = c7 * f9_z_p2 + s7 * f9_z_p4;

  // link 6 (link3), force propagation
  const Real f9_z_p16 = f9_z_p15 - inverse_D1_p34 * f9_z_p9;
  const Real f9_z_p17 = 0.0203 * f9_z_p15 - inverse_D4_p10 * f9_z_p9;
  const Real f9_z_p18 = 0.4331 * f9_z_p15 - c7 * f9_z_p8 - inverse_D4_p8 * f9_z_p9;

  // link 5 (link2), force propagation
  const Real f9_z_p19 = 0.4318 * f9_z_p16 + 0.1501 * f9_z_p14 - c6 * f9_z_p17 + s6 * f9_z_p18 -
      inverse_D4_p16 * f9_z_p13;
  const Real f9_z_p20 = s5 * (0.1501 * f9_z_p12 + s6 * f9_z_p17 + c6 * f9_z_p18 - inverse_D4_p18 *
      f9_z_p13);
  const Real f9_z_p21 = c5 * f9_z_p19 + f9_z_p20;

  // link 4 (link1), force propagation
  const Real f9_z_p22 = s5 * (f9_z_p12 - inverse_D1_p29 * f9_z_p13) + c5 *
      (f9_z_p14 - inverse_D1_p42 * f9_z_p13) - inverse_D1_p56 * f9_z_p21;
  const Real f9_z_p23 = f9_z_p16 + inverse_D1_p52 * f9_z_p13 - inverse_D1_p54 * f9_z_p21;
  const Real f9_z_p24 = c4 * f9_z_p23 - s4 * f9_z_p22;
  const Real f9_z_p25 = s4 * f9_z_p23 + c4 * f9_z_p22;

  // link 3 (base), force propagation
  const Real f9_z_p26 = c3 * f9_z_p24 - s3 * f9_z_p25;

  // link 2 (base_y), force propagation
  const Real f9_z_p27 = s3 * f9_z_p24 + c3 * f9_z_p25 - inverse_D1_p68 * f9_z_p26;

  // link 1 (base_x), force propagation
  const Real f9_z_p28 = inverse_D1 * f9_z_p27;

  // link 8 (link5), force propagation
  const Real f9_z_p29 = c8 * c9;

  // link 7 (link4), force propagation
  const Real f9_z_p30 = s7 * s9 - c7 * f9_z_p29;

  // link 8 (link5), force propagation
  const Real f9_z_p31 = s8 * c9;

  // link 7 (link4), force propagation
  const Real f9_z_p32 = 0.4331 * f9_z_p30 + 0.0203 * f9_z_p31;

  // link 6 (link3), force propagation
  const Real f9_z_p33 = f9_z_p31 + inverse_D1_p12 * f9_z_p32;
  const Real f9_z_p34 = f9_z_p30 + inverse_D1_p2 * f9_z_p32;
  const Real f9_z_p35 = c6 * f9_z_p33 - s6 * f9_z_p34;
  const Real f9_z_p36 = 0.4318 * f9_z_p35;
  const Real f9_z_p37 = s6 * f9_z_p33 + c6 * f9_z_p34;

  // link 7 (link4), force propagation
  const Real f9_z_p38 = c7 * s9 + s7 * f9_z_p29;

  // link 6 (link3), force propagation
  const Real f9_z_p39 = f9_z_p38 - inverse_D1_p34 * f9_z_p32;
  const Real f9_z_p40 = 0.0203 * f9_z_p38 - inverse_D4_p10 * f9_z_p32;
  const Real f9_z_p41 = 0.4331 * f9_z_p38 - inverse_D4_p8 * f9_z_p32;

  // link 5 (link2), force propagation
  const Real f9_z_p42 = 0.4318 * f9_z_p39 + 0.1501 * f9_z_p37 - c6 * f9_z_p40 + s6 * f9_z_p41 -
      inverse_D4_p16 * f9_z_p36;
  const Real f9_z_p43 = s5 * (0.1501 * f9_z_p35 + s6 * f9_z_p40 + c6 * f9_z_p41 - inverse_D4_p18 *
      f9_z_p36);
  const Real f9_z_p44 = c5 * f9_z_p42 + f9_z_p43;

  // link 4 (link1), force propagation
  const Real f9_z_p45 = s5 * (f9_z_p35 - inverse_D1_p29 * f9_z_p36) + c5 *
      (f9_z_p37 - inverse_D1_p42 * f9_z_p36) - inverse_D1_p56 * f9_z_p44;
  const Real f9_z_p46 = f9_z_p39 + inverse_D1_p52 * f9_z_p36 - inverse_D1_p54 * f9_z_p44;
  const Real f9_z_p47 = c4 * f9_z_p46 - s4 * f9_z_p45;
  const Real f9_z_p48 = s4 * f9_z_p46 + c4 * f9_z_p45;

  // link 3 (base), force propagation
  const Real f9_z_p49 = c3 * f9_z_p47 - s3 * f9_z_p48;

  // link 2 (base_y), force propagation
  const Real f9_z_p50 = s3 * f9_z_p47 + c3 * f9_z_p48 - inverse_D1_p68 * f9_z_p49;
  const Real f9_z_p51 = minus_inverse_D2 * f9_z_p26;

  // link 4 (link1), force propagation
  const Real f9_z_p52 = inverse_D4 * f9_z_p21;

  // link 5 (link2), force propagation
  const Real f9_z_p53 = inverse_D5 * f9_z_p13;

  // link 6 (link3), force propagation
  const Real f9_z_p54 = minus_inverse_D6 * f9_z_p9;

  // link 1 (base_x), force propagation
  const Real f9_z_p55 = f9_z_p32 * f9_z_p54 - f9_z_p36 * f9_z_p53 - f9_z_p44 * f9_z_p52 + f9_z_p49 *
      f9_z_p51 - f9_z_p50 * f9_z_p28;
  const Real f9_z_p56 = f9_z_p32 * (minus_inverse_D6 * f9_z_p32) - f9_z_p36 *
      (inverse_D5 * f9_z_p36) - f9_z_p44 * (inverse_D4 * f9_z_p44);
  const Real f9_z_p57 = 1.0 / (f9_z_p56 + f9_z_p49 * (minus_inverse_D2 * f9_z_p49) - f9_z_p50 *
      (inverse_D1 * f9_z_p50));
  const Real f9_z_p58 = f9_z_p55 * f9_z_p57;

  // link 7 (link4), force propagation
  const Real f9_z_p59 = s7 * c9 + c7 * f9_z_p7;
  const Real f9_z_p60 = 0.4331 * f9_z_p59 - 0.0203 * f9_z_p1;

  // link 6 (link3), force propagation
  const Real f9_z_p61 = f9_z_p1 - inverse_D1_p12 * f9_z_p60;
  const Real f9_z_p62 = f9_z_p59 + inverse_D1_p2 * f9_z_p60;
  const Real f9_z_p63 = c6 * f9_z_p61 + s6 * f9_z_p62;
  const Real f9_z_p64 = 0.4318 * f9_z_p63;
  const Real f9_z_p65 = s6 * f9_z_p61 - c6 * f9_z_p62;

  // link 7 (link4), force propagation
  const Real f9_z_p66 = c7 * c9 - s7 * f9_z_p7;

  // link 6 (link3), force propagation
  const Real f9_z_p67 = f9_z_p66 - inverse_D1_p34 * f9_z_p60;
  const Real f9_z_p68 = 0.0203 * f9_z_p66 - inverse_D4_p10 * f9_z_p60;
  const Real f9_z_p69 = 0.4331 * f9_z_p66 - inverse_D4_p8 * f9_z_p60;

  // link 5 (link2), force propagation
  const Real f9_z_p70 = 0.4318 * f9_z_p67 - 0.1501 * f9_z_p65 - c6 * f9_z_p68 + s6 * f9_z_p69 +
      inverse_D4_p16 * f9_z_p64;
  const Real f9_z_p71 = s5 * (0.1501 * f9_z_p63 - s6 * f9_z_p68 - c6 * f9_z_p69 - inverse_D4_p18 *
      f9_z_p64);
  const Real f9_z_p72 = c5 * f9_z_p70 - f9_z_p71;

  // link 4 (link1), force propagation
  const Real f9_z_p73 = s5 * (f9_z_p63 - inverse_D1_p29 * f9_z_p64) + c5 *
      (f9_z_p65 - inverse_D1_p42 * f9_z_p64) + inverse_D1_p56 * f9_z_p72;
  const Real f9_z_p74 = f9_z_p67 - inverse_D1_p52 * f9_z_p64 - inverse_D1_p54 * f9_z_p72;
  const Real f9_z_p75 = c4 * f9_z_p74 + s4 * f9_z_p73;
  const Real f9_z_p76 = s4 * f9_z_p74 - c4 * f9_z_p73;

  // link 3 (base), force propagation
  const Real f9_z_p77 = c3 * f9_z_p75 - s3 * f9_z_p76;

  // link 2 (base_y), force propagation
  const Real f9_z_p78 = s3 * f9_z_p75 + c3 * f9_z_p76 - inverse_D1_p68 * f9_z_p77;

  // link 1 (base_x), force propagation
  const Real f9_z_p79 = inverse_D1 * f9_z_p78;

  // link 2 (base_y), force propagation
  const Real f9_z_p80 = minus_inverse_D2 * f9_z_p77;

  // link 4 (link1), force propagation
  const Real f9_z_p81 = inverse_D4 * f9_z_p72;

  // link 5 (link2), force propagation
  const Real f9_z_p82 = inverse_D5 * f9_z_p64;

  // link 6 (link3), force propagation
  const Real f9_z_p83 = minus_inverse_D6 * f9_z_p60;

  // link 1 (base_x), force propagation
  const Real f9_z_p84 = f9_z_p32 * f9_z_p83 + f9_z_p36 * f9_z_p82 - f9_z_p44 * f9_z_p81 + f9_z_p49 *
      f9_z_p80 - f9_z_p50 * f9_z_p79;
  const Real f9_z_p85 = f9_z_p60 * f9_z_p54 + f9_z_p64 * f9_z_p53 - f9_z_p72 * f9_z_p52 + f9_z_p77 *
      f9_z_p51 - f9_z_p78 * f9_z_p28;
  const Real f9_z_p86 = f9_z_p85 - f9_z_p84 * f9_z_p58;
  const Real f9_z_p87 = f9_z_p84 * f9_z_p57;
  const Real f9_z_p88 = f9_z_p60 * f9_z_p83 - f9_z_p64 * f9_z_p82 - f9_z_p72 * f9_z_p81 + f9_z_p77 *
      f9_z_p80 - f9_z_p78 * f9_z_p79;
  const Real f9_z_p89 = 1.0 / (f9_z_p88 - f9_z_p84 * f9_z_p87);
  const Real f9_z_p90 = f9_z_p86 * f9_z_p89;

  // link 7 (link4), force propagation
  const Real f9_z_p91 = c7 * s8;
  const Real f9_z_p92 = 0.4331 * f9_z_p91 + 0.0203 * c8;

  // link 6 (link3), force propagation
  const Real f9_z_p93 = c8 + inverse_D1_p12 * f9_z_p92;
  const Real f9_z_p94 = f9_z_p91 + inverse_D1_p2 * f9_z_p92;
  const Real f9_z_p95 = c6 * f9_z_p93 - s6 * f9_z_p94;
  const Real f9_z_p96 = 0.4318 * f9_z_p95;
  const Real f9_z_p97 = s6 * f9_z_p93 + c6 * f9_z_p94;

  // link 7 (link4), force propagation
  const Real f9_z_p98 = s7 * s8;

  // link 6 (link3), force propagation
  const Real f9_z_p99 = f9_z_p98 + inverse_D1_p34 * f9_z_p92;
  const Real f9_z_p100 = 0.0203 * f9_z_p98 + inverse_D4_p10 * f9_z_p92;
  const Real f9_z_p101 = 0.4331 * f9_z_p98 + inverse_D4_p8 * f9_z_p92;

  // link 5 (link2), force propagation
  const Real f9_z_p102 = 0.4318 * f9_z_p99 - 0.1501 * f9_z_p97 - c6 * f9_z_p100 + s6 * f9_z_p101 +
      inverse_D4_p16 * f9_z_p96;
  const Real f9_z_p103 = s5 * (0.1501 * f9_z_p95 - s6 * f9_z_p100 - c6 * f9_z_p101 -
      inverse_D4_p18 * f9_z_p96);
  const Real f9_z_p104 = c5 * f9_z_p102 - f9_z_p103;

  // link 4 (link1), force propagation
  const Real f9_z_p105 = s5 * (f9_z_p95 - inverse_D1_p29 * f9_z_p96) + c5 *
      (f9_z_p97 - inverse_D1_p42 * f9_z_p96) + inverse_D1_p56 * f9_z_p104;
  const Real f9_z_p106 = f9_z_p99 - inverse_D1_p52 * f9_z_p96 - inverse_D1_p54 * f9_z_p104;
  const Real f9_z_p107 = c4 * f9_z_p106 + s4 * f9_z_p105;
  const Real f9_z_p108 = s4 * f9_z_p106 - c4 * f9_z_p105;

  // link 3 (base), force propagation
  const Real f9_z_p109 = c3 * f9_z_p107 - s3 * f9_z_p108;

  // link 2 (base_y), force propagation
  const Real f9_z_p110 = s3 * f9_z_p107 + c3 * f9_z_p108 - inverse_D1_p68 * f9_z_p109;

  // link 1 (base_x), force propagation
  const Real f9_z_p111 = inverse_D1 * f9_z_p110;

  // link 2 (base_y), force propagation
  const Real f9_z_p112 = minus_inverse_D2 * f9_z_p109;

  // link 4 (link1), force propagation
  const Real f9_z_p113 = inverse_D4 * f9_z_p104;

  // link 5 (link2), force propagation
  const Real f9_z_p114 = inverse_D5 * f9_z_p96;

  // link 6 (link3), force propagation
  const Real f9_z_p115 = minus_inverse_D6 * f9_z_p92;

  // link 1 (base_x), force propagation
  const Real f9_z_p116 = f9_z_p32 * f9_z_p115 - f9_z_p36 * f9_z_p114 + f9_z_p44 * f9_z_p113 -
      f9_z_p49 * f9_z_p112 + f9_z_p50 * f9_z_p111;
  const Real f9_z_p117 = f9_z_p116 * f9_z_p57;
  const Real f9_z_p118 = f9_z_p60 * f9_z_p115 + f9_z_p64 * f9_z_p114 + f9_z_p72 * f9_z_p113 -
      f9_z_p77 * f9_z_p112 + f9_z_p78 * f9_z_p111;
  const Real f9_z_p119 = f9_z_p118 - f9_z_p84 * f9_z_p117;
  const Real f9_z_p120 = f9_z_p92 * f9_z_p54 - f9_z_p96 * f9_z_p53 + f9_z_p104 * f9_z_p52 -
      f9_z_p109 * f9_z_p51 + f9_z_p110 * f9_z_p28;
  const Real f9_z_p121 = f9_z_p120 - f9_z_p116 * f9_z_p58 - f9_z_p119 * f9_z_p90;
  const Real f9_z_p122 = f9_z_p119 * f9_z_p89;
  const Real f9_z_p123 = f9_z_p92 * f9_z_p115 - f9_z_p96 * f9_z_p114 - f9_z_p104 * f9_z_p113 +
      f9_z_p109 * f9_z_p112 - f9_z_p110 * f9_z_p111;
  const Real f9_z_p124 = 1.0 / (f9_z_p123 - f9_z_p116 * f9_z_p117 - f9_z_p119 * f9_z_p122);
  const Real f9_z_p125 = f9_z_p121 * f9_z_p124;

  // link 7 (link4), force propagation
  const Real f9_z_p126 = minus_inverse_D6_p2 * f9_z_p31;

  // link 8 (link5), force propagation
  const Real f9_z_p127 = 4.484863585399276 * s9;
  const Real f9_z_p128 = c8 * f9_z_p127;

  // link 7 (link4), force propagation
  const Real f9_z_p129 = s7 * f9_z_p126 + c7 * f9_z_p128;

  // link 8 (link5), force propagation
  const Real f9_z_p130 = s8 * f9_z_p127;

  // link 7 (link4), force propagation
  const Real f9_z_p131 = f9_z_p29 - minus_inverse_D6_p18 * f9_z_p31;
  const Real f9_z_p132 = 0.4331 * f9_z_p129 - 0.0203 * f9_z_p130 - s7 * f9_z_p131;

  // link 6 (link3), force propagation
  const Real f9_z_p133 = f9_z_p130 - inverse_D1_p12 * f9_z_p132;
  const Real f9_z_p134 = f9_z_p129 + inverse_D1_p2 * f9_z_p132;
  const Real f9_z_p135 = c6 * f9_z_p133 + s6 * f9_z_p134;
  const Real f9_z_p136 = 0.4318 * f9_z_p135;
  const Real f9_z_p137 = s6 * f9_z_p133 - c6 * f9_z_p134;

  // link 7 (link4), force propagation
  const Real f9_z_p138 = c7 * f9_z_p126 - s7 * f9_z_p128;

  // link 6 (link3), force propagation
  const Real f9_z_p139 = f9_z_p138 - inverse_D1_p34 * f9_z_p132;
  const Real f9_z_p140 = 0.0203 * f9_z_p138 - inverse_D4_p10 * f9_z_p132;
  const Real f9_z_p141 = 0.4331 * f9_z_p138 - c7 * f9_z_p131 - inverse_D4_p8 * f9_z_p132;

  // link 5 (link2), force propagation
  const Real f9_z_p142 = 0.4318 * f9_z_p139 - 0.1501 * f9_z_p137 - c6 * f9_z_p140 + s6 * f9_z_p141 +
      inverse_D4_p16 * f9_z_p136;
  const Real f9_z_p143 = s5 * (0.1501 * f9_z_p135 - s6 * f9_z_p140 - c6 * f9_z_p141 -
      inverse_D4_p18 * f9_z_p136);
  const Real f9_z_p144 = c5 * f9_z_p142 - f9_z_p143;

  // link 4 (link1), force propagation
  const Real f9_z_p145 = s5 * (f9_z_p135 - inverse_D1_p29 * f9_z_p136) + c5 *
      (f9_z_p137 - inverse_D1_p42 * f9_z_p136) + inverse_D1_p56 * f9_z_p144;
  const Real f9_z_p146 = f9_z_p139 - inverse_D1_p52 * f9_z_p136 - inverse_D1_p54 * f9_z_p144;
  const Real f9_z_p147 = c4 * f9_z_p146 + s4 * f9_z_p145;
  const Real f9_z_p148 = s4 * f9_z_p146 - c4 * f9_z_p145;

  // link 3 (base), force propagation
  const Real f9_z_p149 = c3 * f9_z_p147 - s3 * f9_z_p148;

  // link 2 (base_y), force propagation
  const Real f9_z_p150 = s3 * f9_z_p147 + c3 * f9_z_p148 - inverse_D1_p68 * f9_z_p149;

  // link 1 (base_x), force propagation
  const Real f9_z_p151 = inverse_D1 * f9_z_p150;

  // link 2 (base_y), force propagation
  const Real f9_z_p152 = minus_inverse_D2 * f9_z_p149;

  // link 4 (link1), force propagation
  const Real f9_z_p153 = inverse_D4 * f9_z_p144;

  // link 5 (link2), force propagation
  const Real f9_z_p154 = inverse_D5 * f9_z_p136;

  // link 6 (link3), force propagation
  const Real f9_z_p155 = minus_inverse_D6 * f9_z_p132;

  // link 1 (base_x), force propagation
  const Real f9_z_p156 = f9_z_p32 * f9_z_p155 + f9_z_p36 * f9_z_p154 - f9_z_p44 * f9_z_p153 +
      f9_z_p49 * f9_z_p152 - f9_z_p50 * f9_z_p151;
  const Real f9_z_p157 = f9_z_p156 * f9_z_p57;
  const Real f9_z_p158 = f9_z_p60 * f9_z_p155 - f9_z_p64 * f9_z_p154 - f9_z_p72 * f9_z_p153 +
      f9_z_p77 * f9_z_p152 - f9_z_p78 * f9_z_p151;
  const Real f9_z_p159 = f9_z_p158 - f9_z_p84 * f9_z_p157;
  const Real f9_z_p160 = f9_z_p159 * f9_z_p89;
  const Real f9_z_p161 = f9_z_p92 * f9_z_p155 + f9_z_p96 * f9_z_p154 + f9_z_p104 * f9_z_p153 -
      f9_z_p109 * f9_z_p152 + f9_z_p110 * f9_z_p151;
  const Real f9_z_p162 = f9_z_p161 - f9_z_p116 * f9_z_p157 - f9_z_p119 * f9_z_p160;

  // link 7 (link4), force propagation
  const Real f9_z_p163 = inverse_D7 * f9_z_p1;

  // link 8 (link5), force propagation
  const Real f9_z_p164 = 1557.24430048586 * c9;

  // link 1 (base_x), force propagation
  const Real f9_z_p165 = s9 * f9_z_p164 - f9_z_p31 * f9_z_p163 + f9_z_p132 * f9_z_p54 + f9_z_p136 *
      f9_z_p53 - f9_z_p144 * f9_z_p52;
  const Real f9_z_p166 = f9_z_p165 + f9_z_p149 * f9_z_p51 - f9_z_p150 * f9_z_p28 - f9_z_p156 *
      f9_z_p58 - f9_z_p159 * f9_z_p90;
  const Real f9_z_p167 = f9_z_p166 - f9_z_p162 * f9_z_p125;
  const Real f9_z_p168 = f9_z_p162 * f9_z_p124;
  const Real f9_z_p169 = s9 * (1557.24430048586 * s9) + f9_z_p31 * (inverse_D7 * f9_z_p31) -
      f9_z_p132 * f9_z_p155 + f9_z_p136 * f9_z_p154;
  const Real f9_z_p170 = f9_z_p169 + f9_z_p144 * f9_z_p153 - f9_z_p149 * f9_z_p152 + f9_z_p150 *
      f9_z_p151 + f9_z_p156 * f9_z_p157;
  const Real f9_z_p171 = 1.0 / (f9_z_p170 + f9_z_p159 * f9_z_p160 + f9_z_p162 * f9_z_p168);
  const Real f9_z_p172 = f9_z_p167 * f9_z_p171;
  const Real f9_z_p173 = c9 * f9_z_p164 + f9_z_p1 * f9_z_p163 - f9_z_p9 * f9_z_p54 + f9_z_p13 *
      f9_z_p53 + f9_z_p21 * f9_z_p52;
  const Real f9_z_p174 = f9_z_p173 - f9_z_p26 * f9_z_p51 + f9_z_p27 * f9_z_p28 + f9_z_p55 *
      f9_z_p58 + f9_z_p86 * f9_z_p90;

  // link 3 (base), outward
  const Real a3_y = qdd_0[1] * c3 - qdd_0[0] * s3;
  const Real a3_x = qdd_0[1] * s3 + qdd_0[0] * c3;

  // link 4 (link1), outward
  const Real a4_y = c4 * a3_y - s4 * a3_x;
  const Real w4_z = qd[2] + qd[3];

  // link 5 (link2), outward
  const Real minus_w5_x = s5 * w4_z;
  const Real a6_z_p1 = minus_w5_x * minus_w5_x;
  const Real minus_w5_y = c5 * w4_z;
  const Real a6_z_p2 = minus_w5_y * minus_w5_y;

  // link 4 (link1), outward
  const Real wd4_z = qdd_0[2] + qdd_0[3];

  // link 5 (link2), outward
  const Real minus_wd5_y_p1 = c5 * wd4_z;
  const Real minus_wd5_y_p2 = qd[4] * minus_w5_x;
  const Real minus_wd5_y = minus_wd5_y_p1 - minus_wd5_y_p2;
  const Real a6_z_p3 = minus_wd5_y_p2 - minus_wd5_y;

  // link 6 (link3), outward
  const Real a6_z = a4_y - 0.1501 * (a6_z_p1 + a6_z_p2) - 0.4318 * a6_z_p3;

  // link 5 (link2), outward
  const Real minus_wd5_x_p1 = s5 * wd4_z;
  const Real minus_wd5_x_p2 = qd[4] * minus_w5_y;
  const Real minus_wd5_x = minus_wd5_x_p1 + minus_wd5_x_p2;

  // link 6 (link3), outward
  const Real minus_w6_y = c6 * minus_w5_y - s6 * minus_w5_x;
  const Real minus_wd6_x = s6 * minus_wd5_y + c6 * minus_wd5_x + qd[5] * minus_w6_y;
  const Real w6_z = qd[4] + qd[5];
  const Real a7_x_p1 = minus_wd6_x + minus_w6_y * w6_z;
  const Real minus_w6_x = s6 * minus_w5_y + c6 * minus_w5_x;
  const Real minus_wd6_y = c6 * minus_wd5_y - s6 * minus_wd5_x - qd[5] * minus_w6_x;
  const Real a7_x_p2 = minus_w6_x * w6_z;
  const Real a7_x_p3 = minus_wd6_y - a7_x_p2;

  // link 7 (link4), outward
  const Real a7_x_p4 = a6_z + 0.4331 * a7_x_p1 - 0.0203 * a7_x_p3;

  // link 4 (link1), outward
  const Real a4_x = s4 * a3_y + c4 * a3_x;

  // link 5 (link2), outward
  const Real minus_a5_y = 9.81 * c5 + s5 * a4_x;
  const Real minus_a6_x_p1 = minus_w5_x * minus_w5_y;
  const Real minus_a6_x_p2 = qdd_0[4] + minus_a6_x_p1;

  // link 6 (link3), outward
  const Real minus_a6_x_p3 = minus_a5_y - 0.1501 * minus_wd5_x_p1 - 0.4318 * minus_a6_x_p2;

  // link 5 (link2), outward
  const Real minus_a5_x = 9.81 * s5 - c5 * a4_x;
  const Real minus_a6_x_p4 = qd[4] * qd[4];

  // link 6 (link3), outward
  const Real minus_a6_x_p5 = a6_z_p2 + minus_a6_x_p4;
  const Real minus_a6_x_p6 = minus_a5_x + 0.1501 * minus_wd5_y_p1 + 0.4318 * minus_a6_x_p5;
  const Real minus_a6_x = s6 * minus_a6_x_p3 + c6 * minus_a6_x_p6;
  const Real a7_x_p5 = minus_w6_x * minus_w6_y;
  const Real wd6_z = qdd_0[4] + qdd_0[5];
  const Real a7_x_p6 = wd6_z - a7_x_p5;
  const Real a7_x_p7 = minus_w6_y * minus_w6_y;
  const Real a7_x_p8 = w6_z * w6_z;

  // link 7 (link4), outward
  const Real a7_x_p9 = a7_x_p7 + a7_x_p8;
  const Real a7_x_p10 = minus_a6_x - 0.4331 * a7_x_p6 - 0.0203 * a7_x_p9;
  const Real a7_x = s7 * a7_x_p4 - c7 * a7_x_p10;

  // link 6 (link3), outward
  const Real minus_a6_y = c6 * minus_a6_x_p3 - s6 * minus_a6_x_p6;
  const Real a7_z_p1 = minus_w6_x * minus_w6_x;

  // link 7 (link4), outward
  const Real a7_z_p2 = a7_z_p1 + a7_x_p8;

  // link 6 (link3), outward
  const Real a7_z_p3 = wd6_z + a7_x_p5;

  // link 7 (link4), outward
  const Real a7_z = minus_a6_y - 0.4331 * a7_z_p2 + 0.0203 * a7_z_p3;

  // link 8 (link5), outward
  const Real minus_a8_x = s8 * a7_z - c8 * a7_x;

  // link 9 (link6), outward
  const Real f9_z_p175 = xdd_cmd[1] * c3 - xdd_cmd[0] * s3;
  const Real f9_z_p176 = xdd_cmd[1] * s3 + xdd_cmd[0] * c3;
  const Real f9_z_p177 = s4 * f9_z_p175 + c4 * f9_z_p176;
  const Real f9_z_p178 = 9.81 + xdd_cmd[2];
  const Real f9_z_p179 = c5 * f9_z_p178 + s5 * f9_z_p177;
  const Real f9_z_p180 = s5 * f9_z_p178 - c5 * f9_z_p177;
  const Real f9_z_p181 = c6 * f9_z_p179 - s6 * f9_z_p180;
  const Real f9_z_p182 = s6 * f9_z_p179 + c6 * f9_z_p180;
  const Real f9_z_p183 = c4 * f9_z_p175 - s4 * f9_z_p176;
  const Real f9_z_p184 = s7 * f9_z_p183 - c7 * f9_z_p182;
  const Real f9_z_p185 = minus_a8_x - (s8 * f9_z_p181 - c8 * f9_z_p184);

  // link 7 (link4), outward
  const Real wd7_z = qdd_0[6] + minus_wd6_y;
  const Real w7_y = c7 * w6_z + s7 * minus_w6_x;
  const Real wd7_x = s7 * wd6_z - c7 * minus_wd6_x + qd[6] * w7_y;
  const Real w7_z = qd[6] + minus_w6_y;
  const Real w7_x = s7 * w6_z - c7 * minus_w6_x;

  // link 8 (link5), outward
  const Real minus_w8_y = c8 * w7_z + s8 * w7_x;
  const Real minus_wd8_x = s8 * wd7_z - c8 * wd7_x + qd[7] * minus_w8_y;

  // link 7 (link4), outward
  const Real wd7_y = c7 * wd6_z + s7 * minus_wd6_x - qd[6] * w7_x;

  // link 8 (link5), outward
  const Real wd8_z = qdd_0[7] + wd7_y;
  const Real minus_w8_x = s8 * w7_z - c8 * w7_x;
  const Real w8_z = qd[7] + w7_y;

  // link 9 (link6), outward
  const Real w9_x = s9 * w8_z - c9 * minus_w8_x;
  const Real wd9_y = c9 * wd8_z + s9 * minus_wd8_x - qd[8] * w9_x;
  const Real f9_z_p186 = xdd_cmd[4] * c3 - xdd_cmd[3] * s3;
  const Real f9_z_p187 = xdd_cmd[4] * s3 + xdd_cmd[3] * c3;
  const Real f9_z_p188 = s4 * f9_z_p186 + c4 * f9_z_p187;
  const Real f9_z_p189 = xdd_cmd[5] * c5 + s5 * f9_z_p188;
  const Real f9_z_p190 = xdd_cmd[5] * s5 - c5 * f9_z_p188;
  const Real f9_z_p191 = s6 * f9_z_p189 + c6 * f9_z_p190;
  const Real f9_z_p192 = c4 * f9_z_p186 - s4 * f9_z_p187;
  const Real f9_z_p193 = c7 * f9_z_p192 + s7 * f9_z_p191;
  const Real f9_z_p194 = c6 * f9_z_p189 - s6 * f9_z_p190;
  const Real f9_z_p195 = s7 * f9_z_p192 - c7 * f9_z_p191;
  const Real f9_z_p196 = s8 * f9_z_p194 - c8 * f9_z_p195;
  const Real f9_z_p197 = wd9_y - c9 * f9_z_p193 - s9 * f9_z_p196;
  const Real w9_z = qd[8] + minus_w8_y;
  const Real f9_z_p198 = w9_x * w9_z;

  // link 7 (link4), outward
  const Real a7_y = c7 * a7_x_p4 + s7 * a7_x_p10;

  // link 9 (link6), outward
  const Real f9_z_p199 = a7_y - (c7 * f9_z_p183 + s7 * f9_z_p182);
  const Real f9_z_p200 = s9 * f9_z_p199 - (c9 * f9_z_p185 - 0.05625 *
      (wd9_y + f9_z_p198 - f9_z_p197));
  const Real w9_y = c9 * w8_z + s9 * minus_w8_x;
  const Real wd9_x = s9 * wd8_z - c9 * minus_wd8_x + qd[8] * w9_y;
  const Real f9_z_p201 = wd9_x - s9 * f9_z_p193 + c9 * f9_z_p196;
  const Real f9_z_p202 = w9_y * w9_z;

  // link 1 (base_x), force propagation
  const Real f9_z_p203 = c9 * f9_z_p199 + (s9 * f9_z_p185 -
      (0.05625 * (wd9_x - f9_z_p202 - f9_z_p201) + f9_z_p200 * f9_z_p87));
  const Real f9_z_p204 = 0.05625 * (w9_x * w9_x + w9_y * w9_y) - f9_z_p200 * f9_z_p117 - f9_z_p122 *
      f9_z_p203;
  const Real f9_z_p205 = c8 * (a7_z - f9_z_p181) + (s8 * (a7_x - f9_z_p184) - f9_z_p204);
  const Real f9_z_p206 = f9_z_p201 - f9_z_p200 * f9_z_p157 - f9_z_p160 * f9_z_p203 + f9_z_p168 *
      f9_z_p205;
  const Real f9_z_p207 = f9_z_p197 + f9_z_p200 * f9_z_p58 + f9_z_p90 * f9_z_p203 - f9_z_p125 *
      f9_z_p205 - f9_z_p172 * f9_z_p206;
  const Real f9_z_p208 = 1.0 / (f9_z_p174 + f9_z_p121 * f9_z_p125 - f9_z_p167 * f9_z_p172) *
      f9_z_p207;
  const Real f9_z_p209 = f9_z_p171 * f9_z_p206 - f9_z_p172 * f9_z_p208;
  const Real f9_z = f9_z_p124 * f9_z_p205 - f9_z_p168 * f9_z_p209 + f9_z_p125 * f9_z_p208;
  const Real f9_y = f9_z_p89 * f9_z_p203 + f9_z_p122 * f9_z + f9_z_p160 * f9_z_p209 - f9_z_p90 *
      f9_z_p208;
  const Real f9_x = f9_z_p200 * f9_z_p57 - f9_z_p87 * f9_y + f9_z_p117 * f9_z + f9_z_p157 *
      f9_z_p209 - f9_z_p58 * f9_z_p208;

  // link 8 (link5), outward
  const Real f8_z_p1 = minus_wd8_x + minus_w8_y * w8_z;

  // link 9 (link6), inward
  const Real f8_z = 0.0028799999999999997 * f8_z_p1 + c9 * f9_y + s9 * f9_x;

  // link 8 (link5), outward
  const Real f8_x_p1 = minus_w8_x * minus_w8_y;

  // link 9 (link6), inward
  const Real f8_x = 0.0028799999999999997 * (wd8_z - f8_x_p1) - s9 * f9_y + c9 * f9_x;
  const Real minus_f8_y = f9_z - 0.0028799999999999997 * (minus_w8_x * minus_w8_x + w8_z * w8_z);

  // link 8 (link5), inward
  const Real f7_x = s8 * minus_f8_y + c8 * f8_x;

  // link 7 (link4), inward
  const Real minus_f6_x_p1 = s7 * f8_z - c7 * f7_x;
  const Real minus_f6_x = minus_f6_x_p1 - (0.861795 * a7_x_p6 + 0.025374999999999998 * a7_x_p9);

  // link 8 (link5), inward
  const Real f7_z = c8 * minus_f8_y - s8 * f8_x;

  // link 7 (link4), inward
  const Real minus_f6_y = f7_z - (0.861795 * a7_z_p2 - 0.025374999999999998 * a7_z_p3);

  // link 6 (link3), inward
  const Real minus_f5_y_p1 = c6 * minus_f6_y + s6 * minus_f6_x;
  const Real minus_f5_y = minus_f5_y_p1 + (0.10439999999999999 * (a6_z_p1 + minus_a6_x_p4) -
      3.79559 * minus_a6_x_p2);
  const Real f5_x_p1 = s6 * minus_f6_y - c6 * minus_f6_x;

  // link 5 (link2), outward
  const Real f5_x_p2 = qdd_0[4] - minus_a6_x_p1;

  // link 6 (link3), inward
  const Real f5_x = f5_x_p1 - (0.10439999999999999 * f5_x_p2 + 3.79559 * minus_a6_x_p5);

  // link 5 (link2), inward
  const Real minus_f4_x = 4.9338049999999996 * wd4_z - s5 * minus_f5_y - c5 * f5_x;

  // link 7 (link4), inward
  const Real f6_z_p1 = c7 * f8_z + s7 * f7_x;
  const Real f6_z = f6_z_p1 + (0.861795 * a7_x_p1 - 0.025374999999999998 * a7_x_p3);

  // link 5 (link2), outward
  const Real f4_y_p1 = minus_wd5_x_p2 + minus_wd5_x;

  // link 5 (link2), inward
  const Real f4_y = f6_z - (w4_z * (4.9338049999999996 * w4_z) + 0.10439999999999999 * f4_y_p1 +
      3.79559 * a6_z_p3);

  // link 4 (link1), inward
  const Real f3_y = c4 * f4_y - s4 * minus_f4_x;
  const Real minus_f3_x = s4 * f4_y + c4 * minus_f4_x;

  // link 3 (base), inward
  const Real f2_x = 186.45 * qdd_0[0] - s3 * f3_y - c3 * minus_f3_x;
  tau[0] = f2_x;
  const Real f2_z = 186.45 * qdd_0[1] + c3 * f3_y - s3 * minus_f3_x;
  tau[1] = f2_z;

  // link 6 (link3), inward
  const Real n5_y_p1 = 0.690314699 * (a6_z_p1 - minus_a6_x_p4) + 0.0070992 * f4_y_p1 -
      0.023750999999999998 * f5_x_p2 + 1.674987602 * a6_z_p3;

  // link 9 (link6), inertial wrench
  const Real minus_n9_y = f9_z_p208 - 2e-05 * (wd9_y - f9_z_p198);
  const Real minus_n9_x = f9_z_p209 - 2e-05 * (wd9_x + f9_z_p202);

  // link 9 (link6), inward
  const Real minus_n8_x = 0.00042216 * f8_z_p1 + 0.0028799999999999997 * a7_y - s9 * minus_n9_y +
      c9 * minus_n9_x;

  // link 8 (link5), outward
  const Real minus_wd8_y = c8 * wd7_z + s8 * wd7_x - qd[7] * minus_w8_x;

  // link 9 (link6), outward
  const Real wd9_z = qdd_0[8] + minus_wd8_y;

  // link 9 (link6), inertial wrench
  const Real n9_z = 4e-05 * (wd9_z - (wd9_z - c8 * f9_z_p194 - s8 * f9_z_p195));
  tau[8] = n9_z;

  // link 9 (link6), inward
  const Real minus_n8_y = n9_z + 2e-04 * (minus_wd8_y - minus_w8_x * w8_z);

  // link 8 (link5), inward
  const Real n7_z = 0.0013999999999999998 * wd7_z - w7_y * (9.999999999999994e-05 * w7_x) + c8 *
      minus_n8_y + s8 * minus_n8_x;
  tau[6] = n7_z;

  // link 7 (link4), inward
  const Real minus_n6_y_p1 = n7_z - (0.010673638499999999 * a7_x_p1 + 0.004704000000000001 *
      a7_x_p6 - 0.0067651125 * a7_x_p3 + 0.025374999999999998 * a6_z);
  const Real minus_n6_y = minus_n6_y_p1 - 0.0203 * f6_z_p1;

  // link 6 (link3), inward
  const Real n5_y_p2 = n5_y_p1 - 3.79559 * a4_y - 0.4318 * f6_z + 0.1501 * f5_x_p1 - c6 *
      minus_n6_y;

  // link 7 (link4), inward
  const Real n6_x_p1 = 0.004704000000000001 * (a7_x_p7 - a7_x_p8) + 0.010673638499999999 * a7_x_p3 -
      0.3056901365 * a7_x_p1 - 0.861795 * a6_z;

  // link 9 (link6), inward
  const Real n8_z = 0.00062216 * wd8_z - 0.00022215999999999997 * f8_x_p1 - 0.0028799999999999997 *
      minus_a8_x - c9 * minus_n9_y - s9 * minus_n9_x;
  tau[7] = n8_z;

  // link 8 (link5), inward
  const Real n7_y = n8_z + 0.00065 * (wd7_y - w7_x * w7_z);
  const Real n7_x = 0.0007499999999999999 * (wd7_x + w7_y * w7_z) + s8 * minus_n8_y - c8 *
      minus_n8_x;

  // link 7 (link4), inward
  const Real n6_x = n6_x_p1 - 0.4331 * f6_z_p1 - s7 * n7_y + c7 * n7_x;

  // link 6 (link3), inward
  const Real n5_y = n5_y_p2 + s6 * n6_x;
  const Real minus_n5_x_p1 = 0.023750999999999998 * (a6_z_p2 - minus_a6_x_p4) + 0.690314699 *
      minus_a6_x_p2 + 0.0070992 * a6_z_p3 + 0.07312640000000001 * f4_y_p1;
  const Real minus_n5_x = minus_n5_x_p1 - 0.10439999999999999 * a4_y - 0.1501 * minus_f5_y_p1 - s6 *
      minus_n6_y - c6 * n6_x;

  // link 5 (link2), inward
  const Real n4_z = 1.4717295504999999 * wd4_z - 4.9338049999999996 * a4_x - c5 * n5_y + s5 *
      minus_n5_x;
  tau[3] = n4_z;

  // link 4 (link1), inward
  const Real n3_z = n4_z + 7.2 * qdd_0[2];
  tau[2] = n3_z;

  // link 7 (link4), inward
  const Real minus_n6_z_p1 = 0.010673638499999999 * (a7_z_p1 - a7_x_p7) + 0.004704000000000001 *
      (minus_wd6_y + a7_x_p2) - 0.312455249 * wd6_z + 0.298925024 * a7_x_p5;
  const Real minus_n6_z_p2 = minus_n6_z_p1 + 0.861795 * minus_a6_x - 0.025374999999999998 *
      minus_a6_y + 0.4331 * minus_f6_x_p1 - 0.0203 * f7_z;
  const Real minus_n6_z = minus_n6_z_p2 - c7 * n7_y - s7 * n7_x;
  tau[5] = -minus_n6_z;

  // link 6 (link3), inward
  const Real minus_n5_z_p1 = 0.0070992 * (a6_z_p1 - a6_z_p2) - 0.023750999999999998 *
      minus_wd5_y_p1 - 0.690314699 * minus_wd5_x_p1 - 1.7481140020000001 * qdd_0[4];
  const Real minus_n5_z = minus_n6_z + (minus_n5_z_p1 - 1.601861202 * minus_a6_x_p1 -
      0.10439999999999999 * minus_a5_x + 3.79559 * minus_a5_y) + 0.4318 * minus_f5_y_p1;
  tau[4] = -minus_n5_z;
}

}  // namespace samm

#undef TREELINE_RESTRICT
