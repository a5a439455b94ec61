// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at link origins.
// 1106 flops (add 462, mul 635, div 9), sine and cosine of 6 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void control_torque(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT qdd_0)[6], const Real (&TREELINE_RESTRICT xdd_cmd)[6],
    Real (&TREELINE_RESTRICT tau)[6]) noexcept {
  const Real angles[6] = {q[0], q[1], q[2], q[3], q[4], q[5]};
  Real sines[6];
  Real cosines[6];
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
  const Real s6 = sines[5];
  const Real c6 = cosines[5];

  // link 5 (link5), articulated inertia
  const Real minus_inverse_D3_p1 = 0.0028799999999999997 * s5;
  const Real inverse_D4_p1 = 0.00024215999999999997 * s5;
  const Real inverse_D4_p2 = s5 * inverse_D4_p1;

  // link 4 (link4), articulated inertia
  const Real inverse_D4 = 1.0 / (0.0016 + inverse_D4_p2);
  const Real minus_inverse_D3_p2 = minus_inverse_D3_p1 * inverse_D4;

  // link 5 (link5), articulated inertia
  const Real minus_inverse_D3_p3 = c5 * inverse_D4_p1;

  // link 4 (link4), articulated inertia
  const Real minus_inverse_D3_p4 = 0.0028799999999999997 * c5 - minus_inverse_D3_p3 *
      minus_inverse_D3_p2;
  const Real minus_inverse_D3_p5 = c4 * minus_inverse_D3_p4;
  const Real minus_inverse_D3_p6 = c4 * minus_inverse_D3_p5;
  const Real minus_inverse_D3_p7 = minus_inverse_D3_p4 - minus_inverse_D3_p6;

  // link 5 (link5), articulated inertia
  const Real minus_inverse_D3_p8 = 0.012916407125949915 * s5;
  const Real minus_inverse_D3_p9 = c5 * minus_inverse_D3_p8;

  // link 4 (link4), articulated inertia
  const Real minus_inverse_D3_p10 = c4 * minus_inverse_D3_p9;
  const Real minus_inverse_D3_p11 = minus_inverse_D3_p1 * minus_inverse_D3_p2;

  // link 5 (link5), articulated inertia
  const Real minus_inverse_D3_p12 = s5 * minus_inverse_D3_p8;
  const Real minus_inverse_D3_p13 = 0.012916407125949915 - minus_inverse_D3_p12;

  // link 4 (link4), articulated inertia
  const Real minus_inverse_D3_p14 = s4 * (minus_inverse_D3_p13 - minus_inverse_D3_p11);
  const Real minus_inverse_D3_p15 = s4 * minus_inverse_D3_p14;
  const Real minus_inverse_D3_p16 = minus_inverse_D3_p13 - minus_inverse_D3_p15;
  const Real minus_inverse_D3_p17 = minus_inverse_D3_p7 + 0.0203 * minus_inverse_D3_p10 - 0.4331 *
      minus_inverse_D3_p16;
  const Real minus_inverse_D3_p18 = minus_inverse_D3_p3 * inverse_D4;
  const Real minus_inverse_D3_p19 = inverse_D4_p2 - 0.0011921599999999998 + minus_inverse_D3_p3 *
      minus_inverse_D3_p18;
  const Real minus_inverse_D3_p20 = s4 * (0.00065 + minus_inverse_D3_p19);
  const Real minus_inverse_D3_p21 = s4 * minus_inverse_D3_p20;
  const Real minus_inverse_D3_p22 = 0.0203 * minus_inverse_D3_p12 - 0.4331 * minus_inverse_D3_p10;

  // link 3 (link3), articulated inertia
  const Real minus_inverse_D3 = 1.0 / (minus_inverse_D3_p21 - 0.313105249 - 0.4331 *
      (minus_inverse_D3_p7 + minus_inverse_D3_p17) + 0.0203 * minus_inverse_D3_p22);

  // link 4 (link4), articulated inertia
  const Real inverse_D1_p1 = 0.861795 + minus_inverse_D3_p17;

  // link 3 (link3), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * minus_inverse_D3;

  // link 4 (link4), articulated inertia
  const Real inverse_D1_p3 = s4 * minus_inverse_D3_p5;
  const Real inverse_D1_p4 = c4 * minus_inverse_D3_p14;
  const Real inverse_D1_p5 = inverse_D1_p3 + 0.4331 * inverse_D1_p4;
  const Real inverse_D1_p6 = s4 * minus_inverse_D3_p9;
  const Real inverse_D1_p7 = 0.0203 * inverse_D1_p6;
  const Real inverse_D1_p8 = inverse_D1_p7 - inverse_D1_p5;
  const Real inverse_D1_p9 = 0.004704000000000001 + 0.0203 * inverse_D1_p8;

  // link 3 (link3), articulated inertia
  const Real inverse_D1_p10 = 0.0203 * inverse_D1_p4 - inverse_D1_p9 * inverse_D1_p2;

  // link 4 (link4), articulated inertia
  const Real inverse_D1_p11 = 0.025374999999999998 - minus_inverse_D3_p22;

  // link 3 (link3), articulated inertia
  const Real inverse_D1_p12 = inverse_D1_p11 * minus_inverse_D3;

  // link 4 (link4), articulated inertia
  const Real inverse_D1_p13 = c4 * minus_inverse_D3_p20 - 0.4331 * (inverse_D1_p3 - inverse_D1_p8);

  // link 3 (link3), articulated inertia
  const Real inverse_D1_p14 = 0.4331 * inverse_D1_p6 + inverse_D1_p13 * inverse_D1_p12;
  const Real inverse_D1_p15 = inverse_D1_p5 - inverse_D1_p13 * inverse_D1_p2;
  const Real inverse_D1_p16 = inverse_D1_p7 + inverse_D1_p9 * inverse_D1_p12;
  const Real inverse_D1_p17 = c3 * (inverse_D1_p10 - inverse_D1_p14) - s3 *
      (inverse_D1_p15 + inverse_D1_p16);
  const Real inverse_D1_p18 = c3 * inverse_D1_p17;
  const Real inverse_D1_p19 = minus_inverse_D3_p16 - inverse_D1_p1 * inverse_D1_p2;
  const Real inverse_D1_p20 = minus_inverse_D3_p12 - inverse_D1_p11 * inverse_D1_p12;
  const Real inverse_D1_p21 = minus_inverse_D3_p10 + inverse_D1_p1 * inverse_D1_p12;
  const Real inverse_D1_p22 = 2.0 * c3;
  const Real inverse_D1_p23 = inverse_D1_p21 * inverse_D1_p22 + s3 *
      (inverse_D1_p19 - inverse_D1_p20);
  const Real inverse_D1_p24 = s3 * inverse_D1_p23;
  const Real inverse_D1_p25 = inverse_D1_p8 * minus_inverse_D3;
  const Real inverse_D1_p26 = inverse_D1_p6 + inverse_D1_p11 * inverse_D1_p25;
  const Real inverse_D1_p27 = inverse_D1_p4 - inverse_D1_p1 * inverse_D1_p25;
  const Real inverse_D1_p28 = s3 * inverse_D1_p26 - c3 * inverse_D1_p27;

  // link 2 (link2), articulated inertia
  const Real inverse_D1_p29 = 0.1501 * (2.0 * (inverse_D1_p14 + inverse_D1_p18) +
      (0.1501 * (inverse_D1_p19 - inverse_D1_p24) + 0.4318 * inverse_D1_p28));

  // link 4 (link4), articulated inertia
  const Real inverse_D1_p30 = minus_inverse_D3_p11 + minus_inverse_D3_p15;

  // link 3 (link3), articulated inertia
  const Real inverse_D1_p31 = 0.025374999999999998 - 0.0203 * inverse_D1_p30 + inverse_D1_p9 *
      inverse_D1_p25;

  // link 4 (link4), articulated inertia
  const Real inverse_D1_p32 = minus_inverse_D3_p6 - 0.4331 * inverse_D1_p30;

  // link 3 (link3), articulated inertia
  const Real inverse_D1_p33 = 0.861795 + inverse_D1_p32 + inverse_D1_p13 * inverse_D1_p25;
  const Real inverse_D1_p34 = 2.0 * (c3 * inverse_D1_p31 - s3 * inverse_D1_p33) +
      (0.1501 * inverse_D1_p28 + 0.4318 * (inverse_D1_p30 - inverse_D1_p8 * inverse_D1_p25));
  const Real inverse_D1_p35 = inverse_D1_p13 * minus_inverse_D3;
  const Real inverse_D1_p36 = minus_inverse_D3_p21 + (0.3056901365 - minus_inverse_D3_p19) +
      0.4331 * (minus_inverse_D3_p6 + inverse_D1_p32) + inverse_D1_p13 * inverse_D1_p35;
  const Real inverse_D1_p37 = inverse_D1_p9 * minus_inverse_D3;
  const Real inverse_D1_p38 = 0.0067651125 - 0.00041208999999999994 * inverse_D1_p30 +
      inverse_D1_p9 * inverse_D1_p37;
  const Real inverse_D1_p39 = 0.010673638499999999 - 0.00879193 * inverse_D1_p30 + 0.0203 *
      minus_inverse_D3_p6 + inverse_D1_p13 * inverse_D1_p37;
  const Real inverse_D1_p40 = inverse_D1_p39 * inverse_D1_p22 - s3 *
      (inverse_D1_p36 - inverse_D1_p38);
  const Real inverse_D1_p41 = s3 * inverse_D1_p40;
  const Real inverse_D1_p42 = s3 * inverse_D1_p17;
  const Real inverse_D1_p43 = inverse_D1_p16 + inverse_D1_p42;
  const Real inverse_D1_p44 = 0.4318 * (c3 * inverse_D1_p26 + s3 * inverse_D1_p27);
  const Real inverse_D1_p45 = inverse_D1_p21 - c3 * inverse_D1_p23;
  const Real inverse_D1_p46 = 0.023750999999999998 - 0.06481318000000001 * inverse_D1_p45 + 0.4318 *
      (inverse_D1_p43 - inverse_D1_p44);
  const Real inverse_D2_p1 = inverse_D1_p20 + inverse_D1_p24;

  // link 2 (link2), articulated inertia
  const Real inverse_D2 = 1.0 / (1.7481140020000001 - 0.18645124000000002 * inverse_D2_p1);
  const Real inverse_D1_p47 = inverse_D1_p46 * inverse_D2;
  const Real inverse_D1_p48 = inverse_D1_p41 - (1.674987602 + inverse_D1_p38) + 0.4318 *
      inverse_D1_p34 + inverse_D1_p29 + inverse_D1_p46 * inverse_D1_p47;

  // link 3 (link3), articulated inertia
  const Real inverse_D1_p49 = inverse_D1_p10 - inverse_D1_p18;
  const Real inverse_D1_p50 = 0.690314699 - 0.06481318000000001 * inverse_D2_p1 - 0.4318 *
      inverse_D1_p49;

  // link 2 (link2), articulated inertia
  const Real inverse_D1_p51 = inverse_D1_p50 * inverse_D2;
  const Real inverse_D1_p52 = inverse_D1_p41 + (0.07312640000000001 + inverse_D1_p36) - 0.1501 *
      (2.0 * inverse_D1_p49 + 0.1501 * inverse_D2_p1) - inverse_D1_p50 * inverse_D1_p51;
  const Real inverse_D1_p53 = 0.0070992 - inverse_D1_p39 + c3 * inverse_D1_p40 - 0.4318 *
      (s3 * inverse_D1_p31 + c3 * inverse_D1_p33);
  const Real inverse_D1_p54 = inverse_D1_p53 + 0.1501 *
      (inverse_D1_p44 - (inverse_D1_p43 + (inverse_D1_p15 + inverse_D1_p42) - 0.1501 *
      inverse_D1_p45)) + inverse_D1_p50 * inverse_D1_p47;
  const Real inverse_D1_p55 = 1.4717295504999999 - inverse_D1_p48 - s2 *
      (inverse_D1_p54 * (2.0 * c2) - s2 * (inverse_D1_p48 + inverse_D1_p52));

  // link 1 (link1), articulated inertia
  const Real inverse_D1 = 1.0 / inverse_D1_p55;

  // link 5 (link5), force propagation
  const Real f6_z_p1 = s5 * s6;

  // link 4 (link4), force propagation
  const Real f6_z_p2 = minus_inverse_D3_p2 * f6_z_p1;

  // link 5 (link5), force propagation
  const Real f6_z_p3 = 4.484863585399276 * c6;
  const Real f6_z_p4 = c5 * f6_z_p3;

  // link 4 (link4), force propagation
  const Real f6_z_p5 = s4 * f6_z_p2 - c4 * f6_z_p4;

  // link 5 (link5), force propagation
  const Real f6_z_p6 = s5 * f6_z_p3;
  const Real f6_z_p7 = c5 * s6;

  // link 4 (link4), force propagation
  const Real f6_z_p8 = f6_z_p7 - minus_inverse_D3_p18 * f6_z_p1;
  const Real f6_z_p9 = 0.4331 * f6_z_p5 + 0.0203 * f6_z_p6 - s4 * f6_z_p8;

  // link 3 (link3), force propagation
  const Real f6_z_p10 = f6_z_p6 + inverse_D1_p12 * f6_z_p9;
  const Real f6_z_p11 = f6_z_p5 + inverse_D1_p2 * f6_z_p9;
  const Real f6_z_p12 = c3 * f6_z_p10 - s3 * f6_z_p11;
  const Real f6_z_p13 = 0.4318 * f6_z_p12;

  // link 4 (link4), force propagation
  const Real f6_z_p14 = c4 * f6_z_p2 + s4 * f6_z_p4;

  // link 2 (link2), force propagation
  const Real f6_z_p15 = 0.4318 * (f6_z_p14 - inverse_D1_p25 * f6_z_p9) + 0.1501 *
      (s3 * f6_z_p10 + c3 * f6_z_p11);

  // link 3 (link3), force propagation
  const Real f6_z_p16 = 0.0203 * f6_z_p14 - inverse_D1_p37 * f6_z_p9;
  const Real f6_z_p17 = 0.4331 * f6_z_p14 - c4 * f6_z_p8 - inverse_D1_p35 * f6_z_p9;

  // link 2 (link2), force propagation
  const Real f6_z_p18 = s2 * (0.1501 * f6_z_p12 + s3 * f6_z_p16 + c3 * f6_z_p17 - inverse_D1_p51 *
      f6_z_p13);
  const Real f6_z_p19 = c2 * (f6_z_p15 - c3 * f6_z_p16 + s3 * f6_z_p17 - inverse_D1_p47 *
      f6_z_p13) + f6_z_p18;

  // link 1 (link1), force propagation
  const Real f6_z_p20 = inverse_D1 * f6_z_p19;

  // link 5 (link5), force propagation
  const Real f6_z_p21 = c5 * c6;

  // link 4 (link4), force propagation
  const Real f6_z_p22 = s4 * s6 - c4 * f6_z_p21;

  // link 5 (link5), force propagation
  const Real f6_z_p23 = s5 * c6;

  // link 4 (link4), force propagation
  const Real f6_z_p24 = 0.4331 * f6_z_p22 + 0.0203 * f6_z_p23;

  // link 3 (link3), force propagation
  const Real f6_z_p25 = f6_z_p23 + inverse_D1_p12 * f6_z_p24;
  const Real f6_z_p26 = f6_z_p22 + inverse_D1_p2 * f6_z_p24;
  const Real f6_z_p27 = c3 * f6_z_p25 - s3 * f6_z_p26;
  const Real f6_z_p28 = 0.4318 * f6_z_p27;

  // link 4 (link4), force propagation
  const Real f6_z_p29 = c4 * s6 + s4 * f6_z_p21;

  // link 2 (link2), force propagation
  const Real f6_z_p30 = 0.4318 * (f6_z_p29 - inverse_D1_p25 * f6_z_p24) + 0.1501 *
      (s3 * f6_z_p25 + c3 * f6_z_p26);

  // link 3 (link3), force propagation
  const Real f6_z_p31 = 0.0203 * f6_z_p29 - inverse_D1_p37 * f6_z_p24;
  const Real f6_z_p32 = 0.4331 * f6_z_p29 - inverse_D1_p35 * f6_z_p24;

  // link 2 (link2), force propagation
  const Real f6_z_p33 = s2 * (0.1501 * f6_z_p27 + s3 * f6_z_p31 + c3 * f6_z_p32 - inverse_D1_p51 *
      f6_z_p28);
  const Real f6_z_p34 = c2 * (f6_z_p30 - c3 * f6_z_p31 + s3 * f6_z_p32 - inverse_D1_p47 *
      f6_z_p28) + f6_z_p33;
  const Real f6_z_p35 = inverse_D2 * f6_z_p13;

  // link 3 (link3), force propagation
  const Real f6_z_p36 = minus_inverse_D3 * f6_z_p9;

  // link 1 (link1), force propagation
  const Real f6_z_p37 = f6_z_p24 * f6_z_p36 - f6_z_p28 * f6_z_p35 - f6_z_p34 * f6_z_p20;
  const Real f6_z_p38 = f6_z_p24 * (minus_inverse_D3 * f6_z_p24) - f6_z_p28 *
      (inverse_D2 * f6_z_p28) - f6_z_p34 * (inverse_D1 * f6_z_p34);
  const Real f6_z_p39 = 1.0 / f6_z_p38;
  const Real f6_z_p40 = f6_z_p37 * f6_z_p39;

  // link 4 (link4), force propagation
  const Real f6_z_p41 = s4 * c6 + c4 * f6_z_p7;
  const Real f6_z_p42 = 0.4331 * f6_z_p41 - 0.0203 * f6_z_p1;

  // link 3 (link3), force propagation
  const Real f6_z_p43 = f6_z_p1 - inverse_D1_p12 * f6_z_p42;
  const Real f6_z_p44 = f6_z_p41 + inverse_D1_p2 * f6_z_p42;
  const Real f6_z_p45 = c3 * f6_z_p43 + s3 * f6_z_p44;
  const Real f6_z_p46 = 0.4318 * f6_z_p45;

  // link 4 (link4), force propagation
  const Real f6_z_p47 = c4 * c6 - s4 * f6_z_p7;

  // link 2 (link2), force propagation
  const Real f6_z_p48 = 0.4318 * (f6_z_p47 - inverse_D1_p25 * f6_z_p42) - 0.1501 *
      (s3 * f6_z_p43 - c3 * f6_z_p44);

  // link 3 (link3), force propagation
  const Real f6_z_p49 = 0.0203 * f6_z_p47 - inverse_D1_p37 * f6_z_p42;
  const Real f6_z_p50 = 0.4331 * f6_z_p47 - inverse_D1_p35 * f6_z_p42;

  // link 2 (link2), force propagation
  const Real f6_z_p51 = s2 * (0.1501 * f6_z_p45 - s3 * f6_z_p49 - c3 * f6_z_p50 - inverse_D1_p51 *
      f6_z_p46);
  const Real f6_z_p52 = c2 * (f6_z_p48 - c3 * f6_z_p49 + s3 * f6_z_p50 + inverse_D1_p47 *
      f6_z_p46) - f6_z_p51;

  // link 1 (link1), force propagation
  const Real f6_z_p53 = inverse_D1 * f6_z_p52;

  // link 2 (link2), force propagation
  const Real f6_z_p54 = inverse_D2 * f6_z_p46;

  // link 3 (link3), force propagation
  const Real f6_z_p55 = minus_inverse_D3 * f6_z_p42;

  // link 1 (link1), force propagation
  const Real f6_z_p56 = f6_z_p24 * f6_z_p55 + f6_z_p28 * f6_z_p54 - f6_z_p34 * f6_z_p53;
  const Real f6_z_p57 = f6_z_p42 * f6_z_p36 + f6_z_p46 * f6_z_p35 - f6_z_p52 * f6_z_p20 - f6_z_p56 *
      f6_z_p40;
  const Real f6_z_p58 = f6_z_p56 * f6_z_p39;
  const Real f6_z_p59 = 1.0 / (f6_z_p42 * f6_z_p55 - f6_z_p46 * f6_z_p54 - f6_z_p52 * f6_z_p53 -
      f6_z_p56 * f6_z_p58);
  const Real f6_z_p60 = f6_z_p57 * f6_z_p59;

  // link 4 (link4), force propagation
  const Real f6_z_p61 = c4 * s5;
  const Real f6_z_p62 = 0.4331 * f6_z_p61 + 0.0203 * c5;

  // link 3 (link3), force propagation
  const Real f6_z_p63 = c5 + inverse_D1_p12 * f6_z_p62;
  const Real f6_z_p64 = f6_z_p61 + inverse_D1_p2 * f6_z_p62;
  const Real f6_z_p65 = c3 * f6_z_p63 - s3 * f6_z_p64;
  const Real f6_z_p66 = 0.4318 * f6_z_p65;

  // link 4 (link4), force propagation
  const Real f6_z_p67 = s4 * s5;

  // link 2 (link2), force propagation
  const Real f6_z_p68 = 0.4318 * (f6_z_p67 + inverse_D1_p25 * f6_z_p62) - 0.1501 *
      (s3 * f6_z_p63 + c3 * f6_z_p64);

  // link 3 (link3), force propagation
  const Real f6_z_p69 = 0.0203 * f6_z_p67 + inverse_D1_p37 * f6_z_p62;
  const Real f6_z_p70 = 0.4331 * f6_z_p67 + inverse_D1_p35 * f6_z_p62;

  // link 2 (link2), force propagation
  const Real f6_z_p71 = s2 * (0.1501 * f6_z_p65 - s3 * f6_z_p69 - c3 * f6_z_p70 - inverse_D1_p51 *
      f6_z_p66);
  const Real f6_z_p72 = c2 * (f6_z_p68 - c3 * f6_z_p69 + s3 * f6_z_p70 + inverse_D1_p47 *
      f6_z_p66) - f6_z_p71;

  // link 1 (link1), force propagation
  const Real f6_z_p73 = inverse_D1 * f6_z_p72;

  // link 2 (link2), force propagation
  const Real f6_z_p74 = inverse_D2 * f6_z_p66;

  // link 3 (link3), force propagation
  const Real f6_z_p75 = minus_inverse_D3 * f6_z_p62;

  // link 1 (link1), force propagation
  const Real f6_z_p76 = f6_z_p24 * f6_z_p75 - f6_z_p28 * f6_z_p74 + f6_z_p34 * f6_z_p73;
  const Real f6_z_p77 = f6_z_p76 * f6_z_p39;
  const Real f6_z_p78 = f6_z_p42 * f6_z_p75 + f6_z_p46 * f6_z_p74 + f6_z_p52 * f6_z_p73 - f6_z_p56 *
      f6_z_p77;
  const Real f6_z_p79 = f6_z_p62 * f6_z_p36 - f6_z_p66 * f6_z_p35 + f6_z_p72 * f6_z_p20 - f6_z_p76 *
      f6_z_p40 - f6_z_p78 * f6_z_p60;
  const Real f6_z_p80 = f6_z_p78 * f6_z_p59;
  const Real f6_z_p81 = f6_z_p62 * f6_z_p75 - f6_z_p66 * f6_z_p74 - f6_z_p72 * f6_z_p73 - f6_z_p76 *
      f6_z_p77 - f6_z_p78 * f6_z_p80;
  const Real f6_z_p82 = 1.0 / f6_z_p81;
  const Real f6_z_p83 = f6_z_p79 * f6_z_p82;

  // link 4 (link4), force propagation
  const Real f6_z_p84 = minus_inverse_D3_p2 * f6_z_p23;

  // link 5 (link5), force propagation
  const Real f6_z_p85 = 4.484863585399276 * s6;
  const Real f6_z_p86 = c5 * f6_z_p85;

  // link 4 (link4), force propagation
  const Real f6_z_p87 = s4 * f6_z_p84 + c4 * f6_z_p86;

  // link 5 (link5), force propagation
  const Real f6_z_p88 = s5 * f6_z_p85;

  // link 4 (link4), force propagation
  const Real f6_z_p89 = f6_z_p21 - minus_inverse_D3_p18 * f6_z_p23;
  const Real f6_z_p90 = 0.4331 * f6_z_p87 - 0.0203 * f6_z_p88 - s4 * f6_z_p89;

  // link 3 (link3), force propagation
  const Real f6_z_p91 = f6_z_p88 - inverse_D1_p12 * f6_z_p90;
  const Real f6_z_p92 = f6_z_p87 + inverse_D1_p2 * f6_z_p90;
  const Real f6_z_p93 = c3 * f6_z_p91 + s3 * f6_z_p92;
  const Real f6_z_p94 = 0.4318 * f6_z_p93;

  // link 4 (link4), force propagation
  const Real f6_z_p95 = c4 * f6_z_p84 - s4 * f6_z_p86;

  // link 2 (link2), force propagation
  const Real f6_z_p96 = 0.4318 * (f6_z_p95 - inverse_D1_p25 * f6_z_p90) - 0.1501 *
      (s3 * f6_z_p91 - c3 * f6_z_p92);

  // link 3 (link3), force propagation
  const Real f6_z_p97 = 0.0203 * f6_z_p95 - inverse_D1_p37 * f6_z_p90;
  const Real f6_z_p98 = 0.4331 * f6_z_p95 - c4 * f6_z_p89 - inverse_D1_p35 * f6_z_p90;

  // link 2 (link2), force propagation
  const Real f6_z_p99 = s2 * (0.1501 * f6_z_p93 - s3 * f6_z_p97 - c3 * f6_z_p98 - inverse_D1_p51 *
      f6_z_p94);
  const Real f6_z_p100 = c2 * (f6_z_p96 - c3 * f6_z_p97 + s3 * f6_z_p98 + inverse_D1_p47 *
      f6_z_p94) - f6_z_p99;

  // link 1 (link1), force propagation
  const Real f6_z_p101 = inverse_D1 * f6_z_p100;

  // link 2 (link2), force propagation
  const Real f6_z_p102 = inverse_D2 * f6_z_p94;

  // link 3 (link3), force propagation
  const Real f6_z_p103 = minus_inverse_D3 * f6_z_p90;

  // link 1 (link1), force propagation
  const Real f6_z_p104 = f6_z_p24 * f6_z_p103 + f6_z_p28 * f6_z_p102 - f6_z_p34 * f6_z_p101;
  const Real f6_z_p105 = f6_z_p104 * f6_z_p39;
  const Real f6_z_p106 = f6_z_p42 * f6_z_p103 - f6_z_p46 * f6_z_p102 - f6_z_p52 * f6_z_p101 -
      f6_z_p56 * f6_z_p105;
  const Real f6_z_p107 = f6_z_p106 * f6_z_p59;
  const Real f6_z_p108 = f6_z_p62 * f6_z_p103 + f6_z_p66 * f6_z_p102 + f6_z_p72 * f6_z_p101 -
      f6_z_p76 * f6_z_p105 - f6_z_p78 * f6_z_p107;

  // link 4 (link4), force propagation
  const Real f6_z_p109 = inverse_D4 * f6_z_p1;

  // link 5 (link5), force propagation
  const Real f6_z_p110 = 1557.24430048586 * c6;

  // link 1 (link1), force propagation
  const Real f6_z_p111 = s6 * f6_z_p110 - f6_z_p23 * f6_z_p109 + f6_z_p90 * f6_z_p36 + f6_z_p94 *
      f6_z_p35 - f6_z_p100 * f6_z_p20;
  const Real f6_z_p112 = f6_z_p111 - f6_z_p104 * f6_z_p40 - f6_z_p106 * f6_z_p60 - f6_z_p108 *
      f6_z_p83;
  const Real f6_z_p113 = f6_z_p108 * f6_z_p82;
  const Real f6_z_p114 = s6 * (1557.24430048586 * s6) + f6_z_p23 * (inverse_D4 * f6_z_p23) -
      f6_z_p90 * f6_z_p103 + f6_z_p94 * f6_z_p102;
  const Real f6_z_p115 = f6_z_p114 + f6_z_p100 * f6_z_p101 + f6_z_p104 * f6_z_p105 + f6_z_p106 *
      f6_z_p107 + f6_z_p108 * f6_z_p113;
  const Real f6_z_p116 = 1.0 / f6_z_p115;
  const Real f6_z_p117 = f6_z_p112 * f6_z_p116;
  const Real f6_z_p118 = c6 * f6_z_p110 + f6_z_p1 * f6_z_p109 - f6_z_p9 * f6_z_p36 + f6_z_p13 *
      f6_z_p35 + f6_z_p19 * f6_z_p20;
  const Real f6_z_p119 = f6_z_p118 + f6_z_p37 * f6_z_p40 + f6_z_p57 * f6_z_p60 + f6_z_p79 *
      f6_z_p83 - f6_z_p112 * f6_z_p117;

  // link 2 (link2), outward
  const Real minus_wd2_y_p1 = qdd_0[0] * c2;
  const Real minus_w2_x = qd[0] * s2;
  const Real minus_wd2_y_p2 = qd[1] * minus_w2_x;
  const Real minus_wd2_y = minus_wd2_y_p1 - minus_wd2_y_p2;
  const Real minus_wd2_x_p1 = qdd_0[0] * s2;
  const Real minus_w2_y = qd[0] * c2;
  const Real minus_wd2_x_p2 = qd[1] * minus_w2_y;
  const Real minus_wd2_x = minus_wd2_x_p1 + minus_wd2_x_p2;

  // link 3 (link3), outward
  const Real minus_w3_x = s3 * minus_w2_y + c3 * minus_w2_x;
  const Real minus_wd3_y = c3 * minus_wd2_y - s3 * minus_wd2_x - qd[2] * minus_w3_x;

  // link 4 (link4), outward
  const Real wd4_z = qdd_0[3] + minus_wd3_y;

  // link 3 (link3), outward
  const Real minus_w3_y = c3 * minus_w2_y - s3 * minus_w2_x;
  const Real minus_wd3_x = s3 * minus_wd2_y + c3 * minus_wd2_x + qd[2] * minus_w3_y;
  const Real wd3_z = qdd_0[1] + qdd_0[2];
  const Real w3_z = qd[1] + qd[2];

  // link 4 (link4), outward
  const Real w4_y = c4 * w3_z + s4 * minus_w3_x;
  const Real wd4_x = s4 * wd3_z - c4 * minus_wd3_x + qd[3] * w4_y;
  const Real w4_z = qd[3] + minus_w3_y;
  const Real w4_x = s4 * w3_z - c4 * minus_w3_x;

  // link 5 (link5), outward
  const Real minus_w5_y = c5 * w4_z + s5 * w4_x;
  const Real minus_wd5_x = s5 * wd4_z - c5 * wd4_x + qd[4] * minus_w5_y;

  // link 4 (link4), outward
  const Real wd4_y = c4 * wd3_z + s4 * minus_wd3_x - qd[3] * w4_x;

  // link 5 (link5), outward
  const Real wd5_z = qdd_0[4] + wd4_y;
  const Real minus_w5_x = s5 * w4_z - c5 * w4_x;
  const Real w5_z = qd[4] + w4_y;

  // link 6 (link6), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_x;
  const Real wd6_y = c6 * wd5_z + s6 * minus_wd5_x - qd[5] * w6_x;
  const Real w6_z = qd[5] + minus_w5_y;
  const Real f6_z_p120 = w6_x * w6_z;
  const Real f6_z_p121 = xdd_cmd[4] * s1 + xdd_cmd[3] * c1;
  const Real f6_z_p122 = xdd_cmd[5] * c2 + s2 * f6_z_p121;
  const Real f6_z_p123 = xdd_cmd[5] * s2 - c2 * f6_z_p121;
  const Real f6_z_p124 = s3 * f6_z_p122 + c3 * f6_z_p123;
  const Real f6_z_p125 = xdd_cmd[4] * c1 - xdd_cmd[3] * s1;
  const Real f6_z_p126 = c4 * f6_z_p125 + s4 * f6_z_p124;
  const Real f6_z_p127 = c3 * f6_z_p122 - s3 * f6_z_p123;
  const Real f6_z_p128 = s4 * f6_z_p125 - c4 * f6_z_p124;
  const Real f6_z_p129 = s5 * f6_z_p127 - c5 * f6_z_p128;
  const Real f6_z_p130 = wd6_y - c6 * f6_z_p126 - s6 * f6_z_p129;

  // link 2 (link2), outward
  const Real minus_a3_z_p1 = minus_w2_x * minus_w2_x;
  const Real minus_a3_z_p2 = minus_w2_y * minus_w2_y;
  const Real minus_a3_z_p3 = minus_wd2_y_p2 - minus_wd2_y;

  // link 3 (link3), outward
  const Real minus_a3_z = 0.1501 * (minus_a3_z_p1 + minus_a3_z_p2) + 0.4318 * minus_a3_z_p3;
  const Real minus_a4_x_p1 = minus_wd3_x + minus_w3_y * w3_z;
  const Real minus_a4_x_p2 = minus_w3_x * w3_z;
  const Real minus_a4_x_p3 = minus_wd3_y - minus_a4_x_p2;

  // link 4 (link4), outward
  const Real minus_a4_x_p4 = minus_a3_z - 0.4331 * minus_a4_x_p1 + 0.0203 * minus_a4_x_p3;

  // link 2 (link2), outward
  const Real minus_a3_x_p1 = minus_w2_x * minus_w2_y;
  const Real minus_a3_x_p2 = qdd_0[1] + minus_a3_x_p1;

  // link 3 (link3), outward
  const Real minus_a3_x_p3 = 9.81 * c2 - 0.1501 * minus_wd2_x_p1 - 0.4318 * minus_a3_x_p2;

  // link 2 (link2), outward
  const Real minus_a3_x_p4 = qd[1] * qd[1];

  // link 3 (link3), outward
  const Real minus_a3_x_p5 = 9.81 * s2 + 0.1501 * minus_wd2_y_p1 + 0.4318 *
      (minus_a3_z_p2 + minus_a3_x_p4);
  const Real minus_a3_x = s3 * minus_a3_x_p3 + c3 * minus_a3_x_p5;
  const Real minus_a4_x_p5 = minus_w3_x * minus_w3_y;
  const Real minus_a4_x_p6 = wd3_z - minus_a4_x_p5;
  const Real minus_a4_x_p7 = minus_w3_y * minus_w3_y;
  const Real minus_a4_x_p8 = w3_z * w3_z;

  // link 4 (link4), outward
  const Real minus_a4_x_p9 = minus_a4_x_p7 + minus_a4_x_p8;
  const Real minus_a4_x_p10 = minus_a3_x - 0.4331 * minus_a4_x_p6 - 0.0203 * minus_a4_x_p9;
  const Real minus_a4_x = s4 * minus_a4_x_p4 + c4 * minus_a4_x_p10;

  // link 3 (link3), outward
  const Real minus_a3_y = c3 * minus_a3_x_p3 - s3 * minus_a3_x_p5;
  const Real a4_z_p1 = minus_w3_x * minus_w3_x;

  // link 4 (link4), outward
  const Real a4_z_p2 = a4_z_p1 + minus_a4_x_p8;

  // link 3 (link3), outward
  const Real a4_z_p3 = wd3_z + minus_a4_x_p5;

  // link 4 (link4), outward
  const Real a4_z = minus_a3_y - 0.4331 * a4_z_p2 + 0.0203 * a4_z_p3;

  // link 5 (link5), outward
  const Real minus_a5_x = s5 * a4_z + c5 * minus_a4_x;

  // link 6 (link6), outward
  const Real f6_z_p131 = xdd_cmd[1] * s1 + xdd_cmd[0] * c1;
  const Real f6_z_p132 = 9.81 + xdd_cmd[2];
  const Real f6_z_p133 = c2 * f6_z_p132 + s2 * f6_z_p131;
  const Real f6_z_p134 = s2 * f6_z_p132 - c2 * f6_z_p131;
  const Real f6_z_p135 = c3 * f6_z_p133 - s3 * f6_z_p134;
  const Real f6_z_p136 = s3 * f6_z_p133 + c3 * f6_z_p134;
  const Real f6_z_p137 = xdd_cmd[1] * c1 - xdd_cmd[0] * s1;
  const Real f6_z_p138 = s4 * f6_z_p137 - c4 * f6_z_p136;
  const Real f6_z_p139 = minus_a5_x - (s5 * f6_z_p135 - c5 * f6_z_p138);

  // link 4 (link4), outward
  const Real minus_a4_y = c4 * minus_a4_x_p4 - s4 * minus_a4_x_p10;

  // link 6 (link6), outward
  const Real f6_z_p140 = minus_a4_y + (c4 * f6_z_p137 + s4 * f6_z_p136);
  const Real f6_z_p141 = s6 * f6_z_p140 + (c6 * f6_z_p139 - 0.05625 *
      (wd6_y + f6_z_p120 - f6_z_p130));
  const Real w6_y = c6 * w5_z + s6 * minus_w5_x;
  const Real wd6_x = s6 * wd5_z - c6 * minus_wd5_x + qd[5] * w6_y;
  const Real f6_z_p142 = w6_y * w6_z;
  const Real f6_z_p143 = wd6_x - s6 * f6_z_p126 + c6 * f6_z_p129;

  // link 1 (link1), force propagation
  const Real f6_z_p144 = c6 * f6_z_p140 - (s6 * f6_z_p139 -
      (0.05625 * (wd6_x - f6_z_p142 - f6_z_p143) - f6_z_p141 * f6_z_p58));
  const Real f6_z_p145 = 0.05625 * (w6_x * w6_x + w6_y * w6_y) + f6_z_p141 * f6_z_p77 + f6_z_p80 *
      f6_z_p144;
  const Real f6_z_p146 = c5 * (a4_z - f6_z_p135) - (s5 * (minus_a4_x + f6_z_p138) + f6_z_p145);
  const Real f6_z_p147 = f6_z_p143 + f6_z_p141 * f6_z_p105 + f6_z_p107 * f6_z_p144 + f6_z_p113 *
      f6_z_p146;
  const Real f6_z_p148 = f6_z_p130 - f6_z_p141 * f6_z_p40 - f6_z_p60 * f6_z_p144 - f6_z_p83 *
      f6_z_p146 - f6_z_p117 * f6_z_p147;
  const Real f6_z_p149 = 1.0 / f6_z_p119 * f6_z_p148;
  const Real f6_z_p150 = f6_z_p116 * f6_z_p147 - f6_z_p117 * f6_z_p149;
  const Real f6_z = f6_z_p82 * f6_z_p146 - f6_z_p113 * f6_z_p150 + f6_z_p83 * f6_z_p149;
  const Real minus_f6_y = f6_z_p59 * f6_z_p144 - f6_z_p80 * f6_z - f6_z_p107 * f6_z_p150 +
      f6_z_p60 * f6_z_p149;
  const Real minus_f6_x = f6_z_p141 * f6_z_p39 - f6_z_p58 * minus_f6_y - f6_z_p77 * f6_z -
      f6_z_p105 * f6_z_p150 + f6_z_p40 * f6_z_p149;

  // link 5 (link5), outward
  const Real f5_z_p1 = minus_wd5_x + minus_w5_y * w5_z;

  // link 6 (link6), inward
  const Real f5_z = 0.0028799999999999997 * f5_z_p1 - c6 * minus_f6_y - s6 * minus_f6_x;

  // link 5 (link5), outward
  const Real f5_x_p1 = minus_w5_x * minus_w5_y;

  // link 6 (link6), inward
  const Real f5_x = 0.0028799999999999997 * (wd5_z - f5_x_p1) + s6 * minus_f6_y - c6 * minus_f6_x;
  const Real minus_f5_y = f6_z - 0.0028799999999999997 * (minus_w5_x * minus_w5_x + w5_z * w5_z);

  // link 5 (link5), inward
  const Real f4_x = s5 * minus_f5_y + c5 * f5_x;

  // link 4 (link4), inward
  const Real f3_z_p1 = c4 * f5_z + s4 * f4_x;
  const Real f3_z = f3_z_p1 + (0.861795 * minus_a4_x_p1 - 0.025374999999999998 * minus_a4_x_p3);

  // link 2 (link2), outward
  const Real n2_y_p1 = minus_wd2_x_p2 + minus_wd2_x;

  // link 3 (link3), inward
  const Real n2_y_p2 = 0.690314699 * (minus_a3_z_p1 - minus_a3_x_p4) + 0.0070992 * n2_y_p1 -
      0.023750999999999998 * (qdd_0[1] - minus_a3_x_p1) + 1.674987602 * minus_a3_z_p3;

  // link 4 (link4), inward
  const Real minus_f3_x_p1 = s4 * f5_z - c4 * f4_x;
  const Real minus_f3_x = minus_f3_x_p1 - (0.861795 * minus_a4_x_p6 + 0.025374999999999998 *
      minus_a4_x_p9);

  // link 5 (link5), inward
  const Real f4_z = c5 * minus_f5_y - s5 * f5_x;

  // link 4 (link4), inward
  const Real minus_f3_y = f4_z - (0.861795 * a4_z_p2 - 0.025374999999999998 * a4_z_p3);

  // link 6 (link6), inertial wrench
  const Real minus_n6_y = f6_z_p149 - 2e-05 * (wd6_y - f6_z_p120);
  const Real minus_n6_x = f6_z_p150 - 2e-05 * (wd6_x + f6_z_p142);

  // link 6 (link6), inward
  const Real minus_n5_x = 0.00042216 * f5_z_p1 - 0.0028799999999999997 * minus_a4_y - s6 *
      minus_n6_y + c6 * minus_n6_x;

  // link 5 (link5), outward
  const Real minus_wd5_y = c5 * wd4_z + s5 * wd4_x - qd[4] * minus_w5_x;

  // link 6 (link6), outward
  const Real wd6_z = qdd_0[5] + minus_wd5_y;

  // link 6 (link6), inertial wrench
  const Real n6_z = 4e-05 * (wd6_z - (wd6_z - c5 * f6_z_p127 - s5 * f6_z_p128));
  tau[5] = n6_z;

  // link 6 (link6), inward
  const Real minus_n5_y = n6_z + 2e-04 * (minus_wd5_y - minus_w5_x * w5_z);

  // link 5 (link5), inward
  const Real n4_z = 0.0013999999999999998 * wd4_z - w4_y * (9.999999999999994e-05 * w4_x) + c5 *
      minus_n5_y + s5 * minus_n5_x;
  tau[3] = n4_z;

  // link 4 (link4), inward
  const Real minus_n3_y_p1 = n4_z - (0.010673638499999999 * minus_a4_x_p1 + 0.004704000000000001 *
      minus_a4_x_p6 - 0.0067651125 * minus_a4_x_p3 - 0.025374999999999998 * minus_a3_z);
  const Real minus_n3_y = minus_n3_y_p1 - 0.0203 * f3_z_p1;

  // link 3 (link3), inward
  const Real n2_y_p3 = n2_y_p2 - 0.4318 * f3_z + 0.1501 * (s3 * minus_f3_y - c3 * minus_f3_x) - c3 *
      minus_n3_y;

  // link 4 (link4), inward
  const Real n3_x_p1 = 0.004704000000000001 * (minus_a4_x_p7 - minus_a4_x_p8) +
      0.010673638499999999 * minus_a4_x_p3 - 0.3056901365 * minus_a4_x_p1 + 0.861795 * minus_a3_z;

  // link 6 (link6), inward
  const Real n5_z = 0.00062216 * wd5_z - 0.00022215999999999997 * f5_x_p1 - 0.0028799999999999997 *
      minus_a5_x - c6 * minus_n6_y - s6 * minus_n6_x;
  tau[4] = n5_z;

  // link 5 (link5), inward
  const Real n4_y = n5_z + 0.00065 * (wd4_y - w4_x * w4_z);
  const Real n4_x = 0.0007499999999999999 * (wd4_x + w4_y * w4_z) + s5 * minus_n5_y - c5 *
      minus_n5_x;

  // link 4 (link4), inward
  const Real n3_x = n3_x_p1 - 0.4331 * f3_z_p1 - s4 * n4_y + c4 * n4_x;

  // link 3 (link3), inward
  const Real n2_y = n2_y_p3 + s3 * n3_x;
  const Real minus_n2_x_p1 = c3 * minus_f3_y + s3 * minus_f3_x;
  const Real minus_n2_x_p2 = 0.023750999999999998 * (minus_a3_z_p2 - minus_a3_x_p4) + 0.690314699 *
      minus_a3_x_p2 + 0.0070992 * minus_a3_z_p3 + 0.07312640000000001 * n2_y_p1;
  const Real minus_n2_x = minus_n2_x_p2 - 0.1501 * minus_n2_x_p1 - s3 * minus_n3_y - c3 * n3_x;

  // link 2 (link2), inward
  const Real n1_z = 1.4717295504999999 * qdd_0[0] - c2 * n2_y + s2 * minus_n2_x;
  tau[0] = n1_z;

  // link 4 (link4), inward
  const Real minus_n3_z_p1 = 0.010673638499999999 * (a4_z_p1 - minus_a4_x_p7) +
      0.004704000000000001 * (minus_wd3_y + minus_a4_x_p2) - 0.312455249 * wd3_z + 0.298925024 *
      minus_a4_x_p5;
  const Real minus_n3_z_p2 = minus_n3_z_p1 + 0.861795 * minus_a3_x - 0.025374999999999998 *
      minus_a3_y + 0.4331 * minus_f3_x_p1 - 0.0203 * f4_z;
  const Real minus_n3_z = minus_n3_z_p2 - c4 * n4_y - s4 * n4_x;
  tau[2] = -minus_n3_z;

  // link 3 (link3), inward
  const Real minus_n2_z_p1 = 0.0070992 * (minus_a3_z_p1 - minus_a3_z_p2) - 0.023750999999999998 *
      minus_wd2_y_p1 - 0.690314699 * minus_wd2_x_p1 - 1.7481140020000001 * qdd_0[1];
  const Real minus_n2_z = minus_n3_z + (minus_n2_z_p1 - 1.601861202 * minus_a3_x_p1 - 1.024164 *
      s2 + 37.2347379 * c2) + 0.4318 * minus_n2_x_p1;
  tau[1] = -minus_n2_z;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
