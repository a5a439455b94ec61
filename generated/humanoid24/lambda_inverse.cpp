// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points.
// 6522 flops (add 2753, mul 3737, div 32), sine and cosine of 24 angles
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
void lambda_inverse(const Real (&TREELINE_RESTRICT q)[24],
    Real (&TREELINE_RESTRICT Lambda_inv)[144]) noexcept {
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
  const Real Lambda_inv_0_0_p1 = 0.0002628975791811551 * c13 - 0.0007660844555829042 * s13;
  const Real Lambda_inv_0_0_p2 = c13 * Lambda_inv_0_0_p1 - 0.00013384878959057754;
  const Real inverse_D12_p1 = s13 * Lambda_inv_0_0_p1;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D12 = 1.0 / (0.0010519177038056625 + inverse_D12_p1);
  const Real Lambda_inv_0_0_p3 = Lambda_inv_0_0_p2 * inverse_D12;
  const Real Lambda_inv_0_0_p4 = 0.0002742332482227584 - inverse_D12_p1 - Lambda_inv_0_0_p2 *
      Lambda_inv_0_0_p3;
  const Real Lambda_inv_0_0_p5 = s12 * (1.16e-05 - Lambda_inv_0_0_p4);

  // link 13 (left_hand), articulated inertia
  const Real Lambda_inv_0_0_p6 = 0.001090468517736955 * s13 + 0.001742099791326752 * c13;
  const Real Lambda_inv_0_0_p7 = s13 * Lambda_inv_0_0_p6;
  const Real Lambda_inv_0_0_p8 = Lambda_inv_0_0_p7 - 0.000760024621759417;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p9 = Lambda_inv_0_0_p8 * inverse_D12;

  // link 13 (left_hand), articulated inertia
  const Real Lambda_inv_0_0_p10 = c13 * Lambda_inv_0_0_p6;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p11 = Lambda_inv_0_0_p10 - 0.002376125662528793 - Lambda_inv_0_0_p2 *
      Lambda_inv_0_0_p9;
  const Real Lambda_inv_0_0_p12 = 0.0006000000000000001 * s12 + c12 * Lambda_inv_0_0_p11;
  const Real Lambda_inv_0_0_p13 = 0.000144 - (c12 * Lambda_inv_0_0_p5 + 0.269 * Lambda_inv_0_0_p12);
  const Real inverse_D11_p1 = s12 * Lambda_inv_0_0_p5;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D11 = 1.0 / (0.00022920000000000001 + (Lambda_inv_0_0_p4 + inverse_D11_p1));
  const Real Lambda_inv_0_0_p14 = Lambda_inv_0_0_p13 * inverse_D11;

  // link 13 (left_hand), articulated inertia
  const Real Lambda_inv_0_0_p15 = 0.27310176737964387 * s13 - 0.09929187165525127 * c13;
  const Real Lambda_inv_0_0_p16 = s13 * Lambda_inv_0_0_p15;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p17 = Lambda_inv_0_0_p16 - 0.2818466605750157 - Lambda_inv_0_0_p8 *
      Lambda_inv_0_0_p9;
  const Real Lambda_inv_0_0_p18 = s12 * Lambda_inv_0_0_p11 - 0.0006000000000000001 * c12;
  const Real Lambda_inv_0_0_p19 = 0.269 * Lambda_inv_0_0_p17 - Lambda_inv_0_0_p18;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p20 = 0.000131 - inverse_D11_p1 + 0.269 *
      (Lambda_inv_0_0_p19 - Lambda_inv_0_0_p18) - Lambda_inv_0_0_p13 * Lambda_inv_0_0_p14;

  // link 13 (left_hand), articulated inertia
  const Real Lambda_inv_0_0_p21 = 0.0006340258712020409 + Lambda_inv_0_0_p10;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p22 = Lambda_inv_0_0_p21 * inverse_D12;
  const Real Lambda_inv_0_0_p23 = 0.00033044389597753786 - Lambda_inv_0_0_p7 - Lambda_inv_0_0_p2 *
      Lambda_inv_0_0_p22;

  // link 13 (left_hand), articulated inertia
  const Real Lambda_inv_0_0_p24 = 0.0006000000000000001 +
      (0.002865001425 * s13 + 0.01626499875 * c13);

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p25 = Lambda_inv_0_0_p24 * inverse_D12;
  const Real Lambda_inv_0_0_p26 = 0.01626499875 * s13 - 0.002865001425 * c13 + Lambda_inv_0_0_p2 *
      Lambda_inv_0_0_p25;
  const Real Lambda_inv_0_0_p27 = s12 * Lambda_inv_0_0_p23 - c12 * Lambda_inv_0_0_p26;
  const Real Lambda_inv_0_0_p28 = c12 * Lambda_inv_0_0_p27;
  const Real Lambda_inv_0_0_p29 = 0.0002516 - 0.269 * Lambda_inv_0_0_p28;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p30 = Lambda_inv_0_0_p29 * inverse_D11;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p31 = 0.008744893195371809 + Lambda_inv_0_0_p16 + Lambda_inv_0_0_p21 *
      Lambda_inv_0_0_p22;
  const Real Lambda_inv_0_0_p32 = Lambda_inv_0_0_p24 * Lambda_inv_0_0_p25;
  const Real Lambda_inv_0_0_p33 = Lambda_inv_0_0_p24 * Lambda_inv_0_0_p22;
  const Real Lambda_inv_0_0_p34 = s12 * (Lambda_inv_0_0_p31 - Lambda_inv_0_0_p32) + c12 *
      (2.0 * Lambda_inv_0_0_p33);
  const Real Lambda_inv_0_0_p35 = s12 * Lambda_inv_0_0_p34;
  const Real Lambda_inv_0_0_p36 = Lambda_inv_0_0_p32 + Lambda_inv_0_0_p35;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p37 = 0.0001098 - 0.07236100000000001 * Lambda_inv_0_0_p36 -
      Lambda_inv_0_0_p29 * Lambda_inv_0_0_p30;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p38 = s12 * Lambda_inv_0_0_p27;
  const Real Lambda_inv_0_0_p39 = 0.04964593582762564 + c13 * Lambda_inv_0_0_p15 -
      Lambda_inv_0_0_p21 * Lambda_inv_0_0_p9;
  const Real Lambda_inv_0_0_p40 = Lambda_inv_0_0_p24 * Lambda_inv_0_0_p9;
  const Real Lambda_inv_0_0_p41 = s12 * Lambda_inv_0_0_p39 - c12 * Lambda_inv_0_0_p40;
  const Real Lambda_inv_0_0_p42 = 0.269 * Lambda_inv_0_0_p41;
  const Real Lambda_inv_0_0_p43 = Lambda_inv_0_0_p38 - Lambda_inv_0_0_p42;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p44 = 6e-06 + 0.269 * Lambda_inv_0_0_p43 + Lambda_inv_0_0_p13 *
      Lambda_inv_0_0_p30;
  const Real Lambda_inv_0_0_p45 = 2.0 * c11;
  const Real Lambda_inv_0_0_p46 = s11 * (Lambda_inv_0_0_p20 - Lambda_inv_0_0_p37) -
      Lambda_inv_0_0_p45 * Lambda_inv_0_0_p44;
  const Real Lambda_inv_0_0_p47 = c11 * Lambda_inv_0_0_p46 + Lambda_inv_0_0_p44 -
      2.249994685315e-05;
  const Real inverse_D10_p1 = s11 * Lambda_inv_0_0_p46;
  const Real inverse_D10_p2 = 0.060888541114265754 + (Lambda_inv_0_0_p37 + inverse_D10_p1);

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D10 = 1.0 / inverse_D10_p2;
  const Real Lambda_inv_0_0_p48 = Lambda_inv_0_0_p47 * inverse_D10;
  const Real Lambda_inv_0_0_p49 = 0.06060754126741261 + (Lambda_inv_0_0_p20 - inverse_D10_p1) -
      Lambda_inv_0_0_p47 * Lambda_inv_0_0_p48;
  const Real Lambda_inv_0_0_p50 = 0.00028099984685315 - 2.249996661190239e-08 / inverse_D10_p2;
  const Real Lambda_inv_0_0_p51 = 0.0001499998887063 / inverse_D10_p2;
  const Real Lambda_inv_0_0_p52 = Lambda_inv_0_0_p47 * Lambda_inv_0_0_p51 - 0.0001499998887063;
  const Real Lambda_inv_0_0_p53 = 2.0 * c10;
  const Real Lambda_inv_0_0_p54 = s10 * (Lambda_inv_0_0_p49 - Lambda_inv_0_0_p50) +
      Lambda_inv_0_0_p53 * Lambda_inv_0_0_p52;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p55 = Lambda_inv_0_0_p28 - 0.001;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p56 = Lambda_inv_0_0_p55 * inverse_D11;
  const Real Lambda_inv_0_0_p57 = Lambda_inv_0_0_p43 - Lambda_inv_0_0_p13 * Lambda_inv_0_0_p56;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p58 = 6e-04 - Lambda_inv_0_0_p12;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p59 = Lambda_inv_0_0_p58 * inverse_D11;
  const Real Lambda_inv_0_0_p60 = Lambda_inv_0_0_p42 - Lambda_inv_0_0_p29 * Lambda_inv_0_0_p59;
  const Real Lambda_inv_0_0_p61 = 0.269 * Lambda_inv_0_0_p36 - Lambda_inv_0_0_p29 *
      Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_0_p62 = Lambda_inv_0_0_p19 - Lambda_inv_0_0_p13 * Lambda_inv_0_0_p59;
  const Real Lambda_inv_0_0_p63 = s11 * (Lambda_inv_0_0_p57 - Lambda_inv_0_0_p60) + c11 *
      (Lambda_inv_0_0_p61 + Lambda_inv_0_0_p62);
  const Real Lambda_inv_0_0_p64 = s11 * Lambda_inv_0_0_p63;
  const Real Lambda_inv_0_0_p65 = Lambda_inv_0_0_p60 + Lambda_inv_0_0_p64;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p66 = Lambda_inv_0_0_p65 * inverse_D10;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p67 = c11 * Lambda_inv_0_0_p63;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p68 = 0.28049749700000004 + (Lambda_inv_0_0_p67 - Lambda_inv_0_0_p61) -
      Lambda_inv_0_0_p47 * Lambda_inv_0_0_p66;
  const Real Lambda_inv_0_0_p69 = 0.0001499998887063 * Lambda_inv_0_0_p66 - 0.0014999985000000002;
  const Real Lambda_inv_0_0_p70 = s10 * Lambda_inv_0_0_p68 + c10 * Lambda_inv_0_0_p69;
  const Real Lambda_inv_0_0_p71 = 0.0005895000784280001 +
      (c10 * Lambda_inv_0_0_p54 - Lambda_inv_0_0_p52 + 0.282 * Lambda_inv_0_0_p70);

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p72 = Lambda_inv_0_0_p67 - Lambda_inv_0_0_p62 - 0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p73 = Lambda_inv_0_0_p72 * inverse_D10;
  const Real Lambda_inv_0_0_p74 = 0.0001499998887063 * Lambda_inv_0_0_p73;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p75 = s12 * Lambda_inv_0_0_p40 + c12 * Lambda_inv_0_0_p39;
  const Real Lambda_inv_0_0_p76 = Lambda_inv_0_0_p23 - Lambda_inv_0_0_p38;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p77 = Lambda_inv_0_0_p76 * inverse_D11;
  const Real Lambda_inv_0_0_p78 = 0.001 + (Lambda_inv_0_0_p28 + Lambda_inv_0_0_p26 - 0.269 *
      Lambda_inv_0_0_p75) - Lambda_inv_0_0_p13 * Lambda_inv_0_0_p77;

  // link 12 (left_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p79 = c12 * Lambda_inv_0_0_p34 - Lambda_inv_0_0_p33;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p80 = 0.269 * Lambda_inv_0_0_p79 - 6e-04 - Lambda_inv_0_0_p29 *
      Lambda_inv_0_0_p77;
  const Real Lambda_inv_0_0_p81 = 0.0014999985000000002 -
      (s11 * Lambda_inv_0_0_p78 + c11 * Lambda_inv_0_0_p80);

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p82 = Lambda_inv_0_0_p81 * inverse_D10;
  const Real Lambda_inv_0_0_p83 = c11 * Lambda_inv_0_0_p78 - s11 * Lambda_inv_0_0_p80 +
      Lambda_inv_0_0_p47 * Lambda_inv_0_0_p82;
  const Real Lambda_inv_0_0_p84 = Lambda_inv_0_0_p57 - Lambda_inv_0_0_p64 - Lambda_inv_0_0_p47 *
      Lambda_inv_0_0_p73;
  const Real Lambda_inv_0_0_p85 = 0.0001499998887063 * Lambda_inv_0_0_p82;
  const Real Lambda_inv_0_0_p86 = s10 * (Lambda_inv_0_0_p84 - Lambda_inv_0_0_p85) + c10 *
      (Lambda_inv_0_0_p74 - Lambda_inv_0_0_p83);
  const Real Lambda_inv_0_0_p87 = c10 * Lambda_inv_0_0_p86;
  const Real Lambda_inv_0_0_p88 = Lambda_inv_0_0_p87 + Lambda_inv_0_0_p83;
  const Real Lambda_inv_0_0_p89 = 0.004500002325 + Lambda_inv_0_0_p88;
  const Real inverse_D9_p1 = s10 * Lambda_inv_0_0_p54;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D9 = 1.0 / (0.0027762933559338653 + (Lambda_inv_0_0_p50 + inverse_D9_p1));
  const Real Lambda_inv_0_0_p90 = Lambda_inv_0_0_p89 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p91 = s10 * Lambda_inv_0_0_p86;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p92 = Lambda_inv_0_0_p79 + Lambda_inv_0_0_p55 * Lambda_inv_0_0_p77;
  const Real Lambda_inv_0_0_p93 = Lambda_inv_0_0_p75 + Lambda_inv_0_0_p58 * Lambda_inv_0_0_p77;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p94 = s11 * Lambda_inv_0_0_p92 + c11 * Lambda_inv_0_0_p93 -
      Lambda_inv_0_0_p81 * Lambda_inv_0_0_p66;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p95 = Lambda_inv_0_0_p36 + Lambda_inv_0_0_p55 * Lambda_inv_0_0_p56;
  const Real Lambda_inv_0_0_p96 = Lambda_inv_0_0_p17 - Lambda_inv_0_0_p58 * Lambda_inv_0_0_p59;
  const Real Lambda_inv_0_0_p97 = Lambda_inv_0_0_p41 + Lambda_inv_0_0_p55 * Lambda_inv_0_0_p59;
  const Real Lambda_inv_0_0_p98 = s11 * (Lambda_inv_0_0_p95 + Lambda_inv_0_0_p96) +
      Lambda_inv_0_0_p45 * Lambda_inv_0_0_p97;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p99 = Lambda_inv_0_0_p97 - c11 * Lambda_inv_0_0_p98 -
      Lambda_inv_0_0_p72 * Lambda_inv_0_0_p66;
  const Real Lambda_inv_0_0_p100 = s10 * Lambda_inv_0_0_p94 - c10 * Lambda_inv_0_0_p99;
  const Real Lambda_inv_0_0_p101 = 0.282 * Lambda_inv_0_0_p100;
  const Real Lambda_inv_0_0_p102 = Lambda_inv_0_0_p84 - Lambda_inv_0_0_p91 - Lambda_inv_0_0_p101;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p103 = Lambda_inv_0_0_p102 - Lambda_inv_0_0_p71 * Lambda_inv_0_0_p90;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p104 = 0.0022500062 + Lambda_inv_0_0_p70;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p105 = Lambda_inv_0_0_p104 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p106 = 0.0012089992423205001 + 0.282 * Lambda_inv_0_0_p88;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p107 = Lambda_inv_0_0_p101 + Lambda_inv_0_0_p106 * Lambda_inv_0_0_p105;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p108 = s10 * Lambda_inv_0_0_p69 - c10 * Lambda_inv_0_0_p68;

  // link 11 (left_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p109 = s11 * Lambda_inv_0_0_p98;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p110 = Lambda_inv_0_0_p96 - Lambda_inv_0_0_p109 - Lambda_inv_0_0_p65 *
      Lambda_inv_0_0_p66;
  const Real Lambda_inv_0_0_p111 = 0.282 * Lambda_inv_0_0_p110 - Lambda_inv_0_0_p108;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p112 = Lambda_inv_0_0_p111 - Lambda_inv_0_0_p71 * Lambda_inv_0_0_p105;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p113 = s11 * Lambda_inv_0_0_p93 - c11 * Lambda_inv_0_0_p92 +
      Lambda_inv_0_0_p72 * Lambda_inv_0_0_p82;
  const Real Lambda_inv_0_0_p114 = Lambda_inv_0_0_p109 - Lambda_inv_0_0_p95 - Lambda_inv_0_0_p72 *
      Lambda_inv_0_0_p73;
  const Real Lambda_inv_0_0_p115 = Lambda_inv_0_0_p35 - Lambda_inv_0_0_p31 - Lambda_inv_0_0_p76 *
      Lambda_inv_0_0_p77 - Lambda_inv_0_0_p81 * Lambda_inv_0_0_p82;
  const Real Lambda_inv_0_0_p116 = Lambda_inv_0_0_p53 * Lambda_inv_0_0_p113 - s10 *
      (Lambda_inv_0_0_p114 - Lambda_inv_0_0_p115);
  const Real Lambda_inv_0_0_p117 = s10 * Lambda_inv_0_0_p116;
  const Real Lambda_inv_0_0_p118 = Lambda_inv_0_0_p114 + Lambda_inv_0_0_p117;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p119 = Lambda_inv_0_0_p106 * Lambda_inv_0_0_p90 - 0.282 *
      Lambda_inv_0_0_p118;
  const Real Lambda_inv_0_0_p120 = c9 * (Lambda_inv_0_0_p103 - Lambda_inv_0_0_p107) - s9 *
      (Lambda_inv_0_0_p119 + Lambda_inv_0_0_p112);
  const Real Lambda_inv_0_0_p121 = c9 * Lambda_inv_0_0_p120;
  const Real Lambda_inv_0_0_p122 = Lambda_inv_0_0_p107 + Lambda_inv_0_0_p121;
  const Real inverse_D8_p1 = Lambda_inv_0_0_p71 * inverse_D9;
  const Real inverse_D8_p2 = 0.0019585440854647937 +
      (Lambda_inv_0_0_p49 - inverse_D9_p1 + 0.282 * (Lambda_inv_0_0_p111 - Lambda_inv_0_0_p108)) -
      Lambda_inv_0_0_p71 * inverse_D8_p1;
  const Real inverse_D8_p3 = Lambda_inv_0_0_p106 * inverse_D9;
  const Real inverse_D8_p4 = 0.0008177492704690715 + 0.07952399999999998 * Lambda_inv_0_0_p118 -
      Lambda_inv_0_0_p106 * inverse_D8_p3;
  const Real inverse_D8_p5 = 4.4999986458742003e-05 - 0.282 * Lambda_inv_0_0_p102 +
      Lambda_inv_0_0_p71 * inverse_D8_p3;
  const Real inverse_D8_p6 = 2.0 * s9;
  const Real inverse_D8_p7 = c9 * (inverse_D8_p2 - inverse_D8_p4) - inverse_D8_p6 * inverse_D8_p5;
  const Real inverse_D8_p8 = c9 * inverse_D8_p7;
  const Real inverse_D8_p9 = 0.18125194219699997 + (inverse_D8_p4 + inverse_D8_p8);

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D8 = 1.0 / inverse_D8_p9;
  const Real Lambda_inv_0_0_p123 = Lambda_inv_0_0_p122 * inverse_D8;
  const Real Lambda_inv_0_0_p124 = 0.0017499999999999998 + 0.00010499999999999999 *
      Lambda_inv_0_0_p123;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p125 = s9 * inverse_D8_p7 + inverse_D8_p5 - 1.75e-05;
  const Real Lambda_inv_0_0_p126 = s9 * Lambda_inv_0_0_p120;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p127 = Lambda_inv_0_0_p126 + Lambda_inv_0_0_p119 - 0.7139200499999999 -
      Lambda_inv_0_0_p125 * Lambda_inv_0_0_p123;
  const Real Lambda_inv_0_0_p128 = 0.0017499999999999998 +
      (s8 * Lambda_inv_0_0_p124 + c8 * Lambda_inv_0_0_p127);
  const Real inverse_D7_p1 = Lambda_inv_0_0_p125 * inverse_D8;
  const Real inverse_D7_p2 = 0.18113119219699997 + (inverse_D8_p2 - inverse_D8_p8) -
      Lambda_inv_0_0_p125 * inverse_D7_p1;
  const Real inverse_D7_p3 = 0.00012075 - 1.1024999999999998e-08 / inverse_D8_p9;
  const Real inverse_D7_p4 = 0.00010499999999999999 * inverse_D7_p1 - 5.2499999999999995e-05;
  const Real inverse_D7_p5 = 2.0 * c8;
  const Real inverse_D7_p6 = s8 * (inverse_D7_p3 - inverse_D7_p2) + inverse_D7_p5 * inverse_D7_p4;
  const Real inverse_D7_p7 = s8 * inverse_D7_p6;
  const Real inverse_D7_p8 = 0.000448 + (inverse_D7_p2 + inverse_D7_p7);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D7 = 1.0 / inverse_D7_p8;
  const Real Lambda_inv_0_0_p129 = Lambda_inv_0_0_p128 * inverse_D7;
  const Real Lambda_inv_0_0_p130 = 2.6249999999999998e-05 * Lambda_inv_0_0_p129;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p131 = Lambda_inv_0_0_p85 + Lambda_inv_0_0_p91;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p132 = Lambda_inv_0_0_p131 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p133 = s10 * Lambda_inv_0_0_p99 + c10 * Lambda_inv_0_0_p94;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p134 = 0.004500002325 -
      (Lambda_inv_0_0_p87 - Lambda_inv_0_0_p74 + 0.282 * Lambda_inv_0_0_p133) + Lambda_inv_0_0_p71 *
      Lambda_inv_0_0_p132;

  // link 10 (left_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p135 = Lambda_inv_0_0_p113 - c10 * Lambda_inv_0_0_p116;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p136 = 0.0022500062 + 0.282 * Lambda_inv_0_0_p135 -
      Lambda_inv_0_0_p106 * Lambda_inv_0_0_p132;
  const Real Lambda_inv_0_0_p137 = 0.0017499999999999998 +
      (c9 * Lambda_inv_0_0_p134 - s9 * Lambda_inv_0_0_p136);

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p138 = Lambda_inv_0_0_p137 * inverse_D8;
  const Real Lambda_inv_0_0_p139 = Lambda_inv_0_0_p125 * Lambda_inv_0_0_p138 -
      (s9 * Lambda_inv_0_0_p134 + c9 * Lambda_inv_0_0_p136);

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p140 = 0.7139200499999999 + (Lambda_inv_0_0_p126 + Lambda_inv_0_0_p112);

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p141 = Lambda_inv_0_0_p140 * inverse_D8;
  const Real Lambda_inv_0_0_p142 = 0.00010499999999999999 * Lambda_inv_0_0_p141;
  const Real Lambda_inv_0_0_p143 = Lambda_inv_0_0_p103 - Lambda_inv_0_0_p121 - Lambda_inv_0_0_p125 *
      Lambda_inv_0_0_p141;
  const Real Lambda_inv_0_0_p144 = 0.00010499999999999999 * Lambda_inv_0_0_p138;
  const Real Lambda_inv_0_0_p145 = c8 * (Lambda_inv_0_0_p139 + Lambda_inv_0_0_p142) - s8 *
      (Lambda_inv_0_0_p144 + Lambda_inv_0_0_p143);
  const Real Lambda_inv_0_0_p146 = c8 * Lambda_inv_0_0_p145;
  const Real Lambda_inv_0_0_p147 = 0.0017499999999999998 +
      (Lambda_inv_0_0_p146 - Lambda_inv_0_0_p142);

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p148 = Lambda_inv_0_0_p147 * inverse_D7;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p149 = c8 * inverse_D7_p6 - inverse_D7_p4 - 2.6249999999999998e-05;
  const Real Lambda_inv_0_0_p150 = s8 * Lambda_inv_0_0_p145;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p151 = Lambda_inv_0_0_p144 + Lambda_inv_0_0_p150 + Lambda_inv_0_0_p149 *
      Lambda_inv_0_0_p148;
  const Real Lambda_inv_0_0_p152 = c8 * Lambda_inv_0_0_p124 - s8 * Lambda_inv_0_0_p127 -
      Lambda_inv_0_0_p149 * Lambda_inv_0_0_p129;
  const Real Lambda_inv_0_0_p153 = 2.6249999999999998e-05 * Lambda_inv_0_0_p148;
  const Real Lambda_inv_0_0_p154 = c7 * (Lambda_inv_0_0_p130 + Lambda_inv_0_0_p151) - s7 *
      (Lambda_inv_0_0_p152 + Lambda_inv_0_0_p153);
  const Real Lambda_inv_0_0_p155 = s7 * Lambda_inv_0_0_p154;
  const Real Lambda_inv_0_0_p156 = Lambda_inv_0_0_p155 + Lambda_inv_0_0_p153;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p157 = Lambda_inv_0_0_p118 - Lambda_inv_0_0_p89 * Lambda_inv_0_0_p90;
  const Real Lambda_inv_0_0_p158 = Lambda_inv_0_0_p110 - Lambda_inv_0_0_p104 * Lambda_inv_0_0_p105;
  const Real Lambda_inv_0_0_p159 = Lambda_inv_0_0_p100 + Lambda_inv_0_0_p89 * Lambda_inv_0_0_p105;
  const Real Lambda_inv_0_0_p160 = c9 * (Lambda_inv_0_0_p157 - Lambda_inv_0_0_p158) +
      inverse_D8_p6 * Lambda_inv_0_0_p159;
  const Real Lambda_inv_0_0_p161 = c9 * Lambda_inv_0_0_p160;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p162 = Lambda_inv_0_0_p158 + Lambda_inv_0_0_p161 - Lambda_inv_0_0_p122 *
      Lambda_inv_0_0_p123 - Lambda_inv_0_0_p128 * Lambda_inv_0_0_p129;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p163 = Lambda_inv_0_0_p157 - Lambda_inv_0_0_p161 - Lambda_inv_0_0_p140 *
      Lambda_inv_0_0_p141;
  const Real Lambda_inv_0_0_p164 = Lambda_inv_0_0_p115 - Lambda_inv_0_0_p117 - Lambda_inv_0_0_p131 *
      Lambda_inv_0_0_p132 - Lambda_inv_0_0_p137 * Lambda_inv_0_0_p138;

  // link 9 (left_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p165 = Lambda_inv_0_0_p89 * Lambda_inv_0_0_p132 - Lambda_inv_0_0_p135;
  const Real Lambda_inv_0_0_p166 = Lambda_inv_0_0_p104 * Lambda_inv_0_0_p132 - Lambda_inv_0_0_p133;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p167 = Lambda_inv_0_0_p137 * Lambda_inv_0_0_p141 -
      (s9 * Lambda_inv_0_0_p165 + c9 * Lambda_inv_0_0_p166);
  const Real Lambda_inv_0_0_p168 = s8 * (Lambda_inv_0_0_p164 - Lambda_inv_0_0_p163) +
      inverse_D7_p5 * Lambda_inv_0_0_p167;
  const Real Lambda_inv_0_0_p169 = s8 * Lambda_inv_0_0_p168;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p170 = Lambda_inv_0_0_p164 - Lambda_inv_0_0_p169 - Lambda_inv_0_0_p147 *
      Lambda_inv_0_0_p148;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p171 = Lambda_inv_0_0_p137 * Lambda_inv_0_0_p123 -
      (c9 * Lambda_inv_0_0_p165 - s9 * Lambda_inv_0_0_p166);
  const Real Lambda_inv_0_0_p172 = Lambda_inv_0_0_p159 - s9 * Lambda_inv_0_0_p160 +
      Lambda_inv_0_0_p140 * Lambda_inv_0_0_p123;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p173 = c8 * Lambda_inv_0_0_p171 + s8 * Lambda_inv_0_0_p172 -
      Lambda_inv_0_0_p128 * Lambda_inv_0_0_p148;
  const Real Lambda_inv_0_0_p174 = 2.0 * s7;
  const Real Lambda_inv_0_0_p175 = c7 * (Lambda_inv_0_0_p162 - Lambda_inv_0_0_p170) -
      Lambda_inv_0_0_p174 * Lambda_inv_0_0_p173;
  const Real Lambda_inv_0_0_p176 = c7 * Lambda_inv_0_0_p175;
  const Real Lambda_inv_0_0_p177 = Lambda_inv_0_0_p162 - Lambda_inv_0_0_p176;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p178 = Lambda_inv_0_0_p143 + Lambda_inv_0_0_p150;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p179 = Lambda_inv_0_0_p178 * inverse_D7;
  const Real Lambda_inv_0_0_p180 = s8 * Lambda_inv_0_0_p171 - c8 * Lambda_inv_0_0_p172 -
      Lambda_inv_0_0_p128 * Lambda_inv_0_0_p179;
  const Real Lambda_inv_0_0_p181 = c8 * Lambda_inv_0_0_p168 - Lambda_inv_0_0_p167 -
      Lambda_inv_0_0_p147 * Lambda_inv_0_0_p179;
  const Real Lambda_inv_0_0_p182 = s7 * Lambda_inv_0_0_p180 + c7 * Lambda_inv_0_0_p181;
  const Real Lambda_inv_0_0_p183 = Lambda_inv_0_0_p156 -
      (0.18 * Lambda_inv_0_0_p177 + 0.226 * Lambda_inv_0_0_p182);

  // link 20 (right_hand), articulated inertia
  const Real Lambda_inv_0_0_p184 = 0.0007660844555829042 * s20 + 0.0002628975791811551 * c20;
  const Real Lambda_inv_0_0_p185 = 0.00013384878959057754 - c20 * Lambda_inv_0_0_p184;
  const Real inverse_D19_p1 = s20 * Lambda_inv_0_0_p184;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D19 = 1.0 / (0.0010519177038056625 - inverse_D19_p1);
  const Real Lambda_inv_0_0_p186 = Lambda_inv_0_0_p185 * inverse_D19;
  const Real Lambda_inv_0_0_p187 = 0.0002742332482227584 + inverse_D19_p1 - Lambda_inv_0_0_p185 *
      Lambda_inv_0_0_p186;
  const Real Lambda_inv_0_0_p188 = s19 * (1.16e-05 - Lambda_inv_0_0_p187);

  // link 20 (right_hand), articulated inertia
  const Real Lambda_inv_0_0_p189 = 0.001742099791326752 * c20 - 0.001090468517736955 * s20;
  const Real Lambda_inv_0_0_p190 = s20 * Lambda_inv_0_0_p189;
  const Real Lambda_inv_0_0_p191 = 0.000760024621759417 + Lambda_inv_0_0_p190;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p192 = Lambda_inv_0_0_p191 * inverse_D19;

  // link 20 (right_hand), articulated inertia
  const Real Lambda_inv_0_0_p193 = c20 * Lambda_inv_0_0_p189;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p194 = Lambda_inv_0_0_p193 - 0.002376125662528793 -
      Lambda_inv_0_0_p185 * Lambda_inv_0_0_p192;
  const Real Lambda_inv_0_0_p195 = 0.0006000000000000001 * s19 + c19 * Lambda_inv_0_0_p194;
  const Real Lambda_inv_0_0_p196 = 0.000144 - (c19 * Lambda_inv_0_0_p188 + 0.269 *
      Lambda_inv_0_0_p195);
  const Real inverse_D18_p1 = s19 * Lambda_inv_0_0_p188;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D18 = 1.0 / (0.00022920000000000001 + (Lambda_inv_0_0_p187 + inverse_D18_p1));

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p197 = 6e-04 - Lambda_inv_0_0_p195;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p198 = Lambda_inv_0_0_p197 * inverse_D18;

  // link 20 (right_hand), articulated inertia
  const Real Lambda_inv_0_0_p199 = 0.27310176737964387 * s20 + 0.09929187165525127 * c20;
  const Real Lambda_inv_0_0_p200 = s20 * Lambda_inv_0_0_p199;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p201 = Lambda_inv_0_0_p200 - 0.2818466605750157 - Lambda_inv_0_0_p191 *
      Lambda_inv_0_0_p192;
  const Real Lambda_inv_0_0_p202 = s19 * Lambda_inv_0_0_p194 - 0.0006000000000000001 * c19;
  const Real Lambda_inv_0_0_p203 = 0.269 * Lambda_inv_0_0_p201 - Lambda_inv_0_0_p202;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p204 = Lambda_inv_0_0_p203 - Lambda_inv_0_0_p196 * Lambda_inv_0_0_p198;

  // link 20 (right_hand), articulated inertia
  const Real Lambda_inv_0_0_p205 = 0.0006340258712020409 + Lambda_inv_0_0_p193;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p206 = Lambda_inv_0_0_p205 * inverse_D19;
  const Real Lambda_inv_0_0_p207 = 0.00033044389597753786 + Lambda_inv_0_0_p190 +
      Lambda_inv_0_0_p185 * Lambda_inv_0_0_p206;

  // link 20 (right_hand), articulated inertia
  const Real Lambda_inv_0_0_p208 = 0.002865001425 * s20 - 0.01626499875 * c20 -
      0.0006000000000000001;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p209 = Lambda_inv_0_0_p208 * inverse_D19;
  const Real Lambda_inv_0_0_p210 = 0.002865001425 * c20 + 0.01626499875 * s20 -
      Lambda_inv_0_0_p185 * Lambda_inv_0_0_p209;
  const Real Lambda_inv_0_0_p211 = s19 * Lambda_inv_0_0_p207 + c19 * Lambda_inv_0_0_p210;
  const Real Lambda_inv_0_0_p212 = c19 * Lambda_inv_0_0_p211;
  const Real Lambda_inv_0_0_p213 = 0.001 - Lambda_inv_0_0_p212;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p214 = Lambda_inv_0_0_p213 * inverse_D18;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p215 = 0.269 * Lambda_inv_0_0_p212 - 0.0002516;
  const Real Lambda_inv_0_0_p216 = 0.008744893195371809 + Lambda_inv_0_0_p200 +
      Lambda_inv_0_0_p205 * Lambda_inv_0_0_p206;
  const Real Lambda_inv_0_0_p217 = Lambda_inv_0_0_p208 * Lambda_inv_0_0_p209;
  const Real Lambda_inv_0_0_p218 = Lambda_inv_0_0_p208 * Lambda_inv_0_0_p206;
  const Real Lambda_inv_0_0_p219 = c19 * (2.0 * Lambda_inv_0_0_p218) - s19 *
      (Lambda_inv_0_0_p216 - Lambda_inv_0_0_p217);
  const Real Lambda_inv_0_0_p220 = s19 * Lambda_inv_0_0_p219;
  const Real Lambda_inv_0_0_p221 = Lambda_inv_0_0_p220 - Lambda_inv_0_0_p217;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p222 = 0.269 * Lambda_inv_0_0_p221 + Lambda_inv_0_0_p215 *
      Lambda_inv_0_0_p214;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p223 = s19 * Lambda_inv_0_0_p211;
  const Real Lambda_inv_0_0_p224 = Lambda_inv_0_0_p208 * Lambda_inv_0_0_p192;
  const Real Lambda_inv_0_0_p225 = c20 * Lambda_inv_0_0_p199 - 0.04964593582762564 -
      Lambda_inv_0_0_p205 * Lambda_inv_0_0_p192;
  const Real Lambda_inv_0_0_p226 = c19 * Lambda_inv_0_0_p224 + s19 * Lambda_inv_0_0_p225;
  const Real Lambda_inv_0_0_p227 = 0.269 * Lambda_inv_0_0_p226;
  const Real Lambda_inv_0_0_p228 = Lambda_inv_0_0_p223 + Lambda_inv_0_0_p227;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p229 = Lambda_inv_0_0_p228 + Lambda_inv_0_0_p196 * Lambda_inv_0_0_p214;
  const Real Lambda_inv_0_0_p230 = Lambda_inv_0_0_p227 - Lambda_inv_0_0_p215 * Lambda_inv_0_0_p198;
  const Real Lambda_inv_0_0_p231 = c18 * (Lambda_inv_0_0_p204 - Lambda_inv_0_0_p222) - s18 *
      (Lambda_inv_0_0_p229 + Lambda_inv_0_0_p230);
  const Real Lambda_inv_0_0_p232 = s18 * Lambda_inv_0_0_p231;
  const Real Lambda_inv_0_0_p233 = Lambda_inv_0_0_p230 + Lambda_inv_0_0_p232;
  const Real inverse_D17_p1 = Lambda_inv_0_0_p196 * inverse_D18;
  const Real inverse_D17_p2 = 0.000131 - inverse_D18_p1 + 0.269 *
      (Lambda_inv_0_0_p203 - Lambda_inv_0_0_p202) - Lambda_inv_0_0_p196 * inverse_D17_p1;
  const Real inverse_D17_p3 = Lambda_inv_0_0_p215 * inverse_D18;
  const Real inverse_D17_p4 = 0.0001098 + 0.07236100000000001 * Lambda_inv_0_0_p221 -
      Lambda_inv_0_0_p215 * inverse_D17_p3;
  const Real inverse_D17_p5 = 6e-06 + 0.269 * Lambda_inv_0_0_p228 - Lambda_inv_0_0_p196 *
      inverse_D17_p3;
  const Real inverse_D17_p6 = 2.0 * c18;
  const Real inverse_D17_p7 = s18 * (inverse_D17_p2 - inverse_D17_p4) + inverse_D17_p6 *
      inverse_D17_p5;
  const Real inverse_D17_p8 = s18 * inverse_D17_p7;
  const Real inverse_D17_p9 = 0.060888541114265754 + (inverse_D17_p4 + inverse_D17_p8);

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D17 = 1.0 / inverse_D17_p9;
  const Real Lambda_inv_0_0_p234 = Lambda_inv_0_0_p233 * inverse_D17;
  const Real Lambda_inv_0_0_p235 = 0.0014999985000000002 + 0.0001499998887063 * Lambda_inv_0_0_p234;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p236 = 2.249994685315e-05 + (c18 * inverse_D17_p7 - inverse_D17_p5);
  const Real Lambda_inv_0_0_p237 = c18 * Lambda_inv_0_0_p231;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p238 = 0.28049749700000004 +
      (Lambda_inv_0_0_p237 + Lambda_inv_0_0_p222) - Lambda_inv_0_0_p236 * Lambda_inv_0_0_p234;
  const Real Lambda_inv_0_0_p239 = c17 * Lambda_inv_0_0_p235 - s17 * Lambda_inv_0_0_p238;
  const Real Lambda_inv_0_0_p240 = 0.0001499998887063 / inverse_D17_p9;
  const Real Lambda_inv_0_0_p241 = 0.0001499998887063 + Lambda_inv_0_0_p236 * Lambda_inv_0_0_p240;
  const Real Lambda_inv_0_0_p242 = 2.0 * c17;
  const Real Lambda_inv_0_0_p243 = Lambda_inv_0_0_p236 * inverse_D17;
  const Real Lambda_inv_0_0_p244 = 0.06060754126741261 + (inverse_D17_p2 - inverse_D17_p8) -
      Lambda_inv_0_0_p236 * Lambda_inv_0_0_p243;
  const Real Lambda_inv_0_0_p245 = 0.00028099984685315 - 2.249996661190239e-08 / inverse_D17_p9;
  const Real Lambda_inv_0_0_p246 = Lambda_inv_0_0_p242 * Lambda_inv_0_0_p241 - s17 *
      (Lambda_inv_0_0_p244 - Lambda_inv_0_0_p245);
  const Real Lambda_inv_0_0_p247 = 0.282 * Lambda_inv_0_0_p239 -
      (Lambda_inv_0_0_p241 - c17 * Lambda_inv_0_0_p246) - 0.0005895000784280001;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p248 = Lambda_inv_0_0_p237 - Lambda_inv_0_0_p204 - 0.28049749700000004;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p249 = Lambda_inv_0_0_p248 * inverse_D17;
  const Real Lambda_inv_0_0_p250 = 0.0001499998887063 * Lambda_inv_0_0_p249;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p251 = s19 * Lambda_inv_0_0_p224 - c19 * Lambda_inv_0_0_p225;
  const Real Lambda_inv_0_0_p252 = Lambda_inv_0_0_p223 - Lambda_inv_0_0_p207;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p253 = Lambda_inv_0_0_p252 * inverse_D18;
  const Real Lambda_inv_0_0_p254 = 0.269 * Lambda_inv_0_0_p251 -
      (Lambda_inv_0_0_p212 - Lambda_inv_0_0_p210) - 0.001 - Lambda_inv_0_0_p196 *
      Lambda_inv_0_0_p253;

  // link 19 (right_wrist2), articulated inertia
  const Real Lambda_inv_0_0_p255 = Lambda_inv_0_0_p218 - c19 * Lambda_inv_0_0_p219;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p256 = 0.269 * Lambda_inv_0_0_p255 - 6e-04 - Lambda_inv_0_0_p215 *
      Lambda_inv_0_0_p253;
  const Real Lambda_inv_0_0_p257 = 0.0014999985000000002 -
      (s18 * Lambda_inv_0_0_p254 + c18 * Lambda_inv_0_0_p256);

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p258 = Lambda_inv_0_0_p257 * inverse_D17;
  const Real Lambda_inv_0_0_p259 = c18 * Lambda_inv_0_0_p254 - s18 * Lambda_inv_0_0_p256 +
      Lambda_inv_0_0_p236 * Lambda_inv_0_0_p258;
  const Real Lambda_inv_0_0_p260 = Lambda_inv_0_0_p229 + Lambda_inv_0_0_p232 + Lambda_inv_0_0_p236 *
      Lambda_inv_0_0_p249;
  const Real Lambda_inv_0_0_p261 = 0.0001499998887063 * Lambda_inv_0_0_p258;
  const Real Lambda_inv_0_0_p262 = c17 * (Lambda_inv_0_0_p250 + Lambda_inv_0_0_p259) - s17 *
      (Lambda_inv_0_0_p261 - Lambda_inv_0_0_p260);
  const Real Lambda_inv_0_0_p263 = c17 * Lambda_inv_0_0_p262;
  const Real Lambda_inv_0_0_p264 = Lambda_inv_0_0_p259 - Lambda_inv_0_0_p263;
  const Real Lambda_inv_0_0_p265 = 0.004500002325 - Lambda_inv_0_0_p264;
  const Real inverse_D16_p1 = s17 * Lambda_inv_0_0_p246;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D16 = 1.0 / (0.0027762933559338653 + (Lambda_inv_0_0_p245 - inverse_D16_p1));
  const Real Lambda_inv_0_0_p266 = Lambda_inv_0_0_p265 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p267 = s17 * Lambda_inv_0_0_p262;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p268 = Lambda_inv_0_0_p221 - Lambda_inv_0_0_p213 * Lambda_inv_0_0_p214;
  const Real Lambda_inv_0_0_p269 = Lambda_inv_0_0_p201 - Lambda_inv_0_0_p197 * Lambda_inv_0_0_p198;
  const Real Lambda_inv_0_0_p270 = Lambda_inv_0_0_p226 + Lambda_inv_0_0_p213 * Lambda_inv_0_0_p198;
  const Real Lambda_inv_0_0_p271 = s18 * (Lambda_inv_0_0_p268 - Lambda_inv_0_0_p269) -
      inverse_D17_p6 * Lambda_inv_0_0_p270;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p272 = c18 * Lambda_inv_0_0_p271 + Lambda_inv_0_0_p270 -
      Lambda_inv_0_0_p248 * Lambda_inv_0_0_p234;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p273 = Lambda_inv_0_0_p251 - Lambda_inv_0_0_p197 * Lambda_inv_0_0_p253;
  const Real Lambda_inv_0_0_p274 = Lambda_inv_0_0_p255 + Lambda_inv_0_0_p213 * Lambda_inv_0_0_p253;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p275 = c18 * Lambda_inv_0_0_p273 - s18 * Lambda_inv_0_0_p274 +
      Lambda_inv_0_0_p257 * Lambda_inv_0_0_p234;
  const Real Lambda_inv_0_0_p276 = c17 * Lambda_inv_0_0_p272 + s17 * Lambda_inv_0_0_p275;
  const Real Lambda_inv_0_0_p277 = 0.282 * Lambda_inv_0_0_p276;
  const Real Lambda_inv_0_0_p278 = Lambda_inv_0_0_p267 - Lambda_inv_0_0_p260 + Lambda_inv_0_0_p277;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p279 = Lambda_inv_0_0_p278 - Lambda_inv_0_0_p247 * Lambda_inv_0_0_p266;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p280 = Lambda_inv_0_0_p239 - 0.0022500062;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p281 = Lambda_inv_0_0_p280 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p282 = 0.282 * Lambda_inv_0_0_p264 - 0.0012089992423205001;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p283 = Lambda_inv_0_0_p277 + Lambda_inv_0_0_p282 * Lambda_inv_0_0_p281;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p284 = c17 * Lambda_inv_0_0_p238 + s17 * Lambda_inv_0_0_p235;

  // link 18 (right_wrist1), articulated inertia
  const Real Lambda_inv_0_0_p285 = s18 * Lambda_inv_0_0_p271;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p286 = Lambda_inv_0_0_p269 + Lambda_inv_0_0_p285 - Lambda_inv_0_0_p233 *
      Lambda_inv_0_0_p234;
  const Real Lambda_inv_0_0_p287 = Lambda_inv_0_0_p284 + 0.282 * Lambda_inv_0_0_p286;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p288 = Lambda_inv_0_0_p287 - Lambda_inv_0_0_p247 * Lambda_inv_0_0_p281;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p289 = Lambda_inv_0_0_p268 - Lambda_inv_0_0_p285 - Lambda_inv_0_0_p248 *
      Lambda_inv_0_0_p249;
  const Real Lambda_inv_0_0_p290 = Lambda_inv_0_0_p216 + Lambda_inv_0_0_p220 + Lambda_inv_0_0_p252 *
      Lambda_inv_0_0_p253 + Lambda_inv_0_0_p257 * Lambda_inv_0_0_p258;
  const Real Lambda_inv_0_0_p291 = c18 * Lambda_inv_0_0_p274 + s18 * Lambda_inv_0_0_p273 -
      Lambda_inv_0_0_p248 * Lambda_inv_0_0_p258;
  const Real Lambda_inv_0_0_p292 = s17 * (Lambda_inv_0_0_p289 + Lambda_inv_0_0_p290) +
      Lambda_inv_0_0_p242 * Lambda_inv_0_0_p291;
  const Real Lambda_inv_0_0_p293 = s17 * Lambda_inv_0_0_p292;
  const Real Lambda_inv_0_0_p294 = Lambda_inv_0_0_p289 - Lambda_inv_0_0_p293;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p295 = 0.282 * Lambda_inv_0_0_p294 + Lambda_inv_0_0_p282 *
      Lambda_inv_0_0_p266;
  const Real Lambda_inv_0_0_p296 = c16 * (Lambda_inv_0_0_p279 + Lambda_inv_0_0_p283) - s16 *
      (Lambda_inv_0_0_p288 - Lambda_inv_0_0_p295);
  const Real Lambda_inv_0_0_p297 = c16 * Lambda_inv_0_0_p296;
  const Real Lambda_inv_0_0_p298 = Lambda_inv_0_0_p297 - Lambda_inv_0_0_p283;
  const Real inverse_D15_p1 = Lambda_inv_0_0_p247 * inverse_D16;
  const Real inverse_D15_p2 = 0.0019585440854647937 +
      (Lambda_inv_0_0_p244 + inverse_D16_p1 + 0.282 * (Lambda_inv_0_0_p284 + Lambda_inv_0_0_p287)) -
      Lambda_inv_0_0_p247 * inverse_D15_p1;
  const Real inverse_D15_p3 = Lambda_inv_0_0_p282 * inverse_D16;
  const Real inverse_D15_p4 = 0.0008177492704690715 + 0.07952399999999998 * Lambda_inv_0_0_p294 -
      Lambda_inv_0_0_p282 * inverse_D15_p3;
  const Real inverse_D15_p5 = 4.4999986458742003e-05 + 0.282 * Lambda_inv_0_0_p278 +
      Lambda_inv_0_0_p247 * inverse_D15_p3;
  const Real inverse_D15_p6 = 2.0 * s16;
  const Real inverse_D15_p7 = c16 * (inverse_D15_p2 - inverse_D15_p4) + inverse_D15_p6 *
      inverse_D15_p5;
  const Real inverse_D15_p8 = c16 * inverse_D15_p7;
  const Real inverse_D15_p9 = 0.18125194219699997 + (inverse_D15_p4 + inverse_D15_p8);

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D15 = 1.0 / inverse_D15_p9;
  const Real Lambda_inv_0_0_p299 = Lambda_inv_0_0_p298 * inverse_D15;
  const Real Lambda_inv_0_0_p300 = 0.00010499999999999999 * Lambda_inv_0_0_p299 -
      0.0017499999999999998;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p301 = 1.75e-05 - (inverse_D15_p5 - s16 * inverse_D15_p7);
  const Real Lambda_inv_0_0_p302 = s16 * Lambda_inv_0_0_p296;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p303 = 0.7139200499999999 +
      (Lambda_inv_0_0_p295 - Lambda_inv_0_0_p302) + Lambda_inv_0_0_p301 * Lambda_inv_0_0_p299;
  const Real Lambda_inv_0_0_p304 = 0.0017499999999999998 +
      (s15 * Lambda_inv_0_0_p300 - c15 * Lambda_inv_0_0_p303);
  const Real inverse_D14_p1 = Lambda_inv_0_0_p301 * inverse_D15;
  const Real inverse_D14_p2 = 0.18113119219699997 + (inverse_D15_p2 - inverse_D15_p8) -
      Lambda_inv_0_0_p301 * inverse_D14_p1;
  const Real inverse_D14_p3 = 0.00012075 - 1.1024999999999998e-08 / inverse_D15_p9;
  const Real inverse_D14_p4 = 5.2499999999999995e-05 + 0.00010499999999999999 * inverse_D14_p1;
  const Real inverse_D14_p5 = 2.0 * c15;
  const Real inverse_D14_p6 = s15 * (inverse_D14_p3 - inverse_D14_p2) + inverse_D14_p5 *
      inverse_D14_p4;
  const Real inverse_D14_p7 = s15 * inverse_D14_p6;
  const Real inverse_D14_p8 = 0.000448 + (inverse_D14_p2 + inverse_D14_p7);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D14 = 1.0 / inverse_D14_p8;
  const Real Lambda_inv_0_0_p305 = Lambda_inv_0_0_p304 * inverse_D14;
  const Real Lambda_inv_0_0_p306 = 2.6249999999999998e-05 * Lambda_inv_0_0_p305;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p307 = 0.7139200499999999 + (Lambda_inv_0_0_p302 + Lambda_inv_0_0_p288);

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p308 = Lambda_inv_0_0_p307 * inverse_D15;
  const Real Lambda_inv_0_0_p309 = 0.00010499999999999999 * Lambda_inv_0_0_p308;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p310 = Lambda_inv_0_0_p261 + Lambda_inv_0_0_p267;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p311 = Lambda_inv_0_0_p310 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p312 = c17 * Lambda_inv_0_0_p275 - s17 * Lambda_inv_0_0_p272;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p313 = 0.282 * Lambda_inv_0_0_p312 -
      (Lambda_inv_0_0_p250 - Lambda_inv_0_0_p263) - 0.004500002325 + Lambda_inv_0_0_p247 *
      Lambda_inv_0_0_p311;

  // link 17 (right_lowerarm), articulated inertia
  const Real Lambda_inv_0_0_p314 = c17 * Lambda_inv_0_0_p292 - Lambda_inv_0_0_p291;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p315 = 0.0022500062 + 0.282 * Lambda_inv_0_0_p314 +
      Lambda_inv_0_0_p282 * Lambda_inv_0_0_p311;
  const Real Lambda_inv_0_0_p316 = 0.0017499999999999998 -
      (c16 * Lambda_inv_0_0_p313 - s16 * Lambda_inv_0_0_p315);

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p317 = Lambda_inv_0_0_p316 * inverse_D15;
  const Real Lambda_inv_0_0_p318 = s16 * Lambda_inv_0_0_p313 + c16 * Lambda_inv_0_0_p315 +
      Lambda_inv_0_0_p301 * Lambda_inv_0_0_p317;
  const Real Lambda_inv_0_0_p319 = Lambda_inv_0_0_p279 - Lambda_inv_0_0_p297 - Lambda_inv_0_0_p301 *
      Lambda_inv_0_0_p308;
  const Real Lambda_inv_0_0_p320 = 0.00010499999999999999 * Lambda_inv_0_0_p317;
  const Real Lambda_inv_0_0_p321 = s15 * (Lambda_inv_0_0_p320 - Lambda_inv_0_0_p319) + c15 *
      (Lambda_inv_0_0_p309 - Lambda_inv_0_0_p318);
  const Real Lambda_inv_0_0_p322 = c15 * Lambda_inv_0_0_p321;
  const Real Lambda_inv_0_0_p323 = 0.0017499999999999998 +
      (Lambda_inv_0_0_p322 - Lambda_inv_0_0_p309);

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p324 = Lambda_inv_0_0_p323 * inverse_D14;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p325 = 2.6249999999999998e-05 + (c15 * inverse_D14_p6 - inverse_D14_p4);
  const Real Lambda_inv_0_0_p326 = s15 * Lambda_inv_0_0_p321;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p327 = Lambda_inv_0_0_p320 - Lambda_inv_0_0_p326 - Lambda_inv_0_0_p325 *
      Lambda_inv_0_0_p324;
  const Real Lambda_inv_0_0_p328 = c15 * Lambda_inv_0_0_p300 + s15 * Lambda_inv_0_0_p303 -
      Lambda_inv_0_0_p325 * Lambda_inv_0_0_p305;
  const Real Lambda_inv_0_0_p329 = 2.6249999999999998e-05 * Lambda_inv_0_0_p324;
  const Real Lambda_inv_0_0_p330 = c14 * (Lambda_inv_0_0_p306 + Lambda_inv_0_0_p327) + s14 *
      (Lambda_inv_0_0_p328 - Lambda_inv_0_0_p329);
  const Real Lambda_inv_0_0_p331 = s14 * Lambda_inv_0_0_p330;
  const Real Lambda_inv_0_0_p332 = Lambda_inv_0_0_p331 + Lambda_inv_0_0_p329;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p333 = Lambda_inv_0_0_p319 + Lambda_inv_0_0_p326;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p334 = Lambda_inv_0_0_p333 * inverse_D14;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p335 = Lambda_inv_0_0_p294 - Lambda_inv_0_0_p265 * Lambda_inv_0_0_p266;
  const Real Lambda_inv_0_0_p336 = Lambda_inv_0_0_p286 - Lambda_inv_0_0_p280 * Lambda_inv_0_0_p281;
  const Real Lambda_inv_0_0_p337 = Lambda_inv_0_0_p276 - Lambda_inv_0_0_p265 * Lambda_inv_0_0_p281;
  const Real Lambda_inv_0_0_p338 = c16 * (Lambda_inv_0_0_p335 - Lambda_inv_0_0_p336) -
      inverse_D15_p6 * Lambda_inv_0_0_p337;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p339 = s16 * Lambda_inv_0_0_p338 + Lambda_inv_0_0_p337 -
      Lambda_inv_0_0_p307 * Lambda_inv_0_0_p299;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p340 = Lambda_inv_0_0_p265 * Lambda_inv_0_0_p311 - Lambda_inv_0_0_p314;
  const Real Lambda_inv_0_0_p341 = Lambda_inv_0_0_p312 + Lambda_inv_0_0_p280 * Lambda_inv_0_0_p311;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p342 = c16 * Lambda_inv_0_0_p340 - s16 * Lambda_inv_0_0_p341 +
      Lambda_inv_0_0_p316 * Lambda_inv_0_0_p299;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p343 = c15 * Lambda_inv_0_0_p339 - s15 * Lambda_inv_0_0_p342 -
      Lambda_inv_0_0_p304 * Lambda_inv_0_0_p334;

  // link 16 (right_upperarm), articulated inertia
  const Real Lambda_inv_0_0_p344 = c16 * Lambda_inv_0_0_p338;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p345 = Lambda_inv_0_0_p335 - Lambda_inv_0_0_p344 - Lambda_inv_0_0_p307 *
      Lambda_inv_0_0_p308;
  const Real Lambda_inv_0_0_p346 = Lambda_inv_0_0_p293 - Lambda_inv_0_0_p290 - Lambda_inv_0_0_p310 *
      Lambda_inv_0_0_p311 - Lambda_inv_0_0_p316 * Lambda_inv_0_0_p317;
  const Real Lambda_inv_0_0_p347 = s16 * Lambda_inv_0_0_p340 + c16 * Lambda_inv_0_0_p341 +
      Lambda_inv_0_0_p316 * Lambda_inv_0_0_p308;
  const Real Lambda_inv_0_0_p348 = s15 * (Lambda_inv_0_0_p346 - Lambda_inv_0_0_p345) -
      inverse_D14_p5 * Lambda_inv_0_0_p347;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p349 = c15 * Lambda_inv_0_0_p348 + Lambda_inv_0_0_p347 -
      Lambda_inv_0_0_p323 * Lambda_inv_0_0_p334;
  const Real Lambda_inv_0_0_p350 = s14 * Lambda_inv_0_0_p343 + c14 * Lambda_inv_0_0_p349;
  const Real Lambda_inv_0_0_p351 = Lambda_inv_0_0_p336 + Lambda_inv_0_0_p344 - Lambda_inv_0_0_p298 *
      Lambda_inv_0_0_p299 - Lambda_inv_0_0_p304 * Lambda_inv_0_0_p305;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p352 = s15 * Lambda_inv_0_0_p348;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p353 = Lambda_inv_0_0_p346 - Lambda_inv_0_0_p352 - Lambda_inv_0_0_p323 *
      Lambda_inv_0_0_p324;
  const Real Lambda_inv_0_0_p354 = c15 * Lambda_inv_0_0_p342 + s15 * Lambda_inv_0_0_p339 +
      Lambda_inv_0_0_p304 * Lambda_inv_0_0_p324;
  const Real Lambda_inv_0_0_p355 = 2.0 * s14;
  const Real Lambda_inv_0_0_p356 = c14 * (Lambda_inv_0_0_p351 - Lambda_inv_0_0_p353) +
      Lambda_inv_0_0_p355 * Lambda_inv_0_0_p354;
  const Real Lambda_inv_0_0_p357 = c14 * Lambda_inv_0_0_p356;
  const Real Lambda_inv_0_0_p358 = Lambda_inv_0_0_p351 - Lambda_inv_0_0_p357;
  const Real Lambda_inv_0_0_p359 = Lambda_inv_0_0_p332 +
      (0.226 * Lambda_inv_0_0_p350 - 0.18 * Lambda_inv_0_0_p358);

  // link 23 (left_eye), articulated inertia
  const Real Lambda_inv_0_0_p360 = 0.0007770270270270272 * c23;
  const Real Lambda_inv_0_0_p361 = c23 * Lambda_inv_0_0_p360;

  // link 24 (right_eye), articulated inertia
  const Real Lambda_inv_0_0_p362 = 0.0007770270270270272 * c24;
  const Real Lambda_inv_0_0_p363 = c24 * Lambda_inv_0_0_p362;

  // link 23 (left_eye), articulated inertia
  const Real Lambda_inv_0_0_p364 = s23 * Lambda_inv_0_0_p360;

  // link 24 (right_eye), articulated inertia
  const Real Lambda_inv_0_0_p365 = s24 * Lambda_inv_0_0_p362;

  // link 23 (left_eye), articulated inertia
  const Real Lambda_inv_0_0_p366 = Lambda_inv_0_0_p364 + Lambda_inv_0_0_p365;
  const Real Lambda_inv_0_0_p367 = 0.032 * (Lambda_inv_0_0_p361 - Lambda_inv_0_0_p363) - 0.095 *
      Lambda_inv_0_0_p366;
  const Real Lambda_inv_0_0_p368 = Lambda_inv_0_0_p363 + Lambda_inv_0_0_p361;
  const Real Lambda_inv_0_0_p369 = 0.430445945945946 + Lambda_inv_0_0_p368;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D22_p1 = 9.060810810810813e-05 * s24;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D22_p2 = 9.060810810810813e-05 * s23;
  const Real inverse_D22_p3 = s24 * inverse_D22_p1 + s23 * inverse_D22_p2;
  const Real inverse_D22_p4 = c24 + c23;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p3 + 4.75e-05 * inverse_D22_p4);
  const Real Lambda_inv_0_0_p370 = Lambda_inv_0_0_p369 * inverse_D22;

  // link 24 (right_eye), articulated inertia
  const Real Lambda_inv_0_0_p371 = 0.006756756756756757 * s24;
  const Real Lambda_inv_0_0_p372 = c24 * Lambda_inv_0_0_p371;
  const Real Lambda_inv_0_0_p373 = s24 * Lambda_inv_0_0_p371;
  const Real Lambda_inv_0_0_p374 = 0.095 * Lambda_inv_0_0_p372 - 0.032 * Lambda_inv_0_0_p373;

  // link 23 (left_eye), articulated inertia
  const Real Lambda_inv_0_0_p375 = 0.006756756756756757 * s23;
  const Real Lambda_inv_0_0_p376 = c23 * Lambda_inv_0_0_p375;
  const Real Lambda_inv_0_0_p377 = s23 * Lambda_inv_0_0_p375;
  const Real Lambda_inv_0_0_p378 = 0.095 * Lambda_inv_0_0_p376 + 0.032 * Lambda_inv_0_0_p377;

  // link 22 (head), articulated inertia
  const Real Lambda_inv_0_0_p379 = Lambda_inv_0_0_p374 + Lambda_inv_0_0_p378 + Lambda_inv_0_0_p367 *
      Lambda_inv_0_0_p370;

  // link 23 (left_eye), articulated inertia
  const Real Lambda_inv_0_0_p380 = s24 + s23;
  const Real Lambda_inv_0_0_p381 = 8e-06 * (c24 - c23) -
      (c24 * inverse_D22_p1 + c23 * inverse_D22_p2 + 2.375e-05 * Lambda_inv_0_0_p380);
  const Real Lambda_inv_0_0_p382 = 0.072575 + 0.00025 * inverse_D22_p4;

  // link 22 (head), articulated inertia
  const Real Lambda_inv_0_0_p383 = Lambda_inv_0_0_p382 * inverse_D22;
  const Real Lambda_inv_0_0_p384 = Lambda_inv_0_0_p381 * Lambda_inv_0_0_p383 + 0.00025 *
      Lambda_inv_0_0_p380;
  const Real Lambda_inv_0_0_p385 = Lambda_inv_0_0_p367 * Lambda_inv_0_0_p383;
  const Real Lambda_inv_0_0_p386 = Lambda_inv_0_0_p366 + Lambda_inv_0_0_p381 * Lambda_inv_0_0_p370;
  const Real Lambda_inv_0_0_p387 = c22 * (Lambda_inv_0_0_p379 + Lambda_inv_0_0_p384) - s22 *
      (Lambda_inv_0_0_p385 - Lambda_inv_0_0_p386);
  const Real Lambda_inv_0_0_p388 = s22 * Lambda_inv_0_0_p387;
  const Real Lambda_inv_0_0_p389 = Lambda_inv_0_0_p385 + Lambda_inv_0_0_p388;
  const Real inverse_D21_p1 = Lambda_inv_0_0_p367 * inverse_D22;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D21_p2 = Lambda_inv_0_0_p373 - 0.006756756756756757;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D21_p3 = Lambda_inv_0_0_p377 - 0.006756756756756757;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p4 = 0.095 * inverse_D21_p2 + 0.032 * Lambda_inv_0_0_p372 +
      (0.095 * inverse_D21_p3 - 0.032 * Lambda_inv_0_0_p376);
  const Real inverse_D21_p5 = 0.009438624999999999 - Lambda_inv_0_0_p367 * inverse_D21_p1 + 0.095 *
      inverse_D21_p4 + 0.032 * (Lambda_inv_0_0_p374 - Lambda_inv_0_0_p378);
  const Real inverse_D21_p6 = 0.05450270000000001 + inverse_D22_p3 - Lambda_inv_0_0_p381 *
      Lambda_inv_0_0_p381 * inverse_D22 + 1.6e-05 * (s23 - s24) - 0.00017071621621621625;
  const Real inverse_D21_p7 = 0.0074 - Lambda_inv_0_0_p381 * inverse_D21_p1 - 0.095 *
      Lambda_inv_0_0_p368 + 0.032 * (Lambda_inv_0_0_p365 - Lambda_inv_0_0_p364);
  const Real inverse_D21_p8 = 2.0 * c22;
  const Real inverse_D21_p9 = s22 * (inverse_D21_p6 - inverse_D21_p5) + inverse_D21_p8 *
      inverse_D21_p7;
  const Real inverse_D21_p10 = s22 * inverse_D21_p9;

  // link 21 (neck), articulated inertia
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p5 + inverse_D21_p10));
  const Real Lambda_inv_0_0_p390 = Lambda_inv_0_0_p389 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real Lambda_inv_0_0_p391 = c22 * Lambda_inv_0_0_p387;
  const Real Lambda_inv_0_0_p392 = Lambda_inv_0_0_p384 - Lambda_inv_0_0_p391;
  const Real Lambda_inv_0_0_p393 = 0.394 * Lambda_inv_0_0_p392;
  const Real Lambda_inv_0_0_p394 = Lambda_inv_0_0_p369 * Lambda_inv_0_0_p383;
  const Real Lambda_inv_0_0_p395 = Lambda_inv_0_0_p373 + Lambda_inv_0_0_p377 + Lambda_inv_0_0_p369 *
      Lambda_inv_0_0_p370;
  const Real Lambda_inv_0_0_p396 = Lambda_inv_0_0_p382 * Lambda_inv_0_0_p383;
  const Real Lambda_inv_0_0_p397 = inverse_D21_p8 * Lambda_inv_0_0_p394 - s22 *
      (Lambda_inv_0_0_p396 - Lambda_inv_0_0_p395);
  const Real Lambda_inv_0_0_p398 = Lambda_inv_0_0_p394 - c22 * Lambda_inv_0_0_p397;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p399 = 0.0045000000000000005 + 0.394 * Lambda_inv_0_0_p398 +
      Lambda_inv_0_0_p393 * Lambda_inv_0_0_p390;

  // link 22 (head), articulated inertia
  const Real Lambda_inv_0_0_p400 = Lambda_inv_0_0_p366 * inverse_D22;
  const Real Lambda_inv_0_0_p401 = 0.072575 + inverse_D21_p4 + Lambda_inv_0_0_p367 *
      Lambda_inv_0_0_p400;
  const Real Lambda_inv_0_0_p402 = Lambda_inv_0_0_p368 - 0.43200000000000005 - Lambda_inv_0_0_p381 *
      Lambda_inv_0_0_p400;
  const Real Lambda_inv_0_0_p403 = c22 * Lambda_inv_0_0_p401 - s22 * Lambda_inv_0_0_p402;
  const Real Lambda_inv_0_0_p404 = 0.0016155 + (c22 * inverse_D21_p9 - inverse_D21_p7 + 0.394 *
      Lambda_inv_0_0_p403);
  const Real Lambda_inv_0_0_p405 = Lambda_inv_0_0_p382 * Lambda_inv_0_0_p400;
  const Real Lambda_inv_0_0_p406 = Lambda_inv_0_0_p372 + Lambda_inv_0_0_p376 - Lambda_inv_0_0_p369 *
      Lambda_inv_0_0_p400;
  const Real Lambda_inv_0_0_p407 = c22 * Lambda_inv_0_0_p405 - s22 * Lambda_inv_0_0_p406;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p408 = Lambda_inv_0_0_p379 - Lambda_inv_0_0_p391 + 0.394 *
      Lambda_inv_0_0_p407 + Lambda_inv_0_0_p404 * Lambda_inv_0_0_p390;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p409 = Lambda_inv_0_0_p183 -
      (s21 * Lambda_inv_0_0_p399 - c21 * Lambda_inv_0_0_p408 + Lambda_inv_0_0_p359);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D6_p1 = Lambda_inv_0_0_p325 * inverse_D14;
  const Real inverse_D6_p2 = 0.0002975 + (inverse_D14_p3 - inverse_D14_p7) - Lambda_inv_0_0_p325 *
      inverse_D6_p1;
  const Real inverse_D6_p3 = 6.890624999999999e-10 / inverse_D14_p8;
  const Real inverse_D6_p4 = 2.6249999999999998e-05 * inverse_D6_p1;
  const Real inverse_D6_p5 = c14 * (0.0001505 - inverse_D6_p3 - inverse_D6_p2) +
      Lambda_inv_0_0_p355 * (8.75e-06 + inverse_D6_p4);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p6 = Lambda_inv_0_0_p149 * inverse_D7;
  const Real inverse_D6_p7 = 0.0002975 + (inverse_D7_p3 - inverse_D7_p7) - Lambda_inv_0_0_p149 *
      inverse_D6_p6;
  const Real inverse_D6_p8 = 0.0001505 - 6.890624999999999e-10 / inverse_D7_p8;
  const Real inverse_D6_p9 = 2.6249999999999998e-05 * inverse_D6_p6 - 8.75e-06;
  const Real inverse_D6_p10 = c7 * (inverse_D6_p8 - inverse_D6_p7) - Lambda_inv_0_0_p174 *
      inverse_D6_p9;
  const Real inverse_D6_p11 = c14 * inverse_D6_p5 + c7 * inverse_D6_p10;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p12 = c22 * Lambda_inv_0_0_p402 + s22 * Lambda_inv_0_0_p401;
  const Real inverse_D6_p13 = inverse_D21_p2 + inverse_D21_p3 - Lambda_inv_0_0_p366 *
      Lambda_inv_0_0_p400;
  const Real inverse_D6_p14 = inverse_D6_p12 - 0.394 * inverse_D6_p13;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p15 = 0.005513625 + (inverse_D21_p6 - inverse_D21_p10 - 0.394 *
      (inverse_D6_p12 + inverse_D6_p14)) - Lambda_inv_0_0_p404 *
      (Lambda_inv_0_0_p404 * inverse_D21);
  const Real inverse_D6_p16 = Lambda_inv_0_0_p393 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p17 = s22 * Lambda_inv_0_0_p397;
  const Real inverse_D6_p18 = inverse_D6_p17 - Lambda_inv_0_0_p395;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p19 = 0.000703125 + 0.155236 * inverse_D6_p18 - Lambda_inv_0_0_p393 *
      inverse_D6_p16;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p20 = c22 * Lambda_inv_0_0_p406 + s22 * Lambda_inv_0_0_p405;
  const Real inverse_D6_p21 = 0.394 * inverse_D6_p20;
  const Real inverse_D6_p22 = Lambda_inv_0_0_p388 - Lambda_inv_0_0_p386 - inverse_D6_p21;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p23 = 0.394 * inverse_D6_p22 - Lambda_inv_0_0_p404 * inverse_D6_p16;
  const Real inverse_D6_p24 = 2.0 * s21;
  const Real inverse_D6_p25 = c21 * (inverse_D6_p15 - inverse_D6_p19) - inverse_D6_p24 *
      inverse_D6_p23;
  const Real inverse_D6_p26 = c21 * inverse_D6_p25;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p27 = 2.06965463592404 + inverse_D6_p19 + inverse_D6_p26 + inverse_D6_p2 +
      inverse_D6_p11 + inverse_D6_p7 - 0.18 * (Lambda_inv_0_0_p332 + Lambda_inv_0_0_p359 +
      (Lambda_inv_0_0_p156 + Lambda_inv_0_0_p183));

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D6_p28 = 0.0017499999999999998 + 2.6249999999999998e-05 * Lambda_inv_0_0_p334;
  const Real inverse_D6_p29 = Lambda_inv_0_0_p322 + Lambda_inv_0_0_p318 - 0.0017499999999999998 -
      Lambda_inv_0_0_p325 * Lambda_inv_0_0_p334;
  const Real inverse_D6_p30 = c14 * inverse_D6_p28 + s14 * inverse_D6_p29;
  const Real inverse_D6_p31 = Lambda_inv_0_0_p345 + Lambda_inv_0_0_p352 - Lambda_inv_0_0_p333 *
      Lambda_inv_0_0_p334;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p32 = 2.6249999999999998e-05 * Lambda_inv_0_0_p179 - 0.0017499999999999998;
  const Real inverse_D6_p33 = Lambda_inv_0_0_p146 - Lambda_inv_0_0_p139 - 0.0017499999999999998 -
      Lambda_inv_0_0_p149 * Lambda_inv_0_0_p179;
  const Real inverse_D6_p34 = c7 * inverse_D6_p32 - s7 * inverse_D6_p33;
  const Real inverse_D6_p35 = Lambda_inv_0_0_p163 + Lambda_inv_0_0_p169 - Lambda_inv_0_0_p178 *
      Lambda_inv_0_0_p179;
  const Real inverse_D6_p36 = inverse_D6_p30 + (0.226 * inverse_D6_p31 - 0.18 *
      Lambda_inv_0_0_p350) - (inverse_D6_p34 - (0.18 * Lambda_inv_0_0_p182 + 0.226 *
      inverse_D6_p35));

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / (inverse_D6_p27 + 0.226 *
      (inverse_D6_p30 + inverse_D6_p36 - inverse_D6_p34));
  const Real Lambda_inv_0_0_p410 = Lambda_inv_0_0_p409 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p411 = c7 * Lambda_inv_0_0_p154;
  const Real Lambda_inv_0_0_p412 = s7 * Lambda_inv_0_0_p175 + Lambda_inv_0_0_p173;
  const Real Lambda_inv_0_0_p413 = 0.18 * Lambda_inv_0_0_p412;
  const Real Lambda_inv_0_0_p414 = c7 * Lambda_inv_0_0_p180 - s7 * Lambda_inv_0_0_p181;
  const Real Lambda_inv_0_0_p415 = 0.226 * Lambda_inv_0_0_p414;
  const Real Lambda_inv_0_0_p416 = Lambda_inv_0_0_p411 - Lambda_inv_0_0_p151 -
      (Lambda_inv_0_0_p413 + Lambda_inv_0_0_p415);
  const Real Lambda_inv_0_0_p417 = Lambda_inv_0_0_p130 - Lambda_inv_0_0_p411;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p418 = c14 * Lambda_inv_0_0_p330;
  const Real Lambda_inv_0_0_p419 = Lambda_inv_0_0_p354 - s14 * Lambda_inv_0_0_p356;
  const Real Lambda_inv_0_0_p420 = 0.18 * Lambda_inv_0_0_p419;
  const Real Lambda_inv_0_0_p421 = c14 * Lambda_inv_0_0_p343 - s14 * Lambda_inv_0_0_p349;
  const Real Lambda_inv_0_0_p422 = 0.226 * Lambda_inv_0_0_p421;
  const Real Lambda_inv_0_0_p423 = Lambda_inv_0_0_p327 - Lambda_inv_0_0_p418 -
      (Lambda_inv_0_0_p420 + Lambda_inv_0_0_p422);
  const Real Lambda_inv_0_0_p424 = Lambda_inv_0_0_p418 - Lambda_inv_0_0_p306;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p425 = 0.0187281677636143 - inverse_D6_p4 + s14 * inverse_D6_p5 + s7 *
      inverse_D6_p10 + inverse_D6_p9 + 0.18 * (Lambda_inv_0_0_p416 - Lambda_inv_0_0_p417 -
      (Lambda_inv_0_0_p423 - Lambda_inv_0_0_p424));
  const Real Lambda_inv_0_0_p426 = s14 * inverse_D6_p28 - c14 * inverse_D6_p29 -
      (s7 * inverse_D6_p32 + c7 * inverse_D6_p33);
  const Real Lambda_inv_0_0_p427 = Lambda_inv_0_0_p425 + 0.226 * Lambda_inv_0_0_p426;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p428 = Lambda_inv_0_0_p424 + Lambda_inv_0_0_p420 +
      (Lambda_inv_0_0_p417 + Lambda_inv_0_0_p413) - Lambda_inv_0_0_p427 * Lambda_inv_0_0_p410;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p429 = Lambda_inv_0_0_p423 + Lambda_inv_0_0_p416;
  const Real Lambda_inv_0_0_p430 = s21 * inverse_D6_p25 + inverse_D6_p23 + 0.226 *
      Lambda_inv_0_0_p429;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p431 = Lambda_inv_0_0_p392 * inverse_D21;
  const Real Lambda_inv_0_0_p432 = inverse_D6_p22 - Lambda_inv_0_0_p404 * Lambda_inv_0_0_p431;

  // link 22 (head), articulated inertia
  const Real Lambda_inv_0_0_p433 = 0.0045000000000000005 + Lambda_inv_0_0_p403;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p434 = Lambda_inv_0_0_p433 * inverse_D21;
  const Real Lambda_inv_0_0_p435 = inverse_D6_p21 + Lambda_inv_0_0_p393 * Lambda_inv_0_0_p434;
  const Real Lambda_inv_0_0_p436 = 0.394 * inverse_D6_p18 - Lambda_inv_0_0_p393 *
      Lambda_inv_0_0_p431;
  const Real Lambda_inv_0_0_p437 = inverse_D6_p14 + Lambda_inv_0_0_p404 * Lambda_inv_0_0_p434;
  const Real Lambda_inv_0_0_p438 = c21 * (Lambda_inv_0_0_p432 - Lambda_inv_0_0_p435) - s21 *
      (Lambda_inv_0_0_p436 + Lambda_inv_0_0_p437);
  const Real Lambda_inv_0_0_p439 = s21 * Lambda_inv_0_0_p438;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p440 = Lambda_inv_0_0_p439 + Lambda_inv_0_0_p437 - 6.1665928899999995 -
      inverse_D6_p36;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p441 = Lambda_inv_0_0_p440 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p442 = c21 * Lambda_inv_0_0_p438;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p443 = Lambda_inv_0_0_p432 - Lambda_inv_0_0_p442 + Lambda_inv_0_0_p422 +
      Lambda_inv_0_0_p415 - Lambda_inv_0_0_p430 * Lambda_inv_0_0_p441;
  const Real Lambda_inv_0_0_p444 = Lambda_inv_0_0_p419 - Lambda_inv_0_0_p412;
  const Real Lambda_inv_0_0_p445 = s21 * Lambda_inv_0_0_p408 + c21 * Lambda_inv_0_0_p399 -
      Lambda_inv_0_0_p430 * Lambda_inv_0_0_p410 - 0.226 * Lambda_inv_0_0_p444;
  const Real Lambda_inv_0_0_p446 = 0.18 * (Lambda_inv_0_0_p414 - Lambda_inv_0_0_p421) -
      (Lambda_inv_0_0_p426 + Lambda_inv_0_0_p427 * Lambda_inv_0_0_p441);
  const Real Lambda_inv_0_0_p447 = s6 * (Lambda_inv_0_0_p428 - Lambda_inv_0_0_p443) + c6 *
      (Lambda_inv_0_0_p445 + Lambda_inv_0_0_p446);
  const Real Lambda_inv_0_0_p448 = s6 * Lambda_inv_0_0_p447;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p449 = Lambda_inv_0_0_p435 + Lambda_inv_0_0_p442 + Lambda_inv_0_0_p429;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p450 = Lambda_inv_0_0_p449 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p451 = Lambda_inv_0_0_p398 + Lambda_inv_0_0_p392 * Lambda_inv_0_0_p390;
  const Real Lambda_inv_0_0_p452 = Lambda_inv_0_0_p407 + Lambda_inv_0_0_p433 * Lambda_inv_0_0_p390;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p453 = c21 * Lambda_inv_0_0_p451 + s21 * Lambda_inv_0_0_p452 -
      Lambda_inv_0_0_p444 - Lambda_inv_0_0_p409 * Lambda_inv_0_0_p450;

  // link 21 (neck), articulated inertia
  const Real Lambda_inv_0_0_p454 = inverse_D6_p18 - Lambda_inv_0_0_p392 * Lambda_inv_0_0_p431;
  const Real Lambda_inv_0_0_p455 = inverse_D6_p13 - Lambda_inv_0_0_p433 * Lambda_inv_0_0_p434;
  const Real Lambda_inv_0_0_p456 = inverse_D6_p20 + Lambda_inv_0_0_p392 * Lambda_inv_0_0_p434;
  const Real Lambda_inv_0_0_p457 = c21 * (Lambda_inv_0_0_p454 - Lambda_inv_0_0_p455) -
      inverse_D6_p24 * Lambda_inv_0_0_p456;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p458 = s21 * Lambda_inv_0_0_p457 + Lambda_inv_0_0_p456 +
      Lambda_inv_0_0_p421 + Lambda_inv_0_0_p414 - Lambda_inv_0_0_p440 * Lambda_inv_0_0_p450;
  const Real Lambda_inv_0_0_p459 = s6 * Lambda_inv_0_0_p453 + c6 * Lambda_inv_0_0_p458;
  const Real Lambda_inv_0_0_p460 = 0.072 * Lambda_inv_0_0_p459;
  const Real Lambda_inv_0_0_p461 = Lambda_inv_0_0_p443 + Lambda_inv_0_0_p448 + Lambda_inv_0_0_p460;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p1 = Lambda_inv_0_0_p155 + Lambda_inv_0_0_p152;
  const Real inverse_D5_p2 = Lambda_inv_0_0_p170 + Lambda_inv_0_0_p176;
  const Real inverse_D5_p3 = inverse_D5_p1 + 0.18 * inverse_D5_p2;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p4 = Lambda_inv_0_0_p331 - Lambda_inv_0_0_p328;
  const Real inverse_D5_p5 = Lambda_inv_0_0_p353 + Lambda_inv_0_0_p357;
  const Real inverse_D5_p6 = inverse_D5_p4 + 0.18 * inverse_D5_p5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p7 = inverse_D5_p3 - inverse_D5_p6 - Lambda_inv_0_0_p427 *
      Lambda_inv_0_0_p450;
  const Real inverse_D5_p8 = inverse_D5_p5 + inverse_D5_p2;
  const Real inverse_D5_p9 = 6.1665928899999995 + Lambda_inv_0_0_p439 + Lambda_inv_0_0_p436 -
      Lambda_inv_0_0_p430 * Lambda_inv_0_0_p450 + 0.226 * inverse_D5_p8;
  const Real inverse_D5_p10 = s6 * inverse_D5_p7 + c6 * inverse_D5_p9;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p11 = c21 * Lambda_inv_0_0_p457;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p12 = Lambda_inv_0_0_p455 + inverse_D5_p11 + inverse_D5_p8 -
      Lambda_inv_0_0_p449 * Lambda_inv_0_0_p450;
  const Real inverse_D5_p13 = inverse_D5_p10 + 0.072 * inverse_D5_p12;
  const Real inverse_D5_p14 = Lambda_inv_0_0_p427 * inverse_D6;
  const Real inverse_D5_p15 = 0.40056549999999996 - inverse_D6_p3 - inverse_D6_p11 + inverse_D6_p8 -
      Lambda_inv_0_0_p427 * inverse_D5_p14 + 0.18 * (inverse_D5_p4 + inverse_D5_p6 +
      (inverse_D5_p1 + inverse_D5_p3));
  const Real inverse_D5_p16 = Lambda_inv_0_0_p430 * inverse_D6;
  const Real inverse_D5_p17 = 1.66923963592404 + inverse_D6_p15 - inverse_D6_p26 -
      Lambda_inv_0_0_p430 * inverse_D5_p16 + 0.051076 * inverse_D5_p8;
  const Real inverse_D5_p18 = 0.04068 * (inverse_D5_p2 - inverse_D5_p5) - Lambda_inv_0_0_p427 *
      inverse_D5_p16 + 0.226 * (inverse_D5_p1 - inverse_D5_p4);
  const Real inverse_D5_p19 = 2.0 * c6;
  const Real inverse_D5_p20 = s6 * (inverse_D5_p15 - inverse_D5_p17) + inverse_D5_p19 *
      inverse_D5_p18;
  const Real inverse_D5_p21 = s6 * inverse_D5_p20;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p17 + inverse_D5_p21 + 0.072 * (inverse_D5_p10 + inverse_D5_p13)));
  const Real Lambda_inv_0_0_p462 = Lambda_inv_0_0_p461 * inverse_D5;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p463 = 0.072 * Lambda_inv_0_0_p461;
  const Real Lambda_inv_0_0_p464 = Lambda_inv_0_0_p358 -
      (Lambda_inv_0_0_p396 + inverse_D6_p17 + Lambda_inv_0_0_p389 * Lambda_inv_0_0_p390) +
      Lambda_inv_0_0_p177 - Lambda_inv_0_0_p409 * Lambda_inv_0_0_p410;
  const Real Lambda_inv_0_0_p465 = Lambda_inv_0_0_p454 - inverse_D5_p11 + inverse_D6_p31 +
      inverse_D6_p35 - Lambda_inv_0_0_p440 * Lambda_inv_0_0_p441;
  const Real Lambda_inv_0_0_p466 = s21 * Lambda_inv_0_0_p451 - c21 * Lambda_inv_0_0_p452 +
      Lambda_inv_0_0_p350 + Lambda_inv_0_0_p182 - Lambda_inv_0_0_p409 * Lambda_inv_0_0_p441;
  const Real Lambda_inv_0_0_p467 = s6 * (Lambda_inv_0_0_p464 - Lambda_inv_0_0_p465) +
      inverse_D5_p19 * Lambda_inv_0_0_p466;
  const Real Lambda_inv_0_0_p468 = s6 * Lambda_inv_0_0_p467;
  const Real Lambda_inv_0_0_p469 = Lambda_inv_0_0_p465 + Lambda_inv_0_0_p468;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p470 = Lambda_inv_0_0_p463 * Lambda_inv_0_0_p462 -
      (2.2194301519999997 + 0.072 * Lambda_inv_0_0_p469);

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p471 = c6 * inverse_D5_p7 - s6 * inverse_D5_p9;
  const Real Lambda_inv_0_0_p472 = c6 * inverse_D5_p20 - inverse_D5_p18 + 0.072 *
      Lambda_inv_0_0_p471;
  const Real Lambda_inv_0_0_p473 = c6 * Lambda_inv_0_0_p447;
  const Real Lambda_inv_0_0_p474 = Lambda_inv_0_0_p473 - Lambda_inv_0_0_p445;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p475 = Lambda_inv_0_0_p474 - 0.069699984375 - Lambda_inv_0_0_p472 *
      Lambda_inv_0_0_p462;
  const Real Lambda_inv_0_0_p476 = s5 * Lambda_inv_0_0_p470 + c5 * Lambda_inv_0_0_p475;
  const Real Lambda_inv_0_0_p477 = Lambda_inv_0_0_p463 * inverse_D5;
  const Real Lambda_inv_0_0_p478 = 0.15637308509675518 + 0.005183999999999999 *
      Lambda_inv_0_0_p469 - Lambda_inv_0_0_p463 * Lambda_inv_0_0_p477;
  const Real Lambda_inv_0_0_p479 = Lambda_inv_0_0_p472 * inverse_D5;
  const Real Lambda_inv_0_0_p480 = 0.04675382692737882 + (inverse_D5_p15 - inverse_D5_p21) -
      Lambda_inv_0_0_p472 * Lambda_inv_0_0_p479;
  const Real Lambda_inv_0_0_p481 = 0.005678398088837119 - 0.072 * Lambda_inv_0_0_p474 +
      Lambda_inv_0_0_p463 * Lambda_inv_0_0_p479;
  const Real Lambda_inv_0_0_p482 = 2.0 * c5;
  const Real Lambda_inv_0_0_p483 = s5 * (Lambda_inv_0_0_p478 - Lambda_inv_0_0_p480) +
      Lambda_inv_0_0_p482 * Lambda_inv_0_0_p481;
  const Real Lambda_inv_0_0_p484 = 0.005880002159562879 +
      (0.21799999999999997 * Lambda_inv_0_0_p476 - (c5 * Lambda_inv_0_0_p483 -
      Lambda_inv_0_0_p481));

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p485 = 2.2194301519999997 + inverse_D5_p13;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p486 = Lambda_inv_0_0_p485 * inverse_D5;
  const Real Lambda_inv_0_0_p487 = Lambda_inv_0_0_p463 * Lambda_inv_0_0_p486 - Lambda_inv_0_0_p460;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p488 = c6 * Lambda_inv_0_0_p453 - s6 * Lambda_inv_0_0_p458;
  const Real Lambda_inv_0_0_p489 = 0.069699984375 +
      (Lambda_inv_0_0_p473 - Lambda_inv_0_0_p446 + 0.072 * Lambda_inv_0_0_p488);

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p490 = Lambda_inv_0_0_p489 * inverse_D5;
  const Real Lambda_inv_0_0_p491 = Lambda_inv_0_0_p428 - Lambda_inv_0_0_p448 - Lambda_inv_0_0_p472 *
      Lambda_inv_0_0_p490;
  const Real Lambda_inv_0_0_p492 = Lambda_inv_0_0_p471 - Lambda_inv_0_0_p472 * Lambda_inv_0_0_p486;

  // link 6 (chest3), articulated inertia
  const Real Lambda_inv_0_0_p493 = c6 * Lambda_inv_0_0_p467 - Lambda_inv_0_0_p466;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p494 = Lambda_inv_0_0_p463 * Lambda_inv_0_0_p490 - 0.072 *
      Lambda_inv_0_0_p493;
  const Real Lambda_inv_0_0_p495 = s5 * (Lambda_inv_0_0_p487 - Lambda_inv_0_0_p491) + c5 *
      (Lambda_inv_0_0_p492 + Lambda_inv_0_0_p494);
  const Real Lambda_inv_0_0_p496 = c5 * Lambda_inv_0_0_p495;
  const Real Lambda_inv_0_0_p497 = Lambda_inv_0_0_p496 - Lambda_inv_0_0_p494;
  const Real inverse_D4_p1 = s5 * Lambda_inv_0_0_p483;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (Lambda_inv_0_0_p480 + inverse_D4_p1));
  const Real Lambda_inv_0_0_p498 = Lambda_inv_0_0_p497 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p499 = s5 * Lambda_inv_0_0_p495;
  const Real Lambda_inv_0_0_p500 = Lambda_inv_0_0_p493 - Lambda_inv_0_0_p489 * Lambda_inv_0_0_p462;
  const Real Lambda_inv_0_0_p501 = Lambda_inv_0_0_p459 - Lambda_inv_0_0_p485 * Lambda_inv_0_0_p462;
  const Real Lambda_inv_0_0_p502 = s5 * Lambda_inv_0_0_p500 - c5 * Lambda_inv_0_0_p501;
  const Real Lambda_inv_0_0_p503 = 0.21799999999999997 * Lambda_inv_0_0_p502;
  const Real Lambda_inv_0_0_p504 = Lambda_inv_0_0_p487 - Lambda_inv_0_0_p499 + Lambda_inv_0_0_p503;
  const Real Lambda_inv_0_0_p505 = 0.21799999999999997 * Lambda_inv_0_0_p497;
  const Real Lambda_inv_0_0_p506 = 0.0300000063 + Lambda_inv_0_0_p476;

  // link 4 (chest1), articulated inertia
  const Real Lambda_inv_0_0_p507 = Lambda_inv_0_0_p506 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p508 = Lambda_inv_0_0_p464 - Lambda_inv_0_0_p468 - Lambda_inv_0_0_p489 *
      Lambda_inv_0_0_p490;
  const Real Lambda_inv_0_0_p509 = inverse_D5_p12 - Lambda_inv_0_0_p485 * Lambda_inv_0_0_p486;
  const Real Lambda_inv_0_0_p510 = Lambda_inv_0_0_p488 - Lambda_inv_0_0_p485 * Lambda_inv_0_0_p490;
  const Real Lambda_inv_0_0_p511 = s5 * (Lambda_inv_0_0_p509 - Lambda_inv_0_0_p508) +
      Lambda_inv_0_0_p482 * Lambda_inv_0_0_p510;
  const Real Lambda_inv_0_0_p512 = s5 * Lambda_inv_0_0_p511;
  const Real Lambda_inv_0_0_p513 = Lambda_inv_0_0_p509 - Lambda_inv_0_0_p512;
  const Real Lambda_inv_0_0_p514 = s5 * Lambda_inv_0_0_p475 - c5 * Lambda_inv_0_0_p470;
  const Real Lambda_inv_0_0_p515 = Lambda_inv_0_0_p469 - Lambda_inv_0_0_p461 * Lambda_inv_0_0_p462;
  const Real Lambda_inv_0_0_p516 = Lambda_inv_0_0_p514 + 0.21799999999999997 * Lambda_inv_0_0_p515;

  // link 4 (chest1), articulated inertia
  const Real Lambda_inv_0_0_p517 = Lambda_inv_0_0_p484 * Lambda_inv_0_0_p507 - Lambda_inv_0_0_p516;
  const Real Lambda_inv_0_0_p518 = s4 * (Lambda_inv_0_0_p504 + Lambda_inv_0_0_p484 *
      Lambda_inv_0_0_p498 + (Lambda_inv_0_0_p503 + Lambda_inv_0_0_p505 * Lambda_inv_0_0_p507)) +
      c4 * (0.21799999999999997 * Lambda_inv_0_0_p513 - Lambda_inv_0_0_p505 * Lambda_inv_0_0_p498 +
      Lambda_inv_0_0_p517);
  const Real Lambda_inv_0_0_p519 = 8.419374554 + (c4 * Lambda_inv_0_0_p518 - Lambda_inv_0_0_p517);
  const Real inverse_D3_p1 = Lambda_inv_0_0_p484 * inverse_D4;
  const Real inverse_D3_p2 = Lambda_inv_0_0_p505 * inverse_D4;
  const Real inverse_D3_p3 = 0.01227760324629517 + 0.04752399999999999 * Lambda_inv_0_0_p513 -
      Lambda_inv_0_0_p505 * inverse_D3_p2;
  const Real inverse_D3_p4 = 0.0478915 + (Lambda_inv_0_0_p478 - inverse_D4_p1 +
      0.21799999999999997 * (Lambda_inv_0_0_p514 + Lambda_inv_0_0_p516)) - Lambda_inv_0_0_p484 *
      inverse_D3_p1 - inverse_D3_p3;
  const Real inverse_D3_p5 = 2.0 * c4;
  const Real inverse_D3_p6 = inverse_D3_p3 + s4 * (s4 * inverse_D3_p4 + inverse_D3_p5 *
      (0.21799999999999997 * Lambda_inv_0_0_p504 + Lambda_inv_0_0_p484 * inverse_D3_p2));

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p6);
  const Real Lambda_inv_0_0_p520 = Lambda_inv_0_0_p519 * inverse_D3;

  // link 4 (chest1), articulated inertia
  const Real Lambda_inv_0_0_p521 = Lambda_inv_0_0_p513 - Lambda_inv_0_0_p497 * Lambda_inv_0_0_p498;
  const Real Lambda_inv_0_0_p522 = s4 * (Lambda_inv_0_0_p521 -
      (Lambda_inv_0_0_p515 - Lambda_inv_0_0_p506 * Lambda_inv_0_0_p507)) - inverse_D3_p5 *
      (Lambda_inv_0_0_p502 + Lambda_inv_0_0_p497 * Lambda_inv_0_0_p507);

  // link 3 (hip), articulated inertia
  const Real Lambda_inv_0_0_p523 = Lambda_inv_0_0_p521 - s4 * Lambda_inv_0_0_p522 -
      Lambda_inv_0_0_p519 * Lambda_inv_0_0_p520;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p524 = Lambda_inv_0_0_p491 + Lambda_inv_0_0_p499;

  // link 4 (chest1), articulated inertia
  const Real Lambda_inv_0_0_p525 = Lambda_inv_0_0_p524 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real Lambda_inv_0_0_p526 = s5 * Lambda_inv_0_0_p501 + c5 * Lambda_inv_0_0_p500;
  const Real Lambda_inv_0_0_p527 = c5 * Lambda_inv_0_0_p511 - Lambda_inv_0_0_p510;

  // link 4 (chest1), articulated inertia
  const Real Lambda_inv_0_0_p528 = s4 * (0.21799999999999997 * Lambda_inv_0_0_p526 -
      (Lambda_inv_0_0_p496 - Lambda_inv_0_0_p492) - Lambda_inv_0_0_p484 * Lambda_inv_0_0_p525) +
      c4 * (0.0300000063 - 0.21799999999999997 * Lambda_inv_0_0_p527 + Lambda_inv_0_0_p505 *
      Lambda_inv_0_0_p525);
  const Real Lambda_inv_0_0_p529 = 0.02999999505 + Lambda_inv_0_0_p528;

  // link 3 (hip), articulated inertia
  const Real Lambda_inv_0_0_p530 = Lambda_inv_0_0_p529 * inverse_D3;
  const Real Lambda_inv_0_0_p531 = Lambda_inv_0_0_p508 + Lambda_inv_0_0_p512 - Lambda_inv_0_0_p524 *
      Lambda_inv_0_0_p525 - Lambda_inv_0_0_p529 * Lambda_inv_0_0_p530;
  const Real Lambda_inv_0_0_p532 = Lambda_inv_0_0_p519 * Lambda_inv_0_0_p530 -
      (c4 * (Lambda_inv_0_0_p497 * Lambda_inv_0_0_p525 - Lambda_inv_0_0_p527) - s4 *
      (Lambda_inv_0_0_p506 * Lambda_inv_0_0_p525 - Lambda_inv_0_0_p526));
  const Real Lambda_inv_0_0_p533 = s3 * (Lambda_inv_0_0_p523 - Lambda_inv_0_0_p531) + c3 *
      (2.0 * Lambda_inv_0_0_p532);
  const Real Lambda_inv_0_0_p534 = s3 * Lambda_inv_0_0_p533;
  const Real Lambda_inv_0_0_p535 = Lambda_inv_0_0_p523 - Lambda_inv_0_0_p534;
  const Real Lambda_inv_0_0_p536 = 24.5839218 + 0.422 * Lambda_inv_0_0_p535;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * Lambda_inv_0_0_p535);
  const Real Lambda_inv_0_0_p537 = Lambda_inv_0_0_p536 * inverse_D2;

  // link 15 (right_shoulder2), articulated inertia
  const Real Lambda_inv_0_7_p1 = 0.00010499999999999999 / inverse_D15_p9;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_7_p2 = s5 * s4;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_7_p3 = s6 * c4 - c6 * Lambda_inv_0_7_p2;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_7_p4 = c5 * s4;

  // link 14 (right_shoulder1), pose
  const Real Lambda_inv_0_7_p5 = c14 * Lambda_inv_0_7_p3 - s14 * Lambda_inv_0_7_p4;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_7_p6 = s6 * Lambda_inv_0_7_p2 + c6 * c4;

  // link 15 (right_shoulder2), pose
  const Real Lambda_inv_0_7_p7 = c15 * Lambda_inv_0_7_p5 + s15 * Lambda_inv_0_7_p6;
  const Real Lambda_inv_0_7_p8 = c15 * Lambda_inv_0_7_p6 - s15 * Lambda_inv_0_7_p5;

  // link 14 (right_shoulder1), pose
  const Real Lambda_inv_0_7_p9 = s14 * Lambda_inv_0_7_p3 + c14 * Lambda_inv_0_7_p4;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_7_p10 = s16 * Lambda_inv_0_7_p8 + c16 * Lambda_inv_0_7_p9;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_7_p11 = c17 * Lambda_inv_0_7_p7 - s17 * Lambda_inv_0_7_p10;
  const Real Lambda_inv_0_7_p12 = c17 * Lambda_inv_0_7_p10 + s17 * Lambda_inv_0_7_p7;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_7_p13 = c16 * Lambda_inv_0_7_p8 - s16 * Lambda_inv_0_7_p9;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_7_p14 = c18 * Lambda_inv_0_7_p12 + s18 * Lambda_inv_0_7_p13;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_7_p15 = c19 * Lambda_inv_0_7_p11 - s19 * Lambda_inv_0_7_p14;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_7_p16 = c18 * Lambda_inv_0_7_p13 - s18 * Lambda_inv_0_7_p12;

  // link 20 (right_hand), pose
  const Real Lambda_inv_0_7_p17 = c20 * Lambda_inv_0_7_p15 + s20 * Lambda_inv_0_7_p16;
  const Real Lambda_inv_0_7_p18 = c20 * Lambda_inv_0_7_p16 - s20 * Lambda_inv_0_7_p15;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p19 = Lambda_inv_0_7_p17 + 0.26249928123577654 * Lambda_inv_0_7_p18;
  const Real Lambda_inv_0_7_p20 = 0.49024375482668536 * Lambda_inv_0_7_p18;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_7_p21 = c19 * Lambda_inv_0_7_p14 + s19 * Lambda_inv_0_7_p11;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_7_p22 = -(0.086 * Lambda_inv_0_7_p21) + 0.004018575007348824 *
      Lambda_inv_0_7_p18;
  const Real Lambda_inv_0_7_p23 = 0.009919078854932248 * Lambda_inv_0_7_p18;
  const Real Lambda_inv_0_7_p24 = s20 * Lambda_inv_0_7_p23 + c20 * Lambda_inv_0_7_p22;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p25 = s20 * Lambda_inv_0_7_p19 - c20 * Lambda_inv_0_7_p20 -
      Lambda_inv_0_0_p192 * Lambda_inv_0_7_p24;
  const Real Lambda_inv_0_7_p26 = c20 * Lambda_inv_0_7_p23 - s20 * Lambda_inv_0_7_p22 -
      Lambda_inv_0_0_p186 * Lambda_inv_0_7_p24;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p27 = -(c19 * Lambda_inv_0_7_p26);
  const Real Lambda_inv_0_7_p28 = 0.269 * Lambda_inv_0_7_p25 - s19 * Lambda_inv_0_7_p26 -
      inverse_D17_p1 * Lambda_inv_0_7_p27;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_7_p29 = c20 * Lambda_inv_0_7_p19 + s20 * Lambda_inv_0_7_p20 -
      Lambda_inv_0_0_p206 * Lambda_inv_0_7_p24;
  const Real Lambda_inv_0_7_p30 = Lambda_inv_0_7_p21 - Lambda_inv_0_0_p209 * Lambda_inv_0_7_p24;
  const Real Lambda_inv_0_7_p31 = s19 * Lambda_inv_0_7_p29 - c19 * Lambda_inv_0_7_p30;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p32 = 0.269 * Lambda_inv_0_7_p31 - inverse_D17_p3 * Lambda_inv_0_7_p27;
  const Real Lambda_inv_0_7_p33 = s18 * Lambda_inv_0_7_p28 + c18 * Lambda_inv_0_7_p32;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p34 = c18 * Lambda_inv_0_7_p28 - s18 * Lambda_inv_0_7_p32 -
      Lambda_inv_0_0_p243 * Lambda_inv_0_7_p33;
  const Real Lambda_inv_0_7_p35 = Lambda_inv_0_0_p240 * Lambda_inv_0_7_p33;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_7_p36 = -Lambda_inv_0_7_p31 - Lambda_inv_0_0_p214 * Lambda_inv_0_7_p27;
  const Real Lambda_inv_0_7_p37 = Lambda_inv_0_7_p25 - Lambda_inv_0_0_p198 * Lambda_inv_0_7_p27;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p38 = s18 * Lambda_inv_0_7_p36 + c18 * Lambda_inv_0_7_p37 -
      Lambda_inv_0_0_p234 * Lambda_inv_0_7_p33;
  const Real Lambda_inv_0_7_p39 = c17 * Lambda_inv_0_7_p35 - s17 * Lambda_inv_0_7_p34;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p40 = c17 * Lambda_inv_0_7_p34 + s17 * Lambda_inv_0_7_p35 + 0.282 *
      Lambda_inv_0_7_p38 - inverse_D15_p1 * Lambda_inv_0_7_p39;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_7_p41 = c18 * Lambda_inv_0_7_p36 - s18 * Lambda_inv_0_7_p37 -
      Lambda_inv_0_0_p249 * Lambda_inv_0_7_p33;
  const Real Lambda_inv_0_7_p42 = -(-(s19 * Lambda_inv_0_7_p30 + c19 * Lambda_inv_0_7_p29) -
      Lambda_inv_0_0_p253 * Lambda_inv_0_7_p27) - Lambda_inv_0_0_p258 * Lambda_inv_0_7_p33;
  const Real Lambda_inv_0_7_p43 = s17 * Lambda_inv_0_7_p42 - c17 * Lambda_inv_0_7_p41;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p44 = 0.282 * Lambda_inv_0_7_p43 - inverse_D15_p3 * Lambda_inv_0_7_p39;
  const Real Lambda_inv_0_7_p45 = c16 * Lambda_inv_0_7_p40 - s16 * Lambda_inv_0_7_p44;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p46 = Lambda_inv_0_7_p1 * Lambda_inv_0_7_p45;
  const Real Lambda_inv_0_7_p47 = s16 * Lambda_inv_0_7_p40 + c16 * Lambda_inv_0_7_p44 -
      inverse_D14_p1 * Lambda_inv_0_7_p45;
  const Real Lambda_inv_0_7_p48 = s15 * Lambda_inv_0_7_p46 + c15 * Lambda_inv_0_7_p47;

  // link 2 (thigh), pose
  const Real Lambda_inv_0_6_p1 = c2 * c1 - s2 * s1;
  const Real Lambda_inv_0_6_p2 = s2 * c1 + c2 * s1;

  // link 3 (hip), pose
  const Real Lambda_inv_0_6_p3 = c3 * Lambda_inv_0_6_p1 - s3 * Lambda_inv_0_6_p2;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_6_p4 = c4 * Lambda_inv_0_6_p3;

  // link 3 (hip), pose
  const Real Lambda_inv_0_6_p5 = s3 * Lambda_inv_0_6_p1 + c3 * Lambda_inv_0_6_p2;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_6_p6 = s5 * Lambda_inv_0_6_p4 + c5 * Lambda_inv_0_6_p5;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_6_p7 = s4 * Lambda_inv_0_6_p3;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_6_p8 = c6 * Lambda_inv_0_6_p6 + s6 * Lambda_inv_0_6_p7;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_6_p9 = c5 * Lambda_inv_0_6_p4 - s5 * Lambda_inv_0_6_p5;

  // link 14 (right_shoulder1), pose
  const Real Lambda_inv_0_6_p10 = c14 * Lambda_inv_0_6_p8 + s14 * Lambda_inv_0_6_p9;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_6_p11 = s6 * Lambda_inv_0_6_p6 - c6 * Lambda_inv_0_6_p7;

  // link 15 (right_shoulder2), pose
  const Real Lambda_inv_0_6_p12 = s15 * Lambda_inv_0_6_p10 + c15 * Lambda_inv_0_6_p11;

  // link 14 (right_shoulder1), pose
  const Real Lambda_inv_0_6_p13 = c14 * Lambda_inv_0_6_p9 - s14 * Lambda_inv_0_6_p8;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_6_p14 = s16 * Lambda_inv_0_6_p12 + c16 * Lambda_inv_0_6_p13;

  // link 15 (right_shoulder2), pose
  const Real Lambda_inv_0_6_p15 = s15 * Lambda_inv_0_6_p11 - c15 * Lambda_inv_0_6_p10;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_6_p16 = c17 * Lambda_inv_0_6_p14 + s17 * Lambda_inv_0_6_p15;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_6_p17 = c16 * Lambda_inv_0_6_p12 - s16 * Lambda_inv_0_6_p13;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_6_p18 = c18 * Lambda_inv_0_6_p16 + s18 * Lambda_inv_0_6_p17;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_6_p19 = c17 * Lambda_inv_0_6_p15 - s17 * Lambda_inv_0_6_p14;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_6_p20 = c19 * Lambda_inv_0_6_p19 - s19 * Lambda_inv_0_6_p18;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_6_p21 = c18 * Lambda_inv_0_6_p17 - s18 * Lambda_inv_0_6_p16;

  // link 20 (right_hand), pose
  const Real Lambda_inv_0_6_p22 = c20 * Lambda_inv_0_6_p20 + s20 * Lambda_inv_0_6_p21;
  const Real Lambda_inv_0_6_p23 = c20 * Lambda_inv_0_6_p21 - s20 * Lambda_inv_0_6_p20;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p24 = Lambda_inv_0_6_p22 + 0.26249928123577654 * Lambda_inv_0_6_p23;
  const Real Lambda_inv_0_6_p25 = 0.49024375482668536 * Lambda_inv_0_6_p23;
  const Real Lambda_inv_0_6_p26 = 0.009919078854932248 * Lambda_inv_0_6_p23;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_6_p27 = c19 * Lambda_inv_0_6_p18 + s19 * Lambda_inv_0_6_p19;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_6_p28 = -(0.086 * Lambda_inv_0_6_p27) + 0.004018575007348824 *
      Lambda_inv_0_6_p23;
  const Real Lambda_inv_0_6_p29 = s20 * Lambda_inv_0_6_p26 + c20 * Lambda_inv_0_6_p28;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p30 = s20 * Lambda_inv_0_6_p24 - c20 * Lambda_inv_0_6_p25 -
      Lambda_inv_0_0_p192 * Lambda_inv_0_6_p29;
  const Real Lambda_inv_0_6_p31 = c20 * Lambda_inv_0_6_p26 - s20 * Lambda_inv_0_6_p28 -
      Lambda_inv_0_0_p186 * Lambda_inv_0_6_p29;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p32 = -(c19 * Lambda_inv_0_6_p31);
  const Real Lambda_inv_0_6_p33 = 0.269 * Lambda_inv_0_6_p30 - s19 * Lambda_inv_0_6_p31 -
      inverse_D17_p1 * Lambda_inv_0_6_p32;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_0_6_p34 = c20 * Lambda_inv_0_6_p24 + s20 * Lambda_inv_0_6_p25 -
      Lambda_inv_0_0_p206 * Lambda_inv_0_6_p29;
  const Real Lambda_inv_0_6_p35 = Lambda_inv_0_6_p27 - Lambda_inv_0_0_p209 * Lambda_inv_0_6_p29;
  const Real Lambda_inv_0_6_p36 = s19 * Lambda_inv_0_6_p34 - c19 * Lambda_inv_0_6_p35;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p37 = 0.269 * Lambda_inv_0_6_p36 - inverse_D17_p3 * Lambda_inv_0_6_p32;
  const Real Lambda_inv_0_6_p38 = s18 * Lambda_inv_0_6_p33 + c18 * Lambda_inv_0_6_p37;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p39 = c18 * Lambda_inv_0_6_p33 - s18 * Lambda_inv_0_6_p37 -
      Lambda_inv_0_0_p243 * Lambda_inv_0_6_p38;
  const Real Lambda_inv_0_6_p40 = Lambda_inv_0_0_p240 * Lambda_inv_0_6_p38;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_6_p41 = -Lambda_inv_0_6_p36 - Lambda_inv_0_0_p214 * Lambda_inv_0_6_p32;
  const Real Lambda_inv_0_6_p42 = Lambda_inv_0_6_p30 - Lambda_inv_0_0_p198 * Lambda_inv_0_6_p32;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p43 = s18 * Lambda_inv_0_6_p41 + c18 * Lambda_inv_0_6_p42 -
      Lambda_inv_0_0_p234 * Lambda_inv_0_6_p38;
  const Real Lambda_inv_0_6_p44 = c17 * Lambda_inv_0_6_p40 - s17 * Lambda_inv_0_6_p39;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p45 = c17 * Lambda_inv_0_6_p39 + s17 * Lambda_inv_0_6_p40 + 0.282 *
      Lambda_inv_0_6_p43 - inverse_D15_p1 * Lambda_inv_0_6_p44;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_0_6_p46 = c18 * Lambda_inv_0_6_p41 - s18 * Lambda_inv_0_6_p42 -
      Lambda_inv_0_0_p249 * Lambda_inv_0_6_p38;
  const Real Lambda_inv_0_6_p47 = -(-(s19 * Lambda_inv_0_6_p35 + c19 * Lambda_inv_0_6_p34) -
      Lambda_inv_0_0_p253 * Lambda_inv_0_6_p32) - Lambda_inv_0_0_p258 * Lambda_inv_0_6_p38;
  const Real Lambda_inv_0_6_p48 = s17 * Lambda_inv_0_6_p47 - c17 * Lambda_inv_0_6_p46;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_6_p49 = 0.282 * Lambda_inv_0_6_p48 - inverse_D15_p3 * Lambda_inv_0_6_p44;
  const Real Lambda_inv_0_6_p50 = c16 * Lambda_inv_0_6_p45 - s16 * Lambda_inv_0_6_p49;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_6_p51 = s16 * Lambda_inv_0_6_p45 + c16 * Lambda_inv_0_6_p49 -
      inverse_D14_p1 * Lambda_inv_0_6_p50;
  const Real Lambda_inv_0_6_p52 = Lambda_inv_0_7_p1 * Lambda_inv_0_6_p50;
  const Real Lambda_inv_0_6_p53 = s15 * Lambda_inv_0_6_p52 + c15 * Lambda_inv_0_6_p51;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_5_p1 = c4 * Lambda_inv_0_6_p5;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_5_p2 = s5 * Lambda_inv_0_5_p1 - c5 * Lambda_inv_0_6_p3;

  // link 4 (chest1), pose
  const Real Lambda_inv_0_5_p3 = s4 * Lambda_inv_0_6_p5;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_5_p4 = c6 * Lambda_inv_0_5_p2 + s6 * Lambda_inv_0_5_p3;

  // link 5 (chest2), pose
  const Real Lambda_inv_0_5_p5 = c5 * Lambda_inv_0_5_p1 + s5 * Lambda_inv_0_6_p3;

  // link 7 (left_shoulder1), pose
  const Real Lambda_inv_0_5_p6 = s7 * Lambda_inv_0_5_p4 - c7 * Lambda_inv_0_5_p5;
  const Real Lambda_inv_0_5_p7 = c7 * Lambda_inv_0_5_p4 + s7 * Lambda_inv_0_5_p5;

  // link 6 (chest3), pose
  const Real Lambda_inv_0_5_p8 = s6 * Lambda_inv_0_5_p2 - c6 * Lambda_inv_0_5_p3;

  // link 8 (left_shoulder2), pose
  const Real Lambda_inv_0_5_p9 = s8 * Lambda_inv_0_5_p7 + c8 * Lambda_inv_0_5_p8;

  // link 9 (left_upperarm), pose
  const Real Lambda_inv_0_5_p10 = c9 * Lambda_inv_0_5_p6 - s9 * Lambda_inv_0_5_p9;

  // link 8 (left_shoulder2), pose
  const Real Lambda_inv_0_5_p11 = c8 * Lambda_inv_0_5_p7 - s8 * Lambda_inv_0_5_p8;

  // link 10 (left_lowerarm), pose
  const Real Lambda_inv_0_5_p12 = c10 * Lambda_inv_0_5_p10 + s10 * Lambda_inv_0_5_p11;

  // link 9 (left_upperarm), pose
  const Real Lambda_inv_0_5_p13 = c9 * Lambda_inv_0_5_p9 + s9 * Lambda_inv_0_5_p6;

  // link 11 (left_wrist1), pose
  const Real Lambda_inv_0_5_p14 = c11 * Lambda_inv_0_5_p12 - s11 * Lambda_inv_0_5_p13;

  // link 7 (left_shoulder1), pose
  const Real Lambda_inv_0_4_p1 = c7 * Lambda_inv_0_7_p3 - s7 * Lambda_inv_0_7_p4;

  // link 8 (left_shoulder2), pose
  const Real Lambda_inv_0_4_p2 = c8 * Lambda_inv_0_7_p6 - s8 * Lambda_inv_0_4_p1;

  // link 7 (left_shoulder1), pose
  const Real Lambda_inv_0_4_p3 = s7 * Lambda_inv_0_7_p3 + c7 * Lambda_inv_0_7_p4;

  // link 9 (left_upperarm), pose
  const Real Lambda_inv_0_4_p4 = s9 * Lambda_inv_0_4_p2 + c9 * Lambda_inv_0_4_p3;

  // link 7 (left_shoulder1), pose
  const Real Lambda_inv_0_3_p1 = c7 * Lambda_inv_0_6_p8 + s7 * Lambda_inv_0_6_p9;

  // link 8 (left_shoulder2), pose
  const Real Lambda_inv_0_3_p2 = s8 * Lambda_inv_0_3_p1 + c8 * Lambda_inv_0_6_p11;

  // link 7 (left_shoulder1), pose
  const Real Lambda_inv_0_3_p3 = c7 * Lambda_inv_0_6_p9 - s7 * Lambda_inv_0_6_p8;

  // link 9 (left_upperarm), pose
  const Real Lambda_inv_0_3_p4 = s9 * Lambda_inv_0_3_p2 + c9 * Lambda_inv_0_3_p3;

  // link 10 (left_lowerarm), pose
  const Lanes Lambda_inv_0_3_p5_lanes = s10 * detail::make_lanes<Real>(Lambda_inv_0_3_p4,
      Lambda_inv_0_4_p4, Lambda_inv_0_5_p10, Lambda_inv_0_3_p4, Lambda_inv_0_3_p4,
      Lambda_inv_0_3_p4, Lambda_inv_0_3_p4, Lambda_inv_0_3_p4);

  // link 8 (left_shoulder2), pose
  const Real Lambda_inv_0_4_p6 = c8 * Lambda_inv_0_4_p1 + s8 * Lambda_inv_0_7_p6;
  const Real Lambda_inv_0_3_p6 = s8 * Lambda_inv_0_6_p11 - c8 * Lambda_inv_0_3_p1;

  // link 10 (left_lowerarm), pose
  const Lanes Lambda_inv_0_3_p7_lanes = c10 * detail::make_lanes<Real>(Lambda_inv_0_3_p6,
      Lambda_inv_0_4_p6, Lambda_inv_0_5_p11, Lambda_inv_0_3_p6, Lambda_inv_0_3_p6,
      Lambda_inv_0_3_p6, Lambda_inv_0_3_p6, Lambda_inv_0_3_p6);
  const Lanes Lambda_inv_0_3_p8_lanes = Lambda_inv_0_3_p7_lanes - Lambda_inv_0_3_p5_lanes;

  // link 12 (left_wrist2), pose
  const Real Lambda_inv_0_5_p18 = c12 * Lambda_inv_0_3_p8_lanes[2] - s12 * Lambda_inv_0_5_p14;

  // link 11 (left_wrist1), pose
  const Real Lambda_inv_0_5_p19 = s11 * Lambda_inv_0_5_p12 + c11 * Lambda_inv_0_5_p13;

  // link 13 (left_hand), pose
  const Real Lambda_inv_0_5_p20 = c13 * Lambda_inv_0_5_p18 - s13 * Lambda_inv_0_5_p19;

  // link 10 (left_lowerarm), pose
  const Real Lambda_inv_0_4_p9 = c10 * Lambda_inv_0_4_p4 + s10 * Lambda_inv_0_4_p6;

  // link 9 (left_upperarm), pose
  const Real Lambda_inv_0_4_p10 = c9 * Lambda_inv_0_4_p2 - s9 * Lambda_inv_0_4_p3;

  // link 11 (left_wrist1), pose
  const Real Lambda_inv_0_4_p11 = c11 * Lambda_inv_0_4_p9 + s11 * Lambda_inv_0_4_p10;

  // link 10 (left_lowerarm), pose
  const Real Lambda_inv_0_3_p9 = c10 * Lambda_inv_0_3_p4 + s10 * Lambda_inv_0_3_p6;

  // link 9 (left_upperarm), pose
  const Real Lambda_inv_0_3_p10 = c9 * Lambda_inv_0_3_p2 - s9 * Lambda_inv_0_3_p3;

  // link 11 (left_wrist1), pose
  const Real Lambda_inv_0_3_p11 = c11 * Lambda_inv_0_3_p9 + s11 * Lambda_inv_0_3_p10;

  // link 12 (left_wrist2), pose
  const Lanes Lambda_inv_0_3_p12_lanes = c12 * detail::make_lanes<Real>(Lambda_inv_0_3_p11,
      Lambda_inv_0_4_p11, Lambda_inv_0_5_p14, Lambda_inv_0_3_p11, Lambda_inv_0_3_p11,
      Lambda_inv_0_3_p11, Lambda_inv_0_3_p11, Lambda_inv_0_3_p11);
  const Lanes Lambda_inv_0_3_p13_lanes = s12 * Lambda_inv_0_3_p8_lanes;
  const Lanes Lambda_inv_0_3_p14_lanes = Lambda_inv_0_3_p12_lanes + Lambda_inv_0_3_p13_lanes;

  // link 13 (left_hand), force propagation
  const Lanes Lambda_inv_0_3_p15_lanes = 0.11533812622014242 *
      detail::make_lanes<Real>(Lambda_inv_0_3_p14_lanes[0], Lambda_inv_0_3_p14_lanes[0],
      Lambda_inv_0_3_p14_lanes[0], Lambda_inv_0_3_p14_lanes[0], Lambda_inv_0_3_p14_lanes[1],
      Lambda_inv_0_3_p14_lanes[2], Lambda_inv_0_3_p14_lanes[0], Lambda_inv_0_3_p14_lanes[0]);

  // link 12 (left_wrist2), pose
  const Real Lambda_inv_0_4_p16 = c12 * Lambda_inv_0_3_p8_lanes[1] - s12 * Lambda_inv_0_4_p11;

  // link 11 (left_wrist1), pose
  const Real Lambda_inv_0_4_p17 = c11 * Lambda_inv_0_4_p10 - s11 * Lambda_inv_0_4_p9;

  // link 13 (left_hand), pose
  const Real Lambda_inv_0_4_p18 = c13 * Lambda_inv_0_4_p16 + s13 * Lambda_inv_0_4_p17;

  // link 12 (left_wrist2), pose
  const Real Lambda_inv_0_3_p16 = c12 * Lambda_inv_0_3_p8_lanes[0] - s12 * Lambda_inv_0_3_p11;

  // link 11 (left_wrist1), pose
  const Real Lambda_inv_0_3_p17 = c11 * Lambda_inv_0_3_p10 - s11 * Lambda_inv_0_3_p9;

  // link 13 (left_hand), pose
  const Real Lambda_inv_0_3_p18 = c13 * Lambda_inv_0_3_p16 + s13 * Lambda_inv_0_3_p17;

  // link 13 (left_hand), force propagation
  const Lanes Lambda_inv_0_3_p19_lanes = detail::make_lanes<Real>(Lambda_inv_0_3_p18,
      Lambda_inv_0_3_p18, Lambda_inv_0_3_p18, Lambda_inv_0_3_p18, Lambda_inv_0_4_p18,
      Lambda_inv_0_5_p20, Lambda_inv_0_3_p18, Lambda_inv_0_3_p18) + Lambda_inv_0_3_p15_lanes;

  // link 13 (left_hand), pose
  const Real Lambda_inv_0_2_p1 = s13 * Lambda_inv_0_5_p18 + c13 * Lambda_inv_0_5_p19;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_0_2_p2 = -(0.086 * Lambda_inv_0_2_p1);
  const Real Lambda_inv_0_2_p3 = 0.11533812622014242 * Lambda_inv_0_2_p2;

  // link 13 (left_hand), pose
  const Real Lambda_inv_0_1_p1 = c13 * Lambda_inv_0_4_p17 - s13 * Lambda_inv_0_4_p16;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_0_1_p2 = 0.009919078854932248 * Lambda_inv_0_1_p1;

  // link 13 (left_hand), pose
  const Real Lambda_inv_0_0_p538 = c13 * Lambda_inv_0_3_p17 - s13 * Lambda_inv_0_3_p16;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_0_0_p539 = 0.009919078854932248 * Lambda_inv_0_0_p538;
  const Lanes Lambda_inv_0_0_p540_lanes = c13 * detail::make_lanes<Real>(Lambda_inv_0_0_p539,
      Lambda_inv_0_1_p2, Lambda_inv_0_2_p3, Lambda_inv_0_3_p19_lanes[3],
      Lambda_inv_0_3_p19_lanes[4], Lambda_inv_0_3_p19_lanes[5], Lambda_inv_0_0_p539,
      Lambda_inv_0_0_p539);
  const Real Lambda_inv_0_5_p27 = -Lambda_inv_0_2_p1;
  const Lanes Lambda_inv_0_0_p541_lanes = detail::make_lanes<Real>(0.004018575007348824,
      0.004018575007348824, 0.04672761636452121, 0.04672761636452121, 0.04672761636452121,
      0.04672761636452121, 0.004018575007348824, 0.004018575007348824) *
      detail::make_lanes<Real>(Lambda_inv_0_0_p538, Lambda_inv_0_1_p1, Lambda_inv_0_2_p2,
      Lambda_inv_0_3_p14_lanes[0], Lambda_inv_0_3_p14_lanes[1], Lambda_inv_0_3_p14_lanes[2],
      Lambda_inv_0_0_p538, Lambda_inv_0_0_p538);
  const Lanes Lambda_inv_0_0_p542_lanes = detail::make_lanes<Real>(-(0.086 *
      Lambda_inv_0_3_p14_lanes[0]), -(0.086 * Lambda_inv_0_3_p14_lanes[1]),
      -(0.086 * Lambda_inv_0_3_p14_lanes[2]), Lambda_inv_0_0_p538, Lambda_inv_0_1_p1,
      Lambda_inv_0_5_p27, -(0.086 * Lambda_inv_0_3_p14_lanes[0]),
      -(0.086 * Lambda_inv_0_3_p14_lanes[0])) - Lambda_inv_0_0_p541_lanes;
  const Lanes Lambda_inv_0_0_p543_lanes = s13 * Lambda_inv_0_0_p542_lanes;
  const Lanes Lambda_inv_0_0_p544_lanes = Lambda_inv_0_0_p540_lanes - Lambda_inv_0_0_p543_lanes;
  const Lanes Lambda_inv_0_0_p545_lanes = s13 * detail::make_lanes<Real>(Lambda_inv_0_0_p539,
      Lambda_inv_0_1_p2, Lambda_inv_0_2_p3, Lambda_inv_0_3_p19_lanes[3],
      Lambda_inv_0_3_p19_lanes[4], Lambda_inv_0_3_p19_lanes[5], Lambda_inv_0_0_p539,
      Lambda_inv_0_0_p539);
  const Lanes Lambda_inv_0_0_p546_lanes = c13 * Lambda_inv_0_0_p542_lanes;
  const Lanes Lambda_inv_0_0_p547_lanes = Lambda_inv_0_0_p545_lanes + Lambda_inv_0_0_p546_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_0_0_p548_lanes = Lambda_inv_0_0_p3 * Lambda_inv_0_0_p547_lanes;
  const Lanes Lambda_inv_0_0_p549_lanes = Lambda_inv_0_0_p544_lanes - Lambda_inv_0_0_p548_lanes;
  const Lanes Lambda_inv_0_0_p550_lanes = s12 * Lambda_inv_0_0_p549_lanes;
  const Lanes Lambda_inv_0_0_p551_lanes = Lambda_inv_0_0_p9 * Lambda_inv_0_0_p547_lanes;

  // link 13 (left_hand), force propagation
  const Real Lambda_inv_0_5_p39 = 3.0523172236718206 * Lambda_inv_0_3_p14_lanes[2];
  const Real Lambda_inv_0_5_p40 = 17.32841575379867 * Lambda_inv_0_3_p14_lanes[2];
  const Real Lambda_inv_0_4_p32 = 3.0523172236718206 * Lambda_inv_0_3_p14_lanes[1];
  const Real Lambda_inv_0_4_p33 = 17.32841575379867 * Lambda_inv_0_3_p14_lanes[1];
  const Real Lambda_inv_0_3_p32 = 3.0523172236718206 * Lambda_inv_0_3_p14_lanes[0];
  const Real Lambda_inv_0_3_p33 = 17.32841575379867 * Lambda_inv_0_3_p14_lanes[0];
  const Real Lambda_inv_0_2_p16 = Lambda_inv_0_5_p20 - 3.0523172236718206 * Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_2_p17 = Lambda_inv_0_5_p27 - 17.32841575379867 * Lambda_inv_0_2_p2;
  const Real Lambda_inv_0_1_p15 = Lambda_inv_0_4_p18 - 0.26249928123577654 * Lambda_inv_0_1_p1;
  const Real Lambda_inv_0_1_p16 = 0.49024375482668536 * Lambda_inv_0_1_p1;
  const Real Lambda_inv_0_0_p552 = Lambda_inv_0_3_p18 - 0.26249928123577654 * Lambda_inv_0_0_p538;
  const Real Lambda_inv_0_0_p553 = 0.49024375482668536 * Lambda_inv_0_0_p538;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_0_0_p554_lanes = detail::make_lanes<Real>(s13 * Lambda_inv_0_0_p552 - c13 *
      Lambda_inv_0_0_p553, s13 * Lambda_inv_0_1_p15 - c13 * Lambda_inv_0_1_p16, s13 *
      Lambda_inv_0_2_p16 + c13 * Lambda_inv_0_2_p17, -(s13 * Lambda_inv_0_3_p32 + c13 *
      Lambda_inv_0_3_p33), -(s13 * Lambda_inv_0_4_p32 + c13 * Lambda_inv_0_4_p33),
      -(s13 * Lambda_inv_0_5_p39 + c13 * Lambda_inv_0_5_p40), s13 * Lambda_inv_0_0_p552 - c13 *
      Lambda_inv_0_0_p553, s13 * Lambda_inv_0_0_p552 - c13 * Lambda_inv_0_0_p553) -
      Lambda_inv_0_0_p551_lanes;
  const Lanes Lambda_inv_0_0_p555_lanes = 0.269 * Lambda_inv_0_0_p554_lanes;
  const Lanes Lambda_inv_0_0_p556_lanes = Lambda_inv_0_0_p555_lanes - Lambda_inv_0_0_p550_lanes;

  // link 11 (left_wrist1), force propagation
  const Real Lambda_inv_0_5_p44 = -(c12 * Lambda_inv_0_0_p549_lanes[5]);
  const Real Lambda_inv_0_4_p37 = -(c12 * Lambda_inv_0_0_p549_lanes[4]);
  const Real Lambda_inv_0_3_p37 = -(c12 * Lambda_inv_0_0_p549_lanes[3]);
  const Real Lambda_inv_0_2_p21 = -(c12 * Lambda_inv_0_0_p549_lanes[2]);
  const Real Lambda_inv_0_1_p20 = -(c12 * Lambda_inv_0_0_p549_lanes[1]);
  const Real Lambda_inv_0_0_p557 = -(c12 * Lambda_inv_0_0_p549_lanes[0]);
  const Lanes Lambda_inv_0_0_p558_lanes = Lambda_inv_0_0_p14 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p557, Lambda_inv_0_1_p20, Lambda_inv_0_2_p21,
      Lambda_inv_0_3_p37, Lambda_inv_0_4_p37, Lambda_inv_0_5_p44, Lambda_inv_0_0_p557,
      Lambda_inv_0_0_p557);
  const Lanes Lambda_inv_0_0_p559_lanes = Lambda_inv_0_0_p556_lanes - Lambda_inv_0_0_p558_lanes;
  const Lanes Lambda_inv_0_0_p560_lanes = c11 * Lambda_inv_0_0_p559_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_0_0_p561_lanes = Lambda_inv_0_0_p22 * Lambda_inv_0_0_p547_lanes;

  // link 13 (left_hand), force propagation
  const Lanes Lambda_inv_0_2_p26_lanes = detail::make_lanes<Real>(c13, c13, c13, s13, s13, s13, c13,
      c13) * detail::make_lanes<Real>(Lambda_inv_0_2_p16, Lambda_inv_0_2_p16, Lambda_inv_0_2_p16,
      Lambda_inv_0_3_p33, Lambda_inv_0_4_p33, Lambda_inv_0_5_p40, Lambda_inv_0_2_p16,
      Lambda_inv_0_2_p16);
  const Lanes Lambda_inv_0_2_p27_lanes = detail::make_lanes<Real>(s13, s13, s13, c13, c13, c13, s13,
      s13) * detail::make_lanes<Real>(Lambda_inv_0_2_p17, Lambda_inv_0_2_p17, Lambda_inv_0_2_p17,
      Lambda_inv_0_3_p32, Lambda_inv_0_4_p32, Lambda_inv_0_5_p39, Lambda_inv_0_2_p17,
      Lambda_inv_0_2_p17);
  const Lanes Lambda_inv_0_2_p28_lanes = Lambda_inv_0_2_p26_lanes - Lambda_inv_0_2_p27_lanes;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_0_0_p562_lanes = detail::make_lanes<Real>(c13 * Lambda_inv_0_0_p552 + s13 *
      Lambda_inv_0_0_p553, c13 * Lambda_inv_0_1_p15 + s13 * Lambda_inv_0_1_p16,
      Lambda_inv_0_2_p28_lanes[2], Lambda_inv_0_2_p28_lanes[3], Lambda_inv_0_2_p28_lanes[4],
      Lambda_inv_0_2_p28_lanes[5], c13 * Lambda_inv_0_0_p552 + s13 * Lambda_inv_0_0_p553, c13 *
      Lambda_inv_0_0_p552 + s13 * Lambda_inv_0_0_p553) - Lambda_inv_0_0_p561_lanes;
  const Lanes Lambda_inv_0_0_p563_lanes = s12 * Lambda_inv_0_0_p562_lanes;
  const Real Lambda_inv_0_5_p54 = Lambda_inv_0_0_p25 * Lambda_inv_0_0_p547_lanes[5];
  const Real Lambda_inv_0_4_p47 = Lambda_inv_0_0_p25 * Lambda_inv_0_0_p547_lanes[4];
  const Real Lambda_inv_0_3_p47 = Lambda_inv_0_0_p25 * Lambda_inv_0_0_p547_lanes[3];
  const Lanes Lambda_inv_0_0_p564_lanes = Lambda_inv_0_0_p25 * Lambda_inv_0_0_p547_lanes;
  const Lanes Lambda_inv_0_0_p565_lanes = Lambda_inv_0_3_p14_lanes + Lambda_inv_0_0_p564_lanes;
  const Lanes Lambda_inv_0_0_p566_lanes = c12 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p565_lanes[0], Lambda_inv_0_0_p565_lanes[1],
      Lambda_inv_0_0_p565_lanes[2], Lambda_inv_0_3_p47, Lambda_inv_0_4_p47, Lambda_inv_0_5_p54,
      Lambda_inv_0_0_p565_lanes[0], Lambda_inv_0_0_p565_lanes[0]);
  const Lanes Lambda_inv_0_0_p567_lanes = Lambda_inv_0_0_p563_lanes - Lambda_inv_0_0_p566_lanes;
  const Lanes Lambda_inv_0_0_p568_lanes = 0.269 * Lambda_inv_0_0_p567_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_0_0_p569_lanes = Lambda_inv_0_0_p30 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p557, Lambda_inv_0_1_p20, Lambda_inv_0_2_p21,
      Lambda_inv_0_3_p37, Lambda_inv_0_4_p37, Lambda_inv_0_5_p44, Lambda_inv_0_0_p557,
      Lambda_inv_0_0_p557);
  const Lanes Lambda_inv_0_0_p570_lanes = Lambda_inv_0_0_p568_lanes - Lambda_inv_0_0_p569_lanes;
  const Lanes Lambda_inv_0_0_p571_lanes = s11 * Lambda_inv_0_0_p570_lanes;
  const Lanes Lambda_inv_0_0_p572_lanes = Lambda_inv_0_0_p560_lanes - Lambda_inv_0_0_p571_lanes;
  const Lanes Lambda_inv_0_0_p573_lanes = s11 * Lambda_inv_0_0_p559_lanes;
  const Lanes Lambda_inv_0_0_p574_lanes = c11 * Lambda_inv_0_0_p570_lanes;
  const Lanes Lambda_inv_0_0_p575_lanes = Lambda_inv_0_0_p573_lanes + Lambda_inv_0_0_p574_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_0_0_p576_lanes = Lambda_inv_0_0_p48 * Lambda_inv_0_0_p575_lanes;
  const Lanes Lambda_inv_0_0_p577_lanes = Lambda_inv_0_0_p572_lanes - Lambda_inv_0_0_p576_lanes;
  const Lanes Lambda_inv_0_0_p578_lanes = c10 * Lambda_inv_0_0_p577_lanes;
  const Lanes Lambda_inv_0_0_p579_lanes = Lambda_inv_0_0_p51 * Lambda_inv_0_0_p575_lanes;
  const Lanes Lambda_inv_0_0_p580_lanes = s10 * Lambda_inv_0_0_p579_lanes;
  const Lanes Lambda_inv_0_0_p581_lanes = Lambda_inv_0_0_p580_lanes - Lambda_inv_0_0_p578_lanes;
  const Lanes Lambda_inv_0_0_p582_lanes = Lambda_inv_0_0_p66 * Lambda_inv_0_0_p575_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_0_0_p583_lanes = Lambda_inv_0_0_p56 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p557, Lambda_inv_0_1_p20, Lambda_inv_0_2_p21,
      Lambda_inv_0_3_p37, Lambda_inv_0_4_p37, Lambda_inv_0_5_p44, Lambda_inv_0_0_p557,
      Lambda_inv_0_0_p557);
  const Lanes Lambda_inv_0_0_p584_lanes = detail::make_lanes<Real>(-Lambda_inv_0_0_p567_lanes[0],
      -Lambda_inv_0_0_p567_lanes[1], -Lambda_inv_0_0_p567_lanes[2], -Lambda_inv_0_0_p567_lanes[3],
      -Lambda_inv_0_0_p567_lanes[4], -Lambda_inv_0_0_p567_lanes[5], -Lambda_inv_0_0_p567_lanes[0],
      -Lambda_inv_0_0_p567_lanes[0]) - Lambda_inv_0_0_p583_lanes;
  const Lanes Lambda_inv_0_0_p585_lanes = s11 * Lambda_inv_0_0_p584_lanes;
  const Lanes Lambda_inv_0_0_p586_lanes = Lambda_inv_0_0_p59 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p557, Lambda_inv_0_1_p20, Lambda_inv_0_2_p21,
      Lambda_inv_0_3_p37, Lambda_inv_0_4_p37, Lambda_inv_0_5_p44, Lambda_inv_0_0_p557,
      Lambda_inv_0_0_p557);
  const Lanes Lambda_inv_0_0_p587_lanes = Lambda_inv_0_0_p554_lanes - Lambda_inv_0_0_p586_lanes;
  const Lanes Lambda_inv_0_0_p588_lanes = c11 * Lambda_inv_0_0_p587_lanes;
  const Lanes Lambda_inv_0_0_p589_lanes = Lambda_inv_0_0_p585_lanes + Lambda_inv_0_0_p588_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_0_0_p590_lanes = Lambda_inv_0_0_p589_lanes - Lambda_inv_0_0_p582_lanes;
  const Lanes Lambda_inv_0_0_p591_lanes = 0.282 * Lambda_inv_0_0_p590_lanes;
  const Lanes Lambda_inv_0_0_p592_lanes = Lambda_inv_0_0_p591_lanes - Lambda_inv_0_0_p581_lanes;

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_0_5_p82 = -(s10 * Lambda_inv_0_0_p577_lanes[5] + c10 *
      Lambda_inv_0_0_p579_lanes[5]);
  const Real Lambda_inv_0_4_p75 = -(s10 * Lambda_inv_0_0_p577_lanes[4] + c10 *
      Lambda_inv_0_0_p579_lanes[4]);
  const Real Lambda_inv_0_3_p75 = -(s10 * Lambda_inv_0_0_p577_lanes[3] + c10 *
      Lambda_inv_0_0_p579_lanes[3]);
  const Real Lambda_inv_0_2_p60 = -(s10 * Lambda_inv_0_0_p577_lanes[2] + c10 *
      Lambda_inv_0_0_p579_lanes[2]);
  const Real Lambda_inv_0_1_p56 = -(s10 * Lambda_inv_0_0_p577_lanes[1] + c10 *
      Lambda_inv_0_0_p579_lanes[1]);
  const Real Lambda_inv_0_0_p593 = -(s10 * Lambda_inv_0_0_p577_lanes[0] + c10 *
      Lambda_inv_0_0_p579_lanes[0]);
  const Lanes Lambda_inv_0_0_p594_lanes = inverse_D8_p1 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p593, Lambda_inv_0_1_p56, Lambda_inv_0_2_p60,
      Lambda_inv_0_3_p75, Lambda_inv_0_4_p75, Lambda_inv_0_5_p82, Lambda_inv_0_0_p593,
      Lambda_inv_0_0_p593);
  const Lanes Lambda_inv_0_0_p595_lanes = Lambda_inv_0_0_p592_lanes + Lambda_inv_0_0_p594_lanes;
  const Lanes Lambda_inv_0_0_p596_lanes = s9 * Lambda_inv_0_0_p595_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_0_0_p597_lanes = Lambda_inv_0_0_p82 * Lambda_inv_0_0_p575_lanes;
  const Lanes Lambda_inv_0_0_p598_lanes = detail::make_lanes<Real>(-(-(s12 *
      Lambda_inv_0_0_p565_lanes[0] + c12 * Lambda_inv_0_0_p562_lanes[0]) - Lambda_inv_0_0_p77 *
      Lambda_inv_0_0_p557), -(-(s12 * Lambda_inv_0_0_p565_lanes[1] + c12 *
      Lambda_inv_0_0_p562_lanes[1]) - Lambda_inv_0_0_p77 * Lambda_inv_0_1_p20),
      -(-(s12 * Lambda_inv_0_0_p565_lanes[2] + c12 * Lambda_inv_0_0_p562_lanes[2]) -
      Lambda_inv_0_0_p77 * Lambda_inv_0_2_p21), -(-(s12 * Lambda_inv_0_3_p47 + c12 *
      Lambda_inv_0_0_p562_lanes[3]) - Lambda_inv_0_0_p77 * Lambda_inv_0_3_p37),
      -(-(s12 * Lambda_inv_0_4_p47 + c12 * Lambda_inv_0_0_p562_lanes[4]) - Lambda_inv_0_0_p77 *
      Lambda_inv_0_4_p37), -(-(s12 * Lambda_inv_0_5_p54 + c12 * Lambda_inv_0_0_p562_lanes[5]) -
      Lambda_inv_0_0_p77 * Lambda_inv_0_5_p44), -(-(s12 * Lambda_inv_0_0_p565_lanes[0] + c12 *
      Lambda_inv_0_0_p562_lanes[0]) - Lambda_inv_0_0_p77 * Lambda_inv_0_0_p557),
      -(-(s12 * Lambda_inv_0_0_p565_lanes[0] + c12 * Lambda_inv_0_0_p562_lanes[0]) -
      Lambda_inv_0_0_p77 * Lambda_inv_0_0_p557)) - Lambda_inv_0_0_p597_lanes;
  const Lanes Lambda_inv_0_0_p599_lanes = s10 * Lambda_inv_0_0_p598_lanes;
  const Lanes Lambda_inv_0_0_p600_lanes = Lambda_inv_0_0_p73 * Lambda_inv_0_0_p575_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_0_0_p601_lanes = c11 * Lambda_inv_0_0_p584_lanes;
  const Lanes Lambda_inv_0_0_p602_lanes = s11 * Lambda_inv_0_0_p587_lanes;
  const Lanes Lambda_inv_0_0_p603_lanes = Lambda_inv_0_0_p601_lanes - Lambda_inv_0_0_p602_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_0_0_p604_lanes = Lambda_inv_0_0_p603_lanes - Lambda_inv_0_0_p600_lanes;
  const Lanes Lambda_inv_0_0_p605_lanes = c10 * Lambda_inv_0_0_p604_lanes;
  const Lanes Lambda_inv_0_0_p606_lanes = Lambda_inv_0_0_p599_lanes - Lambda_inv_0_0_p605_lanes;
  const Lanes Lambda_inv_0_0_p607_lanes = 0.282 * Lambda_inv_0_0_p606_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_0_0_p608_lanes = inverse_D8_p3 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p593, Lambda_inv_0_1_p56, Lambda_inv_0_2_p60,
      Lambda_inv_0_3_p75, Lambda_inv_0_4_p75, Lambda_inv_0_5_p82, Lambda_inv_0_0_p593,
      Lambda_inv_0_0_p593);
  const Lanes Lambda_inv_0_0_p609_lanes = Lambda_inv_0_0_p607_lanes - Lambda_inv_0_0_p608_lanes;
  const Lanes Lambda_inv_0_0_p610_lanes = c9 * Lambda_inv_0_0_p609_lanes;
  const Lanes Lambda_inv_0_0_p611_lanes = Lambda_inv_0_0_p596_lanes + Lambda_inv_0_0_p610_lanes;
  const Lanes Lambda_inv_0_0_p612_lanes = c9 * Lambda_inv_0_0_p595_lanes;
  const Lanes Lambda_inv_0_0_p613_lanes = s9 * Lambda_inv_0_0_p609_lanes;
  const Lanes Lambda_inv_0_0_p614_lanes = Lambda_inv_0_0_p612_lanes - Lambda_inv_0_0_p613_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_0_0_p615_lanes = inverse_D7_p1 * Lambda_inv_0_0_p614_lanes;
  const Lanes Lambda_inv_0_0_p616_lanes = Lambda_inv_0_0_p611_lanes - Lambda_inv_0_0_p615_lanes;
  const Lanes Lambda_inv_0_0_p617_lanes = c8 * Lambda_inv_0_0_p616_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Real Lambda_inv_0_0_p618 = 0.00010499999999999999 / inverse_D8_p9;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_0_0_p619_lanes = Lambda_inv_0_0_p618 * Lambda_inv_0_0_p614_lanes;
  const Lanes Lambda_inv_0_0_p620_lanes = s8 * Lambda_inv_0_0_p619_lanes;
  const Lanes Lambda_inv_0_0_p621_lanes = Lambda_inv_0_0_p620_lanes + Lambda_inv_0_0_p617_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p622_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p129,
      Lambda_inv_0_0_p129, Lambda_inv_0_0_p129, Lambda_inv_0_0_p129, Lambda_inv_0_0_p129,
      Lambda_inv_0_0_p129, Lambda_inv_0_0_p305, Lambda_inv_0_0_p305) *
      detail::make_lanes<Real>(Lambda_inv_0_0_p621_lanes[0], Lambda_inv_0_0_p621_lanes[1],
      Lambda_inv_0_0_p621_lanes[2], Lambda_inv_0_0_p621_lanes[3], Lambda_inv_0_0_p621_lanes[4],
      Lambda_inv_0_0_p621_lanes[5], Lambda_inv_0_6_p53, Lambda_inv_0_7_p48);

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_0_7_p50 = -Lambda_inv_0_7_p43 - Lambda_inv_0_0_p266 * Lambda_inv_0_7_p39;
  const Real Lambda_inv_0_7_p51 = Lambda_inv_0_7_p38 - Lambda_inv_0_0_p281 * Lambda_inv_0_7_p39;
  const Real Lambda_inv_0_6_p55 = -Lambda_inv_0_6_p48 - Lambda_inv_0_0_p266 * Lambda_inv_0_6_p44;
  const Real Lambda_inv_0_6_p56 = Lambda_inv_0_6_p43 - Lambda_inv_0_0_p281 * Lambda_inv_0_6_p44;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_0_0_p623_lanes = Lambda_inv_0_0_p123 * Lambda_inv_0_0_p614_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_0_0_p624_lanes = Lambda_inv_0_0_p90 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p593, Lambda_inv_0_1_p56, Lambda_inv_0_2_p60,
      Lambda_inv_0_3_p75, Lambda_inv_0_4_p75, Lambda_inv_0_5_p82, Lambda_inv_0_0_p593,
      Lambda_inv_0_0_p593);
  const Lanes Lambda_inv_0_0_p625_lanes = detail::make_lanes<Real>(-Lambda_inv_0_0_p606_lanes[0],
      -Lambda_inv_0_0_p606_lanes[1], -Lambda_inv_0_0_p606_lanes[2], -Lambda_inv_0_0_p606_lanes[3],
      -Lambda_inv_0_0_p606_lanes[4], -Lambda_inv_0_0_p606_lanes[5], -Lambda_inv_0_0_p606_lanes[0],
      -Lambda_inv_0_0_p606_lanes[0]) + Lambda_inv_0_0_p624_lanes;
  const Lanes Lambda_inv_0_0_p626_lanes = c9 * Lambda_inv_0_0_p625_lanes;
  const Lanes Lambda_inv_0_0_p627_lanes = Lambda_inv_0_0_p105 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p593, Lambda_inv_0_1_p56, Lambda_inv_0_2_p60,
      Lambda_inv_0_3_p75, Lambda_inv_0_4_p75, Lambda_inv_0_5_p82, Lambda_inv_0_0_p593,
      Lambda_inv_0_0_p593);
  const Lanes Lambda_inv_0_0_p628_lanes = Lambda_inv_0_0_p590_lanes + Lambda_inv_0_0_p627_lanes;
  const Lanes Lambda_inv_0_0_p629_lanes = s9 * Lambda_inv_0_0_p628_lanes;
  const Lanes Lambda_inv_0_0_p630_lanes = Lambda_inv_0_0_p626_lanes - Lambda_inv_0_0_p629_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_0_0_p631_lanes = Lambda_inv_0_0_p630_lanes - Lambda_inv_0_0_p623_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p632_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p631_lanes[0],
      Lambda_inv_0_0_p631_lanes[1], Lambda_inv_0_0_p631_lanes[2], Lambda_inv_0_0_p631_lanes[3],
      Lambda_inv_0_0_p631_lanes[4], Lambda_inv_0_0_p631_lanes[5], c16 * Lambda_inv_0_6_p55 - s16 *
      Lambda_inv_0_6_p56 - Lambda_inv_0_0_p299 * Lambda_inv_0_6_p50, c16 * Lambda_inv_0_7_p50 -
      s16 * Lambda_inv_0_7_p51 - Lambda_inv_0_0_p299 * Lambda_inv_0_7_p45) -
      Lambda_inv_0_0_p622_lanes;
  const Lanes Lambda_inv_0_0_p633_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_inv_0_0_p632_lanes;
  const Lanes Lambda_inv_0_0_p634_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p148,
      Lambda_inv_0_0_p148, Lambda_inv_0_0_p148, Lambda_inv_0_0_p148, Lambda_inv_0_0_p148,
      Lambda_inv_0_0_p148, Lambda_inv_0_0_p324, Lambda_inv_0_0_p324) *
      detail::make_lanes<Real>(Lambda_inv_0_0_p621_lanes[0], Lambda_inv_0_0_p621_lanes[1],
      Lambda_inv_0_0_p621_lanes[2], Lambda_inv_0_0_p621_lanes[3], Lambda_inv_0_0_p621_lanes[4],
      Lambda_inv_0_0_p621_lanes[5], Lambda_inv_0_6_p53, Lambda_inv_0_7_p48);

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_0_7_p55 = -(-(s17 * Lambda_inv_0_7_p41 + c17 * Lambda_inv_0_7_p42) +
      Lambda_inv_0_0_p311 * Lambda_inv_0_7_p39) - Lambda_inv_0_0_p317 * Lambda_inv_0_7_p45;
  const Real Lambda_inv_0_7_p56 = s16 * Lambda_inv_0_7_p50 + c16 * Lambda_inv_0_7_p51 -
      Lambda_inv_0_0_p308 * Lambda_inv_0_7_p45;
  const Real Lambda_inv_0_6_p60 = s16 * Lambda_inv_0_6_p55 + c16 * Lambda_inv_0_6_p56 -
      Lambda_inv_0_0_p308 * Lambda_inv_0_6_p50;
  const Real Lambda_inv_0_6_p61 = -(-(s17 * Lambda_inv_0_6_p46 + c17 * Lambda_inv_0_6_p47) +
      Lambda_inv_0_0_p311 * Lambda_inv_0_6_p44) - Lambda_inv_0_0_p317 * Lambda_inv_0_6_p50;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_0_0_p635_lanes = Lambda_inv_0_0_p138 * Lambda_inv_0_0_p614_lanes;
  const Lanes Lambda_inv_0_0_p636_lanes = detail::make_lanes<Real>(-(-(s10 *
      Lambda_inv_0_0_p604_lanes[0] + c10 * Lambda_inv_0_0_p598_lanes[0]) - Lambda_inv_0_0_p132 *
      Lambda_inv_0_0_p593), -(-(s10 * Lambda_inv_0_0_p604_lanes[1] + c10 *
      Lambda_inv_0_0_p598_lanes[1]) - Lambda_inv_0_0_p132 * Lambda_inv_0_1_p56),
      -(-(s10 * Lambda_inv_0_0_p604_lanes[2] + c10 * Lambda_inv_0_0_p598_lanes[2]) -
      Lambda_inv_0_0_p132 * Lambda_inv_0_2_p60), -(-(s10 * Lambda_inv_0_0_p604_lanes[3] + c10 *
      Lambda_inv_0_0_p598_lanes[3]) - Lambda_inv_0_0_p132 * Lambda_inv_0_3_p75),
      -(-(s10 * Lambda_inv_0_0_p604_lanes[4] + c10 * Lambda_inv_0_0_p598_lanes[4]) -
      Lambda_inv_0_0_p132 * Lambda_inv_0_4_p75), -(-(s10 * Lambda_inv_0_0_p604_lanes[5] + c10 *
      Lambda_inv_0_0_p598_lanes[5]) - Lambda_inv_0_0_p132 * Lambda_inv_0_5_p82),
      -(-(s10 * Lambda_inv_0_0_p604_lanes[0] + c10 * Lambda_inv_0_0_p598_lanes[0]) -
      Lambda_inv_0_0_p132 * Lambda_inv_0_0_p593), -(-(s10 * Lambda_inv_0_0_p604_lanes[0] + c10 *
      Lambda_inv_0_0_p598_lanes[0]) - Lambda_inv_0_0_p132 * Lambda_inv_0_0_p593)) +
      Lambda_inv_0_0_p635_lanes;
  const Lanes Lambda_inv_0_0_p637_lanes = c8 * Lambda_inv_0_0_p636_lanes;
  const Lanes Lambda_inv_0_0_p638_lanes = Lambda_inv_0_0_p141 * Lambda_inv_0_0_p614_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_0_0_p639_lanes = s9 * Lambda_inv_0_0_p625_lanes;
  const Lanes Lambda_inv_0_0_p640_lanes = c9 * Lambda_inv_0_0_p628_lanes;
  const Lanes Lambda_inv_0_0_p641_lanes = Lambda_inv_0_0_p639_lanes + Lambda_inv_0_0_p640_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_0_0_p642_lanes = Lambda_inv_0_0_p641_lanes - Lambda_inv_0_0_p638_lanes;
  const Lanes Lambda_inv_0_0_p643_lanes = s8 * Lambda_inv_0_0_p642_lanes;
  const Lanes Lambda_inv_0_0_p644_lanes = Lambda_inv_0_0_p637_lanes - Lambda_inv_0_0_p643_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p645_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p644_lanes[0],
      Lambda_inv_0_0_p644_lanes[1], Lambda_inv_0_0_p644_lanes[2], Lambda_inv_0_0_p644_lanes[3],
      Lambda_inv_0_0_p644_lanes[4], Lambda_inv_0_0_p644_lanes[5], c15 * Lambda_inv_0_6_p61 - s15 *
      Lambda_inv_0_6_p60, c15 * Lambda_inv_0_7_p55 - s15 * Lambda_inv_0_7_p56) -
      Lambda_inv_0_0_p634_lanes;
  const Lanes Lambda_inv_0_0_p646_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_inv_0_0_p645_lanes;
  const Lanes Lambda_inv_0_0_p647_lanes = Lambda_inv_0_0_p633_lanes + Lambda_inv_0_0_p646_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Real Lambda_inv_0_0_p648 = 2.6249999999999998e-05 / inverse_D7_p8;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p649_lanes = Lambda_inv_0_0_p648 * Lambda_inv_0_0_p621_lanes;
  const Lanes Lambda_inv_0_0_p650_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, 0.18,
      0.18) * detail::make_lanes<Real>(Lambda_inv_0_0_p649_lanes[0], Lambda_inv_0_0_p649_lanes[1],
      Lambda_inv_0_0_p649_lanes[2], Lambda_inv_0_0_p649_lanes[3], Lambda_inv_0_0_p649_lanes[4],
      Lambda_inv_0_0_p649_lanes[5], Lambda_inv_0_0_p647_lanes[6], Lambda_inv_0_0_p647_lanes[7]);
  const Lanes Lambda_inv_0_0_p651_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p179,
      Lambda_inv_0_0_p179, Lambda_inv_0_0_p179, Lambda_inv_0_0_p179, Lambda_inv_0_0_p179,
      Lambda_inv_0_0_p179, Lambda_inv_0_0_p334, Lambda_inv_0_0_p334) *
      detail::make_lanes<Real>(Lambda_inv_0_0_p621_lanes[0], Lambda_inv_0_0_p621_lanes[1],
      Lambda_inv_0_0_p621_lanes[2], Lambda_inv_0_0_p621_lanes[3], Lambda_inv_0_0_p621_lanes[4],
      Lambda_inv_0_0_p621_lanes[5], Lambda_inv_0_6_p53, Lambda_inv_0_7_p48);

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_0_0_p652_lanes = s8 * Lambda_inv_0_0_p636_lanes;
  const Lanes Lambda_inv_0_0_p653_lanes = c8 * Lambda_inv_0_0_p642_lanes;
  const Lanes Lambda_inv_0_0_p654_lanes = Lambda_inv_0_0_p652_lanes + Lambda_inv_0_0_p653_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p655_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p654_lanes[0],
      Lambda_inv_0_0_p654_lanes[1], Lambda_inv_0_0_p654_lanes[2], Lambda_inv_0_0_p654_lanes[3],
      Lambda_inv_0_0_p654_lanes[4], Lambda_inv_0_0_p654_lanes[5], s15 * Lambda_inv_0_6_p61 + c15 *
      Lambda_inv_0_6_p60, s15 * Lambda_inv_0_7_p55 + c15 * Lambda_inv_0_7_p56) -
      Lambda_inv_0_0_p651_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_0_0_p656_lanes = s8 * Lambda_inv_0_0_p616_lanes;
  const Lanes Lambda_inv_0_0_p657_lanes = c8 * Lambda_inv_0_0_p619_lanes;
  const Lanes Lambda_inv_0_0_p658_lanes = Lambda_inv_0_0_p657_lanes - Lambda_inv_0_0_p656_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p659_lanes = inverse_D6_p6 * Lambda_inv_0_0_p621_lanes;
  const Lanes Lambda_inv_0_0_p660_lanes = Lambda_inv_0_0_p658_lanes - Lambda_inv_0_0_p659_lanes;
  const Lanes Lambda_inv_0_0_p661_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, 0.226,
      0.226) * detail::make_lanes<Real>(Lambda_inv_0_0_p660_lanes[0], Lambda_inv_0_0_p660_lanes[1],
      Lambda_inv_0_0_p660_lanes[2], Lambda_inv_0_0_p660_lanes[3], Lambda_inv_0_0_p660_lanes[4],
      Lambda_inv_0_0_p660_lanes[5], Lambda_inv_0_0_p655_lanes[6], Lambda_inv_0_0_p655_lanes[7]);
  const Lanes Lambda_inv_0_0_p662_lanes = Lambda_inv_0_0_p650_lanes - Lambda_inv_0_0_p661_lanes;

  // link 14 (right_shoulder1), articulated inertia
  const Real Lambda_inv_0_7_p65 = 2.6249999999999998e-05 / inverse_D14_p8;

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_0_7_p66 = Lambda_inv_0_7_p65 * Lambda_inv_0_7_p48;
  const Real Lambda_inv_0_6_p70 = Lambda_inv_0_7_p65 * Lambda_inv_0_6_p53;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p663_lanes = detail::make_lanes<Real>(0.226, 0.226, 0.226, 0.226,
      0.226, 0.226, c14, c14) * detail::make_lanes<Real>(Lambda_inv_0_0_p655_lanes[0],
      Lambda_inv_0_0_p655_lanes[1], Lambda_inv_0_0_p655_lanes[2], Lambda_inv_0_0_p655_lanes[3],
      Lambda_inv_0_0_p655_lanes[4], Lambda_inv_0_0_p655_lanes[5], Lambda_inv_0_6_p70,
      Lambda_inv_0_7_p66);

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_0_7_p68 = c15 * Lambda_inv_0_7_p46 - s15 * Lambda_inv_0_7_p47 -
      inverse_D6_p1 * Lambda_inv_0_7_p48;
  const Real Lambda_inv_0_6_p72 = c15 * Lambda_inv_0_6_p52 - s15 * Lambda_inv_0_6_p51 -
      inverse_D6_p1 * Lambda_inv_0_6_p53;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p664_lanes = detail::make_lanes<Real>(0.18, 0.18, 0.18, 0.18, 0.18,
      0.18, s14, s14) * detail::make_lanes<Real>(Lambda_inv_0_0_p647_lanes[0],
      Lambda_inv_0_0_p647_lanes[1], Lambda_inv_0_0_p647_lanes[2], Lambda_inv_0_0_p647_lanes[3],
      Lambda_inv_0_0_p647_lanes[4], Lambda_inv_0_0_p647_lanes[5], Lambda_inv_0_6_p72,
      Lambda_inv_0_7_p68);
  const Lanes Lambda_inv_0_0_p665_lanes = Lambda_inv_0_0_p663_lanes + Lambda_inv_0_0_p664_lanes;
  const Lanes Lambda_inv_0_0_p666_lanes = Lambda_inv_0_0_p662_lanes - Lambda_inv_0_0_p665_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_0_p667_lanes = inverse_D5_p14 * Lambda_inv_0_0_p666_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p668_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, c14,
      c14) * Lambda_inv_0_0_p632_lanes;
  const Lanes Lambda_inv_0_0_p669_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, s14,
      s14) * Lambda_inv_0_0_p645_lanes;
  const Lanes Lambda_inv_0_0_p670_lanes = Lambda_inv_0_0_p668_lanes - Lambda_inv_0_0_p669_lanes;
  const Lanes Lambda_inv_0_0_p671_lanes = c7 * Lambda_inv_0_0_p660_lanes;
  const Lanes Lambda_inv_0_0_p672_lanes = s7 * Lambda_inv_0_0_p649_lanes;
  const Lanes Lambda_inv_0_0_p673_lanes = Lambda_inv_0_0_p672_lanes + Lambda_inv_0_0_p671_lanes;
  const Lanes Lambda_inv_0_0_p674_lanes = 0.18 * Lambda_inv_0_0_p670_lanes;
  const Lanes Lambda_inv_0_0_p675_lanes = Lambda_inv_0_0_p673_lanes + Lambda_inv_0_0_p674_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_0_p676_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p675_lanes[0],
      Lambda_inv_0_0_p675_lanes[1], Lambda_inv_0_0_p675_lanes[2], Lambda_inv_0_0_p675_lanes[3],
      Lambda_inv_0_0_p675_lanes[4], Lambda_inv_0_0_p675_lanes[5],
      -(s14 * Lambda_inv_0_6_p70 - c14 * Lambda_inv_0_6_p72 + 0.18 * Lambda_inv_0_0_p670_lanes[6]),
      -(s14 * Lambda_inv_0_7_p66 - c14 * Lambda_inv_0_7_p68 + 0.18 *
      Lambda_inv_0_0_p670_lanes[7])) - Lambda_inv_0_0_p667_lanes;
  const Lanes Lambda_inv_0_0_p677_lanes = s6 * Lambda_inv_0_0_p676_lanes;
  const Lanes Lambda_inv_0_0_p678_lanes = inverse_D5_p16 * Lambda_inv_0_0_p666_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p679_lanes = 0.226 * Lambda_inv_0_0_p670_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_0_p680_lanes = Lambda_inv_0_0_p679_lanes - Lambda_inv_0_0_p678_lanes;
  const Lanes Lambda_inv_0_0_p681_lanes = c6 * Lambda_inv_0_0_p680_lanes;
  const Lanes Lambda_inv_0_0_p682_lanes = Lambda_inv_0_0_p677_lanes + Lambda_inv_0_0_p681_lanes;
  const Lanes Lambda_inv_0_0_p683_lanes = Lambda_inv_0_0_p450 * Lambda_inv_0_0_p666_lanes;
  const Lanes Lambda_inv_0_0_p684_lanes = Lambda_inv_0_0_p670_lanes - Lambda_inv_0_0_p683_lanes;
  const Lanes Lambda_inv_0_0_p685_lanes = 0.072 * Lambda_inv_0_0_p684_lanes;
  const Lanes Lambda_inv_0_0_p686_lanes = Lambda_inv_0_0_p682_lanes + Lambda_inv_0_0_p685_lanes;
  const Lanes Lambda_inv_0_0_p687_lanes = Lambda_inv_0_0_p410 * Lambda_inv_0_0_p666_lanes;
  const Lanes Lambda_inv_0_0_p688_lanes = Lambda_inv_0_0_p647_lanes - Lambda_inv_0_0_p687_lanes;
  const Lanes Lambda_inv_0_0_p689_lanes = s6 * Lambda_inv_0_0_p688_lanes;
  const Lanes Lambda_inv_0_0_p690_lanes = Lambda_inv_0_0_p441 * Lambda_inv_0_0_p666_lanes;
  const Lanes Lambda_inv_0_0_p691_lanes = Lambda_inv_0_0_p655_lanes - Lambda_inv_0_0_p690_lanes;
  const Lanes Lambda_inv_0_0_p692_lanes = c6 * Lambda_inv_0_0_p691_lanes;
  const Lanes Lambda_inv_0_0_p693_lanes = Lambda_inv_0_0_p689_lanes + Lambda_inv_0_0_p692_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_7_p94 = -(0.072 * Lambda_inv_0_0_p693_lanes[7]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_0_p686_lanes[7];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_0_p694_lanes = c6 * Lambda_inv_0_0_p676_lanes;
  const Lanes Lambda_inv_0_0_p695_lanes = s6 * Lambda_inv_0_0_p680_lanes;
  const Lanes Lambda_inv_0_0_p696_lanes = Lambda_inv_0_0_p694_lanes - Lambda_inv_0_0_p695_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_7_p98 = Lambda_inv_0_0_p696_lanes[7] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_0_p686_lanes[7];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_7_p99 = -(s5 * Lambda_inv_0_7_p94 + c5 * Lambda_inv_0_7_p98);

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_6_p101 = -(0.072 * Lambda_inv_0_0_p693_lanes[6]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_0_p686_lanes[6];
  const Real Lambda_inv_0_6_p102 = Lambda_inv_0_0_p696_lanes[6] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_0_p686_lanes[6];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_6_p103 = -(s5 * Lambda_inv_0_6_p101 + c5 * Lambda_inv_0_6_p102);

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_5_p184 = -(0.072 * Lambda_inv_0_0_p693_lanes[5]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_0_p686_lanes[5];
  const Real Lambda_inv_0_5_p185 = Lambda_inv_0_0_p696_lanes[5] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_0_p686_lanes[5];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_5_p186 = -(s5 * Lambda_inv_0_5_p184 + c5 * Lambda_inv_0_5_p185);

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_4_p177 = -(0.072 * Lambda_inv_0_0_p693_lanes[4]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_0_p686_lanes[4];
  const Real Lambda_inv_0_4_p178 = Lambda_inv_0_0_p696_lanes[4] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_0_p686_lanes[4];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_4_p179 = -(s5 * Lambda_inv_0_4_p177 + c5 * Lambda_inv_0_4_p178);

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_3_p177 = -(0.072 * Lambda_inv_0_0_p693_lanes[3]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_0_p686_lanes[3];
  const Real Lambda_inv_0_3_p178 = Lambda_inv_0_0_p696_lanes[3] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_0_p686_lanes[3];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_3_p179 = -(s5 * Lambda_inv_0_3_p177 + c5 * Lambda_inv_0_3_p178);

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_2_p162 = -(0.072 * Lambda_inv_0_0_p693_lanes[2]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_0_p686_lanes[2];
  const Real Lambda_inv_0_2_p163 = Lambda_inv_0_0_p696_lanes[2] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_0_p686_lanes[2];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_2_p164 = -(s5 * Lambda_inv_0_2_p162 + c5 * Lambda_inv_0_2_p163);

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_1_p158 = -(0.072 * Lambda_inv_0_0_p693_lanes[1]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_0_p686_lanes[1];
  const Real Lambda_inv_0_1_p159 = Lambda_inv_0_0_p696_lanes[1] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_0_p686_lanes[1];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_1_p160 = -(s5 * Lambda_inv_0_1_p158 + c5 * Lambda_inv_0_1_p159);

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_0_p697 = -(0.072 * Lambda_inv_0_0_p693_lanes[0]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_0_p686_lanes[0];
  const Real Lambda_inv_0_0_p698 = Lambda_inv_0_0_p696_lanes[0] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_0_p686_lanes[0];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_0_p699 = -(s5 * Lambda_inv_0_0_p697 + c5 * Lambda_inv_0_0_p698);
  const Lanes Lambda_inv_0_0_p700_lanes = inverse_D3_p1 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p699, Lambda_inv_0_1_p160, Lambda_inv_0_2_p164,
      Lambda_inv_0_3_p179, Lambda_inv_0_4_p179, Lambda_inv_0_5_p186, Lambda_inv_0_6_p103,
      Lambda_inv_0_7_p99);

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_0_0_p701_lanes = Lambda_inv_0_0_p462 * Lambda_inv_0_0_p686_lanes;
  const Lanes Lambda_inv_0_0_p702_lanes = Lambda_inv_0_0_p693_lanes - Lambda_inv_0_0_p701_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_0_0_p703_lanes = detail::make_lanes<Real>(-(s5 * Lambda_inv_0_0_p698 - c5 *
      Lambda_inv_0_0_p697 + 0.21799999999999997 * Lambda_inv_0_0_p702_lanes[0]),
      -(s5 * Lambda_inv_0_1_p159 - c5 * Lambda_inv_0_1_p158 + 0.21799999999999997 *
      Lambda_inv_0_0_p702_lanes[1]), -(s5 * Lambda_inv_0_2_p163 - c5 * Lambda_inv_0_2_p162 +
      0.21799999999999997 * Lambda_inv_0_0_p702_lanes[2]),
      -(s5 * Lambda_inv_0_3_p178 - c5 * Lambda_inv_0_3_p177 + 0.21799999999999997 *
      Lambda_inv_0_0_p702_lanes[3]), -(s5 * Lambda_inv_0_4_p178 - c5 * Lambda_inv_0_4_p177 +
      0.21799999999999997 * Lambda_inv_0_0_p702_lanes[4]),
      -(s5 * Lambda_inv_0_5_p185 - c5 * Lambda_inv_0_5_p184 + 0.21799999999999997 *
      Lambda_inv_0_0_p702_lanes[5]), -(s5 * Lambda_inv_0_6_p102 - c5 * Lambda_inv_0_6_p101 +
      0.21799999999999997 * Lambda_inv_0_0_p702_lanes[6]),
      -(s5 * Lambda_inv_0_7_p98 - c5 * Lambda_inv_0_7_p94 + 0.21799999999999997 *
      Lambda_inv_0_0_p702_lanes[7])) - Lambda_inv_0_0_p700_lanes;
  const Lanes Lambda_inv_0_0_p704_lanes = s4 * Lambda_inv_0_0_p703_lanes;
  const Lanes Lambda_inv_0_0_p705_lanes = inverse_D3_p2 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p699, Lambda_inv_0_1_p160, Lambda_inv_0_2_p164,
      Lambda_inv_0_3_p179, Lambda_inv_0_4_p179, Lambda_inv_0_5_p186, Lambda_inv_0_6_p103,
      Lambda_inv_0_7_p99);

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_0_p706_lanes = c6 * Lambda_inv_0_0_p688_lanes;
  const Lanes Lambda_inv_0_0_p707_lanes = s6 * Lambda_inv_0_0_p691_lanes;
  const Lanes Lambda_inv_0_0_p708_lanes = Lambda_inv_0_0_p706_lanes - Lambda_inv_0_0_p707_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_7_p109 = Lambda_inv_0_0_p708_lanes[7] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_0_p686_lanes[7];
  const Real Lambda_inv_0_7_p110 = Lambda_inv_0_0_p684_lanes[7] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_0_p686_lanes[7];
  const Real Lambda_inv_0_7_p111 = s5 * Lambda_inv_0_7_p109 - c5 * Lambda_inv_0_7_p110;
  const Real Lambda_inv_0_6_p113 = Lambda_inv_0_0_p708_lanes[6] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_0_p686_lanes[6];
  const Real Lambda_inv_0_6_p114 = Lambda_inv_0_0_p684_lanes[6] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_0_p686_lanes[6];
  const Real Lambda_inv_0_6_p115 = s5 * Lambda_inv_0_6_p113 - c5 * Lambda_inv_0_6_p114;
  const Real Lambda_inv_0_5_p196 = Lambda_inv_0_0_p708_lanes[5] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_0_p686_lanes[5];
  const Real Lambda_inv_0_5_p197 = Lambda_inv_0_0_p684_lanes[5] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_0_p686_lanes[5];
  const Real Lambda_inv_0_5_p198 = s5 * Lambda_inv_0_5_p196 - c5 * Lambda_inv_0_5_p197;
  const Real Lambda_inv_0_4_p189 = Lambda_inv_0_0_p708_lanes[4] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_0_p686_lanes[4];
  const Real Lambda_inv_0_4_p190 = Lambda_inv_0_0_p684_lanes[4] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_0_p686_lanes[4];
  const Real Lambda_inv_0_4_p191 = s5 * Lambda_inv_0_4_p189 - c5 * Lambda_inv_0_4_p190;
  const Real Lambda_inv_0_3_p189 = Lambda_inv_0_0_p708_lanes[3] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_0_p686_lanes[3];
  const Real Lambda_inv_0_3_p190 = Lambda_inv_0_0_p684_lanes[3] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_0_p686_lanes[3];
  const Real Lambda_inv_0_3_p191 = s5 * Lambda_inv_0_3_p189 - c5 * Lambda_inv_0_3_p190;
  const Real Lambda_inv_0_2_p174 = Lambda_inv_0_0_p708_lanes[2] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_0_p686_lanes[2];
  const Real Lambda_inv_0_2_p175 = Lambda_inv_0_0_p684_lanes[2] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_0_p686_lanes[2];
  const Real Lambda_inv_0_2_p176 = s5 * Lambda_inv_0_2_p174 - c5 * Lambda_inv_0_2_p175;
  const Real Lambda_inv_0_1_p170 = Lambda_inv_0_0_p708_lanes[1] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_0_p686_lanes[1];
  const Real Lambda_inv_0_1_p171 = Lambda_inv_0_0_p684_lanes[1] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_0_p686_lanes[1];
  const Real Lambda_inv_0_1_p172 = s5 * Lambda_inv_0_1_p170 - c5 * Lambda_inv_0_1_p171;
  const Real Lambda_inv_0_0_p709 = Lambda_inv_0_0_p708_lanes[0] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_0_p686_lanes[0];
  const Real Lambda_inv_0_0_p710 = Lambda_inv_0_0_p684_lanes[0] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_0_p686_lanes[0];
  const Real Lambda_inv_0_0_p711 = s5 * Lambda_inv_0_0_p709 - c5 * Lambda_inv_0_0_p710;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_0_0_p712_lanes = detail::make_lanes<Real>(-(0.21799999999999997 *
      Lambda_inv_0_0_p711), -(0.21799999999999997 * Lambda_inv_0_1_p172),
      -(0.21799999999999997 * Lambda_inv_0_2_p176), -(0.21799999999999997 * Lambda_inv_0_3_p191),
      -(0.21799999999999997 * Lambda_inv_0_4_p191), -(0.21799999999999997 * Lambda_inv_0_5_p198),
      -(0.21799999999999997 * Lambda_inv_0_6_p115), -(0.21799999999999997 * Lambda_inv_0_7_p111)) +
      Lambda_inv_0_0_p705_lanes;
  const Lanes Lambda_inv_0_0_p713_lanes = c4 * Lambda_inv_0_0_p712_lanes;
  const Lanes Lambda_inv_0_0_p714_lanes = Lambda_inv_0_0_p704_lanes + Lambda_inv_0_0_p713_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_0_0_p715_lanes = Lambda_inv_0_0_p520 * Lambda_inv_0_0_p714_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_0_0_p716_lanes = Lambda_inv_0_0_p498 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p699, Lambda_inv_0_1_p160, Lambda_inv_0_2_p164,
      Lambda_inv_0_3_p179, Lambda_inv_0_4_p179, Lambda_inv_0_5_p186, Lambda_inv_0_6_p103,
      Lambda_inv_0_7_p99);
  const Lanes Lambda_inv_0_0_p717_lanes = detail::make_lanes<Real>(-Lambda_inv_0_0_p711,
      -Lambda_inv_0_1_p172, -Lambda_inv_0_2_p176, -Lambda_inv_0_3_p191, -Lambda_inv_0_4_p191,
      -Lambda_inv_0_5_p198, -Lambda_inv_0_6_p115, -Lambda_inv_0_7_p111) + Lambda_inv_0_0_p716_lanes;
  const Lanes Lambda_inv_0_0_p718_lanes = c4 * Lambda_inv_0_0_p717_lanes;
  const Lanes Lambda_inv_0_0_p719_lanes = Lambda_inv_0_0_p507 *
      detail::make_lanes<Real>(Lambda_inv_0_0_p699, Lambda_inv_0_1_p160, Lambda_inv_0_2_p164,
      Lambda_inv_0_3_p179, Lambda_inv_0_4_p179, Lambda_inv_0_5_p186, Lambda_inv_0_6_p103,
      Lambda_inv_0_7_p99);
  const Lanes Lambda_inv_0_0_p720_lanes = Lambda_inv_0_0_p702_lanes + Lambda_inv_0_0_p719_lanes;
  const Lanes Lambda_inv_0_0_p721_lanes = s4 * Lambda_inv_0_0_p720_lanes;
  const Lanes Lambda_inv_0_0_p722_lanes = Lambda_inv_0_0_p718_lanes - Lambda_inv_0_0_p721_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_0_0_p723_lanes = Lambda_inv_0_0_p722_lanes - Lambda_inv_0_0_p715_lanes;
  const Lanes Lambda_inv_0_0_p724_lanes = c3 * Lambda_inv_0_0_p723_lanes;
  const Lanes Lambda_inv_0_0_p725_lanes = Lambda_inv_0_0_p530 * Lambda_inv_0_0_p714_lanes;
  const Lanes Lambda_inv_0_0_p726_lanes = detail::make_lanes<Real>(-(-(s5 * Lambda_inv_0_0_p710 +
      c5 * Lambda_inv_0_0_p709) - Lambda_inv_0_0_p525 * Lambda_inv_0_0_p699),
      -(-(s5 * Lambda_inv_0_1_p171 + c5 * Lambda_inv_0_1_p170) - Lambda_inv_0_0_p525 *
      Lambda_inv_0_1_p160), -(-(s5 * Lambda_inv_0_2_p175 + c5 * Lambda_inv_0_2_p174) -
      Lambda_inv_0_0_p525 * Lambda_inv_0_2_p164), -(-(s5 * Lambda_inv_0_3_p190 + c5 *
      Lambda_inv_0_3_p189) - Lambda_inv_0_0_p525 * Lambda_inv_0_3_p179),
      -(-(s5 * Lambda_inv_0_4_p190 + c5 * Lambda_inv_0_4_p189) - Lambda_inv_0_0_p525 *
      Lambda_inv_0_4_p179), -(-(s5 * Lambda_inv_0_5_p197 + c5 * Lambda_inv_0_5_p196) -
      Lambda_inv_0_0_p525 * Lambda_inv_0_5_p186), -(-(s5 * Lambda_inv_0_6_p114 + c5 *
      Lambda_inv_0_6_p113) - Lambda_inv_0_0_p525 * Lambda_inv_0_6_p103),
      -(-(s5 * Lambda_inv_0_7_p110 + c5 * Lambda_inv_0_7_p109) - Lambda_inv_0_0_p525 *
      Lambda_inv_0_7_p99)) + Lambda_inv_0_0_p725_lanes;
  const Lanes Lambda_inv_0_0_p727_lanes = s3 * Lambda_inv_0_0_p726_lanes;
  const Lanes Lambda_inv_0_0_p728_lanes = Lambda_inv_0_0_p724_lanes - Lambda_inv_0_0_p727_lanes;
  const Lanes Lambda_inv_0_0_p729_lanes = 0.422 * Lambda_inv_0_0_p728_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_0_0_p730_lanes = Lambda_inv_0_0_p537 * Lambda_inv_0_0_p729_lanes;
  const Lanes Lambda_inv_0_0_p731_lanes = Lambda_inv_0_0_p728_lanes - Lambda_inv_0_0_p730_lanes;
  const Lanes Lambda_inv_0_0_p732_lanes = c2 * Lambda_inv_0_0_p731_lanes;

  // link 3 (hip), articulated inertia
  const Real Lambda_inv_0_0_p733 = c3 * Lambda_inv_0_0_p533 - Lambda_inv_0_0_p532;
  const Real Lambda_inv_0_0_p734 = 0.031999971599999996 + 0.422 * Lambda_inv_0_0_p733;

  // link 2 (thigh), articulated inertia
  const Real Lambda_inv_0_0_p735 = Lambda_inv_0_0_p734 * inverse_D2;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_0_0_p736_lanes = Lambda_inv_0_0_p735 * Lambda_inv_0_0_p729_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_0_0_p737_lanes = s3 * Lambda_inv_0_0_p723_lanes;
  const Lanes Lambda_inv_0_0_p738_lanes = c3 * Lambda_inv_0_0_p726_lanes;
  const Lanes Lambda_inv_0_0_p739_lanes = Lambda_inv_0_0_p737_lanes + Lambda_inv_0_0_p738_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_0_0_p740_lanes = Lambda_inv_0_0_p739_lanes - Lambda_inv_0_0_p736_lanes;
  const Lanes Lambda_inv_0_0_p741_lanes = s2 * Lambda_inv_0_0_p740_lanes;
  const Lanes Lambda_inv_0_0_p742_lanes = Lambda_inv_0_0_p732_lanes - Lambda_inv_0_0_p741_lanes;
  const Lanes Lambda_inv_0_0_p743_lanes = 0.434 * Lambda_inv_0_0_p742_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p1 = Lambda_inv_0_0_p535 - Lambda_inv_0_0_p536 * Lambda_inv_0_0_p537;
  const Real inverse_D1_p2 = s2 * (inverse_D1_p1 - (Lambda_inv_0_0_p531 + Lambda_inv_0_0_p534 -
      Lambda_inv_0_0_p734 * Lambda_inv_0_0_p735)) + c2 *
      (2.0 * (Lambda_inv_0_0_p733 - Lambda_inv_0_0_p536 * Lambda_inv_0_0_p735));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p1 - s2 * inverse_D1_p2));

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_0_0_p744_lanes = Lambda_inv_0_0_p743_lanes * inverse_D1;
  const Lanes Lambda_inv_0_0_p745_lanes = Lambda_inv_0_0_p744_lanes * Lambda_inv_0_0_p743_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_0_0_p746_lanes = Lambda_inv_0_0_p729_lanes * inverse_D2;
  const Lanes Lambda_inv_0_0_p747_lanes = Lambda_inv_0_0_p746_lanes * Lambda_inv_0_0_p729_lanes[0];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_0_0_p748_lanes = Lambda_inv_0_0_p714_lanes * inverse_D3;
  const Lanes Lambda_inv_0_0_p749_lanes = Lambda_inv_0_0_p748_lanes * Lambda_inv_0_0_p714_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_0_0_p750_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p699,
      Lambda_inv_0_1_p160, Lambda_inv_0_2_p164, Lambda_inv_0_3_p179, Lambda_inv_0_4_p179,
      Lambda_inv_0_5_p186, Lambda_inv_0_6_p103, Lambda_inv_0_7_p99) * inverse_D4;
  const Lanes Lambda_inv_0_0_p751_lanes = Lambda_inv_0_0_p750_lanes * Lambda_inv_0_0_p699;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_0_0_p752_lanes = Lambda_inv_0_0_p686_lanes * inverse_D5;
  const Lanes Lambda_inv_0_0_p753_lanes = Lambda_inv_0_0_p752_lanes * Lambda_inv_0_0_p686_lanes[0];

  // link 6 (chest3), force propagation
  const Real Lambda_inv_0_7_p151 = Lambda_inv_0_0_p666_lanes[7] * inverse_D6;
  const Real Lambda_inv_0_6_p155 = Lambda_inv_0_0_p666_lanes[6] * inverse_D6;
  const Lanes Lambda_inv_0_0_p754_lanes = Lambda_inv_0_0_p666_lanes * inverse_D6;
  const Lanes Lambda_inv_0_0_p755_lanes = Lambda_inv_0_0_p754_lanes * Lambda_inv_0_0_p666_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p756_lanes = Lambda_inv_0_0_p621_lanes * inverse_D7;
  const Lanes Lambda_inv_0_0_p757_lanes = Lambda_inv_0_0_p756_lanes * Lambda_inv_0_0_p621_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_0_0_p758_lanes = Lambda_inv_0_0_p614_lanes * inverse_D8;
  const Lanes Lambda_inv_0_0_p759_lanes = Lambda_inv_0_0_p758_lanes * Lambda_inv_0_0_p614_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_0_0_p760_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p593,
      Lambda_inv_0_1_p56, Lambda_inv_0_2_p60, Lambda_inv_0_3_p75, Lambda_inv_0_4_p75,
      Lambda_inv_0_5_p82, Lambda_inv_0_0_p593, Lambda_inv_0_0_p593) * inverse_D9;
  const Lanes Lambda_inv_0_0_p761_lanes = Lambda_inv_0_0_p760_lanes * Lambda_inv_0_0_p593;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_0_0_p762_lanes = Lambda_inv_0_0_p575_lanes * inverse_D10;
  const Lanes Lambda_inv_0_0_p763_lanes = Lambda_inv_0_0_p762_lanes * Lambda_inv_0_0_p575_lanes[0];

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_0_0_p764_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p557,
      Lambda_inv_0_1_p20, Lambda_inv_0_2_p21, Lambda_inv_0_3_p37, Lambda_inv_0_4_p37,
      Lambda_inv_0_5_p44, Lambda_inv_0_0_p557, Lambda_inv_0_0_p557) * inverse_D11;
  const Lanes Lambda_inv_0_0_p765_lanes = Lambda_inv_0_0_p764_lanes * Lambda_inv_0_0_p557;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_0_0_p766_lanes = Lambda_inv_0_0_p547_lanes * inverse_D12;
  const Lanes Lambda_inv_0_0_p767_lanes = Lambda_inv_0_0_p766_lanes * Lambda_inv_0_0_p547_lanes[0];

  // link 1 (calf), articulated inertia
  const Real Lambda_inv_0_0_p768 = 0.086 * Lambda_inv_0_0_p538;

  // link 13 (left_hand), force propagation
  const Lanes Lambda_inv_0_0_p769_lanes = detail::make_lanes<Real>(91.62274020012977,
      91.62274020012977, 1065.380700001509, 1065.380700001509, 1065.380700001509, 1065.380700001509,
      91.62274020012977, 91.62274020012977) * detail::make_lanes<Real>(Lambda_inv_0_0_p538,
      Lambda_inv_0_1_p1, Lambda_inv_0_2_p2, Lambda_inv_0_3_p14_lanes[0],
      Lambda_inv_0_3_p14_lanes[1], Lambda_inv_0_3_p14_lanes[2], Lambda_inv_0_0_p538,
      Lambda_inv_0_0_p538);
  const Lanes Lambda_inv_0_0_p770_lanes = Lambda_inv_0_0_p769_lanes * Lambda_inv_0_0_p768;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_0_0_p771_lanes = Lambda_inv_0_0_p770_lanes + Lambda_inv_0_0_p767_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_0_0_p772_lanes = Lambda_inv_0_0_p771_lanes + Lambda_inv_0_0_p765_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_0_0_p773_lanes = Lambda_inv_0_0_p772_lanes + Lambda_inv_0_0_p763_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_0_0_p774_lanes = Lambda_inv_0_0_p773_lanes + Lambda_inv_0_0_p761_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_0_0_p775_lanes = Lambda_inv_0_0_p774_lanes + Lambda_inv_0_0_p759_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_0_0_p776_lanes = Lambda_inv_0_0_p775_lanes + Lambda_inv_0_0_p757_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_0_p777_lanes = Lambda_inv_0_0_p776_lanes + Lambda_inv_0_0_p755_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_0_0_p778_lanes = detail::make_lanes<Real>(Lambda_inv_0_0_p777_lanes[0],
      Lambda_inv_0_0_p777_lanes[1], Lambda_inv_0_0_p777_lanes[2], Lambda_inv_0_0_p777_lanes[3],
      Lambda_inv_0_0_p777_lanes[4], Lambda_inv_0_0_p777_lanes[5], Lambda_inv_0_6_p155 *
      Lambda_inv_0_0_p666_lanes[0], Lambda_inv_0_7_p151 * Lambda_inv_0_0_p666_lanes[0]) +
      Lambda_inv_0_0_p753_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_0_0_p779_lanes = Lambda_inv_0_0_p778_lanes + Lambda_inv_0_0_p751_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_0_0_p780_lanes = Lambda_inv_0_0_p779_lanes + Lambda_inv_0_0_p749_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_0_0_p781_lanes = Lambda_inv_0_0_p780_lanes + Lambda_inv_0_0_p747_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_0_0_lanes = Lambda_inv_0_0_p781_lanes + Lambda_inv_0_0_p745_lanes;
  Lambda_inv[0] = Lambda_inv_0_0_lanes[0];
  Lambda_inv[1] = Lambda_inv_0_0_lanes[1];
  Lambda_inv[12] = Lambda_inv_0_0_lanes[1];
  Lambda_inv[2] = Lambda_inv_0_0_lanes[2];
  Lambda_inv[24] = Lambda_inv_0_0_lanes[2];
  Lambda_inv[3] = Lambda_inv_0_0_lanes[3];
  Lambda_inv[36] = Lambda_inv_0_0_lanes[3];
  Lambda_inv[4] = Lambda_inv_0_0_lanes[4];
  Lambda_inv[48] = Lambda_inv_0_0_lanes[4];
  Lambda_inv[5] = Lambda_inv_0_0_lanes[5];
  Lambda_inv[60] = Lambda_inv_0_0_lanes[5];
  Lambda_inv[6] = Lambda_inv_0_0_lanes[6];
  Lambda_inv[72] = Lambda_inv_0_0_lanes[6];
  Lambda_inv[7] = Lambda_inv_0_0_lanes[7];
  Lambda_inv[84] = Lambda_inv_0_0_lanes[7];

  // link 14 (right_shoulder1), pose
  const Real Lambda_inv_0_11_p1 = s14 * Lambda_inv_0_5_p4 - c14 * Lambda_inv_0_5_p5;
  const Real Lambda_inv_0_11_p2 = c14 * Lambda_inv_0_5_p4 + s14 * Lambda_inv_0_5_p5;

  // link 15 (right_shoulder2), pose
  const Real Lambda_inv_0_11_p3 = s15 * Lambda_inv_0_11_p2 + c15 * Lambda_inv_0_5_p8;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_11_p4 = c16 * Lambda_inv_0_11_p1 - s16 * Lambda_inv_0_11_p3;

  // link 15 (right_shoulder2), pose
  const Real Lambda_inv_0_11_p5 = c15 * Lambda_inv_0_11_p2 - s15 * Lambda_inv_0_5_p8;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_11_p6 = c17 * Lambda_inv_0_11_p4 + s17 * Lambda_inv_0_11_p5;

  // link 16 (right_upperarm), pose
  const Real Lambda_inv_0_11_p7 = c16 * Lambda_inv_0_11_p3 + s16 * Lambda_inv_0_11_p1;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_11_p8 = c18 * Lambda_inv_0_11_p6 - s18 * Lambda_inv_0_11_p7;

  // link 17 (right_lowerarm), pose
  const Real Lambda_inv_0_11_p9 = c17 * Lambda_inv_0_11_p5 - s17 * Lambda_inv_0_11_p4;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_11_p10 = c19 * Lambda_inv_0_11_p9 - s19 * Lambda_inv_0_11_p8;

  // link 18 (right_wrist1), pose
  const Real Lambda_inv_0_11_p11 = s18 * Lambda_inv_0_11_p6 + c18 * Lambda_inv_0_11_p7;

  // link 20 (right_hand), pose
  const Real Lambda_inv_0_11_p12 = c20 * Lambda_inv_0_11_p10 - s20 * Lambda_inv_0_11_p11;

  // link 19 (right_wrist2), pose
  const Real Lambda_inv_0_11_p13 = c19 * Lambda_inv_0_11_p8 + s19 * Lambda_inv_0_11_p9;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_inv_0_9_p1_lanes = 0.11533812622014242 *
      detail::make_lanes<Real>(Lambda_inv_0_6_p27, Lambda_inv_0_6_p27, Lambda_inv_0_7_p21,
      Lambda_inv_0_11_p13, Lambda_inv_0_6_p27, Lambda_inv_0_6_p27, Lambda_inv_0_6_p27,
      Lambda_inv_0_6_p27);
  const Lanes Lambda_inv_0_9_p2_lanes = detail::make_lanes<Real>(Lambda_inv_0_6_p22,
      Lambda_inv_0_6_p22, Lambda_inv_0_7_p17, Lambda_inv_0_11_p12, Lambda_inv_0_6_p22,
      Lambda_inv_0_6_p22, Lambda_inv_0_6_p22, Lambda_inv_0_6_p22) + Lambda_inv_0_9_p1_lanes;

  // link 20 (right_hand), pose
  const Real Lambda_inv_0_8_p1 = s20 * Lambda_inv_0_11_p10 + c20 * Lambda_inv_0_11_p11;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_0_8_p2 = -(0.086 * Lambda_inv_0_8_p1);
  const Real Lambda_inv_0_8_p3 = 0.11533812622014242 * Lambda_inv_0_8_p2;
  const Lanes Lambda_inv_0_8_p4_lanes = c20 * detail::make_lanes<Real>(Lambda_inv_0_8_p3,
      Lambda_inv_0_9_p2_lanes[1], Lambda_inv_0_9_p2_lanes[2], Lambda_inv_0_9_p2_lanes[3],
      Lambda_inv_0_8_p3, Lambda_inv_0_8_p3, Lambda_inv_0_8_p3, Lambda_inv_0_8_p3);
  const Real Lambda_inv_0_11_p17 = -Lambda_inv_0_8_p1;
  const Lanes Lambda_inv_0_8_p5_lanes = 0.04672761636452121 *
      detail::make_lanes<Real>(Lambda_inv_0_8_p2, Lambda_inv_0_6_p27, Lambda_inv_0_7_p21,
      Lambda_inv_0_11_p13, Lambda_inv_0_8_p2, Lambda_inv_0_8_p2, Lambda_inv_0_8_p2,
      Lambda_inv_0_8_p2);
  const Lanes Lambda_inv_0_8_p6_lanes = detail::make_lanes<Real>(-(0.086 * Lambda_inv_0_11_p13),
      Lambda_inv_0_6_p23, Lambda_inv_0_7_p18, Lambda_inv_0_11_p17, -(0.086 * Lambda_inv_0_11_p13),
      -(0.086 * Lambda_inv_0_11_p13), -(0.086 * Lambda_inv_0_11_p13),
      -(0.086 * Lambda_inv_0_11_p13)) + Lambda_inv_0_8_p5_lanes;
  const Lanes Lambda_inv_0_8_p7_lanes = s20 * Lambda_inv_0_8_p6_lanes;
  const Lanes Lambda_inv_0_8_p8_lanes = Lambda_inv_0_8_p4_lanes - Lambda_inv_0_8_p7_lanes;
  const Lanes Lambda_inv_0_8_p9_lanes = s20 * detail::make_lanes<Real>(Lambda_inv_0_8_p3,
      Lambda_inv_0_9_p2_lanes[1], Lambda_inv_0_9_p2_lanes[2], Lambda_inv_0_9_p2_lanes[3],
      Lambda_inv_0_8_p3, Lambda_inv_0_8_p3, Lambda_inv_0_8_p3, Lambda_inv_0_8_p3);
  const Lanes Lambda_inv_0_8_p10_lanes = c20 * Lambda_inv_0_8_p6_lanes;
  const Lanes Lambda_inv_0_8_p11_lanes = Lambda_inv_0_8_p9_lanes + Lambda_inv_0_8_p10_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_0_8_p12_lanes = Lambda_inv_0_0_p186 * Lambda_inv_0_8_p11_lanes;
  const Lanes Lambda_inv_0_8_p13_lanes = Lambda_inv_0_8_p8_lanes - Lambda_inv_0_8_p12_lanes;
  const Lanes Lambda_inv_0_8_p14_lanes = s19 * Lambda_inv_0_8_p13_lanes;
  const Lanes Lambda_inv_0_8_p15_lanes = Lambda_inv_0_0_p192 * Lambda_inv_0_8_p11_lanes;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_inv_0_9_p15_lanes = 3.0523172236718206 *
      detail::make_lanes<Real>(Lambda_inv_0_6_p27, Lambda_inv_0_6_p27, Lambda_inv_0_7_p21,
      Lambda_inv_0_11_p13, Lambda_inv_0_6_p27, Lambda_inv_0_6_p27, Lambda_inv_0_6_p27,
      Lambda_inv_0_6_p27);
  const Lanes Lambda_inv_0_9_p16_lanes = s20 * Lambda_inv_0_9_p15_lanes;
  const Lanes Lambda_inv_0_9_p17_lanes = 17.32841575379867 *
      detail::make_lanes<Real>(Lambda_inv_0_6_p27, Lambda_inv_0_6_p27, Lambda_inv_0_7_p21,
      Lambda_inv_0_11_p13, Lambda_inv_0_6_p27, Lambda_inv_0_6_p27, Lambda_inv_0_6_p27,
      Lambda_inv_0_6_p27);
  const Lanes Lambda_inv_0_9_p18_lanes = c20 * Lambda_inv_0_9_p17_lanes;
  const Lanes Lambda_inv_0_9_p19_lanes = Lambda_inv_0_9_p16_lanes - Lambda_inv_0_9_p18_lanes;
  const Real Lambda_inv_0_8_p16 = Lambda_inv_0_11_p12 + 3.0523172236718206 * Lambda_inv_0_8_p2;
  const Real Lambda_inv_0_8_p17 = Lambda_inv_0_11_p17 - 17.32841575379867 * Lambda_inv_0_8_p2;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_0_8_p18_lanes = detail::make_lanes<Real>(s20 * Lambda_inv_0_8_p16 + c20 *
      Lambda_inv_0_8_p17, Lambda_inv_0_9_p19_lanes[1], Lambda_inv_0_9_p19_lanes[2],
      Lambda_inv_0_9_p19_lanes[3], s20 * Lambda_inv_0_8_p16 + c20 * Lambda_inv_0_8_p17, s20 *
      Lambda_inv_0_8_p16 + c20 * Lambda_inv_0_8_p17, s20 * Lambda_inv_0_8_p16 + c20 *
      Lambda_inv_0_8_p17, s20 * Lambda_inv_0_8_p16 + c20 * Lambda_inv_0_8_p17) -
      Lambda_inv_0_8_p15_lanes;
  const Lanes Lambda_inv_0_8_p19_lanes = 0.269 * Lambda_inv_0_8_p18_lanes;
  const Lanes Lambda_inv_0_8_p20_lanes = Lambda_inv_0_8_p19_lanes - Lambda_inv_0_8_p14_lanes;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_0_11_p37 = -(c19 * Lambda_inv_0_8_p13_lanes[3]);
  const Real Lambda_inv_0_10_p23 = -(c19 * Lambda_inv_0_8_p13_lanes[2]);
  const Real Lambda_inv_0_9_p23 = -(c19 * Lambda_inv_0_8_p13_lanes[1]);
  const Real Lambda_inv_0_8_p21 = -(c19 * Lambda_inv_0_8_p13_lanes[0]);
  const Lanes Lambda_inv_0_8_p22_lanes = inverse_D17_p1 *
      detail::make_lanes<Real>(Lambda_inv_0_8_p21, Lambda_inv_0_9_p23, Lambda_inv_0_10_p23,
      Lambda_inv_0_11_p37, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21,
      Lambda_inv_0_8_p21);
  const Lanes Lambda_inv_0_8_p23_lanes = Lambda_inv_0_8_p20_lanes - Lambda_inv_0_8_p22_lanes;
  const Lanes Lambda_inv_0_8_p24_lanes = c18 * Lambda_inv_0_8_p23_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_0_9_p27_lanes = Lambda_inv_0_0_p209 * Lambda_inv_0_8_p11_lanes;
  const Lanes Lambda_inv_0_9_p28_lanes = c19 * Lambda_inv_0_9_p27_lanes;
  const Lanes Lambda_inv_0_9_p29_lanes = Lambda_inv_0_0_p206 * Lambda_inv_0_8_p11_lanes;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_inv_0_9_p30_lanes = c20 * Lambda_inv_0_9_p15_lanes;
  const Lanes Lambda_inv_0_9_p31_lanes = s20 * Lambda_inv_0_9_p17_lanes;
  const Lanes Lambda_inv_0_9_p32_lanes = Lambda_inv_0_9_p30_lanes + Lambda_inv_0_9_p31_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_0_9_p33_lanes = Lambda_inv_0_9_p32_lanes - Lambda_inv_0_9_p29_lanes;
  const Lanes Lambda_inv_0_9_p34_lanes = s19 * Lambda_inv_0_9_p33_lanes;
  const Lanes Lambda_inv_0_9_p35_lanes = Lambda_inv_0_9_p28_lanes + Lambda_inv_0_9_p34_lanes;
  const Real Lambda_inv_0_8_p25 = c20 * Lambda_inv_0_8_p16 - s20 * Lambda_inv_0_8_p17 -
      Lambda_inv_0_0_p206 * Lambda_inv_0_8_p11_lanes[0];
  const Real Lambda_inv_0_8_p26 = Lambda_inv_0_11_p13 - Lambda_inv_0_0_p209 *
      Lambda_inv_0_8_p11_lanes[0];
  const Real Lambda_inv_0_8_p27 = s19 * Lambda_inv_0_8_p25 - c19 * Lambda_inv_0_8_p26;
  const Lanes Lambda_inv_0_8_p28_lanes = 0.269 * detail::make_lanes<Real>(Lambda_inv_0_8_p27,
      Lambda_inv_0_9_p35_lanes[1], Lambda_inv_0_9_p35_lanes[2], Lambda_inv_0_9_p35_lanes[3],
      Lambda_inv_0_8_p27, Lambda_inv_0_8_p27, Lambda_inv_0_8_p27, Lambda_inv_0_8_p27);

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_0_8_p29_lanes = inverse_D17_p3 *
      detail::make_lanes<Real>(Lambda_inv_0_8_p21, Lambda_inv_0_9_p23, Lambda_inv_0_10_p23,
      Lambda_inv_0_11_p37, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21,
      Lambda_inv_0_8_p21);
  const Lanes Lambda_inv_0_8_p30_lanes = Lambda_inv_0_8_p28_lanes - Lambda_inv_0_8_p29_lanes;
  const Lanes Lambda_inv_0_8_p31_lanes = s18 * Lambda_inv_0_8_p30_lanes;
  const Lanes Lambda_inv_0_8_p32_lanes = Lambda_inv_0_8_p24_lanes - Lambda_inv_0_8_p31_lanes;
  const Lanes Lambda_inv_0_8_p33_lanes = s18 * Lambda_inv_0_8_p23_lanes;
  const Lanes Lambda_inv_0_8_p34_lanes = c18 * Lambda_inv_0_8_p30_lanes;
  const Lanes Lambda_inv_0_8_p35_lanes = Lambda_inv_0_8_p33_lanes + Lambda_inv_0_8_p34_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_0_8_p36_lanes = Lambda_inv_0_0_p243 * Lambda_inv_0_8_p35_lanes;
  const Lanes Lambda_inv_0_8_p37_lanes = Lambda_inv_0_8_p32_lanes - Lambda_inv_0_8_p36_lanes;
  const Lanes Lambda_inv_0_8_p38_lanes = c17 * Lambda_inv_0_8_p37_lanes;
  const Lanes Lambda_inv_0_8_p39_lanes = Lambda_inv_0_0_p240 * Lambda_inv_0_8_p35_lanes;
  const Lanes Lambda_inv_0_8_p40_lanes = s17 * Lambda_inv_0_8_p39_lanes;
  const Lanes Lambda_inv_0_8_p41_lanes = Lambda_inv_0_8_p38_lanes + Lambda_inv_0_8_p40_lanes;
  const Lanes Lambda_inv_0_8_p42_lanes = Lambda_inv_0_0_p234 * Lambda_inv_0_8_p35_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_0_8_p43_lanes = Lambda_inv_0_0_p214 *
      detail::make_lanes<Real>(Lambda_inv_0_8_p21, Lambda_inv_0_9_p23, Lambda_inv_0_10_p23,
      Lambda_inv_0_11_p37, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21,
      Lambda_inv_0_8_p21);
  const Lanes Lambda_inv_0_8_p44_lanes = detail::make_lanes<Real>(-Lambda_inv_0_8_p27,
      -Lambda_inv_0_9_p35_lanes[1], -Lambda_inv_0_9_p35_lanes[2], -Lambda_inv_0_9_p35_lanes[3],
      -Lambda_inv_0_8_p27, -Lambda_inv_0_8_p27, -Lambda_inv_0_8_p27, -Lambda_inv_0_8_p27) -
      Lambda_inv_0_8_p43_lanes;
  const Lanes Lambda_inv_0_8_p45_lanes = s18 * Lambda_inv_0_8_p44_lanes;
  const Lanes Lambda_inv_0_8_p46_lanes = Lambda_inv_0_0_p198 *
      detail::make_lanes<Real>(Lambda_inv_0_8_p21, Lambda_inv_0_9_p23, Lambda_inv_0_10_p23,
      Lambda_inv_0_11_p37, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21,
      Lambda_inv_0_8_p21);
  const Lanes Lambda_inv_0_8_p47_lanes = Lambda_inv_0_8_p18_lanes - Lambda_inv_0_8_p46_lanes;
  const Lanes Lambda_inv_0_8_p48_lanes = c18 * Lambda_inv_0_8_p47_lanes;
  const Lanes Lambda_inv_0_8_p49_lanes = Lambda_inv_0_8_p45_lanes + Lambda_inv_0_8_p48_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_0_8_p50_lanes = Lambda_inv_0_8_p49_lanes - Lambda_inv_0_8_p42_lanes;
  const Lanes Lambda_inv_0_8_p51_lanes = 0.282 * Lambda_inv_0_8_p50_lanes;
  const Lanes Lambda_inv_0_8_p52_lanes = Lambda_inv_0_8_p41_lanes + Lambda_inv_0_8_p51_lanes;
  const Lanes Lambda_inv_0_8_p53_lanes = s17 * Lambda_inv_0_8_p37_lanes;
  const Lanes Lambda_inv_0_8_p54_lanes = c17 * Lambda_inv_0_8_p39_lanes;
  const Lanes Lambda_inv_0_8_p55_lanes = Lambda_inv_0_8_p54_lanes - Lambda_inv_0_8_p53_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_0_8_p56_lanes = inverse_D15_p1 * Lambda_inv_0_8_p55_lanes;
  const Lanes Lambda_inv_0_8_p57_lanes = Lambda_inv_0_8_p52_lanes - Lambda_inv_0_8_p56_lanes;
  const Lanes Lambda_inv_0_8_p58_lanes = c16 * Lambda_inv_0_8_p57_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_0_8_p59_lanes = Lambda_inv_0_0_p258 * Lambda_inv_0_8_p35_lanes;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_0_9_p68_lanes = s19 * Lambda_inv_0_9_p27_lanes;
  const Lanes Lambda_inv_0_9_p69_lanes = c19 * Lambda_inv_0_9_p33_lanes;
  const Lanes Lambda_inv_0_9_p70_lanes = Lambda_inv_0_9_p68_lanes - Lambda_inv_0_9_p69_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_0_8_p60_lanes = detail::make_lanes<Real>(-(-(s19 * Lambda_inv_0_8_p26 +
      c19 * Lambda_inv_0_8_p25) - Lambda_inv_0_0_p253 * Lambda_inv_0_8_p21),
      -(Lambda_inv_0_9_p70_lanes[1] - Lambda_inv_0_0_p253 * Lambda_inv_0_9_p23),
      -(Lambda_inv_0_9_p70_lanes[2] - Lambda_inv_0_0_p253 * Lambda_inv_0_10_p23),
      -(Lambda_inv_0_9_p70_lanes[3] - Lambda_inv_0_0_p253 * Lambda_inv_0_11_p37),
      -(-(s19 * Lambda_inv_0_8_p26 + c19 * Lambda_inv_0_8_p25) - Lambda_inv_0_0_p253 *
      Lambda_inv_0_8_p21), -(-(s19 * Lambda_inv_0_8_p26 + c19 * Lambda_inv_0_8_p25) -
      Lambda_inv_0_0_p253 * Lambda_inv_0_8_p21), -(-(s19 * Lambda_inv_0_8_p26 + c19 *
      Lambda_inv_0_8_p25) - Lambda_inv_0_0_p253 * Lambda_inv_0_8_p21),
      -(-(s19 * Lambda_inv_0_8_p26 + c19 * Lambda_inv_0_8_p25) - Lambda_inv_0_0_p253 *
      Lambda_inv_0_8_p21)) - Lambda_inv_0_8_p59_lanes;
  const Lanes Lambda_inv_0_8_p61_lanes = s17 * Lambda_inv_0_8_p60_lanes;
  const Lanes Lambda_inv_0_8_p62_lanes = Lambda_inv_0_0_p249 * Lambda_inv_0_8_p35_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_0_8_p63_lanes = c18 * Lambda_inv_0_8_p44_lanes;
  const Lanes Lambda_inv_0_8_p64_lanes = s18 * Lambda_inv_0_8_p47_lanes;
  const Lanes Lambda_inv_0_8_p65_lanes = Lambda_inv_0_8_p63_lanes - Lambda_inv_0_8_p64_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_0_8_p66_lanes = Lambda_inv_0_8_p65_lanes - Lambda_inv_0_8_p62_lanes;
  const Lanes Lambda_inv_0_8_p67_lanes = c17 * Lambda_inv_0_8_p66_lanes;
  const Lanes Lambda_inv_0_8_p68_lanes = Lambda_inv_0_8_p61_lanes - Lambda_inv_0_8_p67_lanes;
  const Lanes Lambda_inv_0_8_p69_lanes = 0.282 * Lambda_inv_0_8_p68_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_0_8_p70_lanes = inverse_D15_p3 * Lambda_inv_0_8_p55_lanes;
  const Lanes Lambda_inv_0_8_p71_lanes = Lambda_inv_0_8_p69_lanes - Lambda_inv_0_8_p70_lanes;
  const Lanes Lambda_inv_0_8_p72_lanes = s16 * Lambda_inv_0_8_p71_lanes;
  const Lanes Lambda_inv_0_8_p73_lanes = Lambda_inv_0_8_p58_lanes - Lambda_inv_0_8_p72_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_0_8_p74_lanes = Lambda_inv_0_0_p317 * Lambda_inv_0_8_p73_lanes;
  const Lanes Lambda_inv_0_8_p75_lanes = detail::make_lanes<Real>(-(-(s17 *
      Lambda_inv_0_8_p66_lanes[0] + c17 * Lambda_inv_0_8_p60_lanes[0]) + Lambda_inv_0_0_p311 *
      Lambda_inv_0_8_p55_lanes[0]), -(-(s17 * Lambda_inv_0_8_p66_lanes[1] + c17 *
      Lambda_inv_0_8_p60_lanes[1]) + Lambda_inv_0_0_p311 * Lambda_inv_0_8_p55_lanes[1]),
      -(-(s17 * Lambda_inv_0_8_p66_lanes[2] + c17 * Lambda_inv_0_8_p60_lanes[2]) +
      Lambda_inv_0_0_p311 * Lambda_inv_0_8_p55_lanes[2]),
      -(-(s17 * Lambda_inv_0_8_p66_lanes[3] + c17 * Lambda_inv_0_8_p60_lanes[3]) +
      Lambda_inv_0_0_p311 * Lambda_inv_0_8_p55_lanes[3]),
      -(-(s17 * Lambda_inv_0_8_p66_lanes[0] + c17 * Lambda_inv_0_8_p60_lanes[0]) +
      Lambda_inv_0_0_p311 * Lambda_inv_0_8_p55_lanes[0]),
      -(-(s17 * Lambda_inv_0_8_p66_lanes[0] + c17 * Lambda_inv_0_8_p60_lanes[0]) +
      Lambda_inv_0_0_p311 * Lambda_inv_0_8_p55_lanes[0]),
      -(-(s17 * Lambda_inv_0_8_p66_lanes[0] + c17 * Lambda_inv_0_8_p60_lanes[0]) +
      Lambda_inv_0_0_p311 * Lambda_inv_0_8_p55_lanes[0]),
      -(-(s17 * Lambda_inv_0_8_p66_lanes[0] + c17 * Lambda_inv_0_8_p60_lanes[0]) +
      Lambda_inv_0_0_p311 * Lambda_inv_0_8_p55_lanes[0])) - Lambda_inv_0_8_p74_lanes;
  const Lanes Lambda_inv_0_8_p76_lanes = c15 * Lambda_inv_0_8_p75_lanes;
  const Lanes Lambda_inv_0_8_p77_lanes = Lambda_inv_0_0_p308 * Lambda_inv_0_8_p73_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_0_8_p78_lanes = Lambda_inv_0_0_p266 * Lambda_inv_0_8_p55_lanes;
  const Lanes Lambda_inv_0_8_p79_lanes = detail::make_lanes<Real>(-Lambda_inv_0_8_p68_lanes[0],
      -Lambda_inv_0_8_p68_lanes[1], -Lambda_inv_0_8_p68_lanes[2], -Lambda_inv_0_8_p68_lanes[3],
      -Lambda_inv_0_8_p68_lanes[0], -Lambda_inv_0_8_p68_lanes[0], -Lambda_inv_0_8_p68_lanes[0],
      -Lambda_inv_0_8_p68_lanes[0]) - Lambda_inv_0_8_p78_lanes;
  const Lanes Lambda_inv_0_8_p80_lanes = s16 * Lambda_inv_0_8_p79_lanes;
  const Lanes Lambda_inv_0_8_p81_lanes = Lambda_inv_0_0_p281 * Lambda_inv_0_8_p55_lanes;
  const Lanes Lambda_inv_0_8_p82_lanes = Lambda_inv_0_8_p50_lanes - Lambda_inv_0_8_p81_lanes;
  const Lanes Lambda_inv_0_8_p83_lanes = c16 * Lambda_inv_0_8_p82_lanes;
  const Lanes Lambda_inv_0_8_p84_lanes = Lambda_inv_0_8_p80_lanes + Lambda_inv_0_8_p83_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_0_8_p85_lanes = Lambda_inv_0_8_p84_lanes - Lambda_inv_0_8_p77_lanes;
  const Lanes Lambda_inv_0_8_p86_lanes = s15 * Lambda_inv_0_8_p85_lanes;
  const Lanes Lambda_inv_0_8_p87_lanes = Lambda_inv_0_8_p76_lanes - Lambda_inv_0_8_p86_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_0_8_p88_lanes = s16 * Lambda_inv_0_8_p57_lanes;
  const Lanes Lambda_inv_0_8_p89_lanes = c16 * Lambda_inv_0_8_p71_lanes;
  const Lanes Lambda_inv_0_8_p90_lanes = Lambda_inv_0_8_p88_lanes + Lambda_inv_0_8_p89_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_0_8_p91_lanes = inverse_D14_p1 * Lambda_inv_0_8_p73_lanes;
  const Lanes Lambda_inv_0_8_p92_lanes = Lambda_inv_0_8_p90_lanes - Lambda_inv_0_8_p91_lanes;
  const Lanes Lambda_inv_0_8_p93_lanes = c15 * Lambda_inv_0_8_p92_lanes;
  const Lanes Lambda_inv_0_8_p94_lanes = Lambda_inv_0_7_p1 * Lambda_inv_0_8_p73_lanes;
  const Lanes Lambda_inv_0_8_p95_lanes = s15 * Lambda_inv_0_8_p94_lanes;
  const Lanes Lambda_inv_0_8_p96_lanes = Lambda_inv_0_8_p95_lanes + Lambda_inv_0_8_p93_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_0_8_p97_lanes = Lambda_inv_0_0_p324 * Lambda_inv_0_8_p96_lanes;
  const Lanes Lambda_inv_0_8_p98_lanes = Lambda_inv_0_8_p87_lanes - Lambda_inv_0_8_p97_lanes;
  const Lanes Lambda_inv_0_8_p99_lanes = c14 * Lambda_inv_0_8_p98_lanes;
  const Lanes Lambda_inv_0_8_p100_lanes = Lambda_inv_0_0_p305 * Lambda_inv_0_8_p96_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_0_8_p101_lanes = Lambda_inv_0_0_p299 * Lambda_inv_0_8_p73_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_0_8_p102_lanes = c16 * Lambda_inv_0_8_p79_lanes;
  const Lanes Lambda_inv_0_8_p103_lanes = s16 * Lambda_inv_0_8_p82_lanes;
  const Lanes Lambda_inv_0_8_p104_lanes = Lambda_inv_0_8_p102_lanes - Lambda_inv_0_8_p103_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_0_8_p105_lanes = Lambda_inv_0_8_p104_lanes - Lambda_inv_0_8_p101_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_0_8_p106_lanes = Lambda_inv_0_8_p105_lanes - Lambda_inv_0_8_p100_lanes;
  const Lanes Lambda_inv_0_8_p107_lanes = s14 * Lambda_inv_0_8_p106_lanes;
  const Lanes Lambda_inv_0_8_p108_lanes = Lambda_inv_0_8_p107_lanes + Lambda_inv_0_8_p99_lanes;
  const Lanes Lambda_inv_0_8_p109_lanes = 0.18 * Lambda_inv_0_8_p108_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_0_8_p110_lanes = s15 * Lambda_inv_0_8_p75_lanes;
  const Lanes Lambda_inv_0_8_p111_lanes = c15 * Lambda_inv_0_8_p85_lanes;
  const Lanes Lambda_inv_0_8_p112_lanes = Lambda_inv_0_8_p110_lanes + Lambda_inv_0_8_p111_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_0_8_p113_lanes = Lambda_inv_0_0_p334 * Lambda_inv_0_8_p96_lanes;
  const Lanes Lambda_inv_0_8_p114_lanes = Lambda_inv_0_8_p112_lanes - Lambda_inv_0_8_p113_lanes;
  const Lanes Lambda_inv_0_8_p115_lanes = 0.226 * Lambda_inv_0_8_p114_lanes;
  const Lanes Lambda_inv_0_8_p116_lanes = Lambda_inv_0_8_p109_lanes - Lambda_inv_0_8_p115_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_0_8_p117_lanes = s15 * Lambda_inv_0_8_p92_lanes;
  const Lanes Lambda_inv_0_8_p118_lanes = c15 * Lambda_inv_0_8_p94_lanes;
  const Lanes Lambda_inv_0_8_p119_lanes = Lambda_inv_0_8_p118_lanes - Lambda_inv_0_8_p117_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_0_8_p120_lanes = inverse_D6_p1 * Lambda_inv_0_8_p96_lanes;
  const Lanes Lambda_inv_0_8_p121_lanes = Lambda_inv_0_8_p119_lanes - Lambda_inv_0_8_p120_lanes;
  const Lanes Lambda_inv_0_8_p122_lanes = s14 * Lambda_inv_0_8_p121_lanes;
  const Lanes Lambda_inv_0_8_p123_lanes = Lambda_inv_0_7_p65 * Lambda_inv_0_8_p96_lanes;
  const Lanes Lambda_inv_0_8_p124_lanes = c14 * Lambda_inv_0_8_p123_lanes;
  const Lanes Lambda_inv_0_8_p125_lanes = Lambda_inv_0_8_p124_lanes + Lambda_inv_0_8_p122_lanes;
  const Lanes Lambda_inv_0_8_p126_lanes = Lambda_inv_0_8_p116_lanes - Lambda_inv_0_8_p125_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_8_p127_lanes = inverse_D5_p14 * Lambda_inv_0_8_p126_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_0_8_p128_lanes = s14 * Lambda_inv_0_8_p98_lanes;
  const Lanes Lambda_inv_0_8_p129_lanes = c14 * Lambda_inv_0_8_p106_lanes;
  const Lanes Lambda_inv_0_8_p130_lanes = Lambda_inv_0_8_p129_lanes - Lambda_inv_0_8_p128_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_8_p131_lanes = detail::make_lanes<Real>(-(s14 *
      Lambda_inv_0_8_p123_lanes[0] - c14 * Lambda_inv_0_8_p121_lanes[0] + 0.18 *
      Lambda_inv_0_8_p130_lanes[0]), -(s14 * Lambda_inv_0_8_p123_lanes[1] - c14 *
      Lambda_inv_0_8_p121_lanes[1] + 0.18 * Lambda_inv_0_8_p130_lanes[1]),
      -(s14 * Lambda_inv_0_8_p123_lanes[2] - c14 * Lambda_inv_0_8_p121_lanes[2] + 0.18 *
      Lambda_inv_0_8_p130_lanes[2]), -(s14 * Lambda_inv_0_8_p123_lanes[3] - c14 *
      Lambda_inv_0_8_p121_lanes[3] + 0.18 * Lambda_inv_0_8_p130_lanes[3]),
      -(s14 * Lambda_inv_0_8_p123_lanes[0] - c14 * Lambda_inv_0_8_p121_lanes[0] + 0.18 *
      Lambda_inv_0_8_p130_lanes[0]), -(s14 * Lambda_inv_0_8_p123_lanes[0] - c14 *
      Lambda_inv_0_8_p121_lanes[0] + 0.18 * Lambda_inv_0_8_p130_lanes[0]),
      -(s14 * Lambda_inv_0_8_p123_lanes[0] - c14 * Lambda_inv_0_8_p121_lanes[0] + 0.18 *
      Lambda_inv_0_8_p130_lanes[0]), -(s14 * Lambda_inv_0_8_p123_lanes[0] - c14 *
      Lambda_inv_0_8_p121_lanes[0] + 0.18 * Lambda_inv_0_8_p130_lanes[0])) -
      Lambda_inv_0_8_p127_lanes;
  const Lanes Lambda_inv_0_8_p132_lanes = s6 * Lambda_inv_0_8_p131_lanes;
  const Lanes Lambda_inv_0_8_p133_lanes = inverse_D5_p16 * Lambda_inv_0_8_p126_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_0_8_p134_lanes = 0.226 * Lambda_inv_0_8_p130_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_8_p135_lanes = Lambda_inv_0_8_p134_lanes - Lambda_inv_0_8_p133_lanes;
  const Lanes Lambda_inv_0_8_p136_lanes = c6 * Lambda_inv_0_8_p135_lanes;
  const Lanes Lambda_inv_0_8_p137_lanes = Lambda_inv_0_8_p132_lanes + Lambda_inv_0_8_p136_lanes;
  const Lanes Lambda_inv_0_8_p138_lanes = Lambda_inv_0_0_p450 * Lambda_inv_0_8_p126_lanes;
  const Lanes Lambda_inv_0_8_p139_lanes = Lambda_inv_0_8_p130_lanes - Lambda_inv_0_8_p138_lanes;
  const Lanes Lambda_inv_0_8_p140_lanes = 0.072 * Lambda_inv_0_8_p139_lanes;
  const Lanes Lambda_inv_0_8_p141_lanes = Lambda_inv_0_8_p137_lanes + Lambda_inv_0_8_p140_lanes;
  const Lanes Lambda_inv_0_8_p142_lanes = Lambda_inv_0_0_p410 * Lambda_inv_0_8_p126_lanes;
  const Lanes Lambda_inv_0_8_p143_lanes = Lambda_inv_0_8_p108_lanes - Lambda_inv_0_8_p142_lanes;
  const Lanes Lambda_inv_0_8_p144_lanes = s6 * Lambda_inv_0_8_p143_lanes;
  const Lanes Lambda_inv_0_8_p145_lanes = Lambda_inv_0_0_p441 * Lambda_inv_0_8_p126_lanes;
  const Lanes Lambda_inv_0_8_p146_lanes = Lambda_inv_0_8_p114_lanes - Lambda_inv_0_8_p145_lanes;
  const Lanes Lambda_inv_0_8_p147_lanes = c6 * Lambda_inv_0_8_p146_lanes;
  const Lanes Lambda_inv_0_8_p148_lanes = Lambda_inv_0_8_p144_lanes + Lambda_inv_0_8_p147_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_11_p174 = -(0.072 * Lambda_inv_0_8_p148_lanes[3]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_8_p141_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_8_p149_lanes = c6 * Lambda_inv_0_8_p131_lanes;
  const Lanes Lambda_inv_0_8_p150_lanes = s6 * Lambda_inv_0_8_p135_lanes;
  const Lanes Lambda_inv_0_8_p151_lanes = Lambda_inv_0_8_p149_lanes - Lambda_inv_0_8_p150_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_11_p178 = Lambda_inv_0_8_p151_lanes[3] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_8_p141_lanes[3];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_11_p179 = -(s5 * Lambda_inv_0_11_p174 + c5 * Lambda_inv_0_11_p178);

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_10_p163 = -(0.072 * Lambda_inv_0_8_p148_lanes[2]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_8_p141_lanes[2];
  const Real Lambda_inv_0_10_p164 = Lambda_inv_0_8_p151_lanes[2] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_8_p141_lanes[2];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_10_p165 = -(s5 * Lambda_inv_0_10_p163 + c5 * Lambda_inv_0_10_p164);

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_9_p163 = -(0.072 * Lambda_inv_0_8_p148_lanes[1]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_8_p141_lanes[1];
  const Real Lambda_inv_0_9_p164 = Lambda_inv_0_8_p151_lanes[1] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_8_p141_lanes[1];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_9_p165 = -(s5 * Lambda_inv_0_9_p163 + c5 * Lambda_inv_0_9_p164);

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_8_p152 = -(0.072 * Lambda_inv_0_8_p148_lanes[0]) + Lambda_inv_0_0_p477 *
      Lambda_inv_0_8_p141_lanes[0];
  const Real Lambda_inv_0_8_p153 = Lambda_inv_0_8_p151_lanes[0] - Lambda_inv_0_0_p479 *
      Lambda_inv_0_8_p141_lanes[0];

  // link 4 (chest1), force propagation
  const Real Lambda_inv_0_8_p154 = -(s5 * Lambda_inv_0_8_p152 + c5 * Lambda_inv_0_8_p153);
  const Lanes Lambda_inv_0_8_p155_lanes = inverse_D3_p1 *
      detail::make_lanes<Real>(Lambda_inv_0_8_p154, Lambda_inv_0_9_p165, Lambda_inv_0_10_p165,
      Lambda_inv_0_11_p179, Lambda_inv_0_8_p154, Lambda_inv_0_8_p154, Lambda_inv_0_8_p154,
      Lambda_inv_0_8_p154);

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_0_8_p156_lanes = Lambda_inv_0_0_p462 * Lambda_inv_0_8_p141_lanes;
  const Lanes Lambda_inv_0_8_p157_lanes = Lambda_inv_0_8_p148_lanes - Lambda_inv_0_8_p156_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_0_8_p158_lanes = detail::make_lanes<Real>(-(s5 * Lambda_inv_0_8_p153 - c5 *
      Lambda_inv_0_8_p152 + 0.21799999999999997 * Lambda_inv_0_8_p157_lanes[0]),
      -(s5 * Lambda_inv_0_9_p164 - c5 * Lambda_inv_0_9_p163 + 0.21799999999999997 *
      Lambda_inv_0_8_p157_lanes[1]), -(s5 * Lambda_inv_0_10_p164 - c5 * Lambda_inv_0_10_p163 +
      0.21799999999999997 * Lambda_inv_0_8_p157_lanes[2]),
      -(s5 * Lambda_inv_0_11_p178 - c5 * Lambda_inv_0_11_p174 + 0.21799999999999997 *
      Lambda_inv_0_8_p157_lanes[3]), -(s5 * Lambda_inv_0_8_p153 - c5 * Lambda_inv_0_8_p152 +
      0.21799999999999997 * Lambda_inv_0_8_p157_lanes[0]),
      -(s5 * Lambda_inv_0_8_p153 - c5 * Lambda_inv_0_8_p152 + 0.21799999999999997 *
      Lambda_inv_0_8_p157_lanes[0]), -(s5 * Lambda_inv_0_8_p153 - c5 * Lambda_inv_0_8_p152 +
      0.21799999999999997 * Lambda_inv_0_8_p157_lanes[0]),
      -(s5 * Lambda_inv_0_8_p153 - c5 * Lambda_inv_0_8_p152 + 0.21799999999999997 *
      Lambda_inv_0_8_p157_lanes[0])) - Lambda_inv_0_8_p155_lanes;
  const Lanes Lambda_inv_0_8_p159_lanes = s4 * Lambda_inv_0_8_p158_lanes;
  const Lanes Lambda_inv_0_8_p160_lanes = inverse_D3_p2 *
      detail::make_lanes<Real>(Lambda_inv_0_8_p154, Lambda_inv_0_9_p165, Lambda_inv_0_10_p165,
      Lambda_inv_0_11_p179, Lambda_inv_0_8_p154, Lambda_inv_0_8_p154, Lambda_inv_0_8_p154,
      Lambda_inv_0_8_p154);

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_8_p161_lanes = c6 * Lambda_inv_0_8_p143_lanes;
  const Lanes Lambda_inv_0_8_p162_lanes = s6 * Lambda_inv_0_8_p146_lanes;
  const Lanes Lambda_inv_0_8_p163_lanes = Lambda_inv_0_8_p161_lanes - Lambda_inv_0_8_p162_lanes;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_0_11_p189 = Lambda_inv_0_8_p163_lanes[3] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_8_p141_lanes[3];
  const Real Lambda_inv_0_11_p190 = Lambda_inv_0_8_p139_lanes[3] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_8_p141_lanes[3];
  const Real Lambda_inv_0_11_p191 = s5 * Lambda_inv_0_11_p189 - c5 * Lambda_inv_0_11_p190;
  const Real Lambda_inv_0_10_p175 = Lambda_inv_0_8_p163_lanes[2] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_8_p141_lanes[2];
  const Real Lambda_inv_0_10_p176 = Lambda_inv_0_8_p139_lanes[2] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_8_p141_lanes[2];
  const Real Lambda_inv_0_10_p177 = s5 * Lambda_inv_0_10_p175 - c5 * Lambda_inv_0_10_p176;
  const Real Lambda_inv_0_9_p175 = Lambda_inv_0_8_p163_lanes[1] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_8_p141_lanes[1];
  const Real Lambda_inv_0_9_p176 = Lambda_inv_0_8_p139_lanes[1] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_8_p141_lanes[1];
  const Real Lambda_inv_0_9_p177 = s5 * Lambda_inv_0_9_p175 - c5 * Lambda_inv_0_9_p176;
  const Real Lambda_inv_0_8_p164 = Lambda_inv_0_8_p163_lanes[0] - Lambda_inv_0_0_p490 *
      Lambda_inv_0_8_p141_lanes[0];
  const Real Lambda_inv_0_8_p165 = Lambda_inv_0_8_p139_lanes[0] - Lambda_inv_0_0_p486 *
      Lambda_inv_0_8_p141_lanes[0];
  const Real Lambda_inv_0_8_p166 = s5 * Lambda_inv_0_8_p164 - c5 * Lambda_inv_0_8_p165;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_0_8_p167_lanes = detail::make_lanes<Real>(-(0.21799999999999997 *
      Lambda_inv_0_8_p166), -(0.21799999999999997 * Lambda_inv_0_9_p177),
      -(0.21799999999999997 * Lambda_inv_0_10_p177), -(0.21799999999999997 * Lambda_inv_0_11_p191),
      -(0.21799999999999997 * Lambda_inv_0_8_p166), -(0.21799999999999997 * Lambda_inv_0_8_p166),
      -(0.21799999999999997 * Lambda_inv_0_8_p166), -(0.21799999999999997 * Lambda_inv_0_8_p166)) +
      Lambda_inv_0_8_p160_lanes;
  const Lanes Lambda_inv_0_8_p168_lanes = c4 * Lambda_inv_0_8_p167_lanes;
  const Lanes Lambda_inv_0_8_p169_lanes = Lambda_inv_0_8_p159_lanes + Lambda_inv_0_8_p168_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_0_8_p170_lanes = Lambda_inv_0_0_p520 * Lambda_inv_0_8_p169_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_0_8_p171_lanes = Lambda_inv_0_0_p498 *
      detail::make_lanes<Real>(Lambda_inv_0_8_p154, Lambda_inv_0_9_p165, Lambda_inv_0_10_p165,
      Lambda_inv_0_11_p179, Lambda_inv_0_8_p154, Lambda_inv_0_8_p154, Lambda_inv_0_8_p154,
      Lambda_inv_0_8_p154);
  const Lanes Lambda_inv_0_8_p172_lanes = detail::make_lanes<Real>(-Lambda_inv_0_8_p166,
      -Lambda_inv_0_9_p177, -Lambda_inv_0_10_p177, -Lambda_inv_0_11_p191, -Lambda_inv_0_8_p166,
      -Lambda_inv_0_8_p166, -Lambda_inv_0_8_p166, -Lambda_inv_0_8_p166) + Lambda_inv_0_8_p171_lanes;
  const Lanes Lambda_inv_0_8_p173_lanes = c4 * Lambda_inv_0_8_p172_lanes;
  const Lanes Lambda_inv_0_8_p174_lanes = Lambda_inv_0_0_p507 *
      detail::make_lanes<Real>(Lambda_inv_0_8_p154, Lambda_inv_0_9_p165, Lambda_inv_0_10_p165,
      Lambda_inv_0_11_p179, Lambda_inv_0_8_p154, Lambda_inv_0_8_p154, Lambda_inv_0_8_p154,
      Lambda_inv_0_8_p154);
  const Lanes Lambda_inv_0_8_p175_lanes = Lambda_inv_0_8_p157_lanes + Lambda_inv_0_8_p174_lanes;
  const Lanes Lambda_inv_0_8_p176_lanes = s4 * Lambda_inv_0_8_p175_lanes;
  const Lanes Lambda_inv_0_8_p177_lanes = Lambda_inv_0_8_p173_lanes - Lambda_inv_0_8_p176_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_0_8_p178_lanes = Lambda_inv_0_8_p177_lanes - Lambda_inv_0_8_p170_lanes;
  const Lanes Lambda_inv_0_8_p179_lanes = c3 * Lambda_inv_0_8_p178_lanes;
  const Lanes Lambda_inv_0_8_p180_lanes = Lambda_inv_0_0_p530 * Lambda_inv_0_8_p169_lanes;
  const Lanes Lambda_inv_0_8_p181_lanes = detail::make_lanes<Real>(-(-(s5 * Lambda_inv_0_8_p165 +
      c5 * Lambda_inv_0_8_p164) - Lambda_inv_0_0_p525 * Lambda_inv_0_8_p154),
      -(-(s5 * Lambda_inv_0_9_p176 + c5 * Lambda_inv_0_9_p175) - Lambda_inv_0_0_p525 *
      Lambda_inv_0_9_p165), -(-(s5 * Lambda_inv_0_10_p176 + c5 * Lambda_inv_0_10_p175) -
      Lambda_inv_0_0_p525 * Lambda_inv_0_10_p165), -(-(s5 * Lambda_inv_0_11_p190 + c5 *
      Lambda_inv_0_11_p189) - Lambda_inv_0_0_p525 * Lambda_inv_0_11_p179),
      -(-(s5 * Lambda_inv_0_8_p165 + c5 * Lambda_inv_0_8_p164) - Lambda_inv_0_0_p525 *
      Lambda_inv_0_8_p154), -(-(s5 * Lambda_inv_0_8_p165 + c5 * Lambda_inv_0_8_p164) -
      Lambda_inv_0_0_p525 * Lambda_inv_0_8_p154), -(-(s5 * Lambda_inv_0_8_p165 + c5 *
      Lambda_inv_0_8_p164) - Lambda_inv_0_0_p525 * Lambda_inv_0_8_p154),
      -(-(s5 * Lambda_inv_0_8_p165 + c5 * Lambda_inv_0_8_p164) - Lambda_inv_0_0_p525 *
      Lambda_inv_0_8_p154)) + Lambda_inv_0_8_p180_lanes;
  const Lanes Lambda_inv_0_8_p182_lanes = s3 * Lambda_inv_0_8_p181_lanes;
  const Lanes Lambda_inv_0_8_p183_lanes = Lambda_inv_0_8_p179_lanes - Lambda_inv_0_8_p182_lanes;
  const Lanes Lambda_inv_0_8_p184_lanes = 0.422 * Lambda_inv_0_8_p183_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_0_8_p185_lanes = Lambda_inv_0_0_p537 * Lambda_inv_0_8_p184_lanes;
  const Lanes Lambda_inv_0_8_p186_lanes = Lambda_inv_0_8_p183_lanes - Lambda_inv_0_8_p185_lanes;
  const Lanes Lambda_inv_0_8_p187_lanes = c2 * Lambda_inv_0_8_p186_lanes;
  const Lanes Lambda_inv_0_8_p188_lanes = Lambda_inv_0_0_p735 * Lambda_inv_0_8_p184_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_0_8_p189_lanes = s3 * Lambda_inv_0_8_p178_lanes;
  const Lanes Lambda_inv_0_8_p190_lanes = c3 * Lambda_inv_0_8_p181_lanes;
  const Lanes Lambda_inv_0_8_p191_lanes = Lambda_inv_0_8_p189_lanes + Lambda_inv_0_8_p190_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_0_8_p192_lanes = Lambda_inv_0_8_p191_lanes - Lambda_inv_0_8_p188_lanes;
  const Lanes Lambda_inv_0_8_p193_lanes = s2 * Lambda_inv_0_8_p192_lanes;
  const Lanes Lambda_inv_0_8_p194_lanes = Lambda_inv_0_8_p187_lanes - Lambda_inv_0_8_p193_lanes;
  const Lanes Lambda_inv_0_8_p195_lanes = 0.434 * Lambda_inv_0_8_p194_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_0_8_p196_lanes = Lambda_inv_0_8_p195_lanes * inverse_D1;
  const Lanes Lambda_inv_0_8_p197_lanes = Lambda_inv_0_8_p196_lanes * Lambda_inv_0_0_p743_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_0_8_p198_lanes = Lambda_inv_0_8_p184_lanes * inverse_D2;
  const Lanes Lambda_inv_0_8_p199_lanes = Lambda_inv_0_8_p198_lanes * Lambda_inv_0_0_p729_lanes[0];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_0_8_p200_lanes = Lambda_inv_0_8_p169_lanes * inverse_D3;
  const Lanes Lambda_inv_0_8_p201_lanes = Lambda_inv_0_8_p200_lanes * Lambda_inv_0_0_p714_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_0_8_p202_lanes = detail::make_lanes<Real>(Lambda_inv_0_8_p154,
      Lambda_inv_0_9_p165, Lambda_inv_0_10_p165, Lambda_inv_0_11_p179, Lambda_inv_0_8_p154,
      Lambda_inv_0_8_p154, Lambda_inv_0_8_p154, Lambda_inv_0_8_p154) * inverse_D4;
  const Lanes Lambda_inv_0_8_p203_lanes = Lambda_inv_0_8_p202_lanes * Lambda_inv_0_0_p699;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_0_8_p204_lanes = Lambda_inv_0_8_p141_lanes * inverse_D5;
  const Lanes Lambda_inv_0_8_p205_lanes = Lambda_inv_0_8_p204_lanes * Lambda_inv_0_0_p686_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_0_8_p206_lanes = Lambda_inv_0_8_p126_lanes * inverse_D6;
  const Lanes Lambda_inv_0_8_p207_lanes = Lambda_inv_0_8_p206_lanes * Lambda_inv_0_0_p666_lanes[0];

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_0_8_p208_lanes = Lambda_inv_0_8_p207_lanes + Lambda_inv_0_8_p205_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_0_8_p209_lanes = Lambda_inv_0_8_p208_lanes + Lambda_inv_0_8_p203_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_0_8_p210_lanes = Lambda_inv_0_8_p209_lanes + Lambda_inv_0_8_p201_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_0_8_p211_lanes = Lambda_inv_0_8_p210_lanes + Lambda_inv_0_8_p199_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_0_8_lanes = Lambda_inv_0_8_p211_lanes + Lambda_inv_0_8_p197_lanes;
  Lambda_inv[8] = Lambda_inv_0_8_lanes[0];
  Lambda_inv[96] = Lambda_inv_0_8_lanes[0];
  Lambda_inv[9] = Lambda_inv_0_8_lanes[1];
  Lambda_inv[108] = Lambda_inv_0_8_lanes[1];
  Lambda_inv[10] = Lambda_inv_0_8_lanes[2];
  Lambda_inv[120] = Lambda_inv_0_8_lanes[2];
  Lambda_inv[11] = Lambda_inv_0_8_lanes[3];
  Lambda_inv[132] = Lambda_inv_0_8_lanes[3];
  const Lanes Lambda_inv_1_1_p1_lanes = Lambda_inv_0_0_p744_lanes * Lambda_inv_0_0_p743_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_1_1_p2_lanes = Lambda_inv_0_0_p746_lanes * Lambda_inv_0_0_p729_lanes[1];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_1_1_p3_lanes = Lambda_inv_0_0_p748_lanes * Lambda_inv_0_0_p714_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_1_1_p4_lanes = Lambda_inv_0_0_p750_lanes * Lambda_inv_0_1_p160;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_1_1_p5_lanes = Lambda_inv_0_0_p752_lanes * Lambda_inv_0_0_p686_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_1_1_p6_lanes = Lambda_inv_0_0_p754_lanes * Lambda_inv_0_0_p666_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_1_1_p7_lanes = Lambda_inv_0_0_p756_lanes * Lambda_inv_0_0_p621_lanes[1];

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_1_1_p8_lanes = Lambda_inv_0_0_p758_lanes * Lambda_inv_0_0_p614_lanes[1];

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_1_1_p9_lanes = Lambda_inv_0_0_p760_lanes * Lambda_inv_0_1_p56;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_1_1_p10_lanes = Lambda_inv_0_0_p762_lanes * Lambda_inv_0_0_p575_lanes[1];

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_1_1_p11_lanes = Lambda_inv_0_0_p764_lanes * Lambda_inv_0_1_p20;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_1_1_p12_lanes = Lambda_inv_0_0_p766_lanes * Lambda_inv_0_0_p547_lanes[1];

  // link 1 (calf), articulated inertia
  const Real Lambda_inv_1_1_p13 = 0.086 * Lambda_inv_0_1_p1;

  // link 13 (left_hand), force propagation
  const Lanes Lambda_inv_1_1_p14_lanes = Lambda_inv_0_0_p769_lanes * Lambda_inv_1_1_p13;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_1_1_p15_lanes = Lambda_inv_1_1_p14_lanes + Lambda_inv_1_1_p12_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_1_1_p16_lanes = Lambda_inv_1_1_p15_lanes + Lambda_inv_1_1_p11_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_1_1_p17_lanes = Lambda_inv_1_1_p16_lanes + Lambda_inv_1_1_p10_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_1_1_p18_lanes = Lambda_inv_1_1_p17_lanes + Lambda_inv_1_1_p9_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_1_1_p19_lanes = Lambda_inv_1_1_p18_lanes + Lambda_inv_1_1_p8_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_1_1_p20_lanes = Lambda_inv_1_1_p19_lanes + Lambda_inv_1_1_p7_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_1_1_p21_lanes = Lambda_inv_1_1_p20_lanes + Lambda_inv_1_1_p6_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_1_1_p22_lanes = detail::make_lanes<Real>(Lambda_inv_1_1_p21_lanes[1],
      Lambda_inv_1_1_p21_lanes[1], Lambda_inv_1_1_p21_lanes[2], Lambda_inv_1_1_p21_lanes[3],
      Lambda_inv_1_1_p21_lanes[4], Lambda_inv_1_1_p21_lanes[5], Lambda_inv_0_6_p155 *
      Lambda_inv_0_0_p666_lanes[1], Lambda_inv_0_7_p151 * Lambda_inv_0_0_p666_lanes[1]) +
      Lambda_inv_1_1_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_1_1_p23_lanes = Lambda_inv_1_1_p22_lanes + Lambda_inv_1_1_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_1_1_p24_lanes = Lambda_inv_1_1_p23_lanes + Lambda_inv_1_1_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_1_1_p25_lanes = Lambda_inv_1_1_p24_lanes + Lambda_inv_1_1_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_1_1_lanes = Lambda_inv_1_1_p25_lanes + Lambda_inv_1_1_p1_lanes;
  Lambda_inv[13] = Lambda_inv_1_1_lanes[1];
  Lambda_inv[14] = Lambda_inv_1_1_lanes[2];
  Lambda_inv[25] = Lambda_inv_1_1_lanes[2];
  Lambda_inv[15] = Lambda_inv_1_1_lanes[3];
  Lambda_inv[37] = Lambda_inv_1_1_lanes[3];
  Lambda_inv[16] = Lambda_inv_1_1_lanes[4];
  Lambda_inv[49] = Lambda_inv_1_1_lanes[4];
  Lambda_inv[17] = Lambda_inv_1_1_lanes[5];
  Lambda_inv[61] = Lambda_inv_1_1_lanes[5];
  Lambda_inv[18] = Lambda_inv_1_1_lanes[6];
  Lambda_inv[73] = Lambda_inv_1_1_lanes[6];
  Lambda_inv[19] = Lambda_inv_1_1_lanes[7];
  Lambda_inv[85] = Lambda_inv_1_1_lanes[7];
  const Lanes Lambda_inv_1_8_p1_lanes = Lambda_inv_0_8_p196_lanes * Lambda_inv_0_0_p743_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_1_8_p2_lanes = Lambda_inv_0_8_p198_lanes * Lambda_inv_0_0_p729_lanes[1];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_1_8_p3_lanes = Lambda_inv_0_8_p200_lanes * Lambda_inv_0_0_p714_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_1_8_p4_lanes = Lambda_inv_0_8_p202_lanes * Lambda_inv_0_1_p160;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_1_8_p5_lanes = Lambda_inv_0_8_p204_lanes * Lambda_inv_0_0_p686_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_1_8_p6_lanes = Lambda_inv_0_8_p206_lanes * Lambda_inv_0_0_p666_lanes[1];

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_1_8_p7_lanes = Lambda_inv_1_8_p6_lanes + Lambda_inv_1_8_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_1_8_p8_lanes = Lambda_inv_1_8_p7_lanes + Lambda_inv_1_8_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_1_8_p9_lanes = Lambda_inv_1_8_p8_lanes + Lambda_inv_1_8_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_1_8_p10_lanes = Lambda_inv_1_8_p9_lanes + Lambda_inv_1_8_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_1_8_lanes = Lambda_inv_1_8_p10_lanes + Lambda_inv_1_8_p1_lanes;
  Lambda_inv[20] = Lambda_inv_1_8_lanes[0];
  Lambda_inv[97] = Lambda_inv_1_8_lanes[0];
  Lambda_inv[21] = Lambda_inv_1_8_lanes[1];
  Lambda_inv[109] = Lambda_inv_1_8_lanes[1];
  Lambda_inv[22] = Lambda_inv_1_8_lanes[2];
  Lambda_inv[121] = Lambda_inv_1_8_lanes[2];
  Lambda_inv[23] = Lambda_inv_1_8_lanes[3];
  Lambda_inv[133] = Lambda_inv_1_8_lanes[3];
  const Lanes Lambda_inv_2_2_p1_lanes = Lambda_inv_0_0_p744_lanes * Lambda_inv_0_0_p743_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_2_2_p2_lanes = Lambda_inv_0_0_p746_lanes * Lambda_inv_0_0_p729_lanes[2];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_2_2_p3_lanes = Lambda_inv_0_0_p748_lanes * Lambda_inv_0_0_p714_lanes[2];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_2_2_p4_lanes = Lambda_inv_0_0_p750_lanes * Lambda_inv_0_2_p164;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_2_2_p5_lanes = Lambda_inv_0_0_p752_lanes * Lambda_inv_0_0_p686_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_2_2_p6_lanes = Lambda_inv_0_0_p754_lanes * Lambda_inv_0_0_p666_lanes[2];

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_2_2_p7_lanes = Lambda_inv_0_0_p756_lanes * Lambda_inv_0_0_p621_lanes[2];

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_2_2_p8_lanes = Lambda_inv_0_0_p758_lanes * Lambda_inv_0_0_p614_lanes[2];

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_2_2_p9_lanes = Lambda_inv_0_0_p760_lanes * Lambda_inv_0_2_p60;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_2_2_p10_lanes = Lambda_inv_0_0_p762_lanes * Lambda_inv_0_0_p575_lanes[2];

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_2_2_p11_lanes = Lambda_inv_0_0_p764_lanes * Lambda_inv_0_2_p21;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_2_2_p12_lanes = Lambda_inv_0_0_p766_lanes * Lambda_inv_0_0_p547_lanes[2];

  // link 13 (left_hand), force propagation
  const Lanes Lambda_inv_2_2_p13_lanes = Lambda_inv_0_0_p769_lanes * Lambda_inv_0_2_p2;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_2_2_p14_lanes = Lambda_inv_2_2_p13_lanes + Lambda_inv_2_2_p12_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_2_2_p15_lanes = Lambda_inv_2_2_p14_lanes + Lambda_inv_2_2_p11_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_2_2_p16_lanes = Lambda_inv_2_2_p15_lanes + Lambda_inv_2_2_p10_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_2_2_p17_lanes = Lambda_inv_2_2_p16_lanes + Lambda_inv_2_2_p9_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_2_2_p18_lanes = Lambda_inv_2_2_p17_lanes + Lambda_inv_2_2_p8_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_2_2_p19_lanes = Lambda_inv_2_2_p18_lanes + Lambda_inv_2_2_p7_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_2_2_p20_lanes = Lambda_inv_2_2_p19_lanes + Lambda_inv_2_2_p6_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_2_2_p21_lanes = detail::make_lanes<Real>(Lambda_inv_2_2_p20_lanes[2],
      Lambda_inv_2_2_p20_lanes[2], Lambda_inv_2_2_p20_lanes[2], Lambda_inv_2_2_p20_lanes[3],
      Lambda_inv_2_2_p20_lanes[4], Lambda_inv_2_2_p20_lanes[5], Lambda_inv_0_6_p155 *
      Lambda_inv_0_0_p666_lanes[2], Lambda_inv_0_7_p151 * Lambda_inv_0_0_p666_lanes[2]) +
      Lambda_inv_2_2_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_2_2_p22_lanes = Lambda_inv_2_2_p21_lanes + Lambda_inv_2_2_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_2_2_p23_lanes = Lambda_inv_2_2_p22_lanes + Lambda_inv_2_2_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_2_2_p24_lanes = Lambda_inv_2_2_p23_lanes + Lambda_inv_2_2_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_2_2_lanes = Lambda_inv_2_2_p24_lanes + Lambda_inv_2_2_p1_lanes;
  Lambda_inv[26] = Lambda_inv_2_2_lanes[2];
  Lambda_inv[27] = Lambda_inv_2_2_lanes[3];
  Lambda_inv[38] = Lambda_inv_2_2_lanes[3];
  Lambda_inv[28] = Lambda_inv_2_2_lanes[4];
  Lambda_inv[50] = Lambda_inv_2_2_lanes[4];
  Lambda_inv[29] = Lambda_inv_2_2_lanes[5];
  Lambda_inv[62] = Lambda_inv_2_2_lanes[5];
  Lambda_inv[30] = Lambda_inv_2_2_lanes[6];
  Lambda_inv[74] = Lambda_inv_2_2_lanes[6];
  Lambda_inv[31] = Lambda_inv_2_2_lanes[7];
  Lambda_inv[86] = Lambda_inv_2_2_lanes[7];
  const Lanes Lambda_inv_2_8_p1_lanes = Lambda_inv_0_8_p196_lanes * Lambda_inv_0_0_p743_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_2_8_p2_lanes = Lambda_inv_0_8_p198_lanes * Lambda_inv_0_0_p729_lanes[2];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_2_8_p3_lanes = Lambda_inv_0_8_p200_lanes * Lambda_inv_0_0_p714_lanes[2];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_2_8_p4_lanes = Lambda_inv_0_8_p202_lanes * Lambda_inv_0_2_p164;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_2_8_p5_lanes = Lambda_inv_0_8_p204_lanes * Lambda_inv_0_0_p686_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_2_8_p6_lanes = Lambda_inv_0_8_p206_lanes * Lambda_inv_0_0_p666_lanes[2];

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_2_8_p7_lanes = Lambda_inv_2_8_p6_lanes + Lambda_inv_2_8_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_2_8_p8_lanes = Lambda_inv_2_8_p7_lanes + Lambda_inv_2_8_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_2_8_p9_lanes = Lambda_inv_2_8_p8_lanes + Lambda_inv_2_8_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_2_8_p10_lanes = Lambda_inv_2_8_p9_lanes + Lambda_inv_2_8_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_2_8_lanes = Lambda_inv_2_8_p10_lanes + Lambda_inv_2_8_p1_lanes;
  Lambda_inv[32] = Lambda_inv_2_8_lanes[0];
  Lambda_inv[98] = Lambda_inv_2_8_lanes[0];
  Lambda_inv[33] = Lambda_inv_2_8_lanes[1];
  Lambda_inv[110] = Lambda_inv_2_8_lanes[1];
  Lambda_inv[34] = Lambda_inv_2_8_lanes[2];
  Lambda_inv[122] = Lambda_inv_2_8_lanes[2];
  Lambda_inv[35] = Lambda_inv_2_8_lanes[3];
  Lambda_inv[134] = Lambda_inv_2_8_lanes[3];
  const Lanes Lambda_inv_3_3_p1_lanes = Lambda_inv_0_0_p744_lanes * Lambda_inv_0_0_p743_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_3_3_p2_lanes = Lambda_inv_0_0_p746_lanes * Lambda_inv_0_0_p729_lanes[3];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_3_3_p3_lanes = Lambda_inv_0_0_p748_lanes * Lambda_inv_0_0_p714_lanes[3];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_3_3_p4_lanes = Lambda_inv_0_0_p750_lanes * Lambda_inv_0_3_p179;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_3_3_p5_lanes = Lambda_inv_0_0_p752_lanes * Lambda_inv_0_0_p686_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_3_3_p6_lanes = Lambda_inv_0_0_p754_lanes * Lambda_inv_0_0_p666_lanes[3];

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_3_3_p7_lanes = Lambda_inv_0_0_p756_lanes * Lambda_inv_0_0_p621_lanes[3];

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_3_3_p8_lanes = Lambda_inv_0_0_p758_lanes * Lambda_inv_0_0_p614_lanes[3];

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_3_3_p9_lanes = Lambda_inv_0_0_p760_lanes * Lambda_inv_0_3_p75;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_3_3_p10_lanes = Lambda_inv_0_0_p762_lanes * Lambda_inv_0_0_p575_lanes[3];

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_3_3_p11_lanes = Lambda_inv_0_0_p764_lanes * Lambda_inv_0_3_p37;

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_3_3_p12_lanes = Lambda_inv_0_0_p766_lanes * Lambda_inv_0_0_p547_lanes[3];

  // link 13 (left_hand), force propagation
  const Lanes Lambda_inv_3_3_p13_lanes = Lambda_inv_0_0_p769_lanes * Lambda_inv_0_3_p14_lanes[0];

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_3_3_p14_lanes = Lambda_inv_3_3_p13_lanes + Lambda_inv_3_3_p12_lanes;

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_3_3_p15_lanes = Lambda_inv_3_3_p14_lanes + Lambda_inv_3_3_p11_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_3_3_p16_lanes = Lambda_inv_3_3_p15_lanes + Lambda_inv_3_3_p10_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_3_3_p17_lanes = Lambda_inv_3_3_p16_lanes + Lambda_inv_3_3_p9_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_3_3_p18_lanes = Lambda_inv_3_3_p17_lanes + Lambda_inv_3_3_p8_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_3_3_p19_lanes = Lambda_inv_3_3_p18_lanes + Lambda_inv_3_3_p7_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_3_3_p20_lanes = Lambda_inv_3_3_p19_lanes + Lambda_inv_3_3_p6_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_3_3_p21_lanes = detail::make_lanes<Real>(Lambda_inv_3_3_p20_lanes[3],
      Lambda_inv_3_3_p20_lanes[3], Lambda_inv_3_3_p20_lanes[3], Lambda_inv_3_3_p20_lanes[3],
      Lambda_inv_3_3_p20_lanes[4], Lambda_inv_3_3_p20_lanes[5], Lambda_inv_0_6_p155 *
      Lambda_inv_0_0_p666_lanes[3], Lambda_inv_0_7_p151 * Lambda_inv_0_0_p666_lanes[3]) +
      Lambda_inv_3_3_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_3_3_p22_lanes = Lambda_inv_3_3_p21_lanes + Lambda_inv_3_3_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_3_3_p23_lanes = Lambda_inv_3_3_p22_lanes + Lambda_inv_3_3_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_3_3_p24_lanes = Lambda_inv_3_3_p23_lanes + Lambda_inv_3_3_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_3_3_lanes = Lambda_inv_3_3_p24_lanes + Lambda_inv_3_3_p1_lanes;
  Lambda_inv[39] = Lambda_inv_3_3_lanes[3];
  Lambda_inv[40] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[51] = Lambda_inv_3_3_lanes[4];
  Lambda_inv[41] = Lambda_inv_3_3_lanes[5];
  Lambda_inv[63] = Lambda_inv_3_3_lanes[5];
  Lambda_inv[42] = Lambda_inv_3_3_lanes[6];
  Lambda_inv[75] = Lambda_inv_3_3_lanes[6];
  Lambda_inv[43] = Lambda_inv_3_3_lanes[7];
  Lambda_inv[87] = Lambda_inv_3_3_lanes[7];
  const Lanes Lambda_inv_3_8_p1_lanes = Lambda_inv_0_8_p196_lanes * Lambda_inv_0_0_p743_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_3_8_p2_lanes = Lambda_inv_0_8_p198_lanes * Lambda_inv_0_0_p729_lanes[3];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_3_8_p3_lanes = Lambda_inv_0_8_p200_lanes * Lambda_inv_0_0_p714_lanes[3];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_3_8_p4_lanes = Lambda_inv_0_8_p202_lanes * Lambda_inv_0_3_p179;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_3_8_p5_lanes = Lambda_inv_0_8_p204_lanes * Lambda_inv_0_0_p686_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_3_8_p6_lanes = Lambda_inv_0_8_p206_lanes * Lambda_inv_0_0_p666_lanes[3];

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_3_8_p7_lanes = Lambda_inv_3_8_p6_lanes + Lambda_inv_3_8_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_3_8_p8_lanes = Lambda_inv_3_8_p7_lanes + Lambda_inv_3_8_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_3_8_p9_lanes = Lambda_inv_3_8_p8_lanes + Lambda_inv_3_8_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_3_8_p10_lanes = Lambda_inv_3_8_p9_lanes + Lambda_inv_3_8_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_3_8_lanes = Lambda_inv_3_8_p10_lanes + Lambda_inv_3_8_p1_lanes;
  Lambda_inv[44] = Lambda_inv_3_8_lanes[0];
  Lambda_inv[99] = Lambda_inv_3_8_lanes[0];
  Lambda_inv[45] = Lambda_inv_3_8_lanes[1];
  Lambda_inv[111] = Lambda_inv_3_8_lanes[1];
  Lambda_inv[46] = Lambda_inv_3_8_lanes[2];
  Lambda_inv[123] = Lambda_inv_3_8_lanes[2];
  Lambda_inv[47] = Lambda_inv_3_8_lanes[3];
  Lambda_inv[135] = Lambda_inv_3_8_lanes[3];
  const Lanes Lambda_inv_4_4_p1_lanes = Lambda_inv_0_0_p744_lanes * Lambda_inv_0_0_p743_lanes[4];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_4_4_p2_lanes = Lambda_inv_0_0_p746_lanes * Lambda_inv_0_0_p729_lanes[4];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_4_4_p3_lanes = Lambda_inv_0_0_p748_lanes * Lambda_inv_0_0_p714_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_4_4_p4_lanes = Lambda_inv_0_0_p750_lanes * Lambda_inv_0_4_p179;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_4_4_p5_lanes = Lambda_inv_0_0_p752_lanes * Lambda_inv_0_0_p686_lanes[4];

  // link 13 (left_hand), force propagation
  const Lanes Lambda_inv_4_4_p6_lanes = Lambda_inv_0_0_p769_lanes * Lambda_inv_0_3_p14_lanes[1];

  // link 12 (left_wrist2), force propagation
  const Lanes Lambda_inv_4_4_p7_lanes = Lambda_inv_4_4_p6_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p766_lanes[4] * Lambda_inv_0_0_p547_lanes[4],
      Lambda_inv_0_0_p766_lanes[4] * Lambda_inv_0_0_p547_lanes[4], Lambda_inv_0_0_p766_lanes[4] *
      Lambda_inv_0_0_p547_lanes[4], Lambda_inv_0_0_p766_lanes[4] * Lambda_inv_0_0_p547_lanes[4],
      Lambda_inv_0_0_p766_lanes[4] * Lambda_inv_0_0_p547_lanes[4], Lambda_inv_0_0_p766_lanes[5] *
      Lambda_inv_0_0_p547_lanes[4], Lambda_inv_0_0_p766_lanes[4] * Lambda_inv_0_0_p547_lanes[4],
      Lambda_inv_0_0_p766_lanes[4] * Lambda_inv_0_0_p547_lanes[4]);

  // link 11 (left_wrist1), force propagation
  const Lanes Lambda_inv_4_4_p8_lanes = Lambda_inv_4_4_p7_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p764_lanes[4] * Lambda_inv_0_4_p37,
      Lambda_inv_0_0_p764_lanes[4] * Lambda_inv_0_4_p37, Lambda_inv_0_0_p764_lanes[4] *
      Lambda_inv_0_4_p37, Lambda_inv_0_0_p764_lanes[4] * Lambda_inv_0_4_p37,
      Lambda_inv_0_0_p764_lanes[4] * Lambda_inv_0_4_p37, Lambda_inv_0_0_p764_lanes[5] *
      Lambda_inv_0_4_p37, Lambda_inv_0_0_p764_lanes[4] * Lambda_inv_0_4_p37,
      Lambda_inv_0_0_p764_lanes[4] * Lambda_inv_0_4_p37);

  // link 10 (left_lowerarm), force propagation
  const Lanes Lambda_inv_4_4_p9_lanes = Lambda_inv_4_4_p8_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p762_lanes[4] * Lambda_inv_0_0_p575_lanes[4],
      Lambda_inv_0_0_p762_lanes[4] * Lambda_inv_0_0_p575_lanes[4], Lambda_inv_0_0_p762_lanes[4] *
      Lambda_inv_0_0_p575_lanes[4], Lambda_inv_0_0_p762_lanes[4] * Lambda_inv_0_0_p575_lanes[4],
      Lambda_inv_0_0_p762_lanes[4] * Lambda_inv_0_0_p575_lanes[4], Lambda_inv_0_0_p762_lanes[5] *
      Lambda_inv_0_0_p575_lanes[4], Lambda_inv_0_0_p762_lanes[4] * Lambda_inv_0_0_p575_lanes[4],
      Lambda_inv_0_0_p762_lanes[4] * Lambda_inv_0_0_p575_lanes[4]);

  // link 9 (left_upperarm), force propagation
  const Lanes Lambda_inv_4_4_p10_lanes = Lambda_inv_4_4_p9_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p760_lanes[4] * Lambda_inv_0_4_p75,
      Lambda_inv_0_0_p760_lanes[4] * Lambda_inv_0_4_p75, Lambda_inv_0_0_p760_lanes[4] *
      Lambda_inv_0_4_p75, Lambda_inv_0_0_p760_lanes[4] * Lambda_inv_0_4_p75,
      Lambda_inv_0_0_p760_lanes[4] * Lambda_inv_0_4_p75, Lambda_inv_0_0_p760_lanes[5] *
      Lambda_inv_0_4_p75, Lambda_inv_0_0_p760_lanes[4] * Lambda_inv_0_4_p75,
      Lambda_inv_0_0_p760_lanes[4] * Lambda_inv_0_4_p75);

  // link 8 (left_shoulder2), force propagation
  const Lanes Lambda_inv_4_4_p11_lanes = Lambda_inv_4_4_p10_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p758_lanes[4] * Lambda_inv_0_0_p614_lanes[4],
      Lambda_inv_0_0_p758_lanes[4] * Lambda_inv_0_0_p614_lanes[4], Lambda_inv_0_0_p758_lanes[4] *
      Lambda_inv_0_0_p614_lanes[4], Lambda_inv_0_0_p758_lanes[4] * Lambda_inv_0_0_p614_lanes[4],
      Lambda_inv_0_0_p758_lanes[4] * Lambda_inv_0_0_p614_lanes[4], Lambda_inv_0_0_p758_lanes[5] *
      Lambda_inv_0_0_p614_lanes[4], Lambda_inv_0_0_p758_lanes[4] * Lambda_inv_0_0_p614_lanes[4],
      Lambda_inv_0_0_p758_lanes[4] * Lambda_inv_0_0_p614_lanes[4]);

  // link 7 (left_shoulder1), force propagation
  const Lanes Lambda_inv_4_4_p12_lanes = Lambda_inv_4_4_p11_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p756_lanes[4] * Lambda_inv_0_0_p621_lanes[4],
      Lambda_inv_0_0_p756_lanes[4] * Lambda_inv_0_0_p621_lanes[4], Lambda_inv_0_0_p756_lanes[4] *
      Lambda_inv_0_0_p621_lanes[4], Lambda_inv_0_0_p756_lanes[4] * Lambda_inv_0_0_p621_lanes[4],
      Lambda_inv_0_0_p756_lanes[4] * Lambda_inv_0_0_p621_lanes[4], Lambda_inv_0_0_p756_lanes[5] *
      Lambda_inv_0_0_p621_lanes[4], Lambda_inv_0_0_p756_lanes[4] * Lambda_inv_0_0_p621_lanes[4],
      Lambda_inv_0_0_p756_lanes[4] * Lambda_inv_0_0_p621_lanes[4]);

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_4_4_p13_lanes = Lambda_inv_4_4_p12_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p754_lanes[4] * Lambda_inv_0_0_p666_lanes[4],
      Lambda_inv_0_0_p754_lanes[4] * Lambda_inv_0_0_p666_lanes[4], Lambda_inv_0_0_p754_lanes[4] *
      Lambda_inv_0_0_p666_lanes[4], Lambda_inv_0_0_p754_lanes[4] * Lambda_inv_0_0_p666_lanes[4],
      Lambda_inv_0_0_p754_lanes[4] * Lambda_inv_0_0_p666_lanes[4], Lambda_inv_0_0_p754_lanes[5] *
      Lambda_inv_0_0_p666_lanes[4], Lambda_inv_0_0_p754_lanes[4] * Lambda_inv_0_0_p666_lanes[4],
      Lambda_inv_0_0_p754_lanes[4] * Lambda_inv_0_0_p666_lanes[4]);

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_4_4_p14_lanes = detail::make_lanes<Real>(Lambda_inv_4_4_p13_lanes[4],
      Lambda_inv_4_4_p13_lanes[4], Lambda_inv_4_4_p13_lanes[4], Lambda_inv_4_4_p13_lanes[4],
      Lambda_inv_4_4_p13_lanes[4], Lambda_inv_4_4_p13_lanes[5], Lambda_inv_0_6_p155 *
      Lambda_inv_0_0_p666_lanes[4], Lambda_inv_0_7_p151 * Lambda_inv_0_0_p666_lanes[4]) +
      Lambda_inv_4_4_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_4_4_p15_lanes = Lambda_inv_4_4_p14_lanes + Lambda_inv_4_4_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_4_4_p16_lanes = Lambda_inv_4_4_p15_lanes + Lambda_inv_4_4_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_4_4_p17_lanes = Lambda_inv_4_4_p16_lanes + Lambda_inv_4_4_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_4_4_lanes = Lambda_inv_4_4_p17_lanes + Lambda_inv_4_4_p1_lanes;
  Lambda_inv[52] = Lambda_inv_4_4_lanes[4];
  Lambda_inv[53] = Lambda_inv_4_4_lanes[5];
  Lambda_inv[64] = Lambda_inv_4_4_lanes[5];
  Lambda_inv[54] = Lambda_inv_4_4_lanes[6];
  Lambda_inv[76] = Lambda_inv_4_4_lanes[6];
  Lambda_inv[55] = Lambda_inv_4_4_lanes[7];
  Lambda_inv[88] = Lambda_inv_4_4_lanes[7];
  const Lanes Lambda_inv_4_8_p1_lanes = Lambda_inv_0_8_p196_lanes * Lambda_inv_0_0_p743_lanes[4];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_4_8_p2_lanes = Lambda_inv_0_8_p198_lanes * Lambda_inv_0_0_p729_lanes[4];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_4_8_p3_lanes = Lambda_inv_0_8_p200_lanes * Lambda_inv_0_0_p714_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_4_8_p4_lanes = Lambda_inv_0_8_p202_lanes * Lambda_inv_0_4_p179;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_4_8_p5_lanes = Lambda_inv_0_8_p204_lanes * Lambda_inv_0_0_p686_lanes[4];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_4_8_p6_lanes = Lambda_inv_0_8_p206_lanes * Lambda_inv_0_0_p666_lanes[4];

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_4_8_p7_lanes = Lambda_inv_4_8_p6_lanes + Lambda_inv_4_8_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_4_8_p8_lanes = Lambda_inv_4_8_p7_lanes + Lambda_inv_4_8_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_4_8_p9_lanes = Lambda_inv_4_8_p8_lanes + Lambda_inv_4_8_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_4_8_p10_lanes = Lambda_inv_4_8_p9_lanes + Lambda_inv_4_8_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_4_8_lanes = Lambda_inv_4_8_p10_lanes + Lambda_inv_4_8_p1_lanes;
  Lambda_inv[56] = Lambda_inv_4_8_lanes[0];
  Lambda_inv[100] = Lambda_inv_4_8_lanes[0];
  Lambda_inv[57] = Lambda_inv_4_8_lanes[1];
  Lambda_inv[112] = Lambda_inv_4_8_lanes[1];
  Lambda_inv[58] = Lambda_inv_4_8_lanes[2];
  Lambda_inv[124] = Lambda_inv_4_8_lanes[2];
  Lambda_inv[59] = Lambda_inv_4_8_lanes[3];
  Lambda_inv[136] = Lambda_inv_4_8_lanes[3];
  const Lanes Lambda_inv_5_5_p1_lanes = Lambda_inv_0_0_p744_lanes * Lambda_inv_0_0_p743_lanes[5];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_5_5_p2_lanes = Lambda_inv_0_0_p746_lanes * Lambda_inv_0_0_p729_lanes[5];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_5_5_p3_lanes = Lambda_inv_0_0_p748_lanes * Lambda_inv_0_0_p714_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_5_5_p4_lanes = Lambda_inv_0_0_p750_lanes * Lambda_inv_0_5_p186;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_5_5_p5_lanes = Lambda_inv_0_0_p752_lanes * Lambda_inv_0_0_p686_lanes[5];

  // link 9 (left_upperarm), force propagation
  const Real Lambda_inv_5_5_p6 = Lambda_inv_0_0_p769_lanes[5] * Lambda_inv_0_3_p14_lanes[2] +
      Lambda_inv_0_0_p766_lanes[5] * Lambda_inv_0_0_p547_lanes[5] + Lambda_inv_0_0_p764_lanes[5] *
      Lambda_inv_0_5_p44 + Lambda_inv_0_0_p762_lanes[5] * Lambda_inv_0_0_p575_lanes[5] +
      Lambda_inv_0_0_p760_lanes[5] * Lambda_inv_0_5_p82;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_5_5_p7_lanes = detail::make_lanes<Real>(Lambda_inv_5_5_p6 +
      Lambda_inv_0_0_p758_lanes[5] * Lambda_inv_0_0_p614_lanes[5] + Lambda_inv_0_0_p756_lanes[5] *
      Lambda_inv_0_0_p621_lanes[5] + Lambda_inv_0_0_p754_lanes[5] * Lambda_inv_0_0_p666_lanes[5],
      Lambda_inv_5_5_p6 + Lambda_inv_0_0_p758_lanes[5] * Lambda_inv_0_0_p614_lanes[5] +
      Lambda_inv_0_0_p756_lanes[5] * Lambda_inv_0_0_p621_lanes[5] + Lambda_inv_0_0_p754_lanes[5] *
      Lambda_inv_0_0_p666_lanes[5], Lambda_inv_5_5_p6 + Lambda_inv_0_0_p758_lanes[5] *
      Lambda_inv_0_0_p614_lanes[5] + Lambda_inv_0_0_p756_lanes[5] * Lambda_inv_0_0_p621_lanes[5] +
      Lambda_inv_0_0_p754_lanes[5] * Lambda_inv_0_0_p666_lanes[5], Lambda_inv_5_5_p6 +
      Lambda_inv_0_0_p758_lanes[5] * Lambda_inv_0_0_p614_lanes[5] + Lambda_inv_0_0_p756_lanes[5] *
      Lambda_inv_0_0_p621_lanes[5] + Lambda_inv_0_0_p754_lanes[5] * Lambda_inv_0_0_p666_lanes[5],
      Lambda_inv_5_5_p6 + Lambda_inv_0_0_p758_lanes[5] * Lambda_inv_0_0_p614_lanes[5] +
      Lambda_inv_0_0_p756_lanes[5] * Lambda_inv_0_0_p621_lanes[5] + Lambda_inv_0_0_p754_lanes[5] *
      Lambda_inv_0_0_p666_lanes[5], Lambda_inv_5_5_p6 + Lambda_inv_0_0_p758_lanes[5] *
      Lambda_inv_0_0_p614_lanes[5] + Lambda_inv_0_0_p756_lanes[5] * Lambda_inv_0_0_p621_lanes[5] +
      Lambda_inv_0_0_p754_lanes[5] * Lambda_inv_0_0_p666_lanes[5], Lambda_inv_0_6_p155 *
      Lambda_inv_0_0_p666_lanes[5], Lambda_inv_0_7_p151 * Lambda_inv_0_0_p666_lanes[5]) +
      Lambda_inv_5_5_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_5_5_p8_lanes = Lambda_inv_5_5_p7_lanes + Lambda_inv_5_5_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_5_5_p9_lanes = Lambda_inv_5_5_p8_lanes + Lambda_inv_5_5_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_5_5_p10_lanes = Lambda_inv_5_5_p9_lanes + Lambda_inv_5_5_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_5_5_lanes = Lambda_inv_5_5_p10_lanes + Lambda_inv_5_5_p1_lanes;
  Lambda_inv[65] = Lambda_inv_5_5_lanes[5];
  Lambda_inv[66] = Lambda_inv_5_5_lanes[6];
  Lambda_inv[77] = Lambda_inv_5_5_lanes[6];
  Lambda_inv[67] = Lambda_inv_5_5_lanes[7];
  Lambda_inv[89] = Lambda_inv_5_5_lanes[7];
  const Lanes Lambda_inv_5_8_p1_lanes = Lambda_inv_0_8_p196_lanes * Lambda_inv_0_0_p743_lanes[5];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_5_8_p2_lanes = Lambda_inv_0_8_p198_lanes * Lambda_inv_0_0_p729_lanes[5];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_5_8_p3_lanes = Lambda_inv_0_8_p200_lanes * Lambda_inv_0_0_p714_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_5_8_p4_lanes = Lambda_inv_0_8_p202_lanes * Lambda_inv_0_5_p186;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_5_8_p5_lanes = Lambda_inv_0_8_p204_lanes * Lambda_inv_0_0_p686_lanes[5];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_5_8_p6_lanes = Lambda_inv_0_8_p206_lanes * Lambda_inv_0_0_p666_lanes[5];

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_5_8_p7_lanes = Lambda_inv_5_8_p6_lanes + Lambda_inv_5_8_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_5_8_p8_lanes = Lambda_inv_5_8_p7_lanes + Lambda_inv_5_8_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_5_8_p9_lanes = Lambda_inv_5_8_p8_lanes + Lambda_inv_5_8_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_5_8_p10_lanes = Lambda_inv_5_8_p9_lanes + Lambda_inv_5_8_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_5_8_lanes = Lambda_inv_5_8_p10_lanes + Lambda_inv_5_8_p1_lanes;
  Lambda_inv[68] = Lambda_inv_5_8_lanes[0];
  Lambda_inv[101] = Lambda_inv_5_8_lanes[0];
  Lambda_inv[69] = Lambda_inv_5_8_lanes[1];
  Lambda_inv[113] = Lambda_inv_5_8_lanes[1];
  Lambda_inv[70] = Lambda_inv_5_8_lanes[2];
  Lambda_inv[125] = Lambda_inv_5_8_lanes[2];
  Lambda_inv[71] = Lambda_inv_5_8_lanes[3];
  Lambda_inv[137] = Lambda_inv_5_8_lanes[3];

  // link 14 (right_shoulder1), force propagation
  const Real Lambda_inv_6_7_p1 = Lambda_inv_0_7_p48 * inverse_D14;

  // link 15 (right_shoulder2), force propagation
  const Real Lambda_inv_6_7_p2 = Lambda_inv_0_7_p45 * inverse_D15;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_6_7_p3 = Lambda_inv_0_7_p39 * inverse_D16;

  // link 17 (right_lowerarm), force propagation
  const Real Lambda_inv_6_7_p4 = Lambda_inv_0_7_p33 * inverse_D17;

  // link 18 (right_wrist1), force propagation
  const Real Lambda_inv_6_7_p5 = Lambda_inv_0_7_p27 * inverse_D18;

  // link 19 (right_wrist2), force propagation
  const Real Lambda_inv_6_7_p6 = Lambda_inv_0_7_p24 * inverse_D19;

  // link 1 (calf), articulated inertia
  const Real Lambda_inv_6_6_p1 = 0.086 * Lambda_inv_0_6_p23;

  // link 20 (right_hand), force propagation
  const Real Lambda_inv_6_7_p7 = 91.62274020012977 * Lambda_inv_0_7_p18;
  const Lanes Lambda_inv_6_6_p2_lanes = detail::make_lanes<Real>(91.62274020012977 *
      Lambda_inv_0_6_p23, 91.62274020012977 * Lambda_inv_0_6_p23, 91.62274020012977 *
      Lambda_inv_0_6_p23, 91.62274020012977 * Lambda_inv_0_6_p23, 91.62274020012977 *
      Lambda_inv_0_6_p23, 91.62274020012977 * Lambda_inv_0_6_p23, 91.62274020012977 *
      Lambda_inv_0_6_p23, Lambda_inv_6_7_p7) * Lambda_inv_6_6_p1;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_6_6_p3_lanes = Lambda_inv_6_6_p2_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_6_p29 * inverse_D19 * Lambda_inv_0_6_p29,
      Lambda_inv_0_6_p29 * inverse_D19 * Lambda_inv_0_6_p29, Lambda_inv_0_6_p29 * inverse_D19 *
      Lambda_inv_0_6_p29, Lambda_inv_0_6_p29 * inverse_D19 * Lambda_inv_0_6_p29,
      Lambda_inv_0_6_p29 * inverse_D19 * Lambda_inv_0_6_p29, Lambda_inv_0_6_p29 * inverse_D19 *
      Lambda_inv_0_6_p29, Lambda_inv_0_6_p29 * inverse_D19 * Lambda_inv_0_6_p29, Lambda_inv_6_7_p6 *
      Lambda_inv_0_6_p29);

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_6_6_p4_lanes = Lambda_inv_6_6_p3_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_6_p32 * inverse_D18 * Lambda_inv_0_6_p32,
      Lambda_inv_0_6_p32 * inverse_D18 * Lambda_inv_0_6_p32, Lambda_inv_0_6_p32 * inverse_D18 *
      Lambda_inv_0_6_p32, Lambda_inv_0_6_p32 * inverse_D18 * Lambda_inv_0_6_p32,
      Lambda_inv_0_6_p32 * inverse_D18 * Lambda_inv_0_6_p32, Lambda_inv_0_6_p32 * inverse_D18 *
      Lambda_inv_0_6_p32, Lambda_inv_0_6_p32 * inverse_D18 * Lambda_inv_0_6_p32, Lambda_inv_6_7_p5 *
      Lambda_inv_0_6_p32);

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_6_6_p5_lanes = Lambda_inv_6_6_p4_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_6_p38 * inverse_D17 * Lambda_inv_0_6_p38,
      Lambda_inv_0_6_p38 * inverse_D17 * Lambda_inv_0_6_p38, Lambda_inv_0_6_p38 * inverse_D17 *
      Lambda_inv_0_6_p38, Lambda_inv_0_6_p38 * inverse_D17 * Lambda_inv_0_6_p38,
      Lambda_inv_0_6_p38 * inverse_D17 * Lambda_inv_0_6_p38, Lambda_inv_0_6_p38 * inverse_D17 *
      Lambda_inv_0_6_p38, Lambda_inv_0_6_p38 * inverse_D17 * Lambda_inv_0_6_p38, Lambda_inv_6_7_p4 *
      Lambda_inv_0_6_p38);

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_6_6_p6_lanes = Lambda_inv_6_6_p5_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_6_p44 * inverse_D16 * Lambda_inv_0_6_p44,
      Lambda_inv_0_6_p44 * inverse_D16 * Lambda_inv_0_6_p44, Lambda_inv_0_6_p44 * inverse_D16 *
      Lambda_inv_0_6_p44, Lambda_inv_0_6_p44 * inverse_D16 * Lambda_inv_0_6_p44,
      Lambda_inv_0_6_p44 * inverse_D16 * Lambda_inv_0_6_p44, Lambda_inv_0_6_p44 * inverse_D16 *
      Lambda_inv_0_6_p44, Lambda_inv_0_6_p44 * inverse_D16 * Lambda_inv_0_6_p44, Lambda_inv_6_7_p3 *
      Lambda_inv_0_6_p44);

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_6_6_p7_lanes = Lambda_inv_6_6_p6_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_6_p50 * inverse_D15 * Lambda_inv_0_6_p50,
      Lambda_inv_0_6_p50 * inverse_D15 * Lambda_inv_0_6_p50, Lambda_inv_0_6_p50 * inverse_D15 *
      Lambda_inv_0_6_p50, Lambda_inv_0_6_p50 * inverse_D15 * Lambda_inv_0_6_p50,
      Lambda_inv_0_6_p50 * inverse_D15 * Lambda_inv_0_6_p50, Lambda_inv_0_6_p50 * inverse_D15 *
      Lambda_inv_0_6_p50, Lambda_inv_0_6_p50 * inverse_D15 * Lambda_inv_0_6_p50, Lambda_inv_6_7_p2 *
      Lambda_inv_0_6_p50);

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_6_6_p8_lanes = Lambda_inv_6_6_p7_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_6_p53 * inverse_D14 * Lambda_inv_0_6_p53,
      Lambda_inv_0_6_p53 * inverse_D14 * Lambda_inv_0_6_p53, Lambda_inv_0_6_p53 * inverse_D14 *
      Lambda_inv_0_6_p53, Lambda_inv_0_6_p53 * inverse_D14 * Lambda_inv_0_6_p53,
      Lambda_inv_0_6_p53 * inverse_D14 * Lambda_inv_0_6_p53, Lambda_inv_0_6_p53 * inverse_D14 *
      Lambda_inv_0_6_p53, Lambda_inv_0_6_p53 * inverse_D14 * Lambda_inv_0_6_p53, Lambda_inv_6_7_p1 *
      Lambda_inv_0_6_p53);

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_6_6_p9_lanes = Lambda_inv_6_6_p8_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_6_p155 * Lambda_inv_0_0_p666_lanes[6],
      Lambda_inv_0_6_p155 * Lambda_inv_0_0_p666_lanes[6], Lambda_inv_0_6_p155 *
      Lambda_inv_0_0_p666_lanes[6], Lambda_inv_0_6_p155 * Lambda_inv_0_0_p666_lanes[6],
      Lambda_inv_0_6_p155 * Lambda_inv_0_0_p666_lanes[6], Lambda_inv_0_6_p155 *
      Lambda_inv_0_0_p666_lanes[6], Lambda_inv_0_6_p155 * Lambda_inv_0_0_p666_lanes[6],
      Lambda_inv_0_7_p151 * Lambda_inv_0_0_p666_lanes[6]);

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_6_6_p10_lanes = Lambda_inv_6_6_p9_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p752_lanes[6] * Lambda_inv_0_0_p686_lanes[6],
      Lambda_inv_0_0_p752_lanes[6] * Lambda_inv_0_0_p686_lanes[6], Lambda_inv_0_0_p752_lanes[6] *
      Lambda_inv_0_0_p686_lanes[6], Lambda_inv_0_0_p752_lanes[6] * Lambda_inv_0_0_p686_lanes[6],
      Lambda_inv_0_0_p752_lanes[6] * Lambda_inv_0_0_p686_lanes[6], Lambda_inv_0_0_p752_lanes[6] *
      Lambda_inv_0_0_p686_lanes[6], Lambda_inv_0_0_p752_lanes[6] * Lambda_inv_0_0_p686_lanes[6],
      Lambda_inv_0_0_p752_lanes[7] * Lambda_inv_0_0_p686_lanes[6]);

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_6_6_p11_lanes = Lambda_inv_6_6_p10_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p750_lanes[6] * Lambda_inv_0_6_p103,
      Lambda_inv_0_0_p750_lanes[6] * Lambda_inv_0_6_p103, Lambda_inv_0_0_p750_lanes[6] *
      Lambda_inv_0_6_p103, Lambda_inv_0_0_p750_lanes[6] * Lambda_inv_0_6_p103,
      Lambda_inv_0_0_p750_lanes[6] * Lambda_inv_0_6_p103, Lambda_inv_0_0_p750_lanes[6] *
      Lambda_inv_0_6_p103, Lambda_inv_0_0_p750_lanes[6] * Lambda_inv_0_6_p103,
      Lambda_inv_0_0_p750_lanes[7] * Lambda_inv_0_6_p103);

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_6_6_p12_lanes = Lambda_inv_6_6_p11_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p748_lanes[6] * Lambda_inv_0_0_p714_lanes[6],
      Lambda_inv_0_0_p748_lanes[6] * Lambda_inv_0_0_p714_lanes[6], Lambda_inv_0_0_p748_lanes[6] *
      Lambda_inv_0_0_p714_lanes[6], Lambda_inv_0_0_p748_lanes[6] * Lambda_inv_0_0_p714_lanes[6],
      Lambda_inv_0_0_p748_lanes[6] * Lambda_inv_0_0_p714_lanes[6], Lambda_inv_0_0_p748_lanes[6] *
      Lambda_inv_0_0_p714_lanes[6], Lambda_inv_0_0_p748_lanes[6] * Lambda_inv_0_0_p714_lanes[6],
      Lambda_inv_0_0_p748_lanes[7] * Lambda_inv_0_0_p714_lanes[6]);

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_6_6_p13_lanes = Lambda_inv_6_6_p12_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p746_lanes[6] * Lambda_inv_0_0_p729_lanes[6],
      Lambda_inv_0_0_p746_lanes[6] * Lambda_inv_0_0_p729_lanes[6], Lambda_inv_0_0_p746_lanes[6] *
      Lambda_inv_0_0_p729_lanes[6], Lambda_inv_0_0_p746_lanes[6] * Lambda_inv_0_0_p729_lanes[6],
      Lambda_inv_0_0_p746_lanes[6] * Lambda_inv_0_0_p729_lanes[6], Lambda_inv_0_0_p746_lanes[6] *
      Lambda_inv_0_0_p729_lanes[6], Lambda_inv_0_0_p746_lanes[6] * Lambda_inv_0_0_p729_lanes[6],
      Lambda_inv_0_0_p746_lanes[7] * Lambda_inv_0_0_p729_lanes[6]);

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_6_6_lanes = Lambda_inv_6_6_p13_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_0_p744_lanes[6] * Lambda_inv_0_0_p743_lanes[6],
      Lambda_inv_0_0_p744_lanes[6] * Lambda_inv_0_0_p743_lanes[6], Lambda_inv_0_0_p744_lanes[6] *
      Lambda_inv_0_0_p743_lanes[6], Lambda_inv_0_0_p744_lanes[6] * Lambda_inv_0_0_p743_lanes[6],
      Lambda_inv_0_0_p744_lanes[6] * Lambda_inv_0_0_p743_lanes[6], Lambda_inv_0_0_p744_lanes[6] *
      Lambda_inv_0_0_p743_lanes[6], Lambda_inv_0_0_p744_lanes[6] * Lambda_inv_0_0_p743_lanes[6],
      Lambda_inv_0_0_p744_lanes[7] * Lambda_inv_0_0_p743_lanes[6]);
  Lambda_inv[78] = Lambda_inv_6_6_lanes[6];
  Lambda_inv[79] = Lambda_inv_6_6_lanes[7];
  Lambda_inv[90] = Lambda_inv_6_6_lanes[7];
  const Lanes Lambda_inv_6_8_p1_lanes = Lambda_inv_0_8_p196_lanes * Lambda_inv_0_0_p743_lanes[6];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_6_8_p2_lanes = Lambda_inv_0_8_p198_lanes * Lambda_inv_0_0_p729_lanes[6];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_6_8_p3_lanes = Lambda_inv_0_8_p200_lanes * Lambda_inv_0_0_p714_lanes[6];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_6_8_p4_lanes = Lambda_inv_0_8_p202_lanes * Lambda_inv_0_6_p103;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_6_8_p5_lanes = Lambda_inv_0_8_p204_lanes * Lambda_inv_0_0_p686_lanes[6];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_6_8_p6_lanes = Lambda_inv_0_8_p206_lanes * Lambda_inv_0_0_p666_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_6_8_p7_lanes = Lambda_inv_0_8_p96_lanes * inverse_D14;
  const Lanes Lambda_inv_6_8_p8_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_6_p53;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_6_8_p9_lanes = Lambda_inv_0_8_p73_lanes * inverse_D15;
  const Lanes Lambda_inv_6_8_p10_lanes = Lambda_inv_6_8_p9_lanes * Lambda_inv_0_6_p50;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_6_8_p11_lanes = Lambda_inv_0_8_p55_lanes * inverse_D16;
  const Lanes Lambda_inv_6_8_p12_lanes = Lambda_inv_6_8_p11_lanes * Lambda_inv_0_6_p44;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_6_8_p13_lanes = Lambda_inv_0_8_p35_lanes * inverse_D17;
  const Lanes Lambda_inv_6_8_p14_lanes = Lambda_inv_6_8_p13_lanes * Lambda_inv_0_6_p38;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_6_8_p15_lanes = detail::make_lanes<Real>(Lambda_inv_0_8_p21,
      Lambda_inv_0_9_p23, Lambda_inv_0_10_p23, Lambda_inv_0_11_p37, Lambda_inv_0_8_p21,
      Lambda_inv_0_8_p21, Lambda_inv_0_8_p21, Lambda_inv_0_8_p21) * inverse_D18;
  const Lanes Lambda_inv_6_8_p16_lanes = Lambda_inv_6_8_p15_lanes * Lambda_inv_0_6_p32;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_6_8_p17_lanes = Lambda_inv_0_8_p11_lanes * inverse_D19;
  const Lanes Lambda_inv_6_8_p18_lanes = Lambda_inv_6_8_p17_lanes * Lambda_inv_0_6_p29;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_inv_6_8_p19_lanes = 1065.380700001509 *
      detail::make_lanes<Real>(Lambda_inv_0_8_p2, Lambda_inv_0_6_p27, Lambda_inv_0_7_p21,
      Lambda_inv_0_11_p13, Lambda_inv_0_8_p2, Lambda_inv_0_8_p2, Lambda_inv_0_8_p2,
      Lambda_inv_0_8_p2);
  const Lanes Lambda_inv_6_8_p20_lanes = Lambda_inv_6_8_p19_lanes * Lambda_inv_6_6_p1;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_6_8_p21_lanes = Lambda_inv_6_8_p20_lanes + Lambda_inv_6_8_p18_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_6_8_p22_lanes = Lambda_inv_6_8_p21_lanes + Lambda_inv_6_8_p16_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_6_8_p23_lanes = Lambda_inv_6_8_p22_lanes + Lambda_inv_6_8_p14_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_6_8_p24_lanes = Lambda_inv_6_8_p23_lanes + Lambda_inv_6_8_p12_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_6_8_p25_lanes = Lambda_inv_6_8_p24_lanes + Lambda_inv_6_8_p10_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_6_8_p26_lanes = Lambda_inv_6_8_p25_lanes + Lambda_inv_6_8_p8_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_6_8_p27_lanes = Lambda_inv_6_8_p26_lanes + Lambda_inv_6_8_p6_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_6_8_p28_lanes = Lambda_inv_6_8_p27_lanes + Lambda_inv_6_8_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_6_8_p29_lanes = Lambda_inv_6_8_p28_lanes + Lambda_inv_6_8_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_6_8_p30_lanes = Lambda_inv_6_8_p29_lanes + Lambda_inv_6_8_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_6_8_p31_lanes = Lambda_inv_6_8_p30_lanes + Lambda_inv_6_8_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_6_8_lanes = Lambda_inv_6_8_p31_lanes + Lambda_inv_6_8_p1_lanes;
  Lambda_inv[80] = Lambda_inv_6_8_lanes[0];
  Lambda_inv[102] = Lambda_inv_6_8_lanes[0];
  Lambda_inv[81] = Lambda_inv_6_8_lanes[1];
  Lambda_inv[114] = Lambda_inv_6_8_lanes[1];
  Lambda_inv[82] = Lambda_inv_6_8_lanes[2];
  Lambda_inv[126] = Lambda_inv_6_8_lanes[2];
  Lambda_inv[83] = Lambda_inv_6_8_lanes[3];
  Lambda_inv[138] = Lambda_inv_6_8_lanes[3];

  // link 1 (calf), articulated inertia
  const Real Lambda_inv_7_7_p1 = 0.086 * Lambda_inv_0_7_p18;

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_7_7_p2 = Lambda_inv_6_7_p7 * Lambda_inv_7_7_p1 + Lambda_inv_6_7_p6 *
      Lambda_inv_0_7_p24 + Lambda_inv_6_7_p5 * Lambda_inv_0_7_p27 + Lambda_inv_6_7_p4 *
      Lambda_inv_0_7_p33 + Lambda_inv_6_7_p3 * Lambda_inv_0_7_p39;

  // link 5 (chest2), force propagation
  const Real Lambda_inv_7_7_p3 = Lambda_inv_7_7_p2 + Lambda_inv_6_7_p2 * Lambda_inv_0_7_p45 +
      Lambda_inv_6_7_p1 * Lambda_inv_0_7_p48 + Lambda_inv_0_7_p151 * Lambda_inv_0_0_p666_lanes[7] +
      Lambda_inv_0_0_p752_lanes[7] * Lambda_inv_0_0_p686_lanes[7];

  // link 1 (calf), force propagation
  Lambda_inv[91] = Lambda_inv_7_7_p3 + Lambda_inv_0_0_p750_lanes[7] * Lambda_inv_0_7_p99 +
      Lambda_inv_0_0_p748_lanes[7] * Lambda_inv_0_0_p714_lanes[7] + Lambda_inv_0_0_p746_lanes[7] *
      Lambda_inv_0_0_p729_lanes[7] + Lambda_inv_0_0_p744_lanes[7] * Lambda_inv_0_0_p743_lanes[7];
  const Lanes Lambda_inv_7_8_p1_lanes = Lambda_inv_0_8_p196_lanes * Lambda_inv_0_0_p743_lanes[7];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_7_8_p2_lanes = Lambda_inv_0_8_p198_lanes * Lambda_inv_0_0_p729_lanes[7];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_7_8_p3_lanes = Lambda_inv_0_8_p200_lanes * Lambda_inv_0_0_p714_lanes[7];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_7_8_p4_lanes = Lambda_inv_0_8_p202_lanes * Lambda_inv_0_7_p99;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_7_8_p5_lanes = Lambda_inv_0_8_p204_lanes * Lambda_inv_0_0_p686_lanes[7];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_7_8_p6_lanes = Lambda_inv_0_8_p206_lanes * Lambda_inv_0_0_p666_lanes[7];

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_7_8_p7_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_7_p48;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_7_8_p8_lanes = Lambda_inv_6_8_p9_lanes * Lambda_inv_0_7_p45;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_7_8_p9_lanes = Lambda_inv_6_8_p11_lanes * Lambda_inv_0_7_p39;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_7_8_p10_lanes = Lambda_inv_6_8_p13_lanes * Lambda_inv_0_7_p33;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_7_8_p11_lanes = Lambda_inv_6_8_p15_lanes * Lambda_inv_0_7_p27;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_7_8_p12_lanes = Lambda_inv_6_8_p17_lanes * Lambda_inv_0_7_p24;

  // link 20 (right_hand), force propagation
  const Lanes Lambda_inv_7_8_p13_lanes = Lambda_inv_6_8_p19_lanes * Lambda_inv_7_7_p1;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_7_8_p14_lanes = Lambda_inv_7_8_p13_lanes + Lambda_inv_7_8_p12_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_7_8_p15_lanes = Lambda_inv_7_8_p14_lanes + Lambda_inv_7_8_p11_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_7_8_p16_lanes = Lambda_inv_7_8_p15_lanes + Lambda_inv_7_8_p10_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_7_8_p17_lanes = Lambda_inv_7_8_p16_lanes + Lambda_inv_7_8_p9_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_7_8_p18_lanes = Lambda_inv_7_8_p17_lanes + Lambda_inv_7_8_p8_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_7_8_p19_lanes = Lambda_inv_7_8_p18_lanes + Lambda_inv_7_8_p7_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_7_8_p20_lanes = Lambda_inv_7_8_p19_lanes + Lambda_inv_7_8_p6_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_7_8_p21_lanes = Lambda_inv_7_8_p20_lanes + Lambda_inv_7_8_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_7_8_p22_lanes = Lambda_inv_7_8_p21_lanes + Lambda_inv_7_8_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_7_8_p23_lanes = Lambda_inv_7_8_p22_lanes + Lambda_inv_7_8_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_7_8_p24_lanes = Lambda_inv_7_8_p23_lanes + Lambda_inv_7_8_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_7_8_lanes = Lambda_inv_7_8_p24_lanes + Lambda_inv_7_8_p1_lanes;
  Lambda_inv[92] = Lambda_inv_7_8_lanes[0];
  Lambda_inv[103] = Lambda_inv_7_8_lanes[0];
  Lambda_inv[93] = Lambda_inv_7_8_lanes[1];
  Lambda_inv[115] = Lambda_inv_7_8_lanes[1];
  Lambda_inv[94] = Lambda_inv_7_8_lanes[2];
  Lambda_inv[127] = Lambda_inv_7_8_lanes[2];
  Lambda_inv[95] = Lambda_inv_7_8_lanes[3];
  Lambda_inv[139] = Lambda_inv_7_8_lanes[3];
  const Lanes Lambda_inv_8_8_p1_lanes = Lambda_inv_0_8_p196_lanes * Lambda_inv_0_8_p195_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_8_8_p2_lanes = Lambda_inv_0_8_p198_lanes * Lambda_inv_0_8_p184_lanes[0];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_8_8_p3_lanes = Lambda_inv_0_8_p200_lanes * Lambda_inv_0_8_p169_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_8_8_p4_lanes = Lambda_inv_0_8_p202_lanes * Lambda_inv_0_8_p154;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_8_8_p5_lanes = Lambda_inv_0_8_p204_lanes * Lambda_inv_0_8_p141_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_8_8_p6_lanes = Lambda_inv_0_8_p206_lanes * Lambda_inv_0_8_p126_lanes[0];

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_8_8_p7_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_8_p96_lanes[0];

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_8_8_p8_lanes = Lambda_inv_6_8_p9_lanes * Lambda_inv_0_8_p73_lanes[0];

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_8_8_p9_lanes = Lambda_inv_6_8_p11_lanes * Lambda_inv_0_8_p55_lanes[0];

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_8_8_p10_lanes = Lambda_inv_6_8_p13_lanes * Lambda_inv_0_8_p35_lanes[0];

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_8_8_p11_lanes = Lambda_inv_6_8_p15_lanes * Lambda_inv_0_8_p21;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_8_8_p12_lanes = Lambda_inv_6_8_p17_lanes * Lambda_inv_0_8_p11_lanes[0];

  // link 20 (right_hand), force propagation
  const Lanes Lambda_inv_8_8_p13_lanes = Lambda_inv_6_8_p19_lanes * Lambda_inv_0_8_p2;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_8_8_p14_lanes = Lambda_inv_8_8_p13_lanes + Lambda_inv_8_8_p12_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_8_8_p15_lanes = Lambda_inv_8_8_p14_lanes + Lambda_inv_8_8_p11_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_8_8_p16_lanes = Lambda_inv_8_8_p15_lanes + Lambda_inv_8_8_p10_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_8_8_p17_lanes = Lambda_inv_8_8_p16_lanes + Lambda_inv_8_8_p9_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_8_8_p18_lanes = Lambda_inv_8_8_p17_lanes + Lambda_inv_8_8_p8_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_8_8_p19_lanes = Lambda_inv_8_8_p18_lanes + Lambda_inv_8_8_p7_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_8_8_p20_lanes = Lambda_inv_8_8_p19_lanes + Lambda_inv_8_8_p6_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_8_8_p21_lanes = Lambda_inv_8_8_p20_lanes + Lambda_inv_8_8_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_8_8_p22_lanes = Lambda_inv_8_8_p21_lanes + Lambda_inv_8_8_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_8_8_p23_lanes = Lambda_inv_8_8_p22_lanes + Lambda_inv_8_8_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_8_8_p24_lanes = Lambda_inv_8_8_p23_lanes + Lambda_inv_8_8_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_8_8_lanes = Lambda_inv_8_8_p24_lanes + Lambda_inv_8_8_p1_lanes;
  Lambda_inv[104] = Lambda_inv_8_8_lanes[0];
  Lambda_inv[105] = Lambda_inv_8_8_lanes[1];
  Lambda_inv[116] = Lambda_inv_8_8_lanes[1];
  Lambda_inv[106] = Lambda_inv_8_8_lanes[2];
  Lambda_inv[128] = Lambda_inv_8_8_lanes[2];
  Lambda_inv[107] = Lambda_inv_8_8_lanes[3];
  Lambda_inv[140] = Lambda_inv_8_8_lanes[3];
  const Lanes Lambda_inv_9_9_p1_lanes = Lambda_inv_0_8_p196_lanes * Lambda_inv_0_8_p195_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_9_9_p2_lanes = Lambda_inv_0_8_p198_lanes * Lambda_inv_0_8_p184_lanes[1];

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_9_9_p3_lanes = Lambda_inv_0_8_p200_lanes * Lambda_inv_0_8_p169_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_9_9_p4_lanes = Lambda_inv_0_8_p202_lanes * Lambda_inv_0_9_p165;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_9_9_p5_lanes = Lambda_inv_0_8_p204_lanes * Lambda_inv_0_8_p141_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_9_9_p6_lanes = Lambda_inv_0_8_p206_lanes * Lambda_inv_0_8_p126_lanes[1];

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_9_9_p7_lanes = Lambda_inv_6_8_p7_lanes * Lambda_inv_0_8_p96_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_9_9_p8_lanes = Lambda_inv_6_8_p9_lanes * Lambda_inv_0_8_p73_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_9_9_p9_lanes = Lambda_inv_6_8_p11_lanes * Lambda_inv_0_8_p55_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_9_9_p10_lanes = Lambda_inv_6_8_p13_lanes * Lambda_inv_0_8_p35_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_9_9_p11_lanes = Lambda_inv_6_8_p15_lanes * Lambda_inv_0_9_p23;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_9_9_p12_lanes = Lambda_inv_6_8_p17_lanes * Lambda_inv_0_8_p11_lanes[1];

  // link 20 (right_hand), force propagation
  const Lanes Lambda_inv_9_9_p13_lanes = Lambda_inv_6_8_p19_lanes * Lambda_inv_0_6_p27;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_9_9_p14_lanes = Lambda_inv_9_9_p13_lanes + Lambda_inv_9_9_p12_lanes;

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_9_9_p15_lanes = Lambda_inv_9_9_p14_lanes + Lambda_inv_9_9_p11_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_9_9_p16_lanes = Lambda_inv_9_9_p15_lanes + Lambda_inv_9_9_p10_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_9_9_p17_lanes = Lambda_inv_9_9_p16_lanes + Lambda_inv_9_9_p9_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_9_9_p18_lanes = Lambda_inv_9_9_p17_lanes + Lambda_inv_9_9_p8_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_9_9_p19_lanes = Lambda_inv_9_9_p18_lanes + Lambda_inv_9_9_p7_lanes;

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_9_9_p20_lanes = Lambda_inv_9_9_p19_lanes + Lambda_inv_9_9_p6_lanes;

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_9_9_p21_lanes = Lambda_inv_9_9_p20_lanes + Lambda_inv_9_9_p5_lanes;

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_9_9_p22_lanes = Lambda_inv_9_9_p21_lanes + Lambda_inv_9_9_p4_lanes;

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_9_9_p23_lanes = Lambda_inv_9_9_p22_lanes + Lambda_inv_9_9_p3_lanes;

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_9_9_p24_lanes = Lambda_inv_9_9_p23_lanes + Lambda_inv_9_9_p2_lanes;

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_9_9_lanes = Lambda_inv_9_9_p24_lanes + Lambda_inv_9_9_p1_lanes;
  Lambda_inv[117] = Lambda_inv_9_9_lanes[1];
  Lambda_inv[118] = Lambda_inv_9_9_lanes[2];
  Lambda_inv[129] = Lambda_inv_9_9_lanes[2];
  Lambda_inv[119] = Lambda_inv_9_9_lanes[3];
  Lambda_inv[141] = Lambda_inv_9_9_lanes[3];

  // link 20 (right_hand), force propagation
  const Lanes Lambda_inv_10_10_p1_lanes = Lambda_inv_6_8_p19_lanes * Lambda_inv_0_7_p21;

  // link 19 (right_wrist2), force propagation
  const Lanes Lambda_inv_10_10_p2_lanes = Lambda_inv_10_10_p1_lanes +
      detail::make_lanes<Real>(Lambda_inv_6_8_p17_lanes[2] * Lambda_inv_0_8_p11_lanes[2],
      Lambda_inv_6_8_p17_lanes[2] * Lambda_inv_0_8_p11_lanes[2], Lambda_inv_6_8_p17_lanes[2] *
      Lambda_inv_0_8_p11_lanes[2], Lambda_inv_6_8_p17_lanes[3] * Lambda_inv_0_8_p11_lanes[2],
      Lambda_inv_6_8_p17_lanes[2] * Lambda_inv_0_8_p11_lanes[2], Lambda_inv_6_8_p17_lanes[2] *
      Lambda_inv_0_8_p11_lanes[2], Lambda_inv_6_8_p17_lanes[2] * Lambda_inv_0_8_p11_lanes[2],
      Lambda_inv_6_8_p17_lanes[2] * Lambda_inv_0_8_p11_lanes[2]);

  // link 18 (right_wrist1), force propagation
  const Lanes Lambda_inv_10_10_p3_lanes = Lambda_inv_10_10_p2_lanes +
      detail::make_lanes<Real>(Lambda_inv_6_8_p15_lanes[2] * Lambda_inv_0_10_p23,
      Lambda_inv_6_8_p15_lanes[2] * Lambda_inv_0_10_p23, Lambda_inv_6_8_p15_lanes[2] *
      Lambda_inv_0_10_p23, Lambda_inv_6_8_p15_lanes[3] * Lambda_inv_0_10_p23,
      Lambda_inv_6_8_p15_lanes[2] * Lambda_inv_0_10_p23, Lambda_inv_6_8_p15_lanes[2] *
      Lambda_inv_0_10_p23, Lambda_inv_6_8_p15_lanes[2] * Lambda_inv_0_10_p23,
      Lambda_inv_6_8_p15_lanes[2] * Lambda_inv_0_10_p23);

  // link 17 (right_lowerarm), force propagation
  const Lanes Lambda_inv_10_10_p4_lanes = Lambda_inv_10_10_p3_lanes +
      detail::make_lanes<Real>(Lambda_inv_6_8_p13_lanes[2] * Lambda_inv_0_8_p35_lanes[2],
      Lambda_inv_6_8_p13_lanes[2] * Lambda_inv_0_8_p35_lanes[2], Lambda_inv_6_8_p13_lanes[2] *
      Lambda_inv_0_8_p35_lanes[2], Lambda_inv_6_8_p13_lanes[3] * Lambda_inv_0_8_p35_lanes[2],
      Lambda_inv_6_8_p13_lanes[2] * Lambda_inv_0_8_p35_lanes[2], Lambda_inv_6_8_p13_lanes[2] *
      Lambda_inv_0_8_p35_lanes[2], Lambda_inv_6_8_p13_lanes[2] * Lambda_inv_0_8_p35_lanes[2],
      Lambda_inv_6_8_p13_lanes[2] * Lambda_inv_0_8_p35_lanes[2]);

  // link 16 (right_upperarm), force propagation
  const Lanes Lambda_inv_10_10_p5_lanes = Lambda_inv_10_10_p4_lanes +
      detail::make_lanes<Real>(Lambda_inv_6_8_p11_lanes[2] * Lambda_inv_0_8_p55_lanes[2],
      Lambda_inv_6_8_p11_lanes[2] * Lambda_inv_0_8_p55_lanes[2], Lambda_inv_6_8_p11_lanes[2] *
      Lambda_inv_0_8_p55_lanes[2], Lambda_inv_6_8_p11_lanes[3] * Lambda_inv_0_8_p55_lanes[2],
      Lambda_inv_6_8_p11_lanes[2] * Lambda_inv_0_8_p55_lanes[2], Lambda_inv_6_8_p11_lanes[2] *
      Lambda_inv_0_8_p55_lanes[2], Lambda_inv_6_8_p11_lanes[2] * Lambda_inv_0_8_p55_lanes[2],
      Lambda_inv_6_8_p11_lanes[2] * Lambda_inv_0_8_p55_lanes[2]);

  // link 15 (right_shoulder2), force propagation
  const Lanes Lambda_inv_10_10_p6_lanes = Lambda_inv_10_10_p5_lanes +
      detail::make_lanes<Real>(Lambda_inv_6_8_p9_lanes[2] * Lambda_inv_0_8_p73_lanes[2],
      Lambda_inv_6_8_p9_lanes[2] * Lambda_inv_0_8_p73_lanes[2], Lambda_inv_6_8_p9_lanes[2] *
      Lambda_inv_0_8_p73_lanes[2], Lambda_inv_6_8_p9_lanes[3] * Lambda_inv_0_8_p73_lanes[2],
      Lambda_inv_6_8_p9_lanes[2] * Lambda_inv_0_8_p73_lanes[2], Lambda_inv_6_8_p9_lanes[2] *
      Lambda_inv_0_8_p73_lanes[2], Lambda_inv_6_8_p9_lanes[2] * Lambda_inv_0_8_p73_lanes[2],
      Lambda_inv_6_8_p9_lanes[2] * Lambda_inv_0_8_p73_lanes[2]);

  // link 14 (right_shoulder1), force propagation
  const Lanes Lambda_inv_10_10_p7_lanes = Lambda_inv_10_10_p6_lanes +
      detail::make_lanes<Real>(Lambda_inv_6_8_p7_lanes[2] * Lambda_inv_0_8_p96_lanes[2],
      Lambda_inv_6_8_p7_lanes[2] * Lambda_inv_0_8_p96_lanes[2], Lambda_inv_6_8_p7_lanes[2] *
      Lambda_inv_0_8_p96_lanes[2], Lambda_inv_6_8_p7_lanes[3] * Lambda_inv_0_8_p96_lanes[2],
      Lambda_inv_6_8_p7_lanes[2] * Lambda_inv_0_8_p96_lanes[2], Lambda_inv_6_8_p7_lanes[2] *
      Lambda_inv_0_8_p96_lanes[2], Lambda_inv_6_8_p7_lanes[2] * Lambda_inv_0_8_p96_lanes[2],
      Lambda_inv_6_8_p7_lanes[2] * Lambda_inv_0_8_p96_lanes[2]);

  // link 6 (chest3), force propagation
  const Lanes Lambda_inv_10_10_p8_lanes = Lambda_inv_10_10_p7_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_8_p206_lanes[2] * Lambda_inv_0_8_p126_lanes[2],
      Lambda_inv_0_8_p206_lanes[2] * Lambda_inv_0_8_p126_lanes[2], Lambda_inv_0_8_p206_lanes[2] *
      Lambda_inv_0_8_p126_lanes[2], Lambda_inv_0_8_p206_lanes[3] * Lambda_inv_0_8_p126_lanes[2],
      Lambda_inv_0_8_p206_lanes[2] * Lambda_inv_0_8_p126_lanes[2], Lambda_inv_0_8_p206_lanes[2] *
      Lambda_inv_0_8_p126_lanes[2], Lambda_inv_0_8_p206_lanes[2] * Lambda_inv_0_8_p126_lanes[2],
      Lambda_inv_0_8_p206_lanes[2] * Lambda_inv_0_8_p126_lanes[2]);

  // link 5 (chest2), force propagation
  const Lanes Lambda_inv_10_10_p9_lanes = Lambda_inv_10_10_p8_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_8_p204_lanes[2] * Lambda_inv_0_8_p141_lanes[2],
      Lambda_inv_0_8_p204_lanes[2] * Lambda_inv_0_8_p141_lanes[2], Lambda_inv_0_8_p204_lanes[2] *
      Lambda_inv_0_8_p141_lanes[2], Lambda_inv_0_8_p204_lanes[3] * Lambda_inv_0_8_p141_lanes[2],
      Lambda_inv_0_8_p204_lanes[2] * Lambda_inv_0_8_p141_lanes[2], Lambda_inv_0_8_p204_lanes[2] *
      Lambda_inv_0_8_p141_lanes[2], Lambda_inv_0_8_p204_lanes[2] * Lambda_inv_0_8_p141_lanes[2],
      Lambda_inv_0_8_p204_lanes[2] * Lambda_inv_0_8_p141_lanes[2]);

  // link 4 (chest1), force propagation
  const Lanes Lambda_inv_10_10_p10_lanes = Lambda_inv_10_10_p9_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_8_p202_lanes[2] * Lambda_inv_0_10_p165,
      Lambda_inv_0_8_p202_lanes[2] * Lambda_inv_0_10_p165, Lambda_inv_0_8_p202_lanes[2] *
      Lambda_inv_0_10_p165, Lambda_inv_0_8_p202_lanes[3] * Lambda_inv_0_10_p165,
      Lambda_inv_0_8_p202_lanes[2] * Lambda_inv_0_10_p165, Lambda_inv_0_8_p202_lanes[2] *
      Lambda_inv_0_10_p165, Lambda_inv_0_8_p202_lanes[2] * Lambda_inv_0_10_p165,
      Lambda_inv_0_8_p202_lanes[2] * Lambda_inv_0_10_p165);

  // link 3 (hip), force propagation
  const Lanes Lambda_inv_10_10_p11_lanes = Lambda_inv_10_10_p10_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_8_p200_lanes[2] * Lambda_inv_0_8_p169_lanes[2],
      Lambda_inv_0_8_p200_lanes[2] * Lambda_inv_0_8_p169_lanes[2], Lambda_inv_0_8_p200_lanes[2] *
      Lambda_inv_0_8_p169_lanes[2], Lambda_inv_0_8_p200_lanes[3] * Lambda_inv_0_8_p169_lanes[2],
      Lambda_inv_0_8_p200_lanes[2] * Lambda_inv_0_8_p169_lanes[2], Lambda_inv_0_8_p200_lanes[2] *
      Lambda_inv_0_8_p169_lanes[2], Lambda_inv_0_8_p200_lanes[2] * Lambda_inv_0_8_p169_lanes[2],
      Lambda_inv_0_8_p200_lanes[2] * Lambda_inv_0_8_p169_lanes[2]);

  // link 2 (thigh), force propagation
  const Lanes Lambda_inv_10_10_p12_lanes = Lambda_inv_10_10_p11_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_8_p198_lanes[2] * Lambda_inv_0_8_p184_lanes[2],
      Lambda_inv_0_8_p198_lanes[2] * Lambda_inv_0_8_p184_lanes[2], Lambda_inv_0_8_p198_lanes[2] *
      Lambda_inv_0_8_p184_lanes[2], Lambda_inv_0_8_p198_lanes[3] * Lambda_inv_0_8_p184_lanes[2],
      Lambda_inv_0_8_p198_lanes[2] * Lambda_inv_0_8_p184_lanes[2], Lambda_inv_0_8_p198_lanes[2] *
      Lambda_inv_0_8_p184_lanes[2], Lambda_inv_0_8_p198_lanes[2] * Lambda_inv_0_8_p184_lanes[2],
      Lambda_inv_0_8_p198_lanes[2] * Lambda_inv_0_8_p184_lanes[2]);

  // link 1 (calf), force propagation
  const Lanes Lambda_inv_10_10_lanes = Lambda_inv_10_10_p12_lanes +
      detail::make_lanes<Real>(Lambda_inv_0_8_p196_lanes[2] * Lambda_inv_0_8_p195_lanes[2],
      Lambda_inv_0_8_p196_lanes[2] * Lambda_inv_0_8_p195_lanes[2], Lambda_inv_0_8_p196_lanes[2] *
      Lambda_inv_0_8_p195_lanes[2], Lambda_inv_0_8_p196_lanes[3] * Lambda_inv_0_8_p195_lanes[2],
      Lambda_inv_0_8_p196_lanes[2] * Lambda_inv_0_8_p195_lanes[2], Lambda_inv_0_8_p196_lanes[2] *
      Lambda_inv_0_8_p195_lanes[2], Lambda_inv_0_8_p196_lanes[2] * Lambda_inv_0_8_p195_lanes[2],
      Lambda_inv_0_8_p196_lanes[2] * Lambda_inv_0_8_p195_lanes[2]);
  Lambda_inv[130] = Lambda_inv_10_10_lanes[2];
  Lambda_inv[131] = Lambda_inv_10_10_lanes[3];
  Lambda_inv[142] = Lambda_inv_10_10_lanes[3];

  // link 16 (right_upperarm), force propagation
  const Real Lambda_inv_11_11_p1 = Lambda_inv_6_8_p19_lanes[3] * Lambda_inv_0_11_p13 +
      Lambda_inv_6_8_p17_lanes[3] * Lambda_inv_0_8_p11_lanes[3] + Lambda_inv_6_8_p15_lanes[3] *
      Lambda_inv_0_11_p37 + Lambda_inv_6_8_p13_lanes[3] * Lambda_inv_0_8_p35_lanes[3] +
      Lambda_inv_6_8_p11_lanes[3] * Lambda_inv_0_8_p55_lanes[3];

  // link 5 (chest2), force propagation
  const Real Lambda_inv_11_11_p2 = Lambda_inv_11_11_p1 + Lambda_inv_6_8_p9_lanes[3] *
      Lambda_inv_0_8_p73_lanes[3] + Lambda_inv_6_8_p7_lanes[3] * Lambda_inv_0_8_p96_lanes[3] +
      Lambda_inv_0_8_p206_lanes[3] * Lambda_inv_0_8_p126_lanes[3] + Lambda_inv_0_8_p204_lanes[3] *
      Lambda_inv_0_8_p141_lanes[3];

  // link 1 (calf), force propagation
  Lambda_inv[143] = Lambda_inv_11_11_p2 + Lambda_inv_0_8_p202_lanes[3] * Lambda_inv_0_11_p179 +
      Lambda_inv_0_8_p200_lanes[3] * Lambda_inv_0_8_p169_lanes[3] + Lambda_inv_0_8_p198_lanes[3] *
      Lambda_inv_0_8_p184_lanes[3] + Lambda_inv_0_8_p196_lanes[3] * Lambda_inv_0_8_p195_lanes[3];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
