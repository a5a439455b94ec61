// gravity: g: the joint forces that hold the robot at rest
// By recursive Newton-Euler, Chang table 4.1.
// 396 flops (add 158, mul 238, div 0), sine and cosine of 24 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

void gravity(const Real (&TREELINE_RESTRICT q)[24], Real (&TREELINE_RESTRICT g)[24]) noexcept {
  const Real angles[24] = {q[0], q[1], q[2], q[3], q[4], q[5], q[6], q[7], q[8], q[9], q[10], q[11],
      q[12], q[13], q[14], q[15], q[16], q[17], q[18], q[19], q[20], q[21], q[22], q[23]};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real s1 = sines[0];
  const Real c1 = cosines[0];
  const Real s2 = sines[1];
  const Real c2 = cosines[1];
  const Real s3 = sines[2];
  const Real c3 = cosines[2];
  const Real s4 = sines[3];
  const Real c4 = cosines[3];
  const Real s5 = sines[4];
  const Real c5 = cosines[4];
  const Real s6 = sines[5];
  const Real c6 = cosines[5];
  const Real s7 = sines[6];
  const Real c7 = cosines[6];
  const Real s8 = sines[7];
  const Real c8 = cosines[7];
  const Real s9 = sines[8];
  const Real c9 = cosines[8];
  const Real s10 = sines[9];
  const Real c10 = cosines[9];
  const Real s11 = sines[10];
  const Real c11 = cosines[10];
  const Real s12 = sines[11];
  const Real c12 = cosines[11];
  const Real s13 = sines[12];
  const Real c13 = cosines[12];
  const Real s14 = sines[13];
  const Real c14 = cosines[13];
  const Real s15 = sines[14];
  const Real c15 = cosines[14];
  const Real s16 = sines[15];
  const Real c16 = cosines[15];
  const Real s17 = sines[16];
  const Real c17 = cosines[16];
  const Real s18 = sines[17];
  const Real c18 = cosines[17];
  const Real s19 = sines[18];
  const Real c19 = cosines[18];
  const Real s20 = sines[19];
  const Real c20 = cosines[19];
  const Real s21 = sines[20];
  const Real c21 = cosines[20];
  const Real s22 = sines[21];
  const Real c22 = cosines[21];
  const Real s23 = sines[22];
  const Real c23 = cosines[22];
  const Real s24 = sines[23];
  const Real c24 = cosines[23];

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;
  const Real minus_a1_x = 9.81 * s1;

  // link 2 (thigh), outward
  const Real minus_a2_y = c2 * minus_a1_y - s2 * minus_a1_x;
  const Real minus_a2_x = s2 * minus_a1_y + c2 * minus_a1_x;

  // link 3 (hip), outward
  const Real minus_a3_y = c3 * minus_a2_y - s3 * minus_a2_x;
  const Real minus_a3_x = s3 * minus_a2_y + c3 * minus_a2_x;

  // link 4 (chest1), outward
  const Real minus_a4_x = c4 * minus_a3_x;

  // link 5 (chest2), outward
  const Real minus_a5_x = s5 * minus_a3_y + c5 * minus_a4_x;
  const Real minus_a5_y = c5 * minus_a3_y - s5 * minus_a4_x;

  // link 4 (chest1), outward
  const Real a4_y = s4 * minus_a3_x;

  // link 6 (chest3), outward
  const Real a6_x = s6 * a4_y - c6 * minus_a5_y;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_x = c7 * minus_a5_x - s7 * a6_x;
  const Real a7_y = s7 * minus_a5_x + c7 * a6_x;

  // link 6 (chest3), outward
  const Real a6_y = c6 * a4_y + s6 * minus_a5_y;

  // link 8 (left_shoulder2), outward
  const Real a8_y = c8 * a6_y - s8 * a7_y;

  // link 9 (left_upperarm), outward
  const Real a9_y = s9 * minus_a7_x + c9 * a8_y;
  const Real minus_a9_x = c9 * minus_a7_x - s9 * a8_y;

  // link 8 (left_shoulder2), outward
  const Real a8_x = s8 * a6_y + c8 * a7_y;

  // link 10 (left_lowerarm), outward
  const Real a10_x = s10 * a8_x - c10 * minus_a9_x;

  // link 11 (left_wrist1), outward
  const Real a11_x = s11 * a9_y + c11 * a10_x;
  const Real a11_y = c11 * a9_y - s11 * a10_x;

  // link 10 (left_lowerarm), outward
  const Real a10_y = c10 * a8_x + s10 * minus_a9_x;

  // link 12 (left_wrist2), outward
  const Real a12_x = s12 * a10_y + c12 * a11_x;

  // link 13 (left_hand), inertial wrench
  const Real minus_n13_y = 0.01626499875 * a12_x;
  const Real minus_n13_x = 0.002865001425 * a12_x;

  // link 13 (left_hand), inward
  const Real minus_n12_y = 0.0025100003499999995 * a11_y - s13 * minus_n13_y + c13 * minus_n13_x;

  // link 12 (left_wrist2), outward
  const Real a12_y = c12 * a10_y - s12 * a11_x;

  // link 13 (left_hand), outward
  const Real a13_x = s13 * a11_y + c13 * a12_y;
  const Real a13_y = c13 * a11_y - s13 * a12_y;

  // link 13 (left_hand), inertial wrench
  const Real n13_z = 0.002865001425 * a13_x + 0.01626499875 * a13_y;
  g[12] = n13_z;

  // link 13 (left_hand), inward
  const Real n12_x = n13_z + 0.0006000000000000001 * a11_y;

  // link 12 (left_wrist2), inward
  const Real minus_n11_z = 0.001 * a11_x - 6e-04 * a11_y - c12 * minus_n12_y + s12 * n12_x;
  g[10] = -minus_n11_z;

  // link 11 (left_wrist1), inward
  const Real n10_y = minus_n11_z - 0.0014999985000000002 * a9_y;

  // link 12 (left_wrist2), inward
  const Real minus_n11_x = 0.001 * a10_y - s12 * minus_n12_y - c12 * n12_x;

  // link 13 (left_hand), inward
  const Real minus_n12_z = 0.0006000000000000001 * a12_x - 0.0025100003499999995 * a12_y + c13 *
      minus_n13_y + s13 * minus_n13_x;
  g[11] = -minus_n12_z;

  // link 12 (left_wrist2), inward
  const Real minus_n11_y = minus_n12_z - 6e-04 * a10_y;

  // link 11 (left_wrist1), inward
  const Real n10_x = 0.28049749700000004 * a9_y + s11 * minus_n11_y - c11 * minus_n11_x;

  // link 10 (left_lowerarm), inward
  const Real minus_n9_x = 0.004500002325 * a8_x + s10 * n10_y - c10 * n10_x;

  // link 11 (left_wrist1), inward
  const Real minus_n10_z = 0.28049749700000004 * a10_x - 0.0014999985000000002 * a10_y + c11 *
      minus_n11_y + s11 * minus_n11_x;
  g[9] = -minus_n10_z;

  // link 10 (left_lowerarm), inward
  const Real minus_n9_y = minus_n10_z + 0.0022500062 * a8_x;

  // link 9 (left_upperarm), inward
  const Real n8_y = 0.7139200499999999 * minus_a7_x - c9 * minus_n9_y - s9 * minus_n9_x;

  // link 7 (left_shoulder1), inertial wrench
  const Real minus_n7_z_p1 = 0.0017499999999999998 * minus_a7_x;

  // link 10 (left_lowerarm), inward
  const Real n9_z = 0.004500002325 * minus_a9_x - 0.0022500062 * a9_y - c10 * n10_y - s10 * n10_x;
  g[8] = n9_z;

  // link 9 (left_upperarm), inward
  const Real minus_n8_x = minus_n7_z_p1 + n9_z;

  // link 8 (left_shoulder2), inward
  const Real minus_n7_z = minus_n7_z_p1 - 0.0017499999999999998 * a7_y - c8 * n8_y + s8 *
      minus_n8_x;
  g[6] = -minus_n7_z;

  // link 14 (right_shoulder1), outward
  const Real minus_a14_x = c14 * minus_a5_x - s14 * a6_x;
  const Real a14_y = s14 * minus_a5_x + c14 * a6_x;

  // link 15 (right_shoulder2), outward
  const Real a15_y = c15 * a6_y - s15 * a14_y;

  // link 16 (right_upperarm), outward
  const Real a16_y = s16 * minus_a14_x + c16 * a15_y;
  const Real minus_a16_x = c16 * minus_a14_x - s16 * a15_y;

  // link 15 (right_shoulder2), outward
  const Real a15_x = s15 * a6_y + c15 * a14_y;

  // link 17 (right_lowerarm), outward
  const Real a17_x = s17 * a15_x - c17 * minus_a16_x;

  // link 18 (right_wrist1), outward
  const Real a18_x = s18 * a16_y + c18 * a17_x;
  const Real a18_y = c18 * a16_y - s18 * a17_x;

  // link 17 (right_lowerarm), outward
  const Real a17_y = c17 * a15_x + s17 * minus_a16_x;

  // link 19 (right_wrist2), outward
  const Real a19_x = s19 * a17_y + c19 * a18_x;

  // link 20 (right_hand), inertial wrench
  const Real minus_n20_y = 0.01626499875 * a19_x;
  const Real n20_x = 0.002865001425 * a19_x;

  // link 20 (right_hand), inward
  const Real minus_n19_y = 0.0025100003499999995 * a18_y - s20 * minus_n20_y - c20 * n20_x;

  // link 19 (right_wrist2), outward
  const Real a19_y = c19 * a17_y - s19 * a18_x;

  // link 20 (right_hand), outward
  const Real a20_x = s20 * a18_y + c20 * a19_y;
  const Real a20_y = c20 * a18_y - s20 * a19_y;

  // link 20 (right_hand), inertial wrench
  const Real minus_n20_z = 0.002865001425 * a20_x - 0.01626499875 * a20_y;
  g[19] = -minus_n20_z;

  // link 20 (right_hand), inward
  const Real minus_n19_x = minus_n20_z - 0.0006000000000000001 * a18_y;

  // link 19 (right_wrist2), inward
  const Real n18_z = 0.001 * a18_x + 6e-04 * a18_y + c19 * minus_n19_y + s19 * minus_n19_x;
  g[17] = n18_z;

  // link 18 (right_wrist1), inward
  const Real minus_n17_y = n18_z + 0.0014999985000000002 * a16_y;

  // link 19 (right_wrist2), inward
  const Real n18_x = 0.001 * a17_y + s19 * minus_n19_y - c19 * minus_n19_x;

  // link 20 (right_hand), inward
  const Real minus_n19_z = 0.0006000000000000001 * a19_x - 0.0025100003499999995 * a19_y + c20 *
      minus_n20_y - s20 * n20_x;
  g[18] = -minus_n19_z;

  // link 19 (right_wrist2), inward
  const Real minus_n18_y = minus_n19_z - 6e-04 * a17_y;

  // link 18 (right_wrist1), inward
  const Real n17_x = 0.28049749700000004 * a16_y + s18 * minus_n18_y + c18 * n18_x;

  // link 17 (right_lowerarm), inward
  const Real n16_x = 0.004500002325 * a15_x + s17 * minus_n17_y + c17 * n17_x;

  // link 18 (right_wrist1), inward
  const Real minus_n17_z = 0.28049749700000004 * a17_x - 0.0014999985000000002 * a17_y + c18 *
      minus_n18_y - s18 * n18_x;
  g[16] = -minus_n17_z;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_y = minus_n17_z + 0.0022500062 * a15_x;

  // link 16 (right_upperarm), inward
  const Real n15_y = 0.7139200499999999 * minus_a14_x - c16 * minus_n16_y + s16 * n16_x;

  // link 14 (right_shoulder1), inertial wrench
  const Real minus_n14_z_p1 = 0.0017499999999999998 * minus_a14_x;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_z = 0.004500002325 * minus_a16_x + 0.0022500062 * a16_y - c17 * minus_n17_y +
      s17 * n17_x;
  g[15] = -minus_n16_z;

  // link 16 (right_upperarm), inward
  const Real n15_x = minus_n14_z_p1 + minus_n16_z;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_z = minus_n14_z_p1 - 0.0017499999999999998 * a14_y - c15 * n15_y - s15 *
      n15_x;
  g[13] = -minus_n14_z;

  // link 21 (neck), outward
  const Real a21_y = s21 * minus_a5_x + c21 * a6_y;
  const Real minus_a21_x = c21 * minus_a5_x - s21 * a6_y;

  // link 22 (head), outward
  const Real a22_x = s22 * a6_x - c22 * minus_a21_x;

  // link 24 (right_eye), outward
  const Real a24_y = c24 * a21_y - s24 * a22_x;

  // link 24 (right_eye), inertial wrench
  const Real n24_z = 0.00025 * a24_y;
  g[23] = n24_z;

  // link 23 (left_eye), outward
  const Real a23_y = c23 * a21_y - s23 * a22_x;

  // link 23 (left_eye), inertial wrench
  const Real n23_z = 0.00025 * a23_y;
  g[22] = n23_z;

  // link 23 (left_eye), inward
  const Real minus_n22_y = n24_z + (n23_z + 0.072575 * a21_y);

  // link 22 (head), outward
  const Real a22_y = c22 * a6_x + s22 * minus_a21_x;

  // link 23 (left_eye), inertial wrench
  const Real n24_y = 0.00025 * a22_y;

  // link 23 (left_eye), inward
  const Real minus_n22_x = n24_y * (s23 + s24) + 0.43200000000000005 * a21_y;

  // link 22 (head), inward
  const Real n21_x = s22 * minus_n22_y - c22 * minus_n22_x;

  // link 23 (left_eye), inward
  const Real n22_z = n24_y * (c23 + c24) + (0.43200000000000005 * a22_x + 0.072575 * a22_y);
  g[21] = n22_z;

  // link 22 (head), inward
  const Real n21_y = n22_z + 0.0045000000000000005 * a6_x;

  // link 7 (left_shoulder1), inward
  const Real minus_n6_y = minus_n7_z + (minus_n14_z +
      (6.1665928899999995 * minus_a5_x - c21 * n21_y - s21 * n21_x));

  // link 7 (left_shoulder1), inertial wrench
  const Real minus_n14_y_p1 = 0.0017499999999999998 * a6_y;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_y = minus_n14_y_p1 + s15 * n15_y - c15 * n15_x;

  // link 22 (head), inward
  const Real n21_z = 0.0045000000000000005 * a21_y + c22 * minus_n22_y + s22 * minus_n22_x;
  g[20] = n21_z;

  // link 16 (right_upperarm), inward
  const Real n15_z = 0.0017499999999999998 * a15_x + 0.7139200499999999 * a15_y + s16 *
      minus_n16_y + c16 * n16_x;
  g[14] = n15_z;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_x = minus_n14_y_p1 - n15_z;

  // link 8 (left_shoulder2), inward
  const Real minus_n7_y = minus_n14_y_p1 + s8 * n8_y + c8 * minus_n8_x;

  // link 9 (left_upperarm), inward
  const Real minus_n8_z = 0.0017499999999999998 * a8_x - 0.7139200499999999 * a8_y - s9 *
      minus_n9_y + c9 * minus_n9_x;
  g[7] = -minus_n8_z;

  // link 8 (left_shoulder2), inward
  const Real minus_n7_x = minus_n14_y_p1 + minus_n8_z;

  // link 7 (left_shoulder1), inward
  const Real minus_n6_x = n21_z + c14 * minus_n14_y + s14 * minus_n14_x + c7 * minus_n7_y + s7 *
      minus_n7_x;

  // link 6 (chest3), inward
  const Real minus_n5_z = 2.2194301519999997 * minus_a5_x + 0.069699984375 * minus_a5_y + c6 *
      minus_n6_y + s6 * minus_n6_x;
  g[4] = -minus_n5_z;

  // link 5 (chest2), inward
  const Real minus_n4_y = minus_n5_z - 0.0300000063 * minus_a3_y;

  // link 6 (chest3), inward
  const Real minus_n5_y = 0.069699984375 * a4_y - s6 * minus_n6_y + c6 * minus_n6_x;

  // link 7 (left_shoulder1), inward
  const Real minus_n6_z_p1 = 6.1665928899999995 * a6_y + s21 * n21_y - c21 * n21_x - s14 *
      minus_n14_y + c14 * minus_n14_x;
  const Real minus_n6_z = minus_n6_z_p1 - s7 * minus_n7_y + c7 * minus_n7_x;
  g[5] = -minus_n6_z;

  // link 6 (chest3), inward
  const Real minus_n5_x = minus_n6_z + 2.2194301519999997 * a4_y;

  // link 5 (chest2), inward
  const Real n4_x = s5 * minus_n5_y - c5 * minus_n5_x;

  // link 4 (chest1), inward
  const Real minus_n3_z = 8.419374554 * minus_a3_x - 0.02999999505 * minus_a3_y + c4 * minus_n4_y -
      s4 * n4_x;
  g[2] = -minus_n3_z;

  // link 3 (hip), inward
  const Real minus_n2_z = minus_n3_z + (24.5839218 * minus_a2_x + 0.031999971599999996 *
      minus_a2_y);
  g[1] = -minus_n2_z;

  // link 2 (thigh), inward
  const Real minus_n1_z = minus_n2_z + (299.6743959432 * s1 - 0.1569597827085 * c1);
  g[0] = -minus_n1_z;

  // link 5 (chest2), inward
  const Real minus_n4_z = 0.0300000063 * a4_y - c5 * minus_n5_y - s5 * minus_n5_x;
  g[3] = -minus_n4_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
