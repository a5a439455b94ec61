// forward_kinematics: x_world = R x_point + p, for every operational point
// By outward recursion.
// 367 flops (add 132, mul 235, div 0), sine and cosine of 20 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

void forward_kinematics(const Real (&TREELINE_RESTRICT q)[24],
    Real (&TREELINE_RESTRICT position)[6], Real (&TREELINE_RESTRICT rotation)[18]) noexcept {
  const Real angles[20] = {q[0], q[1], q[2], q[4], q[3], q[5], q[7], q[6], q[9], q[8], q[12], q[11],
      q[10], q[14], q[13], q[16], q[15], q[19], q[18], q[17]};
  Real sines[20];
  Real cosines[20];
  detail::sin_cos(angles, sines, cosines);
  const Real s1 = sines[0];
  const Real s2 = sines[1];
  const Real c1 = cosines[0];
  const Real c2 = cosines[1];
  const Real s3 = sines[2];
  const Real c3 = cosines[2];
  const Real s5 = sines[3];
  const Real c4 = cosines[4];
  const Real c5 = cosines[3];
  const Real c6 = cosines[5];
  const Real s6 = sines[5];
  const Real s4 = sines[4];
  const Real s8 = sines[6];
  const Real c8 = cosines[6];
  const Real c7 = cosines[7];
  const Real s7 = sines[7];
  const Real c10 = cosines[8];
  const Real s10 = sines[8];
  const Real s9 = sines[9];
  const Real c9 = cosines[9];
  const Real c13 = cosines[10];
  const Real c12 = cosines[11];
  const Real s12 = sines[11];
  const Real c11 = cosines[12];
  const Real s11 = sines[12];
  const Real s13 = sines[10];
  const Real s15 = sines[13];
  const Real c15 = cosines[13];
  const Real c14 = cosines[14];
  const Real s14 = sines[14];
  const Real c17 = cosines[15];
  const Real s17 = sines[15];
  const Real s16 = sines[16];
  const Real c16 = cosines[16];
  const Real c20 = cosines[17];
  const Real c19 = cosines[18];
  const Real s19 = sines[18];
  const Real c18 = cosines[19];
  const Real s18 = sines[19];
  const Real s20 = sines[17];

  // link 2 (thigh), pose
  const Real rotation_2_p1 = c2 * c1 - s2 * s1;
  const Real rotation_2_p2 = s2 * c1 + c2 * s1;

  // link 3 (hip), pose
  const Real rotation_2_p3 = c3 * rotation_2_p1 - s3 * rotation_2_p2;

  // link 4 (chest1), pose
  const Real rotation_2_p4 = c4 * rotation_2_p3;

  // link 3 (hip), pose
  const Real rotation_2_p5 = s3 * rotation_2_p1 + c3 * rotation_2_p2;

  // link 5 (chest2), pose
  const Real rotation_2_p6 = s5 * rotation_2_p4 + c5 * rotation_2_p5;

  // link 4 (chest1), pose
  const Real rotation_2_p7 = s4 * rotation_2_p3;

  // link 6 (chest3), pose
  const Real rotation_2_p8 = c6 * rotation_2_p6 + s6 * rotation_2_p7;

  // link 5 (chest2), pose
  const Real rotation_2_p9 = c5 * rotation_2_p4 - s5 * rotation_2_p5;

  // link 7 (left_shoulder1), pose
  const Real rotation_2_p10 = c7 * rotation_2_p8 + s7 * rotation_2_p9;

  // link 6 (chest3), pose
  const Real rotation_2_p11 = s6 * rotation_2_p6 - c6 * rotation_2_p7;

  // link 8 (left_shoulder2), pose
  const Real rotation_2_p12 = s8 * rotation_2_p10 + c8 * rotation_2_p11;

  // link 7 (left_shoulder1), pose
  const Real rotation_2_p13 = c7 * rotation_2_p9 - s7 * rotation_2_p8;

  // link 9 (left_upperarm), pose
  const Real rotation_2_p14 = s9 * rotation_2_p12 + c9 * rotation_2_p13;

  // link 8 (left_shoulder2), pose
  const Real rotation_2_p15 = s8 * rotation_2_p11 - c8 * rotation_2_p10;

  // link 10 (left_lowerarm), pose
  const Real rotation_2_p16 = c10 * rotation_2_p14 + s10 * rotation_2_p15;

  // link 9 (left_upperarm), pose
  const Real rotation_2_p17 = c9 * rotation_2_p12 - s9 * rotation_2_p13;

  // link 11 (left_wrist1), pose
  const Real rotation_2_p18 = c11 * rotation_2_p16 + s11 * rotation_2_p17;

  // link 10 (left_lowerarm), pose
  const Real rotation_2_p19 = c10 * rotation_2_p15 - s10 * rotation_2_p14;

  // link 12 (left_wrist2), pose
  const Real rotation_2_p20 = c12 * rotation_2_p19 - s12 * rotation_2_p18;

  // link 11 (left_wrist1), pose
  const Real rotation_2_p21 = c11 * rotation_2_p17 - s11 * rotation_2_p16;

  // link 13 (left_hand), pose
  const Real rotation_2 = c13 * rotation_2_p20 + s13 * rotation_2_p21;
  rotation[2] = -rotation_2;

  // link 2 (thigh), pose
  const Real p2_x = 0.434 * s1;

  // link 3 (hip), pose
  const Real p3_x = p2_x + 0.422 * rotation_2_p2;

  // link 5 (chest2), pose
  const Real p5_x = p3_x + 0.21799999999999997 * rotation_2_p5;

  // link 6 (chest3), pose
  const Real p6_x = p5_x + 0.072 * rotation_2_p6;

  // link 24 (right_eye), pose
  const Real position_0_p1 = p6_x + 0.226 * rotation_2_p8;

  // link 7 (left_shoulder1), pose
  const Real position_0_p2 = 0.18 * rotation_2_p11;

  // link 24 (right_eye), pose
  position[0] = position_0_p1 + position_0_p2 + 0.282 * rotation_2_p15 + 0.269 * rotation_2_p19 +
      0.086 * rotation_2;

  // link 5 (chest2), pose
  const Real position_1_p1 = s5 * s4;

  // link 6 (chest3), pose
  const Real position_1_p2 = s6 * c4 - c6 * position_1_p1;
  const Real p6_y = 0.072 * position_1_p1;

  // link 24 (right_eye), pose
  const Real position_1_p3 = p6_y - 0.226 * position_1_p2;

  // link 6 (chest3), pose
  const Real position_1_p4 = s6 * position_1_p1 + c6 * c4;

  // link 7 (left_shoulder1), pose
  const Real position_1_p5 = 0.18 * position_1_p4;

  // link 5 (chest2), pose
  const Real position_1_p6 = c5 * s4;

  // link 7 (left_shoulder1), pose
  const Real position_1_p7 = c7 * position_1_p2 - s7 * position_1_p6;

  // link 8 (left_shoulder2), pose
  const Real position_1_p8 = c8 * position_1_p7 + s8 * position_1_p4;
  const Real position_1_p9 = c8 * position_1_p4 - s8 * position_1_p7;

  // link 7 (left_shoulder1), pose
  const Real position_1_p10 = s7 * position_1_p2 + c7 * position_1_p6;

  // link 9 (left_upperarm), pose
  const Real position_1_p11 = s9 * position_1_p9 + c9 * position_1_p10;

  // link 10 (left_lowerarm), pose
  const Real position_1_p12 = c10 * position_1_p8 - s10 * position_1_p11;
  const Real rotation_5_p1 = c10 * position_1_p11 + s10 * position_1_p8;

  // link 9 (left_upperarm), pose
  const Real rotation_5_p2 = c9 * position_1_p9 - s9 * position_1_p10;

  // link 11 (left_wrist1), pose
  const Real rotation_5_p3 = c11 * rotation_5_p1 + s11 * rotation_5_p2;

  // link 12 (left_wrist2), pose
  const Real rotation_5_p4 = c12 * position_1_p12 - s12 * rotation_5_p3;

  // link 11 (left_wrist1), pose
  const Real rotation_5_p5 = c11 * rotation_5_p2 - s11 * rotation_5_p1;

  // link 13 (left_hand), pose
  const Real rotation_5 = c13 * rotation_5_p4 + s13 * rotation_5_p5;
  rotation[5] = -rotation_5;

  // link 24 (right_eye), pose
  position[1] = position_1_p3 + position_1_p5 + 0.282 * position_1_p8 + 0.269 * position_1_p12 +
      0.086 * rotation_5;

  // link 4 (chest1), pose
  const Real rotation_8_p1 = c4 * rotation_2_p5;

  // link 5 (chest2), pose
  const Real rotation_8_p2 = s5 * rotation_8_p1 - c5 * rotation_2_p3;

  // link 4 (chest1), pose
  const Real rotation_8_p3 = s4 * rotation_2_p5;

  // link 6 (chest3), pose
  const Real rotation_8_p4 = c6 * rotation_8_p2 + s6 * rotation_8_p3;

  // link 5 (chest2), pose
  const Real rotation_8_p5 = c5 * rotation_8_p1 + s5 * rotation_2_p3;

  // link 7 (left_shoulder1), pose
  const Real rotation_8_p6 = s7 * rotation_8_p4 - c7 * rotation_8_p5;
  const Real rotation_8_p7 = c7 * rotation_8_p4 + s7 * rotation_8_p5;

  // link 6 (chest3), pose
  const Real rotation_8_p8 = s6 * rotation_8_p2 - c6 * rotation_8_p3;

  // link 8 (left_shoulder2), pose
  const Real rotation_8_p9 = s8 * rotation_8_p7 + c8 * rotation_8_p8;

  // link 9 (left_upperarm), pose
  const Real rotation_8_p10 = c9 * rotation_8_p6 - s9 * rotation_8_p9;

  // link 8 (left_shoulder2), pose
  const Real rotation_8_p11 = c8 * rotation_8_p7 - s8 * rotation_8_p8;

  // link 10 (left_lowerarm), pose
  const Real rotation_8_p12 = c10 * rotation_8_p10 + s10 * rotation_8_p11;

  // link 9 (left_upperarm), pose
  const Real rotation_8_p13 = c9 * rotation_8_p9 + s9 * rotation_8_p6;

  // link 11 (left_wrist1), pose
  const Real rotation_8_p14 = c11 * rotation_8_p12 - s11 * rotation_8_p13;

  // link 10 (left_lowerarm), pose
  const Real rotation_8_p15 = c10 * rotation_8_p11 - s10 * rotation_8_p10;

  // link 12 (left_wrist2), pose
  const Real rotation_8_p16 = c12 * rotation_8_p15 - s12 * rotation_8_p14;

  // link 11 (left_wrist1), pose
  const Real rotation_8_p17 = s11 * rotation_8_p12 + c11 * rotation_8_p13;

  // link 13 (left_hand), pose
  const Real rotation_8 = c13 * rotation_8_p16 - s13 * rotation_8_p17;
  rotation[8] = -rotation_8;

  // link 2 (thigh), pose
  const Real p2_z = 0.07 + 0.434 * c1;

  // link 3 (hip), pose
  const Real p3_z = p2_z + 0.422 * rotation_2_p1;

  // link 5 (chest2), pose
  const Real p5_z = p3_z + 0.21799999999999997 * rotation_2_p3;

  // link 6 (chest3), pose
  const Real p6_z = p5_z - 0.072 * rotation_8_p2;

  // link 24 (right_eye), pose
  const Real position_2_p1 = p6_z - 0.226 * rotation_8_p4;

  // link 7 (left_shoulder1), pose
  const Real position_2_p2 = 0.18 * rotation_8_p8;

  // link 24 (right_eye), pose
  position[2] = position_2_p1 - position_2_p2 + 0.282 * rotation_8_p11 + 0.269 * rotation_8_p15 +
      0.086 * rotation_8;

  // link 14 (right_shoulder1), pose
  const Real rotation_11_p1 = c14 * rotation_2_p8 + s14 * rotation_2_p9;

  // link 15 (right_shoulder2), pose
  const Real rotation_11_p2 = s15 * rotation_11_p1 + c15 * rotation_2_p11;

  // link 14 (right_shoulder1), pose
  const Real rotation_11_p3 = c14 * rotation_2_p9 - s14 * rotation_2_p8;

  // link 16 (right_upperarm), pose
  const Real rotation_11_p4 = s16 * rotation_11_p2 + c16 * rotation_11_p3;

  // link 15 (right_shoulder2), pose
  const Real rotation_11_p5 = s15 * rotation_2_p11 - c15 * rotation_11_p1;

  // link 17 (right_lowerarm), pose
  const Real rotation_11_p6 = c17 * rotation_11_p4 + s17 * rotation_11_p5;

  // link 16 (right_upperarm), pose
  const Real rotation_11_p7 = c16 * rotation_11_p2 - s16 * rotation_11_p3;

  // link 18 (right_wrist1), pose
  const Real rotation_11_p8 = c18 * rotation_11_p6 + s18 * rotation_11_p7;

  // link 17 (right_lowerarm), pose
  const Real rotation_11_p9 = c17 * rotation_11_p5 - s17 * rotation_11_p4;

  // link 19 (right_wrist2), pose
  const Real rotation_11_p10 = c19 * rotation_11_p9 - s19 * rotation_11_p8;

  // link 18 (right_wrist1), pose
  const Real rotation_11_p11 = c18 * rotation_11_p7 - s18 * rotation_11_p6;

  // link 20 (right_hand), pose
  const Real rotation_11 = c20 * rotation_11_p10 + s20 * rotation_11_p11;
  rotation[11] = -rotation_11;

  // link 24 (right_eye), pose
  position[3] = position_0_p1 - position_0_p2 + 0.282 * rotation_11_p5 + 0.269 * rotation_11_p9 +
      0.086 * rotation_11;

  // link 14 (right_shoulder1), pose
  const Real position_4_p1 = c14 * position_1_p2 - s14 * position_1_p6;

  // link 15 (right_shoulder2), pose
  const Real position_4_p2 = c15 * position_4_p1 + s15 * position_1_p4;
  const Real position_4_p3 = c15 * position_1_p4 - s15 * position_4_p1;

  // link 14 (right_shoulder1), pose
  const Real position_4_p4 = s14 * position_1_p2 + c14 * position_1_p6;

  // link 16 (right_upperarm), pose
  const Real position_4_p5 = s16 * position_4_p3 + c16 * position_4_p4;

  // link 17 (right_lowerarm), pose
  const Real position_4_p6 = c17 * position_4_p2 - s17 * position_4_p5;
  const Real rotation_14_p1 = c17 * position_4_p5 + s17 * position_4_p2;

  // link 16 (right_upperarm), pose
  const Real rotation_14_p2 = c16 * position_4_p3 - s16 * position_4_p4;

  // link 18 (right_wrist1), pose
  const Real rotation_14_p3 = c18 * rotation_14_p1 + s18 * rotation_14_p2;

  // link 19 (right_wrist2), pose
  const Real rotation_14_p4 = c19 * position_4_p6 - s19 * rotation_14_p3;

  // link 18 (right_wrist1), pose
  const Real rotation_14_p5 = c18 * rotation_14_p2 - s18 * rotation_14_p1;

  // link 20 (right_hand), pose
  const Real rotation_14 = c20 * rotation_14_p4 + s20 * rotation_14_p5;
  rotation[14] = -rotation_14;

  // link 24 (right_eye), pose
  position[4] = position_1_p3 - position_1_p5 + 0.282 * position_4_p2 + 0.269 * position_4_p6 +
      0.086 * rotation_14;

  // link 14 (right_shoulder1), pose
  const Real rotation_17_p1 = s14 * rotation_8_p4 - c14 * rotation_8_p5;
  const Real rotation_17_p2 = c14 * rotation_8_p4 + s14 * rotation_8_p5;

  // link 15 (right_shoulder2), pose
  const Real rotation_17_p3 = s15 * rotation_17_p2 + c15 * rotation_8_p8;

  // link 16 (right_upperarm), pose
  const Real rotation_17_p4 = c16 * rotation_17_p1 - s16 * rotation_17_p3;

  // link 15 (right_shoulder2), pose
  const Real rotation_17_p5 = c15 * rotation_17_p2 - s15 * rotation_8_p8;

  // link 17 (right_lowerarm), pose
  const Real rotation_17_p6 = c17 * rotation_17_p4 + s17 * rotation_17_p5;

  // link 16 (right_upperarm), pose
  const Real rotation_17_p7 = c16 * rotation_17_p3 + s16 * rotation_17_p1;

  // link 18 (right_wrist1), pose
  const Real rotation_17_p8 = c18 * rotation_17_p6 - s18 * rotation_17_p7;

  // link 17 (right_lowerarm), pose
  const Real rotation_17_p9 = c17 * rotation_17_p5 - s17 * rotation_17_p4;

  // link 19 (right_wrist2), pose
  const Real rotation_17_p10 = c19 * rotation_17_p9 - s19 * rotation_17_p8;

  // link 18 (right_wrist1), pose
  const Real rotation_17_p11 = s18 * rotation_17_p6 + c18 * rotation_17_p7;

  // link 20 (right_hand), pose
  const Real rotation_17 = c20 * rotation_17_p10 - s20 * rotation_17_p11;
  rotation[17] = -rotation_17;

  // link 24 (right_eye), pose
  position[5] = position_2_p1 + position_2_p2 + 0.282 * rotation_17_p5 + 0.269 * rotation_17_p9 +
      0.086 * rotation_17;

  // link 12 (left_wrist2), pose
  rotation[0] = c12 * rotation_2_p18 + s12 * rotation_2_p19;

  // link 13 (left_hand), pose
  rotation[1] = c13 * rotation_2_p21 - s13 * rotation_2_p20;

  // link 12 (left_wrist2), pose
  rotation[3] = c12 * rotation_5_p3 + s12 * position_1_p12;

  // link 13 (left_hand), pose
  rotation[4] = c13 * rotation_5_p5 - s13 * rotation_5_p4;

  // link 12 (left_wrist2), pose
  rotation[6] = c12 * rotation_8_p14 + s12 * rotation_8_p15;

  // link 13 (left_hand), pose
  rotation[7] = -(s13 * rotation_8_p16 + c13 * rotation_8_p17);

  // link 19 (right_wrist2), pose
  rotation[9] = c19 * rotation_11_p8 + s19 * rotation_11_p9;

  // link 20 (right_hand), pose
  rotation[10] = c20 * rotation_11_p11 - s20 * rotation_11_p10;

  // link 19 (right_wrist2), pose
  rotation[12] = c19 * rotation_14_p3 + s19 * position_4_p6;

  // link 20 (right_hand), pose
  rotation[13] = c20 * rotation_14_p5 - s20 * rotation_14_p4;

  // link 19 (right_wrist2), pose
  rotation[15] = c19 * rotation_17_p8 + s19 * rotation_17_p9;

  // link 20 (right_hand), pose
  rotation[16] = -(s20 * rotation_17_p10 + c20 * rotation_17_p11);
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
