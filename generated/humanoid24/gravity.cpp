// SPDX-License-Identifier: 0BSD
// gravity: g: the joint forces that hold the robot at rest
// By recursive Newton-Euler, Chang table 4.1, alike limbs in lanes.
// 378 flops (add 152, mul 226, div 0), sine and cosine of 24 angles
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
void gravity(const Real (&TREELINE_RESTRICT q)[24], Real (&TREELINE_RESTRICT g)[24]) noexcept {
  // constants
  const Real minus_gravity_z = 9.81;
  const Real h_22_x = 0.072575;
  const Real minus_h_22_y = 0.43200000000000005;
  const Real h_21_x = 0.0045000000000000005;
  const Real minus_h_6_x = 6.1665928899999995;
  const Real h_5_x = 0.069699984375;
  const Real minus_h_5_y = 2.2194301519999997;
  const Real minus_h_4_x = 0.0300000063;
  const Real minus_h_3_y = 8.419374554;
  const Real minus_h_3_x = 0.02999999505;
  const Real h_2_x = 0.031999971599999996;
  const Real minus_h_2_y = 24.5839218;
  const Real t1 = 0.17435661841416683 + q[19];
  const Real t2 = (-0.17435661841416683) + q[12];

  // sines and cosines
  const Real angles[24] = {q[0], q[1], q[2], q[3], q[4], q[5], q[20], q[21], q[23], q[22], q[13],
      q[14], q[15], q[16], q[17], q[18], t1, q[6], q[7], q[8], q[9], q[10], q[11], t2};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real c1 = cosines[0];
  const Real s1 = sines[0];
  const Real s2 = sines[1];
  const Real c2 = cosines[1];
  const Real s3 = sines[2];
  const Real c3 = cosines[2];
  const Real c4 = cosines[3];
  const Real c5 = cosines[4];
  const Real s5 = sines[4];
  const Real s6 = sines[5];
  const Real c21 = cosines[6];
  const Real c6 = cosines[5];
  const Real s4 = sines[3];
  const Real s21 = sines[6];
  const Real s22 = sines[7];
  const Real s24 = sines[8];
  const Real c22 = cosines[7];
  const Real s23 = sines[9];
  const Real c24 = cosines[8];
  const Real c23 = cosines[9];
  const Real s14 = sines[10];
  const Real s15 = sines[11];
  const Real c14 = cosines[10];
  const Real c15 = cosines[11];
  const Real c16 = cosines[12];
  const Real c17 = cosines[13];
  const Real s16 = sines[12];
  const Real c18 = cosines[14];
  const Real s17 = sines[13];
  const Real c19 = cosines[15];
  const Real s18 = sines[14];
  const Real s20 = sines[16];
  const Real s19 = sines[15];
  const Real c20 = cosines[16];
  const Real s7 = sines[17];
  const Real s8 = sines[18];
  const Real c7 = cosines[17];
  const Real c8 = cosines[18];
  const Real c9 = cosines[19];
  const Real c10 = cosines[20];
  const Real s9 = sines[19];
  const Real c11 = cosines[21];
  const Real s10 = sines[20];
  const Real c12 = cosines[22];
  const Real s11 = sines[21];
  const Real s13 = sines[23];
  const Real s12 = sines[22];
  const Real c13 = cosines[23];

  // links 1 to 3, outward
  const Real minus_a1_x = minus_gravity_z * s1;
  const Real minus_a1_y = minus_gravity_z * c1;
  const Real minus_a2_x = c2 * minus_a1_x + s2 * minus_a1_y;
  const Real a2_y = s2 * minus_a1_x - c2 * minus_a1_y;
  const Real a3_x = s3 * a2_y - c3 * minus_a2_x;
  const Real a3_y = s3 * minus_a2_x + c3 * a2_y;

  // links 4 to 6, outward
  const Real a4_x = c4 * a3_x;
  const Real minus_a4_y = s4 * a3_x;
  const Real a5_y = c5 * a3_y - s5 * a4_x;
  const Real a5_x = c5 * a4_x + s5 * a3_y;
  const Real a6_x = c6 * a5_y - s6 * minus_a4_y;
  const Real minus_a6_y = s6 * a5_y + c6 * minus_a4_y;

  // link 7 (left_shoulder1), inertial wrench; links 7, 14, 21, outward
  const Real t9 = 0.0017499999999999998 * minus_a6_y;
  const Lanes<2> a7_14_y_lanes = detail::make_pack<Real>(c7, c14) * a6_x -
      detail::make_pack<Real>(s7, s14) * a5_x;
  const Lanes<2> a7_14_x_lanes = detail::make_pack<Real>(s7, s14) * a6_x +
      detail::make_pack<Real>(c7, c14) * a5_x;
  const Real a21_x = c21 * a5_x - s21 * minus_a6_y;
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a5_x;

  // links 8, 15, 22, outward; link 23 (left_eye), inertial wrench
  const Lanes<2> minus_a8_15_y_lanes = detail::make_pack<Real>(s8, s15) * a7_14_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a6_y;
  const Lanes<2> a8_15_x_lanes = detail::make_pack<Real>(c8, c15) * a7_14_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a6_y;
  const Real a22_x = c22 * a21_x + s22 * a6_x;
  const Real a22_y = c22 * a6_x - s22 * a21_x;
  const Real n24_y = 0.00025 * a22_y;

  // links 9, 16, 23 and 24, outward; links 23 (left_eye) and 24 (right_eye), inertial wrench
  const Lanes<2> a9_16_x_lanes = detail::make_pack<Real>(c9, c16) * a7_14_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_15_y_lanes;
  const Lanes<2> minus_a9_16_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_15_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_14_x_lanes;
  const Lanes<2> minus_a23_24_y_lanes = detail::make_pack<Real>(s23, s24) * a22_x +
      detail::make_pack<Real>(c23, c24) * minus_a21_y;
  const Lanes<2> minus_n23_24_z_lanes = 0.00025 * minus_a23_24_y_lanes;
  g[22] = -minus_n23_24_z_lanes[0];
  g[23] = -minus_n23_24_z_lanes[1];

  // link 23 (left_eye), inward; links 10 (left_lowerarm) and 17 (right_lowerarm), outward
  const Real n22_x = minus_h_22_y * minus_a21_y - (s24 + s23) * n24_y;
  const Real n22_z = h_22_x * a22_y + minus_h_22_y * a22_x + (c24 + c23) * n24_y;
  g[21] = n22_z;
  const Lanes<2> a10_17_x_lanes = detail::make_pack<Real>(c10, c17) * a9_16_x_lanes +
      detail::make_pack<Real>(s10, s17) * a8_15_x_lanes;
  const Lanes<2> a10_17_y_lanes = detail::make_pack<Real>(c10, c17) * a8_15_x_lanes -
      detail::make_pack<Real>(s10, s17) * a9_16_x_lanes;

  // links 22 (head) and 23 (left_eye), inward; links 11 (left_wrist1) and 18 (right_wrist1),
  //   outward
  const Real n21_y = h_21_x * a6_x + n22_z;
  const Real n22_y = h_22_x * minus_a21_y + minus_n23_24_z_lanes[1] + minus_n23_24_z_lanes[0];
  const Lanes<2> a11_18_x_lanes = detail::make_pack<Real>(c11, c18) * a10_17_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a9_16_y_lanes;
  const Lanes<2> minus_a11_18_y_lanes = detail::make_pack<Real>(s11, s18) * a10_17_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a9_16_y_lanes;
  const Real minus_n21_x = s22 * n22_y - c22 * n22_x;

  // links 12 (left_wrist2) and 19 (right_wrist2), outward; links 11 (left_wrist1) and 18
  //   (right_wrist1), inertial wrench; link 22 (head), inward
  const Lanes<2> a12_19_y_lanes = detail::make_pack<Real>(c12, c19) * a10_17_y_lanes -
      detail::make_pack<Real>(s12, s19) * a11_18_x_lanes;
  const Lanes<2> a12_19_x_lanes = detail::make_pack<Real>(c12, c19) * a11_18_x_lanes +
      detail::make_pack<Real>(s12, s19) * a10_17_y_lanes;
  const Lanes<2> t54_lanes = 6e-04 * minus_a11_18_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_18_x_lanes;
  const Real minus_n21_z = h_21_x * minus_a21_y + (s22 * n22_x + c22 * n22_y);
  g[20] = -minus_n21_z;

  // links 13 (left_hand) and 20 (right_hand), inertial wrench and outward
  const Lanes<2> minus_n13_20_y_lanes = 0.0165153994048813 * a12_19_x_lanes;
  const Lanes<2> minus_a13_20_y_lanes = detail::make_pack<Real>(s13, s20) * a12_19_y_lanes +
      detail::make_pack<Real>(c13, c20) * minus_a11_18_y_lanes;
  const Lanes<2> minus_n13_20_z_lanes = 0.0165153994048813 * minus_a13_20_y_lanes;
  g[12] = -minus_n13_20_z_lanes[0];
  g[19] = -minus_n13_20_z_lanes[1];

  // links 13 (left_hand) and 20 (right_hand), inward
  const Lanes<2> n12_19_y_lanes = 0.0025100003499999995 * minus_a11_18_y_lanes +
      detail::make_pack<Real>(s13, s20) * minus_n13_20_y_lanes;
  const Lanes<2> n12_19_z_lanes = 0.0025100003499999995 * a12_19_y_lanes - 0.0006000000000000001 *
      a12_19_x_lanes - detail::make_pack<Real>(c13, c20) * minus_n13_20_y_lanes;
  g[11] = n12_19_z_lanes[0];
  g[18] = n12_19_z_lanes[1];
  const Lanes<2> minus_n12_19_x_lanes = 0.0006000000000000001 * minus_a11_18_y_lanes +
      minus_n13_20_z_lanes;

  // links 12 (left_wrist2) and 19 (right_wrist2), inward
  const Lanes<2> n11_18_y_lanes = 6e-04 * a10_17_y_lanes + n12_19_z_lanes;
  const Lanes<2> minus_n11_18_x_lanes = detail::make_pack<Real>(0.001, (-0.001)) * a10_17_y_lanes +
      (detail::make_pack<Real>(c12, c19) * minus_n12_19_x_lanes +
      detail::make_pack<Real>(s12, s19) * n12_19_y_lanes);
  const Lanes<2> n11_18_z_lanes = detail::make_pack<Real>(s12, s19) * minus_n12_19_x_lanes -
      detail::make_pack<Real>(c12, c19) * n12_19_y_lanes - t54_lanes;
  g[10] = n11_18_z_lanes[0];
  g[17] = n11_18_z_lanes[1];

  // links 11 (left_wrist1) and 18 (right_wrist1), inward
  const Lanes<2> n10_17_y_lanes = 0.0014999985000000002 * minus_a9_16_y_lanes - n11_18_z_lanes;
  const Lanes<2> t74_lanes = detail::make_pack<Real>(c11, c18) * n11_18_y_lanes -
      detail::make_pack<Real>(s11, s18) * minus_n11_18_x_lanes;
  const Lanes<2> minus_n10_17_x_lanes = 0.28049749700000004 * minus_a9_16_y_lanes +
      (detail::make_pack<Real>(c11, c18) * minus_n11_18_x_lanes +
      detail::make_pack<Real>(s11, s18) * n11_18_y_lanes);
  const Lanes<2> n10_17_z_lanes = 0.0014999985000000002 * a10_17_y_lanes - 0.28049749700000004 *
      a10_17_x_lanes + t74_lanes;
  g[9] = n10_17_z_lanes[0];
  g[16] = n10_17_z_lanes[1];

  // links 10 (left_lowerarm) and 17 (right_lowerarm), inward
  const Lanes<2> n9_16_y_lanes = n10_17_z_lanes - 0.0022500062 * a8_15_x_lanes;
  const Lanes<2> t80_lanes = detail::make_pack<Real>(s10, s17) * minus_n10_17_x_lanes -
      detail::make_pack<Real>(c10, c17) * n10_17_y_lanes;
  const Lanes<2> minus_n9_16_x_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      a8_15_x_lanes + (detail::make_pack<Real>(c10, c17) * minus_n10_17_x_lanes +
      detail::make_pack<Real>(s10, s17) * n10_17_y_lanes);
  const Lanes<2> n9_16_z_lanes = 0.0022500062 * minus_a9_16_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_16_x_lanes + t80_lanes;
  g[8] = n9_16_z_lanes[0];
  g[15] = n9_16_z_lanes[1];

  // links 9 (left_upperarm) and 16 (right_upperarm), inward
  const Lanes<2> n8_15_x_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_14_x_lanes - n9_16_z_lanes;
  const Lanes<2> t86_lanes = detail::make_pack<Real>(c9, c16) * minus_n9_16_x_lanes +
      detail::make_pack<Real>(s9, s16) * n9_16_y_lanes;
  const Lanes<2> minus_n8_15_y_lanes = 0.7139200499999999 * a7_14_x_lanes +
      (detail::make_pack<Real>(s9, s16) * minus_n9_16_x_lanes - detail::make_pack<Real>(c9, c16) *
      n9_16_y_lanes);
  const Lanes<2> minus_n8_15_z_lanes = 0.7139200499999999 * minus_a8_15_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_15_x_lanes +
      t86_lanes;
  g[7] = -minus_n8_15_z_lanes[0];
  g[14] = -minus_n8_15_z_lanes[1];

  // links 8 (left_shoulder2) and 15 (right_shoulder2), inward
  const Lanes<2> n7_14_x_lanes = t9 - minus_n8_15_z_lanes;
  const Lanes<2> n7_14_y_lanes = t9 + (detail::make_pack<Real>(c8, c15) * n8_15_x_lanes +
      detail::make_pack<Real>(s8, s15) * minus_n8_15_y_lanes);
  const Lanes<2> n7_14_z_lanes = detail::make_pack<Real>(s8, s15) * n8_15_x_lanes -
      detail::make_pack<Real>(c8, c15) * minus_n8_15_y_lanes + 0.0017499999999999998 *
      (a7_14_y_lanes + a7_14_x_lanes);
  g[6] = n7_14_z_lanes[0];
  g[13] = n7_14_z_lanes[1];

  // links 7 (left_shoulder1) and 14 (right_shoulder1), inward
  const Real n6_y = minus_h_6_x * a5_x - (s21 * minus_n21_x - c21 * n21_y) + n7_14_z_lanes[1] +
      n7_14_z_lanes[0];
  const Lanes<2> t95_lanes = detail::make_pack<Real>(s7, s14) * n7_14_x_lanes +
      detail::make_pack<Real>(c7, c14) * n7_14_y_lanes;
  const Lanes<2> t96_lanes = detail::make_pack<Real>(c7, c14) * n7_14_x_lanes -
      detail::make_pack<Real>(s7, s14) * n7_14_y_lanes;
  const Real n6_x = minus_n21_z + t95_lanes[1] + t95_lanes[0];
  const Real n6_z = minus_h_6_x * minus_a6_y - (c21 * minus_n21_x + s21 * n21_y) + t96_lanes[1] +
      t96_lanes[0];
  g[5] = n6_z;

  // links 5 (chest2) and 6 (chest3), inward
  const Real n5_x = minus_h_5_y * minus_a4_y + n6_z;
  const Real n5_y = h_5_x * minus_a4_y + (c6 * n6_x - s6 * n6_y);
  const Real n5_z = h_5_x * a5_y + minus_h_5_y * a5_x + (s6 * n6_x + c6 * n6_y);
  g[4] = n5_z;
  const Real n4_y = n5_z - minus_h_4_x * a3_y;
  const Real minus_n4_x = s5 * n5_y - c5 * n5_x;
  const Real n4_z = minus_h_4_x * minus_a4_y - (s5 * n5_x + c5 * n5_y);
  g[3] = n4_z;

  // links 2 to 4, inward
  const Real n3_z = minus_h_3_y * a3_x - minus_h_3_x * a3_y + (c4 * n4_y - s4 * minus_n4_x);
  g[2] = n3_z;
  const Real n2_z = h_2_x * a2_y - minus_h_2_y * minus_a2_x + n3_z;
  g[1] = n2_z;
  const Real n1_z = 0.1569597827085 * c1 - 299.6743959432 * s1 + n2_z;
  g[0] = n1_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
