// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By unit forces propagated inward (PV-OSIM), in the axes asked for at link origins.
// 6416 flops (add 2744, mul 3640, div 32), sine and cosine of 24 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

void lambda_inverse(const Real (&TREELINE_RESTRICT q)[24],
    Real (&TREELINE_RESTRICT Lambda_inv)[144]) noexcept {
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

  // link 5 (chest2), pose
  const Real Lambda_inv_0_4_p1 = s4 * s5;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_4_p2 = c4 * c6 + s6 * Lambda_inv_0_4_p1;
  const Real Lambda_inv_0_4_p3 = c4 * s6 - c6 * Lambda_inv_0_4_p1;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_4_p4 = s4 * c5;

  // link 7 (left_shoulder1), pose
  const Real Lambda_inv_0_4_p5 = s7 * Lambda_inv_0_4_p4 - c7 * Lambda_inv_0_4_p3;

  // link 8 (left_shoulder2), pose
  const Real Lambda_inv_0_4_p6 = s8 * Lambda_inv_0_4_p2 - c8 * Lambda_inv_0_4_p5;
  const Real Lambda_inv_0_4_p7 = c8 * Lambda_inv_0_4_p2 + s8 * Lambda_inv_0_4_p5;

  // link 7 (left_shoulder1), pose
  const Real Lambda_inv_0_4_p8 = c7 * Lambda_inv_0_4_p4 + s7 * Lambda_inv_0_4_p3;

  // link 9 (left_upperarm), pose
  const Real Lambda_inv_0_4_p9 = c9 * Lambda_inv_0_4_p8 + s9 * Lambda_inv_0_4_p7;

  // link 10 (left_lowerarm), pose
  const Real Lambda_inv_0_4_p10 = c10 * Lambda_inv_0_4_p6 - s10 * Lambda_inv_0_4_p9;
  const Real Lambda_inv_0_4_p11 = s10 * Lambda_inv_0_4_p6 + c10 * Lambda_inv_0_4_p9;

  // link 9 (left_upperarm), pose
  const Real Lambda_inv_0_4_p12 = s9 * Lambda_inv_0_4_p8 - c9 * Lambda_inv_0_4_p7;

  // link 11 (left_wrist1), pose
  const Real Lambda_inv_0_4_p13 = s11 * Lambda_inv_0_4_p12 - c11 * Lambda_inv_0_4_p11;

  // link 12 (left_wrist2), pose
  const Real Lambda_inv_0_4_p14 = c12 * Lambda_inv_0_4_p10 + s12 * Lambda_inv_0_4_p13;

  // link 11 (left_wrist1), pose
  const Real Lambda_inv_0_4_p15 = c11 * Lambda_inv_0_4_p12 + s11 * Lambda_inv_0_4_p11;

  // link 13 (left_hand), pose
  const Real Lambda_inv_0_4_p16 = c13 * Lambda_inv_0_4_p15 + s13 * Lambda_inv_0_4_p14;

  // link 12 (left_wrist2), pose
  const Real Lambda_inv_0_4_p17 = s12 * Lambda_inv_0_4_p10 - c12 * Lambda_inv_0_4_p13;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_0_4_p18 = Lambda_inv_0_4_p16 + 0.04672761636452121 * Lambda_inv_0_4_p17;

  // link 13 (left_hand), pose
  const Real Lambda_inv_0_4_p19 = s13 * Lambda_inv_0_4_p15 - c13 * Lambda_inv_0_4_p14;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_0_4_p20 = Lambda_inv_0_4_p19 - 0.11533812622014242 * Lambda_inv_0_4_p17;
  const Real Lambda_inv_0_4_p21 = c13 * Lambda_inv_0_4_p18 + s13 * Lambda_inv_0_4_p20;
  const Real Lambda_inv_0_4_p22 = 17.32841575379867 * Lambda_inv_0_4_p17;
  const Real Lambda_inv_0_4_p23 = 3.0523172236718206 * Lambda_inv_0_4_p17;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_0_4_p24 = s13 * Lambda_inv_0_4_p22 - c13 * Lambda_inv_0_4_p23 +
      inverse_D5_p190 * Lambda_inv_0_4_p21;
  const Real Lambda_inv_0_4_p25 = inverse_D5_p184 * Lambda_inv_0_4_p21;
  const Real Lambda_inv_0_4_p26 = s12 * Lambda_inv_0_4_p24 + c12 * Lambda_inv_0_4_p25;
  const Real Lambda_inv_0_4_p27 = s13 * Lambda_inv_0_4_p18 - c13 * Lambda_inv_0_4_p20 -
      inverse_D11_p1 * Lambda_inv_0_4_p21;
  const Real Lambda_inv_0_4_p28 = c12 * Lambda_inv_0_4_p27;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_0_4_p29 = 0.269 * Lambda_inv_0_4_p26 + inverse_D5_p205 * Lambda_inv_0_4_p28;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_0_4_p30 = c13 * Lambda_inv_0_4_p22 + s13 * Lambda_inv_0_4_p23 +
      inverse_D5_p196 * Lambda_inv_0_4_p21;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_0_4_p31 = 0.269 * Lambda_inv_0_4_p30 + s12 * Lambda_inv_0_4_p27 -
      inverse_D5_p211 * Lambda_inv_0_4_p28;
  const Real Lambda_inv_0_4_p32 = c11 * Lambda_inv_0_4_p29 - s11 * Lambda_inv_0_4_p31;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_4_p33 = c12 * Lambda_inv_0_4_p24 - s12 * Lambda_inv_0_4_p25 -
      inverse_D5_p268 * Lambda_inv_0_4_p28 + inverse_D5_p273 * Lambda_inv_0_4_p32;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_0_4_p34 = Lambda_inv_0_4_p26 + inverse_D5_p236 * Lambda_inv_0_4_p28;
  const Real Lambda_inv_0_4_p35 = Lambda_inv_0_4_p30 - inverse_D5_p239 * Lambda_inv_0_4_p28;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_4_p36 = s11 * Lambda_inv_0_4_p35 - c11 * Lambda_inv_0_4_p34 +
      inverse_D5_p264 * Lambda_inv_0_4_p32;
  const Real Lambda_inv_0_4_p37 = s10 * Lambda_inv_0_4_p33 - c10 * Lambda_inv_0_4_p36;
  const Real Lambda_inv_0_4_p38 = s11 * Lambda_inv_0_4_p29 + c11 * Lambda_inv_0_4_p31 +
      inverse_D5_p231 * Lambda_inv_0_4_p32;
  const Real Lambda_inv_0_4_p39 = inverse_D5_p228 * Lambda_inv_0_4_p32;
  const Real Lambda_inv_0_4_p40 = c10 * Lambda_inv_0_4_p39 + s10 * Lambda_inv_0_4_p38;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_4_p41 = 0.282 * Lambda_inv_0_4_p37 + minus_inverse_D8_p1 *
      Lambda_inv_0_4_p40;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_4_p42 = c11 * Lambda_inv_0_4_p35 + s11 * Lambda_inv_0_4_p34 -
      inverse_D5_p246 * Lambda_inv_0_4_p32;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_4_p43 = 0.282 * Lambda_inv_0_4_p42 - s10 * Lambda_inv_0_4_p39 + c10 *
      Lambda_inv_0_4_p38 + minus_inverse_D8_p4 * Lambda_inv_0_4_p40;
  const Real Lambda_inv_0_4_p44 = s9 * Lambda_inv_0_4_p41 + c9 * Lambda_inv_0_4_p43;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_4_p45 = c9 * Lambda_inv_0_4_p41 - s9 * Lambda_inv_0_4_p43 +
      minus_inverse_D7_p1 * Lambda_inv_0_4_p44;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_inv_0_4_p46 = 0.00010499999999999999 / minus_inverse_D8_p9;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_4_p47 = Lambda_inv_0_4_p46 * Lambda_inv_0_4_p44;
  const Real Lambda_inv_0_4_p48 = c8 * Lambda_inv_0_4_p45 + s8 * Lambda_inv_0_4_p47;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_4_p49 = Lambda_inv_0_4_p37 + inverse_D5_p281 * Lambda_inv_0_4_p40;
  const Real Lambda_inv_0_4_p50 = Lambda_inv_0_4_p42 + inverse_D5_p253 * Lambda_inv_0_4_p40;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_4_p51 = c9 * Lambda_inv_0_4_p50 + s9 * Lambda_inv_0_4_p49 -
      inverse_D5_p322 * Lambda_inv_0_4_p44;
  const Real Lambda_inv_0_4_p52 = c10 * Lambda_inv_0_4_p33 + s10 * Lambda_inv_0_4_p36 +
      inverse_D5_p313 * Lambda_inv_0_4_p40 + inverse_D5_p319 * Lambda_inv_0_4_p44;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_0_4_p53 = s8 * Lambda_inv_0_4_p51 + c8 * Lambda_inv_0_4_p52 -
      inverse_D5_p329 * Lambda_inv_0_4_p48;
  const Real Lambda_inv_0_4_p54 = s9 * Lambda_inv_0_4_p50 - c9 * Lambda_inv_0_4_p49 -
      inverse_D5_p303 * Lambda_inv_0_4_p44 + inverse_D5_p309 * Lambda_inv_0_4_p48;
  const Real Lambda_inv_0_4_p55 = c7 * Lambda_inv_0_4_p53 + s7 * Lambda_inv_0_4_p54;
  const Real Lambda_inv_0_4_p56 = c8 * Lambda_inv_0_4_p51 - s8 * Lambda_inv_0_4_p52 +
      inverse_D5_p359 * Lambda_inv_0_4_p48;
  const Real Lambda_inv_0_4_p57 = s8 * Lambda_inv_0_4_p45 - c8 * Lambda_inv_0_4_p47 -
      inverse_D5_p370 * Lambda_inv_0_4_p48;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_4_p58 = 2.6249999999999998e-05 / minus_inverse_D7_p8;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_0_4_p59 = Lambda_inv_0_4_p58 * Lambda_inv_0_4_p48;
  const Real Lambda_inv_0_4_p60 = 0.18 * Lambda_inv_0_4_p55 - 0.226 * Lambda_inv_0_4_p56 - s7 *
      Lambda_inv_0_4_p57 + c7 * Lambda_inv_0_4_p59;
  const Real Lambda_inv_0_4_p61 = s7 * Lambda_inv_0_4_p53 - c7 * Lambda_inv_0_4_p54;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_4_p62 = Lambda_inv_0_4_p61 + inverse_D5_p408 * Lambda_inv_0_4_p60;
  const Real Lambda_inv_0_4_p63 = 0.226 * Lambda_inv_0_4_p61 - inverse_D5_p383 * Lambda_inv_0_4_p60;
  const Real Lambda_inv_0_4_p64 = 0.18 * Lambda_inv_0_4_p61 + c7 * Lambda_inv_0_4_p57 + s7 *
      Lambda_inv_0_4_p59 - inverse_D5_p390 * Lambda_inv_0_4_p60;
  const Real Lambda_inv_0_4_p65 = 0.072 * Lambda_inv_0_4_p62 + c6 * Lambda_inv_0_4_p63 + s6 *
      Lambda_inv_0_4_p64;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_4_p66 = s6 * Lambda_inv_0_4_p63 - c6 * Lambda_inv_0_4_p64 -
      inverse_D1_p35 * Lambda_inv_0_4_p65;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_4_p67 = Lambda_inv_0_4_p56 - inverse_D1_p2 * Lambda_inv_0_4_p60;
  const Real Lambda_inv_0_4_p68 = Lambda_inv_0_4_p55 + inverse_D1_p11 * Lambda_inv_0_4_p60;
  const Real Lambda_inv_0_4_p69 = c6 * Lambda_inv_0_4_p67 - s6 * Lambda_inv_0_4_p68;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_4_p70 = 0.072 * Lambda_inv_0_4_p69 - inverse_D1_p25 * Lambda_inv_0_4_p65;
  const Real Lambda_inv_0_4_p71 = c5 * Lambda_inv_0_4_p66 + s5 * Lambda_inv_0_4_p70;
  const Real Lambda_inv_0_4_p72 = s6 * Lambda_inv_0_4_p67 + c6 * Lambda_inv_0_4_p68 -
      inverse_D1_p58 * Lambda_inv_0_4_p65;
  const Real Lambda_inv_0_4_p73 = Lambda_inv_0_4_p62 - inverse_D1_p54 * Lambda_inv_0_4_p65;
  const Real Lambda_inv_0_4_p74 = s5 * Lambda_inv_0_4_p72 + c5 * Lambda_inv_0_4_p73;
  const Real Lambda_inv_0_4_p75 = Lambda_inv_0_4_p69 - inverse_D1_p42 * Lambda_inv_0_4_p65;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_4_p76 = s4 * (0.21799999999999997 * Lambda_inv_0_4_p75 - s5 *
      Lambda_inv_0_4_p66 + c5 * Lambda_inv_0_4_p70 + inverse_D3_p3 * Lambda_inv_0_4_p71);
  const Real Lambda_inv_0_4_p77 = c4 * (0.21799999999999997 * Lambda_inv_0_4_p74 + inverse_D3_p1 *
      Lambda_inv_0_4_p71) - Lambda_inv_0_4_p76;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_4_p78 = c5 * Lambda_inv_0_4_p72 - s5 * Lambda_inv_0_4_p73 -
      inverse_D1_p83 * Lambda_inv_0_4_p71 - inverse_D1_p87 * Lambda_inv_0_4_p77;
  const Real Lambda_inv_0_4_p79 = s4 * (Lambda_inv_0_4_p75 + inverse_D1_p48 * Lambda_inv_0_4_p71) -
      c4 * (Lambda_inv_0_4_p74 + inverse_D1_p67 * Lambda_inv_0_4_p71) + inverse_D1_p89 *
      Lambda_inv_0_4_p77;
  const Real Lambda_inv_0_4_p80 = s3 * Lambda_inv_0_4_p78 - c3 * Lambda_inv_0_4_p79;
  const Real Lambda_inv_0_4_p81 = 0.422 * Lambda_inv_0_4_p80;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_4_p82 = s2 * (c3 * Lambda_inv_0_4_p78 + s3 * Lambda_inv_0_4_p79 +
      inverse_D1_p102 * Lambda_inv_0_4_p81) + c2 * (Lambda_inv_0_4_p80 - inverse_D1_p98 *
      Lambda_inv_0_4_p81);
  const Real Lambda_inv_0_4_p83 = 0.434 * Lambda_inv_0_4_p82;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_4_p84 = inverse_D1 * Lambda_inv_0_4_p83;

  // link 2 (thigh), pose
  const Real Lambda_inv_0_4_p85 = s1 * c2 + c1 * s2;
  const Real Lambda_inv_0_4_p86 = s1 * s2 - c1 * c2;

  // link 3 (hip), pose
  const Real Lambda_inv_0_4_p87 = c3 * Lambda_inv_0_4_p85 - s3 * Lambda_inv_0_4_p86;
  const Real Lambda_inv_0_4_p88 = s3 * Lambda_inv_0_4_p85 + c3 * Lambda_inv_0_4_p86;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_4_p89 = c4 * Lambda_inv_0_4_p88;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_4_p90 = s5 * Lambda_inv_0_4_p87 + c5 * Lambda_inv_0_4_p89;
  const Real Lambda_inv_0_4_p91 = c5 * Lambda_inv_0_4_p87 - s5 * Lambda_inv_0_4_p89;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_4_p92 = s4 * Lambda_inv_0_4_p88;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_4_p93 = s6 * Lambda_inv_0_4_p92 - c6 * Lambda_inv_0_4_p91;

  // link 7 (left_shoulder1), pose
  const Real Lambda_inv_0_4_p94 = c7 * Lambda_inv_0_4_p90 - s7 * Lambda_inv_0_4_p93;
  const Real Lambda_inv_0_4_p95 = s7 * Lambda_inv_0_4_p90 + c7 * Lambda_inv_0_4_p93;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_4_p96 = c6 * Lambda_inv_0_4_p92 + s6 * Lambda_inv_0_4_p91;

  // link 8 (left_shoulder2), pose
  const Real Lambda_inv_0_4_p97 = c8 * Lambda_inv_0_4_p96 - s8 * Lambda_inv_0_4_p95;

  // link 9 (left_upperarm), pose
  const Real Lambda_inv_0_4_p98 = s9 * Lambda_inv_0_4_p94 + c9 * Lambda_inv_0_4_p97;
  const Real Lambda_inv_0_4_p99 = c9 * Lambda_inv_0_4_p94 - s9 * Lambda_inv_0_4_p97;

  // link 8 (left_shoulder2), pose
  const Real Lambda_inv_0_4_p100 = s8 * Lambda_inv_0_4_p96 + c8 * Lambda_inv_0_4_p95;

  // link 10 (left_lowerarm), pose
  const Real Lambda_inv_0_4_p101 = s10 * Lambda_inv_0_4_p100 - c10 * Lambda_inv_0_4_p99;

  // link 11 (left_wrist1), pose
  const Real Lambda_inv_0_4_p102 = c11 * Lambda_inv_0_4_p98 - s11 * Lambda_inv_0_4_p101;
  const Real Lambda_inv_0_4_p103 = s11 * Lambda_inv_0_4_p98 + c11 * Lambda_inv_0_4_p101;

  // link 10 (left_lowerarm), pose
  const Real Lambda_inv_0_4_p104 = c10 * Lambda_inv_0_4_p100 + s10 * Lambda_inv_0_4_p99;

  // link 12 (left_wrist2), pose
  const Real Lambda_inv_0_4_p105 = c12 * Lambda_inv_0_4_p104 - s12 * Lambda_inv_0_4_p103;

  // link 13 (left_hand), pose
  const Real Lambda_inv_0_4_p106 = c13 * Lambda_inv_0_4_p102 - s13 * Lambda_inv_0_4_p105;
  const Real Lambda_inv_0_4_p107 = s13 * Lambda_inv_0_4_p102 + c13 * Lambda_inv_0_4_p105;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_0_4_p108 = c13 * Lambda_inv_0_4_p106 + s13 * Lambda_inv_0_4_p107;
  const Real Lambda_inv_0_4_p109 = s13 * Lambda_inv_0_4_p106 - c13 * Lambda_inv_0_4_p107;

  // link 12 (left_wrist2), pose
  const Real Lambda_inv_0_4_p110 = s12 * Lambda_inv_0_4_p104 + c12 * Lambda_inv_0_4_p103;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_0_4_p111 = s12 * Lambda_inv_0_4_p109 + c12 * Lambda_inv_0_4_p110;
  const Real Lambda_inv_0_4_p112 = 0.269 * Lambda_inv_0_4_p111;
  const Real Lambda_inv_0_4_p113 = 0.269 * Lambda_inv_0_4_p108;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_0_4_p114 = c11 * Lambda_inv_0_4_p112 - s11 * Lambda_inv_0_4_p113;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_4_p115 = s11 * Lambda_inv_0_4_p108 - c11 * Lambda_inv_0_4_p111 +
      inverse_D5_p264 * Lambda_inv_0_4_p114;
  const Real Lambda_inv_0_4_p116 = c12 * Lambda_inv_0_4_p109 - s12 * Lambda_inv_0_4_p110 +
      inverse_D5_p273 * Lambda_inv_0_4_p114;
  const Real Lambda_inv_0_4_p117 = s10 * Lambda_inv_0_4_p116 - c10 * Lambda_inv_0_4_p115;
  const Real Lambda_inv_0_4_p118 = s11 * Lambda_inv_0_4_p112 + c11 * Lambda_inv_0_4_p113 +
      inverse_D5_p231 * Lambda_inv_0_4_p114;
  const Real Lambda_inv_0_4_p119 = inverse_D5_p228 * Lambda_inv_0_4_p114;
  const Real Lambda_inv_0_4_p120 = c10 * Lambda_inv_0_4_p119 + s10 * Lambda_inv_0_4_p118;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_4_p121 = 0.282 * Lambda_inv_0_4_p117 + minus_inverse_D8_p1 *
      Lambda_inv_0_4_p120;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_4_p122 = c11 * Lambda_inv_0_4_p108 + s11 * Lambda_inv_0_4_p111 -
      inverse_D5_p246 * Lambda_inv_0_4_p114;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_4_p123 = 0.282 * Lambda_inv_0_4_p122 - s10 * Lambda_inv_0_4_p119 + c10 *
      Lambda_inv_0_4_p118 + minus_inverse_D8_p4 * Lambda_inv_0_4_p120;
  const Real Lambda_inv_0_4_p124 = s9 * Lambda_inv_0_4_p121 + c9 * Lambda_inv_0_4_p123;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_4_p125 = c9 * Lambda_inv_0_4_p121 - s9 * Lambda_inv_0_4_p123 +
      minus_inverse_D7_p1 * Lambda_inv_0_4_p124;
  const Real Lambda_inv_0_4_p126 = Lambda_inv_0_4_p46 * Lambda_inv_0_4_p124;
  const Real Lambda_inv_0_4_p127 = c8 * Lambda_inv_0_4_p125 + s8 * Lambda_inv_0_4_p126;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_4_p128 = Lambda_inv_0_4_p122 + inverse_D5_p253 * Lambda_inv_0_4_p120;
  const Real Lambda_inv_0_4_p129 = Lambda_inv_0_4_p117 + inverse_D5_p281 * Lambda_inv_0_4_p120;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_4_p130 = c9 * Lambda_inv_0_4_p128 + s9 * Lambda_inv_0_4_p129 -
      inverse_D5_p322 * Lambda_inv_0_4_p124;
  const Real Lambda_inv_0_4_p131 = c10 * Lambda_inv_0_4_p116 + s10 * Lambda_inv_0_4_p115 +
      inverse_D5_p313 * Lambda_inv_0_4_p120 + inverse_D5_p319 * Lambda_inv_0_4_p124;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_0_4_p132 = s8 * Lambda_inv_0_4_p130 + c8 * Lambda_inv_0_4_p131 -
      inverse_D5_p329 * Lambda_inv_0_4_p127;
  const Real Lambda_inv_0_4_p133 = s9 * Lambda_inv_0_4_p128 - c9 * Lambda_inv_0_4_p129 -
      inverse_D5_p303 * Lambda_inv_0_4_p124 + inverse_D5_p309 * Lambda_inv_0_4_p127;
  const Real Lambda_inv_0_4_p134 = c7 * Lambda_inv_0_4_p132 + s7 * Lambda_inv_0_4_p133;
  const Real Lambda_inv_0_4_p135 = c8 * Lambda_inv_0_4_p130 - s8 * Lambda_inv_0_4_p131 +
      inverse_D5_p359 * Lambda_inv_0_4_p127;
  const Real Lambda_inv_0_4_p136 = s8 * Lambda_inv_0_4_p125 - c8 * Lambda_inv_0_4_p126 -
      inverse_D5_p370 * Lambda_inv_0_4_p127;
  const Real Lambda_inv_0_4_p137 = Lambda_inv_0_4_p58 * Lambda_inv_0_4_p127;
  const Real Lambda_inv_0_4_p138 = 0.18 * Lambda_inv_0_4_p134 - 0.226 * Lambda_inv_0_4_p135 - s7 *
      Lambda_inv_0_4_p136 + c7 * Lambda_inv_0_4_p137;
  const Real Lambda_inv_0_4_p139 = s7 * Lambda_inv_0_4_p132 - c7 * Lambda_inv_0_4_p133;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_4_p140 = Lambda_inv_0_4_p139 + inverse_D5_p408 * Lambda_inv_0_4_p138;
  const Real Lambda_inv_0_4_p141 = 0.226 * Lambda_inv_0_4_p139 - inverse_D5_p383 *
      Lambda_inv_0_4_p138;
  const Real Lambda_inv_0_4_p142 = 0.18 * Lambda_inv_0_4_p139 + c7 * Lambda_inv_0_4_p136 + s7 *
      Lambda_inv_0_4_p137 - inverse_D5_p390 * Lambda_inv_0_4_p138;
  const Real Lambda_inv_0_4_p143 = 0.072 * Lambda_inv_0_4_p140 + c6 * Lambda_inv_0_4_p141 + s6 *
      Lambda_inv_0_4_p142;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_4_p144 = s6 * Lambda_inv_0_4_p141 - c6 * Lambda_inv_0_4_p142 -
      inverse_D1_p35 * Lambda_inv_0_4_p143;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_4_p145 = Lambda_inv_0_4_p135 - inverse_D1_p2 * Lambda_inv_0_4_p138;
  const Real Lambda_inv_0_4_p146 = Lambda_inv_0_4_p134 + inverse_D1_p11 * Lambda_inv_0_4_p138;
  const Real Lambda_inv_0_4_p147 = c6 * Lambda_inv_0_4_p145 - s6 * Lambda_inv_0_4_p146;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_4_p148 = 0.072 * Lambda_inv_0_4_p147 - inverse_D1_p25 *
      Lambda_inv_0_4_p143;
  const Real Lambda_inv_0_4_p149 = c5 * Lambda_inv_0_4_p144 + s5 * Lambda_inv_0_4_p148;
  const Real Lambda_inv_0_4_p150 = s6 * Lambda_inv_0_4_p145 + c6 * Lambda_inv_0_4_p146 -
      inverse_D1_p58 * Lambda_inv_0_4_p143;
  const Real Lambda_inv_0_4_p151 = Lambda_inv_0_4_p140 - inverse_D1_p54 * Lambda_inv_0_4_p143;
  const Real Lambda_inv_0_4_p152 = s5 * Lambda_inv_0_4_p150 + c5 * Lambda_inv_0_4_p151;
  const Real Lambda_inv_0_4_p153 = Lambda_inv_0_4_p147 - inverse_D1_p42 * Lambda_inv_0_4_p143;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_4_p154 = s4 * (0.21799999999999997 * Lambda_inv_0_4_p153 - s5 *
      Lambda_inv_0_4_p144 + c5 * Lambda_inv_0_4_p148 + inverse_D3_p3 * Lambda_inv_0_4_p149);
  const Real Lambda_inv_0_4_p155 = c4 * (0.21799999999999997 * Lambda_inv_0_4_p152 + inverse_D3_p1 *
      Lambda_inv_0_4_p149) - Lambda_inv_0_4_p154;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_4_p156 = c5 * Lambda_inv_0_4_p150 - s5 * Lambda_inv_0_4_p151 -
      inverse_D1_p83 * Lambda_inv_0_4_p149 - inverse_D1_p87 * Lambda_inv_0_4_p155;
  const Real Lambda_inv_0_4_p157 = s4 * (Lambda_inv_0_4_p153 + inverse_D1_p48 *
      Lambda_inv_0_4_p149) - c4 * (Lambda_inv_0_4_p152 + inverse_D1_p67 * Lambda_inv_0_4_p149) +
      inverse_D1_p89 * Lambda_inv_0_4_p155;
  const Real Lambda_inv_0_4_p158 = s3 * Lambda_inv_0_4_p156 - c3 * Lambda_inv_0_4_p157;
  const Real Lambda_inv_0_4_p159 = 0.422 * Lambda_inv_0_4_p158;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_4_p160 = s2 * (c3 * Lambda_inv_0_4_p156 + s3 * Lambda_inv_0_4_p157 +
      inverse_D1_p102 * Lambda_inv_0_4_p159) + c2 * (Lambda_inv_0_4_p158 - inverse_D1_p98 *
      Lambda_inv_0_4_p159);
  const Real Lambda_inv_0_4_p161 = 0.434 * Lambda_inv_0_4_p160;
  const Real Lambda_inv_0_4_p162 = inverse_D2 * Lambda_inv_0_4_p81;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_4_p163 = inverse_D3 * Lambda_inv_0_4_p77;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_4_p164 = inverse_D4 * Lambda_inv_0_4_p71;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_4_p165 = inverse_D5 * Lambda_inv_0_4_p65;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_4_p166 = inverse_D6 * Lambda_inv_0_4_p60;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_0_4_p167 = minus_inverse_D7 * Lambda_inv_0_4_p48;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_4_p168 = minus_inverse_D8 * Lambda_inv_0_4_p44;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_4_p169 = minus_inverse_D9 * Lambda_inv_0_4_p40;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_4_p170 = minus_inverse_D10 * Lambda_inv_0_4_p32;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_4_p171 = Lambda_inv_0_4_p114 * Lambda_inv_0_4_p170 + Lambda_inv_0_4_p120 *
      Lambda_inv_0_4_p169 + Lambda_inv_0_4_p124 * Lambda_inv_0_4_p168 + Lambda_inv_0_4_p127 *
      Lambda_inv_0_4_p167 - Lambda_inv_0_4_p138 * Lambda_inv_0_4_p166;
  const Real Lambda_inv_0_4_p172 = Lambda_inv_0_4_p171 - Lambda_inv_0_4_p143 * Lambda_inv_0_4_p165 -
      Lambda_inv_0_4_p149 * Lambda_inv_0_4_p164 - Lambda_inv_0_4_p155 * Lambda_inv_0_4_p163 -
      Lambda_inv_0_4_p159 * Lambda_inv_0_4_p162;
  const Real Lambda_inv_0_4_p173 = Lambda_inv_0_4_p172 - Lambda_inv_0_4_p161 * Lambda_inv_0_4_p84;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_4_4_p1 = inverse_D11 * Lambda_inv_0_4_p28;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_4_4_p2 = inverse_D12 * Lambda_inv_0_4_p21;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_4_4_p3 = 1065.380700001509 * Lambda_inv_0_4_p17;

  // link 1 (calf), force propagation
  const Real Lambda_inv_4_4_p4 = Lambda_inv_0_4_p17 * Lambda_inv_4_4_p3 + Lambda_inv_0_4_p21 *
      Lambda_inv_4_4_p2 + Lambda_inv_0_4_p28 * Lambda_inv_4_4_p1 - Lambda_inv_0_4_p32 *
      Lambda_inv_0_4_p170 - Lambda_inv_0_4_p40 * Lambda_inv_0_4_p169;
  const Real Lambda_inv_4_4_p5 = Lambda_inv_4_4_p4 - Lambda_inv_0_4_p44 * Lambda_inv_0_4_p168 -
      Lambda_inv_0_4_p48 * Lambda_inv_0_4_p167 + Lambda_inv_0_4_p60 * Lambda_inv_0_4_p166 +
      Lambda_inv_0_4_p65 * Lambda_inv_0_4_p165;
  const Real Lambda_inv_4_4 = Lambda_inv_4_4_p5 + Lambda_inv_0_4_p71 * Lambda_inv_0_4_p164 +
      Lambda_inv_0_4_p77 * Lambda_inv_0_4_p163 + Lambda_inv_0_4_p81 * Lambda_inv_0_4_p162 +
      Lambda_inv_0_4_p83 * Lambda_inv_0_4_p84;
  Lambda_inv[52] = Lambda_inv_4_4;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_4_p174 = c4 * Lambda_inv_0_4_p87;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_4_p175 = s5 * Lambda_inv_0_4_p88 - c5 * Lambda_inv_0_4_p174;
  const Real Lambda_inv_0_4_p176 = c5 * Lambda_inv_0_4_p88 + s5 * Lambda_inv_0_4_p174;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_4_p177 = s4 * Lambda_inv_0_4_p87;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_4_p178 = s6 * Lambda_inv_0_4_p177 + c6 * Lambda_inv_0_4_p176;

  // link 7 (left_shoulder1), pose
  const Real Lambda_inv_0_4_p179 = c7 * Lambda_inv_0_4_p175 + s7 * Lambda_inv_0_4_p178;
  const Real Lambda_inv_0_4_p180 = s7 * Lambda_inv_0_4_p175 - c7 * Lambda_inv_0_4_p178;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_4_p181 = c6 * Lambda_inv_0_4_p177 - s6 * Lambda_inv_0_4_p176;

  // link 8 (left_shoulder2), pose
  const Real Lambda_inv_0_4_p182 = c8 * Lambda_inv_0_4_p181 + s8 * Lambda_inv_0_4_p180;

  // link 9 (left_upperarm), pose
  const Real Lambda_inv_0_4_p183 = s9 * Lambda_inv_0_4_p179 - c9 * Lambda_inv_0_4_p182;
  const Real Lambda_inv_0_4_p184 = c9 * Lambda_inv_0_4_p179 + s9 * Lambda_inv_0_4_p182;

  // link 8 (left_shoulder2), pose
  const Real Lambda_inv_0_4_p185 = s8 * Lambda_inv_0_4_p181 - c8 * Lambda_inv_0_4_p180;

  // link 10 (left_lowerarm), pose
  const Real Lambda_inv_0_4_p186 = s10 * Lambda_inv_0_4_p185 + c10 * Lambda_inv_0_4_p184;

  // link 11 (left_wrist1), pose
  const Real Lambda_inv_0_4_p187 = c11 * Lambda_inv_0_4_p183 + s11 * Lambda_inv_0_4_p186;
  const Real Lambda_inv_0_4_p188 = s11 * Lambda_inv_0_4_p183 - c11 * Lambda_inv_0_4_p186;

  // link 10 (left_lowerarm), pose
  const Real Lambda_inv_0_4_p189 = c10 * Lambda_inv_0_4_p185 - s10 * Lambda_inv_0_4_p184;

  // link 12 (left_wrist2), pose
  const Real Lambda_inv_0_4_p190 = c12 * Lambda_inv_0_4_p189 + s12 * Lambda_inv_0_4_p188;

  // link 13 (left_hand), pose
  const Real Lambda_inv_0_4_p191 = s13 * Lambda_inv_0_4_p187 - c13 * Lambda_inv_0_4_p190;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_4_p192 = 0.086 * Lambda_inv_0_4_p191;

  // link 13 (left_hand), pose
  const Real Lambda_inv_4_5_p1 = c13 * Lambda_inv_0_4_p187 + s13 * Lambda_inv_0_4_p190;

  // link 12 (left_wrist2), pose
  const Real Lambda_inv_4_5_p2 = s12 * Lambda_inv_0_4_p189 - c12 * Lambda_inv_0_4_p188;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_4_5_p3 = Lambda_inv_4_5_p1 + 0.04672761636452121 * Lambda_inv_4_5_p2;
  const Real Lambda_inv_4_5_p4 = Lambda_inv_0_4_p191 - 0.11533812622014242 * Lambda_inv_4_5_p2;
  const Real Lambda_inv_4_5_p5 = c13 * Lambda_inv_4_5_p3 + s13 * Lambda_inv_4_5_p4;
  const Real Lambda_inv_4_5_p6 = 17.32841575379867 * Lambda_inv_4_5_p2;
  const Real Lambda_inv_4_5_p7 = 3.0523172236718206 * Lambda_inv_4_5_p2;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_4_5_p8 = s13 * Lambda_inv_4_5_p6 - c13 * Lambda_inv_4_5_p7 +
      inverse_D5_p190 * Lambda_inv_4_5_p5;
  const Real Lambda_inv_4_5_p9 = inverse_D5_p184 * Lambda_inv_4_5_p5;
  const Real Lambda_inv_4_5_p10 = s12 * Lambda_inv_4_5_p8 + c12 * Lambda_inv_4_5_p9;
  const Real Lambda_inv_4_5_p11 = s13 * Lambda_inv_4_5_p3 - c13 * Lambda_inv_4_5_p4 -
      inverse_D11_p1 * Lambda_inv_4_5_p5;
  const Real Lambda_inv_4_5_p12 = c12 * Lambda_inv_4_5_p11;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_4_5_p13 = 0.269 * Lambda_inv_4_5_p10 + inverse_D5_p205 * Lambda_inv_4_5_p12;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_4_5_p14 = c13 * Lambda_inv_4_5_p6 + s13 * Lambda_inv_4_5_p7 +
      inverse_D5_p196 * Lambda_inv_4_5_p5;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_4_5_p15 = 0.269 * Lambda_inv_4_5_p14 + s12 * Lambda_inv_4_5_p11 -
      inverse_D5_p211 * Lambda_inv_4_5_p12;
  const Real Lambda_inv_4_5_p16 = c11 * Lambda_inv_4_5_p13 - s11 * Lambda_inv_4_5_p15;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_4_5_p17 = c12 * Lambda_inv_4_5_p8 - s12 * Lambda_inv_4_5_p9 -
      inverse_D5_p268 * Lambda_inv_4_5_p12 + inverse_D5_p273 * Lambda_inv_4_5_p16;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_4_5_p18 = Lambda_inv_4_5_p10 + inverse_D5_p236 * Lambda_inv_4_5_p12;
  const Real Lambda_inv_4_5_p19 = Lambda_inv_4_5_p14 - inverse_D5_p239 * Lambda_inv_4_5_p12;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_4_5_p20 = s11 * Lambda_inv_4_5_p19 - c11 * Lambda_inv_4_5_p18 +
      inverse_D5_p264 * Lambda_inv_4_5_p16;
  const Real Lambda_inv_4_5_p21 = s10 * Lambda_inv_4_5_p17 - c10 * Lambda_inv_4_5_p20;
  const Real Lambda_inv_4_5_p22 = s11 * Lambda_inv_4_5_p13 + c11 * Lambda_inv_4_5_p15 +
      inverse_D5_p231 * Lambda_inv_4_5_p16;
  const Real Lambda_inv_4_5_p23 = inverse_D5_p228 * Lambda_inv_4_5_p16;
  const Real Lambda_inv_4_5_p24 = c10 * Lambda_inv_4_5_p23 + s10 * Lambda_inv_4_5_p22;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_4_5_p25 = 0.282 * Lambda_inv_4_5_p21 + minus_inverse_D8_p1 *
      Lambda_inv_4_5_p24;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_4_5_p26 = c11 * Lambda_inv_4_5_p19 + s11 * Lambda_inv_4_5_p18 -
      inverse_D5_p246 * Lambda_inv_4_5_p16;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_4_5_p27 = 0.282 * Lambda_inv_4_5_p26 - s10 * Lambda_inv_4_5_p23 + c10 *
      Lambda_inv_4_5_p22 + minus_inverse_D8_p4 * Lambda_inv_4_5_p24;
  const Real Lambda_inv_4_5_p28 = s9 * Lambda_inv_4_5_p25 + c9 * Lambda_inv_4_5_p27;
  const Real Lambda_inv_4_5_p29 = Lambda_inv_4_5_p21 + inverse_D5_p281 * Lambda_inv_4_5_p24;
  const Real Lambda_inv_4_5_p30 = Lambda_inv_4_5_p26 + inverse_D5_p253 * Lambda_inv_4_5_p24;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_4_5_p31 = c9 * Lambda_inv_4_5_p30 + s9 * Lambda_inv_4_5_p29 -
      inverse_D5_p322 * Lambda_inv_4_5_p28;
  const Real Lambda_inv_4_5_p32 = c10 * Lambda_inv_4_5_p17 + s10 * Lambda_inv_4_5_p20 +
      inverse_D5_p313 * Lambda_inv_4_5_p24 + inverse_D5_p319 * Lambda_inv_4_5_p28;
  const Real Lambda_inv_4_5_p33 = c9 * Lambda_inv_4_5_p25 - s9 * Lambda_inv_4_5_p27 +
      minus_inverse_D7_p1 * Lambda_inv_4_5_p28;
  const Real Lambda_inv_4_5_p34 = Lambda_inv_0_4_p46 * Lambda_inv_4_5_p28;
  const Real Lambda_inv_4_5_p35 = c8 * Lambda_inv_4_5_p33 + s8 * Lambda_inv_4_5_p34;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_4_5_p36 = s8 * Lambda_inv_4_5_p31 + c8 * Lambda_inv_4_5_p32 -
      inverse_D5_p329 * Lambda_inv_4_5_p35;
  const Real Lambda_inv_4_5_p37 = s9 * Lambda_inv_4_5_p30 - c9 * Lambda_inv_4_5_p29 -
      inverse_D5_p303 * Lambda_inv_4_5_p28 + inverse_D5_p309 * Lambda_inv_4_5_p35;
  const Real Lambda_inv_4_5_p38 = c7 * Lambda_inv_4_5_p36 + s7 * Lambda_inv_4_5_p37;
  const Real Lambda_inv_4_5_p39 = c8 * Lambda_inv_4_5_p31 - s8 * Lambda_inv_4_5_p32 +
      inverse_D5_p359 * Lambda_inv_4_5_p35;
  const Real Lambda_inv_4_5_p40 = s8 * Lambda_inv_4_5_p33 - c8 * Lambda_inv_4_5_p34 -
      inverse_D5_p370 * Lambda_inv_4_5_p35;
  const Real Lambda_inv_4_5_p41 = Lambda_inv_0_4_p58 * Lambda_inv_4_5_p35;
  const Real Lambda_inv_4_5_p42 = 0.18 * Lambda_inv_4_5_p38 - 0.226 * Lambda_inv_4_5_p39 - s7 *
      Lambda_inv_4_5_p40 + c7 * Lambda_inv_4_5_p41;
  const Real Lambda_inv_4_5_p43 = s7 * Lambda_inv_4_5_p36 - c7 * Lambda_inv_4_5_p37;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_4_5_p44 = Lambda_inv_4_5_p43 + inverse_D5_p408 * Lambda_inv_4_5_p42;
  const Real Lambda_inv_4_5_p45 = 0.226 * Lambda_inv_4_5_p43 - inverse_D5_p383 * Lambda_inv_4_5_p42;
  const Real Lambda_inv_4_5_p46 = 0.18 * Lambda_inv_4_5_p43 + c7 * Lambda_inv_4_5_p40 + s7 *
      Lambda_inv_4_5_p41 - inverse_D5_p390 * Lambda_inv_4_5_p42;
  const Real Lambda_inv_4_5_p47 = 0.072 * Lambda_inv_4_5_p44 + c6 * Lambda_inv_4_5_p45 + s6 *
      Lambda_inv_4_5_p46;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_4_5_p48 = s6 * Lambda_inv_4_5_p45 - c6 * Lambda_inv_4_5_p46 -
      inverse_D1_p35 * Lambda_inv_4_5_p47;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_4_5_p49 = Lambda_inv_4_5_p39 - inverse_D1_p2 * Lambda_inv_4_5_p42;
  const Real Lambda_inv_4_5_p50 = Lambda_inv_4_5_p38 + inverse_D1_p11 * Lambda_inv_4_5_p42;
  const Real Lambda_inv_4_5_p51 = c6 * Lambda_inv_4_5_p49 - s6 * Lambda_inv_4_5_p50;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_4_5_p52 = 0.072 * Lambda_inv_4_5_p51 - inverse_D1_p25 * Lambda_inv_4_5_p47;
  const Real Lambda_inv_4_5_p53 = c5 * Lambda_inv_4_5_p48 + s5 * Lambda_inv_4_5_p52;
  const Real Lambda_inv_4_5_p54 = s6 * Lambda_inv_4_5_p49 + c6 * Lambda_inv_4_5_p50 -
      inverse_D1_p58 * Lambda_inv_4_5_p47;
  const Real Lambda_inv_4_5_p55 = Lambda_inv_4_5_p44 - inverse_D1_p54 * Lambda_inv_4_5_p47;
  const Real Lambda_inv_4_5_p56 = s5 * Lambda_inv_4_5_p54 + c5 * Lambda_inv_4_5_p55;
  const Real Lambda_inv_4_5_p57 = Lambda_inv_4_5_p51 - inverse_D1_p42 * Lambda_inv_4_5_p47;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_4_5_p58 = s4 * (0.21799999999999997 * Lambda_inv_4_5_p57 - s5 *
      Lambda_inv_4_5_p48 + c5 * Lambda_inv_4_5_p52 + inverse_D3_p3 * Lambda_inv_4_5_p53);
  const Real Lambda_inv_4_5_p59 = c4 * (0.21799999999999997 * Lambda_inv_4_5_p56 + inverse_D3_p1 *
      Lambda_inv_4_5_p53) - Lambda_inv_4_5_p58;

  // link 3 (hip), force propagation
  const Real Lambda_inv_4_5_p60 = c5 * Lambda_inv_4_5_p54 - s5 * Lambda_inv_4_5_p55 -
      inverse_D1_p83 * Lambda_inv_4_5_p53 - inverse_D1_p87 * Lambda_inv_4_5_p59;
  const Real Lambda_inv_4_5_p61 = s4 * (Lambda_inv_4_5_p57 + inverse_D1_p48 * Lambda_inv_4_5_p53) -
      c4 * (Lambda_inv_4_5_p56 + inverse_D1_p67 * Lambda_inv_4_5_p53) + inverse_D1_p89 *
      Lambda_inv_4_5_p59;
  const Real Lambda_inv_4_5_p62 = s3 * Lambda_inv_4_5_p60 - c3 * Lambda_inv_4_5_p61;
  const Real Lambda_inv_4_5_p63 = 0.422 * Lambda_inv_4_5_p62;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_4_5_p64 = s2 * (c3 * Lambda_inv_4_5_p60 + s3 * Lambda_inv_4_5_p61 +
      inverse_D1_p102 * Lambda_inv_4_5_p63) + c2 * (Lambda_inv_4_5_p62 - inverse_D1_p98 *
      Lambda_inv_4_5_p63);
  const Real Lambda_inv_4_5_p65 = 0.434 * Lambda_inv_4_5_p64;

  // link 1 (calf), force propagation
  const Real Lambda_inv_4_5_p66 = inverse_D1 * Lambda_inv_4_5_p65;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_4_5_p67 = inverse_D2 * Lambda_inv_4_5_p63;

  // link 3 (hip), force propagation
  const Real Lambda_inv_4_5_p68 = inverse_D3 * Lambda_inv_4_5_p59;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_4_5_p69 = inverse_D4 * Lambda_inv_4_5_p53;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_4_5_p70 = inverse_D5 * Lambda_inv_4_5_p47;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_4_5_p71 = inverse_D6 * Lambda_inv_4_5_p42;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_4_5_p72 = minus_inverse_D7 * Lambda_inv_4_5_p35;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_4_5_p73 = minus_inverse_D8 * Lambda_inv_4_5_p28;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_4_5_p74 = minus_inverse_D9 * Lambda_inv_4_5_p24;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_4_5_p75 = minus_inverse_D10 * Lambda_inv_4_5_p16;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_4_5_p76 = inverse_D11 * Lambda_inv_4_5_p12;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_4_5_p77 = inverse_D12 * Lambda_inv_4_5_p5;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_4_5_p78 = 1065.380700001509 * Lambda_inv_4_5_p2;

  // link 1 (calf), force propagation
  const Real Lambda_inv_4_5_p79 = Lambda_inv_0_4_p17 * Lambda_inv_4_5_p78 + Lambda_inv_0_4_p21 *
      Lambda_inv_4_5_p77 + Lambda_inv_0_4_p28 * Lambda_inv_4_5_p76 - Lambda_inv_0_4_p32 *
      Lambda_inv_4_5_p75 - Lambda_inv_0_4_p40 * Lambda_inv_4_5_p74;
  const Real Lambda_inv_4_5_p80 = Lambda_inv_4_5_p79 - Lambda_inv_0_4_p44 * Lambda_inv_4_5_p73 -
      Lambda_inv_0_4_p48 * Lambda_inv_4_5_p72 + Lambda_inv_0_4_p60 * Lambda_inv_4_5_p71 +
      Lambda_inv_0_4_p65 * Lambda_inv_4_5_p70;
  const Real Lambda_inv_4_5 = Lambda_inv_4_5_p80 + Lambda_inv_0_4_p71 * Lambda_inv_4_5_p69 +
      Lambda_inv_0_4_p77 * Lambda_inv_4_5_p68 + Lambda_inv_0_4_p81 * Lambda_inv_4_5_p67 +
      Lambda_inv_0_4_p83 * Lambda_inv_4_5_p66;
  Lambda_inv[53] = Lambda_inv_4_5;
  Lambda_inv[64] = Lambda_inv_4_5;
  const Real Lambda_inv_0_4_p193 = 0.086 * Lambda_inv_0_4_p19;
  const Real Lambda_inv_0_4 = Lambda_inv_0_4_p173 - Lambda_inv_4_4 * Lambda_inv_0_4_p192 +
      Lambda_inv_4_5 * Lambda_inv_0_4_p193;
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[48] = Lambda_inv_0_4;
  const Real Lambda_inv_0_0_p1 = Lambda_inv_0_4_p114 * (minus_inverse_D10 * Lambda_inv_0_4_p114) +
      Lambda_inv_0_4_p120 * (minus_inverse_D9 * Lambda_inv_0_4_p120) + Lambda_inv_0_4_p124 *
      (minus_inverse_D8 * Lambda_inv_0_4_p124);
  const Real Lambda_inv_0_0_p2 = Lambda_inv_0_0_p1 + Lambda_inv_0_4_p127 *
      (minus_inverse_D7 * Lambda_inv_0_4_p127) - Lambda_inv_0_4_p138 *
      (inverse_D6 * Lambda_inv_0_4_p138) - Lambda_inv_0_4_p143 * (inverse_D5 * Lambda_inv_0_4_p143);
  const Real Lambda_inv_0_0_p3 = Lambda_inv_0_0_p2 - Lambda_inv_0_4_p149 *
      (inverse_D4 * Lambda_inv_0_4_p149) - Lambda_inv_0_4_p155 *
      (inverse_D3 * Lambda_inv_0_4_p155) - Lambda_inv_0_4_p159 * (inverse_D2 * Lambda_inv_0_4_p159);
  const Real Lambda_inv_0_5_p1 = Lambda_inv_0_4_p114 * Lambda_inv_4_5_p75 + Lambda_inv_0_4_p120 *
      Lambda_inv_4_5_p74 + Lambda_inv_0_4_p124 * Lambda_inv_4_5_p73 + Lambda_inv_0_4_p127 *
      Lambda_inv_4_5_p72 - Lambda_inv_0_4_p138 * Lambda_inv_4_5_p71;
  const Real Lambda_inv_0_5_p2 = Lambda_inv_0_5_p1 - Lambda_inv_0_4_p143 * Lambda_inv_4_5_p70 -
      Lambda_inv_0_4_p149 * Lambda_inv_4_5_p69 - Lambda_inv_0_4_p155 * Lambda_inv_4_5_p68 -
      Lambda_inv_0_4_p159 * Lambda_inv_4_5_p67;
  const Real Lambda_inv_0_5_p3 = Lambda_inv_0_5_p2 - Lambda_inv_0_4_p161 * Lambda_inv_4_5_p66;
  const Real Lambda_inv_5_5_p1 = Lambda_inv_4_5_p2 * Lambda_inv_4_5_p78 + Lambda_inv_4_5_p5 *
      Lambda_inv_4_5_p77 + Lambda_inv_4_5_p12 * Lambda_inv_4_5_p76 - Lambda_inv_4_5_p16 *
      Lambda_inv_4_5_p75 - Lambda_inv_4_5_p24 * Lambda_inv_4_5_p74;
  const Real Lambda_inv_5_5_p2 = Lambda_inv_5_5_p1 - Lambda_inv_4_5_p28 * Lambda_inv_4_5_p73 -
      Lambda_inv_4_5_p35 * Lambda_inv_4_5_p72 + Lambda_inv_4_5_p42 * Lambda_inv_4_5_p71 +
      Lambda_inv_4_5_p47 * Lambda_inv_4_5_p70;
  const Real Lambda_inv_5_5 = Lambda_inv_5_5_p2 + Lambda_inv_4_5_p53 * Lambda_inv_4_5_p69 +
      Lambda_inv_4_5_p59 * Lambda_inv_4_5_p68 + Lambda_inv_4_5_p63 * Lambda_inv_4_5_p67 +
      Lambda_inv_4_5_p65 * Lambda_inv_4_5_p66;
  Lambda_inv[65] = Lambda_inv_5_5;
  const Real Lambda_inv_0_5 = Lambda_inv_0_5_p3 - Lambda_inv_4_5 * Lambda_inv_0_4_p192 +
      Lambda_inv_5_5 * Lambda_inv_0_4_p193;
  Lambda_inv[5] = Lambda_inv_0_5;
  Lambda_inv[60] = Lambda_inv_0_5;
  Lambda_inv[0] = -(Lambda_inv_0_0_p3 - Lambda_inv_0_4_p161 * (inverse_D1 * Lambda_inv_0_4_p161) +
      Lambda_inv_0_4_p192 * (Lambda_inv_0_4_p173 + Lambda_inv_0_4) - Lambda_inv_0_4_p193 *
      (Lambda_inv_0_5_p3 + Lambda_inv_0_5));

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_3_4_p1 = Lambda_inv_0_4_p106 - 0.04672761636452121 * Lambda_inv_0_4_p110;
  const Real Lambda_inv_3_4_p2 = Lambda_inv_0_4_p107 + 0.11533812622014242 * Lambda_inv_0_4_p110;
  const Real Lambda_inv_3_4_p3 = c13 * Lambda_inv_3_4_p1 + s13 * Lambda_inv_3_4_p2;
  const Real Lambda_inv_3_4_p4 = 17.32841575379867 * Lambda_inv_0_4_p110;
  const Real Lambda_inv_3_4_p5 = 3.0523172236718206 * Lambda_inv_0_4_p110;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_3_4_p6 = s13 * Lambda_inv_3_4_p4 - c13 * Lambda_inv_3_4_p5 -
      inverse_D5_p190 * Lambda_inv_3_4_p3;
  const Real Lambda_inv_3_4_p7 = inverse_D5_p184 * Lambda_inv_3_4_p3;
  const Real Lambda_inv_3_4_p8 = s12 * Lambda_inv_3_4_p6 - c12 * Lambda_inv_3_4_p7;
  const Real Lambda_inv_3_4_p9 = s13 * Lambda_inv_3_4_p1 - c13 * Lambda_inv_3_4_p2 -
      inverse_D11_p1 * Lambda_inv_3_4_p3;
  const Real Lambda_inv_3_4_p10 = c12 * Lambda_inv_3_4_p9;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_3_4_p11 = 0.269 * Lambda_inv_3_4_p8 - inverse_D5_p205 * Lambda_inv_3_4_p10;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_3_4_p12 = c13 * Lambda_inv_3_4_p4 + s13 * Lambda_inv_3_4_p5 -
      inverse_D5_p196 * Lambda_inv_3_4_p3;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_3_4_p13 = 0.269 * Lambda_inv_3_4_p12 - s12 * Lambda_inv_3_4_p9 +
      inverse_D5_p211 * Lambda_inv_3_4_p10;
  const Real Lambda_inv_3_4_p14 = c11 * Lambda_inv_3_4_p11 - s11 * Lambda_inv_3_4_p13;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_3_4_p15 = c12 * Lambda_inv_3_4_p6 + s12 * Lambda_inv_3_4_p7 +
      inverse_D5_p268 * Lambda_inv_3_4_p10 + inverse_D5_p273 * Lambda_inv_3_4_p14;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_3_4_p16 = Lambda_inv_3_4_p8 - inverse_D5_p236 * Lambda_inv_3_4_p10;
  const Real Lambda_inv_3_4_p17 = Lambda_inv_3_4_p12 + inverse_D5_p239 * Lambda_inv_3_4_p10;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_3_4_p18 = s11 * Lambda_inv_3_4_p17 - c11 * Lambda_inv_3_4_p16 +
      inverse_D5_p264 * Lambda_inv_3_4_p14;
  const Real Lambda_inv_3_4_p19 = s10 * Lambda_inv_3_4_p15 - c10 * Lambda_inv_3_4_p18;
  const Real Lambda_inv_3_4_p20 = s11 * Lambda_inv_3_4_p11 + c11 * Lambda_inv_3_4_p13 +
      inverse_D5_p231 * Lambda_inv_3_4_p14;
  const Real Lambda_inv_3_4_p21 = inverse_D5_p228 * Lambda_inv_3_4_p14;
  const Real Lambda_inv_3_4_p22 = c10 * Lambda_inv_3_4_p21 + s10 * Lambda_inv_3_4_p20;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_3_4_p23 = 0.282 * Lambda_inv_3_4_p19 + minus_inverse_D8_p1 *
      Lambda_inv_3_4_p22;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_3_4_p24 = c11 * Lambda_inv_3_4_p17 + s11 * Lambda_inv_3_4_p16 -
      inverse_D5_p246 * Lambda_inv_3_4_p14;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_3_4_p25 = 0.282 * Lambda_inv_3_4_p24 - s10 * Lambda_inv_3_4_p21 + c10 *
      Lambda_inv_3_4_p20 + minus_inverse_D8_p4 * Lambda_inv_3_4_p22;
  const Real Lambda_inv_3_4_p26 = s9 * Lambda_inv_3_4_p23 + c9 * Lambda_inv_3_4_p25;
  const Real Lambda_inv_3_4_p27 = Lambda_inv_3_4_p19 + inverse_D5_p281 * Lambda_inv_3_4_p22;
  const Real Lambda_inv_3_4_p28 = Lambda_inv_3_4_p24 + inverse_D5_p253 * Lambda_inv_3_4_p22;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_3_4_p29 = c9 * Lambda_inv_3_4_p28 + s9 * Lambda_inv_3_4_p27 -
      inverse_D5_p322 * Lambda_inv_3_4_p26;
  const Real Lambda_inv_3_4_p30 = c10 * Lambda_inv_3_4_p15 + s10 * Lambda_inv_3_4_p18 +
      inverse_D5_p313 * Lambda_inv_3_4_p22 + inverse_D5_p319 * Lambda_inv_3_4_p26;
  const Real Lambda_inv_3_4_p31 = c9 * Lambda_inv_3_4_p23 - s9 * Lambda_inv_3_4_p25 +
      minus_inverse_D7_p1 * Lambda_inv_3_4_p26;
  const Real Lambda_inv_3_4_p32 = Lambda_inv_0_4_p46 * Lambda_inv_3_4_p26;
  const Real Lambda_inv_3_4_p33 = c8 * Lambda_inv_3_4_p31 + s8 * Lambda_inv_3_4_p32;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_3_4_p34 = s8 * Lambda_inv_3_4_p29 + c8 * Lambda_inv_3_4_p30 -
      inverse_D5_p329 * Lambda_inv_3_4_p33;
  const Real Lambda_inv_3_4_p35 = s9 * Lambda_inv_3_4_p28 - c9 * Lambda_inv_3_4_p27 -
      inverse_D5_p303 * Lambda_inv_3_4_p26 + inverse_D5_p309 * Lambda_inv_3_4_p33;
  const Real Lambda_inv_3_4_p36 = c7 * Lambda_inv_3_4_p34 + s7 * Lambda_inv_3_4_p35;
  const Real Lambda_inv_3_4_p37 = c8 * Lambda_inv_3_4_p29 - s8 * Lambda_inv_3_4_p30 +
      inverse_D5_p359 * Lambda_inv_3_4_p33;
  const Real Lambda_inv_3_4_p38 = s8 * Lambda_inv_3_4_p31 - c8 * Lambda_inv_3_4_p32 -
      inverse_D5_p370 * Lambda_inv_3_4_p33;
  const Real Lambda_inv_3_4_p39 = Lambda_inv_0_4_p58 * Lambda_inv_3_4_p33;
  const Real Lambda_inv_3_4_p40 = 0.18 * Lambda_inv_3_4_p36 - 0.226 * Lambda_inv_3_4_p37 - s7 *
      Lambda_inv_3_4_p38 + c7 * Lambda_inv_3_4_p39;
  const Real Lambda_inv_3_4_p41 = s7 * Lambda_inv_3_4_p34 - c7 * Lambda_inv_3_4_p35;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_3_4_p42 = Lambda_inv_3_4_p41 + inverse_D5_p408 * Lambda_inv_3_4_p40;
  const Real Lambda_inv_3_4_p43 = 0.226 * Lambda_inv_3_4_p41 - inverse_D5_p383 * Lambda_inv_3_4_p40;
  const Real Lambda_inv_3_4_p44 = 0.18 * Lambda_inv_3_4_p41 + c7 * Lambda_inv_3_4_p38 + s7 *
      Lambda_inv_3_4_p39 - inverse_D5_p390 * Lambda_inv_3_4_p40;
  const Real Lambda_inv_3_4_p45 = 0.072 * Lambda_inv_3_4_p42 + c6 * Lambda_inv_3_4_p43 + s6 *
      Lambda_inv_3_4_p44;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_3_4_p46 = s6 * Lambda_inv_3_4_p43 - c6 * Lambda_inv_3_4_p44 -
      inverse_D1_p35 * Lambda_inv_3_4_p45;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_3_4_p47 = Lambda_inv_3_4_p37 - inverse_D1_p2 * Lambda_inv_3_4_p40;
  const Real Lambda_inv_3_4_p48 = Lambda_inv_3_4_p36 + inverse_D1_p11 * Lambda_inv_3_4_p40;
  const Real Lambda_inv_3_4_p49 = c6 * Lambda_inv_3_4_p47 - s6 * Lambda_inv_3_4_p48;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_3_4_p50 = 0.072 * Lambda_inv_3_4_p49 - inverse_D1_p25 * Lambda_inv_3_4_p45;
  const Real Lambda_inv_3_4_p51 = c5 * Lambda_inv_3_4_p46 + s5 * Lambda_inv_3_4_p50;
  const Real Lambda_inv_3_4_p52 = s6 * Lambda_inv_3_4_p47 + c6 * Lambda_inv_3_4_p48 -
      inverse_D1_p58 * Lambda_inv_3_4_p45;
  const Real Lambda_inv_3_4_p53 = Lambda_inv_3_4_p42 - inverse_D1_p54 * Lambda_inv_3_4_p45;
  const Real Lambda_inv_3_4_p54 = s5 * Lambda_inv_3_4_p52 + c5 * Lambda_inv_3_4_p53;
  const Real Lambda_inv_3_4_p55 = Lambda_inv_3_4_p49 - inverse_D1_p42 * Lambda_inv_3_4_p45;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_3_4_p56 = s4 * (0.21799999999999997 * Lambda_inv_3_4_p55 - s5 *
      Lambda_inv_3_4_p46 + c5 * Lambda_inv_3_4_p50 + inverse_D3_p3 * Lambda_inv_3_4_p51);
  const Real Lambda_inv_3_4_p57 = c4 * (0.21799999999999997 * Lambda_inv_3_4_p54 + inverse_D3_p1 *
      Lambda_inv_3_4_p51) - Lambda_inv_3_4_p56;

  // link 3 (hip), force propagation
  const Real Lambda_inv_3_4_p58 = c5 * Lambda_inv_3_4_p52 - s5 * Lambda_inv_3_4_p53 -
      inverse_D1_p83 * Lambda_inv_3_4_p51 - inverse_D1_p87 * Lambda_inv_3_4_p57;
  const Real Lambda_inv_3_4_p59 = s4 * (Lambda_inv_3_4_p55 + inverse_D1_p48 * Lambda_inv_3_4_p51) -
      c4 * (Lambda_inv_3_4_p54 + inverse_D1_p67 * Lambda_inv_3_4_p51) + inverse_D1_p89 *
      Lambda_inv_3_4_p57;
  const Real Lambda_inv_3_4_p60 = s3 * Lambda_inv_3_4_p58 - c3 * Lambda_inv_3_4_p59;
  const Real Lambda_inv_3_4_p61 = 0.422 * Lambda_inv_3_4_p60;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_3_4_p62 = s2 * (c3 * Lambda_inv_3_4_p58 + s3 * Lambda_inv_3_4_p59 +
      inverse_D1_p102 * Lambda_inv_3_4_p61) + c2 * (Lambda_inv_3_4_p60 - inverse_D1_p98 *
      Lambda_inv_3_4_p61);
  const Real Lambda_inv_3_4_p63 = 0.434 * Lambda_inv_3_4_p62;

  // link 1 (calf), force propagation
  const Real Lambda_inv_3_4_p64 = Lambda_inv_0_4_p110 * Lambda_inv_4_4_p3 - Lambda_inv_3_4_p3 *
      Lambda_inv_4_4_p2 - Lambda_inv_3_4_p10 * Lambda_inv_4_4_p1 - Lambda_inv_3_4_p14 *
      Lambda_inv_0_4_p170 - Lambda_inv_3_4_p22 * Lambda_inv_0_4_p169;
  const Real Lambda_inv_3_4_p65 = Lambda_inv_3_4_p64 - Lambda_inv_3_4_p26 * Lambda_inv_0_4_p168 -
      Lambda_inv_3_4_p33 * Lambda_inv_0_4_p167 + Lambda_inv_3_4_p40 * Lambda_inv_0_4_p166 +
      Lambda_inv_3_4_p45 * Lambda_inv_0_4_p165;
  const Real Lambda_inv_3_4 = Lambda_inv_3_4_p65 + Lambda_inv_3_4_p51 * Lambda_inv_0_4_p164 +
      Lambda_inv_3_4_p57 * Lambda_inv_0_4_p163 + Lambda_inv_3_4_p61 * Lambda_inv_0_4_p162 +
      Lambda_inv_3_4_p63 * Lambda_inv_0_4_p84;
  Lambda_inv[40] = Lambda_inv_3_4;
  Lambda_inv[51] = Lambda_inv_3_4;
  const Real Lambda_inv_0_3_p1 = Lambda_inv_3_4 * Lambda_inv_0_4_p192;
  const Real Lambda_inv_0_3_p2 = inverse_D1 * Lambda_inv_3_4_p63;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_3_p3 = inverse_D2 * Lambda_inv_3_4_p61;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_3_p4 = inverse_D3 * Lambda_inv_3_4_p57;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_3_p5 = inverse_D4 * Lambda_inv_3_4_p51;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_3_p6 = inverse_D5 * Lambda_inv_3_4_p45;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_3_p7 = inverse_D6 * Lambda_inv_3_4_p40;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_0_3_p8 = minus_inverse_D7 * Lambda_inv_3_4_p33;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_3_p9 = minus_inverse_D8 * Lambda_inv_3_4_p26;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_3_p10 = minus_inverse_D9 * Lambda_inv_3_4_p22;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_3_p11 = minus_inverse_D10 * Lambda_inv_3_4_p14;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_3_p12 = Lambda_inv_0_4_p114 * Lambda_inv_0_3_p11 + Lambda_inv_0_4_p120 *
      Lambda_inv_0_3_p10 + Lambda_inv_0_4_p124 * Lambda_inv_0_3_p9 + Lambda_inv_0_4_p127 *
      Lambda_inv_0_3_p8 - Lambda_inv_0_4_p138 * Lambda_inv_0_3_p7;
  const Real Lambda_inv_0_3_p13 = Lambda_inv_0_3_p12 - Lambda_inv_0_4_p143 * Lambda_inv_0_3_p6 -
      Lambda_inv_0_4_p149 * Lambda_inv_0_3_p5 - Lambda_inv_0_4_p155 * Lambda_inv_0_3_p4 -
      Lambda_inv_0_4_p159 * Lambda_inv_0_3_p3;
  const Real Lambda_inv_3_5_p1 = Lambda_inv_0_4_p110 * Lambda_inv_4_5_p78 - Lambda_inv_3_4_p3 *
      Lambda_inv_4_5_p77 - Lambda_inv_3_4_p10 * Lambda_inv_4_5_p76 - Lambda_inv_3_4_p14 *
      Lambda_inv_4_5_p75 - Lambda_inv_3_4_p22 * Lambda_inv_4_5_p74;
  const Real Lambda_inv_3_5_p2 = Lambda_inv_3_5_p1 - Lambda_inv_3_4_p26 * Lambda_inv_4_5_p73 -
      Lambda_inv_3_4_p33 * Lambda_inv_4_5_p72 + Lambda_inv_3_4_p40 * Lambda_inv_4_5_p71 +
      Lambda_inv_3_4_p45 * Lambda_inv_4_5_p70;
  const Real Lambda_inv_3_5 = Lambda_inv_3_5_p2 + Lambda_inv_3_4_p51 * Lambda_inv_4_5_p69 +
      Lambda_inv_3_4_p57 * Lambda_inv_4_5_p68 + Lambda_inv_3_4_p61 * Lambda_inv_4_5_p67 +
      Lambda_inv_3_4_p63 * Lambda_inv_4_5_p66;
  Lambda_inv[41] = Lambda_inv_3_5;
  Lambda_inv[63] = Lambda_inv_3_5;
  const Real Lambda_inv_0_3_p14 = Lambda_inv_3_5 * Lambda_inv_0_4_p193;
  const Real Lambda_inv_0_3 = Lambda_inv_0_3_p14 - (Lambda_inv_0_3_p1 -
      (Lambda_inv_0_3_p13 - Lambda_inv_0_4_p161 * Lambda_inv_0_3_p2));
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[36] = Lambda_inv_0_3;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_0_1_p1 = s13 * Lambda_inv_0_4_p16 - c13 * Lambda_inv_0_4_p19;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_0_1_p2 = s12 * Lambda_inv_0_1_p1 - c12 * Lambda_inv_0_4_p17;
  const Real Lambda_inv_0_1_p3 = 0.269 * Lambda_inv_0_1_p2;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_0_1_p4 = c13 * Lambda_inv_0_4_p16 + s13 * Lambda_inv_0_4_p19;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_0_1_p5 = 0.269 * Lambda_inv_0_1_p4;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_0_1_p6 = c11 * Lambda_inv_0_1_p3 - s11 * Lambda_inv_0_1_p5;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_1_p7 = inverse_D5_p228 * Lambda_inv_0_1_p6;
  const Real Lambda_inv_0_1_p8 = s11 * Lambda_inv_0_1_p3 + c11 * Lambda_inv_0_1_p5 +
      inverse_D5_p231 * Lambda_inv_0_1_p6;
  const Real Lambda_inv_0_1_p9 = c10 * Lambda_inv_0_1_p7 + s10 * Lambda_inv_0_1_p8;
  const Real Lambda_inv_0_1_p10 = c12 * Lambda_inv_0_1_p1 + s12 * Lambda_inv_0_4_p17 +
      inverse_D5_p273 * Lambda_inv_0_1_p6;
  const Real Lambda_inv_0_1_p11 = s11 * Lambda_inv_0_1_p4 - c11 * Lambda_inv_0_1_p2 +
      inverse_D5_p264 * Lambda_inv_0_1_p6;
  const Real Lambda_inv_0_1_p12 = s10 * Lambda_inv_0_1_p10 - c10 * Lambda_inv_0_1_p11;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_1_p13 = 0.282 * Lambda_inv_0_1_p12 + minus_inverse_D8_p1 *
      Lambda_inv_0_1_p9;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_1_p14 = c11 * Lambda_inv_0_1_p4 + s11 * Lambda_inv_0_1_p2 -
      inverse_D5_p246 * Lambda_inv_0_1_p6;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_1_p15 = 0.282 * Lambda_inv_0_1_p14 - s10 * Lambda_inv_0_1_p7 + c10 *
      Lambda_inv_0_1_p8 + minus_inverse_D8_p4 * Lambda_inv_0_1_p9;
  const Real Lambda_inv_0_1_p16 = s9 * Lambda_inv_0_1_p13 + c9 * Lambda_inv_0_1_p15;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_1_p17 = c9 * Lambda_inv_0_1_p13 - s9 * Lambda_inv_0_1_p15 +
      minus_inverse_D7_p1 * Lambda_inv_0_1_p16;
  const Real Lambda_inv_0_1_p18 = Lambda_inv_0_4_p46 * Lambda_inv_0_1_p16;
  const Real Lambda_inv_0_1_p19 = c8 * Lambda_inv_0_1_p17 + s8 * Lambda_inv_0_1_p18;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_1_p20 = Lambda_inv_0_1_p14 + inverse_D5_p253 * Lambda_inv_0_1_p9;
  const Real Lambda_inv_0_1_p21 = Lambda_inv_0_1_p12 + inverse_D5_p281 * Lambda_inv_0_1_p9;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_1_p22 = c9 * Lambda_inv_0_1_p20 + s9 * Lambda_inv_0_1_p21 -
      inverse_D5_p322 * Lambda_inv_0_1_p16;
  const Real Lambda_inv_0_1_p23 = c10 * Lambda_inv_0_1_p10 + s10 * Lambda_inv_0_1_p11 +
      inverse_D5_p313 * Lambda_inv_0_1_p9 + inverse_D5_p319 * Lambda_inv_0_1_p16;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_0_1_p24 = s8 * Lambda_inv_0_1_p22 + c8 * Lambda_inv_0_1_p23 -
      inverse_D5_p329 * Lambda_inv_0_1_p19;
  const Real Lambda_inv_0_1_p25 = s9 * Lambda_inv_0_1_p20 - c9 * Lambda_inv_0_1_p21 -
      inverse_D5_p303 * Lambda_inv_0_1_p16 + inverse_D5_p309 * Lambda_inv_0_1_p19;
  const Real Lambda_inv_0_1_p26 = c7 * Lambda_inv_0_1_p24 + s7 * Lambda_inv_0_1_p25;
  const Real Lambda_inv_0_1_p27 = c8 * Lambda_inv_0_1_p22 - s8 * Lambda_inv_0_1_p23 +
      inverse_D5_p359 * Lambda_inv_0_1_p19;
  const Real Lambda_inv_0_1_p28 = s8 * Lambda_inv_0_1_p17 - c8 * Lambda_inv_0_1_p18 -
      inverse_D5_p370 * Lambda_inv_0_1_p19;
  const Real Lambda_inv_0_1_p29 = Lambda_inv_0_4_p58 * Lambda_inv_0_1_p19;
  const Real Lambda_inv_0_1_p30 = 0.18 * Lambda_inv_0_1_p26 - 0.226 * Lambda_inv_0_1_p27 - s7 *
      Lambda_inv_0_1_p28 + c7 * Lambda_inv_0_1_p29;
  const Real Lambda_inv_0_1_p31 = s7 * Lambda_inv_0_1_p24 - c7 * Lambda_inv_0_1_p25;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_1_p32 = Lambda_inv_0_1_p31 + inverse_D5_p408 * Lambda_inv_0_1_p30;
  const Real Lambda_inv_0_1_p33 = 0.226 * Lambda_inv_0_1_p31 - inverse_D5_p383 * Lambda_inv_0_1_p30;
  const Real Lambda_inv_0_1_p34 = 0.18 * Lambda_inv_0_1_p31 + c7 * Lambda_inv_0_1_p28 + s7 *
      Lambda_inv_0_1_p29 - inverse_D5_p390 * Lambda_inv_0_1_p30;
  const Real Lambda_inv_0_1_p35 = 0.072 * Lambda_inv_0_1_p32 + c6 * Lambda_inv_0_1_p33 + s6 *
      Lambda_inv_0_1_p34;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_1_p36 = s6 * Lambda_inv_0_1_p33 - c6 * Lambda_inv_0_1_p34 -
      inverse_D1_p35 * Lambda_inv_0_1_p35;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_1_p37 = Lambda_inv_0_1_p27 - inverse_D1_p2 * Lambda_inv_0_1_p30;
  const Real Lambda_inv_0_1_p38 = Lambda_inv_0_1_p26 + inverse_D1_p11 * Lambda_inv_0_1_p30;
  const Real Lambda_inv_0_1_p39 = c6 * Lambda_inv_0_1_p37 - s6 * Lambda_inv_0_1_p38;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_1_p40 = 0.072 * Lambda_inv_0_1_p39 - inverse_D1_p25 * Lambda_inv_0_1_p35;
  const Real Lambda_inv_0_1_p41 = c5 * Lambda_inv_0_1_p36 + s5 * Lambda_inv_0_1_p40;
  const Real Lambda_inv_0_1_p42 = s6 * Lambda_inv_0_1_p37 + c6 * Lambda_inv_0_1_p38 -
      inverse_D1_p58 * Lambda_inv_0_1_p35;
  const Real Lambda_inv_0_1_p43 = Lambda_inv_0_1_p32 - inverse_D1_p54 * Lambda_inv_0_1_p35;
  const Real Lambda_inv_0_1_p44 = s5 * Lambda_inv_0_1_p42 + c5 * Lambda_inv_0_1_p43;
  const Real Lambda_inv_0_1_p45 = Lambda_inv_0_1_p39 - inverse_D1_p42 * Lambda_inv_0_1_p35;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_1_p46 = s4 * (0.21799999999999997 * Lambda_inv_0_1_p45 - s5 *
      Lambda_inv_0_1_p36 + c5 * Lambda_inv_0_1_p40 + inverse_D3_p3 * Lambda_inv_0_1_p41);
  const Real Lambda_inv_0_1_p47 = c4 * (0.21799999999999997 * Lambda_inv_0_1_p44 + inverse_D3_p1 *
      Lambda_inv_0_1_p41) - Lambda_inv_0_1_p46;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_1_p48 = c5 * Lambda_inv_0_1_p42 - s5 * Lambda_inv_0_1_p43 -
      inverse_D1_p83 * Lambda_inv_0_1_p41 - inverse_D1_p87 * Lambda_inv_0_1_p47;
  const Real Lambda_inv_0_1_p49 = s4 * (Lambda_inv_0_1_p45 + inverse_D1_p48 * Lambda_inv_0_1_p41) -
      c4 * (Lambda_inv_0_1_p44 + inverse_D1_p67 * Lambda_inv_0_1_p41) + inverse_D1_p89 *
      Lambda_inv_0_1_p47;
  const Real Lambda_inv_0_1_p50 = s3 * Lambda_inv_0_1_p48 - c3 * Lambda_inv_0_1_p49;
  const Real Lambda_inv_0_1_p51 = 0.422 * Lambda_inv_0_1_p50;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_1_p52 = s2 * (c3 * Lambda_inv_0_1_p48 + s3 * Lambda_inv_0_1_p49 +
      inverse_D1_p102 * Lambda_inv_0_1_p51) + c2 * (Lambda_inv_0_1_p50 - inverse_D1_p98 *
      Lambda_inv_0_1_p51);
  const Real Lambda_inv_0_1_p53 = 0.434 * Lambda_inv_0_1_p52;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_1_p54 = Lambda_inv_0_1_p6 * Lambda_inv_0_4_p170 + Lambda_inv_0_1_p9 *
      Lambda_inv_0_4_p169 + Lambda_inv_0_1_p16 * Lambda_inv_0_4_p168 + Lambda_inv_0_1_p19 *
      Lambda_inv_0_4_p167 - Lambda_inv_0_1_p30 * Lambda_inv_0_4_p166;
  const Real Lambda_inv_0_1_p55 = Lambda_inv_0_1_p54 - Lambda_inv_0_1_p35 * Lambda_inv_0_4_p165 -
      Lambda_inv_0_1_p41 * Lambda_inv_0_4_p164 - Lambda_inv_0_1_p47 * Lambda_inv_0_4_p163 -
      Lambda_inv_0_1_p51 * Lambda_inv_0_4_p162;
  const Real Lambda_inv_0_1_p56 = Lambda_inv_0_1_p55 - Lambda_inv_0_1_p53 * Lambda_inv_0_4_p84;
  const Real Lambda_inv_0_1_p57 = 0.086 * Lambda_inv_0_4_p107;
  const Real Lambda_inv_0_1_p58 = inverse_D1 * Lambda_inv_0_1_p53;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_1_p59 = inverse_D2 * Lambda_inv_0_1_p51;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_1_p60 = inverse_D3 * Lambda_inv_0_1_p47;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_1_p61 = inverse_D4 * Lambda_inv_0_1_p41;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_1_p62 = inverse_D5 * Lambda_inv_0_1_p35;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_1_p63 = inverse_D6 * Lambda_inv_0_1_p30;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_0_1_p64 = minus_inverse_D7 * Lambda_inv_0_1_p19;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_1_p65 = minus_inverse_D8 * Lambda_inv_0_1_p16;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_1_p66 = minus_inverse_D9 * Lambda_inv_0_1_p9;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_1_p67 = minus_inverse_D10 * Lambda_inv_0_1_p6;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_1_p68 = Lambda_inv_0_4_p114 * Lambda_inv_0_1_p67 + Lambda_inv_0_4_p120 *
      Lambda_inv_0_1_p66 + Lambda_inv_0_4_p124 * Lambda_inv_0_1_p65 + Lambda_inv_0_4_p127 *
      Lambda_inv_0_1_p64 - Lambda_inv_0_4_p138 * Lambda_inv_0_1_p63;
  const Real Lambda_inv_0_1_p69 = Lambda_inv_0_1_p68 - Lambda_inv_0_4_p143 * Lambda_inv_0_1_p62 -
      Lambda_inv_0_4_p149 * Lambda_inv_0_1_p61 - Lambda_inv_0_4_p155 * Lambda_inv_0_1_p60 -
      Lambda_inv_0_4_p159 * Lambda_inv_0_1_p59;
  const Real Lambda_inv_0_1_p70 = Lambda_inv_0_1_p6 * Lambda_inv_4_5_p75 + Lambda_inv_0_1_p9 *
      Lambda_inv_4_5_p74 + Lambda_inv_0_1_p16 * Lambda_inv_4_5_p73 + Lambda_inv_0_1_p19 *
      Lambda_inv_4_5_p72 - Lambda_inv_0_1_p30 * Lambda_inv_4_5_p71;
  const Real Lambda_inv_0_1_p71 = Lambda_inv_0_1_p70 - Lambda_inv_0_1_p35 * Lambda_inv_4_5_p70 -
      Lambda_inv_0_1_p41 * Lambda_inv_4_5_p69 - Lambda_inv_0_1_p47 * Lambda_inv_4_5_p68 -
      Lambda_inv_0_1_p51 * Lambda_inv_4_5_p67;
  const Real Lambda_inv_0_1_p72 = Lambda_inv_0_1_p71 - Lambda_inv_0_1_p53 * Lambda_inv_4_5_p66;
  const Real Lambda_inv_0_1 = Lambda_inv_0_4_p192 * (Lambda_inv_0_1_p56 + Lambda_inv_0_3) +
      (Lambda_inv_0_1_p69 - Lambda_inv_0_4_p161 * Lambda_inv_0_1_p58 + Lambda_inv_0_1_p57 *
      Lambda_inv_0_5 - Lambda_inv_0_1_p72 * Lambda_inv_0_4_p193);
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[12] = Lambda_inv_0_1;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_0_2_p1 = c13 * Lambda_inv_4_5_p1 + s13 * Lambda_inv_0_4_p191;
  const Real Lambda_inv_0_2_p2 = s13 * Lambda_inv_4_5_p1 - c13 * Lambda_inv_0_4_p191;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_inv_0_2_p3 = s12 * Lambda_inv_0_2_p2 - c12 * Lambda_inv_4_5_p2;
  const Real Lambda_inv_0_2_p4 = 0.269 * Lambda_inv_0_2_p3;
  const Real Lambda_inv_0_2_p5 = 0.269 * Lambda_inv_0_2_p1;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_0_2_p6 = c11 * Lambda_inv_0_2_p4 - s11 * Lambda_inv_0_2_p5;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_2_p7 = s11 * Lambda_inv_0_2_p1 - c11 * Lambda_inv_0_2_p3 +
      inverse_D5_p264 * Lambda_inv_0_2_p6;
  const Real Lambda_inv_0_2_p8 = c12 * Lambda_inv_0_2_p2 + s12 * Lambda_inv_4_5_p2 +
      inverse_D5_p273 * Lambda_inv_0_2_p6;
  const Real Lambda_inv_0_2_p9 = s10 * Lambda_inv_0_2_p8 - c10 * Lambda_inv_0_2_p7;
  const Real Lambda_inv_0_2_p10 = s11 * Lambda_inv_0_2_p4 + c11 * Lambda_inv_0_2_p5 +
      inverse_D5_p231 * Lambda_inv_0_2_p6;
  const Real Lambda_inv_0_2_p11 = inverse_D5_p228 * Lambda_inv_0_2_p6;
  const Real Lambda_inv_0_2_p12 = c10 * Lambda_inv_0_2_p11 + s10 * Lambda_inv_0_2_p10;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_2_p13 = 0.282 * Lambda_inv_0_2_p9 + minus_inverse_D8_p1 *
      Lambda_inv_0_2_p12;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_2_p14 = c11 * Lambda_inv_0_2_p1 + s11 * Lambda_inv_0_2_p3 -
      inverse_D5_p246 * Lambda_inv_0_2_p6;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_2_p15 = 0.282 * Lambda_inv_0_2_p14 - s10 * Lambda_inv_0_2_p11 + c10 *
      Lambda_inv_0_2_p10 + minus_inverse_D8_p4 * Lambda_inv_0_2_p12;
  const Real Lambda_inv_0_2_p16 = s9 * Lambda_inv_0_2_p13 + c9 * Lambda_inv_0_2_p15;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_2_p17 = c9 * Lambda_inv_0_2_p13 - s9 * Lambda_inv_0_2_p15 +
      minus_inverse_D7_p1 * Lambda_inv_0_2_p16;
  const Real Lambda_inv_0_2_p18 = Lambda_inv_0_4_p46 * Lambda_inv_0_2_p16;
  const Real Lambda_inv_0_2_p19 = c8 * Lambda_inv_0_2_p17 + s8 * Lambda_inv_0_2_p18;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_2_p20 = Lambda_inv_0_2_p14 + inverse_D5_p253 * Lambda_inv_0_2_p12;
  const Real Lambda_inv_0_2_p21 = Lambda_inv_0_2_p9 + inverse_D5_p281 * Lambda_inv_0_2_p12;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_2_p22 = c9 * Lambda_inv_0_2_p20 + s9 * Lambda_inv_0_2_p21 -
      inverse_D5_p322 * Lambda_inv_0_2_p16;
  const Real Lambda_inv_0_2_p23 = c10 * Lambda_inv_0_2_p8 + s10 * Lambda_inv_0_2_p7 +
      inverse_D5_p313 * Lambda_inv_0_2_p12 + inverse_D5_p319 * Lambda_inv_0_2_p16;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_0_2_p24 = s8 * Lambda_inv_0_2_p22 + c8 * Lambda_inv_0_2_p23 -
      inverse_D5_p329 * Lambda_inv_0_2_p19;
  const Real Lambda_inv_0_2_p25 = s9 * Lambda_inv_0_2_p20 - c9 * Lambda_inv_0_2_p21 -
      inverse_D5_p303 * Lambda_inv_0_2_p16 + inverse_D5_p309 * Lambda_inv_0_2_p19;
  const Real Lambda_inv_0_2_p26 = c7 * Lambda_inv_0_2_p24 + s7 * Lambda_inv_0_2_p25;
  const Real Lambda_inv_0_2_p27 = c8 * Lambda_inv_0_2_p22 - s8 * Lambda_inv_0_2_p23 +
      inverse_D5_p359 * Lambda_inv_0_2_p19;
  const Real Lambda_inv_0_2_p28 = s8 * Lambda_inv_0_2_p17 - c8 * Lambda_inv_0_2_p18 -
      inverse_D5_p370 * Lambda_inv_0_2_p19;
  const Real Lambda_inv_0_2_p29 = Lambda_inv_0_4_p58 * Lambda_inv_0_2_p19;
  const Real Lambda_inv_0_2_p30 = 0.18 * Lambda_inv_0_2_p26 - 0.226 * Lambda_inv_0_2_p27 - s7 *
      Lambda_inv_0_2_p28 + c7 * Lambda_inv_0_2_p29;
  const Real Lambda_inv_0_2_p31 = s7 * Lambda_inv_0_2_p24 - c7 * Lambda_inv_0_2_p25;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_2_p32 = Lambda_inv_0_2_p31 + inverse_D5_p408 * Lambda_inv_0_2_p30;
  const Real Lambda_inv_0_2_p33 = 0.226 * Lambda_inv_0_2_p31 - inverse_D5_p383 * Lambda_inv_0_2_p30;
  const Real Lambda_inv_0_2_p34 = 0.18 * Lambda_inv_0_2_p31 + c7 * Lambda_inv_0_2_p28 + s7 *
      Lambda_inv_0_2_p29 - inverse_D5_p390 * Lambda_inv_0_2_p30;
  const Real Lambda_inv_0_2_p35 = 0.072 * Lambda_inv_0_2_p32 + c6 * Lambda_inv_0_2_p33 + s6 *
      Lambda_inv_0_2_p34;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_2_p36 = s6 * Lambda_inv_0_2_p33 - c6 * Lambda_inv_0_2_p34 -
      inverse_D1_p35 * Lambda_inv_0_2_p35;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_2_p37 = Lambda_inv_0_2_p27 - inverse_D1_p2 * Lambda_inv_0_2_p30;
  const Real Lambda_inv_0_2_p38 = Lambda_inv_0_2_p26 + inverse_D1_p11 * Lambda_inv_0_2_p30;
  const Real Lambda_inv_0_2_p39 = c6 * Lambda_inv_0_2_p37 - s6 * Lambda_inv_0_2_p38;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_2_p40 = 0.072 * Lambda_inv_0_2_p39 - inverse_D1_p25 * Lambda_inv_0_2_p35;
  const Real Lambda_inv_0_2_p41 = c5 * Lambda_inv_0_2_p36 + s5 * Lambda_inv_0_2_p40;
  const Real Lambda_inv_0_2_p42 = s6 * Lambda_inv_0_2_p37 + c6 * Lambda_inv_0_2_p38 -
      inverse_D1_p58 * Lambda_inv_0_2_p35;
  const Real Lambda_inv_0_2_p43 = Lambda_inv_0_2_p32 - inverse_D1_p54 * Lambda_inv_0_2_p35;
  const Real Lambda_inv_0_2_p44 = s5 * Lambda_inv_0_2_p42 + c5 * Lambda_inv_0_2_p43;
  const Real Lambda_inv_0_2_p45 = Lambda_inv_0_2_p39 - inverse_D1_p42 * Lambda_inv_0_2_p35;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_2_p46 = s4 * (0.21799999999999997 * Lambda_inv_0_2_p45 - s5 *
      Lambda_inv_0_2_p36 + c5 * Lambda_inv_0_2_p40 + inverse_D3_p3 * Lambda_inv_0_2_p41);
  const Real Lambda_inv_0_2_p47 = c4 * (0.21799999999999997 * Lambda_inv_0_2_p44 + inverse_D3_p1 *
      Lambda_inv_0_2_p41) - Lambda_inv_0_2_p46;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_2_p48 = c5 * Lambda_inv_0_2_p42 - s5 * Lambda_inv_0_2_p43 -
      inverse_D1_p83 * Lambda_inv_0_2_p41 - inverse_D1_p87 * Lambda_inv_0_2_p47;
  const Real Lambda_inv_0_2_p49 = s4 * (Lambda_inv_0_2_p45 + inverse_D1_p48 * Lambda_inv_0_2_p41) -
      c4 * (Lambda_inv_0_2_p44 + inverse_D1_p67 * Lambda_inv_0_2_p41) + inverse_D1_p89 *
      Lambda_inv_0_2_p47;
  const Real Lambda_inv_0_2_p50 = s3 * Lambda_inv_0_2_p48 - c3 * Lambda_inv_0_2_p49;
  const Real Lambda_inv_0_2_p51 = 0.422 * Lambda_inv_0_2_p50;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_2_p52 = s2 * (c3 * Lambda_inv_0_2_p48 + s3 * Lambda_inv_0_2_p49 +
      inverse_D1_p102 * Lambda_inv_0_2_p51) + c2 * (Lambda_inv_0_2_p50 - inverse_D1_p98 *
      Lambda_inv_0_2_p51);
  const Real Lambda_inv_0_2_p53 = 0.434 * Lambda_inv_0_2_p52;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_2_p54 = Lambda_inv_0_2_p6 * Lambda_inv_4_5_p75 + Lambda_inv_0_2_p12 *
      Lambda_inv_4_5_p74 + Lambda_inv_0_2_p16 * Lambda_inv_4_5_p73 + Lambda_inv_0_2_p19 *
      Lambda_inv_4_5_p72 - Lambda_inv_0_2_p30 * Lambda_inv_4_5_p71;
  const Real Lambda_inv_0_2_p55 = Lambda_inv_0_2_p54 - Lambda_inv_0_2_p35 * Lambda_inv_4_5_p70 -
      Lambda_inv_0_2_p41 * Lambda_inv_4_5_p69 - Lambda_inv_0_2_p47 * Lambda_inv_4_5_p68 -
      Lambda_inv_0_2_p51 * Lambda_inv_4_5_p67;
  const Real Lambda_inv_0_2_p56 = Lambda_inv_0_2_p55 - Lambda_inv_0_2_p53 * Lambda_inv_4_5_p66;
  const Real Lambda_inv_0_2_p57 = inverse_D1 * Lambda_inv_0_2_p53;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_2_p58 = inverse_D2 * Lambda_inv_0_2_p51;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_2_p59 = inverse_D3 * Lambda_inv_0_2_p47;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_2_p60 = inverse_D4 * Lambda_inv_0_2_p41;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_2_p61 = inverse_D5 * Lambda_inv_0_2_p35;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_2_p62 = inverse_D6 * Lambda_inv_0_2_p30;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_inv_0_2_p63 = minus_inverse_D7 * Lambda_inv_0_2_p19;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_inv_0_2_p64 = minus_inverse_D8 * Lambda_inv_0_2_p16;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_2_p65 = minus_inverse_D9 * Lambda_inv_0_2_p12;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_inv_0_2_p66 = minus_inverse_D10 * Lambda_inv_0_2_p6;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_2_p67 = Lambda_inv_0_4_p114 * Lambda_inv_0_2_p66 + Lambda_inv_0_4_p120 *
      Lambda_inv_0_2_p65 + Lambda_inv_0_4_p124 * Lambda_inv_0_2_p64 + Lambda_inv_0_4_p127 *
      Lambda_inv_0_2_p63 - Lambda_inv_0_4_p138 * Lambda_inv_0_2_p62;
  const Real Lambda_inv_0_2_p68 = Lambda_inv_0_2_p67 - Lambda_inv_0_4_p143 * Lambda_inv_0_2_p61 -
      Lambda_inv_0_4_p149 * Lambda_inv_0_2_p60 - Lambda_inv_0_4_p155 * Lambda_inv_0_2_p59 -
      Lambda_inv_0_4_p159 * Lambda_inv_0_2_p58;
  const Real Lambda_inv_0_2_p69 = Lambda_inv_0_2_p6 * Lambda_inv_0_4_p170 + Lambda_inv_0_2_p12 *
      Lambda_inv_0_4_p169 + Lambda_inv_0_2_p16 * Lambda_inv_0_4_p168 + Lambda_inv_0_2_p19 *
      Lambda_inv_0_4_p167 - Lambda_inv_0_2_p30 * Lambda_inv_0_4_p166;
  const Real Lambda_inv_0_2_p70 = Lambda_inv_0_2_p69 - Lambda_inv_0_2_p35 * Lambda_inv_0_4_p165 -
      Lambda_inv_0_2_p41 * Lambda_inv_0_4_p164 - Lambda_inv_0_2_p47 * Lambda_inv_0_4_p163 -
      Lambda_inv_0_2_p51 * Lambda_inv_0_4_p162;
  const Real Lambda_inv_0_2_p71 = Lambda_inv_0_2_p70 - Lambda_inv_0_2_p53 * Lambda_inv_0_4_p84;
  const Real Lambda_inv_0_2 = Lambda_inv_0_4_p193 * (Lambda_inv_0_2_p56 + Lambda_inv_0_3) -
      (Lambda_inv_0_2_p68 - Lambda_inv_0_4_p161 * Lambda_inv_0_2_p57 - Lambda_inv_0_1_p57 *
      Lambda_inv_0_4 + Lambda_inv_0_2_p71 * Lambda_inv_0_4_p192);
  Lambda_inv[2] = -Lambda_inv_0_2;
  Lambda_inv[24] = -Lambda_inv_0_2;

  // link 14 (right_shoulder1), pose
  const Real Lambda_inv_0_6_p1 = c14 * Lambda_inv_0_4_p90 - s14 * Lambda_inv_0_4_p93;
  const Real Lambda_inv_0_6_p2 = s14 * Lambda_inv_0_4_p90 + c14 * Lambda_inv_0_4_p93;

  // link 15 (right_shoulder2), pose
  const Real Lambda_inv_0_6_p3 = c15 * Lambda_inv_0_4_p96 - s15 * Lambda_inv_0_6_p2;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_6_p4 = s16 * Lambda_inv_0_6_p1 + c16 * Lambda_inv_0_6_p3;
  const Real Lambda_inv_0_6_p5 = c16 * Lambda_inv_0_6_p1 - s16 * Lambda_inv_0_6_p3;

  // link 15 (right_shoulder2), pose
  const Real Lambda_inv_0_6_p6 = s15 * Lambda_inv_0_4_p96 + c15 * Lambda_inv_0_6_p2;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_6_p7 = s17 * Lambda_inv_0_6_p6 - c17 * Lambda_inv_0_6_p5;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_6_p8 = c18 * Lambda_inv_0_6_p4 - s18 * Lambda_inv_0_6_p7;
  const Real Lambda_inv_0_6_p9 = s18 * Lambda_inv_0_6_p4 + c18 * Lambda_inv_0_6_p7;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_6_p10 = c17 * Lambda_inv_0_6_p6 + s17 * Lambda_inv_0_6_p5;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_6_p11 = c19 * Lambda_inv_0_6_p10 - s19 * Lambda_inv_0_6_p9;

  // link 20 (right_hand), pose
  const Real Lambda_inv_0_6_p12 = c20 * Lambda_inv_0_6_p8 - s20 * Lambda_inv_0_6_p11;
  const Real Lambda_inv_0_6_p13 = s20 * Lambda_inv_0_6_p8 + c20 * Lambda_inv_0_6_p11;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p14 = c20 * Lambda_inv_0_6_p12 + s20 * Lambda_inv_0_6_p13;
  const Real Lambda_inv_0_6_p15 = s20 * Lambda_inv_0_6_p12 - c20 * Lambda_inv_0_6_p13;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_6_p16 = s19 * Lambda_inv_0_6_p10 + c19 * Lambda_inv_0_6_p9;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p17 = s19 * Lambda_inv_0_6_p15 + c19 * Lambda_inv_0_6_p16;
  const Real Lambda_inv_0_6_p18 = 0.269 * Lambda_inv_0_6_p17;
  const Real Lambda_inv_0_6_p19 = 0.269 * Lambda_inv_0_6_p14;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p20 = c18 * Lambda_inv_0_6_p18 - s18 * Lambda_inv_0_6_p19;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p21 = s18 * Lambda_inv_0_6_p14 - c18 * Lambda_inv_0_6_p17 +
      inverse_D5_p82 * Lambda_inv_0_6_p20;
  const Real Lambda_inv_0_6_p22 = c19 * Lambda_inv_0_6_p15 - s19 * Lambda_inv_0_6_p16 -
      inverse_D5_p91 * Lambda_inv_0_6_p20;
  const Real Lambda_inv_0_6_p23 = s17 * Lambda_inv_0_6_p22 - c17 * Lambda_inv_0_6_p21;
  const Real Lambda_inv_0_6_p24 = s18 * Lambda_inv_0_6_p18 + c18 * Lambda_inv_0_6_p19 +
      inverse_D5_p49 * Lambda_inv_0_6_p20;
  const Real Lambda_inv_0_6_p25 = inverse_D5_p46 * Lambda_inv_0_6_p20;
  const Real Lambda_inv_0_6_p26 = c17 * Lambda_inv_0_6_p25 + s17 * Lambda_inv_0_6_p24;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p27 = 0.282 * Lambda_inv_0_6_p23 - inverse_D15_p1 * Lambda_inv_0_6_p26;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p28 = c18 * Lambda_inv_0_6_p14 + s18 * Lambda_inv_0_6_p17 -
      inverse_D5_p64 * Lambda_inv_0_6_p20;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p29 = 0.282 * Lambda_inv_0_6_p28 - s17 * Lambda_inv_0_6_p25 + c17 *
      Lambda_inv_0_6_p24 + inverse_D15_p4 * Lambda_inv_0_6_p26;
  const Real Lambda_inv_0_6_p30 = s16 * Lambda_inv_0_6_p27 + c16 * Lambda_inv_0_6_p29;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p31 = c16 * Lambda_inv_0_6_p27 - s16 * Lambda_inv_0_6_p29 +
      inverse_D14_p1 * Lambda_inv_0_6_p30;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_inv_0_6_p32 = 0.00010499999999999999 / inverse_D15_p9;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p33 = Lambda_inv_0_6_p32 * Lambda_inv_0_6_p30;
  const Real Lambda_inv_0_6_p34 = c15 * Lambda_inv_0_6_p31 - s15 * Lambda_inv_0_6_p33;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p35 = Lambda_inv_0_6_p28 + inverse_D5_p71 * Lambda_inv_0_6_p26;
  const Real Lambda_inv_0_6_p36 = Lambda_inv_0_6_p23 - inverse_D5_p99 * Lambda_inv_0_6_p26;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p37 = c16 * Lambda_inv_0_6_p35 + s16 * Lambda_inv_0_6_p36 -
      inverse_D5_p140 * Lambda_inv_0_6_p30;
  const Real Lambda_inv_0_6_p38 = c17 * Lambda_inv_0_6_p22 + s17 * Lambda_inv_0_6_p21 +
      inverse_D5_p131 * Lambda_inv_0_6_p26 + inverse_D5_p137 * Lambda_inv_0_6_p30;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_0_6_p39 = s15 * Lambda_inv_0_6_p37 + c15 * Lambda_inv_0_6_p38 +
      inverse_D5_p147 * Lambda_inv_0_6_p34;
  const Real Lambda_inv_0_6_p40 = s16 * Lambda_inv_0_6_p35 - c16 * Lambda_inv_0_6_p36 -
      inverse_D5_p121 * Lambda_inv_0_6_p30 - inverse_D5_p127 * Lambda_inv_0_6_p34;
  const Real Lambda_inv_0_6_p41 = c14 * Lambda_inv_0_6_p39 + s14 * Lambda_inv_0_6_p40;
  const Real Lambda_inv_0_6_p42 = c15 * Lambda_inv_0_6_p37 - s15 * Lambda_inv_0_6_p38 +
      inverse_D5_p177 * Lambda_inv_0_6_p34;
  const Real Lambda_inv_0_6_p43 = s15 * Lambda_inv_0_6_p31 + c15 * Lambda_inv_0_6_p33 -
      inverse_D5_p365 * Lambda_inv_0_6_p34;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_inv_0_6_p44 = 2.6249999999999998e-05 / inverse_D14_p8;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_0_6_p45 = Lambda_inv_0_6_p44 * Lambda_inv_0_6_p34;
  const Real Lambda_inv_0_6_p46 = 0.18 * Lambda_inv_0_6_p41 + 0.226 * Lambda_inv_0_6_p42 + s14 *
      Lambda_inv_0_6_p43 - c14 * Lambda_inv_0_6_p45;
  const Real Lambda_inv_0_6_p47 = s14 * Lambda_inv_0_6_p39 - c14 * Lambda_inv_0_6_p40;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_6_p48 = Lambda_inv_0_6_p47 - inverse_D5_p408 * Lambda_inv_0_6_p46;
  const Real Lambda_inv_0_6_p49 = 0.226 * Lambda_inv_0_6_p47 + inverse_D5_p383 * Lambda_inv_0_6_p46;
  const Real Lambda_inv_0_6_p50 = 0.18 * Lambda_inv_0_6_p47 - c14 * Lambda_inv_0_6_p43 - s14 *
      Lambda_inv_0_6_p45 - inverse_D5_p390 * Lambda_inv_0_6_p46;
  const Real Lambda_inv_0_6_p51 = 0.072 * Lambda_inv_0_6_p48 + c6 * Lambda_inv_0_6_p49 - s6 *
      Lambda_inv_0_6_p50;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_6_p52 = s6 * Lambda_inv_0_6_p49 + c6 * Lambda_inv_0_6_p50 -
      inverse_D1_p35 * Lambda_inv_0_6_p51;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_6_p53 = Lambda_inv_0_6_p42 + inverse_D1_p2 * Lambda_inv_0_6_p46;
  const Real Lambda_inv_0_6_p54 = Lambda_inv_0_6_p41 - inverse_D1_p11 * Lambda_inv_0_6_p46;
  const Real Lambda_inv_0_6_p55 = c6 * Lambda_inv_0_6_p53 - s6 * Lambda_inv_0_6_p54;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_6_p56 = 0.072 * Lambda_inv_0_6_p55 - inverse_D1_p25 * Lambda_inv_0_6_p51;
  const Real Lambda_inv_0_6_p57 = c5 * Lambda_inv_0_6_p52 + s5 * Lambda_inv_0_6_p56;
  const Real Lambda_inv_0_6_p58 = s6 * Lambda_inv_0_6_p53 + c6 * Lambda_inv_0_6_p54 -
      inverse_D1_p58 * Lambda_inv_0_6_p51;
  const Real Lambda_inv_0_6_p59 = Lambda_inv_0_6_p48 - inverse_D1_p54 * Lambda_inv_0_6_p51;
  const Real Lambda_inv_0_6_p60 = s5 * Lambda_inv_0_6_p58 + c5 * Lambda_inv_0_6_p59;
  const Real Lambda_inv_0_6_p61 = Lambda_inv_0_6_p55 - inverse_D1_p42 * Lambda_inv_0_6_p51;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_6_p62 = s4 * (0.21799999999999997 * Lambda_inv_0_6_p61 - s5 *
      Lambda_inv_0_6_p52 + c5 * Lambda_inv_0_6_p56 + inverse_D3_p3 * Lambda_inv_0_6_p57);
  const Real Lambda_inv_0_6_p63 = c4 * (0.21799999999999997 * Lambda_inv_0_6_p60 + inverse_D3_p1 *
      Lambda_inv_0_6_p57) - Lambda_inv_0_6_p62;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_6_p64 = c5 * Lambda_inv_0_6_p58 - s5 * Lambda_inv_0_6_p59 -
      inverse_D1_p83 * Lambda_inv_0_6_p57 - inverse_D1_p87 * Lambda_inv_0_6_p63;
  const Real Lambda_inv_0_6_p65 = s4 * (Lambda_inv_0_6_p61 + inverse_D1_p48 * Lambda_inv_0_6_p57) -
      c4 * (Lambda_inv_0_6_p60 + inverse_D1_p67 * Lambda_inv_0_6_p57) + inverse_D1_p89 *
      Lambda_inv_0_6_p63;
  const Real Lambda_inv_0_6_p66 = s3 * Lambda_inv_0_6_p64 - c3 * Lambda_inv_0_6_p65;
  const Real Lambda_inv_0_6_p67 = 0.422 * Lambda_inv_0_6_p66;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_6_p68 = s2 * (c3 * Lambda_inv_0_6_p64 + s3 * Lambda_inv_0_6_p65 +
      inverse_D1_p102 * Lambda_inv_0_6_p67) + c2 * (Lambda_inv_0_6_p66 - inverse_D1_p98 *
      Lambda_inv_0_6_p67);
  const Real Lambda_inv_0_6_p69 = 0.434 * Lambda_inv_0_6_p68;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_6_p70 = inverse_D1 * Lambda_inv_0_6_p69;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_6_p71 = inverse_D2 * Lambda_inv_0_6_p67;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_6_p72 = inverse_D3 * Lambda_inv_0_6_p63;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_6_p73 = inverse_D4 * Lambda_inv_0_6_p57;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_6_p74 = inverse_D5 * Lambda_inv_0_6_p51;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_6_p75 = inverse_D6 * Lambda_inv_0_6_p46;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_6_p76 = Lambda_inv_0_4_p138 * Lambda_inv_0_6_p75 - Lambda_inv_0_4_p143 *
      Lambda_inv_0_6_p74 - Lambda_inv_0_4_p149 * Lambda_inv_0_6_p73 - Lambda_inv_0_4_p155 *
      Lambda_inv_0_6_p72 - Lambda_inv_0_4_p159 * Lambda_inv_0_6_p71;

  // link 14 (right_shoulder1), pose
  const Real Lambda_inv_0_6_p77 = s14 * Lambda_inv_0_4_p4 - c14 * Lambda_inv_0_4_p3;

  // link 15 (right_shoulder2), pose
  const Real Lambda_inv_0_6_p78 = s15 * Lambda_inv_0_4_p2 - c15 * Lambda_inv_0_6_p77;
  const Real Lambda_inv_0_6_p79 = c15 * Lambda_inv_0_4_p2 + s15 * Lambda_inv_0_6_p77;

  // link 14 (right_shoulder1), pose
  const Real Lambda_inv_0_6_p80 = c14 * Lambda_inv_0_4_p4 + s14 * Lambda_inv_0_4_p3;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_6_p81 = c16 * Lambda_inv_0_6_p80 + s16 * Lambda_inv_0_6_p79;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_6_p82 = c17 * Lambda_inv_0_6_p78 - s17 * Lambda_inv_0_6_p81;
  const Real Lambda_inv_0_6_p83 = s17 * Lambda_inv_0_6_p78 + c17 * Lambda_inv_0_6_p81;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_6_p84 = s16 * Lambda_inv_0_6_p80 - c16 * Lambda_inv_0_6_p79;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_6_p85 = s18 * Lambda_inv_0_6_p84 - c18 * Lambda_inv_0_6_p83;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_6_p86 = c19 * Lambda_inv_0_6_p82 + s19 * Lambda_inv_0_6_p85;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_6_p87 = c18 * Lambda_inv_0_6_p84 + s18 * Lambda_inv_0_6_p83;

  // link 20 (right_hand), pose
  const Real Lambda_inv_0_6_p88 = c20 * Lambda_inv_0_6_p87 + s20 * Lambda_inv_0_6_p86;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_6_p89 = s19 * Lambda_inv_0_6_p82 - c19 * Lambda_inv_0_6_p85;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p90 = Lambda_inv_0_6_p88 - 0.04672761636452121 * Lambda_inv_0_6_p89;

  // link 20 (right_hand), pose
  const Real Lambda_inv_0_6_p91 = s20 * Lambda_inv_0_6_p87 - c20 * Lambda_inv_0_6_p86;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p92 = Lambda_inv_0_6_p91 - 0.11533812622014242 * Lambda_inv_0_6_p89;
  const Real Lambda_inv_0_6_p93 = c20 * Lambda_inv_0_6_p90 + s20 * Lambda_inv_0_6_p92;
  const Real Lambda_inv_0_6_p94 = 17.32841575379867 * Lambda_inv_0_6_p89;
  const Real Lambda_inv_0_6_p95 = 3.0523172236718206 * Lambda_inv_0_6_p89;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p96 = s20 * Lambda_inv_0_6_p94 + c20 * Lambda_inv_0_6_p95 -
      inverse_D5_p8 * Lambda_inv_0_6_p93;
  const Real Lambda_inv_0_6_p97 = inverse_D5_p2 * Lambda_inv_0_6_p93;
  const Real Lambda_inv_0_6_p98 = s19 * Lambda_inv_0_6_p96 - c19 * Lambda_inv_0_6_p97;
  const Real Lambda_inv_0_6_p99 = s20 * Lambda_inv_0_6_p90 - c20 * Lambda_inv_0_6_p92 -
      inverse_D18_p1 * Lambda_inv_0_6_p93;
  const Real Lambda_inv_0_6_p100 = c19 * Lambda_inv_0_6_p99;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p101 = 0.269 * Lambda_inv_0_6_p98 - inverse_D5_p23 *
      Lambda_inv_0_6_p100;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p102 = c20 * Lambda_inv_0_6_p94 - s20 * Lambda_inv_0_6_p95 +
      inverse_D5_p14 * Lambda_inv_0_6_p93;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p103 = 0.269 * Lambda_inv_0_6_p102 + s19 * Lambda_inv_0_6_p99 -
      inverse_D5_p29 * Lambda_inv_0_6_p100;
  const Real Lambda_inv_0_6_p104 = c18 * Lambda_inv_0_6_p101 - s18 * Lambda_inv_0_6_p103;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p105 = c19 * Lambda_inv_0_6_p96 + s19 * Lambda_inv_0_6_p97 +
      inverse_D5_p86 * Lambda_inv_0_6_p100 - inverse_D5_p91 * Lambda_inv_0_6_p104;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p106 = Lambda_inv_0_6_p98 - inverse_D5_p54 * Lambda_inv_0_6_p100;
  const Real Lambda_inv_0_6_p107 = Lambda_inv_0_6_p102 - inverse_D5_p57 * Lambda_inv_0_6_p100;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p108 = s18 * Lambda_inv_0_6_p107 - c18 * Lambda_inv_0_6_p106 +
      inverse_D5_p82 * Lambda_inv_0_6_p104;
  const Real Lambda_inv_0_6_p109 = s17 * Lambda_inv_0_6_p105 - c17 * Lambda_inv_0_6_p108;
  const Real Lambda_inv_0_6_p110 = s18 * Lambda_inv_0_6_p101 + c18 * Lambda_inv_0_6_p103 +
      inverse_D5_p49 * Lambda_inv_0_6_p104;
  const Real Lambda_inv_0_6_p111 = inverse_D5_p46 * Lambda_inv_0_6_p104;
  const Real Lambda_inv_0_6_p112 = c17 * Lambda_inv_0_6_p111 + s17 * Lambda_inv_0_6_p110;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p113 = 0.282 * Lambda_inv_0_6_p109 - inverse_D15_p1 *
      Lambda_inv_0_6_p112;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p114 = c18 * Lambda_inv_0_6_p107 + s18 * Lambda_inv_0_6_p106 -
      inverse_D5_p64 * Lambda_inv_0_6_p104;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p115 = 0.282 * Lambda_inv_0_6_p114 - s17 * Lambda_inv_0_6_p111 + c17 *
      Lambda_inv_0_6_p110 + inverse_D15_p4 * Lambda_inv_0_6_p112;
  const Real Lambda_inv_0_6_p116 = s16 * Lambda_inv_0_6_p113 + c16 * Lambda_inv_0_6_p115;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p117 = c16 * Lambda_inv_0_6_p113 - s16 * Lambda_inv_0_6_p115 +
      inverse_D14_p1 * Lambda_inv_0_6_p116;
  const Real Lambda_inv_0_6_p118 = Lambda_inv_0_6_p32 * Lambda_inv_0_6_p116;
  const Real Lambda_inv_0_6_p119 = c15 * Lambda_inv_0_6_p117 - s15 * Lambda_inv_0_6_p118;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p120 = Lambda_inv_0_6_p109 - inverse_D5_p99 * Lambda_inv_0_6_p112;
  const Real Lambda_inv_0_6_p121 = Lambda_inv_0_6_p114 + inverse_D5_p71 * Lambda_inv_0_6_p112;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p122 = c16 * Lambda_inv_0_6_p121 + s16 * Lambda_inv_0_6_p120 -
      inverse_D5_p140 * Lambda_inv_0_6_p116;
  const Real Lambda_inv_0_6_p123 = c17 * Lambda_inv_0_6_p105 + s17 * Lambda_inv_0_6_p108 +
      inverse_D5_p131 * Lambda_inv_0_6_p112 + inverse_D5_p137 * Lambda_inv_0_6_p116;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_0_6_p124 = s15 * Lambda_inv_0_6_p122 + c15 * Lambda_inv_0_6_p123 +
      inverse_D5_p147 * Lambda_inv_0_6_p119;
  const Real Lambda_inv_0_6_p125 = s16 * Lambda_inv_0_6_p121 - c16 * Lambda_inv_0_6_p120 -
      inverse_D5_p121 * Lambda_inv_0_6_p116 - inverse_D5_p127 * Lambda_inv_0_6_p119;
  const Real Lambda_inv_0_6_p126 = c14 * Lambda_inv_0_6_p124 + s14 * Lambda_inv_0_6_p125;
  const Real Lambda_inv_0_6_p127 = c15 * Lambda_inv_0_6_p122 - s15 * Lambda_inv_0_6_p123 +
      inverse_D5_p177 * Lambda_inv_0_6_p119;
  const Real Lambda_inv_0_6_p128 = s15 * Lambda_inv_0_6_p117 + c15 * Lambda_inv_0_6_p118 -
      inverse_D5_p365 * Lambda_inv_0_6_p119;
  const Real Lambda_inv_0_6_p129 = Lambda_inv_0_6_p44 * Lambda_inv_0_6_p119;
  const Real Lambda_inv_0_6_p130 = 0.18 * Lambda_inv_0_6_p126 + 0.226 * Lambda_inv_0_6_p127 + s14 *
      Lambda_inv_0_6_p128 - c14 * Lambda_inv_0_6_p129;
  const Real Lambda_inv_0_6_p131 = s14 * Lambda_inv_0_6_p124 - c14 * Lambda_inv_0_6_p125;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_6_p132 = Lambda_inv_0_6_p131 - inverse_D5_p408 * Lambda_inv_0_6_p130;
  const Real Lambda_inv_0_6_p133 = 0.226 * Lambda_inv_0_6_p131 + inverse_D5_p383 *
      Lambda_inv_0_6_p130;
  const Real Lambda_inv_0_6_p134 = 0.18 * Lambda_inv_0_6_p131 - c14 * Lambda_inv_0_6_p128 - s14 *
      Lambda_inv_0_6_p129 - inverse_D5_p390 * Lambda_inv_0_6_p130;
  const Real Lambda_inv_0_6_p135 = 0.072 * Lambda_inv_0_6_p132 + c6 * Lambda_inv_0_6_p133 - s6 *
      Lambda_inv_0_6_p134;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_6_p136 = s6 * Lambda_inv_0_6_p133 + c6 * Lambda_inv_0_6_p134 -
      inverse_D1_p35 * Lambda_inv_0_6_p135;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_6_p137 = Lambda_inv_0_6_p127 + inverse_D1_p2 * Lambda_inv_0_6_p130;
  const Real Lambda_inv_0_6_p138 = Lambda_inv_0_6_p126 - inverse_D1_p11 * Lambda_inv_0_6_p130;
  const Real Lambda_inv_0_6_p139 = c6 * Lambda_inv_0_6_p137 - s6 * Lambda_inv_0_6_p138;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_6_p140 = 0.072 * Lambda_inv_0_6_p139 - inverse_D1_p25 *
      Lambda_inv_0_6_p135;
  const Real Lambda_inv_0_6_p141 = c5 * Lambda_inv_0_6_p136 + s5 * Lambda_inv_0_6_p140;
  const Real Lambda_inv_0_6_p142 = s6 * Lambda_inv_0_6_p137 + c6 * Lambda_inv_0_6_p138 -
      inverse_D1_p58 * Lambda_inv_0_6_p135;
  const Real Lambda_inv_0_6_p143 = Lambda_inv_0_6_p132 - inverse_D1_p54 * Lambda_inv_0_6_p135;
  const Real Lambda_inv_0_6_p144 = s5 * Lambda_inv_0_6_p142 + c5 * Lambda_inv_0_6_p143;
  const Real Lambda_inv_0_6_p145 = Lambda_inv_0_6_p139 - inverse_D1_p42 * Lambda_inv_0_6_p135;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_6_p146 = s4 * (0.21799999999999997 * Lambda_inv_0_6_p145 - s5 *
      Lambda_inv_0_6_p136 + c5 * Lambda_inv_0_6_p140 + inverse_D3_p3 * Lambda_inv_0_6_p141);
  const Real Lambda_inv_0_6_p147 = c4 * (0.21799999999999997 * Lambda_inv_0_6_p144 + inverse_D3_p1 *
      Lambda_inv_0_6_p141) - Lambda_inv_0_6_p146;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_6_p148 = c5 * Lambda_inv_0_6_p142 - s5 * Lambda_inv_0_6_p143 -
      inverse_D1_p83 * Lambda_inv_0_6_p141 - inverse_D1_p87 * Lambda_inv_0_6_p147;
  const Real Lambda_inv_0_6_p149 = s4 * (Lambda_inv_0_6_p145 + inverse_D1_p48 *
      Lambda_inv_0_6_p141) - c4 * (Lambda_inv_0_6_p144 + inverse_D1_p67 * Lambda_inv_0_6_p141) +
      inverse_D1_p89 * Lambda_inv_0_6_p147;
  const Real Lambda_inv_0_6_p150 = s3 * Lambda_inv_0_6_p148 - c3 * Lambda_inv_0_6_p149;
  const Real Lambda_inv_0_6_p151 = 0.422 * Lambda_inv_0_6_p150;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_6_p152 = s2 * (c3 * Lambda_inv_0_6_p148 + s3 * Lambda_inv_0_6_p149 +
      inverse_D1_p102 * Lambda_inv_0_6_p151) + c2 * (Lambda_inv_0_6_p150 - inverse_D1_p98 *
      Lambda_inv_0_6_p151);
  const Real Lambda_inv_0_6_p153 = 0.434 * Lambda_inv_0_6_p152;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_6_p154 = inverse_D1 * Lambda_inv_0_6_p153;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_6_p155 = inverse_D2 * Lambda_inv_0_6_p151;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_6_p156 = inverse_D3 * Lambda_inv_0_6_p147;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_6_p157 = inverse_D4 * Lambda_inv_0_6_p141;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_6_p158 = inverse_D5 * Lambda_inv_0_6_p135;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_6_p159 = inverse_D6 * Lambda_inv_0_6_p130;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_6_p160 = Lambda_inv_0_4_p138 * Lambda_inv_0_6_p159 - Lambda_inv_0_4_p143 *
      Lambda_inv_0_6_p158 - Lambda_inv_0_4_p149 * Lambda_inv_0_6_p157 - Lambda_inv_0_4_p155 *
      Lambda_inv_0_6_p156 - Lambda_inv_0_4_p159 * Lambda_inv_0_6_p155;
  const Real Lambda_inv_0_6_p161 = Lambda_inv_0_6_p160 - Lambda_inv_0_4_p161 * Lambda_inv_0_6_p154;

  // link 14 (right_shoulder1), pose
  const Real Lambda_inv_0_6_p162 = c14 * Lambda_inv_0_4_p175 + s14 * Lambda_inv_0_4_p178;
  const Real Lambda_inv_0_6_p163 = s14 * Lambda_inv_0_4_p175 - c14 * Lambda_inv_0_4_p178;

  // link 15 (right_shoulder2), pose
  const Real Lambda_inv_0_6_p164 = c15 * Lambda_inv_0_4_p181 + s15 * Lambda_inv_0_6_p163;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_6_p165 = s16 * Lambda_inv_0_6_p162 - c16 * Lambda_inv_0_6_p164;
  const Real Lambda_inv_0_6_p166 = c16 * Lambda_inv_0_6_p162 + s16 * Lambda_inv_0_6_p164;

  // link 15 (right_shoulder2), pose
  const Real Lambda_inv_0_6_p167 = s15 * Lambda_inv_0_4_p181 - c15 * Lambda_inv_0_6_p163;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_6_p168 = s17 * Lambda_inv_0_6_p167 + c17 * Lambda_inv_0_6_p166;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_6_p169 = c18 * Lambda_inv_0_6_p165 + s18 * Lambda_inv_0_6_p168;
  const Real Lambda_inv_0_6_p170 = s18 * Lambda_inv_0_6_p165 - c18 * Lambda_inv_0_6_p168;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_6_p171 = c17 * Lambda_inv_0_6_p167 - s17 * Lambda_inv_0_6_p166;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_6_p172 = c19 * Lambda_inv_0_6_p171 + s19 * Lambda_inv_0_6_p170;

  // link 20 (right_hand), pose
  const Real Lambda_inv_0_6_p173 = s20 * Lambda_inv_0_6_p169 - c20 * Lambda_inv_0_6_p172;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_6_p174 = 0.086 * Lambda_inv_0_6_p173;

  // link 20 (right_hand), pose
  const Real Lambda_inv_0_6_p175 = c20 * Lambda_inv_0_6_p169 + s20 * Lambda_inv_0_6_p172;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_6_p176 = s19 * Lambda_inv_0_6_p171 - c19 * Lambda_inv_0_6_p170;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p177 = Lambda_inv_0_6_p175 - 0.04672761636452121 * Lambda_inv_0_6_p176;
  const Real Lambda_inv_0_6_p178 = Lambda_inv_0_6_p173 - 0.11533812622014242 * Lambda_inv_0_6_p176;
  const Real Lambda_inv_0_6_p179 = c20 * Lambda_inv_0_6_p177 + s20 * Lambda_inv_0_6_p178;
  const Real Lambda_inv_0_6_p180 = 17.32841575379867 * Lambda_inv_0_6_p176;
  const Real Lambda_inv_0_6_p181 = 3.0523172236718206 * Lambda_inv_0_6_p176;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p182 = s20 * Lambda_inv_0_6_p180 + c20 * Lambda_inv_0_6_p181 -
      inverse_D5_p8 * Lambda_inv_0_6_p179;
  const Real Lambda_inv_0_6_p183 = inverse_D5_p2 * Lambda_inv_0_6_p179;
  const Real Lambda_inv_0_6_p184 = s19 * Lambda_inv_0_6_p182 - c19 * Lambda_inv_0_6_p183;
  const Real Lambda_inv_0_6_p185 = s20 * Lambda_inv_0_6_p177 - c20 * Lambda_inv_0_6_p178 -
      inverse_D18_p1 * Lambda_inv_0_6_p179;
  const Real Lambda_inv_0_6_p186 = c19 * Lambda_inv_0_6_p185;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p187 = 0.269 * Lambda_inv_0_6_p184 - inverse_D5_p23 *
      Lambda_inv_0_6_p186;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p188 = c20 * Lambda_inv_0_6_p180 - s20 * Lambda_inv_0_6_p181 +
      inverse_D5_p14 * Lambda_inv_0_6_p179;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p189 = 0.269 * Lambda_inv_0_6_p188 + s19 * Lambda_inv_0_6_p185 -
      inverse_D5_p29 * Lambda_inv_0_6_p186;
  const Real Lambda_inv_0_6_p190 = c18 * Lambda_inv_0_6_p187 - s18 * Lambda_inv_0_6_p189;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p191 = c19 * Lambda_inv_0_6_p182 + s19 * Lambda_inv_0_6_p183 +
      inverse_D5_p86 * Lambda_inv_0_6_p186 - inverse_D5_p91 * Lambda_inv_0_6_p190;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p192 = Lambda_inv_0_6_p184 - inverse_D5_p54 * Lambda_inv_0_6_p186;
  const Real Lambda_inv_0_6_p193 = Lambda_inv_0_6_p188 - inverse_D5_p57 * Lambda_inv_0_6_p186;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p194 = s18 * Lambda_inv_0_6_p193 - c18 * Lambda_inv_0_6_p192 +
      inverse_D5_p82 * Lambda_inv_0_6_p190;
  const Real Lambda_inv_0_6_p195 = s17 * Lambda_inv_0_6_p191 - c17 * Lambda_inv_0_6_p194;
  const Real Lambda_inv_0_6_p196 = s18 * Lambda_inv_0_6_p187 + c18 * Lambda_inv_0_6_p189 +
      inverse_D5_p49 * Lambda_inv_0_6_p190;
  const Real Lambda_inv_0_6_p197 = inverse_D5_p46 * Lambda_inv_0_6_p190;
  const Real Lambda_inv_0_6_p198 = c17 * Lambda_inv_0_6_p197 + s17 * Lambda_inv_0_6_p196;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p199 = 0.282 * Lambda_inv_0_6_p195 - inverse_D15_p1 *
      Lambda_inv_0_6_p198;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p200 = c18 * Lambda_inv_0_6_p193 + s18 * Lambda_inv_0_6_p192 -
      inverse_D5_p64 * Lambda_inv_0_6_p190;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p201 = 0.282 * Lambda_inv_0_6_p200 - s17 * Lambda_inv_0_6_p197 + c17 *
      Lambda_inv_0_6_p196 + inverse_D15_p4 * Lambda_inv_0_6_p198;
  const Real Lambda_inv_0_6_p202 = s16 * Lambda_inv_0_6_p199 + c16 * Lambda_inv_0_6_p201;
  const Real Lambda_inv_0_6_p203 = Lambda_inv_0_6_p195 - inverse_D5_p99 * Lambda_inv_0_6_p198;
  const Real Lambda_inv_0_6_p204 = Lambda_inv_0_6_p200 + inverse_D5_p71 * Lambda_inv_0_6_p198;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p205 = c16 * Lambda_inv_0_6_p204 + s16 * Lambda_inv_0_6_p203 -
      inverse_D5_p140 * Lambda_inv_0_6_p202;
  const Real Lambda_inv_0_6_p206 = c17 * Lambda_inv_0_6_p191 + s17 * Lambda_inv_0_6_p194 +
      inverse_D5_p131 * Lambda_inv_0_6_p198 + inverse_D5_p137 * Lambda_inv_0_6_p202;
  const Real Lambda_inv_0_6_p207 = c16 * Lambda_inv_0_6_p199 - s16 * Lambda_inv_0_6_p201 +
      inverse_D14_p1 * Lambda_inv_0_6_p202;
  const Real Lambda_inv_0_6_p208 = Lambda_inv_0_6_p32 * Lambda_inv_0_6_p202;
  const Real Lambda_inv_0_6_p209 = c15 * Lambda_inv_0_6_p207 - s15 * Lambda_inv_0_6_p208;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_0_6_p210 = s15 * Lambda_inv_0_6_p205 + c15 * Lambda_inv_0_6_p206 +
      inverse_D5_p147 * Lambda_inv_0_6_p209;
  const Real Lambda_inv_0_6_p211 = s16 * Lambda_inv_0_6_p204 - c16 * Lambda_inv_0_6_p203 -
      inverse_D5_p121 * Lambda_inv_0_6_p202 - inverse_D5_p127 * Lambda_inv_0_6_p209;
  const Real Lambda_inv_0_6_p212 = c14 * Lambda_inv_0_6_p210 + s14 * Lambda_inv_0_6_p211;
  const Real Lambda_inv_0_6_p213 = c15 * Lambda_inv_0_6_p205 - s15 * Lambda_inv_0_6_p206 +
      inverse_D5_p177 * Lambda_inv_0_6_p209;
  const Real Lambda_inv_0_6_p214 = s15 * Lambda_inv_0_6_p207 + c15 * Lambda_inv_0_6_p208 -
      inverse_D5_p365 * Lambda_inv_0_6_p209;
  const Real Lambda_inv_0_6_p215 = Lambda_inv_0_6_p44 * Lambda_inv_0_6_p209;
  const Real Lambda_inv_0_6_p216 = 0.18 * Lambda_inv_0_6_p212 + 0.226 * Lambda_inv_0_6_p213 + s14 *
      Lambda_inv_0_6_p214 - c14 * Lambda_inv_0_6_p215;
  const Real Lambda_inv_0_6_p217 = s14 * Lambda_inv_0_6_p210 - c14 * Lambda_inv_0_6_p211;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_6_p218 = Lambda_inv_0_6_p217 - inverse_D5_p408 * Lambda_inv_0_6_p216;
  const Real Lambda_inv_0_6_p219 = 0.226 * Lambda_inv_0_6_p217 + inverse_D5_p383 *
      Lambda_inv_0_6_p216;
  const Real Lambda_inv_0_6_p220 = 0.18 * Lambda_inv_0_6_p217 - c14 * Lambda_inv_0_6_p214 - s14 *
      Lambda_inv_0_6_p215 - inverse_D5_p390 * Lambda_inv_0_6_p216;
  const Real Lambda_inv_0_6_p221 = 0.072 * Lambda_inv_0_6_p218 + c6 * Lambda_inv_0_6_p219 - s6 *
      Lambda_inv_0_6_p220;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_6_p222 = s6 * Lambda_inv_0_6_p219 + c6 * Lambda_inv_0_6_p220 -
      inverse_D1_p35 * Lambda_inv_0_6_p221;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_6_p223 = Lambda_inv_0_6_p213 + inverse_D1_p2 * Lambda_inv_0_6_p216;
  const Real Lambda_inv_0_6_p224 = Lambda_inv_0_6_p212 - inverse_D1_p11 * Lambda_inv_0_6_p216;
  const Real Lambda_inv_0_6_p225 = c6 * Lambda_inv_0_6_p223 - s6 * Lambda_inv_0_6_p224;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_6_p226 = 0.072 * Lambda_inv_0_6_p225 - inverse_D1_p25 *
      Lambda_inv_0_6_p221;
  const Real Lambda_inv_0_6_p227 = c5 * Lambda_inv_0_6_p222 + s5 * Lambda_inv_0_6_p226;
  const Real Lambda_inv_0_6_p228 = s6 * Lambda_inv_0_6_p223 + c6 * Lambda_inv_0_6_p224 -
      inverse_D1_p58 * Lambda_inv_0_6_p221;
  const Real Lambda_inv_0_6_p229 = Lambda_inv_0_6_p218 - inverse_D1_p54 * Lambda_inv_0_6_p221;
  const Real Lambda_inv_0_6_p230 = s5 * Lambda_inv_0_6_p228 + c5 * Lambda_inv_0_6_p229;
  const Real Lambda_inv_0_6_p231 = Lambda_inv_0_6_p225 - inverse_D1_p42 * Lambda_inv_0_6_p221;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_6_p232 = s4 * (0.21799999999999997 * Lambda_inv_0_6_p231 - s5 *
      Lambda_inv_0_6_p222 + c5 * Lambda_inv_0_6_p226 + inverse_D3_p3 * Lambda_inv_0_6_p227);
  const Real Lambda_inv_0_6_p233 = c4 * (0.21799999999999997 * Lambda_inv_0_6_p230 + inverse_D3_p1 *
      Lambda_inv_0_6_p227) - Lambda_inv_0_6_p232;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_6_p234 = c5 * Lambda_inv_0_6_p228 - s5 * Lambda_inv_0_6_p229 -
      inverse_D1_p83 * Lambda_inv_0_6_p227 - inverse_D1_p87 * Lambda_inv_0_6_p233;
  const Real Lambda_inv_0_6_p235 = s4 * (Lambda_inv_0_6_p231 + inverse_D1_p48 *
      Lambda_inv_0_6_p227) - c4 * (Lambda_inv_0_6_p230 + inverse_D1_p67 * Lambda_inv_0_6_p227) +
      inverse_D1_p89 * Lambda_inv_0_6_p233;
  const Real Lambda_inv_0_6_p236 = s3 * Lambda_inv_0_6_p234 - c3 * Lambda_inv_0_6_p235;
  const Real Lambda_inv_0_6_p237 = 0.422 * Lambda_inv_0_6_p236;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_6_p238 = s2 * (c3 * Lambda_inv_0_6_p234 + s3 * Lambda_inv_0_6_p235 +
      inverse_D1_p102 * Lambda_inv_0_6_p237) + c2 * (Lambda_inv_0_6_p236 - inverse_D1_p98 *
      Lambda_inv_0_6_p237);
  const Real Lambda_inv_0_6_p239 = 0.434 * Lambda_inv_0_6_p238;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_6_p240 = inverse_D1 * Lambda_inv_0_6_p239;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_6_p241 = inverse_D2 * Lambda_inv_0_6_p237;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_6_p242 = inverse_D3 * Lambda_inv_0_6_p233;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_6_p243 = inverse_D4 * Lambda_inv_0_6_p227;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_6_p244 = inverse_D5 * Lambda_inv_0_6_p221;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_6_p245 = inverse_D6 * Lambda_inv_0_6_p216;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_6_p246 = Lambda_inv_0_4_p138 * Lambda_inv_0_6_p245 - Lambda_inv_0_4_p143 *
      Lambda_inv_0_6_p244 - Lambda_inv_0_4_p149 * Lambda_inv_0_6_p243 - Lambda_inv_0_4_p155 *
      Lambda_inv_0_6_p242 - Lambda_inv_0_4_p159 * Lambda_inv_0_6_p241;
  const Real Lambda_inv_0_6_p247 = Lambda_inv_0_6_p246 - Lambda_inv_0_4_p161 * Lambda_inv_0_6_p240;
  const Real Lambda_inv_0_6_p248 = 0.086 * Lambda_inv_0_6_p91;
  const Real Lambda_inv_4_6_p1 = Lambda_inv_0_4_p60 * Lambda_inv_0_6_p75 - Lambda_inv_0_4_p65 *
      Lambda_inv_0_6_p74 - Lambda_inv_0_4_p71 * Lambda_inv_0_6_p73 - Lambda_inv_0_4_p77 *
      Lambda_inv_0_6_p72 - Lambda_inv_0_4_p81 * Lambda_inv_0_6_p71;
  const Real Lambda_inv_4_10_p1 = Lambda_inv_0_4_p60 * Lambda_inv_0_6_p159 - Lambda_inv_0_4_p65 *
      Lambda_inv_0_6_p158 - Lambda_inv_0_4_p71 * Lambda_inv_0_6_p157 - Lambda_inv_0_4_p77 *
      Lambda_inv_0_6_p156 - Lambda_inv_0_4_p81 * Lambda_inv_0_6_p155;
  const Real Lambda_inv_4_10 = Lambda_inv_4_10_p1 - Lambda_inv_0_4_p83 * Lambda_inv_0_6_p154;
  Lambda_inv[58] = -Lambda_inv_4_10;
  Lambda_inv[124] = -Lambda_inv_4_10;
  const Real Lambda_inv_4_11_p1 = Lambda_inv_0_4_p60 * Lambda_inv_0_6_p245 - Lambda_inv_0_4_p65 *
      Lambda_inv_0_6_p244 - Lambda_inv_0_4_p71 * Lambda_inv_0_6_p243 - Lambda_inv_0_4_p77 *
      Lambda_inv_0_6_p242 - Lambda_inv_0_4_p81 * Lambda_inv_0_6_p241;
  const Real Lambda_inv_4_11 = Lambda_inv_4_11_p1 - Lambda_inv_0_4_p83 * Lambda_inv_0_6_p240;
  Lambda_inv[59] = -Lambda_inv_4_11;
  Lambda_inv[136] = -Lambda_inv_4_11;
  const Real Lambda_inv_4_6 = Lambda_inv_4_6_p1 - Lambda_inv_0_4_p83 * Lambda_inv_0_6_p70 +
      Lambda_inv_4_10 * Lambda_inv_0_6_p174 - Lambda_inv_4_11 * Lambda_inv_0_6_p248;
  Lambda_inv[54] = Lambda_inv_4_6;
  Lambda_inv[76] = Lambda_inv_4_6;
  const Real Lambda_inv_0_6_p249 = Lambda_inv_0_6_p76 - Lambda_inv_0_4_p161 * Lambda_inv_0_6_p70 +
      Lambda_inv_0_6_p161 * Lambda_inv_0_6_p174 - Lambda_inv_0_6_p247 * Lambda_inv_0_6_p248 +
      Lambda_inv_0_4_p192 * Lambda_inv_4_6;
  const Real Lambda_inv_5_6_p1 = Lambda_inv_4_5_p42 * Lambda_inv_0_6_p75 - Lambda_inv_4_5_p47 *
      Lambda_inv_0_6_p74 - Lambda_inv_4_5_p53 * Lambda_inv_0_6_p73 - Lambda_inv_4_5_p59 *
      Lambda_inv_0_6_p72 - Lambda_inv_4_5_p63 * Lambda_inv_0_6_p71;
  const Real Lambda_inv_5_10_p1 = Lambda_inv_4_5_p42 * Lambda_inv_0_6_p159 - Lambda_inv_4_5_p47 *
      Lambda_inv_0_6_p158 - Lambda_inv_4_5_p53 * Lambda_inv_0_6_p157 - Lambda_inv_4_5_p59 *
      Lambda_inv_0_6_p156 - Lambda_inv_4_5_p63 * Lambda_inv_0_6_p155;
  const Real Lambda_inv_5_10 = Lambda_inv_5_10_p1 - Lambda_inv_4_5_p65 * Lambda_inv_0_6_p154;
  Lambda_inv[70] = -Lambda_inv_5_10;
  Lambda_inv[125] = -Lambda_inv_5_10;
  const Real Lambda_inv_5_11_p1 = Lambda_inv_4_5_p42 * Lambda_inv_0_6_p245 - Lambda_inv_4_5_p47 *
      Lambda_inv_0_6_p244 - Lambda_inv_4_5_p53 * Lambda_inv_0_6_p243 - Lambda_inv_4_5_p59 *
      Lambda_inv_0_6_p242 - Lambda_inv_4_5_p63 * Lambda_inv_0_6_p241;
  const Real Lambda_inv_5_11 = Lambda_inv_5_11_p1 - Lambda_inv_4_5_p65 * Lambda_inv_0_6_p240;
  Lambda_inv[71] = -Lambda_inv_5_11;
  Lambda_inv[137] = -Lambda_inv_5_11;
  const Real Lambda_inv_5_6 = Lambda_inv_5_6_p1 - Lambda_inv_4_5_p65 * Lambda_inv_0_6_p70 +
      Lambda_inv_5_10 * Lambda_inv_0_6_p174 - Lambda_inv_5_11 * Lambda_inv_0_6_p248;
  Lambda_inv[66] = Lambda_inv_5_6;
  Lambda_inv[77] = Lambda_inv_5_6;
  const Real Lambda_inv_0_6 = Lambda_inv_0_6_p249 - Lambda_inv_0_4_p193 * Lambda_inv_5_6;
  Lambda_inv[6] = -Lambda_inv_0_6;
  Lambda_inv[72] = -Lambda_inv_0_6;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p1 = s20 * Lambda_inv_0_6_p88 - c20 * Lambda_inv_0_6_p91;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p2 = s19 * Lambda_inv_0_7_p1 - c19 * Lambda_inv_0_6_p89;
  const Real Lambda_inv_0_7_p3 = 0.269 * Lambda_inv_0_7_p2;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p4 = c20 * Lambda_inv_0_6_p88 + s20 * Lambda_inv_0_6_p91;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p5 = 0.269 * Lambda_inv_0_7_p4;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p6 = c18 * Lambda_inv_0_7_p3 - s18 * Lambda_inv_0_7_p5;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p7 = inverse_D5_p46 * Lambda_inv_0_7_p6;
  const Real Lambda_inv_0_7_p8 = s18 * Lambda_inv_0_7_p3 + c18 * Lambda_inv_0_7_p5 +
      inverse_D5_p49 * Lambda_inv_0_7_p6;
  const Real Lambda_inv_0_7_p9 = c17 * Lambda_inv_0_7_p7 + s17 * Lambda_inv_0_7_p8;
  const Real Lambda_inv_0_7_p10 = c19 * Lambda_inv_0_7_p1 + s19 * Lambda_inv_0_6_p89 -
      inverse_D5_p91 * Lambda_inv_0_7_p6;
  const Real Lambda_inv_0_7_p11 = s18 * Lambda_inv_0_7_p4 - c18 * Lambda_inv_0_7_p2 +
      inverse_D5_p82 * Lambda_inv_0_7_p6;
  const Real Lambda_inv_0_7_p12 = s17 * Lambda_inv_0_7_p10 - c17 * Lambda_inv_0_7_p11;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p13 = 0.282 * Lambda_inv_0_7_p12 - inverse_D15_p1 * Lambda_inv_0_7_p9;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p14 = c18 * Lambda_inv_0_7_p4 + s18 * Lambda_inv_0_7_p2 -
      inverse_D5_p64 * Lambda_inv_0_7_p6;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p15 = 0.282 * Lambda_inv_0_7_p14 - s17 * Lambda_inv_0_7_p7 + c17 *
      Lambda_inv_0_7_p8 + inverse_D15_p4 * Lambda_inv_0_7_p9;
  const Real Lambda_inv_0_7_p16 = s16 * Lambda_inv_0_7_p13 + c16 * Lambda_inv_0_7_p15;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p17 = c16 * Lambda_inv_0_7_p13 - s16 * Lambda_inv_0_7_p15 +
      inverse_D14_p1 * Lambda_inv_0_7_p16;
  const Real Lambda_inv_0_7_p18 = Lambda_inv_0_6_p32 * Lambda_inv_0_7_p16;
  const Real Lambda_inv_0_7_p19 = c15 * Lambda_inv_0_7_p17 - s15 * Lambda_inv_0_7_p18;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p20 = Lambda_inv_0_7_p14 + inverse_D5_p71 * Lambda_inv_0_7_p9;
  const Real Lambda_inv_0_7_p21 = Lambda_inv_0_7_p12 - inverse_D5_p99 * Lambda_inv_0_7_p9;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p22 = c16 * Lambda_inv_0_7_p20 + s16 * Lambda_inv_0_7_p21 -
      inverse_D5_p140 * Lambda_inv_0_7_p16;
  const Real Lambda_inv_0_7_p23 = c17 * Lambda_inv_0_7_p10 + s17 * Lambda_inv_0_7_p11 +
      inverse_D5_p131 * Lambda_inv_0_7_p9 + inverse_D5_p137 * Lambda_inv_0_7_p16;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_0_7_p24 = s15 * Lambda_inv_0_7_p22 + c15 * Lambda_inv_0_7_p23 +
      inverse_D5_p147 * Lambda_inv_0_7_p19;
  const Real Lambda_inv_0_7_p25 = s16 * Lambda_inv_0_7_p20 - c16 * Lambda_inv_0_7_p21 -
      inverse_D5_p121 * Lambda_inv_0_7_p16 - inverse_D5_p127 * Lambda_inv_0_7_p19;
  const Real Lambda_inv_0_7_p26 = c14 * Lambda_inv_0_7_p24 + s14 * Lambda_inv_0_7_p25;
  const Real Lambda_inv_0_7_p27 = c15 * Lambda_inv_0_7_p22 - s15 * Lambda_inv_0_7_p23 +
      inverse_D5_p177 * Lambda_inv_0_7_p19;
  const Real Lambda_inv_0_7_p28 = s15 * Lambda_inv_0_7_p17 + c15 * Lambda_inv_0_7_p18 -
      inverse_D5_p365 * Lambda_inv_0_7_p19;
  const Real Lambda_inv_0_7_p29 = Lambda_inv_0_6_p44 * Lambda_inv_0_7_p19;
  const Real Lambda_inv_0_7_p30 = 0.18 * Lambda_inv_0_7_p26 + 0.226 * Lambda_inv_0_7_p27 + s14 *
      Lambda_inv_0_7_p28 - c14 * Lambda_inv_0_7_p29;
  const Real Lambda_inv_0_7_p31 = s14 * Lambda_inv_0_7_p24 - c14 * Lambda_inv_0_7_p25;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_7_p32 = Lambda_inv_0_7_p31 - inverse_D5_p408 * Lambda_inv_0_7_p30;
  const Real Lambda_inv_0_7_p33 = 0.226 * Lambda_inv_0_7_p31 + inverse_D5_p383 * Lambda_inv_0_7_p30;
  const Real Lambda_inv_0_7_p34 = 0.18 * Lambda_inv_0_7_p31 - c14 * Lambda_inv_0_7_p28 - s14 *
      Lambda_inv_0_7_p29 - inverse_D5_p390 * Lambda_inv_0_7_p30;
  const Real Lambda_inv_0_7_p35 = 0.072 * Lambda_inv_0_7_p32 + c6 * Lambda_inv_0_7_p33 - s6 *
      Lambda_inv_0_7_p34;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_7_p36 = s6 * Lambda_inv_0_7_p33 + c6 * Lambda_inv_0_7_p34 -
      inverse_D1_p35 * Lambda_inv_0_7_p35;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_7_p37 = Lambda_inv_0_7_p27 + inverse_D1_p2 * Lambda_inv_0_7_p30;
  const Real Lambda_inv_0_7_p38 = Lambda_inv_0_7_p26 - inverse_D1_p11 * Lambda_inv_0_7_p30;
  const Real Lambda_inv_0_7_p39 = c6 * Lambda_inv_0_7_p37 - s6 * Lambda_inv_0_7_p38;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_7_p40 = 0.072 * Lambda_inv_0_7_p39 - inverse_D1_p25 * Lambda_inv_0_7_p35;
  const Real Lambda_inv_0_7_p41 = c5 * Lambda_inv_0_7_p36 + s5 * Lambda_inv_0_7_p40;
  const Real Lambda_inv_0_7_p42 = s6 * Lambda_inv_0_7_p37 + c6 * Lambda_inv_0_7_p38 -
      inverse_D1_p58 * Lambda_inv_0_7_p35;
  const Real Lambda_inv_0_7_p43 = Lambda_inv_0_7_p32 - inverse_D1_p54 * Lambda_inv_0_7_p35;
  const Real Lambda_inv_0_7_p44 = s5 * Lambda_inv_0_7_p42 + c5 * Lambda_inv_0_7_p43;
  const Real Lambda_inv_0_7_p45 = Lambda_inv_0_7_p39 - inverse_D1_p42 * Lambda_inv_0_7_p35;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_7_p46 = s4 * (0.21799999999999997 * Lambda_inv_0_7_p45 - s5 *
      Lambda_inv_0_7_p36 + c5 * Lambda_inv_0_7_p40 + inverse_D3_p3 * Lambda_inv_0_7_p41);
  const Real Lambda_inv_0_7_p47 = c4 * (0.21799999999999997 * Lambda_inv_0_7_p44 + inverse_D3_p1 *
      Lambda_inv_0_7_p41) - Lambda_inv_0_7_p46;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_7_p48 = c5 * Lambda_inv_0_7_p42 - s5 * Lambda_inv_0_7_p43 -
      inverse_D1_p83 * Lambda_inv_0_7_p41 - inverse_D1_p87 * Lambda_inv_0_7_p47;
  const Real Lambda_inv_0_7_p49 = s4 * (Lambda_inv_0_7_p45 + inverse_D1_p48 * Lambda_inv_0_7_p41) -
      c4 * (Lambda_inv_0_7_p44 + inverse_D1_p67 * Lambda_inv_0_7_p41) + inverse_D1_p89 *
      Lambda_inv_0_7_p47;
  const Real Lambda_inv_0_7_p50 = s3 * Lambda_inv_0_7_p48 - c3 * Lambda_inv_0_7_p49;
  const Real Lambda_inv_0_7_p51 = 0.422 * Lambda_inv_0_7_p50;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_7_p52 = s2 * (c3 * Lambda_inv_0_7_p48 + s3 * Lambda_inv_0_7_p49 +
      inverse_D1_p102 * Lambda_inv_0_7_p51) + c2 * (Lambda_inv_0_7_p50 - inverse_D1_p98 *
      Lambda_inv_0_7_p51);
  const Real Lambda_inv_0_7_p53 = 0.434 * Lambda_inv_0_7_p52;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_7_p54 = inverse_D1 * Lambda_inv_0_7_p53;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_7_p55 = inverse_D2 * Lambda_inv_0_7_p51;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_7_p56 = inverse_D3 * Lambda_inv_0_7_p47;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_7_p57 = inverse_D4 * Lambda_inv_0_7_p41;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_7_p58 = inverse_D5 * Lambda_inv_0_7_p35;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_7_p59 = inverse_D6 * Lambda_inv_0_7_p30;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_7_p60 = Lambda_inv_0_4_p138 * Lambda_inv_0_7_p59 - Lambda_inv_0_4_p143 *
      Lambda_inv_0_7_p58 - Lambda_inv_0_4_p149 * Lambda_inv_0_7_p57 - Lambda_inv_0_4_p155 *
      Lambda_inv_0_7_p56 - Lambda_inv_0_4_p159 * Lambda_inv_0_7_p55;
  const Real Lambda_inv_0_7_p61 = 0.086 * Lambda_inv_0_6_p13;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p62 = Lambda_inv_0_6_p12 + 0.04672761636452121 * Lambda_inv_0_6_p16;
  const Real Lambda_inv_0_7_p63 = Lambda_inv_0_6_p13 + 0.11533812622014242 * Lambda_inv_0_6_p16;
  const Real Lambda_inv_0_7_p64 = c20 * Lambda_inv_0_7_p62 + s20 * Lambda_inv_0_7_p63;
  const Real Lambda_inv_0_7_p65 = 17.32841575379867 * Lambda_inv_0_6_p16;
  const Real Lambda_inv_0_7_p66 = 3.0523172236718206 * Lambda_inv_0_6_p16;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p67 = s20 * Lambda_inv_0_7_p65 + c20 * Lambda_inv_0_7_p66 +
      inverse_D5_p8 * Lambda_inv_0_7_p64;
  const Real Lambda_inv_0_7_p68 = inverse_D5_p2 * Lambda_inv_0_7_p64;
  const Real Lambda_inv_0_7_p69 = s19 * Lambda_inv_0_7_p67 + c19 * Lambda_inv_0_7_p68;
  const Real Lambda_inv_0_7_p70 = s20 * Lambda_inv_0_7_p62 - c20 * Lambda_inv_0_7_p63 -
      inverse_D18_p1 * Lambda_inv_0_7_p64;
  const Real Lambda_inv_0_7_p71 = c19 * Lambda_inv_0_7_p70;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p72 = 0.269 * Lambda_inv_0_7_p69 + inverse_D5_p23 * Lambda_inv_0_7_p71;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p73 = c20 * Lambda_inv_0_7_p65 - s20 * Lambda_inv_0_7_p66 -
      inverse_D5_p14 * Lambda_inv_0_7_p64;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p74 = 0.269 * Lambda_inv_0_7_p73 - s19 * Lambda_inv_0_7_p70 +
      inverse_D5_p29 * Lambda_inv_0_7_p71;
  const Real Lambda_inv_0_7_p75 = c18 * Lambda_inv_0_7_p72 - s18 * Lambda_inv_0_7_p74;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p76 = c19 * Lambda_inv_0_7_p67 - s19 * Lambda_inv_0_7_p68 -
      inverse_D5_p86 * Lambda_inv_0_7_p71 - inverse_D5_p91 * Lambda_inv_0_7_p75;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p77 = Lambda_inv_0_7_p69 + inverse_D5_p54 * Lambda_inv_0_7_p71;
  const Real Lambda_inv_0_7_p78 = Lambda_inv_0_7_p73 + inverse_D5_p57 * Lambda_inv_0_7_p71;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p79 = s18 * Lambda_inv_0_7_p78 - c18 * Lambda_inv_0_7_p77 +
      inverse_D5_p82 * Lambda_inv_0_7_p75;
  const Real Lambda_inv_0_7_p80 = s17 * Lambda_inv_0_7_p76 - c17 * Lambda_inv_0_7_p79;
  const Real Lambda_inv_0_7_p81 = s18 * Lambda_inv_0_7_p72 + c18 * Lambda_inv_0_7_p74 +
      inverse_D5_p49 * Lambda_inv_0_7_p75;
  const Real Lambda_inv_0_7_p82 = inverse_D5_p46 * Lambda_inv_0_7_p75;
  const Real Lambda_inv_0_7_p83 = c17 * Lambda_inv_0_7_p82 + s17 * Lambda_inv_0_7_p81;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p84 = 0.282 * Lambda_inv_0_7_p80 - inverse_D15_p1 * Lambda_inv_0_7_p83;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p85 = c18 * Lambda_inv_0_7_p78 + s18 * Lambda_inv_0_7_p77 -
      inverse_D5_p64 * Lambda_inv_0_7_p75;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p86 = 0.282 * Lambda_inv_0_7_p85 - s17 * Lambda_inv_0_7_p82 + c17 *
      Lambda_inv_0_7_p81 + inverse_D15_p4 * Lambda_inv_0_7_p83;
  const Real Lambda_inv_0_7_p87 = s16 * Lambda_inv_0_7_p84 + c16 * Lambda_inv_0_7_p86;
  const Real Lambda_inv_0_7_p88 = Lambda_inv_0_7_p80 - inverse_D5_p99 * Lambda_inv_0_7_p83;
  const Real Lambda_inv_0_7_p89 = Lambda_inv_0_7_p85 + inverse_D5_p71 * Lambda_inv_0_7_p83;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p90 = c16 * Lambda_inv_0_7_p89 + s16 * Lambda_inv_0_7_p88 -
      inverse_D5_p140 * Lambda_inv_0_7_p87;
  const Real Lambda_inv_0_7_p91 = c17 * Lambda_inv_0_7_p76 + s17 * Lambda_inv_0_7_p79 +
      inverse_D5_p131 * Lambda_inv_0_7_p83 + inverse_D5_p137 * Lambda_inv_0_7_p87;
  const Real Lambda_inv_0_7_p92 = c16 * Lambda_inv_0_7_p84 - s16 * Lambda_inv_0_7_p86 +
      inverse_D14_p1 * Lambda_inv_0_7_p87;
  const Real Lambda_inv_0_7_p93 = Lambda_inv_0_6_p32 * Lambda_inv_0_7_p87;
  const Real Lambda_inv_0_7_p94 = c15 * Lambda_inv_0_7_p92 - s15 * Lambda_inv_0_7_p93;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_0_7_p95 = s15 * Lambda_inv_0_7_p90 + c15 * Lambda_inv_0_7_p91 +
      inverse_D5_p147 * Lambda_inv_0_7_p94;
  const Real Lambda_inv_0_7_p96 = s16 * Lambda_inv_0_7_p89 - c16 * Lambda_inv_0_7_p88 -
      inverse_D5_p121 * Lambda_inv_0_7_p87 - inverse_D5_p127 * Lambda_inv_0_7_p94;
  const Real Lambda_inv_0_7_p97 = c14 * Lambda_inv_0_7_p95 + s14 * Lambda_inv_0_7_p96;
  const Real Lambda_inv_0_7_p98 = c15 * Lambda_inv_0_7_p90 - s15 * Lambda_inv_0_7_p91 +
      inverse_D5_p177 * Lambda_inv_0_7_p94;
  const Real Lambda_inv_0_7_p99 = s15 * Lambda_inv_0_7_p92 + c15 * Lambda_inv_0_7_p93 -
      inverse_D5_p365 * Lambda_inv_0_7_p94;
  const Real Lambda_inv_0_7_p100 = Lambda_inv_0_6_p44 * Lambda_inv_0_7_p94;
  const Real Lambda_inv_0_7_p101 = 0.18 * Lambda_inv_0_7_p97 + 0.226 * Lambda_inv_0_7_p98 + s14 *
      Lambda_inv_0_7_p99 - c14 * Lambda_inv_0_7_p100;
  const Real Lambda_inv_0_7_p102 = s14 * Lambda_inv_0_7_p95 - c14 * Lambda_inv_0_7_p96;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_7_p103 = Lambda_inv_0_7_p102 - inverse_D5_p408 * Lambda_inv_0_7_p101;
  const Real Lambda_inv_0_7_p104 = 0.226 * Lambda_inv_0_7_p102 + inverse_D5_p383 *
      Lambda_inv_0_7_p101;
  const Real Lambda_inv_0_7_p105 = 0.18 * Lambda_inv_0_7_p102 - c14 * Lambda_inv_0_7_p99 - s14 *
      Lambda_inv_0_7_p100 - inverse_D5_p390 * Lambda_inv_0_7_p101;
  const Real Lambda_inv_0_7_p106 = 0.072 * Lambda_inv_0_7_p103 + c6 * Lambda_inv_0_7_p104 - s6 *
      Lambda_inv_0_7_p105;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_7_p107 = s6 * Lambda_inv_0_7_p104 + c6 * Lambda_inv_0_7_p105 -
      inverse_D1_p35 * Lambda_inv_0_7_p106;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_7_p108 = Lambda_inv_0_7_p98 + inverse_D1_p2 * Lambda_inv_0_7_p101;
  const Real Lambda_inv_0_7_p109 = Lambda_inv_0_7_p97 - inverse_D1_p11 * Lambda_inv_0_7_p101;
  const Real Lambda_inv_0_7_p110 = c6 * Lambda_inv_0_7_p108 - s6 * Lambda_inv_0_7_p109;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_7_p111 = 0.072 * Lambda_inv_0_7_p110 - inverse_D1_p25 *
      Lambda_inv_0_7_p106;
  const Real Lambda_inv_0_7_p112 = c5 * Lambda_inv_0_7_p107 + s5 * Lambda_inv_0_7_p111;
  const Real Lambda_inv_0_7_p113 = s6 * Lambda_inv_0_7_p108 + c6 * Lambda_inv_0_7_p109 -
      inverse_D1_p58 * Lambda_inv_0_7_p106;
  const Real Lambda_inv_0_7_p114 = Lambda_inv_0_7_p103 - inverse_D1_p54 * Lambda_inv_0_7_p106;
  const Real Lambda_inv_0_7_p115 = s5 * Lambda_inv_0_7_p113 + c5 * Lambda_inv_0_7_p114;
  const Real Lambda_inv_0_7_p116 = Lambda_inv_0_7_p110 - inverse_D1_p42 * Lambda_inv_0_7_p106;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_7_p117 = s4 * (0.21799999999999997 * Lambda_inv_0_7_p116 - s5 *
      Lambda_inv_0_7_p107 + c5 * Lambda_inv_0_7_p111 + inverse_D3_p3 * Lambda_inv_0_7_p112);
  const Real Lambda_inv_0_7_p118 = c4 * (0.21799999999999997 * Lambda_inv_0_7_p115 + inverse_D3_p1 *
      Lambda_inv_0_7_p112) - Lambda_inv_0_7_p117;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_7_p119 = c5 * Lambda_inv_0_7_p113 - s5 * Lambda_inv_0_7_p114 -
      inverse_D1_p83 * Lambda_inv_0_7_p112 - inverse_D1_p87 * Lambda_inv_0_7_p118;
  const Real Lambda_inv_0_7_p120 = s4 * (Lambda_inv_0_7_p116 + inverse_D1_p48 *
      Lambda_inv_0_7_p112) - c4 * (Lambda_inv_0_7_p115 + inverse_D1_p67 * Lambda_inv_0_7_p112) +
      inverse_D1_p89 * Lambda_inv_0_7_p118;
  const Real Lambda_inv_0_7_p121 = s3 * Lambda_inv_0_7_p119 - c3 * Lambda_inv_0_7_p120;
  const Real Lambda_inv_0_7_p122 = 0.422 * Lambda_inv_0_7_p121;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_7_p123 = s2 * (c3 * Lambda_inv_0_7_p119 + s3 * Lambda_inv_0_7_p120 +
      inverse_D1_p102 * Lambda_inv_0_7_p122) + c2 * (Lambda_inv_0_7_p121 - inverse_D1_p98 *
      Lambda_inv_0_7_p122);
  const Real Lambda_inv_0_7_p124 = 0.434 * Lambda_inv_0_7_p123;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_7_p125 = inverse_D1 * Lambda_inv_0_7_p124;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_7_p126 = inverse_D2 * Lambda_inv_0_7_p122;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_7_p127 = inverse_D3 * Lambda_inv_0_7_p118;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_7_p128 = inverse_D4 * Lambda_inv_0_7_p112;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_7_p129 = inverse_D5 * Lambda_inv_0_7_p106;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_7_p130 = inverse_D6 * Lambda_inv_0_7_p101;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_7_p131 = Lambda_inv_0_4_p138 * Lambda_inv_0_7_p130 - Lambda_inv_0_4_p143 *
      Lambda_inv_0_7_p129 - Lambda_inv_0_4_p149 * Lambda_inv_0_7_p128 - Lambda_inv_0_4_p155 *
      Lambda_inv_0_7_p127 - Lambda_inv_0_4_p159 * Lambda_inv_0_7_p126;
  const Real Lambda_inv_0_7_p132 = Lambda_inv_0_7_p131 - Lambda_inv_0_4_p161 * Lambda_inv_0_7_p125;
  const Real Lambda_inv_4_7_p1 = Lambda_inv_0_4_p60 * Lambda_inv_0_7_p59 - Lambda_inv_0_4_p65 *
      Lambda_inv_0_7_p58 - Lambda_inv_0_4_p71 * Lambda_inv_0_7_p57 - Lambda_inv_0_4_p77 *
      Lambda_inv_0_7_p56 - Lambda_inv_0_4_p81 * Lambda_inv_0_7_p55;
  const Real Lambda_inv_4_9_p1 = Lambda_inv_0_4_p60 * Lambda_inv_0_7_p130 - Lambda_inv_0_4_p65 *
      Lambda_inv_0_7_p129 - Lambda_inv_0_4_p71 * Lambda_inv_0_7_p128 - Lambda_inv_0_4_p77 *
      Lambda_inv_0_7_p127 - Lambda_inv_0_4_p81 * Lambda_inv_0_7_p126;
  const Real Lambda_inv_4_9 = Lambda_inv_4_9_p1 - Lambda_inv_0_4_p83 * Lambda_inv_0_7_p125;
  Lambda_inv[57] = -Lambda_inv_4_9;
  Lambda_inv[112] = -Lambda_inv_4_9;
  const Real Lambda_inv_4_7 = Lambda_inv_4_7_p1 - Lambda_inv_0_4_p83 * Lambda_inv_0_7_p54 +
      Lambda_inv_4_11 * Lambda_inv_0_7_p61 + Lambda_inv_4_9 * Lambda_inv_0_6_p174;
  Lambda_inv[55] = -Lambda_inv_4_7;
  Lambda_inv[88] = -Lambda_inv_4_7;
  const Real Lambda_inv_0_7_p133 = Lambda_inv_0_7_p60 - Lambda_inv_0_4_p161 * Lambda_inv_0_7_p54 +
      Lambda_inv_0_6_p247 * Lambda_inv_0_7_p61 + Lambda_inv_0_7_p132 * Lambda_inv_0_6_p174 +
      Lambda_inv_0_4_p192 * Lambda_inv_4_7;
  const Real Lambda_inv_5_7_p1 = Lambda_inv_4_5_p42 * Lambda_inv_0_7_p59 - Lambda_inv_4_5_p47 *
      Lambda_inv_0_7_p58 - Lambda_inv_4_5_p53 * Lambda_inv_0_7_p57 - Lambda_inv_4_5_p59 *
      Lambda_inv_0_7_p56 - Lambda_inv_4_5_p63 * Lambda_inv_0_7_p55;
  const Real Lambda_inv_5_9_p1 = Lambda_inv_4_5_p42 * Lambda_inv_0_7_p130 - Lambda_inv_4_5_p47 *
      Lambda_inv_0_7_p129 - Lambda_inv_4_5_p53 * Lambda_inv_0_7_p128 - Lambda_inv_4_5_p59 *
      Lambda_inv_0_7_p127 - Lambda_inv_4_5_p63 * Lambda_inv_0_7_p126;
  const Real Lambda_inv_5_9 = Lambda_inv_5_9_p1 - Lambda_inv_4_5_p65 * Lambda_inv_0_7_p125;
  Lambda_inv[69] = -Lambda_inv_5_9;
  Lambda_inv[113] = -Lambda_inv_5_9;
  const Real Lambda_inv_5_7 = Lambda_inv_5_7_p1 - Lambda_inv_4_5_p65 * Lambda_inv_0_7_p54 +
      Lambda_inv_5_11 * Lambda_inv_0_7_p61 + Lambda_inv_5_9 * Lambda_inv_0_6_p174;
  Lambda_inv[67] = -Lambda_inv_5_7;
  Lambda_inv[89] = -Lambda_inv_5_7;
  const Real Lambda_inv_0_7 = Lambda_inv_0_7_p133 - Lambda_inv_0_4_p193 * Lambda_inv_5_7;
  Lambda_inv[7] = Lambda_inv_0_7;
  Lambda_inv[84] = Lambda_inv_0_7;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_8_p1 = c20 * Lambda_inv_0_6_p175 + s20 * Lambda_inv_0_6_p173;
  const Real Lambda_inv_0_8_p2 = s20 * Lambda_inv_0_6_p175 - c20 * Lambda_inv_0_6_p173;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_8_p3 = s19 * Lambda_inv_0_8_p2 - c19 * Lambda_inv_0_6_p176;
  const Real Lambda_inv_0_8_p4 = 0.269 * Lambda_inv_0_8_p3;
  const Real Lambda_inv_0_8_p5 = 0.269 * Lambda_inv_0_8_p1;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_8_p6 = c18 * Lambda_inv_0_8_p4 - s18 * Lambda_inv_0_8_p5;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_8_p7 = s18 * Lambda_inv_0_8_p1 - c18 * Lambda_inv_0_8_p3 +
      inverse_D5_p82 * Lambda_inv_0_8_p6;
  const Real Lambda_inv_0_8_p8 = c19 * Lambda_inv_0_8_p2 + s19 * Lambda_inv_0_6_p176 -
      inverse_D5_p91 * Lambda_inv_0_8_p6;
  const Real Lambda_inv_0_8_p9 = s17 * Lambda_inv_0_8_p8 - c17 * Lambda_inv_0_8_p7;
  const Real Lambda_inv_0_8_p10 = s18 * Lambda_inv_0_8_p4 + c18 * Lambda_inv_0_8_p5 +
      inverse_D5_p49 * Lambda_inv_0_8_p6;
  const Real Lambda_inv_0_8_p11 = inverse_D5_p46 * Lambda_inv_0_8_p6;
  const Real Lambda_inv_0_8_p12 = c17 * Lambda_inv_0_8_p11 + s17 * Lambda_inv_0_8_p10;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_8_p13 = 0.282 * Lambda_inv_0_8_p9 - inverse_D15_p1 * Lambda_inv_0_8_p12;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_8_p14 = c18 * Lambda_inv_0_8_p1 + s18 * Lambda_inv_0_8_p3 -
      inverse_D5_p64 * Lambda_inv_0_8_p6;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_8_p15 = 0.282 * Lambda_inv_0_8_p14 - s17 * Lambda_inv_0_8_p11 + c17 *
      Lambda_inv_0_8_p10 + inverse_D15_p4 * Lambda_inv_0_8_p12;
  const Real Lambda_inv_0_8_p16 = s16 * Lambda_inv_0_8_p13 + c16 * Lambda_inv_0_8_p15;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_8_p17 = c16 * Lambda_inv_0_8_p13 - s16 * Lambda_inv_0_8_p15 +
      inverse_D14_p1 * Lambda_inv_0_8_p16;
  const Real Lambda_inv_0_8_p18 = Lambda_inv_0_6_p32 * Lambda_inv_0_8_p16;
  const Real Lambda_inv_0_8_p19 = c15 * Lambda_inv_0_8_p17 - s15 * Lambda_inv_0_8_p18;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_8_p20 = Lambda_inv_0_8_p14 + inverse_D5_p71 * Lambda_inv_0_8_p12;
  const Real Lambda_inv_0_8_p21 = Lambda_inv_0_8_p9 - inverse_D5_p99 * Lambda_inv_0_8_p12;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_8_p22 = c16 * Lambda_inv_0_8_p20 + s16 * Lambda_inv_0_8_p21 -
      inverse_D5_p140 * Lambda_inv_0_8_p16;
  const Real Lambda_inv_0_8_p23 = c17 * Lambda_inv_0_8_p8 + s17 * Lambda_inv_0_8_p7 +
      inverse_D5_p131 * Lambda_inv_0_8_p12 + inverse_D5_p137 * Lambda_inv_0_8_p16;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_0_8_p24 = s15 * Lambda_inv_0_8_p22 + c15 * Lambda_inv_0_8_p23 +
      inverse_D5_p147 * Lambda_inv_0_8_p19;
  const Real Lambda_inv_0_8_p25 = s16 * Lambda_inv_0_8_p20 - c16 * Lambda_inv_0_8_p21 -
      inverse_D5_p121 * Lambda_inv_0_8_p16 - inverse_D5_p127 * Lambda_inv_0_8_p19;
  const Real Lambda_inv_0_8_p26 = c14 * Lambda_inv_0_8_p24 + s14 * Lambda_inv_0_8_p25;
  const Real Lambda_inv_0_8_p27 = c15 * Lambda_inv_0_8_p22 - s15 * Lambda_inv_0_8_p23 +
      inverse_D5_p177 * Lambda_inv_0_8_p19;
  const Real Lambda_inv_0_8_p28 = s15 * Lambda_inv_0_8_p17 + c15 * Lambda_inv_0_8_p18 -
      inverse_D5_p365 * Lambda_inv_0_8_p19;
  const Real Lambda_inv_0_8_p29 = Lambda_inv_0_6_p44 * Lambda_inv_0_8_p19;
  const Real Lambda_inv_0_8_p30 = 0.18 * Lambda_inv_0_8_p26 + 0.226 * Lambda_inv_0_8_p27 + s14 *
      Lambda_inv_0_8_p28 - c14 * Lambda_inv_0_8_p29;
  const Real Lambda_inv_0_8_p31 = s14 * Lambda_inv_0_8_p24 - c14 * Lambda_inv_0_8_p25;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_8_p32 = Lambda_inv_0_8_p31 - inverse_D5_p408 * Lambda_inv_0_8_p30;
  const Real Lambda_inv_0_8_p33 = 0.226 * Lambda_inv_0_8_p31 + inverse_D5_p383 * Lambda_inv_0_8_p30;
  const Real Lambda_inv_0_8_p34 = 0.18 * Lambda_inv_0_8_p31 - c14 * Lambda_inv_0_8_p28 - s14 *
      Lambda_inv_0_8_p29 - inverse_D5_p390 * Lambda_inv_0_8_p30;
  const Real Lambda_inv_0_8_p35 = 0.072 * Lambda_inv_0_8_p32 + c6 * Lambda_inv_0_8_p33 - s6 *
      Lambda_inv_0_8_p34;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_8_p36 = s6 * Lambda_inv_0_8_p33 + c6 * Lambda_inv_0_8_p34 -
      inverse_D1_p35 * Lambda_inv_0_8_p35;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_8_p37 = Lambda_inv_0_8_p27 + inverse_D1_p2 * Lambda_inv_0_8_p30;
  const Real Lambda_inv_0_8_p38 = Lambda_inv_0_8_p26 - inverse_D1_p11 * Lambda_inv_0_8_p30;
  const Real Lambda_inv_0_8_p39 = c6 * Lambda_inv_0_8_p37 - s6 * Lambda_inv_0_8_p38;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_8_p40 = 0.072 * Lambda_inv_0_8_p39 - inverse_D1_p25 * Lambda_inv_0_8_p35;
  const Real Lambda_inv_0_8_p41 = c5 * Lambda_inv_0_8_p36 + s5 * Lambda_inv_0_8_p40;
  const Real Lambda_inv_0_8_p42 = s6 * Lambda_inv_0_8_p37 + c6 * Lambda_inv_0_8_p38 -
      inverse_D1_p58 * Lambda_inv_0_8_p35;
  const Real Lambda_inv_0_8_p43 = Lambda_inv_0_8_p32 - inverse_D1_p54 * Lambda_inv_0_8_p35;
  const Real Lambda_inv_0_8_p44 = s5 * Lambda_inv_0_8_p42 + c5 * Lambda_inv_0_8_p43;
  const Real Lambda_inv_0_8_p45 = Lambda_inv_0_8_p39 - inverse_D1_p42 * Lambda_inv_0_8_p35;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_8_p46 = s4 * (0.21799999999999997 * Lambda_inv_0_8_p45 - s5 *
      Lambda_inv_0_8_p36 + c5 * Lambda_inv_0_8_p40 + inverse_D3_p3 * Lambda_inv_0_8_p41);
  const Real Lambda_inv_0_8_p47 = c4 * (0.21799999999999997 * Lambda_inv_0_8_p44 + inverse_D3_p1 *
      Lambda_inv_0_8_p41) - Lambda_inv_0_8_p46;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_8_p48 = c5 * Lambda_inv_0_8_p42 - s5 * Lambda_inv_0_8_p43 -
      inverse_D1_p83 * Lambda_inv_0_8_p41 - inverse_D1_p87 * Lambda_inv_0_8_p47;
  const Real Lambda_inv_0_8_p49 = s4 * (Lambda_inv_0_8_p45 + inverse_D1_p48 * Lambda_inv_0_8_p41) -
      c4 * (Lambda_inv_0_8_p44 + inverse_D1_p67 * Lambda_inv_0_8_p41) + inverse_D1_p89 *
      Lambda_inv_0_8_p47;
  const Real Lambda_inv_0_8_p50 = s3 * Lambda_inv_0_8_p48 - c3 * Lambda_inv_0_8_p49;
  const Real Lambda_inv_0_8_p51 = 0.422 * Lambda_inv_0_8_p50;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_8_p52 = s2 * (c3 * Lambda_inv_0_8_p48 + s3 * Lambda_inv_0_8_p49 +
      inverse_D1_p102 * Lambda_inv_0_8_p51) + c2 * (Lambda_inv_0_8_p50 - inverse_D1_p98 *
      Lambda_inv_0_8_p51);
  const Real Lambda_inv_0_8_p53 = 0.434 * Lambda_inv_0_8_p52;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_8_p54 = inverse_D1 * Lambda_inv_0_8_p53;

  // link 2 (thigh), force propagation
  const Real Lambda_inv_0_8_p55 = inverse_D2 * Lambda_inv_0_8_p51;

  // link 3 (hip), force propagation
  const Real Lambda_inv_0_8_p56 = inverse_D3 * Lambda_inv_0_8_p47;

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_8_p57 = inverse_D4 * Lambda_inv_0_8_p41;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_8_p58 = inverse_D5 * Lambda_inv_0_8_p35;

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_8_p59 = inverse_D6 * Lambda_inv_0_8_p30;

  // link 1 (calf), force propagation
  const Real Lambda_inv_0_8_p60 = Lambda_inv_0_4_p138 * Lambda_inv_0_8_p59 - Lambda_inv_0_4_p143 *
      Lambda_inv_0_8_p58 - Lambda_inv_0_4_p149 * Lambda_inv_0_8_p57 - Lambda_inv_0_4_p155 *
      Lambda_inv_0_8_p56 - Lambda_inv_0_4_p159 * Lambda_inv_0_8_p55;
  const Real Lambda_inv_4_8_p1 = Lambda_inv_0_4_p60 * Lambda_inv_0_8_p59 - Lambda_inv_0_4_p65 *
      Lambda_inv_0_8_p58 - Lambda_inv_0_4_p71 * Lambda_inv_0_8_p57 - Lambda_inv_0_4_p77 *
      Lambda_inv_0_8_p56 - Lambda_inv_0_4_p81 * Lambda_inv_0_8_p55;
  const Real Lambda_inv_4_8 = Lambda_inv_4_8_p1 - Lambda_inv_0_4_p83 * Lambda_inv_0_8_p54 -
      Lambda_inv_4_9 * Lambda_inv_0_6_p248 - Lambda_inv_4_10 * Lambda_inv_0_7_p61;
  Lambda_inv[56] = -Lambda_inv_4_8;
  Lambda_inv[100] = -Lambda_inv_4_8;
  const Real Lambda_inv_0_8_p61 = Lambda_inv_0_8_p60 - Lambda_inv_0_4_p161 * Lambda_inv_0_8_p54 -
      Lambda_inv_0_7_p132 * Lambda_inv_0_6_p248 - Lambda_inv_0_6_p161 * Lambda_inv_0_7_p61 +
      Lambda_inv_0_4_p192 * Lambda_inv_4_8;
  const Real Lambda_inv_5_8_p1 = Lambda_inv_4_5_p42 * Lambda_inv_0_8_p59 - Lambda_inv_4_5_p47 *
      Lambda_inv_0_8_p58 - Lambda_inv_4_5_p53 * Lambda_inv_0_8_p57 - Lambda_inv_4_5_p59 *
      Lambda_inv_0_8_p56 - Lambda_inv_4_5_p63 * Lambda_inv_0_8_p55;
  const Real Lambda_inv_5_8 = Lambda_inv_5_8_p1 - Lambda_inv_4_5_p65 * Lambda_inv_0_8_p54 -
      Lambda_inv_5_9 * Lambda_inv_0_6_p248 - Lambda_inv_5_10 * Lambda_inv_0_7_p61;
  Lambda_inv[68] = -Lambda_inv_5_8;
  Lambda_inv[101] = -Lambda_inv_5_8;
  const Real Lambda_inv_0_8 = Lambda_inv_0_8_p61 - Lambda_inv_0_4_p193 * Lambda_inv_5_8;
  Lambda_inv[8] = Lambda_inv_0_8;
  Lambda_inv[96] = Lambda_inv_0_8;
  const Real Lambda_inv_0_9 = Lambda_inv_0_7_p132 + Lambda_inv_4_9 * Lambda_inv_0_4_p192 -
      Lambda_inv_5_9 * Lambda_inv_0_4_p193;
  Lambda_inv[9] = Lambda_inv_0_9;
  Lambda_inv[108] = Lambda_inv_0_9;
  const Real Lambda_inv_0_10 = Lambda_inv_0_6_p161 + Lambda_inv_4_10 * Lambda_inv_0_4_p192 -
      Lambda_inv_5_10 * Lambda_inv_0_4_p193;
  Lambda_inv[10] = Lambda_inv_0_10;
  Lambda_inv[120] = Lambda_inv_0_10;
  const Real Lambda_inv_0_11 = Lambda_inv_0_6_p247 + Lambda_inv_4_11 * Lambda_inv_0_4_p192 -
      Lambda_inv_5_11 * Lambda_inv_0_4_p193;
  Lambda_inv[11] = Lambda_inv_0_11;
  Lambda_inv[132] = Lambda_inv_0_11;
  const Real Lambda_inv_1_5 = Lambda_inv_0_1_p72 - Lambda_inv_5_5 * Lambda_inv_0_1_p57 -
      Lambda_inv_3_5 * Lambda_inv_0_4_p192;
  Lambda_inv[17] = -Lambda_inv_1_5;
  Lambda_inv[61] = -Lambda_inv_1_5;
  const Real Lambda_inv_1_1_p1 = Lambda_inv_0_1_p6 * Lambda_inv_0_1_p67 + Lambda_inv_0_1_p9 *
      Lambda_inv_0_1_p66 + Lambda_inv_0_1_p16 * Lambda_inv_0_1_p65 + Lambda_inv_0_1_p19 *
      Lambda_inv_0_1_p64 - Lambda_inv_0_1_p30 * Lambda_inv_0_1_p63;
  const Real Lambda_inv_1_1_p2 = Lambda_inv_1_1_p1 - Lambda_inv_0_1_p35 * Lambda_inv_0_1_p62 -
      Lambda_inv_0_1_p41 * Lambda_inv_0_1_p61 - Lambda_inv_0_1_p47 * Lambda_inv_0_1_p60 -
      Lambda_inv_0_1_p51 * Lambda_inv_0_1_p59;
  const Real Lambda_inv_1_3_p1 = Lambda_inv_0_1_p6 * Lambda_inv_0_3_p11 + Lambda_inv_0_1_p9 *
      Lambda_inv_0_3_p10 + Lambda_inv_0_1_p16 * Lambda_inv_0_3_p9 + Lambda_inv_0_1_p19 *
      Lambda_inv_0_3_p8 - Lambda_inv_0_1_p30 * Lambda_inv_0_3_p7;
  const Real Lambda_inv_1_3_p2 = Lambda_inv_1_3_p1 - Lambda_inv_0_1_p35 * Lambda_inv_0_3_p6 -
      Lambda_inv_0_1_p41 * Lambda_inv_0_3_p5 - Lambda_inv_0_1_p47 * Lambda_inv_0_3_p4 -
      Lambda_inv_0_1_p51 * Lambda_inv_0_3_p3;
  const Real Lambda_inv_1_3_p3 = Lambda_inv_1_3_p2 - Lambda_inv_0_1_p53 * Lambda_inv_0_3_p2;
  const Real Lambda_inv_3_3_p1 = Lambda_inv_0_4_p110 * (1065.380700001509 * Lambda_inv_0_4_p110) +
      Lambda_inv_3_4_p3 * (inverse_D12 * Lambda_inv_3_4_p3) + Lambda_inv_3_4_p10 *
      (inverse_D11 * Lambda_inv_3_4_p10);
  const Real Lambda_inv_3_3_p2 = Lambda_inv_3_3_p1 - Lambda_inv_3_4_p14 * Lambda_inv_0_3_p11 -
      Lambda_inv_3_4_p22 * Lambda_inv_0_3_p10 - Lambda_inv_3_4_p26 * Lambda_inv_0_3_p9 -
      Lambda_inv_3_4_p33 * Lambda_inv_0_3_p8;
  const Real Lambda_inv_3_3_p3 = Lambda_inv_3_3_p2 + Lambda_inv_3_4_p40 * Lambda_inv_0_3_p7 +
      Lambda_inv_3_4_p45 * Lambda_inv_0_3_p6 + Lambda_inv_3_4_p51 * Lambda_inv_0_3_p5 +
      Lambda_inv_3_4_p57 * Lambda_inv_0_3_p4;
  const Real Lambda_inv_3_3 = Lambda_inv_3_3_p3 + Lambda_inv_3_4_p61 * Lambda_inv_0_3_p3 +
      Lambda_inv_3_4_p63 * Lambda_inv_0_3_p2;
  Lambda_inv[39] = Lambda_inv_3_3;
  const Real Lambda_inv_1_3 = Lambda_inv_1_3_p3 - Lambda_inv_3_5 * Lambda_inv_0_1_p57 -
      Lambda_inv_3_3 * Lambda_inv_0_4_p192;
  Lambda_inv[15] = -Lambda_inv_1_3;
  Lambda_inv[37] = -Lambda_inv_1_3;
  Lambda_inv[13] = -(Lambda_inv_1_1_p2 - Lambda_inv_0_1_p53 * Lambda_inv_0_1_p58 +
      Lambda_inv_0_1_p57 * (Lambda_inv_0_1_p72 + Lambda_inv_1_5) + Lambda_inv_0_4_p192 *
      (Lambda_inv_1_3_p3 + Lambda_inv_1_3));
  const Real Lambda_inv_1_4_p1 = Lambda_inv_4_5 * Lambda_inv_0_1_p57;
  const Real Lambda_inv_1_4 = Lambda_inv_1_4_p1 - (Lambda_inv_0_1_p56 - Lambda_inv_0_3_p1);
  Lambda_inv[16] = Lambda_inv_1_4;
  Lambda_inv[49] = Lambda_inv_1_4;
  const Real Lambda_inv_1_2_p1 = Lambda_inv_0_1_p6 * Lambda_inv_0_2_p66 + Lambda_inv_0_1_p9 *
      Lambda_inv_0_2_p65 + Lambda_inv_0_1_p16 * Lambda_inv_0_2_p64 + Lambda_inv_0_1_p19 *
      Lambda_inv_0_2_p63 - Lambda_inv_0_1_p30 * Lambda_inv_0_2_p62;
  const Real Lambda_inv_1_2_p2 = Lambda_inv_1_2_p1 - Lambda_inv_0_1_p35 * Lambda_inv_0_2_p61 -
      Lambda_inv_0_1_p41 * Lambda_inv_0_2_p60 - Lambda_inv_0_1_p47 * Lambda_inv_0_2_p59 -
      Lambda_inv_0_1_p51 * Lambda_inv_0_2_p58;
  const Real Lambda_inv_1_2_p3 = Lambda_inv_0_2_p6 * Lambda_inv_0_3_p11 + Lambda_inv_0_2_p12 *
      Lambda_inv_0_3_p10 + Lambda_inv_0_2_p16 * Lambda_inv_0_3_p9 + Lambda_inv_0_2_p19 *
      Lambda_inv_0_3_p8 - Lambda_inv_0_2_p30 * Lambda_inv_0_3_p7;
  const Real Lambda_inv_1_2_p4 = Lambda_inv_1_2_p3 - Lambda_inv_0_2_p35 * Lambda_inv_0_3_p6 -
      Lambda_inv_0_2_p41 * Lambda_inv_0_3_p5 - Lambda_inv_0_2_p47 * Lambda_inv_0_3_p4 -
      Lambda_inv_0_2_p51 * Lambda_inv_0_3_p3;
  const Real Lambda_inv_1_2_p5 = Lambda_inv_1_2_p4 - Lambda_inv_0_2_p53 * Lambda_inv_0_3_p2;
  const Real Lambda_inv_1_2 = Lambda_inv_0_1_p57 * (Lambda_inv_0_2_p56 + Lambda_inv_1_4) +
      (Lambda_inv_1_2_p2 - Lambda_inv_0_1_p53 * Lambda_inv_0_2_p57 - Lambda_inv_0_4_p193 *
      Lambda_inv_1_3 + Lambda_inv_1_2_p5 * Lambda_inv_0_4_p192);
  Lambda_inv[14] = -Lambda_inv_1_2;
  Lambda_inv[25] = -Lambda_inv_1_2;
  const Real Lambda_inv_1_6_p1 = Lambda_inv_0_1_p30 * Lambda_inv_0_6_p75 - Lambda_inv_0_1_p35 *
      Lambda_inv_0_6_p74 - Lambda_inv_0_1_p41 * Lambda_inv_0_6_p73 - Lambda_inv_0_1_p47 *
      Lambda_inv_0_6_p72 - Lambda_inv_0_1_p51 * Lambda_inv_0_6_p71;
  const Real Lambda_inv_1_6_p2 = Lambda_inv_0_1_p30 * Lambda_inv_0_6_p159 - Lambda_inv_0_1_p35 *
      Lambda_inv_0_6_p158 - Lambda_inv_0_1_p41 * Lambda_inv_0_6_p157 - Lambda_inv_0_1_p47 *
      Lambda_inv_0_6_p156 - Lambda_inv_0_1_p51 * Lambda_inv_0_6_p155;
  const Real Lambda_inv_1_6_p3 = Lambda_inv_1_6_p2 - Lambda_inv_0_1_p53 * Lambda_inv_0_6_p154;
  const Real Lambda_inv_1_6_p4 = Lambda_inv_0_1_p30 * Lambda_inv_0_6_p245 - Lambda_inv_0_1_p35 *
      Lambda_inv_0_6_p244 - Lambda_inv_0_1_p41 * Lambda_inv_0_6_p243 - Lambda_inv_0_1_p47 *
      Lambda_inv_0_6_p242 - Lambda_inv_0_1_p51 * Lambda_inv_0_6_p241;
  const Real Lambda_inv_1_6_p5 = Lambda_inv_1_6_p4 - Lambda_inv_0_1_p53 * Lambda_inv_0_6_p240;
  const Real Lambda_inv_1_6_p6 = Lambda_inv_1_6_p1 - Lambda_inv_0_1_p53 * Lambda_inv_0_6_p70 +
      Lambda_inv_1_6_p3 * Lambda_inv_0_6_p174 - Lambda_inv_1_6_p5 * Lambda_inv_0_6_p248 +
      Lambda_inv_0_1_p57 * Lambda_inv_5_6;
  const Real Lambda_inv_3_6_p1 = Lambda_inv_3_4_p40 * Lambda_inv_0_6_p75 - Lambda_inv_3_4_p45 *
      Lambda_inv_0_6_p74 - Lambda_inv_3_4_p51 * Lambda_inv_0_6_p73 - Lambda_inv_3_4_p57 *
      Lambda_inv_0_6_p72 - Lambda_inv_3_4_p61 * Lambda_inv_0_6_p71;
  const Real Lambda_inv_3_10_p1 = Lambda_inv_3_4_p40 * Lambda_inv_0_6_p159 - Lambda_inv_3_4_p45 *
      Lambda_inv_0_6_p158 - Lambda_inv_3_4_p51 * Lambda_inv_0_6_p157 - Lambda_inv_3_4_p57 *
      Lambda_inv_0_6_p156 - Lambda_inv_3_4_p61 * Lambda_inv_0_6_p155;
  const Real Lambda_inv_3_10 = Lambda_inv_3_10_p1 - Lambda_inv_3_4_p63 * Lambda_inv_0_6_p154;
  Lambda_inv[46] = -Lambda_inv_3_10;
  Lambda_inv[123] = -Lambda_inv_3_10;
  const Real Lambda_inv_3_11_p1 = Lambda_inv_3_4_p40 * Lambda_inv_0_6_p245 - Lambda_inv_3_4_p45 *
      Lambda_inv_0_6_p244 - Lambda_inv_3_4_p51 * Lambda_inv_0_6_p243 - Lambda_inv_3_4_p57 *
      Lambda_inv_0_6_p242 - Lambda_inv_3_4_p61 * Lambda_inv_0_6_p241;
  const Real Lambda_inv_3_11 = Lambda_inv_3_11_p1 - Lambda_inv_3_4_p63 * Lambda_inv_0_6_p240;
  Lambda_inv[47] = -Lambda_inv_3_11;
  Lambda_inv[135] = -Lambda_inv_3_11;
  const Real Lambda_inv_3_6 = Lambda_inv_3_6_p1 - Lambda_inv_3_4_p63 * Lambda_inv_0_6_p70 +
      Lambda_inv_3_10 * Lambda_inv_0_6_p174 - Lambda_inv_3_11 * Lambda_inv_0_6_p248;
  Lambda_inv[42] = Lambda_inv_3_6;
  Lambda_inv[75] = Lambda_inv_3_6;
  const Real Lambda_inv_1_6 = Lambda_inv_1_6_p6 + Lambda_inv_0_4_p192 * Lambda_inv_3_6;
  Lambda_inv[18] = Lambda_inv_1_6;
  Lambda_inv[73] = Lambda_inv_1_6;
  const Real Lambda_inv_1_7_p1 = Lambda_inv_0_1_p30 * Lambda_inv_0_7_p59 - Lambda_inv_0_1_p35 *
      Lambda_inv_0_7_p58 - Lambda_inv_0_1_p41 * Lambda_inv_0_7_p57 - Lambda_inv_0_1_p47 *
      Lambda_inv_0_7_p56 - Lambda_inv_0_1_p51 * Lambda_inv_0_7_p55;
  const Real Lambda_inv_1_7_p2 = Lambda_inv_0_1_p30 * Lambda_inv_0_7_p130 - Lambda_inv_0_1_p35 *
      Lambda_inv_0_7_p129 - Lambda_inv_0_1_p41 * Lambda_inv_0_7_p128 - Lambda_inv_0_1_p47 *
      Lambda_inv_0_7_p127 - Lambda_inv_0_1_p51 * Lambda_inv_0_7_p126;
  const Real Lambda_inv_1_7_p3 = Lambda_inv_1_7_p2 - Lambda_inv_0_1_p53 * Lambda_inv_0_7_p125;
  const Real Lambda_inv_1_7_p4 = Lambda_inv_1_7_p1 - Lambda_inv_0_1_p53 * Lambda_inv_0_7_p54 +
      Lambda_inv_1_6_p5 * Lambda_inv_0_7_p61 + Lambda_inv_1_7_p3 * Lambda_inv_0_6_p174 +
      Lambda_inv_0_1_p57 * Lambda_inv_5_7;
  const Real Lambda_inv_3_7_p1 = Lambda_inv_3_4_p40 * Lambda_inv_0_7_p59 - Lambda_inv_3_4_p45 *
      Lambda_inv_0_7_p58 - Lambda_inv_3_4_p51 * Lambda_inv_0_7_p57 - Lambda_inv_3_4_p57 *
      Lambda_inv_0_7_p56 - Lambda_inv_3_4_p61 * Lambda_inv_0_7_p55;
  const Real Lambda_inv_3_9_p1 = Lambda_inv_3_4_p40 * Lambda_inv_0_7_p130 - Lambda_inv_3_4_p45 *
      Lambda_inv_0_7_p129 - Lambda_inv_3_4_p51 * Lambda_inv_0_7_p128 - Lambda_inv_3_4_p57 *
      Lambda_inv_0_7_p127 - Lambda_inv_3_4_p61 * Lambda_inv_0_7_p126;
  const Real Lambda_inv_3_9 = Lambda_inv_3_9_p1 - Lambda_inv_3_4_p63 * Lambda_inv_0_7_p125;
  Lambda_inv[45] = -Lambda_inv_3_9;
  Lambda_inv[111] = -Lambda_inv_3_9;
  const Real Lambda_inv_3_7 = Lambda_inv_3_7_p1 - Lambda_inv_3_4_p63 * Lambda_inv_0_7_p54 +
      Lambda_inv_3_11 * Lambda_inv_0_7_p61 + Lambda_inv_3_9 * Lambda_inv_0_6_p174;
  Lambda_inv[43] = -Lambda_inv_3_7;
  Lambda_inv[87] = -Lambda_inv_3_7;
  const Real Lambda_inv_1_7 = Lambda_inv_1_7_p4 + Lambda_inv_0_4_p192 * Lambda_inv_3_7;
  Lambda_inv[19] = -Lambda_inv_1_7;
  Lambda_inv[85] = -Lambda_inv_1_7;
  const Real Lambda_inv_1_8_p1 = Lambda_inv_0_1_p30 * Lambda_inv_0_8_p59 - Lambda_inv_0_1_p35 *
      Lambda_inv_0_8_p58 - Lambda_inv_0_1_p41 * Lambda_inv_0_8_p57 - Lambda_inv_0_1_p47 *
      Lambda_inv_0_8_p56 - Lambda_inv_0_1_p51 * Lambda_inv_0_8_p55;
  const Real Lambda_inv_1_8_p2 = Lambda_inv_1_8_p1 - Lambda_inv_0_1_p53 * Lambda_inv_0_8_p54 -
      Lambda_inv_1_7_p3 * Lambda_inv_0_6_p248 - Lambda_inv_1_6_p3 * Lambda_inv_0_7_p61 +
      Lambda_inv_0_1_p57 * Lambda_inv_5_8;
  const Real Lambda_inv_3_8_p1 = Lambda_inv_3_4_p40 * Lambda_inv_0_8_p59 - Lambda_inv_3_4_p45 *
      Lambda_inv_0_8_p58 - Lambda_inv_3_4_p51 * Lambda_inv_0_8_p57 - Lambda_inv_3_4_p57 *
      Lambda_inv_0_8_p56 - Lambda_inv_3_4_p61 * Lambda_inv_0_8_p55;
  const Real Lambda_inv_3_8 = Lambda_inv_3_8_p1 - Lambda_inv_3_4_p63 * Lambda_inv_0_8_p54 -
      Lambda_inv_3_9 * Lambda_inv_0_6_p248 - Lambda_inv_3_10 * Lambda_inv_0_7_p61;
  Lambda_inv[44] = -Lambda_inv_3_8;
  Lambda_inv[99] = -Lambda_inv_3_8;
  const Real Lambda_inv_1_8 = Lambda_inv_1_8_p2 + Lambda_inv_0_4_p192 * Lambda_inv_3_8;
  Lambda_inv[20] = -Lambda_inv_1_8;
  Lambda_inv[97] = -Lambda_inv_1_8;
  const Real Lambda_inv_1_9 = Lambda_inv_1_7_p3 + Lambda_inv_5_9 * Lambda_inv_0_1_p57 +
      Lambda_inv_3_9 * Lambda_inv_0_4_p192;
  Lambda_inv[21] = -Lambda_inv_1_9;
  Lambda_inv[109] = -Lambda_inv_1_9;
  const Real Lambda_inv_1_10 = Lambda_inv_1_6_p3 + Lambda_inv_5_10 * Lambda_inv_0_1_p57 +
      Lambda_inv_3_10 * Lambda_inv_0_4_p192;
  Lambda_inv[22] = -Lambda_inv_1_10;
  Lambda_inv[121] = -Lambda_inv_1_10;
  const Real Lambda_inv_1_11 = Lambda_inv_1_6_p5 + Lambda_inv_5_11 * Lambda_inv_0_1_p57 +
      Lambda_inv_3_11 * Lambda_inv_0_4_p192;
  Lambda_inv[23] = -Lambda_inv_1_11;
  Lambda_inv[133] = -Lambda_inv_1_11;
  const Real Lambda_inv_2_3 = Lambda_inv_1_2_p5 + Lambda_inv_3_3 * Lambda_inv_0_4_p193 +
      Lambda_inv_3_4 * Lambda_inv_0_1_p57;
  Lambda_inv[27] = -Lambda_inv_2_3;
  Lambda_inv[38] = -Lambda_inv_2_3;
  const Real Lambda_inv_2_2_p1 = Lambda_inv_0_2_p6 * Lambda_inv_0_2_p66 + Lambda_inv_0_2_p12 *
      Lambda_inv_0_2_p65 + Lambda_inv_0_2_p16 * Lambda_inv_0_2_p64 + Lambda_inv_0_2_p19 *
      Lambda_inv_0_2_p63 - Lambda_inv_0_2_p30 * Lambda_inv_0_2_p62;
  const Real Lambda_inv_2_2_p2 = Lambda_inv_2_2_p1 - Lambda_inv_0_2_p35 * Lambda_inv_0_2_p61 -
      Lambda_inv_0_2_p41 * Lambda_inv_0_2_p60 - Lambda_inv_0_2_p47 * Lambda_inv_0_2_p59 -
      Lambda_inv_0_2_p51 * Lambda_inv_0_2_p58;
  const Real Lambda_inv_2_4 = Lambda_inv_0_2_p71 + Lambda_inv_3_4 * Lambda_inv_0_4_p193 +
      Lambda_inv_4_4 * Lambda_inv_0_1_p57;
  Lambda_inv[28] = -Lambda_inv_2_4;
  Lambda_inv[50] = -Lambda_inv_2_4;
  Lambda_inv[26] = -(Lambda_inv_2_2_p2 - Lambda_inv_0_2_p53 * Lambda_inv_0_2_p57 -
      Lambda_inv_0_4_p193 * (Lambda_inv_1_2_p5 + Lambda_inv_2_3) - Lambda_inv_0_1_p57 *
      (Lambda_inv_0_2_p71 + Lambda_inv_2_4));
  const Real Lambda_inv_2_5 = Lambda_inv_1_4_p1 + (Lambda_inv_0_2_p56 + Lambda_inv_0_3_p14);
  Lambda_inv[29] = -Lambda_inv_2_5;
  Lambda_inv[62] = -Lambda_inv_2_5;
  const Real Lambda_inv_2_6_p1 = Lambda_inv_0_2_p30 * Lambda_inv_0_6_p75 - Lambda_inv_0_2_p35 *
      Lambda_inv_0_6_p74 - Lambda_inv_0_2_p41 * Lambda_inv_0_6_p73 - Lambda_inv_0_2_p47 *
      Lambda_inv_0_6_p72 - Lambda_inv_0_2_p51 * Lambda_inv_0_6_p71;
  const Real Lambda_inv_2_6_p2 = Lambda_inv_0_2_p30 * Lambda_inv_0_6_p159 - Lambda_inv_0_2_p35 *
      Lambda_inv_0_6_p158 - Lambda_inv_0_2_p41 * Lambda_inv_0_6_p157 - Lambda_inv_0_2_p47 *
      Lambda_inv_0_6_p156 - Lambda_inv_0_2_p51 * Lambda_inv_0_6_p155;
  const Real Lambda_inv_2_6_p3 = Lambda_inv_2_6_p2 - Lambda_inv_0_2_p53 * Lambda_inv_0_6_p154;
  const Real Lambda_inv_2_6_p4 = Lambda_inv_0_2_p30 * Lambda_inv_0_6_p245 - Lambda_inv_0_2_p35 *
      Lambda_inv_0_6_p244 - Lambda_inv_0_2_p41 * Lambda_inv_0_6_p243 - Lambda_inv_0_2_p47 *
      Lambda_inv_0_6_p242 - Lambda_inv_0_2_p51 * Lambda_inv_0_6_p241;
  const Real Lambda_inv_2_6_p5 = Lambda_inv_2_6_p4 - Lambda_inv_0_2_p53 * Lambda_inv_0_6_p240;
  const Real Lambda_inv_2_6_p6 = Lambda_inv_2_6_p1 - Lambda_inv_0_2_p53 * Lambda_inv_0_6_p70 +
      Lambda_inv_2_6_p3 * Lambda_inv_0_6_p174 - Lambda_inv_2_6_p5 * Lambda_inv_0_6_p248 -
      Lambda_inv_0_4_p193 * Lambda_inv_3_6;
  const Real Lambda_inv_2_6 = Lambda_inv_2_6_p6 - Lambda_inv_0_1_p57 * Lambda_inv_4_6;
  Lambda_inv[30] = Lambda_inv_2_6;
  Lambda_inv[74] = Lambda_inv_2_6;
  const Real Lambda_inv_2_7_p1 = Lambda_inv_0_2_p30 * Lambda_inv_0_7_p59 - Lambda_inv_0_2_p35 *
      Lambda_inv_0_7_p58 - Lambda_inv_0_2_p41 * Lambda_inv_0_7_p57 - Lambda_inv_0_2_p47 *
      Lambda_inv_0_7_p56 - Lambda_inv_0_2_p51 * Lambda_inv_0_7_p55;
  const Real Lambda_inv_2_7_p2 = Lambda_inv_0_2_p30 * Lambda_inv_0_7_p130 - Lambda_inv_0_2_p35 *
      Lambda_inv_0_7_p129 - Lambda_inv_0_2_p41 * Lambda_inv_0_7_p128 - Lambda_inv_0_2_p47 *
      Lambda_inv_0_7_p127 - Lambda_inv_0_2_p51 * Lambda_inv_0_7_p126;
  const Real Lambda_inv_2_7_p3 = Lambda_inv_2_7_p2 - Lambda_inv_0_2_p53 * Lambda_inv_0_7_p125;
  const Real Lambda_inv_2_7_p4 = Lambda_inv_2_7_p1 - Lambda_inv_0_2_p53 * Lambda_inv_0_7_p54 +
      Lambda_inv_2_6_p5 * Lambda_inv_0_7_p61 + Lambda_inv_2_7_p3 * Lambda_inv_0_6_p174 -
      Lambda_inv_0_4_p193 * Lambda_inv_3_7;
  const Real Lambda_inv_2_7 = Lambda_inv_2_7_p4 - Lambda_inv_0_1_p57 * Lambda_inv_4_7;
  Lambda_inv[31] = -Lambda_inv_2_7;
  Lambda_inv[86] = -Lambda_inv_2_7;
  const Real Lambda_inv_2_8_p1 = Lambda_inv_0_2_p30 * Lambda_inv_0_8_p59 - Lambda_inv_0_2_p35 *
      Lambda_inv_0_8_p58 - Lambda_inv_0_2_p41 * Lambda_inv_0_8_p57 - Lambda_inv_0_2_p47 *
      Lambda_inv_0_8_p56 - Lambda_inv_0_2_p51 * Lambda_inv_0_8_p55;
  const Real Lambda_inv_2_8_p2 = Lambda_inv_2_8_p1 - Lambda_inv_0_2_p53 * Lambda_inv_0_8_p54 -
      Lambda_inv_2_7_p3 * Lambda_inv_0_6_p248 - Lambda_inv_2_6_p3 * Lambda_inv_0_7_p61 -
      Lambda_inv_0_4_p193 * Lambda_inv_3_8;
  const Real Lambda_inv_2_8 = Lambda_inv_2_8_p2 - Lambda_inv_0_1_p57 * Lambda_inv_4_8;
  Lambda_inv[32] = -Lambda_inv_2_8;
  Lambda_inv[98] = -Lambda_inv_2_8;
  const Real Lambda_inv_2_9 = Lambda_inv_2_7_p3 - Lambda_inv_3_9 * Lambda_inv_0_4_p193 -
      Lambda_inv_4_9 * Lambda_inv_0_1_p57;
  Lambda_inv[33] = -Lambda_inv_2_9;
  Lambda_inv[110] = -Lambda_inv_2_9;
  const Real Lambda_inv_2_10 = Lambda_inv_2_6_p3 - Lambda_inv_3_10 * Lambda_inv_0_4_p193 -
      Lambda_inv_4_10 * Lambda_inv_0_1_p57;
  Lambda_inv[34] = -Lambda_inv_2_10;
  Lambda_inv[122] = -Lambda_inv_2_10;
  const Real Lambda_inv_2_11 = Lambda_inv_2_6_p5 - Lambda_inv_3_11 * Lambda_inv_0_4_p193 -
      Lambda_inv_4_11 * Lambda_inv_0_1_p57;
  Lambda_inv[35] = -Lambda_inv_2_11;
  Lambda_inv[134] = -Lambda_inv_2_11;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_6_10_p1 = inverse_D14 * Lambda_inv_0_6_p119;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_6_10_p2 = inverse_D15 * Lambda_inv_0_6_p116;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_6_10_p3 = minus_inverse_D16 * Lambda_inv_0_6_p112;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_6_10_p4 = inverse_D17 * Lambda_inv_0_6_p104;

  // link 1 (calf), force propagation
  const Real Lambda_inv_6_10_p5 = Lambda_inv_0_6_p20 * Lambda_inv_6_10_p4 - Lambda_inv_0_6_p26 *
      Lambda_inv_6_10_p3 + Lambda_inv_0_6_p30 * Lambda_inv_6_10_p2 + Lambda_inv_0_6_p34 *
      Lambda_inv_6_10_p1 + Lambda_inv_0_6_p46 * Lambda_inv_0_6_p159;
  const Real Lambda_inv_6_10_p6 = Lambda_inv_6_10_p5 + Lambda_inv_0_6_p51 * Lambda_inv_0_6_p158 +
      Lambda_inv_0_6_p57 * Lambda_inv_0_6_p157 + Lambda_inv_0_6_p63 * Lambda_inv_0_6_p156 +
      Lambda_inv_0_6_p67 * Lambda_inv_0_6_p155;
  const Real Lambda_inv_6_10_p7 = Lambda_inv_6_10_p6 + Lambda_inv_0_6_p69 * Lambda_inv_0_6_p154;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_10_10_p1 = inverse_D18 * Lambda_inv_0_6_p100;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_10_10_p2 = minus_inverse_D19 * Lambda_inv_0_6_p93;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_10_10_p3 = 1065.380700001509 * Lambda_inv_0_6_p89;

  // link 1 (calf), force propagation
  const Real Lambda_inv_10_10_p4 = Lambda_inv_0_6_p89 * Lambda_inv_10_10_p3 - Lambda_inv_0_6_p93 *
      Lambda_inv_10_10_p2 + Lambda_inv_0_6_p100 * Lambda_inv_10_10_p1 + Lambda_inv_0_6_p104 *
      Lambda_inv_6_10_p4 - Lambda_inv_0_6_p112 * Lambda_inv_6_10_p3;
  const Real Lambda_inv_10_10_p5 = Lambda_inv_10_10_p4 + Lambda_inv_0_6_p116 * Lambda_inv_6_10_p2 +
      Lambda_inv_0_6_p119 * Lambda_inv_6_10_p1 + Lambda_inv_0_6_p130 * Lambda_inv_0_6_p159 +
      Lambda_inv_0_6_p135 * Lambda_inv_0_6_p158;
  const Real Lambda_inv_10_10 = Lambda_inv_10_10_p5 + Lambda_inv_0_6_p141 * Lambda_inv_0_6_p157 +
      Lambda_inv_0_6_p147 * Lambda_inv_0_6_p156 + Lambda_inv_0_6_p151 * Lambda_inv_0_6_p155 +
      Lambda_inv_0_6_p153 * Lambda_inv_0_6_p154;
  Lambda_inv[130] = Lambda_inv_10_10;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_10_11_p1 = inverse_D14 * Lambda_inv_0_6_p209;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_10_11_p2 = inverse_D15 * Lambda_inv_0_6_p202;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_10_11_p3 = minus_inverse_D16 * Lambda_inv_0_6_p198;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_10_11_p4 = inverse_D17 * Lambda_inv_0_6_p190;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_10_11_p5 = inverse_D18 * Lambda_inv_0_6_p186;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_10_11_p6 = minus_inverse_D19 * Lambda_inv_0_6_p179;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_10_11_p7 = 1065.380700001509 * Lambda_inv_0_6_p176;

  // link 1 (calf), force propagation
  const Real Lambda_inv_10_11_p8 = Lambda_inv_0_6_p89 * Lambda_inv_10_11_p7 - Lambda_inv_0_6_p93 *
      Lambda_inv_10_11_p6 + Lambda_inv_0_6_p100 * Lambda_inv_10_11_p5 + Lambda_inv_0_6_p104 *
      Lambda_inv_10_11_p4 - Lambda_inv_0_6_p112 * Lambda_inv_10_11_p3;
  const Real Lambda_inv_10_11_p9 = Lambda_inv_10_11_p8 + Lambda_inv_0_6_p116 * Lambda_inv_10_11_p2 +
      Lambda_inv_0_6_p119 * Lambda_inv_10_11_p1 + Lambda_inv_0_6_p130 * Lambda_inv_0_6_p245 +
      Lambda_inv_0_6_p135 * Lambda_inv_0_6_p244;
  const Real Lambda_inv_10_11 = Lambda_inv_10_11_p9 + Lambda_inv_0_6_p141 * Lambda_inv_0_6_p243 +
      Lambda_inv_0_6_p147 * Lambda_inv_0_6_p242 + Lambda_inv_0_6_p151 * Lambda_inv_0_6_p241 +
      Lambda_inv_0_6_p153 * Lambda_inv_0_6_p240;
  Lambda_inv[131] = Lambda_inv_10_11;
  Lambda_inv[142] = Lambda_inv_10_11;
  const Real Lambda_inv_6_10 = Lambda_inv_6_10_p7 + Lambda_inv_10_10 * Lambda_inv_0_6_p174 -
      Lambda_inv_10_11 * Lambda_inv_0_6_p248;
  Lambda_inv[82] = -Lambda_inv_6_10;
  Lambda_inv[126] = -Lambda_inv_6_10;
  const Real Lambda_inv_6_6_p1 = Lambda_inv_0_6_p20 * (inverse_D17 * Lambda_inv_0_6_p20) -
      Lambda_inv_0_6_p26 * (minus_inverse_D16 * Lambda_inv_0_6_p26) + Lambda_inv_0_6_p30 *
      (inverse_D15 * Lambda_inv_0_6_p30);
  const Real Lambda_inv_6_6_p2 = Lambda_inv_6_6_p1 + Lambda_inv_0_6_p34 *
      (inverse_D14 * Lambda_inv_0_6_p34) + Lambda_inv_0_6_p46 * Lambda_inv_0_6_p75 +
      Lambda_inv_0_6_p51 * Lambda_inv_0_6_p74 + Lambda_inv_0_6_p57 * Lambda_inv_0_6_p73;
  const Real Lambda_inv_6_6_p3 = Lambda_inv_6_6_p2 + Lambda_inv_0_6_p63 * Lambda_inv_0_6_p72 +
      Lambda_inv_0_6_p67 * Lambda_inv_0_6_p71 + Lambda_inv_0_6_p69 * Lambda_inv_0_6_p70 +
      Lambda_inv_0_6_p174 * (Lambda_inv_6_10_p7 + Lambda_inv_6_10);
  const Real Lambda_inv_6_11_p1 = Lambda_inv_0_6_p20 * Lambda_inv_10_11_p4 - Lambda_inv_0_6_p26 *
      Lambda_inv_10_11_p3 + Lambda_inv_0_6_p30 * Lambda_inv_10_11_p2 + Lambda_inv_0_6_p34 *
      Lambda_inv_10_11_p1 + Lambda_inv_0_6_p46 * Lambda_inv_0_6_p245;
  const Real Lambda_inv_6_11_p2 = Lambda_inv_6_11_p1 + Lambda_inv_0_6_p51 * Lambda_inv_0_6_p244 +
      Lambda_inv_0_6_p57 * Lambda_inv_0_6_p243 + Lambda_inv_0_6_p63 * Lambda_inv_0_6_p242 +
      Lambda_inv_0_6_p67 * Lambda_inv_0_6_p241;
  const Real Lambda_inv_6_11_p3 = Lambda_inv_6_11_p2 + Lambda_inv_0_6_p69 * Lambda_inv_0_6_p240;
  const Real Lambda_inv_11_11_p1 = Lambda_inv_0_6_p176 * Lambda_inv_10_11_p7 - Lambda_inv_0_6_p179 *
      Lambda_inv_10_11_p6 + Lambda_inv_0_6_p186 * Lambda_inv_10_11_p5 + Lambda_inv_0_6_p190 *
      Lambda_inv_10_11_p4 - Lambda_inv_0_6_p198 * Lambda_inv_10_11_p3;
  const Real Lambda_inv_11_11_p2 = Lambda_inv_11_11_p1 + Lambda_inv_0_6_p202 * Lambda_inv_10_11_p2 +
      Lambda_inv_0_6_p209 * Lambda_inv_10_11_p1 + Lambda_inv_0_6_p216 * Lambda_inv_0_6_p245 +
      Lambda_inv_0_6_p221 * Lambda_inv_0_6_p244;
  const Real Lambda_inv_11_11 = Lambda_inv_11_11_p2 + Lambda_inv_0_6_p227 * Lambda_inv_0_6_p243 +
      Lambda_inv_0_6_p233 * Lambda_inv_0_6_p242 + Lambda_inv_0_6_p237 * Lambda_inv_0_6_p241 +
      Lambda_inv_0_6_p239 * Lambda_inv_0_6_p240;
  Lambda_inv[143] = Lambda_inv_11_11;
  const Real Lambda_inv_6_11 = Lambda_inv_6_11_p3 + Lambda_inv_10_11 * Lambda_inv_0_6_p174 -
      Lambda_inv_11_11 * Lambda_inv_0_6_p248;
  Lambda_inv[83] = -Lambda_inv_6_11;
  Lambda_inv[138] = -Lambda_inv_6_11;
  Lambda_inv[78] = Lambda_inv_6_6_p3 - Lambda_inv_0_6_p248 * (Lambda_inv_6_11_p3 + Lambda_inv_6_11);
  const Real Lambda_inv_9_10_p1 = Lambda_inv_0_6_p16 * Lambda_inv_10_10_p3 + Lambda_inv_0_7_p64 *
      Lambda_inv_10_10_p2 - Lambda_inv_0_7_p71 * Lambda_inv_10_10_p1 + Lambda_inv_0_7_p75 *
      Lambda_inv_6_10_p4 - Lambda_inv_0_7_p83 * Lambda_inv_6_10_p3;
  const Real Lambda_inv_9_10_p2 = Lambda_inv_9_10_p1 + Lambda_inv_0_7_p87 * Lambda_inv_6_10_p2 +
      Lambda_inv_0_7_p94 * Lambda_inv_6_10_p1 + Lambda_inv_0_7_p101 * Lambda_inv_0_6_p159 +
      Lambda_inv_0_7_p106 * Lambda_inv_0_6_p158;
  const Real Lambda_inv_9_10 = Lambda_inv_9_10_p2 + Lambda_inv_0_7_p112 * Lambda_inv_0_6_p157 +
      Lambda_inv_0_7_p118 * Lambda_inv_0_6_p156 + Lambda_inv_0_7_p122 * Lambda_inv_0_6_p155 +
      Lambda_inv_0_7_p124 * Lambda_inv_0_6_p154;
  Lambda_inv[118] = Lambda_inv_9_10;
  Lambda_inv[129] = Lambda_inv_9_10;
  const Real Lambda_inv_6_9_p1 = Lambda_inv_9_10 * Lambda_inv_0_6_p174;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_6_9_p2 = inverse_D14 * Lambda_inv_0_7_p94;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_6_9_p3 = inverse_D15 * Lambda_inv_0_7_p87;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_6_9_p4 = minus_inverse_D16 * Lambda_inv_0_7_p83;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_6_9_p5 = inverse_D17 * Lambda_inv_0_7_p75;

  // link 1 (calf), force propagation
  const Real Lambda_inv_6_9_p6 = Lambda_inv_0_6_p20 * Lambda_inv_6_9_p5 - Lambda_inv_0_6_p26 *
      Lambda_inv_6_9_p4 + Lambda_inv_0_6_p30 * Lambda_inv_6_9_p3 + Lambda_inv_0_6_p34 *
      Lambda_inv_6_9_p2 + Lambda_inv_0_6_p46 * Lambda_inv_0_7_p130;
  const Real Lambda_inv_6_9_p7 = Lambda_inv_6_9_p6 + Lambda_inv_0_6_p51 * Lambda_inv_0_7_p129 +
      Lambda_inv_0_6_p57 * Lambda_inv_0_7_p128 + Lambda_inv_0_6_p63 * Lambda_inv_0_7_p127 +
      Lambda_inv_0_6_p67 * Lambda_inv_0_7_p126;
  const Real Lambda_inv_9_11_p1 = Lambda_inv_0_6_p16 * Lambda_inv_10_11_p7 + Lambda_inv_0_7_p64 *
      Lambda_inv_10_11_p6 - Lambda_inv_0_7_p71 * Lambda_inv_10_11_p5 + Lambda_inv_0_7_p75 *
      Lambda_inv_10_11_p4 - Lambda_inv_0_7_p83 * Lambda_inv_10_11_p3;
  const Real Lambda_inv_9_11_p2 = Lambda_inv_9_11_p1 + Lambda_inv_0_7_p87 * Lambda_inv_10_11_p2 +
      Lambda_inv_0_7_p94 * Lambda_inv_10_11_p1 + Lambda_inv_0_7_p101 * Lambda_inv_0_6_p245 +
      Lambda_inv_0_7_p106 * Lambda_inv_0_6_p244;
  const Real Lambda_inv_9_11 = Lambda_inv_9_11_p2 + Lambda_inv_0_7_p112 * Lambda_inv_0_6_p243 +
      Lambda_inv_0_7_p118 * Lambda_inv_0_6_p242 + Lambda_inv_0_7_p122 * Lambda_inv_0_6_p241 +
      Lambda_inv_0_7_p124 * Lambda_inv_0_6_p240;
  Lambda_inv[119] = Lambda_inv_9_11;
  Lambda_inv[141] = Lambda_inv_9_11;
  const Real Lambda_inv_6_9_p8 = Lambda_inv_9_11 * Lambda_inv_0_6_p248;
  const Real Lambda_inv_6_9 = Lambda_inv_6_9_p8 - (Lambda_inv_6_9_p1 +
      (Lambda_inv_6_9_p7 + Lambda_inv_0_6_p69 * Lambda_inv_0_7_p125));
  Lambda_inv[81] = Lambda_inv_6_9;
  Lambda_inv[114] = Lambda_inv_6_9;
  const Real Lambda_inv_6_7_p1 = Lambda_inv_0_7_p6 * Lambda_inv_6_10_p4 - Lambda_inv_0_7_p9 *
      Lambda_inv_6_10_p3 + Lambda_inv_0_7_p16 * Lambda_inv_6_10_p2 + Lambda_inv_0_7_p19 *
      Lambda_inv_6_10_p1 + Lambda_inv_0_7_p30 * Lambda_inv_0_6_p159;
  const Real Lambda_inv_6_7_p2 = Lambda_inv_6_7_p1 + Lambda_inv_0_7_p35 * Lambda_inv_0_6_p158 +
      Lambda_inv_0_7_p41 * Lambda_inv_0_6_p157 + Lambda_inv_0_7_p47 * Lambda_inv_0_6_p156 +
      Lambda_inv_0_7_p51 * Lambda_inv_0_6_p155;
  const Real Lambda_inv_6_7_p3 = Lambda_inv_6_7_p2 + Lambda_inv_0_7_p53 * Lambda_inv_0_6_p154;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_6_7_p4 = inverse_D14 * Lambda_inv_0_7_p19;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_6_7_p5 = inverse_D15 * Lambda_inv_0_7_p16;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_6_7_p6 = minus_inverse_D16 * Lambda_inv_0_7_p9;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_6_7_p7 = inverse_D17 * Lambda_inv_0_7_p6;

  // link 1 (calf), force propagation
  const Real Lambda_inv_6_7_p8 = Lambda_inv_0_6_p20 * Lambda_inv_6_7_p7 - Lambda_inv_0_6_p26 *
      Lambda_inv_6_7_p6 + Lambda_inv_0_6_p30 * Lambda_inv_6_7_p5 + Lambda_inv_0_6_p34 *
      Lambda_inv_6_7_p4 + Lambda_inv_0_6_p46 * Lambda_inv_0_7_p59;
  const Real Lambda_inv_6_7_p9 = Lambda_inv_6_7_p8 + Lambda_inv_0_6_p51 * Lambda_inv_0_7_p58 +
      Lambda_inv_0_6_p57 * Lambda_inv_0_7_p57 + Lambda_inv_0_6_p63 * Lambda_inv_0_7_p56 +
      Lambda_inv_0_6_p67 * Lambda_inv_0_7_p55;
  const Real Lambda_inv_6_7_p10 = Lambda_inv_0_7_p6 * Lambda_inv_10_11_p4 - Lambda_inv_0_7_p9 *
      Lambda_inv_10_11_p3 + Lambda_inv_0_7_p16 * Lambda_inv_10_11_p2 + Lambda_inv_0_7_p19 *
      Lambda_inv_10_11_p1 + Lambda_inv_0_7_p30 * Lambda_inv_0_6_p245;
  const Real Lambda_inv_6_7_p11 = Lambda_inv_6_7_p10 + Lambda_inv_0_7_p35 * Lambda_inv_0_6_p244 +
      Lambda_inv_0_7_p41 * Lambda_inv_0_6_p243 + Lambda_inv_0_7_p47 * Lambda_inv_0_6_p242 +
      Lambda_inv_0_7_p51 * Lambda_inv_0_6_p241;
  const Real Lambda_inv_6_7_p12 = Lambda_inv_6_7_p11 + Lambda_inv_0_7_p53 * Lambda_inv_0_6_p240;
  const Real Lambda_inv_6_7 = Lambda_inv_0_6_p174 * (Lambda_inv_6_7_p3 - Lambda_inv_6_9) +
      (Lambda_inv_6_7_p9 + Lambda_inv_0_6_p69 * Lambda_inv_0_7_p54 + Lambda_inv_0_7_p61 *
      Lambda_inv_6_11 - Lambda_inv_6_7_p12 * Lambda_inv_0_6_p248);
  Lambda_inv[79] = -Lambda_inv_6_7;
  Lambda_inv[90] = -Lambda_inv_6_7;
  const Real Lambda_inv_6_8_p1 = Lambda_inv_0_8_p6 * Lambda_inv_10_11_p4 - Lambda_inv_0_8_p12 *
      Lambda_inv_10_11_p3 + Lambda_inv_0_8_p16 * Lambda_inv_10_11_p2 + Lambda_inv_0_8_p19 *
      Lambda_inv_10_11_p1 + Lambda_inv_0_8_p30 * Lambda_inv_0_6_p245;
  const Real Lambda_inv_6_8_p2 = Lambda_inv_6_8_p1 + Lambda_inv_0_8_p35 * Lambda_inv_0_6_p244 +
      Lambda_inv_0_8_p41 * Lambda_inv_0_6_p243 + Lambda_inv_0_8_p47 * Lambda_inv_0_6_p242 +
      Lambda_inv_0_8_p51 * Lambda_inv_0_6_p241;
  const Real Lambda_inv_6_8_p3 = Lambda_inv_6_8_p2 + Lambda_inv_0_8_p53 * Lambda_inv_0_6_p240;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_6_8_p4 = inverse_D14 * Lambda_inv_0_8_p19;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_6_8_p5 = inverse_D15 * Lambda_inv_0_8_p16;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_6_8_p6 = minus_inverse_D16 * Lambda_inv_0_8_p12;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_6_8_p7 = inverse_D17 * Lambda_inv_0_8_p6;

  // link 1 (calf), force propagation
  const Real Lambda_inv_6_8_p8 = Lambda_inv_0_6_p20 * Lambda_inv_6_8_p7 - Lambda_inv_0_6_p26 *
      Lambda_inv_6_8_p6 + Lambda_inv_0_6_p30 * Lambda_inv_6_8_p5 + Lambda_inv_0_6_p34 *
      Lambda_inv_6_8_p4 + Lambda_inv_0_6_p46 * Lambda_inv_0_8_p59;
  const Real Lambda_inv_6_8_p9 = Lambda_inv_6_8_p8 + Lambda_inv_0_6_p51 * Lambda_inv_0_8_p58 +
      Lambda_inv_0_6_p57 * Lambda_inv_0_8_p57 + Lambda_inv_0_6_p63 * Lambda_inv_0_8_p56 +
      Lambda_inv_0_6_p67 * Lambda_inv_0_8_p55;
  const Real Lambda_inv_6_8_p10 = Lambda_inv_0_8_p6 * Lambda_inv_6_10_p4 - Lambda_inv_0_8_p12 *
      Lambda_inv_6_10_p3 + Lambda_inv_0_8_p16 * Lambda_inv_6_10_p2 + Lambda_inv_0_8_p19 *
      Lambda_inv_6_10_p1 + Lambda_inv_0_8_p30 * Lambda_inv_0_6_p159;
  const Real Lambda_inv_6_8_p11 = Lambda_inv_6_8_p10 + Lambda_inv_0_8_p35 * Lambda_inv_0_6_p158 +
      Lambda_inv_0_8_p41 * Lambda_inv_0_6_p157 + Lambda_inv_0_8_p47 * Lambda_inv_0_6_p156 +
      Lambda_inv_0_8_p51 * Lambda_inv_0_6_p155;
  const Real Lambda_inv_6_8_p12 = Lambda_inv_6_8_p11 + Lambda_inv_0_8_p53 * Lambda_inv_0_6_p154;
  const Real Lambda_inv_6_8 = Lambda_inv_0_6_p248 * (Lambda_inv_6_8_p3 - Lambda_inv_6_9) -
      (Lambda_inv_6_8_p9 + Lambda_inv_0_6_p69 * Lambda_inv_0_8_p54 - Lambda_inv_0_7_p61 *
      Lambda_inv_6_10 + Lambda_inv_6_8_p12 * Lambda_inv_0_6_p174);
  Lambda_inv[80] = Lambda_inv_6_8;
  Lambda_inv[102] = Lambda_inv_6_8;
  const Real Lambda_inv_7_11 = Lambda_inv_6_7_p12 + Lambda_inv_11_11 * Lambda_inv_0_7_p61 +
      Lambda_inv_9_11 * Lambda_inv_0_6_p174;
  Lambda_inv[95] = Lambda_inv_7_11;
  Lambda_inv[139] = Lambda_inv_7_11;
  const Real Lambda_inv_7_7_p1 = Lambda_inv_0_7_p6 * Lambda_inv_6_7_p7 - Lambda_inv_0_7_p9 *
      Lambda_inv_6_7_p6 + Lambda_inv_0_7_p16 * Lambda_inv_6_7_p5 + Lambda_inv_0_7_p19 *
      Lambda_inv_6_7_p4 + Lambda_inv_0_7_p30 * Lambda_inv_0_7_p59;
  const Real Lambda_inv_7_7_p2 = Lambda_inv_7_7_p1 + Lambda_inv_0_7_p35 * Lambda_inv_0_7_p58 +
      Lambda_inv_0_7_p41 * Lambda_inv_0_7_p57 + Lambda_inv_0_7_p47 * Lambda_inv_0_7_p56 +
      Lambda_inv_0_7_p51 * Lambda_inv_0_7_p55;
  const Real Lambda_inv_7_9_p1 = Lambda_inv_0_7_p6 * Lambda_inv_6_9_p5 - Lambda_inv_0_7_p9 *
      Lambda_inv_6_9_p4 + Lambda_inv_0_7_p16 * Lambda_inv_6_9_p3 + Lambda_inv_0_7_p19 *
      Lambda_inv_6_9_p2 + Lambda_inv_0_7_p30 * Lambda_inv_0_7_p130;
  const Real Lambda_inv_7_9_p2 = Lambda_inv_7_9_p1 + Lambda_inv_0_7_p35 * Lambda_inv_0_7_p129 +
      Lambda_inv_0_7_p41 * Lambda_inv_0_7_p128 + Lambda_inv_0_7_p47 * Lambda_inv_0_7_p127 +
      Lambda_inv_0_7_p51 * Lambda_inv_0_7_p126;
  const Real Lambda_inv_7_9_p3 = Lambda_inv_7_9_p2 + Lambda_inv_0_7_p53 * Lambda_inv_0_7_p125;
  const Real Lambda_inv_9_9_p1 = Lambda_inv_0_6_p16 * (1065.380700001509 * Lambda_inv_0_6_p16) -
      Lambda_inv_0_7_p64 * (minus_inverse_D19 * Lambda_inv_0_7_p64) + Lambda_inv_0_7_p71 *
      (inverse_D18 * Lambda_inv_0_7_p71);
  const Real Lambda_inv_9_9_p2 = Lambda_inv_9_9_p1 + Lambda_inv_0_7_p75 * Lambda_inv_6_9_p5 -
      Lambda_inv_0_7_p83 * Lambda_inv_6_9_p4 + Lambda_inv_0_7_p87 * Lambda_inv_6_9_p3 +
      Lambda_inv_0_7_p94 * Lambda_inv_6_9_p2;
  const Real Lambda_inv_9_9_p3 = Lambda_inv_9_9_p2 + Lambda_inv_0_7_p101 * Lambda_inv_0_7_p130 +
      Lambda_inv_0_7_p106 * Lambda_inv_0_7_p129 + Lambda_inv_0_7_p112 * Lambda_inv_0_7_p128 +
      Lambda_inv_0_7_p118 * Lambda_inv_0_7_p127;
  const Real Lambda_inv_9_9 = Lambda_inv_9_9_p3 + Lambda_inv_0_7_p122 * Lambda_inv_0_7_p126 +
      Lambda_inv_0_7_p124 * Lambda_inv_0_7_p125;
  Lambda_inv[117] = Lambda_inv_9_9;
  const Real Lambda_inv_7_9 = Lambda_inv_7_9_p3 + Lambda_inv_9_11 * Lambda_inv_0_7_p61 +
      Lambda_inv_9_9 * Lambda_inv_0_6_p174;
  Lambda_inv[93] = Lambda_inv_7_9;
  Lambda_inv[115] = Lambda_inv_7_9;
  Lambda_inv[91] = Lambda_inv_7_7_p2 + Lambda_inv_0_7_p53 * Lambda_inv_0_7_p54 +
      Lambda_inv_0_7_p61 * (Lambda_inv_6_7_p12 + Lambda_inv_7_11) + Lambda_inv_0_6_p174 *
      (Lambda_inv_7_9_p3 + Lambda_inv_7_9);
  const Real Lambda_inv_7_10_p1 = Lambda_inv_10_11 * Lambda_inv_0_7_p61;
  const Real Lambda_inv_7_10 = Lambda_inv_7_10_p1 + (Lambda_inv_6_7_p3 + Lambda_inv_6_9_p1);
  Lambda_inv[94] = Lambda_inv_7_10;
  Lambda_inv[127] = Lambda_inv_7_10;
  const Real Lambda_inv_7_8_p1 = Lambda_inv_0_7_p6 * Lambda_inv_6_8_p7 - Lambda_inv_0_7_p9 *
      Lambda_inv_6_8_p6 + Lambda_inv_0_7_p16 * Lambda_inv_6_8_p5 + Lambda_inv_0_7_p19 *
      Lambda_inv_6_8_p4 + Lambda_inv_0_7_p30 * Lambda_inv_0_8_p59;
  const Real Lambda_inv_7_8_p2 = Lambda_inv_7_8_p1 + Lambda_inv_0_7_p35 * Lambda_inv_0_8_p58 +
      Lambda_inv_0_7_p41 * Lambda_inv_0_8_p57 + Lambda_inv_0_7_p47 * Lambda_inv_0_8_p56 +
      Lambda_inv_0_7_p51 * Lambda_inv_0_8_p55;
  const Real Lambda_inv_7_8_p3 = Lambda_inv_0_8_p6 * Lambda_inv_6_9_p5 - Lambda_inv_0_8_p12 *
      Lambda_inv_6_9_p4 + Lambda_inv_0_8_p16 * Lambda_inv_6_9_p3 + Lambda_inv_0_8_p19 *
      Lambda_inv_6_9_p2 + Lambda_inv_0_8_p30 * Lambda_inv_0_7_p130;
  const Real Lambda_inv_7_8_p4 = Lambda_inv_7_8_p3 + Lambda_inv_0_8_p35 * Lambda_inv_0_7_p129 +
      Lambda_inv_0_8_p41 * Lambda_inv_0_7_p128 + Lambda_inv_0_8_p47 * Lambda_inv_0_7_p127 +
      Lambda_inv_0_8_p51 * Lambda_inv_0_7_p126;
  const Real Lambda_inv_7_8_p5 = Lambda_inv_7_8_p4 + Lambda_inv_0_8_p53 * Lambda_inv_0_7_p125;
  const Real Lambda_inv_7_8 = Lambda_inv_0_7_p61 * (Lambda_inv_6_8_p3 - Lambda_inv_7_10) +
      (Lambda_inv_7_8_p2 + Lambda_inv_0_7_p53 * Lambda_inv_0_8_p54 - Lambda_inv_0_6_p248 *
      Lambda_inv_7_9 + Lambda_inv_7_8_p5 * Lambda_inv_0_6_p174);
  Lambda_inv[92] = Lambda_inv_7_8;
  Lambda_inv[103] = Lambda_inv_7_8;
  const Real Lambda_inv_8_9 = Lambda_inv_7_8_p5 - Lambda_inv_9_9 * Lambda_inv_0_6_p248 -
      Lambda_inv_9_10 * Lambda_inv_0_7_p61;
  Lambda_inv[105] = Lambda_inv_8_9;
  Lambda_inv[116] = Lambda_inv_8_9;
  const Real Lambda_inv_8_8_p1 = Lambda_inv_0_8_p6 * Lambda_inv_6_8_p7 - Lambda_inv_0_8_p12 *
      Lambda_inv_6_8_p6 + Lambda_inv_0_8_p16 * Lambda_inv_6_8_p5 + Lambda_inv_0_8_p19 *
      Lambda_inv_6_8_p4 + Lambda_inv_0_8_p30 * Lambda_inv_0_8_p59;
  const Real Lambda_inv_8_8_p2 = Lambda_inv_8_8_p1 + Lambda_inv_0_8_p35 * Lambda_inv_0_8_p58 +
      Lambda_inv_0_8_p41 * Lambda_inv_0_8_p57 + Lambda_inv_0_8_p47 * Lambda_inv_0_8_p56 +
      Lambda_inv_0_8_p51 * Lambda_inv_0_8_p55;
  const Real Lambda_inv_8_10 = Lambda_inv_6_8_p12 - Lambda_inv_9_10 * Lambda_inv_0_6_p248 -
      Lambda_inv_10_10 * Lambda_inv_0_7_p61;
  Lambda_inv[106] = Lambda_inv_8_10;
  Lambda_inv[128] = Lambda_inv_8_10;
  Lambda_inv[104] = Lambda_inv_8_8_p2 + Lambda_inv_0_8_p53 * Lambda_inv_0_8_p54 -
      Lambda_inv_0_6_p248 * (Lambda_inv_7_8_p5 + Lambda_inv_8_9) - Lambda_inv_0_7_p61 *
      (Lambda_inv_6_8_p12 + Lambda_inv_8_10);
  const Real Lambda_inv_8_11 = Lambda_inv_7_10_p1 - (Lambda_inv_6_8_p3 - Lambda_inv_6_9_p8);
  Lambda_inv[107] = -Lambda_inv_8_11;
  Lambda_inv[140] = -Lambda_inv_8_11;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
