// SPDX-License-Identifier: 0BSD
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
  // constants; sines and cosines
  const Real minus_link2_to_3_y = 0.422;
  const Real minus_link1_to_2_y = 0.434;
  const Real link4_to_5_z = 0.21799999999999997;
  const Real minus_link5_to_6_y = 0.072;
  const Real angles[20] = {q[10], q[8], q[7], q[6], q[5], q[4], q[3], q[1], q[2], q[0], q[9], q[11],
      q[12], q[17], q[15], q[14], q[13], q[16], q[18], q[19]};

  // sines and cosines
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

  // links 2 to 5, outward
  const Real w2_z = qd[0] + qd[1];
  const Lanes<2> t1_lanes = 0.086 * detail::make_pack<Real>(c13, c20);
  const Real w3_z = w2_z + qd[2];
  const Real t2 = s4 * w3_z;
  const Real wd4_x = w3_z * qd[3];

  // link 5 (chest2), outward
  const Real t3 = c4 * wd4_x;
  const Real w5_z = c4 * w3_z + qd[4];
  const Real minus_wd5_z = s4 * wd4_x;
  const Lanes<2> t4_lanes = 0.086 * detail::make_pack<Real>(s13, s20);
  const Real w5_x = c5 * t2 - s5 * qd[3];
  const Real minus_w5_y = s5 * t2 + c5 * qd[3];

  // links 2 and 3, 6, outward
  const Real t5 = minus_link2_to_3_y * (w2_z * w2_z);
  const Real s2_plus_3 = s2 * c3 + c2 * s3;
  const Real c2_plus_3 = c2 * c3 - s2 * s3;
  const Real a2_y = minus_link1_to_2_y * (qd[0] * qd[0]);
  const Real w6_z = w5_x + qd[5];
  const Real t6 = t5 * s2;

  // links 3, 5 and 6, outward
  const Real minus_wd5_y = s5 * t3 + w5_x * qd[4];
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real wd5_x = c5 * t3 - minus_w5_y * qd[4];
  const Real t9 = a2_y + t5 * c2;

  // links 6 and 7, 14, outward
  const Lanes<2> w7_14_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);
  const Real t13 = w6_z * w6_z;
  const Real t14 = w6_x * w6_y;
  const Lanes<2> w7_14_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;
  const Lanes<2> w7_14_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;

  // links 3, 5 and 6, outward
  const Real a3_x = s2_plus_3 * t9 - c2_plus_3 * t6;
  const Real a3_y = s2_plus_3 * t6 + c2_plus_3 * t9;
  const Real wd6_x = w6_y * qd[5] - (c6 * minus_wd5_y + s6 * minus_wd5_z);
  const Real wd6_y = s6 * minus_wd5_y - c6 * minus_wd5_z - w6_x * qd[5];
  const Real t21 = t14 - wd5_x;
  const Real t22 = c4 * a3_x;
  const Real t23 = a3_y + link4_to_5_z * (w3_z * w3_z);
  const Real minus_a5_z = s4 * a3_x;

  // links 6, 8, 15, outward
  const Real t28 = w6_y * w6_z + wd6_x;
  const Lanes<2> w8_15_z_lanes = w7_14_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);
  const Lanes<2> w8_15_x_lanes = detail::make_pack<Real>(c8, c15) * w7_14_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_14_z_lanes;
  const Lanes<2> w8_15_y_lanes = detail::make_pack<Real>(c8, c15) * w7_14_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_14_y_lanes;
  const Real t29 = minus_a5_z + minus_link5_to_6_y * (wd5_x - minus_w5_y * w5_z);

  // links 5 to 7, 14, outward
  const Real a5_y = c5 * t23 - s5 * t22;
  const Lanes<2> wd7_14_y_lanes = detail::make_pack<Real>(c7, c14) * wd6_x -
      detail::make_pack<Real>(s7, s14) * wd5_x - w7_14_x_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);
  const Real a5_x = c5 * t22 + s5 * t23;
  const Lanes<2> wd7_14_x_lanes = detail::make_pack<Real>(s7, s14) * wd6_x +
      detail::make_pack<Real>(c7, c14) * wd5_x + w7_14_y_lanes *
      detail::make_pack<Real>(qd[6], qd[13]);
  const Real t39 = w6_x * w6_x + t13;

  // links 6, 9, 16, outward
  const Lanes<2> w9_16_y_lanes = detail::make_pack<Real>(c9, c16) * w8_15_y_lanes -
      detail::make_pack<Real>(s9, s16) * w8_15_z_lanes;
  const Real t42 = a5_y + minus_link5_to_6_y * (w5_x * w5_x + w5_z * w5_z);
  const Real a6_z = a5_x - minus_link5_to_6_y * (minus_wd5_z - w5_x * minus_w5_y);
  const Lanes<2> w9_16_x_lanes = detail::make_pack<Real>(s9, s16) * w8_15_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_15_z_lanes;
  const Lanes<2> w9_16_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_15_x_lanes;

  // links 3 (hip) and 5 (chest2), pose; links 7, 10, 17, outward
  const Real c1_plus_2_plus_3 = c2_plus_3 * c1 - s2_plus_3 * s1;
  const Real s1_plus_2_plus_3 = s2_plus_3 * c1 + c2_plus_3 * s1;
  const Real t51 = a6_z - 0.226 * (w6_x * w6_z - wd6_y);
  const Lanes<2> w10_17_z_lanes = w9_16_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);
  const Real t56 = c4 * c1_plus_2_plus_3;
  const Real t57 = s4 * c1_plus_2_plus_3;

  // links 6 to 8, 14 and 15, outward
  const Real a6_x = c6 * t42 - s6 * t29;
  const Lanes<2> wd8_15_y_lanes = detail::make_pack<Real>(c8, c15) * wd6_y -
      detail::make_pack<Real>(s8, s15) * wd7_14_y_lanes - w8_15_x_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);
  const Lanes<2> t60_lanes = t51 + detail::make_pack<Real>(0.18, (-0.18)) * t28;
  const Real minus_a6_y = s6 * t42 + c6 * t29;
  const Lanes<2> wd8_15_x_lanes = detail::make_pack<Real>(c8, c15) * wd7_14_y_lanes +
      detail::make_pack<Real>(s8, s15) * wd6_y + w8_15_y_lanes *
      detail::make_pack<Real>(qd[7], qd[14]);

  // links 7, 10, 14, 17, outward; link 5 (chest2), pose
  const Lanes<2> minus_w10_17_y_lanes = detail::make_pack<Real>(s10, s17) * w9_16_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_16_z_lanes;
  const Real t65 = a6_x + 0.226 * (w6_y * w6_y + t13);
  const Real t68 = minus_a6_y + 0.226 * (t14 + wd5_x);
  const Lanes<2> t73_lanes = t65 + detail::make_pack<Real>(0.18, (-0.18)) * t21;
  const Lanes<2> w10_17_x_lanes = detail::make_pack<Real>(c10, c17) * w9_16_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_16_z_lanes;
  const Real t76 = s5 * t56 + c5 * s1_plus_2_plus_3;
  const Lanes<2> minus_a7_14_z_lanes = t68 + detail::make_pack<Real>(0.18, (-0.18)) * t39;
  const Real t79 = c5 * t56 - s5 * s1_plus_2_plus_3;

  // links 7, 9, 11, 14, 16, 18, outward
  const Lanes<2> w11_18_z_lanes = minus_w10_17_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);
  const Lanes<2> wd9_16_x_lanes = detail::make_pack<Real>(s9, s16) * wd8_15_y_lanes +
      detail::make_pack<Real>(c9, c16) * wd7_14_x_lanes + w9_16_y_lanes *
      detail::make_pack<Real>(qd[8], qd[15]);
  const Lanes<2> wd9_16_y_lanes = detail::make_pack<Real>(c9, c16) * wd8_15_y_lanes -
      detail::make_pack<Real>(s9, s16) * wd7_14_x_lanes - w9_16_x_lanes *
      detail::make_pack<Real>(qd[8], qd[15]);
  const Lanes<2> a7_14_y_lanes = detail::make_pack<Real>(c7, c14) * t73_lanes -
      detail::make_pack<Real>(s7, s14) * t60_lanes;
  const Lanes<2> a7_14_x_lanes = detail::make_pack<Real>(s7, s14) * t73_lanes +
      detail::make_pack<Real>(c7, c14) * t60_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), outward; links 5 (chest2) and 6 (chest3), pose
  const Lanes<2> w11_18_y_lanes = detail::make_pack<Real>(c11, c18) * w10_17_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_17_x_lanes;
  const Real t94 = c6 * t76 + s6 * t57;
  const Real t95 = s6 * t76 - c6 * t57;
  const Lanes<2> w11_18_x_lanes = detail::make_pack<Real>(c11, c18) * w10_17_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_17_z_lanes;
  const Real t114 = s5 * s4;

  // links 8, 10, 15, 17, outward; links 7 (left_shoulder1) and 14 (right_shoulder1), pose
  const Lanes<2> minus_a8_15_y_lanes = detail::make_pack<Real>(s8, s15) * a7_14_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_14_z_lanes;
  const Lanes<2> wd10_17_x_lanes = detail::make_pack<Real>(c10, c17) * wd9_16_x_lanes +
      detail::make_pack<Real>(s10, s17) * wd8_15_x_lanes - minus_w10_17_y_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);
  const Lanes<2> a8_15_x_lanes = detail::make_pack<Real>(c8, c15) * a7_14_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_14_z_lanes;
  const Lanes<2> t116_lanes = detail::make_pack<Real>(c7, c14) * t94 +
      detail::make_pack<Real>(s7, s14) * t79;
  const Lanes<2> t117_lanes = detail::make_pack<Real>(c7, c14) * t79 -
      detail::make_pack<Real>(s7, s14) * t94;

  // link 5 (chest2), pose; links 10, 12, 17, 19, outward
  const Real t118 = c5 * s4;
  const Lanes<2> wd10_17_y_lanes = detail::make_pack<Real>(c10, c17) * wd8_15_x_lanes -
      detail::make_pack<Real>(s10, s17) * wd9_16_x_lanes - w10_17_x_lanes *
      detail::make_pack<Real>(qd[9], qd[16]);
  const Lanes<2> t126_lanes = 0.282 * (w9_16_x_lanes * w9_16_x_lanes + w9_16_y_lanes *
      w9_16_y_lanes) - a8_15_x_lanes;
  const Lanes<2> minus_w12_19_y_lanes = detail::make_pack<Real>(s12, s19) * w11_18_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_18_z_lanes;
  const Lanes<2> w12_19_x_lanes = detail::make_pack<Real>(c12, c19) * w11_18_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_18_z_lanes;

  // links 6, 8, 15, pose; links 9 (left_upperarm) and 16 (right_upperarm), outward
  const Real t135 = s6 * c4 - c6 * t114;
  const Real t136 = s6 * t114 + c6 * c4;
  const Lanes<2> a9_16_x_lanes = detail::make_pack<Real>(c9, c16) * a7_14_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_15_y_lanes;
  const Lanes<2> t138_lanes = detail::make_pack<Real>(s8, s15) * t116_lanes +
      detail::make_pack<Real>(c8, c15) * t95;
  const Lanes<2> minus_a9_16_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_15_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_14_x_lanes;
  const Lanes<2> t141_lanes = detail::make_pack<Real>(s8, s15) * t95 -
      detail::make_pack<Real>(c8, c15) * t116_lanes;

  // links 10 and 11, 17 and 18, outward; link 5 (chest2), pose
  const Lanes<2> t148_lanes = a9_16_x_lanes - 0.282 *
      (w9_16_x_lanes * w9_16_z_lanes + wd9_16_y_lanes);
  const Real t151 = c4 * s1_plus_2_plus_3;
  const Lanes<2> wd11_18_x_lanes = detail::make_pack<Real>(c11, c18) * wd10_17_x_lanes +
      detail::make_pack<Real>(s11, s18) * wd9_16_y_lanes + w11_18_y_lanes *
      detail::make_pack<Real>(qd[10], qd[17]);
  const Lanes<2> minus_a10_17_z_lanes = minus_a9_16_y_lanes + 0.282 *
      (w9_16_y_lanes * w9_16_z_lanes - wd9_16_x_lanes);
  const Lanes<2> wd11_18_y_lanes = detail::make_pack<Real>(c11, c18) * wd9_16_y_lanes -
      detail::make_pack<Real>(s11, s18) * wd10_17_x_lanes - w11_18_x_lanes *
      detail::make_pack<Real>(qd[10], qd[17]);
  const Real t152 = s4 * s1_plus_2_plus_3;

  // links 7, 9, 14, 16, pose; links 12 and 13, 19 and 20, outward
  const Lanes<2> t156_lanes = detail::make_pack<Real>(c7, c14) * t135 -
      detail::make_pack<Real>(s7, s14) * t118;
  const Lanes<2> t157_lanes = detail::make_pack<Real>(s7, s14) * t135 +
      detail::make_pack<Real>(c7, c14) * t118;
  const Lanes<2> t160_lanes = detail::make_pack<Real>(s9, s16) * t138_lanes +
      detail::make_pack<Real>(c9, c16) * t117_lanes;
  const Lanes<2> w12_19_z_lanes = w11_18_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);
  const Lanes<2> w13_20_z_lanes = w12_19_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);

  // links 10, 12, 17, 19, outward; links 5, 8, 15, pose
  const Lanes<2> a10_17_x_lanes = detail::make_pack<Real>(c10, c17) * t148_lanes -
      detail::make_pack<Real>(s10, s17) * t126_lanes;
  const Real t169 = s5 * t151 - c5 * c1_plus_2_plus_3;
  const Real t170 = s5 * c1_plus_2_plus_3 + c5 * t151;
  const Lanes<2> t177_lanes = detail::make_pack<Real>(c8, c15) * t136 -
      detail::make_pack<Real>(s8, s15) * t156_lanes;
  const Lanes<2> t178_lanes = detail::make_pack<Real>(c8, c15) * t156_lanes +
      detail::make_pack<Real>(s8, s15) * t136;
  const Lanes<2> t179_lanes = minus_w12_19_y_lanes * w12_19_z_lanes;

  // links 13 (left_hand) and 20 (right_hand), outward; links 6, 9 and 10, 16 and 17, pose
  const Lanes<2> t183_lanes = w13_20_z_lanes * w13_20_z_lanes;
  const Lanes<2> t185_lanes = detail::make_pack<Real>(c9, c16) * t138_lanes -
      detail::make_pack<Real>(s9, s16) * t117_lanes;
  const Lanes<2> t186_lanes = detail::make_pack<Real>(c10, c17) * t160_lanes +
      detail::make_pack<Real>(s10, s17) * t141_lanes;
  const Real t195 = c6 * t169 + s6 * t152;
  const Real t196 = c6 * t152 - s6 * t169;

  // links 10 to 12, 17 to 19, outward; links 9 (left_upperarm) and 16 (right_upperarm), pose
  const Lanes<2> wd12_19_x_lanes = detail::make_pack<Real>(c12, c19) * wd11_18_x_lanes +
      detail::make_pack<Real>(s12, s19) * wd10_17_y_lanes - minus_w12_19_y_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);
  const Lanes<2> a11_18_x_lanes = detail::make_pack<Real>(c11, c18) * a10_17_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_17_z_lanes;
  const Lanes<2> minus_a10_17_y_lanes = detail::make_pack<Real>(s10, s17) * t148_lanes +
      detail::make_pack<Real>(c10, c17) * t126_lanes;
  const Lanes<2> wd12_19_y_lanes = detail::make_pack<Real>(c12, c19) * wd10_17_y_lanes -
      detail::make_pack<Real>(s12, s19) * wd11_18_x_lanes - w12_19_x_lanes *
      detail::make_pack<Real>(qd[11], qd[18]);
  const Lanes<2> t199_lanes = detail::make_pack<Real>(s9, s16) * t177_lanes +
      detail::make_pack<Real>(c9, c16) * t157_lanes;
  const Lanes<2> t200_lanes = detail::make_pack<Real>(c9, c16) * t177_lanes -
      detail::make_pack<Real>(s9, s16) * t157_lanes;

  // links 12 and 13, 19 and 20, outward; links 7 (left_shoulder1) and 14 (right_shoulder1), pose
  const Lanes<2> t218_lanes = a11_18_x_lanes - 0.269 *
      (w11_18_x_lanes * w11_18_z_lanes + wd11_18_y_lanes);
  const Lanes<2> t219_lanes = detail::make_pack<Real>(c7, c14) * t195 +
      detail::make_pack<Real>(s7, s14) * t170;
  const Lanes<2> t220_lanes = detail::make_pack<Real>(s7, s14) * t195 -
      detail::make_pack<Real>(c7, c14) * t170;
  const Lanes<2> t221_lanes = minus_a10_17_y_lanes + 0.269 *
      (w11_18_x_lanes * w11_18_x_lanes + w11_18_y_lanes * w11_18_y_lanes);
  const Lanes<2> wd13_20_x_lanes = wd12_19_y_lanes + w12_19_z_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> wd13_20_y_lanes = wd11_18_y_lanes + minus_w12_19_y_lanes *
      detail::make_pack<Real>(qd[12], qd[19]);

  // links 10 and 11, 17 and 18, pose; links 11 (left_wrist1) and 18 (right_wrist1), outward
  const Lanes<2> t225_lanes = detail::make_pack<Real>(c10, c17) * t199_lanes +
      detail::make_pack<Real>(s10, s17) * t178_lanes;
  const Lanes<2> t236_lanes = detail::make_pack<Real>(c11, c18) * t186_lanes +
      detail::make_pack<Real>(s11, s18) * t185_lanes;
  const Lanes<2> t238_lanes = detail::make_pack<Real>(c10, c17) * t141_lanes -
      detail::make_pack<Real>(s10, s17) * t160_lanes;
  const Lanes<2> t241_lanes = detail::make_pack<Real>(c10, c17) * t178_lanes -
      detail::make_pack<Real>(s10, s17) * t199_lanes;
  const Lanes<2> minus_a11_18_y_lanes = detail::make_pack<Real>(s11, s18) * a10_17_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_17_z_lanes;

  // links 8, 11, 15, 18, pose; link 24 (right_eye), outward
  const Lanes<2> t244_lanes = detail::make_pack<Real>(c8, c15) * t196 -
      detail::make_pack<Real>(s8, s15) * t219_lanes;
  const Lanes<2> t245_lanes = detail::make_pack<Real>(c8, c15) * t219_lanes +
      detail::make_pack<Real>(s8, s15) * t196;
  const Lanes<2> t251_lanes = (minus_w12_19_y_lanes * w13_20_z_lanes + wd13_20_y_lanes) * t1_lanes;
  const Lanes<2> t252_lanes = detail::make_pack<Real>(c11, c18) * t225_lanes +
      detail::make_pack<Real>(s11, s18) * t200_lanes;
  const Lanes<2> t260_lanes = (wd12_19_x_lanes - t179_lanes) * t1_lanes -
      (minus_w12_19_y_lanes * minus_w12_19_y_lanes + t183_lanes) * t4_lanes;

  // links 12, 19, 24, outward; links 11 and 12, 18 and 19, pose
  const Lanes<2> minus_a12_19_z_lanes = minus_a11_18_y_lanes + 0.269 *
      (w11_18_y_lanes * w11_18_z_lanes - wd11_18_x_lanes);
  const Lanes<2> minus_a12_19_y_lanes = detail::make_pack<Real>(s12, s19) * t218_lanes +
      detail::make_pack<Real>(c12, c19) * t221_lanes;
  const Lanes<2> t261_lanes = (w12_19_z_lanes * w12_19_z_lanes + t183_lanes) * t1_lanes +
      (t179_lanes + wd12_19_x_lanes) * t4_lanes;
  const Lanes<2> t267_lanes = detail::make_pack<Real>(c11, c18) * t185_lanes -
      detail::make_pack<Real>(s11, s18) * t186_lanes;
  const Lanes<2> t268_lanes = detail::make_pack<Real>(c12, c19) * t238_lanes -
      detail::make_pack<Real>(s12, s19) * t236_lanes;
  const Lanes<2> a12_19_x_lanes = detail::make_pack<Real>(c12, c19) * t218_lanes -
      detail::make_pack<Real>(s12, s19) * t221_lanes;

  // links 9, 11, 16, 18, pose; link 24 (right_eye), outward
  const Lanes<2> t269_lanes = detail::make_pack<Real>(s9, s16) * t244_lanes +
      detail::make_pack<Real>(c9, c16) * t220_lanes;
  const Lanes<2> t270_lanes = detail::make_pack<Real>(c9, c16) * t244_lanes -
      detail::make_pack<Real>(s9, s16) * t220_lanes;
  const Lanes<2> t271_lanes = t260_lanes - minus_a12_19_z_lanes;
  const Lanes<2> t272_lanes = minus_a12_19_y_lanes + t261_lanes;
  const Lanes<2> t274_lanes = detail::make_pack<Real>(c11, c18) * t200_lanes -
      detail::make_pack<Real>(s11, s18) * t225_lanes;

  // links 10, 12, 17, 19, pose; link 24 (right_eye), outward
  const Lanes<2> t275_lanes = detail::make_pack<Real>(c12, c19) * t241_lanes -
      detail::make_pack<Real>(s12, s19) * t252_lanes;
  const Lanes<2> t276_lanes = detail::make_pack<Real>(c12, c19) * t236_lanes +
      detail::make_pack<Real>(s12, s19) * t238_lanes;
  const Lanes<2> t285_lanes = a12_19_x_lanes + ((w12_19_z_lanes * w13_20_z_lanes +
      wd13_20_x_lanes) * t4_lanes - t251_lanes);
  const Lanes<2> t288_lanes = detail::make_pack<Real>(c12, c19) * t252_lanes +
      detail::make_pack<Real>(s12, s19) * t241_lanes;
  const Lanes<2> t293_lanes = detail::make_pack<Real>(c10, c17) * t269_lanes +
      detail::make_pack<Real>(s10, s17) * t245_lanes;
  const Lanes<2> t294_lanes = detail::make_pack<Real>(c10, c17) * t245_lanes -
      detail::make_pack<Real>(s10, s17) * t269_lanes;

  // link 24 (right_eye), outward
  const Lanes<2> bias_0_6_lanes = t267_lanes * t271_lanes - t268_lanes * t272_lanes + t276_lanes *
      t285_lanes;
  bias[0] = bias_0_6_lanes[0];
  bias[6] = bias_0_6_lanes[1];
  const Lanes<2> bias_3_9_lanes = t268_lanes * wd13_20_x_lanes + t267_lanes * wd13_20_y_lanes +
      t276_lanes * wd12_19_x_lanes;
  bias[3] = bias_3_9_lanes[0];
  bias[9] = bias_3_9_lanes[1];
  const Lanes<2> bias_1_7_lanes = t274_lanes * t271_lanes - t275_lanes * t272_lanes + t288_lanes *
      t285_lanes;
  bias[1] = bias_1_7_lanes[0];
  bias[7] = bias_1_7_lanes[1];
  const Lanes<2> bias_4_10_lanes = t275_lanes * wd13_20_x_lanes + t274_lanes * wd13_20_y_lanes +
      t288_lanes * wd12_19_x_lanes;
  bias[4] = bias_4_10_lanes[0];
  bias[10] = bias_4_10_lanes[1];

  // links 11 and 12, 18 and 19, pose; link 24 (right_eye), outward
  const Lanes<2> t305_lanes = detail::make_pack<Real>(c11, c18) * t293_lanes +
      detail::make_pack<Real>(s11, s18) * t270_lanes;
  const Lanes<2> t306_lanes = detail::make_pack<Real>(c11, c18) * t270_lanes -
      detail::make_pack<Real>(s11, s18) * t293_lanes;
  const Lanes<2> t311_lanes = detail::make_pack<Real>(c12, c19) * t294_lanes -
      detail::make_pack<Real>(s12, s19) * t305_lanes;
  const Lanes<2> t312_lanes = detail::make_pack<Real>(c12, c19) * t305_lanes +
      detail::make_pack<Real>(s12, s19) * t294_lanes;
  const Lanes<2> bias_2_8_lanes = t306_lanes * t271_lanes - t311_lanes * t272_lanes + t312_lanes *
      t285_lanes;

  // link 24 (right_eye), outward
  bias[2] = bias_2_8_lanes[0];
  bias[8] = bias_2_8_lanes[1];
  const Lanes<2> bias_5_11_lanes = t311_lanes * wd13_20_x_lanes + t306_lanes * wd13_20_y_lanes +
      t312_lanes * wd12_19_x_lanes;
  bias[5] = bias_5_11_lanes[0];
  bias[11] = bias_5_11_lanes[1];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
