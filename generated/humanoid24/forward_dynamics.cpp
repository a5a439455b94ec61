// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By articulated bodies, Chang table 4.2.
// 4785 flops (add 2286, mul 2467, div 32), sine and cosine of 24 angles
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
  const Real angles[24] = {q[23], q[22], q[21], q[20], q[16], q[18], q[19], q[17], q[15], q[14],
      q[13], q[11], q[12], q[10], q[9], q[8], q[7], q[6], q[5], q[4], q[3], q[2], q[1], q[0]};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real s24 = sines[0];
  const Real s23 = sines[1];
  const Real c24 = cosines[0];
  const Real c23 = cosines[1];
  const Real c22 = cosines[2];
  const Real s22 = sines[2];
  const Real c21 = cosines[3];
  const Real s21 = sines[3];
  const Real s17 = sines[4];
  const Real s19 = sines[5];
  const Real c19 = cosines[5];
  const Real s20 = sines[6];
  const Real c20 = cosines[6];
  const Real s18 = sines[7];
  const Real c18 = cosines[7];
  const Real c17 = cosines[4];
  const Real c16 = cosines[8];
  const Real s16 = sines[8];
  const Real s15 = sines[9];
  const Real c15 = cosines[9];
  const Real c14 = cosines[10];
  const Real s14 = sines[10];
  const Real s12 = sines[11];
  const Real s13 = sines[12];
  const Real c13 = cosines[12];
  const Real c12 = cosines[11];
  const Real s11 = sines[13];
  const Real c11 = cosines[13];
  const Real s10 = sines[14];
  const Real c10 = cosines[14];
  const Real c9 = cosines[15];
  const Real s9 = sines[15];
  const Real s8 = sines[16];
  const Real c8 = cosines[16];
  const Real c7 = cosines[17];
  const Real s7 = sines[17];
  const Real s6 = sines[18];
  const Real c6 = cosines[18];
  const Real s5 = sines[19];
  const Real c5 = cosines[19];
  const Real s4 = sines[20];
  const Real c4 = cosines[20];
  const Real s3 = sines[21];
  const Real c3 = cosines[21];
  const Real s2 = sines[22];
  const Real c2 = cosines[22];
  const Real c1 = cosines[23];
  const Real s1 = sines[23];

  // link 13 (left_hand), articulated inertia
  const Real inverse_D1_p1 = 0.0002628975791811551 * c13 - 0.0007660844555829042 * s13;
  const Real inverse_D1_p2 = c13 * inverse_D1_p1 - 0.00013384878959057754;
  const Real inverse_D12_p1 = s13 * inverse_D1_p1;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D12 = 1.0 / (0.0010519177038056625 + inverse_D12_p1);
  const Real inverse_D1_p3 = inverse_D1_p2 * inverse_D12;
  const Real inverse_D1_p4 = 0.0002742332482227584 - inverse_D12_p1 - inverse_D1_p2 * inverse_D1_p3;
  const Real inverse_D1_p5 = s12 * (1.16e-05 - inverse_D1_p4);

  // link 13 (left_hand), articulated inertia
  const Real inverse_D1_p6 = 0.001090468517736955 * s13 + 0.001742099791326752 * c13;
  const Real inverse_D1_p7 = s13 * inverse_D1_p6;
  const Real inverse_D1_p8 = inverse_D1_p7 - 0.000760024621759417;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D1_p9 = inverse_D1_p8 * inverse_D12;

  // link 13 (left_hand), articulated inertia
  const Real inverse_D1_p10 = c13 * inverse_D1_p6;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D1_p11 = inverse_D1_p10 - 0.002376125662528793 - inverse_D1_p2 * inverse_D1_p9;
  const Real inverse_D1_p12 = 0.0006000000000000001 * s12 + c12 * inverse_D1_p11;
  const Real inverse_D1_p13 = 0.000144 - (c12 * inverse_D1_p5 + 0.269 * inverse_D1_p12);
  const Real inverse_D11_p1 = s12 * inverse_D1_p5;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D11 = 1.0 / (0.00022920000000000001 + (inverse_D1_p4 + inverse_D11_p1));
  const Real inverse_D1_p14 = inverse_D1_p13 * inverse_D11;

  // link 13 (left_hand), articulated inertia
  const Real inverse_D1_p15 = 0.27310176737964387 * s13 - 0.09929187165525127 * c13;
  const Real inverse_D1_p16 = s13 * inverse_D1_p15;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D1_p17 = inverse_D1_p16 - 0.2818466605750157 - inverse_D1_p8 * inverse_D1_p9;
  const Real inverse_D1_p18 = s12 * inverse_D1_p11 - 0.0006000000000000001 * c12;
  const Real inverse_D1_p19 = 0.269 * inverse_D1_p17 - inverse_D1_p18;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p20 = 0.000131 - inverse_D11_p1 + 0.269 *
      (inverse_D1_p19 - inverse_D1_p18) - inverse_D1_p13 * inverse_D1_p14;

  // link 13 (left_hand), articulated inertia
  const Real inverse_D1_p21 = 0.0006340258712020409 + inverse_D1_p10;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D1_p22 = inverse_D1_p21 * inverse_D12;
  const Real inverse_D1_p23 = 0.00033044389597753786 - inverse_D1_p7 - inverse_D1_p2 *
      inverse_D1_p22;

  // link 13 (left_hand), articulated inertia
  const Real inverse_D1_p24 = 0.0006000000000000001 + (0.002865001425 * s13 + 0.01626499875 * c13);

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D1_p25 = inverse_D1_p24 * inverse_D12;
  const Real inverse_D1_p26 = 0.01626499875 * s13 - 0.002865001425 * c13 + inverse_D1_p2 *
      inverse_D1_p25;
  const Real inverse_D1_p27 = s12 * inverse_D1_p23 - c12 * inverse_D1_p26;
  const Real inverse_D1_p28 = c12 * inverse_D1_p27;
  const Real inverse_D1_p29 = 0.0002516 - 0.269 * inverse_D1_p28;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p30 = inverse_D1_p29 * inverse_D11;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D1_p31 = 0.008744893195371809 + inverse_D1_p16 + inverse_D1_p21 *
      inverse_D1_p22;
  const Real inverse_D1_p32 = inverse_D1_p24 * inverse_D1_p25;
  const Real inverse_D1_p33 = inverse_D1_p24 * inverse_D1_p22;
  const Real inverse_D1_p34 = s12 * (inverse_D1_p31 - inverse_D1_p32) + c12 *
      (2.0 * inverse_D1_p33);
  const Real inverse_D1_p35 = s12 * inverse_D1_p34;
  const Real inverse_D1_p36 = inverse_D1_p32 + inverse_D1_p35;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p37 = 0.0001098 - 0.07236100000000001 * inverse_D1_p36 - inverse_D1_p29 *
      inverse_D1_p30;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D1_p38 = s12 * inverse_D1_p27;
  const Real inverse_D1_p39 = 0.04964593582762564 + c13 * inverse_D1_p15 - inverse_D1_p21 *
      inverse_D1_p9;
  const Real inverse_D1_p40 = inverse_D1_p24 * inverse_D1_p9;
  const Real inverse_D1_p41 = s12 * inverse_D1_p39 - c12 * inverse_D1_p40;
  const Real inverse_D1_p42 = 0.269 * inverse_D1_p41;
  const Real inverse_D1_p43 = inverse_D1_p38 - inverse_D1_p42;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p44 = 6e-06 + 0.269 * inverse_D1_p43 + inverse_D1_p13 * inverse_D1_p30;
  const Real inverse_D1_p45 = 2.0 * c11;
  const Real inverse_D1_p46 = s11 * (inverse_D1_p20 - inverse_D1_p37) - inverse_D1_p45 *
      inverse_D1_p44;
  const Real inverse_D1_p47 = c11 * inverse_D1_p46 + inverse_D1_p44 - 2.249994685315e-05;
  const Real inverse_D10_p1 = s11 * inverse_D1_p46;
  const Real inverse_D10_p2 = 0.060888541114265754 + (inverse_D1_p37 + inverse_D10_p1);

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D10 = 1.0 / inverse_D10_p2;
  const Real inverse_D1_p48 = inverse_D1_p47 * inverse_D10;
  const Real inverse_D1_p49 = 0.06060754126741261 + (inverse_D1_p20 - inverse_D10_p1) -
      inverse_D1_p47 * inverse_D1_p48;
  const Real inverse_D1_p50 = 0.00028099984685315 - 2.249996661190239e-08 / inverse_D10_p2;
  const Real inverse_D1_p51 = 0.0001499998887063 / inverse_D10_p2;
  const Real inverse_D1_p52 = inverse_D1_p47 * inverse_D1_p51 - 0.0001499998887063;
  const Real inverse_D1_p53 = 2.0 * c10;
  const Real inverse_D1_p54 = s10 * (inverse_D1_p49 - inverse_D1_p50) + inverse_D1_p53 *
      inverse_D1_p52;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D1_p55 = inverse_D1_p28 - 0.001;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p56 = inverse_D1_p55 * inverse_D11;
  const Real inverse_D1_p57 = inverse_D1_p43 - inverse_D1_p13 * inverse_D1_p56;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D1_p58 = 6e-04 - inverse_D1_p12;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p59 = inverse_D1_p58 * inverse_D11;
  const Real inverse_D1_p60 = inverse_D1_p42 - inverse_D1_p29 * inverse_D1_p59;
  const Real inverse_D1_p61 = 0.269 * inverse_D1_p36 - inverse_D1_p29 * inverse_D1_p56;
  const Real inverse_D1_p62 = inverse_D1_p19 - inverse_D1_p13 * inverse_D1_p59;
  const Real inverse_D1_p63 = s11 * (inverse_D1_p57 - inverse_D1_p60) + c11 *
      (inverse_D1_p61 + inverse_D1_p62);
  const Real inverse_D1_p64 = s11 * inverse_D1_p63;
  const Real inverse_D1_p65 = inverse_D1_p60 + inverse_D1_p64;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p66 = inverse_D1_p65 * inverse_D10;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p67 = c11 * inverse_D1_p63;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p68 = 0.28049749700000004 + (inverse_D1_p67 - inverse_D1_p61) -
      inverse_D1_p47 * inverse_D1_p66;
  const Real inverse_D1_p69 = 0.0001499998887063 * inverse_D1_p66 - 0.0014999985000000002;
  const Real inverse_D1_p70 = s10 * inverse_D1_p68 + c10 * inverse_D1_p69;
  const Real inverse_D1_p71 = 0.0005895000784280001 +
      (c10 * inverse_D1_p54 - inverse_D1_p52 + 0.282 * inverse_D1_p70);

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p72 = inverse_D1_p67 - inverse_D1_p62 - 0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p73 = inverse_D1_p72 * inverse_D10;
  const Real inverse_D1_p74 = 0.0001499998887063 * inverse_D1_p73;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D1_p75 = s12 * inverse_D1_p40 + c12 * inverse_D1_p39;
  const Real inverse_D1_p76 = inverse_D1_p23 - inverse_D1_p38;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p77 = inverse_D1_p76 * inverse_D11;
  const Real inverse_D1_p78 = 0.001 + (inverse_D1_p28 + inverse_D1_p26 - 0.269 * inverse_D1_p75) -
      inverse_D1_p13 * inverse_D1_p77;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D1_p79 = c12 * inverse_D1_p34 - inverse_D1_p33;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p80 = 0.269 * inverse_D1_p79 - 6e-04 - inverse_D1_p29 * inverse_D1_p77;
  const Real inverse_D1_p81 = 0.0014999985000000002 - (s11 * inverse_D1_p78 + c11 * inverse_D1_p80);

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p82 = inverse_D1_p81 * inverse_D10;
  const Real inverse_D1_p83 = c11 * inverse_D1_p78 - s11 * inverse_D1_p80 + inverse_D1_p47 *
      inverse_D1_p82;
  const Real inverse_D1_p84 = inverse_D1_p57 - inverse_D1_p64 - inverse_D1_p47 * inverse_D1_p73;
  const Real inverse_D1_p85 = 0.0001499998887063 * inverse_D1_p82;
  const Real inverse_D1_p86 = s10 * (inverse_D1_p84 - inverse_D1_p85) + c10 *
      (inverse_D1_p74 - inverse_D1_p83);
  const Real inverse_D1_p87 = c10 * inverse_D1_p86;
  const Real inverse_D1_p88 = inverse_D1_p87 + inverse_D1_p83;
  const Real inverse_D1_p89 = 0.004500002325 + inverse_D1_p88;
  const Real inverse_D9_p1 = s10 * inverse_D1_p54;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D9 = 1.0 / (0.0027762933559338653 + (inverse_D1_p50 + inverse_D9_p1));
  const Real inverse_D1_p90 = inverse_D1_p89 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p91 = s10 * inverse_D1_p86;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p92 = inverse_D1_p79 + inverse_D1_p55 * inverse_D1_p77;
  const Real inverse_D1_p93 = inverse_D1_p75 + inverse_D1_p58 * inverse_D1_p77;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p94 = s11 * inverse_D1_p92 + c11 * inverse_D1_p93 - inverse_D1_p81 *
      inverse_D1_p66;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p95 = inverse_D1_p36 + inverse_D1_p55 * inverse_D1_p56;
  const Real inverse_D1_p96 = inverse_D1_p17 - inverse_D1_p58 * inverse_D1_p59;
  const Real inverse_D1_p97 = inverse_D1_p41 + inverse_D1_p55 * inverse_D1_p59;
  const Real inverse_D1_p98 = s11 * (inverse_D1_p95 + inverse_D1_p96) + inverse_D1_p45 *
      inverse_D1_p97;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p99 = inverse_D1_p97 - c11 * inverse_D1_p98 - inverse_D1_p72 *
      inverse_D1_p66;
  const Real inverse_D1_p100 = s10 * inverse_D1_p94 - c10 * inverse_D1_p99;
  const Real inverse_D1_p101 = 0.282 * inverse_D1_p100;
  const Real inverse_D1_p102 = inverse_D1_p84 - inverse_D1_p91 - inverse_D1_p101;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p103 = inverse_D1_p102 - inverse_D1_p71 * inverse_D1_p90;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p104 = 0.0022500062 + inverse_D1_p70;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p105 = inverse_D1_p104 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p106 = 0.0012089992423205001 + 0.282 * inverse_D1_p88;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p107 = inverse_D1_p101 + inverse_D1_p106 * inverse_D1_p105;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p108 = s10 * inverse_D1_p69 - c10 * inverse_D1_p68;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D1_p109 = s11 * inverse_D1_p98;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p110 = inverse_D1_p96 - inverse_D1_p109 - inverse_D1_p65 * inverse_D1_p66;
  const Real inverse_D1_p111 = 0.282 * inverse_D1_p110 - inverse_D1_p108;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p112 = inverse_D1_p111 - inverse_D1_p71 * inverse_D1_p105;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p113 = s11 * inverse_D1_p93 - c11 * inverse_D1_p92 + inverse_D1_p72 *
      inverse_D1_p82;
  const Real inverse_D1_p114 = inverse_D1_p109 - inverse_D1_p95 - inverse_D1_p72 * inverse_D1_p73;
  const Real inverse_D1_p115 = inverse_D1_p35 - inverse_D1_p31 - inverse_D1_p76 * inverse_D1_p77 -
      inverse_D1_p81 * inverse_D1_p82;
  const Real inverse_D1_p116 = inverse_D1_p53 * inverse_D1_p113 - s10 *
      (inverse_D1_p114 - inverse_D1_p115);
  const Real inverse_D1_p117 = s10 * inverse_D1_p116;
  const Real inverse_D1_p118 = inverse_D1_p114 + inverse_D1_p117;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p119 = inverse_D1_p106 * inverse_D1_p90 - 0.282 * inverse_D1_p118;
  const Real inverse_D1_p120 = c9 * (inverse_D1_p103 - inverse_D1_p107) - s9 *
      (inverse_D1_p119 + inverse_D1_p112);
  const Real inverse_D1_p121 = c9 * inverse_D1_p120;
  const Real inverse_D1_p122 = inverse_D1_p107 + inverse_D1_p121;
  const Real inverse_D8_p1 = inverse_D1_p71 * inverse_D9;
  const Real inverse_D8_p2 = 0.0019585440854647937 +
      (inverse_D1_p49 - inverse_D9_p1 + 0.282 * (inverse_D1_p111 - inverse_D1_p108)) -
      inverse_D1_p71 * inverse_D8_p1;
  const Real inverse_D8_p3 = inverse_D1_p106 * inverse_D9;
  const Real inverse_D8_p4 = 0.0008177492704690715 + 0.07952399999999998 * inverse_D1_p118 -
      inverse_D1_p106 * inverse_D8_p3;
  const Real inverse_D8_p5 = 4.4999986458742003e-05 - 0.282 * inverse_D1_p102 + inverse_D1_p71 *
      inverse_D8_p3;
  const Real inverse_D8_p6 = 2.0 * s9;
  const Real inverse_D8_p7 = c9 * (inverse_D8_p2 - inverse_D8_p4) - inverse_D8_p6 * inverse_D8_p5;
  const Real inverse_D8_p8 = c9 * inverse_D8_p7;
  const Real inverse_D8_p9 = 0.18125194219699997 + (inverse_D8_p4 + inverse_D8_p8);

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D8 = 1.0 / inverse_D8_p9;
  const Real inverse_D1_p123 = inverse_D1_p122 * inverse_D8;
  const Real inverse_D1_p124 = 0.0017499999999999998 + 0.00010499999999999999 * inverse_D1_p123;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p125 = s9 * inverse_D8_p7 + inverse_D8_p5 - 1.75e-05;
  const Real inverse_D1_p126 = s9 * inverse_D1_p120;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D1_p127 = inverse_D1_p126 + inverse_D1_p119 - 0.7139200499999999 -
      inverse_D1_p125 * inverse_D1_p123;
  const Real inverse_D1_p128 = 0.0017499999999999998 +
      (s8 * inverse_D1_p124 + c8 * inverse_D1_p127);
  const Real inverse_D7_p1 = inverse_D1_p125 * inverse_D8;
  const Real inverse_D7_p2 = 0.18113119219699997 + (inverse_D8_p2 - inverse_D8_p8) -
      inverse_D1_p125 * inverse_D7_p1;
  const Real inverse_D7_p3 = 0.00012075 - 1.1024999999999998e-08 / inverse_D8_p9;
  const Real inverse_D7_p4 = 0.00010499999999999999 * inverse_D7_p1 - 5.2499999999999995e-05;
  const Real inverse_D7_p5 = 2.0 * c8;
  const Real inverse_D7_p6 = s8 * (inverse_D7_p3 - inverse_D7_p2) + inverse_D7_p5 * inverse_D7_p4;
  const Real inverse_D7_p7 = s8 * inverse_D7_p6;
  const Real inverse_D7_p8 = 0.000448 + (inverse_D7_p2 + inverse_D7_p7);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D7 = 1.0 / inverse_D7_p8;
  const Real inverse_D1_p129 = inverse_D1_p128 * inverse_D7;
  const Real inverse_D1_p130 = 2.6249999999999998e-05 * inverse_D1_p129;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p131 = inverse_D1_p85 + inverse_D1_p91;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p132 = inverse_D1_p131 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p133 = s10 * inverse_D1_p99 + c10 * inverse_D1_p94;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p134 = 0.004500002325 - (inverse_D1_p87 - inverse_D1_p74 + 0.282 *
      inverse_D1_p133) + inverse_D1_p71 * inverse_D1_p132;

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D1_p135 = inverse_D1_p113 - c10 * inverse_D1_p116;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p136 = 0.0022500062 + 0.282 * inverse_D1_p135 - inverse_D1_p106 *
      inverse_D1_p132;
  const Real inverse_D1_p137 = 0.0017499999999999998 +
      (c9 * inverse_D1_p134 - s9 * inverse_D1_p136);

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D1_p138 = inverse_D1_p137 * inverse_D8;
  const Real inverse_D1_p139 = inverse_D1_p125 * inverse_D1_p138 -
      (s9 * inverse_D1_p134 + c9 * inverse_D1_p136);

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p140 = 0.7139200499999999 + (inverse_D1_p126 + inverse_D1_p112);

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D1_p141 = inverse_D1_p140 * inverse_D8;
  const Real inverse_D1_p142 = 0.00010499999999999999 * inverse_D1_p141;
  const Real inverse_D1_p143 = inverse_D1_p103 - inverse_D1_p121 - inverse_D1_p125 *
      inverse_D1_p141;
  const Real inverse_D1_p144 = 0.00010499999999999999 * inverse_D1_p138;
  const Real inverse_D1_p145 = c8 * (inverse_D1_p139 + inverse_D1_p142) - s8 *
      (inverse_D1_p144 + inverse_D1_p143);
  const Real inverse_D1_p146 = c8 * inverse_D1_p145;
  const Real inverse_D1_p147 = 0.0017499999999999998 + (inverse_D1_p146 - inverse_D1_p142);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p148 = inverse_D1_p147 * inverse_D7;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D1_p149 = c8 * inverse_D7_p6 - inverse_D7_p4 - 2.6249999999999998e-05;
  const Real inverse_D1_p150 = s8 * inverse_D1_p145;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p151 = inverse_D1_p144 + inverse_D1_p150 + inverse_D1_p149 *
      inverse_D1_p148;
  const Real inverse_D1_p152 = c8 * inverse_D1_p124 - s8 * inverse_D1_p127 - inverse_D1_p149 *
      inverse_D1_p129;
  const Real inverse_D1_p153 = 2.6249999999999998e-05 * inverse_D1_p148;
  const Real inverse_D1_p154 = c7 * (inverse_D1_p130 + inverse_D1_p151) - s7 *
      (inverse_D1_p152 + inverse_D1_p153);
  const Real inverse_D1_p155 = s7 * inverse_D1_p154;
  const Real inverse_D1_p156 = inverse_D1_p155 + inverse_D1_p153;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p157 = inverse_D1_p118 - inverse_D1_p89 * inverse_D1_p90;
  const Real inverse_D1_p158 = inverse_D1_p110 - inverse_D1_p104 * inverse_D1_p105;
  const Real inverse_D1_p159 = inverse_D1_p100 + inverse_D1_p89 * inverse_D1_p105;
  const Real inverse_D1_p160 = c9 * (inverse_D1_p157 - inverse_D1_p158) + inverse_D8_p6 *
      inverse_D1_p159;
  const Real inverse_D1_p161 = c9 * inverse_D1_p160;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p162 = inverse_D1_p158 + inverse_D1_p161 - inverse_D1_p122 *
      inverse_D1_p123 - inverse_D1_p128 * inverse_D1_p129;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D1_p163 = inverse_D1_p157 - inverse_D1_p161 - inverse_D1_p140 *
      inverse_D1_p141;
  const Real inverse_D1_p164 = inverse_D1_p115 - inverse_D1_p117 - inverse_D1_p131 *
      inverse_D1_p132 - inverse_D1_p137 * inverse_D1_p138;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D1_p165 = inverse_D1_p89 * inverse_D1_p132 - inverse_D1_p135;
  const Real inverse_D1_p166 = inverse_D1_p104 * inverse_D1_p132 - inverse_D1_p133;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D1_p167 = inverse_D1_p137 * inverse_D1_p141 -
      (s9 * inverse_D1_p165 + c9 * inverse_D1_p166);
  const Real inverse_D1_p168 = s8 * (inverse_D1_p164 - inverse_D1_p163) + inverse_D7_p5 *
      inverse_D1_p167;
  const Real inverse_D1_p169 = s8 * inverse_D1_p168;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p170 = inverse_D1_p164 - inverse_D1_p169 - inverse_D1_p147 *
      inverse_D1_p148;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D1_p171 = inverse_D1_p137 * inverse_D1_p123 -
      (c9 * inverse_D1_p165 - s9 * inverse_D1_p166);
  const Real inverse_D1_p172 = inverse_D1_p159 - s9 * inverse_D1_p160 + inverse_D1_p140 *
      inverse_D1_p123;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p173 = c8 * inverse_D1_p171 + s8 * inverse_D1_p172 - inverse_D1_p128 *
      inverse_D1_p148;
  const Real inverse_D1_p174 = 2.0 * s7;
  const Real inverse_D1_p175 = c7 * (inverse_D1_p162 - inverse_D1_p170) - inverse_D1_p174 *
      inverse_D1_p173;
  const Real inverse_D1_p176 = c7 * inverse_D1_p175;
  const Real inverse_D1_p177 = inverse_D1_p162 - inverse_D1_p176;

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D1_p178 = inverse_D1_p143 + inverse_D1_p150;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p179 = inverse_D1_p178 * inverse_D7;
  const Real inverse_D1_p180 = s8 * inverse_D1_p171 - c8 * inverse_D1_p172 - inverse_D1_p128 *
      inverse_D1_p179;
  const Real inverse_D1_p181 = c8 * inverse_D1_p168 - inverse_D1_p167 - inverse_D1_p147 *
      inverse_D1_p179;
  const Real inverse_D1_p182 = s7 * inverse_D1_p180 + c7 * inverse_D1_p181;
  const Real inverse_D1_p183 = inverse_D1_p156 - (0.18 * inverse_D1_p177 + 0.226 * inverse_D1_p182);

  // link 20 (right_hand), articulated inertia
  const Real inverse_D1_p184 = 0.0007660844555829042 * s20 + 0.0002628975791811551 * c20;
  const Real inverse_D1_p185 = 0.00013384878959057754 - c20 * inverse_D1_p184;
  const Real inverse_D19_p1 = s20 * inverse_D1_p184;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D19 = 1.0 / (0.0010519177038056625 - inverse_D19_p1);
  const Real inverse_D1_p186 = inverse_D1_p185 * inverse_D19;
  const Real inverse_D1_p187 = 0.0002742332482227584 + inverse_D19_p1 - inverse_D1_p185 *
      inverse_D1_p186;
  const Real inverse_D1_p188 = s19 * (1.16e-05 - inverse_D1_p187);

  // link 20 (right_hand), articulated inertia
  const Real inverse_D1_p189 = 0.001742099791326752 * c20 - 0.001090468517736955 * s20;
  const Real inverse_D1_p190 = s20 * inverse_D1_p189;
  const Real inverse_D1_p191 = 0.000760024621759417 + inverse_D1_p190;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D1_p192 = inverse_D1_p191 * inverse_D19;

  // link 20 (right_hand), articulated inertia
  const Real inverse_D1_p193 = c20 * inverse_D1_p189;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D1_p194 = inverse_D1_p193 - 0.002376125662528793 - inverse_D1_p185 *
      inverse_D1_p192;
  const Real inverse_D1_p195 = 0.0006000000000000001 * s19 + c19 * inverse_D1_p194;
  const Real inverse_D1_p196 = 0.000144 - (c19 * inverse_D1_p188 + 0.269 * inverse_D1_p195);
  const Real inverse_D18_p1 = s19 * inverse_D1_p188;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D18 = 1.0 / (0.00022920000000000001 + (inverse_D1_p187 + inverse_D18_p1));

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D1_p197 = 6e-04 - inverse_D1_p195;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p198 = inverse_D1_p197 * inverse_D18;

  // link 20 (right_hand), articulated inertia
  const Real inverse_D1_p199 = 0.27310176737964387 * s20 + 0.09929187165525127 * c20;
  const Real inverse_D1_p200 = s20 * inverse_D1_p199;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D1_p201 = inverse_D1_p200 - 0.2818466605750157 - inverse_D1_p191 *
      inverse_D1_p192;
  const Real inverse_D1_p202 = s19 * inverse_D1_p194 - 0.0006000000000000001 * c19;
  const Real inverse_D1_p203 = 0.269 * inverse_D1_p201 - inverse_D1_p202;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p204 = inverse_D1_p203 - inverse_D1_p196 * inverse_D1_p198;

  // link 20 (right_hand), articulated inertia
  const Real inverse_D1_p205 = 0.0006340258712020409 + inverse_D1_p193;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D1_p206 = inverse_D1_p205 * inverse_D19;
  const Real inverse_D1_p207 = 0.00033044389597753786 + inverse_D1_p190 + inverse_D1_p185 *
      inverse_D1_p206;

  // link 20 (right_hand), articulated inertia
  const Real inverse_D1_p208 = 0.002865001425 * s20 - 0.01626499875 * c20 - 0.0006000000000000001;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D1_p209 = inverse_D1_p208 * inverse_D19;
  const Real inverse_D1_p210 = 0.002865001425 * c20 + 0.01626499875 * s20 - inverse_D1_p185 *
      inverse_D1_p209;
  const Real inverse_D1_p211 = s19 * inverse_D1_p207 + c19 * inverse_D1_p210;
  const Real inverse_D1_p212 = c19 * inverse_D1_p211;
  const Real inverse_D1_p213 = 0.001 - inverse_D1_p212;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p214 = inverse_D1_p213 * inverse_D18;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D1_p215 = 0.269 * inverse_D1_p212 - 0.0002516;
  const Real inverse_D1_p216 = 0.008744893195371809 + inverse_D1_p200 + inverse_D1_p205 *
      inverse_D1_p206;
  const Real inverse_D1_p217 = inverse_D1_p208 * inverse_D1_p209;
  const Real inverse_D1_p218 = inverse_D1_p208 * inverse_D1_p206;
  const Real inverse_D1_p219 = c19 * (2.0 * inverse_D1_p218) - s19 *
      (inverse_D1_p216 - inverse_D1_p217);
  const Real inverse_D1_p220 = s19 * inverse_D1_p219;
  const Real inverse_D1_p221 = inverse_D1_p220 - inverse_D1_p217;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p222 = 0.269 * inverse_D1_p221 + inverse_D1_p215 * inverse_D1_p214;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D1_p223 = s19 * inverse_D1_p211;
  const Real inverse_D1_p224 = inverse_D1_p208 * inverse_D1_p192;
  const Real inverse_D1_p225 = c20 * inverse_D1_p199 - 0.04964593582762564 - inverse_D1_p205 *
      inverse_D1_p192;
  const Real inverse_D1_p226 = c19 * inverse_D1_p224 + s19 * inverse_D1_p225;
  const Real inverse_D1_p227 = 0.269 * inverse_D1_p226;
  const Real inverse_D1_p228 = inverse_D1_p223 + inverse_D1_p227;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p229 = inverse_D1_p228 + inverse_D1_p196 * inverse_D1_p214;
  const Real inverse_D1_p230 = inverse_D1_p227 - inverse_D1_p215 * inverse_D1_p198;
  const Real inverse_D1_p231 = c18 * (inverse_D1_p204 - inverse_D1_p222) - s18 *
      (inverse_D1_p229 + inverse_D1_p230);
  const Real inverse_D1_p232 = s18 * inverse_D1_p231;
  const Real inverse_D1_p233 = inverse_D1_p230 + inverse_D1_p232;
  const Real inverse_D17_p1 = inverse_D1_p196 * inverse_D18;
  const Real inverse_D17_p2 = 0.000131 - inverse_D18_p1 + 0.269 *
      (inverse_D1_p203 - inverse_D1_p202) - inverse_D1_p196 * inverse_D17_p1;
  const Real inverse_D17_p3 = inverse_D1_p215 * inverse_D18;
  const Real inverse_D17_p4 = 0.0001098 + 0.07236100000000001 * inverse_D1_p221 - inverse_D1_p215 *
      inverse_D17_p3;
  const Real inverse_D17_p5 = 6e-06 + 0.269 * inverse_D1_p228 - inverse_D1_p196 * inverse_D17_p3;
  const Real inverse_D17_p6 = 2.0 * c18;
  const Real inverse_D17_p7 = s18 * (inverse_D17_p2 - inverse_D17_p4) + inverse_D17_p6 *
      inverse_D17_p5;
  const Real inverse_D17_p8 = s18 * inverse_D17_p7;
  const Real inverse_D17_p9 = 0.060888541114265754 + (inverse_D17_p4 + inverse_D17_p8);

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D17 = 1.0 / inverse_D17_p9;
  const Real inverse_D1_p234 = inverse_D1_p233 * inverse_D17;
  const Real inverse_D1_p235 = 0.0014999985000000002 + 0.0001499998887063 * inverse_D1_p234;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p236 = 2.249994685315e-05 + (c18 * inverse_D17_p7 - inverse_D17_p5);
  const Real inverse_D1_p237 = c18 * inverse_D1_p231;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p238 = 0.28049749700000004 + (inverse_D1_p237 + inverse_D1_p222) -
      inverse_D1_p236 * inverse_D1_p234;
  const Real inverse_D1_p239 = c17 * inverse_D1_p235 - s17 * inverse_D1_p238;
  const Real inverse_D1_p240 = 0.0001499998887063 / inverse_D17_p9;
  const Real inverse_D1_p241 = 0.0001499998887063 + inverse_D1_p236 * inverse_D1_p240;
  const Real inverse_D1_p242 = 2.0 * c17;
  const Real inverse_D1_p243 = inverse_D1_p236 * inverse_D17;
  const Real inverse_D1_p244 = 0.06060754126741261 + (inverse_D17_p2 - inverse_D17_p8) -
      inverse_D1_p236 * inverse_D1_p243;
  const Real inverse_D1_p245 = 0.00028099984685315 - 2.249996661190239e-08 / inverse_D17_p9;
  const Real inverse_D1_p246 = inverse_D1_p242 * inverse_D1_p241 - s17 *
      (inverse_D1_p244 - inverse_D1_p245);
  const Real inverse_D1_p247 = 0.282 * inverse_D1_p239 - (inverse_D1_p241 - c17 * inverse_D1_p246) -
      0.0005895000784280001;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p248 = inverse_D1_p237 - inverse_D1_p204 - 0.28049749700000004;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p249 = inverse_D1_p248 * inverse_D17;
  const Real inverse_D1_p250 = 0.0001499998887063 * inverse_D1_p249;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D1_p251 = s19 * inverse_D1_p224 - c19 * inverse_D1_p225;
  const Real inverse_D1_p252 = inverse_D1_p223 - inverse_D1_p207;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p253 = inverse_D1_p252 * inverse_D18;
  const Real inverse_D1_p254 = 0.269 * inverse_D1_p251 - (inverse_D1_p212 - inverse_D1_p210) -
      0.001 - inverse_D1_p196 * inverse_D1_p253;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D1_p255 = inverse_D1_p218 - c19 * inverse_D1_p219;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p256 = 0.269 * inverse_D1_p255 - 6e-04 - inverse_D1_p215 * inverse_D1_p253;
  const Real inverse_D1_p257 = 0.0014999985000000002 -
      (s18 * inverse_D1_p254 + c18 * inverse_D1_p256);

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p258 = inverse_D1_p257 * inverse_D17;
  const Real inverse_D1_p259 = c18 * inverse_D1_p254 - s18 * inverse_D1_p256 + inverse_D1_p236 *
      inverse_D1_p258;
  const Real inverse_D1_p260 = inverse_D1_p229 + inverse_D1_p232 + inverse_D1_p236 *
      inverse_D1_p249;
  const Real inverse_D1_p261 = 0.0001499998887063 * inverse_D1_p258;
  const Real inverse_D1_p262 = c17 * (inverse_D1_p250 + inverse_D1_p259) - s17 *
      (inverse_D1_p261 - inverse_D1_p260);
  const Real inverse_D1_p263 = c17 * inverse_D1_p262;
  const Real inverse_D1_p264 = inverse_D1_p259 - inverse_D1_p263;
  const Real inverse_D1_p265 = 0.004500002325 - inverse_D1_p264;
  const Real inverse_D16_p1 = s17 * inverse_D1_p246;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D16 = 1.0 / (0.0027762933559338653 + (inverse_D1_p245 - inverse_D16_p1));
  const Real inverse_D1_p266 = inverse_D1_p265 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p267 = s17 * inverse_D1_p262;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p268 = inverse_D1_p221 - inverse_D1_p213 * inverse_D1_p214;
  const Real inverse_D1_p269 = inverse_D1_p201 - inverse_D1_p197 * inverse_D1_p198;
  const Real inverse_D1_p270 = inverse_D1_p226 + inverse_D1_p213 * inverse_D1_p198;
  const Real inverse_D1_p271 = s18 * (inverse_D1_p268 - inverse_D1_p269) - inverse_D17_p6 *
      inverse_D1_p270;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p272 = c18 * inverse_D1_p271 + inverse_D1_p270 - inverse_D1_p248 *
      inverse_D1_p234;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p273 = inverse_D1_p251 - inverse_D1_p197 * inverse_D1_p253;
  const Real inverse_D1_p274 = inverse_D1_p255 + inverse_D1_p213 * inverse_D1_p253;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p275 = c18 * inverse_D1_p273 - s18 * inverse_D1_p274 + inverse_D1_p257 *
      inverse_D1_p234;
  const Real inverse_D1_p276 = c17 * inverse_D1_p272 + s17 * inverse_D1_p275;
  const Real inverse_D1_p277 = 0.282 * inverse_D1_p276;
  const Real inverse_D1_p278 = inverse_D1_p267 - inverse_D1_p260 + inverse_D1_p277;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p279 = inverse_D1_p278 - inverse_D1_p247 * inverse_D1_p266;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p280 = inverse_D1_p239 - 0.0022500062;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p281 = inverse_D1_p280 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p282 = 0.282 * inverse_D1_p264 - 0.0012089992423205001;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p283 = inverse_D1_p277 + inverse_D1_p282 * inverse_D1_p281;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p284 = c17 * inverse_D1_p238 + s17 * inverse_D1_p235;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D1_p285 = s18 * inverse_D1_p271;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p286 = inverse_D1_p269 + inverse_D1_p285 - inverse_D1_p233 *
      inverse_D1_p234;
  const Real inverse_D1_p287 = inverse_D1_p284 + 0.282 * inverse_D1_p286;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p288 = inverse_D1_p287 - inverse_D1_p247 * inverse_D1_p281;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p289 = inverse_D1_p268 - inverse_D1_p285 - inverse_D1_p248 *
      inverse_D1_p249;
  const Real inverse_D1_p290 = inverse_D1_p216 + inverse_D1_p220 + inverse_D1_p252 *
      inverse_D1_p253 + inverse_D1_p257 * inverse_D1_p258;
  const Real inverse_D1_p291 = c18 * inverse_D1_p274 + s18 * inverse_D1_p273 - inverse_D1_p248 *
      inverse_D1_p258;
  const Real inverse_D1_p292 = s17 * (inverse_D1_p289 + inverse_D1_p290) + inverse_D1_p242 *
      inverse_D1_p291;
  const Real inverse_D1_p293 = s17 * inverse_D1_p292;
  const Real inverse_D1_p294 = inverse_D1_p289 - inverse_D1_p293;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p295 = 0.282 * inverse_D1_p294 + inverse_D1_p282 * inverse_D1_p266;
  const Real inverse_D1_p296 = c16 * (inverse_D1_p279 + inverse_D1_p283) - s16 *
      (inverse_D1_p288 - inverse_D1_p295);
  const Real inverse_D1_p297 = c16 * inverse_D1_p296;
  const Real inverse_D1_p298 = inverse_D1_p297 - inverse_D1_p283;
  const Real inverse_D15_p1 = inverse_D1_p247 * inverse_D16;
  const Real inverse_D15_p2 = 0.0019585440854647937 +
      (inverse_D1_p244 + inverse_D16_p1 + 0.282 * (inverse_D1_p284 + inverse_D1_p287)) -
      inverse_D1_p247 * inverse_D15_p1;
  const Real inverse_D15_p3 = inverse_D1_p282 * inverse_D16;
  const Real inverse_D15_p4 = 0.0008177492704690715 + 0.07952399999999998 * inverse_D1_p294 -
      inverse_D1_p282 * inverse_D15_p3;
  const Real inverse_D15_p5 = 4.4999986458742003e-05 + 0.282 * inverse_D1_p278 + inverse_D1_p247 *
      inverse_D15_p3;
  const Real inverse_D15_p6 = 2.0 * s16;
  const Real inverse_D15_p7 = c16 * (inverse_D15_p2 - inverse_D15_p4) + inverse_D15_p6 *
      inverse_D15_p5;
  const Real inverse_D15_p8 = c16 * inverse_D15_p7;
  const Real inverse_D15_p9 = 0.18125194219699997 + (inverse_D15_p4 + inverse_D15_p8);

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D15 = 1.0 / inverse_D15_p9;
  const Real inverse_D1_p299 = inverse_D1_p298 * inverse_D15;
  const Real inverse_D1_p300 = 0.00010499999999999999 * inverse_D1_p299 - 0.0017499999999999998;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p301 = 1.75e-05 - (inverse_D15_p5 - s16 * inverse_D15_p7);
  const Real inverse_D1_p302 = s16 * inverse_D1_p296;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D1_p303 = 0.7139200499999999 + (inverse_D1_p295 - inverse_D1_p302) +
      inverse_D1_p301 * inverse_D1_p299;
  const Real inverse_D1_p304 = 0.0017499999999999998 +
      (s15 * inverse_D1_p300 - c15 * inverse_D1_p303);
  const Real inverse_D14_p1 = inverse_D1_p301 * inverse_D15;
  const Real inverse_D14_p2 = 0.18113119219699997 + (inverse_D15_p2 - inverse_D15_p8) -
      inverse_D1_p301 * inverse_D14_p1;
  const Real inverse_D14_p3 = 0.00012075 - 1.1024999999999998e-08 / inverse_D15_p9;
  const Real inverse_D14_p4 = 5.2499999999999995e-05 + 0.00010499999999999999 * inverse_D14_p1;
  const Real inverse_D14_p5 = 2.0 * c15;
  const Real inverse_D14_p6 = s15 * (inverse_D14_p3 - inverse_D14_p2) + inverse_D14_p5 *
      inverse_D14_p4;
  const Real inverse_D14_p7 = s15 * inverse_D14_p6;
  const Real inverse_D14_p8 = 0.000448 + (inverse_D14_p2 + inverse_D14_p7);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D14 = 1.0 / inverse_D14_p8;
  const Real inverse_D1_p305 = inverse_D1_p304 * inverse_D14;
  const Real inverse_D1_p306 = 2.6249999999999998e-05 * inverse_D1_p305;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p307 = 0.7139200499999999 + (inverse_D1_p302 + inverse_D1_p288);

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D1_p308 = inverse_D1_p307 * inverse_D15;
  const Real inverse_D1_p309 = 0.00010499999999999999 * inverse_D1_p308;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p310 = inverse_D1_p261 + inverse_D1_p267;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p311 = inverse_D1_p310 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p312 = c17 * inverse_D1_p275 - s17 * inverse_D1_p272;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p313 = 0.282 * inverse_D1_p312 - (inverse_D1_p250 - inverse_D1_p263) -
      0.004500002325 + inverse_D1_p247 * inverse_D1_p311;

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D1_p314 = c17 * inverse_D1_p292 - inverse_D1_p291;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p315 = 0.0022500062 + 0.282 * inverse_D1_p314 + inverse_D1_p282 *
      inverse_D1_p311;
  const Real inverse_D1_p316 = 0.0017499999999999998 -
      (c16 * inverse_D1_p313 - s16 * inverse_D1_p315);

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D1_p317 = inverse_D1_p316 * inverse_D15;
  const Real inverse_D1_p318 = s16 * inverse_D1_p313 + c16 * inverse_D1_p315 + inverse_D1_p301 *
      inverse_D1_p317;
  const Real inverse_D1_p319 = inverse_D1_p279 - inverse_D1_p297 - inverse_D1_p301 *
      inverse_D1_p308;
  const Real inverse_D1_p320 = 0.00010499999999999999 * inverse_D1_p317;
  const Real inverse_D1_p321 = s15 * (inverse_D1_p320 - inverse_D1_p319) + c15 *
      (inverse_D1_p309 - inverse_D1_p318);
  const Real inverse_D1_p322 = c15 * inverse_D1_p321;
  const Real inverse_D1_p323 = 0.0017499999999999998 + (inverse_D1_p322 - inverse_D1_p309);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D1_p324 = inverse_D1_p323 * inverse_D14;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D1_p325 = 2.6249999999999998e-05 + (c15 * inverse_D14_p6 - inverse_D14_p4);
  const Real inverse_D1_p326 = s15 * inverse_D1_p321;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D1_p327 = inverse_D1_p320 - inverse_D1_p326 - inverse_D1_p325 *
      inverse_D1_p324;
  const Real inverse_D1_p328 = c15 * inverse_D1_p300 + s15 * inverse_D1_p303 - inverse_D1_p325 *
      inverse_D1_p305;
  const Real inverse_D1_p329 = 2.6249999999999998e-05 * inverse_D1_p324;
  const Real inverse_D1_p330 = c14 * (inverse_D1_p306 + inverse_D1_p327) + s14 *
      (inverse_D1_p328 - inverse_D1_p329);
  const Real inverse_D1_p331 = s14 * inverse_D1_p330;
  const Real inverse_D1_p332 = inverse_D1_p331 + inverse_D1_p329;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D1_p333 = inverse_D1_p319 + inverse_D1_p326;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D1_p334 = inverse_D1_p333 * inverse_D14;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p335 = inverse_D1_p294 - inverse_D1_p265 * inverse_D1_p266;
  const Real inverse_D1_p336 = inverse_D1_p286 - inverse_D1_p280 * inverse_D1_p281;
  const Real inverse_D1_p337 = inverse_D1_p276 - inverse_D1_p265 * inverse_D1_p281;
  const Real inverse_D1_p338 = c16 * (inverse_D1_p335 - inverse_D1_p336) - inverse_D15_p6 *
      inverse_D1_p337;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D1_p339 = s16 * inverse_D1_p338 + inverse_D1_p337 - inverse_D1_p307 *
      inverse_D1_p299;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p340 = inverse_D1_p265 * inverse_D1_p311 - inverse_D1_p314;
  const Real inverse_D1_p341 = inverse_D1_p312 + inverse_D1_p280 * inverse_D1_p311;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D1_p342 = c16 * inverse_D1_p340 - s16 * inverse_D1_p341 + inverse_D1_p316 *
      inverse_D1_p299;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D1_p343 = c15 * inverse_D1_p339 - s15 * inverse_D1_p342 - inverse_D1_p304 *
      inverse_D1_p334;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D1_p344 = c16 * inverse_D1_p338;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D1_p345 = inverse_D1_p335 - inverse_D1_p344 - inverse_D1_p307 *
      inverse_D1_p308;
  const Real inverse_D1_p346 = inverse_D1_p293 - inverse_D1_p290 - inverse_D1_p310 *
      inverse_D1_p311 - inverse_D1_p316 * inverse_D1_p317;
  const Real inverse_D1_p347 = s16 * inverse_D1_p340 + c16 * inverse_D1_p341 + inverse_D1_p316 *
      inverse_D1_p308;
  const Real inverse_D1_p348 = s15 * (inverse_D1_p346 - inverse_D1_p345) - inverse_D14_p5 *
      inverse_D1_p347;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D1_p349 = c15 * inverse_D1_p348 + inverse_D1_p347 - inverse_D1_p323 *
      inverse_D1_p334;
  const Real inverse_D1_p350 = s14 * inverse_D1_p343 + c14 * inverse_D1_p349;
  const Real inverse_D1_p351 = inverse_D1_p336 + inverse_D1_p344 - inverse_D1_p298 *
      inverse_D1_p299 - inverse_D1_p304 * inverse_D1_p305;

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D1_p352 = s15 * inverse_D1_p348;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D1_p353 = inverse_D1_p346 - inverse_D1_p352 - inverse_D1_p323 *
      inverse_D1_p324;
  const Real inverse_D1_p354 = c15 * inverse_D1_p342 + s15 * inverse_D1_p339 + inverse_D1_p304 *
      inverse_D1_p324;
  const Real inverse_D1_p355 = 2.0 * s14;
  const Real inverse_D1_p356 = c14 * (inverse_D1_p351 - inverse_D1_p353) + inverse_D1_p355 *
      inverse_D1_p354;
  const Real inverse_D1_p357 = c14 * inverse_D1_p356;
  const Real inverse_D1_p358 = inverse_D1_p351 - inverse_D1_p357;
  const Real inverse_D1_p359 = inverse_D1_p332 + (0.226 * inverse_D1_p350 - 0.18 * inverse_D1_p358);

  // link 23 (left_eye), articulated inertia
  const Real inverse_D1_p360 = 0.0007770270270270272 * c23;
  const Real inverse_D1_p361 = c23 * inverse_D1_p360;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D1_p362 = 0.0007770270270270272 * c24;
  const Real inverse_D1_p363 = c24 * inverse_D1_p362;
  const Real inverse_D1_p364 = s24 * inverse_D1_p362;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D1_p365 = s23 * inverse_D1_p360;
  const Real inverse_D1_p366 = inverse_D1_p364 + inverse_D1_p365;
  const Real inverse_D1_p367 = 0.032 * (inverse_D1_p361 - inverse_D1_p363) - 0.095 *
      inverse_D1_p366;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p368 = inverse_D1_p361 + inverse_D1_p363;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D1_p369 = 0.430445945945946 + inverse_D1_p368;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D22_p1 = 9.060810810810813e-05 * s24;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D22_p2 = 9.060810810810813e-05 * s23;
  const Real inverse_D22_p3 = s24 * inverse_D22_p1 + s23 * inverse_D22_p2;
  const Real inverse_D22_p4 = c24 + c23;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p3 + 4.75e-05 * inverse_D22_p4);
  const Real inverse_D1_p370 = inverse_D1_p369 * inverse_D22;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D1_p371 = 0.006756756756756757 * s24;
  const Real inverse_D1_p372 = c24 * inverse_D1_p371;
  const Real inverse_D1_p373 = s24 * inverse_D1_p371;
  const Real inverse_D1_p374 = 0.095 * inverse_D1_p372 - 0.032 * inverse_D1_p373;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D1_p375 = 0.006756756756756757 * s23;
  const Real inverse_D1_p376 = c23 * inverse_D1_p375;
  const Real inverse_D1_p377 = s23 * inverse_D1_p375;
  const Real inverse_D1_p378 = 0.095 * inverse_D1_p376 + 0.032 * inverse_D1_p377;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p379 = inverse_D1_p374 + inverse_D1_p378 + inverse_D1_p367 *
      inverse_D1_p370;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D1_p380 = s24 + s23;
  const Real inverse_D1_p381 = 8e-06 * (c24 - c23) -
      (c24 * inverse_D22_p1 + c23 * inverse_D22_p2 + 2.375e-05 * inverse_D1_p380);
  const Real inverse_D1_p382 = 0.072575 + 0.00025 * inverse_D22_p4;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p383 = inverse_D1_p382 * inverse_D22;
  const Real inverse_D1_p384 = inverse_D1_p381 * inverse_D1_p383 + 0.00025 * inverse_D1_p380;
  const Real inverse_D1_p385 = inverse_D1_p367 * inverse_D1_p383;
  const Real inverse_D1_p386 = inverse_D1_p366 + inverse_D1_p381 * inverse_D1_p370;
  const Real inverse_D1_p387 = c22 * (inverse_D1_p379 + inverse_D1_p384) - s22 *
      (inverse_D1_p385 - inverse_D1_p386);
  const Real inverse_D1_p388 = s22 * inverse_D1_p387;
  const Real inverse_D1_p389 = inverse_D1_p385 + inverse_D1_p388;
  const Real inverse_D21_p1 = inverse_D1_p367 * inverse_D22;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D21_p2 = inverse_D1_p373 - 0.006756756756756757;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D21_p3 = inverse_D1_p377 - 0.006756756756756757;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p4 = 0.095 * inverse_D21_p2 + 0.032 * inverse_D1_p372 +
      (0.095 * inverse_D21_p3 - 0.032 * inverse_D1_p376);
  const Real inverse_D21_p5 = 0.009438624999999999 - inverse_D1_p367 * inverse_D21_p1 + 0.095 *
      inverse_D21_p4 + 0.032 * (inverse_D1_p374 - inverse_D1_p378);
  const Real inverse_D21_p6 = inverse_D1_p381 * inverse_D22;
  const Real inverse_D21_p7 = 0.05450270000000001 + inverse_D22_p3 - inverse_D1_p381 *
      inverse_D21_p6 + 1.6e-05 * (s23 - s24) - 0.00017071621621621625;
  const Real inverse_D21_p8 = 0.0074 - inverse_D1_p381 * inverse_D21_p1 - 0.095 * inverse_D1_p368 +
      0.032 * (inverse_D1_p364 - inverse_D1_p365);
  const Real inverse_D21_p9 = 2.0 * c22;
  const Real inverse_D21_p10 = s22 * (inverse_D21_p7 - inverse_D21_p5) + inverse_D21_p9 *
      inverse_D21_p8;
  const Real inverse_D21_p11 = s22 * inverse_D21_p10;

  // link 21 (neck), articulated inertia
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p5 + inverse_D21_p11));
  const Real inverse_D1_p390 = inverse_D1_p389 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p391 = c22 * inverse_D1_p387;
  const Real inverse_D1_p392 = inverse_D1_p384 - inverse_D1_p391;
  const Real inverse_D1_p393 = 0.394 * inverse_D1_p392;
  const Real inverse_D1_p394 = inverse_D1_p369 * inverse_D1_p383;
  const Real inverse_D1_p395 = inverse_D1_p373 + inverse_D1_p377 + inverse_D1_p369 *
      inverse_D1_p370;
  const Real inverse_D1_p396 = inverse_D1_p382 * inverse_D1_p383;
  const Real inverse_D1_p397 = inverse_D21_p9 * inverse_D1_p394 - s22 *
      (inverse_D1_p396 - inverse_D1_p395);
  const Real inverse_D1_p398 = inverse_D1_p394 - c22 * inverse_D1_p397;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p399 = 0.0045000000000000005 + 0.394 * inverse_D1_p398 + inverse_D1_p393 *
      inverse_D1_p390;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p400 = inverse_D1_p366 * inverse_D22;
  const Real inverse_D1_p401 = 0.072575 + inverse_D21_p4 + inverse_D1_p367 * inverse_D1_p400;
  const Real inverse_D1_p402 = inverse_D1_p368 - 0.43200000000000005 - inverse_D1_p381 *
      inverse_D1_p400;
  const Real inverse_D1_p403 = c22 * inverse_D1_p401 - s22 * inverse_D1_p402;
  const Real inverse_D1_p404 = 0.0016155 + (c22 * inverse_D21_p10 - inverse_D21_p8 + 0.394 *
      inverse_D1_p403);
  const Real inverse_D1_p405 = inverse_D1_p382 * inverse_D1_p400;
  const Real inverse_D1_p406 = inverse_D1_p372 + inverse_D1_p376 - inverse_D1_p369 *
      inverse_D1_p400;
  const Real inverse_D1_p407 = c22 * inverse_D1_p405 - s22 * inverse_D1_p406;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p408 = inverse_D1_p379 - inverse_D1_p391 + 0.394 * inverse_D1_p407 +
      inverse_D1_p404 * inverse_D1_p390;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p409 = inverse_D1_p183 - (s21 * inverse_D1_p399 - c21 * inverse_D1_p408 +
      inverse_D1_p359);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D6_p1 = inverse_D1_p325 * inverse_D14;
  const Real inverse_D6_p2 = 0.0002975 + (inverse_D14_p3 - inverse_D14_p7) - inverse_D1_p325 *
      inverse_D6_p1;
  const Real inverse_D6_p3 = 6.890624999999999e-10 / inverse_D14_p8;
  const Real inverse_D6_p4 = 2.6249999999999998e-05 * inverse_D6_p1;
  const Real inverse_D6_p5 = c14 * (0.0001505 - inverse_D6_p3 - inverse_D6_p2) + inverse_D1_p355 *
      (8.75e-06 + inverse_D6_p4);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p6 = inverse_D1_p149 * inverse_D7;
  const Real inverse_D6_p7 = 0.0002975 + (inverse_D7_p3 - inverse_D7_p7) - inverse_D1_p149 *
      inverse_D6_p6;
  const Real inverse_D6_p8 = 0.0001505 - 6.890624999999999e-10 / inverse_D7_p8;
  const Real inverse_D6_p9 = 2.6249999999999998e-05 * inverse_D6_p6 - 8.75e-06;
  const Real inverse_D6_p10 = c7 * (inverse_D6_p8 - inverse_D6_p7) - inverse_D1_p174 *
      inverse_D6_p9;
  const Real inverse_D6_p11 = c14 * inverse_D6_p5 + c7 * inverse_D6_p10;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p12 = inverse_D1_p404 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p13 = c22 * inverse_D1_p402 + s22 * inverse_D1_p401;
  const Real inverse_D6_p14 = inverse_D21_p2 + inverse_D21_p3 - inverse_D1_p366 * inverse_D1_p400;
  const Real inverse_D6_p15 = inverse_D6_p13 - 0.394 * inverse_D6_p14;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p16 = 0.005513625 + (inverse_D21_p7 - inverse_D21_p11 - 0.394 *
      (inverse_D6_p13 + inverse_D6_p15)) - inverse_D1_p404 * inverse_D6_p12;
  const Real inverse_D6_p17 = inverse_D1_p393 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p18 = s22 * inverse_D1_p397;
  const Real inverse_D6_p19 = inverse_D6_p18 - inverse_D1_p395;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p20 = 0.000703125 + 0.155236 * inverse_D6_p19 - inverse_D1_p393 *
      inverse_D6_p17;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p21 = c22 * inverse_D1_p406 + s22 * inverse_D1_p405;
  const Real inverse_D6_p22 = 0.394 * inverse_D6_p21;
  const Real inverse_D6_p23 = inverse_D1_p388 - inverse_D1_p386 - inverse_D6_p22;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p24 = 0.394 * inverse_D6_p23 - inverse_D1_p404 * inverse_D6_p17;
  const Real inverse_D6_p25 = 2.0 * s21;
  const Real inverse_D6_p26 = c21 * (inverse_D6_p16 - inverse_D6_p20) - inverse_D6_p25 *
      inverse_D6_p24;
  const Real inverse_D6_p27 = c21 * inverse_D6_p26;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p28 = 2.06965463592404 + inverse_D6_p20 + inverse_D6_p27 + inverse_D6_p2 +
      inverse_D6_p11 + inverse_D6_p7 - 0.18 * (inverse_D1_p332 + inverse_D1_p359 +
      (inverse_D1_p156 + inverse_D1_p183));

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D6_p29 = 0.0017499999999999998 + 2.6249999999999998e-05 * inverse_D1_p334;
  const Real inverse_D6_p30 = inverse_D1_p322 + inverse_D1_p318 - 0.0017499999999999998 -
      inverse_D1_p325 * inverse_D1_p334;
  const Real inverse_D6_p31 = c14 * inverse_D6_p29 + s14 * inverse_D6_p30;
  const Real inverse_D6_p32 = inverse_D1_p345 + inverse_D1_p352 - inverse_D1_p333 * inverse_D1_p334;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p33 = 2.6249999999999998e-05 * inverse_D1_p179 - 0.0017499999999999998;
  const Real inverse_D6_p34 = inverse_D1_p146 - inverse_D1_p139 - 0.0017499999999999998 -
      inverse_D1_p149 * inverse_D1_p179;
  const Real inverse_D6_p35 = c7 * inverse_D6_p33 - s7 * inverse_D6_p34;
  const Real inverse_D6_p36 = inverse_D1_p163 + inverse_D1_p169 - inverse_D1_p178 * inverse_D1_p179;
  const Real inverse_D6_p37 = inverse_D6_p31 + (0.226 * inverse_D6_p32 - 0.18 * inverse_D1_p350) -
      (inverse_D6_p35 - (0.18 * inverse_D1_p182 + 0.226 * inverse_D6_p36));

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / (inverse_D6_p28 + 0.226 *
      (inverse_D6_p31 + inverse_D6_p37 - inverse_D6_p35));
  const Real inverse_D1_p410 = inverse_D1_p409 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p411 = c7 * inverse_D1_p154;
  const Real inverse_D1_p412 = s7 * inverse_D1_p175 + inverse_D1_p173;
  const Real inverse_D1_p413 = 0.18 * inverse_D1_p412;
  const Real inverse_D1_p414 = c7 * inverse_D1_p180 - s7 * inverse_D1_p181;
  const Real inverse_D1_p415 = 0.226 * inverse_D1_p414;
  const Real inverse_D1_p416 = inverse_D1_p411 - inverse_D1_p151 -
      (inverse_D1_p413 + inverse_D1_p415);
  const Real inverse_D1_p417 = inverse_D1_p130 - inverse_D1_p411;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D1_p418 = c14 * inverse_D1_p330;
  const Real inverse_D1_p419 = inverse_D1_p354 - s14 * inverse_D1_p356;
  const Real inverse_D1_p420 = 0.18 * inverse_D1_p419;
  const Real inverse_D1_p421 = c14 * inverse_D1_p343 - s14 * inverse_D1_p349;
  const Real inverse_D1_p422 = 0.226 * inverse_D1_p421;
  const Real inverse_D1_p423 = inverse_D1_p327 - inverse_D1_p418 -
      (inverse_D1_p420 + inverse_D1_p422);
  const Real inverse_D1_p424 = inverse_D1_p418 - inverse_D1_p306;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p425 = 0.0187281677636143 - inverse_D6_p4 + s14 * inverse_D6_p5 + s7 *
      inverse_D6_p10 + inverse_D6_p9 + 0.18 * (inverse_D1_p416 - inverse_D1_p417 -
      (inverse_D1_p423 - inverse_D1_p424));
  const Real inverse_D1_p426 = s14 * inverse_D6_p29 - c14 * inverse_D6_p30 -
      (s7 * inverse_D6_p33 + c7 * inverse_D6_p34);
  const Real inverse_D1_p427 = inverse_D1_p425 + 0.226 * inverse_D1_p426;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p428 = inverse_D1_p424 + inverse_D1_p420 +
      (inverse_D1_p417 + inverse_D1_p413) - inverse_D1_p427 * inverse_D1_p410;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p429 = inverse_D1_p423 + inverse_D1_p416;
  const Real inverse_D1_p430 = s21 * inverse_D6_p26 + inverse_D6_p24 + 0.226 * inverse_D1_p429;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p431 = inverse_D1_p392 * inverse_D21;
  const Real inverse_D1_p432 = inverse_D6_p23 - inverse_D1_p404 * inverse_D1_p431;

  // link 22 (head), articulated inertia
  const Real inverse_D1_p433 = 0.0045000000000000005 + inverse_D1_p403;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p434 = inverse_D1_p433 * inverse_D21;
  const Real inverse_D1_p435 = inverse_D6_p22 + inverse_D1_p393 * inverse_D1_p434;
  const Real inverse_D1_p436 = 0.394 * inverse_D6_p19 - inverse_D1_p393 * inverse_D1_p431;
  const Real inverse_D1_p437 = inverse_D6_p15 + inverse_D1_p404 * inverse_D1_p434;
  const Real inverse_D1_p438 = c21 * (inverse_D1_p432 - inverse_D1_p435) - s21 *
      (inverse_D1_p436 + inverse_D1_p437);
  const Real inverse_D1_p439 = s21 * inverse_D1_p438;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p440 = inverse_D1_p439 + inverse_D1_p437 - 6.1665928899999995 -
      inverse_D6_p37;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p441 = inverse_D1_p440 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p442 = c21 * inverse_D1_p438;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p443 = inverse_D1_p432 - inverse_D1_p442 + inverse_D1_p422 +
      inverse_D1_p415 - inverse_D1_p430 * inverse_D1_p441;
  const Real inverse_D1_p444 = inverse_D1_p419 - inverse_D1_p412;
  const Real inverse_D1_p445 = s21 * inverse_D1_p408 + c21 * inverse_D1_p399 - inverse_D1_p430 *
      inverse_D1_p410 - 0.226 * inverse_D1_p444;
  const Real inverse_D1_p446 = 0.18 * (inverse_D1_p414 - inverse_D1_p421) -
      (inverse_D1_p426 + inverse_D1_p427 * inverse_D1_p441);
  const Real inverse_D1_p447 = s6 * (inverse_D1_p428 - inverse_D1_p443) + c6 *
      (inverse_D1_p445 + inverse_D1_p446);
  const Real inverse_D1_p448 = s6 * inverse_D1_p447;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D1_p449 = inverse_D1_p435 + inverse_D1_p442 + inverse_D1_p429;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p450 = inverse_D1_p449 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p451 = inverse_D1_p398 + inverse_D1_p392 * inverse_D1_p390;
  const Real inverse_D1_p452 = inverse_D1_p407 + inverse_D1_p433 * inverse_D1_p390;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p453 = c21 * inverse_D1_p451 + s21 * inverse_D1_p452 - inverse_D1_p444 -
      inverse_D1_p409 * inverse_D1_p450;

  // link 21 (neck), articulated inertia
  const Real inverse_D1_p454 = inverse_D6_p19 - inverse_D1_p392 * inverse_D1_p431;
  const Real inverse_D1_p455 = inverse_D6_p14 - inverse_D1_p433 * inverse_D1_p434;
  const Real inverse_D1_p456 = inverse_D6_p21 + inverse_D1_p392 * inverse_D1_p434;
  const Real inverse_D1_p457 = c21 * (inverse_D1_p454 - inverse_D1_p455) - inverse_D6_p25 *
      inverse_D1_p456;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p458 = s21 * inverse_D1_p457 + inverse_D1_p456 + inverse_D1_p421 +
      inverse_D1_p414 - inverse_D1_p440 * inverse_D1_p450;
  const Real inverse_D1_p459 = s6 * inverse_D1_p453 + c6 * inverse_D1_p458;
  const Real inverse_D1_p460 = 0.072 * inverse_D1_p459;
  const Real inverse_D1_p461 = inverse_D1_p443 + inverse_D1_p448 + inverse_D1_p460;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p1 = inverse_D1_p155 + inverse_D1_p152;
  const Real inverse_D5_p2 = inverse_D1_p170 + inverse_D1_p176;
  const Real inverse_D5_p3 = inverse_D5_p1 + 0.18 * inverse_D5_p2;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p4 = inverse_D1_p331 - inverse_D1_p328;
  const Real inverse_D5_p5 = inverse_D1_p353 + inverse_D1_p357;
  const Real inverse_D5_p6 = inverse_D5_p4 + 0.18 * inverse_D5_p5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p7 = inverse_D5_p3 - inverse_D5_p6 - inverse_D1_p427 * inverse_D1_p450;
  const Real inverse_D5_p8 = inverse_D5_p5 + inverse_D5_p2;
  const Real inverse_D5_p9 = 6.1665928899999995 + inverse_D1_p439 + inverse_D1_p436 -
      inverse_D1_p430 * inverse_D1_p450 + 0.226 * inverse_D5_p8;
  const Real inverse_D5_p10 = s6 * inverse_D5_p7 + c6 * inverse_D5_p9;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p11 = c21 * inverse_D1_p457;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p12 = inverse_D1_p455 + inverse_D5_p11 + inverse_D5_p8 - inverse_D1_p449 *
      inverse_D1_p450;
  const Real inverse_D5_p13 = inverse_D5_p10 + 0.072 * inverse_D5_p12;
  const Real inverse_D5_p14 = inverse_D1_p427 * inverse_D6;
  const Real inverse_D5_p15 = 0.40056549999999996 - inverse_D6_p3 - inverse_D6_p11 + inverse_D6_p8 -
      inverse_D1_p427 * inverse_D5_p14 + 0.18 * (inverse_D5_p4 + inverse_D5_p6 +
      (inverse_D5_p1 + inverse_D5_p3));
  const Real inverse_D5_p16 = inverse_D1_p430 * inverse_D6;
  const Real inverse_D5_p17 = 1.66923963592404 + inverse_D6_p16 - inverse_D6_p27 - inverse_D1_p430 *
      inverse_D5_p16 + 0.051076 * inverse_D5_p8;
  const Real inverse_D5_p18 = 0.04068 * (inverse_D5_p2 - inverse_D5_p5) - inverse_D1_p427 *
      inverse_D5_p16 + 0.226 * (inverse_D5_p1 - inverse_D5_p4);
  const Real inverse_D5_p19 = 2.0 * c6;
  const Real inverse_D5_p20 = s6 * (inverse_D5_p15 - inverse_D5_p17) + inverse_D5_p19 *
      inverse_D5_p18;
  const Real inverse_D5_p21 = s6 * inverse_D5_p20;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p17 + inverse_D5_p21 + 0.072 * (inverse_D5_p10 + inverse_D5_p13)));
  const Real inverse_D1_p462 = inverse_D1_p461 * inverse_D5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p463 = 0.072 * inverse_D1_p461;
  const Real inverse_D1_p464 = inverse_D1_p358 - (inverse_D1_p396 + inverse_D6_p18 +
      inverse_D1_p389 * inverse_D1_p390) + inverse_D1_p177 - inverse_D1_p409 * inverse_D1_p410;
  const Real inverse_D1_p465 = inverse_D1_p454 - inverse_D5_p11 + inverse_D6_p32 + inverse_D6_p36 -
      inverse_D1_p440 * inverse_D1_p441;
  const Real inverse_D1_p466 = s21 * inverse_D1_p451 - c21 * inverse_D1_p452 + inverse_D1_p350 +
      inverse_D1_p182 - inverse_D1_p409 * inverse_D1_p441;
  const Real inverse_D1_p467 = s6 * (inverse_D1_p464 - inverse_D1_p465) + inverse_D5_p19 *
      inverse_D1_p466;
  const Real inverse_D1_p468 = s6 * inverse_D1_p467;
  const Real inverse_D1_p469 = inverse_D1_p465 + inverse_D1_p468;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p470 = inverse_D1_p463 * inverse_D1_p462 -
      (2.2194301519999997 + 0.072 * inverse_D1_p469);

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p471 = c6 * inverse_D5_p7 - s6 * inverse_D5_p9;
  const Real inverse_D1_p472 = c6 * inverse_D5_p20 - inverse_D5_p18 + 0.072 * inverse_D1_p471;
  const Real inverse_D1_p473 = c6 * inverse_D1_p447;
  const Real inverse_D1_p474 = inverse_D1_p473 - inverse_D1_p445;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p475 = inverse_D1_p474 - 0.069699984375 - inverse_D1_p472 * inverse_D1_p462;
  const Real inverse_D1_p476 = s5 * inverse_D1_p470 + c5 * inverse_D1_p475;
  const Real inverse_D1_p477 = inverse_D1_p463 * inverse_D5;
  const Real inverse_D1_p478 = 0.15637308509675518 + 0.005183999999999999 * inverse_D1_p469 -
      inverse_D1_p463 * inverse_D1_p477;
  const Real inverse_D1_p479 = inverse_D1_p472 * inverse_D5;
  const Real inverse_D1_p480 = 0.04675382692737882 + (inverse_D5_p15 - inverse_D5_p21) -
      inverse_D1_p472 * inverse_D1_p479;
  const Real inverse_D1_p481 = 0.005678398088837119 - 0.072 * inverse_D1_p474 + inverse_D1_p463 *
      inverse_D1_p479;
  const Real inverse_D1_p482 = 2.0 * c5;
  const Real inverse_D1_p483 = s5 * (inverse_D1_p478 - inverse_D1_p480) + inverse_D1_p482 *
      inverse_D1_p481;
  const Real inverse_D1_p484 = 0.005880002159562879 +
      (0.21799999999999997 * inverse_D1_p476 - (c5 * inverse_D1_p483 - inverse_D1_p481));

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p485 = 2.2194301519999997 + inverse_D5_p13;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p486 = inverse_D1_p485 * inverse_D5;
  const Real inverse_D1_p487 = inverse_D1_p463 * inverse_D1_p486 - inverse_D1_p460;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p488 = c6 * inverse_D1_p453 - s6 * inverse_D1_p458;
  const Real inverse_D1_p489 = 0.069699984375 + (inverse_D1_p473 - inverse_D1_p446 + 0.072 *
      inverse_D1_p488);

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p490 = inverse_D1_p489 * inverse_D5;
  const Real inverse_D1_p491 = inverse_D1_p428 - inverse_D1_p448 - inverse_D1_p472 *
      inverse_D1_p490;
  const Real inverse_D1_p492 = inverse_D1_p471 - inverse_D1_p472 * inverse_D1_p486;

  // link 6 (chest3), articulated inertia
  const Real inverse_D1_p493 = c6 * inverse_D1_p467 - inverse_D1_p466;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p494 = inverse_D1_p463 * inverse_D1_p490 - 0.072 * inverse_D1_p493;
  const Real inverse_D1_p495 = s5 * (inverse_D1_p487 - inverse_D1_p491) + c5 *
      (inverse_D1_p492 + inverse_D1_p494);
  const Real inverse_D1_p496 = c5 * inverse_D1_p495;
  const Real inverse_D1_p497 = inverse_D1_p496 - inverse_D1_p494;
  const Real inverse_D4_p1 = s5 * inverse_D1_p483;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (inverse_D1_p480 + inverse_D4_p1));
  const Real inverse_D1_p498 = inverse_D1_p497 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p499 = s5 * inverse_D1_p495;
  const Real inverse_D1_p500 = inverse_D1_p493 - inverse_D1_p489 * inverse_D1_p462;
  const Real inverse_D1_p501 = inverse_D1_p459 - inverse_D1_p485 * inverse_D1_p462;
  const Real inverse_D1_p502 = s5 * inverse_D1_p500 - c5 * inverse_D1_p501;
  const Real inverse_D1_p503 = 0.21799999999999997 * inverse_D1_p502;
  const Real inverse_D1_p504 = inverse_D1_p487 - inverse_D1_p499 + inverse_D1_p503;
  const Real inverse_D1_p505 = 0.21799999999999997 * inverse_D1_p497;
  const Real inverse_D1_p506 = 0.0300000063 + inverse_D1_p476;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p507 = inverse_D1_p506 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p508 = inverse_D1_p464 - inverse_D1_p468 - inverse_D1_p489 *
      inverse_D1_p490;
  const Real inverse_D1_p509 = inverse_D5_p12 - inverse_D1_p485 * inverse_D1_p486;
  const Real inverse_D1_p510 = inverse_D1_p488 - inverse_D1_p485 * inverse_D1_p490;
  const Real inverse_D1_p511 = s5 * (inverse_D1_p509 - inverse_D1_p508) + inverse_D1_p482 *
      inverse_D1_p510;
  const Real inverse_D1_p512 = s5 * inverse_D1_p511;
  const Real inverse_D1_p513 = inverse_D1_p509 - inverse_D1_p512;
  const Real inverse_D1_p514 = s5 * inverse_D1_p475 - c5 * inverse_D1_p470;
  const Real inverse_D1_p515 = inverse_D1_p469 - inverse_D1_p461 * inverse_D1_p462;
  const Real inverse_D1_p516 = inverse_D1_p514 + 0.21799999999999997 * inverse_D1_p515;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p517 = inverse_D1_p484 * inverse_D1_p507 - inverse_D1_p516;
  const Real inverse_D1_p518 = s4 * (inverse_D1_p504 + inverse_D1_p484 * inverse_D1_p498 +
      (inverse_D1_p503 + inverse_D1_p505 * inverse_D1_p507)) + c4 *
      (0.21799999999999997 * inverse_D1_p513 - inverse_D1_p505 * inverse_D1_p498 + inverse_D1_p517);
  const Real inverse_D1_p519 = 8.419374554 + (c4 * inverse_D1_p518 - inverse_D1_p517);
  const Real inverse_D3_p1 = inverse_D1_p484 * inverse_D4;
  const Real inverse_D3_p2 = inverse_D1_p505 * inverse_D4;
  const Real inverse_D3_p3 = 0.01227760324629517 + 0.04752399999999999 * inverse_D1_p513 -
      inverse_D1_p505 * inverse_D3_p2;
  const Real inverse_D3_p4 = 0.0478915 + (inverse_D1_p478 - inverse_D4_p1 + 0.21799999999999997 *
      (inverse_D1_p514 + inverse_D1_p516)) - inverse_D1_p484 * inverse_D3_p1 - inverse_D3_p3;
  const Real inverse_D3_p5 = 2.0 * c4;
  const Real inverse_D3_p6 = inverse_D3_p3 + s4 * (s4 * inverse_D3_p4 + inverse_D3_p5 *
      (0.21799999999999997 * inverse_D1_p504 + inverse_D1_p484 * inverse_D3_p2));

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p6);
  const Real inverse_D1_p520 = inverse_D1_p519 * inverse_D3;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p521 = inverse_D1_p513 - inverse_D1_p497 * inverse_D1_p498;
  const Real inverse_D1_p522 = s4 * (inverse_D1_p521 -
      (inverse_D1_p515 - inverse_D1_p506 * inverse_D1_p507)) - inverse_D3_p5 *
      (inverse_D1_p502 + inverse_D1_p497 * inverse_D1_p507);

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p523 = inverse_D1_p521 - s4 * inverse_D1_p522 - inverse_D1_p519 *
      inverse_D1_p520;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p524 = inverse_D1_p491 + inverse_D1_p499;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p525 = inverse_D1_p524 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real inverse_D1_p526 = s5 * inverse_D1_p501 + c5 * inverse_D1_p500;
  const Real inverse_D1_p527 = c5 * inverse_D1_p511 - inverse_D1_p510;

  // link 4 (chest1), articulated inertia
  const Real inverse_D1_p528 = s4 * (0.21799999999999997 * inverse_D1_p526 -
      (inverse_D1_p496 - inverse_D1_p492) - inverse_D1_p484 * inverse_D1_p525) + c4 *
      (0.0300000063 - 0.21799999999999997 * inverse_D1_p527 + inverse_D1_p505 * inverse_D1_p525);
  const Real inverse_D1_p529 = 0.02999999505 + inverse_D1_p528;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p530 = inverse_D1_p529 * inverse_D3;
  const Real inverse_D1_p531 = inverse_D1_p508 + inverse_D1_p512 - inverse_D1_p524 *
      inverse_D1_p525 - inverse_D1_p529 * inverse_D1_p530;
  const Real inverse_D1_p532 = inverse_D1_p519 * inverse_D1_p530 -
      (c4 * (inverse_D1_p497 * inverse_D1_p525 - inverse_D1_p527) - s4 *
      (inverse_D1_p506 * inverse_D1_p525 - inverse_D1_p526));
  const Real inverse_D1_p533 = s3 * (inverse_D1_p523 - inverse_D1_p531) + c3 *
      (2.0 * inverse_D1_p532);
  const Real inverse_D1_p534 = s3 * inverse_D1_p533;
  const Real inverse_D1_p535 = inverse_D1_p523 - inverse_D1_p534;
  const Real inverse_D1_p536 = 24.5839218 + 0.422 * inverse_D1_p535;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * inverse_D1_p535);
  const Real inverse_D1_p537 = inverse_D1_p536 * inverse_D2;
  const Real inverse_D1_p538 = inverse_D1_p535 - inverse_D1_p536 * inverse_D1_p537;

  // link 3 (hip), articulated inertia
  const Real inverse_D1_p539 = c3 * inverse_D1_p533 - inverse_D1_p532;
  const Real inverse_D1_p540 = 0.031999971599999996 + 0.422 * inverse_D1_p539;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p541 = inverse_D1_p540 * inverse_D2;
  const Real inverse_D1_p542 = s2 * (inverse_D1_p538 -
      (inverse_D1_p531 + inverse_D1_p534 - inverse_D1_p540 * inverse_D1_p541)) + c2 *
      (2.0 * (inverse_D1_p539 - inverse_D1_p536 * inverse_D1_p541));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p538 - s2 * inverse_D1_p542));

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;

  // link 2 (thigh), outward
  const Real a2_y_p1 = 0.434 * (qd[0] * qd[0]) - minus_a1_y;

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;

  // link 2 (thigh), outward
  const Real a2_y = s2 * minus_a1_x + c2 * a2_y_p1;
  const Real w2_z = qd[0] + qd[1];
  const Real a3_y_p1 = w2_z * w2_z;

  // link 3 (hip), outward
  const Real a3_y_p2 = a2_y + 0.422 * a3_y_p1;

  // link 2 (thigh), outward
  const Real a2_x = s2 * a2_y_p1 - c2 * minus_a1_x;

  // link 3 (hip), outward
  const Real a3_y = c3 * a3_y_p2 - s3 * a2_x;
  const Real w3_z = w2_z + qd[2];

  // link 4 (chest1), outward
  const Real w4_x = s4 * w3_z;
  const Real a5_y_p1 = w4_x * w4_x;
  const Real w4_y = c4 * w3_z;
  const Real a5_y_p2 = w4_y * w4_y;

  // link 5 (chest2), outward
  const Real a5_y_p3 = a3_y + 0.21799999999999997 * (a5_y_p1 + a5_y_p2);

  // link 3 (hip), outward
  const Real a3_x = c3 * a2_x + s3 * a3_y_p2;

  // link 4 (chest1), outward
  const Real a4_x = c4 * a3_x;

  // link 5 (chest2), outward
  const Real a5_y = c5 * a5_y_p3 - s5 * a4_x;
  const Real w5_x = c5 * w4_x - s5 * qd[3];
  const Real a6_x_p1 = w5_x * w5_x;
  const Real w5_z = w4_y + qd[4];
  const Real a6_x_p2 = w5_z * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p3 = a6_x_p1 + a6_x_p2;
  const Real a6_x_p4 = a5_y + 0.072 * a6_x_p3;

  // link 4 (chest1), outward
  const Real minus_a4_y = s4 * a3_x;

  // link 5 (chest2), outward
  const Real minus_w5_y = s5 * w4_x + c5 * qd[3];

  // link 4 (chest1), outward
  const Real wd4_x = w4_y * qd[3];

  // link 5 (chest2), outward
  const Real wd5_x = c5 * wd4_x - minus_w5_y * qd[4];
  const Real a6_x_p5 = wd5_x - minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p6 = minus_a4_y + 0.072 * a6_x_p5;
  const Real a6_x = c6 * a6_x_p4 - s6 * a6_x_p6;
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_z = w5_x + qd[5];
  const Real a14_y_p1 = w6_z * w6_z;

  // link 7 (left_shoulder1), outward
  const Real a14_y_p2 = w6_y * w6_y + a14_y_p1;

  // link 14 (right_shoulder1), outward
  const Real a14_y_p3 = a6_x + 0.226 * a14_y_p2;

  // link 6 (chest3), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real a14_y_p4 = w6_x * w6_y;

  // link 7 (left_shoulder1), outward
  const Real a14_y_p5 = 0.18 * (a14_y_p4 - wd5_x);

  // link 14 (right_shoulder1), outward
  const Real a14_y_p6 = a14_y_p3 - a14_y_p5;

  // link 5 (chest2), outward
  const Real a5_x = c5 * a4_x + s5 * a5_y_p3;
  const Real a6_z_p1 = w5_x * minus_w5_y;

  // link 4 (chest1), outward
  const Real minus_wd4_y = w4_x * qd[3];

  // link 5 (chest2), outward
  const Real a6_z_p2 = minus_wd4_y - a6_z_p1;

  // link 6 (chest3), outward
  const Real a6_z = a5_x - 0.072 * a6_z_p2;

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * wd4_x + w5_x * qd[4];

  // link 6 (chest3), outward
  const Real wd6_y = s6 * minus_wd5_y - c6 * minus_wd4_y - w6_x * qd[5];
  const Real a14_y_p7 = w6_x * w6_z - wd6_y;

  // link 14 (right_shoulder1), outward
  const Real a14_y_p8 = a6_z - 0.226 * a14_y_p7;

  // link 6 (chest3), outward
  const Real a14_y_p9 = w6_y * w6_z;
  const Real wd6_x = w6_y * qd[5] - (c6 * minus_wd5_y + s6 * minus_wd4_y);
  const Real a14_y_p10 = a14_y_p9 + wd6_x;

  // link 7 (left_shoulder1), outward
  const Real a14_y_p11 = 0.18 * a14_y_p10;

  // link 14 (right_shoulder1), outward
  const Real a14_y_p12 = a14_y_p8 - a14_y_p11;
  const Real a14_y = c14 * a14_y_p6 - s14 * a14_y_p12;

  // link 6 (chest3), outward
  const Real minus_a6_y = s6 * a6_x_p4 + c6 * a6_x_p6;
  const Real a14_z_p1 = a14_y_p4 + wd5_x;

  // link 14 (right_shoulder1), outward
  const Real a14_z_p2 = minus_a6_y + 0.226 * a14_z_p1;

  // link 6 (chest3), outward
  const Real a14_z_p3 = w6_x * w6_x;

  // link 7 (left_shoulder1), outward
  const Real a14_z_p4 = 0.18 * (a14_z_p3 + a14_y_p1);

  // link 14 (right_shoulder1), outward
  const Real a14_z = a14_z_p4 - a14_z_p2;

  // link 15 (right_shoulder2), outward
  const Real a15_y = c15 * a14_z - s15 * a14_y;

  // link 14 (right_shoulder1), outward
  const Real a14_x = s14 * a14_y_p6 + c14 * a14_y_p12;

  // link 16 (right_upperarm), outward
  const Real a16_x = s16 * a15_y + c16 * a14_x;

  // link 14 (right_shoulder1), outward
  const Real w14_x = s14 * w6_x + c14 * w6_z;
  const Real wd14_y = c14 * wd6_x - s14 * wd5_x - w14_x * qd[13];
  const Real w14_y = c14 * w6_x - s14 * w6_z;
  const Real w14_z = w6_y + qd[13];

  // link 15 (right_shoulder2), outward
  const Real w15_x = c15 * w14_y + s15 * w14_z;
  const Real wd15_y = c15 * wd6_y - s15 * wd14_y - w15_x * qd[14];

  // link 14 (right_shoulder1), outward
  const Real wd14_x = s14 * wd6_x + c14 * wd5_x + w14_y * qd[13];

  // link 15 (right_shoulder2), outward
  const Real w15_y = c15 * w14_z - s15 * w14_y;
  const Real w15_z = w14_x + qd[14];

  // link 16 (right_upperarm), outward
  const Real w16_x = s16 * w15_y + c16 * w15_z;
  const Real wd16_y = c16 * wd15_y - s16 * wd14_x - w16_x * qd[15];
  const Real w16_z = qd[15] - w15_x;
  const Real a17_x_p1 = w16_x * w16_z;
  const Real a17_x_p2 = a17_x_p1 + wd16_y;

  // link 17 (right_lowerarm), outward
  const Real a17_x_p3 = a16_x - 0.282 * a17_x_p2;

  // link 16 (right_upperarm), outward
  const Real a17_x_p4 = w16_x * w16_x;
  const Real w16_y = c16 * w15_y - s16 * w15_z;
  const Real a17_x_p5 = w16_y * w16_y;

  // link 15 (right_shoulder2), outward
  const Real a15_x = c15 * a14_y + s15 * a14_z;

  // link 17 (right_lowerarm), outward
  const Real a17_x_p6 = 0.282 * (a17_x_p4 + a17_x_p5) - a15_x;
  const Real a17_x = c17 * a17_x_p3 - s17 * a17_x_p6;

  // link 16 (right_upperarm), outward
  const Real a16_y = c16 * a15_y - s16 * a14_x;
  const Real wd16_x = s16 * wd15_y + c16 * wd14_x + w16_y * qd[15];
  const Real a17_z_p1 = w16_y * w16_z;
  const Real a17_z_p2 = a17_z_p1 - wd16_x;

  // link 17 (right_lowerarm), outward
  const Real a17_z = a16_y - 0.282 * a17_z_p2;

  // link 18 (right_wrist1), outward
  const Real a18_x = c18 * a17_x + s18 * a17_z;

  // link 15 (right_shoulder2), outward
  const Real wd15_x = c15 * wd14_y + s15 * wd6_y + w15_y * qd[14];

  // link 17 (right_lowerarm), outward
  const Real minus_w17_y = s17 * w16_x + c17 * w16_z;
  const Real wd17_x = c17 * wd16_x + s17 * wd15_x - minus_w17_y * qd[16];
  const Real w17_x = c17 * w16_x - s17 * w16_z;
  const Real w17_z = w16_y + qd[16];

  // link 18 (right_wrist1), outward
  const Real w18_x = c18 * w17_x + s18 * w17_z;
  const Real wd18_y = c18 * wd16_y - s18 * wd17_x - w18_x * qd[17];
  const Real w18_z = minus_w17_y + qd[17];
  const Real minus_a19_y_p1 = w18_x * w18_z;
  const Real minus_a19_y_p2 = minus_a19_y_p1 + wd18_y;

  // link 19 (right_wrist2), outward
  const Real minus_a19_y_p3 = a18_x - 0.269 * minus_a19_y_p2;

  // link 17 (right_lowerarm), outward
  const Real minus_a17_y = s17 * a17_x_p3 + c17 * a17_x_p6;

  // link 18 (right_wrist1), outward
  const Real minus_a19_y_p4 = w18_x * w18_x;
  const Real w18_y = c18 * w17_z - s18 * w17_x;
  const Real minus_a19_y_p5 = w18_y * w18_y;

  // link 19 (right_wrist2), outward
  const Real minus_a19_y_p6 = minus_a17_y + 0.269 * (minus_a19_y_p4 + minus_a19_y_p5);
  const Real minus_a19_y = s19 * minus_a19_y_p3 + c19 * minus_a19_y_p6;
  const Real a19_x = c19 * minus_a19_y_p3 - s19 * minus_a19_y_p6;
  const Real w19_x = c19 * w18_x - s19 * w18_z;
  const Real minus_w19_y = s19 * w18_x + c19 * w18_z;
  const Real n19_z_p1 = w19_x * minus_w19_y;
  const Real w19_z = w18_y + qd[18];
  const Real n19_z_p2 = w19_x * w19_z;

  // link 18 (right_wrist1), outward
  const Real wd18_x = c18 * wd17_x + s18 * wd16_y + w18_y * qd[17];

  // link 17 (right_lowerarm), outward
  const Real wd17_y = c17 * wd15_x - s17 * wd16_x - w17_x * qd[16];

  // link 19 (right_wrist2), outward
  const Real wd19_y = c19 * wd17_y - s19 * wd18_x - w19_x * qd[18];

  // link 19 (right_wrist2), inertial wrench
  const Real n19_z_p3 = 0.00020682766225734302 * wd18_y - 0.000183627662257343 * n19_z_p1 +
      2.4000000000000003e-06 * (n19_z_p2 + wd19_y) - (0.0025100003499999995 * minus_a19_y +
      0.0006000000000000001 * a19_x);

  // link 20 (right_hand), outward
  const Real w20_y = s20 * minus_w19_y + c20 * w19_z;
  const Real wd20_x = c20 * wd19_y + s20 * wd18_y + w20_y * qd[19];
  const Real w20_z = w19_x + qd[19];
  const Real n20_x_p1 = w20_y * w20_z;
  const Real n20_x_p2 = n20_x_p1 + wd20_x;
  const Real w20_x = s20 * w19_z - c20 * minus_w19_y;
  const Real wd20_y = c20 * wd18_y - s20 * wd19_y - w20_x * qd[19];
  const Real n20_x_p3 = w20_x * w20_z;
  const Real n20_x_p4 = n20_x_p3 - wd20_y;
  const Real n20_x_p5 = w20_x * w20_y;

  // link 19 (right_wrist2), outward
  const Real wd19_x = c19 * wd18_x + s19 * wd17_y - minus_w19_y * qd[18];

  // link 20 (right_hand), outward
  const Real n20_x_p6 = n20_x_p5 + wd19_x;
  const Real n20_x_p7 = w20_y * w20_y;
  const Real n20_x_p8 = w20_z * w20_z;

  // link 20 (right_hand), inertial wrench
  const Real n20_x_p9 = 9.149209276993575e-05 * n20_x_p2 + 0.0001263900573325125 * n20_x_p4 -
      0.000108260010923775 * n20_x_p6 + 4.38600177048965e-05 * (n20_x_p8 - n20_x_p7);
  const Real n20_x = n20_x_p9 + 0.002865001425 * a19_x;

  // link 20 (right_hand), outward
  const Real n20_y_p1 = n20_x_p5 - wd19_x;
  const Real n20_y_p2 = w20_x * w20_x;

  // link 20 (right_hand), inertial wrench
  const Real n20_y_p3 = 4.38600177048965e-05 * n20_y_p1 - 0.000847139515629375 * n20_x_p4 -
      0.0001263900573325125 * n20_x_p2 + 0.000108260010923775 * (n20_y_p2 - n20_x_p8);
  const Real n20_y = n20_y_p3 - 0.01626499875 * a19_x;

  // link 20 (right_hand), inward
  const Real n19_z = n19_z_p3 + (s20 * n20_x + c20 * n20_y);

  // link 1 (calf), inward
  const Real qdd_0_p1 = tau[18] - n19_z;

  // link 18 (right_wrist1), outward
  const Real a18_y = c18 * a17_z - s18 * a17_x;
  const Real a19_z_p1 = w18_y * w18_z;
  const Real a19_z_p2 = a19_z_p1 - wd18_x;

  // link 19 (right_wrist2), outward
  const Real a19_z = a18_y - 0.269 * a19_z_p2;

  // link 20 (right_hand), outward
  const Real a20_y = s20 * minus_a19_y + c20 * a19_z;
  const Real a20_x = s20 * a19_z - c20 * minus_a19_y;

  // link 20 (right_hand), inertial wrench
  const Real n20_z_p1 = 0.0007556474228594393 * n20_x_p5 + 0.0009386316083993107 * wd19_x +
      0.000108260010923775 * (n20_x_p1 - wd20_x) - 4.38600177048965e-05 * (n20_x_p3 + wd20_y);
  const Real n20_z = n20_z_p1 + 0.0001263900573325125 * (n20_x_p7 - n20_y_p2) +
      (0.01626499875 * a20_y - 0.002865001425 * a20_x);

  // link 1 (calf), inward
  const Real qdd_0_p2 = tau[19] - n20_z;

  // link 20 (right_hand), bias force
  const Real qdd_0_p3 = 0.11533812622014242 * qdd_0_p2;
  const Real qdd_0_p4 = 0.04672761636452121 * qdd_0_p2;

  // link 19 (right_wrist2), bias force
  const Real qdd_0_p5 = qdd_0_p1 + (s20 * qdd_0_p3 + c20 * qdd_0_p4);

  // link 20 (right_hand), bias force
  const Real qdd_0_p6 = 3.0523172236718206 * qdd_0_p2;
  const Real qdd_0_p7 = 17.32841575379867 * qdd_0_p2;

  // link 19 (right_wrist2), bias force
  const Real qdd_0_p8 = inverse_D1_p206 * qdd_0_p5 - (c20 * qdd_0_p6 + s20 * qdd_0_p7);
  const Real qdd_0_p9 = inverse_D1_p209 * qdd_0_p5;
  const Real qdd_0_p10 = s19 * qdd_0_p8 - c19 * qdd_0_p9;
  const Real qdd_0_p11 = s20 * qdd_0_p4 - c20 * qdd_0_p3 + inverse_D1_p186 * qdd_0_p5;

  // link 19 (right_wrist2), outward
  const Real n19_x_p1 = wd19_x - minus_w19_y * w19_z;
  const Real n19_x_p2 = w19_z * w19_z;
  const Real n19_x_p3 = minus_w19_y * minus_w19_y;

  // link 20 (right_hand), inward
  const Real n19_x = 1.16e-05 * n19_x_p1 - 2.4000000000000003e-06 * (n19_x_p2 - n19_x_p3) +
      0.0006000000000000001 * a19_z + n20_z;

  // link 19 (right_wrist2), outward
  const Real n19_y_p1 = n19_z_p1 + wd18_y;
  const Real n19_y_p2 = n19_z_p2 - wd19_y;

  // link 20 (right_hand), inward
  const Real n19_y = 2.4000000000000003e-06 * n19_y_p1 - 0.000195227662257343 * n19_y_p2 -
      0.0025100003499999995 * a19_z + (c20 * n20_x - s20 * n20_y);

  // link 18 (right_wrist1), outward
  const Real n18_z_p1 = w18_x * w18_y;

  // link 18 (right_wrist1), inertial wrench
  const Real n18_z_p2 = 9.600000000000003e-06 * n18_z_p1 + 0.0002292 * wd17_y + 0.000144 *
      a19_z_p2 + 0.0002516 * minus_a19_y_p2 + 6e-06 * (minus_a19_y_p5 - minus_a19_y_p4);

  // link 19 (right_wrist2), inward
  const Real n18_z = 6e-04 * a18_y + 0.001 * a18_x - n18_z_p2 - (s19 * n19_x + c19 * n19_y);

  // link 1 (calf), inward
  const Real qdd_0_p12 = tau[17] - n18_z;

  // link 18 (right_wrist1), bias force
  const Real qdd_0_p13 = qdd_0_p12 + (s19 * qdd_0_p2 + c19 * qdd_0_p11);
  const Real qdd_0_p14 = inverse_D1_p214 * qdd_0_p13 - qdd_0_p10;

  // link 19 (right_wrist2), bias force
  const Real qdd_0_p15 = c20 * qdd_0_p7 - s20 * qdd_0_p6 + inverse_D1_p192 * qdd_0_p5;

  // link 18 (right_wrist1), bias force
  const Real qdd_0_p16 = qdd_0_p15 + inverse_D1_p198 * qdd_0_p13;
  const Real qdd_0_p17 = 0.269 * qdd_0_p15 - (s19 * qdd_0_p11 - c19 * qdd_0_p2) + inverse_D17_p1 *
      qdd_0_p13;
  const Real qdd_0_p18 = qdd_0_p1 + 0.269 * qdd_0_p10 + inverse_D17_p3 * qdd_0_p13;

  // link 20 (right_hand), inertial wrench
  const Real f20_x = 0.002865001425 * n20_y_p1 - 0.01626499875 * (n20_x_p7 + n20_x_p8);
  const Real f20_y = 0.01626499875 * n20_x_p6 - 0.002865001425 * (n20_y_p2 + n20_x_p8);

  // link 20 (right_hand), inward
  const Real f19_z = 0.0025100003499999995 * n19_y_p2 + 0.0006000000000000001 * n19_x_p1 +
      (s20 * f20_x + c20 * f20_y);

  // link 18 (right_wrist1), outward
  const Real n18_x_p1 = a19_z_p1 + wd18_x;
  const Real n18_x_p2 = minus_a19_y_p1 - wd18_y;
  const Real n18_x_p3 = n18_z_p1 - wd17_y;
  const Real n18_x_p4 = w18_z * w18_z;

  // link 18 (right_wrist1), inertial wrench
  const Real n18_x_p5 = 0.0001194 * n18_x_p1 - 6e-06 * n18_x_p2 + 0.000144 * n18_x_p3 + 0.0002516 *
      (n18_x_p4 - minus_a19_y_p5);

  // link 19 (right_wrist2), inward
  const Real n18_x = n18_x_p5 - 0.001 * minus_a17_y + (0.269 * f19_z - (s19 * n19_y - c19 * n19_x));

  // link 17 (right_lowerarm), outward
  const Real n17_z_p1 = w17_x * minus_w17_y;
  const Real n17_z_p2 = minus_w17_y * w17_z;

  // link 18 (right_wrist1), inward
  const Real n17_z_p3 = 0.06032654142055946 * n17_z_p1 + 0.060888541114265754 * wd16_y +
      2.249994685315e-05 * (n17_z_p2 + wd17_x) - 0.0014999985000000002 * minus_a17_y;

  // link 20 (right_hand), inward
  const Real f19_y = 0.0025100003499999995 * (wd18_y - n19_z_p1) - 0.0006000000000000001 *
      (w19_x * w19_x + n19_x_p2) + (c20 * f20_x - s20 * f20_y);

  // link 20 (right_hand), inertial wrench
  const Real f20_z = 0.01626499875 * n20_x_p4 + 0.002865001425 * n20_x_p2;

  // link 20 (right_hand), inward
  const Real f19_x = f20_z - (0.0025100003499999995 * (n19_x_p3 + n19_x_p2) +
      0.0006000000000000001 * n19_y_p1);

  // link 19 (right_wrist2), inward
  const Real n18_y_p1 = s19 * f19_y - c19 * f19_x;

  // link 18 (right_wrist1), outward
  const Real n18_y_p2 = n18_z_p1 + wd17_y;

  // link 18 (right_wrist1), inertial wrench
  const Real n18_y_p3 = 0.0002516 * n18_y_p2 - 0.0001098 * n18_x_p2 + 6e-06 * n18_x_p1 - 0.000144 *
      (minus_a19_y_p4 - n18_x_p4);

  // link 19 (right_wrist2), inward
  const Real n18_y = n18_y_p3 - 6e-04 * minus_a17_y + (n19_z + 0.269 * n18_y_p1);

  // link 17 (right_lowerarm), outward
  const Real n17_z_p4 = w17_x * w17_z;
  const Real n17_z_p5 = minus_w17_y * minus_w17_y;
  const Real n17_z_p6 = w17_x * w17_x;

  // link 18 (right_wrist1), inward
  const Real n17_z = n17_z_p3 - 0.28049749700000004 * a17_x + s18 * n18_x + c18 * n18_y +
      0.0001499998887063 * (n17_z_p4 + wd17_y + (n17_z_p5 - n17_z_p6));

  // link 1 (calf), inward
  const Real qdd_0_p19 = tau[16] - n17_z;

  // link 17 (right_lowerarm), bias force
  const Real qdd_0_p20 = qdd_0_p19 - (s18 * qdd_0_p17 + c18 * qdd_0_p18);
  const Real qdd_0_p21 = s18 * qdd_0_p14 + c18 * qdd_0_p16 + inverse_D1_p234 * qdd_0_p20;
  const Real qdd_0_p22 = c18 * qdd_0_p17 - s18 * qdd_0_p18 + inverse_D1_p243 * qdd_0_p20;
  const Real qdd_0_p23 = inverse_D1_p240 * qdd_0_p20 - qdd_0_p12;

  // link 17 (right_lowerarm), outward
  const Real n17_x_p1 = wd17_x - n17_z_p2;
  const Real n17_x_p2 = wd16_y - n17_z_p1;

  // link 18 (right_wrist1), inward
  const Real n17_x_p3 = 0.06060754126741261 * n17_x_p1 + 2.249994685315e-05 * n17_x_p2 +
      0.28049749700000004 * a17_z + c18 * n18_x - s18 * n18_y;

  // link 17 (right_lowerarm), outward
  const Real n17_x_p4 = n17_z_p4 - wd17_y;
  const Real n17_x_p5 = w17_z * w17_z;

  // link 18 (right_wrist1), inward
  const Real n17_x = n17_x_p3 + 0.0001499998887063 * (n17_x_p4 - (n17_x_p5 - n17_z_p5));

  // link 17 (right_lowerarm), outward
  const Real n17_y_p1 = n17_z_p1 + wd16_y;

  // link 18 (right_wrist1), inward
  const Real n17_y = 0.0001499998887063 * (n17_y_p1 - n17_x_p1) -
      (0.00028099984685315 * n17_x_p4 + 2.249994685315e-05 * (n17_z_p6 - n17_x_p5) +
      0.0014999985000000002 * a17_z + n18_z);

  // link 16 (right_upperarm), outward
  const Real n16_z_p1 = w16_x * w16_y;

  // link 16 (right_upperarm), inertial wrench
  const Real n16_z_p2 = 0.0005895000784280001 * a17_z_p2 -
      (0.001140794814995722 * n16_z_p1 + 0.0027762933559338653 * wd15_x) - 0.0012089992423205001 *
      a17_x_p2 + 4.4999986458742003e-05 * (a17_x_p5 - a17_x_p4);

  // link 17 (right_lowerarm), inward
  const Real n16_z = n16_z_p2 + (0.004500002325 * a16_x - 0.0022500062 * a16_y) -
      (s17 * n17_x + c17 * n17_y);

  // link 1 (calf), inward
  const Real qdd_0_p24 = tau[15] - n16_z;

  // link 16 (right_upperarm), bias force
  const Real qdd_0_p25 = qdd_0_p24 + (s17 * qdd_0_p22 + c17 * qdd_0_p23);
  const Real qdd_0_p26 = 0.282 * qdd_0_p21 - (s17 * qdd_0_p23 - c17 * qdd_0_p22) + inverse_D15_p1 *
      qdd_0_p25;

  // link 17 (right_lowerarm), bias force
  const Real qdd_0_p27 = c18 * qdd_0_p14 - s18 * qdd_0_p16 + inverse_D1_p249 * qdd_0_p20;
  const Real qdd_0_p28 = inverse_D1_p258 * qdd_0_p20 -
      (inverse_D1_p253 * qdd_0_p13 - (s19 * qdd_0_p9 + c19 * qdd_0_p8));
  const Real qdd_0_p29 = s17 * qdd_0_p28 - c17 * qdd_0_p27;

  // link 16 (right_upperarm), bias force
  const Real qdd_0_p30 = qdd_0_p19 + 0.282 * qdd_0_p29 + inverse_D15_p3 * qdd_0_p25;

  // link 19 (right_wrist2), inward
  const Real minus_f18_x = 6e-04 * (minus_a19_y_p5 + n18_x_p4) + 0.001 * n18_y_p2 + n18_y_p1;
  const Real f18_y = 6e-04 * n18_x_p3 + 0.001 * (minus_a19_y_p4 + n18_x_p4) + f19_z;

  // link 18 (right_wrist1), inward
  const Real f17_z = 0.0014999985000000002 * n17_x_p4 + 0.28049749700000004 * n17_x_p1 +
      (c18 * f18_y - s18 * minus_f18_x);

  // link 16 (right_upperarm), outward
  const Real n16_x_p1 = a17_z_p1 + wd16_x;
  const Real n16_x_p2 = a17_x_p1 - wd16_y;
  const Real n16_x_p3 = n16_z_p1 - wd15_x;
  const Real n16_x_p4 = w16_z * w16_z;

  // link 16 (right_upperarm), inertial wrench
  const Real n16_x_p5 = 0.0019585440854647937 * n16_x_p1 + 4.4999986458742003e-05 * n16_x_p2 -
      0.0005895000784280001 * n16_x_p3 + 0.0012089992423205001 * (n16_x_p4 - a17_x_p5);

  // link 17 (right_lowerarm), inward
  const Real n16_x = n16_x_p5 + 0.004500002325 * a15_x +
      (0.282 * f17_z - (s17 * n17_y - c17 * n17_x));

  // link 18 (right_wrist1), inward
  const Real minus_f17_x = 0.0014999985000000002 * (n17_z_p5 + n17_x_p5) + 0.28049749700000004 *
      n17_y_p1 + (c18 * minus_f18_x + s18 * f18_y);

  // link 19 (right_wrist2), inward
  const Real f18_z = 6e-04 * n18_x_p2 - 0.001 * n18_x_p1 - (s19 * f19_x + c19 * f19_y);

  // link 18 (right_wrist1), inward
  const Real f17_y = 0.0014999985000000002 * n17_x_p2 - 0.28049749700000004 *
      (n17_z_p6 + n17_x_p5) - f18_z;

  // link 17 (right_lowerarm), inward
  const Real n16_y_p1 = c17 * minus_f17_x + s17 * f17_y;

  // link 16 (right_upperarm), outward
  const Real n16_y_p2 = n16_z_p1 + wd15_x;

  // link 16 (right_upperarm), inertial wrench
  const Real n16_y_p3 = 0.0012089992423205001 * n16_y_p2 - 0.0008177492704690715 * n16_x_p2 -
      4.4999986458742003e-05 * n16_x_p1 + 0.0005895000784280001 * (a17_x_p4 - n16_x_p4);

  // link 17 (right_lowerarm), inward
  const Real n16_y = n16_y_p3 - 0.0022500062 * a15_x + (n17_z + 0.282 * n16_y_p1);

  // link 15 (right_shoulder2), outward
  const Real n15_z_p1 = w15_x * w15_y;
  const Real n15_z_p2 = w15_y * w15_z;
  const Real n15_z_p3 = w15_x * w15_z;

  // link 15 (right_shoulder2), inertial wrench
  const Real n15_z_p4 = 0.18101044219699997 * n15_z_p1 + 0.18125194219699997 * wd14_x +
      0.00010499999999999999 * (n15_z_p2 - wd15_x) + 1.75e-05 * (n15_z_p3 + wd15_y);

  // link 15 (right_shoulder2), outward
  const Real n15_z_p5 = w15_y * w15_y;
  const Real n15_z_p6 = w15_x * w15_x;

  // link 16 (right_upperarm), inward
  const Real n15_z = n15_z_p4 - 5.2499999999999995e-05 * (n15_z_p5 - n15_z_p6) +
      (0.7139200499999999 * a15_y + 0.0017499999999999998 * a15_x) + (c16 * n16_x - s16 * n16_y);

  // link 1 (calf), inward
  const Real qdd_0_p31 = tau[14] - n15_z;

  // link 15 (right_shoulder2), bias force
  const Real qdd_0_p32 = qdd_0_p31 - (c16 * qdd_0_p26 - s16 * qdd_0_p30);
  const Real qdd_0_p33 = s16 * qdd_0_p26 + c16 * qdd_0_p30 + inverse_D14_p1 * qdd_0_p32;

  // link 15 (right_shoulder2), articulated inertia
  const Real qdd_0_p34 = 0.00010499999999999999 / inverse_D15_p9;

  // link 15 (right_shoulder2), bias force
  const Real qdd_0_p35 = qdd_0_p24 + qdd_0_p34 * qdd_0_p32;

  // link 15 (right_shoulder2), outward
  const Real n15_y_p1 = n15_z_p3 - wd15_y;
  const Real n15_y_p2 = n15_z_p1 - wd14_x;
  const Real n15_y_p3 = n15_z_p2 + wd15_x;
  const Real n15_y_p4 = w15_z * w15_z;

  // link 15 (right_shoulder2), inertial wrench
  const Real n15_y_p5 = 5.2499999999999995e-05 * n15_y_p3 -
      (0.18113119219699997 * n15_y_p1 + 1.75e-05 * n15_y_p2) + 0.00010499999999999999 *
      (n15_z_p6 - n15_y_p4);

  // link 16 (right_upperarm), inward
  const Real n15_y = n15_y_p5 - 0.7139200499999999 * a14_x + (s16 * n16_x + c16 * n16_y);

  // link 15 (right_shoulder2), outward
  const Real n15_x_p1 = n15_z_p1 + wd14_x;

  // link 15 (right_shoulder2), inertial wrench
  const Real n15_x_p2 = 0.00012075 * n15_y_p3 - 5.2499999999999995e-05 * n15_y_p1 -
      0.00010499999999999999 * n15_x_p1 - 1.75e-05 * (n15_y_p4 - n15_z_p5);

  // link 14 (right_shoulder1), inertial wrench
  const Real n15_x_p3 = 0.0017499999999999998 * a14_x;

  // link 16 (right_upperarm), inward
  const Real n15_x = n15_x_p2 - n15_x_p3 - n16_z;

  // link 14 (right_shoulder1), outward
  const Real n14_z_p1 = w14_y * w14_y;
  const Real n14_z_p2 = w14_x * w14_x;
  const Real n14_z_p3 = w14_x * w14_y;

  // link 7 (left_shoulder1), inertial wrench
  const Real n14_z_p4 = 0.00044800000000000005 * wd6_y;

  // link 15 (right_shoulder2), inward
  const Real n14_z_p5 = 0.00014700000000000002 * n14_z_p3 + n14_z_p4 + 8.75e-06 *
      (n14_z_p1 - n14_z_p2) + 0.0017499999999999998 * a14_y + n15_x_p3;

  // link 14 (right_shoulder1), outward
  const Real n14_z_p6 = w14_x * w14_z;
  const Real n14_z_p7 = w14_y * w14_z;

  // link 15 (right_shoulder2), inward
  const Real n14_z = n14_z_p5 + s15 * n15_x + c15 * n15_y + 2.6249999999999998e-05 *
      (n14_z_p6 + wd14_y - (n14_z_p7 - wd14_x));

  // link 1 (calf), inward
  const Real qdd_0_p36 = tau[13] - n14_z;

  // link 14 (right_shoulder1), bias force
  const Real qdd_0_p37 = qdd_0_p36 - (c15 * qdd_0_p33 - s15 * qdd_0_p35);
  const Real qdd_0_p38 = inverse_D6_p1 * qdd_0_p37 - (c15 * qdd_0_p35 + s15 * qdd_0_p33);

  // link 14 (right_shoulder1), articulated inertia
  const Real qdd_0_p39 = 2.6249999999999998e-05 / inverse_D14_p8;

  // link 14 (right_shoulder1), bias force
  const Real qdd_0_p40 = qdd_0_p31 + qdd_0_p39 * qdd_0_p37;

  // link 14 (right_shoulder1), outward
  const Real n14_x_p1 = n14_z_p7 + wd14_x;
  const Real n14_x_p2 = n14_z_p6 - wd14_y;

  // link 14 (right_shoulder1), inertial wrench
  const Real n14_x_p3 = 0.0017499999999999998 * a14_z;

  // link 14 (right_shoulder1), outward
  const Real n14_x_p4 = n14_z_p3 + wd6_y;
  const Real n14_x_p5 = w14_z * w14_z;

  // link 15 (right_shoulder2), inward
  const Real n14_x = 0.0001505 * n14_x_p1 + 8.75e-06 * n14_x_p2 - n14_x_p3 + n15_z +
      2.6249999999999998e-05 * (n14_x_p4 - (n14_x_p5 - n14_z_p1));

  // link 21 (neck), outward
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;
  const Real w21_y = c21 * w6_y - s21 * w6_z;
  const Real wd21_x = s21 * wd6_y + c21 * wd5_x + w21_y * qd[20];
  const Real w21_z = qd[20] - w6_x;
  const Real a22_z_p1 = w21_y * w21_z;
  const Real a22_z_p2 = a22_z_p1 - wd21_x;

  // link 22 (head), outward
  const Real a22_z = 0.394 * a22_z_p2 - minus_a21_y;

  // link 21 (neck), outward
  const Real w21_x = s21 * w6_y + c21 * w6_z;

  // link 22 (head), outward
  const Real w22_x = c22 * w21_x - s22 * w21_z;
  const Real w22_z = w21_y + qd[21];
  const Real a24_y_p1 = w22_x * w22_z;
  const Real wd22_y = c22 * wd6_x - s22 * wd21_x - w22_x * qd[21];
  const Real a24_y_p2 = a24_y_p1 - wd22_y;

  // link 24 (right_eye), outward
  const Real a24_y_p3 = a22_z + 0.095 * a24_y_p2;

  // link 22 (head), outward
  const Real a24_y_p4 = w22_x * w22_x;
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;
  const Real a24_y_p5 = minus_w22_y * minus_w22_y;

  // link 23 (left_eye), outward
  const Real a24_y_p6 = 0.032 * (a24_y_p4 + a24_y_p5);

  // link 21 (neck), outward
  const Real a22_x_p1 = w21_x * w21_x;
  const Real a22_x_p2 = w21_y * w21_y;

  // link 22 (head), outward
  const Real a22_x_p3 = a6_x + 0.394 * (a22_x_p1 + a22_x_p2);

  // link 21 (neck), outward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;
  const Real wd21_y = c21 * wd6_y - s21 * wd5_x - w21_x * qd[20];
  const Real a22_x_p4 = w21_x * w21_z;

  // link 22 (head), outward
  const Real a22_x_p5 = a21_x + 0.394 * (a22_x_p4 + wd21_y);
  const Real a22_x = c22 * a22_x_p5 + s22 * a22_x_p3;
  const Real a24_y_p7 = w22_z * w22_z;

  // link 23 (left_eye), outward
  const Real a24_y_p8 = a24_y_p5 + a24_y_p7;

  // link 24 (right_eye), outward
  const Real a24_y_p9 = a22_x - 0.095 * a24_y_p8;

  // link 23 (left_eye), outward
  const Real a24_y_p10 = 0.032 * (a24_y_p1 + wd22_y);

  // link 24 (right_eye), outward
  const Real a24_y = c24 * (a24_y_p3 + a24_y_p6) - s24 * (a24_y_p9 - a24_y_p10);
  const Real w24_x = c24 * w22_x + s24 * w22_z;
  const Real w24_y = c24 * w22_z - s24 * w22_x;
  const Real n24_z_p1 = w24_x * w24_y;

  // link 23 (left_eye), inertial wrench
  const Real n24_z_p2 = 9.25e-06 * wd22_y;

  // link 22 (head), outward
  const Real wd22_x = c22 * wd21_x + s22 * wd6_x - minus_w22_y * qd[21];

  // link 24 (right_eye), outward
  const Real wd24_x = c24 * wd22_x + s24 * wd21_y + w24_y * qd[23];
  const Real w24_z = minus_w22_y + qd[23];
  const Real n24_z_p3 = w24_y * w24_z;

  // link 24 (right_eye), inertial wrench
  const Real n24_z = 1.2499999999999999e-06 * n24_z_p1 - n24_z_p2 + 2.8750000000000004e-05 *
      (n24_z_p3 - wd24_x) + 0.00025 * a24_y;

  // link 22 (head), outward
  const Real n22_y_p1 = minus_w22_y * w22_z;
  const Real n22_y_p2 = wd22_x - n22_y_p1;

  // link 23 (left_eye), outward
  const Real a23_y = c23 * (a24_y_p3 - a24_y_p6) - s23 * (a24_y_p9 + a24_y_p10);
  const Real w23_x = c23 * w22_x + s23 * w22_z;
  const Real w23_y = c23 * w22_z - s23 * w22_x;
  const Real n23_z_p1 = w23_x * w23_y;
  const Real wd23_x = c23 * wd22_x + s23 * wd21_y + w23_y * qd[22];
  const Real w23_z = minus_w22_y + qd[22];
  const Real n23_z_p2 = w23_y * w23_z;

  // link 23 (left_eye), inertial wrench
  const Real n23_z = 1.2499999999999999e-06 * n23_z_p1 - n24_z_p2 + 2.8750000000000004e-05 *
      (n23_z_p2 - wd23_x) + 0.00025 * a23_y;

  // link 24 (right_eye), outward
  const Real f24_y_p1 = n24_z_p1 - wd22_y;

  // link 24 (right_eye), inertial wrench
  const Real f24_y = 0.00025 * f24_y_p1;

  // link 24 (right_eye), outward
  const Real minus_f24_x_p1 = w24_z * w24_z;

  // link 24 (right_eye), inertial wrench
  const Real minus_f24_x = 0.00025 * (w24_y * w24_y + minus_f24_x_p1);

  // link 23 (left_eye), outward
  const Real f23_y_p1 = n23_z_p1 - wd22_y;

  // link 23 (left_eye), inertial wrench
  const Real f23_y = 0.00025 * f23_y_p1;

  // link 23 (left_eye), outward
  const Real minus_f23_x_p1 = w23_z * w23_z;

  // link 23 (left_eye), inertial wrench
  const Real minus_f23_x = 0.00025 * (w23_y * w23_y + minus_f23_x_p1);

  // link 23 (left_eye), inward
  const Real n22_y_p3 = c24 * f24_y - s24 * minus_f24_x + (c23 * f23_y - s23 * minus_f23_x);
  const Real n22_y_p4 = 0.0074 * n22_y_p2 - 0.009438624999999999 * a24_y_p2 - 0.072575 * a22_z -
      n24_z - n23_z - 0.095 * n22_y_p3;

  // link 24 (right_eye), inward
  const Real n22_y_p5 = c24 * minus_f24_x + s24 * f24_y;

  // link 23 (left_eye), inward
  const Real n22_y_p6 = c23 * minus_f23_x + s23 * f23_y;
  const Real n22_y = n22_y_p4 + 0.032 * (n22_y_p5 - n22_y_p6);

  // link 24 (right_eye), inertial wrench
  const Real n24_x = 4e-06 * (n24_z_p3 + wd24_x) - 2.8750000000000004e-05 * f24_y_p1;

  // link 24 (right_eye), outward
  const Real n24_y_p1 = (w24_z + qd[23]) * w24_x - (c24 * wd21_y - s24 * wd22_x);

  // link 22 (head), outward
  const Real a22_y = c22 * a22_x_p3 - s22 * a22_x_p5;
  const Real minus_a24_z_p1 = w22_x * minus_w22_y;
  const Real minus_a24_z_p2 = wd21_y - minus_a24_z_p1;

  // link 24 (right_eye), outward
  const Real minus_a24_z_p3 = a22_y + 0.095 * minus_a24_z_p2;

  // link 23 (left_eye), outward
  const Real minus_a24_z_p4 = 0.032 * (n22_y_p1 + wd22_x);

  // link 24 (right_eye), outward
  const Real minus_a24_z = minus_a24_z_p3 + minus_a24_z_p4;

  // link 24 (right_eye), inertial wrench
  const Real n24_y = 2.8750000000000004e-05 * (w24_x * w24_x - minus_f24_x_p1) - 5.25e-06 *
      n24_y_p1 + 0.00025 * minus_a24_z;

  // link 23 (left_eye), inward
  const Real n22_x_p1 = 0.05450270000000001 * n22_y_p2 - 0.0074 * a24_y_p2 - 0.43200000000000005 *
      a22_z + c24 * n24_x - s24 * n24_y;

  // link 23 (left_eye), inertial wrench
  const Real n23_x = 4e-06 * (n23_z_p2 + wd23_x) - 2.8750000000000004e-05 * f23_y_p1;

  // link 23 (left_eye), outward
  const Real n23_y_p1 = (w23_z + qd[22]) * w23_x - (c23 * wd21_y - s23 * wd22_x);
  const Real minus_a23_z = minus_a24_z_p3 - minus_a24_z_p4;

  // link 23 (left_eye), inertial wrench
  const Real n23_y = 2.8750000000000004e-05 * (w23_x * w23_x - minus_f23_x_p1) - 5.25e-06 *
      n23_y_p1 + 0.00025 * minus_a23_z;

  // link 23 (left_eye), inward
  const Real n22_x = n22_x_p1 + c23 * n23_x - s23 * n23_y + 8e-06 * (n23_y_p1 - n24_y_p1);
  const Real f22_z = 0.072575 * a24_y_p2 - 0.43200000000000005 * n22_y_p2 + n22_y_p3;

  // link 21 (neck), outward
  const Real n21_x_p1 = w21_x * w21_y;
  const Real n21_x_p2 = n21_x_p1 - wd6_x;

  // link 22 (head), inward
  const Real n21_x = 0.005513625 * (a22_z_p1 + wd21_x) - 0.0016155 * n21_x_p2 -
      (s22 * n22_y - c22 * n22_x + 0.394 * f22_z);

  // link 6 (chest3), inertial wrench
  const Real n6_z_p1 = 1.26882463592404 * a14_y_p4 + 2.06965463592404 * wd5_x - 0.0187369177636143 *
      (a14_y_p9 - wd6_x) + 6.1665928899999995 * minus_a6_y;

  // link 23 (left_eye), inward
  const Real n22_z_p1 = 0.04506407500000001 * minus_a24_z_p1 + 0.06394132500000001 * wd21_y -
      0.0074 * (a24_y_p5 - a24_y_p4) + 0.072575 * a22_y;
  const Real n22_z_p2 = n22_z_p1 + 0.43200000000000005 * a22_x + s24 * n24_x + c24 * n24_y + s23 *
      n23_x;
  const Real n22_z_p3 = n24_y_p1 + n23_y_p1;
  const Real n22_z = n22_z_p2 + c23 * n23_y - 2.375e-05 * n22_z_p3;
  const Real f22_y = 0.072575 * minus_a24_z_p2 + 0.43200000000000005 * (a24_y_p4 + a24_y_p7) -
      0.00025 * n22_z_p3;
  const Real f22_x = 0.43200000000000005 * (minus_a24_z_p1 + wd21_y) - 0.072575 * a24_y_p8 -
      n22_y_p5 - n22_y_p6;

  // link 22 (head), inward
  const Real n21_y_p1 = s22 * f22_y - c22 * f22_x;

  // link 21 (neck), outward
  const Real n21_y_p2 = w21_z * w21_z;
  const Real n21_y_p3 = a22_x_p4 - wd21_y;

  // link 22 (head), inward
  const Real n21_y = 0.0016155 * (a22_x_p1 - n21_y_p2) - 0.000703125 * n21_y_p3 +
      0.0045000000000000005 * a6_x + (n22_z - 0.394 * n21_y_p1);

  // link 15 (right_shoulder2), inward
  const Real n14_y_p1 = c15 * n15_x - s15 * n15_y - 0.0002975 * n14_x_p2 - 8.75e-06 * n14_x_p1 -
      n14_x_p3;

  // link 14 (right_shoulder1), outward
  const Real n14_y_p2 = n14_z_p3 - wd6_y;

  // link 15 (right_shoulder2), inward
  const Real n14_y = n14_y_p1 - 2.6249999999999998e-05 * (n14_y_p2 + (n14_z_p2 - n14_x_p5));

  // link 7 (left_shoulder1), inward
  const Real n6_z_p2 = n6_z_p1 + c21 * n21_x - s21 * n21_y + c14 * n14_x - s14 * n14_y;

  // link 7 (left_shoulder1), outward
  const Real a7_x_p1 = a14_y_p3 + a14_y_p5;
  const Real a7_x_p2 = a14_y_p8 + a14_y_p11;
  const Real a7_x = s7 * a7_x_p1 + c7 * a7_x_p2;
  const Real a7_y = c7 * a7_x_p1 - s7 * a7_x_p2;
  const Real minus_a7_z = a14_z_p2 + a14_z_p4;

  // link 8 (left_shoulder2), outward
  const Real minus_a8_y = s8 * a7_y + c8 * minus_a7_z;

  // link 9 (left_upperarm), outward
  const Real a9_x = c9 * a7_x - s9 * minus_a8_y;

  // link 7 (left_shoulder1), outward
  const Real w7_x = s7 * w6_x + c7 * w6_z;
  const Real wd7_y = c7 * wd6_x - s7 * wd5_x - w7_x * qd[6];
  const Real w7_y = c7 * w6_x - s7 * w6_z;
  const Real w7_z = w6_y + qd[6];

  // link 8 (left_shoulder2), outward
  const Real w8_x = c8 * w7_y + s8 * w7_z;
  const Real wd8_y = c8 * wd6_y - s8 * wd7_y - w8_x * qd[7];

  // link 7 (left_shoulder1), outward
  const Real wd7_x = s7 * wd6_x + c7 * wd5_x + w7_y * qd[6];

  // link 8 (left_shoulder2), outward
  const Real w8_y = c8 * w7_z - s8 * w7_y;
  const Real w8_z = w7_x + qd[7];

  // link 9 (left_upperarm), outward
  const Real w9_x = s9 * w8_y + c9 * w8_z;
  const Real wd9_y = c9 * wd8_y - s9 * wd7_x - w9_x * qd[8];
  const Real w9_z = qd[8] - w8_x;
  const Real a10_x_p1 = w9_x * w9_z;
  const Real a10_x_p2 = a10_x_p1 + wd9_y;

  // link 10 (left_lowerarm), outward
  const Real a10_x_p3 = a9_x - 0.282 * a10_x_p2;

  // link 9 (left_upperarm), outward
  const Real a10_x_p4 = w9_x * w9_x;
  const Real w9_y = c9 * w8_y - s9 * w8_z;
  const Real a10_x_p5 = w9_y * w9_y;

  // link 8 (left_shoulder2), outward
  const Real a8_x = c8 * a7_y - s8 * minus_a7_z;

  // link 10 (left_lowerarm), outward
  const Real a10_x_p6 = 0.282 * (a10_x_p4 + a10_x_p5) - a8_x;
  const Real a10_x = c10 * a10_x_p3 - s10 * a10_x_p6;

  // link 9 (left_upperarm), outward
  const Real minus_a9_y = c9 * minus_a8_y + s9 * a7_x;
  const Real wd9_x = s9 * wd8_y + c9 * wd7_x + w9_y * qd[8];
  const Real minus_a10_z_p1 = w9_y * w9_z;
  const Real minus_a10_z_p2 = minus_a10_z_p1 - wd9_x;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_z = minus_a9_y + 0.282 * minus_a10_z_p2;

  // link 11 (left_wrist1), outward
  const Real a11_x = c11 * a10_x - s11 * minus_a10_z;

  // link 8 (left_shoulder2), outward
  const Real wd8_x = c8 * wd7_y + s8 * wd6_y + w8_y * qd[7];

  // link 10 (left_lowerarm), outward
  const Real minus_w10_y = s10 * w9_x + c10 * w9_z;
  const Real wd10_x = c10 * wd9_x + s10 * wd8_x - minus_w10_y * qd[9];
  const Real w10_x = c10 * w9_x - s10 * w9_z;
  const Real w10_z = w9_y + qd[9];

  // link 11 (left_wrist1), outward
  const Real w11_x = c11 * w10_x + s11 * w10_z;
  const Real wd11_y = c11 * wd9_y - s11 * wd10_x - w11_x * qd[10];
  const Real w11_z = minus_w10_y + qd[10];
  const Real a12_x_p1 = w11_x * w11_z;
  const Real a12_x_p2 = a12_x_p1 + wd11_y;

  // link 12 (left_wrist2), outward
  const Real a12_x_p3 = a11_x - 0.269 * a12_x_p2;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_y = s10 * a10_x_p3 + c10 * a10_x_p6;

  // link 11 (left_wrist1), outward
  const Real a12_x_p4 = w11_x * w11_x;
  const Real w11_y = c11 * w10_z - s11 * w10_x;
  const Real a12_x_p5 = w11_y * w11_y;

  // link 12 (left_wrist2), outward
  const Real a12_x_p6 = minus_a10_y + 0.269 * (a12_x_p4 + a12_x_p5);
  const Real a12_x = c12 * a12_x_p3 - s12 * a12_x_p6;

  // link 11 (left_wrist1), outward
  const Real wd11_x = c11 * wd10_x + s11 * wd9_y + w11_y * qd[10];

  // link 10 (left_lowerarm), outward
  const Real wd10_y = c10 * wd8_x - s10 * wd9_x - w10_x * qd[9];

  // link 12 (left_wrist2), outward
  const Real w12_x = c12 * w11_x - s12 * w11_z;
  const Real wd12_y = c12 * wd10_y - s12 * wd11_x - w12_x * qd[11];
  const Real minus_w12_y = s12 * w11_x + c12 * w11_z;
  const Real w12_z = w11_y + qd[11];

  // link 13 (left_hand), outward
  const Real w13_y = s13 * minus_w12_y + c13 * w12_z;
  const Real wd13_x = c13 * wd12_y + s13 * wd11_y + w13_y * qd[12];
  const Real w13_z = w12_x + qd[12];
  const Real n13_x_p1 = w13_y * w13_z;
  const Real n13_x_p2 = n13_x_p1 + wd13_x;
  const Real w13_x = s13 * w12_z - c13 * minus_w12_y;
  const Real wd13_y = c13 * wd11_y - s13 * wd12_y - w13_x * qd[12];
  const Real n13_x_p3 = w13_x * w13_z;
  const Real n13_x_p4 = n13_x_p3 - wd13_y;
  const Real n13_x_p5 = w13_x * w13_y;

  // link 12 (left_wrist2), outward
  const Real wd12_x = c12 * wd11_x + s12 * wd10_y - minus_w12_y * qd[11];

  // link 13 (left_hand), outward
  const Real n13_x_p6 = n13_x_p5 + wd12_x;
  const Real n13_x_p7 = w13_y * w13_y;
  const Real n13_x_p8 = w13_z * w13_z;

  // link 13 (left_hand), inertial wrench
  const Real n13_x_p9 = 9.149209276993575e-05 * n13_x_p2 - 0.0001263900573325125 * n13_x_p4 -
      0.000108260010923775 * n13_x_p6 - 4.38600177048965e-05 * (n13_x_p8 - n13_x_p7);
  const Real n13_x = n13_x_p9 - 0.002865001425 * a12_x;

  // link 13 (left_hand), outward
  const Real n13_y_p1 = n13_x_p5 - wd12_x;
  const Real n13_y_p2 = w13_x * w13_x;

  // link 13 (left_hand), inertial wrench
  const Real n13_y_p3 = 0.0001263900573325125 * n13_x_p2 -
      (0.000847139515629375 * n13_x_p4 + 4.38600177048965e-05 * n13_y_p1) + 0.000108260010923775 *
      (n13_y_p2 - n13_x_p8);
  const Real n13_y = n13_y_p3 - 0.01626499875 * a12_x;

  // link 11 (left_wrist1), outward
  const Real minus_a11_y = s11 * a10_x + c11 * minus_a10_z;
  const Real minus_a12_z_p1 = w11_y * w11_z;
  const Real minus_a12_z_p2 = minus_a12_z_p1 - wd11_x;

  // link 12 (left_wrist2), outward
  const Real minus_a12_z = minus_a11_y + 0.269 * minus_a12_z_p2;
  const Real n12_y_p1 = w12_x * w12_z;
  const Real n12_y_p2 = n12_y_p1 - wd12_y;
  const Real n12_y_p3 = w12_x * minus_w12_y;
  const Real n12_y_p4 = n12_y_p3 + wd11_y;

  // link 13 (left_hand), inward
  const Real n12_y = 0.0025100003499999995 * minus_a12_z -
      (0.000195227662257343 * n12_y_p2 + 2.4000000000000003e-06 * n12_y_p4) +
      (c13 * n13_x - s13 * n13_y);

  // link 12 (left_wrist2), outward
  const Real minus_a12_y = s12 * a12_x_p3 + c12 * a12_x_p6;

  // link 13 (left_hand), outward
  const Real a13_y = s13 * minus_a12_y - c13 * minus_a12_z;
  const Real minus_a13_x = c13 * minus_a12_y + s13 * minus_a12_z;

  // link 13 (left_hand), inertial wrench
  const Real n13_z_p1 = 0.0007556474228594393 * n13_x_p5 + 0.0009386316083993107 * wd12_x +
      0.000108260010923775 * (n13_x_p1 - wd13_x) + 4.38600177048965e-05 * (n13_x_p3 + wd13_y);
  const Real n13_z = n13_z_p1 - 0.0001263900573325125 * (n13_x_p7 - n13_y_p2) +
      (0.01626499875 * a13_y - 0.002865001425 * minus_a13_x);

  // link 12 (left_wrist2), outward
  const Real n12_x_p1 = wd12_x - minus_w12_y * w12_z;
  const Real n12_x_p2 = w12_z * w12_z;
  const Real n12_x_p3 = minus_w12_y * minus_w12_y;

  // link 13 (left_hand), inward
  const Real n12_x = 1.16e-05 * n12_x_p1 + 2.4000000000000003e-06 * (n12_x_p2 - n12_x_p3) -
      0.0006000000000000001 * minus_a12_z + n13_z;

  // link 13 (left_hand), inertial wrench
  const Real f13_y = 0.01626499875 * n13_x_p6 + 0.002865001425 * (n13_y_p2 + n13_x_p8);
  const Real minus_f13_x = 0.01626499875 * (n13_x_p7 + n13_x_p8) + 0.002865001425 * n13_y_p1;

  // link 13 (left_hand), inward
  const Real f12_z = 0.0025100003499999995 * n12_y_p2 + 0.0006000000000000001 * n12_x_p1 +
      (c13 * f13_y - s13 * minus_f13_x);

  // link 11 (left_wrist1), outward
  const Real n11_x_p1 = minus_a12_z_p1 + wd11_x;
  const Real n11_x_p2 = a12_x_p1 - wd11_y;
  const Real n11_x_p3 = w11_x * w11_y;
  const Real n11_x_p4 = n11_x_p3 - wd10_y;
  const Real n11_x_p5 = w11_z * w11_z;

  // link 11 (left_wrist1), inertial wrench
  const Real n11_x_p6 = 0.0001194 * n11_x_p1 + 6e-06 * n11_x_p2 + 0.000144 * n11_x_p4 - 0.0002516 *
      (n11_x_p5 - a12_x_p5);

  // link 12 (left_wrist2), inward
  const Real n11_x = n11_x_p6 + 0.001 * minus_a10_y + (0.269 * f12_z - (s12 * n12_y - c12 * n12_x));

  // link 10 (left_lowerarm), outward
  const Real n10_x_p1 = minus_w10_y * w10_z;
  const Real n10_x_p2 = wd10_x - n10_x_p1;
  const Real n10_x_p3 = w10_x * minus_w10_y;
  const Real n10_x_p4 = wd9_y - n10_x_p3;

  // link 12 (left_wrist2), inertial wrench
  const Real n12_z_p1 = 0.00020682766225734302 * wd11_y - 0.000183627662257343 * n12_y_p3 -
      2.4000000000000003e-06 * (n12_y_p1 + wd12_y) - (0.0025100003499999995 * minus_a12_y +
      0.0006000000000000001 * a12_x);

  // link 13 (left_hand), inward
  const Real n12_z = n12_z_p1 + (s13 * n13_x + c13 * n13_y);
  const Real f12_y = 0.0025100003499999995 * (wd11_y - n12_y_p3) - 0.0006000000000000001 *
      (w12_x * w12_x + n12_x_p2) - (c13 * minus_f13_x + s13 * f13_y);

  // link 13 (left_hand), inertial wrench
  const Real f13_z = 0.01626499875 * n13_x_p4 - 0.002865001425 * n13_x_p2;

  // link 13 (left_hand), inward
  const Real f12_x = f13_z - (0.0025100003499999995 * (n12_x_p3 + n12_x_p2) +
      0.0006000000000000001 * n12_y_p4);

  // link 12 (left_wrist2), inward
  const Real n11_y_p1 = s12 * f12_y - c12 * f12_x;

  // link 11 (left_wrist1), outward
  const Real n11_y_p2 = n11_x_p3 + wd10_y;

  // link 11 (left_wrist1), inertial wrench
  const Real n11_y_p3 = 0.0001098 * n11_x_p2 + 0.0002516 * n11_y_p2 + 6e-06 * n11_x_p1 + 0.000144 *
      (a12_x_p4 - n11_x_p5);

  // link 12 (left_wrist2), inward
  const Real n11_y = n12_z + 0.269 * n11_y_p1 - (n11_y_p3 + 6e-04 * minus_a10_y);

  // link 11 (left_wrist1), inward
  const Real n10_x_p5 = 0.06060754126741261 * n10_x_p2 - 2.249994685315e-05 * n10_x_p4 -
      0.28049749700000004 * minus_a10_z + c11 * n11_x - s11 * n11_y;

  // link 10 (left_lowerarm), outward
  const Real n10_x_p6 = w10_x * w10_z;
  const Real n10_x_p7 = n10_x_p6 - wd10_y;
  const Real n10_x_p8 = w10_z * w10_z;
  const Real n10_x_p9 = minus_w10_y * minus_w10_y;

  // link 11 (left_wrist1), inward
  const Real n10_x = n10_x_p5 + 0.0001499998887063 * (n10_x_p7 + (n10_x_p8 - n10_x_p9));

  // link 11 (left_wrist1), inertial wrench
  const Real n11_z_p1 = 0.0002516 * a12_x_p2 - (9.600000000000003e-06 * n11_x_p3 + 0.0002292 *
      wd10_y + 0.000144 * minus_a12_z_p2) + 6e-06 * (a12_x_p5 - a12_x_p4);

  // link 12 (left_wrist2), inward
  const Real n11_z = n11_z_p1 - (6e-04 * minus_a11_y + 0.001 * a11_x) - (s12 * n12_x + c12 * n12_y);

  // link 10 (left_lowerarm), outward
  const Real n10_y_p1 = w10_x * w10_x;
  const Real n10_y_p2 = n10_x_p3 + wd9_y;

  // link 11 (left_wrist1), inward
  const Real n10_y = 2.249994685315e-05 * (n10_y_p1 - n10_x_p8) - 0.00028099984685315 * n10_x_p7 +
      0.0014999985000000002 * minus_a10_z - n11_z - 0.0001499998887063 * (n10_y_p2 + n10_x_p2);

  // link 12 (left_wrist2), inward
  const Real f11_x = 0.001 * n11_y_p2 - 6e-04 * (a12_x_p5 + n11_x_p5) - n11_y_p1;
  const Real f11_y = 6e-04 * n11_x_p4 - 0.001 * (a12_x_p4 + n11_x_p5) + f12_z;

  // link 11 (left_wrist1), inward
  const Real f10_z = 0.0014999985000000002 * n10_x_p7 + 0.28049749700000004 * n10_x_p2 +
      (s11 * f11_x + c11 * f11_y);

  // link 9 (left_upperarm), outward
  const Real n9_x_p1 = minus_a10_z_p1 + wd9_x;
  const Real n9_x_p2 = a10_x_p1 - wd9_y;
  const Real n9_x_p3 = w9_x * w9_y;
  const Real n9_x_p4 = n9_x_p3 - wd8_x;
  const Real n9_x_p5 = w9_z * w9_z;

  // link 9 (left_upperarm), inertial wrench
  const Real n9_x_p6 = 0.0019585440854647937 * n9_x_p1 - 4.4999986458742003e-05 * n9_x_p2 -
      0.0005895000784280001 * n9_x_p4 - 0.0012089992423205001 * (n9_x_p5 - a10_x_p5);

  // link 10 (left_lowerarm), inward
  const Real n9_x = n9_x_p6 - 0.004500002325 * a8_x + (0.282 * f10_z - (s10 * n10_y - c10 * n10_x));

  // link 11 (left_wrist1), inward
  const Real n10_z_p1 = 0.06032654142055946 * n10_x_p3 + 0.060888541114265754 * wd9_y -
      2.249994685315e-05 * (n10_x_p1 + wd10_x) - 0.0014999985000000002 * minus_a10_y;
  const Real n10_z = n10_z_p1 - 0.28049749700000004 * a10_x + s11 * n11_x + c11 * n11_y +
      0.0001499998887063 * (n10_x_p9 - n10_y_p1 - (n10_x_p6 + wd10_y));

  // link 12 (left_wrist2), inward
  const Real f11_z = 6e-04 * n11_x_p2 + 0.001 * n11_x_p1 - (s12 * f12_x + c12 * f12_y);

  // link 11 (left_wrist1), inward
  const Real f10_y = 0.0014999985000000002 * n10_x_p4 - 0.28049749700000004 *
      (n10_y_p1 + n10_x_p8) - f11_z;
  const Real f10_x = c11 * f11_x - s11 * f11_y - (0.0014999985000000002 * (n10_x_p9 + n10_x_p8) +
      0.28049749700000004 * n10_y_p2);

  // link 10 (left_lowerarm), inward
  const Real n9_y_p1 = s10 * f10_y - c10 * f10_x;

  // link 9 (left_upperarm), outward
  const Real n9_y_p2 = n9_x_p3 + wd8_x;

  // link 9 (left_upperarm), inertial wrench
  const Real n9_y_p3 = 4.4999986458742003e-05 * n9_x_p1 -
      (0.0008177492704690715 * n9_x_p2 + 0.0012089992423205001 * n9_y_p2) + 0.0005895000784280001 *
      (a10_x_p4 - n9_x_p5);

  // link 10 (left_lowerarm), inward
  const Real n9_y = n9_y_p3 - 0.0022500062 * a8_x + (n10_z + 0.282 * n9_y_p1);

  // link 8 (left_shoulder2), outward
  const Real n8_z_p1 = w8_x * w8_y;
  const Real n8_z_p2 = w8_y * w8_z;
  const Real n8_z_p3 = w8_x * w8_z;

  // link 8 (left_shoulder2), inertial wrench
  const Real n8_z_p4 = 0.18101044219699997 * n8_z_p1 + 0.18125194219699997 * wd7_x +
      0.00010499999999999999 * (n8_z_p2 - wd8_x) - 1.75e-05 * (n8_z_p3 + wd8_y);

  // link 8 (left_shoulder2), outward
  const Real n8_z_p5 = w8_y * w8_y;
  const Real n8_z_p6 = w8_x * w8_x;

  // link 9 (left_upperarm), inward
  const Real n8_z = n8_z_p4 + 5.2499999999999995e-05 * (n8_z_p5 - n8_z_p6) -
      (0.7139200499999999 * minus_a8_y + 0.0017499999999999998 * a8_x) + (c9 * n9_x - s9 * n9_y);

  // link 7 (left_shoulder1), outward
  const Real n7_x_p1 = w7_y * w7_z;
  const Real n7_x_p2 = n7_x_p1 + wd7_x;
  const Real n7_x_p3 = w7_x * w7_z;
  const Real n7_x_p4 = n7_x_p3 - wd7_y;

  // link 7 (left_shoulder1), inertial wrench
  const Real n7_x_p5 = 0.0017499999999999998 * minus_a7_z;

  // link 7 (left_shoulder1), outward
  const Real n7_x_p6 = w7_y * w7_y;
  const Real n7_x_p7 = w7_z * w7_z;
  const Real n7_x_p8 = w7_x * w7_y;
  const Real n7_x_p9 = n7_x_p8 + wd6_y;

  // link 8 (left_shoulder2), inward
  const Real n7_x = 0.0001505 * n7_x_p2 + 8.75e-06 * n7_x_p4 + n7_x_p5 + n8_z +
      2.6249999999999998e-05 * (n7_x_p7 - n7_x_p6 - n7_x_p9);

  // link 8 (left_shoulder2), outward
  const Real n8_y_p1 = n8_z_p1 - wd7_x;
  const Real n8_y_p2 = n8_z_p3 - wd8_y;
  const Real n8_y_p3 = n8_z_p2 + wd8_x;
  const Real n8_y_p4 = w8_z * w8_z;

  // link 8 (left_shoulder2), inertial wrench
  const Real n8_y_p5 = 1.75e-05 * n8_y_p1 - 0.18113119219699997 * n8_y_p2 - 5.2499999999999995e-05 *
      n8_y_p3 + 0.00010499999999999999 * (n8_z_p6 - n8_y_p4);

  // link 9 (left_upperarm), inward
  const Real n8_y = n8_y_p5 - 0.7139200499999999 * a7_x + (s9 * n9_x + c9 * n9_y);

  // link 9 (left_upperarm), inertial wrench
  const Real n9_z_p1 = 0.0005895000784280001 * minus_a10_z_p2 -
      (0.001140794814995722 * n9_x_p3 + 0.0027762933559338653 * wd8_x) + 0.0012089992423205001 *
      a10_x_p2 - 4.4999986458742003e-05 * (a10_x_p5 - a10_x_p4);

  // link 10 (left_lowerarm), inward
  const Real n9_z = n9_z_p1 + (0.0022500062 * minus_a9_y - 0.004500002325 * a9_x) -
      (s10 * n10_x + c10 * n10_y);

  // link 8 (left_shoulder2), outward
  const Real n8_x_p1 = n8_z_p1 + wd7_x;

  // link 8 (left_shoulder2), inertial wrench
  const Real n8_x_p2 = 0.00012075 * n8_y_p3 + 5.2499999999999995e-05 * n8_y_p2 -
      0.00010499999999999999 * n8_x_p1 + 1.75e-05 * (n8_y_p4 - n8_z_p5);

  // link 7 (left_shoulder1), inertial wrench
  const Real n8_x_p3 = 0.0017499999999999998 * a7_x;

  // link 9 (left_upperarm), inward
  const Real n8_x = n8_x_p2 + n8_x_p3 - n9_z;

  // link 8 (left_shoulder2), inward
  const Real n7_y_p1 = n7_x_p5 - (0.0002975 * n7_x_p4 + 8.75e-06 * n7_x_p2) + c8 * n8_x - s8 * n8_y;

  // link 7 (left_shoulder1), outward
  const Real n7_y_p2 = n7_x_p8 - wd6_y;
  const Real n7_y_p3 = w7_x * w7_x;

  // link 8 (left_shoulder2), inward
  const Real n7_y = n7_y_p1 + 2.6249999999999998e-05 * (n7_y_p2 + (n7_y_p3 - n7_x_p7));

  // link 17 (right_lowerarm), inward
  const Real f16_x = 0.0022500062 * (a17_x_p5 + n16_x_p4) - 0.004500002325 * n16_y_p2 - n16_y_p1;
  const Real f16_y = 0.004500002325 * (a17_x_p4 + n16_x_p4) - 0.0022500062 * n16_x_p3 + f17_z;

  // link 16 (right_upperarm), inward
  const Real f15_y = 0.7139200499999999 * n15_x_p1 + 0.0017499999999999998 * (n15_z_p6 + n15_y_p4) +
      (s16 * f16_x + c16 * f16_y);

  // link 17 (right_lowerarm), inward
  const Real f16_z = s17 * minus_f17_x - c17 * f17_y -
      (0.0022500062 * n16_x_p2 + 0.004500002325 * n16_x_p1);

  // link 16 (right_upperarm), inward
  const Real minus_f15_x = 0.7139200499999999 * (n15_z_p5 + n15_y_p4) + 0.0017499999999999998 *
      n15_y_p2 + f16_z;

  // link 15 (right_shoulder2), inward
  const Real f14_z = c15 * f15_y - s15 * minus_f15_x + 0.0017499999999999998 *
      (n14_x_p2 - n14_x_p1);

  // link 10 (left_lowerarm), inward
  const Real f9_z = 0.004500002325 * n9_x_p1 - 0.0022500062 * n9_x_p2 - (s10 * f10_x + c10 * f10_y);

  // link 9 (left_upperarm), inward
  const Real f8_x = 0.0017499999999999998 * n8_y_p1 - 0.7139200499999999 * (n8_z_p5 + n8_y_p4) -
      f9_z;

  // link 10 (left_lowerarm), inward
  const Real f9_x = 0.0022500062 * (a10_x_p5 + n9_x_p5) + 0.004500002325 * n9_y_p2 - n9_y_p1;
  const Real f9_y = f10_z - (0.0022500062 * n9_x_p4 + 0.004500002325 * (a10_x_p4 + n9_x_p5));

  // link 9 (left_upperarm), inward
  const Real f8_y = 0.7139200499999999 * n8_x_p1 - 0.0017499999999999998 * (n8_z_p6 + n8_y_p4) +
      (s9 * f9_x + c9 * f9_y);

  // link 8 (left_shoulder2), inward
  const Real f7_z = s8 * f8_x + c8 * f8_y + 0.0017499999999999998 * (n7_x_p4 - n7_x_p2);

  // link 7 (left_shoulder1), inward
  const Real n6_z_p3 = f14_z + f7_z;

  // link 15 (right_shoulder2), inward
  const Real f14_y = 0.0017499999999999998 * (n14_x_p4 + (n14_z_p2 + n14_x_p5)) -
      (c15 * minus_f15_x + s15 * f15_y);
  const Real f14_x = 0.7139200499999999 * n15_y_p1 + c16 * f16_x - s16 * f16_y -
      0.0017499999999999998 * (n15_y_p3 + (n14_z_p1 + n14_x_p5) + n14_y_p2);

  // link 14 (right_shoulder1), inward
  const Real n6_z_p4 = s14 * f14_x + c14 * f14_y;

  // link 8 (left_shoulder2), inward
  const Real f7_y = c8 * f8_x - s8 * f8_y + 0.0017499999999999998 * (n7_x_p9 + (n7_y_p3 + n7_x_p7));
  const Real f7_x = 0.7139200499999999 * n8_y_p2 + c9 * f9_x - s9 * f9_y + 0.0017499999999999998 *
      (n8_y_p3 - (n7_x_p6 + n7_x_p7) - n7_y_p2);

  // link 7 (left_shoulder1), inward
  const Real n6_z_p5 = s7 * f7_x + c7 * f7_y;
  const Real n6_z = n6_z_p2 + c7 * n7_x - s7 * n7_y - 0.226 * n6_z_p3 + 0.18 * (n6_z_p4 - n6_z_p5);

  // link 1 (calf), inward
  const Real qdd_0_p41 = tau[5] - n6_z;
  const Real qdd_0_p42 = tau[21] - n22_z;
  const Real qdd_0_p43 = tau[23] - n24_z;

  // link 24 (right_eye), bias force
  const Real qdd_0_p44 = 3.1081081081081083 * qdd_0_p43;

  // link 1 (calf), inward
  const Real qdd_0_p45 = tau[22] - n23_z;

  // link 23 (left_eye), bias force
  const Real qdd_0_p46 = 3.1081081081081083 * qdd_0_p45;

  // link 22 (head), bias force
  const Real qdd_0_p47 = qdd_0_p42 + (s24 * qdd_0_p44 + s23 * qdd_0_p46);

  // link 24 (right_eye), bias force
  const Real qdd_0_p48 = 27.027027027027028 * qdd_0_p43;

  // link 23 (left_eye), bias force
  const Real qdd_0_p49 = 27.027027027027028 * qdd_0_p45;

  // link 22 (head), bias force
  const Real qdd_0_p50 = c24 * qdd_0_p48 + c23 * qdd_0_p49;

  // link 24 (right_eye), bias force
  const Real qdd_0_p51 = s24 * qdd_0_p48;

  // link 23 (left_eye), bias force
  const Real qdd_0_p52 = s23 * qdd_0_p49;

  // link 22 (head), bias force
  const Real qdd_0_p53 = inverse_D21_p1 * qdd_0_p47 - (qdd_0_p43 + qdd_0_p45) - 0.095 * qdd_0_p50 +
      0.032 * (qdd_0_p51 - qdd_0_p52);
  const Real qdd_0_p54 = inverse_D21_p6 * qdd_0_p47 - (c24 * qdd_0_p44 + c23 * qdd_0_p46);
  const Real qdd_0_p55 = qdd_0_p50 + inverse_D1_p400 * qdd_0_p47;

  // link 22 (head), inward
  const Real n21_z = 0.0016155 * a22_z_p2 - (0.0048105000000000005 * n21_x_p1 + 0.00621675 *
      wd6_x) - 0.0045000000000000005 * minus_a21_y - (s22 * n22_x + c22 * n22_y);

  // link 1 (calf), inward
  const Real qdd_0_p56 = tau[20] - n21_z;

  // link 21 (neck), bias force
  const Real qdd_0_p57 = qdd_0_p56 + (s22 * qdd_0_p54 + c22 * qdd_0_p53);
  const Real qdd_0_p58 = s22 * qdd_0_p53 - c22 * qdd_0_p54 + 0.394 * qdd_0_p55 + inverse_D6_p12 *
      qdd_0_p57;

  // link 22 (head), bias force
  const Real qdd_0_p59 = inverse_D1_p383 * qdd_0_p47;
  const Real qdd_0_p60 = inverse_D1_p370 * qdd_0_p47 - (qdd_0_p51 + qdd_0_p52);
  const Real qdd_0_p61 = s22 * qdd_0_p59 - c22 * qdd_0_p60;

  // link 21 (neck), bias force
  const Real qdd_0_p62 = qdd_0_p42 - 0.394 * qdd_0_p61 - inverse_D6_p17 * qdd_0_p57;

  // link 6 (chest3), bias force
  const Real qdd_0_p63 = qdd_0_p41 - c14 * qdd_0_p40 + s14 * qdd_0_p38 + c21 * qdd_0_p58 + s21 *
      qdd_0_p62;

  // link 1 (calf), inward
  const Real qdd_0_p64 = tau[11] - n12_z;
  const Real qdd_0_p65 = tau[12] - n13_z;

  // link 13 (left_hand), bias force
  const Real qdd_0_p66 = 0.04672761636452121 * qdd_0_p65;
  const Real qdd_0_p67 = 0.11533812622014242 * qdd_0_p65;

  // link 12 (left_wrist2), bias force
  const Real qdd_0_p68 = qdd_0_p64 - (c13 * qdd_0_p66 - s13 * qdd_0_p67);

  // link 13 (left_hand), bias force
  const Real qdd_0_p69 = 3.0523172236718206 * qdd_0_p65;
  const Real qdd_0_p70 = 17.32841575379867 * qdd_0_p65;

  // link 12 (left_wrist2), bias force
  const Real qdd_0_p71 = s13 * qdd_0_p69 + c13 * qdd_0_p70 + inverse_D1_p9 * qdd_0_p68;
  const Real qdd_0_p72 = inverse_D1_p3 * qdd_0_p68 - (c13 * qdd_0_p67 + s13 * qdd_0_p66);

  // link 1 (calf), inward
  const Real qdd_0_p73 = tau[10] - n11_z;

  // link 11 (left_wrist1), bias force
  const Real qdd_0_p74 = qdd_0_p73 + (s12 * qdd_0_p65 + c12 * qdd_0_p72);
  const Real qdd_0_p75 = 0.269 * qdd_0_p71 - (s12 * qdd_0_p72 - c12 * qdd_0_p65) + inverse_D1_p14 *
      qdd_0_p74;

  // link 12 (left_wrist2), bias force
  const Real qdd_0_p76 = inverse_D1_p25 * qdd_0_p68;
  const Real qdd_0_p77 = c13 * qdd_0_p69 - s13 * qdd_0_p70 + inverse_D1_p22 * qdd_0_p68;
  const Real qdd_0_p78 = c12 * qdd_0_p76 + s12 * qdd_0_p77;

  // link 11 (left_wrist1), bias force
  const Real qdd_0_p79 = qdd_0_p64 + 0.269 * qdd_0_p78 + inverse_D1_p30 * qdd_0_p74;

  // link 1 (calf), inward
  const Real qdd_0_p80 = tau[9] - n10_z;

  // link 10 (left_lowerarm), bias force
  const Real qdd_0_p81 = qdd_0_p80 - (s11 * qdd_0_p75 + c11 * qdd_0_p79);
  const Real qdd_0_p82 = c11 * qdd_0_p75 - s11 * qdd_0_p79 + inverse_D1_p48 * qdd_0_p81;
  const Real qdd_0_p83 = qdd_0_p73 + inverse_D1_p51 * qdd_0_p81;

  // link 11 (left_wrist1), bias force
  const Real qdd_0_p84 = inverse_D1_p56 * qdd_0_p74 - qdd_0_p78;
  const Real qdd_0_p85 = qdd_0_p71 + inverse_D1_p59 * qdd_0_p74;

  // link 10 (left_lowerarm), bias force
  const Real qdd_0_p86 = s11 * qdd_0_p84 + c11 * qdd_0_p85 + inverse_D1_p66 * qdd_0_p81;

  // link 1 (calf), inward
  const Real qdd_0_p87 = tau[8] - n9_z;

  // link 9 (left_upperarm), bias force
  const Real qdd_0_p88 = qdd_0_p87 - (c10 * qdd_0_p83 - s10 * qdd_0_p82);
  const Real qdd_0_p89 = c10 * qdd_0_p82 + s10 * qdd_0_p83 + 0.282 * qdd_0_p86 - inverse_D8_p1 *
      qdd_0_p88;

  // link 10 (left_lowerarm), bias force
  const Real qdd_0_p90 = c11 * qdd_0_p84 - s11 * qdd_0_p85 + inverse_D1_p73 * qdd_0_p81;
  const Real qdd_0_p91 = inverse_D1_p82 * qdd_0_p81 -
      (s12 * qdd_0_p76 - c12 * qdd_0_p77 + inverse_D1_p77 * qdd_0_p74);
  const Real qdd_0_p92 = s10 * qdd_0_p91 - c10 * qdd_0_p90;

  // link 9 (left_upperarm), bias force
  const Real qdd_0_p93 = qdd_0_p80 + 0.282 * qdd_0_p92 + inverse_D8_p3 * qdd_0_p88;

  // link 1 (calf), inward
  const Real qdd_0_p94 = tau[7] - n8_z;

  // link 8 (left_shoulder2), bias force
  const Real qdd_0_p95 = qdd_0_p94 - (c9 * qdd_0_p89 - s9 * qdd_0_p93);
  const Real qdd_0_p96 = s9 * qdd_0_p89 + c9 * qdd_0_p93 + inverse_D7_p1 * qdd_0_p95;

  // link 8 (left_shoulder2), articulated inertia
  const Real qdd_0_p97 = 0.00010499999999999999 / inverse_D8_p9;

  // link 8 (left_shoulder2), bias force
  const Real qdd_0_p98 = qdd_0_p87 + qdd_0_p97 * qdd_0_p95;

  // link 8 (left_shoulder2), inward
  const Real n7_z_p1 = 0.00014700000000000002 * n7_x_p8 + n14_z_p4 + 8.75e-06 *
      (n7_x_p6 - n7_y_p3) + 0.0017499999999999998 * a7_y + n8_x_p3;
  const Real n7_z = n7_z_p1 + s8 * n8_x + c8 * n8_y + 2.6249999999999998e-05 *
      (n7_x_p1 - wd7_x - (n7_x_p3 + wd7_y));

  // link 1 (calf), inward
  const Real qdd_0_p99 = tau[6] - n7_z;

  // link 7 (left_shoulder1), bias force
  const Real qdd_0_p100 = qdd_0_p99 - (c8 * qdd_0_p96 - s8 * qdd_0_p98);

  // link 7 (left_shoulder1), articulated inertia
  const Real qdd_0_p101 = 2.6249999999999998e-05 / inverse_D7_p8;

  // link 7 (left_shoulder1), bias force
  const Real qdd_0_p102 = qdd_0_p94 - qdd_0_p101 * qdd_0_p100;
  const Real qdd_0_p103 = inverse_D6_p6 * qdd_0_p100 - (c8 * qdd_0_p98 + s8 * qdd_0_p96);

  // link 16 (right_upperarm), bias force
  const Real qdd_0_p104 = inverse_D1_p266 * qdd_0_p25 - qdd_0_p29;
  const Real qdd_0_p105 = qdd_0_p21 + inverse_D1_p281 * qdd_0_p25;

  // link 15 (right_shoulder2), bias force
  const Real qdd_0_p106 = s16 * qdd_0_p104 + c16 * qdd_0_p105 + inverse_D1_p308 * qdd_0_p32;
  const Real qdd_0_p107 = s17 * qdd_0_p27 + c17 * qdd_0_p28 + inverse_D1_p311 * qdd_0_p25 +
      inverse_D1_p317 * qdd_0_p32;

  // link 9 (left_upperarm), bias force
  const Real qdd_0_p108 = qdd_0_p92 + inverse_D1_p90 * qdd_0_p88;
  const Real qdd_0_p109 = qdd_0_p86 - inverse_D1_p105 * qdd_0_p88;

  // link 8 (left_shoulder2), bias force
  const Real qdd_0_p110 = inverse_D1_p141 * qdd_0_p95 - (s9 * qdd_0_p108 - c9 * qdd_0_p109);
  const Real qdd_0_p111 = inverse_D1_p132 * qdd_0_p88 - (s10 * qdd_0_p90 + c10 * qdd_0_p91) +
      inverse_D1_p138 * qdd_0_p95;

  // link 6 (chest3), bias force
  const Real qdd_0_p112 = s15 * qdd_0_p107 + c15 * qdd_0_p106 + inverse_D1_p334 * qdd_0_p37 +
      (c8 * qdd_0_p110 - s8 * qdd_0_p111 + inverse_D1_p179 * qdd_0_p100);

  // link 7 (left_shoulder1), bias force
  const Real qdd_0_p113 = inverse_D1_p123 * qdd_0_p95 - (c9 * qdd_0_p108 + s9 * qdd_0_p109) +
      inverse_D1_p129 * qdd_0_p100;
  const Real qdd_0_p114 = inverse_D1_p148 * qdd_0_p100 - (c8 * qdd_0_p111 + s8 * qdd_0_p110);
  const Real qdd_0_p115 = s7 * qdd_0_p113 + c7 * qdd_0_p114;

  // link 14 (right_shoulder1), bias force
  const Real qdd_0_p116 = c16 * qdd_0_p104 - s16 * qdd_0_p105 + inverse_D1_p299 * qdd_0_p32 +
      inverse_D1_p305 * qdd_0_p37;
  const Real qdd_0_p117 = c15 * qdd_0_p107 - s15 * qdd_0_p106 + inverse_D1_p324 * qdd_0_p37;
  const Real qdd_0_p118 = s14 * qdd_0_p116 + c14 * qdd_0_p117;

  // link 6 (chest3), bias force
  const Real qdd_0_p119 = qdd_0_p63 - c7 * qdd_0_p102 + s7 * qdd_0_p103 + 0.226 * qdd_0_p112 +
      0.18 * (qdd_0_p115 - qdd_0_p118);
  const Real qdd_0_p120 = s14 * qdd_0_p40 + c14 * qdd_0_p38 - qdd_0_p56 + s7 * qdd_0_p102 + c7 *
      qdd_0_p103;

  // link 7 (left_shoulder1), bias force
  const Real qdd_0_p121 = c7 * qdd_0_p113 - s7 * qdd_0_p114;

  // link 14 (right_shoulder1), bias force
  const Real qdd_0_p122 = c14 * qdd_0_p116 - s14 * qdd_0_p117;

  // link 6 (chest3), bias force
  const Real qdd_0_p123 = qdd_0_p120 + inverse_D5_p14 * qdd_0_p119 + 0.18 *
      (qdd_0_p121 - qdd_0_p122);
  const Real qdd_0_p124 = qdd_0_p122 + qdd_0_p121;
  const Real qdd_0_p125 = qdd_0_p36 - s21 * qdd_0_p58 + c21 * qdd_0_p62 + qdd_0_p99 +
      inverse_D5_p16 * qdd_0_p119 + 0.226 * qdd_0_p124;

  // link 21 (neck), bias force
  const Real qdd_0_p126 = qdd_0_p61 + inverse_D1_p431 * qdd_0_p57;
  const Real qdd_0_p127 = qdd_0_p55 + inverse_D1_p434 * qdd_0_p57;

  // link 6 (chest3), bias force
  const Real qdd_0_p128 = qdd_0_p124 - c21 * qdd_0_p126 - s21 * qdd_0_p127 + inverse_D1_p450 *
      qdd_0_p119;

  // link 7 (left_shoulder1), inward
  const Real n6_x_p1 = 0.40041499999999997 * a14_y_p10 + 0.0187369177636143 * a14_z_p1 - n21_z +
      s14 * n14_x + c14 * n14_y;
  const Real n6_x_p2 = c7 * f7_x - s7 * f7_y;

  // link 14 (right_shoulder1), inward
  const Real n6_x_p3 = c14 * f14_x - s14 * f14_y;

  // link 7 (left_shoulder1), inward
  const Real n6_x = n6_x_p1 + s7 * n7_x + c7 * n7_y + 0.18 * (n6_x_p2 - n6_x_p3);
  const Real n6_y_p1 = 6.1665928899999995 * a6_z - 1.66923963592404 * a14_y_p7 -
      0.0187369177636143 * (a14_z_p3 - a14_y_p1) + s21 * n21_x;
  const Real n6_y_p2 = n6_x_p3 + n6_x_p2;
  const Real n6_y = n6_y_p1 + c21 * n21_y + n14_z + n7_z + 0.226 * n6_y_p2;

  // link 22 (head), inward
  const Real minus_f21_x = 0.0045000000000000005 * (a22_x_p2 + n21_y_p2) + n21_y_p1;
  const Real f21_y = 0.0045000000000000005 * n21_x_p2 + f22_z;

  // link 7 (left_shoulder1), inward
  const Real f6_z = n6_y_p2 - 6.1665928899999995 * a14_y_p7 - c21 * minus_f21_x - s21 * f21_y;

  // link 5 (chest2), outward
  const Real n5_z_p1 = minus_w5_y * minus_w5_y;

  // link 5 (chest2), inertial wrench
  const Real n5_z_p2 = 0.10961925816937637 * a6_z_p1 - 0.203126912024134 * minus_wd4_y -
      0.005678398088837119 * (n5_z_p1 - a6_x_p1) + (0.069699984375 * a5_y + 2.2194301519999997 *
      a5_x);

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p2 + (s6 * n6_x + c6 * n6_y + 0.072 * f6_z);

  // link 1 (calf), inward
  const Real qdd_0_p129 = tau[4] - n5_z;

  // link 5 (chest2), bias force
  const Real qdd_0_p130 = qdd_0_p129 - (s6 * qdd_0_p123 + c6 * qdd_0_p125 + 0.072 * qdd_0_p128);
  const Real qdd_0_p131 = c6 * qdd_0_p123 - s6 * qdd_0_p125 + inverse_D1_p479 * qdd_0_p130;

  // link 5 (chest2), outward
  const Real n5_y_p1 = w5_x * w5_z + minus_wd5_y;

  // link 6 (chest3), inward
  const Real n5_y = 0.005678398088837119 * a6_x_p5 - 0.04675382692737882 * n5_y_p1 +
      0.069699984375 * minus_a4_y + (c6 * n6_x - s6 * n6_y);

  // link 4 (chest1), outward
  const Real qdd_0_p132 = w4_x * w4_y;

  // link 6 (chest3), bias force
  const Real qdd_0_p133 = s22 * qdd_0_p60 + c22 * qdd_0_p59 + inverse_D1_p390 * qdd_0_p57 +
      qdd_0_p118 + qdd_0_p115 + inverse_D1_p410 * qdd_0_p119;
  const Real qdd_0_p134 = qdd_0_p112 - s21 * qdd_0_p126 + c21 * qdd_0_p127 + inverse_D1_p441 *
      qdd_0_p119;
  const Real qdd_0_p135 = s6 * qdd_0_p133 + c6 * qdd_0_p134;

  // link 5 (chest2), bias force
  const Real qdd_0_p136 = qdd_0_p41 - 0.072 * qdd_0_p135 - inverse_D1_p477 * qdd_0_p130;

  // link 22 (head), inward
  const Real f21_z = 0.0045000000000000005 * n21_y_p3 - (s22 * f22_x + c22 * f22_y);

  // link 7 (left_shoulder1), inward
  const Real f6_x = 6.1665928899999995 * a14_y_p2 - f21_z + n6_z_p4 + n6_z_p5;
  const Real f6_y = n6_z_p3 - 6.1665928899999995 * a14_z_p1 - s21 * minus_f21_x + c21 * f21_y;

  // link 6 (chest3), inward
  const Real n5_x_p1 = s6 * f6_x + c6 * f6_y;
  const Real n5_x = 0.15637308509675518 * a6_x_p5 - 0.005678398088837119 * n5_y_p1 +
      2.2194301519999997 * minus_a4_y + (n6_z - 0.072 * n5_x_p1);

  // link 4 (chest1), bias force
  const Real qdd_0_p137 = tau[3] - 0.0300000063 * minus_a4_y + 0.03561389675370483 * qdd_0_p132 +
      (n5_y + qdd_0_p131) * c5 + (n5_x + qdd_0_p136) * s5;

  // link 5 (chest2), bias force
  const Real qdd_0_p138 = qdd_0_p135 + inverse_D1_p462 * qdd_0_p130;

  // link 4 (chest1), bias force
  const Real qdd_0_p139 = s4 * (inverse_D3_p1 * qdd_0_p137 -
      (s5 * qdd_0_p131 - c5 * qdd_0_p136 + 0.21799999999999997 * qdd_0_p138));

  // link 5 (chest2), bias force
  const Real qdd_0_p140 = c6 * qdd_0_p133 - s6 * qdd_0_p134 + inverse_D1_p490 * qdd_0_p130;
  const Real qdd_0_p141 = qdd_0_p128 + inverse_D1_p486 * qdd_0_p130;
  const Real qdd_0_p142 = s5 * qdd_0_p140 - c5 * qdd_0_p141;

  // link 6 (chest3), inward
  const Real f5_z = 0.069699984375 * n5_y_p1 - 2.2194301519999997 * a6_x_p5 + n5_x_p1;

  // link 5 (chest2), inward
  const Real n4_x = 0.095783 * wd4_x + 0.005880002159562879 * qdd_0_p132 -
      (s5 * n5_y - c5 * n5_x + 0.21799999999999997 * f5_z);

  // link 6 (chest3), inward
  const Real f5_y = 2.2194301519999997 * a6_x_p3 - 0.069699984375 * (a6_z_p1 + minus_wd4_y) +
      (c6 * f6_x - s6 * f6_y);
  const Real f5_x = f6_z - (0.069699984375 * (n5_z_p1 + a6_x_p2) + 2.2194301519999997 * a6_z_p2);

  // link 5 (chest2), inward
  const Real n4_y_p1 = s5 * f5_y - c5 * f5_x;

  // link 4 (chest1), outward
  const Real n4_y_p2 = qd[3] * qd[3];

  // link 5 (chest2), inward
  const Real n4_y = n5_z - 0.21799999999999997 * n4_y_p1 -
      (0.02455520649259034 * minus_wd4_y + 0.005880002159562879 * (a5_y_p1 - n4_y_p2) +
      0.0300000063 * a3_y);

  // link 4 (chest1), inward
  const Real n3_z = 8.419374554 * a3_x - 0.02999999505 * a3_y + (s4 * n4_x + c4 * n4_y);

  // link 1 (calf), inward
  const Real qdd_0_p143 = tau[2] - n3_z;

  // link 3 (hip), bias force
  const Real qdd_0_p144 = qdd_0_p143 - (qdd_0_p139 + c4 *
      (qdd_0_p129 - 0.21799999999999997 * qdd_0_p142 - inverse_D3_p2 * qdd_0_p137));
  const Real qdd_0_p145 = inverse_D1_p520 * qdd_0_p144 -
      (c4 * (qdd_0_p142 + inverse_D1_p498 * qdd_0_p137) + s4 *
      (qdd_0_p138 - inverse_D1_p507 * qdd_0_p137));
  const Real qdd_0_p146 = inverse_D1_p525 * qdd_0_p137 - (s5 * qdd_0_p141 + c5 * qdd_0_p140) +
      inverse_D1_p530 * qdd_0_p144;
  const Real qdd_0_p147 = c3 * qdd_0_p145 + s3 * qdd_0_p146;

  // link 5 (chest2), inward
  const Real f4_x = 0.0300000063 * (a5_y_p2 + n4_y_p2) - n4_y_p1;
  const Real f4_y = f5_z - 0.0300000063 * qdd_0_p132;

  // link 3 (hip), outward
  const Real f3_x_p1 = w3_z * w3_z;

  // link 4 (chest1), inward
  const Real f3_x = 0.02999999505 * f3_x_p1 + (c4 * f4_x - s4 * f4_y);

  // link 5 (chest2), inward
  const Real minus_f4_z = 0.0600000126 * minus_wd4_y + (s5 * f5_x + c5 * f5_y);

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * f3_x_p1 + minus_f4_z;

  // link 3 (hip), inward
  const Real n2_z_p1 = c3 * f3_x - s3 * f3_y;
  const Real n2_z = 0.031999971599999996 * a2_y + 24.5839218 * a2_x + (n3_z + 0.422 * n2_z_p1);

  // link 2 (thigh), bias force
  const Real qdd_0_p148 = tau[1] - n2_z - (qdd_0_p143 + 0.422 * qdd_0_p147);
  const Real qdd_0_p149 = c2 * (qdd_0_p147 + inverse_D1_p537 * qdd_0_p148) - s2 *
      (s3 * qdd_0_p145 - c3 * qdd_0_p146 + inverse_D1_p541 * qdd_0_p148);

  // link 3 (hip), inward
  const Real f2_x = n2_z_p1 - 0.031999971599999996 * a3_y_p1;
  const Real f2_y = 24.5839218 * a3_y_p1 + (s3 * f3_x + c3 * f3_y);

  // link 1 (calf), bias force
  const Real qdd_0_p150 = tau[0] - 0.1569597827085 * c1 + 299.6743959432 * s1 - tau[1] - 0.434 *
      (c2 * f2_x - s2 * f2_y + qdd_0_p149);

  // link 1 (calf), acceleration
  const Real qdd_0 = inverse_D1 * qdd_0_p150;
  qdd[0] = qdd_0;

  // link 2 (thigh), acceleration
  const Real qdd_1_p1 = 0.434 * qdd_0;
  const Real qdd_1_p2 = c2 * qdd_1_p1;
  const Real qdd_1_p3 = s2 * qdd_1_p1;
  const Real qdd_1 = inverse_D2 * qdd_0_p148 - (inverse_D1_p537 * qdd_1_p2 - inverse_D1_p541 *
      qdd_1_p3 + qdd_0);
  qdd[1] = qdd_1;
  const Real qdd_2_p1 = qdd_0 + qdd_1;

  // link 3 (hip), acceleration
  const Real qdd_2_p2 = qdd_1_p2 + 0.422 * qdd_2_p1;
  const Real qdd_2_p3 = c3 * qdd_2_p2 - s3 * qdd_1_p3;
  const Real qdd_2_p4 = s3 * qdd_2_p2 + c3 * qdd_1_p3;
  const Real qdd_2 = inverse_D3 * qdd_0_p144 - (inverse_D1_p520 * qdd_2_p3 + inverse_D1_p530 *
      qdd_2_p4 + qdd_2_p1);
  qdd[2] = qdd_2;
  const Real qdd_3_p1 = qdd_2_p1 + qdd_2;

  // link 4 (chest1), acceleration
  const Real qdd_3_p2 = s4 * qdd_3_p1;
  const Real qdd_3_p3 = c4 * qdd_3_p1;
  const Real qdd_3_p4 = s4 * qdd_2_p3;
  const Real qdd_3_p5 = c4 * qdd_2_p3;
  const Real qdd_3_p6 = inverse_D1_p507 * qdd_3_p4 - inverse_D1_p498 * qdd_3_p5 + inverse_D1_p525 *
      qdd_2_p4 + (inverse_D3_p1 * qdd_3_p2 - inverse_D3_p2 * qdd_3_p3);
  const Real qdd_3 = inverse_D4 * qdd_0_p137 - qdd_3_p6;
  qdd[3] = qdd_3;

  // link 5 (chest2), acceleration
  const Real qdd_4_p1 = c5 * qdd_3_p2 - s5 * qdd_3;
  const Real qdd_4_p2 = s5 * qdd_3_p2 + c5 * qdd_3;
  const Real qdd_4_p3 = qdd_3_p5 + 0.21799999999999997 * qdd_3_p3;
  const Real qdd_4_p4 = c5 * qdd_4_p3 - s5 * qdd_2_p4;
  const Real qdd_4_p5 = s5 * qdd_4_p3 + c5 * qdd_2_p4;
  const Real qdd_4_p6 = qdd_3_p4 + 0.21799999999999997 * qdd_3_p2;
  const Real qdd_4_p7 = inverse_D1_p486 * qdd_4_p4 - inverse_D1_p490 * qdd_4_p5 - inverse_D1_p462 *
      qdd_4_p6 + (qdd_3_p3 - (inverse_D1_p477 * qdd_4_p1 + inverse_D1_p479 * qdd_4_p2));
  const Real qdd_4 = inverse_D5 * qdd_0_p130 - qdd_4_p7;
  qdd[4] = qdd_4;

  // link 6 (chest3), acceleration
  const Real qdd_5_p1 = qdd_4_p6 + 0.072 * qdd_4_p1;
  const Real qdd_5_p2 = s6 * qdd_4_p5 - c6 * qdd_5_p1;
  const Real qdd_5_p3 = c6 * qdd_4_p5 + s6 * qdd_5_p1;

  // link 5 (chest2), acceleration
  const Real qdd_5_p4 = qdd_3_p3 + qdd_4;

  // link 6 (chest3), acceleration
  const Real qdd_5_p5 = qdd_4_p4 + 0.072 * qdd_5_p4;
  const Real qdd_5_p6 = s6 * qdd_5_p4 - c6 * qdd_4_p2;
  const Real qdd_5_p7 = s6 * qdd_4_p2 + c6 * qdd_5_p4;
  const Real qdd_5_p8 = inverse_D1_p441 * qdd_5_p2 - inverse_D1_p410 * qdd_5_p3 + inverse_D1_p450 *
      qdd_5_p5 + (inverse_D5_p14 * qdd_5_p6 + inverse_D5_p16 * qdd_5_p7 + qdd_4_p1);
  const Real qdd_5 = inverse_D6 * qdd_0_p119 - qdd_5_p8;
  qdd[5] = qdd_5;
  const Real qdd_6_p1 = qdd_4_p1 + qdd_5;

  // link 7 (left_shoulder1), acceleration
  const Real qdd_6_p2 = 0.18 * qdd_6_p1;
  const Real qdd_6_p3 = qdd_5_p3 + qdd_6_p2;
  const Real qdd_6_p4 = qdd_5_p5 + 0.226 * qdd_5_p7;
  const Real qdd_6_p5 = 0.18 * qdd_5_p6;
  const Real qdd_6_p6 = qdd_6_p4 + qdd_6_p5;
  const Real qdd_6_p7 = c7 * qdd_6_p6 - s7 * qdd_6_p3;
  const Real qdd_6_p8 = c7 * qdd_6_p3 + s7 * qdd_6_p6;
  const Real qdd_6_p9 = qdd_5_p2 - 0.226 * qdd_6_p1;
  const Real qdd_6_p10 = c7 * qdd_5_p6 - s7 * qdd_6_p1;
  const Real qdd_6_p11 = s7 * qdd_5_p6 + c7 * qdd_6_p1;
  const Real qdd_6_p12 = inverse_D1_p129 * qdd_6_p7 - inverse_D1_p148 * qdd_6_p8 + inverse_D1_p179 *
      qdd_6_p9 + (inverse_D6_p6 * qdd_6_p10 - qdd_0_p101 * qdd_6_p11 + qdd_5_p7);
  const Real qdd_6 = inverse_D7 * qdd_0_p100 - qdd_6_p12;
  qdd[6] = qdd_6;
  const Real qdd_7_p1 = qdd_5_p7 + qdd_6;

  // link 8 (left_shoulder2), acceleration
  const Real qdd_7_p2 = c8 * qdd_7_p1 - s8 * qdd_6_p10;
  const Real qdd_7_p3 = c8 * qdd_6_p10 + s8 * qdd_7_p1;
  const Real qdd_7_p4 = s8 * qdd_6_p8 + c8 * qdd_6_p9;
  const Real qdd_7_p5 = s8 * qdd_6_p9 - c8 * qdd_6_p8;
  const Real qdd_7_p6 = inverse_D1_p141 * qdd_7_p4 - inverse_D1_p138 * qdd_7_p5 + inverse_D1_p123 *
      qdd_6_p7 + (inverse_D7_p1 * qdd_7_p2 - qdd_0_p97 * qdd_7_p3 + qdd_6_p11);
  const Real qdd_7 = inverse_D8 * qdd_0_p95 - qdd_7_p6;
  qdd[7] = qdd_7;
  const Real qdd_8_p1 = qdd_6_p11 + qdd_7;

  // link 9 (left_upperarm), acceleration
  const Real qdd_8_p2 = c9 * qdd_7_p2 - s9 * qdd_8_p1;
  const Real qdd_8_p3 = s9 * qdd_7_p2 + c9 * qdd_8_p1;
  const Real qdd_8_p4 = s9 * qdd_7_p4 + c9 * qdd_6_p7;
  const Real qdd_8_p5 = c9 * qdd_7_p4 - s9 * qdd_6_p7;
  const Real qdd_8_p6 = inverse_D8_p3 * qdd_8_p2 - inverse_D8_p1 * qdd_8_p3 - qdd_7_p3 -
      (inverse_D1_p90 * qdd_8_p4 + inverse_D1_p105 * qdd_8_p5 + inverse_D1_p132 * qdd_7_p5);
  const Real qdd_8 = inverse_D9 * qdd_0_p88 - qdd_8_p6;
  qdd[8] = qdd_8;
  const Real qdd_9_p1 = qdd_8 - qdd_7_p3;

  // link 10 (left_lowerarm), acceleration
  const Real qdd_9_p2 = c10 * qdd_8_p3 - s10 * qdd_9_p1;
  const Real qdd_9_p3 = s10 * qdd_8_p3 + c10 * qdd_9_p1;
  const Real qdd_9_p4 = qdd_8_p4 - 0.282 * qdd_8_p2;
  const Real qdd_9_p5 = c10 * qdd_9_p4 + s10 * qdd_7_p5;
  const Real qdd_9_p6 = c10 * qdd_7_p5 - s10 * qdd_9_p4;
  const Real qdd_9_p7 = qdd_8_p5 + 0.282 * qdd_8_p3;
  const Real qdd_9_p8 = inverse_D1_p73 * qdd_9_p5 + inverse_D1_p82 * qdd_9_p6 + inverse_D1_p66 *
      qdd_9_p7 + (inverse_D1_p48 * qdd_9_p2 + inverse_D1_p51 * qdd_9_p3 + qdd_8_p2);
  const Real qdd_9 = inverse_D10 * qdd_0_p81 - qdd_9_p8;
  qdd[9] = qdd_9;
  const Real qdd_10_p1 = qdd_8_p2 + qdd_9;

  // link 11 (left_wrist1), acceleration
  const Real qdd_10_p2 = c11 * qdd_9_p2 + s11 * qdd_10_p1;
  const Real qdd_10_p3 = c11 * qdd_10_p1 - s11 * qdd_9_p2;
  const Real qdd_10_p4 = c11 * qdd_9_p5 + s11 * qdd_9_p7;
  const Real qdd_10_p5 = c11 * qdd_9_p7 - s11 * qdd_9_p5;
  const Real qdd_10_p6 = inverse_D1_p56 * qdd_10_p4 + inverse_D1_p59 * qdd_10_p5 - inverse_D1_p77 *
      qdd_9_p6 + (inverse_D1_p14 * qdd_10_p2 + inverse_D1_p30 * qdd_10_p3 + qdd_9_p3);
  const Real qdd_10 = inverse_D11 * qdd_0_p74 - qdd_10_p6;
  qdd[10] = qdd_10;

  // link 12 (left_wrist2), acceleration
  const Real qdd_11_p1 = qdd_10_p4 - 0.269 * qdd_10_p3;
  const Real qdd_11_p2 = c12 * qdd_9_p6 - s12 * qdd_11_p1;
  const Real qdd_11_p3 = qdd_10_p5 + 0.269 * qdd_10_p2;
  const Real qdd_11_p4 = inverse_D1_p22 * qdd_11_p2 - inverse_D1_p25 *
      (c12 * qdd_11_p1 + s12 * qdd_9_p6) + inverse_D1_p9 * qdd_11_p3;

  // link 11 (left_wrist1), acceleration
  const Real qdd_11_p5 = qdd_9_p3 + qdd_10;

  // link 12 (left_wrist2), acceleration
  const Real qdd_11_p6 = s12 * qdd_10_p2 + c12 * qdd_11_p5;
  const Real qdd_11 = inverse_D12 * qdd_0_p68 - (qdd_11_p4 +
      (qdd_10_p3 - inverse_D1_p3 * qdd_11_p6));
  qdd[11] = qdd_11;
  const Real qdd_12_p1 = qdd_10_p3 + qdd_11;

  // link 13 (left_hand), acceleration
  const Real qdd_12_p2 = 0.04672761636452121 * (s13 * qdd_11_p6 + c13 * qdd_12_p1) -
      0.11533812622014242 * (s13 * qdd_12_p1 - c13 * qdd_11_p6);
  const Real qdd_12_p3 = 3.0523172236718206 * (c13 * qdd_11_p2 + s13 * qdd_11_p3) +
      17.32841575379867 * (c13 * qdd_11_p3 - s13 * qdd_11_p2);
  qdd[12] = 1065.380700001509 * qdd_0_p65 - (qdd_12_p3 +
      (qdd_12_p2 + (c12 * qdd_10_p2 - s12 * qdd_11_p5)));

  // link 14 (right_shoulder1), acceleration
  const Real qdd_13_p1 = qdd_6_p2 - qdd_5_p3;
  const Real qdd_13_p2 = qdd_6_p4 - qdd_6_p5;
  const Real qdd_13_p3 = s14 * qdd_13_p1 + c14 * qdd_13_p2;
  const Real qdd_13_p4 = c14 * qdd_13_p1 - s14 * qdd_13_p2;
  const Real qdd_13_p5 = s14 * qdd_5_p6 + c14 * qdd_6_p1;
  const Real qdd_13_p6 = c14 * qdd_5_p6 - s14 * qdd_6_p1;
  const Real qdd_13_p7 = inverse_D1_p305 * qdd_13_p3 + inverse_D1_p324 * qdd_13_p4 +
      inverse_D1_p334 * qdd_6_p9 + (qdd_0_p39 * qdd_13_p5 + inverse_D6_p1 * qdd_13_p6 + qdd_5_p7);
  const Real qdd_13 = inverse_D14 * qdd_0_p37 - qdd_13_p7;
  qdd[13] = qdd_13;
  const Real qdd_14_p1 = qdd_5_p7 + qdd_13;

  // link 15 (right_shoulder2), acceleration
  const Real qdd_14_p2 = c15 * qdd_14_p1 - s15 * qdd_13_p6;
  const Real qdd_14_p3 = c15 * qdd_13_p6 + s15 * qdd_14_p1;
  const Real qdd_14_p4 = c15 * qdd_13_p4 + s15 * qdd_6_p9;
  const Real qdd_14_p5 = c15 * qdd_6_p9 - s15 * qdd_13_p4;
  const Real qdd_14_p6 = inverse_D1_p317 * qdd_14_p4 + inverse_D1_p308 * qdd_14_p5 +
      inverse_D1_p299 * qdd_13_p3 + (inverse_D14_p1 * qdd_14_p2 - qdd_0_p34 * qdd_14_p3 +
      qdd_13_p5);
  const Real qdd_14 = inverse_D15 * qdd_0_p32 - qdd_14_p6;
  qdd[14] = qdd_14;
  const Real qdd_15_p1 = qdd_13_p5 + qdd_14;

  // link 16 (right_upperarm), acceleration
  const Real qdd_15_p2 = s16 * qdd_14_p2 + c16 * qdd_15_p1;
  const Real qdd_15_p3 = c16 * qdd_14_p2 - s16 * qdd_15_p1;
  const Real qdd_15_p4 = s16 * qdd_14_p5 + c16 * qdd_13_p3;
  const Real qdd_15_p5 = c16 * qdd_14_p5 - s16 * qdd_13_p3;
  const Real qdd_15_p6 = inverse_D1_p266 * qdd_15_p4 + inverse_D1_p281 * qdd_15_p5 +
      inverse_D1_p311 * qdd_14_p4 + (inverse_D15_p1 * qdd_15_p2 + inverse_D15_p3 * qdd_15_p3 -
      qdd_14_p3);
  const Real qdd_15 = inverse_D16 * qdd_0_p25 - qdd_15_p6;
  qdd[15] = qdd_15;
  const Real qdd_16_p1 = qdd_15 - qdd_14_p3;

  // link 17 (right_lowerarm), acceleration
  const Real qdd_16_p2 = c17 * qdd_15_p2 - s17 * qdd_16_p1;
  const Real qdd_16_p3 = s17 * qdd_15_p2 + c17 * qdd_16_p1;
  const Real qdd_16_p4 = qdd_15_p4 - 0.282 * qdd_15_p3;
  const Real qdd_16_p5 = c17 * qdd_16_p4 + s17 * qdd_14_p4;
  const Real qdd_16_p6 = c17 * qdd_14_p4 - s17 * qdd_16_p4;
  const Real qdd_16_p7 = qdd_15_p5 + 0.282 * qdd_15_p2;
  const Real qdd_16_p8 = inverse_D1_p249 * qdd_16_p5 + inverse_D1_p258 * qdd_16_p6 +
      inverse_D1_p234 * qdd_16_p7 + (inverse_D1_p243 * qdd_16_p2 - inverse_D1_p240 * qdd_16_p3 +
      qdd_15_p3);
  const Real qdd_16 = inverse_D17 * qdd_0_p20 - qdd_16_p8;
  qdd[16] = qdd_16;
  const Real qdd_17_p1 = qdd_15_p3 + qdd_16;

  // link 18 (right_wrist1), acceleration
  const Real qdd_17_p2 = c18 * qdd_16_p2 + s18 * qdd_17_p1;
  const Real qdd_17_p3 = c18 * qdd_17_p1 - s18 * qdd_16_p2;
  const Real qdd_17_p4 = c18 * qdd_16_p5 + s18 * qdd_16_p7;
  const Real qdd_17_p5 = c18 * qdd_16_p7 - s18 * qdd_16_p5;
  const Real qdd_17_p6 = inverse_D1_p214 * qdd_17_p4 + inverse_D1_p198 * qdd_17_p5 -
      inverse_D1_p253 * qdd_16_p6 + (inverse_D17_p1 * qdd_17_p2 + inverse_D17_p3 * qdd_17_p3 +
      qdd_16_p3);
  const Real qdd_17 = inverse_D18 * qdd_0_p13 - qdd_17_p6;
  qdd[17] = qdd_17;

  // link 19 (right_wrist2), acceleration
  const Real qdd_18_p1 = qdd_17_p4 - 0.269 * qdd_17_p3;
  const Real qdd_18_p2 = c19 * qdd_16_p6 - s19 * qdd_18_p1;
  const Real qdd_18_p3 = qdd_17_p5 + 0.269 * qdd_17_p2;
  const Real qdd_18_p4 = inverse_D1_p209 * (c19 * qdd_18_p1 + s19 * qdd_16_p6) + inverse_D1_p206 *
      qdd_18_p2 + inverse_D1_p192 * qdd_18_p3;

  // link 18 (right_wrist1), acceleration
  const Real qdd_18_p5 = qdd_16_p3 + qdd_17;

  // link 19 (right_wrist2), acceleration
  const Real qdd_18_p6 = s19 * qdd_17_p2 + c19 * qdd_18_p5;
  const Real qdd_18 = inverse_D19 * qdd_0_p5 - (qdd_18_p4 +
      (qdd_17_p3 - inverse_D1_p186 * qdd_18_p6));
  qdd[18] = qdd_18;
  const Real qdd_19_p1 = qdd_17_p3 + qdd_18;

  // link 20 (right_hand), acceleration
  const Real qdd_19_p2 = 0.11533812622014242 * (s20 * qdd_19_p1 - c20 * qdd_18_p6) +
      0.04672761636452121 * (s20 * qdd_18_p6 + c20 * qdd_19_p1);
  const Real qdd_19_p3 = 17.32841575379867 * (c20 * qdd_18_p3 - s20 * qdd_18_p2) -
      3.0523172236718206 * (c20 * qdd_18_p2 + s20 * qdd_18_p3);
  qdd[19] = 1065.380700001509 * qdd_0_p2 - (qdd_19_p3 +
      (c19 * qdd_17_p2 - s19 * qdd_18_p5 - qdd_19_p2));

  // link 21 (neck), acceleration
  const Real qdd_20_p1 = s21 * qdd_5_p7 + c21 * qdd_6_p1;
  const Real qdd_20_p2 = c21 * qdd_5_p7 - s21 * qdd_6_p1;
  const Real qdd_20_p3 = c21 * qdd_5_p2 - s21 * qdd_5_p5;
  const Real qdd_20_p4 = s21 * qdd_5_p2 + c21 * qdd_5_p5;
  const Real qdd_20_p5 = inverse_D1_p434 * qdd_20_p3 - inverse_D1_p431 * qdd_20_p4 -
      inverse_D1_p390 * qdd_5_p3 - (inverse_D6_p12 * qdd_20_p1 + inverse_D6_p17 * qdd_20_p2 +
      qdd_5_p6);
  const Real qdd_20 = inverse_D21 * qdd_0_p57 - qdd_20_p5;
  qdd[20] = qdd_20;
  const Real qdd_21_p1 = qdd_20 - qdd_5_p6;

  // link 22 (head), acceleration
  const Real qdd_21_p2 = c22 * qdd_20_p1 - s22 * qdd_21_p1;
  const Real qdd_21_p3 = s22 * qdd_20_p1 + c22 * qdd_21_p1;
  const Real qdd_21_p4 = qdd_20_p4 + 0.394 * qdd_20_p2;
  const Real qdd_21_p5 = c22 * qdd_21_p4 - s22 * qdd_5_p3;
  const Real qdd_21_p6 = qdd_20_p3 - 0.394 * qdd_20_p1;
  const Real qdd_21_p7 = inverse_D1_p370 * qdd_21_p5 - inverse_D1_p383 *
      (s22 * qdd_21_p4 + c22 * qdd_5_p3) + inverse_D1_p400 * qdd_21_p6;
  const Real qdd_21 = inverse_D22 * qdd_0_p47 - (qdd_21_p7 +
      (inverse_D21_p6 * qdd_21_p2 - inverse_D21_p1 * qdd_21_p3 + qdd_20_p2));
  qdd[21] = qdd_21;

  // link 23 (left_eye), acceleration
  const Real qdd_22_p1 = qdd_21_p6 + 0.095 * qdd_21_p3;
  const Real qdd_22_p2 = 0.032 * qdd_21_p3;

  // link 22 (head), acceleration
  const Real qdd_22_p3 = qdd_20_p2 + qdd_21;

  // link 23 (left_eye), acceleration
  const Real qdd_22_p4 = 27.027027027027028 * (c23 * qdd_22_p1 - s23 * (qdd_21_p5 - qdd_22_p2)) +
      (qdd_21_p3 - 3.1081081081081083 * (c23 * qdd_21_p2 + s23 * qdd_22_p3));
  qdd[22] = 108108.1081081081 * qdd_0_p45 - qdd_22_p4;

  // link 24 (right_eye), acceleration
  const Real qdd_23_p1 = 27.027027027027028 * (c24 * qdd_22_p1 - s24 * (qdd_21_p5 + qdd_22_p2)) +
      (qdd_21_p3 - 3.1081081081081083 * (c24 * qdd_21_p2 + s24 * qdd_22_p3));
  qdd[23] = 108108.1081081081 * qdd_0_p43 - qdd_23_p1;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
