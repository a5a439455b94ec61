// bias_acceleration: xdd = J qdd + Jd qd: the term Jd qd
// By outward recursion, Chang eq. 6.11, alike limbs in lanes.
// 824 flops (add 315, mul 509, div 0), sine and cosine of 20 angles
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
void bias_acceleration(const Real (&TREELINE_RESTRICT q)[24],
    const Real (&TREELINE_RESTRICT qd)[24], Real (&TREELINE_RESTRICT bias)[12]) noexcept {
  const Real angles[20] = {q[10], q[8], q[7], q[6], q[5], q[4], q[3], q[1], q[2], q[0], q[9], q[11],
      q[12], q[17], q[15], q[14], q[13], q[16], q[18], q[19]};
  Real sines[20];
  Real cosines[20];
  detail::sin_cos(angles, sines, cosines);
  const Real c11 = cosines[0];
  const Real c9 = cosines[1];
  const Real s8 = sines[2];
  const Real c7 = cosines[3];
  const Real c6 = cosines[4];
  const Real s5 = sines[5];
  const Real c4 = cosines[6];
  const Real c2 = cosines[7];
  const Real c3 = cosines[8];
  const Real s2 = sines[7];
  const Real s3 = sines[8];
  const Real c1 = cosines[9];
  const Real s1 = sines[9];
  const Real c5 = cosines[5];
  const Real s6 = sines[4];
  const Real s4 = sines[6];
  const Real s7 = sines[3];
  const Real c8 = cosines[2];
  const Real s9 = sines[1];
  const Real s11 = sines[0];
  const Real c10 = cosines[10];
  const Real s10 = sines[10];
  const Real c12 = cosines[11];
  const Real s12 = sines[11];
  const Real c13 = cosines[12];
  const Real s13 = sines[12];
  const Real c18 = cosines[13];
  const Real c16 = cosines[14];
  const Real s15 = sines[15];
  const Real c14 = cosines[16];
  const Real s14 = sines[16];
  const Real c15 = cosines[15];
  const Real s16 = sines[14];
  const Real s18 = sines[13];
  const Real c17 = cosines[17];
  const Real s17 = sines[17];
  const Real c19 = cosines[18];
  const Real s19 = sines[18];
  const Real c20 = cosines[19];
  const Real s20 = sines[19];

  // link 2 (thigh), outward
  const Real w2_z = qd[0] + qd[1];
  const Lanes<2> bias_0_p1_lanes = 0.086 * detail::make_pack<Real>(c13, c20);

  // link 3 (hip), outward
  const Real w3_z = w2_z + qd[2];

  // link 5 (chest2), outward
  const Real w5_x_p1 = s4 * w3_z;

  // link 4 (chest1), outward
  const Real wd4_x = w3_z * qd[3];

  // link 5 (chest2), outward
  const Real minus_wd5_y_p1 = c4 * wd4_x;
  const Real w5_z = c4 * w3_z + qd[4];
  const Real minus_wd5_z = s4 * wd4_x;
  const Lanes<2> bias_0_p2_lanes = 0.086 * detail::make_pack<Real>(s13, s20);
  const Real w5_x = c5 * w5_x_p1 - s5 * qd[3];
  const Real minus_w5_y = s5 * w5_x_p1 + c5 * qd[3];

  // link 3 (hip), outward
  const Real a3_x_p1 = 0.422 * (w2_z * w2_z);
  const Real a3_y_p1 = s2 * c3 + c2 * s3;
  const Real a3_x_p2 = c2 * c3 - s2 * s3;

  // link 2 (thigh), outward
  const Real a2_y = 0.434 * (qd[0] * qd[0]);

  // link 6 (chest3), outward
  const Real w6_z = w5_x + qd[5];

  // link 3 (hip), outward
  const Real a3_x_p3 = a3_x_p1 * s2;

  // link 5 (chest2), outward
  const Real minus_wd5_y = s5 * minus_wd5_y_p1 + w5_x * qd[4];

  // link 6 (chest3), outward
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;

  // link 5 (chest2), outward
  const Real wd5_x = c5 * minus_wd5_y_p1 - minus_w5_y * qd[4];

  // link 3 (hip), outward
  const Real a3_x_p4 = a2_y + a3_x_p1 * c2;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);

  // link 6 (chest3), outward
  const Real a7_y_p1 = w6_z * w6_z;
  const Real a7_y_p2 = w6_x * w6_y;

  // link 7 (left_shoulder1), outward
  const Lanes<2> w7_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;
  const Lanes<2> w7_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;

  // link 3 (hip), outward
  const Real a3_x = a3_y_p1 * a3_x_p4 - a3_x_p2 * a3_x_p3;
  const Real a3_y = a3_y_p1 * a3_x_p3 + a3_x_p2 * a3_x_p4;

  // link 6 (chest3), outward
  const Real wd6_x = w6_y * qd[5] - (c6 * minus_wd5_y + s6 * minus_wd5_z);
  const Real wd6_y = s6 * minus_wd5_y - c6 * minus_wd5_z - w6_x * qd[5];
  const Real a7_y_p3 = a7_y_p2 - wd5_x;

  // link 5 (chest2), outward
  const Real a5_y_p1 = c4 * a3_x;
  const Real a5_y_p2 = a3_y + 0.21799999999999997 * (w3_z * w3_z);
  const Real minus_a5_z = s4 * a3_x;

  // link 6 (chest3), outward
  const Real a7_y_p4 = w6_y * w6_z + wd6_x;

  // link 8 (left_shoulder2), outward
  const Lanes<2> w8_z_lanes = w7_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);
  const Lanes<2> w8_x_lanes = detail::make_pack<Real>(c8, c15) * w7_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_z_lanes;
  const Lanes<2> w8_y_lanes = detail::make_pack<Real>(c8, c15) * w7_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_y_lanes;

  // link 6 (chest3), outward
  const Real a6_x_p1 = minus_a5_z + 0.072 * (wd5_x - minus_w5_y * w5_z);

  // link 5 (chest2), outward
  const Real a5_y = c5 * a5_y_p2 - s5 * a5_y_p1;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_y_lanes = detail::make_pack<Real>(c7, c14) * wd6_x -
      detail::make_pack<Real>(s7, s14) * wd5_x - w7_x_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);

  // link 5 (chest2), outward
  const Real a5_x = c5 * a5_y_p1 + s5 * a5_y_p2;

  // link 7 (left_shoulder1), outward
  const Lanes<2> wd7_x_lanes = detail::make_pack<Real>(s7, s14) * wd6_x +
      detail::make_pack<Real>(c7, c14) * wd5_x + w7_y_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);

  // link 6 (chest3), outward
  const Real minus_a7_z_p1 = w6_x * w6_x + a7_y_p1;

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_y_lanes = detail::make_pack<Real>(c9, c16) * w8_y_lanes -
      detail::make_pack<Real>(s9, s16) * w8_z_lanes;

  // link 6 (chest3), outward
  const Real a6_x_p2 = a5_y + 0.072 * (w5_x * w5_x + w5_z * w5_z);
  const Real a6_z = a5_x - 0.072 * (minus_wd5_z - w5_x * minus_w5_y);

  // link 9 (left_upperarm), outward
  const Lanes<2> w9_x_lanes = detail::make_pack<Real>(s9, s16) * w8_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_z_lanes;
  const Lanes<2> w9_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_x_lanes;

  // link 3 (hip), pose
  const Real bias_3_p1 = a3_x_p2 * c1 - a3_y_p1 * s1;
  const Real bias_3_p2 = a3_y_p1 * c1 + a3_x_p2 * s1;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p7 = a6_z - 0.226 * (w6_x * w6_z - wd6_y);

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_z_lanes = w9_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);

  // link 5 (chest2), pose
  const Real bias_3_p3 = c4 * bias_3_p1;
  const Real bias_3_p4 = s4 * bias_3_p1;

  // link 6 (chest3), outward
  const Real a6_x = c6 * a6_x_p2 - s6 * a6_x_p1;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_y_lanes = detail::make_pack<Real>(c8, c15) * wd6_y -
      detail::make_pack<Real>(s8, s15) * wd7_y_lanes - w8_x_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_p8_lanes = a7_y_p7 + detail::make_pack<Real>(0.18, (-0.18)) * a7_y_p4;

  // link 6 (chest3), outward
  const Real minus_a6_y = s6 * a6_x_p2 + c6 * a6_x_p1;

  // link 8 (left_shoulder2), outward
  const Lanes<2> wd8_x_lanes = detail::make_pack<Real>(c8, c15) * wd7_y_lanes +
      detail::make_pack<Real>(s8, s15) * wd6_y + w8_y_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_w10_y_lanes = detail::make_pack<Real>(s10, s17) * w9_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_z_lanes;

  // link 7 (left_shoulder1), outward
  const Real a7_y_p9 = a6_x + 0.226 * (w6_y * w6_y + a7_y_p1);
  const Real minus_a7_z_p3 = minus_a6_y + 0.226 * (a7_y_p2 + wd5_x);
  const Lanes<2> a7_y_p11_lanes = a7_y_p9 + detail::make_pack<Real>(0.18, (-0.18)) * a7_y_p3;

  // link 10 (left_lowerarm), outward
  const Lanes<2> w10_x_lanes = detail::make_pack<Real>(c10, c17) * w9_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_z_lanes;

  // link 5 (chest2), pose
  const Real bias_3_p5 = s5 * bias_3_p3 + c5 * bias_3_p2;

  // link 7 (left_shoulder1), outward
  const Lanes<2> minus_a7_z_lanes = minus_a7_z_p3 + detail::make_pack<Real>(0.18, (-0.18)) *
      minus_a7_z_p1;

  // link 5 (chest2), pose
  const Real bias_3_p6 = c5 * bias_3_p3 - s5 * bias_3_p2;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_z_lanes = minus_w10_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);

  // link 9 (left_upperarm), outward
  const Lanes<2> wd9_x_lanes = detail::make_pack<Real>(s9, s16) * wd8_y_lanes +
      detail::make_pack<Real>(c9, c16) * wd7_x_lanes + w9_y_lanes *
      detail::make_pack<Real>(qd[8], qd[15]);
  const Lanes<2> wd9_y_lanes = detail::make_pack<Real>(c9, c16) * wd8_y_lanes -
      detail::make_pack<Real>(s9, s16) * wd7_x_lanes - w9_x_lanes *
      detail::make_pack<Real>(qd[8], qd[15]);

  // link 7 (left_shoulder1), outward
  const Lanes<2> a7_y_lanes = detail::make_pack<Real>(c7, c14) * a7_y_p11_lanes -
      detail::make_pack<Real>(s7, s14) * a7_y_p8_lanes;
  const Lanes<2> a7_x_lanes = detail::make_pack<Real>(s7, s14) * a7_y_p11_lanes +
      detail::make_pack<Real>(c7, c14) * a7_y_p8_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_y_lanes = detail::make_pack<Real>(c11, c18) * w10_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_x_lanes;

  // link 6 (chest3), pose
  const Real bias_3_p9 = c6 * bias_3_p5 + s6 * bias_3_p4;
  const Real bias_3_p10 = s6 * bias_3_p5 - c6 * bias_3_p4;

  // link 11 (left_wrist1), outward
  const Lanes<2> w11_x_lanes = detail::make_pack<Real>(c11, c18) * w10_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_z_lanes;

  // link 5 (chest2), pose
  const Real bias_1_p1 = s5 * s4;

  // link 8 (left_shoulder2), outward
  const Lanes<2> minus_a8_y_lanes = detail::make_pack<Real>(s8, s15) * a7_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_x_lanes = detail::make_pack<Real>(c10, c17) * wd9_x_lanes +
      detail::make_pack<Real>(s10, s17) * wd8_x_lanes - minus_w10_y_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);

  // link 8 (left_shoulder2), outward
  const Lanes<2> a8_x_lanes = detail::make_pack<Real>(c8, c15) * a7_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_z_lanes;

  // link 7 (left_shoulder1), pose
  const Lanes<2> bias_3_p15_lanes = detail::make_pack<Real>(c7, c14) * bias_3_p9 +
      detail::make_pack<Real>(s7, s14) * bias_3_p6;
  const Lanes<2> bias_3_p16_lanes = detail::make_pack<Real>(c7, c14) * bias_3_p6 -
      detail::make_pack<Real>(s7, s14) * bias_3_p9;

  // link 5 (chest2), pose
  const Real bias_1_p2 = c5 * s4;

  // link 10 (left_lowerarm), outward
  const Lanes<2> wd10_y_lanes = detail::make_pack<Real>(c10, c17) * wd8_x_lanes -
      detail::make_pack<Real>(s10, s17) * wd9_x_lanes - w10_x_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);
  const Lanes<2> a10_x_p8_lanes = 0.282 * (w9_x_lanes * w9_x_lanes + w9_y_lanes * w9_y_lanes) -
      a8_x_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_w12_y_lanes = detail::make_pack<Real>(s12, s19) * w11_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_z_lanes;
  const Lanes<2> w12_x_lanes = detail::make_pack<Real>(c12, c19) * w11_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_z_lanes;

  // link 6 (chest3), pose
  const Real bias_1_p5 = s6 * c4 - c6 * bias_1_p1;
  const Real bias_1_p6 = s6 * bias_1_p1 + c6 * c4;

  // link 9 (left_upperarm), outward
  const Lanes<2> a9_x_lanes = detail::make_pack<Real>(c9, c16) * a7_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_y_lanes;

  // link 8 (left_shoulder2), pose
  const Lanes<2> bias_3_p20_lanes = detail::make_pack<Real>(s8, s15) * bias_3_p15_lanes +
      detail::make_pack<Real>(c8, c15) * bias_3_p10;

  // link 9 (left_upperarm), outward
  const Lanes<2> minus_a9_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_x_lanes;

  // link 8 (left_shoulder2), pose
  const Lanes<2> bias_3_p21_lanes = detail::make_pack<Real>(s8, s15) * bias_3_p10 -
      detail::make_pack<Real>(c8, c15) * bias_3_p15_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_p10_lanes = a9_x_lanes - 0.282 * (w9_x_lanes * w9_z_lanes + wd9_y_lanes);

  // link 5 (chest2), pose
  const Real bias_2_p1 = c4 * bias_3_p2;

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_x_lanes = detail::make_pack<Real>(c11, c18) * wd10_x_lanes +
      detail::make_pack<Real>(s11, s18) * wd9_y_lanes + w11_y_lanes *
      detail::make_pack<Real>(qd[10], qd[17]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a10_z_lanes = minus_a9_y_lanes + 0.282 *
      (w9_y_lanes * w9_z_lanes - wd9_x_lanes);

  // link 11 (left_wrist1), outward
  const Lanes<2> wd11_y_lanes = detail::make_pack<Real>(c11, c18) * wd9_y_lanes -
      detail::make_pack<Real>(s11, s18) * wd10_x_lanes - w11_x_lanes *
      detail::make_pack<Real>(qd[10], qd[17]);

  // link 5 (chest2), pose
  const Real bias_2_p2 = s4 * bias_3_p2;

  // link 7 (left_shoulder1), pose
  const Lanes<2> bias_1_p11_lanes = detail::make_pack<Real>(c7, c14) * bias_1_p5 -
      detail::make_pack<Real>(s7, s14) * bias_1_p2;
  const Lanes<2> bias_1_p12_lanes = detail::make_pack<Real>(s7, s14) * bias_1_p5 +
      detail::make_pack<Real>(c7, c14) * bias_1_p2;

  // link 9 (left_upperarm), pose
  const Lanes<2> bias_3_p26_lanes = detail::make_pack<Real>(s9, s16) * bias_3_p20_lanes +
      detail::make_pack<Real>(c9, c16) * bias_3_p16_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> w12_z_lanes = w11_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);

  // link 13 (left_hand), outward
  const Lanes<2> w13_z_lanes = w12_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);

  // link 10 (left_lowerarm), outward
  const Lanes<2> a10_x_lanes = detail::make_pack<Real>(c10, c17) * a10_x_p10_lanes -
      detail::make_pack<Real>(s10, s17) * a10_x_p8_lanes;

  // link 5 (chest2), pose
  const Real bias_2_p3 = s5 * bias_2_p1 - c5 * bias_3_p1;
  const Real bias_2_p4 = s5 * bias_3_p1 + c5 * bias_2_p1;

  // link 8 (left_shoulder2), pose
  const Lanes<2> bias_1_p17_lanes = detail::make_pack<Real>(c8, c15) * bias_1_p6 -
      detail::make_pack<Real>(s8, s15) * bias_1_p11_lanes;
  const Lanes<2> bias_1_p18_lanes = detail::make_pack<Real>(c8, c15) * bias_1_p11_lanes +
      detail::make_pack<Real>(s8, s15) * bias_1_p6;

  // link 12 (left_wrist2), outward
  const Lanes<2> bias_0_p3_lanes = minus_w12_y_lanes * w12_z_lanes;

  // link 13 (left_hand), outward
  const Lanes<2> bias_0_p5_lanes = w13_z_lanes * w13_z_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> bias_3_p28_lanes = detail::make_pack<Real>(c9, c16) * bias_3_p20_lanes -
      detail::make_pack<Real>(s9, s16) * bias_3_p16_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<2> bias_3_p29_lanes = detail::make_pack<Real>(c10, c17) * bias_3_p26_lanes +
      detail::make_pack<Real>(s10, s17) * bias_3_p21_lanes;

  // link 6 (chest3), pose
  const Real bias_2_p7 = c6 * bias_2_p3 + s6 * bias_2_p2;
  const Real bias_2_p8 = c6 * bias_2_p2 - s6 * bias_2_p3;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_x_lanes = detail::make_pack<Real>(c12, c19) * wd11_x_lanes +
      detail::make_pack<Real>(s12, s19) * wd10_y_lanes - minus_w12_y_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);

  // link 11 (left_wrist1), outward
  const Lanes<2> a11_x_lanes = detail::make_pack<Real>(c11, c18) * a10_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_z_lanes;

  // link 10 (left_lowerarm), outward
  const Lanes<2> minus_a10_y_lanes = detail::make_pack<Real>(s10, s17) * a10_x_p10_lanes +
      detail::make_pack<Real>(c10, c17) * a10_x_p8_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> wd12_y_lanes = detail::make_pack<Real>(c12, c19) * wd10_y_lanes -
      detail::make_pack<Real>(s12, s19) * wd11_x_lanes - w12_x_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);

  // link 9 (left_upperarm), pose
  const Lanes<2> bias_1_p22_lanes = detail::make_pack<Real>(s9, s16) * bias_1_p17_lanes +
      detail::make_pack<Real>(c9, c16) * bias_1_p12_lanes;
  const Lanes<2> bias_1_p23_lanes = detail::make_pack<Real>(c9, c16) * bias_1_p17_lanes -
      detail::make_pack<Real>(s9, s16) * bias_1_p12_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p8_lanes = a11_x_lanes - 0.269 *
      (w11_x_lanes * w11_z_lanes + wd11_y_lanes);

  // link 7 (left_shoulder1), pose
  const Lanes<2> bias_2_p13_lanes = detail::make_pack<Real>(c7, c14) * bias_2_p7 +
      detail::make_pack<Real>(s7, s14) * bias_2_p4;
  const Lanes<2> bias_2_p14_lanes = detail::make_pack<Real>(s7, s14) * bias_2_p7 -
      detail::make_pack<Real>(c7, c14) * bias_2_p4;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_y_p9_lanes = minus_a10_y_lanes + 0.269 *
      (w11_x_lanes * w11_x_lanes + w11_y_lanes * w11_y_lanes);

  // link 13 (left_hand), outward
  const Lanes<2> wd13_x_lanes = wd12_y_lanes + w12_z_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> wd13_y_lanes = wd11_y_lanes + minus_w12_y_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);

  // link 10 (left_lowerarm), pose
  const Lanes<2> bias_1_p28_lanes = detail::make_pack<Real>(c10, c17) * bias_1_p22_lanes +
      detail::make_pack<Real>(s10, s17) * bias_1_p18_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> bias_3_p34_lanes = detail::make_pack<Real>(c11, c18) * bias_3_p29_lanes +
      detail::make_pack<Real>(s11, s18) * bias_3_p28_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<2> bias_3_p35_lanes = detail::make_pack<Real>(c10, c17) * bias_3_p21_lanes -
      detail::make_pack<Real>(s10, s17) * bias_3_p26_lanes;
  const Lanes<2> bias_1_p30_lanes = detail::make_pack<Real>(c10, c17) * bias_1_p18_lanes -
      detail::make_pack<Real>(s10, s17) * bias_1_p22_lanes;

  // link 11 (left_wrist1), outward
  const Lanes<2> minus_a11_y_lanes = detail::make_pack<Real>(s11, s18) * a10_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_z_lanes;

  // link 8 (left_shoulder2), pose
  const Lanes<2> bias_2_p19_lanes = detail::make_pack<Real>(c8, c15) * bias_2_p8 -
      detail::make_pack<Real>(s8, s15) * bias_2_p13_lanes;
  const Lanes<2> bias_2_p20_lanes = detail::make_pack<Real>(c8, c15) * bias_2_p13_lanes +
      detail::make_pack<Real>(s8, s15) * bias_2_p8;

  // link 24 (right_eye), outward
  const Lanes<2> bias_0_p20_lanes = (minus_w12_y_lanes * w13_z_lanes + wd13_y_lanes) *
      bias_0_p1_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> bias_1_p31_lanes = detail::make_pack<Real>(c11, c18) * bias_1_p28_lanes +
      detail::make_pack<Real>(s11, s18) * bias_1_p23_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> bias_0_p21_lanes = (wd12_x_lanes - bias_0_p3_lanes) * bias_0_p1_lanes -
      (minus_w12_y_lanes * minus_w12_y_lanes + bias_0_p5_lanes) * bias_0_p2_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> minus_a12_z_lanes = minus_a11_y_lanes + 0.269 *
      (w11_y_lanes * w11_z_lanes - wd11_x_lanes);
  const Lanes<2> minus_a12_y_lanes = detail::make_pack<Real>(s12, s19) * minus_a12_y_p8_lanes +
      detail::make_pack<Real>(c12, c19) * minus_a12_y_p9_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> bias_0_p22_lanes = (w12_z_lanes * w12_z_lanes + bias_0_p5_lanes) *
      bias_0_p1_lanes + (bias_0_p3_lanes + wd12_x_lanes) * bias_0_p2_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> bias_3_p42_lanes = detail::make_pack<Real>(c11, c18) * bias_3_p28_lanes -
      detail::make_pack<Real>(s11, s18) * bias_3_p29_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> bias_3_p43_lanes = detail::make_pack<Real>(c12, c19) * bias_3_p35_lanes -
      detail::make_pack<Real>(s12, s19) * bias_3_p34_lanes;

  // link 12 (left_wrist2), outward
  const Lanes<2> a12_x_lanes = detail::make_pack<Real>(c12, c19) * minus_a12_y_p8_lanes -
      detail::make_pack<Real>(s12, s19) * minus_a12_y_p9_lanes;

  // link 9 (left_upperarm), pose
  const Lanes<2> bias_2_p25_lanes = detail::make_pack<Real>(s9, s16) * bias_2_p19_lanes +
      detail::make_pack<Real>(c9, c16) * bias_2_p14_lanes;
  const Lanes<2> bias_2_p26_lanes = detail::make_pack<Real>(c9, c16) * bias_2_p19_lanes -
      detail::make_pack<Real>(s9, s16) * bias_2_p14_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> bias_0_p23_lanes = bias_0_p21_lanes - minus_a12_z_lanes;
  const Lanes<2> bias_0_p24_lanes = minus_a12_y_lanes + bias_0_p22_lanes;

  // link 11 (left_wrist1), pose
  const Lanes<2> bias_1_p38_lanes = detail::make_pack<Real>(c11, c18) * bias_1_p23_lanes -
      detail::make_pack<Real>(s11, s18) * bias_1_p28_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> bias_1_p39_lanes = detail::make_pack<Real>(c12, c19) * bias_1_p30_lanes -
      detail::make_pack<Real>(s12, s19) * bias_1_p31_lanes;
  const Lanes<2> bias_3_p44_lanes = detail::make_pack<Real>(c12, c19) * bias_3_p34_lanes +
      detail::make_pack<Real>(s12, s19) * bias_3_p35_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> bias_0_p28_lanes = a12_x_lanes + ((w12_z_lanes * w13_z_lanes + wd13_x_lanes) *
      bias_0_p2_lanes - bias_0_p20_lanes);

  // link 12 (left_wrist2), pose
  const Lanes<2> bias_1_p42_lanes = detail::make_pack<Real>(c12, c19) * bias_1_p31_lanes +
      detail::make_pack<Real>(s12, s19) * bias_1_p30_lanes;

  // link 10 (left_lowerarm), pose
  const Lanes<2> bias_2_p31_lanes = detail::make_pack<Real>(c10, c17) * bias_2_p25_lanes +
      detail::make_pack<Real>(s10, s17) * bias_2_p20_lanes;
  const Lanes<2> bias_2_p32_lanes = detail::make_pack<Real>(c10, c17) * bias_2_p20_lanes -
      detail::make_pack<Real>(s10, s17) * bias_2_p25_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> bias_0_lanes = bias_3_p42_lanes * bias_0_p23_lanes - bias_3_p43_lanes *
      bias_0_p24_lanes + bias_3_p44_lanes * bias_0_p28_lanes;
  bias[0] = bias_0_lanes[0];
  bias[6] = bias_0_lanes[1];
  const Lanes<2> bias_3_lanes = bias_3_p43_lanes * wd13_x_lanes + bias_3_p42_lanes * wd13_y_lanes +
      bias_3_p44_lanes * wd12_x_lanes;
  bias[3] = bias_3_lanes[0];
  bias[9] = bias_3_lanes[1];
  const Lanes<2> bias_1_lanes = bias_1_p38_lanes * bias_0_p23_lanes - bias_1_p39_lanes *
      bias_0_p24_lanes + bias_1_p42_lanes * bias_0_p28_lanes;
  bias[1] = bias_1_lanes[0];
  bias[7] = bias_1_lanes[1];
  const Lanes<2> bias_4_lanes = bias_1_p39_lanes * wd13_x_lanes + bias_1_p38_lanes * wd13_y_lanes +
      bias_1_p42_lanes * wd12_x_lanes;
  bias[4] = bias_4_lanes[0];
  bias[10] = bias_4_lanes[1];

  // link 11 (left_wrist1), pose
  const Lanes<2> bias_2_p37_lanes = detail::make_pack<Real>(c11, c18) * bias_2_p31_lanes +
      detail::make_pack<Real>(s11, s18) * bias_2_p26_lanes;
  const Lanes<2> bias_2_p38_lanes = detail::make_pack<Real>(c11, c18) * bias_2_p26_lanes -
      detail::make_pack<Real>(s11, s18) * bias_2_p31_lanes;

  // link 12 (left_wrist2), pose
  const Lanes<2> bias_2_p42_lanes = detail::make_pack<Real>(c12, c19) * bias_2_p32_lanes -
      detail::make_pack<Real>(s12, s19) * bias_2_p37_lanes;
  const Lanes<2> bias_2_p43_lanes = detail::make_pack<Real>(c12, c19) * bias_2_p37_lanes +
      detail::make_pack<Real>(s12, s19) * bias_2_p32_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> bias_2_lanes = bias_2_p38_lanes * bias_0_p23_lanes - bias_2_p42_lanes *
      bias_0_p24_lanes + bias_2_p43_lanes * bias_0_p28_lanes;
  bias[2] = bias_2_lanes[0];
  bias[8] = bias_2_lanes[1];
  const Lanes<2> bias_5_lanes = bias_2_p42_lanes * wd13_x_lanes + bias_2_p38_lanes * wd13_y_lanes +
      bias_2_p43_lanes * wd12_x_lanes;
  bias[5] = bias_5_lanes[0];
  bias[11] = bias_5_lanes[1];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
