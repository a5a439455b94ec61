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
  const Real angles[24] = {q[0], q[1], q[2], q[3], q[4], q[5], q[20], q[21], q[23], q[22], q[13],
      q[14], q[15], q[16], q[17], q[18], q[19], q[6], q[7], q[8], q[9], q[10], q[11], q[12]};
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
  const Real c15 = cosines[11];
  const Real c14 = cosines[10];
  const Real s15 = sines[11];
  const Real c16 = cosines[12];
  const Real s17 = sines[13];
  const Real s16 = sines[12];
  const Real c18 = cosines[14];
  const Real c17 = cosines[13];
  const Real s18 = sines[14];
  const Real s19 = sines[15];
  const Real s20 = sines[16];
  const Real c19 = cosines[15];
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
  const Real s12 = sines[22];
  const Real s11 = sines[21];
  const Real s13 = sines[23];
  const Real c12 = cosines[22];
  const Real c13 = cosines[23];

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;
  const Real minus_a1_y = 9.81 * c1;

  // link 2 (thigh), outward
  const Real minus_a2_x = c2 * minus_a1_x + s2 * minus_a1_y;
  const Real a2_y = s2 * minus_a1_x - c2 * minus_a1_y;

  // link 3 (hip), outward
  const Real a3_y = s3 * minus_a2_x + c3 * a2_y;
  const Real a3_x = s3 * a2_y - c3 * minus_a2_x;

  // link 4 (chest1), outward
  const Real a4_x = c4 * a3_x;

  // link 5 (chest2), outward
  const Real a5_y = c5 * a3_y - s5 * a4_x;

  // link 4 (chest1), outward
  const Real minus_a4_y = s4 * a3_x;

  // link 6 (chest3), outward
  const Real a6_x = c6 * a5_y - s6 * minus_a4_y;

  // link 5 (chest2), outward
  const Real a5_x = c5 * a4_x + s5 * a3_y;

  // link 14 (right_shoulder1), outward
  const Real a14_x = s14 * a6_x + c14 * a5_x;
  const Real a14_y = c14 * a6_x - s14 * a5_x;

  // link 6 (chest3), outward
  const Real minus_a6_y = s6 * a5_y + c6 * minus_a4_y;

  // link 15 (right_shoulder2), outward
  const Real minus_a15_y = s15 * a14_y + c15 * minus_a6_y;

  // link 16 (right_upperarm), outward
  const Real a16_x = c16 * a14_x - s16 * minus_a15_y;

  // link 15 (right_shoulder2), outward
  const Real a15_x = c15 * a14_y - s15 * minus_a6_y;

  // link 17 (right_lowerarm), outward
  const Real a17_x = c17 * a16_x + s17 * a15_x;

  // link 16 (right_upperarm), outward
  const Real minus_a16_y = c16 * minus_a15_y + s16 * a14_x;

  // link 18 (right_wrist1), outward
  const Real a18_x = c18 * a17_x - s18 * minus_a16_y;

  // link 17 (right_lowerarm), outward
  const Real a17_y = c17 * a15_x - s17 * a16_x;

  // link 19 (right_wrist2), outward
  const Real a19_y = c19 * a17_y - s19 * a18_x;

  // link 18 (right_wrist1), outward
  const Real minus_a18_y = s18 * a17_x + c18 * minus_a16_y;

  // link 20 (right_hand), outward
  const Real minus_a20_y = s20 * a19_y + c20 * minus_a18_y;
  const Real a20_x = c20 * a19_y - s20 * minus_a18_y;

  // link 20 (right_hand), inertial wrench
  const Real minus_n20_z = 0.01626499875 * minus_a20_y + 0.002865001425 * a20_x;
  g[19] = -minus_n20_z;

  // link 20 (right_hand), inward
  const Real minus_n19_x = 0.0006000000000000001 * minus_a18_y + minus_n20_z;

  // link 19 (right_wrist2), outward
  const Real a19_x = c19 * a18_x + s19 * a17_y;

  // link 20 (right_hand), inertial wrench
  const Real n20_x = 0.002865001425 * a19_x;
  const Real minus_n20_y = 0.01626499875 * a19_x;

  // link 20 (right_hand), inward
  const Real n19_y = 0.0025100003499999995 * minus_a18_y + (c20 * n20_x + s20 * minus_n20_y);

  // link 19 (right_wrist2), inward
  const Real n18_x = 0.001 * a17_y - (c19 * minus_n19_x + s19 * n19_y);

  // link 20 (right_hand), inward
  const Real n19_z = 0.0025100003499999995 * a19_y - 0.0006000000000000001 * a19_x +
      (s20 * n20_x - c20 * minus_n20_y);
  g[18] = n19_z;

  // link 19 (right_wrist2), inward
  const Real n18_y = 6e-04 * a17_y + n19_z;

  // link 18 (right_wrist1), inward
  const Real n17_x = c18 * n18_x - s18 * n18_y - 0.28049749700000004 * minus_a16_y;

  // link 19 (right_wrist2), inward
  const Real n18_z = 0.001 * a18_x - 6e-04 * minus_a18_y + (s19 * minus_n19_x - c19 * n19_y);
  g[17] = n18_z;

  // link 18 (right_wrist1), inward
  const Real n17_y = 0.0014999985000000002 * minus_a16_y - n18_z;

  // link 17 (right_lowerarm), inward
  const Real n16_x = 0.004500002325 * a15_x - (s17 * n17_y - c17 * n17_x);

  // link 18 (right_wrist1), inward
  const Real n17_z = 0.0014999985000000002 * a17_y - 0.28049749700000004 * a17_x +
      (s18 * n18_x + c18 * n18_y);
  g[16] = n17_z;

  // link 17 (right_lowerarm), inward
  const Real n16_y = n17_z - 0.0022500062 * a15_x;

  // link 16 (right_upperarm), inward
  const Real n15_z = 0.0017499999999999998 * a15_x - 0.7139200499999999 * minus_a15_y +
      (c16 * n16_x - s16 * n16_y);
  g[14] = n15_z;

  // link 7 (left_shoulder1), inertial wrench
  const Real n14_x_p1 = 0.0017499999999999998 * minus_a6_y;

  // link 15 (right_shoulder2), inward
  const Real n14_x = n14_x_p1 + n15_z;

  // link 16 (right_upperarm), inward
  const Real n15_y = s16 * n16_x + c16 * n16_y - 0.7139200499999999 * a14_x;

  // link 17 (right_lowerarm), inward
  const Real n16_z = 0.0022500062 * minus_a16_y + 0.004500002325 * a16_x -
      (s17 * n17_x + c17 * n17_y);
  g[15] = n16_z;

  // link 14 (right_shoulder1), inertial wrench
  const Real minus_n15_x_p1 = 0.0017499999999999998 * a14_x;

  // link 16 (right_upperarm), inward
  const Real minus_n15_x = minus_n15_x_p1 + n16_z;

  // link 15 (right_shoulder2), inward
  const Real n14_y = n14_x_p1 - (c15 * minus_n15_x + s15 * n15_y);

  // link 21 (neck), outward
  const Real a21_x = c21 * a5_x - s21 * minus_a6_y;

  // link 22 (head), outward
  const Real a22_x = c22 * a21_x + s22 * a6_x;

  // link 21 (neck), outward
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a5_x;

  // link 24 (right_eye), outward
  const Real minus_a24_y = s24 * a22_x + c24 * minus_a21_y;

  // link 24 (right_eye), inertial wrench
  const Real minus_n24_z = 0.00025 * minus_a24_y;
  g[23] = -minus_n24_z;

  // link 23 (left_eye), outward
  const Real minus_a23_y = s23 * a22_x + c23 * minus_a21_y;

  // link 23 (left_eye), inertial wrench
  const Real minus_n23_z = 0.00025 * minus_a23_y;
  g[22] = -minus_n23_z;

  // link 23 (left_eye), inward
  const Real n22_y = 0.072575 * minus_a21_y + minus_n24_z + minus_n23_z;

  // link 22 (head), outward
  const Real a22_y = c22 * a6_x - s22 * a21_x;

  // link 23 (left_eye), inertial wrench
  const Real n24_y = 0.00025 * a22_y;

  // link 23 (left_eye), inward
  const Real n22_x = 0.43200000000000005 * minus_a21_y - (s24 + s23) * n24_y;

  // link 22 (head), inward
  const Real minus_n21_z = 0.0045000000000000005 * minus_a21_y + (s22 * n22_x + c22 * n22_y);
  g[20] = -minus_n21_z;

  // link 7 (left_shoulder1), outward
  const Real a7_x = s7 * a6_x + c7 * a5_x;
  const Real a7_y = c7 * a6_x - s7 * a5_x;

  // link 8 (left_shoulder2), outward
  const Real minus_a8_y = s8 * a7_y + c8 * minus_a6_y;

  // link 9 (left_upperarm), outward
  const Real a9_x = c9 * a7_x - s9 * minus_a8_y;

  // link 8 (left_shoulder2), outward
  const Real a8_x = c8 * a7_y - s8 * minus_a6_y;

  // link 10 (left_lowerarm), outward
  const Real a10_x = c10 * a9_x + s10 * a8_x;

  // link 9 (left_upperarm), outward
  const Real minus_a9_y = c9 * minus_a8_y + s9 * a7_x;

  // link 11 (left_wrist1), outward
  const Real a11_x = c11 * a10_x - s11 * minus_a9_y;

  // link 10 (left_lowerarm), outward
  const Real a10_y = c10 * a8_x - s10 * a9_x;

  // link 12 (left_wrist2), outward
  const Real a12_y = c12 * a10_y - s12 * a11_x;

  // link 11 (left_wrist1), outward
  const Real minus_a11_y = s11 * a10_x + c11 * minus_a9_y;

  // link 13 (left_hand), outward
  const Real a13_x = c13 * a12_y - s13 * minus_a11_y;
  const Real minus_a13_y = s13 * a12_y + c13 * minus_a11_y;

  // link 13 (left_hand), inertial wrench
  const Real n13_z = 0.002865001425 * a13_x - 0.01626499875 * minus_a13_y;
  g[12] = n13_z;

  // link 13 (left_hand), inward
  const Real n12_x = n13_z - 0.0006000000000000001 * minus_a11_y;

  // link 12 (left_wrist2), outward
  const Real a12_x = c12 * a11_x + s12 * a10_y;

  // link 13 (left_hand), inertial wrench
  const Real minus_n13_y = 0.01626499875 * a12_x;
  const Real minus_n13_x = 0.002865001425 * a12_x;

  // link 13 (left_hand), inward
  const Real n12_y = 0.0025100003499999995 * minus_a11_y + (s13 * minus_n13_y - c13 * minus_n13_x);

  // link 12 (left_wrist2), inward
  const Real minus_n11_x = 0.001 * a10_y + (s12 * n12_y - c12 * n12_x);

  // link 13 (left_hand), inward
  const Real n12_z = 0.0025100003499999995 * a12_y - 0.0006000000000000001 * a12_x -
      (s13 * minus_n13_x + c13 * minus_n13_y);
  g[11] = n12_z;

  // link 12 (left_wrist2), inward
  const Real n11_y = 6e-04 * a10_y + n12_z;

  // link 11 (left_wrist1), inward
  const Real minus_n10_x = 0.28049749700000004 * minus_a9_y + (c11 * minus_n11_x + s11 * n11_y);

  // link 12 (left_wrist2), inward
  const Real minus_n11_z = 6e-04 * minus_a11_y + 0.001 * a11_x + (s12 * n12_x + c12 * n12_y);
  g[10] = -minus_n11_z;

  // link 11 (left_wrist1), inward
  const Real n10_y = 0.0014999985000000002 * minus_a9_y + minus_n11_z;

  // link 10 (left_lowerarm), inward
  const Real minus_n9_x = 0.004500002325 * a8_x + (c10 * minus_n10_x + s10 * n10_y);

  // link 11 (left_wrist1), inward
  const Real n10_z = 0.0014999985000000002 * a10_y - 0.28049749700000004 * a10_x +
      (c11 * n11_y - s11 * minus_n11_x);
  g[9] = n10_z;

  // link 10 (left_lowerarm), inward
  const Real n9_y = n10_z - 0.0022500062 * a8_x;

  // link 9 (left_upperarm), inward
  const Real minus_n8_z = 0.7139200499999999 * minus_a8_y + 0.0017499999999999998 * a8_x +
      (c9 * minus_n9_x + s9 * n9_y);
  g[7] = -minus_n8_z;

  // link 8 (left_shoulder2), inward
  const Real n7_x = n14_x_p1 - minus_n8_z;

  // link 9 (left_upperarm), inward
  const Real minus_n8_y = 0.7139200499999999 * a7_x + (s9 * minus_n9_x - c9 * n9_y);

  // link 10 (left_lowerarm), inward
  const Real n9_z = 0.0022500062 * minus_a9_y - 0.004500002325 * a9_x +
      (s10 * minus_n10_x - c10 * n10_y);
  g[8] = n9_z;

  // link 7 (left_shoulder1), inertial wrench
  const Real n8_x_p1 = 0.0017499999999999998 * a7_x;

  // link 9 (left_upperarm), inward
  const Real n8_x = n8_x_p1 - n9_z;

  // link 8 (left_shoulder2), inward
  const Real n7_y = n14_x_p1 + (c8 * n8_x + s8 * minus_n8_y);

  // link 7 (left_shoulder1), inward
  const Real n6_x = minus_n21_z + (s14 * n14_x + c14 * n14_y) + (s7 * n7_x + c7 * n7_y);

  // link 15 (right_shoulder2), inward
  const Real n14_z = 0.0017499999999999998 * a14_y + minus_n15_x_p1 +
      (c15 * n15_y - s15 * minus_n15_x);
  g[13] = n14_z;

  // link 22 (head), inward
  const Real minus_n21_x = s22 * n22_y - c22 * n22_x;

  // link 23 (left_eye), inward
  const Real n22_z = 0.072575 * a22_y + 0.43200000000000005 * a22_x + (c24 + c23) * n24_y;
  g[21] = n22_z;

  // link 22 (head), inward
  const Real n21_y = 0.0045000000000000005 * a6_x + n22_z;

  // link 8 (left_shoulder2), inward
  const Real n7_z = 0.0017499999999999998 * a7_y + n8_x_p1 + (s8 * n8_x - c8 * minus_n8_y);
  g[6] = n7_z;

  // link 7 (left_shoulder1), inward
  const Real n6_y = 6.1665928899999995 * a5_x - (s21 * minus_n21_x - c21 * n21_y) + n14_z + n7_z;

  // link 6 (chest3), inward
  const Real n5_y = 0.069699984375 * minus_a4_y + (c6 * n6_x - s6 * n6_y);

  // link 14 (right_shoulder1), inward
  const Real n6_z_p1 = 6.1665928899999995 * minus_a6_y - (c21 * minus_n21_x + s21 * n21_y) +
      (c14 * n14_x - s14 * n14_y);

  // link 7 (left_shoulder1), inward
  const Real n6_z = n6_z_p1 + (c7 * n7_x - s7 * n7_y);
  g[5] = n6_z;

  // link 6 (chest3), inward
  const Real n5_x = 2.2194301519999997 * minus_a4_y + n6_z;

  // link 5 (chest2), inward
  const Real minus_n4_x = s5 * n5_y - c5 * n5_x;

  // link 6 (chest3), inward
  const Real n5_z = 0.069699984375 * a5_y + 2.2194301519999997 * a5_x + (s6 * n6_x + c6 * n6_y);
  g[4] = n5_z;

  // link 5 (chest2), inward
  const Real n4_y = n5_z - 0.0300000063 * a3_y;

  // link 4 (chest1), inward
  const Real n3_z = 8.419374554 * a3_x - 0.02999999505 * a3_y + (c4 * n4_y - s4 * minus_n4_x);
  g[2] = n3_z;

  // link 3 (hip), inward
  const Real n2_z = 0.031999971599999996 * a2_y - 24.5839218 * minus_a2_x + n3_z;
  g[1] = n2_z;

  // link 2 (thigh), inward
  const Real n1_z = 0.1569597827085 * c1 - 299.6743959432 * s1 + n2_z;
  g[0] = n1_z;

  // link 5 (chest2), inward
  const Real n4_z = 0.0300000063 * minus_a4_y - (s5 * n5_x + c5 * n5_y);
  g[3] = n4_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
