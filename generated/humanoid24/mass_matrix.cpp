// mass_matrix: tau = M qdd + b + g: the matrix M
// By composite rigid bodies, RBDA table 6.2.
// 2292 flops (add 956, mul 1336, div 0), sine and cosine of 23 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

void mass_matrix(const Real (&TREELINE_RESTRICT q)[24], Real (&TREELINE_RESTRICT M)[576]) noexcept {
  M[157] = 0.0;
  M[158] = 0.0;
  M[159] = 0.0;
  M[160] = 0.0;
  M[161] = 0.0;
  M[162] = 0.0;
  M[163] = 0.0;
  M[164] = 0.0;
  M[165] = 0.0;
  M[166] = 0.0;
  M[167] = 0.0;
  M[181] = 0.0;
  M[182] = 0.0;
  M[183] = 0.0;
  M[184] = 0.0;
  M[185] = 0.0;
  M[186] = 0.0;
  M[187] = 0.0;
  M[188] = 0.0;
  M[189] = 0.0;
  M[190] = 0.0;
  M[191] = 0.0;
  M[205] = 0.0;
  M[206] = 0.0;
  M[207] = 0.0;
  M[208] = 0.0;
  M[209] = 0.0;
  M[210] = 0.0;
  M[211] = 0.0;
  M[212] = 0.0;
  M[213] = 0.0;
  M[214] = 0.0;
  M[215] = 0.0;
  M[229] = 0.0;
  M[230] = 0.0;
  M[231] = 0.0;
  M[232] = 0.0;
  M[233] = 0.0;
  M[234] = 0.0;
  M[235] = 0.0;
  M[236] = 0.0;
  M[237] = 0.0;
  M[238] = 0.0;
  M[239] = 0.0;
  M[253] = 0.0;
  M[254] = 0.0;
  M[255] = 0.0;
  M[256] = 0.0;
  M[257] = 0.0;
  M[258] = 0.0;
  M[259] = 0.0;
  M[260] = 0.0;
  M[261] = 0.0;
  M[262] = 0.0;
  M[263] = 0.0;
  M[277] = 0.0;
  M[278] = 0.0;
  M[279] = 0.0;
  M[280] = 0.0;
  M[281] = 0.0;
  M[282] = 0.0;
  M[283] = 0.0;
  M[284] = 0.0;
  M[285] = 0.0;
  M[286] = 0.0;
  M[287] = 0.0;
  M[301] = 0.0;
  M[302] = 0.0;
  M[303] = 0.0;
  M[304] = 0.0;
  M[305] = 0.0;
  M[306] = 0.0;
  M[307] = 0.0;
  M[308] = 0.0;
  M[309] = 0.0;
  M[310] = 0.0;
  M[311] = 0.0;
  M[318] = 0.0;
  M[319] = 0.0;
  M[320] = 0.0;
  M[321] = 0.0;
  M[322] = 0.0;
  M[323] = 0.0;
  M[324] = 0.0;
  M[332] = 0.0;
  M[333] = 0.0;
  M[334] = 0.0;
  M[335] = 0.0;
  M[342] = 0.0;
  M[343] = 0.0;
  M[344] = 0.0;
  M[345] = 0.0;
  M[346] = 0.0;
  M[347] = 0.0;
  M[348] = 0.0;
  M[356] = 0.0;
  M[357] = 0.0;
  M[358] = 0.0;
  M[359] = 0.0;
  M[366] = 0.0;
  M[367] = 0.0;
  M[368] = 0.0;
  M[369] = 0.0;
  M[370] = 0.0;
  M[371] = 0.0;
  M[372] = 0.0;
  M[380] = 0.0;
  M[381] = 0.0;
  M[382] = 0.0;
  M[383] = 0.0;
  M[390] = 0.0;
  M[391] = 0.0;
  M[392] = 0.0;
  M[393] = 0.0;
  M[394] = 0.0;
  M[395] = 0.0;
  M[396] = 0.0;
  M[404] = 0.0;
  M[405] = 0.0;
  M[406] = 0.0;
  M[407] = 0.0;
  M[414] = 0.0;
  M[415] = 0.0;
  M[416] = 0.0;
  M[417] = 0.0;
  M[418] = 0.0;
  M[419] = 0.0;
  M[420] = 0.0;
  M[428] = 0.0;
  M[429] = 0.0;
  M[430] = 0.0;
  M[431] = 0.0;
  M[438] = 0.0;
  M[439] = 0.0;
  M[440] = 0.0;
  M[441] = 0.0;
  M[442] = 0.0;
  M[443] = 0.0;
  M[444] = 0.0;
  M[452] = 0.0;
  M[453] = 0.0;
  M[454] = 0.0;
  M[455] = 0.0;
  M[462] = 0.0;
  M[463] = 0.0;
  M[464] = 0.0;
  M[465] = 0.0;
  M[466] = 0.0;
  M[467] = 0.0;
  M[468] = 0.0;
  M[476] = 0.0;
  M[477] = 0.0;
  M[478] = 0.0;
  M[479] = 0.0;
  M[486] = 0.0;
  M[487] = 0.0;
  M[488] = 0.0;
  M[489] = 0.0;
  M[490] = 0.0;
  M[491] = 0.0;
  M[492] = 0.0;
  M[493] = 0.0;
  M[494] = 0.0;
  M[495] = 0.0;
  M[496] = 0.0;
  M[497] = 0.0;
  M[498] = 0.0;
  M[499] = 0.0;
  M[510] = 0.0;
  M[511] = 0.0;
  M[512] = 0.0;
  M[513] = 0.0;
  M[514] = 0.0;
  M[515] = 0.0;
  M[516] = 0.0;
  M[517] = 0.0;
  M[518] = 0.0;
  M[519] = 0.0;
  M[520] = 0.0;
  M[521] = 0.0;
  M[522] = 0.0;
  M[523] = 0.0;
  M[534] = 0.0;
  M[535] = 0.0;
  M[536] = 0.0;
  M[537] = 0.0;
  M[538] = 0.0;
  M[539] = 0.0;
  M[540] = 0.0;
  M[541] = 0.0;
  M[542] = 0.0;
  M[543] = 0.0;
  M[544] = 0.0;
  M[545] = 0.0;
  M[546] = 0.0;
  M[547] = 0.0;
  M[551] = 0.0;
  M[558] = 0.0;
  M[559] = 0.0;
  M[560] = 0.0;
  M[561] = 0.0;
  M[562] = 0.0;
  M[563] = 0.0;
  M[564] = 0.0;
  M[565] = 0.0;
  M[566] = 0.0;
  M[567] = 0.0;
  M[568] = 0.0;
  M[569] = 0.0;
  M[570] = 0.0;
  M[571] = 0.0;
  M[574] = 0.0;
  const Real angles[23] = {q[23], q[22], q[21], q[20], q[18], q[19], q[17], q[16], q[15], q[14],
      q[13], q[11], q[12], q[10], q[9], q[8], q[7], q[6], q[5], q[4], q[3], q[2], q[1]};
  Real sines[23];
  Real cosines[23];
  detail::sin_cos(angles, sines, cosines);
  const Real s24 = sines[0];
  const Real s23 = sines[1];
  const Real s22 = sines[2];
  const Real c24 = cosines[0];
  const Real c23 = cosines[1];
  const Real c22 = cosines[2];
  const Real c21 = cosines[3];
  const Real s21 = sines[3];
  const Real s19 = sines[4];
  const Real s20 = sines[5];
  const Real c20 = cosines[5];
  const Real c19 = cosines[4];
  const Real s18 = sines[6];
  const Real c18 = cosines[6];
  const Real s17 = sines[7];
  const Real c17 = cosines[7];
  const Real c16 = cosines[8];
  const Real s16 = sines[8];
  const Real s15 = sines[9];
  const Real c15 = cosines[9];
  const Real s14 = sines[10];
  const Real c14 = cosines[10];
  const Real s12 = sines[11];
  const Real c12 = cosines[11];
  const Real c13 = cosines[12];
  const Real s13 = sines[12];
  const Real s11 = sines[13];
  const Real c11 = cosines[13];
  const Real s10 = sines[14];
  const Real c10 = cosines[14];
  const Real c9 = cosines[15];
  const Real s9 = sines[15];
  const Real s8 = sines[16];
  const Real c8 = cosines[16];
  const Real s7 = sines[17];
  const Real c7 = cosines[17];
  const Real s6 = sines[18];
  const Real c6 = cosines[18];
  const Real s5 = sines[19];
  const Real c5 = cosines[19];
  const Real s4 = sines[20];
  const Real c4 = cosines[20];
  const Real c3 = cosines[21];
  const Real s3 = sines[21];
  const Real s2 = sines[22];
  const Real c2 = cosines[22];

  // link 20 (right_hand), composite inertia
  const Real M_2_2_p1 = 0.0007556474228594393 * s20 + 0.000252780114665025 * c20;
  const Real M_2_2_p2 = s20 * M_2_2_p1;
  const Real M_2_2_p3 = 4.38600177048965e-05 * s20 - 0.000108260010923775 * c20;

  // link 19 (right_wrist2), composite inertia
  const Real M_2_2_p4 = c19 * M_2_2_p3;
  const Real M_2_2_p5 = s19 * (0.000663511853372032 - M_2_2_p2) + 2.0 * M_2_2_p4;

  // link 20 (right_hand), composite inertia
  const Real M_2_2_p6 = 0.01626499875 * c20 - 0.002865001425 * s20;
  const Real M_2_2_p7 = 0.0006000000000000001 + M_2_2_p6;

  // link 19 (right_wrist2), composite inertia
  const Real M_2_2_p8 = s19 * M_2_2_p7 - 0.0025100003499999995 * c19;
  const Real M_2_2_p9 = 0.000144 - (c19 * M_2_2_p5 - M_2_2_p3 + 0.269 * M_2_2_p8);

  // link 20 (right_hand), composite inertia
  const Real M_18_19 = 0.000108260010923775 * s20 + 4.38600177048965e-05 * c20;
  M[451] = -M_18_19;
  M[474] = -M_18_19;
  const Real M_17_18_p1 = 0.0001287900573325125 - c20 * M_2_2_p1;

  // link 19 (right_wrist2), composite inertia
  const Real M_17_18 = s19 * M_18_19 - c19 * M_17_18_p1;
  M[426] = M_17_18;
  M[449] = M_17_18;

  // link 20 (right_hand), composite inertia
  const Real M_2_2_p10 = 0.01626499875 * s20 + 0.002865001425 * c20;

  // link 19 (right_wrist2), composite inertia
  const Real M_2_2_p11 = M_17_18 + 0.269 * M_2_2_p10 - 0.0002516;

  // link 18 (right_wrist1), composite inertia
  const Real M_2_2_p12 = c18 * M_2_2_p9 - s18 * M_2_2_p11;
  const Real M_2_2_p13 = 0.0001499998887063 + M_2_2_p12;

  // link 19 (right_wrist2), composite inertia
  const Real M_2_2_p14 = s19 * M_2_2_p5;
  const Real M_2_2_p15 = 0.0025100003499999995 * s19 + c19 * M_2_2_p7;
  const Real M_2_2_p16 = 0.538 * M_2_2_p15;
  const Real M_2_2_p17 = 0.0010696316083993107 - M_2_2_p14 + M_2_2_p16;

  // link 20 (right_hand), composite inertia
  const Real M_18_18 = 0.001053967177886718 - M_2_2_p2;
  M[450] = M_18_18;

  // link 19 (right_wrist2), composite inertia
  const Real M_2_2_p18 = 0.0001098 + (M_18_18 + M_2_2_p16);
  const Real M_2_2_p19 = c19 * M_18_19 + s19 * M_17_18_p1;
  const Real M_2_2_p20 = 6e-06 - M_2_2_p19;

  // link 18 (right_wrist1), composite inertia
  const Real M_2_2_p21 = s18 * (M_2_2_p17 - M_2_2_p18) + c18 * (2.0 * M_2_2_p20);
  const Real M_2_2_p22 = s18 * M_2_2_p21;
  const Real M_2_2_p23 = 0.06060754126741261 + (M_2_2_p17 - M_2_2_p22);

  // link 19 (right_wrist2), composite inertia
  const Real M_2_2_p24 = 0.0002867197550272787 + M_2_2_p2 + M_2_2_p14;

  // link 18 (right_wrist1), composite inertia
  const Real M_2_2_p25 = 0.00051019984685315 + M_2_2_p24;

  // link 17 (right_lowerarm), composite inertia
  const Real M_2_2_p26 = c17 * (2.0 * M_2_2_p13) - s17 * (M_2_2_p23 - M_2_2_p25);
  const Real M_2_2_p27 = s17 * M_2_2_p26;

  // link 19 (right_wrist2), composite inertia
  const Real M_2_2_p28 = 6e-04 - M_2_2_p8;
  const Real M_2_2_p29 = M_2_2_p10 - 0.001;

  // link 18 (right_wrist1), composite inertia
  const Real M_2_2_p30 = c18 * M_2_2_p28 - s18 * M_2_2_p29;
  const Real M_2_2_p31 = 0.0014999985000000002 + M_2_2_p30;
  const Real M_2_2_p32 = 0.28049749700000004 + M_2_2_p15;

  // link 17 (right_lowerarm), composite inertia
  const Real M_2_2_p33 = s17 * M_2_2_p31 + c17 * M_2_2_p32;
  const Real M_2_2_p34 = 0.564 * M_2_2_p33;
  const Real M_2_2_p35 = 0.0019585440854647937 + (M_2_2_p23 + M_2_2_p27 + M_2_2_p34);

  // link 18 (right_wrist1), composite inertia
  const Real M_16_16 = 0.060888541114265754 + (M_2_2_p18 + M_2_2_p22);
  M[400] = M_16_16;

  // link 17 (right_lowerarm), composite inertia
  const Real M_2_2_p36 = 0.0008177492704690715 + (M_16_16 + M_2_2_p34);

  // link 18 (right_wrist1), composite inertia
  const Real M_16_17 = s18 * M_2_2_p9 + c18 * M_2_2_p11;
  M[401] = M_16_17;
  M[424] = M_16_17;
  const Real M_2_2_p37 = 0.0001499998887063 - M_16_17;
  const Real M_2_2_p38 = 2.249994685315e-05 + (c18 * M_2_2_p21 - M_2_2_p20);

  // link 17 (right_lowerarm), composite inertia
  const Real M_2_2_p39 = s17 * M_2_2_p37 - c17 * M_2_2_p38;
  const Real M_2_2_p40 = 4.4999986458742003e-05 + M_2_2_p39;

  // link 16 (right_upperarm), composite inertia
  const Real M_2_2_p41 = c16 * (M_2_2_p35 - M_2_2_p36) + s16 * (2.0 * M_2_2_p40);
  const Real M_2_2_p42 = c16 * M_2_2_p41;
  const Real M_2_2_p43 = 0.18113119219699997 + (M_2_2_p35 - M_2_2_p42);

  // link 17 (right_lowerarm), composite inertia
  const Real M_2_2_p44 = M_2_2_p25 - M_2_2_p27;

  // link 16 (right_upperarm), composite inertia
  const Real M_2_2_p45 = 0.0028970433559338655 + M_2_2_p44;

  // link 17 (right_lowerarm), composite inertia
  const Real M_2_2_p46 = s17 * M_2_2_p32 - c17 * M_2_2_p31;
  const Real M_2_2_p47 = 0.0005895000784280001 + (M_2_2_p13 - c17 * M_2_2_p26 + 0.282 * M_2_2_p46);
  const Real M_15_16 = s17 * M_2_2_p38 + c17 * M_2_2_p37;
  M[376] = -M_15_16;
  M[399] = -M_15_16;

  // link 18 (right_wrist1), composite inertia
  const Real M_2_2_p48 = s18 * M_2_2_p28 + c18 * M_2_2_p29;

  // link 17 (right_lowerarm), composite inertia
  const Real M_2_2_p49 = 0.282 * M_2_2_p48 - M_15_16 - 0.0012089992423205001;

  // link 16 (right_upperarm), composite inertia
  const Real M_2_2_p50 = s16 * M_2_2_p47 - c16 * M_2_2_p49;
  const Real M_2_2_p51 = 5.2499999999999995e-05 + M_2_2_p50;

  // link 15 (right_shoulder2), composite inertia
  const Real M_2_2_p52 = s15 * (M_2_2_p45 - M_2_2_p43) + c15 * (2.0 * M_2_2_p51);
  const Real M_2_2_p53 = s15 * M_2_2_p52;
  const Real M_2_2_p54 = 0.0002975 + (M_2_2_p45 - M_2_2_p53);

  // link 16 (right_upperarm), composite inertia
  const Real M_2_2_p55 = M_2_2_p36 + M_2_2_p42;

  // link 15 (right_shoulder2), composite inertia
  const Real M_2_2_p56 = 0.18140244219699997 + M_2_2_p55;

  // link 16 (right_upperarm), composite inertia
  const Real M_14_15 = c16 * M_2_2_p47 + s16 * M_2_2_p49;
  M[351] = -M_14_15;
  M[374] = -M_14_15;
  const Real M_2_2_p57 = M_14_15 - 0.00010499999999999999;
  const Real M_2_2_p58 = 1.75e-05 - (M_2_2_p40 - s16 * M_2_2_p41);

  // link 15 (right_shoulder2), composite inertia
  const Real M_2_2_p59 = c15 * M_2_2_p57 - s15 * M_2_2_p58;
  const Real M_2_2_p60 = M_2_2_p59 - 8.75e-06;

  // link 14 (right_shoulder1), composite inertia
  const Real M_2_2_p61 = c14 * (M_2_2_p56 - M_2_2_p54) - s14 * (2.0 * M_2_2_p60);

  // link 13 (left_hand), composite inertia
  const Real M_2_2_p62 = 0.000108260010923775 * c13 + 4.38600177048965e-05 * s13;

  // link 12 (left_wrist2), composite inertia
  const Real M_2_2_p63 = c12 * M_2_2_p62;

  // link 13 (left_hand), composite inertia
  const Real M_2_2_p64 = 0.000252780114665025 * c13 - 0.0007556474228594393 * s13;
  const Real M_2_2_p65 = s13 * M_2_2_p64;

  // link 12 (left_wrist2), composite inertia
  const Real M_2_2_p66 = 2.0 * M_2_2_p63 - s12 * (0.000663511853372032 + M_2_2_p65);

  // link 13 (left_hand), composite inertia
  const Real M_2_2_p67 = 0.01626499875 * c13 + 0.002865001425 * s13;
  const Real M_2_2_p68 = 0.0006000000000000001 + M_2_2_p67;

  // link 12 (left_wrist2), composite inertia
  const Real M_2_2_p69 = s12 * M_2_2_p68 - 0.0025100003499999995 * c12;
  const Real M_2_2_p70 = 0.000144 - (M_2_2_p62 - c12 * M_2_2_p66 + 0.269 * M_2_2_p69);

  // link 13 (left_hand), composite inertia
  const Real M_11_12 = 4.38600177048965e-05 * c13 - 0.000108260010923775 * s13;
  M[276] = M_11_12;
  M[299] = M_11_12;
  const Real M_10_11_p1 = c13 * M_2_2_p64 - 0.0001287900573325125;

  // link 12 (left_wrist2), composite inertia
  const Real M_10_11 = s12 * M_11_12 + c12 * M_10_11_p1;
  M[251] = -M_10_11;
  M[274] = -M_10_11;

  // link 13 (left_hand), composite inertia
  const Real M_2_2_p71 = 0.01626499875 * s13 - 0.002865001425 * c13;

  // link 12 (left_wrist2), composite inertia
  const Real M_2_2_p72 = 0.0002516 + (0.269 * M_2_2_p71 - M_10_11);

  // link 11 (left_wrist1), composite inertia
  const Real M_2_2_p73 = c11 * M_2_2_p70 - s11 * M_2_2_p72;
  const Real M_2_2_p74 = 0.0001499998887063 + M_2_2_p73;

  // link 12 (left_wrist2), composite inertia
  const Real M_2_2_p75 = s12 * M_2_2_p66;
  const Real M_2_2_p76 = 0.0025100003499999995 * s12 + c12 * M_2_2_p68;
  const Real M_2_2_p77 = 0.538 * M_2_2_p76;
  const Real M_2_2_p78 = 0.0010696316083993107 + M_2_2_p75 + M_2_2_p77;

  // link 13 (left_hand), composite inertia
  const Real M_11_11 = 0.001053967177886718 + M_2_2_p65;
  M[275] = M_11_11;

  // link 12 (left_wrist2), composite inertia
  const Real M_2_2_p79 = 0.0001098 + (M_11_11 + M_2_2_p77);
  const Real M_2_2_p80 = s12 * M_10_11_p1 - c12 * M_11_12;
  const Real M_2_2_p81 = 6e-06 + M_2_2_p80;

  // link 11 (left_wrist1), composite inertia
  const Real M_2_2_p82 = s11 * (M_2_2_p78 - M_2_2_p79) - c11 * (2.0 * M_2_2_p81);
  const Real M_2_2_p83 = s11 * M_2_2_p82;
  const Real M_2_2_p84 = 0.06060754126741261 + (M_2_2_p78 - M_2_2_p83);

  // link 12 (left_wrist2), composite inertia
  const Real M_2_2_p85 = 0.0002867197550272787 - M_2_2_p65 - M_2_2_p75;

  // link 11 (left_wrist1), composite inertia
  const Real M_2_2_p86 = 0.00051019984685315 + M_2_2_p85;

  // link 10 (left_lowerarm), composite inertia
  const Real M_2_2_p87 = c10 * (2.0 * M_2_2_p74) - s10 * (M_2_2_p84 - M_2_2_p86);
  const Real M_2_2_p88 = s10 * M_2_2_p87;

  // link 12 (left_wrist2), composite inertia
  const Real M_2_2_p89 = 6e-04 - M_2_2_p69;
  const Real M_2_2_p90 = 0.001 + M_2_2_p71;

  // link 11 (left_wrist1), composite inertia
  const Real M_2_2_p91 = c11 * M_2_2_p89 - s11 * M_2_2_p90;
  const Real M_2_2_p92 = 0.0014999985000000002 + M_2_2_p91;
  const Real M_2_2_p93 = 0.28049749700000004 + M_2_2_p76;

  // link 10 (left_lowerarm), composite inertia
  const Real M_2_2_p94 = s10 * M_2_2_p92 + c10 * M_2_2_p93;
  const Real M_2_2_p95 = 0.564 * M_2_2_p94;
  const Real M_2_2_p96 = 0.0019585440854647937 + (M_2_2_p84 + M_2_2_p88 + M_2_2_p95);

  // link 11 (left_wrist1), composite inertia
  const Real M_9_9 = 0.060888541114265754 + (M_2_2_p79 + M_2_2_p83);
  M[225] = M_9_9;

  // link 10 (left_lowerarm), composite inertia
  const Real M_2_2_p97 = 0.0008177492704690715 + (M_9_9 + M_2_2_p95);

  // link 11 (left_wrist1), composite inertia
  const Real M_2_2_p98 = c11 * M_2_2_p82 + M_2_2_p81 - 2.249994685315e-05;
  const Real M_9_10 = s11 * M_2_2_p70 + c11 * M_2_2_p72;
  M[226] = M_9_10;
  M[249] = M_9_10;
  const Real M_2_2_p99 = 0.0001499998887063 + M_9_10;

  // link 10 (left_lowerarm), composite inertia
  const Real M_2_2_p100 = c10 * M_2_2_p98 + s10 * M_2_2_p99;
  const Real M_2_2_p101 = 4.4999986458742003e-05 + M_2_2_p100;

  // link 9 (left_upperarm), composite inertia
  const Real M_2_2_p102 = c9 * (M_2_2_p96 - M_2_2_p97) - s9 * (2.0 * M_2_2_p101);
  const Real M_2_2_p103 = c9 * M_2_2_p102;
  const Real M_2_2_p104 = 0.18113119219699997 + (M_2_2_p96 - M_2_2_p103);

  // link 10 (left_lowerarm), composite inertia
  const Real M_2_2_p105 = M_2_2_p86 - M_2_2_p88;

  // link 9 (left_upperarm), composite inertia
  const Real M_2_2_p106 = 0.0028970433559338655 + M_2_2_p105;

  // link 10 (left_lowerarm), composite inertia
  const Real M_2_2_p107 = s10 * M_2_2_p93 - c10 * M_2_2_p92;
  const Real M_2_2_p108 = 0.0005895000784280001 + (M_2_2_p74 - c10 * M_2_2_p87 + 0.282 *
      M_2_2_p107);
  const Real M_8_9 = c10 * M_2_2_p99 - s10 * M_2_2_p98;
  M[201] = M_8_9;
  M[224] = M_8_9;

  // link 11 (left_wrist1), composite inertia
  const Real M_2_2_p109 = s11 * M_2_2_p89 + c11 * M_2_2_p90;

  // link 10 (left_lowerarm), composite inertia
  const Real M_2_2_p110 = 0.0012089992423205001 + (M_8_9 + 0.282 * M_2_2_p109);

  // link 9 (left_upperarm), composite inertia
  const Real M_2_2_p111 = s9 * M_2_2_p108 - c9 * M_2_2_p110;
  const Real M_2_2_p112 = M_2_2_p111 - 5.2499999999999995e-05;

  // link 8 (left_shoulder2), composite inertia
  const Real M_2_2_p113 = s8 * (M_2_2_p106 - M_2_2_p104) + c8 * (2.0 * M_2_2_p112);
  const Real M_2_2_p114 = s8 * M_2_2_p113;
  const Real M_2_2_p115 = 0.0002975 + (M_2_2_p106 - M_2_2_p114);

  // link 9 (left_upperarm), composite inertia
  const Real M_2_2_p116 = M_2_2_p97 + M_2_2_p103;

  // link 8 (left_shoulder2), composite inertia
  const Real M_2_2_p117 = 0.18140244219699997 + M_2_2_p116;

  // link 9 (left_upperarm), composite inertia
  const Real M_7_8 = c9 * M_2_2_p108 + s9 * M_2_2_p110;
  M[176] = -M_7_8;
  M[199] = -M_7_8;
  const Real M_2_2_p118 = M_7_8 - 0.00010499999999999999;
  const Real M_2_2_p119 = s9 * M_2_2_p102 + M_2_2_p101 - 1.75e-05;

  // link 8 (left_shoulder2), composite inertia
  const Real M_2_2_p120 = c8 * M_2_2_p118 - s8 * M_2_2_p119;
  const Real M_2_2_p121 = M_2_2_p120 - 8.75e-06;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p122 = c7 * (M_2_2_p117 - M_2_2_p115) - s7 * (2.0 * M_2_2_p121);
  const Real M_2_2_p123 = c14 * M_2_2_p61 + c7 * M_2_2_p122;

  // link 24 (right_eye), composite inertia
  const Real M_2_2_p124 = 2.375e-05 * c24 - 8e-06 * s24;

  // link 23 (left_eye), composite inertia
  const Real M_2_2_p125 = 2.375e-05 * c23 + 8e-06 * s23;
  const Real M_2_2_p126 = 0.009457125 + 2.0 * (M_2_2_p124 + M_2_2_p125);

  // link 24 (right_eye), composite inertia
  const Real M_2_2_p127 = 1.2499999999999999e-06 * s24;

  // link 23 (left_eye), composite inertia
  const Real M_2_2_p128 = 1.2499999999999999e-06 * s23;
  const Real M_2_2_p129 = s24 * M_2_2_p127 + s23 * M_2_2_p128;
  const Real M_2_2_p130 = 0.05451070000000001 + M_2_2_p129 + 1.6e-05 * (s23 - s24);

  // link 24 (right_eye), composite inertia
  const Real M_2_2_p131 = 2.8750000000000004e-05 * c24;

  // link 23 (left_eye), composite inertia
  const Real M_2_2_p132 = 2.8750000000000004e-05 * c23;
  const Real M_2_2_p133 = 0.0074 + M_2_2_p131 + M_2_2_p132;

  // link 22 (head), composite inertia
  const Real M_2_2_p134 = s22 * (M_2_2_p130 - M_2_2_p126) + c22 * (2.0 * M_2_2_p133);
  const Real M_2_2_p135 = s22 * M_2_2_p134;
  const Real M_2_2_p136 = M_2_2_p126 + M_2_2_p135;

  // link 10 (left_lowerarm), composite inertia
  const Real M_2_2_p137 = 0.0022500062 + M_2_2_p107;
  const Real M_2_2_p138 = 0.004500002325 + M_2_2_p109;

  // link 9 (left_upperarm), composite inertia
  const Real M_2_2_p139 = s9 * M_2_2_p137 - c9 * M_2_2_p138;
  const Real M_2_2_p140 = 0.0017499999999999998 - M_2_2_p139;
  const Real M_2_2_p141 = 0.7139200499999999 + M_2_2_p94;

  // link 8 (left_shoulder2), composite inertia
  const Real M_2_2_p142 = s8 * M_2_2_p141 + c8 * M_2_2_p140;

  // link 17 (right_lowerarm), composite inertia
  const Real M_2_2_p143 = 0.0022500062 + M_2_2_p46;
  const Real M_2_2_p144 = M_2_2_p48 - 0.004500002325;

  // link 16 (right_upperarm), composite inertia
  const Real M_2_2_p145 = s16 * M_2_2_p143 - c16 * M_2_2_p144;
  const Real M_2_2_p146 = 0.0017499999999999998 + M_2_2_p145;
  const Real M_2_2_p147 = 0.7139200499999999 + M_2_2_p33;

  // link 15 (right_shoulder2), composite inertia
  const Real M_2_2_p148 = s15 * M_2_2_p147 - c15 * M_2_2_p146;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p149 = 0.40663174999999996 + M_2_2_p136 + M_2_2_p56 - M_2_2_p123 + M_2_2_p117 +
      0.36 * (M_2_2_p142 - M_2_2_p148);

  // link 15 (right_shoulder2), composite inertia
  const Real M_13_13 = 0.000448 + (M_2_2_p43 + M_2_2_p53);
  M[325] = M_13_13;

  // link 24 (right_eye), composite inertia
  const Real M_2_2_p150 = 0.00025 * c24;

  // link 23 (left_eye), composite inertia
  const Real M_2_2_p151 = 0.00025 * c23;
  const Real M_2_2_p152 = 0.072575 + M_2_2_p150 + M_2_2_p151;

  // link 22 (head), composite inertia
  const Real M_2_2_p153 = 0.43200000000000005 * c22 - s22 * M_2_2_p152;
  const Real M_2_2_p154 = 0.788 * M_2_2_p153;
  const Real M_2_2_p155 = M_2_2_p130 - M_2_2_p135 + M_2_2_p154;

  // link 23 (left_eye), composite inertia
  const Real M_21_21 = 0.063951825 - M_2_2_p129 + 4.75e-05 * (c24 + c23);
  M[525] = M_21_21;

  // link 22 (head), composite inertia
  const Real M_2_2_p156 = M_21_21 + M_2_2_p154;

  // link 23 (left_eye), composite inertia
  const Real M_2_2_p157 = (8e-06 + M_2_2_p128) * c23 + 2.375e-05 * (s24 + s23) +
      (M_2_2_p127 - 8e-06) * c24;

  // link 24 (right_eye), composite inertia
  const Real M_21_23 = 2.8750000000000004e-05 * s24;
  M[527] = -M_21_23;
  M[573] = -M_21_23;

  // link 23 (left_eye), composite inertia
  const Real M_21_22 = 2.8750000000000004e-05 * s23;
  M[526] = -M_21_22;
  M[549] = -M_21_22;
  const Real M_2_2_p158 = M_21_23 + M_21_22;

  // link 22 (head), composite inertia
  const Real M_2_2_p159 = c22 * M_2_2_p157 + s22 * M_2_2_p158;

  // link 21 (neck), composite inertia
  const Real M_2_2_p160 = s21 * M_2_2_p159;
  const Real M_2_2_p161 = c21 * (0.005513625 + M_2_2_p155 - (0.000703125 + M_2_2_p156)) + 2.0 *
      M_2_2_p160;
  const Real M_2_2_p162 = c21 * M_2_2_p161;

  // link 8 (left_shoulder2), composite inertia
  const Real M_6_6 = 0.000448 + (M_2_2_p104 + M_2_2_p114);
  M[150] = M_6_6;

  // link 16 (right_upperarm), composite inertia
  const Real M_2_2_p163 = c16 * M_2_2_p143 + s16 * M_2_2_p144;

  // link 15 (right_shoulder2), composite inertia
  const Real M_2_2_p164 = 0.0017499999999999998 - M_2_2_p163;
  const Real M_2_2_p165 = c15 * M_2_2_p147 + s15 * M_2_2_p146;
  const Real M_2_2_p166 = M_2_2_p165 - 0.0017499999999999998;

  // link 14 (right_shoulder1), composite inertia
  const Real M_2_2_p167 = s14 * M_2_2_p164 + c14 * M_2_2_p166;

  // link 9 (left_upperarm), composite inertia
  const Real M_2_2_p168 = c9 * M_2_2_p137 + s9 * M_2_2_p138;

  // link 8 (left_shoulder2), composite inertia
  const Real M_2_2_p169 = 0.0017499999999999998 - M_2_2_p168;
  const Real M_2_2_p170 = c8 * M_2_2_p141 - s8 * M_2_2_p140;
  const Real M_2_2_p171 = M_2_2_p170 - 0.0017499999999999998;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p172 = s7 * M_2_2_p169 + c7 * M_2_2_p171;
  const Real M_2_2_p173 = M_2_2_p167 + M_2_2_p172;
  const Real M_2_2_p174 = 1.67475326092404 + M_2_2_p155 - M_2_2_p162 + M_13_13 + M_6_6 - 0.452 *
      M_2_2_p173;

  // link 15 (right_shoulder2), composite inertia
  const Real M_13_14 = s15 * M_2_2_p57 + c15 * M_2_2_p58;
  M[326] = M_13_14;
  M[349] = M_13_14;
  const Real M_2_2_p175 = 2.6249999999999998e-05 + M_13_14;
  const Real M_2_2_p176 = 2.6249999999999998e-05 + (c15 * M_2_2_p52 - M_2_2_p51);

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p177 = s14 * M_2_2_p175 + c14 * M_2_2_p176 + 0.18 * M_2_2_p167;

  // link 22 (head), composite inertia
  const Real M_2_2_p178 = c22 * M_2_2_p152 + 0.43200000000000005 * s22;
  const Real M_2_2_p179 = 0.0016155 + (c22 * M_2_2_p134 - M_2_2_p133 + 0.394 * M_2_2_p178);
  const Real M_20_21 = s22 * M_2_2_p157 - c22 * M_2_2_p158;
  M[501] = M_20_21;
  M[524] = M_20_21;

  // link 24 (right_eye), composite inertia
  const Real M_2_2_p180 = 0.00025 * s24;

  // link 23 (left_eye), composite inertia
  const Real M_2_2_p181 = 0.00025 * s23;
  const Real M_2_2_p182 = M_2_2_p180 + M_2_2_p181;

  // link 22 (head), composite inertia
  const Real M_2_2_p183 = M_20_21 - 0.394 * M_2_2_p182;

  // link 21 (neck), composite inertia
  const Real M_2_2_p184 = s21 * M_2_2_p179 - c21 * M_2_2_p183;

  // link 8 (left_shoulder2), composite inertia
  const Real M_6_7 = s8 * M_2_2_p118 + c8 * M_2_2_p119;
  M[151] = M_6_7;
  M[174] = M_6_7;
  const Real M_2_2_p185 = M_6_7 - 2.6249999999999998e-05;
  const Real M_2_2_p186 = c8 * M_2_2_p113 - M_2_2_p112 - 2.6249999999999998e-05;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p187 = s7 * M_2_2_p185 + c7 * M_2_2_p186 - 0.18 * M_2_2_p172;
  const Real M_2_2_p188 = M_2_2_p148 + M_2_2_p142;
  const Real M_2_2_p189 = M_2_2_p184 + M_2_2_p177 + M_2_2_p187 + 0.226 * M_2_2_p188;

  // link 6 (chest3), composite inertia
  const Real M_2_2_p190 = s6 * (M_2_2_p149 - M_2_2_p174) + c6 * (2.0 * M_2_2_p189);
  const Real M_2_2_p191 = s6 * M_2_2_p190;
  const Real M_2_2_p192 = 0.04675382692737882 + (M_2_2_p149 - M_2_2_p191);

  // link 7 (left_shoulder1), composite inertia
  const Real M_5_5_p1 = 0.226 * M_2_2_p172;

  // link 14 (right_shoulder1), composite inertia
  const Real M_5_5_p2 = 0.226 * M_2_2_p167;

  // link 7 (left_shoulder1), composite inertia
  const Real M_5_5 = 2.07035776092404 + M_2_2_p156 + M_2_2_p162 + M_2_2_p54 + M_2_2_p123 +
      M_2_2_p115 + 2.0 * (0.18 * M_2_2_p142 - M_5_5_p1 - (M_5_5_p2 + 0.18 * M_2_2_p148));
  M[125] = M_5_5;
  const Real M_2_2_p193 = M_2_2_p173 - 6.1665928899999995 - M_2_2_p153;

  // link 22 (head), composite inertia
  const Real M_2_2_p194 = 0.0045000000000000005 + M_2_2_p178;

  // link 21 (neck), composite inertia
  const Real M_2_2_p195 = s21 * M_2_2_p194 + c21 * M_2_2_p182;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p196 = M_2_2_p195 + M_2_2_p188;

  // link 6 (chest3), composite inertia
  const Real M_2_2_p197 = c6 * M_2_2_p193 - s6 * M_2_2_p196;
  const Real M_2_2_p198 = 0.144 * M_2_2_p197;
  const Real M_2_2_p199 = 0.15637308509675518 + (M_5_5 - M_2_2_p198);

  // link 21 (neck), composite inertia
  const Real M_5_20 = c21 * M_2_2_p179 + s21 * M_2_2_p183;
  M[140] = -M_5_20;
  M[485] = -M_5_20;

  // link 14 (right_shoulder1), composite inertia
  const Real M_2_2_p200 = c14 * M_2_2_p164 - s14 * M_2_2_p166;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p201 = c7 * M_2_2_p169 - s7 * M_2_2_p171;
  const Real M_2_2_p202 = M_2_2_p200 + M_2_2_p201;
  const Real M_2_2_p203 = 0.0187369177636143 + M_5_20 + s14 * M_2_2_p61 + M_2_2_p60 + s7 *
      M_2_2_p122 + M_2_2_p121 + 0.226 * M_2_2_p202;

  // link 14 (right_shoulder1), composite inertia
  const Real M_5_13 = c14 * M_2_2_p175 - s14 * M_2_2_p176 + 0.18 * M_2_2_p200;
  M[133] = M_5_13;
  M[317] = M_5_13;

  // link 7 (left_shoulder1), composite inertia
  const Real M_5_6 = c7 * M_2_2_p185 - s7 * M_2_2_p186 - 0.18 * M_2_2_p201;
  M[126] = M_5_6;
  M[149] = M_5_6;
  const Real M_2_2_p204 = M_5_13 - (M_2_2_p159 - s21 * M_2_2_p161) + M_5_6;

  // link 6 (chest3), composite inertia
  const Real M_2_2_p205 = c6 * M_2_2_p203 - s6 * M_2_2_p204;

  // link 21 (neck), composite inertia
  const Real M_2_2_p206 = c21 * M_2_2_p194 - s21 * M_2_2_p182;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p207 = M_2_2_p206 + M_2_2_p202;

  // link 6 (chest3), composite inertia
  const Real M_2_2_p208 = 0.005678398088837119 + (M_2_2_p205 + 0.072 * M_2_2_p207);

  // link 5 (chest2), composite inertia
  const Real M_2_2_p209 = s5 * (M_2_2_p199 - M_2_2_p192) + c5 * (2.0 * M_2_2_p208);
  const Real M_2_2_p210 = s5 * M_2_2_p209;

  // link 6 (chest3), composite inertia
  const Real M_2_2_p211 = 0.069699984375 + M_2_2_p207;
  const Real M_2_2_p212 = M_2_2_p197 - 2.2194301519999997;

  // link 5 (chest2), composite inertia
  const Real M_2_2_p213 = s5 * M_2_2_p211 + c5 * M_2_2_p212;
  const Real M_2_2_p214 = 0.43599999999999994 * M_2_2_p213;

  // link 6 (chest3), composite inertia
  const Real M_4_4 = 0.203126912024134 + (M_2_2_p174 + M_2_2_p191 - M_2_2_p198);
  M[100] = M_4_4;

  // link 5 (chest2), composite inertia
  const Real M_2_2_p215 = 0.01227760324629517 + (M_4_4 - M_2_2_p214);

  // link 6 (chest3), composite inertia
  const Real M_2_2_p216 = s6 * M_2_2_p193 + c6 * M_2_2_p196;
  const Real M_2_2_p217 = c6 * M_2_2_p190 - M_2_2_p189 + 0.072 * M_2_2_p216;
  const Real M_4_5 = s6 * M_2_2_p203 + c6 * M_2_2_p204;
  M[101] = M_4_5;
  M[124] = M_4_5;

  // link 5 (chest2), composite inertia
  const Real M_2_2_p218 = s5 * M_2_2_p217 - c5 * M_4_5;

  // link 4 (chest1), composite inertia
  const Real M_2_2_p219 = s4 * (0.0478915 + (M_2_2_p199 - M_2_2_p210 - M_2_2_p214) - M_2_2_p215) -
      c4 * (2.0 * M_2_2_p218);
  const Real M_2_2 = 1.7824817919087104 + (M_2_2_p215 + s4 * M_2_2_p219);
  M[50] = M_2_2;
  const Real M_1_1_p1 = M_2_2_p213 - 8.419374554;

  // link 5 (chest2), composite inertia
  const Real M_1_1_p2 = s5 * M_2_2_p212 - c5 * M_2_2_p211;
  const Real M_1_1_p3 = 0.0300000063 + M_1_1_p2;

  // link 4 (chest1), composite inertia
  const Real M_1_1_p4 = 0.02999999505 + (c4 * M_1_1_p3 + s4 * M_2_2_p216);

  // link 3 (hip), composite inertia
  const Real M_1_1_p5 = c3 * M_1_1_p1 - s3 * M_1_1_p4;
  const Real M_1_1 = 9.885744550888212 + (M_2_2 - 0.844 * M_1_1_p5);
  M[25] = M_1_1;
  const Real M_0_0_p1 = c3 * M_1_1_p4 + s3 * M_1_1_p1;

  // link 2 (thigh), composite inertia
  const Real M_0_0_p2 = s2 * (0.031999971599999996 - M_0_0_p1) + c2 * (M_1_1_p5 - 24.5839218);
  M[0] = 13.049859506913753 + (M_1_1 - 0.868 * M_0_0_p2);

  // link 2 (thigh), mass matrix
  const Real M_0_1 = M_1_1 - 0.434 * M_0_0_p2;
  M[1] = M_0_1;
  M[24] = M_0_1;

  // link 3 (hip), mass matrix
  const Real M_1_2 = M_2_2 - 0.422 * M_1_1_p5;
  M[26] = M_1_2;
  M[49] = M_1_2;
  const Real M_0_2 = M_1_2 + 0.434 * (s2 * M_0_0_p1 - c2 * M_1_1_p5);
  M[2] = M_0_2;
  M[48] = M_0_2;

  // link 5 (chest2), composite inertia
  const Real M_3_4 = s5 * M_4_5 + c5 * M_2_2_p217;
  M[76] = -M_3_4;
  M[99] = -M_3_4;

  // link 4 (chest1), composite inertia
  const Real M_2_3 = s4 * (0.005880002159562879 + (0.21799999999999997 * M_1_1_p2 -
      (c5 * M_2_2_p209 - M_2_2_p208))) - c4 * (M_3_4 + 0.21799999999999997 * M_2_2_p216);
  M[51] = M_2_3;
  M[74] = M_2_3;

  // link 4 (chest1), mass matrix
  const Real M_1_3_p1 = s4 * M_1_1_p3 - c4 * M_2_2_p216;
  const Real M_1_3_p2 = c3 * M_1_3_p1;
  const Real M_1_3 = M_2_3 + 0.422 * M_1_3_p2;
  M[27] = M_1_3;
  M[73] = M_1_3;
  const Real M_0_3 = M_1_3 + 0.434 * (c2 * M_1_3_p2 - s2 * (s3 * M_1_3_p1));
  M[3] = M_0_3;
  M[72] = M_0_3;

  // link 5 (chest2), mass matrix
  const Real M_2_4 = c4 * (M_4_4 - 0.21799999999999997 * M_2_2_p213) - s4 * M_2_2_p218;
  M[52] = M_2_4;
  M[98] = M_2_4;
  const Real M_1_4_p1 = c4 * M_2_2_p213;
  const Real M_1_4_p2 = s3 * M_1_1_p2 - c3 * M_1_4_p1;
  const Real M_1_4 = M_2_4 + 0.422 * M_1_4_p2;
  M[28] = M_1_4;
  M[97] = M_1_4;
  const Real M_0_4 = M_1_4 + 0.434 * (c2 * M_1_4_p2 + s2 * (s3 * M_1_4_p1 + c3 * M_1_1_p2));
  M[4] = M_0_4;
  M[96] = M_0_4;

  // link 6 (chest3), mass matrix
  const Real M_2_5_p1 = s5 * M_2_2_p216;
  const Real M_2_5_p2 = M_5_5 - 0.072 * M_2_2_p197;
  const Real M_2_5 = c4 * (M_4_5 + 0.21799999999999997 * M_2_5_p1) - s4 *
      (s5 * M_2_2_p205 - c5 * M_2_5_p2 + 0.21799999999999997 * M_2_2_p197);
  M[53] = M_2_5;
  M[122] = M_2_5;
  const Real M_1_5_p1 = c4 * M_2_5_p1 - s4 * M_2_2_p197;
  const Real M_1_5_p2 = c5 * M_2_2_p216;
  const Real M_1_5_p3 = c3 * M_1_5_p1 + s3 * M_1_5_p2;
  const Real M_1_5 = M_2_5 + 0.422 * M_1_5_p3;
  M[29] = M_1_5;
  M[121] = M_1_5;
  const Real M_0_5 = M_1_5 + 0.434 * (c2 * M_1_5_p3 - s2 * (s3 * M_1_5_p1 - c3 * M_1_5_p2));
  M[5] = M_0_5;
  M[120] = M_0_5;

  // link 7 (left_shoulder1), mass matrix
  const Real M_2_6_p1 = M_6_6 - M_5_5_p1;
  const Real M_2_6_p2 = c6 * M_2_2_p187 - s6 * M_2_6_p1;
  const Real M_2_6_p3 = s6 * M_2_2_p201;
  const Real M_2_6_p4 = M_5_6 - 0.072 * M_2_6_p3;
  const Real M_4_6 = s6 * M_2_2_p187 + c6 * M_2_6_p1 - 0.072 * M_2_2_p172;
  M[102] = M_4_6;
  M[148] = M_4_6;
  const Real M_2_6_p5 = c6 * M_2_2_p201;
  const Real M_2_6_p6 = c5 * M_2_2_p172 + s5 * M_2_6_p5;
  const Real M_2_6 = c4 * (M_4_6 - 0.21799999999999997 * M_2_6_p6) - s4 *
      (0.21799999999999997 * M_2_6_p3 + (s5 * M_2_6_p2 - c5 * M_2_6_p4));
  M[54] = M_2_6;
  M[146] = M_2_6;
  const Real M_1_6_p1 = s5 * M_2_2_p172 - c5 * M_2_6_p5;
  const Real M_1_6_p2 = s4 * M_2_6_p3 + c4 * M_2_6_p6;
  const Real M_1_6_p3 = s3 * M_1_6_p1 - c3 * M_1_6_p2;
  const Real M_1_6 = M_2_6 + 0.422 * M_1_6_p3;
  M[30] = M_1_6;
  M[145] = M_1_6;
  const Real M_0_6 = M_1_6 + 0.434 * (c2 * M_1_6_p3 + s2 * (s3 * M_1_6_p2 + c3 * M_1_6_p1));
  M[6] = M_0_6;
  M[144] = M_0_6;

  // link 9 (left_upperarm), composite inertia
  const Real M_7_7 = 0.18125194219699997 + M_2_2_p116;
  M[175] = M_7_7;

  // link 8 (left_shoulder2), mass matrix
  const Real M_4_7_p1 = s7 * M_2_2_p142;
  const Real M_4_7_p2 = s7 * M_7_7 + c7 * M_2_2_p120 + 0.18 * M_4_7_p1;
  const Real M_4_7_p3 = M_6_7 + 0.226 * M_4_7_p1;
  const Real M_4_7 = s6 * M_4_7_p2 + c6 * M_4_7_p3 + 0.072 * M_4_7_p1;
  M[103] = M_4_7;
  M[172] = M_4_7;
  const Real M_2_7_p1 = c7 * M_2_2_p142;
  const Real M_2_7_p2 = c6 * M_2_7_p1 + s6 * M_2_2_p170;
  const Real M_2_7_p3 = c5 * M_4_7_p1 + s5 * M_2_7_p2;
  const Real M_2_7_p4 = c6 * M_4_7_p2 - s6 * M_4_7_p3;
  const Real M_5_7 = c7 * M_7_7 - s7 * M_2_2_p120 + (0.18 * M_2_7_p1 - 0.226 * M_2_2_p170);
  M[127] = M_5_7;
  M[173] = M_5_7;
  const Real M_2_7_p5 = c6 * M_2_2_p170 - s6 * M_2_7_p1;
  const Real M_2_7_p6 = M_5_7 - 0.072 * M_2_7_p5;
  const Real M_2_7 = c4 * (M_4_7 + 0.21799999999999997 * M_2_7_p3) - s4 *
      (s5 * M_2_7_p4 - c5 * M_2_7_p6 + 0.21799999999999997 * M_2_7_p5);
  M[55] = M_2_7;
  M[170] = M_2_7;
  const Real M_1_7_p1 = c4 * M_2_7_p3 - s4 * M_2_7_p5;
  const Real M_1_7_p2 = c5 * M_2_7_p2 - s5 * M_4_7_p1;
  const Real M_1_7_p3 = c3 * M_1_7_p1 + s3 * M_1_7_p2;
  const Real M_1_7 = M_2_7 + 0.422 * M_1_7_p3;
  M[31] = M_1_7;
  M[169] = M_1_7;
  const Real M_0_7 = M_1_7 + 0.434 * (c2 * M_1_7_p3 - s2 * (s3 * M_1_7_p1 - c3 * M_1_7_p2));
  M[7] = M_0_7;
  M[168] = M_0_7;

  // link 10 (left_lowerarm), composite inertia
  const Real M_8_8 = 0.0027762933559338653 + M_2_2_p105;
  M[200] = M_8_8;

  // link 9 (left_upperarm), mass matrix
  const Real M_2_8_p1 = s8 * M_2_2_p111 - c8 * M_8_8;
  const Real M_2_8_p2 = s8 * M_2_2_p168;
  const Real M_2_8_p3 = c7 * M_2_2_p139 - s7 * M_2_8_p2;
  const Real M_2_8_p4 = 0.18 * M_2_8_p3 - (s7 * M_7_8 - c7 * M_2_8_p1);
  const Real M_6_8 = s8 * M_8_8 + c8 * M_2_2_p111;
  M[152] = -M_6_8;
  M[198] = -M_6_8;
  const Real M_2_8_p5 = 0.226 * M_2_8_p3 - M_6_8;
  const Real M_2_8_p6 = c6 * M_2_8_p4 - s6 * M_2_8_p5;
  const Real M_5_8_p1 = s7 * M_2_2_p139 + c7 * M_2_8_p2;
  const Real M_5_8_p2 = c8 * M_2_2_p168;
  const Real M_5_8 = 0.226 * M_5_8_p2 - 0.18 * M_5_8_p1 - (c7 * M_7_8 + s7 * M_2_8_p1);
  M[128] = M_5_8;
  M[197] = M_5_8;
  const Real M_2_8_p7 = s6 * M_5_8_p1 - c6 * M_5_8_p2;
  const Real M_2_8_p8 = M_5_8 - 0.072 * M_2_8_p7;
  const Real M_4_8 = s6 * M_2_8_p4 + c6 * M_2_8_p5 + 0.072 * M_2_8_p3;
  M[104] = M_4_8;
  M[196] = M_4_8;
  const Real M_2_8_p9 = c6 * M_5_8_p1 + s6 * M_5_8_p2;
  const Real M_2_8_p10 = s5 * M_2_8_p9 - c5 * M_2_8_p3;
  const Real M_2_8 = c4 * (M_4_8 - 0.21799999999999997 * M_2_8_p10) - s4 *
      (s5 * M_2_8_p6 - c5 * M_2_8_p8 + 0.21799999999999997 * M_2_8_p7);
  M[56] = M_2_8;
  M[194] = M_2_8;
  const Real M_1_8_p1 = c4 * M_2_8_p10 + s4 * M_2_8_p7;
  const Real M_1_8_p2 = s5 * M_2_8_p3 + c5 * M_2_8_p9;
  const Real M_1_8_p3 = c3 * M_1_8_p1 + s3 * M_1_8_p2;
  const Real M_1_8 = M_2_8 - 0.422 * M_1_8_p3;
  M[32] = M_1_8;
  M[193] = M_1_8;
  const Real M_0_8 = M_1_8 - 0.434 * (c2 * M_1_8_p3 + s2 * (c3 * M_1_8_p2 - s3 * M_1_8_p1));
  M[8] = M_0_8;
  M[192] = M_0_8;

  // link 10 (left_lowerarm), mass matrix
  const Real M_2_9_p1 = M_9_9 + 0.282 * M_2_2_p94;
  const Real M_2_9_p2 = s9 * M_2_2_p100 + c9 * M_2_9_p1;
  const Real M_2_9_p3 = c8 * M_8_9 + s8 * M_2_9_p2;
  const Real M_7_9 = c9 * M_2_2_p100 - s9 * M_2_9_p1;
  M[177] = M_7_9;
  M[223] = M_7_9;
  const Real M_2_9_p4 = s9 * M_2_2_p94;
  const Real M_2_9_p5 = s8 * M_2_9_p4 - c8 * M_2_2_p107;
  const Real M_2_9_p6 = c9 * M_2_2_p94;
  const Real M_2_9_p7 = c7 * M_2_9_p6 + s7 * M_2_9_p5;
  const Real M_2_9_p8 = c7 * M_2_9_p3 - s7 * M_7_9 + 0.18 * M_2_9_p7;
  const Real M_6_9 = c8 * M_2_9_p2 - s8 * M_8_9;
  M[153] = M_6_9;
  M[222] = M_6_9;
  const Real M_2_9_p9 = M_6_9 - 0.226 * M_2_9_p7;
  const Real M_2_9_p10 = c6 * M_2_9_p8 + s6 * M_2_9_p9;
  const Real M_5_9_p1 = s8 * M_2_2_p107 + c8 * M_2_9_p4;
  const Real M_5_9_p2 = s7 * M_2_9_p6 - c7 * M_2_9_p5;
  const Real M_5_9 = c7 * M_7_9 + s7 * M_2_9_p3 + (0.226 * M_5_9_p1 + 0.18 * M_5_9_p2);
  M[129] = M_5_9;
  M[221] = M_5_9;
  const Real M_2_9_p11 = s6 * M_5_9_p2 + c6 * M_5_9_p1;
  const Real M_2_9_p12 = M_5_9 + 0.072 * M_2_9_p11;
  const Real M_4_9 = c6 * M_2_9_p9 - s6 * M_2_9_p8 - 0.072 * M_2_9_p7;
  M[105] = M_4_9;
  M[220] = M_4_9;
  const Real M_2_9_p13 = s6 * M_5_9_p1 - c6 * M_5_9_p2;
  const Real M_2_9_p14 = c5 * M_2_9_p7 + s5 * M_2_9_p13;
  const Real M_2_9 = s4 * (c5 * M_2_9_p12 + s5 * M_2_9_p10 + 0.21799999999999997 * M_2_9_p11) + c4 *
      (M_4_9 - 0.21799999999999997 * M_2_9_p14);
  M[57] = M_2_9;
  M[218] = M_2_9;
  const Real M_1_9_p1 = s4 * M_2_9_p11 - c4 * M_2_9_p14;
  const Real M_1_9_p2 = s5 * M_2_9_p7 - c5 * M_2_9_p13;
  const Real M_1_9_p3 = c3 * M_1_9_p1 + s3 * M_1_9_p2;
  const Real M_1_9 = M_2_9 + 0.422 * M_1_9_p3;
  M[33] = M_1_9;
  M[217] = M_1_9;
  const Real M_0_9 = M_1_9 + 0.434 * (c2 * M_1_9_p3 - s2 * (s3 * M_1_9_p1 - c3 * M_1_9_p2));
  M[9] = M_0_9;
  M[216] = M_0_9;

  // link 12 (left_wrist2), composite inertia
  const Real M_10_10 = 0.00022920000000000001 + M_2_2_p85;
  M[250] = M_10_10;

  // link 11 (left_wrist1), mass matrix
  const Real M_2_10_p1 = c10 * M_2_2_p73 + s10 * M_10_10 + 0.282 * M_2_2_p91;
  const Real M_2_10_p2 = c10 * M_2_2_p109;
  const Real M_2_10_p3 = M_9_10 + 0.282 * M_2_10_p2;
  const Real M_2_10_p4 = s9 * M_2_10_p1 + c9 * M_2_10_p3;
  const Real M_8_10 = c10 * M_10_10 - s10 * M_2_2_p73;
  M[202] = M_8_10;
  M[248] = M_8_10;
  const Real M_2_10_p5 = c8 * M_8_10 + s8 * M_2_10_p4;
  const Real M_7_10 = c9 * M_2_10_p1 - s9 * M_2_10_p3;
  M[178] = M_7_10;
  M[247] = M_7_10;
  const Real M_2_10_p6 = c9 * M_2_10_p2 + s9 * M_2_2_p91;
  const Real M_2_10_p7 = s9 * M_2_10_p2 - c9 * M_2_2_p91;
  const Real M_2_10_p8 = s10 * M_2_2_p109;
  const Real M_2_10_p9 = s8 * M_2_10_p7 - c8 * M_2_10_p8;
  const Real M_2_10_p10 = c7 * M_2_10_p6 + s7 * M_2_10_p9;
  const Real M_2_10_p11 = c7 * M_2_10_p5 - s7 * M_7_10 + 0.18 * M_2_10_p10;
  const Real M_6_10 = c8 * M_2_10_p4 - s8 * M_8_10;
  M[154] = M_6_10;
  M[246] = M_6_10;
  const Real M_2_10_p12 = M_6_10 - 0.226 * M_2_10_p10;
  const Real M_2_10_p13 = c6 * M_2_10_p11 + s6 * M_2_10_p12;
  const Real M_5_10_p1 = s7 * M_2_10_p6 - c7 * M_2_10_p9;
  const Real M_5_10_p2 = s8 * M_2_10_p8 + c8 * M_2_10_p7;
  const Real M_5_10 = c7 * M_7_10 + s7 * M_2_10_p5 + (0.226 * M_5_10_p2 + 0.18 * M_5_10_p1);
  M[130] = M_5_10;
  M[245] = M_5_10;
  const Real M_2_10_p14 = s6 * M_5_10_p1 + c6 * M_5_10_p2;
  const Real M_2_10_p15 = M_5_10 + 0.072 * M_2_10_p14;
  const Real M_4_10 = c6 * M_2_10_p12 - s6 * M_2_10_p11 - 0.072 * M_2_10_p10;
  M[106] = M_4_10;
  M[244] = M_4_10;
  const Real M_2_10_p16 = s6 * M_5_10_p2 - c6 * M_5_10_p1;
  const Real M_2_10_p17 = c5 * M_2_10_p10 + s5 * M_2_10_p16;
  const Real M_2_10 = s4 * (c5 * M_2_10_p15 + s5 * M_2_10_p13 + 0.21799999999999997 * M_2_10_p14) +
      c4 * (M_4_10 - 0.21799999999999997 * M_2_10_p17);
  M[58] = M_2_10;
  M[242] = M_2_10;
  const Real M_1_10_p1 = s4 * M_2_10_p14 - c4 * M_2_10_p17;
  const Real M_1_10_p2 = s5 * M_2_10_p10 - c5 * M_2_10_p16;
  const Real M_1_10_p3 = c3 * M_1_10_p1 + s3 * M_1_10_p2;
  const Real M_1_10 = M_2_10 + 0.422 * M_1_10_p3;
  M[34] = M_1_10;
  M[241] = M_1_10;
  const Real M_0_10 = M_1_10 + 0.434 * (c2 * M_1_10_p3 - s2 * (s3 * M_1_10_p1 - c3 * M_1_10_p2));
  M[10] = M_0_10;
  M[240] = M_0_10;

  // link 12 (left_wrist2), mass matrix
  const Real M_7_11_p1 = M_11_11 + 0.269 * M_2_2_p76;
  const Real M_7_11_p2 = c11 * M_2_2_p80 + s11 * M_7_11_p1;
  const Real M_7_11_p3 = s11 * M_2_2_p76;
  const Real M_7_11_p4 = c10 * M_7_11_p2 + s10 * M_10_11 + 0.282 * M_7_11_p3;
  const Real M_9_11 = c11 * M_7_11_p1 - s11 * M_2_2_p80;
  M[227] = M_9_11;
  M[273] = M_9_11;
  const Real M_7_11_p5 = c11 * M_2_2_p76;
  const Real M_7_11_p6 = c10 * M_7_11_p5 - s10 * M_2_2_p69;
  const Real M_7_11_p7 = M_9_11 + 0.282 * M_7_11_p6;
  const Real M_7_11 = c9 * M_7_11_p4 + s9 * M_7_11_p7;
  M[179] = -M_7_11;
  M[271] = -M_7_11;
  const Real M_2_11_p1 = s9 * M_7_11_p4 - c9 * M_7_11_p7;
  const Real M_8_11 = s10 * M_7_11_p2 - c10 * M_10_11;
  M[203] = M_8_11;
  M[272] = M_8_11;
  const Real M_2_11_p2 = s8 * M_2_11_p1 - c8 * M_8_11;
  const Real M_2_11_p3 = s9 * M_7_11_p6 + c9 * M_7_11_p3;
  const Real M_2_11_p4 = s10 * M_7_11_p5 + c10 * M_2_2_p69;
  const Real M_2_11_p5 = s8 * M_2_11_p3 - c8 * M_2_11_p4;
  const Real M_2_11_p6 = s9 * M_7_11_p3 - c9 * M_7_11_p6;
  const Real M_2_11_p7 = c7 * M_2_11_p6 - s7 * M_2_11_p5;
  const Real M_2_11_p8 = 0.18 * M_2_11_p7 - (s7 * M_7_11 - c7 * M_2_11_p2);
  const Real M_6_11 = s8 * M_8_11 + c8 * M_2_11_p1;
  M[155] = -M_6_11;
  M[270] = -M_6_11;
  const Real M_2_11_p9 = 0.226 * M_2_11_p7 - M_6_11;
  const Real M_2_11_p10 = c6 * M_2_11_p8 - s6 * M_2_11_p9;
  const Real M_5_11_p1 = s8 * M_2_11_p4 + c8 * M_2_11_p3;
  const Real M_5_11_p2 = s7 * M_2_11_p6 + c7 * M_2_11_p5;
  const Real M_5_11 = 0.226 * M_5_11_p1 - 0.18 * M_5_11_p2 - (c7 * M_7_11 + s7 * M_2_11_p2);
  M[131] = M_5_11;
  M[269] = M_5_11;
  const Real M_2_11_p11 = s6 * M_5_11_p2 - c6 * M_5_11_p1;
  const Real M_2_11_p12 = M_5_11 - 0.072 * M_2_11_p11;
  const Real M_4_11 = s6 * M_2_11_p8 + c6 * M_2_11_p9 + 0.072 * M_2_11_p7;
  M[107] = M_4_11;
  M[268] = M_4_11;
  const Real M_2_11_p13 = c6 * M_5_11_p2 + s6 * M_5_11_p1;
  const Real M_2_11_p14 = s5 * M_2_11_p13 - c5 * M_2_11_p7;
  const Real M_2_11 = c4 * (M_4_11 - 0.21799999999999997 * M_2_11_p14) - s4 *
      (s5 * M_2_11_p10 - c5 * M_2_11_p12 + 0.21799999999999997 * M_2_11_p11);
  M[59] = M_2_11;
  M[266] = M_2_11;
  const Real M_1_11_p1 = c4 * M_2_11_p14 + s4 * M_2_11_p11;
  const Real M_1_11_p2 = s5 * M_2_11_p7 + c5 * M_2_11_p13;
  const Real M_1_11_p3 = c3 * M_1_11_p1 + s3 * M_1_11_p2;
  const Real M_1_11 = M_2_11 - 0.422 * M_1_11_p3;
  M[35] = M_1_11;
  M[265] = M_1_11;
  const Real M_0_11 = M_1_11 - 0.434 * (c2 * M_1_11_p3 + s2 * (c3 * M_1_11_p2 - s3 * M_1_11_p1));
  M[11] = M_0_11;
  M[264] = M_0_11;

  // link 13 (left_hand), mass matrix
  M[300] = 0.0009386316083993107;
  M[475] = 0.0009386316083993107;
  const Real M_2_12_p1 = 0.0009386316083993107 * c12 + s12 * M_2_2_p62 + 0.269 * M_2_2_p67;
  const Real M_2_12_p2 = s12 * M_2_2_p71;
  const Real M_2_12_p3 = M_11_12 - 0.269 * M_2_12_p2;
  const Real M_2_12_p4 = c11 * M_2_12_p1 - s11 * M_2_12_p3;
  const Real M_10_12 = M_2_2_p63 - 0.0009386316083993107 * s12;
  M[252] = M_10_12;
  M[298] = M_10_12;
  const Real M_2_12_p5 = c11 * M_2_2_p67 + s11 * M_2_12_p2;
  const Real M_2_12_p6 = c10 * M_2_12_p4 + s10 * M_10_12 + 0.282 * M_2_12_p5;
  const Real M_9_12 = s11 * M_2_12_p1 + c11 * M_2_12_p3;
  M[228] = M_9_12;
  M[297] = M_9_12;
  const Real M_2_12_p7 = s11 * M_2_2_p67 - c11 * M_2_12_p2;
  const Real M_2_12_p8 = c12 * M_2_2_p71;
  const Real M_2_12_p9 = c10 * M_2_12_p7 - s10 * M_2_12_p8;
  const Real M_2_12_p10 = M_9_12 + 0.282 * M_2_12_p9;
  const Real M_2_12_p11 = s9 * M_2_12_p6 + c9 * M_2_12_p10;
  const Real M_8_12 = c10 * M_10_12 - s10 * M_2_12_p4;
  M[204] = M_8_12;
  M[296] = M_8_12;
  const Real M_2_12_p12 = c8 * M_8_12 + s8 * M_2_12_p11;
  const Real M_7_12 = c9 * M_2_12_p6 - s9 * M_2_12_p10;
  M[180] = M_7_12;
  M[295] = M_7_12;
  const Real M_2_12_p13 = c9 * M_2_12_p9 + s9 * M_2_12_p5;
  const Real M_2_12_p14 = s9 * M_2_12_p9 - c9 * M_2_12_p5;
  const Real M_2_12_p15 = s10 * M_2_12_p7 + c10 * M_2_12_p8;
  const Real M_2_12_p16 = s8 * M_2_12_p14 - c8 * M_2_12_p15;
  const Real M_2_12_p17 = c7 * M_2_12_p13 + s7 * M_2_12_p16;
  const Real M_2_12_p18 = c7 * M_2_12_p12 - s7 * M_7_12 + 0.18 * M_2_12_p17;
  const Real M_6_12 = c8 * M_2_12_p11 - s8 * M_8_12;
  M[156] = M_6_12;
  M[294] = M_6_12;
  const Real M_2_12_p19 = M_6_12 - 0.226 * M_2_12_p17;
  const Real M_2_12_p20 = c6 * M_2_12_p18 + s6 * M_2_12_p19;
  const Real M_5_12_p1 = s7 * M_2_12_p13 - c7 * M_2_12_p16;
  const Real M_5_12_p2 = s8 * M_2_12_p15 + c8 * M_2_12_p14;
  const Real M_5_12 = c7 * M_7_12 + s7 * M_2_12_p12 + (0.226 * M_5_12_p2 + 0.18 * M_5_12_p1);
  M[132] = M_5_12;
  M[293] = M_5_12;
  const Real M_2_12_p21 = s6 * M_5_12_p1 + c6 * M_5_12_p2;
  const Real M_2_12_p22 = M_5_12 + 0.072 * M_2_12_p21;
  const Real M_4_12 = c6 * M_2_12_p19 - s6 * M_2_12_p18 - 0.072 * M_2_12_p17;
  M[108] = M_4_12;
  M[292] = M_4_12;
  const Real M_2_12_p23 = s6 * M_5_12_p2 - c6 * M_5_12_p1;
  const Real M_2_12_p24 = c5 * M_2_12_p17 + s5 * M_2_12_p23;
  const Real M_2_12 = s4 * (c5 * M_2_12_p22 + s5 * M_2_12_p20 + 0.21799999999999997 * M_2_12_p21) +
      c4 * (M_4_12 - 0.21799999999999997 * M_2_12_p24);
  M[60] = M_2_12;
  M[290] = M_2_12;
  const Real M_1_12_p1 = s4 * M_2_12_p21 - c4 * M_2_12_p24;
  const Real M_1_12_p2 = s5 * M_2_12_p17 - c5 * M_2_12_p23;
  const Real M_1_12_p3 = c3 * M_1_12_p1 + s3 * M_1_12_p2;
  const Real M_1_12 = M_2_12 + 0.422 * M_1_12_p3;
  M[36] = M_1_12;
  M[289] = M_1_12;
  const Real M_0_12 = M_1_12 + 0.434 * (c2 * M_1_12_p3 - s2 * (s3 * M_1_12_p1 - c3 * M_1_12_p2));
  M[12] = M_0_12;
  M[288] = M_0_12;

  // link 14 (right_shoulder1), mass matrix
  const Real M_2_13_p1 = M_13_13 - M_5_5_p2;
  const Real M_2_13_p2 = c6 * M_2_2_p177 - s6 * M_2_13_p1;
  const Real M_2_13_p3 = s6 * M_2_2_p200;
  const Real M_2_13_p4 = M_5_13 - 0.072 * M_2_13_p3;
  const Real M_4_13 = s6 * M_2_2_p177 + c6 * M_2_13_p1 - 0.072 * M_2_2_p167;
  M[109] = M_4_13;
  M[316] = M_4_13;
  const Real M_2_13_p5 = c6 * M_2_2_p200;
  const Real M_2_13_p6 = c5 * M_2_2_p167 + s5 * M_2_13_p5;
  const Real M_2_13 = c4 * (M_4_13 - 0.21799999999999997 * M_2_13_p6) - s4 *
      (0.21799999999999997 * M_2_13_p3 + (s5 * M_2_13_p2 - c5 * M_2_13_p4));
  M[61] = M_2_13;
  M[314] = M_2_13;
  const Real M_1_13_p1 = s5 * M_2_2_p167 - c5 * M_2_13_p5;
  const Real M_1_13_p2 = s4 * M_2_13_p3 + c4 * M_2_13_p6;
  const Real M_1_13_p3 = s3 * M_1_13_p1 - c3 * M_1_13_p2;
  const Real M_1_13 = M_2_13 + 0.422 * M_1_13_p3;
  M[37] = M_1_13;
  M[313] = M_1_13;
  const Real M_0_13 = M_1_13 + 0.434 * (c2 * M_1_13_p3 + s2 * (s3 * M_1_13_p2 + c3 * M_1_13_p1));
  M[13] = M_0_13;
  M[312] = M_0_13;

  // link 16 (right_upperarm), composite inertia
  const Real M_14_14 = 0.18125194219699997 + M_2_2_p55;
  M[350] = M_14_14;

  // link 15 (right_shoulder2), mass matrix
  const Real M_4_14_p1 = s14 * M_2_2_p148;
  const Real M_4_14_p2 = s14 * M_14_14 + c14 * M_2_2_p59 - 0.18 * M_4_14_p1;
  const Real M_4_14_p3 = M_13_14 + 0.226 * M_4_14_p1;
  const Real M_4_14 = s6 * M_4_14_p2 + c6 * M_4_14_p3 + 0.072 * M_4_14_p1;
  M[110] = M_4_14;
  M[340] = M_4_14;
  const Real M_2_14_p1 = c14 * M_2_2_p148;
  const Real M_2_14_p2 = c6 * M_2_14_p1 + s6 * M_2_2_p165;
  const Real M_2_14_p3 = c5 * M_4_14_p1 + s5 * M_2_14_p2;
  const Real M_2_14_p4 = c6 * M_4_14_p2 - s6 * M_4_14_p3;
  const Real M_5_14 = c14 * M_14_14 - s14 * M_2_2_p59 - (0.18 * M_2_14_p1 + 0.226 * M_2_2_p165);
  M[134] = M_5_14;
  M[341] = M_5_14;
  const Real M_2_14_p5 = c6 * M_2_2_p165 - s6 * M_2_14_p1;
  const Real M_2_14_p6 = M_5_14 - 0.072 * M_2_14_p5;
  const Real M_2_14 = c4 * (M_4_14 + 0.21799999999999997 * M_2_14_p3) - s4 *
      (s5 * M_2_14_p4 - c5 * M_2_14_p6 + 0.21799999999999997 * M_2_14_p5);
  M[62] = M_2_14;
  M[338] = M_2_14;
  const Real M_1_14_p1 = s4 * M_2_14_p5 - c4 * M_2_14_p3;
  const Real M_1_14_p2 = c5 * M_2_14_p2 - s5 * M_4_14_p1;
  const Real M_1_14_p3 = s3 * M_1_14_p2 - c3 * M_1_14_p1;
  const Real M_1_14 = M_2_14 + 0.422 * M_1_14_p3;
  M[38] = M_1_14;
  M[337] = M_1_14;
  const Real M_0_14 = M_1_14 + 0.434 * (c2 * M_1_14_p3 + s2 * (s3 * M_1_14_p1 + c3 * M_1_14_p2));
  M[14] = M_0_14;
  M[336] = M_0_14;

  // link 17 (right_lowerarm), composite inertia
  const Real M_15_15 = 0.0027762933559338653 + M_2_2_p44;
  M[375] = M_15_15;

  // link 16 (right_upperarm), mass matrix
  const Real M_5_15_p1 = s15 * M_2_2_p50 - c15 * M_15_15;
  const Real M_5_15_p2 = s15 * M_2_2_p163;
  const Real M_5_15_p3 = s14 * M_2_2_p145 + c14 * M_5_15_p2;
  const Real M_5_15_p4 = c15 * M_2_2_p163;
  const Real M_5_15 = 0.226 * M_5_15_p4 + 0.18 * M_5_15_p3 - (c14 * M_14_15 + s14 * M_5_15_p1);
  M[135] = M_5_15;
  M[365] = M_5_15;
  const Real M_2_15_p1 = s6 * M_5_15_p3 - c6 * M_5_15_p4;
  const Real M_2_15_p2 = M_5_15 - 0.072 * M_2_15_p1;
  const Real M_2_15_p3 = c14 * M_2_2_p145 - s14 * M_5_15_p2;
  const Real M_2_15_p4 = s14 * M_14_15 - c14 * M_5_15_p1 + 0.18 * M_2_15_p3;
  const Real M_13_15 = s15 * M_15_15 + c15 * M_2_2_p50;
  M[327] = -M_13_15;
  M[373] = -M_13_15;
  const Real M_2_15_p5 = 0.226 * M_2_15_p3 - M_13_15;
  const Real M_2_15_p6 = c6 * M_2_15_p4 + s6 * M_2_15_p5;
  const Real M_4_15 = c6 * M_2_15_p5 - s6 * M_2_15_p4 + 0.072 * M_2_15_p3;
  M[111] = M_4_15;
  M[364] = M_4_15;
  const Real M_2_15_p7 = c6 * M_5_15_p3 + s6 * M_5_15_p4;
  const Real M_2_15_p8 = s5 * M_2_15_p7 - c5 * M_2_15_p3;
  const Real M_2_15 = s4 * (c5 * M_2_15_p2 + s5 * M_2_15_p6 - 0.21799999999999997 * M_2_15_p1) +
      c4 * (M_4_15 - 0.21799999999999997 * M_2_15_p8);
  M[63] = M_2_15;
  M[362] = M_2_15;
  const Real M_1_15_p1 = c4 * M_2_15_p8 + s4 * M_2_15_p1;
  const Real M_1_15_p2 = s5 * M_2_15_p3 + c5 * M_2_15_p7;
  const Real M_1_15_p3 = c3 * M_1_15_p1 + s3 * M_1_15_p2;
  const Real M_1_15 = M_2_15 - 0.422 * M_1_15_p3;
  M[39] = M_1_15;
  M[361] = M_1_15;
  const Real M_0_15 = M_1_15 - 0.434 * (c2 * M_1_15_p3 + s2 * (c3 * M_1_15_p2 - s3 * M_1_15_p1));
  M[15] = M_0_15;
  M[360] = M_0_15;

  // link 17 (right_lowerarm), mass matrix
  const Real M_2_16_p1 = M_16_16 + 0.282 * M_2_2_p33;
  const Real M_2_16_p2 = s16 * M_2_2_p39 - c16 * M_2_16_p1;
  const Real M_2_16_p3 = c15 * M_15_16 + s15 * M_2_16_p2;
  const Real M_14_16 = c16 * M_2_2_p39 + s16 * M_2_16_p1;
  M[352] = -M_14_16;
  M[398] = -M_14_16;
  const Real M_2_16_p4 = s16 * M_2_2_p33;
  const Real M_2_16_p5 = s15 * M_2_16_p4 - c15 * M_2_2_p46;
  const Real M_2_16_p6 = c16 * M_2_2_p33;
  const Real M_2_16_p7 = c14 * M_2_16_p6 + s14 * M_2_16_p5;
  const Real M_2_16_p8 = 0.18 * M_2_16_p7 - (s14 * M_14_16 - c14 * M_2_16_p3);
  const Real M_13_16 = s15 * M_15_16 - c15 * M_2_16_p2;
  M[328] = M_13_16;
  M[397] = M_13_16;
  const Real M_2_16_p9 = M_13_16 - 0.226 * M_2_16_p7;
  const Real M_2_16_p10 = c6 * M_2_16_p8 - s6 * M_2_16_p9;
  const Real M_5_16_p1 = s15 * M_2_2_p46 + c15 * M_2_16_p4;
  const Real M_5_16_p2 = s14 * M_2_16_p6 - c14 * M_2_16_p5;
  const Real M_5_16 = 0.226 * M_5_16_p1 - 0.18 * M_5_16_p2 - (c14 * M_14_16 + s14 * M_2_16_p3);
  M[136] = M_5_16;
  M[389] = M_5_16;
  const Real M_2_16_p11 = s6 * M_5_16_p2 + c6 * M_5_16_p1;
  const Real M_2_16_p12 = M_5_16 + 0.072 * M_2_16_p11;
  const Real M_4_16 = s6 * M_2_16_p8 + c6 * M_2_16_p9 - 0.072 * M_2_16_p7;
  M[112] = M_4_16;
  M[388] = M_4_16;
  const Real M_2_16_p13 = s6 * M_5_16_p1 - c6 * M_5_16_p2;
  const Real M_2_16_p14 = c5 * M_2_16_p7 + s5 * M_2_16_p13;
  const Real M_2_16 = s4 * (0.21799999999999997 * M_2_16_p11 -
      (s5 * M_2_16_p10 - c5 * M_2_16_p12)) + c4 * (M_4_16 - 0.21799999999999997 * M_2_16_p14);
  M[64] = M_2_16;
  M[386] = M_2_16;
  const Real M_1_16_p1 = s4 * M_2_16_p11 - c4 * M_2_16_p14;
  const Real M_1_16_p2 = s5 * M_2_16_p7 - c5 * M_2_16_p13;
  const Real M_1_16_p3 = c3 * M_1_16_p1 + s3 * M_1_16_p2;
  const Real M_1_16 = M_2_16 + 0.422 * M_1_16_p3;
  M[40] = M_1_16;
  M[385] = M_1_16;
  const Real M_0_16 = M_1_16 + 0.434 * (c2 * M_1_16_p3 - s2 * (s3 * M_1_16_p1 - c3 * M_1_16_p2));
  M[16] = M_0_16;
  M[384] = M_0_16;

  // link 19 (right_wrist2), composite inertia
  const Real M_17_17 = 0.00022920000000000001 + M_2_2_p24;
  M[425] = M_17_17;

  // link 18 (right_wrist1), mass matrix
  const Real M_2_17_p1 = c17 * M_2_2_p12 + s17 * M_17_17 + 0.282 * M_2_2_p30;
  const Real M_2_17_p2 = c17 * M_2_2_p48;
  const Real M_2_17_p3 = M_16_17 + 0.282 * M_2_17_p2;
  const Real M_2_17_p4 = s16 * M_2_17_p1 + c16 * M_2_17_p3;
  const Real M_15_17 = c17 * M_17_17 - s17 * M_2_2_p12;
  M[377] = M_15_17;
  M[423] = M_15_17;
  const Real M_2_17_p5 = c15 * M_15_17 + s15 * M_2_17_p4;
  const Real M_14_17 = c16 * M_2_17_p1 - s16 * M_2_17_p3;
  M[353] = M_14_17;
  M[422] = M_14_17;
  const Real M_2_17_p6 = c16 * M_2_17_p2 + s16 * M_2_2_p30;
  const Real M_2_17_p7 = s16 * M_2_17_p2 - c16 * M_2_2_p30;
  const Real M_2_17_p8 = s17 * M_2_2_p48;
  const Real M_2_17_p9 = s15 * M_2_17_p7 - c15 * M_2_17_p8;
  const Real M_2_17_p10 = c14 * M_2_17_p6 + s14 * M_2_17_p9;
  const Real M_2_17_p11 = 0.18 * M_2_17_p10 - (c14 * M_2_17_p5 - s14 * M_14_17);
  const Real M_13_17 = c15 * M_2_17_p4 - s15 * M_15_17;
  M[329] = M_13_17;
  M[421] = M_13_17;
  const Real M_2_17_p12 = M_13_17 - 0.226 * M_2_17_p10;
  const Real M_2_17_p13 = c6 * M_2_17_p11 - s6 * M_2_17_p12;
  const Real M_5_17_p1 = s14 * M_2_17_p6 - c14 * M_2_17_p9;
  const Real M_5_17_p2 = s15 * M_2_17_p8 + c15 * M_2_17_p7;
  const Real M_5_17 = c14 * M_14_17 + s14 * M_2_17_p5 + (0.226 * M_5_17_p2 - 0.18 * M_5_17_p1);
  M[137] = M_5_17;
  M[413] = M_5_17;
  const Real M_2_17_p14 = s6 * M_5_17_p1 + c6 * M_5_17_p2;
  const Real M_2_17_p15 = M_5_17 + 0.072 * M_2_17_p14;
  const Real M_4_17 = s6 * M_2_17_p11 + c6 * M_2_17_p12 - 0.072 * M_2_17_p10;
  M[113] = M_4_17;
  M[412] = M_4_17;
  const Real M_2_17_p16 = s6 * M_5_17_p2 - c6 * M_5_17_p1;
  const Real M_2_17_p17 = c5 * M_2_17_p10 + s5 * M_2_17_p16;
  const Real M_2_17 = s4 * (0.21799999999999997 * M_2_17_p14 -
      (s5 * M_2_17_p13 - c5 * M_2_17_p15)) + c4 * (M_4_17 - 0.21799999999999997 * M_2_17_p17);
  M[65] = M_2_17;
  M[410] = M_2_17;
  const Real M_1_17_p1 = s4 * M_2_17_p14 - c4 * M_2_17_p17;
  const Real M_1_17_p2 = s5 * M_2_17_p10 - c5 * M_2_17_p16;
  const Real M_1_17_p3 = c3 * M_1_17_p1 + s3 * M_1_17_p2;
  const Real M_1_17 = M_2_17 + 0.422 * M_1_17_p3;
  M[41] = M_1_17;
  M[409] = M_1_17;
  const Real M_0_17 = M_1_17 + 0.434 * (c2 * M_1_17_p3 - s2 * (s3 * M_1_17_p1 - c3 * M_1_17_p2));
  M[17] = M_0_17;
  M[408] = M_0_17;

  // link 19 (right_wrist2), mass matrix
  const Real M_14_18_p1 = M_18_18 + 0.269 * M_2_2_p15;
  const Real M_14_18_p2 = c18 * M_2_2_p19 + s18 * M_14_18_p1;
  const Real M_14_18_p3 = s18 * M_2_2_p15;
  const Real M_14_18_p4 = c17 * M_14_18_p2 - s17 * M_17_18 + 0.282 * M_14_18_p3;
  const Real M_16_18 = c18 * M_14_18_p1 - s18 * M_2_2_p19;
  M[402] = M_16_18;
  M[448] = M_16_18;
  const Real M_14_18_p5 = c18 * M_2_2_p15;
  const Real M_14_18_p6 = c17 * M_14_18_p5 - s17 * M_2_2_p8;
  const Real M_14_18_p7 = M_16_18 + 0.282 * M_14_18_p6;
  const Real M_14_18 = c16 * M_14_18_p4 + s16 * M_14_18_p7;
  M[354] = -M_14_18;
  M[446] = -M_14_18;
  const Real M_5_18_p1 = s16 * M_14_18_p4 - c16 * M_14_18_p7;
  const Real M_15_18 = s17 * M_14_18_p2 + c17 * M_17_18;
  M[378] = M_15_18;
  M[447] = M_15_18;
  const Real M_5_18_p2 = s15 * M_5_18_p1 - c15 * M_15_18;
  const Real M_5_18_p3 = s17 * M_14_18_p5 + c17 * M_2_2_p8;
  const Real M_5_18_p4 = s16 * M_14_18_p6 + c16 * M_14_18_p3;
  const Real M_5_18_p5 = s15 * M_5_18_p3 + c15 * M_5_18_p4;
  const Real M_5_18_p6 = s15 * M_5_18_p4 - c15 * M_5_18_p3;
  const Real M_5_18_p7 = s16 * M_14_18_p3 - c16 * M_14_18_p6;
  const Real M_5_18_p8 = s14 * M_5_18_p7 + c14 * M_5_18_p6;
  const Real M_5_18 = 0.226 * M_5_18_p5 + 0.18 * M_5_18_p8 - (c14 * M_14_18 + s14 * M_5_18_p2);
  M[138] = M_5_18;
  M[437] = M_5_18;
  const Real M_2_18_p1 = s6 * M_5_18_p8 - c6 * M_5_18_p5;
  const Real M_2_18_p2 = M_5_18 - 0.072 * M_2_18_p1;
  const Real M_2_18_p3 = c14 * M_5_18_p7 - s14 * M_5_18_p6;
  const Real M_2_18_p4 = s14 * M_14_18 - c14 * M_5_18_p2 + 0.18 * M_2_18_p3;
  const Real M_13_18 = s15 * M_15_18 + c15 * M_5_18_p1;
  M[330] = -M_13_18;
  M[445] = -M_13_18;
  const Real M_2_18_p5 = 0.226 * M_2_18_p3 - M_13_18;
  const Real M_2_18_p6 = c6 * M_2_18_p4 + s6 * M_2_18_p5;
  const Real M_4_18 = c6 * M_2_18_p5 - s6 * M_2_18_p4 + 0.072 * M_2_18_p3;
  M[114] = M_4_18;
  M[436] = M_4_18;
  const Real M_2_18_p7 = c6 * M_5_18_p8 + s6 * M_5_18_p5;
  const Real M_2_18_p8 = s5 * M_2_18_p7 - c5 * M_2_18_p3;
  const Real M_2_18 = s4 * (c5 * M_2_18_p2 + s5 * M_2_18_p6 - 0.21799999999999997 * M_2_18_p1) +
      c4 * (M_4_18 - 0.21799999999999997 * M_2_18_p8);
  M[66] = M_2_18;
  M[434] = M_2_18;
  const Real M_1_18_p1 = c4 * M_2_18_p8 + s4 * M_2_18_p1;
  const Real M_1_18_p2 = s5 * M_2_18_p3 + c5 * M_2_18_p7;
  const Real M_1_18_p3 = c3 * M_1_18_p1 + s3 * M_1_18_p2;
  const Real M_1_18 = M_2_18 - 0.422 * M_1_18_p3;
  M[42] = M_1_18;
  M[433] = M_1_18;
  const Real M_0_18 = M_1_18 - 0.434 * (c2 * M_1_18_p3 + s2 * (c3 * M_1_18_p2 - s3 * M_1_18_p1));
  M[18] = M_0_18;
  M[432] = M_0_18;

  // link 20 (right_hand), mass matrix
  const Real M_14_19_p1 = 0.269 * M_2_2_p6 - (s19 * M_2_2_p3 - 0.0009386316083993107 * c19);
  const Real M_14_19_p2 = s19 * M_2_2_p10;
  const Real M_14_19_p3 = M_18_19 + 0.269 * M_14_19_p2;
  const Real M_14_19_p4 = c18 * M_14_19_p1 + s18 * M_14_19_p3;
  const Real M_17_19 = 0.0009386316083993107 * s19 + M_2_2_p4;
  M[427] = -M_17_19;
  M[473] = -M_17_19;
  const Real M_14_19_p5 = s18 * M_14_19_p2 + c18 * M_2_2_p6;
  const Real M_14_19_p6 = 0.282 * M_14_19_p5 - (s17 * M_17_19 - c17 * M_14_19_p4);
  const Real M_16_19 = s18 * M_14_19_p1 - c18 * M_14_19_p3;
  M[403] = M_16_19;
  M[472] = M_16_19;
  const Real M_14_19_p7 = c18 * M_14_19_p2 - s18 * M_2_2_p6;
  const Real M_14_19_p8 = c19 * M_2_2_p10;
  const Real M_14_19_p9 = c17 * M_14_19_p7 + s17 * M_14_19_p8;
  const Real M_14_19_p10 = M_16_19 - 0.282 * M_14_19_p9;
  const Real M_14_19 = c16 * M_14_19_p6 - s16 * M_14_19_p10;
  M[355] = M_14_19;
  M[470] = M_14_19;
  const Real M_4_19_p1 = s16 * M_14_19_p6 + c16 * M_14_19_p10;
  const Real M_15_19 = s17 * M_14_19_p4 + c17 * M_17_19;
  M[379] = -M_15_19;
  M[471] = -M_15_19;
  const Real M_4_19_p2 = c15 * M_15_19 - s15 * M_4_19_p1;
  const Real M_4_19_p3 = c16 * M_14_19_p9 - s16 * M_14_19_p5;
  const Real M_4_19_p4 = s16 * M_14_19_p9 + c16 * M_14_19_p5;
  const Real M_4_19_p5 = c17 * M_14_19_p8 - s17 * M_14_19_p7;
  const Real M_4_19_p6 = c15 * M_4_19_p5 + s15 * M_4_19_p4;
  const Real M_4_19_p7 = c14 * M_4_19_p3 + s14 * M_4_19_p6;
  const Real M_4_19_p8 = s14 * M_14_19 + c14 * M_4_19_p2 - 0.18 * M_4_19_p7;
  const Real M_13_19 = s15 * M_15_19 + c15 * M_4_19_p1;
  M[331] = M_13_19;
  M[469] = M_13_19;
  const Real M_4_19_p9 = M_13_19 + 0.226 * M_4_19_p7;
  const Real M_4_19 = s6 * M_4_19_p8 + c6 * M_4_19_p9 + 0.072 * M_4_19_p7;
  M[115] = M_4_19;
  M[460] = M_4_19;
  const Real M_2_19_p1 = c14 * M_4_19_p6 - s14 * M_4_19_p3;
  const Real M_2_19_p2 = c15 * M_4_19_p4 - s15 * M_4_19_p5;
  const Real M_2_19_p3 = c6 * M_2_19_p1 + s6 * M_2_19_p2;
  const Real M_2_19_p4 = c5 * M_4_19_p7 + s5 * M_2_19_p3;
  const Real M_2_19_p5 = c6 * M_4_19_p8 - s6 * M_4_19_p9;
  const Real M_5_19 = c14 * M_14_19 - s14 * M_4_19_p2 - (0.226 * M_2_19_p2 + 0.18 * M_2_19_p1);
  M[139] = M_5_19;
  M[461] = M_5_19;
  const Real M_2_19_p6 = c6 * M_2_19_p2 - s6 * M_2_19_p1;
  const Real M_2_19_p7 = M_5_19 - 0.072 * M_2_19_p6;
  const Real M_2_19 = c4 * (M_4_19 + 0.21799999999999997 * M_2_19_p4) - s4 *
      (s5 * M_2_19_p5 - c5 * M_2_19_p7 + 0.21799999999999997 * M_2_19_p6);
  M[67] = M_2_19;
  M[458] = M_2_19;
  const Real M_1_19_p1 = c4 * M_2_19_p4 - s4 * M_2_19_p6;
  const Real M_1_19_p2 = c5 * M_2_19_p3 - s5 * M_4_19_p7;
  const Real M_1_19_p3 = c3 * M_1_19_p1 + s3 * M_1_19_p2;
  const Real M_1_19 = M_2_19 + 0.422 * M_1_19_p3;
  M[43] = M_1_19;
  M[457] = M_1_19;
  const Real M_0_19 = M_1_19 + 0.434 * (c2 * M_1_19_p3 - s2 * (s3 * M_1_19_p1 - c3 * M_1_19_p2));
  M[19] = M_0_19;
  M[456] = M_0_19;

  // link 22 (head), composite inertia
  const Real M_20_20 = 0.006216750000000001 + M_2_2_p136;
  M[500] = M_20_20;

  // link 21 (neck), mass matrix
  const Real M_2_20_p1 = s6 * M_2_2_p184 - c6 * M_20_20;
  const Real M_2_20_p2 = c6 * M_2_2_p206;
  const Real M_2_20_p3 = 0.072 * M_2_20_p2 + M_5_20;
  const Real M_4_20 = s6 * M_20_20 + c6 * M_2_2_p184 + 0.072 * M_2_2_p195;
  M[116] = -M_4_20;
  M[484] = -M_4_20;
  const Real M_2_20_p4 = s6 * M_2_2_p206;
  const Real M_2_20_p5 = c5 * M_2_2_p195 - s5 * M_2_20_p4;
  const Real M_2_20 = s4 * (0.21799999999999997 * M_2_20_p2 + (s5 * M_2_20_p1 + c5 * M_2_20_p3)) +
      c4 * (M_4_20 + 0.21799999999999997 * M_2_20_p5);
  M[68] = -M_2_20;
  M[482] = -M_2_20;
  const Real M_1_20_p1 = s5 * M_2_2_p195 + c5 * M_2_20_p4;
  const Real M_1_20_p2 = s4 * M_2_20_p2 + c4 * M_2_20_p5;
  const Real M_1_20_p3 = s3 * M_1_20_p1 - c3 * M_1_20_p2;
  const Real M_1_20 = 0.422 * M_1_20_p3 - M_2_20;
  M[44] = M_1_20;
  M[481] = M_1_20;
  const Real M_0_20 = M_1_20 + 0.434 * (c2 * M_1_20_p3 + s2 * (s3 * M_1_20_p2 + c3 * M_1_20_p1));
  M[20] = M_0_20;
  M[480] = M_0_20;

  // link 22 (head), mass matrix
  const Real M_0_21_p1 = s21 * M_2_2_p153;
  const Real M_0_21_p2 = c6 * M_2_2_p178 - s6 * M_0_21_p1;
  const Real M_0_21_p3 = c21 * M_2_2_p153;
  const Real M_0_21_p4 = s5 * M_0_21_p2 - c5 * M_0_21_p3;
  const Real M_0_21_p5 = s6 * M_2_2_p178 + c6 * M_0_21_p1;
  const Real M_0_21_p6 = c4 * M_0_21_p4 + s4 * M_0_21_p5;
  const Real M_0_21_p7 = s5 * M_0_21_p3 + c5 * M_0_21_p2;
  const Real M_0_21_p8 = s3 * M_0_21_p7 + c3 * M_0_21_p6;
  const Real M_5_21_p1 = M_21_21 + 0.394 * M_2_2_p153;
  const Real M_5_21 = c21 * M_2_2_p159 + s21 * M_5_21_p1;
  M[141] = -M_5_21;
  M[509] = -M_5_21;
  const Real M_2_21_p1 = M_5_21 + 0.072 * M_0_21_p5;
  const Real M_2_21_p2 = M_2_2_p160 - c21 * M_5_21_p1;
  const Real M_2_21_p3 = s6 * M_2_21_p2 - c6 * M_20_21;
  const Real M_4_21 = s6 * M_20_21 + c6 * M_2_21_p2 - 0.072 * M_0_21_p3;
  M[117] = -M_4_21;
  M[508] = -M_4_21;
  const Real M_2_21 = s4 * (c5 * M_2_21_p1 + s5 * M_2_21_p3 + 0.21799999999999997 * M_0_21_p5) +
      c4 * (M_4_21 + 0.21799999999999997 * M_0_21_p4);
  M[69] = -M_2_21;
  M[506] = -M_2_21;
  const Real M_1_21 = 0.422 * M_0_21_p8 + M_2_21;
  M[45] = -M_1_21;
  M[505] = -M_1_21;
  const Real M_0_21 = 0.434 * (s2 * (s3 * M_0_21_p6 - c3 * M_0_21_p7) - c2 * M_0_21_p8) - M_1_21;
  M[21] = M_0_21;
  M[504] = M_0_21;
  M[550] = 9.25e-06;
  M[575] = 9.25e-06;

  // link 23 (left_eye), mass matrix
  const Real M_2_22_p1 = 9.25e-06 + M_2_2_p125;
  const Real M_2_22_p2 = c22 * M_2_2_p132 - s22 * M_2_22_p1 + 9.850000000000001e-05 * c23;
  const Real M_2_22_p3 = c22 * M_2_2_p181;
  const Real M_2_22_p4 = M_21_22 + 0.394 * M_2_22_p3;
  const Real M_2_22_p5 = s21 * M_2_22_p2 + c21 * M_2_22_p4;
  const Real M_20_22 = s22 * M_2_2_p132 + c22 * M_2_22_p1;
  M[502] = M_20_22;
  M[548] = M_20_22;
  const Real M_2_22_p6 = s6 * M_2_22_p5 - c6 * M_20_22;
  const Real M_5_22 = s21 * M_2_22_p4 - c21 * M_2_22_p2;
  M[142] = M_5_22;
  M[533] = M_5_22;
  const Real M_2_22_p7 = s21 * M_2_22_p3 - c21 * M_2_2_p151;
  const Real M_2_22_p8 = s22 * M_2_2_p181;
  const Real M_2_22_p9 = s6 * M_2_22_p8 + c6 * M_2_22_p7;
  const Real M_2_22_p10 = M_5_22 + 0.072 * M_2_22_p9;
  const Real M_4_22_p1 = c21 * M_2_22_p3 + s21 * M_2_2_p151;
  const Real M_4_22 = s6 * M_20_22 + c6 * M_2_22_p5 + 0.072 * M_4_22_p1;
  M[118] = -M_4_22;
  M[532] = -M_4_22;
  const Real M_2_22_p11 = s6 * M_2_22_p7 - c6 * M_2_22_p8;
  const Real M_2_22_p12 = c5 * M_4_22_p1 + s5 * M_2_22_p11;
  const Real M_2_22 = s4 * (0.21799999999999997 * M_2_22_p9 - (s5 * M_2_22_p6 - c5 * M_2_22_p10)) -
      c4 * (M_4_22 + 0.21799999999999997 * M_2_22_p12);
  M[70] = M_2_22;
  M[530] = M_2_22;
  const Real M_1_22_p1 = s4 * M_2_22_p9 - c4 * M_2_22_p12;
  const Real M_1_22_p2 = s5 * M_4_22_p1 - c5 * M_2_22_p11;
  const Real M_1_22_p3 = c3 * M_1_22_p1 + s3 * M_1_22_p2;
  const Real M_1_22 = M_2_22 + 0.422 * M_1_22_p3;
  M[46] = M_1_22;
  M[529] = M_1_22;
  const Real M_0_22 = M_1_22 + 0.434 * (c2 * M_1_22_p3 - s2 * (s3 * M_1_22_p1 - c3 * M_1_22_p2));
  M[22] = M_0_22;
  M[528] = M_0_22;

  // link 24 (right_eye), mass matrix
  const Real M_2_23_p1 = 9.25e-06 + M_2_2_p124;
  const Real M_2_23_p2 = c22 * M_2_2_p131 - s22 * M_2_23_p1 + 9.850000000000001e-05 * c24;
  const Real M_2_23_p3 = c22 * M_2_2_p180;
  const Real M_2_23_p4 = M_21_23 + 0.394 * M_2_23_p3;
  const Real M_2_23_p5 = s21 * M_2_23_p2 + c21 * M_2_23_p4;
  const Real M_20_23 = s22 * M_2_2_p131 + c22 * M_2_23_p1;
  M[503] = M_20_23;
  M[572] = M_20_23;
  const Real M_2_23_p6 = s6 * M_2_23_p5 - c6 * M_20_23;
  const Real M_5_23 = s21 * M_2_23_p4 - c21 * M_2_23_p2;
  M[143] = M_5_23;
  M[557] = M_5_23;
  const Real M_2_23_p7 = s21 * M_2_23_p3 - c21 * M_2_2_p150;
  const Real M_2_23_p8 = s22 * M_2_2_p180;
  const Real M_2_23_p9 = s6 * M_2_23_p8 + c6 * M_2_23_p7;
  const Real M_2_23_p10 = M_5_23 + 0.072 * M_2_23_p9;
  const Real M_4_23_p1 = c21 * M_2_23_p3 + s21 * M_2_2_p150;
  const Real M_4_23 = s6 * M_20_23 + c6 * M_2_23_p5 + 0.072 * M_4_23_p1;
  M[119] = -M_4_23;
  M[556] = -M_4_23;
  const Real M_2_23_p11 = s6 * M_2_23_p7 - c6 * M_2_23_p8;
  const Real M_2_23_p12 = c5 * M_4_23_p1 + s5 * M_2_23_p11;
  const Real M_2_23 = s4 * (0.21799999999999997 * M_2_23_p9 - (s5 * M_2_23_p6 - c5 * M_2_23_p10)) -
      c4 * (M_4_23 + 0.21799999999999997 * M_2_23_p12);
  M[71] = M_2_23;
  M[554] = M_2_23;
  const Real M_1_23_p1 = s4 * M_2_23_p9 - c4 * M_2_23_p12;
  const Real M_1_23_p2 = s5 * M_4_23_p1 - c5 * M_2_23_p11;
  const Real M_1_23_p3 = c3 * M_1_23_p1 + s3 * M_1_23_p2;
  const Real M_1_23 = M_2_23 + 0.422 * M_1_23_p3;
  M[47] = M_1_23;
  M[553] = M_1_23;
  const Real M_0_23 = M_1_23 + 0.434 * (c2 * M_1_23_p3 - s2 * (s3 * M_1_23_p1 - c3 * M_1_23_p2));
  M[23] = M_0_23;
  M[552] = M_0_23;

  // link 5 (chest2), composite inertia
  M[75] = 0.060169103246295166 + (M_2_2_p192 + M_2_2_p210);

  // link 6 (chest3), mass matrix
  const Real M_3_5 = s5 * M_2_5_p2 + c5 * M_2_2_p205;
  M[77] = -M_3_5;
  M[123] = -M_3_5;

  // link 7 (left_shoulder1), mass matrix
  const Real M_3_6 = s5 * M_2_6_p4 + c5 * M_2_6_p2;
  M[78] = -M_3_6;
  M[147] = -M_3_6;

  // link 8 (left_shoulder2), mass matrix
  const Real M_3_7 = s5 * M_2_7_p6 + c5 * M_2_7_p4;
  M[79] = -M_3_7;
  M[171] = -M_3_7;

  // link 9 (left_upperarm), mass matrix
  const Real M_3_8 = s5 * M_2_8_p8 + c5 * M_2_8_p6;
  M[80] = -M_3_8;
  M[195] = -M_3_8;

  // link 10 (left_lowerarm), mass matrix
  const Real M_3_9 = c5 * M_2_9_p10 - s5 * M_2_9_p12;
  M[81] = M_3_9;
  M[219] = M_3_9;

  // link 11 (left_wrist1), mass matrix
  const Real M_3_10 = c5 * M_2_10_p13 - s5 * M_2_10_p15;
  M[82] = M_3_10;
  M[243] = M_3_10;

  // link 12 (left_wrist2), mass matrix
  const Real M_3_11 = s5 * M_2_11_p12 + c5 * M_2_11_p10;
  M[83] = -M_3_11;
  M[267] = -M_3_11;

  // link 13 (left_hand), mass matrix
  const Real M_3_12 = c5 * M_2_12_p20 - s5 * M_2_12_p22;
  M[84] = M_3_12;
  M[291] = M_3_12;

  // link 14 (right_shoulder1), mass matrix
  const Real M_3_13 = s5 * M_2_13_p4 + c5 * M_2_13_p2;
  M[85] = -M_3_13;
  M[315] = -M_3_13;

  // link 15 (right_shoulder2), mass matrix
  const Real M_3_14 = s5 * M_2_14_p6 + c5 * M_2_14_p4;
  M[86] = -M_3_14;
  M[339] = -M_3_14;

  // link 16 (right_upperarm), mass matrix
  const Real M_3_15 = c5 * M_2_15_p6 - s5 * M_2_15_p2;
  M[87] = M_3_15;
  M[363] = M_3_15;

  // link 17 (right_lowerarm), mass matrix
  const Real M_3_16 = s5 * M_2_16_p12 + c5 * M_2_16_p10;
  M[88] = -M_3_16;
  M[387] = -M_3_16;

  // link 18 (right_wrist1), mass matrix
  const Real M_3_17 = s5 * M_2_17_p15 + c5 * M_2_17_p13;
  M[89] = -M_3_17;
  M[411] = -M_3_17;

  // link 19 (right_wrist2), mass matrix
  const Real M_3_18 = c5 * M_2_18_p6 - s5 * M_2_18_p2;
  M[90] = M_3_18;
  M[435] = M_3_18;

  // link 20 (right_hand), mass matrix
  const Real M_3_19 = s5 * M_2_19_p7 + c5 * M_2_19_p5;
  M[91] = -M_3_19;
  M[459] = -M_3_19;

  // link 21 (neck), mass matrix
  const Real M_3_20 = c5 * M_2_20_p1 - s5 * M_2_20_p3;
  M[92] = -M_3_20;
  M[483] = -M_3_20;

  // link 22 (head), mass matrix
  const Real M_3_21 = s5 * M_2_21_p1 - c5 * M_2_21_p3;
  M[93] = M_3_21;
  M[507] = M_3_21;

  // link 23 (left_eye), mass matrix
  const Real M_3_22 = s5 * M_2_22_p10 + c5 * M_2_22_p6;
  M[94] = -M_3_22;
  M[531] = -M_3_22;

  // link 24 (right_eye), mass matrix
  const Real M_3_23 = s5 * M_2_23_p10 + c5 * M_2_23_p6;
  M[95] = -M_3_23;
  M[555] = -M_3_23;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
