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
  const Real angles[20] = {q[11], q[9], q[7], q[6], q[5], q[4], q[0], q[1], q[2], q[3], q[8], q[10],
      q[12], q[18], q[16], q[14], q[13], q[15], q[17], q[19]};
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
  const Real J_0_4_p1 = s5 * s4;
  const Real J_4_5 = c5 * s4;
  J[101] = J_4_5;
  J[245] = J_4_5;
  const Lanes<2> J_0_4_p2_lanes = 0.086 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> J_0_4_p3_lanes = 0.086 * detail::make_pack<Real>(s13, s20);
  const Real J_0_0_p1 = 0.434 * c1;
  const Real J_5_3_p1 = s1 * s2 - c1 * c2;
  const Real J_5_3_p2 = s1 * c2 + c1 * s2;

  // link 6 (chest3), pose
  const Real p6_y = 0.072 * J_0_4_p1;
  const Real J_0_1_p1 = 0.422 * J_5_3_p1;
  const Real J_0_4_p5 = s6 * c4 - c6 * J_0_4_p1;
  const Real J_4_6 = s6 * J_0_4_p1 + c6 * c4;
  J[102] = J_4_6;
  J[253] = J_4_6;
  const Real J_5_3 = J_5_3_p1 * c3 + J_5_3_p2 * s3;
  J[123] = -J_5_3;
  J[267] = -J_5_3;
  const Real J_3_3 = J_5_3_p1 * s3 - J_5_3_p2 * c3;
  J[75] = -J_3_3;
  J[219] = -J_3_3;

  // link 7 (left_shoulder1), pose
  const Real J_0_4_p9 = 0.226 * J_0_4_p5;

  // link 4 (chest1), pose
  const Real J_0_2_p1 = c4 * J_3_3;
  const Real J_5_4 = s4 * J_3_3;
  J[124] = -J_5_4;
  J[268] = -J_5_4;

  // link 5 (chest2), pose
  const Real J_0_2_p2 = 0.21799999999999997 * J_5_3;

  // link 7 (left_shoulder1), pose
  const Lanes<2> J_0_4_p10_lanes = detail::make_pack<Real>(c7, c14) * J_0_4_p5 -
      detail::make_pack<Real>(s7, s14) * J_4_5;
  const Lanes<2> J_4_7_lanes = detail::make_pack<Real>(s7, s14) * J_0_4_p5 +
      detail::make_pack<Real>(c7, c14) * J_4_5;
  J[103] = J_4_7_lanes[0];

  // link 14 (right_shoulder1), pose
  J[254] = J_4_7_lanes[1];

  // link 4 (chest1), pose
  const Real J_2_2_p1 = c4 * J_5_3;
  const Real J_3_4 = s4 * J_5_3;
  J[76] = J_3_4;
  J[220] = J_3_4;

  // link 5 (chest2), pose
  const Real J_0_2_p3 = c5 * J_5_3 - s5 * J_0_2_p1;
  const Real J_5_5 = c5 * J_0_2_p1 + s5 * J_5_3;
  J[125] = J_5_5;
  J[269] = J_5_5;

  // link 8 (left_shoulder2), pose
  const Lanes<2> J_0_4_p14_lanes = detail::make_pack<Real>(c8, c15) * J_4_6 -
      detail::make_pack<Real>(s8, s15) * J_0_4_p10_lanes;
  const Lanes<2> J_4_8_lanes = detail::make_pack<Real>(c8, c15) * J_0_4_p10_lanes +
      detail::make_pack<Real>(s8, s15) * J_4_6;
  J[104] = -J_4_8_lanes[0];

  // link 15 (right_shoulder2), pose
  J[255] = -J_4_8_lanes[1];

  // link 5 (chest2), pose
  const Real J_2_2_p2 = s5 * J_2_2_p1 + c5 * J_3_3;
  const Real J_3_5 = s5 * J_3_3 - c5 * J_2_2_p1;
  J[77] = J_3_5;
  J[221] = J_3_5;

  // link 6 (chest3), pose
  const Real J_0_2_p5 = 0.072 * J_0_2_p3;
  const Real J_0_2_p6 = c6 * J_0_2_p3 - s6 * J_5_4;
  const Real J_5_6 = s6 * J_0_2_p3 + c6 * J_5_4;
  J[126] = -J_5_6;
  J[277] = -J_5_6;

  // link 9 (left_upperarm), pose
  const Lanes<2> J_0_4_p18_lanes = detail::make_pack<Real>(s9, s16) * J_0_4_p14_lanes +
      detail::make_pack<Real>(c9, c16) * J_4_7_lanes;
  const Lanes<2> J_4_9_lanes = detail::make_pack<Real>(c9, c16) * J_0_4_p14_lanes -
      detail::make_pack<Real>(s9, s16) * J_4_7_lanes;
  J[105] = J_4_9_lanes[0];

  // link 16 (right_upperarm), pose
  J[256] = J_4_9_lanes[1];

  // link 6 (chest3), pose
  const Real J_2_2_p4 = c6 * J_2_2_p2 + s6 * J_3_4;
  const Real J_3_6 = c6 * J_3_4 - s6 * J_2_2_p2;
  J[78] = J_3_6;
  J[229] = J_3_6;

  // link 7 (left_shoulder1), pose
  const Real J_0_2_p9 = 0.226 * J_0_2_p6;
  const Lanes<2> J_0_2_p11_lanes = detail::make_pack<Real>(c7, c14) * J_0_2_p6 -
      detail::make_pack<Real>(s7, s14) * J_5_5;
  const Lanes<2> J_5_7_lanes = detail::make_pack<Real>(s7, s14) * J_0_2_p6 +
      detail::make_pack<Real>(c7, c14) * J_5_5;
  J[127] = J_5_7_lanes[0];

  // link 14 (right_shoulder1), pose
  J[278] = J_5_7_lanes[1];

  // link 7 (left_shoulder1), pose
  const Real J_2_2_p8 = 0.226 * J_2_2_p4;

  // link 10 (left_lowerarm), pose
  const Lanes<2> J_0_4_p21_lanes = detail::make_pack<Real>(c10, c17) * J_0_4_p18_lanes +
      detail::make_pack<Real>(s10, s17) * J_4_8_lanes;
  const Lanes<2> J_4_10_lanes = detail::make_pack<Real>(c10, c17) * J_4_8_lanes -
      detail::make_pack<Real>(s10, s17) * J_0_4_p18_lanes;
  J[106] = -J_4_10_lanes[0];

  // link 17 (right_lowerarm), pose
  J[257] = -J_4_10_lanes[1];

  // link 6 (chest3), pose
  const Real J_2_2_p9 = 0.072 * J_2_2_p2;

  // link 5 (chest2), pose
  const Real J_2_2_p10 = 0.21799999999999997 * J_3_3;

  // link 7 (left_shoulder1), pose
  const Lanes<2> J_2_2_p11_lanes = detail::make_pack<Real>(c7, c14) * J_2_2_p4 -
      detail::make_pack<Real>(s7, s14) * J_3_5;
  const Lanes<2> J_3_7_lanes = detail::make_pack<Real>(s7, s14) * J_2_2_p4 +
      detail::make_pack<Real>(c7, c14) * J_3_5;
  J[79] = J_3_7_lanes[0];

  // link 14 (right_shoulder1), pose
  J[230] = J_3_7_lanes[1];

  // link 8 (left_shoulder2), pose
  const Lanes<2> J_0_2_p15_lanes = detail::make_pack<Real>(s8, s15) * J_0_2_p11_lanes +
      detail::make_pack<Real>(c8, c15) * J_5_6;
  const Lanes<2> J_5_8_lanes = detail::make_pack<Real>(c8, c15) * J_0_2_p11_lanes -
      detail::make_pack<Real>(s8, s15) * J_5_6;
  J[128] = -J_5_8_lanes[0];

  // link 15 (right_shoulder2), pose
  J[279] = -J_5_8_lanes[1];

  // link 11 (left_wrist1), pose
  const Lanes<2> J_0_4_p25_lanes = detail::make_pack<Real>(c11, c18) * J_0_4_p21_lanes +
      detail::make_pack<Real>(s11, s18) * J_4_9_lanes;
  const Lanes<2> J_4_11_lanes = detail::make_pack<Real>(c11, c18) * J_4_9_lanes -
      detail::make_pack<Real>(s11, s18) * J_0_4_p21_lanes;
  J[107] = J_4_11_lanes[0];

  // link 18 (right_wrist1), pose
  J[258] = J_4_11_lanes[1];

  // link 8 (left_shoulder2), pose
  const Lanes<2> J_2_2_p15_lanes = detail::make_pack<Real>(c8, c15) * J_3_6 -
      detail::make_pack<Real>(s8, s15) * J_2_2_p11_lanes;
  const Lanes<2> J_3_8_lanes = detail::make_pack<Real>(c8, c15) * J_2_2_p11_lanes +
      detail::make_pack<Real>(s8, s15) * J_3_6;
  J[80] = -J_3_8_lanes[0];

  // link 15 (right_shoulder2), pose
  J[231] = -J_3_8_lanes[1];
  const Real J_2_1_p1 = 0.422 * J_5_3_p2;
  const Real p2_x = 0.434 * s1;

  // link 9 (left_upperarm), pose
  const Lanes<2> J_0_2_p19_lanes = detail::make_pack<Real>(c9, c16) * J_5_7_lanes -
      detail::make_pack<Real>(s9, s16) * J_0_2_p15_lanes;
  const Lanes<2> J_5_9_lanes = detail::make_pack<Real>(c9, c16) * J_0_2_p15_lanes +
      detail::make_pack<Real>(s9, s16) * J_5_7_lanes;
  J[129] = -J_5_9_lanes[0];

  // link 16 (right_upperarm), pose
  J[280] = -J_5_9_lanes[1];

  // link 12 (left_wrist2), pose
  const Lanes<2> J_4_12_lanes = detail::make_pack<Real>(c12, c19) * J_0_4_p25_lanes +
      detail::make_pack<Real>(s12, s19) * J_4_10_lanes;
  J[108] = J_4_12_lanes[0];

  // link 19 (right_wrist2), pose
  J[259] = J_4_12_lanes[1];

  // link 9 (left_upperarm), pose
  const Lanes<2> J_2_2_p19_lanes = detail::make_pack<Real>(s9, s16) * J_2_2_p15_lanes +
      detail::make_pack<Real>(c9, c16) * J_3_7_lanes;
  const Lanes<2> J_3_9_lanes = detail::make_pack<Real>(c9, c16) * J_2_2_p15_lanes -
      detail::make_pack<Real>(s9, s16) * J_3_7_lanes;
  J[81] = J_3_9_lanes[0];

  // link 16 (right_upperarm), pose
  J[232] = J_3_9_lanes[1];

  // link 10 (left_lowerarm), pose
  const Lanes<2> J_0_2_p22_lanes = detail::make_pack<Real>(c10, c17) * J_0_2_p19_lanes +
      detail::make_pack<Real>(s10, s17) * J_5_8_lanes;
  const Lanes<2> J_5_10_lanes = detail::make_pack<Real>(c10, c17) * J_5_8_lanes -
      detail::make_pack<Real>(s10, s17) * J_0_2_p19_lanes;
  J[130] = -J_5_10_lanes[0];

  // link 17 (right_lowerarm), pose
  J[281] = -J_5_10_lanes[1];

  // link 24 (right_eye), pose
  const Lanes<2> J_0_4_p30_lanes = (detail::make_pack<Real>(c12, c19) * J_4_10_lanes -
      detail::make_pack<Real>(s12, s19) * J_0_4_p25_lanes) * J_0_4_p2_lanes + J_4_11_lanes *
      J_0_4_p3_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<2> J_2_2_p22_lanes = detail::make_pack<Real>(c10, c17) * J_2_2_p19_lanes +
      detail::make_pack<Real>(s10, s17) * J_3_8_lanes;
  const Lanes<2> J_3_10_lanes = detail::make_pack<Real>(c10, c17) * J_3_8_lanes -
      detail::make_pack<Real>(s10, s17) * J_2_2_p19_lanes;
  J[82] = -J_3_10_lanes[0];

  // link 17 (right_lowerarm), pose
  J[233] = -J_3_10_lanes[1];

  // link 12 (left_wrist2), Jacobian
  const Lanes<2> J_0_4_p31_lanes = J_0_4_p30_lanes + 0.269 * J_4_10_lanes;

  // link 19 (right_wrist2), pose
  J[96] = 1.0;
  J[97] = 1.0;
  J[98] = 1.0;
  J[240] = 1.0;
  J[241] = 1.0;
  J[242] = 1.0;

  // link 11 (left_wrist1), pose
  const Lanes<2> J_0_2_p26_lanes = detail::make_pack<Real>(c11, c18) * J_0_2_p22_lanes -
      detail::make_pack<Real>(s11, s18) * J_5_9_lanes;
  const Lanes<2> J_5_11_lanes = detail::make_pack<Real>(s11, s18) * J_0_2_p22_lanes +
      detail::make_pack<Real>(c11, c18) * J_5_9_lanes;
  J[131] = -J_5_11_lanes[0];

  // link 18 (right_wrist1), pose
  J[282] = -J_5_11_lanes[1];

  // link 10 (left_lowerarm), Jacobian
  const Lanes<2> J_0_4_p32_lanes = J_0_4_p31_lanes + 0.282 * J_4_8_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> J_2_2_p26_lanes = detail::make_pack<Real>(c11, c18) * J_2_2_p22_lanes +
      detail::make_pack<Real>(s11, s18) * J_3_9_lanes;
  const Lanes<2> J_3_11_lanes = detail::make_pack<Real>(c11, c18) * J_3_9_lanes -
      detail::make_pack<Real>(s11, s18) * J_2_2_p22_lanes;
  J[83] = J_3_11_lanes[0];

  // link 18 (right_wrist1), pose
  J[234] = J_3_11_lanes[1];

  // link 7 (left_shoulder1), Jacobian
  const Lanes<2> J_0_4_p33_lanes = J_0_4_p32_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * J_4_6 - J_0_4_p9);

  // link 6 (chest3), Jacobian
  const Lanes<2> J_0_4_p34_lanes = J_0_4_p33_lanes + p6_y;

  // link 12 (left_wrist2), pose
  const Lanes<2> J_5_12_lanes = detail::make_pack<Real>(c12, c19) * J_0_2_p26_lanes +
      detail::make_pack<Real>(s12, s19) * J_5_10_lanes;
  J[132] = J_5_12_lanes[0];

  // link 19 (right_wrist2), pose
  J[283] = J_5_12_lanes[1];

  // link 12 (left_wrist2), pose
  const Lanes<2> J_3_12_lanes = detail::make_pack<Real>(c12, c19) * J_2_2_p26_lanes +
      detail::make_pack<Real>(s12, s19) * J_3_10_lanes;
  J[84] = J_3_12_lanes[0];

  // link 19 (right_wrist2), pose
  J[235] = J_3_12_lanes[1];

  // link 4 (chest1), Jacobian
  const Lanes<2> J_0_3_lanes = J_5_3 * J_0_4_p34_lanes;
  J[3] = J_0_3_lanes[0];
  J[147] = J_0_3_lanes[1];
  const Lanes<2> J_2_3_lanes = J_3_3 * J_0_4_p34_lanes;
  J[51] = -J_2_3_lanes[0];
  J[195] = -J_2_3_lanes[1];

  // link 24 (right_eye), pose
  const Lanes<2> J_0_2_p31_lanes = (detail::make_pack<Real>(c12, c19) * J_5_10_lanes -
      detail::make_pack<Real>(s12, s19) * J_0_2_p26_lanes) * J_0_4_p2_lanes - J_5_11_lanes *
      J_0_4_p3_lanes;
  const Lanes<2> J_2_2_p31_lanes = (detail::make_pack<Real>(c12, c19) * J_3_10_lanes -
      detail::make_pack<Real>(s12, s19) * J_2_2_p26_lanes) * J_0_4_p2_lanes + J_3_11_lanes *
      J_0_4_p3_lanes;

  // link 12 (left_wrist2), Jacobian
  const Lanes<2> J_0_2_p32_lanes = J_0_2_p31_lanes + 0.269 * J_5_10_lanes;
  const Lanes<2> J_2_2_p32_lanes = J_2_2_p31_lanes + 0.269 * J_3_10_lanes;

  // link 10 (left_lowerarm), Jacobian
  const Lanes<2> J_0_2_p33_lanes = J_0_2_p32_lanes + 0.282 * J_5_8_lanes;

  // link 12 (left_wrist2), Jacobian
  const Lanes<2> J_0_11_lanes = J_4_11_lanes * J_0_2_p31_lanes + J_5_11_lanes * J_0_4_p30_lanes;
  J[11] = J_0_11_lanes[0];

  // link 19 (right_wrist2), Jacobian
  J[162] = J_0_11_lanes[1];

  // link 13 (left_hand), Jacobian
  const Lanes<2> J_0_12_lanes = J_4_12_lanes * J_0_2_p31_lanes - J_5_12_lanes * J_0_4_p30_lanes;
  J[12] = J_0_12_lanes[0];

  // link 20 (right_hand), Jacobian
  J[163] = J_0_12_lanes[1];

  // link 10 (left_lowerarm), Jacobian
  const Lanes<2> J_2_2_p33_lanes = J_2_2_p32_lanes + 0.282 * J_3_8_lanes;

  // link 7 (left_shoulder1), Jacobian
  const Lanes<2> J_0_2_p34_lanes = J_0_2_p33_lanes -
      (J_0_2_p9 + detail::make_pack<Real>(0.18, (-0.18)) * J_5_6);
  const Lanes<2> J_2_2_p34_lanes = J_2_2_p33_lanes +
      (detail::make_pack<Real>(0.18, (-0.18)) * J_3_6 - J_2_2_p8);

  // link 6 (chest3), Jacobian
  const Lanes<2> J_0_2_p35_lanes = J_0_2_p34_lanes - J_0_2_p5;

  // link 7 (left_shoulder1), Jacobian
  const Lanes<2> J_0_6_lanes = J_4_6 * J_0_2_p33_lanes + J_5_6 * J_0_4_p32_lanes;
  J[6] = J_0_6_lanes[0];

  // link 14 (right_shoulder1), Jacobian
  J[157] = J_0_6_lanes[1];

  // link 8 (left_shoulder2), Jacobian
  const Lanes<2> J_0_7_lanes = J_4_7_lanes * J_0_2_p33_lanes - J_5_7_lanes * J_0_4_p32_lanes;
  J[7] = J_0_7_lanes[0];

  // link 15 (right_shoulder2), Jacobian
  J[158] = J_0_7_lanes[1];

  // link 6 (chest3), Jacobian
  const Lanes<2> J_2_2_p35_lanes = J_2_2_p34_lanes - J_2_2_p9;

  // link 5 (chest2), Jacobian
  const Lanes<2> J_0_2_lanes = J_0_2_p35_lanes - J_0_2_p2;
  J[2] = J_0_2_lanes[0];
  J[146] = J_0_2_lanes[1];

  // link 6 (chest3), Jacobian
  const Lanes<2> J_0_5_lanes = J_4_5 * J_0_2_p34_lanes - J_5_5 * J_0_4_p33_lanes;
  J[5] = J_0_5_lanes[0];
  J[149] = J_0_5_lanes[1];

  // link 9 (left_upperarm), Jacobian
  const Lanes<2> J_0_8_lanes = J_5_8_lanes * J_0_4_p32_lanes - J_4_8_lanes * J_0_2_p33_lanes;
  J[8] = J_0_8_lanes[0];

  // link 16 (right_upperarm), Jacobian
  J[159] = J_0_8_lanes[1];

  // link 10 (left_lowerarm), Jacobian
  const Lanes<2> J_0_9_lanes = J_4_9_lanes * J_0_2_p32_lanes + J_5_9_lanes * J_0_4_p31_lanes;
  J[9] = J_0_9_lanes[0];

  // link 17 (right_lowerarm), Jacobian
  J[160] = J_0_9_lanes[1];

  // link 11 (left_wrist1), Jacobian
  const Lanes<2> J_0_10_lanes = J_5_10_lanes * J_0_4_p31_lanes - J_4_10_lanes * J_0_2_p32_lanes;
  J[10] = J_0_10_lanes[0];

  // link 18 (right_wrist1), Jacobian
  J[161] = J_0_10_lanes[1];

  // link 7 (left_shoulder1), Jacobian
  const Lanes<2> J_1_6_lanes = J_5_6 * J_2_2_p33_lanes + J_3_6 * J_0_2_p33_lanes;
  J[30] = -J_1_6_lanes[0];

  // link 14 (right_shoulder1), Jacobian
  J[181] = -J_1_6_lanes[1];

  // link 8 (left_shoulder2), Jacobian
  const Lanes<2> J_1_7_lanes = J_5_7_lanes * J_2_2_p33_lanes - J_3_7_lanes * J_0_2_p33_lanes;
  J[31] = J_1_7_lanes[0];

  // link 15 (right_shoulder2), Jacobian
  J[182] = J_1_7_lanes[1];

  // link 5 (chest2), Jacobian
  const Lanes<2> J_2_2_lanes = J_2_2_p35_lanes - J_2_2_p10;
  J[50] = -J_2_2_lanes[0];
  J[194] = -J_2_2_lanes[1];

  // link 3 (hip), Jacobian
  const Lanes<2> J_0_1_lanes = J_0_2_lanes - J_0_1_p1;
  J[1] = J_0_1_lanes[0];
  J[145] = J_0_1_lanes[1];

  // link 5 (chest2), Jacobian
  const Lanes<2> J_0_4_lanes = c4 * J_0_2_p35_lanes + J_5_4 * J_0_4_p34_lanes;
  J[4] = J_0_4_lanes[0];
  J[148] = J_0_4_lanes[1];

  // link 9 (left_upperarm), Jacobian
  const Lanes<2> J_1_8_lanes = J_3_8_lanes * J_0_2_p33_lanes - J_5_8_lanes * J_2_2_p33_lanes;
  J[32] = J_1_8_lanes[0];

  // link 16 (right_upperarm), Jacobian
  J[183] = J_1_8_lanes[1];

  // link 10 (left_lowerarm), Jacobian
  const Lanes<2> J_1_9_lanes = J_5_9_lanes * J_2_2_p32_lanes + J_3_9_lanes * J_0_2_p32_lanes;
  J[33] = -J_1_9_lanes[0];

  // link 17 (right_lowerarm), Jacobian
  J[184] = -J_1_9_lanes[1];

  // link 6 (chest3), Jacobian
  const Lanes<2> J_1_5_lanes = J_5_5 * J_2_2_p34_lanes - J_3_5 * J_0_2_p34_lanes;
  J[29] = J_1_5_lanes[0];
  J[173] = J_1_5_lanes[1];

  // link 11 (left_wrist1), Jacobian
  const Lanes<2> J_1_10_lanes = J_3_10_lanes * J_0_2_p32_lanes - J_5_10_lanes * J_2_2_p32_lanes;
  J[34] = J_1_10_lanes[0];

  // link 18 (right_wrist1), Jacobian
  J[185] = J_1_10_lanes[1];

  // link 12 (left_wrist2), Jacobian
  const Lanes<2> J_1_11_lanes = J_5_11_lanes * J_2_2_p31_lanes + J_3_11_lanes * J_0_2_p31_lanes;
  J[35] = -J_1_11_lanes[0];

  // link 19 (right_wrist2), Jacobian
  J[186] = -J_1_11_lanes[1];

  // link 13 (left_hand), Jacobian
  const Lanes<2> J_1_12_lanes = J_5_12_lanes * J_2_2_p31_lanes - J_3_12_lanes * J_0_2_p31_lanes;
  J[36] = J_1_12_lanes[0];

  // link 20 (right_hand), Jacobian
  J[187] = J_1_12_lanes[1];

  // link 3 (hip), Jacobian
  const Lanes<2> J_2_1_lanes = J_2_2_lanes + J_2_1_p1;
  J[49] = -J_2_1_lanes[0];
  J[193] = -J_2_1_lanes[1];

  // link 6 (chest3), Jacobian
  const Lanes<2> J_2_5_lanes = J_3_5 * J_0_4_p33_lanes - J_4_5 * J_2_2_p34_lanes;
  J[53] = J_2_5_lanes[0];
  J[197] = J_2_5_lanes[1];

  // link 7 (left_shoulder1), Jacobian
  const Lanes<2> J_2_6_lanes = J_3_6 * J_0_4_p32_lanes - J_4_6 * J_2_2_p33_lanes;
  J[54] = J_2_6_lanes[0];

  // link 14 (right_shoulder1), Jacobian
  J[205] = J_2_6_lanes[1];

  // link 2 (thigh), Jacobian
  const Lanes<2> J_0_0_lanes = J_0_1_lanes + J_0_0_p1;
  J[0] = J_0_0_lanes[0];
  J[144] = J_0_0_lanes[1];

  // link 5 (chest2), Jacobian
  const Lanes<2> J_1_4_lanes = J_5_4 * J_2_2_p35_lanes + J_3_4 * J_0_2_p35_lanes;
  J[28] = -J_1_4_lanes[0];
  J[172] = -J_1_4_lanes[1];
  const Lanes<2> J_2_4_lanes = J_3_4 * J_0_4_p34_lanes - c4 * J_2_2_p35_lanes;
  J[52] = J_2_4_lanes[0];
  J[196] = J_2_4_lanes[1];

  // link 8 (left_shoulder2), Jacobian
  const Lanes<2> J_2_7_lanes = J_3_7_lanes * J_0_4_p32_lanes - J_4_7_lanes * J_2_2_p33_lanes;
  J[55] = J_2_7_lanes[0];

  // link 15 (right_shoulder2), Jacobian
  J[206] = J_2_7_lanes[1];

  // link 9 (left_upperarm), Jacobian
  const Lanes<2> J_2_8_lanes = J_4_8_lanes * J_2_2_p33_lanes - J_3_8_lanes * J_0_4_p32_lanes;
  J[56] = J_2_8_lanes[0];

  // link 16 (right_upperarm), Jacobian
  J[207] = J_2_8_lanes[1];

  // link 10 (left_lowerarm), Jacobian
  const Lanes<2> J_2_9_lanes = J_3_9_lanes * J_0_4_p31_lanes - J_4_9_lanes * J_2_2_p32_lanes;
  J[57] = J_2_9_lanes[0];

  // link 17 (right_lowerarm), Jacobian
  J[208] = J_2_9_lanes[1];

  // link 11 (left_wrist1), Jacobian
  const Lanes<2> J_2_10_lanes = J_4_10_lanes * J_2_2_p32_lanes - J_3_10_lanes * J_0_4_p31_lanes;
  J[58] = J_2_10_lanes[0];

  // link 18 (right_wrist1), Jacobian
  J[209] = J_2_10_lanes[1];

  // link 12 (left_wrist2), Jacobian
  const Lanes<2> J_2_11_lanes = J_3_11_lanes * J_0_4_p30_lanes - J_4_11_lanes * J_2_2_p31_lanes;
  J[59] = J_2_11_lanes[0];

  // link 19 (right_wrist2), Jacobian
  J[210] = J_2_11_lanes[1];

  // link 2 (thigh), Jacobian
  const Lanes<2> J_2_0_lanes = J_2_1_lanes + p2_x;
  J[48] = -J_2_0_lanes[0];
  J[192] = -J_2_0_lanes[1];

  // link 13 (left_hand), Jacobian
  const Lanes<2> J_2_12_lanes = J_3_12_lanes * J_0_4_p30_lanes - J_4_12_lanes * J_2_2_p31_lanes;
  J[60] = J_2_12_lanes[0];

  // link 20 (right_hand), Jacobian
  J[211] = J_2_12_lanes[1];

  // link 4 (chest1), Jacobian
  const Lanes<2> J_1_3_lanes = J_3_3 * J_0_2_lanes - J_5_3 * J_2_2_lanes;
  J[27] = J_1_3_lanes[0];
  J[171] = J_1_3_lanes[1];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
