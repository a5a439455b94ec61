// lambda: Lambda = (J M^-1 J^T)^-1
// By unit forces propagated inward (PV-OSIM), in the axes asked for at link origins.
// 8144 flops (add 3536, mul 4564, div 44), sine and cosine of 24 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

void lambda(const Real (&TREELINE_RESTRICT q)[24], Real (&TREELINE_RESTRICT Lambda)[144]) noexcept {
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
  const Real Lambda_11_11_p1 = s4 * s5;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p2 = c4 * c6 + s6 * Lambda_11_11_p1;
  const Real Lambda_11_11_p3 = c4 * s6 - c6 * Lambda_11_11_p1;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p4 = s4 * c5;

  // link 7 (left_shoulder1), pose
  const Real Lambda_11_11_p5 = s7 * Lambda_11_11_p4 - c7 * Lambda_11_11_p3;

  // link 8 (left_shoulder2), pose
  const Real Lambda_11_11_p6 = s8 * Lambda_11_11_p2 - c8 * Lambda_11_11_p5;
  const Real Lambda_11_11_p7 = c8 * Lambda_11_11_p2 + s8 * Lambda_11_11_p5;

  // link 7 (left_shoulder1), pose
  const Real Lambda_11_11_p8 = c7 * Lambda_11_11_p4 + s7 * Lambda_11_11_p3;

  // link 9 (left_upperarm), pose
  const Real Lambda_11_11_p9 = c9 * Lambda_11_11_p8 + s9 * Lambda_11_11_p7;

  // link 10 (left_lowerarm), pose
  const Real Lambda_11_11_p10 = c10 * Lambda_11_11_p6 - s10 * Lambda_11_11_p9;
  const Real Lambda_11_11_p11 = s10 * Lambda_11_11_p6 + c10 * Lambda_11_11_p9;

  // link 9 (left_upperarm), pose
  const Real Lambda_11_11_p12 = s9 * Lambda_11_11_p8 - c9 * Lambda_11_11_p7;

  // link 11 (left_wrist1), pose
  const Real Lambda_11_11_p13 = s11 * Lambda_11_11_p12 - c11 * Lambda_11_11_p11;

  // link 12 (left_wrist2), pose
  const Real Lambda_11_11_p14 = c12 * Lambda_11_11_p10 + s12 * Lambda_11_11_p13;

  // link 11 (left_wrist1), pose
  const Real Lambda_11_11_p15 = c11 * Lambda_11_11_p12 + s11 * Lambda_11_11_p11;

  // link 13 (left_hand), pose
  const Real Lambda_11_11_p16 = c13 * Lambda_11_11_p15 + s13 * Lambda_11_11_p14;

  // link 12 (left_wrist2), pose
  const Real Lambda_11_11_p17 = s12 * Lambda_11_11_p10 - c12 * Lambda_11_11_p13;

  // link 13 (left_hand), force propagation
  const Real Lambda_11_11_p18 = Lambda_11_11_p16 + 0.04672761636452121 * Lambda_11_11_p17;

  // link 13 (left_hand), pose
  const Real Lambda_11_11_p19 = s13 * Lambda_11_11_p15 - c13 * Lambda_11_11_p14;

  // link 13 (left_hand), force propagation
  const Real Lambda_11_11_p20 = Lambda_11_11_p19 - 0.11533812622014242 * Lambda_11_11_p17;
  const Real Lambda_11_11_p21 = c13 * Lambda_11_11_p18 + s13 * Lambda_11_11_p20;
  const Real Lambda_11_11_p22 = 17.32841575379867 * Lambda_11_11_p17;
  const Real Lambda_11_11_p23 = 3.0523172236718206 * Lambda_11_11_p17;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p24 = s13 * Lambda_11_11_p22 - c13 * Lambda_11_11_p23 + inverse_D5_p190 *
      Lambda_11_11_p21;
  const Real Lambda_11_11_p25 = inverse_D5_p184 * Lambda_11_11_p21;
  const Real Lambda_11_11_p26 = s12 * Lambda_11_11_p24 + c12 * Lambda_11_11_p25;
  const Real Lambda_11_11_p27 = s13 * Lambda_11_11_p18 - c13 * Lambda_11_11_p20 - inverse_D11_p1 *
      Lambda_11_11_p21;
  const Real Lambda_11_11_p28 = c12 * Lambda_11_11_p27;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p29 = 0.269 * Lambda_11_11_p26 + inverse_D5_p205 * Lambda_11_11_p28;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p30 = c13 * Lambda_11_11_p22 + s13 * Lambda_11_11_p23 + inverse_D5_p196 *
      Lambda_11_11_p21;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p31 = 0.269 * Lambda_11_11_p30 + s12 * Lambda_11_11_p27 -
      inverse_D5_p211 * Lambda_11_11_p28;
  const Real Lambda_11_11_p32 = c11 * Lambda_11_11_p29 - s11 * Lambda_11_11_p31;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p33 = c12 * Lambda_11_11_p24 - s12 * Lambda_11_11_p25 - inverse_D5_p268 *
      Lambda_11_11_p28 + inverse_D5_p273 * Lambda_11_11_p32;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p34 = Lambda_11_11_p26 + inverse_D5_p236 * Lambda_11_11_p28;
  const Real Lambda_11_11_p35 = Lambda_11_11_p30 - inverse_D5_p239 * Lambda_11_11_p28;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p36 = s11 * Lambda_11_11_p35 - c11 * Lambda_11_11_p34 + inverse_D5_p264 *
      Lambda_11_11_p32;
  const Real Lambda_11_11_p37 = s10 * Lambda_11_11_p33 - c10 * Lambda_11_11_p36;
  const Real Lambda_11_11_p38 = s11 * Lambda_11_11_p29 + c11 * Lambda_11_11_p31 + inverse_D5_p231 *
      Lambda_11_11_p32;
  const Real Lambda_11_11_p39 = inverse_D5_p228 * Lambda_11_11_p32;
  const Real Lambda_11_11_p40 = c10 * Lambda_11_11_p39 + s10 * Lambda_11_11_p38;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p41 = 0.282 * Lambda_11_11_p37 + minus_inverse_D8_p1 * Lambda_11_11_p40;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p42 = c11 * Lambda_11_11_p35 + s11 * Lambda_11_11_p34 - inverse_D5_p246 *
      Lambda_11_11_p32;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p43 = 0.282 * Lambda_11_11_p42 - s10 * Lambda_11_11_p39 + c10 *
      Lambda_11_11_p38 + minus_inverse_D8_p4 * Lambda_11_11_p40;
  const Real Lambda_11_11_p44 = s9 * Lambda_11_11_p41 + c9 * Lambda_11_11_p43;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p45 = c9 * Lambda_11_11_p41 - s9 * Lambda_11_11_p43 +
      minus_inverse_D7_p1 * Lambda_11_11_p44;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_11_11_p46 = 0.00010499999999999999 / minus_inverse_D8_p9;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p47 = Lambda_11_11_p46 * Lambda_11_11_p44;
  const Real Lambda_11_11_p48 = c8 * Lambda_11_11_p45 + s8 * Lambda_11_11_p47;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p49 = Lambda_11_11_p37 + inverse_D5_p281 * Lambda_11_11_p40;
  const Real Lambda_11_11_p50 = Lambda_11_11_p42 + inverse_D5_p253 * Lambda_11_11_p40;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p51 = c9 * Lambda_11_11_p50 + s9 * Lambda_11_11_p49 - inverse_D5_p322 *
      Lambda_11_11_p44;
  const Real Lambda_11_11_p52 = c10 * Lambda_11_11_p33 + s10 * Lambda_11_11_p36 + inverse_D5_p313 *
      Lambda_11_11_p40 + inverse_D5_p319 * Lambda_11_11_p44;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p53 = s8 * Lambda_11_11_p51 + c8 * Lambda_11_11_p52 - inverse_D5_p329 *
      Lambda_11_11_p48;
  const Real Lambda_11_11_p54 = s9 * Lambda_11_11_p50 - c9 * Lambda_11_11_p49 - inverse_D5_p303 *
      Lambda_11_11_p44 + inverse_D5_p309 * Lambda_11_11_p48;
  const Real Lambda_11_11_p55 = c7 * Lambda_11_11_p53 + s7 * Lambda_11_11_p54;
  const Real Lambda_11_11_p56 = c8 * Lambda_11_11_p51 - s8 * Lambda_11_11_p52 + inverse_D5_p359 *
      Lambda_11_11_p48;
  const Real Lambda_11_11_p57 = s8 * Lambda_11_11_p45 - c8 * Lambda_11_11_p47 - inverse_D5_p370 *
      Lambda_11_11_p48;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_11_11_p58 = 2.6249999999999998e-05 / minus_inverse_D7_p8;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p59 = Lambda_11_11_p58 * Lambda_11_11_p48;
  const Real Lambda_11_11_p60 = 0.18 * Lambda_11_11_p55 - 0.226 * Lambda_11_11_p56 - s7 *
      Lambda_11_11_p57 + c7 * Lambda_11_11_p59;
  const Real Lambda_11_11_p61 = s7 * Lambda_11_11_p53 - c7 * Lambda_11_11_p54;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p62 = Lambda_11_11_p61 + inverse_D5_p408 * Lambda_11_11_p60;
  const Real Lambda_11_11_p63 = 0.226 * Lambda_11_11_p61 - inverse_D5_p383 * Lambda_11_11_p60;
  const Real Lambda_11_11_p64 = 0.18 * Lambda_11_11_p61 + c7 * Lambda_11_11_p57 + s7 *
      Lambda_11_11_p59 - inverse_D5_p390 * Lambda_11_11_p60;
  const Real Lambda_11_11_p65 = 0.072 * Lambda_11_11_p62 + c6 * Lambda_11_11_p63 + s6 *
      Lambda_11_11_p64;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p66 = s6 * Lambda_11_11_p63 - c6 * Lambda_11_11_p64 - inverse_D1_p35 *
      Lambda_11_11_p65;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p67 = Lambda_11_11_p56 - inverse_D1_p2 * Lambda_11_11_p60;
  const Real Lambda_11_11_p68 = Lambda_11_11_p55 + inverse_D1_p11 * Lambda_11_11_p60;
  const Real Lambda_11_11_p69 = c6 * Lambda_11_11_p67 - s6 * Lambda_11_11_p68;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p70 = 0.072 * Lambda_11_11_p69 - inverse_D1_p25 * Lambda_11_11_p65;
  const Real Lambda_11_11_p71 = c5 * Lambda_11_11_p66 + s5 * Lambda_11_11_p70;
  const Real Lambda_11_11_p72 = s6 * Lambda_11_11_p67 + c6 * Lambda_11_11_p68 - inverse_D1_p58 *
      Lambda_11_11_p65;
  const Real Lambda_11_11_p73 = Lambda_11_11_p62 - inverse_D1_p54 * Lambda_11_11_p65;
  const Real Lambda_11_11_p74 = s5 * Lambda_11_11_p72 + c5 * Lambda_11_11_p73;
  const Real Lambda_11_11_p75 = Lambda_11_11_p69 - inverse_D1_p42 * Lambda_11_11_p65;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p76 = s4 * (0.21799999999999997 * Lambda_11_11_p75 - s5 *
      Lambda_11_11_p66 + c5 * Lambda_11_11_p70 + inverse_D3_p3 * Lambda_11_11_p71);
  const Real Lambda_11_11_p77 = c4 * (0.21799999999999997 * Lambda_11_11_p74 + inverse_D3_p1 *
      Lambda_11_11_p71) - Lambda_11_11_p76;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p78 = c5 * Lambda_11_11_p72 - s5 * Lambda_11_11_p73 - inverse_D1_p83 *
      Lambda_11_11_p71 - inverse_D1_p87 * Lambda_11_11_p77;
  const Real Lambda_11_11_p79 = s4 * (Lambda_11_11_p75 + inverse_D1_p48 * Lambda_11_11_p71) - c4 *
      (Lambda_11_11_p74 + inverse_D1_p67 * Lambda_11_11_p71) + inverse_D1_p89 * Lambda_11_11_p77;
  const Real Lambda_11_11_p80 = s3 * Lambda_11_11_p78 - c3 * Lambda_11_11_p79;
  const Real Lambda_11_11_p81 = 0.422 * Lambda_11_11_p80;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p82 = s2 * (c3 * Lambda_11_11_p78 + s3 * Lambda_11_11_p79 +
      inverse_D1_p102 * Lambda_11_11_p81) + c2 * (Lambda_11_11_p80 - inverse_D1_p98 *
      Lambda_11_11_p81);
  const Real Lambda_11_11_p83 = 0.434 * Lambda_11_11_p82;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p84 = inverse_D1 * Lambda_11_11_p83;

  // link 2 (thigh), pose
  const Real Lambda_11_11_p85 = s1 * c2 + c1 * s2;
  const Real Lambda_11_11_p86 = s1 * s2 - c1 * c2;

  // link 3 (hip), pose
  const Real Lambda_11_11_p87 = c3 * Lambda_11_11_p85 - s3 * Lambda_11_11_p86;
  const Real Lambda_11_11_p88 = s3 * Lambda_11_11_p85 + c3 * Lambda_11_11_p86;

  // link 4 (chest1), pose
  const Real Lambda_11_11_p89 = c4 * Lambda_11_11_p88;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p90 = s5 * Lambda_11_11_p87 + c5 * Lambda_11_11_p89;
  const Real Lambda_11_11_p91 = c5 * Lambda_11_11_p87 - s5 * Lambda_11_11_p89;

  // link 4 (chest1), pose
  const Real Lambda_11_11_p92 = s4 * Lambda_11_11_p88;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p93 = s6 * Lambda_11_11_p92 - c6 * Lambda_11_11_p91;

  // link 7 (left_shoulder1), pose
  const Real Lambda_11_11_p94 = c7 * Lambda_11_11_p90 - s7 * Lambda_11_11_p93;
  const Real Lambda_11_11_p95 = s7 * Lambda_11_11_p90 + c7 * Lambda_11_11_p93;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p96 = c6 * Lambda_11_11_p92 + s6 * Lambda_11_11_p91;

  // link 8 (left_shoulder2), pose
  const Real Lambda_11_11_p97 = c8 * Lambda_11_11_p96 - s8 * Lambda_11_11_p95;

  // link 9 (left_upperarm), pose
  const Real Lambda_11_11_p98 = s9 * Lambda_11_11_p94 + c9 * Lambda_11_11_p97;
  const Real Lambda_11_11_p99 = c9 * Lambda_11_11_p94 - s9 * Lambda_11_11_p97;

  // link 8 (left_shoulder2), pose
  const Real Lambda_11_11_p100 = s8 * Lambda_11_11_p96 + c8 * Lambda_11_11_p95;

  // link 10 (left_lowerarm), pose
  const Real Lambda_11_11_p101 = s10 * Lambda_11_11_p100 - c10 * Lambda_11_11_p99;

  // link 11 (left_wrist1), pose
  const Real Lambda_11_11_p102 = c11 * Lambda_11_11_p98 - s11 * Lambda_11_11_p101;
  const Real Lambda_11_11_p103 = s11 * Lambda_11_11_p98 + c11 * Lambda_11_11_p101;

  // link 10 (left_lowerarm), pose
  const Real Lambda_11_11_p104 = c10 * Lambda_11_11_p100 + s10 * Lambda_11_11_p99;

  // link 12 (left_wrist2), pose
  const Real Lambda_11_11_p105 = c12 * Lambda_11_11_p104 - s12 * Lambda_11_11_p103;

  // link 13 (left_hand), pose
  const Real Lambda_11_11_p106 = c13 * Lambda_11_11_p102 - s13 * Lambda_11_11_p105;

  // link 12 (left_wrist2), pose
  const Real Lambda_11_11_p107 = s12 * Lambda_11_11_p104 + c12 * Lambda_11_11_p103;

  // link 13 (left_hand), force propagation
  const Real Lambda_11_11_p108 = Lambda_11_11_p106 - 0.04672761636452121 * Lambda_11_11_p107;

  // link 13 (left_hand), pose
  const Real Lambda_11_11_p109 = s13 * Lambda_11_11_p102 + c13 * Lambda_11_11_p105;

  // link 13 (left_hand), force propagation
  const Real Lambda_11_11_p110 = Lambda_11_11_p109 + 0.11533812622014242 * Lambda_11_11_p107;
  const Real Lambda_11_11_p111 = c13 * Lambda_11_11_p108 + s13 * Lambda_11_11_p110;
  const Real Lambda_11_11_p112 = 17.32841575379867 * Lambda_11_11_p107;
  const Real Lambda_11_11_p113 = 3.0523172236718206 * Lambda_11_11_p107;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p114 = s13 * Lambda_11_11_p112 - c13 * Lambda_11_11_p113 -
      inverse_D5_p190 * Lambda_11_11_p111;
  const Real Lambda_11_11_p115 = inverse_D5_p184 * Lambda_11_11_p111;
  const Real Lambda_11_11_p116 = s12 * Lambda_11_11_p114 - c12 * Lambda_11_11_p115;
  const Real Lambda_11_11_p117 = s13 * Lambda_11_11_p108 - c13 * Lambda_11_11_p110 -
      inverse_D11_p1 * Lambda_11_11_p111;
  const Real Lambda_11_11_p118 = c12 * Lambda_11_11_p117;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p119 = 0.269 * Lambda_11_11_p116 - inverse_D5_p205 * Lambda_11_11_p118;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p120 = c13 * Lambda_11_11_p112 + s13 * Lambda_11_11_p113 -
      inverse_D5_p196 * Lambda_11_11_p111;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p121 = 0.269 * Lambda_11_11_p120 - s12 * Lambda_11_11_p117 +
      inverse_D5_p211 * Lambda_11_11_p118;
  const Real Lambda_11_11_p122 = c11 * Lambda_11_11_p119 - s11 * Lambda_11_11_p121;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p123 = c12 * Lambda_11_11_p114 + s12 * Lambda_11_11_p115 +
      inverse_D5_p268 * Lambda_11_11_p118 + inverse_D5_p273 * Lambda_11_11_p122;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p124 = Lambda_11_11_p116 - inverse_D5_p236 * Lambda_11_11_p118;
  const Real Lambda_11_11_p125 = Lambda_11_11_p120 + inverse_D5_p239 * Lambda_11_11_p118;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p126 = s11 * Lambda_11_11_p125 - c11 * Lambda_11_11_p124 +
      inverse_D5_p264 * Lambda_11_11_p122;
  const Real Lambda_11_11_p127 = s10 * Lambda_11_11_p123 - c10 * Lambda_11_11_p126;
  const Real Lambda_11_11_p128 = s11 * Lambda_11_11_p119 + c11 * Lambda_11_11_p121 +
      inverse_D5_p231 * Lambda_11_11_p122;
  const Real Lambda_11_11_p129 = inverse_D5_p228 * Lambda_11_11_p122;
  const Real Lambda_11_11_p130 = c10 * Lambda_11_11_p129 + s10 * Lambda_11_11_p128;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p131 = 0.282 * Lambda_11_11_p127 + minus_inverse_D8_p1 *
      Lambda_11_11_p130;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p132 = c11 * Lambda_11_11_p125 + s11 * Lambda_11_11_p124 -
      inverse_D5_p246 * Lambda_11_11_p122;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p133 = 0.282 * Lambda_11_11_p132 - s10 * Lambda_11_11_p129 + c10 *
      Lambda_11_11_p128 + minus_inverse_D8_p4 * Lambda_11_11_p130;
  const Real Lambda_11_11_p134 = s9 * Lambda_11_11_p131 + c9 * Lambda_11_11_p133;
  const Real Lambda_11_11_p135 = Lambda_11_11_p127 + inverse_D5_p281 * Lambda_11_11_p130;
  const Real Lambda_11_11_p136 = Lambda_11_11_p132 + inverse_D5_p253 * Lambda_11_11_p130;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p137 = c9 * Lambda_11_11_p136 + s9 * Lambda_11_11_p135 - inverse_D5_p322 *
      Lambda_11_11_p134;
  const Real Lambda_11_11_p138 = c10 * Lambda_11_11_p123 + s10 * Lambda_11_11_p126 +
      inverse_D5_p313 * Lambda_11_11_p130 + inverse_D5_p319 * Lambda_11_11_p134;
  const Real Lambda_11_11_p139 = c9 * Lambda_11_11_p131 - s9 * Lambda_11_11_p133 +
      minus_inverse_D7_p1 * Lambda_11_11_p134;
  const Real Lambda_11_11_p140 = Lambda_11_11_p46 * Lambda_11_11_p134;
  const Real Lambda_11_11_p141 = c8 * Lambda_11_11_p139 + s8 * Lambda_11_11_p140;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p142 = s8 * Lambda_11_11_p137 + c8 * Lambda_11_11_p138 - inverse_D5_p329 *
      Lambda_11_11_p141;
  const Real Lambda_11_11_p143 = s9 * Lambda_11_11_p136 - c9 * Lambda_11_11_p135 - inverse_D5_p303 *
      Lambda_11_11_p134 + inverse_D5_p309 * Lambda_11_11_p141;
  const Real Lambda_11_11_p144 = c7 * Lambda_11_11_p142 + s7 * Lambda_11_11_p143;
  const Real Lambda_11_11_p145 = c8 * Lambda_11_11_p137 - s8 * Lambda_11_11_p138 + inverse_D5_p359 *
      Lambda_11_11_p141;
  const Real Lambda_11_11_p146 = s8 * Lambda_11_11_p139 - c8 * Lambda_11_11_p140 - inverse_D5_p370 *
      Lambda_11_11_p141;
  const Real Lambda_11_11_p147 = Lambda_11_11_p58 * Lambda_11_11_p141;
  const Real Lambda_11_11_p148 = 0.18 * Lambda_11_11_p144 - 0.226 * Lambda_11_11_p145 - s7 *
      Lambda_11_11_p146 + c7 * Lambda_11_11_p147;
  const Real Lambda_11_11_p149 = s7 * Lambda_11_11_p142 - c7 * Lambda_11_11_p143;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p150 = Lambda_11_11_p149 + inverse_D5_p408 * Lambda_11_11_p148;
  const Real Lambda_11_11_p151 = 0.226 * Lambda_11_11_p149 - inverse_D5_p383 * Lambda_11_11_p148;
  const Real Lambda_11_11_p152 = 0.18 * Lambda_11_11_p149 + c7 * Lambda_11_11_p146 + s7 *
      Lambda_11_11_p147 - inverse_D5_p390 * Lambda_11_11_p148;
  const Real Lambda_11_11_p153 = 0.072 * Lambda_11_11_p150 + c6 * Lambda_11_11_p151 + s6 *
      Lambda_11_11_p152;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p154 = s6 * Lambda_11_11_p151 - c6 * Lambda_11_11_p152 - inverse_D1_p35 *
      Lambda_11_11_p153;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p155 = Lambda_11_11_p145 - inverse_D1_p2 * Lambda_11_11_p148;
  const Real Lambda_11_11_p156 = Lambda_11_11_p144 + inverse_D1_p11 * Lambda_11_11_p148;
  const Real Lambda_11_11_p157 = c6 * Lambda_11_11_p155 - s6 * Lambda_11_11_p156;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p158 = 0.072 * Lambda_11_11_p157 - inverse_D1_p25 * Lambda_11_11_p153;
  const Real Lambda_11_11_p159 = c5 * Lambda_11_11_p154 + s5 * Lambda_11_11_p158;
  const Real Lambda_11_11_p160 = s6 * Lambda_11_11_p155 + c6 * Lambda_11_11_p156 - inverse_D1_p58 *
      Lambda_11_11_p153;
  const Real Lambda_11_11_p161 = Lambda_11_11_p150 - inverse_D1_p54 * Lambda_11_11_p153;
  const Real Lambda_11_11_p162 = s5 * Lambda_11_11_p160 + c5 * Lambda_11_11_p161;
  const Real Lambda_11_11_p163 = Lambda_11_11_p157 - inverse_D1_p42 * Lambda_11_11_p153;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p164 = s4 * (0.21799999999999997 * Lambda_11_11_p163 - s5 *
      Lambda_11_11_p154 + c5 * Lambda_11_11_p158 + inverse_D3_p3 * Lambda_11_11_p159);
  const Real Lambda_11_11_p165 = c4 * (0.21799999999999997 * Lambda_11_11_p162 + inverse_D3_p1 *
      Lambda_11_11_p159) - Lambda_11_11_p164;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p166 = c5 * Lambda_11_11_p160 - s5 * Lambda_11_11_p161 - inverse_D1_p83 *
      Lambda_11_11_p159 - inverse_D1_p87 * Lambda_11_11_p165;
  const Real Lambda_11_11_p167 = s4 * (Lambda_11_11_p163 + inverse_D1_p48 * Lambda_11_11_p159) -
      c4 * (Lambda_11_11_p162 + inverse_D1_p67 * Lambda_11_11_p159) + inverse_D1_p89 *
      Lambda_11_11_p165;
  const Real Lambda_11_11_p168 = s3 * Lambda_11_11_p166 - c3 * Lambda_11_11_p167;
  const Real Lambda_11_11_p169 = 0.422 * Lambda_11_11_p168;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p170 = s2 * (c3 * Lambda_11_11_p166 + s3 * Lambda_11_11_p167 +
      inverse_D1_p102 * Lambda_11_11_p169) + c2 * (Lambda_11_11_p168 - inverse_D1_p98 *
      Lambda_11_11_p169);
  const Real Lambda_11_11_p171 = 0.434 * Lambda_11_11_p170;
  const Real Lambda_11_11_p172 = inverse_D2 * Lambda_11_11_p81;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p173 = inverse_D3 * Lambda_11_11_p77;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p174 = inverse_D4 * Lambda_11_11_p71;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p175 = inverse_D5 * Lambda_11_11_p65;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p176 = inverse_D6 * Lambda_11_11_p60;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p177 = minus_inverse_D7 * Lambda_11_11_p48;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p178 = minus_inverse_D8 * Lambda_11_11_p44;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p179 = minus_inverse_D9 * Lambda_11_11_p40;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p180 = minus_inverse_D10 * Lambda_11_11_p32;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p181 = inverse_D11 * Lambda_11_11_p28;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p182 = inverse_D12 * Lambda_11_11_p21;

  // link 13 (left_hand), force propagation
  const Real Lambda_11_11_p183 = 1065.380700001509 * Lambda_11_11_p17;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p184 = Lambda_11_11_p107 * Lambda_11_11_p183 - Lambda_11_11_p111 *
      Lambda_11_11_p182 - Lambda_11_11_p118 * Lambda_11_11_p181 - Lambda_11_11_p122 *
      Lambda_11_11_p180 - Lambda_11_11_p130 * Lambda_11_11_p179;
  const Real Lambda_11_11_p185 = Lambda_11_11_p184 - Lambda_11_11_p134 * Lambda_11_11_p178 -
      Lambda_11_11_p141 * Lambda_11_11_p177 + Lambda_11_11_p148 * Lambda_11_11_p176 +
      Lambda_11_11_p153 * Lambda_11_11_p175;
  const Real Lambda_11_11_p186 = Lambda_11_11_p185 + Lambda_11_11_p159 * Lambda_11_11_p174 +
      Lambda_11_11_p165 * Lambda_11_11_p173 + Lambda_11_11_p169 * Lambda_11_11_p172 +
      Lambda_11_11_p171 * Lambda_11_11_p84;

  // link 4 (chest1), pose
  const Real Lambda_11_11_p187 = c4 * Lambda_11_11_p87;

  // link 5 (chest2), pose
  const Real Lambda_11_11_p188 = s5 * Lambda_11_11_p88 - c5 * Lambda_11_11_p187;
  const Real Lambda_11_11_p189 = c5 * Lambda_11_11_p88 + s5 * Lambda_11_11_p187;

  // link 4 (chest1), pose
  const Real Lambda_11_11_p190 = s4 * Lambda_11_11_p87;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p191 = s6 * Lambda_11_11_p190 + c6 * Lambda_11_11_p189;

  // link 7 (left_shoulder1), pose
  const Real Lambda_11_11_p192 = c7 * Lambda_11_11_p188 + s7 * Lambda_11_11_p191;
  const Real Lambda_11_11_p193 = s7 * Lambda_11_11_p188 - c7 * Lambda_11_11_p191;

  // link 6 (chest3), pose
  const Real Lambda_11_11_p194 = c6 * Lambda_11_11_p190 - s6 * Lambda_11_11_p189;

  // link 8 (left_shoulder2), pose
  const Real Lambda_11_11_p195 = c8 * Lambda_11_11_p194 + s8 * Lambda_11_11_p193;

  // link 9 (left_upperarm), pose
  const Real Lambda_11_11_p196 = s9 * Lambda_11_11_p192 - c9 * Lambda_11_11_p195;
  const Real Lambda_11_11_p197 = c9 * Lambda_11_11_p192 + s9 * Lambda_11_11_p195;

  // link 8 (left_shoulder2), pose
  const Real Lambda_11_11_p198 = s8 * Lambda_11_11_p194 - c8 * Lambda_11_11_p193;

  // link 10 (left_lowerarm), pose
  const Real Lambda_11_11_p199 = s10 * Lambda_11_11_p198 + c10 * Lambda_11_11_p197;

  // link 11 (left_wrist1), pose
  const Real Lambda_11_11_p200 = c11 * Lambda_11_11_p196 + s11 * Lambda_11_11_p199;
  const Real Lambda_11_11_p201 = s11 * Lambda_11_11_p196 - c11 * Lambda_11_11_p199;

  // link 10 (left_lowerarm), pose
  const Real Lambda_11_11_p202 = c10 * Lambda_11_11_p198 - s10 * Lambda_11_11_p197;

  // link 12 (left_wrist2), pose
  const Real Lambda_11_11_p203 = c12 * Lambda_11_11_p202 + s12 * Lambda_11_11_p201;

  // link 13 (left_hand), pose
  const Real Lambda_11_11_p204 = s13 * Lambda_11_11_p200 - c13 * Lambda_11_11_p203;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p205 = 0.086 * Lambda_11_11_p204;
  const Real Lambda_11_11_p206 = Lambda_11_11_p186 * Lambda_11_11_p205;
  const Real Lambda_11_11_p207 = inverse_D1 * Lambda_11_11_p171;

  // link 13 (left_hand), force propagation
  const Real Lambda_11_11_p208 = c13 * Lambda_11_11_p106 + s13 * Lambda_11_11_p109;
  const Real Lambda_11_11_p209 = s13 * Lambda_11_11_p106 - c13 * Lambda_11_11_p109;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p210 = s12 * Lambda_11_11_p209 + c12 * Lambda_11_11_p107;
  const Real Lambda_11_11_p211 = 0.269 * Lambda_11_11_p210;
  const Real Lambda_11_11_p212 = 0.269 * Lambda_11_11_p208;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p213 = c11 * Lambda_11_11_p211 - s11 * Lambda_11_11_p212;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p214 = s11 * Lambda_11_11_p208 - c11 * Lambda_11_11_p210 +
      inverse_D5_p264 * Lambda_11_11_p213;
  const Real Lambda_11_11_p215 = c12 * Lambda_11_11_p209 - s12 * Lambda_11_11_p107 +
      inverse_D5_p273 * Lambda_11_11_p213;
  const Real Lambda_11_11_p216 = s10 * Lambda_11_11_p215 - c10 * Lambda_11_11_p214;
  const Real Lambda_11_11_p217 = s11 * Lambda_11_11_p211 + c11 * Lambda_11_11_p212 +
      inverse_D5_p231 * Lambda_11_11_p213;
  const Real Lambda_11_11_p218 = inverse_D5_p228 * Lambda_11_11_p213;
  const Real Lambda_11_11_p219 = c10 * Lambda_11_11_p218 + s10 * Lambda_11_11_p217;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p220 = 0.282 * Lambda_11_11_p216 + minus_inverse_D8_p1 *
      Lambda_11_11_p219;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p221 = c11 * Lambda_11_11_p208 + s11 * Lambda_11_11_p210 -
      inverse_D5_p246 * Lambda_11_11_p213;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p222 = 0.282 * Lambda_11_11_p221 - s10 * Lambda_11_11_p218 + c10 *
      Lambda_11_11_p217 + minus_inverse_D8_p4 * Lambda_11_11_p219;
  const Real Lambda_11_11_p223 = s9 * Lambda_11_11_p220 + c9 * Lambda_11_11_p222;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p224 = c9 * Lambda_11_11_p220 - s9 * Lambda_11_11_p222 +
      minus_inverse_D7_p1 * Lambda_11_11_p223;
  const Real Lambda_11_11_p225 = Lambda_11_11_p46 * Lambda_11_11_p223;
  const Real Lambda_11_11_p226 = c8 * Lambda_11_11_p224 + s8 * Lambda_11_11_p225;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p227 = Lambda_11_11_p221 + inverse_D5_p253 * Lambda_11_11_p219;
  const Real Lambda_11_11_p228 = Lambda_11_11_p216 + inverse_D5_p281 * Lambda_11_11_p219;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p229 = c9 * Lambda_11_11_p227 + s9 * Lambda_11_11_p228 - inverse_D5_p322 *
      Lambda_11_11_p223;
  const Real Lambda_11_11_p230 = c10 * Lambda_11_11_p215 + s10 * Lambda_11_11_p214 +
      inverse_D5_p313 * Lambda_11_11_p219 + inverse_D5_p319 * Lambda_11_11_p223;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p231 = s8 * Lambda_11_11_p229 + c8 * Lambda_11_11_p230 - inverse_D5_p329 *
      Lambda_11_11_p226;
  const Real Lambda_11_11_p232 = s9 * Lambda_11_11_p227 - c9 * Lambda_11_11_p228 - inverse_D5_p303 *
      Lambda_11_11_p223 + inverse_D5_p309 * Lambda_11_11_p226;
  const Real Lambda_11_11_p233 = c7 * Lambda_11_11_p231 + s7 * Lambda_11_11_p232;
  const Real Lambda_11_11_p234 = c8 * Lambda_11_11_p229 - s8 * Lambda_11_11_p230 + inverse_D5_p359 *
      Lambda_11_11_p226;
  const Real Lambda_11_11_p235 = s8 * Lambda_11_11_p224 - c8 * Lambda_11_11_p225 - inverse_D5_p370 *
      Lambda_11_11_p226;
  const Real Lambda_11_11_p236 = Lambda_11_11_p58 * Lambda_11_11_p226;
  const Real Lambda_11_11_p237 = 0.18 * Lambda_11_11_p233 - 0.226 * Lambda_11_11_p234 - s7 *
      Lambda_11_11_p235 + c7 * Lambda_11_11_p236;
  const Real Lambda_11_11_p238 = s7 * Lambda_11_11_p231 - c7 * Lambda_11_11_p232;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p239 = Lambda_11_11_p238 + inverse_D5_p408 * Lambda_11_11_p237;
  const Real Lambda_11_11_p240 = 0.226 * Lambda_11_11_p238 - inverse_D5_p383 * Lambda_11_11_p237;
  const Real Lambda_11_11_p241 = 0.18 * Lambda_11_11_p238 + c7 * Lambda_11_11_p235 + s7 *
      Lambda_11_11_p236 - inverse_D5_p390 * Lambda_11_11_p237;
  const Real Lambda_11_11_p242 = 0.072 * Lambda_11_11_p239 + c6 * Lambda_11_11_p240 + s6 *
      Lambda_11_11_p241;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p243 = s6 * Lambda_11_11_p240 - c6 * Lambda_11_11_p241 - inverse_D1_p35 *
      Lambda_11_11_p242;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p244 = Lambda_11_11_p234 - inverse_D1_p2 * Lambda_11_11_p237;
  const Real Lambda_11_11_p245 = Lambda_11_11_p233 + inverse_D1_p11 * Lambda_11_11_p237;
  const Real Lambda_11_11_p246 = c6 * Lambda_11_11_p244 - s6 * Lambda_11_11_p245;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p247 = 0.072 * Lambda_11_11_p246 - inverse_D1_p25 * Lambda_11_11_p242;
  const Real Lambda_11_11_p248 = c5 * Lambda_11_11_p243 + s5 * Lambda_11_11_p247;
  const Real Lambda_11_11_p249 = s6 * Lambda_11_11_p244 + c6 * Lambda_11_11_p245 - inverse_D1_p58 *
      Lambda_11_11_p242;
  const Real Lambda_11_11_p250 = Lambda_11_11_p239 - inverse_D1_p54 * Lambda_11_11_p242;
  const Real Lambda_11_11_p251 = s5 * Lambda_11_11_p249 + c5 * Lambda_11_11_p250;
  const Real Lambda_11_11_p252 = Lambda_11_11_p246 - inverse_D1_p42 * Lambda_11_11_p242;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p253 = s4 * (0.21799999999999997 * Lambda_11_11_p252 - s5 *
      Lambda_11_11_p243 + c5 * Lambda_11_11_p247 + inverse_D3_p3 * Lambda_11_11_p248);
  const Real Lambda_11_11_p254 = c4 * (0.21799999999999997 * Lambda_11_11_p251 + inverse_D3_p1 *
      Lambda_11_11_p248) - Lambda_11_11_p253;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p255 = c5 * Lambda_11_11_p249 - s5 * Lambda_11_11_p250 - inverse_D1_p83 *
      Lambda_11_11_p248 - inverse_D1_p87 * Lambda_11_11_p254;
  const Real Lambda_11_11_p256 = s4 * (Lambda_11_11_p252 + inverse_D1_p48 * Lambda_11_11_p248) -
      c4 * (Lambda_11_11_p251 + inverse_D1_p67 * Lambda_11_11_p248) + inverse_D1_p89 *
      Lambda_11_11_p254;
  const Real Lambda_11_11_p257 = s3 * Lambda_11_11_p255 - c3 * Lambda_11_11_p256;
  const Real Lambda_11_11_p258 = 0.422 * Lambda_11_11_p257;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p259 = s2 * (c3 * Lambda_11_11_p255 + s3 * Lambda_11_11_p256 +
      inverse_D1_p102 * Lambda_11_11_p258) + c2 * (Lambda_11_11_p257 - inverse_D1_p98 *
      Lambda_11_11_p258);
  const Real Lambda_11_11_p260 = 0.434 * Lambda_11_11_p259;
  const Real Lambda_11_11_p261 = inverse_D2 * Lambda_11_11_p169;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p262 = inverse_D3 * Lambda_11_11_p165;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p263 = inverse_D4 * Lambda_11_11_p159;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p264 = inverse_D5 * Lambda_11_11_p153;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p265 = inverse_D6 * Lambda_11_11_p148;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p266 = minus_inverse_D7 * Lambda_11_11_p141;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p267 = minus_inverse_D8 * Lambda_11_11_p134;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p268 = minus_inverse_D9 * Lambda_11_11_p130;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p269 = minus_inverse_D10 * Lambda_11_11_p122;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p270 = Lambda_11_11_p213 * Lambda_11_11_p269 + Lambda_11_11_p219 *
      Lambda_11_11_p268 + Lambda_11_11_p223 * Lambda_11_11_p267 + Lambda_11_11_p226 *
      Lambda_11_11_p266 - Lambda_11_11_p237 * Lambda_11_11_p265;
  const Real Lambda_11_11_p271 = Lambda_11_11_p270 - Lambda_11_11_p242 * Lambda_11_11_p264 -
      Lambda_11_11_p248 * Lambda_11_11_p263 - Lambda_11_11_p254 * Lambda_11_11_p262 -
      Lambda_11_11_p258 * Lambda_11_11_p261;

  // link 13 (left_hand), pose
  const Real Lambda_11_11_p272 = c13 * Lambda_11_11_p200 + s13 * Lambda_11_11_p203;

  // link 12 (left_wrist2), pose
  const Real Lambda_11_11_p273 = s12 * Lambda_11_11_p202 - c12 * Lambda_11_11_p201;

  // link 13 (left_hand), force propagation
  const Real Lambda_11_11_p274 = Lambda_11_11_p272 + 0.04672761636452121 * Lambda_11_11_p273;
  const Real Lambda_11_11_p275 = Lambda_11_11_p204 - 0.11533812622014242 * Lambda_11_11_p273;
  const Real Lambda_11_11_p276 = c13 * Lambda_11_11_p274 + s13 * Lambda_11_11_p275;
  const Real Lambda_11_11_p277 = 17.32841575379867 * Lambda_11_11_p273;
  const Real Lambda_11_11_p278 = 3.0523172236718206 * Lambda_11_11_p273;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p279 = s13 * Lambda_11_11_p277 - c13 * Lambda_11_11_p278 +
      inverse_D5_p190 * Lambda_11_11_p276;
  const Real Lambda_11_11_p280 = inverse_D5_p184 * Lambda_11_11_p276;
  const Real Lambda_11_11_p281 = s12 * Lambda_11_11_p279 + c12 * Lambda_11_11_p280;
  const Real Lambda_11_11_p282 = s13 * Lambda_11_11_p274 - c13 * Lambda_11_11_p275 -
      inverse_D11_p1 * Lambda_11_11_p276;
  const Real Lambda_11_11_p283 = c12 * Lambda_11_11_p282;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p284 = 0.269 * Lambda_11_11_p281 + inverse_D5_p205 * Lambda_11_11_p283;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p285 = c13 * Lambda_11_11_p277 + s13 * Lambda_11_11_p278 +
      inverse_D5_p196 * Lambda_11_11_p276;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p286 = 0.269 * Lambda_11_11_p285 + s12 * Lambda_11_11_p282 -
      inverse_D5_p211 * Lambda_11_11_p283;
  const Real Lambda_11_11_p287 = c11 * Lambda_11_11_p284 - s11 * Lambda_11_11_p286;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p288 = c12 * Lambda_11_11_p279 - s12 * Lambda_11_11_p280 -
      inverse_D5_p268 * Lambda_11_11_p283 + inverse_D5_p273 * Lambda_11_11_p287;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p289 = Lambda_11_11_p281 + inverse_D5_p236 * Lambda_11_11_p283;
  const Real Lambda_11_11_p290 = Lambda_11_11_p285 - inverse_D5_p239 * Lambda_11_11_p283;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p291 = s11 * Lambda_11_11_p290 - c11 * Lambda_11_11_p289 +
      inverse_D5_p264 * Lambda_11_11_p287;
  const Real Lambda_11_11_p292 = s10 * Lambda_11_11_p288 - c10 * Lambda_11_11_p291;
  const Real Lambda_11_11_p293 = s11 * Lambda_11_11_p284 + c11 * Lambda_11_11_p286 +
      inverse_D5_p231 * Lambda_11_11_p287;
  const Real Lambda_11_11_p294 = inverse_D5_p228 * Lambda_11_11_p287;
  const Real Lambda_11_11_p295 = c10 * Lambda_11_11_p294 + s10 * Lambda_11_11_p293;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p296 = 0.282 * Lambda_11_11_p292 + minus_inverse_D8_p1 *
      Lambda_11_11_p295;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p297 = c11 * Lambda_11_11_p290 + s11 * Lambda_11_11_p289 -
      inverse_D5_p246 * Lambda_11_11_p287;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p298 = 0.282 * Lambda_11_11_p297 - s10 * Lambda_11_11_p294 + c10 *
      Lambda_11_11_p293 + minus_inverse_D8_p4 * Lambda_11_11_p295;
  const Real Lambda_11_11_p299 = s9 * Lambda_11_11_p296 + c9 * Lambda_11_11_p298;
  const Real Lambda_11_11_p300 = Lambda_11_11_p292 + inverse_D5_p281 * Lambda_11_11_p295;
  const Real Lambda_11_11_p301 = Lambda_11_11_p297 + inverse_D5_p253 * Lambda_11_11_p295;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p302 = c9 * Lambda_11_11_p301 + s9 * Lambda_11_11_p300 - inverse_D5_p322 *
      Lambda_11_11_p299;
  const Real Lambda_11_11_p303 = c10 * Lambda_11_11_p288 + s10 * Lambda_11_11_p291 +
      inverse_D5_p313 * Lambda_11_11_p295 + inverse_D5_p319 * Lambda_11_11_p299;
  const Real Lambda_11_11_p304 = c9 * Lambda_11_11_p296 - s9 * Lambda_11_11_p298 +
      minus_inverse_D7_p1 * Lambda_11_11_p299;
  const Real Lambda_11_11_p305 = Lambda_11_11_p46 * Lambda_11_11_p299;
  const Real Lambda_11_11_p306 = c8 * Lambda_11_11_p304 + s8 * Lambda_11_11_p305;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p307 = s8 * Lambda_11_11_p302 + c8 * Lambda_11_11_p303 - inverse_D5_p329 *
      Lambda_11_11_p306;
  const Real Lambda_11_11_p308 = s9 * Lambda_11_11_p301 - c9 * Lambda_11_11_p300 - inverse_D5_p303 *
      Lambda_11_11_p299 + inverse_D5_p309 * Lambda_11_11_p306;
  const Real Lambda_11_11_p309 = c7 * Lambda_11_11_p307 + s7 * Lambda_11_11_p308;
  const Real Lambda_11_11_p310 = c8 * Lambda_11_11_p302 - s8 * Lambda_11_11_p303 + inverse_D5_p359 *
      Lambda_11_11_p306;
  const Real Lambda_11_11_p311 = s8 * Lambda_11_11_p304 - c8 * Lambda_11_11_p305 - inverse_D5_p370 *
      Lambda_11_11_p306;
  const Real Lambda_11_11_p312 = Lambda_11_11_p58 * Lambda_11_11_p306;
  const Real Lambda_11_11_p313 = 0.18 * Lambda_11_11_p309 - 0.226 * Lambda_11_11_p310 - s7 *
      Lambda_11_11_p311 + c7 * Lambda_11_11_p312;
  const Real Lambda_11_11_p314 = s7 * Lambda_11_11_p307 - c7 * Lambda_11_11_p308;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p315 = Lambda_11_11_p314 + inverse_D5_p408 * Lambda_11_11_p313;
  const Real Lambda_11_11_p316 = 0.226 * Lambda_11_11_p314 - inverse_D5_p383 * Lambda_11_11_p313;
  const Real Lambda_11_11_p317 = 0.18 * Lambda_11_11_p314 + c7 * Lambda_11_11_p311 + s7 *
      Lambda_11_11_p312 - inverse_D5_p390 * Lambda_11_11_p313;
  const Real Lambda_11_11_p318 = 0.072 * Lambda_11_11_p315 + c6 * Lambda_11_11_p316 + s6 *
      Lambda_11_11_p317;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p319 = s6 * Lambda_11_11_p316 - c6 * Lambda_11_11_p317 - inverse_D1_p35 *
      Lambda_11_11_p318;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p320 = Lambda_11_11_p310 - inverse_D1_p2 * Lambda_11_11_p313;
  const Real Lambda_11_11_p321 = Lambda_11_11_p309 + inverse_D1_p11 * Lambda_11_11_p313;
  const Real Lambda_11_11_p322 = c6 * Lambda_11_11_p320 - s6 * Lambda_11_11_p321;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p323 = 0.072 * Lambda_11_11_p322 - inverse_D1_p25 * Lambda_11_11_p318;
  const Real Lambda_11_11_p324 = c5 * Lambda_11_11_p319 + s5 * Lambda_11_11_p323;
  const Real Lambda_11_11_p325 = s6 * Lambda_11_11_p320 + c6 * Lambda_11_11_p321 - inverse_D1_p58 *
      Lambda_11_11_p318;
  const Real Lambda_11_11_p326 = Lambda_11_11_p315 - inverse_D1_p54 * Lambda_11_11_p318;
  const Real Lambda_11_11_p327 = s5 * Lambda_11_11_p325 + c5 * Lambda_11_11_p326;
  const Real Lambda_11_11_p328 = Lambda_11_11_p322 - inverse_D1_p42 * Lambda_11_11_p318;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p329 = s4 * (0.21799999999999997 * Lambda_11_11_p328 - s5 *
      Lambda_11_11_p319 + c5 * Lambda_11_11_p323 + inverse_D3_p3 * Lambda_11_11_p324);
  const Real Lambda_11_11_p330 = c4 * (0.21799999999999997 * Lambda_11_11_p327 + inverse_D3_p1 *
      Lambda_11_11_p324) - Lambda_11_11_p329;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p331 = c5 * Lambda_11_11_p325 - s5 * Lambda_11_11_p326 - inverse_D1_p83 *
      Lambda_11_11_p324 - inverse_D1_p87 * Lambda_11_11_p330;
  const Real Lambda_11_11_p332 = s4 * (Lambda_11_11_p328 + inverse_D1_p48 * Lambda_11_11_p324) -
      c4 * (Lambda_11_11_p327 + inverse_D1_p67 * Lambda_11_11_p324) + inverse_D1_p89 *
      Lambda_11_11_p330;
  const Real Lambda_11_11_p333 = s3 * Lambda_11_11_p331 - c3 * Lambda_11_11_p332;
  const Real Lambda_11_11_p334 = 0.422 * Lambda_11_11_p333;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p335 = s2 * (c3 * Lambda_11_11_p331 + s3 * Lambda_11_11_p332 +
      inverse_D1_p102 * Lambda_11_11_p334) + c2 * (Lambda_11_11_p333 - inverse_D1_p98 *
      Lambda_11_11_p334);
  const Real Lambda_11_11_p336 = 0.434 * Lambda_11_11_p335;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p337 = inverse_D1 * Lambda_11_11_p336;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p338 = inverse_D2 * Lambda_11_11_p334;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p339 = inverse_D3 * Lambda_11_11_p330;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p340 = inverse_D4 * Lambda_11_11_p324;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p341 = inverse_D5 * Lambda_11_11_p318;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p342 = inverse_D6 * Lambda_11_11_p313;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p343 = minus_inverse_D7 * Lambda_11_11_p306;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p344 = minus_inverse_D8 * Lambda_11_11_p299;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p345 = minus_inverse_D9 * Lambda_11_11_p295;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p346 = minus_inverse_D10 * Lambda_11_11_p287;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p347 = inverse_D11 * Lambda_11_11_p283;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p348 = inverse_D12 * Lambda_11_11_p276;

  // link 13 (left_hand), force propagation
  const Real Lambda_11_11_p349 = 1065.380700001509 * Lambda_11_11_p273;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p350 = Lambda_11_11_p107 * Lambda_11_11_p349 - Lambda_11_11_p111 *
      Lambda_11_11_p348 - Lambda_11_11_p118 * Lambda_11_11_p347 - Lambda_11_11_p122 *
      Lambda_11_11_p346 - Lambda_11_11_p130 * Lambda_11_11_p345;
  const Real Lambda_11_11_p351 = Lambda_11_11_p350 - Lambda_11_11_p134 * Lambda_11_11_p344 -
      Lambda_11_11_p141 * Lambda_11_11_p343 + Lambda_11_11_p148 * Lambda_11_11_p342 +
      Lambda_11_11_p153 * Lambda_11_11_p341;
  const Real Lambda_11_11_p352 = Lambda_11_11_p351 + Lambda_11_11_p159 * Lambda_11_11_p340 +
      Lambda_11_11_p165 * Lambda_11_11_p339 + Lambda_11_11_p169 * Lambda_11_11_p338 +
      Lambda_11_11_p171 * Lambda_11_11_p337;
  const Real Lambda_11_11_p353 = 0.086 * Lambda_11_11_p19;
  const Real Lambda_11_11_p354 = Lambda_11_11_p352 * Lambda_11_11_p353;
  const Real Lambda_11_11_p355 = Lambda_11_11_p354 -
      (Lambda_11_11_p206 - (Lambda_11_11_p271 - Lambda_11_11_p260 * Lambda_11_11_p207));

  // link 13 (left_hand), force propagation
  const Real Lambda_11_11_p356 = s13 * Lambda_11_11_p16 - c13 * Lambda_11_11_p19;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p357 = s12 * Lambda_11_11_p356 - c12 * Lambda_11_11_p17;
  const Real Lambda_11_11_p358 = 0.269 * Lambda_11_11_p357;

  // link 13 (left_hand), force propagation
  const Real Lambda_11_11_p359 = c13 * Lambda_11_11_p16 + s13 * Lambda_11_11_p19;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p360 = 0.269 * Lambda_11_11_p359;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p361 = c11 * Lambda_11_11_p358 - s11 * Lambda_11_11_p360;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p362 = inverse_D5_p228 * Lambda_11_11_p361;
  const Real Lambda_11_11_p363 = s11 * Lambda_11_11_p358 + c11 * Lambda_11_11_p360 +
      inverse_D5_p231 * Lambda_11_11_p361;
  const Real Lambda_11_11_p364 = c10 * Lambda_11_11_p362 + s10 * Lambda_11_11_p363;
  const Real Lambda_11_11_p365 = c12 * Lambda_11_11_p356 + s12 * Lambda_11_11_p17 +
      inverse_D5_p273 * Lambda_11_11_p361;
  const Real Lambda_11_11_p366 = s11 * Lambda_11_11_p359 - c11 * Lambda_11_11_p357 +
      inverse_D5_p264 * Lambda_11_11_p361;
  const Real Lambda_11_11_p367 = s10 * Lambda_11_11_p365 - c10 * Lambda_11_11_p366;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p368 = 0.282 * Lambda_11_11_p367 + minus_inverse_D8_p1 *
      Lambda_11_11_p364;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p369 = c11 * Lambda_11_11_p359 + s11 * Lambda_11_11_p357 -
      inverse_D5_p246 * Lambda_11_11_p361;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p370 = 0.282 * Lambda_11_11_p369 - s10 * Lambda_11_11_p362 + c10 *
      Lambda_11_11_p363 + minus_inverse_D8_p4 * Lambda_11_11_p364;
  const Real Lambda_11_11_p371 = s9 * Lambda_11_11_p368 + c9 * Lambda_11_11_p370;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p372 = c9 * Lambda_11_11_p368 - s9 * Lambda_11_11_p370 +
      minus_inverse_D7_p1 * Lambda_11_11_p371;
  const Real Lambda_11_11_p373 = Lambda_11_11_p46 * Lambda_11_11_p371;
  const Real Lambda_11_11_p374 = c8 * Lambda_11_11_p372 + s8 * Lambda_11_11_p373;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p375 = Lambda_11_11_p369 + inverse_D5_p253 * Lambda_11_11_p364;
  const Real Lambda_11_11_p376 = Lambda_11_11_p367 + inverse_D5_p281 * Lambda_11_11_p364;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p377 = c9 * Lambda_11_11_p375 + s9 * Lambda_11_11_p376 - inverse_D5_p322 *
      Lambda_11_11_p371;
  const Real Lambda_11_11_p378 = c10 * Lambda_11_11_p365 + s10 * Lambda_11_11_p366 +
      inverse_D5_p313 * Lambda_11_11_p364 + inverse_D5_p319 * Lambda_11_11_p371;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p379 = s8 * Lambda_11_11_p377 + c8 * Lambda_11_11_p378 - inverse_D5_p329 *
      Lambda_11_11_p374;
  const Real Lambda_11_11_p380 = s9 * Lambda_11_11_p375 - c9 * Lambda_11_11_p376 - inverse_D5_p303 *
      Lambda_11_11_p371 + inverse_D5_p309 * Lambda_11_11_p374;
  const Real Lambda_11_11_p381 = c7 * Lambda_11_11_p379 + s7 * Lambda_11_11_p380;
  const Real Lambda_11_11_p382 = c8 * Lambda_11_11_p377 - s8 * Lambda_11_11_p378 + inverse_D5_p359 *
      Lambda_11_11_p374;
  const Real Lambda_11_11_p383 = s8 * Lambda_11_11_p372 - c8 * Lambda_11_11_p373 - inverse_D5_p370 *
      Lambda_11_11_p374;
  const Real Lambda_11_11_p384 = Lambda_11_11_p58 * Lambda_11_11_p374;
  const Real Lambda_11_11_p385 = 0.18 * Lambda_11_11_p381 - 0.226 * Lambda_11_11_p382 - s7 *
      Lambda_11_11_p383 + c7 * Lambda_11_11_p384;
  const Real Lambda_11_11_p386 = s7 * Lambda_11_11_p379 - c7 * Lambda_11_11_p380;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p387 = Lambda_11_11_p386 + inverse_D5_p408 * Lambda_11_11_p385;
  const Real Lambda_11_11_p388 = 0.226 * Lambda_11_11_p386 - inverse_D5_p383 * Lambda_11_11_p385;
  const Real Lambda_11_11_p389 = 0.18 * Lambda_11_11_p386 + c7 * Lambda_11_11_p383 + s7 *
      Lambda_11_11_p384 - inverse_D5_p390 * Lambda_11_11_p385;
  const Real Lambda_11_11_p390 = 0.072 * Lambda_11_11_p387 + c6 * Lambda_11_11_p388 + s6 *
      Lambda_11_11_p389;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p391 = s6 * Lambda_11_11_p388 - c6 * Lambda_11_11_p389 - inverse_D1_p35 *
      Lambda_11_11_p390;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p392 = Lambda_11_11_p382 - inverse_D1_p2 * Lambda_11_11_p385;
  const Real Lambda_11_11_p393 = Lambda_11_11_p381 + inverse_D1_p11 * Lambda_11_11_p385;
  const Real Lambda_11_11_p394 = c6 * Lambda_11_11_p392 - s6 * Lambda_11_11_p393;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p395 = 0.072 * Lambda_11_11_p394 - inverse_D1_p25 * Lambda_11_11_p390;
  const Real Lambda_11_11_p396 = c5 * Lambda_11_11_p391 + s5 * Lambda_11_11_p395;
  const Real Lambda_11_11_p397 = s6 * Lambda_11_11_p392 + c6 * Lambda_11_11_p393 - inverse_D1_p58 *
      Lambda_11_11_p390;
  const Real Lambda_11_11_p398 = Lambda_11_11_p387 - inverse_D1_p54 * Lambda_11_11_p390;
  const Real Lambda_11_11_p399 = s5 * Lambda_11_11_p397 + c5 * Lambda_11_11_p398;
  const Real Lambda_11_11_p400 = Lambda_11_11_p394 - inverse_D1_p42 * Lambda_11_11_p390;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p401 = s4 * (0.21799999999999997 * Lambda_11_11_p400 - s5 *
      Lambda_11_11_p391 + c5 * Lambda_11_11_p395 + inverse_D3_p3 * Lambda_11_11_p396);
  const Real Lambda_11_11_p402 = c4 * (0.21799999999999997 * Lambda_11_11_p399 + inverse_D3_p1 *
      Lambda_11_11_p396) - Lambda_11_11_p401;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p403 = c5 * Lambda_11_11_p397 - s5 * Lambda_11_11_p398 - inverse_D1_p83 *
      Lambda_11_11_p396 - inverse_D1_p87 * Lambda_11_11_p402;
  const Real Lambda_11_11_p404 = s4 * (Lambda_11_11_p400 + inverse_D1_p48 * Lambda_11_11_p396) -
      c4 * (Lambda_11_11_p399 + inverse_D1_p67 * Lambda_11_11_p396) + inverse_D1_p89 *
      Lambda_11_11_p402;
  const Real Lambda_11_11_p405 = s3 * Lambda_11_11_p403 - c3 * Lambda_11_11_p404;
  const Real Lambda_11_11_p406 = 0.422 * Lambda_11_11_p405;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p407 = s2 * (c3 * Lambda_11_11_p403 + s3 * Lambda_11_11_p404 +
      inverse_D1_p102 * Lambda_11_11_p406) + c2 * (Lambda_11_11_p405 - inverse_D1_p98 *
      Lambda_11_11_p406);
  const Real Lambda_11_11_p408 = 0.434 * Lambda_11_11_p407;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p409 = Lambda_11_11_p361 * Lambda_11_11_p180 + Lambda_11_11_p364 *
      Lambda_11_11_p179 + Lambda_11_11_p371 * Lambda_11_11_p178 + Lambda_11_11_p374 *
      Lambda_11_11_p177 - Lambda_11_11_p385 * Lambda_11_11_p176;
  const Real Lambda_11_11_p410 = Lambda_11_11_p409 - Lambda_11_11_p390 * Lambda_11_11_p175 -
      Lambda_11_11_p396 * Lambda_11_11_p174 - Lambda_11_11_p402 * Lambda_11_11_p173 -
      Lambda_11_11_p406 * Lambda_11_11_p172;
  const Real Lambda_11_11_p411 = Lambda_11_11_p410 - Lambda_11_11_p408 * Lambda_11_11_p84;
  const Real Lambda_11_11_p412 = Lambda_11_11_p213 * Lambda_11_11_p346 + Lambda_11_11_p219 *
      Lambda_11_11_p345 + Lambda_11_11_p223 * Lambda_11_11_p344 + Lambda_11_11_p226 *
      Lambda_11_11_p343 - Lambda_11_11_p237 * Lambda_11_11_p342;
  const Real Lambda_11_11_p413 = Lambda_11_11_p412 - Lambda_11_11_p242 * Lambda_11_11_p341 -
      Lambda_11_11_p248 * Lambda_11_11_p340 - Lambda_11_11_p254 * Lambda_11_11_p339 -
      Lambda_11_11_p258 * Lambda_11_11_p338;
  const Real Lambda_11_11_p414 = Lambda_11_11_p413 - Lambda_11_11_p260 * Lambda_11_11_p337;
  const Real Lambda_11_11_p415 = Lambda_11_11_p17 * Lambda_11_11_p349 + Lambda_11_11_p21 *
      Lambda_11_11_p348 + Lambda_11_11_p28 * Lambda_11_11_p347 - Lambda_11_11_p32 *
      Lambda_11_11_p346 - Lambda_11_11_p40 * Lambda_11_11_p345;
  const Real Lambda_11_11_p416 = Lambda_11_11_p415 - Lambda_11_11_p44 * Lambda_11_11_p344 -
      Lambda_11_11_p48 * Lambda_11_11_p343 + Lambda_11_11_p60 * Lambda_11_11_p342 +
      Lambda_11_11_p65 * Lambda_11_11_p341;
  const Real Lambda_11_11_p417 = Lambda_11_11_p416 + Lambda_11_11_p71 * Lambda_11_11_p340 +
      Lambda_11_11_p77 * Lambda_11_11_p339 + Lambda_11_11_p81 * Lambda_11_11_p338 +
      Lambda_11_11_p83 * Lambda_11_11_p337;
  const Real Lambda_11_11_p418 = Lambda_11_11_p273 * Lambda_11_11_p349 + Lambda_11_11_p276 *
      Lambda_11_11_p348 + Lambda_11_11_p283 * Lambda_11_11_p347 - Lambda_11_11_p287 *
      Lambda_11_11_p346 - Lambda_11_11_p295 * Lambda_11_11_p345;
  const Real Lambda_11_11_p419 = Lambda_11_11_p418 - Lambda_11_11_p299 * Lambda_11_11_p344 -
      Lambda_11_11_p306 * Lambda_11_11_p343 + Lambda_11_11_p313 * Lambda_11_11_p342 +
      Lambda_11_11_p318 * Lambda_11_11_p341;
  const Real Lambda_11_11_p420 = Lambda_11_11_p419 + Lambda_11_11_p324 * Lambda_11_11_p340 +
      Lambda_11_11_p330 * Lambda_11_11_p339 + Lambda_11_11_p334 * Lambda_11_11_p338 +
      Lambda_11_11_p336 * Lambda_11_11_p337;
  const Real Lambda_11_11_p421 = Lambda_11_11_p414 - Lambda_11_11_p417 * Lambda_11_11_p205 +
      Lambda_11_11_p420 * Lambda_11_11_p353;
  const Real Lambda_11_11_p422 = 0.086 * Lambda_11_11_p109;
  const Real Lambda_11_11_p423 = inverse_D1 * Lambda_11_11_p408;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p424 = inverse_D2 * Lambda_11_11_p406;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p425 = inverse_D3 * Lambda_11_11_p402;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p426 = inverse_D4 * Lambda_11_11_p396;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p427 = inverse_D5 * Lambda_11_11_p390;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p428 = inverse_D6 * Lambda_11_11_p385;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p429 = minus_inverse_D7 * Lambda_11_11_p374;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p430 = minus_inverse_D8 * Lambda_11_11_p371;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p431 = minus_inverse_D9 * Lambda_11_11_p364;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p432 = minus_inverse_D10 * Lambda_11_11_p361;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p433 = Lambda_11_11_p213 * Lambda_11_11_p432 + Lambda_11_11_p219 *
      Lambda_11_11_p431 + Lambda_11_11_p223 * Lambda_11_11_p430 + Lambda_11_11_p226 *
      Lambda_11_11_p429 - Lambda_11_11_p237 * Lambda_11_11_p428;
  const Real Lambda_11_11_p434 = Lambda_11_11_p433 - Lambda_11_11_p242 * Lambda_11_11_p427 -
      Lambda_11_11_p248 * Lambda_11_11_p426 - Lambda_11_11_p254 * Lambda_11_11_p425 -
      Lambda_11_11_p258 * Lambda_11_11_p424;
  const Real Lambda_11_11_p435 = Lambda_11_11_p361 * Lambda_11_11_p346 + Lambda_11_11_p364 *
      Lambda_11_11_p345 + Lambda_11_11_p371 * Lambda_11_11_p344 + Lambda_11_11_p374 *
      Lambda_11_11_p343 - Lambda_11_11_p385 * Lambda_11_11_p342;
  const Real Lambda_11_11_p436 = Lambda_11_11_p435 - Lambda_11_11_p390 * Lambda_11_11_p341 -
      Lambda_11_11_p396 * Lambda_11_11_p340 - Lambda_11_11_p402 * Lambda_11_11_p339 -
      Lambda_11_11_p406 * Lambda_11_11_p338;
  const Real Lambda_11_11_p437 = Lambda_11_11_p436 - Lambda_11_11_p408 * Lambda_11_11_p337;
  const Real Lambda_11_11_p438 = Lambda_11_11_p205 * (Lambda_11_11_p411 + Lambda_11_11_p355) +
      (Lambda_11_11_p434 - Lambda_11_11_p260 * Lambda_11_11_p423 + Lambda_11_11_p422 *
      Lambda_11_11_p421 - Lambda_11_11_p437 * Lambda_11_11_p353);
  const Real Lambda_11_11_p439 = Lambda_11_11_p213 * Lambda_11_11_p180 + Lambda_11_11_p219 *
      Lambda_11_11_p179 + Lambda_11_11_p223 * Lambda_11_11_p178 + Lambda_11_11_p226 *
      Lambda_11_11_p177 - Lambda_11_11_p237 * Lambda_11_11_p176;
  const Real Lambda_11_11_p440 = Lambda_11_11_p439 - Lambda_11_11_p242 * Lambda_11_11_p175 -
      Lambda_11_11_p248 * Lambda_11_11_p174 - Lambda_11_11_p254 * Lambda_11_11_p173 -
      Lambda_11_11_p258 * Lambda_11_11_p172;
  const Real Lambda_11_11_p441 = Lambda_11_11_p440 - Lambda_11_11_p260 * Lambda_11_11_p84;
  const Real Lambda_11_11_p442 = Lambda_11_11_p17 * Lambda_11_11_p183 + Lambda_11_11_p21 *
      Lambda_11_11_p182 + Lambda_11_11_p28 * Lambda_11_11_p181 - Lambda_11_11_p32 *
      Lambda_11_11_p180 - Lambda_11_11_p40 * Lambda_11_11_p179;
  const Real Lambda_11_11_p443 = Lambda_11_11_p442 - Lambda_11_11_p44 * Lambda_11_11_p178 -
      Lambda_11_11_p48 * Lambda_11_11_p177 + Lambda_11_11_p60 * Lambda_11_11_p176 +
      Lambda_11_11_p65 * Lambda_11_11_p175;
  const Real Lambda_11_11_p444 = Lambda_11_11_p443 + Lambda_11_11_p71 * Lambda_11_11_p174 +
      Lambda_11_11_p77 * Lambda_11_11_p173 + Lambda_11_11_p81 * Lambda_11_11_p172 +
      Lambda_11_11_p83 * Lambda_11_11_p84;
  const Real Lambda_11_11_p445 = Lambda_11_11_p441 - Lambda_11_11_p444 * Lambda_11_11_p205 +
      Lambda_11_11_p417 * Lambda_11_11_p353;
  const Real Lambda_11_11_p446 = Lambda_11_11_p213 * (minus_inverse_D10 * Lambda_11_11_p213) +
      Lambda_11_11_p219 * (minus_inverse_D9 * Lambda_11_11_p219) + Lambda_11_11_p223 *
      (minus_inverse_D8 * Lambda_11_11_p223);
  const Real Lambda_11_11_p447 = Lambda_11_11_p446 + Lambda_11_11_p226 *
      (minus_inverse_D7 * Lambda_11_11_p226) - Lambda_11_11_p237 *
      (inverse_D6 * Lambda_11_11_p237) - Lambda_11_11_p242 * (inverse_D5 * Lambda_11_11_p242);
  const Real Lambda_11_11_p448 = Lambda_11_11_p447 - Lambda_11_11_p248 *
      (inverse_D4 * Lambda_11_11_p248) - Lambda_11_11_p254 * (inverse_D3 * Lambda_11_11_p254) -
      Lambda_11_11_p258 * (inverse_D2 * Lambda_11_11_p258);
  const Real Lambda_11_11_p449 = Lambda_11_11_p448 - Lambda_11_11_p260 *
      (inverse_D1 * Lambda_11_11_p260) + Lambda_11_11_p205 *
      (Lambda_11_11_p441 + Lambda_11_11_p445) - Lambda_11_11_p353 *
      (Lambda_11_11_p414 + Lambda_11_11_p421);
  const Real Lambda_11_11_p450 = 1.0 / Lambda_11_11_p449;

  // link 14 (right_shoulder1), pose
  const Real Lambda_11_11_p451 = c14 * Lambda_11_11_p188 + s14 * Lambda_11_11_p191;
  const Real Lambda_11_11_p452 = s14 * Lambda_11_11_p188 - c14 * Lambda_11_11_p191;

  // link 15 (right_shoulder2), pose
  const Real Lambda_11_11_p453 = c15 * Lambda_11_11_p194 + s15 * Lambda_11_11_p452;

  // link 16 (right_upperarm), pose
  const Real Lambda_11_11_p454 = s16 * Lambda_11_11_p451 - c16 * Lambda_11_11_p453;
  const Real Lambda_11_11_p455 = c16 * Lambda_11_11_p451 + s16 * Lambda_11_11_p453;

  // link 15 (right_shoulder2), pose
  const Real Lambda_11_11_p456 = s15 * Lambda_11_11_p194 - c15 * Lambda_11_11_p452;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p457 = s17 * Lambda_11_11_p456 + c17 * Lambda_11_11_p455;

  // link 18 (right_wrist1), pose
  const Real Lambda_11_11_p458 = c18 * Lambda_11_11_p454 + s18 * Lambda_11_11_p457;
  const Real Lambda_11_11_p459 = s18 * Lambda_11_11_p454 - c18 * Lambda_11_11_p457;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p460 = c17 * Lambda_11_11_p456 - s17 * Lambda_11_11_p455;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p461 = c19 * Lambda_11_11_p460 + s19 * Lambda_11_11_p459;

  // link 20 (right_hand), pose
  const Real Lambda_11_11_p462 = c20 * Lambda_11_11_p458 + s20 * Lambda_11_11_p461;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p463 = s19 * Lambda_11_11_p460 - c19 * Lambda_11_11_p459;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p464 = Lambda_11_11_p462 - 0.04672761636452121 * Lambda_11_11_p463;

  // link 20 (right_hand), pose
  const Real Lambda_11_11_p465 = s20 * Lambda_11_11_p458 - c20 * Lambda_11_11_p461;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p466 = Lambda_11_11_p465 - 0.11533812622014242 * Lambda_11_11_p463;
  const Real Lambda_11_11_p467 = c20 * Lambda_11_11_p464 + s20 * Lambda_11_11_p466;
  const Real Lambda_11_11_p468 = 17.32841575379867 * Lambda_11_11_p463;
  const Real Lambda_11_11_p469 = 3.0523172236718206 * Lambda_11_11_p463;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p470 = s20 * Lambda_11_11_p468 + c20 * Lambda_11_11_p469 - inverse_D5_p8 *
      Lambda_11_11_p467;
  const Real Lambda_11_11_p471 = inverse_D5_p2 * Lambda_11_11_p467;
  const Real Lambda_11_11_p472 = s19 * Lambda_11_11_p470 - c19 * Lambda_11_11_p471;
  const Real Lambda_11_11_p473 = s20 * Lambda_11_11_p464 - c20 * Lambda_11_11_p466 -
      inverse_D18_p1 * Lambda_11_11_p467;
  const Real Lambda_11_11_p474 = c19 * Lambda_11_11_p473;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p475 = 0.269 * Lambda_11_11_p472 - inverse_D5_p23 * Lambda_11_11_p474;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p476 = c20 * Lambda_11_11_p468 - s20 * Lambda_11_11_p469 +
      inverse_D5_p14 * Lambda_11_11_p467;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p477 = 0.269 * Lambda_11_11_p476 + s19 * Lambda_11_11_p473 -
      inverse_D5_p29 * Lambda_11_11_p474;
  const Real Lambda_11_11_p478 = c18 * Lambda_11_11_p475 - s18 * Lambda_11_11_p477;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p479 = c19 * Lambda_11_11_p470 + s19 * Lambda_11_11_p471 +
      inverse_D5_p86 * Lambda_11_11_p474 - inverse_D5_p91 * Lambda_11_11_p478;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p480 = Lambda_11_11_p472 - inverse_D5_p54 * Lambda_11_11_p474;
  const Real Lambda_11_11_p481 = Lambda_11_11_p476 - inverse_D5_p57 * Lambda_11_11_p474;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p482 = s18 * Lambda_11_11_p481 - c18 * Lambda_11_11_p480 +
      inverse_D5_p82 * Lambda_11_11_p478;
  const Real Lambda_11_11_p483 = s17 * Lambda_11_11_p479 - c17 * Lambda_11_11_p482;
  const Real Lambda_11_11_p484 = s18 * Lambda_11_11_p475 + c18 * Lambda_11_11_p477 +
      inverse_D5_p49 * Lambda_11_11_p478;
  const Real Lambda_11_11_p485 = inverse_D5_p46 * Lambda_11_11_p478;
  const Real Lambda_11_11_p486 = c17 * Lambda_11_11_p485 + s17 * Lambda_11_11_p484;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p487 = 0.282 * Lambda_11_11_p483 - inverse_D15_p1 * Lambda_11_11_p486;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p488 = c18 * Lambda_11_11_p481 + s18 * Lambda_11_11_p480 -
      inverse_D5_p64 * Lambda_11_11_p478;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p489 = 0.282 * Lambda_11_11_p488 - s17 * Lambda_11_11_p485 + c17 *
      Lambda_11_11_p484 + inverse_D15_p4 * Lambda_11_11_p486;
  const Real Lambda_11_11_p490 = s16 * Lambda_11_11_p487 + c16 * Lambda_11_11_p489;
  const Real Lambda_11_11_p491 = Lambda_11_11_p483 - inverse_D5_p99 * Lambda_11_11_p486;
  const Real Lambda_11_11_p492 = Lambda_11_11_p488 + inverse_D5_p71 * Lambda_11_11_p486;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p493 = c16 * Lambda_11_11_p492 + s16 * Lambda_11_11_p491 -
      inverse_D5_p140 * Lambda_11_11_p490;
  const Real Lambda_11_11_p494 = c17 * Lambda_11_11_p479 + s17 * Lambda_11_11_p482 +
      inverse_D5_p131 * Lambda_11_11_p486 + inverse_D5_p137 * Lambda_11_11_p490;
  const Real Lambda_11_11_p495 = c16 * Lambda_11_11_p487 - s16 * Lambda_11_11_p489 +
      inverse_D14_p1 * Lambda_11_11_p490;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_11_11_p496 = 0.00010499999999999999 / inverse_D15_p9;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p497 = Lambda_11_11_p496 * Lambda_11_11_p490;
  const Real Lambda_11_11_p498 = c15 * Lambda_11_11_p495 - s15 * Lambda_11_11_p497;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p499 = s15 * Lambda_11_11_p493 + c15 * Lambda_11_11_p494 +
      inverse_D5_p147 * Lambda_11_11_p498;
  const Real Lambda_11_11_p500 = s16 * Lambda_11_11_p492 - c16 * Lambda_11_11_p491 -
      inverse_D5_p121 * Lambda_11_11_p490 - inverse_D5_p127 * Lambda_11_11_p498;
  const Real Lambda_11_11_p501 = c14 * Lambda_11_11_p499 + s14 * Lambda_11_11_p500;
  const Real Lambda_11_11_p502 = c15 * Lambda_11_11_p493 - s15 * Lambda_11_11_p494 +
      inverse_D5_p177 * Lambda_11_11_p498;
  const Real Lambda_11_11_p503 = s15 * Lambda_11_11_p495 + c15 * Lambda_11_11_p497 -
      inverse_D5_p365 * Lambda_11_11_p498;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_11_11_p504 = 2.6249999999999998e-05 / inverse_D14_p8;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p505 = Lambda_11_11_p504 * Lambda_11_11_p498;
  const Real Lambda_11_11_p506 = 0.18 * Lambda_11_11_p501 + 0.226 * Lambda_11_11_p502 + s14 *
      Lambda_11_11_p503 - c14 * Lambda_11_11_p505;
  const Real Lambda_11_11_p507 = s14 * Lambda_11_11_p499 - c14 * Lambda_11_11_p500;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p508 = Lambda_11_11_p507 - inverse_D5_p408 * Lambda_11_11_p506;
  const Real Lambda_11_11_p509 = 0.226 * Lambda_11_11_p507 + inverse_D5_p383 * Lambda_11_11_p506;
  const Real Lambda_11_11_p510 = 0.18 * Lambda_11_11_p507 - c14 * Lambda_11_11_p503 - s14 *
      Lambda_11_11_p505 - inverse_D5_p390 * Lambda_11_11_p506;
  const Real Lambda_11_11_p511 = 0.072 * Lambda_11_11_p508 + c6 * Lambda_11_11_p509 - s6 *
      Lambda_11_11_p510;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p512 = s6 * Lambda_11_11_p509 + c6 * Lambda_11_11_p510 - inverse_D1_p35 *
      Lambda_11_11_p511;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p513 = Lambda_11_11_p502 + inverse_D1_p2 * Lambda_11_11_p506;
  const Real Lambda_11_11_p514 = Lambda_11_11_p501 - inverse_D1_p11 * Lambda_11_11_p506;
  const Real Lambda_11_11_p515 = c6 * Lambda_11_11_p513 - s6 * Lambda_11_11_p514;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p516 = 0.072 * Lambda_11_11_p515 - inverse_D1_p25 * Lambda_11_11_p511;
  const Real Lambda_11_11_p517 = c5 * Lambda_11_11_p512 + s5 * Lambda_11_11_p516;
  const Real Lambda_11_11_p518 = s6 * Lambda_11_11_p513 + c6 * Lambda_11_11_p514 - inverse_D1_p58 *
      Lambda_11_11_p511;
  const Real Lambda_11_11_p519 = Lambda_11_11_p508 - inverse_D1_p54 * Lambda_11_11_p511;
  const Real Lambda_11_11_p520 = s5 * Lambda_11_11_p518 + c5 * Lambda_11_11_p519;
  const Real Lambda_11_11_p521 = Lambda_11_11_p515 - inverse_D1_p42 * Lambda_11_11_p511;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p522 = s4 * (0.21799999999999997 * Lambda_11_11_p521 - s5 *
      Lambda_11_11_p512 + c5 * Lambda_11_11_p516 + inverse_D3_p3 * Lambda_11_11_p517);
  const Real Lambda_11_11_p523 = c4 * (0.21799999999999997 * Lambda_11_11_p520 + inverse_D3_p1 *
      Lambda_11_11_p517) - Lambda_11_11_p522;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p524 = c5 * Lambda_11_11_p518 - s5 * Lambda_11_11_p519 - inverse_D1_p83 *
      Lambda_11_11_p517 - inverse_D1_p87 * Lambda_11_11_p523;
  const Real Lambda_11_11_p525 = s4 * (Lambda_11_11_p521 + inverse_D1_p48 * Lambda_11_11_p517) -
      c4 * (Lambda_11_11_p520 + inverse_D1_p67 * Lambda_11_11_p517) + inverse_D1_p89 *
      Lambda_11_11_p523;
  const Real Lambda_11_11_p526 = s3 * Lambda_11_11_p524 - c3 * Lambda_11_11_p525;
  const Real Lambda_11_11_p527 = 0.422 * Lambda_11_11_p526;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p528 = s2 * (c3 * Lambda_11_11_p524 + s3 * Lambda_11_11_p525 +
      inverse_D1_p102 * Lambda_11_11_p527) + c2 * (Lambda_11_11_p526 - inverse_D1_p98 *
      Lambda_11_11_p527);
  const Real Lambda_11_11_p529 = 0.434 * Lambda_11_11_p528;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p530 = inverse_D1 * Lambda_11_11_p529;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p531 = inverse_D2 * Lambda_11_11_p527;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p532 = inverse_D3 * Lambda_11_11_p523;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p533 = inverse_D4 * Lambda_11_11_p517;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p534 = inverse_D5 * Lambda_11_11_p511;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p535 = inverse_D6 * Lambda_11_11_p506;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p536 = Lambda_11_11_p237 * Lambda_11_11_p535 - Lambda_11_11_p242 *
      Lambda_11_11_p534 - Lambda_11_11_p248 * Lambda_11_11_p533 - Lambda_11_11_p254 *
      Lambda_11_11_p532 - Lambda_11_11_p258 * Lambda_11_11_p531;
  const Real Lambda_11_11_p537 = Lambda_11_11_p536 - Lambda_11_11_p260 * Lambda_11_11_p530;
  const Real Lambda_11_11_p538 = Lambda_11_11_p60 * Lambda_11_11_p535 - Lambda_11_11_p65 *
      Lambda_11_11_p534 - Lambda_11_11_p71 * Lambda_11_11_p533 - Lambda_11_11_p77 *
      Lambda_11_11_p532 - Lambda_11_11_p81 * Lambda_11_11_p531;
  const Real Lambda_11_11_p539 = Lambda_11_11_p538 - Lambda_11_11_p83 * Lambda_11_11_p530;
  const Real Lambda_11_11_p540 = Lambda_11_11_p313 * Lambda_11_11_p535 - Lambda_11_11_p318 *
      Lambda_11_11_p534 - Lambda_11_11_p324 * Lambda_11_11_p533 - Lambda_11_11_p330 *
      Lambda_11_11_p532 - Lambda_11_11_p334 * Lambda_11_11_p531;
  const Real Lambda_11_11_p541 = Lambda_11_11_p540 - Lambda_11_11_p336 * Lambda_11_11_p530;
  const Real Lambda_11_11_p542 = Lambda_11_11_p537 + Lambda_11_11_p539 * Lambda_11_11_p205 -
      Lambda_11_11_p541 * Lambda_11_11_p353;
  const Real Lambda_11_11_p543 = Lambda_11_11_p542 * Lambda_11_11_p450;
  const Real Lambda_11_11_p544 = Lambda_11_11_p385 * Lambda_11_11_p535 - Lambda_11_11_p390 *
      Lambda_11_11_p534 - Lambda_11_11_p396 * Lambda_11_11_p533 - Lambda_11_11_p402 *
      Lambda_11_11_p532 - Lambda_11_11_p406 * Lambda_11_11_p531;
  const Real Lambda_11_11_p545 = Lambda_11_11_p544 - Lambda_11_11_p408 * Lambda_11_11_p530;
  const Real Lambda_11_11_p546 = Lambda_11_11_p148 * Lambda_11_11_p535 - Lambda_11_11_p153 *
      Lambda_11_11_p534 - Lambda_11_11_p159 * Lambda_11_11_p533 - Lambda_11_11_p165 *
      Lambda_11_11_p532 - Lambda_11_11_p169 * Lambda_11_11_p531;
  const Real Lambda_11_11_p547 = Lambda_11_11_p546 - Lambda_11_11_p171 * Lambda_11_11_p530;
  const Real Lambda_11_11_p548 = Lambda_11_11_p545 + Lambda_11_11_p541 * Lambda_11_11_p422 +
      Lambda_11_11_p547 * Lambda_11_11_p205 - Lambda_11_11_p438 * Lambda_11_11_p543;
  const Real Lambda_11_11_p549 = Lambda_11_11_p438 * Lambda_11_11_p450;
  const Real Lambda_11_11_p550 = Lambda_11_11_p437 - Lambda_11_11_p420 * Lambda_11_11_p422 -
      Lambda_11_11_p352 * Lambda_11_11_p205;
  const Real Lambda_11_11_p551 = Lambda_11_11_p361 * Lambda_11_11_p432 + Lambda_11_11_p364 *
      Lambda_11_11_p431 + Lambda_11_11_p371 * Lambda_11_11_p430 + Lambda_11_11_p374 *
      Lambda_11_11_p429 - Lambda_11_11_p385 * Lambda_11_11_p428;
  const Real Lambda_11_11_p552 = Lambda_11_11_p551 - Lambda_11_11_p390 * Lambda_11_11_p427 -
      Lambda_11_11_p396 * Lambda_11_11_p426 - Lambda_11_11_p402 * Lambda_11_11_p425 -
      Lambda_11_11_p406 * Lambda_11_11_p424;
  const Real Lambda_11_11_p553 = Lambda_11_11_p361 * Lambda_11_11_p269 + Lambda_11_11_p364 *
      Lambda_11_11_p268 + Lambda_11_11_p371 * Lambda_11_11_p267 + Lambda_11_11_p374 *
      Lambda_11_11_p266 - Lambda_11_11_p385 * Lambda_11_11_p265;
  const Real Lambda_11_11_p554 = Lambda_11_11_p553 - Lambda_11_11_p390 * Lambda_11_11_p264 -
      Lambda_11_11_p396 * Lambda_11_11_p263 - Lambda_11_11_p402 * Lambda_11_11_p262 -
      Lambda_11_11_p406 * Lambda_11_11_p261;
  const Real Lambda_11_11_p555 = Lambda_11_11_p554 - Lambda_11_11_p408 * Lambda_11_11_p207;
  const Real Lambda_11_11_p556 = Lambda_11_11_p107 * (1065.380700001509 * Lambda_11_11_p107) +
      Lambda_11_11_p111 * (inverse_D12 * Lambda_11_11_p111) + Lambda_11_11_p118 *
      (inverse_D11 * Lambda_11_11_p118);
  const Real Lambda_11_11_p557 = Lambda_11_11_p556 - Lambda_11_11_p122 * Lambda_11_11_p269 -
      Lambda_11_11_p130 * Lambda_11_11_p268 - Lambda_11_11_p134 * Lambda_11_11_p267 -
      Lambda_11_11_p141 * Lambda_11_11_p266;
  const Real Lambda_11_11_p558 = Lambda_11_11_p557 + Lambda_11_11_p148 * Lambda_11_11_p265 +
      Lambda_11_11_p153 * Lambda_11_11_p264 + Lambda_11_11_p159 * Lambda_11_11_p263 +
      Lambda_11_11_p165 * Lambda_11_11_p262;
  const Real Lambda_11_11_p559 = Lambda_11_11_p558 + Lambda_11_11_p169 * Lambda_11_11_p261 +
      Lambda_11_11_p171 * Lambda_11_11_p207;
  const Real Lambda_11_11_p560 = Lambda_11_11_p555 - Lambda_11_11_p352 * Lambda_11_11_p422 -
      Lambda_11_11_p559 * Lambda_11_11_p205;
  const Real Lambda_11_11_p561 = Lambda_11_11_p552 - Lambda_11_11_p408 * Lambda_11_11_p423 +
      Lambda_11_11_p422 * (Lambda_11_11_p437 + Lambda_11_11_p550) + Lambda_11_11_p205 *
      (Lambda_11_11_p555 + Lambda_11_11_p560);
  const Real Lambda_11_11_p562 = 1.0 / (Lambda_11_11_p561 - Lambda_11_11_p438 * Lambda_11_11_p549);
  const Real Lambda_11_11_p563 = Lambda_11_11_p548 * Lambda_11_11_p562;

  // link 13 (left_hand), force propagation
  const Real Lambda_11_11_p564 = c13 * Lambda_11_11_p272 + s13 * Lambda_11_11_p204;
  const Real Lambda_11_11_p565 = s13 * Lambda_11_11_p272 - c13 * Lambda_11_11_p204;

  // link 12 (left_wrist2), force propagation
  const Real Lambda_11_11_p566 = s12 * Lambda_11_11_p565 - c12 * Lambda_11_11_p273;
  const Real Lambda_11_11_p567 = 0.269 * Lambda_11_11_p566;
  const Real Lambda_11_11_p568 = 0.269 * Lambda_11_11_p564;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_11_11_p569 = c11 * Lambda_11_11_p567 - s11 * Lambda_11_11_p568;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p570 = s11 * Lambda_11_11_p564 - c11 * Lambda_11_11_p566 +
      inverse_D5_p264 * Lambda_11_11_p569;
  const Real Lambda_11_11_p571 = c12 * Lambda_11_11_p565 + s12 * Lambda_11_11_p273 +
      inverse_D5_p273 * Lambda_11_11_p569;
  const Real Lambda_11_11_p572 = s10 * Lambda_11_11_p571 - c10 * Lambda_11_11_p570;
  const Real Lambda_11_11_p573 = s11 * Lambda_11_11_p567 + c11 * Lambda_11_11_p568 +
      inverse_D5_p231 * Lambda_11_11_p569;
  const Real Lambda_11_11_p574 = inverse_D5_p228 * Lambda_11_11_p569;
  const Real Lambda_11_11_p575 = c10 * Lambda_11_11_p574 + s10 * Lambda_11_11_p573;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p576 = 0.282 * Lambda_11_11_p572 + minus_inverse_D8_p1 *
      Lambda_11_11_p575;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p577 = c11 * Lambda_11_11_p564 + s11 * Lambda_11_11_p566 -
      inverse_D5_p246 * Lambda_11_11_p569;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p578 = 0.282 * Lambda_11_11_p577 - s10 * Lambda_11_11_p574 + c10 *
      Lambda_11_11_p573 + minus_inverse_D8_p4 * Lambda_11_11_p575;
  const Real Lambda_11_11_p579 = s9 * Lambda_11_11_p576 + c9 * Lambda_11_11_p578;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p580 = c9 * Lambda_11_11_p576 - s9 * Lambda_11_11_p578 +
      minus_inverse_D7_p1 * Lambda_11_11_p579;
  const Real Lambda_11_11_p581 = Lambda_11_11_p46 * Lambda_11_11_p579;
  const Real Lambda_11_11_p582 = c8 * Lambda_11_11_p580 + s8 * Lambda_11_11_p581;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p583 = Lambda_11_11_p577 + inverse_D5_p253 * Lambda_11_11_p575;
  const Real Lambda_11_11_p584 = Lambda_11_11_p572 + inverse_D5_p281 * Lambda_11_11_p575;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p585 = c9 * Lambda_11_11_p583 + s9 * Lambda_11_11_p584 - inverse_D5_p322 *
      Lambda_11_11_p579;
  const Real Lambda_11_11_p586 = c10 * Lambda_11_11_p571 + s10 * Lambda_11_11_p570 +
      inverse_D5_p313 * Lambda_11_11_p575 + inverse_D5_p319 * Lambda_11_11_p579;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p587 = s8 * Lambda_11_11_p585 + c8 * Lambda_11_11_p586 - inverse_D5_p329 *
      Lambda_11_11_p582;
  const Real Lambda_11_11_p588 = s9 * Lambda_11_11_p583 - c9 * Lambda_11_11_p584 - inverse_D5_p303 *
      Lambda_11_11_p579 + inverse_D5_p309 * Lambda_11_11_p582;
  const Real Lambda_11_11_p589 = c7 * Lambda_11_11_p587 + s7 * Lambda_11_11_p588;
  const Real Lambda_11_11_p590 = c8 * Lambda_11_11_p585 - s8 * Lambda_11_11_p586 + inverse_D5_p359 *
      Lambda_11_11_p582;
  const Real Lambda_11_11_p591 = s8 * Lambda_11_11_p580 - c8 * Lambda_11_11_p581 - inverse_D5_p370 *
      Lambda_11_11_p582;
  const Real Lambda_11_11_p592 = Lambda_11_11_p58 * Lambda_11_11_p582;
  const Real Lambda_11_11_p593 = 0.18 * Lambda_11_11_p589 - 0.226 * Lambda_11_11_p590 - s7 *
      Lambda_11_11_p591 + c7 * Lambda_11_11_p592;
  const Real Lambda_11_11_p594 = s7 * Lambda_11_11_p587 - c7 * Lambda_11_11_p588;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p595 = Lambda_11_11_p594 + inverse_D5_p408 * Lambda_11_11_p593;
  const Real Lambda_11_11_p596 = 0.226 * Lambda_11_11_p594 - inverse_D5_p383 * Lambda_11_11_p593;
  const Real Lambda_11_11_p597 = 0.18 * Lambda_11_11_p594 + c7 * Lambda_11_11_p591 + s7 *
      Lambda_11_11_p592 - inverse_D5_p390 * Lambda_11_11_p593;
  const Real Lambda_11_11_p598 = 0.072 * Lambda_11_11_p595 + c6 * Lambda_11_11_p596 + s6 *
      Lambda_11_11_p597;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p599 = s6 * Lambda_11_11_p596 - c6 * Lambda_11_11_p597 - inverse_D1_p35 *
      Lambda_11_11_p598;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p600 = Lambda_11_11_p590 - inverse_D1_p2 * Lambda_11_11_p593;
  const Real Lambda_11_11_p601 = Lambda_11_11_p589 + inverse_D1_p11 * Lambda_11_11_p593;
  const Real Lambda_11_11_p602 = c6 * Lambda_11_11_p600 - s6 * Lambda_11_11_p601;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p603 = 0.072 * Lambda_11_11_p602 - inverse_D1_p25 * Lambda_11_11_p598;
  const Real Lambda_11_11_p604 = c5 * Lambda_11_11_p599 + s5 * Lambda_11_11_p603;
  const Real Lambda_11_11_p605 = s6 * Lambda_11_11_p600 + c6 * Lambda_11_11_p601 - inverse_D1_p58 *
      Lambda_11_11_p598;
  const Real Lambda_11_11_p606 = Lambda_11_11_p595 - inverse_D1_p54 * Lambda_11_11_p598;
  const Real Lambda_11_11_p607 = s5 * Lambda_11_11_p605 + c5 * Lambda_11_11_p606;
  const Real Lambda_11_11_p608 = Lambda_11_11_p602 - inverse_D1_p42 * Lambda_11_11_p598;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p609 = s4 * (0.21799999999999997 * Lambda_11_11_p608 - s5 *
      Lambda_11_11_p599 + c5 * Lambda_11_11_p603 + inverse_D3_p3 * Lambda_11_11_p604);
  const Real Lambda_11_11_p610 = c4 * (0.21799999999999997 * Lambda_11_11_p607 + inverse_D3_p1 *
      Lambda_11_11_p604) - Lambda_11_11_p609;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p611 = c5 * Lambda_11_11_p605 - s5 * Lambda_11_11_p606 - inverse_D1_p83 *
      Lambda_11_11_p604 - inverse_D1_p87 * Lambda_11_11_p610;
  const Real Lambda_11_11_p612 = s4 * (Lambda_11_11_p608 + inverse_D1_p48 * Lambda_11_11_p604) -
      c4 * (Lambda_11_11_p607 + inverse_D1_p67 * Lambda_11_11_p604) + inverse_D1_p89 *
      Lambda_11_11_p610;
  const Real Lambda_11_11_p613 = s3 * Lambda_11_11_p611 - c3 * Lambda_11_11_p612;
  const Real Lambda_11_11_p614 = 0.422 * Lambda_11_11_p613;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p615 = s2 * (c3 * Lambda_11_11_p611 + s3 * Lambda_11_11_p612 +
      inverse_D1_p102 * Lambda_11_11_p614) + c2 * (Lambda_11_11_p613 - inverse_D1_p98 *
      Lambda_11_11_p614);
  const Real Lambda_11_11_p616 = 0.434 * Lambda_11_11_p615;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p617 = Lambda_11_11_p569 * Lambda_11_11_p346 + Lambda_11_11_p575 *
      Lambda_11_11_p345 + Lambda_11_11_p579 * Lambda_11_11_p344 + Lambda_11_11_p582 *
      Lambda_11_11_p343 - Lambda_11_11_p593 * Lambda_11_11_p342;
  const Real Lambda_11_11_p618 = Lambda_11_11_p617 - Lambda_11_11_p598 * Lambda_11_11_p341 -
      Lambda_11_11_p604 * Lambda_11_11_p340 - Lambda_11_11_p610 * Lambda_11_11_p339 -
      Lambda_11_11_p614 * Lambda_11_11_p338;
  const Real Lambda_11_11_p619 = Lambda_11_11_p618 - Lambda_11_11_p616 * Lambda_11_11_p337;
  const Real Lambda_11_11_p620 = inverse_D1 * Lambda_11_11_p616;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p621 = inverse_D2 * Lambda_11_11_p614;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p622 = inverse_D3 * Lambda_11_11_p610;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p623 = inverse_D4 * Lambda_11_11_p604;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p624 = inverse_D5 * Lambda_11_11_p598;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p625 = inverse_D6 * Lambda_11_11_p593;

  // link 7 (left_shoulder1), force propagation
  const Real Lambda_11_11_p626 = minus_inverse_D7 * Lambda_11_11_p582;

  // link 8 (left_shoulder2), force propagation
  const Real Lambda_11_11_p627 = minus_inverse_D8 * Lambda_11_11_p579;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_11_11_p628 = minus_inverse_D9 * Lambda_11_11_p575;

  // link 10 (left_lowerarm), force propagation
  const Real Lambda_11_11_p629 = minus_inverse_D10 * Lambda_11_11_p569;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p630 = Lambda_11_11_p213 * Lambda_11_11_p629 + Lambda_11_11_p219 *
      Lambda_11_11_p628 + Lambda_11_11_p223 * Lambda_11_11_p627 + Lambda_11_11_p226 *
      Lambda_11_11_p626 - Lambda_11_11_p237 * Lambda_11_11_p625;
  const Real Lambda_11_11_p631 = Lambda_11_11_p630 - Lambda_11_11_p242 * Lambda_11_11_p624 -
      Lambda_11_11_p248 * Lambda_11_11_p623 - Lambda_11_11_p254 * Lambda_11_11_p622 -
      Lambda_11_11_p258 * Lambda_11_11_p621;
  const Real Lambda_11_11_p632 = Lambda_11_11_p569 * Lambda_11_11_p180 + Lambda_11_11_p575 *
      Lambda_11_11_p179 + Lambda_11_11_p579 * Lambda_11_11_p178 + Lambda_11_11_p582 *
      Lambda_11_11_p177 - Lambda_11_11_p593 * Lambda_11_11_p176;
  const Real Lambda_11_11_p633 = Lambda_11_11_p632 - Lambda_11_11_p598 * Lambda_11_11_p175 -
      Lambda_11_11_p604 * Lambda_11_11_p174 - Lambda_11_11_p610 * Lambda_11_11_p173 -
      Lambda_11_11_p614 * Lambda_11_11_p172;
  const Real Lambda_11_11_p634 = Lambda_11_11_p633 - Lambda_11_11_p616 * Lambda_11_11_p84;
  const Real Lambda_11_11_p635 = Lambda_11_11_p353 * (Lambda_11_11_p619 + Lambda_11_11_p355) -
      (Lambda_11_11_p631 - Lambda_11_11_p260 * Lambda_11_11_p620 - Lambda_11_11_p422 *
      Lambda_11_11_p445 + Lambda_11_11_p634 * Lambda_11_11_p205);
  const Real Lambda_11_11_p636 = Lambda_11_11_p635 * Lambda_11_11_p450;
  const Real Lambda_11_11_p637 = Lambda_11_11_p361 * Lambda_11_11_p629 + Lambda_11_11_p364 *
      Lambda_11_11_p628 + Lambda_11_11_p371 * Lambda_11_11_p627 + Lambda_11_11_p374 *
      Lambda_11_11_p626 - Lambda_11_11_p385 * Lambda_11_11_p625;
  const Real Lambda_11_11_p638 = Lambda_11_11_p637 - Lambda_11_11_p390 * Lambda_11_11_p624 -
      Lambda_11_11_p396 * Lambda_11_11_p623 - Lambda_11_11_p402 * Lambda_11_11_p622 -
      Lambda_11_11_p406 * Lambda_11_11_p621;
  const Real Lambda_11_11_p639 = Lambda_11_11_p569 * Lambda_11_11_p269 + Lambda_11_11_p575 *
      Lambda_11_11_p268 + Lambda_11_11_p579 * Lambda_11_11_p267 + Lambda_11_11_p582 *
      Lambda_11_11_p266 - Lambda_11_11_p593 * Lambda_11_11_p265;
  const Real Lambda_11_11_p640 = Lambda_11_11_p639 - Lambda_11_11_p598 * Lambda_11_11_p264 -
      Lambda_11_11_p604 * Lambda_11_11_p263 - Lambda_11_11_p610 * Lambda_11_11_p262 -
      Lambda_11_11_p614 * Lambda_11_11_p261;
  const Real Lambda_11_11_p641 = Lambda_11_11_p640 - Lambda_11_11_p616 * Lambda_11_11_p207;
  const Real Lambda_11_11_p642 = Lambda_11_11_p638 - Lambda_11_11_p408 * Lambda_11_11_p620 -
      Lambda_11_11_p353 * Lambda_11_11_p560 + Lambda_11_11_p641 * Lambda_11_11_p205 +
      Lambda_11_11_p438 * Lambda_11_11_p636;
  const Real Lambda_11_11_p643 = Lambda_11_11_p417 * Lambda_11_11_p422;
  const Real Lambda_11_11_p644 = Lambda_11_11_p643 - (Lambda_11_11_p411 - Lambda_11_11_p206);
  const Real Lambda_11_11_p645 = Lambda_11_11_p422 * (Lambda_11_11_p619 + Lambda_11_11_p644) +
      Lambda_11_11_p642;
  const Real Lambda_11_11_p646 = Lambda_11_11_p593 * Lambda_11_11_p535 - Lambda_11_11_p598 *
      Lambda_11_11_p534 - Lambda_11_11_p604 * Lambda_11_11_p533 - Lambda_11_11_p610 *
      Lambda_11_11_p532 - Lambda_11_11_p614 * Lambda_11_11_p531;
  const Real Lambda_11_11_p647 = Lambda_11_11_p646 - Lambda_11_11_p616 * Lambda_11_11_p530;
  const Real Lambda_11_11_p648 = Lambda_11_11_p647 - Lambda_11_11_p547 * Lambda_11_11_p353 -
      Lambda_11_11_p539 * Lambda_11_11_p422 + Lambda_11_11_p635 * Lambda_11_11_p543 -
      Lambda_11_11_p645 * Lambda_11_11_p563;
  const Real Lambda_11_11_p649 = Lambda_11_11_p645 * Lambda_11_11_p562;
  const Real Lambda_11_11_p650 = Lambda_11_11_p641 + Lambda_11_11_p559 * Lambda_11_11_p353 +
      Lambda_11_11_p186 * Lambda_11_11_p422;
  const Real Lambda_11_11_p651 = Lambda_11_11_p569 * Lambda_11_11_p629 + Lambda_11_11_p575 *
      Lambda_11_11_p628 + Lambda_11_11_p579 * Lambda_11_11_p627 + Lambda_11_11_p582 *
      Lambda_11_11_p626 - Lambda_11_11_p593 * Lambda_11_11_p625;
  const Real Lambda_11_11_p652 = Lambda_11_11_p651 - Lambda_11_11_p598 * Lambda_11_11_p624 -
      Lambda_11_11_p604 * Lambda_11_11_p623 - Lambda_11_11_p610 * Lambda_11_11_p622 -
      Lambda_11_11_p614 * Lambda_11_11_p621;
  const Real Lambda_11_11_p653 = Lambda_11_11_p634 + Lambda_11_11_p186 * Lambda_11_11_p353 +
      Lambda_11_11_p444 * Lambda_11_11_p422;
  const Real Lambda_11_11_p654 = Lambda_11_11_p652 - Lambda_11_11_p616 * Lambda_11_11_p620 -
      Lambda_11_11_p353 * (Lambda_11_11_p641 + Lambda_11_11_p650) - Lambda_11_11_p422 *
      (Lambda_11_11_p634 + Lambda_11_11_p653);
  const Real Lambda_11_11_p655 = 1.0 / (Lambda_11_11_p654 - Lambda_11_11_p635 * Lambda_11_11_p636 -
      Lambda_11_11_p645 * Lambda_11_11_p649);
  const Real Lambda_11_11_p656 = Lambda_11_11_p648 * Lambda_11_11_p655;
  const Real Lambda_11_11_p657 = Lambda_11_11_p355 * Lambda_11_11_p450;
  const Real Lambda_11_11_p658 = Lambda_11_11_p560 - Lambda_11_11_p438 * Lambda_11_11_p657;
  const Real Lambda_11_11_p659 = Lambda_11_11_p658 * Lambda_11_11_p562;
  const Real Lambda_11_11_p660 = Lambda_11_11_p650 + Lambda_11_11_p635 * Lambda_11_11_p657 -
      Lambda_11_11_p645 * Lambda_11_11_p659;
  const Real Lambda_11_11_p661 = Lambda_11_11_p547 - Lambda_11_11_p355 * Lambda_11_11_p543 -
      Lambda_11_11_p658 * Lambda_11_11_p563 - Lambda_11_11_p660 * Lambda_11_11_p656;
  const Real Lambda_11_11_p662 = Lambda_11_11_p660 * Lambda_11_11_p655;
  const Real Lambda_11_11_p663 = 1.0 / (Lambda_11_11_p559 + Lambda_11_11_p355 * Lambda_11_11_p657 +
      Lambda_11_11_p658 * Lambda_11_11_p659 + Lambda_11_11_p660 * Lambda_11_11_p662);
  const Real Lambda_11_11_p664 = Lambda_11_11_p661 * Lambda_11_11_p663;
  const Real Lambda_11_11_p665 = Lambda_11_11_p445 * Lambda_11_11_p450;
  const Real Lambda_11_11_p666 = Lambda_11_11_p644 + Lambda_11_11_p438 * Lambda_11_11_p665;
  const Real Lambda_11_11_p667 = Lambda_11_11_p666 * Lambda_11_11_p562;
  const Real Lambda_11_11_p668 = Lambda_11_11_p653 + Lambda_11_11_p635 * Lambda_11_11_p665 +
      Lambda_11_11_p645 * Lambda_11_11_p667;
  const Real Lambda_11_11_p669 = Lambda_11_11_p668 * Lambda_11_11_p655;
  const Real Lambda_11_11_p670 = Lambda_11_11_p186 + Lambda_11_11_p355 * Lambda_11_11_p665 -
      Lambda_11_11_p658 * Lambda_11_11_p667 + Lambda_11_11_p660 * Lambda_11_11_p669;
  const Real Lambda_11_11_p671 = Lambda_11_11_p539 - Lambda_11_11_p445 * Lambda_11_11_p543 +
      Lambda_11_11_p666 * Lambda_11_11_p563 - Lambda_11_11_p668 * Lambda_11_11_p656 -
      Lambda_11_11_p670 * Lambda_11_11_p664;
  const Real Lambda_11_11_p672 = Lambda_11_11_p670 * Lambda_11_11_p663;
  const Real Lambda_11_11_p673 = Lambda_11_11_p444 + Lambda_11_11_p445 * Lambda_11_11_p665 +
      Lambda_11_11_p666 * Lambda_11_11_p667 + Lambda_11_11_p668 * Lambda_11_11_p669 -
      Lambda_11_11_p670 * Lambda_11_11_p672;
  const Real Lambda_11_11_p674 = 1.0 / Lambda_11_11_p673;
  const Real Lambda_11_11_p675 = Lambda_11_11_p671 * Lambda_11_11_p674;
  const Real Lambda_11_11_p676 = Lambda_11_11_p421 * Lambda_11_11_p450;
  const Real Lambda_11_11_p677 = Lambda_11_11_p550 - Lambda_11_11_p438 * Lambda_11_11_p676;
  const Real Lambda_11_11_p678 = Lambda_11_11_p677 * Lambda_11_11_p562;
  const Real Lambda_11_11_p679 = Lambda_11_11_p643 + (Lambda_11_11_p619 + Lambda_11_11_p354) +
      Lambda_11_11_p635 * Lambda_11_11_p676 - Lambda_11_11_p645 * Lambda_11_11_p678;
  const Real Lambda_11_11_p680 = Lambda_11_11_p679 * Lambda_11_11_p655;
  const Real Lambda_11_11_p681 = Lambda_11_11_p352 + Lambda_11_11_p355 * Lambda_11_11_p676 +
      Lambda_11_11_p658 * Lambda_11_11_p678 + Lambda_11_11_p660 * Lambda_11_11_p680;
  const Real Lambda_11_11_p682 = Lambda_11_11_p681 * Lambda_11_11_p663;
  const Real Lambda_11_11_p683 = Lambda_11_11_p417 + Lambda_11_11_p445 * Lambda_11_11_p676 -
      Lambda_11_11_p666 * Lambda_11_11_p678 + Lambda_11_11_p668 * Lambda_11_11_p680 -
      Lambda_11_11_p670 * Lambda_11_11_p682;
  const Real Lambda_11_11_p684 = Lambda_11_11_p541 - Lambda_11_11_p421 * Lambda_11_11_p543 -
      Lambda_11_11_p677 * Lambda_11_11_p563 - Lambda_11_11_p679 * Lambda_11_11_p656 -
      Lambda_11_11_p681 * Lambda_11_11_p664;
  const Real Lambda_11_11_p685 = Lambda_11_11_p684 - Lambda_11_11_p683 * Lambda_11_11_p675;
  const Real Lambda_11_11_p686 = Lambda_11_11_p683 * Lambda_11_11_p674;
  const Real Lambda_11_11_p687 = Lambda_11_11_p420 + Lambda_11_11_p421 * Lambda_11_11_p676 +
      Lambda_11_11_p677 * Lambda_11_11_p678 + Lambda_11_11_p679 * Lambda_11_11_p680 -
      Lambda_11_11_p681 * Lambda_11_11_p682;
  const Real Lambda_11_11_p688 = 1.0 / (Lambda_11_11_p687 - Lambda_11_11_p683 * Lambda_11_11_p686);
  const Real Lambda_11_11_p689 = Lambda_11_11_p685 * Lambda_11_11_p688;

  // link 14 (right_shoulder1), pose
  const Real Lambda_11_11_p690 = c14 * Lambda_11_11_p90 - s14 * Lambda_11_11_p93;
  const Real Lambda_11_11_p691 = s14 * Lambda_11_11_p90 + c14 * Lambda_11_11_p93;

  // link 15 (right_shoulder2), pose
  const Real Lambda_11_11_p692 = c15 * Lambda_11_11_p96 - s15 * Lambda_11_11_p691;

  // link 16 (right_upperarm), pose
  const Real Lambda_11_11_p693 = s16 * Lambda_11_11_p690 + c16 * Lambda_11_11_p692;
  const Real Lambda_11_11_p694 = c16 * Lambda_11_11_p690 - s16 * Lambda_11_11_p692;

  // link 15 (right_shoulder2), pose
  const Real Lambda_11_11_p695 = s15 * Lambda_11_11_p96 + c15 * Lambda_11_11_p691;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p696 = s17 * Lambda_11_11_p695 - c17 * Lambda_11_11_p694;

  // link 18 (right_wrist1), pose
  const Real Lambda_11_11_p697 = c18 * Lambda_11_11_p693 - s18 * Lambda_11_11_p696;
  const Real Lambda_11_11_p698 = s18 * Lambda_11_11_p693 + c18 * Lambda_11_11_p696;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p699 = c17 * Lambda_11_11_p695 + s17 * Lambda_11_11_p694;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p700 = c19 * Lambda_11_11_p699 - s19 * Lambda_11_11_p698;

  // link 20 (right_hand), pose
  const Real Lambda_11_11_p701 = c20 * Lambda_11_11_p697 - s20 * Lambda_11_11_p700;
  const Real Lambda_11_11_p702 = s20 * Lambda_11_11_p697 + c20 * Lambda_11_11_p700;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p703 = c20 * Lambda_11_11_p701 + s20 * Lambda_11_11_p702;
  const Real Lambda_11_11_p704 = s20 * Lambda_11_11_p701 - c20 * Lambda_11_11_p702;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p705 = s19 * Lambda_11_11_p699 + c19 * Lambda_11_11_p698;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p706 = s19 * Lambda_11_11_p704 + c19 * Lambda_11_11_p705;
  const Real Lambda_11_11_p707 = 0.269 * Lambda_11_11_p706;
  const Real Lambda_11_11_p708 = 0.269 * Lambda_11_11_p703;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p709 = c18 * Lambda_11_11_p707 - s18 * Lambda_11_11_p708;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p710 = s18 * Lambda_11_11_p703 - c18 * Lambda_11_11_p706 +
      inverse_D5_p82 * Lambda_11_11_p709;
  const Real Lambda_11_11_p711 = c19 * Lambda_11_11_p704 - s19 * Lambda_11_11_p705 -
      inverse_D5_p91 * Lambda_11_11_p709;
  const Real Lambda_11_11_p712 = s17 * Lambda_11_11_p711 - c17 * Lambda_11_11_p710;
  const Real Lambda_11_11_p713 = s18 * Lambda_11_11_p707 + c18 * Lambda_11_11_p708 +
      inverse_D5_p49 * Lambda_11_11_p709;
  const Real Lambda_11_11_p714 = inverse_D5_p46 * Lambda_11_11_p709;
  const Real Lambda_11_11_p715 = c17 * Lambda_11_11_p714 + s17 * Lambda_11_11_p713;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p716 = 0.282 * Lambda_11_11_p712 - inverse_D15_p1 * Lambda_11_11_p715;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p717 = c18 * Lambda_11_11_p703 + s18 * Lambda_11_11_p706 -
      inverse_D5_p64 * Lambda_11_11_p709;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p718 = 0.282 * Lambda_11_11_p717 - s17 * Lambda_11_11_p714 + c17 *
      Lambda_11_11_p713 + inverse_D15_p4 * Lambda_11_11_p715;
  const Real Lambda_11_11_p719 = s16 * Lambda_11_11_p716 + c16 * Lambda_11_11_p718;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p720 = c16 * Lambda_11_11_p716 - s16 * Lambda_11_11_p718 +
      inverse_D14_p1 * Lambda_11_11_p719;
  const Real Lambda_11_11_p721 = Lambda_11_11_p496 * Lambda_11_11_p719;
  const Real Lambda_11_11_p722 = c15 * Lambda_11_11_p720 - s15 * Lambda_11_11_p721;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p723 = Lambda_11_11_p717 + inverse_D5_p71 * Lambda_11_11_p715;
  const Real Lambda_11_11_p724 = Lambda_11_11_p712 - inverse_D5_p99 * Lambda_11_11_p715;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p725 = c16 * Lambda_11_11_p723 + s16 * Lambda_11_11_p724 -
      inverse_D5_p140 * Lambda_11_11_p719;
  const Real Lambda_11_11_p726 = c17 * Lambda_11_11_p711 + s17 * Lambda_11_11_p710 +
      inverse_D5_p131 * Lambda_11_11_p715 + inverse_D5_p137 * Lambda_11_11_p719;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p727 = s15 * Lambda_11_11_p725 + c15 * Lambda_11_11_p726 +
      inverse_D5_p147 * Lambda_11_11_p722;
  const Real Lambda_11_11_p728 = s16 * Lambda_11_11_p723 - c16 * Lambda_11_11_p724 -
      inverse_D5_p121 * Lambda_11_11_p719 - inverse_D5_p127 * Lambda_11_11_p722;
  const Real Lambda_11_11_p729 = c14 * Lambda_11_11_p727 + s14 * Lambda_11_11_p728;
  const Real Lambda_11_11_p730 = c15 * Lambda_11_11_p725 - s15 * Lambda_11_11_p726 +
      inverse_D5_p177 * Lambda_11_11_p722;
  const Real Lambda_11_11_p731 = s15 * Lambda_11_11_p720 + c15 * Lambda_11_11_p721 -
      inverse_D5_p365 * Lambda_11_11_p722;
  const Real Lambda_11_11_p732 = Lambda_11_11_p504 * Lambda_11_11_p722;
  const Real Lambda_11_11_p733 = 0.18 * Lambda_11_11_p729 + 0.226 * Lambda_11_11_p730 + s14 *
      Lambda_11_11_p731 - c14 * Lambda_11_11_p732;
  const Real Lambda_11_11_p734 = s14 * Lambda_11_11_p727 - c14 * Lambda_11_11_p728;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p735 = Lambda_11_11_p734 - inverse_D5_p408 * Lambda_11_11_p733;
  const Real Lambda_11_11_p736 = 0.226 * Lambda_11_11_p734 + inverse_D5_p383 * Lambda_11_11_p733;
  const Real Lambda_11_11_p737 = 0.18 * Lambda_11_11_p734 - c14 * Lambda_11_11_p731 - s14 *
      Lambda_11_11_p732 - inverse_D5_p390 * Lambda_11_11_p733;
  const Real Lambda_11_11_p738 = 0.072 * Lambda_11_11_p735 + c6 * Lambda_11_11_p736 - s6 *
      Lambda_11_11_p737;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p739 = s6 * Lambda_11_11_p736 + c6 * Lambda_11_11_p737 - inverse_D1_p35 *
      Lambda_11_11_p738;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p740 = Lambda_11_11_p730 + inverse_D1_p2 * Lambda_11_11_p733;
  const Real Lambda_11_11_p741 = Lambda_11_11_p729 - inverse_D1_p11 * Lambda_11_11_p733;
  const Real Lambda_11_11_p742 = c6 * Lambda_11_11_p740 - s6 * Lambda_11_11_p741;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p743 = 0.072 * Lambda_11_11_p742 - inverse_D1_p25 * Lambda_11_11_p738;
  const Real Lambda_11_11_p744 = c5 * Lambda_11_11_p739 + s5 * Lambda_11_11_p743;
  const Real Lambda_11_11_p745 = s6 * Lambda_11_11_p740 + c6 * Lambda_11_11_p741 - inverse_D1_p58 *
      Lambda_11_11_p738;
  const Real Lambda_11_11_p746 = Lambda_11_11_p735 - inverse_D1_p54 * Lambda_11_11_p738;
  const Real Lambda_11_11_p747 = s5 * Lambda_11_11_p745 + c5 * Lambda_11_11_p746;
  const Real Lambda_11_11_p748 = Lambda_11_11_p742 - inverse_D1_p42 * Lambda_11_11_p738;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p749 = s4 * (0.21799999999999997 * Lambda_11_11_p748 - s5 *
      Lambda_11_11_p739 + c5 * Lambda_11_11_p743 + inverse_D3_p3 * Lambda_11_11_p744);
  const Real Lambda_11_11_p750 = c4 * (0.21799999999999997 * Lambda_11_11_p747 + inverse_D3_p1 *
      Lambda_11_11_p744) - Lambda_11_11_p749;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p751 = c5 * Lambda_11_11_p745 - s5 * Lambda_11_11_p746 - inverse_D1_p83 *
      Lambda_11_11_p744 - inverse_D1_p87 * Lambda_11_11_p750;
  const Real Lambda_11_11_p752 = s4 * (Lambda_11_11_p748 + inverse_D1_p48 * Lambda_11_11_p744) -
      c4 * (Lambda_11_11_p747 + inverse_D1_p67 * Lambda_11_11_p744) + inverse_D1_p89 *
      Lambda_11_11_p750;
  const Real Lambda_11_11_p753 = s3 * Lambda_11_11_p751 - c3 * Lambda_11_11_p752;
  const Real Lambda_11_11_p754 = 0.422 * Lambda_11_11_p753;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p755 = s2 * (c3 * Lambda_11_11_p751 + s3 * Lambda_11_11_p752 +
      inverse_D1_p102 * Lambda_11_11_p754) + c2 * (Lambda_11_11_p753 - inverse_D1_p98 *
      Lambda_11_11_p754);
  const Real Lambda_11_11_p756 = 0.434 * Lambda_11_11_p755;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p757 = inverse_D1 * Lambda_11_11_p756;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p758 = inverse_D2 * Lambda_11_11_p754;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p759 = inverse_D3 * Lambda_11_11_p750;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p760 = inverse_D4 * Lambda_11_11_p744;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p761 = inverse_D5 * Lambda_11_11_p738;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p762 = inverse_D6 * Lambda_11_11_p733;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p763 = Lambda_11_11_p237 * Lambda_11_11_p762 - Lambda_11_11_p242 *
      Lambda_11_11_p761 - Lambda_11_11_p248 * Lambda_11_11_p760 - Lambda_11_11_p254 *
      Lambda_11_11_p759 - Lambda_11_11_p258 * Lambda_11_11_p758;

  // link 14 (right_shoulder1), pose
  const Real Lambda_11_11_p764 = s14 * Lambda_11_11_p4 - c14 * Lambda_11_11_p3;

  // link 15 (right_shoulder2), pose
  const Real Lambda_11_11_p765 = s15 * Lambda_11_11_p2 - c15 * Lambda_11_11_p764;
  const Real Lambda_11_11_p766 = c15 * Lambda_11_11_p2 + s15 * Lambda_11_11_p764;

  // link 14 (right_shoulder1), pose
  const Real Lambda_11_11_p767 = c14 * Lambda_11_11_p4 + s14 * Lambda_11_11_p3;

  // link 16 (right_upperarm), pose
  const Real Lambda_11_11_p768 = c16 * Lambda_11_11_p767 + s16 * Lambda_11_11_p766;

  // link 17 (right_lowerarm), pose
  const Real Lambda_11_11_p769 = c17 * Lambda_11_11_p765 - s17 * Lambda_11_11_p768;
  const Real Lambda_11_11_p770 = s17 * Lambda_11_11_p765 + c17 * Lambda_11_11_p768;

  // link 16 (right_upperarm), pose
  const Real Lambda_11_11_p771 = s16 * Lambda_11_11_p767 - c16 * Lambda_11_11_p766;

  // link 18 (right_wrist1), pose
  const Real Lambda_11_11_p772 = s18 * Lambda_11_11_p771 - c18 * Lambda_11_11_p770;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p773 = c19 * Lambda_11_11_p769 + s19 * Lambda_11_11_p772;

  // link 18 (right_wrist1), pose
  const Real Lambda_11_11_p774 = c18 * Lambda_11_11_p771 + s18 * Lambda_11_11_p770;

  // link 20 (right_hand), pose
  const Real Lambda_11_11_p775 = c20 * Lambda_11_11_p774 + s20 * Lambda_11_11_p773;

  // link 19 (right_wrist2), pose
  const Real Lambda_11_11_p776 = s19 * Lambda_11_11_p769 - c19 * Lambda_11_11_p772;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p777 = Lambda_11_11_p775 - 0.04672761636452121 * Lambda_11_11_p776;

  // link 20 (right_hand), pose
  const Real Lambda_11_11_p778 = s20 * Lambda_11_11_p774 - c20 * Lambda_11_11_p773;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p779 = Lambda_11_11_p778 - 0.11533812622014242 * Lambda_11_11_p776;
  const Real Lambda_11_11_p780 = c20 * Lambda_11_11_p777 + s20 * Lambda_11_11_p779;
  const Real Lambda_11_11_p781 = 17.32841575379867 * Lambda_11_11_p776;
  const Real Lambda_11_11_p782 = 3.0523172236718206 * Lambda_11_11_p776;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p783 = s20 * Lambda_11_11_p781 + c20 * Lambda_11_11_p782 - inverse_D5_p8 *
      Lambda_11_11_p780;
  const Real Lambda_11_11_p784 = inverse_D5_p2 * Lambda_11_11_p780;
  const Real Lambda_11_11_p785 = s19 * Lambda_11_11_p783 - c19 * Lambda_11_11_p784;
  const Real Lambda_11_11_p786 = s20 * Lambda_11_11_p777 - c20 * Lambda_11_11_p779 -
      inverse_D18_p1 * Lambda_11_11_p780;
  const Real Lambda_11_11_p787 = c19 * Lambda_11_11_p786;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p788 = 0.269 * Lambda_11_11_p785 - inverse_D5_p23 * Lambda_11_11_p787;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p789 = c20 * Lambda_11_11_p781 - s20 * Lambda_11_11_p782 +
      inverse_D5_p14 * Lambda_11_11_p780;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p790 = 0.269 * Lambda_11_11_p789 + s19 * Lambda_11_11_p786 -
      inverse_D5_p29 * Lambda_11_11_p787;
  const Real Lambda_11_11_p791 = c18 * Lambda_11_11_p788 - s18 * Lambda_11_11_p790;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p792 = c19 * Lambda_11_11_p783 + s19 * Lambda_11_11_p784 +
      inverse_D5_p86 * Lambda_11_11_p787 - inverse_D5_p91 * Lambda_11_11_p791;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p793 = Lambda_11_11_p785 - inverse_D5_p54 * Lambda_11_11_p787;
  const Real Lambda_11_11_p794 = Lambda_11_11_p789 - inverse_D5_p57 * Lambda_11_11_p787;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p795 = s18 * Lambda_11_11_p794 - c18 * Lambda_11_11_p793 +
      inverse_D5_p82 * Lambda_11_11_p791;
  const Real Lambda_11_11_p796 = s17 * Lambda_11_11_p792 - c17 * Lambda_11_11_p795;
  const Real Lambda_11_11_p797 = s18 * Lambda_11_11_p788 + c18 * Lambda_11_11_p790 +
      inverse_D5_p49 * Lambda_11_11_p791;
  const Real Lambda_11_11_p798 = inverse_D5_p46 * Lambda_11_11_p791;
  const Real Lambda_11_11_p799 = c17 * Lambda_11_11_p798 + s17 * Lambda_11_11_p797;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p800 = 0.282 * Lambda_11_11_p796 - inverse_D15_p1 * Lambda_11_11_p799;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p801 = c18 * Lambda_11_11_p794 + s18 * Lambda_11_11_p793 -
      inverse_D5_p64 * Lambda_11_11_p791;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p802 = 0.282 * Lambda_11_11_p801 - s17 * Lambda_11_11_p798 + c17 *
      Lambda_11_11_p797 + inverse_D15_p4 * Lambda_11_11_p799;
  const Real Lambda_11_11_p803 = s16 * Lambda_11_11_p800 + c16 * Lambda_11_11_p802;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p804 = c16 * Lambda_11_11_p800 - s16 * Lambda_11_11_p802 +
      inverse_D14_p1 * Lambda_11_11_p803;
  const Real Lambda_11_11_p805 = Lambda_11_11_p496 * Lambda_11_11_p803;
  const Real Lambda_11_11_p806 = c15 * Lambda_11_11_p804 - s15 * Lambda_11_11_p805;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p807 = Lambda_11_11_p796 - inverse_D5_p99 * Lambda_11_11_p799;
  const Real Lambda_11_11_p808 = Lambda_11_11_p801 + inverse_D5_p71 * Lambda_11_11_p799;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p809 = c16 * Lambda_11_11_p808 + s16 * Lambda_11_11_p807 -
      inverse_D5_p140 * Lambda_11_11_p803;
  const Real Lambda_11_11_p810 = c17 * Lambda_11_11_p792 + s17 * Lambda_11_11_p795 +
      inverse_D5_p131 * Lambda_11_11_p799 + inverse_D5_p137 * Lambda_11_11_p803;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p811 = s15 * Lambda_11_11_p809 + c15 * Lambda_11_11_p810 +
      inverse_D5_p147 * Lambda_11_11_p806;
  const Real Lambda_11_11_p812 = s16 * Lambda_11_11_p808 - c16 * Lambda_11_11_p807 -
      inverse_D5_p121 * Lambda_11_11_p803 - inverse_D5_p127 * Lambda_11_11_p806;
  const Real Lambda_11_11_p813 = c14 * Lambda_11_11_p811 + s14 * Lambda_11_11_p812;
  const Real Lambda_11_11_p814 = c15 * Lambda_11_11_p809 - s15 * Lambda_11_11_p810 +
      inverse_D5_p177 * Lambda_11_11_p806;
  const Real Lambda_11_11_p815 = s15 * Lambda_11_11_p804 + c15 * Lambda_11_11_p805 -
      inverse_D5_p365 * Lambda_11_11_p806;
  const Real Lambda_11_11_p816 = Lambda_11_11_p504 * Lambda_11_11_p806;
  const Real Lambda_11_11_p817 = 0.18 * Lambda_11_11_p813 + 0.226 * Lambda_11_11_p814 + s14 *
      Lambda_11_11_p815 - c14 * Lambda_11_11_p816;
  const Real Lambda_11_11_p818 = s14 * Lambda_11_11_p811 - c14 * Lambda_11_11_p812;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p819 = Lambda_11_11_p818 - inverse_D5_p408 * Lambda_11_11_p817;
  const Real Lambda_11_11_p820 = 0.226 * Lambda_11_11_p818 + inverse_D5_p383 * Lambda_11_11_p817;
  const Real Lambda_11_11_p821 = 0.18 * Lambda_11_11_p818 - c14 * Lambda_11_11_p815 - s14 *
      Lambda_11_11_p816 - inverse_D5_p390 * Lambda_11_11_p817;
  const Real Lambda_11_11_p822 = 0.072 * Lambda_11_11_p819 + c6 * Lambda_11_11_p820 - s6 *
      Lambda_11_11_p821;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p823 = s6 * Lambda_11_11_p820 + c6 * Lambda_11_11_p821 - inverse_D1_p35 *
      Lambda_11_11_p822;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p824 = Lambda_11_11_p814 + inverse_D1_p2 * Lambda_11_11_p817;
  const Real Lambda_11_11_p825 = Lambda_11_11_p813 - inverse_D1_p11 * Lambda_11_11_p817;
  const Real Lambda_11_11_p826 = c6 * Lambda_11_11_p824 - s6 * Lambda_11_11_p825;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p827 = 0.072 * Lambda_11_11_p826 - inverse_D1_p25 * Lambda_11_11_p822;
  const Real Lambda_11_11_p828 = c5 * Lambda_11_11_p823 + s5 * Lambda_11_11_p827;
  const Real Lambda_11_11_p829 = s6 * Lambda_11_11_p824 + c6 * Lambda_11_11_p825 - inverse_D1_p58 *
      Lambda_11_11_p822;
  const Real Lambda_11_11_p830 = Lambda_11_11_p819 - inverse_D1_p54 * Lambda_11_11_p822;
  const Real Lambda_11_11_p831 = s5 * Lambda_11_11_p829 + c5 * Lambda_11_11_p830;
  const Real Lambda_11_11_p832 = Lambda_11_11_p826 - inverse_D1_p42 * Lambda_11_11_p822;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p833 = s4 * (0.21799999999999997 * Lambda_11_11_p832 - s5 *
      Lambda_11_11_p823 + c5 * Lambda_11_11_p827 + inverse_D3_p3 * Lambda_11_11_p828);
  const Real Lambda_11_11_p834 = c4 * (0.21799999999999997 * Lambda_11_11_p831 + inverse_D3_p1 *
      Lambda_11_11_p828) - Lambda_11_11_p833;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p835 = c5 * Lambda_11_11_p829 - s5 * Lambda_11_11_p830 - inverse_D1_p83 *
      Lambda_11_11_p828 - inverse_D1_p87 * Lambda_11_11_p834;
  const Real Lambda_11_11_p836 = s4 * (Lambda_11_11_p832 + inverse_D1_p48 * Lambda_11_11_p828) -
      c4 * (Lambda_11_11_p831 + inverse_D1_p67 * Lambda_11_11_p828) + inverse_D1_p89 *
      Lambda_11_11_p834;
  const Real Lambda_11_11_p837 = s3 * Lambda_11_11_p835 - c3 * Lambda_11_11_p836;
  const Real Lambda_11_11_p838 = 0.422 * Lambda_11_11_p837;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p839 = s2 * (c3 * Lambda_11_11_p835 + s3 * Lambda_11_11_p836 +
      inverse_D1_p102 * Lambda_11_11_p838) + c2 * (Lambda_11_11_p837 - inverse_D1_p98 *
      Lambda_11_11_p838);
  const Real Lambda_11_11_p840 = 0.434 * Lambda_11_11_p839;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p841 = inverse_D1 * Lambda_11_11_p840;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p842 = inverse_D2 * Lambda_11_11_p838;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p843 = inverse_D3 * Lambda_11_11_p834;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p844 = inverse_D4 * Lambda_11_11_p828;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p845 = inverse_D5 * Lambda_11_11_p822;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p846 = inverse_D6 * Lambda_11_11_p817;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p847 = Lambda_11_11_p237 * Lambda_11_11_p846 - Lambda_11_11_p242 *
      Lambda_11_11_p845 - Lambda_11_11_p248 * Lambda_11_11_p844 - Lambda_11_11_p254 *
      Lambda_11_11_p843 - Lambda_11_11_p258 * Lambda_11_11_p842;
  const Real Lambda_11_11_p848 = Lambda_11_11_p847 - Lambda_11_11_p260 * Lambda_11_11_p841;
  const Real Lambda_11_11_p849 = 0.086 * Lambda_11_11_p465;
  const Real Lambda_11_11_p850 = 0.086 * Lambda_11_11_p778;
  const Real Lambda_11_11_p851 = Lambda_11_11_p60 * Lambda_11_11_p762 - Lambda_11_11_p65 *
      Lambda_11_11_p761 - Lambda_11_11_p71 * Lambda_11_11_p760 - Lambda_11_11_p77 *
      Lambda_11_11_p759 - Lambda_11_11_p81 * Lambda_11_11_p758;
  const Real Lambda_11_11_p852 = Lambda_11_11_p60 * Lambda_11_11_p846 - Lambda_11_11_p65 *
      Lambda_11_11_p845 - Lambda_11_11_p71 * Lambda_11_11_p844 - Lambda_11_11_p77 *
      Lambda_11_11_p843 - Lambda_11_11_p81 * Lambda_11_11_p842;
  const Real Lambda_11_11_p853 = Lambda_11_11_p852 - Lambda_11_11_p83 * Lambda_11_11_p841;
  const Real Lambda_11_11_p854 = Lambda_11_11_p851 - Lambda_11_11_p83 * Lambda_11_11_p757 +
      Lambda_11_11_p853 * Lambda_11_11_p849 - Lambda_11_11_p539 * Lambda_11_11_p850;
  const Real Lambda_11_11_p855 = Lambda_11_11_p763 - Lambda_11_11_p260 * Lambda_11_11_p757 +
      Lambda_11_11_p848 * Lambda_11_11_p849 - Lambda_11_11_p537 * Lambda_11_11_p850 +
      Lambda_11_11_p205 * Lambda_11_11_p854;
  const Real Lambda_11_11_p856 = Lambda_11_11_p313 * Lambda_11_11_p762 - Lambda_11_11_p318 *
      Lambda_11_11_p761 - Lambda_11_11_p324 * Lambda_11_11_p760 - Lambda_11_11_p330 *
      Lambda_11_11_p759 - Lambda_11_11_p334 * Lambda_11_11_p758;
  const Real Lambda_11_11_p857 = Lambda_11_11_p313 * Lambda_11_11_p846 - Lambda_11_11_p318 *
      Lambda_11_11_p845 - Lambda_11_11_p324 * Lambda_11_11_p844 - Lambda_11_11_p330 *
      Lambda_11_11_p843 - Lambda_11_11_p334 * Lambda_11_11_p842;
  const Real Lambda_11_11_p858 = Lambda_11_11_p857 - Lambda_11_11_p336 * Lambda_11_11_p841;
  const Real Lambda_11_11_p859 = Lambda_11_11_p856 - Lambda_11_11_p336 * Lambda_11_11_p757 +
      Lambda_11_11_p858 * Lambda_11_11_p849 - Lambda_11_11_p541 * Lambda_11_11_p850;
  const Real Lambda_11_11_p860 = Lambda_11_11_p855 - Lambda_11_11_p353 * Lambda_11_11_p859;
  const Real Lambda_11_11_p861 = Lambda_11_11_p860 * Lambda_11_11_p450;
  const Real Lambda_11_11_p862 = Lambda_11_11_p385 * Lambda_11_11_p762 - Lambda_11_11_p390 *
      Lambda_11_11_p761 - Lambda_11_11_p396 * Lambda_11_11_p760 - Lambda_11_11_p402 *
      Lambda_11_11_p759 - Lambda_11_11_p406 * Lambda_11_11_p758;
  const Real Lambda_11_11_p863 = Lambda_11_11_p385 * Lambda_11_11_p846 - Lambda_11_11_p390 *
      Lambda_11_11_p845 - Lambda_11_11_p396 * Lambda_11_11_p844 - Lambda_11_11_p402 *
      Lambda_11_11_p843 - Lambda_11_11_p406 * Lambda_11_11_p842;
  const Real Lambda_11_11_p864 = Lambda_11_11_p863 - Lambda_11_11_p408 * Lambda_11_11_p841;
  const Real Lambda_11_11_p865 = Lambda_11_11_p862 - Lambda_11_11_p408 * Lambda_11_11_p757 +
      Lambda_11_11_p864 * Lambda_11_11_p849 - Lambda_11_11_p545 * Lambda_11_11_p850 +
      Lambda_11_11_p422 * Lambda_11_11_p859;
  const Real Lambda_11_11_p866 = Lambda_11_11_p148 * Lambda_11_11_p762 - Lambda_11_11_p153 *
      Lambda_11_11_p761 - Lambda_11_11_p159 * Lambda_11_11_p760 - Lambda_11_11_p165 *
      Lambda_11_11_p759 - Lambda_11_11_p169 * Lambda_11_11_p758;
  const Real Lambda_11_11_p867 = Lambda_11_11_p148 * Lambda_11_11_p846 - Lambda_11_11_p153 *
      Lambda_11_11_p845 - Lambda_11_11_p159 * Lambda_11_11_p844 - Lambda_11_11_p165 *
      Lambda_11_11_p843 - Lambda_11_11_p169 * Lambda_11_11_p842;
  const Real Lambda_11_11_p868 = Lambda_11_11_p867 - Lambda_11_11_p171 * Lambda_11_11_p841;
  const Real Lambda_11_11_p869 = Lambda_11_11_p866 - Lambda_11_11_p171 * Lambda_11_11_p757 +
      Lambda_11_11_p868 * Lambda_11_11_p849 - Lambda_11_11_p547 * Lambda_11_11_p850;
  const Real Lambda_11_11_p870 = Lambda_11_11_p865 + Lambda_11_11_p205 * Lambda_11_11_p869 -
      Lambda_11_11_p438 * Lambda_11_11_p861;
  const Real Lambda_11_11_p871 = Lambda_11_11_p870 * Lambda_11_11_p562;
  const Real Lambda_11_11_p872 = Lambda_11_11_p593 * Lambda_11_11_p762 - Lambda_11_11_p598 *
      Lambda_11_11_p761 - Lambda_11_11_p604 * Lambda_11_11_p760 - Lambda_11_11_p610 *
      Lambda_11_11_p759 - Lambda_11_11_p614 * Lambda_11_11_p758;
  const Real Lambda_11_11_p873 = Lambda_11_11_p593 * Lambda_11_11_p846 - Lambda_11_11_p598 *
      Lambda_11_11_p845 - Lambda_11_11_p604 * Lambda_11_11_p844 - Lambda_11_11_p610 *
      Lambda_11_11_p843 - Lambda_11_11_p614 * Lambda_11_11_p842;
  const Real Lambda_11_11_p874 = Lambda_11_11_p873 - Lambda_11_11_p616 * Lambda_11_11_p841;
  const Real Lambda_11_11_p875 = Lambda_11_11_p872 - Lambda_11_11_p616 * Lambda_11_11_p757 +
      Lambda_11_11_p874 * Lambda_11_11_p849 - Lambda_11_11_p647 * Lambda_11_11_p850 -
      Lambda_11_11_p353 * Lambda_11_11_p869;
  const Real Lambda_11_11_p876 = Lambda_11_11_p875 - Lambda_11_11_p422 * Lambda_11_11_p854 +
      Lambda_11_11_p635 * Lambda_11_11_p861 - Lambda_11_11_p645 * Lambda_11_11_p871;
  const Real Lambda_11_11_p877 = Lambda_11_11_p876 * Lambda_11_11_p655;
  const Real Lambda_11_11_p878 = Lambda_11_11_p869 - Lambda_11_11_p355 * Lambda_11_11_p861 -
      Lambda_11_11_p658 * Lambda_11_11_p871 - Lambda_11_11_p660 * Lambda_11_11_p877;
  const Real Lambda_11_11_p879 = Lambda_11_11_p878 * Lambda_11_11_p663;
  const Real Lambda_11_11_p880 = Lambda_11_11_p854 - Lambda_11_11_p445 * Lambda_11_11_p861 +
      Lambda_11_11_p666 * Lambda_11_11_p871 - Lambda_11_11_p668 * Lambda_11_11_p877 -
      Lambda_11_11_p670 * Lambda_11_11_p879;
  const Real Lambda_11_11_p881 = Lambda_11_11_p880 * Lambda_11_11_p674;
  const Real Lambda_11_11_p882 = Lambda_11_11_p859 - Lambda_11_11_p421 * Lambda_11_11_p861 -
      Lambda_11_11_p677 * Lambda_11_11_p871 - Lambda_11_11_p679 * Lambda_11_11_p877 -
      Lambda_11_11_p681 * Lambda_11_11_p879;
  const Real Lambda_11_11_p883 = Lambda_11_11_p882 - Lambda_11_11_p683 * Lambda_11_11_p881;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p884 = inverse_D14 * Lambda_11_11_p498;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p885 = inverse_D15 * Lambda_11_11_p490;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p886 = minus_inverse_D16 * Lambda_11_11_p486;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p887 = inverse_D17 * Lambda_11_11_p478;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p888 = Lambda_11_11_p709 * Lambda_11_11_p887 - Lambda_11_11_p715 *
      Lambda_11_11_p886 + Lambda_11_11_p719 * Lambda_11_11_p885 + Lambda_11_11_p722 *
      Lambda_11_11_p884 + Lambda_11_11_p733 * Lambda_11_11_p535;
  const Real Lambda_11_11_p889 = Lambda_11_11_p888 + Lambda_11_11_p738 * Lambda_11_11_p534 +
      Lambda_11_11_p744 * Lambda_11_11_p533 + Lambda_11_11_p750 * Lambda_11_11_p532 +
      Lambda_11_11_p754 * Lambda_11_11_p531;
  const Real Lambda_11_11_p890 = Lambda_11_11_p889 + Lambda_11_11_p756 * Lambda_11_11_p530;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p891 = inverse_D18 * Lambda_11_11_p474;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p892 = minus_inverse_D19 * Lambda_11_11_p467;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p893 = 1065.380700001509 * Lambda_11_11_p463;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p894 = Lambda_11_11_p776 * Lambda_11_11_p893 - Lambda_11_11_p780 *
      Lambda_11_11_p892 + Lambda_11_11_p787 * Lambda_11_11_p891 + Lambda_11_11_p791 *
      Lambda_11_11_p887 - Lambda_11_11_p799 * Lambda_11_11_p886;
  const Real Lambda_11_11_p895 = Lambda_11_11_p894 + Lambda_11_11_p803 * Lambda_11_11_p885 +
      Lambda_11_11_p806 * Lambda_11_11_p884 + Lambda_11_11_p817 * Lambda_11_11_p535 +
      Lambda_11_11_p822 * Lambda_11_11_p534;
  const Real Lambda_11_11_p896 = Lambda_11_11_p895 + Lambda_11_11_p828 * Lambda_11_11_p533 +
      Lambda_11_11_p834 * Lambda_11_11_p532 + Lambda_11_11_p838 * Lambda_11_11_p531 +
      Lambda_11_11_p840 * Lambda_11_11_p530;
  const Real Lambda_11_11_p897 = Lambda_11_11_p463 * Lambda_11_11_p893 - Lambda_11_11_p467 *
      Lambda_11_11_p892 + Lambda_11_11_p474 * Lambda_11_11_p891 + Lambda_11_11_p478 *
      Lambda_11_11_p887 - Lambda_11_11_p486 * Lambda_11_11_p886;
  const Real Lambda_11_11_p898 = Lambda_11_11_p897 + Lambda_11_11_p490 * Lambda_11_11_p885 +
      Lambda_11_11_p498 * Lambda_11_11_p884 + Lambda_11_11_p506 * Lambda_11_11_p535 +
      Lambda_11_11_p511 * Lambda_11_11_p534;
  const Real Lambda_11_11_p899 = Lambda_11_11_p898 + Lambda_11_11_p517 * Lambda_11_11_p533 +
      Lambda_11_11_p523 * Lambda_11_11_p532 + Lambda_11_11_p527 * Lambda_11_11_p531 +
      Lambda_11_11_p529 * Lambda_11_11_p530;
  const Real Lambda_11_11_p900 = Lambda_11_11_p890 + Lambda_11_11_p896 * Lambda_11_11_p849 -
      Lambda_11_11_p899 * Lambda_11_11_p850;
  const Real Lambda_11_11_p901 = Lambda_11_11_p900 + Lambda_11_11_p860 * Lambda_11_11_p543 +
      Lambda_11_11_p870 * Lambda_11_11_p563 + Lambda_11_11_p876 * Lambda_11_11_p656 -
      Lambda_11_11_p878 * Lambda_11_11_p664;
  const Real Lambda_11_11_p902 = Lambda_11_11_p901 - Lambda_11_11_p880 * Lambda_11_11_p675 -
      Lambda_11_11_p883 * Lambda_11_11_p689;
  const Real Lambda_11_11_p903 = Lambda_11_11_p883 * Lambda_11_11_p688;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p904 = inverse_D14 * Lambda_11_11_p806;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p905 = inverse_D15 * Lambda_11_11_p803;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p906 = minus_inverse_D16 * Lambda_11_11_p799;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p907 = inverse_D17 * Lambda_11_11_p791;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p908 = Lambda_11_11_p709 * Lambda_11_11_p907 - Lambda_11_11_p715 *
      Lambda_11_11_p906 + Lambda_11_11_p719 * Lambda_11_11_p905 + Lambda_11_11_p722 *
      Lambda_11_11_p904 + Lambda_11_11_p733 * Lambda_11_11_p846;
  const Real Lambda_11_11_p909 = Lambda_11_11_p908 + Lambda_11_11_p738 * Lambda_11_11_p845 +
      Lambda_11_11_p744 * Lambda_11_11_p844 + Lambda_11_11_p750 * Lambda_11_11_p843 +
      Lambda_11_11_p754 * Lambda_11_11_p842;
  const Real Lambda_11_11_p910 = Lambda_11_11_p909 + Lambda_11_11_p756 * Lambda_11_11_p841;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p911 = inverse_D18 * Lambda_11_11_p787;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p912 = minus_inverse_D19 * Lambda_11_11_p780;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p913 = 1065.380700001509 * Lambda_11_11_p776;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p914 = Lambda_11_11_p776 * Lambda_11_11_p913 - Lambda_11_11_p780 *
      Lambda_11_11_p912 + Lambda_11_11_p787 * Lambda_11_11_p911 + Lambda_11_11_p791 *
      Lambda_11_11_p907 - Lambda_11_11_p799 * Lambda_11_11_p906;
  const Real Lambda_11_11_p915 = Lambda_11_11_p914 + Lambda_11_11_p803 * Lambda_11_11_p905 +
      Lambda_11_11_p806 * Lambda_11_11_p904 + Lambda_11_11_p817 * Lambda_11_11_p846 +
      Lambda_11_11_p822 * Lambda_11_11_p845;
  const Real Lambda_11_11_p916 = Lambda_11_11_p915 + Lambda_11_11_p828 * Lambda_11_11_p844 +
      Lambda_11_11_p834 * Lambda_11_11_p843 + Lambda_11_11_p838 * Lambda_11_11_p842 +
      Lambda_11_11_p840 * Lambda_11_11_p841;
  const Real Lambda_11_11_p917 = Lambda_11_11_p910 + Lambda_11_11_p916 * Lambda_11_11_p849 -
      Lambda_11_11_p896 * Lambda_11_11_p850;
  const Real Lambda_11_11_p918 = Lambda_11_11_p709 * (inverse_D17 * Lambda_11_11_p709) -
      Lambda_11_11_p715 * (minus_inverse_D16 * Lambda_11_11_p715) + Lambda_11_11_p719 *
      (inverse_D15 * Lambda_11_11_p719);
  const Real Lambda_11_11_p919 = Lambda_11_11_p918 + Lambda_11_11_p722 *
      (inverse_D14 * Lambda_11_11_p722) + Lambda_11_11_p733 * Lambda_11_11_p762 +
      Lambda_11_11_p738 * Lambda_11_11_p761 + Lambda_11_11_p744 * Lambda_11_11_p760;
  const Real Lambda_11_11_p920 = Lambda_11_11_p919 + Lambda_11_11_p750 * Lambda_11_11_p759 +
      Lambda_11_11_p754 * Lambda_11_11_p758 + Lambda_11_11_p756 * Lambda_11_11_p757 +
      Lambda_11_11_p849 * (Lambda_11_11_p910 + Lambda_11_11_p917);
  const Real Lambda_11_11_p921 = Lambda_11_11_p920 - Lambda_11_11_p850 *
      (Lambda_11_11_p890 + Lambda_11_11_p900) + Lambda_11_11_p860 * Lambda_11_11_p861 +
      Lambda_11_11_p870 * Lambda_11_11_p871 + Lambda_11_11_p876 * Lambda_11_11_p877;
  const Real Lambda_11_11_p922 = 1.0 / (Lambda_11_11_p921 - Lambda_11_11_p878 * Lambda_11_11_p879 -
      Lambda_11_11_p880 * Lambda_11_11_p881 - Lambda_11_11_p883 * Lambda_11_11_p903);
  const Real Lambda_11_11_p923 = Lambda_11_11_p902 * Lambda_11_11_p922;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p924 = s20 * Lambda_11_11_p775 - c20 * Lambda_11_11_p778;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p925 = s19 * Lambda_11_11_p924 - c19 * Lambda_11_11_p776;
  const Real Lambda_11_11_p926 = 0.269 * Lambda_11_11_p925;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p927 = c20 * Lambda_11_11_p775 + s20 * Lambda_11_11_p778;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p928 = 0.269 * Lambda_11_11_p927;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p929 = c18 * Lambda_11_11_p926 - s18 * Lambda_11_11_p928;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p930 = inverse_D5_p46 * Lambda_11_11_p929;
  const Real Lambda_11_11_p931 = s18 * Lambda_11_11_p926 + c18 * Lambda_11_11_p928 +
      inverse_D5_p49 * Lambda_11_11_p929;
  const Real Lambda_11_11_p932 = c17 * Lambda_11_11_p930 + s17 * Lambda_11_11_p931;
  const Real Lambda_11_11_p933 = c19 * Lambda_11_11_p924 + s19 * Lambda_11_11_p776 -
      inverse_D5_p91 * Lambda_11_11_p929;
  const Real Lambda_11_11_p934 = s18 * Lambda_11_11_p927 - c18 * Lambda_11_11_p925 +
      inverse_D5_p82 * Lambda_11_11_p929;
  const Real Lambda_11_11_p935 = s17 * Lambda_11_11_p933 - c17 * Lambda_11_11_p934;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p936 = 0.282 * Lambda_11_11_p935 - inverse_D15_p1 * Lambda_11_11_p932;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p937 = c18 * Lambda_11_11_p927 + s18 * Lambda_11_11_p925 -
      inverse_D5_p64 * Lambda_11_11_p929;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p938 = 0.282 * Lambda_11_11_p937 - s17 * Lambda_11_11_p930 + c17 *
      Lambda_11_11_p931 + inverse_D15_p4 * Lambda_11_11_p932;
  const Real Lambda_11_11_p939 = s16 * Lambda_11_11_p936 + c16 * Lambda_11_11_p938;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p940 = c16 * Lambda_11_11_p936 - s16 * Lambda_11_11_p938 +
      inverse_D14_p1 * Lambda_11_11_p939;
  const Real Lambda_11_11_p941 = Lambda_11_11_p496 * Lambda_11_11_p939;
  const Real Lambda_11_11_p942 = c15 * Lambda_11_11_p940 - s15 * Lambda_11_11_p941;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p943 = Lambda_11_11_p937 + inverse_D5_p71 * Lambda_11_11_p932;
  const Real Lambda_11_11_p944 = Lambda_11_11_p935 - inverse_D5_p99 * Lambda_11_11_p932;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p945 = c16 * Lambda_11_11_p943 + s16 * Lambda_11_11_p944 -
      inverse_D5_p140 * Lambda_11_11_p939;
  const Real Lambda_11_11_p946 = c17 * Lambda_11_11_p933 + s17 * Lambda_11_11_p934 +
      inverse_D5_p131 * Lambda_11_11_p932 + inverse_D5_p137 * Lambda_11_11_p939;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p947 = s15 * Lambda_11_11_p945 + c15 * Lambda_11_11_p946 +
      inverse_D5_p147 * Lambda_11_11_p942;
  const Real Lambda_11_11_p948 = s16 * Lambda_11_11_p943 - c16 * Lambda_11_11_p944 -
      inverse_D5_p121 * Lambda_11_11_p939 - inverse_D5_p127 * Lambda_11_11_p942;
  const Real Lambda_11_11_p949 = c14 * Lambda_11_11_p947 + s14 * Lambda_11_11_p948;
  const Real Lambda_11_11_p950 = c15 * Lambda_11_11_p945 - s15 * Lambda_11_11_p946 +
      inverse_D5_p177 * Lambda_11_11_p942;
  const Real Lambda_11_11_p951 = s15 * Lambda_11_11_p940 + c15 * Lambda_11_11_p941 -
      inverse_D5_p365 * Lambda_11_11_p942;
  const Real Lambda_11_11_p952 = Lambda_11_11_p504 * Lambda_11_11_p942;
  const Real Lambda_11_11_p953 = 0.18 * Lambda_11_11_p949 + 0.226 * Lambda_11_11_p950 + s14 *
      Lambda_11_11_p951 - c14 * Lambda_11_11_p952;
  const Real Lambda_11_11_p954 = s14 * Lambda_11_11_p947 - c14 * Lambda_11_11_p948;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p955 = Lambda_11_11_p954 - inverse_D5_p408 * Lambda_11_11_p953;
  const Real Lambda_11_11_p956 = 0.226 * Lambda_11_11_p954 + inverse_D5_p383 * Lambda_11_11_p953;
  const Real Lambda_11_11_p957 = 0.18 * Lambda_11_11_p954 - c14 * Lambda_11_11_p951 - s14 *
      Lambda_11_11_p952 - inverse_D5_p390 * Lambda_11_11_p953;
  const Real Lambda_11_11_p958 = 0.072 * Lambda_11_11_p955 + c6 * Lambda_11_11_p956 - s6 *
      Lambda_11_11_p957;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p959 = s6 * Lambda_11_11_p956 + c6 * Lambda_11_11_p957 - inverse_D1_p35 *
      Lambda_11_11_p958;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p960 = Lambda_11_11_p950 + inverse_D1_p2 * Lambda_11_11_p953;
  const Real Lambda_11_11_p961 = Lambda_11_11_p949 - inverse_D1_p11 * Lambda_11_11_p953;
  const Real Lambda_11_11_p962 = c6 * Lambda_11_11_p960 - s6 * Lambda_11_11_p961;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p963 = 0.072 * Lambda_11_11_p962 - inverse_D1_p25 * Lambda_11_11_p958;
  const Real Lambda_11_11_p964 = c5 * Lambda_11_11_p959 + s5 * Lambda_11_11_p963;
  const Real Lambda_11_11_p965 = s6 * Lambda_11_11_p960 + c6 * Lambda_11_11_p961 - inverse_D1_p58 *
      Lambda_11_11_p958;
  const Real Lambda_11_11_p966 = Lambda_11_11_p955 - inverse_D1_p54 * Lambda_11_11_p958;
  const Real Lambda_11_11_p967 = s5 * Lambda_11_11_p965 + c5 * Lambda_11_11_p966;
  const Real Lambda_11_11_p968 = Lambda_11_11_p962 - inverse_D1_p42 * Lambda_11_11_p958;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p969 = s4 * (0.21799999999999997 * Lambda_11_11_p968 - s5 *
      Lambda_11_11_p959 + c5 * Lambda_11_11_p963 + inverse_D3_p3 * Lambda_11_11_p964);
  const Real Lambda_11_11_p970 = c4 * (0.21799999999999997 * Lambda_11_11_p967 + inverse_D3_p1 *
      Lambda_11_11_p964) - Lambda_11_11_p969;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p971 = c5 * Lambda_11_11_p965 - s5 * Lambda_11_11_p966 - inverse_D1_p83 *
      Lambda_11_11_p964 - inverse_D1_p87 * Lambda_11_11_p970;
  const Real Lambda_11_11_p972 = s4 * (Lambda_11_11_p968 + inverse_D1_p48 * Lambda_11_11_p964) -
      c4 * (Lambda_11_11_p967 + inverse_D1_p67 * Lambda_11_11_p964) + inverse_D1_p89 *
      Lambda_11_11_p970;
  const Real Lambda_11_11_p973 = s3 * Lambda_11_11_p971 - c3 * Lambda_11_11_p972;
  const Real Lambda_11_11_p974 = 0.422 * Lambda_11_11_p973;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p975 = s2 * (c3 * Lambda_11_11_p971 + s3 * Lambda_11_11_p972 +
      inverse_D1_p102 * Lambda_11_11_p974) + c2 * (Lambda_11_11_p973 - inverse_D1_p98 *
      Lambda_11_11_p974);
  const Real Lambda_11_11_p976 = 0.434 * Lambda_11_11_p975;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p977 = inverse_D1 * Lambda_11_11_p976;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p978 = inverse_D2 * Lambda_11_11_p974;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p979 = inverse_D3 * Lambda_11_11_p970;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p980 = inverse_D4 * Lambda_11_11_p964;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p981 = inverse_D5 * Lambda_11_11_p958;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p982 = inverse_D6 * Lambda_11_11_p953;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p983 = Lambda_11_11_p237 * Lambda_11_11_p982 - Lambda_11_11_p242 *
      Lambda_11_11_p981 - Lambda_11_11_p248 * Lambda_11_11_p980 - Lambda_11_11_p254 *
      Lambda_11_11_p979 - Lambda_11_11_p258 * Lambda_11_11_p978;
  const Real Lambda_11_11_p984 = 0.086 * Lambda_11_11_p702;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p985 = Lambda_11_11_p701 + 0.04672761636452121 * Lambda_11_11_p705;
  const Real Lambda_11_11_p986 = Lambda_11_11_p702 + 0.11533812622014242 * Lambda_11_11_p705;
  const Real Lambda_11_11_p987 = c20 * Lambda_11_11_p985 + s20 * Lambda_11_11_p986;
  const Real Lambda_11_11_p988 = 17.32841575379867 * Lambda_11_11_p705;
  const Real Lambda_11_11_p989 = 3.0523172236718206 * Lambda_11_11_p705;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p990 = s20 * Lambda_11_11_p988 + c20 * Lambda_11_11_p989 + inverse_D5_p8 *
      Lambda_11_11_p987;
  const Real Lambda_11_11_p991 = inverse_D5_p2 * Lambda_11_11_p987;
  const Real Lambda_11_11_p992 = s19 * Lambda_11_11_p990 + c19 * Lambda_11_11_p991;
  const Real Lambda_11_11_p993 = s20 * Lambda_11_11_p985 - c20 * Lambda_11_11_p986 -
      inverse_D18_p1 * Lambda_11_11_p987;
  const Real Lambda_11_11_p994 = c19 * Lambda_11_11_p993;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p995 = 0.269 * Lambda_11_11_p992 + inverse_D5_p23 * Lambda_11_11_p994;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p996 = c20 * Lambda_11_11_p988 - s20 * Lambda_11_11_p989 -
      inverse_D5_p14 * Lambda_11_11_p987;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p997 = 0.269 * Lambda_11_11_p996 - s19 * Lambda_11_11_p993 +
      inverse_D5_p29 * Lambda_11_11_p994;
  const Real Lambda_11_11_p998 = c18 * Lambda_11_11_p995 - s18 * Lambda_11_11_p997;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p999 = c19 * Lambda_11_11_p990 - s19 * Lambda_11_11_p991 -
      inverse_D5_p86 * Lambda_11_11_p994 - inverse_D5_p91 * Lambda_11_11_p998;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1000 = Lambda_11_11_p992 + inverse_D5_p54 * Lambda_11_11_p994;
  const Real Lambda_11_11_p1001 = Lambda_11_11_p996 + inverse_D5_p57 * Lambda_11_11_p994;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1002 = s18 * Lambda_11_11_p1001 - c18 * Lambda_11_11_p1000 +
      inverse_D5_p82 * Lambda_11_11_p998;
  const Real Lambda_11_11_p1003 = s17 * Lambda_11_11_p999 - c17 * Lambda_11_11_p1002;
  const Real Lambda_11_11_p1004 = s18 * Lambda_11_11_p995 + c18 * Lambda_11_11_p997 +
      inverse_D5_p49 * Lambda_11_11_p998;
  const Real Lambda_11_11_p1005 = inverse_D5_p46 * Lambda_11_11_p998;
  const Real Lambda_11_11_p1006 = c17 * Lambda_11_11_p1005 + s17 * Lambda_11_11_p1004;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1007 = 0.282 * Lambda_11_11_p1003 - inverse_D15_p1 * Lambda_11_11_p1006;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1008 = c18 * Lambda_11_11_p1001 + s18 * Lambda_11_11_p1000 -
      inverse_D5_p64 * Lambda_11_11_p998;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1009 = 0.282 * Lambda_11_11_p1008 - s17 * Lambda_11_11_p1005 + c17 *
      Lambda_11_11_p1004 + inverse_D15_p4 * Lambda_11_11_p1006;
  const Real Lambda_11_11_p1010 = s16 * Lambda_11_11_p1007 + c16 * Lambda_11_11_p1009;
  const Real Lambda_11_11_p1011 = Lambda_11_11_p1003 - inverse_D5_p99 * Lambda_11_11_p1006;
  const Real Lambda_11_11_p1012 = Lambda_11_11_p1008 + inverse_D5_p71 * Lambda_11_11_p1006;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1013 = c16 * Lambda_11_11_p1012 + s16 * Lambda_11_11_p1011 -
      inverse_D5_p140 * Lambda_11_11_p1010;
  const Real Lambda_11_11_p1014 = c17 * Lambda_11_11_p999 + s17 * Lambda_11_11_p1002 +
      inverse_D5_p131 * Lambda_11_11_p1006 + inverse_D5_p137 * Lambda_11_11_p1010;
  const Real Lambda_11_11_p1015 = c16 * Lambda_11_11_p1007 - s16 * Lambda_11_11_p1009 +
      inverse_D14_p1 * Lambda_11_11_p1010;
  const Real Lambda_11_11_p1016 = Lambda_11_11_p496 * Lambda_11_11_p1010;
  const Real Lambda_11_11_p1017 = c15 * Lambda_11_11_p1015 - s15 * Lambda_11_11_p1016;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p1018 = s15 * Lambda_11_11_p1013 + c15 * Lambda_11_11_p1014 +
      inverse_D5_p147 * Lambda_11_11_p1017;
  const Real Lambda_11_11_p1019 = s16 * Lambda_11_11_p1012 - c16 * Lambda_11_11_p1011 -
      inverse_D5_p121 * Lambda_11_11_p1010 - inverse_D5_p127 * Lambda_11_11_p1017;
  const Real Lambda_11_11_p1020 = c14 * Lambda_11_11_p1018 + s14 * Lambda_11_11_p1019;
  const Real Lambda_11_11_p1021 = c15 * Lambda_11_11_p1013 - s15 * Lambda_11_11_p1014 +
      inverse_D5_p177 * Lambda_11_11_p1017;
  const Real Lambda_11_11_p1022 = s15 * Lambda_11_11_p1015 + c15 * Lambda_11_11_p1016 -
      inverse_D5_p365 * Lambda_11_11_p1017;
  const Real Lambda_11_11_p1023 = Lambda_11_11_p504 * Lambda_11_11_p1017;
  const Real Lambda_11_11_p1024 = 0.18 * Lambda_11_11_p1020 + 0.226 * Lambda_11_11_p1021 + s14 *
      Lambda_11_11_p1022 - c14 * Lambda_11_11_p1023;
  const Real Lambda_11_11_p1025 = s14 * Lambda_11_11_p1018 - c14 * Lambda_11_11_p1019;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p1026 = Lambda_11_11_p1025 - inverse_D5_p408 * Lambda_11_11_p1024;
  const Real Lambda_11_11_p1027 = 0.226 * Lambda_11_11_p1025 + inverse_D5_p383 * Lambda_11_11_p1024;
  const Real Lambda_11_11_p1028 = 0.18 * Lambda_11_11_p1025 - c14 * Lambda_11_11_p1022 - s14 *
      Lambda_11_11_p1023 - inverse_D5_p390 * Lambda_11_11_p1024;
  const Real Lambda_11_11_p1029 = 0.072 * Lambda_11_11_p1026 + c6 * Lambda_11_11_p1027 - s6 *
      Lambda_11_11_p1028;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p1030 = s6 * Lambda_11_11_p1027 + c6 * Lambda_11_11_p1028 -
      inverse_D1_p35 * Lambda_11_11_p1029;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p1031 = Lambda_11_11_p1021 + inverse_D1_p2 * Lambda_11_11_p1024;
  const Real Lambda_11_11_p1032 = Lambda_11_11_p1020 - inverse_D1_p11 * Lambda_11_11_p1024;
  const Real Lambda_11_11_p1033 = c6 * Lambda_11_11_p1031 - s6 * Lambda_11_11_p1032;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p1034 = 0.072 * Lambda_11_11_p1033 - inverse_D1_p25 * Lambda_11_11_p1029;
  const Real Lambda_11_11_p1035 = c5 * Lambda_11_11_p1030 + s5 * Lambda_11_11_p1034;
  const Real Lambda_11_11_p1036 = s6 * Lambda_11_11_p1031 + c6 * Lambda_11_11_p1032 -
      inverse_D1_p58 * Lambda_11_11_p1029;
  const Real Lambda_11_11_p1037 = Lambda_11_11_p1026 - inverse_D1_p54 * Lambda_11_11_p1029;
  const Real Lambda_11_11_p1038 = s5 * Lambda_11_11_p1036 + c5 * Lambda_11_11_p1037;
  const Real Lambda_11_11_p1039 = Lambda_11_11_p1033 - inverse_D1_p42 * Lambda_11_11_p1029;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p1040 = s4 * (0.21799999999999997 * Lambda_11_11_p1039 - s5 *
      Lambda_11_11_p1030 + c5 * Lambda_11_11_p1034 + inverse_D3_p3 * Lambda_11_11_p1035);
  const Real Lambda_11_11_p1041 = c4 * (0.21799999999999997 * Lambda_11_11_p1038 + inverse_D3_p1 *
      Lambda_11_11_p1035) - Lambda_11_11_p1040;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p1042 = c5 * Lambda_11_11_p1036 - s5 * Lambda_11_11_p1037 -
      inverse_D1_p83 * Lambda_11_11_p1035 - inverse_D1_p87 * Lambda_11_11_p1041;
  const Real Lambda_11_11_p1043 = s4 * (Lambda_11_11_p1039 + inverse_D1_p48 * Lambda_11_11_p1035) -
      c4 * (Lambda_11_11_p1038 + inverse_D1_p67 * Lambda_11_11_p1035) + inverse_D1_p89 *
      Lambda_11_11_p1041;
  const Real Lambda_11_11_p1044 = s3 * Lambda_11_11_p1042 - c3 * Lambda_11_11_p1043;
  const Real Lambda_11_11_p1045 = 0.422 * Lambda_11_11_p1044;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p1046 = s2 * (c3 * Lambda_11_11_p1042 + s3 * Lambda_11_11_p1043 +
      inverse_D1_p102 * Lambda_11_11_p1045) + c2 * (Lambda_11_11_p1044 - inverse_D1_p98 *
      Lambda_11_11_p1045);
  const Real Lambda_11_11_p1047 = 0.434 * Lambda_11_11_p1046;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p1048 = inverse_D1 * Lambda_11_11_p1047;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p1049 = inverse_D2 * Lambda_11_11_p1045;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p1050 = inverse_D3 * Lambda_11_11_p1041;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p1051 = inverse_D4 * Lambda_11_11_p1035;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p1052 = inverse_D5 * Lambda_11_11_p1029;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p1053 = inverse_D6 * Lambda_11_11_p1024;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p1054 = Lambda_11_11_p237 * Lambda_11_11_p1053 - Lambda_11_11_p242 *
      Lambda_11_11_p1052 - Lambda_11_11_p248 * Lambda_11_11_p1051 - Lambda_11_11_p254 *
      Lambda_11_11_p1050 - Lambda_11_11_p258 * Lambda_11_11_p1049;
  const Real Lambda_11_11_p1055 = Lambda_11_11_p1054 - Lambda_11_11_p260 * Lambda_11_11_p1048;
  const Real Lambda_11_11_p1056 = Lambda_11_11_p60 * Lambda_11_11_p982 - Lambda_11_11_p65 *
      Lambda_11_11_p981 - Lambda_11_11_p71 * Lambda_11_11_p980 - Lambda_11_11_p77 *
      Lambda_11_11_p979 - Lambda_11_11_p81 * Lambda_11_11_p978;
  const Real Lambda_11_11_p1057 = Lambda_11_11_p60 * Lambda_11_11_p1053 - Lambda_11_11_p65 *
      Lambda_11_11_p1052 - Lambda_11_11_p71 * Lambda_11_11_p1051 - Lambda_11_11_p77 *
      Lambda_11_11_p1050 - Lambda_11_11_p81 * Lambda_11_11_p1049;
  const Real Lambda_11_11_p1058 = Lambda_11_11_p1057 - Lambda_11_11_p83 * Lambda_11_11_p1048;
  const Real Lambda_11_11_p1059 = Lambda_11_11_p1056 - Lambda_11_11_p83 * Lambda_11_11_p977 +
      Lambda_11_11_p539 * Lambda_11_11_p984 + Lambda_11_11_p1058 * Lambda_11_11_p849;
  const Real Lambda_11_11_p1060 = Lambda_11_11_p983 - Lambda_11_11_p260 * Lambda_11_11_p977 +
      Lambda_11_11_p537 * Lambda_11_11_p984 + Lambda_11_11_p1055 * Lambda_11_11_p849 +
      Lambda_11_11_p205 * Lambda_11_11_p1059;
  const Real Lambda_11_11_p1061 = Lambda_11_11_p313 * Lambda_11_11_p982 - Lambda_11_11_p318 *
      Lambda_11_11_p981 - Lambda_11_11_p324 * Lambda_11_11_p980 - Lambda_11_11_p330 *
      Lambda_11_11_p979 - Lambda_11_11_p334 * Lambda_11_11_p978;
  const Real Lambda_11_11_p1062 = Lambda_11_11_p313 * Lambda_11_11_p1053 - Lambda_11_11_p318 *
      Lambda_11_11_p1052 - Lambda_11_11_p324 * Lambda_11_11_p1051 - Lambda_11_11_p330 *
      Lambda_11_11_p1050 - Lambda_11_11_p334 * Lambda_11_11_p1049;
  const Real Lambda_11_11_p1063 = Lambda_11_11_p1062 - Lambda_11_11_p336 * Lambda_11_11_p1048;
  const Real Lambda_11_11_p1064 = Lambda_11_11_p1061 - Lambda_11_11_p336 * Lambda_11_11_p977 +
      Lambda_11_11_p541 * Lambda_11_11_p984 + Lambda_11_11_p1063 * Lambda_11_11_p849;
  const Real Lambda_11_11_p1065 = Lambda_11_11_p1060 - Lambda_11_11_p353 * Lambda_11_11_p1064;
  const Real Lambda_11_11_p1066 = Lambda_11_11_p1065 * Lambda_11_11_p450;
  const Real Lambda_11_11_p1067 = Lambda_11_11_p385 * Lambda_11_11_p982 - Lambda_11_11_p390 *
      Lambda_11_11_p981 - Lambda_11_11_p396 * Lambda_11_11_p980 - Lambda_11_11_p402 *
      Lambda_11_11_p979 - Lambda_11_11_p406 * Lambda_11_11_p978;
  const Real Lambda_11_11_p1068 = Lambda_11_11_p385 * Lambda_11_11_p1053 - Lambda_11_11_p390 *
      Lambda_11_11_p1052 - Lambda_11_11_p396 * Lambda_11_11_p1051 - Lambda_11_11_p402 *
      Lambda_11_11_p1050 - Lambda_11_11_p406 * Lambda_11_11_p1049;
  const Real Lambda_11_11_p1069 = Lambda_11_11_p1068 - Lambda_11_11_p408 * Lambda_11_11_p1048;
  const Real Lambda_11_11_p1070 = Lambda_11_11_p1067 - Lambda_11_11_p408 * Lambda_11_11_p977 +
      Lambda_11_11_p545 * Lambda_11_11_p984 + Lambda_11_11_p1069 * Lambda_11_11_p849 +
      Lambda_11_11_p422 * Lambda_11_11_p1064;
  const Real Lambda_11_11_p1071 = Lambda_11_11_p148 * Lambda_11_11_p982 - Lambda_11_11_p153 *
      Lambda_11_11_p981 - Lambda_11_11_p159 * Lambda_11_11_p980 - Lambda_11_11_p165 *
      Lambda_11_11_p979 - Lambda_11_11_p169 * Lambda_11_11_p978;
  const Real Lambda_11_11_p1072 = Lambda_11_11_p148 * Lambda_11_11_p1053 - Lambda_11_11_p153 *
      Lambda_11_11_p1052 - Lambda_11_11_p159 * Lambda_11_11_p1051 - Lambda_11_11_p165 *
      Lambda_11_11_p1050 - Lambda_11_11_p169 * Lambda_11_11_p1049;
  const Real Lambda_11_11_p1073 = Lambda_11_11_p1072 - Lambda_11_11_p171 * Lambda_11_11_p1048;
  const Real Lambda_11_11_p1074 = Lambda_11_11_p1071 - Lambda_11_11_p171 * Lambda_11_11_p977 +
      Lambda_11_11_p547 * Lambda_11_11_p984 + Lambda_11_11_p1073 * Lambda_11_11_p849;
  const Real Lambda_11_11_p1075 = Lambda_11_11_p1070 + Lambda_11_11_p205 * Lambda_11_11_p1074 -
      Lambda_11_11_p438 * Lambda_11_11_p1066;
  const Real Lambda_11_11_p1076 = Lambda_11_11_p1075 * Lambda_11_11_p562;
  const Real Lambda_11_11_p1077 = Lambda_11_11_p593 * Lambda_11_11_p982 - Lambda_11_11_p598 *
      Lambda_11_11_p981 - Lambda_11_11_p604 * Lambda_11_11_p980 - Lambda_11_11_p610 *
      Lambda_11_11_p979 - Lambda_11_11_p614 * Lambda_11_11_p978;
  const Real Lambda_11_11_p1078 = Lambda_11_11_p593 * Lambda_11_11_p1053 - Lambda_11_11_p598 *
      Lambda_11_11_p1052 - Lambda_11_11_p604 * Lambda_11_11_p1051 - Lambda_11_11_p610 *
      Lambda_11_11_p1050 - Lambda_11_11_p614 * Lambda_11_11_p1049;
  const Real Lambda_11_11_p1079 = Lambda_11_11_p1078 - Lambda_11_11_p616 * Lambda_11_11_p1048;
  const Real Lambda_11_11_p1080 = Lambda_11_11_p1077 - Lambda_11_11_p616 * Lambda_11_11_p977 +
      Lambda_11_11_p647 * Lambda_11_11_p984 + Lambda_11_11_p1079 * Lambda_11_11_p849 -
      Lambda_11_11_p353 * Lambda_11_11_p1074;
  const Real Lambda_11_11_p1081 = Lambda_11_11_p1080 - Lambda_11_11_p422 * Lambda_11_11_p1059 +
      Lambda_11_11_p635 * Lambda_11_11_p1066 - Lambda_11_11_p645 * Lambda_11_11_p1076;
  const Real Lambda_11_11_p1082 = Lambda_11_11_p1081 * Lambda_11_11_p655;
  const Real Lambda_11_11_p1083 = Lambda_11_11_p1074 - Lambda_11_11_p355 * Lambda_11_11_p1066 -
      Lambda_11_11_p658 * Lambda_11_11_p1076 - Lambda_11_11_p660 * Lambda_11_11_p1082;
  const Real Lambda_11_11_p1084 = Lambda_11_11_p1083 * Lambda_11_11_p663;
  const Real Lambda_11_11_p1085 = Lambda_11_11_p1059 - Lambda_11_11_p445 * Lambda_11_11_p1066 +
      Lambda_11_11_p666 * Lambda_11_11_p1076 - Lambda_11_11_p668 * Lambda_11_11_p1082 -
      Lambda_11_11_p670 * Lambda_11_11_p1084;
  const Real Lambda_11_11_p1086 = Lambda_11_11_p1085 * Lambda_11_11_p674;
  const Real Lambda_11_11_p1087 = Lambda_11_11_p1064 - Lambda_11_11_p421 * Lambda_11_11_p1066 -
      Lambda_11_11_p677 * Lambda_11_11_p1076 - Lambda_11_11_p679 * Lambda_11_11_p1082 -
      Lambda_11_11_p681 * Lambda_11_11_p1084;
  const Real Lambda_11_11_p1088 = Lambda_11_11_p1087 - Lambda_11_11_p683 * Lambda_11_11_p1086;
  const Real Lambda_11_11_p1089 = Lambda_11_11_p1088 * Lambda_11_11_p688;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p1090 = inverse_D14 * Lambda_11_11_p942;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1091 = inverse_D15 * Lambda_11_11_p939;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1092 = minus_inverse_D16 * Lambda_11_11_p932;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1093 = inverse_D17 * Lambda_11_11_p929;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p1094 = Lambda_11_11_p709 * Lambda_11_11_p1093 - Lambda_11_11_p715 *
      Lambda_11_11_p1092 + Lambda_11_11_p719 * Lambda_11_11_p1091 + Lambda_11_11_p722 *
      Lambda_11_11_p1090 + Lambda_11_11_p733 * Lambda_11_11_p982;
  const Real Lambda_11_11_p1095 = Lambda_11_11_p1094 + Lambda_11_11_p738 * Lambda_11_11_p981 +
      Lambda_11_11_p744 * Lambda_11_11_p980 + Lambda_11_11_p750 * Lambda_11_11_p979 +
      Lambda_11_11_p754 * Lambda_11_11_p978;
  const Real Lambda_11_11_p1096 = Lambda_11_11_p929 * Lambda_11_11_p887 - Lambda_11_11_p932 *
      Lambda_11_11_p886 + Lambda_11_11_p939 * Lambda_11_11_p885 + Lambda_11_11_p942 *
      Lambda_11_11_p884 + Lambda_11_11_p953 * Lambda_11_11_p535;
  const Real Lambda_11_11_p1097 = Lambda_11_11_p1096 + Lambda_11_11_p958 * Lambda_11_11_p534 +
      Lambda_11_11_p964 * Lambda_11_11_p533 + Lambda_11_11_p970 * Lambda_11_11_p532 +
      Lambda_11_11_p974 * Lambda_11_11_p531;
  const Real Lambda_11_11_p1098 = Lambda_11_11_p1097 + Lambda_11_11_p976 * Lambda_11_11_p530;
  const Real Lambda_11_11_p1099 = Lambda_11_11_p1095 + Lambda_11_11_p756 * Lambda_11_11_p977 +
      Lambda_11_11_p984 * Lambda_11_11_p900 - Lambda_11_11_p1098 * Lambda_11_11_p850 +
      Lambda_11_11_p860 * Lambda_11_11_p1066;
  const Real Lambda_11_11_p1100 = Lambda_11_11_p1099 + Lambda_11_11_p870 * Lambda_11_11_p1076 +
      Lambda_11_11_p876 * Lambda_11_11_p1082 - Lambda_11_11_p878 * Lambda_11_11_p1084 -
      Lambda_11_11_p880 * Lambda_11_11_p1086;
  const Real Lambda_11_11_p1101 = Lambda_11_11_p705 * Lambda_11_11_p913 + Lambda_11_11_p987 *
      Lambda_11_11_p912 - Lambda_11_11_p994 * Lambda_11_11_p911 + Lambda_11_11_p998 *
      Lambda_11_11_p907 - Lambda_11_11_p1006 * Lambda_11_11_p906;
  const Real Lambda_11_11_p1102 = Lambda_11_11_p1101 + Lambda_11_11_p1010 * Lambda_11_11_p905 +
      Lambda_11_11_p1017 * Lambda_11_11_p904 + Lambda_11_11_p1024 * Lambda_11_11_p846 +
      Lambda_11_11_p1029 * Lambda_11_11_p845;
  const Real Lambda_11_11_p1103 = Lambda_11_11_p1102 + Lambda_11_11_p1035 * Lambda_11_11_p844 +
      Lambda_11_11_p1041 * Lambda_11_11_p843 + Lambda_11_11_p1045 * Lambda_11_11_p842 +
      Lambda_11_11_p1047 * Lambda_11_11_p841;
  const Real Lambda_11_11_p1104 = Lambda_11_11_p1103 * Lambda_11_11_p849;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p1105 = inverse_D14 * Lambda_11_11_p1017;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1106 = inverse_D15 * Lambda_11_11_p1010;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1107 = minus_inverse_D16 * Lambda_11_11_p1006;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1108 = inverse_D17 * Lambda_11_11_p998;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p1109 = Lambda_11_11_p709 * Lambda_11_11_p1108 - Lambda_11_11_p715 *
      Lambda_11_11_p1107 + Lambda_11_11_p719 * Lambda_11_11_p1106 + Lambda_11_11_p722 *
      Lambda_11_11_p1105 + Lambda_11_11_p733 * Lambda_11_11_p1053;
  const Real Lambda_11_11_p1110 = Lambda_11_11_p1109 + Lambda_11_11_p738 * Lambda_11_11_p1052 +
      Lambda_11_11_p744 * Lambda_11_11_p1051 + Lambda_11_11_p750 * Lambda_11_11_p1050 +
      Lambda_11_11_p754 * Lambda_11_11_p1049;
  const Real Lambda_11_11_p1111 = Lambda_11_11_p705 * Lambda_11_11_p893 + Lambda_11_11_p987 *
      Lambda_11_11_p892 - Lambda_11_11_p994 * Lambda_11_11_p891 + Lambda_11_11_p998 *
      Lambda_11_11_p887 - Lambda_11_11_p1006 * Lambda_11_11_p886;
  const Real Lambda_11_11_p1112 = Lambda_11_11_p1111 + Lambda_11_11_p1010 * Lambda_11_11_p885 +
      Lambda_11_11_p1017 * Lambda_11_11_p884 + Lambda_11_11_p1024 * Lambda_11_11_p535 +
      Lambda_11_11_p1029 * Lambda_11_11_p534;
  const Real Lambda_11_11_p1113 = Lambda_11_11_p1112 + Lambda_11_11_p1035 * Lambda_11_11_p533 +
      Lambda_11_11_p1041 * Lambda_11_11_p532 + Lambda_11_11_p1045 * Lambda_11_11_p531 +
      Lambda_11_11_p1047 * Lambda_11_11_p530;
  const Real Lambda_11_11_p1114 = Lambda_11_11_p1113 * Lambda_11_11_p850;
  const Real Lambda_11_11_p1115 = Lambda_11_11_p1114 -
      (Lambda_11_11_p1104 + (Lambda_11_11_p1110 + Lambda_11_11_p756 * Lambda_11_11_p1048));
  const Real Lambda_11_11_p1116 = Lambda_11_11_p929 * Lambda_11_11_p907 - Lambda_11_11_p932 *
      Lambda_11_11_p906 + Lambda_11_11_p939 * Lambda_11_11_p905 + Lambda_11_11_p942 *
      Lambda_11_11_p904 + Lambda_11_11_p953 * Lambda_11_11_p846;
  const Real Lambda_11_11_p1117 = Lambda_11_11_p1116 + Lambda_11_11_p958 * Lambda_11_11_p845 +
      Lambda_11_11_p964 * Lambda_11_11_p844 + Lambda_11_11_p970 * Lambda_11_11_p843 +
      Lambda_11_11_p974 * Lambda_11_11_p842;
  const Real Lambda_11_11_p1118 = Lambda_11_11_p1117 + Lambda_11_11_p976 * Lambda_11_11_p841;
  const Real Lambda_11_11_p1119 = Lambda_11_11_p849 * (Lambda_11_11_p1118 - Lambda_11_11_p1115) +
      (Lambda_11_11_p1100 - Lambda_11_11_p883 * Lambda_11_11_p1089);
  const Real Lambda_11_11_p1120 = Lambda_11_11_p1098 + Lambda_11_11_p899 * Lambda_11_11_p984 +
      Lambda_11_11_p1113 * Lambda_11_11_p849;
  const Real Lambda_11_11_p1121 = Lambda_11_11_p1120 + Lambda_11_11_p1065 * Lambda_11_11_p543 +
      Lambda_11_11_p1075 * Lambda_11_11_p563 + Lambda_11_11_p1081 * Lambda_11_11_p656 -
      Lambda_11_11_p1083 * Lambda_11_11_p664;
  const Real Lambda_11_11_p1122 = Lambda_11_11_p1121 - Lambda_11_11_p1085 * Lambda_11_11_p675 -
      Lambda_11_11_p1088 * Lambda_11_11_p689 - Lambda_11_11_p1119 * Lambda_11_11_p923;
  const Real Lambda_11_11_p1123 = Lambda_11_11_p1119 * Lambda_11_11_p922;
  const Real Lambda_11_11_p1124 = Lambda_11_11_p929 * Lambda_11_11_p1093 - Lambda_11_11_p932 *
      Lambda_11_11_p1092 + Lambda_11_11_p939 * Lambda_11_11_p1091 + Lambda_11_11_p942 *
      Lambda_11_11_p1090 + Lambda_11_11_p953 * Lambda_11_11_p982;
  const Real Lambda_11_11_p1125 = Lambda_11_11_p1124 + Lambda_11_11_p958 * Lambda_11_11_p981 +
      Lambda_11_11_p964 * Lambda_11_11_p980 + Lambda_11_11_p970 * Lambda_11_11_p979 +
      Lambda_11_11_p974 * Lambda_11_11_p978;
  const Real Lambda_11_11_p1126 = Lambda_11_11_p929 * Lambda_11_11_p1108 - Lambda_11_11_p932 *
      Lambda_11_11_p1107 + Lambda_11_11_p939 * Lambda_11_11_p1106 + Lambda_11_11_p942 *
      Lambda_11_11_p1105 + Lambda_11_11_p953 * Lambda_11_11_p1053;
  const Real Lambda_11_11_p1127 = Lambda_11_11_p1126 + Lambda_11_11_p958 * Lambda_11_11_p1052 +
      Lambda_11_11_p964 * Lambda_11_11_p1051 + Lambda_11_11_p970 * Lambda_11_11_p1050 +
      Lambda_11_11_p974 * Lambda_11_11_p1049;
  const Real Lambda_11_11_p1128 = Lambda_11_11_p1127 + Lambda_11_11_p976 * Lambda_11_11_p1048;
  const Real Lambda_11_11_p1129 = Lambda_11_11_p705 * (1065.380700001509 * Lambda_11_11_p705) -
      Lambda_11_11_p987 * (minus_inverse_D19 * Lambda_11_11_p987) + Lambda_11_11_p994 *
      (inverse_D18 * Lambda_11_11_p994);
  const Real Lambda_11_11_p1130 = Lambda_11_11_p1129 + Lambda_11_11_p998 * Lambda_11_11_p1108 -
      Lambda_11_11_p1006 * Lambda_11_11_p1107 + Lambda_11_11_p1010 * Lambda_11_11_p1106 +
      Lambda_11_11_p1017 * Lambda_11_11_p1105;
  const Real Lambda_11_11_p1131 = Lambda_11_11_p1130 + Lambda_11_11_p1024 * Lambda_11_11_p1053 +
      Lambda_11_11_p1029 * Lambda_11_11_p1052 + Lambda_11_11_p1035 * Lambda_11_11_p1051 +
      Lambda_11_11_p1041 * Lambda_11_11_p1050;
  const Real Lambda_11_11_p1132 = Lambda_11_11_p1131 + Lambda_11_11_p1045 * Lambda_11_11_p1049 +
      Lambda_11_11_p1047 * Lambda_11_11_p1048;
  const Real Lambda_11_11_p1133 = Lambda_11_11_p1128 + Lambda_11_11_p1113 * Lambda_11_11_p984 +
      Lambda_11_11_p1132 * Lambda_11_11_p849;
  const Real Lambda_11_11_p1134 = Lambda_11_11_p1125 + Lambda_11_11_p976 * Lambda_11_11_p977 +
      Lambda_11_11_p984 * (Lambda_11_11_p1098 + Lambda_11_11_p1120) + Lambda_11_11_p849 *
      (Lambda_11_11_p1128 + Lambda_11_11_p1133);
  const Real Lambda_11_11_p1135 = Lambda_11_11_p1134 + Lambda_11_11_p1065 * Lambda_11_11_p1066 +
      Lambda_11_11_p1075 * Lambda_11_11_p1076 + Lambda_11_11_p1081 * Lambda_11_11_p1082 -
      Lambda_11_11_p1083 * Lambda_11_11_p1084;
  const Real Lambda_11_11_p1136 = 1.0 / (Lambda_11_11_p1135 - Lambda_11_11_p1085 *
      Lambda_11_11_p1086 - Lambda_11_11_p1088 * Lambda_11_11_p1089 - Lambda_11_11_p1119 *
      Lambda_11_11_p1123);
  const Real Lambda_11_11_p1137 = Lambda_11_11_p1122 * Lambda_11_11_p1136;

  // link 20 (right_hand), force propagation
  const Real Lambda_11_11_p1138 = c20 * Lambda_11_11_p462 + s20 * Lambda_11_11_p465;
  const Real Lambda_11_11_p1139 = s20 * Lambda_11_11_p462 - c20 * Lambda_11_11_p465;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_11_11_p1140 = s19 * Lambda_11_11_p1139 - c19 * Lambda_11_11_p463;
  const Real Lambda_11_11_p1141 = 0.269 * Lambda_11_11_p1140;
  const Real Lambda_11_11_p1142 = 0.269 * Lambda_11_11_p1138;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_11_11_p1143 = c18 * Lambda_11_11_p1141 - s18 * Lambda_11_11_p1142;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1144 = s18 * Lambda_11_11_p1138 - c18 * Lambda_11_11_p1140 +
      inverse_D5_p82 * Lambda_11_11_p1143;
  const Real Lambda_11_11_p1145 = c19 * Lambda_11_11_p1139 + s19 * Lambda_11_11_p463 -
      inverse_D5_p91 * Lambda_11_11_p1143;
  const Real Lambda_11_11_p1146 = s17 * Lambda_11_11_p1145 - c17 * Lambda_11_11_p1144;
  const Real Lambda_11_11_p1147 = s18 * Lambda_11_11_p1141 + c18 * Lambda_11_11_p1142 +
      inverse_D5_p49 * Lambda_11_11_p1143;
  const Real Lambda_11_11_p1148 = inverse_D5_p46 * Lambda_11_11_p1143;
  const Real Lambda_11_11_p1149 = c17 * Lambda_11_11_p1148 + s17 * Lambda_11_11_p1147;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1150 = 0.282 * Lambda_11_11_p1146 - inverse_D15_p1 * Lambda_11_11_p1149;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1151 = c18 * Lambda_11_11_p1138 + s18 * Lambda_11_11_p1140 -
      inverse_D5_p64 * Lambda_11_11_p1143;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1152 = 0.282 * Lambda_11_11_p1151 - s17 * Lambda_11_11_p1148 + c17 *
      Lambda_11_11_p1147 + inverse_D15_p4 * Lambda_11_11_p1149;
  const Real Lambda_11_11_p1153 = s16 * Lambda_11_11_p1150 + c16 * Lambda_11_11_p1152;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1154 = c16 * Lambda_11_11_p1150 - s16 * Lambda_11_11_p1152 +
      inverse_D14_p1 * Lambda_11_11_p1153;
  const Real Lambda_11_11_p1155 = Lambda_11_11_p496 * Lambda_11_11_p1153;
  const Real Lambda_11_11_p1156 = c15 * Lambda_11_11_p1154 - s15 * Lambda_11_11_p1155;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1157 = Lambda_11_11_p1151 + inverse_D5_p71 * Lambda_11_11_p1149;
  const Real Lambda_11_11_p1158 = Lambda_11_11_p1146 - inverse_D5_p99 * Lambda_11_11_p1149;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1159 = c16 * Lambda_11_11_p1157 + s16 * Lambda_11_11_p1158 -
      inverse_D5_p140 * Lambda_11_11_p1153;
  const Real Lambda_11_11_p1160 = c17 * Lambda_11_11_p1145 + s17 * Lambda_11_11_p1144 +
      inverse_D5_p131 * Lambda_11_11_p1149 + inverse_D5_p137 * Lambda_11_11_p1153;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p1161 = s15 * Lambda_11_11_p1159 + c15 * Lambda_11_11_p1160 +
      inverse_D5_p147 * Lambda_11_11_p1156;
  const Real Lambda_11_11_p1162 = s16 * Lambda_11_11_p1157 - c16 * Lambda_11_11_p1158 -
      inverse_D5_p121 * Lambda_11_11_p1153 - inverse_D5_p127 * Lambda_11_11_p1156;
  const Real Lambda_11_11_p1163 = c14 * Lambda_11_11_p1161 + s14 * Lambda_11_11_p1162;
  const Real Lambda_11_11_p1164 = c15 * Lambda_11_11_p1159 - s15 * Lambda_11_11_p1160 +
      inverse_D5_p177 * Lambda_11_11_p1156;
  const Real Lambda_11_11_p1165 = s15 * Lambda_11_11_p1154 + c15 * Lambda_11_11_p1155 -
      inverse_D5_p365 * Lambda_11_11_p1156;
  const Real Lambda_11_11_p1166 = Lambda_11_11_p504 * Lambda_11_11_p1156;
  const Real Lambda_11_11_p1167 = 0.18 * Lambda_11_11_p1163 + 0.226 * Lambda_11_11_p1164 + s14 *
      Lambda_11_11_p1165 - c14 * Lambda_11_11_p1166;
  const Real Lambda_11_11_p1168 = s14 * Lambda_11_11_p1161 - c14 * Lambda_11_11_p1162;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p1169 = Lambda_11_11_p1168 - inverse_D5_p408 * Lambda_11_11_p1167;
  const Real Lambda_11_11_p1170 = 0.226 * Lambda_11_11_p1168 + inverse_D5_p383 * Lambda_11_11_p1167;
  const Real Lambda_11_11_p1171 = 0.18 * Lambda_11_11_p1168 - c14 * Lambda_11_11_p1165 - s14 *
      Lambda_11_11_p1166 - inverse_D5_p390 * Lambda_11_11_p1167;
  const Real Lambda_11_11_p1172 = 0.072 * Lambda_11_11_p1169 + c6 * Lambda_11_11_p1170 - s6 *
      Lambda_11_11_p1171;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p1173 = s6 * Lambda_11_11_p1170 + c6 * Lambda_11_11_p1171 -
      inverse_D1_p35 * Lambda_11_11_p1172;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p1174 = Lambda_11_11_p1164 + inverse_D1_p2 * Lambda_11_11_p1167;
  const Real Lambda_11_11_p1175 = Lambda_11_11_p1163 - inverse_D1_p11 * Lambda_11_11_p1167;
  const Real Lambda_11_11_p1176 = c6 * Lambda_11_11_p1174 - s6 * Lambda_11_11_p1175;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p1177 = 0.072 * Lambda_11_11_p1176 - inverse_D1_p25 * Lambda_11_11_p1172;
  const Real Lambda_11_11_p1178 = c5 * Lambda_11_11_p1173 + s5 * Lambda_11_11_p1177;
  const Real Lambda_11_11_p1179 = s6 * Lambda_11_11_p1174 + c6 * Lambda_11_11_p1175 -
      inverse_D1_p58 * Lambda_11_11_p1172;
  const Real Lambda_11_11_p1180 = Lambda_11_11_p1169 - inverse_D1_p54 * Lambda_11_11_p1172;
  const Real Lambda_11_11_p1181 = s5 * Lambda_11_11_p1179 + c5 * Lambda_11_11_p1180;
  const Real Lambda_11_11_p1182 = Lambda_11_11_p1176 - inverse_D1_p42 * Lambda_11_11_p1172;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p1183 = s4 * (0.21799999999999997 * Lambda_11_11_p1182 - s5 *
      Lambda_11_11_p1173 + c5 * Lambda_11_11_p1177 + inverse_D3_p3 * Lambda_11_11_p1178);
  const Real Lambda_11_11_p1184 = c4 * (0.21799999999999997 * Lambda_11_11_p1181 + inverse_D3_p1 *
      Lambda_11_11_p1178) - Lambda_11_11_p1183;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p1185 = c5 * Lambda_11_11_p1179 - s5 * Lambda_11_11_p1180 -
      inverse_D1_p83 * Lambda_11_11_p1178 - inverse_D1_p87 * Lambda_11_11_p1184;
  const Real Lambda_11_11_p1186 = s4 * (Lambda_11_11_p1182 + inverse_D1_p48 * Lambda_11_11_p1178) -
      c4 * (Lambda_11_11_p1181 + inverse_D1_p67 * Lambda_11_11_p1178) + inverse_D1_p89 *
      Lambda_11_11_p1184;
  const Real Lambda_11_11_p1187 = s3 * Lambda_11_11_p1185 - c3 * Lambda_11_11_p1186;
  const Real Lambda_11_11_p1188 = 0.422 * Lambda_11_11_p1187;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p1189 = s2 * (c3 * Lambda_11_11_p1185 + s3 * Lambda_11_11_p1186 +
      inverse_D1_p102 * Lambda_11_11_p1188) + c2 * (Lambda_11_11_p1187 - inverse_D1_p98 *
      Lambda_11_11_p1188);
  const Real Lambda_11_11_p1190 = 0.434 * Lambda_11_11_p1189;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p1191 = inverse_D1 * Lambda_11_11_p1190;

  // link 2 (thigh), force propagation
  const Real Lambda_11_11_p1192 = inverse_D2 * Lambda_11_11_p1188;

  // link 3 (hip), force propagation
  const Real Lambda_11_11_p1193 = inverse_D3 * Lambda_11_11_p1184;

  // link 4 (chest1), force propagation
  const Real Lambda_11_11_p1194 = inverse_D4 * Lambda_11_11_p1178;

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p1195 = inverse_D5 * Lambda_11_11_p1172;

  // link 6 (chest3), force propagation
  const Real Lambda_11_11_p1196 = inverse_D6 * Lambda_11_11_p1167;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p1197 = Lambda_11_11_p237 * Lambda_11_11_p1196 - Lambda_11_11_p242 *
      Lambda_11_11_p1195 - Lambda_11_11_p248 * Lambda_11_11_p1194 - Lambda_11_11_p254 *
      Lambda_11_11_p1193 - Lambda_11_11_p258 * Lambda_11_11_p1192;
  const Real Lambda_11_11_p1198 = Lambda_11_11_p60 * Lambda_11_11_p1196 - Lambda_11_11_p65 *
      Lambda_11_11_p1195 - Lambda_11_11_p71 * Lambda_11_11_p1194 - Lambda_11_11_p77 *
      Lambda_11_11_p1193 - Lambda_11_11_p81 * Lambda_11_11_p1192;
  const Real Lambda_11_11_p1199 = Lambda_11_11_p1198 - Lambda_11_11_p83 * Lambda_11_11_p1191 -
      Lambda_11_11_p1058 * Lambda_11_11_p850 - Lambda_11_11_p853 * Lambda_11_11_p984;
  const Real Lambda_11_11_p1200 = Lambda_11_11_p1197 - Lambda_11_11_p260 * Lambda_11_11_p1191 -
      Lambda_11_11_p1055 * Lambda_11_11_p850 - Lambda_11_11_p848 * Lambda_11_11_p984 +
      Lambda_11_11_p205 * Lambda_11_11_p1199;
  const Real Lambda_11_11_p1201 = Lambda_11_11_p313 * Lambda_11_11_p1196 - Lambda_11_11_p318 *
      Lambda_11_11_p1195 - Lambda_11_11_p324 * Lambda_11_11_p1194 - Lambda_11_11_p330 *
      Lambda_11_11_p1193 - Lambda_11_11_p334 * Lambda_11_11_p1192;
  const Real Lambda_11_11_p1202 = Lambda_11_11_p1201 - Lambda_11_11_p336 * Lambda_11_11_p1191 -
      Lambda_11_11_p1063 * Lambda_11_11_p850 - Lambda_11_11_p858 * Lambda_11_11_p984;
  const Real Lambda_11_11_p1203 = Lambda_11_11_p1200 - Lambda_11_11_p353 * Lambda_11_11_p1202;
  const Real Lambda_11_11_p1204 = Lambda_11_11_p1203 * Lambda_11_11_p450;
  const Real Lambda_11_11_p1205 = Lambda_11_11_p385 * Lambda_11_11_p1196 - Lambda_11_11_p390 *
      Lambda_11_11_p1195 - Lambda_11_11_p396 * Lambda_11_11_p1194 - Lambda_11_11_p402 *
      Lambda_11_11_p1193 - Lambda_11_11_p406 * Lambda_11_11_p1192;
  const Real Lambda_11_11_p1206 = Lambda_11_11_p1205 - Lambda_11_11_p408 * Lambda_11_11_p1191 -
      Lambda_11_11_p1069 * Lambda_11_11_p850 - Lambda_11_11_p864 * Lambda_11_11_p984 +
      Lambda_11_11_p422 * Lambda_11_11_p1202;
  const Real Lambda_11_11_p1207 = Lambda_11_11_p148 * Lambda_11_11_p1196 - Lambda_11_11_p153 *
      Lambda_11_11_p1195 - Lambda_11_11_p159 * Lambda_11_11_p1194 - Lambda_11_11_p165 *
      Lambda_11_11_p1193 - Lambda_11_11_p169 * Lambda_11_11_p1192;
  const Real Lambda_11_11_p1208 = Lambda_11_11_p1207 - Lambda_11_11_p171 * Lambda_11_11_p1191 -
      Lambda_11_11_p1073 * Lambda_11_11_p850 - Lambda_11_11_p868 * Lambda_11_11_p984;
  const Real Lambda_11_11_p1209 = Lambda_11_11_p1206 + Lambda_11_11_p205 * Lambda_11_11_p1208 -
      Lambda_11_11_p438 * Lambda_11_11_p1204;
  const Real Lambda_11_11_p1210 = Lambda_11_11_p1209 * Lambda_11_11_p562;
  const Real Lambda_11_11_p1211 = Lambda_11_11_p593 * Lambda_11_11_p1196 - Lambda_11_11_p598 *
      Lambda_11_11_p1195 - Lambda_11_11_p604 * Lambda_11_11_p1194 - Lambda_11_11_p610 *
      Lambda_11_11_p1193 - Lambda_11_11_p614 * Lambda_11_11_p1192;
  const Real Lambda_11_11_p1212 = Lambda_11_11_p1211 - Lambda_11_11_p616 * Lambda_11_11_p1191 -
      Lambda_11_11_p1079 * Lambda_11_11_p850 - Lambda_11_11_p874 * Lambda_11_11_p984 -
      Lambda_11_11_p353 * Lambda_11_11_p1208;
  const Real Lambda_11_11_p1213 = Lambda_11_11_p1212 - Lambda_11_11_p422 * Lambda_11_11_p1199 +
      Lambda_11_11_p635 * Lambda_11_11_p1204 - Lambda_11_11_p645 * Lambda_11_11_p1210;
  const Real Lambda_11_11_p1214 = Lambda_11_11_p1213 * Lambda_11_11_p655;
  const Real Lambda_11_11_p1215 = Lambda_11_11_p1208 - Lambda_11_11_p355 * Lambda_11_11_p1204 -
      Lambda_11_11_p658 * Lambda_11_11_p1210 - Lambda_11_11_p660 * Lambda_11_11_p1214;
  const Real Lambda_11_11_p1216 = Lambda_11_11_p1215 * Lambda_11_11_p663;
  const Real Lambda_11_11_p1217 = Lambda_11_11_p1199 - Lambda_11_11_p445 * Lambda_11_11_p1204 +
      Lambda_11_11_p666 * Lambda_11_11_p1210 - Lambda_11_11_p668 * Lambda_11_11_p1214 -
      Lambda_11_11_p670 * Lambda_11_11_p1216;
  const Real Lambda_11_11_p1218 = Lambda_11_11_p1217 * Lambda_11_11_p674;
  const Real Lambda_11_11_p1219 = Lambda_11_11_p1202 - Lambda_11_11_p421 * Lambda_11_11_p1204 -
      Lambda_11_11_p677 * Lambda_11_11_p1210 - Lambda_11_11_p679 * Lambda_11_11_p1214 -
      Lambda_11_11_p681 * Lambda_11_11_p1216;
  const Real Lambda_11_11_p1220 = Lambda_11_11_p1219 - Lambda_11_11_p683 * Lambda_11_11_p1218;
  const Real Lambda_11_11_p1221 = Lambda_11_11_p1220 * Lambda_11_11_p688;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_11_11_p1222 = inverse_D14 * Lambda_11_11_p1156;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_11_11_p1223 = inverse_D15 * Lambda_11_11_p1153;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1224 = minus_inverse_D16 * Lambda_11_11_p1149;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_11_11_p1225 = inverse_D17 * Lambda_11_11_p1143;

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p1226 = Lambda_11_11_p709 * Lambda_11_11_p1225 - Lambda_11_11_p715 *
      Lambda_11_11_p1224 + Lambda_11_11_p719 * Lambda_11_11_p1223 + Lambda_11_11_p722 *
      Lambda_11_11_p1222 + Lambda_11_11_p733 * Lambda_11_11_p1196;
  const Real Lambda_11_11_p1227 = Lambda_11_11_p1226 + Lambda_11_11_p738 * Lambda_11_11_p1195 +
      Lambda_11_11_p744 * Lambda_11_11_p1194 + Lambda_11_11_p750 * Lambda_11_11_p1193 +
      Lambda_11_11_p754 * Lambda_11_11_p1192;
  const Real Lambda_11_11_p1228 = Lambda_11_11_p1143 * Lambda_11_11_p907 - Lambda_11_11_p1149 *
      Lambda_11_11_p906 + Lambda_11_11_p1153 * Lambda_11_11_p905 + Lambda_11_11_p1156 *
      Lambda_11_11_p904 + Lambda_11_11_p1167 * Lambda_11_11_p846;
  const Real Lambda_11_11_p1229 = Lambda_11_11_p1228 + Lambda_11_11_p1172 * Lambda_11_11_p845 +
      Lambda_11_11_p1178 * Lambda_11_11_p844 + Lambda_11_11_p1184 * Lambda_11_11_p843 +
      Lambda_11_11_p1188 * Lambda_11_11_p842;
  const Real Lambda_11_11_p1230 = Lambda_11_11_p1229 + Lambda_11_11_p1190 * Lambda_11_11_p841;
  const Real Lambda_11_11_p1231 = Lambda_11_11_p1227 + Lambda_11_11_p756 * Lambda_11_11_p1191 -
      Lambda_11_11_p984 * Lambda_11_11_p917 + Lambda_11_11_p1230 * Lambda_11_11_p849 +
      Lambda_11_11_p860 * Lambda_11_11_p1204;
  const Real Lambda_11_11_p1232 = Lambda_11_11_p1231 + Lambda_11_11_p870 * Lambda_11_11_p1210 +
      Lambda_11_11_p876 * Lambda_11_11_p1214 - Lambda_11_11_p878 * Lambda_11_11_p1216 -
      Lambda_11_11_p880 * Lambda_11_11_p1218;
  const Real Lambda_11_11_p1233 = Lambda_11_11_p1143 * Lambda_11_11_p887 - Lambda_11_11_p1149 *
      Lambda_11_11_p886 + Lambda_11_11_p1153 * Lambda_11_11_p885 + Lambda_11_11_p1156 *
      Lambda_11_11_p884 + Lambda_11_11_p1167 * Lambda_11_11_p535;
  const Real Lambda_11_11_p1234 = Lambda_11_11_p1233 + Lambda_11_11_p1172 * Lambda_11_11_p534 +
      Lambda_11_11_p1178 * Lambda_11_11_p533 + Lambda_11_11_p1184 * Lambda_11_11_p532 +
      Lambda_11_11_p1188 * Lambda_11_11_p531;
  const Real Lambda_11_11_p1235 = Lambda_11_11_p1234 + Lambda_11_11_p1190 * Lambda_11_11_p530;
  const Real Lambda_11_11_p1236 = Lambda_11_11_p850 * (Lambda_11_11_p1235 - Lambda_11_11_p1115) -
      (Lambda_11_11_p1232 - Lambda_11_11_p883 * Lambda_11_11_p1221);
  const Real Lambda_11_11_p1237 = Lambda_11_11_p1236 * Lambda_11_11_p922;
  const Real Lambda_11_11_p1238 = Lambda_11_11_p929 * Lambda_11_11_p1225 - Lambda_11_11_p932 *
      Lambda_11_11_p1224 + Lambda_11_11_p939 * Lambda_11_11_p1223 + Lambda_11_11_p942 *
      Lambda_11_11_p1222 + Lambda_11_11_p953 * Lambda_11_11_p1196;
  const Real Lambda_11_11_p1239 = Lambda_11_11_p1238 + Lambda_11_11_p958 * Lambda_11_11_p1195 +
      Lambda_11_11_p964 * Lambda_11_11_p1194 + Lambda_11_11_p970 * Lambda_11_11_p1193 +
      Lambda_11_11_p974 * Lambda_11_11_p1192;
  const Real Lambda_11_11_p1240 = Lambda_11_11_p1143 * Lambda_11_11_p1108 - Lambda_11_11_p1149 *
      Lambda_11_11_p1107 + Lambda_11_11_p1153 * Lambda_11_11_p1106 + Lambda_11_11_p1156 *
      Lambda_11_11_p1105 + Lambda_11_11_p1167 * Lambda_11_11_p1053;
  const Real Lambda_11_11_p1241 = Lambda_11_11_p1240 + Lambda_11_11_p1172 * Lambda_11_11_p1052 +
      Lambda_11_11_p1178 * Lambda_11_11_p1051 + Lambda_11_11_p1184 * Lambda_11_11_p1050 +
      Lambda_11_11_p1188 * Lambda_11_11_p1049;
  const Real Lambda_11_11_p1242 = Lambda_11_11_p1241 + Lambda_11_11_p1190 * Lambda_11_11_p1048;
  const Real Lambda_11_11_p1243 = Lambda_11_11_p1239 + Lambda_11_11_p976 * Lambda_11_11_p1191 -
      Lambda_11_11_p850 * Lambda_11_11_p1133 + Lambda_11_11_p1242 * Lambda_11_11_p849 +
      Lambda_11_11_p1065 * Lambda_11_11_p1204;
  const Real Lambda_11_11_p1244 = Lambda_11_11_p1243 + Lambda_11_11_p1075 * Lambda_11_11_p1210 +
      Lambda_11_11_p1081 * Lambda_11_11_p1214 - Lambda_11_11_p1083 * Lambda_11_11_p1216 -
      Lambda_11_11_p1085 * Lambda_11_11_p1218;
  const Real Lambda_11_11_p1245 = Lambda_11_11_p896 * Lambda_11_11_p984;
  const Real Lambda_11_11_p1246 = Lambda_11_11_p1245 + (Lambda_11_11_p1118 + Lambda_11_11_p1104);
  const Real Lambda_11_11_p1247 = Lambda_11_11_p984 * (Lambda_11_11_p1235 - Lambda_11_11_p1246) +
      (Lambda_11_11_p1244 - Lambda_11_11_p1088 * Lambda_11_11_p1221 + Lambda_11_11_p1119 *
      Lambda_11_11_p1237);
  const Real Lambda_11_11_p1248 = Lambda_11_11_p1245 - (Lambda_11_11_p1235 - Lambda_11_11_p1114) -
      Lambda_11_11_p1203 * Lambda_11_11_p543 - Lambda_11_11_p1209 * Lambda_11_11_p563 -
      Lambda_11_11_p1213 * Lambda_11_11_p656;
  const Real Lambda_11_11_p1249 = Lambda_11_11_p1248 + Lambda_11_11_p1215 * Lambda_11_11_p664 +
      Lambda_11_11_p1217 * Lambda_11_11_p675 + Lambda_11_11_p1220 * Lambda_11_11_p689 -
      Lambda_11_11_p1236 * Lambda_11_11_p923;
  const Real Lambda_11_11_p1250 = Lambda_11_11_p1249 + Lambda_11_11_p1247 * Lambda_11_11_p1137;
  const Real Lambda_11_11_p1251 = Lambda_11_11_p1247 * Lambda_11_11_p1136;
  const Real Lambda_11_11_p1252 = Lambda_11_11_p1242 - Lambda_11_11_p1132 * Lambda_11_11_p850 -
      Lambda_11_11_p1103 * Lambda_11_11_p984;
  const Real Lambda_11_11_p1253 = Lambda_11_11_p1143 * Lambda_11_11_p1225 - Lambda_11_11_p1149 *
      Lambda_11_11_p1224 + Lambda_11_11_p1153 * Lambda_11_11_p1223 + Lambda_11_11_p1156 *
      Lambda_11_11_p1222 + Lambda_11_11_p1167 * Lambda_11_11_p1196;
  const Real Lambda_11_11_p1254 = Lambda_11_11_p1253 + Lambda_11_11_p1172 * Lambda_11_11_p1195 +
      Lambda_11_11_p1178 * Lambda_11_11_p1194 + Lambda_11_11_p1184 * Lambda_11_11_p1193 +
      Lambda_11_11_p1188 * Lambda_11_11_p1192;
  const Real Lambda_11_11_p1255 = Lambda_11_11_p1230 - Lambda_11_11_p1103 * Lambda_11_11_p850 -
      Lambda_11_11_p916 * Lambda_11_11_p984;
  const Real Lambda_11_11_p1256 = Lambda_11_11_p1254 + Lambda_11_11_p1190 * Lambda_11_11_p1191 -
      Lambda_11_11_p850 * (Lambda_11_11_p1242 + Lambda_11_11_p1252) - Lambda_11_11_p984 *
      (Lambda_11_11_p1230 + Lambda_11_11_p1255);
  const Real Lambda_11_11_p1257 = Lambda_11_11_p1256 + Lambda_11_11_p1203 * Lambda_11_11_p1204 +
      Lambda_11_11_p1209 * Lambda_11_11_p1210 + Lambda_11_11_p1213 * Lambda_11_11_p1214 -
      Lambda_11_11_p1215 * Lambda_11_11_p1216;
  const Real Lambda_11_11_p1258 = Lambda_11_11_p1257 - Lambda_11_11_p1217 * Lambda_11_11_p1218 -
      Lambda_11_11_p1220 * Lambda_11_11_p1221 - Lambda_11_11_p1236 * Lambda_11_11_p1237 -
      Lambda_11_11_p1247 * Lambda_11_11_p1251;
  const Real Lambda_11_11_p1259 = 1.0 / Lambda_11_11_p1258;
  const Real Lambda_11_11_p1260 = Lambda_11_11_p1250 * Lambda_11_11_p1259;
  const Real Lambda_11_11_p1261 = Lambda_11_11_p1055 + Lambda_11_11_p1058 * Lambda_11_11_p205 -
      Lambda_11_11_p1063 * Lambda_11_11_p353;
  const Real Lambda_11_11_p1262 = Lambda_11_11_p1261 * Lambda_11_11_p450;
  const Real Lambda_11_11_p1263 = Lambda_11_11_p1069 + Lambda_11_11_p1063 * Lambda_11_11_p422 +
      Lambda_11_11_p1073 * Lambda_11_11_p205 - Lambda_11_11_p438 * Lambda_11_11_p1262;
  const Real Lambda_11_11_p1264 = Lambda_11_11_p1263 * Lambda_11_11_p562;
  const Real Lambda_11_11_p1265 = Lambda_11_11_p1079 - Lambda_11_11_p1073 * Lambda_11_11_p353 -
      Lambda_11_11_p1058 * Lambda_11_11_p422 + Lambda_11_11_p635 * Lambda_11_11_p1262 -
      Lambda_11_11_p645 * Lambda_11_11_p1264;
  const Real Lambda_11_11_p1266 = Lambda_11_11_p1265 * Lambda_11_11_p655;
  const Real Lambda_11_11_p1267 = Lambda_11_11_p1073 - Lambda_11_11_p355 * Lambda_11_11_p1262 -
      Lambda_11_11_p658 * Lambda_11_11_p1264 - Lambda_11_11_p660 * Lambda_11_11_p1266;
  const Real Lambda_11_11_p1268 = Lambda_11_11_p1267 * Lambda_11_11_p663;
  const Real Lambda_11_11_p1269 = Lambda_11_11_p1058 - Lambda_11_11_p445 * Lambda_11_11_p1262 +
      Lambda_11_11_p666 * Lambda_11_11_p1264 - Lambda_11_11_p668 * Lambda_11_11_p1266 -
      Lambda_11_11_p670 * Lambda_11_11_p1268;
  const Real Lambda_11_11_p1270 = Lambda_11_11_p1269 * Lambda_11_11_p674;
  const Real Lambda_11_11_p1271 = Lambda_11_11_p1063 - Lambda_11_11_p421 * Lambda_11_11_p1262 -
      Lambda_11_11_p677 * Lambda_11_11_p1264 - Lambda_11_11_p679 * Lambda_11_11_p1266 -
      Lambda_11_11_p681 * Lambda_11_11_p1268;
  const Real Lambda_11_11_p1272 = Lambda_11_11_p1271 - Lambda_11_11_p683 * Lambda_11_11_p1270;
  const Real Lambda_11_11_p1273 = Lambda_11_11_p1272 * Lambda_11_11_p688;
  const Real Lambda_11_11_p1274 = Lambda_11_11_p1115 - Lambda_11_11_p860 * Lambda_11_11_p1262 -
      Lambda_11_11_p870 * Lambda_11_11_p1264 - Lambda_11_11_p876 * Lambda_11_11_p1266 +
      Lambda_11_11_p878 * Lambda_11_11_p1268;
  const Real Lambda_11_11_p1275 = Lambda_11_11_p1274 + Lambda_11_11_p880 * Lambda_11_11_p1270 +
      Lambda_11_11_p883 * Lambda_11_11_p1273;
  const Real Lambda_11_11_p1276 = Lambda_11_11_p1275 * Lambda_11_11_p922;
  const Real Lambda_11_11_p1277 = Lambda_11_11_p1133 + Lambda_11_11_p1065 * Lambda_11_11_p1262 +
      Lambda_11_11_p1075 * Lambda_11_11_p1264 + Lambda_11_11_p1081 * Lambda_11_11_p1266 -
      Lambda_11_11_p1083 * Lambda_11_11_p1268;
  const Real Lambda_11_11_p1278 = Lambda_11_11_p1277 - Lambda_11_11_p1085 * Lambda_11_11_p1270 -
      Lambda_11_11_p1088 * Lambda_11_11_p1273 + Lambda_11_11_p1119 * Lambda_11_11_p1276;
  const Real Lambda_11_11_p1279 = Lambda_11_11_p1278 * Lambda_11_11_p1136;
  const Real Lambda_11_11_p1280 = Lambda_11_11_p1252 + Lambda_11_11_p1203 * Lambda_11_11_p1262 +
      Lambda_11_11_p1209 * Lambda_11_11_p1264 + Lambda_11_11_p1213 * Lambda_11_11_p1266 -
      Lambda_11_11_p1215 * Lambda_11_11_p1268;
  const Real Lambda_11_11_p1281 = Lambda_11_11_p1280 - Lambda_11_11_p1217 * Lambda_11_11_p1270 -
      Lambda_11_11_p1220 * Lambda_11_11_p1273 - Lambda_11_11_p1236 * Lambda_11_11_p1276 -
      Lambda_11_11_p1247 * Lambda_11_11_p1279;
  const Real Lambda_11_11_p1282 = Lambda_11_11_p1113 + Lambda_11_11_p1261 * Lambda_11_11_p543 +
      Lambda_11_11_p1263 * Lambda_11_11_p563 + Lambda_11_11_p1265 * Lambda_11_11_p656 -
      Lambda_11_11_p1267 * Lambda_11_11_p664;
  const Real Lambda_11_11_p1283 = Lambda_11_11_p1282 - Lambda_11_11_p1269 * Lambda_11_11_p675 -
      Lambda_11_11_p1272 * Lambda_11_11_p689 + Lambda_11_11_p1275 * Lambda_11_11_p923 -
      Lambda_11_11_p1278 * Lambda_11_11_p1137;
  const Real Lambda_11_11_p1284 = Lambda_11_11_p1283 + Lambda_11_11_p1281 * Lambda_11_11_p1260;
  const Real Lambda_11_11_p1285 = Lambda_11_11_p1281 * Lambda_11_11_p1259;
  const Real Lambda_11_11_p1286 = Lambda_11_11_p1132 + Lambda_11_11_p1261 * Lambda_11_11_p1262 +
      Lambda_11_11_p1263 * Lambda_11_11_p1264 + Lambda_11_11_p1265 * Lambda_11_11_p1266 -
      Lambda_11_11_p1267 * Lambda_11_11_p1268;
  const Real Lambda_11_11_p1287 = Lambda_11_11_p1286 - Lambda_11_11_p1269 * Lambda_11_11_p1270 -
      Lambda_11_11_p1272 * Lambda_11_11_p1273 - Lambda_11_11_p1275 * Lambda_11_11_p1276 -
      Lambda_11_11_p1278 * Lambda_11_11_p1279;
  const Real Lambda_11_11_p1288 = 1.0 / (Lambda_11_11_p1287 - Lambda_11_11_p1281 *
      Lambda_11_11_p1285);
  const Real Lambda_11_11_p1289 = Lambda_11_11_p1284 * Lambda_11_11_p1288;
  const Real Lambda_11_11_p1290 = Lambda_11_11_p848 + Lambda_11_11_p853 * Lambda_11_11_p205 -
      Lambda_11_11_p858 * Lambda_11_11_p353;
  const Real Lambda_11_11_p1291 = Lambda_11_11_p1290 * Lambda_11_11_p450;
  const Real Lambda_11_11_p1292 = Lambda_11_11_p864 + Lambda_11_11_p858 * Lambda_11_11_p422 +
      Lambda_11_11_p868 * Lambda_11_11_p205 - Lambda_11_11_p438 * Lambda_11_11_p1291;
  const Real Lambda_11_11_p1293 = Lambda_11_11_p1292 * Lambda_11_11_p562;
  const Real Lambda_11_11_p1294 = Lambda_11_11_p874 - Lambda_11_11_p868 * Lambda_11_11_p353 -
      Lambda_11_11_p853 * Lambda_11_11_p422 + Lambda_11_11_p635 * Lambda_11_11_p1291 -
      Lambda_11_11_p645 * Lambda_11_11_p1293;
  const Real Lambda_11_11_p1295 = Lambda_11_11_p1294 * Lambda_11_11_p655;
  const Real Lambda_11_11_p1296 = Lambda_11_11_p868 - Lambda_11_11_p355 * Lambda_11_11_p1291 -
      Lambda_11_11_p658 * Lambda_11_11_p1293 - Lambda_11_11_p660 * Lambda_11_11_p1295;
  const Real Lambda_11_11_p1297 = Lambda_11_11_p1296 * Lambda_11_11_p663;
  const Real Lambda_11_11_p1298 = Lambda_11_11_p853 - Lambda_11_11_p445 * Lambda_11_11_p1291 +
      Lambda_11_11_p666 * Lambda_11_11_p1293 - Lambda_11_11_p668 * Lambda_11_11_p1295 -
      Lambda_11_11_p670 * Lambda_11_11_p1297;
  const Real Lambda_11_11_p1299 = Lambda_11_11_p1298 * Lambda_11_11_p674;
  const Real Lambda_11_11_p1300 = Lambda_11_11_p858 - Lambda_11_11_p421 * Lambda_11_11_p1291 -
      Lambda_11_11_p677 * Lambda_11_11_p1293 - Lambda_11_11_p679 * Lambda_11_11_p1295 -
      Lambda_11_11_p681 * Lambda_11_11_p1297;
  const Real Lambda_11_11_p1301 = Lambda_11_11_p1300 - Lambda_11_11_p683 * Lambda_11_11_p1299;
  const Real Lambda_11_11_p1302 = Lambda_11_11_p1301 * Lambda_11_11_p688;
  const Real Lambda_11_11_p1303 = Lambda_11_11_p917 + Lambda_11_11_p860 * Lambda_11_11_p1291 +
      Lambda_11_11_p870 * Lambda_11_11_p1293 + Lambda_11_11_p876 * Lambda_11_11_p1295 -
      Lambda_11_11_p878 * Lambda_11_11_p1297;
  const Real Lambda_11_11_p1304 = Lambda_11_11_p1303 - Lambda_11_11_p880 * Lambda_11_11_p1299 -
      Lambda_11_11_p883 * Lambda_11_11_p1302;
  const Real Lambda_11_11_p1305 = Lambda_11_11_p1304 * Lambda_11_11_p922;
  const Real Lambda_11_11_p1306 = Lambda_11_11_p1246 + Lambda_11_11_p1065 * Lambda_11_11_p1291 +
      Lambda_11_11_p1075 * Lambda_11_11_p1293 + Lambda_11_11_p1081 * Lambda_11_11_p1295 -
      Lambda_11_11_p1083 * Lambda_11_11_p1297;
  const Real Lambda_11_11_p1307 = Lambda_11_11_p1306 - Lambda_11_11_p1085 * Lambda_11_11_p1299 -
      Lambda_11_11_p1088 * Lambda_11_11_p1302 - Lambda_11_11_p1119 * Lambda_11_11_p1305;
  const Real Lambda_11_11_p1308 = Lambda_11_11_p1307 * Lambda_11_11_p1136;
  const Real Lambda_11_11_p1309 = Lambda_11_11_p1255 + Lambda_11_11_p1203 * Lambda_11_11_p1291 +
      Lambda_11_11_p1209 * Lambda_11_11_p1293 + Lambda_11_11_p1213 * Lambda_11_11_p1295 -
      Lambda_11_11_p1215 * Lambda_11_11_p1297;
  const Real Lambda_11_11_p1310 = Lambda_11_11_p1309 - Lambda_11_11_p1217 * Lambda_11_11_p1299 -
      Lambda_11_11_p1220 * Lambda_11_11_p1302 + Lambda_11_11_p1236 * Lambda_11_11_p1305 -
      Lambda_11_11_p1247 * Lambda_11_11_p1308;
  const Real Lambda_11_11_p1311 = Lambda_11_11_p1310 * Lambda_11_11_p1259;
  const Real Lambda_11_11_p1312 = Lambda_11_11_p1103 + Lambda_11_11_p1261 * Lambda_11_11_p1291 +
      Lambda_11_11_p1263 * Lambda_11_11_p1293 + Lambda_11_11_p1265 * Lambda_11_11_p1295 -
      Lambda_11_11_p1267 * Lambda_11_11_p1297;
  const Real Lambda_11_11_p1313 = Lambda_11_11_p1312 - Lambda_11_11_p1269 * Lambda_11_11_p1299 -
      Lambda_11_11_p1272 * Lambda_11_11_p1302 + Lambda_11_11_p1275 * Lambda_11_11_p1305 -
      Lambda_11_11_p1278 * Lambda_11_11_p1308;
  const Real Lambda_11_11_p1314 = Lambda_11_11_p1313 - Lambda_11_11_p1281 * Lambda_11_11_p1311;
  const Real Lambda_11_11_p1315 = Lambda_11_11_p896 + Lambda_11_11_p1290 * Lambda_11_11_p543 +
      Lambda_11_11_p1292 * Lambda_11_11_p563 + Lambda_11_11_p1294 * Lambda_11_11_p656 -
      Lambda_11_11_p1296 * Lambda_11_11_p664;
  const Real Lambda_11_11_p1316 = Lambda_11_11_p1315 - Lambda_11_11_p1298 * Lambda_11_11_p675 -
      Lambda_11_11_p1301 * Lambda_11_11_p689 - Lambda_11_11_p1304 * Lambda_11_11_p923 -
      Lambda_11_11_p1307 * Lambda_11_11_p1137;
  const Real Lambda_11_11_p1317 = Lambda_11_11_p1316 + Lambda_11_11_p1310 * Lambda_11_11_p1260 -
      Lambda_11_11_p1314 * Lambda_11_11_p1289;
  const Real Lambda_11_11_p1318 = Lambda_11_11_p1314 * Lambda_11_11_p1288;
  const Real Lambda_11_11_p1319 = Lambda_11_11_p916 + Lambda_11_11_p1290 * Lambda_11_11_p1291 +
      Lambda_11_11_p1292 * Lambda_11_11_p1293 + Lambda_11_11_p1294 * Lambda_11_11_p1295 -
      Lambda_11_11_p1296 * Lambda_11_11_p1297;
  const Real Lambda_11_11_p1320 = Lambda_11_11_p1319 - Lambda_11_11_p1298 * Lambda_11_11_p1299 -
      Lambda_11_11_p1301 * Lambda_11_11_p1302 - Lambda_11_11_p1304 * Lambda_11_11_p1305 -
      Lambda_11_11_p1307 * Lambda_11_11_p1308;
  const Real Lambda_11_11_p1321 = 1.0 / (Lambda_11_11_p1320 - Lambda_11_11_p1310 *
      Lambda_11_11_p1311 - Lambda_11_11_p1314 * Lambda_11_11_p1318);
  const Real Lambda_11_11_p1322 = Lambda_11_11_p1317 * Lambda_11_11_p1321;
  const Real Lambda_11_11_p1323 = Lambda_11_11_p899 + Lambda_11_11_p542 * Lambda_11_11_p543 +
      Lambda_11_11_p548 * Lambda_11_11_p563 + Lambda_11_11_p648 * Lambda_11_11_p656 -
      Lambda_11_11_p661 * Lambda_11_11_p664;
  const Real Lambda_11_11_p1324 = Lambda_11_11_p1323 - Lambda_11_11_p671 * Lambda_11_11_p675 -
      Lambda_11_11_p685 * Lambda_11_11_p689 - Lambda_11_11_p902 * Lambda_11_11_p923 -
      Lambda_11_11_p1122 * Lambda_11_11_p1137;
  const Real Lambda_11_11 = 1.0 / (Lambda_11_11_p1324 - Lambda_11_11_p1250 * Lambda_11_11_p1260 -
      Lambda_11_11_p1284 * Lambda_11_11_p1289 - Lambda_11_11_p1317 * Lambda_11_11_p1322);
  Lambda[143] = Lambda_11_11;
  const Real Lambda_0_11_p1 = Lambda_11_11_p636 + Lambda_11_11_p549 * Lambda_11_11_p649;
  const Real Lambda_0_11_p2 = Lambda_11_11_p657 - Lambda_11_11_p549 * Lambda_11_11_p659 +
      Lambda_11_11_p662 * Lambda_0_11_p1;
  const Real Lambda_0_11_p3 = Lambda_11_11_p665 + Lambda_11_11_p549 * Lambda_11_11_p667 +
      Lambda_11_11_p669 * Lambda_0_11_p1 - Lambda_11_11_p672 * Lambda_0_11_p2;
  const Real Lambda_0_11_p4 = Lambda_11_11_p676 - Lambda_11_11_p549 * Lambda_11_11_p678 +
      Lambda_11_11_p680 * Lambda_0_11_p1 - Lambda_11_11_p682 * Lambda_0_11_p2 - Lambda_11_11_p686 *
      Lambda_0_11_p3;
  const Real Lambda_0_11_p5 = Lambda_11_11_p861 - Lambda_11_11_p549 * Lambda_11_11_p871 +
      Lambda_11_11_p877 * Lambda_0_11_p1 + Lambda_11_11_p879 * Lambda_0_11_p2 + Lambda_11_11_p881 *
      Lambda_0_11_p3;
  const Real Lambda_0_11_p6 = Lambda_0_11_p5 + Lambda_11_11_p903 * Lambda_0_11_p4;
  const Real Lambda_0_11_p7 = Lambda_11_11_p1066 - Lambda_11_11_p549 * Lambda_11_11_p1076 +
      Lambda_11_11_p1082 * Lambda_0_11_p1 + Lambda_11_11_p1084 * Lambda_0_11_p2 +
      Lambda_11_11_p1086 * Lambda_0_11_p3;
  const Real Lambda_0_11_p8 = Lambda_0_11_p7 + Lambda_11_11_p1089 * Lambda_0_11_p4 -
      Lambda_11_11_p1123 * Lambda_0_11_p6;
  const Real Lambda_0_11_p9 = Lambda_11_11_p1204 - Lambda_11_11_p549 * Lambda_11_11_p1210 +
      Lambda_11_11_p1214 * Lambda_0_11_p1 + Lambda_11_11_p1216 * Lambda_0_11_p2 +
      Lambda_11_11_p1218 * Lambda_0_11_p3;
  const Real Lambda_0_11_p10 = Lambda_0_11_p9 + Lambda_11_11_p1221 * Lambda_0_11_p4 +
      Lambda_11_11_p1237 * Lambda_0_11_p6 - Lambda_11_11_p1251 * Lambda_0_11_p8;
  const Real Lambda_0_11_p11 = Lambda_11_11_p1262 - Lambda_11_11_p549 * Lambda_11_11_p1264 +
      Lambda_11_11_p1266 * Lambda_0_11_p1 + Lambda_11_11_p1268 * Lambda_0_11_p2 +
      Lambda_11_11_p1270 * Lambda_0_11_p3;
  const Real Lambda_0_11_p12 = Lambda_0_11_p11 + Lambda_11_11_p1273 * Lambda_0_11_p4 +
      Lambda_11_11_p1276 * Lambda_0_11_p6 - Lambda_11_11_p1279 * Lambda_0_11_p8 -
      Lambda_11_11_p1285 * Lambda_0_11_p10;
  const Real Lambda_0_11_p13 = Lambda_11_11_p1291 - Lambda_11_11_p549 * Lambda_11_11_p1293 +
      Lambda_11_11_p1295 * Lambda_0_11_p1 + Lambda_11_11_p1297 * Lambda_0_11_p2 +
      Lambda_11_11_p1299 * Lambda_0_11_p3;
  const Real Lambda_0_11_p14 = Lambda_0_11_p13 + Lambda_11_11_p1302 * Lambda_0_11_p4 -
      Lambda_11_11_p1305 * Lambda_0_11_p6 - Lambda_11_11_p1308 * Lambda_0_11_p8 -
      Lambda_11_11_p1311 * Lambda_0_11_p10;
  const Real Lambda_0_11_p15 = Lambda_0_11_p14 - Lambda_11_11_p1318 * Lambda_0_11_p12;
  const Real Lambda_0_11_p16 = Lambda_11_11_p543 - Lambda_11_11_p549 * Lambda_11_11_p563 +
      Lambda_11_11_p656 * Lambda_0_11_p1 + Lambda_11_11_p664 * Lambda_0_11_p2 + Lambda_11_11_p675 *
      Lambda_0_11_p3;
  const Real Lambda_0_11_p17 = Lambda_0_11_p16 + Lambda_11_11_p689 * Lambda_0_11_p4 -
      Lambda_11_11_p923 * Lambda_0_11_p6 - Lambda_11_11_p1137 * Lambda_0_11_p8 +
      Lambda_11_11_p1260 * Lambda_0_11_p10;
  const Real Lambda_0_11_p18 = Lambda_0_11_p17 - Lambda_11_11_p1289 * Lambda_0_11_p12 -
      Lambda_11_11_p1322 * Lambda_0_11_p15;
  const Real Lambda_0_11 = Lambda_11_11 * Lambda_0_11_p18;
  Lambda[11] = Lambda_0_11;
  Lambda[132] = Lambda_0_11;
  const Real Lambda_0_0_p1 = Lambda_11_11_p1321 * Lambda_0_11_p15;
  const Real Lambda_0_0_p2 = Lambda_11_11_p1288 * Lambda_0_11_p12;
  const Real Lambda_0_0_p3 = Lambda_11_11_p1259 * Lambda_0_11_p10;
  const Real Lambda_0_0_p4 = Lambda_11_11_p1136 * Lambda_0_11_p8;
  const Real Lambda_0_0_p5 = Lambda_11_11_p922 * Lambda_0_11_p6;
  const Real Lambda_0_0_p6 = Lambda_11_11_p688 * Lambda_0_11_p4;
  const Real Lambda_0_0_p7 = Lambda_11_11_p674 * Lambda_0_11_p3;
  const Real Lambda_0_0_p8 = Lambda_11_11_p663 * Lambda_0_11_p2;
  const Real Lambda_0_0_p9 = Lambda_11_11_p655 * Lambda_0_11_p1;
  const Real Lambda_0_0_p10 = Lambda_11_11_p549 * Lambda_11_11_p562;
  const Real Lambda_0_0_p11 = Lambda_11_11_p450 + Lambda_11_11_p549 * Lambda_0_0_p10 +
      Lambda_0_11_p1 * Lambda_0_0_p9 - Lambda_0_11_p2 * Lambda_0_0_p8 - Lambda_0_11_p3 *
      Lambda_0_0_p7;
  const Real Lambda_0_0_p12 = Lambda_0_0_p11 - Lambda_0_11_p4 * Lambda_0_0_p6 - Lambda_0_11_p6 *
      Lambda_0_0_p5 - Lambda_0_11_p8 * Lambda_0_0_p4 - Lambda_0_11_p10 * Lambda_0_0_p3;
  Lambda[0] = -(Lambda_0_0_p12 - Lambda_0_11_p12 * Lambda_0_0_p2 - Lambda_0_11_p15 * Lambda_0_0_p1 -
      Lambda_0_11_p18 * Lambda_0_11);
  const Real Lambda_1_11_p1 = Lambda_11_11_p659 - Lambda_11_11_p649 * Lambda_11_11_p662;
  const Real Lambda_1_11_p2 = Lambda_11_11_p667 + Lambda_11_11_p649 * Lambda_11_11_p669 +
      Lambda_11_11_p672 * Lambda_1_11_p1;
  const Real Lambda_1_11_p3 = Lambda_11_11_p678 - Lambda_11_11_p649 * Lambda_11_11_p680 -
      Lambda_11_11_p682 * Lambda_1_11_p1 + Lambda_11_11_p686 * Lambda_1_11_p2;
  const Real Lambda_1_11_p4 = Lambda_11_11_p871 - Lambda_11_11_p649 * Lambda_11_11_p877 +
      Lambda_11_11_p879 * Lambda_1_11_p1 - Lambda_11_11_p881 * Lambda_1_11_p2 + Lambda_11_11_p903 *
      Lambda_1_11_p3;
  const Real Lambda_1_11_p5 = Lambda_11_11_p1076 - Lambda_11_11_p649 * Lambda_11_11_p1082 +
      Lambda_11_11_p1084 * Lambda_1_11_p1 - Lambda_11_11_p1086 * Lambda_1_11_p2 +
      Lambda_11_11_p1089 * Lambda_1_11_p3;
  const Real Lambda_1_11_p6 = Lambda_1_11_p5 - Lambda_11_11_p1123 * Lambda_1_11_p4;
  const Real Lambda_1_11_p7 = Lambda_11_11_p1210 - Lambda_11_11_p649 * Lambda_11_11_p1214 +
      Lambda_11_11_p1216 * Lambda_1_11_p1 - Lambda_11_11_p1218 * Lambda_1_11_p2 +
      Lambda_11_11_p1221 * Lambda_1_11_p3;
  const Real Lambda_1_11_p8 = Lambda_1_11_p7 + Lambda_11_11_p1237 * Lambda_1_11_p4 -
      Lambda_11_11_p1251 * Lambda_1_11_p6;
  const Real Lambda_1_11_p9 = Lambda_11_11_p1264 - Lambda_11_11_p649 * Lambda_11_11_p1266 +
      Lambda_11_11_p1268 * Lambda_1_11_p1 - Lambda_11_11_p1270 * Lambda_1_11_p2 +
      Lambda_11_11_p1273 * Lambda_1_11_p3;
  const Real Lambda_1_11_p10 = Lambda_1_11_p9 + Lambda_11_11_p1276 * Lambda_1_11_p4 -
      Lambda_11_11_p1279 * Lambda_1_11_p6 - Lambda_11_11_p1285 * Lambda_1_11_p8;
  const Real Lambda_1_11_p11 = Lambda_11_11_p1293 - Lambda_11_11_p649 * Lambda_11_11_p1295 +
      Lambda_11_11_p1297 * Lambda_1_11_p1 - Lambda_11_11_p1299 * Lambda_1_11_p2 +
      Lambda_11_11_p1302 * Lambda_1_11_p3;
  const Real Lambda_1_11_p12 = Lambda_1_11_p11 - Lambda_11_11_p1305 * Lambda_1_11_p4 -
      Lambda_11_11_p1308 * Lambda_1_11_p6 - Lambda_11_11_p1311 * Lambda_1_11_p8 -
      Lambda_11_11_p1318 * Lambda_1_11_p10;
  const Real Lambda_1_11_p13 = Lambda_11_11_p563 - Lambda_11_11_p649 * Lambda_11_11_p656 +
      Lambda_11_11_p664 * Lambda_1_11_p1 - Lambda_11_11_p675 * Lambda_1_11_p2 + Lambda_11_11_p689 *
      Lambda_1_11_p3;
  const Real Lambda_1_11_p14 = Lambda_1_11_p13 - Lambda_11_11_p923 * Lambda_1_11_p4 -
      Lambda_11_11_p1137 * Lambda_1_11_p6 + Lambda_11_11_p1260 * Lambda_1_11_p8 -
      Lambda_11_11_p1289 * Lambda_1_11_p10;
  const Real Lambda_1_11_p15 = Lambda_1_11_p14 - Lambda_11_11_p1322 * Lambda_1_11_p12;
  const Real Lambda_1_11 = Lambda_11_11 * Lambda_1_11_p15;
  Lambda[23] = -Lambda_1_11;
  Lambda[133] = -Lambda_1_11;
  const Real Lambda_0_1_p1 = Lambda_11_11_p1321 * Lambda_1_11_p12;
  const Real Lambda_0_1_p2 = Lambda_11_11_p1288 * Lambda_1_11_p10;
  const Real Lambda_0_1_p3 = Lambda_11_11_p1259 * Lambda_1_11_p8;
  const Real Lambda_0_1_p4 = Lambda_11_11_p1136 * Lambda_1_11_p6;
  const Real Lambda_0_1_p5 = Lambda_11_11_p922 * Lambda_1_11_p4;
  const Real Lambda_0_1_p6 = Lambda_11_11_p688 * Lambda_1_11_p3;
  const Real Lambda_0_1_p7 = Lambda_11_11_p674 * Lambda_1_11_p2;
  const Real Lambda_0_1_p8 = Lambda_11_11_p663 * Lambda_1_11_p1;
  const Real Lambda_0_1_p9 = Lambda_11_11_p649 * Lambda_11_11_p655;
  const Real Lambda_0_1_p10 = Lambda_0_0_p10 + Lambda_0_11_p1 * Lambda_0_1_p9 + Lambda_0_11_p2 *
      Lambda_0_1_p8 - Lambda_0_11_p3 * Lambda_0_1_p7 + Lambda_0_11_p4 * Lambda_0_1_p6;
  const Real Lambda_0_1_p11 = Lambda_0_1_p10 + Lambda_0_11_p6 * Lambda_0_1_p5 + Lambda_0_11_p8 *
      Lambda_0_1_p4 + Lambda_0_11_p10 * Lambda_0_1_p3 + Lambda_0_11_p12 * Lambda_0_1_p2;
  const Real Lambda_0_1 = Lambda_0_1_p11 + Lambda_0_11_p15 * Lambda_0_1_p1 + Lambda_0_11_p18 *
      Lambda_1_11;
  Lambda[1] = -Lambda_0_1;
  Lambda[12] = -Lambda_0_1;
  const Real Lambda_2_11_p1 = Lambda_11_11_p669 - Lambda_11_11_p662 * Lambda_11_11_p672;
  const Real Lambda_2_11_p2 = Lambda_11_11_p680 - Lambda_11_11_p662 * Lambda_11_11_p682 -
      Lambda_11_11_p686 * Lambda_2_11_p1;
  const Real Lambda_2_11_p3 = Lambda_11_11_p877 + Lambda_11_11_p662 * Lambda_11_11_p879 +
      Lambda_11_11_p881 * Lambda_2_11_p1 + Lambda_11_11_p903 * Lambda_2_11_p2;
  const Real Lambda_2_11_p4 = Lambda_11_11_p1082 + Lambda_11_11_p662 * Lambda_11_11_p1084 +
      Lambda_11_11_p1086 * Lambda_2_11_p1 + Lambda_11_11_p1089 * Lambda_2_11_p2 -
      Lambda_11_11_p1123 * Lambda_2_11_p3;
  const Real Lambda_2_11_p5 = Lambda_11_11_p1214 + Lambda_11_11_p662 * Lambda_11_11_p1216 +
      Lambda_11_11_p1218 * Lambda_2_11_p1 + Lambda_11_11_p1221 * Lambda_2_11_p2 +
      Lambda_11_11_p1237 * Lambda_2_11_p3;
  const Real Lambda_2_11_p6 = Lambda_2_11_p5 - Lambda_11_11_p1251 * Lambda_2_11_p4;
  const Real Lambda_2_11_p7 = Lambda_11_11_p1266 + Lambda_11_11_p662 * Lambda_11_11_p1268 +
      Lambda_11_11_p1270 * Lambda_2_11_p1 + Lambda_11_11_p1273 * Lambda_2_11_p2 +
      Lambda_11_11_p1276 * Lambda_2_11_p3;
  const Real Lambda_2_11_p8 = Lambda_2_11_p7 - Lambda_11_11_p1279 * Lambda_2_11_p4 -
      Lambda_11_11_p1285 * Lambda_2_11_p6;
  const Real Lambda_2_11_p9 = Lambda_11_11_p1295 + Lambda_11_11_p662 * Lambda_11_11_p1297 +
      Lambda_11_11_p1299 * Lambda_2_11_p1 + Lambda_11_11_p1302 * Lambda_2_11_p2 -
      Lambda_11_11_p1305 * Lambda_2_11_p3;
  const Real Lambda_2_11_p10 = Lambda_2_11_p9 - Lambda_11_11_p1308 * Lambda_2_11_p4 -
      Lambda_11_11_p1311 * Lambda_2_11_p6 - Lambda_11_11_p1318 * Lambda_2_11_p8;
  const Real Lambda_2_11_p11 = Lambda_11_11_p656 + Lambda_11_11_p662 * Lambda_11_11_p664 +
      Lambda_11_11_p675 * Lambda_2_11_p1 + Lambda_11_11_p689 * Lambda_2_11_p2 - Lambda_11_11_p923 *
      Lambda_2_11_p3;
  const Real Lambda_2_11_p12 = Lambda_2_11_p11 - Lambda_11_11_p1137 * Lambda_2_11_p4 +
      Lambda_11_11_p1260 * Lambda_2_11_p6 - Lambda_11_11_p1289 * Lambda_2_11_p8 -
      Lambda_11_11_p1322 * Lambda_2_11_p10;
  const Real Lambda_2_11 = Lambda_11_11 * Lambda_2_11_p12;
  Lambda[35] = -Lambda_2_11;
  Lambda[134] = -Lambda_2_11;
  const Real Lambda_0_2_p1 = Lambda_11_11_p1321 * Lambda_2_11_p10;
  const Real Lambda_0_2_p2 = Lambda_11_11_p1288 * Lambda_2_11_p8;
  const Real Lambda_0_2_p3 = Lambda_11_11_p1259 * Lambda_2_11_p6;
  const Real Lambda_0_2_p4 = Lambda_11_11_p1136 * Lambda_2_11_p4;
  const Real Lambda_0_2_p5 = Lambda_11_11_p922 * Lambda_2_11_p3;
  const Real Lambda_0_2_p6 = Lambda_11_11_p688 * Lambda_2_11_p2;
  const Real Lambda_0_2_p7 = Lambda_11_11_p674 * Lambda_2_11_p1;
  const Real Lambda_0_2_p8 = Lambda_11_11_p662 * Lambda_11_11_p663;
  const Real Lambda_0_2_p9 = Lambda_0_0_p9 - Lambda_0_11_p2 * Lambda_0_2_p8 - Lambda_0_11_p3 *
      Lambda_0_2_p7 - Lambda_0_11_p4 * Lambda_0_2_p6 - Lambda_0_11_p6 * Lambda_0_2_p5;
  const Real Lambda_0_2_p10 = Lambda_0_2_p9 - Lambda_0_11_p8 * Lambda_0_2_p4 - Lambda_0_11_p10 *
      Lambda_0_2_p3 - Lambda_0_11_p12 * Lambda_0_2_p2 - Lambda_0_11_p15 * Lambda_0_2_p1;
  const Real Lambda_0_2 = Lambda_0_2_p10 - Lambda_0_11_p18 * Lambda_2_11;
  Lambda[2] = Lambda_0_2;
  Lambda[24] = Lambda_0_2;
  const Real Lambda_3_11_p1 = Lambda_11_11_p682 - Lambda_11_11_p672 * Lambda_11_11_p686;
  const Real Lambda_3_11_p2 = Lambda_11_11_p879 - Lambda_11_11_p672 * Lambda_11_11_p881 -
      Lambda_11_11_p903 * Lambda_3_11_p1;
  const Real Lambda_3_11_p3 = Lambda_11_11_p1084 - Lambda_11_11_p672 * Lambda_11_11_p1086 -
      Lambda_11_11_p1089 * Lambda_3_11_p1 - Lambda_11_11_p1123 * Lambda_3_11_p2;
  const Real Lambda_3_11_p4 = Lambda_11_11_p1216 - Lambda_11_11_p672 * Lambda_11_11_p1218 -
      Lambda_11_11_p1221 * Lambda_3_11_p1 + Lambda_11_11_p1237 * Lambda_3_11_p2 -
      Lambda_11_11_p1251 * Lambda_3_11_p3;
  const Real Lambda_3_11_p5 = Lambda_11_11_p1268 - Lambda_11_11_p672 * Lambda_11_11_p1270 -
      Lambda_11_11_p1273 * Lambda_3_11_p1 + Lambda_11_11_p1276 * Lambda_3_11_p2 -
      Lambda_11_11_p1279 * Lambda_3_11_p3;
  const Real Lambda_3_11_p6 = Lambda_3_11_p5 - Lambda_11_11_p1285 * Lambda_3_11_p4;
  const Real Lambda_3_11_p7 = Lambda_11_11_p1297 - Lambda_11_11_p672 * Lambda_11_11_p1299 -
      Lambda_11_11_p1302 * Lambda_3_11_p1 - Lambda_11_11_p1305 * Lambda_3_11_p2 -
      Lambda_11_11_p1308 * Lambda_3_11_p3;
  const Real Lambda_3_11_p8 = Lambda_3_11_p7 - Lambda_11_11_p1311 * Lambda_3_11_p4 -
      Lambda_11_11_p1318 * Lambda_3_11_p6;
  const Real Lambda_3_11_p9 = Lambda_11_11_p664 - Lambda_11_11_p672 * Lambda_11_11_p675 -
      Lambda_11_11_p689 * Lambda_3_11_p1 - Lambda_11_11_p923 * Lambda_3_11_p2 - Lambda_11_11_p1137 *
      Lambda_3_11_p3;
  const Real Lambda_3_11_p10 = Lambda_3_11_p9 + Lambda_11_11_p1260 * Lambda_3_11_p4 -
      Lambda_11_11_p1289 * Lambda_3_11_p6 - Lambda_11_11_p1322 * Lambda_3_11_p8;
  const Real Lambda_3_11 = Lambda_11_11 * Lambda_3_11_p10;
  Lambda[47] = Lambda_3_11;
  Lambda[135] = Lambda_3_11;
  const Real Lambda_0_3_p1 = Lambda_11_11_p1321 * Lambda_3_11_p8;
  const Real Lambda_0_3_p2 = Lambda_11_11_p1288 * Lambda_3_11_p6;
  const Real Lambda_0_3_p3 = Lambda_11_11_p1259 * Lambda_3_11_p4;
  const Real Lambda_0_3_p4 = Lambda_11_11_p1136 * Lambda_3_11_p3;
  const Real Lambda_0_3_p5 = Lambda_11_11_p922 * Lambda_3_11_p2;
  const Real Lambda_0_3_p6 = Lambda_11_11_p688 * Lambda_3_11_p1;
  const Real Lambda_0_3_p7 = Lambda_11_11_p672 * Lambda_11_11_p674;
  const Real Lambda_0_3_p8 = Lambda_0_0_p8 - Lambda_0_11_p3 * Lambda_0_3_p7 - Lambda_0_11_p4 *
      Lambda_0_3_p6 + Lambda_0_11_p6 * Lambda_0_3_p5 + Lambda_0_11_p8 * Lambda_0_3_p4;
  const Real Lambda_0_3 = Lambda_0_3_p8 + Lambda_0_11_p10 * Lambda_0_3_p3 + Lambda_0_11_p12 *
      Lambda_0_3_p2 + Lambda_0_11_p15 * Lambda_0_3_p1 + Lambda_0_11_p18 * Lambda_3_11;
  Lambda[3] = Lambda_0_3;
  Lambda[36] = Lambda_0_3;
  const Real Lambda_4_11_p1 = Lambda_11_11_p881 - Lambda_11_11_p686 * Lambda_11_11_p903;
  const Real Lambda_4_11_p2 = Lambda_11_11_p1086 - Lambda_11_11_p686 * Lambda_11_11_p1089 -
      Lambda_11_11_p1123 * Lambda_4_11_p1;
  const Real Lambda_4_11_p3 = Lambda_11_11_p1218 - Lambda_11_11_p686 * Lambda_11_11_p1221 +
      Lambda_11_11_p1237 * Lambda_4_11_p1 - Lambda_11_11_p1251 * Lambda_4_11_p2;
  const Real Lambda_4_11_p4 = Lambda_11_11_p1270 - Lambda_11_11_p686 * Lambda_11_11_p1273 +
      Lambda_11_11_p1276 * Lambda_4_11_p1 - Lambda_11_11_p1279 * Lambda_4_11_p2 -
      Lambda_11_11_p1285 * Lambda_4_11_p3;
  const Real Lambda_4_11_p5 = Lambda_11_11_p1299 - Lambda_11_11_p686 * Lambda_11_11_p1302 -
      Lambda_11_11_p1305 * Lambda_4_11_p1 - Lambda_11_11_p1308 * Lambda_4_11_p2 -
      Lambda_11_11_p1311 * Lambda_4_11_p3;
  const Real Lambda_4_11_p6 = Lambda_4_11_p5 - Lambda_11_11_p1318 * Lambda_4_11_p4;
  const Real Lambda_4_11_p7 = Lambda_11_11_p675 - Lambda_11_11_p686 * Lambda_11_11_p689 -
      Lambda_11_11_p923 * Lambda_4_11_p1 - Lambda_11_11_p1137 * Lambda_4_11_p2 +
      Lambda_11_11_p1260 * Lambda_4_11_p3;
  const Real Lambda_4_11_p8 = Lambda_4_11_p7 - Lambda_11_11_p1289 * Lambda_4_11_p4 -
      Lambda_11_11_p1322 * Lambda_4_11_p6;
  const Real Lambda_4_11 = Lambda_11_11 * Lambda_4_11_p8;
  Lambda[59] = Lambda_4_11;
  Lambda[136] = Lambda_4_11;
  const Real Lambda_0_4_p1 = Lambda_11_11_p1321 * Lambda_4_11_p6;
  const Real Lambda_0_4_p2 = Lambda_11_11_p1288 * Lambda_4_11_p4;
  const Real Lambda_0_4_p3 = Lambda_11_11_p1259 * Lambda_4_11_p3;
  const Real Lambda_0_4_p4 = Lambda_11_11_p1136 * Lambda_4_11_p2;
  const Real Lambda_0_4_p5 = Lambda_11_11_p922 * Lambda_4_11_p1;
  const Real Lambda_0_4_p6 = Lambda_11_11_p686 * Lambda_11_11_p688;
  const Real Lambda_0_4_p7 = Lambda_0_0_p7 - Lambda_0_11_p4 * Lambda_0_4_p6 + Lambda_0_11_p6 *
      Lambda_0_4_p5 + Lambda_0_11_p8 * Lambda_0_4_p4 + Lambda_0_11_p10 * Lambda_0_4_p3;
  const Real Lambda_0_4 = Lambda_0_4_p7 + Lambda_0_11_p12 * Lambda_0_4_p2 + Lambda_0_11_p15 *
      Lambda_0_4_p1 + Lambda_0_11_p18 * Lambda_4_11;
  Lambda[4] = Lambda_0_4;
  Lambda[48] = Lambda_0_4;
  const Real Lambda_5_11_p1 = Lambda_11_11_p1089 - Lambda_11_11_p903 * Lambda_11_11_p1123;
  const Real Lambda_5_11_p2 = Lambda_11_11_p1221 + Lambda_11_11_p903 * Lambda_11_11_p1237 -
      Lambda_11_11_p1251 * Lambda_5_11_p1;
  const Real Lambda_5_11_p3 = Lambda_11_11_p1273 + Lambda_11_11_p903 * Lambda_11_11_p1276 -
      Lambda_11_11_p1279 * Lambda_5_11_p1 - Lambda_11_11_p1285 * Lambda_5_11_p2;
  const Real Lambda_5_11_p4 = Lambda_11_11_p1302 - Lambda_11_11_p903 * Lambda_11_11_p1305 -
      Lambda_11_11_p1308 * Lambda_5_11_p1 - Lambda_11_11_p1311 * Lambda_5_11_p2 -
      Lambda_11_11_p1318 * Lambda_5_11_p3;
  const Real Lambda_5_11_p5 = Lambda_11_11_p689 - Lambda_11_11_p903 * Lambda_11_11_p923 -
      Lambda_11_11_p1137 * Lambda_5_11_p1 + Lambda_11_11_p1260 * Lambda_5_11_p2 -
      Lambda_11_11_p1289 * Lambda_5_11_p3;
  const Real Lambda_5_11_p6 = Lambda_5_11_p5 - Lambda_11_11_p1322 * Lambda_5_11_p4;
  const Real Lambda_5_11 = Lambda_11_11 * Lambda_5_11_p6;
  Lambda[71] = Lambda_5_11;
  Lambda[137] = Lambda_5_11;
  const Real Lambda_0_5_p1 = Lambda_11_11_p1321 * Lambda_5_11_p4;
  const Real Lambda_0_5_p2 = Lambda_11_11_p1288 * Lambda_5_11_p3;
  const Real Lambda_0_5_p3 = Lambda_11_11_p1259 * Lambda_5_11_p2;
  const Real Lambda_0_5_p4 = Lambda_11_11_p1136 * Lambda_5_11_p1;
  const Real Lambda_0_5_p5 = Lambda_11_11_p903 * Lambda_11_11_p922;
  const Real Lambda_0_5_p6 = Lambda_0_0_p6 + Lambda_0_11_p6 * Lambda_0_5_p5 + Lambda_0_11_p8 *
      Lambda_0_5_p4 + Lambda_0_11_p10 * Lambda_0_5_p3 + Lambda_0_11_p12 * Lambda_0_5_p2;
  const Real Lambda_0_5 = Lambda_0_5_p6 + Lambda_0_11_p15 * Lambda_0_5_p1 + Lambda_0_11_p18 *
      Lambda_5_11;
  Lambda[5] = Lambda_0_5;
  Lambda[60] = Lambda_0_5;
  const Real Lambda_6_11_p1 = Lambda_11_11_p1237 + Lambda_11_11_p1123 * Lambda_11_11_p1251;
  const Real Lambda_6_11_p2 = Lambda_11_11_p1276 + Lambda_11_11_p1123 * Lambda_11_11_p1279 -
      Lambda_11_11_p1285 * Lambda_6_11_p1;
  const Real Lambda_6_11_p3 = Lambda_11_11_p1305 - Lambda_11_11_p1123 * Lambda_11_11_p1308 +
      Lambda_11_11_p1311 * Lambda_6_11_p1 + Lambda_11_11_p1318 * Lambda_6_11_p2;
  const Real Lambda_6_11_p4 = Lambda_11_11_p923 - Lambda_11_11_p1123 * Lambda_11_11_p1137 -
      Lambda_11_11_p1260 * Lambda_6_11_p1 + Lambda_11_11_p1289 * Lambda_6_11_p2 -
      Lambda_11_11_p1322 * Lambda_6_11_p3;
  const Real Lambda_6_11 = Lambda_11_11 * Lambda_6_11_p4;
  Lambda[83] = Lambda_6_11;
  Lambda[138] = Lambda_6_11;
  const Real Lambda_0_6_p1 = Lambda_11_11_p1321 * Lambda_6_11_p3;
  const Real Lambda_0_6_p2 = Lambda_11_11_p1288 * Lambda_6_11_p2;
  const Real Lambda_0_6_p3 = Lambda_11_11_p1259 * Lambda_6_11_p1;
  const Real Lambda_0_6_p4 = Lambda_11_11_p1123 * Lambda_11_11_p1136;
  const Real Lambda_0_6_p5 = Lambda_0_0_p5 - Lambda_0_11_p8 * Lambda_0_6_p4 + Lambda_0_11_p10 *
      Lambda_0_6_p3 + Lambda_0_11_p12 * Lambda_0_6_p2 - Lambda_0_11_p15 * Lambda_0_6_p1;
  const Real Lambda_0_6 = Lambda_0_6_p5 - Lambda_0_11_p18 * Lambda_6_11;
  Lambda[6] = -Lambda_0_6;
  Lambda[72] = -Lambda_0_6;
  const Real Lambda_7_11_p1 = Lambda_11_11_p1279 - Lambda_11_11_p1251 * Lambda_11_11_p1285;
  const Real Lambda_7_11_p2 = Lambda_11_11_p1308 - Lambda_11_11_p1251 * Lambda_11_11_p1311 -
      Lambda_11_11_p1318 * Lambda_7_11_p1;
  const Real Lambda_7_11_p3 = Lambda_11_11_p1137 + Lambda_11_11_p1251 * Lambda_11_11_p1260 -
      Lambda_11_11_p1289 * Lambda_7_11_p1 - Lambda_11_11_p1322 * Lambda_7_11_p2;
  const Real Lambda_7_11 = Lambda_11_11 * Lambda_7_11_p3;
  Lambda[95] = -Lambda_7_11;
  Lambda[139] = -Lambda_7_11;
  const Real Lambda_0_7_p1 = Lambda_11_11_p1321 * Lambda_7_11_p2;
  const Real Lambda_0_7_p2 = Lambda_11_11_p1288 * Lambda_7_11_p1;
  const Real Lambda_0_7_p3 = Lambda_11_11_p1251 * Lambda_11_11_p1259;
  const Real Lambda_0_7 = Lambda_0_0_p4 - Lambda_0_11_p10 * Lambda_0_7_p3 - Lambda_0_11_p12 *
      Lambda_0_7_p2 - Lambda_0_11_p15 * Lambda_0_7_p1 - Lambda_0_11_p18 * Lambda_7_11;
  Lambda[7] = Lambda_0_7;
  Lambda[84] = Lambda_0_7;
  const Real Lambda_8_11_p1 = Lambda_11_11_p1311 - Lambda_11_11_p1285 * Lambda_11_11_p1318;
  const Real Lambda_8_11_p2 = Lambda_11_11_p1260 + Lambda_11_11_p1285 * Lambda_11_11_p1289 +
      Lambda_11_11_p1322 * Lambda_8_11_p1;
  const Real Lambda_8_11 = Lambda_11_11 * Lambda_8_11_p2;
  Lambda[107] = Lambda_8_11;
  Lambda[140] = Lambda_8_11;
  const Real Lambda_0_8_p1 = Lambda_11_11_p1321 * Lambda_8_11_p1;
  const Real Lambda_0_8_p2 = Lambda_11_11_p1285 * Lambda_11_11_p1288;
  const Real Lambda_0_8 = Lambda_0_0_p3 - Lambda_0_11_p12 * Lambda_0_8_p2 - Lambda_0_11_p15 *
      Lambda_0_8_p1 + Lambda_0_11_p18 * Lambda_8_11;
  Lambda[8] = Lambda_0_8;
  Lambda[96] = Lambda_0_8;
  const Real Lambda_9_11_p1 = Lambda_11_11_p1289 - Lambda_11_11_p1318 * Lambda_11_11_p1322;
  const Real Lambda_9_11 = Lambda_11_11 * Lambda_9_11_p1;
  Lambda[119] = -Lambda_9_11;
  Lambda[141] = -Lambda_9_11;
  const Real Lambda_0_9_p1 = Lambda_11_11_p1318 * Lambda_11_11_p1321;
  const Real Lambda_0_9 = Lambda_0_0_p2 - Lambda_0_11_p15 * Lambda_0_9_p1 - Lambda_0_11_p18 *
      Lambda_9_11;
  Lambda[9] = Lambda_0_9;
  Lambda[108] = Lambda_0_9;
  const Real Lambda_10_11 = Lambda_11_11_p1322 * Lambda_11_11;
  Lambda[131] = -Lambda_10_11;
  Lambda[142] = -Lambda_10_11;
  const Real Lambda_0_10 = Lambda_0_0_p1 - Lambda_0_11_p18 * Lambda_10_11;
  Lambda[10] = Lambda_0_10;
  Lambda[120] = Lambda_0_10;
  const Real Lambda_1_1_p1 = Lambda_11_11_p562 + Lambda_11_11_p649 * Lambda_0_1_p9 -
      Lambda_1_11_p1 * Lambda_0_1_p8 - Lambda_1_11_p2 * Lambda_0_1_p7 - Lambda_1_11_p3 *
      Lambda_0_1_p6;
  const Real Lambda_1_1_p2 = Lambda_1_1_p1 - Lambda_1_11_p4 * Lambda_0_1_p5 - Lambda_1_11_p6 *
      Lambda_0_1_p4 - Lambda_1_11_p8 * Lambda_0_1_p3 - Lambda_1_11_p10 * Lambda_0_1_p2;
  Lambda[13] = -(Lambda_1_1_p2 - Lambda_1_11_p12 * Lambda_0_1_p1 - Lambda_1_11_p15 * Lambda_1_11);
  const Real Lambda_1_2_p1 = Lambda_0_1_p9 + Lambda_1_11_p1 * Lambda_0_2_p8 - Lambda_1_11_p2 *
      Lambda_0_2_p7 + Lambda_1_11_p3 * Lambda_0_2_p6 + Lambda_1_11_p4 * Lambda_0_2_p5;
  const Real Lambda_1_2_p2 = Lambda_1_2_p1 + Lambda_1_11_p6 * Lambda_0_2_p4 + Lambda_1_11_p8 *
      Lambda_0_2_p3 + Lambda_1_11_p10 * Lambda_0_2_p2 + Lambda_1_11_p12 * Lambda_0_2_p1;
  const Real Lambda_1_2 = Lambda_1_2_p2 + Lambda_1_11_p15 * Lambda_2_11;
  Lambda[14] = Lambda_1_2;
  Lambda[25] = Lambda_1_2;
  const Real Lambda_1_3_p1 = Lambda_0_1_p8 + Lambda_1_11_p2 * Lambda_0_3_p7 - Lambda_1_11_p3 *
      Lambda_0_3_p6 + Lambda_1_11_p4 * Lambda_0_3_p5 + Lambda_1_11_p6 * Lambda_0_3_p4;
  const Real Lambda_1_3 = Lambda_1_3_p1 + Lambda_1_11_p8 * Lambda_0_3_p3 + Lambda_1_11_p10 *
      Lambda_0_3_p2 + Lambda_1_11_p12 * Lambda_0_3_p1 + Lambda_1_11_p15 * Lambda_3_11;
  Lambda[15] = -Lambda_1_3;
  Lambda[37] = -Lambda_1_3;
  const Real Lambda_1_4_p1 = Lambda_0_1_p7 + Lambda_1_11_p3 * Lambda_0_4_p6 - Lambda_1_11_p4 *
      Lambda_0_4_p5 - Lambda_1_11_p6 * Lambda_0_4_p4 - Lambda_1_11_p8 * Lambda_0_4_p3;
  const Real Lambda_1_4 = Lambda_1_4_p1 - Lambda_1_11_p10 * Lambda_0_4_p2 - Lambda_1_11_p12 *
      Lambda_0_4_p1 - Lambda_1_11_p15 * Lambda_4_11;
  Lambda[16] = Lambda_1_4;
  Lambda[49] = Lambda_1_4;
  const Real Lambda_1_5_p1 = Lambda_0_1_p6 + Lambda_1_11_p4 * Lambda_0_5_p5 + Lambda_1_11_p6 *
      Lambda_0_5_p4 + Lambda_1_11_p8 * Lambda_0_5_p3 + Lambda_1_11_p10 * Lambda_0_5_p2;
  const Real Lambda_1_5 = Lambda_1_5_p1 + Lambda_1_11_p12 * Lambda_0_5_p1 + Lambda_1_11_p15 *
      Lambda_5_11;
  Lambda[17] = -Lambda_1_5;
  Lambda[61] = -Lambda_1_5;
  const Real Lambda_1_6_p1 = Lambda_0_1_p5 - Lambda_1_11_p6 * Lambda_0_6_p4 + Lambda_1_11_p8 *
      Lambda_0_6_p3 + Lambda_1_11_p10 * Lambda_0_6_p2 - Lambda_1_11_p12 * Lambda_0_6_p1;
  const Real Lambda_1_6 = Lambda_1_6_p1 - Lambda_1_11_p15 * Lambda_6_11;
  Lambda[18] = Lambda_1_6;
  Lambda[73] = Lambda_1_6;
  const Real Lambda_1_7 = Lambda_0_1_p4 - Lambda_1_11_p8 * Lambda_0_7_p3 - Lambda_1_11_p10 *
      Lambda_0_7_p2 - Lambda_1_11_p12 * Lambda_0_7_p1 - Lambda_1_11_p15 * Lambda_7_11;
  Lambda[19] = -Lambda_1_7;
  Lambda[85] = -Lambda_1_7;
  const Real Lambda_1_8 = Lambda_0_1_p3 - Lambda_1_11_p10 * Lambda_0_8_p2 - Lambda_1_11_p12 *
      Lambda_0_8_p1 + Lambda_1_11_p15 * Lambda_8_11;
  Lambda[20] = -Lambda_1_8;
  Lambda[97] = -Lambda_1_8;
  const Real Lambda_1_9 = Lambda_0_1_p2 - Lambda_1_11_p12 * Lambda_0_9_p1 - Lambda_1_11_p15 *
      Lambda_9_11;
  Lambda[21] = -Lambda_1_9;
  Lambda[109] = -Lambda_1_9;
  const Real Lambda_1_10 = Lambda_0_1_p1 - Lambda_1_11_p15 * Lambda_10_11;
  Lambda[22] = -Lambda_1_10;
  Lambda[121] = -Lambda_1_10;
  const Real Lambda_2_2_p1 = Lambda_11_11_p655 - Lambda_11_11_p662 * Lambda_0_2_p8 -
      Lambda_2_11_p1 * Lambda_0_2_p7 - Lambda_2_11_p2 * Lambda_0_2_p6 - Lambda_2_11_p3 *
      Lambda_0_2_p5;
  const Real Lambda_2_2_p2 = Lambda_2_2_p1 - Lambda_2_11_p4 * Lambda_0_2_p4 - Lambda_2_11_p6 *
      Lambda_0_2_p3 - Lambda_2_11_p8 * Lambda_0_2_p2 - Lambda_2_11_p10 * Lambda_0_2_p1;
  Lambda[26] = -(Lambda_2_2_p2 - Lambda_2_11_p12 * Lambda_2_11);
  const Real Lambda_2_3_p1 = Lambda_0_2_p8 - Lambda_2_11_p1 * Lambda_0_3_p7 - Lambda_2_11_p2 *
      Lambda_0_3_p6 + Lambda_2_11_p3 * Lambda_0_3_p5 + Lambda_2_11_p4 * Lambda_0_3_p4;
  const Real Lambda_2_3 = Lambda_2_3_p1 + Lambda_2_11_p6 * Lambda_0_3_p3 + Lambda_2_11_p8 *
      Lambda_0_3_p2 + Lambda_2_11_p10 * Lambda_0_3_p1 + Lambda_2_11_p12 * Lambda_3_11;
  Lambda[27] = -Lambda_2_3;
  Lambda[38] = -Lambda_2_3;
  const Real Lambda_2_4_p1 = Lambda_0_2_p7 - Lambda_2_11_p2 * Lambda_0_4_p6 + Lambda_2_11_p3 *
      Lambda_0_4_p5 + Lambda_2_11_p4 * Lambda_0_4_p4 + Lambda_2_11_p6 * Lambda_0_4_p3;
  const Real Lambda_2_4 = Lambda_2_4_p1 + Lambda_2_11_p8 * Lambda_0_4_p2 + Lambda_2_11_p10 *
      Lambda_0_4_p1 + Lambda_2_11_p12 * Lambda_4_11;
  Lambda[28] = -Lambda_2_4;
  Lambda[50] = -Lambda_2_4;
  const Real Lambda_2_5_p1 = Lambda_0_2_p6 + Lambda_2_11_p3 * Lambda_0_5_p5 + Lambda_2_11_p4 *
      Lambda_0_5_p4 + Lambda_2_11_p6 * Lambda_0_5_p3 + Lambda_2_11_p8 * Lambda_0_5_p2;
  const Real Lambda_2_5 = Lambda_2_5_p1 + Lambda_2_11_p10 * Lambda_0_5_p1 + Lambda_2_11_p12 *
      Lambda_5_11;
  Lambda[29] = -Lambda_2_5;
  Lambda[62] = -Lambda_2_5;
  const Real Lambda_2_6_p1 = Lambda_0_2_p5 - Lambda_2_11_p4 * Lambda_0_6_p4 + Lambda_2_11_p6 *
      Lambda_0_6_p3 + Lambda_2_11_p8 * Lambda_0_6_p2 - Lambda_2_11_p10 * Lambda_0_6_p1;
  const Real Lambda_2_6 = Lambda_2_6_p1 - Lambda_2_11_p12 * Lambda_6_11;
  Lambda[30] = Lambda_2_6;
  Lambda[74] = Lambda_2_6;
  const Real Lambda_2_7 = Lambda_0_2_p4 - Lambda_2_11_p6 * Lambda_0_7_p3 - Lambda_2_11_p8 *
      Lambda_0_7_p2 - Lambda_2_11_p10 * Lambda_0_7_p1 - Lambda_2_11_p12 * Lambda_7_11;
  Lambda[31] = -Lambda_2_7;
  Lambda[86] = -Lambda_2_7;
  const Real Lambda_2_8 = Lambda_0_2_p3 - Lambda_2_11_p8 * Lambda_0_8_p2 - Lambda_2_11_p10 *
      Lambda_0_8_p1 + Lambda_2_11_p12 * Lambda_8_11;
  Lambda[32] = -Lambda_2_8;
  Lambda[98] = -Lambda_2_8;
  const Real Lambda_2_9 = Lambda_0_2_p2 - Lambda_2_11_p10 * Lambda_0_9_p1 - Lambda_2_11_p12 *
      Lambda_9_11;
  Lambda[33] = -Lambda_2_9;
  Lambda[110] = -Lambda_2_9;
  const Real Lambda_2_10 = Lambda_0_2_p1 - Lambda_2_11_p12 * Lambda_10_11;
  Lambda[34] = -Lambda_2_10;
  Lambda[122] = -Lambda_2_10;
  const Real Lambda_3_3_p1 = Lambda_11_11_p663 + Lambda_11_11_p672 * Lambda_0_3_p7 +
      Lambda_3_11_p1 * Lambda_0_3_p6 + Lambda_3_11_p2 * Lambda_0_3_p5 + Lambda_3_11_p3 *
      Lambda_0_3_p4;
  Lambda[39] = Lambda_3_3_p1 + Lambda_3_11_p4 * Lambda_0_3_p3 + Lambda_3_11_p6 * Lambda_0_3_p2 +
      Lambda_3_11_p8 * Lambda_0_3_p1 + Lambda_3_11_p10 * Lambda_3_11;
  const Real Lambda_3_4_p1 = Lambda_0_3_p7 - Lambda_3_11_p1 * Lambda_0_4_p6 - Lambda_3_11_p2 *
      Lambda_0_4_p5 - Lambda_3_11_p3 * Lambda_0_4_p4 - Lambda_3_11_p4 * Lambda_0_4_p3;
  const Real Lambda_3_4 = Lambda_3_4_p1 - Lambda_3_11_p6 * Lambda_0_4_p2 - Lambda_3_11_p8 *
      Lambda_0_4_p1 - Lambda_3_11_p10 * Lambda_4_11;
  Lambda[40] = -Lambda_3_4;
  Lambda[51] = -Lambda_3_4;
  const Real Lambda_3_5_p1 = Lambda_0_3_p6 - Lambda_3_11_p2 * Lambda_0_5_p5 - Lambda_3_11_p3 *
      Lambda_0_5_p4 - Lambda_3_11_p4 * Lambda_0_5_p3 - Lambda_3_11_p6 * Lambda_0_5_p2;
  const Real Lambda_3_5 = Lambda_3_5_p1 - Lambda_3_11_p8 * Lambda_0_5_p1 - Lambda_3_11_p10 *
      Lambda_5_11;
  Lambda[41] = -Lambda_3_5;
  Lambda[63] = -Lambda_3_5;
  const Real Lambda_3_6_p1 = Lambda_0_3_p5 - Lambda_3_11_p3 * Lambda_0_6_p4 + Lambda_3_11_p4 *
      Lambda_0_6_p3 + Lambda_3_11_p6 * Lambda_0_6_p2 - Lambda_3_11_p8 * Lambda_0_6_p1;
  const Real Lambda_3_6 = Lambda_3_6_p1 - Lambda_3_11_p10 * Lambda_6_11;
  Lambda[42] = -Lambda_3_6;
  Lambda[75] = -Lambda_3_6;
  const Real Lambda_3_7 = Lambda_0_3_p4 - Lambda_3_11_p4 * Lambda_0_7_p3 - Lambda_3_11_p6 *
      Lambda_0_7_p2 - Lambda_3_11_p8 * Lambda_0_7_p1 - Lambda_3_11_p10 * Lambda_7_11;
  Lambda[43] = Lambda_3_7;
  Lambda[87] = Lambda_3_7;
  const Real Lambda_3_8 = Lambda_0_3_p3 - Lambda_3_11_p6 * Lambda_0_8_p2 - Lambda_3_11_p8 *
      Lambda_0_8_p1 + Lambda_3_11_p10 * Lambda_8_11;
  Lambda[44] = Lambda_3_8;
  Lambda[99] = Lambda_3_8;
  const Real Lambda_3_9 = Lambda_0_3_p2 - Lambda_3_11_p8 * Lambda_0_9_p1 - Lambda_3_11_p10 *
      Lambda_9_11;
  Lambda[45] = Lambda_3_9;
  Lambda[111] = Lambda_3_9;
  const Real Lambda_3_10 = Lambda_0_3_p1 - Lambda_3_11_p10 * Lambda_10_11;
  Lambda[46] = Lambda_3_10;
  Lambda[123] = Lambda_3_10;
  const Real Lambda_4_4_p1 = Lambda_11_11_p674 + Lambda_11_11_p686 * Lambda_0_4_p6 +
      Lambda_4_11_p1 * Lambda_0_4_p5 + Lambda_4_11_p2 * Lambda_0_4_p4 + Lambda_4_11_p3 *
      Lambda_0_4_p3;
  Lambda[52] = Lambda_4_4_p1 + Lambda_4_11_p4 * Lambda_0_4_p2 + Lambda_4_11_p6 * Lambda_0_4_p1 +
      Lambda_4_11_p8 * Lambda_4_11;
  const Real Lambda_4_5_p1 = Lambda_0_4_p6 - Lambda_4_11_p1 * Lambda_0_5_p5 - Lambda_4_11_p2 *
      Lambda_0_5_p4 - Lambda_4_11_p3 * Lambda_0_5_p3 - Lambda_4_11_p4 * Lambda_0_5_p2;
  const Real Lambda_4_5 = Lambda_4_5_p1 - Lambda_4_11_p6 * Lambda_0_5_p1 - Lambda_4_11_p8 *
      Lambda_5_11;
  Lambda[53] = -Lambda_4_5;
  Lambda[64] = -Lambda_4_5;
  const Real Lambda_4_6_p1 = Lambda_0_4_p5 - Lambda_4_11_p2 * Lambda_0_6_p4 + Lambda_4_11_p3 *
      Lambda_0_6_p3 + Lambda_4_11_p4 * Lambda_0_6_p2 - Lambda_4_11_p6 * Lambda_0_6_p1;
  const Real Lambda_4_6 = Lambda_4_6_p1 - Lambda_4_11_p8 * Lambda_6_11;
  Lambda[54] = -Lambda_4_6;
  Lambda[76] = -Lambda_4_6;
  const Real Lambda_4_7 = Lambda_0_4_p4 - Lambda_4_11_p3 * Lambda_0_7_p3 - Lambda_4_11_p4 *
      Lambda_0_7_p2 - Lambda_4_11_p6 * Lambda_0_7_p1 - Lambda_4_11_p8 * Lambda_7_11;
  Lambda[55] = Lambda_4_7;
  Lambda[88] = Lambda_4_7;
  const Real Lambda_4_8 = Lambda_0_4_p3 - Lambda_4_11_p4 * Lambda_0_8_p2 - Lambda_4_11_p6 *
      Lambda_0_8_p1 + Lambda_4_11_p8 * Lambda_8_11;
  Lambda[56] = Lambda_4_8;
  Lambda[100] = Lambda_4_8;
  const Real Lambda_4_9 = Lambda_0_4_p2 - Lambda_4_11_p6 * Lambda_0_9_p1 - Lambda_4_11_p8 *
      Lambda_9_11;
  Lambda[57] = Lambda_4_9;
  Lambda[112] = Lambda_4_9;
  const Real Lambda_4_10 = Lambda_0_4_p1 - Lambda_4_11_p8 * Lambda_10_11;
  Lambda[58] = Lambda_4_10;
  Lambda[124] = Lambda_4_10;
  const Real Lambda_5_5_p1 = Lambda_11_11_p688 + Lambda_11_11_p903 * Lambda_0_5_p5 +
      Lambda_5_11_p1 * Lambda_0_5_p4 + Lambda_5_11_p2 * Lambda_0_5_p3 + Lambda_5_11_p3 *
      Lambda_0_5_p2;
  Lambda[65] = Lambda_5_5_p1 + Lambda_5_11_p4 * Lambda_0_5_p1 + Lambda_5_11_p6 * Lambda_5_11;
  const Real Lambda_5_6_p1 = Lambda_0_5_p5 - Lambda_5_11_p1 * Lambda_0_6_p4 + Lambda_5_11_p2 *
      Lambda_0_6_p3 + Lambda_5_11_p3 * Lambda_0_6_p2 - Lambda_5_11_p4 * Lambda_0_6_p1;
  const Real Lambda_5_6 = Lambda_5_6_p1 - Lambda_5_11_p6 * Lambda_6_11;
  Lambda[66] = -Lambda_5_6;
  Lambda[77] = -Lambda_5_6;
  const Real Lambda_5_7 = Lambda_0_5_p4 - Lambda_5_11_p2 * Lambda_0_7_p3 - Lambda_5_11_p3 *
      Lambda_0_7_p2 - Lambda_5_11_p4 * Lambda_0_7_p1 - Lambda_5_11_p6 * Lambda_7_11;
  Lambda[67] = Lambda_5_7;
  Lambda[89] = Lambda_5_7;
  const Real Lambda_5_8 = Lambda_0_5_p3 - Lambda_5_11_p3 * Lambda_0_8_p2 - Lambda_5_11_p4 *
      Lambda_0_8_p1 + Lambda_5_11_p6 * Lambda_8_11;
  Lambda[68] = Lambda_5_8;
  Lambda[101] = Lambda_5_8;
  const Real Lambda_5_9 = Lambda_0_5_p2 - Lambda_5_11_p4 * Lambda_0_9_p1 - Lambda_5_11_p6 *
      Lambda_9_11;
  Lambda[69] = Lambda_5_9;
  Lambda[113] = Lambda_5_9;
  const Real Lambda_5_10 = Lambda_0_5_p1 - Lambda_5_11_p6 * Lambda_10_11;
  Lambda[70] = Lambda_5_10;
  Lambda[125] = Lambda_5_10;
  const Real Lambda_6_6_p1 = Lambda_11_11_p922 + Lambda_11_11_p1123 * Lambda_0_6_p4 +
      Lambda_6_11_p1 * Lambda_0_6_p3 + Lambda_6_11_p2 * Lambda_0_6_p2 + Lambda_6_11_p3 *
      Lambda_0_6_p1;
  Lambda[78] = Lambda_6_6_p1 + Lambda_6_11_p4 * Lambda_6_11;
  const Real Lambda_6_7 = Lambda_0_6_p4 + Lambda_6_11_p1 * Lambda_0_7_p3 + Lambda_6_11_p2 *
      Lambda_0_7_p2 - Lambda_6_11_p3 * Lambda_0_7_p1 - Lambda_6_11_p4 * Lambda_7_11;
  Lambda[79] = Lambda_6_7;
  Lambda[90] = Lambda_6_7;
  const Real Lambda_6_8 = Lambda_0_6_p3 - Lambda_6_11_p2 * Lambda_0_8_p2 + Lambda_6_11_p3 *
      Lambda_0_8_p1 - Lambda_6_11_p4 * Lambda_8_11;
  Lambda[80] = -Lambda_6_8;
  Lambda[102] = -Lambda_6_8;
  const Real Lambda_6_9 = Lambda_0_6_p2 + Lambda_6_11_p3 * Lambda_0_9_p1 + Lambda_6_11_p4 *
      Lambda_9_11;
  Lambda[81] = -Lambda_6_9;
  Lambda[114] = -Lambda_6_9;
  const Real Lambda_6_10 = Lambda_0_6_p1 - Lambda_6_11_p4 * Lambda_10_11;
  Lambda[82] = Lambda_6_10;
  Lambda[126] = Lambda_6_10;
  Lambda[91] = Lambda_11_11_p1136 + Lambda_11_11_p1251 * Lambda_0_7_p3 + Lambda_7_11_p1 *
      Lambda_0_7_p2 + Lambda_7_11_p2 * Lambda_0_7_p1 + Lambda_7_11_p3 * Lambda_7_11;
  const Real Lambda_7_8 = Lambda_0_7_p3 - Lambda_7_11_p1 * Lambda_0_8_p2 - Lambda_7_11_p2 *
      Lambda_0_8_p1 + Lambda_7_11_p3 * Lambda_8_11;
  Lambda[92] = -Lambda_7_8;
  Lambda[103] = -Lambda_7_8;
  const Real Lambda_7_9 = Lambda_0_7_p2 - Lambda_7_11_p2 * Lambda_0_9_p1 - Lambda_7_11_p3 *
      Lambda_9_11;
  Lambda[93] = -Lambda_7_9;
  Lambda[115] = -Lambda_7_9;
  const Real Lambda_7_10 = Lambda_0_7_p1 - Lambda_7_11_p3 * Lambda_10_11;
  Lambda[94] = -Lambda_7_10;
  Lambda[127] = -Lambda_7_10;
  Lambda[104] = Lambda_11_11_p1259 + Lambda_11_11_p1285 * Lambda_0_8_p2 + Lambda_8_11_p1 *
      Lambda_0_8_p1 + Lambda_8_11_p2 * Lambda_8_11;
  const Real Lambda_8_9 = Lambda_0_8_p2 - Lambda_8_11_p1 * Lambda_0_9_p1 + Lambda_8_11_p2 *
      Lambda_9_11;
  Lambda[105] = -Lambda_8_9;
  Lambda[116] = -Lambda_8_9;
  const Real Lambda_8_10 = Lambda_0_8_p1 + Lambda_8_11_p2 * Lambda_10_11;
  Lambda[106] = -Lambda_8_10;
  Lambda[128] = -Lambda_8_10;
  Lambda[117] = Lambda_11_11_p1288 + Lambda_11_11_p1318 * Lambda_0_9_p1 + Lambda_9_11_p1 *
      Lambda_9_11;
  const Real Lambda_9_10 = Lambda_0_9_p1 - Lambda_9_11_p1 * Lambda_10_11;
  Lambda[118] = -Lambda_9_10;
  Lambda[129] = -Lambda_9_10;
  Lambda[130] = Lambda_11_11_p1321 + Lambda_11_11_p1322 * Lambda_10_11;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
