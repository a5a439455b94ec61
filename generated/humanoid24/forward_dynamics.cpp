// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By articulated bodies, Chang table 4.2.
// 4806 flops (add 2308, mul 2466, div 32), sine and cosine of 24 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

void forward_dynamics(const Real (&TREELINE_RESTRICT q)[24], const Real (&TREELINE_RESTRICT qd)[24],
    const Real (&TREELINE_RESTRICT tau)[24], Real (&TREELINE_RESTRICT qdd)[24]) noexcept {
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
  const Real inverse_D6_p44 = c24 * (8e-06 - inverse_D22_p3) -
      (2.375e-05 * inverse_D6_p43 + c23 * (8e-06 + inverse_D22_p1));

  // link 22 (head), articulated inertia
  const Real inverse_D6_p45 = inverse_D6_p44 * inverse_D22;
  const Real inverse_D6_p46 = 1.6e-05 * (s23 - s24) +
      (inverse_D22_p2 + (0.05450270000000001 + inverse_D22_p4) - inverse_D6_p44 * inverse_D6_p45);
  const Real inverse_D6_p47 = 0.095 * (inverse_D6_p22 + inverse_D6_p24) -
      (0.032 * (inverse_D6_p25 - inverse_D6_p26) + (0.0074 + inverse_D6_p44 * inverse_D6_p29));
  const Real inverse_D6_p48 = 2.0 * c22;
  const Real inverse_D6_p49 = inverse_D6_p47 * inverse_D6_p48 + s22 *
      (0.00017071621621621625 - inverse_D6_p46 + inverse_D6_p42);
  const Real inverse_D6_p50 = inverse_D6_p27 * inverse_D22;
  const Real inverse_D6_p51 = inverse_D6_p41 - (0.072575 + inverse_D6_p39) + inverse_D6_p28 *
      inverse_D6_p50;
  const Real inverse_D6_p52 = inverse_D6_p24 - (0.43200000000000005 - inverse_D6_p22) -
      inverse_D6_p44 * inverse_D6_p50;
  const Real inverse_D6_p53 = c22 * inverse_D6_p51 + s22 * inverse_D6_p52;
  const Real inverse_D6_p54 = 0.0016155 + inverse_D6_p47 - c22 * inverse_D6_p49 - 0.394 *
      inverse_D6_p53;
  const Real minus_inverse_D21_p1 = s22 * inverse_D6_p49;

  // link 21 (neck), articulated inertia
  const Real minus_inverse_D21 = 1.0 / (minus_inverse_D21_p1 -
      (0.006216750000000001 + inverse_D6_p42));
  const Real inverse_D6_p55 = inverse_D6_p54 * minus_inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p56 = s22 * inverse_D6_p51 - c22 * inverse_D6_p52;
  const Real inverse_D6_p57 = inverse_D6_p38 + inverse_D6_p40 + inverse_D6_p27 * inverse_D6_p50;
  const Real inverse_D6_p58 = inverse_D6_p56 - 0.394 * inverse_D6_p57;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p59 = minus_inverse_D21_p1 + (0.005342908783783784 + inverse_D6_p46) +
      0.394 * (inverse_D6_p56 + inverse_D6_p58) + inverse_D6_p54 * inverse_D6_p55;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D6_p60 = 0.0007770270270270272 - inverse_D6_p24 -
      (0.431222972972973 + inverse_D6_p22);

  // link 22 (head), articulated inertia
  const Real inverse_D6_p61 = inverse_D6_p60 * inverse_D22;
  const Real inverse_D6_p62 = inverse_D6_p33 - inverse_D6_p37 - inverse_D6_p28 * inverse_D6_p61;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D6_p63 = 0.072575 + 0.00025 * inverse_D22_p5;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p64 = inverse_D6_p63 * inverse_D22;
  const Real inverse_D6_p65 = 0.00025 * inverse_D6_p43 + inverse_D6_p44 * inverse_D6_p64;
  const Real inverse_D6_p66 = inverse_D6_p27 - inverse_D6_p44 * inverse_D6_p61;
  const Real inverse_D6_p67 = inverse_D6_p28 * inverse_D6_p64;
  const Real inverse_D6_p68 = c22 * (inverse_D6_p62 - inverse_D6_p65) - s22 *
      (inverse_D6_p66 + inverse_D6_p67);
  const Real inverse_D6_p69 = c22 * inverse_D6_p68;
  const Real inverse_D6_p70 = inverse_D6_p65 + inverse_D6_p69;
  const Real inverse_D6_p71 = 0.394 * inverse_D6_p70;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p72 = inverse_D6_p71 * minus_inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p73 = inverse_D6_p60 * inverse_D6_p64;
  const Real inverse_D6_p74 = inverse_D6_p31 + inverse_D6_p35 + inverse_D6_p60 * inverse_D6_p61;
  const Real inverse_D6_p75 = inverse_D6_p63 * inverse_D6_p64;
  const Real inverse_D6_p76 = inverse_D6_p73 * inverse_D6_p48 - s22 *
      (inverse_D6_p74 - inverse_D6_p75);
  const Real inverse_D6_p77 = s22 * inverse_D6_p76;
  const Real inverse_D6_p78 = inverse_D6_p74 + inverse_D6_p77;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p79 = 0.000703125 - 0.155236 * inverse_D6_p78 + inverse_D6_p71 *
      inverse_D6_p72;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p80 = s22 * inverse_D6_p68;
  const Real inverse_D6_p81 = inverse_D6_p63 * inverse_D6_p50;
  const Real inverse_D6_p82 = inverse_D6_p32 + inverse_D6_p36 + inverse_D6_p60 * inverse_D6_p50;
  const Real inverse_D6_p83 = s22 * inverse_D6_p81 + c22 * inverse_D6_p82;
  const Real inverse_D6_p84 = 0.394 * inverse_D6_p83;
  const Real inverse_D6_p85 = inverse_D6_p84 + (inverse_D6_p66 + inverse_D6_p80);

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p86 = 0.394 * inverse_D6_p85 - inverse_D6_p54 * inverse_D6_p72;
  const Real inverse_D6_p87 = 2.0 * s21;
  const Real inverse_D6_p88 = inverse_D6_p86 * inverse_D6_p87 + c21 *
      (inverse_D6_p59 - inverse_D6_p79);
  const Real inverse_D6_p89 = c21 * inverse_D6_p88;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p90 = 0.226 * (inverse_D6_p13 + inverse_D6_p15 +
      (inverse_D6_p16 + inverse_D6_p18)) - (inverse_D6_p19 +
      (inverse_D5_p372 + (inverse_D6_p20 - (inverse_D5_p367 -
      (inverse_D6_p89 + (2.06965463592404 + inverse_D6_p79))))));

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / (0.18 * (inverse_D6_p2 + inverse_D6_p6 -
      (inverse_D6_p8 + inverse_D6_p12)) - inverse_D6_p90);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p382 = 0.226 * (inverse_D5_p182 - inverse_D5_p364) -
      (inverse_D6_p86 - s21 * inverse_D6_p88);

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
      (inverse_D6_p89 - (1.66923963592404 + inverse_D6_p59) + inverse_D5_p382 * inverse_D5_p383);
  const Real inverse_D5_p396 = inverse_D5_p388 * inverse_D5_p389 + s6 *
      (inverse_D5_p393 + inverse_D5_p395);
  const Real inverse_D5_p397 = s6 * inverse_D5_p396;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p398 = inverse_D6_p70 * minus_inverse_D21;
  const Real inverse_D5_p399 = 0.394 * inverse_D6_p78 - inverse_D6_p71 * inverse_D5_p398;

  // link 22 (head), articulated inertia
  const Real inverse_D5_p400 = 0.0045000000000000005 - inverse_D6_p53;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p401 = inverse_D5_p400 * minus_inverse_D21;
  const Real inverse_D5_p402 = inverse_D6_p58 + inverse_D6_p54 * inverse_D5_p401;
  const Real inverse_D5_p403 = inverse_D6_p85 - inverse_D6_p54 * inverse_D5_p398;
  const Real inverse_D5_p404 = inverse_D6_p84 - inverse_D6_p71 * inverse_D5_p401;
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
  const Real inverse_D5_p413 = inverse_D6_p83 - inverse_D6_p70 * inverse_D5_p401;
  const Real inverse_D5_p414 = inverse_D6_p78 - inverse_D6_p70 * inverse_D5_p398;
  const Real inverse_D5_p415 = inverse_D6_p57 - inverse_D5_p400 * inverse_D5_p401;
  const Real inverse_D5_p416 = inverse_D5_p413 * inverse_D6_p87 + c21 *
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
  const Real inverse_D1_p4 = inverse_D6_p67 + inverse_D6_p80;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p5 = inverse_D1_p4 * minus_inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p6 = inverse_D6_p73 - c22 * inverse_D6_p76;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p7 = 0.0045000000000000005 - 0.394 * inverse_D1_p6 + inverse_D6_p71 *
      inverse_D1_p5;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p8 = c22 * inverse_D6_p81 - s22 * inverse_D6_p82;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p9 = inverse_D6_p62 - inverse_D6_p69 - 0.394 * inverse_D1_p8 -
      inverse_D6_p54 * inverse_D1_p5;

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
  const Real inverse_D1_p19 = inverse_D1_p6 - inverse_D6_p70 * inverse_D1_p5;

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
      (inverse_D6_p75 - inverse_D6_p77 - inverse_D1_p4 * inverse_D1_p5)) + inverse_D1_p10 *
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

  // link 2 (thigh), outward
  const Real minus_a2_y_p1 = 9.81 * c1 - qd[0] * (0.434 * qd[0]);

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;

  // link 2 (thigh), outward
  const Real minus_a2_y = c2 * minus_a2_y_p1 - s2 * minus_a1_x;
  const Real w2_z = qd[0] + qd[1];
  const Real minus_a3_y_p1 = w2_z * w2_z;

  // link 3 (hip), outward
  const Real minus_a3_y_p2 = minus_a2_y - 0.422 * minus_a3_y_p1;

  // link 2 (thigh), outward
  const Real minus_a2_x = s2 * minus_a2_y_p1 + c2 * minus_a1_x;

  // link 3 (hip), outward
  const Real minus_a3_y = c3 * minus_a3_y_p2 - s3 * minus_a2_x;
  const Real w3_z = qd[2] + w2_z;

  // link 4 (chest1), outward
  const Real w4_x = s4 * w3_z;
  const Real minus_a5_x_p1 = w4_x * w4_x;
  const Real w4_y = c4 * w3_z;
  const Real minus_a5_x_p2 = w4_y * w4_y;

  // link 5 (chest2), outward
  const Real minus_a5_x_p3 = minus_a3_y - 0.21799999999999997 * (minus_a5_x_p1 + minus_a5_x_p2);

  // link 3 (hip), outward
  const Real minus_a3_x = s3 * minus_a3_y_p2 + c3 * minus_a2_x;

  // link 4 (chest1), outward
  const Real minus_a4_x = c4 * minus_a3_x;

  // link 5 (chest2), outward
  const Real minus_a5_x = s5 * minus_a5_x_p3 + c5 * minus_a4_x;
  const Real minus_w5_x = qd[3] * s5 - c5 * w4_x;
  const Real minus_w5_y = qd[3] * c5 + s5 * w4_x;
  const Real minus_a6_z_p1 = minus_w5_x * minus_w5_y;

  // link 4 (chest1), outward
  const Real minus_wd4_y = qd[3] * w4_x;

  // link 5 (chest2), outward
  const Real minus_a6_z_p2 = minus_wd4_y + minus_a6_z_p1;

  // link 6 (chest3), outward
  const Real minus_a6_z = minus_a5_x + 0.072 * minus_a6_z_p2;

  // link 4 (chest1), outward
  const Real wd4_x = qd[3] * w4_y;

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * wd4_x - qd[4] * minus_w5_x;
  const Real w5_z = qd[4] + w4_y;

  // link 6 (chest3), outward
  const Real w6_y = c6 * w5_z + s6 * minus_w5_y;
  const Real minus_wd6_x = s6 * minus_wd4_y + c6 * minus_wd5_y - qd[5] * w6_y;
  const Real w6_z = qd[5] - minus_w5_x;
  const Real a14_y_p1 = w6_y * w6_z;
  const Real a14_y_p2 = minus_wd6_x - a14_y_p1;

  // link 7 (left_shoulder1), outward
  const Real a14_y_p3 = 0.18 * a14_y_p2;

  // link 6 (chest3), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real minus_wd6_y = c6 * minus_wd4_y - s6 * minus_wd5_y + qd[5] * w6_x;
  const Real a14_y_p4 = minus_wd6_y + w6_x * w6_z;

  // link 7 (left_shoulder1), outward
  const Real a14_y_p5 = 0.226 * a14_y_p4;

  // link 14 (right_shoulder1), outward
  const Real a14_y_p6 = a14_y_p5 + (minus_a6_z - a14_y_p3);

  // link 4 (chest1), outward
  const Real a4_y = s4 * minus_a3_x;

  // link 5 (chest2), outward
  const Real wd5_x = c5 * wd4_x - qd[4] * minus_w5_y;
  const Real a6_x_p1 = wd5_x - minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p2 = a4_y - 0.072 * a6_x_p1;

  // link 5 (chest2), outward
  const Real minus_a5_y = c5 * minus_a5_x_p3 - s5 * minus_a4_x;
  const Real a6_x_p3 = minus_w5_x * minus_w5_x;
  const Real a6_x_p4 = w5_z * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p5 = a6_x_p3 + a6_x_p4;
  const Real a6_x_p6 = minus_a5_y - 0.072 * a6_x_p5;
  const Real a6_x = s6 * a6_x_p2 - c6 * a6_x_p6;
  const Real a14_y_p7 = w6_x * w6_y;

  // link 7 (left_shoulder1), outward
  const Real a14_y_p8 = 0.18 * (wd5_x - a14_y_p7);

  // link 6 (chest3), outward
  const Real a14_y_p9 = w6_z * w6_z;

  // link 7 (left_shoulder1), outward
  const Real a14_y_p10 = a14_y_p9 + w6_y * w6_y;
  const Real a14_y_p11 = 0.226 * a14_y_p10;

  // link 14 (right_shoulder1), outward
  const Real a14_y_p12 = a14_y_p11 + (a6_x + a14_y_p8);
  const Real a14_y = s14 * a14_y_p6 + c14 * a14_y_p12;

  // link 6 (chest3), outward
  const Real a6_y = c6 * a6_x_p2 + s6 * a6_x_p6;
  const Real minus_a14_z_p1 = w6_x * w6_x;

  // link 7 (left_shoulder1), outward
  const Real minus_a14_z_p2 = 0.18 * (minus_a14_z_p1 + a14_y_p9);

  // link 6 (chest3), outward
  const Real minus_a14_z_p3 = wd5_x + a14_y_p7;

  // link 7 (left_shoulder1), outward
  const Real minus_a14_z_p4 = 0.226 * minus_a14_z_p3;

  // link 14 (right_shoulder1), outward
  const Real minus_a14_z = minus_a14_z_p4 - (a6_y + minus_a14_z_p2);

  // link 15 (right_shoulder2), outward
  const Real minus_a15_x = s15 * minus_a14_z - c15 * a14_y;

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
  const Real minus_a14_x = c14 * a14_y_p6 - s14 * a14_y_p12;

  // link 15 (right_shoulder2), outward
  const Real minus_a15_y = c15 * minus_a14_z + s15 * a14_y;

  // link 16 (right_upperarm), outward
  const Real minus_a16_x = c16 * minus_a14_x + s16 * minus_a15_y;

  // link 14 (right_shoulder1), outward
  const Real wd14_x = c14 * wd5_x - s14 * minus_wd6_x - qd[13] * minus_w14_y;
  const Real minus_wd14_y = s14 * wd5_x + c14 * minus_wd6_x + qd[13] * w14_x;

  // link 15 (right_shoulder2), outward
  const Real w15_x = s15 * w14_z - c15 * minus_w14_y;
  const Real minus_wd15_y = c15 * minus_wd6_y - s15 * minus_wd14_y + qd[14] * w15_x;

  // link 16 (right_upperarm), outward
  const Real minus_wd16_y = s16 * wd14_x + c16 * minus_wd15_y + qd[15] * w16_x;
  const Real w16_z = qd[15] - w15_x;
  const Real minus_a17_y_p4 = w16_x * w16_z;
  const Real minus_a17_y_p5 = minus_wd16_y - minus_a17_y_p4;

  // link 17 (right_lowerarm), outward
  const Real minus_a17_y_p6 = minus_a16_x - 0.282 * minus_a17_y_p5;
  const Real minus_a17_y = c17 * minus_a17_y_p3 - s17 * minus_a17_y_p6;
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
  const Real minus_a17_x = s17 * minus_a17_y_p3 + c17 * minus_a17_y_p6;

  // link 16 (right_upperarm), outward
  const Real a16_y = s16 * minus_a14_x - c16 * minus_a15_y;
  const Real wd16_x = c16 * wd14_x - s16 * minus_wd15_y - qd[15] * minus_w16_y;
  const Real a17_z_p1 = minus_w16_y * w16_z;
  const Real a17_z_p2 = wd16_x + a17_z_p1;

  // link 17 (right_lowerarm), outward
  const Real a17_z = a16_y + 0.282 * a17_z_p2;

  // link 18 (right_wrist1), outward
  const Real a18_x = s18 * a17_z - c18 * minus_a17_x;

  // link 15 (right_shoulder2), outward
  const Real minus_wd15_x = s15 * minus_wd6_y + c15 * minus_wd14_y - qd[14] * w15_y;

  // link 17 (right_lowerarm), outward
  const Real minus_w17_y = c17 * w16_z + s17 * w16_x;
  const Real minus_wd17_x = s17 * minus_wd15_x - c17 * wd16_x + qd[16] * minus_w17_y;

  // link 18 (right_wrist1), outward
  const Real minus_wd18_y = c18 * minus_wd16_y - s18 * minus_wd17_x + qd[17] * w18_x;
  const Real w18_z = qd[17] + minus_w17_y;
  const Real minus_a19_y_p4 = w18_x * w18_z;
  const Real minus_a19_y_p5 = minus_wd18_y - minus_a19_y_p4;

  // link 19 (right_wrist2), outward
  const Real minus_a19_y_p6 = a18_x + 0.269 * minus_a19_y_p5;
  const Real minus_a19_y = c19 * minus_a19_y_p3 + s19 * minus_a19_y_p6;

  // link 18 (right_wrist1), outward
  const Real a18_y = c18 * a17_z + s18 * minus_a17_x;
  const Real minus_wd18_x = s18 * minus_wd16_y + c18 * minus_wd17_x - qd[17] * w18_y;
  const Real a19_z_p1 = w18_y * w18_z;
  const Real a19_z_p2 = minus_wd18_x + a19_z_p1;

  // link 19 (right_wrist2), outward
  const Real a19_z = a18_y - 0.269 * a19_z_p2;

  // link 20 (right_hand), outward
  const Real a20_x = s20 * a19_z - c20 * minus_a19_y;

  // link 19 (right_wrist2), outward
  const Real w19_z = qd[18] + w18_y;
  const Real minus_w19_y = c19 * w18_z + s19 * w18_x;

  // link 20 (right_hand), outward
  const Real w20_x = s20 * w19_z - c20 * minus_w19_y;
  const Real minus_n20_z_p1 = w20_x * w20_x;
  const Real w20_y = c20 * w19_z + s20 * minus_w19_y;
  const Real minus_n20_z_p2 = w20_y * w20_y;

  // link 17 (right_lowerarm), outward
  const Real minus_wd17_y = c17 * minus_wd15_x + s17 * wd16_x - qd[16] * minus_w17_x;

  // link 19 (right_wrist2), outward
  const Real minus_w19_x = s19 * w18_z - c19 * w18_x;
  const Real minus_wd19_y = c19 * minus_wd17_y - s19 * minus_wd18_x - qd[18] * minus_w19_x;

  // link 20 (right_hand), outward
  const Real minus_wd20_y = c20 * minus_wd18_y - s20 * minus_wd19_y + qd[19] * w20_x;
  const Real w20_z = qd[19] - minus_w19_x;
  const Real minus_n20_z_p3 = w20_x * w20_z;
  const Real minus_wd20_x = s20 * minus_wd18_y + c20 * minus_wd19_y - qd[19] * w20_y;
  const Real minus_n20_z_p4 = w20_y * w20_z;

  // link 20 (right_hand), inertial wrench
  const Real minus_n20_z_p5 = 0.0001263900573325125 * (minus_n20_z_p1 - minus_n20_z_p2) -
      4.38600177048965e-05 * (minus_wd20_y - minus_n20_z_p3) - 0.000108260010923775 *
      (minus_wd20_x + minus_n20_z_p4);

  // link 19 (right_wrist2), outward
  const Real minus_wd19_x = s19 * minus_wd17_y + c19 * minus_wd18_x + qd[18] * minus_w19_y;

  // link 20 (right_hand), outward
  const Real minus_n20_z_p6 = w20_x * w20_y;
  const Real a20_y = c20 * a19_z + s20 * minus_a19_y;

  // link 20 (right_hand), inertial wrench
  const Real minus_n20_z = minus_n20_z_p5 + 0.0009386316083993107 * minus_wd19_x -
      0.0007556474228594393 * minus_n20_z_p6 + 0.002865001425 * a20_x - 0.01626499875 * a20_y;

  // link 1 (calf), inward
  const Real qdd_0_p1 = tau[19] + minus_n20_z;

  // link 20 (right_hand), bias force
  const Real qdd_0_p2 = 17.32841575379867 * qdd_0_p1;
  const Real qdd_0_p3 = 3.0523172236718206 * qdd_0_p1;

  // link 19 (right_wrist2), outward
  const Real minus_a19_x = s19 * minus_a19_y_p3 - c19 * minus_a19_y_p6;
  const Real minus_n19_z_p1 = minus_w19_x * w19_z;
  const Real minus_n19_z_p2 = minus_w19_x * minus_w19_y;

  // link 20 (right_hand), inward
  const Real minus_n19_z_p3 = 2.4000000000000003e-06 * (minus_wd19_y + minus_n19_z_p1) +
      0.00020682766225734302 * minus_wd18_y - 0.000183627662257343 * minus_n19_z_p2 -
      0.0006000000000000001 * minus_a19_x;

  // link 20 (right_hand), outward
  const Real n20_y_p1 = w20_z * w20_z;
  const Real n20_y_p2 = minus_wd20_x - minus_n20_z_p4;
  const Real n20_y_p3 = minus_wd19_x + minus_n20_z_p6;
  const Real n20_y_p4 = minus_wd20_y + minus_n20_z_p3;

  // link 20 (right_hand), inertial wrench
  const Real n20_y_p5 = 0.000108260010923775 * (minus_n20_z_p1 - n20_y_p1) + 0.0001263900573325125 *
      n20_y_p2 + 4.38600177048965e-05 * n20_y_p3 - 0.000847139515629375 * n20_y_p4;
  const Real n20_y = n20_y_p5 + 0.01626499875 * minus_a19_x;

  // link 20 (right_hand), outward
  const Real minus_n20_x_p1 = minus_wd19_x - minus_n20_z_p6;

  // link 20 (right_hand), inertial wrench
  const Real minus_n20_x_p2 = 4.38600177048965e-05 * (minus_n20_z_p2 - n20_y_p1) -
      0.000108260010923775 * minus_n20_x_p1 - 0.0001263900573325125 * n20_y_p4 +
      9.149209276993575e-05 * n20_y_p2;
  const Real minus_n20_x = minus_n20_x_p2 + 0.002865001425 * minus_a19_x;

  // link 20 (right_hand), inward
  const Real minus_n19_z = minus_n19_z_p3 + 0.0025100003499999995 * minus_a19_y - c20 * n20_y +
      s20 * minus_n20_x;

  // link 1 (calf), inward
  const Real qdd_0_p4 = tau[18] + minus_n19_z;

  // link 20 (right_hand), bias force
  const Real qdd_0_p5 = 0.04672761636452121 * qdd_0_p1;
  const Real qdd_0_p6 = 0.11533812622014242 * qdd_0_p1;

  // link 19 (right_wrist2), bias force
  const Real qdd_0_p7 = qdd_0_p4 + c20 * qdd_0_p5 + s20 * qdd_0_p6;
  const Real qdd_0_p8 = c20 * qdd_0_p2 - s20 * qdd_0_p3 - inverse_D5_p14 * qdd_0_p7;
  const Real qdd_0_p9 = s20 * qdd_0_p5 - c20 * qdd_0_p6 - inverse_D18_p1 * qdd_0_p7;

  // link 19 (right_wrist2), outward
  const Real minus_n19_y_p1 = minus_wd18_y + minus_n19_z_p2;
  const Real minus_n19_y_p2 = minus_wd19_y - minus_n19_z_p1;

  // link 20 (right_hand), inward
  const Real minus_n19_y = 2.4000000000000003e-06 * minus_n19_y_p1 + 0.000195227662257343 *
      minus_n19_y_p2 + 0.0025100003499999995 * a19_z + s20 * n20_y + c20 * minus_n20_x;

  // link 19 (right_wrist2), inward
  const Real n18_z_p1 = 6e-06 * (minus_a19_y_p1 - minus_a19_y_p2) + 0.0002516 * minus_a19_y_p5 -
      0.000144 * a19_z_p2 + 0.0002292 * minus_wd17_y;

  // link 18 (right_wrist1), outward
  const Real n18_z_p2 = w18_x * w18_y;

  // link 19 (right_wrist2), inward
  const Real n18_z_p3 = n18_z_p1 - 9.600000000000003e-06 * n18_z_p2 + 0.001 * a18_x + 6e-04 *
      a18_y + c19 * minus_n19_y;

  // link 19 (right_wrist2), outward
  const Real minus_n19_x_p1 = minus_w19_y * minus_w19_y;
  const Real minus_n19_x_p2 = w19_z * w19_z;
  const Real minus_n19_x_p3 = minus_wd19_x + minus_w19_y * w19_z;

  // link 20 (right_hand), inward
  const Real minus_n19_x = minus_n20_z - (2.4000000000000003e-06 *
      (minus_n19_x_p1 - minus_n19_x_p2) - 1.16e-05 * minus_n19_x_p3 + 0.0006000000000000001 *
      a19_z);

  // link 19 (right_wrist2), inward
  const Real n18_z = n18_z_p3 + s19 * minus_n19_x;

  // link 1 (calf), inward
  const Real qdd_0_p10 = tau[17] - n18_z;

  // link 18 (right_wrist1), bias force
  const Real qdd_0_p11 = qdd_0_p10 + c19 * qdd_0_p9 + s19 * qdd_0_p1;
  const Real qdd_0_p12 = qdd_0_p8 + inverse_D5_p57 * qdd_0_p11;

  // link 19 (right_wrist2), bias force
  const Real qdd_0_p13 = s20 * qdd_0_p2 + c20 * qdd_0_p3 + inverse_D5_p8 * qdd_0_p7;
  const Real qdd_0_p14 = inverse_D5_p2 * qdd_0_p7;
  const Real qdd_0_p15 = s19 * qdd_0_p13 + c19 * qdd_0_p14;

  // link 18 (right_wrist1), bias force
  const Real qdd_0_p16 = qdd_0_p15 + inverse_D5_p54 * qdd_0_p11;
  const Real qdd_0_p17 = qdd_0_p4 - 0.269 * qdd_0_p15 - inverse_D5_p23 * qdd_0_p11;

  // link 20 (right_hand), inertial wrench
  const Real minus_f20_y = 0.002865001425 * (minus_n20_z_p1 + n20_y_p1) + 0.01626499875 *
      minus_n20_x_p1;
  const Real f20_x = 0.002865001425 * n20_y_p3 - 0.01626499875 * (minus_n20_z_p2 + n20_y_p1);

  // link 20 (right_hand), inward
  const Real minus_f19_z = 0.0006000000000000001 * minus_n19_x_p3 - 0.0025100003499999995 *
      minus_n19_y_p2 + c20 * minus_f20_y - s20 * f20_x;

  // link 18 (right_wrist1), outward
  const Real minus_n18_x_p1 = w18_z * w18_z;
  const Real minus_n18_x_p2 = minus_wd17_y + n18_z_p2;
  const Real minus_n18_x_p3 = minus_wd18_y + minus_a19_y_p4;
  const Real minus_n18_x_p4 = minus_wd18_x - a19_z_p1;

  // link 19 (right_wrist2), inward
  const Real minus_n18_x_p5 = 0.0002516 * (minus_a19_y_p2 - minus_n18_x_p1) - 0.000144 *
      minus_n18_x_p2 + 6e-06 * minus_n18_x_p3 + 0.0001194 * minus_n18_x_p4;
  const Real minus_n18_x = minus_n18_x_p5 + 0.001 * minus_a17_y + 0.269 * minus_f19_z - s19 *
      minus_n19_y + c19 * minus_n19_x;

  // link 18 (right_wrist1), outward
  const Real minus_n18_y_p1 = minus_wd17_y - n18_z_p2;

  // link 19 (right_wrist2), inward
  const Real minus_n18_y_p2 = 0.000144 * (minus_a19_y_p1 - minus_n18_x_p1) + 6e-06 *
      minus_n18_x_p4 + 0.0002516 * minus_n18_y_p1 + 0.0001098 * minus_n18_x_p3;

  // link 20 (right_hand), inward
  const Real minus_f19_y_p1 = 0.0006000000000000001 * (minus_n19_x_p2 + minus_w19_x * minus_w19_x) +
      0.0025100003499999995 * (minus_wd18_y - minus_n19_z_p2) - s20 * minus_f20_y;
  const Real minus_f19_y = minus_f19_y_p1 - c20 * f20_x;
  const Real f19_x = 0.0006000000000000001 * minus_n19_y_p1 - 0.0025100003499999995 *
      (minus_n19_x_p1 + minus_n19_x_p2) - 0.002865001425 * n20_y_p2 + 0.01626499875 * n20_y_p4;

  // link 19 (right_wrist2), inward
  const Real minus_n18_y_p3 = s19 * minus_f19_y + c19 * f19_x;
  const Real minus_n18_y = minus_n19_z + (minus_n18_y_p2 + 6e-04 * minus_a17_y) + 0.269 *
      minus_n18_y_p3;

  // link 17 (right_lowerarm), outward
  const Real minus_n17_z_p1 = minus_w17_y * w17_z;
  const Real minus_n17_z_p2 = minus_w17_x * minus_w17_y;

  // link 18 (right_wrist1), inward
  const Real minus_n17_z_p3 = 2.249994685315e-05 * (minus_wd17_x - minus_n17_z_p1) +
      0.060888541114265754 * minus_wd16_y + 0.06032654142055946 * minus_n17_z_p2 -
      0.28049749700000004 * minus_a17_x;

  // link 17 (right_lowerarm), outward
  const Real minus_n17_z_p4 = minus_w17_x * w17_z;
  const Real minus_n17_z_p5 = minus_w17_x * minus_w17_x;
  const Real minus_n17_z_p6 = minus_w17_y * minus_w17_y;

  // link 18 (right_wrist1), inward
  const Real minus_n17_z = 0.0001499998887063 * (minus_wd17_y + minus_n17_z_p4 +
      (minus_n17_z_p5 - minus_n17_z_p6)) + (minus_n17_z_p3 + 0.0014999985000000002 * minus_a17_y +
      c18 * minus_n18_y + s18 * minus_n18_x);

  // link 1 (calf), inward
  const Real qdd_0_p18 = tau[16] + minus_n17_z;

  // link 18 (right_wrist1), bias force
  const Real qdd_0_p19 = 0.269 * qdd_0_p8 - s19 * qdd_0_p9 + c19 * qdd_0_p1 + inverse_D5_p29 *
      qdd_0_p11;

  // link 17 (right_lowerarm), bias force
  const Real qdd_0_p20 = qdd_0_p18 - c18 * qdd_0_p17 - s18 * qdd_0_p19;
  const Real qdd_0_p21 = c18 * qdd_0_p12 + s18 * qdd_0_p16 - inverse_D5_p64 * qdd_0_p20;
  const Real qdd_0_p22 = s18 * qdd_0_p17 - c18 * qdd_0_p19 - inverse_D5_p49 * qdd_0_p20;
  const Real qdd_0_p23 = qdd_0_p10 - inverse_D5_p46 * qdd_0_p20;

  // link 17 (right_lowerarm), outward
  const Real minus_n17_y_p1 = w17_z * w17_z;
  const Real minus_n17_y_p2 = minus_wd17_y - minus_n17_z_p4;
  const Real minus_n17_y_p3 = minus_wd16_y + minus_n17_z_p2;
  const Real minus_n17_y_p4 = minus_wd17_x + minus_n17_z_p1;

  // link 18 (right_wrist1), inward
  const Real minus_n17_y = 0.0001499998887063 * (minus_n17_y_p3 - minus_n17_y_p4) +
      (n18_z + (2.249994685315e-05 * (minus_n17_z_p5 - minus_n17_y_p1) + 0.00028099984685315 *
      minus_n17_y_p2 + 0.0014999985000000002 * a17_z));

  // link 17 (right_lowerarm), inward
  const Real minus_n16_z_p1 = 4.4999986458742003e-05 * (minus_a17_y_p1 - minus_a17_y_p2) -
      0.0012089992423205001 * minus_a17_y_p5 + 0.0005895000784280001 * a17_z_p2 -
      0.0027762933559338653 * minus_wd15_x;

  // link 16 (right_upperarm), outward
  const Real minus_n16_z_p2 = w16_x * minus_w16_y;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_z_p3 = minus_n16_z_p1 - 0.001140794814995722 * minus_n16_z_p2 +
      0.004500002325 * minus_a16_x + 0.0022500062 * a16_y - c17 * minus_n17_y;

  // link 17 (right_lowerarm), outward
  const Real n17_x_p1 = minus_wd16_y - minus_n17_z_p2;

  // link 18 (right_wrist1), inward
  const Real n17_x_p2 = 2.249994685315e-05 * n17_x_p1 + 0.06060754126741261 * minus_n17_y_p4 -
      0.28049749700000004 * a17_z - s18 * minus_n18_y + c18 * minus_n18_x;
  const Real n17_x = 0.0001499998887063 * (minus_n17_y_p2 + (minus_n17_z_p6 - minus_n17_y_p1)) -
      n17_x_p2;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_z = minus_n16_z_p3 + s17 * n17_x;

  // link 1 (calf), inward
  const Real qdd_0_p24 = tau[15] + minus_n16_z;

  // link 16 (right_upperarm), bias force
  const Real qdd_0_p25 = qdd_0_p24 - c17 * qdd_0_p23 - s17 * qdd_0_p22;
  const Real qdd_0_p26 = qdd_0_p21 + inverse_D5_p71 * qdd_0_p25;

  // link 17 (right_lowerarm), bias force
  const Real qdd_0_p27 = s18 * qdd_0_p12 - c18 * qdd_0_p16 + inverse_D5_p82 * qdd_0_p20;
  const Real qdd_0_p28 = c19 * qdd_0_p13 - s19 * qdd_0_p14 - inverse_D5_p86 * qdd_0_p11 -
      inverse_D5_p91 * qdd_0_p20;
  const Real qdd_0_p29 = s17 * qdd_0_p28 - c17 * qdd_0_p27;

  // link 16 (right_upperarm), bias force
  const Real qdd_0_p30 = qdd_0_p29 - inverse_D5_p99 * qdd_0_p25;
  const Real qdd_0_p31 = qdd_0_p18 - 0.282 * qdd_0_p29 + inverse_D15_p1 * qdd_0_p25;

  // link 19 (right_wrist2), inward
  const Real minus_f18_y = minus_f19_z - (0.001 * (minus_a19_y_p1 + minus_n18_x_p1) + 6e-04 *
      minus_n18_x_p2);
  const Real f18_x = minus_n18_y_p3 + (0.001 * minus_n18_y_p1 - 6e-04 *
      (minus_a19_y_p2 + minus_n18_x_p1));

  // link 18 (right_wrist1), inward
  const Real minus_f17_z = 0.28049749700000004 * minus_n17_y_p4 - 0.0014999985000000002 *
      minus_n17_y_p2 + c18 * minus_f18_y - s18 * f18_x;

  // link 16 (right_upperarm), outward
  const Real minus_n16_x_p1 = w16_z * w16_z;
  const Real minus_n16_x_p2 = minus_wd15_x - minus_n16_z_p2;
  const Real minus_n16_x_p3 = minus_wd16_y + minus_a17_y_p4;
  const Real minus_n16_x_p4 = wd16_x - a17_z_p1;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_x_p5 = 0.0012089992423205001 * (minus_a17_y_p2 - minus_n16_x_p1) +
      0.0005895000784280001 * minus_n16_x_p2 - 4.4999986458742003e-05 * minus_n16_x_p3 -
      0.0019585440854647937 * minus_n16_x_p4;
  const Real minus_n16_x = minus_n16_x_p5 + 0.004500002325 * minus_a15_x + 0.282 * minus_f17_z -
      s17 * minus_n17_y - c17 * n17_x;

  // link 16 (right_upperarm), outward
  const Real minus_n16_y_p1 = minus_wd15_x + minus_n16_z_p2;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_y_p2 = 0.0005895000784280001 * (minus_a17_y_p1 - minus_n16_x_p1) -
      4.4999986458742003e-05 * minus_n16_x_p4 - 0.0012089992423205001 * minus_n16_y_p1 -
      0.0008177492704690715 * minus_n16_x_p3;

  // link 18 (right_wrist1), inward
  const Real f17_x = 0.28049749700000004 * minus_n17_y_p3 - 0.0014999985000000002 *
      (minus_n17_z_p6 + minus_n17_y_p1) + s18 * minus_f18_y + c18 * f18_x;
  const Real minus_f17_y_p1 = 0.28049749700000004 * (minus_n17_z_p5 + minus_n17_y_p1) +
      0.0014999985000000002 * n17_x_p1 + 0.001 * minus_n18_x_p4 + 6e-04 * minus_n18_x_p3;
  const Real minus_f17_y = minus_f17_y_p1 + c19 * minus_f19_y - s19 * f19_x;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_y_p3 = s17 * minus_f17_y + c17 * f17_x;
  const Real minus_n16_y = minus_n17_z - (minus_n16_y_p2 + 0.0022500062 * minus_a15_x) + 0.282 *
      minus_n16_y_p3;

  // link 15 (right_shoulder2), outward
  const Real n15_z_p1 = w15_x * w15_x;
  const Real n15_z_p2 = w15_y * w15_y;
  const Real n15_z_p3 = w15_x * w15_z;
  const Real n15_z_p4 = w15_y * w15_z;

  // link 16 (right_upperarm), inward
  const Real n15_z_p5 = 5.2499999999999995e-05 * (n15_z_p1 - n15_z_p2) - 1.75e-05 *
      (minus_wd15_y - n15_z_p3) + 0.00010499999999999999 * (minus_wd15_x + n15_z_p4);

  // link 15 (right_shoulder2), outward
  const Real n15_z_p6 = w15_x * w15_y;

  // link 16 (right_upperarm), inward
  const Real n15_z_p7 = n15_z_p5 + 0.18125194219699997 * wd14_x + 0.18101044219699997 * n15_z_p6 -
      0.0017499999999999998 * minus_a15_x - 0.7139200499999999 * minus_a15_y;
  const Real n15_z = n15_z_p7 + s16 * minus_n16_y - c16 * minus_n16_x;

  // link 1 (calf), inward
  const Real qdd_0_p32 = tau[14] - n15_z;

  // link 16 (right_upperarm), bias force
  const Real qdd_0_p33 = 0.282 * qdd_0_p21 + s17 * qdd_0_p23 - c17 * qdd_0_p22 + inverse_D15_p4 *
      qdd_0_p25;

  // link 15 (right_shoulder2), bias force
  const Real qdd_0_p34 = qdd_0_p32 + s16 * qdd_0_p31 - c16 * qdd_0_p33;
  const Real qdd_0_p35 = c16 * qdd_0_p26 + s16 * qdd_0_p30 + inverse_D5_p140 * qdd_0_p34;
  const Real qdd_0_p36 = c17 * qdd_0_p28 + s17 * qdd_0_p27 + inverse_D5_p131 * qdd_0_p25 -
      inverse_D5_p137 * qdd_0_p34;
  const Real qdd_0_p37 = c16 * qdd_0_p31 + s16 * qdd_0_p33 + inverse_D14_p1 * qdd_0_p34;

  // link 15 (right_shoulder2), outward
  const Real n15_y_p1 = w15_z * w15_z;
  const Real n15_y_p2 = minus_wd15_x - n15_z_p4;
  const Real n15_y_p3 = wd14_x - n15_z_p6;
  const Real n15_y_p4 = minus_wd15_y + n15_z_p3;

  // link 16 (right_upperarm), inward
  const Real n15_y_p5 = 0.00010499999999999999 * (n15_z_p1 - n15_y_p1) - 5.2499999999999995e-05 *
      n15_y_p2 + 1.75e-05 * n15_y_p3 - 0.18113119219699997 * n15_y_p4;
  const Real n15_y = n15_y_p5 + 0.7139200499999999 * minus_a14_x - c16 * minus_n16_y - s16 *
      minus_n16_x;

  // link 14 (right_shoulder1), inertial wrench
  const Real minus_n14_z_p1 = 0.0017499999999999998 * minus_a14_x;

  // link 14 (right_shoulder1), outward
  const Real minus_n14_z_p2 = w14_x * w14_x;
  const Real minus_n14_z_p3 = minus_w14_y * minus_w14_y;

  // link 7 (left_shoulder1), inertial wrench
  const Real minus_n14_z_p4 = 0.00044800000000000005 * minus_wd6_y;

  // link 14 (right_shoulder1), outward
  const Real minus_n14_z_p5 = w14_x * minus_w14_y;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_z_p6 = minus_n14_z_p1 + (minus_n14_z_p4 + 8.75e-06 *
      (minus_n14_z_p2 - minus_n14_z_p3) + 0.00014700000000000002 * minus_n14_z_p5) -
      0.0017499999999999998 * a14_y;

  // link 15 (right_shoulder2), outward
  const Real n15_x_p1 = wd14_x + n15_z_p6;

  // link 16 (right_upperarm), inward
  const Real n15_x_p2 = minus_n14_z_p1 + 1.75e-05 * (n15_z_p2 - n15_y_p1) - 0.00010499999999999999 *
      n15_x_p1 - 5.2499999999999995e-05 * n15_y_p4 - 0.00012075 * n15_y_p2;
  const Real n15_x = minus_n16_z + n15_x_p2;

  // link 14 (right_shoulder1), outward
  const Real minus_n14_z_p7 = w14_x * w14_z;
  const Real minus_n14_z_p8 = minus_w14_y * w14_z;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_z = 2.6249999999999998e-05 *
      (minus_wd14_y - minus_n14_z_p7 - (wd14_x + minus_n14_z_p8)) +
      (minus_n14_z_p6 - c15 * n15_y - s15 * n15_x);

  // link 1 (calf), inward
  const Real qdd_0_p38 = tau[13] + minus_n14_z;

  // link 15 (right_shoulder2), articulated inertia
  const Real qdd_0_p39 = 0.00010499999999999999 / inverse_D15_p9;

  // link 15 (right_shoulder2), bias force
  const Real qdd_0_p40 = qdd_0_p24 + qdd_0_p39 * qdd_0_p34;

  // link 14 (right_shoulder1), bias force
  const Real qdd_0_p41 = qdd_0_p38 - c15 * qdd_0_p37 + s15 * qdd_0_p40;
  const Real qdd_0_p42 = s15 * qdd_0_p35 + c15 * qdd_0_p36 + inverse_D5_p147 * qdd_0_p41;
  const Real qdd_0_p43 = s16 * qdd_0_p26 - c16 * qdd_0_p30 + inverse_D5_p121 * qdd_0_p34 -
      inverse_D5_p127 * qdd_0_p41;
  const Real qdd_0_p44 = c14 * qdd_0_p42 + s14 * qdd_0_p43;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p1 = a14_y_p5 + (minus_a6_z + a14_y_p3);
  const Real a7_y_p2 = a14_y_p11 + (a6_x - a14_y_p8);
  const Real a7_y = s7 * a7_y_p1 + c7 * a7_y_p2;
  const Real minus_a7_z = minus_a14_z_p4 - (a6_y - minus_a14_z_p2);

  // link 8 (left_shoulder2), outward
  const Real minus_a8_x = s8 * minus_a7_z - c8 * a7_y;

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
  const Real minus_a7_x = c7 * a7_y_p1 - s7 * a7_y_p2;

  // link 8 (left_shoulder2), outward
  const Real minus_a8_y = c8 * minus_a7_z + s8 * a7_y;

  // link 9 (left_upperarm), outward
  const Real minus_a9_x = c9 * minus_a7_x + s9 * minus_a8_y;

  // link 7 (left_shoulder1), outward
  const Real wd7_x = c7 * wd5_x - s7 * minus_wd6_x - qd[6] * minus_w7_y;
  const Real minus_wd7_y = s7 * wd5_x + c7 * minus_wd6_x + qd[6] * w7_x;

  // link 8 (left_shoulder2), outward
  const Real w8_x = s8 * w7_z - c8 * minus_w7_y;
  const Real minus_wd8_y = c8 * minus_wd6_y - s8 * minus_wd7_y + qd[7] * w8_x;

  // link 9 (left_upperarm), outward
  const Real minus_wd9_y = s9 * wd7_x + c9 * minus_wd8_y + qd[8] * w9_x;
  const Real w9_z = qd[8] - w8_x;
  const Real minus_a10_y_p4 = w9_x * w9_z;
  const Real minus_a10_y_p5 = minus_wd9_y - minus_a10_y_p4;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_y_p6 = minus_a9_x - 0.282 * minus_a10_y_p5;
  const Real minus_a10_y = c10 * minus_a10_y_p3 - s10 * minus_a10_y_p6;
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
  const Real minus_a10_x = s10 * minus_a10_y_p3 + c10 * minus_a10_y_p6;

  // link 9 (left_upperarm), outward
  const Real a9_y = s9 * minus_a7_x - c9 * minus_a8_y;
  const Real wd9_x = c9 * wd7_x - s9 * minus_wd8_y - qd[8] * minus_w9_y;
  const Real a10_z_p1 = minus_w9_y * w9_z;
  const Real a10_z_p2 = wd9_x + a10_z_p1;

  // link 10 (left_lowerarm), outward
  const Real a10_z = a9_y + 0.282 * a10_z_p2;

  // link 11 (left_wrist1), outward
  const Real a11_x = s11 * a10_z - c11 * minus_a10_x;

  // link 8 (left_shoulder2), outward
  const Real minus_wd8_x = s8 * minus_wd6_y + c8 * minus_wd7_y - qd[7] * w8_y;

  // link 10 (left_lowerarm), outward
  const Real minus_w10_y = c10 * w9_z + s10 * w9_x;
  const Real minus_wd10_x = s10 * minus_wd8_x - c10 * wd9_x + qd[9] * minus_w10_y;

  // link 11 (left_wrist1), outward
  const Real minus_wd11_y = c11 * minus_wd9_y - s11 * minus_wd10_x + qd[10] * w11_x;
  const Real w11_z = qd[10] + minus_w10_y;
  const Real minus_a12_y_p4 = w11_x * w11_z;
  const Real minus_a12_y_p5 = minus_wd11_y - minus_a12_y_p4;

  // link 12 (left_wrist2), outward
  const Real minus_a12_y_p6 = a11_x + 0.269 * minus_a12_y_p5;
  const Real minus_a12_y = c12 * minus_a12_y_p3 + s12 * minus_a12_y_p6;

  // link 11 (left_wrist1), outward
  const Real a11_y = c11 * a10_z + s11 * minus_a10_x;
  const Real minus_wd11_x = s11 * minus_wd9_y + c11 * minus_wd10_x - qd[10] * w11_y;
  const Real a12_z_p1 = w11_y * w11_z;
  const Real a12_z_p2 = minus_wd11_x + a12_z_p1;

  // link 12 (left_wrist2), outward
  const Real a12_z = a11_y - 0.269 * a12_z_p2;

  // link 13 (left_hand), outward
  const Real a13_x = s13 * a12_z - c13 * minus_a12_y;

  // link 12 (left_wrist2), outward
  const Real w12_z = qd[11] + w11_y;
  const Real minus_w12_y = c12 * w11_z + s12 * w11_x;

  // link 13 (left_hand), outward
  const Real w13_x = s13 * w12_z - c13 * minus_w12_y;
  const Real n13_z_p1 = w13_x * w13_x;
  const Real w13_y = c13 * w12_z + s13 * minus_w12_y;
  const Real n13_z_p2 = w13_y * w13_y;

  // link 10 (left_lowerarm), outward
  const Real minus_wd10_y = c10 * minus_wd8_x + s10 * wd9_x - qd[9] * minus_w10_x;

  // link 12 (left_wrist2), outward
  const Real minus_w12_x = s12 * w11_z - c12 * w11_x;
  const Real minus_wd12_y = c12 * minus_wd10_y - s12 * minus_wd11_x - qd[11] * minus_w12_x;

  // link 13 (left_hand), outward
  const Real minus_wd13_y = c13 * minus_wd11_y - s13 * minus_wd12_y + qd[12] * w13_x;
  const Real w13_z = qd[12] - minus_w12_x;
  const Real n13_z_p3 = w13_x * w13_z;
  const Real minus_wd13_x = s13 * minus_wd11_y + c13 * minus_wd12_y - qd[12] * w13_y;
  const Real n13_z_p4 = w13_y * w13_z;

  // link 13 (left_hand), inertial wrench
  const Real n13_z_p5 = 0.0001263900573325125 * (n13_z_p1 - n13_z_p2) - 4.38600177048965e-05 *
      (minus_wd13_y - n13_z_p3) + 0.000108260010923775 * (minus_wd13_x + n13_z_p4);

  // link 12 (left_wrist2), outward
  const Real minus_wd12_x = s12 * minus_wd10_y + c12 * minus_wd11_x + qd[11] * minus_w12_y;

  // link 13 (left_hand), outward
  const Real n13_z_p6 = w13_x * w13_y;
  const Real a13_y = c13 * a12_z + s13 * minus_a12_y;

  // link 13 (left_hand), inertial wrench
  const Real n13_z = n13_z_p5 - 0.0009386316083993107 * minus_wd12_x + 0.0007556474228594393 *
      n13_z_p6 + 0.002865001425 * a13_x + 0.01626499875 * a13_y;

  // link 1 (calf), inward
  const Real qdd_0_p45 = tau[12] - n13_z;

  // link 13 (left_hand), bias force
  const Real qdd_0_p46 = 17.32841575379867 * qdd_0_p45;
  const Real qdd_0_p47 = 3.0523172236718206 * qdd_0_p45;

  // link 12 (left_wrist2), outward
  const Real minus_a12_x = s12 * minus_a12_y_p3 - c12 * minus_a12_y_p6;
  const Real n12_z_p1 = minus_w12_x * w12_z;
  const Real n12_z_p2 = minus_w12_x * minus_w12_y;

  // link 13 (left_hand), inward
  const Real n12_z_p3 = 2.4000000000000003e-06 * (minus_wd12_y + n12_z_p1) -
      0.00020682766225734302 * minus_wd11_y + 0.000183627662257343 * n12_z_p2 +
      0.0006000000000000001 * minus_a12_x;

  // link 13 (left_hand), outward
  const Real n13_y_p1 = w13_z * w13_z;
  const Real n13_y_p2 = minus_wd13_x - n13_z_p4;
  const Real n13_y_p3 = minus_wd12_x + n13_z_p6;
  const Real n13_y_p4 = minus_wd13_y + n13_z_p3;

  // link 13 (left_hand), inertial wrench
  const Real n13_y_p5 = 0.000108260010923775 * (n13_z_p1 - n13_y_p1) - 0.0001263900573325125 *
      n13_y_p2 - 4.38600177048965e-05 * n13_y_p3 - 0.000847139515629375 * n13_y_p4;
  const Real n13_y = n13_y_p5 + 0.01626499875 * minus_a12_x;

  // link 13 (left_hand), outward
  const Real n13_x_p1 = minus_wd12_x - n13_z_p6;

  // link 13 (left_hand), inertial wrench
  const Real n13_x_p2 = 4.38600177048965e-05 * (n13_z_p2 - n13_y_p1) + 0.000108260010923775 *
      n13_x_p1 - 0.0001263900573325125 * n13_y_p4 - 9.149209276993575e-05 * n13_y_p2;
  const Real n13_x = n13_x_p2 + 0.002865001425 * minus_a12_x;

  // link 13 (left_hand), inward
  const Real n12_z = n12_z_p3 - 0.0025100003499999995 * minus_a12_y + c13 * n13_y + s13 * n13_x;

  // link 1 (calf), inward
  const Real qdd_0_p48 = tau[11] - n12_z;

  // link 13 (left_hand), bias force
  const Real qdd_0_p49 = 0.04672761636452121 * qdd_0_p45;
  const Real qdd_0_p50 = 0.11533812622014242 * qdd_0_p45;

  // link 12 (left_wrist2), bias force
  const Real qdd_0_p51 = qdd_0_p48 - c13 * qdd_0_p49 + s13 * qdd_0_p50;
  const Real qdd_0_p52 = c13 * qdd_0_p46 + s13 * qdd_0_p47 - inverse_D5_p196 * qdd_0_p51;
  const Real qdd_0_p53 = s13 * qdd_0_p49 + c13 * qdd_0_p50 + inverse_D11_p1 * qdd_0_p51;

  // link 12 (left_wrist2), outward
  const Real n12_y_p1 = minus_wd11_y + n12_z_p2;
  const Real n12_y_p2 = minus_wd12_y - n12_z_p1;

  // link 13 (left_hand), inward
  const Real n12_y = 2.4000000000000003e-06 * n12_y_p1 - 0.000195227662257343 * n12_y_p2 -
      0.0025100003499999995 * a12_z - s13 * n13_y + c13 * n13_x;

  // link 12 (left_wrist2), inward
  const Real minus_n11_z_p1 = 6e-06 * (minus_a12_y_p1 - minus_a12_y_p2) + 0.0002516 *
      minus_a12_y_p5 + 0.000144 * a12_z_p2 - 0.0002292 * minus_wd10_y;

  // link 11 (left_wrist1), outward
  const Real minus_n11_z_p2 = w11_x * w11_y;

  // link 12 (left_wrist2), inward
  const Real minus_n11_z_p3 = minus_n11_z_p1 + 9.600000000000003e-06 * minus_n11_z_p2 + 0.001 *
      a11_x - 6e-04 * a11_y + c12 * n12_y;

  // link 12 (left_wrist2), outward
  const Real n12_x_p1 = minus_w12_y * minus_w12_y;
  const Real n12_x_p2 = w12_z * w12_z;
  const Real n12_x_p3 = minus_wd12_x + minus_w12_y * w12_z;

  // link 13 (left_hand), inward
  const Real n12_x = n13_z - (2.4000000000000003e-06 * (n12_x_p1 - n12_x_p2) + 1.16e-05 * n12_x_p3 -
      0.0006000000000000001 * a12_z);

  // link 12 (left_wrist2), inward
  const Real minus_n11_z = minus_n11_z_p3 + s12 * n12_x;

  // link 1 (calf), inward
  const Real qdd_0_p54 = tau[10] + minus_n11_z;

  // link 11 (left_wrist1), bias force
  const Real qdd_0_p55 = qdd_0_p54 - c12 * qdd_0_p53 + s12 * qdd_0_p45;
  const Real qdd_0_p56 = qdd_0_p52 + inverse_D5_p239 * qdd_0_p55;

  // link 12 (left_wrist2), bias force
  const Real qdd_0_p57 = s13 * qdd_0_p46 - c13 * qdd_0_p47 - inverse_D5_p190 * qdd_0_p51;
  const Real qdd_0_p58 = inverse_D5_p184 * qdd_0_p51;
  const Real qdd_0_p59 = s12 * qdd_0_p57 - c12 * qdd_0_p58;

  // link 11 (left_wrist1), bias force
  const Real qdd_0_p60 = qdd_0_p59 - inverse_D5_p236 * qdd_0_p55;
  const Real qdd_0_p61 = qdd_0_p48 - 0.269 * qdd_0_p59 + inverse_D5_p205 * qdd_0_p55;

  // link 13 (left_hand), inertial wrench
  const Real f13_y = 0.002865001425 * (n13_z_p1 + n13_y_p1) - 0.01626499875 * n13_x_p1;
  const Real minus_f13_x = 0.002865001425 * n13_y_p3 + 0.01626499875 * (n13_z_p2 + n13_y_p1);

  // link 13 (left_hand), inward
  const Real minus_f12_z = 0.0006000000000000001 * n12_x_p3 - 0.0025100003499999995 * n12_y_p2 -
      c13 * f13_y + s13 * minus_f13_x;

  // link 11 (left_wrist1), outward
  const Real n11_x_p1 = w11_z * w11_z;
  const Real n11_x_p2 = minus_wd10_y + minus_n11_z_p2;
  const Real n11_x_p3 = minus_wd11_y + minus_a12_y_p4;
  const Real n11_x_p4 = minus_wd11_x - a12_z_p1;

  // link 12 (left_wrist2), inward
  const Real n11_x_p5 = 0.0002516 * (minus_a12_y_p2 - n11_x_p1) + 0.000144 * n11_x_p2 + 6e-06 *
      n11_x_p3 - 0.0001194 * n11_x_p4;
  const Real n11_x = n11_x_p5 + 0.001 * minus_a10_y - 0.269 * minus_f12_z - s12 * n12_y + c12 *
      n12_x;

  // link 11 (left_wrist1), outward
  const Real n11_y_p1 = minus_wd10_y - minus_n11_z_p2;

  // link 12 (left_wrist2), inward
  const Real n11_y_p2 = 0.000144 * (minus_a12_y_p1 - n11_x_p1) - 6e-06 * n11_x_p4 - 0.0002516 *
      n11_y_p1 + 0.0001098 * n11_x_p3;

  // link 13 (left_hand), inward
  const Real minus_f12_y_p1 = 0.0006000000000000001 * (n12_x_p2 + minus_w12_x * minus_w12_x) +
      0.0025100003499999995 * (minus_wd11_y - n12_z_p2) + s13 * f13_y;
  const Real minus_f12_y = minus_f12_y_p1 + c13 * minus_f13_x;
  const Real f12_x = 0.0006000000000000001 * n12_y_p1 - 0.0025100003499999995 *
      (n12_x_p1 + n12_x_p2) + 0.002865001425 * n13_y_p2 + 0.01626499875 * n13_y_p4;

  // link 12 (left_wrist2), inward
  const Real n11_y_p3 = s12 * minus_f12_y + c12 * f12_x;
  const Real n11_y = n12_z - (n11_y_p2 + 6e-04 * minus_a10_y) - 0.269 * n11_y_p3;

  // link 10 (left_lowerarm), outward
  const Real n10_z_p1 = minus_w10_y * w10_z;
  const Real n10_z_p2 = minus_w10_x * minus_w10_y;

  // link 11 (left_wrist1), inward
  const Real n10_z_p3 = 2.249994685315e-05 * (minus_wd10_x - n10_z_p1) - 0.060888541114265754 *
      minus_wd9_y - 0.06032654142055946 * n10_z_p2 + 0.28049749700000004 * minus_a10_x;

  // link 10 (left_lowerarm), outward
  const Real n10_z_p4 = minus_w10_x * w10_z;
  const Real n10_z_p5 = minus_w10_x * minus_w10_x;
  const Real n10_z_p6 = minus_w10_y * minus_w10_y;

  // link 11 (left_wrist1), inward
  const Real n10_z = 0.0001499998887063 * (minus_wd10_y + n10_z_p4 - (n10_z_p5 - n10_z_p6)) +
      (n10_z_p3 - 0.0014999985000000002 * minus_a10_y + c11 * n11_y + s11 * n11_x);

  // link 1 (calf), inward
  const Real qdd_0_p62 = tau[9] - n10_z;

  // link 11 (left_wrist1), bias force
  const Real qdd_0_p63 = 0.269 * qdd_0_p52 + s12 * qdd_0_p53 + c12 * qdd_0_p45 + inverse_D5_p211 *
      qdd_0_p55;

  // link 10 (left_lowerarm), bias force
  const Real qdd_0_p64 = qdd_0_p62 - c11 * qdd_0_p61 - s11 * qdd_0_p63;
  const Real qdd_0_p65 = c11 * qdd_0_p56 + s11 * qdd_0_p60 - inverse_D5_p246 * qdd_0_p64;
  const Real qdd_0_p66 = s11 * qdd_0_p61 - c11 * qdd_0_p63 - inverse_D5_p231 * qdd_0_p64;
  const Real qdd_0_p67 = qdd_0_p54 - inverse_D5_p228 * qdd_0_p64;

  // link 10 (left_lowerarm), outward
  const Real n10_y_p1 = w10_z * w10_z;
  const Real n10_y_p2 = minus_wd10_y - n10_z_p4;
  const Real n10_y_p3 = minus_wd9_y + n10_z_p2;
  const Real n10_y_p4 = minus_wd10_x + n10_z_p1;

  // link 11 (left_wrist1), inward
  const Real n10_y = 0.0001499998887063 * (n10_y_p3 + n10_y_p4) +
      (minus_n11_z + (2.249994685315e-05 * (n10_z_p5 - n10_y_p1) - 0.00028099984685315 * n10_y_p2 -
      0.0014999985000000002 * a10_z));

  // link 10 (left_lowerarm), inward
  const Real n9_z_p1 = 4.4999986458742003e-05 * (minus_a10_y_p1 - minus_a10_y_p2) -
      0.0012089992423205001 * minus_a10_y_p5 - 0.0005895000784280001 * a10_z_p2 +
      0.0027762933559338653 * minus_wd8_x;

  // link 9 (left_upperarm), outward
  const Real n9_z_p2 = w9_x * minus_w9_y;

  // link 10 (left_lowerarm), inward
  const Real n9_z_p3 = n9_z_p1 + 0.001140794814995722 * n9_z_p2 + 0.004500002325 * minus_a9_x -
      0.0022500062 * a9_y - c10 * n10_y;

  // link 10 (left_lowerarm), outward
  const Real n10_x_p1 = minus_wd9_y - n10_z_p2;

  // link 11 (left_wrist1), inward
  const Real n10_x_p2 = 2.249994685315e-05 * n10_x_p1 - 0.06060754126741261 * n10_y_p4 +
      0.28049749700000004 * a10_z - s11 * n11_y + c11 * n11_x;
  const Real n10_x = 0.0001499998887063 * (n10_y_p2 - (n10_z_p6 - n10_y_p1)) + n10_x_p2;

  // link 10 (left_lowerarm), inward
  const Real n9_z = n9_z_p3 - s10 * n10_x;

  // link 1 (calf), inward
  const Real qdd_0_p68 = tau[8] - n9_z;

  // link 9 (left_upperarm), bias force
  const Real qdd_0_p69 = qdd_0_p68 - c10 * qdd_0_p67 - s10 * qdd_0_p66;
  const Real qdd_0_p70 = qdd_0_p65 + inverse_D5_p253 * qdd_0_p69;

  // link 10 (left_lowerarm), bias force
  const Real qdd_0_p71 = s11 * qdd_0_p56 - c11 * qdd_0_p60 + inverse_D5_p264 * qdd_0_p64;
  const Real qdd_0_p72 = c12 * qdd_0_p57 + s12 * qdd_0_p58 + inverse_D5_p268 * qdd_0_p55 +
      inverse_D5_p273 * qdd_0_p64;
  const Real qdd_0_p73 = s10 * qdd_0_p72 - c10 * qdd_0_p71;

  // link 9 (left_upperarm), bias force
  const Real qdd_0_p74 = qdd_0_p73 + inverse_D5_p281 * qdd_0_p69;
  const Real qdd_0_p75 = qdd_0_p62 - 0.282 * qdd_0_p73 - minus_inverse_D8_p1 * qdd_0_p69;

  // link 12 (left_wrist2), inward
  const Real minus_f11_y = minus_f12_z + (0.001 * (minus_a12_y_p1 + n11_x_p1) - 6e-04 * n11_x_p2);
  const Real f11_x = n11_y_p3 - (0.001 * n11_y_p1 + 6e-04 * (minus_a12_y_p2 + n11_x_p1));

  // link 11 (left_wrist1), inward
  const Real minus_f10_z = 0.28049749700000004 * n10_y_p4 - 0.0014999985000000002 * n10_y_p2 + c11 *
      minus_f11_y - s11 * f11_x;

  // link 9 (left_upperarm), outward
  const Real n9_x_p1 = w9_z * w9_z;
  const Real n9_x_p2 = minus_wd8_x - n9_z_p2;
  const Real n9_x_p3 = minus_wd9_y + minus_a10_y_p4;
  const Real n9_x_p4 = wd9_x - a10_z_p1;

  // link 10 (left_lowerarm), inward
  const Real n9_x_p5 = 0.0012089992423205001 * (minus_a10_y_p2 - n9_x_p1) - 0.0005895000784280001 *
      n9_x_p2 - 4.4999986458742003e-05 * n9_x_p3 + 0.0019585440854647937 * n9_x_p4;
  const Real n9_x = n9_x_p5 + 0.004500002325 * minus_a8_x - 0.282 * minus_f10_z - s10 * n10_y +
      c10 * n10_x;

  // link 9 (left_upperarm), outward
  const Real n9_y_p1 = minus_wd8_x + n9_z_p2;

  // link 10 (left_lowerarm), inward
  const Real n9_y_p2 = 0.0005895000784280001 * (minus_a10_y_p1 - n9_x_p1) + 4.4999986458742003e-05 *
      n9_x_p4 + 0.0012089992423205001 * n9_y_p1 - 0.0008177492704690715 * n9_x_p3;

  // link 11 (left_wrist1), inward
  const Real f10_x = 0.28049749700000004 * n10_y_p3 - 0.0014999985000000002 *
      (n10_z_p6 + n10_y_p1) + s11 * minus_f11_y + c11 * f11_x;
  const Real minus_f10_y_p1 = 0.28049749700000004 * (n10_z_p5 + n10_y_p1) + 0.0014999985000000002 *
      n10_x_p1 - 0.001 * n11_x_p4 + 6e-04 * n11_x_p3;
  const Real minus_f10_y = minus_f10_y_p1 + c12 * minus_f12_y - s12 * f12_x;

  // link 10 (left_lowerarm), inward
  const Real n9_y_p3 = s10 * minus_f10_y + c10 * f10_x;
  const Real n9_y = n10_z + (n9_y_p2 + 0.0022500062 * minus_a8_x) - 0.282 * n9_y_p3;

  // link 8 (left_shoulder2), outward
  const Real minus_n8_z_p1 = w8_x * w8_x;
  const Real minus_n8_z_p2 = w8_y * w8_y;
  const Real minus_n8_z_p3 = w8_x * w8_z;
  const Real minus_n8_z_p4 = w8_y * w8_z;

  // link 9 (left_upperarm), inward
  const Real minus_n8_z_p5 = 5.2499999999999995e-05 * (minus_n8_z_p1 - minus_n8_z_p2) - 1.75e-05 *
      (minus_wd8_y - minus_n8_z_p3) - 0.00010499999999999999 * (minus_wd8_x + minus_n8_z_p4);

  // link 8 (left_shoulder2), outward
  const Real minus_n8_z_p6 = w8_x * w8_y;

  // link 9 (left_upperarm), inward
  const Real minus_n8_z_p7 = minus_n8_z_p5 - 0.18125194219699997 * wd7_x - 0.18101044219699997 *
      minus_n8_z_p6 - 0.0017499999999999998 * minus_a8_x + 0.7139200499999999 * minus_a8_y;
  const Real minus_n8_z = minus_n8_z_p7 + s9 * n9_y - c9 * n9_x;

  // link 1 (calf), inward
  const Real qdd_0_p76 = tau[7] + minus_n8_z;

  // link 9 (left_upperarm), bias force
  const Real qdd_0_p77 = 0.282 * qdd_0_p65 + s10 * qdd_0_p67 - c10 * qdd_0_p66 +
      minus_inverse_D8_p4 * qdd_0_p69;

  // link 8 (left_shoulder2), bias force
  const Real qdd_0_p78 = qdd_0_p76 + s9 * qdd_0_p75 - c9 * qdd_0_p77;
  const Real qdd_0_p79 = c9 * qdd_0_p70 + s9 * qdd_0_p74 + inverse_D5_p322 * qdd_0_p78;
  const Real qdd_0_p80 = c10 * qdd_0_p72 + s10 * qdd_0_p71 + inverse_D5_p313 * qdd_0_p69 -
      inverse_D5_p319 * qdd_0_p78;
  const Real qdd_0_p81 = c9 * qdd_0_p75 + s9 * qdd_0_p77 + minus_inverse_D7_p1 * qdd_0_p78;

  // link 8 (left_shoulder2), outward
  const Real n8_y_p1 = w8_z * w8_z;
  const Real n8_y_p2 = minus_wd8_x - minus_n8_z_p4;
  const Real n8_y_p3 = wd7_x - minus_n8_z_p6;
  const Real n8_y_p4 = minus_wd8_y + minus_n8_z_p3;

  // link 9 (left_upperarm), inward
  const Real n8_y_p5 = 0.00010499999999999999 * (minus_n8_z_p1 - n8_y_p1) + 5.2499999999999995e-05 *
      n8_y_p2 - 1.75e-05 * n8_y_p3 - 0.18113119219699997 * n8_y_p4;
  const Real n8_y = n8_y_p5 + 0.7139200499999999 * minus_a7_x + c9 * n9_y + s9 * n9_x;

  // link 7 (left_shoulder1), inertial wrench
  const Real n7_z_p1 = 0.0017499999999999998 * minus_a7_x;

  // link 7 (left_shoulder1), outward
  const Real n7_z_p2 = w7_x * w7_x;
  const Real n7_z_p3 = minus_w7_y * minus_w7_y;
  const Real n7_z_p4 = w7_x * minus_w7_y;

  // link 8 (left_shoulder2), inward
  const Real n7_z_p5 = n7_z_p1 + (minus_n14_z_p4 + 8.75e-06 * (n7_z_p2 - n7_z_p3) +
      0.00014700000000000002 * n7_z_p4) - 0.0017499999999999998 * a7_y;

  // link 8 (left_shoulder2), outward
  const Real minus_n8_x_p1 = wd7_x + minus_n8_z_p6;

  // link 9 (left_upperarm), inward
  const Real minus_n8_x_p2 = n7_z_p1 + 1.75e-05 * (minus_n8_z_p2 - n8_y_p1) +
      0.00010499999999999999 * minus_n8_x_p1 - 5.2499999999999995e-05 * n8_y_p4 + 0.00012075 *
      n8_y_p2;
  const Real minus_n8_x = n9_z + minus_n8_x_p2;

  // link 7 (left_shoulder1), outward
  const Real n7_z_p6 = w7_x * w7_z;
  const Real n7_z_p7 = minus_w7_y * w7_z;

  // link 8 (left_shoulder2), inward
  const Real n7_z = 2.6249999999999998e-05 * (minus_wd7_y - n7_z_p6 - (wd7_x + n7_z_p7)) -
      (n7_z_p5 - c8 * n8_y + s8 * minus_n8_x);

  // link 1 (calf), inward
  const Real qdd_0_p82 = tau[6] - n7_z;

  // link 8 (left_shoulder2), articulated inertia
  const Real qdd_0_p83 = 0.00010499999999999999 / minus_inverse_D8_p9;

  // link 8 (left_shoulder2), bias force
  const Real qdd_0_p84 = qdd_0_p68 - qdd_0_p83 * qdd_0_p78;

  // link 7 (left_shoulder1), bias force
  const Real qdd_0_p85 = qdd_0_p82 - c8 * qdd_0_p81 + s8 * qdd_0_p84;
  const Real qdd_0_p86 = s8 * qdd_0_p79 + c8 * qdd_0_p80 - inverse_D5_p329 * qdd_0_p85;
  const Real qdd_0_p87 = s9 * qdd_0_p70 - c9 * qdd_0_p74 + inverse_D5_p303 * qdd_0_p78 +
      inverse_D5_p309 * qdd_0_p85;
  const Real qdd_0_p88 = c7 * qdd_0_p86 + s7 * qdd_0_p87;

  // link 14 (right_shoulder1), bias force
  const Real qdd_0_p89 = c15 * qdd_0_p35 - s15 * qdd_0_p36 + inverse_D5_p177 * qdd_0_p41;

  // link 7 (left_shoulder1), bias force
  const Real qdd_0_p90 = c8 * qdd_0_p79 - s8 * qdd_0_p80 + inverse_D5_p359 * qdd_0_p85;

  // link 14 (right_shoulder1), bias force
  const Real qdd_0_p91 = s15 * qdd_0_p37 + c15 * qdd_0_p40 + inverse_D5_p365 * qdd_0_p41;

  // link 14 (right_shoulder1), inertial wrench
  const Real minus_n14_y_p1 = 0.0017499999999999998 * minus_a14_z;

  // link 14 (right_shoulder1), outward
  const Real minus_n14_y_p2 = wd14_x - minus_n14_z_p8;
  const Real minus_n14_y_p3 = minus_wd14_y + minus_n14_z_p7;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_y_p4 = minus_n14_y_p1 - (8.75e-06 * minus_n14_y_p2 + 0.0002975 *
      minus_n14_y_p3) - s15 * n15_y + c15 * n15_x;

  // link 14 (right_shoulder1), outward
  const Real minus_n14_y_p5 = minus_wd6_y - minus_n14_z_p5;
  const Real minus_n14_y_p6 = w14_z * w14_z;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_y = 2.6249999999999998e-05 *
      (minus_n14_y_p5 + (minus_n14_z_p2 - minus_n14_y_p6)) - minus_n14_y_p4;

  // link 21 (neck), outward
  const Real w21_x = c21 * w6_z + s21 * w6_y;
  const Real a22_x_p1 = w21_x * w21_x;
  const Real minus_w21_y = s21 * w6_z - c21 * w6_y;
  const Real a22_x_p2 = minus_w21_y * minus_w21_y;

  // link 22 (head), outward
  const Real a22_x_p3 = a6_x + 0.394 * (a22_x_p1 + a22_x_p2);

  // link 21 (neck), outward
  const Real minus_wd21_y = s21 * wd5_x + c21 * minus_wd6_y + qd[20] * w21_x;
  const Real w21_z = qd[20] - w6_x;
  const Real a22_x_p4 = w21_x * w21_z;

  // link 22 (head), outward
  const Real a22_x_p5 = c21 * minus_a6_z - s21 * a6_y + 0.394 * (minus_wd21_y - a22_x_p4);
  const Real a22_x = s22 * a22_x_p3 - c22 * a22_x_p5;
  const Real minus_w22_x = s22 * w21_z - c22 * w21_x;
  const Real minus_n22_z_p1 = minus_w22_x * minus_w22_x;
  const Real minus_w22_y = c22 * w21_z + s22 * w21_x;
  const Real minus_n22_z_p2 = minus_w22_y * minus_w22_y;
  const Real minus_n22_z_p3 = minus_w22_x * minus_w22_y;

  // link 23 (left_eye), inward
  const Real minus_n22_z_p4 = 0.0074 * (minus_n22_z_p1 - minus_n22_z_p2) - 0.06394132500000001 *
      minus_wd21_y - 0.04506407500000001 * minus_n22_z_p3 + 0.43200000000000005 * a22_x;

  // link 22 (head), outward
  const Real a22_y = c22 * a22_x_p3 + s22 * a22_x_p5;
  const Real w22_z = qd[21] - minus_w21_y;

  // link 24 (right_eye), outward
  const Real w24_x = s24 * w22_z - c24 * minus_w22_x;
  const Real w24_z = qd[23] + minus_w22_y;
  const Real minus_n24_y_p1 = w24_z * w24_z;

  // link 21 (neck), outward
  const Real wd21_x = c21 * wd5_x - s21 * minus_wd6_y - qd[20] * minus_w21_y;

  // link 22 (head), outward
  const Real minus_wd22_x = s22 * minus_wd6_x - c22 * wd21_x + qd[21] * minus_w22_y;

  // link 24 (right_eye), outward
  const Real minus_n24_y_p2 = w24_x * (qd[23] + w24_z) + (c24 * minus_wd21_y - s24 * minus_wd22_x);

  // link 22 (head), outward
  const Real a24_z_p1 = minus_w22_y * w22_z;

  // link 23 (left_eye), outward
  const Real a24_z_p2 = 0.032 * (minus_wd22_x - a24_z_p1);

  // link 22 (head), outward
  const Real a24_z_p3 = minus_wd21_y - minus_n22_z_p3;

  // link 23 (left_eye), outward
  const Real a24_z_p4 = 0.095 * a24_z_p3;

  // link 24 (right_eye), outward
  const Real a24_z = a24_z_p4 - (a22_y - a24_z_p2);

  // link 24 (right_eye), inertial wrench
  const Real minus_n24_y = 2.8750000000000004e-05 * (minus_n24_y_p1 - w24_x * w24_x) + 5.25e-06 *
      minus_n24_y_p2 + 0.00025 * a24_z;

  // link 24 (right_eye), outward
  const Real w24_y = c24 * w22_z + s24 * minus_w22_x;
  const Real minus_n24_x_p1 = w24_x * w24_y;

  // link 22 (head), outward
  const Real minus_wd22_y = c22 * minus_wd6_x + s22 * wd21_x - qd[21] * minus_w22_x;

  // link 24 (right_eye), outward
  const Real minus_n24_x_p2 = minus_wd22_y + minus_n24_x_p1;
  const Real minus_wd24_x = s24 * minus_wd21_y + c24 * minus_wd22_x - qd[23] * w24_y;
  const Real minus_n24_x_p3 = w24_y * w24_z;

  // link 24 (right_eye), inertial wrench
  const Real minus_n24_x = 2.8750000000000004e-05 * minus_n24_x_p2 + 4e-06 *
      (minus_wd24_x - minus_n24_x_p3);

  // link 23 (left_eye), outward
  const Real w23_x = s23 * w22_z - c23 * minus_w22_x;
  const Real w23_z = qd[22] + minus_w22_y;
  const Real minus_n23_y_p1 = w23_z * w23_z;
  const Real minus_n23_y_p2 = w23_x * (qd[22] + w23_z) + (c23 * minus_wd21_y - s23 * minus_wd22_x);
  const Real a23_z = a24_z_p4 - (a22_y + a24_z_p2);

  // link 23 (left_eye), inertial wrench
  const Real minus_n23_y = 2.8750000000000004e-05 * (minus_n23_y_p1 - w23_x * w23_x) + 5.25e-06 *
      minus_n23_y_p2 + 0.00025 * a23_z;

  // link 23 (left_eye), inward
  const Real minus_n22_z_p5 = minus_n22_z_p4 + 0.072575 * a22_y - c24 * minus_n24_y - s24 *
      minus_n24_x - c23 * minus_n23_y;

  // link 23 (left_eye), outward
  const Real w23_y = c23 * w22_z + s23 * minus_w22_x;
  const Real minus_n23_x_p1 = w23_x * w23_y;
  const Real minus_n23_x_p2 = minus_wd22_y + minus_n23_x_p1;
  const Real minus_wd23_x = s23 * minus_wd21_y + c23 * minus_wd22_x - qd[22] * w23_y;
  const Real minus_n23_x_p3 = w23_y * w23_z;

  // link 23 (left_eye), inertial wrench
  const Real minus_n23_x = 2.8750000000000004e-05 * minus_n23_x_p2 + 4e-06 *
      (minus_wd23_x - minus_n23_x_p3);

  // link 23 (left_eye), inward
  const Real minus_n22_z_p6 = minus_n23_y_p2 + minus_n24_y_p2;
  const Real minus_n22_z = 2.375e-05 * minus_n22_z_p6 - (minus_n22_z_p5 - s23 * minus_n23_x);

  // link 21 (neck), outward
  const Real minus_n21_y_p1 = w21_z * w21_z;
  const Real minus_n21_y_p2 = minus_wd21_y + a22_x_p4;

  // link 22 (head), outward
  const Real minus_f22_y_p1 = w22_z * w22_z;

  // link 23 (left_eye), inward
  const Real minus_f22_y = 0.00025 * minus_n22_z_p6 -
      (0.43200000000000005 * (minus_n22_z_p1 + minus_f22_y_p1) - 0.072575 * a24_z_p3);

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
  const Real minus_f22_x = minus_f22_x_p3 + (minus_f22_x_p1 +
      (0.43200000000000005 * (minus_wd21_y + minus_n22_z_p3) + 0.072575 * minus_f22_x_p2));

  // link 22 (head), inward
  const Real minus_n21_y_p3 = s22 * minus_f22_y - c22 * minus_f22_x;
  const Real minus_n21_y = minus_n22_z - (0.0016155 * (a22_x_p1 - minus_n21_y_p1) - 0.000703125 *
      minus_n21_y_p2 + 0.0045000000000000005 * a6_x) - 0.394 * minus_n21_y_p3;

  // link 7 (left_shoulder1), inward
  const Real minus_n6_z_p1 = 0.0187369177636143 * (minus_wd6_x + a14_y_p1) - 2.06965463592404 *
      wd5_x - 1.26882463592404 * a14_y_p7 + 6.1665928899999995 * a6_y;

  // link 21 (neck), outward
  const Real a21_y = s21 * minus_a6_z + c21 * a6_y;
  const Real a22_z_p1 = minus_w21_y * w21_z;
  const Real a22_z_p2 = wd21_x + a22_z_p1;

  // link 22 (head), outward
  const Real a22_z = a21_y - 0.394 * a22_z_p2;

  // link 23 (left_eye), outward
  const Real a23_y_p1 = 0.032 * (minus_n22_z_p1 + minus_n22_z_p2);

  // link 22 (head), outward
  const Real a23_y_p2 = minus_w22_x * w22_z;
  const Real a23_y_p3 = minus_wd22_y - a23_y_p2;

  // link 23 (left_eye), outward
  const Real a23_y_p4 = 0.095 * a23_y_p3;
  const Real a23_y_p5 = 0.032 * (minus_wd22_y + a23_y_p2);
  const Real a23_y_p6 = 0.095 * minus_f22_x_p2;
  const Real a23_y = c23 * (a23_y_p4 + (a22_z - a23_y_p1)) + s23 * (a23_y_p6 - (a22_x - a23_y_p5));

  // link 23 (left_eye), inertial wrench
  const Real n23_z_p1 = 9.25e-06 * minus_wd22_y;
  const Real n23_z = n23_z_p1 + 2.8750000000000004e-05 * (minus_wd23_x + minus_n23_x_p3) +
      1.2499999999999999e-06 * minus_n23_x_p1 + 0.00025 * a23_y;

  // link 24 (right_eye), outward
  const Real a24_y = c24 * (a23_y_p4 + (a22_z + a23_y_p1)) + s24 * (a23_y_p6 - (a22_x + a23_y_p5));

  // link 24 (right_eye), inertial wrench
  const Real n24_z = n23_z_p1 + 2.8750000000000004e-05 * (minus_wd24_x + minus_n24_x_p3) +
      1.2499999999999999e-06 * minus_n24_x_p1 + 0.00025 * a24_y;

  // link 22 (head), outward
  const Real minus_n22_y_p1 = minus_wd22_x + a24_z_p1;

  // link 23 (left_eye), inward
  const Real minus_n22_y_p2 = 0.032 * (minus_f22_x_p1 - minus_f22_x_p3) -
      (n23_z + (n24_z + (0.0074 * minus_n22_y_p1 + 0.009438624999999999 * a23_y_p3 + 0.072575 *
      a22_z)));

  // link 24 (right_eye), inward
  const Real minus_n22_y_p3 = c24 * f24_y - s24 * minus_f24_x;

  // link 23 (left_eye), inward
  const Real minus_n22_y_p4 = c23 * f23_y - s23 * minus_f23_x;
  const Real minus_n22_y = 0.095 * (minus_n22_y_p3 + minus_n22_y_p4) - minus_n22_y_p2;
  const Real f22_z = minus_n22_y_p4 + (minus_n22_y_p3 +
      (0.43200000000000005 * minus_n22_y_p1 + 0.072575 * a23_y_p3));

  // link 21 (neck), outward
  const Real minus_n21_x_p1 = w21_x * minus_w21_y;
  const Real minus_n21_x_p2 = minus_wd6_x - minus_n21_x_p1;

  // link 22 (head), inward
  const Real minus_n21_x_p3 = 0.0016155 * minus_n21_x_p2 - 0.005513625 * (wd21_x - a22_z_p1) +
      0.394 * f22_z - s22 * minus_n22_y;

  // link 23 (left_eye), inward
  const Real n22_x_p1 = 0.0074 * a23_y_p3 + 0.05450270000000001 * minus_n22_y_p1 +
      0.43200000000000005 * a22_z - s24 * minus_n24_y + c24 * minus_n24_x;
  const Real n22_x = 8e-06 * (minus_n23_y_p2 - minus_n24_y_p2) -
      (n22_x_p1 - s23 * minus_n23_y + c23 * minus_n23_x);

  // link 22 (head), inward
  const Real minus_n21_x = minus_n21_x_p3 - c22 * n22_x;

  // link 14 (right_shoulder1), outward
  const Real minus_n14_x_p1 = minus_wd6_y + minus_n14_z_p5;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_x = 2.6249999999999998e-05 *
      (minus_n14_x_p1 - (minus_n14_z_p3 - minus_n14_y_p6)) -
      (n15_z + (minus_n14_y_p1 + (8.75e-06 * minus_n14_y_p3 + 0.0001505 * minus_n14_y_p2)));

  // link 7 (left_shoulder1), inward
  const Real minus_n6_z_p2 = minus_n6_z_p1 - s21 * minus_n21_y + c21 * minus_n21_x - s14 *
      minus_n14_y + c14 * minus_n14_x;

  // link 7 (left_shoulder1), inertial wrench
  const Real n7_y_p1 = 0.0017499999999999998 * minus_a7_z;

  // link 7 (left_shoulder1), outward
  const Real n7_y_p2 = wd7_x - n7_z_p7;
  const Real n7_y_p3 = minus_wd7_y + n7_z_p6;

  // link 8 (left_shoulder2), inward
  const Real n7_y_p4 = n7_y_p1 - (8.75e-06 * n7_y_p2 + 0.0002975 * n7_y_p3) - s8 * n8_y - c8 *
      minus_n8_x;

  // link 7 (left_shoulder1), outward
  const Real n7_y_p5 = minus_wd6_y - n7_z_p4;
  const Real n7_y_p6 = w7_z * w7_z;

  // link 8 (left_shoulder2), inward
  const Real n7_y = 2.6249999999999998e-05 * (n7_y_p5 + (n7_z_p2 - n7_y_p6)) + n7_y_p4;

  // link 7 (left_shoulder1), outward
  const Real n7_x_p1 = minus_wd6_y + n7_z_p4;

  // link 8 (left_shoulder2), inward
  const Real n7_x = 2.6249999999999998e-05 * (n7_x_p1 - (n7_z_p3 - n7_y_p6)) -
      (minus_n8_z - (n7_y_p1 + (8.75e-06 * n7_y_p3 + 0.0001505 * n7_y_p2)));

  // link 17 (right_lowerarm), inward
  const Real minus_f16_y = minus_f17_z - (0.004500002325 * (minus_a17_y_p1 + minus_n16_x_p1) -
      0.0022500062 * minus_n16_x_p2);
  const Real f16_x = minus_n16_y_p3 + (0.004500002325 * minus_n16_y_p1 + 0.0022500062 *
      (minus_a17_y_p2 + minus_n16_x_p1));

  // link 16 (right_upperarm), inward
  const Real f15_y = 0.0017499999999999998 * (n15_z_p1 + n15_y_p1) + 0.7139200499999999 * n15_x_p1 -
      c16 * minus_f16_y + s16 * f16_x;
  const Real f15_x_p1 = 0.0017499999999999998 * n15_y_p3 - 0.7139200499999999 *
      (n15_z_p2 + n15_y_p1) + 0.004500002325 * minus_n16_x_p4 + 0.0022500062 * minus_n16_x_p3;
  const Real f15_x = f15_x_p1 - c17 * minus_f17_y + s17 * f17_x;

  // link 15 (right_shoulder2), inward
  const Real f14_z = 0.0017499999999999998 * (minus_n14_y_p3 - minus_n14_y_p2) +
      (c15 * f15_y + s15 * f15_x);

  // link 10 (left_lowerarm), inward
  const Real minus_f9_y = minus_f10_z + (0.004500002325 * (minus_a10_y_p1 + n9_x_p1) +
      0.0022500062 * n9_x_p2);
  const Real f9_x = n9_y_p3 - (0.004500002325 * n9_y_p1 - 0.0022500062 *
      (minus_a10_y_p2 + n9_x_p1));

  // link 9 (left_upperarm), inward
  const Real minus_f8_y = 0.0017499999999999998 * (minus_n8_z_p1 + n8_y_p1) - 0.7139200499999999 *
      minus_n8_x_p1 + c9 * minus_f9_y - s9 * f9_x;
  const Real minus_f8_x_p1 = 0.0017499999999999998 * n8_y_p3 + 0.7139200499999999 *
      (minus_n8_z_p2 + n8_y_p1) + 0.004500002325 * n9_x_p4 - 0.0022500062 * n9_x_p3;
  const Real minus_f8_x = minus_f8_x_p1 + c10 * minus_f10_y - s10 * f10_x;

  // link 8 (left_shoulder2), inward
  const Real f7_z = 0.0017499999999999998 * (n7_y_p3 - n7_y_p2) -
      (c8 * minus_f8_y + s8 * minus_f8_x);

  // link 15 (right_shoulder2), inward
  const Real minus_f14_y = 0.0017499999999999998 * (minus_n14_x_p1 -
      (minus_n14_z_p2 + minus_n14_y_p6)) + (s15 * f15_y - c15 * f15_x);
  const Real f14_x = 0.0017499999999999998 * (n15_y_p2 -
      (minus_n14_y_p5 + (minus_n14_z_p3 + minus_n14_y_p6))) +
      (0.7139200499999999 * n15_y_p4 + s16 * minus_f16_y + c16 * f16_x);

  // link 14 (right_shoulder1), inward
  const Real minus_n6_z_p3 = c14 * minus_f14_y - s14 * f14_x;

  // link 8 (left_shoulder2), inward
  const Real minus_f7_y = 0.0017499999999999998 * (n7_x_p1 - (n7_z_p2 + n7_y_p6)) -
      (s8 * minus_f8_y - c8 * minus_f8_x);
  const Real minus_f7_x = 0.0017499999999999998 * (n8_y_p2 + (n7_y_p5 + (n7_z_p3 + n7_y_p6))) -
      (0.7139200499999999 * n8_y_p4 + s9 * minus_f9_y + c9 * f9_x);

  // link 7 (left_shoulder1), inward
  const Real minus_n6_z_p4 = c7 * minus_f7_y + s7 * minus_f7_x;
  const Real minus_n6_z = 0.18 * (minus_n6_z_p3 - minus_n6_z_p4) +
      (0.226 * (f14_z + f7_z) + (minus_n6_z_p2 + s7 * n7_y - c7 * n7_x));

  // link 1 (calf), inward
  const Real qdd_0_p92 = tau[5] + minus_n6_z;

  // link 22 (head), inward
  const Real minus_n21_z_p1 = 0.0016155 * a22_z_p2 - 0.00621675 * minus_wd6_x -
      0.0048105000000000005 * minus_n21_x_p1 - 0.0045000000000000005 * a21_y - c22 * minus_n22_y;
  const Real minus_n21_z = minus_n21_z_p1 + s22 * n22_x;

  // link 1 (calf), inward
  const Real qdd_0_p93 = tau[20] + minus_n21_z;
  const Real qdd_0_p94 = tau[22] - n23_z;
  const Real qdd_0_p95 = tau[23] - n24_z;
  const Real qdd_0_p96 = tau[21] + minus_n22_z;

  // link 24 (right_eye), bias force
  const Real qdd_0_p97 = 3.1081081081081083 * qdd_0_p95;

  // link 23 (left_eye), bias force
  const Real qdd_0_p98 = 3.1081081081081083 * qdd_0_p94;

  // link 22 (head), bias force
  const Real qdd_0_p99 = qdd_0_p96 + s24 * qdd_0_p97 + s23 * qdd_0_p98;

  // link 24 (right_eye), bias force
  const Real qdd_0_p100 = 27.027027027027028 * qdd_0_p95;
  const Real qdd_0_p101 = s24 * qdd_0_p100;

  // link 23 (left_eye), bias force
  const Real qdd_0_p102 = 27.027027027027028 * qdd_0_p94;
  const Real qdd_0_p103 = s23 * qdd_0_p102;

  // link 22 (head), bias force
  const Real qdd_0_p104 = c24 * qdd_0_p100 + c23 * qdd_0_p102;
  const Real qdd_0_p105 = 0.095 * qdd_0_p104 - (0.032 * (qdd_0_p101 - qdd_0_p103) -
      (qdd_0_p94 + qdd_0_p95 + inverse_D6_p29 * qdd_0_p99));
  const Real qdd_0_p106 = c24 * qdd_0_p97 + c23 * qdd_0_p98 - inverse_D6_p45 * qdd_0_p99;

  // link 21 (neck), bias force
  const Real qdd_0_p107 = qdd_0_p93 - c22 * qdd_0_p105 - s22 * qdd_0_p106;

  // link 22 (head), bias force
  const Real qdd_0_p108 = qdd_0_p101 + qdd_0_p103 + inverse_D6_p61 * qdd_0_p99;
  const Real qdd_0_p109 = inverse_D6_p64 * qdd_0_p99;
  const Real qdd_0_p110 = s22 * qdd_0_p109 + c22 * qdd_0_p108;

  // link 21 (neck), bias force
  const Real qdd_0_p111 = qdd_0_p96 - 0.394 * qdd_0_p110 + inverse_D6_p72 * qdd_0_p107;

  // link 22 (head), bias force
  const Real qdd_0_p112 = qdd_0_p104 + inverse_D6_p50 * qdd_0_p99;

  // link 21 (neck), bias force
  const Real qdd_0_p113 = 0.394 * qdd_0_p112 - s22 * qdd_0_p105 + c22 * qdd_0_p106 -
      inverse_D6_p55 * qdd_0_p107;

  // link 14 (right_shoulder1), articulated inertia
  const Real qdd_0_p114 = 2.6249999999999998e-05 / inverse_D14_p8;

  // link 14 (right_shoulder1), bias force
  const Real qdd_0_p115 = qdd_0_p32 + qdd_0_p114 * qdd_0_p41;

  // link 6 (chest3), bias force
  const Real qdd_0_p116 = qdd_0_p92 + s21 * qdd_0_p111 + c21 * qdd_0_p113 - s14 * qdd_0_p91 - c14 *
      qdd_0_p115;

  // link 7 (left_shoulder1), bias force
  const Real qdd_0_p117 = s8 * qdd_0_p81 + c8 * qdd_0_p84 + inverse_D5_p370 * qdd_0_p85;

  // link 7 (left_shoulder1), articulated inertia
  const Real qdd_0_p118 = 2.6249999999999998e-05 / minus_inverse_D7_p8;

  // link 7 (left_shoulder1), bias force
  const Real qdd_0_p119 = qdd_0_p76 + qdd_0_p118 * qdd_0_p85;

  // link 6 (chest3), bias force
  const Real qdd_0_p120 = 0.18 * (qdd_0_p44 - qdd_0_p88) +
      (0.226 * (qdd_0_p89 + qdd_0_p90) + (qdd_0_p116 - s7 * qdd_0_p117 - c7 * qdd_0_p119));

  // link 21 (neck), bias force
  const Real qdd_0_p121 = qdd_0_p112 - inverse_D5_p401 * qdd_0_p107;
  const Real qdd_0_p122 = qdd_0_p110 - inverse_D5_p398 * qdd_0_p107;

  // link 6 (chest3), bias force
  const Real qdd_0_p123 = qdd_0_p90 + (qdd_0_p89 + (c21 * qdd_0_p121 - s21 * qdd_0_p122)) +
      inverse_D1_p2 * qdd_0_p120;
  const Real qdd_0_p124 = qdd_0_p88 + (qdd_0_p44 - (c22 * qdd_0_p109 - s22 * qdd_0_p108 +
      inverse_D1_p5 * qdd_0_p107)) - inverse_D1_p11 * qdd_0_p120;
  const Real qdd_0_p125 = c6 * qdd_0_p123 - s6 * qdd_0_p124;

  // link 7 (left_shoulder1), bias force
  const Real qdd_0_p126 = s7 * qdd_0_p86 - c7 * qdd_0_p87;

  // link 14 (right_shoulder1), bias force
  const Real qdd_0_p127 = s14 * qdd_0_p42 - c14 * qdd_0_p43;

  // link 6 (chest3), bias force
  const Real qdd_0_p128 = qdd_0_p126 + (qdd_0_p127 - (s21 * qdd_0_p121 + c21 * qdd_0_p122)) -
      inverse_D5_p408 * qdd_0_p120;

  // link 7 (left_shoulder1), inward
  const Real n6_y_p1 = 0.0187369177636143 * (minus_a14_z_p1 - a14_y_p9) + 1.66923963592404 *
      a14_y_p4 + 6.1665928899999995 * minus_a6_z + c21 * minus_n21_y;

  // link 14 (right_shoulder1), inward
  const Real n6_y_p2 = s14 * minus_f14_y + c14 * f14_x;

  // link 7 (left_shoulder1), inward
  const Real n6_y_p3 = s7 * minus_f7_y - c7 * minus_f7_x;
  const Real n6_y = 0.226 * (n6_y_p2 + n6_y_p3) + (n7_z -
      (minus_n14_z + (n6_y_p1 + s21 * minus_n21_x)));

  // link 22 (head), inward
  const Real f21_x = minus_n21_y_p3 - 0.0045000000000000005 * (a22_x_p2 + minus_n21_y_p1);
  const Real f21_y = f22_z + 0.0045000000000000005 * minus_n21_x_p2;

  // link 7 (left_shoulder1), inward
  const Real f6_z = n6_y_p3 + (n6_y_p2 - (6.1665928899999995 * a14_y_p4 + s21 * f21_y - c21 *
      f21_x));

  // link 5 (chest2), outward
  const Real n5_z_p1 = minus_w5_y * minus_w5_y;

  // link 6 (chest3), inward
  const Real n5_z_p2 = 0.005678398088837119 * (a6_x_p3 - n5_z_p1) - 0.203126912024134 *
      minus_wd4_y - 0.10961925816937637 * minus_a6_z_p1 - 2.2194301519999997 * minus_a5_x;

  // link 7 (left_shoulder1), inward
  const Real minus_n6_x_p1 = minus_n21_z + (0.0187369177636143 * minus_a14_z_p3 -
      0.40041499999999997 * a14_y_p2) - c14 * minus_n14_y - s14 * minus_n14_x;
  const Real minus_n6_x = 0.18 * (n6_y_p2 - n6_y_p3) - (minus_n6_x_p1 + c7 * n7_y + s7 * n7_x);

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p2 - 0.069699984375 * minus_a5_y + 0.072 * f6_z + c6 * n6_y - s6 *
      minus_n6_x;

  // link 1 (calf), inward
  const Real qdd_0_p129 = tau[4] - n5_z;

  // link 6 (chest3), bias force
  const Real qdd_0_p130 = 0.226 * (qdd_0_p127 + qdd_0_p126) +
      (qdd_0_p82 + (qdd_0_p38 + (c21 * qdd_0_p111 - s21 * qdd_0_p113)) + inverse_D5_p383 *
      qdd_0_p120);
  const Real qdd_0_p131 = qdd_0_p93 + c14 * qdd_0_p91 - s14 * qdd_0_p115 + c7 * qdd_0_p117 - s7 *
      qdd_0_p119;
  const Real qdd_0_p132 = 0.18 * (qdd_0_p127 - qdd_0_p126) +
      (qdd_0_p131 - inverse_D5_p390 * qdd_0_p120);

  // link 5 (chest2), bias force
  const Real qdd_0_p133 = qdd_0_p129 - 0.072 * qdd_0_p128 - c6 * qdd_0_p130 + s6 * qdd_0_p132;
  const Real qdd_0_p134 = qdd_0_p125 + inverse_D1_p42 * qdd_0_p133;
  const Real qdd_0_p135 = s6 * qdd_0_p130 + c6 * qdd_0_p132 + inverse_D1_p35 * qdd_0_p133;
  const Real qdd_0_p136 = qdd_0_p92 - 0.072 * qdd_0_p125 - inverse_D1_p25 * qdd_0_p133;

  // link 5 (chest2), outward
  const Real n5_y_p1 = minus_wd5_y - minus_w5_x * w5_z;

  // link 6 (chest3), inward
  const Real n5_y = 0.005678398088837119 * a6_x_p1 - 0.04675382692737882 * n5_y_p1 -
      0.069699984375 * a4_y - s6 * n6_y - c6 * minus_n6_x;

  // link 7 (left_shoulder1), inward
  const Real minus_f6_x_p1 = minus_n6_z_p3 - (6.1665928899999995 * a14_y_p10 -
      0.0045000000000000005 * minus_n21_y_p2 - c22 * minus_f22_y - s22 * minus_f22_x);
  const Real minus_f6_x = minus_n6_z_p4 + minus_f6_x_p1;
  const Real f6_y = f7_z + (f14_z - (6.1665928899999995 * minus_a14_z_p3 - c21 * f21_y - s21 *
      f21_x));

  // link 6 (chest3), inward
  const Real minus_n5_x_p1 = c6 * f6_y - s6 * minus_f6_x;
  const Real minus_n5_x = minus_n6_z + (0.005678398088837119 * n5_y_p1 - 0.15637308509675518 *
      a6_x_p1 + 2.2194301519999997 * a4_y) + 0.072 * minus_n5_x_p1;

  // link 4 (chest1), outward
  const Real qdd_0_p137 = w4_x * w4_y;

  // link 4 (chest1), bias force
  const Real qdd_0_p138 = c5 * (n5_y - qdd_0_p135) -
      (s5 * (minus_n5_x - qdd_0_p136) - (tau[3] + 0.03561389675370483 * qdd_0_p137 + 0.0300000063 *
      a4_y));

  // link 3 (hip), bias force
  const Real qdd_0_p139 = s4 * (0.21799999999999997 * qdd_0_p134 - s5 * qdd_0_p135 - c5 *
      qdd_0_p136 - inverse_D3_p3 * qdd_0_p138);

  // link 5 (chest2), bias force
  const Real qdd_0_p140 = s6 * qdd_0_p123 + c6 * qdd_0_p124 + inverse_D1_p58 * qdd_0_p133;
  const Real qdd_0_p141 = qdd_0_p128 + inverse_D1_p54 * qdd_0_p133;
  const Real qdd_0_p142 = s5 * qdd_0_p140 + c5 * qdd_0_p141;

  // link 4 (chest1), outward
  const Real n4_y_p1 = qd[3] * qd[3];

  // link 6 (chest3), inward
  const Real f5_y = 2.2194301519999997 * a6_x_p5 - 0.069699984375 * (minus_wd4_y - minus_a6_z_p1) -
      s6 * f6_y - c6 * minus_f6_x;
  const Real f5_x = f6_z - (2.2194301519999997 * minus_a6_z_p2 + 0.069699984375 *
      (n5_z_p1 + a6_x_p4));

  // link 5 (chest2), inward
  const Real n4_y_p2 = s5 * f5_y - c5 * f5_x;
  const Real n4_y = n5_z - (0.005880002159562879 * (minus_a5_x_p1 - n4_y_p1) + 0.02455520649259034 *
      minus_wd4_y - 0.0300000063 * minus_a3_y) - 0.21799999999999997 * n4_y_p2;

  // link 6 (chest3), inward
  const Real f5_z = minus_n5_x_p1 - (2.2194301519999997 * a6_x_p1 - 0.069699984375 * n5_y_p1);

  // link 5 (chest2), inward
  const Real n4_x = 0.005880002159562879 * qdd_0_p137 + 0.095783 * wd4_x - 0.21799999999999997 *
      f5_z - s5 * n5_y - c5 * minus_n5_x;

  // link 4 (chest1), inward
  const Real minus_n3_z = 8.419374554 * minus_a3_x - 0.02999999505 * minus_a3_y - c4 * n4_y - s4 *
      n4_x;

  // link 1 (calf), inward
  const Real qdd_0_p143 = tau[2] + minus_n3_z;

  // link 3 (hip), bias force
  const Real qdd_0_p144 = qdd_0_p143 - c4 * (qdd_0_p129 + 0.21799999999999997 * qdd_0_p142 -
      inverse_D3_p1 * qdd_0_p138) + qdd_0_p139;
  const Real qdd_0_p145 = c5 * qdd_0_p140 - s5 * qdd_0_p141 + inverse_D1_p83 * qdd_0_p138 +
      inverse_D1_p87 * qdd_0_p144;
  const Real qdd_0_p146 = s4 * (qdd_0_p134 - inverse_D1_p48 * qdd_0_p138) - c4 *
      (qdd_0_p142 - inverse_D1_p67 * qdd_0_p138) - inverse_D1_p89 * qdd_0_p144;
  const Real qdd_0_p147 = s3 * qdd_0_p145 - c3 * qdd_0_p146;

  // link 3 (hip), outward
  const Real f3_y_p1 = w3_z * w3_z;

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * f3_y_p1 + 0.0600000126 * minus_wd4_y + c5 * f5_y + s5 * f5_x;

  // link 5 (chest2), inward
  const Real minus_f4_x = n4_y_p2 - 0.0300000063 * (minus_a5_x_p2 + n4_y_p1);
  const Real f4_y = f5_z - 0.0300000063 * qdd_0_p137;

  // link 4 (chest1), inward
  const Real f3_x = 0.02999999505 * f3_y_p1 - s4 * f4_y - c4 * minus_f4_x;

  // link 3 (hip), inward
  const Real minus_n2_z_p1 = s3 * f3_y - c3 * f3_x;
  const Real minus_n2_z = minus_n3_z + (24.5839218 * minus_a2_x + 0.031999971599999996 *
      minus_a2_y) + 0.422 * minus_n2_z_p1;

  // link 2 (thigh), bias force
  const Real qdd_0_p148 = tau[1] + minus_n2_z - qdd_0_p143 - 0.422 * qdd_0_p147;
  const Real qdd_0_p149 = s2 * (c3 * qdd_0_p145 + s3 * qdd_0_p146 - inverse_D1_p102 * qdd_0_p148) +
      c2 * (qdd_0_p147 + inverse_D1_p98 * qdd_0_p148);

  // link 3 (hip), inward
  const Real f2_y = 24.5839218 * minus_a3_y_p1 + c3 * f3_y + s3 * f3_x;
  const Real minus_f2_x = minus_n2_z_p1 + 0.031999971599999996 * minus_a3_y_p1;

  // link 1 (calf), bias force
  const Real qdd_0_p150 = 0.434 * (s2 * f2_y + c2 * minus_f2_x - qdd_0_p149) -
      (tau[1] - (tau[0] + 299.6743959432 * s1 - 0.1569597827085 * c1));

  // link 1 (calf), acceleration
  const Real qdd_0 = inverse_D1 * qdd_0_p150;
  qdd[0] = qdd_0;

  // link 2 (thigh), acceleration
  const Real qdd_1_p1 = 0.434 * qdd_0;
  const Real qdd_1_p2 = s2 * qdd_1_p1;
  const Real qdd_1_p3 = c2 * qdd_1_p1;
  const Real qdd_1 = qdd_0 - inverse_D1_p102 * qdd_1_p2 + inverse_D1_p98 * qdd_1_p3 - inverse_D2 *
      qdd_0_p148;
  qdd[1] = -qdd_1;
  const Real qdd_2_p1 = qdd_0 - qdd_1;

  // link 3 (hip), acceleration
  const Real qdd_2_p2 = qdd_1_p3 + 0.422 * qdd_2_p1;
  const Real qdd_2_p3 = c3 * qdd_1_p2 + s3 * qdd_2_p2;
  const Real qdd_2_p4 = s3 * qdd_1_p2 - c3 * qdd_2_p2;
  const Real qdd_2 = qdd_2_p1 + inverse_D1_p87 * qdd_2_p3 - inverse_D1_p89 * qdd_2_p4 - inverse_D3 *
      qdd_0_p144;
  qdd[2] = -qdd_2;
  const Real qdd_3_p1 = qdd_2_p1 - qdd_2;

  // link 4 (chest1), acceleration
  const Real qdd_3_p2 = c4 * qdd_3_p1;
  const Real qdd_3_p3 = s4 * qdd_3_p1;
  const Real qdd_3_p4 = s4 * qdd_2_p4;
  const Real qdd_3_p5 = c4 * qdd_2_p4;
  const Real qdd_3_p6 = inverse_D3_p1 * qdd_3_p2 - inverse_D3_p3 * qdd_3_p3 - inverse_D1_p83 *
      qdd_2_p3 + inverse_D1_p48 * qdd_3_p4 - inverse_D1_p67 * qdd_3_p5;
  const Real qdd_3 = qdd_3_p6 + inverse_D4 * qdd_0_p138;
  qdd[3] = qdd_3;

  // link 5 (chest2), acceleration
  const Real qdd_4_p1 = c5 * qdd_3 + s5 * qdd_3_p3;
  const Real qdd_4_p2 = s5 * qdd_3 - c5 * qdd_3_p3;
  const Real qdd_4_p3 = qdd_3_p4 - 0.21799999999999997 * qdd_3_p3;
  const Real qdd_4_p4 = qdd_3_p5 - 0.21799999999999997 * qdd_3_p2;
  const Real qdd_4_p5 = c5 * qdd_2_p3 - s5 * qdd_4_p4;
  const Real qdd_4_p6 = qdd_3_p2 + inverse_D1_p35 * qdd_4_p1 + inverse_D1_p25 * qdd_4_p2 +
      inverse_D1_p42 * qdd_4_p3 + inverse_D1_p58 * qdd_4_p5;
  const Real qdd_4_p7 = s5 * qdd_2_p3 + c5 * qdd_4_p4;
  const Real qdd_4 = qdd_4_p6 - inverse_D1_p54 * qdd_4_p7 - inverse_D5 * qdd_0_p133;
  qdd[4] = -qdd_4;
  const Real qdd_5_p1 = qdd_3_p2 - qdd_4;

  // link 6 (chest3), acceleration
  const Real qdd_5_p2 = c6 * qdd_5_p1 + s6 * qdd_4_p1;
  const Real qdd_5_p3 = s6 * qdd_5_p1 - c6 * qdd_4_p1;
  const Real qdd_5_p4 = qdd_4_p7 - 0.072 * qdd_5_p1;
  const Real qdd_5_p5 = qdd_4_p3 + 0.072 * qdd_4_p2;
  const Real qdd_5_p6 = c6 * qdd_5_p5 + s6 * qdd_4_p5;
  const Real qdd_5_p7 = qdd_4_p2 - inverse_D5_p383 * qdd_5_p2 - inverse_D5_p390 * qdd_5_p3 -
      inverse_D5_p408 * qdd_5_p4 - inverse_D1_p2 * qdd_5_p6;
  const Real qdd_5_p8 = s6 * qdd_5_p5 - c6 * qdd_4_p5;
  const Real qdd_5 = qdd_5_p7 - inverse_D1_p11 * qdd_5_p8 + inverse_D6 * qdd_0_p120;
  qdd[5] = qdd_5;
  const Real qdd_6_p1 = qdd_4_p2 - qdd_5;

  // link 7 (left_shoulder1), acceleration
  const Real qdd_6_p2 = s7 * qdd_6_p1 + c7 * qdd_5_p3;
  const Real qdd_6_p3 = c7 * qdd_6_p1 - s7 * qdd_5_p3;
  const Real qdd_6_p4 = qdd_5_p6 + 0.226 * qdd_6_p1;
  const Real qdd_6_p5 = qdd_5_p4 - 0.226 * qdd_5_p2;
  const Real qdd_6_p6 = 0.18 * qdd_5_p3;
  const Real qdd_6_p7 = qdd_6_p6 - qdd_6_p5;
  const Real qdd_6_p8 = 0.18 * qdd_6_p1;
  const Real qdd_6_p9 = qdd_5_p8 + qdd_6_p8;
  const Real qdd_6_p10 = s7 * qdd_6_p7 - c7 * qdd_6_p9;
  const Real qdd_6_p11 = qdd_5_p2 - inverse_D5_p370 * qdd_6_p2 - qdd_0_p118 * qdd_6_p3 +
      inverse_D5_p359 * qdd_6_p4 - inverse_D5_p329 * qdd_6_p10;
  const Real qdd_6_p12 = c7 * qdd_6_p7 + s7 * qdd_6_p9;
  const Real qdd_6 = qdd_6_p11 - inverse_D5_p309 * qdd_6_p12 + minus_inverse_D7 * qdd_0_p85;
  qdd[6] = -qdd_6;
  const Real qdd_7_p1 = qdd_5_p2 - qdd_6;

  // link 8 (left_shoulder2), acceleration
  const Real qdd_7_p2 = c8 * qdd_7_p1 - s8 * qdd_6_p2;
  const Real qdd_7_p3 = s8 * qdd_7_p1 + c8 * qdd_6_p2;
  const Real qdd_7_p4 = c8 * qdd_6_p4 + s8 * qdd_6_p10;
  const Real qdd_7_p5 = qdd_6_p3 - minus_inverse_D7_p1 * qdd_7_p2 - qdd_0_p83 * qdd_7_p3 +
      inverse_D5_p303 * qdd_6_p12 - inverse_D5_p322 * qdd_7_p4;
  const Real qdd_7_p6 = s8 * qdd_6_p4 - c8 * qdd_6_p10;
  const Real qdd_7 = qdd_7_p5 - inverse_D5_p319 * qdd_7_p6 - minus_inverse_D8 * qdd_0_p78;
  qdd[7] = qdd_7;
  const Real qdd_8_p1 = qdd_6_p3 - qdd_7;

  // link 9 (left_upperarm), acceleration
  const Real qdd_8_p2 = s9 * qdd_8_p1 + c9 * qdd_7_p2;
  const Real qdd_8_p3 = c9 * qdd_8_p1 - s9 * qdd_7_p2;
  const Real qdd_8_p4 = s9 * qdd_6_p12 - c9 * qdd_7_p4;
  const Real qdd_8_p5 = qdd_7_p3 + minus_inverse_D8_p1 * qdd_8_p2 + minus_inverse_D8_p4 * qdd_8_p3 +
      inverse_D5_p313 * qdd_7_p6 + inverse_D5_p253 * qdd_8_p4;
  const Real qdd_8_p6 = c9 * qdd_6_p12 + s9 * qdd_7_p4;
  const Real qdd_8 = qdd_8_p5 - inverse_D5_p281 * qdd_8_p6 - minus_inverse_D9 * qdd_0_p69;
  qdd[8] = qdd_8;
  const Real qdd_9_p1 = qdd_7_p3 - qdd_8;

  // link 10 (left_lowerarm), acceleration
  const Real qdd_9_p2 = c10 * qdd_9_p1 + s10 * qdd_8_p3;
  const Real qdd_9_p3 = s10 * qdd_9_p1 - c10 * qdd_8_p3;
  const Real qdd_9_p4 = qdd_8_p4 + 0.282 * qdd_8_p3;
  const Real qdd_9_p5 = qdd_8_p6 - 0.282 * qdd_8_p2;
  const Real qdd_9_p6 = c10 * qdd_7_p6 - s10 * qdd_9_p5;
  const Real qdd_9_p7 = qdd_8_p2 + inverse_D5_p228 * qdd_9_p2 + inverse_D5_p231 * qdd_9_p3 +
      inverse_D5_p246 * qdd_9_p4 - inverse_D5_p273 * qdd_9_p6;
  const Real qdd_9_p8 = s10 * qdd_7_p6 + c10 * qdd_9_p5;
  const Real qdd_9 = qdd_9_p7 - inverse_D5_p264 * qdd_9_p8 + minus_inverse_D10 * qdd_0_p64;
  qdd[9] = -qdd_9;
  const Real qdd_10_p1 = qdd_8_p2 - qdd_9;

  // link 11 (left_wrist1), acceleration
  const Real qdd_10_p2 = c11 * qdd_10_p1 - s11 * qdd_9_p3;
  const Real qdd_10_p3 = s11 * qdd_10_p1 + c11 * qdd_9_p3;
  const Real qdd_10_p4 = c11 * qdd_9_p4 + s11 * qdd_9_p8;
  const Real qdd_10_p5 = qdd_9_p2 - inverse_D5_p205 * qdd_10_p2 - inverse_D5_p211 * qdd_10_p3 +
      inverse_D5_p268 * qdd_9_p6 + inverse_D5_p239 * qdd_10_p4;
  const Real qdd_10_p6 = s11 * qdd_9_p4 - c11 * qdd_9_p8;
  const Real qdd_10 = qdd_10_p5 - inverse_D5_p236 * qdd_10_p6 + inverse_D11 * qdd_0_p55;
  qdd[10] = qdd_10;
  const Real qdd_11_p1 = qdd_9_p2 - qdd_10;

  // link 12 (left_wrist2), acceleration
  const Real qdd_11_p2 = c12 * qdd_11_p1 - s12 * qdd_10_p3;
  const Real qdd_11_p3 = qdd_10_p4 - 0.269 * qdd_10_p3;
  const Real qdd_11_p4 = qdd_10_p6 + 0.269 * qdd_10_p2;
  const Real qdd_11_p5 = c12 * qdd_9_p6 + s12 * qdd_11_p4;
  const Real qdd_11_p6 = qdd_10_p2 - inverse_D11_p1 * qdd_11_p2 + inverse_D5_p196 * qdd_11_p3 +
      inverse_D5_p190 * qdd_11_p5 - inverse_D5_p184 * (s12 * qdd_9_p6 - c12 * qdd_11_p4);
  const Real qdd_11 = qdd_11_p6 - inverse_D12 * qdd_0_p51;
  qdd[11] = -qdd_11;
  const Real qdd_12_p1 = qdd_10_p2 - qdd_11;

  // link 13 (left_hand), acceleration
  const Real qdd_12_p2 = s12 * qdd_11_p1 + c12 * qdd_10_p3 + 0.04672761636452121 *
      (c13 * qdd_12_p1 - s13 * qdd_11_p2);
  const Real qdd_12_p3 = qdd_12_p2 - 0.11533812622014242 * (s13 * qdd_12_p1 + c13 * qdd_11_p2) -
      17.32841575379867 * (c13 * qdd_11_p3 + s13 * qdd_11_p5);
  qdd[12] = -(qdd_12_p3 - 3.0523172236718206 * (s13 * qdd_11_p3 - c13 * qdd_11_p5) -
      1065.380700001509 * qdd_0_p45);

  // link 14 (right_shoulder1), acceleration
  const Real qdd_13_p1 = s14 * qdd_6_p1 + c14 * qdd_5_p3;
  const Real qdd_13_p2 = c14 * qdd_6_p1 - s14 * qdd_5_p3;
  const Real qdd_13_p3 = qdd_6_p6 + qdd_6_p5;
  const Real qdd_13_p4 = qdd_5_p8 - qdd_6_p8;
  const Real qdd_13_p5 = s14 * qdd_13_p3 + c14 * qdd_13_p4;
  const Real qdd_13_p6 = qdd_5_p2 - inverse_D5_p365 * qdd_13_p1 - qdd_0_p114 * qdd_13_p2 +
      inverse_D5_p177 * qdd_6_p4 - inverse_D5_p147 * qdd_13_p5;
  const Real qdd_13_p7 = c14 * qdd_13_p3 - s14 * qdd_13_p4;
  const Real qdd_13 = qdd_13_p6 - inverse_D5_p127 * qdd_13_p7 - inverse_D14 * qdd_0_p41;
  qdd[13] = -qdd_13;
  const Real qdd_14_p1 = qdd_5_p2 - qdd_13;

  // link 15 (right_shoulder2), acceleration
  const Real qdd_14_p2 = c15 * qdd_14_p1 - s15 * qdd_13_p1;
  const Real qdd_14_p3 = s15 * qdd_14_p1 + c15 * qdd_13_p1;
  const Real qdd_14_p4 = c15 * qdd_6_p4 - s15 * qdd_13_p5;
  const Real qdd_14_p5 = qdd_13_p2 - inverse_D14_p1 * qdd_14_p2 + qdd_0_p39 * qdd_14_p3 -
      inverse_D5_p121 * qdd_13_p7 - inverse_D5_p140 * qdd_14_p4;
  const Real qdd_14_p6 = s15 * qdd_6_p4 + c15 * qdd_13_p5;
  const Real qdd_14 = qdd_14_p5 - inverse_D5_p137 * qdd_14_p6 + inverse_D15 * qdd_0_p34;
  qdd[14] = qdd_14;
  const Real qdd_15_p1 = qdd_13_p2 - qdd_14;

  // link 16 (right_upperarm), acceleration
  const Real qdd_15_p2 = s16 * qdd_15_p1 + c16 * qdd_14_p2;
  const Real qdd_15_p3 = c16 * qdd_15_p1 - s16 * qdd_14_p2;
  const Real qdd_15_p4 = s16 * qdd_13_p7 + c16 * qdd_14_p4;
  const Real qdd_15_p5 = qdd_14_p3 - inverse_D15_p1 * qdd_15_p2 + inverse_D15_p4 * qdd_15_p3 +
      inverse_D5_p131 * qdd_14_p6 - inverse_D5_p71 * qdd_15_p4;
  const Real qdd_15_p6 = c16 * qdd_13_p7 - s16 * qdd_14_p4;
  const Real qdd_15 = qdd_15_p5 - inverse_D5_p99 * qdd_15_p6 - minus_inverse_D16 * qdd_0_p25;
  qdd[15] = qdd_15;
  const Real qdd_16_p1 = qdd_14_p3 - qdd_15;

  // link 17 (right_lowerarm), acceleration
  const Real qdd_16_p2 = c17 * qdd_16_p1 + s17 * qdd_15_p3;
  const Real qdd_16_p3 = s17 * qdd_16_p1 - c17 * qdd_15_p3;
  const Real qdd_16_p4 = qdd_15_p4 - 0.282 * qdd_15_p3;
  const Real qdd_16_p5 = qdd_15_p6 + 0.282 * qdd_15_p2;
  const Real qdd_16_p6 = c17 * qdd_14_p6 + s17 * qdd_16_p5;
  const Real qdd_16_p7 = qdd_15_p2 + inverse_D5_p46 * qdd_16_p2 + inverse_D5_p49 * qdd_16_p3 -
      inverse_D5_p64 * qdd_16_p4 + inverse_D5_p91 * qdd_16_p6;
  const Real qdd_16_p8 = s17 * qdd_14_p6 - c17 * qdd_16_p5;
  const Real qdd_16 = qdd_16_p7 - inverse_D5_p82 * qdd_16_p8 - inverse_D17 * qdd_0_p20;
  qdd[16] = -qdd_16;
  const Real qdd_17_p1 = qdd_15_p2 - qdd_16;

  // link 18 (right_wrist1), acceleration
  const Real qdd_17_p2 = c18 * qdd_17_p1 - s18 * qdd_16_p3;
  const Real qdd_17_p3 = s18 * qdd_17_p1 + c18 * qdd_16_p3;
  const Real qdd_17_p4 = c18 * qdd_16_p4 - s18 * qdd_16_p8;
  const Real qdd_17_p5 = qdd_16_p2 + inverse_D5_p23 * qdd_17_p2 - inverse_D5_p29 * qdd_17_p3 -
      inverse_D5_p86 * qdd_16_p6 - inverse_D5_p57 * qdd_17_p4;
  const Real qdd_17_p6 = s18 * qdd_16_p4 + c18 * qdd_16_p8;
  const Real qdd_17 = qdd_17_p5 - inverse_D5_p54 * qdd_17_p6 + inverse_D18 * qdd_0_p11;
  qdd[17] = qdd_17;
  const Real qdd_18_p1 = qdd_16_p2 - qdd_17;

  // link 19 (right_wrist2), acceleration
  const Real qdd_18_p2 = c19 * qdd_18_p1 - s19 * qdd_17_p3;
  const Real qdd_18_p3 = qdd_17_p4 + 0.269 * qdd_17_p3;
  const Real qdd_18_p4 = qdd_17_p6 - 0.269 * qdd_17_p2;
  const Real qdd_18_p5 = c19 * qdd_16_p6 - s19 * qdd_18_p4;
  const Real qdd_18_p6 = qdd_17_p2 - inverse_D18_p1 * qdd_18_p2 - inverse_D5_p14 * qdd_18_p3 -
      inverse_D5_p8 * qdd_18_p5 + inverse_D5_p2 * (s19 * qdd_16_p6 + c19 * qdd_18_p4);
  const Real qdd_18 = qdd_18_p6 + minus_inverse_D19 * qdd_0_p7;
  qdd[18] = -qdd_18;
  const Real qdd_19_p1 = qdd_17_p2 - qdd_18;

  // link 20 (right_hand), acceleration
  const Real qdd_19_p2 = s19 * qdd_18_p1 + c19 * qdd_17_p3 - 0.04672761636452121 *
      (c20 * qdd_19_p1 - s20 * qdd_18_p2);
  const Real qdd_19_p3 = qdd_19_p2 - 0.11533812622014242 * (s20 * qdd_19_p1 + c20 * qdd_18_p2) +
      17.32841575379867 * (c20 * qdd_18_p3 - s20 * qdd_18_p5);
  qdd[19] = -(qdd_19_p3 - 3.0523172236718206 * (s20 * qdd_18_p3 + c20 * qdd_18_p5) -
      1065.380700001509 * qdd_0_p1);

  // link 21 (neck), acceleration
  const Real qdd_20_p1 = s21 * qdd_6_p1 + c21 * qdd_5_p2;
  const Real qdd_20_p2 = c21 * qdd_6_p1 - s21 * qdd_5_p2;
  const Real qdd_20_p3 = s21 * qdd_5_p4 + c21 * qdd_5_p6;
  const Real qdd_20_p4 = qdd_5_p3 - inverse_D6_p72 * qdd_20_p1 + inverse_D6_p55 * qdd_20_p2 -
      inverse_D1_p5 * qdd_5_p8 + inverse_D5_p401 * qdd_20_p3;
  const Real qdd_20_p5 = c21 * qdd_5_p4 - s21 * qdd_5_p6;
  const Real qdd_20 = qdd_20_p4 + inverse_D5_p398 * qdd_20_p5 - minus_inverse_D21 * qdd_0_p107;
  qdd[20] = qdd_20;
  const Real qdd_21_p1 = qdd_5_p3 - qdd_20;

  // link 22 (head), acceleration
  const Real qdd_21_p2 = c22 * qdd_21_p1 + s22 * qdd_20_p2;
  const Real qdd_21_p3 = s22 * qdd_21_p1 - c22 * qdd_20_p2;
  const Real qdd_21_p4 = qdd_20_p3 + 0.394 * qdd_20_p2;
  const Real qdd_21_p5 = qdd_20_p5 - 0.394 * qdd_20_p1;
  const Real qdd_21_p6 = qdd_20_p1 - inverse_D6_p29 * qdd_21_p2 + inverse_D6_p45 * qdd_21_p3 +
      inverse_D6_p50 * qdd_21_p4 + inverse_D6_p64 * (c22 * qdd_5_p8 + s22 * qdd_21_p5);
  const Real qdd_21_p7 = s22 * qdd_5_p8 - c22 * qdd_21_p5;
  const Real qdd_21 = qdd_21_p6 - inverse_D6_p61 * qdd_21_p7 - inverse_D22 * qdd_0_p99;
  qdd[21] = -qdd_21;
  const Real qdd_22_p1 = qdd_20_p1 - qdd_21;

  // link 23 (left_eye), acceleration
  const Real qdd_22_p2 = qdd_21_p4 - 0.095 * qdd_21_p2;
  const Real qdd_22_p3 = 0.032 * qdd_21_p2;
  const Real qdd_22_p4 = qdd_21_p2 + 3.1081081081081083 * (s23 * qdd_22_p1 + c23 * qdd_21_p3) -
      27.027027027027028 * (c23 * qdd_22_p2 - s23 * (qdd_21_p7 + qdd_22_p3));
  qdd[22] = qdd_22_p4 + 108108.1081081081 * qdd_0_p94;

  // link 24 (right_eye), acceleration
  const Real qdd_23_p1 = qdd_21_p2 + 3.1081081081081083 * (s24 * qdd_22_p1 + c24 * qdd_21_p3) -
      27.027027027027028 * (c24 * qdd_22_p2 - s24 * (qdd_21_p7 - qdd_22_p3));
  qdd[23] = qdd_23_p1 + 108108.1081081081 * qdd_0_p95;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
