// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at link origins.
// 8918 flops (add 3941, mul 4933, div 44), sine and cosine of 24 angles
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
void control_torque(const Real (&TREELINE_RESTRICT q)[24], const Real (&TREELINE_RESTRICT qd)[24],
    const Real (&TREELINE_RESTRICT qdd_0)[24], const Real (&TREELINE_RESTRICT xdd_cmd)[12],
    Real (&TREELINE_RESTRICT tau)[24]) noexcept {
  const Real angles[24] = {q[0], q[1], q[2], q[3], q[4], q[5], q[20], q[21], q[23], q[22], q[13],
      q[14], q[15], q[16], q[17], q[18], q[19], q[10], q[12], q[11], q[9], q[8], q[7], q[6]};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real c1 = cosines[0];
  const Real s1 = sines[0];
  const Real c2 = cosines[1];
  const Real s2 = sines[1];
  const Real c3 = cosines[2];
  const Real s3 = sines[2];
  const Real s4 = sines[3];
  const Real c4 = cosines[3];
  const Real s5 = sines[4];
  const Real c5 = cosines[4];
  const Real c6 = cosines[5];
  const Real s6 = sines[5];
  const Real s21 = sines[6];
  const Real c21 = cosines[6];
  const Real s22 = sines[7];
  const Real c22 = cosines[7];
  const Real c24 = cosines[8];
  const Real s24 = sines[8];
  const Real c23 = cosines[9];
  const Real s23 = sines[9];
  const Real s14 = sines[10];
  const Real c14 = cosines[10];
  const Real c15 = cosines[11];
  const Real s15 = sines[11];
  const Real c16 = cosines[12];
  const Real s16 = sines[12];
  const Real c17 = cosines[13];
  const Real s17 = sines[13];
  const Real c18 = cosines[14];
  const Real s18 = sines[14];
  const Real c19 = cosines[15];
  const Real s19 = sines[15];
  const Real s20 = sines[16];
  const Real c20 = cosines[16];
  const Real s11 = sines[17];
  const Real s13 = sines[18];
  const Real c13 = cosines[18];
  const Real s12 = sines[19];
  const Real c12 = cosines[19];
  const Real c11 = cosines[17];
  const Real s10 = sines[20];
  const Real c10 = cosines[20];
  const Real c9 = cosines[21];
  const Real s9 = sines[21];
  const Real s8 = sines[22];
  const Real c8 = cosines[22];
  const Real c7 = cosines[23];
  const Real s7 = sines[23];

  // link 13 (left_hand), articulated inertia
  const Real f13_x_p1 = 0.0002628975791811551 * c13 - 0.0007660844555829042 * s13;
  const Real f13_x_p2 = c13 * f13_x_p1 - 0.00013384878959057754;
  const Real inverse_D12_p1 = s13 * f13_x_p1;

  // link 12 (left_wrist2), articulated inertia
  const Real inverse_D12 = 1.0 / (0.0010519177038056625 + inverse_D12_p1);
  const Real f13_x_p3 = f13_x_p2 * inverse_D12;
  const Real f13_x_p4 = 0.0002742332482227584 - inverse_D12_p1 - f13_x_p2 * f13_x_p3;
  const Real f13_x_p5 = s12 * (1.16e-05 - f13_x_p4);

  // link 13 (left_hand), articulated inertia
  const Real f13_x_p6 = 0.001090468517736955 * s13 + 0.001742099791326752 * c13;
  const Real f13_x_p7 = s13 * f13_x_p6;
  const Real f13_x_p8 = f13_x_p7 - 0.000760024621759417;

  // link 12 (left_wrist2), articulated inertia
  const Real f13_x_p9 = f13_x_p8 * inverse_D12;

  // link 13 (left_hand), articulated inertia
  const Real f13_x_p10 = c13 * f13_x_p6;

  // link 12 (left_wrist2), articulated inertia
  const Real f13_x_p11 = f13_x_p10 - 0.002376125662528793 - f13_x_p2 * f13_x_p9;
  const Real f13_x_p12 = 0.0006000000000000001 * s12 + c12 * f13_x_p11;
  const Real f13_x_p13 = 0.000144 - (c12 * f13_x_p5 + 0.269 * f13_x_p12);
  const Real inverse_D11_p1 = s12 * f13_x_p5;

  // link 11 (left_wrist1), articulated inertia
  const Real inverse_D11 = 1.0 / (0.00022920000000000001 + (f13_x_p4 + inverse_D11_p1));
  const Real f13_x_p14 = f13_x_p13 * inverse_D11;

  // link 13 (left_hand), articulated inertia
  const Real f13_x_p15 = 0.27310176737964387 * s13 - 0.09929187165525127 * c13;
  const Real f13_x_p16 = s13 * f13_x_p15;

  // link 12 (left_wrist2), articulated inertia
  const Real f13_x_p17 = f13_x_p16 - 0.2818466605750157 - f13_x_p8 * f13_x_p9;
  const Real f13_x_p18 = s12 * f13_x_p11 - 0.0006000000000000001 * c12;
  const Real f13_x_p19 = 0.269 * f13_x_p17 - f13_x_p18;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p20 = 0.000131 - inverse_D11_p1 + 0.269 * (f13_x_p19 - f13_x_p18) - f13_x_p13 *
      f13_x_p14;

  // link 13 (left_hand), articulated inertia
  const Real f13_x_p21 = 0.0006340258712020409 + f13_x_p10;

  // link 12 (left_wrist2), articulated inertia
  const Real f13_x_p22 = f13_x_p21 * inverse_D12;
  const Real f13_x_p23 = 0.00033044389597753786 - f13_x_p7 - f13_x_p2 * f13_x_p22;

  // link 13 (left_hand), articulated inertia
  const Real f13_x_p24 = 0.0006000000000000001 + (0.002865001425 * s13 + 0.01626499875 * c13);

  // link 12 (left_wrist2), articulated inertia
  const Real f13_x_p25 = f13_x_p24 * inverse_D12;
  const Real f13_x_p26 = 0.01626499875 * s13 - 0.002865001425 * c13 + f13_x_p2 * f13_x_p25;
  const Real f13_x_p27 = s12 * f13_x_p23 - c12 * f13_x_p26;
  const Real f13_x_p28 = c12 * f13_x_p27;
  const Real f13_x_p29 = 0.0002516 - 0.269 * f13_x_p28;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p30 = f13_x_p29 * inverse_D11;

  // link 12 (left_wrist2), articulated inertia
  const Real f13_x_p31 = 0.008744893195371809 + f13_x_p16 + f13_x_p21 * f13_x_p22;
  const Real f13_x_p32 = f13_x_p24 * f13_x_p25;
  const Real f13_x_p33 = f13_x_p24 * f13_x_p22;
  const Real f13_x_p34 = s12 * (f13_x_p31 - f13_x_p32) + c12 * (2.0 * f13_x_p33);
  const Real f13_x_p35 = s12 * f13_x_p34;
  const Real f13_x_p36 = f13_x_p32 + f13_x_p35;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p37 = 0.0001098 - 0.07236100000000001 * f13_x_p36 - f13_x_p29 * f13_x_p30;

  // link 12 (left_wrist2), articulated inertia
  const Real f13_x_p38 = s12 * f13_x_p27;
  const Real f13_x_p39 = 0.04964593582762564 + c13 * f13_x_p15 - f13_x_p21 * f13_x_p9;
  const Real f13_x_p40 = f13_x_p24 * f13_x_p9;
  const Real f13_x_p41 = s12 * f13_x_p39 - c12 * f13_x_p40;
  const Real f13_x_p42 = 0.269 * f13_x_p41;
  const Real f13_x_p43 = f13_x_p38 - f13_x_p42;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p44 = 6e-06 + 0.269 * f13_x_p43 + f13_x_p13 * f13_x_p30;
  const Real f13_x_p45 = 2.0 * c11;
  const Real f13_x_p46 = s11 * (f13_x_p20 - f13_x_p37) - f13_x_p45 * f13_x_p44;
  const Real f13_x_p47 = c11 * f13_x_p46 + f13_x_p44 - 2.249994685315e-05;
  const Real inverse_D10_p1 = s11 * f13_x_p46;
  const Real inverse_D10_p2 = 0.060888541114265754 + (f13_x_p37 + inverse_D10_p1);

  // link 10 (left_lowerarm), articulated inertia
  const Real inverse_D10 = 1.0 / inverse_D10_p2;
  const Real f13_x_p48 = f13_x_p47 * inverse_D10;
  const Real f13_x_p49 = 0.06060754126741261 + (f13_x_p20 - inverse_D10_p1) - f13_x_p47 * f13_x_p48;
  const Real f13_x_p50 = 0.00028099984685315 - 2.249996661190239e-08 / inverse_D10_p2;
  const Real f13_x_p51 = 0.0001499998887063 / inverse_D10_p2;
  const Real f13_x_p52 = f13_x_p47 * f13_x_p51 - 0.0001499998887063;
  const Real f13_x_p53 = 2.0 * c10;
  const Real f13_x_p54 = s10 * (f13_x_p49 - f13_x_p50) + f13_x_p53 * f13_x_p52;

  // link 12 (left_wrist2), articulated inertia
  const Real f13_x_p55 = f13_x_p28 - 0.001;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p56 = f13_x_p55 * inverse_D11;
  const Real f13_x_p57 = f13_x_p43 - f13_x_p13 * f13_x_p56;

  // link 12 (left_wrist2), articulated inertia
  const Real f13_x_p58 = 6e-04 - f13_x_p12;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p59 = f13_x_p58 * inverse_D11;
  const Real f13_x_p60 = f13_x_p42 - f13_x_p29 * f13_x_p59;
  const Real f13_x_p61 = 0.269 * f13_x_p36 - f13_x_p29 * f13_x_p56;
  const Real f13_x_p62 = f13_x_p19 - f13_x_p13 * f13_x_p59;
  const Real f13_x_p63 = s11 * (f13_x_p57 - f13_x_p60) + c11 * (f13_x_p61 + f13_x_p62);
  const Real f13_x_p64 = s11 * f13_x_p63;
  const Real f13_x_p65 = f13_x_p60 + f13_x_p64;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p66 = f13_x_p65 * inverse_D10;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p67 = c11 * f13_x_p63;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p68 = 0.28049749700000004 + (f13_x_p67 - f13_x_p61) - f13_x_p47 * f13_x_p66;
  const Real f13_x_p69 = 0.0001499998887063 * f13_x_p66 - 0.0014999985000000002;
  const Real f13_x_p70 = s10 * f13_x_p68 + c10 * f13_x_p69;
  const Real f13_x_p71 = 0.0005895000784280001 + (c10 * f13_x_p54 - f13_x_p52 + 0.282 * f13_x_p70);

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p72 = f13_x_p67 - f13_x_p62 - 0.28049749700000004;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p73 = f13_x_p72 * inverse_D10;
  const Real f13_x_p74 = 0.0001499998887063 * f13_x_p73;

  // link 12 (left_wrist2), articulated inertia
  const Real f13_x_p75 = s12 * f13_x_p40 + c12 * f13_x_p39;
  const Real f13_x_p76 = f13_x_p23 - f13_x_p38;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p77 = f13_x_p76 * inverse_D11;
  const Real f13_x_p78 = 0.001 + (f13_x_p28 + f13_x_p26 - 0.269 * f13_x_p75) - f13_x_p13 *
      f13_x_p77;

  // link 12 (left_wrist2), articulated inertia
  const Real f13_x_p79 = c12 * f13_x_p34 - f13_x_p33;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p80 = 0.269 * f13_x_p79 - 6e-04 - f13_x_p29 * f13_x_p77;
  const Real f13_x_p81 = 0.0014999985000000002 - (s11 * f13_x_p78 + c11 * f13_x_p80);

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p82 = f13_x_p81 * inverse_D10;
  const Real f13_x_p83 = c11 * f13_x_p78 - s11 * f13_x_p80 + f13_x_p47 * f13_x_p82;
  const Real f13_x_p84 = f13_x_p57 - f13_x_p64 - f13_x_p47 * f13_x_p73;
  const Real f13_x_p85 = 0.0001499998887063 * f13_x_p82;
  const Real f13_x_p86 = s10 * (f13_x_p84 - f13_x_p85) + c10 * (f13_x_p74 - f13_x_p83);
  const Real f13_x_p87 = c10 * f13_x_p86;
  const Real f13_x_p88 = f13_x_p87 + f13_x_p83;
  const Real f13_x_p89 = 0.004500002325 + f13_x_p88;
  const Real inverse_D9_p1 = s10 * f13_x_p54;

  // link 9 (left_upperarm), articulated inertia
  const Real inverse_D9 = 1.0 / (0.0027762933559338653 + (f13_x_p50 + inverse_D9_p1));
  const Real f13_x_p90 = f13_x_p89 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p91 = s10 * f13_x_p86;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p92 = f13_x_p79 + f13_x_p55 * f13_x_p77;
  const Real f13_x_p93 = f13_x_p75 + f13_x_p58 * f13_x_p77;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p94 = s11 * f13_x_p92 + c11 * f13_x_p93 - f13_x_p81 * f13_x_p66;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p95 = f13_x_p36 + f13_x_p55 * f13_x_p56;
  const Real f13_x_p96 = f13_x_p17 - f13_x_p58 * f13_x_p59;
  const Real f13_x_p97 = f13_x_p41 + f13_x_p55 * f13_x_p59;
  const Real f13_x_p98 = s11 * (f13_x_p95 + f13_x_p96) + f13_x_p45 * f13_x_p97;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p99 = f13_x_p97 - c11 * f13_x_p98 - f13_x_p72 * f13_x_p66;
  const Real f13_x_p100 = s10 * f13_x_p94 - c10 * f13_x_p99;
  const Real f13_x_p101 = 0.282 * f13_x_p100;
  const Real f13_x_p102 = f13_x_p84 - f13_x_p91 - f13_x_p101;

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p103 = f13_x_p102 - f13_x_p71 * f13_x_p90;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p104 = 0.0022500062 + f13_x_p70;

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p105 = f13_x_p104 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p106 = 0.0012089992423205001 + 0.282 * f13_x_p88;

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p107 = f13_x_p101 + f13_x_p106 * f13_x_p105;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p108 = s10 * f13_x_p69 - c10 * f13_x_p68;

  // link 11 (left_wrist1), articulated inertia
  const Real f13_x_p109 = s11 * f13_x_p98;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p110 = f13_x_p96 - f13_x_p109 - f13_x_p65 * f13_x_p66;
  const Real f13_x_p111 = 0.282 * f13_x_p110 - f13_x_p108;

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p112 = f13_x_p111 - f13_x_p71 * f13_x_p105;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p113 = s11 * f13_x_p93 - c11 * f13_x_p92 + f13_x_p72 * f13_x_p82;
  const Real f13_x_p114 = f13_x_p109 - f13_x_p95 - f13_x_p72 * f13_x_p73;
  const Real f13_x_p115 = f13_x_p35 - f13_x_p31 - f13_x_p76 * f13_x_p77 - f13_x_p81 * f13_x_p82;
  const Real f13_x_p116 = f13_x_p53 * f13_x_p113 - s10 * (f13_x_p114 - f13_x_p115);
  const Real f13_x_p117 = s10 * f13_x_p116;
  const Real f13_x_p118 = f13_x_p114 + f13_x_p117;

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p119 = f13_x_p106 * f13_x_p90 - 0.282 * f13_x_p118;
  const Real f13_x_p120 = c9 * (f13_x_p103 - f13_x_p107) - s9 * (f13_x_p119 + f13_x_p112);
  const Real f13_x_p121 = c9 * f13_x_p120;
  const Real f13_x_p122 = f13_x_p107 + f13_x_p121;
  const Real inverse_D8_p1 = f13_x_p71 * inverse_D9;
  const Real inverse_D8_p2 = 0.0019585440854647937 +
      (f13_x_p49 - inverse_D9_p1 + 0.282 * (f13_x_p111 - f13_x_p108)) - f13_x_p71 * inverse_D8_p1;
  const Real inverse_D8_p3 = f13_x_p106 * inverse_D9;
  const Real inverse_D8_p4 = 0.0008177492704690715 + 0.07952399999999998 * f13_x_p118 - f13_x_p106 *
      inverse_D8_p3;
  const Real inverse_D8_p5 = 4.4999986458742003e-05 - 0.282 * f13_x_p102 + f13_x_p71 *
      inverse_D8_p3;
  const Real inverse_D8_p6 = 2.0 * s9;
  const Real inverse_D8_p7 = c9 * (inverse_D8_p2 - inverse_D8_p4) - inverse_D8_p6 * inverse_D8_p5;
  const Real inverse_D8_p8 = c9 * inverse_D8_p7;
  const Real inverse_D8_p9 = 0.18125194219699997 + (inverse_D8_p4 + inverse_D8_p8);

  // link 8 (left_shoulder2), articulated inertia
  const Real inverse_D8 = 1.0 / inverse_D8_p9;
  const Real f13_x_p123 = f13_x_p122 * inverse_D8;
  const Real f13_x_p124 = 0.0017499999999999998 + 0.00010499999999999999 * f13_x_p123;

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p125 = s9 * inverse_D8_p7 + inverse_D8_p5 - 1.75e-05;
  const Real f13_x_p126 = s9 * f13_x_p120;

  // link 8 (left_shoulder2), articulated inertia
  const Real f13_x_p127 = f13_x_p126 + f13_x_p119 - 0.7139200499999999 - f13_x_p125 * f13_x_p123;
  const Real f13_x_p128 = 0.0017499999999999998 + (s8 * f13_x_p124 + c8 * f13_x_p127);
  const Real inverse_D7_p1 = f13_x_p125 * inverse_D8;
  const Real inverse_D7_p2 = 0.18113119219699997 + (inverse_D8_p2 - inverse_D8_p8) - f13_x_p125 *
      inverse_D7_p1;
  const Real inverse_D7_p3 = 0.00012075 - 1.1024999999999998e-08 / inverse_D8_p9;
  const Real inverse_D7_p4 = 0.00010499999999999999 * inverse_D7_p1 - 5.2499999999999995e-05;
  const Real inverse_D7_p5 = 2.0 * c8;
  const Real inverse_D7_p6 = s8 * (inverse_D7_p3 - inverse_D7_p2) + inverse_D7_p5 * inverse_D7_p4;
  const Real inverse_D7_p7 = s8 * inverse_D7_p6;
  const Real inverse_D7_p8 = 0.000448 + (inverse_D7_p2 + inverse_D7_p7);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D7 = 1.0 / inverse_D7_p8;
  const Real f13_x_p129 = f13_x_p128 * inverse_D7;
  const Real f13_x_p130 = 2.6249999999999998e-05 * f13_x_p129;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p131 = f13_x_p85 + f13_x_p91;

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p132 = f13_x_p131 * inverse_D9;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p133 = s10 * f13_x_p99 + c10 * f13_x_p94;

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p134 = 0.004500002325 - (f13_x_p87 - f13_x_p74 + 0.282 * f13_x_p133) +
      f13_x_p71 * f13_x_p132;

  // link 10 (left_lowerarm), articulated inertia
  const Real f13_x_p135 = f13_x_p113 - c10 * f13_x_p116;

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p136 = 0.0022500062 + 0.282 * f13_x_p135 - f13_x_p106 * f13_x_p132;
  const Real f13_x_p137 = 0.0017499999999999998 + (c9 * f13_x_p134 - s9 * f13_x_p136);

  // link 8 (left_shoulder2), articulated inertia
  const Real f13_x_p138 = f13_x_p137 * inverse_D8;
  const Real f13_x_p139 = f13_x_p125 * f13_x_p138 - (s9 * f13_x_p134 + c9 * f13_x_p136);

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p140 = 0.7139200499999999 + (f13_x_p126 + f13_x_p112);

  // link 8 (left_shoulder2), articulated inertia
  const Real f13_x_p141 = f13_x_p140 * inverse_D8;
  const Real f13_x_p142 = 0.00010499999999999999 * f13_x_p141;
  const Real f13_x_p143 = f13_x_p103 - f13_x_p121 - f13_x_p125 * f13_x_p141;
  const Real f13_x_p144 = 0.00010499999999999999 * f13_x_p138;
  const Real f13_x_p145 = c8 * (f13_x_p139 + f13_x_p142) - s8 * (f13_x_p144 + f13_x_p143);
  const Real f13_x_p146 = c8 * f13_x_p145;
  const Real f13_x_p147 = 0.0017499999999999998 + (f13_x_p146 - f13_x_p142);

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p148 = f13_x_p147 * inverse_D7;

  // link 8 (left_shoulder2), articulated inertia
  const Real f13_x_p149 = c8 * inverse_D7_p6 - inverse_D7_p4 - 2.6249999999999998e-05;
  const Real f13_x_p150 = s8 * f13_x_p145;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p151 = f13_x_p144 + f13_x_p150 + f13_x_p149 * f13_x_p148;
  const Real f13_x_p152 = c8 * f13_x_p124 - s8 * f13_x_p127 - f13_x_p149 * f13_x_p129;
  const Real f13_x_p153 = 2.6249999999999998e-05 * f13_x_p148;
  const Real f13_x_p154 = c7 * (f13_x_p130 + f13_x_p151) - s7 * (f13_x_p152 + f13_x_p153);
  const Real f13_x_p155 = s7 * f13_x_p154;
  const Real f13_x_p156 = f13_x_p155 + f13_x_p153;

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p157 = f13_x_p118 - f13_x_p89 * f13_x_p90;
  const Real f13_x_p158 = f13_x_p110 - f13_x_p104 * f13_x_p105;
  const Real f13_x_p159 = f13_x_p100 + f13_x_p89 * f13_x_p105;
  const Real f13_x_p160 = c9 * (f13_x_p157 - f13_x_p158) + inverse_D8_p6 * f13_x_p159;
  const Real f13_x_p161 = c9 * f13_x_p160;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p162 = f13_x_p158 + f13_x_p161 - f13_x_p122 * f13_x_p123 - f13_x_p128 *
      f13_x_p129;

  // link 8 (left_shoulder2), articulated inertia
  const Real f13_x_p163 = f13_x_p157 - f13_x_p161 - f13_x_p140 * f13_x_p141;
  const Real f13_x_p164 = f13_x_p115 - f13_x_p117 - f13_x_p131 * f13_x_p132 - f13_x_p137 *
      f13_x_p138;

  // link 9 (left_upperarm), articulated inertia
  const Real f13_x_p165 = f13_x_p89 * f13_x_p132 - f13_x_p135;
  const Real f13_x_p166 = f13_x_p104 * f13_x_p132 - f13_x_p133;

  // link 8 (left_shoulder2), articulated inertia
  const Real f13_x_p167 = f13_x_p137 * f13_x_p141 - (s9 * f13_x_p165 + c9 * f13_x_p166);
  const Real f13_x_p168 = s8 * (f13_x_p164 - f13_x_p163) + inverse_D7_p5 * f13_x_p167;
  const Real f13_x_p169 = s8 * f13_x_p168;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p170 = f13_x_p164 - f13_x_p169 - f13_x_p147 * f13_x_p148;

  // link 8 (left_shoulder2), articulated inertia
  const Real f13_x_p171 = f13_x_p137 * f13_x_p123 - (c9 * f13_x_p165 - s9 * f13_x_p166);
  const Real f13_x_p172 = f13_x_p159 - s9 * f13_x_p160 + f13_x_p140 * f13_x_p123;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p173 = c8 * f13_x_p171 + s8 * f13_x_p172 - f13_x_p128 * f13_x_p148;
  const Real f13_x_p174 = 2.0 * s7;
  const Real f13_x_p175 = c7 * (f13_x_p162 - f13_x_p170) - f13_x_p174 * f13_x_p173;
  const Real f13_x_p176 = c7 * f13_x_p175;
  const Real f13_x_p177 = f13_x_p162 - f13_x_p176;

  // link 8 (left_shoulder2), articulated inertia
  const Real f13_x_p178 = f13_x_p143 + f13_x_p150;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p179 = f13_x_p178 * inverse_D7;
  const Real f13_x_p180 = s8 * f13_x_p171 - c8 * f13_x_p172 - f13_x_p128 * f13_x_p179;
  const Real f13_x_p181 = c8 * f13_x_p168 - f13_x_p167 - f13_x_p147 * f13_x_p179;
  const Real f13_x_p182 = s7 * f13_x_p180 + c7 * f13_x_p181;
  const Real f13_x_p183 = f13_x_p156 - (0.18 * f13_x_p177 + 0.226 * f13_x_p182);

  // link 20 (right_hand), articulated inertia
  const Real f13_x_p184 = 0.0007660844555829042 * s20 + 0.0002628975791811551 * c20;
  const Real f13_x_p185 = 0.00013384878959057754 - c20 * f13_x_p184;
  const Real inverse_D19_p1 = s20 * f13_x_p184;

  // link 19 (right_wrist2), articulated inertia
  const Real inverse_D19 = 1.0 / (0.0010519177038056625 - inverse_D19_p1);
  const Real f13_x_p186 = f13_x_p185 * inverse_D19;
  const Real f13_x_p187 = 0.0002742332482227584 + inverse_D19_p1 - f13_x_p185 * f13_x_p186;
  const Real f13_x_p188 = s19 * (1.16e-05 - f13_x_p187);

  // link 20 (right_hand), articulated inertia
  const Real f13_x_p189 = 0.001742099791326752 * c20 - 0.001090468517736955 * s20;
  const Real f13_x_p190 = s20 * f13_x_p189;
  const Real f13_x_p191 = 0.000760024621759417 + f13_x_p190;

  // link 19 (right_wrist2), articulated inertia
  const Real f13_x_p192 = f13_x_p191 * inverse_D19;

  // link 20 (right_hand), articulated inertia
  const Real f13_x_p193 = c20 * f13_x_p189;

  // link 19 (right_wrist2), articulated inertia
  const Real f13_x_p194 = f13_x_p193 - 0.002376125662528793 - f13_x_p185 * f13_x_p192;
  const Real f13_x_p195 = 0.0006000000000000001 * s19 + c19 * f13_x_p194;
  const Real f13_x_p196 = 0.000144 - (c19 * f13_x_p188 + 0.269 * f13_x_p195);
  const Real inverse_D18_p1 = s19 * f13_x_p188;

  // link 18 (right_wrist1), articulated inertia
  const Real inverse_D18 = 1.0 / (0.00022920000000000001 + (f13_x_p187 + inverse_D18_p1));

  // link 19 (right_wrist2), articulated inertia
  const Real f13_x_p197 = 6e-04 - f13_x_p195;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p198 = f13_x_p197 * inverse_D18;

  // link 20 (right_hand), articulated inertia
  const Real f13_x_p199 = 0.27310176737964387 * s20 + 0.09929187165525127 * c20;
  const Real f13_x_p200 = s20 * f13_x_p199;

  // link 19 (right_wrist2), articulated inertia
  const Real f13_x_p201 = f13_x_p200 - 0.2818466605750157 - f13_x_p191 * f13_x_p192;
  const Real f13_x_p202 = s19 * f13_x_p194 - 0.0006000000000000001 * c19;
  const Real f13_x_p203 = 0.269 * f13_x_p201 - f13_x_p202;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p204 = f13_x_p203 - f13_x_p196 * f13_x_p198;

  // link 20 (right_hand), articulated inertia
  const Real f13_x_p205 = 0.0006340258712020409 + f13_x_p193;

  // link 19 (right_wrist2), articulated inertia
  const Real f13_x_p206 = f13_x_p205 * inverse_D19;
  const Real f13_x_p207 = 0.00033044389597753786 + f13_x_p190 + f13_x_p185 * f13_x_p206;

  // link 20 (right_hand), articulated inertia
  const Real f13_x_p208 = 0.002865001425 * s20 - 0.01626499875 * c20 - 0.0006000000000000001;

  // link 19 (right_wrist2), articulated inertia
  const Real f13_x_p209 = f13_x_p208 * inverse_D19;
  const Real f13_x_p210 = 0.002865001425 * c20 + 0.01626499875 * s20 - f13_x_p185 * f13_x_p209;
  const Real f13_x_p211 = s19 * f13_x_p207 + c19 * f13_x_p210;
  const Real f13_x_p212 = c19 * f13_x_p211;
  const Real f13_x_p213 = 0.001 - f13_x_p212;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p214 = f13_x_p213 * inverse_D18;

  // link 19 (right_wrist2), articulated inertia
  const Real f13_x_p215 = 0.269 * f13_x_p212 - 0.0002516;
  const Real f13_x_p216 = 0.008744893195371809 + f13_x_p200 + f13_x_p205 * f13_x_p206;
  const Real f13_x_p217 = f13_x_p208 * f13_x_p209;
  const Real f13_x_p218 = f13_x_p208 * f13_x_p206;
  const Real f13_x_p219 = c19 * (2.0 * f13_x_p218) - s19 * (f13_x_p216 - f13_x_p217);
  const Real f13_x_p220 = s19 * f13_x_p219;
  const Real f13_x_p221 = f13_x_p220 - f13_x_p217;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p222 = 0.269 * f13_x_p221 + f13_x_p215 * f13_x_p214;

  // link 19 (right_wrist2), articulated inertia
  const Real f13_x_p223 = s19 * f13_x_p211;
  const Real f13_x_p224 = f13_x_p208 * f13_x_p192;
  const Real f13_x_p225 = c20 * f13_x_p199 - 0.04964593582762564 - f13_x_p205 * f13_x_p192;
  const Real f13_x_p226 = c19 * f13_x_p224 + s19 * f13_x_p225;
  const Real f13_x_p227 = 0.269 * f13_x_p226;
  const Real f13_x_p228 = f13_x_p223 + f13_x_p227;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p229 = f13_x_p228 + f13_x_p196 * f13_x_p214;
  const Real f13_x_p230 = f13_x_p227 - f13_x_p215 * f13_x_p198;
  const Real f13_x_p231 = c18 * (f13_x_p204 - f13_x_p222) - s18 * (f13_x_p229 + f13_x_p230);
  const Real f13_x_p232 = s18 * f13_x_p231;
  const Real f13_x_p233 = f13_x_p230 + f13_x_p232;
  const Real inverse_D17_p1 = f13_x_p196 * inverse_D18;
  const Real inverse_D17_p2 = 0.000131 - inverse_D18_p1 + 0.269 * (f13_x_p203 - f13_x_p202) -
      f13_x_p196 * inverse_D17_p1;
  const Real inverse_D17_p3 = f13_x_p215 * inverse_D18;
  const Real inverse_D17_p4 = 0.0001098 + 0.07236100000000001 * f13_x_p221 - f13_x_p215 *
      inverse_D17_p3;
  const Real inverse_D17_p5 = 6e-06 + 0.269 * f13_x_p228 - f13_x_p196 * inverse_D17_p3;
  const Real inverse_D17_p6 = 2.0 * c18;
  const Real inverse_D17_p7 = s18 * (inverse_D17_p2 - inverse_D17_p4) + inverse_D17_p6 *
      inverse_D17_p5;
  const Real inverse_D17_p8 = s18 * inverse_D17_p7;
  const Real inverse_D17_p9 = 0.060888541114265754 + (inverse_D17_p4 + inverse_D17_p8);

  // link 17 (right_lowerarm), articulated inertia
  const Real inverse_D17 = 1.0 / inverse_D17_p9;
  const Real f13_x_p234 = f13_x_p233 * inverse_D17;
  const Real f13_x_p235 = 0.0014999985000000002 + 0.0001499998887063 * f13_x_p234;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p236 = 2.249994685315e-05 + (c18 * inverse_D17_p7 - inverse_D17_p5);
  const Real f13_x_p237 = c18 * f13_x_p231;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p238 = 0.28049749700000004 + (f13_x_p237 + f13_x_p222) - f13_x_p236 * f13_x_p234;
  const Real f13_x_p239 = c17 * f13_x_p235 - s17 * f13_x_p238;
  const Real f13_x_p240 = 0.0001499998887063 / inverse_D17_p9;
  const Real f13_x_p241 = 0.0001499998887063 + f13_x_p236 * f13_x_p240;
  const Real f13_x_p242 = 2.0 * c17;
  const Real f13_x_p243 = f13_x_p236 * inverse_D17;
  const Real f13_x_p244 = 0.06060754126741261 + (inverse_D17_p2 - inverse_D17_p8) - f13_x_p236 *
      f13_x_p243;
  const Real f13_x_p245 = 0.00028099984685315 - 2.249996661190239e-08 / inverse_D17_p9;
  const Real f13_x_p246 = f13_x_p242 * f13_x_p241 - s17 * (f13_x_p244 - f13_x_p245);
  const Real f13_x_p247 = 0.282 * f13_x_p239 - (f13_x_p241 - c17 * f13_x_p246) -
      0.0005895000784280001;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p248 = f13_x_p237 - f13_x_p204 - 0.28049749700000004;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p249 = f13_x_p248 * inverse_D17;
  const Real f13_x_p250 = 0.0001499998887063 * f13_x_p249;

  // link 19 (right_wrist2), articulated inertia
  const Real f13_x_p251 = s19 * f13_x_p224 - c19 * f13_x_p225;
  const Real f13_x_p252 = f13_x_p223 - f13_x_p207;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p253 = f13_x_p252 * inverse_D18;
  const Real f13_x_p254 = 0.269 * f13_x_p251 - (f13_x_p212 - f13_x_p210) - 0.001 - f13_x_p196 *
      f13_x_p253;

  // link 19 (right_wrist2), articulated inertia
  const Real f13_x_p255 = f13_x_p218 - c19 * f13_x_p219;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p256 = 0.269 * f13_x_p255 - 6e-04 - f13_x_p215 * f13_x_p253;
  const Real f13_x_p257 = 0.0014999985000000002 - (s18 * f13_x_p254 + c18 * f13_x_p256);

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p258 = f13_x_p257 * inverse_D17;
  const Real f13_x_p259 = c18 * f13_x_p254 - s18 * f13_x_p256 + f13_x_p236 * f13_x_p258;
  const Real f13_x_p260 = f13_x_p229 + f13_x_p232 + f13_x_p236 * f13_x_p249;
  const Real f13_x_p261 = 0.0001499998887063 * f13_x_p258;
  const Real f13_x_p262 = c17 * (f13_x_p250 + f13_x_p259) - s17 * (f13_x_p261 - f13_x_p260);
  const Real f13_x_p263 = c17 * f13_x_p262;
  const Real f13_x_p264 = f13_x_p259 - f13_x_p263;
  const Real f13_x_p265 = 0.004500002325 - f13_x_p264;
  const Real inverse_D16_p1 = s17 * f13_x_p246;

  // link 16 (right_upperarm), articulated inertia
  const Real inverse_D16 = 1.0 / (0.0027762933559338653 + (f13_x_p245 - inverse_D16_p1));
  const Real f13_x_p266 = f13_x_p265 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p267 = s17 * f13_x_p262;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p268 = f13_x_p221 - f13_x_p213 * f13_x_p214;
  const Real f13_x_p269 = f13_x_p201 - f13_x_p197 * f13_x_p198;
  const Real f13_x_p270 = f13_x_p226 + f13_x_p213 * f13_x_p198;
  const Real f13_x_p271 = s18 * (f13_x_p268 - f13_x_p269) - inverse_D17_p6 * f13_x_p270;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p272 = c18 * f13_x_p271 + f13_x_p270 - f13_x_p248 * f13_x_p234;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p273 = f13_x_p251 - f13_x_p197 * f13_x_p253;
  const Real f13_x_p274 = f13_x_p255 + f13_x_p213 * f13_x_p253;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p275 = c18 * f13_x_p273 - s18 * f13_x_p274 + f13_x_p257 * f13_x_p234;
  const Real f13_x_p276 = c17 * f13_x_p272 + s17 * f13_x_p275;
  const Real f13_x_p277 = 0.282 * f13_x_p276;
  const Real f13_x_p278 = f13_x_p267 - f13_x_p260 + f13_x_p277;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p279 = f13_x_p278 - f13_x_p247 * f13_x_p266;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p280 = f13_x_p239 - 0.0022500062;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p281 = f13_x_p280 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p282 = 0.282 * f13_x_p264 - 0.0012089992423205001;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p283 = f13_x_p277 + f13_x_p282 * f13_x_p281;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p284 = c17 * f13_x_p238 + s17 * f13_x_p235;

  // link 18 (right_wrist1), articulated inertia
  const Real f13_x_p285 = s18 * f13_x_p271;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p286 = f13_x_p269 + f13_x_p285 - f13_x_p233 * f13_x_p234;
  const Real f13_x_p287 = f13_x_p284 + 0.282 * f13_x_p286;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p288 = f13_x_p287 - f13_x_p247 * f13_x_p281;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p289 = f13_x_p268 - f13_x_p285 - f13_x_p248 * f13_x_p249;
  const Real f13_x_p290 = f13_x_p216 + f13_x_p220 + f13_x_p252 * f13_x_p253 + f13_x_p257 *
      f13_x_p258;
  const Real f13_x_p291 = c18 * f13_x_p274 + s18 * f13_x_p273 - f13_x_p248 * f13_x_p258;
  const Real f13_x_p292 = s17 * (f13_x_p289 + f13_x_p290) + f13_x_p242 * f13_x_p291;
  const Real f13_x_p293 = s17 * f13_x_p292;
  const Real f13_x_p294 = f13_x_p289 - f13_x_p293;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p295 = 0.282 * f13_x_p294 + f13_x_p282 * f13_x_p266;
  const Real f13_x_p296 = c16 * (f13_x_p279 + f13_x_p283) - s16 * (f13_x_p288 - f13_x_p295);
  const Real f13_x_p297 = c16 * f13_x_p296;
  const Real f13_x_p298 = f13_x_p297 - f13_x_p283;
  const Real inverse_D15_p1 = f13_x_p247 * inverse_D16;
  const Real inverse_D15_p2 = 0.0019585440854647937 +
      (f13_x_p244 + inverse_D16_p1 + 0.282 * (f13_x_p284 + f13_x_p287)) - f13_x_p247 *
      inverse_D15_p1;
  const Real inverse_D15_p3 = f13_x_p282 * inverse_D16;
  const Real inverse_D15_p4 = 0.0008177492704690715 + 0.07952399999999998 * f13_x_p294 -
      f13_x_p282 * inverse_D15_p3;
  const Real inverse_D15_p5 = 4.4999986458742003e-05 + 0.282 * f13_x_p278 + f13_x_p247 *
      inverse_D15_p3;
  const Real inverse_D15_p6 = 2.0 * s16;
  const Real inverse_D15_p7 = c16 * (inverse_D15_p2 - inverse_D15_p4) + inverse_D15_p6 *
      inverse_D15_p5;
  const Real inverse_D15_p8 = c16 * inverse_D15_p7;
  const Real inverse_D15_p9 = 0.18125194219699997 + (inverse_D15_p4 + inverse_D15_p8);

  // link 15 (right_shoulder2), articulated inertia
  const Real inverse_D15 = 1.0 / inverse_D15_p9;
  const Real f13_x_p299 = f13_x_p298 * inverse_D15;
  const Real f13_x_p300 = 0.00010499999999999999 * f13_x_p299 - 0.0017499999999999998;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p301 = 1.75e-05 - (inverse_D15_p5 - s16 * inverse_D15_p7);
  const Real f13_x_p302 = s16 * f13_x_p296;

  // link 15 (right_shoulder2), articulated inertia
  const Real f13_x_p303 = 0.7139200499999999 + (f13_x_p295 - f13_x_p302) + f13_x_p301 * f13_x_p299;
  const Real f13_x_p304 = 0.0017499999999999998 + (s15 * f13_x_p300 - c15 * f13_x_p303);
  const Real inverse_D14_p1 = f13_x_p301 * inverse_D15;
  const Real inverse_D14_p2 = 0.18113119219699997 + (inverse_D15_p2 - inverse_D15_p8) - f13_x_p301 *
      inverse_D14_p1;
  const Real inverse_D14_p3 = 0.00012075 - 1.1024999999999998e-08 / inverse_D15_p9;
  const Real inverse_D14_p4 = 5.2499999999999995e-05 + 0.00010499999999999999 * inverse_D14_p1;
  const Real inverse_D14_p5 = 2.0 * c15;
  const Real inverse_D14_p6 = s15 * (inverse_D14_p3 - inverse_D14_p2) + inverse_D14_p5 *
      inverse_D14_p4;
  const Real inverse_D14_p7 = s15 * inverse_D14_p6;
  const Real inverse_D14_p8 = 0.000448 + (inverse_D14_p2 + inverse_D14_p7);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D14 = 1.0 / inverse_D14_p8;
  const Real f13_x_p305 = f13_x_p304 * inverse_D14;
  const Real f13_x_p306 = 2.6249999999999998e-05 * f13_x_p305;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p307 = 0.7139200499999999 + (f13_x_p302 + f13_x_p288);

  // link 15 (right_shoulder2), articulated inertia
  const Real f13_x_p308 = f13_x_p307 * inverse_D15;
  const Real f13_x_p309 = 0.00010499999999999999 * f13_x_p308;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p310 = f13_x_p261 + f13_x_p267;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p311 = f13_x_p310 * inverse_D16;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p312 = c17 * f13_x_p275 - s17 * f13_x_p272;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p313 = 0.282 * f13_x_p312 - (f13_x_p250 - f13_x_p263) - 0.004500002325 +
      f13_x_p247 * f13_x_p311;

  // link 17 (right_lowerarm), articulated inertia
  const Real f13_x_p314 = c17 * f13_x_p292 - f13_x_p291;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p315 = 0.0022500062 + 0.282 * f13_x_p314 + f13_x_p282 * f13_x_p311;
  const Real f13_x_p316 = 0.0017499999999999998 - (c16 * f13_x_p313 - s16 * f13_x_p315);

  // link 15 (right_shoulder2), articulated inertia
  const Real f13_x_p317 = f13_x_p316 * inverse_D15;
  const Real f13_x_p318 = s16 * f13_x_p313 + c16 * f13_x_p315 + f13_x_p301 * f13_x_p317;
  const Real f13_x_p319 = f13_x_p279 - f13_x_p297 - f13_x_p301 * f13_x_p308;
  const Real f13_x_p320 = 0.00010499999999999999 * f13_x_p317;
  const Real f13_x_p321 = s15 * (f13_x_p320 - f13_x_p319) + c15 * (f13_x_p309 - f13_x_p318);
  const Real f13_x_p322 = c15 * f13_x_p321;
  const Real f13_x_p323 = 0.0017499999999999998 + (f13_x_p322 - f13_x_p309);

  // link 14 (right_shoulder1), articulated inertia
  const Real f13_x_p324 = f13_x_p323 * inverse_D14;

  // link 15 (right_shoulder2), articulated inertia
  const Real f13_x_p325 = 2.6249999999999998e-05 + (c15 * inverse_D14_p6 - inverse_D14_p4);
  const Real f13_x_p326 = s15 * f13_x_p321;

  // link 14 (right_shoulder1), articulated inertia
  const Real f13_x_p327 = f13_x_p320 - f13_x_p326 - f13_x_p325 * f13_x_p324;
  const Real f13_x_p328 = c15 * f13_x_p300 + s15 * f13_x_p303 - f13_x_p325 * f13_x_p305;
  const Real f13_x_p329 = 2.6249999999999998e-05 * f13_x_p324;
  const Real f13_x_p330 = c14 * (f13_x_p306 + f13_x_p327) + s14 * (f13_x_p328 - f13_x_p329);
  const Real f13_x_p331 = s14 * f13_x_p330;
  const Real f13_x_p332 = f13_x_p331 + f13_x_p329;

  // link 15 (right_shoulder2), articulated inertia
  const Real f13_x_p333 = f13_x_p319 + f13_x_p326;

  // link 14 (right_shoulder1), articulated inertia
  const Real f13_x_p334 = f13_x_p333 * inverse_D14;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p335 = f13_x_p294 - f13_x_p265 * f13_x_p266;
  const Real f13_x_p336 = f13_x_p286 - f13_x_p280 * f13_x_p281;
  const Real f13_x_p337 = f13_x_p276 - f13_x_p265 * f13_x_p281;
  const Real f13_x_p338 = c16 * (f13_x_p335 - f13_x_p336) - inverse_D15_p6 * f13_x_p337;

  // link 15 (right_shoulder2), articulated inertia
  const Real f13_x_p339 = s16 * f13_x_p338 + f13_x_p337 - f13_x_p307 * f13_x_p299;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p340 = f13_x_p265 * f13_x_p311 - f13_x_p314;
  const Real f13_x_p341 = f13_x_p312 + f13_x_p280 * f13_x_p311;

  // link 15 (right_shoulder2), articulated inertia
  const Real f13_x_p342 = c16 * f13_x_p340 - s16 * f13_x_p341 + f13_x_p316 * f13_x_p299;

  // link 14 (right_shoulder1), articulated inertia
  const Real f13_x_p343 = c15 * f13_x_p339 - s15 * f13_x_p342 - f13_x_p304 * f13_x_p334;

  // link 16 (right_upperarm), articulated inertia
  const Real f13_x_p344 = c16 * f13_x_p338;

  // link 15 (right_shoulder2), articulated inertia
  const Real f13_x_p345 = f13_x_p335 - f13_x_p344 - f13_x_p307 * f13_x_p308;
  const Real f13_x_p346 = f13_x_p293 - f13_x_p290 - f13_x_p310 * f13_x_p311 - f13_x_p316 *
      f13_x_p317;
  const Real f13_x_p347 = s16 * f13_x_p340 + c16 * f13_x_p341 + f13_x_p316 * f13_x_p308;
  const Real f13_x_p348 = s15 * (f13_x_p346 - f13_x_p345) - inverse_D14_p5 * f13_x_p347;

  // link 14 (right_shoulder1), articulated inertia
  const Real f13_x_p349 = c15 * f13_x_p348 + f13_x_p347 - f13_x_p323 * f13_x_p334;
  const Real f13_x_p350 = s14 * f13_x_p343 + c14 * f13_x_p349;
  const Real f13_x_p351 = f13_x_p336 + f13_x_p344 - f13_x_p298 * f13_x_p299 - f13_x_p304 *
      f13_x_p305;

  // link 15 (right_shoulder2), articulated inertia
  const Real f13_x_p352 = s15 * f13_x_p348;

  // link 14 (right_shoulder1), articulated inertia
  const Real f13_x_p353 = f13_x_p346 - f13_x_p352 - f13_x_p323 * f13_x_p324;
  const Real f13_x_p354 = c15 * f13_x_p342 + s15 * f13_x_p339 + f13_x_p304 * f13_x_p324;
  const Real f13_x_p355 = 2.0 * s14;
  const Real f13_x_p356 = c14 * (f13_x_p351 - f13_x_p353) + f13_x_p355 * f13_x_p354;
  const Real f13_x_p357 = c14 * f13_x_p356;
  const Real f13_x_p358 = f13_x_p351 - f13_x_p357;
  const Real f13_x_p359 = f13_x_p332 + (0.226 * f13_x_p350 - 0.18 * f13_x_p358);

  // link 23 (left_eye), articulated inertia
  const Real f13_x_p360 = 0.0007770270270270272 * c23;
  const Real f13_x_p361 = c23 * f13_x_p360;

  // link 24 (right_eye), articulated inertia
  const Real f13_x_p362 = 0.0007770270270270272 * c24;
  const Real f13_x_p363 = c24 * f13_x_p362;

  // link 23 (left_eye), articulated inertia
  const Real f13_x_p364 = s23 * f13_x_p360;

  // link 24 (right_eye), articulated inertia
  const Real f13_x_p365 = s24 * f13_x_p362;

  // link 23 (left_eye), articulated inertia
  const Real f13_x_p366 = f13_x_p364 + f13_x_p365;
  const Real f13_x_p367 = 0.032 * (f13_x_p361 - f13_x_p363) - 0.095 * f13_x_p366;
  const Real f13_x_p368 = f13_x_p363 + f13_x_p361;
  const Real f13_x_p369 = 0.430445945945946 + f13_x_p368;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D22_p1 = 9.060810810810813e-05 * s24;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D22_p2 = 9.060810810810813e-05 * s23;
  const Real inverse_D22_p3 = s24 * inverse_D22_p1 + s23 * inverse_D22_p2;
  const Real inverse_D22_p4 = c24 + c23;

  // link 22 (head), articulated inertia
  const Real inverse_D22 = 1.0 / (0.063951825 - inverse_D22_p3 + 4.75e-05 * inverse_D22_p4);
  const Real f13_x_p370 = f13_x_p369 * inverse_D22;

  // link 24 (right_eye), articulated inertia
  const Real f13_x_p371 = 0.006756756756756757 * s24;
  const Real f13_x_p372 = c24 * f13_x_p371;
  const Real f13_x_p373 = s24 * f13_x_p371;
  const Real f13_x_p374 = 0.095 * f13_x_p372 - 0.032 * f13_x_p373;

  // link 23 (left_eye), articulated inertia
  const Real f13_x_p375 = 0.006756756756756757 * s23;
  const Real f13_x_p376 = c23 * f13_x_p375;
  const Real f13_x_p377 = s23 * f13_x_p375;
  const Real f13_x_p378 = 0.095 * f13_x_p376 + 0.032 * f13_x_p377;

  // link 22 (head), articulated inertia
  const Real f13_x_p379 = f13_x_p374 + f13_x_p378 + f13_x_p367 * f13_x_p370;

  // link 23 (left_eye), articulated inertia
  const Real f13_x_p380 = s24 + s23;
  const Real f13_x_p381 = 8e-06 * (c24 - c23) - (c24 * inverse_D22_p1 + c23 * inverse_D22_p2 +
      2.375e-05 * f13_x_p380);
  const Real f13_x_p382 = 0.072575 + 0.00025 * inverse_D22_p4;

  // link 22 (head), articulated inertia
  const Real f13_x_p383 = f13_x_p382 * inverse_D22;
  const Real f13_x_p384 = f13_x_p381 * f13_x_p383 + 0.00025 * f13_x_p380;
  const Real f13_x_p385 = f13_x_p367 * f13_x_p383;
  const Real f13_x_p386 = f13_x_p366 + f13_x_p381 * f13_x_p370;
  const Real f13_x_p387 = c22 * (f13_x_p379 + f13_x_p384) - s22 * (f13_x_p385 - f13_x_p386);
  const Real f13_x_p388 = s22 * f13_x_p387;
  const Real f13_x_p389 = f13_x_p385 + f13_x_p388;
  const Real inverse_D21_p1 = f13_x_p367 * inverse_D22;

  // link 24 (right_eye), articulated inertia
  const Real inverse_D21_p2 = f13_x_p373 - 0.006756756756756757;

  // link 23 (left_eye), articulated inertia
  const Real inverse_D21_p3 = f13_x_p377 - 0.006756756756756757;

  // link 22 (head), articulated inertia
  const Real inverse_D21_p4 = 0.095 * inverse_D21_p2 + 0.032 * f13_x_p372 +
      (0.095 * inverse_D21_p3 - 0.032 * f13_x_p376);
  const Real inverse_D21_p5 = 0.009438624999999999 - f13_x_p367 * inverse_D21_p1 + 0.095 *
      inverse_D21_p4 + 0.032 * (f13_x_p374 - f13_x_p378);
  const Real inverse_D21_p6 = 0.05450270000000001 + inverse_D22_p3 - f13_x_p381 * f13_x_p381 *
      inverse_D22 + 1.6e-05 * (s23 - s24) - 0.00017071621621621625;
  const Real inverse_D21_p7 = 0.0074 - f13_x_p381 * inverse_D21_p1 - 0.095 * f13_x_p368 + 0.032 *
      (f13_x_p365 - f13_x_p364);
  const Real inverse_D21_p8 = 2.0 * c22;
  const Real inverse_D21_p9 = s22 * (inverse_D21_p6 - inverse_D21_p5) + inverse_D21_p8 *
      inverse_D21_p7;
  const Real inverse_D21_p10 = s22 * inverse_D21_p9;

  // link 21 (neck), articulated inertia
  const Real inverse_D21 = 1.0 / (0.006216750000000001 + (inverse_D21_p5 + inverse_D21_p10));
  const Real f13_x_p390 = f13_x_p389 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real f13_x_p391 = c22 * f13_x_p387;
  const Real f13_x_p392 = f13_x_p384 - f13_x_p391;
  const Real f13_x_p393 = 0.394 * f13_x_p392;
  const Real f13_x_p394 = f13_x_p369 * f13_x_p383;
  const Real f13_x_p395 = f13_x_p373 + f13_x_p377 + f13_x_p369 * f13_x_p370;
  const Real f13_x_p396 = f13_x_p382 * f13_x_p383;
  const Real f13_x_p397 = inverse_D21_p8 * f13_x_p394 - s22 * (f13_x_p396 - f13_x_p395);
  const Real f13_x_p398 = f13_x_p394 - c22 * f13_x_p397;

  // link 21 (neck), articulated inertia
  const Real f13_x_p399 = 0.0045000000000000005 + 0.394 * f13_x_p398 + f13_x_p393 * f13_x_p390;

  // link 22 (head), articulated inertia
  const Real f13_x_p400 = f13_x_p366 * inverse_D22;
  const Real f13_x_p401 = 0.072575 + inverse_D21_p4 + f13_x_p367 * f13_x_p400;
  const Real f13_x_p402 = f13_x_p368 - 0.43200000000000005 - f13_x_p381 * f13_x_p400;
  const Real f13_x_p403 = c22 * f13_x_p401 - s22 * f13_x_p402;
  const Real f13_x_p404 = 0.0016155 + (c22 * inverse_D21_p9 - inverse_D21_p7 + 0.394 * f13_x_p403);
  const Real f13_x_p405 = f13_x_p382 * f13_x_p400;
  const Real f13_x_p406 = f13_x_p372 + f13_x_p376 - f13_x_p369 * f13_x_p400;
  const Real f13_x_p407 = c22 * f13_x_p405 - s22 * f13_x_p406;

  // link 21 (neck), articulated inertia
  const Real f13_x_p408 = f13_x_p379 - f13_x_p391 + 0.394 * f13_x_p407 + f13_x_p404 * f13_x_p390;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p409 = f13_x_p183 - (s21 * f13_x_p399 - c21 * f13_x_p408 + f13_x_p359);

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D6_p1 = f13_x_p325 * inverse_D14;
  const Real inverse_D6_p2 = 0.0002975 + (inverse_D14_p3 - inverse_D14_p7) - f13_x_p325 *
      inverse_D6_p1;
  const Real inverse_D6_p3 = 6.890624999999999e-10 / inverse_D14_p8;
  const Real inverse_D6_p4 = 2.6249999999999998e-05 * inverse_D6_p1;
  const Real inverse_D6_p5 = c14 * (0.0001505 - inverse_D6_p3 - inverse_D6_p2) + f13_x_p355 *
      (8.75e-06 + inverse_D6_p4);

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p6 = f13_x_p149 * inverse_D7;
  const Real inverse_D6_p7 = 0.0002975 + (inverse_D7_p3 - inverse_D7_p7) - f13_x_p149 *
      inverse_D6_p6;
  const Real inverse_D6_p8 = 0.0001505 - 6.890624999999999e-10 / inverse_D7_p8;
  const Real inverse_D6_p9 = 2.6249999999999998e-05 * inverse_D6_p6 - 8.75e-06;
  const Real inverse_D6_p10 = c7 * (inverse_D6_p8 - inverse_D6_p7) - f13_x_p174 * inverse_D6_p9;
  const Real inverse_D6_p11 = c14 * inverse_D6_p5 + c7 * inverse_D6_p10;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p12 = c22 * f13_x_p402 + s22 * f13_x_p401;
  const Real inverse_D6_p13 = inverse_D21_p2 + inverse_D21_p3 - f13_x_p366 * f13_x_p400;
  const Real inverse_D6_p14 = inverse_D6_p12 - 0.394 * inverse_D6_p13;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p15 = 0.005513625 + (inverse_D21_p6 - inverse_D21_p10 - 0.394 *
      (inverse_D6_p12 + inverse_D6_p14)) - f13_x_p404 * (f13_x_p404 * inverse_D21);
  const Real inverse_D6_p16 = f13_x_p393 * inverse_D21;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p17 = s22 * f13_x_p397;
  const Real inverse_D6_p18 = inverse_D6_p17 - f13_x_p395;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p19 = 0.000703125 + 0.155236 * inverse_D6_p18 - f13_x_p393 * inverse_D6_p16;

  // link 22 (head), articulated inertia
  const Real inverse_D6_p20 = c22 * f13_x_p406 + s22 * f13_x_p405;
  const Real inverse_D6_p21 = 0.394 * inverse_D6_p20;
  const Real inverse_D6_p22 = f13_x_p388 - f13_x_p386 - inverse_D6_p21;

  // link 21 (neck), articulated inertia
  const Real inverse_D6_p23 = 0.394 * inverse_D6_p22 - f13_x_p404 * inverse_D6_p16;
  const Real inverse_D6_p24 = 2.0 * s21;
  const Real inverse_D6_p25 = c21 * (inverse_D6_p15 - inverse_D6_p19) - inverse_D6_p24 *
      inverse_D6_p23;
  const Real inverse_D6_p26 = c21 * inverse_D6_p25;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p27 = 2.06965463592404 + inverse_D6_p19 + inverse_D6_p26 + inverse_D6_p2 +
      inverse_D6_p11 + inverse_D6_p7 - 0.18 * (f13_x_p332 + f13_x_p359 + (f13_x_p156 + f13_x_p183));

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D6_p28 = 0.0017499999999999998 + 2.6249999999999998e-05 * f13_x_p334;
  const Real inverse_D6_p29 = f13_x_p322 + f13_x_p318 - 0.0017499999999999998 - f13_x_p325 *
      f13_x_p334;
  const Real inverse_D6_p30 = c14 * inverse_D6_p28 + s14 * inverse_D6_p29;
  const Real inverse_D6_p31 = f13_x_p345 + f13_x_p352 - f13_x_p333 * f13_x_p334;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D6_p32 = 2.6249999999999998e-05 * f13_x_p179 - 0.0017499999999999998;
  const Real inverse_D6_p33 = f13_x_p146 - f13_x_p139 - 0.0017499999999999998 - f13_x_p149 *
      f13_x_p179;
  const Real inverse_D6_p34 = c7 * inverse_D6_p32 - s7 * inverse_D6_p33;
  const Real inverse_D6_p35 = f13_x_p163 + f13_x_p169 - f13_x_p178 * f13_x_p179;
  const Real inverse_D6_p36 = inverse_D6_p30 + (0.226 * inverse_D6_p31 - 0.18 * f13_x_p350) -
      (inverse_D6_p34 - (0.18 * f13_x_p182 + 0.226 * inverse_D6_p35));

  // link 6 (chest3), articulated inertia
  const Real inverse_D6 = 1.0 / (inverse_D6_p27 + 0.226 *
      (inverse_D6_p30 + inverse_D6_p36 - inverse_D6_p34));
  const Real f13_x_p410 = f13_x_p409 * inverse_D6;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p411 = c7 * f13_x_p154;
  const Real f13_x_p412 = s7 * f13_x_p175 + f13_x_p173;
  const Real f13_x_p413 = 0.18 * f13_x_p412;
  const Real f13_x_p414 = c7 * f13_x_p180 - s7 * f13_x_p181;
  const Real f13_x_p415 = 0.226 * f13_x_p414;
  const Real f13_x_p416 = f13_x_p411 - f13_x_p151 - (f13_x_p413 + f13_x_p415);
  const Real f13_x_p417 = f13_x_p130 - f13_x_p411;

  // link 14 (right_shoulder1), articulated inertia
  const Real f13_x_p418 = c14 * f13_x_p330;
  const Real f13_x_p419 = f13_x_p354 - s14 * f13_x_p356;
  const Real f13_x_p420 = 0.18 * f13_x_p419;
  const Real f13_x_p421 = c14 * f13_x_p343 - s14 * f13_x_p349;
  const Real f13_x_p422 = 0.226 * f13_x_p421;
  const Real f13_x_p423 = f13_x_p327 - f13_x_p418 - (f13_x_p420 + f13_x_p422);
  const Real f13_x_p424 = f13_x_p418 - f13_x_p306;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p425 = 0.0187281677636143 - inverse_D6_p4 + s14 * inverse_D6_p5 + s7 *
      inverse_D6_p10 + inverse_D6_p9 + 0.18 * (f13_x_p416 - f13_x_p417 - (f13_x_p423 - f13_x_p424));
  const Real f13_x_p426 = s14 * inverse_D6_p28 - c14 * inverse_D6_p29 -
      (s7 * inverse_D6_p32 + c7 * inverse_D6_p33);
  const Real f13_x_p427 = f13_x_p425 + 0.226 * f13_x_p426;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p428 = f13_x_p424 + f13_x_p420 + (f13_x_p417 + f13_x_p413) - f13_x_p427 *
      f13_x_p410;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p429 = f13_x_p423 + f13_x_p416;
  const Real f13_x_p430 = s21 * inverse_D6_p25 + inverse_D6_p23 + 0.226 * f13_x_p429;

  // link 21 (neck), articulated inertia
  const Real f13_x_p431 = f13_x_p392 * inverse_D21;
  const Real f13_x_p432 = inverse_D6_p22 - f13_x_p404 * f13_x_p431;

  // link 22 (head), articulated inertia
  const Real f13_x_p433 = 0.0045000000000000005 + f13_x_p403;

  // link 21 (neck), articulated inertia
  const Real f13_x_p434 = f13_x_p433 * inverse_D21;
  const Real f13_x_p435 = inverse_D6_p21 + f13_x_p393 * f13_x_p434;
  const Real f13_x_p436 = 0.394 * inverse_D6_p18 - f13_x_p393 * f13_x_p431;
  const Real f13_x_p437 = inverse_D6_p14 + f13_x_p404 * f13_x_p434;
  const Real f13_x_p438 = c21 * (f13_x_p432 - f13_x_p435) - s21 * (f13_x_p436 + f13_x_p437);
  const Real f13_x_p439 = s21 * f13_x_p438;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p440 = f13_x_p439 + f13_x_p437 - 6.1665928899999995 - inverse_D6_p36;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p441 = f13_x_p440 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real f13_x_p442 = c21 * f13_x_p438;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p443 = f13_x_p432 - f13_x_p442 + f13_x_p422 + f13_x_p415 - f13_x_p430 *
      f13_x_p441;
  const Real f13_x_p444 = f13_x_p419 - f13_x_p412;
  const Real f13_x_p445 = s21 * f13_x_p408 + c21 * f13_x_p399 - f13_x_p430 * f13_x_p410 - 0.226 *
      f13_x_p444;
  const Real f13_x_p446 = 0.18 * (f13_x_p414 - f13_x_p421) - (f13_x_p426 + f13_x_p427 * f13_x_p441);
  const Real f13_x_p447 = s6 * (f13_x_p428 - f13_x_p443) + c6 * (f13_x_p445 + f13_x_p446);
  const Real f13_x_p448 = s6 * f13_x_p447;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p449 = f13_x_p435 + f13_x_p442 + f13_x_p429;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p450 = f13_x_p449 * inverse_D6;

  // link 21 (neck), articulated inertia
  const Real f13_x_p451 = f13_x_p398 + f13_x_p392 * f13_x_p390;
  const Real f13_x_p452 = f13_x_p407 + f13_x_p433 * f13_x_p390;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p453 = c21 * f13_x_p451 + s21 * f13_x_p452 - f13_x_p444 - f13_x_p409 *
      f13_x_p450;

  // link 21 (neck), articulated inertia
  const Real f13_x_p454 = inverse_D6_p18 - f13_x_p392 * f13_x_p431;
  const Real f13_x_p455 = inverse_D6_p13 - f13_x_p433 * f13_x_p434;
  const Real f13_x_p456 = inverse_D6_p20 + f13_x_p392 * f13_x_p434;
  const Real f13_x_p457 = c21 * (f13_x_p454 - f13_x_p455) - inverse_D6_p24 * f13_x_p456;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p458 = s21 * f13_x_p457 + f13_x_p456 + f13_x_p421 + f13_x_p414 - f13_x_p440 *
      f13_x_p450;
  const Real f13_x_p459 = s6 * f13_x_p453 + c6 * f13_x_p458;
  const Real f13_x_p460 = 0.072 * f13_x_p459;
  const Real f13_x_p461 = f13_x_p443 + f13_x_p448 + f13_x_p460;

  // link 7 (left_shoulder1), articulated inertia
  const Real inverse_D5_p1 = f13_x_p155 + f13_x_p152;
  const Real inverse_D5_p2 = f13_x_p170 + f13_x_p176;
  const Real inverse_D5_p3 = inverse_D5_p1 + 0.18 * inverse_D5_p2;

  // link 14 (right_shoulder1), articulated inertia
  const Real inverse_D5_p4 = f13_x_p331 - f13_x_p328;
  const Real inverse_D5_p5 = f13_x_p353 + f13_x_p357;
  const Real inverse_D5_p6 = inverse_D5_p4 + 0.18 * inverse_D5_p5;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p7 = inverse_D5_p3 - inverse_D5_p6 - f13_x_p427 * f13_x_p450;
  const Real inverse_D5_p8 = inverse_D5_p5 + inverse_D5_p2;
  const Real inverse_D5_p9 = 6.1665928899999995 + f13_x_p439 + f13_x_p436 - f13_x_p430 *
      f13_x_p450 + 0.226 * inverse_D5_p8;
  const Real inverse_D5_p10 = s6 * inverse_D5_p7 + c6 * inverse_D5_p9;

  // link 21 (neck), articulated inertia
  const Real inverse_D5_p11 = c21 * f13_x_p457;

  // link 6 (chest3), articulated inertia
  const Real inverse_D5_p12 = f13_x_p455 + inverse_D5_p11 + inverse_D5_p8 - f13_x_p449 * f13_x_p450;
  const Real inverse_D5_p13 = inverse_D5_p10 + 0.072 * inverse_D5_p12;
  const Real inverse_D5_p14 = f13_x_p427 * inverse_D6;
  const Real inverse_D5_p15 = 0.40056549999999996 - inverse_D6_p3 - inverse_D6_p11 + inverse_D6_p8 -
      f13_x_p427 * inverse_D5_p14 + 0.18 * (inverse_D5_p4 + inverse_D5_p6 +
      (inverse_D5_p1 + inverse_D5_p3));
  const Real inverse_D5_p16 = f13_x_p430 * inverse_D6;
  const Real inverse_D5_p17 = 1.66923963592404 + inverse_D6_p15 - inverse_D6_p26 - f13_x_p430 *
      inverse_D5_p16 + 0.051076 * inverse_D5_p8;
  const Real inverse_D5_p18 = 0.04068 * (inverse_D5_p2 - inverse_D5_p5) - f13_x_p427 *
      inverse_D5_p16 + 0.226 * (inverse_D5_p1 - inverse_D5_p4);
  const Real inverse_D5_p19 = 2.0 * c6;
  const Real inverse_D5_p20 = s6 * (inverse_D5_p15 - inverse_D5_p17) + inverse_D5_p19 *
      inverse_D5_p18;
  const Real inverse_D5_p21 = s6 * inverse_D5_p20;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (0.203126912024134 +
      (inverse_D5_p17 + inverse_D5_p21 + 0.072 * (inverse_D5_p10 + inverse_D5_p13)));
  const Real f13_x_p462 = f13_x_p461 * inverse_D5;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p463 = 0.072 * f13_x_p461;
  const Real f13_x_p464 = f13_x_p358 - (f13_x_p396 + inverse_D6_p17 + f13_x_p389 * f13_x_p390) +
      f13_x_p177 - f13_x_p409 * f13_x_p410;
  const Real f13_x_p465 = f13_x_p454 - inverse_D5_p11 + inverse_D6_p31 + inverse_D6_p35 -
      f13_x_p440 * f13_x_p441;
  const Real f13_x_p466 = s21 * f13_x_p451 - c21 * f13_x_p452 + f13_x_p350 + f13_x_p182 -
      f13_x_p409 * f13_x_p441;
  const Real f13_x_p467 = s6 * (f13_x_p464 - f13_x_p465) + inverse_D5_p19 * f13_x_p466;
  const Real f13_x_p468 = s6 * f13_x_p467;
  const Real f13_x_p469 = f13_x_p465 + f13_x_p468;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p470 = f13_x_p463 * f13_x_p462 - (2.2194301519999997 + 0.072 * f13_x_p469);

  // link 6 (chest3), articulated inertia
  const Real f13_x_p471 = c6 * inverse_D5_p7 - s6 * inverse_D5_p9;
  const Real f13_x_p472 = c6 * inverse_D5_p20 - inverse_D5_p18 + 0.072 * f13_x_p471;
  const Real f13_x_p473 = c6 * f13_x_p447;
  const Real f13_x_p474 = f13_x_p473 - f13_x_p445;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p475 = f13_x_p474 - 0.069699984375 - f13_x_p472 * f13_x_p462;
  const Real f13_x_p476 = s5 * f13_x_p470 + c5 * f13_x_p475;
  const Real f13_x_p477 = f13_x_p463 * inverse_D5;
  const Real f13_x_p478 = 0.15637308509675518 + 0.005183999999999999 * f13_x_p469 - f13_x_p463 *
      f13_x_p477;
  const Real f13_x_p479 = f13_x_p472 * inverse_D5;
  const Real f13_x_p480 = 0.04675382692737882 + (inverse_D5_p15 - inverse_D5_p21) - f13_x_p472 *
      f13_x_p479;
  const Real f13_x_p481 = 0.005678398088837119 - 0.072 * f13_x_p474 + f13_x_p463 * f13_x_p479;
  const Real f13_x_p482 = 2.0 * c5;
  const Real f13_x_p483 = s5 * (f13_x_p478 - f13_x_p480) + f13_x_p482 * f13_x_p481;
  const Real f13_x_p484 = 0.005880002159562879 + (0.21799999999999997 * f13_x_p476 -
      (c5 * f13_x_p483 - f13_x_p481));

  // link 6 (chest3), articulated inertia
  const Real f13_x_p485 = 2.2194301519999997 + inverse_D5_p13;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p486 = f13_x_p485 * inverse_D5;
  const Real f13_x_p487 = f13_x_p463 * f13_x_p486 - f13_x_p460;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p488 = c6 * f13_x_p453 - s6 * f13_x_p458;
  const Real f13_x_p489 = 0.069699984375 + (f13_x_p473 - f13_x_p446 + 0.072 * f13_x_p488);

  // link 5 (chest2), articulated inertia
  const Real f13_x_p490 = f13_x_p489 * inverse_D5;
  const Real f13_x_p491 = f13_x_p428 - f13_x_p448 - f13_x_p472 * f13_x_p490;
  const Real f13_x_p492 = f13_x_p471 - f13_x_p472 * f13_x_p486;

  // link 6 (chest3), articulated inertia
  const Real f13_x_p493 = c6 * f13_x_p467 - f13_x_p466;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p494 = f13_x_p463 * f13_x_p490 - 0.072 * f13_x_p493;
  const Real f13_x_p495 = s5 * (f13_x_p487 - f13_x_p491) + c5 * (f13_x_p492 + f13_x_p494);
  const Real f13_x_p496 = c5 * f13_x_p495;
  const Real f13_x_p497 = f13_x_p496 - f13_x_p494;
  const Real inverse_D4_p1 = s5 * f13_x_p483;

  // link 4 (chest1), articulated inertia
  const Real inverse_D4 = 1.0 / (0.060169103246295166 + (f13_x_p480 + inverse_D4_p1));
  const Real f13_x_p498 = f13_x_p497 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p499 = s5 * f13_x_p495;
  const Real f13_x_p500 = f13_x_p493 - f13_x_p489 * f13_x_p462;
  const Real f13_x_p501 = f13_x_p459 - f13_x_p485 * f13_x_p462;
  const Real f13_x_p502 = s5 * f13_x_p500 - c5 * f13_x_p501;
  const Real f13_x_p503 = 0.21799999999999997 * f13_x_p502;
  const Real f13_x_p504 = f13_x_p487 - f13_x_p499 + f13_x_p503;
  const Real f13_x_p505 = 0.21799999999999997 * f13_x_p497;
  const Real f13_x_p506 = 0.0300000063 + f13_x_p476;

  // link 4 (chest1), articulated inertia
  const Real f13_x_p507 = f13_x_p506 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p508 = f13_x_p464 - f13_x_p468 - f13_x_p489 * f13_x_p490;
  const Real f13_x_p509 = inverse_D5_p12 - f13_x_p485 * f13_x_p486;
  const Real f13_x_p510 = f13_x_p488 - f13_x_p485 * f13_x_p490;
  const Real f13_x_p511 = s5 * (f13_x_p509 - f13_x_p508) + f13_x_p482 * f13_x_p510;
  const Real f13_x_p512 = s5 * f13_x_p511;
  const Real f13_x_p513 = f13_x_p509 - f13_x_p512;
  const Real f13_x_p514 = s5 * f13_x_p475 - c5 * f13_x_p470;
  const Real f13_x_p515 = f13_x_p469 - f13_x_p461 * f13_x_p462;
  const Real f13_x_p516 = f13_x_p514 + 0.21799999999999997 * f13_x_p515;

  // link 4 (chest1), articulated inertia
  const Real f13_x_p517 = f13_x_p484 * f13_x_p507 - f13_x_p516;
  const Real f13_x_p518 = s4 * (f13_x_p504 + f13_x_p484 * f13_x_p498 +
      (f13_x_p503 + f13_x_p505 * f13_x_p507)) + c4 * (0.21799999999999997 * f13_x_p513 -
      f13_x_p505 * f13_x_p498 + f13_x_p517);
  const Real f13_x_p519 = 8.419374554 + (c4 * f13_x_p518 - f13_x_p517);
  const Real inverse_D3_p1 = f13_x_p484 * inverse_D4;
  const Real inverse_D3_p2 = f13_x_p505 * inverse_D4;
  const Real inverse_D3_p3 = 0.01227760324629517 + 0.04752399999999999 * f13_x_p513 - f13_x_p505 *
      inverse_D3_p2;
  const Real inverse_D3_p4 = 0.0478915 + (f13_x_p478 - inverse_D4_p1 + 0.21799999999999997 *
      (f13_x_p514 + f13_x_p516)) - f13_x_p484 * inverse_D3_p1 - inverse_D3_p3;
  const Real inverse_D3_p5 = 2.0 * c4;
  const Real inverse_D3_p6 = inverse_D3_p3 + s4 * (s4 * inverse_D3_p4 + inverse_D3_p5 *
      (0.21799999999999997 * f13_x_p504 + f13_x_p484 * inverse_D3_p2));

  // link 3 (hip), articulated inertia
  const Real inverse_D3 = 1.0 / (1.7824817919087104 + inverse_D3_p6);
  const Real f13_x_p520 = f13_x_p519 * inverse_D3;

  // link 4 (chest1), articulated inertia
  const Real f13_x_p521 = f13_x_p513 - f13_x_p497 * f13_x_p498;
  const Real f13_x_p522 = s4 * (f13_x_p521 - (f13_x_p515 - f13_x_p506 * f13_x_p507)) -
      inverse_D3_p5 * (f13_x_p502 + f13_x_p497 * f13_x_p507);

  // link 3 (hip), articulated inertia
  const Real f13_x_p523 = f13_x_p521 - s4 * f13_x_p522 - f13_x_p519 * f13_x_p520;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p524 = f13_x_p491 + f13_x_p499;

  // link 4 (chest1), articulated inertia
  const Real f13_x_p525 = f13_x_p524 * inverse_D4;

  // link 5 (chest2), articulated inertia
  const Real f13_x_p526 = s5 * f13_x_p501 + c5 * f13_x_p500;
  const Real f13_x_p527 = c5 * f13_x_p511 - f13_x_p510;

  // link 4 (chest1), articulated inertia
  const Real f13_x_p528 = s4 * (0.21799999999999997 * f13_x_p526 - (f13_x_p496 - f13_x_p492) -
      f13_x_p484 * f13_x_p525) + c4 * (0.0300000063 - 0.21799999999999997 * f13_x_p527 +
      f13_x_p505 * f13_x_p525);
  const Real f13_x_p529 = 0.02999999505 + f13_x_p528;

  // link 3 (hip), articulated inertia
  const Real f13_x_p530 = f13_x_p529 * inverse_D3;
  const Real f13_x_p531 = f13_x_p508 + f13_x_p512 - f13_x_p524 * f13_x_p525 - f13_x_p529 *
      f13_x_p530;
  const Real f13_x_p532 = f13_x_p519 * f13_x_p530 -
      (c4 * (f13_x_p497 * f13_x_p525 - f13_x_p527) - s4 * (f13_x_p506 * f13_x_p525 - f13_x_p526));
  const Real f13_x_p533 = s3 * (f13_x_p523 - f13_x_p531) + c3 * (2.0 * f13_x_p532);
  const Real f13_x_p534 = s3 * f13_x_p533;
  const Real f13_x_p535 = f13_x_p523 - f13_x_p534;
  const Real f13_x_p536 = 24.5839218 + 0.422 * f13_x_p535;

  // link 2 (thigh), articulated inertia
  const Real inverse_D2 = 1.0 / (9.885744550888212 + 0.178084 * f13_x_p535);
  const Real f13_x_p537 = f13_x_p536 * inverse_D2;

  // link 20 (right_hand), force propagation
  const Real f13_x_p538 = 0.11533812622014242 * s20 + 0.04672761636452121 * c20;

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p539 = 0.11533812622014242 * c20 - 0.04672761636452121 * s20 - f13_x_p186 *
      f13_x_p538;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p540 = -(c19 * f13_x_p539);

  // link 19 (right_wrist2), force propagation
  const Real neg_s20 = -s20;
  const Real f13_x_p541 = neg_s20 - f13_x_p186 * c20;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p542 = -(c19 * f13_x_p541);

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p543 = c20 - f13_x_p186 * s20;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p544 = -(c19 * f13_x_p543);
  const Lanes f13_x_p545_lanes = inverse_D17_p1 * detail::make_lanes<Real>(f13_x_p544, f13_x_p544,
      f13_x_p542, f13_x_p540, f13_x_p544, f13_x_p544, f13_x_p544, f13_x_p544);

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p548 = 3.0523172236718206 * s20 - 17.32841575379867 * c20 - f13_x_p192 *
      f13_x_p538;
  const Real f13_x_p549 = f13_x_p192 * c20;
  const Real f13_x_p550 = f13_x_p192 * s20;

  // link 18 (right_wrist1), force propagation
  const Lanes f13_x_p551_lanes = detail::make_lanes<Real>(-(s19 * f13_x_p543 + 0.269 * f13_x_p550),
      -(s19 * f13_x_p543 + 0.269 * f13_x_p550), -(s19 * f13_x_p541 + 0.269 * f13_x_p549), 0.269 *
      f13_x_p548 - s19 * f13_x_p539, -(s19 * f13_x_p543 + 0.269 * f13_x_p550),
      -(s19 * f13_x_p543 + 0.269 * f13_x_p550), -(s19 * f13_x_p543 + 0.269 * f13_x_p550),
      -(s19 * f13_x_p543 + 0.269 * f13_x_p550)) - f13_x_p545_lanes;
  const Lanes f13_x_p554_lanes = s18 * f13_x_p551_lanes;
  const Lanes f13_x_p557_lanes = inverse_D17_p3 * detail::make_lanes<Real>(f13_x_p544, f13_x_p544,
      f13_x_p542, f13_x_p540, f13_x_p544, f13_x_p544, f13_x_p544, f13_x_p544);

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p560 = f13_x_p209 * f13_x_p538;
  const Real f13_x_p561 = 3.0523172236718206 * c20 + 17.32841575379867 * s20 - f13_x_p206 *
      f13_x_p538;
  const Real f13_x_p562 = c19 * f13_x_p560 + s19 * f13_x_p561;
  const Real f13_x_p563 = f13_x_p209 * c20;
  const Real f13_x_p564 = f13_x_p206 * c20;
  const Real f13_x_p565 = c19 * f13_x_p563 - s19 * f13_x_p564;
  const Real f13_x_p566 = f13_x_p209 * s20;
  const Real f13_x_p567 = f13_x_p206 * s20;
  const Real f13_x_p568 = c19 * f13_x_p566 - s19 * f13_x_p567;
  const Lanes f13_x_p569_lanes = 0.269 * detail::make_lanes<Real>(f13_x_p568, f13_x_p568,
      f13_x_p565, f13_x_p562, f13_x_p568, f13_x_p568, f13_x_p568, f13_x_p568);

  // link 18 (right_wrist1), force propagation
  const Lanes f13_x_p572_lanes = f13_x_p569_lanes - f13_x_p557_lanes;
  const Lanes f13_x_p575_lanes = c18 * f13_x_p572_lanes;
  const Lanes f13_x_p578_lanes = f13_x_p554_lanes + f13_x_p575_lanes;
  const Real f13_x_p581 = -(0.269 * c19);
  const Real f13_x_p582 = c18 * f13_x_p581;

  // link 17 (right_lowerarm), force propagation
  const Lanes f13_x_p583_lanes = f13_x_p243 * detail::make_lanes<Real>(f13_x_p582,
      f13_x_p578_lanes[1], f13_x_p578_lanes[2], f13_x_p578_lanes[3], f13_x_p582, f13_x_p582,
      f13_x_p582, f13_x_p582);

  // link 18 (right_wrist1), force propagation
  const Lanes f13_x_p587_lanes = c18 * f13_x_p551_lanes;
  const Lanes f13_x_p590_lanes = s18 * f13_x_p572_lanes;
  const Lanes f13_x_p593_lanes = f13_x_p587_lanes - f13_x_p590_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes f13_x_p596_lanes = detail::make_lanes<Real>(-(s18 * f13_x_p581), f13_x_p593_lanes[1],
      f13_x_p593_lanes[2], f13_x_p593_lanes[3], -(s18 * f13_x_p581), -(s18 * f13_x_p581),
      -(s18 * f13_x_p581), -(s18 * f13_x_p581)) - f13_x_p583_lanes;
  const Lanes f13_x_p600_lanes = s17 * f13_x_p596_lanes;
  const Lanes f13_x_p604_lanes = f13_x_p240 * detail::make_lanes<Real>(f13_x_p582,
      f13_x_p578_lanes[1], f13_x_p578_lanes[2], f13_x_p578_lanes[3], f13_x_p582, f13_x_p582,
      f13_x_p582, f13_x_p582);
  const Lanes f13_x_p608_lanes = c17 * f13_x_p604_lanes;
  const Lanes f13_x_p612_lanes = f13_x_p608_lanes - f13_x_p600_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p616_lanes = inverse_D15_p1 * f13_x_p612_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes f13_x_p620_lanes = c17 * f13_x_p596_lanes;
  const Lanes f13_x_p624_lanes = s17 * f13_x_p604_lanes;
  const Lanes f13_x_p628_lanes = f13_x_p620_lanes + f13_x_p624_lanes;
  const Lanes f13_x_p632_lanes = f13_x_p234 * detail::make_lanes<Real>(f13_x_p582,
      f13_x_p578_lanes[1], f13_x_p578_lanes[2], f13_x_p578_lanes[3], f13_x_p582, f13_x_p582,
      f13_x_p582, f13_x_p582);

  // link 18 (right_wrist1), force propagation
  const Lanes f13_x_p636_lanes = f13_x_p214 * detail::make_lanes<Real>(f13_x_p544, f13_x_p544,
      f13_x_p542, f13_x_p540, f13_x_p544, f13_x_p544, f13_x_p544, f13_x_p544);
  const Lanes f13_x_p639_lanes = detail::make_lanes<Real>(-f13_x_p568, -f13_x_p568, -f13_x_p565,
      -f13_x_p562, -f13_x_p568, -f13_x_p568, -f13_x_p568, -f13_x_p568) - f13_x_p636_lanes;
  const Lanes f13_x_p642_lanes = s18 * f13_x_p639_lanes;
  const Lanes f13_x_p645_lanes = f13_x_p198 * detail::make_lanes<Real>(f13_x_p544, f13_x_p544,
      f13_x_p542, f13_x_p540, f13_x_p544, f13_x_p544, f13_x_p544, f13_x_p544);
  const Lanes f13_x_p648_lanes = detail::make_lanes<Real>(-f13_x_p550, -f13_x_p550, -f13_x_p549,
      f13_x_p548, -f13_x_p550, -f13_x_p550, -f13_x_p550, -f13_x_p550) - f13_x_p645_lanes;
  const Lanes f13_x_p651_lanes = c18 * f13_x_p648_lanes;
  const Lanes f13_x_p654_lanes = f13_x_p642_lanes + f13_x_p651_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes f13_x_p657_lanes = detail::make_lanes<Real>(s18 * c19, f13_x_p654_lanes[1],
      f13_x_p654_lanes[2], f13_x_p654_lanes[3], s18 * c19, s18 * c19, s18 * c19, s18 * c19) -
      f13_x_p632_lanes;
  const Lanes f13_x_p661_lanes = 0.282 * f13_x_p657_lanes;
  const Lanes f13_x_p665_lanes = f13_x_p628_lanes + f13_x_p661_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p669_lanes = f13_x_p665_lanes - f13_x_p616_lanes;
  const Lanes f13_x_p673_lanes = c16 * f13_x_p669_lanes;
  const Lanes f13_x_p677_lanes = inverse_D15_p3 * f13_x_p612_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes f13_x_p681_lanes = f13_x_p249 * detail::make_lanes<Real>(f13_x_p582,
      f13_x_p578_lanes[1], f13_x_p578_lanes[2], f13_x_p578_lanes[3], f13_x_p582, f13_x_p582,
      f13_x_p582, f13_x_p582);

  // link 18 (right_wrist1), force propagation
  const Lanes f13_x_p685_lanes = c18 * f13_x_p639_lanes;
  const Lanes f13_x_p688_lanes = s18 * f13_x_p648_lanes;
  const Lanes f13_x_p691_lanes = f13_x_p685_lanes - f13_x_p688_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes f13_x_p694_lanes = detail::make_lanes<Real>(c18 * c19, f13_x_p691_lanes[1],
      f13_x_p691_lanes[2], f13_x_p691_lanes[3], c18 * c19, c18 * c19, c18 * c19, c18 * c19) -
      f13_x_p681_lanes;
  const Lanes f13_x_p698_lanes = c17 * f13_x_p694_lanes;
  const Lanes f13_x_p702_lanes = f13_x_p258 * detail::make_lanes<Real>(f13_x_p582,
      f13_x_p578_lanes[1], f13_x_p578_lanes[2], f13_x_p578_lanes[3], f13_x_p582, f13_x_p582,
      f13_x_p582, f13_x_p582);
  const Lanes f13_x_p706_lanes = detail::make_lanes<Real>(-(-s19),
      -(s19 * f13_x_p566 + c19 * f13_x_p567 - f13_x_p253 * f13_x_p544),
      -(s19 * f13_x_p563 + c19 * f13_x_p564 - f13_x_p253 * f13_x_p542),
      -(s19 * f13_x_p560 - c19 * f13_x_p561 - f13_x_p253 * f13_x_p540), -(-s19), -(-s19), -(-s19),
      -(-s19)) - f13_x_p702_lanes;
  const Lanes f13_x_p710_lanes = s17 * f13_x_p706_lanes;
  const Lanes f13_x_p714_lanes = f13_x_p710_lanes - f13_x_p698_lanes;
  const Lanes f13_x_p718_lanes = 0.282 * f13_x_p714_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p722_lanes = f13_x_p718_lanes - f13_x_p677_lanes;
  const Lanes f13_x_p726_lanes = s16 * f13_x_p722_lanes;
  const Lanes f13_x_p730_lanes = f13_x_p673_lanes - f13_x_p726_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p734_lanes = inverse_D14_p1 * f13_x_p730_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p738_lanes = s16 * f13_x_p669_lanes;
  const Lanes f13_x_p742_lanes = c16 * f13_x_p722_lanes;
  const Lanes f13_x_p746_lanes = f13_x_p738_lanes + f13_x_p742_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p750_lanes = f13_x_p746_lanes - f13_x_p734_lanes;
  const Lanes f13_x_p754_lanes = c15 * f13_x_p750_lanes;

  // link 15 (right_shoulder2), articulated inertia
  const Real f13_x_p758 = 0.00010499999999999999 / inverse_D15_p9;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p759_lanes = f13_x_p758 * f13_x_p730_lanes;
  const Lanes f13_x_p763_lanes = s15 * f13_x_p759_lanes;
  const Lanes f13_x_p767_lanes = f13_x_p763_lanes + f13_x_p754_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p771_lanes = f13_x_p305 * f13_x_p767_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p775_lanes = f13_x_p299 * f13_x_p730_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p779_lanes = f13_x_p266 * f13_x_p612_lanes;
  const Lanes f13_x_p783_lanes = detail::make_lanes<Real>(-f13_x_p714_lanes[0],
      -f13_x_p714_lanes[1], -f13_x_p714_lanes[2], -f13_x_p714_lanes[3], -f13_x_p714_lanes[0],
      -f13_x_p714_lanes[0], -f13_x_p714_lanes[0], -f13_x_p714_lanes[0]) - f13_x_p779_lanes;
  const Lanes f13_x_p787_lanes = c16 * f13_x_p783_lanes;
  const Lanes f13_x_p791_lanes = f13_x_p281 * f13_x_p612_lanes;
  const Lanes f13_x_p795_lanes = f13_x_p657_lanes - f13_x_p791_lanes;
  const Lanes f13_x_p799_lanes = s16 * f13_x_p795_lanes;
  const Lanes f13_x_p803_lanes = f13_x_p787_lanes - f13_x_p799_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p807_lanes = f13_x_p803_lanes - f13_x_p775_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p811_lanes = f13_x_p807_lanes - f13_x_p771_lanes;
  const Lanes f13_x_p815_lanes = s14 * f13_x_p811_lanes;
  const Lanes f13_x_p819_lanes = f13_x_p324 * f13_x_p767_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p823_lanes = f13_x_p308 * f13_x_p730_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p827_lanes = s16 * f13_x_p783_lanes;
  const Lanes f13_x_p831_lanes = c16 * f13_x_p795_lanes;
  const Lanes f13_x_p835_lanes = f13_x_p827_lanes + f13_x_p831_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p839_lanes = f13_x_p835_lanes - f13_x_p823_lanes;
  const Lanes f13_x_p843_lanes = s15 * f13_x_p839_lanes;
  const Lanes f13_x_p847_lanes = f13_x_p317 * f13_x_p730_lanes;
  const Lanes f13_x_p851_lanes = detail::make_lanes<Real>(-(-(s17 * f13_x_p694_lanes[0] + c17 *
      f13_x_p706_lanes[0]) + f13_x_p311 * f13_x_p612_lanes[0]),
      -(-(s17 * f13_x_p694_lanes[1] + c17 * f13_x_p706_lanes[1]) + f13_x_p311 *
      f13_x_p612_lanes[1]), -(-(s17 * f13_x_p694_lanes[2] + c17 * f13_x_p706_lanes[2]) +
      f13_x_p311 * f13_x_p612_lanes[2]), -(-(s17 * f13_x_p694_lanes[3] + c17 *
      f13_x_p706_lanes[3]) + f13_x_p311 * f13_x_p612_lanes[3]),
      -(-(s17 * f13_x_p694_lanes[0] + c17 * f13_x_p706_lanes[0]) + f13_x_p311 *
      f13_x_p612_lanes[0]), -(-(s17 * f13_x_p694_lanes[0] + c17 * f13_x_p706_lanes[0]) +
      f13_x_p311 * f13_x_p612_lanes[0]), -(-(s17 * f13_x_p694_lanes[0] + c17 *
      f13_x_p706_lanes[0]) + f13_x_p311 * f13_x_p612_lanes[0]),
      -(-(s17 * f13_x_p694_lanes[0] + c17 * f13_x_p706_lanes[0]) + f13_x_p311 *
      f13_x_p612_lanes[0])) - f13_x_p847_lanes;
  const Lanes f13_x_p855_lanes = c15 * f13_x_p851_lanes;
  const Lanes f13_x_p859_lanes = f13_x_p855_lanes - f13_x_p843_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p863_lanes = f13_x_p859_lanes - f13_x_p819_lanes;
  const Lanes f13_x_p867_lanes = c14 * f13_x_p863_lanes;
  const Lanes f13_x_p871_lanes = f13_x_p815_lanes + f13_x_p867_lanes;
  const Lanes f13_x_p875_lanes = 0.18 * f13_x_p871_lanes;
  const Lanes f13_x_p879_lanes = f13_x_p334 * f13_x_p767_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p883_lanes = c15 * f13_x_p839_lanes;
  const Lanes f13_x_p887_lanes = s15 * f13_x_p851_lanes;
  const Lanes f13_x_p891_lanes = f13_x_p887_lanes + f13_x_p883_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p895_lanes = f13_x_p891_lanes - f13_x_p879_lanes;
  const Lanes f13_x_p899_lanes = 0.226 * f13_x_p895_lanes;
  const Lanes f13_x_p903_lanes = f13_x_p875_lanes - f13_x_p899_lanes;
  const Lanes f13_x_p907_lanes = inverse_D6_p1 * f13_x_p767_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p911_lanes = s15 * f13_x_p750_lanes;
  const Lanes f13_x_p915_lanes = c15 * f13_x_p759_lanes;
  const Lanes f13_x_p919_lanes = f13_x_p915_lanes - f13_x_p911_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p923_lanes = f13_x_p919_lanes - f13_x_p907_lanes;
  const Lanes f13_x_p927_lanes = s14 * f13_x_p923_lanes;

  // link 14 (right_shoulder1), articulated inertia
  const Real f13_x_p931 = 2.6249999999999998e-05 / inverse_D14_p8;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p932_lanes = f13_x_p931 * f13_x_p767_lanes;
  const Lanes f13_x_p936_lanes = c14 * f13_x_p932_lanes;
  const Lanes f13_x_p940_lanes = f13_x_p936_lanes + f13_x_p927_lanes;
  const Lanes f13_x_p944_lanes = f13_x_p903_lanes - f13_x_p940_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p948_lanes = inverse_D5_p14 * f13_x_p944_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p952_lanes = c14 * f13_x_p811_lanes;
  const Lanes f13_x_p956_lanes = s14 * f13_x_p863_lanes;
  const Lanes f13_x_p960_lanes = f13_x_p952_lanes - f13_x_p956_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p964_lanes = detail::make_lanes<Real>(-(s14 * f13_x_p932_lanes[0] - c14 *
      f13_x_p923_lanes[0] + 0.18 * f13_x_p960_lanes[0]),
      -(s14 * f13_x_p932_lanes[1] - c14 * f13_x_p923_lanes[1] + 0.18 * f13_x_p960_lanes[1]),
      -(s14 * f13_x_p932_lanes[2] - c14 * f13_x_p923_lanes[2] + 0.18 * f13_x_p960_lanes[2]),
      -(s14 * f13_x_p932_lanes[3] - c14 * f13_x_p923_lanes[3] + 0.18 * f13_x_p960_lanes[3]),
      -(s14 * f13_x_p932_lanes[0] - c14 * f13_x_p923_lanes[0] + 0.18 * f13_x_p960_lanes[0]),
      -(s14 * f13_x_p932_lanes[0] - c14 * f13_x_p923_lanes[0] + 0.18 * f13_x_p960_lanes[0]),
      -(s14 * f13_x_p932_lanes[0] - c14 * f13_x_p923_lanes[0] + 0.18 * f13_x_p960_lanes[0]),
      -(s14 * f13_x_p932_lanes[0] - c14 * f13_x_p923_lanes[0] + 0.18 * f13_x_p960_lanes[0])) -
      f13_x_p948_lanes;
  const Lanes f13_x_p968_lanes = s6 * f13_x_p964_lanes;
  const Lanes f13_x_p972_lanes = inverse_D5_p16 * f13_x_p944_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p976_lanes = 0.226 * f13_x_p960_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p980_lanes = f13_x_p976_lanes - f13_x_p972_lanes;
  const Lanes f13_x_p984_lanes = c6 * f13_x_p980_lanes;
  const Lanes f13_x_p988_lanes = f13_x_p968_lanes + f13_x_p984_lanes;
  const Lanes f13_x_p992_lanes = f13_x_p450 * f13_x_p944_lanes;
  const Lanes f13_x_p996_lanes = f13_x_p960_lanes - f13_x_p992_lanes;
  const Lanes f13_x_p1000_lanes = 0.072 * f13_x_p996_lanes;
  const Lanes f13_x_p1004_lanes = f13_x_p988_lanes + f13_x_p1000_lanes;
  const Lanes f13_x_p1008_lanes = f13_x_p410 * f13_x_p944_lanes;
  const Lanes f13_x_p1012_lanes = f13_x_p871_lanes - f13_x_p1008_lanes;
  const Lanes f13_x_p1016_lanes = s6 * f13_x_p1012_lanes;
  const Lanes f13_x_p1020_lanes = f13_x_p441 * f13_x_p944_lanes;
  const Lanes f13_x_p1024_lanes = f13_x_p895_lanes - f13_x_p1020_lanes;
  const Lanes f13_x_p1028_lanes = c6 * f13_x_p1024_lanes;
  const Lanes f13_x_p1032_lanes = f13_x_p1016_lanes + f13_x_p1028_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p1036 = -(0.072 * f13_x_p1032_lanes[3]) + f13_x_p477 * f13_x_p1004_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p1037_lanes = c6 * f13_x_p964_lanes;
  const Lanes f13_x_p1041_lanes = s6 * f13_x_p980_lanes;
  const Lanes f13_x_p1045_lanes = f13_x_p1037_lanes - f13_x_p1041_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p1049 = f13_x_p1045_lanes[3] - f13_x_p479 * f13_x_p1004_lanes[3];

  // link 4 (chest1), force propagation
  const Real f13_x_p1050 = -(s5 * f13_x_p1036 + c5 * f13_x_p1049);

  // link 5 (chest2), force propagation
  const Real f13_x_p1051 = -(0.072 * f13_x_p1032_lanes[2]) + f13_x_p477 * f13_x_p1004_lanes[2];
  const Real f13_x_p1052 = f13_x_p1045_lanes[2] - f13_x_p479 * f13_x_p1004_lanes[2];

  // link 4 (chest1), force propagation
  const Real f13_x_p1053 = -(s5 * f13_x_p1051 + c5 * f13_x_p1052);

  // link 5 (chest2), force propagation
  const Real f13_x_p1054 = -(0.072 * f13_x_p1032_lanes[1]) + f13_x_p477 * f13_x_p1004_lanes[1];
  const Real f13_x_p1055 = f13_x_p1045_lanes[1] - f13_x_p479 * f13_x_p1004_lanes[1];

  // link 4 (chest1), force propagation
  const Real f13_x_p1056 = -(s5 * f13_x_p1054 + c5 * f13_x_p1055);

  // link 5 (chest2), force propagation
  const Real f13_x_p1057 = -(0.072 * f13_x_p1032_lanes[0]) + f13_x_p477 * f13_x_p1004_lanes[0];
  const Real f13_x_p1058 = f13_x_p1045_lanes[0] - f13_x_p479 * f13_x_p1004_lanes[0];

  // link 4 (chest1), force propagation
  const Real f13_x_p1059 = -(s5 * f13_x_p1057 + c5 * f13_x_p1058);
  const Lanes f13_x_p1060_lanes = inverse_D3_p1 * detail::make_lanes<Real>(f13_x_p1059, f13_x_p1056,
      f13_x_p1053, f13_x_p1050, f13_x_p1059, f13_x_p1059, f13_x_p1059, f13_x_p1059);

  // link 5 (chest2), force propagation
  const Lanes f13_x_p1064_lanes = f13_x_p462 * f13_x_p1004_lanes;
  const Lanes f13_x_p1068_lanes = f13_x_p1032_lanes - f13_x_p1064_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p1072_lanes = detail::make_lanes<Real>(-(s5 * f13_x_p1058 - c5 * f13_x_p1057 +
      0.21799999999999997 * f13_x_p1068_lanes[0]), -(s5 * f13_x_p1055 - c5 * f13_x_p1054 +
      0.21799999999999997 * f13_x_p1068_lanes[1]), -(s5 * f13_x_p1052 - c5 * f13_x_p1051 +
      0.21799999999999997 * f13_x_p1068_lanes[2]), -(s5 * f13_x_p1049 - c5 * f13_x_p1036 +
      0.21799999999999997 * f13_x_p1068_lanes[3]), -(s5 * f13_x_p1058 - c5 * f13_x_p1057 +
      0.21799999999999997 * f13_x_p1068_lanes[0]), -(s5 * f13_x_p1058 - c5 * f13_x_p1057 +
      0.21799999999999997 * f13_x_p1068_lanes[0]), -(s5 * f13_x_p1058 - c5 * f13_x_p1057 +
      0.21799999999999997 * f13_x_p1068_lanes[0]), -(s5 * f13_x_p1058 - c5 * f13_x_p1057 +
      0.21799999999999997 * f13_x_p1068_lanes[0])) - f13_x_p1060_lanes;
  const Lanes f13_x_p1076_lanes = s4 * f13_x_p1072_lanes;
  const Lanes f13_x_p1080_lanes = inverse_D3_p2 * detail::make_lanes<Real>(f13_x_p1059, f13_x_p1056,
      f13_x_p1053, f13_x_p1050, f13_x_p1059, f13_x_p1059, f13_x_p1059, f13_x_p1059);

  // link 6 (chest3), force propagation
  const Lanes f13_x_p1084_lanes = c6 * f13_x_p1012_lanes;
  const Lanes f13_x_p1088_lanes = s6 * f13_x_p1024_lanes;
  const Lanes f13_x_p1092_lanes = f13_x_p1084_lanes - f13_x_p1088_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p1096 = f13_x_p1092_lanes[3] - f13_x_p490 * f13_x_p1004_lanes[3];
  const Real f13_x_p1097 = f13_x_p996_lanes[3] - f13_x_p486 * f13_x_p1004_lanes[3];
  const Real f13_x_p1098 = s5 * f13_x_p1096 - c5 * f13_x_p1097;
  const Real f13_x_p1099 = f13_x_p1092_lanes[2] - f13_x_p490 * f13_x_p1004_lanes[2];
  const Real f13_x_p1100 = f13_x_p996_lanes[2] - f13_x_p486 * f13_x_p1004_lanes[2];
  const Real f13_x_p1101 = s5 * f13_x_p1099 - c5 * f13_x_p1100;
  const Real f13_x_p1102 = f13_x_p1092_lanes[1] - f13_x_p490 * f13_x_p1004_lanes[1];
  const Real f13_x_p1103 = f13_x_p996_lanes[1] - f13_x_p486 * f13_x_p1004_lanes[1];
  const Real f13_x_p1104 = s5 * f13_x_p1102 - c5 * f13_x_p1103;
  const Real f13_x_p1105 = f13_x_p1092_lanes[0] - f13_x_p490 * f13_x_p1004_lanes[0];
  const Real f13_x_p1106 = f13_x_p996_lanes[0] - f13_x_p486 * f13_x_p1004_lanes[0];
  const Real f13_x_p1107 = s5 * f13_x_p1105 - c5 * f13_x_p1106;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p1108_lanes = detail::make_lanes<Real>(-(0.21799999999999997 * f13_x_p1107),
      -(0.21799999999999997 * f13_x_p1104), -(0.21799999999999997 * f13_x_p1101),
      -(0.21799999999999997 * f13_x_p1098), -(0.21799999999999997 * f13_x_p1107),
      -(0.21799999999999997 * f13_x_p1107), -(0.21799999999999997 * f13_x_p1107),
      -(0.21799999999999997 * f13_x_p1107)) + f13_x_p1080_lanes;
  const Lanes f13_x_p1112_lanes = c4 * f13_x_p1108_lanes;
  const Lanes f13_x_p1116_lanes = f13_x_p1076_lanes + f13_x_p1112_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p1120_lanes = f13_x_p520 * f13_x_p1116_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p1124_lanes = f13_x_p498 * detail::make_lanes<Real>(f13_x_p1059, f13_x_p1056,
      f13_x_p1053, f13_x_p1050, f13_x_p1059, f13_x_p1059, f13_x_p1059, f13_x_p1059);
  const Lanes f13_x_p1128_lanes = detail::make_lanes<Real>(-f13_x_p1107, -f13_x_p1104, -f13_x_p1101,
      -f13_x_p1098, -f13_x_p1107, -f13_x_p1107, -f13_x_p1107, -f13_x_p1107) + f13_x_p1124_lanes;
  const Lanes f13_x_p1132_lanes = c4 * f13_x_p1128_lanes;
  const Lanes f13_x_p1136_lanes = f13_x_p507 * detail::make_lanes<Real>(f13_x_p1059, f13_x_p1056,
      f13_x_p1053, f13_x_p1050, f13_x_p1059, f13_x_p1059, f13_x_p1059, f13_x_p1059);
  const Lanes f13_x_p1140_lanes = f13_x_p1068_lanes + f13_x_p1136_lanes;
  const Lanes f13_x_p1144_lanes = s4 * f13_x_p1140_lanes;
  const Lanes f13_x_p1148_lanes = f13_x_p1132_lanes - f13_x_p1144_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p1152_lanes = f13_x_p1148_lanes - f13_x_p1120_lanes;
  const Lanes f13_x_p1156_lanes = c3 * f13_x_p1152_lanes;
  const Lanes f13_x_p1160_lanes = f13_x_p530 * f13_x_p1116_lanes;
  const Lanes f13_x_p1164_lanes = detail::make_lanes<Real>(-(-(s5 * f13_x_p1106 + c5 *
      f13_x_p1105) - f13_x_p525 * f13_x_p1059), -(-(s5 * f13_x_p1103 + c5 * f13_x_p1102) -
      f13_x_p525 * f13_x_p1056), -(-(s5 * f13_x_p1100 + c5 * f13_x_p1099) - f13_x_p525 *
      f13_x_p1053), -(-(s5 * f13_x_p1097 + c5 * f13_x_p1096) - f13_x_p525 * f13_x_p1050),
      -(-(s5 * f13_x_p1106 + c5 * f13_x_p1105) - f13_x_p525 * f13_x_p1059),
      -(-(s5 * f13_x_p1106 + c5 * f13_x_p1105) - f13_x_p525 * f13_x_p1059),
      -(-(s5 * f13_x_p1106 + c5 * f13_x_p1105) - f13_x_p525 * f13_x_p1059),
      -(-(s5 * f13_x_p1106 + c5 * f13_x_p1105) - f13_x_p525 * f13_x_p1059)) + f13_x_p1160_lanes;
  const Lanes f13_x_p1168_lanes = s3 * f13_x_p1164_lanes;
  const Lanes f13_x_p1172_lanes = f13_x_p1156_lanes - f13_x_p1168_lanes;
  const Lanes f13_x_p1176_lanes = 0.422 * f13_x_p1172_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p1180_lanes = f13_x_p537 * f13_x_p1176_lanes;
  const Lanes f13_x_p1184_lanes = f13_x_p1172_lanes - f13_x_p1180_lanes;
  const Lanes f13_x_p1188_lanes = c2 * f13_x_p1184_lanes;

  // link 3 (hip), articulated inertia
  const Real f13_x_p1192 = c3 * f13_x_p533 - f13_x_p532;
  const Real f13_x_p1193 = 0.031999971599999996 + 0.422 * f13_x_p1192;

  // link 2 (thigh), articulated inertia
  const Real f13_x_p1194 = f13_x_p1193 * inverse_D2;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p1195_lanes = f13_x_p1194 * f13_x_p1176_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p1199_lanes = s3 * f13_x_p1152_lanes;
  const Lanes f13_x_p1203_lanes = c3 * f13_x_p1164_lanes;
  const Lanes f13_x_p1207_lanes = f13_x_p1199_lanes + f13_x_p1203_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p1211_lanes = f13_x_p1207_lanes - f13_x_p1195_lanes;
  const Lanes f13_x_p1215_lanes = s2 * f13_x_p1211_lanes;
  const Lanes f13_x_p1219_lanes = f13_x_p1188_lanes - f13_x_p1215_lanes;
  const Lanes f13_x_p1223_lanes = 0.434 * f13_x_p1219_lanes;

  // link 2 (thigh), articulated inertia
  const Real inverse_D1_p1 = f13_x_p535 - f13_x_p536 * f13_x_p537;
  const Real inverse_D1_p2 = s2 * (inverse_D1_p1 - (f13_x_p531 + f13_x_p534 - f13_x_p1193 *
      f13_x_p1194)) + c2 * (2.0 * (f13_x_p1192 - f13_x_p536 * f13_x_p1194));

  // link 1 (calf), articulated inertia
  const Real inverse_D1 = 1.0 / (13.049859506913753 + 0.188356 *
      (inverse_D1_p1 - s2 * inverse_D1_p2));

  // link 1 (calf), force propagation
  const Lanes f13_x_p1227_lanes = f13_x_p1223_lanes * inverse_D1;

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p1231 = 0.269 * c20;
  const Real f13_x_p1232 = s19 * neg_s20;
  const Real f13_x_p1233 = 0.269 * f13_x_p1232;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1234 = s18 * f13_x_p1231 + c18 * f13_x_p1233;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1235 = c18 * f13_x_p1231 - s18 * f13_x_p1233 - f13_x_p243 * f13_x_p1234;
  const Real f13_x_p1236 = f13_x_p240 * f13_x_p1234;
  const Real f13_x_p1237 = c17 * f13_x_p1236 - s17 * f13_x_p1235;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1238 = -f13_x_p1232;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1239 = s18 * f13_x_p1238 + c18 * c20 - f13_x_p234 * f13_x_p1234;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1240 = c17 * f13_x_p1235 + s17 * f13_x_p1236 + 0.282 * f13_x_p1239 -
      inverse_D15_p1 * f13_x_p1237;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1241 = c18 * f13_x_p1238 - s18 * c20 - f13_x_p249 * f13_x_p1234;
  const Real f13_x_p1242 = -(-(c19 * neg_s20)) - f13_x_p258 * f13_x_p1234;
  const Real f13_x_p1243 = s17 * f13_x_p1242 - c17 * f13_x_p1241;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1244 = 0.282 * f13_x_p1243 - inverse_D15_p3 * f13_x_p1237;
  const Real f13_x_p1245 = c16 * f13_x_p1240 - s16 * f13_x_p1244;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1246 = s16 * f13_x_p1240 + c16 * f13_x_p1244 - inverse_D14_p1 * f13_x_p1245;
  const Real f13_x_p1247 = f13_x_p758 * f13_x_p1245;
  const Real f13_x_p1248 = s15 * f13_x_p1247 + c15 * f13_x_p1246;

  // link 19 (right_wrist2), force propagation
  const Real f13_x_p1249 = 0.269 * s20;
  const Real f13_x_p1250 = s19 * c20;
  const Real f13_x_p1251 = 0.269 * f13_x_p1250;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1252 = s18 * f13_x_p1249 + c18 * f13_x_p1251;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1253 = c18 * f13_x_p1249 - s18 * f13_x_p1251 - f13_x_p243 * f13_x_p1252;
  const Real f13_x_p1254 = f13_x_p240 * f13_x_p1252;
  const Real f13_x_p1255 = c17 * f13_x_p1254 - s17 * f13_x_p1253;

  // link 18 (right_wrist1), force propagation
  const Real f13_x_p1256 = -f13_x_p1250;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1257 = s18 * f13_x_p1256 + c18 * s20 - f13_x_p234 * f13_x_p1252;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1258 = c17 * f13_x_p1253 + s17 * f13_x_p1254 + 0.282 * f13_x_p1257 -
      inverse_D15_p1 * f13_x_p1255;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p1259 = c18 * f13_x_p1256 - s18 * s20 - f13_x_p249 * f13_x_p1252;
  const Real f13_x_p1260 = -(-(c19 * c20)) - f13_x_p258 * f13_x_p1252;
  const Real f13_x_p1261 = s17 * f13_x_p1260 - c17 * f13_x_p1259;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1262 = 0.282 * f13_x_p1261 - inverse_D15_p3 * f13_x_p1255;
  const Real f13_x_p1263 = c16 * f13_x_p1258 - s16 * f13_x_p1262;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1264 = s16 * f13_x_p1258 + c16 * f13_x_p1262 - inverse_D14_p1 * f13_x_p1263;
  const Real f13_x_p1265 = f13_x_p758 * f13_x_p1263;
  const Real f13_x_p1266 = s15 * f13_x_p1265 + c15 * f13_x_p1264;

  // link 13 (left_hand), force propagation
  const Real f13_x_p1267 = 0.11533812622014242 * s13 - 0.04672761636452121 * c13;

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1268 = 0.11533812622014242 * c13 + 0.04672761636452121 * s13 - f13_x_p3 *
      f13_x_p1267;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1269 = -(c12 * f13_x_p1268);

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1270 = -(3.0523172236718206 * s13 + 17.32841575379867 * c13) - f13_x_p9 *
      f13_x_p1267;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1271 = 0.269 * f13_x_p1270 - s12 * f13_x_p1268 - f13_x_p14 * f13_x_p1269;

  // link 12 (left_wrist2), force propagation
  const Real neg_s13 = -s13;
  const Real f13_x_p1272 = neg_s13 - f13_x_p3 * c13;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1273 = -(c12 * f13_x_p1272);

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1274 = f13_x_p9 * c13;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1275 = -(s12 * f13_x_p1272 + 0.269 * f13_x_p1274) - f13_x_p14 * f13_x_p1273;

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1276 = c13 - f13_x_p3 * s13;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1277 = -(c12 * f13_x_p1276);

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1278 = f13_x_p9 * s13;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1279 = -(s12 * f13_x_p1276 + 0.269 * f13_x_p1278) - f13_x_p14 * f13_x_p1277;

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1280 = 0.269 * c13;
  const Real f13_x_p1281 = 0.269 * s13;

  // link 11 (left_wrist1), force propagation
  const Lanes f13_x_p1282_lanes = s11 * detail::make_lanes<Real>(f13_x_p1281, f13_x_p1280,
      f13_x_p1281, f13_x_p1279, f13_x_p1275, f13_x_p1271, f13_x_p1281, f13_x_p1281);

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1287 = 17.32841575379867 * s13 - 3.0523172236718206 * c13 - f13_x_p22 *
      f13_x_p1267;
  const Real f13_x_p1288 = f13_x_p25 * f13_x_p1267;
  const Real f13_x_p1289 = s12 * f13_x_p1287 - c12 * f13_x_p1288;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1290 = 0.269 * f13_x_p1289 - f13_x_p30 * f13_x_p1269;

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1291 = f13_x_p25 * c13;
  const Real f13_x_p1292 = f13_x_p22 * c13;
  const Real f13_x_p1293 = c12 * f13_x_p1291 + s12 * f13_x_p1292;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1294 = -(0.269 * f13_x_p1293) - f13_x_p30 * f13_x_p1273;

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1295 = f13_x_p25 * s13;
  const Real f13_x_p1296 = f13_x_p22 * s13;
  const Real f13_x_p1297 = c12 * f13_x_p1295 + s12 * f13_x_p1296;

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1298 = -(0.269 * f13_x_p1297) - f13_x_p30 * f13_x_p1277;

  // link 12 (left_wrist2), force propagation
  const Real f13_x_p1299 = s12 * neg_s13;
  const Real f13_x_p1300 = 0.269 * f13_x_p1299;
  const Real f13_x_p1301 = s12 * c13;
  const Real f13_x_p1302 = 0.269 * f13_x_p1301;

  // link 11 (left_wrist1), force propagation
  const Lanes f13_x_p1303_lanes = c11 * detail::make_lanes<Real>(f13_x_p1302, f13_x_p1300,
      f13_x_p1302, f13_x_p1298, f13_x_p1294, f13_x_p1290, f13_x_p1302, f13_x_p1302);
  const Lanes f13_x_p1308_lanes = f13_x_p1282_lanes + f13_x_p1303_lanes;
  const Real f13_x_p1313 = -(0.269 * c12);
  const Real f13_x_p1314 = c11 * f13_x_p1313;

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p1315_lanes = f13_x_p48 * detail::make_lanes<Real>(f13_x_p1308_lanes[0],
      f13_x_p1308_lanes[1], f13_x_p1314, f13_x_p1308_lanes[3], f13_x_p1308_lanes[4],
      f13_x_p1308_lanes[5], f13_x_p1308_lanes[0], f13_x_p1308_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Lanes f13_x_p1321_lanes = c11 * detail::make_lanes<Real>(f13_x_p1281, f13_x_p1280,
      f13_x_p1281, f13_x_p1279, f13_x_p1275, f13_x_p1271, f13_x_p1281, f13_x_p1281);
  const Lanes f13_x_p1326_lanes = s11 * detail::make_lanes<Real>(f13_x_p1302, f13_x_p1300,
      f13_x_p1302, f13_x_p1298, f13_x_p1294, f13_x_p1290, f13_x_p1302, f13_x_p1302);
  const Lanes f13_x_p1331_lanes = f13_x_p1321_lanes - f13_x_p1326_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p1336_lanes = detail::make_lanes<Real>(f13_x_p1331_lanes[0],
      f13_x_p1331_lanes[1], -(s11 * f13_x_p1313), f13_x_p1331_lanes[3], f13_x_p1331_lanes[4],
      f13_x_p1331_lanes[5], f13_x_p1331_lanes[0], f13_x_p1331_lanes[0]) - f13_x_p1315_lanes;
  const Lanes f13_x_p1342_lanes = f13_x_p51 * detail::make_lanes<Real>(f13_x_p1308_lanes[0],
      f13_x_p1308_lanes[1], f13_x_p1314, f13_x_p1308_lanes[3], f13_x_p1308_lanes[4],
      f13_x_p1308_lanes[5], f13_x_p1308_lanes[0], f13_x_p1308_lanes[0]);

  // link 9 (left_upperarm), force propagation
  const Real f13_x_p1348 = -(s10 * f13_x_p1336_lanes[5] + c10 * f13_x_p1342_lanes[5]);
  const Real f13_x_p1349 = -(s10 * f13_x_p1336_lanes[4] + c10 * f13_x_p1342_lanes[4]);
  const Real f13_x_p1350 = -(s10 * f13_x_p1336_lanes[3] + c10 * f13_x_p1342_lanes[3]);
  const Real f13_x_p1351 = -(s10 * f13_x_p1336_lanes[2] + c10 * f13_x_p1342_lanes[2]);
  const Real f13_x_p1352 = -(s10 * f13_x_p1336_lanes[1] + c10 * f13_x_p1342_lanes[1]);
  const Real f13_x_p1353 = -(s10 * f13_x_p1336_lanes[0] + c10 * f13_x_p1342_lanes[0]);
  const Lanes f13_x_p1354_lanes = inverse_D8_p1 * detail::make_lanes<Real>(f13_x_p1353, f13_x_p1352,
      f13_x_p1351, f13_x_p1350, f13_x_p1349, f13_x_p1348, f13_x_p1353, f13_x_p1353);

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p1360_lanes = f13_x_p66 * detail::make_lanes<Real>(f13_x_p1308_lanes[0],
      f13_x_p1308_lanes[1], f13_x_p1314, f13_x_p1308_lanes[3], f13_x_p1308_lanes[4],
      f13_x_p1308_lanes[5], f13_x_p1308_lanes[0], f13_x_p1308_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Real f13_x_p1366 = -f13_x_p1289 - f13_x_p56 * f13_x_p1269;
  const Real f13_x_p1367 = f13_x_p1293 - f13_x_p56 * f13_x_p1273;
  const Real f13_x_p1368 = f13_x_p1297 - f13_x_p56 * f13_x_p1277;
  const Real f13_x_p1369 = -f13_x_p1299;
  const Real f13_x_p1370 = -f13_x_p1301;
  const Lanes f13_x_p1371_lanes = s11 * detail::make_lanes<Real>(f13_x_p1370, f13_x_p1369,
      f13_x_p1370, f13_x_p1368, f13_x_p1367, f13_x_p1366, f13_x_p1370, f13_x_p1370);
  const Real f13_x_p1376 = f13_x_p1270 - f13_x_p59 * f13_x_p1269;
  const Real f13_x_p1377 = -f13_x_p1274 - f13_x_p59 * f13_x_p1273;
  const Real f13_x_p1378 = -f13_x_p1278 - f13_x_p59 * f13_x_p1277;
  const Lanes f13_x_p1379_lanes = c11 * detail::make_lanes<Real>(s13, c13, s13, f13_x_p1378,
      f13_x_p1377, f13_x_p1376, s13, s13);
  const Lanes f13_x_p1384_lanes = f13_x_p1371_lanes + f13_x_p1379_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p1389_lanes = detail::make_lanes<Real>(f13_x_p1384_lanes[0],
      f13_x_p1384_lanes[1], s11 * c12, f13_x_p1384_lanes[3], f13_x_p1384_lanes[4],
      f13_x_p1384_lanes[5], f13_x_p1384_lanes[0], f13_x_p1384_lanes[0]) - f13_x_p1360_lanes;
  const Lanes f13_x_p1395_lanes = 0.282 * f13_x_p1389_lanes;
  const Lanes f13_x_p1401_lanes = c10 * f13_x_p1336_lanes;
  const Lanes f13_x_p1407_lanes = s10 * f13_x_p1342_lanes;
  const Lanes f13_x_p1413_lanes = f13_x_p1407_lanes - f13_x_p1401_lanes;
  const Lanes f13_x_p1419_lanes = f13_x_p1395_lanes - f13_x_p1413_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p1425_lanes = f13_x_p1419_lanes + f13_x_p1354_lanes;
  const Lanes f13_x_p1431_lanes = c9 * f13_x_p1425_lanes;
  const Lanes f13_x_p1437_lanes = inverse_D8_p3 * detail::make_lanes<Real>(f13_x_p1353, f13_x_p1352,
      f13_x_p1351, f13_x_p1350, f13_x_p1349, f13_x_p1348, f13_x_p1353, f13_x_p1353);

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p1443_lanes = f13_x_p73 * detail::make_lanes<Real>(f13_x_p1308_lanes[0],
      f13_x_p1308_lanes[1], f13_x_p1314, f13_x_p1308_lanes[3], f13_x_p1308_lanes[4],
      f13_x_p1308_lanes[5], f13_x_p1308_lanes[0], f13_x_p1308_lanes[0]);

  // link 11 (left_wrist1), force propagation
  const Lanes f13_x_p1449_lanes = c11 * detail::make_lanes<Real>(f13_x_p1370, f13_x_p1369,
      f13_x_p1370, f13_x_p1368, f13_x_p1367, f13_x_p1366, f13_x_p1370, f13_x_p1370);
  const Lanes f13_x_p1454_lanes = s11 * detail::make_lanes<Real>(s13, c13, s13, f13_x_p1378,
      f13_x_p1377, f13_x_p1376, s13, s13);
  const Lanes f13_x_p1459_lanes = f13_x_p1449_lanes - f13_x_p1454_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p1464_lanes = detail::make_lanes<Real>(f13_x_p1459_lanes[0],
      f13_x_p1459_lanes[1], c11 * c12, f13_x_p1459_lanes[3], f13_x_p1459_lanes[4],
      f13_x_p1459_lanes[5], f13_x_p1459_lanes[0], f13_x_p1459_lanes[0]) - f13_x_p1443_lanes;
  const Lanes f13_x_p1470_lanes = c10 * f13_x_p1464_lanes;
  const Lanes f13_x_p1476_lanes = f13_x_p82 * detail::make_lanes<Real>(f13_x_p1308_lanes[0],
      f13_x_p1308_lanes[1], f13_x_p1314, f13_x_p1308_lanes[3], f13_x_p1308_lanes[4],
      f13_x_p1308_lanes[5], f13_x_p1308_lanes[0], f13_x_p1308_lanes[0]);
  const Lanes f13_x_p1482_lanes = detail::make_lanes<Real>(-(-(c12 * c13)), -(-(c12 * neg_s13)),
      -(-s12), -(c12 * f13_x_p1296 - s12 * f13_x_p1295 - f13_x_p77 * f13_x_p1277),
      -(c12 * f13_x_p1292 - s12 * f13_x_p1291 - f13_x_p77 * f13_x_p1273),
      -(-(s12 * f13_x_p1288 + c12 * f13_x_p1287) - f13_x_p77 * f13_x_p1269), -(-(c12 * c13)),
      -(-(c12 * c13))) - f13_x_p1476_lanes;
  const Lanes f13_x_p1488_lanes = s10 * f13_x_p1482_lanes;
  const Lanes f13_x_p1494_lanes = f13_x_p1488_lanes - f13_x_p1470_lanes;
  const Lanes f13_x_p1500_lanes = 0.282 * f13_x_p1494_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p1506_lanes = f13_x_p1500_lanes - f13_x_p1437_lanes;
  const Lanes f13_x_p1512_lanes = s9 * f13_x_p1506_lanes;
  const Lanes f13_x_p1518_lanes = f13_x_p1431_lanes - f13_x_p1512_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p1524_lanes = inverse_D7_p1 * f13_x_p1518_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p1530_lanes = s9 * f13_x_p1425_lanes;
  const Lanes f13_x_p1536_lanes = c9 * f13_x_p1506_lanes;
  const Lanes f13_x_p1542_lanes = f13_x_p1530_lanes + f13_x_p1536_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p1548_lanes = f13_x_p1542_lanes - f13_x_p1524_lanes;
  const Lanes f13_x_p1554_lanes = c8 * f13_x_p1548_lanes;

  // link 8 (left_shoulder2), articulated inertia
  const Real f13_x_p1560 = 0.00010499999999999999 / inverse_D8_p9;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p1561_lanes = f13_x_p1560 * f13_x_p1518_lanes;
  const Lanes f13_x_p1567_lanes = s8 * f13_x_p1561_lanes;
  const Lanes f13_x_p1573_lanes = f13_x_p1567_lanes + f13_x_p1554_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p1579_lanes = detail::make_lanes<Real>(f13_x_p129, f13_x_p129, f13_x_p129,
      f13_x_p129, f13_x_p129, f13_x_p129, f13_x_p305, f13_x_p305) *
      detail::make_lanes<Real>(f13_x_p1573_lanes[0], f13_x_p1573_lanes[1], f13_x_p1573_lanes[2],
      f13_x_p1573_lanes[3], f13_x_p1573_lanes[4], f13_x_p1573_lanes[5], f13_x_p1266, f13_x_p1248);

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p1587 = -f13_x_p1243 - f13_x_p266 * f13_x_p1237;
  const Real f13_x_p1588 = f13_x_p1239 - f13_x_p281 * f13_x_p1237;
  const Real f13_x_p1589 = -f13_x_p1261 - f13_x_p266 * f13_x_p1255;
  const Real f13_x_p1590 = f13_x_p1257 - f13_x_p281 * f13_x_p1255;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p1591_lanes = f13_x_p123 * f13_x_p1518_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p1597_lanes = f13_x_p90 * detail::make_lanes<Real>(f13_x_p1353, f13_x_p1352,
      f13_x_p1351, f13_x_p1350, f13_x_p1349, f13_x_p1348, f13_x_p1353, f13_x_p1353);
  const Lanes f13_x_p1603_lanes = detail::make_lanes<Real>(-f13_x_p1494_lanes[0],
      -f13_x_p1494_lanes[1], -f13_x_p1494_lanes[2], -f13_x_p1494_lanes[3], -f13_x_p1494_lanes[4],
      -f13_x_p1494_lanes[5], -f13_x_p1494_lanes[0], -f13_x_p1494_lanes[0]) + f13_x_p1597_lanes;
  const Lanes f13_x_p1609_lanes = c9 * f13_x_p1603_lanes;
  const Lanes f13_x_p1615_lanes = f13_x_p105 * detail::make_lanes<Real>(f13_x_p1353, f13_x_p1352,
      f13_x_p1351, f13_x_p1350, f13_x_p1349, f13_x_p1348, f13_x_p1353, f13_x_p1353);
  const Lanes f13_x_p1621_lanes = f13_x_p1389_lanes + f13_x_p1615_lanes;
  const Lanes f13_x_p1627_lanes = s9 * f13_x_p1621_lanes;
  const Lanes f13_x_p1633_lanes = f13_x_p1609_lanes - f13_x_p1627_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p1639_lanes = f13_x_p1633_lanes - f13_x_p1591_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p1645_lanes = detail::make_lanes<Real>(f13_x_p1639_lanes[0],
      f13_x_p1639_lanes[1], f13_x_p1639_lanes[2], f13_x_p1639_lanes[3], f13_x_p1639_lanes[4],
      f13_x_p1639_lanes[5], c16 * f13_x_p1589 - s16 * f13_x_p1590 - f13_x_p299 * f13_x_p1263, c16 *
      f13_x_p1587 - s16 * f13_x_p1588 - f13_x_p299 * f13_x_p1245) - f13_x_p1579_lanes;
  const Lanes f13_x_p1653_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p1645_lanes;
  const Lanes f13_x_p1661_lanes = detail::make_lanes<Real>(f13_x_p148, f13_x_p148, f13_x_p148,
      f13_x_p148, f13_x_p148, f13_x_p148, f13_x_p324, f13_x_p324) *
      detail::make_lanes<Real>(f13_x_p1573_lanes[0], f13_x_p1573_lanes[1], f13_x_p1573_lanes[2],
      f13_x_p1573_lanes[3], f13_x_p1573_lanes[4], f13_x_p1573_lanes[5], f13_x_p1266, f13_x_p1248);

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p1669 = s16 * f13_x_p1587 + c16 * f13_x_p1588 - f13_x_p308 * f13_x_p1245;
  const Real f13_x_p1670 = -(-(s17 * f13_x_p1241 + c17 * f13_x_p1242) + f13_x_p311 * f13_x_p1237) -
      f13_x_p317 * f13_x_p1245;
  const Real f13_x_p1671 = s16 * f13_x_p1589 + c16 * f13_x_p1590 - f13_x_p308 * f13_x_p1263;
  const Real f13_x_p1672 = -(-(s17 * f13_x_p1259 + c17 * f13_x_p1260) + f13_x_p311 * f13_x_p1255) -
      f13_x_p317 * f13_x_p1263;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p1673_lanes = f13_x_p141 * f13_x_p1518_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p1679_lanes = s9 * f13_x_p1603_lanes;
  const Lanes f13_x_p1685_lanes = c9 * f13_x_p1621_lanes;
  const Lanes f13_x_p1691_lanes = f13_x_p1679_lanes + f13_x_p1685_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p1697_lanes = f13_x_p1691_lanes - f13_x_p1673_lanes;
  const Lanes f13_x_p1703_lanes = s8 * f13_x_p1697_lanes;
  const Lanes f13_x_p1709_lanes = f13_x_p138 * f13_x_p1518_lanes;
  const Lanes f13_x_p1715_lanes = detail::make_lanes<Real>(-(-(s10 * f13_x_p1464_lanes[0] + c10 *
      f13_x_p1482_lanes[0]) - f13_x_p132 * f13_x_p1353),
      -(-(s10 * f13_x_p1464_lanes[1] + c10 * f13_x_p1482_lanes[1]) - f13_x_p132 * f13_x_p1352),
      -(-(s10 * f13_x_p1464_lanes[2] + c10 * f13_x_p1482_lanes[2]) - f13_x_p132 * f13_x_p1351),
      -(-(s10 * f13_x_p1464_lanes[3] + c10 * f13_x_p1482_lanes[3]) - f13_x_p132 * f13_x_p1350),
      -(-(s10 * f13_x_p1464_lanes[4] + c10 * f13_x_p1482_lanes[4]) - f13_x_p132 * f13_x_p1349),
      -(-(s10 * f13_x_p1464_lanes[5] + c10 * f13_x_p1482_lanes[5]) - f13_x_p132 * f13_x_p1348),
      -(-(s10 * f13_x_p1464_lanes[0] + c10 * f13_x_p1482_lanes[0]) - f13_x_p132 * f13_x_p1353),
      -(-(s10 * f13_x_p1464_lanes[0] + c10 * f13_x_p1482_lanes[0]) - f13_x_p132 * f13_x_p1353)) +
      f13_x_p1709_lanes;
  const Lanes f13_x_p1721_lanes = c8 * f13_x_p1715_lanes;
  const Lanes f13_x_p1727_lanes = f13_x_p1721_lanes - f13_x_p1703_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p1733_lanes = detail::make_lanes<Real>(f13_x_p1727_lanes[0],
      f13_x_p1727_lanes[1], f13_x_p1727_lanes[2], f13_x_p1727_lanes[3], f13_x_p1727_lanes[4],
      f13_x_p1727_lanes[5], c15 * f13_x_p1672 - s15 * f13_x_p1671, c15 * f13_x_p1670 - s15 *
      f13_x_p1669) - f13_x_p1661_lanes;
  const Lanes f13_x_p1741_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1733_lanes;
  const Lanes f13_x_p1749_lanes = f13_x_p1653_lanes + f13_x_p1741_lanes;

  // link 7 (left_shoulder1), articulated inertia
  const Real f13_x_p1757 = 2.6249999999999998e-05 / inverse_D7_p8;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p1758_lanes = f13_x_p1757 * f13_x_p1573_lanes;
  const Lanes f13_x_p1764_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, 0.18, 0.18) *
      detail::make_lanes<Real>(f13_x_p1758_lanes[0], f13_x_p1758_lanes[1], f13_x_p1758_lanes[2],
      f13_x_p1758_lanes[3], f13_x_p1758_lanes[4], f13_x_p1758_lanes[5], f13_x_p1749_lanes[6],
      f13_x_p1749_lanes[7]);
  const Lanes f13_x_p1772_lanes = detail::make_lanes<Real>(f13_x_p179, f13_x_p179, f13_x_p179,
      f13_x_p179, f13_x_p179, f13_x_p179, f13_x_p334, f13_x_p334) *
      detail::make_lanes<Real>(f13_x_p1573_lanes[0], f13_x_p1573_lanes[1], f13_x_p1573_lanes[2],
      f13_x_p1573_lanes[3], f13_x_p1573_lanes[4], f13_x_p1573_lanes[5], f13_x_p1266, f13_x_p1248);

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p1780_lanes = c8 * f13_x_p1697_lanes;
  const Lanes f13_x_p1786_lanes = s8 * f13_x_p1715_lanes;
  const Lanes f13_x_p1792_lanes = f13_x_p1786_lanes + f13_x_p1780_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p1798_lanes = detail::make_lanes<Real>(f13_x_p1792_lanes[0],
      f13_x_p1792_lanes[1], f13_x_p1792_lanes[2], f13_x_p1792_lanes[3], f13_x_p1792_lanes[4],
      f13_x_p1792_lanes[5], s15 * f13_x_p1672 + c15 * f13_x_p1671, s15 * f13_x_p1670 + c15 *
      f13_x_p1669) - f13_x_p1772_lanes;
  const Lanes f13_x_p1806_lanes = inverse_D6_p6 * f13_x_p1573_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p1812_lanes = s8 * f13_x_p1548_lanes;
  const Lanes f13_x_p1818_lanes = c8 * f13_x_p1561_lanes;
  const Lanes f13_x_p1824_lanes = f13_x_p1818_lanes - f13_x_p1812_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p1830_lanes = f13_x_p1824_lanes - f13_x_p1806_lanes;
  const Lanes f13_x_p1836_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, 0.226, 0.226) *
      detail::make_lanes<Real>(f13_x_p1830_lanes[0], f13_x_p1830_lanes[1], f13_x_p1830_lanes[2],
      f13_x_p1830_lanes[3], f13_x_p1830_lanes[4], f13_x_p1830_lanes[5], f13_x_p1798_lanes[6],
      f13_x_p1798_lanes[7]);
  const Lanes f13_x_p1844_lanes = f13_x_p1764_lanes - f13_x_p1836_lanes;

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p1852 = c15 * f13_x_p1247 - s15 * f13_x_p1246 - inverse_D6_p1 * f13_x_p1248;
  const Real f13_x_p1853 = c15 * f13_x_p1265 - s15 * f13_x_p1264 - inverse_D6_p1 * f13_x_p1266;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p1854_lanes = detail::make_lanes<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, s14,
      s14) * detail::make_lanes<Real>(f13_x_p1749_lanes[0], f13_x_p1749_lanes[1],
      f13_x_p1749_lanes[2], f13_x_p1749_lanes[3], f13_x_p1749_lanes[4], f13_x_p1749_lanes[5],
      f13_x_p1853, f13_x_p1852);

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p1862 = f13_x_p931 * f13_x_p1248;
  const Real f13_x_p1863 = f13_x_p931 * f13_x_p1266;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p1864_lanes = detail::make_lanes<Real>(0.226, 0.226, 0.226, 0.226, 0.226, 0.226,
      c14, c14) * detail::make_lanes<Real>(f13_x_p1798_lanes[0], f13_x_p1798_lanes[1],
      f13_x_p1798_lanes[2], f13_x_p1798_lanes[3], f13_x_p1798_lanes[4], f13_x_p1798_lanes[5],
      f13_x_p1863, f13_x_p1862);
  const Lanes f13_x_p1872_lanes = f13_x_p1864_lanes + f13_x_p1854_lanes;
  const Lanes f13_x_p1880_lanes = f13_x_p1844_lanes - f13_x_p1872_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p1888_lanes = inverse_D5_p14 * f13_x_p1880_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p1896_lanes = detail::make_lanes<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      f13_x_p1645_lanes;
  const Lanes f13_x_p1904_lanes = detail::make_lanes<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      f13_x_p1733_lanes;
  const Lanes f13_x_p1912_lanes = f13_x_p1896_lanes - f13_x_p1904_lanes;
  const Lanes f13_x_p1920_lanes = 0.18 * f13_x_p1912_lanes;
  const Lanes f13_x_p1926_lanes = c7 * f13_x_p1830_lanes;
  const Lanes f13_x_p1932_lanes = s7 * f13_x_p1758_lanes;
  const Lanes f13_x_p1938_lanes = f13_x_p1932_lanes + f13_x_p1926_lanes;
  const Lanes f13_x_p1944_lanes = f13_x_p1938_lanes + f13_x_p1920_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p1950_lanes = detail::make_lanes<Real>(f13_x_p1944_lanes[0],
      f13_x_p1944_lanes[1], f13_x_p1944_lanes[2], f13_x_p1944_lanes[3], f13_x_p1944_lanes[4],
      f13_x_p1944_lanes[5], -(s14 * f13_x_p1863 - c14 * f13_x_p1853 + 0.18 * f13_x_p1912_lanes[6]),
      -(s14 * f13_x_p1862 - c14 * f13_x_p1852 + 0.18 * f13_x_p1912_lanes[7])) - f13_x_p1888_lanes;
  const Lanes f13_x_p1958_lanes = s6 * f13_x_p1950_lanes;
  const Lanes f13_x_p1966_lanes = inverse_D5_p16 * f13_x_p1880_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p1974_lanes = 0.226 * f13_x_p1912_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p1982_lanes = f13_x_p1974_lanes - f13_x_p1966_lanes;
  const Lanes f13_x_p1990_lanes = c6 * f13_x_p1982_lanes;
  const Lanes f13_x_p1998_lanes = f13_x_p1958_lanes + f13_x_p1990_lanes;
  const Lanes f13_x_p2006_lanes = f13_x_p450 * f13_x_p1880_lanes;
  const Lanes f13_x_p2014_lanes = f13_x_p1912_lanes - f13_x_p2006_lanes;
  const Lanes f13_x_p2022_lanes = 0.072 * f13_x_p2014_lanes;
  const Lanes f13_x_p2030_lanes = f13_x_p1998_lanes + f13_x_p2022_lanes;
  const Lanes f13_x_p2038_lanes = f13_x_p410 * f13_x_p1880_lanes;
  const Lanes f13_x_p2046_lanes = f13_x_p1749_lanes - f13_x_p2038_lanes;
  const Lanes f13_x_p2054_lanes = s6 * f13_x_p2046_lanes;
  const Lanes f13_x_p2062_lanes = f13_x_p441 * f13_x_p1880_lanes;
  const Lanes f13_x_p2070_lanes = f13_x_p1798_lanes - f13_x_p2062_lanes;
  const Lanes f13_x_p2078_lanes = c6 * f13_x_p2070_lanes;
  const Lanes f13_x_p2086_lanes = f13_x_p2054_lanes + f13_x_p2078_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p2094 = -(0.072 * f13_x_p2086_lanes[7]) + f13_x_p477 * f13_x_p2030_lanes[7];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p2095_lanes = c6 * f13_x_p1950_lanes;
  const Lanes f13_x_p2103_lanes = s6 * f13_x_p1982_lanes;
  const Lanes f13_x_p2111_lanes = f13_x_p2095_lanes - f13_x_p2103_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p2119 = f13_x_p2111_lanes[7] - f13_x_p479 * f13_x_p2030_lanes[7];

  // link 4 (chest1), force propagation
  const Real f13_x_p2120 = -(s5 * f13_x_p2094 + c5 * f13_x_p2119);

  // link 5 (chest2), force propagation
  const Real f13_x_p2121 = -(0.072 * f13_x_p2086_lanes[6]) + f13_x_p477 * f13_x_p2030_lanes[6];
  const Real f13_x_p2122 = f13_x_p2111_lanes[6] - f13_x_p479 * f13_x_p2030_lanes[6];

  // link 4 (chest1), force propagation
  const Real f13_x_p2123 = -(s5 * f13_x_p2121 + c5 * f13_x_p2122);

  // link 5 (chest2), force propagation
  const Real f13_x_p2124 = -(0.072 * f13_x_p2086_lanes[5]) + f13_x_p477 * f13_x_p2030_lanes[5];
  const Real f13_x_p2125 = f13_x_p2111_lanes[5] - f13_x_p479 * f13_x_p2030_lanes[5];

  // link 4 (chest1), force propagation
  const Real f13_x_p2126 = -(s5 * f13_x_p2124 + c5 * f13_x_p2125);

  // link 5 (chest2), force propagation
  const Real f13_x_p2127 = -(0.072 * f13_x_p2086_lanes[4]) + f13_x_p477 * f13_x_p2030_lanes[4];
  const Real f13_x_p2128 = f13_x_p2111_lanes[4] - f13_x_p479 * f13_x_p2030_lanes[4];

  // link 4 (chest1), force propagation
  const Real f13_x_p2129 = -(s5 * f13_x_p2127 + c5 * f13_x_p2128);

  // link 5 (chest2), force propagation
  const Real f13_x_p2130 = -(0.072 * f13_x_p2086_lanes[3]) + f13_x_p477 * f13_x_p2030_lanes[3];
  const Real f13_x_p2131 = f13_x_p2111_lanes[3] - f13_x_p479 * f13_x_p2030_lanes[3];

  // link 4 (chest1), force propagation
  const Real f13_x_p2132 = -(s5 * f13_x_p2130 + c5 * f13_x_p2131);

  // link 5 (chest2), force propagation
  const Real f13_x_p2133 = -(0.072 * f13_x_p2086_lanes[2]) + f13_x_p477 * f13_x_p2030_lanes[2];
  const Real f13_x_p2134 = f13_x_p2111_lanes[2] - f13_x_p479 * f13_x_p2030_lanes[2];

  // link 4 (chest1), force propagation
  const Real f13_x_p2135 = -(s5 * f13_x_p2133 + c5 * f13_x_p2134);

  // link 5 (chest2), force propagation
  const Real f13_x_p2136 = -(0.072 * f13_x_p2086_lanes[1]) + f13_x_p477 * f13_x_p2030_lanes[1];
  const Real f13_x_p2137 = f13_x_p2111_lanes[1] - f13_x_p479 * f13_x_p2030_lanes[1];

  // link 4 (chest1), force propagation
  const Real f13_x_p2138 = -(s5 * f13_x_p2136 + c5 * f13_x_p2137);

  // link 5 (chest2), force propagation
  const Real f13_x_p2139 = -(0.072 * f13_x_p2086_lanes[0]) + f13_x_p477 * f13_x_p2030_lanes[0];
  const Real f13_x_p2140 = f13_x_p2111_lanes[0] - f13_x_p479 * f13_x_p2030_lanes[0];

  // link 4 (chest1), force propagation
  const Real f13_x_p2141 = -(s5 * f13_x_p2139 + c5 * f13_x_p2140);
  const Lanes f13_x_p2142_lanes = inverse_D3_p1 * detail::make_lanes<Real>(f13_x_p2141, f13_x_p2138,
      f13_x_p2135, f13_x_p2132, f13_x_p2129, f13_x_p2126, f13_x_p2123, f13_x_p2120);

  // link 5 (chest2), force propagation
  const Lanes f13_x_p2150_lanes = f13_x_p462 * f13_x_p2030_lanes;
  const Lanes f13_x_p2158_lanes = f13_x_p2086_lanes - f13_x_p2150_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2166_lanes = detail::make_lanes<Real>(-(s5 * f13_x_p2140 - c5 * f13_x_p2139 +
      0.21799999999999997 * f13_x_p2158_lanes[0]), -(s5 * f13_x_p2137 - c5 * f13_x_p2136 +
      0.21799999999999997 * f13_x_p2158_lanes[1]), -(s5 * f13_x_p2134 - c5 * f13_x_p2133 +
      0.21799999999999997 * f13_x_p2158_lanes[2]), -(s5 * f13_x_p2131 - c5 * f13_x_p2130 +
      0.21799999999999997 * f13_x_p2158_lanes[3]), -(s5 * f13_x_p2128 - c5 * f13_x_p2127 +
      0.21799999999999997 * f13_x_p2158_lanes[4]), -(s5 * f13_x_p2125 - c5 * f13_x_p2124 +
      0.21799999999999997 * f13_x_p2158_lanes[5]), -(s5 * f13_x_p2122 - c5 * f13_x_p2121 +
      0.21799999999999997 * f13_x_p2158_lanes[6]), -(s5 * f13_x_p2119 - c5 * f13_x_p2094 +
      0.21799999999999997 * f13_x_p2158_lanes[7])) - f13_x_p2142_lanes;
  const Lanes f13_x_p2174_lanes = s4 * f13_x_p2166_lanes;
  const Lanes f13_x_p2182_lanes = inverse_D3_p2 * detail::make_lanes<Real>(f13_x_p2141, f13_x_p2138,
      f13_x_p2135, f13_x_p2132, f13_x_p2129, f13_x_p2126, f13_x_p2123, f13_x_p2120);

  // link 6 (chest3), force propagation
  const Lanes f13_x_p2190_lanes = c6 * f13_x_p2046_lanes;
  const Lanes f13_x_p2198_lanes = s6 * f13_x_p2070_lanes;
  const Lanes f13_x_p2206_lanes = f13_x_p2190_lanes - f13_x_p2198_lanes;

  // link 5 (chest2), force propagation
  const Real f13_x_p2214 = f13_x_p2206_lanes[7] - f13_x_p490 * f13_x_p2030_lanes[7];
  const Real f13_x_p2215 = f13_x_p2014_lanes[7] - f13_x_p486 * f13_x_p2030_lanes[7];
  const Real f13_x_p2216 = s5 * f13_x_p2214 - c5 * f13_x_p2215;
  const Real f13_x_p2217 = f13_x_p2206_lanes[6] - f13_x_p490 * f13_x_p2030_lanes[6];
  const Real f13_x_p2218 = f13_x_p2014_lanes[6] - f13_x_p486 * f13_x_p2030_lanes[6];
  const Real f13_x_p2219 = s5 * f13_x_p2217 - c5 * f13_x_p2218;
  const Real f13_x_p2220 = f13_x_p2206_lanes[5] - f13_x_p490 * f13_x_p2030_lanes[5];
  const Real f13_x_p2221 = f13_x_p2014_lanes[5] - f13_x_p486 * f13_x_p2030_lanes[5];
  const Real f13_x_p2222 = s5 * f13_x_p2220 - c5 * f13_x_p2221;
  const Real f13_x_p2223 = f13_x_p2206_lanes[4] - f13_x_p490 * f13_x_p2030_lanes[4];
  const Real f13_x_p2224 = f13_x_p2014_lanes[4] - f13_x_p486 * f13_x_p2030_lanes[4];
  const Real f13_x_p2225 = s5 * f13_x_p2223 - c5 * f13_x_p2224;
  const Real f13_x_p2226 = f13_x_p2206_lanes[3] - f13_x_p490 * f13_x_p2030_lanes[3];
  const Real f13_x_p2227 = f13_x_p2014_lanes[3] - f13_x_p486 * f13_x_p2030_lanes[3];
  const Real f13_x_p2228 = s5 * f13_x_p2226 - c5 * f13_x_p2227;
  const Real f13_x_p2229 = f13_x_p2206_lanes[2] - f13_x_p490 * f13_x_p2030_lanes[2];
  const Real f13_x_p2230 = f13_x_p2014_lanes[2] - f13_x_p486 * f13_x_p2030_lanes[2];
  const Real f13_x_p2231 = s5 * f13_x_p2229 - c5 * f13_x_p2230;
  const Real f13_x_p2232 = f13_x_p2206_lanes[1] - f13_x_p490 * f13_x_p2030_lanes[1];
  const Real f13_x_p2233 = f13_x_p2014_lanes[1] - f13_x_p486 * f13_x_p2030_lanes[1];
  const Real f13_x_p2234 = s5 * f13_x_p2232 - c5 * f13_x_p2233;
  const Real f13_x_p2235 = f13_x_p2206_lanes[0] - f13_x_p490 * f13_x_p2030_lanes[0];
  const Real f13_x_p2236 = f13_x_p2014_lanes[0] - f13_x_p486 * f13_x_p2030_lanes[0];
  const Real f13_x_p2237 = s5 * f13_x_p2235 - c5 * f13_x_p2236;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2238_lanes = detail::make_lanes<Real>(-(0.21799999999999997 * f13_x_p2237),
      -(0.21799999999999997 * f13_x_p2234), -(0.21799999999999997 * f13_x_p2231),
      -(0.21799999999999997 * f13_x_p2228), -(0.21799999999999997 * f13_x_p2225),
      -(0.21799999999999997 * f13_x_p2222), -(0.21799999999999997 * f13_x_p2219),
      -(0.21799999999999997 * f13_x_p2216)) + f13_x_p2182_lanes;
  const Lanes f13_x_p2246_lanes = c4 * f13_x_p2238_lanes;
  const Lanes f13_x_p2254_lanes = f13_x_p2174_lanes + f13_x_p2246_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p2262_lanes = f13_x_p520 * f13_x_p2254_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2270_lanes = f13_x_p498 * detail::make_lanes<Real>(f13_x_p2141, f13_x_p2138,
      f13_x_p2135, f13_x_p2132, f13_x_p2129, f13_x_p2126, f13_x_p2123, f13_x_p2120);
  const Lanes f13_x_p2278_lanes = detail::make_lanes<Real>(-f13_x_p2237, -f13_x_p2234, -f13_x_p2231,
      -f13_x_p2228, -f13_x_p2225, -f13_x_p2222, -f13_x_p2219, -f13_x_p2216) + f13_x_p2270_lanes;
  const Lanes f13_x_p2286_lanes = c4 * f13_x_p2278_lanes;
  const Lanes f13_x_p2294_lanes = f13_x_p507 * detail::make_lanes<Real>(f13_x_p2141, f13_x_p2138,
      f13_x_p2135, f13_x_p2132, f13_x_p2129, f13_x_p2126, f13_x_p2123, f13_x_p2120);
  const Lanes f13_x_p2302_lanes = f13_x_p2158_lanes + f13_x_p2294_lanes;
  const Lanes f13_x_p2310_lanes = s4 * f13_x_p2302_lanes;
  const Lanes f13_x_p2318_lanes = f13_x_p2286_lanes - f13_x_p2310_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p2326_lanes = f13_x_p2318_lanes - f13_x_p2262_lanes;
  const Lanes f13_x_p2334_lanes = c3 * f13_x_p2326_lanes;
  const Lanes f13_x_p2342_lanes = f13_x_p530 * f13_x_p2254_lanes;
  const Lanes f13_x_p2350_lanes = detail::make_lanes<Real>(-(-(s5 * f13_x_p2236 + c5 *
      f13_x_p2235) - f13_x_p525 * f13_x_p2141), -(-(s5 * f13_x_p2233 + c5 * f13_x_p2232) -
      f13_x_p525 * f13_x_p2138), -(-(s5 * f13_x_p2230 + c5 * f13_x_p2229) - f13_x_p525 *
      f13_x_p2135), -(-(s5 * f13_x_p2227 + c5 * f13_x_p2226) - f13_x_p525 * f13_x_p2132),
      -(-(s5 * f13_x_p2224 + c5 * f13_x_p2223) - f13_x_p525 * f13_x_p2129),
      -(-(s5 * f13_x_p2221 + c5 * f13_x_p2220) - f13_x_p525 * f13_x_p2126),
      -(-(s5 * f13_x_p2218 + c5 * f13_x_p2217) - f13_x_p525 * f13_x_p2123),
      -(-(s5 * f13_x_p2215 + c5 * f13_x_p2214) - f13_x_p525 * f13_x_p2120)) + f13_x_p2342_lanes;
  const Lanes f13_x_p2358_lanes = s3 * f13_x_p2350_lanes;
  const Lanes f13_x_p2366_lanes = f13_x_p2334_lanes - f13_x_p2358_lanes;
  const Lanes f13_x_p2374_lanes = 0.422 * f13_x_p2366_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2382_lanes = f13_x_p537 * f13_x_p2374_lanes;
  const Lanes f13_x_p2390_lanes = f13_x_p2366_lanes - f13_x_p2382_lanes;
  const Lanes f13_x_p2398_lanes = c2 * f13_x_p2390_lanes;
  const Lanes f13_x_p2406_lanes = f13_x_p1194 * f13_x_p2374_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p2414_lanes = s3 * f13_x_p2326_lanes;
  const Lanes f13_x_p2422_lanes = c3 * f13_x_p2350_lanes;
  const Lanes f13_x_p2430_lanes = f13_x_p2414_lanes + f13_x_p2422_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2438_lanes = f13_x_p2430_lanes - f13_x_p2406_lanes;
  const Lanes f13_x_p2446_lanes = s2 * f13_x_p2438_lanes;
  const Lanes f13_x_p2454_lanes = f13_x_p2398_lanes - f13_x_p2446_lanes;
  const Lanes f13_x_p2462_lanes = 0.434 * f13_x_p2454_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p2470_lanes = f13_x_p1227_lanes * f13_x_p2462_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2474_lanes = f13_x_p1176_lanes * inverse_D2;
  const Lanes f13_x_p2478_lanes = f13_x_p2474_lanes * f13_x_p2374_lanes[0];

  // link 3 (hip), force propagation
  const Lanes f13_x_p2482_lanes = f13_x_p1116_lanes * inverse_D3;
  const Lanes f13_x_p2486_lanes = f13_x_p2482_lanes * f13_x_p2254_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2490_lanes = detail::make_lanes<Real>(f13_x_p1059, f13_x_p1056, f13_x_p1053,
      f13_x_p1050, f13_x_p1059, f13_x_p1059, f13_x_p1059, f13_x_p1059) * inverse_D4;
  const Lanes f13_x_p2494_lanes = f13_x_p2490_lanes * f13_x_p2141;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p2498_lanes = f13_x_p1004_lanes * inverse_D5;
  const Lanes f13_x_p2502_lanes = f13_x_p2498_lanes * f13_x_p2030_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p2506_lanes = f13_x_p944_lanes * inverse_D6;
  const Lanes f13_x_p2510_lanes = f13_x_p2506_lanes * f13_x_p1880_lanes[0];

  // link 5 (chest2), force propagation
  const Lanes f13_x_p2514_lanes = f13_x_p2510_lanes + f13_x_p2502_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2518_lanes = f13_x_p2514_lanes + f13_x_p2494_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p2522_lanes = f13_x_p2518_lanes + f13_x_p2486_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2526_lanes = f13_x_p2522_lanes + f13_x_p2478_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p2530_lanes = f13_x_p2526_lanes + f13_x_p2470_lanes;
  const Lanes f13_x_p2534_lanes = f13_x_p2462_lanes * inverse_D1;
  const Lanes f13_x_p2542_lanes = f13_x_p2534_lanes * f13_x_p2462_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2550_lanes = f13_x_p2374_lanes * inverse_D2;
  const Lanes f13_x_p2558_lanes = f13_x_p2550_lanes * f13_x_p2374_lanes[0];

  // link 3 (hip), force propagation
  const Lanes f13_x_p2566_lanes = f13_x_p2254_lanes * inverse_D3;
  const Lanes f13_x_p2574_lanes = f13_x_p2566_lanes * f13_x_p2254_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2582_lanes = detail::make_lanes<Real>(f13_x_p2141, f13_x_p2138, f13_x_p2135,
      f13_x_p2132, f13_x_p2129, f13_x_p2126, f13_x_p2123, f13_x_p2120) * inverse_D4;
  const Lanes f13_x_p2590_lanes = f13_x_p2582_lanes * f13_x_p2141;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p2598_lanes = f13_x_p2030_lanes * inverse_D5;
  const Lanes f13_x_p2606_lanes = f13_x_p2598_lanes * f13_x_p2030_lanes[0];

  // link 6 (chest3), force propagation
  const Real f13_x_p2614 = f13_x_p1880_lanes[7] * inverse_D6;
  const Real f13_x_p2615 = f13_x_p1880_lanes[6] * inverse_D6;
  const Lanes f13_x_p2616_lanes = f13_x_p1880_lanes * inverse_D6;
  const Lanes f13_x_p2622_lanes = f13_x_p2616_lanes * f13_x_p1880_lanes[0];

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p2628_lanes = f13_x_p1573_lanes * inverse_D7;
  const Lanes f13_x_p2634_lanes = f13_x_p2628_lanes * f13_x_p1573_lanes[0];

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p2640_lanes = f13_x_p1518_lanes * inverse_D8;
  const Lanes f13_x_p2646_lanes = f13_x_p2640_lanes * f13_x_p1518_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p2652_lanes = detail::make_lanes<Real>(f13_x_p1353, f13_x_p1352, f13_x_p1351,
      f13_x_p1350, f13_x_p1349, f13_x_p1348, f13_x_p1353, f13_x_p1353) * inverse_D9;
  const Lanes f13_x_p2658_lanes = f13_x_p2652_lanes * f13_x_p1353;

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p2664_lanes = detail::make_lanes<Real>(f13_x_p1308_lanes[0],
      f13_x_p1308_lanes[1], f13_x_p1314, f13_x_p1308_lanes[3], f13_x_p1308_lanes[4],
      f13_x_p1308_lanes[5], f13_x_p1308_lanes[0], f13_x_p1308_lanes[0]) * inverse_D10;
  const Lanes f13_x_p2670_lanes = f13_x_p2664_lanes * f13_x_p1308_lanes[0];

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p2676_lanes = f13_x_p2670_lanes + f13_x_p2658_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p2682_lanes = f13_x_p2676_lanes + f13_x_p2646_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p2688_lanes = f13_x_p2682_lanes + f13_x_p2634_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p2694_lanes = f13_x_p2688_lanes + f13_x_p2622_lanes;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p2700_lanes = detail::make_lanes<Real>(f13_x_p2694_lanes[0],
      f13_x_p2694_lanes[1], f13_x_p2694_lanes[2], f13_x_p2694_lanes[3], f13_x_p2694_lanes[4],
      f13_x_p2694_lanes[5], f13_x_p2615 * f13_x_p1880_lanes[0], f13_x_p2614 *
      f13_x_p1880_lanes[0]) + f13_x_p2606_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2708_lanes = f13_x_p2700_lanes + f13_x_p2590_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p2716_lanes = f13_x_p2708_lanes + f13_x_p2574_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2724_lanes = f13_x_p2716_lanes + f13_x_p2558_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p2732_lanes = f13_x_p2724_lanes + f13_x_p2542_lanes;
  const Real f13_x_p2740 = 1.0 / f13_x_p2732_lanes[0];
  const Lanes f13_x_p2741_lanes = f13_x_p2530_lanes * f13_x_p2740;
  const Lanes f13_x_p2745_lanes = f13_x_p2741_lanes * f13_x_p2732_lanes[1];
  const Lanes f13_x_p2749_lanes = f13_x_p1227_lanes * f13_x_p2462_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2753_lanes = f13_x_p2474_lanes * f13_x_p2374_lanes[1];

  // link 3 (hip), force propagation
  const Lanes f13_x_p2757_lanes = f13_x_p2482_lanes * f13_x_p2254_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2761_lanes = f13_x_p2490_lanes * f13_x_p2138;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p2765_lanes = f13_x_p2498_lanes * f13_x_p2030_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p2769_lanes = f13_x_p2506_lanes * f13_x_p1880_lanes[1];

  // link 5 (chest2), force propagation
  const Lanes f13_x_p2773_lanes = f13_x_p2769_lanes + f13_x_p2765_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2777_lanes = f13_x_p2773_lanes + f13_x_p2761_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p2781_lanes = f13_x_p2777_lanes + f13_x_p2757_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2785_lanes = f13_x_p2781_lanes + f13_x_p2753_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p2789_lanes = f13_x_p2785_lanes + f13_x_p2749_lanes;
  const Lanes f13_x_p2793_lanes = f13_x_p2789_lanes - f13_x_p2745_lanes;
  const Lanes f13_x_p2797_lanes = f13_x_p2732_lanes * f13_x_p2740;
  const Lanes f13_x_p2804_lanes = f13_x_p2797_lanes * f13_x_p2732_lanes[1];
  const Lanes f13_x_p2811_lanes = f13_x_p2534_lanes * f13_x_p2462_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2818_lanes = f13_x_p2550_lanes * f13_x_p2374_lanes[1];

  // link 3 (hip), force propagation
  const Lanes f13_x_p2825_lanes = f13_x_p2566_lanes * f13_x_p2254_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2832_lanes = f13_x_p2582_lanes * f13_x_p2138;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p2839_lanes = f13_x_p2598_lanes * f13_x_p2030_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p2846_lanes = f13_x_p2616_lanes * f13_x_p1880_lanes[1];

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p2851_lanes = f13_x_p2628_lanes * f13_x_p1573_lanes[1];

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p2856_lanes = f13_x_p2640_lanes * f13_x_p1518_lanes[1];

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p2861_lanes = f13_x_p2652_lanes * f13_x_p1352;

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p2866_lanes = f13_x_p2664_lanes * f13_x_p1308_lanes[1];

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p2871_lanes = f13_x_p2866_lanes + f13_x_p2861_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p2876_lanes = f13_x_p2871_lanes + f13_x_p2856_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p2881_lanes = f13_x_p2876_lanes + f13_x_p2851_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p2886_lanes = f13_x_p2881_lanes + f13_x_p2846_lanes;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p2891_lanes = detail::make_lanes<Real>(f13_x_p2886_lanes[1],
      f13_x_p2886_lanes[1], f13_x_p2886_lanes[2], f13_x_p2886_lanes[3], f13_x_p2886_lanes[4],
      f13_x_p2886_lanes[5], f13_x_p2615 * f13_x_p1880_lanes[1], f13_x_p2614 *
      f13_x_p1880_lanes[1]) + f13_x_p2839_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2898_lanes = f13_x_p2891_lanes + f13_x_p2832_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p2905_lanes = f13_x_p2898_lanes + f13_x_p2825_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2912_lanes = f13_x_p2905_lanes + f13_x_p2818_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p2919_lanes = f13_x_p2912_lanes + f13_x_p2811_lanes;
  const Lanes f13_x_p2926_lanes = f13_x_p2919_lanes - f13_x_p2804_lanes;
  const Real f13_x_p2933 = 1.0 / f13_x_p2926_lanes[1];
  const Lanes f13_x_p2934_lanes = f13_x_p2793_lanes * f13_x_p2933;
  const Lanes f13_x_p2938_lanes = f13_x_p2934_lanes * f13_x_p2926_lanes[2];
  const Lanes f13_x_p2942_lanes = f13_x_p2741_lanes * f13_x_p2732_lanes[2];
  const Lanes f13_x_p2946_lanes = f13_x_p1227_lanes * f13_x_p2462_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2950_lanes = f13_x_p2474_lanes * f13_x_p2374_lanes[2];

  // link 3 (hip), force propagation
  const Lanes f13_x_p2954_lanes = f13_x_p2482_lanes * f13_x_p2254_lanes[2];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2958_lanes = f13_x_p2490_lanes * f13_x_p2135;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p2962_lanes = f13_x_p2498_lanes * f13_x_p2030_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p2966_lanes = f13_x_p2506_lanes * f13_x_p1880_lanes[2];

  // link 5 (chest2), force propagation
  const Lanes f13_x_p2970_lanes = f13_x_p2966_lanes + f13_x_p2962_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p2974_lanes = f13_x_p2970_lanes + f13_x_p2958_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p2978_lanes = f13_x_p2974_lanes + f13_x_p2954_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p2982_lanes = f13_x_p2978_lanes + f13_x_p2950_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p2986_lanes = f13_x_p2982_lanes + f13_x_p2946_lanes;
  const Lanes f13_x_p2990_lanes = f13_x_p2986_lanes - f13_x_p2942_lanes;
  const Lanes f13_x_p2994_lanes = f13_x_p2990_lanes - f13_x_p2938_lanes;
  const Lanes f13_x_p2998_lanes = f13_x_p2926_lanes * f13_x_p2933;
  const Lanes f13_x_p3004_lanes = f13_x_p2998_lanes * f13_x_p2926_lanes[2];
  const Lanes f13_x_p3010_lanes = f13_x_p2797_lanes * f13_x_p2732_lanes[2];
  const Lanes f13_x_p3016_lanes = f13_x_p2534_lanes * f13_x_p2462_lanes[2];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3022_lanes = f13_x_p2550_lanes * f13_x_p2374_lanes[2];

  // link 3 (hip), force propagation
  const Lanes f13_x_p3028_lanes = f13_x_p2566_lanes * f13_x_p2254_lanes[2];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3034_lanes = f13_x_p2582_lanes * f13_x_p2135;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3040_lanes = f13_x_p2598_lanes * f13_x_p2030_lanes[2];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3046_lanes = f13_x_p2616_lanes * f13_x_p1880_lanes[2];

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p3050_lanes = f13_x_p2628_lanes * f13_x_p1573_lanes[2];

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p3054_lanes = f13_x_p2640_lanes * f13_x_p1518_lanes[2];

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p3058_lanes = f13_x_p2652_lanes * f13_x_p1351;

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p3062_lanes = f13_x_p2664_lanes * f13_x_p1314;

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p3066_lanes = f13_x_p3062_lanes + f13_x_p3058_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p3070_lanes = f13_x_p3066_lanes + f13_x_p3054_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p3074_lanes = f13_x_p3070_lanes + f13_x_p3050_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3078_lanes = f13_x_p3074_lanes + f13_x_p3046_lanes;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3082_lanes = detail::make_lanes<Real>(f13_x_p3078_lanes[2],
      f13_x_p3078_lanes[2], f13_x_p3078_lanes[2], f13_x_p3078_lanes[3], f13_x_p3078_lanes[4],
      f13_x_p3078_lanes[5], f13_x_p2615 * f13_x_p1880_lanes[2], f13_x_p2614 *
      f13_x_p1880_lanes[2]) + f13_x_p3040_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3088_lanes = f13_x_p3082_lanes + f13_x_p3034_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p3094_lanes = f13_x_p3088_lanes + f13_x_p3028_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3100_lanes = f13_x_p3094_lanes + f13_x_p3022_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p3106_lanes = f13_x_p3100_lanes + f13_x_p3016_lanes;
  const Lanes f13_x_p3112_lanes = f13_x_p3106_lanes - f13_x_p3010_lanes;
  const Lanes f13_x_p3118_lanes = f13_x_p3112_lanes - f13_x_p3004_lanes;
  const Real f13_x_p3124 = 1.0 / f13_x_p3118_lanes[2];
  const Lanes f13_x_p3125_lanes = f13_x_p2994_lanes * f13_x_p3124;
  const Lanes f13_x_p3129_lanes = f13_x_p3125_lanes * f13_x_p3118_lanes[3];
  const Lanes f13_x_p3133_lanes = f13_x_p2934_lanes * f13_x_p2926_lanes[3];
  const Lanes f13_x_p3137_lanes = f13_x_p2741_lanes * f13_x_p2732_lanes[3];
  const Lanes f13_x_p3141_lanes = f13_x_p1227_lanes * f13_x_p2462_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3145_lanes = f13_x_p2474_lanes * f13_x_p2374_lanes[3];

  // link 3 (hip), force propagation
  const Lanes f13_x_p3149_lanes = f13_x_p2482_lanes * f13_x_p2254_lanes[3];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3153_lanes = f13_x_p2490_lanes * f13_x_p2132;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3157_lanes = f13_x_p2498_lanes * f13_x_p2030_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3161_lanes = f13_x_p2506_lanes * f13_x_p1880_lanes[3];

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3165_lanes = f13_x_p3161_lanes + f13_x_p3157_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3169_lanes = f13_x_p3165_lanes + f13_x_p3153_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p3173_lanes = f13_x_p3169_lanes + f13_x_p3149_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3177_lanes = f13_x_p3173_lanes + f13_x_p3145_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p3181_lanes = f13_x_p3177_lanes + f13_x_p3141_lanes;
  const Lanes f13_x_p3185_lanes = f13_x_p3181_lanes - f13_x_p3137_lanes;
  const Lanes f13_x_p3189_lanes = f13_x_p3185_lanes - f13_x_p3133_lanes;
  const Lanes f13_x_p3193_lanes = f13_x_p3189_lanes - f13_x_p3129_lanes;
  const Lanes f13_x_p3197_lanes = f13_x_p3118_lanes * f13_x_p3124;
  const Lanes f13_x_p3202_lanes = f13_x_p3197_lanes * f13_x_p3118_lanes[3];
  const Lanes f13_x_p3207_lanes = f13_x_p2998_lanes * f13_x_p2926_lanes[3];
  const Lanes f13_x_p3212_lanes = f13_x_p2797_lanes * f13_x_p2732_lanes[3];
  const Lanes f13_x_p3217_lanes = f13_x_p2534_lanes * f13_x_p2462_lanes[3];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3222_lanes = f13_x_p2550_lanes * f13_x_p2374_lanes[3];

  // link 3 (hip), force propagation
  const Lanes f13_x_p3227_lanes = f13_x_p2566_lanes * f13_x_p2254_lanes[3];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3232_lanes = f13_x_p2582_lanes * f13_x_p2132;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3237_lanes = f13_x_p2598_lanes * f13_x_p2030_lanes[3];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3242_lanes = f13_x_p2616_lanes * f13_x_p1880_lanes[3];

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p3245_lanes = f13_x_p2628_lanes * f13_x_p1573_lanes[3];

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p3248_lanes = f13_x_p2640_lanes * f13_x_p1518_lanes[3];

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p3251_lanes = f13_x_p2652_lanes * f13_x_p1350;

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p3254_lanes = f13_x_p2664_lanes * f13_x_p1308_lanes[3];

  // link 11 (left_wrist1), force propagation
  const Lanes f13_x_p3257_lanes = detail::make_lanes<Real>(f13_x_p1277, f13_x_p1277, f13_x_p1277,
      f13_x_p1277, f13_x_p1273, f13_x_p1269, f13_x_p1277, f13_x_p1277) * inverse_D11;
  const Lanes f13_x_p3260_lanes = f13_x_p3257_lanes * f13_x_p1277;

  // link 12 (left_wrist2), force propagation
  const Lanes f13_x_p3263_lanes = detail::make_lanes<Real>(s13, s13, s13, s13, c13, f13_x_p1267,
      s13, s13) * inverse_D12;
  const Lanes f13_x_p3266_lanes = f13_x_p3263_lanes * s13;

  // link 11 (left_wrist1), force propagation
  const Lanes f13_x_p3269_lanes = f13_x_p3266_lanes + f13_x_p3260_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p3272_lanes = f13_x_p3269_lanes + f13_x_p3254_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p3275_lanes = f13_x_p3272_lanes + f13_x_p3251_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p3278_lanes = f13_x_p3275_lanes + f13_x_p3248_lanes;

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p3281_lanes = f13_x_p3278_lanes + f13_x_p3245_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3284_lanes = f13_x_p3281_lanes + f13_x_p3242_lanes;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3287_lanes = detail::make_lanes<Real>(f13_x_p3284_lanes[3],
      f13_x_p3284_lanes[3], f13_x_p3284_lanes[3], f13_x_p3284_lanes[3], f13_x_p3284_lanes[4],
      f13_x_p3284_lanes[5], f13_x_p2615 * f13_x_p1880_lanes[3], f13_x_p2614 *
      f13_x_p1880_lanes[3]) + f13_x_p3237_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3292_lanes = f13_x_p3287_lanes + f13_x_p3232_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p3297_lanes = f13_x_p3292_lanes + f13_x_p3227_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3302_lanes = f13_x_p3297_lanes + f13_x_p3222_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p3307_lanes = f13_x_p3302_lanes + f13_x_p3217_lanes;
  const Lanes f13_x_p3312_lanes = f13_x_p3307_lanes - f13_x_p3212_lanes;
  const Lanes f13_x_p3317_lanes = f13_x_p3312_lanes - f13_x_p3207_lanes;
  const Lanes f13_x_p3322_lanes = f13_x_p3317_lanes - f13_x_p3202_lanes;
  const Real f13_x_p3327 = 1.0 / f13_x_p3322_lanes[3];
  const Lanes f13_x_p3328_lanes = f13_x_p3193_lanes * f13_x_p3327;
  const Lanes f13_x_p3332_lanes = f13_x_p3328_lanes * f13_x_p3322_lanes[4];
  const Lanes f13_x_p3336_lanes = f13_x_p3125_lanes * f13_x_p3118_lanes[4];
  const Lanes f13_x_p3340_lanes = f13_x_p2934_lanes * f13_x_p2926_lanes[4];
  const Lanes f13_x_p3344_lanes = f13_x_p2741_lanes * f13_x_p2732_lanes[4];
  const Lanes f13_x_p3348_lanes = f13_x_p1227_lanes * f13_x_p2462_lanes[4];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3352_lanes = f13_x_p2474_lanes * f13_x_p2374_lanes[4];

  // link 3 (hip), force propagation
  const Lanes f13_x_p3356_lanes = f13_x_p2482_lanes * f13_x_p2254_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3360_lanes = f13_x_p2490_lanes * f13_x_p2129;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3364_lanes = f13_x_p2498_lanes * f13_x_p2030_lanes[4];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3368_lanes = f13_x_p2506_lanes * f13_x_p1880_lanes[4];

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3372_lanes = f13_x_p3368_lanes + f13_x_p3364_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3376_lanes = f13_x_p3372_lanes + f13_x_p3360_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p3380_lanes = f13_x_p3376_lanes + f13_x_p3356_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3384_lanes = f13_x_p3380_lanes + f13_x_p3352_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p3388_lanes = f13_x_p3384_lanes + f13_x_p3348_lanes;
  const Lanes f13_x_p3392_lanes = f13_x_p3388_lanes - f13_x_p3344_lanes;
  const Lanes f13_x_p3396_lanes = f13_x_p3392_lanes - f13_x_p3340_lanes;
  const Lanes f13_x_p3400_lanes = f13_x_p3396_lanes - f13_x_p3336_lanes;
  const Lanes f13_x_p3404_lanes = f13_x_p3400_lanes - f13_x_p3332_lanes;
  const Lanes f13_x_p3408_lanes = f13_x_p3322_lanes * f13_x_p3327;
  const Lanes f13_x_p3412_lanes = f13_x_p3408_lanes * f13_x_p3322_lanes[4];
  const Lanes f13_x_p3416_lanes = f13_x_p3197_lanes * f13_x_p3118_lanes[4];
  const Lanes f13_x_p3420_lanes = f13_x_p2998_lanes * f13_x_p2926_lanes[4];
  const Lanes f13_x_p3424_lanes = f13_x_p2797_lanes * f13_x_p2732_lanes[4];
  const Lanes f13_x_p3428_lanes = f13_x_p2534_lanes * f13_x_p2462_lanes[4];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3432_lanes = f13_x_p2550_lanes * f13_x_p2374_lanes[4];

  // link 3 (hip), force propagation
  const Lanes f13_x_p3436_lanes = f13_x_p2566_lanes * f13_x_p2254_lanes[4];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3440_lanes = f13_x_p2582_lanes * f13_x_p2129;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3444_lanes = f13_x_p2598_lanes * f13_x_p2030_lanes[4];

  // link 12 (left_wrist2), force propagation
  const Lanes f13_x_p3448_lanes = f13_x_p3263_lanes * c13;

  // link 11 (left_wrist1), force propagation
  const Lanes f13_x_p3450_lanes = f13_x_p3448_lanes +
      detail::make_lanes<Real>(f13_x_p3257_lanes[4] * f13_x_p1273, f13_x_p3257_lanes[4] *
      f13_x_p1273, f13_x_p3257_lanes[4] * f13_x_p1273, f13_x_p3257_lanes[4] * f13_x_p1273,
      f13_x_p3257_lanes[4] * f13_x_p1273, f13_x_p3257_lanes[5] * f13_x_p1273, f13_x_p3257_lanes[4] *
      f13_x_p1273, f13_x_p3257_lanes[4] * f13_x_p1273);

  // link 10 (left_lowerarm), force propagation
  const Lanes f13_x_p3452_lanes = f13_x_p3450_lanes +
      detail::make_lanes<Real>(f13_x_p2664_lanes[4] * f13_x_p1308_lanes[4], f13_x_p2664_lanes[4] *
      f13_x_p1308_lanes[4], f13_x_p2664_lanes[4] * f13_x_p1308_lanes[4], f13_x_p2664_lanes[4] *
      f13_x_p1308_lanes[4], f13_x_p2664_lanes[4] * f13_x_p1308_lanes[4], f13_x_p2664_lanes[5] *
      f13_x_p1308_lanes[4], f13_x_p2664_lanes[4] * f13_x_p1308_lanes[4], f13_x_p2664_lanes[4] *
      f13_x_p1308_lanes[4]);

  // link 9 (left_upperarm), force propagation
  const Lanes f13_x_p3454_lanes = f13_x_p3452_lanes +
      detail::make_lanes<Real>(f13_x_p2652_lanes[4] * f13_x_p1349, f13_x_p2652_lanes[4] *
      f13_x_p1349, f13_x_p2652_lanes[4] * f13_x_p1349, f13_x_p2652_lanes[4] * f13_x_p1349,
      f13_x_p2652_lanes[4] * f13_x_p1349, f13_x_p2652_lanes[5] * f13_x_p1349, f13_x_p2652_lanes[4] *
      f13_x_p1349, f13_x_p2652_lanes[4] * f13_x_p1349);

  // link 8 (left_shoulder2), force propagation
  const Lanes f13_x_p3456_lanes = f13_x_p3454_lanes +
      detail::make_lanes<Real>(f13_x_p2640_lanes[4] * f13_x_p1518_lanes[4], f13_x_p2640_lanes[4] *
      f13_x_p1518_lanes[4], f13_x_p2640_lanes[4] * f13_x_p1518_lanes[4], f13_x_p2640_lanes[4] *
      f13_x_p1518_lanes[4], f13_x_p2640_lanes[4] * f13_x_p1518_lanes[4], f13_x_p2640_lanes[5] *
      f13_x_p1518_lanes[4], f13_x_p2640_lanes[4] * f13_x_p1518_lanes[4], f13_x_p2640_lanes[4] *
      f13_x_p1518_lanes[4]);

  // link 7 (left_shoulder1), force propagation
  const Lanes f13_x_p3458_lanes = f13_x_p3456_lanes +
      detail::make_lanes<Real>(f13_x_p2628_lanes[4] * f13_x_p1573_lanes[4], f13_x_p2628_lanes[4] *
      f13_x_p1573_lanes[4], f13_x_p2628_lanes[4] * f13_x_p1573_lanes[4], f13_x_p2628_lanes[4] *
      f13_x_p1573_lanes[4], f13_x_p2628_lanes[4] * f13_x_p1573_lanes[4], f13_x_p2628_lanes[5] *
      f13_x_p1573_lanes[4], f13_x_p2628_lanes[4] * f13_x_p1573_lanes[4], f13_x_p2628_lanes[4] *
      f13_x_p1573_lanes[4]);

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3460_lanes = f13_x_p3458_lanes +
      detail::make_lanes<Real>(f13_x_p2616_lanes[4] * f13_x_p1880_lanes[4], f13_x_p2616_lanes[4] *
      f13_x_p1880_lanes[4], f13_x_p2616_lanes[4] * f13_x_p1880_lanes[4], f13_x_p2616_lanes[4] *
      f13_x_p1880_lanes[4], f13_x_p2616_lanes[4] * f13_x_p1880_lanes[4], f13_x_p2616_lanes[5] *
      f13_x_p1880_lanes[4], f13_x_p2616_lanes[4] * f13_x_p1880_lanes[4], f13_x_p2616_lanes[4] *
      f13_x_p1880_lanes[4]);

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3462_lanes = detail::make_lanes<Real>(f13_x_p3460_lanes[4],
      f13_x_p3460_lanes[4], f13_x_p3460_lanes[4], f13_x_p3460_lanes[4], f13_x_p3460_lanes[4],
      f13_x_p3460_lanes[5], f13_x_p2615 * f13_x_p1880_lanes[4], f13_x_p2614 *
      f13_x_p1880_lanes[4]) + f13_x_p3444_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3466_lanes = f13_x_p3462_lanes + f13_x_p3440_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p3470_lanes = f13_x_p3466_lanes + f13_x_p3436_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3474_lanes = f13_x_p3470_lanes + f13_x_p3432_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p3478_lanes = f13_x_p3474_lanes + f13_x_p3428_lanes;
  const Lanes f13_x_p3482_lanes = f13_x_p3478_lanes - f13_x_p3424_lanes;
  const Lanes f13_x_p3486_lanes = f13_x_p3482_lanes - f13_x_p3420_lanes;
  const Lanes f13_x_p3490_lanes = f13_x_p3486_lanes - f13_x_p3416_lanes;
  const Lanes f13_x_p3494_lanes = f13_x_p3490_lanes - f13_x_p3412_lanes;
  const Real f13_x_p3498 = 1.0 / f13_x_p3494_lanes[4];
  const Lanes f13_x_p3499_lanes = f13_x_p3404_lanes * f13_x_p3498;
  const Lanes f13_x_p3503_lanes = f13_x_p3499_lanes * f13_x_p3494_lanes[5];
  const Lanes f13_x_p3507_lanes = f13_x_p3328_lanes * f13_x_p3322_lanes[5];
  const Lanes f13_x_p3511_lanes = f13_x_p3125_lanes * f13_x_p3118_lanes[5];
  const Lanes f13_x_p3515_lanes = f13_x_p2934_lanes * f13_x_p2926_lanes[5];
  const Lanes f13_x_p3519_lanes = f13_x_p2741_lanes * f13_x_p2732_lanes[5];
  const Lanes f13_x_p3523_lanes = f13_x_p1227_lanes * f13_x_p2462_lanes[5];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3527_lanes = f13_x_p2474_lanes * f13_x_p2374_lanes[5];

  // link 3 (hip), force propagation
  const Lanes f13_x_p3531_lanes = f13_x_p2482_lanes * f13_x_p2254_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3535_lanes = f13_x_p2490_lanes * f13_x_p2126;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3539_lanes = f13_x_p2498_lanes * f13_x_p2030_lanes[5];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3543_lanes = f13_x_p2506_lanes * f13_x_p1880_lanes[5];

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3547_lanes = f13_x_p3543_lanes + f13_x_p3539_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3551_lanes = f13_x_p3547_lanes + f13_x_p3535_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p3555_lanes = f13_x_p3551_lanes + f13_x_p3531_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3559_lanes = f13_x_p3555_lanes + f13_x_p3527_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p3563_lanes = f13_x_p3559_lanes + f13_x_p3523_lanes;
  const Lanes f13_x_p3567_lanes = f13_x_p3563_lanes - f13_x_p3519_lanes;
  const Lanes f13_x_p3571_lanes = f13_x_p3567_lanes - f13_x_p3515_lanes;
  const Lanes f13_x_p3575_lanes = f13_x_p3571_lanes - f13_x_p3511_lanes;
  const Lanes f13_x_p3579_lanes = f13_x_p3575_lanes - f13_x_p3507_lanes;
  const Lanes f13_x_p3583_lanes = f13_x_p3579_lanes - f13_x_p3503_lanes;
  const Lanes f13_x_p3587_lanes = f13_x_p3494_lanes * f13_x_p3498;
  const Lanes f13_x_p3590_lanes = f13_x_p3587_lanes * f13_x_p3494_lanes[5];
  const Lanes f13_x_p3593_lanes = f13_x_p3408_lanes * f13_x_p3322_lanes[5];
  const Lanes f13_x_p3596_lanes = f13_x_p3197_lanes * f13_x_p3118_lanes[5];
  const Lanes f13_x_p3599_lanes = f13_x_p2998_lanes * f13_x_p2926_lanes[5];
  const Lanes f13_x_p3602_lanes = f13_x_p2797_lanes * f13_x_p2732_lanes[5];
  const Lanes f13_x_p3605_lanes = f13_x_p2534_lanes * f13_x_p2462_lanes[5];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3608_lanes = f13_x_p2550_lanes * f13_x_p2374_lanes[5];

  // link 3 (hip), force propagation
  const Lanes f13_x_p3611_lanes = f13_x_p2566_lanes * f13_x_p2254_lanes[5];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3614_lanes = f13_x_p2582_lanes * f13_x_p2126;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3617_lanes = f13_x_p2598_lanes * f13_x_p2030_lanes[5];

  // link 9 (left_upperarm), force propagation
  const Real f13_x_p3620 = 1065.380700001509 + f13_x_p3263_lanes[5] * f13_x_p1267 +
      f13_x_p3257_lanes[5] * f13_x_p1269 + f13_x_p2664_lanes[5] * f13_x_p1308_lanes[5] +
      f13_x_p2652_lanes[5] * f13_x_p1348;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3621_lanes = detail::make_lanes<Real>(f13_x_p3620 + f13_x_p2640_lanes[5] *
      f13_x_p1518_lanes[5] + f13_x_p2628_lanes[5] * f13_x_p1573_lanes[5] + f13_x_p2616_lanes[5] *
      f13_x_p1880_lanes[5], f13_x_p3620 + f13_x_p2640_lanes[5] * f13_x_p1518_lanes[5] +
      f13_x_p2628_lanes[5] * f13_x_p1573_lanes[5] + f13_x_p2616_lanes[5] * f13_x_p1880_lanes[5],
      f13_x_p3620 + f13_x_p2640_lanes[5] * f13_x_p1518_lanes[5] + f13_x_p2628_lanes[5] *
      f13_x_p1573_lanes[5] + f13_x_p2616_lanes[5] * f13_x_p1880_lanes[5], f13_x_p3620 +
      f13_x_p2640_lanes[5] * f13_x_p1518_lanes[5] + f13_x_p2628_lanes[5] * f13_x_p1573_lanes[5] +
      f13_x_p2616_lanes[5] * f13_x_p1880_lanes[5], f13_x_p3620 + f13_x_p2640_lanes[5] *
      f13_x_p1518_lanes[5] + f13_x_p2628_lanes[5] * f13_x_p1573_lanes[5] + f13_x_p2616_lanes[5] *
      f13_x_p1880_lanes[5], f13_x_p3620 + f13_x_p2640_lanes[5] * f13_x_p1518_lanes[5] +
      f13_x_p2628_lanes[5] * f13_x_p1573_lanes[5] + f13_x_p2616_lanes[5] * f13_x_p1880_lanes[5],
      f13_x_p2615 * f13_x_p1880_lanes[5], f13_x_p2614 * f13_x_p1880_lanes[5]) + f13_x_p3617_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3624_lanes = f13_x_p3621_lanes + f13_x_p3614_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p3627_lanes = f13_x_p3624_lanes + f13_x_p3611_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3630_lanes = f13_x_p3627_lanes + f13_x_p3608_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p3633_lanes = f13_x_p3630_lanes + f13_x_p3605_lanes;
  const Lanes f13_x_p3636_lanes = f13_x_p3633_lanes - f13_x_p3602_lanes;
  const Lanes f13_x_p3639_lanes = f13_x_p3636_lanes - f13_x_p3599_lanes;
  const Lanes f13_x_p3642_lanes = f13_x_p3639_lanes - f13_x_p3596_lanes;
  const Lanes f13_x_p3645_lanes = f13_x_p3642_lanes - f13_x_p3593_lanes;
  const Lanes f13_x_p3648_lanes = f13_x_p3645_lanes - f13_x_p3590_lanes;
  const Real f13_x_p3651 = 1.0 / f13_x_p3648_lanes[5];
  const Lanes f13_x_p3652_lanes = f13_x_p3583_lanes * f13_x_p3651;
  const Lanes f13_x_p3656_lanes = f13_x_p3652_lanes * f13_x_p3648_lanes[6];
  const Lanes f13_x_p3660_lanes = f13_x_p3499_lanes * f13_x_p3494_lanes[6];
  const Lanes f13_x_p3664_lanes = f13_x_p3328_lanes * f13_x_p3322_lanes[6];
  const Lanes f13_x_p3668_lanes = f13_x_p3125_lanes * f13_x_p3118_lanes[6];
  const Lanes f13_x_p3672_lanes = f13_x_p2934_lanes * f13_x_p2926_lanes[6];
  const Lanes f13_x_p3676_lanes = f13_x_p2741_lanes * f13_x_p2732_lanes[6];
  const Lanes f13_x_p3680_lanes = f13_x_p1227_lanes * f13_x_p2462_lanes[6];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3684_lanes = f13_x_p2474_lanes * f13_x_p2374_lanes[6];

  // link 3 (hip), force propagation
  const Lanes f13_x_p3688_lanes = f13_x_p2482_lanes * f13_x_p2254_lanes[6];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3692_lanes = f13_x_p2490_lanes * f13_x_p2123;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3696_lanes = f13_x_p2498_lanes * f13_x_p2030_lanes[6];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3700_lanes = f13_x_p2506_lanes * f13_x_p1880_lanes[6];

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p3704_lanes = f13_x_p767_lanes * inverse_D14;
  const Lanes f13_x_p3708_lanes = f13_x_p3704_lanes * f13_x_p1266;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p3712_lanes = f13_x_p730_lanes * inverse_D15;
  const Lanes f13_x_p3716_lanes = f13_x_p3712_lanes * f13_x_p1263;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p3720_lanes = f13_x_p612_lanes * inverse_D16;
  const Lanes f13_x_p3724_lanes = f13_x_p3720_lanes * f13_x_p1255;

  // link 17 (right_lowerarm), force propagation
  const Lanes f13_x_p3728_lanes = detail::make_lanes<Real>(f13_x_p582, f13_x_p578_lanes[1],
      f13_x_p578_lanes[2], f13_x_p578_lanes[3], f13_x_p582, f13_x_p582, f13_x_p582, f13_x_p582) *
      inverse_D17;
  const Lanes f13_x_p3732_lanes = f13_x_p3728_lanes * f13_x_p1252;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p3736_lanes = f13_x_p3732_lanes + f13_x_p3724_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p3740_lanes = f13_x_p3736_lanes + f13_x_p3716_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p3744_lanes = f13_x_p3740_lanes + f13_x_p3708_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3748_lanes = f13_x_p3744_lanes + f13_x_p3700_lanes;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3752_lanes = f13_x_p3748_lanes + f13_x_p3696_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3756_lanes = f13_x_p3752_lanes + f13_x_p3692_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p3760_lanes = f13_x_p3756_lanes + f13_x_p3688_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3764_lanes = f13_x_p3760_lanes + f13_x_p3684_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p3768_lanes = f13_x_p3764_lanes + f13_x_p3680_lanes;
  const Lanes f13_x_p3772_lanes = f13_x_p3768_lanes - f13_x_p3676_lanes;
  const Lanes f13_x_p3776_lanes = f13_x_p3772_lanes - f13_x_p3672_lanes;
  const Lanes f13_x_p3780_lanes = f13_x_p3776_lanes - f13_x_p3668_lanes;
  const Lanes f13_x_p3784_lanes = f13_x_p3780_lanes - f13_x_p3664_lanes;
  const Lanes f13_x_p3788_lanes = f13_x_p3784_lanes - f13_x_p3660_lanes;
  const Lanes f13_x_p3792_lanes = f13_x_p3788_lanes - f13_x_p3656_lanes;
  const Real f13_x_p3796 = f13_x_p3648_lanes[6] * f13_x_p3651;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p3797 = f13_x_p1252 * inverse_D17 * f13_x_p1252 + f13_x_p1255 * inverse_D16 *
      f13_x_p1255 + f13_x_p1263 * inverse_D15 * f13_x_p1263;

  // link 4 (chest1), force propagation
  const Real f13_x_p3798 = f13_x_p3797 + f13_x_p1266 * inverse_D14 * f13_x_p1266 + f13_x_p2615 *
      f13_x_p1880_lanes[6] + f13_x_p2598_lanes[6] * f13_x_p2030_lanes[6] + f13_x_p2582_lanes[6] *
      f13_x_p2123;

  // link 1 (calf), force propagation
  const Real f13_x_p3799 = f13_x_p3798 + f13_x_p2566_lanes[6] * f13_x_p2254_lanes[6] +
      f13_x_p2550_lanes[6] * f13_x_p2374_lanes[6] + f13_x_p2534_lanes[6] * f13_x_p2462_lanes[6] -
      f13_x_p2797_lanes[6] * f13_x_p2732_lanes[6];
  const Real f13_x_p3800 = f13_x_p3799 - f13_x_p2998_lanes[6] * f13_x_p2926_lanes[6] -
      f13_x_p3197_lanes[6] * f13_x_p3118_lanes[6] - f13_x_p3408_lanes[6] * f13_x_p3322_lanes[6] -
      f13_x_p3587_lanes[6] * f13_x_p3494_lanes[6];
  const Real f13_x_p3801 = 1.0 / (f13_x_p3800 - f13_x_p3796 * f13_x_p3648_lanes[6]);
  const Lanes f13_x_p3802_lanes = f13_x_p3792_lanes * f13_x_p3801;
  const Real f13_x_p3806 = f13_x_p3648_lanes[7] * f13_x_p3651;

  // link 14 (right_shoulder1), force propagation
  const Real f13_x_p3807 = f13_x_p1248 * inverse_D14;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p3808 = f13_x_p1245 * inverse_D15;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p3809 = f13_x_p1237 * inverse_D16;

  // link 17 (right_lowerarm), force propagation
  const Real f13_x_p3810 = f13_x_p1234 * inverse_D17;

  // link 6 (chest3), force propagation
  const Real f13_x_p3811 = f13_x_p3810 * f13_x_p1252 + f13_x_p3809 * f13_x_p1255 + f13_x_p3808 *
      f13_x_p1263 + f13_x_p3807 * f13_x_p1266 + f13_x_p2614 * f13_x_p1880_lanes[6];

  // link 2 (thigh), force propagation
  const Real f13_x_p3812 = f13_x_p3811 + f13_x_p2598_lanes[7] * f13_x_p2030_lanes[6] +
      f13_x_p2582_lanes[7] * f13_x_p2123 + f13_x_p2566_lanes[7] * f13_x_p2254_lanes[6] +
      f13_x_p2550_lanes[7] * f13_x_p2374_lanes[6];

  // link 1 (calf), force propagation
  const Real f13_x_p3813 = f13_x_p3812 + f13_x_p2534_lanes[7] * f13_x_p2462_lanes[6] -
      f13_x_p2797_lanes[7] * f13_x_p2732_lanes[6] - f13_x_p2998_lanes[7] * f13_x_p2926_lanes[6] -
      f13_x_p3197_lanes[7] * f13_x_p3118_lanes[6];
  const Real f13_x_p3814 = f13_x_p3813 - f13_x_p3408_lanes[7] * f13_x_p3322_lanes[6] -
      f13_x_p3587_lanes[7] * f13_x_p3494_lanes[6] - f13_x_p3806 * f13_x_p3648_lanes[6];
  const Lanes f13_x_p3815_lanes = f13_x_p3802_lanes * f13_x_p3814;
  const Lanes f13_x_p3819_lanes = f13_x_p3652_lanes * f13_x_p3648_lanes[7];
  const Lanes f13_x_p3823_lanes = f13_x_p3499_lanes * f13_x_p3494_lanes[7];
  const Lanes f13_x_p3827_lanes = f13_x_p3328_lanes * f13_x_p3322_lanes[7];
  const Lanes f13_x_p3831_lanes = f13_x_p3125_lanes * f13_x_p3118_lanes[7];
  const Lanes f13_x_p3835_lanes = f13_x_p2934_lanes * f13_x_p2926_lanes[7];
  const Lanes f13_x_p3839_lanes = f13_x_p2741_lanes * f13_x_p2732_lanes[7];
  const Lanes f13_x_p3843_lanes = f13_x_p1227_lanes * f13_x_p2462_lanes[7];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3847_lanes = f13_x_p2474_lanes * f13_x_p2374_lanes[7];

  // link 3 (hip), force propagation
  const Lanes f13_x_p3851_lanes = f13_x_p2482_lanes * f13_x_p2254_lanes[7];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3855_lanes = f13_x_p2490_lanes * f13_x_p2120;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3859_lanes = f13_x_p2498_lanes * f13_x_p2030_lanes[7];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3863_lanes = f13_x_p2506_lanes * f13_x_p1880_lanes[7];

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p3867_lanes = f13_x_p3704_lanes * f13_x_p1248;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p3871_lanes = f13_x_p3712_lanes * f13_x_p1245;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p3875_lanes = f13_x_p3720_lanes * f13_x_p1237;

  // link 17 (right_lowerarm), force propagation
  const Lanes f13_x_p3879_lanes = f13_x_p3728_lanes * f13_x_p1234;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p3883_lanes = f13_x_p3879_lanes + f13_x_p3875_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p3887_lanes = f13_x_p3883_lanes + f13_x_p3871_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p3891_lanes = f13_x_p3887_lanes + f13_x_p3867_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p3895_lanes = f13_x_p3891_lanes + f13_x_p3863_lanes;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p3899_lanes = f13_x_p3895_lanes + f13_x_p3859_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p3903_lanes = f13_x_p3899_lanes + f13_x_p3855_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p3907_lanes = f13_x_p3903_lanes + f13_x_p3851_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3911_lanes = f13_x_p3907_lanes + f13_x_p3847_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p3915_lanes = f13_x_p3911_lanes + f13_x_p3843_lanes;
  const Lanes f13_x_p3919_lanes = f13_x_p3915_lanes - f13_x_p3839_lanes;
  const Lanes f13_x_p3923_lanes = f13_x_p3919_lanes - f13_x_p3835_lanes;
  const Lanes f13_x_p3927_lanes = f13_x_p3923_lanes - f13_x_p3831_lanes;
  const Lanes f13_x_p3931_lanes = f13_x_p3927_lanes - f13_x_p3827_lanes;
  const Lanes f13_x_p3935_lanes = f13_x_p3931_lanes - f13_x_p3823_lanes;
  const Lanes f13_x_p3939_lanes = f13_x_p3935_lanes - f13_x_p3819_lanes;
  const Lanes f13_x_p3943_lanes = f13_x_p3939_lanes - f13_x_p3815_lanes;
  const Real f13_x_p3947 = f13_x_p3814 * f13_x_p3801;

  // link 6 (chest3), force propagation
  const Real f13_x_p3948 = f13_x_p3810 * f13_x_p1234 + f13_x_p3809 * f13_x_p1237 + f13_x_p3808 *
      f13_x_p1245 + f13_x_p3807 * f13_x_p1248 + f13_x_p2614 * f13_x_p1880_lanes[7];

  // link 2 (thigh), force propagation
  const Real f13_x_p3949 = f13_x_p3948 + f13_x_p2598_lanes[7] * f13_x_p2030_lanes[7] +
      f13_x_p2582_lanes[7] * f13_x_p2120 + f13_x_p2566_lanes[7] * f13_x_p2254_lanes[7] +
      f13_x_p2550_lanes[7] * f13_x_p2374_lanes[7];

  // link 1 (calf), force propagation
  const Real f13_x_p3950 = f13_x_p3949 + f13_x_p2534_lanes[7] * f13_x_p2462_lanes[7] -
      f13_x_p2797_lanes[7] * f13_x_p2732_lanes[7] - f13_x_p2998_lanes[7] * f13_x_p2926_lanes[7] -
      f13_x_p3197_lanes[7] * f13_x_p3118_lanes[7];
  const Real f13_x_p3951 = f13_x_p3950 - f13_x_p3408_lanes[7] * f13_x_p3322_lanes[7] -
      f13_x_p3587_lanes[7] * f13_x_p3494_lanes[7] - f13_x_p3806 * f13_x_p3648_lanes[7] -
      f13_x_p3947 * f13_x_p3814;
  const Real f13_x_p3952 = 1.0 / f13_x_p3951;
  const Lanes f13_x_p3953_lanes = f13_x_p3943_lanes * f13_x_p3952;
  const Lanes f13_x_p3957_lanes = f13_x_p3953_lanes * f13_x_p3943_lanes[0];
  const Lanes f13_x_p3961_lanes = f13_x_p3802_lanes * f13_x_p3792_lanes[0];
  const Lanes f13_x_p3965_lanes = f13_x_p3652_lanes * f13_x_p3583_lanes[0];
  const Lanes f13_x_p3969_lanes = f13_x_p3499_lanes * f13_x_p3404_lanes[0];
  const Lanes f13_x_p3973_lanes = f13_x_p3328_lanes * f13_x_p3193_lanes[0];
  const Lanes f13_x_p3977_lanes = f13_x_p3125_lanes * f13_x_p2994_lanes[0];
  const Lanes f13_x_p3981_lanes = f13_x_p2934_lanes * f13_x_p2793_lanes[0];
  const Lanes f13_x_p3985_lanes = f13_x_p2741_lanes * f13_x_p2530_lanes[0];
  const Lanes f13_x_p3989_lanes = f13_x_p1227_lanes * f13_x_p1223_lanes[0];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p3993_lanes = f13_x_p2474_lanes * f13_x_p1176_lanes[0];

  // link 3 (hip), force propagation
  const Lanes f13_x_p3997_lanes = f13_x_p2482_lanes * f13_x_p1116_lanes[0];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p4001_lanes = f13_x_p2490_lanes * f13_x_p1059;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p4005_lanes = f13_x_p2498_lanes * f13_x_p1004_lanes[0];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p4009_lanes = f13_x_p2506_lanes * f13_x_p944_lanes[0];

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p4013_lanes = f13_x_p3704_lanes * f13_x_p767_lanes[0];

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p4017_lanes = f13_x_p3712_lanes * f13_x_p730_lanes[0];

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p4021_lanes = f13_x_p3720_lanes * f13_x_p612_lanes[0];

  // link 17 (right_lowerarm), force propagation
  const Lanes f13_x_p4025_lanes = f13_x_p3728_lanes * f13_x_p582;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p4029_lanes = f13_x_p4025_lanes + f13_x_p4021_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p4033_lanes = f13_x_p4029_lanes + f13_x_p4017_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p4037_lanes = f13_x_p4033_lanes + f13_x_p4013_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p4041_lanes = f13_x_p4037_lanes + f13_x_p4009_lanes;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p4045_lanes = f13_x_p4041_lanes + f13_x_p4005_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p4049_lanes = f13_x_p4045_lanes + f13_x_p4001_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p4053_lanes = f13_x_p4049_lanes + f13_x_p3997_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p4057_lanes = f13_x_p4053_lanes + f13_x_p3993_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p4061_lanes = f13_x_p4057_lanes + f13_x_p3989_lanes;
  const Lanes f13_x_p4065_lanes = f13_x_p4061_lanes - f13_x_p3985_lanes;
  const Lanes f13_x_p4069_lanes = f13_x_p4065_lanes - f13_x_p3981_lanes;
  const Lanes f13_x_p4073_lanes = f13_x_p4069_lanes - f13_x_p3977_lanes;
  const Lanes f13_x_p4077_lanes = f13_x_p4073_lanes - f13_x_p3973_lanes;
  const Lanes f13_x_p4081_lanes = f13_x_p4077_lanes - f13_x_p3969_lanes;
  const Lanes f13_x_p4085_lanes = f13_x_p4081_lanes - f13_x_p3965_lanes;
  const Lanes f13_x_p4089_lanes = f13_x_p4085_lanes - f13_x_p3961_lanes;
  const Lanes f13_x_p4093_lanes = f13_x_p4089_lanes - f13_x_p3957_lanes;
  const Real f13_x_p4097 = 1.0 / f13_x_p4093_lanes[0];
  const Lanes f13_x_p4098_lanes = f13_x_p4093_lanes * f13_x_p4097;
  const Lanes f13_x_p4101_lanes = f13_x_p4098_lanes * f13_x_p4093_lanes[1];
  const Lanes f13_x_p4104_lanes = f13_x_p3953_lanes * f13_x_p3943_lanes[1];
  const Lanes f13_x_p4107_lanes = f13_x_p3802_lanes * f13_x_p3792_lanes[1];
  const Lanes f13_x_p4110_lanes = f13_x_p3652_lanes * f13_x_p3583_lanes[1];
  const Lanes f13_x_p4113_lanes = f13_x_p3499_lanes * f13_x_p3404_lanes[1];
  const Lanes f13_x_p4116_lanes = f13_x_p3328_lanes * f13_x_p3193_lanes[1];
  const Lanes f13_x_p4119_lanes = f13_x_p3125_lanes * f13_x_p2994_lanes[1];
  const Lanes f13_x_p4122_lanes = f13_x_p2934_lanes * f13_x_p2793_lanes[1];
  const Lanes f13_x_p4125_lanes = f13_x_p2741_lanes * f13_x_p2530_lanes[1];
  const Lanes f13_x_p4128_lanes = f13_x_p1227_lanes * f13_x_p1223_lanes[1];

  // link 2 (thigh), force propagation
  const Lanes f13_x_p4131_lanes = f13_x_p2474_lanes * f13_x_p1176_lanes[1];

  // link 3 (hip), force propagation
  const Lanes f13_x_p4134_lanes = f13_x_p2482_lanes * f13_x_p1116_lanes[1];

  // link 4 (chest1), force propagation
  const Lanes f13_x_p4137_lanes = f13_x_p2490_lanes * f13_x_p1056;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p4140_lanes = f13_x_p2498_lanes * f13_x_p1004_lanes[1];

  // link 6 (chest3), force propagation
  const Lanes f13_x_p4143_lanes = f13_x_p2506_lanes * f13_x_p944_lanes[1];

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p4146_lanes = f13_x_p3704_lanes * f13_x_p767_lanes[1];

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p4149_lanes = f13_x_p3712_lanes * f13_x_p730_lanes[1];

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p4152_lanes = f13_x_p3720_lanes * f13_x_p612_lanes[1];

  // link 17 (right_lowerarm), force propagation
  const Lanes f13_x_p4155_lanes = f13_x_p3728_lanes * f13_x_p578_lanes[1];

  // link 18 (right_wrist1), force propagation
  const Lanes f13_x_p4158_lanes = detail::make_lanes<Real>(f13_x_p544, f13_x_p544, f13_x_p542,
      f13_x_p540, f13_x_p544, f13_x_p544, f13_x_p544, f13_x_p544) * inverse_D18;
  const Lanes f13_x_p4161_lanes = f13_x_p4158_lanes * f13_x_p544;

  // link 19 (right_wrist2), force propagation
  const Lanes f13_x_p4164_lanes = detail::make_lanes<Real>(s20, s20, c20, f13_x_p538, s20, s20, s20,
      s20) * inverse_D19;
  const Lanes f13_x_p4167_lanes = f13_x_p4164_lanes * s20;

  // link 18 (right_wrist1), force propagation
  const Lanes f13_x_p4170_lanes = f13_x_p4167_lanes + f13_x_p4161_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes f13_x_p4173_lanes = f13_x_p4170_lanes + f13_x_p4155_lanes;

  // link 16 (right_upperarm), force propagation
  const Lanes f13_x_p4176_lanes = f13_x_p4173_lanes + f13_x_p4152_lanes;

  // link 15 (right_shoulder2), force propagation
  const Lanes f13_x_p4179_lanes = f13_x_p4176_lanes + f13_x_p4149_lanes;

  // link 14 (right_shoulder1), force propagation
  const Lanes f13_x_p4182_lanes = f13_x_p4179_lanes + f13_x_p4146_lanes;

  // link 6 (chest3), force propagation
  const Lanes f13_x_p4185_lanes = f13_x_p4182_lanes + f13_x_p4143_lanes;

  // link 5 (chest2), force propagation
  const Lanes f13_x_p4188_lanes = f13_x_p4185_lanes + f13_x_p4140_lanes;

  // link 4 (chest1), force propagation
  const Lanes f13_x_p4191_lanes = f13_x_p4188_lanes + f13_x_p4137_lanes;

  // link 3 (hip), force propagation
  const Lanes f13_x_p4194_lanes = f13_x_p4191_lanes + f13_x_p4134_lanes;

  // link 2 (thigh), force propagation
  const Lanes f13_x_p4197_lanes = f13_x_p4194_lanes + f13_x_p4131_lanes;

  // link 1 (calf), force propagation
  const Lanes f13_x_p4200_lanes = f13_x_p4197_lanes + f13_x_p4128_lanes;
  const Lanes f13_x_p4203_lanes = f13_x_p4200_lanes - f13_x_p4125_lanes;
  const Lanes f13_x_p4206_lanes = f13_x_p4203_lanes - f13_x_p4122_lanes;
  const Lanes f13_x_p4209_lanes = f13_x_p4206_lanes - f13_x_p4119_lanes;
  const Lanes f13_x_p4212_lanes = f13_x_p4209_lanes - f13_x_p4116_lanes;
  const Lanes f13_x_p4215_lanes = f13_x_p4212_lanes - f13_x_p4113_lanes;
  const Lanes f13_x_p4218_lanes = f13_x_p4215_lanes - f13_x_p4110_lanes;
  const Lanes f13_x_p4221_lanes = f13_x_p4218_lanes - f13_x_p4107_lanes;
  const Lanes f13_x_p4224_lanes = f13_x_p4221_lanes - f13_x_p4104_lanes;
  const Lanes f13_x_p4227_lanes = f13_x_p4224_lanes - f13_x_p4101_lanes;
  const Real f13_x_p4230 = 1.0 / f13_x_p4227_lanes[1];
  const Real f13_x_p4231 = f13_x_p4227_lanes[3] * f13_x_p4230;

  // link 19 (right_wrist2), force propagation
  const Lanes f13_x_p4232_lanes = f13_x_p4164_lanes * c20;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p4234 = f13_x_p4232_lanes[3] + f13_x_p4158_lanes[3] * f13_x_p542 +
      f13_x_p3728_lanes[3] * f13_x_p578_lanes[2] + f13_x_p3720_lanes[3] * f13_x_p612_lanes[2] +
      f13_x_p3712_lanes[3] * f13_x_p730_lanes[2];

  // link 4 (chest1), force propagation
  const Real f13_x_p4235 = f13_x_p4234 + f13_x_p3704_lanes[3] * f13_x_p767_lanes[2] +
      f13_x_p2506_lanes[3] * f13_x_p944_lanes[2] + f13_x_p2498_lanes[3] * f13_x_p1004_lanes[2] +
      f13_x_p2490_lanes[3] * f13_x_p1053;

  // link 1 (calf), force propagation
  const Real f13_x_p4236 = f13_x_p4235 + f13_x_p2482_lanes[3] * f13_x_p1116_lanes[2] +
      f13_x_p2474_lanes[3] * f13_x_p1176_lanes[2] + f13_x_p1227_lanes[3] * f13_x_p1223_lanes[2] -
      f13_x_p2741_lanes[3] * f13_x_p2530_lanes[2];
  const Real f13_x_p4237 = f13_x_p4236 - f13_x_p2934_lanes[3] * f13_x_p2793_lanes[2] -
      f13_x_p3125_lanes[3] * f13_x_p2994_lanes[2] - f13_x_p3328_lanes[3] * f13_x_p3193_lanes[2] -
      f13_x_p3499_lanes[3] * f13_x_p3404_lanes[2];
  const Real f13_x_p4238 = f13_x_p4237 - f13_x_p3652_lanes[3] * f13_x_p3583_lanes[2] -
      f13_x_p3802_lanes[3] * f13_x_p3792_lanes[2] - f13_x_p3953_lanes[3] * f13_x_p3943_lanes[2] -
      f13_x_p4098_lanes[3] * f13_x_p4093_lanes[2];
  const Real f13_x_p4239 = f13_x_p4238 - f13_x_p4231 * f13_x_p4227_lanes[2];
  const Real f13_x_p4240 = f13_x_p4227_lanes[2] * f13_x_p4230;

  // link 15 (right_shoulder2), force propagation
  const Real f13_x_p4241 = f13_x_p4232_lanes[2] + f13_x_p4158_lanes[2] * f13_x_p542 +
      f13_x_p3728_lanes[2] * f13_x_p578_lanes[2] + f13_x_p3720_lanes[2] * f13_x_p612_lanes[2] +
      f13_x_p3712_lanes[2] * f13_x_p730_lanes[2];

  // link 4 (chest1), force propagation
  const Real f13_x_p4242 = f13_x_p4241 + f13_x_p3704_lanes[2] * f13_x_p767_lanes[2] +
      f13_x_p2506_lanes[2] * f13_x_p944_lanes[2] + f13_x_p2498_lanes[2] * f13_x_p1004_lanes[2] +
      f13_x_p2490_lanes[2] * f13_x_p1053;

  // link 1 (calf), force propagation
  const Real f13_x_p4243 = f13_x_p4242 + f13_x_p2482_lanes[2] * f13_x_p1116_lanes[2] +
      f13_x_p2474_lanes[2] * f13_x_p1176_lanes[2] + f13_x_p1227_lanes[2] * f13_x_p1223_lanes[2] -
      f13_x_p2741_lanes[2] * f13_x_p2530_lanes[2];
  const Real f13_x_p4244 = f13_x_p4243 - f13_x_p2934_lanes[2] * f13_x_p2793_lanes[2] -
      f13_x_p3125_lanes[2] * f13_x_p2994_lanes[2] - f13_x_p3328_lanes[2] * f13_x_p3193_lanes[2] -
      f13_x_p3499_lanes[2] * f13_x_p3404_lanes[2];
  const Real f13_x_p4245 = f13_x_p4244 - f13_x_p3652_lanes[2] * f13_x_p3583_lanes[2] -
      f13_x_p3802_lanes[2] * f13_x_p3792_lanes[2] - f13_x_p3953_lanes[2] * f13_x_p3943_lanes[2] -
      f13_x_p4098_lanes[2] * f13_x_p4093_lanes[2];
  const Real f13_x_p4246 = 1.0 / (f13_x_p4245 - f13_x_p4240 * f13_x_p4227_lanes[2]);
  const Real f13_x_p4247 = f13_x_p4239 * f13_x_p4246;

  // link 24 (right_eye), outward
  const Real f13_x_p4248 = 9.81 + xdd_cmd[2];
  const Real f13_x_p4249 = c1 * xdd_cmd[0] - s1 * f13_x_p4248;
  const Real f13_x_p4250 = s1 * xdd_cmd[0] + c1 * f13_x_p4248;
  const Real f13_x_p4251 = c2 * f13_x_p4249 - s2 * f13_x_p4250;
  const Real f13_x_p4252 = s2 * f13_x_p4249 + c2 * f13_x_p4250;
  const Real f13_x_p4253 = c3 * f13_x_p4251 - s3 * f13_x_p4252;
  const Real f13_x_p4254 = c4 * f13_x_p4253 + s4 * xdd_cmd[1];
  const Real f13_x_p4255 = s3 * f13_x_p4251 + c3 * f13_x_p4252;
  const Real f13_x_p4256 = s5 * f13_x_p4254 + c5 * f13_x_p4255;
  const Real f13_x_p4257 = c4 * xdd_cmd[1] - s4 * f13_x_p4253;
  const Real f13_x_p4258 = s6 * f13_x_p4257 - c6 * f13_x_p4256;
  const Real f13_x_p4259 = c5 * f13_x_p4254 - s5 * f13_x_p4255;
  const Real f13_x_p4260 = c7 * f13_x_p4258 - s7 * f13_x_p4259;
  const Real f13_x_p4261 = s6 * f13_x_p4256 + c6 * f13_x_p4257;
  const Real f13_x_p4262 = c8 * f13_x_p4261 - s8 * f13_x_p4260;
  const Real f13_x_p4263 = s7 * f13_x_p4258 + c7 * f13_x_p4259;
  const Real f13_x_p4264 = s9 * f13_x_p4262 + c9 * f13_x_p4263;
  const Real f13_x_p4265 = c8 * f13_x_p4260 + s8 * f13_x_p4261;
  const Real f13_x_p4266 = c10 * f13_x_p4264 + s10 * f13_x_p4265;
  const Real f13_x_p4267 = c9 * f13_x_p4262 - s9 * f13_x_p4263;
  const Real f13_x_p4268 = c11 * f13_x_p4266 + s11 * f13_x_p4267;
  const Real f13_x_p4269 = c10 * f13_x_p4265 - s10 * f13_x_p4264;
  const Real f13_x_p4270 = c12 * f13_x_p4269 - s12 * f13_x_p4268;
  const Real f13_x_p4271 = c11 * f13_x_p4267 - s11 * f13_x_p4266;

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;

  // link 2 (thigh), outward
  const Real a2_y_p1 = 0.434 * (qd[0] * qd[0]) - minus_a1_y;

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;

  // link 2 (thigh), outward
  const Real a2_y_p2 = 0.434 * qdd_0[0] - minus_a1_x;
  const Real a2_y = c2 * a2_y_p1 - s2 * a2_y_p2;
  const Real w2_z = qd[0] + qd[1];
  const Real a3_y_p1 = w2_z * w2_z;

  // link 3 (hip), outward
  const Real a3_y_p2 = a2_y + 0.422 * a3_y_p1;

  // link 2 (thigh), outward
  const Real a2_x = c2 * a2_y_p2 + s2 * a2_y_p1;
  const Real wd2_z = qdd_0[0] + qdd_0[1];

  // link 3 (hip), outward
  const Real a3_y_p3 = a2_x + 0.422 * wd2_z;
  const Real a3_y = c3 * a3_y_p2 - s3 * a3_y_p3;
  const Real w3_z = w2_z + qd[2];

  // link 4 (chest1), outward
  const Real w4_x = s4 * w3_z;
  const Real a5_y_p1 = w4_x * w4_x;
  const Real w4_y = c4 * w3_z;
  const Real a5_y_p2 = w4_y * w4_y;

  // link 5 (chest2), outward
  const Real a5_y_p3 = a3_y + 0.21799999999999997 * (a5_y_p1 + a5_y_p2);

  // link 3 (hip), outward
  const Real a3_x = c3 * a3_y_p3 + s3 * a3_y_p2;

  // link 4 (chest1), outward
  const Real a4_x = c4 * a3_x;

  // link 3 (hip), outward
  const Real wd3_z = wd2_z + qdd_0[2];

  // link 4 (chest1), outward
  const Real a5_y_p4 = c4 * wd3_z;

  // link 5 (chest2), outward
  const Real a5_y_p5 = a4_x + 0.21799999999999997 * a5_y_p4;
  const Real a5_y = c5 * a5_y_p3 - s5 * a5_y_p5;
  const Real w5_x = c5 * w4_x - s5 * qd[3];
  const Real a6_x_p1 = w5_x * w5_x;
  const Real w5_z = w4_y + qd[4];
  const Real a6_x_p2 = w5_z * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p3 = a6_x_p1 + a6_x_p2;
  const Real a6_x_p4 = a5_y + 0.072 * a6_x_p3;

  // link 4 (chest1), outward
  const Real minus_a4_y = s4 * a3_x;
  const Real minus_a5_z_p1 = s4 * wd3_z;

  // link 5 (chest2), outward
  const Real minus_a5_z = minus_a4_y + 0.21799999999999997 * minus_a5_z_p1;

  // link 4 (chest1), outward
  const Real wd4_x_p1 = w4_y * qd[3];
  const Real wd4_x = minus_a5_z_p1 + wd4_x_p1;

  // link 5 (chest2), outward
  const Real minus_w5_y = s5 * w4_x + c5 * qd[3];
  const Real wd5_x = c5 * wd4_x - s5 * qdd_0[3] - minus_w5_y * qd[4];
  const Real a6_x_p5 = wd5_x - minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p6 = minus_a5_z + 0.072 * a6_x_p5;
  const Real a6_x = c6 * a6_x_p4 - s6 * a6_x_p6;
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_z = w5_x + qd[5];
  const Real a7_x_p1 = w6_z * w6_z;

  // link 7 (left_shoulder1), outward
  const Real a7_x_p2 = w6_y * w6_y + a7_x_p1;

  // link 14 (right_shoulder1), outward
  const Real a7_x_p3 = a6_x + 0.226 * a7_x_p2;

  // link 6 (chest3), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real a7_x_p4 = w6_x * w6_y;
  const Real wd6_z = wd5_x + qdd_0[5];

  // link 7 (left_shoulder1), outward
  const Real a7_x_p5 = 0.18 * (a7_x_p4 - wd6_z);
  const Real a7_x_p6 = a7_x_p3 + a7_x_p5;

  // link 5 (chest2), outward
  const Real a5_x = c5 * a5_y_p5 + s5 * a5_y_p3;
  const Real a6_z_p1 = w5_x * minus_w5_y;

  // link 4 (chest1), outward
  const Real wd4_y_p1 = w4_x * qd[3];
  const Real wd4_y = a5_y_p4 - wd4_y_p1;

  // link 5 (chest2), outward
  const Real wd5_z = wd4_y + qdd_0[4];
  const Real a6_z_p2 = a6_z_p1 + wd5_z;

  // link 6 (chest3), outward
  const Real a6_z = a5_x + 0.072 * a6_z_p2;

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * wd4_x + c5 * qdd_0[3] + w5_x * qd[4];

  // link 6 (chest3), outward
  const Real wd6_y = s6 * minus_wd5_y + c6 * wd5_z - w6_x * qd[5];
  const Real a7_x_p7 = w6_x * w6_z - wd6_y;

  // link 14 (right_shoulder1), outward
  const Real a7_x_p8 = a6_z - 0.226 * a7_x_p7;

  // link 6 (chest3), outward
  const Real a7_x_p9 = w6_y * w6_z;
  const Real wd6_x = s6 * wd5_z - c6 * minus_wd5_y + w6_y * qd[5];
  const Real a7_x_p10 = a7_x_p9 + wd6_x;

  // link 7 (left_shoulder1), outward
  const Real a7_x_p11 = 0.18 * a7_x_p10;
  const Real a7_x_p12 = a7_x_p8 + a7_x_p11;
  const Real a7_x = s7 * a7_x_p6 + c7 * a7_x_p12;
  const Real a7_y = c7 * a7_x_p6 - s7 * a7_x_p12;

  // link 6 (chest3), outward
  const Real minus_a6_y = s6 * a6_x_p4 + c6 * a6_x_p6;
  const Real minus_a7_z_p1 = a7_x_p4 + wd6_z;

  // link 14 (right_shoulder1), outward
  const Real minus_a7_z_p2 = minus_a6_y + 0.226 * minus_a7_z_p1;

  // link 6 (chest3), outward
  const Real minus_a7_z_p3 = w6_x * w6_x;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_z_p4 = 0.18 * (minus_a7_z_p3 + a7_x_p1);
  const Real minus_a7_z = minus_a7_z_p2 + minus_a7_z_p4;

  // link 8 (left_shoulder2), outward
  const Real minus_a8_y = s8 * a7_y + c8 * minus_a7_z;

  // link 9 (left_upperarm), outward
  const Real a9_x = c9 * a7_x - s9 * minus_a8_y;

  // link 7 (left_shoulder1), outward
  const Real w7_x = s7 * w6_x + c7 * w6_z;
  const Real wd7_y = c7 * wd6_x - s7 * wd6_z - w7_x * qd[6];
  const Real wd7_z = wd6_y + qdd_0[6];
  const Real w7_y = c7 * w6_x - s7 * w6_z;
  const Real w7_z = w6_y + qd[6];

  // link 8 (left_shoulder2), outward
  const Real w8_x = c8 * w7_y + s8 * w7_z;
  const Real wd8_y = c8 * wd7_z - s8 * wd7_y - w8_x * qd[7];

  // link 7 (left_shoulder1), outward
  const Real wd7_x = s7 * wd6_x + c7 * wd6_z + w7_y * qd[6];

  // link 8 (left_shoulder2), outward
  const Real wd8_z = wd7_x + qdd_0[7];
  const Real w8_y = c8 * w7_z - s8 * w7_y;
  const Real w8_z = w7_x + qd[7];

  // link 9 (left_upperarm), outward
  const Real w9_x = s9 * w8_y + c9 * w8_z;
  const Real wd9_y = c9 * wd8_y - s9 * wd8_z - w9_x * qd[8];
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
  const Real wd9_x = s9 * wd8_y + c9 * wd8_z + w9_y * qd[8];
  const Real minus_a10_z_p1 = w9_y * w9_z;
  const Real minus_a10_z_p2 = minus_a10_z_p1 - wd9_x;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_z = minus_a9_y + 0.282 * minus_a10_z_p2;

  // link 11 (left_wrist1), outward
  const Real a11_x = c11 * a10_x - s11 * minus_a10_z;

  // link 10 (left_lowerarm), outward
  const Real wd10_z = wd9_y + qdd_0[9];

  // link 8 (left_shoulder2), outward
  const Real wd8_x = c8 * wd7_y + s8 * wd7_z + w8_y * qd[7];

  // link 9 (left_upperarm), outward
  const Real wd9_z = qdd_0[8] - wd8_x;

  // link 10 (left_lowerarm), outward
  const Real minus_w10_y = s10 * w9_x + c10 * w9_z;
  const Real wd10_x = c10 * wd9_x - s10 * wd9_z - minus_w10_y * qd[9];
  const Real w10_x = c10 * w9_x - s10 * w9_z;
  const Real w10_z = w9_y + qd[9];

  // link 11 (left_wrist1), outward
  const Real w11_x = c11 * w10_x + s11 * w10_z;
  const Real wd11_y = c11 * wd10_z - s11 * wd10_x - w11_x * qd[10];
  const Real w11_z = minus_w10_y + qd[10];
  const Real minus_a12_y_p1 = w11_x * w11_z;
  const Real minus_a12_y_p2 = minus_a12_y_p1 + wd11_y;

  // link 12 (left_wrist2), outward
  const Real minus_a12_y_p3 = a11_x - 0.269 * minus_a12_y_p2;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_y = s10 * a10_x_p3 + c10 * a10_x_p6;

  // link 11 (left_wrist1), outward
  const Real minus_a12_y_p4 = w11_x * w11_x;
  const Real w11_y = c11 * w10_z - s11 * w10_x;
  const Real minus_a12_y_p5 = w11_y * w11_y;

  // link 12 (left_wrist2), outward
  const Real minus_a12_y_p6 = minus_a10_y + 0.269 * (minus_a12_y_p4 + minus_a12_y_p5);
  const Real minus_a12_y = s12 * minus_a12_y_p3 + c12 * minus_a12_y_p6;

  // link 11 (left_wrist1), outward
  const Real minus_a11_y = s11 * a10_x + c11 * minus_a10_z;
  const Real wd11_x = c11 * wd10_x + s11 * wd10_z + w11_y * qd[10];
  const Real minus_a12_z_p1 = w11_y * w11_z;
  const Real minus_a12_z_p2 = minus_a12_z_p1 - wd11_x;

  // link 12 (left_wrist2), outward
  const Real minus_a12_z = minus_a11_y + 0.269 * minus_a12_z_p2;

  // link 13 (left_hand), outward
  const Real minus_a13_x = c13 * minus_a12_y + s13 * minus_a12_z;

  // link 12 (left_wrist2), outward
  const Real minus_w12_y = s12 * w11_x + c12 * w11_z;
  const Real w12_z = w11_y + qd[11];

  // link 13 (left_hand), outward
  const Real w13_y = s13 * minus_w12_y + c13 * w12_z;
  const Real f13_x_p4272 = w13_y * w13_y;

  // link 12 (left_wrist2), outward
  const Real w12_x = c12 * w11_x - s12 * w11_z;

  // link 13 (left_hand), outward
  const Real w13_z = w12_x + qd[12];
  const Real f13_x_p4273 = w13_z * w13_z;

  // link 24 (right_eye), outward
  const Real f13_x_p4274 = f13_x_p4272 + f13_x_p4273;
  const Real f13_x_p4275 = c13 * f13_x_p4270 + s13 * f13_x_p4271 +
      (minus_a13_x + 0.086 * f13_x_p4274);

  // link 13 (left_hand), outward
  const Real a13_y = s13 * minus_a12_y - c13 * minus_a12_z;

  // link 24 (right_eye), outward
  const Real f13_x_p4276 = c1 * xdd_cmd[3] - s1 * xdd_cmd[5];
  const Real f13_x_p4277 = s1 * xdd_cmd[3] + c1 * xdd_cmd[5];
  const Real f13_x_p4278 = c2 * f13_x_p4276 - s2 * f13_x_p4277;
  const Real f13_x_p4279 = s2 * f13_x_p4276 + c2 * f13_x_p4277;
  const Real f13_x_p4280 = c3 * f13_x_p4278 - s3 * f13_x_p4279;
  const Real f13_x_p4281 = c4 * f13_x_p4280 + s4 * xdd_cmd[4];
  const Real f13_x_p4282 = s3 * f13_x_p4278 + c3 * f13_x_p4279;
  const Real f13_x_p4283 = s5 * f13_x_p4281 + c5 * f13_x_p4282;
  const Real f13_x_p4284 = c4 * xdd_cmd[4] - s4 * f13_x_p4280;
  const Real f13_x_p4285 = s6 * f13_x_p4284 - c6 * f13_x_p4283;
  const Real f13_x_p4286 = c5 * f13_x_p4281 - s5 * f13_x_p4282;
  const Real f13_x_p4287 = c7 * f13_x_p4285 - s7 * f13_x_p4286;
  const Real f13_x_p4288 = s6 * f13_x_p4283 + c6 * f13_x_p4284;
  const Real f13_x_p4289 = c8 * f13_x_p4288 - s8 * f13_x_p4287;
  const Real f13_x_p4290 = s7 * f13_x_p4285 + c7 * f13_x_p4286;
  const Real f13_x_p4291 = s9 * f13_x_p4289 + c9 * f13_x_p4290;
  const Real f13_x_p4292 = c8 * f13_x_p4287 + s8 * f13_x_p4288;
  const Real f13_x_p4293 = c10 * f13_x_p4291 + s10 * f13_x_p4292;
  const Real f13_x_p4294 = c9 * f13_x_p4289 - s9 * f13_x_p4290;
  const Real f13_x_p4295 = c11 * f13_x_p4293 + s11 * f13_x_p4294;
  const Real f13_x_p4296 = c10 * f13_x_p4292 - s10 * f13_x_p4291;
  const Real f13_x_p4297 = c12 * f13_x_p4295 + s12 * f13_x_p4296;

  // link 13 (left_hand), outward
  const Real w13_x = s13 * w12_z - c13 * minus_w12_y;
  const Real f13_x_p4298 = w13_x * w13_y;

  // link 1 (calf), force propagation
  const Real f13_x_p4299 = c13 * f13_x_p4271 - s13 * f13_x_p4270 - a13_y - f13_x_p2797_lanes[1] *
      f13_x_p4275 - 0.086 * (f13_x_p4298 + f13_x_p4297);

  // link 12 (left_wrist2), outward
  const Real a12_x = c12 * minus_a12_y_p3 - s12 * minus_a12_y_p6;

  // link 1 (calf), force propagation
  const Real f13_x_p4300 = c12 * f13_x_p4268 + s12 * f13_x_p4269 - a12_x - f13_x_p2797_lanes[2] *
      f13_x_p4275 - f13_x_p2998_lanes[2] * f13_x_p4299;

  // link 24 (right_eye), outward
  const Real f13_x_p4301 = c11 * f13_x_p4294 - s11 * f13_x_p4293;
  const Real f13_x_p4302 = c12 * f13_x_p4296 - s12 * f13_x_p4295;
  const Real f13_x_p4303 = c13 * f13_x_p4301 - s13 * f13_x_p4302;

  // link 13 (left_hand), outward
  const Real f13_x_p4304 = w13_x * w13_z;

  // link 1 (calf), force propagation
  const Real f13_x_p4305 = f13_x_p4300 + 0.086 * (f13_x_p4303 - f13_x_p4304);

  // link 12 (left_wrist2), outward
  const Real wd12_z = wd11_y + qdd_0[11];

  // link 10 (left_lowerarm), outward
  const Real minus_wd10_y = s10 * wd9_x + c10 * wd9_z + w10_x * qd[9];

  // link 11 (left_wrist1), outward
  const Real wd11_z = minus_wd10_y + qdd_0[10];

  // link 12 (left_wrist2), outward
  const Real minus_wd12_y = s12 * wd11_x + c12 * wd11_z + w12_x * qd[11];

  // link 13 (left_hand), outward
  const Real wd13_x = s13 * wd12_z - c13 * minus_wd12_y + w13_y * qd[12];

  // link 1 (calf), force propagation
  const Real f13_x_p4306 = c13 * f13_x_p4302 + s13 * f13_x_p4301 - wd13_x - f13_x_p2797_lanes[3] *
      f13_x_p4275 - f13_x_p2998_lanes[3] * f13_x_p4299;
  const Real f13_x_p4307 = f13_x_p4306 - f13_x_p3197_lanes[3] * f13_x_p4305;

  // link 13 (left_hand), outward
  const Real wd13_y = s13 * minus_wd12_y + c13 * wd12_z - w13_x * qd[12];

  // link 1 (calf), force propagation
  const Real f13_x_p4308 = f13_x_p4303 - wd13_y - f13_x_p2797_lanes[4] * f13_x_p4275 -
      f13_x_p2998_lanes[4] * f13_x_p4299 - f13_x_p3197_lanes[4] * f13_x_p4305 -
      f13_x_p3408_lanes[4] * f13_x_p4307;

  // link 12 (left_wrist2), outward
  const Real wd12_x = c12 * wd11_x - s12 * wd11_z - minus_w12_y * qd[11];

  // link 13 (left_hand), outward
  const Real wd13_z = wd12_x + qdd_0[12];

  // link 1 (calf), force propagation
  const Real f13_x_p4309 = f13_x_p4297 - wd13_z - f13_x_p2797_lanes[5] * f13_x_p4275 -
      f13_x_p2998_lanes[5] * f13_x_p4299 - f13_x_p3197_lanes[5] * f13_x_p4305 -
      f13_x_p3408_lanes[5] * f13_x_p4307;
  const Real f13_x_p4310 = f13_x_p4309 - f13_x_p3587_lanes[5] * f13_x_p4308;

  // link 24 (right_eye), outward
  const Real f13_x_p4311 = 9.81 + xdd_cmd[8];
  const Real f13_x_p4312 = c1 * xdd_cmd[6] - s1 * f13_x_p4311;
  const Real f13_x_p4313 = s1 * xdd_cmd[6] + c1 * f13_x_p4311;
  const Real f13_x_p4314 = c2 * f13_x_p4312 - s2 * f13_x_p4313;
  const Real f13_x_p4315 = s2 * f13_x_p4312 + c2 * f13_x_p4313;
  const Real f13_x_p4316 = c3 * f13_x_p4314 - s3 * f13_x_p4315;
  const Real f13_x_p4317 = c4 * f13_x_p4316 + s4 * xdd_cmd[7];
  const Real f13_x_p4318 = s3 * f13_x_p4314 + c3 * f13_x_p4315;
  const Real f13_x_p4319 = s5 * f13_x_p4317 + c5 * f13_x_p4318;
  const Real f13_x_p4320 = c4 * xdd_cmd[7] - s4 * f13_x_p4316;
  const Real f13_x_p4321 = s6 * f13_x_p4320 - c6 * f13_x_p4319;
  const Real f13_x_p4322 = c5 * f13_x_p4317 - s5 * f13_x_p4318;
  const Real f13_x_p4323 = c14 * f13_x_p4321 - s14 * f13_x_p4322;
  const Real f13_x_p4324 = s6 * f13_x_p4319 + c6 * f13_x_p4320;
  const Real f13_x_p4325 = c15 * f13_x_p4324 - s15 * f13_x_p4323;
  const Real f13_x_p4326 = s14 * f13_x_p4321 + c14 * f13_x_p4322;
  const Real f13_x_p4327 = s16 * f13_x_p4325 + c16 * f13_x_p4326;
  const Real f13_x_p4328 = c15 * f13_x_p4323 + s15 * f13_x_p4324;
  const Real f13_x_p4329 = c17 * f13_x_p4327 + s17 * f13_x_p4328;
  const Real f13_x_p4330 = c16 * f13_x_p4325 - s16 * f13_x_p4326;
  const Real f13_x_p4331 = c18 * f13_x_p4329 + s18 * f13_x_p4330;
  const Real f13_x_p4332 = c17 * f13_x_p4328 - s17 * f13_x_p4327;
  const Real f13_x_p4333 = c19 * f13_x_p4332 - s19 * f13_x_p4331;
  const Real f13_x_p4334 = c18 * f13_x_p4330 - s18 * f13_x_p4329;

  // link 14 (right_shoulder1), outward
  const Real a14_y_p1 = a7_x_p3 - a7_x_p5;
  const Real a14_y_p2 = a7_x_p8 - a7_x_p11;
  const Real a14_y = c14 * a14_y_p1 - s14 * a14_y_p2;
  const Real a14_z = minus_a7_z_p4 - minus_a7_z_p2;

  // link 15 (right_shoulder2), outward
  const Real a15_y = c15 * a14_z - s15 * a14_y;

  // link 14 (right_shoulder1), outward
  const Real a14_x = s14 * a14_y_p1 + c14 * a14_y_p2;

  // link 16 (right_upperarm), outward
  const Real a16_x = s16 * a15_y + c16 * a14_x;

  // link 14 (right_shoulder1), outward
  const Real w14_x = s14 * w6_x + c14 * w6_z;
  const Real wd14_y = c14 * wd6_x - s14 * wd6_z - w14_x * qd[13];
  const Real wd14_z = wd6_y + qdd_0[13];
  const Real w14_y = c14 * w6_x - s14 * w6_z;
  const Real w14_z = w6_y + qd[13];

  // link 15 (right_shoulder2), outward
  const Real w15_x = c15 * w14_y + s15 * w14_z;
  const Real wd15_y = c15 * wd14_z - s15 * wd14_y - w15_x * qd[14];

  // link 14 (right_shoulder1), outward
  const Real wd14_x = s14 * wd6_x + c14 * wd6_z + w14_y * qd[13];

  // link 15 (right_shoulder2), outward
  const Real wd15_z = wd14_x + qdd_0[14];
  const Real w15_y = c15 * w14_z - s15 * w14_y;
  const Real w15_z = w14_x + qd[14];

  // link 16 (right_upperarm), outward
  const Real w16_x = s16 * w15_y + c16 * w15_z;
  const Real wd16_y = c16 * wd15_y - s16 * wd15_z - w16_x * qd[15];
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
  const Real wd16_x = s16 * wd15_y + c16 * wd15_z + w16_y * qd[15];
  const Real a17_z_p1 = w16_y * w16_z;
  const Real a17_z_p2 = a17_z_p1 - wd16_x;

  // link 17 (right_lowerarm), outward
  const Real a17_z = a16_y - 0.282 * a17_z_p2;

  // link 18 (right_wrist1), outward
  const Real a18_x = c18 * a17_x + s18 * a17_z;

  // link 17 (right_lowerarm), outward
  const Real wd17_z = wd16_y + qdd_0[16];

  // link 15 (right_shoulder2), outward
  const Real wd15_x = c15 * wd14_y + s15 * wd14_z + w15_y * qd[14];

  // link 16 (right_upperarm), outward
  const Real wd16_z = qdd_0[15] - wd15_x;

  // link 17 (right_lowerarm), outward
  const Real minus_w17_y = s17 * w16_x + c17 * w16_z;
  const Real wd17_x = c17 * wd16_x - s17 * wd16_z - minus_w17_y * qd[16];
  const Real w17_x = c17 * w16_x - s17 * w16_z;
  const Real w17_z = w16_y + qd[16];

  // link 18 (right_wrist1), outward
  const Real w18_x = c18 * w17_x + s18 * w17_z;
  const Real wd18_y = c18 * wd17_z - s18 * wd17_x - w18_x * qd[17];
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

  // link 18 (right_wrist1), outward
  const Real a18_y = c18 * a17_z - s18 * a17_x;
  const Real wd18_x = c18 * wd17_x + s18 * wd17_z + w18_y * qd[17];
  const Real a19_z_p1 = w18_y * w18_z;
  const Real a19_z_p2 = a19_z_p1 - wd18_x;

  // link 19 (right_wrist2), outward
  const Real a19_z = a18_y - 0.269 * a19_z_p2;

  // link 20 (right_hand), outward
  const Real a20_x = s20 * a19_z - c20 * minus_a19_y;

  // link 19 (right_wrist2), outward
  const Real minus_w19_y = s19 * w18_x + c19 * w18_z;
  const Real w19_z = w18_y + qd[18];

  // link 20 (right_hand), outward
  const Real w20_y = s20 * minus_w19_y + c20 * w19_z;
  const Real f13_x_p4335 = w20_y * w20_y;

  // link 19 (right_wrist2), outward
  const Real w19_x = c19 * w18_x - s19 * w18_z;

  // link 20 (right_hand), outward
  const Real w20_z = w19_x + qd[19];
  const Real f13_x_p4336 = w20_z * w20_z;

  // link 24 (right_eye), outward
  const Real f13_x_p4337 = f13_x_p4335 + f13_x_p4336;

  // link 1 (calf), force propagation
  const Real f13_x_p4338 = c20 * f13_x_p4333 + s20 * f13_x_p4334 - (a20_x - 0.086 * f13_x_p4337) -
      f13_x_p2797_lanes[6] * f13_x_p4275;
  const Real f13_x_p4339 = f13_x_p4338 - f13_x_p2998_lanes[6] * f13_x_p4299 - f13_x_p3197_lanes[6] *
      f13_x_p4305 - f13_x_p3408_lanes[6] * f13_x_p4307 - f13_x_p3587_lanes[6] * f13_x_p4308;
  const Real f13_x_p4340 = f13_x_p4339 - f13_x_p3796 * f13_x_p4310;

  // link 20 (right_hand), outward
  const Real a20_y = s20 * minus_a19_y + c20 * a19_z;

  // link 1 (calf), force propagation
  const Real f13_x_p4341 = c20 * f13_x_p4334 - s20 * f13_x_p4333 - a20_y - f13_x_p2797_lanes[7] *
      f13_x_p4275 - f13_x_p2998_lanes[7] * f13_x_p4299;
  const Real f13_x_p4342 = f13_x_p4341 - f13_x_p3197_lanes[7] * f13_x_p4305 - f13_x_p3408_lanes[7] *
      f13_x_p4307 - f13_x_p3587_lanes[7] * f13_x_p4308 - f13_x_p3806 * f13_x_p4310;

  // link 24 (right_eye), outward
  const Real f13_x_p4343 = c1 * xdd_cmd[9] - s1 * xdd_cmd[11];
  const Real f13_x_p4344 = s1 * xdd_cmd[9] + c1 * xdd_cmd[11];
  const Real f13_x_p4345 = c2 * f13_x_p4343 - s2 * f13_x_p4344;
  const Real f13_x_p4346 = s2 * f13_x_p4343 + c2 * f13_x_p4344;
  const Real f13_x_p4347 = c3 * f13_x_p4345 - s3 * f13_x_p4346;
  const Real f13_x_p4348 = c4 * f13_x_p4347 + s4 * xdd_cmd[10];
  const Real f13_x_p4349 = s3 * f13_x_p4345 + c3 * f13_x_p4346;
  const Real f13_x_p4350 = s5 * f13_x_p4348 + c5 * f13_x_p4349;
  const Real f13_x_p4351 = c4 * xdd_cmd[10] - s4 * f13_x_p4347;
  const Real f13_x_p4352 = s6 * f13_x_p4351 - c6 * f13_x_p4350;
  const Real f13_x_p4353 = c5 * f13_x_p4348 - s5 * f13_x_p4349;
  const Real f13_x_p4354 = c14 * f13_x_p4352 - s14 * f13_x_p4353;
  const Real f13_x_p4355 = s6 * f13_x_p4350 + c6 * f13_x_p4351;
  const Real f13_x_p4356 = c15 * f13_x_p4355 - s15 * f13_x_p4354;
  const Real f13_x_p4357 = s14 * f13_x_p4352 + c14 * f13_x_p4353;
  const Real f13_x_p4358 = s16 * f13_x_p4356 + c16 * f13_x_p4357;
  const Real f13_x_p4359 = c15 * f13_x_p4354 + s15 * f13_x_p4355;
  const Real f13_x_p4360 = c17 * f13_x_p4358 + s17 * f13_x_p4359;
  const Real f13_x_p4361 = c16 * f13_x_p4356 - s16 * f13_x_p4357;
  const Real f13_x_p4362 = c18 * f13_x_p4360 + s18 * f13_x_p4361;
  const Real f13_x_p4363 = c17 * f13_x_p4359 - s17 * f13_x_p4358;
  const Real f13_x_p4364 = c19 * f13_x_p4362 + s19 * f13_x_p4363;

  // link 20 (right_hand), outward
  const Real w20_x = s20 * w19_z - c20 * minus_w19_y;
  const Real f13_x_p4365 = w20_x * w20_y;

  // link 1 (calf), force propagation
  const Real f13_x_p4366 = f13_x_p4342 - f13_x_p3947 * f13_x_p4340 - 0.086 *
      (f13_x_p4365 + f13_x_p4364);

  // link 19 (right_wrist2), outward
  const Real a19_x = c19 * minus_a19_y_p3 - s19 * minus_a19_y_p6;

  // link 1 (calf), force propagation
  const Real f13_x_p4367 = c19 * f13_x_p4331 + s19 * f13_x_p4332 - a19_x - f13_x_p2741_lanes[0] *
      f13_x_p4275 - f13_x_p2934_lanes[0] * f13_x_p4299;
  const Real f13_x_p4368 = f13_x_p4367 - f13_x_p3125_lanes[0] * f13_x_p4305 - f13_x_p3328_lanes[0] *
      f13_x_p4307 - f13_x_p3499_lanes[0] * f13_x_p4308 - f13_x_p3652_lanes[0] * f13_x_p4310;

  // link 24 (right_eye), outward
  const Real f13_x_p4369 = c18 * f13_x_p4361 - s18 * f13_x_p4360;
  const Real f13_x_p4370 = c19 * f13_x_p4363 - s19 * f13_x_p4362;
  const Real f13_x_p4371 = c20 * f13_x_p4369 - s20 * f13_x_p4370;

  // link 20 (right_hand), outward
  const Real f13_x_p4372 = w20_x * w20_z;

  // link 1 (calf), force propagation
  const Real f13_x_p4373 = f13_x_p4368 - f13_x_p3802_lanes[0] * f13_x_p4340 - f13_x_p3953_lanes[0] *
      f13_x_p4366 + 0.086 * (f13_x_p4371 - f13_x_p4372);

  // link 19 (right_wrist2), outward
  const Real wd19_z = wd18_y + qdd_0[18];

  // link 17 (right_lowerarm), outward
  const Real minus_wd17_y = s17 * wd16_x + c17 * wd16_z + w17_x * qd[16];

  // link 18 (right_wrist1), outward
  const Real wd18_z = minus_wd17_y + qdd_0[17];

  // link 19 (right_wrist2), outward
  const Real minus_wd19_y = s19 * wd18_x + c19 * wd18_z + w19_x * qd[18];

  // link 20 (right_hand), outward
  const Real wd20_x = s20 * wd19_z - c20 * minus_wd19_y + w20_y * qd[19];

  // link 1 (calf), force propagation
  const Real f13_x_p4374 = c20 * f13_x_p4370 + s20 * f13_x_p4369 - wd20_x - f13_x_p2741_lanes[1] *
      f13_x_p4275 - f13_x_p2934_lanes[1] * f13_x_p4299;
  const Real f13_x_p4375 = f13_x_p4374 - f13_x_p3125_lanes[1] * f13_x_p4305 - f13_x_p3328_lanes[1] *
      f13_x_p4307 - f13_x_p3499_lanes[1] * f13_x_p4308 - f13_x_p3652_lanes[1] * f13_x_p4310;
  const Real f13_x_p4376 = f13_x_p4375 - f13_x_p3802_lanes[1] * f13_x_p4340 - f13_x_p3953_lanes[1] *
      f13_x_p4366 - f13_x_p4098_lanes[1] * f13_x_p4373;

  // link 20 (right_hand), outward
  const Real wd20_y = s20 * minus_wd19_y + c20 * wd19_z - w20_x * qd[19];

  // link 1 (calf), force propagation
  const Real f13_x_p4377 = f13_x_p4371 - wd20_y - f13_x_p2741_lanes[2] * f13_x_p4275 -
      f13_x_p2934_lanes[2] * f13_x_p4299 - f13_x_p3125_lanes[2] * f13_x_p4305 -
      f13_x_p3328_lanes[2] * f13_x_p4307;
  const Real f13_x_p4378 = f13_x_p4377 - f13_x_p3499_lanes[2] * f13_x_p4308 - f13_x_p3652_lanes[2] *
      f13_x_p4310 - f13_x_p3802_lanes[2] * f13_x_p4340 - f13_x_p3953_lanes[2] * f13_x_p4366;
  const Real f13_x_p4379 = f13_x_p4378 - f13_x_p4098_lanes[2] * f13_x_p4373 - f13_x_p4240 *
      f13_x_p4376;

  // link 19 (right_wrist2), outward
  const Real wd19_x = c19 * wd18_x - s19 * wd18_z - minus_w19_y * qd[18];

  // link 20 (right_hand), outward
  const Real wd20_z = wd19_x + qdd_0[19];

  // link 1 (calf), force propagation
  const Real f13_x_p4380 = f13_x_p4364 - wd20_z - f13_x_p2741_lanes[3] * f13_x_p4275 -
      f13_x_p2934_lanes[3] * f13_x_p4299 - f13_x_p3125_lanes[3] * f13_x_p4305 -
      f13_x_p3328_lanes[3] * f13_x_p4307;
  const Real f13_x_p4381 = f13_x_p4380 - f13_x_p3499_lanes[3] * f13_x_p4308 - f13_x_p3652_lanes[3] *
      f13_x_p4310 - f13_x_p3802_lanes[3] * f13_x_p4340 - f13_x_p3953_lanes[3] * f13_x_p4366;

  // link 16 (right_upperarm), force propagation
  const Real f13_x_p4382 = 1065.380700001509 + f13_x_p4164_lanes[3] * f13_x_p538 +
      f13_x_p4158_lanes[3] * f13_x_p540 + f13_x_p3728_lanes[3] * f13_x_p578_lanes[3] +
      f13_x_p3720_lanes[3] * f13_x_p612_lanes[3];

  // link 5 (chest2), force propagation
  const Real f13_x_p4383 = f13_x_p4382 + f13_x_p3712_lanes[3] * f13_x_p730_lanes[3] +
      f13_x_p3704_lanes[3] * f13_x_p767_lanes[3] + f13_x_p2506_lanes[3] * f13_x_p944_lanes[3] +
      f13_x_p2498_lanes[3] * f13_x_p1004_lanes[3];

  // link 1 (calf), force propagation
  const Real f13_x_p4384 = f13_x_p4383 + f13_x_p2490_lanes[3] * f13_x_p1050 + f13_x_p2482_lanes[3] *
      f13_x_p1116_lanes[3] + f13_x_p2474_lanes[3] * f13_x_p1176_lanes[3] + f13_x_p1227_lanes[3] *
      f13_x_p1223_lanes[3];
  const Real f13_x_p4385 = f13_x_p4384 - f13_x_p2741_lanes[3] * f13_x_p2530_lanes[3] -
      f13_x_p2934_lanes[3] * f13_x_p2793_lanes[3] - f13_x_p3125_lanes[3] * f13_x_p2994_lanes[3] -
      f13_x_p3328_lanes[3] * f13_x_p3193_lanes[3];
  const Real f13_x_p4386 = f13_x_p4385 - f13_x_p3499_lanes[3] * f13_x_p3404_lanes[3] -
      f13_x_p3652_lanes[3] * f13_x_p3583_lanes[3] - f13_x_p3802_lanes[3] * f13_x_p3792_lanes[3] -
      f13_x_p3953_lanes[3] * f13_x_p3943_lanes[3];
  const Real f13_x_p4387 = (f13_x_p4381 - f13_x_p4098_lanes[3] * f13_x_p4373 - f13_x_p4231 *
      f13_x_p4376 - f13_x_p4247 * f13_x_p4379) * (1.0 /
      (f13_x_p4386 - f13_x_p4098_lanes[3] * f13_x_p4093_lanes[3] - f13_x_p4231 *
      f13_x_p4227_lanes[3] - f13_x_p4247 * f13_x_p4239));
  const Real f13_x_p4388 = f13_x_p4379 * f13_x_p4246 - f13_x_p4247 * f13_x_p4387;
  const Real f13_x_p4389 = f13_x_p4376 * f13_x_p4230 - f13_x_p4240 * f13_x_p4388 - f13_x_p4231 *
      f13_x_p4387;
  const Real f13_x_p4390 = f13_x_p4373 * f13_x_p4097 - f13_x_p4098_lanes[1] * f13_x_p4389 -
      f13_x_p4098_lanes[2] * f13_x_p4388 - f13_x_p4098_lanes[3] * f13_x_p4387;
  const Real f13_x_p4391 = f13_x_p4366 * f13_x_p3952 - f13_x_p3953_lanes[0] * f13_x_p4390 -
      f13_x_p3953_lanes[1] * f13_x_p4389 - f13_x_p3953_lanes[2] * f13_x_p4388 -
      f13_x_p3953_lanes[3] * f13_x_p4387;
  const Real f13_x_p4392 = f13_x_p4340 * f13_x_p3801 - f13_x_p3947 * f13_x_p4391 -
      f13_x_p3802_lanes[0] * f13_x_p4390 - f13_x_p3802_lanes[1] * f13_x_p4389 -
      f13_x_p3802_lanes[2] * f13_x_p4388;
  const Real f13_x_p4393 = f13_x_p4392 - f13_x_p3802_lanes[3] * f13_x_p4387;
  const Real f13_x_p4394 = f13_x_p4310 * f13_x_p3651 - f13_x_p3796 * f13_x_p4393 - f13_x_p3806 *
      f13_x_p4391 - f13_x_p3652_lanes[0] * f13_x_p4390 - f13_x_p3652_lanes[1] * f13_x_p4389;
  const Real f13_x_p4395 = f13_x_p4394 - f13_x_p3652_lanes[2] * f13_x_p4388 - f13_x_p3652_lanes[3] *
      f13_x_p4387;
  const Real f13_x_p4396 = f13_x_p4308 * f13_x_p3498 - f13_x_p3587_lanes[5] * f13_x_p4395 -
      f13_x_p3587_lanes[6] * f13_x_p4393 - f13_x_p3587_lanes[7] * f13_x_p4391 -
      f13_x_p3499_lanes[0] * f13_x_p4390;
  const Real f13_x_p4397 = f13_x_p4396 - f13_x_p3499_lanes[1] * f13_x_p4389 - f13_x_p3499_lanes[2] *
      f13_x_p4388 - f13_x_p3499_lanes[3] * f13_x_p4387;
  const Real f13_x_p4398 = f13_x_p4307 * f13_x_p3327 - f13_x_p3408_lanes[4] * f13_x_p4397 -
      f13_x_p3408_lanes[5] * f13_x_p4395 - f13_x_p3408_lanes[6] * f13_x_p4393 -
      f13_x_p3408_lanes[7] * f13_x_p4391;
  const Real f13_x_p4399 = f13_x_p4398 - f13_x_p3328_lanes[0] * f13_x_p4390 - f13_x_p3328_lanes[1] *
      f13_x_p4389 - f13_x_p3328_lanes[2] * f13_x_p4388 - f13_x_p3328_lanes[3] * f13_x_p4387;
  const Real f13_x_p4400 = f13_x_p4305 * f13_x_p3124 - f13_x_p3197_lanes[3] * f13_x_p4399 -
      f13_x_p3197_lanes[4] * f13_x_p4397 - f13_x_p3197_lanes[5] * f13_x_p4395 -
      f13_x_p3197_lanes[6] * f13_x_p4393;
  const Real f13_x_p4401 = f13_x_p4400 - f13_x_p3197_lanes[7] * f13_x_p4391 - f13_x_p3125_lanes[0] *
      f13_x_p4390 - f13_x_p3125_lanes[1] * f13_x_p4389 - f13_x_p3125_lanes[2] * f13_x_p4388;
  const Real f13_x_p4402 = f13_x_p4401 - f13_x_p3125_lanes[3] * f13_x_p4387;
  const Real f13_x_p4403 = f13_x_p4299 * f13_x_p2933 - f13_x_p2998_lanes[2] * f13_x_p4402 -
      f13_x_p2998_lanes[3] * f13_x_p4399 - f13_x_p2998_lanes[4] * f13_x_p4397 -
      f13_x_p2998_lanes[5] * f13_x_p4395;
  const Real f13_x_p4404 = f13_x_p4403 - f13_x_p2998_lanes[6] * f13_x_p4393 - f13_x_p2998_lanes[7] *
      f13_x_p4391 - f13_x_p2934_lanes[0] * f13_x_p4390 - f13_x_p2934_lanes[1] * f13_x_p4389;
  const Real f13_x_p4405 = f13_x_p4404 - f13_x_p2934_lanes[2] * f13_x_p4388 - f13_x_p2934_lanes[3] *
      f13_x_p4387;
  const Real f13_x_p4406 = f13_x_p4275 * f13_x_p2740 - f13_x_p2797_lanes[1] * f13_x_p4405 -
      f13_x_p2797_lanes[2] * f13_x_p4402 - f13_x_p2797_lanes[3] * f13_x_p4399 -
      f13_x_p2797_lanes[4] * f13_x_p4397;
  const Real f13_x_p4407 = f13_x_p4406 - f13_x_p2797_lanes[5] * f13_x_p4395 - f13_x_p2797_lanes[6] *
      f13_x_p4393 - f13_x_p2797_lanes[7] * f13_x_p4391 - f13_x_p2741_lanes[0] * f13_x_p4390;

  // link 13 (left_hand), outward
  const Real f13_x_p4408 = f13_x_p4298 - wd13_z;

  // link 24 (right_eye), inertial wrench
  const Real f13_x = f13_x_p4407 - f13_x_p2741_lanes[1] * f13_x_p4389 - f13_x_p2741_lanes[2] *
      f13_x_p4388 - f13_x_p2741_lanes[3] * f13_x_p4387 -
      (0.01626499875 * f13_x_p4274 + 0.002865001425 * f13_x_p4408);

  // link 13 (left_hand), outward
  const Real f13_y_p1 = f13_x_p4298 + wd13_z;
  const Real f13_y_p2 = w13_x * w13_x;

  // link 24 (right_eye), inertial wrench
  const Real f13_y = 0.01626499875 * f13_y_p1 + 0.002865001425 * (f13_y_p2 + f13_x_p4273) +
      f13_x_p4405;

  // link 12 (left_wrist2), outward
  const Real f12_y_p1 = w12_x * minus_w12_y;
  const Real f12_y_p2 = w12_z * w12_z;

  // link 13 (left_hand), inward
  const Real f12_y = 0.0025100003499999995 * (wd12_z - f12_y_p1) - 0.0006000000000000001 *
      (w12_x * w12_x + f12_y_p2) + (c13 * f13_x - s13 * f13_y);

  // link 13 (left_hand), outward
  const Real f13_z_p1 = f13_x_p4304 - wd13_y;
  const Real f13_z_p2 = w13_y * w13_z;
  const Real f13_z_p3 = f13_z_p2 + wd13_x;

  // link 24 (right_eye), inertial wrench
  const Real f13_z = 0.01626499875 * f13_z_p1 - 0.002865001425 * f13_z_p3 + f13_x_p4402;

  // link 12 (left_wrist2), outward
  const Real f12_x_p1 = minus_w12_y * minus_w12_y;
  const Real f12_x_p2 = f12_y_p1 + wd12_z;

  // link 13 (left_hand), inward
  const Real f12_x = f13_z - (0.0025100003499999995 * (f12_x_p1 + f12_y_p2) +
      0.0006000000000000001 * f12_x_p2);

  // link 12 (left_wrist2), inward
  const Real f11_x_p1 = s12 * f12_y - c12 * f12_x;

  // link 11 (left_wrist1), outward
  const Real f11_x_p2 = w11_x * w11_y;
  const Real f11_x_p3 = f11_x_p2 - wd11_z;
  const Real f11_x_p4 = w11_z * w11_z;

  // link 12 (left_wrist2), inward
  const Real f11_x = 0.001 * f11_x_p3 - 6e-04 * (minus_a12_y_p5 + f11_x_p4) - f11_x_p1;

  // link 12 (left_wrist2), outward
  const Real f12_z_p1 = w12_x * w12_z;
  const Real f12_z_p2 = f12_z_p1 + minus_wd12_y;
  const Real f12_z_p3 = wd12_x - minus_w12_y * w12_z;

  // link 13 (left_hand), inward
  const Real f12_z = 0.0025100003499999995 * f12_z_p2 + 0.0006000000000000001 * f12_z_p3 +
      (s13 * f13_x + c13 * f13_y);

  // link 11 (left_wrist1), outward
  const Real f11_y_p1 = f11_x_p2 + wd11_z;

  // link 12 (left_wrist2), inward
  const Real f11_y = 6e-04 * f11_y_p1 - 0.001 * (minus_a12_y_p4 + f11_x_p4) + f12_z;

  // link 10 (left_lowerarm), outward
  const Real f10_z_p1 = w10_x * w10_z;
  const Real f10_z_p2 = f10_z_p1 + minus_wd10_y;
  const Real f10_z_p3 = minus_w10_y * w10_z;
  const Real f10_z_p4 = wd10_x - f10_z_p3;

  // link 11 (left_wrist1), inward
  const Real f10_z = 0.0014999985000000002 * f10_z_p2 + 0.28049749700000004 * f10_z_p4 +
      (s11 * f11_x + c11 * f11_y);

  // link 13 (left_hand), inertial wrench
  const Real n13_x_p1 = 9.149209276993575e-05 * f13_z_p3 - 0.0001263900573325125 * f13_z_p1 -
      0.000108260010923775 * f13_y_p1 - 4.38600177048965e-05 * (f13_x_p4273 - f13_x_p4272);

  // link 24 (right_eye), inertial wrench
  const Real n13_x = n13_x_p1 - 0.002865001425 * a12_x + f13_x_p4399;

  // link 13 (left_hand), inertial wrench
  const Real n13_y_p1 = 0.0001263900573325125 * f13_z_p3 -
      (0.000847139515629375 * f13_z_p1 + 4.38600177048965e-05 * f13_x_p4408) +
      0.000108260010923775 * (f13_y_p2 - f13_x_p4273);

  // link 24 (right_eye), inertial wrench
  const Real n13_y = n13_y_p1 - 0.01626499875 * a12_x + f13_x_p4397;

  // link 13 (left_hand), inward
  const Real n12_y = 0.0025100003499999995 * minus_a12_z -
      (0.000195227662257343 * f12_z_p2 + 2.4000000000000003e-06 * f12_x_p2) +
      (c13 * n13_x - s13 * n13_y);

  // link 13 (left_hand), inertial wrench
  const Real n13_z_p1 = 0.0007556474228594393 * f13_x_p4298 + 0.0009386316083993107 * wd13_z +
      0.000108260010923775 * (f13_z_p2 - wd13_x) + 4.38600177048965e-05 * (f13_x_p4304 + wd13_y);

  // link 24 (right_eye), inertial wrench
  const Real n13_z = n13_z_p1 - 0.0001263900573325125 * (f13_x_p4272 - f13_y_p2) +
      (0.01626499875 * a13_y - 0.002865001425 * minus_a13_x) + f13_x_p4395;
  tau[12] = n13_z;

  // link 13 (left_hand), inward
  const Real n12_x = 1.16e-05 * f12_z_p3 + 2.4000000000000003e-06 * (f12_y_p2 - f12_x_p1) -
      0.0006000000000000001 * minus_a12_z + n13_z;

  // link 11 (left_wrist1), outward
  const Real n11_x_p1 = minus_a12_z_p1 + wd11_x;
  const Real n11_x_p2 = minus_a12_y_p1 - wd11_y;

  // link 11 (left_wrist1), inertial wrench
  const Real n11_x_p3 = 0.0001194 * n11_x_p1 + 6e-06 * n11_x_p2 + 0.000144 * f11_y_p1 - 0.0002516 *
      (f11_x_p4 - minus_a12_y_p5);

  // link 12 (left_wrist2), inward
  const Real n11_x = n11_x_p3 + 0.001 * minus_a10_y + (0.269 * f12_z - (s12 * n12_y - c12 * n12_x));

  // link 10 (left_lowerarm), outward
  const Real n10_x_p1 = w10_x * minus_w10_y;
  const Real n10_x_p2 = wd10_z - n10_x_p1;

  // link 12 (left_wrist2), inertial wrench
  const Real n12_z_p1 = 0.00020682766225734302 * wd12_z - 0.000183627662257343 * f12_y_p1 -
      2.4000000000000003e-06 * (f12_z_p1 - minus_wd12_y) -
      (0.0025100003499999995 * minus_a12_y + 0.0006000000000000001 * a12_x);

  // link 13 (left_hand), inward
  const Real n12_z = n12_z_p1 + (s13 * n13_x + c13 * n13_y);
  tau[11] = n12_z;

  // link 11 (left_wrist1), inertial wrench
  const Real n11_y_p1 = 0.0001098 * n11_x_p2 + 0.0002516 * f11_x_p3 + 6e-06 * n11_x_p1 + 0.000144 *
      (minus_a12_y_p4 - f11_x_p4);

  // link 12 (left_wrist2), inward
  const Real n11_y = n12_z + 0.269 * f11_x_p1 - (n11_y_p1 + 6e-04 * minus_a10_y);

  // link 11 (left_wrist1), inward
  const Real n10_x_p3 = 0.06060754126741261 * f10_z_p4 - 2.249994685315e-05 * n10_x_p2 -
      0.28049749700000004 * minus_a10_z + c11 * n11_x - s11 * n11_y;

  // link 10 (left_lowerarm), outward
  const Real n10_x_p4 = w10_z * w10_z;
  const Real n10_x_p5 = minus_w10_y * minus_w10_y;

  // link 11 (left_wrist1), inward
  const Real n10_x = n10_x_p3 + 0.0001499998887063 * (f10_z_p2 + (n10_x_p4 - n10_x_p5));

  // link 11 (left_wrist1), inertial wrench
  const Real n11_z_p1 = 0.0002292 * wd11_z - 9.600000000000003e-06 * f11_x_p2 - 0.000144 *
      minus_a12_z_p2 + 0.0002516 * minus_a12_y_p2 + 6e-06 * (minus_a12_y_p5 - minus_a12_y_p4);

  // link 12 (left_wrist2), inward
  const Real n11_z = n11_z_p1 - (6e-04 * minus_a11_y + 0.001 * a11_x) - (s12 * n12_x + c12 * n12_y);
  tau[10] = n11_z;

  // link 10 (left_lowerarm), outward
  const Real n10_y_p1 = w10_x * w10_x;
  const Real n10_y_p2 = n10_x_p1 + wd10_z;

  // link 11 (left_wrist1), inward
  const Real n10_y = 2.249994685315e-05 * (n10_y_p1 - n10_x_p4) - 0.00028099984685315 * f10_z_p2 +
      0.0014999985000000002 * minus_a10_z - n11_z - 0.0001499998887063 * (n10_y_p2 + f10_z_p4);

  // link 9 (left_upperarm), outward
  const Real n9_x_p1 = minus_a10_z_p1 + wd9_x;
  const Real n9_x_p2 = a10_x_p1 - wd9_y;
  const Real n9_x_p3 = w9_x * w9_y;
  const Real n9_x_p4 = n9_x_p3 + wd9_z;
  const Real n9_x_p5 = w9_z * w9_z;

  // link 9 (left_upperarm), inertial wrench
  const Real n9_x_p6 = 0.0019585440854647937 * n9_x_p1 - 4.4999986458742003e-05 * n9_x_p2 -
      0.0005895000784280001 * n9_x_p4 - 0.0012089992423205001 * (n9_x_p5 - a10_x_p5);

  // link 10 (left_lowerarm), inward
  const Real n9_x = n9_x_p6 - 0.004500002325 * a8_x + (0.282 * f10_z - (s10 * n10_y - c10 * n10_x));

  // link 11 (left_wrist1), inward
  const Real n10_z_p1 = 0.06032654142055946 * n10_x_p1 + 0.060888541114265754 * wd10_z -
      2.249994685315e-05 * (f10_z_p3 + wd10_x) - 0.0014999985000000002 * minus_a10_y;
  const Real n10_z = n10_z_p1 - 0.28049749700000004 * a10_x + s11 * n11_x + c11 * n11_y +
      0.0001499998887063 * (n10_x_p5 - n10_y_p1 - (f10_z_p1 - minus_wd10_y));
  tau[9] = n10_z;
  const Real f10_x = c11 * f11_x - s11 * f11_y - (0.0014999985000000002 * (n10_x_p5 + n10_x_p4) +
      0.28049749700000004 * n10_y_p2);

  // link 12 (left_wrist2), inward
  const Real f11_z = 6e-04 * n11_x_p2 + 0.001 * n11_x_p1 - (s12 * f12_x + c12 * f12_y);

  // link 11 (left_wrist1), inward
  const Real f10_y = 0.0014999985000000002 * n10_x_p2 - 0.28049749700000004 *
      (n10_y_p1 + n10_x_p4) - f11_z;

  // link 10 (left_lowerarm), inward
  const Real n9_y_p1 = s10 * f10_y - c10 * f10_x;

  // link 9 (left_upperarm), outward
  const Real n9_y_p2 = n9_x_p3 - wd9_z;

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
  const Real n8_z_p4 = 0.18101044219699997 * n8_z_p1 + 0.18125194219699997 * wd8_z +
      0.00010499999999999999 * (n8_z_p2 - wd8_x) - 1.75e-05 * (n8_z_p3 + wd8_y);

  // link 8 (left_shoulder2), outward
  const Real n8_z_p5 = w8_y * w8_y;
  const Real n8_z_p6 = w8_x * w8_x;

  // link 9 (left_upperarm), inward
  const Real n8_z = n8_z_p4 + 5.2499999999999995e-05 * (n8_z_p5 - n8_z_p6) -
      (0.7139200499999999 * minus_a8_y + 0.0017499999999999998 * a8_x) + (c9 * n9_x - s9 * n9_y);
  tau[7] = n8_z;

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
  const Real n7_x_p9 = n7_x_p8 + wd7_z;

  // link 8 (left_shoulder2), inward
  const Real n7_x = 0.0001505 * n7_x_p2 + 8.75e-06 * n7_x_p4 + n7_x_p5 + n8_z +
      2.6249999999999998e-05 * (n7_x_p7 - n7_x_p6 - n7_x_p9);

  // link 20 (right_hand), outward
  const Real f20_x_p1 = f13_x_p4365 - wd20_z;

  // link 24 (right_eye), inertial wrench
  const Real f20_x = 0.002865001425 * f20_x_p1 - 0.01626499875 * f13_x_p4337 + f13_x_p4393;

  // link 20 (right_hand), outward
  const Real f20_y_p1 = f13_x_p4365 + wd20_z;
  const Real f20_y_p2 = w20_x * w20_x;

  // link 24 (right_eye), inertial wrench
  const Real f20_y = 0.01626499875 * f20_y_p1 - 0.002865001425 * (f20_y_p2 + f13_x_p4336) +
      f13_x_p4391;

  // link 19 (right_wrist2), outward
  const Real f19_z_p1 = w19_x * w19_z;
  const Real f19_z_p2 = f19_z_p1 + minus_wd19_y;
  const Real f19_z_p3 = wd19_x - minus_w19_y * w19_z;

  // link 20 (right_hand), inward
  const Real f19_z = 0.0025100003499999995 * f19_z_p2 + 0.0006000000000000001 * f19_z_p3 +
      (s20 * f20_x + c20 * f20_y);

  // link 18 (right_wrist1), outward
  const Real f18_y_p1 = w18_x * w18_y;
  const Real f18_y_p2 = f18_y_p1 + wd18_z;
  const Real f18_y_p3 = w18_z * w18_z;

  // link 19 (right_wrist2), inward
  const Real f18_y = 6e-04 * f18_y_p2 + 0.001 * (minus_a19_y_p4 + f18_y_p3) + f19_z;

  // link 19 (right_wrist2), outward
  const Real f19_y_p1 = w19_x * minus_w19_y;
  const Real f19_y_p2 = w19_z * w19_z;

  // link 20 (right_hand), inward
  const Real f19_y = 0.0025100003499999995 * (wd19_z - f19_y_p1) - 0.0006000000000000001 *
      (w19_x * w19_x + f19_y_p2) + (c20 * f20_x - s20 * f20_y);

  // link 20 (right_hand), outward
  const Real f20_z_p1 = f13_x_p4372 - wd20_y;
  const Real f20_z_p2 = w20_y * w20_z;
  const Real f20_z_p3 = f20_z_p2 + wd20_x;

  // link 24 (right_eye), inertial wrench
  const Real f20_z = 0.01626499875 * f20_z_p1 + 0.002865001425 * f20_z_p3 + f13_x_p4390;

  // link 19 (right_wrist2), outward
  const Real f19_x_p1 = minus_w19_y * minus_w19_y;
  const Real f19_x_p2 = f19_y_p1 + wd19_z;

  // link 20 (right_hand), inward
  const Real f19_x = f20_z - (0.0025100003499999995 * (f19_x_p1 + f19_y_p2) +
      0.0006000000000000001 * f19_x_p2);

  // link 19 (right_wrist2), inward
  const Real minus_f18_x_p1 = s19 * f19_y - c19 * f19_x;

  // link 18 (right_wrist1), outward
  const Real minus_f18_x_p2 = f18_y_p1 - wd18_z;

  // link 19 (right_wrist2), inward
  const Real minus_f18_x = 6e-04 * (minus_a19_y_p5 + f18_y_p3) + 0.001 * minus_f18_x_p2 +
      minus_f18_x_p1;

  // link 17 (right_lowerarm), outward
  const Real f17_z_p1 = w17_x * w17_z;
  const Real f17_z_p2 = f17_z_p1 + minus_wd17_y;
  const Real f17_z_p3 = minus_w17_y * w17_z;
  const Real f17_z_p4 = wd17_x - f17_z_p3;

  // link 18 (right_wrist1), inward
  const Real f17_z = 0.0014999985000000002 * f17_z_p2 + 0.28049749700000004 * f17_z_p4 +
      (c18 * f18_y - s18 * minus_f18_x);

  // link 20 (right_hand), inertial wrench
  const Real n20_x_p1 = 9.149209276993575e-05 * f20_z_p3 + 0.0001263900573325125 * f20_z_p1 -
      0.000108260010923775 * f20_y_p1 + 4.38600177048965e-05 * (f13_x_p4336 - f13_x_p4335);

  // link 24 (right_eye), inertial wrench
  const Real n20_x = n20_x_p1 + 0.002865001425 * a19_x + f13_x_p4389;

  // link 20 (right_hand), inertial wrench
  const Real n20_y_p1 = 4.38600177048965e-05 * f20_x_p1 - 0.000847139515629375 * f20_z_p1 -
      0.0001263900573325125 * f20_z_p3 + 0.000108260010923775 * (f20_y_p2 - f13_x_p4336);

  // link 24 (right_eye), inertial wrench
  const Real n20_y = n20_y_p1 - 0.01626499875 * a19_x + f13_x_p4388;

  // link 20 (right_hand), inward
  const Real n19_y = 2.4000000000000003e-06 * f19_x_p2 - 0.000195227662257343 * f19_z_p2 -
      0.0025100003499999995 * a19_z + (c20 * n20_x - s20 * n20_y);

  // link 20 (right_hand), inertial wrench
  const Real n20_z_p1 = 0.0007556474228594393 * f13_x_p4365 + 0.0009386316083993107 * wd20_z +
      0.000108260010923775 * (f20_z_p2 - wd20_x) - 4.38600177048965e-05 * (f13_x_p4372 + wd20_y);

  // link 24 (right_eye), inertial wrench
  const Real n20_z = n20_z_p1 + 0.0001263900573325125 * (f13_x_p4335 - f20_y_p2) +
      (0.01626499875 * a20_y - 0.002865001425 * a20_x) + f13_x_p4387;
  tau[19] = n20_z;

  // link 20 (right_hand), inward
  const Real n19_x = 1.16e-05 * f19_z_p3 - 2.4000000000000003e-06 * (f19_y_p2 - f19_x_p1) +
      0.0006000000000000001 * a19_z + n20_z;

  // link 18 (right_wrist1), outward
  const Real n18_x_p1 = a19_z_p1 + wd18_x;
  const Real n18_x_p2 = minus_a19_y_p1 - wd18_y;

  // link 18 (right_wrist1), inertial wrench
  const Real n18_x_p3 = 0.0001194 * n18_x_p1 - 6e-06 * n18_x_p2 + 0.000144 * f18_y_p2 + 0.0002516 *
      (f18_y_p3 - minus_a19_y_p5);

  // link 19 (right_wrist2), inward
  const Real n18_x = n18_x_p3 - 0.001 * minus_a17_y + (0.269 * f19_z - (s19 * n19_y - c19 * n19_x));

  // link 17 (right_lowerarm), outward
  const Real n17_x_p1 = w17_x * minus_w17_y;
  const Real n17_x_p2 = wd17_z - n17_x_p1;

  // link 19 (right_wrist2), inertial wrench
  const Real n19_z_p1 = 0.00020682766225734302 * wd19_z - 0.000183627662257343 * f19_y_p1 +
      2.4000000000000003e-06 * (f19_z_p1 - minus_wd19_y) -
      (0.0025100003499999995 * minus_a19_y + 0.0006000000000000001 * a19_x);

  // link 20 (right_hand), inward
  const Real n19_z = n19_z_p1 + (s20 * n20_x + c20 * n20_y);
  tau[18] = n19_z;

  // link 18 (right_wrist1), inertial wrench
  const Real n18_y_p1 = 0.0002516 * minus_f18_x_p2 - 0.0001098 * n18_x_p2 + 6e-06 * n18_x_p1 -
      0.000144 * (minus_a19_y_p4 - f18_y_p3);

  // link 19 (right_wrist2), inward
  const Real n18_y = n18_y_p1 - 6e-04 * minus_a17_y + (n19_z + 0.269 * minus_f18_x_p1);

  // link 18 (right_wrist1), inward
  const Real n17_x_p3 = 0.06060754126741261 * f17_z_p4 + 2.249994685315e-05 * n17_x_p2 +
      0.28049749700000004 * a17_z + c18 * n18_x - s18 * n18_y;

  // link 17 (right_lowerarm), outward
  const Real n17_x_p4 = w17_z * w17_z;
  const Real n17_x_p5 = minus_w17_y * minus_w17_y;

  // link 18 (right_wrist1), inward
  const Real n17_x = n17_x_p3 + 0.0001499998887063 * (f17_z_p2 - (n17_x_p4 - n17_x_p5));

  // link 18 (right_wrist1), inertial wrench
  const Real n18_z_p1 = 0.0002292 * wd18_z - 9.600000000000003e-06 * f18_y_p1 - 0.000144 *
      a19_z_p2 - 0.0002516 * minus_a19_y_p2 - 6e-06 * (minus_a19_y_p5 - minus_a19_y_p4);

  // link 19 (right_wrist2), inward
  const Real n18_z = n18_z_p1 + (6e-04 * a18_y + 0.001 * a18_x) - (s19 * n19_x + c19 * n19_y);
  tau[17] = n18_z;

  // link 17 (right_lowerarm), outward
  const Real n17_y_p1 = w17_x * w17_x;
  const Real n17_y_p2 = n17_x_p1 + wd17_z;

  // link 18 (right_wrist1), inward
  const Real n17_y = 0.0001499998887063 * (n17_y_p2 - f17_z_p4) -
      (0.00028099984685315 * f17_z_p2 + 2.249994685315e-05 * (n17_y_p1 - n17_x_p4) +
      0.0014999985000000002 * a17_z + n18_z);

  // link 16 (right_upperarm), outward
  const Real n16_x_p1 = a17_z_p1 + wd16_x;
  const Real n16_x_p2 = a17_x_p1 - wd16_y;
  const Real n16_x_p3 = w16_x * w16_y;
  const Real n16_x_p4 = n16_x_p3 + wd16_z;
  const Real n16_x_p5 = w16_z * w16_z;

  // link 16 (right_upperarm), inertial wrench
  const Real n16_x_p6 = 0.0019585440854647937 * n16_x_p1 + 4.4999986458742003e-05 * n16_x_p2 -
      0.0005895000784280001 * n16_x_p4 + 0.0012089992423205001 * (n16_x_p5 - a17_x_p5);

  // link 17 (right_lowerarm), inward
  const Real n16_x = n16_x_p6 + 0.004500002325 * a15_x +
      (0.282 * f17_z - (s17 * n17_y - c17 * n17_x));

  // link 18 (right_wrist1), inward
  const Real n17_z_p1 = 0.06032654142055946 * n17_x_p1 + 0.060888541114265754 * wd17_z +
      2.249994685315e-05 * (f17_z_p3 + wd17_x) - 0.0014999985000000002 * minus_a17_y;
  const Real n17_z = n17_z_p1 - 0.28049749700000004 * a17_x + s18 * n18_x + c18 * n18_y +
      0.0001499998887063 * (f17_z_p1 - minus_wd17_y + (n17_x_p5 - n17_y_p1));
  tau[16] = n17_z;
  const Real minus_f17_x = 0.0014999985000000002 * (n17_x_p5 + n17_x_p4) + 0.28049749700000004 *
      n17_y_p2 + (c18 * minus_f18_x + s18 * f18_y);

  // link 19 (right_wrist2), inward
  const Real f18_z = 6e-04 * n18_x_p2 - 0.001 * n18_x_p1 - (s19 * f19_x + c19 * f19_y);

  // link 18 (right_wrist1), inward
  const Real f17_y = 0.0014999985000000002 * n17_x_p2 - 0.28049749700000004 *
      (n17_y_p1 + n17_x_p4) - f18_z;

  // link 17 (right_lowerarm), inward
  const Real n16_y_p1 = c17 * minus_f17_x + s17 * f17_y;

  // link 16 (right_upperarm), outward
  const Real n16_y_p2 = n16_x_p3 - wd16_z;

  // link 16 (right_upperarm), inertial wrench
  const Real n16_y_p3 = 0.0012089992423205001 * n16_y_p2 - 0.0008177492704690715 * n16_x_p2 -
      4.4999986458742003e-05 * n16_x_p1 + 0.0005895000784280001 * (a17_x_p4 - n16_x_p5);

  // link 17 (right_lowerarm), inward
  const Real n16_y = n16_y_p3 - 0.0022500062 * a15_x + (n17_z + 0.282 * n16_y_p1);

  // link 15 (right_shoulder2), outward
  const Real n15_z_p1 = w15_x * w15_y;
  const Real n15_z_p2 = w15_y * w15_z;
  const Real n15_z_p3 = w15_x * w15_z;

  // link 15 (right_shoulder2), inertial wrench
  const Real n15_z_p4 = 0.18101044219699997 * n15_z_p1 + 0.18125194219699997 * wd15_z +
      0.00010499999999999999 * (n15_z_p2 - wd15_x) + 1.75e-05 * (n15_z_p3 + wd15_y);

  // link 15 (right_shoulder2), outward
  const Real n15_z_p5 = w15_y * w15_y;
  const Real n15_z_p6 = w15_x * w15_x;

  // link 16 (right_upperarm), inward
  const Real n15_z = n15_z_p4 - 5.2499999999999995e-05 * (n15_z_p5 - n15_z_p6) +
      (0.7139200499999999 * a15_y + 0.0017499999999999998 * a15_x) + (c16 * n16_x - s16 * n16_y);
  tau[14] = n15_z;

  // link 14 (right_shoulder1), outward
  const Real n14_x_p1 = w14_y * w14_z;
  const Real n14_x_p2 = n14_x_p1 + wd14_x;
  const Real n14_x_p3 = w14_x * w14_z;
  const Real n14_x_p4 = n14_x_p3 - wd14_y;

  // link 14 (right_shoulder1), inertial wrench
  const Real n14_x_p5 = 0.0017499999999999998 * a14_z;

  // link 14 (right_shoulder1), outward
  const Real n14_x_p6 = w14_x * w14_y;
  const Real n14_x_p7 = n14_x_p6 + wd14_z;
  const Real n14_x_p8 = w14_y * w14_y;
  const Real n14_x_p9 = w14_z * w14_z;

  // link 15 (right_shoulder2), inward
  const Real n14_x = 0.0001505 * n14_x_p2 + 8.75e-06 * n14_x_p4 - n14_x_p5 + n15_z +
      2.6249999999999998e-05 * (n14_x_p7 - (n14_x_p9 - n14_x_p8));

  // link 21 (neck), outward
  const Real w21_y = c21 * w6_y - s21 * w6_z;
  const Real wd21_x = s21 * wd6_y + c21 * wd6_z + w21_y * qd[20];
  const Real wd21_z = qdd_0[20] - wd6_x;
  const Real w21_x = s21 * w6_y + c21 * w6_z;
  const Real w21_z = qd[20] - w6_x;

  // link 22 (head), outward
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;
  const Real wd22_x = c22 * wd21_x - s22 * wd21_z - minus_w22_y * qd[21];
  const Real w22_z = w21_y + qd[21];
  const Real n22_x_p1 = minus_w22_y * w22_z;
  const Real n22_x_p2 = wd22_x - n22_x_p1;
  const Real w22_x = c22 * w21_x - s22 * w21_z;
  const Real n22_x_p3 = w22_x * w22_z;
  const Real minus_wd22_y = s22 * wd21_x + c22 * wd21_z + w22_x * qd[21];
  const Real n22_x_p4 = n22_x_p3 + minus_wd22_y;

  // link 21 (neck), outward
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;
  const Real a22_z_p1 = w21_y * w21_z;
  const Real a22_z_p2 = a22_z_p1 - wd21_x;

  // link 22 (head), outward
  const Real a22_z = 0.394 * a22_z_p2 - minus_a21_y;

  // link 21 (neck), outward
  const Real wd21_y = c21 * wd6_y - s21 * wd6_z - w21_x * qd[20];

  // link 22 (head), outward
  const Real wd22_z = wd21_y + qdd_0[21];

  // link 24 (right_eye), outward
  const Real w24_y = c24 * w22_z - s24 * w22_x;
  const Real wd24_x = c24 * wd22_x + s24 * wd22_z + w24_y * qd[23];
  const Real w24_z = minus_w22_y + qd[23];
  const Real n24_x_p1 = w24_y * w24_z;
  const Real w24_x = c24 * w22_x + s24 * w22_z;
  const Real n24_x_p2 = w24_x * w24_y;
  const Real wd24_z = minus_wd22_y + qdd_0[23];
  const Real n24_x_p3 = n24_x_p2 + wd24_z;

  // link 24 (right_eye), inertial wrench
  const Real n24_x = 4e-06 * (n24_x_p1 + wd24_x) - 2.8750000000000004e-05 * n24_x_p3;

  // link 21 (neck), outward
  const Real a22_y_p1 = w21_x * w21_x;
  const Real a22_y_p2 = w21_y * w21_y;

  // link 22 (head), outward
  const Real a22_y_p3 = a6_x + 0.394 * (a22_y_p1 + a22_y_p2);

  // link 21 (neck), outward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;
  const Real a22_y_p4 = w21_x * w21_z;

  // link 22 (head), outward
  const Real a22_y_p5 = a21_x + 0.394 * (a22_y_p4 + wd21_y);
  const Real a22_y = c22 * a22_y_p3 - s22 * a22_y_p5;
  const Real minus_a24_z_p1 = w22_x * minus_w22_y;
  const Real minus_a24_z_p2 = wd22_z - minus_a24_z_p1;

  // link 24 (right_eye), outward
  const Real minus_a24_z_p3 = a22_y + 0.095 * minus_a24_z_p2;

  // link 23 (left_eye), outward
  const Real minus_a24_z_p4 = 0.032 * (n22_x_p1 + wd22_x);

  // link 24 (right_eye), outward
  const Real minus_a24_z = minus_a24_z_p3 + minus_a24_z_p4;
  const Real n24_y_p1 = w24_z * w24_z;
  const Real n24_y_p2 = (w24_z + qd[23]) * w24_x - (c24 * wd22_z - s24 * wd22_x);

  // link 24 (right_eye), inertial wrench
  const Real n24_y = 2.8750000000000004e-05 * (w24_x * w24_x - n24_y_p1) - 5.25e-06 * n24_y_p2 +
      0.00025 * minus_a24_z;

  // link 23 (left_eye), inward
  const Real n22_x_p5 = 0.05450270000000001 * n22_x_p2 - 0.0074 * n22_x_p4 - 0.43200000000000005 *
      a22_z + c24 * n24_x - s24 * n24_y;

  // link 23 (left_eye), outward
  const Real w23_y = c23 * w22_z - s23 * w22_x;
  const Real wd23_x = c23 * wd22_x + s23 * wd22_z + w23_y * qd[22];
  const Real w23_z = minus_w22_y + qd[22];
  const Real n23_x_p1 = w23_y * w23_z;
  const Real w23_x = c23 * w22_x + s23 * w22_z;
  const Real n23_x_p2 = w23_x * w23_y;
  const Real wd23_z = minus_wd22_y + qdd_0[22];
  const Real n23_x_p3 = n23_x_p2 + wd23_z;

  // link 23 (left_eye), inertial wrench
  const Real n23_x = 4e-06 * (n23_x_p1 + wd23_x) - 2.8750000000000004e-05 * n23_x_p3;

  // link 23 (left_eye), outward
  const Real minus_a23_z = minus_a24_z_p3 - minus_a24_z_p4;
  const Real n23_y_p1 = w23_z * w23_z;
  const Real n23_y_p2 = (w23_z + qd[22]) * w23_x - (c23 * wd22_z - s23 * wd22_x);

  // link 23 (left_eye), inertial wrench
  const Real n23_y = 2.8750000000000004e-05 * (w23_x * w23_x - n23_y_p1) - 5.25e-06 * n23_y_p2 +
      0.00025 * minus_a23_z;

  // link 23 (left_eye), inward
  const Real n22_x = n22_x_p5 + c23 * n23_x - s23 * n23_y + 8e-06 * (n23_y_p2 - n24_y_p2);

  // link 22 (head), outward
  const Real a22_x = c22 * a22_y_p5 + s22 * a22_y_p3;
  const Real a24_y_p1 = minus_w22_y * minus_w22_y;
  const Real a24_y_p2 = w22_z * w22_z;

  // link 23 (left_eye), outward
  const Real a24_y_p3 = a24_y_p1 + a24_y_p2;

  // link 24 (right_eye), outward
  const Real a24_y_p4 = a22_x - 0.095 * a24_y_p3;

  // link 23 (left_eye), outward
  const Real a24_y_p5 = 0.032 * (n22_x_p3 - minus_wd22_y);

  // link 24 (right_eye), outward
  const Real a24_y_p6 = a22_z + 0.095 * n22_x_p4;

  // link 22 (head), outward
  const Real a24_y_p7 = w22_x * w22_x;

  // link 23 (left_eye), outward
  const Real a24_y_p8 = 0.032 * (a24_y_p7 + a24_y_p1);

  // link 24 (right_eye), outward
  const Real a24_y = c24 * (a24_y_p6 + a24_y_p8) - s24 * (a24_y_p4 - a24_y_p5);

  // link 24 (right_eye), inertial wrench
  const Real n24_z = 1.2499999999999999e-06 * n24_x_p2 + 9.25e-06 * wd24_z +
      2.8750000000000004e-05 * (n24_x_p1 - wd24_x) + 0.00025 * a24_y;
  tau[23] = n24_z;

  // link 23 (left_eye), outward
  const Real a23_y = c23 * (a24_y_p6 - a24_y_p8) - s23 * (a24_y_p4 + a24_y_p5);

  // link 23 (left_eye), inertial wrench
  const Real n23_z = 1.2499999999999999e-06 * n23_x_p2 + 9.25e-06 * wd23_z +
      2.8750000000000004e-05 * (n23_x_p1 - wd23_x) + 0.00025 * a23_y;
  tau[22] = n23_z;

  // link 24 (right_eye), inertial wrench
  const Real f24_y = 0.00025 * n24_x_p3;
  const Real minus_f24_x = 0.00025 * (w24_y * w24_y + n24_y_p1);

  // link 23 (left_eye), inertial wrench
  const Real f23_y = 0.00025 * n23_x_p3;
  const Real minus_f23_x = 0.00025 * (w23_y * w23_y + n23_y_p1);

  // link 23 (left_eye), inward
  const Real n22_y_p1 = c24 * f24_y - s24 * minus_f24_x + (c23 * f23_y - s23 * minus_f23_x);
  const Real n22_y_p2 = 0.0074 * n22_x_p2 - 0.009438624999999999 * n22_x_p4 - 0.072575 * a22_z -
      n24_z - n23_z - 0.095 * n22_y_p1;

  // link 24 (right_eye), inward
  const Real n22_y_p3 = c24 * minus_f24_x + s24 * f24_y;

  // link 23 (left_eye), inward
  const Real n22_y_p4 = c23 * minus_f23_x + s23 * f23_y;
  const Real n22_y = n22_y_p2 + 0.032 * (n22_y_p3 - n22_y_p4);

  // link 21 (neck), outward
  const Real n21_z_p1 = w21_x * w21_y;

  // link 22 (head), inward
  const Real n21_z = 0.00621675 * wd21_z - 0.0048105000000000005 * n21_z_p1 + 0.0016155 * a22_z_p2 -
      0.0045000000000000005 * minus_a21_y - (s22 * n22_x + c22 * n22_y);
  tau[20] = n21_z;

  // link 15 (right_shoulder2), outward
  const Real n15_y_p1 = n15_z_p3 - wd15_y;
  const Real n15_y_p2 = n15_z_p1 - wd15_z;
  const Real n15_y_p3 = n15_z_p2 + wd15_x;
  const Real n15_y_p4 = w15_z * w15_z;

  // link 15 (right_shoulder2), inertial wrench
  const Real n15_y_p5 = 5.2499999999999995e-05 * n15_y_p3 -
      (0.18113119219699997 * n15_y_p1 + 1.75e-05 * n15_y_p2) + 0.00010499999999999999 *
      (n15_z_p6 - n15_y_p4);

  // link 16 (right_upperarm), inward
  const Real n15_y = n15_y_p5 - 0.7139200499999999 * a14_x + (s16 * n16_x + c16 * n16_y);

  // link 16 (right_upperarm), inertial wrench
  const Real n16_z_p1 = 0.0027762933559338653 * wd16_z - 0.001140794814995722 * n16_x_p3 +
      0.0005895000784280001 * a17_z_p2 - 0.0012089992423205001 * a17_x_p2 + 4.4999986458742003e-05 *
      (a17_x_p5 - a17_x_p4);

  // link 17 (right_lowerarm), inward
  const Real n16_z = n16_z_p1 + (0.004500002325 * a16_x - 0.0022500062 * a16_y) -
      (s17 * n17_x + c17 * n17_y);
  tau[15] = n16_z;

  // link 15 (right_shoulder2), outward
  const Real n15_x_p1 = n15_z_p1 + wd15_z;

  // link 15 (right_shoulder2), inertial wrench
  const Real n15_x_p2 = 0.00012075 * n15_y_p3 - 5.2499999999999995e-05 * n15_y_p1 -
      0.00010499999999999999 * n15_x_p1 - 1.75e-05 * (n15_y_p4 - n15_z_p5);

  // link 14 (right_shoulder1), inertial wrench
  const Real n15_x_p3 = 0.0017499999999999998 * a14_x;

  // link 16 (right_upperarm), inward
  const Real n15_x = n15_x_p2 - n15_x_p3 - n16_z;

  // link 15 (right_shoulder2), inward
  const Real n14_y_p1 = c15 * n15_x - s15 * n15_y - 0.0002975 * n14_x_p4 - 8.75e-06 * n14_x_p2 -
      n14_x_p5;

  // link 14 (right_shoulder1), outward
  const Real n14_y_p2 = n14_x_p6 - wd14_z;
  const Real n14_y_p3 = w14_x * w14_x;

  // link 15 (right_shoulder2), inward
  const Real n14_y = n14_y_p1 - 2.6249999999999998e-05 * (n14_y_p2 + (n14_y_p3 - n14_x_p9));

  // link 7 (left_shoulder1), inward
  const Real n6_x_p1 = 0.40041499999999997 * a7_x_p10 + 0.0187369177636143 * minus_a7_z_p1 - n21_z +
      s14 * n14_x + c14 * n14_y;

  // link 8 (left_shoulder2), outward
  const Real n8_y_p1 = n8_z_p1 - wd8_z;
  const Real n8_y_p2 = n8_z_p3 - wd8_y;
  const Real n8_y_p3 = n8_z_p2 + wd8_x;
  const Real n8_y_p4 = w8_z * w8_z;

  // link 8 (left_shoulder2), inertial wrench
  const Real n8_y_p5 = 1.75e-05 * n8_y_p1 - 0.18113119219699997 * n8_y_p2 - 5.2499999999999995e-05 *
      n8_y_p3 + 0.00010499999999999999 * (n8_z_p6 - n8_y_p4);

  // link 9 (left_upperarm), inward
  const Real n8_y = n8_y_p5 - 0.7139200499999999 * a7_x + (s9 * n9_x + c9 * n9_y);

  // link 9 (left_upperarm), inertial wrench
  const Real n9_z_p1 = 0.0027762933559338653 * wd9_z - 0.001140794814995722 * n9_x_p3 +
      0.0005895000784280001 * minus_a10_z_p2 + 0.0012089992423205001 * a10_x_p2 -
      4.4999986458742003e-05 * (a10_x_p5 - a10_x_p4);

  // link 10 (left_lowerarm), inward
  const Real n9_z = n9_z_p1 + (0.0022500062 * minus_a9_y - 0.004500002325 * a9_x) -
      (s10 * n10_x + c10 * n10_y);
  tau[8] = n9_z;

  // link 8 (left_shoulder2), outward
  const Real n8_x_p1 = n8_z_p1 + wd8_z;

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
  const Real n7_y_p2 = n7_x_p8 - wd7_z;
  const Real n7_y_p3 = w7_x * w7_x;

  // link 8 (left_shoulder2), inward
  const Real n7_y = n7_y_p1 + 2.6249999999999998e-05 * (n7_y_p2 + (n7_y_p3 - n7_x_p7));

  // link 10 (left_lowerarm), inward
  const Real f9_x = 0.0022500062 * (a10_x_p5 + n9_x_p5) + 0.004500002325 * n9_y_p2 - n9_y_p1;
  const Real f9_y = f10_z - (0.0022500062 * n9_x_p4 + 0.004500002325 * (a10_x_p4 + n9_x_p5));

  // link 8 (left_shoulder2), inward
  const Real f7_x = 0.7139200499999999 * n8_y_p2 + c9 * f9_x - s9 * f9_y + 0.0017499999999999998 *
      (n8_y_p3 - (n7_x_p6 + n7_x_p7) - n7_y_p2);

  // link 9 (left_upperarm), inward
  const Real f8_y = 0.7139200499999999 * n8_x_p1 - 0.0017499999999999998 * (n8_z_p6 + n8_y_p4) +
      (s9 * f9_x + c9 * f9_y);

  // link 10 (left_lowerarm), inward
  const Real f9_z = 0.004500002325 * n9_x_p1 - 0.0022500062 * n9_x_p2 - (s10 * f10_x + c10 * f10_y);

  // link 9 (left_upperarm), inward
  const Real f8_x = 0.0017499999999999998 * n8_y_p1 - 0.7139200499999999 * (n8_z_p5 + n8_y_p4) -
      f9_z;

  // link 8 (left_shoulder2), inward
  const Real f7_y = c8 * f8_x - s8 * f8_y + 0.0017499999999999998 * (n7_x_p9 + (n7_y_p3 + n7_x_p7));

  // link 7 (left_shoulder1), inward
  const Real n6_x_p2 = c7 * f7_x - s7 * f7_y;

  // link 17 (right_lowerarm), inward
  const Real f16_x = 0.0022500062 * (a17_x_p5 + n16_x_p5) - 0.004500002325 * n16_y_p2 - n16_y_p1;
  const Real f16_y = 0.004500002325 * (a17_x_p4 + n16_x_p5) - 0.0022500062 * n16_x_p4 + f17_z;

  // link 15 (right_shoulder2), inward
  const Real f14_x = 0.7139200499999999 * n15_y_p1 + c16 * f16_x - s16 * f16_y -
      0.0017499999999999998 * (n15_y_p3 + (n14_x_p8 + n14_x_p9) + n14_y_p2);

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
  const Real f14_y = 0.0017499999999999998 * (n14_x_p7 + (n14_y_p3 + n14_x_p9)) -
      (c15 * minus_f15_x + s15 * f15_y);

  // link 14 (right_shoulder1), inward
  const Real n6_x_p3 = c14 * f14_x - s14 * f14_y;

  // link 7 (left_shoulder1), inward
  const Real n6_x = n6_x_p1 + s7 * n7_x + c7 * n7_y + 0.18 * (n6_x_p2 - n6_x_p3);

  // link 8 (left_shoulder2), inward
  const Real n7_z_p1 = 0.00014700000000000002 * n7_x_p8 + 0.00044800000000000005 * wd7_z +
      8.75e-06 * (n7_x_p6 - n7_y_p3) + 0.0017499999999999998 * a7_y;
  const Real n7_z = n7_z_p1 + n8_x_p3 + s8 * n8_x + c8 * n8_y + 2.6249999999999998e-05 *
      (n7_x_p1 - wd7_x - (n7_x_p3 + wd7_y));
  tau[6] = n7_z;

  // link 15 (right_shoulder2), inward
  const Real n14_z_p1 = 0.00014700000000000002 * n14_x_p6 + 0.00044800000000000005 * wd14_z +
      8.75e-06 * (n14_x_p8 - n14_y_p3) + 0.0017499999999999998 * a14_y;
  const Real n14_z = n14_z_p1 + n15_x_p3 + s15 * n15_x + c15 * n15_y + 2.6249999999999998e-05 *
      (n14_x_p3 + wd14_y - (n14_x_p1 - wd14_x));
  tau[13] = n14_z;

  // link 23 (left_eye), inward
  const Real f22_z = 0.072575 * n22_x_p4 - 0.43200000000000005 * n22_x_p2 + n22_y_p1;

  // link 21 (neck), outward
  const Real n21_x_p1 = n21_z_p1 + wd21_z;

  // link 22 (head), inward
  const Real n21_x = 0.005513625 * (a22_z_p1 + wd21_x) - 0.0016155 * n21_x_p1 -
      (s22 * n22_y - c22 * n22_x + 0.394 * f22_z);

  // link 7 (left_shoulder1), inward
  const Real n6_y_p1 = 6.1665928899999995 * a6_z - 1.66923963592404 * a7_x_p7 - 0.0187369177636143 *
      (minus_a7_z_p3 - a7_x_p1) + s21 * n21_x;

  // link 23 (left_eye), inward
  const Real n22_z_p1 = 0.04506407500000001 * minus_a24_z_p1 + 0.06394132500000001 * wd22_z -
      0.0074 * (a24_y_p1 - a24_y_p7) + 0.072575 * a22_y;
  const Real n22_z_p2 = n22_z_p1 + 0.43200000000000005 * a22_x + s24 * n24_x + c24 * n24_y + s23 *
      n23_x;
  const Real n22_z_p3 = n24_y_p2 + n23_y_p2;
  const Real n22_z = n22_z_p2 + c23 * n23_y - 2.375e-05 * n22_z_p3;
  tau[21] = n22_z;
  const Real f22_y = 0.072575 * minus_a24_z_p2 + 0.43200000000000005 * (a24_y_p7 + a24_y_p2) -
      0.00025 * n22_z_p3;
  const Real f22_x = 0.43200000000000005 * (minus_a24_z_p1 + wd22_z) - 0.072575 * a24_y_p3 -
      n22_y_p3 - n22_y_p4;

  // link 22 (head), inward
  const Real n21_y_p1 = s22 * f22_y - c22 * f22_x;

  // link 21 (neck), outward
  const Real n21_y_p2 = w21_z * w21_z;
  const Real n21_y_p3 = a22_y_p4 - wd21_y;

  // link 22 (head), inward
  const Real n21_y = 0.0016155 * (a22_y_p1 - n21_y_p2) - 0.000703125 * n21_y_p3 +
      0.0045000000000000005 * a6_x + (n22_z - 0.394 * n21_y_p1);

  // link 7 (left_shoulder1), inward
  const Real n6_y_p2 = n6_x_p3 + n6_x_p2;
  const Real n6_y = n6_y_p1 + c21 * n21_y + n14_z + n7_z + 0.226 * n6_y_p2;

  // link 5 (chest2), outward
  const Real n5_y_p1 = w5_x * w5_z + minus_wd5_y;

  // link 6 (chest3), inward
  const Real n5_y = 0.005678398088837119 * a6_x_p5 - 0.04675382692737882 * n5_y_p1 +
      0.069699984375 * minus_a5_z + (c6 * n6_x - s6 * n6_y);

  // link 6 (chest3), inertial wrench
  const Real n6_z_p1 = 1.26882463592404 * a7_x_p4 + 2.06965463592404 * wd6_z - 0.0187369177636143 *
      (a7_x_p9 - wd6_x) + 6.1665928899999995 * minus_a6_y;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p2 = n6_z_p1 + c21 * n21_x - s21 * n21_y + c14 * n14_x - s14 * n14_y;

  // link 8 (left_shoulder2), inward
  const Real f7_z = s8 * f8_x + c8 * f8_y + 0.0017499999999999998 * (n7_x_p4 - n7_x_p2);

  // link 15 (right_shoulder2), inward
  const Real f14_z = c15 * f15_y - s15 * minus_f15_x + 0.0017499999999999998 *
      (n14_x_p4 - n14_x_p2);

  // link 7 (left_shoulder1), inward
  const Real n6_z_p3 = f14_z + f7_z;
  const Real n6_z_p4 = s7 * f7_x + c7 * f7_y;

  // link 14 (right_shoulder1), inward
  const Real n6_z_p5 = s14 * f14_x + c14 * f14_y;

  // link 7 (left_shoulder1), inward
  const Real n6_z = n6_z_p2 + c7 * n7_x - s7 * n7_y - 0.226 * n6_z_p3 + 0.18 * (n6_z_p5 - n6_z_p4);
  tau[5] = n6_z;

  // link 22 (head), inward
  const Real f21_z = 0.0045000000000000005 * n21_y_p3 - (s22 * f22_x + c22 * f22_y);

  // link 7 (left_shoulder1), inward
  const Real f6_x = 6.1665928899999995 * a7_x_p2 - f21_z + n6_z_p5 + n6_z_p4;

  // link 22 (head), inward
  const Real minus_f21_x = 0.0045000000000000005 * (a22_y_p2 + n21_y_p2) + n21_y_p1;
  const Real f21_y = 0.0045000000000000005 * n21_x_p1 + f22_z;

  // link 7 (left_shoulder1), inward
  const Real f6_y = n6_z_p3 - 6.1665928899999995 * minus_a7_z_p1 - s21 * minus_f21_x + c21 * f21_y;

  // link 6 (chest3), inward
  const Real n5_x_p1 = s6 * f6_x + c6 * f6_y;
  const Real n5_x = 0.15637308509675518 * a6_x_p5 - 0.005678398088837119 * n5_y_p1 +
      2.2194301519999997 * minus_a5_z + (n6_z - 0.072 * n5_x_p1);
  const Real f5_z = 0.069699984375 * n5_y_p1 - 2.2194301519999997 * a6_x_p5 + n5_x_p1;

  // link 4 (chest1), outward
  const Real n4_x_p1 = w4_x * w4_y;
  const Real n4_x_p2 = n4_x_p1 + qdd_0[3];

  // link 5 (chest2), inward
  const Real n4_x = 0.0478915 * (wd4_x_p1 + wd4_x) + 0.005880002159562879 * n4_x_p2 -
      (s5 * n5_y - c5 * n5_x + 0.21799999999999997 * f5_z);

  // link 7 (left_shoulder1), inward
  const Real f6_z = n6_y_p2 - 6.1665928899999995 * a7_x_p7 - c21 * minus_f21_x - s21 * f21_y;

  // link 5 (chest2), outward
  const Real n5_z_p1 = minus_w5_y * minus_w5_y;

  // link 5 (chest2), inertial wrench
  const Real n5_z_p2 = 0.10961925816937637 * a6_z_p1 + 0.203126912024134 * wd5_z -
      0.005678398088837119 * (n5_z_p1 - a6_x_p1) + (0.069699984375 * a5_y + 2.2194301519999997 *
      a5_x);

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p2 + (s6 * n6_x + c6 * n6_y + 0.072 * f6_z);
  tau[4] = n5_z;
  const Real f5_y = 0.069699984375 * (wd5_z - a6_z_p1) + 2.2194301519999997 * a6_x_p3 +
      (c6 * f6_x - s6 * f6_y);
  const Real f5_x = 2.2194301519999997 * a6_z_p2 - 0.069699984375 * (n5_z_p1 + a6_x_p2) + f6_z;

  // link 5 (chest2), inward
  const Real n4_y_p1 = s5 * f5_y - c5 * f5_x;

  // link 4 (chest1), outward
  const Real n4_y_p2 = wd4_y_p1 - wd4_y;
  const Real n4_y_p3 = qd[3] * qd[3];

  // link 5 (chest2), inward
  const Real n4_y = n5_z - 0.21799999999999997 * n4_y_p1 -
      (0.01227760324629517 * n4_y_p2 + 0.005880002159562879 * (a5_y_p1 - n4_y_p3) + 0.0300000063 *
      a3_y);

  // link 4 (chest1), inward
  const Real n3_z = 1.7824817919087104 * wd3_z + (8.419374554 * a3_x - 0.02999999505 * a3_y) +
      (s4 * n4_x + c4 * n4_y);
  tau[2] = n3_z;

  // link 5 (chest2), inward
  const Real f4_x = 0.0300000063 * (a5_y_p2 + n4_y_p3) - n4_y_p1;
  const Real f4_y = f5_z - 0.0300000063 * n4_x_p2;

  // link 3 (hip), outward
  const Real f3_x_p1 = w3_z * w3_z;

  // link 4 (chest1), inward
  const Real f3_x = 0.02999999505 * f3_x_p1 + 8.419374554 * wd3_z + (c4 * f4_x - s4 * f4_y);

  // link 5 (chest2), inward
  const Real minus_f4_z = 0.0300000063 * n4_y_p2 + (s5 * f5_x + c5 * f5_y);

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * f3_x_p1 - 0.02999999505 * wd3_z + minus_f4_z;

  // link 3 (hip), inward
  const Real n2_z_p1 = c3 * f3_x - s3 * f3_y;
  const Real n2_z = 9.885744550888212 * wd2_z + (0.031999971599999996 * a2_y + 24.5839218 * a2_x) +
      (n3_z + 0.422 * n2_z_p1);
  tau[1] = n2_z;
  const Real f2_x = 24.5839218 * wd2_z - 0.031999971599999996 * a3_y_p1 + n2_z_p1;
  const Real f2_y = 0.031999971599999996 * wd2_z + 24.5839218 * a3_y_p1 + (s3 * f3_x + c3 * f3_y);

  // link 2 (thigh), inward
  const Real n1_z = 13.049859506913753 * qdd_0[0] + (0.1569597827085 * c1 - 299.6743959432 * s1) +
      (n2_z + 0.434 * (c2 * f2_x - s2 * f2_y));
  tau[0] = n1_z;

  // link 5 (chest2), inward
  const Real n4_z = 0.060169103246295166 * qdd_0[3] - 0.03561389675370483 * n4_x_p1 +
      0.005880002159562879 * minus_a5_z_p1 + 0.0300000063 * minus_a4_y - (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
