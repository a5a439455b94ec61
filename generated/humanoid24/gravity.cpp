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
  const Real s20_p1 = 0.17435661841416683 + q[19];
  const Real s13_p1 = (-0.17435661841416683) + q[12];
  const Real angles[24] = {q[0], q[1], q[2], q[3], q[4], q[5], q[20], q[21], q[23], q[22], q[13],
      q[14], q[15], q[16], q[17], q[18], s20_p1, q[6], q[7], q[8], q[9], q[10], q[11], s13_p1};
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

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;
  const Real minus_a1_y = 9.81 * c1;

  // link 2 (thigh), outward
  const Real minus_a2_x = c2 * minus_a1_x + s2 * minus_a1_y;
  const Real a2_y = s2 * minus_a1_x - c2 * minus_a1_y;

  // link 3 (hip), outward
  const Real a3_x = s3 * a2_y - c3 * minus_a2_x;
  const Real a3_y = s3 * minus_a2_x + c3 * a2_y;

  // link 4 (chest1), outward
  const Real a4_x = c4 * a3_x;
  const Real minus_a4_y = s4 * a3_x;

  // link 5 (chest2), outward
  const Real a5_y = c5 * a3_y - s5 * a4_x;
  const Real a5_x = c5 * a4_x + s5 * a3_y;

  // link 6 (chest3), outward
  const Real a6_x = c6 * a5_y - s6 * minus_a4_y;
  const Real minus_a6_y = s6 * a5_y + c6 * minus_a4_y;

  // link 7 (left_shoulder1), inertial wrench
  const Real n7_x_p1 = 0.0017499999999999998 * minus_a6_y;

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_lanes = detail::make_pack<Real>(c7, c14) * a6_x -
      detail::make_pack<Real>(s7, s14) * a5_x;
  const Lanes<2> a7_x_lanes = detail::make_pack<Real>(s7, s14) * a6_x +
      detail::make_pack<Real>(c7, c14) * a5_x;

  // link 21 (neck), outward
  const Real a21_x = c21 * a5_x - s21 * minus_a6_y;
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a5_x;

  // link 8 (left_shoulder2), outward
  const Lanes<2> minus_a8_y_lanes = detail::make_pack<Real>(s8, s15) * a7_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a6_y;
  const Lanes<2> a8_x_lanes = detail::make_pack<Real>(c8, c15) * a7_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a6_y;

  // link 22 (head), outward
  const Real a22_x = c22 * a21_x + s22 * a6_x;
  const Real a22_y = c22 * a6_x - s22 * a21_x;

  // link 23 (left_eye), inertial wrench
  const Real n24_y = 0.00025 * a22_y;

  // link 9 (left_upperarm), outward
  const Lanes<2> a9_x_lanes = detail::make_pack<Real>(c9, c16) * a7_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_y_lanes;
  const Lanes<2> minus_a9_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_x_lanes;

  // link 23 (left_eye), outward
  const Lanes<2> minus_a23_y_lanes = detail::make_pack<Real>(s23, s24) * a22_x +
      detail::make_pack<Real>(c23, c24) * minus_a21_y;

  // link 23 (left_eye), inertial wrench
  const Lanes<2> minus_n23_z_lanes = 0.00025 * minus_a23_y_lanes;
  g[22] = -minus_n23_z_lanes[0];

  // link 24 (right_eye), inertial wrench
  g[23] = -minus_n23_z_lanes[1];

  // link 23 (left_eye), inward
  const Real n22_x = 0.43200000000000005 * minus_a21_y - (s24 + s23) * n24_y;
  const Real n22_z = 0.072575 * a22_y + 0.43200000000000005 * a22_x + (c24 + c23) * n24_y;
  g[21] = n22_z;

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_lanes = detail::make_pack<Real>(c10, c17) * a9_x_lanes +
      detail::make_pack<Real>(s10, s17) * a8_x_lanes;
  const Lanes<2> a10_y_lanes = detail::make_pack<Real>(c10, c17) * a8_x_lanes -
      detail::make_pack<Real>(s10, s17) * a9_x_lanes;

  // link 22 (head), inward
  const Real n21_y = 0.0045000000000000005 * a6_x + n22_z;

  // link 23 (left_eye), inward
  const Real n22_y = 0.072575 * minus_a21_y + minus_n23_z_lanes[1] + minus_n23_z_lanes[0];

  // link 11 (left_wrist1), outward
  const Lanes<2> a11_x_lanes = detail::make_pack<Real>(c11, c18) * a10_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a9_y_lanes;
  const Lanes<2> minus_a11_y_lanes = detail::make_pack<Real>(s11, s18) * a10_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a9_y_lanes;

  // link 22 (head), inward
  const Real minus_n21_x = s22 * n22_y - c22 * n22_x;

  // link 12 (left_wrist2), outward
  const Lanes<2> a12_y_lanes = detail::make_pack<Real>(c12, c19) * a10_y_lanes -
      detail::make_pack<Real>(s12, s19) * a11_x_lanes;
  const Lanes<2> a12_x_lanes = detail::make_pack<Real>(c12, c19) * a11_x_lanes +
      detail::make_pack<Real>(s12, s19) * a10_y_lanes;

  // link 11 (left_wrist1), inertial wrench
  const Lanes<2> n11_z_p3_lanes = 6e-04 * minus_a11_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_x_lanes;

  // link 22 (head), inward
  const Real minus_n21_z = 0.0045000000000000005 * minus_a21_y + (s22 * n22_x + c22 * n22_y);
  g[20] = -minus_n21_z;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> minus_n13_y_lanes = 0.0165153994048813 * a12_x_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> minus_a13_y_lanes = detail::make_pack<Real>(s13, s20) * a12_y_lanes +
      detail::make_pack<Real>(c13, c20) * minus_a11_y_lanes;

  // link 13 (left_hand), inertial wrench
  const Lanes<2> minus_n13_z_lanes = 0.0165153994048813 * minus_a13_y_lanes;
  g[12] = -minus_n13_z_lanes[0];

  // link 20 (right_hand), inertial wrench
  g[19] = -minus_n13_z_lanes[1];

  // link 13 (left_hand), inward
  const Lanes<2> n12_y_lanes = 0.0025100003499999995 * minus_a11_y_lanes +
      detail::make_pack<Real>(s13, s20) * minus_n13_y_lanes;
  const Lanes<2> n12_z_lanes = 0.0025100003499999995 * a12_y_lanes - 0.0006000000000000001 *
      a12_x_lanes - detail::make_pack<Real>(c13, c20) * minus_n13_y_lanes;
  g[11] = n12_z_lanes[0];

  // link 20 (right_hand), inward
  g[18] = n12_z_lanes[1];

  // link 13 (left_hand), inward
  const Lanes<2> minus_n12_x_lanes = 0.0006000000000000001 * minus_a11_y_lanes + minus_n13_z_lanes;

  // link 12 (left_wrist2), inward
  const Lanes<2> n11_y_lanes = 6e-04 * a10_y_lanes + n12_z_lanes;
  const Lanes<2> minus_n11_x_lanes = detail::make_pack<Real>(0.001, (-0.001)) * a10_y_lanes +
      (detail::make_pack<Real>(c12, c19) * minus_n12_x_lanes + detail::make_pack<Real>(s12, s19) *
      n12_y_lanes);
  const Lanes<2> n11_z_lanes = detail::make_pack<Real>(s12, s19) * minus_n12_x_lanes -
      detail::make_pack<Real>(c12, c19) * n12_y_lanes - n11_z_p3_lanes;
  g[10] = n11_z_lanes[0];

  // link 19 (right_wrist2), inward
  g[17] = n11_z_lanes[1];

  // link 11 (left_wrist1), inward
  const Lanes<2> n10_y_lanes = 0.0014999985000000002 * minus_a9_y_lanes - n11_z_lanes;
  const Lanes<2> n10_z_p6_lanes = detail::make_pack<Real>(c11, c18) * n11_y_lanes -
      detail::make_pack<Real>(s11, s18) * minus_n11_x_lanes;
  const Lanes<2> minus_n10_x_lanes = 0.28049749700000004 * minus_a9_y_lanes +
      (detail::make_pack<Real>(c11, c18) * minus_n11_x_lanes + detail::make_pack<Real>(s11, s18) *
      n11_y_lanes);
  const Lanes<2> n10_z_lanes = 0.0014999985000000002 * a10_y_lanes - 0.28049749700000004 *
      a10_x_lanes + n10_z_p6_lanes;
  g[9] = n10_z_lanes[0];

  // link 18 (right_wrist1), inward
  g[16] = n10_z_lanes[1];

  // link 10 (left_lowerarm), inward
  const Lanes<2> n9_y_lanes = n10_z_lanes - 0.0022500062 * a8_x_lanes;
  const Lanes<2> n9_z_p6_lanes = detail::make_pack<Real>(s10, s17) * minus_n10_x_lanes -
      detail::make_pack<Real>(c10, c17) * n10_y_lanes;
  const Lanes<2> minus_n9_x_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      a8_x_lanes + (detail::make_pack<Real>(c10, c17) * minus_n10_x_lanes +
      detail::make_pack<Real>(s10, s17) * n10_y_lanes);
  const Lanes<2> n9_z_lanes = 0.0022500062 * minus_a9_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_x_lanes + n9_z_p6_lanes;
  g[8] = n9_z_lanes[0];

  // link 17 (right_lowerarm), inward
  g[15] = n9_z_lanes[1];

  // link 9 (left_upperarm), inward
  const Lanes<2> n8_x_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_x_lanes - n9_z_lanes;
  const Lanes<2> minus_n8_z_p6_lanes = detail::make_pack<Real>(c9, c16) * minus_n9_x_lanes +
      detail::make_pack<Real>(s9, s16) * n9_y_lanes;
  const Lanes<2> minus_n8_y_lanes = 0.7139200499999999 * a7_x_lanes +
      (detail::make_pack<Real>(s9, s16) * minus_n9_x_lanes - detail::make_pack<Real>(c9, c16) *
      n9_y_lanes);
  const Lanes<2> minus_n8_z_lanes = 0.7139200499999999 * minus_a8_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_x_lanes +
      minus_n8_z_p6_lanes;
  g[7] = -minus_n8_z_lanes[0];

  // link 16 (right_upperarm), inward
  g[14] = -minus_n8_z_lanes[1];

  // link 8 (left_shoulder2), inward
  const Lanes<2> n7_x_lanes = n7_x_p1 - minus_n8_z_lanes;
  const Lanes<2> n7_y_lanes = n7_x_p1 + (detail::make_pack<Real>(c8, c15) * n8_x_lanes +
      detail::make_pack<Real>(s8, s15) * minus_n8_y_lanes);
  const Lanes<2> n7_z_lanes = detail::make_pack<Real>(s8, s15) * n8_x_lanes -
      detail::make_pack<Real>(c8, c15) * minus_n8_y_lanes + 0.0017499999999999998 *
      (a7_y_lanes + a7_x_lanes);
  g[6] = n7_z_lanes[0];

  // link 15 (right_shoulder2), inward
  g[13] = n7_z_lanes[1];

  // link 7 (left_shoulder1), inward
  const Real n6_y = 6.1665928899999995 * a5_x - (s21 * minus_n21_x - c21 * n21_y) + n7_z_lanes[1] +
      n7_z_lanes[0];
  const Lanes<2> n6_x_p5_lanes = detail::make_pack<Real>(s7, s14) * n7_x_lanes +
      detail::make_pack<Real>(c7, c14) * n7_y_lanes;
  const Lanes<2> n6_z_p5_lanes = detail::make_pack<Real>(c7, c14) * n7_x_lanes -
      detail::make_pack<Real>(s7, s14) * n7_y_lanes;
  const Real n6_x = minus_n21_z + n6_x_p5_lanes[1] + n6_x_p5_lanes[0];
  const Real n6_z = 6.1665928899999995 * minus_a6_y - (c21 * minus_n21_x + s21 * n21_y) +
      n6_z_p5_lanes[1] + n6_z_p5_lanes[0];
  g[5] = n6_z;

  // link 6 (chest3), inward
  const Real n5_x = 2.2194301519999997 * minus_a4_y + n6_z;
  const Real n5_y = 0.069699984375 * minus_a4_y + (c6 * n6_x - s6 * n6_y);
  const Real n5_z = 0.069699984375 * a5_y + 2.2194301519999997 * a5_x + (s6 * n6_x + c6 * n6_y);
  g[4] = n5_z;

  // link 5 (chest2), inward
  const Real n4_y = n5_z - 0.0300000063 * a3_y;
  const Real minus_n4_x = s5 * n5_y - c5 * n5_x;
  const Real n4_z = 0.0300000063 * minus_a4_y - (s5 * n5_x + c5 * n5_y);
  g[3] = n4_z;

  // link 4 (chest1), inward
  const Real n3_z = 8.419374554 * a3_x - 0.02999999505 * a3_y + (c4 * n4_y - s4 * minus_n4_x);
  g[2] = n3_z;

  // link 3 (hip), inward
  const Real n2_z = 0.031999971599999996 * a2_y - 24.5839218 * minus_a2_x + n3_z;
  g[1] = n2_z;

  // link 2 (thigh), inward
  const Real n1_z = 0.1569597827085 * c1 - 299.6743959432 * s1 + n2_z;
  g[0] = n1_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
