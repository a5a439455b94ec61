// nonlinear_effects: h = b + g: the joint forces at qdd = 0
// By recursive Newton-Euler, Chang table 4.1.
// 1976 flops (add 949, mul 1027, div 0), sine and cosine of 24 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

void nonlinear_effects(const Real (&TREELINE_RESTRICT q)[24],
    const Real (&TREELINE_RESTRICT qd)[24], Real (&TREELINE_RESTRICT h)[24]) noexcept {
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

  // link 2 (thigh), outward
  const Real w2_z = qd[0] + qd[1];

  // link 3 (hip), outward
  const Real w3_z = qd[2] + w2_z;

  // link 4 (chest1), outward
  const Real w4_x = s4 * w3_z;

  // link 5 (chest2), outward
  const Real minus_w5_x = qd[3] * s5 - c5 * w4_x;

  // link 4 (chest1), outward
  const Real w4_y = c4 * w3_z;
  const Real wd4_x = qd[3] * w4_y;

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * wd4_x - qd[4] * minus_w5_x;

  // link 4 (chest1), outward
  const Real minus_wd4_y = qd[3] * w4_x;

  // link 5 (chest2), outward
  const Real minus_w5_y = qd[3] * c5 + s5 * w4_x;
  const Real w5_z = qd[4] + w4_y;

  // link 6 (chest3), outward
  const Real w6_y = c6 * w5_z + s6 * minus_w5_y;
  const Real minus_wd6_x = s6 * minus_wd4_y + c6 * minus_wd5_y - qd[5] * w6_y;

  // link 5 (chest2), outward
  const Real wd5_x = c5 * wd4_x - qd[4] * minus_w5_y;

  // link 6 (chest3), outward
  const Real w6_z = qd[5] - minus_w5_x;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;

  // link 7 (left_shoulder1), outward
  const Real minus_w7_y = s7 * w6_z - c7 * w6_x;
  const Real wd7_x = c7 * wd5_x - s7 * minus_wd6_x - qd[6] * minus_w7_y;
  const Real w7_x = c7 * w6_z + s7 * w6_x;
  const Real minus_wd7_y = s7 * wd5_x + c7 * minus_wd6_x + qd[6] * w7_x;

  // link 6 (chest3), outward
  const Real minus_wd6_y = c6 * minus_wd4_y - s6 * minus_wd5_y + qd[5] * w6_x;

  // link 7 (left_shoulder1), outward
  const Real w7_z = qd[6] + w6_y;

  // link 8 (left_shoulder2), outward
  const Real w8_x = s8 * w7_z - c8 * minus_w7_y;
  const Real minus_wd8_y = c8 * minus_wd6_y - s8 * minus_wd7_y + qd[7] * w8_x;
  const Real w8_z = qd[7] + w7_x;
  const Real w8_y = c8 * w7_z + s8 * minus_w7_y;

  // link 9 (left_upperarm), outward
  const Real w9_x = c9 * w8_z + s9 * w8_y;
  const Real minus_wd9_y = s9 * wd7_x + c9 * minus_wd8_y + qd[8] * w9_x;
  const Real minus_w9_y = s9 * w8_z - c9 * w8_y;
  const Real wd9_x = c9 * wd7_x - s9 * minus_wd8_y - qd[8] * minus_w9_y;

  // link 8 (left_shoulder2), outward
  const Real minus_wd8_x = s8 * minus_wd6_y + c8 * minus_wd7_y - qd[7] * w8_y;

  // link 9 (left_upperarm), outward
  const Real w9_z = qd[8] - w8_x;

  // link 10 (left_lowerarm), outward
  const Real minus_w10_y = c10 * w9_z + s10 * w9_x;
  const Real minus_wd10_x = s10 * minus_wd8_x - c10 * wd9_x + qd[9] * minus_w10_y;
  const Real w10_z = qd[9] - minus_w9_y;
  const Real minus_w10_x = s10 * w9_z - c10 * w9_x;

  // link 11 (left_wrist1), outward
  const Real w11_x = s11 * w10_z - c11 * minus_w10_x;
  const Real minus_wd11_y = c11 * minus_wd9_y - s11 * minus_wd10_x + qd[10] * w11_x;
  const Real w11_z = qd[10] + minus_w10_y;

  // link 12 (left_wrist2), outward
  const Real minus_w12_x = s12 * w11_z - c12 * w11_x;
  const Real minus_w12_y = c12 * w11_z + s12 * w11_x;
  const Real n12_y_p1 = minus_w12_x * minus_w12_y;
  const Real n12_y_p2 = minus_wd11_y + n12_y_p1;

  // link 11 (left_wrist1), outward
  const Real w11_y = c11 * w10_z + s11 * minus_w10_x;
  const Real minus_wd11_x = s11 * minus_wd9_y + c11 * minus_wd10_x - qd[10] * w11_y;

  // link 10 (left_lowerarm), outward
  const Real minus_wd10_y = c10 * minus_wd8_x + s10 * wd9_x - qd[9] * minus_w10_x;

  // link 12 (left_wrist2), outward
  const Real minus_wd12_y = c12 * minus_wd10_y - s12 * minus_wd11_x - qd[11] * minus_w12_x;
  const Real w12_z = qd[11] + w11_y;
  const Real n12_y_p3 = minus_w12_x * w12_z;
  const Real n12_y_p4 = minus_wd12_y - n12_y_p3;

  // link 2 (thigh), outward
  const Real minus_a2_y_p1 = 9.81 * c1 - qd[0] * (0.434 * qd[0]);

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;

  // link 2 (thigh), outward
  const Real minus_a2_y = c2 * minus_a2_y_p1 - s2 * minus_a1_x;
  const Real minus_a3_y_p1 = w2_z * w2_z;

  // link 3 (hip), outward
  const Real minus_a3_y_p2 = minus_a2_y - 0.422 * minus_a3_y_p1;

  // link 2 (thigh), outward
  const Real minus_a2_x = s2 * minus_a2_y_p1 + c2 * minus_a1_x;

  // link 3 (hip), outward
  const Real minus_a3_y = c3 * minus_a3_y_p2 - s3 * minus_a2_x;

  // link 4 (chest1), outward
  const Real minus_a5_x_p1 = w4_x * w4_x;
  const Real minus_a5_x_p2 = w4_y * w4_y;

  // link 5 (chest2), outward
  const Real minus_a5_x_p3 = minus_a3_y - 0.21799999999999997 * (minus_a5_x_p1 + minus_a5_x_p2);

  // link 3 (hip), outward
  const Real minus_a3_x = s3 * minus_a3_y_p2 + c3 * minus_a2_x;

  // link 4 (chest1), outward
  const Real minus_a4_x = c4 * minus_a3_x;

  // link 5 (chest2), outward
  const Real minus_a5_x = s5 * minus_a5_x_p3 + c5 * minus_a4_x;
  const Real minus_a6_z_p1 = minus_w5_x * minus_w5_y;
  const Real minus_a6_z_p2 = minus_wd4_y + minus_a6_z_p1;

  // link 6 (chest3), outward
  const Real minus_a6_z = minus_a5_x + 0.072 * minus_a6_z_p2;
  const Real a7_y_p1 = w6_y * w6_z;
  const Real a7_y_p2 = minus_wd6_x - a7_y_p1;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p3 = 0.18 * a7_y_p2;

  // link 6 (chest3), outward
  const Real a7_y_p4 = minus_wd6_y + w6_x * w6_z;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p5 = 0.226 * a7_y_p4;
  const Real a7_y_p6 = a7_y_p5 + (minus_a6_z + a7_y_p3);

  // link 4 (chest1), outward
  const Real a4_y = s4 * minus_a3_x;

  // link 5 (chest2), outward
  const Real a6_x_p1 = wd5_x - minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p2 = a4_y - 0.072 * a6_x_p1;

  // link 5 (chest2), outward
  const Real minus_a5_y = c5 * minus_a5_x_p3 - s5 * minus_a4_x;
  const Real a6_x_p3 = minus_w5_x * minus_w5_x;
  const Real a6_x_p4 = w5_z * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p5 = a6_x_p3 + a6_x_p4;
  const Real a6_x_p6 = minus_a5_y - 0.072 * a6_x_p5;
  const Real a6_x = s6 * a6_x_p2 - c6 * a6_x_p6;
  const Real a7_y_p7 = w6_x * w6_y;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p8 = 0.18 * (wd5_x - a7_y_p7);

  // link 6 (chest3), outward
  const Real a7_y_p9 = w6_z * w6_z;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p10 = a7_y_p9 + w6_y * w6_y;
  const Real a7_y_p11 = 0.226 * a7_y_p10;
  const Real a7_y_p12 = a7_y_p11 + (a6_x - a7_y_p8);
  const Real a7_y = s7 * a7_y_p6 + c7 * a7_y_p12;

  // link 6 (chest3), outward
  const Real a6_y = c6 * a6_x_p2 + s6 * a6_x_p6;
  const Real minus_a7_z_p1 = w6_x * w6_x;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_z_p2 = 0.18 * (minus_a7_z_p1 + a7_y_p9);

  // link 6 (chest3), outward
  const Real minus_a7_z_p3 = wd5_x + a7_y_p7;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_z_p4 = 0.226 * minus_a7_z_p3;
  const Real minus_a7_z = minus_a7_z_p4 - (a6_y - minus_a7_z_p2);

  // link 8 (left_shoulder2), outward
  const Real minus_a8_x = s8 * minus_a7_z - c8 * a7_y;

  // link 9 (left_upperarm), outward
  const Real minus_a10_x_p1 = w9_x * w9_x;
  const Real minus_a10_x_p2 = minus_w9_y * minus_w9_y;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_x_p3 = minus_a8_x + 0.282 * (minus_a10_x_p1 + minus_a10_x_p2);

  // link 7 (left_shoulder1), outward
  const Real minus_a7_x = c7 * a7_y_p6 - s7 * a7_y_p12;

  // link 8 (left_shoulder2), outward
  const Real minus_a8_y = c8 * minus_a7_z + s8 * a7_y;

  // link 9 (left_upperarm), outward
  const Real minus_a9_x = c9 * minus_a7_x + s9 * minus_a8_y;
  const Real minus_a10_x_p4 = w9_x * w9_z;
  const Real minus_a10_x_p5 = minus_wd9_y - minus_a10_x_p4;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_x_p6 = minus_a9_x - 0.282 * minus_a10_x_p5;
  const Real minus_a10_x = s10 * minus_a10_x_p3 + c10 * minus_a10_x_p6;

  // link 9 (left_upperarm), outward
  const Real a9_y = s9 * minus_a7_x - c9 * minus_a8_y;
  const Real a10_z_p1 = minus_w9_y * w9_z;
  const Real a10_z_p2 = wd9_x + a10_z_p1;

  // link 10 (left_lowerarm), outward
  const Real a10_z = a9_y + 0.282 * a10_z_p2;

  // link 11 (left_wrist1), outward
  const Real a11_y = c11 * a10_z + s11 * minus_a10_x;
  const Real a12_z_p1 = w11_y * w11_z;
  const Real a12_z_p2 = minus_wd11_x + a12_z_p1;

  // link 12 (left_wrist2), outward
  const Real a12_z = a11_y - 0.269 * a12_z_p2;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_y = c10 * minus_a10_x_p3 - s10 * minus_a10_x_p6;

  // link 11 (left_wrist1), outward
  const Real minus_a12_x_p1 = w11_x * w11_x;
  const Real minus_a12_x_p2 = w11_y * w11_y;

  // link 12 (left_wrist2), outward
  const Real minus_a12_x_p3 = minus_a10_y + 0.269 * (minus_a12_x_p1 + minus_a12_x_p2);

  // link 11 (left_wrist1), outward
  const Real a11_x = s11 * a10_z - c11 * minus_a10_x;
  const Real minus_a12_x_p4 = w11_x * w11_z;
  const Real minus_a12_x_p5 = minus_wd11_y - minus_a12_x_p4;

  // link 12 (left_wrist2), outward
  const Real minus_a12_x_p6 = a11_x + 0.269 * minus_a12_x_p5;
  const Real minus_a12_x = s12 * minus_a12_x_p3 - c12 * minus_a12_x_p6;

  // link 13 (left_hand), outward
  const Real w13_x = s13 * w12_z - c13 * minus_w12_y;
  const Real n13_y_p1 = w13_x * w13_x;
  const Real w13_z = qd[12] - minus_w12_x;
  const Real n13_y_p2 = w13_z * w13_z;
  const Real w13_y = c13 * w12_z + s13 * minus_w12_y;
  const Real minus_wd13_x = s13 * minus_wd11_y + c13 * minus_wd12_y - qd[12] * w13_y;
  const Real n13_y_p3 = w13_y * w13_z;
  const Real n13_y_p4 = minus_wd13_x - n13_y_p3;
  const Real n13_y_p5 = w13_x * w13_y;

  // link 12 (left_wrist2), outward
  const Real minus_wd12_x = s12 * minus_wd10_y + c12 * minus_wd11_x + qd[11] * minus_w12_y;

  // link 13 (left_hand), outward
  const Real n13_y_p6 = minus_wd12_x + n13_y_p5;
  const Real minus_wd13_y = c13 * minus_wd11_y - s13 * minus_wd12_y + qd[12] * w13_x;
  const Real n13_y_p7 = w13_x * w13_z;
  const Real n13_y_p8 = minus_wd13_y + n13_y_p7;

  // link 13 (left_hand), inertial wrench
  const Real n13_y_p9 = 0.000108260010923775 * (n13_y_p1 - n13_y_p2) - 0.0001263900573325125 *
      n13_y_p4 - 4.38600177048965e-05 * n13_y_p6 - 0.000847139515629375 * n13_y_p8;
  const Real n13_y = n13_y_p9 + 0.01626499875 * minus_a12_x;

  // link 13 (left_hand), outward
  const Real n13_x_p1 = w13_y * w13_y;
  const Real n13_x_p2 = minus_wd12_x - n13_y_p5;

  // link 13 (left_hand), inertial wrench
  const Real n13_x_p3 = 4.38600177048965e-05 * (n13_x_p1 - n13_y_p2) + 0.000108260010923775 *
      n13_x_p2 - 0.0001263900573325125 * n13_y_p8 - 9.149209276993575e-05 * n13_y_p4;
  const Real n13_x = n13_x_p3 + 0.002865001425 * minus_a12_x;

  // link 13 (left_hand), inward
  const Real n12_y = 2.4000000000000003e-06 * n12_y_p2 - 0.000195227662257343 * n12_y_p4 -
      0.0025100003499999995 * a12_z - s13 * n13_y + c13 * n13_x;

  // link 12 (left_wrist2), inward
  const Real minus_n11_z_p1 = 6e-06 * (minus_a12_x_p1 - minus_a12_x_p2) + 0.0002516 *
      minus_a12_x_p5 + 0.000144 * a12_z_p2 - 0.0002292 * minus_wd10_y;

  // link 11 (left_wrist1), outward
  const Real minus_n11_z_p2 = w11_x * w11_y;

  // link 12 (left_wrist2), inward
  const Real minus_n11_z_p3 = minus_n11_z_p1 + 9.600000000000003e-06 * minus_n11_z_p2 + 0.001 *
      a11_x - 6e-04 * a11_y + c12 * n12_y;

  // link 12 (left_wrist2), outward
  const Real minus_a12_y = c12 * minus_a12_x_p3 + s12 * minus_a12_x_p6;

  // link 13 (left_hand), outward
  const Real a13_x = s13 * a12_z - c13 * minus_a12_y;

  // link 13 (left_hand), inertial wrench
  const Real n13_z_p1 = 0.0001263900573325125 * (n13_y_p1 - n13_x_p1) - 4.38600177048965e-05 *
      (minus_wd13_y - n13_y_p7) + 0.000108260010923775 * (minus_wd13_x + n13_y_p3);

  // link 13 (left_hand), outward
  const Real a13_y = c13 * a12_z + s13 * minus_a12_y;

  // link 13 (left_hand), inertial wrench
  const Real n13_z = n13_z_p1 - 0.0009386316083993107 * minus_wd12_x + 0.0007556474228594393 *
      n13_y_p5 + 0.002865001425 * a13_x + 0.01626499875 * a13_y;
  h[12] = n13_z;

  // link 12 (left_wrist2), outward
  const Real n12_x_p1 = minus_w12_y * minus_w12_y;
  const Real n12_x_p2 = w12_z * w12_z;
  const Real n12_x_p3 = minus_wd12_x + minus_w12_y * w12_z;

  // link 13 (left_hand), inward
  const Real n12_x = n13_z - (2.4000000000000003e-06 * (n12_x_p1 - n12_x_p2) + 1.16e-05 * n12_x_p3 -
      0.0006000000000000001 * a12_z);

  // link 12 (left_wrist2), inward
  const Real minus_n11_z = minus_n11_z_p3 + s12 * n12_x;
  h[10] = -minus_n11_z;

  // link 10 (left_lowerarm), outward
  const Real n10_y_p1 = minus_w10_x * minus_w10_x;
  const Real n10_y_p2 = w10_z * w10_z;
  const Real n10_y_p3 = minus_w10_x * w10_z;
  const Real n10_y_p4 = minus_wd10_y - n10_y_p3;
  const Real n10_y_p5 = minus_w10_x * minus_w10_y;
  const Real n10_y_p6 = minus_wd9_y + n10_y_p5;
  const Real n10_y_p7 = minus_w10_y * w10_z;
  const Real n10_y_p8 = minus_wd10_x + n10_y_p7;

  // link 11 (left_wrist1), inward
  const Real n10_y = 0.0001499998887063 * (n10_y_p6 + n10_y_p8) +
      (minus_n11_z + (2.249994685315e-05 * (n10_y_p1 - n10_y_p2) - 0.00028099984685315 * n10_y_p4 -
      0.0014999985000000002 * a10_z));

  // link 13 (left_hand), inertial wrench
  const Real f13_y = 0.002865001425 * (n13_y_p1 + n13_y_p2) - 0.01626499875 * n13_x_p2;
  const Real minus_f13_x = 0.002865001425 * n13_y_p6 + 0.01626499875 * (n13_x_p1 + n13_y_p2);

  // link 13 (left_hand), inward
  const Real minus_f12_z = 0.0006000000000000001 * n12_x_p3 - 0.0025100003499999995 * n12_y_p4 -
      c13 * f13_y + s13 * minus_f13_x;

  // link 11 (left_wrist1), outward
  const Real minus_f11_y_p1 = w11_z * w11_z;
  const Real minus_f11_y_p2 = minus_wd10_y + minus_n11_z_p2;

  // link 12 (left_wrist2), inward
  const Real minus_f11_y = minus_f12_z + (0.001 * (minus_a12_x_p1 + minus_f11_y_p1) - 6e-04 *
      minus_f11_y_p2);

  // link 13 (left_hand), inward
  const Real minus_f12_y_p1 = 0.0006000000000000001 * (n12_x_p2 + minus_w12_x * minus_w12_x) +
      0.0025100003499999995 * (minus_wd11_y - n12_y_p1) + s13 * f13_y;
  const Real minus_f12_y = minus_f12_y_p1 + c13 * minus_f13_x;
  const Real f12_x = 0.0006000000000000001 * n12_y_p2 - 0.0025100003499999995 *
      (n12_x_p1 + n12_x_p2) + 0.002865001425 * n13_y_p4 + 0.01626499875 * n13_y_p8;

  // link 12 (left_wrist2), inward
  const Real f11_x_p1 = s12 * minus_f12_y + c12 * f12_x;

  // link 11 (left_wrist1), outward
  const Real f11_x_p2 = minus_wd10_y - minus_n11_z_p2;

  // link 12 (left_wrist2), inward
  const Real f11_x = f11_x_p1 - (0.001 * f11_x_p2 + 6e-04 * (minus_a12_x_p2 + minus_f11_y_p1));

  // link 11 (left_wrist1), inward
  const Real minus_f10_z = 0.28049749700000004 * n10_y_p8 - 0.0014999985000000002 * n10_y_p4 + c11 *
      minus_f11_y - s11 * f11_x;

  // link 9 (left_upperarm), outward
  const Real n9_x_p1 = w9_z * w9_z;
  const Real n9_x_p2 = w9_x * minus_w9_y;
  const Real n9_x_p3 = minus_wd8_x - n9_x_p2;
  const Real n9_x_p4 = minus_wd9_y + minus_a10_x_p4;
  const Real n9_x_p5 = wd9_x - a10_z_p1;

  // link 10 (left_lowerarm), inward
  const Real n9_x_p6 = 0.0012089992423205001 * (minus_a10_x_p2 - n9_x_p1) - 0.0005895000784280001 *
      n9_x_p3 - 4.4999986458742003e-05 * n9_x_p4 + 0.0019585440854647937 * n9_x_p5;

  // link 11 (left_wrist1), outward
  const Real n11_x_p1 = minus_wd11_y + minus_a12_x_p4;
  const Real n11_x_p2 = minus_wd11_x - a12_z_p1;

  // link 12 (left_wrist2), inward
  const Real n11_x_p3 = 0.0002516 * (minus_a12_x_p2 - minus_f11_y_p1) + 0.000144 * minus_f11_y_p2 +
      6e-06 * n11_x_p1 - 0.0001194 * n11_x_p2;
  const Real n11_x = n11_x_p3 + 0.001 * minus_a10_y - 0.269 * minus_f12_z - s12 * n12_y + c12 *
      n12_x;

  // link 13 (left_hand), inward
  const Real n12_z_p1 = 2.4000000000000003e-06 * (minus_wd12_y + n12_y_p3) -
      0.00020682766225734302 * minus_wd11_y + 0.000183627662257343 * n12_y_p1 +
      0.0006000000000000001 * minus_a12_x;
  const Real n12_z = n12_z_p1 - 0.0025100003499999995 * minus_a12_y + c13 * n13_y + s13 * n13_x;
  h[11] = n12_z;

  // link 12 (left_wrist2), inward
  const Real n11_y_p1 = 0.000144 * (minus_a12_x_p1 - minus_f11_y_p1) - 6e-06 * n11_x_p2 -
      0.0002516 * f11_x_p2 + 0.0001098 * n11_x_p1;
  const Real n11_y = n12_z - (n11_y_p1 + 6e-04 * minus_a10_y) - 0.269 * f11_x_p1;

  // link 10 (left_lowerarm), outward
  const Real n10_x_p1 = minus_wd9_y - n10_y_p5;

  // link 11 (left_wrist1), inward
  const Real n10_x_p2 = 2.249994685315e-05 * n10_x_p1 - 0.06060754126741261 * n10_y_p8 +
      0.28049749700000004 * a10_z - s11 * n11_y + c11 * n11_x;

  // link 10 (left_lowerarm), outward
  const Real n10_x_p3 = minus_w10_y * minus_w10_y;

  // link 11 (left_wrist1), inward
  const Real n10_x = 0.0001499998887063 * (n10_y_p4 - (n10_x_p3 - n10_y_p2)) + n10_x_p2;

  // link 10 (left_lowerarm), inward
  const Real n9_x = n9_x_p6 + 0.004500002325 * minus_a8_x - 0.282 * minus_f10_z - s10 * n10_y +
      c10 * n10_x;

  // link 11 (left_wrist1), inward
  const Real n10_z_p1 = 2.249994685315e-05 * (minus_wd10_x - n10_y_p7) - 0.060888541114265754 *
      minus_wd9_y - 0.06032654142055946 * n10_y_p5 + 0.28049749700000004 * minus_a10_x;
  const Real n10_z = 0.0001499998887063 * (minus_wd10_y + n10_y_p3 - (n10_y_p1 - n10_x_p3)) +
      (n10_z_p1 - 0.0014999985000000002 * minus_a10_y + c11 * n11_y + s11 * n11_x);
  h[9] = n10_z;

  // link 9 (left_upperarm), outward
  const Real n9_y_p1 = minus_wd8_x + n9_x_p2;

  // link 10 (left_lowerarm), inward
  const Real n9_y_p2 = 0.0005895000784280001 * (minus_a10_x_p1 - n9_x_p1) + 4.4999986458742003e-05 *
      n9_x_p5 + 0.0012089992423205001 * n9_y_p1 - 0.0008177492704690715 * n9_x_p4;

  // link 11 (left_wrist1), inward
  const Real f10_x = 0.28049749700000004 * n10_y_p6 - 0.0014999985000000002 *
      (n10_x_p3 + n10_y_p2) + s11 * minus_f11_y + c11 * f11_x;
  const Real minus_f10_y_p1 = 0.28049749700000004 * (n10_y_p1 + n10_y_p2) + 0.0014999985000000002 *
      n10_x_p1 - 0.001 * n11_x_p2 + 6e-04 * n11_x_p1;
  const Real minus_f10_y = minus_f10_y_p1 + c12 * minus_f12_y - s12 * f12_x;

  // link 10 (left_lowerarm), inward
  const Real n9_y_p3 = s10 * minus_f10_y + c10 * f10_x;
  const Real n9_y = n10_z + (n9_y_p2 + 0.0022500062 * minus_a8_x) - 0.282 * n9_y_p3;

  // link 8 (left_shoulder2), outward
  const Real n8_y_p1 = w8_x * w8_x;
  const Real n8_y_p2 = w8_z * w8_z;
  const Real n8_y_p3 = w8_y * w8_z;
  const Real n8_y_p4 = minus_wd8_x - n8_y_p3;
  const Real n8_y_p5 = w8_x * w8_y;
  const Real n8_y_p6 = wd7_x - n8_y_p5;
  const Real n8_y_p7 = w8_x * w8_z;
  const Real n8_y_p8 = minus_wd8_y + n8_y_p7;

  // link 9 (left_upperarm), inward
  const Real n8_y_p9 = 0.00010499999999999999 * (n8_y_p1 - n8_y_p2) + 5.2499999999999995e-05 *
      n8_y_p4 - 1.75e-05 * n8_y_p6 - 0.18113119219699997 * n8_y_p8;
  const Real n8_y = n8_y_p9 + 0.7139200499999999 * minus_a7_x + c9 * n9_y + s9 * n9_x;

  // link 7 (left_shoulder1), inertial wrench
  const Real n7_z_p1 = 0.0017499999999999998 * minus_a7_x;

  // link 7 (left_shoulder1), outward
  const Real n7_z_p2 = w7_x * w7_x;
  const Real n7_z_p3 = minus_w7_y * minus_w7_y;

  // link 7 (left_shoulder1), inertial wrench
  const Real n7_z_p4 = 0.00044800000000000005 * minus_wd6_y;

  // link 7 (left_shoulder1), outward
  const Real n7_z_p5 = w7_x * minus_w7_y;

  // link 8 (left_shoulder2), inward
  const Real n7_z_p6 = n7_z_p1 + (n7_z_p4 + 8.75e-06 * (n7_z_p2 - n7_z_p3) +
      0.00014700000000000002 * n7_z_p5) - 0.0017499999999999998 * a7_y;

  // link 10 (left_lowerarm), inward
  const Real n9_z_p1 = 4.4999986458742003e-05 * (minus_a10_x_p1 - minus_a10_x_p2) -
      0.0012089992423205001 * minus_a10_x_p5 - 0.0005895000784280001 * a10_z_p2 +
      0.0027762933559338653 * minus_wd8_x;
  const Real n9_z_p2 = n9_z_p1 + 0.001140794814995722 * n9_x_p2 + 0.004500002325 * minus_a9_x -
      0.0022500062 * a9_y - c10 * n10_y;
  const Real n9_z = n9_z_p2 - s10 * n10_x;
  h[8] = n9_z;

  // link 8 (left_shoulder2), outward
  const Real minus_n8_x_p1 = w8_y * w8_y;
  const Real minus_n8_x_p2 = wd7_x + n8_y_p5;

  // link 9 (left_upperarm), inward
  const Real minus_n8_x_p3 = n7_z_p1 + 1.75e-05 * (minus_n8_x_p1 - n8_y_p2) +
      0.00010499999999999999 * minus_n8_x_p2 - 5.2499999999999995e-05 * n8_y_p8 + 0.00012075 *
      n8_y_p4;
  const Real minus_n8_x = n9_z + minus_n8_x_p3;

  // link 7 (left_shoulder1), outward
  const Real n7_z_p7 = w7_x * w7_z;
  const Real n7_z_p8 = minus_w7_y * w7_z;

  // link 8 (left_shoulder2), inward
  const Real n7_z = 2.6249999999999998e-05 * (minus_wd7_y - n7_z_p7 - (wd7_x + n7_z_p8)) -
      (n7_z_p6 - c8 * n8_y + s8 * minus_n8_x);
  h[6] = n7_z;

  // link 14 (right_shoulder1), outward
  const Real minus_w14_y = s14 * w6_z - c14 * w6_x;
  const Real wd14_x = c14 * wd5_x - s14 * minus_wd6_x - qd[13] * minus_w14_y;
  const Real w14_x = c14 * w6_z + s14 * w6_x;
  const Real minus_wd14_y = s14 * wd5_x + c14 * minus_wd6_x + qd[13] * w14_x;
  const Real w14_z = qd[13] + w6_y;

  // link 15 (right_shoulder2), outward
  const Real w15_x = s15 * w14_z - c15 * minus_w14_y;
  const Real minus_wd15_y = c15 * minus_wd6_y - s15 * minus_wd14_y + qd[14] * w15_x;
  const Real w15_z = qd[14] + w14_x;
  const Real w15_y = c15 * w14_z + s15 * minus_w14_y;

  // link 16 (right_upperarm), outward
  const Real w16_x = c16 * w15_z + s16 * w15_y;
  const Real minus_wd16_y = s16 * wd14_x + c16 * minus_wd15_y + qd[15] * w16_x;
  const Real minus_w16_y = s16 * w15_z - c16 * w15_y;
  const Real wd16_x = c16 * wd14_x - s16 * minus_wd15_y - qd[15] * minus_w16_y;

  // link 15 (right_shoulder2), outward
  const Real minus_wd15_x = s15 * minus_wd6_y + c15 * minus_wd14_y - qd[14] * w15_y;

  // link 16 (right_upperarm), outward
  const Real w16_z = qd[15] - w15_x;

  // link 17 (right_lowerarm), outward
  const Real minus_w17_y = c17 * w16_z + s17 * w16_x;
  const Real minus_wd17_x = s17 * minus_wd15_x - c17 * wd16_x + qd[16] * minus_w17_y;
  const Real w17_z = qd[16] - minus_w16_y;
  const Real minus_w17_x = s17 * w16_z - c17 * w16_x;

  // link 18 (right_wrist1), outward
  const Real w18_x = s18 * w17_z - c18 * minus_w17_x;
  const Real minus_wd18_y = c18 * minus_wd16_y - s18 * minus_wd17_x + qd[17] * w18_x;
  const Real w18_z = qd[17] + minus_w17_y;

  // link 19 (right_wrist2), outward
  const Real minus_w19_x = s19 * w18_z - c19 * w18_x;
  const Real minus_w19_y = c19 * w18_z + s19 * w18_x;
  const Real minus_n19_y_p1 = minus_w19_x * minus_w19_y;
  const Real minus_n19_y_p2 = minus_wd18_y + minus_n19_y_p1;

  // link 18 (right_wrist1), outward
  const Real w18_y = c18 * w17_z + s18 * minus_w17_x;
  const Real minus_wd18_x = s18 * minus_wd16_y + c18 * minus_wd17_x - qd[17] * w18_y;

  // link 17 (right_lowerarm), outward
  const Real minus_wd17_y = c17 * minus_wd15_x + s17 * wd16_x - qd[16] * minus_w17_x;

  // link 19 (right_wrist2), outward
  const Real minus_wd19_y = c19 * minus_wd17_y - s19 * minus_wd18_x - qd[18] * minus_w19_x;
  const Real w19_z = qd[18] + w18_y;
  const Real minus_n19_y_p3 = minus_w19_x * w19_z;
  const Real minus_n19_y_p4 = minus_wd19_y - minus_n19_y_p3;

  // link 14 (right_shoulder1), outward
  const Real a14_y_p1 = a7_y_p5 + (minus_a6_z - a7_y_p3);
  const Real a14_y_p2 = a7_y_p11 + (a6_x + a7_y_p8);
  const Real a14_y = s14 * a14_y_p1 + c14 * a14_y_p2;
  const Real minus_a14_z = minus_a7_z_p4 - (a6_y + minus_a7_z_p2);

  // link 15 (right_shoulder2), outward
  const Real minus_a15_x = s15 * minus_a14_z - c15 * a14_y;

  // link 16 (right_upperarm), outward
  const Real minus_a17_x_p1 = w16_x * w16_x;
  const Real minus_a17_x_p2 = minus_w16_y * minus_w16_y;

  // link 17 (right_lowerarm), outward
  const Real minus_a17_x_p3 = minus_a15_x + 0.282 * (minus_a17_x_p1 + minus_a17_x_p2);

  // link 14 (right_shoulder1), outward
  const Real minus_a14_x = c14 * a14_y_p1 - s14 * a14_y_p2;

  // link 15 (right_shoulder2), outward
  const Real minus_a15_y = c15 * minus_a14_z + s15 * a14_y;

  // link 16 (right_upperarm), outward
  const Real minus_a16_x = c16 * minus_a14_x + s16 * minus_a15_y;
  const Real minus_a17_x_p4 = w16_x * w16_z;
  const Real minus_a17_x_p5 = minus_wd16_y - minus_a17_x_p4;

  // link 17 (right_lowerarm), outward
  const Real minus_a17_x_p6 = minus_a16_x - 0.282 * minus_a17_x_p5;
  const Real minus_a17_x = s17 * minus_a17_x_p3 + c17 * minus_a17_x_p6;

  // link 16 (right_upperarm), outward
  const Real a16_y = s16 * minus_a14_x - c16 * minus_a15_y;
  const Real a17_z_p1 = minus_w16_y * w16_z;
  const Real a17_z_p2 = wd16_x + a17_z_p1;

  // link 17 (right_lowerarm), outward
  const Real a17_z = a16_y + 0.282 * a17_z_p2;

  // link 18 (right_wrist1), outward
  const Real a18_y = c18 * a17_z + s18 * minus_a17_x;
  const Real a19_z_p1 = w18_y * w18_z;
  const Real a19_z_p2 = minus_wd18_x + a19_z_p1;

  // link 19 (right_wrist2), outward
  const Real a19_z = a18_y - 0.269 * a19_z_p2;

  // link 17 (right_lowerarm), outward
  const Real minus_a17_y = c17 * minus_a17_x_p3 - s17 * minus_a17_x_p6;

  // link 18 (right_wrist1), outward
  const Real minus_a19_x_p1 = w18_x * w18_x;
  const Real minus_a19_x_p2 = w18_y * w18_y;

  // link 19 (right_wrist2), outward
  const Real minus_a19_x_p3 = minus_a17_y + 0.269 * (minus_a19_x_p1 + minus_a19_x_p2);

  // link 18 (right_wrist1), outward
  const Real a18_x = s18 * a17_z - c18 * minus_a17_x;
  const Real minus_a19_x_p4 = w18_x * w18_z;
  const Real minus_a19_x_p5 = minus_wd18_y - minus_a19_x_p4;

  // link 19 (right_wrist2), outward
  const Real minus_a19_x_p6 = a18_x + 0.269 * minus_a19_x_p5;
  const Real minus_a19_x = s19 * minus_a19_x_p3 - c19 * minus_a19_x_p6;

  // link 20 (right_hand), outward
  const Real w20_x = s20 * w19_z - c20 * minus_w19_y;
  const Real n20_y_p1 = w20_x * w20_x;
  const Real w20_z = qd[19] - minus_w19_x;
  const Real n20_y_p2 = w20_z * w20_z;
  const Real w20_y = c20 * w19_z + s20 * minus_w19_y;
  const Real minus_wd20_x = s20 * minus_wd18_y + c20 * minus_wd19_y - qd[19] * w20_y;
  const Real n20_y_p3 = w20_y * w20_z;
  const Real n20_y_p4 = minus_wd20_x - n20_y_p3;
  const Real n20_y_p5 = w20_x * w20_y;

  // link 19 (right_wrist2), outward
  const Real minus_wd19_x = s19 * minus_wd17_y + c19 * minus_wd18_x + qd[18] * minus_w19_y;

  // link 20 (right_hand), outward
  const Real n20_y_p6 = minus_wd19_x + n20_y_p5;
  const Real minus_wd20_y = c20 * minus_wd18_y - s20 * minus_wd19_y + qd[19] * w20_x;
  const Real n20_y_p7 = w20_x * w20_z;
  const Real n20_y_p8 = minus_wd20_y + n20_y_p7;

  // link 20 (right_hand), inertial wrench
  const Real n20_y_p9 = 0.000108260010923775 * (n20_y_p1 - n20_y_p2) + 0.0001263900573325125 *
      n20_y_p4 + 4.38600177048965e-05 * n20_y_p6 - 0.000847139515629375 * n20_y_p8;
  const Real n20_y = n20_y_p9 + 0.01626499875 * minus_a19_x;

  // link 20 (right_hand), outward
  const Real minus_n20_x_p1 = w20_y * w20_y;
  const Real minus_n20_x_p2 = minus_wd19_x - n20_y_p5;

  // link 20 (right_hand), inertial wrench
  const Real minus_n20_x_p3 = 4.38600177048965e-05 * (minus_n20_x_p1 - n20_y_p2) -
      0.000108260010923775 * minus_n20_x_p2 - 0.0001263900573325125 * n20_y_p8 +
      9.149209276993575e-05 * n20_y_p4;
  const Real minus_n20_x = minus_n20_x_p3 + 0.002865001425 * minus_a19_x;

  // link 20 (right_hand), inward
  const Real minus_n19_y = 2.4000000000000003e-06 * minus_n19_y_p2 + 0.000195227662257343 *
      minus_n19_y_p4 + 0.0025100003499999995 * a19_z + s20 * n20_y + c20 * minus_n20_x;

  // link 19 (right_wrist2), inward
  const Real n18_z_p1 = 6e-06 * (minus_a19_x_p1 - minus_a19_x_p2) + 0.0002516 * minus_a19_x_p5 -
      0.000144 * a19_z_p2 + 0.0002292 * minus_wd17_y;

  // link 18 (right_wrist1), outward
  const Real n18_z_p2 = w18_x * w18_y;

  // link 19 (right_wrist2), inward
  const Real n18_z_p3 = n18_z_p1 - 9.600000000000003e-06 * n18_z_p2 + 0.001 * a18_x + 6e-04 *
      a18_y + c19 * minus_n19_y;

  // link 19 (right_wrist2), outward
  const Real minus_a19_y = c19 * minus_a19_x_p3 + s19 * minus_a19_x_p6;

  // link 20 (right_hand), outward
  const Real a20_x = s20 * a19_z - c20 * minus_a19_y;

  // link 20 (right_hand), inertial wrench
  const Real minus_n20_z_p1 = 0.0001263900573325125 * (n20_y_p1 - minus_n20_x_p1) -
      4.38600177048965e-05 * (minus_wd20_y - n20_y_p7) - 0.000108260010923775 *
      (minus_wd20_x + n20_y_p3);

  // link 20 (right_hand), outward
  const Real a20_y = c20 * a19_z + s20 * minus_a19_y;

  // link 20 (right_hand), inertial wrench
  const Real minus_n20_z = minus_n20_z_p1 + 0.0009386316083993107 * minus_wd19_x -
      0.0007556474228594393 * n20_y_p5 + 0.002865001425 * a20_x - 0.01626499875 * a20_y;
  h[19] = -minus_n20_z;

  // link 19 (right_wrist2), outward
  const Real minus_n19_x_p1 = minus_w19_y * minus_w19_y;
  const Real minus_n19_x_p2 = w19_z * w19_z;
  const Real minus_n19_x_p3 = minus_wd19_x + minus_w19_y * w19_z;

  // link 20 (right_hand), inward
  const Real minus_n19_x = minus_n20_z - (2.4000000000000003e-06 *
      (minus_n19_x_p1 - minus_n19_x_p2) - 1.16e-05 * minus_n19_x_p3 + 0.0006000000000000001 *
      a19_z);

  // link 19 (right_wrist2), inward
  const Real n18_z = n18_z_p3 + s19 * minus_n19_x;
  h[17] = n18_z;

  // link 17 (right_lowerarm), outward
  const Real minus_n17_y_p1 = minus_w17_x * minus_w17_x;
  const Real minus_n17_y_p2 = w17_z * w17_z;
  const Real minus_n17_y_p3 = minus_w17_x * w17_z;
  const Real minus_n17_y_p4 = minus_wd17_y - minus_n17_y_p3;
  const Real minus_n17_y_p5 = minus_w17_x * minus_w17_y;
  const Real minus_n17_y_p6 = minus_wd16_y + minus_n17_y_p5;
  const Real minus_n17_y_p7 = minus_w17_y * w17_z;
  const Real minus_n17_y_p8 = minus_wd17_x + minus_n17_y_p7;

  // link 18 (right_wrist1), inward
  const Real minus_n17_y = 0.0001499998887063 * (minus_n17_y_p6 - minus_n17_y_p8) +
      (n18_z + (2.249994685315e-05 * (minus_n17_y_p1 - minus_n17_y_p2) + 0.00028099984685315 *
      minus_n17_y_p4 + 0.0014999985000000002 * a17_z));

  // link 20 (right_hand), inertial wrench
  const Real minus_f20_y = 0.002865001425 * (n20_y_p1 + n20_y_p2) + 0.01626499875 * minus_n20_x_p2;
  const Real f20_x = 0.002865001425 * n20_y_p6 - 0.01626499875 * (minus_n20_x_p1 + n20_y_p2);

  // link 20 (right_hand), inward
  const Real minus_f19_z = 0.0006000000000000001 * minus_n19_x_p3 - 0.0025100003499999995 *
      minus_n19_y_p4 + c20 * minus_f20_y - s20 * f20_x;

  // link 18 (right_wrist1), outward
  const Real minus_f18_y_p1 = w18_z * w18_z;
  const Real minus_f18_y_p2 = minus_wd17_y + n18_z_p2;

  // link 19 (right_wrist2), inward
  const Real minus_f18_y = minus_f19_z - (0.001 * (minus_a19_x_p1 + minus_f18_y_p1) + 6e-04 *
      minus_f18_y_p2);

  // link 20 (right_hand), inward
  const Real minus_f19_y_p1 = 0.0006000000000000001 * (minus_n19_x_p2 + minus_w19_x * minus_w19_x) +
      0.0025100003499999995 * (minus_wd18_y - minus_n19_y_p1) - s20 * minus_f20_y;
  const Real minus_f19_y = minus_f19_y_p1 - c20 * f20_x;
  const Real f19_x = 0.0006000000000000001 * minus_n19_y_p2 - 0.0025100003499999995 *
      (minus_n19_x_p1 + minus_n19_x_p2) - 0.002865001425 * n20_y_p4 + 0.01626499875 * n20_y_p8;

  // link 19 (right_wrist2), inward
  const Real f18_x_p1 = s19 * minus_f19_y + c19 * f19_x;

  // link 18 (right_wrist1), outward
  const Real f18_x_p2 = minus_wd17_y - n18_z_p2;

  // link 19 (right_wrist2), inward
  const Real f18_x = f18_x_p1 + (0.001 * f18_x_p2 - 6e-04 * (minus_a19_x_p2 + minus_f18_y_p1));

  // link 18 (right_wrist1), inward
  const Real minus_f17_z = 0.28049749700000004 * minus_n17_y_p8 - 0.0014999985000000002 *
      minus_n17_y_p4 + c18 * minus_f18_y - s18 * f18_x;

  // link 16 (right_upperarm), outward
  const Real minus_n16_x_p1 = w16_z * w16_z;
  const Real minus_n16_x_p2 = w16_x * minus_w16_y;
  const Real minus_n16_x_p3 = minus_wd15_x - minus_n16_x_p2;
  const Real minus_n16_x_p4 = minus_wd16_y + minus_a17_x_p4;
  const Real minus_n16_x_p5 = wd16_x - a17_z_p1;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_x_p6 = 0.0012089992423205001 * (minus_a17_x_p2 - minus_n16_x_p1) +
      0.0005895000784280001 * minus_n16_x_p3 - 4.4999986458742003e-05 * minus_n16_x_p4 -
      0.0019585440854647937 * minus_n16_x_p5;

  // link 18 (right_wrist1), outward
  const Real minus_n18_x_p1 = minus_wd18_y + minus_a19_x_p4;
  const Real minus_n18_x_p2 = minus_wd18_x - a19_z_p1;

  // link 19 (right_wrist2), inward
  const Real minus_n18_x_p3 = 0.0002516 * (minus_a19_x_p2 - minus_f18_y_p1) - 0.000144 *
      minus_f18_y_p2 + 6e-06 * minus_n18_x_p1 + 0.0001194 * minus_n18_x_p2;
  const Real minus_n18_x = minus_n18_x_p3 + 0.001 * minus_a17_y + 0.269 * minus_f19_z - s19 *
      minus_n19_y + c19 * minus_n19_x;

  // link 20 (right_hand), inward
  const Real minus_n19_z_p1 = 2.4000000000000003e-06 * (minus_wd19_y + minus_n19_y_p3) +
      0.00020682766225734302 * minus_wd18_y - 0.000183627662257343 * minus_n19_y_p1 -
      0.0006000000000000001 * minus_a19_x;
  const Real minus_n19_z = minus_n19_z_p1 + 0.0025100003499999995 * minus_a19_y - c20 * n20_y +
      s20 * minus_n20_x;
  h[18] = -minus_n19_z;

  // link 19 (right_wrist2), inward
  const Real minus_n18_y_p1 = 0.000144 * (minus_a19_x_p1 - minus_f18_y_p1) + 6e-06 *
      minus_n18_x_p2 + 0.0002516 * f18_x_p2 + 0.0001098 * minus_n18_x_p1;
  const Real minus_n18_y = minus_n19_z + (minus_n18_y_p1 + 6e-04 * minus_a17_y) + 0.269 * f18_x_p1;

  // link 17 (right_lowerarm), outward
  const Real n17_x_p1 = minus_wd16_y - minus_n17_y_p5;

  // link 18 (right_wrist1), inward
  const Real n17_x_p2 = 2.249994685315e-05 * n17_x_p1 + 0.06060754126741261 * minus_n17_y_p8 -
      0.28049749700000004 * a17_z - s18 * minus_n18_y + c18 * minus_n18_x;

  // link 17 (right_lowerarm), outward
  const Real n17_x_p3 = minus_w17_y * minus_w17_y;

  // link 18 (right_wrist1), inward
  const Real n17_x = 0.0001499998887063 * (minus_n17_y_p4 + (n17_x_p3 - minus_n17_y_p2)) - n17_x_p2;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_x = minus_n16_x_p6 + 0.004500002325 * minus_a15_x + 0.282 * minus_f17_z -
      s17 * minus_n17_y - c17 * n17_x;

  // link 18 (right_wrist1), inward
  const Real minus_n17_z_p1 = 2.249994685315e-05 * (minus_wd17_x - minus_n17_y_p7) +
      0.060888541114265754 * minus_wd16_y + 0.06032654142055946 * minus_n17_y_p5 -
      0.28049749700000004 * minus_a17_x;
  const Real minus_n17_z = 0.0001499998887063 * (minus_wd17_y + minus_n17_y_p3 +
      (minus_n17_y_p1 - n17_x_p3)) + (minus_n17_z_p1 + 0.0014999985000000002 * minus_a17_y + c18 *
      minus_n18_y + s18 * minus_n18_x);
  h[16] = -minus_n17_z;

  // link 16 (right_upperarm), outward
  const Real minus_n16_y_p1 = minus_wd15_x + minus_n16_x_p2;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_y_p2 = 0.0005895000784280001 * (minus_a17_x_p1 - minus_n16_x_p1) -
      4.4999986458742003e-05 * minus_n16_x_p5 - 0.0012089992423205001 * minus_n16_y_p1 -
      0.0008177492704690715 * minus_n16_x_p4;

  // link 18 (right_wrist1), inward
  const Real f17_x = 0.28049749700000004 * minus_n17_y_p6 - 0.0014999985000000002 *
      (n17_x_p3 + minus_n17_y_p2) + s18 * minus_f18_y + c18 * f18_x;
  const Real minus_f17_y_p1 = 0.28049749700000004 * (minus_n17_y_p1 + minus_n17_y_p2) +
      0.0014999985000000002 * n17_x_p1 + 0.001 * minus_n18_x_p2 + 6e-04 * minus_n18_x_p1;
  const Real minus_f17_y = minus_f17_y_p1 + c19 * minus_f19_y - s19 * f19_x;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_y_p3 = s17 * minus_f17_y + c17 * f17_x;
  const Real minus_n16_y = minus_n17_z - (minus_n16_y_p2 + 0.0022500062 * minus_a15_x) + 0.282 *
      minus_n16_y_p3;

  // link 15 (right_shoulder2), outward
  const Real n15_y_p1 = w15_x * w15_x;
  const Real n15_y_p2 = w15_z * w15_z;
  const Real n15_y_p3 = w15_y * w15_z;
  const Real n15_y_p4 = minus_wd15_x - n15_y_p3;
  const Real n15_y_p5 = w15_x * w15_y;
  const Real n15_y_p6 = wd14_x - n15_y_p5;
  const Real n15_y_p7 = w15_x * w15_z;
  const Real n15_y_p8 = minus_wd15_y + n15_y_p7;

  // link 16 (right_upperarm), inward
  const Real n15_y_p9 = 0.00010499999999999999 * (n15_y_p1 - n15_y_p2) - 5.2499999999999995e-05 *
      n15_y_p4 + 1.75e-05 * n15_y_p6 - 0.18113119219699997 * n15_y_p8;
  const Real n15_y = n15_y_p9 + 0.7139200499999999 * minus_a14_x - c16 * minus_n16_y - s16 *
      minus_n16_x;

  // link 14 (right_shoulder1), inertial wrench
  const Real minus_n14_z_p1 = 0.0017499999999999998 * minus_a14_x;

  // link 14 (right_shoulder1), outward
  const Real minus_n14_z_p2 = w14_x * w14_x;
  const Real minus_n14_z_p3 = minus_w14_y * minus_w14_y;
  const Real minus_n14_z_p4 = w14_x * minus_w14_y;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_z_p5 = minus_n14_z_p1 + (n7_z_p4 + 8.75e-06 *
      (minus_n14_z_p2 - minus_n14_z_p3) + 0.00014700000000000002 * minus_n14_z_p4) -
      0.0017499999999999998 * a14_y;

  // link 17 (right_lowerarm), inward
  const Real minus_n16_z_p1 = 4.4999986458742003e-05 * (minus_a17_x_p1 - minus_a17_x_p2) -
      0.0012089992423205001 * minus_a17_x_p5 + 0.0005895000784280001 * a17_z_p2 -
      0.0027762933559338653 * minus_wd15_x;
  const Real minus_n16_z_p2 = minus_n16_z_p1 - 0.001140794814995722 * minus_n16_x_p2 +
      0.004500002325 * minus_a16_x + 0.0022500062 * a16_y - c17 * minus_n17_y;
  const Real minus_n16_z = minus_n16_z_p2 + s17 * n17_x;
  h[15] = -minus_n16_z;

  // link 15 (right_shoulder2), outward
  const Real n15_x_p1 = w15_y * w15_y;
  const Real n15_x_p2 = wd14_x + n15_y_p5;

  // link 16 (right_upperarm), inward
  const Real n15_x_p3 = minus_n14_z_p1 + 1.75e-05 * (n15_x_p1 - n15_y_p2) - 0.00010499999999999999 *
      n15_x_p2 - 5.2499999999999995e-05 * n15_y_p8 - 0.00012075 * n15_y_p4;
  const Real n15_x = minus_n16_z + n15_x_p3;

  // link 14 (right_shoulder1), outward
  const Real minus_n14_z_p6 = w14_x * w14_z;
  const Real minus_n14_z_p7 = minus_w14_y * w14_z;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_z = 2.6249999999999998e-05 *
      (minus_wd14_y - minus_n14_z_p6 - (wd14_x + minus_n14_z_p7)) +
      (minus_n14_z_p5 - c15 * n15_y - s15 * n15_x);
  h[13] = -minus_n14_z;

  // link 21 (neck), outward
  const Real w21_x = c21 * w6_z + s21 * w6_y;
  const Real a22_x_p1 = w21_x * w21_x;
  const Real minus_w21_y = s21 * w6_z - c21 * w6_y;
  const Real a22_x_p2 = minus_w21_y * minus_w21_y;

  // link 22 (head), outward
  const Real a22_x_p3 = a6_x + 0.394 * (a22_x_p1 + a22_x_p2);

  // link 21 (neck), outward
  const Real minus_wd21_y = s21 * wd5_x + c21 * minus_wd6_y + qd[20] * w21_x;
  const Real w21_z = qd[20] - w6_x;
  const Real a22_x_p4 = w21_x * w21_z;

  // link 22 (head), outward
  const Real a22_x_p5 = c21 * minus_a6_z - s21 * a6_y + 0.394 * (minus_wd21_y - a22_x_p4);
  const Real a22_x = s22 * a22_x_p3 - c22 * a22_x_p5;
  const Real minus_w22_x = s22 * w21_z - c22 * w21_x;
  const Real minus_n22_z_p1 = minus_w22_x * minus_w22_x;
  const Real minus_w22_y = c22 * w21_z + s22 * w21_x;
  const Real minus_n22_z_p2 = minus_w22_y * minus_w22_y;
  const Real minus_n22_z_p3 = minus_w22_x * minus_w22_y;

  // link 23 (left_eye), inward
  const Real minus_n22_z_p4 = 0.0074 * (minus_n22_z_p1 - minus_n22_z_p2) - 0.06394132500000001 *
      minus_wd21_y - 0.04506407500000001 * minus_n22_z_p3 + 0.43200000000000005 * a22_x;

  // link 22 (head), outward
  const Real a22_y = c22 * a22_x_p3 + s22 * a22_x_p5;
  const Real w22_z = qd[21] - minus_w21_y;

  // link 24 (right_eye), outward
  const Real w24_x = s24 * w22_z - c24 * minus_w22_x;
  const Real w24_z = qd[23] + minus_w22_y;
  const Real minus_n24_y_p1 = w24_z * w24_z;

  // link 21 (neck), outward
  const Real wd21_x = c21 * wd5_x - s21 * minus_wd6_y - qd[20] * minus_w21_y;

  // link 22 (head), outward
  const Real minus_wd22_x = s22 * minus_wd6_x - c22 * wd21_x + qd[21] * minus_w22_y;

  // link 24 (right_eye), outward
  const Real minus_n24_y_p2 = w24_x * (qd[23] + w24_z) + (c24 * minus_wd21_y - s24 * minus_wd22_x);

  // link 22 (head), outward
  const Real a24_z_p1 = minus_w22_y * w22_z;

  // link 23 (left_eye), outward
  const Real a24_z_p2 = 0.032 * (minus_wd22_x - a24_z_p1);

  // link 22 (head), outward
  const Real a24_z_p3 = minus_wd21_y - minus_n22_z_p3;

  // link 23 (left_eye), outward
  const Real a24_z_p4 = 0.095 * a24_z_p3;

  // link 24 (right_eye), outward
  const Real a24_z = a24_z_p4 - (a22_y - a24_z_p2);

  // link 24 (right_eye), inertial wrench
  const Real minus_n24_y = 2.8750000000000004e-05 * (minus_n24_y_p1 - w24_x * w24_x) + 5.25e-06 *
      minus_n24_y_p2 + 0.00025 * a24_z;

  // link 24 (right_eye), outward
  const Real w24_y = c24 * w22_z + s24 * minus_w22_x;
  const Real minus_n24_x_p1 = w24_x * w24_y;

  // link 22 (head), outward
  const Real minus_wd22_y = c22 * minus_wd6_x + s22 * wd21_x - qd[21] * minus_w22_x;

  // link 24 (right_eye), outward
  const Real minus_n24_x_p2 = minus_wd22_y + minus_n24_x_p1;
  const Real minus_wd24_x = s24 * minus_wd21_y + c24 * minus_wd22_x - qd[23] * w24_y;
  const Real minus_n24_x_p3 = w24_y * w24_z;

  // link 24 (right_eye), inertial wrench
  const Real minus_n24_x = 2.8750000000000004e-05 * minus_n24_x_p2 + 4e-06 *
      (minus_wd24_x - minus_n24_x_p3);

  // link 23 (left_eye), outward
  const Real w23_x = s23 * w22_z - c23 * minus_w22_x;
  const Real w23_z = qd[22] + minus_w22_y;
  const Real minus_n23_y_p1 = w23_z * w23_z;
  const Real minus_n23_y_p2 = w23_x * (qd[22] + w23_z) + (c23 * minus_wd21_y - s23 * minus_wd22_x);
  const Real a23_z = a24_z_p4 - (a22_y + a24_z_p2);

  // link 23 (left_eye), inertial wrench
  const Real minus_n23_y = 2.8750000000000004e-05 * (minus_n23_y_p1 - w23_x * w23_x) + 5.25e-06 *
      minus_n23_y_p2 + 0.00025 * a23_z;

  // link 23 (left_eye), inward
  const Real minus_n22_z_p5 = minus_n22_z_p4 + 0.072575 * a22_y - c24 * minus_n24_y - s24 *
      minus_n24_x - c23 * minus_n23_y;

  // link 23 (left_eye), outward
  const Real w23_y = c23 * w22_z + s23 * minus_w22_x;
  const Real minus_n23_x_p1 = w23_x * w23_y;
  const Real minus_n23_x_p2 = minus_wd22_y + minus_n23_x_p1;
  const Real minus_wd23_x = s23 * minus_wd21_y + c23 * minus_wd22_x - qd[22] * w23_y;
  const Real minus_n23_x_p3 = w23_y * w23_z;

  // link 23 (left_eye), inertial wrench
  const Real minus_n23_x = 2.8750000000000004e-05 * minus_n23_x_p2 + 4e-06 *
      (minus_wd23_x - minus_n23_x_p3);

  // link 23 (left_eye), inward
  const Real minus_n22_z_p6 = minus_n23_y_p2 + minus_n24_y_p2;
  const Real minus_n22_z = 2.375e-05 * minus_n22_z_p6 - (minus_n22_z_p5 - s23 * minus_n23_x);
  h[21] = -minus_n22_z;

  // link 21 (neck), outward
  const Real minus_n21_y_p1 = w21_z * w21_z;
  const Real minus_n21_y_p2 = minus_wd21_y + a22_x_p4;

  // link 22 (head), outward
  const Real minus_f22_y_p1 = w22_z * w22_z;

  // link 23 (left_eye), inward
  const Real minus_f22_y = 0.00025 * minus_n22_z_p6 -
      (0.43200000000000005 * (minus_n22_z_p1 + minus_f22_y_p1) - 0.072575 * a24_z_p3);

  // link 24 (right_eye), inertial wrench
  const Real f24_y = 0.00025 * minus_n24_x_p2;
  const Real minus_f24_x = 0.00025 * (minus_n24_y_p1 + w24_y * w24_y);

  // link 24 (right_eye), inward
  const Real minus_f22_x_p1 = s24 * f24_y + c24 * minus_f24_x;

  // link 23 (left_eye), outward
  const Real minus_f22_x_p2 = minus_n22_z_p2 + minus_f22_y_p1;

  // link 23 (left_eye), inertial wrench
  const Real f23_y = 0.00025 * minus_n23_x_p2;
  const Real minus_f23_x = 0.00025 * (minus_n23_y_p1 + w23_y * w23_y);

  // link 23 (left_eye), inward
  const Real minus_f22_x_p3 = s23 * f23_y + c23 * minus_f23_x;
  const Real minus_f22_x = minus_f22_x_p3 + (minus_f22_x_p1 +
      (0.43200000000000005 * (minus_wd21_y + minus_n22_z_p3) + 0.072575 * minus_f22_x_p2));

  // link 22 (head), inward
  const Real minus_n21_y_p3 = s22 * minus_f22_y - c22 * minus_f22_x;
  const Real minus_n21_y = minus_n22_z - (0.0016155 * (a22_x_p1 - minus_n21_y_p1) - 0.000703125 *
      minus_n21_y_p2 + 0.0045000000000000005 * a6_x) - 0.394 * minus_n21_y_p3;

  // link 7 (left_shoulder1), inward
  const Real n6_y_p1 = 0.0187369177636143 * (minus_a7_z_p1 - a7_y_p9) + 1.66923963592404 * a7_y_p4 +
      6.1665928899999995 * minus_a6_z + c21 * minus_n21_y;

  // link 21 (neck), outward
  const Real a21_y = s21 * minus_a6_z + c21 * a6_y;
  const Real a22_z_p1 = minus_w21_y * w21_z;
  const Real a22_z_p2 = wd21_x + a22_z_p1;

  // link 22 (head), outward
  const Real a22_z = a21_y - 0.394 * a22_z_p2;

  // link 23 (left_eye), outward
  const Real a23_y_p1 = 0.032 * (minus_n22_z_p1 + minus_n22_z_p2);

  // link 22 (head), outward
  const Real a23_y_p2 = minus_w22_x * w22_z;
  const Real a23_y_p3 = minus_wd22_y - a23_y_p2;

  // link 23 (left_eye), outward
  const Real a23_y_p4 = 0.095 * a23_y_p3;
  const Real a23_y_p5 = 0.032 * (minus_wd22_y + a23_y_p2);
  const Real a23_y_p6 = 0.095 * minus_f22_x_p2;
  const Real a23_y = c23 * (a23_y_p4 + (a22_z - a23_y_p1)) + s23 * (a23_y_p6 - (a22_x - a23_y_p5));

  // link 23 (left_eye), inertial wrench
  const Real n23_z_p1 = 9.25e-06 * minus_wd22_y;
  const Real n23_z = n23_z_p1 + 2.8750000000000004e-05 * (minus_wd23_x + minus_n23_x_p3) +
      1.2499999999999999e-06 * minus_n23_x_p1 + 0.00025 * a23_y;
  h[22] = n23_z;

  // link 24 (right_eye), outward
  const Real a24_y = c24 * (a23_y_p4 + (a22_z + a23_y_p1)) + s24 * (a23_y_p6 - (a22_x + a23_y_p5));

  // link 24 (right_eye), inertial wrench
  const Real n24_z = n23_z_p1 + 2.8750000000000004e-05 * (minus_wd24_x + minus_n24_x_p3) +
      1.2499999999999999e-06 * minus_n24_x_p1 + 0.00025 * a24_y;
  h[23] = n24_z;

  // link 22 (head), outward
  const Real minus_n22_y_p1 = minus_wd22_x + a24_z_p1;

  // link 23 (left_eye), inward
  const Real minus_n22_y_p2 = 0.032 * (minus_f22_x_p1 - minus_f22_x_p3) -
      (n23_z + (n24_z + (0.0074 * minus_n22_y_p1 + 0.009438624999999999 * a23_y_p3 + 0.072575 *
      a22_z)));

  // link 24 (right_eye), inward
  const Real minus_n22_y_p3 = c24 * f24_y - s24 * minus_f24_x;

  // link 23 (left_eye), inward
  const Real minus_n22_y_p4 = c23 * f23_y - s23 * minus_f23_x;
  const Real minus_n22_y = 0.095 * (minus_n22_y_p3 + minus_n22_y_p4) - minus_n22_y_p2;
  const Real f22_z = minus_n22_y_p4 + (minus_n22_y_p3 +
      (0.43200000000000005 * minus_n22_y_p1 + 0.072575 * a23_y_p3));

  // link 21 (neck), outward
  const Real minus_n21_x_p1 = w21_x * minus_w21_y;
  const Real minus_n21_x_p2 = minus_wd6_x - minus_n21_x_p1;

  // link 22 (head), inward
  const Real minus_n21_x_p3 = 0.0016155 * minus_n21_x_p2 - 0.005513625 * (wd21_x - a22_z_p1) +
      0.394 * f22_z - s22 * minus_n22_y;

  // link 23 (left_eye), inward
  const Real n22_x_p1 = 0.0074 * a23_y_p3 + 0.05450270000000001 * minus_n22_y_p1 +
      0.43200000000000005 * a22_z - s24 * minus_n24_y + c24 * minus_n24_x;
  const Real n22_x = 8e-06 * (minus_n23_y_p2 - minus_n24_y_p2) -
      (n22_x_p1 - s23 * minus_n23_y + c23 * minus_n23_x);

  // link 22 (head), inward
  const Real minus_n21_x = minus_n21_x_p3 - c22 * n22_x;

  // link 17 (right_lowerarm), inward
  const Real minus_f16_y = minus_f17_z - (0.004500002325 * (minus_a17_x_p1 + minus_n16_x_p1) -
      0.0022500062 * minus_n16_x_p3);
  const Real f16_x = minus_n16_y_p3 + (0.004500002325 * minus_n16_y_p1 + 0.0022500062 *
      (minus_a17_x_p2 + minus_n16_x_p1));

  // link 16 (right_upperarm), inward
  const Real f15_y = 0.0017499999999999998 * (n15_y_p1 + n15_y_p2) + 0.7139200499999999 * n15_x_p2 -
      c16 * minus_f16_y + s16 * f16_x;
  const Real f15_x_p1 = 0.0017499999999999998 * n15_y_p6 - 0.7139200499999999 *
      (n15_x_p1 + n15_y_p2) + 0.004500002325 * minus_n16_x_p5 + 0.0022500062 * minus_n16_x_p4;
  const Real f15_x = f15_x_p1 - c17 * minus_f17_y + s17 * f17_x;

  // link 14 (right_shoulder1), outward
  const Real minus_f14_y_p1 = minus_wd6_y + minus_n14_z_p4;
  const Real minus_f14_y_p2 = w14_z * w14_z;

  // link 15 (right_shoulder2), inward
  const Real minus_f14_y = 0.0017499999999999998 * (minus_f14_y_p1 -
      (minus_n14_z_p2 + minus_f14_y_p2)) + (s15 * f15_y - c15 * f15_x);

  // link 14 (right_shoulder1), outward
  const Real f14_x_p1 = minus_wd6_y - minus_n14_z_p4;

  // link 15 (right_shoulder2), inward
  const Real f14_x = 0.0017499999999999998 * (n15_y_p4 -
      (f14_x_p1 + (minus_n14_z_p3 + minus_f14_y_p2))) +
      (0.7139200499999999 * n15_y_p8 + s16 * minus_f16_y + c16 * f16_x);

  // link 14 (right_shoulder1), inward
  const Real n6_y_p2 = s14 * minus_f14_y + c14 * f14_x;

  // link 10 (left_lowerarm), inward
  const Real minus_f9_y = minus_f10_z + (0.004500002325 * (minus_a10_x_p1 + n9_x_p1) +
      0.0022500062 * n9_x_p3);
  const Real f9_x = n9_y_p3 - (0.004500002325 * n9_y_p1 - 0.0022500062 *
      (minus_a10_x_p2 + n9_x_p1));

  // link 9 (left_upperarm), inward
  const Real minus_f8_y = 0.0017499999999999998 * (n8_y_p1 + n8_y_p2) - 0.7139200499999999 *
      minus_n8_x_p2 + c9 * minus_f9_y - s9 * f9_x;
  const Real minus_f8_x_p1 = 0.0017499999999999998 * n8_y_p6 + 0.7139200499999999 *
      (minus_n8_x_p1 + n8_y_p2) + 0.004500002325 * n9_x_p5 - 0.0022500062 * n9_x_p4;
  const Real minus_f8_x = minus_f8_x_p1 + c10 * minus_f10_y - s10 * f10_x;

  // link 7 (left_shoulder1), outward
  const Real minus_f7_y_p1 = minus_wd6_y + n7_z_p5;
  const Real minus_f7_y_p2 = w7_z * w7_z;

  // link 8 (left_shoulder2), inward
  const Real minus_f7_y = 0.0017499999999999998 * (minus_f7_y_p1 - (n7_z_p2 + minus_f7_y_p2)) -
      (s8 * minus_f8_y - c8 * minus_f8_x);

  // link 7 (left_shoulder1), outward
  const Real minus_f7_x_p1 = minus_wd6_y - n7_z_p5;

  // link 8 (left_shoulder2), inward
  const Real minus_f7_x = 0.0017499999999999998 * (n8_y_p4 +
      (minus_f7_x_p1 + (n7_z_p3 + minus_f7_y_p2))) - (0.7139200499999999 * n8_y_p8 + s9 *
      minus_f9_y + c9 * f9_x);

  // link 7 (left_shoulder1), inward
  const Real n6_y_p3 = s7 * minus_f7_y - c7 * minus_f7_x;
  const Real n6_y = 0.226 * (n6_y_p2 + n6_y_p3) + (n7_z -
      (minus_n14_z + (n6_y_p1 + s21 * minus_n21_x)));

  // link 22 (head), inward
  const Real f21_x = minus_n21_y_p3 - 0.0045000000000000005 * (a22_x_p2 + minus_n21_y_p1);
  const Real f21_y = f22_z + 0.0045000000000000005 * minus_n21_x_p2;

  // link 7 (left_shoulder1), inward
  const Real f6_z = n6_y_p3 + (n6_y_p2 - (6.1665928899999995 * a7_y_p4 + s21 * f21_y - c21 *
      f21_x));

  // link 5 (chest2), outward
  const Real n5_z_p1 = minus_w5_y * minus_w5_y;

  // link 6 (chest3), inward
  const Real n5_z_p2 = 0.005678398088837119 * (a6_x_p3 - n5_z_p1) - 0.203126912024134 *
      minus_wd4_y - 0.10961925816937637 * minus_a6_z_p1 - 2.2194301519999997 * minus_a5_x;

  // link 14 (right_shoulder1), inertial wrench
  const Real minus_n14_y_p1 = 0.0017499999999999998 * minus_a14_z;

  // link 14 (right_shoulder1), outward
  const Real minus_n14_y_p2 = wd14_x - minus_n14_z_p7;
  const Real minus_n14_y_p3 = minus_wd14_y + minus_n14_z_p6;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_y_p4 = minus_n14_y_p1 - (8.75e-06 * minus_n14_y_p2 + 0.0002975 *
      minus_n14_y_p3) - s15 * n15_y + c15 * n15_x;
  const Real minus_n14_y = 2.6249999999999998e-05 * (f14_x_p1 + (minus_n14_z_p2 - minus_f14_y_p2)) -
      minus_n14_y_p4;

  // link 22 (head), inward
  const Real minus_n21_z_p1 = 0.0016155 * a22_z_p2 - 0.00621675 * minus_wd6_x -
      0.0048105000000000005 * minus_n21_x_p1 - 0.0045000000000000005 * a21_y - c22 * minus_n22_y;
  const Real minus_n21_z = minus_n21_z_p1 + s22 * n22_x;
  h[20] = -minus_n21_z;

  // link 16 (right_upperarm), inward
  const Real n15_z_p1 = 5.2499999999999995e-05 * (n15_y_p1 - n15_x_p1) - 1.75e-05 *
      (minus_wd15_y - n15_y_p7) + 0.00010499999999999999 * (minus_wd15_x + n15_y_p3);
  const Real n15_z_p2 = n15_z_p1 + 0.18125194219699997 * wd14_x + 0.18101044219699997 * n15_y_p5 -
      0.0017499999999999998 * minus_a15_x - 0.7139200499999999 * minus_a15_y;
  const Real n15_z = n15_z_p2 + s16 * minus_n16_y - c16 * minus_n16_x;
  h[14] = n15_z;

  // link 15 (right_shoulder2), inward
  const Real minus_n14_x = 2.6249999999999998e-05 *
      (minus_f14_y_p1 - (minus_n14_z_p3 - minus_f14_y_p2)) -
      (n15_z + (minus_n14_y_p1 + (8.75e-06 * minus_n14_y_p3 + 0.0001505 * minus_n14_y_p2)));

  // link 7 (left_shoulder1), inward
  const Real minus_n6_x_p1 = minus_n21_z + (0.0187369177636143 * minus_a7_z_p3 -
      0.40041499999999997 * a7_y_p2) - c14 * minus_n14_y - s14 * minus_n14_x;

  // link 7 (left_shoulder1), inertial wrench
  const Real n7_y_p1 = 0.0017499999999999998 * minus_a7_z;

  // link 7 (left_shoulder1), outward
  const Real n7_y_p2 = wd7_x - n7_z_p8;
  const Real n7_y_p3 = minus_wd7_y + n7_z_p7;

  // link 8 (left_shoulder2), inward
  const Real n7_y_p4 = n7_y_p1 - (8.75e-06 * n7_y_p2 + 0.0002975 * n7_y_p3) - s8 * n8_y - c8 *
      minus_n8_x;
  const Real n7_y = 2.6249999999999998e-05 * (minus_f7_x_p1 + (n7_z_p2 - minus_f7_y_p2)) + n7_y_p4;

  // link 9 (left_upperarm), inward
  const Real minus_n8_z_p1 = 5.2499999999999995e-05 * (n8_y_p1 - minus_n8_x_p1) - 1.75e-05 *
      (minus_wd8_y - n8_y_p7) - 0.00010499999999999999 * (minus_wd8_x + n8_y_p3);
  const Real minus_n8_z_p2 = minus_n8_z_p1 - 0.18125194219699997 * wd7_x - 0.18101044219699997 *
      n8_y_p5 - 0.0017499999999999998 * minus_a8_x + 0.7139200499999999 * minus_a8_y;
  const Real minus_n8_z = minus_n8_z_p2 + s9 * n9_y - c9 * n9_x;
  h[7] = -minus_n8_z;

  // link 8 (left_shoulder2), inward
  const Real n7_x = 2.6249999999999998e-05 * (minus_f7_y_p1 - (n7_z_p3 - minus_f7_y_p2)) -
      (minus_n8_z - (n7_y_p1 + (8.75e-06 * n7_y_p3 + 0.0001505 * n7_y_p2)));

  // link 7 (left_shoulder1), inward
  const Real minus_n6_x = 0.18 * (n6_y_p2 - n6_y_p3) - (minus_n6_x_p1 + c7 * n7_y + s7 * n7_x);

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p2 - 0.069699984375 * minus_a5_y + 0.072 * f6_z + c6 * n6_y - s6 *
      minus_n6_x;
  h[4] = n5_z;

  // link 4 (chest1), outward
  const Real n4_y_p1 = qd[3] * qd[3];

  // link 7 (left_shoulder1), inward
  const Real minus_f6_x_p1 = c7 * minus_f7_y + s7 * minus_f7_x;

  // link 14 (right_shoulder1), inward
  const Real minus_f6_x_p2 = c14 * minus_f14_y - s14 * f14_x;

  // link 7 (left_shoulder1), inward
  const Real minus_f6_x_p3 = minus_f6_x_p2 - (6.1665928899999995 * a7_y_p10 -
      0.0045000000000000005 * minus_n21_y_p2 - c22 * minus_f22_y - s22 * minus_f22_x);
  const Real minus_f6_x = minus_f6_x_p1 + minus_f6_x_p3;

  // link 8 (left_shoulder2), inward
  const Real f7_z = 0.0017499999999999998 * (n7_y_p3 - n7_y_p2) -
      (c8 * minus_f8_y + s8 * minus_f8_x);

  // link 15 (right_shoulder2), inward
  const Real f14_z = 0.0017499999999999998 * (minus_n14_y_p3 - minus_n14_y_p2) +
      (c15 * f15_y + s15 * f15_x);

  // link 7 (left_shoulder1), inward
  const Real f6_y = f7_z + (f14_z - (6.1665928899999995 * minus_a7_z_p3 - c21 * f21_y - s21 *
      f21_x));

  // link 6 (chest3), inward
  const Real f5_y = 2.2194301519999997 * a6_x_p5 - 0.069699984375 * (minus_wd4_y - minus_a6_z_p1) -
      s6 * f6_y - c6 * minus_f6_x;
  const Real f5_x = f6_z - (2.2194301519999997 * minus_a6_z_p2 + 0.069699984375 *
      (n5_z_p1 + a6_x_p4));

  // link 5 (chest2), inward
  const Real n4_y_p2 = s5 * f5_y - c5 * f5_x;
  const Real n4_y = n5_z - (0.005880002159562879 * (minus_a5_x_p1 - n4_y_p1) + 0.02455520649259034 *
      minus_wd4_y - 0.0300000063 * minus_a3_y) - 0.21799999999999997 * n4_y_p2;

  // link 5 (chest2), outward
  const Real n5_y_p1 = minus_wd5_y - minus_w5_x * w5_z;

  // link 6 (chest3), inward
  const Real n5_y = 0.005678398088837119 * a6_x_p1 - 0.04675382692737882 * n5_y_p1 -
      0.069699984375 * a4_y - s6 * n6_y - c6 * minus_n6_x;
  const Real f5_z_p1 = c6 * f6_y - s6 * minus_f6_x;
  const Real f5_z = f5_z_p1 - (2.2194301519999997 * a6_x_p1 - 0.069699984375 * n5_y_p1);

  // link 4 (chest1), outward
  const Real n4_x_p1 = w4_x * w4_y;

  // link 7 (left_shoulder1), inward
  const Real minus_n6_z_p1 = 0.0187369177636143 * (minus_wd6_x + a7_y_p1) - 2.06965463592404 *
      wd5_x - 1.26882463592404 * a7_y_p7 + 6.1665928899999995 * a6_y;
  const Real minus_n6_z_p2 = minus_n6_z_p1 - s21 * minus_n21_y + c21 * minus_n21_x - s14 *
      minus_n14_y + c14 * minus_n14_x;
  const Real minus_n6_z = 0.18 * (minus_f6_x_p2 - minus_f6_x_p1) +
      (0.226 * (f14_z + f7_z) + (minus_n6_z_p2 + s7 * n7_y - c7 * n7_x));
  h[5] = -minus_n6_z;

  // link 6 (chest3), inward
  const Real minus_n5_x = minus_n6_z + (0.005678398088837119 * n5_y_p1 - 0.15637308509675518 *
      a6_x_p1 + 2.2194301519999997 * a4_y) + 0.072 * f5_z_p1;

  // link 5 (chest2), inward
  const Real n4_x = 0.005880002159562879 * n4_x_p1 + 0.095783 * wd4_x - 0.21799999999999997 * f5_z -
      s5 * n5_y - c5 * minus_n5_x;

  // link 4 (chest1), inward
  const Real minus_n3_z = 8.419374554 * minus_a3_x - 0.02999999505 * minus_a3_y - c4 * n4_y - s4 *
      n4_x;
  h[2] = -minus_n3_z;

  // link 3 (hip), outward
  const Real f3_y_p1 = w3_z * w3_z;

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * f3_y_p1 + 0.0600000126 * minus_wd4_y + c5 * f5_y + s5 * f5_x;

  // link 5 (chest2), inward
  const Real minus_f4_x = n4_y_p2 - 0.0300000063 * (minus_a5_x_p2 + n4_y_p1);
  const Real f4_y = f5_z - 0.0300000063 * n4_x_p1;

  // link 4 (chest1), inward
  const Real f3_x = 0.02999999505 * f3_y_p1 - s4 * f4_y - c4 * minus_f4_x;

  // link 3 (hip), inward
  const Real minus_n2_z_p1 = s3 * f3_y - c3 * f3_x;
  const Real minus_n2_z = minus_n3_z + (24.5839218 * minus_a2_x + 0.031999971599999996 *
      minus_a2_y) + 0.422 * minus_n2_z_p1;
  h[1] = -minus_n2_z;
  const Real f2_y = 24.5839218 * minus_a3_y_p1 + c3 * f3_y + s3 * f3_x;
  const Real minus_f2_x = minus_n2_z_p1 + 0.031999971599999996 * minus_a3_y_p1;

  // link 2 (thigh), inward
  const Real minus_n1_z = minus_n2_z + (299.6743959432 * s1 - 0.1569597827085 * c1) + 0.434 *
      (s2 * f2_y + c2 * minus_f2_x);
  h[0] = -minus_n1_z;

  // link 5 (chest2), inward
  const Real minus_n4_z = 0.03561389675370483 * n4_x_p1 + 0.0300000063 * a4_y + c5 * n5_y - s5 *
      minus_n5_x;
  h[3] = -minus_n4_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
