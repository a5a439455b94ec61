// forward_kinematics: x_world = R x_point + p, for every operational point
// By outward recursion, alike limbs in lanes.
// 370 flops (add 132, mul 238, div 0), sine and cosine of 20 angles
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
void forward_kinematics(const Real (&TREELINE_RESTRICT q)[24],
    Real (&TREELINE_RESTRICT position)[6], Real (&TREELINE_RESTRICT rotation)[18]) noexcept {
  const Real angles[20] = {q[0], q[1], q[2], q[4], q[3], q[5], q[7], q[6], q[9], q[8], q[12], q[11],
      q[10], q[14], q[13], q[16], q[15], q[19], q[18], q[17]};
  Real sines[20];
  Real cosines[20];
  detail::sin_cos(angles, sines, cosines);
  const Real s1 = sines[0];
  const Real c2 = cosines[1];
  const Real c1 = cosines[0];
  const Real s2 = sines[1];
  const Real s3 = sines[2];
  const Real c3 = cosines[2];
  const Real s5 = sines[3];
  const Real c4 = cosines[4];
  const Real c5 = cosines[3];
  const Real c6 = cosines[5];
  const Real s4 = sines[4];
  const Real s6 = sines[5];
  const Real c8 = cosines[6];
  const Real c7 = cosines[7];
  const Real s7 = sines[7];
  const Real s8 = sines[6];
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
  const Real c15 = cosines[13];
  const Real c14 = cosines[14];
  const Real s14 = sines[14];
  const Real s15 = sines[13];
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

  // link 5 (chest2), pose
  const Real rotation_5_p1 = s5 * s4;
  const Real rotation_5_p2 = c5 * s4;
  const Real p2_x = 0.434 * s1;
  const Real rotation_2_p1 = s1 * s2 - c1 * c2;
  const Real rotation_2_p2 = s1 * c2 + c1 * s2;

  // link 6 (chest3), pose
  const Real p6_y = 0.072 * rotation_5_p1;
  const Real rotation_5_p5 = s6 * c4 - c6 * rotation_5_p1;
  const Real rotation_5_p6 = s6 * rotation_5_p1 + c6 * c4;
  const Real rotation_2_p3 = rotation_2_p1 * c3 + rotation_2_p2 * s3;
  const Real rotation_8_p1 = rotation_2_p1 * s3 - rotation_2_p2 * c3;

  // link 3 (hip), pose
  const Real p3_x = p2_x + 0.422 * rotation_2_p2;

  // link 4 (chest1), pose
  const Real rotation_2_p4 = c4 * rotation_2_p3;
  const Real rotation_8_p2 = c4 * rotation_8_p1;
  const Real rotation_2_p5 = s4 * rotation_2_p3;
  const Real rotation_8_p3 = s4 * rotation_8_p1;

  // link 7 (left_shoulder1), pose
  const Lanes<2> rotation_5_p11_lanes = detail::make_pack<Real>(c7, c14) * rotation_5_p5 -
      detail::make_pack<Real>(s7, s14) * rotation_5_p2;
  const Lanes<2> rotation_5_p12_lanes = detail::make_pack<Real>(s7, s14) * rotation_5_p5 +
      detail::make_pack<Real>(c7, c14) * rotation_5_p2;

  // link 24 (right_eye), pose
  const Real position_1_p2 = p6_y - 0.226 * rotation_5_p5;

  // link 5 (chest2), pose
  const Real p5_x = p3_x - 0.21799999999999997 * rotation_8_p1;
  const Real rotation_2_p6 = s5 * rotation_2_p4 + c5 * rotation_8_p1;
  const Real rotation_8_p4 = c5 * rotation_2_p3 - s5 * rotation_8_p2;
  const Real rotation_2_p7 = s5 * rotation_8_p1 - c5 * rotation_2_p4;
  const Real rotation_8_p5 = c5 * rotation_8_p2 + s5 * rotation_2_p3;

  // link 8 (left_shoulder2), pose
  const Lanes<2> rotation_5_p17_lanes = detail::make_pack<Real>(c8, c15) * rotation_5_p6 -
      detail::make_pack<Real>(s8, s15) * rotation_5_p11_lanes;
  const Lanes<2> rotation_5_p18_lanes = detail::make_pack<Real>(c8, c15) * rotation_5_p11_lanes +
      detail::make_pack<Real>(s8, s15) * rotation_5_p6;

  // link 2 (thigh), pose
  const Real p2_z = 0.07 + 0.434 * c1;

  // link 6 (chest3), pose
  const Real rotation_2_p10 = c6 * rotation_2_p6 + s6 * rotation_2_p5;
  const Real rotation_8_p8 = c6 * rotation_8_p4 - s6 * rotation_8_p3;
  const Real rotation_2_p11 = c6 * rotation_2_p5 - s6 * rotation_2_p6;
  const Real rotation_8_p9 = s6 * rotation_8_p4 + c6 * rotation_8_p3;

  // link 9 (left_upperarm), pose
  const Lanes<2> rotation_5_p23_lanes = detail::make_pack<Real>(s9, s16) * rotation_5_p17_lanes +
      detail::make_pack<Real>(c9, c16) * rotation_5_p12_lanes;
  const Lanes<2> rotation_5_p24_lanes = detail::make_pack<Real>(c9, c16) * rotation_5_p17_lanes -
      detail::make_pack<Real>(s9, s16) * rotation_5_p12_lanes;

  // link 3 (hip), pose
  const Real p3_z = p2_z - 0.422 * rotation_2_p1;

  // link 5 (chest2), pose
  const Real p5_z = p3_z - 0.21799999999999997 * rotation_2_p3;

  // link 6 (chest3), pose
  const Real p6_x = p5_x - 0.072 * rotation_2_p6;

  // link 7 (left_shoulder1), pose
  const Lanes<2> rotation_2_p16_lanes = detail::make_pack<Real>(c7, c14) * rotation_2_p10 -
      detail::make_pack<Real>(s7, s14) * rotation_2_p7;
  const Lanes<2> rotation_8_p14_lanes = detail::make_pack<Real>(c7, c14) * rotation_8_p8 -
      detail::make_pack<Real>(s7, s14) * rotation_8_p5;
  const Lanes<2> rotation_2_p17_lanes = detail::make_pack<Real>(s7, s14) * rotation_2_p10 +
      detail::make_pack<Real>(c7, c14) * rotation_2_p7;
  const Lanes<2> rotation_8_p15_lanes = detail::make_pack<Real>(s7, s14) * rotation_8_p8 +
      detail::make_pack<Real>(c7, c14) * rotation_8_p5;

  // link 10 (left_lowerarm), pose
  const Lanes<2> rotation_5_p29_lanes = detail::make_pack<Real>(c10, c17) * rotation_5_p23_lanes +
      detail::make_pack<Real>(s10, s17) * rotation_5_p18_lanes;
  const Lanes<2> rotation_5_p30_lanes = detail::make_pack<Real>(c10, c17) * rotation_5_p18_lanes -
      detail::make_pack<Real>(s10, s17) * rotation_5_p23_lanes;

  // link 6 (chest3), pose
  const Real p6_z = p5_z - 0.072 * rotation_8_p4;

  // link 24 (right_eye), pose
  const Real position_0_p2 = p6_x - 0.226 * rotation_2_p10;
  const Real position_2_p2 = p6_z - 0.226 * rotation_8_p8;

  // link 8 (left_shoulder2), pose
  const Lanes<2> rotation_2_p22_lanes = detail::make_pack<Real>(c8, c15) * rotation_2_p11 -
      detail::make_pack<Real>(s8, s15) * rotation_2_p16_lanes;
  const Lanes<2> rotation_8_p20_lanes = detail::make_pack<Real>(s8, s15) * rotation_8_p14_lanes +
      detail::make_pack<Real>(c8, c15) * rotation_8_p9;
  const Lanes<2> rotation_2_p23_lanes = detail::make_pack<Real>(c8, c15) * rotation_2_p16_lanes +
      detail::make_pack<Real>(s8, s15) * rotation_2_p11;
  const Lanes<2> rotation_8_p21_lanes = detail::make_pack<Real>(c8, c15) * rotation_8_p14_lanes -
      detail::make_pack<Real>(s8, s15) * rotation_8_p9;

  // link 11 (left_wrist1), pose
  const Lanes<2> rotation_5_p34_lanes = detail::make_pack<Real>(c11, c18) * rotation_5_p29_lanes +
      detail::make_pack<Real>(s11, s18) * rotation_5_p24_lanes;
  const Lanes<2> rotation_5_p35_lanes = detail::make_pack<Real>(c11, c18) * rotation_5_p24_lanes -
      detail::make_pack<Real>(s11, s18) * rotation_5_p29_lanes;

  // link 24 (right_eye), pose
  const Lanes<2> position_1_p7_lanes = position_1_p2 + detail::make_pack<Real>(0.18, (-0.18)) *
      rotation_5_p6 + 0.282 * rotation_5_p18_lanes + 0.269 * rotation_5_p30_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> rotation_2_p28_lanes = detail::make_pack<Real>(s9, s16) * rotation_2_p22_lanes +
      detail::make_pack<Real>(c9, c16) * rotation_2_p17_lanes;
  const Lanes<2> rotation_8_p26_lanes = detail::make_pack<Real>(c9, c16) * rotation_8_p15_lanes -
      detail::make_pack<Real>(s9, s16) * rotation_8_p20_lanes;
  const Lanes<2> rotation_2_p29_lanes = detail::make_pack<Real>(c9, c16) * rotation_2_p22_lanes -
      detail::make_pack<Real>(s9, s16) * rotation_2_p17_lanes;
  const Lanes<2> rotation_8_p27_lanes = detail::make_pack<Real>(c9, c16) * rotation_8_p20_lanes +
      detail::make_pack<Real>(s9, s16) * rotation_8_p15_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> rotation_5_p38_lanes = detail::make_pack<Real>(c12, c19) * rotation_5_p30_lanes -
      detail::make_pack<Real>(s12, s19) * rotation_5_p34_lanes;
  const Lanes<2> rotation_3_lanes = detail::make_pack<Real>(c12, c19) * rotation_5_p34_lanes +
      detail::make_pack<Real>(s12, s19) * rotation_5_p30_lanes;
  rotation[3] = rotation_3_lanes[0];

  // link 19 (right_wrist2), pose
  rotation[12] = rotation_3_lanes[1];

  // link 10 (left_lowerarm), pose
  const Lanes<2> rotation_2_p34_lanes = detail::make_pack<Real>(c10, c17) * rotation_2_p28_lanes +
      detail::make_pack<Real>(s10, s17) * rotation_2_p23_lanes;
  const Lanes<2> rotation_8_p32_lanes = detail::make_pack<Real>(c10, c17) * rotation_8_p26_lanes +
      detail::make_pack<Real>(s10, s17) * rotation_8_p21_lanes;
  const Lanes<2> rotation_2_p35_lanes = detail::make_pack<Real>(c10, c17) * rotation_2_p23_lanes -
      detail::make_pack<Real>(s10, s17) * rotation_2_p28_lanes;
  const Lanes<2> rotation_8_p33_lanes = detail::make_pack<Real>(c10, c17) * rotation_8_p21_lanes -
      detail::make_pack<Real>(s10, s17) * rotation_8_p26_lanes;

  // link 13 (left_hand), pose
  const Lanes<2> rotation_5_lanes = detail::make_pack<Real>(c13, c20) * rotation_5_p38_lanes +
      detail::make_pack<Real>(s13, s20) * rotation_5_p35_lanes;
  rotation[5] = -rotation_5_lanes[0];

  // link 20 (right_hand), pose
  rotation[14] = -rotation_5_lanes[1];

  // link 13 (left_hand), pose
  const Lanes<2> rotation_4_lanes = detail::make_pack<Real>(c13, c20) * rotation_5_p35_lanes -
      detail::make_pack<Real>(s13, s20) * rotation_5_p38_lanes;
  rotation[4] = rotation_4_lanes[0];

  // link 20 (right_hand), pose
  rotation[13] = rotation_4_lanes[1];

  // link 11 (left_wrist1), pose
  const Lanes<2> rotation_2_p39_lanes = detail::make_pack<Real>(c11, c18) * rotation_2_p34_lanes +
      detail::make_pack<Real>(s11, s18) * rotation_2_p29_lanes;
  const Lanes<2> rotation_8_p37_lanes = detail::make_pack<Real>(c11, c18) * rotation_8_p32_lanes -
      detail::make_pack<Real>(s11, s18) * rotation_8_p27_lanes;
  const Lanes<2> rotation_2_p40_lanes = detail::make_pack<Real>(c11, c18) * rotation_2_p29_lanes -
      detail::make_pack<Real>(s11, s18) * rotation_2_p34_lanes;
  const Lanes<2> rotation_8_p38_lanes = detail::make_pack<Real>(s11, s18) * rotation_8_p32_lanes +
      detail::make_pack<Real>(c11, c18) * rotation_8_p27_lanes;

  // link 24 (right_eye), pose
  const Lanes<2> position_0_p7_lanes = position_0_p2 + detail::make_pack<Real>(0.18, (-0.18)) *
      rotation_2_p11 + 0.282 * rotation_2_p23_lanes + 0.269 * rotation_2_p35_lanes;
  const Lanes<2> position_2_p7_lanes = position_2_p2 - detail::make_pack<Real>(0.18, (-0.18)) *
      rotation_8_p9 + 0.282 * rotation_8_p21_lanes + 0.269 * rotation_8_p33_lanes;
  const Lanes<2> position_1_lanes = position_1_p7_lanes + 0.086 * rotation_5_lanes;
  position[1] = position_1_lanes[0];
  position[4] = position_1_lanes[1];

  // link 12 (left_wrist2), pose
  const Lanes<2> rotation_2_p43_lanes = detail::make_pack<Real>(c12, c19) * rotation_2_p35_lanes -
      detail::make_pack<Real>(s12, s19) * rotation_2_p39_lanes;
  const Lanes<2> rotation_8_p41_lanes = detail::make_pack<Real>(c12, c19) * rotation_8_p33_lanes -
      detail::make_pack<Real>(s12, s19) * rotation_8_p37_lanes;
  const Lanes<2> rotation_0_lanes = detail::make_pack<Real>(c12, c19) * rotation_2_p39_lanes +
      detail::make_pack<Real>(s12, s19) * rotation_2_p35_lanes;
  rotation[0] = rotation_0_lanes[0];

  // link 19 (right_wrist2), pose
  rotation[9] = rotation_0_lanes[1];

  // link 12 (left_wrist2), pose
  const Lanes<2> rotation_6_lanes = detail::make_pack<Real>(c12, c19) * rotation_8_p37_lanes +
      detail::make_pack<Real>(s12, s19) * rotation_8_p33_lanes;
  rotation[6] = rotation_6_lanes[0];

  // link 19 (right_wrist2), pose
  rotation[15] = rotation_6_lanes[1];

  // link 13 (left_hand), pose
  const Lanes<2> rotation_2_lanes = detail::make_pack<Real>(c13, c20) * rotation_2_p43_lanes +
      detail::make_pack<Real>(s13, s20) * rotation_2_p40_lanes;
  rotation[2] = -rotation_2_lanes[0];

  // link 20 (right_hand), pose
  rotation[11] = -rotation_2_lanes[1];

  // link 13 (left_hand), pose
  const Lanes<2> rotation_8_lanes = detail::make_pack<Real>(c13, c20) * rotation_8_p41_lanes -
      detail::make_pack<Real>(s13, s20) * rotation_8_p38_lanes;
  rotation[8] = -rotation_8_lanes[0];

  // link 20 (right_hand), pose
  rotation[17] = -rotation_8_lanes[1];

  // link 13 (left_hand), pose
  const Lanes<2> rotation_1_lanes = detail::make_pack<Real>(c13, c20) * rotation_2_p40_lanes -
      detail::make_pack<Real>(s13, s20) * rotation_2_p43_lanes;
  rotation[1] = rotation_1_lanes[0];

  // link 20 (right_hand), pose
  rotation[10] = rotation_1_lanes[1];

  // link 13 (left_hand), pose
  const Lanes<2> rotation_7_lanes = detail::make_pack<Real>(s13, s20) * rotation_8_p41_lanes +
      detail::make_pack<Real>(c13, c20) * rotation_8_p38_lanes;
  rotation[7] = -rotation_7_lanes[0];

  // link 20 (right_hand), pose
  rotation[16] = -rotation_7_lanes[1];

  // link 24 (right_eye), pose
  const Lanes<2> position_0_lanes = position_0_p7_lanes + 0.086 * rotation_2_lanes;
  position[0] = position_0_lanes[0];
  position[3] = position_0_lanes[1];
  const Lanes<2> position_2_lanes = position_2_p7_lanes + 0.086 * rotation_8_lanes;
  position[2] = position_2_lanes[0];
  position[5] = position_2_lanes[1];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
