// mass_matrix: tau = M qdd + b + g: the matrix M
// By composite rigid bodies, RBDA table 6.2, alike limbs in lanes.
// 2233 flops (add 934, mul 1299, div 0), sine and cosine of 23 angles
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

template <int count>
using Lanes = detail::Pack<Real, count>;
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
  const Real c20_p1 = 0.17435661841416683 + q[19];
  const Real c13_p1 = (-0.17435661841416683) + q[12];
  const Real angles[23] = {q[3], q[23], q[22], q[21], q[20], q[18], c20_p1, q[17], q[16], q[15],
      q[14], q[13], q[11], c13_p1, q[10], q[9], q[8], q[7], q[6], q[5], q[4], q[1], q[2]};
  Real sines[23];
  Real cosines[23];
  detail::sin_cos(angles, sines, cosines);
  const Real s4 = sines[0];
  const Real s24 = sines[1];
  const Real s23 = sines[2];
  const Real s22 = sines[3];
  const Real c24 = cosines[1];
  const Real c23 = cosines[2];
  const Real c22 = cosines[3];
  const Real c21 = cosines[4];
  const Real s21 = sines[4];
  const Real s19 = sines[5];
  const Real c19 = cosines[5];
  const Real c20 = cosines[6];
  const Real s20 = sines[6];
  const Real s18 = sines[7];
  const Real c18 = cosines[7];
  const Real s17 = sines[8];
  const Real c17 = cosines[8];
  const Real c16 = cosines[9];
  const Real s16 = sines[9];
  const Real s15 = sines[10];
  const Real c15 = cosines[10];
  const Real s14 = sines[11];
  const Real c14 = cosines[11];
  const Real s12 = sines[12];
  const Real c12 = cosines[12];
  const Real c13 = cosines[13];
  const Real s13 = sines[13];
  const Real s11 = sines[14];
  const Real c11 = cosines[14];
  const Real s10 = sines[15];
  const Real c10 = cosines[15];
  const Real c9 = cosines[16];
  const Real s9 = sines[16];
  const Real s8 = sines[17];
  const Real c8 = cosines[17];
  const Real s7 = sines[18];
  const Real c7 = cosines[18];
  const Real s6 = sines[19];
  const Real c6 = cosines[19];
  const Real c4 = cosines[0];
  const Real s5 = sines[20];
  const Real c5 = cosines[20];
  const Real s2 = sines[21];
  const Real c2 = cosines[21];
  const Real c3 = cosines[22];
  const Real s3 = sines[22];

  // link 13 (left_hand), composite inertia
  const Lanes<2> M_2_2_p9_lanes = 0.0165153994048813 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> M_2_2_p17_lanes = 0.0165153994048813 * detail::make_pack<Real>(s13, s20);
  const Lanes<2> M_2_2_p19_lanes = detail::make_pack<Real>((-2.0630162081277884e-05),
      2.0630162081277884e-05) * detail::make_pack<Real>(c13, c20) - 0.0007965395222188762 *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> M_2_2_p21_lanes = 0.00011422720754895356 * detail::make_pack<Real>(c13, c20) +
      detail::make_pack<Real>(2.4414671283021662e-05, (-2.4414671283021662e-05)) *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> M_2_2_p23_lanes = 0.0006000000000000001 + M_2_2_p9_lanes;
  const Lanes<2> M_11_12_lanes = detail::make_pack<Real>(2.4414671283021662e-05,
      (-2.4414671283021662e-05)) * detail::make_pack<Real>(c13, c20) - 0.00011422720754895356 *
      detail::make_pack<Real>(s13, s20);
  M[276] = M_11_12_lanes[0];
  M[299] = M_11_12_lanes[0];

  // link 20 (right_hand), composite inertia
  M[451] = M_11_12_lanes[1];
  M[474] = M_11_12_lanes[1];

  // link 12 (left_wrist2), composite inertia
  const Lanes<2> M_2_2_p25_lanes = detail::make_pack<Real>(0.001, (-0.001)) + M_2_2_p17_lanes;

  // link 13 (left_hand), composite inertia
  const Lanes<2> M_2_2_p27_lanes = detail::make_pack<Real>(s13, s20) * M_2_2_p19_lanes;

  // link 12 (left_wrist2), composite inertia
  const Lanes<2> M_2_2_p29_lanes = detail::make_pack<Real>(c12, c19) * M_2_2_p21_lanes;

  // link 13 (left_hand), composite inertia
  const Lanes<2> M_2_2_p47_lanes = detail::make_pack<Real>(7.915081040638941e-06,
      (-7.915081040638941e-06)) + detail::make_pack<Real>(c13, c20) * M_2_2_p19_lanes;
  const Lanes<2> M_11_11_lanes = 0.0010744132275664366 + M_2_2_p27_lanes;
  M[275] = M_11_11_lanes[0];

  // link 20 (right_hand), composite inertia
  M[450] = M_11_11_lanes[1];

  // link 12 (left_wrist2), composite inertia
  const Lanes<2> M_2_2_p49_lanes = 0.0025100003499999995 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * M_2_2_p23_lanes;
  const Lanes<2> M_2_2_p51_lanes = detail::make_pack<Real>(s12, s19) * M_2_2_p23_lanes -
      0.0025100003499999995 * detail::make_pack<Real>(c12, c19);

  // link 23 (left_eye), composite inertia
  const Lanes<2> M_2_2_p63_lanes = 1.2499999999999999e-06 * detail::make_pack<Real>(s23, s24);

  // link 12 (left_wrist2), composite inertia
  const Lanes<2> M_2_2_p65_lanes = 0.538 * M_2_2_p49_lanes;
  const Lanes<2> M_2_2_p69_lanes = 6e-04 - M_2_2_p51_lanes;

  // link 11 (left_wrist1), composite inertia
  const Lanes<2> M_2_2_p71_lanes = 0.28049749700000004 + M_2_2_p49_lanes;

  // link 23 (left_eye), composite inertia
  const Lanes<2> M_2_2_p73_lanes = 2.375e-05 * detail::make_pack<Real>(c23, c24) +
      detail::make_pack<Real>(8e-06, (-8e-06)) * detail::make_pack<Real>(s23, s24);
  const Lanes<2> M_2_2_p75_lanes = 2.8750000000000004e-05 * detail::make_pack<Real>(c23, c24);

  // link 12 (left_wrist2), composite inertia
  const Lanes<2> M_2_2_p77_lanes = 2.0 * M_2_2_p29_lanes - detail::make_pack<Real>(s12, s19) *
      (0.0006839579030517506 + M_2_2_p27_lanes);
  const Lanes<2> M_2_2_p79_lanes = detail::make_pack<Real>(s12, s19) * M_2_2_p47_lanes -
      detail::make_pack<Real>(c12, c19) * M_11_12_lanes;
  const Lanes<2> M_10_11_lanes = detail::make_pack<Real>(s12, s19) * M_11_12_lanes +
      detail::make_pack<Real>(c12, c19) * M_2_2_p47_lanes;
  M[251] = -M_10_11_lanes[0];
  M[274] = -M_10_11_lanes[0];

  // link 19 (right_wrist2), composite inertia
  M[426] = -M_10_11_lanes[1];
  M[449] = -M_10_11_lanes[1];

  // link 23 (left_eye), composite inertia
  const Lanes<2> M_2_2_p91_lanes = detail::make_pack<Real>(s23, s24) * M_2_2_p63_lanes;

  // link 12 (left_wrist2), composite inertia
  const Lanes<2> M_2_2_p93_lanes = detail::make_pack<Real>(s12, s19) * M_2_2_p77_lanes;
  const Lanes<2> M_2_2_p97_lanes = detail::make_pack<Real>((-6e-06), 6e-06) - M_2_2_p79_lanes;
  const Lanes<2> M_2_2_p101_lanes = 0.0001098 + (M_11_11_lanes + M_2_2_p65_lanes);

  // link 11 (left_wrist1), composite inertia
  const Lanes<2> M_2_2_p103_lanes = detail::make_pack<Real>(c11, c18) * M_2_2_p69_lanes -
      detail::make_pack<Real>(s11, s18) * M_2_2_p25_lanes;
  const Lanes<2> M_2_2_p105_lanes = detail::make_pack<Real>(s11, s18) * M_2_2_p69_lanes +
      detail::make_pack<Real>(c11, c18) * M_2_2_p25_lanes;

  // link 12 (left_wrist2), composite inertia
  const Lanes<2> M_2_2_p109_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) +
      (0.00444264243991307 * detail::make_pack<Real>(s13, s20) - M_10_11_lanes);

  // link 23 (left_eye), composite inertia
  const Real M_2_2_p111 = M_2_2_p91_lanes[1] + M_2_2_p91_lanes[0];

  // link 12 (left_wrist2), composite inertia
  const Lanes<2> M_2_2_p116_lanes = 0.00026627370534756023 - M_2_2_p27_lanes - M_2_2_p93_lanes;

  // link 11 (left_wrist1), composite inertia
  const Lanes<2> M_2_2_p118_lanes = 0.0014999985000000002 + M_2_2_p103_lanes;

  // link 23 (left_eye), composite inertia
  const Real M_2_2_p122 = 0.0074 + M_2_2_p75_lanes[1] + M_2_2_p75_lanes[0];

  // link 10 (left_lowerarm), composite inertia
  const Lanes<2> M_2_6_p1_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      M_2_2_p105_lanes;

  // link 23 (left_eye), composite inertia
  const Lanes<2> M_2_2_p124_lanes = 0.00025 * detail::make_pack<Real>(c23, c24);
  const Real M_2_2_p128 = 0.009457125 + 2.0 * (M_2_2_p73_lanes[1] + M_2_2_p73_lanes[0]);

  // link 12 (left_wrist2), composite inertia
  const Lanes<2> M_2_2_p129_lanes = 0.0010696316083993109 + M_2_2_p93_lanes + M_2_2_p65_lanes;

  // link 11 (left_wrist1), composite inertia
  const Lanes<2> M_2_2_p135_lanes = 0.00051019984685315 + M_2_2_p116_lanes;

  // link 12 (left_wrist2), composite inertia
  const Lanes<2> M_2_2_p144_lanes = 0.000144 - (M_2_2_p21_lanes -
      detail::make_pack<Real>(c12, c19) * M_2_2_p77_lanes + 0.269 * M_2_2_p51_lanes);

  // link 10 (left_lowerarm), composite inertia
  const Lanes<2> M_2_2_p148_lanes = detail::make_pack<Real>(s10, s17) * M_2_2_p118_lanes +
      detail::make_pack<Real>(c10, c17) * M_2_2_p71_lanes;
  const Lanes<2> M_2_2_p150_lanes = detail::make_pack<Real>(s10, s17) * M_2_2_p71_lanes -
      detail::make_pack<Real>(c10, c17) * M_2_2_p118_lanes;

  // link 23 (left_eye), composite inertia
  const Real M_2_2_p152 = 0.05451070000000001 + M_2_2_p111 + (-1.6e-05) * s24 + 1.6e-05 * s23;
  const Real M_2_2_p157 = 0.072575 + M_2_2_p124_lanes[1] + M_2_2_p124_lanes[0];
  const Lanes<2> M_2_2_p158_lanes = (detail::make_pack<Real>(8e-06, (-8e-06)) + M_2_2_p63_lanes) *
      detail::make_pack<Real>(c23, c24);
  const Lanes<2> M_21_22_lanes = 2.8750000000000004e-05 * detail::make_pack<Real>(s23, s24);
  M[526] = -M_21_22_lanes[0];
  M[549] = -M_21_22_lanes[0];

  // link 24 (right_eye), composite inertia
  M[527] = -M_21_22_lanes[1];
  M[573] = -M_21_22_lanes[1];

  // link 10 (left_lowerarm), composite inertia
  const Lanes<2> M_2_2_p160_lanes = 0.564 * M_2_2_p148_lanes;
  const Lanes<2> M_2_6_p3_lanes = 0.0022500062 + M_2_2_p150_lanes;

  // link 9 (left_upperarm), composite inertia
  const Lanes<2> M_2_6_p4_lanes = 0.7139200499999999 + M_2_2_p148_lanes;

  // link 11 (left_wrist1), composite inertia
  const Lanes<2> M_2_2_p166_lanes = detail::make_pack<Real>(s11, s18) *
      (M_2_2_p129_lanes - M_2_2_p101_lanes) + detail::make_pack<Real>(c11, c18) *
      (2.0 * M_2_2_p97_lanes);
  const Lanes<2> M_2_2_p168_lanes = detail::make_pack<Real>(c11, c18) * M_2_2_p144_lanes -
      detail::make_pack<Real>(s11, s18) * M_2_2_p109_lanes;
  const Lanes<2> M_9_10_lanes = detail::make_pack<Real>(s11, s18) * M_2_2_p144_lanes +
      detail::make_pack<Real>(c11, c18) * M_2_2_p109_lanes;
  M[226] = M_9_10_lanes[0];
  M[249] = M_9_10_lanes[0];

  // link 18 (right_wrist1), composite inertia
  M[401] = M_9_10_lanes[1];
  M[424] = M_9_10_lanes[1];

  // link 23 (left_eye), composite inertia
  const Real M_2_2_p172 = M_21_22_lanes[1] + M_21_22_lanes[0];
  const Real M_21_21 = 0.063951825 - M_2_2_p111 + 4.75e-05 * (c24 + c23);
  M[525] = M_21_21;

  // link 11 (left_wrist1), composite inertia
  const Lanes<2> M_2_2_p177_lanes = detail::make_pack<Real>(s11, s18) * M_2_2_p166_lanes;
  const Lanes<2> M_2_2_p179_lanes = 0.0001499998887063 + M_2_2_p168_lanes;
  const Lanes<2> M_2_2_p183_lanes = detail::make_pack<Real>((-0.0001499998887063),
      0.0001499998887063) - M_9_10_lanes;

  // link 22 (head), composite inertia
  const Real M_2_2_p185 = 0.43200000000000005 * c22 - s22 * M_2_2_p157;

  // link 23 (left_eye), composite inertia
  const Real M_2_2_p186 = M_2_2_p158_lanes[0] + 2.375e-05 * (s24 + s23) + M_2_2_p158_lanes[1];

  // link 22 (head), composite inertia
  const Real M_2_2_p187 = s22 * (M_2_2_p152 - M_2_2_p128) + c22 * (2.0 * M_2_2_p122);

  // link 9 (left_upperarm), composite inertia
  const Lanes<2> M_2_6_p9_lanes = detail::make_pack<Real>(s9, s16) * M_2_6_p3_lanes -
      detail::make_pack<Real>(c9, c16) * M_2_6_p1_lanes;
  const Lanes<2> M_2_6_p10_lanes = detail::make_pack<Real>(c9, c16) * M_2_6_p3_lanes +
      detail::make_pack<Real>(s9, s16) * M_2_6_p1_lanes;

  // link 22 (head), composite inertia
  const Real M_2_2_p198 = 0.788 * M_2_2_p185;
  const Real M_2_2_p199 = s22 * M_2_2_p187;

  // link 9 (left_upperarm), composite inertia
  const Lanes<2> M_2_6_p11_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) - M_2_6_p9_lanes;

  // link 23 (left_eye), composite inertia
  const Lanes<2> M_5_20_p1_lanes = 0.00025 * detail::make_pack<Real>(s23, s24);

  // link 11 (left_wrist1), composite inertia
  const Lanes<2> M_2_2_p201_lanes = 0.06060754126741261 + (M_2_2_p129_lanes - M_2_2_p177_lanes);
  const Lanes<2> M_2_2_p205_lanes = detail::make_pack<Real>((-2.249994685315e-05),
      2.249994685315e-05) + (detail::make_pack<Real>(c11, c18) * M_2_2_p166_lanes -
      M_2_2_p97_lanes);
  const Lanes<2> M_9_9_lanes = 0.060888541114265754 + (M_2_2_p101_lanes + M_2_2_p177_lanes);
  M[225] = M_9_9_lanes[0];

  // link 18 (right_wrist1), composite inertia
  M[400] = M_9_9_lanes[1];

  // link 22 (head), composite inertia
  const Real M_2_2_p208 = M_21_21 + M_2_2_p198;

  // link 8 (left_shoulder2), composite inertia
  const Lanes<2> M_2_6_p13_lanes = 0.0017499999999999998 - M_2_6_p10_lanes;

  // link 22 (head), composite inertia
  const Real M_5_20_p3 = c22 * M_2_2_p157 + 0.43200000000000005 * s22;
  const Real M_2_2_p210 = M_2_2_p128 + M_2_2_p199;
  const Real M_2_2_p219 = c22 * M_2_2_p186 + s22 * M_2_2_p172;

  // link 23 (left_eye), composite inertia
  const Real M_5_20_p4 = M_5_20_p1_lanes[1] + M_5_20_p1_lanes[0];

  // link 22 (head), composite inertia
  const Real M_2_2_p220 = M_2_2_p152 - M_2_2_p199 + M_2_2_p198;

  // link 8 (left_shoulder2), composite inertia
  const Lanes<2> M_2_6_p14_lanes = detail::make_pack<Real>(c8, c15) * M_2_6_p4_lanes -
      detail::make_pack<Real>(s8, s15) * M_2_6_p11_lanes;

  // link 22 (head), composite inertia
  const Real M_20_21 = s22 * M_2_2_p186 - c22 * M_2_2_p172;
  M[501] = M_20_21;
  M[524] = M_20_21;

  // link 10 (left_lowerarm), composite inertia
  const Lanes<2> M_2_2_p224_lanes = 0.0008177492704690715 + (M_9_9_lanes + M_2_2_p160_lanes);
  const Lanes<2> M_2_2_p227_lanes = detail::make_pack<Real>(s10, s17) * M_2_2_p183_lanes -
      detail::make_pack<Real>(c10, c17) * M_2_2_p205_lanes;
  const Lanes<2> M_8_9_lanes = detail::make_pack<Real>(s10, s17) * M_2_2_p205_lanes +
      detail::make_pack<Real>(c10, c17) * M_2_2_p183_lanes;
  M[201] = -M_8_9_lanes[0];
  M[224] = -M_8_9_lanes[0];

  // link 17 (right_lowerarm), composite inertia
  M[376] = -M_8_9_lanes[1];
  M[399] = -M_8_9_lanes[1];

  // link 21 (neck), composite inertia
  const Real M_2_2_p229 = s21 * M_2_2_p219;

  // link 8 (left_shoulder2), composite inertia
  const Lanes<2> M_2_6_p16_lanes = M_2_6_p14_lanes - 0.0017499999999999998;
  const Lanes<2> M_2_2_p231_lanes = detail::make_pack<Real>(s8, s15) * M_2_6_p4_lanes +
      detail::make_pack<Real>(c8, c15) * M_2_6_p11_lanes;

  // link 22 (head), composite inertia
  const Real M_2_2_p233 = 0.0045000000000000005 + M_5_20_p3;

  // link 10 (left_lowerarm), composite inertia
  const Lanes<2> M_2_2_p234_lanes = detail::make_pack<Real>(c10, c17) * (2.0 * M_2_2_p179_lanes) -
      detail::make_pack<Real>(s10, s17) * (M_2_2_p201_lanes - M_2_2_p135_lanes);
  const Lanes<2> M_2_2_p236_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - M_2_2_p227_lanes;

  // link 22 (head), composite inertia
  const Real M_5_20_p5 = M_20_21 - 0.394 * M_5_20_p4;
  const Real M_5_20_p6 = 0.0016155 + (c22 * M_2_2_p187 - M_2_2_p122 + 0.394 * M_5_20_p3);

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p241 = M_2_2_p231_lanes[1] + M_2_2_p231_lanes[0];

  // link 10 (left_lowerarm), composite inertia
  const Lanes<2> M_2_2_p242_lanes = detail::make_pack<Real>(s10, s17) * M_2_2_p234_lanes;
  const Lanes<2> M_2_2_p248_lanes = detail::make_pack<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + (0.282 * M_2_2_p105_lanes - M_8_9_lanes);

  // link 7 (left_shoulder1), composite inertia
  const Lanes<2> M_2_6_p18_lanes = detail::make_pack<Real>(s7, s14) * M_2_6_p13_lanes +
      detail::make_pack<Real>(c7, c14) * M_2_6_p16_lanes;
  const Lanes<2> M_5_6_p3_lanes = detail::make_pack<Real>(c7, c14) * M_2_6_p13_lanes -
      detail::make_pack<Real>(s7, s14) * M_2_6_p16_lanes;

  // link 10 (left_lowerarm), composite inertia
  const Lanes<2> M_2_2_p259_lanes = M_2_2_p135_lanes - M_2_2_p242_lanes;

  // link 21 (neck), composite inertia
  const Real M_2_2_p261 = c21 * (0.005513625 + M_2_2_p220 - (0.000703125 + M_2_2_p208)) + 2.0 *
      M_2_2_p229;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p263 = M_2_6_p18_lanes[1] + M_2_6_p18_lanes[0];

  // link 21 (neck), composite inertia
  const Real M_5_20 = c21 * M_5_20_p6 + s21 * M_5_20_p5;
  M[140] = -M_5_20;
  M[485] = -M_5_20;
  const Real M_2_2_p264 = s21 * M_5_20_p6 - c21 * M_5_20_p5;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p265 = M_5_6_p3_lanes[1] + M_5_6_p3_lanes[0];

  // link 9 (left_upperarm), composite inertia
  const Lanes<2> M_2_2_p270_lanes = 0.0028970433559338655 + M_2_2_p259_lanes;

  // link 21 (neck), composite inertia
  const Real M_2_2_p272 = s21 * M_2_2_p233 + c21 * M_5_20_p4;
  const Real M_2_2_p273 = c21 * M_2_2_p261;

  // link 7 (left_shoulder1), composite inertia
  const Lanes<2> M_5_5_p3_lanes = 0.226 * M_2_6_p18_lanes;

  // link 10 (left_lowerarm), composite inertia
  const Lanes<2> M_2_2_p274_lanes = 0.0019585440854647937 +
      (M_2_2_p201_lanes + M_2_2_p242_lanes + M_2_2_p160_lanes);
  const Lanes<2> M_2_2_p276_lanes = 0.0005895000784280001 +
      (M_2_2_p179_lanes - detail::make_pack<Real>(c10, c17) * M_2_2_p234_lanes + 0.282 *
      M_2_2_p150_lanes);

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p278 = M_2_2_p263 - 6.1665928899999995 - M_2_2_p185;
  const Real M_2_2_p279 = M_2_2_p272 + M_2_2_p241;
  const Lanes<2> M_5_5_p5_lanes = detail::make_pack<Real>(0.18, (-0.18)) * M_2_2_p231_lanes -
      M_5_5_p3_lanes;

  // link 21 (neck), composite inertia
  const Real M_2_2_p284 = c21 * M_2_2_p233 - s21 * M_5_20_p4;

  // link 9 (left_upperarm), composite inertia
  const Lanes<2> M_2_2_p287_lanes = detail::make_pack<Real>(s9, s16) * M_2_2_p276_lanes -
      detail::make_pack<Real>(c9, c16) * M_2_2_p248_lanes;
  const Lanes<2> M_7_8_lanes = detail::make_pack<Real>(c9, c16) * M_2_2_p276_lanes +
      detail::make_pack<Real>(s9, s16) * M_2_2_p248_lanes;
  M[176] = -M_7_8_lanes[0];
  M[199] = -M_7_8_lanes[0];

  // link 16 (right_upperarm), composite inertia
  M[351] = -M_7_8_lanes[1];
  M[374] = -M_7_8_lanes[1];

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p289 = M_2_2_p284 + M_2_2_p265;

  // link 6 (chest3), composite inertia
  const Real M_2_2_p290 = c6 * M_2_2_p278 - s6 * M_2_2_p279;
  const Real M_2_2_p291 = s6 * M_2_2_p278 + c6 * M_2_2_p279;

  // link 9 (left_upperarm), composite inertia
  const Lanes<2> M_2_2_p292_lanes = detail::make_pack<Real>(c9, c16) *
      (M_2_2_p274_lanes - M_2_2_p224_lanes) - detail::make_pack<Real>(s9, s16) *
      (2.0 * M_2_2_p236_lanes);
  const Lanes<2> M_2_2_p294_lanes = detail::make_pack<Real>((-5.2499999999999995e-05),
      5.2499999999999995e-05) + M_2_2_p287_lanes;
  const Lanes<2> M_2_2_p296_lanes = M_7_8_lanes - 0.00010499999999999999;

  // link 6 (chest3), composite inertia
  const Real M_2_2_p298 = 0.144 * M_2_2_p290;
  const Real M_1_1_p1 = M_2_2_p290 - 2.2194301519999997;
  const Real M_1_1_p2 = 0.069699984375 + M_2_2_p289;

  // link 9 (left_upperarm), composite inertia
  const Lanes<2> M_2_2_p299_lanes = detail::make_pack<Real>(c9, c16) * M_2_2_p292_lanes;
  const Real M_1_1_p3 = 0.422 * s2;
  const Real M_1_1_p4 = 0.422 * c2;
  const Real M_1_1_p5 = c2 * c3 - s2 * s3;
  const Lanes<2> M_2_2_p313_lanes = M_2_2_p224_lanes + M_2_2_p299_lanes;

  // link 5 (chest2), composite inertia
  const Real M_1_1_p6 = s5 * M_1_1_p1 - c5 * M_1_1_p2;
  const Real M_1_1_p7 = s5 * M_1_1_p2 + c5 * M_1_1_p1;
  const Real M_1_1_p8 = s2 * c3 + c2 * s3;

  // link 9 (left_upperarm), composite inertia
  const Lanes<2> M_2_2_p315_lanes = 0.18113119219699997 + (M_2_2_p274_lanes - M_2_2_p299_lanes);
  const Lanes<2> M_2_2_p317_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * M_2_2_p292_lanes + M_2_2_p236_lanes);

  // link 8 (left_shoulder2), composite inertia
  const Lanes<2> M_2_2_p319_lanes = 0.18140244219699997 + M_2_2_p313_lanes;

  // link 4 (chest1), composite inertia
  const Real M_1_1_p9 = M_1_1_p7 - 8.419374554;

  // link 5 (chest2), composite inertia
  const Real M_1_3_p1 = c4 * M_2_2_p291;

  // link 8 (left_shoulder2), composite inertia
  const Lanes<2> M_2_2_p327_lanes = detail::make_pack<Real>(c8, c15) * M_2_2_p296_lanes -
      detail::make_pack<Real>(s8, s15) * M_2_2_p317_lanes;
  const Lanes<2> M_6_7_lanes = detail::make_pack<Real>(s8, s15) * M_2_2_p296_lanes +
      detail::make_pack<Real>(c8, c15) * M_2_2_p317_lanes;
  M[151] = M_6_7_lanes[0];
  M[174] = M_6_7_lanes[0];

  // link 15 (right_shoulder2), composite inertia
  M[326] = M_6_7_lanes[1];
  M[349] = M_6_7_lanes[1];

  // link 4 (chest1), composite inertia
  const Real M_1_1_p10 = 0.02999999505 + s4 * M_2_2_p291 + (0.0300000063 + M_1_1_p6) * c4;

  // link 5 (chest2), composite inertia
  const Real M_1_3_p2 = M_1_3_p1 - s4 * M_1_1_p6;

  // link 8 (left_shoulder2), composite inertia
  const Lanes<2> M_2_2_p329_lanes = detail::make_pack<Real>(s8, s15) *
      (M_2_2_p270_lanes - M_2_2_p315_lanes) + detail::make_pack<Real>(c8, c15) *
      (2.0 * M_2_2_p294_lanes);
  const Lanes<2> M_2_2_p331_lanes = M_2_2_p327_lanes - 8.75e-06;
  const Lanes<2> M_2_6_p20_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + M_6_7_lanes;

  // link 5 (chest2), composite inertia
  const Real M_1_3_p3 = M_1_3_p2 - 0.0300000063 * s4;

  // link 5 (chest2), mass matrix
  const Real M_1_4_p1 = c4 * M_1_1_p7;

  // link 8 (left_shoulder2), composite inertia
  const Lanes<2> M_2_2_p334_lanes = detail::make_pack<Real>(s8, s15) * M_2_2_p329_lanes;

  // link 3 (hip), composite inertia
  const Real M_1_1_p11 = M_1_1_p5 * M_1_1_p9 - M_1_1_p8 * M_1_1_p10;

  // link 4 (chest1), mass matrix
  const Real M_1_3_p4 = M_1_1_p5 * M_1_3_p3;

  // link 5 (chest2), mass matrix
  const Real M_1_4_p2 = M_1_1_p8 * M_1_1_p6 - M_1_1_p5 * M_1_4_p1;

  // link 3 (hip), composite inertia
  const Real M_0_0_p1 = 0.031999971599999996 * s2 - 24.5839218 * c2 + M_1_1_p11;

  // link 8 (left_shoulder2), composite inertia
  const Lanes<2> M_2_2_p345_lanes = 0.0002975 + (M_2_2_p270_lanes - M_2_2_p334_lanes);
  const Lanes<2> M_2_6_p24_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * M_2_2_p329_lanes -
      M_2_2_p294_lanes);
  const Lanes<2> M_6_6_lanes = 0.000448 + (M_2_2_p315_lanes + M_2_2_p334_lanes);
  M[150] = M_6_6_lanes[0];

  // link 15 (right_shoulder2), composite inertia
  M[325] = M_6_6_lanes[1];

  // link 6 (chest3), mass matrix
  const Real M_1_5_p1 = c5 * M_2_2_p291;

  // link 3 (hip), composite inertia
  const Real M_1_1_p12 = M_1_1_p3 * (M_1_1_p5 * M_1_1_p10 + M_1_1_p8 * M_1_1_p9) + M_1_1_p4 *
      M_1_1_p11;

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_2_6_p26_lanes = M_6_6_lanes - M_5_5_p3_lanes;
  const Lanes<2> M_2_6_p27_lanes = s6 * M_5_6_p3_lanes;

  // link 6 (chest3), mass matrix
  const Real M_1_5_p2 = M_1_3_p1 * s5 - s4 * M_2_2_p290;

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_1_6_p2_lanes = c6 * M_5_6_p3_lanes;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p354 = 1.67475326092404 + M_2_2_p220 - M_2_2_p273 + M_6_6_lanes[1] +
      M_6_6_lanes[0] - 0.452 * M_2_2_p263;
  const Lanes<2> M_2_2_p355_lanes = detail::make_pack<Real>(c7, c14) *
      (M_2_2_p319_lanes - M_2_2_p345_lanes) - detail::make_pack<Real>(s7, s14) *
      (2.0 * M_2_2_p331_lanes);
  const Lanes<2> M_2_6_p31_lanes = detail::make_pack<Real>(s7, s14) * M_2_6_p20_lanes +
      detail::make_pack<Real>(c7, c14) * M_2_6_p24_lanes - detail::make_pack<Real>(0.18, (-0.18)) *
      M_2_6_p18_lanes;
  const Lanes<2> M_5_6_lanes = detail::make_pack<Real>(c7, c14) * M_2_6_p20_lanes -
      detail::make_pack<Real>(s7, s14) * M_2_6_p24_lanes - detail::make_pack<Real>(0.18, (-0.18)) *
      M_5_6_p3_lanes;
  M[126] = M_5_6_lanes[0];
  M[149] = M_5_6_lanes[0];

  // link 14 (right_shoulder1), composite inertia
  M[133] = M_5_6_lanes[1];
  M[317] = M_5_6_lanes[1];

  // link 7 (left_shoulder1), composite inertia
  const Lanes<2> M_2_2_p358_lanes = detail::make_pack<Real>(c7, c14) * M_2_2_p355_lanes;
  const Lanes<2> M_2_2_p360_lanes = detail::make_pack<Real>(s7, s14) * M_2_2_p355_lanes;

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_2_6_p33_lanes = M_5_6_lanes - 0.072 * M_2_6_p27_lanes;

  // link 9 (left_upperarm), composite inertia
  const Lanes<2> M_7_7_lanes = 0.18125194219699997 + M_2_2_p313_lanes;
  M[175] = M_7_7_lanes[0];

  // link 16 (right_upperarm), composite inertia
  M[350] = M_7_7_lanes[1];

  // link 6 (chest3), mass matrix
  const Real M_1_5_p3 = M_1_1_p5 * M_1_5_p2 + M_1_1_p8 * M_1_5_p1;

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_2_7_p2_lanes = detail::make_pack<Real>(s7, s14) * M_2_2_p231_lanes;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p362 = M_5_6_lanes[1] - (M_2_2_p219 - s21 * M_2_2_p261) + M_5_6_lanes[0];

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_1_6_p8_lanes = s5 * M_2_6_p18_lanes - c5 * M_1_6_p2_lanes;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p363 = M_2_2_p358_lanes[1] + M_2_2_p358_lanes[0];

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_2_6_p35_lanes = c6 * M_2_6_p31_lanes - s6 * M_2_6_p26_lanes;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p364 = M_2_2_p264 + M_2_6_p31_lanes[1] + M_2_6_p31_lanes[0] + 0.226 * M_2_2_p241;

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_1_7_p1_lanes = detail::make_pack<Real>(c7, c14) * M_2_2_p231_lanes;
  const Lanes<2> M_2_7_p9_lanes = detail::make_pack<Real>(s7, s14) * M_7_7_lanes +
      detail::make_pack<Real>(c7, c14) * M_2_2_p327_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      M_2_7_p2_lanes;
  const Lanes<2> M_2_7_p10_lanes = M_6_7_lanes + 0.226 * M_2_7_p2_lanes;

  // link 7 (left_shoulder1), composite inertia
  const Real M_5_5 = 2.07035776092404 + M_2_2_p208 + M_2_2_p273 + M_2_2_p345_lanes[1] + M_2_2_p363 +
      M_2_2_p345_lanes[0] + 2.0 * (M_5_5_p5_lanes[1] + M_5_5_p5_lanes[0]);
  M[125] = M_5_5;

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_1_6_p10_lanes = s4 * M_2_6_p27_lanes + c4 *
      (c5 * M_2_6_p18_lanes + s5 * M_1_6_p2_lanes);

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_1_7_p6_lanes = c6 * M_1_7_p1_lanes + s6 * M_2_6_p14_lanes;
  const Lanes<2> M_2_7_p11_lanes = c6 * M_2_6_p14_lanes - s6 * M_1_7_p1_lanes;
  const Lanes<2> M_5_7_p6_lanes = detail::make_pack<Real>(0.18, (-0.18)) * M_1_7_p1_lanes - 0.226 *
      M_2_6_p14_lanes;

  // link 7 (left_shoulder1), composite inertia
  const Real M_2_2_p365 = 0.40663174999999996 + M_2_2_p210 + M_2_2_p319_lanes[1] - M_2_2_p363 +
      (-0.36) * M_2_2_p231_lanes[1] + M_2_2_p319_lanes[0] + 0.36 * M_2_2_p231_lanes[0];
  const Real M_2_2_p366 = 0.0187369177636143 + M_5_20 + M_2_2_p360_lanes[1] + M_2_2_p331_lanes[1] +
      M_2_2_p360_lanes[0] + M_2_2_p331_lanes[0] + 0.226 * M_2_2_p265;

  // link 6 (chest3), mass matrix
  const Real M_2_5_p1 = M_5_5 - 0.072 * M_2_2_p290;

  // link 10 (left_lowerarm), composite inertia
  const Lanes<2> M_8_8_lanes = 0.0027762933559338653 + M_2_2_p259_lanes;
  M[200] = M_8_8_lanes[0];

  // link 17 (right_lowerarm), composite inertia
  M[375] = M_8_8_lanes[1];

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_5_7_lanes = detail::make_pack<Real>(c7, c14) * M_7_7_lanes -
      detail::make_pack<Real>(s7, s14) * M_2_2_p327_lanes + M_5_7_p6_lanes;
  M[127] = M_5_7_lanes[0];
  M[173] = M_5_7_lanes[0];

  // link 15 (right_shoulder2), mass matrix
  M[134] = M_5_7_lanes[1];
  M[341] = M_5_7_lanes[1];

  // link 6 (chest3), composite inertia
  const Real M_2_2_p367 = 0.15637308509675518 + (M_5_5 - M_2_2_p298);

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_2_8_p3_lanes = detail::make_pack<Real>(s8, s15) * M_2_6_p10_lanes;

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_2_7_p15_lanes = c6 * M_2_7_p9_lanes - s6 * M_2_7_p10_lanes;

  // link 6 (chest3), composite inertia
  const Real M_2_2_p368 = c6 * M_2_2_p366 - s6 * M_2_2_p362;
  const Real M_4_5 = s6 * M_2_2_p366 + c6 * M_2_2_p362;
  M[101] = M_4_5;
  M[124] = M_4_5;

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_2_8_p7_lanes = detail::make_pack<Real>(s8, s15) * M_2_2_p287_lanes -
      detail::make_pack<Real>(c8, c15) * M_8_8_lanes;
  const Lanes<2> M_2_8_p8_lanes = detail::make_pack<Real>(c8, c15) * M_2_6_p10_lanes;

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_2_7_p16_lanes = M_5_7_lanes - 0.072 * M_2_7_p11_lanes;

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_6_8_lanes = detail::make_pack<Real>(s8, s15) * M_8_8_lanes +
      detail::make_pack<Real>(c8, c15) * M_2_2_p287_lanes;
  M[152] = -M_6_8_lanes[0];
  M[198] = -M_6_8_lanes[0];

  // link 16 (right_upperarm), mass matrix
  M[327] = -M_6_8_lanes[1];
  M[373] = -M_6_8_lanes[1];

  // link 6 (chest3), composite inertia
  const Real M_2_2_p369 = s6 * (M_2_2_p365 - M_2_2_p354) + c6 * (2.0 * M_2_2_p364);

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_1_7_p12_lanes = c5 * M_1_7_p6_lanes - s5 * M_2_7_p2_lanes;

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_1_8_p3_lanes = detail::make_pack<Real>(s7, s14) * M_2_6_p9_lanes +
      detail::make_pack<Real>(c7, c14) * M_2_8_p3_lanes;
  const Lanes<2> M_2_8_p10_lanes = detail::make_pack<Real>(c7, c14) * M_2_6_p9_lanes -
      detail::make_pack<Real>(s7, s14) * M_2_8_p3_lanes;

  // link 6 (chest3), composite inertia
  const Real M_2_2_p370 = s6 * M_2_2_p369;
  const Real M_2_2_p371 = 0.005678398088837119 + (M_2_2_p368 + 0.072 * M_2_2_p289);

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_5_8_p5_lanes = detail::make_pack<Real>(c7, c14) * M_7_8_lanes +
      detail::make_pack<Real>(s7, s14) * M_2_8_p7_lanes;

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_1_7_p13_lanes = c4 * (c5 * M_2_7_p2_lanes + s5 * M_1_7_p6_lanes) - s4 *
      M_2_7_p11_lanes;

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_1_8_p8_lanes = c6 * M_1_8_p3_lanes + s6 * M_2_8_p8_lanes;
  const Lanes<2> M_2_8_p16_lanes = detail::make_pack<Real>(0.18, (-0.18)) * M_2_8_p10_lanes -
      (detail::make_pack<Real>(s7, s14) * M_7_8_lanes - detail::make_pack<Real>(c7, c14) *
      M_2_8_p7_lanes);
  const Lanes<2> M_2_8_p17_lanes = 0.226 * M_2_8_p10_lanes - M_6_8_lanes;
  const Lanes<2> M_2_8_p18_lanes = s6 * M_1_8_p3_lanes - c6 * M_2_8_p8_lanes;

  // link 6 (chest3), composite inertia
  const Real M_2_2_p372 = 0.04675382692737882 + (M_2_2_p365 - M_2_2_p370);
  const Real M_2_2_p373 = c6 * M_2_2_p369 - M_2_2_p364 + 0.072 * M_2_2_p291;
  const Real M_4_4_p1 = M_2_2_p354 + M_2_2_p370 - M_2_2_p298;

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_5_8_lanes = 0.226 * M_2_8_p8_lanes - detail::make_pack<Real>(0.18, (-0.18)) *
      M_1_8_p3_lanes - M_5_8_p5_lanes;
  M[128] = M_5_8_lanes[0];
  M[197] = M_5_8_lanes[0];

  // link 16 (right_upperarm), mass matrix
  M[135] = M_5_8_lanes[1];
  M[365] = M_5_8_lanes[1];

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_1_9_p1_lanes = detail::make_pack<Real>(s9, s16) * M_2_2_p148_lanes;
  const Lanes<2> M_2_9_p4_lanes = M_9_9_lanes + 0.282 * M_2_2_p148_lanes;
  const Lanes<2> M_2_9_p5_lanes = detail::make_pack<Real>(c9, c16) * M_2_2_p148_lanes;

  // link 6 (chest3), composite inertia
  const Real M_4_4 = 0.203126912024134 + M_4_4_p1;
  M[100] = M_4_4;

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_2_8_p22_lanes = c6 * M_2_8_p16_lanes - s6 * M_2_8_p17_lanes;
  const Lanes<2> M_2_8_p23_lanes = M_5_8_lanes - 0.072 * M_2_8_p18_lanes;

  // link 5 (chest2), composite inertia
  const Real M_2_2_p374 = s5 * M_2_2_p373 - c5 * M_4_5;

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_1_8_p14_lanes = s5 * M_2_8_p10_lanes + c5 * M_1_8_p8_lanes;

  // link 5 (chest2), composite inertia
  const Real M_2_2_p375 = s5 * (M_2_2_p367 - M_2_2_p372) + c5 * (2.0 * M_2_2_p371);

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_1_9_p7_lanes = detail::make_pack<Real>(s8, s15) * M_1_9_p1_lanes -
      detail::make_pack<Real>(c8, c15) * M_2_2_p150_lanes;
  const Lanes<2> M_2_9_p8_lanes = detail::make_pack<Real>(s9, s16) * M_2_2_p227_lanes -
      detail::make_pack<Real>(c9, c16) * M_2_9_p4_lanes;
  const Lanes<2> M_7_9_lanes = detail::make_pack<Real>(c9, c16) * M_2_2_p227_lanes +
      detail::make_pack<Real>(s9, s16) * M_2_9_p4_lanes;
  M[177] = -M_7_9_lanes[0];
  M[223] = -M_7_9_lanes[0];

  // link 17 (right_lowerarm), mass matrix
  M[352] = -M_7_9_lanes[1];
  M[398] = -M_7_9_lanes[1];

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_1_8_p15_lanes = c4 * (s5 * M_1_8_p8_lanes - c5 * M_2_8_p10_lanes) + s4 *
      M_2_8_p18_lanes;

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_1_9_p8_lanes = detail::make_pack<Real>(s8, s15) * M_2_2_p150_lanes +
      detail::make_pack<Real>(c8, c15) * M_1_9_p1_lanes;

  // link 5 (chest2), composite inertia
  const Real M_2_2_p376 = s5 * M_2_2_p375;

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_1_9_p11_lanes = detail::make_pack<Real>(s7, s14) * M_2_9_p5_lanes -
      detail::make_pack<Real>(c7, c14) * M_1_9_p7_lanes;
  const Lanes<2> M_2_9_p13_lanes = detail::make_pack<Real>(c8, c15) * M_8_9_lanes +
      detail::make_pack<Real>(s8, s15) * M_2_9_p8_lanes;
  const Lanes<2> M_2_9_p14_lanes = detail::make_pack<Real>(c7, c14) * M_2_9_p5_lanes +
      detail::make_pack<Real>(s7, s14) * M_1_9_p7_lanes;
  const Lanes<2> M_6_9_lanes = detail::make_pack<Real>(s8, s15) * M_8_9_lanes -
      detail::make_pack<Real>(c8, c15) * M_2_9_p8_lanes;
  M[153] = M_6_9_lanes[0];
  M[222] = M_6_9_lanes[0];

  // link 17 (right_lowerarm), mass matrix
  M[328] = M_6_9_lanes[1];
  M[397] = M_6_9_lanes[1];

  // link 5 (chest2), composite inertia
  const Real M_3_4 = s5 * M_4_5 + c5 * M_2_2_p373;
  M[76] = -M_3_4;
  M[99] = -M_3_4;

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_4_6_lanes = s6 * M_2_6_p31_lanes + c6 * M_2_6_p26_lanes - 0.072 *
      M_2_6_p18_lanes;
  M[102] = M_4_6_lanes[0];
  M[148] = M_4_6_lanes[0];

  // link 14 (right_shoulder1), mass matrix
  M[109] = M_4_6_lanes[1];
  M[316] = M_4_6_lanes[1];

  // link 12 (left_wrist2), composite inertia
  const Lanes<2> M_10_10_lanes = 0.00022920000000000001 + M_2_2_p116_lanes;
  M[250] = M_10_10_lanes[0];

  // link 19 (right_wrist2), composite inertia
  M[425] = M_10_10_lanes[1];

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_2_10_p3_lanes = detail::make_pack<Real>(c10, c17) * M_2_2_p105_lanes;

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_1_9_p15_lanes = s6 * M_1_9_p8_lanes - c6 * M_1_9_p11_lanes;

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_4_7_lanes = s6 * M_2_7_p9_lanes + c6 * M_2_7_p10_lanes + 0.072 * M_2_7_p2_lanes;
  M[103] = M_4_7_lanes[0];
  M[172] = M_4_7_lanes[0];

  // link 15 (right_shoulder2), mass matrix
  M[110] = M_4_7_lanes[1];
  M[340] = M_4_7_lanes[1];

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_2_9_p20_lanes = M_6_9_lanes - 0.226 * M_2_9_p14_lanes;
  const Lanes<2> M_2_9_p21_lanes = s6 * M_1_9_p11_lanes + c6 * M_1_9_p8_lanes;
  const Lanes<2> M_5_9_p5_lanes = detail::make_pack<Real>(c7, c14) * M_7_9_lanes +
      detail::make_pack<Real>(s7, s14) * M_2_9_p13_lanes;
  const Lanes<2> M_2_9_p22_lanes = detail::make_pack<Real>(s7, s14) * M_7_9_lanes -
      detail::make_pack<Real>(c7, c14) * M_2_9_p13_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      M_2_9_p14_lanes;

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_1_10_p5_lanes = detail::make_pack<Real>(s10, s17) * M_2_2_p105_lanes;
  const Lanes<2> M_8_10_lanes = detail::make_pack<Real>(c10, c17) * M_10_10_lanes -
      detail::make_pack<Real>(s10, s17) * M_2_2_p168_lanes;
  M[202] = M_8_10_lanes[0];
  M[248] = M_8_10_lanes[0];

  // link 18 (right_wrist1), mass matrix
  M[377] = M_8_10_lanes[1];
  M[423] = M_8_10_lanes[1];

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_2_10_p7_lanes = detail::make_pack<Real>(c10, c17) * M_2_2_p168_lanes +
      detail::make_pack<Real>(s10, s17) * M_10_10_lanes + 0.282 * M_2_2_p103_lanes;
  const Lanes<2> M_2_10_p8_lanes = M_9_10_lanes + 0.282 * M_2_10_p3_lanes;
  const Lanes<2> M_1_10_p6_lanes = detail::make_pack<Real>(c9, c16) * M_2_10_p3_lanes +
      detail::make_pack<Real>(s9, s16) * M_2_2_p103_lanes;
  const Lanes<2> M_1_10_p7_lanes = detail::make_pack<Real>(s9, s16) * M_2_10_p3_lanes -
      detail::make_pack<Real>(c9, c16) * M_2_2_p103_lanes;

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_5_9_lanes = 0.226 * M_1_9_p8_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      M_1_9_p11_lanes - M_5_9_p5_lanes;
  M[129] = M_5_9_lanes[0];
  M[221] = M_5_9_lanes[0];

  // link 17 (right_lowerarm), mass matrix
  M[136] = M_5_9_lanes[1];
  M[389] = M_5_9_lanes[1];

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_2_9_p26_lanes = c6 * M_2_9_p22_lanes + s6 * M_2_9_p20_lanes;
  const Lanes<2> M_2_9_p27_lanes = M_5_9_lanes + 0.072 * M_2_9_p21_lanes;
  const Lanes<2> M_1_9_p21_lanes = s5 * M_2_9_p14_lanes - c5 * M_1_9_p15_lanes;

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_2_10_p13_lanes = detail::make_pack<Real>(s9, s16) * M_2_10_p7_lanes +
      detail::make_pack<Real>(c9, c16) * M_2_10_p8_lanes;

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_4_8_lanes = s6 * M_2_8_p16_lanes + c6 * M_2_8_p17_lanes + 0.072 *
      M_2_8_p10_lanes;
  M[104] = M_4_8_lanes[0];
  M[196] = M_4_8_lanes[0];

  // link 16 (right_upperarm), mass matrix
  M[111] = M_4_8_lanes[1];
  M[364] = M_4_8_lanes[1];

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_1_10_p13_lanes = detail::make_pack<Real>(s8, s15) * M_1_10_p7_lanes -
      detail::make_pack<Real>(c8, c15) * M_1_10_p5_lanes;
  const Lanes<2> M_1_10_p14_lanes = detail::make_pack<Real>(s8, s15) * M_1_10_p5_lanes +
      detail::make_pack<Real>(c8, c15) * M_1_10_p7_lanes;
  const Lanes<2> M_7_10_lanes = detail::make_pack<Real>(c9, c16) * M_2_10_p7_lanes -
      detail::make_pack<Real>(s9, s16) * M_2_10_p8_lanes;
  M[178] = M_7_10_lanes[0];
  M[247] = M_7_10_lanes[0];

  // link 18 (right_wrist1), mass matrix
  M[353] = M_7_10_lanes[1];
  M[422] = M_7_10_lanes[1];

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_1_9_p22_lanes = s4 * M_2_9_p21_lanes - c4 *
      (c5 * M_2_9_p14_lanes + s5 * M_1_9_p15_lanes);

  // link 4 (chest1), composite inertia
  const Real M_2_2_p377 = 0.03561389675370483 * s4 -
      (c4 * (2.0 * M_2_2_p374) - s4 * (M_2_2_p367 - M_2_2_p376 - M_4_4));

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_4_9_lanes = c6 * M_2_9_p20_lanes - s6 * M_2_9_p22_lanes - 0.072 *
      M_2_9_p14_lanes;
  M[105] = M_4_9_lanes[0];
  M[220] = M_4_9_lanes[0];

  // link 17 (right_lowerarm), mass matrix
  M[112] = M_4_9_lanes[1];
  M[388] = M_4_9_lanes[1];

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_2_10_p18_lanes = detail::make_pack<Real>(c8, c15) * M_8_10_lanes +
      detail::make_pack<Real>(s8, s15) * M_2_10_p13_lanes;
  const Lanes<2> M_6_10_lanes = detail::make_pack<Real>(c8, c15) * M_2_10_p13_lanes -
      detail::make_pack<Real>(s8, s15) * M_8_10_lanes;
  M[154] = M_6_10_lanes[0];
  M[246] = M_6_10_lanes[0];

  // link 18 (right_wrist1), mass matrix
  M[329] = M_6_10_lanes[1];
  M[421] = M_6_10_lanes[1];

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_1_10_p17_lanes = detail::make_pack<Real>(s7, s14) * M_1_10_p6_lanes -
      detail::make_pack<Real>(c7, c14) * M_1_10_p13_lanes;
  const Lanes<2> M_2_10_p19_lanes = detail::make_pack<Real>(c7, c14) * M_1_10_p6_lanes +
      detail::make_pack<Real>(s7, s14) * M_1_10_p13_lanes;

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_1_6_p15_lanes = M_1_1_p8 * M_1_6_p8_lanes - M_1_1_p5 * M_1_6_p10_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_2_11_p4_lanes = detail::make_pack<Real>(s11, s18) * M_2_2_p49_lanes;
  const Lanes<2> M_1_11_p1_lanes = detail::make_pack<Real>(c11, c18) * M_2_2_p49_lanes;
  const Lanes<2> M_2_11_p5_lanes = M_11_11_lanes + 0.269 * M_2_2_p49_lanes;

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_1_10_p21_lanes = s6 * M_1_10_p14_lanes - c6 * M_1_10_p17_lanes;
  const Lanes<2> M_2_10_p25_lanes = s6 * M_1_10_p17_lanes + c6 * M_1_10_p14_lanes;
  const Lanes<2> M_2_10_p26_lanes = detail::make_pack<Real>(c7, c14) * M_2_10_p18_lanes -
      detail::make_pack<Real>(s7, s14) * M_7_10_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      M_2_10_p19_lanes;
  const Lanes<2> M_2_10_p27_lanes = M_6_10_lanes - 0.226 * M_2_10_p19_lanes;
  const Lanes<2> M_5_10_p6_lanes = 0.226 * M_1_10_p14_lanes +
      detail::make_pack<Real>(0.18, (-0.18)) * M_1_10_p17_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_2_11_p8_lanes = detail::make_pack<Real>(c11, c18) * M_2_2_p79_lanes +
      detail::make_pack<Real>(s11, s18) * M_2_11_p5_lanes;
  const Lanes<2> M_1_11_p7_lanes = detail::make_pack<Real>(c10, c17) * M_1_11_p1_lanes -
      detail::make_pack<Real>(s10, s17) * M_2_2_p51_lanes;
  const Lanes<2> M_9_11_lanes = detail::make_pack<Real>(c11, c18) * M_2_11_p5_lanes -
      detail::make_pack<Real>(s11, s18) * M_2_2_p79_lanes;
  M[227] = M_9_11_lanes[0];
  M[273] = M_9_11_lanes[0];

  // link 19 (right_wrist2), mass matrix
  M[402] = M_9_11_lanes[1];
  M[448] = M_9_11_lanes[1];

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_5_10_lanes = detail::make_pack<Real>(c7, c14) * M_7_10_lanes +
      detail::make_pack<Real>(s7, s14) * M_2_10_p18_lanes + M_5_10_p6_lanes;
  M[130] = M_5_10_lanes[0];
  M[245] = M_5_10_lanes[0];

  // link 18 (right_wrist1), mass matrix
  M[137] = M_5_10_lanes[1];
  M[413] = M_5_10_lanes[1];

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_1_7_p19_lanes = M_1_1_p5 * M_1_7_p13_lanes + M_1_1_p8 * M_1_7_p12_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_1_11_p10_lanes = detail::make_pack<Real>(s10, s17) * M_1_11_p1_lanes +
      detail::make_pack<Real>(c10, c17) * M_2_2_p51_lanes;

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_2_10_p31_lanes = M_5_10_lanes + 0.072 * M_2_10_p25_lanes;
  const Lanes<2> M_1_10_p26_lanes = s5 * M_2_10_p19_lanes - c5 * M_1_10_p21_lanes;
  const Lanes<2> M_2_10_p32_lanes = c6 * M_2_10_p26_lanes + s6 * M_2_10_p27_lanes;

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_1_8_p21_lanes = M_1_1_p5 * M_1_8_p15_lanes + M_1_1_p8 * M_1_8_p14_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_1_11_p14_lanes = detail::make_pack<Real>(s9, s16) * M_1_11_p7_lanes +
      detail::make_pack<Real>(c9, c16) * M_2_11_p4_lanes;
  const Lanes<2> M_2_11_p12_lanes = M_9_11_lanes + 0.282 * M_1_11_p7_lanes;
  const Lanes<2> M_1_11_p15_lanes = detail::make_pack<Real>(s9, s16) * M_2_11_p4_lanes -
      detail::make_pack<Real>(c9, c16) * M_1_11_p7_lanes;
  const Lanes<2> M_8_11_lanes = detail::make_pack<Real>(s10, s17) * M_2_11_p8_lanes -
      detail::make_pack<Real>(c10, c17) * M_10_11_lanes;
  M[203] = M_8_11_lanes[0];
  M[272] = M_8_11_lanes[0];

  // link 19 (right_wrist2), mass matrix
  M[378] = M_8_11_lanes[1];
  M[447] = M_8_11_lanes[1];

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_1_10_p29_lanes = s4 * M_2_10_p25_lanes - c4 *
      (c5 * M_2_10_p19_lanes + s5 * M_1_10_p21_lanes);
  const Lanes<2> M_4_10_lanes = c6 * M_2_10_p27_lanes - s6 * M_2_10_p26_lanes - 0.072 *
      M_2_10_p19_lanes;
  M[106] = M_4_10_lanes[0];
  M[244] = M_4_10_lanes[0];

  // link 18 (right_wrist1), mass matrix
  M[113] = M_4_10_lanes[1];
  M[412] = M_4_10_lanes[1];

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_2_11_p13_lanes = detail::make_pack<Real>(c10, c17) * M_2_11_p8_lanes +
      detail::make_pack<Real>(s10, s17) * M_10_11_lanes + 0.282 * M_2_11_p4_lanes;
  const Lanes<2> M_1_11_p19_lanes = detail::make_pack<Real>(s8, s15) * M_1_11_p14_lanes -
      detail::make_pack<Real>(c8, c15) * M_1_11_p10_lanes;
  const Lanes<2> M_1_11_p20_lanes = detail::make_pack<Real>(s8, s15) * M_1_11_p10_lanes +
      detail::make_pack<Real>(c8, c15) * M_1_11_p14_lanes;

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_1_9_p28_lanes = M_1_1_p5 * M_1_9_p22_lanes + M_1_1_p8 * M_1_9_p21_lanes;

  // link 4 (chest1), composite inertia
  const Real M_2_2 = 1.9978863071791395 + M_4_4_p1 - 0.43599999999999994 * M_1_1_p7 + M_2_2_p377 *
      s4;
  M[50] = M_2_2;

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_1_10_p34_lanes = M_1_1_p5 * M_1_10_p29_lanes + M_1_1_p8 * M_1_10_p26_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_2_11_p18_lanes = detail::make_pack<Real>(s9, s16) * M_2_11_p13_lanes -
      detail::make_pack<Real>(c9, c16) * M_2_11_p12_lanes;

  // link 20 (right_hand), mass matrix
  M[300] = 0.0009386316083993107;
  M[475] = 0.0009386316083993107;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_7_11_lanes = detail::make_pack<Real>(c9, c16) * M_2_11_p13_lanes +
      detail::make_pack<Real>(s9, s16) * M_2_11_p12_lanes;
  M[179] = -M_7_11_lanes[0];
  M[271] = -M_7_11_lanes[0];

  // link 19 (right_wrist2), mass matrix
  M[354] = -M_7_11_lanes[1];
  M[446] = -M_7_11_lanes[1];

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_p4_lanes = detail::make_pack<Real>(s12, s19) * M_2_2_p17_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_1_11_p23_lanes = detail::make_pack<Real>(s7, s14) * M_1_11_p15_lanes +
      detail::make_pack<Real>(c7, c14) * M_1_11_p19_lanes;
  const Lanes<2> M_2_11_p23_lanes = detail::make_pack<Real>(c7, c14) * M_1_11_p15_lanes -
      detail::make_pack<Real>(s7, s14) * M_1_11_p19_lanes;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_10_12_lanes = M_2_2_p29_lanes - 0.0009386316083993107 *
      detail::make_pack<Real>(s12, s19);
  M[252] = M_10_12_lanes[0];
  M[298] = M_10_12_lanes[0];

  // link 20 (right_hand), mass matrix
  M[427] = M_10_12_lanes[1];
  M[473] = M_10_12_lanes[1];

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_2_11_p24_lanes = detail::make_pack<Real>(s8, s15) * M_2_11_p18_lanes -
      detail::make_pack<Real>(c8, c15) * M_8_11_lanes;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_p9_lanes = 0.0009386316083993107 * detail::make_pack<Real>(c12, c19) +
      detail::make_pack<Real>(s12, s19) * M_2_2_p21_lanes + 0.00444264243991307 *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> M_1_12_p3_lanes = detail::make_pack<Real>(c12, c19) * M_2_2_p17_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_6_11_lanes = detail::make_pack<Real>(s8, s15) * M_8_11_lanes +
      detail::make_pack<Real>(c8, c15) * M_2_11_p18_lanes;
  M[155] = -M_6_11_lanes[0];
  M[270] = -M_6_11_lanes[0];

  // link 19 (right_wrist2), mass matrix
  M[330] = -M_6_11_lanes[1];
  M[445] = -M_6_11_lanes[1];

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_p10_lanes = M_11_12_lanes - 0.269 * M_2_12_p4_lanes;
  const Lanes<2> M_2_12_p11_lanes = detail::make_pack<Real>(s11, s18) * M_2_12_p4_lanes +
      detail::make_pack<Real>(c11, c18) * M_2_2_p9_lanes;
  const Lanes<2> M_1_12_p4_lanes = detail::make_pack<Real>(c11, c18) * M_2_12_p4_lanes -
      detail::make_pack<Real>(s11, s18) * M_2_2_p9_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_1_11_p25_lanes = c6 * M_1_11_p23_lanes + s6 * M_1_11_p20_lanes;
  const Lanes<2> M_2_11_p29_lanes = 0.226 * M_2_11_p23_lanes - M_6_11_lanes;
  const Lanes<2> M_2_11_p31_lanes = s6 * M_1_11_p23_lanes - c6 * M_1_11_p20_lanes;
  const Lanes<2> M_5_11_p5_lanes = detail::make_pack<Real>(c7, c14) * M_7_11_lanes +
      detail::make_pack<Real>(s7, s14) * M_2_11_p24_lanes;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_p16_lanes = detail::make_pack<Real>(c11, c18) * M_2_12_p9_lanes -
      detail::make_pack<Real>(s11, s18) * M_2_12_p10_lanes;
  const Lanes<2> M_9_12_lanes = detail::make_pack<Real>(s11, s18) * M_2_12_p9_lanes +
      detail::make_pack<Real>(c11, c18) * M_2_12_p10_lanes;
  M[228] = M_9_12_lanes[0];
  M[297] = M_9_12_lanes[0];

  // link 20 (right_hand), mass matrix
  M[403] = M_9_12_lanes[1];
  M[472] = M_9_12_lanes[1];

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_1_12_p11_lanes = detail::make_pack<Real>(c10, c17) * M_1_12_p4_lanes +
      detail::make_pack<Real>(s10, s17) * M_1_12_p3_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_2_11_p33_lanes = detail::make_pack<Real>(0.18, (-0.18)) * M_2_11_p23_lanes -
      (detail::make_pack<Real>(s7, s14) * M_7_11_lanes - detail::make_pack<Real>(c7, c14) *
      M_2_11_p24_lanes);

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_1_12_p12_lanes = detail::make_pack<Real>(c10, c17) * M_1_12_p3_lanes -
      detail::make_pack<Real>(s10, s17) * M_1_12_p4_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_5_11_lanes = 0.226 * M_1_11_p20_lanes - detail::make_pack<Real>(0.18, (-0.18)) *
      M_1_11_p23_lanes - M_5_11_p5_lanes;
  M[131] = M_5_11_lanes[0];
  M[269] = M_5_11_lanes[0];

  // link 19 (right_wrist2), mass matrix
  M[138] = M_5_11_lanes[1];
  M[437] = M_5_11_lanes[1];

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_1_11_p32_lanes = s5 * M_2_11_p23_lanes + c5 * M_1_11_p25_lanes;
  const Lanes<2> M_2_11_p36_lanes = M_5_11_lanes - 0.072 * M_2_11_p31_lanes;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_8_12_lanes = detail::make_pack<Real>(c10, c17) * M_10_12_lanes -
      detail::make_pack<Real>(s10, s17) * M_2_12_p16_lanes;
  M[204] = M_8_12_lanes[0];
  M[296] = M_8_12_lanes[0];

  // link 20 (right_hand), mass matrix
  M[379] = M_8_12_lanes[1];
  M[471] = M_8_12_lanes[1];

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_1_12_p17_lanes = detail::make_pack<Real>(s9, s16) * M_1_12_p11_lanes +
      detail::make_pack<Real>(c9, c16) * M_2_12_p11_lanes;
  const Lanes<2> M_2_12_p20_lanes = M_9_12_lanes - 0.282 * M_1_12_p11_lanes;
  const Lanes<2> M_1_12_p18_lanes = detail::make_pack<Real>(c9, c16) * M_1_12_p11_lanes -
      detail::make_pack<Real>(s9, s16) * M_2_12_p11_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_2_11_p37_lanes = c6 * M_2_11_p33_lanes - s6 * M_2_11_p29_lanes;
  const Lanes<2> M_1_11_p36_lanes = c4 * (s5 * M_1_11_p25_lanes - c5 * M_2_11_p23_lanes) + s4 *
      M_2_11_p31_lanes;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_p21_lanes = detail::make_pack<Real>(c10, c17) * M_2_12_p16_lanes +
      detail::make_pack<Real>(s10, s17) * M_10_12_lanes + 0.282 * M_2_12_p11_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_4_11_lanes = s6 * M_2_11_p33_lanes + c6 * M_2_11_p29_lanes + 0.072 *
      M_2_11_p23_lanes;
  M[107] = M_4_11_lanes[0];
  M[268] = M_4_11_lanes[0];

  // link 19 (right_wrist2), mass matrix
  M[114] = M_4_11_lanes[1];
  M[436] = M_4_11_lanes[1];

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_1_12_p22_lanes = detail::make_pack<Real>(c8, c15) * M_1_12_p12_lanes +
      detail::make_pack<Real>(s8, s15) * M_1_12_p17_lanes;
  const Lanes<2> M_1_12_p23_lanes = detail::make_pack<Real>(c8, c15) * M_1_12_p17_lanes -
      detail::make_pack<Real>(s8, s15) * M_1_12_p12_lanes;

  // link 21 (neck), mass matrix
  const Real M_1_20_p1 = s6 * M_2_2_p284;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_p26_lanes = detail::make_pack<Real>(s9, s16) * M_2_12_p21_lanes +
      detail::make_pack<Real>(c9, c16) * M_2_12_p20_lanes;
  const Lanes<2> M_7_12_lanes = detail::make_pack<Real>(c9, c16) * M_2_12_p21_lanes -
      detail::make_pack<Real>(s9, s16) * M_2_12_p20_lanes;
  M[180] = M_7_12_lanes[0];
  M[295] = M_7_12_lanes[0];

  // link 20 (right_hand), mass matrix
  M[355] = M_7_12_lanes[1];
  M[470] = M_7_12_lanes[1];

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_1_11_p40_lanes = M_1_1_p5 * M_1_11_p36_lanes + M_1_1_p8 * M_1_11_p32_lanes;

  // link 21 (neck), mass matrix
  const Real M_2_20_p1 = c6 * M_2_2_p284;

  // link 22 (head), composite inertia
  const Real M_20_20 = 0.006216750000000001 + M_2_2_p210;
  M[500] = M_20_20;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_1_12_p26_lanes = detail::make_pack<Real>(c7, c14) * M_1_12_p22_lanes -
      detail::make_pack<Real>(s7, s14) * M_1_12_p18_lanes;
  const Lanes<2> M_2_12_p31_lanes = detail::make_pack<Real>(c7, c14) * M_1_12_p18_lanes +
      detail::make_pack<Real>(s7, s14) * M_1_12_p22_lanes;

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_2_6_p41_lanes = c4 * M_4_6_lanes - s4 *
      (s5 * M_2_6_p35_lanes - c5 * M_2_6_p33_lanes);

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_2_7_p23_lanes = c4 * M_4_7_lanes - s4 *
      (s5 * M_2_7_p15_lanes - c5 * M_2_7_p16_lanes);

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_p32_lanes = detail::make_pack<Real>(c8, c15) * M_8_12_lanes +
      detail::make_pack<Real>(s8, s15) * M_2_12_p26_lanes;
  const Lanes<2> M_6_12_lanes = detail::make_pack<Real>(c8, c15) * M_2_12_p26_lanes -
      detail::make_pack<Real>(s8, s15) * M_8_12_lanes;
  M[156] = M_6_12_lanes[0];
  M[294] = M_6_12_lanes[0];

  // link 20 (right_hand), mass matrix
  M[331] = M_6_12_lanes[1];
  M[469] = M_6_12_lanes[1];

  // link 22 (head), mass matrix
  const Real M_1_21_p1 = s21 * M_2_2_p185;
  const Real M_1_21_p2 = c21 * M_2_2_p185;

  // link 21 (neck), mass matrix
  const Real M_2_20_p2 = s6 * M_2_2_p264 - c6 * M_20_20;
  const Real M_2_20_p3 = 0.072 * M_2_20_p1 + M_5_20;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_1_12_p30_lanes = c6 * M_1_12_p26_lanes + s6 * M_1_12_p23_lanes;
  const Lanes<2> M_2_12_p37_lanes = M_6_12_lanes + 0.226 * M_2_12_p31_lanes;
  const Lanes<2> M_2_12_p38_lanes = c6 * M_1_12_p23_lanes - s6 * M_1_12_p26_lanes;
  const Lanes<2> M_5_12_p5_lanes = detail::make_pack<Real>(0.18, (-0.18)) * M_1_12_p26_lanes -
      0.226 * M_1_12_p23_lanes;

  // link 22 (head), mass matrix
  const Real M_1_21_p3 = c6 * M_5_20_p3 - s6 * M_1_21_p1;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_p42_lanes = detail::make_pack<Real>(0.18, (-0.18)) * M_2_12_p31_lanes -
      (detail::make_pack<Real>(c7, c14) * M_2_12_p32_lanes - detail::make_pack<Real>(s7, s14) *
      M_7_12_lanes);

  // link 22 (head), mass matrix
  const Real M_2_21_p1 = s6 * M_5_20_p3 + c6 * M_1_21_p1;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_5_12_lanes = detail::make_pack<Real>(c7, c14) * M_7_12_lanes +
      detail::make_pack<Real>(s7, s14) * M_2_12_p32_lanes + M_5_12_p5_lanes;
  M[132] = M_5_12_lanes[0];
  M[293] = M_5_12_lanes[0];

  // link 20 (right_hand), mass matrix
  M[139] = M_5_12_lanes[1];
  M[461] = M_5_12_lanes[1];

  // link 21 (neck), mass matrix
  const Real M_1_20_p2 = s5 * M_2_2_p272 + c5 * M_1_20_p1;
  const Real M_1_20_p3 = s4 * M_2_20_p1 + c4 * (c5 * M_2_2_p272 - s5 * M_1_20_p1);

  // link 22 (head), mass matrix
  const Real M_2_21_p2 = M_21_21 + 0.394 * M_2_2_p185;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_p44_lanes = M_5_12_lanes - 0.072 * M_2_12_p38_lanes;
  const Lanes<2> M_1_12_p36_lanes = c5 * M_1_12_p30_lanes - s5 * M_2_12_p31_lanes;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_1_22_p1_lanes = c22 * M_5_20_p1_lanes;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_p45_lanes = c6 * M_2_12_p42_lanes - s6 * M_2_12_p37_lanes;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_1_22_p4_lanes = s22 * M_5_20_p1_lanes;

  // link 22 (head), mass matrix
  const Real M_1_21_p4 = s5 * M_1_21_p2 + c5 * M_1_21_p3;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_1_12_p38_lanes = c4 * (c5 * M_2_12_p31_lanes + s5 * M_1_12_p30_lanes) - s4 *
      M_2_12_p38_lanes;

  // link 22 (head), mass matrix
  const Real M_2_21_p3 = M_2_2_p229 - c21 * M_2_21_p2;
  const Real M_5_21 = c21 * M_2_2_p219 + s21 * M_2_21_p2;
  M[141] = -M_5_21;
  M[509] = -M_5_21;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_1_22_p8_lanes = s21 * M_1_22_p1_lanes - c21 * M_2_2_p124_lanes;
  const Lanes<2> M_1_22_p9_lanes = c21 * M_1_22_p1_lanes + s21 * M_2_2_p124_lanes;

  // link 22 (head), mass matrix
  M[550] = 9.25e-06;
  M[575] = 9.25e-06;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_2_22_p2_lanes = 9.25e-06 + M_2_2_p73_lanes;

  // link 22 (head), mass matrix
  const Real M_2_21_p4 = M_5_21 + 0.072 * M_2_21_p1;
  const Real M_1_21_p5 = c4 * (s5 * M_1_21_p3 - c5 * M_1_21_p2) + s4 * M_2_21_p1;
  const Real M_2_21_p5 = s6 * M_2_21_p3 - c6 * M_20_21;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_2_22_p8_lanes = M_21_22_lanes + 0.394 * M_1_22_p1_lanes;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_4_12_lanes = s6 * M_2_12_p42_lanes + c6 * M_2_12_p37_lanes + 0.072 *
      M_2_12_p31_lanes;
  M[108] = M_4_12_lanes[0];
  M[292] = M_4_12_lanes[0];

  // link 20 (right_hand), mass matrix
  M[115] = M_4_12_lanes[1];
  M[460] = M_4_12_lanes[1];

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_1_22_p13_lanes = s6 * M_1_22_p8_lanes - c6 * M_1_22_p4_lanes;
  const Lanes<2> M_2_22_p10_lanes = s6 * M_1_22_p4_lanes + c6 * M_1_22_p8_lanes;
  const Lanes<2> M_20_22_lanes = s22 * M_2_2_p75_lanes + c22 * M_2_22_p2_lanes;
  M[502] = M_20_22_lanes[0];
  M[548] = M_20_22_lanes[0];

  // link 24 (right_eye), mass matrix
  M[503] = M_20_22_lanes[1];
  M[572] = M_20_22_lanes[1];

  // link 21 (neck), mass matrix
  const Real M_4_20 = s6 * M_20_20 + c6 * M_2_2_p264 + 0.072 * M_2_2_p272;
  M[116] = -M_4_20;
  M[484] = -M_4_20;

  // link 22 (head), mass matrix
  const Real M_4_21 = s6 * M_20_21 + c6 * M_2_21_p3 - 0.072 * M_1_21_p2;
  M[117] = -M_4_21;
  M[508] = -M_4_21;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_2_22_p12_lanes = c22 * M_2_2_p75_lanes - s22 * M_2_22_p2_lanes +
      9.850000000000001e-05 * detail::make_pack<Real>(c23, c24);

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_1_12_p43_lanes = M_1_1_p5 * M_1_12_p38_lanes + M_1_1_p8 * M_1_12_p36_lanes;

  // link 21 (neck), mass matrix
  const Real M_1_20_p4 = M_1_1_p8 * M_1_20_p2 - M_1_1_p5 * M_1_20_p3;

  // link 22 (head), mass matrix
  const Real M_1_21_p6 = M_1_1_p8 * M_1_21_p4 + M_1_1_p5 * M_1_21_p5;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_1_22_p18_lanes = s5 * M_1_22_p9_lanes - c5 * M_1_22_p13_lanes;
  const Lanes<2> M_2_22_p16_lanes = s21 * M_2_22_p12_lanes + c21 * M_2_22_p8_lanes;
  const Lanes<2> M_5_22_lanes = s21 * M_2_22_p8_lanes - c21 * M_2_22_p12_lanes;
  M[142] = M_5_22_lanes[0];
  M[533] = M_5_22_lanes[0];

  // link 24 (right_eye), mass matrix
  M[143] = M_5_22_lanes[1];
  M[557] = M_5_22_lanes[1];

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_2_8_p30_lanes = c4 * M_4_8_lanes - s4 *
      (s5 * M_2_8_p22_lanes - c5 * M_2_8_p23_lanes);

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_2_9_p34_lanes = s4 * (c5 * M_2_9_p27_lanes + s5 * M_2_9_p26_lanes) + c4 *
      M_4_9_lanes;

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_2_10_p39_lanes = s4 * (c5 * M_2_10_p31_lanes + s5 * M_2_10_p32_lanes) + c4 *
      M_4_10_lanes;

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_2_11_p44_lanes = c4 * M_4_11_lanes - s4 *
      (s5 * M_2_11_p37_lanes - c5 * M_2_11_p36_lanes);

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_2_22_p18_lanes = M_5_22_lanes + 0.072 * M_2_22_p10_lanes;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_p52_lanes = c4 * M_4_12_lanes - s4 *
      (s5 * M_2_12_p45_lanes - c5 * M_2_12_p44_lanes);

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_1_22_p22_lanes = s4 * M_2_22_p10_lanes - c4 *
      (c5 * M_1_22_p9_lanes + s5 * M_1_22_p13_lanes);

  // link 3 (hip), composite inertia
  const Real M_1_1 = 9.885744550888212 + (M_2_2 - 2.0 * M_1_1_p12);
  M[25] = M_1_1;

  // link 5 (chest2), composite inertia
  const Real M_2_3 = (0.005880002159562879 - (c5 * M_2_2_p375 - M_2_2_p371)) * s4 -
      (c4 * M_3_4 + 0.21799999999999997 * M_1_3_p2);
  M[51] = M_2_3;
  M[74] = M_2_3;

  // link 5 (chest2), mass matrix
  const Real M_2_4 = c4 * M_4_4 - s4 * M_2_2_p374 - 0.21799999999999997 * M_1_4_p1;
  M[52] = M_2_4;
  M[98] = M_2_4;

  // link 6 (chest3), mass matrix
  const Real M_2_5 = c4 * M_4_5 - s4 * (s5 * M_2_2_p368 - c5 * M_2_5_p1) + 0.21799999999999997 *
      M_1_5_p2;
  M[53] = M_2_5;
  M[122] = M_2_5;

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_2_6_lanes = M_2_6_p41_lanes - 0.21799999999999997 * M_1_6_p10_lanes;
  M[54] = M_2_6_lanes[0];
  M[146] = M_2_6_lanes[0];

  // link 14 (right_shoulder1), mass matrix
  M[61] = M_2_6_lanes[1];
  M[314] = M_2_6_lanes[1];

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_1_6_p19_lanes = M_1_1_p4 * M_1_6_p15_lanes - M_1_1_p3 *
      (M_1_1_p8 * M_1_6_p10_lanes + M_1_1_p5 * M_1_6_p8_lanes);

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_2_7_lanes = M_2_7_p23_lanes + 0.21799999999999997 * M_1_7_p13_lanes;
  M[55] = M_2_7_lanes[0];
  M[170] = M_2_7_lanes[0];

  // link 15 (right_shoulder2), mass matrix
  M[62] = M_2_7_lanes[1];
  M[338] = M_2_7_lanes[1];

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_2_22_p20_lanes = s6 * M_2_22_p16_lanes - c6 * M_20_22_lanes;

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_1_7_p22_lanes = M_1_1_p3 * (M_1_1_p8 * M_1_7_p13_lanes - M_1_1_p5 *
      M_1_7_p12_lanes) + M_1_1_p4 * M_1_7_p19_lanes;

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_2_8_lanes = M_2_8_p30_lanes - 0.21799999999999997 * M_1_8_p15_lanes;
  M[56] = M_2_8_lanes[0];
  M[194] = M_2_8_lanes[0];

  // link 16 (right_upperarm), mass matrix
  M[63] = M_2_8_lanes[1];
  M[362] = M_2_8_lanes[1];

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_1_8_p24_lanes = M_1_1_p3 * (M_1_1_p5 * M_1_8_p14_lanes - M_1_1_p8 *
      M_1_8_p15_lanes) - M_1_1_p4 * M_1_8_p21_lanes;

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_2_9_lanes = M_2_9_p34_lanes + 0.21799999999999997 * M_1_9_p22_lanes;
  M[57] = M_2_9_lanes[0];
  M[218] = M_2_9_lanes[0];

  // link 17 (right_lowerarm), mass matrix
  M[64] = M_2_9_lanes[1];
  M[386] = M_2_9_lanes[1];

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_1_9_p31_lanes = M_1_1_p3 * (M_1_1_p8 * M_1_9_p22_lanes - M_1_1_p5 *
      M_1_9_p21_lanes) + M_1_1_p4 * M_1_9_p28_lanes;

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_2_10_lanes = M_2_10_p39_lanes + 0.21799999999999997 * M_1_10_p29_lanes;
  M[58] = M_2_10_lanes[0];
  M[242] = M_2_10_lanes[0];

  // link 18 (right_wrist1), mass matrix
  M[65] = M_2_10_lanes[1];
  M[410] = M_2_10_lanes[1];

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_1_10_p37_lanes = M_1_1_p3 * (M_1_1_p8 * M_1_10_p29_lanes - M_1_1_p5 *
      M_1_10_p26_lanes) + M_1_1_p4 * M_1_10_p34_lanes;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_4_22_lanes = s6 * M_20_22_lanes + c6 * M_2_22_p16_lanes + 0.072 *
      M_1_22_p9_lanes;
  M[118] = -M_4_22_lanes[0];
  M[532] = -M_4_22_lanes[0];

  // link 24 (right_eye), mass matrix
  M[119] = -M_4_22_lanes[1];
  M[556] = -M_4_22_lanes[1];

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_2_11_lanes = M_2_11_p44_lanes - 0.21799999999999997 * M_1_11_p36_lanes;
  M[59] = M_2_11_lanes[0];
  M[266] = M_2_11_lanes[0];

  // link 19 (right_wrist2), mass matrix
  M[66] = M_2_11_lanes[1];
  M[434] = M_2_11_lanes[1];

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_1_11_p43_lanes = M_1_1_p3 * (M_1_1_p5 * M_1_11_p32_lanes - M_1_1_p8 *
      M_1_11_p36_lanes) - M_1_1_p4 * M_1_11_p40_lanes;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_1_22_p26_lanes = M_1_1_p5 * M_1_22_p22_lanes + M_1_1_p8 * M_1_22_p18_lanes;

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_2_12_lanes = M_2_12_p52_lanes + 0.21799999999999997 * M_1_12_p38_lanes;
  M[60] = M_2_12_lanes[0];
  M[290] = M_2_12_lanes[0];

  // link 20 (right_hand), mass matrix
  M[67] = M_2_12_lanes[1];
  M[458] = M_2_12_lanes[1];

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_1_12_p46_lanes = M_1_1_p3 * (M_1_1_p8 * M_1_12_p38_lanes - M_1_1_p5 *
      M_1_12_p36_lanes) + M_1_1_p4 * M_1_12_p43_lanes;

  // link 21 (neck), mass matrix
  const Real M_2_20 = 0.21799999999999997 * M_1_20_p3 +
      (s4 * (s5 * M_2_20_p2 + c5 * M_2_20_p3) + c4 * M_4_20);
  M[68] = -M_2_20;
  M[482] = -M_2_20;

  // link 22 (head), mass matrix
  const Real M_2_21 = s4 * (c5 * M_2_21_p4 + s5 * M_2_21_p5) + c4 * M_4_21 + 0.21799999999999997 *
      M_1_21_p5;
  M[69] = -M_2_21;
  M[506] = -M_2_21;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_1_22_p29_lanes = M_1_1_p3 * (M_1_1_p8 * M_1_22_p22_lanes - M_1_1_p5 *
      M_1_22_p18_lanes) + M_1_1_p4 * M_1_22_p26_lanes;
  const Lanes<2> M_2_22_p26_lanes = s4 * (s5 * M_2_22_p20_lanes - c5 * M_2_22_p18_lanes) + c4 *
      M_4_22_lanes;

  // link 3 (hip), mass matrix
  const Real M_1_2 = M_2_2 - M_1_1_p12;
  M[26] = M_1_2;
  M[49] = M_1_2;

  // link 4 (chest1), mass matrix
  const Real M_1_3 = M_2_3 - (M_1_1_p3 * (M_1_1_p8 * M_1_3_p3) + M_1_1_p4 * M_1_3_p4);
  M[27] = M_1_3;
  M[73] = M_1_3;

  // link 5 (chest2), mass matrix
  const Real M_1_4 = M_2_4 + (M_1_1_p4 * M_1_4_p2 - M_1_1_p3 *
      (M_1_1_p8 * M_1_4_p1 + M_1_1_p5 * M_1_1_p6));
  M[28] = M_1_4;
  M[97] = M_1_4;

  // link 6 (chest3), mass matrix
  const Real M_1_5 = M_2_5 + (M_1_1_p3 * (M_1_1_p8 * M_1_5_p2 - M_1_1_p5 * M_1_5_p1) + M_1_1_p4 *
      M_1_5_p3);
  M[29] = M_1_5;
  M[121] = M_1_5;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_2_22_lanes = 0.21799999999999997 * M_1_22_p22_lanes - M_2_22_p26_lanes;
  M[70] = M_2_22_lanes[0];
  M[530] = M_2_22_lanes[0];

  // link 24 (right_eye), mass matrix
  M[71] = M_2_22_lanes[1];
  M[554] = M_2_22_lanes[1];

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_1_6_lanes = M_2_6_lanes + M_1_6_p19_lanes;
  M[30] = M_1_6_lanes[0];
  M[145] = M_1_6_lanes[0];

  // link 14 (right_shoulder1), mass matrix
  M[37] = M_1_6_lanes[1];
  M[313] = M_1_6_lanes[1];

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_1_7_lanes = M_2_7_lanes + M_1_7_p22_lanes;
  M[31] = M_1_7_lanes[0];
  M[169] = M_1_7_lanes[0];

  // link 15 (right_shoulder2), mass matrix
  M[38] = M_1_7_lanes[1];
  M[337] = M_1_7_lanes[1];

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_1_8_lanes = M_2_8_lanes + M_1_8_p24_lanes;
  M[32] = M_1_8_lanes[0];
  M[193] = M_1_8_lanes[0];

  // link 16 (right_upperarm), mass matrix
  M[39] = M_1_8_lanes[1];
  M[361] = M_1_8_lanes[1];

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_1_9_lanes = M_2_9_lanes + M_1_9_p31_lanes;
  M[33] = M_1_9_lanes[0];
  M[217] = M_1_9_lanes[0];

  // link 17 (right_lowerarm), mass matrix
  M[40] = M_1_9_lanes[1];
  M[385] = M_1_9_lanes[1];

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_1_10_lanes = M_2_10_lanes + M_1_10_p37_lanes;
  M[34] = M_1_10_lanes[0];
  M[241] = M_1_10_lanes[0];

  // link 18 (right_wrist1), mass matrix
  M[41] = M_1_10_lanes[1];
  M[409] = M_1_10_lanes[1];

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_1_11_lanes = M_2_11_lanes + M_1_11_p43_lanes;
  M[35] = M_1_11_lanes[0];
  M[265] = M_1_11_lanes[0];

  // link 19 (right_wrist2), mass matrix
  M[42] = M_1_11_lanes[1];
  M[433] = M_1_11_lanes[1];

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_1_12_lanes = M_2_12_lanes + M_1_12_p46_lanes;
  M[36] = M_1_12_lanes[0];
  M[289] = M_1_12_lanes[0];

  // link 20 (right_hand), mass matrix
  M[43] = M_1_12_lanes[1];
  M[457] = M_1_12_lanes[1];

  // link 21 (neck), mass matrix
  const Real M_1_20 = M_1_1_p4 * M_1_20_p4 - M_1_1_p3 *
      (M_1_1_p8 * M_1_20_p3 + M_1_1_p5 * M_1_20_p2) - M_2_20;
  M[44] = M_1_20;
  M[481] = M_1_20;

  // link 22 (head), mass matrix
  const Real M_1_21 = M_1_1_p4 * M_1_21_p6 + M_1_1_p3 *
      (M_1_1_p8 * M_1_21_p5 - M_1_1_p5 * M_1_21_p4) + M_2_21;
  M[45] = -M_1_21;
  M[505] = -M_1_21;

  // link 2 (thigh), composite inertia
  M[0] = 13.049859506913753 + (M_1_1 - 0.868 * M_0_0_p1);

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_1_22_lanes = M_2_22_lanes + M_1_22_p29_lanes;
  M[46] = M_1_22_lanes[0];
  M[529] = M_1_22_lanes[0];

  // link 24 (right_eye), mass matrix
  M[47] = M_1_22_lanes[1];
  M[553] = M_1_22_lanes[1];

  // link 2 (thigh), mass matrix
  const Real M_0_1 = M_1_1 - 0.434 * M_0_0_p1;
  M[1] = M_0_1;
  M[24] = M_0_1;

  // link 3 (hip), mass matrix
  const Real M_0_2 = M_1_2 - 0.434 * M_1_1_p11;
  M[2] = M_0_2;
  M[48] = M_0_2;

  // link 4 (chest1), mass matrix
  const Real M_0_3 = M_1_3 - 0.434 * M_1_3_p4;
  M[3] = M_0_3;
  M[72] = M_0_3;

  // link 5 (chest2), mass matrix
  const Real M_0_4 = M_1_4 + 0.434 * M_1_4_p2;
  M[4] = M_0_4;
  M[96] = M_0_4;

  // link 6 (chest3), mass matrix
  const Real M_0_5 = M_1_5 + 0.434 * M_1_5_p3;
  M[5] = M_0_5;
  M[120] = M_0_5;

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_0_6_lanes = M_1_6_lanes + 0.434 * M_1_6_p15_lanes;
  M[6] = M_0_6_lanes[0];
  M[144] = M_0_6_lanes[0];

  // link 14 (right_shoulder1), mass matrix
  M[13] = M_0_6_lanes[1];
  M[312] = M_0_6_lanes[1];

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_0_7_lanes = M_1_7_lanes + 0.434 * M_1_7_p19_lanes;
  M[7] = M_0_7_lanes[0];
  M[168] = M_0_7_lanes[0];

  // link 15 (right_shoulder2), mass matrix
  M[14] = M_0_7_lanes[1];
  M[336] = M_0_7_lanes[1];

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_0_8_lanes = M_1_8_lanes - 0.434 * M_1_8_p21_lanes;
  M[8] = M_0_8_lanes[0];
  M[192] = M_0_8_lanes[0];

  // link 16 (right_upperarm), mass matrix
  M[15] = M_0_8_lanes[1];
  M[360] = M_0_8_lanes[1];

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_0_9_lanes = M_1_9_lanes + 0.434 * M_1_9_p28_lanes;
  M[9] = M_0_9_lanes[0];
  M[216] = M_0_9_lanes[0];

  // link 17 (right_lowerarm), mass matrix
  M[16] = M_0_9_lanes[1];
  M[384] = M_0_9_lanes[1];

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_0_10_lanes = M_1_10_lanes + 0.434 * M_1_10_p34_lanes;
  M[10] = M_0_10_lanes[0];
  M[240] = M_0_10_lanes[0];

  // link 18 (right_wrist1), mass matrix
  M[17] = M_0_10_lanes[1];
  M[408] = M_0_10_lanes[1];

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_0_11_lanes = M_1_11_lanes - 0.434 * M_1_11_p40_lanes;
  M[11] = M_0_11_lanes[0];
  M[264] = M_0_11_lanes[0];

  // link 19 (right_wrist2), mass matrix
  M[18] = M_0_11_lanes[1];
  M[432] = M_0_11_lanes[1];

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_0_12_lanes = M_1_12_lanes + 0.434 * M_1_12_p43_lanes;
  M[12] = M_0_12_lanes[0];
  M[288] = M_0_12_lanes[0];

  // link 20 (right_hand), mass matrix
  M[19] = M_0_12_lanes[1];
  M[456] = M_0_12_lanes[1];

  // link 21 (neck), mass matrix
  const Real M_0_20 = M_1_20 + 0.434 * M_1_20_p4;
  M[20] = M_0_20;
  M[480] = M_0_20;

  // link 22 (head), mass matrix
  const Real M_0_21 = M_1_21 + 0.434 * M_1_21_p6;
  M[21] = -M_0_21;
  M[504] = -M_0_21;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_0_22_lanes = M_1_22_lanes + 0.434 * M_1_22_p26_lanes;
  M[22] = M_0_22_lanes[0];
  M[528] = M_0_22_lanes[0];

  // link 24 (right_eye), mass matrix
  M[23] = M_0_22_lanes[1];
  M[552] = M_0_22_lanes[1];

  // link 5 (chest2), composite inertia
  M[75] = 0.060169103246295166 + (M_2_2_p372 + M_2_2_p376);

  // link 6 (chest3), mass matrix
  const Real M_3_5 = s5 * M_2_5_p1 + c5 * M_2_2_p368;
  M[77] = -M_3_5;
  M[123] = -M_3_5;

  // link 7 (left_shoulder1), mass matrix
  const Lanes<2> M_3_6_lanes = s5 * M_2_6_p33_lanes + c5 * M_2_6_p35_lanes;
  M[78] = -M_3_6_lanes[0];
  M[147] = -M_3_6_lanes[0];

  // link 14 (right_shoulder1), mass matrix
  M[85] = -M_3_6_lanes[1];
  M[315] = -M_3_6_lanes[1];

  // link 8 (left_shoulder2), mass matrix
  const Lanes<2> M_3_7_lanes = s5 * M_2_7_p16_lanes + c5 * M_2_7_p15_lanes;
  M[79] = -M_3_7_lanes[0];
  M[171] = -M_3_7_lanes[0];

  // link 15 (right_shoulder2), mass matrix
  M[86] = -M_3_7_lanes[1];
  M[339] = -M_3_7_lanes[1];

  // link 9 (left_upperarm), mass matrix
  const Lanes<2> M_3_8_lanes = s5 * M_2_8_p23_lanes + c5 * M_2_8_p22_lanes;
  M[80] = -M_3_8_lanes[0];
  M[195] = -M_3_8_lanes[0];

  // link 16 (right_upperarm), mass matrix
  M[87] = -M_3_8_lanes[1];
  M[363] = -M_3_8_lanes[1];

  // link 10 (left_lowerarm), mass matrix
  const Lanes<2> M_3_9_lanes = c5 * M_2_9_p26_lanes - s5 * M_2_9_p27_lanes;
  M[81] = M_3_9_lanes[0];
  M[219] = M_3_9_lanes[0];

  // link 17 (right_lowerarm), mass matrix
  M[88] = M_3_9_lanes[1];
  M[387] = M_3_9_lanes[1];

  // link 11 (left_wrist1), mass matrix
  const Lanes<2> M_3_10_lanes = c5 * M_2_10_p32_lanes - s5 * M_2_10_p31_lanes;
  M[82] = M_3_10_lanes[0];
  M[243] = M_3_10_lanes[0];

  // link 18 (right_wrist1), mass matrix
  M[89] = M_3_10_lanes[1];
  M[411] = M_3_10_lanes[1];

  // link 12 (left_wrist2), mass matrix
  const Lanes<2> M_3_11_lanes = s5 * M_2_11_p36_lanes + c5 * M_2_11_p37_lanes;
  M[83] = -M_3_11_lanes[0];
  M[267] = -M_3_11_lanes[0];

  // link 19 (right_wrist2), mass matrix
  M[90] = -M_3_11_lanes[1];
  M[435] = -M_3_11_lanes[1];

  // link 13 (left_hand), mass matrix
  const Lanes<2> M_3_12_lanes = s5 * M_2_12_p44_lanes + c5 * M_2_12_p45_lanes;
  M[84] = -M_3_12_lanes[0];
  M[291] = -M_3_12_lanes[0];

  // link 20 (right_hand), mass matrix
  M[91] = -M_3_12_lanes[1];
  M[459] = -M_3_12_lanes[1];

  // link 21 (neck), mass matrix
  const Real M_3_20 = c5 * M_2_20_p2 - s5 * M_2_20_p3;
  M[92] = -M_3_20;
  M[483] = -M_3_20;

  // link 22 (head), mass matrix
  const Real M_3_21 = s5 * M_2_21_p4 - c5 * M_2_21_p5;
  M[93] = M_3_21;
  M[507] = M_3_21;

  // link 23 (left_eye), mass matrix
  const Lanes<2> M_3_22_lanes = s5 * M_2_22_p18_lanes + c5 * M_2_22_p20_lanes;
  M[94] = -M_3_22_lanes[0];
  M[531] = -M_3_22_lanes[0];

  // link 24 (right_eye), mass matrix
  M[95] = -M_3_22_lanes[1];
  M[555] = -M_3_22_lanes[1];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
