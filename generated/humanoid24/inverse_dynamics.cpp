// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1.
// 2028 flops (add 982, mul 1046, div 0), sine and cosine of 24 angles
// Generated; see humanoid24.hpp for the contract.
#include "humanoid24.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace humanoid24 {

void inverse_dynamics(const Real (&TREELINE_RESTRICT q)[24], const Real (&TREELINE_RESTRICT qd)[24],
    const Real (&TREELINE_RESTRICT qdd)[24], Real (&TREELINE_RESTRICT tau)[24]) noexcept {
  const Real angles[24] = {q[0], q[1], q[2], q[3], q[4], q[5], q[20], q[21], q[23], q[22], q[13],
      q[14], q[15], q[16], q[17], q[18], q[19], q[6], q[7], q[8], q[9], q[10], q[11], q[12]};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real c1 = cosines[0];
  const Real s1 = sines[0];
  const Real c2 = cosines[1];
  const Real s2 = sines[1];
  const Real c3 = cosines[2];
  const Real s3 = sines[2];
  const Real s4 = sines[3];
  const Real c4 = cosines[3];
  const Real s5 = sines[4];
  const Real c5 = cosines[4];
  const Real c6 = cosines[5];
  const Real s6 = sines[5];
  const Real s21 = sines[6];
  const Real c21 = cosines[6];
  const Real s22 = sines[7];
  const Real c22 = cosines[7];
  const Real c24 = cosines[8];
  const Real s24 = sines[8];
  const Real c23 = cosines[9];
  const Real s23 = sines[9];
  const Real s14 = sines[10];
  const Real c14 = cosines[10];
  const Real c15 = cosines[11];
  const Real s15 = sines[11];
  const Real c16 = cosines[12];
  const Real s16 = sines[12];
  const Real c17 = cosines[13];
  const Real s17 = sines[13];
  const Real c18 = cosines[14];
  const Real s18 = sines[14];
  const Real c19 = cosines[15];
  const Real s19 = sines[15];
  const Real s20 = sines[16];
  const Real c20 = cosines[16];
  const Real s7 = sines[17];
  const Real c7 = cosines[17];
  const Real c8 = cosines[18];
  const Real s8 = sines[18];
  const Real c9 = cosines[19];
  const Real s9 = sines[19];
  const Real c10 = cosines[20];
  const Real s10 = sines[20];
  const Real s11 = sines[21];
  const Real c11 = cosines[21];
  const Real s12 = sines[22];
  const Real c12 = cosines[22];
  const Real c13 = cosines[23];
  const Real s13 = sines[23];

  // link 1 (calf), outward
  const Real minus_a1_y = 9.81 * c1;

  // link 2 (thigh), outward
  const Real a2_y_p1 = 0.434 * (qd[0] * qd[0]) - minus_a1_y;

  // link 1 (calf), outward
  const Real minus_a1_x = 9.81 * s1;

  // link 2 (thigh), outward
  const Real a2_y_p2 = 0.434 * qdd[0] - minus_a1_x;
  const Real a2_y = c2 * a2_y_p1 - s2 * a2_y_p2;
  const Real w2_z = qd[0] + qd[1];
  const Real a3_y_p1 = w2_z * w2_z;

  // link 3 (hip), outward
  const Real a3_y_p2 = a2_y + 0.422 * a3_y_p1;

  // link 2 (thigh), outward
  const Real a2_x = c2 * a2_y_p2 + s2 * a2_y_p1;
  const Real wd2_z = qdd[0] + qdd[1];

  // link 3 (hip), outward
  const Real a3_y_p3 = a2_x + 0.422 * wd2_z;
  const Real a3_y = c3 * a3_y_p2 - s3 * a3_y_p3;
  const Real w3_z = w2_z + qd[2];

  // link 4 (chest1), outward
  const Real w4_x = s4 * w3_z;
  const Real a5_y_p1 = w4_x * w4_x;
  const Real w4_y = c4 * w3_z;
  const Real a5_y_p2 = w4_y * w4_y;

  // link 5 (chest2), outward
  const Real a5_y_p3 = a3_y + 0.21799999999999997 * (a5_y_p1 + a5_y_p2);

  // link 3 (hip), outward
  const Real a3_x = c3 * a3_y_p3 + s3 * a3_y_p2;

  // link 4 (chest1), outward
  const Real a4_x = c4 * a3_x;

  // link 3 (hip), outward
  const Real wd3_z = wd2_z + qdd[2];

  // link 4 (chest1), outward
  const Real a5_y_p4 = c4 * wd3_z;

  // link 5 (chest2), outward
  const Real a5_y_p5 = a4_x + 0.21799999999999997 * a5_y_p4;
  const Real a5_y = c5 * a5_y_p3 - s5 * a5_y_p5;
  const Real w5_x = c5 * w4_x - s5 * qd[3];
  const Real a6_x_p1 = w5_x * w5_x;
  const Real w5_z = w4_y + qd[4];
  const Real a6_x_p2 = w5_z * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p3 = a6_x_p1 + a6_x_p2;
  const Real a6_x_p4 = a5_y + 0.072 * a6_x_p3;

  // link 4 (chest1), outward
  const Real minus_a4_y = s4 * a3_x;
  const Real minus_a5_z_p1 = s4 * wd3_z;

  // link 5 (chest2), outward
  const Real minus_a5_z = minus_a4_y + 0.21799999999999997 * minus_a5_z_p1;

  // link 4 (chest1), outward
  const Real wd4_x_p1 = w4_y * qd[3];
  const Real wd4_x = minus_a5_z_p1 + wd4_x_p1;

  // link 5 (chest2), outward
  const Real minus_w5_y = s5 * w4_x + c5 * qd[3];
  const Real wd5_x = c5 * wd4_x - s5 * qdd[3] - minus_w5_y * qd[4];
  const Real a6_x_p5 = wd5_x - minus_w5_y * w5_z;

  // link 6 (chest3), outward
  const Real a6_x_p6 = minus_a5_z + 0.072 * a6_x_p5;
  const Real a6_x = c6 * a6_x_p4 - s6 * a6_x_p6;
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_z = w5_x + qd[5];
  const Real a14_y_p1 = w6_z * w6_z;

  // link 7 (left_shoulder1), outward
  const Real a14_y_p2 = w6_y * w6_y + a14_y_p1;

  // link 14 (right_shoulder1), outward
  const Real a14_y_p3 = a6_x + 0.226 * a14_y_p2;

  // link 6 (chest3), outward
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real a14_y_p4 = w6_x * w6_y;
  const Real wd6_z = wd5_x + qdd[5];

  // link 7 (left_shoulder1), outward
  const Real a14_y_p5 = 0.18 * (a14_y_p4 - wd6_z);

  // link 14 (right_shoulder1), outward
  const Real a14_y_p6 = a14_y_p3 - a14_y_p5;

  // link 5 (chest2), outward
  const Real a5_x = c5 * a5_y_p5 + s5 * a5_y_p3;
  const Real a6_z_p1 = w5_x * minus_w5_y;

  // link 4 (chest1), outward
  const Real wd4_y_p1 = w4_x * qd[3];
  const Real wd4_y = a5_y_p4 - wd4_y_p1;

  // link 5 (chest2), outward
  const Real wd5_z = wd4_y + qdd[4];
  const Real a6_z_p2 = a6_z_p1 + wd5_z;

  // link 6 (chest3), outward
  const Real a6_z = a5_x + 0.072 * a6_z_p2;

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * wd4_x + c5 * qdd[3] + w5_x * qd[4];

  // link 6 (chest3), outward
  const Real wd6_y = s6 * minus_wd5_y + c6 * wd5_z - w6_x * qd[5];
  const Real a14_y_p7 = w6_x * w6_z - wd6_y;

  // link 14 (right_shoulder1), outward
  const Real a14_y_p8 = a6_z - 0.226 * a14_y_p7;

  // link 6 (chest3), outward
  const Real a14_y_p9 = w6_y * w6_z;
  const Real wd6_x = s6 * wd5_z - c6 * minus_wd5_y + w6_y * qd[5];
  const Real a14_y_p10 = a14_y_p9 + wd6_x;

  // link 7 (left_shoulder1), outward
  const Real a14_y_p11 = 0.18 * a14_y_p10;

  // link 14 (right_shoulder1), outward
  const Real a14_y_p12 = a14_y_p8 - a14_y_p11;
  const Real a14_y = c14 * a14_y_p6 - s14 * a14_y_p12;

  // link 6 (chest3), outward
  const Real minus_a6_y = s6 * a6_x_p4 + c6 * a6_x_p6;
  const Real a14_z_p1 = a14_y_p4 + wd6_z;

  // link 14 (right_shoulder1), outward
  const Real a14_z_p2 = minus_a6_y + 0.226 * a14_z_p1;

  // link 6 (chest3), outward
  const Real a14_z_p3 = w6_x * w6_x;

  // link 7 (left_shoulder1), outward
  const Real a14_z_p4 = 0.18 * (a14_z_p3 + a14_y_p1);

  // link 14 (right_shoulder1), outward
  const Real a14_z = a14_z_p4 - a14_z_p2;

  // link 15 (right_shoulder2), outward
  const Real a15_y = c15 * a14_z - s15 * a14_y;

  // link 14 (right_shoulder1), outward
  const Real a14_x = s14 * a14_y_p6 + c14 * a14_y_p12;

  // link 16 (right_upperarm), outward
  const Real a16_x = s16 * a15_y + c16 * a14_x;

  // link 14 (right_shoulder1), outward
  const Real w14_x = s14 * w6_x + c14 * w6_z;
  const Real wd14_y = c14 * wd6_x - s14 * wd6_z - w14_x * qd[13];
  const Real wd14_z = wd6_y + qdd[13];
  const Real w14_y = c14 * w6_x - s14 * w6_z;
  const Real w14_z = w6_y + qd[13];

  // link 15 (right_shoulder2), outward
  const Real w15_x = c15 * w14_y + s15 * w14_z;
  const Real wd15_y = c15 * wd14_z - s15 * wd14_y - w15_x * qd[14];

  // link 14 (right_shoulder1), outward
  const Real wd14_x = s14 * wd6_x + c14 * wd6_z + w14_y * qd[13];

  // link 15 (right_shoulder2), outward
  const Real wd15_z = wd14_x + qdd[14];
  const Real w15_y = c15 * w14_z - s15 * w14_y;
  const Real w15_z = w14_x + qd[14];

  // link 16 (right_upperarm), outward
  const Real w16_x = s16 * w15_y + c16 * w15_z;
  const Real wd16_y = c16 * wd15_y - s16 * wd15_z - w16_x * qd[15];
  const Real w16_z = qd[15] - w15_x;
  const Real a17_x_p1 = w16_x * w16_z;
  const Real a17_x_p2 = a17_x_p1 + wd16_y;

  // link 17 (right_lowerarm), outward
  const Real a17_x_p3 = a16_x - 0.282 * a17_x_p2;

  // link 16 (right_upperarm), outward
  const Real a17_x_p4 = w16_x * w16_x;
  const Real w16_y = c16 * w15_y - s16 * w15_z;
  const Real a17_x_p5 = w16_y * w16_y;

  // link 15 (right_shoulder2), outward
  const Real a15_x = c15 * a14_y + s15 * a14_z;

  // link 17 (right_lowerarm), outward
  const Real a17_x_p6 = 0.282 * (a17_x_p4 + a17_x_p5) - a15_x;
  const Real a17_x = c17 * a17_x_p3 - s17 * a17_x_p6;

  // link 16 (right_upperarm), outward
  const Real a16_y = c16 * a15_y - s16 * a14_x;
  const Real wd16_x = s16 * wd15_y + c16 * wd15_z + w16_y * qd[15];
  const Real a17_z_p1 = w16_y * w16_z;
  const Real a17_z_p2 = a17_z_p1 - wd16_x;

  // link 17 (right_lowerarm), outward
  const Real a17_z = a16_y - 0.282 * a17_z_p2;

  // link 18 (right_wrist1), outward
  const Real a18_x = c18 * a17_x + s18 * a17_z;

  // link 17 (right_lowerarm), outward
  const Real wd17_z = wd16_y + qdd[16];

  // link 15 (right_shoulder2), outward
  const Real wd15_x = c15 * wd14_y + s15 * wd14_z + w15_y * qd[14];

  // link 16 (right_upperarm), outward
  const Real wd16_z = qdd[15] - wd15_x;

  // link 17 (right_lowerarm), outward
  const Real minus_w17_y = s17 * w16_x + c17 * w16_z;
  const Real wd17_x = c17 * wd16_x - s17 * wd16_z - minus_w17_y * qd[16];
  const Real w17_x = c17 * w16_x - s17 * w16_z;
  const Real w17_z = w16_y + qd[16];

  // link 18 (right_wrist1), outward
  const Real w18_x = c18 * w17_x + s18 * w17_z;
  const Real wd18_y = c18 * wd17_z - s18 * wd17_x - w18_x * qd[17];
  const Real w18_z = minus_w17_y + qd[17];
  const Real a19_x_p1 = w18_x * w18_z;
  const Real a19_x_p2 = a19_x_p1 + wd18_y;

  // link 19 (right_wrist2), outward
  const Real a19_x_p3 = a18_x - 0.269 * a19_x_p2;

  // link 17 (right_lowerarm), outward
  const Real minus_a17_y = s17 * a17_x_p3 + c17 * a17_x_p6;

  // link 18 (right_wrist1), outward
  const Real a19_x_p4 = w18_x * w18_x;
  const Real w18_y = c18 * w17_z - s18 * w17_x;
  const Real a19_x_p5 = w18_y * w18_y;

  // link 19 (right_wrist2), outward
  const Real a19_x_p6 = minus_a17_y + 0.269 * (a19_x_p4 + a19_x_p5);
  const Real a19_x = c19 * a19_x_p3 - s19 * a19_x_p6;
  const Real wd19_z = wd18_y + qdd[18];

  // link 18 (right_wrist1), outward
  const Real wd18_x = c18 * wd17_x + s18 * wd17_z + w18_y * qd[17];

  // link 17 (right_lowerarm), outward
  const Real minus_wd17_y = s17 * wd16_x + c17 * wd16_z + w17_x * qd[16];

  // link 18 (right_wrist1), outward
  const Real wd18_z = minus_wd17_y + qdd[17];

  // link 19 (right_wrist2), outward
  const Real w19_x = c19 * w18_x - s19 * w18_z;
  const Real minus_wd19_y = s19 * wd18_x + c19 * wd18_z + w19_x * qd[18];
  const Real minus_w19_y = s19 * w18_x + c19 * w18_z;
  const Real w19_z = w18_y + qd[18];

  // link 20 (right_hand), outward
  const Real w20_y = s20 * minus_w19_y + c20 * w19_z;
  const Real wd20_x = s20 * wd19_z - c20 * minus_wd19_y + w20_y * qd[19];
  const Real w20_z = w19_x + qd[19];
  const Real n20_x_p1 = w20_y * w20_z;
  const Real n20_x_p2 = n20_x_p1 + wd20_x;
  const Real w20_x = s20 * w19_z - c20 * minus_w19_y;
  const Real wd20_y = s20 * minus_wd19_y + c20 * wd19_z - w20_x * qd[19];
  const Real n20_x_p3 = w20_x * w20_z;
  const Real n20_x_p4 = n20_x_p3 - wd20_y;
  const Real n20_x_p5 = w20_x * w20_y;

  // link 19 (right_wrist2), outward
  const Real wd19_x = c19 * wd18_x - s19 * wd18_z - minus_w19_y * qd[18];

  // link 20 (right_hand), outward
  const Real wd20_z = wd19_x + qdd[19];
  const Real n20_x_p6 = n20_x_p5 + wd20_z;
  const Real n20_x_p7 = w20_y * w20_y;
  const Real n20_x_p8 = w20_z * w20_z;

  // link 20 (right_hand), inertial wrench
  const Real n20_x_p9 = 9.149209276993575e-05 * n20_x_p2 + 0.0001263900573325125 * n20_x_p4 -
      0.000108260010923775 * n20_x_p6 + 4.38600177048965e-05 * (n20_x_p8 - n20_x_p7);
  const Real n20_x = n20_x_p9 + 0.002865001425 * a19_x;

  // link 20 (right_hand), outward
  const Real n20_y_p1 = n20_x_p5 - wd20_z;
  const Real n20_y_p2 = w20_x * w20_x;

  // link 20 (right_hand), inertial wrench
  const Real n20_y_p3 = 4.38600177048965e-05 * n20_y_p1 - 0.000847139515629375 * n20_x_p4 -
      0.0001263900573325125 * n20_x_p2 + 0.000108260010923775 * (n20_y_p2 - n20_x_p8);
  const Real n20_y = n20_y_p3 - 0.01626499875 * a19_x;

  // link 19 (right_wrist2), outward
  const Real n19_y_p1 = w19_x * minus_w19_y;
  const Real n19_y_p2 = n19_y_p1 + wd19_z;
  const Real n19_y_p3 = w19_x * w19_z;
  const Real n19_y_p4 = n19_y_p3 + minus_wd19_y;

  // link 18 (right_wrist1), outward
  const Real a18_y = c18 * a17_z - s18 * a17_x;
  const Real a19_z_p1 = w18_y * w18_z;
  const Real a19_z_p2 = a19_z_p1 - wd18_x;

  // link 19 (right_wrist2), outward
  const Real a19_z = a18_y - 0.269 * a19_z_p2;

  // link 20 (right_hand), inward
  const Real n19_y = 2.4000000000000003e-06 * n19_y_p2 - 0.000195227662257343 * n19_y_p4 -
      0.0025100003499999995 * a19_z + (c20 * n20_x - s20 * n20_y);

  // link 19 (right_wrist2), outward
  const Real minus_a19_y = s19 * a19_x_p3 + c19 * a19_x_p6;

  // link 20 (right_hand), outward
  const Real a20_y = s20 * minus_a19_y + c20 * a19_z;
  const Real a20_x = s20 * a19_z - c20 * minus_a19_y;

  // link 20 (right_hand), inertial wrench
  const Real n20_z_p1 = 0.0007556474228594393 * n20_x_p5 + 0.0009386316083993107 * wd20_z +
      0.000108260010923775 * (n20_x_p1 - wd20_x) - 4.38600177048965e-05 * (n20_x_p3 + wd20_y);
  const Real n20_z = n20_z_p1 + 0.0001263900573325125 * (n20_x_p7 - n20_y_p2) +
      (0.01626499875 * a20_y - 0.002865001425 * a20_x);
  tau[19] = n20_z;

  // link 19 (right_wrist2), outward
  const Real n19_x_p1 = wd19_x - minus_w19_y * w19_z;
  const Real n19_x_p2 = w19_z * w19_z;
  const Real n19_x_p3 = minus_w19_y * minus_w19_y;

  // link 20 (right_hand), inward
  const Real n19_x = 1.16e-05 * n19_x_p1 - 2.4000000000000003e-06 * (n19_x_p2 - n19_x_p3) +
      0.0006000000000000001 * a19_z + n20_z;

  // link 20 (right_hand), inertial wrench
  const Real f20_x = 0.002865001425 * n20_y_p1 - 0.01626499875 * (n20_x_p7 + n20_x_p8);
  const Real f20_y = 0.01626499875 * n20_x_p6 - 0.002865001425 * (n20_y_p2 + n20_x_p8);

  // link 20 (right_hand), inward
  const Real f19_z = 0.0025100003499999995 * n19_y_p4 + 0.0006000000000000001 * n19_x_p1 +
      (s20 * f20_x + c20 * f20_y);

  // link 18 (right_wrist1), outward
  const Real n18_x_p1 = a19_z_p1 + wd18_x;
  const Real n18_x_p2 = a19_x_p1 - wd18_y;
  const Real n18_x_p3 = w18_x * w18_y;
  const Real n18_x_p4 = n18_x_p3 + wd18_z;
  const Real n18_x_p5 = w18_z * w18_z;

  // link 18 (right_wrist1), inertial wrench
  const Real n18_x_p6 = 0.0001194 * n18_x_p1 - 6e-06 * n18_x_p2 + 0.000144 * n18_x_p4 + 0.0002516 *
      (n18_x_p5 - a19_x_p5);

  // link 19 (right_wrist2), inward
  const Real n18_x = n18_x_p6 - 0.001 * minus_a17_y + (0.269 * f19_z - (s19 * n19_y - c19 * n19_x));

  // link 17 (right_lowerarm), outward
  const Real n17_x_p1 = minus_w17_y * w17_z;
  const Real n17_x_p2 = wd17_x - n17_x_p1;
  const Real n17_x_p3 = w17_x * minus_w17_y;
  const Real n17_x_p4 = wd17_z - n17_x_p3;

  // link 19 (right_wrist2), inertial wrench
  const Real n19_z_p1 = 0.00020682766225734302 * wd19_z - 0.000183627662257343 * n19_y_p1 +
      2.4000000000000003e-06 * (n19_y_p3 - minus_wd19_y) -
      (0.0025100003499999995 * minus_a19_y + 0.0006000000000000001 * a19_x);

  // link 20 (right_hand), inward
  const Real n19_z = n19_z_p1 + (s20 * n20_x + c20 * n20_y);
  tau[18] = n19_z;
  const Real f19_y = 0.0025100003499999995 * (wd19_z - n19_y_p1) - 0.0006000000000000001 *
      (w19_x * w19_x + n19_x_p2) + (c20 * f20_x - s20 * f20_y);

  // link 20 (right_hand), inertial wrench
  const Real f20_z = 0.01626499875 * n20_x_p4 + 0.002865001425 * n20_x_p2;

  // link 20 (right_hand), inward
  const Real f19_x = f20_z - (0.0025100003499999995 * (n19_x_p3 + n19_x_p2) +
      0.0006000000000000001 * n19_y_p2);

  // link 19 (right_wrist2), inward
  const Real n18_y_p1 = s19 * f19_y - c19 * f19_x;

  // link 18 (right_wrist1), outward
  const Real n18_y_p2 = n18_x_p3 - wd18_z;

  // link 18 (right_wrist1), inertial wrench
  const Real n18_y_p3 = 0.0002516 * n18_y_p2 - 0.0001098 * n18_x_p2 + 6e-06 * n18_x_p1 - 0.000144 *
      (a19_x_p4 - n18_x_p5);

  // link 19 (right_wrist2), inward
  const Real n18_y = n18_y_p3 - 6e-04 * minus_a17_y + (n19_z + 0.269 * n18_y_p1);

  // link 18 (right_wrist1), inward
  const Real n17_x_p5 = 0.06060754126741261 * n17_x_p2 + 2.249994685315e-05 * n17_x_p4 +
      0.28049749700000004 * a17_z + c18 * n18_x - s18 * n18_y;

  // link 17 (right_lowerarm), outward
  const Real n17_x_p6 = w17_x * w17_z;
  const Real n17_x_p7 = n17_x_p6 + minus_wd17_y;
  const Real n17_x_p8 = w17_z * w17_z;
  const Real n17_x_p9 = minus_w17_y * minus_w17_y;

  // link 18 (right_wrist1), inward
  const Real n17_x = n17_x_p5 + 0.0001499998887063 * (n17_x_p7 - (n17_x_p8 - n17_x_p9));

  // link 18 (right_wrist1), inertial wrench
  const Real n18_z_p1 = 0.0002292 * wd18_z - 9.600000000000003e-06 * n18_x_p3 - 0.000144 *
      a19_z_p2 - 0.0002516 * a19_x_p2 - 6e-06 * (a19_x_p5 - a19_x_p4);

  // link 19 (right_wrist2), inward
  const Real n18_z = n18_z_p1 + (6e-04 * a18_y + 0.001 * a18_x) - (s19 * n19_x + c19 * n19_y);
  tau[17] = n18_z;

  // link 17 (right_lowerarm), outward
  const Real n17_y_p1 = w17_x * w17_x;
  const Real n17_y_p2 = n17_x_p3 + wd17_z;

  // link 18 (right_wrist1), inward
  const Real n17_y = 0.0001499998887063 * (n17_y_p2 - n17_x_p2) -
      (0.00028099984685315 * n17_x_p7 + 2.249994685315e-05 * (n17_y_p1 - n17_x_p8) +
      0.0014999985000000002 * a17_z + n18_z);

  // link 19 (right_wrist2), inward
  const Real minus_f18_x = 6e-04 * (a19_x_p5 + n18_x_p5) + 0.001 * n18_y_p2 + n18_y_p1;
  const Real f18_y = 6e-04 * n18_x_p4 + 0.001 * (a19_x_p4 + n18_x_p5) + f19_z;

  // link 18 (right_wrist1), inward
  const Real f17_z = 0.0014999985000000002 * n17_x_p7 + 0.28049749700000004 * n17_x_p2 +
      (c18 * f18_y - s18 * minus_f18_x);

  // link 16 (right_upperarm), outward
  const Real n16_x_p1 = a17_z_p1 + wd16_x;
  const Real n16_x_p2 = a17_x_p1 - wd16_y;
  const Real n16_x_p3 = w16_x * w16_y;
  const Real n16_x_p4 = n16_x_p3 + wd16_z;
  const Real n16_x_p5 = w16_z * w16_z;

  // link 16 (right_upperarm), inertial wrench
  const Real n16_x_p6 = 0.0019585440854647937 * n16_x_p1 + 4.4999986458742003e-05 * n16_x_p2 -
      0.0005895000784280001 * n16_x_p4 + 0.0012089992423205001 * (n16_x_p5 - a17_x_p5);

  // link 17 (right_lowerarm), inward
  const Real n16_x = n16_x_p6 + 0.004500002325 * a15_x +
      (0.282 * f17_z - (s17 * n17_y - c17 * n17_x));

  // link 18 (right_wrist1), inward
  const Real n17_z_p1 = 0.06032654142055946 * n17_x_p3 + 0.060888541114265754 * wd17_z +
      2.249994685315e-05 * (n17_x_p1 + wd17_x) - 0.0014999985000000002 * minus_a17_y;
  const Real n17_z = n17_z_p1 - 0.28049749700000004 * a17_x + s18 * n18_x + c18 * n18_y +
      0.0001499998887063 * (n17_x_p6 - minus_wd17_y + (n17_x_p9 - n17_y_p1));
  tau[16] = n17_z;
  const Real minus_f17_x = 0.0014999985000000002 * (n17_x_p9 + n17_x_p8) + 0.28049749700000004 *
      n17_y_p2 + (c18 * minus_f18_x + s18 * f18_y);

  // link 19 (right_wrist2), inward
  const Real f18_z = 6e-04 * n18_x_p2 - 0.001 * n18_x_p1 - (s19 * f19_x + c19 * f19_y);

  // link 18 (right_wrist1), inward
  const Real f17_y = 0.0014999985000000002 * n17_x_p4 - 0.28049749700000004 *
      (n17_y_p1 + n17_x_p8) - f18_z;

  // link 17 (right_lowerarm), inward
  const Real n16_y_p1 = c17 * minus_f17_x + s17 * f17_y;

  // link 16 (right_upperarm), outward
  const Real n16_y_p2 = n16_x_p3 - wd16_z;

  // link 16 (right_upperarm), inertial wrench
  const Real n16_y_p3 = 0.0012089992423205001 * n16_y_p2 - 0.0008177492704690715 * n16_x_p2 -
      4.4999986458742003e-05 * n16_x_p1 + 0.0005895000784280001 * (a17_x_p4 - n16_x_p5);

  // link 17 (right_lowerarm), inward
  const Real n16_y = n16_y_p3 - 0.0022500062 * a15_x + (n17_z + 0.282 * n16_y_p1);

  // link 15 (right_shoulder2), outward
  const Real n15_z_p1 = w15_x * w15_y;
  const Real n15_z_p2 = w15_y * w15_z;
  const Real n15_z_p3 = w15_x * w15_z;

  // link 15 (right_shoulder2), inertial wrench
  const Real n15_z_p4 = 0.18101044219699997 * n15_z_p1 + 0.18125194219699997 * wd15_z +
      0.00010499999999999999 * (n15_z_p2 - wd15_x) + 1.75e-05 * (n15_z_p3 + wd15_y);

  // link 15 (right_shoulder2), outward
  const Real n15_z_p5 = w15_y * w15_y;
  const Real n15_z_p6 = w15_x * w15_x;

  // link 16 (right_upperarm), inward
  const Real n15_z = n15_z_p4 - 5.2499999999999995e-05 * (n15_z_p5 - n15_z_p6) +
      (0.7139200499999999 * a15_y + 0.0017499999999999998 * a15_x) + (c16 * n16_x - s16 * n16_y);
  tau[14] = n15_z;

  // link 14 (right_shoulder1), outward
  const Real n14_x_p1 = w14_y * w14_z;
  const Real n14_x_p2 = n14_x_p1 + wd14_x;
  const Real n14_x_p3 = w14_x * w14_z;
  const Real n14_x_p4 = n14_x_p3 - wd14_y;

  // link 14 (right_shoulder1), inertial wrench
  const Real n14_x_p5 = 0.0017499999999999998 * a14_z;

  // link 14 (right_shoulder1), outward
  const Real n14_x_p6 = w14_x * w14_y;
  const Real n14_x_p7 = n14_x_p6 + wd14_z;
  const Real n14_x_p8 = w14_y * w14_y;
  const Real n14_x_p9 = w14_z * w14_z;

  // link 15 (right_shoulder2), inward
  const Real n14_x = 0.0001505 * n14_x_p2 + 8.75e-06 * n14_x_p4 - n14_x_p5 + n15_z +
      2.6249999999999998e-05 * (n14_x_p7 - (n14_x_p9 - n14_x_p8));

  // link 21 (neck), outward
  const Real w21_y = c21 * w6_y - s21 * w6_z;
  const Real wd21_x = s21 * wd6_y + c21 * wd6_z + w21_y * qd[20];
  const Real wd21_z = qdd[20] - wd6_x;
  const Real w21_x = s21 * w6_y + c21 * w6_z;
  const Real w21_z = qd[20] - w6_x;

  // link 22 (head), outward
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;
  const Real wd22_x = c22 * wd21_x - s22 * wd21_z - minus_w22_y * qd[21];
  const Real w22_z = w21_y + qd[21];
  const Real n22_x_p1 = minus_w22_y * w22_z;
  const Real n22_x_p2 = wd22_x - n22_x_p1;
  const Real w22_x = c22 * w21_x - s22 * w21_z;
  const Real n22_x_p3 = w22_x * w22_z;
  const Real minus_wd22_y = s22 * wd21_x + c22 * wd21_z + w22_x * qd[21];
  const Real n22_x_p4 = n22_x_p3 + minus_wd22_y;

  // link 21 (neck), outward
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;
  const Real a22_z_p1 = w21_y * w21_z;
  const Real a22_z_p2 = a22_z_p1 - wd21_x;

  // link 22 (head), outward
  const Real a22_z = 0.394 * a22_z_p2 - minus_a21_y;

  // link 21 (neck), outward
  const Real wd21_y = c21 * wd6_y - s21 * wd6_z - w21_x * qd[20];

  // link 22 (head), outward
  const Real wd22_z = wd21_y + qdd[21];

  // link 24 (right_eye), outward
  const Real w24_y = c24 * w22_z - s24 * w22_x;
  const Real wd24_x = c24 * wd22_x + s24 * wd22_z + w24_y * qd[23];
  const Real w24_z = minus_w22_y + qd[23];
  const Real n24_x_p1 = w24_y * w24_z;
  const Real w24_x = c24 * w22_x + s24 * w22_z;
  const Real n24_x_p2 = w24_x * w24_y;
  const Real wd24_z = minus_wd22_y + qdd[23];
  const Real n24_x_p3 = n24_x_p2 + wd24_z;

  // link 24 (right_eye), inertial wrench
  const Real n24_x = 4e-06 * (n24_x_p1 + wd24_x) - 2.8750000000000004e-05 * n24_x_p3;

  // link 21 (neck), outward
  const Real a22_y_p1 = w21_x * w21_x;
  const Real a22_y_p2 = w21_y * w21_y;

  // link 22 (head), outward
  const Real a22_y_p3 = a6_x + 0.394 * (a22_y_p1 + a22_y_p2);

  // link 21 (neck), outward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;
  const Real a22_y_p4 = w21_x * w21_z;

  // link 22 (head), outward
  const Real a22_y_p5 = a21_x + 0.394 * (a22_y_p4 + wd21_y);
  const Real a22_y = c22 * a22_y_p3 - s22 * a22_y_p5;
  const Real minus_a24_z_p1 = w22_x * minus_w22_y;
  const Real minus_a24_z_p2 = wd22_z - minus_a24_z_p1;

  // link 24 (right_eye), outward
  const Real minus_a24_z_p3 = a22_y + 0.095 * minus_a24_z_p2;

  // link 23 (left_eye), outward
  const Real minus_a24_z_p4 = 0.032 * (n22_x_p1 + wd22_x);

  // link 24 (right_eye), outward
  const Real minus_a24_z = minus_a24_z_p3 + minus_a24_z_p4;
  const Real n24_y_p1 = w24_z * w24_z;
  const Real n24_y_p2 = (w24_z + qd[23]) * w24_x - (c24 * wd22_z - s24 * wd22_x);

  // link 24 (right_eye), inertial wrench
  const Real n24_y = 2.8750000000000004e-05 * (w24_x * w24_x - n24_y_p1) - 5.25e-06 * n24_y_p2 +
      0.00025 * minus_a24_z;

  // link 23 (left_eye), inward
  const Real n22_x_p5 = 0.05450270000000001 * n22_x_p2 - 0.0074 * n22_x_p4 - 0.43200000000000005 *
      a22_z + c24 * n24_x - s24 * n24_y;

  // link 23 (left_eye), outward
  const Real w23_y = c23 * w22_z - s23 * w22_x;
  const Real wd23_x = c23 * wd22_x + s23 * wd22_z + w23_y * qd[22];
  const Real w23_z = minus_w22_y + qd[22];
  const Real n23_x_p1 = w23_y * w23_z;
  const Real w23_x = c23 * w22_x + s23 * w22_z;
  const Real n23_x_p2 = w23_x * w23_y;
  const Real wd23_z = minus_wd22_y + qdd[22];
  const Real n23_x_p3 = n23_x_p2 + wd23_z;

  // link 23 (left_eye), inertial wrench
  const Real n23_x = 4e-06 * (n23_x_p1 + wd23_x) - 2.8750000000000004e-05 * n23_x_p3;

  // link 23 (left_eye), outward
  const Real minus_a23_z = minus_a24_z_p3 - minus_a24_z_p4;
  const Real n23_y_p1 = w23_z * w23_z;
  const Real n23_y_p2 = (w23_z + qd[22]) * w23_x - (c23 * wd22_z - s23 * wd22_x);

  // link 23 (left_eye), inertial wrench
  const Real n23_y = 2.8750000000000004e-05 * (w23_x * w23_x - n23_y_p1) - 5.25e-06 * n23_y_p2 +
      0.00025 * minus_a23_z;

  // link 23 (left_eye), inward
  const Real n22_x = n22_x_p5 + c23 * n23_x - s23 * n23_y + 8e-06 * (n23_y_p2 - n24_y_p2);

  // link 22 (head), outward
  const Real a22_x = c22 * a22_y_p5 + s22 * a22_y_p3;
  const Real a24_y_p1 = minus_w22_y * minus_w22_y;
  const Real a24_y_p2 = w22_z * w22_z;

  // link 23 (left_eye), outward
  const Real a24_y_p3 = a24_y_p1 + a24_y_p2;

  // link 24 (right_eye), outward
  const Real a24_y_p4 = a22_x - 0.095 * a24_y_p3;

  // link 23 (left_eye), outward
  const Real a24_y_p5 = 0.032 * (n22_x_p3 - minus_wd22_y);

  // link 24 (right_eye), outward
  const Real a24_y_p6 = a22_z + 0.095 * n22_x_p4;

  // link 22 (head), outward
  const Real a24_y_p7 = w22_x * w22_x;

  // link 23 (left_eye), outward
  const Real a24_y_p8 = 0.032 * (a24_y_p7 + a24_y_p1);

  // link 24 (right_eye), outward
  const Real a24_y = c24 * (a24_y_p6 + a24_y_p8) - s24 * (a24_y_p4 - a24_y_p5);

  // link 24 (right_eye), inertial wrench
  const Real n24_z = 1.2499999999999999e-06 * n24_x_p2 + 9.25e-06 * wd24_z +
      2.8750000000000004e-05 * (n24_x_p1 - wd24_x) + 0.00025 * a24_y;
  tau[23] = n24_z;

  // link 23 (left_eye), outward
  const Real a23_y = c23 * (a24_y_p6 - a24_y_p8) - s23 * (a24_y_p4 + a24_y_p5);

  // link 23 (left_eye), inertial wrench
  const Real n23_z = 1.2499999999999999e-06 * n23_x_p2 + 9.25e-06 * wd23_z +
      2.8750000000000004e-05 * (n23_x_p1 - wd23_x) + 0.00025 * a23_y;
  tau[22] = n23_z;

  // link 24 (right_eye), inertial wrench
  const Real f24_y = 0.00025 * n24_x_p3;
  const Real minus_f24_x = 0.00025 * (w24_y * w24_y + n24_y_p1);

  // link 23 (left_eye), inertial wrench
  const Real f23_y = 0.00025 * n23_x_p3;
  const Real minus_f23_x = 0.00025 * (w23_y * w23_y + n23_y_p1);

  // link 23 (left_eye), inward
  const Real n22_y_p1 = c24 * f24_y - s24 * minus_f24_x + (c23 * f23_y - s23 * minus_f23_x);
  const Real n22_y_p2 = 0.0074 * n22_x_p2 - 0.009438624999999999 * n22_x_p4 - 0.072575 * a22_z -
      n24_z - n23_z - 0.095 * n22_y_p1;

  // link 24 (right_eye), inward
  const Real n22_y_p3 = c24 * minus_f24_x + s24 * f24_y;

  // link 23 (left_eye), inward
  const Real n22_y_p4 = c23 * minus_f23_x + s23 * f23_y;
  const Real n22_y = n22_y_p2 + 0.032 * (n22_y_p3 - n22_y_p4);

  // link 21 (neck), outward
  const Real n21_z_p1 = w21_x * w21_y;

  // link 22 (head), inward
  const Real n21_z = 0.00621675 * wd21_z - 0.0048105000000000005 * n21_z_p1 + 0.0016155 * a22_z_p2 -
      0.0045000000000000005 * minus_a21_y - (s22 * n22_x + c22 * n22_y);
  tau[20] = n21_z;

  // link 15 (right_shoulder2), outward
  const Real n15_y_p1 = n15_z_p3 - wd15_y;
  const Real n15_y_p2 = n15_z_p1 - wd15_z;
  const Real n15_y_p3 = n15_z_p2 + wd15_x;
  const Real n15_y_p4 = w15_z * w15_z;

  // link 15 (right_shoulder2), inertial wrench
  const Real n15_y_p5 = 5.2499999999999995e-05 * n15_y_p3 -
      (0.18113119219699997 * n15_y_p1 + 1.75e-05 * n15_y_p2) + 0.00010499999999999999 *
      (n15_z_p6 - n15_y_p4);

  // link 16 (right_upperarm), inward
  const Real n15_y = n15_y_p5 - 0.7139200499999999 * a14_x + (s16 * n16_x + c16 * n16_y);

  // link 16 (right_upperarm), inertial wrench
  const Real n16_z_p1 = 0.0027762933559338653 * wd16_z - 0.001140794814995722 * n16_x_p3 +
      0.0005895000784280001 * a17_z_p2 - 0.0012089992423205001 * a17_x_p2 + 4.4999986458742003e-05 *
      (a17_x_p5 - a17_x_p4);

  // link 17 (right_lowerarm), inward
  const Real n16_z = n16_z_p1 + (0.004500002325 * a16_x - 0.0022500062 * a16_y) -
      (s17 * n17_x + c17 * n17_y);
  tau[15] = n16_z;

  // link 15 (right_shoulder2), outward
  const Real n15_x_p1 = n15_z_p1 + wd15_z;

  // link 15 (right_shoulder2), inertial wrench
  const Real n15_x_p2 = 0.00012075 * n15_y_p3 - 5.2499999999999995e-05 * n15_y_p1 -
      0.00010499999999999999 * n15_x_p1 - 1.75e-05 * (n15_y_p4 - n15_z_p5);

  // link 14 (right_shoulder1), inertial wrench
  const Real n15_x_p3 = 0.0017499999999999998 * a14_x;

  // link 16 (right_upperarm), inward
  const Real n15_x = n15_x_p2 - n15_x_p3 - n16_z;

  // link 15 (right_shoulder2), inward
  const Real n14_y_p1 = c15 * n15_x - s15 * n15_y - 0.0002975 * n14_x_p4 - 8.75e-06 * n14_x_p2 -
      n14_x_p5;

  // link 14 (right_shoulder1), outward
  const Real n14_y_p2 = n14_x_p6 - wd14_z;
  const Real n14_y_p3 = w14_x * w14_x;

  // link 15 (right_shoulder2), inward
  const Real n14_y = n14_y_p1 - 2.6249999999999998e-05 * (n14_y_p2 + (n14_y_p3 - n14_x_p9));

  // link 7 (left_shoulder1), inward
  const Real n6_x_p1 = 0.40041499999999997 * a14_y_p10 + 0.0187369177636143 * a14_z_p1 - n21_z +
      s14 * n14_x + c14 * n14_y;

  // link 7 (left_shoulder1), outward
  const Real a7_x_p1 = a14_y_p3 + a14_y_p5;
  const Real a7_x_p2 = a14_y_p8 + a14_y_p11;
  const Real a7_x = s7 * a7_x_p1 + c7 * a7_x_p2;
  const Real a7_y = c7 * a7_x_p1 - s7 * a7_x_p2;
  const Real minus_a7_z = a14_z_p2 + a14_z_p4;

  // link 8 (left_shoulder2), outward
  const Real minus_a8_y = s8 * a7_y + c8 * minus_a7_z;

  // link 9 (left_upperarm), outward
  const Real a9_x = c9 * a7_x - s9 * minus_a8_y;

  // link 7 (left_shoulder1), outward
  const Real w7_x = s7 * w6_x + c7 * w6_z;
  const Real wd7_y = c7 * wd6_x - s7 * wd6_z - w7_x * qd[6];
  const Real wd7_z = wd6_y + qdd[6];
  const Real w7_y = c7 * w6_x - s7 * w6_z;
  const Real w7_z = w6_y + qd[6];

  // link 8 (left_shoulder2), outward
  const Real w8_x = c8 * w7_y + s8 * w7_z;
  const Real wd8_y = c8 * wd7_z - s8 * wd7_y - w8_x * qd[7];

  // link 7 (left_shoulder1), outward
  const Real wd7_x = s7 * wd6_x + c7 * wd6_z + w7_y * qd[6];

  // link 8 (left_shoulder2), outward
  const Real wd8_z = wd7_x + qdd[7];
  const Real w8_y = c8 * w7_z - s8 * w7_y;
  const Real w8_z = w7_x + qd[7];

  // link 9 (left_upperarm), outward
  const Real w9_x = s9 * w8_y + c9 * w8_z;
  const Real wd9_y = c9 * wd8_y - s9 * wd8_z - w9_x * qd[8];
  const Real w9_z = qd[8] - w8_x;
  const Real a10_x_p1 = w9_x * w9_z;
  const Real a10_x_p2 = a10_x_p1 + wd9_y;

  // link 10 (left_lowerarm), outward
  const Real a10_x_p3 = a9_x - 0.282 * a10_x_p2;

  // link 9 (left_upperarm), outward
  const Real a10_x_p4 = w9_x * w9_x;
  const Real w9_y = c9 * w8_y - s9 * w8_z;
  const Real a10_x_p5 = w9_y * w9_y;

  // link 8 (left_shoulder2), outward
  const Real a8_x = c8 * a7_y - s8 * minus_a7_z;

  // link 10 (left_lowerarm), outward
  const Real a10_x_p6 = 0.282 * (a10_x_p4 + a10_x_p5) - a8_x;
  const Real a10_x = c10 * a10_x_p3 - s10 * a10_x_p6;

  // link 9 (left_upperarm), outward
  const Real minus_a9_y = c9 * minus_a8_y + s9 * a7_x;
  const Real wd9_x = s9 * wd8_y + c9 * wd8_z + w9_y * qd[8];
  const Real minus_a10_z_p1 = w9_y * w9_z;
  const Real minus_a10_z_p2 = minus_a10_z_p1 - wd9_x;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_z = minus_a9_y + 0.282 * minus_a10_z_p2;

  // link 11 (left_wrist1), outward
  const Real a11_x = c11 * a10_x - s11 * minus_a10_z;

  // link 10 (left_lowerarm), outward
  const Real wd10_z = wd9_y + qdd[9];

  // link 8 (left_shoulder2), outward
  const Real wd8_x = c8 * wd7_y + s8 * wd7_z + w8_y * qd[7];

  // link 9 (left_upperarm), outward
  const Real wd9_z = qdd[8] - wd8_x;

  // link 10 (left_lowerarm), outward
  const Real minus_w10_y = s10 * w9_x + c10 * w9_z;
  const Real wd10_x = c10 * wd9_x - s10 * wd9_z - minus_w10_y * qd[9];
  const Real w10_x = c10 * w9_x - s10 * w9_z;
  const Real w10_z = w9_y + qd[9];

  // link 11 (left_wrist1), outward
  const Real w11_x = c11 * w10_x + s11 * w10_z;
  const Real wd11_y = c11 * wd10_z - s11 * wd10_x - w11_x * qd[10];
  const Real w11_z = minus_w10_y + qd[10];
  const Real a12_x_p1 = w11_x * w11_z;
  const Real a12_x_p2 = a12_x_p1 + wd11_y;

  // link 12 (left_wrist2), outward
  const Real a12_x_p3 = a11_x - 0.269 * a12_x_p2;

  // link 10 (left_lowerarm), outward
  const Real minus_a10_y = s10 * a10_x_p3 + c10 * a10_x_p6;

  // link 11 (left_wrist1), outward
  const Real a12_x_p4 = w11_x * w11_x;
  const Real w11_y = c11 * w10_z - s11 * w10_x;
  const Real a12_x_p5 = w11_y * w11_y;

  // link 12 (left_wrist2), outward
  const Real a12_x_p6 = minus_a10_y + 0.269 * (a12_x_p4 + a12_x_p5);
  const Real a12_x = c12 * a12_x_p3 - s12 * a12_x_p6;
  const Real wd12_z = wd11_y + qdd[11];

  // link 11 (left_wrist1), outward
  const Real wd11_x = c11 * wd10_x + s11 * wd10_z + w11_y * qd[10];

  // link 10 (left_lowerarm), outward
  const Real minus_wd10_y = s10 * wd9_x + c10 * wd9_z + w10_x * qd[9];

  // link 11 (left_wrist1), outward
  const Real wd11_z = minus_wd10_y + qdd[10];

  // link 12 (left_wrist2), outward
  const Real w12_x = c12 * w11_x - s12 * w11_z;
  const Real minus_wd12_y = s12 * wd11_x + c12 * wd11_z + w12_x * qd[11];
  const Real minus_w12_y = s12 * w11_x + c12 * w11_z;
  const Real w12_z = w11_y + qd[11];

  // link 13 (left_hand), outward
  const Real w13_y = s13 * minus_w12_y + c13 * w12_z;
  const Real wd13_x = s13 * wd12_z - c13 * minus_wd12_y + w13_y * qd[12];
  const Real w13_z = w12_x + qd[12];
  const Real n13_x_p1 = w13_y * w13_z;
  const Real n13_x_p2 = n13_x_p1 + wd13_x;
  const Real w13_x = s13 * w12_z - c13 * minus_w12_y;
  const Real wd13_y = s13 * minus_wd12_y + c13 * wd12_z - w13_x * qd[12];
  const Real n13_x_p3 = w13_x * w13_z;
  const Real n13_x_p4 = n13_x_p3 - wd13_y;
  const Real n13_x_p5 = w13_x * w13_y;

  // link 12 (left_wrist2), outward
  const Real wd12_x = c12 * wd11_x - s12 * wd11_z - minus_w12_y * qd[11];

  // link 13 (left_hand), outward
  const Real wd13_z = wd12_x + qdd[12];
  const Real n13_x_p6 = n13_x_p5 + wd13_z;
  const Real n13_x_p7 = w13_y * w13_y;
  const Real n13_x_p8 = w13_z * w13_z;

  // link 13 (left_hand), inertial wrench
  const Real n13_x_p9 = 9.149209276993575e-05 * n13_x_p2 - 0.0001263900573325125 * n13_x_p4 -
      0.000108260010923775 * n13_x_p6 - 4.38600177048965e-05 * (n13_x_p8 - n13_x_p7);
  const Real n13_x = n13_x_p9 - 0.002865001425 * a12_x;

  // link 13 (left_hand), outward
  const Real n13_y_p1 = n13_x_p5 - wd13_z;
  const Real n13_y_p2 = w13_x * w13_x;

  // link 13 (left_hand), inertial wrench
  const Real n13_y_p3 = 0.0001263900573325125 * n13_x_p2 -
      (0.000847139515629375 * n13_x_p4 + 4.38600177048965e-05 * n13_y_p1) + 0.000108260010923775 *
      (n13_y_p2 - n13_x_p8);
  const Real n13_y = n13_y_p3 - 0.01626499875 * a12_x;

  // link 11 (left_wrist1), outward
  const Real minus_a11_y = s11 * a10_x + c11 * minus_a10_z;
  const Real minus_a12_z_p1 = w11_y * w11_z;
  const Real minus_a12_z_p2 = minus_a12_z_p1 - wd11_x;

  // link 12 (left_wrist2), outward
  const Real minus_a12_z = minus_a11_y + 0.269 * minus_a12_z_p2;
  const Real n12_y_p1 = w12_x * w12_z;
  const Real n12_y_p2 = n12_y_p1 + minus_wd12_y;
  const Real n12_y_p3 = w12_x * minus_w12_y;
  const Real n12_y_p4 = n12_y_p3 + wd12_z;

  // link 13 (left_hand), inward
  const Real n12_y = 0.0025100003499999995 * minus_a12_z -
      (0.000195227662257343 * n12_y_p2 + 2.4000000000000003e-06 * n12_y_p4) +
      (c13 * n13_x - s13 * n13_y);

  // link 12 (left_wrist2), outward
  const Real minus_a12_y = s12 * a12_x_p3 + c12 * a12_x_p6;

  // link 13 (left_hand), outward
  const Real a13_y = s13 * minus_a12_y - c13 * minus_a12_z;
  const Real minus_a13_x = c13 * minus_a12_y + s13 * minus_a12_z;

  // link 13 (left_hand), inertial wrench
  const Real n13_z_p1 = 0.0007556474228594393 * n13_x_p5 + 0.0009386316083993107 * wd13_z +
      0.000108260010923775 * (n13_x_p1 - wd13_x) + 4.38600177048965e-05 * (n13_x_p3 + wd13_y);
  const Real n13_z = n13_z_p1 - 0.0001263900573325125 * (n13_x_p7 - n13_y_p2) +
      (0.01626499875 * a13_y - 0.002865001425 * minus_a13_x);
  tau[12] = n13_z;

  // link 12 (left_wrist2), outward
  const Real n12_x_p1 = wd12_x - minus_w12_y * w12_z;
  const Real n12_x_p2 = w12_z * w12_z;
  const Real n12_x_p3 = minus_w12_y * minus_w12_y;

  // link 13 (left_hand), inward
  const Real n12_x = 1.16e-05 * n12_x_p1 + 2.4000000000000003e-06 * (n12_x_p2 - n12_x_p3) -
      0.0006000000000000001 * minus_a12_z + n13_z;

  // link 13 (left_hand), inertial wrench
  const Real f13_y = 0.01626499875 * n13_x_p6 + 0.002865001425 * (n13_y_p2 + n13_x_p8);
  const Real minus_f13_x = 0.01626499875 * (n13_x_p7 + n13_x_p8) + 0.002865001425 * n13_y_p1;

  // link 13 (left_hand), inward
  const Real f12_z = 0.0025100003499999995 * n12_y_p2 + 0.0006000000000000001 * n12_x_p1 +
      (c13 * f13_y - s13 * minus_f13_x);

  // link 11 (left_wrist1), outward
  const Real n11_x_p1 = minus_a12_z_p1 + wd11_x;
  const Real n11_x_p2 = a12_x_p1 - wd11_y;
  const Real n11_x_p3 = w11_x * w11_y;
  const Real n11_x_p4 = n11_x_p3 + wd11_z;
  const Real n11_x_p5 = w11_z * w11_z;

  // link 11 (left_wrist1), inertial wrench
  const Real n11_x_p6 = 0.0001194 * n11_x_p1 + 6e-06 * n11_x_p2 + 0.000144 * n11_x_p4 - 0.0002516 *
      (n11_x_p5 - a12_x_p5);

  // link 12 (left_wrist2), inward
  const Real n11_x = n11_x_p6 + 0.001 * minus_a10_y + (0.269 * f12_z - (s12 * n12_y - c12 * n12_x));

  // link 10 (left_lowerarm), outward
  const Real n10_x_p1 = minus_w10_y * w10_z;
  const Real n10_x_p2 = wd10_x - n10_x_p1;
  const Real n10_x_p3 = w10_x * minus_w10_y;
  const Real n10_x_p4 = wd10_z - n10_x_p3;

  // link 12 (left_wrist2), inertial wrench
  const Real n12_z_p1 = 0.00020682766225734302 * wd12_z - 0.000183627662257343 * n12_y_p3 -
      2.4000000000000003e-06 * (n12_y_p1 - minus_wd12_y) -
      (0.0025100003499999995 * minus_a12_y + 0.0006000000000000001 * a12_x);

  // link 13 (left_hand), inward
  const Real n12_z = n12_z_p1 + (s13 * n13_x + c13 * n13_y);
  tau[11] = n12_z;
  const Real f12_y = 0.0025100003499999995 * (wd12_z - n12_y_p3) - 0.0006000000000000001 *
      (w12_x * w12_x + n12_x_p2) - (c13 * minus_f13_x + s13 * f13_y);

  // link 13 (left_hand), inertial wrench
  const Real f13_z = 0.01626499875 * n13_x_p4 - 0.002865001425 * n13_x_p2;

  // link 13 (left_hand), inward
  const Real f12_x = f13_z - (0.0025100003499999995 * (n12_x_p3 + n12_x_p2) +
      0.0006000000000000001 * n12_y_p4);

  // link 12 (left_wrist2), inward
  const Real n11_y_p1 = s12 * f12_y - c12 * f12_x;

  // link 11 (left_wrist1), outward
  const Real n11_y_p2 = n11_x_p3 - wd11_z;

  // link 11 (left_wrist1), inertial wrench
  const Real n11_y_p3 = 0.0001098 * n11_x_p2 + 0.0002516 * n11_y_p2 + 6e-06 * n11_x_p1 + 0.000144 *
      (a12_x_p4 - n11_x_p5);

  // link 12 (left_wrist2), inward
  const Real n11_y = n12_z + 0.269 * n11_y_p1 - (n11_y_p3 + 6e-04 * minus_a10_y);

  // link 11 (left_wrist1), inward
  const Real n10_x_p5 = 0.06060754126741261 * n10_x_p2 - 2.249994685315e-05 * n10_x_p4 -
      0.28049749700000004 * minus_a10_z + c11 * n11_x - s11 * n11_y;

  // link 10 (left_lowerarm), outward
  const Real n10_x_p6 = w10_x * w10_z;
  const Real n10_x_p7 = n10_x_p6 + minus_wd10_y;
  const Real n10_x_p8 = w10_z * w10_z;
  const Real n10_x_p9 = minus_w10_y * minus_w10_y;

  // link 11 (left_wrist1), inward
  const Real n10_x = n10_x_p5 + 0.0001499998887063 * (n10_x_p7 + (n10_x_p8 - n10_x_p9));

  // link 11 (left_wrist1), inertial wrench
  const Real n11_z_p1 = 0.0002292 * wd11_z - 9.600000000000003e-06 * n11_x_p3 - 0.000144 *
      minus_a12_z_p2 + 0.0002516 * a12_x_p2 + 6e-06 * (a12_x_p5 - a12_x_p4);

  // link 12 (left_wrist2), inward
  const Real n11_z = n11_z_p1 - (6e-04 * minus_a11_y + 0.001 * a11_x) - (s12 * n12_x + c12 * n12_y);
  tau[10] = n11_z;

  // link 10 (left_lowerarm), outward
  const Real n10_y_p1 = w10_x * w10_x;
  const Real n10_y_p2 = n10_x_p3 + wd10_z;

  // link 11 (left_wrist1), inward
  const Real n10_y = 2.249994685315e-05 * (n10_y_p1 - n10_x_p8) - 0.00028099984685315 * n10_x_p7 +
      0.0014999985000000002 * minus_a10_z - n11_z - 0.0001499998887063 * (n10_y_p2 + n10_x_p2);

  // link 12 (left_wrist2), inward
  const Real f11_x = 0.001 * n11_y_p2 - 6e-04 * (a12_x_p5 + n11_x_p5) - n11_y_p1;
  const Real f11_y = 6e-04 * n11_x_p4 - 0.001 * (a12_x_p4 + n11_x_p5) + f12_z;

  // link 11 (left_wrist1), inward
  const Real f10_z = 0.0014999985000000002 * n10_x_p7 + 0.28049749700000004 * n10_x_p2 +
      (s11 * f11_x + c11 * f11_y);

  // link 9 (left_upperarm), outward
  const Real n9_x_p1 = minus_a10_z_p1 + wd9_x;
  const Real n9_x_p2 = a10_x_p1 - wd9_y;
  const Real n9_x_p3 = w9_x * w9_y;
  const Real n9_x_p4 = n9_x_p3 + wd9_z;
  const Real n9_x_p5 = w9_z * w9_z;

  // link 9 (left_upperarm), inertial wrench
  const Real n9_x_p6 = 0.0019585440854647937 * n9_x_p1 - 4.4999986458742003e-05 * n9_x_p2 -
      0.0005895000784280001 * n9_x_p4 - 0.0012089992423205001 * (n9_x_p5 - a10_x_p5);

  // link 10 (left_lowerarm), inward
  const Real n9_x = n9_x_p6 - 0.004500002325 * a8_x + (0.282 * f10_z - (s10 * n10_y - c10 * n10_x));

  // link 11 (left_wrist1), inward
  const Real n10_z_p1 = 0.06032654142055946 * n10_x_p3 + 0.060888541114265754 * wd10_z -
      2.249994685315e-05 * (n10_x_p1 + wd10_x) - 0.0014999985000000002 * minus_a10_y;
  const Real n10_z = n10_z_p1 - 0.28049749700000004 * a10_x + s11 * n11_x + c11 * n11_y +
      0.0001499998887063 * (n10_x_p9 - n10_y_p1 - (n10_x_p6 - minus_wd10_y));
  tau[9] = n10_z;

  // link 12 (left_wrist2), inward
  const Real f11_z = 6e-04 * n11_x_p2 + 0.001 * n11_x_p1 - (s12 * f12_x + c12 * f12_y);

  // link 11 (left_wrist1), inward
  const Real f10_y = 0.0014999985000000002 * n10_x_p4 - 0.28049749700000004 *
      (n10_y_p1 + n10_x_p8) - f11_z;
  const Real f10_x = c11 * f11_x - s11 * f11_y - (0.0014999985000000002 * (n10_x_p9 + n10_x_p8) +
      0.28049749700000004 * n10_y_p2);

  // link 10 (left_lowerarm), inward
  const Real n9_y_p1 = s10 * f10_y - c10 * f10_x;

  // link 9 (left_upperarm), outward
  const Real n9_y_p2 = n9_x_p3 - wd9_z;

  // link 9 (left_upperarm), inertial wrench
  const Real n9_y_p3 = 4.4999986458742003e-05 * n9_x_p1 -
      (0.0008177492704690715 * n9_x_p2 + 0.0012089992423205001 * n9_y_p2) + 0.0005895000784280001 *
      (a10_x_p4 - n9_x_p5);

  // link 10 (left_lowerarm), inward
  const Real n9_y = n9_y_p3 - 0.0022500062 * a8_x + (n10_z + 0.282 * n9_y_p1);

  // link 8 (left_shoulder2), outward
  const Real n8_z_p1 = w8_x * w8_y;
  const Real n8_z_p2 = w8_y * w8_z;
  const Real n8_z_p3 = w8_x * w8_z;

  // link 8 (left_shoulder2), inertial wrench
  const Real n8_z_p4 = 0.18101044219699997 * n8_z_p1 + 0.18125194219699997 * wd8_z +
      0.00010499999999999999 * (n8_z_p2 - wd8_x) - 1.75e-05 * (n8_z_p3 + wd8_y);

  // link 8 (left_shoulder2), outward
  const Real n8_z_p5 = w8_y * w8_y;
  const Real n8_z_p6 = w8_x * w8_x;

  // link 9 (left_upperarm), inward
  const Real n8_z = n8_z_p4 + 5.2499999999999995e-05 * (n8_z_p5 - n8_z_p6) -
      (0.7139200499999999 * minus_a8_y + 0.0017499999999999998 * a8_x) + (c9 * n9_x - s9 * n9_y);
  tau[7] = n8_z;

  // link 7 (left_shoulder1), outward
  const Real n7_x_p1 = w7_y * w7_z;
  const Real n7_x_p2 = n7_x_p1 + wd7_x;
  const Real n7_x_p3 = w7_x * w7_z;
  const Real n7_x_p4 = n7_x_p3 - wd7_y;

  // link 7 (left_shoulder1), inertial wrench
  const Real n7_x_p5 = 0.0017499999999999998 * minus_a7_z;

  // link 7 (left_shoulder1), outward
  const Real n7_x_p6 = w7_y * w7_y;
  const Real n7_x_p7 = w7_z * w7_z;
  const Real n7_x_p8 = w7_x * w7_y;
  const Real n7_x_p9 = n7_x_p8 + wd7_z;

  // link 8 (left_shoulder2), inward
  const Real n7_x = 0.0001505 * n7_x_p2 + 8.75e-06 * n7_x_p4 + n7_x_p5 + n8_z +
      2.6249999999999998e-05 * (n7_x_p7 - n7_x_p6 - n7_x_p9);

  // link 8 (left_shoulder2), outward
  const Real n8_y_p1 = n8_z_p1 - wd8_z;
  const Real n8_y_p2 = n8_z_p3 - wd8_y;
  const Real n8_y_p3 = n8_z_p2 + wd8_x;
  const Real n8_y_p4 = w8_z * w8_z;

  // link 8 (left_shoulder2), inertial wrench
  const Real n8_y_p5 = 1.75e-05 * n8_y_p1 - 0.18113119219699997 * n8_y_p2 - 5.2499999999999995e-05 *
      n8_y_p3 + 0.00010499999999999999 * (n8_z_p6 - n8_y_p4);

  // link 9 (left_upperarm), inward
  const Real n8_y = n8_y_p5 - 0.7139200499999999 * a7_x + (s9 * n9_x + c9 * n9_y);

  // link 9 (left_upperarm), inertial wrench
  const Real n9_z_p1 = 0.0027762933559338653 * wd9_z - 0.001140794814995722 * n9_x_p3 +
      0.0005895000784280001 * minus_a10_z_p2 + 0.0012089992423205001 * a10_x_p2 -
      4.4999986458742003e-05 * (a10_x_p5 - a10_x_p4);

  // link 10 (left_lowerarm), inward
  const Real n9_z = n9_z_p1 + (0.0022500062 * minus_a9_y - 0.004500002325 * a9_x) -
      (s10 * n10_x + c10 * n10_y);
  tau[8] = n9_z;

  // link 8 (left_shoulder2), outward
  const Real n8_x_p1 = n8_z_p1 + wd8_z;

  // link 8 (left_shoulder2), inertial wrench
  const Real n8_x_p2 = 0.00012075 * n8_y_p3 + 5.2499999999999995e-05 * n8_y_p2 -
      0.00010499999999999999 * n8_x_p1 + 1.75e-05 * (n8_y_p4 - n8_z_p5);

  // link 7 (left_shoulder1), inertial wrench
  const Real n8_x_p3 = 0.0017499999999999998 * a7_x;

  // link 9 (left_upperarm), inward
  const Real n8_x = n8_x_p2 + n8_x_p3 - n9_z;

  // link 8 (left_shoulder2), inward
  const Real n7_y_p1 = n7_x_p5 - (0.0002975 * n7_x_p4 + 8.75e-06 * n7_x_p2) + c8 * n8_x - s8 * n8_y;

  // link 7 (left_shoulder1), outward
  const Real n7_y_p2 = n7_x_p8 - wd7_z;
  const Real n7_y_p3 = w7_x * w7_x;

  // link 8 (left_shoulder2), inward
  const Real n7_y = n7_y_p1 + 2.6249999999999998e-05 * (n7_y_p2 + (n7_y_p3 - n7_x_p7));

  // link 10 (left_lowerarm), inward
  const Real f9_z = 0.004500002325 * n9_x_p1 - 0.0022500062 * n9_x_p2 - (s10 * f10_x + c10 * f10_y);

  // link 9 (left_upperarm), inward
  const Real f8_x = 0.0017499999999999998 * n8_y_p1 - 0.7139200499999999 * (n8_z_p5 + n8_y_p4) -
      f9_z;

  // link 10 (left_lowerarm), inward
  const Real f9_x = 0.0022500062 * (a10_x_p5 + n9_x_p5) + 0.004500002325 * n9_y_p2 - n9_y_p1;
  const Real f9_y = f10_z - (0.0022500062 * n9_x_p4 + 0.004500002325 * (a10_x_p4 + n9_x_p5));

  // link 9 (left_upperarm), inward
  const Real f8_y = 0.7139200499999999 * n8_x_p1 - 0.0017499999999999998 * (n8_z_p6 + n8_y_p4) +
      (s9 * f9_x + c9 * f9_y);

  // link 8 (left_shoulder2), inward
  const Real f7_y = c8 * f8_x - s8 * f8_y + 0.0017499999999999998 * (n7_x_p9 + (n7_y_p3 + n7_x_p7));
  const Real f7_x = 0.7139200499999999 * n8_y_p2 + c9 * f9_x - s9 * f9_y + 0.0017499999999999998 *
      (n8_y_p3 - (n7_x_p6 + n7_x_p7) - n7_y_p2);

  // link 7 (left_shoulder1), inward
  const Real n6_x_p2 = c7 * f7_x - s7 * f7_y;

  // link 17 (right_lowerarm), inward
  const Real f16_z = s17 * minus_f17_x - c17 * f17_y -
      (0.0022500062 * n16_x_p2 + 0.004500002325 * n16_x_p1);

  // link 16 (right_upperarm), inward
  const Real minus_f15_x = 0.7139200499999999 * (n15_z_p5 + n15_y_p4) + 0.0017499999999999998 *
      n15_y_p2 + f16_z;

  // link 17 (right_lowerarm), inward
  const Real f16_x = 0.0022500062 * (a17_x_p5 + n16_x_p5) - 0.004500002325 * n16_y_p2 - n16_y_p1;
  const Real f16_y = 0.004500002325 * (a17_x_p4 + n16_x_p5) - 0.0022500062 * n16_x_p4 + f17_z;

  // link 16 (right_upperarm), inward
  const Real f15_y = 0.7139200499999999 * n15_x_p1 + 0.0017499999999999998 * (n15_z_p6 + n15_y_p4) +
      (s16 * f16_x + c16 * f16_y);

  // link 15 (right_shoulder2), inward
  const Real f14_y = 0.0017499999999999998 * (n14_x_p7 + (n14_y_p3 + n14_x_p9)) -
      (c15 * minus_f15_x + s15 * f15_y);
  const Real f14_x = 0.7139200499999999 * n15_y_p1 + c16 * f16_x - s16 * f16_y -
      0.0017499999999999998 * (n15_y_p3 + (n14_x_p8 + n14_x_p9) + n14_y_p2);

  // link 14 (right_shoulder1), inward
  const Real n6_x_p3 = c14 * f14_x - s14 * f14_y;

  // link 7 (left_shoulder1), inward
  const Real n6_x = n6_x_p1 + s7 * n7_x + c7 * n7_y + 0.18 * (n6_x_p2 - n6_x_p3);

  // link 15 (right_shoulder2), inward
  const Real n14_z_p1 = 0.00014700000000000002 * n14_x_p6 + 0.00044800000000000005 * wd14_z +
      8.75e-06 * (n14_x_p8 - n14_y_p3) + 0.0017499999999999998 * a14_y;
  const Real n14_z = n14_z_p1 + n15_x_p3 + s15 * n15_x + c15 * n15_y + 2.6249999999999998e-05 *
      (n14_x_p3 + wd14_y - (n14_x_p1 - wd14_x));
  tau[13] = n14_z;

  // link 23 (left_eye), inward
  const Real f22_z = 0.072575 * n22_x_p4 - 0.43200000000000005 * n22_x_p2 + n22_y_p1;

  // link 21 (neck), outward
  const Real n21_x_p1 = n21_z_p1 + wd21_z;

  // link 22 (head), inward
  const Real n21_x = 0.005513625 * (a22_z_p1 + wd21_x) - 0.0016155 * n21_x_p1 -
      (s22 * n22_y - c22 * n22_x + 0.394 * f22_z);

  // link 7 (left_shoulder1), inward
  const Real n6_y_p1 = 6.1665928899999995 * a6_z - 1.66923963592404 * a14_y_p7 -
      0.0187369177636143 * (a14_z_p3 - a14_y_p1) + s21 * n21_x;

  // link 23 (left_eye), inward
  const Real n22_z_p1 = 0.04506407500000001 * minus_a24_z_p1 + 0.06394132500000001 * wd22_z -
      0.0074 * (a24_y_p1 - a24_y_p7) + 0.072575 * a22_y;
  const Real n22_z_p2 = n22_z_p1 + 0.43200000000000005 * a22_x + s24 * n24_x + c24 * n24_y + s23 *
      n23_x;
  const Real n22_z_p3 = n24_y_p2 + n23_y_p2;
  const Real n22_z = n22_z_p2 + c23 * n23_y - 2.375e-05 * n22_z_p3;
  tau[21] = n22_z;
  const Real f22_y = 0.072575 * minus_a24_z_p2 + 0.43200000000000005 * (a24_y_p7 + a24_y_p2) -
      0.00025 * n22_z_p3;
  const Real f22_x = 0.43200000000000005 * (minus_a24_z_p1 + wd22_z) - 0.072575 * a24_y_p3 -
      n22_y_p3 - n22_y_p4;

  // link 22 (head), inward
  const Real n21_y_p1 = s22 * f22_y - c22 * f22_x;

  // link 21 (neck), outward
  const Real n21_y_p2 = w21_z * w21_z;
  const Real n21_y_p3 = a22_y_p4 - wd21_y;

  // link 22 (head), inward
  const Real n21_y = 0.0016155 * (a22_y_p1 - n21_y_p2) - 0.000703125 * n21_y_p3 +
      0.0045000000000000005 * a6_x + (n22_z - 0.394 * n21_y_p1);

  // link 8 (left_shoulder2), inward
  const Real n7_z_p1 = 0.00014700000000000002 * n7_x_p8 + 0.00044800000000000005 * wd7_z +
      8.75e-06 * (n7_x_p6 - n7_y_p3) + 0.0017499999999999998 * a7_y;
  const Real n7_z = n7_z_p1 + n8_x_p3 + s8 * n8_x + c8 * n8_y + 2.6249999999999998e-05 *
      (n7_x_p1 - wd7_x - (n7_x_p3 + wd7_y));
  tau[6] = n7_z;

  // link 7 (left_shoulder1), inward
  const Real n6_y_p2 = n6_x_p3 + n6_x_p2;
  const Real n6_y = n6_y_p1 + c21 * n21_y + n14_z + n7_z + 0.226 * n6_y_p2;

  // link 5 (chest2), outward
  const Real n5_y_p1 = w5_x * w5_z + minus_wd5_y;

  // link 6 (chest3), inward
  const Real n5_y = 0.005678398088837119 * a6_x_p5 - 0.04675382692737882 * n5_y_p1 +
      0.069699984375 * minus_a5_z + (c6 * n6_x - s6 * n6_y);

  // link 6 (chest3), inertial wrench
  const Real n6_z_p1 = 1.26882463592404 * a14_y_p4 + 2.06965463592404 * wd6_z - 0.0187369177636143 *
      (a14_y_p9 - wd6_x) + 6.1665928899999995 * minus_a6_y;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p2 = n6_z_p1 + c21 * n21_x - s21 * n21_y + c14 * n14_x - s14 * n14_y;

  // link 15 (right_shoulder2), inward
  const Real f14_z = c15 * f15_y - s15 * minus_f15_x + 0.0017499999999999998 *
      (n14_x_p4 - n14_x_p2);

  // link 8 (left_shoulder2), inward
  const Real f7_z = s8 * f8_x + c8 * f8_y + 0.0017499999999999998 * (n7_x_p4 - n7_x_p2);

  // link 7 (left_shoulder1), inward
  const Real n6_z_p3 = f14_z + f7_z;

  // link 14 (right_shoulder1), inward
  const Real n6_z_p4 = s14 * f14_x + c14 * f14_y;

  // link 7 (left_shoulder1), inward
  const Real n6_z_p5 = s7 * f7_x + c7 * f7_y;
  const Real n6_z = n6_z_p2 + c7 * n7_x - s7 * n7_y - 0.226 * n6_z_p3 + 0.18 * (n6_z_p4 - n6_z_p5);
  tau[5] = n6_z;

  // link 22 (head), inward
  const Real f21_z = 0.0045000000000000005 * n21_y_p3 - (s22 * f22_x + c22 * f22_y);

  // link 7 (left_shoulder1), inward
  const Real f6_x = 6.1665928899999995 * a14_y_p2 - f21_z + n6_z_p4 + n6_z_p5;

  // link 22 (head), inward
  const Real minus_f21_x = 0.0045000000000000005 * (a22_y_p2 + n21_y_p2) + n21_y_p1;
  const Real f21_y = 0.0045000000000000005 * n21_x_p1 + f22_z;

  // link 7 (left_shoulder1), inward
  const Real f6_y = n6_z_p3 - 6.1665928899999995 * a14_z_p1 - s21 * minus_f21_x + c21 * f21_y;

  // link 6 (chest3), inward
  const Real n5_x_p1 = s6 * f6_x + c6 * f6_y;
  const Real n5_x = 0.15637308509675518 * a6_x_p5 - 0.005678398088837119 * n5_y_p1 +
      2.2194301519999997 * minus_a5_z + (n6_z - 0.072 * n5_x_p1);
  const Real f5_z = 0.069699984375 * n5_y_p1 - 2.2194301519999997 * a6_x_p5 + n5_x_p1;

  // link 4 (chest1), outward
  const Real n4_x_p1 = w4_x * w4_y;
  const Real n4_x_p2 = n4_x_p1 + qdd[3];

  // link 5 (chest2), inward
  const Real n4_x = 0.0478915 * (wd4_x_p1 + wd4_x) + 0.005880002159562879 * n4_x_p2 -
      (s5 * n5_y - c5 * n5_x + 0.21799999999999997 * f5_z);

  // link 7 (left_shoulder1), inward
  const Real f6_z = n6_y_p2 - 6.1665928899999995 * a14_y_p7 - c21 * minus_f21_x - s21 * f21_y;

  // link 5 (chest2), outward
  const Real n5_z_p1 = minus_w5_y * minus_w5_y;

  // link 5 (chest2), inertial wrench
  const Real n5_z_p2 = 0.10961925816937637 * a6_z_p1 + 0.203126912024134 * wd5_z -
      0.005678398088837119 * (n5_z_p1 - a6_x_p1) + (0.069699984375 * a5_y + 2.2194301519999997 *
      a5_x);

  // link 6 (chest3), inward
  const Real n5_z = n5_z_p2 + (s6 * n6_x + c6 * n6_y + 0.072 * f6_z);
  tau[4] = n5_z;
  const Real f5_y = 0.069699984375 * (wd5_z - a6_z_p1) + 2.2194301519999997 * a6_x_p3 +
      (c6 * f6_x - s6 * f6_y);
  const Real f5_x = 2.2194301519999997 * a6_z_p2 - 0.069699984375 * (n5_z_p1 + a6_x_p2) + f6_z;

  // link 5 (chest2), inward
  const Real n4_y_p1 = s5 * f5_y - c5 * f5_x;

  // link 4 (chest1), outward
  const Real n4_y_p2 = wd4_y_p1 - wd4_y;
  const Real n4_y_p3 = qd[3] * qd[3];

  // link 5 (chest2), inward
  const Real n4_y = n5_z - 0.21799999999999997 * n4_y_p1 -
      (0.01227760324629517 * n4_y_p2 + 0.005880002159562879 * (a5_y_p1 - n4_y_p3) + 0.0300000063 *
      a3_y);

  // link 4 (chest1), inward
  const Real n3_z = 1.7824817919087104 * wd3_z + (8.419374554 * a3_x - 0.02999999505 * a3_y) +
      (s4 * n4_x + c4 * n4_y);
  tau[2] = n3_z;

  // link 5 (chest2), inward
  const Real f4_x = 0.0300000063 * (a5_y_p2 + n4_y_p3) - n4_y_p1;
  const Real f4_y = f5_z - 0.0300000063 * n4_x_p2;

  // link 3 (hip), outward
  const Real f3_x_p1 = w3_z * w3_z;

  // link 4 (chest1), inward
  const Real f3_x = 0.02999999505 * f3_x_p1 + 8.419374554 * wd3_z + (c4 * f4_x - s4 * f4_y);

  // link 5 (chest2), inward
  const Real minus_f4_z = 0.0300000063 * n4_y_p2 + (s5 * f5_x + c5 * f5_y);

  // link 4 (chest1), inward
  const Real f3_y = 8.419374554 * f3_x_p1 - 0.02999999505 * wd3_z + minus_f4_z;

  // link 3 (hip), inward
  const Real n2_z_p1 = c3 * f3_x - s3 * f3_y;
  const Real n2_z = 9.885744550888212 * wd2_z + (0.031999971599999996 * a2_y + 24.5839218 * a2_x) +
      (n3_z + 0.422 * n2_z_p1);
  tau[1] = n2_z;
  const Real f2_x = 24.5839218 * wd2_z - 0.031999971599999996 * a3_y_p1 + n2_z_p1;
  const Real f2_y = 0.031999971599999996 * wd2_z + 24.5839218 * a3_y_p1 + (s3 * f3_x + c3 * f3_y);

  // link 2 (thigh), inward
  const Real n1_z = 13.049859506913753 * qdd[0] + (0.1569597827085 * c1 - 299.6743959432 * s1) +
      (n2_z + 0.434 * (c2 * f2_x - s2 * f2_y));
  tau[0] = n1_z;

  // link 5 (chest2), inward
  const Real n4_z = 0.060169103246295166 * qdd[3] - 0.03561389675370483 * n4_x_p1 +
      0.005880002159562879 * minus_a5_z_p1 + 0.0300000063 * minus_a4_y - (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
