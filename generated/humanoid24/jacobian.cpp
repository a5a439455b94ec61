// SPDX-License-Identifier: 0BSD
// jacobian: xd = J qd, rows stacked over operational points
// By from the poses of all links, alike limbs in lanes.
// 530 flops (add 190, mul 340, div 0), sine and cosine of 20 angles
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
void jacobian(const Real (&TREELINE_RESTRICT q)[24], Real (&TREELINE_RESTRICT J)[288]) noexcept {
  J[13] = 0.0;
  J[14] = 0.0;
  J[15] = 0.0;
  J[16] = 0.0;
  J[17] = 0.0;
  J[18] = 0.0;
  J[19] = 0.0;
  J[20] = 0.0;
  J[21] = 0.0;
  J[22] = 0.0;
  J[23] = 0.0;
  J[24] = 0.0;
  J[25] = 0.0;
  J[26] = 0.0;
  J[37] = 0.0;
  J[38] = 0.0;
  J[39] = 0.0;
  J[40] = 0.0;
  J[41] = 0.0;
  J[42] = 0.0;
  J[43] = 0.0;
  J[44] = 0.0;
  J[45] = 0.0;
  J[46] = 0.0;
  J[47] = 0.0;
  J[61] = 0.0;
  J[62] = 0.0;
  J[63] = 0.0;
  J[64] = 0.0;
  J[65] = 0.0;
  J[66] = 0.0;
  J[67] = 0.0;
  J[68] = 0.0;
  J[69] = 0.0;
  J[70] = 0.0;
  J[71] = 0.0;
  J[72] = 0.0;
  J[73] = 0.0;
  J[74] = 0.0;
  J[85] = 0.0;
  J[86] = 0.0;
  J[87] = 0.0;
  J[88] = 0.0;
  J[89] = 0.0;
  J[90] = 0.0;
  J[91] = 0.0;
  J[92] = 0.0;
  J[93] = 0.0;
  J[94] = 0.0;
  J[95] = 0.0;
  J[99] = 0.0;
  J[109] = 0.0;
  J[110] = 0.0;
  J[111] = 0.0;
  J[112] = 0.0;
  J[113] = 0.0;
  J[114] = 0.0;
  J[115] = 0.0;
  J[116] = 0.0;
  J[117] = 0.0;
  J[118] = 0.0;
  J[119] = 0.0;
  J[120] = 0.0;
  J[121] = 0.0;
  J[122] = 0.0;
  J[133] = 0.0;
  J[134] = 0.0;
  J[135] = 0.0;
  J[136] = 0.0;
  J[137] = 0.0;
  J[138] = 0.0;
  J[139] = 0.0;
  J[140] = 0.0;
  J[141] = 0.0;
  J[142] = 0.0;
  J[143] = 0.0;
  J[150] = 0.0;
  J[151] = 0.0;
  J[152] = 0.0;
  J[153] = 0.0;
  J[154] = 0.0;
  J[155] = 0.0;
  J[156] = 0.0;
  J[164] = 0.0;
  J[165] = 0.0;
  J[166] = 0.0;
  J[167] = 0.0;
  J[168] = 0.0;
  J[169] = 0.0;
  J[170] = 0.0;
  J[174] = 0.0;
  J[175] = 0.0;
  J[176] = 0.0;
  J[177] = 0.0;
  J[178] = 0.0;
  J[179] = 0.0;
  J[180] = 0.0;
  J[188] = 0.0;
  J[189] = 0.0;
  J[190] = 0.0;
  J[191] = 0.0;
  J[198] = 0.0;
  J[199] = 0.0;
  J[200] = 0.0;
  J[201] = 0.0;
  J[202] = 0.0;
  J[203] = 0.0;
  J[204] = 0.0;
  J[212] = 0.0;
  J[213] = 0.0;
  J[214] = 0.0;
  J[215] = 0.0;
  J[216] = 0.0;
  J[217] = 0.0;
  J[218] = 0.0;
  J[222] = 0.0;
  J[223] = 0.0;
  J[224] = 0.0;
  J[225] = 0.0;
  J[226] = 0.0;
  J[227] = 0.0;
  J[228] = 0.0;
  J[236] = 0.0;
  J[237] = 0.0;
  J[238] = 0.0;
  J[239] = 0.0;
  J[243] = 0.0;
  J[246] = 0.0;
  J[247] = 0.0;
  J[248] = 0.0;
  J[249] = 0.0;
  J[250] = 0.0;
  J[251] = 0.0;
  J[252] = 0.0;
  J[260] = 0.0;
  J[261] = 0.0;
  J[262] = 0.0;
  J[263] = 0.0;
  J[264] = 0.0;
  J[265] = 0.0;
  J[266] = 0.0;
  J[270] = 0.0;
  J[271] = 0.0;
  J[272] = 0.0;
  J[273] = 0.0;
  J[274] = 0.0;
  J[275] = 0.0;
  J[276] = 0.0;
  J[284] = 0.0;
  J[285] = 0.0;
  J[286] = 0.0;
  J[287] = 0.0;

  // constants; sines and cosines
  const Real minus_link5_to_6_y = 0.072;
  const Real link4_to_5_z = 0.21799999999999997;
  const Real minus_link2_to_3_y = 0.422;
  const Real minus_link1_to_2_y = 0.434;
  const Real angles[20] = {q[11], q[9], q[7], q[6], q[5], q[4], q[0], q[1], q[2], q[3], q[8], q[10],
      q[12], q[18], q[16], q[14], q[13], q[15], q[17], q[19]};

  // sines and cosines
  Real sines[20];
  Real cosines[20];
  detail::sin_cos(angles, sines, cosines);
  const Real c12 = cosines[0];
  const Real c10 = cosines[1];
  const Real c8 = cosines[2];
  const Real c7 = cosines[3];
  const Real c6 = cosines[4];
  const Real c5 = cosines[5];
  const Real s1 = sines[6];
  const Real s2 = sines[7];
  const Real c1 = cosines[6];
  const Real c2 = cosines[7];
  const Real c3 = cosines[8];
  const Real s3 = sines[8];
  const Real s5 = sines[5];
  const Real c4 = cosines[9];
  J[100] = c4;
  J[244] = c4;
  const Real s6 = sines[4];
  const Real s4 = sines[9];
  const Real s7 = sines[3];
  const Real s8 = sines[2];
  const Real s10 = sines[1];
  const Real c9 = cosines[10];
  const Real s9 = sines[10];
  const Real s12 = sines[0];
  const Real c11 = cosines[11];
  const Real s11 = sines[11];
  const Real c13 = cosines[12];
  const Real s13 = sines[12];
  const Real c19 = cosines[13];
  const Real c17 = cosines[14];
  const Real c15 = cosines[15];
  const Real c14 = cosines[16];
  const Real s14 = sines[16];
  const Real s15 = sines[15];
  const Real s17 = sines[14];
  const Real c16 = cosines[17];
  const Real s16 = sines[17];
  const Real s19 = sines[13];
  const Real c18 = cosines[18];
  const Real s18 = sines[18];
  const Real c20 = cosines[19];
  const Real s20 = sines[19];

  // link 5 (chest2), pose
  const Real t1 = s5 * s4;
  const Real J_4_5 = c5 * s4;
  J[101] = J_4_5;
  J[245] = J_4_5;
  const Lanes<2> t2_lanes = 0.086 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> t3_lanes = 0.086 * detail::make_pack<Real>(s13, s20);
  const Real t4 = minus_link1_to_2_y * c1;
  const Real minus_c1_plus_2 = s1 * s2 - c1 * c2;
  const Real s1_plus_2 = s1 * c2 + c1 * s2;

  // link 6 (chest3), pose
  const Real p6_y = minus_link5_to_6_y * t1;
  const Real t7 = minus_link2_to_3_y * minus_c1_plus_2;
  const Real t8 = s6 * c4 - c6 * t1;
  const Real J_4_6 = s6 * t1 + c6 * c4;
  J[102] = J_4_6;
  J[253] = J_4_6;
  const Real minus_c1_plus_2_plus_3 = minus_c1_plus_2 * c3 + s1_plus_2 * s3;
  J[123] = -minus_c1_plus_2_plus_3;
  J[267] = -minus_c1_plus_2_plus_3;
  const Real minus_s1_plus_2_plus_3 = minus_c1_plus_2 * s3 - s1_plus_2 * c3;
  J[75] = -minus_s1_plus_2_plus_3;
  J[219] = -minus_s1_plus_2_plus_3;

  // links 4 (chest1) and 7 (left_shoulder1), pose
  const Real t14 = 0.226 * t8;
  const Real t15 = c4 * minus_s1_plus_2_plus_3;
  const Real J_5_4 = s4 * minus_s1_plus_2_plus_3;
  J[124] = -J_5_4;
  J[268] = -J_5_4;

  // links 5, 7, 14, pose
  const Real t16 = link4_to_5_z * minus_c1_plus_2_plus_3;
  const Lanes<2> t17_lanes = detail::make_pack<Real>(c7, c14) * t8 -
      detail::make_pack<Real>(s7, s14) * J_4_5;
  const Lanes<2> t18_lanes = detail::make_pack<Real>(s7, s14) * t8 +
      detail::make_pack<Real>(c7, c14) * J_4_5;
  J[103] = t18_lanes[0];
  J[254] = t18_lanes[1];

  // links 4 (chest1) and 5 (chest2), pose
  const Real t20 = c4 * minus_c1_plus_2_plus_3;
  const Real J_3_4 = s4 * minus_c1_plus_2_plus_3;
  J[76] = J_3_4;
  J[220] = J_3_4;
  const Real t25 = c5 * minus_c1_plus_2_plus_3 - s5 * t15;
  const Real J_5_5 = c5 * t15 + s5 * minus_c1_plus_2_plus_3;
  J[125] = J_5_5;
  J[269] = J_5_5;

  // links 5, 8, 15, pose
  const Lanes<2> t26_lanes = detail::make_pack<Real>(c8, c15) * J_4_6 -
      detail::make_pack<Real>(s8, s15) * t17_lanes;
  const Lanes<2> t27_lanes = detail::make_pack<Real>(c8, c15) * t17_lanes +
      detail::make_pack<Real>(s8, s15) * J_4_6;
  J[104] = -t27_lanes[0];
  J[255] = -t27_lanes[1];
  const Real t28 = s5 * t20 + c5 * minus_s1_plus_2_plus_3;
  const Real J_3_5 = s5 * minus_s1_plus_2_plus_3 - c5 * t20;
  J[77] = J_3_5;
  J[221] = J_3_5;

  // link 6 (chest3), pose
  const Real t36 = minus_link5_to_6_y * t25;
  const Real t39 = c6 * t25 - s6 * J_5_4;
  const Real J_5_6 = s6 * t25 + c6 * J_5_4;
  J[126] = -J_5_6;
  J[277] = -J_5_6;

  // links 6, 9, 16, pose
  const Lanes<2> t40_lanes = detail::make_pack<Real>(s9, s16) * t26_lanes +
      detail::make_pack<Real>(c9, c16) * t18_lanes;
  const Lanes<2> t41_lanes = detail::make_pack<Real>(c9, c16) * t26_lanes -
      detail::make_pack<Real>(s9, s16) * t18_lanes;
  J[105] = t41_lanes[0];
  J[256] = t41_lanes[1];
  const Real t42 = c6 * t28 + s6 * J_3_4;
  const Real J_3_6 = c6 * J_3_4 - s6 * t28;
  J[78] = J_3_6;
  J[229] = J_3_6;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), pose
  const Real t51 = 0.226 * t39;
  const Lanes<2> t57_lanes = detail::make_pack<Real>(c7, c14) * t39 -
      detail::make_pack<Real>(s7, s14) * J_5_5;
  const Lanes<2> t58_lanes = detail::make_pack<Real>(s7, s14) * t39 +
      detail::make_pack<Real>(c7, c14) * J_5_5;
  J[127] = t58_lanes[0];
  J[278] = t58_lanes[1];
  const Real t60 = 0.226 * t42;

  // links 6, 10, 17, pose
  const Lanes<2> t61_lanes = detail::make_pack<Real>(c10, c17) * t40_lanes +
      detail::make_pack<Real>(s10, s17) * t27_lanes;
  const Lanes<2> t62_lanes = detail::make_pack<Real>(c10, c17) * t27_lanes -
      detail::make_pack<Real>(s10, s17) * t40_lanes;
  J[106] = -t62_lanes[0];
  J[257] = -t62_lanes[1];
  const Real t63 = minus_link5_to_6_y * t28;

  // links 5, 7, 14, pose
  const Real t64 = link4_to_5_z * minus_s1_plus_2_plus_3;
  const Lanes<2> t66_lanes = detail::make_pack<Real>(c7, c14) * t42 -
      detail::make_pack<Real>(s7, s14) * J_3_5;
  const Lanes<2> t68_lanes = detail::make_pack<Real>(s7, s14) * t42 +
      detail::make_pack<Real>(c7, c14) * J_3_5;
  J[79] = t68_lanes[0];
  J[230] = t68_lanes[1];

  // links 8, 11, 15, 18, pose
  const Lanes<2> t82_lanes = detail::make_pack<Real>(s8, s15) * t57_lanes +
      detail::make_pack<Real>(c8, c15) * J_5_6;
  const Lanes<2> t83_lanes = detail::make_pack<Real>(c8, c15) * t57_lanes -
      detail::make_pack<Real>(s8, s15) * J_5_6;
  J[128] = -t83_lanes[0];
  J[279] = -t83_lanes[1];
  const Lanes<2> t84_lanes = detail::make_pack<Real>(c11, c18) * t61_lanes +
      detail::make_pack<Real>(s11, s18) * t41_lanes;
  const Lanes<2> t85_lanes = detail::make_pack<Real>(c11, c18) * t41_lanes -
      detail::make_pack<Real>(s11, s18) * t61_lanes;
  J[107] = t85_lanes[0];
  J[258] = t85_lanes[1];

  // links 8 (left_shoulder2) and 15 (right_shoulder2), pose
  const Lanes<2> t86_lanes = detail::make_pack<Real>(c8, c15) * J_3_6 -
      detail::make_pack<Real>(s8, s15) * t66_lanes;
  const Lanes<2> t88_lanes = detail::make_pack<Real>(c8, c15) * t66_lanes +
      detail::make_pack<Real>(s8, s15) * J_3_6;
  J[80] = -t88_lanes[0];
  J[231] = -t88_lanes[1];
  const Real t96 = minus_link2_to_3_y * s1_plus_2;

  // links 9 (left_upperarm) and 16 (right_upperarm), pose
  const Real p2_x = minus_link1_to_2_y * s1;
  const Lanes<2> t101_lanes = detail::make_pack<Real>(c9, c16) * t58_lanes -
      detail::make_pack<Real>(s9, s16) * t82_lanes;
  const Lanes<2> t102_lanes = detail::make_pack<Real>(c9, c16) * t82_lanes +
      detail::make_pack<Real>(s9, s16) * t58_lanes;
  J[129] = -t102_lanes[0];
  J[280] = -t102_lanes[1];

  // links 9, 12, 16, 19, pose
  const Lanes<2> t105_lanes = detail::make_pack<Real>(c12, c19) * t84_lanes +
      detail::make_pack<Real>(s12, s19) * t62_lanes;
  J[108] = t105_lanes[0];
  J[259] = t105_lanes[1];
  const Lanes<2> t106_lanes = detail::make_pack<Real>(s9, s16) * t86_lanes +
      detail::make_pack<Real>(c9, c16) * t68_lanes;
  const Lanes<2> t108_lanes = detail::make_pack<Real>(c9, c16) * t86_lanes -
      detail::make_pack<Real>(s9, s16) * t68_lanes;
  J[81] = t108_lanes[0];
  J[232] = t108_lanes[1];

  // links 10, 17, 24, pose; link 1 (calf), Jacobian
  const Lanes<2> t117_lanes = detail::make_pack<Real>(c10, c17) * t101_lanes +
      detail::make_pack<Real>(s10, s17) * t83_lanes;
  const Lanes<2> t118_lanes = detail::make_pack<Real>(c10, c17) * t83_lanes -
      detail::make_pack<Real>(s10, s17) * t101_lanes;
  J[130] = -t118_lanes[0];
  J[281] = -t118_lanes[1];
  const Lanes<2> t119_lanes = (detail::make_pack<Real>(c12, c19) * t62_lanes -
      detail::make_pack<Real>(s12, s19) * t84_lanes) * t2_lanes + t85_lanes * t3_lanes;
  const Lanes<2> t120_lanes = detail::make_pack<Real>(c10, c17) * t106_lanes +
      detail::make_pack<Real>(s10, s17) * t88_lanes;
  const Lanes<2> t122_lanes = detail::make_pack<Real>(c10, c17) * t88_lanes -
      detail::make_pack<Real>(s10, s17) * t106_lanes;
  J[82] = -t122_lanes[0];
  J[233] = -t122_lanes[1];

  // links 12 (left_wrist2) and 19 (right_wrist2), Jacobian
  const Lanes<2> t126_lanes = t119_lanes + 0.269 * t62_lanes;
  J[96] = 1.0;
  J[97] = 1.0;
  J[98] = 1.0;
  J[240] = 1.0;
  J[241] = 1.0;
  J[242] = 1.0;

  // links 11 (left_wrist1) and 18 (right_wrist1), pose; links 10 (left_lowerarm) and 17
  //   (right_lowerarm), Jacobian
  const Lanes<2> t132_lanes = detail::make_pack<Real>(c11, c18) * t117_lanes -
      detail::make_pack<Real>(s11, s18) * t102_lanes;
  const Lanes<2> t133_lanes = detail::make_pack<Real>(s11, s18) * t117_lanes +
      detail::make_pack<Real>(c11, c18) * t102_lanes;
  J[131] = -t133_lanes[0];
  J[282] = -t133_lanes[1];
  const Lanes<2> t134_lanes = t126_lanes + 0.282 * t27_lanes;
  const Lanes<2> t140_lanes = detail::make_pack<Real>(c11, c18) * t120_lanes +
      detail::make_pack<Real>(s11, s18) * t108_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), pose; links 6 and 7, 14, Jacobian
  const Lanes<2> t142_lanes = detail::make_pack<Real>(c11, c18) * t108_lanes -
      detail::make_pack<Real>(s11, s18) * t120_lanes;
  J[83] = t142_lanes[0];
  J[234] = t142_lanes[1];
  const Lanes<2> t145_lanes = t134_lanes + (detail::make_pack<Real>(0.18, (-0.18)) * J_4_6 - t14);
  const Lanes<2> t157_lanes = t145_lanes + p6_y;

  // links 12 (left_wrist2) and 19 (right_wrist2), pose
  const Lanes<2> t160_lanes = detail::make_pack<Real>(c12, c19) * t132_lanes +
      detail::make_pack<Real>(s12, s19) * t118_lanes;
  J[132] = t160_lanes[0];
  J[283] = t160_lanes[1];
  const Lanes<2> t164_lanes = detail::make_pack<Real>(c12, c19) * t140_lanes +
      detail::make_pack<Real>(s12, s19) * t122_lanes;
  J[84] = t164_lanes[0];
  J[235] = t164_lanes[1];

  // link 4 (chest1), Jacobian
  const Lanes<2> J_0_6_3_lanes = minus_c1_plus_2_plus_3 * t157_lanes;
  J[3] = J_0_6_3_lanes[0];
  J[147] = J_0_6_3_lanes[1];
  const Lanes<2> J_2_8_3_lanes = minus_s1_plus_2_plus_3 * t157_lanes;
  J[51] = -J_2_8_3_lanes[0];
  J[195] = -J_2_8_3_lanes[1];

  // links 1, 10, 12, 17, 19, Jacobian; link 24 (right_eye), pose
  const Lanes<2> t170_lanes = (detail::make_pack<Real>(c12, c19) * t118_lanes -
      detail::make_pack<Real>(s12, s19) * t132_lanes) * t2_lanes - t133_lanes * t3_lanes;
  const Lanes<2> t171_lanes = (detail::make_pack<Real>(c12, c19) * t122_lanes -
      detail::make_pack<Real>(s12, s19) * t140_lanes) * t2_lanes + t142_lanes * t3_lanes;
  const Lanes<2> t172_lanes = t170_lanes + 0.269 * t118_lanes;
  const Lanes<2> t177_lanes = t171_lanes + 0.269 * t122_lanes;
  const Lanes<2> t178_lanes = t172_lanes + 0.282 * t83_lanes;

  // links 12 and 13, 19 and 20, Jacobian
  const Lanes<2> t187_lanes = t85_lanes * t170_lanes + t133_lanes * t119_lanes;
  J[11] = t187_lanes[0];
  J[162] = t187_lanes[1];
  const Lanes<2> t188_lanes = t105_lanes * t170_lanes - t160_lanes * t119_lanes;
  J[12] = t188_lanes[0];
  J[163] = t188_lanes[1];

  // links 6 and 7, 10, 14, 17, Jacobian
  const Lanes<2> t189_lanes = t177_lanes + 0.282 * t88_lanes;
  const Lanes<2> t190_lanes = t178_lanes - (t51 + detail::make_pack<Real>(0.18, (-0.18)) * J_5_6);
  const Lanes<2> t201_lanes = t189_lanes + (detail::make_pack<Real>(0.18, (-0.18)) * J_3_6 - t60);
  const Lanes<2> t202_lanes = t190_lanes - t36;
  const Lanes<2> t211_lanes = J_4_6 * t178_lanes + J_5_6 * t134_lanes;

  // links 7 and 8, 14 and 15, Jacobian
  J[6] = t211_lanes[0];
  J[157] = t211_lanes[1];
  const Lanes<2> t212_lanes = t18_lanes * t178_lanes - t58_lanes * t134_lanes;
  J[7] = t212_lanes[0];
  J[158] = t212_lanes[1];

  // links 5 (chest2) and 6 (chest3), Jacobian
  const Lanes<2> t213_lanes = t201_lanes - t63;
  const Lanes<2> J_0_6_2_lanes = t202_lanes - t16;
  J[2] = J_0_6_2_lanes[0];
  J[146] = J_0_6_2_lanes[1];
  const Lanes<2> J_0_6_5_lanes = J_4_5 * t190_lanes - J_5_5 * t145_lanes;
  J[5] = J_0_6_5_lanes[0];
  J[149] = J_0_6_5_lanes[1];

  // links 9 and 10, 16 and 17, Jacobian
  const Lanes<2> t218_lanes = t83_lanes * t134_lanes - t27_lanes * t178_lanes;
  J[8] = t218_lanes[0];
  J[159] = t218_lanes[1];
  const Lanes<2> t219_lanes = t41_lanes * t172_lanes + t102_lanes * t126_lanes;
  J[9] = t219_lanes[0];
  J[160] = t219_lanes[1];

  // links 7, 11, 14, 18, Jacobian
  const Lanes<2> t220_lanes = t118_lanes * t126_lanes - t62_lanes * t172_lanes;
  J[10] = t220_lanes[0];
  J[161] = t220_lanes[1];
  const Lanes<2> t221_lanes = J_5_6 * t189_lanes + J_3_6 * t178_lanes;
  J[30] = -t221_lanes[0];
  J[181] = -t221_lanes[1];

  // links 5, 8, 15, Jacobian
  const Lanes<2> t222_lanes = t58_lanes * t189_lanes - t68_lanes * t178_lanes;
  J[31] = t222_lanes[0];
  J[182] = t222_lanes[1];
  const Lanes<2> J_2_8_2_lanes = t213_lanes - t64;
  J[50] = -J_2_8_2_lanes[0];

  // links 3 (hip) and 5 (chest2), Jacobian
  J[194] = -J_2_8_2_lanes[1];
  const Lanes<2> J_0_6_1_lanes = J_0_6_2_lanes - t7;
  J[1] = J_0_6_1_lanes[0];
  J[145] = J_0_6_1_lanes[1];
  const Lanes<2> J_0_6_4_lanes = c4 * t202_lanes + J_5_4 * t157_lanes;
  J[4] = J_0_6_4_lanes[0];
  J[148] = J_0_6_4_lanes[1];

  // links 9 and 10, 16 and 17, Jacobian
  const Lanes<2> t226_lanes = t88_lanes * t178_lanes - t83_lanes * t189_lanes;
  J[32] = t226_lanes[0];
  J[183] = t226_lanes[1];
  const Lanes<2> t227_lanes = t102_lanes * t177_lanes + t108_lanes * t172_lanes;
  J[33] = -t227_lanes[0];
  J[184] = -t227_lanes[1];

  // links 6, 11, 18, Jacobian
  const Lanes<2> J_1_7_5_lanes = J_5_5 * t201_lanes - J_3_5 * t190_lanes;
  J[29] = J_1_7_5_lanes[0];
  J[173] = J_1_7_5_lanes[1];
  const Lanes<2> t228_lanes = t122_lanes * t172_lanes - t118_lanes * t177_lanes;
  J[34] = t228_lanes[0];
  J[185] = t228_lanes[1];

  // links 12 and 13, 19 and 20, Jacobian
  const Lanes<2> t229_lanes = t133_lanes * t171_lanes + t142_lanes * t170_lanes;
  J[35] = -t229_lanes[0];
  J[186] = -t229_lanes[1];
  const Lanes<2> t230_lanes = t160_lanes * t171_lanes - t164_lanes * t170_lanes;
  J[36] = t230_lanes[0];
  J[187] = t230_lanes[1];

  // links 3 (hip) and 6 (chest3), Jacobian
  const Lanes<2> J_2_8_1_lanes = J_2_8_2_lanes + t96;
  J[49] = -J_2_8_1_lanes[0];
  J[193] = -J_2_8_1_lanes[1];
  const Lanes<2> J_2_8_5_lanes = J_3_5 * t145_lanes - J_4_5 * t201_lanes;
  J[53] = J_2_8_5_lanes[0];
  J[197] = J_2_8_5_lanes[1];

  // links 2, 7, 14, Jacobian
  const Lanes<2> t232_lanes = J_3_6 * t134_lanes - J_4_6 * t189_lanes;
  J[54] = t232_lanes[0];
  J[205] = t232_lanes[1];
  const Lanes<2> J_0_6_0_lanes = J_0_6_1_lanes + t4;
  J[0] = J_0_6_0_lanes[0];
  J[144] = J_0_6_0_lanes[1];

  // link 5 (chest2), Jacobian
  const Lanes<2> J_1_7_4_lanes = J_5_4 * t213_lanes + J_3_4 * t202_lanes;
  J[28] = -J_1_7_4_lanes[0];
  J[172] = -J_1_7_4_lanes[1];
  const Lanes<2> J_2_8_4_lanes = J_3_4 * t157_lanes - c4 * t213_lanes;
  J[52] = J_2_8_4_lanes[0];
  J[196] = J_2_8_4_lanes[1];

  // links 8 and 9, 15 and 16, Jacobian
  const Lanes<2> t233_lanes = t68_lanes * t134_lanes - t18_lanes * t189_lanes;
  J[55] = t233_lanes[0];
  J[206] = t233_lanes[1];
  const Lanes<2> t234_lanes = t27_lanes * t189_lanes - t88_lanes * t134_lanes;
  J[56] = t234_lanes[0];
  J[207] = t234_lanes[1];

  // links 10 and 11, 17 and 18, Jacobian
  const Lanes<2> t235_lanes = t108_lanes * t126_lanes - t41_lanes * t177_lanes;
  J[57] = t235_lanes[0];
  J[208] = t235_lanes[1];
  const Lanes<2> t236_lanes = t62_lanes * t177_lanes - t122_lanes * t126_lanes;
  J[58] = t236_lanes[0];
  J[209] = t236_lanes[1];

  // links 2, 12, 19, Jacobian
  const Lanes<2> t237_lanes = t142_lanes * t119_lanes - t85_lanes * t171_lanes;
  J[59] = t237_lanes[0];
  J[210] = t237_lanes[1];
  const Lanes<2> J_2_8_0_lanes = J_2_8_1_lanes + p2_x;
  J[48] = -J_2_8_0_lanes[0];
  J[192] = -J_2_8_0_lanes[1];

  // links 4, 13, 20, Jacobian
  const Lanes<2> t238_lanes = t164_lanes * t119_lanes - t105_lanes * t171_lanes;
  J[60] = t238_lanes[0];
  J[211] = t238_lanes[1];
  const Lanes<2> J_1_7_3_lanes = minus_s1_plus_2_plus_3 * J_0_6_2_lanes - minus_c1_plus_2_plus_3 *
      J_2_8_2_lanes;
  J[27] = J_1_7_3_lanes[0];
  J[171] = J_1_7_3_lanes[1];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
