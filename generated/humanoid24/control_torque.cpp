// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at link origins.
// 8937 flops (add 3961, mul 4932, div 44), sine and cosine of 24 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

void control_torque(const Real (&TREELINE_RESTRICT q)[24], const Real (&TREELINE_RESTRICT qd)[24],
    const Real (&TREELINE_RESTRICT qdd_0)[24], const Real (&TREELINE_RESTRICT xdd_cmd)[12],
    Real (&TREELINE_RESTRICT tau)[24]) noexcept {
  const Real angles[24] = {q[0], q[1], q[2], q[3], q[4], q[5], q[6], q[7], q[8], q[9], q[10], q[11],
      q[12], q[13], q[14], q[15], q[16], q[17], q[18], q[19], q[20], q[21], q[22], q[23]};
  Real sines[24];
  Real cosines[24];
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
  const Real s7 = sines[6];
  const Real c7 = cosines[6];
  const Real s8 = sines[7];
  const Real c8 = cosines[7];
  const Real s9 = sines[8];
  const Real c9 = cosines[8];
  const Real s10 = sines[9];
  const Real c10 = cosines[9];
  const Real s11 = sines[10];
  const Real c11 = cosines[10];
  const Real s12 = sines[11];
  const Real c12 = cosines[11];
  const Real s13 = sines[12];
  const Real c13 = cosines[12];
  const Real s14 = sines[13];
  const Real c14 = cosines[13];
  const Real s15 = sines[14];
  const Real c15 = cosines[14];
  const Real s16 = sines[15];
  const Real c16 = cosines[15];
  const Real s17 = sines[16];
  const Real c17 = cosines[16];
  const Real s18 = sines[17];
  const Real c18 = cosines[17];
  const Real s19 = sines[18];
  const Real c19 = cosines[18];
  const Real s20 = sines[19];
  const Real c20 = cosines[19];
  const Real s21 = sines[20];
  const Real c21 = cosines[20];
  const Real s22 = sines[21];
  const Real c22 = cosines[21];
  const Real s23 = sines[22];
  const Real c23 = cosines[22];
  const Real s24 = sines[23];
  const Real c24 = cosines[23];

  // link 20 (right_hand), articulated inertia
  const Real inverse_D5_p1 = 0.0006000000000000001 + 0.01626499875 * c20 - 0.002865001425 * s20;
  const Real minus_inverse_D19_p1 = 0.0002628975791811551 * c20 + 0.0007660844555829042 * s20;
  const Real minus_inverse_D19_p2 = s20 * minus_inverse_D19_p1;

  // link 19 (right_wrist2), articulated inertia
  const Real minus_inverse_D19 = 1.0 / (minus_inverse_D19_p2 - 0.0010519177038056625);
  const Real inverse_D5_p2 = inverse_D5_p1 * minus_inverse_D19;

  // link 20 (right_hand), articulated inertia
  const Real inverse_D5_p3 = 0.00013384878959057754 - c20 * minus_inverse_D19_p1;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p4 = 0.01626499875 * s20 + 0.002865001425 * c20 - inverse_D5_p3 *
      inverse_D5_p2;

  // link 20 (right_hand), articulated inertia
  const Real inverse_D5_p5 = 0.001742099791326752 * c20 - 0.001090468517736955 * s20;
  const Real inverse_D5_p6 = c20 * inverse_D5_p5;
  const Real inverse_D5_p7 = 0.0006340258712020409 + inverse_D5_p6;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p8 = inverse_D5_p7 * minus_inverse_D19;

  // link 20 (right_hand), articulated inertia
  const Real inverse_D5_p9 = s20 * inverse_D5_p5;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p10 = 0.00033044389597753786 + inverse_D5_p9 - inverse_D5_p3 *
      inverse_D5_p8;
  const Real inverse_D5_p11 = c19 * inverse_D5_p4 + s19 * inverse_D5_p10;
  const Real inverse_D5_p12 = s19 * inverse_D5_p11;

  // link 20 (right_hand), articulated inertia
  const Real inverse_D5_p13 = 0.000760024621759417 + inverse_D5_p9;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p14 = inverse_D5_p13 * minus_inverse_D19;

  // link 20 (right_hand), articulated inertia
  const Real inverse_D5_p15 = 0.09929187165525127 * c20 + 0.27310176737964387 * s20;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p16 = 0.04964593582762564 - c20 * inverse_D5_p15 - inverse_D5_p7 *
      inverse_D5_p14;
  const Real inverse_D5_p17 = inverse_D5_p1 * inverse_D5_p14;
  const Real inverse_D5_p18 = s19 * inverse_D5_p16 - c19 * inverse_D5_p17;
  const Real inverse_D5_p19 = 0.269 * inverse_D5_p18;
  const Real inverse_D5_p20 = inverse_D5_p12 - inverse_D5_p19;
  const Real inverse_D5_p21 = c19 * inverse_D5_p11;
  const Real inverse_D5_p22 = 0.0002516 - 0.269 * inverse_D5_p21;
  const Real inverse_D18_p1 = inverse_D5_p3 * minus_inverse_D19;
  const Real inverse_D18_p2 = 0.0002742332482227584 + minus_inverse_D19_p2 + inverse_D5_p3 *
      inverse_D18_p1;
  const Real inverse_D18_p3 = s19 * (1.16e-05 - inverse_D18_p2);
  const Real inverse_D18_p4 = s19 * inverse_D18_p3;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D18 = 1.0 / (inverse_D18_p4 + (0.00022920000000000001 + inverse_D18_p2));
  const Real inverse_D5_p23 = inverse_D5_p22 * inverse_D18;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p24 = inverse_D5_p6 - 0.002376125662528793 + inverse_D5_p3 * inverse_D5_p14;
  const Real inverse_D5_p25 = c19 * inverse_D5_p24 + 0.0006000000000000001 * s19;
  const Real inverse_D5_p26 = 0.000144 - c19 * inverse_D18_p3 - 0.269 * inverse_D5_p25;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D5_p27 = 6e-06 + 0.269 * inverse_D5_p20 + inverse_D5_p26 * inverse_D5_p23;
  const Real inverse_D5_p28 = 2.0 * c18;
  const Real inverse_D5_p29 = inverse_D5_p26 * inverse_D18;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p30 = s19 * inverse_D5_p24 - 0.0006000000000000001 * c19;

  // link 20 (right_hand), articulated inertia
  const Real inverse_D5_p31 = s20 * inverse_D5_p15;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p32 = 0.2818466605750157 - inverse_D5_p31 - inverse_D5_p13 * inverse_D5_p14;
  const Real inverse_D5_p33 = inverse_D5_p30 + 0.269 * inverse_D5_p32;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D5_p34 = inverse_D18_p4 - 0.000131 + 0.269 *
      (inverse_D5_p30 + inverse_D5_p33) + inverse_D5_p26 * inverse_D5_p29;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p35 = inverse_D5_p1 * inverse_D5_p2;
  const Real inverse_D5_p36 = 0.008744893195371809 + inverse_D5_p31 - inverse_D5_p7 * inverse_D5_p8;
  const Real inverse_D5_p37 = inverse_D5_p1 * inverse_D5_p8;
  const Real inverse_D5_p38 = inverse_D5_p37 * (2.0 * c19) - s19 *
      (inverse_D5_p35 + inverse_D5_p36);
  const Real inverse_D5_p39 = s19 * inverse_D5_p38;
  const Real inverse_D5_p40 = inverse_D5_p35 + inverse_D5_p39;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D5_p41 = 0.0001098 + 0.07236100000000001 * inverse_D5_p40 - inverse_D5_p22 *
      inverse_D5_p23;
  const Real inverse_D5_p42 = inverse_D5_p27 * inverse_D5_p28 - s18 *
      (inverse_D5_p34 + inverse_D5_p41);
  const Real inverse_D5_p43 = 2.249994685315e-05 - inverse_D5_p27 + c18 * inverse_D5_p42;
  const Real inverse_D5_p44 = s18 * inverse_D5_p42;
  const Real inverse_D5_p45 = inverse_D5_p44 + (0.060888541114265754 + inverse_D5_p41);

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p46 = 0.0001499998887063 / inverse_D5_p45;
  const Real inverse_D5_p47 = inverse_D5_p43 * inverse_D5_p46;
  const Real inverse_D5_p48 = 2.0 * c17;
  const Real inverse_D17 = 1.0 / inverse_D5_p45;
  const Real inverse_D5_p49 = inverse_D5_p43 * inverse_D17;
  const Real inverse_D5_p50 = inverse_D5_p44 - (0.06060754126741261 - inverse_D5_p34) +
      inverse_D5_p43 * inverse_D5_p49;
  const Real inverse_D5_p51 = 2.249996661190239e-08 / inverse_D5_p45;
  const Real inverse_D5_p52 = (0.0001499998887063 + inverse_D5_p47) * inverse_D5_p48 + s17 *
      (inverse_D5_p50 + (0.00028099984685315 - inverse_D5_p51));

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p53 = 0.001 - inverse_D5_p21;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D5_p54 = inverse_D5_p53 * inverse_D18;
  const Real inverse_D5_p55 = 0.269 * inverse_D5_p40 - inverse_D5_p22 * inverse_D5_p54;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p56 = 6e-04 - inverse_D5_p25;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D5_p57 = inverse_D5_p56 * inverse_D18;
  const Real inverse_D5_p58 = inverse_D5_p33 + inverse_D5_p26 * inverse_D5_p57;
  const Real inverse_D5_p59 = inverse_D5_p20 + inverse_D5_p26 * inverse_D5_p54;
  const Real inverse_D5_p60 = inverse_D5_p19 - inverse_D5_p22 * inverse_D5_p57;
  const Real inverse_D5_p61 = c18 * (inverse_D5_p55 + inverse_D5_p58) + s18 *
      (inverse_D5_p59 - inverse_D5_p60);
  const Real inverse_D5_p62 = s18 * inverse_D5_p61;
  const Real inverse_D5_p63 = inverse_D5_p60 + inverse_D5_p62;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p64 = inverse_D5_p63 * inverse_D17;
  const Real inverse_D5_p65 = 0.0014999985000000002 - 0.0001499998887063 * inverse_D5_p64;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D5_p66 = c18 * inverse_D5_p61;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p67 = inverse_D5_p66 - (0.28049749700000004 + inverse_D5_p55) -
      inverse_D5_p43 * inverse_D5_p64;
  const Real inverse_D5_p68 = c17 * inverse_D5_p65 + s17 * inverse_D5_p67;
  const Real inverse_D5_p69 = 0.0007394999671343001 + inverse_D5_p47 - c17 * inverse_D5_p52 -
      0.282 * inverse_D5_p68;
  const Real inverse_D5_p70 = 0.0022500062 - inverse_D5_p68;
  const Real minus_inverse_D16_p1 = s17 * inverse_D5_p52;

  // link 16 (right_upperarm), articulated inertia
  const Real minus_inverse_D16 = 1.0 / (minus_inverse_D16_p1 +
      (inverse_D5_p51 - 0.0030572932027870155));
  const Real inverse_D5_p71 = inverse_D5_p70 * minus_inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p72 = s17 * inverse_D5_p65 - c17 * inverse_D5_p67;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D5_p73 = inverse_D5_p18 - inverse_D5_p53 * inverse_D5_p57;
  const Real inverse_D5_p74 = inverse_D5_p40 - inverse_D5_p53 * inverse_D5_p54;
  const Real inverse_D5_p75 = inverse_D5_p32 + inverse_D5_p56 * inverse_D5_p57;
  const Real inverse_D5_p76 = inverse_D5_p73 * inverse_D5_p28 + s18 *
      (inverse_D5_p74 + inverse_D5_p75);
  const Real inverse_D5_p77 = s18 * inverse_D5_p76;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p78 = inverse_D5_p75 - inverse_D5_p77 + inverse_D5_p63 * inverse_D5_p64;
  const Real inverse_D5_p79 = inverse_D5_p72 - 0.282 * inverse_D5_p78;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D5_p80 = inverse_D5_p79 + inverse_D5_p69 * inverse_D5_p71;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D5_p81 = inverse_D5_p66 + (0.28049749700000004 - inverse_D5_p58);

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p82 = inverse_D5_p81 * inverse_D17;
  const Real inverse_D5_p83 = 0.0001499998887063 * inverse_D5_p82;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p84 = c19 * inverse_D5_p16 + s19 * inverse_D5_p17;
  const Real inverse_D5_p85 = inverse_D5_p10 - inverse_D5_p12;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D5_p86 = inverse_D5_p85 * inverse_D18;
  const Real inverse_D5_p87 = inverse_D5_p21 + (0.001 - inverse_D5_p4) - 0.269 * inverse_D5_p84 -
      inverse_D5_p26 * inverse_D5_p86;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D5_p88 = inverse_D5_p37 - c19 * inverse_D5_p38;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D5_p89 = 6e-04 - 0.269 * inverse_D5_p88 + inverse_D5_p22 * inverse_D5_p86;
  const Real inverse_D5_p90 = 0.0014999985000000002 + c18 * inverse_D5_p89 + s18 * inverse_D5_p87;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p91 = inverse_D5_p90 * inverse_D17;
  const Real inverse_D5_p92 = s18 * inverse_D5_p89 - c18 * inverse_D5_p87 + inverse_D5_p43 *
      inverse_D5_p91;
  const Real inverse_D5_p93 = inverse_D5_p59 - inverse_D5_p62 - inverse_D5_p43 * inverse_D5_p82;
  const Real inverse_D5_p94 = 0.0001499998887063 * inverse_D5_p91;
  const Real inverse_D5_p95 = c17 * (inverse_D5_p83 - inverse_D5_p92) - s17 *
      (inverse_D5_p93 - inverse_D5_p94);
  const Real inverse_D5_p96 = c17 * inverse_D5_p95;
  const Real inverse_D5_p97 = inverse_D5_p92 + inverse_D5_p96;
  const Real inverse_D5_p98 = 0.004500002325 - inverse_D5_p97;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D5_p99 = inverse_D5_p98 * minus_inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p100 = 0.0012089992423205001 - 0.282 * inverse_D5_p97;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D5_p101 = inverse_D5_p84 + inverse_D5_p56 * inverse_D5_p86;
  const Real inverse_D5_p102 = inverse_D5_p88 - inverse_D5_p53 * inverse_D5_p86;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p103 = s18 * inverse_D5_p101 + c18 * inverse_D5_p102 + inverse_D5_p81 *
      inverse_D5_p91;
  const Real inverse_D5_p104 = inverse_D5_p74 - inverse_D5_p77 - inverse_D5_p81 * inverse_D5_p82;
  const Real inverse_D5_p105 = inverse_D5_p36 + inverse_D5_p39 + inverse_D5_p85 * inverse_D5_p86 +
      inverse_D5_p90 * inverse_D5_p91;
  const Real inverse_D5_p106 = inverse_D5_p103 * inverse_D5_p48 + s17 *
      (inverse_D5_p104 + inverse_D5_p105);
  const Real inverse_D5_p107 = s17 * inverse_D5_p106;
  const Real inverse_D5_p108 = inverse_D5_p104 - inverse_D5_p107;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D5_p109 = 0.282 * inverse_D5_p108 + inverse_D5_p100 * inverse_D5_p99;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p110 = c18 * inverse_D5_p101 - s18 * inverse_D5_p102 - inverse_D5_p90 *
      inverse_D5_p64;
  const Real inverse_D5_p111 = inverse_D5_p73 - c18 * inverse_D5_p76 + inverse_D5_p81 *
      inverse_D5_p64;
  const Real inverse_D5_p112 = s17 * inverse_D5_p110 - c17 * inverse_D5_p111;
  const Real inverse_D5_p113 = 0.282 * inverse_D5_p112;
  const Real inverse_D5_p114 = s17 * inverse_D5_p95;
  const Real inverse_D5_p115 = inverse_D5_p113 - (inverse_D5_p93 + inverse_D5_p114);

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D5_p116 = inverse_D5_p115 - inverse_D5_p69 * inverse_D5_p99;
  const Real inverse_D5_p117 = inverse_D5_p113 - inverse_D5_p100 * inverse_D5_p71;
  const Real inverse_D5_p118 = s16 * (inverse_D5_p109 - inverse_D5_p80) + c16 *
      (inverse_D5_p116 + inverse_D5_p117);
  const Real inverse_D5_p119 = c16 * inverse_D5_p118;
  const Real inverse_D5_p120 = inverse_D5_p117 - inverse_D5_p119;
  const Real inverse_D15_p1 = inverse_D5_p100 * minus_inverse_D16;
  const Real inverse_D15_p2 = 4.4999986458742003e-05 + 0.282 * inverse_D5_p115 - inverse_D5_p69 *
      inverse_D15_p1;
  const Real inverse_D15_p3 = 2.0 * s16;
  const Real inverse_D15_p4 = inverse_D5_p69 * minus_inverse_D16;
  const Real inverse_D15_p5 = minus_inverse_D16_p1 + (0.0019585440854647937 - inverse_D5_p50) +
      0.282 * (inverse_D5_p72 + inverse_D5_p79) + inverse_D5_p69 * inverse_D15_p4;
  const Real inverse_D15_p6 = 0.0008177492704690715 + 0.07952399999999998 * inverse_D5_p108 +
      inverse_D5_p100 * inverse_D15_p1;
  const Real inverse_D15_p7 = inverse_D15_p2 * inverse_D15_p3 + c16 *
      (inverse_D15_p5 - inverse_D15_p6);
  const Real inverse_D15_p8 = c16 * inverse_D15_p7;
  const Real inverse_D15_p9 = inverse_D15_p8 + (0.18125194219699997 + inverse_D15_p6);

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D15 = 1.0 / inverse_D15_p9;
  const Real inverse_D5_p121 = inverse_D5_p120 * inverse_D15;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D5_p122 = 1.75e-05 - inverse_D15_p2 + s16 * inverse_D15_p7;
  const Real inverse_D5_p123 = s16 * inverse_D5_p118;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D5_p124 = inverse_D5_p123 - (0.7139200499999999 + inverse_D5_p109) +
      inverse_D5_p122 * inverse_D5_p121;
  const Real inverse_D5_p125 = 0.0017499999999999998 + 0.00010499999999999999 * inverse_D5_p121;
  const Real inverse_D5_p126 = 0.0017499999999999998 + c15 * inverse_D5_p124 - s15 *
      inverse_D5_p125;
  const Real inverse_D14_p1 = inverse_D5_p122 * inverse_D15;
  const Real inverse_D14_p2 = 0.00010499999999999999 * inverse_D14_p1;
  const Real inverse_D14_p3 = 2.0 * c15;
  const Real inverse_D14_p4 = inverse_D15_p8 - (0.18113119219699997 + inverse_D15_p5) +
      inverse_D5_p122 * inverse_D14_p1;
  const Real inverse_D14_p5 = 1.1024999999999998e-08 / inverse_D15_p9;
  const Real inverse_D14_p6 = (5.2499999999999995e-05 + inverse_D14_p2) * inverse_D14_p3 + s15 *
      (0.00012075 - inverse_D14_p5 + inverse_D14_p4);
  const Real inverse_D14_p7 = s15 * inverse_D14_p6;
  const Real inverse_D14_p8 = inverse_D14_p7 + (0.000448 - inverse_D14_p4);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D14 = 1.0 / inverse_D14_p8;
  const Real inverse_D5_p127 = inverse_D5_p126 * inverse_D14;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D5_p128 = 2.6249999999999998e-05 + inverse_D14_p2 - c15 * inverse_D14_p6;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p129 = s15 * inverse_D5_p124 + c15 * inverse_D5_p125 - inverse_D5_p128 *
      inverse_D5_p127;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p130 = inverse_D5_p94 - inverse_D5_p114;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D5_p131 = inverse_D5_p130 * minus_inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p132 = c17 * inverse_D5_p110 + s17 * inverse_D5_p111;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D5_p133 = inverse_D5_p96 + (0.004500002325 - inverse_D5_p83) - 0.282 *
      inverse_D5_p132 - inverse_D5_p69 * inverse_D5_p131;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D5_p134 = inverse_D5_p103 - c17 * inverse_D5_p106;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D5_p135 = 0.0022500062 - 0.282 * inverse_D5_p134 + inverse_D5_p100 *
      inverse_D5_p131;
  const Real inverse_D5_p136 = 0.0017499999999999998 + s16 * inverse_D5_p135 + c16 *
      inverse_D5_p133;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D5_p137 = inverse_D5_p136 * inverse_D15;
  const Real inverse_D5_p138 = c16 * inverse_D5_p135 - s16 * inverse_D5_p133 + inverse_D5_p122 *
      inverse_D5_p137;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D5_p139 = inverse_D5_p123 + (0.7139200499999999 + inverse_D5_p80);

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D5_p140 = inverse_D5_p139 * inverse_D15;
  const Real inverse_D5_p141 = 0.00010499999999999999 * inverse_D5_p140;
  const Real inverse_D5_p142 = inverse_D5_p116 - inverse_D5_p119 - inverse_D5_p122 *
      inverse_D5_p140;
  const Real inverse_D5_p143 = 0.00010499999999999999 * inverse_D5_p137;
  const Real inverse_D5_p144 = c15 * (inverse_D5_p138 - inverse_D5_p141) - s15 *
      (inverse_D5_p143 - inverse_D5_p142);
  const Real inverse_D5_p145 = c15 * inverse_D5_p144;
  const Real inverse_D5_p146 = inverse_D5_p145 - (0.0017499999999999998 - inverse_D5_p141);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p147 = inverse_D5_p146 * inverse_D14;
  const Real inverse_D5_p148 = 2.6249999999999998e-05 * inverse_D5_p147;
  const Real inverse_D5_p149 = 2.6249999999999998e-05 * inverse_D5_p127;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D5_p150 = s15 * inverse_D5_p144;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p151 = inverse_D5_p143 + inverse_D5_p150 - inverse_D5_p128 *
      inverse_D5_p147;
  const Real inverse_D5_p152 = s14 * (inverse_D5_p129 - inverse_D5_p148) - c14 *
      (inverse_D5_p149 + inverse_D5_p151);
  const Real inverse_D5_p153 = c14 * inverse_D5_p152;
  const Real inverse_D5_p154 = inverse_D5_p149 + inverse_D5_p153;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D5_p155 = inverse_D5_p108 + inverse_D5_p98 * inverse_D5_p99;
  const Real inverse_D5_p156 = inverse_D5_p78 - inverse_D5_p70 * inverse_D5_p71;
  const Real inverse_D5_p157 = inverse_D5_p112 - inverse_D5_p98 * inverse_D5_p71;
  const Real inverse_D5_p158 = inverse_D5_p157 * inverse_D15_p3 - c16 *
      (inverse_D5_p155 + inverse_D5_p156);
  const Real inverse_D5_p159 = c16 * inverse_D5_p158;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p160 = inverse_D5_p156 + inverse_D5_p159 + inverse_D5_p120 *
      inverse_D5_p121 + inverse_D5_p126 * inverse_D5_p127;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D5_p161 = inverse_D5_p132 + inverse_D5_p70 * inverse_D5_p131;
  const Real inverse_D5_p162 = inverse_D5_p134 - inverse_D5_p98 * inverse_D5_p131;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D5_p163 = c16 * inverse_D5_p161 + s16 * inverse_D5_p162 + inverse_D5_p136 *
      inverse_D5_p140;
  const Real inverse_D5_p164 = inverse_D5_p155 + inverse_D5_p159 - inverse_D5_p139 *
      inverse_D5_p140;
  const Real inverse_D5_p165 = inverse_D5_p105 - inverse_D5_p107 - inverse_D5_p130 *
      inverse_D5_p131 + inverse_D5_p136 * inverse_D5_p137;
  const Real inverse_D5_p166 = inverse_D5_p163 * inverse_D14_p3 + s15 *
      (inverse_D5_p165 + inverse_D5_p164);
  const Real inverse_D5_p167 = s15 * inverse_D5_p166;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p168 = inverse_D5_p165 - inverse_D5_p167 + inverse_D5_p146 *
      inverse_D5_p147;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D5_p169 = inverse_D5_p157 - s16 * inverse_D5_p158 + inverse_D5_p139 *
      inverse_D5_p121;
  const Real inverse_D5_p170 = s16 * inverse_D5_p161 - c16 * inverse_D5_p162 + inverse_D5_p136 *
      inverse_D5_p121;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p171 = s15 * inverse_D5_p169 - c15 * inverse_D5_p170 - inverse_D5_p126 *
      inverse_D5_p147;
  const Real inverse_D5_p172 = 2.0 * s14;
  const Real inverse_D5_p173 = inverse_D5_p171 * inverse_D5_p172 - c14 *
      (inverse_D5_p160 - inverse_D5_p168);
  const Real inverse_D5_p174 = inverse_D5_p171 - s14 * inverse_D5_p173;
  const Real inverse_D5_p175 = 0.18 * inverse_D5_p174;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D5_p176 = inverse_D5_p142 - inverse_D5_p150;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p177 = inverse_D5_p176 * inverse_D14;
  const Real inverse_D5_p178 = inverse_D5_p163 - c15 * inverse_D5_p166 + inverse_D5_p146 *
      inverse_D5_p177;
  const Real inverse_D5_p179 = c15 * inverse_D5_p169 + s15 * inverse_D5_p170 - inverse_D5_p126 *
      inverse_D5_p177;
  const Real inverse_D5_p180 = s14 * inverse_D5_p178 - c14 * inverse_D5_p179;
  const Real inverse_D5_p181 = 0.226 * inverse_D5_p180;
  const Real inverse_D5_p182 = inverse_D5_p181 - (inverse_D5_p175 -
      (inverse_D5_p151 + inverse_D5_p153));

  // link 13 (left_hand), articulated inertia
  const Real inverse_D5_p183 = 0.0006000000000000001 + 0.01626499875 * c13 + 0.002865001425 * s13;
  const Real inverse_D12_p1 = 0.0002628975791811551 * c13 - 0.0007660844555829042 * s13;
  const Real inverse_D12_p2 = s13 * inverse_D12_p1;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D12 = 1.0 / (0.0010519177038056625 + inverse_D12_p2);
  const Real inverse_D5_p184 = inverse_D5_p183 * inverse_D12;

  // link 13 (left_hand), articulated inertia
  const Real inverse_D5_p185 = 0.00013384878959057754 - c13 * inverse_D12_p1;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p186 = 0.01626499875 * s13 - 0.002865001425 * c13 - inverse_D5_p185 *
      inverse_D5_p184;

  // link 13 (left_hand), articulated inertia
  const Real inverse_D5_p187 = 0.001742099791326752 * c13 + 0.001090468517736955 * s13;
  const Real inverse_D5_p188 = c13 * inverse_D5_p187;
  const Real inverse_D5_p189 = 0.0006340258712020409 + inverse_D5_p188;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p190 = inverse_D5_p189 * inverse_D12;

  // link 13 (left_hand), articulated inertia
  const Real inverse_D5_p191 = s13 * inverse_D5_p187;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p192 = 0.00033044389597753786 - inverse_D5_p191 + inverse_D5_p185 *
      inverse_D5_p190;
  const Real inverse_D5_p193 = c12 * inverse_D5_p186 - s12 * inverse_D5_p192;
  const Real inverse_D5_p194 = s12 * inverse_D5_p193;

  // link 13 (left_hand), articulated inertia
  const Real inverse_D5_p195 = 0.000760024621759417 - inverse_D5_p191;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p196 = inverse_D5_p195 * inverse_D12;

  // link 13 (left_hand), articulated inertia
  const Real inverse_D5_p197 = 0.09929187165525127 * c13 - 0.27310176737964387 * s13;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p198 = 0.04964593582762564 - c13 * inverse_D5_p197 + inverse_D5_p189 *
      inverse_D5_p196;
  const Real inverse_D5_p199 = inverse_D5_p183 * inverse_D5_p196;
  const Real inverse_D5_p200 = s12 * inverse_D5_p198 + c12 * inverse_D5_p199;
  const Real inverse_D5_p201 = 0.269 * inverse_D5_p200;
  const Real inverse_D5_p202 = inverse_D5_p194 + inverse_D5_p201;
  const Real inverse_D5_p203 = c12 * inverse_D5_p193;
  const Real inverse_D5_p204 = 0.0002516 + 0.269 * inverse_D5_p203;
  const Real inverse_D11_p1 = inverse_D5_p185 * inverse_D12;
  const Real inverse_D11_p2 = 0.0002742332482227584 - inverse_D12_p2 - inverse_D5_p185 *
      inverse_D11_p1;
  const Real inverse_D11_p3 = s12 * (1.16e-05 - inverse_D11_p2);
  const Real inverse_D11_p4 = s12 * inverse_D11_p3;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D11 = 1.0 / (inverse_D11_p4 + (0.00022920000000000001 + inverse_D11_p2));
  const Real inverse_D5_p205 = inverse_D5_p204 * inverse_D11;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p206 = 0.002376125662528793 - inverse_D5_p188 + inverse_D5_p185 *
      inverse_D5_p196;
  const Real inverse_D5_p207 = c12 * inverse_D5_p206 - 0.0006000000000000001 * s12;
  const Real inverse_D5_p208 = 0.000144 - c12 * inverse_D11_p3 + 0.269 * inverse_D5_p207;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D5_p209 = 6e-06 - 0.269 * inverse_D5_p202 + inverse_D5_p208 * inverse_D5_p205;
  const Real inverse_D5_p210 = 2.0 * c11;
  const Real inverse_D5_p211 = inverse_D5_p208 * inverse_D11;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p212 = s12 * inverse_D5_p206 + 0.0006000000000000001 * c12;

  // link 13 (left_hand), articulated inertia
  const Real inverse_D5_p213 = s13 * inverse_D5_p197;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p214 = 0.2818466605750157 + inverse_D5_p213 + inverse_D5_p195 *
      inverse_D5_p196;
  const Real inverse_D5_p215 = inverse_D5_p212 - 0.269 * inverse_D5_p214;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D5_p216 = 0.000131 - inverse_D11_p4 + 0.269 *
      (inverse_D5_p212 + inverse_D5_p215) - inverse_D5_p208 * inverse_D5_p211;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p217 = inverse_D5_p183 * inverse_D5_p184;
  const Real inverse_D5_p218 = 0.008744893195371809 - inverse_D5_p213 + inverse_D5_p189 *
      inverse_D5_p190;
  const Real inverse_D5_p219 = inverse_D5_p183 * inverse_D5_p190;
  const Real inverse_D5_p220 = inverse_D5_p219 * (2.0 * c12) - s12 *
      (inverse_D5_p217 - inverse_D5_p218);
  const Real inverse_D5_p221 = s12 * inverse_D5_p220;
  const Real inverse_D5_p222 = inverse_D5_p217 + inverse_D5_p221;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D5_p223 = 0.0001098 - 0.07236100000000001 * inverse_D5_p222 - inverse_D5_p204 *
      inverse_D5_p205;
  const Real inverse_D5_p224 = inverse_D5_p209 * inverse_D5_p210 - s11 *
      (inverse_D5_p216 - inverse_D5_p223);
  const Real inverse_D5_p225 = 2.249994685315e-05 - inverse_D5_p209 + c11 * inverse_D5_p224;
  const Real inverse_D5_p226 = s11 * inverse_D5_p224;
  const Real inverse_D5_p227 = inverse_D5_p226 - (0.060888541114265754 + inverse_D5_p223);

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p228 = 0.0001499998887063 / inverse_D5_p227;
  const Real inverse_D5_p229 = inverse_D5_p225 * inverse_D5_p228;
  const Real inverse_D5_p230 = 2.0 * c10;
  const Real minus_inverse_D10 = 1.0 / inverse_D5_p227;
  const Real inverse_D5_p231 = inverse_D5_p225 * minus_inverse_D10;
  const Real inverse_D5_p232 = inverse_D5_p226 + (0.06060754126741261 + inverse_D5_p216) +
      inverse_D5_p225 * inverse_D5_p231;
  const Real inverse_D5_p233 = 2.249996661190239e-08 / inverse_D5_p227;
  const Real inverse_D5_p234 = (0.0001499998887063 - inverse_D5_p229) * inverse_D5_p230 - s10 *
      (inverse_D5_p232 - (0.00028099984685315 + inverse_D5_p233));

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p235 = 0.001 + inverse_D5_p203;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D5_p236 = inverse_D5_p235 * inverse_D11;
  const Real inverse_D5_p237 = 0.269 * inverse_D5_p222 + inverse_D5_p204 * inverse_D5_p236;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p238 = 6e-04 + inverse_D5_p207;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D5_p239 = inverse_D5_p238 * inverse_D11;
  const Real inverse_D5_p240 = inverse_D5_p215 - inverse_D5_p208 * inverse_D5_p239;
  const Real inverse_D5_p241 = inverse_D5_p202 - inverse_D5_p208 * inverse_D5_p236;
  const Real inverse_D5_p242 = inverse_D5_p201 - inverse_D5_p204 * inverse_D5_p239;
  const Real inverse_D5_p243 = c11 * (inverse_D5_p237 + inverse_D5_p240) - s11 *
      (inverse_D5_p241 + inverse_D5_p242);
  const Real inverse_D5_p244 = s11 * inverse_D5_p243;
  const Real inverse_D5_p245 = inverse_D5_p242 + inverse_D5_p244;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p246 = inverse_D5_p245 * minus_inverse_D10;
  const Real inverse_D5_p247 = 0.0014999985000000002 + 0.0001499998887063 * inverse_D5_p246;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D5_p248 = c11 * inverse_D5_p243;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p249 = inverse_D5_p248 + (0.28049749700000004 - inverse_D5_p237) -
      inverse_D5_p225 * inverse_D5_p246;
  const Real inverse_D5_p250 = c10 * inverse_D5_p247 - s10 * inverse_D5_p249;
  const Real inverse_D5_p251 = 0.0007394999671343001 - inverse_D5_p229 - c10 * inverse_D5_p234 -
      0.282 * inverse_D5_p250;
  const Real inverse_D5_p252 = 0.0022500062 - inverse_D5_p250;
  const Real minus_inverse_D9_p1 = s10 * inverse_D5_p234;

  // link 9 (left_upperarm), articulated inertia
  const Real minus_inverse_D9 = 1.0 / (minus_inverse_D9_p1 -
      (0.0030572932027870155 + inverse_D5_p233));
  const Real inverse_D5_p253 = inverse_D5_p252 * minus_inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p254 = s10 * inverse_D5_p247 + c10 * inverse_D5_p249;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D5_p255 = inverse_D5_p200 - inverse_D5_p235 * inverse_D5_p239;
  const Real inverse_D5_p256 = inverse_D5_p222 + inverse_D5_p235 * inverse_D5_p236;
  const Real inverse_D5_p257 = inverse_D5_p214 + inverse_D5_p238 * inverse_D5_p239;
  const Real inverse_D5_p258 = inverse_D5_p255 * inverse_D5_p210 + s11 *
      (inverse_D5_p256 - inverse_D5_p257);
  const Real inverse_D5_p259 = s11 * inverse_D5_p258;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p260 = inverse_D5_p257 + inverse_D5_p259 - inverse_D5_p245 *
      inverse_D5_p246;
  const Real inverse_D5_p261 = inverse_D5_p254 - 0.282 * inverse_D5_p260;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D5_p262 = inverse_D5_p261 + inverse_D5_p251 * inverse_D5_p253;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D5_p263 = inverse_D5_p248 - (0.28049749700000004 + inverse_D5_p240);

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p264 = inverse_D5_p263 * minus_inverse_D10;
  const Real inverse_D5_p265 = 0.0001499998887063 * inverse_D5_p264;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p266 = c12 * inverse_D5_p198 - s12 * inverse_D5_p199;
  const Real inverse_D5_p267 = inverse_D5_p192 + inverse_D5_p194;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D5_p268 = inverse_D5_p267 * inverse_D11;
  const Real inverse_D5_p269 = inverse_D5_p203 - (0.001 + inverse_D5_p186) + 0.269 *
      inverse_D5_p266 + inverse_D5_p208 * inverse_D5_p268;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D5_p270 = inverse_D5_p219 - c12 * inverse_D5_p220;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D5_p271 = 6e-04 + 0.269 * inverse_D5_p270 + inverse_D5_p204 * inverse_D5_p268;
  const Real inverse_D5_p272 = 0.0014999985000000002 + c11 * inverse_D5_p271 + s11 *
      inverse_D5_p269;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p273 = inverse_D5_p272 * minus_inverse_D10;
  const Real inverse_D5_p274 = s11 * inverse_D5_p271 - c11 * inverse_D5_p269 + inverse_D5_p225 *
      inverse_D5_p273;
  const Real inverse_D5_p275 = inverse_D5_p241 + inverse_D5_p244 + inverse_D5_p225 *
      inverse_D5_p264;
  const Real inverse_D5_p276 = 0.0001499998887063 * inverse_D5_p273;
  const Real inverse_D5_p277 = c10 * (inverse_D5_p265 + inverse_D5_p274) + s10 *
      (inverse_D5_p275 - inverse_D5_p276);
  const Real inverse_D5_p278 = c10 * inverse_D5_p277;
  const Real inverse_D5_p279 = inverse_D5_p274 - inverse_D5_p278;
  const Real inverse_D5_p280 = 0.004500002325 + inverse_D5_p279;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D5_p281 = inverse_D5_p280 * minus_inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p282 = 0.0012089992423205001 + 0.282 * inverse_D5_p279;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D5_p283 = inverse_D5_p266 + inverse_D5_p238 * inverse_D5_p268;
  const Real inverse_D5_p284 = inverse_D5_p270 + inverse_D5_p235 * inverse_D5_p268;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p285 = s11 * inverse_D5_p283 + c11 * inverse_D5_p284 - inverse_D5_p263 *
      inverse_D5_p273;
  const Real inverse_D5_p286 = inverse_D5_p256 - inverse_D5_p259 - inverse_D5_p263 *
      inverse_D5_p264;
  const Real inverse_D5_p287 = inverse_D5_p218 - inverse_D5_p221 + inverse_D5_p267 *
      inverse_D5_p268 - inverse_D5_p272 * inverse_D5_p273;
  const Real inverse_D5_p288 = inverse_D5_p285 * inverse_D5_p230 + s10 *
      (inverse_D5_p286 - inverse_D5_p287);
  const Real inverse_D5_p289 = s10 * inverse_D5_p288;
  const Real inverse_D5_p290 = inverse_D5_p286 - inverse_D5_p289;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D5_p291 = 0.282 * inverse_D5_p290 - inverse_D5_p282 * inverse_D5_p281;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p292 = c11 * inverse_D5_p283 - s11 * inverse_D5_p284 + inverse_D5_p272 *
      inverse_D5_p246;
  const Real inverse_D5_p293 = inverse_D5_p255 - c11 * inverse_D5_p258 + inverse_D5_p263 *
      inverse_D5_p246;
  const Real inverse_D5_p294 = s10 * inverse_D5_p292 - c10 * inverse_D5_p293;
  const Real inverse_D5_p295 = 0.282 * inverse_D5_p294;
  const Real inverse_D5_p296 = s10 * inverse_D5_p277;
  const Real inverse_D5_p297 = inverse_D5_p295 + (inverse_D5_p275 - inverse_D5_p296);

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D5_p298 = inverse_D5_p297 - inverse_D5_p251 * inverse_D5_p281;
  const Real inverse_D5_p299 = inverse_D5_p295 - inverse_D5_p282 * inverse_D5_p253;
  const Real inverse_D5_p300 = s9 * (inverse_D5_p291 + inverse_D5_p262) + c9 *
      (inverse_D5_p298 + inverse_D5_p299);
  const Real inverse_D5_p301 = c9 * inverse_D5_p300;
  const Real inverse_D5_p302 = inverse_D5_p299 - inverse_D5_p301;
  const Real minus_inverse_D8_p1 = inverse_D5_p282 * minus_inverse_D9;
  const Real minus_inverse_D8_p2 = 4.4999986458742003e-05 + 0.282 * inverse_D5_p297 -
      inverse_D5_p251 * minus_inverse_D8_p1;
  const Real minus_inverse_D8_p3 = 2.0 * s9;
  const Real minus_inverse_D8_p4 = inverse_D5_p251 * minus_inverse_D9;
  const Real minus_inverse_D8_p5 = minus_inverse_D9_p1 + (0.0019585440854647937 + inverse_D5_p232) +
      0.282 * (inverse_D5_p254 + inverse_D5_p261) + inverse_D5_p251 * minus_inverse_D8_p4;
  const Real minus_inverse_D8_p6 = 0.0008177492704690715 - 0.07952399999999998 * inverse_D5_p290 +
      inverse_D5_p282 * minus_inverse_D8_p1;
  const Real minus_inverse_D8_p7 = minus_inverse_D8_p2 * minus_inverse_D8_p3 - c9 *
      (minus_inverse_D8_p5 - minus_inverse_D8_p6);
  const Real minus_inverse_D8_p8 = c9 * minus_inverse_D8_p7;
  const Real minus_inverse_D8_p9 = minus_inverse_D8_p8 -
      (0.18125194219699997 + minus_inverse_D8_p6);

  // link 8 (left_shoulder2), articulated inertia
  const Real minus_inverse_D8 = 1.0 / minus_inverse_D8_p9;
  const Real inverse_D5_p303 = inverse_D5_p302 * minus_inverse_D8;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D5_p304 = 1.75e-05 - minus_inverse_D8_p2 + s9 * minus_inverse_D8_p7;
  const Real inverse_D5_p305 = s9 * inverse_D5_p300;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D5_p306 = inverse_D5_p305 + (0.7139200499999999 - inverse_D5_p291) +
      inverse_D5_p304 * inverse_D5_p303;
  const Real inverse_D5_p307 = 0.0017499999999999998 - 0.00010499999999999999 * inverse_D5_p303;
  const Real inverse_D5_p308 = 0.0017499999999999998 - c8 * inverse_D5_p306 + s8 * inverse_D5_p307;
  const Real minus_inverse_D7_p1 = inverse_D5_p304 * minus_inverse_D8;
  const Real minus_inverse_D7_p2 = 0.00010499999999999999 * minus_inverse_D7_p1;
  const Real minus_inverse_D7_p3 = 2.0 * c8;
  const Real minus_inverse_D7_p4 = minus_inverse_D8_p8 +
      (0.18113119219699997 + minus_inverse_D8_p5) + inverse_D5_p304 * minus_inverse_D7_p1;
  const Real minus_inverse_D7_p5 = 1.1024999999999998e-08 / minus_inverse_D8_p9;
  const Real minus_inverse_D7_p6 = (5.2499999999999995e-05 - minus_inverse_D7_p2) *
      minus_inverse_D7_p3 - s8 * (0.00012075 + minus_inverse_D7_p5 - minus_inverse_D7_p4);
  const Real minus_inverse_D7_p7 = s8 * minus_inverse_D7_p6;
  const Real minus_inverse_D7_p8 = minus_inverse_D7_p7 - (0.000448 + minus_inverse_D7_p4);

  // link 7 (left_shoulder1), articulated inertia
  const Real minus_inverse_D7 = 1.0 / minus_inverse_D7_p8;
  const Real inverse_D5_p309 = inverse_D5_p308 * minus_inverse_D7;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D5_p310 = 2.6249999999999998e-05 - minus_inverse_D7_p2 - c8 *
      minus_inverse_D7_p6;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p311 = s8 * inverse_D5_p306 + c8 * inverse_D5_p307 + inverse_D5_p310 *
      inverse_D5_p309;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p312 = inverse_D5_p276 + inverse_D5_p296;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D5_p313 = inverse_D5_p312 * minus_inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p314 = c10 * inverse_D5_p292 + s10 * inverse_D5_p293;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D5_p315 = inverse_D5_p278 + (0.004500002325 - inverse_D5_p265) - 0.282 *
      inverse_D5_p314 + inverse_D5_p251 * inverse_D5_p313;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D5_p316 = inverse_D5_p285 - c10 * inverse_D5_p288;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D5_p317 = 0.0022500062 + 0.282 * inverse_D5_p316 - inverse_D5_p282 *
      inverse_D5_p313;
  const Real inverse_D5_p318 = 0.0017499999999999998 - s9 * inverse_D5_p317 + c9 * inverse_D5_p315;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D5_p319 = inverse_D5_p318 * minus_inverse_D8;
  const Real inverse_D5_p320 = c9 * inverse_D5_p317 + s9 * inverse_D5_p315 - inverse_D5_p304 *
      inverse_D5_p319;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D5_p321 = inverse_D5_p305 - (0.7139200499999999 + inverse_D5_p262);

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D5_p322 = inverse_D5_p321 * minus_inverse_D8;
  const Real inverse_D5_p323 = 0.00010499999999999999 * inverse_D5_p322;
  const Real inverse_D5_p324 = inverse_D5_p298 - inverse_D5_p301 - inverse_D5_p304 *
      inverse_D5_p322;
  const Real inverse_D5_p325 = 0.00010499999999999999 * inverse_D5_p319;
  const Real inverse_D5_p326 = c8 * (inverse_D5_p320 - inverse_D5_p323) - s8 *
      (inverse_D5_p325 + inverse_D5_p324);
  const Real inverse_D5_p327 = c8 * inverse_D5_p326;
  const Real inverse_D5_p328 = inverse_D5_p327 - (0.0017499999999999998 - inverse_D5_p323);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p329 = inverse_D5_p328 * minus_inverse_D7;
  const Real inverse_D5_p330 = 2.6249999999999998e-05 * inverse_D5_p329;
  const Real inverse_D5_p331 = 2.6249999999999998e-05 * inverse_D5_p309;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D5_p332 = s8 * inverse_D5_p326;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p333 = inverse_D5_p325 + inverse_D5_p332 - inverse_D5_p310 *
      inverse_D5_p329;
  const Real inverse_D5_p334 = s7 * (inverse_D5_p311 + inverse_D5_p330) + c7 *
      (inverse_D5_p331 + inverse_D5_p333);
  const Real inverse_D5_p335 = c7 * inverse_D5_p334;
  const Real inverse_D5_p336 = inverse_D5_p331 - inverse_D5_p335;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D5_p337 = inverse_D5_p290 - inverse_D5_p280 * inverse_D5_p281;
  const Real inverse_D5_p338 = inverse_D5_p260 - inverse_D5_p252 * inverse_D5_p253;
  const Real inverse_D5_p339 = inverse_D5_p294 - inverse_D5_p280 * inverse_D5_p253;
  const Real inverse_D5_p340 = inverse_D5_p339 * minus_inverse_D8_p3 - c9 *
      (inverse_D5_p337 - inverse_D5_p338);
  const Real inverse_D5_p341 = c9 * inverse_D5_p340;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p342 = inverse_D5_p338 - inverse_D5_p341 - inverse_D5_p302 *
      inverse_D5_p303 - inverse_D5_p308 * inverse_D5_p309;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D5_p343 = inverse_D5_p314 - inverse_D5_p252 * inverse_D5_p313;
  const Real inverse_D5_p344 = inverse_D5_p316 - inverse_D5_p280 * inverse_D5_p313;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D5_p345 = c9 * inverse_D5_p343 + s9 * inverse_D5_p344 + inverse_D5_p318 *
      inverse_D5_p322;
  const Real inverse_D5_p346 = inverse_D5_p337 + inverse_D5_p341 - inverse_D5_p321 *
      inverse_D5_p322;
  const Real inverse_D5_p347 = inverse_D5_p287 + inverse_D5_p289 - inverse_D5_p312 *
      inverse_D5_p313 - inverse_D5_p318 * inverse_D5_p319;
  const Real inverse_D5_p348 = inverse_D5_p345 * minus_inverse_D7_p3 - s8 *
      (inverse_D5_p347 - inverse_D5_p346);
  const Real inverse_D5_p349 = s8 * inverse_D5_p348;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p350 = inverse_D5_p347 + inverse_D5_p349 - inverse_D5_p328 *
      inverse_D5_p329;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D5_p351 = inverse_D5_p339 - s9 * inverse_D5_p340 + inverse_D5_p321 *
      inverse_D5_p303;
  const Real inverse_D5_p352 = s9 * inverse_D5_p343 - c9 * inverse_D5_p344 + inverse_D5_p318 *
      inverse_D5_p303;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p353 = s8 * inverse_D5_p351 - c8 * inverse_D5_p352 - inverse_D5_p308 *
      inverse_D5_p329;
  const Real inverse_D5_p354 = 2.0 * s7;
  const Real inverse_D5_p355 = inverse_D5_p353 * inverse_D5_p354 + c7 *
      (inverse_D5_p342 - inverse_D5_p350);
  const Real inverse_D5_p356 = inverse_D5_p353 - s7 * inverse_D5_p355;
  const Real inverse_D5_p357 = 0.18 * inverse_D5_p356;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D5_p358 = inverse_D5_p324 + inverse_D5_p332;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p359 = inverse_D5_p358 * minus_inverse_D7;
  const Real inverse_D5_p360 = inverse_D5_p345 - c8 * inverse_D5_p348 - inverse_D5_p328 *
      inverse_D5_p359;
  const Real inverse_D5_p361 = c8 * inverse_D5_p351 + s8 * inverse_D5_p352 + inverse_D5_p308 *
      inverse_D5_p359;
  const Real inverse_D5_p362 = s7 * inverse_D5_p360 - c7 * inverse_D5_p361;
  const Real inverse_D5_p363 = 0.226 * inverse_D5_p362;
  const Real inverse_D5_p364 = inverse_D5_p363 + (inverse_D5_p357 -
      (inverse_D5_p333 - inverse_D5_p335));

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p365 = inverse_D5_p128 * inverse_D14;
  const Real inverse_D5_p366 = 2.6249999999999998e-05 * inverse_D5_p365;
  const Real inverse_D5_p367 = inverse_D14_p7 + (inverse_D14_p5 - 0.00041825) + inverse_D5_p128 *
      inverse_D5_p365;
  const Real inverse_D5_p368 = 6.890624999999999e-10 / inverse_D14_p8;
  const Real inverse_D5_p369 = (8.75e-06 - inverse_D5_p366) * inverse_D5_p172 + c14 *
      (0.0001505 - inverse_D5_p368 + inverse_D5_p367);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p370 = inverse_D5_p310 * minus_inverse_D7;
  const Real inverse_D5_p371 = 8.75e-06 + 2.6249999999999998e-05 * inverse_D5_p370;
  const Real inverse_D5_p372 = minus_inverse_D7_p7 + (0.00041825 + minus_inverse_D7_p5) +
      inverse_D5_p310 * inverse_D5_p370;
  const Real inverse_D5_p373 = 0.0001505 + 6.890624999999999e-10 / minus_inverse_D7_p8;
  const Real inverse_D5_p374 = inverse_D5_p371 * inverse_D5_p354 + c7 *
      (inverse_D5_p373 - inverse_D5_p372);
  const Real inverse_D5_p375 = 0.18 * (inverse_D5_p154 + inverse_D5_p182 -
      (inverse_D5_p336 - inverse_D5_p364)) + (inverse_D5_p371 -
      (0.0187281677636143 + inverse_D5_p366 + s14 * inverse_D5_p369) - s7 * inverse_D5_p374);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p376 = inverse_D5_p145 + (0.0017499999999999998 - inverse_D5_p138) -
      inverse_D5_p128 * inverse_D5_p177;
  const Real inverse_D5_p377 = 0.0017499999999999998 + 2.6249999999999998e-05 * inverse_D5_p177;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p378 = inverse_D5_p327 + (0.0017499999999999998 - inverse_D5_p320) +
      inverse_D5_p310 * inverse_D5_p359;
  const Real inverse_D5_p379 = 0.0017499999999999998 - 2.6249999999999998e-05 * inverse_D5_p359;
  const Real inverse_D5_p380 = c14 * inverse_D5_p376 + s14 * inverse_D5_p377 +
      (c7 * inverse_D5_p378 + s7 * inverse_D5_p379);
  const Real inverse_D5_p381 = 0.226 * inverse_D5_p380 - inverse_D5_p375;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D6_p1 = s14 * inverse_D5_p152;
  const Real inverse_D6_p2 = inverse_D5_p148 + inverse_D6_p1;
  const Real inverse_D6_p3 = c14 * inverse_D5_p178 + s14 * inverse_D5_p179;
  const Real inverse_D6_p4 = c14 * inverse_D5_p173;
  const Real inverse_D6_p5 = inverse_D5_p160 + inverse_D6_p4;
  const Real inverse_D6_p6 = inverse_D6_p2 - 0.226 * inverse_D6_p3 - 0.18 * inverse_D6_p5;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p7 = s7 * inverse_D5_p334;
  const Real inverse_D6_p8 = inverse_D5_p330 - inverse_D6_p7;
  const Real inverse_D6_p9 = c7 * inverse_D5_p360 + s7 * inverse_D5_p361;
  const Real inverse_D6_p10 = c7 * inverse_D5_p355;
  const Real inverse_D6_p11 = inverse_D5_p342 - inverse_D6_p10;
  const Real inverse_D6_p12 = inverse_D6_p8 + 0.226 * inverse_D6_p9 + 0.18 * inverse_D6_p11;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D6_p13 = s14 * inverse_D5_p376 - c14 * inverse_D5_p377;
  const Real inverse_D6_p14 = inverse_D5_p164 - inverse_D5_p167 - inverse_D5_p176 * inverse_D5_p177;
  const Real inverse_D6_p15 = inverse_D6_p13 - 0.226 * inverse_D6_p14 + 0.18 * inverse_D6_p3;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p16 = s7 * inverse_D5_p378 - c7 * inverse_D5_p379;
  const Real inverse_D6_p17 = inverse_D5_p346 - inverse_D5_p349 - inverse_D5_p358 * inverse_D5_p359;
  const Real inverse_D6_p18 = inverse_D6_p16 + 0.226 * inverse_D6_p17 + 0.18 * inverse_D6_p9;
  const Real inverse_D6_p19 = c7 * inverse_D5_p374;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D6_p20 = c14 * inverse_D5_p369;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D6_p21 = 0.0007770270270270272 * c24;
  const Real inverse_D6_p22 = c24 * inverse_D6_p21;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D6_p23 = 0.0007770270270270272 * c23;
  const Real inverse_D6_p24 = c23 * inverse_D6_p23;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D6_p25 = s24 * inverse_D6_p21;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D6_p26 = s23 * inverse_D6_p23;
  const Real inverse_D6_p27 = inverse_D6_p25 + inverse_D6_p26;
  const Real inverse_D6_p28 = 0.032 * (inverse_D6_p22 - inverse_D6_p24) + 0.095 * inverse_D6_p27;
  const Real inverse_D22_p1 = 9.060810810810813e-05 * s23;
  const Real inverse_D22_p2 = s23 * inverse_D22_p1;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D22_p3 = 9.060810810810813e-05 * s24;
  const Real inverse_D22_p4 = s24 * inverse_D22_p3;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D22_p5 = c23 + c24;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (1.05e-05 + (4.75e-05 * inverse_D22_p5 -
      (inverse_D22_p2 - (0.06394132500000001 - inverse_D22_p4))));
  const Real inverse_D6_p29 = inverse_D6_p28 * inverse_D22;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D6_p30 = 0.006756756756756757 * s24;
  const Real inverse_D6_p31 = s24 * inverse_D6_p30;
  const Real inverse_D6_p32 = c24 * inverse_D6_p30;
  const Real inverse_D6_p33 = 0.032 * inverse_D6_p31 - 0.095 * inverse_D6_p32;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D6_p34 = 0.006756756756756757 * s23;
  const Real inverse_D6_p35 = s23 * inverse_D6_p34;
  const Real inverse_D6_p36 = c23 * inverse_D6_p34;
  const Real inverse_D6_p37 = 0.032 * inverse_D6_p35 + 0.095 * inverse_D6_p36;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D6_p38 = 0.006756756756756757 - inverse_D6_p31;
  const Real inverse_D6_p39 = 0.032 * inverse_D6_p32 - 0.095 * inverse_D6_p38;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D6_p40 = 0.006756756756756757 - inverse_D6_p35;
  const Real inverse_D6_p41 = 0.032 * inverse_D6_p36 + 0.095 * inverse_D6_p40;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p42 = 0.095 * (inverse_D6_p39 - inverse_D6_p41) -
      (0.032 * (inverse_D6_p33 + inverse_D6_p37) - (0.009438624999999999 - inverse_D6_p28 *
      inverse_D6_p29));

  // link 23 (left_eye), articulated inertia
  const Real inverse_D6_p43 = s23 + s24;
  const Real inverse_D6_p44 = c24 * (inverse_D22_p3 - 8e-06) +
      (2.375e-05 * inverse_D6_p43 + c23 * (8e-06 + inverse_D22_p1));

  // link 22 (head), articulated inertia
  const Real inverse_D6_p45 = 1.6e-05 * (s23 - s24) +
      (inverse_D22_p2 + (0.05450270000000001 + inverse_D22_p4) - inverse_D22 *
      (inverse_D6_p44 * inverse_D6_p44));
  const Real inverse_D6_p46 = 0.095 * (inverse_D6_p22 + inverse_D6_p24) -
      (0.032 * (inverse_D6_p25 - inverse_D6_p26) + (0.0074 - inverse_D6_p44 * inverse_D6_p29));
  const Real inverse_D6_p47 = 2.0 * c22;
  const Real inverse_D6_p48 = inverse_D6_p46 * inverse_D6_p47 + s22 *
      (0.00017071621621621625 - inverse_D6_p45 + inverse_D6_p42);
  const Real inverse_D6_p49 = inverse_D6_p27 * inverse_D22;
  const Real inverse_D6_p50 = inverse_D6_p41 - (0.072575 + inverse_D6_p39) + inverse_D6_p28 *
      inverse_D6_p49;
  const Real inverse_D6_p51 = inverse_D6_p24 - (0.43200000000000005 - inverse_D6_p22) +
      inverse_D6_p44 * inverse_D6_p49;
  const Real inverse_D6_p52 = c22 * inverse_D6_p50 + s22 * inverse_D6_p51;
  const Real inverse_D6_p53 = 0.0016155 + inverse_D6_p46 - c22 * inverse_D6_p48 - 0.394 *
      inverse_D6_p52;
  const Real minus_inverse_D21_p1 = s22 * inverse_D6_p48;

  // link 21 (neck), articulated inertia
  const Real minus_inverse_D21 = 1.0 / (minus_inverse_D21_p1 -
      (0.006216750000000001 + inverse_D6_p42));

  // link 22 (head), articulated inertia
  const Real inverse_D6_p54 = s22 * inverse_D6_p50 - c22 * inverse_D6_p51;
  const Real inverse_D6_p55 = inverse_D6_p38 + inverse_D6_p40 + inverse_D6_p27 * inverse_D6_p49;
  const Real inverse_D6_p56 = inverse_D6_p54 - 0.394 * inverse_D6_p55;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p57 = minus_inverse_D21_p1 + (0.005342908783783784 + inverse_D6_p45) +
      0.394 * (inverse_D6_p54 + inverse_D6_p56) + minus_inverse_D21 *
      (inverse_D6_p53 * inverse_D6_p53);

  // link 23 (left_eye), articulated inertia
  const Real inverse_D6_p58 = 0.0007770270270270272 - inverse_D6_p24 -
      (0.431222972972973 + inverse_D6_p22);

  // link 22 (head), articulated inertia
  const Real inverse_D6_p59 = inverse_D6_p58 * inverse_D22;
  const Real inverse_D6_p60 = inverse_D6_p33 - inverse_D6_p37 - inverse_D6_p28 * inverse_D6_p59;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D6_p61 = 0.072575 + 0.00025 * inverse_D22_p5;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p62 = inverse_D6_p61 * inverse_D22;
  const Real inverse_D6_p63 = 0.00025 * inverse_D6_p43 - inverse_D6_p44 * inverse_D6_p62;
  const Real inverse_D6_p64 = inverse_D6_p27 + inverse_D6_p44 * inverse_D6_p59;
  const Real inverse_D6_p65 = inverse_D6_p28 * inverse_D6_p62;
  const Real inverse_D6_p66 = c22 * (inverse_D6_p60 - inverse_D6_p63) - s22 *
      (inverse_D6_p64 + inverse_D6_p65);
  const Real inverse_D6_p67 = c22 * inverse_D6_p66;
  const Real inverse_D6_p68 = inverse_D6_p63 + inverse_D6_p67;
  const Real inverse_D6_p69 = 0.394 * inverse_D6_p68;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p70 = inverse_D6_p69 * minus_inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p71 = inverse_D6_p58 * inverse_D6_p62;
  const Real inverse_D6_p72 = inverse_D6_p31 + inverse_D6_p35 + inverse_D6_p58 * inverse_D6_p59;
  const Real inverse_D6_p73 = inverse_D6_p61 * inverse_D6_p62;
  const Real inverse_D6_p74 = inverse_D6_p71 * inverse_D6_p47 - s22 *
      (inverse_D6_p72 - inverse_D6_p73);
  const Real inverse_D6_p75 = s22 * inverse_D6_p74;
  const Real inverse_D6_p76 = inverse_D6_p72 + inverse_D6_p75;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p77 = 0.000703125 - 0.155236 * inverse_D6_p76 + inverse_D6_p69 *
      inverse_D6_p70;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p78 = s22 * inverse_D6_p66;
  const Real inverse_D6_p79 = inverse_D6_p61 * inverse_D6_p49;
  const Real inverse_D6_p80 = inverse_D6_p32 + inverse_D6_p36 + inverse_D6_p58 * inverse_D6_p49;
  const Real inverse_D6_p81 = s22 * inverse_D6_p79 + c22 * inverse_D6_p80;
  const Real inverse_D6_p82 = 0.394 * inverse_D6_p81;
  const Real inverse_D6_p83 = inverse_D6_p82 + (inverse_D6_p64 + inverse_D6_p78);

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p84 = 0.394 * inverse_D6_p83 - inverse_D6_p53 * inverse_D6_p70;
  const Real inverse_D6_p85 = 2.0 * s21;
  const Real inverse_D6_p86 = inverse_D6_p84 * inverse_D6_p85 + c21 *
      (inverse_D6_p57 - inverse_D6_p77);
  const Real inverse_D6_p87 = c21 * inverse_D6_p86;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p88 = 0.226 * (inverse_D6_p13 + inverse_D6_p15 +
      (inverse_D6_p16 + inverse_D6_p18)) - (inverse_D6_p19 +
      (inverse_D5_p372 + (inverse_D6_p20 - (inverse_D5_p367 -
      (inverse_D6_p87 + (2.06965463592404 + inverse_D6_p77))))));

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / (0.18 * (inverse_D6_p2 + inverse_D6_p6 -
      (inverse_D6_p8 + inverse_D6_p12)) - inverse_D6_p88);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p382 = 0.226 * (inverse_D5_p182 - inverse_D5_p364) -
      (inverse_D6_p84 - s21 * inverse_D6_p86);

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p383 = inverse_D5_p382 * inverse_D6;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p384 = inverse_D5_p129 - inverse_D6_p1;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p385 = inverse_D5_p311 - inverse_D6_p7;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p386 = inverse_D5_p168 - inverse_D6_p4;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p387 = inverse_D5_p350 + inverse_D6_p10;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p388 = 0.04068 * (inverse_D5_p386 - inverse_D5_p387) -
      (0.226 * (inverse_D5_p384 - inverse_D5_p385) + inverse_D5_p381 * inverse_D5_p383);
  const Real inverse_D5_p389 = 2.0 * c6;
  const Real inverse_D5_p390 = inverse_D5_p381 * inverse_D6;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p391 = inverse_D5_p384 - 0.18 * inverse_D5_p386;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p392 = inverse_D5_p385 - 0.18 * inverse_D5_p387;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p393 = 0.18 * (inverse_D5_p384 + inverse_D5_p391 +
      (inverse_D5_p385 + inverse_D5_p392)) - (inverse_D6_p19 -
      (inverse_D5_p373 - (inverse_D6_p20 + (inverse_D5_p368 - 0.40056549999999996))) +
      inverse_D5_p381 * inverse_D5_p390);
  const Real inverse_D5_p394 = inverse_D5_p386 + inverse_D5_p387;
  const Real inverse_D5_p395 = 0.051076 * inverse_D5_p394 +
      (inverse_D6_p87 - (1.66923963592404 + inverse_D6_p57) + inverse_D5_p382 * inverse_D5_p383);
  const Real inverse_D5_p396 = inverse_D5_p388 * inverse_D5_p389 + s6 *
      (inverse_D5_p393 + inverse_D5_p395);
  const Real inverse_D5_p397 = s6 * inverse_D5_p396;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p398 = inverse_D6_p68 * minus_inverse_D21;
  const Real inverse_D5_p399 = 0.394 * inverse_D6_p76 - inverse_D6_p69 * inverse_D5_p398;

  // link 22 (head), articulated inertia
  const Real inverse_D5_p400 = 0.0045000000000000005 - inverse_D6_p52;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p401 = inverse_D5_p400 * minus_inverse_D21;
  const Real inverse_D5_p402 = inverse_D6_p56 + inverse_D6_p53 * inverse_D5_p401;
  const Real inverse_D5_p403 = inverse_D6_p83 - inverse_D6_p53 * inverse_D5_p398;
  const Real inverse_D5_p404 = inverse_D6_p82 - inverse_D6_p69 * inverse_D5_p401;
  const Real inverse_D5_p405 = s21 * (inverse_D5_p399 + inverse_D5_p402) - c21 *
      (inverse_D5_p403 + inverse_D5_p404);
  const Real inverse_D5_p406 = c21 * inverse_D5_p405;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p407 = inverse_D5_p364 - (inverse_D5_p182 +
      (inverse_D5_p404 + inverse_D5_p406));

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p408 = inverse_D5_p407 * inverse_D6;
  const Real inverse_D5_p409 = inverse_D5_p391 - inverse_D5_p392 - inverse_D5_p381 *
      inverse_D5_p408;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p410 = s21 * inverse_D5_p405;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p411 = 0.226 * inverse_D5_p394 -
      (inverse_D5_p410 + (6.1665928899999995 - inverse_D5_p399) + inverse_D5_p382 *
      inverse_D5_p408);
  const Real inverse_D5_p412 = c6 * inverse_D5_p411 + s6 * inverse_D5_p409;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p413 = inverse_D6_p81 - inverse_D6_p68 * inverse_D5_p401;
  const Real inverse_D5_p414 = inverse_D6_p76 - inverse_D6_p68 * inverse_D5_p398;
  const Real inverse_D5_p415 = inverse_D6_p55 - inverse_D5_p400 * inverse_D5_p401;
  const Real inverse_D5_p416 = inverse_D5_p413 * inverse_D6_p85 + c21 *
      (inverse_D5_p414 - inverse_D5_p415);
  const Real inverse_D5_p417 = c21 * inverse_D5_p416;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p418 = inverse_D5_p387 + (inverse_D5_p386 +
      (inverse_D5_p415 + inverse_D5_p417)) + inverse_D5_p407 * inverse_D5_p408;
  const Real inverse_D5_p419 = inverse_D5_p412 + 0.072 * inverse_D5_p418;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (inverse_D5_p397 + (0.203126912024134 - inverse_D5_p395) - 0.072 *
      (inverse_D5_p412 + inverse_D5_p419));

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p1 = inverse_D6_p18 + (inverse_D6_p15 +
      (inverse_D5_p410 - (6.1665928899999995 + inverse_D5_p402)));

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p2 = inverse_D1_p1 * inverse_D6;
  const Real inverse_D1_p3 = 0.18 * (inverse_D5_p180 + inverse_D5_p362) -
      (inverse_D5_p380 + inverse_D5_p381 * inverse_D1_p2);

  // link 22 (head), articulated inertia
  const Real inverse_D1_p4 = inverse_D6_p65 + inverse_D6_p78;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p5 = inverse_D1_p4 * minus_inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p6 = inverse_D6_p71 - c22 * inverse_D6_p74;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p7 = 0.0045000000000000005 - 0.394 * inverse_D1_p6 + inverse_D6_p69 *
      inverse_D1_p5;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p8 = c22 * inverse_D6_p79 - s22 * inverse_D6_p80;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p9 = inverse_D6_p60 - inverse_D6_p67 - 0.394 * inverse_D1_p8 -
      inverse_D6_p53 * inverse_D1_p5;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p10 = inverse_D6_p12 + (inverse_D6_p6 -
      (s21 * inverse_D1_p7 + c21 * inverse_D1_p9));

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p11 = inverse_D1_p10 * inverse_D6;
  const Real inverse_D1_p12 = 0.226 * (inverse_D5_p174 - inverse_D5_p356) -
      (c21 * inverse_D1_p7 - s21 * inverse_D1_p9 - inverse_D5_p382 * inverse_D1_p11);
  const Real inverse_D1_p13 = inverse_D5_p357 - (inverse_D5_p336 +
      (inverse_D5_p154 - inverse_D5_p175)) - inverse_D5_p381 * inverse_D1_p11;
  const Real inverse_D1_p14 = inverse_D5_p363 - (inverse_D5_p181 +
      (inverse_D5_p403 + inverse_D5_p406)) - inverse_D5_p382 * inverse_D1_p2;
  const Real inverse_D1_p15 = c6 * (inverse_D1_p12 - inverse_D1_p3) - s6 *
      (inverse_D1_p13 - inverse_D1_p14);
  const Real inverse_D1_p16 = s6 * inverse_D1_p15;
  const Real inverse_D1_p17 = inverse_D5_p362 - (inverse_D5_p180 -
      (inverse_D5_p413 - s21 * inverse_D5_p416)) + inverse_D1_p1 * inverse_D5_p408;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p18 = inverse_D1_p8 + inverse_D5_p400 * inverse_D1_p5;
  const Real inverse_D1_p19 = inverse_D1_p6 - inverse_D6_p68 * inverse_D1_p5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p20 = inverse_D5_p356 - (inverse_D5_p174 -
      (s21 * inverse_D1_p18 - c21 * inverse_D1_p19)) + inverse_D1_p10 * inverse_D5_p408;
  const Real inverse_D1_p21 = c6 * inverse_D1_p17 + s6 * inverse_D1_p20;
  const Real inverse_D1_p22 = 0.072 * inverse_D1_p21;
  const Real inverse_D1_p23 = inverse_D1_p22 + (inverse_D1_p14 - inverse_D1_p16);
  const Real inverse_D1_p24 = 0.072 * inverse_D1_p23;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p25 = inverse_D1_p24 * inverse_D5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p26 = inverse_D6_p11 + (inverse_D6_p5 +
      (inverse_D6_p73 - inverse_D6_p75 - inverse_D1_p4 * inverse_D1_p5)) + inverse_D1_p10 *
      inverse_D1_p11;
  const Real inverse_D1_p27 = inverse_D6_p17 - (inverse_D6_p14 -
      (inverse_D5_p414 - inverse_D5_p417)) + inverse_D1_p1 * inverse_D1_p2;
  const Real inverse_D1_p28 = inverse_D6_p9 - (inverse_D6_p3 -
      (c21 * inverse_D1_p18 + s21 * inverse_D1_p19)) + inverse_D1_p10 * inverse_D1_p2;
  const Real inverse_D1_p29 = inverse_D1_p28 * inverse_D5_p389 + s6 *
      (inverse_D1_p26 - inverse_D1_p27);
  const Real inverse_D1_p30 = s6 * inverse_D1_p29;
  const Real inverse_D1_p31 = inverse_D1_p27 + inverse_D1_p30;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p32 = 0.15637308509675518 - 0.005183999999999999 * inverse_D1_p31 -
      inverse_D1_p24 * inverse_D1_p25;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p33 = s6 * inverse_D5_p411 - c6 * inverse_D5_p409;
  const Real inverse_D1_p34 = inverse_D5_p388 - c6 * inverse_D5_p396 - 0.072 * inverse_D1_p33;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p35 = inverse_D1_p34 * inverse_D5;
  const Real inverse_D1_p36 = inverse_D5_p397 - (0.04675382692737882 + inverse_D5_p393) +
      inverse_D1_p34 * inverse_D1_p35;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p37 = c6 * inverse_D1_p15;
  const Real inverse_D1_p38 = inverse_D1_p12 - inverse_D1_p37;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p39 = 0.005678398088837119 - 0.072 * inverse_D1_p38 - inverse_D1_p24 *
      inverse_D1_p35;
  const Real inverse_D1_p40 = 2.0 * c5;
  const Real inverse_D1_p41 = inverse_D1_p39 * inverse_D1_p40 + s5 *
      (inverse_D1_p32 + inverse_D1_p36);
  const Real inverse_D1_p42 = inverse_D1_p23 * inverse_D5;
  const Real inverse_D1_p43 = 0.069699984375 - inverse_D1_p38 - inverse_D1_p34 * inverse_D1_p42;
  const Real inverse_D1_p44 = 2.2194301519999997 - 0.072 * inverse_D1_p31 - inverse_D1_p24 *
      inverse_D1_p42;
  const Real inverse_D1_p45 = c5 * inverse_D1_p43 + s5 * inverse_D1_p44;
  const Real inverse_D1_p46 = 0.005880002159562879 + inverse_D1_p39 - c5 * inverse_D1_p41 -
      0.21799999999999997 * inverse_D1_p45;
  const Real inverse_D1_p47 = 0.0300000063 - inverse_D1_p45;
  const Real inverse_D4_p1 = s5 * inverse_D1_p41;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (inverse_D4_p1 + (0.060169103246295166 - inverse_D1_p36));
  const Real inverse_D1_p48 = inverse_D1_p47 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p49 = s5 * inverse_D1_p43 - c5 * inverse_D1_p44;
  const Real inverse_D1_p50 = inverse_D1_p31 + inverse_D1_p23 * inverse_D1_p42;
  const Real inverse_D1_p51 = inverse_D1_p49 + 0.21799999999999997 * inverse_D1_p50;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p52 = inverse_D1_p51 + inverse_D1_p46 * inverse_D1_p48;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p53 = 2.2194301519999997 - inverse_D5_p419;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p54 = inverse_D1_p53 * inverse_D5;
  const Real inverse_D1_p55 = inverse_D1_p33 + inverse_D1_p34 * inverse_D1_p54;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p56 = s6 * inverse_D1_p17 - c6 * inverse_D1_p20;
  const Real inverse_D1_p57 = inverse_D1_p37 - (0.069699984375 - inverse_D1_p3) + 0.072 *
      inverse_D1_p56;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p58 = inverse_D1_p57 * inverse_D5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p59 = inverse_D1_p28 - c6 * inverse_D1_p29;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p60 = 0.072 * inverse_D1_p59 + inverse_D1_p24 * inverse_D1_p58;
  const Real inverse_D1_p61 = inverse_D1_p22 - inverse_D1_p24 * inverse_D1_p54;
  const Real inverse_D1_p62 = inverse_D1_p13 + inverse_D1_p16 - inverse_D1_p34 * inverse_D1_p58;
  const Real inverse_D1_p63 = c5 * (inverse_D1_p55 - inverse_D1_p60) - s5 *
      (inverse_D1_p61 + inverse_D1_p62);
  const Real inverse_D1_p64 = c5 * inverse_D1_p63;
  const Real inverse_D1_p65 = inverse_D1_p60 + inverse_D1_p64;
  const Real inverse_D1_p66 = 0.21799999999999997 * inverse_D1_p65;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p67 = inverse_D1_p65 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p68 = inverse_D5_p418 + inverse_D1_p53 * inverse_D1_p54;
  const Real inverse_D1_p69 = inverse_D1_p26 - inverse_D1_p30 + inverse_D1_p57 * inverse_D1_p58;
  const Real inverse_D1_p70 = inverse_D1_p56 - inverse_D1_p53 * inverse_D1_p58;
  const Real inverse_D1_p71 = inverse_D1_p70 * inverse_D1_p40 + s5 *
      (inverse_D1_p68 - inverse_D1_p69);
  const Real inverse_D1_p72 = s5 * inverse_D1_p71;
  const Real inverse_D1_p73 = inverse_D1_p68 - inverse_D1_p72;
  const Real inverse_D1_p74 = s5 * inverse_D1_p63;
  const Real inverse_D1_p75 = inverse_D1_p59 + inverse_D1_p57 * inverse_D1_p42;
  const Real inverse_D1_p76 = inverse_D1_p21 - inverse_D1_p53 * inverse_D1_p42;
  const Real inverse_D1_p77 = s5 * inverse_D1_p75 - c5 * inverse_D1_p76;
  const Real inverse_D1_p78 = 0.21799999999999997 * inverse_D1_p77;
  const Real inverse_D1_p79 = inverse_D1_p78 - (inverse_D1_p61 + inverse_D1_p74);

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p80 = c4 * (inverse_D1_p52 -
      (0.21799999999999997 * inverse_D1_p73 + inverse_D1_p66 * inverse_D1_p67)) + s4 *
      (inverse_D1_p78 + (inverse_D1_p79 + inverse_D1_p46 * inverse_D1_p67) + inverse_D1_p66 *
      inverse_D1_p48);
  const Real inverse_D1_p81 = 8.419374554 - inverse_D1_p52 + c4 * inverse_D1_p80;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p82 = inverse_D1_p62 + inverse_D1_p74;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p83 = inverse_D1_p82 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p84 = inverse_D1_p70 - c5 * inverse_D1_p71;
  const Real inverse_D1_p85 = c5 * inverse_D1_p75 + s5 * inverse_D1_p76;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p86 = 0.02999999505 + c4 * (0.0300000063 - 0.21799999999999997 *
      inverse_D1_p84 + inverse_D1_p66 * inverse_D1_p83) + s4 *
      (inverse_D1_p55 - inverse_D1_p64 + 0.21799999999999997 * inverse_D1_p85 - inverse_D1_p46 *
      inverse_D1_p83);
  const Real inverse_D3_p1 = inverse_D1_p66 * inverse_D4;
  const Real inverse_D3_p2 = 0.01227760324629517 - 0.04752399999999999 * inverse_D1_p73 -
      inverse_D1_p66 * inverse_D3_p1;
  const Real inverse_D3_p3 = inverse_D1_p46 * inverse_D4;
  const Real inverse_D3_p4 = inverse_D3_p2 + (inverse_D4_p1 - (0.0478915 + inverse_D1_p32) +
      0.21799999999999997 * (inverse_D1_p49 + inverse_D1_p51) + inverse_D1_p46 * inverse_D3_p3);
  const Real inverse_D3_p5 = 2.0 * c4;
  const Real inverse_D3_p6 = 1.7824817919087104 + inverse_D3_p2 + s4 *
      ((0.21799999999999997 * inverse_D1_p79 + inverse_D1_p46 * inverse_D3_p1) * inverse_D3_p5 -
      s4 * inverse_D3_p4);

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / inverse_D3_p6;
  const Real inverse_D1_p87 = inverse_D1_p86 * inverse_D3;
  const Real inverse_D1_p88 = s4 * (inverse_D1_p85 - inverse_D1_p47 * inverse_D1_p83) - c4 *
      (inverse_D1_p84 - inverse_D1_p65 * inverse_D1_p83) - inverse_D1_p81 * inverse_D1_p87;
  const Real inverse_D1_p89 = inverse_D1_p81 * inverse_D3;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p90 = inverse_D1_p73 + inverse_D1_p65 * inverse_D1_p67;
  const Real inverse_D1_p91 = (inverse_D1_p77 + inverse_D1_p65 * inverse_D1_p48) * inverse_D3_p5 -
      s4 * (inverse_D1_p50 - inverse_D1_p90 + inverse_D1_p47 * inverse_D1_p48);

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p92 = inverse_D1_p90 - s4 * inverse_D1_p91 + inverse_D1_p81 *
      inverse_D1_p89;
  const Real inverse_D1_p93 = inverse_D1_p69 + inverse_D1_p72 + inverse_D1_p82 * inverse_D1_p83 +
      inverse_D1_p86 * inverse_D1_p87;
  const Real inverse_D1_p94 = inverse_D1_p88 * (2.0 * c3) + s3 * (inverse_D1_p92 - inverse_D1_p93);
  const Real inverse_D1_p95 = s3 * inverse_D1_p94;
  const Real inverse_D1_p96 = inverse_D1_p92 - inverse_D1_p95;
  const Real inverse_D1_p97 = 24.5839218 - 0.422 * inverse_D1_p96;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 - 0.178084 * inverse_D1_p96);
  const Real inverse_D1_p98 = inverse_D1_p97 * inverse_D2;
  const Real inverse_D1_p99 = inverse_D1_p96 + inverse_D1_p97 * inverse_D1_p98;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p100 = inverse_D1_p88 - c3 * inverse_D1_p94;
  const Real inverse_D1_p101 = 0.031999971599999996 + 0.422 * inverse_D1_p100;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p102 = inverse_D1_p101 * inverse_D2;
  const Real inverse_D1_p103 = (inverse_D1_p100 - inverse_D1_p97 * inverse_D1_p102) * (2.0 * c2) +
      s2 * (inverse_D1_p95 + (inverse_D1_p93 - inverse_D1_p99) + inverse_D1_p101 * inverse_D1_p102);

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 - 0.188356 *
      (inverse_D1_p99 + s2 * inverse_D1_p103));

  // link 20 (right_hand), force propagation
  const Real f13_y_p1 = 0.04672761636452121 * c20 + 0.11533812622014242 * s20;

  // link 19 (right_wrist2), force propagation
  const Real f13_y_p2 = 0.04672761636452121 * s20 - 0.11533812622014242 * c20 - inverse_D18_p1 *
      f13_y_p1;
  const Real f13_y_p3 = c19 * f13_y_p2;
  const Real f13_y_p4 = 17.32841575379867 * s20 + 3.0523172236718206 * c20 + inverse_D5_p8 *
      f13_y_p1;
  const Real f13_y_p5 = inverse_D5_p2 * f13_y_p1;
  const Real f13_y_p6 = s19 * f13_y_p4 + c19 * f13_y_p5;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p7 = 0.269 * f13_y_p6 + inverse_D5_p23 * f13_y_p3;

  // link 19 (right_wrist2), force propagation
  const Real f13_y_p8 = 17.32841575379867 * c20 - 3.0523172236718206 * s20 - inverse_D5_p14 *
      f13_y_p1;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p9 = 0.269 * f13_y_p8 - s19 * f13_y_p2 + inverse_D5_p29 * f13_y_p3;
  const Real f13_y_p10 = c18 * f13_y_p7 - s18 * f13_y_p9;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p11 = s18 * f13_y_p7 + c18 * f13_y_p9 + inverse_D5_p49 * f13_y_p10;
  const Real f13_y_p12 = inverse_D5_p46 * f13_y_p10;
  const Real f13_y_p13 = c17 * f13_y_p12 + s17 * f13_y_p11;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p14 = f13_y_p6 + inverse_D5_p54 * f13_y_p3;
  const Real f13_y_p15 = f13_y_p8 + inverse_D5_p57 * f13_y_p3;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p16 = s18 * f13_y_p15 - c18 * f13_y_p14 + inverse_D5_p82 * f13_y_p10;
  const Real f13_y_p17 = c19 * f13_y_p4 - s19 * f13_y_p5 - inverse_D5_p86 * f13_y_p3 -
      inverse_D5_p91 * f13_y_p10;
  const Real f13_y_p18 = s17 * f13_y_p17 - c17 * f13_y_p16;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p19 = 0.282 * f13_y_p18 - inverse_D15_p1 * f13_y_p13;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p20 = c18 * f13_y_p15 + s18 * f13_y_p14 - inverse_D5_p64 * f13_y_p10;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p21 = 0.282 * f13_y_p20 - s17 * f13_y_p12 + c17 * f13_y_p11 + inverse_D15_p4 *
      f13_y_p13;
  const Real f13_y_p22 = s16 * f13_y_p19 + c16 * f13_y_p21;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p23 = c16 * f13_y_p19 - s16 * f13_y_p21 + inverse_D14_p1 * f13_y_p22;

  // link 15 (right_shoulder2), articulated inertia
  const Real f13_y_p24 = 0.00010499999999999999 / inverse_D15_p9;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p25 = f13_y_p24 * f13_y_p22;
  const Real f13_y_p26 = c15 * f13_y_p23 - s15 * f13_y_p25;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p27 = f13_y_p20 + inverse_D5_p71 * f13_y_p13;
  const Real f13_y_p28 = f13_y_p18 - inverse_D5_p99 * f13_y_p13;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p29 = c16 * f13_y_p27 + s16 * f13_y_p28 - inverse_D5_p140 * f13_y_p22;
  const Real f13_y_p30 = c17 * f13_y_p17 + s17 * f13_y_p16 + inverse_D5_p131 * f13_y_p13 +
      inverse_D5_p137 * f13_y_p22;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p31 = s15 * f13_y_p29 + c15 * f13_y_p30 + inverse_D5_p147 * f13_y_p26;
  const Real f13_y_p32 = s16 * f13_y_p27 - c16 * f13_y_p28 - inverse_D5_p121 * f13_y_p22 -
      inverse_D5_p127 * f13_y_p26;
  const Real f13_y_p33 = c14 * f13_y_p31 + s14 * f13_y_p32;
  const Real f13_y_p34 = c15 * f13_y_p29 - s15 * f13_y_p30 + inverse_D5_p177 * f13_y_p26;
  const Real f13_y_p35 = s15 * f13_y_p23 + c15 * f13_y_p25 - inverse_D5_p365 * f13_y_p26;

  // link 14 (right_shoulder1), articulated inertia
  const Real f13_y_p36 = 2.6249999999999998e-05 / inverse_D14_p8;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p37 = f13_y_p36 * f13_y_p26;
  const Real f13_y_p38 = 0.18 * f13_y_p33 + 0.226 * f13_y_p34 + s14 * f13_y_p35 - c14 * f13_y_p37;
  const Real f13_y_p39 = s14 * f13_y_p31 - c14 * f13_y_p32;

  // link 6 (chest3), force propagation
  const Real f13_y_p40 = f13_y_p39 - inverse_D5_p408 * f13_y_p38;
  const Real f13_y_p41 = 0.226 * f13_y_p39 + inverse_D5_p383 * f13_y_p38;
  const Real f13_y_p42 = 0.18 * f13_y_p39 - c14 * f13_y_p35 - s14 * f13_y_p37 - inverse_D5_p390 *
      f13_y_p38;
  const Real f13_y_p43 = 0.072 * f13_y_p40 + c6 * f13_y_p41 - s6 * f13_y_p42;

  // link 5 (chest2), force propagation
  const Real f13_y_p44 = s6 * f13_y_p41 + c6 * f13_y_p42 - inverse_D1_p35 * f13_y_p43;

  // link 6 (chest3), force propagation
  const Real f13_y_p45 = f13_y_p34 + inverse_D1_p2 * f13_y_p38;
  const Real f13_y_p46 = f13_y_p33 - inverse_D1_p11 * f13_y_p38;
  const Real f13_y_p47 = c6 * f13_y_p45 - s6 * f13_y_p46;

  // link 5 (chest2), force propagation
  const Real f13_y_p48 = 0.072 * f13_y_p47 - inverse_D1_p25 * f13_y_p43;
  const Real f13_y_p49 = c5 * f13_y_p44 + s5 * f13_y_p48;
  const Real f13_y_p50 = s6 * f13_y_p45 + c6 * f13_y_p46 - inverse_D1_p58 * f13_y_p43;
  const Real f13_y_p51 = f13_y_p40 - inverse_D1_p54 * f13_y_p43;
  const Real f13_y_p52 = s5 * f13_y_p50 + c5 * f13_y_p51;
  const Real f13_y_p53 = f13_y_p47 - inverse_D1_p42 * f13_y_p43;

  // link 4 (chest1), force propagation
  const Real f13_y_p54 = s4 * (0.21799999999999997 * f13_y_p53 - s5 * f13_y_p44 + c5 * f13_y_p48 +
      inverse_D3_p3 * f13_y_p49);
  const Real f13_y_p55 = c4 * (0.21799999999999997 * f13_y_p52 + inverse_D3_p1 * f13_y_p49) -
      f13_y_p54;

  // link 3 (hip), force propagation
  const Real f13_y_p56 = c5 * f13_y_p50 - s5 * f13_y_p51 - inverse_D1_p83 * f13_y_p49 -
      inverse_D1_p87 * f13_y_p55;
  const Real f13_y_p57 = s4 * (f13_y_p53 + inverse_D1_p48 * f13_y_p49) - c4 *
      (f13_y_p52 + inverse_D1_p67 * f13_y_p49) + inverse_D1_p89 * f13_y_p55;
  const Real f13_y_p58 = s3 * f13_y_p56 - c3 * f13_y_p57;
  const Real f13_y_p59 = 0.422 * f13_y_p58;

  // link 2 (thigh), force propagation
  const Real f13_y_p60 = s2 * (c3 * f13_y_p56 + s3 * f13_y_p57 + inverse_D1_p102 * f13_y_p59) + c2 *
      (f13_y_p58 - inverse_D1_p98 * f13_y_p59);
  const Real f13_y_p61 = 0.434 * f13_y_p60;

  // link 1 (calf), force propagation
  const Real f13_y_p62 = inverse_D1 * f13_y_p61;

  // link 12 (left_wrist2), force propagation
  const Real f13_y_p63 = s12 * c13;
  const Real f13_y_p64 = 0.269 * f13_y_p63;
  const Real f13_y_p65 = 0.269 * s13;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p66 = c11 * f13_y_p64 + s11 * f13_y_p65;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p67 = s11 * f13_y_p64 - c11 * f13_y_p65 + inverse_D5_p231 * f13_y_p66;
  const Real f13_y_p68 = inverse_D5_p228 * f13_y_p66;
  const Real f13_y_p69 = c10 * f13_y_p68 + s10 * f13_y_p67;
  const Real f13_y_p70 = s11 * s13 + c11 * f13_y_p63 - inverse_D5_p264 * f13_y_p66;
  const Real f13_y_p71 = c12 * c13 + inverse_D5_p273 * f13_y_p66;
  const Real f13_y_p72 = s10 * f13_y_p71 + c10 * f13_y_p70;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p73 = 0.282 * f13_y_p72 + minus_inverse_D8_p1 * f13_y_p69;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p74 = c11 * s13 - s11 * f13_y_p63 + inverse_D5_p246 * f13_y_p66;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p75 = 0.282 * f13_y_p74 + s10 * f13_y_p68 - c10 * f13_y_p67 -
      minus_inverse_D8_p4 * f13_y_p69;
  const Real f13_y_p76 = s9 * f13_y_p73 - c9 * f13_y_p75;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p77 = c9 * f13_y_p73 + s9 * f13_y_p75 + minus_inverse_D7_p1 * f13_y_p76;

  // link 8 (left_shoulder2), articulated inertia
  const Real f13_y_p78 = 0.00010499999999999999 / minus_inverse_D8_p9;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p79 = f13_y_p78 * f13_y_p76;
  const Real f13_y_p80 = c8 * f13_y_p77 + s8 * f13_y_p79;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p81 = f13_y_p74 - inverse_D5_p253 * f13_y_p69;
  const Real f13_y_p82 = f13_y_p72 + inverse_D5_p281 * f13_y_p69;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p83 = c9 * f13_y_p81 - s9 * f13_y_p82 + inverse_D5_p322 * f13_y_p76;
  const Real f13_y_p84 = c10 * f13_y_p71 - s10 * f13_y_p70 + inverse_D5_p313 * f13_y_p69 +
      inverse_D5_p319 * f13_y_p76;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p85 = s8 * f13_y_p83 - c8 * f13_y_p84 + inverse_D5_p329 * f13_y_p80;
  const Real f13_y_p86 = s9 * f13_y_p81 + c9 * f13_y_p82 + inverse_D5_p303 * f13_y_p76 -
      inverse_D5_p309 * f13_y_p80;
  const Real f13_y_p87 = c7 * f13_y_p85 + s7 * f13_y_p86;
  const Real f13_y_p88 = c8 * f13_y_p83 + s8 * f13_y_p84 - inverse_D5_p359 * f13_y_p80;
  const Real f13_y_p89 = s8 * f13_y_p77 - c8 * f13_y_p79 - inverse_D5_p370 * f13_y_p80;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_y_p90 = 2.6249999999999998e-05 / minus_inverse_D7_p8;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p91 = f13_y_p90 * f13_y_p80;
  const Real f13_y_p92 = 0.18 * f13_y_p87 - 0.226 * f13_y_p88 + s7 * f13_y_p89 - c7 * f13_y_p91;
  const Real f13_y_p93 = s7 * f13_y_p85 - c7 * f13_y_p86;

  // link 6 (chest3), force propagation
  const Real f13_y_p94 = f13_y_p93 + inverse_D5_p408 * f13_y_p92;
  const Real f13_y_p95 = 0.226 * f13_y_p93 - inverse_D5_p383 * f13_y_p92;
  const Real f13_y_p96 = 0.18 * f13_y_p93 - c7 * f13_y_p89 - s7 * f13_y_p91 - inverse_D5_p390 *
      f13_y_p92;
  const Real f13_y_p97 = 0.072 * f13_y_p94 + c6 * f13_y_p95 + s6 * f13_y_p96;

  // link 5 (chest2), force propagation
  const Real f13_y_p98 = s6 * f13_y_p95 - c6 * f13_y_p96 - inverse_D1_p35 * f13_y_p97;

  // link 6 (chest3), force propagation
  const Real f13_y_p99 = f13_y_p88 - inverse_D1_p2 * f13_y_p92;
  const Real f13_y_p100 = f13_y_p87 + inverse_D1_p11 * f13_y_p92;
  const Real f13_y_p101 = c6 * f13_y_p99 - s6 * f13_y_p100;

  // link 5 (chest2), force propagation
  const Real f13_y_p102 = 0.072 * f13_y_p101 - inverse_D1_p25 * f13_y_p97;
  const Real f13_y_p103 = c5 * f13_y_p98 + s5 * f13_y_p102;
  const Real f13_y_p104 = s6 * f13_y_p99 + c6 * f13_y_p100 - inverse_D1_p58 * f13_y_p97;
  const Real f13_y_p105 = f13_y_p94 - inverse_D1_p54 * f13_y_p97;
  const Real f13_y_p106 = s5 * f13_y_p104 + c5 * f13_y_p105;
  const Real f13_y_p107 = f13_y_p101 - inverse_D1_p42 * f13_y_p97;

  // link 4 (chest1), force propagation
  const Real f13_y_p108 = s4 * (0.21799999999999997 * f13_y_p107 - s5 * f13_y_p98 + c5 *
      f13_y_p102 + inverse_D3_p3 * f13_y_p103);
  const Real f13_y_p109 = c4 * (0.21799999999999997 * f13_y_p106 + inverse_D3_p1 * f13_y_p103) -
      f13_y_p108;

  // link 3 (hip), force propagation
  const Real f13_y_p110 = c5 * f13_y_p104 - s5 * f13_y_p105 - inverse_D1_p83 * f13_y_p103 -
      inverse_D1_p87 * f13_y_p109;
  const Real f13_y_p111 = s4 * (f13_y_p107 + inverse_D1_p48 * f13_y_p103) - c4 *
      (f13_y_p106 + inverse_D1_p67 * f13_y_p103) + inverse_D1_p89 * f13_y_p109;
  const Real f13_y_p112 = s3 * f13_y_p110 - c3 * f13_y_p111;
  const Real f13_y_p113 = 0.422 * f13_y_p112;

  // link 2 (thigh), force propagation
  const Real f13_y_p114 = s2 * (c3 * f13_y_p110 + s3 * f13_y_p111 + inverse_D1_p102 * f13_y_p113) +
      c2 * (f13_y_p112 - inverse_D1_p98 * f13_y_p113);
  const Real f13_y_p115 = 0.434 * f13_y_p114;
  const Real f13_y_p116 = inverse_D2 * f13_y_p59;

  // link 3 (hip), force propagation
  const Real f13_y_p117 = inverse_D3 * f13_y_p55;

  // link 4 (chest1), force propagation
  const Real f13_y_p118 = inverse_D4 * f13_y_p49;

  // link 5 (chest2), force propagation
  const Real f13_y_p119 = inverse_D5 * f13_y_p43;

  // link 6 (chest3), force propagation
  const Real f13_y_p120 = inverse_D6 * f13_y_p38;

  // link 1 (calf), force propagation
  const Real f13_y_p121 = f13_y_p92 * f13_y_p120 - f13_y_p97 * f13_y_p119 - f13_y_p103 *
      f13_y_p118 - f13_y_p109 * f13_y_p117 - f13_y_p113 * f13_y_p116;
  const Real f13_y_p122 = f13_y_p121 - f13_y_p115 * f13_y_p62;
  const Real f13_y_p123 = f13_y_p66 * (minus_inverse_D10 * f13_y_p66) + f13_y_p69 *
      (minus_inverse_D9 * f13_y_p69) + f13_y_p76 * (minus_inverse_D8 * f13_y_p76);
  const Real f13_y_p124 = f13_y_p123 + f13_y_p80 * (minus_inverse_D7 * f13_y_p80) - f13_y_p92 *
      (inverse_D6 * f13_y_p92) - f13_y_p97 * (inverse_D5 * f13_y_p97);
  const Real f13_y_p125 = f13_y_p124 - f13_y_p103 * (inverse_D4 * f13_y_p103) - f13_y_p109 *
      (inverse_D3 * f13_y_p109) - f13_y_p113 * (inverse_D2 * f13_y_p113);
  const Real f13_y_p126 = 1.0 / (f13_y_p125 - f13_y_p115 * (inverse_D1 * f13_y_p115));
  const Real f13_y_p127 = f13_y_p122 * f13_y_p126;

  // link 12 (left_wrist2), force propagation
  const Real f13_y_p128 = s12 * s13;
  const Real f13_y_p129 = 0.269 * f13_y_p128;
  const Real f13_y_p130 = 0.269 * c13;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p131 = c11 * f13_y_p129 - s11 * f13_y_p130;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p132 = s11 * f13_y_p129 + c11 * f13_y_p130 + inverse_D5_p231 * f13_y_p131;
  const Real f13_y_p133 = inverse_D5_p228 * f13_y_p131;
  const Real f13_y_p134 = c10 * f13_y_p133 + s10 * f13_y_p132;
  const Real f13_y_p135 = s11 * c13 - c11 * f13_y_p128 + inverse_D5_p264 * f13_y_p131;
  const Real f13_y_p136 = c12 * s13 + inverse_D5_p273 * f13_y_p131;
  const Real f13_y_p137 = s10 * f13_y_p136 - c10 * f13_y_p135;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p138 = 0.282 * f13_y_p137 + minus_inverse_D8_p1 * f13_y_p134;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p139 = c11 * c13 + s11 * f13_y_p128 - inverse_D5_p246 * f13_y_p131;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p140 = 0.282 * f13_y_p139 - s10 * f13_y_p133 + c10 * f13_y_p132 +
      minus_inverse_D8_p4 * f13_y_p134;
  const Real f13_y_p141 = s9 * f13_y_p138 + c9 * f13_y_p140;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p142 = c9 * f13_y_p138 - s9 * f13_y_p140 + minus_inverse_D7_p1 * f13_y_p141;
  const Real f13_y_p143 = f13_y_p78 * f13_y_p141;
  const Real f13_y_p144 = c8 * f13_y_p142 + s8 * f13_y_p143;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p145 = f13_y_p139 + inverse_D5_p253 * f13_y_p134;
  const Real f13_y_p146 = f13_y_p137 + inverse_D5_p281 * f13_y_p134;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p147 = c9 * f13_y_p145 + s9 * f13_y_p146 - inverse_D5_p322 * f13_y_p141;
  const Real f13_y_p148 = c10 * f13_y_p136 + s10 * f13_y_p135 + inverse_D5_p313 * f13_y_p134 +
      inverse_D5_p319 * f13_y_p141;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p149 = s8 * f13_y_p147 + c8 * f13_y_p148 - inverse_D5_p329 * f13_y_p144;
  const Real f13_y_p150 = s9 * f13_y_p145 - c9 * f13_y_p146 - inverse_D5_p303 * f13_y_p141 +
      inverse_D5_p309 * f13_y_p144;
  const Real f13_y_p151 = c7 * f13_y_p149 + s7 * f13_y_p150;
  const Real f13_y_p152 = c8 * f13_y_p147 - s8 * f13_y_p148 + inverse_D5_p359 * f13_y_p144;
  const Real f13_y_p153 = s8 * f13_y_p142 - c8 * f13_y_p143 - inverse_D5_p370 * f13_y_p144;
  const Real f13_y_p154 = f13_y_p90 * f13_y_p144;
  const Real f13_y_p155 = 0.18 * f13_y_p151 - 0.226 * f13_y_p152 - s7 * f13_y_p153 + c7 *
      f13_y_p154;
  const Real f13_y_p156 = s7 * f13_y_p149 - c7 * f13_y_p150;

  // link 6 (chest3), force propagation
  const Real f13_y_p157 = f13_y_p156 + inverse_D5_p408 * f13_y_p155;
  const Real f13_y_p158 = 0.226 * f13_y_p156 - inverse_D5_p383 * f13_y_p155;
  const Real f13_y_p159 = 0.18 * f13_y_p156 + c7 * f13_y_p153 + s7 * f13_y_p154 - inverse_D5_p390 *
      f13_y_p155;
  const Real f13_y_p160 = 0.072 * f13_y_p157 + c6 * f13_y_p158 + s6 * f13_y_p159;

  // link 5 (chest2), force propagation
  const Real f13_y_p161 = s6 * f13_y_p158 - c6 * f13_y_p159 - inverse_D1_p35 * f13_y_p160;

  // link 6 (chest3), force propagation
  const Real f13_y_p162 = f13_y_p152 - inverse_D1_p2 * f13_y_p155;
  const Real f13_y_p163 = f13_y_p151 + inverse_D1_p11 * f13_y_p155;
  const Real f13_y_p164 = c6 * f13_y_p162 - s6 * f13_y_p163;

  // link 5 (chest2), force propagation
  const Real f13_y_p165 = 0.072 * f13_y_p164 - inverse_D1_p25 * f13_y_p160;
  const Real f13_y_p166 = c5 * f13_y_p161 + s5 * f13_y_p165;
  const Real f13_y_p167 = s6 * f13_y_p162 + c6 * f13_y_p163 - inverse_D1_p58 * f13_y_p160;
  const Real f13_y_p168 = f13_y_p157 - inverse_D1_p54 * f13_y_p160;
  const Real f13_y_p169 = s5 * f13_y_p167 + c5 * f13_y_p168;
  const Real f13_y_p170 = f13_y_p164 - inverse_D1_p42 * f13_y_p160;

  // link 4 (chest1), force propagation
  const Real f13_y_p171 = s4 * (0.21799999999999997 * f13_y_p170 - s5 * f13_y_p161 + c5 *
      f13_y_p165 + inverse_D3_p3 * f13_y_p166);
  const Real f13_y_p172 = c4 * (0.21799999999999997 * f13_y_p169 + inverse_D3_p1 * f13_y_p166) -
      f13_y_p171;

  // link 3 (hip), force propagation
  const Real f13_y_p173 = c5 * f13_y_p167 - s5 * f13_y_p168 - inverse_D1_p83 * f13_y_p166 -
      inverse_D1_p87 * f13_y_p172;
  const Real f13_y_p174 = s4 * (f13_y_p170 + inverse_D1_p48 * f13_y_p166) - c4 *
      (f13_y_p169 + inverse_D1_p67 * f13_y_p166) + inverse_D1_p89 * f13_y_p172;
  const Real f13_y_p175 = s3 * f13_y_p173 - c3 * f13_y_p174;
  const Real f13_y_p176 = 0.422 * f13_y_p175;

  // link 2 (thigh), force propagation
  const Real f13_y_p177 = s2 * (c3 * f13_y_p173 + s3 * f13_y_p174 + inverse_D1_p102 * f13_y_p176) +
      c2 * (f13_y_p175 - inverse_D1_p98 * f13_y_p176);
  const Real f13_y_p178 = 0.434 * f13_y_p177;

  // link 1 (calf), force propagation
  const Real f13_y_p179 = inverse_D1 * f13_y_p178;

  // link 2 (thigh), force propagation
  const Real f13_y_p180 = inverse_D2 * f13_y_p176;

  // link 3 (hip), force propagation
  const Real f13_y_p181 = inverse_D3 * f13_y_p172;

  // link 4 (chest1), force propagation
  const Real f13_y_p182 = inverse_D4 * f13_y_p166;

  // link 5 (chest2), force propagation
  const Real f13_y_p183 = inverse_D5 * f13_y_p160;

  // link 6 (chest3), force propagation
  const Real f13_y_p184 = inverse_D6 * f13_y_p155;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p185 = minus_inverse_D7 * f13_y_p144;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p186 = minus_inverse_D8 * f13_y_p141;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p187 = minus_inverse_D9 * f13_y_p134;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p188 = minus_inverse_D10 * f13_y_p131;

  // link 1 (calf), force propagation
  const Real f13_y_p189 = f13_y_p66 * f13_y_p188 + f13_y_p69 * f13_y_p187 + f13_y_p76 * f13_y_p186 +
      f13_y_p80 * f13_y_p185 + f13_y_p92 * f13_y_p184;
  const Real f13_y_p190 = f13_y_p189 + f13_y_p97 * f13_y_p183 + f13_y_p103 * f13_y_p182 +
      f13_y_p109 * f13_y_p181 + f13_y_p113 * f13_y_p180;
  const Real f13_y_p191 = f13_y_p190 + f13_y_p115 * f13_y_p179;
  const Real f13_y_p192 = f13_y_p155 * f13_y_p120 - f13_y_p160 * f13_y_p119 - f13_y_p166 *
      f13_y_p118 - f13_y_p172 * f13_y_p117 - f13_y_p176 * f13_y_p116;
  const Real f13_y_p193 = f13_y_p192 - f13_y_p178 * f13_y_p62 + f13_y_p191 * f13_y_p127;
  const Real f13_y_p194 = f13_y_p191 * f13_y_p126;
  const Real f13_y_p195 = f13_y_p131 * f13_y_p188 + f13_y_p134 * f13_y_p187 + f13_y_p141 *
      f13_y_p186 + f13_y_p144 * f13_y_p185 - f13_y_p155 * f13_y_p184;
  const Real f13_y_p196 = f13_y_p195 - f13_y_p160 * f13_y_p183 - f13_y_p166 * f13_y_p182 -
      f13_y_p172 * f13_y_p181 - f13_y_p176 * f13_y_p180;
  const Real f13_y_p197 = 1.0 / (f13_y_p196 - f13_y_p178 * f13_y_p179 - f13_y_p191 * f13_y_p194);
  const Real f13_y_p198 = f13_y_p193 * f13_y_p197;

  // link 12 (left_wrist2), force propagation
  const Real f13_y_p199 = 0.269 * c12;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p200 = c11 * f13_y_p199;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p201 = s11 * f13_y_p199 + inverse_D5_p231 * f13_y_p200;
  const Real f13_y_p202 = inverse_D5_p228 * f13_y_p200;
  const Real f13_y_p203 = c10 * f13_y_p202 + s10 * f13_y_p201;
  const Real f13_y_p204 = c11 * c12 - inverse_D5_p264 * f13_y_p200;
  const Real f13_y_p205 = s12 - inverse_D5_p273 * f13_y_p200;
  const Real f13_y_p206 = s10 * f13_y_p205 - c10 * f13_y_p204;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p207 = 0.282 * f13_y_p206 - minus_inverse_D8_p1 * f13_y_p203;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p208 = s11 * c12 - inverse_D5_p246 * f13_y_p200;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p209 = 0.282 * f13_y_p208 - s10 * f13_y_p202 + c10 * f13_y_p201 +
      minus_inverse_D8_p4 * f13_y_p203;
  const Real f13_y_p210 = s9 * f13_y_p207 - c9 * f13_y_p209;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p211 = c9 * f13_y_p207 + s9 * f13_y_p209 + minus_inverse_D7_p1 * f13_y_p210;
  const Real f13_y_p212 = f13_y_p78 * f13_y_p210;
  const Real f13_y_p213 = c8 * f13_y_p211 + s8 * f13_y_p212;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p214 = f13_y_p208 + inverse_D5_p253 * f13_y_p203;
  const Real f13_y_p215 = f13_y_p206 - inverse_D5_p281 * f13_y_p203;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p216 = c9 * f13_y_p214 - s9 * f13_y_p215 + inverse_D5_p322 * f13_y_p210;
  const Real f13_y_p217 = c10 * f13_y_p205 + s10 * f13_y_p204 - inverse_D5_p313 * f13_y_p203 +
      inverse_D5_p319 * f13_y_p210;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p218 = s8 * f13_y_p216 - c8 * f13_y_p217 + inverse_D5_p329 * f13_y_p213;
  const Real f13_y_p219 = s9 * f13_y_p214 + c9 * f13_y_p215 + inverse_D5_p303 * f13_y_p210 -
      inverse_D5_p309 * f13_y_p213;
  const Real f13_y_p220 = c7 * f13_y_p218 + s7 * f13_y_p219;
  const Real f13_y_p221 = c8 * f13_y_p216 + s8 * f13_y_p217 - inverse_D5_p359 * f13_y_p213;
  const Real f13_y_p222 = s8 * f13_y_p211 - c8 * f13_y_p212 - inverse_D5_p370 * f13_y_p213;
  const Real f13_y_p223 = f13_y_p90 * f13_y_p213;
  const Real f13_y_p224 = 0.18 * f13_y_p220 - 0.226 * f13_y_p221 + s7 * f13_y_p222 - c7 *
      f13_y_p223;
  const Real f13_y_p225 = s7 * f13_y_p218 - c7 * f13_y_p219;

  // link 6 (chest3), force propagation
  const Real f13_y_p226 = f13_y_p225 + inverse_D5_p408 * f13_y_p224;
  const Real f13_y_p227 = 0.226 * f13_y_p225 - inverse_D5_p383 * f13_y_p224;
  const Real f13_y_p228 = 0.18 * f13_y_p225 - c7 * f13_y_p222 - s7 * f13_y_p223 - inverse_D5_p390 *
      f13_y_p224;
  const Real f13_y_p229 = 0.072 * f13_y_p226 + c6 * f13_y_p227 + s6 * f13_y_p228;

  // link 5 (chest2), force propagation
  const Real f13_y_p230 = s6 * f13_y_p227 - c6 * f13_y_p228 - inverse_D1_p35 * f13_y_p229;

  // link 6 (chest3), force propagation
  const Real f13_y_p231 = f13_y_p221 - inverse_D1_p2 * f13_y_p224;
  const Real f13_y_p232 = f13_y_p220 + inverse_D1_p11 * f13_y_p224;
  const Real f13_y_p233 = c6 * f13_y_p231 - s6 * f13_y_p232;

  // link 5 (chest2), force propagation
  const Real f13_y_p234 = 0.072 * f13_y_p233 - inverse_D1_p25 * f13_y_p229;
  const Real f13_y_p235 = c5 * f13_y_p230 + s5 * f13_y_p234;
  const Real f13_y_p236 = s6 * f13_y_p231 + c6 * f13_y_p232 - inverse_D1_p58 * f13_y_p229;
  const Real f13_y_p237 = f13_y_p226 - inverse_D1_p54 * f13_y_p229;
  const Real f13_y_p238 = s5 * f13_y_p236 + c5 * f13_y_p237;
  const Real f13_y_p239 = f13_y_p233 - inverse_D1_p42 * f13_y_p229;

  // link 4 (chest1), force propagation
  const Real f13_y_p240 = s4 * (0.21799999999999997 * f13_y_p239 - s5 * f13_y_p230 + c5 *
      f13_y_p234 + inverse_D3_p3 * f13_y_p235);
  const Real f13_y_p241 = c4 * (0.21799999999999997 * f13_y_p238 + inverse_D3_p1 * f13_y_p235) -
      f13_y_p240;

  // link 3 (hip), force propagation
  const Real f13_y_p242 = c5 * f13_y_p236 - s5 * f13_y_p237 - inverse_D1_p83 * f13_y_p235 -
      inverse_D1_p87 * f13_y_p241;
  const Real f13_y_p243 = s4 * (f13_y_p239 + inverse_D1_p48 * f13_y_p235) - c4 *
      (f13_y_p238 + inverse_D1_p67 * f13_y_p235) + inverse_D1_p89 * f13_y_p241;
  const Real f13_y_p244 = s3 * f13_y_p242 - c3 * f13_y_p243;
  const Real f13_y_p245 = 0.422 * f13_y_p244;

  // link 2 (thigh), force propagation
  const Real f13_y_p246 = s2 * (c3 * f13_y_p242 + s3 * f13_y_p243 + inverse_D1_p102 * f13_y_p245) +
      c2 * (f13_y_p244 - inverse_D1_p98 * f13_y_p245);
  const Real f13_y_p247 = 0.434 * f13_y_p246;

  // link 1 (calf), force propagation
  const Real f13_y_p248 = inverse_D1 * f13_y_p247;

  // link 2 (thigh), force propagation
  const Real f13_y_p249 = inverse_D2 * f13_y_p245;

  // link 3 (hip), force propagation
  const Real f13_y_p250 = inverse_D3 * f13_y_p241;

  // link 4 (chest1), force propagation
  const Real f13_y_p251 = inverse_D4 * f13_y_p235;

  // link 5 (chest2), force propagation
  const Real f13_y_p252 = inverse_D5 * f13_y_p229;

  // link 6 (chest3), force propagation
  const Real f13_y_p253 = inverse_D6 * f13_y_p224;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p254 = minus_inverse_D7 * f13_y_p213;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p255 = minus_inverse_D8 * f13_y_p210;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p256 = minus_inverse_D9 * f13_y_p203;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p257 = minus_inverse_D10 * f13_y_p200;

  // link 1 (calf), force propagation
  const Real f13_y_p258 = f13_y_p66 * f13_y_p257 + f13_y_p69 * f13_y_p256 - f13_y_p76 * f13_y_p255 -
      f13_y_p80 * f13_y_p254 + f13_y_p92 * f13_y_p253;
  const Real f13_y_p259 = f13_y_p258 + f13_y_p97 * f13_y_p252 + f13_y_p103 * f13_y_p251 +
      f13_y_p109 * f13_y_p250 + f13_y_p113 * f13_y_p249;
  const Real f13_y_p260 = f13_y_p259 + f13_y_p115 * f13_y_p248;
  const Real f13_y_p261 = f13_y_p260 * f13_y_p126;
  const Real f13_y_p262 = f13_y_p131 * f13_y_p257 + f13_y_p134 * f13_y_p256 - f13_y_p141 *
      f13_y_p255 - f13_y_p144 * f13_y_p254 - f13_y_p155 * f13_y_p253;
  const Real f13_y_p263 = f13_y_p262 - f13_y_p160 * f13_y_p252 - f13_y_p166 * f13_y_p251 -
      f13_y_p172 * f13_y_p250 - f13_y_p176 * f13_y_p249;
  const Real f13_y_p264 = f13_y_p263 - f13_y_p178 * f13_y_p248 - f13_y_p191 * f13_y_p261;
  const Real f13_y_p265 = f13_y_p224 * f13_y_p120 - f13_y_p229 * f13_y_p119 - f13_y_p235 *
      f13_y_p118 - f13_y_p241 * f13_y_p117 - f13_y_p245 * f13_y_p116;
  const Real f13_y_p266 = f13_y_p265 - f13_y_p247 * f13_y_p62 + f13_y_p260 * f13_y_p127 -
      f13_y_p264 * f13_y_p198;
  const Real f13_y_p267 = f13_y_p264 * f13_y_p197;
  const Real f13_y_p268 = f13_y_p200 * f13_y_p257 + f13_y_p203 * f13_y_p256 + f13_y_p210 *
      f13_y_p255 + f13_y_p213 * f13_y_p254 - f13_y_p224 * f13_y_p253;
  const Real f13_y_p269 = f13_y_p268 - f13_y_p229 * f13_y_p252 - f13_y_p235 * f13_y_p251 -
      f13_y_p241 * f13_y_p250 - f13_y_p245 * f13_y_p249;
  const Real f13_y_p270 = 1.0 / (f13_y_p269 - f13_y_p247 * f13_y_p248 - f13_y_p260 * f13_y_p261 -
      f13_y_p264 * f13_y_p267);
  const Real f13_y_p271 = f13_y_p266 * f13_y_p270;

  // link 12 (left_wrist2), force propagation
  const Real f13_y_p272 = c13 + s13 * inverse_D11_p1;
  const Real f13_y_p273 = c12 * f13_y_p272;
  const Real f13_y_p274 = s13 * inverse_D5_p190;
  const Real f13_y_p275 = s13 * inverse_D5_p184;
  const Real f13_y_p276 = s12 * f13_y_p274 + c12 * f13_y_p275;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p277 = 0.269 * f13_y_p276 - inverse_D5_p205 * f13_y_p273;

  // link 12 (left_wrist2), force propagation
  const Real f13_y_p278 = s13 * inverse_D5_p196;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p279 = 0.269 * f13_y_p278 - s12 * f13_y_p272 + inverse_D5_p211 * f13_y_p273;
  const Real f13_y_p280 = c11 * f13_y_p277 - s11 * f13_y_p279;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p281 = s11 * f13_y_p277 + c11 * f13_y_p279 + inverse_D5_p231 * f13_y_p280;
  const Real f13_y_p282 = inverse_D5_p228 * f13_y_p280;
  const Real f13_y_p283 = c10 * f13_y_p282 + s10 * f13_y_p281;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p284 = f13_y_p276 - inverse_D5_p236 * f13_y_p273;
  const Real f13_y_p285 = f13_y_p278 + inverse_D5_p239 * f13_y_p273;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p286 = s11 * f13_y_p285 - c11 * f13_y_p284 + inverse_D5_p264 * f13_y_p280;
  const Real f13_y_p287 = c12 * f13_y_p274 - s12 * f13_y_p275 + inverse_D5_p268 * f13_y_p273 +
      inverse_D5_p273 * f13_y_p280;
  const Real f13_y_p288 = s10 * f13_y_p287 - c10 * f13_y_p286;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p289 = 0.282 * f13_y_p288 + minus_inverse_D8_p1 * f13_y_p283;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p290 = c11 * f13_y_p285 + s11 * f13_y_p284 - inverse_D5_p246 * f13_y_p280;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p291 = 0.282 * f13_y_p290 - s10 * f13_y_p282 + c10 * f13_y_p281 +
      minus_inverse_D8_p4 * f13_y_p283;
  const Real f13_y_p292 = s9 * f13_y_p289 + c9 * f13_y_p291;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p293 = c9 * f13_y_p289 - s9 * f13_y_p291 + minus_inverse_D7_p1 * f13_y_p292;
  const Real f13_y_p294 = f13_y_p78 * f13_y_p292;
  const Real f13_y_p295 = c8 * f13_y_p293 + s8 * f13_y_p294;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p296 = f13_y_p290 + inverse_D5_p253 * f13_y_p283;
  const Real f13_y_p297 = f13_y_p288 + inverse_D5_p281 * f13_y_p283;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p298 = c9 * f13_y_p296 + s9 * f13_y_p297 - inverse_D5_p322 * f13_y_p292;
  const Real f13_y_p299 = c10 * f13_y_p287 + s10 * f13_y_p286 + inverse_D5_p313 * f13_y_p283 +
      inverse_D5_p319 * f13_y_p292;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p300 = s8 * f13_y_p298 + c8 * f13_y_p299 - inverse_D5_p329 * f13_y_p295;
  const Real f13_y_p301 = s9 * f13_y_p296 - c9 * f13_y_p297 - inverse_D5_p303 * f13_y_p292 +
      inverse_D5_p309 * f13_y_p295;
  const Real f13_y_p302 = c7 * f13_y_p300 + s7 * f13_y_p301;
  const Real f13_y_p303 = c8 * f13_y_p298 - s8 * f13_y_p299 + inverse_D5_p359 * f13_y_p295;
  const Real f13_y_p304 = s8 * f13_y_p293 - c8 * f13_y_p294 - inverse_D5_p370 * f13_y_p295;
  const Real f13_y_p305 = f13_y_p90 * f13_y_p295;
  const Real f13_y_p306 = 0.18 * f13_y_p302 - 0.226 * f13_y_p303 - s7 * f13_y_p304 + c7 *
      f13_y_p305;
  const Real f13_y_p307 = s7 * f13_y_p300 - c7 * f13_y_p301;

  // link 6 (chest3), force propagation
  const Real f13_y_p308 = f13_y_p307 + inverse_D5_p408 * f13_y_p306;
  const Real f13_y_p309 = 0.226 * f13_y_p307 - inverse_D5_p383 * f13_y_p306;
  const Real f13_y_p310 = 0.18 * f13_y_p307 + c7 * f13_y_p304 + s7 * f13_y_p305 - inverse_D5_p390 *
      f13_y_p306;
  const Real f13_y_p311 = 0.072 * f13_y_p308 + c6 * f13_y_p309 + s6 * f13_y_p310;

  // link 5 (chest2), force propagation
  const Real f13_y_p312 = s6 * f13_y_p309 - c6 * f13_y_p310 - inverse_D1_p35 * f13_y_p311;

  // link 6 (chest3), force propagation
  const Real f13_y_p313 = f13_y_p303 - inverse_D1_p2 * f13_y_p306;
  const Real f13_y_p314 = f13_y_p302 + inverse_D1_p11 * f13_y_p306;
  const Real f13_y_p315 = c6 * f13_y_p313 - s6 * f13_y_p314;

  // link 5 (chest2), force propagation
  const Real f13_y_p316 = 0.072 * f13_y_p315 - inverse_D1_p25 * f13_y_p311;
  const Real f13_y_p317 = c5 * f13_y_p312 + s5 * f13_y_p316;
  const Real f13_y_p318 = s6 * f13_y_p313 + c6 * f13_y_p314 - inverse_D1_p58 * f13_y_p311;
  const Real f13_y_p319 = f13_y_p308 - inverse_D1_p54 * f13_y_p311;
  const Real f13_y_p320 = s5 * f13_y_p318 + c5 * f13_y_p319;
  const Real f13_y_p321 = f13_y_p315 - inverse_D1_p42 * f13_y_p311;

  // link 4 (chest1), force propagation
  const Real f13_y_p322 = s4 * (0.21799999999999997 * f13_y_p321 - s5 * f13_y_p312 + c5 *
      f13_y_p316 + inverse_D3_p3 * f13_y_p317);
  const Real f13_y_p323 = c4 * (0.21799999999999997 * f13_y_p320 + inverse_D3_p1 * f13_y_p317) -
      f13_y_p322;

  // link 3 (hip), force propagation
  const Real f13_y_p324 = c5 * f13_y_p318 - s5 * f13_y_p319 - inverse_D1_p83 * f13_y_p317 -
      inverse_D1_p87 * f13_y_p323;
  const Real f13_y_p325 = s4 * (f13_y_p321 + inverse_D1_p48 * f13_y_p317) - c4 *
      (f13_y_p320 + inverse_D1_p67 * f13_y_p317) + inverse_D1_p89 * f13_y_p323;
  const Real f13_y_p326 = s3 * f13_y_p324 - c3 * f13_y_p325;
  const Real f13_y_p327 = 0.422 * f13_y_p326;

  // link 2 (thigh), force propagation
  const Real f13_y_p328 = s2 * (c3 * f13_y_p324 + s3 * f13_y_p325 + inverse_D1_p102 * f13_y_p327) +
      c2 * (f13_y_p326 - inverse_D1_p98 * f13_y_p327);
  const Real f13_y_p329 = 0.434 * f13_y_p328;

  // link 1 (calf), force propagation
  const Real f13_y_p330 = inverse_D1 * f13_y_p329;

  // link 2 (thigh), force propagation
  const Real f13_y_p331 = inverse_D2 * f13_y_p327;

  // link 3 (hip), force propagation
  const Real f13_y_p332 = inverse_D3 * f13_y_p323;

  // link 4 (chest1), force propagation
  const Real f13_y_p333 = inverse_D4 * f13_y_p317;

  // link 5 (chest2), force propagation
  const Real f13_y_p334 = inverse_D5 * f13_y_p311;

  // link 6 (chest3), force propagation
  const Real f13_y_p335 = inverse_D6 * f13_y_p306;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p336 = minus_inverse_D7 * f13_y_p295;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p337 = minus_inverse_D8 * f13_y_p292;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p338 = minus_inverse_D9 * f13_y_p283;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p339 = minus_inverse_D10 * f13_y_p280;

  // link 1 (calf), force propagation
  const Real f13_y_p340 = f13_y_p66 * f13_y_p339 + f13_y_p69 * f13_y_p338 + f13_y_p76 * f13_y_p337 +
      f13_y_p80 * f13_y_p336 + f13_y_p92 * f13_y_p335;
  const Real f13_y_p341 = f13_y_p340 + f13_y_p97 * f13_y_p334 + f13_y_p103 * f13_y_p333 +
      f13_y_p109 * f13_y_p332 + f13_y_p113 * f13_y_p331;
  const Real f13_y_p342 = f13_y_p341 + f13_y_p115 * f13_y_p330;
  const Real f13_y_p343 = f13_y_p342 * f13_y_p126;
  const Real f13_y_p344 = f13_y_p131 * f13_y_p339 + f13_y_p134 * f13_y_p338 + f13_y_p141 *
      f13_y_p337 + f13_y_p144 * f13_y_p336 - f13_y_p155 * f13_y_p335;
  const Real f13_y_p345 = f13_y_p344 - f13_y_p160 * f13_y_p334 - f13_y_p166 * f13_y_p333 -
      f13_y_p172 * f13_y_p332 - f13_y_p176 * f13_y_p331;
  const Real f13_y_p346 = f13_y_p345 - f13_y_p178 * f13_y_p330 - f13_y_p191 * f13_y_p343;
  const Real f13_y_p347 = f13_y_p346 * f13_y_p197;
  const Real f13_y_p348 = f13_y_p200 * f13_y_p339 + f13_y_p203 * f13_y_p338 - f13_y_p210 *
      f13_y_p337 - f13_y_p213 * f13_y_p336 - f13_y_p224 * f13_y_p335;
  const Real f13_y_p349 = f13_y_p348 - f13_y_p229 * f13_y_p334 - f13_y_p235 * f13_y_p333 -
      f13_y_p241 * f13_y_p332 - f13_y_p245 * f13_y_p331;
  const Real f13_y_p350 = f13_y_p349 - f13_y_p247 * f13_y_p330 - f13_y_p260 * f13_y_p343 -
      f13_y_p264 * f13_y_p347;
  const Real f13_y_p351 = f13_y_p306 * f13_y_p120 - f13_y_p311 * f13_y_p119 - f13_y_p317 *
      f13_y_p118 - f13_y_p323 * f13_y_p117 - f13_y_p327 * f13_y_p116;
  const Real f13_y_p352 = f13_y_p351 - f13_y_p329 * f13_y_p62 + f13_y_p342 * f13_y_p127 -
      f13_y_p346 * f13_y_p198 - f13_y_p350 * f13_y_p271;
  const Real f13_y_p353 = f13_y_p350 * f13_y_p270;
  const Real f13_y_p354 = inverse_D12 * (s13 * s13) + f13_y_p273 * (inverse_D11 * f13_y_p273) -
      f13_y_p280 * f13_y_p339 - f13_y_p283 * f13_y_p338;
  const Real f13_y_p355 = f13_y_p354 - f13_y_p292 * f13_y_p337 - f13_y_p295 * f13_y_p336 +
      f13_y_p306 * f13_y_p335 + f13_y_p311 * f13_y_p334;
  const Real f13_y_p356 = f13_y_p355 + f13_y_p317 * f13_y_p333 + f13_y_p323 * f13_y_p332 +
      f13_y_p327 * f13_y_p331 + f13_y_p329 * f13_y_p330;
  const Real f13_y_p357 = 1.0 / (f13_y_p356 + f13_y_p342 * f13_y_p343 + f13_y_p346 * f13_y_p347 +
      f13_y_p350 * f13_y_p353);
  const Real f13_y_p358 = f13_y_p352 * f13_y_p357;

  // link 12 (left_wrist2), force propagation
  const Real f13_y_p359 = s13 - c13 * inverse_D11_p1;
  const Real f13_y_p360 = c12 * f13_y_p359;
  const Real f13_y_p361 = c13 * inverse_D5_p190;
  const Real f13_y_p362 = c13 * inverse_D5_p184;
  const Real f13_y_p363 = s12 * f13_y_p361 + c12 * f13_y_p362;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p364 = 0.269 * f13_y_p363 + inverse_D5_p205 * f13_y_p360;

  // link 12 (left_wrist2), force propagation
  const Real f13_y_p365 = c13 * inverse_D5_p196;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p366 = 0.269 * f13_y_p365 + s12 * f13_y_p359 - inverse_D5_p211 * f13_y_p360;
  const Real f13_y_p367 = c11 * f13_y_p364 - s11 * f13_y_p366;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p368 = s11 * f13_y_p364 + c11 * f13_y_p366 + inverse_D5_p231 * f13_y_p367;
  const Real f13_y_p369 = inverse_D5_p228 * f13_y_p367;
  const Real f13_y_p370 = c10 * f13_y_p369 + s10 * f13_y_p368;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p371 = f13_y_p363 + inverse_D5_p236 * f13_y_p360;
  const Real f13_y_p372 = f13_y_p365 - inverse_D5_p239 * f13_y_p360;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p373 = s11 * f13_y_p372 - c11 * f13_y_p371 + inverse_D5_p264 * f13_y_p367;
  const Real f13_y_p374 = c12 * f13_y_p361 - s12 * f13_y_p362 - inverse_D5_p268 * f13_y_p360 +
      inverse_D5_p273 * f13_y_p367;
  const Real f13_y_p375 = s10 * f13_y_p374 - c10 * f13_y_p373;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p376 = 0.282 * f13_y_p375 + minus_inverse_D8_p1 * f13_y_p370;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p377 = c11 * f13_y_p372 + s11 * f13_y_p371 - inverse_D5_p246 * f13_y_p367;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p378 = 0.282 * f13_y_p377 - s10 * f13_y_p369 + c10 * f13_y_p368 +
      minus_inverse_D8_p4 * f13_y_p370;
  const Real f13_y_p379 = s9 * f13_y_p376 + c9 * f13_y_p378;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p380 = c9 * f13_y_p376 - s9 * f13_y_p378 + minus_inverse_D7_p1 * f13_y_p379;
  const Real f13_y_p381 = f13_y_p78 * f13_y_p379;
  const Real f13_y_p382 = c8 * f13_y_p380 + s8 * f13_y_p381;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p383 = f13_y_p377 + inverse_D5_p253 * f13_y_p370;
  const Real f13_y_p384 = f13_y_p375 + inverse_D5_p281 * f13_y_p370;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p385 = c9 * f13_y_p383 + s9 * f13_y_p384 - inverse_D5_p322 * f13_y_p379;
  const Real f13_y_p386 = c10 * f13_y_p374 + s10 * f13_y_p373 + inverse_D5_p313 * f13_y_p370 +
      inverse_D5_p319 * f13_y_p379;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p387 = s8 * f13_y_p385 + c8 * f13_y_p386 - inverse_D5_p329 * f13_y_p382;
  const Real f13_y_p388 = s9 * f13_y_p383 - c9 * f13_y_p384 - inverse_D5_p303 * f13_y_p379 +
      inverse_D5_p309 * f13_y_p382;
  const Real f13_y_p389 = c7 * f13_y_p387 + s7 * f13_y_p388;
  const Real f13_y_p390 = c8 * f13_y_p385 - s8 * f13_y_p386 + inverse_D5_p359 * f13_y_p382;
  const Real f13_y_p391 = s8 * f13_y_p380 - c8 * f13_y_p381 - inverse_D5_p370 * f13_y_p382;
  const Real f13_y_p392 = f13_y_p90 * f13_y_p382;
  const Real f13_y_p393 = 0.18 * f13_y_p389 - 0.226 * f13_y_p390 - s7 * f13_y_p391 + c7 *
      f13_y_p392;
  const Real f13_y_p394 = s7 * f13_y_p387 - c7 * f13_y_p388;

  // link 6 (chest3), force propagation
  const Real f13_y_p395 = f13_y_p394 + inverse_D5_p408 * f13_y_p393;
  const Real f13_y_p396 = 0.226 * f13_y_p394 - inverse_D5_p383 * f13_y_p393;
  const Real f13_y_p397 = 0.18 * f13_y_p394 + c7 * f13_y_p391 + s7 * f13_y_p392 - inverse_D5_p390 *
      f13_y_p393;
  const Real f13_y_p398 = 0.072 * f13_y_p395 + c6 * f13_y_p396 + s6 * f13_y_p397;

  // link 5 (chest2), force propagation
  const Real f13_y_p399 = s6 * f13_y_p396 - c6 * f13_y_p397 - inverse_D1_p35 * f13_y_p398;

  // link 6 (chest3), force propagation
  const Real f13_y_p400 = f13_y_p390 - inverse_D1_p2 * f13_y_p393;
  const Real f13_y_p401 = f13_y_p389 + inverse_D1_p11 * f13_y_p393;
  const Real f13_y_p402 = c6 * f13_y_p400 - s6 * f13_y_p401;

  // link 5 (chest2), force propagation
  const Real f13_y_p403 = 0.072 * f13_y_p402 - inverse_D1_p25 * f13_y_p398;
  const Real f13_y_p404 = c5 * f13_y_p399 + s5 * f13_y_p403;
  const Real f13_y_p405 = s6 * f13_y_p400 + c6 * f13_y_p401 - inverse_D1_p58 * f13_y_p398;
  const Real f13_y_p406 = f13_y_p395 - inverse_D1_p54 * f13_y_p398;
  const Real f13_y_p407 = s5 * f13_y_p405 + c5 * f13_y_p406;
  const Real f13_y_p408 = f13_y_p402 - inverse_D1_p42 * f13_y_p398;

  // link 4 (chest1), force propagation
  const Real f13_y_p409 = s4 * (0.21799999999999997 * f13_y_p408 - s5 * f13_y_p399 + c5 *
      f13_y_p403 + inverse_D3_p3 * f13_y_p404);
  const Real f13_y_p410 = c4 * (0.21799999999999997 * f13_y_p407 + inverse_D3_p1 * f13_y_p404) -
      f13_y_p409;

  // link 3 (hip), force propagation
  const Real f13_y_p411 = c5 * f13_y_p405 - s5 * f13_y_p406 - inverse_D1_p83 * f13_y_p404 -
      inverse_D1_p87 * f13_y_p410;
  const Real f13_y_p412 = s4 * (f13_y_p408 + inverse_D1_p48 * f13_y_p404) - c4 *
      (f13_y_p407 + inverse_D1_p67 * f13_y_p404) + inverse_D1_p89 * f13_y_p410;
  const Real f13_y_p413 = s3 * f13_y_p411 - c3 * f13_y_p412;
  const Real f13_y_p414 = 0.422 * f13_y_p413;

  // link 2 (thigh), force propagation
  const Real f13_y_p415 = s2 * (c3 * f13_y_p411 + s3 * f13_y_p412 + inverse_D1_p102 * f13_y_p414) +
      c2 * (f13_y_p413 - inverse_D1_p98 * f13_y_p414);
  const Real f13_y_p416 = 0.434 * f13_y_p415;

  // link 1 (calf), force propagation
  const Real f13_y_p417 = inverse_D1 * f13_y_p416;

  // link 2 (thigh), force propagation
  const Real f13_y_p418 = inverse_D2 * f13_y_p414;

  // link 3 (hip), force propagation
  const Real f13_y_p419 = inverse_D3 * f13_y_p410;

  // link 4 (chest1), force propagation
  const Real f13_y_p420 = inverse_D4 * f13_y_p404;

  // link 5 (chest2), force propagation
  const Real f13_y_p421 = inverse_D5 * f13_y_p398;

  // link 6 (chest3), force propagation
  const Real f13_y_p422 = inverse_D6 * f13_y_p393;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p423 = minus_inverse_D7 * f13_y_p382;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p424 = minus_inverse_D8 * f13_y_p379;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p425 = minus_inverse_D9 * f13_y_p370;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p426 = minus_inverse_D10 * f13_y_p367;

  // link 1 (calf), force propagation
  const Real f13_y_p427 = f13_y_p66 * f13_y_p426 + f13_y_p69 * f13_y_p425 + f13_y_p76 * f13_y_p424 +
      f13_y_p80 * f13_y_p423 + f13_y_p92 * f13_y_p422;
  const Real f13_y_p428 = f13_y_p427 + f13_y_p97 * f13_y_p421 + f13_y_p103 * f13_y_p420 +
      f13_y_p109 * f13_y_p419 + f13_y_p113 * f13_y_p418;
  const Real f13_y_p429 = f13_y_p428 + f13_y_p115 * f13_y_p417;
  const Real f13_y_p430 = f13_y_p429 * f13_y_p126;
  const Real f13_y_p431 = f13_y_p131 * f13_y_p426 + f13_y_p134 * f13_y_p425 + f13_y_p141 *
      f13_y_p424 + f13_y_p144 * f13_y_p423 - f13_y_p155 * f13_y_p422;
  const Real f13_y_p432 = f13_y_p431 - f13_y_p160 * f13_y_p421 - f13_y_p166 * f13_y_p420 -
      f13_y_p172 * f13_y_p419 - f13_y_p176 * f13_y_p418;
  const Real f13_y_p433 = f13_y_p432 - f13_y_p178 * f13_y_p417 - f13_y_p191 * f13_y_p430;
  const Real f13_y_p434 = f13_y_p433 * f13_y_p197;
  const Real f13_y_p435 = f13_y_p200 * f13_y_p426 + f13_y_p203 * f13_y_p425 - f13_y_p210 *
      f13_y_p424 - f13_y_p213 * f13_y_p423 - f13_y_p224 * f13_y_p422;
  const Real f13_y_p436 = f13_y_p435 - f13_y_p229 * f13_y_p421 - f13_y_p235 * f13_y_p420 -
      f13_y_p241 * f13_y_p419 - f13_y_p245 * f13_y_p418;
  const Real f13_y_p437 = f13_y_p436 - f13_y_p247 * f13_y_p417 - f13_y_p260 * f13_y_p430 -
      f13_y_p264 * f13_y_p434;
  const Real f13_y_p438 = f13_y_p437 * f13_y_p270;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p439 = inverse_D11 * f13_y_p360;

  // link 12 (left_wrist2), force propagation
  const Real f13_y_p440 = c13 * inverse_D12;

  // link 1 (calf), force propagation
  const Real f13_y_p441 = s13 * f13_y_p440 - f13_y_p273 * f13_y_p439 - f13_y_p280 * f13_y_p426 -
      f13_y_p283 * f13_y_p425 - f13_y_p292 * f13_y_p424;
  const Real f13_y_p442 = f13_y_p441 - f13_y_p295 * f13_y_p423 + f13_y_p306 * f13_y_p422 +
      f13_y_p311 * f13_y_p421 + f13_y_p317 * f13_y_p420;
  const Real f13_y_p443 = f13_y_p442 + f13_y_p323 * f13_y_p419 + f13_y_p327 * f13_y_p418 +
      f13_y_p329 * f13_y_p417 + f13_y_p342 * f13_y_p430;
  const Real f13_y_p444 = f13_y_p443 + f13_y_p346 * f13_y_p434 + f13_y_p350 * f13_y_p438;
  const Real f13_y_p445 = f13_y_p393 * f13_y_p120 - f13_y_p398 * f13_y_p119 - f13_y_p404 *
      f13_y_p118 - f13_y_p410 * f13_y_p117 - f13_y_p414 * f13_y_p116;
  const Real f13_y_p446 = f13_y_p445 - f13_y_p416 * f13_y_p62 + f13_y_p429 * f13_y_p127 -
      f13_y_p433 * f13_y_p198 - f13_y_p437 * f13_y_p271;
  const Real f13_y_p447 = f13_y_p446 - f13_y_p444 * f13_y_p358;
  const Real f13_y_p448 = f13_y_p444 * f13_y_p357;
  const Real f13_y_p449 = c13 * f13_y_p440 + f13_y_p360 * f13_y_p439 - f13_y_p367 * f13_y_p426 -
      f13_y_p370 * f13_y_p425 - f13_y_p379 * f13_y_p424;
  const Real f13_y_p450 = f13_y_p449 - f13_y_p382 * f13_y_p423 + f13_y_p393 * f13_y_p422 +
      f13_y_p398 * f13_y_p421 + f13_y_p404 * f13_y_p420;
  const Real f13_y_p451 = f13_y_p450 + f13_y_p410 * f13_y_p419 + f13_y_p414 * f13_y_p418 +
      f13_y_p416 * f13_y_p417 + f13_y_p429 * f13_y_p430;
  const Real f13_y_p452 = 1.0 / (f13_y_p451 + f13_y_p433 * f13_y_p434 + f13_y_p437 * f13_y_p438 -
      f13_y_p444 * f13_y_p448);
  const Real f13_y_p453 = f13_y_p447 * f13_y_p452;

  // link 13 (left_hand), force propagation
  const Real f13_y_p454 = 0.04672761636452121 * c13 - 0.11533812622014242 * s13;

  // link 12 (left_wrist2), force propagation
  const Real f13_y_p455 = 0.04672761636452121 * s13 + 0.11533812622014242 * c13 - inverse_D11_p1 *
      f13_y_p454;
  const Real f13_y_p456 = c12 * f13_y_p455;
  const Real f13_y_p457 = 17.32841575379867 * s13 - 3.0523172236718206 * c13 + inverse_D5_p190 *
      f13_y_p454;
  const Real f13_y_p458 = inverse_D5_p184 * f13_y_p454;
  const Real f13_y_p459 = s12 * f13_y_p457 + c12 * f13_y_p458;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p460 = 0.269 * f13_y_p459 + inverse_D5_p205 * f13_y_p456;

  // link 12 (left_wrist2), force propagation
  const Real f13_y_p461 = 17.32841575379867 * c13 + 3.0523172236718206 * s13 + inverse_D5_p196 *
      f13_y_p454;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p462 = 0.269 * f13_y_p461 + s12 * f13_y_p455 - inverse_D5_p211 * f13_y_p456;
  const Real f13_y_p463 = c11 * f13_y_p460 - s11 * f13_y_p462;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p464 = s11 * f13_y_p460 + c11 * f13_y_p462 + inverse_D5_p231 * f13_y_p463;
  const Real f13_y_p465 = inverse_D5_p228 * f13_y_p463;
  const Real f13_y_p466 = c10 * f13_y_p465 + s10 * f13_y_p464;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p467 = f13_y_p459 + inverse_D5_p236 * f13_y_p456;
  const Real f13_y_p468 = f13_y_p461 - inverse_D5_p239 * f13_y_p456;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p469 = s11 * f13_y_p468 - c11 * f13_y_p467 + inverse_D5_p264 * f13_y_p463;
  const Real f13_y_p470 = c12 * f13_y_p457 - s12 * f13_y_p458 - inverse_D5_p268 * f13_y_p456 +
      inverse_D5_p273 * f13_y_p463;
  const Real f13_y_p471 = s10 * f13_y_p470 - c10 * f13_y_p469;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p472 = 0.282 * f13_y_p471 + minus_inverse_D8_p1 * f13_y_p466;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p473 = c11 * f13_y_p468 + s11 * f13_y_p467 - inverse_D5_p246 * f13_y_p463;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p474 = 0.282 * f13_y_p473 - s10 * f13_y_p465 + c10 * f13_y_p464 +
      minus_inverse_D8_p4 * f13_y_p466;
  const Real f13_y_p475 = s9 * f13_y_p472 + c9 * f13_y_p474;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p476 = c9 * f13_y_p472 - s9 * f13_y_p474 + minus_inverse_D7_p1 * f13_y_p475;
  const Real f13_y_p477 = f13_y_p78 * f13_y_p475;
  const Real f13_y_p478 = c8 * f13_y_p476 + s8 * f13_y_p477;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p479 = f13_y_p473 + inverse_D5_p253 * f13_y_p466;
  const Real f13_y_p480 = f13_y_p471 + inverse_D5_p281 * f13_y_p466;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p481 = c9 * f13_y_p479 + s9 * f13_y_p480 - inverse_D5_p322 * f13_y_p475;
  const Real f13_y_p482 = c10 * f13_y_p470 + s10 * f13_y_p469 + inverse_D5_p313 * f13_y_p466 +
      inverse_D5_p319 * f13_y_p475;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p483 = s8 * f13_y_p481 + c8 * f13_y_p482 - inverse_D5_p329 * f13_y_p478;
  const Real f13_y_p484 = s9 * f13_y_p479 - c9 * f13_y_p480 - inverse_D5_p303 * f13_y_p475 +
      inverse_D5_p309 * f13_y_p478;
  const Real f13_y_p485 = c7 * f13_y_p483 + s7 * f13_y_p484;
  const Real f13_y_p486 = c8 * f13_y_p481 - s8 * f13_y_p482 + inverse_D5_p359 * f13_y_p478;
  const Real f13_y_p487 = s8 * f13_y_p476 - c8 * f13_y_p477 - inverse_D5_p370 * f13_y_p478;
  const Real f13_y_p488 = f13_y_p90 * f13_y_p478;
  const Real f13_y_p489 = 0.18 * f13_y_p485 - 0.226 * f13_y_p486 - s7 * f13_y_p487 + c7 *
      f13_y_p488;
  const Real f13_y_p490 = s7 * f13_y_p483 - c7 * f13_y_p484;

  // link 6 (chest3), force propagation
  const Real f13_y_p491 = f13_y_p490 + inverse_D5_p408 * f13_y_p489;
  const Real f13_y_p492 = 0.226 * f13_y_p490 - inverse_D5_p383 * f13_y_p489;
  const Real f13_y_p493 = 0.18 * f13_y_p490 + c7 * f13_y_p487 + s7 * f13_y_p488 - inverse_D5_p390 *
      f13_y_p489;
  const Real f13_y_p494 = 0.072 * f13_y_p491 + c6 * f13_y_p492 + s6 * f13_y_p493;

  // link 5 (chest2), force propagation
  const Real f13_y_p495 = s6 * f13_y_p492 - c6 * f13_y_p493 - inverse_D1_p35 * f13_y_p494;

  // link 6 (chest3), force propagation
  const Real f13_y_p496 = f13_y_p486 - inverse_D1_p2 * f13_y_p489;
  const Real f13_y_p497 = f13_y_p485 + inverse_D1_p11 * f13_y_p489;
  const Real f13_y_p498 = c6 * f13_y_p496 - s6 * f13_y_p497;

  // link 5 (chest2), force propagation
  const Real f13_y_p499 = 0.072 * f13_y_p498 - inverse_D1_p25 * f13_y_p494;
  const Real f13_y_p500 = c5 * f13_y_p495 + s5 * f13_y_p499;
  const Real f13_y_p501 = s6 * f13_y_p496 + c6 * f13_y_p497 - inverse_D1_p58 * f13_y_p494;
  const Real f13_y_p502 = f13_y_p491 - inverse_D1_p54 * f13_y_p494;
  const Real f13_y_p503 = s5 * f13_y_p501 + c5 * f13_y_p502;
  const Real f13_y_p504 = f13_y_p498 - inverse_D1_p42 * f13_y_p494;

  // link 4 (chest1), force propagation
  const Real f13_y_p505 = s4 * (0.21799999999999997 * f13_y_p504 - s5 * f13_y_p495 + c5 *
      f13_y_p499 + inverse_D3_p3 * f13_y_p500);
  const Real f13_y_p506 = c4 * (0.21799999999999997 * f13_y_p503 + inverse_D3_p1 * f13_y_p500) -
      f13_y_p505;

  // link 3 (hip), force propagation
  const Real f13_y_p507 = c5 * f13_y_p501 - s5 * f13_y_p502 - inverse_D1_p83 * f13_y_p500 -
      inverse_D1_p87 * f13_y_p506;
  const Real f13_y_p508 = s4 * (f13_y_p504 + inverse_D1_p48 * f13_y_p500) - c4 *
      (f13_y_p503 + inverse_D1_p67 * f13_y_p500) + inverse_D1_p89 * f13_y_p506;
  const Real f13_y_p509 = s3 * f13_y_p507 - c3 * f13_y_p508;
  const Real f13_y_p510 = 0.422 * f13_y_p509;

  // link 2 (thigh), force propagation
  const Real f13_y_p511 = s2 * (c3 * f13_y_p507 + s3 * f13_y_p508 + inverse_D1_p102 * f13_y_p510) +
      c2 * (f13_y_p509 - inverse_D1_p98 * f13_y_p510);
  const Real f13_y_p512 = 0.434 * f13_y_p511;

  // link 1 (calf), force propagation
  const Real f13_y_p513 = inverse_D1 * f13_y_p512;

  // link 2 (thigh), force propagation
  const Real f13_y_p514 = inverse_D2 * f13_y_p510;

  // link 3 (hip), force propagation
  const Real f13_y_p515 = inverse_D3 * f13_y_p506;

  // link 4 (chest1), force propagation
  const Real f13_y_p516 = inverse_D4 * f13_y_p500;

  // link 5 (chest2), force propagation
  const Real f13_y_p517 = inverse_D5 * f13_y_p494;

  // link 6 (chest3), force propagation
  const Real f13_y_p518 = inverse_D6 * f13_y_p489;

  // link 7 (left_shoulder1), force propagation
  const Real f13_y_p519 = minus_inverse_D7 * f13_y_p478;

  // link 8 (left_shoulder2), force propagation
  const Real f13_y_p520 = minus_inverse_D8 * f13_y_p475;

  // link 9 (left_upperarm), force propagation
  const Real f13_y_p521 = minus_inverse_D9 * f13_y_p466;

  // link 10 (left_lowerarm), force propagation
  const Real f13_y_p522 = minus_inverse_D10 * f13_y_p463;

  // link 1 (calf), force propagation
  const Real f13_y_p523 = f13_y_p66 * f13_y_p522 + f13_y_p69 * f13_y_p521 + f13_y_p76 * f13_y_p520 +
      f13_y_p80 * f13_y_p519 + f13_y_p92 * f13_y_p518;
  const Real f13_y_p524 = f13_y_p523 + f13_y_p97 * f13_y_p517 + f13_y_p103 * f13_y_p516 +
      f13_y_p109 * f13_y_p515 + f13_y_p113 * f13_y_p514;
  const Real f13_y_p525 = f13_y_p524 + f13_y_p115 * f13_y_p513;
  const Real f13_y_p526 = f13_y_p525 * f13_y_p126;
  const Real f13_y_p527 = f13_y_p131 * f13_y_p522 + f13_y_p134 * f13_y_p521 + f13_y_p141 *
      f13_y_p520 + f13_y_p144 * f13_y_p519 - f13_y_p155 * f13_y_p518;
  const Real f13_y_p528 = f13_y_p527 - f13_y_p160 * f13_y_p517 - f13_y_p166 * f13_y_p516 -
      f13_y_p172 * f13_y_p515 - f13_y_p176 * f13_y_p514;
  const Real f13_y_p529 = f13_y_p528 - f13_y_p178 * f13_y_p513 - f13_y_p191 * f13_y_p526;
  const Real f13_y_p530 = f13_y_p529 * f13_y_p197;
  const Real f13_y_p531 = f13_y_p200 * f13_y_p522 + f13_y_p203 * f13_y_p521 - f13_y_p210 *
      f13_y_p520 - f13_y_p213 * f13_y_p519 - f13_y_p224 * f13_y_p518;
  const Real f13_y_p532 = f13_y_p531 - f13_y_p229 * f13_y_p517 - f13_y_p235 * f13_y_p516 -
      f13_y_p241 * f13_y_p515 - f13_y_p245 * f13_y_p514;
  const Real f13_y_p533 = f13_y_p532 - f13_y_p247 * f13_y_p513 - f13_y_p260 * f13_y_p526 -
      f13_y_p264 * f13_y_p530;
  const Real f13_y_p534 = f13_y_p533 * f13_y_p270;

  // link 11 (left_wrist1), force propagation
  const Real f13_y_p535 = inverse_D11 * f13_y_p456;

  // link 12 (left_wrist2), force propagation
  const Real f13_y_p536 = inverse_D12 * f13_y_p454;

  // link 1 (calf), force propagation
  const Real f13_y_p537 = s13 * f13_y_p536 - f13_y_p273 * f13_y_p535 - f13_y_p280 * f13_y_p522 -
      f13_y_p283 * f13_y_p521 - f13_y_p292 * f13_y_p520;
  const Real f13_y_p538 = f13_y_p537 - f13_y_p295 * f13_y_p519 + f13_y_p306 * f13_y_p518 +
      f13_y_p311 * f13_y_p517 + f13_y_p317 * f13_y_p516;
  const Real f13_y_p539 = f13_y_p538 + f13_y_p323 * f13_y_p515 + f13_y_p327 * f13_y_p514 +
      f13_y_p329 * f13_y_p513 + f13_y_p342 * f13_y_p526;
  const Real f13_y_p540 = f13_y_p539 + f13_y_p346 * f13_y_p530 + f13_y_p350 * f13_y_p534;
  const Real f13_y_p541 = f13_y_p540 * f13_y_p357;
  const Real f13_y_p542 = c13 * f13_y_p536 + f13_y_p360 * f13_y_p535 - f13_y_p367 * f13_y_p522 -
      f13_y_p370 * f13_y_p521 - f13_y_p379 * f13_y_p520;
  const Real f13_y_p543 = f13_y_p542 - f13_y_p382 * f13_y_p519 + f13_y_p393 * f13_y_p518 +
      f13_y_p398 * f13_y_p517 + f13_y_p404 * f13_y_p516;
  const Real f13_y_p544 = f13_y_p543 + f13_y_p410 * f13_y_p515 + f13_y_p414 * f13_y_p514 +
      f13_y_p416 * f13_y_p513 + f13_y_p429 * f13_y_p526;
  const Real f13_y_p545 = f13_y_p544 + f13_y_p433 * f13_y_p530 + f13_y_p437 * f13_y_p534 -
      f13_y_p444 * f13_y_p541;
  const Real f13_y_p546 = f13_y_p489 * f13_y_p120 - f13_y_p494 * f13_y_p119 - f13_y_p500 *
      f13_y_p118 - f13_y_p506 * f13_y_p117 - f13_y_p510 * f13_y_p116;
  const Real f13_y_p547 = f13_y_p546 - f13_y_p512 * f13_y_p62 + f13_y_p525 * f13_y_p127 -
      f13_y_p529 * f13_y_p198 - f13_y_p533 * f13_y_p271;
  const Real f13_y_p548 = f13_y_p547 - f13_y_p540 * f13_y_p358 - f13_y_p545 * f13_y_p453;
  const Real f13_y_p549 = f13_y_p545 * f13_y_p452;
  const Real f13_y_p550 = 1065.380700001509 + f13_y_p454 * f13_y_p536 + f13_y_p456 * f13_y_p535 -
      f13_y_p463 * f13_y_p522 - f13_y_p466 * f13_y_p521;
  const Real f13_y_p551 = f13_y_p550 - f13_y_p475 * f13_y_p520 - f13_y_p478 * f13_y_p519 +
      f13_y_p489 * f13_y_p518 + f13_y_p494 * f13_y_p517;
  const Real f13_y_p552 = f13_y_p551 + f13_y_p500 * f13_y_p516 + f13_y_p506 * f13_y_p515 +
      f13_y_p510 * f13_y_p514 + f13_y_p512 * f13_y_p513;
  const Real f13_y_p553 = f13_y_p552 + f13_y_p525 * f13_y_p526 + f13_y_p529 * f13_y_p530 +
      f13_y_p533 * f13_y_p534 - f13_y_p540 * f13_y_p541;
  const Real f13_y_p554 = 1.0 / (f13_y_p553 - f13_y_p545 * f13_y_p549);
  const Real f13_y_p555 = f13_y_p548 * f13_y_p554;

  // link 19 (right_wrist2), force propagation
  const Real f13_y_p556 = s19 * c20;
  const Real f13_y_p557 = 0.269 * f13_y_p556;
  const Real f13_y_p558 = 0.269 * s20;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p559 = c18 * f13_y_p557 + s18 * f13_y_p558;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p560 = s18 * f13_y_p557 - c18 * f13_y_p558 + inverse_D5_p49 * f13_y_p559;
  const Real f13_y_p561 = inverse_D5_p46 * f13_y_p559;
  const Real f13_y_p562 = c17 * f13_y_p561 + s17 * f13_y_p560;
  const Real f13_y_p563 = s18 * s20 + c18 * f13_y_p556 - inverse_D5_p82 * f13_y_p559;
  const Real f13_y_p564 = c19 * c20 - inverse_D5_p91 * f13_y_p559;
  const Real f13_y_p565 = s17 * f13_y_p564 + c17 * f13_y_p563;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p566 = 0.282 * f13_y_p565 - inverse_D15_p1 * f13_y_p562;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p567 = c18 * s20 - s18 * f13_y_p556 + inverse_D5_p64 * f13_y_p559;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p568 = 0.282 * f13_y_p567 + s17 * f13_y_p561 - c17 * f13_y_p560 -
      inverse_D15_p4 * f13_y_p562;
  const Real f13_y_p569 = s16 * f13_y_p566 - c16 * f13_y_p568;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p570 = c16 * f13_y_p566 + s16 * f13_y_p568 + inverse_D14_p1 * f13_y_p569;
  const Real f13_y_p571 = f13_y_p24 * f13_y_p569;
  const Real f13_y_p572 = c15 * f13_y_p570 - s15 * f13_y_p571;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p573 = f13_y_p567 - inverse_D5_p71 * f13_y_p562;
  const Real f13_y_p574 = f13_y_p565 - inverse_D5_p99 * f13_y_p562;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p575 = c16 * f13_y_p573 - s16 * f13_y_p574 + inverse_D5_p140 * f13_y_p569;
  const Real f13_y_p576 = c17 * f13_y_p564 - s17 * f13_y_p563 + inverse_D5_p131 * f13_y_p562 +
      inverse_D5_p137 * f13_y_p569;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p577 = s15 * f13_y_p575 - c15 * f13_y_p576 - inverse_D5_p147 * f13_y_p572;
  const Real f13_y_p578 = s16 * f13_y_p573 + c16 * f13_y_p574 + inverse_D5_p121 * f13_y_p569 +
      inverse_D5_p127 * f13_y_p572;
  const Real f13_y_p579 = c14 * f13_y_p577 + s14 * f13_y_p578;
  const Real f13_y_p580 = c15 * f13_y_p575 + s15 * f13_y_p576 - inverse_D5_p177 * f13_y_p572;
  const Real f13_y_p581 = s15 * f13_y_p570 + c15 * f13_y_p571 - inverse_D5_p365 * f13_y_p572;
  const Real f13_y_p582 = f13_y_p36 * f13_y_p572;
  const Real f13_y_p583 = 0.18 * f13_y_p579 + 0.226 * f13_y_p580 - s14 * f13_y_p581 + c14 *
      f13_y_p582;
  const Real f13_y_p584 = s14 * f13_y_p577 - c14 * f13_y_p578;

  // link 6 (chest3), force propagation
  const Real f13_y_p585 = f13_y_p584 - inverse_D5_p408 * f13_y_p583;
  const Real f13_y_p586 = 0.226 * f13_y_p584 + inverse_D5_p383 * f13_y_p583;
  const Real f13_y_p587 = 0.18 * f13_y_p584 + c14 * f13_y_p581 + s14 * f13_y_p582 -
      inverse_D5_p390 * f13_y_p583;
  const Real f13_y_p588 = 0.072 * f13_y_p585 + c6 * f13_y_p586 - s6 * f13_y_p587;

  // link 5 (chest2), force propagation
  const Real f13_y_p589 = s6 * f13_y_p586 + c6 * f13_y_p587 - inverse_D1_p35 * f13_y_p588;

  // link 6 (chest3), force propagation
  const Real f13_y_p590 = f13_y_p580 + inverse_D1_p2 * f13_y_p583;
  const Real f13_y_p591 = f13_y_p579 - inverse_D1_p11 * f13_y_p583;
  const Real f13_y_p592 = c6 * f13_y_p590 - s6 * f13_y_p591;

  // link 5 (chest2), force propagation
  const Real f13_y_p593 = 0.072 * f13_y_p592 - inverse_D1_p25 * f13_y_p588;
  const Real f13_y_p594 = c5 * f13_y_p589 + s5 * f13_y_p593;
  const Real f13_y_p595 = s6 * f13_y_p590 + c6 * f13_y_p591 - inverse_D1_p58 * f13_y_p588;
  const Real f13_y_p596 = f13_y_p585 - inverse_D1_p54 * f13_y_p588;
  const Real f13_y_p597 = s5 * f13_y_p595 + c5 * f13_y_p596;
  const Real f13_y_p598 = f13_y_p592 - inverse_D1_p42 * f13_y_p588;

  // link 4 (chest1), force propagation
  const Real f13_y_p599 = s4 * (0.21799999999999997 * f13_y_p598 - s5 * f13_y_p589 + c5 *
      f13_y_p593 + inverse_D3_p3 * f13_y_p594);
  const Real f13_y_p600 = c4 * (0.21799999999999997 * f13_y_p597 + inverse_D3_p1 * f13_y_p594) -
      f13_y_p599;

  // link 3 (hip), force propagation
  const Real f13_y_p601 = c5 * f13_y_p595 - s5 * f13_y_p596 - inverse_D1_p83 * f13_y_p594 -
      inverse_D1_p87 * f13_y_p600;
  const Real f13_y_p602 = s4 * (f13_y_p598 + inverse_D1_p48 * f13_y_p594) - c4 *
      (f13_y_p597 + inverse_D1_p67 * f13_y_p594) + inverse_D1_p89 * f13_y_p600;
  const Real f13_y_p603 = s3 * f13_y_p601 - c3 * f13_y_p602;
  const Real f13_y_p604 = 0.422 * f13_y_p603;

  // link 2 (thigh), force propagation
  const Real f13_y_p605 = s2 * (c3 * f13_y_p601 + s3 * f13_y_p602 + inverse_D1_p102 * f13_y_p604) +
      c2 * (f13_y_p603 - inverse_D1_p98 * f13_y_p604);
  const Real f13_y_p606 = 0.434 * f13_y_p605;

  // link 1 (calf), force propagation
  const Real f13_y_p607 = inverse_D1 * f13_y_p606;

  // link 2 (thigh), force propagation
  const Real f13_y_p608 = inverse_D2 * f13_y_p604;

  // link 3 (hip), force propagation
  const Real f13_y_p609 = inverse_D3 * f13_y_p600;

  // link 4 (chest1), force propagation
  const Real f13_y_p610 = inverse_D4 * f13_y_p594;

  // link 5 (chest2), force propagation
  const Real f13_y_p611 = inverse_D5 * f13_y_p588;

  // link 6 (chest3), force propagation
  const Real f13_y_p612 = inverse_D6 * f13_y_p583;

  // link 1 (calf), force propagation
  const Real f13_y_p613 = f13_y_p92 * f13_y_p612 - f13_y_p97 * f13_y_p611 - f13_y_p103 *
      f13_y_p610 - f13_y_p109 * f13_y_p609 - f13_y_p113 * f13_y_p608;
  const Real f13_y_p614 = f13_y_p613 - f13_y_p115 * f13_y_p607;
  const Real f13_y_p615 = f13_y_p614 * f13_y_p126;
  const Real f13_y_p616 = f13_y_p155 * f13_y_p612 - f13_y_p160 * f13_y_p611 - f13_y_p166 *
      f13_y_p610 - f13_y_p172 * f13_y_p609 - f13_y_p176 * f13_y_p608;
  const Real f13_y_p617 = f13_y_p616 - f13_y_p178 * f13_y_p607 + f13_y_p191 * f13_y_p615;
  const Real f13_y_p618 = f13_y_p617 * f13_y_p197;
  const Real f13_y_p619 = f13_y_p224 * f13_y_p612 - f13_y_p229 * f13_y_p611 - f13_y_p235 *
      f13_y_p610 - f13_y_p241 * f13_y_p609 - f13_y_p245 * f13_y_p608;
  const Real f13_y_p620 = f13_y_p619 - f13_y_p247 * f13_y_p607 + f13_y_p260 * f13_y_p615 -
      f13_y_p264 * f13_y_p618;
  const Real f13_y_p621 = f13_y_p620 * f13_y_p270;
  const Real f13_y_p622 = f13_y_p306 * f13_y_p612 - f13_y_p311 * f13_y_p611 - f13_y_p317 *
      f13_y_p610 - f13_y_p323 * f13_y_p609 - f13_y_p327 * f13_y_p608;
  const Real f13_y_p623 = f13_y_p622 - f13_y_p329 * f13_y_p607 + f13_y_p342 * f13_y_p615 -
      f13_y_p346 * f13_y_p618 - f13_y_p350 * f13_y_p621;
  const Real f13_y_p624 = f13_y_p623 * f13_y_p357;
  const Real f13_y_p625 = f13_y_p393 * f13_y_p612 - f13_y_p398 * f13_y_p611 - f13_y_p404 *
      f13_y_p610 - f13_y_p410 * f13_y_p609 - f13_y_p414 * f13_y_p608;
  const Real f13_y_p626 = f13_y_p625 - f13_y_p416 * f13_y_p607 + f13_y_p429 * f13_y_p615 -
      f13_y_p433 * f13_y_p618 - f13_y_p437 * f13_y_p621;
  const Real f13_y_p627 = f13_y_p626 - f13_y_p444 * f13_y_p624;
  const Real f13_y_p628 = f13_y_p627 * f13_y_p452;
  const Real f13_y_p629 = f13_y_p489 * f13_y_p612 - f13_y_p494 * f13_y_p611 - f13_y_p500 *
      f13_y_p610 - f13_y_p506 * f13_y_p609 - f13_y_p510 * f13_y_p608;
  const Real f13_y_p630 = f13_y_p629 - f13_y_p512 * f13_y_p607 + f13_y_p525 * f13_y_p615 -
      f13_y_p529 * f13_y_p618 - f13_y_p533 * f13_y_p621;
  const Real f13_y_p631 = f13_y_p630 - f13_y_p540 * f13_y_p624 - f13_y_p545 * f13_y_p628;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p632 = inverse_D14 * f13_y_p26;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p633 = inverse_D15 * f13_y_p22;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p634 = minus_inverse_D16 * f13_y_p13;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p635 = inverse_D17 * f13_y_p10;

  // link 1 (calf), force propagation
  const Real f13_y_p636 = f13_y_p559 * f13_y_p635 - f13_y_p562 * f13_y_p634 + f13_y_p569 *
      f13_y_p633 + f13_y_p572 * f13_y_p632 - f13_y_p583 * f13_y_p120;
  const Real f13_y_p637 = f13_y_p636 - f13_y_p588 * f13_y_p119 - f13_y_p594 * f13_y_p118 -
      f13_y_p600 * f13_y_p117 - f13_y_p604 * f13_y_p116;
  const Real f13_y_p638 = f13_y_p637 - f13_y_p606 * f13_y_p62 - f13_y_p614 * f13_y_p127 -
      f13_y_p617 * f13_y_p198 - f13_y_p620 * f13_y_p271;
  const Real f13_y_p639 = f13_y_p638 + f13_y_p623 * f13_y_p358 + f13_y_p627 * f13_y_p453 +
      f13_y_p631 * f13_y_p555;
  const Real f13_y_p640 = f13_y_p631 * f13_y_p554;
  const Real f13_y_p641 = f13_y_p559 * (inverse_D17 * f13_y_p559) - f13_y_p562 *
      (minus_inverse_D16 * f13_y_p562) + f13_y_p569 * (inverse_D15 * f13_y_p569);
  const Real f13_y_p642 = f13_y_p641 + f13_y_p572 * (inverse_D14 * f13_y_p572) + f13_y_p583 *
      f13_y_p612 + f13_y_p588 * f13_y_p611 + f13_y_p594 * f13_y_p610;
  const Real f13_y_p643 = f13_y_p642 + f13_y_p600 * f13_y_p609 + f13_y_p604 * f13_y_p608 +
      f13_y_p606 * f13_y_p607 + f13_y_p614 * f13_y_p615;
  const Real f13_y_p644 = f13_y_p643 + f13_y_p617 * f13_y_p618 + f13_y_p620 * f13_y_p621 -
      f13_y_p623 * f13_y_p624 - f13_y_p627 * f13_y_p628;
  const Real f13_y_p645 = 1.0 / (f13_y_p644 - f13_y_p631 * f13_y_p640);
  const Real f13_y_p646 = f13_y_p639 * f13_y_p645;

  // link 19 (right_wrist2), force propagation
  const Real f13_y_p647 = s19 * s20;
  const Real f13_y_p648 = 0.269 * f13_y_p647;
  const Real f13_y_p649 = 0.269 * c20;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p650 = c18 * f13_y_p648 - s18 * f13_y_p649;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p651 = s18 * f13_y_p648 + c18 * f13_y_p649 + inverse_D5_p49 * f13_y_p650;
  const Real f13_y_p652 = inverse_D5_p46 * f13_y_p650;
  const Real f13_y_p653 = c17 * f13_y_p652 + s17 * f13_y_p651;
  const Real f13_y_p654 = s18 * c20 - c18 * f13_y_p647 + inverse_D5_p82 * f13_y_p650;
  const Real f13_y_p655 = c19 * s20 - inverse_D5_p91 * f13_y_p650;
  const Real f13_y_p656 = s17 * f13_y_p655 - c17 * f13_y_p654;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p657 = 0.282 * f13_y_p656 - inverse_D15_p1 * f13_y_p653;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p658 = c18 * c20 + s18 * f13_y_p647 - inverse_D5_p64 * f13_y_p650;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p659 = 0.282 * f13_y_p658 - s17 * f13_y_p652 + c17 * f13_y_p651 +
      inverse_D15_p4 * f13_y_p653;
  const Real f13_y_p660 = s16 * f13_y_p657 + c16 * f13_y_p659;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p661 = c16 * f13_y_p657 - s16 * f13_y_p659 + inverse_D14_p1 * f13_y_p660;
  const Real f13_y_p662 = f13_y_p24 * f13_y_p660;
  const Real f13_y_p663 = c15 * f13_y_p661 - s15 * f13_y_p662;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p664 = f13_y_p658 + inverse_D5_p71 * f13_y_p653;
  const Real f13_y_p665 = f13_y_p656 - inverse_D5_p99 * f13_y_p653;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p666 = c16 * f13_y_p664 + s16 * f13_y_p665 - inverse_D5_p140 * f13_y_p660;
  const Real f13_y_p667 = c17 * f13_y_p655 + s17 * f13_y_p654 + inverse_D5_p131 * f13_y_p653 +
      inverse_D5_p137 * f13_y_p660;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p668 = s15 * f13_y_p666 + c15 * f13_y_p667 + inverse_D5_p147 * f13_y_p663;
  const Real f13_y_p669 = s16 * f13_y_p664 - c16 * f13_y_p665 - inverse_D5_p121 * f13_y_p660 -
      inverse_D5_p127 * f13_y_p663;
  const Real f13_y_p670 = c14 * f13_y_p668 + s14 * f13_y_p669;
  const Real f13_y_p671 = c15 * f13_y_p666 - s15 * f13_y_p667 + inverse_D5_p177 * f13_y_p663;
  const Real f13_y_p672 = s15 * f13_y_p661 + c15 * f13_y_p662 - inverse_D5_p365 * f13_y_p663;
  const Real f13_y_p673 = f13_y_p36 * f13_y_p663;
  const Real f13_y_p674 = 0.18 * f13_y_p670 + 0.226 * f13_y_p671 + s14 * f13_y_p672 - c14 *
      f13_y_p673;
  const Real f13_y_p675 = s14 * f13_y_p668 - c14 * f13_y_p669;

  // link 6 (chest3), force propagation
  const Real f13_y_p676 = f13_y_p675 - inverse_D5_p408 * f13_y_p674;
  const Real f13_y_p677 = 0.226 * f13_y_p675 + inverse_D5_p383 * f13_y_p674;
  const Real f13_y_p678 = 0.18 * f13_y_p675 - c14 * f13_y_p672 - s14 * f13_y_p673 -
      inverse_D5_p390 * f13_y_p674;
  const Real f13_y_p679 = 0.072 * f13_y_p676 + c6 * f13_y_p677 - s6 * f13_y_p678;

  // link 5 (chest2), force propagation
  const Real f13_y_p680 = s6 * f13_y_p677 + c6 * f13_y_p678 - inverse_D1_p35 * f13_y_p679;

  // link 6 (chest3), force propagation
  const Real f13_y_p681 = f13_y_p671 + inverse_D1_p2 * f13_y_p674;
  const Real f13_y_p682 = f13_y_p670 - inverse_D1_p11 * f13_y_p674;
  const Real f13_y_p683 = c6 * f13_y_p681 - s6 * f13_y_p682;

  // link 5 (chest2), force propagation
  const Real f13_y_p684 = 0.072 * f13_y_p683 - inverse_D1_p25 * f13_y_p679;
  const Real f13_y_p685 = c5 * f13_y_p680 + s5 * f13_y_p684;
  const Real f13_y_p686 = s6 * f13_y_p681 + c6 * f13_y_p682 - inverse_D1_p58 * f13_y_p679;
  const Real f13_y_p687 = f13_y_p676 - inverse_D1_p54 * f13_y_p679;
  const Real f13_y_p688 = s5 * f13_y_p686 + c5 * f13_y_p687;
  const Real f13_y_p689 = f13_y_p683 - inverse_D1_p42 * f13_y_p679;

  // link 4 (chest1), force propagation
  const Real f13_y_p690 = s4 * (0.21799999999999997 * f13_y_p689 - s5 * f13_y_p680 + c5 *
      f13_y_p684 + inverse_D3_p3 * f13_y_p685);
  const Real f13_y_p691 = c4 * (0.21799999999999997 * f13_y_p688 + inverse_D3_p1 * f13_y_p685) -
      f13_y_p690;

  // link 3 (hip), force propagation
  const Real f13_y_p692 = c5 * f13_y_p686 - s5 * f13_y_p687 - inverse_D1_p83 * f13_y_p685 -
      inverse_D1_p87 * f13_y_p691;
  const Real f13_y_p693 = s4 * (f13_y_p689 + inverse_D1_p48 * f13_y_p685) - c4 *
      (f13_y_p688 + inverse_D1_p67 * f13_y_p685) + inverse_D1_p89 * f13_y_p691;
  const Real f13_y_p694 = s3 * f13_y_p692 - c3 * f13_y_p693;
  const Real f13_y_p695 = 0.422 * f13_y_p694;

  // link 2 (thigh), force propagation
  const Real f13_y_p696 = s2 * (c3 * f13_y_p692 + s3 * f13_y_p693 + inverse_D1_p102 * f13_y_p695) +
      c2 * (f13_y_p694 - inverse_D1_p98 * f13_y_p695);
  const Real f13_y_p697 = 0.434 * f13_y_p696;

  // link 1 (calf), force propagation
  const Real f13_y_p698 = inverse_D1 * f13_y_p697;

  // link 2 (thigh), force propagation
  const Real f13_y_p699 = inverse_D2 * f13_y_p695;

  // link 3 (hip), force propagation
  const Real f13_y_p700 = inverse_D3 * f13_y_p691;

  // link 4 (chest1), force propagation
  const Real f13_y_p701 = inverse_D4 * f13_y_p685;

  // link 5 (chest2), force propagation
  const Real f13_y_p702 = inverse_D5 * f13_y_p679;

  // link 6 (chest3), force propagation
  const Real f13_y_p703 = inverse_D6 * f13_y_p674;

  // link 1 (calf), force propagation
  const Real f13_y_p704 = f13_y_p92 * f13_y_p703 - f13_y_p97 * f13_y_p702 - f13_y_p103 *
      f13_y_p701 - f13_y_p109 * f13_y_p700 - f13_y_p113 * f13_y_p699;
  const Real f13_y_p705 = f13_y_p704 - f13_y_p115 * f13_y_p698;
  const Real f13_y_p706 = f13_y_p705 * f13_y_p126;
  const Real f13_y_p707 = f13_y_p155 * f13_y_p703 - f13_y_p160 * f13_y_p702 - f13_y_p166 *
      f13_y_p701 - f13_y_p172 * f13_y_p700 - f13_y_p176 * f13_y_p699;
  const Real f13_y_p708 = f13_y_p707 - f13_y_p178 * f13_y_p698 + f13_y_p191 * f13_y_p706;
  const Real f13_y_p709 = f13_y_p708 * f13_y_p197;
  const Real f13_y_p710 = f13_y_p224 * f13_y_p703 - f13_y_p229 * f13_y_p702 - f13_y_p235 *
      f13_y_p701 - f13_y_p241 * f13_y_p700 - f13_y_p245 * f13_y_p699;
  const Real f13_y_p711 = f13_y_p710 - f13_y_p247 * f13_y_p698 + f13_y_p260 * f13_y_p706 -
      f13_y_p264 * f13_y_p709;
  const Real f13_y_p712 = f13_y_p711 * f13_y_p270;
  const Real f13_y_p713 = f13_y_p306 * f13_y_p703 - f13_y_p311 * f13_y_p702 - f13_y_p317 *
      f13_y_p701 - f13_y_p323 * f13_y_p700 - f13_y_p327 * f13_y_p699;
  const Real f13_y_p714 = f13_y_p713 - f13_y_p329 * f13_y_p698 + f13_y_p342 * f13_y_p706 -
      f13_y_p346 * f13_y_p709 - f13_y_p350 * f13_y_p712;
  const Real f13_y_p715 = f13_y_p714 * f13_y_p357;
  const Real f13_y_p716 = f13_y_p393 * f13_y_p703 - f13_y_p398 * f13_y_p702 - f13_y_p404 *
      f13_y_p701 - f13_y_p410 * f13_y_p700 - f13_y_p414 * f13_y_p699;
  const Real f13_y_p717 = f13_y_p716 - f13_y_p416 * f13_y_p698 + f13_y_p429 * f13_y_p706 -
      f13_y_p433 * f13_y_p709 - f13_y_p437 * f13_y_p712;
  const Real f13_y_p718 = f13_y_p717 - f13_y_p444 * f13_y_p715;
  const Real f13_y_p719 = f13_y_p718 * f13_y_p452;
  const Real f13_y_p720 = f13_y_p489 * f13_y_p703 - f13_y_p494 * f13_y_p702 - f13_y_p500 *
      f13_y_p701 - f13_y_p506 * f13_y_p700 - f13_y_p510 * f13_y_p699;
  const Real f13_y_p721 = f13_y_p720 - f13_y_p512 * f13_y_p698 + f13_y_p525 * f13_y_p706 -
      f13_y_p529 * f13_y_p709 - f13_y_p533 * f13_y_p712;
  const Real f13_y_p722 = f13_y_p721 - f13_y_p540 * f13_y_p715 - f13_y_p545 * f13_y_p719;
  const Real f13_y_p723 = f13_y_p722 * f13_y_p554;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p724 = inverse_D14 * f13_y_p663;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p725 = inverse_D15 * f13_y_p660;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p726 = minus_inverse_D16 * f13_y_p653;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p727 = inverse_D17 * f13_y_p650;

  // link 1 (calf), force propagation
  const Real f13_y_p728 = f13_y_p559 * f13_y_p727 - f13_y_p562 * f13_y_p726 + f13_y_p569 *
      f13_y_p725 + f13_y_p572 * f13_y_p724 - f13_y_p583 * f13_y_p703;
  const Real f13_y_p729 = f13_y_p728 - f13_y_p588 * f13_y_p702 - f13_y_p594 * f13_y_p701 -
      f13_y_p600 * f13_y_p700 - f13_y_p604 * f13_y_p699;
  const Real f13_y_p730 = f13_y_p729 - f13_y_p606 * f13_y_p698 - f13_y_p614 * f13_y_p706 -
      f13_y_p617 * f13_y_p709 - f13_y_p620 * f13_y_p712;
  const Real f13_y_p731 = f13_y_p730 + f13_y_p623 * f13_y_p715 + f13_y_p627 * f13_y_p719 +
      f13_y_p631 * f13_y_p723;
  const Real f13_y_p732 = f13_y_p650 * f13_y_p635 - f13_y_p653 * f13_y_p634 + f13_y_p660 *
      f13_y_p633 + f13_y_p663 * f13_y_p632 + f13_y_p674 * f13_y_p120;
  const Real f13_y_p733 = f13_y_p732 + f13_y_p679 * f13_y_p119 + f13_y_p685 * f13_y_p118 +
      f13_y_p691 * f13_y_p117 + f13_y_p695 * f13_y_p116;
  const Real f13_y_p734 = f13_y_p733 + f13_y_p697 * f13_y_p62 + f13_y_p705 * f13_y_p127 +
      f13_y_p708 * f13_y_p198 + f13_y_p711 * f13_y_p271;
  const Real f13_y_p735 = f13_y_p734 - f13_y_p714 * f13_y_p358 - f13_y_p718 * f13_y_p453 -
      f13_y_p722 * f13_y_p555 - f13_y_p731 * f13_y_p646;
  const Real f13_y_p736 = f13_y_p731 * f13_y_p645;
  const Real f13_y_p737 = f13_y_p650 * f13_y_p727 - f13_y_p653 * f13_y_p726 + f13_y_p660 *
      f13_y_p725 + f13_y_p663 * f13_y_p724 + f13_y_p674 * f13_y_p703;
  const Real f13_y_p738 = f13_y_p737 + f13_y_p679 * f13_y_p702 + f13_y_p685 * f13_y_p701 +
      f13_y_p691 * f13_y_p700 + f13_y_p695 * f13_y_p699;
  const Real f13_y_p739 = f13_y_p738 + f13_y_p697 * f13_y_p698 + f13_y_p705 * f13_y_p706 +
      f13_y_p708 * f13_y_p709 + f13_y_p711 * f13_y_p712;
  const Real f13_y_p740 = f13_y_p739 - f13_y_p714 * f13_y_p715 - f13_y_p718 * f13_y_p719 -
      f13_y_p722 * f13_y_p723 - f13_y_p731 * f13_y_p736;
  const Real f13_y_p741 = 1.0 / f13_y_p740;
  const Real f13_y_p742 = f13_y_p735 * f13_y_p741;

  // link 19 (right_wrist2), force propagation
  const Real f13_y_p743 = 0.269 * c19;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p744 = c18 * f13_y_p743;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p745 = s18 * f13_y_p743 + inverse_D5_p49 * f13_y_p744;
  const Real f13_y_p746 = inverse_D5_p46 * f13_y_p744;
  const Real f13_y_p747 = c17 * f13_y_p746 + s17 * f13_y_p745;
  const Real f13_y_p748 = c18 * c19 - inverse_D5_p82 * f13_y_p744;
  const Real f13_y_p749 = s19 + inverse_D5_p91 * f13_y_p744;
  const Real f13_y_p750 = s17 * f13_y_p749 - c17 * f13_y_p748;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p751 = 0.282 * f13_y_p750 + inverse_D15_p1 * f13_y_p747;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p752 = s18 * c19 - inverse_D5_p64 * f13_y_p744;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p753 = 0.282 * f13_y_p752 - s17 * f13_y_p746 + c17 * f13_y_p745 +
      inverse_D15_p4 * f13_y_p747;
  const Real f13_y_p754 = s16 * f13_y_p751 - c16 * f13_y_p753;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p755 = c16 * f13_y_p751 + s16 * f13_y_p753 + inverse_D14_p1 * f13_y_p754;
  const Real f13_y_p756 = f13_y_p24 * f13_y_p754;
  const Real f13_y_p757 = c15 * f13_y_p755 - s15 * f13_y_p756;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p758 = f13_y_p752 + inverse_D5_p71 * f13_y_p747;
  const Real f13_y_p759 = f13_y_p750 + inverse_D5_p99 * f13_y_p747;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p760 = c16 * f13_y_p758 - s16 * f13_y_p759 + inverse_D5_p140 * f13_y_p754;
  const Real f13_y_p761 = c17 * f13_y_p749 + s17 * f13_y_p748 - inverse_D5_p131 * f13_y_p747 +
      inverse_D5_p137 * f13_y_p754;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p762 = s15 * f13_y_p760 - c15 * f13_y_p761 - inverse_D5_p147 * f13_y_p757;
  const Real f13_y_p763 = s16 * f13_y_p758 + c16 * f13_y_p759 + inverse_D5_p121 * f13_y_p754 +
      inverse_D5_p127 * f13_y_p757;
  const Real f13_y_p764 = c14 * f13_y_p762 + s14 * f13_y_p763;
  const Real f13_y_p765 = c15 * f13_y_p760 + s15 * f13_y_p761 - inverse_D5_p177 * f13_y_p757;
  const Real f13_y_p766 = s15 * f13_y_p755 + c15 * f13_y_p756 - inverse_D5_p365 * f13_y_p757;
  const Real f13_y_p767 = f13_y_p36 * f13_y_p757;
  const Real f13_y_p768 = 0.18 * f13_y_p764 + 0.226 * f13_y_p765 - s14 * f13_y_p766 + c14 *
      f13_y_p767;
  const Real f13_y_p769 = s14 * f13_y_p762 - c14 * f13_y_p763;

  // link 6 (chest3), force propagation
  const Real f13_y_p770 = f13_y_p769 - inverse_D5_p408 * f13_y_p768;
  const Real f13_y_p771 = 0.226 * f13_y_p769 + inverse_D5_p383 * f13_y_p768;
  const Real f13_y_p772 = 0.18 * f13_y_p769 + c14 * f13_y_p766 + s14 * f13_y_p767 -
      inverse_D5_p390 * f13_y_p768;
  const Real f13_y_p773 = 0.072 * f13_y_p770 + c6 * f13_y_p771 - s6 * f13_y_p772;

  // link 5 (chest2), force propagation
  const Real f13_y_p774 = s6 * f13_y_p771 + c6 * f13_y_p772 - inverse_D1_p35 * f13_y_p773;

  // link 6 (chest3), force propagation
  const Real f13_y_p775 = f13_y_p765 + inverse_D1_p2 * f13_y_p768;
  const Real f13_y_p776 = f13_y_p764 - inverse_D1_p11 * f13_y_p768;
  const Real f13_y_p777 = c6 * f13_y_p775 - s6 * f13_y_p776;

  // link 5 (chest2), force propagation
  const Real f13_y_p778 = 0.072 * f13_y_p777 - inverse_D1_p25 * f13_y_p773;
  const Real f13_y_p779 = c5 * f13_y_p774 + s5 * f13_y_p778;
  const Real f13_y_p780 = s6 * f13_y_p775 + c6 * f13_y_p776 - inverse_D1_p58 * f13_y_p773;
  const Real f13_y_p781 = f13_y_p770 - inverse_D1_p54 * f13_y_p773;
  const Real f13_y_p782 = s5 * f13_y_p780 + c5 * f13_y_p781;
  const Real f13_y_p783 = f13_y_p777 - inverse_D1_p42 * f13_y_p773;

  // link 4 (chest1), force propagation
  const Real f13_y_p784 = s4 * (0.21799999999999997 * f13_y_p783 - s5 * f13_y_p774 + c5 *
      f13_y_p778 + inverse_D3_p3 * f13_y_p779);
  const Real f13_y_p785 = c4 * (0.21799999999999997 * f13_y_p782 + inverse_D3_p1 * f13_y_p779) -
      f13_y_p784;

  // link 3 (hip), force propagation
  const Real f13_y_p786 = c5 * f13_y_p780 - s5 * f13_y_p781 - inverse_D1_p83 * f13_y_p779 -
      inverse_D1_p87 * f13_y_p785;
  const Real f13_y_p787 = s4 * (f13_y_p783 + inverse_D1_p48 * f13_y_p779) - c4 *
      (f13_y_p782 + inverse_D1_p67 * f13_y_p779) + inverse_D1_p89 * f13_y_p785;
  const Real f13_y_p788 = s3 * f13_y_p786 - c3 * f13_y_p787;
  const Real f13_y_p789 = 0.422 * f13_y_p788;

  // link 2 (thigh), force propagation
  const Real f13_y_p790 = s2 * (c3 * f13_y_p786 + s3 * f13_y_p787 + inverse_D1_p102 * f13_y_p789) +
      c2 * (f13_y_p788 - inverse_D1_p98 * f13_y_p789);
  const Real f13_y_p791 = 0.434 * f13_y_p790;

  // link 1 (calf), force propagation
  const Real f13_y_p792 = inverse_D1 * f13_y_p791;

  // link 2 (thigh), force propagation
  const Real f13_y_p793 = inverse_D2 * f13_y_p789;

  // link 3 (hip), force propagation
  const Real f13_y_p794 = inverse_D3 * f13_y_p785;

  // link 4 (chest1), force propagation
  const Real f13_y_p795 = inverse_D4 * f13_y_p779;

  // link 5 (chest2), force propagation
  const Real f13_y_p796 = inverse_D5 * f13_y_p773;

  // link 6 (chest3), force propagation
  const Real f13_y_p797 = inverse_D6 * f13_y_p768;

  // link 1 (calf), force propagation
  const Real f13_y_p798 = f13_y_p92 * f13_y_p797 - f13_y_p97 * f13_y_p796 - f13_y_p103 *
      f13_y_p795 - f13_y_p109 * f13_y_p794 - f13_y_p113 * f13_y_p793;
  const Real f13_y_p799 = f13_y_p798 - f13_y_p115 * f13_y_p792;
  const Real f13_y_p800 = f13_y_p799 * f13_y_p126;
  const Real f13_y_p801 = f13_y_p155 * f13_y_p797 - f13_y_p160 * f13_y_p796 - f13_y_p166 *
      f13_y_p795 - f13_y_p172 * f13_y_p794 - f13_y_p176 * f13_y_p793;
  const Real f13_y_p802 = f13_y_p801 - f13_y_p178 * f13_y_p792 + f13_y_p191 * f13_y_p800;
  const Real f13_y_p803 = f13_y_p802 * f13_y_p197;
  const Real f13_y_p804 = f13_y_p224 * f13_y_p797 - f13_y_p229 * f13_y_p796 - f13_y_p235 *
      f13_y_p795 - f13_y_p241 * f13_y_p794 - f13_y_p245 * f13_y_p793;
  const Real f13_y_p805 = f13_y_p804 - f13_y_p247 * f13_y_p792 + f13_y_p260 * f13_y_p800 -
      f13_y_p264 * f13_y_p803;
  const Real f13_y_p806 = f13_y_p805 * f13_y_p270;
  const Real f13_y_p807 = f13_y_p306 * f13_y_p797 - f13_y_p311 * f13_y_p796 - f13_y_p317 *
      f13_y_p795 - f13_y_p323 * f13_y_p794 - f13_y_p327 * f13_y_p793;
  const Real f13_y_p808 = f13_y_p807 - f13_y_p329 * f13_y_p792 + f13_y_p342 * f13_y_p800 -
      f13_y_p346 * f13_y_p803 - f13_y_p350 * f13_y_p806;
  const Real f13_y_p809 = f13_y_p808 * f13_y_p357;
  const Real f13_y_p810 = f13_y_p393 * f13_y_p797 - f13_y_p398 * f13_y_p796 - f13_y_p404 *
      f13_y_p795 - f13_y_p410 * f13_y_p794 - f13_y_p414 * f13_y_p793;
  const Real f13_y_p811 = f13_y_p810 - f13_y_p416 * f13_y_p792 + f13_y_p429 * f13_y_p800 -
      f13_y_p433 * f13_y_p803 - f13_y_p437 * f13_y_p806;
  const Real f13_y_p812 = f13_y_p811 - f13_y_p444 * f13_y_p809;
  const Real f13_y_p813 = f13_y_p812 * f13_y_p452;
  const Real f13_y_p814 = f13_y_p489 * f13_y_p797 - f13_y_p494 * f13_y_p796 - f13_y_p500 *
      f13_y_p795 - f13_y_p506 * f13_y_p794 - f13_y_p510 * f13_y_p793;
  const Real f13_y_p815 = f13_y_p814 - f13_y_p512 * f13_y_p792 + f13_y_p525 * f13_y_p800 -
      f13_y_p529 * f13_y_p803 - f13_y_p533 * f13_y_p806;
  const Real f13_y_p816 = f13_y_p815 - f13_y_p540 * f13_y_p809 - f13_y_p545 * f13_y_p813;
  const Real f13_y_p817 = f13_y_p816 * f13_y_p554;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p818 = inverse_D14 * f13_y_p757;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p819 = inverse_D15 * f13_y_p754;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p820 = minus_inverse_D16 * f13_y_p747;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p821 = inverse_D17 * f13_y_p744;

  // link 1 (calf), force propagation
  const Real f13_y_p822 = f13_y_p559 * f13_y_p821 - f13_y_p562 * f13_y_p820 - f13_y_p569 *
      f13_y_p819 - f13_y_p572 * f13_y_p818 - f13_y_p583 * f13_y_p797;
  const Real f13_y_p823 = f13_y_p822 - f13_y_p588 * f13_y_p796 - f13_y_p594 * f13_y_p795 -
      f13_y_p600 * f13_y_p794 - f13_y_p604 * f13_y_p793;
  const Real f13_y_p824 = f13_y_p823 - f13_y_p606 * f13_y_p792 - f13_y_p614 * f13_y_p800 -
      f13_y_p617 * f13_y_p803 - f13_y_p620 * f13_y_p806;
  const Real f13_y_p825 = f13_y_p824 + f13_y_p623 * f13_y_p809 + f13_y_p627 * f13_y_p813 +
      f13_y_p631 * f13_y_p817;
  const Real f13_y_p826 = f13_y_p825 * f13_y_p645;
  const Real f13_y_p827 = f13_y_p650 * f13_y_p821 - f13_y_p653 * f13_y_p820 - f13_y_p660 *
      f13_y_p819 - f13_y_p663 * f13_y_p818 + f13_y_p674 * f13_y_p797;
  const Real f13_y_p828 = f13_y_p827 + f13_y_p679 * f13_y_p796 + f13_y_p685 * f13_y_p795 +
      f13_y_p691 * f13_y_p794 + f13_y_p695 * f13_y_p793;
  const Real f13_y_p829 = f13_y_p828 + f13_y_p697 * f13_y_p792 + f13_y_p705 * f13_y_p800 +
      f13_y_p708 * f13_y_p803 + f13_y_p711 * f13_y_p806;
  const Real f13_y_p830 = f13_y_p829 - f13_y_p714 * f13_y_p809 - f13_y_p718 * f13_y_p813 -
      f13_y_p722 * f13_y_p817 - f13_y_p731 * f13_y_p826;
  const Real f13_y_p831 = f13_y_p744 * f13_y_p635 - f13_y_p747 * f13_y_p634 - f13_y_p754 *
      f13_y_p633 - f13_y_p757 * f13_y_p632 + f13_y_p768 * f13_y_p120;
  const Real f13_y_p832 = f13_y_p831 + f13_y_p773 * f13_y_p119 + f13_y_p779 * f13_y_p118 +
      f13_y_p785 * f13_y_p117 + f13_y_p789 * f13_y_p116;
  const Real f13_y_p833 = f13_y_p832 + f13_y_p791 * f13_y_p62 + f13_y_p799 * f13_y_p127 +
      f13_y_p802 * f13_y_p198 + f13_y_p805 * f13_y_p271;
  const Real f13_y_p834 = f13_y_p833 - f13_y_p808 * f13_y_p358 - f13_y_p812 * f13_y_p453 -
      f13_y_p816 * f13_y_p555 - f13_y_p825 * f13_y_p646;
  const Real f13_y_p835 = f13_y_p834 - f13_y_p830 * f13_y_p742;
  const Real f13_y_p836 = f13_y_p830 * f13_y_p741;
  const Real f13_y_p837 = f13_y_p744 * f13_y_p821 - f13_y_p747 * f13_y_p820 + f13_y_p754 *
      f13_y_p819 + f13_y_p757 * f13_y_p818 + f13_y_p768 * f13_y_p797;
  const Real f13_y_p838 = f13_y_p837 + f13_y_p773 * f13_y_p796 + f13_y_p779 * f13_y_p795 +
      f13_y_p785 * f13_y_p794 + f13_y_p789 * f13_y_p793;
  const Real f13_y_p839 = f13_y_p838 + f13_y_p791 * f13_y_p792 + f13_y_p799 * f13_y_p800 +
      f13_y_p802 * f13_y_p803 + f13_y_p805 * f13_y_p806;
  const Real f13_y_p840 = f13_y_p839 - f13_y_p808 * f13_y_p809 - f13_y_p812 * f13_y_p813 -
      f13_y_p816 * f13_y_p817 - f13_y_p825 * f13_y_p826;
  const Real f13_y_p841 = 1.0 / (f13_y_p840 - f13_y_p830 * f13_y_p836);
  const Real f13_y_p842 = f13_y_p835 * f13_y_p841;

  // link 19 (right_wrist2), force propagation
  const Real f13_y_p843 = c20 + s20 * inverse_D18_p1;
  const Real f13_y_p844 = c19 * f13_y_p843;
  const Real f13_y_p845 = s20 * inverse_D5_p8;
  const Real f13_y_p846 = s20 * inverse_D5_p2;
  const Real f13_y_p847 = s19 * f13_y_p845 + c19 * f13_y_p846;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p848 = 0.269 * f13_y_p847 - inverse_D5_p23 * f13_y_p844;

  // link 19 (right_wrist2), force propagation
  const Real f13_y_p849 = s20 * inverse_D5_p14;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p850 = 0.269 * f13_y_p849 - s19 * f13_y_p843 + inverse_D5_p29 * f13_y_p844;
  const Real f13_y_p851 = c18 * f13_y_p848 + s18 * f13_y_p850;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p852 = s18 * f13_y_p848 - c18 * f13_y_p850 + inverse_D5_p49 * f13_y_p851;
  const Real f13_y_p853 = inverse_D5_p46 * f13_y_p851;
  const Real f13_y_p854 = c17 * f13_y_p853 + s17 * f13_y_p852;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p855 = f13_y_p847 - inverse_D5_p54 * f13_y_p844;
  const Real f13_y_p856 = f13_y_p849 + inverse_D5_p57 * f13_y_p844;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p857 = s18 * f13_y_p856 + c18 * f13_y_p855 - inverse_D5_p82 * f13_y_p851;
  const Real f13_y_p858 = c19 * f13_y_p845 - s19 * f13_y_p846 + inverse_D5_p86 * f13_y_p844 -
      inverse_D5_p91 * f13_y_p851;
  const Real f13_y_p859 = s17 * f13_y_p858 + c17 * f13_y_p857;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p860 = 0.282 * f13_y_p859 - inverse_D15_p1 * f13_y_p854;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p861 = c18 * f13_y_p856 - s18 * f13_y_p855 + inverse_D5_p64 * f13_y_p851;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p862 = 0.282 * f13_y_p861 + s17 * f13_y_p853 - c17 * f13_y_p852 -
      inverse_D15_p4 * f13_y_p854;
  const Real f13_y_p863 = s16 * f13_y_p860 - c16 * f13_y_p862;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p864 = c16 * f13_y_p860 + s16 * f13_y_p862 + inverse_D14_p1 * f13_y_p863;
  const Real f13_y_p865 = f13_y_p24 * f13_y_p863;
  const Real f13_y_p866 = c15 * f13_y_p864 - s15 * f13_y_p865;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p867 = f13_y_p861 - inverse_D5_p71 * f13_y_p854;
  const Real f13_y_p868 = f13_y_p859 - inverse_D5_p99 * f13_y_p854;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p869 = c16 * f13_y_p867 - s16 * f13_y_p868 + inverse_D5_p140 * f13_y_p863;
  const Real f13_y_p870 = c17 * f13_y_p858 - s17 * f13_y_p857 + inverse_D5_p131 * f13_y_p854 +
      inverse_D5_p137 * f13_y_p863;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p871 = s15 * f13_y_p869 - c15 * f13_y_p870 - inverse_D5_p147 * f13_y_p866;
  const Real f13_y_p872 = s16 * f13_y_p867 + c16 * f13_y_p868 + inverse_D5_p121 * f13_y_p863 +
      inverse_D5_p127 * f13_y_p866;
  const Real f13_y_p873 = c14 * f13_y_p871 + s14 * f13_y_p872;
  const Real f13_y_p874 = c15 * f13_y_p869 + s15 * f13_y_p870 - inverse_D5_p177 * f13_y_p866;
  const Real f13_y_p875 = s15 * f13_y_p864 + c15 * f13_y_p865 - inverse_D5_p365 * f13_y_p866;
  const Real f13_y_p876 = f13_y_p36 * f13_y_p866;
  const Real f13_y_p877 = 0.18 * f13_y_p873 + 0.226 * f13_y_p874 - s14 * f13_y_p875 + c14 *
      f13_y_p876;
  const Real f13_y_p878 = s14 * f13_y_p871 - c14 * f13_y_p872;

  // link 6 (chest3), force propagation
  const Real f13_y_p879 = f13_y_p878 - inverse_D5_p408 * f13_y_p877;
  const Real f13_y_p880 = 0.226 * f13_y_p878 + inverse_D5_p383 * f13_y_p877;
  const Real f13_y_p881 = 0.18 * f13_y_p878 + c14 * f13_y_p875 + s14 * f13_y_p876 -
      inverse_D5_p390 * f13_y_p877;
  const Real f13_y_p882 = 0.072 * f13_y_p879 + c6 * f13_y_p880 - s6 * f13_y_p881;

  // link 5 (chest2), force propagation
  const Real f13_y_p883 = s6 * f13_y_p880 + c6 * f13_y_p881 - inverse_D1_p35 * f13_y_p882;

  // link 6 (chest3), force propagation
  const Real f13_y_p884 = f13_y_p874 + inverse_D1_p2 * f13_y_p877;
  const Real f13_y_p885 = f13_y_p873 - inverse_D1_p11 * f13_y_p877;
  const Real f13_y_p886 = c6 * f13_y_p884 - s6 * f13_y_p885;

  // link 5 (chest2), force propagation
  const Real f13_y_p887 = 0.072 * f13_y_p886 - inverse_D1_p25 * f13_y_p882;
  const Real f13_y_p888 = c5 * f13_y_p883 + s5 * f13_y_p887;
  const Real f13_y_p889 = s6 * f13_y_p884 + c6 * f13_y_p885 - inverse_D1_p58 * f13_y_p882;
  const Real f13_y_p890 = f13_y_p879 - inverse_D1_p54 * f13_y_p882;
  const Real f13_y_p891 = s5 * f13_y_p889 + c5 * f13_y_p890;
  const Real f13_y_p892 = f13_y_p886 - inverse_D1_p42 * f13_y_p882;

  // link 4 (chest1), force propagation
  const Real f13_y_p893 = s4 * (0.21799999999999997 * f13_y_p892 - s5 * f13_y_p883 + c5 *
      f13_y_p887 + inverse_D3_p3 * f13_y_p888);
  const Real f13_y_p894 = c4 * (0.21799999999999997 * f13_y_p891 + inverse_D3_p1 * f13_y_p888) -
      f13_y_p893;

  // link 3 (hip), force propagation
  const Real f13_y_p895 = c5 * f13_y_p889 - s5 * f13_y_p890 - inverse_D1_p83 * f13_y_p888 -
      inverse_D1_p87 * f13_y_p894;
  const Real f13_y_p896 = s4 * (f13_y_p892 + inverse_D1_p48 * f13_y_p888) - c4 *
      (f13_y_p891 + inverse_D1_p67 * f13_y_p888) + inverse_D1_p89 * f13_y_p894;
  const Real f13_y_p897 = s3 * f13_y_p895 - c3 * f13_y_p896;
  const Real f13_y_p898 = 0.422 * f13_y_p897;

  // link 2 (thigh), force propagation
  const Real f13_y_p899 = s2 * (c3 * f13_y_p895 + s3 * f13_y_p896 + inverse_D1_p102 * f13_y_p898) +
      c2 * (f13_y_p897 - inverse_D1_p98 * f13_y_p898);
  const Real f13_y_p900 = 0.434 * f13_y_p899;

  // link 1 (calf), force propagation
  const Real f13_y_p901 = inverse_D1 * f13_y_p900;

  // link 2 (thigh), force propagation
  const Real f13_y_p902 = inverse_D2 * f13_y_p898;

  // link 3 (hip), force propagation
  const Real f13_y_p903 = inverse_D3 * f13_y_p894;

  // link 4 (chest1), force propagation
  const Real f13_y_p904 = inverse_D4 * f13_y_p888;

  // link 5 (chest2), force propagation
  const Real f13_y_p905 = inverse_D5 * f13_y_p882;

  // link 6 (chest3), force propagation
  const Real f13_y_p906 = inverse_D6 * f13_y_p877;

  // link 1 (calf), force propagation
  const Real f13_y_p907 = f13_y_p92 * f13_y_p906 - f13_y_p97 * f13_y_p905 - f13_y_p103 *
      f13_y_p904 - f13_y_p109 * f13_y_p903 - f13_y_p113 * f13_y_p902;
  const Real f13_y_p908 = f13_y_p907 - f13_y_p115 * f13_y_p901;
  const Real f13_y_p909 = f13_y_p908 * f13_y_p126;
  const Real f13_y_p910 = f13_y_p155 * f13_y_p906 - f13_y_p160 * f13_y_p905 - f13_y_p166 *
      f13_y_p904 - f13_y_p172 * f13_y_p903 - f13_y_p176 * f13_y_p902;
  const Real f13_y_p911 = f13_y_p910 - f13_y_p178 * f13_y_p901 + f13_y_p191 * f13_y_p909;
  const Real f13_y_p912 = f13_y_p911 * f13_y_p197;
  const Real f13_y_p913 = f13_y_p224 * f13_y_p906 - f13_y_p229 * f13_y_p905 - f13_y_p235 *
      f13_y_p904 - f13_y_p241 * f13_y_p903 - f13_y_p245 * f13_y_p902;
  const Real f13_y_p914 = f13_y_p913 - f13_y_p247 * f13_y_p901 + f13_y_p260 * f13_y_p909 -
      f13_y_p264 * f13_y_p912;
  const Real f13_y_p915 = f13_y_p914 * f13_y_p270;
  const Real f13_y_p916 = f13_y_p306 * f13_y_p906 - f13_y_p311 * f13_y_p905 - f13_y_p317 *
      f13_y_p904 - f13_y_p323 * f13_y_p903 - f13_y_p327 * f13_y_p902;
  const Real f13_y_p917 = f13_y_p916 - f13_y_p329 * f13_y_p901 + f13_y_p342 * f13_y_p909 -
      f13_y_p346 * f13_y_p912 - f13_y_p350 * f13_y_p915;
  const Real f13_y_p918 = f13_y_p917 * f13_y_p357;
  const Real f13_y_p919 = f13_y_p393 * f13_y_p906 - f13_y_p398 * f13_y_p905 - f13_y_p404 *
      f13_y_p904 - f13_y_p410 * f13_y_p903 - f13_y_p414 * f13_y_p902;
  const Real f13_y_p920 = f13_y_p919 - f13_y_p416 * f13_y_p901 + f13_y_p429 * f13_y_p909 -
      f13_y_p433 * f13_y_p912 - f13_y_p437 * f13_y_p915;
  const Real f13_y_p921 = f13_y_p920 - f13_y_p444 * f13_y_p918;
  const Real f13_y_p922 = f13_y_p921 * f13_y_p452;
  const Real f13_y_p923 = f13_y_p489 * f13_y_p906 - f13_y_p494 * f13_y_p905 - f13_y_p500 *
      f13_y_p904 - f13_y_p506 * f13_y_p903 - f13_y_p510 * f13_y_p902;
  const Real f13_y_p924 = f13_y_p923 - f13_y_p512 * f13_y_p901 + f13_y_p525 * f13_y_p909 -
      f13_y_p529 * f13_y_p912 - f13_y_p533 * f13_y_p915;
  const Real f13_y_p925 = f13_y_p924 - f13_y_p540 * f13_y_p918 - f13_y_p545 * f13_y_p922;
  const Real f13_y_p926 = f13_y_p925 * f13_y_p554;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p927 = inverse_D14 * f13_y_p866;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p928 = inverse_D15 * f13_y_p863;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p929 = minus_inverse_D16 * f13_y_p854;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p930 = inverse_D17 * f13_y_p851;

  // link 1 (calf), force propagation
  const Real f13_y_p931 = f13_y_p559 * f13_y_p930 - f13_y_p562 * f13_y_p929 + f13_y_p569 *
      f13_y_p928 + f13_y_p572 * f13_y_p927 + f13_y_p583 * f13_y_p906;
  const Real f13_y_p932 = f13_y_p931 + f13_y_p588 * f13_y_p905 + f13_y_p594 * f13_y_p904 +
      f13_y_p600 * f13_y_p903 + f13_y_p604 * f13_y_p902;
  const Real f13_y_p933 = f13_y_p932 + f13_y_p606 * f13_y_p901 + f13_y_p614 * f13_y_p909 +
      f13_y_p617 * f13_y_p912 + f13_y_p620 * f13_y_p915;
  const Real f13_y_p934 = f13_y_p933 - f13_y_p623 * f13_y_p918 - f13_y_p627 * f13_y_p922 -
      f13_y_p631 * f13_y_p926;
  const Real f13_y_p935 = f13_y_p934 * f13_y_p645;
  const Real f13_y_p936 = f13_y_p650 * f13_y_p930 - f13_y_p653 * f13_y_p929 + f13_y_p660 *
      f13_y_p928 + f13_y_p663 * f13_y_p927 - f13_y_p674 * f13_y_p906;
  const Real f13_y_p937 = f13_y_p936 - f13_y_p679 * f13_y_p905 - f13_y_p685 * f13_y_p904 -
      f13_y_p691 * f13_y_p903 - f13_y_p695 * f13_y_p902;
  const Real f13_y_p938 = f13_y_p937 - f13_y_p697 * f13_y_p901 - f13_y_p705 * f13_y_p909 -
      f13_y_p708 * f13_y_p912 - f13_y_p711 * f13_y_p915;
  const Real f13_y_p939 = f13_y_p938 + f13_y_p714 * f13_y_p918 + f13_y_p718 * f13_y_p922 +
      f13_y_p722 * f13_y_p926 - f13_y_p731 * f13_y_p935;
  const Real f13_y_p940 = f13_y_p939 * f13_y_p741;
  const Real f13_y_p941 = f13_y_p744 * f13_y_p930 - f13_y_p747 * f13_y_p929 - f13_y_p754 *
      f13_y_p928 - f13_y_p757 * f13_y_p927 - f13_y_p768 * f13_y_p906;
  const Real f13_y_p942 = f13_y_p941 - f13_y_p773 * f13_y_p905 - f13_y_p779 * f13_y_p904 -
      f13_y_p785 * f13_y_p903 - f13_y_p789 * f13_y_p902;
  const Real f13_y_p943 = f13_y_p942 - f13_y_p791 * f13_y_p901 - f13_y_p799 * f13_y_p909 -
      f13_y_p802 * f13_y_p912 - f13_y_p805 * f13_y_p915;
  const Real f13_y_p944 = f13_y_p943 + f13_y_p808 * f13_y_p918 + f13_y_p812 * f13_y_p922 +
      f13_y_p816 * f13_y_p926 - f13_y_p825 * f13_y_p935;
  const Real f13_y_p945 = f13_y_p944 - f13_y_p830 * f13_y_p940;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p946 = inverse_D18 * f13_y_p3;

  // link 19 (right_wrist2), force propagation
  const Real f13_y_p947 = minus_inverse_D19 * f13_y_p1;

  // link 1 (calf), force propagation
  const Real f13_y_p948 = s20 * f13_y_p947 + f13_y_p844 * f13_y_p946 - f13_y_p851 * f13_y_p635 +
      f13_y_p854 * f13_y_p634 - f13_y_p863 * f13_y_p633;
  const Real f13_y_p949 = f13_y_p948 - f13_y_p866 * f13_y_p632 + f13_y_p877 * f13_y_p120 +
      f13_y_p882 * f13_y_p119 + f13_y_p888 * f13_y_p118;
  const Real f13_y_p950 = f13_y_p949 + f13_y_p894 * f13_y_p117 + f13_y_p898 * f13_y_p116 +
      f13_y_p900 * f13_y_p62 + f13_y_p908 * f13_y_p127;
  const Real f13_y_p951 = f13_y_p950 + f13_y_p911 * f13_y_p198 + f13_y_p914 * f13_y_p271 -
      f13_y_p917 * f13_y_p358 - f13_y_p921 * f13_y_p453;
  const Real f13_y_p952 = f13_y_p951 - f13_y_p925 * f13_y_p555 + f13_y_p934 * f13_y_p646 +
      f13_y_p939 * f13_y_p742 + f13_y_p945 * f13_y_p842;
  const Real f13_y_p953 = f13_y_p945 * f13_y_p841;
  const Real f13_y_p954 = minus_inverse_D19 * (s20 * s20) - f13_y_p844 *
      (inverse_D18 * f13_y_p844) - f13_y_p851 * f13_y_p930 + f13_y_p854 * f13_y_p929;
  const Real f13_y_p955 = f13_y_p954 - f13_y_p863 * f13_y_p928 - f13_y_p866 * f13_y_p927 -
      f13_y_p877 * f13_y_p906 - f13_y_p882 * f13_y_p905;
  const Real f13_y_p956 = f13_y_p955 - f13_y_p888 * f13_y_p904 - f13_y_p894 * f13_y_p903 -
      f13_y_p898 * f13_y_p902 - f13_y_p900 * f13_y_p901;
  const Real f13_y_p957 = f13_y_p956 - f13_y_p908 * f13_y_p909 - f13_y_p911 * f13_y_p912 -
      f13_y_p914 * f13_y_p915 + f13_y_p917 * f13_y_p918;
  const Real f13_y_p958 = f13_y_p957 + f13_y_p921 * f13_y_p922 + f13_y_p925 * f13_y_p926 +
      f13_y_p934 * f13_y_p935 + f13_y_p939 * f13_y_p940;
  const Real f13_y_p959 = 1.0 / (f13_y_p958 + f13_y_p945 * f13_y_p953);
  const Real f13_y_p960 = f13_y_p952 * f13_y_p959;

  // link 19 (right_wrist2), force propagation
  const Real f13_y_p961 = s20 - c20 * inverse_D18_p1;
  const Real f13_y_p962 = c19 * f13_y_p961;
  const Real f13_y_p963 = c20 * inverse_D5_p8;
  const Real f13_y_p964 = c20 * inverse_D5_p2;
  const Real f13_y_p965 = s19 * f13_y_p963 + c19 * f13_y_p964;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p966 = 0.269 * f13_y_p965 + inverse_D5_p23 * f13_y_p962;

  // link 19 (right_wrist2), force propagation
  const Real f13_y_p967 = c20 * inverse_D5_p14;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p968 = 0.269 * f13_y_p967 + s19 * f13_y_p961 - inverse_D5_p29 * f13_y_p962;
  const Real f13_y_p969 = c18 * f13_y_p966 + s18 * f13_y_p968;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p970 = s18 * f13_y_p966 - c18 * f13_y_p968 + inverse_D5_p49 * f13_y_p969;
  const Real f13_y_p971 = inverse_D5_p46 * f13_y_p969;
  const Real f13_y_p972 = c17 * f13_y_p971 + s17 * f13_y_p970;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p973 = f13_y_p965 + inverse_D5_p54 * f13_y_p962;
  const Real f13_y_p974 = f13_y_p967 - inverse_D5_p57 * f13_y_p962;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p975 = s18 * f13_y_p974 + c18 * f13_y_p973 - inverse_D5_p82 * f13_y_p969;
  const Real f13_y_p976 = c19 * f13_y_p963 - s19 * f13_y_p964 - inverse_D5_p86 * f13_y_p962 -
      inverse_D5_p91 * f13_y_p969;
  const Real f13_y_p977 = s17 * f13_y_p976 + c17 * f13_y_p975;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p978 = 0.282 * f13_y_p977 - inverse_D15_p1 * f13_y_p972;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p979 = c18 * f13_y_p974 - s18 * f13_y_p973 + inverse_D5_p64 * f13_y_p969;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p980 = 0.282 * f13_y_p979 + s17 * f13_y_p971 - c17 * f13_y_p970 -
      inverse_D15_p4 * f13_y_p972;
  const Real f13_y_p981 = s16 * f13_y_p978 - c16 * f13_y_p980;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p982 = c16 * f13_y_p978 + s16 * f13_y_p980 + inverse_D14_p1 * f13_y_p981;
  const Real f13_y_p983 = f13_y_p24 * f13_y_p981;
  const Real f13_y_p984 = c15 * f13_y_p982 - s15 * f13_y_p983;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p985 = f13_y_p979 - inverse_D5_p71 * f13_y_p972;
  const Real f13_y_p986 = f13_y_p977 - inverse_D5_p99 * f13_y_p972;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p987 = c16 * f13_y_p985 - s16 * f13_y_p986 + inverse_D5_p140 * f13_y_p981;
  const Real f13_y_p988 = c17 * f13_y_p976 - s17 * f13_y_p975 + inverse_D5_p131 * f13_y_p972 +
      inverse_D5_p137 * f13_y_p981;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p989 = s15 * f13_y_p987 - c15 * f13_y_p988 - inverse_D5_p147 * f13_y_p984;
  const Real f13_y_p990 = s16 * f13_y_p985 + c16 * f13_y_p986 + inverse_D5_p121 * f13_y_p981 +
      inverse_D5_p127 * f13_y_p984;
  const Real f13_y_p991 = c14 * f13_y_p989 + s14 * f13_y_p990;
  const Real f13_y_p992 = c15 * f13_y_p987 + s15 * f13_y_p988 - inverse_D5_p177 * f13_y_p984;
  const Real f13_y_p993 = s15 * f13_y_p982 + c15 * f13_y_p983 - inverse_D5_p365 * f13_y_p984;
  const Real f13_y_p994 = f13_y_p36 * f13_y_p984;
  const Real f13_y_p995 = 0.18 * f13_y_p991 + 0.226 * f13_y_p992 - s14 * f13_y_p993 + c14 *
      f13_y_p994;
  const Real f13_y_p996 = s14 * f13_y_p989 - c14 * f13_y_p990;

  // link 6 (chest3), force propagation
  const Real f13_y_p997 = f13_y_p996 - inverse_D5_p408 * f13_y_p995;
  const Real f13_y_p998 = 0.226 * f13_y_p996 + inverse_D5_p383 * f13_y_p995;
  const Real f13_y_p999 = 0.18 * f13_y_p996 + c14 * f13_y_p993 + s14 * f13_y_p994 -
      inverse_D5_p390 * f13_y_p995;
  const Real f13_y_p1000 = 0.072 * f13_y_p997 + c6 * f13_y_p998 - s6 * f13_y_p999;

  // link 5 (chest2), force propagation
  const Real f13_y_p1001 = s6 * f13_y_p998 + c6 * f13_y_p999 - inverse_D1_p35 * f13_y_p1000;

  // link 6 (chest3), force propagation
  const Real f13_y_p1002 = f13_y_p992 + inverse_D1_p2 * f13_y_p995;
  const Real f13_y_p1003 = f13_y_p991 - inverse_D1_p11 * f13_y_p995;
  const Real f13_y_p1004 = c6 * f13_y_p1002 - s6 * f13_y_p1003;

  // link 5 (chest2), force propagation
  const Real f13_y_p1005 = 0.072 * f13_y_p1004 - inverse_D1_p25 * f13_y_p1000;
  const Real f13_y_p1006 = c5 * f13_y_p1001 + s5 * f13_y_p1005;
  const Real f13_y_p1007 = s6 * f13_y_p1002 + c6 * f13_y_p1003 - inverse_D1_p58 * f13_y_p1000;
  const Real f13_y_p1008 = f13_y_p997 - inverse_D1_p54 * f13_y_p1000;
  const Real f13_y_p1009 = s5 * f13_y_p1007 + c5 * f13_y_p1008;
  const Real f13_y_p1010 = f13_y_p1004 - inverse_D1_p42 * f13_y_p1000;

  // link 4 (chest1), force propagation
  const Real f13_y_p1011 = s4 * (0.21799999999999997 * f13_y_p1010 - s5 * f13_y_p1001 + c5 *
      f13_y_p1005 + inverse_D3_p3 * f13_y_p1006);
  const Real f13_y_p1012 = c4 * (0.21799999999999997 * f13_y_p1009 + inverse_D3_p1 * f13_y_p1006) -
      f13_y_p1011;

  // link 3 (hip), force propagation
  const Real f13_y_p1013 = c5 * f13_y_p1007 - s5 * f13_y_p1008 - inverse_D1_p83 * f13_y_p1006 -
      inverse_D1_p87 * f13_y_p1012;
  const Real f13_y_p1014 = s4 * (f13_y_p1010 + inverse_D1_p48 * f13_y_p1006) - c4 *
      (f13_y_p1009 + inverse_D1_p67 * f13_y_p1006) + inverse_D1_p89 * f13_y_p1012;
  const Real f13_y_p1015 = s3 * f13_y_p1013 - c3 * f13_y_p1014;
  const Real f13_y_p1016 = 0.422 * f13_y_p1015;

  // link 2 (thigh), force propagation
  const Real f13_y_p1017 = s2 * (c3 * f13_y_p1013 + s3 * f13_y_p1014 + inverse_D1_p102 *
      f13_y_p1016) + c2 * (f13_y_p1015 - inverse_D1_p98 * f13_y_p1016);
  const Real f13_y_p1018 = 0.434 * f13_y_p1017;

  // link 1 (calf), force propagation
  const Real f13_y_p1019 = inverse_D1 * f13_y_p1018;

  // link 2 (thigh), force propagation
  const Real f13_y_p1020 = inverse_D2 * f13_y_p1016;

  // link 3 (hip), force propagation
  const Real f13_y_p1021 = inverse_D3 * f13_y_p1012;

  // link 4 (chest1), force propagation
  const Real f13_y_p1022 = inverse_D4 * f13_y_p1006;

  // link 5 (chest2), force propagation
  const Real f13_y_p1023 = inverse_D5 * f13_y_p1000;

  // link 6 (chest3), force propagation
  const Real f13_y_p1024 = inverse_D6 * f13_y_p995;

  // link 1 (calf), force propagation
  const Real f13_y_p1025 = f13_y_p92 * f13_y_p1024 - f13_y_p97 * f13_y_p1023 - f13_y_p103 *
      f13_y_p1022 - f13_y_p109 * f13_y_p1021 - f13_y_p113 * f13_y_p1020;
  const Real f13_y_p1026 = f13_y_p1025 - f13_y_p115 * f13_y_p1019;
  const Real f13_y_p1027 = f13_y_p1026 * f13_y_p126;
  const Real f13_y_p1028 = f13_y_p155 * f13_y_p1024 - f13_y_p160 * f13_y_p1023 - f13_y_p166 *
      f13_y_p1022 - f13_y_p172 * f13_y_p1021 - f13_y_p176 * f13_y_p1020;
  const Real f13_y_p1029 = f13_y_p1028 - f13_y_p178 * f13_y_p1019 + f13_y_p191 * f13_y_p1027;
  const Real f13_y_p1030 = f13_y_p1029 * f13_y_p197;
  const Real f13_y_p1031 = f13_y_p224 * f13_y_p1024 - f13_y_p229 * f13_y_p1023 - f13_y_p235 *
      f13_y_p1022 - f13_y_p241 * f13_y_p1021 - f13_y_p245 * f13_y_p1020;
  const Real f13_y_p1032 = f13_y_p1031 - f13_y_p247 * f13_y_p1019 + f13_y_p260 * f13_y_p1027 -
      f13_y_p264 * f13_y_p1030;
  const Real f13_y_p1033 = f13_y_p1032 * f13_y_p270;
  const Real f13_y_p1034 = f13_y_p306 * f13_y_p1024 - f13_y_p311 * f13_y_p1023 - f13_y_p317 *
      f13_y_p1022 - f13_y_p323 * f13_y_p1021 - f13_y_p327 * f13_y_p1020;
  const Real f13_y_p1035 = f13_y_p1034 - f13_y_p329 * f13_y_p1019 + f13_y_p342 * f13_y_p1027 -
      f13_y_p346 * f13_y_p1030 - f13_y_p350 * f13_y_p1033;
  const Real f13_y_p1036 = f13_y_p1035 * f13_y_p357;
  const Real f13_y_p1037 = f13_y_p393 * f13_y_p1024 - f13_y_p398 * f13_y_p1023 - f13_y_p404 *
      f13_y_p1022 - f13_y_p410 * f13_y_p1021 - f13_y_p414 * f13_y_p1020;
  const Real f13_y_p1038 = f13_y_p1037 - f13_y_p416 * f13_y_p1019 + f13_y_p429 * f13_y_p1027 -
      f13_y_p433 * f13_y_p1030 - f13_y_p437 * f13_y_p1033;
  const Real f13_y_p1039 = f13_y_p1038 - f13_y_p444 * f13_y_p1036;
  const Real f13_y_p1040 = f13_y_p1039 * f13_y_p452;
  const Real f13_y_p1041 = f13_y_p489 * f13_y_p1024 - f13_y_p494 * f13_y_p1023 - f13_y_p500 *
      f13_y_p1022 - f13_y_p506 * f13_y_p1021 - f13_y_p510 * f13_y_p1020;
  const Real f13_y_p1042 = f13_y_p1041 - f13_y_p512 * f13_y_p1019 + f13_y_p525 * f13_y_p1027 -
      f13_y_p529 * f13_y_p1030 - f13_y_p533 * f13_y_p1033;
  const Real f13_y_p1043 = f13_y_p1042 - f13_y_p540 * f13_y_p1036 - f13_y_p545 * f13_y_p1040;
  const Real f13_y_p1044 = f13_y_p1043 * f13_y_p554;

  // link 14 (right_shoulder1), force propagation
  const Real f13_y_p1045 = inverse_D14 * f13_y_p984;

  // link 15 (right_shoulder2), force propagation
  const Real f13_y_p1046 = inverse_D15 * f13_y_p981;

  // link 16 (right_upperarm), force propagation
  const Real f13_y_p1047 = minus_inverse_D16 * f13_y_p972;

  // link 17 (right_lowerarm), force propagation
  const Real f13_y_p1048 = inverse_D17 * f13_y_p969;

  // link 1 (calf), force propagation
  const Real f13_y_p1049 = f13_y_p559 * f13_y_p1048 - f13_y_p562 * f13_y_p1047 + f13_y_p569 *
      f13_y_p1046 + f13_y_p572 * f13_y_p1045 + f13_y_p583 * f13_y_p1024;
  const Real f13_y_p1050 = f13_y_p1049 + f13_y_p588 * f13_y_p1023 + f13_y_p594 * f13_y_p1022 +
      f13_y_p600 * f13_y_p1021 + f13_y_p604 * f13_y_p1020;
  const Real f13_y_p1051 = f13_y_p1050 + f13_y_p606 * f13_y_p1019 + f13_y_p614 * f13_y_p1027 +
      f13_y_p617 * f13_y_p1030 + f13_y_p620 * f13_y_p1033;
  const Real f13_y_p1052 = f13_y_p1051 - f13_y_p623 * f13_y_p1036 - f13_y_p627 * f13_y_p1040 -
      f13_y_p631 * f13_y_p1044;
  const Real f13_y_p1053 = f13_y_p1052 * f13_y_p645;
  const Real f13_y_p1054 = f13_y_p650 * f13_y_p1048 - f13_y_p653 * f13_y_p1047 + f13_y_p660 *
      f13_y_p1046 + f13_y_p663 * f13_y_p1045 - f13_y_p674 * f13_y_p1024;
  const Real f13_y_p1055 = f13_y_p1054 - f13_y_p679 * f13_y_p1023 - f13_y_p685 * f13_y_p1022 -
      f13_y_p691 * f13_y_p1021 - f13_y_p695 * f13_y_p1020;
  const Real f13_y_p1056 = f13_y_p1055 - f13_y_p697 * f13_y_p1019 - f13_y_p705 * f13_y_p1027 -
      f13_y_p708 * f13_y_p1030 - f13_y_p711 * f13_y_p1033;
  const Real f13_y_p1057 = f13_y_p1056 + f13_y_p714 * f13_y_p1036 + f13_y_p718 * f13_y_p1040 +
      f13_y_p722 * f13_y_p1044 - f13_y_p731 * f13_y_p1053;
  const Real f13_y_p1058 = f13_y_p1057 * f13_y_p741;
  const Real f13_y_p1059 = f13_y_p744 * f13_y_p1048 - f13_y_p747 * f13_y_p1047 - f13_y_p754 *
      f13_y_p1046 - f13_y_p757 * f13_y_p1045 - f13_y_p768 * f13_y_p1024;
  const Real f13_y_p1060 = f13_y_p1059 - f13_y_p773 * f13_y_p1023 - f13_y_p779 * f13_y_p1022 -
      f13_y_p785 * f13_y_p1021 - f13_y_p789 * f13_y_p1020;
  const Real f13_y_p1061 = f13_y_p1060 - f13_y_p791 * f13_y_p1019 - f13_y_p799 * f13_y_p1027 -
      f13_y_p802 * f13_y_p1030 - f13_y_p805 * f13_y_p1033;
  const Real f13_y_p1062 = f13_y_p1061 + f13_y_p808 * f13_y_p1036 + f13_y_p812 * f13_y_p1040 +
      f13_y_p816 * f13_y_p1044 - f13_y_p825 * f13_y_p1053;
  const Real f13_y_p1063 = f13_y_p1062 - f13_y_p830 * f13_y_p1058;
  const Real f13_y_p1064 = f13_y_p1063 * f13_y_p841;

  // link 18 (right_wrist1), force propagation
  const Real f13_y_p1065 = inverse_D18 * f13_y_p962;

  // link 19 (right_wrist2), force propagation
  const Real f13_y_p1066 = c20 * minus_inverse_D19;

  // link 1 (calf), force propagation
  const Real f13_y_p1067 = s20 * f13_y_p1066 + f13_y_p844 * f13_y_p1065 - f13_y_p851 * f13_y_p1048 +
      f13_y_p854 * f13_y_p1047 - f13_y_p863 * f13_y_p1046;
  const Real f13_y_p1068 = f13_y_p1067 - f13_y_p866 * f13_y_p1045 - f13_y_p877 * f13_y_p1024 -
      f13_y_p882 * f13_y_p1023 - f13_y_p888 * f13_y_p1022;
  const Real f13_y_p1069 = f13_y_p1068 - f13_y_p894 * f13_y_p1021 - f13_y_p898 * f13_y_p1020 -
      f13_y_p900 * f13_y_p1019 - f13_y_p908 * f13_y_p1027;
  const Real f13_y_p1070 = f13_y_p1069 - f13_y_p911 * f13_y_p1030 - f13_y_p914 * f13_y_p1033 +
      f13_y_p917 * f13_y_p1036 + f13_y_p921 * f13_y_p1040;
  const Real f13_y_p1071 = f13_y_p1070 + f13_y_p925 * f13_y_p1044 + f13_y_p934 * f13_y_p1053 +
      f13_y_p939 * f13_y_p1058 + f13_y_p945 * f13_y_p1064;
  const Real f13_y_p1072 = c20 * f13_y_p947 - f13_y_p962 * f13_y_p946 - f13_y_p969 * f13_y_p635 +
      f13_y_p972 * f13_y_p634 - f13_y_p981 * f13_y_p633;
  const Real f13_y_p1073 = f13_y_p1072 - f13_y_p984 * f13_y_p632 + f13_y_p995 * f13_y_p120 +
      f13_y_p1000 * f13_y_p119 + f13_y_p1006 * f13_y_p118;
  const Real f13_y_p1074 = f13_y_p1073 + f13_y_p1012 * f13_y_p117 + f13_y_p1016 * f13_y_p116 +
      f13_y_p1018 * f13_y_p62 + f13_y_p1026 * f13_y_p127;
  const Real f13_y_p1075 = f13_y_p1074 + f13_y_p1029 * f13_y_p198 + f13_y_p1032 * f13_y_p271 -
      f13_y_p1035 * f13_y_p358 - f13_y_p1039 * f13_y_p453;
  const Real f13_y_p1076 = f13_y_p1075 - f13_y_p1043 * f13_y_p555 + f13_y_p1052 * f13_y_p646 +
      f13_y_p1057 * f13_y_p742 + f13_y_p1063 * f13_y_p842;
  const Real f13_y_p1077 = f13_y_p1076 - f13_y_p1071 * f13_y_p960;
  const Real f13_y_p1078 = f13_y_p1071 * f13_y_p959;
  const Real f13_y_p1079 = c20 * f13_y_p1066 - f13_y_p962 * f13_y_p1065 - f13_y_p969 * f13_y_p1048 +
      f13_y_p972 * f13_y_p1047 - f13_y_p981 * f13_y_p1046;
  const Real f13_y_p1080 = f13_y_p1079 - f13_y_p984 * f13_y_p1045 - f13_y_p995 * f13_y_p1024 -
      f13_y_p1000 * f13_y_p1023 - f13_y_p1006 * f13_y_p1022;
  const Real f13_y_p1081 = f13_y_p1080 - f13_y_p1012 * f13_y_p1021 - f13_y_p1016 * f13_y_p1020 -
      f13_y_p1018 * f13_y_p1019 - f13_y_p1026 * f13_y_p1027;
  const Real f13_y_p1082 = f13_y_p1081 - f13_y_p1029 * f13_y_p1030 - f13_y_p1032 * f13_y_p1033 +
      f13_y_p1035 * f13_y_p1036 + f13_y_p1039 * f13_y_p1040;
  const Real f13_y_p1083 = f13_y_p1082 + f13_y_p1043 * f13_y_p1044 + f13_y_p1052 * f13_y_p1053 +
      f13_y_p1057 * f13_y_p1058 + f13_y_p1063 * f13_y_p1064;
  const Real f13_y_p1084 = 1.0 / (f13_y_p1083 - f13_y_p1071 * f13_y_p1078);
  const Real f13_y_p1085 = f13_y_p1077 * f13_y_p1084;
  const Real f13_y_p1086 = 1065.380700001509 - f13_y_p1 * f13_y_p947 + f13_y_p3 * f13_y_p946 +
      f13_y_p10 * f13_y_p635 - f13_y_p13 * f13_y_p634;
  const Real f13_y_p1087 = f13_y_p1086 + f13_y_p22 * f13_y_p633 + f13_y_p26 * f13_y_p632 +
      f13_y_p38 * f13_y_p120 + f13_y_p43 * f13_y_p119;
  const Real f13_y_p1088 = f13_y_p1087 + f13_y_p49 * f13_y_p118 + f13_y_p55 * f13_y_p117 +
      f13_y_p59 * f13_y_p116 + f13_y_p61 * f13_y_p62;
  const Real f13_y_p1089 = f13_y_p1088 + f13_y_p122 * f13_y_p127 + f13_y_p193 * f13_y_p198 +
      f13_y_p266 * f13_y_p271 - f13_y_p352 * f13_y_p358;
  const Real f13_y_p1090 = f13_y_p1089 - f13_y_p447 * f13_y_p453 - f13_y_p548 * f13_y_p555 -
      f13_y_p639 * f13_y_p646 - f13_y_p735 * f13_y_p742;

  // link 2 (thigh), outward
  const Real minus_a2_y_p1 = 9.81 * c1 - qd[0] * (0.434 * qd[0]);
  const Real minus_a2_y_p2 = 9.81 * s1 - 0.434 * qdd_0[0];
  const Real minus_a2_y = c2 * minus_a2_y_p1 - s2 * minus_a2_y_p2;
  const Real w2_z = qd[0] + qd[1];
  const Real minus_a3_y_p1 = w2_z * w2_z;

  // link 3 (hip), outward
  const Real minus_a3_y_p2 = minus_a2_y - 0.422 * minus_a3_y_p1;

  // link 2 (thigh), outward
  const Real minus_a2_x = s2 * minus_a2_y_p1 + c2 * minus_a2_y_p2;
  const Real wd2_z = qdd_0[0] + qdd_0[1];

  // link 3 (hip), outward
  const Real minus_a3_y_p3 = minus_a2_x - 0.422 * wd2_z;
  const Real minus_a3_y = c3 * minus_a3_y_p2 - s3 * minus_a3_y_p3;
  const Real w3_z = qd[2] + w2_z;

  // link 4 (chest1), outward
  const Real w4_x = s4 * w3_z;
  const Real minus_a5_x_p1 = w4_x * w4_x;
  const Real w4_y = c4 * w3_z;
  const Real minus_a5_x_p2 = w4_y * w4_y;

  // link 5 (chest2), outward
  const Real minus_a5_x_p3 = minus_a3_y - 0.21799999999999997 * (minus_a5_x_p1 + minus_a5_x_p2);

  // link 3 (hip), outward
  const Real minus_a3_x = s3 * minus_a3_y_p2 + c3 * minus_a3_y_p3;
  const Real wd3_z = qdd_0[2] + wd2_z;

  // link 4 (chest1), outward
  const Real minus_a5_x_p4 = c4 * wd3_z;

  // link 5 (chest2), outward
  const Real minus_a5_x_p5 = c4 * minus_a3_x - 0.21799999999999997 * minus_a5_x_p4;
  const Real minus_a5_x = s5 * minus_a5_x_p3 + c5 * minus_a5_x_p5;
  const Real minus_w5_x = qd[3] * s5 - c5 * w4_x;
  const Real minus_w5_y = qd[3] * c5 + s5 * w4_x;
  const Real minus_a6_z_p1 = minus_w5_x * minus_w5_y;

  // link 4 (chest1), outward
  const Real wd4_y_p1 = qd[3] * w4_x;
  const Real wd4_y = minus_a5_x_p4 - wd4_y_p1;

  // link 5 (chest2), outward
  const Real wd5_z = qdd_0[4] + wd4_y;
  const Real minus_a6_z_p2 = wd5_z - minus_a6_z_p1;

  // link 6 (chest3), outward
  const Real minus_a6_z = minus_a5_x - 0.072 * minus_a6_z_p2;

  // link 4 (chest1), outward
  const Real wd4_x_p1 = s4 * wd3_z;
  const Real wd4_x_p2 = qd[3] * w4_y;
  const Real wd4_x = wd4_x_p1 + wd4_x_p2;

  // link 5 (chest2), outward
  const Real minus_wd5_y = qdd_0[3] * c5 + s5 * wd4_x - qd[4] * minus_w5_x;
  const Real w5_z = qd[4] + w4_y;

  // link 6 (chest3), outward
  const Real w6_y = c6 * w5_z + s6 * minus_w5_y;
  const Real wd6_x = s6 * wd5_z - c6 * minus_wd5_y + qd[5] * w6_y;
  const Real w6_z = qd[5] - minus_w5_x;
  const Real minus_a7_y_p1 = w6_y * w6_z;
  const Real minus_a7_y_p2 = wd6_x + minus_a7_y_p1;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_y_p3 = 0.18 * minus_a7_y_p2;

  // link 6 (chest3), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real wd6_y = c6 * wd5_z + s6 * minus_wd5_y - qd[5] * w6_x;
  const Real minus_a7_y_p4 = wd6_y - w6_x * w6_z;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_y_p5 = 0.226 * minus_a7_y_p4;
  const Real minus_a7_y_p6 = minus_a7_y_p5 - (minus_a6_z - minus_a7_y_p3);

  // link 5 (chest2), outward
  const Real minus_a5_y = c5 * minus_a5_x_p3 - s5 * minus_a5_x_p5;
  const Real a6_x_p1 = minus_w5_x * minus_w5_x;
  const Real a6_x_p2 = w5_z * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p3 = a6_x_p1 + a6_x_p2;
  const Real a6_x_p4 = minus_a5_y - 0.072 * a6_x_p3;

  // link 4 (chest1), outward
  const Real a4_y = s4 * minus_a3_x;

  // link 5 (chest2), outward
  const Real a5_z = a4_y - 0.21799999999999997 * wd4_x_p1;
  const Real minus_wd5_x = qdd_0[3] * s5 - c5 * wd4_x + qd[4] * minus_w5_y;
  const Real a6_x_p5 = minus_wd5_x + minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p6 = a5_z + 0.072 * a6_x_p5;
  const Real a6_x = s6 * a6_x_p6 - c6 * a6_x_p4;
  const Real wd6_z = qdd_0[5] - minus_wd5_x;
  const Real minus_a7_y_p7 = w6_x * w6_y;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_y_p8 = 0.18 * (wd6_z - minus_a7_y_p7);

  // link 6 (chest3), outward
  const Real minus_a7_y_p9 = w6_z * w6_z;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_y_p10 = minus_a7_y_p9 + w6_y * w6_y;
  const Real minus_a7_y_p11 = 0.226 * minus_a7_y_p10;
  const Real minus_a7_y_p12 = minus_a7_y_p11 + (a6_x - minus_a7_y_p8);
  const Real minus_a7_y = s7 * minus_a7_y_p6 - c7 * minus_a7_y_p12;

  // link 6 (chest3), outward
  const Real a6_y = c6 * a6_x_p6 + s6 * a6_x_p4;
  const Real minus_a7_z_p1 = w6_x * w6_x;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_z_p2 = 0.18 * (minus_a7_z_p1 + minus_a7_y_p9);

  // link 6 (chest3), outward
  const Real minus_a7_z_p3 = wd6_z + minus_a7_y_p7;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_z_p4 = 0.226 * minus_a7_z_p3;
  const Real minus_a7_z = minus_a7_z_p4 - (a6_y - minus_a7_z_p2);

  // link 8 (left_shoulder2), outward
  const Real minus_a8_x = s8 * minus_a7_z + c8 * minus_a7_y;

  // link 7 (left_shoulder1), outward
  const Real w7_x = c7 * w6_z + s7 * w6_x;

  // link 8 (left_shoulder2), outward
  const Real w8_z = qd[7] + w7_x;

  // link 7 (left_shoulder1), outward
  const Real minus_w7_y = s7 * w6_z - c7 * w6_x;
  const Real w7_z = qd[6] + w6_y;

  // link 8 (left_shoulder2), outward
  const Real w8_y = c8 * w7_z + s8 * minus_w7_y;

  // link 9 (left_upperarm), outward
  const Real w9_x = c9 * w8_z + s9 * w8_y;
  const Real minus_a10_y_p1 = w9_x * w9_x;
  const Real minus_w9_y = s9 * w8_z - c9 * w8_y;
  const Real minus_a10_y_p2 = minus_w9_y * minus_w9_y;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_y_p3 = minus_a8_x + 0.282 * (minus_a10_y_p1 + minus_a10_y_p2);

  // link 7 (left_shoulder1), outward
  const Real a7_x = c7 * minus_a7_y_p6 + s7 * minus_a7_y_p12;

  // link 8 (left_shoulder2), outward
  const Real minus_a8_y = c8 * minus_a7_z - s8 * minus_a7_y;

  // link 9 (left_upperarm), outward
  const Real a9_x = c9 * a7_x - s9 * minus_a8_y;

  // link 7 (left_shoulder1), outward
  const Real wd7_x = c7 * wd6_z + s7 * wd6_x - qd[6] * minus_w7_y;

  // link 8 (left_shoulder2), outward
  const Real wd8_z = qdd_0[7] + wd7_x;

  // link 7 (left_shoulder1), outward
  const Real minus_wd7_y = s7 * wd6_z - c7 * wd6_x + qd[6] * w7_x;
  const Real wd7_z = qdd_0[6] + wd6_y;

  // link 8 (left_shoulder2), outward
  const Real w8_x = s8 * w7_z - c8 * minus_w7_y;
  const Real wd8_y = c8 * wd7_z + s8 * minus_wd7_y - qd[7] * w8_x;

  // link 9 (left_upperarm), outward
  const Real minus_wd9_y = s9 * wd8_z - c9 * wd8_y + qd[8] * w9_x;
  const Real w9_z = qd[8] - w8_x;
  const Real minus_a10_y_p4 = w9_x * w9_z;
  const Real minus_a10_y_p5 = minus_wd9_y - minus_a10_y_p4;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_y_p6 = a9_x + 0.282 * minus_a10_y_p5;
  const Real minus_a10_y = c10 * minus_a10_y_p3 + s10 * minus_a10_y_p6;
  const Real w10_z = qd[9] - minus_w9_y;
  const Real minus_w10_x = s10 * w9_z - c10 * w9_x;

  // link 11 (left_wrist1), outward
  const Real w11_x = s11 * w10_z - c11 * minus_w10_x;
  const Real minus_a12_y_p1 = w11_x * w11_x;
  const Real w11_y = c11 * w10_z + s11 * minus_w10_x;
  const Real minus_a12_y_p2 = w11_y * w11_y;

  // link 12 (left_wrist2), outward
  const Real minus_a12_y_p3 = minus_a10_y + 0.269 * (minus_a12_y_p1 + minus_a12_y_p2);

  // link 10 (left_lowerarm), outward
  const Real minus_a10_x = s10 * minus_a10_y_p3 - c10 * minus_a10_y_p6;

  // link 9 (left_upperarm), outward
  const Real minus_a9_y = s9 * a7_x + c9 * minus_a8_y;
  const Real wd9_x = c9 * wd8_z + s9 * wd8_y - qd[8] * minus_w9_y;
  const Real minus_a10_z_p1 = minus_w9_y * w9_z;
  const Real minus_a10_z_p2 = wd9_x + minus_a10_z_p1;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_z = minus_a9_y - 0.282 * minus_a10_z_p2;

  // link 11 (left_wrist1), outward
  const Real minus_a11_x = s11 * minus_a10_z + c11 * minus_a10_x;

  // link 10 (left_lowerarm), outward
  const Real wd10_z = qdd_0[9] - minus_wd9_y;

  // link 8 (left_shoulder2), outward
  const Real wd8_x = s8 * wd7_z - c8 * minus_wd7_y + qd[7] * w8_y;

  // link 9 (left_upperarm), outward
  const Real wd9_z = qdd_0[8] - wd8_x;

  // link 10 (left_lowerarm), outward
  const Real minus_w10_y = c10 * w9_z + s10 * w9_x;
  const Real minus_wd10_x = s10 * wd9_z - c10 * wd9_x + qd[9] * minus_w10_y;

  // link 11 (left_wrist1), outward
  const Real wd11_y = c11 * wd10_z + s11 * minus_wd10_x - qd[10] * w11_x;
  const Real w11_z = qd[10] + minus_w10_y;
  const Real minus_a12_y_p4 = w11_x * w11_z;
  const Real minus_a12_y_p5 = wd11_y + minus_a12_y_p4;

  // link 12 (left_wrist2), outward
  const Real minus_a12_y_p6 = minus_a11_x + 0.269 * minus_a12_y_p5;
  const Real minus_a12_y = c12 * minus_a12_y_p3 - s12 * minus_a12_y_p6;

  // link 11 (left_wrist1), outward
  const Real minus_a11_y = c11 * minus_a10_z - s11 * minus_a10_x;
  const Real wd11_x = s11 * wd10_z - c11 * minus_wd10_x + qd[10] * w11_y;
  const Real minus_a12_z_p1 = w11_y * w11_z;
  const Real minus_a12_z_p2 = wd11_x - minus_a12_z_p1;

  // link 12 (left_wrist2), outward
  const Real minus_a12_z = minus_a11_y - 0.269 * minus_a12_z_p2;

  // link 13 (left_hand), outward
  const Real minus_a13_x = s13 * minus_a12_z + c13 * minus_a12_y;

  // link 24 (right_eye), outward
  const Real f13_y_p1091 = 9.81 + xdd_cmd[2];
  const Real f13_y_p1092 = c1 * f13_y_p1091 + xdd_cmd[0] * s1;
  const Real f13_y_p1093 = s1 * f13_y_p1091 - xdd_cmd[0] * c1;
  const Real f13_y_p1094 = c2 * f13_y_p1092 - s2 * f13_y_p1093;
  const Real f13_y_p1095 = s2 * f13_y_p1092 + c2 * f13_y_p1093;
  const Real f13_y_p1096 = c3 * f13_y_p1094 - s3 * f13_y_p1095;
  const Real f13_y_p1097 = s3 * f13_y_p1094 + c3 * f13_y_p1095;
  const Real f13_y_p1098 = xdd_cmd[1] * s4 - c4 * f13_y_p1097;
  const Real f13_y_p1099 = s5 * f13_y_p1096 - c5 * f13_y_p1098;
  const Real f13_y_p1100 = c5 * f13_y_p1096 + s5 * f13_y_p1098;
  const Real f13_y_p1101 = xdd_cmd[1] * c4 + s4 * f13_y_p1097;
  const Real f13_y_p1102 = s6 * f13_y_p1101 - c6 * f13_y_p1100;
  const Real f13_y_p1103 = c7 * f13_y_p1099 - s7 * f13_y_p1102;
  const Real f13_y_p1104 = s7 * f13_y_p1099 + c7 * f13_y_p1102;
  const Real f13_y_p1105 = c6 * f13_y_p1101 + s6 * f13_y_p1100;
  const Real f13_y_p1106 = c8 * f13_y_p1105 - s8 * f13_y_p1104;
  const Real f13_y_p1107 = s9 * f13_y_p1103 + c9 * f13_y_p1106;
  const Real f13_y_p1108 = c9 * f13_y_p1103 - s9 * f13_y_p1106;
  const Real f13_y_p1109 = s8 * f13_y_p1105 + c8 * f13_y_p1104;
  const Real f13_y_p1110 = s10 * f13_y_p1109 - c10 * f13_y_p1108;
  const Real f13_y_p1111 = c11 * f13_y_p1107 - s11 * f13_y_p1110;
  const Real f13_y_p1112 = s11 * f13_y_p1107 + c11 * f13_y_p1110;
  const Real f13_y_p1113 = c10 * f13_y_p1109 + s10 * f13_y_p1108;
  const Real f13_y_p1114 = c12 * f13_y_p1113 - s12 * f13_y_p1112;

  // link 12 (left_wrist2), outward
  const Real w12_z = qd[11] + w11_y;
  const Real minus_w12_y = c12 * w11_z + s12 * w11_x;

  // link 13 (left_hand), outward
  const Real w13_y = c13 * w12_z + s13 * minus_w12_y;
  const Real f13_y_p1115 = w13_y * w13_y;

  // link 12 (left_wrist2), outward
  const Real minus_w12_x = s12 * w11_z - c12 * w11_x;

  // link 13 (left_hand), outward
  const Real w13_z = qd[12] - minus_w12_x;
  const Real f13_y_p1116 = w13_z * w13_z;

  // link 24 (right_eye), outward
  const Real f13_y_p1117 = f13_y_p1115 + f13_y_p1116;
  const Real f13_y_p1118 = minus_a13_x + (s13 * f13_y_p1111 + c13 * f13_y_p1114) + 0.086 *
      f13_y_p1117;

  // link 13 (left_hand), outward
  const Real minus_a13_y = c13 * minus_a12_z - s13 * minus_a12_y;

  // link 24 (right_eye), outward
  const Real f13_y_p1119 = xdd_cmd[5] * c1 + xdd_cmd[3] * s1;
  const Real f13_y_p1120 = xdd_cmd[5] * s1 - xdd_cmd[3] * c1;
  const Real f13_y_p1121 = c2 * f13_y_p1119 - s2 * f13_y_p1120;
  const Real f13_y_p1122 = s2 * f13_y_p1119 + c2 * f13_y_p1120;
  const Real f13_y_p1123 = c3 * f13_y_p1121 - s3 * f13_y_p1122;
  const Real f13_y_p1124 = s3 * f13_y_p1121 + c3 * f13_y_p1122;
  const Real f13_y_p1125 = xdd_cmd[4] * s4 - c4 * f13_y_p1124;
  const Real f13_y_p1126 = s5 * f13_y_p1123 - c5 * f13_y_p1125;
  const Real f13_y_p1127 = c5 * f13_y_p1123 + s5 * f13_y_p1125;
  const Real f13_y_p1128 = xdd_cmd[4] * c4 + s4 * f13_y_p1124;
  const Real f13_y_p1129 = s6 * f13_y_p1128 - c6 * f13_y_p1127;
  const Real f13_y_p1130 = c7 * f13_y_p1126 - s7 * f13_y_p1129;
  const Real f13_y_p1131 = s7 * f13_y_p1126 + c7 * f13_y_p1129;
  const Real f13_y_p1132 = c6 * f13_y_p1128 + s6 * f13_y_p1127;
  const Real f13_y_p1133 = c8 * f13_y_p1132 - s8 * f13_y_p1131;
  const Real f13_y_p1134 = s9 * f13_y_p1130 + c9 * f13_y_p1133;
  const Real f13_y_p1135 = c9 * f13_y_p1130 - s9 * f13_y_p1133;
  const Real f13_y_p1136 = s8 * f13_y_p1132 + c8 * f13_y_p1131;
  const Real f13_y_p1137 = s10 * f13_y_p1136 - c10 * f13_y_p1135;
  const Real f13_y_p1138 = s11 * f13_y_p1134 + c11 * f13_y_p1137;
  const Real f13_y_p1139 = c10 * f13_y_p1136 + s10 * f13_y_p1135;

  // link 10 (left_lowerarm), outward
  const Real minus_wd10_y = c10 * wd9_z + s10 * wd9_x - qd[9] * minus_w10_x;

  // link 11 (left_wrist1), outward
  const Real wd11_z = qdd_0[10] + minus_wd10_y;

  // link 12 (left_wrist2), outward
  const Real minus_wd12_x = s12 * wd11_z - c12 * wd11_x + qd[11] * minus_w12_y;

  // link 13 (left_hand), outward
  const Real wd13_z = qdd_0[12] - minus_wd12_x;

  // link 24 (right_eye), outward
  const Real f13_y_p1140 = wd13_z - s12 * f13_y_p1139 - c12 * f13_y_p1138;

  // link 13 (left_hand), outward
  const Real w13_x = s13 * w12_z - c13 * minus_w12_y;
  const Real f13_y_p1141 = w13_x * w13_y;
  const Real f13_y_p1142 = wd13_z + f13_y_p1141;

  // link 1 (calf), force propagation
  const Real f13_y_p1143 = 0.086 * (f13_y_p1142 - f13_y_p1140) -
      (minus_a13_y + (c13 * f13_y_p1111 - s13 * f13_y_p1114) + f13_y_p1118 * f13_y_p194);

  // link 12 (left_wrist2), outward
  const Real minus_a12_x = s12 * minus_a12_y_p3 + c12 * minus_a12_y_p6;

  // link 1 (calf), force propagation
  const Real f13_y_p1144 = minus_a12_x + (s12 * f13_y_p1113 + c12 * f13_y_p1112) + f13_y_p1118 *
      f13_y_p261 + f13_y_p267 * f13_y_p1143;

  // link 24 (right_eye), outward
  const Real f13_y_p1145 = c11 * f13_y_p1134 - s11 * f13_y_p1137;

  // link 12 (left_wrist2), outward
  const Real wd12_z = qdd_0[11] + wd11_y;
  const Real minus_wd12_y = c12 * wd11_z + s12 * wd11_x - qd[11] * minus_w12_x;

  // link 13 (left_hand), outward
  const Real wd13_y = c13 * wd12_z + s13 * minus_wd12_y - qd[12] * w13_x;

  // link 24 (right_eye), outward
  const Real f13_y_p1146 = c12 * f13_y_p1139 - s12 * f13_y_p1138;
  const Real f13_y_p1147 = wd13_y - c13 * f13_y_p1145 + s13 * f13_y_p1146;

  // link 13 (left_hand), outward
  const Real f13_y_p1148 = w13_x * w13_z;
  const Real f13_y_p1149 = wd13_y - f13_y_p1148;

  // link 1 (calf), force propagation
  const Real f13_y_p1150 = 0.086 * (f13_y_p1149 - f13_y_p1147) + f13_y_p1144;

  // link 13 (left_hand), outward
  const Real wd13_x = s13 * wd12_z - c13 * minus_wd12_y + qd[12] * w13_y;

  // link 1 (calf), force propagation
  const Real f13_y_p1151 = wd13_x - s13 * f13_y_p1145 - c13 * f13_y_p1146 - f13_y_p1118 *
      f13_y_p343 - f13_y_p347 * f13_y_p1143;
  const Real f13_y_p1152 = f13_y_p1151 + f13_y_p353 * f13_y_p1150;
  const Real f13_y_p1153 = f13_y_p1147 - f13_y_p1118 * f13_y_p430 - f13_y_p434 * f13_y_p1143 +
      f13_y_p438 * f13_y_p1150 - f13_y_p448 * f13_y_p1152;
  const Real f13_y_p1154 = f13_y_p1140 + f13_y_p1118 * f13_y_p526 + f13_y_p530 * f13_y_p1143 -
      f13_y_p534 * f13_y_p1150 + f13_y_p541 * f13_y_p1152;
  const Real f13_y_p1155 = f13_y_p1154 + f13_y_p549 * f13_y_p1153;

  // link 14 (right_shoulder1), outward
  const Real minus_a14_y_p1 = minus_a7_y_p5 - (minus_a6_z + minus_a7_y_p3);
  const Real minus_a14_y_p2 = minus_a7_y_p11 + (a6_x + minus_a7_y_p8);
  const Real minus_a14_y = s14 * minus_a14_y_p1 - c14 * minus_a14_y_p2;
  const Real minus_a14_z = minus_a7_z_p4 - (a6_y + minus_a7_z_p2);

  // link 15 (right_shoulder2), outward
  const Real minus_a15_x = s15 * minus_a14_z + c15 * minus_a14_y;

  // link 14 (right_shoulder1), outward
  const Real w14_x = c14 * w6_z + s14 * w6_x;

  // link 15 (right_shoulder2), outward
  const Real w15_z = qd[14] + w14_x;

  // link 14 (right_shoulder1), outward
  const Real minus_w14_y = s14 * w6_z - c14 * w6_x;
  const Real w14_z = qd[13] + w6_y;

  // link 15 (right_shoulder2), outward
  const Real w15_y = c15 * w14_z + s15 * minus_w14_y;

  // link 16 (right_upperarm), outward
  const Real w16_x = c16 * w15_z + s16 * w15_y;
  const Real minus_a17_y_p1 = w16_x * w16_x;
  const Real minus_w16_y = s16 * w15_z - c16 * w15_y;
  const Real minus_a17_y_p2 = minus_w16_y * minus_w16_y;

  // link 17 (right_lowerarm), outward
  const Real minus_a17_y_p3 = minus_a15_x + 0.282 * (minus_a17_y_p1 + minus_a17_y_p2);

  // link 14 (right_shoulder1), outward
  const Real a14_x = c14 * minus_a14_y_p1 + s14 * minus_a14_y_p2;

  // link 15 (right_shoulder2), outward
  const Real minus_a15_y = c15 * minus_a14_z - s15 * minus_a14_y;

  // link 16 (right_upperarm), outward
  const Real a16_x = c16 * a14_x - s16 * minus_a15_y;

  // link 14 (right_shoulder1), outward
  const Real wd14_x = c14 * wd6_z + s14 * wd6_x - qd[13] * minus_w14_y;

  // link 15 (right_shoulder2), outward
  const Real wd15_z = qdd_0[14] + wd14_x;

  // link 14 (right_shoulder1), outward
  const Real minus_wd14_y = s14 * wd6_z - c14 * wd6_x + qd[13] * w14_x;
  const Real wd14_z = qdd_0[13] + wd6_y;

  // link 15 (right_shoulder2), outward
  const Real w15_x = s15 * w14_z - c15 * minus_w14_y;
  const Real wd15_y = c15 * wd14_z + s15 * minus_wd14_y - qd[14] * w15_x;

  // link 16 (right_upperarm), outward
  const Real minus_wd16_y = s16 * wd15_z - c16 * wd15_y + qd[15] * w16_x;
  const Real w16_z = qd[15] - w15_x;
  const Real minus_a17_y_p4 = w16_x * w16_z;
  const Real minus_a17_y_p5 = minus_wd16_y - minus_a17_y_p4;

  // link 17 (right_lowerarm), outward
  const Real minus_a17_y_p6 = a16_x + 0.282 * minus_a17_y_p5;
  const Real minus_a17_y = c17 * minus_a17_y_p3 + s17 * minus_a17_y_p6;
  const Real w17_z = qd[16] - minus_w16_y;
  const Real minus_w17_x = s17 * w16_z - c17 * w16_x;

  // link 18 (right_wrist1), outward
  const Real w18_x = s18 * w17_z - c18 * minus_w17_x;
  const Real minus_a19_y_p1 = w18_x * w18_x;
  const Real w18_y = c18 * w17_z + s18 * minus_w17_x;
  const Real minus_a19_y_p2 = w18_y * w18_y;

  // link 19 (right_wrist2), outward
  const Real minus_a19_y_p3 = minus_a17_y + 0.269 * (minus_a19_y_p1 + minus_a19_y_p2);

  // link 17 (right_lowerarm), outward
  const Real minus_a17_x = s17 * minus_a17_y_p3 - c17 * minus_a17_y_p6;

  // link 16 (right_upperarm), outward
  const Real minus_a16_y = s16 * a14_x + c16 * minus_a15_y;
  const Real wd16_x = c16 * wd15_z + s16 * wd15_y - qd[15] * minus_w16_y;
  const Real minus_a17_z_p1 = minus_w16_y * w16_z;
  const Real minus_a17_z_p2 = wd16_x + minus_a17_z_p1;

  // link 17 (right_lowerarm), outward
  const Real minus_a17_z = minus_a16_y - 0.282 * minus_a17_z_p2;

  // link 18 (right_wrist1), outward
  const Real minus_a18_x = s18 * minus_a17_z + c18 * minus_a17_x;

  // link 17 (right_lowerarm), outward
  const Real wd17_z = qdd_0[16] - minus_wd16_y;

  // link 15 (right_shoulder2), outward
  const Real wd15_x = s15 * wd14_z - c15 * minus_wd14_y + qd[14] * w15_y;

  // link 16 (right_upperarm), outward
  const Real wd16_z = qdd_0[15] - wd15_x;

  // link 17 (right_lowerarm), outward
  const Real minus_w17_y = c17 * w16_z + s17 * w16_x;
  const Real minus_wd17_x = s17 * wd16_z - c17 * wd16_x + qd[16] * minus_w17_y;

  // link 18 (right_wrist1), outward
  const Real wd18_y = c18 * wd17_z + s18 * minus_wd17_x - qd[17] * w18_x;
  const Real w18_z = qd[17] + minus_w17_y;
  const Real minus_a19_y_p4 = w18_x * w18_z;
  const Real minus_a19_y_p5 = wd18_y + minus_a19_y_p4;

  // link 19 (right_wrist2), outward
  const Real minus_a19_y_p6 = minus_a18_x + 0.269 * minus_a19_y_p5;
  const Real minus_a19_y = c19 * minus_a19_y_p3 - s19 * minus_a19_y_p6;

  // link 18 (right_wrist1), outward
  const Real minus_a18_y = c18 * minus_a17_z - s18 * minus_a17_x;
  const Real wd18_x = s18 * wd17_z - c18 * minus_wd17_x + qd[17] * w18_y;
  const Real minus_a19_z_p1 = w18_y * w18_z;
  const Real minus_a19_z_p2 = wd18_x - minus_a19_z_p1;

  // link 19 (right_wrist2), outward
  const Real minus_a19_z = minus_a18_y - 0.269 * minus_a19_z_p2;

  // link 20 (right_hand), outward
  const Real minus_a20_x = s20 * minus_a19_z + c20 * minus_a19_y;

  // link 24 (right_eye), outward
  const Real f13_y_p1156 = 9.81 + xdd_cmd[8];
  const Real f13_y_p1157 = c1 * f13_y_p1156 + xdd_cmd[6] * s1;
  const Real f13_y_p1158 = s1 * f13_y_p1156 - xdd_cmd[6] * c1;
  const Real f13_y_p1159 = c2 * f13_y_p1157 - s2 * f13_y_p1158;
  const Real f13_y_p1160 = s2 * f13_y_p1157 + c2 * f13_y_p1158;
  const Real f13_y_p1161 = c3 * f13_y_p1159 - s3 * f13_y_p1160;
  const Real f13_y_p1162 = s3 * f13_y_p1159 + c3 * f13_y_p1160;
  const Real f13_y_p1163 = xdd_cmd[7] * s4 - c4 * f13_y_p1162;
  const Real f13_y_p1164 = s5 * f13_y_p1161 - c5 * f13_y_p1163;
  const Real f13_y_p1165 = c5 * f13_y_p1161 + s5 * f13_y_p1163;
  const Real f13_y_p1166 = xdd_cmd[7] * c4 + s4 * f13_y_p1162;
  const Real f13_y_p1167 = s6 * f13_y_p1166 - c6 * f13_y_p1165;
  const Real f13_y_p1168 = c14 * f13_y_p1164 - s14 * f13_y_p1167;
  const Real f13_y_p1169 = s14 * f13_y_p1164 + c14 * f13_y_p1167;
  const Real f13_y_p1170 = c6 * f13_y_p1166 + s6 * f13_y_p1165;
  const Real f13_y_p1171 = c15 * f13_y_p1170 - s15 * f13_y_p1169;
  const Real f13_y_p1172 = s16 * f13_y_p1168 + c16 * f13_y_p1171;
  const Real f13_y_p1173 = c16 * f13_y_p1168 - s16 * f13_y_p1171;
  const Real f13_y_p1174 = s15 * f13_y_p1170 + c15 * f13_y_p1169;
  const Real f13_y_p1175 = s17 * f13_y_p1174 - c17 * f13_y_p1173;
  const Real f13_y_p1176 = c18 * f13_y_p1172 - s18 * f13_y_p1175;
  const Real f13_y_p1177 = s18 * f13_y_p1172 + c18 * f13_y_p1175;
  const Real f13_y_p1178 = c17 * f13_y_p1174 + s17 * f13_y_p1173;
  const Real f13_y_p1179 = c19 * f13_y_p1178 - s19 * f13_y_p1177;

  // link 19 (right_wrist2), outward
  const Real w19_z = qd[18] + w18_y;
  const Real minus_w19_y = c19 * w18_z + s19 * w18_x;

  // link 20 (right_hand), outward
  const Real w20_y = c20 * w19_z + s20 * minus_w19_y;
  const Real f13_y_p1180 = w20_y * w20_y;

  // link 19 (right_wrist2), outward
  const Real minus_w19_x = s19 * w18_z - c19 * w18_x;

  // link 20 (right_hand), outward
  const Real w20_z = qd[19] - minus_w19_x;
  const Real f13_y_p1181 = w20_z * w20_z;

  // link 24 (right_eye), outward
  const Real f13_y_p1182 = f13_y_p1180 + f13_y_p1181;

  // link 1 (calf), force propagation
  const Real f13_y_p1183 = minus_a20_x + (s20 * f13_y_p1176 + c20 * f13_y_p1179) + 0.086 *
      f13_y_p1182 - f13_y_p1118 * f13_y_p615;
  const Real f13_y_p1184 = f13_y_p1183 + f13_y_p618 * f13_y_p1143 - f13_y_p621 * f13_y_p1150 -
      f13_y_p624 * f13_y_p1152 - f13_y_p628 * f13_y_p1153;
  const Real f13_y_p1185 = f13_y_p1184 + f13_y_p640 * f13_y_p1155;

  // link 20 (right_hand), outward
  const Real minus_a20_y = c20 * minus_a19_z - s20 * minus_a19_y;

  // link 1 (calf), force propagation
  const Real f13_y_p1186 = minus_a20_y + (c20 * f13_y_p1176 - s20 * f13_y_p1179) - f13_y_p1118 *
      f13_y_p706 + f13_y_p709 * f13_y_p1143;
  const Real f13_y_p1187 = f13_y_p1186 - f13_y_p712 * f13_y_p1150 - f13_y_p715 * f13_y_p1152 -
      f13_y_p719 * f13_y_p1153 + f13_y_p723 * f13_y_p1155;

  // link 24 (right_eye), outward
  const Real f13_y_p1188 = xdd_cmd[11] * c1 + xdd_cmd[9] * s1;
  const Real f13_y_p1189 = xdd_cmd[11] * s1 - xdd_cmd[9] * c1;
  const Real f13_y_p1190 = c2 * f13_y_p1188 - s2 * f13_y_p1189;
  const Real f13_y_p1191 = s2 * f13_y_p1188 + c2 * f13_y_p1189;
  const Real f13_y_p1192 = c3 * f13_y_p1190 - s3 * f13_y_p1191;
  const Real f13_y_p1193 = s3 * f13_y_p1190 + c3 * f13_y_p1191;
  const Real f13_y_p1194 = xdd_cmd[10] * s4 - c4 * f13_y_p1193;
  const Real f13_y_p1195 = s5 * f13_y_p1192 - c5 * f13_y_p1194;
  const Real f13_y_p1196 = c5 * f13_y_p1192 + s5 * f13_y_p1194;
  const Real f13_y_p1197 = xdd_cmd[10] * c4 + s4 * f13_y_p1193;
  const Real f13_y_p1198 = s6 * f13_y_p1197 - c6 * f13_y_p1196;
  const Real f13_y_p1199 = c14 * f13_y_p1195 - s14 * f13_y_p1198;
  const Real f13_y_p1200 = s14 * f13_y_p1195 + c14 * f13_y_p1198;
  const Real f13_y_p1201 = c6 * f13_y_p1197 + s6 * f13_y_p1196;
  const Real f13_y_p1202 = c15 * f13_y_p1201 - s15 * f13_y_p1200;
  const Real f13_y_p1203 = s16 * f13_y_p1199 + c16 * f13_y_p1202;
  const Real f13_y_p1204 = c16 * f13_y_p1199 - s16 * f13_y_p1202;
  const Real f13_y_p1205 = s15 * f13_y_p1201 + c15 * f13_y_p1200;
  const Real f13_y_p1206 = s17 * f13_y_p1205 - c17 * f13_y_p1204;
  const Real f13_y_p1207 = s18 * f13_y_p1203 + c18 * f13_y_p1206;
  const Real f13_y_p1208 = c17 * f13_y_p1205 + s17 * f13_y_p1204;

  // link 17 (right_lowerarm), outward
  const Real minus_wd17_y = c17 * wd16_z + s17 * wd16_x - qd[16] * minus_w17_x;

  // link 18 (right_wrist1), outward
  const Real wd18_z = qdd_0[17] + minus_wd17_y;

  // link 19 (right_wrist2), outward
  const Real minus_wd19_x = s19 * wd18_z - c19 * wd18_x + qd[18] * minus_w19_y;

  // link 20 (right_hand), outward
  const Real wd20_z = qdd_0[19] - minus_wd19_x;

  // link 24 (right_eye), outward
  const Real f13_y_p1209 = wd20_z - s19 * f13_y_p1208 - c19 * f13_y_p1207;

  // link 20 (right_hand), outward
  const Real w20_x = s20 * w19_z - c20 * minus_w19_y;
  const Real f13_y_p1210 = w20_x * w20_y;
  const Real f13_y_p1211 = wd20_z + f13_y_p1210;

  // link 1 (calf), force propagation
  const Real f13_y_p1212 = 0.086 * (f13_y_p1211 - f13_y_p1209) -
      (f13_y_p1187 + f13_y_p736 * f13_y_p1185);

  // link 19 (right_wrist2), outward
  const Real minus_a19_x = s19 * minus_a19_y_p3 + c19 * minus_a19_y_p6;

  // link 1 (calf), force propagation
  const Real f13_y_p1213 = minus_a19_x + (s19 * f13_y_p1178 + c19 * f13_y_p1177) - f13_y_p1118 *
      f13_y_p800 + f13_y_p803 * f13_y_p1143;
  const Real f13_y_p1214 = f13_y_p1213 - f13_y_p806 * f13_y_p1150 - f13_y_p809 * f13_y_p1152 -
      f13_y_p813 * f13_y_p1153 + f13_y_p817 * f13_y_p1155;

  // link 24 (right_eye), outward
  const Real f13_y_p1215 = c18 * f13_y_p1203 - s18 * f13_y_p1206;

  // link 19 (right_wrist2), outward
  const Real wd19_z = qdd_0[18] + wd18_y;
  const Real minus_wd19_y = c19 * wd18_z + s19 * wd18_x - qd[18] * minus_w19_x;

  // link 20 (right_hand), outward
  const Real wd20_y = c20 * wd19_z + s20 * minus_wd19_y - qd[19] * w20_x;

  // link 24 (right_eye), outward
  const Real f13_y_p1216 = c19 * f13_y_p1208 - s19 * f13_y_p1207;
  const Real f13_y_p1217 = wd20_y - c20 * f13_y_p1215 + s20 * f13_y_p1216;

  // link 20 (right_hand), outward
  const Real f13_y_p1218 = w20_x * w20_z;
  const Real f13_y_p1219 = wd20_y - f13_y_p1218;

  // link 1 (calf), force propagation
  const Real f13_y_p1220 = 0.086 * (f13_y_p1219 - f13_y_p1217) +
      (f13_y_p1214 + f13_y_p826 * f13_y_p1185 + f13_y_p836 * f13_y_p1212);

  // link 20 (right_hand), outward
  const Real wd20_x = s20 * wd19_z - c20 * minus_wd19_y + qd[19] * w20_y;

  // link 1 (calf), force propagation
  const Real f13_y_p1221 = wd20_x - s20 * f13_y_p1215 - c20 * f13_y_p1216 + f13_y_p1118 *
      f13_y_p909 - f13_y_p912 * f13_y_p1143;
  const Real f13_y_p1222 = f13_y_p1221 + f13_y_p915 * f13_y_p1150 + f13_y_p918 * f13_y_p1152 +
      f13_y_p922 * f13_y_p1153 - f13_y_p926 * f13_y_p1155;
  const Real f13_y_p1223 = f13_y_p1222 + f13_y_p935 * f13_y_p1185 + f13_y_p940 * f13_y_p1212 -
      f13_y_p953 * f13_y_p1220;
  const Real f13_y_p1224 = f13_y_p1217 + f13_y_p1118 * f13_y_p1027 - f13_y_p1030 * f13_y_p1143 +
      f13_y_p1033 * f13_y_p1150 + f13_y_p1036 * f13_y_p1152;
  const Real f13_y_p1225 = f13_y_p1224 + f13_y_p1040 * f13_y_p1153 - f13_y_p1044 * f13_y_p1155 +
      f13_y_p1053 * f13_y_p1185 + f13_y_p1058 * f13_y_p1212;
  const Real f13_y_p1226 = f13_y_p1225 - f13_y_p1064 * f13_y_p1220 - f13_y_p1078 * f13_y_p1223;
  const Real f13_y_p1227 = f13_y_p1209 - f13_y_p1118 * f13_y_p127 + f13_y_p198 * f13_y_p1143 -
      f13_y_p271 * f13_y_p1150 - f13_y_p358 * f13_y_p1152;
  const Real f13_y_p1228 = f13_y_p1227 - f13_y_p453 * f13_y_p1153 + f13_y_p555 * f13_y_p1155 +
      f13_y_p646 * f13_y_p1185 + f13_y_p742 * f13_y_p1212;
  const Real f13_y_p1229 = 1.0 / (f13_y_p1090 - f13_y_p835 * f13_y_p842 + f13_y_p952 * f13_y_p960 +
      f13_y_p1077 * f13_y_p1085) * (f13_y_p1228 - f13_y_p842 * f13_y_p1220 - f13_y_p960 *
      f13_y_p1223 - f13_y_p1085 * f13_y_p1226);
  const Real f13_y_p1230 = f13_y_p1084 * f13_y_p1226 + f13_y_p1085 * f13_y_p1229;
  const Real f13_y_p1231 = f13_y_p959 * f13_y_p1223 - f13_y_p1078 * f13_y_p1230 + f13_y_p960 *
      f13_y_p1229;
  const Real f13_y_p1232 = f13_y_p841 * f13_y_p1220 + f13_y_p953 * f13_y_p1231 + f13_y_p1064 *
      f13_y_p1230 - f13_y_p842 * f13_y_p1229;
  const Real f13_y_p1233 = f13_y_p741 * f13_y_p1212 + f13_y_p836 * f13_y_p1232 - f13_y_p940 *
      f13_y_p1231 - f13_y_p1058 * f13_y_p1230 + f13_y_p742 * f13_y_p1229;
  const Real f13_y_p1234 = f13_y_p645 * f13_y_p1185 - f13_y_p736 * f13_y_p1233 + f13_y_p826 *
      f13_y_p1232 - f13_y_p935 * f13_y_p1231 - f13_y_p1053 * f13_y_p1230;
  const Real f13_y_p1235 = f13_y_p1234 + f13_y_p646 * f13_y_p1229;
  const Real f13_y_p1236 = f13_y_p554 * f13_y_p1155 + f13_y_p640 * f13_y_p1235 - f13_y_p723 *
      f13_y_p1233 + f13_y_p817 * f13_y_p1232 + f13_y_p926 * f13_y_p1231;
  const Real f13_y_p1237 = f13_y_p1236 + f13_y_p1044 * f13_y_p1230 + f13_y_p555 * f13_y_p1229;
  const Real f13_y_p1238 = f13_y_p452 * f13_y_p1153 + f13_y_p549 * f13_y_p1237 - f13_y_p628 *
      f13_y_p1235 + f13_y_p719 * f13_y_p1233 - f13_y_p813 * f13_y_p1232;
  const Real f13_y_p1239 = f13_y_p1238 - f13_y_p922 * f13_y_p1231 - f13_y_p1040 * f13_y_p1230 -
      f13_y_p453 * f13_y_p1229;
  const Real f13_y_p1240 = f13_y_p357 * f13_y_p1152 - f13_y_p448 * f13_y_p1239 + f13_y_p541 *
      f13_y_p1237 - f13_y_p624 * f13_y_p1235 + f13_y_p715 * f13_y_p1233;
  const Real f13_y_p1241 = f13_y_p1240 - f13_y_p809 * f13_y_p1232 - f13_y_p918 * f13_y_p1231 -
      f13_y_p1036 * f13_y_p1230 - f13_y_p358 * f13_y_p1229;
  const Real f13_y_p1242 = f13_y_p270 * f13_y_p1150 - f13_y_p353 * f13_y_p1241 - f13_y_p438 *
      f13_y_p1239 + f13_y_p534 * f13_y_p1237 + f13_y_p621 * f13_y_p1235;
  const Real f13_y_p1243 = f13_y_p1242 - f13_y_p712 * f13_y_p1233 + f13_y_p806 * f13_y_p1232 +
      f13_y_p915 * f13_y_p1231 + f13_y_p1033 * f13_y_p1230;
  const Real f13_y_p1244 = f13_y_p1243 + f13_y_p271 * f13_y_p1229;
  const Real f13_y_p1245 = f13_y_p197 * f13_y_p1143 + f13_y_p267 * f13_y_p1244 + f13_y_p347 *
      f13_y_p1241 + f13_y_p434 * f13_y_p1239 - f13_y_p530 * f13_y_p1237;
  const Real f13_y_p1246 = f13_y_p1245 - f13_y_p618 * f13_y_p1235 + f13_y_p709 * f13_y_p1233 -
      f13_y_p803 * f13_y_p1232 - f13_y_p912 * f13_y_p1231;
  const Real f13_y_p1247 = f13_y_p1246 - f13_y_p1030 * f13_y_p1230 - f13_y_p198 * f13_y_p1229;

  // link 13 (left_hand), outward
  const Real f13_y_p1248 = w13_x * w13_x;

  // link 24 (right_eye), inertial wrench
  const Real f13_y = f13_y_p1247 + 0.002865001425 * (f13_y_p1248 + f13_y_p1116) + 0.01626499875 *
      f13_y_p1142;

  // link 12 (left_wrist2), outward
  const Real minus_f12_z_p1 = minus_wd12_x + minus_w12_y * w12_z;
  const Real minus_f12_z_p2 = minus_w12_x * w12_z;
  const Real minus_f12_z_p3 = minus_wd12_y - minus_f12_z_p2;

  // link 24 (right_eye), inertial wrench
  const Real minus_f13_x_p1 = f13_y_p1118 * f13_y_p126 - f13_y_p194 * f13_y_p1247 + f13_y_p261 *
      f13_y_p1244 + f13_y_p343 * f13_y_p1241 + f13_y_p430 * f13_y_p1239;
  const Real minus_f13_x_p2 = minus_f13_x_p1 - f13_y_p526 * f13_y_p1237 + f13_y_p615 * f13_y_p1235 -
      f13_y_p706 * f13_y_p1233 + f13_y_p800 * f13_y_p1232;

  // link 13 (left_hand), outward
  const Real minus_f13_x_p3 = wd13_z - f13_y_p1141;

  // link 24 (right_eye), inertial wrench
  const Real minus_f13_x_p4 = minus_f13_x_p2 + f13_y_p909 * f13_y_p1231 + f13_y_p1027 *
      f13_y_p1230 + f13_y_p127 * f13_y_p1229 - 0.002865001425 * minus_f13_x_p3;
  const Real minus_f13_x = minus_f13_x_p4 + 0.01626499875 * f13_y_p1117;

  // link 13 (left_hand), inward
  const Real minus_f12_z = 0.0006000000000000001 * minus_f12_z_p1 - 0.0025100003499999995 *
      minus_f12_z_p3 - c13 * f13_y + s13 * minus_f13_x;

  // link 11 (left_wrist1), outward
  const Real minus_f11_y_p1 = w11_z * w11_z;
  const Real minus_f11_y_p2 = w11_x * w11_y;
  const Real minus_f11_y_p3 = wd11_z + minus_f11_y_p2;

  // link 12 (left_wrist2), inward
  const Real minus_f11_y = minus_f12_z + (0.001 * (minus_a12_y_p1 + minus_f11_y_p1) - 6e-04 *
      minus_f11_y_p3);

  // link 10 (left_lowerarm), outward
  const Real minus_f10_z_p1 = minus_w10_y * w10_z;
  const Real minus_f10_z_p2 = minus_wd10_x + minus_f10_z_p1;
  const Real minus_f10_z_p3 = minus_w10_x * w10_z;
  const Real minus_f10_z_p4 = minus_wd10_y - minus_f10_z_p3;

  // link 12 (left_wrist2), outward
  const Real minus_f12_y_p1 = w12_z * w12_z;
  const Real minus_f12_y_p2 = minus_w12_x * minus_w12_y;

  // link 13 (left_hand), inward
  const Real minus_f12_y_p3 = 0.0006000000000000001 * (minus_f12_y_p1 + minus_w12_x * minus_w12_x) -
      0.0025100003499999995 * (wd12_z + minus_f12_y_p2) + s13 * f13_y;
  const Real minus_f12_y = minus_f12_y_p3 + c13 * minus_f13_x;

  // link 12 (left_wrist2), outward
  const Real minus_f12_x_p1 = wd12_z - minus_f12_y_p2;
  const Real minus_f12_x_p2 = minus_w12_y * minus_w12_y;

  // link 13 (left_hand), outward
  const Real minus_f12_x_p3 = w13_y * w13_z;
  const Real minus_f12_x_p4 = wd13_x + minus_f12_x_p3;

  // link 13 (left_hand), inward
  const Real minus_f12_x = f13_y_p1244 + (0.0006000000000000001 * minus_f12_x_p1 +
      0.0025100003499999995 * (minus_f12_x_p2 + minus_f12_y_p1)) + 0.002865001425 * minus_f12_x_p4 +
      0.01626499875 * f13_y_p1149;

  // link 12 (left_wrist2), inward
  const Real f11_x_p1 = s12 * minus_f12_y - c12 * minus_f12_x;

  // link 11 (left_wrist1), outward
  const Real f11_x_p2 = wd11_z - minus_f11_y_p2;

  // link 12 (left_wrist2), inward
  const Real f11_x = f11_x_p1 - (0.001 * f11_x_p2 + 6e-04 * (minus_a12_y_p2 + minus_f11_y_p1));

  // link 11 (left_wrist1), inward
  const Real minus_f10_z = 0.28049749700000004 * minus_f10_z_p2 - 0.0014999985000000002 *
      minus_f10_z_p4 + c11 * minus_f11_y - s11 * f11_x;

  // link 9 (left_upperarm), outward
  const Real minus_f9_y_p1 = w9_z * w9_z;
  const Real minus_f9_y_p2 = w9_x * minus_w9_y;
  const Real minus_f9_y_p3 = wd9_z - minus_f9_y_p2;

  // link 10 (left_lowerarm), inward
  const Real minus_f9_y = minus_f10_z + (0.004500002325 * (minus_a10_y_p1 + minus_f9_y_p1) +
      0.0022500062 * minus_f9_y_p3);

  // link 8 (left_shoulder2), outward
  const Real minus_f8_y_p1 = w8_x * w8_x;
  const Real minus_f8_y_p2 = w8_z * w8_z;
  const Real minus_f8_y_p3 = w8_x * w8_y;
  const Real minus_f8_y_p4 = wd8_z + minus_f8_y_p3;

  // link 10 (left_lowerarm), outward
  const Real minus_f10_x_p1 = minus_w10_x * minus_w10_y;
  const Real minus_f10_x_p2 = wd10_z - minus_f10_x_p1;
  const Real minus_f10_x_p3 = minus_w10_y * minus_w10_y;
  const Real minus_f10_x_p4 = w10_z * w10_z;

  // link 11 (left_wrist1), inward
  const Real minus_f10_x = 0.28049749700000004 * minus_f10_x_p2 + 0.0014999985000000002 *
      (minus_f10_x_p3 + minus_f10_x_p4) - s11 * minus_f11_y - c11 * f11_x;

  // link 10 (left_lowerarm), outward
  const Real minus_f10_y_p1 = minus_w10_x * minus_w10_x;
  const Real minus_f10_y_p2 = wd10_z + minus_f10_x_p1;

  // link 11 (left_wrist1), outward
  const Real minus_f10_y_p3 = wd11_x + minus_a12_z_p1;
  const Real minus_f10_y_p4 = wd11_y - minus_a12_y_p4;

  // link 11 (left_wrist1), inward
  const Real minus_f10_y_p5 = 0.28049749700000004 * (minus_f10_y_p1 + minus_f10_x_p4) -
      0.0014999985000000002 * minus_f10_y_p2 + 0.001 * minus_f10_y_p3 - 6e-04 * minus_f10_y_p4;
  const Real minus_f10_y = minus_f10_y_p5 + c12 * minus_f12_y + s12 * minus_f12_x;

  // link 10 (left_lowerarm), inward
  const Real f9_x_p1 = s10 * minus_f10_y - c10 * minus_f10_x;

  // link 9 (left_upperarm), outward
  const Real f9_x_p2 = wd9_z + minus_f9_y_p2;

  // link 10 (left_lowerarm), inward
  const Real f9_x = f9_x_p1 - (0.004500002325 * f9_x_p2 - 0.0022500062 *
      (minus_a10_y_p2 + minus_f9_y_p1));

  // link 9 (left_upperarm), inward
  const Real minus_f8_y = 0.0017499999999999998 * (minus_f8_y_p1 + minus_f8_y_p2) -
      0.7139200499999999 * minus_f8_y_p4 + c9 * minus_f9_y - s9 * f9_x;

  // link 8 (left_shoulder2), outward
  const Real minus_f8_x_p1 = wd8_z - minus_f8_y_p3;
  const Real minus_f8_x_p2 = w8_y * w8_y;

  // link 9 (left_upperarm), outward
  const Real minus_f8_x_p3 = wd9_x - minus_a10_z_p1;
  const Real minus_f8_x_p4 = minus_wd9_y + minus_a10_y_p4;

  // link 9 (left_upperarm), inward
  const Real minus_f8_x_p5 = 0.0017499999999999998 * minus_f8_x_p1 + 0.7139200499999999 *
      (minus_f8_x_p2 + minus_f8_y_p2) + 0.004500002325 * minus_f8_x_p3 - 0.0022500062 *
      minus_f8_x_p4;
  const Real minus_f8_x = minus_f8_x_p5 + c10 * minus_f10_y + s10 * minus_f10_x;

  // link 7 (left_shoulder1), outward
  const Real f7_y_p1 = w7_x * minus_w7_y;
  const Real f7_y_p2 = wd7_z - f7_y_p1;
  const Real f7_y_p3 = w7_x * w7_x;
  const Real f7_y_p4 = w7_z * w7_z;

  // link 8 (left_shoulder2), inward
  const Real f7_y = 0.0017499999999999998 * (f7_y_p2 + (f7_y_p3 + f7_y_p4)) +
      (s8 * minus_f8_y - c8 * minus_f8_x);

  // link 8 (left_shoulder2), outward
  const Real f7_x_p1 = w8_x * w8_z;
  const Real f7_x_p2 = wd8_y - f7_x_p1;
  const Real f7_x_p3 = w8_y * w8_z;
  const Real f7_x_p4 = wd8_x + f7_x_p3;

  // link 7 (left_shoulder1), outward
  const Real f7_x_p5 = wd7_z + f7_y_p1;
  const Real f7_x_p6 = minus_w7_y * minus_w7_y;

  // link 8 (left_shoulder2), inward
  const Real f7_x = 0.0017499999999999998 * (f7_x_p4 + (f7_x_p5 - (f7_x_p6 + f7_y_p4))) -
      (0.7139200499999999 * f7_x_p2 - s9 * minus_f9_y - c9 * f9_x);

  // link 7 (left_shoulder1), inward
  const Real minus_n6_y_p1 = s7 * f7_y - c7 * f7_x;

  // link 20 (right_hand), outward
  const Real minus_f20_y_p1 = w20_x * w20_x;

  // link 24 (right_eye), inertial wrench
  const Real minus_f20_y = f13_y_p1233 + 0.002865001425 * (minus_f20_y_p1 + f13_y_p1181) -
      0.01626499875 * f13_y_p1211;

  // link 19 (right_wrist2), outward
  const Real minus_f19_z_p1 = minus_wd19_x + minus_w19_y * w19_z;
  const Real minus_f19_z_p2 = minus_w19_x * w19_z;
  const Real minus_f19_z_p3 = minus_wd19_y - minus_f19_z_p2;

  // link 20 (right_hand), outward
  const Real f20_x_p1 = wd20_z - f13_y_p1210;

  // link 24 (right_eye), inertial wrench
  const Real f20_x = f13_y_p1235 - 0.002865001425 * f20_x_p1 - 0.01626499875 * f13_y_p1182;

  // link 20 (right_hand), inward
  const Real minus_f19_z = 0.0006000000000000001 * minus_f19_z_p1 - 0.0025100003499999995 *
      minus_f19_z_p3 + c20 * minus_f20_y - s20 * f20_x;

  // link 18 (right_wrist1), outward
  const Real minus_f18_y_p1 = w18_z * w18_z;
  const Real minus_f18_y_p2 = w18_x * w18_y;
  const Real minus_f18_y_p3 = wd18_z + minus_f18_y_p2;

  // link 19 (right_wrist2), inward
  const Real minus_f18_y = minus_f19_z - (0.001 * (minus_a19_y_p1 + minus_f18_y_p1) + 6e-04 *
      minus_f18_y_p3);

  // link 17 (right_lowerarm), outward
  const Real minus_f17_z_p1 = minus_w17_y * w17_z;
  const Real minus_f17_z_p2 = minus_wd17_x + minus_f17_z_p1;
  const Real minus_f17_z_p3 = minus_w17_x * w17_z;
  const Real minus_f17_z_p4 = minus_wd17_y - minus_f17_z_p3;

  // link 19 (right_wrist2), outward
  const Real minus_f19_y_p1 = w19_z * w19_z;
  const Real minus_f19_y_p2 = minus_w19_x * minus_w19_y;

  // link 20 (right_hand), inward
  const Real minus_f19_y_p3 = 0.0006000000000000001 * (minus_f19_y_p1 + minus_w19_x * minus_w19_x) -
      0.0025100003499999995 * (wd19_z + minus_f19_y_p2) - s20 * minus_f20_y;
  const Real minus_f19_y = minus_f19_y_p3 - c20 * f20_x;

  // link 19 (right_wrist2), outward
  const Real f19_x_p1 = wd19_z - minus_f19_y_p2;
  const Real f19_x_p2 = minus_w19_y * minus_w19_y;

  // link 20 (right_hand), outward
  const Real f19_x_p3 = w20_y * w20_z;
  const Real f19_x_p4 = wd20_x + f19_x_p3;

  // link 20 (right_hand), inward
  const Real f19_x = f13_y_p1232 - (0.0006000000000000001 * f19_x_p1 + 0.0025100003499999995 *
      (f19_x_p2 + minus_f19_y_p1)) + 0.002865001425 * f19_x_p4 - 0.01626499875 * f13_y_p1219;

  // link 19 (right_wrist2), inward
  const Real f18_x_p1 = s19 * minus_f19_y + c19 * f19_x;

  // link 18 (right_wrist1), outward
  const Real f18_x_p2 = wd18_z - minus_f18_y_p2;

  // link 19 (right_wrist2), inward
  const Real f18_x = f18_x_p1 + (0.001 * f18_x_p2 - 6e-04 * (minus_a19_y_p2 + minus_f18_y_p1));

  // link 18 (right_wrist1), inward
  const Real minus_f17_z = 0.28049749700000004 * minus_f17_z_p2 - 0.0014999985000000002 *
      minus_f17_z_p4 + c18 * minus_f18_y - s18 * f18_x;

  // link 16 (right_upperarm), outward
  const Real minus_f16_y_p1 = w16_z * w16_z;
  const Real minus_f16_y_p2 = w16_x * minus_w16_y;
  const Real minus_f16_y_p3 = wd16_z - minus_f16_y_p2;

  // link 17 (right_lowerarm), inward
  const Real minus_f16_y = minus_f17_z - (0.004500002325 * (minus_a17_y_p1 + minus_f16_y_p1) -
      0.0022500062 * minus_f16_y_p3);

  // link 15 (right_shoulder2), outward
  const Real f15_y_p1 = w15_x * w15_x;
  const Real f15_y_p2 = w15_z * w15_z;
  const Real f15_y_p3 = w15_x * w15_y;
  const Real f15_y_p4 = wd15_z + f15_y_p3;

  // link 17 (right_lowerarm), outward
  const Real minus_f17_x_p1 = minus_w17_x * minus_w17_y;
  const Real minus_f17_x_p2 = wd17_z - minus_f17_x_p1;
  const Real minus_f17_x_p3 = minus_w17_y * minus_w17_y;
  const Real minus_f17_x_p4 = w17_z * w17_z;

  // link 18 (right_wrist1), inward
  const Real minus_f17_x = 0.28049749700000004 * minus_f17_x_p2 + 0.0014999985000000002 *
      (minus_f17_x_p3 + minus_f17_x_p4) - s18 * minus_f18_y - c18 * f18_x;

  // link 17 (right_lowerarm), outward
  const Real minus_f17_y_p1 = minus_w17_x * minus_w17_x;
  const Real minus_f17_y_p2 = wd17_z + minus_f17_x_p1;

  // link 18 (right_wrist1), outward
  const Real minus_f17_y_p3 = wd18_x + minus_a19_z_p1;
  const Real minus_f17_y_p4 = wd18_y - minus_a19_y_p4;

  // link 18 (right_wrist1), inward
  const Real minus_f17_y_p5 = 0.28049749700000004 * (minus_f17_y_p1 + minus_f17_x_p4) -
      0.0014999985000000002 * minus_f17_y_p2 - 0.001 * minus_f17_y_p3 - 6e-04 * minus_f17_y_p4;
  const Real minus_f17_y = minus_f17_y_p5 + c19 * minus_f19_y - s19 * f19_x;

  // link 17 (right_lowerarm), inward
  const Real f16_x_p1 = s17 * minus_f17_y - c17 * minus_f17_x;

  // link 16 (right_upperarm), outward
  const Real f16_x_p2 = wd16_z + minus_f16_y_p2;

  // link 17 (right_lowerarm), inward
  const Real f16_x = f16_x_p1 + (0.004500002325 * f16_x_p2 + 0.0022500062 *
      (minus_a17_y_p2 + minus_f16_y_p1));

  // link 16 (right_upperarm), inward
  const Real f15_y = 0.0017499999999999998 * (f15_y_p1 + f15_y_p2) + 0.7139200499999999 * f15_y_p4 -
      c16 * minus_f16_y + s16 * f16_x;

  // link 15 (right_shoulder2), outward
  const Real f15_x_p1 = wd15_z - f15_y_p3;
  const Real f15_x_p2 = w15_y * w15_y;

  // link 16 (right_upperarm), outward
  const Real f15_x_p3 = wd16_x - minus_a17_z_p1;
  const Real f15_x_p4 = minus_wd16_y + minus_a17_y_p4;

  // link 16 (right_upperarm), inward
  const Real f15_x_p5 = 0.0017499999999999998 * f15_x_p1 - 0.7139200499999999 *
      (f15_x_p2 + f15_y_p2) + 0.004500002325 * f15_x_p3 + 0.0022500062 * f15_x_p4;
  const Real f15_x = f15_x_p5 - c17 * minus_f17_y - s17 * minus_f17_x;

  // link 14 (right_shoulder1), outward
  const Real f14_y_p1 = w14_x * minus_w14_y;
  const Real f14_y_p2 = wd14_z - f14_y_p1;
  const Real f14_y_p3 = w14_x * w14_x;
  const Real f14_y_p4 = w14_z * w14_z;

  // link 15 (right_shoulder2), inward
  const Real f14_y = 0.0017499999999999998 * (f14_y_p2 + (f14_y_p3 + f14_y_p4)) -
      (s15 * f15_y - c15 * f15_x);

  // link 15 (right_shoulder2), outward
  const Real minus_f14_x_p1 = w15_x * w15_z;
  const Real minus_f14_x_p2 = wd15_y - minus_f14_x_p1;
  const Real minus_f14_x_p3 = w15_y * w15_z;
  const Real minus_f14_x_p4 = wd15_x + minus_f14_x_p3;

  // link 14 (right_shoulder1), outward
  const Real minus_f14_x_p5 = wd14_z + f14_y_p1;
  const Real minus_f14_x_p6 = minus_w14_y * minus_w14_y;

  // link 15 (right_shoulder2), inward
  const Real minus_f14_x = 0.0017499999999999998 * (minus_f14_x_p4 -
      (minus_f14_x_p5 - (minus_f14_x_p6 + f14_y_p4))) +
      (0.7139200499999999 * minus_f14_x_p2 - s16 * minus_f16_y - c16 * f16_x);

  // link 14 (right_shoulder1), inward
  const Real minus_n6_y_p2 = s14 * f14_y + c14 * minus_f14_x;

  // link 24 (right_eye), inertial wrench
  const Real minus_n13_x_p1 = f13_y_p1241 - 4.38600177048965e-05 * (f13_y_p1115 - f13_y_p1116) +
      0.000108260010923775 * f13_y_p1142 - 0.0001263900573325125 * f13_y_p1149 -
      9.149209276993575e-05 * minus_f12_x_p4;
  const Real minus_n13_x = minus_n13_x_p1 - 0.002865001425 * minus_a12_x;
  const Real minus_n13_y_p1 = f13_y_p1239 - 0.000108260010923775 * (f13_y_p1248 - f13_y_p1116) -
      0.0001263900573325125 * minus_f12_x_p4 - 4.38600177048965e-05 * minus_f13_x_p3 -
      0.000847139515629375 * f13_y_p1149;
  const Real minus_n13_y = minus_n13_y_p1 - 0.01626499875 * minus_a12_x;

  // link 13 (left_hand), inward
  const Real n12_z_p1 = 2.4000000000000003e-06 * (minus_wd12_y + minus_f12_z_p2) +
      0.00020682766225734302 * wd12_z + 0.000183627662257343 * minus_f12_y_p2 +
      0.0006000000000000001 * minus_a12_x;
  const Real n12_z = n12_z_p1 - 0.0025100003499999995 * minus_a12_y - c13 * minus_n13_y - s13 *
      minus_n13_x;
  tau[11] = n12_z;

  // link 12 (left_wrist2), inward
  const Real n11_y_p1 = 0.000144 * (minus_a12_y_p1 - minus_f11_y_p1) + 6e-06 * minus_f10_y_p3 -
      0.0002516 * f11_x_p2 - 0.0001098 * minus_f10_y_p4;
  const Real n11_y = n12_z - (n11_y_p1 + 6e-04 * minus_a10_y) - 0.269 * f11_x_p1;

  // link 11 (left_wrist1), inward
  const Real n10_z_p1 = 2.249994685315e-05 * (minus_wd10_x - minus_f10_z_p1) +
      0.060888541114265754 * wd10_z - 0.06032654142055946 * minus_f10_x_p1 + 0.28049749700000004 *
      minus_a10_x;

  // link 12 (left_wrist2), inward
  const Real n11_x_p1 = 0.0002516 * (minus_a12_y_p2 - minus_f11_y_p1) + 0.000144 * minus_f11_y_p3 -
      6e-06 * minus_f10_y_p4 + 0.0001194 * minus_f10_y_p3;

  // link 13 (left_hand), inward
  const Real minus_n12_y = 2.4000000000000003e-06 * minus_f12_x_p1 + 0.000195227662257343 *
      minus_f12_z_p3 - 0.0025100003499999995 * minus_a12_z - s13 * minus_n13_y + c13 * minus_n13_x;

  // link 24 (right_eye), inertial wrench
  const Real minus_n13_z_p1 = f13_y_p1237 - 0.0001263900573325125 * (f13_y_p1248 - f13_y_p1115) -
      4.38600177048965e-05 * (wd13_y + f13_y_p1148) + 0.000108260010923775 *
      (wd13_x - minus_f12_x_p3);
  const Real minus_n13_z = minus_n13_z_p1 - 0.0009386316083993107 * wd13_z - 0.0007556474228594393 *
      f13_y_p1141 + 0.002865001425 * minus_a13_x + 0.01626499875 * minus_a13_y;
  tau[12] = -minus_n13_z;

  // link 13 (left_hand), inward
  const Real minus_n12_x = minus_n13_z + (2.4000000000000003e-06 *
      (minus_f12_x_p2 - minus_f12_y_p1) + 1.16e-05 * minus_f12_z_p1 + 0.0006000000000000001 *
      minus_a12_z);

  // link 12 (left_wrist2), inward
  const Real n11_x = n11_x_p1 + 0.001 * minus_a10_y - 0.269 * minus_f12_z + s12 * minus_n12_y -
      c12 * minus_n12_x;

  // link 11 (left_wrist1), inward
  const Real n10_z = 0.0001499998887063 * (minus_wd10_y + minus_f10_z_p3 -
      (minus_f10_y_p1 - minus_f10_x_p3)) + (n10_z_p1 - 0.0014999985000000002 * minus_a10_y + c11 *
      n11_y + s11 * n11_x);
  tau[9] = n10_z;

  // link 10 (left_lowerarm), inward
  const Real n9_y_p1 = 0.0005895000784280001 * (minus_a10_y_p1 - minus_f9_y_p1) +
      4.4999986458742003e-05 * minus_f8_x_p3 + 0.0012089992423205001 * f9_x_p2 -
      0.0008177492704690715 * minus_f8_x_p4;
  const Real n9_y = n10_z + (n9_y_p1 + 0.0022500062 * minus_a8_x) - 0.282 * f9_x_p1;

  // link 9 (left_upperarm), inward
  const Real n8_y_p1 = 0.00010499999999999999 * (minus_f8_y_p1 - minus_f8_y_p2) -
      5.2499999999999995e-05 * f7_x_p4 - 1.75e-05 * minus_f8_x_p1 + 0.18113119219699997 * f7_x_p2;

  // link 10 (left_lowerarm), inward
  const Real n9_x_p1 = 0.0012089992423205001 * (minus_a10_y_p2 - minus_f9_y_p1) -
      0.0005895000784280001 * minus_f9_y_p3 - 4.4999986458742003e-05 * minus_f8_x_p4 +
      0.0019585440854647937 * minus_f8_x_p3;

  // link 12 (left_wrist2), inward
  const Real minus_n11_z_p1 = 6e-06 * (minus_a12_y_p1 - minus_a12_y_p2) - 0.0002516 *
      minus_a12_y_p5 - 0.000144 * minus_a12_z_p2 - 0.0002292 * wd11_z;
  const Real minus_n11_z_p2 = minus_n11_z_p1 + 9.600000000000003e-06 * minus_f11_y_p2 - 0.001 *
      minus_a11_x + 6e-04 * minus_a11_y - c12 * minus_n12_y;
  const Real minus_n11_z = minus_n11_z_p2 - s12 * minus_n12_x;
  tau[10] = -minus_n11_z;

  // link 11 (left_wrist1), inward
  const Real minus_n10_y = 0.0001499998887063 * (minus_f10_x_p2 - minus_f10_z_p2) -
      (minus_n11_z + (2.249994685315e-05 * (minus_f10_y_p1 - minus_f10_x_p4) - 0.00028099984685315 *
      minus_f10_z_p4 + 0.0014999985000000002 * minus_a10_z));
  const Real n10_x_p1 = 2.249994685315e-05 * minus_f10_y_p2 + 0.06060754126741261 * minus_f10_z_p2 +
      0.28049749700000004 * minus_a10_z + s11 * n11_y - c11 * n11_x;
  const Real n10_x = 0.0001499998887063 * (minus_f10_z_p4 - (minus_f10_x_p3 - minus_f10_x_p4)) -
      n10_x_p1;

  // link 10 (left_lowerarm), inward
  const Real n9_x = n9_x_p1 + 0.004500002325 * minus_a8_x - 0.282 * minus_f10_z + s10 *
      minus_n10_y + c10 * n10_x;

  // link 9 (left_upperarm), inward
  const Real n8_y = n8_y_p1 - 0.7139200499999999 * a7_x + c9 * n9_y + s9 * n9_x;

  // link 7 (left_shoulder1), inertial wrench
  const Real n7_z_p1 = 0.0017499999999999998 * a7_x;

  // link 8 (left_shoulder2), inward
  const Real n7_z_p2 = n7_z_p1 - (8.75e-06 * (f7_y_p3 - f7_x_p6) - 0.00044800000000000005 * wd7_z +
      0.00014700000000000002 * f7_y_p1) - 0.0017499999999999998 * minus_a7_y;

  // link 10 (left_lowerarm), inward
  const Real n9_z_p1 = 4.4999986458742003e-05 * (minus_a10_y_p1 - minus_a10_y_p2) -
      0.0012089992423205001 * minus_a10_y_p5 - 0.0005895000784280001 * minus_a10_z_p2 +
      0.0027762933559338653 * wd9_z;
  const Real n9_z_p2 = n9_z_p1 + 0.001140794814995722 * minus_f9_y_p2 - 0.004500002325 * a9_x +
      0.0022500062 * minus_a9_y + c10 * minus_n10_y;
  const Real n9_z = n9_z_p2 - s10 * n10_x;
  tau[8] = n9_z;

  // link 9 (left_upperarm), inward
  const Real minus_n8_x_p1 = n7_z_p1 - 1.75e-05 * (minus_f8_x_p2 - minus_f8_y_p2) -
      0.00010499999999999999 * minus_f8_y_p4 - 5.2499999999999995e-05 * f7_x_p2 + 0.00012075 *
      f7_x_p4;
  const Real minus_n8_x = n9_z - minus_n8_x_p1;

  // link 7 (left_shoulder1), outward
  const Real n7_z_p3 = w7_x * w7_z;
  const Real n7_z_p4 = minus_w7_y * w7_z;

  // link 8 (left_shoulder2), inward
  const Real n7_z = 2.6249999999999998e-05 * (minus_wd7_y - n7_z_p3 - (wd7_x + n7_z_p4)) +
      (n7_z_p2 + c8 * n8_y - s8 * minus_n8_x);
  tau[6] = n7_z;

  // link 24 (right_eye), inertial wrench
  const Real n20_x_p1 = f13_y_p1231 - 4.38600177048965e-05 * (f13_y_p1180 - f13_y_p1181) -
      0.000108260010923775 * f13_y_p1211 - 0.0001263900573325125 * f13_y_p1219 +
      9.149209276993575e-05 * f19_x_p4;
  const Real n20_x = n20_x_p1 - 0.002865001425 * minus_a19_x;
  const Real n20_y_p1 = f13_y_p1230 + 0.000108260010923775 * (minus_f20_y_p1 - f13_y_p1181) -
      0.0001263900573325125 * f19_x_p4 - 4.38600177048965e-05 * f20_x_p1 + 0.000847139515629375 *
      f13_y_p1219;
  const Real n20_y = n20_y_p1 + 0.01626499875 * minus_a19_x;

  // link 20 (right_hand), inward
  const Real minus_n19_z_p1 = 2.4000000000000003e-06 * (minus_wd19_y + minus_f19_z_p2) -
      0.00020682766225734302 * wd19_z - 0.000183627662257343 * minus_f19_y_p2 -
      0.0006000000000000001 * minus_a19_x;
  const Real minus_n19_z = minus_n19_z_p1 + 0.0025100003499999995 * minus_a19_y - c20 * n20_y -
      s20 * n20_x;
  tau[18] = -minus_n19_z;

  // link 19 (right_wrist2), inward
  const Real minus_n18_y_p1 = 0.000144 * (minus_a19_y_p1 - minus_f18_y_p1) - 6e-06 *
      minus_f17_y_p3 + 0.0002516 * f18_x_p2 - 0.0001098 * minus_f17_y_p4;
  const Real minus_n18_y = minus_n19_z + (minus_n18_y_p1 + 6e-04 * minus_a17_y) + 0.269 * f18_x_p1;

  // link 18 (right_wrist1), inward
  const Real minus_n17_z_p1 = 2.249994685315e-05 * (minus_wd17_x - minus_f17_z_p1) -
      0.060888541114265754 * wd17_z + 0.06032654142055946 * minus_f17_x_p1 - 0.28049749700000004 *
      minus_a17_x;

  // link 19 (right_wrist2), inward
  const Real minus_n18_x_p1 = 0.0002516 * (minus_a19_y_p2 - minus_f18_y_p1) - 0.000144 *
      minus_f18_y_p3 - 6e-06 * minus_f17_y_p4 - 0.0001194 * minus_f17_y_p3;

  // link 20 (right_hand), inward
  const Real n19_y = 2.4000000000000003e-06 * f19_x_p1 - 0.000195227662257343 * minus_f19_z_p3 +
      0.0025100003499999995 * minus_a19_z - s20 * n20_y + c20 * n20_x;

  // link 24 (right_eye), inertial wrench
  const Real minus_n20_z_p1 = f13_y_p1229 + 0.0001263900573325125 * (minus_f20_y_p1 - f13_y_p1180) +
      4.38600177048965e-05 * (wd20_y + f13_y_p1218) + 0.000108260010923775 * (wd20_x - f19_x_p3);
  const Real minus_n20_z = minus_n20_z_p1 - 0.0009386316083993107 * wd20_z - 0.0007556474228594393 *
      f13_y_p1210 - 0.002865001425 * minus_a20_x + 0.01626499875 * minus_a20_y;
  tau[19] = -minus_n20_z;

  // link 20 (right_hand), inward
  const Real minus_n19_x = minus_n20_z - (2.4000000000000003e-06 * (f19_x_p2 - minus_f19_y_p1) -
      1.16e-05 * minus_f19_z_p1 - 0.0006000000000000001 * minus_a19_z);

  // link 19 (right_wrist2), inward
  const Real minus_n18_x = minus_n18_x_p1 + 0.001 * minus_a17_y + 0.269 * minus_f19_z + s19 *
      n19_y + c19 * minus_n19_x;

  // link 18 (right_wrist1), inward
  const Real minus_n17_z = 0.0001499998887063 * (minus_wd17_y + minus_f17_z_p3 +
      (minus_f17_y_p1 - minus_f17_x_p3)) + (minus_n17_z_p1 + 0.0014999985000000002 * minus_a17_y +
      c18 * minus_n18_y + s18 * minus_n18_x);
  tau[16] = -minus_n17_z;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_y_p1 = 0.0005895000784280001 * (minus_a17_y_p1 - minus_f16_y_p1) -
      4.4999986458742003e-05 * f15_x_p3 - 0.0012089992423205001 * f16_x_p2 - 0.0008177492704690715 *
      f15_x_p4;
  const Real minus_n16_y = minus_n17_z - (minus_n16_y_p1 + 0.0022500062 * minus_a15_x) + 0.282 *
      f16_x_p1;

  // link 16 (right_upperarm), inward
  const Real n15_y_p1 = 0.00010499999999999999 * (f15_y_p1 - f15_y_p2) + 5.2499999999999995e-05 *
      minus_f14_x_p4 + 1.75e-05 * f15_x_p1 + 0.18113119219699997 * minus_f14_x_p2;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_x_p1 = 0.0012089992423205001 * (minus_a17_y_p2 - minus_f16_y_p1) +
      0.0005895000784280001 * minus_f16_y_p3 - 4.4999986458742003e-05 * f15_x_p4 -
      0.0019585440854647937 * f15_x_p3;

  // link 19 (right_wrist2), inward
  const Real n18_z_p1 = 6e-06 * (minus_a19_y_p1 - minus_a19_y_p2) - 0.0002516 * minus_a19_y_p5 +
      0.000144 * minus_a19_z_p2 + 0.0002292 * wd18_z;
  const Real n18_z_p2 = n18_z_p1 - 9.600000000000003e-06 * minus_f18_y_p2 - 0.001 * minus_a18_x -
      6e-04 * minus_a18_y - c19 * n19_y;
  const Real n18_z = n18_z_p2 + s19 * minus_n19_x;
  tau[17] = n18_z;

  // link 18 (right_wrist1), inward
  const Real n17_y = 0.0001499998887063 * (minus_f17_x_p2 + minus_f17_z_p2) -
      (n18_z + (2.249994685315e-05 * (minus_f17_y_p1 - minus_f17_x_p4) + 0.00028099984685315 *
      minus_f17_z_p4 - 0.0014999985000000002 * minus_a17_z));
  const Real n17_x_p1 = 2.249994685315e-05 * minus_f17_y_p2 - 0.06060754126741261 * minus_f17_z_p2 -
      0.28049749700000004 * minus_a17_z + s18 * minus_n18_y - c18 * minus_n18_x;
  const Real n17_x = 0.0001499998887063 * (minus_f17_z_p4 + (minus_f17_x_p3 - minus_f17_x_p4)) +
      n17_x_p1;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_x = minus_n16_x_p1 + 0.004500002325 * minus_a15_x + 0.282 * minus_f17_z +
      s17 * n17_y - c17 * n17_x;

  // link 16 (right_upperarm), inward
  const Real n15_y = n15_y_p1 - 0.7139200499999999 * a14_x - c16 * minus_n16_y - s16 * minus_n16_x;

  // link 14 (right_shoulder1), inertial wrench
  const Real minus_n14_z_p1 = 0.0017499999999999998 * a14_x;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_z_p2 = minus_n14_z_p1 - (8.75e-06 * (f14_y_p3 - minus_f14_x_p6) -
      0.00044800000000000005 * wd14_z + 0.00014700000000000002 * f14_y_p1) - 0.0017499999999999998 *
      minus_a14_y;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_z_p1 = 4.4999986458742003e-05 * (minus_a17_y_p1 - minus_a17_y_p2) -
      0.0012089992423205001 * minus_a17_y_p5 + 0.0005895000784280001 * minus_a17_z_p2 -
      0.0027762933559338653 * wd16_z;
  const Real minus_n16_z_p2 = minus_n16_z_p1 - 0.001140794814995722 * minus_f16_y_p2 -
      0.004500002325 * a16_x - 0.0022500062 * minus_a16_y + c17 * n17_y;
  const Real minus_n16_z = minus_n16_z_p2 + s17 * n17_x;
  tau[15] = -minus_n16_z;

  // link 16 (right_upperarm), inward
  const Real n15_x_p1 = minus_n14_z_p1 - 1.75e-05 * (f15_x_p2 - f15_y_p2) + 0.00010499999999999999 *
      f15_y_p4 - 5.2499999999999995e-05 * minus_f14_x_p2 - 0.00012075 * minus_f14_x_p4;
  const Real n15_x = minus_n16_z - n15_x_p1;

  // link 14 (right_shoulder1), outward
  const Real minus_n14_z_p3 = w14_x * w14_z;
  const Real minus_n14_z_p4 = minus_w14_y * w14_z;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_z = 2.6249999999999998e-05 *
      (minus_wd14_y - minus_n14_z_p3 - (wd14_x + minus_n14_z_p4)) -
      (minus_n14_z_p2 + c15 * n15_y + s15 * n15_x);
  tau[13] = -minus_n14_z;

  // link 21 (neck), outward
  const Real w21_x = c21 * w6_z + s21 * w6_y;
  const Real a22_x_p1 = w21_x * w21_x;
  const Real minus_w21_y = s21 * w6_z - c21 * w6_y;
  const Real a22_x_p2 = minus_w21_y * minus_w21_y;

  // link 22 (head), outward
  const Real a22_x_p3 = a6_x + 0.394 * (a22_x_p1 + a22_x_p2);

  // link 21 (neck), outward
  const Real minus_wd21_y = s21 * wd6_z - c21 * wd6_y + qd[20] * w21_x;
  const Real w21_z = qd[20] - w6_x;
  const Real a22_x_p4 = w21_x * w21_z;

  // link 22 (head), outward
  const Real a22_x_p5 = c21 * minus_a6_z - s21 * a6_y + 0.394 * (minus_wd21_y - a22_x_p4);
  const Real a22_x = s22 * a22_x_p3 - c22 * a22_x_p5;
  const Real minus_w22_x = s22 * w21_z - c22 * w21_x;
  const Real minus_n22_z_p1 = minus_w22_x * minus_w22_x;
  const Real minus_w22_y = c22 * w21_z + s22 * w21_x;
  const Real minus_n22_z_p2 = minus_w22_y * minus_w22_y;
  const Real wd22_z = qdd_0[21] - minus_wd21_y;
  const Real minus_n22_z_p3 = minus_w22_x * minus_w22_y;

  // link 23 (left_eye), inward
  const Real minus_n22_z_p4 = 0.0074 * (minus_n22_z_p1 - minus_n22_z_p2) + 0.06394132500000001 *
      wd22_z - 0.04506407500000001 * minus_n22_z_p3 + 0.43200000000000005 * a22_x;

  // link 22 (head), outward
  const Real a22_y = c22 * a22_x_p3 + s22 * a22_x_p5;

  // link 21 (neck), outward
  const Real wd21_x = c21 * wd6_z + s21 * wd6_y - qd[20] * minus_w21_y;
  const Real wd21_z = qdd_0[20] - wd6_x;

  // link 22 (head), outward
  const Real minus_wd22_x = s22 * wd21_z - c22 * wd21_x + qd[21] * minus_w22_y;
  const Real w22_z = qd[21] - minus_w21_y;
  const Real minus_a24_z_p1 = minus_w22_y * w22_z;

  // link 23 (left_eye), outward
  const Real minus_a24_z_p2 = 0.032 * (minus_wd22_x - minus_a24_z_p1);

  // link 22 (head), outward
  const Real minus_a24_z_p3 = wd22_z + minus_n22_z_p3;

  // link 23 (left_eye), outward
  const Real minus_a24_z_p4 = 0.095 * minus_a24_z_p3;

  // link 24 (right_eye), outward
  const Real minus_a24_z = minus_a24_z_p4 + (a22_y - minus_a24_z_p2);
  const Real w24_x = s24 * w22_z - c24 * minus_w22_x;
  const Real w24_z = qd[23] + minus_w22_y;
  const Real minus_n24_y_p1 = w24_z * w24_z;
  const Real minus_n24_y_p2 = w24_x * (qd[23] + w24_z) - (c24 * wd22_z + s24 * minus_wd22_x);

  // link 24 (right_eye), inertial wrench
  const Real minus_n24_y = 2.8750000000000004e-05 * (minus_n24_y_p1 - w24_x * w24_x) + 5.25e-06 *
      minus_n24_y_p2 - 0.00025 * minus_a24_z;

  // link 24 (right_eye), outward
  const Real w24_y = c24 * w22_z + s24 * minus_w22_x;
  const Real minus_n24_x_p1 = w24_x * w24_y;

  // link 22 (head), outward
  const Real minus_wd22_y = c22 * wd21_z + s22 * wd21_x - qd[21] * minus_w22_x;

  // link 24 (right_eye), outward
  const Real wd24_z = qdd_0[23] + minus_wd22_y;
  const Real minus_n24_x_p2 = wd24_z + minus_n24_x_p1;
  const Real wd24_x = s24 * wd22_z - c24 * minus_wd22_x + qd[23] * w24_y;
  const Real minus_n24_x_p3 = w24_y * w24_z;

  // link 24 (right_eye), inertial wrench
  const Real minus_n24_x = 2.8750000000000004e-05 * minus_n24_x_p2 - 4e-06 *
      (wd24_x + minus_n24_x_p3);

  // link 23 (left_eye), outward
  const Real minus_a23_z = minus_a24_z_p4 + (a22_y + minus_a24_z_p2);
  const Real w23_x = s23 * w22_z - c23 * minus_w22_x;
  const Real w23_z = qd[22] + minus_w22_y;
  const Real minus_n23_y_p1 = w23_z * w23_z;
  const Real minus_n23_y_p2 = w23_x * (qd[22] + w23_z) - (c23 * wd22_z + s23 * minus_wd22_x);

  // link 23 (left_eye), inertial wrench
  const Real minus_n23_y = 2.8750000000000004e-05 * (minus_n23_y_p1 - w23_x * w23_x) + 5.25e-06 *
      minus_n23_y_p2 - 0.00025 * minus_a23_z;

  // link 23 (left_eye), inward
  const Real minus_n22_z_p5 = minus_n22_z_p4 + 0.072575 * a22_y - c24 * minus_n24_y - s24 *
      minus_n24_x - c23 * minus_n23_y;

  // link 23 (left_eye), outward
  const Real w23_y = c23 * w22_z + s23 * minus_w22_x;
  const Real minus_n23_x_p1 = w23_x * w23_y;
  const Real wd23_z = qdd_0[22] + minus_wd22_y;
  const Real minus_n23_x_p2 = wd23_z + minus_n23_x_p1;
  const Real wd23_x = s23 * wd22_z - c23 * minus_wd22_x + qd[22] * w23_y;
  const Real minus_n23_x_p3 = w23_y * w23_z;

  // link 23 (left_eye), inertial wrench
  const Real minus_n23_x = 2.8750000000000004e-05 * minus_n23_x_p2 - 4e-06 *
      (wd23_x + minus_n23_x_p3);

  // link 23 (left_eye), inward
  const Real minus_n22_z_p6 = minus_n23_y_p2 + minus_n24_y_p2;
  const Real minus_n22_z = 2.375e-05 * minus_n22_z_p6 - (minus_n22_z_p5 - s23 * minus_n23_x);
  tau[21] = -minus_n22_z;

  // link 21 (neck), outward
  const Real minus_n21_y_p1 = w21_z * w21_z;
  const Real minus_n21_y_p2 = minus_wd21_y + a22_x_p4;

  // link 22 (head), outward
  const Real minus_f22_y_p1 = w22_z * w22_z;

  // link 23 (left_eye), inward
  const Real minus_f22_y = 0.00025 * minus_n22_z_p6 -
      (0.43200000000000005 * (minus_n22_z_p1 + minus_f22_y_p1) + 0.072575 * minus_a24_z_p3);

  // link 24 (right_eye), inertial wrench
  const Real f24_y = 0.00025 * minus_n24_x_p2;
  const Real minus_f24_x = 0.00025 * (minus_n24_y_p1 + w24_y * w24_y);

  // link 24 (right_eye), inward
  const Real minus_f22_x_p1 = s24 * f24_y + c24 * minus_f24_x;

  // link 23 (left_eye), outward
  const Real minus_f22_x_p2 = minus_n22_z_p2 + minus_f22_y_p1;

  // link 23 (left_eye), inertial wrench
  const Real f23_y = 0.00025 * minus_n23_x_p2;
  const Real minus_f23_x = 0.00025 * (minus_n23_y_p1 + w23_y * w23_y);

  // link 23 (left_eye), inward
  const Real minus_f22_x_p3 = s23 * f23_y + c23 * minus_f23_x;
  const Real minus_f22_x = minus_f22_x_p3 + (minus_f22_x_p1 -
      (0.43200000000000005 * (wd22_z - minus_n22_z_p3) - 0.072575 * minus_f22_x_p2));

  // link 22 (head), inward
  const Real minus_n21_y_p3 = s22 * minus_f22_y - c22 * minus_f22_x;
  const Real minus_n21_y = minus_n22_z - (0.0016155 * (a22_x_p1 - minus_n21_y_p1) - 0.000703125 *
      minus_n21_y_p2 + 0.0045000000000000005 * a6_x) - 0.394 * minus_n21_y_p3;

  // link 7 (left_shoulder1), inward
  const Real minus_n6_y_p3 = 0.0187369177636143 * (minus_a7_z_p1 - minus_a7_y_p9) -
      1.66923963592404 * minus_a7_y_p4 + 6.1665928899999995 * minus_a6_z + c21 * minus_n21_y;

  // link 22 (head), outward
  const Real a24_y_p1 = minus_w22_x * w22_z;

  // link 23 (left_eye), outward
  const Real a24_y_p2 = 0.032 * (minus_wd22_y + a24_y_p1);
  const Real a24_y_p3 = 0.095 * minus_f22_x_p2;

  // link 21 (neck), outward
  const Real a21_y = s21 * minus_a6_z + c21 * a6_y;
  const Real a22_z_p1 = minus_w21_y * w21_z;
  const Real a22_z_p2 = wd21_x + a22_z_p1;

  // link 22 (head), outward
  const Real a22_z = a21_y - 0.394 * a22_z_p2;

  // link 23 (left_eye), outward
  const Real a24_y_p4 = 0.032 * (minus_n22_z_p1 + minus_n22_z_p2);

  // link 22 (head), outward
  const Real a24_y_p5 = minus_wd22_y - a24_y_p1;

  // link 23 (left_eye), outward
  const Real a24_y_p6 = 0.095 * a24_y_p5;

  // link 24 (right_eye), outward
  const Real a24_y = c24 * (a24_y_p6 + (a22_z + a24_y_p4)) + s24 * (a24_y_p3 - (a22_x + a24_y_p2));

  // link 24 (right_eye), inertial wrench
  const Real minus_n24_z = 2.8750000000000004e-05 * (wd24_x - minus_n24_x_p3) - 9.25e-06 * wd24_z -
      1.2499999999999999e-06 * minus_n24_x_p1 - 0.00025 * a24_y;
  tau[23] = -minus_n24_z;

  // link 22 (head), outward
  const Real minus_n22_y_p1 = minus_wd22_x + minus_a24_z_p1;

  // link 23 (left_eye), outward
  const Real a23_y = c23 * (a24_y_p6 + (a22_z - a24_y_p4)) + s23 * (a24_y_p3 - (a22_x - a24_y_p2));

  // link 23 (left_eye), inertial wrench
  const Real minus_n23_z = 2.8750000000000004e-05 * (wd23_x - minus_n23_x_p3) - 9.25e-06 * wd23_z -
      1.2499999999999999e-06 * minus_n23_x_p1 - 0.00025 * a23_y;
  tau[22] = -minus_n23_z;

  // link 23 (left_eye), inward
  const Real minus_n22_y_p2 = 0.032 * (minus_f22_x_p1 - minus_f22_x_p3) +
      (minus_n23_z + (minus_n24_z - (0.0074 * minus_n22_y_p1 + 0.009438624999999999 * a24_y_p5 +
      0.072575 * a22_z)));

  // link 24 (right_eye), inward
  const Real minus_n22_y_p3 = c24 * f24_y - s24 * minus_f24_x;

  // link 23 (left_eye), inward
  const Real minus_n22_y_p4 = c23 * f23_y - s23 * minus_f23_x;
  const Real minus_n22_y = 0.095 * (minus_n22_y_p3 + minus_n22_y_p4) - minus_n22_y_p2;
  const Real f22_z = minus_n22_y_p4 + (minus_n22_y_p3 +
      (0.43200000000000005 * minus_n22_y_p1 + 0.072575 * a24_y_p5));

  // link 21 (neck), outward
  const Real minus_n21_x_p1 = w21_x * minus_w21_y;
  const Real minus_n21_x_p2 = wd21_z - minus_n21_x_p1;

  // link 22 (head), inward
  const Real minus_n21_x_p3 = 0.0016155 * minus_n21_x_p2 - 0.005513625 * (wd21_x - a22_z_p1) +
      0.394 * f22_z - s22 * minus_n22_y;

  // link 23 (left_eye), inward
  const Real n22_x_p1 = 0.0074 * a24_y_p5 + 0.05450270000000001 * minus_n22_y_p1 +
      0.43200000000000005 * a22_z - s24 * minus_n24_y + c24 * minus_n24_x;
  const Real n22_x = 8e-06 * (minus_n23_y_p2 - minus_n24_y_p2) -
      (n22_x_p1 - s23 * minus_n23_y + c23 * minus_n23_x);

  // link 22 (head), inward
  const Real minus_n21_x = minus_n21_x_p3 - c22 * n22_x;

  // link 7 (left_shoulder1), inward
  const Real minus_n6_y = 0.226 * (minus_n6_y_p2 + minus_n6_y_p1) -
      (n7_z - (minus_n14_z + (minus_n6_y_p3 + s21 * minus_n21_x)));

  // link 22 (head), inward
  const Real f21_x = minus_n21_y_p3 - 0.0045000000000000005 * (a22_x_p2 + minus_n21_y_p1);
  const Real f21_y = f22_z + 0.0045000000000000005 * minus_n21_x_p2;

  // link 7 (left_shoulder1), inward
  const Real minus_f6_z = minus_n6_y_p1 + (minus_n6_y_p2 -
      (6.1665928899999995 * minus_a7_y_p4 - s21 * f21_y + c21 * f21_x));

  // link 5 (chest2), outward
  const Real n5_z_p1 = minus_w5_y * minus_w5_y;

  // link 6 (chest3), inward
  const Real n5_z_p2 = 0.005678398088837119 * (a6_x_p1 - n5_z_p1) + 0.203126912024134 * wd5_z -
      0.10961925816937637 * minus_a6_z_p1 - 2.2194301519999997 * minus_a5_x;

  // link 7 (left_shoulder1), inertial wrench
  const Real minus_n7_y_p1 = 0.0017499999999999998 * minus_a7_z;

  // link 7 (left_shoulder1), outward
  const Real minus_n7_y_p2 = wd7_x - n7_z_p4;
  const Real minus_n7_y_p3 = minus_wd7_y + n7_z_p3;

  // link 8 (left_shoulder2), inward
  const Real minus_n7_y_p4 = minus_n7_y_p1 - (8.75e-06 * minus_n7_y_p2 + 0.0002975 *
      minus_n7_y_p3) - s8 * n8_y - c8 * minus_n8_x;
  const Real minus_n7_y = 2.6249999999999998e-05 * (f7_x_p5 - (f7_y_p3 - f7_y_p4)) - minus_n7_y_p4;

  // link 14 (right_shoulder1), inertial wrench
  const Real n14_y_p1 = 0.0017499999999999998 * minus_a14_z;

  // link 14 (right_shoulder1), outward
  const Real n14_y_p2 = wd14_x - minus_n14_z_p4;
  const Real n14_y_p3 = minus_wd14_y + minus_n14_z_p3;

  // link 15 (right_shoulder2), inward
  const Real n14_y_p4 = n14_y_p1 - (8.75e-06 * n14_y_p2 + 0.0002975 * n14_y_p3) - s15 * n15_y +
      c15 * n15_x;
  const Real n14_y = 2.6249999999999998e-05 * (minus_f14_x_p5 - (f14_y_p3 - f14_y_p4)) + n14_y_p4;

  // link 22 (head), inward
  const Real minus_n21_z_p1 = 0.0016155 * a22_z_p2 - 0.00621675 * wd21_z - 0.0048105000000000005 *
      minus_n21_x_p1 - 0.0045000000000000005 * a21_y - c22 * minus_n22_y;
  const Real minus_n21_z = minus_n21_z_p1 + s22 * n22_x;
  tau[20] = -minus_n21_z;

  // link 16 (right_upperarm), inward
  const Real n15_z_p1 = 5.2499999999999995e-05 * (f15_y_p1 - f15_x_p2) + 1.75e-05 *
      (wd15_y + minus_f14_x_p1) - 0.00010499999999999999 * (wd15_x - minus_f14_x_p3);
  const Real n15_z_p2 = n15_z_p1 + 0.18125194219699997 * wd15_z + 0.18101044219699997 * f15_y_p3 -
      0.0017499999999999998 * minus_a15_x - 0.7139200499999999 * minus_a15_y;
  const Real n15_z = n15_z_p2 + s16 * minus_n16_y - c16 * minus_n16_x;
  tau[14] = n15_z;

  // link 15 (right_shoulder2), inward
  const Real n14_x = 2.6249999999999998e-05 * (f14_y_p2 + (minus_f14_x_p6 - f14_y_p4)) +
      (n15_z + (n14_y_p1 + (8.75e-06 * n14_y_p3 + 0.0001505 * n14_y_p2)));

  // link 7 (left_shoulder1), inward
  const Real n6_x_p1 = minus_n21_z + (0.0187369177636143 * minus_a7_z_p3 + 0.40041499999999997 *
      minus_a7_y_p2) + c14 * n14_y + s14 * n14_x;

  // link 9 (left_upperarm), inward
  const Real minus_n8_z_p1 = 5.2499999999999995e-05 * (minus_f8_y_p1 - minus_f8_x_p2) + 1.75e-05 *
      (wd8_y + f7_x_p1) + 0.00010499999999999999 * (wd8_x - f7_x_p3);
  const Real minus_n8_z_p2 = minus_n8_z_p1 - 0.18125194219699997 * wd8_z - 0.18101044219699997 *
      minus_f8_y_p3 - 0.0017499999999999998 * minus_a8_x + 0.7139200499999999 * minus_a8_y;
  const Real minus_n8_z = minus_n8_z_p2 + s9 * n9_y - c9 * n9_x;
  tau[7] = -minus_n8_z;

  // link 8 (left_shoulder2), inward
  const Real minus_n7_x = 2.6249999999999998e-05 * (f7_y_p2 + (f7_x_p6 - f7_y_p4)) +
      (minus_n8_z - (minus_n7_y_p1 + (8.75e-06 * minus_n7_y_p3 + 0.0001505 * minus_n7_y_p2)));

  // link 7 (left_shoulder1), inward
  const Real n6_x = 0.18 * (minus_n6_y_p2 - minus_n6_y_p1) +
      (n6_x_p1 - c7 * minus_n7_y - s7 * minus_n7_x);

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p2 - 0.069699984375 * minus_a5_y - 0.072 * minus_f6_z - c6 * minus_n6_y +
      s6 * n6_x;
  tau[4] = n5_z;

  // link 4 (chest1), outward
  const Real n4_y_p1 = qd[3] * qd[3];
  const Real n4_y_p2 = wd4_y_p1 - wd4_y;

  // link 7 (left_shoulder1), inward
  const Real f6_x_p1 = c7 * f7_y + s7 * f7_x;

  // link 14 (right_shoulder1), inward
  const Real f6_x_p2 = c14 * f14_y - s14 * minus_f14_x;

  // link 7 (left_shoulder1), inward
  const Real f6_x_p3 = f6_x_p2 + (6.1665928899999995 * minus_a7_y_p10 - 0.0045000000000000005 *
      minus_n21_y_p2 - c22 * minus_f22_y - s22 * minus_f22_x);
  const Real f6_x = f6_x_p1 + f6_x_p3;

  // link 8 (left_shoulder2), inward
  const Real f7_z = 0.0017499999999999998 * (minus_n7_y_p3 - minus_n7_y_p2) -
      (c8 * minus_f8_y + s8 * minus_f8_x);

  // link 15 (right_shoulder2), inward
  const Real f14_z = 0.0017499999999999998 * (n14_y_p3 - n14_y_p2) + (c15 * f15_y + s15 * f15_x);

  // link 7 (left_shoulder1), inward
  const Real f6_y = f7_z + (f14_z - (6.1665928899999995 * minus_a7_z_p3 - c21 * f21_y - s21 *
      f21_x));

  // link 6 (chest3), inward
  const Real f5_y = 2.2194301519999997 * a6_x_p3 + 0.069699984375 * (wd5_z + minus_a6_z_p1) - s6 *
      f6_y + c6 * f6_x;
  const Real minus_f5_x = minus_f6_z - (2.2194301519999997 * minus_a6_z_p2 - 0.069699984375 *
      (n5_z_p1 + a6_x_p2));

  // link 5 (chest2), inward
  const Real n4_y_p3 = s5 * f5_y + c5 * minus_f5_x;
  const Real n4_y = n5_z - (0.005880002159562879 * (minus_a5_x_p1 - n4_y_p1) + 0.01227760324629517 *
      n4_y_p2 - 0.0300000063 * minus_a3_y) - 0.21799999999999997 * n4_y_p3;

  // link 5 (chest2), outward
  const Real minus_n5_y_p1 = minus_wd5_y - minus_w5_x * w5_z;

  // link 6 (chest3), inward
  const Real minus_n5_y = 0.005678398088837119 * a6_x_p5 + 0.04675382692737882 * minus_n5_y_p1 +
      0.069699984375 * a5_z - s6 * minus_n6_y - c6 * n6_x;
  const Real f5_z_p1 = c6 * f6_y + s6 * f6_x;
  const Real f5_z = f5_z_p1 + (2.2194301519999997 * a6_x_p5 + 0.069699984375 * minus_n5_y_p1);

  // link 4 (chest1), outward
  const Real n4_x_p1 = w4_x * w4_y;
  const Real n4_x_p2 = qdd_0[3] + n4_x_p1;

  // link 5 (chest2), inward
  const Real n4_x_p3 = 0.005880002159562879 * n4_x_p2 + 0.0478915 * (wd4_x_p2 + wd4_x) -
      0.21799999999999997 * f5_z + s5 * minus_n5_y;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p1 = 0.0187369177636143 * (wd6_x - minus_a7_y_p1) + 2.06965463592404 * wd6_z +
      1.26882463592404 * minus_a7_y_p7 - 6.1665928899999995 * a6_y;
  const Real n6_z_p2 = n6_z_p1 + s21 * minus_n21_y - c21 * minus_n21_x - s14 * n14_y + c14 * n14_x;
  const Real n6_z = 0.18 * (f6_x_p2 - f6_x_p1) - (0.226 * (f14_z + f7_z) -
      (n6_z_p2 + s7 * minus_n7_y - c7 * minus_n7_x));
  tau[5] = n6_z;

  // link 6 (chest3), inward
  const Real n5_x = n6_z - (0.005678398088837119 * minus_n5_y_p1 + 0.15637308509675518 * a6_x_p5 +
      2.2194301519999997 * a5_z) - 0.072 * f5_z_p1;

  // link 5 (chest2), inward
  const Real n4_x = n4_x_p3 + c5 * n5_x;

  // link 4 (chest1), inward
  const Real n3_z = 1.7824817919087104 * wd3_z - 8.419374554 * minus_a3_x + 0.02999999505 *
      minus_a3_y + c4 * n4_y + s4 * n4_x;
  tau[2] = n3_z;

  // link 3 (hip), outward
  const Real f3_y_p1 = w3_z * w3_z;

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * f3_y_p1 - 0.02999999505 * wd3_z + 0.0300000063 * n4_y_p2 + c5 *
      f5_y - s5 * minus_f5_x;

  // link 5 (chest2), inward
  const Real minus_f4_x = n4_y_p3 - 0.0300000063 * (minus_a5_x_p2 + n4_y_p1);
  const Real f4_y = f5_z - 0.0300000063 * n4_x_p2;

  // link 4 (chest1), inward
  const Real f3_x = 8.419374554 * wd3_z + 0.02999999505 * f3_y_p1 - s4 * f4_y - c4 * minus_f4_x;

  // link 3 (hip), inward
  const Real n2_z_p1 = s3 * f3_y - c3 * f3_x;
  const Real n2_z = n3_z + (9.885744550888212 * wd2_z - 24.5839218 * minus_a2_x -
      0.031999971599999996 * minus_a2_y) - 0.422 * n2_z_p1;
  tau[1] = n2_z;
  const Real f2_y = 24.5839218 * minus_a3_y_p1 + 0.031999971599999996 * wd2_z + c3 * f3_y + s3 *
      f3_x;
  const Real minus_f2_x = n2_z_p1 - (24.5839218 * wd2_z - 0.031999971599999996 * minus_a3_y_p1);

  // link 2 (thigh), inward
  const Real n1_z = n2_z + (13.049859506913753 * qdd_0[0] - 299.6743959432 * s1 + 0.1569597827085 *
      c1) - 0.434 * (s2 * f2_y + c2 * minus_f2_x);
  tau[0] = n1_z;

  // link 5 (chest2), inward
  const Real n4_z_p1 = 0.005880002159562879 * wd4_x_p1 + 0.060169103246295166 * qdd_0[3] -
      0.03561389675370483 * n4_x_p1 - 0.0300000063 * a4_y + c5 * minus_n5_y;
  const Real n4_z = n4_z_p1 - s5 * n5_x;
  tau[3] = n4_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
