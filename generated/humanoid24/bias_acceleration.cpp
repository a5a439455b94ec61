// bias_acceleration: xdd = J qdd + Jd qd: the term Jd qd
// By outward recursion, Chang eq. 6.11.
// 871 flops (add 331, mul 540, div 0), sine and cosine of 20 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

void bias_acceleration(const Real (&TREELINE_RESTRICT q)[24],
    const Real (&TREELINE_RESTRICT qd)[24], Real (&TREELINE_RESTRICT bias)[12]) noexcept {
  const Real angles[20] = {q[0], q[1], q[2], q[3], q[4], q[5], q[6], q[7], q[8], q[9], q[10], q[11],
      q[12], q[13], q[14], q[15], q[16], q[17], q[18], q[19]};
  Real sines[20];
  Real cosines[20];
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

  // link 2 (thigh), outward
  const Real w2_z = qd[0] + qd[1];

  // link 3 (hip), outward
  const Real w3_z = qd[2] + w2_z;

  // link 4 (chest1), outward
  const Real w4_x = s4 * w3_z;
  const Real w4_y = c4 * w3_z;

  // link 2 (thigh), outward
  const Real a6_z_p1 = qd[0] * (0.434 * qd[0]);

  // link 3 (hip), outward
  const Real a6_z_p2 = c2 * a6_z_p1 + w2_z * (0.422 * w2_z);

  // link 2 (thigh), outward
  const Real a2_x = s2 * a6_z_p1;

  // link 5 (chest2), outward
  const Real a6_z_p3 = c3 * a6_z_p2 - s3 * a2_x + 0.21799999999999997 * (w4_x * w4_x + w4_y * w4_y);

  // link 3 (hip), outward
  const Real a3_x = s3 * a6_z_p2 + c3 * a2_x;

  // link 4 (chest1), outward
  const Real a4_x = c4 * a3_x;

  // link 5 (chest2), outward
  const Real minus_w5_x = qd[3] * s5 - c5 * w4_x;
  const Real minus_w5_y = qd[3] * c5 + s5 * w4_x;

  // link 4 (chest1), outward
  const Real minus_wd4_y = qd[3] * w4_x;

  // link 6 (chest3), outward
  const Real a6_z = s5 * a6_z_p3 + c5 * a4_x - 0.072 * (minus_wd4_y + minus_w5_x * minus_w5_y);

  // link 4 (chest1), outward
  const Real wd4_x = qd[3] * w4_y;

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * wd4_x - qd[4] * minus_w5_x;
  const Real w5_z = qd[4] + w4_y;

  // link 6 (chest3), outward
  const Real w6_y = c6 * w5_z + s6 * minus_w5_y;
  const Real minus_wd6_x = s6 * minus_wd4_y + c6 * minus_wd5_y - qd[5] * w6_y;
  const Real w6_z = qd[5] - minus_w5_x;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p1 = 0.18 * (minus_wd6_x - w6_y * w6_z);

  // link 6 (chest3), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real minus_wd6_y = c6 * minus_wd4_y - s6 * minus_wd5_y + qd[5] * w6_x;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p2 = 0.226 * (minus_wd6_y + w6_x * w6_z);
  const Real a7_y_p3 = a7_y_p2 - (a6_z - a7_y_p1);

  // link 6 (chest3), outward
  const Real a7_y_p4 = w6_z * w6_z;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p5 = 0.226 * (a7_y_p4 + w6_y * w6_y);

  // link 6 (chest3), outward
  const Real minus_a6_x_p1 = c5 * a6_z_p3 - s5 * a4_x + 0.072 *
      (minus_w5_x * minus_w5_x + w5_z * w5_z);

  // link 5 (chest2), outward
  const Real wd5_x = c5 * wd4_x - qd[4] * minus_w5_y;

  // link 6 (chest3), outward
  const Real minus_a6_x_p2 = s4 * a3_x + 0.072 * (wd5_x - minus_w5_y * w5_z);
  const Real minus_a6_x = s6 * minus_a6_x_p2 - c6 * minus_a6_x_p1;
  const Real a7_y_p6 = w6_x * w6_y;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p7 = 0.18 * (wd5_x - a7_y_p6);
  const Real a7_y_p8 = a7_y_p5 - (minus_a6_x + a7_y_p7);
  const Real a7_y = s7 * a7_y_p3 + c7 * a7_y_p8;

  // link 6 (chest3), outward
  const Real minus_a6_y = c6 * minus_a6_x_p2 + s6 * minus_a6_x_p1;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_z_p1 = 0.18 * (a7_y_p4 + w6_x * w6_x);
  const Real minus_a7_z_p2 = 0.226 * (wd5_x + a7_y_p6);
  const Real minus_a7_z = minus_a7_z_p2 + (minus_a6_y + minus_a7_z_p1);
  const Real w7_x = c7 * w6_z + s7 * w6_x;

  // link 8 (left_shoulder2), outward
  const Real w8_z = qd[7] + w7_x;

  // link 7 (left_shoulder1), outward
  const Real minus_w7_y = s7 * w6_z - c7 * w6_x;
  const Real w7_z = qd[6] + w6_y;

  // link 8 (left_shoulder2), outward
  const Real w8_y = c8 * w7_z + s8 * minus_w7_y;

  // link 9 (left_upperarm), outward
  const Real w9_x = c9 * w8_z + s9 * w8_y;
  const Real minus_w9_y = s9 * w8_z - c9 * w8_y;

  // link 10 (left_lowerarm), outward
  const Real bias_0_p1 = s8 * minus_a7_z - c8 * a7_y + 0.282 *
      (w9_x * w9_x + minus_w9_y * minus_w9_y);

  // link 7 (left_shoulder1), outward
  const Real minus_a7_x = c7 * a7_y_p3 - s7 * a7_y_p8;

  // link 8 (left_shoulder2), outward
  const Real minus_a8_y = c8 * minus_a7_z + s8 * a7_y;

  // link 7 (left_shoulder1), outward
  const Real wd7_x = c7 * wd5_x - s7 * minus_wd6_x - qd[6] * minus_w7_y;
  const Real minus_wd7_y = s7 * wd5_x + c7 * minus_wd6_x + qd[6] * w7_x;

  // link 8 (left_shoulder2), outward
  const Real w8_x = s8 * w7_z - c8 * minus_w7_y;
  const Real minus_wd8_y = c8 * minus_wd6_y - s8 * minus_wd7_y + qd[7] * w8_x;

  // link 9 (left_upperarm), outward
  const Real minus_wd9_y = s9 * wd7_x + c9 * minus_wd8_y + qd[8] * w9_x;
  const Real w9_z = qd[8] - w8_x;

  // link 10 (left_lowerarm), outward
  const Real bias_0_p2 = c9 * minus_a7_x + s9 * minus_a8_y - 0.282 * (minus_wd9_y - w9_x * w9_z);
  const Real w10_z = qd[9] - minus_w9_y;
  const Real minus_w10_x = s10 * w9_z - c10 * w9_x;

  // link 11 (left_wrist1), outward
  const Real w11_x = s11 * w10_z - c11 * minus_w10_x;
  const Real w11_y = c11 * w10_z + s11 * minus_w10_x;

  // link 12 (left_wrist2), outward
  const Real bias_0_p3 = c10 * bias_0_p1 - s10 * bias_0_p2 + 0.269 *
      (w11_x * w11_x + w11_y * w11_y);

  // link 10 (left_lowerarm), outward
  const Real minus_a10_x = s10 * bias_0_p1 + c10 * bias_0_p2;

  // link 9 (left_upperarm), outward
  const Real wd9_x = c9 * wd7_x - s9 * minus_wd8_y - qd[8] * minus_w9_y;

  // link 10 (left_lowerarm), outward
  const Real a10_z = s9 * minus_a7_x - c9 * minus_a8_y + 0.282 * (wd9_x + minus_w9_y * w9_z);

  // link 8 (left_shoulder2), outward
  const Real minus_wd8_x = s8 * minus_wd6_y + c8 * minus_wd7_y - qd[7] * w8_y;

  // link 10 (left_lowerarm), outward
  const Real minus_w10_y = c10 * w9_z + s10 * w9_x;
  const Real minus_wd10_x = s10 * minus_wd8_x - c10 * wd9_x + qd[9] * minus_w10_y;

  // link 11 (left_wrist1), outward
  const Real minus_wd11_y = c11 * minus_wd9_y - s11 * minus_wd10_x + qd[10] * w11_x;
  const Real w11_z = qd[10] + minus_w10_y;

  // link 12 (left_wrist2), outward
  const Real bias_0_p4 = s11 * a10_z - c11 * minus_a10_x + 0.269 * (minus_wd11_y - w11_x * w11_z);

  // link 11 (left_wrist1), outward
  const Real minus_wd11_x = s11 * minus_wd9_y + c11 * minus_wd10_x - qd[10] * w11_y;

  // link 10 (left_lowerarm), outward
  const Real minus_wd10_y = c10 * minus_wd8_x + s10 * wd9_x - qd[9] * minus_w10_x;

  // link 12 (left_wrist2), outward
  const Real minus_w12_x = s12 * w11_z - c12 * w11_x;
  const Real minus_wd12_y = c12 * minus_wd10_y - s12 * minus_wd11_x - qd[11] * minus_w12_x;
  const Real w12_z = qd[11] + w11_y;
  const Real minus_w12_y = c12 * w11_z + s12 * w11_x;

  // link 13 (left_hand), outward
  const Real w13_x = s13 * w12_z - c13 * minus_w12_y;
  const Real minus_wd13_y = c13 * minus_wd11_y - s13 * minus_wd12_y + qd[12] * w13_x;
  const Real w13_z = qd[12] - minus_w12_x;

  // link 24 (right_eye), outward
  const Real bias_0_p5 = s12 * bias_0_p3 - c12 * bias_0_p4 - 0.086 * (minus_wd13_y + w13_x * w13_z);

  // link 2 (thigh), pose
  const Real bias_0_p6 = s1 * c2 + c1 * s2;
  const Real bias_0_p7 = s1 * s2 - c1 * c2;

  // link 3 (hip), pose
  const Real bias_0_p8 = c3 * bias_0_p6 - s3 * bias_0_p7;
  const Real bias_0_p9 = s3 * bias_0_p6 + c3 * bias_0_p7;

  // link 4 (chest1), pose
  const Real bias_0_p10 = c4 * bias_0_p9;

  // link 5 (chest2), pose
  const Real bias_0_p11 = s5 * bias_0_p8 + c5 * bias_0_p10;
  const Real bias_0_p12 = c5 * bias_0_p8 - s5 * bias_0_p10;

  // link 4 (chest1), pose
  const Real bias_0_p13 = s4 * bias_0_p9;

  // link 6 (chest3), pose
  const Real bias_0_p14 = s6 * bias_0_p13 - c6 * bias_0_p12;

  // link 7 (left_shoulder1), pose
  const Real bias_0_p15 = c7 * bias_0_p11 - s7 * bias_0_p14;
  const Real bias_0_p16 = s7 * bias_0_p11 + c7 * bias_0_p14;

  // link 6 (chest3), pose
  const Real bias_0_p17 = c6 * bias_0_p13 + s6 * bias_0_p12;

  // link 8 (left_shoulder2), pose
  const Real bias_0_p18 = c8 * bias_0_p17 - s8 * bias_0_p16;

  // link 9 (left_upperarm), pose
  const Real bias_0_p19 = s9 * bias_0_p15 + c9 * bias_0_p18;
  const Real bias_0_p20 = c9 * bias_0_p15 - s9 * bias_0_p18;

  // link 8 (left_shoulder2), pose
  const Real bias_0_p21 = s8 * bias_0_p17 + c8 * bias_0_p16;

  // link 10 (left_lowerarm), pose
  const Real bias_0_p22 = s10 * bias_0_p21 - c10 * bias_0_p20;

  // link 11 (left_wrist1), pose
  const Real bias_0_p23 = s11 * bias_0_p19 + c11 * bias_0_p22;

  // link 10 (left_lowerarm), pose
  const Real bias_0_p24 = c10 * bias_0_p21 + s10 * bias_0_p20;

  // link 12 (left_wrist2), pose
  const Real bias_0_p25 = s12 * bias_0_p24 + c12 * bias_0_p23;

  // link 12 (left_wrist2), outward
  const Real minus_a12_y = c12 * bias_0_p3 + s12 * bias_0_p4;
  const Real a12_z = c11 * a10_z + s11 * minus_a10_x - 0.269 * (minus_wd11_x + w11_y * w11_z);

  // link 13 (left_hand), outward
  const Real w13_y = c13 * w12_z + s13 * minus_w12_y;

  // link 12 (left_wrist2), outward
  const Real minus_wd12_x = s12 * minus_wd10_y + c12 * minus_wd11_x + qd[11] * minus_w12_y;

  // link 24 (right_eye), outward
  const Real bias_0_p26 = c13 * a12_z + s13 * minus_a12_y - 0.086 * (minus_wd12_x - w13_x * w13_y);

  // link 11 (left_wrist1), pose
  const Real bias_0_p27 = c11 * bias_0_p19 - s11 * bias_0_p22;

  // link 12 (left_wrist2), pose
  const Real bias_0_p28 = c12 * bias_0_p24 - s12 * bias_0_p23;

  // link 13 (left_hand), pose
  const Real bias_0_p29 = c13 * bias_0_p27 - s13 * bias_0_p28;

  // link 24 (right_eye), outward
  const Real bias_0_p30 = s13 * a12_z - c13 * minus_a12_y - 0.086 * (w13_y * w13_y + w13_z * w13_z);

  // link 13 (left_hand), pose
  const Real bias_0_p31 = s13 * bias_0_p27 + c13 * bias_0_p28;

  // link 24 (right_eye), outward
  bias[0] = -(bias_0_p25 * bias_0_p5 - bias_0_p29 * bias_0_p26 - bias_0_p31 * bias_0_p30);

  // link 5 (chest2), pose
  const Real bias_1_p1 = s4 * s5;

  // link 6 (chest3), pose
  const Real bias_1_p2 = c4 * c6 + s6 * bias_1_p1;
  const Real bias_1_p3 = c4 * s6 - c6 * bias_1_p1;

  // link 5 (chest2), pose
  const Real bias_1_p4 = s4 * c5;

  // link 7 (left_shoulder1), pose
  const Real bias_1_p5 = s7 * bias_1_p4 - c7 * bias_1_p3;

  // link 8 (left_shoulder2), pose
  const Real bias_1_p6 = s8 * bias_1_p2 - c8 * bias_1_p5;
  const Real bias_1_p7 = c8 * bias_1_p2 + s8 * bias_1_p5;

  // link 7 (left_shoulder1), pose
  const Real bias_1_p8 = c7 * bias_1_p4 + s7 * bias_1_p3;

  // link 9 (left_upperarm), pose
  const Real bias_1_p9 = c9 * bias_1_p8 + s9 * bias_1_p7;

  // link 10 (left_lowerarm), pose
  const Real bias_1_p10 = c10 * bias_1_p6 - s10 * bias_1_p9;
  const Real bias_1_p11 = s10 * bias_1_p6 + c10 * bias_1_p9;

  // link 9 (left_upperarm), pose
  const Real bias_1_p12 = s9 * bias_1_p8 - c9 * bias_1_p7;

  // link 11 (left_wrist1), pose
  const Real bias_1_p13 = s11 * bias_1_p12 - c11 * bias_1_p11;

  // link 12 (left_wrist2), pose
  const Real bias_1_p14 = s12 * bias_1_p10 - c12 * bias_1_p13;
  const Real bias_1_p15 = c12 * bias_1_p10 + s12 * bias_1_p13;

  // link 11 (left_wrist1), pose
  const Real bias_1_p16 = c11 * bias_1_p12 + s11 * bias_1_p11;

  // link 13 (left_hand), pose
  const Real bias_1_p17 = c13 * bias_1_p16 + s13 * bias_1_p15;
  const Real bias_1_p18 = s13 * bias_1_p16 - c13 * bias_1_p15;

  // link 24 (right_eye), outward
  bias[1] = -(bias_1_p14 * bias_0_p5 + bias_1_p17 * bias_0_p26 + bias_1_p18 * bias_0_p30);

  // link 4 (chest1), pose
  const Real bias_2_p1 = c4 * bias_0_p8;

  // link 5 (chest2), pose
  const Real bias_2_p2 = s5 * bias_0_p9 - c5 * bias_2_p1;
  const Real bias_2_p3 = c5 * bias_0_p9 + s5 * bias_2_p1;

  // link 4 (chest1), pose
  const Real bias_2_p4 = s4 * bias_0_p8;

  // link 6 (chest3), pose
  const Real bias_2_p5 = s6 * bias_2_p4 + c6 * bias_2_p3;

  // link 7 (left_shoulder1), pose
  const Real bias_2_p6 = c7 * bias_2_p2 + s7 * bias_2_p5;
  const Real bias_2_p7 = s7 * bias_2_p2 - c7 * bias_2_p5;

  // link 6 (chest3), pose
  const Real bias_2_p8 = c6 * bias_2_p4 - s6 * bias_2_p3;

  // link 8 (left_shoulder2), pose
  const Real bias_2_p9 = c8 * bias_2_p8 + s8 * bias_2_p7;

  // link 9 (left_upperarm), pose
  const Real bias_2_p10 = s9 * bias_2_p6 - c9 * bias_2_p9;
  const Real bias_2_p11 = c9 * bias_2_p6 + s9 * bias_2_p9;

  // link 8 (left_shoulder2), pose
  const Real bias_2_p12 = s8 * bias_2_p8 - c8 * bias_2_p7;

  // link 10 (left_lowerarm), pose
  const Real bias_2_p13 = s10 * bias_2_p12 + c10 * bias_2_p11;

  // link 11 (left_wrist1), pose
  const Real bias_2_p14 = s11 * bias_2_p10 - c11 * bias_2_p13;

  // link 10 (left_lowerarm), pose
  const Real bias_2_p15 = c10 * bias_2_p12 - s10 * bias_2_p11;

  // link 12 (left_wrist2), pose
  const Real bias_2_p16 = s12 * bias_2_p15 - c12 * bias_2_p14;

  // link 11 (left_wrist1), pose
  const Real bias_2_p17 = c11 * bias_2_p10 + s11 * bias_2_p13;

  // link 12 (left_wrist2), pose
  const Real bias_2_p18 = c12 * bias_2_p15 + s12 * bias_2_p14;

  // link 13 (left_hand), pose
  const Real bias_2_p19 = c13 * bias_2_p17 + s13 * bias_2_p18;
  const Real bias_2_p20 = s13 * bias_2_p17 - c13 * bias_2_p18;

  // link 24 (right_eye), outward
  bias[2] = -(bias_2_p16 * bias_0_p5 + bias_2_p19 * bias_0_p26 + bias_2_p20 * bias_0_p30);

  // link 13 (left_hand), outward
  const Real minus_wd13_x = s13 * minus_wd11_y + c13 * minus_wd12_y - qd[12] * w13_y;

  // link 24 (right_eye), outward
  bias[3] = -(bias_0_p25 * minus_wd12_x + bias_0_p29 * minus_wd13_y + bias_0_p31 * minus_wd13_x);
  bias[4] = -(bias_1_p14 * minus_wd12_x - bias_1_p17 * minus_wd13_y - bias_1_p18 * minus_wd13_x);
  bias[5] = -(bias_2_p16 * minus_wd12_x - bias_2_p19 * minus_wd13_y - bias_2_p20 * minus_wd13_x);

  // link 14 (right_shoulder1), outward
  const Real a14_y_p1 = a7_y_p2 - (a6_z + a7_y_p1);
  const Real a14_y_p2 = a7_y_p5 - (minus_a6_x - a7_y_p7);
  const Real a14_y = s14 * a14_y_p1 + c14 * a14_y_p2;
  const Real minus_a14_z = minus_a7_z_p2 + (minus_a6_y - minus_a7_z_p1);
  const Real w14_x = c14 * w6_z + s14 * w6_x;

  // link 15 (right_shoulder2), outward
  const Real w15_z = qd[14] + w14_x;

  // link 14 (right_shoulder1), outward
  const Real minus_w14_y = s14 * w6_z - c14 * w6_x;
  const Real w14_z = qd[13] + w6_y;

  // link 15 (right_shoulder2), outward
  const Real w15_y = c15 * w14_z + s15 * minus_w14_y;

  // link 16 (right_upperarm), outward
  const Real w16_x = c16 * w15_z + s16 * w15_y;
  const Real minus_w16_y = s16 * w15_z - c16 * w15_y;

  // link 17 (right_lowerarm), outward
  const Real bias_6_p1 = s15 * minus_a14_z - c15 * a14_y + 0.282 *
      (w16_x * w16_x + minus_w16_y * minus_w16_y);

  // link 14 (right_shoulder1), outward
  const Real minus_a14_x = c14 * a14_y_p1 - s14 * a14_y_p2;

  // link 15 (right_shoulder2), outward
  const Real minus_a15_y = c15 * minus_a14_z + s15 * a14_y;

  // link 14 (right_shoulder1), outward
  const Real wd14_x = c14 * wd5_x - s14 * minus_wd6_x - qd[13] * minus_w14_y;
  const Real minus_wd14_y = s14 * wd5_x + c14 * minus_wd6_x + qd[13] * w14_x;

  // link 15 (right_shoulder2), outward
  const Real w15_x = s15 * w14_z - c15 * minus_w14_y;
  const Real minus_wd15_y = c15 * minus_wd6_y - s15 * minus_wd14_y + qd[14] * w15_x;

  // link 16 (right_upperarm), outward
  const Real minus_wd16_y = s16 * wd14_x + c16 * minus_wd15_y + qd[15] * w16_x;
  const Real w16_z = qd[15] - w15_x;

  // link 17 (right_lowerarm), outward
  const Real bias_6_p2 = c16 * minus_a14_x + s16 * minus_a15_y - 0.282 *
      (minus_wd16_y - w16_x * w16_z);
  const Real w17_z = qd[16] - minus_w16_y;
  const Real minus_w17_x = s17 * w16_z - c17 * w16_x;

  // link 18 (right_wrist1), outward
  const Real w18_x = s18 * w17_z - c18 * minus_w17_x;
  const Real w18_y = c18 * w17_z + s18 * minus_w17_x;

  // link 19 (right_wrist2), outward
  const Real bias_6_p3 = c17 * bias_6_p1 - s17 * bias_6_p2 + 0.269 *
      (w18_x * w18_x + w18_y * w18_y);

  // link 17 (right_lowerarm), outward
  const Real minus_a17_x = s17 * bias_6_p1 + c17 * bias_6_p2;

  // link 16 (right_upperarm), outward
  const Real wd16_x = c16 * wd14_x - s16 * minus_wd15_y - qd[15] * minus_w16_y;

  // link 17 (right_lowerarm), outward
  const Real a17_z = s16 * minus_a14_x - c16 * minus_a15_y + 0.282 * (wd16_x + minus_w16_y * w16_z);

  // link 15 (right_shoulder2), outward
  const Real minus_wd15_x = s15 * minus_wd6_y + c15 * minus_wd14_y - qd[14] * w15_y;

  // link 17 (right_lowerarm), outward
  const Real minus_w17_y = c17 * w16_z + s17 * w16_x;
  const Real minus_wd17_x = s17 * minus_wd15_x - c17 * wd16_x + qd[16] * minus_w17_y;

  // link 18 (right_wrist1), outward
  const Real minus_wd18_y = c18 * minus_wd16_y - s18 * minus_wd17_x + qd[17] * w18_x;
  const Real w18_z = qd[17] + minus_w17_y;

  // link 19 (right_wrist2), outward
  const Real bias_6_p4 = s18 * a17_z - c18 * minus_a17_x + 0.269 * (minus_wd18_y - w18_x * w18_z);

  // link 18 (right_wrist1), outward
  const Real minus_wd18_x = s18 * minus_wd16_y + c18 * minus_wd17_x - qd[17] * w18_y;

  // link 17 (right_lowerarm), outward
  const Real minus_wd17_y = c17 * minus_wd15_x + s17 * wd16_x - qd[16] * minus_w17_x;

  // link 19 (right_wrist2), outward
  const Real minus_w19_x = s19 * w18_z - c19 * w18_x;
  const Real minus_wd19_y = c19 * minus_wd17_y - s19 * minus_wd18_x - qd[18] * minus_w19_x;
  const Real w19_z = qd[18] + w18_y;
  const Real minus_w19_y = c19 * w18_z + s19 * w18_x;

  // link 20 (right_hand), outward
  const Real w20_x = s20 * w19_z - c20 * minus_w19_y;
  const Real minus_wd20_y = c20 * minus_wd18_y - s20 * minus_wd19_y + qd[19] * w20_x;
  const Real w20_z = qd[19] - minus_w19_x;

  // link 24 (right_eye), outward
  const Real bias_6_p5 = s19 * bias_6_p3 - c19 * bias_6_p4 - 0.086 * (minus_wd20_y + w20_x * w20_z);

  // link 14 (right_shoulder1), pose
  const Real bias_6_p6 = c14 * bias_0_p11 - s14 * bias_0_p14;
  const Real bias_6_p7 = s14 * bias_0_p11 + c14 * bias_0_p14;

  // link 15 (right_shoulder2), pose
  const Real bias_6_p8 = c15 * bias_0_p17 - s15 * bias_6_p7;

  // link 16 (right_upperarm), pose
  const Real bias_6_p9 = s16 * bias_6_p6 + c16 * bias_6_p8;
  const Real bias_6_p10 = c16 * bias_6_p6 - s16 * bias_6_p8;

  // link 15 (right_shoulder2), pose
  const Real bias_6_p11 = s15 * bias_0_p17 + c15 * bias_6_p7;

  // link 17 (right_lowerarm), pose
  const Real bias_6_p12 = s17 * bias_6_p11 - c17 * bias_6_p10;

  // link 18 (right_wrist1), pose
  const Real bias_6_p13 = s18 * bias_6_p9 + c18 * bias_6_p12;

  // link 17 (right_lowerarm), pose
  const Real bias_6_p14 = c17 * bias_6_p11 + s17 * bias_6_p10;

  // link 19 (right_wrist2), pose
  const Real bias_6_p15 = s19 * bias_6_p14 + c19 * bias_6_p13;

  // link 19 (right_wrist2), outward
  const Real minus_a19_y = c19 * bias_6_p3 + s19 * bias_6_p4;
  const Real a19_z = c18 * a17_z + s18 * minus_a17_x - 0.269 * (minus_wd18_x + w18_y * w18_z);

  // link 20 (right_hand), outward
  const Real w20_y = c20 * w19_z + s20 * minus_w19_y;

  // link 19 (right_wrist2), outward
  const Real minus_wd19_x = s19 * minus_wd17_y + c19 * minus_wd18_x + qd[18] * minus_w19_y;

  // link 24 (right_eye), outward
  const Real bias_6_p16 = c20 * a19_z + s20 * minus_a19_y - 0.086 * (minus_wd19_x - w20_x * w20_y);

  // link 18 (right_wrist1), pose
  const Real bias_6_p17 = c18 * bias_6_p9 - s18 * bias_6_p12;

  // link 19 (right_wrist2), pose
  const Real bias_6_p18 = c19 * bias_6_p14 - s19 * bias_6_p13;

  // link 20 (right_hand), pose
  const Real bias_6_p19 = c20 * bias_6_p17 - s20 * bias_6_p18;

  // link 24 (right_eye), outward
  const Real bias_6_p20 = s20 * a19_z - c20 * minus_a19_y - 0.086 * (w20_y * w20_y + w20_z * w20_z);

  // link 20 (right_hand), pose
  const Real bias_6_p21 = s20 * bias_6_p17 + c20 * bias_6_p18;

  // link 24 (right_eye), outward
  bias[6] = -(bias_6_p15 * bias_6_p5 - bias_6_p19 * bias_6_p16 - bias_6_p21 * bias_6_p20);

  // link 14 (right_shoulder1), pose
  const Real bias_7_p1 = s14 * bias_1_p4 - c14 * bias_1_p3;

  // link 15 (right_shoulder2), pose
  const Real bias_7_p2 = s15 * bias_1_p2 - c15 * bias_7_p1;
  const Real bias_7_p3 = c15 * bias_1_p2 + s15 * bias_7_p1;

  // link 14 (right_shoulder1), pose
  const Real bias_7_p4 = c14 * bias_1_p4 + s14 * bias_1_p3;

  // link 16 (right_upperarm), pose
  const Real bias_7_p5 = c16 * bias_7_p4 + s16 * bias_7_p3;

  // link 17 (right_lowerarm), pose
  const Real bias_7_p6 = c17 * bias_7_p2 - s17 * bias_7_p5;
  const Real bias_7_p7 = s17 * bias_7_p2 + c17 * bias_7_p5;

  // link 16 (right_upperarm), pose
  const Real bias_7_p8 = s16 * bias_7_p4 - c16 * bias_7_p3;

  // link 18 (right_wrist1), pose
  const Real bias_7_p9 = s18 * bias_7_p8 - c18 * bias_7_p7;

  // link 19 (right_wrist2), pose
  const Real bias_7_p10 = s19 * bias_7_p6 - c19 * bias_7_p9;
  const Real bias_7_p11 = c19 * bias_7_p6 + s19 * bias_7_p9;

  // link 18 (right_wrist1), pose
  const Real bias_7_p12 = c18 * bias_7_p8 + s18 * bias_7_p7;

  // link 20 (right_hand), pose
  const Real bias_7_p13 = c20 * bias_7_p12 + s20 * bias_7_p11;
  const Real bias_7_p14 = s20 * bias_7_p12 - c20 * bias_7_p11;

  // link 24 (right_eye), outward
  bias[7] = -(bias_7_p10 * bias_6_p5 + bias_7_p13 * bias_6_p16 + bias_7_p14 * bias_6_p20);

  // link 14 (right_shoulder1), pose
  const Real bias_8_p1 = c14 * bias_2_p2 + s14 * bias_2_p5;
  const Real bias_8_p2 = s14 * bias_2_p2 - c14 * bias_2_p5;

  // link 15 (right_shoulder2), pose
  const Real bias_8_p3 = c15 * bias_2_p8 + s15 * bias_8_p2;

  // link 16 (right_upperarm), pose
  const Real bias_8_p4 = s16 * bias_8_p1 - c16 * bias_8_p3;
  const Real bias_8_p5 = c16 * bias_8_p1 + s16 * bias_8_p3;

  // link 15 (right_shoulder2), pose
  const Real bias_8_p6 = s15 * bias_2_p8 - c15 * bias_8_p2;

  // link 17 (right_lowerarm), pose
  const Real bias_8_p7 = s17 * bias_8_p6 + c17 * bias_8_p5;

  // link 18 (right_wrist1), pose
  const Real bias_8_p8 = s18 * bias_8_p4 - c18 * bias_8_p7;

  // link 17 (right_lowerarm), pose
  const Real bias_8_p9 = c17 * bias_8_p6 - s17 * bias_8_p5;

  // link 19 (right_wrist2), pose
  const Real bias_8_p10 = s19 * bias_8_p9 - c19 * bias_8_p8;

  // link 18 (right_wrist1), pose
  const Real bias_8_p11 = c18 * bias_8_p4 + s18 * bias_8_p7;

  // link 19 (right_wrist2), pose
  const Real bias_8_p12 = c19 * bias_8_p9 + s19 * bias_8_p8;

  // link 20 (right_hand), pose
  const Real bias_8_p13 = c20 * bias_8_p11 + s20 * bias_8_p12;
  const Real bias_8_p14 = s20 * bias_8_p11 - c20 * bias_8_p12;

  // link 24 (right_eye), outward
  bias[8] = -(bias_8_p10 * bias_6_p5 + bias_8_p13 * bias_6_p16 + bias_8_p14 * bias_6_p20);

  // link 20 (right_hand), outward
  const Real minus_wd20_x = s20 * minus_wd18_y + c20 * minus_wd19_y - qd[19] * w20_y;

  // link 24 (right_eye), outward
  bias[9] = -(bias_6_p15 * minus_wd19_x + bias_6_p19 * minus_wd20_y + bias_6_p21 * minus_wd20_x);
  bias[10] = -(bias_7_p10 * minus_wd19_x - bias_7_p13 * minus_wd20_y - bias_7_p14 * minus_wd20_x);
  bias[11] = -(bias_8_p10 * minus_wd19_x - bias_8_p13 * minus_wd20_y - bias_8_p14 * minus_wd20_x);
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
