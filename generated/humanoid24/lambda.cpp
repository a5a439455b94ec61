// lambda: Lambda = (J M^-1 J^T)^-1
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points.
// 8250 flops (add 3545, mul 4661, div 44), sine and cosine of 24 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

using Lanes = detail::Lanes<Real, 8>;
void lambda(const Real (&TREELINE_RESTRICT q)[24], Real (&TREELINE_RESTRICT Lambda)[144]) noexcept {
  const Real angles[24] = {q[12], q[10], q[8], q[7], q[6], q[5], q[4], q[3], q[2], q[1], q[0], q[9],
      q[11], q[21], q[23], q[22], q[20], q[18], q[19], q[17], q[16], q[15], q[14], q[13]};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real c13 = cosines[0];
  const Real c11 = cosines[1];
  const Real c9 = cosines[2];
  const Real s8 = sines[3];
  const Real c7 = cosines[4];
  const Real c6 = cosines[5];
  const Real s5 = sines[6];
  const Real c4 = cosines[7];
  const Real c3 = cosines[8];
  const Real c2 = cosines[9];
  const Real c1 = cosines[10];
  const Real s2 = sines[9];
  const Real s1 = sines[10];
  const Real s3 = sines[8];
  const Real c5 = cosines[6];
  const Real s6 = sines[5];
  const Real s4 = sines[7];
  const Real s7 = sines[4];
  const Real c8 = cosines[3];
  const Real s9 = sines[2];
  const Real s11 = sines[1];
  const Real c10 = cosines[11];
  const Real s10 = sines[11];
  const Real s13 = sines[0];
  const Real c12 = cosines[12];
  const Real s12 = sines[12];
  const Real s22 = sines[13];
  const Real c22 = cosines[13];
  const Real c24 = cosines[14];
  const Real c23 = cosines[15];
  const Real s24 = sines[14];
  const Real s23 = sines[15];
  const Real c21 = cosines[16];
  const Real s21 = sines[16];
  const Real s19 = sines[17];
  const Real c19 = cosines[17];
  const Real s20 = sines[18];
  const Real c20 = cosines[18];
  const Real s18 = sines[19];
  const Real c18 = cosines[19];
  const Real s17 = sines[20];
  const Real c17 = cosines[20];
  const Real c16 = cosines[21];
  const Real s16 = sines[21];
  const Real s15 = sines[22];
  const Real c15 = cosines[22];
  const Real c14 = cosines[23];
  const Real s14 = sines[23];

  // link 13 (left_hand), articulated inertia
  const Real Lambda_0_11_p1 = 0.0002628975791811551 * c13 - 0.0007660844555829042 * s13;
  const Real Lambda_0_11_p2 = c13 * Lambda_0_11_p1 - 0.00013384878959057754;
  const Real inverse_D12_p1 = s13 * Lambda_0_11_p1;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D12 = 1.0 / (0.0010519177038056625 + inverse_D12_p1);
  const Real Lambda_0_11_p3 = Lambda_0_11_p2 * inverse_D12;
  const Real Lambda_0_11_p4 = 0.0002742332482227584 - inverse_D12_p1 - Lambda_0_11_p2 *
      Lambda_0_11_p3;
  const Real Lambda_0_11_p5 = s12 * (1.16e-05 - Lambda_0_11_p4);

  // link 13 (left_hand), articulated inertia
  const Real Lambda_0_11_p6 = 0.001090468517736955 * s13 + 0.001742099791326752 * c13;
  const Real Lambda_0_11_p7 = s13 * Lambda_0_11_p6;
  const Real Lambda_0_11_p8 = Lambda_0_11_p7 - 0.000760024621759417;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_0_11_p9 = Lambda_0_11_p8 * inverse_D12;

  // link 13 (left_hand), articulated inertia
  const Real Lambda_0_11_p10 = c13 * Lambda_0_11_p6;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_0_11_p11 = Lambda_0_11_p10 - 0.002376125662528793 - Lambda_0_11_p2 *
      Lambda_0_11_p9;
  const Real Lambda_0_11_p12 = 0.0006000000000000001 * s12 + c12 * Lambda_0_11_p11;
  const Real Lambda_0_11_p13 = 0.000144 - (c12 * Lambda_0_11_p5 + 0.269 * Lambda_0_11_p12);
  const Real inverse_D11_p1 = s12 * Lambda_0_11_p5;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D11 = 1.0 / (0.00022920000000000001 + (Lambda_0_11_p4 + inverse_D11_p1));
  const Real Lambda_0_11_p14 = Lambda_0_11_p13 * inverse_D11;

  // link 13 (left_hand), articulated inertia
  const Real Lambda_0_11_p15 = 0.27310176737964387 * s13 - 0.09929187165525127 * c13;
  const Real Lambda_0_11_p16 = s13 * Lambda_0_11_p15;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_0_11_p17 = Lambda_0_11_p16 - 0.2818466605750157 - Lambda_0_11_p8 *
      Lambda_0_11_p9;
  const Real Lambda_0_11_p18 = s12 * Lambda_0_11_p11 - 0.0006000000000000001 * c12;
  const Real Lambda_0_11_p19 = 0.269 * Lambda_0_11_p17 - Lambda_0_11_p18;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p20 = 0.000131 - inverse_D11_p1 + 0.269 *
      (Lambda_0_11_p19 - Lambda_0_11_p18) - Lambda_0_11_p13 * Lambda_0_11_p14;

  // link 13 (left_hand), articulated inertia
  const Real Lambda_0_11_p21 = 0.0006340258712020409 + Lambda_0_11_p10;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_0_11_p22 = Lambda_0_11_p21 * inverse_D12;
  const Real Lambda_0_11_p23 = 0.00033044389597753786 - Lambda_0_11_p7 - Lambda_0_11_p2 *
      Lambda_0_11_p22;

  // link 13 (left_hand), articulated inertia
  const Real Lambda_0_11_p24 = 0.0006000000000000001 + (0.002865001425 * s13 + 0.01626499875 * c13);

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_0_11_p25 = Lambda_0_11_p24 * inverse_D12;
  const Real Lambda_0_11_p26 = 0.01626499875 * s13 - 0.002865001425 * c13 + Lambda_0_11_p2 *
      Lambda_0_11_p25;
  const Real Lambda_0_11_p27 = s12 * Lambda_0_11_p23 - c12 * Lambda_0_11_p26;
  const Real Lambda_0_11_p28 = c12 * Lambda_0_11_p27;
  const Real Lambda_0_11_p29 = 0.0002516 - 0.269 * Lambda_0_11_p28;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p30 = Lambda_0_11_p29 * inverse_D11;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_0_11_p31 = 0.008744893195371809 + Lambda_0_11_p16 + Lambda_0_11_p21 *
      Lambda_0_11_p22;
  const Real Lambda_0_11_p32 = Lambda_0_11_p24 * Lambda_0_11_p25;
  const Real Lambda_0_11_p33 = Lambda_0_11_p24 * Lambda_0_11_p22;
  const Real Lambda_0_11_p34 = s12 * (Lambda_0_11_p31 - Lambda_0_11_p32) + c12 *
      (2.0 * Lambda_0_11_p33);
  const Real Lambda_0_11_p35 = s12 * Lambda_0_11_p34;
  const Real Lambda_0_11_p36 = Lambda_0_11_p32 + Lambda_0_11_p35;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p37 = 0.0001098 - 0.07236100000000001 * Lambda_0_11_p36 - Lambda_0_11_p29 *
      Lambda_0_11_p30;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_0_11_p38 = s12 * Lambda_0_11_p27;
  const Real Lambda_0_11_p39 = 0.04964593582762564 + c13 * Lambda_0_11_p15 - Lambda_0_11_p21 *
      Lambda_0_11_p9;
  const Real Lambda_0_11_p40 = Lambda_0_11_p24 * Lambda_0_11_p9;
  const Real Lambda_0_11_p41 = s12 * Lambda_0_11_p39 - c12 * Lambda_0_11_p40;
  const Real Lambda_0_11_p42 = 0.269 * Lambda_0_11_p41;
  const Real Lambda_0_11_p43 = Lambda_0_11_p38 - Lambda_0_11_p42;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p44 = 6e-06 + 0.269 * Lambda_0_11_p43 + Lambda_0_11_p13 * Lambda_0_11_p30;
  const Real Lambda_0_11_p45 = 2.0 * c11;
  const Real Lambda_0_11_p46 = s11 * (Lambda_0_11_p20 - Lambda_0_11_p37) - Lambda_0_11_p45 *
      Lambda_0_11_p44;
  const Real Lambda_0_11_p47 = c11 * Lambda_0_11_p46 + Lambda_0_11_p44 - 2.249994685315e-05;
  const Real inverse_D10_p1 = s11 * Lambda_0_11_p46;
  const Real inverse_D10_p2 = 0.060888541114265754 + (Lambda_0_11_p37 + inverse_D10_p1);

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D10 = 1.0 / inverse_D10_p2;
  const Real Lambda_0_11_p48 = Lambda_0_11_p47 * inverse_D10;
  const Real Lambda_0_11_p49 = 0.06060754126741261 + (Lambda_0_11_p20 - inverse_D10_p1) -
      Lambda_0_11_p47 * Lambda_0_11_p48;
  const Real Lambda_0_11_p50 = 0.00028099984685315 - 2.249996661190239e-08 / inverse_D10_p2;
  const Real Lambda_0_11_p51 = 0.0001499998887063 / inverse_D10_p2;
  const Real Lambda_0_11_p52 = Lambda_0_11_p47 * Lambda_0_11_p51 - 0.0001499998887063;
  const Real Lambda_0_11_p53 = 2.0 * c10;
  const Real Lambda_0_11_p54 = s10 * (Lambda_0_11_p49 - Lambda_0_11_p50) + Lambda_0_11_p53 *
      Lambda_0_11_p52;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_0_11_p55 = Lambda_0_11_p28 - 0.001;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p56 = Lambda_0_11_p55 * inverse_D11;
  const Real Lambda_0_11_p57 = Lambda_0_11_p43 - Lambda_0_11_p13 * Lambda_0_11_p56;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_0_11_p58 = 6e-04 - Lambda_0_11_p12;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p59 = Lambda_0_11_p58 * inverse_D11;
  const Real Lambda_0_11_p60 = Lambda_0_11_p42 - Lambda_0_11_p29 * Lambda_0_11_p59;
  const Real Lambda_0_11_p61 = 0.269 * Lambda_0_11_p36 - Lambda_0_11_p29 * Lambda_0_11_p56;
  const Real Lambda_0_11_p62 = Lambda_0_11_p19 - Lambda_0_11_p13 * Lambda_0_11_p59;
  const Real Lambda_0_11_p63 = s11 * (Lambda_0_11_p57 - Lambda_0_11_p60) + c11 *
      (Lambda_0_11_p61 + Lambda_0_11_p62);
  const Real Lambda_0_11_p64 = s11 * Lambda_0_11_p63;
  const Real Lambda_0_11_p65 = Lambda_0_11_p60 + Lambda_0_11_p64;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p66 = Lambda_0_11_p65 * inverse_D10;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p67 = c11 * Lambda_0_11_p63;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p68 = 0.28049749700000004 + (Lambda_0_11_p67 - Lambda_0_11_p61) -
      Lambda_0_11_p47 * Lambda_0_11_p66;
  const Real Lambda_0_11_p69 = 0.0001499998887063 * Lambda_0_11_p66 - 0.0014999985000000002;
  const Real Lambda_0_11_p70 = s10 * Lambda_0_11_p68 + c10 * Lambda_0_11_p69;
  const Real Lambda_0_11_p71 = 0.0005895000784280001 +
      (c10 * Lambda_0_11_p54 - Lambda_0_11_p52 + 0.282 * Lambda_0_11_p70);

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p72 = Lambda_0_11_p67 - Lambda_0_11_p62 - 0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p73 = Lambda_0_11_p72 * inverse_D10;
  const Real Lambda_0_11_p74 = 0.0001499998887063 * Lambda_0_11_p73;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_0_11_p75 = s12 * Lambda_0_11_p40 + c12 * Lambda_0_11_p39;
  const Real Lambda_0_11_p76 = Lambda_0_11_p23 - Lambda_0_11_p38;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p77 = Lambda_0_11_p76 * inverse_D11;
  const Real Lambda_0_11_p78 = 0.001 + (Lambda_0_11_p28 + Lambda_0_11_p26 - 0.269 *
      Lambda_0_11_p75) - Lambda_0_11_p13 * Lambda_0_11_p77;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_0_11_p79 = c12 * Lambda_0_11_p34 - Lambda_0_11_p33;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p80 = 0.269 * Lambda_0_11_p79 - 6e-04 - Lambda_0_11_p29 * Lambda_0_11_p77;
  const Real Lambda_0_11_p81 = 0.0014999985000000002 -
      (s11 * Lambda_0_11_p78 + c11 * Lambda_0_11_p80);

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p82 = Lambda_0_11_p81 * inverse_D10;
  const Real Lambda_0_11_p83 = c11 * Lambda_0_11_p78 - s11 * Lambda_0_11_p80 + Lambda_0_11_p47 *
      Lambda_0_11_p82;
  const Real Lambda_0_11_p84 = Lambda_0_11_p57 - Lambda_0_11_p64 - Lambda_0_11_p47 *
      Lambda_0_11_p73;
  const Real Lambda_0_11_p85 = 0.0001499998887063 * Lambda_0_11_p82;
  const Real Lambda_0_11_p86 = s10 * (Lambda_0_11_p84 - Lambda_0_11_p85) + c10 *
      (Lambda_0_11_p74 - Lambda_0_11_p83);
  const Real Lambda_0_11_p87 = c10 * Lambda_0_11_p86;
  const Real Lambda_0_11_p88 = Lambda_0_11_p87 + Lambda_0_11_p83;
  const Real Lambda_0_11_p89 = 0.004500002325 + Lambda_0_11_p88;
  const Real inverse_D9_p1 = s10 * Lambda_0_11_p54;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D9 = 1.0 / (0.0027762933559338653 + (Lambda_0_11_p50 + inverse_D9_p1));
  const Real Lambda_0_11_p90 = Lambda_0_11_p89 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p91 = s10 * Lambda_0_11_p86;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p92 = Lambda_0_11_p79 + Lambda_0_11_p55 * Lambda_0_11_p77;
  const Real Lambda_0_11_p93 = Lambda_0_11_p75 + Lambda_0_11_p58 * Lambda_0_11_p77;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p94 = s11 * Lambda_0_11_p92 + c11 * Lambda_0_11_p93 - Lambda_0_11_p81 *
      Lambda_0_11_p66;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p95 = Lambda_0_11_p36 + Lambda_0_11_p55 * Lambda_0_11_p56;
  const Real Lambda_0_11_p96 = Lambda_0_11_p17 - Lambda_0_11_p58 * Lambda_0_11_p59;
  const Real Lambda_0_11_p97 = Lambda_0_11_p41 + Lambda_0_11_p55 * Lambda_0_11_p59;
  const Real Lambda_0_11_p98 = s11 * (Lambda_0_11_p95 + Lambda_0_11_p96) + Lambda_0_11_p45 *
      Lambda_0_11_p97;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p99 = Lambda_0_11_p97 - c11 * Lambda_0_11_p98 - Lambda_0_11_p72 *
      Lambda_0_11_p66;
  const Real Lambda_0_11_p100 = s10 * Lambda_0_11_p94 - c10 * Lambda_0_11_p99;
  const Real Lambda_0_11_p101 = 0.282 * Lambda_0_11_p100;
  const Real Lambda_0_11_p102 = Lambda_0_11_p84 - Lambda_0_11_p91 - Lambda_0_11_p101;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p103 = Lambda_0_11_p102 - Lambda_0_11_p71 * Lambda_0_11_p90;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p104 = 0.0022500062 + Lambda_0_11_p70;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p105 = Lambda_0_11_p104 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p106 = 0.0012089992423205001 + 0.282 * Lambda_0_11_p88;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p107 = Lambda_0_11_p101 + Lambda_0_11_p106 * Lambda_0_11_p105;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p108 = s10 * Lambda_0_11_p69 - c10 * Lambda_0_11_p68;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_0_11_p109 = s11 * Lambda_0_11_p98;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p110 = Lambda_0_11_p96 - Lambda_0_11_p109 - Lambda_0_11_p65 *
      Lambda_0_11_p66;
  const Real Lambda_0_11_p111 = 0.282 * Lambda_0_11_p110 - Lambda_0_11_p108;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p112 = Lambda_0_11_p111 - Lambda_0_11_p71 * Lambda_0_11_p105;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p113 = s11 * Lambda_0_11_p93 - c11 * Lambda_0_11_p92 + Lambda_0_11_p72 *
      Lambda_0_11_p82;
  const Real Lambda_0_11_p114 = Lambda_0_11_p109 - Lambda_0_11_p95 - Lambda_0_11_p72 *
      Lambda_0_11_p73;
  const Real Lambda_0_11_p115 = Lambda_0_11_p35 - Lambda_0_11_p31 - Lambda_0_11_p76 *
      Lambda_0_11_p77 - Lambda_0_11_p81 * Lambda_0_11_p82;
  const Real Lambda_0_11_p116 = Lambda_0_11_p53 * Lambda_0_11_p113 - s10 *
      (Lambda_0_11_p114 - Lambda_0_11_p115);
  const Real Lambda_0_11_p117 = s10 * Lambda_0_11_p116;
  const Real Lambda_0_11_p118 = Lambda_0_11_p114 + Lambda_0_11_p117;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p119 = Lambda_0_11_p106 * Lambda_0_11_p90 - 0.282 * Lambda_0_11_p118;
  const Real Lambda_0_11_p120 = c9 * (Lambda_0_11_p103 - Lambda_0_11_p107) - s9 *
      (Lambda_0_11_p119 + Lambda_0_11_p112);
  const Real Lambda_0_11_p121 = c9 * Lambda_0_11_p120;
  const Real Lambda_0_11_p122 = Lambda_0_11_p107 + Lambda_0_11_p121;
  const Real inverse_D8_p1 = Lambda_0_11_p71 * inverse_D9;
  const Real inverse_D8_p2 = 0.0019585440854647937 +
      (Lambda_0_11_p49 - inverse_D9_p1 + 0.282 * (Lambda_0_11_p111 - Lambda_0_11_p108)) -
      Lambda_0_11_p71 * inverse_D8_p1;
  const Real inverse_D8_p3 = Lambda_0_11_p106 * inverse_D9;
  const Real inverse_D8_p4 = 0.0008177492704690715 + 0.07952399999999998 * Lambda_0_11_p118 -
      Lambda_0_11_p106 * inverse_D8_p3;
  const Real inverse_D8_p5 = 4.4999986458742003e-05 - 0.282 * Lambda_0_11_p102 + Lambda_0_11_p71 *
      inverse_D8_p3;
  const Real inverse_D8_p6 = 2.0 * s9;
  const Real inverse_D8_p7 = c9 * (inverse_D8_p2 - inverse_D8_p4) - inverse_D8_p6 * inverse_D8_p5;
  const Real inverse_D8_p8 = c9 * inverse_D8_p7;
  const Real inverse_D8_p9 = 0.18125194219699997 + (inverse_D8_p4 + inverse_D8_p8);

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D8 = 1.0 / inverse_D8_p9;
  const Real Lambda_0_11_p123 = Lambda_0_11_p122 * inverse_D8;
  const Real Lambda_0_11_p124 = 0.0017499999999999998 + 0.00010499999999999999 * Lambda_0_11_p123;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p125 = s9 * inverse_D8_p7 + inverse_D8_p5 - 1.75e-05;
  const Real Lambda_0_11_p126 = s9 * Lambda_0_11_p120;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_0_11_p127 = Lambda_0_11_p126 + Lambda_0_11_p119 - 0.7139200499999999 -
      Lambda_0_11_p125 * Lambda_0_11_p123;
  const Real Lambda_0_11_p128 = 0.0017499999999999998 +
      (s8 * Lambda_0_11_p124 + c8 * Lambda_0_11_p127);
  const Real inverse_D7_p1 = Lambda_0_11_p125 * inverse_D8;
  const Real inverse_D7_p2 = 0.18113119219699997 + (inverse_D8_p2 - inverse_D8_p8) -
      Lambda_0_11_p125 * inverse_D7_p1;
  const Real inverse_D7_p3 = 0.00012075 - 1.1024999999999998e-08 / inverse_D8_p9;
  const Real inverse_D7_p4 = 0.00010499999999999999 * inverse_D7_p1 - 5.2499999999999995e-05;
  const Real inverse_D7_p5 = 2.0 * c8;
  const Real inverse_D7_p6 = s8 * (inverse_D7_p3 - inverse_D7_p2) + inverse_D7_p5 * inverse_D7_p4;
  const Real inverse_D7_p7 = s8 * inverse_D7_p6;
  const Real inverse_D7_p8 = 0.000448 + (inverse_D7_p2 + inverse_D7_p7);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D7 = 1.0 / inverse_D7_p8;
  const Real Lambda_0_11_p129 = Lambda_0_11_p128 * inverse_D7;
  const Real Lambda_0_11_p130 = 2.6249999999999998e-05 * Lambda_0_11_p129;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p131 = Lambda_0_11_p85 + Lambda_0_11_p91;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p132 = Lambda_0_11_p131 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p133 = s10 * Lambda_0_11_p99 + c10 * Lambda_0_11_p94;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p134 = 0.004500002325 - (Lambda_0_11_p87 - Lambda_0_11_p74 + 0.282 *
      Lambda_0_11_p133) + Lambda_0_11_p71 * Lambda_0_11_p132;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_0_11_p135 = Lambda_0_11_p113 - c10 * Lambda_0_11_p116;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p136 = 0.0022500062 + 0.282 * Lambda_0_11_p135 - Lambda_0_11_p106 *
      Lambda_0_11_p132;
  const Real Lambda_0_11_p137 = 0.0017499999999999998 +
      (c9 * Lambda_0_11_p134 - s9 * Lambda_0_11_p136);

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_0_11_p138 = Lambda_0_11_p137 * inverse_D8;
  const Real Lambda_0_11_p139 = Lambda_0_11_p125 * Lambda_0_11_p138 -
      (s9 * Lambda_0_11_p134 + c9 * Lambda_0_11_p136);

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p140 = 0.7139200499999999 + (Lambda_0_11_p126 + Lambda_0_11_p112);

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_0_11_p141 = Lambda_0_11_p140 * inverse_D8;
  const Real Lambda_0_11_p142 = 0.00010499999999999999 * Lambda_0_11_p141;
  const Real Lambda_0_11_p143 = Lambda_0_11_p103 - Lambda_0_11_p121 - Lambda_0_11_p125 *
      Lambda_0_11_p141;
  const Real Lambda_0_11_p144 = 0.00010499999999999999 * Lambda_0_11_p138;
  const Real Lambda_0_11_p145 = c8 * (Lambda_0_11_p139 + Lambda_0_11_p142) - s8 *
      (Lambda_0_11_p144 + Lambda_0_11_p143);
  const Real Lambda_0_11_p146 = c8 * Lambda_0_11_p145;
  const Real Lambda_0_11_p147 = 0.0017499999999999998 + (Lambda_0_11_p146 - Lambda_0_11_p142);

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p148 = Lambda_0_11_p147 * inverse_D7;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_0_11_p149 = c8 * inverse_D7_p6 - inverse_D7_p4 - 2.6249999999999998e-05;
  const Real Lambda_0_11_p150 = s8 * Lambda_0_11_p145;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p151 = Lambda_0_11_p144 + Lambda_0_11_p150 + Lambda_0_11_p149 *
      Lambda_0_11_p148;
  const Real Lambda_0_11_p152 = c8 * Lambda_0_11_p124 - s8 * Lambda_0_11_p127 - Lambda_0_11_p149 *
      Lambda_0_11_p129;
  const Real Lambda_0_11_p153 = 2.6249999999999998e-05 * Lambda_0_11_p148;
  const Real Lambda_0_11_p154 = c7 * (Lambda_0_11_p130 + Lambda_0_11_p151) - s7 *
      (Lambda_0_11_p152 + Lambda_0_11_p153);
  const Real Lambda_0_11_p155 = s7 * Lambda_0_11_p154;
  const Real Lambda_0_11_p156 = Lambda_0_11_p155 + Lambda_0_11_p153;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p157 = Lambda_0_11_p118 - Lambda_0_11_p89 * Lambda_0_11_p90;
  const Real Lambda_0_11_p158 = Lambda_0_11_p110 - Lambda_0_11_p104 * Lambda_0_11_p105;
  const Real Lambda_0_11_p159 = Lambda_0_11_p100 + Lambda_0_11_p89 * Lambda_0_11_p105;
  const Real Lambda_0_11_p160 = c9 * (Lambda_0_11_p157 - Lambda_0_11_p158) + inverse_D8_p6 *
      Lambda_0_11_p159;
  const Real Lambda_0_11_p161 = c9 * Lambda_0_11_p160;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p162 = Lambda_0_11_p158 + Lambda_0_11_p161 - Lambda_0_11_p122 *
      Lambda_0_11_p123 - Lambda_0_11_p128 * Lambda_0_11_p129;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_0_11_p163 = Lambda_0_11_p157 - Lambda_0_11_p161 - Lambda_0_11_p140 *
      Lambda_0_11_p141;
  const Real Lambda_0_11_p164 = Lambda_0_11_p115 - Lambda_0_11_p117 - Lambda_0_11_p131 *
      Lambda_0_11_p132 - Lambda_0_11_p137 * Lambda_0_11_p138;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_0_11_p165 = Lambda_0_11_p89 * Lambda_0_11_p132 - Lambda_0_11_p135;
  const Real Lambda_0_11_p166 = Lambda_0_11_p104 * Lambda_0_11_p132 - Lambda_0_11_p133;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_0_11_p167 = Lambda_0_11_p137 * Lambda_0_11_p141 -
      (s9 * Lambda_0_11_p165 + c9 * Lambda_0_11_p166);
  const Real Lambda_0_11_p168 = s8 * (Lambda_0_11_p164 - Lambda_0_11_p163) + inverse_D7_p5 *
      Lambda_0_11_p167;
  const Real Lambda_0_11_p169 = s8 * Lambda_0_11_p168;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p170 = Lambda_0_11_p164 - Lambda_0_11_p169 - Lambda_0_11_p147 *
      Lambda_0_11_p148;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_0_11_p171 = Lambda_0_11_p137 * Lambda_0_11_p123 -
      (c9 * Lambda_0_11_p165 - s9 * Lambda_0_11_p166);
  const Real Lambda_0_11_p172 = Lambda_0_11_p159 - s9 * Lambda_0_11_p160 + Lambda_0_11_p140 *
      Lambda_0_11_p123;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p173 = c8 * Lambda_0_11_p171 + s8 * Lambda_0_11_p172 - Lambda_0_11_p128 *
      Lambda_0_11_p148;
  const Real Lambda_0_11_p174 = 2.0 * s7;
  const Real Lambda_0_11_p175 = c7 * (Lambda_0_11_p162 - Lambda_0_11_p170) - Lambda_0_11_p174 *
      Lambda_0_11_p173;
  const Real Lambda_0_11_p176 = c7 * Lambda_0_11_p175;
  const Real Lambda_0_11_p177 = Lambda_0_11_p162 - Lambda_0_11_p176;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_0_11_p178 = Lambda_0_11_p143 + Lambda_0_11_p150;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p179 = Lambda_0_11_p178 * inverse_D7;
  const Real Lambda_0_11_p180 = s8 * Lambda_0_11_p171 - c8 * Lambda_0_11_p172 - Lambda_0_11_p128 *
      Lambda_0_11_p179;
  const Real Lambda_0_11_p181 = c8 * Lambda_0_11_p168 - Lambda_0_11_p167 - Lambda_0_11_p147 *
      Lambda_0_11_p179;
  const Real Lambda_0_11_p182 = s7 * Lambda_0_11_p180 + c7 * Lambda_0_11_p181;
  const Real Lambda_0_11_p183 = Lambda_0_11_p156 - (0.18 * Lambda_0_11_p177 + 0.226 *
      Lambda_0_11_p182);

  // link 20 (right_hand), articulated inertia
  const Real Lambda_0_11_p184 = 0.0007660844555829042 * s20 + 0.0002628975791811551 * c20;
  const Real Lambda_0_11_p185 = 0.00013384878959057754 - c20 * Lambda_0_11_p184;
  const Real inverse_D19_p1 = s20 * Lambda_0_11_p184;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D19 = 1.0 / (0.0010519177038056625 - inverse_D19_p1);
  const Real Lambda_0_11_p186 = Lambda_0_11_p185 * inverse_D19;
  const Real Lambda_0_11_p187 = 0.0002742332482227584 + inverse_D19_p1 - Lambda_0_11_p185 *
      Lambda_0_11_p186;
  const Real Lambda_0_11_p188 = s19 * (1.16e-05 - Lambda_0_11_p187);

  // link 20 (right_hand), articulated inertia
  const Real Lambda_0_11_p189 = 0.001742099791326752 * c20 - 0.001090468517736955 * s20;
  const Real Lambda_0_11_p190 = s20 * Lambda_0_11_p189;
  const Real Lambda_0_11_p191 = 0.000760024621759417 + Lambda_0_11_p190;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_0_11_p192 = Lambda_0_11_p191 * inverse_D19;

  // link 20 (right_hand), articulated inertia
  const Real Lambda_0_11_p193 = c20 * Lambda_0_11_p189;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_0_11_p194 = Lambda_0_11_p193 - 0.002376125662528793 - Lambda_0_11_p185 *
      Lambda_0_11_p192;
  const Real Lambda_0_11_p195 = 0.0006000000000000001 * s19 + c19 * Lambda_0_11_p194;
  const Real Lambda_0_11_p196 = 0.000144 - (c19 * Lambda_0_11_p188 + 0.269 * Lambda_0_11_p195);
  const Real inverse_D18_p1 = s19 * Lambda_0_11_p188;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D18 = 1.0 / (0.00022920000000000001 + (Lambda_0_11_p187 + inverse_D18_p1));

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_0_11_p197 = 6e-04 - Lambda_0_11_p195;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p198 = Lambda_0_11_p197 * inverse_D18;

  // link 20 (right_hand), articulated inertia
  const Real Lambda_0_11_p199 = 0.27310176737964387 * s20 + 0.09929187165525127 * c20;
  const Real Lambda_0_11_p200 = s20 * Lambda_0_11_p199;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_0_11_p201 = Lambda_0_11_p200 - 0.2818466605750157 - Lambda_0_11_p191 *
      Lambda_0_11_p192;
  const Real Lambda_0_11_p202 = s19 * Lambda_0_11_p194 - 0.0006000000000000001 * c19;
  const Real Lambda_0_11_p203 = 0.269 * Lambda_0_11_p201 - Lambda_0_11_p202;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p204 = Lambda_0_11_p203 - Lambda_0_11_p196 * Lambda_0_11_p198;

  // link 20 (right_hand), articulated inertia
  const Real Lambda_0_11_p205 = 0.0006340258712020409 + Lambda_0_11_p193;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_0_11_p206 = Lambda_0_11_p205 * inverse_D19;
  const Real Lambda_0_11_p207 = 0.00033044389597753786 + Lambda_0_11_p190 + Lambda_0_11_p185 *
      Lambda_0_11_p206;

  // link 20 (right_hand), articulated inertia
  const Real Lambda_0_11_p208 = 0.002865001425 * s20 - 0.01626499875 * c20 - 0.0006000000000000001;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_0_11_p209 = Lambda_0_11_p208 * inverse_D19;
  const Real Lambda_0_11_p210 = 0.002865001425 * c20 + 0.01626499875 * s20 - Lambda_0_11_p185 *
      Lambda_0_11_p209;
  const Real Lambda_0_11_p211 = s19 * Lambda_0_11_p207 + c19 * Lambda_0_11_p210;
  const Real Lambda_0_11_p212 = c19 * Lambda_0_11_p211;
  const Real Lambda_0_11_p213 = 0.001 - Lambda_0_11_p212;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p214 = Lambda_0_11_p213 * inverse_D18;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_0_11_p215 = 0.269 * Lambda_0_11_p212 - 0.0002516;
  const Real Lambda_0_11_p216 = 0.008744893195371809 + Lambda_0_11_p200 + Lambda_0_11_p205 *
      Lambda_0_11_p206;
  const Real Lambda_0_11_p217 = Lambda_0_11_p208 * Lambda_0_11_p209;
  const Real Lambda_0_11_p218 = Lambda_0_11_p208 * Lambda_0_11_p206;
  const Real Lambda_0_11_p219 = c19 * (2.0 * Lambda_0_11_p218) - s19 *
      (Lambda_0_11_p216 - Lambda_0_11_p217);
  const Real Lambda_0_11_p220 = s19 * Lambda_0_11_p219;
  const Real Lambda_0_11_p221 = Lambda_0_11_p220 - Lambda_0_11_p217;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p222 = 0.269 * Lambda_0_11_p221 + Lambda_0_11_p215 * Lambda_0_11_p214;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_0_11_p223 = s19 * Lambda_0_11_p211;
  const Real Lambda_0_11_p224 = Lambda_0_11_p208 * Lambda_0_11_p192;
  const Real Lambda_0_11_p225 = c20 * Lambda_0_11_p199 - 0.04964593582762564 - Lambda_0_11_p205 *
      Lambda_0_11_p192;
  const Real Lambda_0_11_p226 = c19 * Lambda_0_11_p224 + s19 * Lambda_0_11_p225;
  const Real Lambda_0_11_p227 = 0.269 * Lambda_0_11_p226;
  const Real Lambda_0_11_p228 = Lambda_0_11_p223 + Lambda_0_11_p227;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p229 = Lambda_0_11_p228 + Lambda_0_11_p196 * Lambda_0_11_p214;
  const Real Lambda_0_11_p230 = Lambda_0_11_p227 - Lambda_0_11_p215 * Lambda_0_11_p198;
  const Real Lambda_0_11_p231 = c18 * (Lambda_0_11_p204 - Lambda_0_11_p222) - s18 *
      (Lambda_0_11_p229 + Lambda_0_11_p230);
  const Real Lambda_0_11_p232 = s18 * Lambda_0_11_p231;
  const Real Lambda_0_11_p233 = Lambda_0_11_p230 + Lambda_0_11_p232;
  const Real inverse_D17_p1 = Lambda_0_11_p196 * inverse_D18;
  const Real inverse_D17_p2 = 0.000131 - inverse_D18_p1 + 0.269 *
      (Lambda_0_11_p203 - Lambda_0_11_p202) - Lambda_0_11_p196 * inverse_D17_p1;
  const Real inverse_D17_p3 = Lambda_0_11_p215 * inverse_D18;
  const Real inverse_D17_p4 = 0.0001098 + 0.07236100000000001 * Lambda_0_11_p221 -
      Lambda_0_11_p215 * inverse_D17_p3;
  const Real inverse_D17_p5 = 6e-06 + 0.269 * Lambda_0_11_p228 - Lambda_0_11_p196 * inverse_D17_p3;
  const Real inverse_D17_p6 = 2.0 * c18;
  const Real inverse_D17_p7 = s18 * (inverse_D17_p2 - inverse_D17_p4) + inverse_D17_p6 *
      inverse_D17_p5;
  const Real inverse_D17_p8 = s18 * inverse_D17_p7;
  const Real inverse_D17_p9 = 0.060888541114265754 + (inverse_D17_p4 + inverse_D17_p8);

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D17 = 1.0 / inverse_D17_p9;
  const Real Lambda_0_11_p234 = Lambda_0_11_p233 * inverse_D17;
  const Real Lambda_0_11_p235 = 0.0014999985000000002 + 0.0001499998887063 * Lambda_0_11_p234;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p236 = 2.249994685315e-05 + (c18 * inverse_D17_p7 - inverse_D17_p5);
  const Real Lambda_0_11_p237 = c18 * Lambda_0_11_p231;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p238 = 0.28049749700000004 + (Lambda_0_11_p237 + Lambda_0_11_p222) -
      Lambda_0_11_p236 * Lambda_0_11_p234;
  const Real Lambda_0_11_p239 = c17 * Lambda_0_11_p235 - s17 * Lambda_0_11_p238;
  const Real Lambda_0_11_p240 = 0.0001499998887063 / inverse_D17_p9;
  const Real Lambda_0_11_p241 = 0.0001499998887063 + Lambda_0_11_p236 * Lambda_0_11_p240;
  const Real Lambda_0_11_p242 = 2.0 * c17;
  const Real Lambda_0_11_p243 = Lambda_0_11_p236 * inverse_D17;
  const Real Lambda_0_11_p244 = 0.06060754126741261 + (inverse_D17_p2 - inverse_D17_p8) -
      Lambda_0_11_p236 * Lambda_0_11_p243;
  const Real Lambda_0_11_p245 = 0.00028099984685315 - 2.249996661190239e-08 / inverse_D17_p9;
  const Real Lambda_0_11_p246 = Lambda_0_11_p242 * Lambda_0_11_p241 - s17 *
      (Lambda_0_11_p244 - Lambda_0_11_p245);
  const Real Lambda_0_11_p247 = 0.282 * Lambda_0_11_p239 -
      (Lambda_0_11_p241 - c17 * Lambda_0_11_p246) - 0.0005895000784280001;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p248 = Lambda_0_11_p237 - Lambda_0_11_p204 - 0.28049749700000004;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p249 = Lambda_0_11_p248 * inverse_D17;
  const Real Lambda_0_11_p250 = 0.0001499998887063 * Lambda_0_11_p249;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_0_11_p251 = s19 * Lambda_0_11_p224 - c19 * Lambda_0_11_p225;
  const Real Lambda_0_11_p252 = Lambda_0_11_p223 - Lambda_0_11_p207;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p253 = Lambda_0_11_p252 * inverse_D18;
  const Real Lambda_0_11_p254 = 0.269 * Lambda_0_11_p251 - (Lambda_0_11_p212 - Lambda_0_11_p210) -
      0.001 - Lambda_0_11_p196 * Lambda_0_11_p253;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_0_11_p255 = Lambda_0_11_p218 - c19 * Lambda_0_11_p219;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p256 = 0.269 * Lambda_0_11_p255 - 6e-04 - Lambda_0_11_p215 *
      Lambda_0_11_p253;
  const Real Lambda_0_11_p257 = 0.0014999985000000002 -
      (s18 * Lambda_0_11_p254 + c18 * Lambda_0_11_p256);

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p258 = Lambda_0_11_p257 * inverse_D17;
  const Real Lambda_0_11_p259 = c18 * Lambda_0_11_p254 - s18 * Lambda_0_11_p256 + Lambda_0_11_p236 *
      Lambda_0_11_p258;
  const Real Lambda_0_11_p260 = Lambda_0_11_p229 + Lambda_0_11_p232 + Lambda_0_11_p236 *
      Lambda_0_11_p249;
  const Real Lambda_0_11_p261 = 0.0001499998887063 * Lambda_0_11_p258;
  const Real Lambda_0_11_p262 = c17 * (Lambda_0_11_p250 + Lambda_0_11_p259) - s17 *
      (Lambda_0_11_p261 - Lambda_0_11_p260);
  const Real Lambda_0_11_p263 = c17 * Lambda_0_11_p262;
  const Real Lambda_0_11_p264 = Lambda_0_11_p259 - Lambda_0_11_p263;
  const Real Lambda_0_11_p265 = 0.004500002325 - Lambda_0_11_p264;
  const Real inverse_D16_p1 = s17 * Lambda_0_11_p246;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D16 = 1.0 / (0.0027762933559338653 + (Lambda_0_11_p245 - inverse_D16_p1));
  const Real Lambda_0_11_p266 = Lambda_0_11_p265 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p267 = s17 * Lambda_0_11_p262;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p268 = Lambda_0_11_p221 - Lambda_0_11_p213 * Lambda_0_11_p214;
  const Real Lambda_0_11_p269 = Lambda_0_11_p201 - Lambda_0_11_p197 * Lambda_0_11_p198;
  const Real Lambda_0_11_p270 = Lambda_0_11_p226 + Lambda_0_11_p213 * Lambda_0_11_p198;
  const Real Lambda_0_11_p271 = s18 * (Lambda_0_11_p268 - Lambda_0_11_p269) - inverse_D17_p6 *
      Lambda_0_11_p270;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p272 = c18 * Lambda_0_11_p271 + Lambda_0_11_p270 - Lambda_0_11_p248 *
      Lambda_0_11_p234;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p273 = Lambda_0_11_p251 - Lambda_0_11_p197 * Lambda_0_11_p253;
  const Real Lambda_0_11_p274 = Lambda_0_11_p255 + Lambda_0_11_p213 * Lambda_0_11_p253;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p275 = c18 * Lambda_0_11_p273 - s18 * Lambda_0_11_p274 + Lambda_0_11_p257 *
      Lambda_0_11_p234;
  const Real Lambda_0_11_p276 = c17 * Lambda_0_11_p272 + s17 * Lambda_0_11_p275;
  const Real Lambda_0_11_p277 = 0.282 * Lambda_0_11_p276;
  const Real Lambda_0_11_p278 = Lambda_0_11_p267 - Lambda_0_11_p260 + Lambda_0_11_p277;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p279 = Lambda_0_11_p278 - Lambda_0_11_p247 * Lambda_0_11_p266;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p280 = Lambda_0_11_p239 - 0.0022500062;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p281 = Lambda_0_11_p280 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p282 = 0.282 * Lambda_0_11_p264 - 0.0012089992423205001;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p283 = Lambda_0_11_p277 + Lambda_0_11_p282 * Lambda_0_11_p281;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p284 = c17 * Lambda_0_11_p238 + s17 * Lambda_0_11_p235;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_0_11_p285 = s18 * Lambda_0_11_p271;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p286 = Lambda_0_11_p269 + Lambda_0_11_p285 - Lambda_0_11_p233 *
      Lambda_0_11_p234;
  const Real Lambda_0_11_p287 = Lambda_0_11_p284 + 0.282 * Lambda_0_11_p286;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p288 = Lambda_0_11_p287 - Lambda_0_11_p247 * Lambda_0_11_p281;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p289 = Lambda_0_11_p268 - Lambda_0_11_p285 - Lambda_0_11_p248 *
      Lambda_0_11_p249;
  const Real Lambda_0_11_p290 = Lambda_0_11_p216 + Lambda_0_11_p220 + Lambda_0_11_p252 *
      Lambda_0_11_p253 + Lambda_0_11_p257 * Lambda_0_11_p258;
  const Real Lambda_0_11_p291 = c18 * Lambda_0_11_p274 + s18 * Lambda_0_11_p273 - Lambda_0_11_p248 *
      Lambda_0_11_p258;
  const Real Lambda_0_11_p292 = s17 * (Lambda_0_11_p289 + Lambda_0_11_p290) + Lambda_0_11_p242 *
      Lambda_0_11_p291;
  const Real Lambda_0_11_p293 = s17 * Lambda_0_11_p292;
  const Real Lambda_0_11_p294 = Lambda_0_11_p289 - Lambda_0_11_p293;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p295 = 0.282 * Lambda_0_11_p294 + Lambda_0_11_p282 * Lambda_0_11_p266;
  const Real Lambda_0_11_p296 = c16 * (Lambda_0_11_p279 + Lambda_0_11_p283) - s16 *
      (Lambda_0_11_p288 - Lambda_0_11_p295);
  const Real Lambda_0_11_p297 = c16 * Lambda_0_11_p296;
  const Real Lambda_0_11_p298 = Lambda_0_11_p297 - Lambda_0_11_p283;
  const Real inverse_D15_p1 = Lambda_0_11_p247 * inverse_D16;
  const Real inverse_D15_p2 = 0.0019585440854647937 +
      (Lambda_0_11_p244 + inverse_D16_p1 + 0.282 * (Lambda_0_11_p284 + Lambda_0_11_p287)) -
      Lambda_0_11_p247 * inverse_D15_p1;
  const Real inverse_D15_p3 = Lambda_0_11_p282 * inverse_D16;
  const Real inverse_D15_p4 = 0.0008177492704690715 + 0.07952399999999998 * Lambda_0_11_p294 -
      Lambda_0_11_p282 * inverse_D15_p3;
  const Real inverse_D15_p5 = 4.4999986458742003e-05 + 0.282 * Lambda_0_11_p278 + Lambda_0_11_p247 *
      inverse_D15_p3;
  const Real inverse_D15_p6 = 2.0 * s16;
  const Real inverse_D15_p7 = c16 * (inverse_D15_p2 - inverse_D15_p4) + inverse_D15_p6 *
      inverse_D15_p5;
  const Real inverse_D15_p8 = c16 * inverse_D15_p7;
  const Real inverse_D15_p9 = 0.18125194219699997 + (inverse_D15_p4 + inverse_D15_p8);

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D15 = 1.0 / inverse_D15_p9;
  const Real Lambda_0_11_p299 = Lambda_0_11_p298 * inverse_D15;
  const Real Lambda_0_11_p300 = 0.00010499999999999999 * Lambda_0_11_p299 - 0.0017499999999999998;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p301 = 1.75e-05 - (inverse_D15_p5 - s16 * inverse_D15_p7);
  const Real Lambda_0_11_p302 = s16 * Lambda_0_11_p296;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_0_11_p303 = 0.7139200499999999 + (Lambda_0_11_p295 - Lambda_0_11_p302) +
      Lambda_0_11_p301 * Lambda_0_11_p299;
  const Real Lambda_0_11_p304 = 0.0017499999999999998 +
      (s15 * Lambda_0_11_p300 - c15 * Lambda_0_11_p303);
  const Real inverse_D14_p1 = Lambda_0_11_p301 * inverse_D15;
  const Real inverse_D14_p2 = 0.18113119219699997 + (inverse_D15_p2 - inverse_D15_p8) -
      Lambda_0_11_p301 * inverse_D14_p1;
  const Real inverse_D14_p3 = 0.00012075 - 1.1024999999999998e-08 / inverse_D15_p9;
  const Real inverse_D14_p4 = 5.2499999999999995e-05 + 0.00010499999999999999 * inverse_D14_p1;
  const Real inverse_D14_p5 = 2.0 * c15;
  const Real inverse_D14_p6 = s15 * (inverse_D14_p3 - inverse_D14_p2) + inverse_D14_p5 *
      inverse_D14_p4;
  const Real inverse_D14_p7 = s15 * inverse_D14_p6;
  const Real inverse_D14_p8 = 0.000448 + (inverse_D14_p2 + inverse_D14_p7);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D14 = 1.0 / inverse_D14_p8;
  const Real Lambda_0_11_p305 = Lambda_0_11_p304 * inverse_D14;
  const Real Lambda_0_11_p306 = 2.6249999999999998e-05 * Lambda_0_11_p305;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p307 = 0.7139200499999999 + (Lambda_0_11_p302 + Lambda_0_11_p288);

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_0_11_p308 = Lambda_0_11_p307 * inverse_D15;
  const Real Lambda_0_11_p309 = 0.00010499999999999999 * Lambda_0_11_p308;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p310 = Lambda_0_11_p261 + Lambda_0_11_p267;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p311 = Lambda_0_11_p310 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p312 = c17 * Lambda_0_11_p275 - s17 * Lambda_0_11_p272;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p313 = 0.282 * Lambda_0_11_p312 - (Lambda_0_11_p250 - Lambda_0_11_p263) -
      0.004500002325 + Lambda_0_11_p247 * Lambda_0_11_p311;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_0_11_p314 = c17 * Lambda_0_11_p292 - Lambda_0_11_p291;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p315 = 0.0022500062 + 0.282 * Lambda_0_11_p314 + Lambda_0_11_p282 *
      Lambda_0_11_p311;
  const Real Lambda_0_11_p316 = 0.0017499999999999998 -
      (c16 * Lambda_0_11_p313 - s16 * Lambda_0_11_p315);

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_0_11_p317 = Lambda_0_11_p316 * inverse_D15;
  const Real Lambda_0_11_p318 = s16 * Lambda_0_11_p313 + c16 * Lambda_0_11_p315 + Lambda_0_11_p301 *
      Lambda_0_11_p317;
  const Real Lambda_0_11_p319 = Lambda_0_11_p279 - Lambda_0_11_p297 - Lambda_0_11_p301 *
      Lambda_0_11_p308;
  const Real Lambda_0_11_p320 = 0.00010499999999999999 * Lambda_0_11_p317;
  const Real Lambda_0_11_p321 = s15 * (Lambda_0_11_p320 - Lambda_0_11_p319) + c15 *
      (Lambda_0_11_p309 - Lambda_0_11_p318);
  const Real Lambda_0_11_p322 = c15 * Lambda_0_11_p321;
  const Real Lambda_0_11_p323 = 0.0017499999999999998 + (Lambda_0_11_p322 - Lambda_0_11_p309);

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_0_11_p324 = Lambda_0_11_p323 * inverse_D14;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_0_11_p325 = 2.6249999999999998e-05 + (c15 * inverse_D14_p6 - inverse_D14_p4);
  const Real Lambda_0_11_p326 = s15 * Lambda_0_11_p321;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_0_11_p327 = Lambda_0_11_p320 - Lambda_0_11_p326 - Lambda_0_11_p325 *
      Lambda_0_11_p324;
  const Real Lambda_0_11_p328 = c15 * Lambda_0_11_p300 + s15 * Lambda_0_11_p303 - Lambda_0_11_p325 *
      Lambda_0_11_p305;
  const Real Lambda_0_11_p329 = 2.6249999999999998e-05 * Lambda_0_11_p324;
  const Real Lambda_0_11_p330 = c14 * (Lambda_0_11_p306 + Lambda_0_11_p327) + s14 *
      (Lambda_0_11_p328 - Lambda_0_11_p329);
  const Real Lambda_0_11_p331 = s14 * Lambda_0_11_p330;
  const Real Lambda_0_11_p332 = Lambda_0_11_p331 + Lambda_0_11_p329;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_0_11_p333 = Lambda_0_11_p319 + Lambda_0_11_p326;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_0_11_p334 = Lambda_0_11_p333 * inverse_D14;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p335 = Lambda_0_11_p294 - Lambda_0_11_p265 * Lambda_0_11_p266;
  const Real Lambda_0_11_p336 = Lambda_0_11_p286 - Lambda_0_11_p280 * Lambda_0_11_p281;
  const Real Lambda_0_11_p337 = Lambda_0_11_p276 - Lambda_0_11_p265 * Lambda_0_11_p281;
  const Real Lambda_0_11_p338 = c16 * (Lambda_0_11_p335 - Lambda_0_11_p336) - inverse_D15_p6 *
      Lambda_0_11_p337;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_0_11_p339 = s16 * Lambda_0_11_p338 + Lambda_0_11_p337 - Lambda_0_11_p307 *
      Lambda_0_11_p299;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p340 = Lambda_0_11_p265 * Lambda_0_11_p311 - Lambda_0_11_p314;
  const Real Lambda_0_11_p341 = Lambda_0_11_p312 + Lambda_0_11_p280 * Lambda_0_11_p311;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_0_11_p342 = c16 * Lambda_0_11_p340 - s16 * Lambda_0_11_p341 + Lambda_0_11_p316 *
      Lambda_0_11_p299;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_0_11_p343 = c15 * Lambda_0_11_p339 - s15 * Lambda_0_11_p342 - Lambda_0_11_p304 *
      Lambda_0_11_p334;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_0_11_p344 = c16 * Lambda_0_11_p338;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_0_11_p345 = Lambda_0_11_p335 - Lambda_0_11_p344 - Lambda_0_11_p307 *
      Lambda_0_11_p308;
  const Real Lambda_0_11_p346 = Lambda_0_11_p293 - Lambda_0_11_p290 - Lambda_0_11_p310 *
      Lambda_0_11_p311 - Lambda_0_11_p316 * Lambda_0_11_p317;
  const Real Lambda_0_11_p347 = s16 * Lambda_0_11_p340 + c16 * Lambda_0_11_p341 + Lambda_0_11_p316 *
      Lambda_0_11_p308;
  const Real Lambda_0_11_p348 = s15 * (Lambda_0_11_p346 - Lambda_0_11_p345) - inverse_D14_p5 *
      Lambda_0_11_p347;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_0_11_p349 = c15 * Lambda_0_11_p348 + Lambda_0_11_p347 - Lambda_0_11_p323 *
      Lambda_0_11_p334;
  const Real Lambda_0_11_p350 = s14 * Lambda_0_11_p343 + c14 * Lambda_0_11_p349;
  const Real Lambda_0_11_p351 = Lambda_0_11_p336 + Lambda_0_11_p344 - Lambda_0_11_p298 *
      Lambda_0_11_p299 - Lambda_0_11_p304 * Lambda_0_11_p305;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_0_11_p352 = s15 * Lambda_0_11_p348;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_0_11_p353 = Lambda_0_11_p346 - Lambda_0_11_p352 - Lambda_0_11_p323 *
      Lambda_0_11_p324;
  const Real Lambda_0_11_p354 = c15 * Lambda_0_11_p342 + s15 * Lambda_0_11_p339 + Lambda_0_11_p304 *
      Lambda_0_11_p324;
  const Real Lambda_0_11_p355 = 2.0 * s14;
  const Real Lambda_0_11_p356 = c14 * (Lambda_0_11_p351 - Lambda_0_11_p353) + Lambda_0_11_p355 *
      Lambda_0_11_p354;
  const Real Lambda_0_11_p357 = c14 * Lambda_0_11_p356;
  const Real Lambda_0_11_p358 = Lambda_0_11_p351 - Lambda_0_11_p357;
  const Real Lambda_0_11_p359 = Lambda_0_11_p332 + (0.226 * Lambda_0_11_p350 - 0.18 *
      Lambda_0_11_p358);

  // link 23 (left_eye), articulated inertia
  const Real Lambda_0_11_p360 = 0.0007770270270270272 * c23;
  const Real Lambda_0_11_p361 = c23 * Lambda_0_11_p360;

  // link 24 (right_eye), articulated inertia
  const Real Lambda_0_11_p362 = 0.0007770270270270272 * c24;
  const Real Lambda_0_11_p363 = c24 * Lambda_0_11_p362;

  // link 23 (left_eye), articulated inertia
  const Real Lambda_0_11_p364 = s23 * Lambda_0_11_p360;

  // link 24 (right_eye), articulated inertia
  const Real Lambda_0_11_p365 = s24 * Lambda_0_11_p362;

  // link 23 (left_eye), articulated inertia
  const Real Lambda_0_11_p366 = Lambda_0_11_p364 + Lambda_0_11_p365;
  const Real Lambda_0_11_p367 = 0.032 * (Lambda_0_11_p361 - Lambda_0_11_p363) - 0.095 *
      Lambda_0_11_p366;
  const Real Lambda_0_11_p368 = Lambda_0_11_p363 + Lambda_0_11_p361;
  const Real Lambda_0_11_p369 = 0.430445945945946 + Lambda_0_11_p368;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D22_p1 = 9.060810810810813e-05 * s24;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D22_p2 = 9.060810810810813e-05 * s23;
  const Real inverse_D22_p3 = s24 * inverse_D22_p1 + s23 * inverse_D22_p2;
  const Real inverse_D22_p4 = c24 + c23;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p3 + 4.75e-05 * inverse_D22_p4);
  const Real Lambda_0_11_p370 = Lambda_0_11_p369 * inverse_D22;

  // link 24 (right_eye), articulated inertia
  const Real Lambda_0_11_p371 = 0.006756756756756757 * s24;
  const Real Lambda_0_11_p372 = c24 * Lambda_0_11_p371;
  const Real Lambda_0_11_p373 = s24 * Lambda_0_11_p371;
  const Real Lambda_0_11_p374 = 0.095 * Lambda_0_11_p372 - 0.032 * Lambda_0_11_p373;

  // link 23 (left_eye), articulated inertia
  const Real Lambda_0_11_p375 = 0.006756756756756757 * s23;
  const Real Lambda_0_11_p376 = c23 * Lambda_0_11_p375;
  const Real Lambda_0_11_p377 = s23 * Lambda_0_11_p375;
  const Real Lambda_0_11_p378 = 0.095 * Lambda_0_11_p376 + 0.032 * Lambda_0_11_p377;

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p379 = Lambda_0_11_p374 + Lambda_0_11_p378 + Lambda_0_11_p367 *
      Lambda_0_11_p370;

  // link 23 (left_eye), articulated inertia
  const Real Lambda_0_11_p380 = s24 + s23;
  const Real Lambda_0_11_p381 = 8e-06 * (c24 - c23) -
      (c24 * inverse_D22_p1 + c23 * inverse_D22_p2 + 2.375e-05 * Lambda_0_11_p380);
  const Real Lambda_0_11_p382 = 0.072575 + 0.00025 * inverse_D22_p4;

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p383 = Lambda_0_11_p382 * inverse_D22;
  const Real Lambda_0_11_p384 = Lambda_0_11_p381 * Lambda_0_11_p383 + 0.00025 * Lambda_0_11_p380;
  const Real Lambda_0_11_p385 = Lambda_0_11_p367 * Lambda_0_11_p383;
  const Real Lambda_0_11_p386 = Lambda_0_11_p366 + Lambda_0_11_p381 * Lambda_0_11_p370;
  const Real Lambda_0_11_p387 = c22 * (Lambda_0_11_p379 + Lambda_0_11_p384) - s22 *
      (Lambda_0_11_p385 - Lambda_0_11_p386);
  const Real Lambda_0_11_p388 = s22 * Lambda_0_11_p387;
  const Real Lambda_0_11_p389 = Lambda_0_11_p385 + Lambda_0_11_p388;
  const Real inverse_D21_p1 = Lambda_0_11_p367 * inverse_D22;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D21_p2 = Lambda_0_11_p373 - 0.006756756756756757;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D21_p3 = Lambda_0_11_p377 - 0.006756756756756757;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p4 = 0.095 * inverse_D21_p2 + 0.032 * Lambda_0_11_p372 +
      (0.095 * inverse_D21_p3 - 0.032 * Lambda_0_11_p376);
  const Real inverse_D21_p5 = 0.009438624999999999 - Lambda_0_11_p367 * inverse_D21_p1 + 0.095 *
      inverse_D21_p4 + 0.032 * (Lambda_0_11_p374 - Lambda_0_11_p378);
  const Real inverse_D21_p6 = 0.05450270000000001 + inverse_D22_p3 - Lambda_0_11_p381 *
      Lambda_0_11_p381 * inverse_D22 + 1.6e-05 * (s23 - s24) - 0.00017071621621621625;
  const Real inverse_D21_p7 = 0.0074 - Lambda_0_11_p381 * inverse_D21_p1 - 0.095 *
      Lambda_0_11_p368 + 0.032 * (Lambda_0_11_p365 - Lambda_0_11_p364);
  const Real inverse_D21_p8 = 2.0 * c22;
  const Real inverse_D21_p9 = s22 * (inverse_D21_p6 - inverse_D21_p5) + inverse_D21_p8 *
      inverse_D21_p7;
  const Real inverse_D21_p10 = s22 * inverse_D21_p9;

  // link 21 (neck), articulated inertia
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p5 + inverse_D21_p10));
  const Real Lambda_0_11_p390 = Lambda_0_11_p389 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p391 = c22 * Lambda_0_11_p387;
  const Real Lambda_0_11_p392 = Lambda_0_11_p384 - Lambda_0_11_p391;
  const Real Lambda_0_11_p393 = 0.394 * Lambda_0_11_p392;
  const Real Lambda_0_11_p394 = Lambda_0_11_p369 * Lambda_0_11_p383;
  const Real Lambda_0_11_p395 = Lambda_0_11_p373 + Lambda_0_11_p377 + Lambda_0_11_p369 *
      Lambda_0_11_p370;
  const Real Lambda_0_11_p396 = Lambda_0_11_p382 * Lambda_0_11_p383;
  const Real Lambda_0_11_p397 = inverse_D21_p8 * Lambda_0_11_p394 - s22 *
      (Lambda_0_11_p396 - Lambda_0_11_p395);
  const Real Lambda_0_11_p398 = Lambda_0_11_p394 - c22 * Lambda_0_11_p397;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p399 = 0.0045000000000000005 + 0.394 * Lambda_0_11_p398 +
      Lambda_0_11_p393 * Lambda_0_11_p390;

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p400 = Lambda_0_11_p366 * inverse_D22;
  const Real Lambda_0_11_p401 = 0.072575 + inverse_D21_p4 + Lambda_0_11_p367 * Lambda_0_11_p400;
  const Real Lambda_0_11_p402 = Lambda_0_11_p368 - 0.43200000000000005 - Lambda_0_11_p381 *
      Lambda_0_11_p400;
  const Real Lambda_0_11_p403 = c22 * Lambda_0_11_p401 - s22 * Lambda_0_11_p402;
  const Real Lambda_0_11_p404 = 0.0016155 + (c22 * inverse_D21_p9 - inverse_D21_p7 + 0.394 *
      Lambda_0_11_p403);
  const Real Lambda_0_11_p405 = Lambda_0_11_p382 * Lambda_0_11_p400;
  const Real Lambda_0_11_p406 = Lambda_0_11_p372 + Lambda_0_11_p376 - Lambda_0_11_p369 *
      Lambda_0_11_p400;
  const Real Lambda_0_11_p407 = c22 * Lambda_0_11_p405 - s22 * Lambda_0_11_p406;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p408 = Lambda_0_11_p379 - Lambda_0_11_p391 + 0.394 * Lambda_0_11_p407 +
      Lambda_0_11_p404 * Lambda_0_11_p390;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p409 = Lambda_0_11_p183 - (s21 * Lambda_0_11_p399 - c21 *
      Lambda_0_11_p408 + Lambda_0_11_p359);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D6_p1 = Lambda_0_11_p325 * inverse_D14;
  const Real inverse_D6_p2 = 0.0002975 + (inverse_D14_p3 - inverse_D14_p7) - Lambda_0_11_p325 *
      inverse_D6_p1;
  const Real inverse_D6_p3 = 6.890624999999999e-10 / inverse_D14_p8;
  const Real inverse_D6_p4 = 2.6249999999999998e-05 * inverse_D6_p1;
  const Real inverse_D6_p5 = c14 * (0.0001505 - inverse_D6_p3 - inverse_D6_p2) + Lambda_0_11_p355 *
      (8.75e-06 + inverse_D6_p4);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p6 = Lambda_0_11_p149 * inverse_D7;
  const Real inverse_D6_p7 = 0.0002975 + (inverse_D7_p3 - inverse_D7_p7) - Lambda_0_11_p149 *
      inverse_D6_p6;
  const Real inverse_D6_p8 = 0.0001505 - 6.890624999999999e-10 / inverse_D7_p8;
  const Real inverse_D6_p9 = 2.6249999999999998e-05 * inverse_D6_p6 - 8.75e-06;
  const Real inverse_D6_p10 = c7 * (inverse_D6_p8 - inverse_D6_p7) - Lambda_0_11_p174 *
      inverse_D6_p9;
  const Real inverse_D6_p11 = c14 * inverse_D6_p5 + c7 * inverse_D6_p10;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p12 = c22 * Lambda_0_11_p402 + s22 * Lambda_0_11_p401;
  const Real inverse_D6_p13 = inverse_D21_p2 + inverse_D21_p3 - Lambda_0_11_p366 * Lambda_0_11_p400;
  const Real inverse_D6_p14 = inverse_D6_p12 - 0.394 * inverse_D6_p13;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p15 = 0.005513625 + (inverse_D21_p6 - inverse_D21_p10 - 0.394 *
      (inverse_D6_p12 + inverse_D6_p14)) - Lambda_0_11_p404 * (Lambda_0_11_p404 * inverse_D21);
  const Real inverse_D6_p16 = Lambda_0_11_p393 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p17 = s22 * Lambda_0_11_p397;
  const Real inverse_D6_p18 = inverse_D6_p17 - Lambda_0_11_p395;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p19 = 0.000703125 + 0.155236 * inverse_D6_p18 - Lambda_0_11_p393 *
      inverse_D6_p16;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p20 = c22 * Lambda_0_11_p406 + s22 * Lambda_0_11_p405;
  const Real inverse_D6_p21 = 0.394 * inverse_D6_p20;
  const Real inverse_D6_p22 = Lambda_0_11_p388 - Lambda_0_11_p386 - inverse_D6_p21;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p23 = 0.394 * inverse_D6_p22 - Lambda_0_11_p404 * inverse_D6_p16;
  const Real inverse_D6_p24 = 2.0 * s21;
  const Real inverse_D6_p25 = c21 * (inverse_D6_p15 - inverse_D6_p19) - inverse_D6_p24 *
      inverse_D6_p23;
  const Real inverse_D6_p26 = c21 * inverse_D6_p25;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p27 = 2.06965463592404 + inverse_D6_p19 + inverse_D6_p26 + inverse_D6_p2 +
      inverse_D6_p11 + inverse_D6_p7 - 0.18 * (Lambda_0_11_p332 + Lambda_0_11_p359 +
      (Lambda_0_11_p156 + Lambda_0_11_p183));

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D6_p28 = 0.0017499999999999998 + 2.6249999999999998e-05 * Lambda_0_11_p334;
  const Real inverse_D6_p29 = Lambda_0_11_p322 + Lambda_0_11_p318 - 0.0017499999999999998 -
      Lambda_0_11_p325 * Lambda_0_11_p334;
  const Real inverse_D6_p30 = c14 * inverse_D6_p28 + s14 * inverse_D6_p29;
  const Real inverse_D6_p31 = Lambda_0_11_p345 + Lambda_0_11_p352 - Lambda_0_11_p333 *
      Lambda_0_11_p334;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p32 = 2.6249999999999998e-05 * Lambda_0_11_p179 - 0.0017499999999999998;
  const Real inverse_D6_p33 = Lambda_0_11_p146 - Lambda_0_11_p139 - 0.0017499999999999998 -
      Lambda_0_11_p149 * Lambda_0_11_p179;
  const Real inverse_D6_p34 = c7 * inverse_D6_p32 - s7 * inverse_D6_p33;
  const Real inverse_D6_p35 = Lambda_0_11_p163 + Lambda_0_11_p169 - Lambda_0_11_p178 *
      Lambda_0_11_p179;
  const Real inverse_D6_p36 = inverse_D6_p30 + (0.226 * inverse_D6_p31 - 0.18 * Lambda_0_11_p350) -
      (inverse_D6_p34 - (0.18 * Lambda_0_11_p182 + 0.226 * inverse_D6_p35));

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / (inverse_D6_p27 + 0.226 *
      (inverse_D6_p30 + inverse_D6_p36 - inverse_D6_p34));
  const Real Lambda_0_11_p410 = Lambda_0_11_p409 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p411 = c7 * Lambda_0_11_p154;
  const Real Lambda_0_11_p412 = s7 * Lambda_0_11_p175 + Lambda_0_11_p173;
  const Real Lambda_0_11_p413 = 0.18 * Lambda_0_11_p412;
  const Real Lambda_0_11_p414 = c7 * Lambda_0_11_p180 - s7 * Lambda_0_11_p181;
  const Real Lambda_0_11_p415 = 0.226 * Lambda_0_11_p414;
  const Real Lambda_0_11_p416 = Lambda_0_11_p411 - Lambda_0_11_p151 -
      (Lambda_0_11_p413 + Lambda_0_11_p415);
  const Real Lambda_0_11_p417 = Lambda_0_11_p130 - Lambda_0_11_p411;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_0_11_p418 = c14 * Lambda_0_11_p330;
  const Real Lambda_0_11_p419 = Lambda_0_11_p354 - s14 * Lambda_0_11_p356;
  const Real Lambda_0_11_p420 = 0.18 * Lambda_0_11_p419;
  const Real Lambda_0_11_p421 = c14 * Lambda_0_11_p343 - s14 * Lambda_0_11_p349;
  const Real Lambda_0_11_p422 = 0.226 * Lambda_0_11_p421;
  const Real Lambda_0_11_p423 = Lambda_0_11_p327 - Lambda_0_11_p418 -
      (Lambda_0_11_p420 + Lambda_0_11_p422);
  const Real Lambda_0_11_p424 = Lambda_0_11_p418 - Lambda_0_11_p306;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p425 = 0.0187281677636143 - inverse_D6_p4 + s14 * inverse_D6_p5 + s7 *
      inverse_D6_p10 + inverse_D6_p9 + 0.18 * (Lambda_0_11_p416 - Lambda_0_11_p417 -
      (Lambda_0_11_p423 - Lambda_0_11_p424));
  const Real Lambda_0_11_p426 = s14 * inverse_D6_p28 - c14 * inverse_D6_p29 -
      (s7 * inverse_D6_p32 + c7 * inverse_D6_p33);
  const Real Lambda_0_11_p427 = Lambda_0_11_p425 + 0.226 * Lambda_0_11_p426;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p428 = Lambda_0_11_p424 + Lambda_0_11_p420 +
      (Lambda_0_11_p417 + Lambda_0_11_p413) - Lambda_0_11_p427 * Lambda_0_11_p410;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p429 = Lambda_0_11_p423 + Lambda_0_11_p416;
  const Real Lambda_0_11_p430 = s21 * inverse_D6_p25 + inverse_D6_p23 + 0.226 * Lambda_0_11_p429;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p431 = Lambda_0_11_p392 * inverse_D21;
  const Real Lambda_0_11_p432 = inverse_D6_p22 - Lambda_0_11_p404 * Lambda_0_11_p431;

  // link 22 (head), articulated inertia
  const Real Lambda_0_11_p433 = 0.0045000000000000005 + Lambda_0_11_p403;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p434 = Lambda_0_11_p433 * inverse_D21;
  const Real Lambda_0_11_p435 = inverse_D6_p21 + Lambda_0_11_p393 * Lambda_0_11_p434;
  const Real Lambda_0_11_p436 = 0.394 * inverse_D6_p18 - Lambda_0_11_p393 * Lambda_0_11_p431;
  const Real Lambda_0_11_p437 = inverse_D6_p14 + Lambda_0_11_p404 * Lambda_0_11_p434;
  const Real Lambda_0_11_p438 = c21 * (Lambda_0_11_p432 - Lambda_0_11_p435) - s21 *
      (Lambda_0_11_p436 + Lambda_0_11_p437);
  const Real Lambda_0_11_p439 = s21 * Lambda_0_11_p438;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p440 = Lambda_0_11_p439 + Lambda_0_11_p437 - 6.1665928899999995 -
      inverse_D6_p36;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p441 = Lambda_0_11_p440 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p442 = c21 * Lambda_0_11_p438;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p443 = Lambda_0_11_p432 - Lambda_0_11_p442 + Lambda_0_11_p422 +
      Lambda_0_11_p415 - Lambda_0_11_p430 * Lambda_0_11_p441;
  const Real Lambda_0_11_p444 = Lambda_0_11_p419 - Lambda_0_11_p412;
  const Real Lambda_0_11_p445 = s21 * Lambda_0_11_p408 + c21 * Lambda_0_11_p399 - Lambda_0_11_p430 *
      Lambda_0_11_p410 - 0.226 * Lambda_0_11_p444;
  const Real Lambda_0_11_p446 = 0.18 * (Lambda_0_11_p414 - Lambda_0_11_p421) -
      (Lambda_0_11_p426 + Lambda_0_11_p427 * Lambda_0_11_p441);
  const Real Lambda_0_11_p447 = s6 * (Lambda_0_11_p428 - Lambda_0_11_p443) + c6 *
      (Lambda_0_11_p445 + Lambda_0_11_p446);
  const Real Lambda_0_11_p448 = s6 * Lambda_0_11_p447;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p449 = Lambda_0_11_p435 + Lambda_0_11_p442 + Lambda_0_11_p429;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p450 = Lambda_0_11_p449 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p451 = Lambda_0_11_p398 + Lambda_0_11_p392 * Lambda_0_11_p390;
  const Real Lambda_0_11_p452 = Lambda_0_11_p407 + Lambda_0_11_p433 * Lambda_0_11_p390;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p453 = c21 * Lambda_0_11_p451 + s21 * Lambda_0_11_p452 - Lambda_0_11_p444 -
      Lambda_0_11_p409 * Lambda_0_11_p450;

  // link 21 (neck), articulated inertia
  const Real Lambda_0_11_p454 = inverse_D6_p18 - Lambda_0_11_p392 * Lambda_0_11_p431;
  const Real Lambda_0_11_p455 = inverse_D6_p13 - Lambda_0_11_p433 * Lambda_0_11_p434;
  const Real Lambda_0_11_p456 = inverse_D6_p20 + Lambda_0_11_p392 * Lambda_0_11_p434;
  const Real Lambda_0_11_p457 = c21 * (Lambda_0_11_p454 - Lambda_0_11_p455) - inverse_D6_p24 *
      Lambda_0_11_p456;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p458 = s21 * Lambda_0_11_p457 + Lambda_0_11_p456 + Lambda_0_11_p421 +
      Lambda_0_11_p414 - Lambda_0_11_p440 * Lambda_0_11_p450;
  const Real Lambda_0_11_p459 = s6 * Lambda_0_11_p453 + c6 * Lambda_0_11_p458;
  const Real Lambda_0_11_p460 = 0.072 * Lambda_0_11_p459;
  const Real Lambda_0_11_p461 = Lambda_0_11_p443 + Lambda_0_11_p448 + Lambda_0_11_p460;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p1 = Lambda_0_11_p155 + Lambda_0_11_p152;
  const Real inverse_D5_p2 = Lambda_0_11_p170 + Lambda_0_11_p176;
  const Real inverse_D5_p3 = inverse_D5_p1 + 0.18 * inverse_D5_p2;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p4 = Lambda_0_11_p331 - Lambda_0_11_p328;
  const Real inverse_D5_p5 = Lambda_0_11_p353 + Lambda_0_11_p357;
  const Real inverse_D5_p6 = inverse_D5_p4 + 0.18 * inverse_D5_p5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p7 = inverse_D5_p3 - inverse_D5_p6 - Lambda_0_11_p427 * Lambda_0_11_p450;
  const Real inverse_D5_p8 = inverse_D5_p5 + inverse_D5_p2;
  const Real inverse_D5_p9 = 6.1665928899999995 + Lambda_0_11_p439 + Lambda_0_11_p436 -
      Lambda_0_11_p430 * Lambda_0_11_p450 + 0.226 * inverse_D5_p8;
  const Real inverse_D5_p10 = s6 * inverse_D5_p7 + c6 * inverse_D5_p9;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p11 = c21 * Lambda_0_11_p457;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p12 = Lambda_0_11_p455 + inverse_D5_p11 + inverse_D5_p8 - Lambda_0_11_p449 *
      Lambda_0_11_p450;
  const Real inverse_D5_p13 = inverse_D5_p10 + 0.072 * inverse_D5_p12;
  const Real inverse_D5_p14 = Lambda_0_11_p427 * inverse_D6;
  const Real inverse_D5_p15 = 0.40056549999999996 - inverse_D6_p3 - inverse_D6_p11 + inverse_D6_p8 -
      Lambda_0_11_p427 * inverse_D5_p14 + 0.18 * (inverse_D5_p4 + inverse_D5_p6 +
      (inverse_D5_p1 + inverse_D5_p3));
  const Real inverse_D5_p16 = Lambda_0_11_p430 * inverse_D6;
  const Real inverse_D5_p17 = 1.66923963592404 + inverse_D6_p15 - inverse_D6_p26 -
      Lambda_0_11_p430 * inverse_D5_p16 + 0.051076 * inverse_D5_p8;
  const Real inverse_D5_p18 = 0.04068 * (inverse_D5_p2 - inverse_D5_p5) - Lambda_0_11_p427 *
      inverse_D5_p16 + 0.226 * (inverse_D5_p1 - inverse_D5_p4);
  const Real inverse_D5_p19 = 2.0 * c6;
  const Real inverse_D5_p20 = s6 * (inverse_D5_p15 - inverse_D5_p17) + inverse_D5_p19 *
      inverse_D5_p18;
  const Real inverse_D5_p21 = s6 * inverse_D5_p20;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p17 + inverse_D5_p21 + 0.072 * (inverse_D5_p10 + inverse_D5_p13)));
  const Real Lambda_0_11_p462 = Lambda_0_11_p461 * inverse_D5;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p463 = 0.072 * Lambda_0_11_p461;
  const Real Lambda_0_11_p464 = Lambda_0_11_p358 - (Lambda_0_11_p396 + inverse_D6_p17 +
      Lambda_0_11_p389 * Lambda_0_11_p390) + Lambda_0_11_p177 - Lambda_0_11_p409 * Lambda_0_11_p410;
  const Real Lambda_0_11_p465 = Lambda_0_11_p454 - inverse_D5_p11 + inverse_D6_p31 +
      inverse_D6_p35 - Lambda_0_11_p440 * Lambda_0_11_p441;
  const Real Lambda_0_11_p466 = s21 * Lambda_0_11_p451 - c21 * Lambda_0_11_p452 + Lambda_0_11_p350 +
      Lambda_0_11_p182 - Lambda_0_11_p409 * Lambda_0_11_p441;
  const Real Lambda_0_11_p467 = s6 * (Lambda_0_11_p464 - Lambda_0_11_p465) + inverse_D5_p19 *
      Lambda_0_11_p466;
  const Real Lambda_0_11_p468 = s6 * Lambda_0_11_p467;
  const Real Lambda_0_11_p469 = Lambda_0_11_p465 + Lambda_0_11_p468;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p470 = Lambda_0_11_p463 * Lambda_0_11_p462 -
      (2.2194301519999997 + 0.072 * Lambda_0_11_p469);

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p471 = c6 * inverse_D5_p7 - s6 * inverse_D5_p9;
  const Real Lambda_0_11_p472 = c6 * inverse_D5_p20 - inverse_D5_p18 + 0.072 * Lambda_0_11_p471;
  const Real Lambda_0_11_p473 = c6 * Lambda_0_11_p447;
  const Real Lambda_0_11_p474 = Lambda_0_11_p473 - Lambda_0_11_p445;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p475 = Lambda_0_11_p474 - 0.069699984375 - Lambda_0_11_p472 *
      Lambda_0_11_p462;
  const Real Lambda_0_11_p476 = s5 * Lambda_0_11_p470 + c5 * Lambda_0_11_p475;
  const Real Lambda_0_11_p477 = Lambda_0_11_p463 * inverse_D5;
  const Real Lambda_0_11_p478 = 0.15637308509675518 + 0.005183999999999999 * Lambda_0_11_p469 -
      Lambda_0_11_p463 * Lambda_0_11_p477;
  const Real Lambda_0_11_p479 = Lambda_0_11_p472 * inverse_D5;
  const Real Lambda_0_11_p480 = 0.04675382692737882 + (inverse_D5_p15 - inverse_D5_p21) -
      Lambda_0_11_p472 * Lambda_0_11_p479;
  const Real Lambda_0_11_p481 = 0.005678398088837119 - 0.072 * Lambda_0_11_p474 + Lambda_0_11_p463 *
      Lambda_0_11_p479;
  const Real Lambda_0_11_p482 = 2.0 * c5;
  const Real Lambda_0_11_p483 = s5 * (Lambda_0_11_p478 - Lambda_0_11_p480) + Lambda_0_11_p482 *
      Lambda_0_11_p481;
  const Real Lambda_0_11_p484 = 0.005880002159562879 +
      (0.21799999999999997 * Lambda_0_11_p476 - (c5 * Lambda_0_11_p483 - Lambda_0_11_p481));

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p485 = 2.2194301519999997 + inverse_D5_p13;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p486 = Lambda_0_11_p485 * inverse_D5;
  const Real Lambda_0_11_p487 = Lambda_0_11_p463 * Lambda_0_11_p486 - Lambda_0_11_p460;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p488 = c6 * Lambda_0_11_p453 - s6 * Lambda_0_11_p458;
  const Real Lambda_0_11_p489 = 0.069699984375 + (Lambda_0_11_p473 - Lambda_0_11_p446 + 0.072 *
      Lambda_0_11_p488);

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p490 = Lambda_0_11_p489 * inverse_D5;
  const Real Lambda_0_11_p491 = Lambda_0_11_p428 - Lambda_0_11_p448 - Lambda_0_11_p472 *
      Lambda_0_11_p490;
  const Real Lambda_0_11_p492 = Lambda_0_11_p471 - Lambda_0_11_p472 * Lambda_0_11_p486;

  // link 6 (chest3), articulated inertia
  const Real Lambda_0_11_p493 = c6 * Lambda_0_11_p467 - Lambda_0_11_p466;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p494 = Lambda_0_11_p463 * Lambda_0_11_p490 - 0.072 * Lambda_0_11_p493;
  const Real Lambda_0_11_p495 = s5 * (Lambda_0_11_p487 - Lambda_0_11_p491) + c5 *
      (Lambda_0_11_p492 + Lambda_0_11_p494);
  const Real Lambda_0_11_p496 = c5 * Lambda_0_11_p495;
  const Real Lambda_0_11_p497 = Lambda_0_11_p496 - Lambda_0_11_p494;
  const Real inverse_D4_p1 = s5 * Lambda_0_11_p483;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (Lambda_0_11_p480 + inverse_D4_p1));
  const Real Lambda_0_11_p498 = Lambda_0_11_p497 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p499 = s5 * Lambda_0_11_p495;
  const Real Lambda_0_11_p500 = Lambda_0_11_p493 - Lambda_0_11_p489 * Lambda_0_11_p462;
  const Real Lambda_0_11_p501 = Lambda_0_11_p459 - Lambda_0_11_p485 * Lambda_0_11_p462;
  const Real Lambda_0_11_p502 = s5 * Lambda_0_11_p500 - c5 * Lambda_0_11_p501;
  const Real Lambda_0_11_p503 = 0.21799999999999997 * Lambda_0_11_p502;
  const Real Lambda_0_11_p504 = Lambda_0_11_p487 - Lambda_0_11_p499 + Lambda_0_11_p503;
  const Real Lambda_0_11_p505 = 0.21799999999999997 * Lambda_0_11_p497;
  const Real Lambda_0_11_p506 = 0.0300000063 + Lambda_0_11_p476;

  // link 4 (chest1), articulated inertia
  const Real Lambda_0_11_p507 = Lambda_0_11_p506 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p508 = Lambda_0_11_p464 - Lambda_0_11_p468 - Lambda_0_11_p489 *
      Lambda_0_11_p490;
  const Real Lambda_0_11_p509 = inverse_D5_p12 - Lambda_0_11_p485 * Lambda_0_11_p486;
  const Real Lambda_0_11_p510 = Lambda_0_11_p488 - Lambda_0_11_p485 * Lambda_0_11_p490;
  const Real Lambda_0_11_p511 = s5 * (Lambda_0_11_p509 - Lambda_0_11_p508) + Lambda_0_11_p482 *
      Lambda_0_11_p510;
  const Real Lambda_0_11_p512 = s5 * Lambda_0_11_p511;
  const Real Lambda_0_11_p513 = Lambda_0_11_p509 - Lambda_0_11_p512;
  const Real Lambda_0_11_p514 = s5 * Lambda_0_11_p475 - c5 * Lambda_0_11_p470;
  const Real Lambda_0_11_p515 = Lambda_0_11_p469 - Lambda_0_11_p461 * Lambda_0_11_p462;
  const Real Lambda_0_11_p516 = Lambda_0_11_p514 + 0.21799999999999997 * Lambda_0_11_p515;

  // link 4 (chest1), articulated inertia
  const Real Lambda_0_11_p517 = Lambda_0_11_p484 * Lambda_0_11_p507 - Lambda_0_11_p516;
  const Real Lambda_0_11_p518 = s4 * (Lambda_0_11_p504 + Lambda_0_11_p484 * Lambda_0_11_p498 +
      (Lambda_0_11_p503 + Lambda_0_11_p505 * Lambda_0_11_p507)) + c4 *
      (0.21799999999999997 * Lambda_0_11_p513 - Lambda_0_11_p505 * Lambda_0_11_p498 +
      Lambda_0_11_p517);
  const Real Lambda_0_11_p519 = 8.419374554 + (c4 * Lambda_0_11_p518 - Lambda_0_11_p517);
  const Real inverse_D3_p1 = Lambda_0_11_p484 * inverse_D4;
  const Real inverse_D3_p2 = Lambda_0_11_p505 * inverse_D4;
  const Real inverse_D3_p3 = 0.01227760324629517 + 0.04752399999999999 * Lambda_0_11_p513 -
      Lambda_0_11_p505 * inverse_D3_p2;
  const Real inverse_D3_p4 = 0.0478915 + (Lambda_0_11_p478 - inverse_D4_p1 + 0.21799999999999997 *
      (Lambda_0_11_p514 + Lambda_0_11_p516)) - Lambda_0_11_p484 * inverse_D3_p1 - inverse_D3_p3;
  const Real inverse_D3_p5 = 2.0 * c4;
  const Real inverse_D3_p6 = inverse_D3_p3 + s4 * (s4 * inverse_D3_p4 + inverse_D3_p5 *
      (0.21799999999999997 * Lambda_0_11_p504 + Lambda_0_11_p484 * inverse_D3_p2));

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p6);
  const Real Lambda_0_11_p520 = Lambda_0_11_p519 * inverse_D3;

  // link 4 (chest1), articulated inertia
  const Real Lambda_0_11_p521 = Lambda_0_11_p513 - Lambda_0_11_p497 * Lambda_0_11_p498;
  const Real Lambda_0_11_p522 = s4 * (Lambda_0_11_p521 -
      (Lambda_0_11_p515 - Lambda_0_11_p506 * Lambda_0_11_p507)) - inverse_D3_p5 *
      (Lambda_0_11_p502 + Lambda_0_11_p497 * Lambda_0_11_p507);

  // link 3 (hip), articulated inertia
  const Real Lambda_0_11_p523 = Lambda_0_11_p521 - s4 * Lambda_0_11_p522 - Lambda_0_11_p519 *
      Lambda_0_11_p520;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p524 = Lambda_0_11_p491 + Lambda_0_11_p499;

  // link 4 (chest1), articulated inertia
  const Real Lambda_0_11_p525 = Lambda_0_11_p524 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_0_11_p526 = s5 * Lambda_0_11_p501 + c5 * Lambda_0_11_p500;
  const Real Lambda_0_11_p527 = c5 * Lambda_0_11_p511 - Lambda_0_11_p510;

  // link 4 (chest1), articulated inertia
  const Real Lambda_0_11_p528 = s4 * (0.21799999999999997 * Lambda_0_11_p526 -
      (Lambda_0_11_p496 - Lambda_0_11_p492) - Lambda_0_11_p484 * Lambda_0_11_p525) + c4 *
      (0.0300000063 - 0.21799999999999997 * Lambda_0_11_p527 + Lambda_0_11_p505 * Lambda_0_11_p525);
  const Real Lambda_0_11_p529 = 0.02999999505 + Lambda_0_11_p528;

  // link 3 (hip), articulated inertia
  const Real Lambda_0_11_p530 = Lambda_0_11_p529 * inverse_D3;
  const Real Lambda_0_11_p531 = Lambda_0_11_p508 + Lambda_0_11_p512 - Lambda_0_11_p524 *
      Lambda_0_11_p525 - Lambda_0_11_p529 * Lambda_0_11_p530;
  const Real Lambda_0_11_p532 = Lambda_0_11_p519 * Lambda_0_11_p530 -
      (c4 * (Lambda_0_11_p497 * Lambda_0_11_p525 - Lambda_0_11_p527) - s4 *
      (Lambda_0_11_p506 * Lambda_0_11_p525 - Lambda_0_11_p526));
  const Real Lambda_0_11_p533 = s3 * (Lambda_0_11_p523 - Lambda_0_11_p531) + c3 *
      (2.0 * Lambda_0_11_p532);
  const Real Lambda_0_11_p534 = s3 * Lambda_0_11_p533;
  const Real Lambda_0_11_p535 = Lambda_0_11_p523 - Lambda_0_11_p534;
  const Real Lambda_0_11_p536 = 24.5839218 + 0.422 * Lambda_0_11_p535;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * Lambda_0_11_p535);
  const Real Lambda_0_11_p537 = Lambda_0_11_p536 * inverse_D2;

  // link 2 (thigh), pose
  const Real Lambda_0_11_p538 = c2 * c1 - s2 * s1;
  const Real Lambda_0_11_p539 = s2 * c1 + c2 * s1;

  // link 3 (hip), pose
  const Real Lambda_0_11_p540 = s3 * Lambda_0_11_p538 + c3 * Lambda_0_11_p539;

  // link 4 (chest1), pose
  const Real Lambda_0_11_p541 = c4 * Lambda_0_11_p540;

  // link 3 (hip), pose
  const Real Lambda_0_11_p542 = c3 * Lambda_0_11_p538 - s3 * Lambda_0_11_p539;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p543 = s5 * Lambda_0_11_p541 - c5 * Lambda_0_11_p542;

  // link 4 (chest1), pose
  const Real Lambda_0_11_p544 = s4 * Lambda_0_11_p540;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p545 = c6 * Lambda_0_11_p543 + s6 * Lambda_0_11_p544;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p546 = c5 * Lambda_0_11_p541 + s5 * Lambda_0_11_p542;

  // link 14 (right_shoulder1), pose
  const Real Lambda_0_11_p547 = s14 * Lambda_0_11_p545 - c14 * Lambda_0_11_p546;
  const Real Lambda_0_11_p548 = c14 * Lambda_0_11_p545 + s14 * Lambda_0_11_p546;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p549 = s6 * Lambda_0_11_p543 - c6 * Lambda_0_11_p544;

  // link 15 (right_shoulder2), pose
  const Real Lambda_0_11_p550 = s15 * Lambda_0_11_p548 + c15 * Lambda_0_11_p549;

  // link 16 (right_upperarm), pose
  const Real Lambda_0_11_p551 = c16 * Lambda_0_11_p547 - s16 * Lambda_0_11_p550;

  // link 15 (right_shoulder2), pose
  const Real Lambda_0_11_p552 = c15 * Lambda_0_11_p548 - s15 * Lambda_0_11_p549;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p553 = c17 * Lambda_0_11_p551 + s17 * Lambda_0_11_p552;

  // link 16 (right_upperarm), pose
  const Real Lambda_0_11_p554 = c16 * Lambda_0_11_p550 + s16 * Lambda_0_11_p547;

  // link 18 (right_wrist1), pose
  const Real Lambda_0_11_p555 = c18 * Lambda_0_11_p553 - s18 * Lambda_0_11_p554;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p556 = c17 * Lambda_0_11_p552 - s17 * Lambda_0_11_p551;

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p557 = c19 * Lambda_0_11_p556 - s19 * Lambda_0_11_p555;

  // link 18 (right_wrist1), pose
  const Real Lambda_0_11_p558 = s18 * Lambda_0_11_p553 + c18 * Lambda_0_11_p554;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p559 = c20 * Lambda_0_11_p557 - s20 * Lambda_0_11_p558;

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p560 = c19 * Lambda_0_11_p555 + s19 * Lambda_0_11_p556;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p561 = s5 * s4;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p562 = s6 * Lambda_0_11_p561 + c6 * c4;
  const Real Lambda_0_11_p563 = s6 * c4 - c6 * Lambda_0_11_p561;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p564 = c5 * s4;

  // link 14 (right_shoulder1), pose
  const Real Lambda_0_11_p565 = c14 * Lambda_0_11_p563 - s14 * Lambda_0_11_p564;

  // link 15 (right_shoulder2), pose
  const Real Lambda_0_11_p566 = c15 * Lambda_0_11_p562 - s15 * Lambda_0_11_p565;

  // link 14 (right_shoulder1), pose
  const Real Lambda_0_11_p567 = s14 * Lambda_0_11_p563 + c14 * Lambda_0_11_p564;

  // link 16 (right_upperarm), pose
  const Real Lambda_0_11_p568 = s16 * Lambda_0_11_p566 + c16 * Lambda_0_11_p567;

  // link 15 (right_shoulder2), pose
  const Real Lambda_0_11_p569 = c15 * Lambda_0_11_p565 + s15 * Lambda_0_11_p562;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p570 = c17 * Lambda_0_11_p568 + s17 * Lambda_0_11_p569;

  // link 16 (right_upperarm), pose
  const Real Lambda_0_11_p571 = c16 * Lambda_0_11_p566 - s16 * Lambda_0_11_p567;

  // link 18 (right_wrist1), pose
  const Real Lambda_0_11_p572 = c18 * Lambda_0_11_p570 + s18 * Lambda_0_11_p571;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p573 = c17 * Lambda_0_11_p569 - s17 * Lambda_0_11_p568;

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p574 = c19 * Lambda_0_11_p572 + s19 * Lambda_0_11_p573;

  // link 4 (chest1), pose
  const Real Lambda_0_11_p575 = c4 * Lambda_0_11_p542;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p576 = s5 * Lambda_0_11_p575 + c5 * Lambda_0_11_p540;

  // link 4 (chest1), pose
  const Real Lambda_0_11_p577 = s4 * Lambda_0_11_p542;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p578 = c6 * Lambda_0_11_p576 + s6 * Lambda_0_11_p577;

  // link 5 (chest2), pose
  const Real Lambda_0_11_p579 = c5 * Lambda_0_11_p575 - s5 * Lambda_0_11_p540;

  // link 14 (right_shoulder1), pose
  const Real Lambda_0_11_p580 = c14 * Lambda_0_11_p578 + s14 * Lambda_0_11_p579;

  // link 6 (chest3), pose
  const Real Lambda_0_11_p581 = s6 * Lambda_0_11_p576 - c6 * Lambda_0_11_p577;

  // link 15 (right_shoulder2), pose
  const Real Lambda_0_11_p582 = s15 * Lambda_0_11_p580 + c15 * Lambda_0_11_p581;

  // link 14 (right_shoulder1), pose
  const Real Lambda_0_11_p583 = c14 * Lambda_0_11_p579 - s14 * Lambda_0_11_p578;

  // link 16 (right_upperarm), pose
  const Real Lambda_0_11_p584 = s16 * Lambda_0_11_p582 + c16 * Lambda_0_11_p583;

  // link 15 (right_shoulder2), pose
  const Real Lambda_0_11_p585 = s15 * Lambda_0_11_p581 - c15 * Lambda_0_11_p580;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p586 = c17 * Lambda_0_11_p584 + s17 * Lambda_0_11_p585;

  // link 16 (right_upperarm), pose
  const Real Lambda_0_11_p587 = c16 * Lambda_0_11_p582 - s16 * Lambda_0_11_p583;

  // link 18 (right_wrist1), pose
  const Real Lambda_0_11_p588 = c18 * Lambda_0_11_p586 + s18 * Lambda_0_11_p587;

  // link 17 (right_lowerarm), pose
  const Real Lambda_0_11_p589 = c17 * Lambda_0_11_p585 - s17 * Lambda_0_11_p584;

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p590 = c19 * Lambda_0_11_p588 + s19 * Lambda_0_11_p589;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_0_11_p591_lanes = 0.11533812622014242 *
      detail::make_lanes<Real>(Lambda_0_11_p590, Lambda_0_11_p590, Lambda_0_11_p574,
      Lambda_0_11_p560, Lambda_0_11_p590, Lambda_0_11_p590, Lambda_0_11_p590, Lambda_0_11_p590);

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p594 = c19 * Lambda_0_11_p573 - s19 * Lambda_0_11_p572;

  // link 18 (right_wrist1), pose
  const Real Lambda_0_11_p595 = c18 * Lambda_0_11_p571 - s18 * Lambda_0_11_p570;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p596 = c20 * Lambda_0_11_p594 + s20 * Lambda_0_11_p595;

  // link 19 (right_wrist2), pose
  const Real Lambda_0_11_p597 = c19 * Lambda_0_11_p589 - s19 * Lambda_0_11_p588;

  // link 18 (right_wrist1), pose
  const Real Lambda_0_11_p598 = c18 * Lambda_0_11_p587 - s18 * Lambda_0_11_p586;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p599 = c20 * Lambda_0_11_p597 + s20 * Lambda_0_11_p598;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_0_11_p600_lanes = detail::make_lanes<Real>(Lambda_0_11_p599, Lambda_0_11_p599,
      Lambda_0_11_p596, Lambda_0_11_p559, Lambda_0_11_p599, Lambda_0_11_p599, Lambda_0_11_p599,
      Lambda_0_11_p599) + Lambda_0_11_p591_lanes;

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p603 = s20 * Lambda_0_11_p557 + c20 * Lambda_0_11_p558;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p604 = -(0.086 * Lambda_0_11_p603);
  const Real Lambda_0_11_p605 = 0.11533812622014242 * Lambda_0_11_p604;
  const Lanes Lambda_0_11_p606_lanes = c20 * detail::make_lanes<Real>(Lambda_0_11_p605,
      Lambda_0_11_p600_lanes[1], Lambda_0_11_p600_lanes[2], Lambda_0_11_p600_lanes[3],
      Lambda_0_11_p605, Lambda_0_11_p605, Lambda_0_11_p605, Lambda_0_11_p605);
  const Real Lambda_0_11_p610 = -Lambda_0_11_p603;
  const Lanes Lambda_0_11_p611_lanes = 0.04672761636452121 *
      detail::make_lanes<Real>(Lambda_0_11_p604, Lambda_0_11_p590, Lambda_0_11_p574,
      Lambda_0_11_p560, Lambda_0_11_p604, Lambda_0_11_p604, Lambda_0_11_p604, Lambda_0_11_p604);

  // link 20 (right_hand), pose
  const Real Lambda_0_11_p615 = c20 * Lambda_0_11_p595 - s20 * Lambda_0_11_p594;
  const Real Lambda_0_11_p616 = c20 * Lambda_0_11_p598 - s20 * Lambda_0_11_p597;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_0_11_p617_lanes = detail::make_lanes<Real>(-(0.086 * Lambda_0_11_p560),
      Lambda_0_11_p616, Lambda_0_11_p615, Lambda_0_11_p610, -(0.086 * Lambda_0_11_p560),
      -(0.086 * Lambda_0_11_p560), -(0.086 * Lambda_0_11_p560), -(0.086 * Lambda_0_11_p560)) +
      Lambda_0_11_p611_lanes;
  const Lanes Lambda_0_11_p621_lanes = s20 * Lambda_0_11_p617_lanes;
  const Lanes Lambda_0_11_p625_lanes = Lambda_0_11_p606_lanes - Lambda_0_11_p621_lanes;
  const Lanes Lambda_0_11_p629_lanes = s20 * detail::make_lanes<Real>(Lambda_0_11_p605,
      Lambda_0_11_p600_lanes[1], Lambda_0_11_p600_lanes[2], Lambda_0_11_p600_lanes[3],
      Lambda_0_11_p605, Lambda_0_11_p605, Lambda_0_11_p605, Lambda_0_11_p605);
  const Lanes Lambda_0_11_p633_lanes = c20 * Lambda_0_11_p617_lanes;
  const Lanes Lambda_0_11_p637_lanes = Lambda_0_11_p629_lanes + Lambda_0_11_p633_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p641_lanes = Lambda_0_11_p186 * Lambda_0_11_p637_lanes;
  const Lanes Lambda_0_11_p645_lanes = Lambda_0_11_p625_lanes - Lambda_0_11_p641_lanes;
  const Lanes Lambda_0_11_p649_lanes = s19 * Lambda_0_11_p645_lanes;
  const Lanes Lambda_0_11_p653_lanes = Lambda_0_11_p192 * Lambda_0_11_p637_lanes;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_0_11_p657_lanes = 3.0523172236718206 *
      detail::make_lanes<Real>(Lambda_0_11_p590, Lambda_0_11_p590, Lambda_0_11_p574,
      Lambda_0_11_p560, Lambda_0_11_p590, Lambda_0_11_p590, Lambda_0_11_p590, Lambda_0_11_p590);
  const Lanes Lambda_0_11_p660_lanes = s20 * Lambda_0_11_p657_lanes;
  const Lanes Lambda_0_11_p663_lanes = 17.32841575379867 *
      detail::make_lanes<Real>(Lambda_0_11_p590, Lambda_0_11_p590, Lambda_0_11_p574,
      Lambda_0_11_p560, Lambda_0_11_p590, Lambda_0_11_p590, Lambda_0_11_p590, Lambda_0_11_p590);
  const Lanes Lambda_0_11_p666_lanes = c20 * Lambda_0_11_p663_lanes;
  const Lanes Lambda_0_11_p669_lanes = Lambda_0_11_p660_lanes - Lambda_0_11_p666_lanes;
  const Real Lambda_0_11_p672 = Lambda_0_11_p559 + 3.0523172236718206 * Lambda_0_11_p604;
  const Real Lambda_0_11_p673 = Lambda_0_11_p610 - 17.32841575379867 * Lambda_0_11_p604;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p674_lanes = detail::make_lanes<Real>(s20 * Lambda_0_11_p672 + c20 *
      Lambda_0_11_p673, Lambda_0_11_p669_lanes[1], Lambda_0_11_p669_lanes[2],
      Lambda_0_11_p669_lanes[3], s20 * Lambda_0_11_p672 + c20 * Lambda_0_11_p673, s20 *
      Lambda_0_11_p672 + c20 * Lambda_0_11_p673, s20 * Lambda_0_11_p672 + c20 * Lambda_0_11_p673,
      s20 * Lambda_0_11_p672 + c20 * Lambda_0_11_p673) - Lambda_0_11_p653_lanes;
  const Lanes Lambda_0_11_p678_lanes = 0.269 * Lambda_0_11_p674_lanes;
  const Lanes Lambda_0_11_p682_lanes = Lambda_0_11_p678_lanes - Lambda_0_11_p649_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p686 = -(c19 * Lambda_0_11_p645_lanes[3]);
  const Real Lambda_0_11_p687 = -(c19 * Lambda_0_11_p645_lanes[2]);
  const Real Lambda_0_11_p688 = -(c19 * Lambda_0_11_p645_lanes[1]);
  const Real Lambda_0_11_p689 = -(c19 * Lambda_0_11_p645_lanes[0]);
  const Lanes Lambda_0_11_p690_lanes = inverse_D17_p1 *
      detail::make_lanes<Real>(Lambda_0_11_p689, Lambda_0_11_p688, Lambda_0_11_p687,
      Lambda_0_11_p686, Lambda_0_11_p689, Lambda_0_11_p689, Lambda_0_11_p689, Lambda_0_11_p689);
  const Lanes Lambda_0_11_p694_lanes = Lambda_0_11_p682_lanes - Lambda_0_11_p690_lanes;
  const Lanes Lambda_0_11_p698_lanes = c18 * Lambda_0_11_p694_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p702_lanes = Lambda_0_11_p209 * Lambda_0_11_p637_lanes;
  const Lanes Lambda_0_11_p705_lanes = c19 * Lambda_0_11_p702_lanes;
  const Lanes Lambda_0_11_p708_lanes = Lambda_0_11_p206 * Lambda_0_11_p637_lanes;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_0_11_p711_lanes = c20 * Lambda_0_11_p657_lanes;
  const Lanes Lambda_0_11_p714_lanes = s20 * Lambda_0_11_p663_lanes;
  const Lanes Lambda_0_11_p717_lanes = Lambda_0_11_p711_lanes + Lambda_0_11_p714_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p720_lanes = Lambda_0_11_p717_lanes - Lambda_0_11_p708_lanes;
  const Lanes Lambda_0_11_p723_lanes = s19 * Lambda_0_11_p720_lanes;
  const Lanes Lambda_0_11_p726_lanes = Lambda_0_11_p705_lanes + Lambda_0_11_p723_lanes;
  const Real Lambda_0_11_p729 = c20 * Lambda_0_11_p672 - s20 * Lambda_0_11_p673 - Lambda_0_11_p206 *
      Lambda_0_11_p637_lanes[0];
  const Real Lambda_0_11_p730 = Lambda_0_11_p560 - Lambda_0_11_p209 * Lambda_0_11_p637_lanes[0];
  const Real Lambda_0_11_p731 = s19 * Lambda_0_11_p729 - c19 * Lambda_0_11_p730;
  const Lanes Lambda_0_11_p732_lanes = 0.269 * detail::make_lanes<Real>(Lambda_0_11_p731,
      Lambda_0_11_p726_lanes[1], Lambda_0_11_p726_lanes[2], Lambda_0_11_p726_lanes[3],
      Lambda_0_11_p731, Lambda_0_11_p731, Lambda_0_11_p731, Lambda_0_11_p731);

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_0_11_p736_lanes = inverse_D17_p3 *
      detail::make_lanes<Real>(Lambda_0_11_p689, Lambda_0_11_p688, Lambda_0_11_p687,
      Lambda_0_11_p686, Lambda_0_11_p689, Lambda_0_11_p689, Lambda_0_11_p689, Lambda_0_11_p689);
  const Lanes Lambda_0_11_p740_lanes = Lambda_0_11_p732_lanes - Lambda_0_11_p736_lanes;
  const Lanes Lambda_0_11_p744_lanes = s18 * Lambda_0_11_p740_lanes;
  const Lanes Lambda_0_11_p748_lanes = Lambda_0_11_p698_lanes - Lambda_0_11_p744_lanes;
  const Lanes Lambda_0_11_p752_lanes = s18 * Lambda_0_11_p694_lanes;
  const Lanes Lambda_0_11_p756_lanes = c18 * Lambda_0_11_p740_lanes;
  const Lanes Lambda_0_11_p760_lanes = Lambda_0_11_p752_lanes + Lambda_0_11_p756_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p764_lanes = Lambda_0_11_p243 * Lambda_0_11_p760_lanes;
  const Lanes Lambda_0_11_p768_lanes = Lambda_0_11_p748_lanes - Lambda_0_11_p764_lanes;
  const Lanes Lambda_0_11_p772_lanes = c17 * Lambda_0_11_p768_lanes;
  const Lanes Lambda_0_11_p776_lanes = Lambda_0_11_p240 * Lambda_0_11_p760_lanes;
  const Lanes Lambda_0_11_p780_lanes = s17 * Lambda_0_11_p776_lanes;
  const Lanes Lambda_0_11_p784_lanes = Lambda_0_11_p772_lanes + Lambda_0_11_p780_lanes;
  const Lanes Lambda_0_11_p788_lanes = Lambda_0_11_p234 * Lambda_0_11_p760_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_0_11_p792_lanes = Lambda_0_11_p214 *
      detail::make_lanes<Real>(Lambda_0_11_p689, Lambda_0_11_p688, Lambda_0_11_p687,
      Lambda_0_11_p686, Lambda_0_11_p689, Lambda_0_11_p689, Lambda_0_11_p689, Lambda_0_11_p689);
  const Lanes Lambda_0_11_p796_lanes = detail::make_lanes<Real>(-Lambda_0_11_p731,
      -Lambda_0_11_p726_lanes[1], -Lambda_0_11_p726_lanes[2], -Lambda_0_11_p726_lanes[3],
      -Lambda_0_11_p731, -Lambda_0_11_p731, -Lambda_0_11_p731, -Lambda_0_11_p731) -
      Lambda_0_11_p792_lanes;
  const Lanes Lambda_0_11_p800_lanes = s18 * Lambda_0_11_p796_lanes;
  const Lanes Lambda_0_11_p804_lanes = Lambda_0_11_p198 *
      detail::make_lanes<Real>(Lambda_0_11_p689, Lambda_0_11_p688, Lambda_0_11_p687,
      Lambda_0_11_p686, Lambda_0_11_p689, Lambda_0_11_p689, Lambda_0_11_p689, Lambda_0_11_p689);
  const Lanes Lambda_0_11_p808_lanes = Lambda_0_11_p674_lanes - Lambda_0_11_p804_lanes;
  const Lanes Lambda_0_11_p812_lanes = c18 * Lambda_0_11_p808_lanes;
  const Lanes Lambda_0_11_p816_lanes = Lambda_0_11_p800_lanes + Lambda_0_11_p812_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p820_lanes = Lambda_0_11_p816_lanes - Lambda_0_11_p788_lanes;
  const Lanes Lambda_0_11_p824_lanes = 0.282 * Lambda_0_11_p820_lanes;
  const Lanes Lambda_0_11_p828_lanes = Lambda_0_11_p784_lanes + Lambda_0_11_p824_lanes;
  const Lanes Lambda_0_11_p832_lanes = s17 * Lambda_0_11_p768_lanes;
  const Lanes Lambda_0_11_p836_lanes = c17 * Lambda_0_11_p776_lanes;
  const Lanes Lambda_0_11_p840_lanes = Lambda_0_11_p836_lanes - Lambda_0_11_p832_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p844_lanes = inverse_D15_p1 * Lambda_0_11_p840_lanes;
  const Lanes Lambda_0_11_p848_lanes = Lambda_0_11_p828_lanes - Lambda_0_11_p844_lanes;
  const Lanes Lambda_0_11_p852_lanes = c16 * Lambda_0_11_p848_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p856_lanes = Lambda_0_11_p258 * Lambda_0_11_p760_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p860_lanes = s19 * Lambda_0_11_p702_lanes;
  const Lanes Lambda_0_11_p863_lanes = c19 * Lambda_0_11_p720_lanes;
  const Lanes Lambda_0_11_p866_lanes = Lambda_0_11_p860_lanes - Lambda_0_11_p863_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p869_lanes = detail::make_lanes<Real>(-(-(s19 * Lambda_0_11_p730 + c19 *
      Lambda_0_11_p729) - Lambda_0_11_p253 * Lambda_0_11_p689),
      -(Lambda_0_11_p866_lanes[1] - Lambda_0_11_p253 * Lambda_0_11_p688),
      -(Lambda_0_11_p866_lanes[2] - Lambda_0_11_p253 * Lambda_0_11_p687),
      -(Lambda_0_11_p866_lanes[3] - Lambda_0_11_p253 * Lambda_0_11_p686),
      -(-(s19 * Lambda_0_11_p730 + c19 * Lambda_0_11_p729) - Lambda_0_11_p253 * Lambda_0_11_p689),
      -(-(s19 * Lambda_0_11_p730 + c19 * Lambda_0_11_p729) - Lambda_0_11_p253 * Lambda_0_11_p689),
      -(-(s19 * Lambda_0_11_p730 + c19 * Lambda_0_11_p729) - Lambda_0_11_p253 * Lambda_0_11_p689),
      -(-(s19 * Lambda_0_11_p730 + c19 * Lambda_0_11_p729) - Lambda_0_11_p253 * Lambda_0_11_p689)) -
      Lambda_0_11_p856_lanes;
  const Lanes Lambda_0_11_p873_lanes = s17 * Lambda_0_11_p869_lanes;
  const Lanes Lambda_0_11_p877_lanes = Lambda_0_11_p249 * Lambda_0_11_p760_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_0_11_p881_lanes = c18 * Lambda_0_11_p796_lanes;
  const Lanes Lambda_0_11_p885_lanes = s18 * Lambda_0_11_p808_lanes;
  const Lanes Lambda_0_11_p889_lanes = Lambda_0_11_p881_lanes - Lambda_0_11_p885_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p893_lanes = Lambda_0_11_p889_lanes - Lambda_0_11_p877_lanes;
  const Lanes Lambda_0_11_p897_lanes = c17 * Lambda_0_11_p893_lanes;
  const Lanes Lambda_0_11_p901_lanes = Lambda_0_11_p873_lanes - Lambda_0_11_p897_lanes;
  const Lanes Lambda_0_11_p905_lanes = 0.282 * Lambda_0_11_p901_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p909_lanes = inverse_D15_p3 * Lambda_0_11_p840_lanes;
  const Lanes Lambda_0_11_p913_lanes = Lambda_0_11_p905_lanes - Lambda_0_11_p909_lanes;
  const Lanes Lambda_0_11_p917_lanes = s16 * Lambda_0_11_p913_lanes;
  const Lanes Lambda_0_11_p921_lanes = Lambda_0_11_p852_lanes - Lambda_0_11_p917_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p925_lanes = Lambda_0_11_p317 * Lambda_0_11_p921_lanes;
  const Lanes Lambda_0_11_p929_lanes = detail::make_lanes<Real>(-(-(s17 *
      Lambda_0_11_p893_lanes[0] + c17 * Lambda_0_11_p869_lanes[0]) + Lambda_0_11_p311 *
      Lambda_0_11_p840_lanes[0]), -(-(s17 * Lambda_0_11_p893_lanes[1] + c17 *
      Lambda_0_11_p869_lanes[1]) + Lambda_0_11_p311 * Lambda_0_11_p840_lanes[1]),
      -(-(s17 * Lambda_0_11_p893_lanes[2] + c17 * Lambda_0_11_p869_lanes[2]) + Lambda_0_11_p311 *
      Lambda_0_11_p840_lanes[2]), -(-(s17 * Lambda_0_11_p893_lanes[3] + c17 *
      Lambda_0_11_p869_lanes[3]) + Lambda_0_11_p311 * Lambda_0_11_p840_lanes[3]),
      -(-(s17 * Lambda_0_11_p893_lanes[0] + c17 * Lambda_0_11_p869_lanes[0]) + Lambda_0_11_p311 *
      Lambda_0_11_p840_lanes[0]), -(-(s17 * Lambda_0_11_p893_lanes[0] + c17 *
      Lambda_0_11_p869_lanes[0]) + Lambda_0_11_p311 * Lambda_0_11_p840_lanes[0]),
      -(-(s17 * Lambda_0_11_p893_lanes[0] + c17 * Lambda_0_11_p869_lanes[0]) + Lambda_0_11_p311 *
      Lambda_0_11_p840_lanes[0]), -(-(s17 * Lambda_0_11_p893_lanes[0] + c17 *
      Lambda_0_11_p869_lanes[0]) + Lambda_0_11_p311 * Lambda_0_11_p840_lanes[0])) -
      Lambda_0_11_p925_lanes;
  const Lanes Lambda_0_11_p933_lanes = c15 * Lambda_0_11_p929_lanes;
  const Lanes Lambda_0_11_p937_lanes = Lambda_0_11_p308 * Lambda_0_11_p921_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p941_lanes = Lambda_0_11_p266 * Lambda_0_11_p840_lanes;
  const Lanes Lambda_0_11_p945_lanes = detail::make_lanes<Real>(-Lambda_0_11_p901_lanes[0],
      -Lambda_0_11_p901_lanes[1], -Lambda_0_11_p901_lanes[2], -Lambda_0_11_p901_lanes[3],
      -Lambda_0_11_p901_lanes[0], -Lambda_0_11_p901_lanes[0], -Lambda_0_11_p901_lanes[0],
      -Lambda_0_11_p901_lanes[0]) - Lambda_0_11_p941_lanes;
  const Lanes Lambda_0_11_p949_lanes = s16 * Lambda_0_11_p945_lanes;
  const Lanes Lambda_0_11_p953_lanes = Lambda_0_11_p281 * Lambda_0_11_p840_lanes;
  const Lanes Lambda_0_11_p957_lanes = Lambda_0_11_p820_lanes - Lambda_0_11_p953_lanes;
  const Lanes Lambda_0_11_p961_lanes = c16 * Lambda_0_11_p957_lanes;
  const Lanes Lambda_0_11_p965_lanes = Lambda_0_11_p949_lanes + Lambda_0_11_p961_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p969_lanes = Lambda_0_11_p965_lanes - Lambda_0_11_p937_lanes;
  const Lanes Lambda_0_11_p973_lanes = s15 * Lambda_0_11_p969_lanes;
  const Lanes Lambda_0_11_p977_lanes = Lambda_0_11_p933_lanes - Lambda_0_11_p973_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p981_lanes = s16 * Lambda_0_11_p848_lanes;
  const Lanes Lambda_0_11_p985_lanes = c16 * Lambda_0_11_p913_lanes;
  const Lanes Lambda_0_11_p989_lanes = Lambda_0_11_p981_lanes + Lambda_0_11_p985_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p993_lanes = inverse_D14_p1 * Lambda_0_11_p921_lanes;
  const Lanes Lambda_0_11_p997_lanes = Lambda_0_11_p989_lanes - Lambda_0_11_p993_lanes;
  const Lanes Lambda_0_11_p1001_lanes = c15 * Lambda_0_11_p997_lanes;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_0_11_p1005 = 0.00010499999999999999 / inverse_D15_p9;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p1006_lanes = Lambda_0_11_p1005 * Lambda_0_11_p921_lanes;
  const Lanes Lambda_0_11_p1010_lanes = s15 * Lambda_0_11_p1006_lanes;
  const Lanes Lambda_0_11_p1014_lanes = Lambda_0_11_p1010_lanes + Lambda_0_11_p1001_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p1018_lanes = Lambda_0_11_p324 * Lambda_0_11_p1014_lanes;
  const Lanes Lambda_0_11_p1022_lanes = Lambda_0_11_p977_lanes - Lambda_0_11_p1018_lanes;
  const Lanes Lambda_0_11_p1026_lanes = c14 * Lambda_0_11_p1022_lanes;
  const Lanes Lambda_0_11_p1030_lanes = Lambda_0_11_p305 * Lambda_0_11_p1014_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p1034_lanes = Lambda_0_11_p299 * Lambda_0_11_p921_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p1038_lanes = c16 * Lambda_0_11_p945_lanes;
  const Lanes Lambda_0_11_p1042_lanes = s16 * Lambda_0_11_p957_lanes;
  const Lanes Lambda_0_11_p1046_lanes = Lambda_0_11_p1038_lanes - Lambda_0_11_p1042_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p1050_lanes = Lambda_0_11_p1046_lanes - Lambda_0_11_p1034_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p1054_lanes = Lambda_0_11_p1050_lanes - Lambda_0_11_p1030_lanes;
  const Lanes Lambda_0_11_p1058_lanes = s14 * Lambda_0_11_p1054_lanes;
  const Lanes Lambda_0_11_p1062_lanes = Lambda_0_11_p1058_lanes + Lambda_0_11_p1026_lanes;
  const Lanes Lambda_0_11_p1066_lanes = 0.18 * Lambda_0_11_p1062_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p1070_lanes = s15 * Lambda_0_11_p929_lanes;
  const Lanes Lambda_0_11_p1074_lanes = c15 * Lambda_0_11_p969_lanes;
  const Lanes Lambda_0_11_p1078_lanes = Lambda_0_11_p1070_lanes + Lambda_0_11_p1074_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p1082_lanes = Lambda_0_11_p334 * Lambda_0_11_p1014_lanes;
  const Lanes Lambda_0_11_p1086_lanes = Lambda_0_11_p1078_lanes - Lambda_0_11_p1082_lanes;
  const Lanes Lambda_0_11_p1090_lanes = 0.226 * Lambda_0_11_p1086_lanes;
  const Lanes Lambda_0_11_p1094_lanes = Lambda_0_11_p1066_lanes - Lambda_0_11_p1090_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p1098_lanes = s15 * Lambda_0_11_p997_lanes;
  const Lanes Lambda_0_11_p1102_lanes = c15 * Lambda_0_11_p1006_lanes;
  const Lanes Lambda_0_11_p1106_lanes = Lambda_0_11_p1102_lanes - Lambda_0_11_p1098_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p1110_lanes = inverse_D6_p1 * Lambda_0_11_p1014_lanes;
  const Lanes Lambda_0_11_p1114_lanes = Lambda_0_11_p1106_lanes - Lambda_0_11_p1110_lanes;
  const Lanes Lambda_0_11_p1118_lanes = s14 * Lambda_0_11_p1114_lanes;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_0_11_p1122 = 2.6249999999999998e-05 / inverse_D14_p8;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p1123_lanes = Lambda_0_11_p1122 * Lambda_0_11_p1014_lanes;
  const Lanes Lambda_0_11_p1127_lanes = c14 * Lambda_0_11_p1123_lanes;
  const Lanes Lambda_0_11_p1131_lanes = Lambda_0_11_p1127_lanes + Lambda_0_11_p1118_lanes;
  const Lanes Lambda_0_11_p1135_lanes = Lambda_0_11_p1094_lanes - Lambda_0_11_p1131_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p1139_lanes = inverse_D5_p14 * Lambda_0_11_p1135_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p1143_lanes = s14 * Lambda_0_11_p1022_lanes;
  const Lanes Lambda_0_11_p1147_lanes = c14 * Lambda_0_11_p1054_lanes;
  const Lanes Lambda_0_11_p1151_lanes = Lambda_0_11_p1147_lanes - Lambda_0_11_p1143_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p1155_lanes = detail::make_lanes<Real>(-(s14 *
      Lambda_0_11_p1123_lanes[0] - c14 * Lambda_0_11_p1114_lanes[0] + 0.18 *
      Lambda_0_11_p1151_lanes[0]), -(s14 * Lambda_0_11_p1123_lanes[1] - c14 *
      Lambda_0_11_p1114_lanes[1] + 0.18 * Lambda_0_11_p1151_lanes[1]),
      -(s14 * Lambda_0_11_p1123_lanes[2] - c14 * Lambda_0_11_p1114_lanes[2] + 0.18 *
      Lambda_0_11_p1151_lanes[2]), -(s14 * Lambda_0_11_p1123_lanes[3] - c14 *
      Lambda_0_11_p1114_lanes[3] + 0.18 * Lambda_0_11_p1151_lanes[3]),
      -(s14 * Lambda_0_11_p1123_lanes[0] - c14 * Lambda_0_11_p1114_lanes[0] + 0.18 *
      Lambda_0_11_p1151_lanes[0]), -(s14 * Lambda_0_11_p1123_lanes[0] - c14 *
      Lambda_0_11_p1114_lanes[0] + 0.18 * Lambda_0_11_p1151_lanes[0]),
      -(s14 * Lambda_0_11_p1123_lanes[0] - c14 * Lambda_0_11_p1114_lanes[0] + 0.18 *
      Lambda_0_11_p1151_lanes[0]), -(s14 * Lambda_0_11_p1123_lanes[0] - c14 *
      Lambda_0_11_p1114_lanes[0] + 0.18 * Lambda_0_11_p1151_lanes[0])) - Lambda_0_11_p1139_lanes;
  const Lanes Lambda_0_11_p1159_lanes = s6 * Lambda_0_11_p1155_lanes;
  const Lanes Lambda_0_11_p1163_lanes = inverse_D5_p16 * Lambda_0_11_p1135_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p1167_lanes = 0.226 * Lambda_0_11_p1151_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p1171_lanes = Lambda_0_11_p1167_lanes - Lambda_0_11_p1163_lanes;
  const Lanes Lambda_0_11_p1175_lanes = c6 * Lambda_0_11_p1171_lanes;
  const Lanes Lambda_0_11_p1179_lanes = Lambda_0_11_p1159_lanes + Lambda_0_11_p1175_lanes;
  const Lanes Lambda_0_11_p1183_lanes = Lambda_0_11_p450 * Lambda_0_11_p1135_lanes;
  const Lanes Lambda_0_11_p1187_lanes = Lambda_0_11_p1151_lanes - Lambda_0_11_p1183_lanes;
  const Lanes Lambda_0_11_p1191_lanes = 0.072 * Lambda_0_11_p1187_lanes;
  const Lanes Lambda_0_11_p1195_lanes = Lambda_0_11_p1179_lanes + Lambda_0_11_p1191_lanes;
  const Lanes Lambda_0_11_p1199_lanes = Lambda_0_11_p410 * Lambda_0_11_p1135_lanes;
  const Lanes Lambda_0_11_p1203_lanes = Lambda_0_11_p1062_lanes - Lambda_0_11_p1199_lanes;
  const Lanes Lambda_0_11_p1207_lanes = s6 * Lambda_0_11_p1203_lanes;
  const Lanes Lambda_0_11_p1211_lanes = Lambda_0_11_p441 * Lambda_0_11_p1135_lanes;
  const Lanes Lambda_0_11_p1215_lanes = Lambda_0_11_p1086_lanes - Lambda_0_11_p1211_lanes;
  const Lanes Lambda_0_11_p1219_lanes = c6 * Lambda_0_11_p1215_lanes;
  const Lanes Lambda_0_11_p1223_lanes = Lambda_0_11_p1207_lanes + Lambda_0_11_p1219_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p1227 = -(0.072 * Lambda_0_11_p1223_lanes[3]) + Lambda_0_11_p477 *
      Lambda_0_11_p1195_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p1228_lanes = c6 * Lambda_0_11_p1155_lanes;
  const Lanes Lambda_0_11_p1232_lanes = s6 * Lambda_0_11_p1171_lanes;
  const Lanes Lambda_0_11_p1236_lanes = Lambda_0_11_p1228_lanes - Lambda_0_11_p1232_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p1240 = Lambda_0_11_p1236_lanes[3] - Lambda_0_11_p479 *
      Lambda_0_11_p1195_lanes[3];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p1241 = -(s5 * Lambda_0_11_p1227 + c5 * Lambda_0_11_p1240);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p1242 = -(0.072 * Lambda_0_11_p1223_lanes[2]) + Lambda_0_11_p477 *
      Lambda_0_11_p1195_lanes[2];
  const Real Lambda_0_11_p1243 = Lambda_0_11_p1236_lanes[2] - Lambda_0_11_p479 *
      Lambda_0_11_p1195_lanes[2];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p1244 = -(s5 * Lambda_0_11_p1242 + c5 * Lambda_0_11_p1243);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p1245 = -(0.072 * Lambda_0_11_p1223_lanes[1]) + Lambda_0_11_p477 *
      Lambda_0_11_p1195_lanes[1];
  const Real Lambda_0_11_p1246 = Lambda_0_11_p1236_lanes[1] - Lambda_0_11_p479 *
      Lambda_0_11_p1195_lanes[1];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p1247 = -(s5 * Lambda_0_11_p1245 + c5 * Lambda_0_11_p1246);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p1248 = -(0.072 * Lambda_0_11_p1223_lanes[0]) + Lambda_0_11_p477 *
      Lambda_0_11_p1195_lanes[0];
  const Real Lambda_0_11_p1249 = Lambda_0_11_p1236_lanes[0] - Lambda_0_11_p479 *
      Lambda_0_11_p1195_lanes[0];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p1250 = -(s5 * Lambda_0_11_p1248 + c5 * Lambda_0_11_p1249);
  const Lanes Lambda_0_11_p1251_lanes = inverse_D3_p1 *
      detail::make_lanes<Real>(Lambda_0_11_p1250, Lambda_0_11_p1247, Lambda_0_11_p1244,
      Lambda_0_11_p1241, Lambda_0_11_p1250, Lambda_0_11_p1250, Lambda_0_11_p1250,
      Lambda_0_11_p1250);

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p1255_lanes = Lambda_0_11_p462 * Lambda_0_11_p1195_lanes;
  const Lanes Lambda_0_11_p1259_lanes = Lambda_0_11_p1223_lanes - Lambda_0_11_p1255_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p1263_lanes = detail::make_lanes<Real>(-(s5 * Lambda_0_11_p1249 - c5 *
      Lambda_0_11_p1248 + 0.21799999999999997 * Lambda_0_11_p1259_lanes[0]),
      -(s5 * Lambda_0_11_p1246 - c5 * Lambda_0_11_p1245 + 0.21799999999999997 *
      Lambda_0_11_p1259_lanes[1]), -(s5 * Lambda_0_11_p1243 - c5 * Lambda_0_11_p1242 +
      0.21799999999999997 * Lambda_0_11_p1259_lanes[2]),
      -(s5 * Lambda_0_11_p1240 - c5 * Lambda_0_11_p1227 + 0.21799999999999997 *
      Lambda_0_11_p1259_lanes[3]), -(s5 * Lambda_0_11_p1249 - c5 * Lambda_0_11_p1248 +
      0.21799999999999997 * Lambda_0_11_p1259_lanes[0]),
      -(s5 * Lambda_0_11_p1249 - c5 * Lambda_0_11_p1248 + 0.21799999999999997 *
      Lambda_0_11_p1259_lanes[0]), -(s5 * Lambda_0_11_p1249 - c5 * Lambda_0_11_p1248 +
      0.21799999999999997 * Lambda_0_11_p1259_lanes[0]),
      -(s5 * Lambda_0_11_p1249 - c5 * Lambda_0_11_p1248 + 0.21799999999999997 *
      Lambda_0_11_p1259_lanes[0])) - Lambda_0_11_p1251_lanes;
  const Lanes Lambda_0_11_p1267_lanes = s4 * Lambda_0_11_p1263_lanes;
  const Lanes Lambda_0_11_p1271_lanes = inverse_D3_p2 *
      detail::make_lanes<Real>(Lambda_0_11_p1250, Lambda_0_11_p1247, Lambda_0_11_p1244,
      Lambda_0_11_p1241, Lambda_0_11_p1250, Lambda_0_11_p1250, Lambda_0_11_p1250,
      Lambda_0_11_p1250);

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p1275_lanes = c6 * Lambda_0_11_p1203_lanes;
  const Lanes Lambda_0_11_p1279_lanes = s6 * Lambda_0_11_p1215_lanes;
  const Lanes Lambda_0_11_p1283_lanes = Lambda_0_11_p1275_lanes - Lambda_0_11_p1279_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p1287 = Lambda_0_11_p1283_lanes[3] - Lambda_0_11_p490 *
      Lambda_0_11_p1195_lanes[3];
  const Real Lambda_0_11_p1288 = Lambda_0_11_p1187_lanes[3] - Lambda_0_11_p486 *
      Lambda_0_11_p1195_lanes[3];
  const Real Lambda_0_11_p1289 = s5 * Lambda_0_11_p1287 - c5 * Lambda_0_11_p1288;
  const Real Lambda_0_11_p1290 = Lambda_0_11_p1283_lanes[2] - Lambda_0_11_p490 *
      Lambda_0_11_p1195_lanes[2];
  const Real Lambda_0_11_p1291 = Lambda_0_11_p1187_lanes[2] - Lambda_0_11_p486 *
      Lambda_0_11_p1195_lanes[2];
  const Real Lambda_0_11_p1292 = s5 * Lambda_0_11_p1290 - c5 * Lambda_0_11_p1291;
  const Real Lambda_0_11_p1293 = Lambda_0_11_p1283_lanes[1] - Lambda_0_11_p490 *
      Lambda_0_11_p1195_lanes[1];
  const Real Lambda_0_11_p1294 = Lambda_0_11_p1187_lanes[1] - Lambda_0_11_p486 *
      Lambda_0_11_p1195_lanes[1];
  const Real Lambda_0_11_p1295 = s5 * Lambda_0_11_p1293 - c5 * Lambda_0_11_p1294;
  const Real Lambda_0_11_p1296 = Lambda_0_11_p1283_lanes[0] - Lambda_0_11_p490 *
      Lambda_0_11_p1195_lanes[0];
  const Real Lambda_0_11_p1297 = Lambda_0_11_p1187_lanes[0] - Lambda_0_11_p486 *
      Lambda_0_11_p1195_lanes[0];
  const Real Lambda_0_11_p1298 = s5 * Lambda_0_11_p1296 - c5 * Lambda_0_11_p1297;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p1299_lanes = detail::make_lanes<Real>(-(0.21799999999999997 *
      Lambda_0_11_p1298), -(0.21799999999999997 * Lambda_0_11_p1295),
      -(0.21799999999999997 * Lambda_0_11_p1292), -(0.21799999999999997 * Lambda_0_11_p1289),
      -(0.21799999999999997 * Lambda_0_11_p1298), -(0.21799999999999997 * Lambda_0_11_p1298),
      -(0.21799999999999997 * Lambda_0_11_p1298), -(0.21799999999999997 * Lambda_0_11_p1298)) +
      Lambda_0_11_p1271_lanes;
  const Lanes Lambda_0_11_p1303_lanes = c4 * Lambda_0_11_p1299_lanes;
  const Lanes Lambda_0_11_p1307_lanes = Lambda_0_11_p1267_lanes + Lambda_0_11_p1303_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p1311_lanes = Lambda_0_11_p520 * Lambda_0_11_p1307_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p1315_lanes = Lambda_0_11_p498 *
      detail::make_lanes<Real>(Lambda_0_11_p1250, Lambda_0_11_p1247, Lambda_0_11_p1244,
      Lambda_0_11_p1241, Lambda_0_11_p1250, Lambda_0_11_p1250, Lambda_0_11_p1250,
      Lambda_0_11_p1250);
  const Lanes Lambda_0_11_p1319_lanes = detail::make_lanes<Real>(-Lambda_0_11_p1298,
      -Lambda_0_11_p1295, -Lambda_0_11_p1292, -Lambda_0_11_p1289, -Lambda_0_11_p1298,
      -Lambda_0_11_p1298, -Lambda_0_11_p1298, -Lambda_0_11_p1298) + Lambda_0_11_p1315_lanes;
  const Lanes Lambda_0_11_p1323_lanes = c4 * Lambda_0_11_p1319_lanes;
  const Lanes Lambda_0_11_p1327_lanes = Lambda_0_11_p507 *
      detail::make_lanes<Real>(Lambda_0_11_p1250, Lambda_0_11_p1247, Lambda_0_11_p1244,
      Lambda_0_11_p1241, Lambda_0_11_p1250, Lambda_0_11_p1250, Lambda_0_11_p1250,
      Lambda_0_11_p1250);
  const Lanes Lambda_0_11_p1331_lanes = Lambda_0_11_p1259_lanes + Lambda_0_11_p1327_lanes;
  const Lanes Lambda_0_11_p1335_lanes = s4 * Lambda_0_11_p1331_lanes;
  const Lanes Lambda_0_11_p1339_lanes = Lambda_0_11_p1323_lanes - Lambda_0_11_p1335_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p1343_lanes = Lambda_0_11_p1339_lanes - Lambda_0_11_p1311_lanes;
  const Lanes Lambda_0_11_p1347_lanes = c3 * Lambda_0_11_p1343_lanes;
  const Lanes Lambda_0_11_p1351_lanes = Lambda_0_11_p530 * Lambda_0_11_p1307_lanes;
  const Lanes Lambda_0_11_p1355_lanes = detail::make_lanes<Real>(-(-(s5 * Lambda_0_11_p1297 + c5 *
      Lambda_0_11_p1296) - Lambda_0_11_p525 * Lambda_0_11_p1250),
      -(-(s5 * Lambda_0_11_p1294 + c5 * Lambda_0_11_p1293) - Lambda_0_11_p525 * Lambda_0_11_p1247),
      -(-(s5 * Lambda_0_11_p1291 + c5 * Lambda_0_11_p1290) - Lambda_0_11_p525 * Lambda_0_11_p1244),
      -(-(s5 * Lambda_0_11_p1288 + c5 * Lambda_0_11_p1287) - Lambda_0_11_p525 * Lambda_0_11_p1241),
      -(-(s5 * Lambda_0_11_p1297 + c5 * Lambda_0_11_p1296) - Lambda_0_11_p525 * Lambda_0_11_p1250),
      -(-(s5 * Lambda_0_11_p1297 + c5 * Lambda_0_11_p1296) - Lambda_0_11_p525 * Lambda_0_11_p1250),
      -(-(s5 * Lambda_0_11_p1297 + c5 * Lambda_0_11_p1296) - Lambda_0_11_p525 * Lambda_0_11_p1250),
      -(-(s5 * Lambda_0_11_p1297 + c5 * Lambda_0_11_p1296) - Lambda_0_11_p525 *
      Lambda_0_11_p1250)) + Lambda_0_11_p1351_lanes;
  const Lanes Lambda_0_11_p1359_lanes = s3 * Lambda_0_11_p1355_lanes;
  const Lanes Lambda_0_11_p1363_lanes = Lambda_0_11_p1347_lanes - Lambda_0_11_p1359_lanes;
  const Lanes Lambda_0_11_p1367_lanes = 0.422 * Lambda_0_11_p1363_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p1371_lanes = Lambda_0_11_p537 * Lambda_0_11_p1367_lanes;
  const Lanes Lambda_0_11_p1375_lanes = Lambda_0_11_p1363_lanes - Lambda_0_11_p1371_lanes;
  const Lanes Lambda_0_11_p1379_lanes = c2 * Lambda_0_11_p1375_lanes;

  // link 3 (hip), articulated inertia
  const Real Lambda_0_11_p1383 = c3 * Lambda_0_11_p533 - Lambda_0_11_p532;
  const Real Lambda_0_11_p1384 = 0.031999971599999996 + 0.422 * Lambda_0_11_p1383;

  // link 2 (thigh), articulated inertia
  const Real Lambda_0_11_p1385 = Lambda_0_11_p1384 * inverse_D2;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p1386_lanes = Lambda_0_11_p1385 * Lambda_0_11_p1367_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p1390_lanes = s3 * Lambda_0_11_p1343_lanes;
  const Lanes Lambda_0_11_p1394_lanes = c3 * Lambda_0_11_p1355_lanes;
  const Lanes Lambda_0_11_p1398_lanes = Lambda_0_11_p1390_lanes + Lambda_0_11_p1394_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p1402_lanes = Lambda_0_11_p1398_lanes - Lambda_0_11_p1386_lanes;
  const Lanes Lambda_0_11_p1406_lanes = s2 * Lambda_0_11_p1402_lanes;
  const Lanes Lambda_0_11_p1410_lanes = Lambda_0_11_p1379_lanes - Lambda_0_11_p1406_lanes;
  const Lanes Lambda_0_11_p1414_lanes = 0.434 * Lambda_0_11_p1410_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p1 = Lambda_0_11_p535 - Lambda_0_11_p536 * Lambda_0_11_p537;
  const Real inverse_D1_p2 = s2 * (inverse_D1_p1 - (Lambda_0_11_p531 + Lambda_0_11_p534 -
      Lambda_0_11_p1384 * Lambda_0_11_p1385)) + c2 * (2.0 *
      (Lambda_0_11_p1383 - Lambda_0_11_p536 * Lambda_0_11_p1385));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p1 - s2 * inverse_D1_p2));

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p1418_lanes = Lambda_0_11_p1414_lanes * inverse_D1;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p1422 = Lambda_0_11_p596 + 0.26249928123577654 * Lambda_0_11_p615;
  const Real Lambda_0_11_p1423 = 0.49024375482668536 * Lambda_0_11_p615;
  const Real Lambda_0_11_p1424 = -(0.086 * Lambda_0_11_p574) + 0.004018575007348824 *
      Lambda_0_11_p615;
  const Real Lambda_0_11_p1425 = 0.009919078854932248 * Lambda_0_11_p615;
  const Real Lambda_0_11_p1426 = s20 * Lambda_0_11_p1425 + c20 * Lambda_0_11_p1424;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p1427 = s20 * Lambda_0_11_p1422 - c20 * Lambda_0_11_p1423 -
      Lambda_0_11_p192 * Lambda_0_11_p1426;
  const Real Lambda_0_11_p1428 = c20 * Lambda_0_11_p1425 - s20 * Lambda_0_11_p1424 -
      Lambda_0_11_p186 * Lambda_0_11_p1426;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p1429 = -(c19 * Lambda_0_11_p1428);
  const Real Lambda_0_11_p1430 = 0.269 * Lambda_0_11_p1427 - s19 * Lambda_0_11_p1428 -
      inverse_D17_p1 * Lambda_0_11_p1429;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p1431 = c20 * Lambda_0_11_p1422 + s20 * Lambda_0_11_p1423 -
      Lambda_0_11_p206 * Lambda_0_11_p1426;
  const Real Lambda_0_11_p1432 = Lambda_0_11_p574 - Lambda_0_11_p209 * Lambda_0_11_p1426;
  const Real Lambda_0_11_p1433 = s19 * Lambda_0_11_p1431 - c19 * Lambda_0_11_p1432;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p1434 = 0.269 * Lambda_0_11_p1433 - inverse_D17_p3 * Lambda_0_11_p1429;
  const Real Lambda_0_11_p1435 = s18 * Lambda_0_11_p1430 + c18 * Lambda_0_11_p1434;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p1436 = c18 * Lambda_0_11_p1430 - s18 * Lambda_0_11_p1434 -
      Lambda_0_11_p243 * Lambda_0_11_p1435;
  const Real Lambda_0_11_p1437 = Lambda_0_11_p240 * Lambda_0_11_p1435;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p1438 = -Lambda_0_11_p1433 - Lambda_0_11_p214 * Lambda_0_11_p1429;
  const Real Lambda_0_11_p1439 = Lambda_0_11_p1427 - Lambda_0_11_p198 * Lambda_0_11_p1429;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p1440 = s18 * Lambda_0_11_p1438 + c18 * Lambda_0_11_p1439 -
      Lambda_0_11_p234 * Lambda_0_11_p1435;
  const Real Lambda_0_11_p1441 = c17 * Lambda_0_11_p1437 - s17 * Lambda_0_11_p1436;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p1442 = c17 * Lambda_0_11_p1436 + s17 * Lambda_0_11_p1437 + 0.282 *
      Lambda_0_11_p1440 - inverse_D15_p1 * Lambda_0_11_p1441;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p1443 = c18 * Lambda_0_11_p1438 - s18 * Lambda_0_11_p1439 -
      Lambda_0_11_p249 * Lambda_0_11_p1435;
  const Real Lambda_0_11_p1444 = -(-(s19 * Lambda_0_11_p1432 + c19 * Lambda_0_11_p1431) -
      Lambda_0_11_p253 * Lambda_0_11_p1429) - Lambda_0_11_p258 * Lambda_0_11_p1435;
  const Real Lambda_0_11_p1445 = s17 * Lambda_0_11_p1444 - c17 * Lambda_0_11_p1443;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p1446 = 0.282 * Lambda_0_11_p1445 - inverse_D15_p3 * Lambda_0_11_p1441;
  const Real Lambda_0_11_p1447 = c16 * Lambda_0_11_p1442 - s16 * Lambda_0_11_p1446;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p1448 = Lambda_0_11_p1005 * Lambda_0_11_p1447;
  const Real Lambda_0_11_p1449 = s16 * Lambda_0_11_p1442 + c16 * Lambda_0_11_p1446 -
      inverse_D14_p1 * Lambda_0_11_p1447;
  const Real Lambda_0_11_p1450 = s15 * Lambda_0_11_p1448 + c15 * Lambda_0_11_p1449;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p1451 = Lambda_0_11_p599 + 0.26249928123577654 * Lambda_0_11_p616;
  const Real Lambda_0_11_p1452 = 0.49024375482668536 * Lambda_0_11_p616;
  const Real Lambda_0_11_p1453 = 0.009919078854932248 * Lambda_0_11_p616;
  const Real Lambda_0_11_p1454 = -(0.086 * Lambda_0_11_p590) + 0.004018575007348824 *
      Lambda_0_11_p616;
  const Real Lambda_0_11_p1455 = s20 * Lambda_0_11_p1453 + c20 * Lambda_0_11_p1454;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p1456 = s20 * Lambda_0_11_p1451 - c20 * Lambda_0_11_p1452 -
      Lambda_0_11_p192 * Lambda_0_11_p1455;
  const Real Lambda_0_11_p1457 = c20 * Lambda_0_11_p1453 - s20 * Lambda_0_11_p1454 -
      Lambda_0_11_p186 * Lambda_0_11_p1455;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p1458 = -(c19 * Lambda_0_11_p1457);
  const Real Lambda_0_11_p1459 = 0.269 * Lambda_0_11_p1456 - s19 * Lambda_0_11_p1457 -
      inverse_D17_p1 * Lambda_0_11_p1458;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p1460 = c20 * Lambda_0_11_p1451 + s20 * Lambda_0_11_p1452 -
      Lambda_0_11_p206 * Lambda_0_11_p1455;
  const Real Lambda_0_11_p1461 = Lambda_0_11_p590 - Lambda_0_11_p209 * Lambda_0_11_p1455;
  const Real Lambda_0_11_p1462 = s19 * Lambda_0_11_p1460 - c19 * Lambda_0_11_p1461;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p1463 = 0.269 * Lambda_0_11_p1462 - inverse_D17_p3 * Lambda_0_11_p1458;
  const Real Lambda_0_11_p1464 = s18 * Lambda_0_11_p1459 + c18 * Lambda_0_11_p1463;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p1465 = c18 * Lambda_0_11_p1459 - s18 * Lambda_0_11_p1463 -
      Lambda_0_11_p243 * Lambda_0_11_p1464;
  const Real Lambda_0_11_p1466 = Lambda_0_11_p240 * Lambda_0_11_p1464;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p1467 = -Lambda_0_11_p1462 - Lambda_0_11_p214 * Lambda_0_11_p1458;
  const Real Lambda_0_11_p1468 = Lambda_0_11_p1456 - Lambda_0_11_p198 * Lambda_0_11_p1458;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p1469 = s18 * Lambda_0_11_p1467 + c18 * Lambda_0_11_p1468 -
      Lambda_0_11_p234 * Lambda_0_11_p1464;
  const Real Lambda_0_11_p1470 = c17 * Lambda_0_11_p1466 - s17 * Lambda_0_11_p1465;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p1471 = c17 * Lambda_0_11_p1465 + s17 * Lambda_0_11_p1466 + 0.282 *
      Lambda_0_11_p1469 - inverse_D15_p1 * Lambda_0_11_p1470;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p1472 = c18 * Lambda_0_11_p1467 - s18 * Lambda_0_11_p1468 -
      Lambda_0_11_p249 * Lambda_0_11_p1464;
  const Real Lambda_0_11_p1473 = -(-(s19 * Lambda_0_11_p1461 + c19 * Lambda_0_11_p1460) -
      Lambda_0_11_p253 * Lambda_0_11_p1458) - Lambda_0_11_p258 * Lambda_0_11_p1464;
  const Real Lambda_0_11_p1474 = s17 * Lambda_0_11_p1473 - c17 * Lambda_0_11_p1472;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p1475 = 0.282 * Lambda_0_11_p1474 - inverse_D15_p3 * Lambda_0_11_p1470;
  const Real Lambda_0_11_p1476 = c16 * Lambda_0_11_p1471 - s16 * Lambda_0_11_p1475;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p1477 = s16 * Lambda_0_11_p1471 + c16 * Lambda_0_11_p1475 -
      inverse_D14_p1 * Lambda_0_11_p1476;
  const Real Lambda_0_11_p1478 = Lambda_0_11_p1005 * Lambda_0_11_p1476;
  const Real Lambda_0_11_p1479 = s15 * Lambda_0_11_p1478 + c15 * Lambda_0_11_p1477;

  // link 7 (left_shoulder1), pose
  const Real Lambda_0_11_p1480 = s7 * Lambda_0_11_p545 - c7 * Lambda_0_11_p546;
  const Real Lambda_0_11_p1481 = c7 * Lambda_0_11_p545 + s7 * Lambda_0_11_p546;

  // link 8 (left_shoulder2), pose
  const Real Lambda_0_11_p1482 = s8 * Lambda_0_11_p1481 + c8 * Lambda_0_11_p549;

  // link 9 (left_upperarm), pose
  const Real Lambda_0_11_p1483 = c9 * Lambda_0_11_p1480 - s9 * Lambda_0_11_p1482;

  // link 8 (left_shoulder2), pose
  const Real Lambda_0_11_p1484 = c8 * Lambda_0_11_p1481 - s8 * Lambda_0_11_p549;

  // link 10 (left_lowerarm), pose
  const Real Lambda_0_11_p1485 = c10 * Lambda_0_11_p1483 + s10 * Lambda_0_11_p1484;

  // link 9 (left_upperarm), pose
  const Real Lambda_0_11_p1486 = c9 * Lambda_0_11_p1482 + s9 * Lambda_0_11_p1480;

  // link 11 (left_wrist1), pose
  const Real Lambda_0_11_p1487 = c11 * Lambda_0_11_p1485 - s11 * Lambda_0_11_p1486;

  // link 7 (left_shoulder1), pose
  const Real Lambda_0_11_p1488 = c7 * Lambda_0_11_p563 - s7 * Lambda_0_11_p564;

  // link 8 (left_shoulder2), pose
  const Real Lambda_0_11_p1489 = c8 * Lambda_0_11_p562 - s8 * Lambda_0_11_p1488;

  // link 7 (left_shoulder1), pose
  const Real Lambda_0_11_p1490 = s7 * Lambda_0_11_p563 + c7 * Lambda_0_11_p564;

  // link 9 (left_upperarm), pose
  const Real Lambda_0_11_p1491 = s9 * Lambda_0_11_p1489 + c9 * Lambda_0_11_p1490;

  // link 7 (left_shoulder1), pose
  const Real Lambda_0_11_p1492 = c7 * Lambda_0_11_p578 + s7 * Lambda_0_11_p579;

  // link 8 (left_shoulder2), pose
  const Real Lambda_0_11_p1493 = s8 * Lambda_0_11_p1492 + c8 * Lambda_0_11_p581;

  // link 7 (left_shoulder1), pose
  const Real Lambda_0_11_p1494 = c7 * Lambda_0_11_p579 - s7 * Lambda_0_11_p578;

  // link 9 (left_upperarm), pose
  const Real Lambda_0_11_p1495 = s9 * Lambda_0_11_p1493 + c9 * Lambda_0_11_p1494;

  // link 10 (left_lowerarm), pose
  const Lanes Lambda_0_11_p1496_lanes = s10 * detail::make_lanes<Real>(Lambda_0_11_p1495,
      Lambda_0_11_p1491, Lambda_0_11_p1483, Lambda_0_11_p1495, Lambda_0_11_p1495, Lambda_0_11_p1495,
      Lambda_0_11_p1495, Lambda_0_11_p1495);

  // link 8 (left_shoulder2), pose
  const Real Lambda_0_11_p1499 = c8 * Lambda_0_11_p1488 + s8 * Lambda_0_11_p562;
  const Real Lambda_0_11_p1500 = s8 * Lambda_0_11_p581 - c8 * Lambda_0_11_p1492;

  // link 10 (left_lowerarm), pose
  const Lanes Lambda_0_11_p1501_lanes = c10 * detail::make_lanes<Real>(Lambda_0_11_p1500,
      Lambda_0_11_p1499, Lambda_0_11_p1484, Lambda_0_11_p1500, Lambda_0_11_p1500, Lambda_0_11_p1500,
      Lambda_0_11_p1500, Lambda_0_11_p1500);
  const Lanes Lambda_0_11_p1504_lanes = Lambda_0_11_p1501_lanes - Lambda_0_11_p1496_lanes;

  // link 12 (left_wrist2), pose
  const Real Lambda_0_11_p1507 = c12 * Lambda_0_11_p1504_lanes[2] - s12 * Lambda_0_11_p1487;

  // link 11 (left_wrist1), pose
  const Real Lambda_0_11_p1508 = s11 * Lambda_0_11_p1485 + c11 * Lambda_0_11_p1486;

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1509 = c13 * Lambda_0_11_p1507 - s13 * Lambda_0_11_p1508;

  // link 10 (left_lowerarm), pose
  const Real Lambda_0_11_p1510 = c10 * Lambda_0_11_p1491 + s10 * Lambda_0_11_p1499;

  // link 9 (left_upperarm), pose
  const Real Lambda_0_11_p1511 = c9 * Lambda_0_11_p1489 - s9 * Lambda_0_11_p1490;

  // link 11 (left_wrist1), pose
  const Real Lambda_0_11_p1512 = c11 * Lambda_0_11_p1510 + s11 * Lambda_0_11_p1511;

  // link 10 (left_lowerarm), pose
  const Real Lambda_0_11_p1513 = c10 * Lambda_0_11_p1495 + s10 * Lambda_0_11_p1500;

  // link 9 (left_upperarm), pose
  const Real Lambda_0_11_p1514 = c9 * Lambda_0_11_p1493 - s9 * Lambda_0_11_p1494;

  // link 11 (left_wrist1), pose
  const Real Lambda_0_11_p1515 = c11 * Lambda_0_11_p1513 + s11 * Lambda_0_11_p1514;

  // link 12 (left_wrist2), pose
  const Lanes Lambda_0_11_p1516_lanes = c12 * detail::make_lanes<Real>(Lambda_0_11_p1515,
      Lambda_0_11_p1512, Lambda_0_11_p1487, Lambda_0_11_p1515, Lambda_0_11_p1515, Lambda_0_11_p1515,
      Lambda_0_11_p1515, Lambda_0_11_p1515);
  const Lanes Lambda_0_11_p1519_lanes = s12 * Lambda_0_11_p1504_lanes;
  const Lanes Lambda_0_11_p1522_lanes = Lambda_0_11_p1516_lanes + Lambda_0_11_p1519_lanes;

  // link 13 (left_hand), force propagation
  const Lanes Lambda_0_11_p1525_lanes = 0.11533812622014242 *
      detail::make_lanes<Real>(Lambda_0_11_p1522_lanes[0], Lambda_0_11_p1522_lanes[0],
      Lambda_0_11_p1522_lanes[0], Lambda_0_11_p1522_lanes[0], Lambda_0_11_p1522_lanes[1],
      Lambda_0_11_p1522_lanes[2], Lambda_0_11_p1522_lanes[0], Lambda_0_11_p1522_lanes[0]);

  // link 12 (left_wrist2), pose
  const Real Lambda_0_11_p1528 = c12 * Lambda_0_11_p1504_lanes[1] - s12 * Lambda_0_11_p1512;

  // link 11 (left_wrist1), pose
  const Real Lambda_0_11_p1529 = c11 * Lambda_0_11_p1511 - s11 * Lambda_0_11_p1510;

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1530 = c13 * Lambda_0_11_p1528 + s13 * Lambda_0_11_p1529;

  // link 12 (left_wrist2), pose
  const Real Lambda_0_11_p1531 = c12 * Lambda_0_11_p1504_lanes[0] - s12 * Lambda_0_11_p1515;

  // link 11 (left_wrist1), pose
  const Real Lambda_0_11_p1532 = c11 * Lambda_0_11_p1514 - s11 * Lambda_0_11_p1513;

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1533 = c13 * Lambda_0_11_p1531 + s13 * Lambda_0_11_p1532;

  // link 13 (left_hand), force propagation
  const Lanes Lambda_0_11_p1534_lanes = detail::make_lanes<Real>(Lambda_0_11_p1533,
      Lambda_0_11_p1533, Lambda_0_11_p1533, Lambda_0_11_p1533, Lambda_0_11_p1530, Lambda_0_11_p1509,
      Lambda_0_11_p1533, Lambda_0_11_p1533) + Lambda_0_11_p1525_lanes;

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1537 = s13 * Lambda_0_11_p1507 + c13 * Lambda_0_11_p1508;

  // link 13 (left_hand), force propagation
  const Real Lambda_0_11_p1538 = -(0.086 * Lambda_0_11_p1537);
  const Real Lambda_0_11_p1539 = 0.11533812622014242 * Lambda_0_11_p1538;

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1540 = c13 * Lambda_0_11_p1529 - s13 * Lambda_0_11_p1528;

  // link 13 (left_hand), force propagation
  const Real Lambda_0_11_p1541 = 0.009919078854932248 * Lambda_0_11_p1540;

  // link 13 (left_hand), pose
  const Real Lambda_0_11_p1542 = c13 * Lambda_0_11_p1532 - s13 * Lambda_0_11_p1531;

  // link 13 (left_hand), force propagation
  const Real Lambda_0_11_p1543 = 0.009919078854932248 * Lambda_0_11_p1542;
  const Lanes Lambda_0_11_p1544_lanes = c13 * detail::make_lanes<Real>(Lambda_0_11_p1543,
      Lambda_0_11_p1541, Lambda_0_11_p1539, Lambda_0_11_p1534_lanes[3], Lambda_0_11_p1534_lanes[4],
      Lambda_0_11_p1534_lanes[5], Lambda_0_11_p1543, Lambda_0_11_p1543);
  const Real Lambda_0_11_p1550 = -Lambda_0_11_p1537;
  const Lanes Lambda_0_11_p1551_lanes = detail::make_lanes<Real>(0.004018575007348824,
      0.004018575007348824, 0.04672761636452121, 0.04672761636452121, 0.04672761636452121,
      0.04672761636452121, 0.004018575007348824, 0.004018575007348824) *
      detail::make_lanes<Real>(Lambda_0_11_p1542, Lambda_0_11_p1540, Lambda_0_11_p1538,
      Lambda_0_11_p1522_lanes[0], Lambda_0_11_p1522_lanes[1], Lambda_0_11_p1522_lanes[2],
      Lambda_0_11_p1542, Lambda_0_11_p1542);
  const Lanes Lambda_0_11_p1557_lanes = detail::make_lanes<Real>(-(0.086 *
      Lambda_0_11_p1522_lanes[0]), -(0.086 * Lambda_0_11_p1522_lanes[1]),
      -(0.086 * Lambda_0_11_p1522_lanes[2]), Lambda_0_11_p1542, Lambda_0_11_p1540,
      Lambda_0_11_p1550, -(0.086 * Lambda_0_11_p1522_lanes[0]),
      -(0.086 * Lambda_0_11_p1522_lanes[0])) - Lambda_0_11_p1551_lanes;
  const Lanes Lambda_0_11_p1563_lanes = s13 * Lambda_0_11_p1557_lanes;
  const Lanes Lambda_0_11_p1569_lanes = Lambda_0_11_p1544_lanes - Lambda_0_11_p1563_lanes;
  const Lanes Lambda_0_11_p1575_lanes = s13 * detail::make_lanes<Real>(Lambda_0_11_p1543,
      Lambda_0_11_p1541, Lambda_0_11_p1539, Lambda_0_11_p1534_lanes[3], Lambda_0_11_p1534_lanes[4],
      Lambda_0_11_p1534_lanes[5], Lambda_0_11_p1543, Lambda_0_11_p1543);
  const Lanes Lambda_0_11_p1581_lanes = c13 * Lambda_0_11_p1557_lanes;
  const Lanes Lambda_0_11_p1587_lanes = Lambda_0_11_p1575_lanes + Lambda_0_11_p1581_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p1593_lanes = Lambda_0_11_p3 * Lambda_0_11_p1587_lanes;
  const Lanes Lambda_0_11_p1599_lanes = Lambda_0_11_p1569_lanes - Lambda_0_11_p1593_lanes;
  const Lanes Lambda_0_11_p1605_lanes = s12 * Lambda_0_11_p1599_lanes;
  const Lanes Lambda_0_11_p1611_lanes = Lambda_0_11_p9 * Lambda_0_11_p1587_lanes;

  // link 13 (left_hand), force propagation
  const Real Lambda_0_11_p1617 = 3.0523172236718206 * Lambda_0_11_p1522_lanes[2];
  const Real Lambda_0_11_p1618 = 17.32841575379867 * Lambda_0_11_p1522_lanes[2];
  const Real Lambda_0_11_p1619 = 3.0523172236718206 * Lambda_0_11_p1522_lanes[1];
  const Real Lambda_0_11_p1620 = 17.32841575379867 * Lambda_0_11_p1522_lanes[1];
  const Real Lambda_0_11_p1621 = 3.0523172236718206 * Lambda_0_11_p1522_lanes[0];
  const Real Lambda_0_11_p1622 = 17.32841575379867 * Lambda_0_11_p1522_lanes[0];
  const Real Lambda_0_11_p1623 = Lambda_0_11_p1509 - 3.0523172236718206 * Lambda_0_11_p1538;
  const Real Lambda_0_11_p1624 = Lambda_0_11_p1550 - 17.32841575379867 * Lambda_0_11_p1538;
  const Real Lambda_0_11_p1625 = Lambda_0_11_p1530 - 0.26249928123577654 * Lambda_0_11_p1540;
  const Real Lambda_0_11_p1626 = 0.49024375482668536 * Lambda_0_11_p1540;
  const Real Lambda_0_11_p1627 = Lambda_0_11_p1533 - 0.26249928123577654 * Lambda_0_11_p1542;
  const Real Lambda_0_11_p1628 = 0.49024375482668536 * Lambda_0_11_p1542;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p1629_lanes = detail::make_lanes<Real>(s13 * Lambda_0_11_p1627 - c13 *
      Lambda_0_11_p1628, s13 * Lambda_0_11_p1625 - c13 * Lambda_0_11_p1626, s13 *
      Lambda_0_11_p1623 + c13 * Lambda_0_11_p1624, -(s13 * Lambda_0_11_p1621 + c13 *
      Lambda_0_11_p1622), -(s13 * Lambda_0_11_p1619 + c13 * Lambda_0_11_p1620),
      -(s13 * Lambda_0_11_p1617 + c13 * Lambda_0_11_p1618), s13 * Lambda_0_11_p1627 - c13 *
      Lambda_0_11_p1628, s13 * Lambda_0_11_p1627 - c13 * Lambda_0_11_p1628) -
      Lambda_0_11_p1611_lanes;
  const Lanes Lambda_0_11_p1635_lanes = 0.269 * Lambda_0_11_p1629_lanes;
  const Lanes Lambda_0_11_p1641_lanes = Lambda_0_11_p1635_lanes - Lambda_0_11_p1605_lanes;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_0_11_p1647 = -(c12 * Lambda_0_11_p1599_lanes[5]);
  const Real Lambda_0_11_p1648 = -(c12 * Lambda_0_11_p1599_lanes[4]);
  const Real Lambda_0_11_p1649 = -(c12 * Lambda_0_11_p1599_lanes[3]);
  const Real Lambda_0_11_p1650 = -(c12 * Lambda_0_11_p1599_lanes[2]);
  const Real Lambda_0_11_p1651 = -(c12 * Lambda_0_11_p1599_lanes[1]);
  const Real Lambda_0_11_p1652 = -(c12 * Lambda_0_11_p1599_lanes[0]);
  const Lanes Lambda_0_11_p1653_lanes = Lambda_0_11_p14 *
      detail::make_lanes<Real>(Lambda_0_11_p1652, Lambda_0_11_p1651, Lambda_0_11_p1650,
      Lambda_0_11_p1649, Lambda_0_11_p1648, Lambda_0_11_p1647, Lambda_0_11_p1652,
      Lambda_0_11_p1652);
  const Lanes Lambda_0_11_p1659_lanes = Lambda_0_11_p1641_lanes - Lambda_0_11_p1653_lanes;
  const Lanes Lambda_0_11_p1665_lanes = c11 * Lambda_0_11_p1659_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p1671_lanes = Lambda_0_11_p22 * Lambda_0_11_p1587_lanes;

  // link 13 (left_hand), force propagation
  const Lanes Lambda_0_11_p1677_lanes = detail::make_lanes<Real>(c13, c13, c13, s13, s13, s13, c13,
      c13) * detail::make_lanes<Real>(Lambda_0_11_p1623, Lambda_0_11_p1623, Lambda_0_11_p1623,
      Lambda_0_11_p1622, Lambda_0_11_p1620, Lambda_0_11_p1618, Lambda_0_11_p1623,
      Lambda_0_11_p1623);
  const Lanes Lambda_0_11_p1681_lanes = detail::make_lanes<Real>(s13, s13, s13, c13, c13, c13, s13,
      s13) * detail::make_lanes<Real>(Lambda_0_11_p1624, Lambda_0_11_p1624, Lambda_0_11_p1624,
      Lambda_0_11_p1621, Lambda_0_11_p1619, Lambda_0_11_p1617, Lambda_0_11_p1624,
      Lambda_0_11_p1624);
  const Lanes Lambda_0_11_p1685_lanes = Lambda_0_11_p1677_lanes - Lambda_0_11_p1681_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p1689_lanes = detail::make_lanes<Real>(c13 * Lambda_0_11_p1627 + s13 *
      Lambda_0_11_p1628, c13 * Lambda_0_11_p1625 + s13 * Lambda_0_11_p1626,
      Lambda_0_11_p1685_lanes[2], Lambda_0_11_p1685_lanes[3], Lambda_0_11_p1685_lanes[4],
      Lambda_0_11_p1685_lanes[5], c13 * Lambda_0_11_p1627 + s13 * Lambda_0_11_p1628, c13 *
      Lambda_0_11_p1627 + s13 * Lambda_0_11_p1628) - Lambda_0_11_p1671_lanes;
  const Lanes Lambda_0_11_p1695_lanes = s12 * Lambda_0_11_p1689_lanes;
  const Real Lambda_0_11_p1701 = Lambda_0_11_p25 * Lambda_0_11_p1587_lanes[5];
  const Real Lambda_0_11_p1702 = Lambda_0_11_p25 * Lambda_0_11_p1587_lanes[4];
  const Real Lambda_0_11_p1703 = Lambda_0_11_p25 * Lambda_0_11_p1587_lanes[3];
  const Lanes Lambda_0_11_p1704_lanes = Lambda_0_11_p25 * Lambda_0_11_p1587_lanes;
  const Lanes Lambda_0_11_p1707_lanes = Lambda_0_11_p1522_lanes + Lambda_0_11_p1704_lanes;
  const Lanes Lambda_0_11_p1710_lanes = c12 * detail::make_lanes<Real>(Lambda_0_11_p1707_lanes[0],
      Lambda_0_11_p1707_lanes[1], Lambda_0_11_p1707_lanes[2], Lambda_0_11_p1703, Lambda_0_11_p1702,
      Lambda_0_11_p1701, Lambda_0_11_p1707_lanes[0], Lambda_0_11_p1707_lanes[0]);
  const Lanes Lambda_0_11_p1716_lanes = Lambda_0_11_p1695_lanes - Lambda_0_11_p1710_lanes;
  const Lanes Lambda_0_11_p1722_lanes = 0.269 * Lambda_0_11_p1716_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p1728_lanes = Lambda_0_11_p30 *
      detail::make_lanes<Real>(Lambda_0_11_p1652, Lambda_0_11_p1651, Lambda_0_11_p1650,
      Lambda_0_11_p1649, Lambda_0_11_p1648, Lambda_0_11_p1647, Lambda_0_11_p1652,
      Lambda_0_11_p1652);
  const Lanes Lambda_0_11_p1734_lanes = Lambda_0_11_p1722_lanes - Lambda_0_11_p1728_lanes;
  const Lanes Lambda_0_11_p1740_lanes = s11 * Lambda_0_11_p1734_lanes;
  const Lanes Lambda_0_11_p1746_lanes = Lambda_0_11_p1665_lanes - Lambda_0_11_p1740_lanes;
  const Lanes Lambda_0_11_p1752_lanes = s11 * Lambda_0_11_p1659_lanes;
  const Lanes Lambda_0_11_p1758_lanes = c11 * Lambda_0_11_p1734_lanes;
  const Lanes Lambda_0_11_p1764_lanes = Lambda_0_11_p1752_lanes + Lambda_0_11_p1758_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p1770_lanes = Lambda_0_11_p48 * Lambda_0_11_p1764_lanes;
  const Lanes Lambda_0_11_p1776_lanes = Lambda_0_11_p1746_lanes - Lambda_0_11_p1770_lanes;
  const Lanes Lambda_0_11_p1782_lanes = c10 * Lambda_0_11_p1776_lanes;
  const Lanes Lambda_0_11_p1788_lanes = Lambda_0_11_p51 * Lambda_0_11_p1764_lanes;
  const Lanes Lambda_0_11_p1794_lanes = s10 * Lambda_0_11_p1788_lanes;
  const Lanes Lambda_0_11_p1800_lanes = Lambda_0_11_p1794_lanes - Lambda_0_11_p1782_lanes;
  const Lanes Lambda_0_11_p1806_lanes = Lambda_0_11_p66 * Lambda_0_11_p1764_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p1812_lanes = Lambda_0_11_p56 *
      detail::make_lanes<Real>(Lambda_0_11_p1652, Lambda_0_11_p1651, Lambda_0_11_p1650,
      Lambda_0_11_p1649, Lambda_0_11_p1648, Lambda_0_11_p1647, Lambda_0_11_p1652,
      Lambda_0_11_p1652);
  const Lanes Lambda_0_11_p1818_lanes = detail::make_lanes<Real>(-Lambda_0_11_p1716_lanes[0],
      -Lambda_0_11_p1716_lanes[1], -Lambda_0_11_p1716_lanes[2], -Lambda_0_11_p1716_lanes[3],
      -Lambda_0_11_p1716_lanes[4], -Lambda_0_11_p1716_lanes[5], -Lambda_0_11_p1716_lanes[0],
      -Lambda_0_11_p1716_lanes[0]) - Lambda_0_11_p1812_lanes;
  const Lanes Lambda_0_11_p1824_lanes = s11 * Lambda_0_11_p1818_lanes;
  const Lanes Lambda_0_11_p1830_lanes = Lambda_0_11_p59 *
      detail::make_lanes<Real>(Lambda_0_11_p1652, Lambda_0_11_p1651, Lambda_0_11_p1650,
      Lambda_0_11_p1649, Lambda_0_11_p1648, Lambda_0_11_p1647, Lambda_0_11_p1652,
      Lambda_0_11_p1652);
  const Lanes Lambda_0_11_p1836_lanes = Lambda_0_11_p1629_lanes - Lambda_0_11_p1830_lanes;
  const Lanes Lambda_0_11_p1842_lanes = c11 * Lambda_0_11_p1836_lanes;
  const Lanes Lambda_0_11_p1848_lanes = Lambda_0_11_p1824_lanes + Lambda_0_11_p1842_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p1854_lanes = Lambda_0_11_p1848_lanes - Lambda_0_11_p1806_lanes;
  const Lanes Lambda_0_11_p1860_lanes = 0.282 * Lambda_0_11_p1854_lanes;
  const Lanes Lambda_0_11_p1866_lanes = Lambda_0_11_p1860_lanes - Lambda_0_11_p1800_lanes;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_0_11_p1872 = -(s10 * Lambda_0_11_p1776_lanes[5] + c10 *
      Lambda_0_11_p1788_lanes[5]);
  const Real Lambda_0_11_p1873 = -(s10 * Lambda_0_11_p1776_lanes[4] + c10 *
      Lambda_0_11_p1788_lanes[4]);
  const Real Lambda_0_11_p1874 = -(s10 * Lambda_0_11_p1776_lanes[3] + c10 *
      Lambda_0_11_p1788_lanes[3]);
  const Real Lambda_0_11_p1875 = -(s10 * Lambda_0_11_p1776_lanes[2] + c10 *
      Lambda_0_11_p1788_lanes[2]);
  const Real Lambda_0_11_p1876 = -(s10 * Lambda_0_11_p1776_lanes[1] + c10 *
      Lambda_0_11_p1788_lanes[1]);
  const Real Lambda_0_11_p1877 = -(s10 * Lambda_0_11_p1776_lanes[0] + c10 *
      Lambda_0_11_p1788_lanes[0]);
  const Lanes Lambda_0_11_p1878_lanes = inverse_D8_p1 *
      detail::make_lanes<Real>(Lambda_0_11_p1877, Lambda_0_11_p1876, Lambda_0_11_p1875,
      Lambda_0_11_p1874, Lambda_0_11_p1873, Lambda_0_11_p1872, Lambda_0_11_p1877,
      Lambda_0_11_p1877);
  const Lanes Lambda_0_11_p1884_lanes = Lambda_0_11_p1866_lanes + Lambda_0_11_p1878_lanes;
  const Lanes Lambda_0_11_p1890_lanes = s9 * Lambda_0_11_p1884_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p1896_lanes = Lambda_0_11_p82 * Lambda_0_11_p1764_lanes;
  const Lanes Lambda_0_11_p1902_lanes = detail::make_lanes<Real>(-(-(s12 *
      Lambda_0_11_p1707_lanes[0] + c12 * Lambda_0_11_p1689_lanes[0]) - Lambda_0_11_p77 *
      Lambda_0_11_p1652), -(-(s12 * Lambda_0_11_p1707_lanes[1] + c12 * Lambda_0_11_p1689_lanes[1]) -
      Lambda_0_11_p77 * Lambda_0_11_p1651), -(-(s12 * Lambda_0_11_p1707_lanes[2] + c12 *
      Lambda_0_11_p1689_lanes[2]) - Lambda_0_11_p77 * Lambda_0_11_p1650),
      -(-(s12 * Lambda_0_11_p1703 + c12 * Lambda_0_11_p1689_lanes[3]) - Lambda_0_11_p77 *
      Lambda_0_11_p1649), -(-(s12 * Lambda_0_11_p1702 + c12 * Lambda_0_11_p1689_lanes[4]) -
      Lambda_0_11_p77 * Lambda_0_11_p1648), -(-(s12 * Lambda_0_11_p1701 + c12 *
      Lambda_0_11_p1689_lanes[5]) - Lambda_0_11_p77 * Lambda_0_11_p1647),
      -(-(s12 * Lambda_0_11_p1707_lanes[0] + c12 * Lambda_0_11_p1689_lanes[0]) - Lambda_0_11_p77 *
      Lambda_0_11_p1652), -(-(s12 * Lambda_0_11_p1707_lanes[0] + c12 * Lambda_0_11_p1689_lanes[0]) -
      Lambda_0_11_p77 * Lambda_0_11_p1652)) - Lambda_0_11_p1896_lanes;
  const Lanes Lambda_0_11_p1908_lanes = s10 * Lambda_0_11_p1902_lanes;
  const Lanes Lambda_0_11_p1914_lanes = Lambda_0_11_p73 * Lambda_0_11_p1764_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p1920_lanes = c11 * Lambda_0_11_p1818_lanes;
  const Lanes Lambda_0_11_p1926_lanes = s11 * Lambda_0_11_p1836_lanes;
  const Lanes Lambda_0_11_p1932_lanes = Lambda_0_11_p1920_lanes - Lambda_0_11_p1926_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p1938_lanes = Lambda_0_11_p1932_lanes - Lambda_0_11_p1914_lanes;
  const Lanes Lambda_0_11_p1944_lanes = c10 * Lambda_0_11_p1938_lanes;
  const Lanes Lambda_0_11_p1950_lanes = Lambda_0_11_p1908_lanes - Lambda_0_11_p1944_lanes;
  const Lanes Lambda_0_11_p1956_lanes = 0.282 * Lambda_0_11_p1950_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p1962_lanes = inverse_D8_p3 *
      detail::make_lanes<Real>(Lambda_0_11_p1877, Lambda_0_11_p1876, Lambda_0_11_p1875,
      Lambda_0_11_p1874, Lambda_0_11_p1873, Lambda_0_11_p1872, Lambda_0_11_p1877,
      Lambda_0_11_p1877);
  const Lanes Lambda_0_11_p1968_lanes = Lambda_0_11_p1956_lanes - Lambda_0_11_p1962_lanes;
  const Lanes Lambda_0_11_p1974_lanes = c9 * Lambda_0_11_p1968_lanes;
  const Lanes Lambda_0_11_p1980_lanes = Lambda_0_11_p1890_lanes + Lambda_0_11_p1974_lanes;
  const Lanes Lambda_0_11_p1986_lanes = c9 * Lambda_0_11_p1884_lanes;
  const Lanes Lambda_0_11_p1992_lanes = s9 * Lambda_0_11_p1968_lanes;
  const Lanes Lambda_0_11_p1998_lanes = Lambda_0_11_p1986_lanes - Lambda_0_11_p1992_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p2004_lanes = inverse_D7_p1 * Lambda_0_11_p1998_lanes;
  const Lanes Lambda_0_11_p2010_lanes = Lambda_0_11_p1980_lanes - Lambda_0_11_p2004_lanes;
  const Lanes Lambda_0_11_p2016_lanes = c8 * Lambda_0_11_p2010_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_0_11_p2022 = 0.00010499999999999999 / inverse_D8_p9;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p2023_lanes = Lambda_0_11_p2022 * Lambda_0_11_p1998_lanes;
  const Lanes Lambda_0_11_p2029_lanes = s8 * Lambda_0_11_p2023_lanes;
  const Lanes Lambda_0_11_p2035_lanes = Lambda_0_11_p2029_lanes + Lambda_0_11_p2016_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p2041_lanes = detail::make_lanes<Real>(Lambda_0_11_p129, Lambda_0_11_p129,
      Lambda_0_11_p129, Lambda_0_11_p129, Lambda_0_11_p129, Lambda_0_11_p129, Lambda_0_11_p305,
      Lambda_0_11_p305) * detail::make_lanes<Real>(Lambda_0_11_p2035_lanes[0],
      Lambda_0_11_p2035_lanes[1], Lambda_0_11_p2035_lanes[2], Lambda_0_11_p2035_lanes[3],
      Lambda_0_11_p2035_lanes[4], Lambda_0_11_p2035_lanes[5], Lambda_0_11_p1479, Lambda_0_11_p1450);

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p2049 = -Lambda_0_11_p1445 - Lambda_0_11_p266 * Lambda_0_11_p1441;
  const Real Lambda_0_11_p2050 = Lambda_0_11_p1440 - Lambda_0_11_p281 * Lambda_0_11_p1441;
  const Real Lambda_0_11_p2051 = -Lambda_0_11_p1474 - Lambda_0_11_p266 * Lambda_0_11_p1470;
  const Real Lambda_0_11_p2052 = Lambda_0_11_p1469 - Lambda_0_11_p281 * Lambda_0_11_p1470;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p2053_lanes = Lambda_0_11_p123 * Lambda_0_11_p1998_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p2059_lanes = Lambda_0_11_p90 *
      detail::make_lanes<Real>(Lambda_0_11_p1877, Lambda_0_11_p1876, Lambda_0_11_p1875,
      Lambda_0_11_p1874, Lambda_0_11_p1873, Lambda_0_11_p1872, Lambda_0_11_p1877,
      Lambda_0_11_p1877);
  const Lanes Lambda_0_11_p2065_lanes = detail::make_lanes<Real>(-Lambda_0_11_p1950_lanes[0],
      -Lambda_0_11_p1950_lanes[1], -Lambda_0_11_p1950_lanes[2], -Lambda_0_11_p1950_lanes[3],
      -Lambda_0_11_p1950_lanes[4], -Lambda_0_11_p1950_lanes[5], -Lambda_0_11_p1950_lanes[0],
      -Lambda_0_11_p1950_lanes[0]) + Lambda_0_11_p2059_lanes;
  const Lanes Lambda_0_11_p2071_lanes = c9 * Lambda_0_11_p2065_lanes;
  const Lanes Lambda_0_11_p2077_lanes = Lambda_0_11_p105 *
      detail::make_lanes<Real>(Lambda_0_11_p1877, Lambda_0_11_p1876, Lambda_0_11_p1875,
      Lambda_0_11_p1874, Lambda_0_11_p1873, Lambda_0_11_p1872, Lambda_0_11_p1877,
      Lambda_0_11_p1877);
  const Lanes Lambda_0_11_p2083_lanes = Lambda_0_11_p1854_lanes + Lambda_0_11_p2077_lanes;
  const Lanes Lambda_0_11_p2089_lanes = s9 * Lambda_0_11_p2083_lanes;
  const Lanes Lambda_0_11_p2095_lanes = Lambda_0_11_p2071_lanes - Lambda_0_11_p2089_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p2101_lanes = Lambda_0_11_p2095_lanes - Lambda_0_11_p2053_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p2107_lanes = detail::make_lanes<Real>(Lambda_0_11_p2101_lanes[0],
      Lambda_0_11_p2101_lanes[1], Lambda_0_11_p2101_lanes[2], Lambda_0_11_p2101_lanes[3],
      Lambda_0_11_p2101_lanes[4], Lambda_0_11_p2101_lanes[5], c16 * Lambda_0_11_p2051 - s16 *
      Lambda_0_11_p2052 - Lambda_0_11_p299 * Lambda_0_11_p1476, c16 * Lambda_0_11_p2049 - s16 *
      Lambda_0_11_p2050 - Lambda_0_11_p299 * Lambda_0_11_p1447) - Lambda_0_11_p2041_lanes;
  const Lanes Lambda_0_11_p2115_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_0_11_p2107_lanes;
  const Lanes Lambda_0_11_p2123_lanes = detail::make_lanes<Real>(Lambda_0_11_p148, Lambda_0_11_p148,
      Lambda_0_11_p148, Lambda_0_11_p148, Lambda_0_11_p148, Lambda_0_11_p148, Lambda_0_11_p324,
      Lambda_0_11_p324) * detail::make_lanes<Real>(Lambda_0_11_p2035_lanes[0],
      Lambda_0_11_p2035_lanes[1], Lambda_0_11_p2035_lanes[2], Lambda_0_11_p2035_lanes[3],
      Lambda_0_11_p2035_lanes[4], Lambda_0_11_p2035_lanes[5], Lambda_0_11_p1479, Lambda_0_11_p1450);

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p2131 = -(-(s17 * Lambda_0_11_p1443 + c17 * Lambda_0_11_p1444) +
      Lambda_0_11_p311 * Lambda_0_11_p1441) - Lambda_0_11_p317 * Lambda_0_11_p1447;
  const Real Lambda_0_11_p2132 = s16 * Lambda_0_11_p2049 + c16 * Lambda_0_11_p2050 -
      Lambda_0_11_p308 * Lambda_0_11_p1447;
  const Real Lambda_0_11_p2133 = s16 * Lambda_0_11_p2051 + c16 * Lambda_0_11_p2052 -
      Lambda_0_11_p308 * Lambda_0_11_p1476;
  const Real Lambda_0_11_p2134 = -(-(s17 * Lambda_0_11_p1472 + c17 * Lambda_0_11_p1473) +
      Lambda_0_11_p311 * Lambda_0_11_p1470) - Lambda_0_11_p317 * Lambda_0_11_p1476;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p2135_lanes = Lambda_0_11_p138 * Lambda_0_11_p1998_lanes;
  const Lanes Lambda_0_11_p2141_lanes = detail::make_lanes<Real>(-(-(s10 *
      Lambda_0_11_p1938_lanes[0] + c10 * Lambda_0_11_p1902_lanes[0]) - Lambda_0_11_p132 *
      Lambda_0_11_p1877), -(-(s10 * Lambda_0_11_p1938_lanes[1] + c10 * Lambda_0_11_p1902_lanes[1]) -
      Lambda_0_11_p132 * Lambda_0_11_p1876), -(-(s10 * Lambda_0_11_p1938_lanes[2] + c10 *
      Lambda_0_11_p1902_lanes[2]) - Lambda_0_11_p132 * Lambda_0_11_p1875),
      -(-(s10 * Lambda_0_11_p1938_lanes[3] + c10 * Lambda_0_11_p1902_lanes[3]) - Lambda_0_11_p132 *
      Lambda_0_11_p1874), -(-(s10 * Lambda_0_11_p1938_lanes[4] + c10 * Lambda_0_11_p1902_lanes[4]) -
      Lambda_0_11_p132 * Lambda_0_11_p1873), -(-(s10 * Lambda_0_11_p1938_lanes[5] + c10 *
      Lambda_0_11_p1902_lanes[5]) - Lambda_0_11_p132 * Lambda_0_11_p1872),
      -(-(s10 * Lambda_0_11_p1938_lanes[0] + c10 * Lambda_0_11_p1902_lanes[0]) - Lambda_0_11_p132 *
      Lambda_0_11_p1877), -(-(s10 * Lambda_0_11_p1938_lanes[0] + c10 * Lambda_0_11_p1902_lanes[0]) -
      Lambda_0_11_p132 * Lambda_0_11_p1877)) + Lambda_0_11_p2135_lanes;
  const Lanes Lambda_0_11_p2147_lanes = c8 * Lambda_0_11_p2141_lanes;
  const Lanes Lambda_0_11_p2153_lanes = Lambda_0_11_p141 * Lambda_0_11_p1998_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p2159_lanes = s9 * Lambda_0_11_p2065_lanes;
  const Lanes Lambda_0_11_p2165_lanes = c9 * Lambda_0_11_p2083_lanes;
  const Lanes Lambda_0_11_p2171_lanes = Lambda_0_11_p2159_lanes + Lambda_0_11_p2165_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p2177_lanes = Lambda_0_11_p2171_lanes - Lambda_0_11_p2153_lanes;
  const Lanes Lambda_0_11_p2183_lanes = s8 * Lambda_0_11_p2177_lanes;
  const Lanes Lambda_0_11_p2189_lanes = Lambda_0_11_p2147_lanes - Lambda_0_11_p2183_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p2195_lanes = detail::make_lanes<Real>(Lambda_0_11_p2189_lanes[0],
      Lambda_0_11_p2189_lanes[1], Lambda_0_11_p2189_lanes[2], Lambda_0_11_p2189_lanes[3],
      Lambda_0_11_p2189_lanes[4], Lambda_0_11_p2189_lanes[5], c15 * Lambda_0_11_p2134 - s15 *
      Lambda_0_11_p2133, c15 * Lambda_0_11_p2131 - s15 * Lambda_0_11_p2132) -
      Lambda_0_11_p2123_lanes;
  const Lanes Lambda_0_11_p2203_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      Lambda_0_11_p2195_lanes;
  const Lanes Lambda_0_11_p2211_lanes = Lambda_0_11_p2115_lanes + Lambda_0_11_p2203_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_0_11_p2219 = 2.6249999999999998e-05 / inverse_D7_p8;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p2220_lanes = Lambda_0_11_p2219 * Lambda_0_11_p2035_lanes;
  const Lanes Lambda_0_11_p2226_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, 0.18,
      0.18) * detail::make_lanes<Real>(Lambda_0_11_p2220_lanes[0], Lambda_0_11_p2220_lanes[1],
      Lambda_0_11_p2220_lanes[2], Lambda_0_11_p2220_lanes[3], Lambda_0_11_p2220_lanes[4],
      Lambda_0_11_p2220_lanes[5], Lambda_0_11_p2211_lanes[6], Lambda_0_11_p2211_lanes[7]);
  const Lanes Lambda_0_11_p2234_lanes = detail::make_lanes<Real>(Lambda_0_11_p179, Lambda_0_11_p179,
      Lambda_0_11_p179, Lambda_0_11_p179, Lambda_0_11_p179, Lambda_0_11_p179, Lambda_0_11_p334,
      Lambda_0_11_p334) * detail::make_lanes<Real>(Lambda_0_11_p2035_lanes[0],
      Lambda_0_11_p2035_lanes[1], Lambda_0_11_p2035_lanes[2], Lambda_0_11_p2035_lanes[3],
      Lambda_0_11_p2035_lanes[4], Lambda_0_11_p2035_lanes[5], Lambda_0_11_p1479, Lambda_0_11_p1450);

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p2242_lanes = s8 * Lambda_0_11_p2141_lanes;
  const Lanes Lambda_0_11_p2248_lanes = c8 * Lambda_0_11_p2177_lanes;
  const Lanes Lambda_0_11_p2254_lanes = Lambda_0_11_p2242_lanes + Lambda_0_11_p2248_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p2260_lanes = detail::make_lanes<Real>(Lambda_0_11_p2254_lanes[0],
      Lambda_0_11_p2254_lanes[1], Lambda_0_11_p2254_lanes[2], Lambda_0_11_p2254_lanes[3],
      Lambda_0_11_p2254_lanes[4], Lambda_0_11_p2254_lanes[5], s15 * Lambda_0_11_p2134 + c15 *
      Lambda_0_11_p2133, s15 * Lambda_0_11_p2131 + c15 * Lambda_0_11_p2132) -
      Lambda_0_11_p2234_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p2268_lanes = s8 * Lambda_0_11_p2010_lanes;
  const Lanes Lambda_0_11_p2274_lanes = c8 * Lambda_0_11_p2023_lanes;
  const Lanes Lambda_0_11_p2280_lanes = Lambda_0_11_p2274_lanes - Lambda_0_11_p2268_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p2286_lanes = inverse_D6_p6 * Lambda_0_11_p2035_lanes;
  const Lanes Lambda_0_11_p2292_lanes = Lambda_0_11_p2280_lanes - Lambda_0_11_p2286_lanes;
  const Lanes Lambda_0_11_p2298_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, 0.226,
      0.226) * detail::make_lanes<Real>(Lambda_0_11_p2292_lanes[0], Lambda_0_11_p2292_lanes[1],
      Lambda_0_11_p2292_lanes[2], Lambda_0_11_p2292_lanes[3], Lambda_0_11_p2292_lanes[4],
      Lambda_0_11_p2292_lanes[5], Lambda_0_11_p2260_lanes[6], Lambda_0_11_p2260_lanes[7]);
  const Lanes Lambda_0_11_p2306_lanes = Lambda_0_11_p2226_lanes - Lambda_0_11_p2298_lanes;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_0_11_p2314 = Lambda_0_11_p1122 * Lambda_0_11_p1450;
  const Real Lambda_0_11_p2315 = Lambda_0_11_p1122 * Lambda_0_11_p1479;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p2316_lanes = detail::make_lanes<Real>(0.226, 0.226, 0.226, 0.226, 0.226,
      0.226, c14, c14) * detail::make_lanes<Real>(Lambda_0_11_p2260_lanes[0],
      Lambda_0_11_p2260_lanes[1], Lambda_0_11_p2260_lanes[2], Lambda_0_11_p2260_lanes[3],
      Lambda_0_11_p2260_lanes[4], Lambda_0_11_p2260_lanes[5], Lambda_0_11_p2315, Lambda_0_11_p2314);

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_0_11_p2324 = c15 * Lambda_0_11_p1448 - s15 * Lambda_0_11_p1449 - inverse_D6_p1 *
      Lambda_0_11_p1450;
  const Real Lambda_0_11_p2325 = c15 * Lambda_0_11_p1478 - s15 * Lambda_0_11_p1477 - inverse_D6_p1 *
      Lambda_0_11_p1479;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p2326_lanes = detail::make_lanes<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18,
      s14, s14) * detail::make_lanes<Real>(Lambda_0_11_p2211_lanes[0], Lambda_0_11_p2211_lanes[1],
      Lambda_0_11_p2211_lanes[2], Lambda_0_11_p2211_lanes[3], Lambda_0_11_p2211_lanes[4],
      Lambda_0_11_p2211_lanes[5], Lambda_0_11_p2325, Lambda_0_11_p2324);
  const Lanes Lambda_0_11_p2334_lanes = Lambda_0_11_p2316_lanes + Lambda_0_11_p2326_lanes;
  const Lanes Lambda_0_11_p2342_lanes = Lambda_0_11_p2306_lanes - Lambda_0_11_p2334_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p2350_lanes = inverse_D5_p14 * Lambda_0_11_p2342_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p2358_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      Lambda_0_11_p2107_lanes;
  const Lanes Lambda_0_11_p2366_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      Lambda_0_11_p2195_lanes;
  const Lanes Lambda_0_11_p2374_lanes = Lambda_0_11_p2358_lanes - Lambda_0_11_p2366_lanes;
  const Lanes Lambda_0_11_p2382_lanes = c7 * Lambda_0_11_p2292_lanes;
  const Lanes Lambda_0_11_p2388_lanes = s7 * Lambda_0_11_p2220_lanes;
  const Lanes Lambda_0_11_p2394_lanes = Lambda_0_11_p2388_lanes + Lambda_0_11_p2382_lanes;
  const Lanes Lambda_0_11_p2400_lanes = 0.18 * Lambda_0_11_p2374_lanes;
  const Lanes Lambda_0_11_p2406_lanes = Lambda_0_11_p2394_lanes + Lambda_0_11_p2400_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p2412_lanes = detail::make_lanes<Real>(Lambda_0_11_p2406_lanes[0],
      Lambda_0_11_p2406_lanes[1], Lambda_0_11_p2406_lanes[2], Lambda_0_11_p2406_lanes[3],
      Lambda_0_11_p2406_lanes[4], Lambda_0_11_p2406_lanes[5],
      -(s14 * Lambda_0_11_p2315 - c14 * Lambda_0_11_p2325 + 0.18 * Lambda_0_11_p2374_lanes[6]),
      -(s14 * Lambda_0_11_p2314 - c14 * Lambda_0_11_p2324 + 0.18 * Lambda_0_11_p2374_lanes[7])) -
      Lambda_0_11_p2350_lanes;
  const Lanes Lambda_0_11_p2420_lanes = s6 * Lambda_0_11_p2412_lanes;
  const Lanes Lambda_0_11_p2428_lanes = inverse_D5_p16 * Lambda_0_11_p2342_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p2436_lanes = 0.226 * Lambda_0_11_p2374_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p2444_lanes = Lambda_0_11_p2436_lanes - Lambda_0_11_p2428_lanes;
  const Lanes Lambda_0_11_p2452_lanes = c6 * Lambda_0_11_p2444_lanes;
  const Lanes Lambda_0_11_p2460_lanes = Lambda_0_11_p2420_lanes + Lambda_0_11_p2452_lanes;
  const Lanes Lambda_0_11_p2468_lanes = Lambda_0_11_p450 * Lambda_0_11_p2342_lanes;
  const Lanes Lambda_0_11_p2476_lanes = Lambda_0_11_p2374_lanes - Lambda_0_11_p2468_lanes;
  const Lanes Lambda_0_11_p2484_lanes = 0.072 * Lambda_0_11_p2476_lanes;
  const Lanes Lambda_0_11_p2492_lanes = Lambda_0_11_p2460_lanes + Lambda_0_11_p2484_lanes;
  const Lanes Lambda_0_11_p2500_lanes = Lambda_0_11_p410 * Lambda_0_11_p2342_lanes;
  const Lanes Lambda_0_11_p2508_lanes = Lambda_0_11_p2211_lanes - Lambda_0_11_p2500_lanes;
  const Lanes Lambda_0_11_p2516_lanes = s6 * Lambda_0_11_p2508_lanes;
  const Lanes Lambda_0_11_p2524_lanes = Lambda_0_11_p441 * Lambda_0_11_p2342_lanes;
  const Lanes Lambda_0_11_p2532_lanes = Lambda_0_11_p2260_lanes - Lambda_0_11_p2524_lanes;
  const Lanes Lambda_0_11_p2540_lanes = c6 * Lambda_0_11_p2532_lanes;
  const Lanes Lambda_0_11_p2548_lanes = Lambda_0_11_p2516_lanes + Lambda_0_11_p2540_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2556 = -(0.072 * Lambda_0_11_p2548_lanes[7]) + Lambda_0_11_p477 *
      Lambda_0_11_p2492_lanes[7];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p2557_lanes = c6 * Lambda_0_11_p2412_lanes;
  const Lanes Lambda_0_11_p2565_lanes = s6 * Lambda_0_11_p2444_lanes;
  const Lanes Lambda_0_11_p2573_lanes = Lambda_0_11_p2557_lanes - Lambda_0_11_p2565_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2581 = Lambda_0_11_p2573_lanes[7] - Lambda_0_11_p479 *
      Lambda_0_11_p2492_lanes[7];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p2582 = -(s5 * Lambda_0_11_p2556 + c5 * Lambda_0_11_p2581);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2583 = -(0.072 * Lambda_0_11_p2548_lanes[6]) + Lambda_0_11_p477 *
      Lambda_0_11_p2492_lanes[6];
  const Real Lambda_0_11_p2584 = Lambda_0_11_p2573_lanes[6] - Lambda_0_11_p479 *
      Lambda_0_11_p2492_lanes[6];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p2585 = -(s5 * Lambda_0_11_p2583 + c5 * Lambda_0_11_p2584);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2586 = -(0.072 * Lambda_0_11_p2548_lanes[5]) + Lambda_0_11_p477 *
      Lambda_0_11_p2492_lanes[5];
  const Real Lambda_0_11_p2587 = Lambda_0_11_p2573_lanes[5] - Lambda_0_11_p479 *
      Lambda_0_11_p2492_lanes[5];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p2588 = -(s5 * Lambda_0_11_p2586 + c5 * Lambda_0_11_p2587);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2589 = -(0.072 * Lambda_0_11_p2548_lanes[4]) + Lambda_0_11_p477 *
      Lambda_0_11_p2492_lanes[4];
  const Real Lambda_0_11_p2590 = Lambda_0_11_p2573_lanes[4] - Lambda_0_11_p479 *
      Lambda_0_11_p2492_lanes[4];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p2591 = -(s5 * Lambda_0_11_p2589 + c5 * Lambda_0_11_p2590);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2592 = -(0.072 * Lambda_0_11_p2548_lanes[3]) + Lambda_0_11_p477 *
      Lambda_0_11_p2492_lanes[3];
  const Real Lambda_0_11_p2593 = Lambda_0_11_p2573_lanes[3] - Lambda_0_11_p479 *
      Lambda_0_11_p2492_lanes[3];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p2594 = -(s5 * Lambda_0_11_p2592 + c5 * Lambda_0_11_p2593);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2595 = -(0.072 * Lambda_0_11_p2548_lanes[2]) + Lambda_0_11_p477 *
      Lambda_0_11_p2492_lanes[2];
  const Real Lambda_0_11_p2596 = Lambda_0_11_p2573_lanes[2] - Lambda_0_11_p479 *
      Lambda_0_11_p2492_lanes[2];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p2597 = -(s5 * Lambda_0_11_p2595 + c5 * Lambda_0_11_p2596);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2598 = -(0.072 * Lambda_0_11_p2548_lanes[1]) + Lambda_0_11_p477 *
      Lambda_0_11_p2492_lanes[1];
  const Real Lambda_0_11_p2599 = Lambda_0_11_p2573_lanes[1] - Lambda_0_11_p479 *
      Lambda_0_11_p2492_lanes[1];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p2600 = -(s5 * Lambda_0_11_p2598 + c5 * Lambda_0_11_p2599);

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2601 = -(0.072 * Lambda_0_11_p2548_lanes[0]) + Lambda_0_11_p477 *
      Lambda_0_11_p2492_lanes[0];
  const Real Lambda_0_11_p2602 = Lambda_0_11_p2573_lanes[0] - Lambda_0_11_p479 *
      Lambda_0_11_p2492_lanes[0];

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p2603 = -(s5 * Lambda_0_11_p2601 + c5 * Lambda_0_11_p2602);
  const Lanes Lambda_0_11_p2604_lanes = inverse_D3_p1 *
      detail::make_lanes<Real>(Lambda_0_11_p2603, Lambda_0_11_p2600, Lambda_0_11_p2597,
      Lambda_0_11_p2594, Lambda_0_11_p2591, Lambda_0_11_p2588, Lambda_0_11_p2585,
      Lambda_0_11_p2582);

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p2612_lanes = Lambda_0_11_p462 * Lambda_0_11_p2492_lanes;
  const Lanes Lambda_0_11_p2620_lanes = Lambda_0_11_p2548_lanes - Lambda_0_11_p2612_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p2628_lanes = detail::make_lanes<Real>(-(s5 * Lambda_0_11_p2602 - c5 *
      Lambda_0_11_p2601 + 0.21799999999999997 * Lambda_0_11_p2620_lanes[0]),
      -(s5 * Lambda_0_11_p2599 - c5 * Lambda_0_11_p2598 + 0.21799999999999997 *
      Lambda_0_11_p2620_lanes[1]), -(s5 * Lambda_0_11_p2596 - c5 * Lambda_0_11_p2595 +
      0.21799999999999997 * Lambda_0_11_p2620_lanes[2]),
      -(s5 * Lambda_0_11_p2593 - c5 * Lambda_0_11_p2592 + 0.21799999999999997 *
      Lambda_0_11_p2620_lanes[3]), -(s5 * Lambda_0_11_p2590 - c5 * Lambda_0_11_p2589 +
      0.21799999999999997 * Lambda_0_11_p2620_lanes[4]),
      -(s5 * Lambda_0_11_p2587 - c5 * Lambda_0_11_p2586 + 0.21799999999999997 *
      Lambda_0_11_p2620_lanes[5]), -(s5 * Lambda_0_11_p2584 - c5 * Lambda_0_11_p2583 +
      0.21799999999999997 * Lambda_0_11_p2620_lanes[6]),
      -(s5 * Lambda_0_11_p2581 - c5 * Lambda_0_11_p2556 + 0.21799999999999997 *
      Lambda_0_11_p2620_lanes[7])) - Lambda_0_11_p2604_lanes;
  const Lanes Lambda_0_11_p2636_lanes = s4 * Lambda_0_11_p2628_lanes;
  const Lanes Lambda_0_11_p2644_lanes = inverse_D3_p2 *
      detail::make_lanes<Real>(Lambda_0_11_p2603, Lambda_0_11_p2600, Lambda_0_11_p2597,
      Lambda_0_11_p2594, Lambda_0_11_p2591, Lambda_0_11_p2588, Lambda_0_11_p2585,
      Lambda_0_11_p2582);

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p2652_lanes = c6 * Lambda_0_11_p2508_lanes;
  const Lanes Lambda_0_11_p2660_lanes = s6 * Lambda_0_11_p2532_lanes;
  const Lanes Lambda_0_11_p2668_lanes = Lambda_0_11_p2652_lanes - Lambda_0_11_p2660_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p2676 = Lambda_0_11_p2668_lanes[7] - Lambda_0_11_p490 *
      Lambda_0_11_p2492_lanes[7];
  const Real Lambda_0_11_p2677 = Lambda_0_11_p2476_lanes[7] - Lambda_0_11_p486 *
      Lambda_0_11_p2492_lanes[7];
  const Real Lambda_0_11_p2678 = s5 * Lambda_0_11_p2676 - c5 * Lambda_0_11_p2677;
  const Real Lambda_0_11_p2679 = Lambda_0_11_p2668_lanes[6] - Lambda_0_11_p490 *
      Lambda_0_11_p2492_lanes[6];
  const Real Lambda_0_11_p2680 = Lambda_0_11_p2476_lanes[6] - Lambda_0_11_p486 *
      Lambda_0_11_p2492_lanes[6];
  const Real Lambda_0_11_p2681 = s5 * Lambda_0_11_p2679 - c5 * Lambda_0_11_p2680;
  const Real Lambda_0_11_p2682 = Lambda_0_11_p2668_lanes[5] - Lambda_0_11_p490 *
      Lambda_0_11_p2492_lanes[5];
  const Real Lambda_0_11_p2683 = Lambda_0_11_p2476_lanes[5] - Lambda_0_11_p486 *
      Lambda_0_11_p2492_lanes[5];
  const Real Lambda_0_11_p2684 = s5 * Lambda_0_11_p2682 - c5 * Lambda_0_11_p2683;
  const Real Lambda_0_11_p2685 = Lambda_0_11_p2668_lanes[4] - Lambda_0_11_p490 *
      Lambda_0_11_p2492_lanes[4];
  const Real Lambda_0_11_p2686 = Lambda_0_11_p2476_lanes[4] - Lambda_0_11_p486 *
      Lambda_0_11_p2492_lanes[4];
  const Real Lambda_0_11_p2687 = s5 * Lambda_0_11_p2685 - c5 * Lambda_0_11_p2686;
  const Real Lambda_0_11_p2688 = Lambda_0_11_p2668_lanes[3] - Lambda_0_11_p490 *
      Lambda_0_11_p2492_lanes[3];
  const Real Lambda_0_11_p2689 = Lambda_0_11_p2476_lanes[3] - Lambda_0_11_p486 *
      Lambda_0_11_p2492_lanes[3];
  const Real Lambda_0_11_p2690 = s5 * Lambda_0_11_p2688 - c5 * Lambda_0_11_p2689;
  const Real Lambda_0_11_p2691 = Lambda_0_11_p2668_lanes[2] - Lambda_0_11_p490 *
      Lambda_0_11_p2492_lanes[2];
  const Real Lambda_0_11_p2692 = Lambda_0_11_p2476_lanes[2] - Lambda_0_11_p486 *
      Lambda_0_11_p2492_lanes[2];
  const Real Lambda_0_11_p2693 = s5 * Lambda_0_11_p2691 - c5 * Lambda_0_11_p2692;
  const Real Lambda_0_11_p2694 = Lambda_0_11_p2668_lanes[1] - Lambda_0_11_p490 *
      Lambda_0_11_p2492_lanes[1];
  const Real Lambda_0_11_p2695 = Lambda_0_11_p2476_lanes[1] - Lambda_0_11_p486 *
      Lambda_0_11_p2492_lanes[1];
  const Real Lambda_0_11_p2696 = s5 * Lambda_0_11_p2694 - c5 * Lambda_0_11_p2695;
  const Real Lambda_0_11_p2697 = Lambda_0_11_p2668_lanes[0] - Lambda_0_11_p490 *
      Lambda_0_11_p2492_lanes[0];
  const Real Lambda_0_11_p2698 = Lambda_0_11_p2476_lanes[0] - Lambda_0_11_p486 *
      Lambda_0_11_p2492_lanes[0];
  const Real Lambda_0_11_p2699 = s5 * Lambda_0_11_p2697 - c5 * Lambda_0_11_p2698;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p2700_lanes = detail::make_lanes<Real>(-(0.21799999999999997 *
      Lambda_0_11_p2699), -(0.21799999999999997 * Lambda_0_11_p2696),
      -(0.21799999999999997 * Lambda_0_11_p2693), -(0.21799999999999997 * Lambda_0_11_p2690),
      -(0.21799999999999997 * Lambda_0_11_p2687), -(0.21799999999999997 * Lambda_0_11_p2684),
      -(0.21799999999999997 * Lambda_0_11_p2681), -(0.21799999999999997 * Lambda_0_11_p2678)) +
      Lambda_0_11_p2644_lanes;
  const Lanes Lambda_0_11_p2708_lanes = c4 * Lambda_0_11_p2700_lanes;
  const Lanes Lambda_0_11_p2716_lanes = Lambda_0_11_p2636_lanes + Lambda_0_11_p2708_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p2724_lanes = Lambda_0_11_p520 * Lambda_0_11_p2716_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p2732_lanes = Lambda_0_11_p498 *
      detail::make_lanes<Real>(Lambda_0_11_p2603, Lambda_0_11_p2600, Lambda_0_11_p2597,
      Lambda_0_11_p2594, Lambda_0_11_p2591, Lambda_0_11_p2588, Lambda_0_11_p2585,
      Lambda_0_11_p2582);
  const Lanes Lambda_0_11_p2740_lanes = detail::make_lanes<Real>(-Lambda_0_11_p2699,
      -Lambda_0_11_p2696, -Lambda_0_11_p2693, -Lambda_0_11_p2690, -Lambda_0_11_p2687,
      -Lambda_0_11_p2684, -Lambda_0_11_p2681, -Lambda_0_11_p2678) + Lambda_0_11_p2732_lanes;
  const Lanes Lambda_0_11_p2748_lanes = c4 * Lambda_0_11_p2740_lanes;
  const Lanes Lambda_0_11_p2756_lanes = Lambda_0_11_p507 *
      detail::make_lanes<Real>(Lambda_0_11_p2603, Lambda_0_11_p2600, Lambda_0_11_p2597,
      Lambda_0_11_p2594, Lambda_0_11_p2591, Lambda_0_11_p2588, Lambda_0_11_p2585,
      Lambda_0_11_p2582);
  const Lanes Lambda_0_11_p2764_lanes = Lambda_0_11_p2620_lanes + Lambda_0_11_p2756_lanes;
  const Lanes Lambda_0_11_p2772_lanes = s4 * Lambda_0_11_p2764_lanes;
  const Lanes Lambda_0_11_p2780_lanes = Lambda_0_11_p2748_lanes - Lambda_0_11_p2772_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p2788_lanes = Lambda_0_11_p2780_lanes - Lambda_0_11_p2724_lanes;
  const Lanes Lambda_0_11_p2796_lanes = c3 * Lambda_0_11_p2788_lanes;
  const Lanes Lambda_0_11_p2804_lanes = Lambda_0_11_p530 * Lambda_0_11_p2716_lanes;
  const Lanes Lambda_0_11_p2812_lanes = detail::make_lanes<Real>(-(-(s5 * Lambda_0_11_p2698 + c5 *
      Lambda_0_11_p2697) - Lambda_0_11_p525 * Lambda_0_11_p2603),
      -(-(s5 * Lambda_0_11_p2695 + c5 * Lambda_0_11_p2694) - Lambda_0_11_p525 * Lambda_0_11_p2600),
      -(-(s5 * Lambda_0_11_p2692 + c5 * Lambda_0_11_p2691) - Lambda_0_11_p525 * Lambda_0_11_p2597),
      -(-(s5 * Lambda_0_11_p2689 + c5 * Lambda_0_11_p2688) - Lambda_0_11_p525 * Lambda_0_11_p2594),
      -(-(s5 * Lambda_0_11_p2686 + c5 * Lambda_0_11_p2685) - Lambda_0_11_p525 * Lambda_0_11_p2591),
      -(-(s5 * Lambda_0_11_p2683 + c5 * Lambda_0_11_p2682) - Lambda_0_11_p525 * Lambda_0_11_p2588),
      -(-(s5 * Lambda_0_11_p2680 + c5 * Lambda_0_11_p2679) - Lambda_0_11_p525 * Lambda_0_11_p2585),
      -(-(s5 * Lambda_0_11_p2677 + c5 * Lambda_0_11_p2676) - Lambda_0_11_p525 *
      Lambda_0_11_p2582)) + Lambda_0_11_p2804_lanes;
  const Lanes Lambda_0_11_p2820_lanes = s3 * Lambda_0_11_p2812_lanes;
  const Lanes Lambda_0_11_p2828_lanes = Lambda_0_11_p2796_lanes - Lambda_0_11_p2820_lanes;
  const Lanes Lambda_0_11_p2836_lanes = 0.422 * Lambda_0_11_p2828_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p2844_lanes = Lambda_0_11_p537 * Lambda_0_11_p2836_lanes;
  const Lanes Lambda_0_11_p2852_lanes = Lambda_0_11_p2828_lanes - Lambda_0_11_p2844_lanes;
  const Lanes Lambda_0_11_p2860_lanes = c2 * Lambda_0_11_p2852_lanes;
  const Lanes Lambda_0_11_p2868_lanes = Lambda_0_11_p1385 * Lambda_0_11_p2836_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p2876_lanes = s3 * Lambda_0_11_p2788_lanes;
  const Lanes Lambda_0_11_p2884_lanes = c3 * Lambda_0_11_p2812_lanes;
  const Lanes Lambda_0_11_p2892_lanes = Lambda_0_11_p2876_lanes + Lambda_0_11_p2884_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p2900_lanes = Lambda_0_11_p2892_lanes - Lambda_0_11_p2868_lanes;
  const Lanes Lambda_0_11_p2908_lanes = s2 * Lambda_0_11_p2900_lanes;
  const Lanes Lambda_0_11_p2916_lanes = Lambda_0_11_p2860_lanes - Lambda_0_11_p2908_lanes;
  const Lanes Lambda_0_11_p2924_lanes = 0.434 * Lambda_0_11_p2916_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p2932_lanes = Lambda_0_11_p1418_lanes * Lambda_0_11_p2924_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p2936_lanes = Lambda_0_11_p1367_lanes * inverse_D2;
  const Lanes Lambda_0_11_p2940_lanes = Lambda_0_11_p2936_lanes * Lambda_0_11_p2836_lanes[0];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p2944_lanes = Lambda_0_11_p1307_lanes * inverse_D3;
  const Lanes Lambda_0_11_p2948_lanes = Lambda_0_11_p2944_lanes * Lambda_0_11_p2716_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p2952_lanes = detail::make_lanes<Real>(Lambda_0_11_p1250,
      Lambda_0_11_p1247, Lambda_0_11_p1244, Lambda_0_11_p1241, Lambda_0_11_p1250, Lambda_0_11_p1250,
      Lambda_0_11_p1250, Lambda_0_11_p1250) * inverse_D4;
  const Lanes Lambda_0_11_p2956_lanes = Lambda_0_11_p2952_lanes * Lambda_0_11_p2603;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p2960_lanes = Lambda_0_11_p1195_lanes * inverse_D5;
  const Lanes Lambda_0_11_p2964_lanes = Lambda_0_11_p2960_lanes * Lambda_0_11_p2492_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p2968_lanes = Lambda_0_11_p1135_lanes * inverse_D6;
  const Lanes Lambda_0_11_p2972_lanes = Lambda_0_11_p2968_lanes * Lambda_0_11_p2342_lanes[0];

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p2976_lanes = Lambda_0_11_p2972_lanes + Lambda_0_11_p2964_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p2980_lanes = Lambda_0_11_p2976_lanes + Lambda_0_11_p2956_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p2984_lanes = Lambda_0_11_p2980_lanes + Lambda_0_11_p2948_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p2988_lanes = Lambda_0_11_p2984_lanes + Lambda_0_11_p2940_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p2992_lanes = Lambda_0_11_p2988_lanes + Lambda_0_11_p2932_lanes;
  const Lanes Lambda_0_11_p2996_lanes = Lambda_0_11_p2924_lanes * inverse_D1;
  const Lanes Lambda_0_11_p3004_lanes = Lambda_0_11_p2996_lanes * Lambda_0_11_p2924_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3012_lanes = Lambda_0_11_p2836_lanes * inverse_D2;
  const Lanes Lambda_0_11_p3020_lanes = Lambda_0_11_p3012_lanes * Lambda_0_11_p2836_lanes[0];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3028_lanes = Lambda_0_11_p2716_lanes * inverse_D3;
  const Lanes Lambda_0_11_p3036_lanes = Lambda_0_11_p3028_lanes * Lambda_0_11_p2716_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3044_lanes = detail::make_lanes<Real>(Lambda_0_11_p2603,
      Lambda_0_11_p2600, Lambda_0_11_p2597, Lambda_0_11_p2594, Lambda_0_11_p2591, Lambda_0_11_p2588,
      Lambda_0_11_p2585, Lambda_0_11_p2582) * inverse_D4;
  const Lanes Lambda_0_11_p3052_lanes = Lambda_0_11_p3044_lanes * Lambda_0_11_p2603;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3060_lanes = Lambda_0_11_p2492_lanes * inverse_D5;
  const Lanes Lambda_0_11_p3068_lanes = Lambda_0_11_p3060_lanes * Lambda_0_11_p2492_lanes[0];

  // link 6 (chest3), force propagation
  const Real Lambda_0_11_p3076 = Lambda_0_11_p2342_lanes[7] * inverse_D6;
  const Real Lambda_0_11_p3077 = Lambda_0_11_p2342_lanes[6] * inverse_D6;
  const Lanes Lambda_0_11_p3078_lanes = Lambda_0_11_p2342_lanes * inverse_D6;
  const Lanes Lambda_0_11_p3084_lanes = Lambda_0_11_p3078_lanes * Lambda_0_11_p2342_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p3090_lanes = Lambda_0_11_p2035_lanes * inverse_D7;
  const Lanes Lambda_0_11_p3096_lanes = Lambda_0_11_p3090_lanes * Lambda_0_11_p2035_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p3102_lanes = Lambda_0_11_p1998_lanes * inverse_D8;
  const Lanes Lambda_0_11_p3108_lanes = Lambda_0_11_p3102_lanes * Lambda_0_11_p1998_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p3114_lanes = detail::make_lanes<Real>(Lambda_0_11_p1877,
      Lambda_0_11_p1876, Lambda_0_11_p1875, Lambda_0_11_p1874, Lambda_0_11_p1873, Lambda_0_11_p1872,
      Lambda_0_11_p1877, Lambda_0_11_p1877) * inverse_D9;
  const Lanes Lambda_0_11_p3120_lanes = Lambda_0_11_p3114_lanes * Lambda_0_11_p1877;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p3126_lanes = Lambda_0_11_p1764_lanes * inverse_D10;
  const Lanes Lambda_0_11_p3132_lanes = Lambda_0_11_p3126_lanes * Lambda_0_11_p1764_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p3138_lanes = detail::make_lanes<Real>(Lambda_0_11_p1652,
      Lambda_0_11_p1651, Lambda_0_11_p1650, Lambda_0_11_p1649, Lambda_0_11_p1648, Lambda_0_11_p1647,
      Lambda_0_11_p1652, Lambda_0_11_p1652) * inverse_D11;
  const Lanes Lambda_0_11_p3144_lanes = Lambda_0_11_p3138_lanes * Lambda_0_11_p1652;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p3150_lanes = Lambda_0_11_p1587_lanes * inverse_D12;
  const Lanes Lambda_0_11_p3156_lanes = Lambda_0_11_p3150_lanes * Lambda_0_11_p1587_lanes[0];

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p3162 = 0.086 * Lambda_0_11_p1542;

  // link 13 (left_hand), force propagation
  const Lanes Lambda_0_11_p3163_lanes = detail::make_lanes<Real>(91.62274020012977,
      91.62274020012977, 1065.380700001509, 1065.380700001509, 1065.380700001509, 1065.380700001509,
      91.62274020012977, 91.62274020012977) * detail::make_lanes<Real>(Lambda_0_11_p1542,
      Lambda_0_11_p1540, Lambda_0_11_p1538, Lambda_0_11_p1522_lanes[0], Lambda_0_11_p1522_lanes[1],
      Lambda_0_11_p1522_lanes[2], Lambda_0_11_p1542, Lambda_0_11_p1542);
  const Lanes Lambda_0_11_p3169_lanes = Lambda_0_11_p3163_lanes * Lambda_0_11_p3162;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p3175_lanes = Lambda_0_11_p3169_lanes + Lambda_0_11_p3156_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p3181_lanes = Lambda_0_11_p3175_lanes + Lambda_0_11_p3144_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p3187_lanes = Lambda_0_11_p3181_lanes + Lambda_0_11_p3132_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p3193_lanes = Lambda_0_11_p3187_lanes + Lambda_0_11_p3120_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p3199_lanes = Lambda_0_11_p3193_lanes + Lambda_0_11_p3108_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p3205_lanes = Lambda_0_11_p3199_lanes + Lambda_0_11_p3096_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p3211_lanes = Lambda_0_11_p3205_lanes + Lambda_0_11_p3084_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3217_lanes = detail::make_lanes<Real>(Lambda_0_11_p3211_lanes[0],
      Lambda_0_11_p3211_lanes[1], Lambda_0_11_p3211_lanes[2], Lambda_0_11_p3211_lanes[3],
      Lambda_0_11_p3211_lanes[4], Lambda_0_11_p3211_lanes[5], Lambda_0_11_p3077 *
      Lambda_0_11_p2342_lanes[0], Lambda_0_11_p3076 * Lambda_0_11_p2342_lanes[0]) +
      Lambda_0_11_p3068_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3225_lanes = Lambda_0_11_p3217_lanes + Lambda_0_11_p3052_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3233_lanes = Lambda_0_11_p3225_lanes + Lambda_0_11_p3036_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3241_lanes = Lambda_0_11_p3233_lanes + Lambda_0_11_p3020_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p3249_lanes = Lambda_0_11_p3241_lanes + Lambda_0_11_p3004_lanes;
  const Real Lambda_0_11_p3257 = 1.0 / Lambda_0_11_p3249_lanes[0];
  const Lanes Lambda_0_11_p3258_lanes = Lambda_0_11_p2992_lanes * Lambda_0_11_p3257;
  const Lanes Lambda_0_11_p3262_lanes = Lambda_0_11_p3258_lanes * Lambda_0_11_p3249_lanes[1];
  const Lanes Lambda_0_11_p3266_lanes = Lambda_0_11_p1418_lanes * Lambda_0_11_p2924_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3270_lanes = Lambda_0_11_p2936_lanes * Lambda_0_11_p2836_lanes[1];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3274_lanes = Lambda_0_11_p2944_lanes * Lambda_0_11_p2716_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3278_lanes = Lambda_0_11_p2952_lanes * Lambda_0_11_p2600;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3282_lanes = Lambda_0_11_p2960_lanes * Lambda_0_11_p2492_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p3286_lanes = Lambda_0_11_p2968_lanes * Lambda_0_11_p2342_lanes[1];

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3290_lanes = Lambda_0_11_p3286_lanes + Lambda_0_11_p3282_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3294_lanes = Lambda_0_11_p3290_lanes + Lambda_0_11_p3278_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3298_lanes = Lambda_0_11_p3294_lanes + Lambda_0_11_p3274_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3302_lanes = Lambda_0_11_p3298_lanes + Lambda_0_11_p3270_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p3306_lanes = Lambda_0_11_p3302_lanes + Lambda_0_11_p3266_lanes;
  const Lanes Lambda_0_11_p3310_lanes = Lambda_0_11_p3306_lanes - Lambda_0_11_p3262_lanes;
  const Lanes Lambda_0_11_p3314_lanes = Lambda_0_11_p3249_lanes * Lambda_0_11_p3257;
  const Lanes Lambda_0_11_p3321_lanes = Lambda_0_11_p3314_lanes * Lambda_0_11_p3249_lanes[1];
  const Lanes Lambda_0_11_p3328_lanes = Lambda_0_11_p2996_lanes * Lambda_0_11_p2924_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3335_lanes = Lambda_0_11_p3012_lanes * Lambda_0_11_p2836_lanes[1];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3342_lanes = Lambda_0_11_p3028_lanes * Lambda_0_11_p2716_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3349_lanes = Lambda_0_11_p3044_lanes * Lambda_0_11_p2600;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3356_lanes = Lambda_0_11_p3060_lanes * Lambda_0_11_p2492_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p3363_lanes = Lambda_0_11_p3078_lanes * Lambda_0_11_p2342_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p3368_lanes = Lambda_0_11_p3090_lanes * Lambda_0_11_p2035_lanes[1];

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p3373_lanes = Lambda_0_11_p3102_lanes * Lambda_0_11_p1998_lanes[1];

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p3378_lanes = Lambda_0_11_p3114_lanes * Lambda_0_11_p1876;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p3383_lanes = Lambda_0_11_p3126_lanes * Lambda_0_11_p1764_lanes[1];

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p3388_lanes = Lambda_0_11_p3138_lanes * Lambda_0_11_p1651;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p3393_lanes = Lambda_0_11_p3150_lanes * Lambda_0_11_p1587_lanes[1];

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p3398 = 0.086 * Lambda_0_11_p1540;

  // link 13 (left_hand), force propagation
  const Lanes Lambda_0_11_p3399_lanes = Lambda_0_11_p3163_lanes * Lambda_0_11_p3398;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p3404_lanes = Lambda_0_11_p3399_lanes + Lambda_0_11_p3393_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p3409_lanes = Lambda_0_11_p3404_lanes + Lambda_0_11_p3388_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p3414_lanes = Lambda_0_11_p3409_lanes + Lambda_0_11_p3383_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p3419_lanes = Lambda_0_11_p3414_lanes + Lambda_0_11_p3378_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p3424_lanes = Lambda_0_11_p3419_lanes + Lambda_0_11_p3373_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p3429_lanes = Lambda_0_11_p3424_lanes + Lambda_0_11_p3368_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p3434_lanes = Lambda_0_11_p3429_lanes + Lambda_0_11_p3363_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3439_lanes = detail::make_lanes<Real>(Lambda_0_11_p3434_lanes[1],
      Lambda_0_11_p3434_lanes[1], Lambda_0_11_p3434_lanes[2], Lambda_0_11_p3434_lanes[3],
      Lambda_0_11_p3434_lanes[4], Lambda_0_11_p3434_lanes[5], Lambda_0_11_p3077 *
      Lambda_0_11_p2342_lanes[1], Lambda_0_11_p3076 * Lambda_0_11_p2342_lanes[1]) +
      Lambda_0_11_p3356_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3446_lanes = Lambda_0_11_p3439_lanes + Lambda_0_11_p3349_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3453_lanes = Lambda_0_11_p3446_lanes + Lambda_0_11_p3342_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3460_lanes = Lambda_0_11_p3453_lanes + Lambda_0_11_p3335_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p3467_lanes = Lambda_0_11_p3460_lanes + Lambda_0_11_p3328_lanes;
  const Lanes Lambda_0_11_p3474_lanes = Lambda_0_11_p3467_lanes - Lambda_0_11_p3321_lanes;
  const Real Lambda_0_11_p3481 = 1.0 / Lambda_0_11_p3474_lanes[1];
  const Lanes Lambda_0_11_p3482_lanes = Lambda_0_11_p3310_lanes * Lambda_0_11_p3481;
  const Lanes Lambda_0_11_p3486_lanes = Lambda_0_11_p3482_lanes * Lambda_0_11_p3474_lanes[2];
  const Lanes Lambda_0_11_p3490_lanes = Lambda_0_11_p3258_lanes * Lambda_0_11_p3249_lanes[2];
  const Lanes Lambda_0_11_p3494_lanes = Lambda_0_11_p1418_lanes * Lambda_0_11_p2924_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3498_lanes = Lambda_0_11_p2936_lanes * Lambda_0_11_p2836_lanes[2];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3502_lanes = Lambda_0_11_p2944_lanes * Lambda_0_11_p2716_lanes[2];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3506_lanes = Lambda_0_11_p2952_lanes * Lambda_0_11_p2597;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3510_lanes = Lambda_0_11_p2960_lanes * Lambda_0_11_p2492_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p3514_lanes = Lambda_0_11_p2968_lanes * Lambda_0_11_p2342_lanes[2];

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3518_lanes = Lambda_0_11_p3514_lanes + Lambda_0_11_p3510_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3522_lanes = Lambda_0_11_p3518_lanes + Lambda_0_11_p3506_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3526_lanes = Lambda_0_11_p3522_lanes + Lambda_0_11_p3502_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3530_lanes = Lambda_0_11_p3526_lanes + Lambda_0_11_p3498_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p3534_lanes = Lambda_0_11_p3530_lanes + Lambda_0_11_p3494_lanes;
  const Lanes Lambda_0_11_p3538_lanes = Lambda_0_11_p3534_lanes - Lambda_0_11_p3490_lanes;
  const Lanes Lambda_0_11_p3542_lanes = Lambda_0_11_p3538_lanes - Lambda_0_11_p3486_lanes;
  const Lanes Lambda_0_11_p3546_lanes = Lambda_0_11_p3474_lanes * Lambda_0_11_p3481;
  const Lanes Lambda_0_11_p3552_lanes = Lambda_0_11_p3546_lanes * Lambda_0_11_p3474_lanes[2];
  const Lanes Lambda_0_11_p3558_lanes = Lambda_0_11_p3314_lanes * Lambda_0_11_p3249_lanes[2];
  const Lanes Lambda_0_11_p3564_lanes = Lambda_0_11_p2996_lanes * Lambda_0_11_p2924_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3570_lanes = Lambda_0_11_p3012_lanes * Lambda_0_11_p2836_lanes[2];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3576_lanes = Lambda_0_11_p3028_lanes * Lambda_0_11_p2716_lanes[2];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3582_lanes = Lambda_0_11_p3044_lanes * Lambda_0_11_p2597;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3588_lanes = Lambda_0_11_p3060_lanes * Lambda_0_11_p2492_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p3594_lanes = Lambda_0_11_p3078_lanes * Lambda_0_11_p2342_lanes[2];

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p3598_lanes = Lambda_0_11_p3090_lanes * Lambda_0_11_p2035_lanes[2];

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p3602_lanes = Lambda_0_11_p3102_lanes * Lambda_0_11_p1998_lanes[2];

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p3606_lanes = Lambda_0_11_p3114_lanes * Lambda_0_11_p1875;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p3610_lanes = Lambda_0_11_p3126_lanes * Lambda_0_11_p1764_lanes[2];

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p3614_lanes = Lambda_0_11_p3138_lanes * Lambda_0_11_p1650;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p3618_lanes = Lambda_0_11_p3150_lanes * Lambda_0_11_p1587_lanes[2];

  // link 13 (left_hand), force propagation
  const Lanes Lambda_0_11_p3622_lanes = Lambda_0_11_p3163_lanes * Lambda_0_11_p1538;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p3626_lanes = Lambda_0_11_p3622_lanes + Lambda_0_11_p3618_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p3630_lanes = Lambda_0_11_p3626_lanes + Lambda_0_11_p3614_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p3634_lanes = Lambda_0_11_p3630_lanes + Lambda_0_11_p3610_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p3638_lanes = Lambda_0_11_p3634_lanes + Lambda_0_11_p3606_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p3642_lanes = Lambda_0_11_p3638_lanes + Lambda_0_11_p3602_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p3646_lanes = Lambda_0_11_p3642_lanes + Lambda_0_11_p3598_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p3650_lanes = Lambda_0_11_p3646_lanes + Lambda_0_11_p3594_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3654_lanes = detail::make_lanes<Real>(Lambda_0_11_p3650_lanes[2],
      Lambda_0_11_p3650_lanes[2], Lambda_0_11_p3650_lanes[2], Lambda_0_11_p3650_lanes[3],
      Lambda_0_11_p3650_lanes[4], Lambda_0_11_p3650_lanes[5], Lambda_0_11_p3077 *
      Lambda_0_11_p2342_lanes[2], Lambda_0_11_p3076 * Lambda_0_11_p2342_lanes[2]) +
      Lambda_0_11_p3588_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3660_lanes = Lambda_0_11_p3654_lanes + Lambda_0_11_p3582_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3666_lanes = Lambda_0_11_p3660_lanes + Lambda_0_11_p3576_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3672_lanes = Lambda_0_11_p3666_lanes + Lambda_0_11_p3570_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p3678_lanes = Lambda_0_11_p3672_lanes + Lambda_0_11_p3564_lanes;
  const Lanes Lambda_0_11_p3684_lanes = Lambda_0_11_p3678_lanes - Lambda_0_11_p3558_lanes;
  const Lanes Lambda_0_11_p3690_lanes = Lambda_0_11_p3684_lanes - Lambda_0_11_p3552_lanes;
  const Real Lambda_0_11_p3696 = 1.0 / Lambda_0_11_p3690_lanes[2];
  const Lanes Lambda_0_11_p3697_lanes = Lambda_0_11_p3542_lanes * Lambda_0_11_p3696;
  const Lanes Lambda_0_11_p3701_lanes = Lambda_0_11_p3697_lanes * Lambda_0_11_p3690_lanes[3];
  const Lanes Lambda_0_11_p3705_lanes = Lambda_0_11_p3482_lanes * Lambda_0_11_p3474_lanes[3];
  const Lanes Lambda_0_11_p3709_lanes = Lambda_0_11_p3258_lanes * Lambda_0_11_p3249_lanes[3];
  const Lanes Lambda_0_11_p3713_lanes = Lambda_0_11_p1418_lanes * Lambda_0_11_p2924_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3717_lanes = Lambda_0_11_p2936_lanes * Lambda_0_11_p2836_lanes[3];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3721_lanes = Lambda_0_11_p2944_lanes * Lambda_0_11_p2716_lanes[3];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3725_lanes = Lambda_0_11_p2952_lanes * Lambda_0_11_p2594;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3729_lanes = Lambda_0_11_p2960_lanes * Lambda_0_11_p2492_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p3733_lanes = Lambda_0_11_p2968_lanes * Lambda_0_11_p2342_lanes[3];

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3737_lanes = Lambda_0_11_p3733_lanes + Lambda_0_11_p3729_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3741_lanes = Lambda_0_11_p3737_lanes + Lambda_0_11_p3725_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3745_lanes = Lambda_0_11_p3741_lanes + Lambda_0_11_p3721_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3749_lanes = Lambda_0_11_p3745_lanes + Lambda_0_11_p3717_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p3753_lanes = Lambda_0_11_p3749_lanes + Lambda_0_11_p3713_lanes;
  const Lanes Lambda_0_11_p3757_lanes = Lambda_0_11_p3753_lanes - Lambda_0_11_p3709_lanes;
  const Lanes Lambda_0_11_p3761_lanes = Lambda_0_11_p3757_lanes - Lambda_0_11_p3705_lanes;
  const Lanes Lambda_0_11_p3765_lanes = Lambda_0_11_p3761_lanes - Lambda_0_11_p3701_lanes;
  const Lanes Lambda_0_11_p3769_lanes = Lambda_0_11_p3690_lanes * Lambda_0_11_p3696;
  const Lanes Lambda_0_11_p3774_lanes = Lambda_0_11_p3769_lanes * Lambda_0_11_p3690_lanes[3];
  const Lanes Lambda_0_11_p3779_lanes = Lambda_0_11_p3546_lanes * Lambda_0_11_p3474_lanes[3];
  const Lanes Lambda_0_11_p3784_lanes = Lambda_0_11_p3314_lanes * Lambda_0_11_p3249_lanes[3];
  const Lanes Lambda_0_11_p3789_lanes = Lambda_0_11_p2996_lanes * Lambda_0_11_p2924_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3794_lanes = Lambda_0_11_p3012_lanes * Lambda_0_11_p2836_lanes[3];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3799_lanes = Lambda_0_11_p3028_lanes * Lambda_0_11_p2716_lanes[3];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3804_lanes = Lambda_0_11_p3044_lanes * Lambda_0_11_p2594;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3809_lanes = Lambda_0_11_p3060_lanes * Lambda_0_11_p2492_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p3814_lanes = Lambda_0_11_p3078_lanes * Lambda_0_11_p2342_lanes[3];

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p3817_lanes = Lambda_0_11_p3090_lanes * Lambda_0_11_p2035_lanes[3];

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p3820_lanes = Lambda_0_11_p3102_lanes * Lambda_0_11_p1998_lanes[3];

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p3823_lanes = Lambda_0_11_p3114_lanes * Lambda_0_11_p1874;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p3826_lanes = Lambda_0_11_p3126_lanes * Lambda_0_11_p1764_lanes[3];

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p3829_lanes = Lambda_0_11_p3138_lanes * Lambda_0_11_p1649;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p3832_lanes = Lambda_0_11_p3150_lanes * Lambda_0_11_p1587_lanes[3];

  // link 13 (left_hand), force propagation
  const Lanes Lambda_0_11_p3835_lanes = Lambda_0_11_p3163_lanes * Lambda_0_11_p1522_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p3838_lanes = Lambda_0_11_p3835_lanes + Lambda_0_11_p3832_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p3841_lanes = Lambda_0_11_p3838_lanes + Lambda_0_11_p3829_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p3844_lanes = Lambda_0_11_p3841_lanes + Lambda_0_11_p3826_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p3847_lanes = Lambda_0_11_p3844_lanes + Lambda_0_11_p3823_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p3850_lanes = Lambda_0_11_p3847_lanes + Lambda_0_11_p3820_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p3853_lanes = Lambda_0_11_p3850_lanes + Lambda_0_11_p3817_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p3856_lanes = Lambda_0_11_p3853_lanes + Lambda_0_11_p3814_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3859_lanes = detail::make_lanes<Real>(Lambda_0_11_p3856_lanes[3],
      Lambda_0_11_p3856_lanes[3], Lambda_0_11_p3856_lanes[3], Lambda_0_11_p3856_lanes[3],
      Lambda_0_11_p3856_lanes[4], Lambda_0_11_p3856_lanes[5], Lambda_0_11_p3077 *
      Lambda_0_11_p2342_lanes[3], Lambda_0_11_p3076 * Lambda_0_11_p2342_lanes[3]) +
      Lambda_0_11_p3809_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3864_lanes = Lambda_0_11_p3859_lanes + Lambda_0_11_p3804_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3869_lanes = Lambda_0_11_p3864_lanes + Lambda_0_11_p3799_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3874_lanes = Lambda_0_11_p3869_lanes + Lambda_0_11_p3794_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p3879_lanes = Lambda_0_11_p3874_lanes + Lambda_0_11_p3789_lanes;
  const Lanes Lambda_0_11_p3884_lanes = Lambda_0_11_p3879_lanes - Lambda_0_11_p3784_lanes;
  const Lanes Lambda_0_11_p3889_lanes = Lambda_0_11_p3884_lanes - Lambda_0_11_p3779_lanes;
  const Lanes Lambda_0_11_p3894_lanes = Lambda_0_11_p3889_lanes - Lambda_0_11_p3774_lanes;
  const Real Lambda_0_11_p3899 = 1.0 / Lambda_0_11_p3894_lanes[3];
  const Lanes Lambda_0_11_p3900_lanes = Lambda_0_11_p3765_lanes * Lambda_0_11_p3899;
  const Lanes Lambda_0_11_p3904_lanes = Lambda_0_11_p3900_lanes * Lambda_0_11_p3894_lanes[4];
  const Lanes Lambda_0_11_p3908_lanes = Lambda_0_11_p3697_lanes * Lambda_0_11_p3690_lanes[4];
  const Lanes Lambda_0_11_p3912_lanes = Lambda_0_11_p3482_lanes * Lambda_0_11_p3474_lanes[4];
  const Lanes Lambda_0_11_p3916_lanes = Lambda_0_11_p3258_lanes * Lambda_0_11_p3249_lanes[4];
  const Lanes Lambda_0_11_p3920_lanes = Lambda_0_11_p1418_lanes * Lambda_0_11_p2924_lanes[4];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3924_lanes = Lambda_0_11_p2936_lanes * Lambda_0_11_p2836_lanes[4];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3928_lanes = Lambda_0_11_p2944_lanes * Lambda_0_11_p2716_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3932_lanes = Lambda_0_11_p2952_lanes * Lambda_0_11_p2591;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3936_lanes = Lambda_0_11_p2960_lanes * Lambda_0_11_p2492_lanes[4];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p3940_lanes = Lambda_0_11_p2968_lanes * Lambda_0_11_p2342_lanes[4];

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p3944_lanes = Lambda_0_11_p3940_lanes + Lambda_0_11_p3936_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p3948_lanes = Lambda_0_11_p3944_lanes + Lambda_0_11_p3932_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p3952_lanes = Lambda_0_11_p3948_lanes + Lambda_0_11_p3928_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p3956_lanes = Lambda_0_11_p3952_lanes + Lambda_0_11_p3924_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p3960_lanes = Lambda_0_11_p3956_lanes + Lambda_0_11_p3920_lanes;
  const Lanes Lambda_0_11_p3964_lanes = Lambda_0_11_p3960_lanes - Lambda_0_11_p3916_lanes;
  const Lanes Lambda_0_11_p3968_lanes = Lambda_0_11_p3964_lanes - Lambda_0_11_p3912_lanes;
  const Lanes Lambda_0_11_p3972_lanes = Lambda_0_11_p3968_lanes - Lambda_0_11_p3908_lanes;
  const Lanes Lambda_0_11_p3976_lanes = Lambda_0_11_p3972_lanes - Lambda_0_11_p3904_lanes;
  const Lanes Lambda_0_11_p3980_lanes = Lambda_0_11_p3894_lanes * Lambda_0_11_p3899;
  const Lanes Lambda_0_11_p3984_lanes = Lambda_0_11_p3980_lanes * Lambda_0_11_p3894_lanes[4];
  const Lanes Lambda_0_11_p3988_lanes = Lambda_0_11_p3769_lanes * Lambda_0_11_p3690_lanes[4];
  const Lanes Lambda_0_11_p3992_lanes = Lambda_0_11_p3546_lanes * Lambda_0_11_p3474_lanes[4];
  const Lanes Lambda_0_11_p3996_lanes = Lambda_0_11_p3314_lanes * Lambda_0_11_p3249_lanes[4];
  const Lanes Lambda_0_11_p4000_lanes = Lambda_0_11_p2996_lanes * Lambda_0_11_p2924_lanes[4];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4004_lanes = Lambda_0_11_p3012_lanes * Lambda_0_11_p2836_lanes[4];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4008_lanes = Lambda_0_11_p3028_lanes * Lambda_0_11_p2716_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4012_lanes = Lambda_0_11_p3044_lanes * Lambda_0_11_p2591;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4016_lanes = Lambda_0_11_p3060_lanes * Lambda_0_11_p2492_lanes[4];

  // link 13 (left_hand), force propagation
  const Lanes Lambda_0_11_p4020_lanes = Lambda_0_11_p3163_lanes * Lambda_0_11_p1522_lanes[1];

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_0_11_p4022_lanes = Lambda_0_11_p4020_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p3150_lanes[4] * Lambda_0_11_p1587_lanes[4],
      Lambda_0_11_p3150_lanes[4] * Lambda_0_11_p1587_lanes[4], Lambda_0_11_p3150_lanes[4] *
      Lambda_0_11_p1587_lanes[4], Lambda_0_11_p3150_lanes[4] * Lambda_0_11_p1587_lanes[4],
      Lambda_0_11_p3150_lanes[4] * Lambda_0_11_p1587_lanes[4], Lambda_0_11_p3150_lanes[5] *
      Lambda_0_11_p1587_lanes[4], Lambda_0_11_p3150_lanes[4] * Lambda_0_11_p1587_lanes[4],
      Lambda_0_11_p3150_lanes[4] * Lambda_0_11_p1587_lanes[4]);

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_0_11_p4024_lanes = Lambda_0_11_p4022_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p3138_lanes[4] * Lambda_0_11_p1648,
      Lambda_0_11_p3138_lanes[4] * Lambda_0_11_p1648, Lambda_0_11_p3138_lanes[4] *
      Lambda_0_11_p1648, Lambda_0_11_p3138_lanes[4] * Lambda_0_11_p1648,
      Lambda_0_11_p3138_lanes[4] * Lambda_0_11_p1648, Lambda_0_11_p3138_lanes[5] *
      Lambda_0_11_p1648, Lambda_0_11_p3138_lanes[4] * Lambda_0_11_p1648,
      Lambda_0_11_p3138_lanes[4] * Lambda_0_11_p1648);

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_0_11_p4026_lanes = Lambda_0_11_p4024_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p3126_lanes[4] * Lambda_0_11_p1764_lanes[4],
      Lambda_0_11_p3126_lanes[4] * Lambda_0_11_p1764_lanes[4], Lambda_0_11_p3126_lanes[4] *
      Lambda_0_11_p1764_lanes[4], Lambda_0_11_p3126_lanes[4] * Lambda_0_11_p1764_lanes[4],
      Lambda_0_11_p3126_lanes[4] * Lambda_0_11_p1764_lanes[4], Lambda_0_11_p3126_lanes[5] *
      Lambda_0_11_p1764_lanes[4], Lambda_0_11_p3126_lanes[4] * Lambda_0_11_p1764_lanes[4],
      Lambda_0_11_p3126_lanes[4] * Lambda_0_11_p1764_lanes[4]);

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_0_11_p4028_lanes = Lambda_0_11_p4026_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p3114_lanes[4] * Lambda_0_11_p1873,
      Lambda_0_11_p3114_lanes[4] * Lambda_0_11_p1873, Lambda_0_11_p3114_lanes[4] *
      Lambda_0_11_p1873, Lambda_0_11_p3114_lanes[4] * Lambda_0_11_p1873,
      Lambda_0_11_p3114_lanes[4] * Lambda_0_11_p1873, Lambda_0_11_p3114_lanes[5] *
      Lambda_0_11_p1873, Lambda_0_11_p3114_lanes[4] * Lambda_0_11_p1873,
      Lambda_0_11_p3114_lanes[4] * Lambda_0_11_p1873);

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_0_11_p4030_lanes = Lambda_0_11_p4028_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p3102_lanes[4] * Lambda_0_11_p1998_lanes[4],
      Lambda_0_11_p3102_lanes[4] * Lambda_0_11_p1998_lanes[4], Lambda_0_11_p3102_lanes[4] *
      Lambda_0_11_p1998_lanes[4], Lambda_0_11_p3102_lanes[4] * Lambda_0_11_p1998_lanes[4],
      Lambda_0_11_p3102_lanes[4] * Lambda_0_11_p1998_lanes[4], Lambda_0_11_p3102_lanes[5] *
      Lambda_0_11_p1998_lanes[4], Lambda_0_11_p3102_lanes[4] * Lambda_0_11_p1998_lanes[4],
      Lambda_0_11_p3102_lanes[4] * Lambda_0_11_p1998_lanes[4]);

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_0_11_p4032_lanes = Lambda_0_11_p4030_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p3090_lanes[4] * Lambda_0_11_p2035_lanes[4],
      Lambda_0_11_p3090_lanes[4] * Lambda_0_11_p2035_lanes[4], Lambda_0_11_p3090_lanes[4] *
      Lambda_0_11_p2035_lanes[4], Lambda_0_11_p3090_lanes[4] * Lambda_0_11_p2035_lanes[4],
      Lambda_0_11_p3090_lanes[4] * Lambda_0_11_p2035_lanes[4], Lambda_0_11_p3090_lanes[5] *
      Lambda_0_11_p2035_lanes[4], Lambda_0_11_p3090_lanes[4] * Lambda_0_11_p2035_lanes[4],
      Lambda_0_11_p3090_lanes[4] * Lambda_0_11_p2035_lanes[4]);

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p4034_lanes = Lambda_0_11_p4032_lanes +
      detail::make_lanes<Real>(Lambda_0_11_p3078_lanes[4] * Lambda_0_11_p2342_lanes[4],
      Lambda_0_11_p3078_lanes[4] * Lambda_0_11_p2342_lanes[4], Lambda_0_11_p3078_lanes[4] *
      Lambda_0_11_p2342_lanes[4], Lambda_0_11_p3078_lanes[4] * Lambda_0_11_p2342_lanes[4],
      Lambda_0_11_p3078_lanes[4] * Lambda_0_11_p2342_lanes[4], Lambda_0_11_p3078_lanes[5] *
      Lambda_0_11_p2342_lanes[4], Lambda_0_11_p3078_lanes[4] * Lambda_0_11_p2342_lanes[4],
      Lambda_0_11_p3078_lanes[4] * Lambda_0_11_p2342_lanes[4]);

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4036_lanes = detail::make_lanes<Real>(Lambda_0_11_p4034_lanes[4],
      Lambda_0_11_p4034_lanes[4], Lambda_0_11_p4034_lanes[4], Lambda_0_11_p4034_lanes[4],
      Lambda_0_11_p4034_lanes[4], Lambda_0_11_p4034_lanes[5], Lambda_0_11_p3077 *
      Lambda_0_11_p2342_lanes[4], Lambda_0_11_p3076 * Lambda_0_11_p2342_lanes[4]) +
      Lambda_0_11_p4016_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4040_lanes = Lambda_0_11_p4036_lanes + Lambda_0_11_p4012_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4044_lanes = Lambda_0_11_p4040_lanes + Lambda_0_11_p4008_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4048_lanes = Lambda_0_11_p4044_lanes + Lambda_0_11_p4004_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p4052_lanes = Lambda_0_11_p4048_lanes + Lambda_0_11_p4000_lanes;
  const Lanes Lambda_0_11_p4056_lanes = Lambda_0_11_p4052_lanes - Lambda_0_11_p3996_lanes;
  const Lanes Lambda_0_11_p4060_lanes = Lambda_0_11_p4056_lanes - Lambda_0_11_p3992_lanes;
  const Lanes Lambda_0_11_p4064_lanes = Lambda_0_11_p4060_lanes - Lambda_0_11_p3988_lanes;
  const Lanes Lambda_0_11_p4068_lanes = Lambda_0_11_p4064_lanes - Lambda_0_11_p3984_lanes;
  const Real Lambda_0_11_p4072 = 1.0 / Lambda_0_11_p4068_lanes[4];
  const Lanes Lambda_0_11_p4073_lanes = Lambda_0_11_p3976_lanes * Lambda_0_11_p4072;
  const Lanes Lambda_0_11_p4077_lanes = Lambda_0_11_p4073_lanes * Lambda_0_11_p4068_lanes[5];
  const Lanes Lambda_0_11_p4081_lanes = Lambda_0_11_p3900_lanes * Lambda_0_11_p3894_lanes[5];
  const Lanes Lambda_0_11_p4085_lanes = Lambda_0_11_p3697_lanes * Lambda_0_11_p3690_lanes[5];
  const Lanes Lambda_0_11_p4089_lanes = Lambda_0_11_p3482_lanes * Lambda_0_11_p3474_lanes[5];
  const Lanes Lambda_0_11_p4093_lanes = Lambda_0_11_p3258_lanes * Lambda_0_11_p3249_lanes[5];
  const Lanes Lambda_0_11_p4097_lanes = Lambda_0_11_p1418_lanes * Lambda_0_11_p2924_lanes[5];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4101_lanes = Lambda_0_11_p2936_lanes * Lambda_0_11_p2836_lanes[5];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4105_lanes = Lambda_0_11_p2944_lanes * Lambda_0_11_p2716_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4109_lanes = Lambda_0_11_p2952_lanes * Lambda_0_11_p2588;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4113_lanes = Lambda_0_11_p2960_lanes * Lambda_0_11_p2492_lanes[5];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p4117_lanes = Lambda_0_11_p2968_lanes * Lambda_0_11_p2342_lanes[5];

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4121_lanes = Lambda_0_11_p4117_lanes + Lambda_0_11_p4113_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4125_lanes = Lambda_0_11_p4121_lanes + Lambda_0_11_p4109_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4129_lanes = Lambda_0_11_p4125_lanes + Lambda_0_11_p4105_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4133_lanes = Lambda_0_11_p4129_lanes + Lambda_0_11_p4101_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p4137_lanes = Lambda_0_11_p4133_lanes + Lambda_0_11_p4097_lanes;
  const Lanes Lambda_0_11_p4141_lanes = Lambda_0_11_p4137_lanes - Lambda_0_11_p4093_lanes;
  const Lanes Lambda_0_11_p4145_lanes = Lambda_0_11_p4141_lanes - Lambda_0_11_p4089_lanes;
  const Lanes Lambda_0_11_p4149_lanes = Lambda_0_11_p4145_lanes - Lambda_0_11_p4085_lanes;
  const Lanes Lambda_0_11_p4153_lanes = Lambda_0_11_p4149_lanes - Lambda_0_11_p4081_lanes;
  const Lanes Lambda_0_11_p4157_lanes = Lambda_0_11_p4153_lanes - Lambda_0_11_p4077_lanes;
  const Lanes Lambda_0_11_p4161_lanes = Lambda_0_11_p4068_lanes * Lambda_0_11_p4072;
  const Lanes Lambda_0_11_p4164_lanes = Lambda_0_11_p4161_lanes * Lambda_0_11_p4068_lanes[5];
  const Lanes Lambda_0_11_p4167_lanes = Lambda_0_11_p3980_lanes * Lambda_0_11_p3894_lanes[5];
  const Lanes Lambda_0_11_p4170_lanes = Lambda_0_11_p3769_lanes * Lambda_0_11_p3690_lanes[5];
  const Lanes Lambda_0_11_p4173_lanes = Lambda_0_11_p3546_lanes * Lambda_0_11_p3474_lanes[5];
  const Lanes Lambda_0_11_p4176_lanes = Lambda_0_11_p3314_lanes * Lambda_0_11_p3249_lanes[5];
  const Lanes Lambda_0_11_p4179_lanes = Lambda_0_11_p2996_lanes * Lambda_0_11_p2924_lanes[5];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4182_lanes = Lambda_0_11_p3012_lanes * Lambda_0_11_p2836_lanes[5];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4185_lanes = Lambda_0_11_p3028_lanes * Lambda_0_11_p2716_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4188_lanes = Lambda_0_11_p3044_lanes * Lambda_0_11_p2588;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4191_lanes = Lambda_0_11_p3060_lanes * Lambda_0_11_p2492_lanes[5];

  // link 9 (left_upperarm), force propagation
  const Real Lambda_0_11_p4194 = Lambda_0_11_p3163_lanes[5] * Lambda_0_11_p1522_lanes[2] +
      Lambda_0_11_p3150_lanes[5] * Lambda_0_11_p1587_lanes[5] + Lambda_0_11_p3138_lanes[5] *
      Lambda_0_11_p1647 + Lambda_0_11_p3126_lanes[5] * Lambda_0_11_p1764_lanes[5] +
      Lambda_0_11_p3114_lanes[5] * Lambda_0_11_p1872;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4195_lanes = detail::make_lanes<Real>(Lambda_0_11_p4194 +
      Lambda_0_11_p3102_lanes[5] * Lambda_0_11_p1998_lanes[5] + Lambda_0_11_p3090_lanes[5] *
      Lambda_0_11_p2035_lanes[5] + Lambda_0_11_p3078_lanes[5] * Lambda_0_11_p2342_lanes[5],
      Lambda_0_11_p4194 + Lambda_0_11_p3102_lanes[5] * Lambda_0_11_p1998_lanes[5] +
      Lambda_0_11_p3090_lanes[5] * Lambda_0_11_p2035_lanes[5] + Lambda_0_11_p3078_lanes[5] *
      Lambda_0_11_p2342_lanes[5], Lambda_0_11_p4194 + Lambda_0_11_p3102_lanes[5] *
      Lambda_0_11_p1998_lanes[5] + Lambda_0_11_p3090_lanes[5] * Lambda_0_11_p2035_lanes[5] +
      Lambda_0_11_p3078_lanes[5] * Lambda_0_11_p2342_lanes[5], Lambda_0_11_p4194 +
      Lambda_0_11_p3102_lanes[5] * Lambda_0_11_p1998_lanes[5] + Lambda_0_11_p3090_lanes[5] *
      Lambda_0_11_p2035_lanes[5] + Lambda_0_11_p3078_lanes[5] * Lambda_0_11_p2342_lanes[5],
      Lambda_0_11_p4194 + Lambda_0_11_p3102_lanes[5] * Lambda_0_11_p1998_lanes[5] +
      Lambda_0_11_p3090_lanes[5] * Lambda_0_11_p2035_lanes[5] + Lambda_0_11_p3078_lanes[5] *
      Lambda_0_11_p2342_lanes[5], Lambda_0_11_p4194 + Lambda_0_11_p3102_lanes[5] *
      Lambda_0_11_p1998_lanes[5] + Lambda_0_11_p3090_lanes[5] * Lambda_0_11_p2035_lanes[5] +
      Lambda_0_11_p3078_lanes[5] * Lambda_0_11_p2342_lanes[5], Lambda_0_11_p3077 *
      Lambda_0_11_p2342_lanes[5], Lambda_0_11_p3076 * Lambda_0_11_p2342_lanes[5]) +
      Lambda_0_11_p4191_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4198_lanes = Lambda_0_11_p4195_lanes + Lambda_0_11_p4188_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4201_lanes = Lambda_0_11_p4198_lanes + Lambda_0_11_p4185_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4204_lanes = Lambda_0_11_p4201_lanes + Lambda_0_11_p4182_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p4207_lanes = Lambda_0_11_p4204_lanes + Lambda_0_11_p4179_lanes;
  const Lanes Lambda_0_11_p4210_lanes = Lambda_0_11_p4207_lanes - Lambda_0_11_p4176_lanes;
  const Lanes Lambda_0_11_p4213_lanes = Lambda_0_11_p4210_lanes - Lambda_0_11_p4173_lanes;
  const Lanes Lambda_0_11_p4216_lanes = Lambda_0_11_p4213_lanes - Lambda_0_11_p4170_lanes;
  const Lanes Lambda_0_11_p4219_lanes = Lambda_0_11_p4216_lanes - Lambda_0_11_p4167_lanes;
  const Lanes Lambda_0_11_p4222_lanes = Lambda_0_11_p4219_lanes - Lambda_0_11_p4164_lanes;
  const Real Lambda_0_11_p4225 = 1.0 / Lambda_0_11_p4222_lanes[5];
  const Lanes Lambda_0_11_p4226_lanes = Lambda_0_11_p4157_lanes * Lambda_0_11_p4225;
  const Lanes Lambda_0_11_p4230_lanes = Lambda_0_11_p4226_lanes * Lambda_0_11_p4222_lanes[6];
  const Lanes Lambda_0_11_p4234_lanes = Lambda_0_11_p4073_lanes * Lambda_0_11_p4068_lanes[6];
  const Lanes Lambda_0_11_p4238_lanes = Lambda_0_11_p3900_lanes * Lambda_0_11_p3894_lanes[6];
  const Lanes Lambda_0_11_p4242_lanes = Lambda_0_11_p3697_lanes * Lambda_0_11_p3690_lanes[6];
  const Lanes Lambda_0_11_p4246_lanes = Lambda_0_11_p3482_lanes * Lambda_0_11_p3474_lanes[6];
  const Lanes Lambda_0_11_p4250_lanes = Lambda_0_11_p3258_lanes * Lambda_0_11_p3249_lanes[6];
  const Lanes Lambda_0_11_p4254_lanes = Lambda_0_11_p1418_lanes * Lambda_0_11_p2924_lanes[6];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4258_lanes = Lambda_0_11_p2936_lanes * Lambda_0_11_p2836_lanes[6];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4262_lanes = Lambda_0_11_p2944_lanes * Lambda_0_11_p2716_lanes[6];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4266_lanes = Lambda_0_11_p2952_lanes * Lambda_0_11_p2585;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4270_lanes = Lambda_0_11_p2960_lanes * Lambda_0_11_p2492_lanes[6];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p4274_lanes = Lambda_0_11_p2968_lanes * Lambda_0_11_p2342_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p4278_lanes = Lambda_0_11_p1014_lanes * inverse_D14;
  const Lanes Lambda_0_11_p4282_lanes = Lambda_0_11_p4278_lanes * Lambda_0_11_p1479;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p4286_lanes = Lambda_0_11_p921_lanes * inverse_D15;
  const Lanes Lambda_0_11_p4290_lanes = Lambda_0_11_p4286_lanes * Lambda_0_11_p1476;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p4294_lanes = Lambda_0_11_p840_lanes * inverse_D16;
  const Lanes Lambda_0_11_p4298_lanes = Lambda_0_11_p4294_lanes * Lambda_0_11_p1470;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p4302_lanes = Lambda_0_11_p760_lanes * inverse_D17;
  const Lanes Lambda_0_11_p4306_lanes = Lambda_0_11_p4302_lanes * Lambda_0_11_p1464;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_0_11_p4310_lanes = detail::make_lanes<Real>(Lambda_0_11_p689, Lambda_0_11_p688,
      Lambda_0_11_p687, Lambda_0_11_p686, Lambda_0_11_p689, Lambda_0_11_p689, Lambda_0_11_p689,
      Lambda_0_11_p689) * inverse_D18;
  const Lanes Lambda_0_11_p4314_lanes = Lambda_0_11_p4310_lanes * Lambda_0_11_p1458;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p4318_lanes = Lambda_0_11_p637_lanes * inverse_D19;
  const Lanes Lambda_0_11_p4322_lanes = Lambda_0_11_p4318_lanes * Lambda_0_11_p1455;

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p4326 = 0.086 * Lambda_0_11_p616;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_0_11_p4327_lanes = 1065.380700001509 *
      detail::make_lanes<Real>(Lambda_0_11_p604, Lambda_0_11_p590, Lambda_0_11_p574,
      Lambda_0_11_p560, Lambda_0_11_p604, Lambda_0_11_p604, Lambda_0_11_p604, Lambda_0_11_p604);
  const Lanes Lambda_0_11_p4331_lanes = Lambda_0_11_p4327_lanes * Lambda_0_11_p4326;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p4335_lanes = Lambda_0_11_p4331_lanes + Lambda_0_11_p4322_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_0_11_p4339_lanes = Lambda_0_11_p4335_lanes + Lambda_0_11_p4314_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p4343_lanes = Lambda_0_11_p4339_lanes + Lambda_0_11_p4306_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p4347_lanes = Lambda_0_11_p4343_lanes + Lambda_0_11_p4298_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p4351_lanes = Lambda_0_11_p4347_lanes + Lambda_0_11_p4290_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p4355_lanes = Lambda_0_11_p4351_lanes + Lambda_0_11_p4282_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p4359_lanes = Lambda_0_11_p4355_lanes + Lambda_0_11_p4274_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4363_lanes = Lambda_0_11_p4359_lanes + Lambda_0_11_p4270_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4367_lanes = Lambda_0_11_p4363_lanes + Lambda_0_11_p4266_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4371_lanes = Lambda_0_11_p4367_lanes + Lambda_0_11_p4262_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4375_lanes = Lambda_0_11_p4371_lanes + Lambda_0_11_p4258_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p4379_lanes = Lambda_0_11_p4375_lanes + Lambda_0_11_p4254_lanes;
  const Lanes Lambda_0_11_p4383_lanes = Lambda_0_11_p4379_lanes - Lambda_0_11_p4250_lanes;
  const Lanes Lambda_0_11_p4387_lanes = Lambda_0_11_p4383_lanes - Lambda_0_11_p4246_lanes;
  const Lanes Lambda_0_11_p4391_lanes = Lambda_0_11_p4387_lanes - Lambda_0_11_p4242_lanes;
  const Lanes Lambda_0_11_p4395_lanes = Lambda_0_11_p4391_lanes - Lambda_0_11_p4238_lanes;
  const Lanes Lambda_0_11_p4399_lanes = Lambda_0_11_p4395_lanes - Lambda_0_11_p4234_lanes;
  const Lanes Lambda_0_11_p4403_lanes = Lambda_0_11_p4399_lanes - Lambda_0_11_p4230_lanes;
  const Real Lambda_0_11_p4407 = Lambda_0_11_p4222_lanes[6] * Lambda_0_11_p4225;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p4408 = 91.62274020012977 * Lambda_0_11_p616 * Lambda_0_11_p4326 +
      Lambda_0_11_p1455 * inverse_D19 * Lambda_0_11_p1455 + Lambda_0_11_p1458 * inverse_D18 *
      Lambda_0_11_p1458;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p4409 = Lambda_0_11_p4408 + Lambda_0_11_p1464 * inverse_D17 *
      Lambda_0_11_p1464 + Lambda_0_11_p1470 * inverse_D16 * Lambda_0_11_p1470 + Lambda_0_11_p1476 *
      inverse_D15 * Lambda_0_11_p1476;

  // link 4 (chest1), force propagation
  const Real Lambda_0_11_p4410 = Lambda_0_11_p4409 + Lambda_0_11_p1479 * inverse_D14 *
      Lambda_0_11_p1479 + Lambda_0_11_p3077 * Lambda_0_11_p2342_lanes[6] +
      Lambda_0_11_p3060_lanes[6] * Lambda_0_11_p2492_lanes[6] + Lambda_0_11_p3044_lanes[6] *
      Lambda_0_11_p2585;

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p4411 = Lambda_0_11_p4410 + Lambda_0_11_p3028_lanes[6] *
      Lambda_0_11_p2716_lanes[6] + Lambda_0_11_p3012_lanes[6] * Lambda_0_11_p2836_lanes[6] +
      Lambda_0_11_p2996_lanes[6] * Lambda_0_11_p2924_lanes[6] - Lambda_0_11_p3314_lanes[6] *
      Lambda_0_11_p3249_lanes[6];
  const Real Lambda_0_11_p4412 = Lambda_0_11_p4411 - Lambda_0_11_p3546_lanes[6] *
      Lambda_0_11_p3474_lanes[6] - Lambda_0_11_p3769_lanes[6] * Lambda_0_11_p3690_lanes[6] -
      Lambda_0_11_p3980_lanes[6] * Lambda_0_11_p3894_lanes[6] - Lambda_0_11_p4161_lanes[6] *
      Lambda_0_11_p4068_lanes[6];
  const Real Lambda_0_11_p4413 = 1.0 / (Lambda_0_11_p4412 - Lambda_0_11_p4407 *
      Lambda_0_11_p4222_lanes[6]);
  const Lanes Lambda_0_11_p4414_lanes = Lambda_0_11_p4403_lanes * Lambda_0_11_p4413;
  const Real Lambda_0_11_p4418 = Lambda_0_11_p4222_lanes[7] * Lambda_0_11_p4225;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_0_11_p4419 = Lambda_0_11_p1450 * inverse_D14;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_0_11_p4420 = Lambda_0_11_p1447 * inverse_D15;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p4421 = Lambda_0_11_p1441 * inverse_D16;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_0_11_p4422 = Lambda_0_11_p1435 * inverse_D17;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_0_11_p4423 = Lambda_0_11_p1429 * inverse_D18;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_0_11_p4424 = Lambda_0_11_p1426 * inverse_D19;

  // link 20 (right_hand), force propagation
  const Real Lambda_0_11_p4425 = 91.62274020012977 * Lambda_0_11_p615;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p4426 = Lambda_0_11_p4425 * Lambda_0_11_p4326 + Lambda_0_11_p4424 *
      Lambda_0_11_p1455 + Lambda_0_11_p4423 * Lambda_0_11_p1458 + Lambda_0_11_p4422 *
      Lambda_0_11_p1464 + Lambda_0_11_p4421 * Lambda_0_11_p1470;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p4427 = Lambda_0_11_p4426 + Lambda_0_11_p4420 * Lambda_0_11_p1476 +
      Lambda_0_11_p4419 * Lambda_0_11_p1479 + Lambda_0_11_p3076 * Lambda_0_11_p2342_lanes[6] +
      Lambda_0_11_p3060_lanes[7] * Lambda_0_11_p2492_lanes[6];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p4428 = Lambda_0_11_p4427 + Lambda_0_11_p3044_lanes[7] *
      Lambda_0_11_p2585 + Lambda_0_11_p3028_lanes[7] * Lambda_0_11_p2716_lanes[6] +
      Lambda_0_11_p3012_lanes[7] * Lambda_0_11_p2836_lanes[6] + Lambda_0_11_p2996_lanes[7] *
      Lambda_0_11_p2924_lanes[6];
  const Real Lambda_0_11_p4429 = Lambda_0_11_p4428 - Lambda_0_11_p3314_lanes[7] *
      Lambda_0_11_p3249_lanes[6] - Lambda_0_11_p3546_lanes[7] * Lambda_0_11_p3474_lanes[6] -
      Lambda_0_11_p3769_lanes[7] * Lambda_0_11_p3690_lanes[6] - Lambda_0_11_p3980_lanes[7] *
      Lambda_0_11_p3894_lanes[6];
  const Real Lambda_0_11_p4430 = Lambda_0_11_p4429 - Lambda_0_11_p4161_lanes[7] *
      Lambda_0_11_p4068_lanes[6] - Lambda_0_11_p4418 * Lambda_0_11_p4222_lanes[6];
  const Lanes Lambda_0_11_p4431_lanes = Lambda_0_11_p4414_lanes * Lambda_0_11_p4430;
  const Lanes Lambda_0_11_p4435_lanes = Lambda_0_11_p4226_lanes * Lambda_0_11_p4222_lanes[7];
  const Lanes Lambda_0_11_p4439_lanes = Lambda_0_11_p4073_lanes * Lambda_0_11_p4068_lanes[7];
  const Lanes Lambda_0_11_p4443_lanes = Lambda_0_11_p3900_lanes * Lambda_0_11_p3894_lanes[7];
  const Lanes Lambda_0_11_p4447_lanes = Lambda_0_11_p3697_lanes * Lambda_0_11_p3690_lanes[7];
  const Lanes Lambda_0_11_p4451_lanes = Lambda_0_11_p3482_lanes * Lambda_0_11_p3474_lanes[7];
  const Lanes Lambda_0_11_p4455_lanes = Lambda_0_11_p3258_lanes * Lambda_0_11_p3249_lanes[7];
  const Lanes Lambda_0_11_p4459_lanes = Lambda_0_11_p1418_lanes * Lambda_0_11_p2924_lanes[7];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4463_lanes = Lambda_0_11_p2936_lanes * Lambda_0_11_p2836_lanes[7];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4467_lanes = Lambda_0_11_p2944_lanes * Lambda_0_11_p2716_lanes[7];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4471_lanes = Lambda_0_11_p2952_lanes * Lambda_0_11_p2582;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4475_lanes = Lambda_0_11_p2960_lanes * Lambda_0_11_p2492_lanes[7];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p4479_lanes = Lambda_0_11_p2968_lanes * Lambda_0_11_p2342_lanes[7];

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p4483_lanes = Lambda_0_11_p4278_lanes * Lambda_0_11_p1450;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p4487_lanes = Lambda_0_11_p4286_lanes * Lambda_0_11_p1447;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p4491_lanes = Lambda_0_11_p4294_lanes * Lambda_0_11_p1441;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p4495_lanes = Lambda_0_11_p4302_lanes * Lambda_0_11_p1435;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_0_11_p4499_lanes = Lambda_0_11_p4310_lanes * Lambda_0_11_p1429;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p4503_lanes = Lambda_0_11_p4318_lanes * Lambda_0_11_p1426;

  // link 1 (calf), articulated inertia
  const Real Lambda_0_11_p4507 = 0.086 * Lambda_0_11_p615;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_0_11_p4508_lanes = Lambda_0_11_p4327_lanes * Lambda_0_11_p4507;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p4512_lanes = Lambda_0_11_p4508_lanes + Lambda_0_11_p4503_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_0_11_p4516_lanes = Lambda_0_11_p4512_lanes + Lambda_0_11_p4499_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p4520_lanes = Lambda_0_11_p4516_lanes + Lambda_0_11_p4495_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p4524_lanes = Lambda_0_11_p4520_lanes + Lambda_0_11_p4491_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p4528_lanes = Lambda_0_11_p4524_lanes + Lambda_0_11_p4487_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p4532_lanes = Lambda_0_11_p4528_lanes + Lambda_0_11_p4483_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p4536_lanes = Lambda_0_11_p4532_lanes + Lambda_0_11_p4479_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4540_lanes = Lambda_0_11_p4536_lanes + Lambda_0_11_p4475_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4544_lanes = Lambda_0_11_p4540_lanes + Lambda_0_11_p4471_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4548_lanes = Lambda_0_11_p4544_lanes + Lambda_0_11_p4467_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4552_lanes = Lambda_0_11_p4548_lanes + Lambda_0_11_p4463_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p4556_lanes = Lambda_0_11_p4552_lanes + Lambda_0_11_p4459_lanes;
  const Lanes Lambda_0_11_p4560_lanes = Lambda_0_11_p4556_lanes - Lambda_0_11_p4455_lanes;
  const Lanes Lambda_0_11_p4564_lanes = Lambda_0_11_p4560_lanes - Lambda_0_11_p4451_lanes;
  const Lanes Lambda_0_11_p4568_lanes = Lambda_0_11_p4564_lanes - Lambda_0_11_p4447_lanes;
  const Lanes Lambda_0_11_p4572_lanes = Lambda_0_11_p4568_lanes - Lambda_0_11_p4443_lanes;
  const Lanes Lambda_0_11_p4576_lanes = Lambda_0_11_p4572_lanes - Lambda_0_11_p4439_lanes;
  const Lanes Lambda_0_11_p4580_lanes = Lambda_0_11_p4576_lanes - Lambda_0_11_p4435_lanes;
  const Lanes Lambda_0_11_p4584_lanes = Lambda_0_11_p4580_lanes - Lambda_0_11_p4431_lanes;
  const Real Lambda_0_11_p4588 = Lambda_0_11_p4430 * Lambda_0_11_p4413;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p4589 = Lambda_0_11_p4425 * Lambda_0_11_p4507 + Lambda_0_11_p4424 *
      Lambda_0_11_p1426 + Lambda_0_11_p4423 * Lambda_0_11_p1429 + Lambda_0_11_p4422 *
      Lambda_0_11_p1435 + Lambda_0_11_p4421 * Lambda_0_11_p1441;

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p4590 = Lambda_0_11_p4589 + Lambda_0_11_p4420 * Lambda_0_11_p1447 +
      Lambda_0_11_p4419 * Lambda_0_11_p1450 + Lambda_0_11_p3076 * Lambda_0_11_p2342_lanes[7] +
      Lambda_0_11_p3060_lanes[7] * Lambda_0_11_p2492_lanes[7];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p4591 = Lambda_0_11_p4590 + Lambda_0_11_p3044_lanes[7] *
      Lambda_0_11_p2582 + Lambda_0_11_p3028_lanes[7] * Lambda_0_11_p2716_lanes[7] +
      Lambda_0_11_p3012_lanes[7] * Lambda_0_11_p2836_lanes[7] + Lambda_0_11_p2996_lanes[7] *
      Lambda_0_11_p2924_lanes[7];
  const Real Lambda_0_11_p4592 = Lambda_0_11_p4591 - Lambda_0_11_p3314_lanes[7] *
      Lambda_0_11_p3249_lanes[7] - Lambda_0_11_p3546_lanes[7] * Lambda_0_11_p3474_lanes[7] -
      Lambda_0_11_p3769_lanes[7] * Lambda_0_11_p3690_lanes[7] - Lambda_0_11_p3980_lanes[7] *
      Lambda_0_11_p3894_lanes[7];
  const Real Lambda_0_11_p4593 = 1.0 / (Lambda_0_11_p4592 - Lambda_0_11_p4161_lanes[7] *
      Lambda_0_11_p4068_lanes[7] - Lambda_0_11_p4418 * Lambda_0_11_p4222_lanes[7] -
      Lambda_0_11_p4588 * Lambda_0_11_p4430);
  const Lanes Lambda_0_11_p4594_lanes = Lambda_0_11_p4584_lanes * Lambda_0_11_p4593;
  const Lanes Lambda_0_11_p4598_lanes = Lambda_0_11_p4594_lanes * Lambda_0_11_p4584_lanes[0];
  const Lanes Lambda_0_11_p4602_lanes = Lambda_0_11_p4414_lanes * Lambda_0_11_p4403_lanes[0];
  const Lanes Lambda_0_11_p4606_lanes = Lambda_0_11_p4226_lanes * Lambda_0_11_p4157_lanes[0];
  const Lanes Lambda_0_11_p4610_lanes = Lambda_0_11_p4073_lanes * Lambda_0_11_p3976_lanes[0];
  const Lanes Lambda_0_11_p4614_lanes = Lambda_0_11_p3900_lanes * Lambda_0_11_p3765_lanes[0];
  const Lanes Lambda_0_11_p4618_lanes = Lambda_0_11_p3697_lanes * Lambda_0_11_p3542_lanes[0];
  const Lanes Lambda_0_11_p4622_lanes = Lambda_0_11_p3482_lanes * Lambda_0_11_p3310_lanes[0];
  const Lanes Lambda_0_11_p4626_lanes = Lambda_0_11_p3258_lanes * Lambda_0_11_p2992_lanes[0];
  const Lanes Lambda_0_11_p4630_lanes = Lambda_0_11_p1418_lanes * Lambda_0_11_p1414_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4634_lanes = Lambda_0_11_p2936_lanes * Lambda_0_11_p1367_lanes[0];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4638_lanes = Lambda_0_11_p2944_lanes * Lambda_0_11_p1307_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4642_lanes = Lambda_0_11_p2952_lanes * Lambda_0_11_p1250;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4646_lanes = Lambda_0_11_p2960_lanes * Lambda_0_11_p1195_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p4650_lanes = Lambda_0_11_p2968_lanes * Lambda_0_11_p1135_lanes[0];

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p4654_lanes = Lambda_0_11_p4278_lanes * Lambda_0_11_p1014_lanes[0];

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p4658_lanes = Lambda_0_11_p4286_lanes * Lambda_0_11_p921_lanes[0];

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p4662_lanes = Lambda_0_11_p4294_lanes * Lambda_0_11_p840_lanes[0];

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p4666_lanes = Lambda_0_11_p4302_lanes * Lambda_0_11_p760_lanes[0];

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_0_11_p4670_lanes = Lambda_0_11_p4310_lanes * Lambda_0_11_p689;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p4674_lanes = Lambda_0_11_p4318_lanes * Lambda_0_11_p637_lanes[0];

  // link 20 (right_hand), force propagation
  const Lanes Lambda_0_11_p4678_lanes = Lambda_0_11_p4327_lanes * Lambda_0_11_p604;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p4682_lanes = Lambda_0_11_p4678_lanes + Lambda_0_11_p4674_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_0_11_p4686_lanes = Lambda_0_11_p4682_lanes + Lambda_0_11_p4670_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p4690_lanes = Lambda_0_11_p4686_lanes + Lambda_0_11_p4666_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p4694_lanes = Lambda_0_11_p4690_lanes + Lambda_0_11_p4662_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p4698_lanes = Lambda_0_11_p4694_lanes + Lambda_0_11_p4658_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p4702_lanes = Lambda_0_11_p4698_lanes + Lambda_0_11_p4654_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p4706_lanes = Lambda_0_11_p4702_lanes + Lambda_0_11_p4650_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4710_lanes = Lambda_0_11_p4706_lanes + Lambda_0_11_p4646_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4714_lanes = Lambda_0_11_p4710_lanes + Lambda_0_11_p4642_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4718_lanes = Lambda_0_11_p4714_lanes + Lambda_0_11_p4638_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4722_lanes = Lambda_0_11_p4718_lanes + Lambda_0_11_p4634_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p4726_lanes = Lambda_0_11_p4722_lanes + Lambda_0_11_p4630_lanes;
  const Lanes Lambda_0_11_p4730_lanes = Lambda_0_11_p4726_lanes - Lambda_0_11_p4626_lanes;
  const Lanes Lambda_0_11_p4734_lanes = Lambda_0_11_p4730_lanes - Lambda_0_11_p4622_lanes;
  const Lanes Lambda_0_11_p4738_lanes = Lambda_0_11_p4734_lanes - Lambda_0_11_p4618_lanes;
  const Lanes Lambda_0_11_p4742_lanes = Lambda_0_11_p4738_lanes - Lambda_0_11_p4614_lanes;
  const Lanes Lambda_0_11_p4746_lanes = Lambda_0_11_p4742_lanes - Lambda_0_11_p4610_lanes;
  const Lanes Lambda_0_11_p4750_lanes = Lambda_0_11_p4746_lanes - Lambda_0_11_p4606_lanes;
  const Lanes Lambda_0_11_p4754_lanes = Lambda_0_11_p4750_lanes - Lambda_0_11_p4602_lanes;
  const Lanes Lambda_0_11_p4758_lanes = Lambda_0_11_p4754_lanes - Lambda_0_11_p4598_lanes;
  const Real Lambda_0_11_p4762 = 1.0 / Lambda_0_11_p4758_lanes[0];
  const Lanes Lambda_0_11_p4763_lanes = Lambda_0_11_p4758_lanes * Lambda_0_11_p4762;
  const Lanes Lambda_0_11_p4766_lanes = Lambda_0_11_p4763_lanes * Lambda_0_11_p4758_lanes[1];
  const Lanes Lambda_0_11_p4769_lanes = Lambda_0_11_p4594_lanes * Lambda_0_11_p4584_lanes[1];
  const Lanes Lambda_0_11_p4772_lanes = Lambda_0_11_p4414_lanes * Lambda_0_11_p4403_lanes[1];
  const Lanes Lambda_0_11_p4775_lanes = Lambda_0_11_p4226_lanes * Lambda_0_11_p4157_lanes[1];
  const Lanes Lambda_0_11_p4778_lanes = Lambda_0_11_p4073_lanes * Lambda_0_11_p3976_lanes[1];
  const Lanes Lambda_0_11_p4781_lanes = Lambda_0_11_p3900_lanes * Lambda_0_11_p3765_lanes[1];
  const Lanes Lambda_0_11_p4784_lanes = Lambda_0_11_p3697_lanes * Lambda_0_11_p3542_lanes[1];
  const Lanes Lambda_0_11_p4787_lanes = Lambda_0_11_p3482_lanes * Lambda_0_11_p3310_lanes[1];
  const Lanes Lambda_0_11_p4790_lanes = Lambda_0_11_p3258_lanes * Lambda_0_11_p2992_lanes[1];
  const Lanes Lambda_0_11_p4793_lanes = Lambda_0_11_p1418_lanes * Lambda_0_11_p1414_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4796_lanes = Lambda_0_11_p2936_lanes * Lambda_0_11_p1367_lanes[1];

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4799_lanes = Lambda_0_11_p2944_lanes * Lambda_0_11_p1307_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4802_lanes = Lambda_0_11_p2952_lanes * Lambda_0_11_p1247;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4805_lanes = Lambda_0_11_p2960_lanes * Lambda_0_11_p1195_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p4808_lanes = Lambda_0_11_p2968_lanes * Lambda_0_11_p1135_lanes[1];

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p4811_lanes = Lambda_0_11_p4278_lanes * Lambda_0_11_p1014_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p4814_lanes = Lambda_0_11_p4286_lanes * Lambda_0_11_p921_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p4817_lanes = Lambda_0_11_p4294_lanes * Lambda_0_11_p840_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p4820_lanes = Lambda_0_11_p4302_lanes * Lambda_0_11_p760_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_0_11_p4823_lanes = Lambda_0_11_p4310_lanes * Lambda_0_11_p688;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p4826_lanes = Lambda_0_11_p4318_lanes * Lambda_0_11_p637_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes Lambda_0_11_p4829_lanes = Lambda_0_11_p4327_lanes * Lambda_0_11_p590;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_0_11_p4832_lanes = Lambda_0_11_p4829_lanes + Lambda_0_11_p4826_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_0_11_p4835_lanes = Lambda_0_11_p4832_lanes + Lambda_0_11_p4823_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_0_11_p4838_lanes = Lambda_0_11_p4835_lanes + Lambda_0_11_p4820_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_0_11_p4841_lanes = Lambda_0_11_p4838_lanes + Lambda_0_11_p4817_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_0_11_p4844_lanes = Lambda_0_11_p4841_lanes + Lambda_0_11_p4814_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_0_11_p4847_lanes = Lambda_0_11_p4844_lanes + Lambda_0_11_p4811_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_0_11_p4850_lanes = Lambda_0_11_p4847_lanes + Lambda_0_11_p4808_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_0_11_p4853_lanes = Lambda_0_11_p4850_lanes + Lambda_0_11_p4805_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_0_11_p4856_lanes = Lambda_0_11_p4853_lanes + Lambda_0_11_p4802_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_0_11_p4859_lanes = Lambda_0_11_p4856_lanes + Lambda_0_11_p4799_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_0_11_p4862_lanes = Lambda_0_11_p4859_lanes + Lambda_0_11_p4796_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_0_11_p4865_lanes = Lambda_0_11_p4862_lanes + Lambda_0_11_p4793_lanes;
  const Lanes Lambda_0_11_p4868_lanes = Lambda_0_11_p4865_lanes - Lambda_0_11_p4790_lanes;
  const Lanes Lambda_0_11_p4871_lanes = Lambda_0_11_p4868_lanes - Lambda_0_11_p4787_lanes;
  const Lanes Lambda_0_11_p4874_lanes = Lambda_0_11_p4871_lanes - Lambda_0_11_p4784_lanes;
  const Lanes Lambda_0_11_p4877_lanes = Lambda_0_11_p4874_lanes - Lambda_0_11_p4781_lanes;
  const Lanes Lambda_0_11_p4880_lanes = Lambda_0_11_p4877_lanes - Lambda_0_11_p4778_lanes;
  const Lanes Lambda_0_11_p4883_lanes = Lambda_0_11_p4880_lanes - Lambda_0_11_p4775_lanes;
  const Lanes Lambda_0_11_p4886_lanes = Lambda_0_11_p4883_lanes - Lambda_0_11_p4772_lanes;
  const Lanes Lambda_0_11_p4889_lanes = Lambda_0_11_p4886_lanes - Lambda_0_11_p4769_lanes;
  const Lanes Lambda_0_11_p4892_lanes = Lambda_0_11_p4889_lanes - Lambda_0_11_p4766_lanes;
  const Real Lambda_0_11_p4895 = 1.0 / Lambda_0_11_p4892_lanes[1];
  const Real Lambda_0_11_p4896 = Lambda_0_11_p4892_lanes[3] * Lambda_0_11_p4895;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_0_11_p4897_lanes = Lambda_0_11_p4327_lanes * Lambda_0_11_p574;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p4899 = Lambda_0_11_p4897_lanes[3] + Lambda_0_11_p4318_lanes[3] *
      Lambda_0_11_p637_lanes[2] + Lambda_0_11_p4310_lanes[3] * Lambda_0_11_p687 +
      Lambda_0_11_p4302_lanes[3] * Lambda_0_11_p760_lanes[2] + Lambda_0_11_p4294_lanes[3] *
      Lambda_0_11_p840_lanes[2];

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p4900 = Lambda_0_11_p4899 + Lambda_0_11_p4286_lanes[3] *
      Lambda_0_11_p921_lanes[2] + Lambda_0_11_p4278_lanes[3] * Lambda_0_11_p1014_lanes[2] +
      Lambda_0_11_p2968_lanes[3] * Lambda_0_11_p1135_lanes[2] + Lambda_0_11_p2960_lanes[3] *
      Lambda_0_11_p1195_lanes[2];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p4901 = Lambda_0_11_p4900 + Lambda_0_11_p2952_lanes[3] *
      Lambda_0_11_p1244 + Lambda_0_11_p2944_lanes[3] * Lambda_0_11_p1307_lanes[2] +
      Lambda_0_11_p2936_lanes[3] * Lambda_0_11_p1367_lanes[2] + Lambda_0_11_p1418_lanes[3] *
      Lambda_0_11_p1414_lanes[2];
  const Real Lambda_0_11_p4902 = Lambda_0_11_p4901 - Lambda_0_11_p3258_lanes[3] *
      Lambda_0_11_p2992_lanes[2] - Lambda_0_11_p3482_lanes[3] * Lambda_0_11_p3310_lanes[2] -
      Lambda_0_11_p3697_lanes[3] * Lambda_0_11_p3542_lanes[2] - Lambda_0_11_p3900_lanes[3] *
      Lambda_0_11_p3765_lanes[2];
  const Real Lambda_0_11_p4903 = Lambda_0_11_p4902 - Lambda_0_11_p4073_lanes[3] *
      Lambda_0_11_p3976_lanes[2] - Lambda_0_11_p4226_lanes[3] * Lambda_0_11_p4157_lanes[2] -
      Lambda_0_11_p4414_lanes[3] * Lambda_0_11_p4403_lanes[2] - Lambda_0_11_p4594_lanes[3] *
      Lambda_0_11_p4584_lanes[2];
  const Real Lambda_0_11_p4904 = Lambda_0_11_p4903 - Lambda_0_11_p4763_lanes[3] *
      Lambda_0_11_p4758_lanes[2] - Lambda_0_11_p4896 * Lambda_0_11_p4892_lanes[2];
  const Real Lambda_0_11_p4905 = Lambda_0_11_p4892_lanes[2] * Lambda_0_11_p4895;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_0_11_p4906 = Lambda_0_11_p4897_lanes[2] + Lambda_0_11_p4318_lanes[2] *
      Lambda_0_11_p637_lanes[2] + Lambda_0_11_p4310_lanes[2] * Lambda_0_11_p687 +
      Lambda_0_11_p4302_lanes[2] * Lambda_0_11_p760_lanes[2] + Lambda_0_11_p4294_lanes[2] *
      Lambda_0_11_p840_lanes[2];

  // link 5 (chest2), force propagation
  const Real Lambda_0_11_p4907 = Lambda_0_11_p4906 + Lambda_0_11_p4286_lanes[2] *
      Lambda_0_11_p921_lanes[2] + Lambda_0_11_p4278_lanes[2] * Lambda_0_11_p1014_lanes[2] +
      Lambda_0_11_p2968_lanes[2] * Lambda_0_11_p1135_lanes[2] + Lambda_0_11_p2960_lanes[2] *
      Lambda_0_11_p1195_lanes[2];

  // link 1 (calf), force propagation
  const Real Lambda_0_11_p4908 = Lambda_0_11_p4907 + Lambda_0_11_p2952_lanes[2] *
      Lambda_0_11_p1244 + Lambda_0_11_p2944_lanes[2] * Lambda_0_11_p1307_lanes[2] +
      Lambda_0_11_p2936_lanes[2] * Lambda_0_11_p1367_lanes[2] + Lambda_0_11_p1418_lanes[2] *
      Lambda_0_11_p1414_lanes[2];
  const Real Lambda_0_11_p4909 = Lambda_0_11_p4908 - Lambda_0_11_p3258_lanes[2] *
      Lambda_0_11_p2992_lanes[2] - Lambda_0_11_p3482_lanes[2] * Lambda_0_11_p3310_lanes[2] -
      Lambda_0_11_p3697_lanes[2] * Lambda_0_11_p3542_lanes[2] - Lambda_0_11_p3900_lanes[2] *
      Lambda_0_11_p3765_lanes[2];
  const Real Lambda_0_11_p4910 = Lambda_0_11_p4909 - Lambda_0_11_p4073_lanes[2] *
      Lambda_0_11_p3976_lanes[2] - Lambda_0_11_p4226_lanes[2] * Lambda_0_11_p4157_lanes[2] -
      Lambda_0_11_p4414_lanes[2] * Lambda_0_11_p4403_lanes[2] - Lambda_0_11_p4594_lanes[2] *
      Lambda_0_11_p4584_lanes[2];
  const Real Lambda_0_11_p4911 = 1.0 / (Lambda_0_11_p4910 - Lambda_0_11_p4763_lanes[2] *
      Lambda_0_11_p4758_lanes[2] - Lambda_0_11_p4905 * Lambda_0_11_p4892_lanes[2]);
  const Real Lambda_0_11_p4912 = Lambda_0_11_p4904 * Lambda_0_11_p4911;
  const Real Lambda_0_11_p4913 = Lambda_0_11_p3546_lanes[2] * Lambda_0_11_p3314_lanes[1] -
      Lambda_0_11_p3314_lanes[2];
  const Real Lambda_0_11_p4914 = Lambda_0_11_p3546_lanes[3] * Lambda_0_11_p3314_lanes[1] -
      Lambda_0_11_p3314_lanes[3] - Lambda_0_11_p3769_lanes[3] * Lambda_0_11_p4913;
  const Real Lambda_0_11_p4915 = Lambda_0_11_p3546_lanes[4] * Lambda_0_11_p3314_lanes[1] -
      Lambda_0_11_p3314_lanes[4] - Lambda_0_11_p3769_lanes[4] * Lambda_0_11_p4913 -
      Lambda_0_11_p3980_lanes[4] * Lambda_0_11_p4914;
  const Real Lambda_0_11_p4916 = Lambda_0_11_p3546_lanes[5] * Lambda_0_11_p3314_lanes[1] -
      Lambda_0_11_p3314_lanes[5] - Lambda_0_11_p3769_lanes[5] * Lambda_0_11_p4913 -
      Lambda_0_11_p3980_lanes[5] * Lambda_0_11_p4914 - Lambda_0_11_p4161_lanes[5] *
      Lambda_0_11_p4915;
  const Real Lambda_0_11_p4917 = Lambda_0_11_p3546_lanes[6] * Lambda_0_11_p3314_lanes[1] -
      Lambda_0_11_p3314_lanes[6] - Lambda_0_11_p3769_lanes[6] * Lambda_0_11_p4913 -
      Lambda_0_11_p3980_lanes[6] * Lambda_0_11_p4914 - Lambda_0_11_p4161_lanes[6] *
      Lambda_0_11_p4915;
  const Real Lambda_0_11_p4918 = Lambda_0_11_p4917 - Lambda_0_11_p4407 * Lambda_0_11_p4916;
  const Real Lambda_0_11_p4919 = Lambda_0_11_p3546_lanes[7] * Lambda_0_11_p3314_lanes[1] -
      Lambda_0_11_p3314_lanes[7] - Lambda_0_11_p3769_lanes[7] * Lambda_0_11_p4913 -
      Lambda_0_11_p3980_lanes[7] * Lambda_0_11_p4914 - Lambda_0_11_p4161_lanes[7] *
      Lambda_0_11_p4915;
  const Real Lambda_0_11_p4920 = Lambda_0_11_p4919 - Lambda_0_11_p4418 * Lambda_0_11_p4916 -
      Lambda_0_11_p4588 * Lambda_0_11_p4918;
  const Real Lambda_0_11_p4921 = Lambda_0_11_p3482_lanes[0] * Lambda_0_11_p3314_lanes[1] -
      Lambda_0_11_p3258_lanes[0] - Lambda_0_11_p3697_lanes[0] * Lambda_0_11_p4913 -
      Lambda_0_11_p3900_lanes[0] * Lambda_0_11_p4914 - Lambda_0_11_p4073_lanes[0] *
      Lambda_0_11_p4915;
  const Real Lambda_0_11_p4922 = Lambda_0_11_p4921 - Lambda_0_11_p4226_lanes[0] *
      Lambda_0_11_p4916 - Lambda_0_11_p4414_lanes[0] * Lambda_0_11_p4918 -
      Lambda_0_11_p4594_lanes[0] * Lambda_0_11_p4920;
  const Real Lambda_0_11_p4923 = Lambda_0_11_p3482_lanes[1] * Lambda_0_11_p3314_lanes[1] -
      Lambda_0_11_p3258_lanes[1] - Lambda_0_11_p3697_lanes[1] * Lambda_0_11_p4913 -
      Lambda_0_11_p3900_lanes[1] * Lambda_0_11_p4914 - Lambda_0_11_p4073_lanes[1] *
      Lambda_0_11_p4915;
  const Real Lambda_0_11_p4924 = Lambda_0_11_p4923 - Lambda_0_11_p4226_lanes[1] *
      Lambda_0_11_p4916 - Lambda_0_11_p4414_lanes[1] * Lambda_0_11_p4918 -
      Lambda_0_11_p4594_lanes[1] * Lambda_0_11_p4920 - Lambda_0_11_p4763_lanes[1] *
      Lambda_0_11_p4922;
  const Real Lambda_0_11_p4925 = Lambda_0_11_p3482_lanes[2] * Lambda_0_11_p3314_lanes[1] -
      Lambda_0_11_p3258_lanes[2] - Lambda_0_11_p3697_lanes[2] * Lambda_0_11_p4913 -
      Lambda_0_11_p3900_lanes[2] * Lambda_0_11_p4914 - Lambda_0_11_p4073_lanes[2] *
      Lambda_0_11_p4915;
  const Real Lambda_0_11_p4926 = Lambda_0_11_p4925 - Lambda_0_11_p4226_lanes[2] *
      Lambda_0_11_p4916 - Lambda_0_11_p4414_lanes[2] * Lambda_0_11_p4918 -
      Lambda_0_11_p4594_lanes[2] * Lambda_0_11_p4920 - Lambda_0_11_p4763_lanes[2] *
      Lambda_0_11_p4922;
  const Real Lambda_0_11_p4927 = Lambda_0_11_p4926 - Lambda_0_11_p4905 * Lambda_0_11_p4924;
  const Real Lambda_0_11_p4928 = Lambda_0_11_p3482_lanes[3] * Lambda_0_11_p3314_lanes[1] -
      Lambda_0_11_p3258_lanes[3] - Lambda_0_11_p3697_lanes[3] * Lambda_0_11_p4913 -
      Lambda_0_11_p3900_lanes[3] * Lambda_0_11_p4914 - Lambda_0_11_p4073_lanes[3] *
      Lambda_0_11_p4915;
  const Real Lambda_0_11_p4929 = Lambda_0_11_p4928 - Lambda_0_11_p4226_lanes[3] *
      Lambda_0_11_p4916 - Lambda_0_11_p4414_lanes[3] * Lambda_0_11_p4918 -
      Lambda_0_11_p4594_lanes[3] * Lambda_0_11_p4920 - Lambda_0_11_p4763_lanes[3] *
      Lambda_0_11_p4922;
  const Real Lambda_0_11_p4930 = Lambda_0_11_p4929 - Lambda_0_11_p4896 * Lambda_0_11_p4924 -
      Lambda_0_11_p4912 * Lambda_0_11_p4927;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_11_11_p1 = Lambda_0_11_p4327_lanes[3] * Lambda_0_11_p560 +
      Lambda_0_11_p4318_lanes[3] * Lambda_0_11_p637_lanes[3] + Lambda_0_11_p4310_lanes[3] *
      Lambda_0_11_p686 + Lambda_0_11_p4302_lanes[3] * Lambda_0_11_p760_lanes[3] +
      Lambda_0_11_p4294_lanes[3] * Lambda_0_11_p840_lanes[3];

  // link 5 (chest2), force propagation
  const Real Lambda_11_11_p2 = Lambda_11_11_p1 + Lambda_0_11_p4286_lanes[3] *
      Lambda_0_11_p921_lanes[3] + Lambda_0_11_p4278_lanes[3] * Lambda_0_11_p1014_lanes[3] +
      Lambda_0_11_p2968_lanes[3] * Lambda_0_11_p1135_lanes[3] + Lambda_0_11_p2960_lanes[3] *
      Lambda_0_11_p1195_lanes[3];

  // link 1 (calf), force propagation
  const Real Lambda_11_11_p3 = Lambda_11_11_p2 + Lambda_0_11_p2952_lanes[3] * Lambda_0_11_p1241 +
      Lambda_0_11_p2944_lanes[3] * Lambda_0_11_p1307_lanes[3] + Lambda_0_11_p2936_lanes[3] *
      Lambda_0_11_p1367_lanes[3] + Lambda_0_11_p1418_lanes[3] * Lambda_0_11_p1414_lanes[3];
  const Real Lambda_11_11_p4 = Lambda_11_11_p3 - Lambda_0_11_p3258_lanes[3] *
      Lambda_0_11_p2992_lanes[3] - Lambda_0_11_p3482_lanes[3] * Lambda_0_11_p3310_lanes[3] -
      Lambda_0_11_p3697_lanes[3] * Lambda_0_11_p3542_lanes[3] - Lambda_0_11_p3900_lanes[3] *
      Lambda_0_11_p3765_lanes[3];
  const Real Lambda_11_11_p5 = Lambda_11_11_p4 - Lambda_0_11_p4073_lanes[3] *
      Lambda_0_11_p3976_lanes[3] - Lambda_0_11_p4226_lanes[3] * Lambda_0_11_p4157_lanes[3] -
      Lambda_0_11_p4414_lanes[3] * Lambda_0_11_p4403_lanes[3] - Lambda_0_11_p4594_lanes[3] *
      Lambda_0_11_p4584_lanes[3];
  const Real Lambda_11_11 = 1.0 / (Lambda_11_11_p5 - Lambda_0_11_p4763_lanes[3] *
      Lambda_0_11_p4758_lanes[3] - Lambda_0_11_p4896 * Lambda_0_11_p4892_lanes[3] -
      Lambda_0_11_p4912 * Lambda_0_11_p4904);
  Lambda[143] = Lambda_11_11;
  const Real Lambda_0_11 = Lambda_0_11_p4930 * Lambda_11_11;
  Lambda[11] = Lambda_0_11;
  Lambda[132] = Lambda_0_11;
  const Real Lambda_0_0_p1 = Lambda_0_11_p4927 * Lambda_0_11_p4911;
  const Real Lambda_0_0_p2 = Lambda_0_11_p4924 * Lambda_0_11_p4895;
  const Real Lambda_0_0_p3 = Lambda_0_11_p4922 * Lambda_0_11_p4762;
  const Real Lambda_0_0_p4 = Lambda_0_11_p4920 * Lambda_0_11_p4593;
  const Real Lambda_0_0_p5 = Lambda_0_11_p4918 * Lambda_0_11_p4413;
  const Real Lambda_0_0_p6 = Lambda_0_11_p4916 * Lambda_0_11_p4225;
  const Real Lambda_0_0_p7 = Lambda_0_11_p4915 * Lambda_0_11_p4072;
  const Real Lambda_0_0_p8 = Lambda_0_11_p4914 * Lambda_0_11_p3899;
  const Real Lambda_0_0_p9 = Lambda_0_11_p4913 * Lambda_0_11_p3696;
  const Real Lambda_0_0_p10 = Lambda_0_11_p3314_lanes[1] * Lambda_0_11_p3481;
  const Real Lambda_0_0_p11 = Lambda_0_11_p3257 + Lambda_0_0_p10 * Lambda_0_11_p3314_lanes[1] +
      Lambda_0_0_p9 * Lambda_0_11_p4913 + Lambda_0_0_p8 * Lambda_0_11_p4914 + Lambda_0_0_p7 *
      Lambda_0_11_p4915;
  const Real Lambda_0_0_p12 = Lambda_0_0_p11 + Lambda_0_0_p6 * Lambda_0_11_p4916 + Lambda_0_0_p5 *
      Lambda_0_11_p4918 + Lambda_0_0_p4 * Lambda_0_11_p4920 + Lambda_0_0_p3 * Lambda_0_11_p4922;
  Lambda[0] = Lambda_0_0_p12 + Lambda_0_0_p2 * Lambda_0_11_p4924 + Lambda_0_0_p1 *
      Lambda_0_11_p4927 + Lambda_0_11 * Lambda_0_11_p4930;
  const Real Lambda_1_11_p1 = Lambda_0_11_p3769_lanes[3] * Lambda_0_11_p3546_lanes[2] -
      Lambda_0_11_p3546_lanes[3];
  const Real Lambda_1_11_p2 = Lambda_0_11_p3769_lanes[4] * Lambda_0_11_p3546_lanes[2] -
      Lambda_0_11_p3546_lanes[4] - Lambda_0_11_p3980_lanes[4] * Lambda_1_11_p1;
  const Real Lambda_1_11_p3 = Lambda_0_11_p3769_lanes[5] * Lambda_0_11_p3546_lanes[2] -
      Lambda_0_11_p3546_lanes[5] - Lambda_0_11_p3980_lanes[5] * Lambda_1_11_p1 -
      Lambda_0_11_p4161_lanes[5] * Lambda_1_11_p2;
  const Real Lambda_1_11_p4 = Lambda_0_11_p3769_lanes[6] * Lambda_0_11_p3546_lanes[2] -
      Lambda_0_11_p3546_lanes[6] - Lambda_0_11_p3980_lanes[6] * Lambda_1_11_p1 -
      Lambda_0_11_p4161_lanes[6] * Lambda_1_11_p2 - Lambda_0_11_p4407 * Lambda_1_11_p3;
  const Real Lambda_1_11_p5 = Lambda_0_11_p3769_lanes[7] * Lambda_0_11_p3546_lanes[2] -
      Lambda_0_11_p3546_lanes[7] - Lambda_0_11_p3980_lanes[7] * Lambda_1_11_p1 -
      Lambda_0_11_p4161_lanes[7] * Lambda_1_11_p2 - Lambda_0_11_p4418 * Lambda_1_11_p3;
  const Real Lambda_1_11_p6 = Lambda_1_11_p5 - Lambda_0_11_p4588 * Lambda_1_11_p4;
  const Real Lambda_1_11_p7 = Lambda_0_11_p3697_lanes[0] * Lambda_0_11_p3546_lanes[2] -
      Lambda_0_11_p3482_lanes[0] - Lambda_0_11_p3900_lanes[0] * Lambda_1_11_p1 -
      Lambda_0_11_p4073_lanes[0] * Lambda_1_11_p2 - Lambda_0_11_p4226_lanes[0] * Lambda_1_11_p3;
  const Real Lambda_1_11_p8 = Lambda_1_11_p7 - Lambda_0_11_p4414_lanes[0] * Lambda_1_11_p4 -
      Lambda_0_11_p4594_lanes[0] * Lambda_1_11_p6;
  const Real Lambda_1_11_p9 = Lambda_0_11_p3697_lanes[1] * Lambda_0_11_p3546_lanes[2] -
      Lambda_0_11_p3482_lanes[1] - Lambda_0_11_p3900_lanes[1] * Lambda_1_11_p1 -
      Lambda_0_11_p4073_lanes[1] * Lambda_1_11_p2 - Lambda_0_11_p4226_lanes[1] * Lambda_1_11_p3;
  const Real Lambda_1_11_p10 = Lambda_1_11_p9 - Lambda_0_11_p4414_lanes[1] * Lambda_1_11_p4 -
      Lambda_0_11_p4594_lanes[1] * Lambda_1_11_p6 - Lambda_0_11_p4763_lanes[1] * Lambda_1_11_p8;
  const Real Lambda_1_11_p11 = Lambda_0_11_p3697_lanes[2] * Lambda_0_11_p3546_lanes[2] -
      Lambda_0_11_p3482_lanes[2] - Lambda_0_11_p3900_lanes[2] * Lambda_1_11_p1 -
      Lambda_0_11_p4073_lanes[2] * Lambda_1_11_p2 - Lambda_0_11_p4226_lanes[2] * Lambda_1_11_p3;
  const Real Lambda_1_11_p12 = Lambda_1_11_p11 - Lambda_0_11_p4414_lanes[2] * Lambda_1_11_p4 -
      Lambda_0_11_p4594_lanes[2] * Lambda_1_11_p6 - Lambda_0_11_p4763_lanes[2] * Lambda_1_11_p8 -
      Lambda_0_11_p4905 * Lambda_1_11_p10;
  const Real Lambda_1_11_p13 = Lambda_0_11_p3697_lanes[3] * Lambda_0_11_p3546_lanes[2] -
      Lambda_0_11_p3482_lanes[3] - Lambda_0_11_p3900_lanes[3] * Lambda_1_11_p1 -
      Lambda_0_11_p4073_lanes[3] * Lambda_1_11_p2 - Lambda_0_11_p4226_lanes[3] * Lambda_1_11_p3;
  const Real Lambda_1_11_p14 = Lambda_1_11_p13 - Lambda_0_11_p4414_lanes[3] * Lambda_1_11_p4 -
      Lambda_0_11_p4594_lanes[3] * Lambda_1_11_p6 - Lambda_0_11_p4763_lanes[3] * Lambda_1_11_p8 -
      Lambda_0_11_p4896 * Lambda_1_11_p10;
  const Real Lambda_1_11_p15 = Lambda_1_11_p14 - Lambda_0_11_p4912 * Lambda_1_11_p12;
  const Real Lambda_1_11 = Lambda_1_11_p15 * Lambda_11_11;
  Lambda[23] = Lambda_1_11;
  Lambda[133] = Lambda_1_11;
  const Real Lambda_0_1_p1 = Lambda_1_11_p12 * Lambda_0_11_p4911;
  const Real Lambda_0_1_p2 = Lambda_1_11_p10 * Lambda_0_11_p4895;
  const Real Lambda_0_1_p3 = Lambda_1_11_p8 * Lambda_0_11_p4762;
  const Real Lambda_0_1_p4 = Lambda_1_11_p6 * Lambda_0_11_p4593;
  const Real Lambda_0_1_p5 = Lambda_1_11_p4 * Lambda_0_11_p4413;
  const Real Lambda_0_1_p6 = Lambda_1_11_p3 * Lambda_0_11_p4225;
  const Real Lambda_0_1_p7 = Lambda_1_11_p2 * Lambda_0_11_p4072;
  const Real Lambda_0_1_p8 = Lambda_1_11_p1 * Lambda_0_11_p3899;
  const Real Lambda_0_1_p9 = Lambda_0_11_p3546_lanes[2] * Lambda_0_11_p3696;
  const Real Lambda_0_1_p10 = Lambda_0_1_p8 * Lambda_0_11_p4914 -
      (Lambda_0_0_p10 + Lambda_0_1_p9 * Lambda_0_11_p4913) + Lambda_0_1_p7 * Lambda_0_11_p4915 +
      Lambda_0_1_p6 * Lambda_0_11_p4916;
  const Real Lambda_0_1_p11 = Lambda_0_1_p10 + Lambda_0_1_p5 * Lambda_0_11_p4918 + Lambda_0_1_p4 *
      Lambda_0_11_p4920 + Lambda_0_1_p3 * Lambda_0_11_p4922 + Lambda_0_1_p2 * Lambda_0_11_p4924;
  const Real Lambda_0_1 = Lambda_0_1_p11 + Lambda_0_1_p1 * Lambda_0_11_p4927 + Lambda_1_11 *
      Lambda_0_11_p4930;
  Lambda[1] = Lambda_0_1;
  Lambda[12] = Lambda_0_1;
  const Real Lambda_2_11_p1 = Lambda_0_11_p3980_lanes[4] * Lambda_0_11_p3769_lanes[3] -
      Lambda_0_11_p3769_lanes[4];
  const Real Lambda_2_11_p2 = Lambda_0_11_p3980_lanes[5] * Lambda_0_11_p3769_lanes[3] -
      Lambda_0_11_p3769_lanes[5] - Lambda_0_11_p4161_lanes[5] * Lambda_2_11_p1;
  const Real Lambda_2_11_p3 = Lambda_0_11_p3980_lanes[6] * Lambda_0_11_p3769_lanes[3] -
      Lambda_0_11_p3769_lanes[6] - Lambda_0_11_p4161_lanes[6] * Lambda_2_11_p1 - Lambda_0_11_p4407 *
      Lambda_2_11_p2;
  const Real Lambda_2_11_p4 = Lambda_0_11_p3980_lanes[7] * Lambda_0_11_p3769_lanes[3] -
      Lambda_0_11_p3769_lanes[7] - Lambda_0_11_p4161_lanes[7] * Lambda_2_11_p1 - Lambda_0_11_p4418 *
      Lambda_2_11_p2 - Lambda_0_11_p4588 * Lambda_2_11_p3;
  const Real Lambda_2_11_p5 = Lambda_0_11_p3900_lanes[0] * Lambda_0_11_p3769_lanes[3] -
      Lambda_0_11_p3697_lanes[0] - Lambda_0_11_p4073_lanes[0] * Lambda_2_11_p1 -
      Lambda_0_11_p4226_lanes[0] * Lambda_2_11_p2 - Lambda_0_11_p4414_lanes[0] * Lambda_2_11_p3;
  const Real Lambda_2_11_p6 = Lambda_2_11_p5 - Lambda_0_11_p4594_lanes[0] * Lambda_2_11_p4;
  const Real Lambda_2_11_p7 = Lambda_0_11_p3900_lanes[1] * Lambda_0_11_p3769_lanes[3] -
      Lambda_0_11_p3697_lanes[1] - Lambda_0_11_p4073_lanes[1] * Lambda_2_11_p1 -
      Lambda_0_11_p4226_lanes[1] * Lambda_2_11_p2 - Lambda_0_11_p4414_lanes[1] * Lambda_2_11_p3;
  const Real Lambda_2_11_p8 = Lambda_2_11_p7 - Lambda_0_11_p4594_lanes[1] * Lambda_2_11_p4 -
      Lambda_0_11_p4763_lanes[1] * Lambda_2_11_p6;
  const Real Lambda_2_11_p9 = Lambda_0_11_p3900_lanes[2] * Lambda_0_11_p3769_lanes[3] -
      Lambda_0_11_p3697_lanes[2] - Lambda_0_11_p4073_lanes[2] * Lambda_2_11_p1 -
      Lambda_0_11_p4226_lanes[2] * Lambda_2_11_p2 - Lambda_0_11_p4414_lanes[2] * Lambda_2_11_p3;
  const Real Lambda_2_11_p10 = Lambda_2_11_p9 - Lambda_0_11_p4594_lanes[2] * Lambda_2_11_p4 -
      Lambda_0_11_p4763_lanes[2] * Lambda_2_11_p6 - Lambda_0_11_p4905 * Lambda_2_11_p8;
  const Real Lambda_2_11_p11 = Lambda_0_11_p3900_lanes[3] * Lambda_0_11_p3769_lanes[3] -
      Lambda_0_11_p3697_lanes[3] - Lambda_0_11_p4073_lanes[3] * Lambda_2_11_p1 -
      Lambda_0_11_p4226_lanes[3] * Lambda_2_11_p2 - Lambda_0_11_p4414_lanes[3] * Lambda_2_11_p3;
  const Real Lambda_2_11_p12 = Lambda_2_11_p11 - Lambda_0_11_p4594_lanes[3] * Lambda_2_11_p4 -
      Lambda_0_11_p4763_lanes[3] * Lambda_2_11_p6 - Lambda_0_11_p4896 * Lambda_2_11_p8 -
      Lambda_0_11_p4912 * Lambda_2_11_p10;
  const Real Lambda_2_11 = Lambda_2_11_p12 * Lambda_11_11;
  Lambda[35] = Lambda_2_11;
  Lambda[134] = Lambda_2_11;
  const Real Lambda_0_2_p1 = Lambda_2_11_p10 * Lambda_0_11_p4911;
  const Real Lambda_0_2_p2 = Lambda_2_11_p8 * Lambda_0_11_p4895;
  const Real Lambda_0_2_p3 = Lambda_2_11_p6 * Lambda_0_11_p4762;
  const Real Lambda_0_2_p4 = Lambda_2_11_p4 * Lambda_0_11_p4593;
  const Real Lambda_0_2_p5 = Lambda_2_11_p3 * Lambda_0_11_p4413;
  const Real Lambda_0_2_p6 = Lambda_2_11_p2 * Lambda_0_11_p4225;
  const Real Lambda_0_2_p7 = Lambda_2_11_p1 * Lambda_0_11_p4072;
  const Real Lambda_0_2_p8 = Lambda_0_11_p3769_lanes[3] * Lambda_0_11_p3899;
  const Real Lambda_0_2_p9 = Lambda_0_0_p9 - Lambda_0_2_p8 * Lambda_0_11_p4914 + Lambda_0_2_p7 *
      Lambda_0_11_p4915 + Lambda_0_2_p6 * Lambda_0_11_p4916 + Lambda_0_2_p5 * Lambda_0_11_p4918;
  const Real Lambda_0_2_p10 = Lambda_0_2_p9 + Lambda_0_2_p4 * Lambda_0_11_p4920 + Lambda_0_2_p3 *
      Lambda_0_11_p4922 + Lambda_0_2_p2 * Lambda_0_11_p4924 + Lambda_0_2_p1 * Lambda_0_11_p4927;
  const Real Lambda_0_2 = Lambda_0_2_p10 + Lambda_2_11 * Lambda_0_11_p4930;
  Lambda[2] = Lambda_0_2;
  Lambda[24] = Lambda_0_2;
  const Real Lambda_3_11_p1 = Lambda_0_11_p4161_lanes[5] * Lambda_0_11_p3980_lanes[4] -
      Lambda_0_11_p3980_lanes[5];
  const Real Lambda_3_11_p2 = Lambda_0_11_p4161_lanes[6] * Lambda_0_11_p3980_lanes[4] -
      Lambda_0_11_p3980_lanes[6] - Lambda_0_11_p4407 * Lambda_3_11_p1;
  const Real Lambda_3_11_p3 = Lambda_0_11_p4161_lanes[7] * Lambda_0_11_p3980_lanes[4] -
      Lambda_0_11_p3980_lanes[7] - Lambda_0_11_p4418 * Lambda_3_11_p1 - Lambda_0_11_p4588 *
      Lambda_3_11_p2;
  const Real Lambda_3_11_p4 = Lambda_0_11_p4073_lanes[0] * Lambda_0_11_p3980_lanes[4] -
      Lambda_0_11_p3900_lanes[0] - Lambda_0_11_p4226_lanes[0] * Lambda_3_11_p1 -
      Lambda_0_11_p4414_lanes[0] * Lambda_3_11_p2 - Lambda_0_11_p4594_lanes[0] * Lambda_3_11_p3;
  const Real Lambda_3_11_p5 = Lambda_0_11_p4073_lanes[1] * Lambda_0_11_p3980_lanes[4] -
      Lambda_0_11_p3900_lanes[1] - Lambda_0_11_p4226_lanes[1] * Lambda_3_11_p1 -
      Lambda_0_11_p4414_lanes[1] * Lambda_3_11_p2 - Lambda_0_11_p4594_lanes[1] * Lambda_3_11_p3;
  const Real Lambda_3_11_p6 = Lambda_3_11_p5 - Lambda_0_11_p4763_lanes[1] * Lambda_3_11_p4;
  const Real Lambda_3_11_p7 = Lambda_0_11_p4073_lanes[2] * Lambda_0_11_p3980_lanes[4] -
      Lambda_0_11_p3900_lanes[2] - Lambda_0_11_p4226_lanes[2] * Lambda_3_11_p1 -
      Lambda_0_11_p4414_lanes[2] * Lambda_3_11_p2 - Lambda_0_11_p4594_lanes[2] * Lambda_3_11_p3;
  const Real Lambda_3_11_p8 = Lambda_3_11_p7 - Lambda_0_11_p4763_lanes[2] * Lambda_3_11_p4 -
      Lambda_0_11_p4905 * Lambda_3_11_p6;
  const Real Lambda_3_11_p9 = Lambda_0_11_p4073_lanes[3] * Lambda_0_11_p3980_lanes[4] -
      Lambda_0_11_p3900_lanes[3] - Lambda_0_11_p4226_lanes[3] * Lambda_3_11_p1 -
      Lambda_0_11_p4414_lanes[3] * Lambda_3_11_p2 - Lambda_0_11_p4594_lanes[3] * Lambda_3_11_p3;
  const Real Lambda_3_11_p10 = Lambda_3_11_p9 - Lambda_0_11_p4763_lanes[3] * Lambda_3_11_p4 -
      Lambda_0_11_p4896 * Lambda_3_11_p6 - Lambda_0_11_p4912 * Lambda_3_11_p8;
  const Real Lambda_3_11 = Lambda_3_11_p10 * Lambda_11_11;
  Lambda[47] = Lambda_3_11;
  Lambda[135] = Lambda_3_11;
  const Real Lambda_0_3_p1 = Lambda_3_11_p8 * Lambda_0_11_p4911;
  const Real Lambda_0_3_p2 = Lambda_3_11_p6 * Lambda_0_11_p4895;
  const Real Lambda_0_3_p3 = Lambda_3_11_p4 * Lambda_0_11_p4762;
  const Real Lambda_0_3_p4 = Lambda_3_11_p3 * Lambda_0_11_p4593;
  const Real Lambda_0_3_p5 = Lambda_3_11_p2 * Lambda_0_11_p4413;
  const Real Lambda_0_3_p6 = Lambda_3_11_p1 * Lambda_0_11_p4225;
  const Real Lambda_0_3_p7 = Lambda_0_11_p3980_lanes[4] * Lambda_0_11_p4072;
  const Real Lambda_0_3_p8 = Lambda_0_0_p8 - Lambda_0_3_p7 * Lambda_0_11_p4915 + Lambda_0_3_p6 *
      Lambda_0_11_p4916 + Lambda_0_3_p5 * Lambda_0_11_p4918 + Lambda_0_3_p4 * Lambda_0_11_p4920;
  const Real Lambda_0_3 = Lambda_0_3_p8 + Lambda_0_3_p3 * Lambda_0_11_p4922 + Lambda_0_3_p2 *
      Lambda_0_11_p4924 + Lambda_0_3_p1 * Lambda_0_11_p4927 + Lambda_3_11 * Lambda_0_11_p4930;
  Lambda[3] = Lambda_0_3;
  Lambda[36] = Lambda_0_3;
  const Real Lambda_4_11_p1 = Lambda_0_11_p4407 * Lambda_0_11_p4161_lanes[5] -
      Lambda_0_11_p4161_lanes[6];
  const Real Lambda_4_11_p2 = Lambda_0_11_p4418 * Lambda_0_11_p4161_lanes[5] -
      Lambda_0_11_p4161_lanes[7] - Lambda_0_11_p4588 * Lambda_4_11_p1;
  const Real Lambda_4_11_p3 = Lambda_0_11_p4226_lanes[0] * Lambda_0_11_p4161_lanes[5] -
      Lambda_0_11_p4073_lanes[0] - Lambda_0_11_p4414_lanes[0] * Lambda_4_11_p1 -
      Lambda_0_11_p4594_lanes[0] * Lambda_4_11_p2;
  const Real Lambda_4_11_p4 = Lambda_0_11_p4226_lanes[1] * Lambda_0_11_p4161_lanes[5] -
      Lambda_0_11_p4073_lanes[1] - Lambda_0_11_p4414_lanes[1] * Lambda_4_11_p1 -
      Lambda_0_11_p4594_lanes[1] * Lambda_4_11_p2 - Lambda_0_11_p4763_lanes[1] * Lambda_4_11_p3;
  const Real Lambda_4_11_p5 = Lambda_0_11_p4226_lanes[2] * Lambda_0_11_p4161_lanes[5] -
      Lambda_0_11_p4073_lanes[2] - Lambda_0_11_p4414_lanes[2] * Lambda_4_11_p1 -
      Lambda_0_11_p4594_lanes[2] * Lambda_4_11_p2 - Lambda_0_11_p4763_lanes[2] * Lambda_4_11_p3;
  const Real Lambda_4_11_p6 = Lambda_4_11_p5 - Lambda_0_11_p4905 * Lambda_4_11_p4;
  const Real Lambda_4_11_p7 = Lambda_0_11_p4226_lanes[3] * Lambda_0_11_p4161_lanes[5] -
      Lambda_0_11_p4073_lanes[3] - Lambda_0_11_p4414_lanes[3] * Lambda_4_11_p1 -
      Lambda_0_11_p4594_lanes[3] * Lambda_4_11_p2 - Lambda_0_11_p4763_lanes[3] * Lambda_4_11_p3;
  const Real Lambda_4_11_p8 = Lambda_4_11_p7 - Lambda_0_11_p4896 * Lambda_4_11_p4 -
      Lambda_0_11_p4912 * Lambda_4_11_p6;
  const Real Lambda_4_11 = Lambda_4_11_p8 * Lambda_11_11;
  Lambda[59] = Lambda_4_11;
  Lambda[136] = Lambda_4_11;
  const Real Lambda_0_4_p1 = Lambda_4_11_p6 * Lambda_0_11_p4911;
  const Real Lambda_0_4_p2 = Lambda_4_11_p4 * Lambda_0_11_p4895;
  const Real Lambda_0_4_p3 = Lambda_4_11_p3 * Lambda_0_11_p4762;
  const Real Lambda_0_4_p4 = Lambda_4_11_p2 * Lambda_0_11_p4593;
  const Real Lambda_0_4_p5 = Lambda_4_11_p1 * Lambda_0_11_p4413;
  const Real Lambda_0_4_p6 = Lambda_0_11_p4161_lanes[5] * Lambda_0_11_p4225;
  const Real Lambda_0_4_p7 = Lambda_0_0_p7 - Lambda_0_4_p6 * Lambda_0_11_p4916 + Lambda_0_4_p5 *
      Lambda_0_11_p4918 + Lambda_0_4_p4 * Lambda_0_11_p4920 + Lambda_0_4_p3 * Lambda_0_11_p4922;
  const Real Lambda_0_4 = Lambda_0_4_p7 + Lambda_0_4_p2 * Lambda_0_11_p4924 + Lambda_0_4_p1 *
      Lambda_0_11_p4927 + Lambda_4_11 * Lambda_0_11_p4930;
  Lambda[4] = Lambda_0_4;
  Lambda[48] = Lambda_0_4;
  const Real Lambda_5_11_p1 = Lambda_0_11_p4588 * Lambda_0_11_p4407 - Lambda_0_11_p4418;
  const Real Lambda_5_11_p2 = Lambda_0_11_p4414_lanes[0] * Lambda_0_11_p4407 -
      Lambda_0_11_p4226_lanes[0] - Lambda_0_11_p4594_lanes[0] * Lambda_5_11_p1;
  const Real Lambda_5_11_p3 = Lambda_0_11_p4414_lanes[1] * Lambda_0_11_p4407 -
      Lambda_0_11_p4226_lanes[1] - Lambda_0_11_p4594_lanes[1] * Lambda_5_11_p1 -
      Lambda_0_11_p4763_lanes[1] * Lambda_5_11_p2;
  const Real Lambda_5_11_p4 = Lambda_0_11_p4414_lanes[2] * Lambda_0_11_p4407 -
      Lambda_0_11_p4226_lanes[2] - Lambda_0_11_p4594_lanes[2] * Lambda_5_11_p1 -
      Lambda_0_11_p4763_lanes[2] * Lambda_5_11_p2 - Lambda_0_11_p4905 * Lambda_5_11_p3;
  const Real Lambda_5_11_p5 = Lambda_0_11_p4414_lanes[3] * Lambda_0_11_p4407 -
      Lambda_0_11_p4226_lanes[3] - Lambda_0_11_p4594_lanes[3] * Lambda_5_11_p1 -
      Lambda_0_11_p4763_lanes[3] * Lambda_5_11_p2 - Lambda_0_11_p4896 * Lambda_5_11_p3;
  const Real Lambda_5_11_p6 = Lambda_5_11_p5 - Lambda_0_11_p4912 * Lambda_5_11_p4;
  const Real Lambda_5_11 = Lambda_5_11_p6 * Lambda_11_11;
  Lambda[71] = Lambda_5_11;
  Lambda[137] = Lambda_5_11;
  const Real Lambda_0_5_p1 = Lambda_5_11_p4 * Lambda_0_11_p4911;
  const Real Lambda_0_5_p2 = Lambda_5_11_p3 * Lambda_0_11_p4895;
  const Real Lambda_0_5_p3 = Lambda_5_11_p2 * Lambda_0_11_p4762;
  const Real Lambda_0_5_p4 = Lambda_5_11_p1 * Lambda_0_11_p4593;
  const Real Lambda_0_5_p5 = Lambda_0_11_p4407 * Lambda_0_11_p4413;
  const Real Lambda_0_5_p6 = Lambda_0_0_p6 - Lambda_0_5_p5 * Lambda_0_11_p4918 + Lambda_0_5_p4 *
      Lambda_0_11_p4920 + Lambda_0_5_p3 * Lambda_0_11_p4922 + Lambda_0_5_p2 * Lambda_0_11_p4924;
  const Real Lambda_0_5 = Lambda_0_5_p6 + Lambda_0_5_p1 * Lambda_0_11_p4927 + Lambda_5_11 *
      Lambda_0_11_p4930;
  Lambda[5] = Lambda_0_5;
  Lambda[60] = Lambda_0_5;
  const Real Lambda_6_11_p1 = Lambda_0_11_p4594_lanes[0] * Lambda_0_11_p4588 -
      Lambda_0_11_p4414_lanes[0];
  const Real Lambda_6_11_p2 = Lambda_0_11_p4594_lanes[1] * Lambda_0_11_p4588 -
      Lambda_0_11_p4414_lanes[1] - Lambda_0_11_p4763_lanes[1] * Lambda_6_11_p1;
  const Real Lambda_6_11_p3 = Lambda_0_11_p4594_lanes[2] * Lambda_0_11_p4588 -
      Lambda_0_11_p4414_lanes[2] - Lambda_0_11_p4763_lanes[2] * Lambda_6_11_p1 - Lambda_0_11_p4905 *
      Lambda_6_11_p2;
  const Real Lambda_6_11_p4 = Lambda_0_11_p4594_lanes[3] * Lambda_0_11_p4588 -
      Lambda_0_11_p4414_lanes[3] - Lambda_0_11_p4763_lanes[3] * Lambda_6_11_p1 - Lambda_0_11_p4896 *
      Lambda_6_11_p2 - Lambda_0_11_p4912 * Lambda_6_11_p3;
  const Real Lambda_6_11 = Lambda_6_11_p4 * Lambda_11_11;
  Lambda[83] = Lambda_6_11;
  Lambda[138] = Lambda_6_11;
  const Real Lambda_0_6_p1 = Lambda_6_11_p3 * Lambda_0_11_p4911;
  const Real Lambda_0_6_p2 = Lambda_6_11_p2 * Lambda_0_11_p4895;
  const Real Lambda_0_6_p3 = Lambda_6_11_p1 * Lambda_0_11_p4762;
  const Real Lambda_0_6_p4 = Lambda_0_11_p4588 * Lambda_0_11_p4593;
  const Real Lambda_0_6_p5 = Lambda_0_0_p5 - Lambda_0_6_p4 * Lambda_0_11_p4920 + Lambda_0_6_p3 *
      Lambda_0_11_p4922 + Lambda_0_6_p2 * Lambda_0_11_p4924 + Lambda_0_6_p1 * Lambda_0_11_p4927;
  const Real Lambda_0_6 = Lambda_0_6_p5 + Lambda_6_11 * Lambda_0_11_p4930;
  Lambda[6] = Lambda_0_6;
  Lambda[72] = Lambda_0_6;
  const Real Lambda_7_11_p1 = Lambda_0_11_p4763_lanes[1] * Lambda_0_11_p4594_lanes[0] -
      Lambda_0_11_p4594_lanes[1];
  const Real Lambda_7_11_p2 = Lambda_0_11_p4763_lanes[2] * Lambda_0_11_p4594_lanes[0] -
      Lambda_0_11_p4594_lanes[2] - Lambda_0_11_p4905 * Lambda_7_11_p1;
  const Real Lambda_7_11_p3 = Lambda_0_11_p4763_lanes[3] * Lambda_0_11_p4594_lanes[0] -
      Lambda_0_11_p4594_lanes[3] - Lambda_0_11_p4896 * Lambda_7_11_p1 - Lambda_0_11_p4912 *
      Lambda_7_11_p2;
  const Real Lambda_7_11 = Lambda_7_11_p3 * Lambda_11_11;
  Lambda[95] = Lambda_7_11;
  Lambda[139] = Lambda_7_11;
  const Real Lambda_0_7_p1 = Lambda_7_11_p2 * Lambda_0_11_p4911;
  const Real Lambda_0_7_p2 = Lambda_7_11_p1 * Lambda_0_11_p4895;
  const Real Lambda_0_7_p3 = Lambda_0_11_p4594_lanes[0] * Lambda_0_11_p4762;
  const Real Lambda_0_7 = Lambda_0_0_p4 - Lambda_0_7_p3 * Lambda_0_11_p4922 + Lambda_0_7_p2 *
      Lambda_0_11_p4924 + Lambda_0_7_p1 * Lambda_0_11_p4927 + Lambda_7_11 * Lambda_0_11_p4930;
  Lambda[7] = Lambda_0_7;
  Lambda[84] = Lambda_0_7;
  const Real Lambda_8_11_p1 = Lambda_0_11_p4905 * Lambda_0_11_p4763_lanes[1] -
      Lambda_0_11_p4763_lanes[2];
  const Real Lambda_8_11_p2 = Lambda_0_11_p4896 * Lambda_0_11_p4763_lanes[1] -
      Lambda_0_11_p4763_lanes[3] - Lambda_0_11_p4912 * Lambda_8_11_p1;
  const Real Lambda_8_11 = Lambda_8_11_p2 * Lambda_11_11;
  Lambda[107] = Lambda_8_11;
  Lambda[140] = Lambda_8_11;
  const Real Lambda_0_8_p1 = Lambda_8_11_p1 * Lambda_0_11_p4911;
  const Real Lambda_0_8_p2 = Lambda_0_11_p4763_lanes[1] * Lambda_0_11_p4895;
  const Real Lambda_0_8 = Lambda_0_0_p3 - Lambda_0_8_p2 * Lambda_0_11_p4924 + Lambda_0_8_p1 *
      Lambda_0_11_p4927 + Lambda_8_11 * Lambda_0_11_p4930;
  Lambda[8] = Lambda_0_8;
  Lambda[96] = Lambda_0_8;
  const Real Lambda_9_11_p1 = Lambda_0_11_p4912 * Lambda_0_11_p4905 - Lambda_0_11_p4896;
  const Real Lambda_9_11 = Lambda_9_11_p1 * Lambda_11_11;
  Lambda[119] = Lambda_9_11;
  Lambda[141] = Lambda_9_11;
  const Real Lambda_0_9_p1 = Lambda_0_11_p4905 * Lambda_0_11_p4911;
  const Real Lambda_0_9 = Lambda_0_0_p2 - Lambda_0_9_p1 * Lambda_0_11_p4927 + Lambda_9_11 *
      Lambda_0_11_p4930;
  Lambda[9] = Lambda_0_9;
  Lambda[108] = Lambda_0_9;
  const Real Lambda_10_11 = Lambda_0_11_p4912 * Lambda_11_11;
  Lambda[131] = -Lambda_10_11;
  Lambda[142] = -Lambda_10_11;
  const Real Lambda_0_10 = Lambda_0_0_p1 - Lambda_10_11 * Lambda_0_11_p4930;
  Lambda[10] = Lambda_0_10;
  Lambda[120] = Lambda_0_10;
  const Real Lambda_1_1_p1 = Lambda_0_11_p3481 + Lambda_0_1_p9 * Lambda_0_11_p3546_lanes[2] +
      Lambda_0_1_p8 * Lambda_1_11_p1 + Lambda_0_1_p7 * Lambda_1_11_p2 + Lambda_0_1_p6 *
      Lambda_1_11_p3;
  const Real Lambda_1_1_p2 = Lambda_1_1_p1 + Lambda_0_1_p5 * Lambda_1_11_p4 + Lambda_0_1_p4 *
      Lambda_1_11_p6 + Lambda_0_1_p3 * Lambda_1_11_p8 + Lambda_0_1_p2 * Lambda_1_11_p10;
  Lambda[13] = Lambda_1_1_p2 + Lambda_0_1_p1 * Lambda_1_11_p12 + Lambda_1_11 * Lambda_1_11_p15;
  const Real Lambda_1_2_p1 = Lambda_0_2_p7 * Lambda_1_11_p2 -
      (Lambda_0_1_p9 + Lambda_0_2_p8 * Lambda_1_11_p1) + Lambda_0_2_p6 * Lambda_1_11_p3 +
      Lambda_0_2_p5 * Lambda_1_11_p4;
  const Real Lambda_1_2_p2 = Lambda_1_2_p1 + Lambda_0_2_p4 * Lambda_1_11_p6 + Lambda_0_2_p3 *
      Lambda_1_11_p8 + Lambda_0_2_p2 * Lambda_1_11_p10 + Lambda_0_2_p1 * Lambda_1_11_p12;
  const Real Lambda_1_2 = Lambda_1_2_p2 + Lambda_2_11 * Lambda_1_11_p15;
  Lambda[14] = Lambda_1_2;
  Lambda[25] = Lambda_1_2;
  const Real Lambda_1_3_p1 = Lambda_0_1_p8 - Lambda_0_3_p7 * Lambda_1_11_p2 + Lambda_0_3_p6 *
      Lambda_1_11_p3 + Lambda_0_3_p5 * Lambda_1_11_p4 + Lambda_0_3_p4 * Lambda_1_11_p6;
  const Real Lambda_1_3 = Lambda_1_3_p1 + Lambda_0_3_p3 * Lambda_1_11_p8 + Lambda_0_3_p2 *
      Lambda_1_11_p10 + Lambda_0_3_p1 * Lambda_1_11_p12 + Lambda_3_11 * Lambda_1_11_p15;
  Lambda[15] = Lambda_1_3;
  Lambda[37] = Lambda_1_3;
  const Real Lambda_1_4_p1 = Lambda_0_1_p7 - Lambda_0_4_p6 * Lambda_1_11_p3 + Lambda_0_4_p5 *
      Lambda_1_11_p4 + Lambda_0_4_p4 * Lambda_1_11_p6 + Lambda_0_4_p3 * Lambda_1_11_p8;
  const Real Lambda_1_4 = Lambda_1_4_p1 + Lambda_0_4_p2 * Lambda_1_11_p10 + Lambda_0_4_p1 *
      Lambda_1_11_p12 + Lambda_4_11 * Lambda_1_11_p15;
  Lambda[16] = Lambda_1_4;
  Lambda[49] = Lambda_1_4;
  const Real Lambda_1_5_p1 = Lambda_0_1_p6 - Lambda_0_5_p5 * Lambda_1_11_p4 + Lambda_0_5_p4 *
      Lambda_1_11_p6 + Lambda_0_5_p3 * Lambda_1_11_p8 + Lambda_0_5_p2 * Lambda_1_11_p10;
  const Real Lambda_1_5 = Lambda_1_5_p1 + Lambda_0_5_p1 * Lambda_1_11_p12 + Lambda_5_11 *
      Lambda_1_11_p15;
  Lambda[17] = Lambda_1_5;
  Lambda[61] = Lambda_1_5;
  const Real Lambda_1_6_p1 = Lambda_0_1_p5 - Lambda_0_6_p4 * Lambda_1_11_p6 + Lambda_0_6_p3 *
      Lambda_1_11_p8 + Lambda_0_6_p2 * Lambda_1_11_p10 + Lambda_0_6_p1 * Lambda_1_11_p12;
  const Real Lambda_1_6 = Lambda_1_6_p1 + Lambda_6_11 * Lambda_1_11_p15;
  Lambda[18] = Lambda_1_6;
  Lambda[73] = Lambda_1_6;
  const Real Lambda_1_7 = Lambda_0_1_p4 - Lambda_0_7_p3 * Lambda_1_11_p8 + Lambda_0_7_p2 *
      Lambda_1_11_p10 + Lambda_0_7_p1 * Lambda_1_11_p12 + Lambda_7_11 * Lambda_1_11_p15;
  Lambda[19] = Lambda_1_7;
  Lambda[85] = Lambda_1_7;
  const Real Lambda_1_8 = Lambda_0_1_p3 - Lambda_0_8_p2 * Lambda_1_11_p10 + Lambda_0_8_p1 *
      Lambda_1_11_p12 + Lambda_8_11 * Lambda_1_11_p15;
  Lambda[20] = Lambda_1_8;
  Lambda[97] = Lambda_1_8;
  const Real Lambda_1_9 = Lambda_0_1_p2 - Lambda_0_9_p1 * Lambda_1_11_p12 + Lambda_9_11 *
      Lambda_1_11_p15;
  Lambda[21] = Lambda_1_9;
  Lambda[109] = Lambda_1_9;
  const Real Lambda_1_10 = Lambda_0_1_p1 - Lambda_10_11 * Lambda_1_11_p15;
  Lambda[22] = Lambda_1_10;
  Lambda[121] = Lambda_1_10;
  const Real Lambda_2_2_p1 = Lambda_0_11_p3696 + Lambda_0_2_p8 * Lambda_0_11_p3769_lanes[3] +
      Lambda_0_2_p7 * Lambda_2_11_p1 + Lambda_0_2_p6 * Lambda_2_11_p2 + Lambda_0_2_p5 *
      Lambda_2_11_p3;
  const Real Lambda_2_2_p2 = Lambda_2_2_p1 + Lambda_0_2_p4 * Lambda_2_11_p4 + Lambda_0_2_p3 *
      Lambda_2_11_p6 + Lambda_0_2_p2 * Lambda_2_11_p8 + Lambda_0_2_p1 * Lambda_2_11_p10;
  Lambda[26] = Lambda_2_2_p2 + Lambda_2_11 * Lambda_2_11_p12;
  const Real Lambda_2_3_p1 = Lambda_0_3_p6 * Lambda_2_11_p2 -
      (Lambda_0_2_p8 + Lambda_0_3_p7 * Lambda_2_11_p1) + Lambda_0_3_p5 * Lambda_2_11_p3 +
      Lambda_0_3_p4 * Lambda_2_11_p4;
  const Real Lambda_2_3 = Lambda_2_3_p1 + Lambda_0_3_p3 * Lambda_2_11_p6 + Lambda_0_3_p2 *
      Lambda_2_11_p8 + Lambda_0_3_p1 * Lambda_2_11_p10 + Lambda_3_11 * Lambda_2_11_p12;
  Lambda[27] = Lambda_2_3;
  Lambda[38] = Lambda_2_3;
  const Real Lambda_2_4_p1 = Lambda_0_2_p7 - Lambda_0_4_p6 * Lambda_2_11_p2 + Lambda_0_4_p5 *
      Lambda_2_11_p3 + Lambda_0_4_p4 * Lambda_2_11_p4 + Lambda_0_4_p3 * Lambda_2_11_p6;
  const Real Lambda_2_4 = Lambda_2_4_p1 + Lambda_0_4_p2 * Lambda_2_11_p8 + Lambda_0_4_p1 *
      Lambda_2_11_p10 + Lambda_4_11 * Lambda_2_11_p12;
  Lambda[28] = Lambda_2_4;
  Lambda[50] = Lambda_2_4;
  const Real Lambda_2_5_p1 = Lambda_0_2_p6 - Lambda_0_5_p5 * Lambda_2_11_p3 + Lambda_0_5_p4 *
      Lambda_2_11_p4 + Lambda_0_5_p3 * Lambda_2_11_p6 + Lambda_0_5_p2 * Lambda_2_11_p8;
  const Real Lambda_2_5 = Lambda_2_5_p1 + Lambda_0_5_p1 * Lambda_2_11_p10 + Lambda_5_11 *
      Lambda_2_11_p12;
  Lambda[29] = Lambda_2_5;
  Lambda[62] = Lambda_2_5;
  const Real Lambda_2_6_p1 = Lambda_0_2_p5 - Lambda_0_6_p4 * Lambda_2_11_p4 + Lambda_0_6_p3 *
      Lambda_2_11_p6 + Lambda_0_6_p2 * Lambda_2_11_p8 + Lambda_0_6_p1 * Lambda_2_11_p10;
  const Real Lambda_2_6 = Lambda_2_6_p1 + Lambda_6_11 * Lambda_2_11_p12;
  Lambda[30] = Lambda_2_6;
  Lambda[74] = Lambda_2_6;
  const Real Lambda_2_7 = Lambda_0_2_p4 - Lambda_0_7_p3 * Lambda_2_11_p6 + Lambda_0_7_p2 *
      Lambda_2_11_p8 + Lambda_0_7_p1 * Lambda_2_11_p10 + Lambda_7_11 * Lambda_2_11_p12;
  Lambda[31] = Lambda_2_7;
  Lambda[86] = Lambda_2_7;
  const Real Lambda_2_8 = Lambda_0_2_p3 - Lambda_0_8_p2 * Lambda_2_11_p8 + Lambda_0_8_p1 *
      Lambda_2_11_p10 + Lambda_8_11 * Lambda_2_11_p12;
  Lambda[32] = Lambda_2_8;
  Lambda[98] = Lambda_2_8;
  const Real Lambda_2_9 = Lambda_0_2_p2 - Lambda_0_9_p1 * Lambda_2_11_p10 + Lambda_9_11 *
      Lambda_2_11_p12;
  Lambda[33] = Lambda_2_9;
  Lambda[110] = Lambda_2_9;
  const Real Lambda_2_10 = Lambda_0_2_p1 - Lambda_10_11 * Lambda_2_11_p12;
  Lambda[34] = Lambda_2_10;
  Lambda[122] = Lambda_2_10;
  const Real Lambda_3_3_p1 = Lambda_0_11_p3899 + Lambda_0_3_p7 * Lambda_0_11_p3980_lanes[4] +
      Lambda_0_3_p6 * Lambda_3_11_p1 + Lambda_0_3_p5 * Lambda_3_11_p2 + Lambda_0_3_p4 *
      Lambda_3_11_p3;
  Lambda[39] = Lambda_3_3_p1 + Lambda_0_3_p3 * Lambda_3_11_p4 + Lambda_0_3_p2 * Lambda_3_11_p6 +
      Lambda_0_3_p1 * Lambda_3_11_p8 + Lambda_3_11 * Lambda_3_11_p10;
  const Real Lambda_3_4_p1 = Lambda_0_4_p5 * Lambda_3_11_p2 -
      (Lambda_0_3_p7 + Lambda_0_4_p6 * Lambda_3_11_p1) + Lambda_0_4_p4 * Lambda_3_11_p3 +
      Lambda_0_4_p3 * Lambda_3_11_p4;
  const Real Lambda_3_4 = Lambda_3_4_p1 + Lambda_0_4_p2 * Lambda_3_11_p6 + Lambda_0_4_p1 *
      Lambda_3_11_p8 + Lambda_4_11 * Lambda_3_11_p10;
  Lambda[40] = Lambda_3_4;
  Lambda[51] = Lambda_3_4;
  const Real Lambda_3_5_p1 = Lambda_0_3_p6 - Lambda_0_5_p5 * Lambda_3_11_p2 + Lambda_0_5_p4 *
      Lambda_3_11_p3 + Lambda_0_5_p3 * Lambda_3_11_p4 + Lambda_0_5_p2 * Lambda_3_11_p6;
  const Real Lambda_3_5 = Lambda_3_5_p1 + Lambda_0_5_p1 * Lambda_3_11_p8 + Lambda_5_11 *
      Lambda_3_11_p10;
  Lambda[41] = Lambda_3_5;
  Lambda[63] = Lambda_3_5;
  const Real Lambda_3_6_p1 = Lambda_0_3_p5 - Lambda_0_6_p4 * Lambda_3_11_p3 + Lambda_0_6_p3 *
      Lambda_3_11_p4 + Lambda_0_6_p2 * Lambda_3_11_p6 + Lambda_0_6_p1 * Lambda_3_11_p8;
  const Real Lambda_3_6 = Lambda_3_6_p1 + Lambda_6_11 * Lambda_3_11_p10;
  Lambda[42] = Lambda_3_6;
  Lambda[75] = Lambda_3_6;
  const Real Lambda_3_7 = Lambda_0_3_p4 - Lambda_0_7_p3 * Lambda_3_11_p4 + Lambda_0_7_p2 *
      Lambda_3_11_p6 + Lambda_0_7_p1 * Lambda_3_11_p8 + Lambda_7_11 * Lambda_3_11_p10;
  Lambda[43] = Lambda_3_7;
  Lambda[87] = Lambda_3_7;
  const Real Lambda_3_8 = Lambda_0_3_p3 - Lambda_0_8_p2 * Lambda_3_11_p6 + Lambda_0_8_p1 *
      Lambda_3_11_p8 + Lambda_8_11 * Lambda_3_11_p10;
  Lambda[44] = Lambda_3_8;
  Lambda[99] = Lambda_3_8;
  const Real Lambda_3_9 = Lambda_0_3_p2 - Lambda_0_9_p1 * Lambda_3_11_p8 + Lambda_9_11 *
      Lambda_3_11_p10;
  Lambda[45] = Lambda_3_9;
  Lambda[111] = Lambda_3_9;
  const Real Lambda_3_10 = Lambda_0_3_p1 - Lambda_10_11 * Lambda_3_11_p10;
  Lambda[46] = Lambda_3_10;
  Lambda[123] = Lambda_3_10;
  const Real Lambda_4_4_p1 = Lambda_0_11_p4072 + Lambda_0_4_p6 * Lambda_0_11_p4161_lanes[5] +
      Lambda_0_4_p5 * Lambda_4_11_p1 + Lambda_0_4_p4 * Lambda_4_11_p2 + Lambda_0_4_p3 *
      Lambda_4_11_p3;
  Lambda[52] = Lambda_4_4_p1 + Lambda_0_4_p2 * Lambda_4_11_p4 + Lambda_0_4_p1 * Lambda_4_11_p6 +
      Lambda_4_11 * Lambda_4_11_p8;
  const Real Lambda_4_5_p1 = Lambda_0_5_p4 * Lambda_4_11_p2 -
      (Lambda_0_4_p6 + Lambda_0_5_p5 * Lambda_4_11_p1) + Lambda_0_5_p3 * Lambda_4_11_p3 +
      Lambda_0_5_p2 * Lambda_4_11_p4;
  const Real Lambda_4_5 = Lambda_4_5_p1 + Lambda_0_5_p1 * Lambda_4_11_p6 + Lambda_5_11 *
      Lambda_4_11_p8;
  Lambda[53] = Lambda_4_5;
  Lambda[64] = Lambda_4_5;
  const Real Lambda_4_6_p1 = Lambda_0_4_p5 - Lambda_0_6_p4 * Lambda_4_11_p2 + Lambda_0_6_p3 *
      Lambda_4_11_p3 + Lambda_0_6_p2 * Lambda_4_11_p4 + Lambda_0_6_p1 * Lambda_4_11_p6;
  const Real Lambda_4_6 = Lambda_4_6_p1 + Lambda_6_11 * Lambda_4_11_p8;
  Lambda[54] = Lambda_4_6;
  Lambda[76] = Lambda_4_6;
  const Real Lambda_4_7 = Lambda_0_4_p4 - Lambda_0_7_p3 * Lambda_4_11_p3 + Lambda_0_7_p2 *
      Lambda_4_11_p4 + Lambda_0_7_p1 * Lambda_4_11_p6 + Lambda_7_11 * Lambda_4_11_p8;
  Lambda[55] = Lambda_4_7;
  Lambda[88] = Lambda_4_7;
  const Real Lambda_4_8 = Lambda_0_4_p3 - Lambda_0_8_p2 * Lambda_4_11_p4 + Lambda_0_8_p1 *
      Lambda_4_11_p6 + Lambda_8_11 * Lambda_4_11_p8;
  Lambda[56] = Lambda_4_8;
  Lambda[100] = Lambda_4_8;
  const Real Lambda_4_9 = Lambda_0_4_p2 - Lambda_0_9_p1 * Lambda_4_11_p6 + Lambda_9_11 *
      Lambda_4_11_p8;
  Lambda[57] = Lambda_4_9;
  Lambda[112] = Lambda_4_9;
  const Real Lambda_4_10 = Lambda_0_4_p1 - Lambda_10_11 * Lambda_4_11_p8;
  Lambda[58] = Lambda_4_10;
  Lambda[124] = Lambda_4_10;
  const Real Lambda_5_5_p1 = Lambda_0_11_p4225 + Lambda_0_5_p5 * Lambda_0_11_p4407 + Lambda_0_5_p4 *
      Lambda_5_11_p1 + Lambda_0_5_p3 * Lambda_5_11_p2 + Lambda_0_5_p2 * Lambda_5_11_p3;
  Lambda[65] = Lambda_5_5_p1 + Lambda_0_5_p1 * Lambda_5_11_p4 + Lambda_5_11 * Lambda_5_11_p6;
  const Real Lambda_5_6_p1 = Lambda_0_6_p3 * Lambda_5_11_p2 -
      (Lambda_0_5_p5 + Lambda_0_6_p4 * Lambda_5_11_p1) + Lambda_0_6_p2 * Lambda_5_11_p3 +
      Lambda_0_6_p1 * Lambda_5_11_p4;
  const Real Lambda_5_6 = Lambda_5_6_p1 + Lambda_6_11 * Lambda_5_11_p6;
  Lambda[66] = Lambda_5_6;
  Lambda[77] = Lambda_5_6;
  const Real Lambda_5_7 = Lambda_0_5_p4 - Lambda_0_7_p3 * Lambda_5_11_p2 + Lambda_0_7_p2 *
      Lambda_5_11_p3 + Lambda_0_7_p1 * Lambda_5_11_p4 + Lambda_7_11 * Lambda_5_11_p6;
  Lambda[67] = Lambda_5_7;
  Lambda[89] = Lambda_5_7;
  const Real Lambda_5_8 = Lambda_0_5_p3 - Lambda_0_8_p2 * Lambda_5_11_p3 + Lambda_0_8_p1 *
      Lambda_5_11_p4 + Lambda_8_11 * Lambda_5_11_p6;
  Lambda[68] = Lambda_5_8;
  Lambda[101] = Lambda_5_8;
  const Real Lambda_5_9 = Lambda_0_5_p2 - Lambda_0_9_p1 * Lambda_5_11_p4 + Lambda_9_11 *
      Lambda_5_11_p6;
  Lambda[69] = Lambda_5_9;
  Lambda[113] = Lambda_5_9;
  const Real Lambda_5_10 = Lambda_0_5_p1 - Lambda_10_11 * Lambda_5_11_p6;
  Lambda[70] = Lambda_5_10;
  Lambda[125] = Lambda_5_10;
  const Real Lambda_6_6_p1 = Lambda_0_11_p4413 + Lambda_0_6_p4 * Lambda_0_11_p4588 + Lambda_0_6_p3 *
      Lambda_6_11_p1 + Lambda_0_6_p2 * Lambda_6_11_p2 + Lambda_0_6_p1 * Lambda_6_11_p3;
  Lambda[78] = Lambda_6_6_p1 + Lambda_6_11 * Lambda_6_11_p4;
  const Real Lambda_6_7 = Lambda_0_7_p2 * Lambda_6_11_p2 -
      (Lambda_0_6_p4 + Lambda_0_7_p3 * Lambda_6_11_p1) + Lambda_0_7_p1 * Lambda_6_11_p3 +
      Lambda_7_11 * Lambda_6_11_p4;
  Lambda[79] = Lambda_6_7;
  Lambda[90] = Lambda_6_7;
  const Real Lambda_6_8 = Lambda_0_6_p3 - Lambda_0_8_p2 * Lambda_6_11_p2 + Lambda_0_8_p1 *
      Lambda_6_11_p3 + Lambda_8_11 * Lambda_6_11_p4;
  Lambda[80] = Lambda_6_8;
  Lambda[102] = Lambda_6_8;
  const Real Lambda_6_9 = Lambda_0_6_p2 - Lambda_0_9_p1 * Lambda_6_11_p3 + Lambda_9_11 *
      Lambda_6_11_p4;
  Lambda[81] = Lambda_6_9;
  Lambda[114] = Lambda_6_9;
  const Real Lambda_6_10 = Lambda_0_6_p1 - Lambda_10_11 * Lambda_6_11_p4;
  Lambda[82] = Lambda_6_10;
  Lambda[126] = Lambda_6_10;
  Lambda[91] = Lambda_0_11_p4593 + Lambda_0_7_p3 * Lambda_0_11_p4594_lanes[0] + Lambda_0_7_p2 *
      Lambda_7_11_p1 + Lambda_0_7_p1 * Lambda_7_11_p2 + Lambda_7_11 * Lambda_7_11_p3;
  const Real Lambda_7_8 = Lambda_0_8_p1 * Lambda_7_11_p2 -
      (Lambda_0_7_p3 + Lambda_0_8_p2 * Lambda_7_11_p1) + Lambda_8_11 * Lambda_7_11_p3;
  Lambda[92] = Lambda_7_8;
  Lambda[103] = Lambda_7_8;
  const Real Lambda_7_9 = Lambda_0_7_p2 - Lambda_0_9_p1 * Lambda_7_11_p2 + Lambda_9_11 *
      Lambda_7_11_p3;
  Lambda[93] = Lambda_7_9;
  Lambda[115] = Lambda_7_9;
  const Real Lambda_7_10 = Lambda_0_7_p1 - Lambda_10_11 * Lambda_7_11_p3;
  Lambda[94] = Lambda_7_10;
  Lambda[127] = Lambda_7_10;
  Lambda[104] = Lambda_0_11_p4762 + Lambda_0_8_p2 * Lambda_0_11_p4763_lanes[1] + Lambda_0_8_p1 *
      Lambda_8_11_p1 + Lambda_8_11 * Lambda_8_11_p2;
  const Real Lambda_8_9 = Lambda_9_11 * Lambda_8_11_p2 -
      (Lambda_0_8_p2 + Lambda_0_9_p1 * Lambda_8_11_p1);
  Lambda[105] = Lambda_8_9;
  Lambda[116] = Lambda_8_9;
  const Real Lambda_8_10 = Lambda_0_8_p1 - Lambda_10_11 * Lambda_8_11_p2;
  Lambda[106] = Lambda_8_10;
  Lambda[128] = Lambda_8_10;
  Lambda[117] = Lambda_0_11_p4895 + Lambda_0_9_p1 * Lambda_0_11_p4905 + Lambda_9_11 *
      Lambda_9_11_p1;
  const Real Lambda_9_10 = Lambda_0_9_p1 + Lambda_10_11 * Lambda_9_11_p1;
  Lambda[118] = -Lambda_9_10;
  Lambda[129] = -Lambda_9_10;
  Lambda[130] = Lambda_0_11_p4911 + Lambda_10_11 * Lambda_0_11_p4912;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
