// SPDX-License-Identifier: 0BSD
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

  // constants
  const Real J_22_xy = 0.0074;
  const Real h_22_x = 0.072575;
  const Real minus_h_22_y = 0.43200000000000005;
  const Real J_21_xx = 0.005513625;
  const Real J_21_yy = 0.000703125;
  const Real link21_to_22_z = 0.394;
  const Real minus_J_21_xz = 0.0016155;
  const Real J_6_xz = 0.0187369177636143;
  const Real h_21_x = 0.0045000000000000005;
  const Real minus_h_6_x = 6.1665928899999995;
  const Real minus_link5_to_6_y = 0.072;
  const Real J_5_xy = 0.005678398088837119;
  const Real J_5_yy = 0.04675382692737882;
  const Real J_5_xx = 0.15637308509675518;
  const Real J_5_zz = 0.203126912024134;
  const Real minus_h_5_y = 2.2194301519999997;
  const Real h_5_x = 0.069699984375;
  const Real minus_h_3_x = 0.02999999505;
  const Real minus_h_4_x = 0.0300000063;
  const Real minus_h_3_y = 8.419374554;
  const Real minus_link2_to_3_y = 0.422;
  const Real h_2_x = 0.031999971599999996;
  const Real minus_h_2_y = 24.5839218;
  const Real J_2_zz = 9.885744550888212;
  const Real minus_link1_to_2_y = 0.434;
  const Real J_1_zz = 13.049859506913753;
  const Real J_4_xz = 0.005880002159562879;
  const Real link4_to_5_z = 0.21799999999999997;
  const Real J_21_zz = 0.006216750000000001;
  const Real J_4_zz = 0.060169103246295166;
  const Real t1 = 0.17435661841416683 + q[19];
  const Real t2 = (-0.17435661841416683) + q[12];

  // sines and cosines
  const Real angles[23] = {q[3], q[23], q[22], q[21], q[20], q[18], t1, q[17], q[16], q[15], q[14],
      q[13], q[11], t2, q[10], q[9], q[8], q[7], q[6], q[5], q[4], q[1], q[2]};
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

  // links 13 (left_hand) and 20 (right_hand), composite inertia
  const Lanes<2> t7_lanes = 0.0165153994048813 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> t13_lanes = 0.0165153994048813 * detail::make_pack<Real>(s13, s20);
  const Lanes<2> t14_lanes = detail::make_pack<Real>((-2.0630162081277884e-05),
      2.0630162081277884e-05) * detail::make_pack<Real>(c13, c20) - 0.0007965395222188762 *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> t15_lanes = 0.00011422720754895356 * detail::make_pack<Real>(c13, c20) +
      detail::make_pack<Real>(2.4414671283021662e-05, (-2.4414671283021662e-05)) *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> t16_lanes = 0.0006000000000000001 + t7_lanes;
  const Lanes<2> t17_lanes = detail::make_pack<Real>(2.4414671283021662e-05,
      (-2.4414671283021662e-05)) * detail::make_pack<Real>(c13, c20) - 0.00011422720754895356 *
      detail::make_pack<Real>(s13, s20);
  M[276] = t17_lanes[0];
  M[299] = t17_lanes[0];
  M[451] = t17_lanes[1];
  M[474] = t17_lanes[1];

  // links 12 and 13, 19 and 20, composite inertia
  const Lanes<2> t18_lanes = detail::make_pack<Real>(0.001, (-0.001)) + t13_lanes;
  const Lanes<2> t19_lanes = detail::make_pack<Real>(s13, s20) * t14_lanes;
  const Lanes<2> t20_lanes = detail::make_pack<Real>(c12, c19) * t15_lanes;
  const Lanes<2> t30_lanes = detail::make_pack<Real>(7.915081040638941e-06,
      (-7.915081040638941e-06)) + detail::make_pack<Real>(c13, c20) * t14_lanes;
  const Lanes<2> t31_lanes = 0.0010744132275664366 + t19_lanes;
  M[275] = t31_lanes[0];
  M[450] = t31_lanes[1];
  const Lanes<2> t32_lanes = 0.0025100003499999995 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * t16_lanes;
  const Lanes<2> t33_lanes = detail::make_pack<Real>(s12, s19) * t16_lanes - 0.0025100003499999995 *
      detail::make_pack<Real>(c12, c19);

  // links 11 and 12, 18 and 19, 23 and 24, composite inertia
  const Lanes<2> t40_lanes = 1.25e-06 * detail::make_pack<Real>(s23, s24);
  const Lanes<2> t41_lanes = 0.538 * t32_lanes;
  const Lanes<2> t43_lanes = 6e-04 - t33_lanes;
  const Lanes<2> t44_lanes = 0.28049749700000004 + t32_lanes;
  const Lanes<2> t45_lanes = 2.375e-05 * detail::make_pack<Real>(c23, c24) +
      detail::make_pack<Real>(8.000000000000001e-06, (-8.000000000000001e-06)) *
      detail::make_pack<Real>(s23, s24);
  const Lanes<2> t46_lanes = 2.8750000000000004e-05 * detail::make_pack<Real>(c23, c24);

  // links 12 (left_wrist2) and 19 (right_wrist2), composite inertia
  const Lanes<2> t47_lanes = 2.0 * t20_lanes - detail::make_pack<Real>(s12, s19) *
      (0.0006839579030517505 + t19_lanes);
  const Lanes<2> t48_lanes = detail::make_pack<Real>(s12, s19) * t30_lanes -
      detail::make_pack<Real>(c12, c19) * t17_lanes;
  const Lanes<2> t49_lanes = detail::make_pack<Real>(s12, s19) * t17_lanes +
      detail::make_pack<Real>(c12, c19) * t30_lanes;
  M[251] = -t49_lanes[0];
  M[274] = -t49_lanes[0];
  M[426] = -t49_lanes[1];

  // links 12, 19, 23 and 24, composite inertia
  M[449] = -t49_lanes[1];
  const Lanes<2> t55_lanes = detail::make_pack<Real>(s23, s24) * t40_lanes;
  const Lanes<2> t56_lanes = detail::make_pack<Real>(s12, s19) * t47_lanes;
  const Lanes<2> t58_lanes = detail::make_pack<Real>((-6e-06), 6e-06) - t48_lanes;
  const Lanes<2> t60_lanes = 0.0001098 + (t31_lanes + t41_lanes);

  // links 11 and 12, 18 and 19, 23, composite inertia
  const Lanes<2> t61_lanes = detail::make_pack<Real>(c11, c18) * t43_lanes -
      detail::make_pack<Real>(s11, s18) * t18_lanes;
  const Lanes<2> t62_lanes = detail::make_pack<Real>(s11, s18) * t43_lanes +
      detail::make_pack<Real>(c11, c18) * t18_lanes;
  const Lanes<2> t64_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) +
      (0.00444264243991307 * detail::make_pack<Real>(s13, s20) - t49_lanes);
  const Real t65 = t55_lanes[1] + t55_lanes[0];
  const Lanes<2> t68_lanes = 0.0002662737053475603 - t19_lanes - t56_lanes;

  // links 10 and 11, 17 and 18, 23 and 24, composite inertia
  const Lanes<2> t69_lanes = 0.0014999985000000002 + t61_lanes;
  const Real t71 = J_22_xy + t46_lanes[1] + t46_lanes[0];
  const Lanes<2> t72_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) + t62_lanes;
  const Lanes<2> t73_lanes = 0.00025 * detail::make_pack<Real>(c23, c24);
  const Real t76 = 0.009457124999999999 + 2.0 * (t45_lanes[1] + t45_lanes[0]);

  // links 10 to 12, 17 to 19, composite inertia
  const Lanes<2> t77_lanes = 0.0010696316083993109 + t56_lanes + t41_lanes;
  const Lanes<2> t80_lanes = 0.00051019984685315 + t68_lanes;
  const Lanes<2> t85_lanes = 0.000144 - (t15_lanes - detail::make_pack<Real>(c12, c19) * t47_lanes +
      0.269 * t33_lanes);
  const Lanes<2> t87_lanes = detail::make_pack<Real>(s10, s17) * t69_lanes +
      detail::make_pack<Real>(c10, c17) * t44_lanes;
  const Lanes<2> t88_lanes = detail::make_pack<Real>(s10, s17) * t44_lanes -
      detail::make_pack<Real>(c10, c17) * t69_lanes;

  // links 23 (left_eye) and 24 (right_eye), composite inertia
  const Real t89 = 0.0545107 + t65 + (-1.6000000000000003e-05) * s24 + 1.6000000000000003e-05 * s23;
  const Real t93 = h_22_x + t73_lanes[1] + t73_lanes[0];
  const Lanes<2> t94_lanes = (detail::make_pack<Real>(8.000000000000001e-06,
      (-8.000000000000001e-06)) + t40_lanes) * detail::make_pack<Real>(c23, c24);
  const Lanes<2> t95_lanes = 2.8750000000000004e-05 * detail::make_pack<Real>(s23, s24);
  M[526] = -t95_lanes[0];
  M[549] = -t95_lanes[0];
  M[527] = -t95_lanes[1];
  M[573] = -t95_lanes[1];

  // links 9 to 11, 16 to 18, composite inertia
  const Lanes<2> t96_lanes = 0.564 * t87_lanes;
  const Lanes<2> t98_lanes = 0.0022500062 + t88_lanes;
  const Lanes<2> t99_lanes = 0.7139200499999999 + t87_lanes;
  const Lanes<2> t100_lanes = detail::make_pack<Real>(s11, s18) * (t77_lanes - t60_lanes) +
      detail::make_pack<Real>(c11, c18) * (2.0 * t58_lanes);
  const Lanes<2> t101_lanes = detail::make_pack<Real>(c11, c18) * t85_lanes -
      detail::make_pack<Real>(s11, s18) * t64_lanes;

  // links 11, 18, 23, composite inertia
  const Lanes<2> t102_lanes = detail::make_pack<Real>(s11, s18) * t85_lanes +
      detail::make_pack<Real>(c11, c18) * t64_lanes;
  M[226] = t102_lanes[0];
  M[249] = t102_lanes[0];
  M[401] = t102_lanes[1];
  M[424] = t102_lanes[1];
  const Real t105 = t95_lanes[1] + t95_lanes[0];
  const Real M_21_21 = 0.063951825 - t65 + 4.75e-05 * (c24 + c23);
  M[525] = M_21_21;
  const Lanes<2> t109_lanes = detail::make_pack<Real>(s11, s18) * t100_lanes;
  const Lanes<2> t110_lanes = 0.0001499998887063 + t101_lanes;
  const Lanes<2> t112_lanes = detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) -
      t102_lanes;

  // links 9, 16, 22 to 24, composite inertia
  const Real t113 = minus_h_22_y * c22 - s22 * t93;
  const Real t114 = t94_lanes[0] + 2.375e-05 * (s24 + s23) + t94_lanes[1];
  const Real t115 = s22 * (t89 - t76) + c22 * (2.0 * t71);
  const Lanes<2> t116_lanes = detail::make_pack<Real>(s9, s16) * t98_lanes -
      detail::make_pack<Real>(c9, c16) * t72_lanes;
  const Lanes<2> t120_lanes = detail::make_pack<Real>(c9, c16) * t98_lanes +
      detail::make_pack<Real>(s9, s16) * t72_lanes;
  const Real t124 = 0.788 * t113;
  const Real t125 = s22 * t115;
  const Lanes<2> t126_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) - t116_lanes;
  const Lanes<2> t127_lanes = 0.00025 * detail::make_pack<Real>(s23, s24);

  // links 11 (left_wrist1) and 18 (right_wrist1), composite inertia
  const Lanes<2> t128_lanes = 0.06060754126741261 + (t77_lanes - t109_lanes);
  const Lanes<2> t130_lanes = detail::make_pack<Real>((-2.249994685315e-05), 2.249994685315e-05) +
      (detail::make_pack<Real>(c11, c18) * t100_lanes - t58_lanes);
  const Lanes<2> t131_lanes = 0.060888541114265754 + (t60_lanes + t109_lanes);
  M[225] = t131_lanes[0];
  M[400] = t131_lanes[1];

  // links 8, 15, 22 and 23, composite inertia
  const Real t133 = M_21_21 + t124;
  const Lanes<2> t134_lanes = 0.0017499999999999998 - t120_lanes;
  const Real t135 = c22 * t93 + minus_h_22_y * s22;
  const Real t136 = t76 + t125;
  const Real t142 = c22 * t114 + s22 * t105;
  const Real t143 = t127_lanes[1] + t127_lanes[0];
  const Real t144 = t89 - t125 + t124;
  const Lanes<2> t145_lanes = detail::make_pack<Real>(c8, c15) * t99_lanes -
      detail::make_pack<Real>(s8, s15) * t126_lanes;
  const Real M_20_21 = s22 * t114 - c22 * t105;
  M[501] = M_20_21;
  M[524] = M_20_21;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), composite inertia
  const Lanes<2> t147_lanes = 0.0008177492704690715 + (t131_lanes + t96_lanes);
  const Lanes<2> t149_lanes = detail::make_pack<Real>(s10, s17) * t112_lanes -
      detail::make_pack<Real>(c10, c17) * t130_lanes;
  const Lanes<2> t150_lanes = detail::make_pack<Real>(s10, s17) * t130_lanes +
      detail::make_pack<Real>(c10, c17) * t112_lanes;
  M[201] = -t150_lanes[0];
  M[224] = -t150_lanes[0];

  // links 8, 10, 15, 17, 21, composite inertia
  M[376] = -t150_lanes[1];
  M[399] = -t150_lanes[1];
  const Real t151 = s21 * t142;
  const Lanes<2> t152_lanes = t145_lanes - 0.0017499999999999998;
  const Lanes<2> t153_lanes = detail::make_pack<Real>(s8, s15) * t99_lanes +
      detail::make_pack<Real>(c8, c15) * t126_lanes;

  // links 10, 17, 22, composite inertia
  const Real t154 = h_21_x + t135;
  const Lanes<2> t156_lanes = detail::make_pack<Real>(c10, c17) * (2.0 * t110_lanes) -
      detail::make_pack<Real>(s10, s17) * (t128_lanes - t80_lanes);
  const Lanes<2> t157_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - t149_lanes;
  const Real t160 = M_20_21 - link21_to_22_z * t143;
  const Real t161 = minus_J_21_xz + (c22 * t115 - t71 + link21_to_22_z * t135);

  // links 7, 10, 14, 17, composite inertia
  const Real t163 = t153_lanes[1] + t153_lanes[0];
  const Lanes<2> t164_lanes = detail::make_pack<Real>(s10, s17) * t156_lanes;
  const Lanes<2> t167_lanes = detail::make_pack<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + (0.282 * t62_lanes - t150_lanes);
  const Lanes<2> t168_lanes = detail::make_pack<Real>(s7, s14) * t134_lanes +
      detail::make_pack<Real>(c7, c14) * t152_lanes;
  const Lanes<2> t171_lanes = detail::make_pack<Real>(c7, c14) * t134_lanes -
      detail::make_pack<Real>(s7, s14) * t152_lanes;
  const Lanes<2> t175_lanes = t80_lanes - t164_lanes;

  // links 7 (left_shoulder1) and 21 (neck), composite inertia
  const Real t176 = c21 * (J_21_xx + t144 - (J_21_yy + t133)) + 2.0 * t151;
  const Real t178 = t168_lanes[1] + t168_lanes[0];
  const Real M_5_20 = c21 * t161 + s21 * t160;
  M[140] = -M_5_20;
  M[485] = -M_5_20;

  // links 7, 9, 16, 21, composite inertia
  const Real t179 = s21 * t161 - c21 * t160;
  const Real t181 = t171_lanes[1] + t171_lanes[0];
  const Lanes<2> t184_lanes = 0.0028970433559338655 + t175_lanes;
  const Real t185 = s21 * t154 + c21 * t143;
  const Real t186 = c21 * t176;

  // links 7, 10, 14, 17, 21, composite inertia
  const Lanes<2> t188_lanes = 0.226 * t168_lanes;
  const Lanes<2> t189_lanes = 0.0019585440854647937 + (t128_lanes + t164_lanes + t96_lanes);
  const Lanes<2> t190_lanes = 0.0005895000784280001 +
      (t110_lanes - detail::make_pack<Real>(c10, c17) * t156_lanes + 0.282 * t88_lanes);
  const Real t191 = t178 - minus_h_6_x - t113;
  const Real t192 = t185 + t163;
  const Lanes<2> t196_lanes = detail::make_pack<Real>(0.18, (-0.18)) * t153_lanes - t188_lanes;
  const Real t197 = c21 * t154 - s21 * t143;

  // links 7, 9, 16, composite inertia
  const Lanes<2> t199_lanes = detail::make_pack<Real>(s9, s16) * t190_lanes -
      detail::make_pack<Real>(c9, c16) * t167_lanes;
  const Lanes<2> t200_lanes = detail::make_pack<Real>(c9, c16) * t190_lanes +
      detail::make_pack<Real>(s9, s16) * t167_lanes;
  M[176] = -t200_lanes[0];
  M[199] = -t200_lanes[0];
  M[351] = -t200_lanes[1];
  M[374] = -t200_lanes[1];
  const Real t201 = t197 + t181;

  // links 6, 9, 16, composite inertia
  const Real t202 = c6 * t191 - s6 * t192;
  const Real t203 = s6 * t191 + c6 * t192;
  const Lanes<2> t204_lanes = detail::make_pack<Real>(c9, c16) * (t189_lanes - t147_lanes) -
      detail::make_pack<Real>(s9, s16) * (2.0 * t157_lanes);
  const Lanes<2> t205_lanes = detail::make_pack<Real>((-5.2499999999999995e-05),
      5.2499999999999995e-05) + t199_lanes;
  const Lanes<2> t206_lanes = t200_lanes - 0.00010499999999999999;
  const Real t207 = 0.144 * t202;
  const Real t208 = t202 - minus_h_5_y;
  const Real t209 = h_5_x + t201;
  const Lanes<2> t210_lanes = detail::make_pack<Real>(c9, c16) * t204_lanes;
  const Real t215 = minus_link2_to_3_y * s2;
  const Real t216 = minus_link2_to_3_y * c2;
  const Real c2_plus_3 = c2 * c3 - s2 * s3;
  const Lanes<2> t220_lanes = t147_lanes + t210_lanes;

  // links 5, 9, 16, composite inertia
  const Real t221 = s5 * t208 - c5 * t209;
  const Real t222 = s5 * t209 + c5 * t208;
  const Real s2_plus_3 = s2 * c3 + c2 * s3;
  const Lanes<2> t223_lanes = 0.18113119219699997 + (t189_lanes - t210_lanes);
  const Lanes<2> t224_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * t204_lanes + t157_lanes);

  // links 4 and 5, 8, 15, composite inertia
  const Lanes<2> t225_lanes = 0.18140244219699997 + t220_lanes;
  const Real t226 = t222 - minus_h_3_y;
  const Real t230 = c4 * t203;
  const Lanes<2> t232_lanes = detail::make_pack<Real>(c8, c15) * t206_lanes -
      detail::make_pack<Real>(s8, s15) * t224_lanes;
  const Lanes<2> t233_lanes = detail::make_pack<Real>(s8, s15) * t206_lanes +
      detail::make_pack<Real>(c8, c15) * t224_lanes;
  M[151] = t233_lanes[0];
  M[174] = t233_lanes[0];
  M[326] = t233_lanes[1];
  M[349] = t233_lanes[1];
  const Real t234 = minus_h_3_x + s4 * t203 + (minus_h_4_x + t221) * c4;
  const Real t235 = t230 - s4 * t221;
  const Lanes<2> t236_lanes = detail::make_pack<Real>(s8, s15) * (t184_lanes - t223_lanes) +
      detail::make_pack<Real>(c8, c15) * (2.0 * t205_lanes);
  const Lanes<2> t237_lanes = t232_lanes - 8.75e-06;
  const Lanes<2> t238_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + t233_lanes;
  const Real t239 = t235 - minus_h_4_x * s4;

  // links 4 (chest1) and 5 (chest2), mass matrix; links 3, 8, 15, composite inertia
  const Real t240 = c4 * t222;
  const Lanes<2> t241_lanes = detail::make_pack<Real>(s8, s15) * t236_lanes;
  const Real t246 = c2_plus_3 * t226 - s2_plus_3 * t234;
  const Real t247 = c2_plus_3 * t239;
  const Real t252 = s2_plus_3 * t221 - c2_plus_3 * t240;
  const Real t253 = h_2_x * s2 - minus_h_2_y * c2 + t246;

  // links 8 (left_shoulder2) and 15 (right_shoulder2), composite inertia
  const Lanes<2> t254_lanes = 0.0002975 + (t184_lanes - t241_lanes);
  const Lanes<2> t255_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * t236_lanes - t205_lanes);
  const Lanes<2> t256_lanes = 0.000448 + (t223_lanes + t241_lanes);
  M[150] = t256_lanes[0];
  M[325] = t256_lanes[1];

  // links 6 and 7, 14, mass matrix; link 3 (hip), composite inertia
  const Real t257 = c5 * t203;
  const Real t258 = t215 * (c2_plus_3 * t234 + s2_plus_3 * t226) + t216 * t246;
  const Lanes<2> t262_lanes = t256_lanes - t188_lanes;
  const Lanes<2> t263_lanes = s6 * t171_lanes;
  const Real t264 = t230 * s5 - s4 * t202;
  const Lanes<2> t271_lanes = c6 * t171_lanes;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), composite inertia
  const Real t274 = 1.67475326092404 + t144 - t186 + t256_lanes[1] + t256_lanes[0] - 0.452 * t178;
  const Lanes<2> t276_lanes = detail::make_pack<Real>(c7, c14) * (t225_lanes - t254_lanes) -
      detail::make_pack<Real>(s7, s14) * (2.0 * t237_lanes);
  const Lanes<2> t277_lanes = detail::make_pack<Real>(s7, s14) * t238_lanes +
      detail::make_pack<Real>(c7, c14) * t255_lanes - detail::make_pack<Real>(0.18, (-0.18)) *
      t168_lanes;
  const Lanes<2> t278_lanes = detail::make_pack<Real>(c7, c14) * t238_lanes -
      detail::make_pack<Real>(s7, s14) * t255_lanes - detail::make_pack<Real>(0.18, (-0.18)) *
      t171_lanes;
  M[126] = t278_lanes[0];
  M[149] = t278_lanes[0];
  M[133] = t278_lanes[1];
  M[317] = t278_lanes[1];
  const Lanes<2> t282_lanes = detail::make_pack<Real>(c7, c14) * t276_lanes;
  const Lanes<2> t283_lanes = detail::make_pack<Real>(s7, s14) * t276_lanes;

  // links 6 and 7, 14, mass matrix; links 9 (left_upperarm) and 16 (right_upperarm), composite
  //   inertia
  const Lanes<2> t285_lanes = t278_lanes - minus_link5_to_6_y * t263_lanes;
  const Lanes<2> t287_lanes = 0.18125194219699997 + t220_lanes;
  M[175] = t287_lanes[0];
  M[350] = t287_lanes[1];
  const Real t289 = c2_plus_3 * t264 + s2_plus_3 * t257;

  // links 7 and 8, 14 and 15, mass matrix; link 7 (left_shoulder1), composite inertia
  const Lanes<2> t290_lanes = detail::make_pack<Real>(s7, s14) * t153_lanes;
  const Real t291 = t278_lanes[1] - (t142 - s21 * t176) + t278_lanes[0];
  const Lanes<2> t293_lanes = s5 * t168_lanes - c5 * t271_lanes;
  const Real t294 = t282_lanes[1] + t282_lanes[0];
  const Lanes<2> t297_lanes = c6 * t277_lanes - s6 * t262_lanes;
  const Real t298 = t179 + t277_lanes[1] + t277_lanes[0] + 0.226 * t163;
  const Lanes<2> t300_lanes = detail::make_pack<Real>(c7, c14) * t153_lanes;
  const Lanes<2> t314_lanes = detail::make_pack<Real>(s7, s14) * t287_lanes +
      detail::make_pack<Real>(c7, c14) * t232_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      t290_lanes;
  const Lanes<2> t315_lanes = t233_lanes + 0.226 * t290_lanes;
  const Real M_5_5 = 2.07035776092404 + t133 + t186 + t254_lanes[1] + t294 + t254_lanes[0] + 2.0 *
      (t196_lanes[1] + t196_lanes[0]);
  M[125] = M_5_5;
  const Lanes<2> t319_lanes = s4 * t263_lanes + c4 * (c5 * t168_lanes + s5 * t271_lanes);
  const Lanes<2> t321_lanes = c6 * t300_lanes + s6 * t145_lanes;
  const Lanes<2> t322_lanes = c6 * t145_lanes - s6 * t300_lanes;
  const Lanes<2> t323_lanes = detail::make_pack<Real>(0.18, (-0.18)) * t300_lanes - 0.226 *
      t145_lanes;

  // links 7, 10, 17, composite inertia; link 6 (chest3), mass matrix
  const Real t325 = 0.40663174999999996 + t136 + t225_lanes[1] - t294 + (-0.36) * t153_lanes[1] +
      t225_lanes[0] + 0.36 * t153_lanes[0];
  const Real t326 = J_6_xz + M_5_20 + t283_lanes[1] + t237_lanes[1] + t283_lanes[0] +
      t237_lanes[0] + 0.226 * t181;
  const Real t328 = M_5_5 - minus_link5_to_6_y * t202;
  const Lanes<2> t331_lanes = 0.0027762933559338653 + t175_lanes;
  M[200] = t331_lanes[0];
  M[375] = t331_lanes[1];

  // links 8 (left_shoulder2) and 15 (right_shoulder2), mass matrix
  const Lanes<2> t334_lanes = detail::make_pack<Real>(c7, c14) * t287_lanes -
      detail::make_pack<Real>(s7, s14) * t232_lanes + t323_lanes;
  M[127] = t334_lanes[0];
  M[173] = t334_lanes[0];
  M[134] = t334_lanes[1];
  M[341] = t334_lanes[1];

  // link 6 (chest3), composite inertia; links 8 and 9, 15 and 16, mass matrix
  const Real t336 = J_5_xx + (M_5_5 - t207);
  const Lanes<2> t337_lanes = detail::make_pack<Real>(s8, s15) * t120_lanes;
  const Lanes<2> t346_lanes = c6 * t314_lanes - s6 * t315_lanes;
  const Real t348 = c6 * t326 - s6 * t291;
  const Real M_4_5 = s6 * t326 + c6 * t291;
  M[101] = M_4_5;
  M[124] = M_4_5;
  const Lanes<2> t352_lanes = detail::make_pack<Real>(s8, s15) * t199_lanes -
      detail::make_pack<Real>(c8, c15) * t331_lanes;
  const Lanes<2> t353_lanes = detail::make_pack<Real>(c8, c15) * t120_lanes;
  const Lanes<2> t354_lanes = t334_lanes - minus_link5_to_6_y * t322_lanes;
  const Lanes<2> t355_lanes = detail::make_pack<Real>(s8, s15) * t331_lanes +
      detail::make_pack<Real>(c8, c15) * t199_lanes;
  M[152] = -t355_lanes[0];
  M[198] = -t355_lanes[0];
  M[327] = -t355_lanes[1];
  M[373] = -t355_lanes[1];
  const Real t358 = s6 * (t325 - t274) + c6 * (2.0 * t298);
  const Lanes<2> t359_lanes = c5 * t321_lanes - s5 * t290_lanes;
  const Lanes<2> t360_lanes = detail::make_pack<Real>(s7, s14) * t116_lanes +
      detail::make_pack<Real>(c7, c14) * t337_lanes;
  const Lanes<2> t362_lanes = detail::make_pack<Real>(c7, c14) * t116_lanes -
      detail::make_pack<Real>(s7, s14) * t337_lanes;
  const Real t366 = s6 * t358;
  const Real t367 = J_5_xy + (t348 + minus_link5_to_6_y * t201);
  const Lanes<2> t377_lanes = detail::make_pack<Real>(c7, c14) * t200_lanes +
      detail::make_pack<Real>(s7, s14) * t352_lanes;
  const Lanes<2> t379_lanes = c4 * (c5 * t290_lanes + s5 * t321_lanes) - s4 * t322_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), mass matrix; link 6 (chest3), composite
  //   inertia
  const Lanes<2> t381_lanes = c6 * t360_lanes + s6 * t353_lanes;
  const Lanes<2> t382_lanes = detail::make_pack<Real>(0.18, (-0.18)) * t362_lanes -
      (detail::make_pack<Real>(s7, s14) * t200_lanes - detail::make_pack<Real>(c7, c14) *
      t352_lanes);
  const Lanes<2> t383_lanes = 0.226 * t362_lanes - t355_lanes;
  const Lanes<2> t384_lanes = s6 * t360_lanes - c6 * t353_lanes;
  const Real t391 = J_5_yy + (t325 - t366);
  const Real t392 = c6 * t358 - t298 + minus_link5_to_6_y * t203;
  const Real t393 = t274 + t366 - t207;
  const Lanes<2> t399_lanes = 0.226 * t353_lanes - detail::make_pack<Real>(0.18, (-0.18)) *
      t360_lanes - t377_lanes;
  M[128] = t399_lanes[0];
  M[197] = t399_lanes[0];
  M[135] = t399_lanes[1];
  M[365] = t399_lanes[1];

  // links 10 (left_lowerarm) and 17 (right_lowerarm), mass matrix; link 6 (chest3), composite
  //   inertia
  const Lanes<2> t400_lanes = detail::make_pack<Real>(s9, s16) * t87_lanes;
  const Lanes<2> t403_lanes = t131_lanes + 0.282 * t87_lanes;
  const Lanes<2> t404_lanes = detail::make_pack<Real>(c9, c16) * t87_lanes;
  const Real M_4_4 = J_5_zz + t393;
  M[100] = M_4_4;

  // links 9 (left_upperarm) and 16 (right_upperarm), mass matrix; link 5 (chest2), composite
  //   inertia
  const Lanes<2> t410_lanes = c6 * t382_lanes - s6 * t383_lanes;
  const Lanes<2> t411_lanes = t399_lanes - minus_link5_to_6_y * t384_lanes;
  const Real t416 = s5 * t392 - c5 * M_4_5;
  const Lanes<2> t422_lanes = s5 * t362_lanes + c5 * t381_lanes;
  const Real t424 = s5 * (t336 - t391) + c5 * (2.0 * t367);

  // links 9 and 10, 16 and 17, mass matrix
  const Lanes<2> t426_lanes = detail::make_pack<Real>(s8, s15) * t400_lanes -
      detail::make_pack<Real>(c8, c15) * t88_lanes;
  const Lanes<2> t427_lanes = detail::make_pack<Real>(s9, s16) * t149_lanes -
      detail::make_pack<Real>(c9, c16) * t403_lanes;
  const Lanes<2> t428_lanes = detail::make_pack<Real>(c9, c16) * t149_lanes +
      detail::make_pack<Real>(s9, s16) * t403_lanes;
  M[177] = -t428_lanes[0];
  M[223] = -t428_lanes[0];
  M[352] = -t428_lanes[1];
  M[398] = -t428_lanes[1];
  const Lanes<2> t429_lanes = c4 * (s5 * t381_lanes - c5 * t362_lanes) + s4 * t384_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), mass matrix; link 5 (chest2), composite
  //   inertia
  const Lanes<2> t433_lanes = detail::make_pack<Real>(s8, s15) * t88_lanes +
      detail::make_pack<Real>(c8, c15) * t400_lanes;
  const Real t434 = s5 * t424;
  const Lanes<2> t450_lanes = detail::make_pack<Real>(s7, s14) * t404_lanes -
      detail::make_pack<Real>(c7, c14) * t426_lanes;
  const Lanes<2> t451_lanes = detail::make_pack<Real>(c8, c15) * t150_lanes +
      detail::make_pack<Real>(s8, s15) * t427_lanes;
  const Lanes<2> t452_lanes = detail::make_pack<Real>(c7, c14) * t404_lanes +
      detail::make_pack<Real>(s7, s14) * t426_lanes;
  const Lanes<2> t454_lanes = detail::make_pack<Real>(s8, s15) * t150_lanes -
      detail::make_pack<Real>(c8, c15) * t427_lanes;
  M[153] = t454_lanes[0];
  M[222] = t454_lanes[0];
  M[328] = t454_lanes[1];
  M[397] = t454_lanes[1];
  const Real M_3_4 = s5 * M_4_5 + c5 * t392;
  M[76] = -M_3_4;
  M[99] = -M_3_4;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), mass matrix
  const Lanes<2> t457_lanes = s6 * t277_lanes + c6 * t262_lanes - minus_link5_to_6_y * t168_lanes;
  M[102] = t457_lanes[0];
  M[148] = t457_lanes[0];
  M[109] = t457_lanes[1];
  M[316] = t457_lanes[1];

  // links 12 (left_wrist2) and 19 (right_wrist2), composite inertia; links 10 and 11, 17 and 18,
  //   mass matrix
  const Lanes<2> t461_lanes = 0.00022920000000000001 + t68_lanes;
  M[250] = t461_lanes[0];
  M[425] = t461_lanes[1];
  const Lanes<2> t467_lanes = detail::make_pack<Real>(c10, c17) * t62_lanes;
  const Lanes<2> t473_lanes = s6 * t433_lanes - c6 * t450_lanes;

  // links 8 (left_shoulder2) and 15 (right_shoulder2), mass matrix
  const Lanes<2> t475_lanes = s6 * t314_lanes + c6 * t315_lanes + minus_link5_to_6_y * t290_lanes;
  M[103] = t475_lanes[0];
  M[172] = t475_lanes[0];
  M[110] = t475_lanes[1];
  M[340] = t475_lanes[1];

  // links 10 and 11, 17 and 18, mass matrix
  const Lanes<2> t478_lanes = t454_lanes - 0.226 * t452_lanes;
  const Lanes<2> t479_lanes = s6 * t450_lanes + c6 * t433_lanes;
  const Lanes<2> t482_lanes = detail::make_pack<Real>(c7, c14) * t428_lanes +
      detail::make_pack<Real>(s7, s14) * t451_lanes;
  const Lanes<2> t489_lanes = detail::make_pack<Real>(s7, s14) * t428_lanes -
      detail::make_pack<Real>(c7, c14) * t451_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      t452_lanes;
  const Lanes<2> t491_lanes = detail::make_pack<Real>(s10, s17) * t62_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), mass matrix
  const Lanes<2> t493_lanes = detail::make_pack<Real>(c10, c17) * t461_lanes -
      detail::make_pack<Real>(s10, s17) * t101_lanes;
  M[202] = t493_lanes[0];
  M[248] = t493_lanes[0];
  M[377] = t493_lanes[1];
  M[423] = t493_lanes[1];
  const Lanes<2> t497_lanes = detail::make_pack<Real>(c10, c17) * t101_lanes +
      detail::make_pack<Real>(s10, s17) * t461_lanes + 0.282 * t61_lanes;
  const Lanes<2> t498_lanes = t102_lanes + 0.282 * t467_lanes;
  const Lanes<2> t499_lanes = detail::make_pack<Real>(c9, c16) * t467_lanes +
      detail::make_pack<Real>(s9, s16) * t61_lanes;
  const Lanes<2> t501_lanes = detail::make_pack<Real>(s9, s16) * t467_lanes -
      detail::make_pack<Real>(c9, c16) * t61_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), mass matrix
  const Lanes<2> t504_lanes = 0.226 * t433_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      t450_lanes - t482_lanes;
  M[129] = t504_lanes[0];
  M[221] = t504_lanes[0];
  M[136] = t504_lanes[1];
  M[389] = t504_lanes[1];
  const Lanes<2> t518_lanes = c6 * t489_lanes + s6 * t478_lanes;
  const Lanes<2> t520_lanes = t504_lanes + minus_link5_to_6_y * t479_lanes;
  const Lanes<2> t521_lanes = s5 * t452_lanes - c5 * t473_lanes;

  // links 9, 11, 16, 18, mass matrix
  const Lanes<2> t524_lanes = detail::make_pack<Real>(s9, s16) * t497_lanes +
      detail::make_pack<Real>(c9, c16) * t498_lanes;
  const Lanes<2> t525_lanes = s6 * t382_lanes + c6 * t383_lanes + minus_link5_to_6_y * t362_lanes;
  M[104] = t525_lanes[0];
  M[196] = t525_lanes[0];
  M[111] = t525_lanes[1];
  M[364] = t525_lanes[1];

  // links 11 (left_wrist1) and 18 (right_wrist1), mass matrix
  const Lanes<2> t526_lanes = detail::make_pack<Real>(s8, s15) * t501_lanes -
      detail::make_pack<Real>(c8, c15) * t491_lanes;
  const Lanes<2> t527_lanes = detail::make_pack<Real>(s8, s15) * t491_lanes +
      detail::make_pack<Real>(c8, c15) * t501_lanes;
  const Lanes<2> t528_lanes = detail::make_pack<Real>(c9, c16) * t497_lanes -
      detail::make_pack<Real>(s9, s16) * t498_lanes;
  M[178] = t528_lanes[0];
  M[247] = t528_lanes[0];
  M[353] = t528_lanes[1];
  M[422] = t528_lanes[1];

  // links 10 (left_lowerarm) and 17 (right_lowerarm), mass matrix; link 4 (chest1), composite
  //   inertia
  const Lanes<2> t531_lanes = s4 * t479_lanes - c4 * (c5 * t452_lanes + s5 * t473_lanes);
  const Real t532 = 0.03561389675370483 * s4 - (c4 * (2.0 * t416) - s4 * (t336 - t434 - M_4_4));
  const Lanes<2> t537_lanes = c6 * t478_lanes - s6 * t489_lanes - minus_link5_to_6_y * t452_lanes;
  M[105] = t537_lanes[0];
  M[220] = t537_lanes[0];
  M[112] = t537_lanes[1];
  M[388] = t537_lanes[1];

  // links 11 (left_wrist1) and 18 (right_wrist1), mass matrix
  const Lanes<2> t548_lanes = detail::make_pack<Real>(c8, c15) * t493_lanes +
      detail::make_pack<Real>(s8, s15) * t524_lanes;
  const Lanes<2> t549_lanes = detail::make_pack<Real>(c8, c15) * t524_lanes -
      detail::make_pack<Real>(s8, s15) * t493_lanes;
  M[154] = t549_lanes[0];
  M[246] = t549_lanes[0];
  M[329] = t549_lanes[1];
  M[421] = t549_lanes[1];
  const Lanes<2> t550_lanes = detail::make_pack<Real>(s7, s14) * t499_lanes -
      detail::make_pack<Real>(c7, c14) * t526_lanes;

  // links 7, 11 and 12, 14, 18 and 19, mass matrix
  const Lanes<2> t551_lanes = detail::make_pack<Real>(c7, c14) * t499_lanes +
      detail::make_pack<Real>(s7, s14) * t526_lanes;
  const Lanes<2> t559_lanes = s2_plus_3 * t293_lanes - c2_plus_3 * t319_lanes;
  const Lanes<2> t560_lanes = detail::make_pack<Real>(s11, s18) * t32_lanes;
  const Lanes<2> t567_lanes = detail::make_pack<Real>(c11, c18) * t32_lanes;
  const Lanes<2> t568_lanes = t31_lanes + 0.269 * t32_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), mass matrix
  const Lanes<2> t577_lanes = s6 * t527_lanes - c6 * t550_lanes;
  const Lanes<2> t578_lanes = s6 * t550_lanes + c6 * t527_lanes;
  const Lanes<2> t584_lanes = detail::make_pack<Real>(c7, c14) * t548_lanes -
      detail::make_pack<Real>(s7, s14) * t528_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      t551_lanes;
  const Lanes<2> t585_lanes = t549_lanes - 0.226 * t551_lanes;
  const Lanes<2> t586_lanes = 0.226 * t527_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      t550_lanes;

  // links 12 (left_wrist2) and 19 (right_wrist2), mass matrix
  const Lanes<2> t596_lanes = detail::make_pack<Real>(c11, c18) * t48_lanes +
      detail::make_pack<Real>(s11, s18) * t568_lanes;
  const Lanes<2> t597_lanes = detail::make_pack<Real>(c10, c17) * t567_lanes -
      detail::make_pack<Real>(s10, s17) * t33_lanes;
  const Lanes<2> t598_lanes = detail::make_pack<Real>(c11, c18) * t568_lanes -
      detail::make_pack<Real>(s11, s18) * t48_lanes;
  M[227] = t598_lanes[0];
  M[273] = t598_lanes[0];
  M[402] = t598_lanes[1];
  M[448] = t598_lanes[1];

  // links 8, 11, 15, 18, mass matrix
  const Lanes<2> t602_lanes = detail::make_pack<Real>(c7, c14) * t528_lanes +
      detail::make_pack<Real>(s7, s14) * t548_lanes + t586_lanes;
  M[130] = t602_lanes[0];
  M[245] = t602_lanes[0];
  M[137] = t602_lanes[1];
  M[413] = t602_lanes[1];
  const Lanes<2> t606_lanes = c2_plus_3 * t379_lanes + s2_plus_3 * t359_lanes;

  // links 9, 11 and 12, 16, 18 and 19, mass matrix
  const Lanes<2> t611_lanes = detail::make_pack<Real>(s10, s17) * t567_lanes +
      detail::make_pack<Real>(c10, c17) * t33_lanes;
  const Lanes<2> t614_lanes = t602_lanes + minus_link5_to_6_y * t578_lanes;
  const Lanes<2> t615_lanes = s5 * t551_lanes - c5 * t577_lanes;
  const Lanes<2> t617_lanes = c6 * t584_lanes + s6 * t585_lanes;
  const Lanes<2> t623_lanes = c2_plus_3 * t429_lanes + s2_plus_3 * t422_lanes;

  // links 12 (left_wrist2) and 19 (right_wrist2), mass matrix
  const Lanes<2> t625_lanes = detail::make_pack<Real>(s9, s16) * t597_lanes +
      detail::make_pack<Real>(c9, c16) * t560_lanes;
  const Lanes<2> t626_lanes = t598_lanes + 0.282 * t597_lanes;
  const Lanes<2> t628_lanes = detail::make_pack<Real>(s9, s16) * t560_lanes -
      detail::make_pack<Real>(c9, c16) * t597_lanes;
  const Lanes<2> t629_lanes = detail::make_pack<Real>(s10, s17) * t596_lanes -
      detail::make_pack<Real>(c10, c17) * t49_lanes;
  M[203] = t629_lanes[0];
  M[272] = t629_lanes[0];
  M[378] = t629_lanes[1];
  M[447] = t629_lanes[1];

  // links 11 (left_wrist1) and 18 (right_wrist1), mass matrix
  const Lanes<2> t632_lanes = s4 * t578_lanes - c4 * (c5 * t551_lanes + s5 * t577_lanes);
  const Lanes<2> t634_lanes = c6 * t585_lanes - s6 * t584_lanes - minus_link5_to_6_y * t551_lanes;
  M[106] = t634_lanes[0];
  M[244] = t634_lanes[0];
  M[113] = t634_lanes[1];
  M[412] = t634_lanes[1];

  // links 10 to 12, 17 to 19, mass matrix; link 4 (chest1), composite inertia
  const Lanes<2> t636_lanes = detail::make_pack<Real>(c10, c17) * t596_lanes +
      detail::make_pack<Real>(s10, s17) * t49_lanes + 0.282 * t560_lanes;
  const Lanes<2> t652_lanes = detail::make_pack<Real>(s8, s15) * t625_lanes -
      detail::make_pack<Real>(c8, c15) * t611_lanes;
  const Lanes<2> t653_lanes = detail::make_pack<Real>(s8, s15) * t611_lanes +
      detail::make_pack<Real>(c8, c15) * t625_lanes;
  const Lanes<2> t654_lanes = c2_plus_3 * t531_lanes + s2_plus_3 * t521_lanes;
  const Real M_2_2 = 1.9978863071791395 + t393 - 0.43599999999999994 * t222 + t532 * s4;
  M[50] = M_2_2;
  const Lanes<2> t659_lanes = c2_plus_3 * t632_lanes + s2_plus_3 * t615_lanes;

  // links 12 (left_wrist2) and 19 (right_wrist2), mass matrix
  const Lanes<2> t662_lanes = detail::make_pack<Real>(s9, s16) * t636_lanes -
      detail::make_pack<Real>(c9, c16) * t626_lanes;
  M[300] = 0.0009386316083993107;
  M[475] = 0.0009386316083993107;
  const Lanes<2> t667_lanes = detail::make_pack<Real>(c9, c16) * t636_lanes +
      detail::make_pack<Real>(s9, s16) * t626_lanes;
  M[179] = -t667_lanes[0];
  M[271] = -t667_lanes[0];
  M[354] = -t667_lanes[1];
  M[446] = -t667_lanes[1];

  // links 12 and 13, 19 and 20, mass matrix
  const Lanes<2> t671_lanes = detail::make_pack<Real>(s12, s19) * t13_lanes;
  const Lanes<2> t678_lanes = detail::make_pack<Real>(s7, s14) * t628_lanes +
      detail::make_pack<Real>(c7, c14) * t652_lanes;
  const Lanes<2> t680_lanes = detail::make_pack<Real>(c7, c14) * t628_lanes -
      detail::make_pack<Real>(s7, s14) * t652_lanes;
  const Lanes<2> t692_lanes = t20_lanes - 0.0009386316083993107 * detail::make_pack<Real>(s12, s19);
  M[252] = t692_lanes[0];
  M[298] = t692_lanes[0];
  M[427] = t692_lanes[1];
  M[473] = t692_lanes[1];
  const Lanes<2> t693_lanes = detail::make_pack<Real>(s8, s15) * t662_lanes -
      detail::make_pack<Real>(c8, c15) * t629_lanes;
  const Lanes<2> t694_lanes = 0.0009386316083993107 * detail::make_pack<Real>(c12, c19) +
      detail::make_pack<Real>(s12, s19) * t15_lanes + 0.00444264243991307 *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> t695_lanes = detail::make_pack<Real>(c12, c19) * t13_lanes;
  const Lanes<2> t700_lanes = detail::make_pack<Real>(s8, s15) * t629_lanes +
      detail::make_pack<Real>(c8, c15) * t662_lanes;
  M[155] = -t700_lanes[0];
  M[270] = -t700_lanes[0];
  M[330] = -t700_lanes[1];
  M[445] = -t700_lanes[1];
  const Lanes<2> t702_lanes = t17_lanes - 0.269 * t671_lanes;
  const Lanes<2> t703_lanes = detail::make_pack<Real>(s11, s18) * t671_lanes +
      detail::make_pack<Real>(c11, c18) * t7_lanes;
  const Lanes<2> t706_lanes = detail::make_pack<Real>(c11, c18) * t671_lanes -
      detail::make_pack<Real>(s11, s18) * t7_lanes;
  const Lanes<2> t711_lanes = c6 * t678_lanes + s6 * t653_lanes;
  const Lanes<2> t720_lanes = 0.226 * t680_lanes - t700_lanes;
  const Lanes<2> t725_lanes = s6 * t678_lanes - c6 * t653_lanes;
  const Lanes<2> t726_lanes = detail::make_pack<Real>(c7, c14) * t667_lanes +
      detail::make_pack<Real>(s7, s14) * t693_lanes;
  const Lanes<2> t730_lanes = detail::make_pack<Real>(c11, c18) * t694_lanes -
      detail::make_pack<Real>(s11, s18) * t702_lanes;
  const Lanes<2> t731_lanes = detail::make_pack<Real>(s11, s18) * t694_lanes +
      detail::make_pack<Real>(c11, c18) * t702_lanes;
  M[228] = t731_lanes[0];
  M[297] = t731_lanes[0];
  M[403] = t731_lanes[1];
  M[472] = t731_lanes[1];
  const Lanes<2> t734_lanes = detail::make_pack<Real>(c10, c17) * t706_lanes +
      detail::make_pack<Real>(s10, s17) * t695_lanes;
  const Lanes<2> t735_lanes = detail::make_pack<Real>(0.18, (-0.18)) * t680_lanes -
      (detail::make_pack<Real>(s7, s14) * t667_lanes - detail::make_pack<Real>(c7, c14) *
      t693_lanes);
  const Lanes<2> t738_lanes = detail::make_pack<Real>(c10, c17) * t695_lanes -
      detail::make_pack<Real>(s10, s17) * t706_lanes;

  // links 12 (left_wrist2) and 19 (right_wrist2), mass matrix
  const Lanes<2> t740_lanes = 0.226 * t653_lanes - detail::make_pack<Real>(0.18, (-0.18)) *
      t678_lanes - t726_lanes;
  M[131] = t740_lanes[0];
  M[269] = t740_lanes[0];
  M[138] = t740_lanes[1];
  M[437] = t740_lanes[1];
  const Lanes<2> t744_lanes = s5 * t680_lanes + c5 * t711_lanes;
  const Lanes<2> t752_lanes = t740_lanes - minus_link5_to_6_y * t725_lanes;

  // links 13 (left_hand) and 20 (right_hand), mass matrix
  const Lanes<2> t759_lanes = detail::make_pack<Real>(c10, c17) * t692_lanes -
      detail::make_pack<Real>(s10, s17) * t730_lanes;
  M[204] = t759_lanes[0];
  M[296] = t759_lanes[0];
  M[379] = t759_lanes[1];
  M[471] = t759_lanes[1];
  const Lanes<2> t762_lanes = detail::make_pack<Real>(s9, s16) * t734_lanes +
      detail::make_pack<Real>(c9, c16) * t703_lanes;
  const Lanes<2> t763_lanes = t731_lanes - 0.282 * t734_lanes;
  const Lanes<2> t764_lanes = detail::make_pack<Real>(c9, c16) * t734_lanes -
      detail::make_pack<Real>(s9, s16) * t703_lanes;

  // links 12 and 13, 19 and 20, mass matrix
  const Lanes<2> t765_lanes = c6 * t735_lanes - s6 * t720_lanes;
  const Lanes<2> t767_lanes = c4 * (s5 * t711_lanes - c5 * t680_lanes) + s4 * t725_lanes;
  const Lanes<2> t770_lanes = detail::make_pack<Real>(c10, c17) * t730_lanes +
      detail::make_pack<Real>(s10, s17) * t692_lanes + 0.282 * t703_lanes;
  const Lanes<2> t785_lanes = s6 * t735_lanes + c6 * t720_lanes + minus_link5_to_6_y * t680_lanes;
  M[107] = t785_lanes[0];
  M[268] = t785_lanes[0];
  M[114] = t785_lanes[1];
  M[436] = t785_lanes[1];

  // links 13, 20 and 21, mass matrix
  const Lanes<2> t787_lanes = detail::make_pack<Real>(c8, c15) * t738_lanes +
      detail::make_pack<Real>(s8, s15) * t762_lanes;
  const Lanes<2> t788_lanes = detail::make_pack<Real>(c8, c15) * t762_lanes -
      detail::make_pack<Real>(s8, s15) * t738_lanes;
  const Real t789 = s6 * t197;
  const Lanes<2> t793_lanes = detail::make_pack<Real>(s9, s16) * t770_lanes +
      detail::make_pack<Real>(c9, c16) * t763_lanes;
  const Lanes<2> t794_lanes = detail::make_pack<Real>(c9, c16) * t770_lanes -
      detail::make_pack<Real>(s9, s16) * t763_lanes;
  M[180] = t794_lanes[0];
  M[295] = t794_lanes[0];
  M[355] = t794_lanes[1];

  // links 12 and 13, 19 to 21, mass matrix; link 22 (head), composite inertia
  M[470] = t794_lanes[1];
  const Lanes<2> t795_lanes = c2_plus_3 * t767_lanes + s2_plus_3 * t744_lanes;
  const Real t801 = c6 * t197;
  const Real M_20_20 = J_21_zz + t136;
  M[500] = M_20_20;

  // links 7 and 8, 13 to 15, 20, mass matrix
  const Lanes<2> t808_lanes = detail::make_pack<Real>(c7, c14) * t787_lanes -
      detail::make_pack<Real>(s7, s14) * t764_lanes;
  const Lanes<2> t809_lanes = detail::make_pack<Real>(c7, c14) * t764_lanes +
      detail::make_pack<Real>(s7, s14) * t787_lanes;
  const Lanes<2> t811_lanes = c4 * t457_lanes - s4 * (s5 * t297_lanes - c5 * t285_lanes);
  const Lanes<2> t812_lanes = c4 * t475_lanes - s4 * (s5 * t346_lanes - c5 * t354_lanes);
  const Lanes<2> t813_lanes = detail::make_pack<Real>(c8, c15) * t759_lanes +
      detail::make_pack<Real>(s8, s15) * t793_lanes;

  // links 13 (left_hand) and 20 (right_hand), mass matrix
  const Lanes<2> t814_lanes = detail::make_pack<Real>(c8, c15) * t793_lanes -
      detail::make_pack<Real>(s8, s15) * t759_lanes;
  M[156] = t814_lanes[0];
  M[294] = t814_lanes[0];
  M[331] = t814_lanes[1];
  M[469] = t814_lanes[1];

  // links 13, 20 to 22, mass matrix
  const Real t820 = s21 * t113;
  const Real t824 = c21 * t113;
  const Real t826 = s6 * t179 - c6 * M_20_20;
  const Real t827 = minus_link5_to_6_y * t801 + M_5_20;
  const Lanes<2> t828_lanes = c6 * t808_lanes + s6 * t788_lanes;
  const Lanes<2> t829_lanes = t814_lanes + 0.226 * t809_lanes;
  const Lanes<2> t830_lanes = c6 * t788_lanes - s6 * t808_lanes;
  const Lanes<2> t832_lanes = detail::make_pack<Real>(0.18, (-0.18)) * t808_lanes - 0.226 *
      t788_lanes;
  const Real t841 = c6 * t135 - s6 * t820;
  const Lanes<2> t842_lanes = detail::make_pack<Real>(0.18, (-0.18)) * t809_lanes -
      (detail::make_pack<Real>(c7, c14) * t813_lanes - detail::make_pack<Real>(s7, s14) *
      t794_lanes);
  const Real t843 = s6 * t135 + c6 * t820;
  const Lanes<2> t844_lanes = detail::make_pack<Real>(c7, c14) * t794_lanes +
      detail::make_pack<Real>(s7, s14) * t813_lanes + t832_lanes;
  M[132] = t844_lanes[0];
  M[293] = t844_lanes[0];
  M[139] = t844_lanes[1];
  M[461] = t844_lanes[1];
  const Real t845 = s5 * t185 + c5 * t789;
  const Real t846 = s4 * t801 + c4 * (c5 * t185 - s5 * t789);
  const Real t848 = M_21_21 + link21_to_22_z * t113;
  const Lanes<2> t851_lanes = t844_lanes - minus_link5_to_6_y * t830_lanes;
  const Lanes<2> t853_lanes = c5 * t828_lanes - s5 * t809_lanes;

  // links 13, 20, 22 to 24, mass matrix
  const Lanes<2> t854_lanes = c22 * t127_lanes;
  const Lanes<2> t857_lanes = c6 * t842_lanes - s6 * t829_lanes;
  const Lanes<2> t859_lanes = s22 * t127_lanes;
  const Real t860 = s5 * t824 + c5 * t841;
  const Lanes<2> t865_lanes = c4 * (c5 * t809_lanes + s5 * t828_lanes) - s4 * t830_lanes;

  // links 22 to 24, mass matrix
  const Real t867 = t151 - c21 * t848;
  const Real M_5_21 = c21 * t142 + s21 * t848;
  M[141] = -M_5_21;
  M[509] = -M_5_21;
  const Lanes<2> t873_lanes = s21 * t854_lanes - c21 * t73_lanes;
  const Lanes<2> t874_lanes = c21 * t854_lanes + s21 * t73_lanes;
  M[550] = 9.25e-06;
  M[575] = 9.25e-06;
  const Lanes<2> t875_lanes = 9.25e-06 + t45_lanes;
  const Real t876 = M_5_21 + minus_link5_to_6_y * t843;
  const Real t879 = c4 * (s5 * t841 - c5 * t824) + s4 * t843;
  const Real t888 = s6 * t867 - c6 * M_20_21;
  const Lanes<2> t889_lanes = t95_lanes + link21_to_22_z * t854_lanes;

  // links 13 (left_hand) and 20 (right_hand), mass matrix
  const Lanes<2> t890_lanes = s6 * t842_lanes + c6 * t829_lanes + minus_link5_to_6_y * t809_lanes;
  M[108] = t890_lanes[0];
  M[292] = t890_lanes[0];
  M[115] = t890_lanes[1];
  M[460] = t890_lanes[1];

  // links 23 (left_eye) and 24 (right_eye), mass matrix
  const Lanes<2> t893_lanes = s6 * t873_lanes - c6 * t859_lanes;
  const Lanes<2> t894_lanes = s6 * t859_lanes + c6 * t873_lanes;
  const Lanes<2> t895_lanes = s22 * t46_lanes + c22 * t875_lanes;
  M[502] = t895_lanes[0];
  M[548] = t895_lanes[0];
  M[503] = t895_lanes[1];
  M[572] = t895_lanes[1];

  // links 21 (neck) and 22 (head), mass matrix
  const Real M_4_20 = s6 * M_20_20 + c6 * t179 + minus_link5_to_6_y * t185;
  M[116] = -M_4_20;
  M[484] = -M_4_20;
  const Real M_4_21 = s6 * M_20_21 + c6 * t867 - minus_link5_to_6_y * t824;
  M[117] = -M_4_21;
  M[508] = -M_4_21;

  // links 13, 20 to 24, mass matrix
  const Lanes<2> t901_lanes = c22 * t46_lanes - s22 * t875_lanes + 9.850000000000001e-05 *
      detail::make_pack<Real>(c23, c24);
  const Lanes<2> t909_lanes = c2_plus_3 * t865_lanes + s2_plus_3 * t853_lanes;
  const Real t910 = s2_plus_3 * t845 - c2_plus_3 * t846;
  const Real t914 = s2_plus_3 * t860 + c2_plus_3 * t879;
  const Lanes<2> t915_lanes = s5 * t874_lanes - c5 * t893_lanes;
  const Lanes<2> t919_lanes = s21 * t901_lanes + c21 * t889_lanes;
  const Lanes<2> t920_lanes = s21 * t889_lanes - c21 * t901_lanes;
  M[142] = t920_lanes[0];

  // links 9 and 10, 16 and 17, 23 and 24, mass matrix
  M[533] = t920_lanes[0];
  M[143] = t920_lanes[1];
  M[557] = t920_lanes[1];
  const Lanes<2> t924_lanes = c4 * t525_lanes - s4 * (s5 * t410_lanes - c5 * t411_lanes);
  const Lanes<2> t925_lanes = s4 * (c5 * t520_lanes + s5 * t518_lanes) + c4 * t537_lanes;

  // links 11 to 13, 18 to 20, 23 and 24, mass matrix
  const Lanes<2> t926_lanes = s4 * (c5 * t614_lanes + s5 * t617_lanes) + c4 * t634_lanes;
  const Lanes<2> t927_lanes = c4 * t785_lanes - s4 * (s5 * t765_lanes - c5 * t752_lanes);
  const Lanes<2> t929_lanes = t920_lanes + minus_link5_to_6_y * t894_lanes;
  const Lanes<2> t931_lanes = c4 * t890_lanes - s4 * (s5 * t857_lanes - c5 * t851_lanes);
  const Lanes<2> t932_lanes = s4 * t894_lanes - c4 * (c5 * t874_lanes + s5 * t893_lanes);

  // links 3 (hip) and 5 (chest2), composite inertia
  const Real M_1_1 = J_2_zz + (M_2_2 - 2.0 * t258);
  M[25] = M_1_1;
  const Real M_2_3 = (J_4_xz - (c5 * t424 - t367)) * s4 - (c4 * M_3_4 + link4_to_5_z * t235);
  M[51] = M_2_3;
  M[74] = M_2_3;

  // links 5 (chest2) and 6 (chest3), mass matrix
  const Real M_2_4 = c4 * M_4_4 - s4 * t416 - link4_to_5_z * t240;
  M[52] = M_2_4;
  M[98] = M_2_4;
  const Real M_2_5 = c4 * M_4_5 - s4 * (s5 * t348 - c5 * t328) + link4_to_5_z * t264;
  M[53] = M_2_5;
  M[122] = M_2_5;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), mass matrix
  const Lanes<2> t934_lanes = t811_lanes - link4_to_5_z * t319_lanes;
  M[54] = t934_lanes[0];
  M[146] = t934_lanes[0];
  M[61] = t934_lanes[1];
  M[314] = t934_lanes[1];
  const Lanes<2> t935_lanes = t216 * t559_lanes - t215 *
      (s2_plus_3 * t319_lanes + c2_plus_3 * t293_lanes);

  // links 8, 15, 23 and 24, mass matrix
  const Lanes<2> t936_lanes = t812_lanes + link4_to_5_z * t379_lanes;
  M[55] = t936_lanes[0];
  M[170] = t936_lanes[0];
  M[62] = t936_lanes[1];
  M[338] = t936_lanes[1];
  const Lanes<2> t937_lanes = s6 * t919_lanes - c6 * t895_lanes;
  const Lanes<2> t942_lanes = t215 * (s2_plus_3 * t379_lanes - c2_plus_3 * t359_lanes) + t216 *
      t606_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), mass matrix
  const Lanes<2> t943_lanes = t924_lanes - link4_to_5_z * t429_lanes;
  M[56] = t943_lanes[0];
  M[194] = t943_lanes[0];
  M[63] = t943_lanes[1];
  M[362] = t943_lanes[1];
  const Lanes<2> t944_lanes = t215 * (c2_plus_3 * t422_lanes - s2_plus_3 * t429_lanes) - t216 *
      t623_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), mass matrix
  const Lanes<2> t945_lanes = t925_lanes + link4_to_5_z * t531_lanes;
  M[57] = t945_lanes[0];
  M[218] = t945_lanes[0];
  M[64] = t945_lanes[1];
  M[386] = t945_lanes[1];
  const Lanes<2> t946_lanes = t215 * (s2_plus_3 * t531_lanes - c2_plus_3 * t521_lanes) + t216 *
      t654_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), mass matrix
  const Lanes<2> t947_lanes = t926_lanes + link4_to_5_z * t632_lanes;
  M[58] = t947_lanes[0];
  M[242] = t947_lanes[0];
  M[65] = t947_lanes[1];
  M[410] = t947_lanes[1];
  const Lanes<2> t948_lanes = t215 * (s2_plus_3 * t632_lanes - c2_plus_3 * t615_lanes) + t216 *
      t659_lanes;

  // links 23 (left_eye) and 24 (right_eye), mass matrix
  const Lanes<2> t950_lanes = s6 * t895_lanes + c6 * t919_lanes + minus_link5_to_6_y * t874_lanes;
  M[118] = -t950_lanes[0];
  M[532] = -t950_lanes[0];
  M[119] = -t950_lanes[1];
  M[556] = -t950_lanes[1];

  // links 12, 19, 23 and 24, mass matrix
  const Lanes<2> t951_lanes = t927_lanes - link4_to_5_z * t767_lanes;
  M[59] = t951_lanes[0];
  M[266] = t951_lanes[0];
  M[66] = t951_lanes[1];
  M[434] = t951_lanes[1];
  const Lanes<2> t952_lanes = t215 * (c2_plus_3 * t744_lanes - s2_plus_3 * t767_lanes) - t216 *
      t795_lanes;
  const Lanes<2> t954_lanes = c2_plus_3 * t932_lanes + s2_plus_3 * t915_lanes;

  // links 13 (left_hand) and 20 (right_hand), mass matrix
  const Lanes<2> t955_lanes = t931_lanes + link4_to_5_z * t865_lanes;
  M[60] = t955_lanes[0];
  M[290] = t955_lanes[0];
  M[67] = t955_lanes[1];
  M[458] = t955_lanes[1];
  const Lanes<2> t956_lanes = t215 * (s2_plus_3 * t865_lanes - c2_plus_3 * t853_lanes) + t216 *
      t909_lanes;

  // links 21 (neck) and 22 (head), mass matrix
  const Real M_2_20 = link4_to_5_z * t846 + (s4 * (s5 * t826 + c5 * t827) + c4 * M_4_20);
  M[68] = -M_2_20;
  M[482] = -M_2_20;
  const Real M_2_21 = s4 * (c5 * t876 + s5 * t888) + c4 * M_4_21 + link4_to_5_z * t879;
  M[69] = -M_2_21;
  M[506] = -M_2_21;

  // links 3, 23 and 24, mass matrix
  const Lanes<2> t973_lanes = t215 * (s2_plus_3 * t932_lanes - c2_plus_3 * t915_lanes) + t216 *
      t954_lanes;
  const Lanes<2> t985_lanes = s4 * (s5 * t937_lanes - c5 * t929_lanes) + c4 * t950_lanes;
  const Real M_1_2 = M_2_2 - t258;
  M[26] = M_1_2;
  M[49] = M_1_2;

  // links 4 (chest1) and 5 (chest2), mass matrix
  const Real M_1_3 = M_2_3 - (t215 * (s2_plus_3 * t239) + t216 * t247);
  M[27] = M_1_3;
  M[73] = M_1_3;
  const Real M_1_4 = M_2_4 + (t216 * t252 - t215 * (s2_plus_3 * t240 + c2_plus_3 * t221));
  M[28] = M_1_4;
  M[97] = M_1_4;

  // links 6, 23 and 24, mass matrix
  const Real M_1_5 = M_2_5 + (t215 * (s2_plus_3 * t264 - c2_plus_3 * t257) + t216 * t289);
  M[29] = M_1_5;
  M[121] = M_1_5;
  const Lanes<2> t988_lanes = link4_to_5_z * t932_lanes - t985_lanes;
  M[70] = t988_lanes[0];
  M[530] = t988_lanes[0];
  M[71] = t988_lanes[1];
  M[554] = t988_lanes[1];

  // links 7 (left_shoulder1) and 14 (right_shoulder1), mass matrix
  const Lanes<2> t989_lanes = t934_lanes + t935_lanes;
  M[30] = t989_lanes[0];
  M[145] = t989_lanes[0];
  M[37] = t989_lanes[1];
  M[313] = t989_lanes[1];

  // links 8 (left_shoulder2) and 15 (right_shoulder2), mass matrix
  const Lanes<2> t990_lanes = t936_lanes + t942_lanes;
  M[31] = t990_lanes[0];
  M[169] = t990_lanes[0];
  M[38] = t990_lanes[1];
  M[337] = t990_lanes[1];

  // links 9 (left_upperarm) and 16 (right_upperarm), mass matrix
  const Lanes<2> t991_lanes = t943_lanes + t944_lanes;
  M[32] = t991_lanes[0];
  M[193] = t991_lanes[0];
  M[39] = t991_lanes[1];
  M[361] = t991_lanes[1];

  // links 10 (left_lowerarm) and 17 (right_lowerarm), mass matrix
  const Lanes<2> t992_lanes = t945_lanes + t946_lanes;
  M[33] = t992_lanes[0];
  M[217] = t992_lanes[0];
  M[40] = t992_lanes[1];
  M[385] = t992_lanes[1];

  // links 11 (left_wrist1) and 18 (right_wrist1), mass matrix
  const Lanes<2> t993_lanes = t947_lanes + t948_lanes;
  M[34] = t993_lanes[0];
  M[241] = t993_lanes[0];
  M[41] = t993_lanes[1];
  M[409] = t993_lanes[1];

  // links 12 (left_wrist2) and 19 (right_wrist2), mass matrix
  const Lanes<2> t994_lanes = t951_lanes + t952_lanes;
  M[35] = t994_lanes[0];
  M[265] = t994_lanes[0];
  M[42] = t994_lanes[1];
  M[433] = t994_lanes[1];

  // links 13 (left_hand) and 20 (right_hand), mass matrix
  const Lanes<2> t995_lanes = t955_lanes + t956_lanes;
  M[36] = t995_lanes[0];
  M[289] = t995_lanes[0];
  M[43] = t995_lanes[1];
  M[457] = t995_lanes[1];

  // links 21 (neck) and 22 (head), mass matrix
  const Real M_1_20 = t216 * t910 - t215 * (s2_plus_3 * t846 + c2_plus_3 * t845) - M_2_20;
  M[44] = M_1_20;
  M[481] = M_1_20;
  const Real M_1_21 = t216 * t914 + t215 * (s2_plus_3 * t879 - c2_plus_3 * t860) + M_2_21;
  M[45] = -M_1_21;
  M[505] = -M_1_21;

  // link 2 (thigh), composite inertia; links 23 (left_eye) and 24 (right_eye), mass matrix
  M[0] = J_1_zz + (M_1_1 - 0.868 * t253);
  const Lanes<2> t996_lanes = t988_lanes + t973_lanes;
  M[46] = t996_lanes[0];
  M[529] = t996_lanes[0];
  M[47] = t996_lanes[1];
  M[553] = t996_lanes[1];

  // links 2 (thigh) and 3 (hip), mass matrix
  const Real M_0_1 = M_1_1 - minus_link1_to_2_y * t253;
  M[1] = M_0_1;
  M[24] = M_0_1;
  const Real M_0_2 = M_1_2 - minus_link1_to_2_y * t246;
  M[2] = M_0_2;
  M[48] = M_0_2;

  // links 4 (chest1) and 5 (chest2), mass matrix
  const Real M_0_3 = M_1_3 - minus_link1_to_2_y * t247;
  M[3] = M_0_3;
  M[72] = M_0_3;
  const Real M_0_4 = M_1_4 + minus_link1_to_2_y * t252;
  M[4] = M_0_4;
  M[96] = M_0_4;

  // links 6 and 7, 14, mass matrix
  const Real M_0_5 = M_1_5 + minus_link1_to_2_y * t289;
  M[5] = M_0_5;
  M[120] = M_0_5;
  const Lanes<2> t997_lanes = t989_lanes + minus_link1_to_2_y * t559_lanes;
  M[6] = t997_lanes[0];
  M[144] = t997_lanes[0];
  M[13] = t997_lanes[1];
  M[312] = t997_lanes[1];

  // links 8 (left_shoulder2) and 15 (right_shoulder2), mass matrix
  const Lanes<2> t998_lanes = t990_lanes + minus_link1_to_2_y * t606_lanes;
  M[7] = t998_lanes[0];
  M[168] = t998_lanes[0];
  M[14] = t998_lanes[1];
  M[336] = t998_lanes[1];

  // links 9 (left_upperarm) and 16 (right_upperarm), mass matrix
  const Lanes<2> t999_lanes = t991_lanes - minus_link1_to_2_y * t623_lanes;
  M[8] = t999_lanes[0];
  M[192] = t999_lanes[0];
  M[15] = t999_lanes[1];
  M[360] = t999_lanes[1];

  // links 10 (left_lowerarm) and 17 (right_lowerarm), mass matrix
  const Lanes<2> t1000_lanes = t992_lanes + minus_link1_to_2_y * t654_lanes;
  M[9] = t1000_lanes[0];
  M[216] = t1000_lanes[0];
  M[16] = t1000_lanes[1];
  M[384] = t1000_lanes[1];

  // links 11 (left_wrist1) and 18 (right_wrist1), mass matrix
  const Lanes<2> t1001_lanes = t993_lanes + minus_link1_to_2_y * t659_lanes;
  M[10] = t1001_lanes[0];
  M[240] = t1001_lanes[0];
  M[17] = t1001_lanes[1];
  M[408] = t1001_lanes[1];

  // links 12 (left_wrist2) and 19 (right_wrist2), mass matrix
  const Lanes<2> t1002_lanes = t994_lanes - minus_link1_to_2_y * t795_lanes;
  M[11] = t1002_lanes[0];
  M[264] = t1002_lanes[0];
  M[18] = t1002_lanes[1];
  M[432] = t1002_lanes[1];

  // links 13 (left_hand) and 20 (right_hand), mass matrix
  const Lanes<2> t1003_lanes = t995_lanes + minus_link1_to_2_y * t909_lanes;
  M[12] = t1003_lanes[0];
  M[288] = t1003_lanes[0];
  M[19] = t1003_lanes[1];
  M[456] = t1003_lanes[1];

  // links 21 (neck) and 22 (head), mass matrix
  const Real M_0_20 = M_1_20 + minus_link1_to_2_y * t910;
  M[20] = M_0_20;
  M[480] = M_0_20;
  const Real M_0_21 = M_1_21 + minus_link1_to_2_y * t914;
  M[21] = -M_0_21;
  M[504] = -M_0_21;

  // links 23 (left_eye) and 24 (right_eye), mass matrix; link 5 (chest2), composite inertia
  const Lanes<2> t1004_lanes = t996_lanes + minus_link1_to_2_y * t954_lanes;
  M[22] = t1004_lanes[0];
  M[528] = t1004_lanes[0];
  M[23] = t1004_lanes[1];
  M[552] = t1004_lanes[1];
  M[75] = J_4_zz + (t391 + t434);

  // links 6 and 7, 14, mass matrix
  const Real M_3_5 = s5 * t328 + c5 * t348;
  M[77] = -M_3_5;
  M[123] = -M_3_5;
  const Lanes<2> t1005_lanes = s5 * t285_lanes + c5 * t297_lanes;
  M[78] = -t1005_lanes[0];
  M[147] = -t1005_lanes[0];
  M[85] = -t1005_lanes[1];
  M[315] = -t1005_lanes[1];

  // links 8 (left_shoulder2) and 15 (right_shoulder2), mass matrix
  const Lanes<2> t1006_lanes = s5 * t354_lanes + c5 * t346_lanes;
  M[79] = -t1006_lanes[0];
  M[171] = -t1006_lanes[0];
  M[86] = -t1006_lanes[1];
  M[339] = -t1006_lanes[1];

  // links 9 (left_upperarm) and 16 (right_upperarm), mass matrix
  const Lanes<2> t1007_lanes = s5 * t411_lanes + c5 * t410_lanes;
  M[80] = -t1007_lanes[0];
  M[195] = -t1007_lanes[0];
  M[87] = -t1007_lanes[1];
  M[363] = -t1007_lanes[1];

  // links 10 (left_lowerarm) and 17 (right_lowerarm), mass matrix
  const Lanes<2> t1008_lanes = c5 * t518_lanes - s5 * t520_lanes;
  M[81] = t1008_lanes[0];
  M[219] = t1008_lanes[0];
  M[88] = t1008_lanes[1];
  M[387] = t1008_lanes[1];

  // links 11 (left_wrist1) and 18 (right_wrist1), mass matrix
  const Lanes<2> t1009_lanes = c5 * t617_lanes - s5 * t614_lanes;
  M[82] = t1009_lanes[0];
  M[243] = t1009_lanes[0];
  M[89] = t1009_lanes[1];
  M[411] = t1009_lanes[1];

  // links 12 (left_wrist2) and 19 (right_wrist2), mass matrix
  const Lanes<2> t1010_lanes = s5 * t752_lanes + c5 * t765_lanes;
  M[83] = -t1010_lanes[0];
  M[267] = -t1010_lanes[0];
  M[90] = -t1010_lanes[1];
  M[435] = -t1010_lanes[1];

  // links 13 (left_hand) and 20 (right_hand), mass matrix
  const Lanes<2> t1011_lanes = s5 * t851_lanes + c5 * t857_lanes;
  M[84] = -t1011_lanes[0];
  M[291] = -t1011_lanes[0];
  M[91] = -t1011_lanes[1];
  M[459] = -t1011_lanes[1];

  // links 21 (neck) and 22 (head), mass matrix
  const Real M_3_20 = c5 * t826 - s5 * t827;
  M[92] = -M_3_20;
  M[483] = -M_3_20;
  const Real M_3_21 = s5 * t876 - c5 * t888;
  M[93] = M_3_21;
  M[507] = M_3_21;

  // links 23 (left_eye) and 24 (right_eye), mass matrix
  const Lanes<2> t1012_lanes = s5 * t929_lanes + c5 * t937_lanes;
  M[94] = -t1012_lanes[0];
  M[531] = -t1012_lanes[0];
  M[95] = -t1012_lanes[1];
  M[555] = -t1012_lanes[1];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
