// SPDX-License-Identifier: 0BSD
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
  // constants
  const Real minus_link1_to_2_y = 0.434;
  const Real minus_link2_to_3_y = 0.422;
  const Real link4_to_5_z = 0.21799999999999997;
  const Real minus_link5_to_6_y = 0.072;
  const Real base_to_1_z = 0.07;

  // sines and cosines
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
  const Real t1 = s5 * s4;
  const Real t2 = c5 * s4;
  const Real p2_x = minus_link1_to_2_y * s1;
  const Real minus_c1_plus_2 = s1 * s2 - c1 * c2;
  const Real s1_plus_2 = s1 * c2 + c1 * s2;

  // links 3 (hip) and 6 (chest3), pose
  const Real p6_y = minus_link5_to_6_y * t1;
  const Real t5 = s6 * c4 - c6 * t1;
  const Real t6 = s6 * t1 + c6 * c4;
  const Real minus_c1_plus_2_plus_3 = minus_c1_plus_2 * c3 + s1_plus_2 * s3;
  const Real minus_s1_plus_2_plus_3 = minus_c1_plus_2 * s3 - s1_plus_2 * c3;
  const Real p3_x = p2_x + minus_link2_to_3_y * s1_plus_2;

  // links 4, 7, 14, pose
  const Real t12 = c4 * minus_c1_plus_2_plus_3;
  const Real t13 = c4 * minus_s1_plus_2_plus_3;
  const Real t14 = s4 * minus_c1_plus_2_plus_3;
  const Real t15 = s4 * minus_s1_plus_2_plus_3;
  const Lanes<2> t16_lanes = detail::make_pack<Real>(c7, c14) * t5 -
      detail::make_pack<Real>(s7, s14) * t2;
  const Lanes<2> t17_lanes = detail::make_pack<Real>(s7, s14) * t5 +
      detail::make_pack<Real>(c7, c14) * t2;

  // links 5 (chest2) and 24 (right_eye), pose
  const Real t18 = p6_y - 0.226 * t5;
  const Real p5_x = p3_x - link4_to_5_z * minus_s1_plus_2_plus_3;
  const Real t24 = s5 * t12 + c5 * minus_s1_plus_2_plus_3;
  const Real t25 = c5 * minus_c1_plus_2_plus_3 - s5 * t13;
  const Real t26 = s5 * minus_s1_plus_2_plus_3 - c5 * t12;
  const Real t27 = c5 * t13 + s5 * minus_c1_plus_2_plus_3;

  // links 2, 6, 8, 15, pose
  const Lanes<2> t28_lanes = detail::make_pack<Real>(c8, c15) * t6 -
      detail::make_pack<Real>(s8, s15) * t16_lanes;
  const Lanes<2> t29_lanes = detail::make_pack<Real>(c8, c15) * t16_lanes +
      detail::make_pack<Real>(s8, s15) * t6;
  const Real p2_z = base_to_1_z + minus_link1_to_2_y * c1;
  const Real t39 = c6 * t24 + s6 * t14;
  const Real t40 = c6 * t25 - s6 * t15;
  const Real t41 = c6 * t14 - s6 * t24;

  // links 3, 5 and 6, 9, 16, pose
  const Real t42 = s6 * t25 + c6 * t15;
  const Lanes<2> t43_lanes = detail::make_pack<Real>(s9, s16) * t28_lanes +
      detail::make_pack<Real>(c9, c16) * t17_lanes;
  const Lanes<2> t44_lanes = detail::make_pack<Real>(c9, c16) * t28_lanes -
      detail::make_pack<Real>(s9, s16) * t17_lanes;
  const Real p3_z = p2_z - minus_link2_to_3_y * minus_c1_plus_2;
  const Real p5_z = p3_z - link4_to_5_z * minus_c1_plus_2_plus_3;

  // links 6 and 7, 14, pose
  const Real p6_x = p5_x - minus_link5_to_6_y * t24;
  const Lanes<2> t57_lanes = detail::make_pack<Real>(c7, c14) * t39 -
      detail::make_pack<Real>(s7, s14) * t26;
  const Lanes<2> t58_lanes = detail::make_pack<Real>(c7, c14) * t40 -
      detail::make_pack<Real>(s7, s14) * t27;
  const Lanes<2> t59_lanes = detail::make_pack<Real>(s7, s14) * t39 +
      detail::make_pack<Real>(c7, c14) * t26;
  const Lanes<2> t61_lanes = detail::make_pack<Real>(s7, s14) * t40 +
      detail::make_pack<Real>(c7, c14) * t27;

  // links 6, 10, 17, 24, pose
  const Lanes<2> t64_lanes = detail::make_pack<Real>(c10, c17) * t43_lanes +
      detail::make_pack<Real>(s10, s17) * t29_lanes;
  const Lanes<2> t65_lanes = detail::make_pack<Real>(c10, c17) * t29_lanes -
      detail::make_pack<Real>(s10, s17) * t43_lanes;
  const Real p6_z = p5_z - minus_link5_to_6_y * t25;
  const Real t77 = p6_x - 0.226 * t39;
  const Real t78 = p6_z - 0.226 * t40;

  // links 8, 11, 15, 18, pose
  const Lanes<2> t81_lanes = detail::make_pack<Real>(c8, c15) * t41 -
      detail::make_pack<Real>(s8, s15) * t57_lanes;
  const Lanes<2> t82_lanes = detail::make_pack<Real>(s8, s15) * t58_lanes +
      detail::make_pack<Real>(c8, c15) * t42;
  const Lanes<2> t83_lanes = detail::make_pack<Real>(c8, c15) * t57_lanes +
      detail::make_pack<Real>(s8, s15) * t41;
  const Lanes<2> t84_lanes = detail::make_pack<Real>(c8, c15) * t58_lanes -
      detail::make_pack<Real>(s8, s15) * t42;
  const Lanes<2> t86_lanes = detail::make_pack<Real>(c11, c18) * t64_lanes +
      detail::make_pack<Real>(s11, s18) * t44_lanes;
  const Lanes<2> t87_lanes = detail::make_pack<Real>(c11, c18) * t44_lanes -
      detail::make_pack<Real>(s11, s18) * t64_lanes;

  // links 9, 16, 24, pose
  const Lanes<2> t103_lanes = t18 + detail::make_pack<Real>(0.18, (-0.18)) * t6 + 0.282 *
      t29_lanes + 0.269 * t65_lanes;
  const Lanes<2> t104_lanes = detail::make_pack<Real>(s9, s16) * t81_lanes +
      detail::make_pack<Real>(c9, c16) * t59_lanes;
  const Lanes<2> t105_lanes = detail::make_pack<Real>(c9, c16) * t61_lanes -
      detail::make_pack<Real>(s9, s16) * t82_lanes;
  const Lanes<2> t106_lanes = detail::make_pack<Real>(c9, c16) * t81_lanes -
      detail::make_pack<Real>(s9, s16) * t59_lanes;
  const Lanes<2> t107_lanes = detail::make_pack<Real>(c9, c16) * t82_lanes +
      detail::make_pack<Real>(s9, s16) * t61_lanes;

  // links 10, 12, 17, 19, pose
  const Lanes<2> t108_lanes = detail::make_pack<Real>(c12, c19) * t65_lanes -
      detail::make_pack<Real>(s12, s19) * t86_lanes;
  const Lanes<2> rotation_3_12_lanes = detail::make_pack<Real>(c12, c19) * t86_lanes +
      detail::make_pack<Real>(s12, s19) * t65_lanes;
  rotation[3] = rotation_3_12_lanes[0];
  rotation[12] = rotation_3_12_lanes[1];
  const Lanes<2> t121_lanes = detail::make_pack<Real>(c10, c17) * t104_lanes +
      detail::make_pack<Real>(s10, s17) * t83_lanes;
  const Lanes<2> t122_lanes = detail::make_pack<Real>(c10, c17) * t105_lanes +
      detail::make_pack<Real>(s10, s17) * t84_lanes;
  const Lanes<2> t123_lanes = detail::make_pack<Real>(c10, c17) * t83_lanes -
      detail::make_pack<Real>(s10, s17) * t104_lanes;
  const Lanes<2> t124_lanes = detail::make_pack<Real>(c10, c17) * t84_lanes -
      detail::make_pack<Real>(s10, s17) * t105_lanes;

  // links 13 (left_hand) and 20 (right_hand), pose
  const Lanes<2> rotation_5_14_lanes = detail::make_pack<Real>(c13, c20) * t108_lanes +
      detail::make_pack<Real>(s13, s20) * t87_lanes;
  rotation[5] = -rotation_5_14_lanes[0];
  rotation[14] = -rotation_5_14_lanes[1];
  const Lanes<2> rotation_4_13_lanes = detail::make_pack<Real>(c13, c20) * t87_lanes -
      detail::make_pack<Real>(s13, s20) * t108_lanes;
  rotation[4] = rotation_4_13_lanes[0];
  rotation[13] = rotation_4_13_lanes[1];

  // links 11, 18, 24, pose
  const Lanes<2> t136_lanes = detail::make_pack<Real>(c11, c18) * t121_lanes +
      detail::make_pack<Real>(s11, s18) * t106_lanes;
  const Lanes<2> t137_lanes = detail::make_pack<Real>(c11, c18) * t122_lanes -
      detail::make_pack<Real>(s11, s18) * t107_lanes;
  const Lanes<2> t138_lanes = detail::make_pack<Real>(c11, c18) * t106_lanes -
      detail::make_pack<Real>(s11, s18) * t121_lanes;
  const Lanes<2> t139_lanes = detail::make_pack<Real>(s11, s18) * t122_lanes +
      detail::make_pack<Real>(c11, c18) * t107_lanes;
  const Lanes<2> t140_lanes = t77 + detail::make_pack<Real>(0.18, (-0.18)) * t41 + 0.282 *
      t83_lanes + 0.269 * t123_lanes;
  const Lanes<2> t141_lanes = t78 - detail::make_pack<Real>(0.18, (-0.18)) * t42 + 0.282 *
      t84_lanes + 0.269 * t124_lanes;
  const Lanes<2> position_1_4_lanes = t103_lanes + 0.086 * rotation_5_14_lanes;
  position[1] = position_1_4_lanes[0];
  position[4] = position_1_4_lanes[1];

  // links 12 (left_wrist2) and 19 (right_wrist2), pose
  const Lanes<2> t150_lanes = detail::make_pack<Real>(c12, c19) * t123_lanes -
      detail::make_pack<Real>(s12, s19) * t136_lanes;
  const Lanes<2> t151_lanes = detail::make_pack<Real>(c12, c19) * t124_lanes -
      detail::make_pack<Real>(s12, s19) * t137_lanes;
  const Lanes<2> rotation_0_9_lanes = detail::make_pack<Real>(c12, c19) * t136_lanes +
      detail::make_pack<Real>(s12, s19) * t123_lanes;
  rotation[0] = rotation_0_9_lanes[0];
  rotation[9] = rotation_0_9_lanes[1];
  const Lanes<2> rotation_6_15_lanes = detail::make_pack<Real>(c12, c19) * t137_lanes +
      detail::make_pack<Real>(s12, s19) * t124_lanes;
  rotation[6] = rotation_6_15_lanes[0];
  rotation[15] = rotation_6_15_lanes[1];

  // links 13 (left_hand) and 20 (right_hand), pose
  const Lanes<2> rotation_2_11_lanes = detail::make_pack<Real>(c13, c20) * t150_lanes +
      detail::make_pack<Real>(s13, s20) * t138_lanes;
  rotation[2] = -rotation_2_11_lanes[0];
  rotation[11] = -rotation_2_11_lanes[1];
  const Lanes<2> rotation_8_17_lanes = detail::make_pack<Real>(c13, c20) * t151_lanes -
      detail::make_pack<Real>(s13, s20) * t139_lanes;
  rotation[8] = -rotation_8_17_lanes[0];
  rotation[17] = -rotation_8_17_lanes[1];
  const Lanes<2> rotation_1_10_lanes = detail::make_pack<Real>(c13, c20) * t138_lanes -
      detail::make_pack<Real>(s13, s20) * t150_lanes;
  rotation[1] = rotation_1_10_lanes[0];
  rotation[10] = rotation_1_10_lanes[1];
  const Lanes<2> rotation_7_16_lanes = detail::make_pack<Real>(s13, s20) * t151_lanes +
      detail::make_pack<Real>(c13, c20) * t139_lanes;
  rotation[7] = -rotation_7_16_lanes[0];
  rotation[16] = -rotation_7_16_lanes[1];

  // link 24 (right_eye), pose
  const Lanes<2> position_0_3_lanes = t140_lanes + 0.086 * rotation_2_11_lanes;
  position[0] = position_0_3_lanes[0];
  position[3] = position_0_3_lanes[1];
  const Lanes<2> position_2_5_lanes = t141_lanes + 0.086 * rotation_8_17_lanes;
  position[2] = position_2_5_lanes[0];
  position[5] = position_2_5_lanes[1];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
