// SPDX-License-Identifier: 0BSD
// inverse_dynamics: tau = M qdd + b + g - J_ext^T f_ext
// By recursive Newton-Euler, Chang table 4.1, alike limbs in lanes.
// 1939 flops (add 915, mul 1024, div 0), sine and cosine of 24 angles
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
void inverse_dynamics(const Real (&TREELINE_RESTRICT q)[24], const Real (&TREELINE_RESTRICT qd)[24],
    const Real (&TREELINE_RESTRICT qdd)[24], Real (&TREELINE_RESTRICT tau)[24]) noexcept {
  // constants
  const Real minus_link1_to_2_y = 0.434;
  const Real minus_gravity_z = 9.81;
  const Real minus_link2_to_3_y = 0.422;
  const Real link4_to_5_z = 0.21799999999999997;
  const Real minus_link5_to_6_y = 0.072;
  const Real link21_to_22_z = 0.394;
  const Real J_22_xy = 0.0074;
  const Real J_22_xx = 0.05450270000000001;
  const Real minus_h_22_y = 0.43200000000000005;
  const Real J_22_yy = 0.009438624999999999;
  const Real h_22_x = 0.072575;
  const Real J_22_zz = 0.06394132500000001;
  const Real minus_J_21_xz = 0.0016155;
  const Real J_21_xx = 0.005513625;
  const Real J_21_yy = 0.000703125;
  const Real h_21_x = 0.0045000000000000005;
  const Real J_6_zz = 2.06965463592404;
  const Real J_6_xz = 0.0187369177636143;
  const Real minus_h_6_x = 6.1665928899999995;
  const Real J_21_zz = 0.006216750000000001;
  const Real J_6_yy = 1.66923963592404;
  const Real J_6_xx = 0.40041499999999997;
  const Real h_5_x = 0.069699984375;
  const Real minus_h_5_y = 2.2194301519999997;
  const Real J_5_xy = 0.005678398088837119;
  const Real J_5_yy = 0.04675382692737882;
  const Real J_5_xx = 0.15637308509675518;
  const Real J_5_zz = 0.203126912024134;
  const Real minus_h_4_x = 0.0300000063;
  const Real minus_h_3_y = 8.419374554;
  const Real minus_h_3_x = 0.02999999505;
  const Real J_4_xz = 0.005880002159562879;
  const Real J_4_yy = 0.01227760324629517;
  const Real J_4_xx = 0.0478915;
  const Real h_2_x = 0.031999971599999996;
  const Real minus_h_2_y = 24.5839218;
  const Real J_3_zz = 1.7824817919087104;
  const Real J_2_zz = 9.885744550888212;
  const Real J_4_zz = 0.060169103246295166;
  const Real J_1_zz = 13.049859506913753;
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
  const Real s18 = sines[14];
  const Real c18 = cosines[14];
  const Real s19 = sines[15];
  const Real c19 = cosines[15];
  const Real c20 = cosines[16];
  const Real s20 = sines[16];
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

  // links 2 to 4, outward
  const Real w2_z = qd[0] + qd[1];
  const Real wd2_z = qdd[0] + qdd[1];
  const Real w3_z = w2_z + qd[2];
  const Real wd3_z = wd2_z + qdd[2];
  const Real w4_y = c4 * w3_z;

  // links 4 (chest1) and 5 (chest2), outward
  const Real w4_x = s4 * w3_z;
  const Real t3 = s4 * wd3_z;
  const Real t4 = c4 * wd3_z;
  const Real t5 = w4_x * w4_y;
  const Real w5_z = w4_y + qd[4];
  const Real t6 = w4_x * qd[3];
  const Real w5_x = c5 * w4_x - s5 * qd[3];
  const Real t7 = t5 - qdd[3];
  const Real minus_w5_y = s5 * w4_x + c5 * qd[3];
  const Real wd4_y = t4 - t6;
  const Real t8 = w5_x * minus_w5_y;
  const Real t9 = t3 + 2.0 * (w4_y * qd[3]);
  const Real wd5_z = wd4_y + qdd[4];
  const Real t10 = minus_w5_y * w5_z;

  // links 5 (chest2) and 6 (chest3), outward
  const Real w6_z = w5_x + qd[5];
  const Real t11 = wd5_z - t8;
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real t16 = w6_y * w6_z;
  const Real t18 = w6_x * w6_y;

  // links 5 to 7, 14, outward
  const Lanes<2> w7_14_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);
  const Real t20 = w6_x * w6_z;
  const Lanes<2> t21_lanes = 0.0007965395222188762 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(2.0630162081277884e-05, (-2.0630162081277884e-05)) *
      detail::make_pack<Real>(c13, c20);
  const Real t22 = 2.0 * (w5_x * w5_z) - (c5 * t7 - s5 * t9);
  const Real wd5_x = s5 * t7 + c5 * t9 - t10;
  const Lanes<2> w7_14_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;
  const Lanes<2> w7_14_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;

  // links 6 to 8, 14 and 15, outward
  const Lanes<2> t26_lanes = detail::make_pack<Real>(s13, s20) * t21_lanes;
  const Real wd6_z = wd5_x + qdd[5];
  const Lanes<2> w8_15_z_lanes = w7_14_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);
  const Lanes<2> t30_lanes = w7_14_x_lanes * w7_14_y_lanes;
  const Lanes<2> t32_lanes = w7_14_y_lanes * w7_14_z_lanes;

  // links 1 (calf) and 6 (chest3), outward
  const Real t33 = t18 - wd6_z;
  const Lanes<2> t34_lanes = 0.0008675855653090935 - t26_lanes;
  const Lanes<2> t35_lanes = 7.104604309021728e-05 + t26_lanes;
  const Real t37 = c6 * t22 - s6 * t11;
  const Lanes<2> t43_lanes = 0.00011422720754895356 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-2.4414671283021662e-05), 2.4414671283021662e-05) *
      detail::make_pack<Real>(s13, s20);
  const Real minus_a1_y = minus_gravity_z * c1;
  const Real wd6_x = t16 - t37;
  const Real wd6_y = c6 * t11 + s6 * t22 - t20;
  const Real minus_a1_x = minus_gravity_z * s1;

  // links 2, 8, 15, outward
  const Lanes<2> w8_15_x_lanes = detail::make_pack<Real>(c8, c15) * w7_14_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_14_z_lanes;
  const Lanes<2> w8_15_y_lanes = detail::make_pack<Real>(c8, c15) * w7_14_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_14_y_lanes;
  const Real t47 = w2_z * w2_z;
  const Lanes<2> t48_lanes = detail::make_pack<Real>(c13, c20) * t21_lanes -
      detail::make_pack<Real>(1.0315081040638942e-05, (-1.0315081040638942e-05));
  const Lanes<2> t49_lanes = 0.00011422720754895356 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-2.4414671283021662e-05), 2.4414671283021662e-05) *
      detail::make_pack<Real>(c13, c20);

  // links 2 and 3, 6 to 8, 14 and 15, outward
  const Real t50 = t16 + wd6_x;
  const Lanes<2> wd7_14_z_lanes = wd6_y + detail::make_pack<Real>(qdd[6], qdd[13]);
  const Real t51 = minus_link1_to_2_y * qdd[0] - minus_a1_x;
  const Real t53 = w3_z * w3_z;
  const Lanes<2> t55_lanes = w8_15_x_lanes * w8_15_y_lanes;

  // links 2, 5, 7, 9, 14, 16, outward
  const Lanes<2> w9_16_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_15_x_lanes;
  const Lanes<2> t59_lanes = t30_lanes + wd7_14_z_lanes;
  const Real t60 = minus_link1_to_2_y * (qd[0] * qd[0]) - minus_a1_y;
  const Real t61 = w5_x * w5_x;
  const Real t62 = w5_z * w5_z;
  const Lanes<2> w9_16_y_lanes = detail::make_pack<Real>(c9, c16) * w8_15_y_lanes -
      detail::make_pack<Real>(s9, s16) * w8_15_z_lanes;

  // links 5 to 8, 14 and 15, outward
  const Real t66 = wd5_x - t10;
  const Lanes<2> t67_lanes = detail::make_pack<Real>(s7, s14) * t33 +
      detail::make_pack<Real>(c7, c14) * t50;
  const Lanes<2> t68_lanes = detail::make_pack<Real>(c7, c14) * t33 -
      detail::make_pack<Real>(s7, s14) * t50;
  const Real t69 = w6_z * w6_z;
  const Lanes<2> t70_lanes = w8_15_y_lanes * w8_15_z_lanes;

  // links 5, 7, 9, 14, 16, outward
  const Lanes<2> w9_16_x_lanes = detail::make_pack<Real>(s9, s16) * w8_15_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_15_z_lanes;
  const Real t71 = t61 + t62;
  const Lanes<2> t74_lanes = 2.0 * (w7_14_x_lanes * w7_14_z_lanes) - t67_lanes;
  const Lanes<2> wd7_14_x_lanes = t32_lanes - t68_lanes;
  const Real t76 = t8 + wd5_z;

  // links 2, 6, 9, 16, outward
  const Real a2_y = c2 * t60 - s2 * t51;
  const Real a2_x = c2 * t51 + s2 * t60;
  const Real t77 = t20 - wd6_y;
  const Real t79 = w6_y * w6_y + t69;
  const Lanes<2> t81_lanes = w9_16_x_lanes * w9_16_y_lanes;

  // links 3, 6, 8, 15, outward
  const Lanes<2> wd8_15_z_lanes = wd7_14_x_lanes + detail::make_pack<Real>(qdd[7], qdd[14]);
  const Real t84 = a2_y + minus_link2_to_3_y * t47;
  const Real t85 = a2_x + minus_link2_to_3_y * wd2_z;
  const Real t87 = t18 + wd6_z;
  const Real t90 = w6_x * w6_x;
  const Lanes<2> t91_lanes = t55_lanes + wd8_15_z_lanes;

  // links 8 to 10, 15 to 17, outward
  const Lanes<2> w10_17_z_lanes = w9_16_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);
  const Lanes<2> minus_w10_17_y_lanes = detail::make_pack<Real>(s10, s17) * w9_16_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_16_z_lanes;
  const Lanes<2> t92_lanes = detail::make_pack<Real>(c8, c15) * t59_lanes +
      detail::make_pack<Real>(s8, s15) * t74_lanes;
  const Lanes<2> t93_lanes = detail::make_pack<Real>(c8, c15) * t74_lanes -
      detail::make_pack<Real>(s8, s15) * t59_lanes;
  const Lanes<2> t94_lanes = w9_16_x_lanes * w9_16_z_lanes;
  const Lanes<2> w10_17_x_lanes = detail::make_pack<Real>(c10, c17) * w9_16_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_16_z_lanes;

  // links 3, 6, 8, 15, outward
  const Real t98 = t90 + t69;
  const Lanes<2> t100_lanes = w8_15_y_lanes * w8_15_y_lanes;
  const Lanes<2> t101_lanes = w8_15_z_lanes * w8_15_z_lanes;
  const Real a3_x = c3 * t85 + s3 * t84;
  const Real a3_y = c3 * t84 - s3 * t85;

  // links 8, 10 and 11, 15, 17 and 18, outward
  const Lanes<2> t102_lanes = 2.0 * (w8_15_x_lanes * w8_15_z_lanes) - t92_lanes;
  const Lanes<2> wd8_15_x_lanes = t70_lanes - t93_lanes;
  const Lanes<2> t104_lanes = w10_17_x_lanes * minus_w10_17_y_lanes;
  const Lanes<2> w11_18_z_lanes = minus_w10_17_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);
  const Lanes<2> t109_lanes = w10_17_x_lanes * w10_17_z_lanes;

  // links 4 and 5, 8 and 9, 15 and 16, outward
  const Real a4_x = c4 * a3_x;
  const Real t110 = a3_y + link4_to_5_z * t53;
  const Real minus_a4_y = s4 * a3_x;
  const Lanes<2> wd9_16_z_lanes = detail::make_pack<Real>(qdd[8], qdd[15]) - wd8_15_x_lanes;
  const Lanes<2> t113_lanes = t100_lanes + t101_lanes;

  // links 10 and 11, 17 and 18, outward
  const Lanes<2> t114_lanes = 0.0165153994048813 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> w11_18_y_lanes = detail::make_pack<Real>(c11, c18) * w10_17_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_17_x_lanes;
  const Lanes<2> w11_18_x_lanes = detail::make_pack<Real>(c11, c18) * w10_17_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_17_z_lanes;
  const Lanes<2> t117_lanes = w10_17_x_lanes * w10_17_x_lanes;
  const Lanes<2> t118_lanes = w10_17_z_lanes * w10_17_z_lanes;

  // links 5, 9, 16, outward
  const Real t119 = a4_x + link4_to_5_z * t4;
  const Real minus_a5_z = minus_a4_y + link4_to_5_z * t3;
  const Lanes<2> t120_lanes = detail::make_pack<Real>(s9, s16) * t102_lanes -
      detail::make_pack<Real>(c9, c16) * t91_lanes;
  const Lanes<2> t121_lanes = t81_lanes - wd9_16_z_lanes;
  const Lanes<2> t122_lanes = detail::make_pack<Real>(s9, s16) * t91_lanes +
      detail::make_pack<Real>(c9, c16) * t102_lanes;

  // links 6, 9, 11 and 12, 16, 18 and 19, outward
  const Lanes<2> t125_lanes = w11_18_x_lanes * w11_18_y_lanes;
  const Lanes<2> w12_19_z_lanes = w11_18_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);
  const Lanes<2> t128_lanes = w11_18_x_lanes * w11_18_z_lanes;
  const Real t129 = minus_a5_z + minus_link5_to_6_y * t66;
  const Lanes<2> t130_lanes = 2.0 * (w9_16_y_lanes * w9_16_z_lanes) - t120_lanes;
  const Lanes<2> minus_wd9_16_y_lanes = t122_lanes + t94_lanes;

  // links 5, 10, 12, 17, 19, outward
  const Lanes<2> t136_lanes = 2.0 * w12_19_z_lanes;
  const Lanes<2> t137_lanes = t117_lanes + t118_lanes;
  const Real a5_y = c5 * t110 - s5 * t119;
  const Real a5_x = c5 * t119 + s5 * t110;
  const Lanes<2> wd10_17_z_lanes = detail::make_pack<Real>(qdd[9], qdd[16]) - minus_wd9_16_y_lanes;
  const Lanes<2> w12_19_x_lanes = detail::make_pack<Real>(c12, c19) * w11_18_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_18_z_lanes;
  const Lanes<2> minus_w12_19_y_lanes = detail::make_pack<Real>(s12, s19) * w11_18_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_18_z_lanes;
  const Lanes<2> t141_lanes = w12_19_z_lanes * w12_19_z_lanes;

  // links 6, 10, 17, outward
  const Lanes<2> t142_lanes = 0.0165153994048813 * detail::make_pack<Real>(s13, s20);
  const Real t143 = a5_y + minus_link5_to_6_y * t71;
  const Real a6_z = a5_x + minus_link5_to_6_y * t76;
  const Lanes<2> t144_lanes = detail::make_pack<Real>(s10, s17) * t121_lanes +
      detail::make_pack<Real>(c10, c17) * t130_lanes;
  const Lanes<2> t145_lanes = t104_lanes + wd10_17_z_lanes;
  const Lanes<2> t146_lanes = detail::make_pack<Real>(c10, c17) * t121_lanes -
      detail::make_pack<Real>(s10, s17) * t130_lanes;

  // links 12 to 14, 19 and 20, outward
  const Lanes<2> w13_20_z_lanes = w12_19_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> t147_lanes = minus_w12_19_y_lanes * w12_19_z_lanes;
  const Lanes<2> t149_lanes = w12_19_x_lanes * minus_w12_19_y_lanes;
  const Lanes<2> t150_lanes = minus_w12_19_y_lanes * minus_w12_19_y_lanes;
  const Real t151 = a6_z - 0.226 * t77;

  // links 7, 10 and 11, 13 and 14, 17 and 18, 20, outward
  const Lanes<2> t152_lanes = t144_lanes - 2.0 * (minus_w10_17_y_lanes * w10_17_z_lanes);
  const Lanes<2> wd10_17_y_lanes = t146_lanes - t109_lanes;
  const Lanes<2> t158_lanes = w13_20_z_lanes * w13_20_z_lanes;
  const Lanes<2> t159_lanes = w11_18_y_lanes * w11_18_y_lanes;
  const Lanes<2> t160_lanes = t151 + detail::make_pack<Real>(0.18, (-0.18)) * t50;

  // links 12 (left_wrist2) and 19 (right_wrist2), inertial wrench; links 6, 11, 18, outward
  const Lanes<2> t163_lanes = t141_lanes - t150_lanes;
  const Real a6_x = c6 * t143 - s6 * t129;
  const Real minus_a6_y = s6 * t143 + c6 * t129;
  const Lanes<2> wd11_18_z_lanes = detail::make_pack<Real>(qdd[10], qdd[17]) - wd10_17_y_lanes;
  const Lanes<2> t164_lanes = w11_18_x_lanes * w11_18_x_lanes;

  // links 10 and 11, 14, 17 and 18, outward
  const Lanes<2> t167_lanes = t109_lanes - wd10_17_y_lanes;
  const Real t173 = a6_x + 0.226 * t79;
  const Real t174 = minus_a6_y + 0.226 * t87;
  const Lanes<2> t175_lanes = detail::make_pack<Real>(s11, s18) * t145_lanes +
      detail::make_pack<Real>(c11, c18) * t152_lanes;
  const Lanes<2> t176_lanes = t125_lanes - wd11_18_z_lanes;

  // links 7, 11, 14, 18, outward; links 13 (left_hand) and 20 (right_hand), inertial wrench
  const Lanes<2> t177_lanes = detail::make_pack<Real>(c11, c18) * t145_lanes -
      detail::make_pack<Real>(s11, s18) * t152_lanes;
  const Lanes<2> t181_lanes = (t158_lanes - t141_lanes) * t49_lanes;
  const Lanes<2> t185_lanes = t173 + detail::make_pack<Real>(0.18, (-0.18)) * t33;
  const Lanes<2> minus_a7_14_z_lanes = t174 + detail::make_pack<Real>(0.18, (-0.18)) * t98;
  const Lanes<2> t186_lanes = t175_lanes + 2.0 * (w11_18_y_lanes * w11_18_z_lanes);

  // links 11 and 12, 18 and 19, outward
  const Lanes<2> wd11_18_y_lanes = t177_lanes - t128_lanes;
  const Lanes<2> t192_lanes = t125_lanes + wd11_18_z_lanes;
  const Lanes<2> t193_lanes = w11_18_z_lanes * w11_18_z_lanes;
  const Lanes<2> wd12_19_z_lanes = wd11_18_y_lanes + detail::make_pack<Real>(qdd[11], qdd[18]);
  const Lanes<2> t202_lanes = t128_lanes - wd11_18_y_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), inertial wrench; links 7, 12, 14, 19, outward
  const Lanes<2> t208_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) * t177_lanes;
  const Lanes<2> a7_14_y_lanes = detail::make_pack<Real>(c7, c14) * t185_lanes -
      detail::make_pack<Real>(s7, s14) * t160_lanes;
  const Lanes<2> a7_14_x_lanes = detail::make_pack<Real>(s7, s14) * t185_lanes +
      detail::make_pack<Real>(c7, c14) * t160_lanes;
  const Lanes<2> t210_lanes = wd12_19_z_lanes - t149_lanes;
  const Lanes<2> t211_lanes = t149_lanes + wd12_19_z_lanes;
  const Lanes<2> t213_lanes = detail::make_pack<Real>(c12, c19) * t176_lanes -
      detail::make_pack<Real>(s12, s19) * t186_lanes;
  const Lanes<2> t218_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (t193_lanes - t159_lanes);
  const Lanes<2> wd12_19_x_lanes = detail::make_pack<Real>(s12, s19) * t176_lanes +
      detail::make_pack<Real>(c12, c19) * t186_lanes - t147_lanes;

  // links 8, 12 and 13, 15, 19 and 20, outward
  const Lanes<2> t224_lanes = t136_lanes * w12_19_x_lanes - t213_lanes;
  const Lanes<2> t225_lanes = t210_lanes + 2.0 * (minus_w12_19_y_lanes * w13_20_z_lanes);
  const Lanes<2> minus_a8_15_y_lanes = detail::make_pack<Real>(s8, s15) * a7_14_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_14_z_lanes;
  const Lanes<2> a8_15_x_lanes = detail::make_pack<Real>(c8, c15) * a7_14_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_14_z_lanes;
  const Lanes<2> wd13_20_z_lanes = wd12_19_x_lanes + detail::make_pack<Real>(qdd[12], qdd[19]);

  // links 10, 12 and 13, 17, 19 and 20, outward
  const Lanes<2> t235_lanes = t136_lanes * w13_20_z_lanes - t224_lanes;
  const Lanes<2> t238_lanes = wd12_19_x_lanes - t147_lanes;
  const Lanes<2> t245_lanes = 0.282 * t113_lanes - a8_15_x_lanes;
  const Lanes<2> t249_lanes = wd13_20_z_lanes - t147_lanes;
  const Lanes<2> t250_lanes = t147_lanes + wd13_20_z_lanes;

  // links 9 and 10, 16 and 17, outward; links 13 (left_hand) and 20 (right_hand), inertial wrench
  const Lanes<2> a9_16_x_lanes = detail::make_pack<Real>(c9, c16) * a7_14_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_15_y_lanes;
  const Lanes<2> minus_a9_16_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_15_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_14_x_lanes;
  const Lanes<2> f13_20_z_lanes = t235_lanes * t142_lanes - t225_lanes * t114_lanes;
  const Lanes<2> t269_lanes = a9_16_x_lanes + 0.282 * t122_lanes;
  const Lanes<2> minus_a10_17_z_lanes = minus_a9_16_y_lanes + 0.282 * t120_lanes;

  // links 13 (left_hand) and 20 (right_hand), inertial wrench and inward
  const Lanes<2> t270_lanes = 0.0009386316083993107 * wd13_20_z_lanes - t147_lanes *
      (t34_lanes - t35_lanes) + t224_lanes * t43_lanes;
  const Lanes<2> f12_19_x_lanes = f13_20_z_lanes - (0.0025100003499999995 *
      (t150_lanes + t141_lanes) + 0.0006000000000000001 * t211_lanes);
  const Lanes<2> minus_f13_20_x_lanes = (t141_lanes + t158_lanes) * t114_lanes + t250_lanes *
      t142_lanes;
  const Lanes<2> t283_lanes = t235_lanes * t35_lanes - t225_lanes * t48_lanes - t249_lanes *
      t43_lanes + t181_lanes;
  const Lanes<2> f13_20_y_lanes = t249_lanes * t114_lanes - (t150_lanes + t158_lanes) * t142_lanes;
  const Lanes<2> f12_19_y_lanes = 0.0025100003499999995 * t210_lanes - 0.0006000000000000001 *
      (w12_19_x_lanes * w12_19_x_lanes + t141_lanes) - minus_f13_20_x_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), outward; links 13 (left_hand) and 20
  //   (right_hand), inward; links 11 (left_wrist1) and 18 (right_wrist1), inertial wrench
  const Lanes<2> a10_17_x_lanes = detail::make_pack<Real>(c10, c17) * t269_lanes -
      detail::make_pack<Real>(s10, s17) * t245_lanes;
  const Lanes<2> minus_a10_17_y_lanes = detail::make_pack<Real>(s10, s17) * t269_lanes +
      detail::make_pack<Real>(c10, c17) * t245_lanes;
  const Lanes<2> f12_19_z_lanes = 0.0025100003499999995 * t224_lanes + 0.0006000000000000001 *
      t238_lanes + f13_20_y_lanes;
  const Lanes<2> t296_lanes = 0.000144 * (t164_lanes - t193_lanes);
  const Lanes<2> t299_lanes = minus_w10_17_y_lanes * minus_w10_17_y_lanes;

  // links 10, 12, 17, 19, outward; links 12 (left_wrist2) and 19 (right_wrist2), inward; links 11
  //   (left_wrist1) and 18 (right_wrist1), inertial wrench
  const Lanes<2> t302_lanes = minus_a10_17_y_lanes + 0.269 * t137_lanes;
  const Lanes<2> t309_lanes = detail::make_pack<Real>(s12, s19) * f12_19_y_lanes -
      detail::make_pack<Real>(c12, c19) * f12_19_x_lanes;
  const Lanes<2> t311_lanes = 0.0001194 * t186_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      t202_lanes + 0.000144 * t192_lanes + t218_lanes;
  const Lanes<2> t312_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) * t176_lanes -
      0.0001098 * t202_lanes - detail::make_pack<Real>(6e-06, (-6e-06)) * t186_lanes - t296_lanes;
  const Lanes<2> t315_lanes = wd10_17_z_lanes - t104_lanes;

  // links 11 and 12, 18 and 19, outward; links 12 (left_wrist2) and 19 (right_wrist2), inward
  const Lanes<2> a11_18_x_lanes = detail::make_pack<Real>(c11, c18) * a10_17_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_17_z_lanes;
  const Lanes<2> minus_a11_18_y_lanes = detail::make_pack<Real>(s11, s18) * a10_17_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_17_z_lanes;
  const Lanes<2> f11_18_x_lanes = detail::make_pack<Real>(0.001, (-0.001)) * t176_lanes - 6e-04 *
      (t159_lanes + t193_lanes) - t309_lanes;
  const Lanes<2> f11_18_y_lanes = 6e-04 * t192_lanes - detail::make_pack<Real>(0.001, (-0.001)) *
      (t164_lanes + t193_lanes) + f12_19_z_lanes;
  const Lanes<2> t325_lanes = a11_18_x_lanes - 0.269 * t177_lanes;
  const Lanes<2> a12_19_z_lanes = 0.269 * t175_lanes - minus_a11_18_y_lanes;

  // links 10 and 11, 17 and 18, inertial wrench; links 12 (left_wrist2) and 19 (right_wrist2),
  //   inward and outward
  const Lanes<2> t330_lanes = 0.00022920000000000001 * wd11_18_z_lanes - 9.6e-06 * t125_lanes +
      0.000144 * t175_lanes - t208_lanes;
  const Lanes<2> t347_lanes = detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      (t118_lanes - t299_lanes);
  const Lanes<2> t348_lanes = detail::make_pack<Real>(s12, s19) * f12_19_x_lanes +
      detail::make_pack<Real>(c12, c19) * f12_19_y_lanes;
  const Lanes<2> t350_lanes = 6e-04 * minus_a11_18_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_18_x_lanes;
  const Lanes<2> minus_a12_19_y_lanes = detail::make_pack<Real>(s12, s19) * t325_lanes +
      detail::make_pack<Real>(c12, c19) * t302_lanes;
  const Lanes<2> a12_19_x_lanes = detail::make_pack<Real>(c12, c19) * t325_lanes -
      detail::make_pack<Real>(s12, s19) * t302_lanes;
  const Lanes<2> t353_lanes = 0.00028099984685315 * t167_lanes +
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) * t145_lanes +
      0.0001499998887063 * t152_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), outward; links 12 (left_wrist2) and 19
  //   (right_wrist2), inertial wrench and inward
  const Lanes<2> t357_lanes = w9_16_y_lanes * w9_16_y_lanes;
  const Lanes<2> t358_lanes = w9_16_z_lanes * w9_16_z_lanes;
  const Lanes<2> t360_lanes = w9_16_x_lanes * w9_16_x_lanes;
  const Lanes<2> t362_lanes = 0.0025100003499999995 * minus_a12_19_y_lanes;
  const Lanes<2> f11_18_z_lanes = 6e-04 * t202_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      t186_lanes - t348_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), inertial wrench; links 9 (left_upperarm) and
  //   16 (right_upperarm), outward; links 13 (left_hand) and 20 (right_hand), inward
  const Lanes<2> t369_lanes = 0.0014999985000000002 * (t299_lanes + t118_lanes) +
      0.28049749700000004 * t145_lanes;
  const Lanes<2> t372_lanes = 0.06060754126741261 * t152_lanes + 0.0001499998887063 * t167_lanes -
      detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) * t315_lanes + t347_lanes;
  const Lanes<2> t373_lanes = t94_lanes + minus_wd9_16_y_lanes;
  const Lanes<2> t374_lanes = detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      t146_lanes;
  const Lanes<2> t377_lanes = 0.000206827662257343 * wd12_19_z_lanes - 0.000183627662257343 *
      t149_lanes - detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      t213_lanes - t362_lanes;

  // links 13 (left_hand) and 20 (right_hand), inertial wrench; links 9 (left_upperarm) and 16
  //   (right_upperarm), outward; links 11 (left_wrist1) and 18 (right_wrist1), inward
  const Lanes<2> t378_lanes = t114_lanes * a12_19_z_lanes + t142_lanes * minus_a12_19_y_lanes;
  const Lanes<2> n13_20_x_lanes = t283_lanes + t142_lanes * a12_19_x_lanes;
  const Lanes<2> t383_lanes = t81_lanes + wd9_16_z_lanes;
  const Lanes<2> f10_17_y_lanes = 0.0014999985000000002 * t315_lanes - 0.28049749700000004 *
      t137_lanes - f11_18_z_lanes;
  const Lanes<2> f10_17_x_lanes = detail::make_pack<Real>(c11, c18) * f11_18_x_lanes -
      detail::make_pack<Real>(s11, s18) * f11_18_y_lanes - t369_lanes;
  const Lanes<2> n13_20_z_lanes = t270_lanes - t210_lanes * t49_lanes + t163_lanes * t48_lanes +
      t378_lanes;
  tau[12] = n13_20_z_lanes[0];
  tau[19] = n13_20_z_lanes[1];

  // links 11, 13, 18, 20, inward; links 10 (left_lowerarm) and 17 (right_lowerarm), inertial
  //   wrench
  const Lanes<2> n12_19_y_lanes = n13_20_x_lanes - (0.000195227662257343 * t224_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * t211_lanes +
      0.0025100003499999995 * a12_19_z_lanes);
  const Lanes<2> t394_lanes = 0.06032654142055946 * t104_lanes + 0.060888541114265754 *
      wd10_17_z_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      t144_lanes - t374_lanes;
  const Lanes<2> n12_19_x_lanes = 1.16e-05 * t238_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * t163_lanes +
      0.0006000000000000001 * a12_19_z_lanes + n13_20_z_lanes;
  const Lanes<2> t400_lanes = detail::make_pack<Real>(s11, s18) * f11_18_x_lanes +
      detail::make_pack<Real>(c11, c18) * f11_18_y_lanes;
  const Lanes<2> t407_lanes = t377_lanes + t225_lanes * t34_lanes - t250_lanes * t49_lanes -
      t235_lanes * t48_lanes;
  const Lanes<2> t411_lanes = 0.0014999985000000002 * minus_a10_17_y_lanes + 0.28049749700000004 *
      a10_17_x_lanes;

  // links 8 (left_shoulder2) and 15 (right_shoulder2), outward; links 10 and 11, 17 and 18,
  //   inward; links 9 (left_upperarm) and 16 (right_upperarm), inertial wrench
  const Lanes<2> t415_lanes = w8_15_x_lanes * w8_15_x_lanes;
  const Lanes<2> f10_17_z_lanes = 0.0014999985000000002 * t167_lanes + 0.28049749700000004 *
      t152_lanes + t400_lanes;
  const Lanes<2> t416_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * (t358_lanes - t357_lanes);
  const Lanes<2> t417_lanes = detail::make_pack<Real>(s10, s17) * f10_17_y_lanes -
      detail::make_pack<Real>(c10, c17) * f10_17_x_lanes;
  const Lanes<2> t419_lanes = 0.0005895000784280001 * (t360_lanes - t358_lanes);

  // links 8 (left_shoulder2) and 15 (right_shoulder2), outward; links 12 and 13, 19 and 20, inward
  const Lanes<2> t421_lanes = t55_lanes - wd8_15_z_lanes;
  const Lanes<2> t423_lanes = detail::make_pack<Real>(s12, s19) * n12_19_x_lanes +
      detail::make_pack<Real>(c12, c19) * n12_19_y_lanes;
  const Lanes<2> t426_lanes = t70_lanes + wd8_15_x_lanes;
  const Lanes<2> n12_19_z_lanes = t407_lanes + (t150_lanes - t158_lanes) * t43_lanes -
      (0.0006000000000000001 + t114_lanes) * a12_19_x_lanes;
  tau[11] = n12_19_z_lanes[0];
  tau[18] = n12_19_z_lanes[1];

  // links 12 (left_wrist2) and 19 (right_wrist2), inward; links 9 (left_upperarm) and 16
  //   (right_upperarm), inertial wrench
  const Lanes<2> t433_lanes = 0.269 * f12_19_z_lanes -
      (detail::make_pack<Real>(s12, s19) * n12_19_y_lanes - detail::make_pack<Real>(c12, c19) *
      n12_19_x_lanes);
  const Lanes<2> n11_18_z_lanes = t330_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      (t159_lanes - t164_lanes) - t350_lanes - t423_lanes;
  tau[10] = n11_18_z_lanes[0];
  tau[17] = n11_18_z_lanes[1];
  const Lanes<2> t434_lanes = 0.0019585440854647937 * t130_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * t373_lanes -
      0.0005895000784280001 * t383_lanes + t416_lanes;
  const Lanes<2> t435_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * t121_lanes - 0.0008177492704690715 * t373_lanes -
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * t130_lanes +
      t419_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), inertial wrench; links 11 and 12, 18 and 19,
  //   inward
  const Lanes<2> t443_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * t122_lanes;
  const Lanes<2> n11_18_x_lanes = t311_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      minus_a10_17_y_lanes + t433_lanes;
  const Lanes<2> n10_17_y_lanes = detail::make_pack<Real>(2.249994685315e-05,
      (-2.249994685315e-05)) * (t117_lanes - t118_lanes) - t353_lanes + 0.0014999985000000002 *
      minus_a10_17_z_lanes - n11_18_z_lanes;
  const Lanes<2> n11_18_y_lanes = t312_lanes - 6e-04 * minus_a10_17_y_lanes +
      (n12_19_z_lanes + 0.269 * t309_lanes);
  const Lanes<2> t476_lanes = detail::make_pack<Real>(s11, s18) * n11_18_x_lanes +
      detail::make_pack<Real>(c11, c18) * n11_18_y_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), inward; link 21 (neck), outward
  const Lanes<2> f9_16_x_lanes = 0.0022500062 * (t357_lanes + t358_lanes) +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * t121_lanes - t417_lanes;
  const Real wd21_z = qdd[20] - wd6_x;
  const Lanes<2> f9_16_y_lanes = f10_17_z_lanes - (0.0022500062 * t383_lanes +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * (t360_lanes + t358_lanes));
  const Real w21_z = qd[20] - w6_x;
  const Real w21_x = s21 * w6_y + c21 * w6_z;

  // links 10 and 11, 17 and 18, inward
  const Lanes<2> n10_17_x_lanes = t372_lanes - 0.28049749700000004 * minus_a10_17_z_lanes +
      (detail::make_pack<Real>(c11, c18) * n11_18_x_lanes - detail::make_pack<Real>(s11, s18) *
      n11_18_y_lanes);
  const Lanes<2> n10_17_z_lanes = t394_lanes + 0.0001499998887063 * (t299_lanes - t117_lanes) -
      t411_lanes + t476_lanes;
  tau[9] = n10_17_z_lanes[0];
  tau[16] = n10_17_z_lanes[1];
  const Lanes<2> t479_lanes = detail::make_pack<Real>(s10, s17) * f10_17_x_lanes +
      detail::make_pack<Real>(c10, c17) * f10_17_y_lanes;

  // links 7, 14, 21 and 22, outward
  const Real w21_y = c21 * w6_y - s21 * w6_z;
  const Lanes<2> t484_lanes = t32_lanes + wd7_14_x_lanes;
  const Real t486 = s21 * t77 - c21 * t87;
  const Real t487 = w21_x * w21_y;
  const Real w22_z = w21_y + qd[21];

  // links 7, 14, 21 and 22, outward; links 9 (left_upperarm) and 16 (right_upperarm), inertial
  //   wrench
  const Real t488 = w21_x * w21_z;
  const Lanes<2> t491_lanes = 0.0027762933559338653 * wd9_16_z_lanes - 0.0011407948149957223 *
      t81_lanes + 0.0005895000784280001 * t120_lanes + t443_lanes;
  const Lanes<2> t494_lanes = w7_14_y_lanes * w7_14_y_lanes;
  const Real t495 = s21 * t87 + c21 * t77;
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;

  // links 7, 14, 21 and 22, outward; links 10 (left_lowerarm) and 17 (right_lowerarm), inward
  const Lanes<2> t497_lanes = w7_14_z_lanes * w7_14_z_lanes;
  const Real t498 = t487 - wd21_z;
  const Lanes<2> t499_lanes = w7_14_x_lanes * w7_14_x_lanes;
  const Lanes<2> n9_16_y_lanes = t435_lanes - 0.0022500062 * a8_15_x_lanes +
      (n10_17_z_lanes + 0.282 * t417_lanes);
  const Real w22_x = c22 * w21_x - s22 * w21_z;

  // links 8 (left_shoulder2) and 15 (right_shoulder2), inertial wrench; links 21, 23 and 24,
  //   outward
  const Lanes<2> t501_lanes = 0.00010499999999999999 * (t415_lanes - t101_lanes);
  const Real minus_wd21_y = t495 + t488;
  const Lanes<2> w23_24_z_lanes = minus_w22_y + detail::make_pack<Real>(qd[22], qd[23]);
  const Lanes<2> t505_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (t101_lanes - t100_lanes);
  const Real t506 = 2.0 * (w21_y * w21_z) - t486;

  // links 22 to 24, outward; links 10 (left_lowerarm) and 17 (right_lowerarm), inward
  const Real t507 = w22_x * w22_z;
  const Real t508 = w22_x * minus_w22_y;
  const Real wd22_z = qdd[21] - minus_wd21_y;
  const Lanes<2> t511_lanes = 2.0 * w23_24_z_lanes;
  const Lanes<2> t512_lanes = 0.282 * f10_17_z_lanes -
      (detail::make_pack<Real>(s10, s17) * n10_17_y_lanes - detail::make_pack<Real>(c10, c17) *
      n10_17_x_lanes);
  const Lanes<2> f9_16_z_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      t130_lanes - 0.0022500062 * t373_lanes - t479_lanes;

  // links 21 (neck) and 22 (head), outward; links 9 (left_upperarm) and 16 (right_upperarm),
  //   inward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;
  const Lanes<2> t514_lanes = detail::make_pack<Real>(s9, s16) * f9_16_x_lanes +
      detail::make_pack<Real>(c9, c16) * f9_16_y_lanes;
  const Real t516 = a6_x + link21_to_22_z * t79;
  const Real t517 = t508 + wd22_z;
  const Real t518 = wd22_z - t508;

  // links 22 to 24, outward; links 10 (left_lowerarm) and 17 (right_lowerarm), inward
  const Lanes<2> t519_lanes = w23_24_z_lanes * w23_24_z_lanes;
  const Lanes<2> w23_24_y_lanes = detail::make_pack<Real>(c23, c24) * w22_z -
      detail::make_pack<Real>(s23, s24) * w22_x;
  const Lanes<2> w23_24_x_lanes = detail::make_pack<Real>(c23, c24) * w22_x +
      detail::make_pack<Real>(s23, s24) * w22_z;
  const Lanes<2> n9_16_x_lanes = t434_lanes - detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) * a8_15_x_lanes + t512_lanes;
  const Real t521 = c22 * t498 - s22 * t506;
  const Real t522 = a21_x - link21_to_22_z * t495;
  const Real t523 = s22 * t498 + c22 * t506;
  const Lanes<2> t527_lanes = w23_24_x_lanes * w23_24_y_lanes;

  // links 21 (neck) and 22 (head), outward; links 8 (left_shoulder2) and 15 (right_shoulder2),
  //   inertial wrench
  const Real wd22_y = t521 - t507;
  const Real t529 = t523 - 2.0 * (minus_w22_y * w22_z);
  const Lanes<2> t533_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * t92_lanes;
  const Real t534 = w21_x * w21_x;
  const Real t535 = w21_z * w21_z;

  // links 21 to 24, outward
  const Real t538 = t507 - wd22_y;
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;
  const Real t539 = minus_w22_y * minus_w22_y;
  const Real t540 = w22_z * w22_z;
  const Lanes<2> wd23_24_z_lanes = detail::make_pack<Real>(qdd[22], qdd[23]) - wd22_y;

  // links 21 (neck) and 22 (head), outward
  const Real a22_y = c22 * t516 - s22 * t522;
  const Real t545 = t534 + t535;
  const Real a22_z = link21_to_22_z * t486 - minus_a21_y;
  const Real a22_x = c22 * t522 + s22 * t516;
  const Real t547 = t539 + t540;

  // links 23 (left_eye) and 24 (right_eye), outward and inertial wrench
  const Lanes<2> t549_lanes = t527_lanes + wd23_24_z_lanes;
  const Lanes<2> t550_lanes = detail::make_pack<Real>(s23, s24) * t517 +
      detail::make_pack<Real>(c23, c24) * t529;
  const Real t552 = a22_y + 0.095 * t518;
  const Real t555 = a22_z + 0.095 * t538;
  const Lanes<2> t557_lanes = t511_lanes * w23_24_x_lanes -
      (detail::make_pack<Real>(c23, c24) * t517 - detail::make_pack<Real>(s23, s24) * t529);
  const Lanes<2> f23_24_y_lanes = 0.00025 * t549_lanes;
  const Lanes<2> minus_a23_24_z_lanes = t552 - detail::make_pack<Real>(0.032, (-0.032)) * t523;
  const Real t567 = a22_x - 0.095 * t547;

  // links 9, 16, 23 and 24, inertial wrench; links 7 (left_shoulder1) and 14 (right_shoulder1),
  //   outward
  const Lanes<2> t568_lanes = 0.00025 * minus_a23_24_z_lanes;
  const Lanes<2> minus_f23_24_x_lanes = 0.00025 * (w23_24_y_lanes * w23_24_y_lanes + t519_lanes);
  const Lanes<2> t575_lanes = 0.0022500062 * minus_a9_16_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_16_x_lanes;
  const Lanes<2> n23_24_x_lanes = 4e-06 * (t550_lanes + t511_lanes * w23_24_y_lanes) -
      2.8750000000000004e-05 * t549_lanes;
  const Lanes<2> t580_lanes = t30_lanes - wd7_14_z_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), inward; links 23 (left_eye) and 24
  //   (right_eye), outward and inertial wrench
  const Lanes<2> f8_15_x_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * t421_lanes - 0.7139200499999999 * t113_lanes - f9_16_z_lanes;
  const Lanes<2> t586_lanes = detail::make_pack<Real>(s23, s24) *
      (t567 + detail::make_pack<Real>(0.032, (-0.032)) * t521);
  const Lanes<2> n23_24_y_lanes = 2.8750000000000004e-05 *
      (w23_24_x_lanes * w23_24_x_lanes - t519_lanes) - 5.25e-06 * t557_lanes + t568_lanes;
  const Lanes<2> f8_15_y_lanes = 0.7139200499999999 * t91_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (t415_lanes + t101_lanes) + t514_lanes;
  const Lanes<2> a23_24_y_lanes = detail::make_pack<Real>(c23, c24) *
      (t555 - detail::make_pack<Real>(0.032, (-0.032)) * t545) - t586_lanes;

  // links 10, 17, 23 and 24, inward; link 21 (neck), outward; links 8 (left_shoulder2) and 15
  //   (right_shoulder2), inertial wrench
  const Lanes<2> t598_lanes = detail::make_pack<Real>(c23, c24) * minus_f23_24_x_lanes +
      detail::make_pack<Real>(s23, s24) * f23_24_y_lanes;
  const Lanes<2> t599_lanes = detail::make_pack<Real>(c23, c24) * f23_24_y_lanes -
      detail::make_pack<Real>(s23, s24) * minus_f23_24_x_lanes;
  const Real t601 = t487 + wd21_z;
  const Lanes<2> t602_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * t421_lanes -
      0.18113119219699997 * t102_lanes - detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * t426_lanes + t501_lanes;
  const Lanes<2> t603_lanes = detail::make_pack<Real>(s10, s17) * n10_17_x_lanes +
      detail::make_pack<Real>(c10, c17) * n10_17_y_lanes;
  const Lanes<2> t605_lanes = 0.00012075 * t426_lanes +
      detail::make_pack<Real>(5.2499999999999995e-05, (-5.2499999999999995e-05)) * t102_lanes -
      0.00010499999999999999 * t91_lanes + t505_lanes;

  // links 23 (left_eye) and 24 (right_eye), inertial wrench and inward; link 22 (head), outward
  const Lanes<2> t609_lanes = 0.00025 * a23_24_y_lanes;
  const Real t611 = t599_lanes[1] + t599_lanes[0];
  const Real t612 = w22_x * w22_x;
  const Lanes<2> t613_lanes = detail::make_pack<Real>(c23, c24) * n23_24_x_lanes -
      detail::make_pack<Real>(s23, s24) * n23_24_y_lanes +
      detail::make_pack<Real>(8.000000000000001e-06, (-8.000000000000001e-06)) * t557_lanes;
  const Lanes<2> t614_lanes = detail::make_pack<Real>(s23, s24) * n23_24_x_lanes;

  // links 8, 15, 23 and 24, inertial wrench; links 23 (left_eye) and 24 (right_eye), inward
  const Lanes<2> t615_lanes = 0.18101044219699997 * t55_lanes + 0.18125194219699997 *
      wd8_15_z_lanes + 0.00010499999999999999 * t93_lanes - t533_lanes;
  const Lanes<2> n23_24_z_lanes = 1.25e-06 * t527_lanes + 9.25e-06 * wd23_24_z_lanes -
      2.8750000000000004e-05 * t550_lanes + t609_lanes;
  tau[22] = n23_24_z_lanes[0];
  tau[23] = n23_24_z_lanes[1];
  const Lanes<2> t616_lanes = detail::make_pack<Real>(c23, c24) * n23_24_y_lanes;

  // link 23 (left_eye), inward; link 21 (neck), outward
  const Real f22_z = h_22_x * t538 - minus_h_22_y * t529 + t611;
  const Real t617 = t557_lanes[1] + t557_lanes[0];
  const Real n22_x = J_22_xx * t529 - J_22_xy * t538 - minus_h_22_y * a22_z + t613_lanes[1] +
      t613_lanes[0];
  const Real t622 = t488 + minus_wd21_y;
  const Real t623 = J_22_xy * t529 - J_22_yy * t538 - h_22_x * a22_z - n23_24_z_lanes[1] -
      (-0.032) * t598_lanes[1];

  // links 9 and 10, 16 and 17, inward; links 7 (left_shoulder1) and 14 (right_shoulder1), inertial
  //   wrench
  const Lanes<2> t624_lanes = detail::make_pack<Real>(s9, s16) * f9_16_y_lanes;
  const Lanes<2> t628_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (t497_lanes - t494_lanes);
  const Lanes<2> n9_16_z_lanes = t491_lanes + detail::make_pack<Real>((-4.4999986458742003e-05),
      4.4999986458742003e-05) * (t357_lanes - t360_lanes) + t575_lanes - t603_lanes;
  tau[8] = n9_16_z_lanes[0];
  tau[15] = n9_16_z_lanes[1];

  // link 23 (left_eye), inward; links 8 (left_shoulder2) and 15 (right_shoulder2), inertial wrench
  const Real t637 = 0.04506407500000001 * t508 + J_22_zz * wd22_z - J_22_xy * (t539 - t612) +
      h_22_x * a22_y;
  const Real f22_y = h_22_x * t518 + minus_h_22_y * (t612 + t540) - 0.00025 * t617;
  const Real f22_x = minus_h_22_y * t517 - h_22_x * t547 - t598_lanes[1] - t598_lanes[0];
  const Lanes<2> t639_lanes = 0.7139200499999999 * minus_a8_15_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_15_x_lanes;
  const Real n22_y = t623 - n23_24_z_lanes[0] - 0.032 * t598_lanes[0] - 0.095 * t611;

  // links 8 and 9, 15 and 16, 22, inward; links 7 (left_shoulder1) and 14 (right_shoulder1),
  //   inertial wrench
  const Lanes<2> t642_lanes = 0.0017499999999999998 * (t59_lanes + (t499_lanes + t497_lanes));
  const Lanes<2> t646_lanes = 0.0017499999999999998 * minus_a7_14_z_lanes;
  const Lanes<2> n8_15_y_lanes = t602_lanes - 0.7139200499999999 * a7_14_x_lanes +
      (detail::make_pack<Real>(s9, s16) * n9_16_x_lanes + detail::make_pack<Real>(c9, c16) *
      n9_16_y_lanes);
  const Lanes<2> n8_15_x_lanes = t605_lanes + detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_14_x_lanes - n9_16_z_lanes;
  const Lanes<2> t648_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (t499_lanes - t497_lanes);
  const Lanes<2> t650_lanes = 0.7139200499999999 * t102_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * t426_lanes +
      detail::make_pack<Real>(c9, c16) * f9_16_x_lanes - t624_lanes;
  const Real t651 = s22 * f22_y - c22 * f22_x;
  const Lanes<2> t654_lanes = detail::make_pack<Real>(c9, c16) * n9_16_x_lanes -
      detail::make_pack<Real>(s9, s16) * n9_16_y_lanes;
  const Lanes<2> t656_lanes = 0.0001505 * t484_lanes + 8.75e-06 * t74_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * t59_lanes +
      t628_lanes;
  const Lanes<2> f7_14_y_lanes = detail::make_pack<Real>(c8, c15) * f8_15_x_lanes -
      detail::make_pack<Real>(s8, s15) * f8_15_y_lanes + t642_lanes;
  const Lanes<2> f7_14_x_lanes = t650_lanes - 0.0017499999999999998 *
      (t494_lanes + t497_lanes + t580_lanes);

  // links 7 (left_shoulder1) and 14 (right_shoulder1), inertial wrench; links 9 (left_upperarm)
  //   and 16 (right_upperarm), inward
  const Lanes<2> t662_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * t67_lanes;
  const Lanes<2> n8_15_z_lanes = t615_lanes + detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * (t100_lanes - t415_lanes) - t639_lanes + t654_lanes;
  tau[7] = n8_15_z_lanes[0];
  tau[14] = n8_15_z_lanes[1];
  const Lanes<2> t665_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * t580_lanes - 0.0002975 * t74_lanes - 8.75e-06 * t484_lanes +
      t648_lanes;

  // links 8, 15, 22 and 23, inward
  const Real n21_x = J_21_xx * t506 - minus_J_21_xz * t601 -
      (s22 * n22_y - c22 * n22_x + link21_to_22_z * f22_z);
  const Lanes<2> f7_14_z_lanes = detail::make_pack<Real>(s8, s15) * f8_15_x_lanes +
      detail::make_pack<Real>(c8, c15) * f8_15_y_lanes + 0.0017499999999999998 *
      (t74_lanes - t484_lanes);
  const Real n22_z = t637 + minus_h_22_y * a22_x + t614_lanes[1] + t616_lanes[1] + t614_lanes[0] +
      t616_lanes[0] - 2.375e-05 * t617;
  tau[21] = n22_z;
  const Lanes<2> n7_14_x_lanes = t656_lanes + t646_lanes + n8_15_z_lanes;
  const Real minus_f21_x = h_21_x * (w21_y * w21_y + t535) + t651;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), inertial wrench; links 7 (left_shoulder1)
  //   and 22 (head), inward
  const Lanes<2> t674_lanes = 0.000147 * t30_lanes + 0.000448 * wd7_14_z_lanes +
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * t68_lanes -
      t662_lanes;
  const Real t675 = f7_14_z_lanes[1] + f7_14_z_lanes[0];
  const Real f21_z = h_21_x * t622 - (s22 * f22_x + c22 * f22_y);
  const Real t676 = 1.26882463592404 * t18 + J_6_zz * wd6_z - J_6_xz * t37 + minus_h_6_x *
      minus_a6_y + c21 * n21_x;
  const Real n21_y = minus_J_21_xz * (t534 - t535) - J_21_yy * t622 + h_21_x * a6_x +
      (n22_z - link21_to_22_z * t651);
  const Real f21_y = h_21_x * t601 + f22_z;

  // links 7 and 8, 14 and 15, inward; link 5 (chest2), outward
  const Lanes<2> n7_14_y_lanes = t665_lanes + t646_lanes +
      (detail::make_pack<Real>(c8, c15) * n8_15_x_lanes - detail::make_pack<Real>(s8, s15) *
      n8_15_y_lanes);
  const Lanes<2> t679_lanes = detail::make_pack<Real>(c7, c14) * n7_14_x_lanes;
  const Lanes<2> t680_lanes = detail::make_pack<Real>(s7, s14) * f7_14_x_lanes +
      detail::make_pack<Real>(c7, c14) * f7_14_y_lanes;
  const Lanes<2> t681_lanes = detail::make_pack<Real>(c7, c14) * f7_14_x_lanes -
      detail::make_pack<Real>(s7, s14) * f7_14_y_lanes;
  const Lanes<2> t682_lanes = detail::make_pack<Real>(c8, c15) * n8_15_y_lanes;
  const Real t684 = minus_w5_y * minus_w5_y;
  const Lanes<2> t686_lanes = detail::make_pack<Real>(s7, s14) * n7_14_y_lanes;
  const Real t687 = t681_lanes[1] + t681_lanes[0];
  const Lanes<2> t691_lanes = t674_lanes + 8.75e-06 * (t494_lanes - t499_lanes) +
      detail::make_pack<Real>(s8, s15) * n8_15_x_lanes + t682_lanes;

  // links 7 (left_shoulder1) and 22 (head), inward
  const Real t692 = minus_h_6_x * a6_z - J_6_yy * t77 - J_6_xz * (t90 - t69) + s21 * n21_x;
  const Real f6_x = minus_h_6_x * t79 - f21_z + t680_lanes[1] + t680_lanes[0];
  const Real f6_y = t675 - minus_h_6_x * t87 - s21 * minus_f21_x + c21 * f21_y;
  const Real n21_z = J_21_zz * wd21_z - 0.0048105000000000005 * t487 + minus_J_21_xz * t486 -
      h_21_x * minus_a21_y - (s22 * n22_x + c22 * n22_y);
  tau[20] = n21_z;

  // links 7 and 8, 14 and 15, inward; link 4 (chest1), outward
  const Lanes<2> n7_14_z_lanes = t691_lanes + 0.0017499999999999998 *
      (a7_14_y_lanes + a7_14_x_lanes);
  tau[6] = n7_14_z_lanes[0];
  tau[13] = n7_14_z_lanes[1];
  const Lanes<2> t695_lanes = detail::make_pack<Real>(s7, s14) * n7_14_x_lanes +
      detail::make_pack<Real>(c7, c14) * n7_14_y_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      t681_lanes;
  const Real t696 = qd[3] * qd[3];

  // links 6 (chest3) and 7 (left_shoulder1), inward
  const Real f6_z = t687 - minus_h_6_x * t77 - c21 * minus_f21_x - s21 * f21_y;
  const Real f5_y = h_5_x * t11 + minus_h_5_y * t71 + (c6 * f6_x - s6 * f6_y);
  const Real t697 = s6 * f6_x + c6 * f6_y;
  const Real t698 = t676 - s21 * n21_y + t679_lanes[1] - t686_lanes[1] - (-0.18) * t680_lanes[1] +
      t679_lanes[0] - t686_lanes[0];
  const Real f5_x = minus_h_5_y * t76 - h_5_x * (t684 + t62) + f6_z;
  const Real n6_x = J_6_xx * t50 + J_6_xz * t87 - n21_z + t695_lanes[1] + t695_lanes[0];
  const Real n6_y = t692 + c21 * n21_y + n7_14_z_lanes[1] + n7_14_z_lanes[0] + 0.226 * t687;

  // link 4 (chest1), outward; links 5 to 7, inward
  const Real t699 = t5 + qdd[3];
  const Real f5_z = h_5_x * t22 - minus_h_5_y * t66 + t697;
  const Real n6_z = t698 - 0.18 * t680_lanes[0] - 0.226 * t675;
  tau[5] = n6_z;
  const Real t700 = s5 * f5_y - c5 * f5_x;
  const Real t701 = t6 - wd4_y;

  // links 5 (chest2) and 6 (chest3), inward; link 5 (chest2), inertial wrench
  const Real f4_y = f5_z - minus_h_4_x * t699;
  const Real f4_x = minus_h_4_x * (w4_y * w4_y + t696) - t700;
  const Real n5_y = J_5_xy * t66 - J_5_yy * t22 + h_5_x * minus_a5_z + (c6 * n6_x - s6 * n6_y);
  const Real n5_x = J_5_xx * t66 - J_5_xy * t22 + minus_h_5_y * minus_a5_z +
      (n6_z - minus_link5_to_6_y * t697);
  const Real t702 = 0.10961925816937634 * t8 + J_5_zz * wd5_z - J_5_xy * (t684 - t61) +
      (h_5_x * a5_y + minus_h_5_y * a5_x);
  const Real minus_f4_z = minus_h_4_x * t701 + (s5 * f5_x + c5 * f5_y);
  const Real n5_z = t702 + (s6 * n6_x + c6 * n6_y + minus_link5_to_6_y * f6_z);
  tau[4] = n5_z;

  // links 3 to 5, inward
  const Real f3_x = minus_h_3_x * t53 + minus_h_3_y * wd3_z + (c4 * f4_x - s4 * f4_y);
  const Real f3_y = minus_h_3_y * t53 - minus_h_3_x * wd3_z + minus_f4_z;
  const Real n4_y = n5_z - link4_to_5_z * t700 - (J_4_yy * t701 + J_4_xz * (w4_x * w4_x - t696) +
      minus_h_4_x * a3_y);
  const Real n4_x = J_4_xx * t9 + J_4_xz * t699 - (s5 * n5_y - c5 * n5_x + link4_to_5_z * f5_z);
  const Real t703 = c3 * f3_x - s3 * f3_y;
  const Real f2_x = minus_h_2_y * wd2_z - h_2_x * t47 + t703;
  const Real f2_y = h_2_x * wd2_z + minus_h_2_y * t47 + (s3 * f3_x + c3 * f3_y);
  const Real n3_z = J_3_zz * wd3_z + (minus_h_3_y * a3_x - minus_h_3_x * a3_y) +
      (s4 * n4_x + c4 * n4_y);
  tau[2] = n3_z;
  const Real n4_z = J_4_zz * qdd[3] - 0.03561389675370483 * t5 + J_4_xz * t3 + minus_h_4_x *
      minus_a4_y - (s5 * n5_x + c5 * n5_y);

  // links 2 and 3, 5, inward
  tau[3] = n4_z;
  const Real n2_z = J_2_zz * wd2_z + (h_2_x * a2_y + minus_h_2_y * a2_x) +
      (n3_z + minus_link2_to_3_y * t703);
  tau[1] = n2_z;
  const Real n1_z = J_1_zz * qdd[0] + (0.1569597827085 * c1 - 299.6743959432 * s1) +
      (n2_z + minus_link1_to_2_y * (c2 * f2_x - s2 * f2_y));
  tau[0] = n1_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
