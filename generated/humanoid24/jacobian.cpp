// jacobian: xd = J qd, rows stacked over operational points
// By from the poses of all links.
// 529 flops (add 190, mul 339, div 0), sine and cosine of 20 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

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
  const Real angles[20] = {q[12], q[11], q[9], q[7], q[6], q[5], q[4], q[2], q[1], q[0], q[3], q[8],
      q[10], q[19], q[18], q[16], q[14], q[13], q[15], q[17]};
  Real sines[20];
  Real cosines[20];
  detail::sin_cos(angles, sines, cosines);
  const Real c13 = cosines[0];
  const Real c12 = cosines[1];
  const Real c10 = cosines[2];
  const Real c8 = cosines[3];
  const Real c7 = cosines[4];
  const Real c6 = cosines[5];
  const Real c5 = cosines[6];
  const Real s3 = sines[7];
  const Real c2 = cosines[8];
  const Real s1 = sines[9];
  const Real s2 = sines[8];
  const Real c1 = cosines[9];
  const Real c3 = cosines[7];
  const Real s5 = sines[6];
  const Real c4 = cosines[10];
  J[100] = c4;
  J[244] = c4;
  const Real s6 = sines[5];
  const Real s4 = sines[10];
  const Real s7 = sines[4];
  const Real s8 = sines[3];
  const Real s10 = sines[2];
  const Real c9 = cosines[11];
  const Real s9 = sines[11];
  const Real s12 = sines[1];
  const Real c11 = cosines[12];
  const Real s11 = sines[12];
  const Real s13 = sines[0];
  const Real c20 = cosines[13];
  const Real c19 = cosines[14];
  const Real c17 = cosines[15];
  const Real c15 = cosines[16];
  const Real c14 = cosines[17];
  const Real s14 = sines[17];
  const Real s15 = sines[16];
  const Real s17 = sines[15];
  const Real c16 = cosines[18];
  const Real s16 = sines[18];
  const Real s19 = sines[14];
  const Real c18 = cosines[19];
  const Real s18 = sines[19];
  const Real s20 = sines[13];

  // link 2 (thigh), pose
  const Real J_5_3_p1 = c2 * s1 + s2 * c1;
  const Real J_5_3_p2 = s2 * s1 - c2 * c1;

  // link 3 (hip), pose
  const Real J_5_3 = s3 * J_5_3_p1 + c3 * J_5_3_p2;
  J[123] = -J_5_3;
  J[267] = -J_5_3;
  const Real J_3_3 = s3 * J_5_3_p2 - c3 * J_5_3_p1;
  J[75] = -J_3_3;
  J[219] = -J_3_3;

  // link 4 (chest1), pose
  const Real J_5_7_p1 = c4 * J_3_3;

  // link 5 (chest2), pose
  const Real J_5_7_p2 = c5 * J_5_3 - s5 * J_5_7_p1;

  // link 4 (chest1), pose
  const Real J_5_4 = s4 * J_3_3;
  J[124] = -J_5_4;
  J[268] = -J_5_4;

  // link 6 (chest3), pose
  const Real J_5_7_p3 = c6 * J_5_7_p2 - s6 * J_5_4;

  // link 5 (chest2), pose
  const Real J_5_5 = c5 * J_5_7_p1 + s5 * J_5_3;
  J[125] = J_5_5;
  J[269] = J_5_5;

  // link 7 (left_shoulder1), pose
  const Real J_5_7 = s7 * J_5_7_p3 + c7 * J_5_5;
  J[127] = J_5_7;
  const Real J_0_2_p1 = c7 * J_5_7_p3 - s7 * J_5_5;

  // link 6 (chest3), pose
  const Real J_5_6 = s6 * J_5_7_p2 + c6 * J_5_4;
  J[126] = -J_5_6;
  J[277] = -J_5_6;

  // link 8 (left_shoulder2), pose
  const Real J_0_2_p2 = s8 * J_0_2_p1 + c8 * J_5_6;

  // link 9 (left_upperarm), pose
  const Real J_0_2_p3 = c9 * J_5_7 - s9 * J_0_2_p2;

  // link 8 (left_shoulder2), pose
  const Real J_5_8 = c8 * J_0_2_p1 - s8 * J_5_6;
  J[128] = -J_5_8;

  // link 10 (left_lowerarm), pose
  const Real J_0_2_p4 = c10 * J_0_2_p3 + s10 * J_5_8;

  // link 9 (left_upperarm), pose
  const Real J_5_9 = c9 * J_0_2_p2 + s9 * J_5_7;
  J[129] = -J_5_9;

  // link 11 (left_wrist1), pose
  const Real J_0_2_p5 = c11 * J_0_2_p4 - s11 * J_5_9;

  // link 10 (left_lowerarm), pose
  const Real J_5_10 = c10 * J_5_8 - s10 * J_0_2_p3;
  J[130] = -J_5_10;

  // link 11 (left_wrist1), pose
  const Real J_5_11 = s11 * J_0_2_p4 + c11 * J_5_9;
  J[131] = -J_5_11;

  // link 24 (right_eye), pose
  const Real J_0_2_p6 = 0.086 * (c13 * (c12 * J_5_10 - s12 * J_0_2_p5) - s13 * J_5_11);

  // link 12 (left_wrist2), Jacobian
  const Real J_0_2_p7 = J_0_2_p6 + 0.269 * J_5_10;

  // link 10 (left_lowerarm), Jacobian
  const Real J_0_2_p8 = J_0_2_p7 + 0.282 * J_5_8;

  // link 7 (left_shoulder1), pose
  const Real J_0_2_p9 = 0.226 * J_5_7_p3;
  const Real J_0_2_p10 = 0.18 * J_5_6;

  // link 7 (left_shoulder1), Jacobian
  const Real J_0_2_p11 = J_0_2_p8 - (J_0_2_p9 + J_0_2_p10);

  // link 6 (chest3), pose
  const Real J_0_2_p12 = 0.072 * J_5_7_p2;

  // link 6 (chest3), Jacobian
  const Real J_0_2_p13 = J_0_2_p11 - J_0_2_p12;

  // link 5 (chest2), pose
  const Real J_0_2_p14 = 0.21799999999999997 * J_5_3;

  // link 5 (chest2), Jacobian
  const Real J_0_2 = J_0_2_p13 - J_0_2_p14;
  J[2] = J_0_2;

  // link 3 (hip), pose
  const Real J_0_1_p1 = 0.422 * J_5_3_p2;

  // link 3 (hip), Jacobian
  const Real J_0_1 = J_0_2 - J_0_1_p1;
  J[1] = J_0_1;

  // link 2 (thigh), pose
  const Real J_0_0_p1 = 0.434 * c1;

  // link 2 (thigh), Jacobian
  J[0] = J_0_1 + J_0_0_p1;

  // link 5 (chest2), pose
  const Real J_4_8_p1 = s5 * s4;

  // link 6 (chest3), pose
  const Real J_4_8_p2 = s6 * c4 - c6 * J_4_8_p1;

  // link 5 (chest2), pose
  const Real J_4_5 = c5 * s4;
  J[101] = J_4_5;
  J[245] = J_4_5;

  // link 7 (left_shoulder1), pose
  const Real J_4_8_p3 = c7 * J_4_8_p2 - s7 * J_4_5;

  // link 6 (chest3), pose
  const Real J_4_6 = s6 * J_4_8_p1 + c6 * c4;
  J[102] = J_4_6;
  J[253] = J_4_6;

  // link 8 (left_shoulder2), pose
  const Real J_4_8 = c8 * J_4_8_p3 + s8 * J_4_6;
  J[104] = -J_4_8;
  const Real J_4_10_p1 = c8 * J_4_6 - s8 * J_4_8_p3;

  // link 7 (left_shoulder1), pose
  const Real J_4_7 = s7 * J_4_8_p2 + c7 * J_4_5;
  J[103] = J_4_7;

  // link 9 (left_upperarm), pose
  const Real J_4_10_p2 = s9 * J_4_10_p1 + c9 * J_4_7;

  // link 10 (left_lowerarm), pose
  const Real J_4_10 = c10 * J_4_8 - s10 * J_4_10_p2;
  J[106] = -J_4_10;
  const Real J_0_3_p1 = c10 * J_4_10_p2 + s10 * J_4_8;

  // link 9 (left_upperarm), pose
  const Real J_4_9 = c9 * J_4_10_p1 - s9 * J_4_7;
  J[105] = J_4_9;

  // link 11 (left_wrist1), pose
  const Real J_0_3_p2 = c11 * J_0_3_p1 + s11 * J_4_9;
  const Real J_4_11 = c11 * J_4_9 - s11 * J_0_3_p1;
  J[107] = J_4_11;

  // link 24 (right_eye), pose
  const Real J_0_3_p3 = 0.086 * (c13 * (c12 * J_4_10 - s12 * J_0_3_p2) + s13 * J_4_11);

  // link 12 (left_wrist2), Jacobian
  const Real J_0_3_p4 = J_0_3_p3 + 0.269 * J_4_10;

  // link 10 (left_lowerarm), Jacobian
  const Real J_0_3_p5 = J_0_3_p4 + 0.282 * J_4_8;

  // link 7 (left_shoulder1), pose
  const Real J_0_3_p6 = 0.18 * J_4_6;
  const Real J_0_3_p7 = 0.226 * J_4_8_p2;

  // link 7 (left_shoulder1), Jacobian
  const Real J_0_3_p8 = J_0_3_p5 + (J_0_3_p6 - J_0_3_p7);

  // link 6 (chest3), pose
  const Real p6_y = 0.072 * J_4_8_p1;

  // link 6 (chest3), Jacobian
  const Real J_0_3_p9 = J_0_3_p8 + p6_y;

  // link 4 (chest1), Jacobian
  J[3] = J_5_3 * J_0_3_p9;

  // link 5 (chest2), Jacobian
  J[4] = c4 * J_0_2_p13 + J_5_4 * J_0_3_p9;

  // link 6 (chest3), Jacobian
  J[5] = J_4_5 * J_0_2_p11 - J_5_5 * J_0_3_p8;

  // link 7 (left_shoulder1), Jacobian
  J[6] = J_4_6 * J_0_2_p8 + J_5_6 * J_0_3_p5;

  // link 8 (left_shoulder2), Jacobian
  J[7] = J_4_7 * J_0_2_p8 - J_5_7 * J_0_3_p5;

  // link 9 (left_upperarm), Jacobian
  J[8] = J_5_8 * J_0_3_p5 - J_4_8 * J_0_2_p8;

  // link 10 (left_lowerarm), Jacobian
  J[9] = J_4_9 * J_0_2_p7 + J_5_9 * J_0_3_p4;

  // link 11 (left_wrist1), Jacobian
  J[10] = J_5_10 * J_0_3_p4 - J_4_10 * J_0_2_p7;

  // link 12 (left_wrist2), Jacobian
  J[11] = J_4_11 * J_0_2_p6 + J_5_11 * J_0_3_p3;

  // link 12 (left_wrist2), pose
  const Real J_4_12 = c12 * J_0_3_p2 + s12 * J_4_10;
  J[108] = J_4_12;
  const Real J_5_12 = c12 * J_0_2_p5 + s12 * J_5_10;
  J[132] = J_5_12;

  // link 13 (left_hand), Jacobian
  J[12] = J_4_12 * J_0_2_p6 - J_5_12 * J_0_3_p3;

  // link 4 (chest1), pose
  const Real J_3_5_p1 = c4 * J_5_3;

  // link 5 (chest2), pose
  const Real J_3_5 = s5 * J_3_3 - c5 * J_3_5_p1;
  J[77] = J_3_5;
  J[221] = J_3_5;
  const Real J_2_2_p1 = s5 * J_3_5_p1 + c5 * J_3_3;

  // link 4 (chest1), pose
  const Real J_3_4 = s4 * J_5_3;
  J[76] = J_3_4;
  J[220] = J_3_4;

  // link 6 (chest3), pose
  const Real J_2_2_p2 = c6 * J_2_2_p1 + s6 * J_3_4;

  // link 7 (left_shoulder1), pose
  const Real J_2_2_p3 = s7 * J_3_5 - c7 * J_2_2_p2;

  // link 6 (chest3), pose
  const Real J_3_6 = c6 * J_3_4 - s6 * J_2_2_p1;
  J[78] = J_3_6;
  J[229] = J_3_6;

  // link 8 (left_shoulder2), pose
  const Real J_2_2_p4 = s8 * J_2_2_p3 + c8 * J_3_6;

  // link 7 (left_shoulder1), pose
  const Real J_3_7 = c7 * J_3_5 + s7 * J_2_2_p2;
  J[79] = J_3_7;

  // link 9 (left_upperarm), pose
  const Real J_2_2_p5 = s9 * J_2_2_p4 + c9 * J_3_7;

  // link 8 (left_shoulder2), pose
  const Real J_3_8 = s8 * J_3_6 - c8 * J_2_2_p3;
  J[80] = -J_3_8;

  // link 10 (left_lowerarm), pose
  const Real J_2_2_p6 = c10 * J_2_2_p5 + s10 * J_3_8;

  // link 9 (left_upperarm), pose
  const Real J_3_9 = c9 * J_2_2_p4 - s9 * J_3_7;
  J[81] = J_3_9;

  // link 11 (left_wrist1), pose
  const Real J_2_2_p7 = c11 * J_2_2_p6 + s11 * J_3_9;

  // link 10 (left_lowerarm), pose
  const Real J_3_10 = c10 * J_3_8 - s10 * J_2_2_p5;
  J[82] = -J_3_10;

  // link 11 (left_wrist1), pose
  const Real J_3_11 = c11 * J_3_9 - s11 * J_2_2_p6;
  J[83] = J_3_11;

  // link 24 (right_eye), pose
  const Real J_2_2_p8 = 0.086 * (c13 * (c12 * J_3_10 - s12 * J_2_2_p7) + s13 * J_3_11);

  // link 12 (left_wrist2), Jacobian
  const Real J_2_2_p9 = J_2_2_p8 + 0.269 * J_3_10;

  // link 10 (left_lowerarm), Jacobian
  const Real J_2_2_p10 = J_2_2_p9 + 0.282 * J_3_8;

  // link 7 (left_shoulder1), pose
  const Real J_2_2_p11 = 0.18 * J_3_6;
  const Real J_2_2_p12 = 0.226 * J_2_2_p2;

  // link 7 (left_shoulder1), Jacobian
  const Real J_2_2_p13 = J_2_2_p10 + (J_2_2_p11 - J_2_2_p12);

  // link 6 (chest3), pose
  const Real J_2_2_p14 = 0.072 * J_2_2_p1;

  // link 6 (chest3), Jacobian
  const Real J_2_2_p15 = J_2_2_p13 - J_2_2_p14;

  // link 5 (chest2), pose
  const Real J_2_2_p16 = 0.21799999999999997 * J_3_3;

  // link 5 (chest2), Jacobian
  const Real J_2_2 = J_2_2_p15 - J_2_2_p16;
  J[50] = -J_2_2;

  // link 4 (chest1), Jacobian
  J[27] = -(J_5_3 * J_2_2 - J_3_3 * J_0_2);

  // link 5 (chest2), Jacobian
  J[28] = -(J_3_4 * J_0_2_p13 + J_5_4 * J_2_2_p15);

  // link 6 (chest3), Jacobian
  J[29] = J_5_5 * J_2_2_p13 - J_3_5 * J_0_2_p11;

  // link 7 (left_shoulder1), Jacobian
  J[30] = -(J_5_6 * J_2_2_p10 + J_3_6 * J_0_2_p8);

  // link 8 (left_shoulder2), Jacobian
  J[31] = J_5_7 * J_2_2_p10 - J_3_7 * J_0_2_p8;

  // link 9 (left_upperarm), Jacobian
  J[32] = J_3_8 * J_0_2_p8 - J_5_8 * J_2_2_p10;

  // link 10 (left_lowerarm), Jacobian
  J[33] = -(J_5_9 * J_2_2_p9 + J_3_9 * J_0_2_p7);

  // link 11 (left_wrist1), Jacobian
  J[34] = J_3_10 * J_0_2_p7 - J_5_10 * J_2_2_p9;

  // link 12 (left_wrist2), Jacobian
  J[35] = -(J_5_11 * J_2_2_p8 + J_3_11 * J_0_2_p6);

  // link 12 (left_wrist2), pose
  const Real J_3_12 = c12 * J_2_2_p7 + s12 * J_3_10;
  J[84] = J_3_12;

  // link 13 (left_hand), Jacobian
  J[36] = J_5_12 * J_2_2_p8 - J_3_12 * J_0_2_p6;

  // link 3 (hip), pose
  const Real J_2_1_p1 = 0.422 * J_5_3_p1;

  // link 3 (hip), Jacobian
  const Real J_2_1 = J_2_2 + J_2_1_p1;
  J[49] = -J_2_1;

  // link 2 (thigh), pose
  const Real p2_x = 0.434 * s1;

  // link 2 (thigh), Jacobian
  J[48] = -(J_2_1 + p2_x);

  // link 4 (chest1), Jacobian
  J[51] = -(J_3_3 * J_0_3_p9);

  // link 5 (chest2), Jacobian
  J[52] = -(c4 * J_2_2_p15 - J_3_4 * J_0_3_p9);

  // link 6 (chest3), Jacobian
  J[53] = J_3_5 * J_0_3_p8 - J_4_5 * J_2_2_p13;

  // link 7 (left_shoulder1), Jacobian
  J[54] = J_3_6 * J_0_3_p5 - J_4_6 * J_2_2_p10;

  // link 8 (left_shoulder2), Jacobian
  J[55] = J_3_7 * J_0_3_p5 - J_4_7 * J_2_2_p10;

  // link 9 (left_upperarm), Jacobian
  J[56] = J_4_8 * J_2_2_p10 - J_3_8 * J_0_3_p5;

  // link 10 (left_lowerarm), Jacobian
  J[57] = J_3_9 * J_0_3_p4 - J_4_9 * J_2_2_p9;

  // link 11 (left_wrist1), Jacobian
  J[58] = J_4_10 * J_2_2_p9 - J_3_10 * J_0_3_p4;

  // link 12 (left_wrist2), Jacobian
  J[59] = J_3_11 * J_0_3_p3 - J_4_11 * J_2_2_p8;

  // link 13 (left_hand), Jacobian
  J[60] = J_3_12 * J_0_3_p3 - J_4_12 * J_2_2_p8;
  J[96] = 1.0;
  J[97] = 1.0;
  J[98] = 1.0;
  J[240] = 1.0;
  J[241] = 1.0;
  J[242] = 1.0;

  // link 14 (right_shoulder1), pose
  const Real J_11_14 = s14 * J_5_7_p3 + c14 * J_5_5;
  J[278] = J_11_14;
  const Real J_6_2_p1 = c14 * J_5_7_p3 - s14 * J_5_5;

  // link 15 (right_shoulder2), pose
  const Real J_6_2_p2 = s15 * J_6_2_p1 + c15 * J_5_6;

  // link 16 (right_upperarm), pose
  const Real J_6_2_p3 = c16 * J_11_14 - s16 * J_6_2_p2;

  // link 15 (right_shoulder2), pose
  const Real J_11_15 = c15 * J_6_2_p1 - s15 * J_5_6;
  J[279] = -J_11_15;

  // link 17 (right_lowerarm), pose
  const Real J_6_2_p4 = c17 * J_6_2_p3 + s17 * J_11_15;

  // link 16 (right_upperarm), pose
  const Real J_11_16 = c16 * J_6_2_p2 + s16 * J_11_14;
  J[280] = -J_11_16;

  // link 18 (right_wrist1), pose
  const Real J_6_2_p5 = c18 * J_6_2_p4 - s18 * J_11_16;

  // link 17 (right_lowerarm), pose
  const Real J_11_17 = c17 * J_11_15 - s17 * J_6_2_p3;
  J[281] = -J_11_17;

  // link 18 (right_wrist1), pose
  const Real J_11_18 = s18 * J_6_2_p4 + c18 * J_11_16;
  J[282] = -J_11_18;

  // link 1 (calf), Jacobian
  const Real J_6_2_p6 = 0.086 * (c20 * (c19 * J_11_17 - s19 * J_6_2_p5) - s20 * J_11_18);

  // link 19 (right_wrist2), Jacobian
  const Real J_6_2_p7 = J_6_2_p6 + 0.269 * J_11_17;

  // link 17 (right_lowerarm), Jacobian
  const Real J_6_2_p8 = J_6_2_p7 + 0.282 * J_11_15;

  // link 14 (right_shoulder1), Jacobian
  const Real J_6_2_p9 = J_6_2_p8 + (J_0_2_p10 - J_0_2_p9);

  // link 6 (chest3), Jacobian
  const Real J_6_2_p10 = J_6_2_p9 - J_0_2_p12;

  // link 5 (chest2), Jacobian
  const Real J_6_2 = J_6_2_p10 - J_0_2_p14;
  J[146] = J_6_2;

  // link 3 (hip), Jacobian
  const Real J_6_1 = J_6_2 - J_0_1_p1;
  J[145] = J_6_1;

  // link 2 (thigh), Jacobian
  J[144] = J_6_1 + J_0_0_p1;

  // link 14 (right_shoulder1), pose
  const Real J_10_15_p1 = c14 * J_4_8_p2 - s14 * J_4_5;

  // link 15 (right_shoulder2), pose
  const Real J_10_15 = c15 * J_10_15_p1 + s15 * J_4_6;
  J[255] = -J_10_15;
  const Real J_10_17_p1 = c15 * J_4_6 - s15 * J_10_15_p1;

  // link 14 (right_shoulder1), pose
  const Real J_10_14 = s14 * J_4_8_p2 + c14 * J_4_5;
  J[254] = J_10_14;

  // link 16 (right_upperarm), pose
  const Real J_10_17_p2 = s16 * J_10_17_p1 + c16 * J_10_14;

  // link 17 (right_lowerarm), pose
  const Real J_10_17 = c17 * J_10_15 - s17 * J_10_17_p2;
  J[257] = -J_10_17;
  const Real J_6_3_p1 = c17 * J_10_17_p2 + s17 * J_10_15;

  // link 16 (right_upperarm), pose
  const Real J_10_16 = c16 * J_10_17_p1 - s16 * J_10_14;
  J[256] = J_10_16;

  // link 18 (right_wrist1), pose
  const Real J_6_3_p2 = c18 * J_6_3_p1 + s18 * J_10_16;
  const Real J_10_18 = c18 * J_10_16 - s18 * J_6_3_p1;
  J[258] = J_10_18;

  // link 1 (calf), Jacobian
  const Real J_6_3_p3 = 0.086 * (c20 * (c19 * J_10_17 - s19 * J_6_3_p2) + s20 * J_10_18);

  // link 19 (right_wrist2), Jacobian
  const Real J_6_3_p4 = J_6_3_p3 + 0.269 * J_10_17;

  // link 17 (right_lowerarm), Jacobian
  const Real J_6_3_p5 = J_6_3_p4 + 0.282 * J_10_15;

  // link 14 (right_shoulder1), Jacobian
  const Real J_6_3_p6 = J_6_3_p5 - (J_0_3_p7 + J_0_3_p6);

  // link 6 (chest3), Jacobian
  const Real J_6_3_p7 = J_6_3_p6 + p6_y;

  // link 4 (chest1), Jacobian
  J[147] = J_5_3 * J_6_3_p7;

  // link 5 (chest2), Jacobian
  J[148] = c4 * J_6_2_p10 + J_5_4 * J_6_3_p7;

  // link 6 (chest3), Jacobian
  J[149] = J_4_5 * J_6_2_p9 - J_5_5 * J_6_3_p6;

  // link 14 (right_shoulder1), Jacobian
  J[157] = J_4_6 * J_6_2_p8 + J_5_6 * J_6_3_p5;

  // link 15 (right_shoulder2), Jacobian
  J[158] = J_10_14 * J_6_2_p8 - J_11_14 * J_6_3_p5;

  // link 16 (right_upperarm), Jacobian
  J[159] = J_11_15 * J_6_3_p5 - J_10_15 * J_6_2_p8;

  // link 17 (right_lowerarm), Jacobian
  J[160] = J_10_16 * J_6_2_p7 + J_11_16 * J_6_3_p4;

  // link 18 (right_wrist1), Jacobian
  J[161] = J_11_17 * J_6_3_p4 - J_10_17 * J_6_2_p7;

  // link 19 (right_wrist2), Jacobian
  J[162] = J_10_18 * J_6_2_p6 + J_11_18 * J_6_3_p3;

  // link 19 (right_wrist2), pose
  const Real J_10_19 = c19 * J_6_3_p2 + s19 * J_10_17;
  J[259] = J_10_19;
  const Real J_11_19 = c19 * J_6_2_p5 + s19 * J_11_17;
  J[283] = J_11_19;

  // link 20 (right_hand), Jacobian
  J[163] = J_10_19 * J_6_2_p6 - J_11_19 * J_6_3_p3;

  // link 14 (right_shoulder1), pose
  const Real J_8_2_p1 = s14 * J_3_5 - c14 * J_2_2_p2;

  // link 15 (right_shoulder2), pose
  const Real J_8_2_p2 = s15 * J_8_2_p1 + c15 * J_3_6;

  // link 14 (right_shoulder1), pose
  const Real J_9_14 = c14 * J_3_5 + s14 * J_2_2_p2;
  J[230] = J_9_14;

  // link 16 (right_upperarm), pose
  const Real J_8_2_p3 = s16 * J_8_2_p2 + c16 * J_9_14;

  // link 15 (right_shoulder2), pose
  const Real J_9_15 = s15 * J_3_6 - c15 * J_8_2_p1;
  J[231] = -J_9_15;

  // link 17 (right_lowerarm), pose
  const Real J_8_2_p4 = c17 * J_8_2_p3 + s17 * J_9_15;

  // link 16 (right_upperarm), pose
  const Real J_9_16 = c16 * J_8_2_p2 - s16 * J_9_14;
  J[232] = J_9_16;

  // link 18 (right_wrist1), pose
  const Real J_8_2_p5 = c18 * J_8_2_p4 + s18 * J_9_16;

  // link 17 (right_lowerarm), pose
  const Real J_9_17 = c17 * J_9_15 - s17 * J_8_2_p3;
  J[233] = -J_9_17;

  // link 18 (right_wrist1), pose
  const Real J_9_18 = c18 * J_9_16 - s18 * J_8_2_p4;
  J[234] = J_9_18;

  // link 1 (calf), Jacobian
  const Real J_8_2_p6 = 0.086 * (c20 * (c19 * J_9_17 - s19 * J_8_2_p5) + s20 * J_9_18);

  // link 19 (right_wrist2), Jacobian
  const Real J_8_2_p7 = J_8_2_p6 + 0.269 * J_9_17;

  // link 17 (right_lowerarm), Jacobian
  const Real J_8_2_p8 = J_8_2_p7 + 0.282 * J_9_15;

  // link 14 (right_shoulder1), Jacobian
  const Real J_8_2_p9 = J_8_2_p8 - (J_2_2_p12 + J_2_2_p11);

  // link 6 (chest3), Jacobian
  const Real J_8_2_p10 = J_8_2_p9 - J_2_2_p14;

  // link 5 (chest2), Jacobian
  const Real J_8_2 = J_8_2_p10 - J_2_2_p16;
  J[194] = -J_8_2;

  // link 4 (chest1), Jacobian
  J[171] = -(J_5_3 * J_8_2 - J_3_3 * J_6_2);

  // link 5 (chest2), Jacobian
  J[172] = -(J_3_4 * J_6_2_p10 + J_5_4 * J_8_2_p10);

  // link 6 (chest3), Jacobian
  J[173] = J_5_5 * J_8_2_p9 - J_3_5 * J_6_2_p9;

  // link 14 (right_shoulder1), Jacobian
  J[181] = -(J_5_6 * J_8_2_p8 + J_3_6 * J_6_2_p8);

  // link 15 (right_shoulder2), Jacobian
  J[182] = J_11_14 * J_8_2_p8 - J_9_14 * J_6_2_p8;

  // link 16 (right_upperarm), Jacobian
  J[183] = J_9_15 * J_6_2_p8 - J_11_15 * J_8_2_p8;

  // link 17 (right_lowerarm), Jacobian
  J[184] = -(J_11_16 * J_8_2_p7 + J_9_16 * J_6_2_p7);

  // link 18 (right_wrist1), Jacobian
  J[185] = J_9_17 * J_6_2_p7 - J_11_17 * J_8_2_p7;

  // link 19 (right_wrist2), Jacobian
  J[186] = -(J_11_18 * J_8_2_p6 + J_9_18 * J_6_2_p6);

  // link 19 (right_wrist2), pose
  const Real J_9_19 = c19 * J_8_2_p5 + s19 * J_9_17;
  J[235] = J_9_19;

  // link 20 (right_hand), Jacobian
  J[187] = J_11_19 * J_8_2_p6 - J_9_19 * J_6_2_p6;

  // link 3 (hip), Jacobian
  const Real J_8_1 = J_8_2 + J_2_1_p1;
  J[193] = -J_8_1;

  // link 2 (thigh), Jacobian
  J[192] = -(J_8_1 + p2_x);

  // link 4 (chest1), Jacobian
  J[195] = -(J_3_3 * J_6_3_p7);

  // link 5 (chest2), Jacobian
  J[196] = -(c4 * J_8_2_p10 - J_3_4 * J_6_3_p7);

  // link 6 (chest3), Jacobian
  J[197] = J_3_5 * J_6_3_p6 - J_4_5 * J_8_2_p9;

  // link 14 (right_shoulder1), Jacobian
  J[205] = J_3_6 * J_6_3_p5 - J_4_6 * J_8_2_p8;

  // link 15 (right_shoulder2), Jacobian
  J[206] = J_9_14 * J_6_3_p5 - J_10_14 * J_8_2_p8;

  // link 16 (right_upperarm), Jacobian
  J[207] = J_10_15 * J_8_2_p8 - J_9_15 * J_6_3_p5;

  // link 17 (right_lowerarm), Jacobian
  J[208] = J_9_16 * J_6_3_p4 - J_10_16 * J_8_2_p7;

  // link 18 (right_wrist1), Jacobian
  J[209] = J_10_17 * J_8_2_p7 - J_9_17 * J_6_3_p4;

  // link 19 (right_wrist2), Jacobian
  J[210] = J_9_18 * J_6_3_p3 - J_10_18 * J_8_2_p6;

  // link 20 (right_hand), Jacobian
  J[211] = J_9_19 * J_6_3_p3 - J_10_19 * J_8_2_p6;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
