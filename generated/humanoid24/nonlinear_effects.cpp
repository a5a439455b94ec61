// SPDX-License-Identifier: 0BSD
// nonlinear_effects: h = b + g: the joint forces at qdd = 0
// By recursive Newton-Euler, Chang table 4.1, alike limbs in lanes.
// 1863 flops (add 863, mul 1000, div 0), sine and cosine of 24 angles
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
void nonlinear_effects(const Real (&TREELINE_RESTRICT q)[24],
    const Real (&TREELINE_RESTRICT qd)[24], Real (&TREELINE_RESTRICT h)[24]) noexcept {
  // constants
  const Real minus_link1_to_2_y = 0.434;
  const Real minus_gravity_z = 9.81;
  const Real minus_link2_to_3_y = 0.422;
  const Real link4_to_5_z = 0.21799999999999997;
  const Real minus_link5_to_6_y = 0.072;
  const Real link21_to_22_z = 0.394;
  const Real J_22_xx = 0.05450270000000001;
  const Real J_22_xy = 0.0074;
  const Real minus_h_22_y = 0.43200000000000005;
  const Real J_22_yy = 0.009438624999999999;
  const Real h_22_x = 0.072575;
  const Real minus_J_21_xz = 0.0016155;
  const Real J_21_xx = 0.005513625;
  const Real J_22_zz = 0.06394132500000001;
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
  const Real h_2_x = 0.031999971599999996;
  const Real minus_h_2_y = 24.5839218;
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
  const Real s2 = sines[1];
  const Real c2 = cosines[1];
  const Real c3 = cosines[2];
  const Real s3 = sines[2];
  const Real c4 = cosines[3];
  const Real s4 = sines[3];
  const Real c5 = cosines[4];
  const Real s5 = sines[4];
  const Real s6 = sines[5];
  const Real c6 = cosines[5];
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
  const Real c12 = cosines[22];
  const Real s12 = sines[22];
  const Real s13 = sines[23];
  const Real c13 = cosines[23];

  // links 2 to 5, outward
  const Real w2_z = qd[0] + qd[1];
  const Real w3_z = w2_z + qd[2];
  const Real t3 = s4 * w3_z;
  const Real wd4_x = w3_z * qd[3];
  const Real w5_z = c4 * w3_z + qd[4];

  // links 5 (chest2) and 6 (chest3), outward
  const Real t4 = c4 * wd4_x;
  const Real minus_wd5_z = s4 * wd4_x;
  const Real minus_w5_y = s5 * t3 + c5 * qd[3];
  const Real w5_x = c5 * t3 - s5 * qd[3];
  const Real t5 = w5_x * minus_w5_y;
  const Real w6_z = w5_x + qd[5];
  const Real t8 = t5 + minus_wd5_z;
  const Real t9 = s5 * t4 + (w5_z + qd[4]) * w5_x;
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real wd5_x = c5 * t4 - minus_w5_y * qd[4];
  const Lanes<2> t12_lanes = 0.0007965395222188762 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(2.0630162081277884e-05, (-2.0630162081277884e-05)) *
      detail::make_pack<Real>(c13, c20);
  const Real t13 = w6_y * w6_z;
  const Real t15 = w6_x * w6_y;

  // links 6 and 7, 14, outward
  const Lanes<2> w7_14_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);
  const Real t17 = w6_x * w6_z;
  const Lanes<2> t18_lanes = detail::make_pack<Real>(s13, s20) * t12_lanes;
  const Real t21 = s6 * t8 + c6 * t9;
  const Lanes<2> w7_14_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;
  const Real t24 = t15 - wd5_x;
  const Lanes<2> w7_14_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;

  // links 6, 8, 15, outward
  const Lanes<2> t27_lanes = 0.0008675855653090935 - t18_lanes;
  const Lanes<2> t28_lanes = 7.104604309021728e-05 + t18_lanes;
  const Real wd6_x = t13 - t21;
  const Lanes<2> w8_15_z_lanes = w7_14_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);
  const Lanes<2> t31_lanes = 0.00011422720754895356 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-2.4414671283021662e-05), 2.4414671283021662e-05) *
      detail::make_pack<Real>(s13, s20);

  // links 1 and 2, 6 and 7, 14, outward
  const Real minus_a1_y = minus_gravity_z * c1;
  const Lanes<2> t34_lanes = w7_14_x_lanes * w7_14_y_lanes;
  const Real minus_a1_x = minus_gravity_z * s1;
  const Real wd6_y = s6 * t9 - c6 * t8 - t17;
  const Real t36 = w2_z * w2_z;
  const Real t37 = t13 + wd6_x;
  const Lanes<2> t39_lanes = w7_14_y_lanes * w7_14_z_lanes;

  // links 3, 7 and 8, 14 and 15, outward
  const Real t44 = w3_z * w3_z;
  const Lanes<2> w8_15_x_lanes = detail::make_pack<Real>(c8, c15) * w7_14_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_14_z_lanes;
  const Lanes<2> t45_lanes = 0.00011422720754895356 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-2.4414671283021662e-05), 2.4414671283021662e-05) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> t47_lanes = t34_lanes + wd6_y;
  const Lanes<2> w8_15_y_lanes = detail::make_pack<Real>(c8, c15) * w7_14_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_14_y_lanes;

  // links 2, 5, 9, 16, outward
  const Real t49 = w5_x * w5_x;
  const Real t50 = w5_z * w5_z;
  const Lanes<2> w9_16_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_15_x_lanes;
  const Lanes<2> t52_lanes = detail::make_pack<Real>(c13, c20) * t12_lanes -
      detail::make_pack<Real>(1.0315081040638942e-05, (-1.0315081040638942e-05));
  const Real t53 = minus_link1_to_2_y * (qd[0] * qd[0]) - minus_a1_y;

  // links 5 to 8, 14 and 15, outward
  const Lanes<2> t55_lanes = detail::make_pack<Real>(s7, s14) * t24 +
      detail::make_pack<Real>(c7, c14) * t37;
  const Real t57 = w6_z * w6_z;
  const Lanes<2> t58_lanes = detail::make_pack<Real>(c7, c14) * t24 -
      detail::make_pack<Real>(s7, s14) * t37;
  const Lanes<2> t59_lanes = w8_15_x_lanes * w8_15_y_lanes;
  const Real t62 = t49 + t50;
  const Real t64 = wd5_x - minus_w5_y * w5_z;
  const Real t65 = minus_wd5_z - t5;

  // links 6 and 7, 9, 14, 16, outward
  const Lanes<2> t66_lanes = 2.0 * (w7_14_x_lanes * w7_14_z_lanes) - t55_lanes;
  const Real t68 = w6_y * w6_y + t57;
  const Real t69 = t17 - wd6_y;
  const Lanes<2> wd7_14_x_lanes = t39_lanes - t58_lanes;
  const Lanes<2> w9_16_y_lanes = detail::make_pack<Real>(c9, c16) * w8_15_y_lanes -
      detail::make_pack<Real>(s9, s16) * w8_15_z_lanes;
  const Lanes<2> w9_16_x_lanes = detail::make_pack<Real>(s9, s16) * w8_15_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_15_z_lanes;

  // links 2 and 3, 6, 8, 15, outward
  const Lanes<2> t71_lanes = w8_15_y_lanes * w8_15_z_lanes;
  const Real a2_y = s2 * minus_a1_x + c2 * t53;
  const Real a2_x = s2 * t53 - c2 * minus_a1_x;
  const Real t73 = t15 + wd5_x;
  const Lanes<2> t75_lanes = t59_lanes + wd7_14_x_lanes;
  const Real t76 = w6_x * w6_x;
  const Real t78 = a2_y + minus_link2_to_3_y * t36;

  // links 6, 8 to 10, 15 to 17, outward
  const Lanes<2> t81_lanes = w9_16_x_lanes * w9_16_y_lanes;
  const Lanes<2> t83_lanes = detail::make_pack<Real>(c8, c15) * t47_lanes +
      detail::make_pack<Real>(s8, s15) * t66_lanes;
  const Lanes<2> w10_17_z_lanes = w9_16_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);
  const Real t86 = t76 + t57;
  const Lanes<2> t87_lanes = detail::make_pack<Real>(c8, c15) * t66_lanes -
      detail::make_pack<Real>(s8, s15) * t47_lanes;
  const Lanes<2> t90_lanes = w9_16_x_lanes * w9_16_z_lanes;

  // links 8, 10, 15, 17, outward
  const Lanes<2> t91_lanes = w8_15_y_lanes * w8_15_y_lanes;
  const Lanes<2> t92_lanes = 2.0 * (w8_15_x_lanes * w8_15_z_lanes) - t83_lanes;
  const Lanes<2> minus_w10_17_y_lanes = detail::make_pack<Real>(s10, s17) * w9_16_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_16_z_lanes;
  const Lanes<2> t93_lanes = w8_15_z_lanes * w8_15_z_lanes;
  const Lanes<2> wd8_15_x_lanes = t71_lanes - t87_lanes;
  const Lanes<2> w10_17_x_lanes = detail::make_pack<Real>(c10, c17) * w9_16_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_16_z_lanes;

  // links 3, 9 to 11, 16 to 18, outward
  const Real a3_x = c3 * a2_x + s3 * t78;
  const Real a3_y = c3 * t78 - s3 * a2_x;
  const Lanes<2> w11_18_z_lanes = minus_w10_17_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);
  const Lanes<2> t100_lanes = t81_lanes + wd8_15_x_lanes;
  const Lanes<2> t103_lanes = w10_17_x_lanes * minus_w10_17_y_lanes;

  // links 5, 8, 10, 15, 17, outward
  const Real t104 = c4 * a3_x;
  const Real t105 = a3_y + link4_to_5_z * t44;
  const Real minus_a5_z = s4 * a3_x;
  const Lanes<2> t106_lanes = t91_lanes + t93_lanes;
  const Lanes<2> t107_lanes = w10_17_x_lanes * w10_17_z_lanes;
  const Lanes<2> t110_lanes = w10_17_x_lanes * w10_17_x_lanes;

  // links 6, 9, 11, 16, 18, outward
  const Lanes<2> t111_lanes = detail::make_pack<Real>(s9, s16) * t92_lanes -
      detail::make_pack<Real>(c9, c16) * t75_lanes;
  const Lanes<2> t113_lanes = detail::make_pack<Real>(s9, s16) * t75_lanes +
      detail::make_pack<Real>(c9, c16) * t92_lanes;
  const Lanes<2> w11_18_y_lanes = detail::make_pack<Real>(c11, c18) * w10_17_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_17_x_lanes;
  const Real t116 = minus_a5_z + minus_link5_to_6_y * t64;
  const Lanes<2> w11_18_x_lanes = detail::make_pack<Real>(c11, c18) * w10_17_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_17_z_lanes;
  const Lanes<2> t117_lanes = 2.0 * (w9_16_y_lanes * w9_16_z_lanes) - t111_lanes;
  const Lanes<2> minus_wd9_16_y_lanes = t113_lanes + t90_lanes;

  // links 5, 10 to 12, 17 to 19, outward
  const Lanes<2> w12_19_z_lanes = w11_18_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);
  const Lanes<2> t122_lanes = w10_17_z_lanes * w10_17_z_lanes;
  const Lanes<2> t124_lanes = w11_18_x_lanes * w11_18_y_lanes;
  const Real a5_y = c5 * t105 - s5 * t104;
  const Real a5_x = c5 * t104 + s5 * t105;
  const Lanes<2> t127_lanes = minus_wd9_16_y_lanes - t103_lanes;
  const Lanes<2> t129_lanes = w11_18_x_lanes * w11_18_z_lanes;
  const Lanes<2> t130_lanes = 2.0 * w12_19_z_lanes;
  const Lanes<2> t132_lanes = t110_lanes + t122_lanes;

  // links 6, 12, 19, outward
  const Lanes<2> t133_lanes = w12_19_z_lanes * w12_19_z_lanes;
  const Lanes<2> t134_lanes = 0.0165153994048813 * detail::make_pack<Real>(s13, s20);
  const Real t135 = a5_y + minus_link5_to_6_y * t62;
  const Real a6_z = a5_x - minus_link5_to_6_y * t65;
  const Lanes<2> w12_19_x_lanes = detail::make_pack<Real>(c12, c19) * w11_18_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_18_z_lanes;
  const Lanes<2> t136_lanes = 0.0165153994048813 * detail::make_pack<Real>(c13, c20);

  // links 10, 12 to 14, 17, 19 and 20, outward
  const Lanes<2> t137_lanes = detail::make_pack<Real>(s10, s17) * t100_lanes +
      detail::make_pack<Real>(c10, c17) * t117_lanes;
  const Lanes<2> t139_lanes = detail::make_pack<Real>(c10, c17) * t100_lanes -
      detail::make_pack<Real>(s10, s17) * t117_lanes;
  const Lanes<2> minus_w12_19_y_lanes = detail::make_pack<Real>(s12, s19) * w11_18_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_18_z_lanes;
  const Real t143 = a6_z - 0.226 * t69;
  const Lanes<2> w13_20_z_lanes = w12_19_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> t144_lanes = t137_lanes - 2.0 * (minus_w10_17_y_lanes * w10_17_z_lanes);
  const Lanes<2> wd10_17_y_lanes = t139_lanes - t107_lanes;

  // links 11 and 12, 18 and 19, outward
  const Lanes<2> t146_lanes = w11_18_y_lanes * w11_18_y_lanes;
  const Lanes<2> t147_lanes = w12_19_x_lanes * minus_w12_19_y_lanes;
  const Lanes<2> t148_lanes = minus_w12_19_y_lanes * w12_19_z_lanes;
  const Lanes<2> t149_lanes = minus_w12_19_y_lanes * minus_w12_19_y_lanes;
  const Lanes<2> t150_lanes = w11_18_x_lanes * w11_18_x_lanes;

  // links 6 and 7, 11, 13 and 14, 18, 20, outward
  const Lanes<2> t151_lanes = t143 + detail::make_pack<Real>(0.18, (-0.18)) * t37;
  const Lanes<2> t154_lanes = w13_20_z_lanes * w13_20_z_lanes;
  const Real a6_x = c6 * t135 - s6 * t116;
  const Real minus_a6_y = s6 * t135 + c6 * t116;
  const Lanes<2> t157_lanes = t124_lanes + wd10_17_y_lanes;

  // links 10 and 11, 14, 17 and 18, outward; links 12 (left_wrist2) and 19 (right_wrist2),
  //   inertial wrench
  const Lanes<2> t159_lanes = t107_lanes - wd10_17_y_lanes;
  const Lanes<2> t164_lanes = t133_lanes - t149_lanes;
  const Real t165 = a6_x + 0.226 * t68;
  const Real t166 = minus_a6_y + 0.226 * t73;
  const Lanes<2> t169_lanes = detail::make_pack<Real>(s11, s18) * t127_lanes -
      detail::make_pack<Real>(c11, c18) * t144_lanes;

  // links 7, 11, 14, 18, outward; links 13 (left_hand) and 20 (right_hand), inward and inertial
  //   wrench
  const Lanes<2> t170_lanes = detail::make_pack<Real>(c11, c18) * t127_lanes +
      detail::make_pack<Real>(s11, s18) * t144_lanes;
  const Lanes<2> t176_lanes = 0.0006000000000000001 + t136_lanes;
  const Lanes<2> t177_lanes = t165 + detail::make_pack<Real>(0.18, (-0.18)) * t24;
  const Lanes<2> minus_a7_14_z_lanes = t166 + detail::make_pack<Real>(0.18, (-0.18)) * t86;
  const Lanes<2> t178_lanes = (t154_lanes - t133_lanes) * t45_lanes;

  // links 11 and 12, 18 and 19, outward
  const Lanes<2> t180_lanes = 2.0 * (w11_18_y_lanes * w11_18_z_lanes) - t169_lanes;
  const Lanes<2> minus_wd11_18_y_lanes = t170_lanes + t129_lanes;
  const Lanes<2> t183_lanes = w11_18_z_lanes * w11_18_z_lanes;
  const Lanes<2> t185_lanes = t124_lanes - wd10_17_y_lanes;
  const Lanes<2> t193_lanes = t147_lanes + minus_wd11_18_y_lanes;
  const Lanes<2> t194_lanes = minus_wd11_18_y_lanes - t147_lanes;
  const Lanes<2> t196_lanes = t129_lanes + minus_wd11_18_y_lanes;

  // links 7, 12 to 14, 19 and 20, outward
  const Lanes<2> a7_14_y_lanes = detail::make_pack<Real>(c7, c14) * t177_lanes -
      detail::make_pack<Real>(s7, s14) * t151_lanes;
  const Lanes<2> a7_14_x_lanes = detail::make_pack<Real>(s7, s14) * t177_lanes +
      detail::make_pack<Real>(c7, c14) * t151_lanes;
  const Lanes<2> t203_lanes = 2.0 * (minus_w12_19_y_lanes * w13_20_z_lanes) - t193_lanes;
  const Lanes<2> t205_lanes = detail::make_pack<Real>(s12, s19) * t157_lanes +
      detail::make_pack<Real>(c12, c19) * t180_lanes;
  const Lanes<2> t206_lanes = detail::make_pack<Real>(c12, c19) * t157_lanes -
      detail::make_pack<Real>(s12, s19) * t180_lanes;
  const Lanes<2> wd12_19_x_lanes = t205_lanes - t148_lanes;

  // links 8, 12 and 13, 15, 19 and 20, outward
  const Lanes<2> t217_lanes = t130_lanes * w12_19_x_lanes - t206_lanes;
  const Lanes<2> minus_a8_15_y_lanes = detail::make_pack<Real>(s8, s15) * a7_14_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_14_z_lanes;
  const Lanes<2> a8_15_x_lanes = detail::make_pack<Real>(c8, c15) * a7_14_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_14_z_lanes;
  const Lanes<2> t229_lanes = t130_lanes * w13_20_z_lanes - t217_lanes;
  const Lanes<2> t231_lanes = wd12_19_x_lanes - t148_lanes;

  // links 13 (left_hand) and 20 (right_hand), inertial wrench; links 9 and 10, 16 and 17, outward
  const Lanes<2> t233_lanes = (t149_lanes - t154_lanes) * t31_lanes;
  const Lanes<2> t239_lanes = 0.282 * t106_lanes - a8_15_x_lanes;
  const Lanes<2> minus_f13_20_x_lanes = (t133_lanes + t154_lanes) * t136_lanes + t205_lanes *
      t134_lanes;
  const Lanes<2> a9_16_x_lanes = detail::make_pack<Real>(c9, c16) * a7_14_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_15_y_lanes;
  const Lanes<2> minus_a9_16_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_15_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_14_x_lanes;
  const Lanes<2> t253_lanes = 0.0009386316083993107 * wd12_19_x_lanes - t148_lanes *
      (t27_lanes - t28_lanes) + t217_lanes * t31_lanes;

  // links 13 (left_hand) and 20 (right_hand), inertial wrench and inward; links 10 (left_lowerarm)
  //   and 17 (right_lowerarm), outward
  const Lanes<2> f13_20_z_lanes = t229_lanes * t134_lanes - t203_lanes * t136_lanes;
  const Lanes<2> minus_f12_19_y_lanes = 0.0025100003499999995 * t193_lanes + 0.0006000000000000001 *
      (w12_19_x_lanes * w12_19_x_lanes + t133_lanes) + minus_f13_20_x_lanes;
  const Lanes<2> t261_lanes = a9_16_x_lanes + 0.282 * t113_lanes;
  const Lanes<2> minus_a10_17_z_lanes = minus_a9_16_y_lanes + 0.282 * t111_lanes;
  const Lanes<2> t264_lanes = t203_lanes * t27_lanes - t205_lanes * t45_lanes - t229_lanes *
      t52_lanes + t233_lanes;

  // links 13 (left_hand) and 20 (right_hand), inward; links 11, 13, 18, 20, inertial wrench
  const Lanes<2> f12_19_x_lanes = 0.0006000000000000001 * t194_lanes - 0.0025100003499999995 *
      (t149_lanes + t133_lanes) + f13_20_z_lanes;
  const Lanes<2> t276_lanes = t229_lanes * t28_lanes - t203_lanes * t52_lanes - t231_lanes *
      t31_lanes + t178_lanes;
  const Lanes<2> f12_19_z_lanes = 0.0025100003499999995 * t217_lanes - (t149_lanes + t154_lanes) *
      t134_lanes + t176_lanes * t231_lanes;
  const Lanes<2> t283_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (t183_lanes - t146_lanes);
  const Lanes<2> t284_lanes = 0.000144 * (t150_lanes - t183_lanes);

  // links 10, 12, 17, 19, outward; links 12 (left_wrist2) and 19 (right_wrist2), inward
  const Lanes<2> a10_17_x_lanes = detail::make_pack<Real>(c10, c17) * t261_lanes -
      detail::make_pack<Real>(s10, s17) * t239_lanes;
  const Lanes<2> minus_a10_17_y_lanes = detail::make_pack<Real>(s10, s17) * t261_lanes +
      detail::make_pack<Real>(c10, c17) * t239_lanes;
  const Lanes<2> t288_lanes = detail::make_pack<Real>(c12, c19) * f12_19_x_lanes +
      detail::make_pack<Real>(s12, s19) * minus_f12_19_y_lanes;
  const Lanes<2> t289_lanes = minus_w10_17_y_lanes * minus_w10_17_y_lanes;
  const Lanes<2> t297_lanes = minus_a10_17_y_lanes + 0.269 * t132_lanes;

  // links 13 (left_hand) and 20 (right_hand), inward; links 11 (left_wrist1) and 18
  //   (right_wrist1), inertial wrench; links 10 (left_lowerarm) and 17 (right_lowerarm), outward
  const Lanes<2> t299_lanes = t264_lanes - 0.000183627662257343 * t147_lanes -
      0.000206827662257343 * minus_wd11_18_y_lanes - detail::make_pack<Real>(2.4000000000000003e-06,
      (-2.4000000000000003e-06)) * t206_lanes;
  const Lanes<2> t303_lanes = 0.0001194 * t180_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      t196_lanes + 0.000144 * t185_lanes + t283_lanes;
  const Lanes<2> t304_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) * t157_lanes -
      0.0001098 * t196_lanes - detail::make_pack<Real>(6e-06, (-6e-06)) * t180_lanes - t284_lanes;
  const Lanes<2> t305_lanes = t103_lanes + minus_wd9_16_y_lanes;
  const Lanes<2> t306_lanes = 9.6e-06 * t124_lanes + 0.00022920000000000001 * wd10_17_y_lanes +
      0.000144 * t169_lanes;

  // links 12 (left_wrist2) and 19 (right_wrist2), inward; links 11 and 12, 18 and 19, outward
  const Lanes<2> f11_18_x_lanes = detail::make_pack<Real>(0.001, (-0.001)) * t157_lanes - 6e-04 *
      (t146_lanes + t183_lanes) + t288_lanes;
  const Lanes<2> f11_18_y_lanes = 6e-04 * t185_lanes - detail::make_pack<Real>(0.001, (-0.001)) *
      (t150_lanes + t183_lanes) + f12_19_z_lanes;
  const Lanes<2> a11_18_x_lanes = detail::make_pack<Real>(c11, c18) * a10_17_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_17_z_lanes;
  const Lanes<2> minus_a11_18_y_lanes = detail::make_pack<Real>(s11, s18) * a10_17_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_17_z_lanes;
  const Lanes<2> t320_lanes = a11_18_x_lanes + 0.269 * t170_lanes;

  // links 12 (left_wrist2) and 19 (right_wrist2), outward; links 10 and 11, 17 and 18, inertial
  //   wrench; links 12 (left_wrist2) and 19 (right_wrist2), inward
  const Lanes<2> minus_a12_19_z_lanes = minus_a11_18_y_lanes + 0.269 * t169_lanes;
  const Lanes<2> t340_lanes = detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      (t110_lanes - t122_lanes);
  const Lanes<2> t341_lanes = detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      (t122_lanes - t289_lanes);
  const Lanes<2> t342_lanes = detail::make_pack<Real>(c12, c19) * minus_f12_19_y_lanes -
      detail::make_pack<Real>(s12, s19) * f12_19_x_lanes;
  const Lanes<2> t344_lanes = 6e-04 * minus_a11_18_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_18_x_lanes;

  // links 9, 12, 16, 19, outward
  const Lanes<2> minus_a12_19_y_lanes = detail::make_pack<Real>(s12, s19) * t320_lanes +
      detail::make_pack<Real>(c12, c19) * t297_lanes;
  const Lanes<2> a12_19_x_lanes = detail::make_pack<Real>(c12, c19) * t320_lanes -
      detail::make_pack<Real>(s12, s19) * t297_lanes;
  const Lanes<2> t351_lanes = w9_16_y_lanes * w9_16_y_lanes;
  const Lanes<2> t352_lanes = w9_16_z_lanes * w9_16_z_lanes;
  const Lanes<2> t354_lanes = w9_16_x_lanes * w9_16_x_lanes;

  // links 11 and 12, 18 and 19, inward; links 10 and 11, 17 and 18, inertial wrench
  const Lanes<2> t361_lanes = detail::make_pack<Real>(c11, c18) * f11_18_x_lanes -
      detail::make_pack<Real>(s11, s18) * f11_18_y_lanes;
  const Lanes<2> f11_18_z_lanes = 6e-04 * t196_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      t180_lanes + t342_lanes;
  const Lanes<2> t364_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) * t170_lanes -
      t306_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) * (t146_lanes - t150_lanes) -
      t344_lanes;
  const Lanes<2> t365_lanes = detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      t127_lanes - 0.00028099984685315 * t159_lanes - 0.0001499998887063 * t144_lanes + t340_lanes;
  const Lanes<2> t366_lanes = 0.06060754126741261 * t144_lanes + 0.0001499998887063 * t159_lanes +
      detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) * t305_lanes + t341_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), outward; links 10, 13, 17, 20, inertial
  //   wrench
  const Lanes<2> t367_lanes = t90_lanes + minus_wd9_16_y_lanes;
  const Lanes<2> t368_lanes = detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      t139_lanes;
  const Lanes<2> t372_lanes = t134_lanes * minus_a12_19_y_lanes - t136_lanes * minus_a12_19_z_lanes;
  const Lanes<2> n13_20_x_lanes = t276_lanes + t134_lanes * a12_19_x_lanes;
  const Lanes<2> t377_lanes = t81_lanes - wd8_15_x_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), inward; links 13 (left_hand) and 20
  //   (right_hand), inertial wrench
  const Lanes<2> f10_17_x_lanes = 0.28049749700000004 * t127_lanes - 0.0014999985000000002 *
      (t289_lanes + t122_lanes) + t361_lanes;
  const Lanes<2> minus_f10_17_y_lanes = 0.0014999985000000002 * t305_lanes + 0.28049749700000004 *
      t132_lanes + f11_18_z_lanes;
  const Lanes<2> n13_20_z_lanes = t253_lanes + t193_lanes * t45_lanes + t164_lanes * t52_lanes +
      t372_lanes;
  h[12] = n13_20_z_lanes[0];
  h[19] = n13_20_z_lanes[1];

  // links 13 (left_hand) and 20 (right_hand), inward; links 10 (left_lowerarm) and 17
  //   (right_lowerarm), inertial wrench
  const Lanes<2> n12_19_y_lanes = detail::make_pack<Real>(2.4000000000000003e-06,
      (-2.4000000000000003e-06)) * t194_lanes - 0.000195227662257343 * t217_lanes +
      0.0025100003499999995 * minus_a12_19_z_lanes + n13_20_x_lanes;
  const Lanes<2> n12_19_z_lanes = t299_lanes - 0.0025100003499999995 * minus_a12_19_y_lanes -
      t176_lanes * a12_19_x_lanes;
  h[11] = n12_19_z_lanes[0];
  h[18] = n12_19_z_lanes[1];
  const Lanes<2> t387_lanes = 0.06032654142055946 * t103_lanes - 0.060888541114265754 *
      minus_wd9_16_y_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      t137_lanes - t368_lanes;
  const Lanes<2> n12_19_x_lanes = 1.16e-05 * t231_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * t164_lanes -
      0.0006000000000000001 * minus_a12_19_z_lanes + n13_20_z_lanes;

  // links 11 and 12, 18 and 19, inward; links 10 (left_lowerarm) and 17 (right_lowerarm), inertial
  //   wrench; links 8 (left_shoulder2) and 15 (right_shoulder2), outward
  const Lanes<2> t393_lanes = detail::make_pack<Real>(s11, s18) * f11_18_x_lanes +
      detail::make_pack<Real>(c11, c18) * f11_18_y_lanes;
  const Lanes<2> n11_18_y_lanes = t304_lanes - 6e-04 * minus_a10_17_y_lanes +
      (n12_19_z_lanes - 0.269 * t288_lanes);
  const Lanes<2> t403_lanes = 0.0014999985000000002 * minus_a10_17_y_lanes + 0.28049749700000004 *
      a10_17_x_lanes;
  const Lanes<2> t407_lanes = w8_15_x_lanes * w8_15_x_lanes;
  const Lanes<2> f10_17_z_lanes = 0.0014999985000000002 * t159_lanes + 0.28049749700000004 *
      t144_lanes + t393_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), inertial wrench; links 10 (left_lowerarm) and
  //   17 (right_lowerarm), inward; links 8 (left_shoulder2) and 15 (right_shoulder2), outward
  const Lanes<2> t408_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * (t352_lanes - t351_lanes);
  const Lanes<2> t409_lanes = detail::make_pack<Real>(c10, c17) * f10_17_x_lanes +
      detail::make_pack<Real>(s10, s17) * minus_f10_17_y_lanes;
  const Lanes<2> t410_lanes = 0.0005895000784280001 * (t354_lanes - t352_lanes);
  const Lanes<2> t418_lanes = t59_lanes - wd7_14_x_lanes;
  const Lanes<2> t419_lanes = t71_lanes + wd8_15_x_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), inertial wrench; links 12 (left_wrist2) and
  //   19 (right_wrist2), inward
  const Lanes<2> t426_lanes = 0.0019585440854647937 * t117_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * t367_lanes -
      0.0005895000784280001 * t377_lanes + t408_lanes;
  const Lanes<2> t427_lanes = 0.269 * f12_19_z_lanes -
      (detail::make_pack<Real>(s12, s19) * n12_19_y_lanes - detail::make_pack<Real>(c12, c19) *
      n12_19_x_lanes);
  const Lanes<2> n11_18_z_lanes = t364_lanes - (detail::make_pack<Real>(s12, s19) * n12_19_x_lanes +
      detail::make_pack<Real>(c12, c19) * n12_19_y_lanes);
  h[10] = n11_18_z_lanes[0];
  h[17] = n11_18_z_lanes[1];
  const Lanes<2> t432_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * t100_lanes - 0.0008177492704690715 * t367_lanes -
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * t117_lanes +
      t410_lanes;
  const Lanes<2> t437_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * t113_lanes;
  const Lanes<2> n11_18_x_lanes = t303_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      minus_a10_17_y_lanes + t427_lanes;

  // links 10 and 11, 17 and 18, inward; link 21 (neck), outward
  const Lanes<2> n10_17_y_lanes = t365_lanes + 0.0014999985000000002 * minus_a10_17_z_lanes -
      n11_18_z_lanes;
  const Lanes<2> t466_lanes = detail::make_pack<Real>(s11, s18) * n11_18_x_lanes +
      detail::make_pack<Real>(c11, c18) * n11_18_y_lanes;
  const Real w21_z = qd[20] - w6_x;
  const Lanes<2> f9_16_x_lanes = 0.0022500062 * (t351_lanes + t352_lanes) +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * t100_lanes + t409_lanes;
  const Lanes<2> t469_lanes = detail::make_pack<Real>(c10, c17) * minus_f10_17_y_lanes -
      detail::make_pack<Real>(s10, s17) * f10_17_x_lanes;
  const Lanes<2> n10_17_x_lanes = t366_lanes - 0.28049749700000004 * minus_a10_17_z_lanes +
      (detail::make_pack<Real>(c11, c18) * n11_18_x_lanes - detail::make_pack<Real>(s11, s18) *
      n11_18_y_lanes);
  const Lanes<2> f9_16_y_lanes = f10_17_z_lanes - (0.0022500062 * t377_lanes +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * (t354_lanes + t352_lanes));

  // link 21 (neck), outward; links 11 (left_wrist1) and 18 (right_wrist1), inward
  const Real t472 = s21 * t73 + c21 * t69;
  const Real w21_x = s21 * w6_y + c21 * w6_z;
  const Lanes<2> n10_17_z_lanes = t387_lanes + 0.0001499998887063 * (t289_lanes - t110_lanes) -
      t403_lanes + t466_lanes;
  h[9] = n10_17_z_lanes[0];
  h[16] = n10_17_z_lanes[1];

  // links 7, 14, 21, outward; links 9 (left_upperarm) and 16 (right_upperarm), inertial wrench
  const Lanes<2> t476_lanes = t39_lanes + wd7_14_x_lanes;
  const Lanes<2> t478_lanes = 0.0005895000784280001 * t111_lanes -
      (0.0011407948149957223 * t81_lanes + 0.0027762933559338653 * wd8_15_x_lanes) + t437_lanes;
  const Real t480 = w21_x * w21_z;
  const Real w21_y = c21 * w6_y - s21 * w6_z;
  const Lanes<2> t483_lanes = w7_14_y_lanes * w7_14_y_lanes;
  const Lanes<2> t484_lanes = w7_14_z_lanes * w7_14_z_lanes;

  // links 7, 14, 21, outward; links 8 (left_shoulder2) and 15 (right_shoulder2), inertial wrench;
  //   links 10 (left_lowerarm) and 17 (right_lowerarm), inward
  const Real t485 = s21 * t69 - c21 * t73;
  const Lanes<2> t487_lanes = w7_14_x_lanes * w7_14_x_lanes;
  const Lanes<2> t488_lanes = 0.00010499999999999999 * (t407_lanes - t93_lanes);
  const Lanes<2> n9_16_y_lanes = t432_lanes - 0.0022500062 * a8_15_x_lanes +
      (n10_17_z_lanes - 0.282 * t409_lanes);
  const Lanes<2> t491_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (t93_lanes - t91_lanes);

  // links 21 (neck) and 22 (head), outward
  const Real t492 = w21_x * w21_y;
  const Real w22_x = c22 * w21_x - s22 * w21_z;
  const Real w22_z = w21_y + qd[21];
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;
  const Real minus_wd21_y = t472 + t480;

  // links 9 and 10, 16 and 17, inward; links 21 (neck) and 22 (head), outward
  const Lanes<2> t493_lanes = 0.282 * f10_17_z_lanes -
      (detail::make_pack<Real>(s10, s17) * n10_17_y_lanes - detail::make_pack<Real>(c10, c17) *
      n10_17_x_lanes);
  const Lanes<2> f9_16_z_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      t117_lanes - 0.0022500062 * t367_lanes + t469_lanes;
  const Lanes<2> t495_lanes = detail::make_pack<Real>(s9, s16) * f9_16_x_lanes +
      detail::make_pack<Real>(c9, c16) * f9_16_y_lanes;
  const Real t498 = w22_x * w22_z;
  const Real t502 = t492 + wd6_x;

  // links 22 to 24, outward; links 10 (left_lowerarm) and 17 (right_lowerarm), inward; links 8
  //   (left_shoulder2) and 15 (right_shoulder2), inertial wrench
  const Real t503 = w22_x * minus_w22_y;
  const Lanes<2> w23_24_z_lanes = minus_w22_y + detail::make_pack<Real>(qd[22], qd[23]);
  const Lanes<2> n9_16_x_lanes = t426_lanes - detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) * a8_15_x_lanes + t493_lanes;
  const Lanes<2> t506_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * t83_lanes;
  const Lanes<2> w23_24_y_lanes = detail::make_pack<Real>(c23, c24) * w22_z -
      detail::make_pack<Real>(s23, s24) * w22_x;

  // links 21 to 24, outward
  const Real t507 = 2.0 * (w21_y * w21_z) - t485;
  const Real t508 = minus_wd21_y - t503;
  const Lanes<2> t509_lanes = 2.0 * w23_24_z_lanes;
  const Real t510 = a6_x + link21_to_22_z * t68;
  const Lanes<2> w23_24_x_lanes = detail::make_pack<Real>(c23, c24) * w22_x +
      detail::make_pack<Real>(s23, s24) * w22_z;
  const Real t511 = t503 + minus_wd21_y;
  const Lanes<2> t512_lanes = w23_24_z_lanes * w23_24_z_lanes;
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;
  const Lanes<2> t517_lanes = w23_24_x_lanes * w23_24_y_lanes;
  const Real t518 = a21_x - link21_to_22_z * t472;

  // links 9 (left_upperarm) and 16 (right_upperarm), inertial wrench; links 21 (neck) and 22
  //   (head), outward
  const Lanes<2> t524_lanes = 0.0022500062 * minus_a9_16_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_16_x_lanes;
  const Real t525 = c22 * t502 - s22 * t507;
  const Real t526 = s22 * t502 + c22 * t507;
  const Real t528 = w21_x * w21_x;
  const Real t529 = w21_z * w21_z;
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;

  // links 7, 14, 22, outward
  const Real t533 = minus_w22_y * minus_w22_y;
  const Real t534 = w22_z * w22_z;
  const Real wd22_y = t525 - t498;
  const Real t535 = t526 - 2.0 * (minus_w22_y * w22_z);
  const Real a22_z = link21_to_22_z * t485 - minus_a21_y;
  const Lanes<2> t538_lanes = t34_lanes - wd6_y;

  // links 21 (neck) and 22 (head), outward
  const Real t539 = t528 + t529;
  const Real a22_y = c22 * t510 - s22 * t518;
  const Real t542 = t498 - wd22_y;
  const Real a22_x = c22 * t518 + s22 * t510;
  const Real t545 = t533 + t534;

  // links 23 (left_eye) and 24 (right_eye), outward and inertial wrench
  const Lanes<2> t546_lanes = t517_lanes - wd22_y;
  const Real t547 = 9.25e-06 * wd22_y;
  const Real t550 = a22_y - 0.095 * t511;
  const Lanes<2> t552_lanes = detail::make_pack<Real>(s23, s24) * t508 -
      detail::make_pack<Real>(c23, c24) * t535;
  const Lanes<2> f23_24_y_lanes = 0.00025 * t546_lanes;
  const Lanes<2> minus_a23_24_z_lanes = t550 - detail::make_pack<Real>(0.032, (-0.032)) * t526;
  const Real t559 = a22_z + 0.095 * t542;
  const Lanes<2> t560_lanes = detail::make_pack<Real>(c23, c24) * t508 +
      detail::make_pack<Real>(s23, s24) * t535 + t509_lanes * w23_24_x_lanes;
  const Real t563 = a22_x - 0.095 * t545;
  const Lanes<2> t564_lanes = 0.00025 * minus_a23_24_z_lanes;
  const Lanes<2> minus_f23_24_x_lanes = 0.00025 * (w23_24_y_lanes * w23_24_y_lanes + t512_lanes);

  // links 9 (left_upperarm) and 16 (right_upperarm), inward; links 23 (left_eye) and 24
  //   (right_eye), outward; links 8, 15, 23 and 24, inertial wrench
  const Lanes<2> f8_15_x_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * t418_lanes - 0.7139200499999999 * t106_lanes - f9_16_z_lanes;
  const Lanes<2> f8_15_y_lanes = 0.7139200499999999 * t75_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (t407_lanes + t93_lanes) + t495_lanes;
  const Lanes<2> t580_lanes = detail::make_pack<Real>(s23, s24) *
      (t563 + detail::make_pack<Real>(0.032, (-0.032)) * t525);
  const Lanes<2> n23_24_x_lanes = 4e-06 * (t509_lanes * w23_24_y_lanes - t552_lanes) -
      2.8750000000000004e-05 * t546_lanes;
  const Lanes<2> t587_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * t418_lanes -
      0.18113119219699997 * t92_lanes - detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * t419_lanes + t488_lanes;

  // links 10, 17, 23 and 24, inward; links 23 (left_eye) and 24 (right_eye), inertial wrench and
  //   outward
  const Lanes<2> t588_lanes = detail::make_pack<Real>(s10, s17) * n10_17_x_lanes +
      detail::make_pack<Real>(c10, c17) * n10_17_y_lanes;
  const Lanes<2> n23_24_y_lanes = 2.8750000000000004e-05 *
      (w23_24_x_lanes * w23_24_x_lanes - t512_lanes) - 5.25e-06 * t560_lanes + t564_lanes;
  const Lanes<2> t589_lanes = detail::make_pack<Real>(c23, c24) * minus_f23_24_x_lanes +
      detail::make_pack<Real>(s23, s24) * f23_24_y_lanes;
  const Lanes<2> t591_lanes = detail::make_pack<Real>(c23, c24) * f23_24_y_lanes -
      detail::make_pack<Real>(s23, s24) * minus_f23_24_x_lanes;
  const Lanes<2> a23_24_y_lanes = detail::make_pack<Real>(c23, c24) *
      (t559 - detail::make_pack<Real>(0.032, (-0.032)) * t539) - t580_lanes;

  // links 21 (neck) and 22 (head), outward; links 8 (left_shoulder2) and 15 (right_shoulder2),
  //   inertial wrench; link 23 (left_eye), inward
  const Real t592 = t492 - wd6_x;
  const Lanes<2> t594_lanes = 0.00012075 * t419_lanes +
      detail::make_pack<Real>(5.2499999999999995e-05, (-5.2499999999999995e-05)) * t92_lanes -
      0.00010499999999999999 * t75_lanes + t491_lanes;
  const Real t600 = w22_x * w22_x;
  const Real t601 = t591_lanes[1] + t591_lanes[0];
  const Lanes<2> t602_lanes = 0.18101044219699997 * t59_lanes + 0.18125194219699997 *
      wd7_14_x_lanes + 0.00010499999999999999 * t87_lanes - t506_lanes;

  // links 23 (left_eye) and 24 (right_eye), inward and inertial wrench
  const Lanes<2> t604_lanes = detail::make_pack<Real>(s23, s24) * n23_24_x_lanes;
  const Lanes<2> t607_lanes = detail::make_pack<Real>(c23, c24) * n23_24_y_lanes;
  const Lanes<2> n23_24_z_lanes = 1.25e-06 * t517_lanes - t547 + 2.8750000000000004e-05 *
      t552_lanes + 0.00025 * a23_24_y_lanes;
  h[22] = n23_24_z_lanes[0];
  h[23] = n23_24_z_lanes[1];
  const Real t609 = t560_lanes[1] + t560_lanes[0];
  const Real f22_z = h_22_x * t542 - minus_h_22_y * t535 + t601;

  // links 9, 16, 23 and 24, inward; link 21 (neck), outward; links 7 (left_shoulder1) and 14
  //   (right_shoulder1), inertial wrench
  const Lanes<2> t611_lanes = detail::make_pack<Real>(c23, c24) * n23_24_x_lanes -
      detail::make_pack<Real>(s23, s24) * n23_24_y_lanes +
      detail::make_pack<Real>(8.000000000000001e-06, (-8.000000000000001e-06)) * t560_lanes;
  const Lanes<2> t612_lanes = detail::make_pack<Real>(s9, s16) * f9_16_y_lanes;
  const Real t615 = t480 + minus_wd21_y;
  const Real t616 = J_22_xy * t535 - J_22_yy * t542 - h_22_x * a22_z - n23_24_z_lanes[1] -
      (-0.032) * t589_lanes[1];
  const Lanes<2> t618_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (t484_lanes - t483_lanes);

  // links 10, 17, 23, inward
  const Lanes<2> n9_16_z_lanes = t478_lanes + detail::make_pack<Real>((-4.4999986458742003e-05),
      4.4999986458742003e-05) * (t351_lanes - t354_lanes) + t524_lanes - t588_lanes;
  h[8] = n9_16_z_lanes[0];
  h[15] = n9_16_z_lanes[1];
  const Real n22_x = J_22_xx * t535 - J_22_xy * t542 - minus_h_22_y * a22_z + t611_lanes[1] +
      t611_lanes[0];
  const Real t624 = 0.04506407500000001 * t503 - J_22_zz * minus_wd21_y - J_22_xy * (t533 - t600) +
      h_22_x * a22_y;

  // links 7 and 8, 15, inertial wrench; link 23 (left_eye), inward
  const Real t627 = 0.000448 * wd6_y;
  const Real minus_f22_x = h_22_x * t545 + minus_h_22_y * t508 + t589_lanes[1] + t589_lanes[0];
  const Real f22_y = minus_h_22_y * (t600 + t534) - h_22_x * t511 - 0.00025 * t609;
  const Lanes<2> t628_lanes = 0.7139200499999999 * minus_a8_15_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_15_x_lanes;
  const Real n22_y = t616 - n23_24_z_lanes[0] - 0.032 * t589_lanes[0] - 0.095 * t601;

  // links 8 and 9, 15 and 16, 22, inward; links 7 (left_shoulder1) and 14 (right_shoulder1),
  //   inertial wrench
  const Lanes<2> t632_lanes = 0.0017499999999999998 * (t47_lanes + (t487_lanes + t484_lanes));
  const Lanes<2> t637_lanes = 0.0017499999999999998 * minus_a7_14_z_lanes;
  const Lanes<2> n8_15_y_lanes = t587_lanes - 0.7139200499999999 * a7_14_x_lanes +
      (detail::make_pack<Real>(s9, s16) * n9_16_x_lanes + detail::make_pack<Real>(c9, c16) *
      n9_16_y_lanes);
  const Lanes<2> n8_15_x_lanes = t594_lanes + detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_14_x_lanes - n9_16_z_lanes;
  const Lanes<2> t638_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (t487_lanes - t484_lanes);
  const Lanes<2> t640_lanes = 0.7139200499999999 * t92_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * t419_lanes +
      detail::make_pack<Real>(c9, c16) * f9_16_x_lanes - t612_lanes;
  const Real t641 = c22 * minus_f22_x + s22 * f22_y;
  const Lanes<2> t644_lanes = detail::make_pack<Real>(c9, c16) * n9_16_x_lanes -
      detail::make_pack<Real>(s9, s16) * n9_16_y_lanes;
  const Lanes<2> t646_lanes = 0.0001505 * t476_lanes + 8.75e-06 * t66_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * t47_lanes +
      t618_lanes;

  // links 8 and 9, 15 and 16, inward
  const Lanes<2> f7_14_y_lanes = detail::make_pack<Real>(c8, c15) * f8_15_x_lanes -
      detail::make_pack<Real>(s8, s15) * f8_15_y_lanes + t632_lanes;
  const Lanes<2> f7_14_x_lanes = t640_lanes - 0.0017499999999999998 *
      (t483_lanes + t484_lanes + t538_lanes);
  const Lanes<2> n8_15_z_lanes = t602_lanes + detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * (t91_lanes - t407_lanes) - t628_lanes + t644_lanes;
  h[7] = n8_15_z_lanes[0];
  h[14] = n8_15_z_lanes[1];

  // links 7 (left_shoulder1) and 14 (right_shoulder1), inertial wrench; links 8, 15, 22 and 23,
  //   inward
  const Lanes<2> t655_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * t538_lanes - 0.0002975 * t66_lanes - 8.75e-06 * t476_lanes +
      t638_lanes;
  const Lanes<2> f7_14_z_lanes = detail::make_pack<Real>(s8, s15) * f8_15_x_lanes +
      detail::make_pack<Real>(c8, c15) * f8_15_y_lanes + 0.0017499999999999998 *
      (t66_lanes - t476_lanes);
  const Real n22_z = t624 + minus_h_22_y * a22_x + t604_lanes[1] + t607_lanes[1] + t604_lanes[0] +
      t607_lanes[0] - 2.375e-05 * t609;
  h[21] = n22_z;
  const Real n21_x = J_21_xx * t507 - minus_J_21_xz * t592 -
      (s22 * n22_y - c22 * n22_x + link21_to_22_z * f22_z);
  const Real minus_f21_x = h_21_x * (w21_y * w21_y + t529) + t641;
  const Lanes<2> n7_14_x_lanes = t646_lanes + t637_lanes + n8_15_z_lanes;
  const Lanes<2> t664_lanes = 0.000147 * t34_lanes + t627 +
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * t58_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * t55_lanes;

  // links 7 (left_shoulder1) and 22 (head), inward
  const Real t665 = f7_14_z_lanes[1] + f7_14_z_lanes[0];
  const Real n21_y = minus_J_21_xz * (t528 - t529) - J_21_yy * t615 + h_21_x * a6_x +
      (n22_z - link21_to_22_z * t641);
  const Real f21_z = h_21_x * t615 + (s22 * minus_f22_x - c22 * f22_y);
  const Real t667 = 1.26882463592404 * t15 + J_6_zz * wd5_x - J_6_xz * t21 + minus_h_6_x *
      minus_a6_y + c21 * n21_x;
  const Real f21_y = h_21_x * t592 + f22_z;

  // links 7 and 8, 14 and 15, inward; link 5 (chest2), outward
  const Lanes<2> n7_14_y_lanes = t655_lanes + t637_lanes +
      (detail::make_pack<Real>(c8, c15) * n8_15_x_lanes - detail::make_pack<Real>(s8, s15) *
      n8_15_y_lanes);
  const Lanes<2> t669_lanes = detail::make_pack<Real>(c7, c14) * n7_14_x_lanes;
  const Lanes<2> t670_lanes = detail::make_pack<Real>(s7, s14) * f7_14_x_lanes +
      detail::make_pack<Real>(c7, c14) * f7_14_y_lanes;
  const Lanes<2> t671_lanes = detail::make_pack<Real>(c7, c14) * f7_14_x_lanes -
      detail::make_pack<Real>(s7, s14) * f7_14_y_lanes;
  const Lanes<2> t672_lanes = detail::make_pack<Real>(c8, c15) * n8_15_y_lanes;
  const Real t674 = minus_w5_y * minus_w5_y;
  const Lanes<2> t676_lanes = detail::make_pack<Real>(s7, s14) * n7_14_y_lanes;
  const Real t677 = t671_lanes[1] + t671_lanes[0];
  const Lanes<2> t681_lanes = t664_lanes + 8.75e-06 * (t483_lanes - t487_lanes) +
      detail::make_pack<Real>(s8, s15) * n8_15_x_lanes + t672_lanes;

  // links 7 (left_shoulder1) and 22 (head), inward
  const Real t682 = minus_h_6_x * a6_z - J_6_yy * t69 - J_6_xz * (t76 - t57) + s21 * n21_x;
  const Real f6_x = minus_h_6_x * t68 - f21_z + t670_lanes[1] + t670_lanes[0];
  const Real f6_y = t665 - minus_h_6_x * t73 - s21 * minus_f21_x + c21 * f21_y;
  const Real n21_z = minus_J_21_xz * t485 - (0.0048105000000000005 * t492 + J_21_zz * wd6_x) -
      h_21_x * minus_a21_y - (s22 * n22_x + c22 * n22_y);
  h[20] = n21_z;

  // links 7 and 8, 14 and 15, inward
  const Lanes<2> n7_14_z_lanes = t681_lanes + 0.0017499999999999998 *
      (a7_14_y_lanes + a7_14_x_lanes);
  h[6] = n7_14_z_lanes[0];
  h[13] = n7_14_z_lanes[1];
  const Lanes<2> t685_lanes = detail::make_pack<Real>(s7, s14) * n7_14_x_lanes +
      detail::make_pack<Real>(c7, c14) * n7_14_y_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      t671_lanes;
  const Real f6_z = t677 - minus_h_6_x * t69 - c21 * minus_f21_x - s21 * f21_y;

  // links 6 (chest3) and 7 (left_shoulder1), inward; link 4 (chest1), outward
  const Real t686 = t667 - s21 * n21_y + t669_lanes[1] - t676_lanes[1] - (-0.18) * t670_lanes[1] +
      t669_lanes[0] - t676_lanes[0];
  const Real f5_y = minus_h_5_y * t62 - h_5_x * t8 + (c6 * f6_x - s6 * f6_y);
  const Real t687 = s6 * f6_x + c6 * f6_y;
  const Real f5_x = f6_z - (h_5_x * (t674 + t50) + minus_h_5_y * t65);
  const Real n6_x = J_6_xx * t37 + J_6_xz * t73 - n21_z + t685_lanes[1] + t685_lanes[0];
  const Real n6_y = t682 + c21 * n21_y + n7_14_z_lanes[1] + n7_14_z_lanes[0] + 0.226 * t677;
  const Real t688 = qd[3] * qd[3];
  const Real t689 = 2.0 * wd4_x;
  const Real f5_z = h_5_x * t9 - minus_h_5_y * t64 + t687;
  const Real n6_z = t686 - 0.18 * t670_lanes[0] - 0.226 * t665;
  h[5] = n6_z;
  const Real t690 = minus_h_4_x * c4;
  const Real t691 = minus_h_4_x * s4;
  const Real n5_y = J_5_xy * t64 - J_5_yy * t9 + h_5_x * minus_a5_z + (c6 * n6_x - s6 * n6_y);
  const Real n5_x = J_5_xx * t64 - J_5_xy * t9 + minus_h_5_y * minus_a5_z +
      (n6_z - minus_link5_to_6_y * t687);

  // link 5 (chest2), inward and inertial wrench
  const Real t692 = c4 * (0.03561389675370483 * s4);
  const Real t693 = c4 * (s5 * f5_y - c5 * f5_x) + s4 * f5_z;
  const Real minus_f4_z = t689 * t691 + (s5 * f5_x + c5 * f5_y);
  const Real t694 = 0.10961925816937634 * t5 - J_5_zz * minus_wd5_z - J_5_xy * (t674 - t49) +
      (h_5_x * a5_y + minus_h_5_y * a5_x);
  const Real f4_x = (t44 + t688) * t690 - t693;

  // links 4 (chest1) and 6 (chest3), inward
  const Real f3_y = minus_h_3_y * t44 + minus_f4_z;
  const Real n5_z = t694 + (s6 * n6_x + c6 * n6_y + minus_link5_to_6_y * f6_z);
  h[4] = n5_z;
  const Real f3_x = minus_h_3_x * t44 + f4_x;
  const Real t695 = minus_h_3_y * a3_x + t689 * t692 - s4 * (s5 * n5_y - c5 * n5_x);

  // links 3 (hip) and 5 (chest2), inward
  const Real n4_z = t691 * a3_x - t44 * t692 - (s5 * n5_x + c5 * n5_y);
  h[3] = n4_z;
  const Real t696 = c3 * f3_x - s3 * f3_y;
  const Real f2_x = t696 - h_2_x * t36;
  const Real f2_y = minus_h_2_y * t36 + (s3 * f3_x + c3 * f3_y);

  // links 2 to 4, inward
  const Real n3_z = t695 - link4_to_5_z * t693 + (J_4_xz * t688 + n5_z) * c4 -
      (minus_h_3_x + t690) * a3_y;
  h[2] = n3_z;
  const Real n2_z = h_2_x * a2_y + minus_h_2_y * a2_x + (n3_z + minus_link2_to_3_y * t696);
  h[1] = n2_z;
  const Real n1_z = 0.1569597827085 * c1 - 299.6743959432 * s1 +
      (n2_z + minus_link1_to_2_y * (c2 * f2_x - s2 * f2_y));
  h[0] = n1_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
