// bias_acceleration: xdd = J qdd + Jd qd: the term Jd qd
// By outward recursion, Chang eq. 6.11.
// 868 flops (add 328, mul 540, div 0), sine and cosine of 20 angles
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
  const Real angles[20] = {q[12], q[10], q[8], q[7], q[6], q[5], q[4], q[3], q[2], q[1], q[0], q[9],
      q[11], q[19], q[18], q[16], q[14], q[13], q[15], q[17]};
  Real sines[20];
  Real cosines[20];
  detail::sin_cos(angles, sines, cosines);
  const Real c13 = cosines[0];
  const Real c11 = cosines[1];
  const Real c9 = cosines[2];
  const Real s8 = sines[3];
  const Real c7 = cosines[4];
  const Real c6 = cosines[5];
  const Real s5 = sines[6];
  const Real c4 = cosines[7];
  const Real c3 = cosines[8];
  const Real c2 = cosines[9];
  const Real c1 = cosines[10];
  const Real s2 = sines[9];
  const Real s1 = sines[10];
  const Real s3 = sines[8];
  const Real c5 = cosines[6];
  const Real s6 = sines[5];
  const Real s4 = sines[7];
  const Real s7 = sines[4];
  const Real c8 = cosines[3];
  const Real s9 = sines[2];
  const Real s11 = sines[1];
  const Real c10 = cosines[11];
  const Real s10 = sines[11];
  const Real s13 = sines[0];
  const Real c12 = cosines[12];
  const Real s12 = sines[12];
  const Real c20 = cosines[13];
  const Real c19 = cosines[14];
  const Real c17 = cosines[15];
  const Real s15 = sines[16];
  const Real c15 = cosines[16];
  const Real c14 = cosines[17];
  const Real s14 = sines[17];
  const Real s17 = sines[15];
  const Real s16 = sines[18];
  const Real c16 = cosines[18];
  const Real s19 = sines[14];
  const Real c18 = cosines[19];
  const Real s18 = sines[19];
  const Real s20 = sines[13];

  // link 2 (thigh), outward
  const Real w2_z = qd[0] + qd[1];

  // link 3 (hip), outward
  const Real w3_z = w2_z + qd[2];

  // link 4 (chest1), outward
  const Real w4_x = s4 * w3_z;
  const Real w4_y = c4 * w3_z;

  // link 2 (thigh), outward
  const Real a2_y_p1 = 0.434 * (qd[0] * qd[0]);
  const Real a2_y = c2 * a2_y_p1;

  // link 3 (hip), outward
  const Real a3_y_p1 = a2_y + 0.422 * (w2_z * w2_z);

  // link 2 (thigh), outward
  const Real a2_x = s2 * a2_y_p1;

  // link 3 (hip), outward
  const Real a3_y = c3 * a3_y_p1 - s3 * a2_x;

  // link 5 (chest2), outward
  const Real a5_y_p1 = a3_y + 0.21799999999999997 * (w4_x * w4_x + w4_y * w4_y);

  // link 3 (hip), outward
  const Real a3_x = c3 * a2_x + s3 * a3_y_p1;

  // link 4 (chest1), outward
  const Real a4_x = c4 * a3_x;

  // link 5 (chest2), outward
  const Real a5_y = c5 * a5_y_p1 - s5 * a4_x;
  const Real w5_x = c5 * w4_x - s5 * qd[3];
  const Real w5_z = w4_y + qd[4];

  // link 6 (chest3), outward
  const Real a6_x_p1 = a5_y + 0.072 * (w5_x * w5_x + w5_z * w5_z);

  // link 5 (chest2), outward
  const Real minus_w5_y = s5 * w4_x + c5 * qd[3];

  // link 4 (chest1), outward
  const Real wd4_x = w4_y * qd[3];

  // link 5 (chest2), outward
  const Real wd5_x = c5 * wd4_x - minus_w5_y * qd[4];

  // link 4 (chest1), outward
  const Real minus_a4_y = s4 * a3_x;

  // link 6 (chest3), outward
  const Real a6_x_p2 = minus_a4_y + 0.072 * (wd5_x - minus_w5_y * w5_z);
  const Real a6_x = c6 * a6_x_p1 - s6 * a6_x_p2;
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_z = w5_x + qd[5];
  const Real a7_x_p1 = w6_z * w6_z;

  // link 7 (left_shoulder1), outward
  const Real a7_x_p2 = a6_x + 0.226 * (w6_y * w6_y + a7_x_p1);

  // link 6 (chest3), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real a7_x_p3 = w6_x * w6_y;

  // link 7 (left_shoulder1), outward
  const Real a7_x_p4 = 0.18 * (a7_x_p3 - wd5_x);
  const Real a7_x_p5 = a7_x_p2 + a7_x_p4;

  // link 5 (chest2), outward
  const Real a5_x = c5 * a4_x + s5 * a5_y_p1;

  // link 4 (chest1), outward
  const Real minus_wd4_y = w4_x * qd[3];

  // link 6 (chest3), outward
  const Real a6_z = a5_x - 0.072 * (minus_wd4_y - w5_x * minus_w5_y);

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * wd4_x + w5_x * qd[4];

  // link 6 (chest3), outward
  const Real wd6_y = s6 * minus_wd5_y - c6 * minus_wd4_y - w6_x * qd[5];

  // link 7 (left_shoulder1), outward
  const Real a7_x_p6 = a6_z - 0.226 * (w6_x * w6_z - wd6_y);

  // link 6 (chest3), outward
  const Real wd6_x = w6_y * qd[5] - (c6 * minus_wd5_y + s6 * minus_wd4_y);

  // link 7 (left_shoulder1), outward
  const Real a7_x_p7 = 0.18 * (w6_y * w6_z + wd6_x);
  const Real a7_x_p8 = a7_x_p6 + a7_x_p7;
  const Real a7_x = s7 * a7_x_p5 + c7 * a7_x_p8;
  const Real a7_y = c7 * a7_x_p5 - s7 * a7_x_p8;

  // link 6 (chest3), outward
  const Real minus_a6_y = s6 * a6_x_p1 + c6 * a6_x_p2;

  // link 7 (left_shoulder1), outward
  const Real minus_a7_z_p1 = minus_a6_y + 0.226 * (a7_x_p3 + wd5_x);
  const Real minus_a7_z_p2 = 0.18 * (w6_x * w6_x + a7_x_p1);
  const Real minus_a7_z = minus_a7_z_p1 + minus_a7_z_p2;

  // link 8 (left_shoulder2), outward
  const Real minus_a8_y = s8 * a7_y + c8 * minus_a7_z;

  // link 9 (left_upperarm), outward
  const Real a9_x = c9 * a7_x - s9 * minus_a8_y;

  // link 7 (left_shoulder1), outward
  const Real w7_x = s7 * w6_x + c7 * w6_z;
  const Real wd7_y = c7 * wd6_x - s7 * wd5_x - w7_x * qd[6];
  const Real w7_y = c7 * w6_x - s7 * w6_z;
  const Real w7_z = w6_y + qd[6];

  // link 8 (left_shoulder2), outward
  const Real w8_x = c8 * w7_y + s8 * w7_z;
  const Real wd8_y = c8 * wd6_y - s8 * wd7_y - w8_x * qd[7];

  // link 7 (left_shoulder1), outward
  const Real wd7_x = s7 * wd6_x + c7 * wd5_x + w7_y * qd[6];

  // link 8 (left_shoulder2), outward
  const Real w8_y = c8 * w7_z - s8 * w7_y;
  const Real w8_z = w7_x + qd[7];

  // link 9 (left_upperarm), outward
  const Real w9_x = s9 * w8_y + c9 * w8_z;
  const Real wd9_y = c9 * wd8_y - s9 * wd7_x - w9_x * qd[8];
  const Real w9_z = qd[8] - w8_x;

  // link 10 (left_lowerarm), outward
  const Real a10_x_p1 = a9_x - 0.282 * (w9_x * w9_z + wd9_y);

  // link 9 (left_upperarm), outward
  const Real w9_y = c9 * w8_y - s9 * w8_z;

  // link 8 (left_shoulder2), outward
  const Real a8_x = c8 * a7_y - s8 * minus_a7_z;

  // link 10 (left_lowerarm), outward
  const Real a10_x_p2 = 0.282 * (w9_x * w9_x + w9_y * w9_y) - a8_x;
  const Real a10_x = c10 * a10_x_p1 - s10 * a10_x_p2;

  // link 9 (left_upperarm), outward
  const Real minus_a9_y = c9 * minus_a8_y + s9 * a7_x;
  const Real wd9_x = s9 * wd8_y + c9 * wd7_x + w9_y * qd[8];

  // link 10 (left_lowerarm), outward
  const Real minus_a10_z = minus_a9_y + 0.282 * (w9_y * w9_z - wd9_x);

  // link 11 (left_wrist1), outward
  const Real a11_x = c11 * a10_x - s11 * minus_a10_z;

  // link 8 (left_shoulder2), outward
  const Real wd8_x = c8 * wd7_y + s8 * wd6_y + w8_y * qd[7];

  // link 10 (left_lowerarm), outward
  const Real minus_w10_y = s10 * w9_x + c10 * w9_z;
  const Real wd10_x = c10 * wd9_x + s10 * wd8_x - minus_w10_y * qd[9];
  const Real w10_x = c10 * w9_x - s10 * w9_z;
  const Real w10_z = w9_y + qd[9];

  // link 11 (left_wrist1), outward
  const Real w11_x = c11 * w10_x + s11 * w10_z;
  const Real wd11_y = c11 * wd9_y - s11 * wd10_x - w11_x * qd[10];
  const Real w11_z = minus_w10_y + qd[10];

  // link 12 (left_wrist2), outward
  const Real minus_a12_y_p1 = a11_x - 0.269 * (w11_x * w11_z + wd11_y);

  // link 10 (left_lowerarm), outward
  const Real minus_a10_y = s10 * a10_x_p1 + c10 * a10_x_p2;

  // link 11 (left_wrist1), outward
  const Real w11_y = c11 * w10_z - s11 * w10_x;

  // link 12 (left_wrist2), outward
  const Real minus_a12_y_p2 = minus_a10_y + 0.269 * (w11_x * w11_x + w11_y * w11_y);
  const Real minus_a12_y = s12 * minus_a12_y_p1 + c12 * minus_a12_y_p2;

  // link 11 (left_wrist1), outward
  const Real minus_a11_y = s11 * a10_x + c11 * minus_a10_z;
  const Real wd11_x = c11 * wd10_x + s11 * wd9_y + w11_y * qd[10];

  // link 12 (left_wrist2), outward
  const Real minus_a12_z = minus_a11_y + 0.269 * (w11_y * w11_z - wd11_x);

  // link 13 (left_hand), outward
  const Real a13_y = s13 * minus_a12_y - c13 * minus_a12_z;

  // link 12 (left_wrist2), outward
  const Real w12_z = w11_y + qd[11];
  const Real minus_w12_y = s12 * w11_x + c12 * w11_z;

  // link 13 (left_hand), outward
  const Real w13_x = s13 * w12_z - c13 * minus_w12_y;
  const Real w13_y = s13 * minus_w12_y + c13 * w12_z;

  // link 10 (left_lowerarm), outward
  const Real wd10_y = c10 * wd8_x - s10 * wd9_x - w10_x * qd[9];

  // link 12 (left_wrist2), outward
  const Real wd12_x = c12 * wd11_x + s12 * wd10_y - minus_w12_y * qd[11];

  // link 24 (right_eye), outward
  const Real bias_0_p1 = a13_y + 0.086 * (w13_x * w13_y + wd12_x);

  // link 2 (thigh), pose
  const Real bias_0_p2 = c2 * c1 - s2 * s1;
  const Real bias_0_p3 = s2 * c1 + c2 * s1;

  // link 3 (hip), pose
  const Real bias_0_p4 = c3 * bias_0_p2 - s3 * bias_0_p3;

  // link 4 (chest1), pose
  const Real bias_0_p5 = c4 * bias_0_p4;

  // link 3 (hip), pose
  const Real bias_0_p6 = s3 * bias_0_p2 + c3 * bias_0_p3;

  // link 5 (chest2), pose
  const Real bias_0_p7 = s5 * bias_0_p5 + c5 * bias_0_p6;

  // link 4 (chest1), pose
  const Real bias_0_p8 = s4 * bias_0_p4;

  // link 6 (chest3), pose
  const Real bias_0_p9 = c6 * bias_0_p7 + s6 * bias_0_p8;

  // link 5 (chest2), pose
  const Real bias_0_p10 = c5 * bias_0_p5 - s5 * bias_0_p6;

  // link 7 (left_shoulder1), pose
  const Real bias_0_p11 = c7 * bias_0_p9 + s7 * bias_0_p10;

  // link 6 (chest3), pose
  const Real bias_0_p12 = s6 * bias_0_p7 - c6 * bias_0_p8;

  // link 8 (left_shoulder2), pose
  const Real bias_0_p13 = s8 * bias_0_p11 + c8 * bias_0_p12;

  // link 7 (left_shoulder1), pose
  const Real bias_0_p14 = c7 * bias_0_p10 - s7 * bias_0_p9;

  // link 9 (left_upperarm), pose
  const Real bias_0_p15 = c9 * bias_0_p13 - s9 * bias_0_p14;
  const Real bias_0_p16 = s9 * bias_0_p13 + c9 * bias_0_p14;

  // link 8 (left_shoulder2), pose
  const Real bias_0_p17 = s8 * bias_0_p12 - c8 * bias_0_p11;

  // link 10 (left_lowerarm), pose
  const Real bias_0_p18 = c10 * bias_0_p16 + s10 * bias_0_p17;

  // link 11 (left_wrist1), pose
  const Real bias_0_p19 = c11 * bias_0_p15 - s11 * bias_0_p18;
  const Real bias_0_p20 = c11 * bias_0_p18 + s11 * bias_0_p15;

  // link 10 (left_lowerarm), pose
  const Real bias_0_p21 = c10 * bias_0_p17 - s10 * bias_0_p16;

  // link 12 (left_wrist2), pose
  const Real bias_0_p22 = c12 * bias_0_p21 - s12 * bias_0_p20;

  // link 13 (left_hand), pose
  const Real bias_0_p23 = c13 * bias_0_p19 - s13 * bias_0_p22;

  // link 13 (left_hand), outward
  const Real minus_a13_x = c13 * minus_a12_y + s13 * minus_a12_z;

  // link 12 (left_wrist2), outward
  const Real w12_x = c12 * w11_x - s12 * w11_z;

  // link 13 (left_hand), outward
  const Real w13_z = w12_x + qd[12];

  // link 24 (right_eye), outward
  const Real bias_0_p24 = minus_a13_x + 0.086 * (w13_y * w13_y + w13_z * w13_z);

  // link 13 (left_hand), pose
  const Real bias_0_p25 = c13 * bias_0_p22 + s13 * bias_0_p19;

  // link 12 (left_wrist2), outward
  const Real a12_x = c12 * minus_a12_y_p1 - s12 * minus_a12_y_p2;
  const Real wd12_y = c12 * wd10_y - s12 * wd11_x - w12_x * qd[11];

  // link 13 (left_hand), outward
  const Real wd13_y = c13 * wd11_y - s13 * wd12_y - w13_x * qd[12];

  // link 24 (right_eye), outward
  const Real bias_0_p26 = a12_x + 0.086 * (w13_x * w13_z - wd13_y);

  // link 12 (left_wrist2), pose
  const Real bias_0_p27 = c12 * bias_0_p20 + s12 * bias_0_p21;

  // link 24 (right_eye), outward
  bias[0] = bias_0_p23 * bias_0_p1 - bias_0_p25 * bias_0_p24 + bias_0_p27 * bias_0_p26;

  // link 5 (chest2), pose
  const Real bias_1_p1 = s5 * s4;

  // link 6 (chest3), pose
  const Real bias_1_p2 = s6 * c4 - c6 * bias_1_p1;

  // link 5 (chest2), pose
  const Real bias_1_p3 = c5 * s4;

  // link 7 (left_shoulder1), pose
  const Real bias_1_p4 = c7 * bias_1_p2 - s7 * bias_1_p3;

  // link 6 (chest3), pose
  const Real bias_1_p5 = s6 * bias_1_p1 + c6 * c4;

  // link 8 (left_shoulder2), pose
  const Real bias_1_p6 = c8 * bias_1_p4 + s8 * bias_1_p5;
  const Real bias_1_p7 = c8 * bias_1_p5 - s8 * bias_1_p4;

  // link 7 (left_shoulder1), pose
  const Real bias_1_p8 = s7 * bias_1_p2 + c7 * bias_1_p3;

  // link 9 (left_upperarm), pose
  const Real bias_1_p9 = s9 * bias_1_p7 + c9 * bias_1_p8;

  // link 10 (left_lowerarm), pose
  const Real bias_1_p10 = c10 * bias_1_p6 - s10 * bias_1_p9;
  const Real bias_1_p11 = c10 * bias_1_p9 + s10 * bias_1_p6;

  // link 9 (left_upperarm), pose
  const Real bias_1_p12 = c9 * bias_1_p7 - s9 * bias_1_p8;

  // link 11 (left_wrist1), pose
  const Real bias_1_p13 = c11 * bias_1_p11 + s11 * bias_1_p12;

  // link 12 (left_wrist2), pose
  const Real bias_1_p14 = c12 * bias_1_p10 - s12 * bias_1_p13;

  // link 11 (left_wrist1), pose
  const Real bias_1_p15 = c11 * bias_1_p12 - s11 * bias_1_p11;

  // link 13 (left_hand), pose
  const Real bias_1_p16 = c13 * bias_1_p15 - s13 * bias_1_p14;
  const Real bias_1_p17 = c13 * bias_1_p14 + s13 * bias_1_p15;

  // link 12 (left_wrist2), pose
  const Real bias_1_p18 = c12 * bias_1_p13 + s12 * bias_1_p10;

  // link 24 (right_eye), outward
  bias[1] = bias_1_p16 * bias_0_p1 - bias_1_p17 * bias_0_p24 + bias_1_p18 * bias_0_p26;

  // link 4 (chest1), pose
  const Real bias_2_p1 = c4 * bias_0_p6;

  // link 5 (chest2), pose
  const Real bias_2_p2 = s5 * bias_2_p1 - c5 * bias_0_p4;

  // link 4 (chest1), pose
  const Real bias_2_p3 = s4 * bias_0_p6;

  // link 6 (chest3), pose
  const Real bias_2_p4 = c6 * bias_2_p2 + s6 * bias_2_p3;

  // link 5 (chest2), pose
  const Real bias_2_p5 = c5 * bias_2_p1 + s5 * bias_0_p4;

  // link 7 (left_shoulder1), pose
  const Real bias_2_p6 = s7 * bias_2_p4 - c7 * bias_2_p5;
  const Real bias_2_p7 = c7 * bias_2_p4 + s7 * bias_2_p5;

  // link 6 (chest3), pose
  const Real bias_2_p8 = s6 * bias_2_p2 - c6 * bias_2_p3;

  // link 8 (left_shoulder2), pose
  const Real bias_2_p9 = s8 * bias_2_p7 + c8 * bias_2_p8;

  // link 9 (left_upperarm), pose
  const Real bias_2_p10 = c9 * bias_2_p6 - s9 * bias_2_p9;

  // link 8 (left_shoulder2), pose
  const Real bias_2_p11 = c8 * bias_2_p7 - s8 * bias_2_p8;

  // link 10 (left_lowerarm), pose
  const Real bias_2_p12 = c10 * bias_2_p10 + s10 * bias_2_p11;

  // link 9 (left_upperarm), pose
  const Real bias_2_p13 = c9 * bias_2_p9 + s9 * bias_2_p6;

  // link 11 (left_wrist1), pose
  const Real bias_2_p14 = c11 * bias_2_p12 - s11 * bias_2_p13;

  // link 10 (left_lowerarm), pose
  const Real bias_2_p15 = c10 * bias_2_p11 - s10 * bias_2_p10;

  // link 12 (left_wrist2), pose
  const Real bias_2_p16 = c12 * bias_2_p15 - s12 * bias_2_p14;

  // link 11 (left_wrist1), pose
  const Real bias_2_p17 = s11 * bias_2_p12 + c11 * bias_2_p13;

  // link 13 (left_hand), pose
  const Real bias_2_p18 = c13 * bias_2_p16 - s13 * bias_2_p17;
  const Real bias_2_p19 = s13 * bias_2_p16 + c13 * bias_2_p17;

  // link 12 (left_wrist2), pose
  const Real bias_2_p20 = c12 * bias_2_p14 + s12 * bias_2_p15;

  // link 24 (right_eye), outward
  bias[2] = bias_2_p20 * bias_0_p26 - (bias_2_p18 * bias_0_p24 + bias_2_p19 * bias_0_p1);

  // link 13 (left_hand), outward
  const Real wd13_x = c13 * wd12_y + s13 * wd11_y + w13_y * qd[12];

  // link 24 (right_eye), outward
  bias[3] = bias_0_p25 * wd13_x + bias_0_p23 * wd13_y + bias_0_p27 * wd12_x;
  bias[4] = bias_1_p17 * wd13_x + bias_1_p16 * wd13_y + bias_1_p18 * wd12_x;
  bias[5] = bias_2_p18 * wd13_x - bias_2_p19 * wd13_y + bias_2_p20 * wd12_x;

  // link 14 (right_shoulder1), outward
  const Real a14_y_p1 = a7_x_p2 - a7_x_p4;
  const Real a14_y_p2 = a7_x_p6 - a7_x_p7;
  const Real a14_y = c14 * a14_y_p1 - s14 * a14_y_p2;
  const Real a14_z = minus_a7_z_p2 - minus_a7_z_p1;

  // link 15 (right_shoulder2), outward
  const Real a15_y = c15 * a14_z - s15 * a14_y;

  // link 14 (right_shoulder1), outward
  const Real a14_x = s14 * a14_y_p1 + c14 * a14_y_p2;

  // link 16 (right_upperarm), outward
  const Real a16_x = s16 * a15_y + c16 * a14_x;

  // link 14 (right_shoulder1), outward
  const Real w14_x = s14 * w6_x + c14 * w6_z;
  const Real wd14_y = c14 * wd6_x - s14 * wd5_x - w14_x * qd[13];
  const Real w14_y = c14 * w6_x - s14 * w6_z;
  const Real w14_z = w6_y + qd[13];

  // link 15 (right_shoulder2), outward
  const Real w15_x = c15 * w14_y + s15 * w14_z;
  const Real wd15_y = c15 * wd6_y - s15 * wd14_y - w15_x * qd[14];

  // link 14 (right_shoulder1), outward
  const Real wd14_x = s14 * wd6_x + c14 * wd5_x + w14_y * qd[13];

  // link 15 (right_shoulder2), outward
  const Real w15_y = c15 * w14_z - s15 * w14_y;
  const Real w15_z = w14_x + qd[14];

  // link 16 (right_upperarm), outward
  const Real w16_x = s16 * w15_y + c16 * w15_z;
  const Real wd16_y = c16 * wd15_y - s16 * wd14_x - w16_x * qd[15];
  const Real w16_z = qd[15] - w15_x;

  // link 17 (right_lowerarm), outward
  const Real a17_x_p1 = a16_x - 0.282 * (w16_x * w16_z + wd16_y);

  // link 16 (right_upperarm), outward
  const Real w16_y = c16 * w15_y - s16 * w15_z;

  // link 15 (right_shoulder2), outward
  const Real a15_x = c15 * a14_y + s15 * a14_z;

  // link 17 (right_lowerarm), outward
  const Real a17_x_p2 = 0.282 * (w16_x * w16_x + w16_y * w16_y) - a15_x;
  const Real a17_x = c17 * a17_x_p1 - s17 * a17_x_p2;

  // link 16 (right_upperarm), outward
  const Real a16_y = c16 * a15_y - s16 * a14_x;
  const Real wd16_x = s16 * wd15_y + c16 * wd14_x + w16_y * qd[15];

  // link 17 (right_lowerarm), outward
  const Real a17_z = a16_y - 0.282 * (w16_y * w16_z - wd16_x);

  // link 18 (right_wrist1), outward
  const Real a18_x = c18 * a17_x + s18 * a17_z;

  // link 15 (right_shoulder2), outward
  const Real wd15_x = c15 * wd14_y + s15 * wd6_y + w15_y * qd[14];

  // link 17 (right_lowerarm), outward
  const Real minus_w17_y = s17 * w16_x + c17 * w16_z;
  const Real wd17_x = c17 * wd16_x + s17 * wd15_x - minus_w17_y * qd[16];
  const Real w17_x = c17 * w16_x - s17 * w16_z;
  const Real w17_z = w16_y + qd[16];

  // link 18 (right_wrist1), outward
  const Real w18_x = c18 * w17_x + s18 * w17_z;
  const Real wd18_y = c18 * wd16_y - s18 * wd17_x - w18_x * qd[17];
  const Real w18_z = minus_w17_y + qd[17];

  // link 19 (right_wrist2), outward
  const Real minus_a19_y_p1 = a18_x - 0.269 * (w18_x * w18_z + wd18_y);

  // link 17 (right_lowerarm), outward
  const Real minus_a17_y = s17 * a17_x_p1 + c17 * a17_x_p2;

  // link 18 (right_wrist1), outward
  const Real w18_y = c18 * w17_z - s18 * w17_x;

  // link 19 (right_wrist2), outward
  const Real minus_a19_y_p2 = minus_a17_y + 0.269 * (w18_x * w18_x + w18_y * w18_y);
  const Real minus_a19_y = s19 * minus_a19_y_p1 + c19 * minus_a19_y_p2;

  // link 18 (right_wrist1), outward
  const Real a18_y = c18 * a17_z - s18 * a17_x;
  const Real wd18_x = c18 * wd17_x + s18 * wd16_y + w18_y * qd[17];

  // link 19 (right_wrist2), outward
  const Real a19_z = a18_y - 0.269 * (w18_y * w18_z - wd18_x);

  // link 20 (right_hand), outward
  const Real a20_x = s20 * a19_z - c20 * minus_a19_y;

  // link 19 (right_wrist2), outward
  const Real minus_w19_y = s19 * w18_x + c19 * w18_z;
  const Real w19_z = w18_y + qd[18];

  // link 20 (right_hand), outward
  const Real w20_y = s20 * minus_w19_y + c20 * w19_z;

  // link 19 (right_wrist2), outward
  const Real w19_x = c19 * w18_x - s19 * w18_z;

  // link 20 (right_hand), outward
  const Real w20_z = w19_x + qd[19];

  // link 24 (right_eye), outward
  const Real bias_6_p1 = a20_x - 0.086 * (w20_y * w20_y + w20_z * w20_z);

  // link 14 (right_shoulder1), pose
  const Real bias_6_p2 = c14 * bias_0_p9 + s14 * bias_0_p10;

  // link 15 (right_shoulder2), pose
  const Real bias_6_p3 = s15 * bias_6_p2 + c15 * bias_0_p12;

  // link 14 (right_shoulder1), pose
  const Real bias_6_p4 = c14 * bias_0_p10 - s14 * bias_0_p9;

  // link 16 (right_upperarm), pose
  const Real bias_6_p5 = s16 * bias_6_p3 + c16 * bias_6_p4;

  // link 15 (right_shoulder2), pose
  const Real bias_6_p6 = s15 * bias_0_p12 - c15 * bias_6_p2;

  // link 17 (right_lowerarm), pose
  const Real bias_6_p7 = c17 * bias_6_p5 + s17 * bias_6_p6;

  // link 16 (right_upperarm), pose
  const Real bias_6_p8 = c16 * bias_6_p3 - s16 * bias_6_p4;

  // link 18 (right_wrist1), pose
  const Real bias_6_p9 = c18 * bias_6_p7 + s18 * bias_6_p8;

  // link 17 (right_lowerarm), pose
  const Real bias_6_p10 = c17 * bias_6_p6 - s17 * bias_6_p5;

  // link 19 (right_wrist2), pose
  const Real bias_6_p11 = c19 * bias_6_p10 - s19 * bias_6_p9;

  // link 18 (right_wrist1), pose
  const Real bias_6_p12 = c18 * bias_6_p8 - s18 * bias_6_p7;

  // link 20 (right_hand), pose
  const Real bias_6_p13 = c20 * bias_6_p11 + s20 * bias_6_p12;

  // link 20 (right_hand), outward
  const Real a20_y = s20 * minus_a19_y + c20 * a19_z;
  const Real w20_x = s20 * w19_z - c20 * minus_w19_y;

  // link 17 (right_lowerarm), outward
  const Real wd17_y = c17 * wd15_x - s17 * wd16_x - w17_x * qd[16];

  // link 19 (right_wrist2), outward
  const Real wd19_x = c19 * wd18_x + s19 * wd17_y - minus_w19_y * qd[18];

  // link 24 (right_eye), outward
  const Real bias_6_p14 = a20_y + 0.086 * (w20_x * w20_y + wd19_x);

  // link 20 (right_hand), pose
  const Real bias_6_p15 = c20 * bias_6_p12 - s20 * bias_6_p11;

  // link 19 (right_wrist2), outward
  const Real a19_x = c19 * minus_a19_y_p1 - s19 * minus_a19_y_p2;
  const Real wd19_y = c19 * wd17_y - s19 * wd18_x - w19_x * qd[18];

  // link 20 (right_hand), outward
  const Real wd20_y = c20 * wd18_y - s20 * wd19_y - w20_x * qd[19];

  // link 24 (right_eye), outward
  const Real bias_6_p16 = a19_x + 0.086 * (w20_x * w20_z - wd20_y);

  // link 19 (right_wrist2), pose
  const Real bias_6_p17 = c19 * bias_6_p9 + s19 * bias_6_p10;

  // link 24 (right_eye), outward
  bias[6] = bias_6_p13 * bias_6_p1 + bias_6_p15 * bias_6_p14 + bias_6_p17 * bias_6_p16;

  // link 14 (right_shoulder1), pose
  const Real bias_7_p1 = c14 * bias_1_p2 - s14 * bias_1_p3;

  // link 15 (right_shoulder2), pose
  const Real bias_7_p2 = c15 * bias_7_p1 + s15 * bias_1_p5;
  const Real bias_7_p3 = c15 * bias_1_p5 - s15 * bias_7_p1;

  // link 14 (right_shoulder1), pose
  const Real bias_7_p4 = s14 * bias_1_p2 + c14 * bias_1_p3;

  // link 16 (right_upperarm), pose
  const Real bias_7_p5 = s16 * bias_7_p3 + c16 * bias_7_p4;

  // link 17 (right_lowerarm), pose
  const Real bias_7_p6 = c17 * bias_7_p2 - s17 * bias_7_p5;
  const Real bias_7_p7 = c17 * bias_7_p5 + s17 * bias_7_p2;

  // link 16 (right_upperarm), pose
  const Real bias_7_p8 = c16 * bias_7_p3 - s16 * bias_7_p4;

  // link 18 (right_wrist1), pose
  const Real bias_7_p9 = c18 * bias_7_p7 + s18 * bias_7_p8;

  // link 19 (right_wrist2), pose
  const Real bias_7_p10 = c19 * bias_7_p6 - s19 * bias_7_p9;

  // link 18 (right_wrist1), pose
  const Real bias_7_p11 = c18 * bias_7_p8 - s18 * bias_7_p7;

  // link 20 (right_hand), pose
  const Real bias_7_p12 = c20 * bias_7_p10 + s20 * bias_7_p11;
  const Real bias_7_p13 = c20 * bias_7_p11 - s20 * bias_7_p10;

  // link 19 (right_wrist2), pose
  const Real bias_7_p14 = c19 * bias_7_p9 + s19 * bias_7_p6;

  // link 24 (right_eye), outward
  bias[7] = bias_7_p12 * bias_6_p1 + bias_7_p13 * bias_6_p14 + bias_7_p14 * bias_6_p16;

  // link 14 (right_shoulder1), pose
  const Real bias_8_p1 = s14 * bias_2_p4 - c14 * bias_2_p5;
  const Real bias_8_p2 = c14 * bias_2_p4 + s14 * bias_2_p5;

  // link 15 (right_shoulder2), pose
  const Real bias_8_p3 = s15 * bias_8_p2 + c15 * bias_2_p8;

  // link 16 (right_upperarm), pose
  const Real bias_8_p4 = c16 * bias_8_p1 - s16 * bias_8_p3;

  // link 15 (right_shoulder2), pose
  const Real bias_8_p5 = c15 * bias_8_p2 - s15 * bias_2_p8;

  // link 17 (right_lowerarm), pose
  const Real bias_8_p6 = c17 * bias_8_p4 + s17 * bias_8_p5;

  // link 16 (right_upperarm), pose
  const Real bias_8_p7 = c16 * bias_8_p3 + s16 * bias_8_p1;

  // link 18 (right_wrist1), pose
  const Real bias_8_p8 = c18 * bias_8_p6 - s18 * bias_8_p7;

  // link 17 (right_lowerarm), pose
  const Real bias_8_p9 = c17 * bias_8_p5 - s17 * bias_8_p4;

  // link 19 (right_wrist2), pose
  const Real bias_8_p10 = c19 * bias_8_p9 - s19 * bias_8_p8;

  // link 18 (right_wrist1), pose
  const Real bias_8_p11 = s18 * bias_8_p6 + c18 * bias_8_p7;

  // link 20 (right_hand), pose
  const Real bias_8_p12 = c20 * bias_8_p10 - s20 * bias_8_p11;
  const Real bias_8_p13 = s20 * bias_8_p10 + c20 * bias_8_p11;

  // link 19 (right_wrist2), pose
  const Real bias_8_p14 = c19 * bias_8_p8 + s19 * bias_8_p9;

  // link 24 (right_eye), outward
  bias[8] = bias_8_p12 * bias_6_p1 - bias_8_p13 * bias_6_p14 + bias_8_p14 * bias_6_p16;

  // link 20 (right_hand), outward
  const Real wd20_x = c20 * wd19_y + s20 * wd18_y + w20_y * qd[19];

  // link 24 (right_eye), outward
  bias[9] = bias_6_p13 * wd20_x + bias_6_p15 * wd20_y + bias_6_p17 * wd19_x;
  bias[10] = bias_7_p12 * wd20_x + bias_7_p13 * wd20_y + bias_7_p14 * wd19_x;
  bias[11] = bias_8_p12 * wd20_x - bias_8_p13 * wd20_y + bias_8_p14 * wd19_x;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
