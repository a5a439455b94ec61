// SPDX-License-Identifier: 0BSD
// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J
//   qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at
//   link origins, alike limbs in lanes.
// 8557 flops (add 3753, mul 4760, div 44), sine and cosine of 24 angles
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
void control_torque(const Real (&TREELINE_RESTRICT q)[24], const Real (&TREELINE_RESTRICT qd)[24],
    const Real (&TREELINE_RESTRICT qdd_0)[24], const Real (&TREELINE_RESTRICT xdd_cmd)[12],
    Real (&TREELINE_RESTRICT tau)[24]) noexcept {
  // constants
  const Real h_22_x = 0.072575;
  const Real J_22_yy = 0.009438624999999999;
  const Real J_22_xx = 0.05450270000000001;
  const Real J_22_xy = 0.0074;
  const Real J_21_zz = 0.006216750000000001;
  const Real minus_h_22_y = 0.43200000000000005;
  const Real link21_to_22_z = 0.394;
  const Real minus_J_21_xz = 0.0016155;
  const Real h_21_x = 0.0045000000000000005;
  const Real J_21_xx = 0.005513625;
  const Real J_21_yy = 0.000703125;
  const Real J_6_zz = 2.06965463592404;
  const Real J_6_xz = 0.0187369177636143;
  const Real minus_h_6_x = 6.1665928899999995;
  const Real minus_link5_to_6_y = 0.072;
  const Real J_6_yy = 1.66923963592404;
  const Real J_5_zz = 0.203126912024134;
  const Real minus_h_5_y = 2.2194301519999997;
  const Real h_5_x = 0.069699984375;
  const Real link4_to_5_z = 0.21799999999999997;
  const Real J_5_xx = 0.15637308509675518;
  const Real J_5_yy = 0.04675382692737882;
  const Real J_5_xy = 0.005678398088837119;
  const Real J_4_xz = 0.005880002159562879;
  const Real minus_h_4_x = 0.0300000063;
  const Real J_4_zz = 0.060169103246295166;
  const Real minus_h_3_y = 8.419374554;
  const Real J_4_yy = 0.01227760324629517;
  const Real J_3_zz = 1.7824817919087104;
  const Real minus_h_3_x = 0.02999999505;
  const Real minus_link2_to_3_y = 0.422;
  const Real J_2_zz = 9.885744550888212;
  const Real h_2_x = 0.031999971599999996;
  const Real minus_h_2_y = 24.5839218;
  const Real J_1_zz = 13.049859506913753;
  const Real minus_link1_to_2_y = 0.434;
  const Real minus_gravity_z = 9.81;
  const Real J_6_xx = 0.40041499999999997;
  const Real J_22_zz = 0.06394132500000001;

  // sines and cosines
  const Real angles[24] = {q[0], q[1], q[2], q[3], q[4], q[5], q[20], q[21], q[23], q[22], q[13],
      q[14], q[15], q[16], q[17], q[18], q[19], q[9], q[12], q[11], q[10], q[8], q[7], q[6]};
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
  const Real s19 = sines[15];
  const Real c19 = cosines[15];
  const Real c20 = cosines[16];
  const Real s20 = sines[16];
  const Real s10 = sines[17];
  const Real c13 = cosines[18];
  const Real s13 = sines[18];
  const Real s12 = sines[19];
  const Real c12 = cosines[19];
  const Real s11 = sines[20];
  const Real c11 = cosines[20];
  const Real c10 = cosines[17];
  const Real c9 = cosines[21];
  const Real s9 = sines[21];
  const Real s8 = sines[22];
  const Real c8 = cosines[22];
  const Real c7 = cosines[23];
  const Real s7 = sines[23];
  const Lanes<2> t11_lanes = 0.000108260010923775 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> t12_lanes = 0.0007556474228594393 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-0.000252780114665025), 0.000252780114665025) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> t13_lanes = 0.000108260010923775 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> t14_lanes = 0.01626499875 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> t15_lanes = 0.01626499875 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(s13, s20);

  // links 13 (left_hand) and 20 (right_hand), articulated inertia
  const Lanes<2> t16_lanes = 1065.380700001509 * t11_lanes;
  const Lanes<2> t17_lanes = detail::make_pack<Real>(s13, s20) * t12_lanes;
  const Lanes<2> t19_lanes = 1065.380700001509 * t13_lanes;
  const Lanes<2> t20_lanes = 1065.380700001509 * t14_lanes;
  const Lanes<2> t21_lanes = 1065.380700001509 * t15_lanes;
  const Lanes<2> t22_lanes = 0.0006000000000000001 + t15_lanes;
  const Lanes<2> t24_lanes = 0.000847139515629375 - t17_lanes;
  const Lanes<2> t26_lanes = detail::make_pack<Real>(c13, c20) * t12_lanes -
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125);
  const Lanes<2> t28_lanes = 9.149209276993575e-05 + t17_lanes;
  const Lanes<2> t31_lanes = t11_lanes * t21_lanes;
  const Lanes<2> t38_lanes = 0.0025100003499999995 - t11_lanes * t20_lanes;
  const Lanes<2> t41_lanes = detail::make_pack<Real>((-2.4000000000000003e-06),
      2.4000000000000003e-06) - (t26_lanes + t13_lanes * t16_lanes);

  // links 12 (left_wrist2) and 19 (right_wrist2), articulated inertia
  const Lanes<2> inverse_D12_19_lanes = 1.0 / (0.000206827662257343 +
      (t24_lanes - t11_lanes * t16_lanes));
  const Lanes<2> t43_lanes = t41_lanes * inverse_D12_19_lanes;
  const Lanes<2> t44_lanes = t38_lanes * inverse_D12_19_lanes;
  const Lanes<2> t45_lanes = t22_lanes * inverse_D12_19_lanes;
  const Lanes<2> t46_lanes = t31_lanes * inverse_D12_19_lanes;
  const Lanes<2> t52_lanes = t22_lanes * t46_lanes;
  const Lanes<2> t55_lanes = 0.000195227662257343 + (t28_lanes - t13_lanes * t19_lanes) -
      t41_lanes * t43_lanes;
  const Lanes<2> t56_lanes = t13_lanes * t20_lanes + t41_lanes * t44_lanes;
  const Lanes<2> t57_lanes = t14_lanes + t41_lanes * t45_lanes;
  const Lanes<2> t58_lanes = t13_lanes * t21_lanes - 0.0025100003499999995 - t41_lanes * t46_lanes;
  const Lanes<2> t59_lanes = t22_lanes * t44_lanes;
  const Lanes<2> t60_lanes = t22_lanes * t45_lanes;
  const Lanes<2> t61_lanes = t14_lanes * t20_lanes + t38_lanes * t44_lanes;
  const Lanes<2> t62_lanes = t14_lanes * t21_lanes - t38_lanes * t46_lanes;
  const Lanes<2> t75_lanes = detail::make_pack<Real>(s12, s19) * (1.16e-05 - t55_lanes);
  const Lanes<2> t76_lanes = detail::make_pack<Real>(s12, s19) * t56_lanes +
      detail::make_pack<Real>(c12, c19) * t57_lanes;
  const Lanes<2> t77_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * t58_lanes;
  const Lanes<2> t79_lanes = detail::make_pack<Real>(s12, s19) * t58_lanes - 0.0006000000000000001 *
      detail::make_pack<Real>(c12, c19);
  const Lanes<2> t80_lanes = detail::make_pack<Real>(s12, s19) * t62_lanes -
      detail::make_pack<Real>(c12, c19) * t52_lanes;
  const Lanes<2> t82_lanes = t15_lanes * t21_lanes + t31_lanes * t46_lanes;
  const Lanes<2> t83_lanes = detail::make_pack<Real>(s12, s19) * t75_lanes;
  const Lanes<2> t84_lanes = detail::make_pack<Real>(c12, c19) * t76_lanes;
  const Lanes<2> t87_lanes = detail::make_pack<Real>(s12, s19) * t76_lanes;
  const Lanes<2> t88_lanes = 0.269 * t80_lanes;
  const Lanes<2> t89_lanes = 6e-04 - t77_lanes;
  const Lanes<2> t91_lanes = detail::make_pack<Real>(s12, s19) * (t61_lanes - t60_lanes) +
      detail::make_pack<Real>(c12, c19) * (2.0 * t59_lanes);
  const Lanes<2> t96_lanes = t87_lanes + t88_lanes;
  const Lanes<2> t97_lanes = detail::make_pack<Real>(0.001, (-0.001)) + t84_lanes;
  const Lanes<2> t98_lanes = detail::make_pack<Real>(s12, s19) * t91_lanes;
  const Lanes<2> t99_lanes = t79_lanes + 0.269 * t82_lanes;

  // links 11 and 12, 18 and 19, articulated inertia
  const Lanes<2> t100_lanes = 2.0 * detail::make_pack<Real>(c11, c18);
  const Lanes<2> t102_lanes = 0.000144 - (detail::make_pack<Real>(c12, c19) * t75_lanes + 0.269 *
      t77_lanes);
  const Lanes<2> t103_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 * t84_lanes;
  const Lanes<2> inverse_D11_18_lanes = 1.0 / (0.00022920000000000001 + (t55_lanes + t83_lanes));
  const Lanes<2> t106_lanes = t60_lanes + t98_lanes;

  // links 10 and 11, 17 and 18, articulated inertia
  const Lanes<2> t113_lanes = t102_lanes * inverse_D11_18_lanes;
  const Lanes<2> t114_lanes = t103_lanes * inverse_D11_18_lanes;
  const Lanes<2> t115_lanes = t97_lanes * inverse_D11_18_lanes;
  const Lanes<2> t116_lanes = t89_lanes * inverse_D11_18_lanes;
  const Lanes<2> t124_lanes = 2.0 * detail::make_pack<Real>(c10, c17);

  // links 11 (left_wrist1) and 18 (right_wrist1), articulated inertia
  const Lanes<2> t125_lanes = 0.000131 - t83_lanes - 0.269 * (t79_lanes + t99_lanes) - t102_lanes *
      t113_lanes;
  const Lanes<2> t126_lanes = 0.0001098 - 0.07236100000000001 * t106_lanes - t103_lanes *
      t114_lanes;
  const Lanes<2> t127_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 * t96_lanes -
      t102_lanes * t114_lanes;
  const Lanes<2> t128_lanes = t102_lanes * t115_lanes - t96_lanes;
  const Lanes<2> t129_lanes = t88_lanes - t103_lanes * t116_lanes;
  const Lanes<2> t130_lanes = 0.269 * t106_lanes + t103_lanes * t115_lanes;
  const Lanes<2> t131_lanes = t99_lanes + t102_lanes * t116_lanes;
  const Lanes<2> t139_lanes = detail::make_pack<Real>(s11, s18) * (t125_lanes - t126_lanes) +
      t100_lanes * t127_lanes;
  const Lanes<2> t140_lanes = detail::make_pack<Real>(s11, s18) * (t128_lanes - t129_lanes) +
      detail::make_pack<Real>(c11, c18) * (t130_lanes - t131_lanes);
  const Lanes<2> t141_lanes = detail::make_pack<Real>(s11, s18) * t139_lanes;
  const Lanes<2> t143_lanes = detail::make_pack<Real>(c11, c18) * t140_lanes;
  const Lanes<2> t144_lanes = detail::make_pack<Real>(s11, s18) * t140_lanes;
  const Lanes<2> t148_lanes = t129_lanes + t144_lanes;
  const Lanes<2> t151_lanes = 0.060888541114265754 + (t126_lanes + t141_lanes);
  const Lanes<2> t152_lanes = detail::make_pack<Real>((-2.249994685315e-05), 2.249994685315e-05) +
      (detail::make_pack<Real>(c11, c18) * t139_lanes - t127_lanes);
  const Lanes<2> t157_lanes = t106_lanes + t97_lanes * t115_lanes;

  // links 10 and 11, 17 and 18, articulated inertia
  const Lanes<2> inverse_D10_17_lanes = 1.0 / t151_lanes;
  const Lanes<2> t158_lanes = detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) /
      t151_lanes;
  const Lanes<2> t160_lanes = t82_lanes + t89_lanes * t116_lanes;
  const Lanes<2> t161_lanes = t97_lanes * t116_lanes - t80_lanes;
  const Lanes<2> t165_lanes = detail::make_pack<Real>(s11, s18) * (t160_lanes - t157_lanes) +
      t100_lanes * t161_lanes;
  const Lanes<2> t166_lanes = t152_lanes * inverse_D10_17_lanes;
  const Lanes<2> t168_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / t151_lanes;
  const Lanes<2> t169_lanes = t148_lanes * inverse_D10_17_lanes;
  const Lanes<2> t170_lanes = detail::make_pack<Real>(s11, s18) * t165_lanes;
  const Lanes<2> t173_lanes = t143_lanes + t131_lanes - 0.28049749700000004;
  const Lanes<2> t177_lanes = 0.0001499998887063 + t152_lanes * t158_lanes;

  // links 10 to 12, 17 to 19, articulated inertia
  const Lanes<2> t181_lanes = t87_lanes - t56_lanes;
  const Lanes<2> t183_lanes = t173_lanes * inverse_D10_17_lanes;
  const Lanes<2> t184_lanes = 0.06060754126741261 + (t125_lanes - t141_lanes) - t152_lanes *
      t166_lanes;
  const Lanes<2> t186_lanes = detail::make_pack<Real>(s12, s19) * t52_lanes +
      detail::make_pack<Real>(c12, c19) * t62_lanes;
  const Lanes<2> t188_lanes = t181_lanes * inverse_D11_18_lanes;

  // links 10, 12, 17, 19, articulated inertia
  const Lanes<2> t189_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * t169_lanes;
  const Lanes<2> t190_lanes = 0.28049749700000004 + (t143_lanes - t130_lanes) - t152_lanes *
      t169_lanes;
  const Lanes<2> t191_lanes = t170_lanes - t160_lanes - t148_lanes * t169_lanes;
  const Lanes<2> t193_lanes = detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) *
      t183_lanes;
  const Lanes<2> t197_lanes = detail::make_pack<Real>(c12, c19) * t91_lanes - t59_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), articulated inertia
  const Lanes<2> t208_lanes = detail::make_pack<Real>(c10, c17) * t189_lanes -
      detail::make_pack<Real>(s10, s17) * t190_lanes;
  const Lanes<2> t209_lanes = t128_lanes - t144_lanes - t152_lanes * t183_lanes;
  const Lanes<2> t210_lanes = t124_lanes * t177_lanes - detail::make_pack<Real>(s10, s17) *
      (t184_lanes - t168_lanes);
  const Lanes<2> t211_lanes = detail::make_pack<Real>(c10, c17) * t190_lanes +
      detail::make_pack<Real>(s10, s17) * t189_lanes;
  const Lanes<2> t215_lanes = detail::make_pack<Real>(s10, s17) * t210_lanes;

  // links 9 to 11, 16 to 18, articulated inertia
  const Lanes<2> t219_lanes = detail::make_pack<Real>(0.001, (-0.001)) -
      (t84_lanes - t57_lanes + 0.269 * t186_lanes) - t102_lanes * t188_lanes;
  const Lanes<2> t222_lanes = t211_lanes + 0.282 * t191_lanes;
  const Lanes<2> t223_lanes = 0.269 * t197_lanes - 6e-04 - t103_lanes * t188_lanes;
  const Lanes<2> t232_lanes = t157_lanes + t170_lanes + t173_lanes * t183_lanes;
  const Lanes<2> t237_lanes = t97_lanes * t188_lanes - t197_lanes;
  const Lanes<2> t240_lanes = t186_lanes + t89_lanes * t188_lanes;
  const Lanes<2> inverse_D9_16_lanes = 1.0 / (0.0027762933559338653 + (t168_lanes - t215_lanes));
  const Lanes<2> t244_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * t219_lanes + detail::make_pack<Real>(c11, c18) *
      t223_lanes);

  // links 9 and 10, 16 and 17, articulated inertia
  const Lanes<2> t248_lanes = 0.282 * t208_lanes - (t177_lanes - detail::make_pack<Real>(c10, c17) *
      t210_lanes) - 0.0005895000784280001;
  const Lanes<2> t250_lanes = t244_lanes * inverse_D10_17_lanes;
  const Lanes<2> t258_lanes = detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) *
      t250_lanes;
  const Lanes<2> t262_lanes = detail::make_pack<Real>(c11, c18) * t165_lanes - t161_lanes -
      t173_lanes * t169_lanes;
  const Lanes<2> t263_lanes = 2.0 * detail::make_pack<Real>(s9, s16);
  const Lanes<2> t264_lanes = detail::make_pack<Real>(c11, c18) * t219_lanes -
      detail::make_pack<Real>(s11, s18) * t223_lanes + t152_lanes * t250_lanes;
  const Lanes<2> t266_lanes = t98_lanes - t61_lanes - t181_lanes * t188_lanes - t244_lanes *
      t250_lanes;
  const Lanes<2> t267_lanes = detail::make_pack<Real>(c11, c18) * t237_lanes +
      detail::make_pack<Real>(s11, s18) * t240_lanes + t173_lanes * t250_lanes;
  const Lanes<2> t268_lanes = detail::make_pack<Real>(s11, s18) * t237_lanes -
      detail::make_pack<Real>(c11, c18) * t240_lanes + t244_lanes * t169_lanes;
  const Lanes<2> t270_lanes = t248_lanes * inverse_D9_16_lanes;
  const Lanes<2> t278_lanes = t248_lanes * t270_lanes;
  const Lanes<2> t281_lanes = detail::make_pack<Real>(c10, c17) * t262_lanes +
      detail::make_pack<Real>(s10, s17) * t268_lanes;
  const Lanes<2> t282_lanes = detail::make_pack<Real>(c10, c17) * t268_lanes -
      detail::make_pack<Real>(s10, s17) * t262_lanes;
  const Lanes<2> t283_lanes = 0.0019585440854647937 +
      (t184_lanes + t215_lanes + 0.282 * (t211_lanes + t222_lanes)) - t278_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), articulated inertia
  const Lanes<2> t284_lanes = detail::make_pack<Real>(c10, c17) * (t193_lanes + t264_lanes) -
      detail::make_pack<Real>(s10, s17) * (t209_lanes + t258_lanes);
  const Lanes<2> t285_lanes = detail::make_pack<Real>(s10, s17) * (t232_lanes + t266_lanes) +
      t124_lanes * t267_lanes;
  const Lanes<2> t286_lanes = 0.282 * t281_lanes;
  const Lanes<2> t288_lanes = detail::make_pack<Real>(c10, c17) * t284_lanes;
  const Lanes<2> t289_lanes = detail::make_pack<Real>(s10, s17) * t285_lanes;
  const Lanes<2> t290_lanes = detail::make_pack<Real>(s10, s17) * t284_lanes;
  const Lanes<2> t292_lanes = t264_lanes - t288_lanes;
  const Lanes<2> t293_lanes = t289_lanes - t232_lanes;
  const Lanes<2> t295_lanes = t258_lanes + t290_lanes;
  const Lanes<2> t296_lanes = t267_lanes - detail::make_pack<Real>(c10, c17) * t285_lanes;
  const Lanes<2> t300_lanes = t209_lanes + t290_lanes + t286_lanes;
  const Lanes<2> t301_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      t292_lanes;

  // links 9 and 10, 16 and 17, articulated inertia
  const Lanes<2> t302_lanes = t295_lanes * inverse_D9_16_lanes;
  const Lanes<2> t304_lanes = t208_lanes - 0.0022500062;
  const Lanes<2> t307_lanes = t301_lanes * inverse_D9_16_lanes;
  const Lanes<2> t308_lanes = detail::make_pack<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + 0.282 * t292_lanes;
  const Lanes<2> t310_lanes = t304_lanes * inverse_D9_16_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), articulated inertia
  const Lanes<2> t315_lanes = t308_lanes * inverse_D9_16_lanes;
  const Lanes<2> t322_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      (0.282 * t282_lanes - (t193_lanes - t288_lanes)) + t248_lanes * t302_lanes;
  const Lanes<2> t325_lanes = t300_lanes + t248_lanes * t307_lanes;
  const Lanes<2> t326_lanes = t308_lanes * t307_lanes - 0.282 * t293_lanes;
  const Lanes<2> t327_lanes = t286_lanes + t308_lanes * t310_lanes;
  const Lanes<2> t328_lanes = t222_lanes - t248_lanes * t310_lanes;
  const Lanes<2> t329_lanes = 0.0022500062 + 0.282 * t296_lanes + t308_lanes * t302_lanes;
  const Lanes<2> t332_lanes = 0.0008177492704690715 + 0.07952399999999998 * t293_lanes -
      t308_lanes * t315_lanes;
  const Lanes<2> t333_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - 0.282 * t300_lanes - t248_lanes * t315_lanes;
  const Lanes<2> t345_lanes = detail::make_pack<Real>(c9, c16) * (t325_lanes + t327_lanes) -
      detail::make_pack<Real>(s9, s16) * (t326_lanes + t328_lanes);

  // links 8 and 9, 15 and 16, articulated inertia
  const Lanes<2> t346_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * t322_lanes -
      detail::make_pack<Real>(s9, s16) * t329_lanes);
  const Lanes<2> t347_lanes = 2.0 * detail::make_pack<Real>(c8, c15);
  const Lanes<2> t348_lanes = detail::make_pack<Real>(c9, c16) * (t283_lanes - t332_lanes) -
      t263_lanes * t333_lanes;
  const Lanes<2> t349_lanes = detail::make_pack<Real>(s9, s16) * t345_lanes;
  const Lanes<2> t350_lanes = detail::make_pack<Real>(c9, c16) * t345_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), articulated inertia
  const Lanes<2> t351_lanes = detail::make_pack<Real>(c9, c16) * t348_lanes;
  const Lanes<2> t358_lanes = 0.7139200499999999 + (t349_lanes + t328_lanes);
  const Lanes<2> t359_lanes = 0.18125194219699997 + (t332_lanes + t351_lanes);
  const Lanes<2> t360_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * t348_lanes + t333_lanes);
  const Lanes<2> t362_lanes = t350_lanes - t327_lanes;

  // links 8 (left_shoulder2) and 15 (right_shoulder2), articulated inertia
  const Lanes<2> inverse_D8_15_lanes = 1.0 / t359_lanes;
  const Lanes<2> t364_lanes = t360_lanes * inverse_D8_15_lanes;
  const Lanes<2> t365_lanes = 0.00012075 - 1.1024999999999998e-08 / t359_lanes;
  const Lanes<2> t366_lanes = t346_lanes * inverse_D8_15_lanes;
  const Lanes<2> t367_lanes = t358_lanes * inverse_D8_15_lanes;
  const Lanes<2> t368_lanes = t362_lanes * inverse_D8_15_lanes;
  const Lanes<2> t374_lanes = 0.00010499999999999999 * t367_lanes;
  const Lanes<2> t375_lanes = 0.00010499999999999999 * t366_lanes;
  const Lanes<2> t379_lanes = 0.18113119219699997 + (t283_lanes - t351_lanes) - t360_lanes *
      t364_lanes;
  const Lanes<2> t380_lanes = detail::make_pack<Real>((-5.2499999999999995e-05),
      5.2499999999999995e-05) + 0.00010499999999999999 * t364_lanes;
  const Lanes<2> t381_lanes = t360_lanes * t366_lanes -
      (detail::make_pack<Real>(s9, s16) * t322_lanes + detail::make_pack<Real>(c9, c16) *
      t329_lanes);
  const Lanes<2> t382_lanes = t325_lanes - t350_lanes - t360_lanes * t367_lanes;
  const Lanes<2> t383_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * t368_lanes;
  const Lanes<2> t384_lanes = t349_lanes + t326_lanes - 0.7139200499999999 - t360_lanes *
      t368_lanes;

  // links 8 and 9, 15 and 16, articulated inertia
  const Lanes<2> t400_lanes = t293_lanes - t301_lanes * t307_lanes;
  const Lanes<2> t401_lanes = t191_lanes - t304_lanes * t310_lanes;
  const Lanes<2> t403_lanes = t281_lanes + t301_lanes * t310_lanes;
  const Lanes<2> t406_lanes = detail::make_pack<Real>(s8, s15) * (t365_lanes - t379_lanes) +
      t347_lanes * t380_lanes;
  const Lanes<2> t407_lanes = detail::make_pack<Real>(c8, c15) * (t381_lanes + t374_lanes) -
      detail::make_pack<Real>(s8, s15) * (t375_lanes + t382_lanes);
  const Lanes<2> t412_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * t383_lanes + detail::make_pack<Real>(c8, c15) *
      t384_lanes);
  const Lanes<2> t414_lanes = detail::make_pack<Real>(s8, s15) * t406_lanes;
  const Lanes<2> t417_lanes = detail::make_pack<Real>(c8, c15) * t407_lanes;
  const Lanes<2> t422_lanes = detail::make_pack<Real>(s8, s15) * t407_lanes;
  const Lanes<2> t424_lanes = t296_lanes + t301_lanes * t302_lanes;
  const Lanes<2> t425_lanes = t266_lanes - t289_lanes - t295_lanes * t302_lanes - t346_lanes *
      t366_lanes;
  const Lanes<2> t427_lanes = detail::make_pack<Real>(c9, c16) * (t400_lanes - t401_lanes) -
      t263_lanes * t403_lanes;
  const Lanes<2> t428_lanes = t282_lanes + t304_lanes * t302_lanes;
  const Lanes<2> t431_lanes = 0.000448 + (t379_lanes + t414_lanes);
  const Lanes<2> t434_lanes = 0.0017499999999999998 + (t417_lanes - t374_lanes);
  const Lanes<2> t435_lanes = detail::make_pack<Real>(c9, c16) * t427_lanes;
  const Lanes<2> t441_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * t406_lanes - t380_lanes);

  // links 7 and 8, 14 and 15, articulated inertia
  const Lanes<2> inverse_D7_14_lanes = 1.0 / t431_lanes;
  const Lanes<2> t447_lanes = 2.0 * detail::make_pack<Real>(s7, s14);
  const Lanes<2> t448_lanes = t400_lanes - t435_lanes - t358_lanes * t367_lanes;
  const Lanes<2> t449_lanes = detail::make_pack<Real>(s9, s16) * t424_lanes -
      detail::make_pack<Real>(c9, c16) * t428_lanes + t346_lanes * t367_lanes;
  const Lanes<2> t450_lanes = detail::make_pack<Real>(c9, c16) * t424_lanes +
      detail::make_pack<Real>(s9, s16) * t428_lanes + t346_lanes * t368_lanes;
  const Lanes<2> t452_lanes = detail::make_pack<Real>(s9, s16) * t427_lanes + t403_lanes -
      t358_lanes * t368_lanes;
  const Lanes<2> t453_lanes = t382_lanes + t422_lanes;
  const Lanes<2> t461_lanes = t434_lanes * inverse_D7_14_lanes;
  const Lanes<2> t462_lanes = t412_lanes * inverse_D7_14_lanes;
  const Lanes<2> t464_lanes = t453_lanes * inverse_D7_14_lanes;
  const Lanes<2> t466_lanes = detail::make_pack<Real>(s8, s15) * (t425_lanes - t448_lanes) +
      t347_lanes * t449_lanes;

  // links 8, 15, 23 and 24, articulated inertia
  const Lanes<2> t467_lanes = 0.0007770270270270272 * detail::make_pack<Real>(c23, c24);
  const Lanes<2> t472_lanes = 9.060810810810813e-05 * detail::make_pack<Real>(s23, s24);
  const Lanes<2> t473_lanes = detail::make_pack<Real>(s8, s15) * t466_lanes;
  const Real t476 = c24 + c23;
  const Lanes<2> t477_lanes = detail::make_pack<Real>(c23, c24) * t467_lanes;

  // links 7, 14, 23 and 24, articulated inertia
  const Lanes<2> t478_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * t462_lanes;
  const Lanes<2> t479_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * t461_lanes;
  const Lanes<2> t482_lanes = t401_lanes + t435_lanes - t362_lanes * t368_lanes - t412_lanes *
      t462_lanes;
  const Real t483 = s24 + s23;
  const Lanes<2> t484_lanes = detail::make_pack<Real>(c8, c15) * t450_lanes -
      detail::make_pack<Real>(s8, s15) * t452_lanes - t412_lanes * t461_lanes;
  const Lanes<2> t485_lanes = t375_lanes + t422_lanes + t441_lanes * t461_lanes;
  const Lanes<2> t486_lanes = detail::make_pack<Real>(s23, s24) * t472_lanes;
  const Lanes<2> t487_lanes = detail::make_pack<Real>(s23, s24) * t467_lanes;
  const Lanes<2> t489_lanes = t477_lanes - 0.0007770270270270272;
  const Lanes<2> t491_lanes = detail::make_pack<Real>(c8, c15) * t383_lanes -
      detail::make_pack<Real>(s8, s15) * t384_lanes - t441_lanes * t462_lanes;
  const Lanes<2> t494_lanes = (detail::make_pack<Real>(8.000000000000001e-06,
      (-8.000000000000001e-06)) + t472_lanes) * detail::make_pack<Real>(c23, c24);
  const Lanes<2> t496_lanes = detail::make_pack<Real>(s8, s15) * t450_lanes +
      detail::make_pack<Real>(c8, c15) * t452_lanes - t412_lanes * t464_lanes;
  const Real t497 = t486_lanes[1] + t486_lanes[0];
  const Lanes<2> t498_lanes = 0.006756756756756758 * detail::make_pack<Real>(s23, s24);
  const Real t499 = t487_lanes[1] + t487_lanes[0];
  const Lanes<2> t500_lanes = detail::make_pack<Real>(0.032, (-0.032)) * t489_lanes;
  const Real t501 = 0.431222972972973 + t477_lanes[1] + t489_lanes[0];
  const Lanes<2> t502_lanes = t425_lanes - t473_lanes - t434_lanes * t461_lanes;
  const Lanes<2> t504_lanes = detail::make_pack<Real>(c8, c15) * t466_lanes - t449_lanes -
      t434_lanes * t464_lanes;

  // links 22 to 24, articulated inertia
  const Real t505 = h_22_x + 0.00025 * t476;
  const Lanes<2> t508_lanes = detail::make_pack<Real>(c23, c24) * t498_lanes;
  const Lanes<2> t509_lanes = detail::make_pack<Real>(s23, s24) * t498_lanes;
  const Real t513 = t494_lanes[0] + 2.375e-05 * t483 + t494_lanes[1];
  const Real t514 = t500_lanes[1] + t500_lanes[0] - 0.095 * t499;
  const Lanes<2> t518_lanes = t509_lanes - 0.006756756756756758;
  const Real inverse_D22 = 1.0 / (0.063951825 - t497 + 4.75e-05 * t476);

  // links 7, 14, 23 and 24, articulated inertia
  const Lanes<2> t520_lanes = detail::make_pack<Real>(c7, c14) * (t485_lanes - t478_lanes) -
      detail::make_pack<Real>(s7, s14) * (t491_lanes - t479_lanes);
  const Lanes<2> t521_lanes = detail::make_pack<Real>(s7, s14) * t496_lanes +
      detail::make_pack<Real>(c7, c14) * t504_lanes;
  const Lanes<2> t523_lanes = detail::make_pack<Real>(c7, c14) * (t482_lanes - t502_lanes) -
      t447_lanes * t484_lanes;
  const Lanes<2> t524_lanes = 0.095 * t508_lanes + detail::make_pack<Real>(0.032, (-0.032)) *
      t509_lanes;
  const Lanes<2> t525_lanes = detail::make_pack<Real>(s7, s14) * t520_lanes;
  const Lanes<2> t527_lanes = detail::make_pack<Real>(c7, c14) * t523_lanes;
  const Lanes<2> t528_lanes = 0.095 * t518_lanes - detail::make_pack<Real>(0.032, (-0.032)) *
      t508_lanes;

  // links 7, 14, 22, articulated inertia
  const Real t529 = t477_lanes[1] + t477_lanes[0];
  const Lanes<2> t530_lanes = t479_lanes - t525_lanes;
  const Real t531 = 2.0 * c22;
  const Real t532 = t528_lanes[1] + t528_lanes[0];
  const Lanes<2> t533_lanes = t482_lanes - t527_lanes;
  const Real t535 = t514 * inverse_D22;
  const Real t536 = t501 * inverse_D22;
  const Real t537 = t505 * inverse_D22;
  const Real t538 = t499 * inverse_D22;
  const Real t540 = J_22_xx + t497 + (-1.6000000000000003e-05) * s24 + 1.6000000000000003e-05 *
      s23 - t513 * t513 * inverse_D22;
  const Real t541 = t514 * t537;
  const Real t542 = t505 * t538;
  const Real t543 = t540 - 0.00017071621621621627;
  const Lanes<2> t544_lanes = t530_lanes + (detail::make_pack<Real>(0.18, (-0.18)) * t533_lanes +
      0.226 * t521_lanes);

  // link 22 (head), articulated inertia
  const Real t545 = t513 * t536 - t499;
  const Real t546 = t524_lanes[1] + t524_lanes[0] + t514 * t536;
  const Real t547 = t513 * t537 - 0.00025 * t483;
  const Real t548 = h_22_x + t532 + t514 * t538;
  const Real t549 = t529 - minus_h_22_y + t513 * t538;
  const Real t550 = t501 * t537;
  const Real t551 = t508_lanes[1] + t508_lanes[0] - t501 * t538;
  const Real t552 = J_22_yy - (-0.032) * t524_lanes[1] - 0.032 * t524_lanes[0] - t514 * t535 +
      0.095 * t532;
  const Real t553 = J_22_xy - (-0.032) * t487_lanes[1] - 0.032 * t487_lanes[0] + t513 * t535 -
      0.095 * t529;
  const Real t554 = t505 * t537;
  const Real t555 = t509_lanes[1] + t509_lanes[0] + t501 * t536;

  // links 7, 14, 22, articulated inertia
  const Lanes<2> t557_lanes = t441_lanes * inverse_D7_14_lanes;
  const Real t558 = c22 * t548 - s22 * t549;
  const Lanes<2> t560_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / t431_lanes;
  const Lanes<2> t561_lanes = detail::make_pack<Real>(0.18, (-0.18)) * (t530_lanes + t544_lanes);
  const Real t562 = c22 * t542 - s22 * t551;
  const Real t563 = s22 * (t545 + t541) + c22 * (t547 - t546);
  const Real t567 = s22 * (t543 - t552) + t531 * t553;
  const Real t568 = c22 * t563;
  const Real t569 = s22 * t563;
  const Lanes<2> t570_lanes = 0.0002975 + (t365_lanes - t414_lanes) - t441_lanes * t557_lanes;
  const Lanes<2> t571_lanes = 8.75e-06 + detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * t557_lanes;
  const Real t572 = s22 * t567;
  const Real t573 = t531 * t550 - s22 * (t554 - t555);
  const Real t574 = c22 * t549 + s22 * t548;
  const Real t575 = t568 - t547;
  const Real t577 = t569 - t541;
  const Real t578 = t518_lanes[1] + t518_lanes[0] - t499 * t538;
  const Real t579 = s22 * t573;
  const Real t580 = link21_to_22_z * t575;
  const Real t581 = t579 - t555;
  const Lanes<2> t582_lanes = 0.0001505 - t560_lanes;

  // links 21 (neck) and 22 (head), articulated inertia
  const Real t583 = t550 - c22 * t573;
  const Real t584 = 2.0 * s21;
  const Real inverse_D21 = 1.0 / (J_21_zz + (t552 + t572));
  const Real t585 = t574 - link21_to_22_z * t578;
  const Real t586 = minus_J_21_xz + (c22 * t567 - t553 + link21_to_22_z * t558);
  const Real t587 = c22 * t551 + s22 * t542;
  const Real t589 = link21_to_22_z * t587;
  const Real t594 = t545 - t569 - t589;

  // links 7, 14, 21, articulated inertia
  const Lanes<2> t596_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) * t464_lanes;
  const Lanes<2> t600_lanes = detail::make_pack<Real>(c7, c14) * (t582_lanes - t570_lanes) +
      t447_lanes * t571_lanes;
  const Lanes<2> t601_lanes = t417_lanes - t381_lanes - 0.0017499999999999998 - t441_lanes *
      t464_lanes;
  const Lanes<2> t603_lanes = detail::make_pack<Real>(c7, c14) * t600_lanes;
  const Real t604 = t580 * inverse_D21;
  const Lanes<2> t605_lanes = t448_lanes + t473_lanes - t453_lanes * t464_lanes;
  const Lanes<2> t607_lanes = detail::make_pack<Real>(c7, c14) * t520_lanes;
  const Real t608 = t577 * inverse_D21;
  const Real t611 = t603_lanes[1] + t603_lanes[0];
  const Lanes<2> t614_lanes = detail::make_pack<Real>(s7, s14) * t523_lanes + t484_lanes;
  const Lanes<2> t615_lanes = detail::make_pack<Real>(c7, c14) * t596_lanes +
      detail::make_pack<Real>(s7, s14) * t601_lanes;
  const Lanes<2> t617_lanes = t478_lanes + t607_lanes;
  const Lanes<2> t618_lanes = detail::make_pack<Real>(s7, s14) * t600_lanes;
  const Lanes<2> t619_lanes = detail::make_pack<Real>(c7, c14) * t496_lanes -
      detail::make_pack<Real>(s7, s14) * t504_lanes;
  const Real t621 = J_21_xx + (t543 - t572 - link21_to_22_z * (t574 + t585)) - t586 *
      (t586 * inverse_D21);
  const Real t622 = J_21_yy + 0.155236 * t581 - t580 * t604;
  const Real t623 = link21_to_22_z * t594 - t586 * t604;
  const Lanes<2> t624_lanes = detail::make_pack<Real>(0.18, (-0.18)) * t614_lanes;
  const Lanes<2> t627_lanes = 0.226 * t619_lanes;
  const Lanes<2> t628_lanes = t615_lanes + (detail::make_pack<Real>(0.18, (-0.18)) * t521_lanes +
      0.226 * t605_lanes);
  const Real t629 = t586 * t608 - (t568 + t546 + link21_to_22_z * t562);
  const Real t630 = t580 * t608 - (h_21_x + link21_to_22_z * t583);
  const Lanes<2> t631_lanes = t624_lanes - t617_lanes;
  const Real t632 = t628_lanes[1] + t628_lanes[0];
  const Lanes<2> t633_lanes = detail::make_pack<Real>(s7, s14) * t596_lanes -
      detail::make_pack<Real>(c7, c14) * t601_lanes;
  const Real t634 = t575 * inverse_D21;

  // links 7, 14, 21 and 22, articulated inertia
  const Real t636 = h_21_x + t558;
  const Real t637 = t633_lanes[1] + t633_lanes[0];
  const Real t638 = t636 * inverse_D21;
  const Lanes<2> t639_lanes = t607_lanes - t485_lanes - (t624_lanes + t627_lanes);
  const Real t640 = c21 * (t621 - t622) - t584 * t623;
  const Real t642 = t639_lanes[1] + t639_lanes[0];
  const Real t643 = c21 * t640;
  const Real t644 = t594 - t586 * t634;
  const Real t645 = link21_to_22_z * t581 - t580 * t634;
  const Lanes<2> t646_lanes = detail::make_pack<Real>(0.18, (-0.18)) * (t639_lanes + t617_lanes);

  // links 6 and 7, 21, articulated inertia
  const Real t647 = t589 + t580 * t638;
  const Real t648 = t585 + t586 * t638;
  const Real t649 = c21 * t629 - s21 * t630 + t544_lanes[1] + t544_lanes[0];
  const Real t650 = t614_lanes[1] + t614_lanes[0];
  const Real t651 = s21 * t640 + t623 + 0.226 * t642;
  const Real t652 = c21 * (t644 - t647) - s21 * (t645 + t648);
  const Real t653 = c21 * t652;
  const Real t654 = s21 * t652;
  const Real t655 = t575 * t608 - t583;
  const Real t656 = t562 - t636 * t608;
  const Real t657 = J_6_zz + t622 + t643 + t570_lanes[1] + t611 + t561_lanes[1] + t570_lanes[0] +
      t561_lanes[0] + 0.226 * (t615_lanes[1] + t632 + t615_lanes[0]);
  const Real t658 = t581 - t575 * t634;
  const Real t659 = t578 - t636 * t638;
  const Real t660 = t647 + t653 + t642;
  const Real t661 = J_6_xz + t646_lanes[1] - t571_lanes[1] + t618_lanes[1] + t646_lanes[0] -
      t571_lanes[0] + t618_lanes[0] + 0.226 * t637;
  const Real inverse_D6 = 1.0 / t657;

  // links 7, 14, 21, articulated inertia
  const Real t662 = t587 + t575 * t638;
  const Lanes<2> t663_lanes = t525_lanes + t491_lanes;
  const Lanes<2> t664_lanes = t502_lanes + t527_lanes;
  const Real t665 = t654 + t648 - minus_h_6_x - t632;
  const Lanes<2> t667_lanes = t663_lanes + detail::make_pack<Real>(0.18, (-0.18)) * t664_lanes;

  // links 6 (chest3) and 21 (neck), articulated inertia
  const Real t668 = c21 * (t658 - t659) - t584 * t662;
  const Real t669 = t664_lanes[1] + t664_lanes[0];
  const Real t670 = t660 * inverse_D6;
  const Real t671 = c21 * t668;
  const Real t672 = t649 * inverse_D6;

  // links 6 and 7, 14, articulated inertia
  const Real t673 = t665 * inverse_D6;
  const Real t674 = t661 * inverse_D6;
  const Real t676 = t651 * inverse_D6;
  const Lanes<2> t677_lanes = detail::make_pack<Real>(0.18, (-0.18)) * (t663_lanes + t667_lanes);
  const Real t678 = t667_lanes[1] + t667_lanes[0] - t661 * t670;

  // link 6 (chest3), articulated inertia
  const Real t679 = t659 + t671 + t669 - t660 * t670;
  const Real t680 = t631_lanes[1] + t631_lanes[0] + t661 * t672;
  const Real t681 = minus_h_6_x + t654 + t645 - t651 * t670 + 0.226 * t669;
  const Real t682 = 2.0 * c6;
  const Real t683 = t644 - t653 + t627_lanes[1] + t627_lanes[0] - t651 * t673;
  const Real t684 = t651 * t672 - (s21 * t629 + c21 * t630) + 0.226 * t650;
  const Real t685 = (-0.18) * t619_lanes[1] - t637 + 0.18 * t619_lanes[0] - t661 * t673;
  const Real t686 = t650 - c21 * t655 + s21 * t656 + t649 * t670;
  const Real t687 = s21 * t668 + t662 + t619_lanes[1] + t619_lanes[0] - t665 * t670;
  const Real t688 = J_6_yy + t621 - t643 - t651 * t676 + 0.051076 * t669;
  const Real t689 = s6 * t678 + c6 * t681;
  const Real t690 = (-0.04068) * t664_lanes[1] + 0.04068 * t664_lanes[0] - t661 * t676 + 0.226 *
      (t663_lanes[1] + t663_lanes[0]);
  const Real t691 = 0.40056549999999996 - t560_lanes[1] - t611 + t677_lanes[1] + t582_lanes[0] +
      t677_lanes[0] - t661 * t674;
  const Real t692 = t689 + minus_link5_to_6_y * t679;
  const Real t693 = c6 * t678 - s6 * t681;
  const Real t694 = s6 * (t680 - t683) + c6 * (t684 + t685);
  const Real t695 = c6 * t686 - s6 * t687;
  const Real t696 = s6 * t686 + c6 * t687;
  const Real t697 = minus_h_5_y + t692;
  const Real t698 = c6 * t694;
  const Real t699 = s6 * t694;
  const Real t700 = minus_link5_to_6_y * t696;
  const Real t701 = s6 * (t691 - t688) + t682 * t690;
  const Real t702 = t683 + t699 + t700;
  const Real t703 = s6 * t701;
  const Real t704 = t658 - t671 + t605_lanes[1] + t605_lanes[0] - t665 * t673;
  const Real t705 = t698 - t684;
  const Real t706 = t533_lanes[1] - (t554 + t579 + t577 * t608) + t533_lanes[0] - t649 * t672;
  const Real t707 = h_5_x + (t698 - t685 + minus_link5_to_6_y * t695);
  const Real t708 = minus_link5_to_6_y * t702;
  const Real t709 = t521_lanes[1] - (s21 * t655 + c21 * t656) + t521_lanes[0] + t649 * t673;
  const Real t710 = c6 * t701 - t690 + minus_link5_to_6_y * t693;

  // links 5 (chest2) and 6 (chest3), articulated inertia
  const Real inverse_D5 = 1.0 / (J_5_zz + (t688 + t703 + minus_link5_to_6_y * (t689 + t692)));
  const Real t711 = s6 * (t706 - t704) + t682 * t709;
  const Real t712 = s6 * t711;
  const Real t713 = c6 * t711 - t709;
  const Real t714 = t704 + t712;

  // link 5 (chest2), articulated inertia
  const Real t715 = t697 * inverse_D5;
  const Real t716 = t707 * inverse_D5;
  const Real t717 = t702 * inverse_D5;
  const Real t718 = 2.0 * c5;
  const Real t719 = t706 - t712 - t707 * t716;
  const Real t720 = t679 - t697 * t715;
  const Real t721 = t695 - t697 * t716;
  const Real t722 = t708 * t715 - t700;
  const Real t723 = t680 - t699 - t710 * t716;
  const Real t724 = t693 - t710 * t715;
  const Real t725 = t708 * t716 - minus_link5_to_6_y * t713;
  const Real t726 = t713 - t707 * t717;
  const Real t727 = t696 - t697 * t717;
  const Real t728 = t705 - h_5_x - t710 * t717;
  const Real t729 = t708 * t717 - (minus_h_5_y + minus_link5_to_6_y * t714);
  const Real t730 = t708 * inverse_D5;
  const Real t731 = t710 * inverse_D5;
  const Real t732 = J_4_xz * s4;
  const Real t733 = s5 * (t720 - t719) + t718 * t721;
  const Real t734 = s5 * t728 - c5 * t729;
  const Real t735 = minus_h_4_x * s4;
  const Real t736 = J_5_xx + 0.005183999999999999 * t714 - t708 * t730;
  const Real t737 = s5 * (t722 - t723) + c5 * (t724 + t725);
  const Real t738 = s5 * t733;
  const Real t739 = J_5_yy + (t691 - t703) - t710 * t731;
  const Real t740 = J_5_xy - minus_link5_to_6_y * t705 + t708 * t731;
  const Real t741 = s5 * t737;
  const Real t742 = c5 * t737;
  const Real t743 = 0.03561389675370483 * s4;
  const Real t744 = t720 - t738;
  const Real t745 = s4 * t743;
  const Real t746 = s5 * (t736 - t739) + t718 * t740;
  const Real t747 = s4 * (s5 * t729 + c5 * t728) - c4 * (t742 - t725);
  const Real t748 = s5 * t746;
  const Real t749 = c4 * (2.0 * (s5 * t726 - c5 * t727)) - s4 * (t744 - (t714 - t702 * t717));
  const Real t750 = t735 + t747;
  const Real t751 = minus_h_4_x * c4;
  const Real t752 = t723 + t741;
  const Real t753 = t734 - c4 * (c4 * t734 - s4 * (t722 - t741));

  // links 4 (chest1) and 5 (chest2), articulated inertia
  const Real t754 = minus_h_3_x + t751;
  const Real t755 = t744 + s4 * t749;
  const Real inverse_D4 = 1.0 / (J_4_zz + (t739 + t748));
  const Real t756 = s4 * (s5 * t727 + c5 * t726) - c4 * (c5 * t733 - t721);
  const Real s2_plus_3 = s2 * c3 + c2 * s3;
  const Real t757 = t732 + (link4_to_5_z * t747 - s4 * (c5 * t746 - t740));
  const Real t758 = t753 + link4_to_5_z * t755;
  const Real t759 = minus_link2_to_3_y * c2;
  const Real c2_plus_3 = c2 * c3 - s2 * s3;
  const Real t760 = minus_link2_to_3_y * s2;
  const Real t761 = t757 * inverse_D4;
  const Real t762 = t750 * inverse_D4;
  const Real t763 = t752 * inverse_D4;
  const Real t764 = J_4_yy + t745 + (s4 * (s4 * (t736 - t748)) + link4_to_5_z * (t753 + t758));

  // links 11 (left_wrist1) and 18 (right_wrist1), force propagation; link 4 (chest1), articulated
  //   inertia
  const Lanes<2> t765_lanes = 0.269 * detail::make_pack<Real>(s11, s18);
  const Lanes<2> t766_lanes = 0.269 * detail::make_pack<Real>(c11, c18);
  const Real t767 = t754 + link4_to_5_z * t756 - s4 * (t742 - t724) - t757 * t763;
  const Real t768 = h_2_x * s2 - minus_h_2_y * c2;
  const Real t769 = minus_h_3_y + (t758 - t757 * t762);

  // links 10 (left_lowerarm) and 17 (right_lowerarm), force propagation; link 3 (hip), articulated
  //   inertia
  const Real t770 = t158_lanes[1] * t765_lanes[1];
  const Real inverse_D3 = 1.0 / (J_3_zz + (t764 - t757 * t761));
  const Real t771 = t766_lanes[1] - t166_lanes[1] * t765_lanes[1];
  const Real t772 = c18 - t169_lanes[1] * t765_lanes[1];
  const Lanes<2> t774_lanes = t250_lanes * t765_lanes;
  const Lanes<2> t775_lanes = -detail::make_pack<Real>(s11, s18) - t183_lanes * t765_lanes;
  const Real t776 = c17 * t770 - s17 * t771;
  const Real t779 = t767 * inverse_D3;
  const Real t780 = t769 * inverse_D3;
  const Lanes<2> t781_lanes = detail::make_pack<Real>(c10, c17) * t775_lanes +
      detail::make_pack<Real>(s10, s17) * t774_lanes;

  // links 12, 16, 19, force propagation; links 3, 8, 15, articulated inertia
  const Real t782 = c17 * t771 + s17 * t770 + 0.282 * t772 - t270_lanes[1] * t776;
  const Lanes<2> t783_lanes = 0.00010499999999999999 / t359_lanes;
  const Lanes<2> t785_lanes = 0.269 * detail::make_pack<Real>(s12, s19);
  const Real t786 = t769 * t779 - (t756 - t750 * t763);
  const Real t787 = t755 - t750 * t762 - t769 * t780;

  // link 3 (hip), articulated inertia; links 9, 11, 16, 18, force propagation
  const Real t788 = t719 + t738 - t752 * t763 - t767 * t779;
  const Lanes<2> t789_lanes = detail::make_pack<Real>(c11, c18) * t785_lanes;
  const Lanes<2> t791_lanes = -(0.282 * t781_lanes);
  const Real t792 = t791_lanes[1] - t315_lanes[1] * t776;
  const Lanes<2> neg_s12_19_lanes = -detail::make_pack<Real>(s12, s19);

  // links 10 and 11, 16 to 18, force propagation
  const Real t793 = t158_lanes[1] * t789_lanes[1];
  const Lanes<2> t794_lanes = -(detail::make_pack<Real>(s11, s18) * t785_lanes);
  const Lanes<2> t795_lanes = detail::make_pack<Real>(s11, s18) * neg_s12_19_lanes;
  const Real t796 = c16 * t782 - s16 * t792;
  const Lanes<2> t797_lanes = detail::make_pack<Real>(c11, c18) * neg_s12_19_lanes;
  const Real t798 = t794_lanes[1] - t166_lanes[1] * t789_lanes[1];
  const Lanes<2> neg_c12_19_lanes = -detail::make_pack<Real>(c12, c19);
  const Lanes<2> neg_neg_c12_19_lanes = -neg_c12_19_lanes;

  // links 15 (right_shoulder2) and 17 (right_lowerarm), force propagation; link 3 (hip),
  //   articulated inertia
  const Real t799 = t795_lanes[1] - t169_lanes[1] * t789_lanes[1];
  const Real t800 = s2_plus_3 * (t787 - t788) + c2_plus_3 * (2.0 * t786);
  const Real t801 = t783_lanes[1] * t796;
  const Real t802 = t797_lanes[1] - t183_lanes[1] * t789_lanes[1];
  const Real t803 = neg_neg_c12_19_lanes[1] - t250_lanes[1] * t789_lanes[1];
  const Real t804 = s2_plus_3 * t800;
  const Real t805 = s16 * t782 + c16 * t792 - t364_lanes[1] * t796;
  const Real t807 = c17 * t793 - s17 * t798;
  const Real t808 = c2_plus_3 * t800 - t786;
  const Real t811 = t787 - t804;

  // links 12, 15, 17, 19, force propagation
  const Lanes<2> t812_lanes = t19_lanes - t43_lanes * t16_lanes;
  const Real t814 = s17 * t803 - c17 * t802;
  const Lanes<2> t815_lanes = t45_lanes * t16_lanes;
  const Lanes<2> t816_lanes = -t21_lanes - t46_lanes * t16_lanes;
  const Lanes<2> t819_lanes = detail::make_pack<Real>(c12, c19) * t43_lanes;
  const Real t820 = s15 * t801 + c15 * t805;

  // links 11 and 12, 16, 18 and 19, force propagation; link 3 (hip), articulated inertia
  const Real t823 = c17 * t798 + s17 * t793 + 0.282 * t799 - t270_lanes[1] * t807;
  const Lanes<2> t824_lanes = t20_lanes - t44_lanes * t16_lanes;
  const Real t829 = t759 * t811 + t760 * t808;
  const Lanes<2> t830_lanes = -(detail::make_pack<Real>(c12, c19) * t812_lanes);
  const Lanes<2> t838_lanes = t114_lanes * neg_c12_19_lanes;
  const Lanes<2> t839_lanes = detail::make_pack<Real>(c12, c19) * t45_lanes +
      detail::make_pack<Real>(s12, s19) * t44_lanes;
  const Real t841 = 0.282 * t814 - t315_lanes[1] * t807;
  const Lanes<2> t843_lanes = detail::make_pack<Real>(s12, s19) * t43_lanes - 0.269 * t46_lanes -
      t113_lanes * t819_lanes;
  const Real t844 = t829 - t768;
  const Lanes<2> t845_lanes = detail::make_pack<Real>(s12, s19) * t824_lanes -
      detail::make_pack<Real>(c12, c19) * t815_lanes;

  // links 10 and 11, 16 to 18, force propagation
  const Lanes<2> t847_lanes = neg_s12_19_lanes - t113_lanes * neg_c12_19_lanes;
  const Lanes<2> t849_lanes = 0.269 * t816_lanes - detail::make_pack<Real>(s12, s19) * t812_lanes -
      t113_lanes * t830_lanes;
  const Lanes<2> t850_lanes = -(0.269 * detail::make_pack<Real>(c12, c19));
  const Lanes<2> t851_lanes = detail::make_pack<Real>(c11, c18) * t850_lanes;
  const Lanes<2> t862_lanes = -(0.269 * t839_lanes) - t114_lanes * t819_lanes;
  const Lanes<2> t867_lanes = -(detail::make_pack<Real>(s11, s18) * t850_lanes);
  const Real t870 = c16 * t823 - s16 * t841;

  // links 11 (left_wrist1) and 18 (right_wrist1), force propagation
  const Lanes<2> t871_lanes = 0.269 * t845_lanes - t114_lanes * t830_lanes;
  const Lanes<2> t873_lanes = t115_lanes * neg_c12_19_lanes;
  const Lanes<2> t874_lanes = t116_lanes * neg_c12_19_lanes;
  const Lanes<2> t875_lanes = -t845_lanes + t115_lanes * t830_lanes;
  const Lanes<2> t876_lanes = t816_lanes - t116_lanes * t830_lanes;
  const Lanes<2> t877_lanes = detail::make_pack<Real>(s11, s18) * t847_lanes -
      detail::make_pack<Real>(c11, c18) * t838_lanes;
  const Lanes<2> t879_lanes = t839_lanes + t115_lanes * t819_lanes;
  const Lanes<2> t880_lanes = -t46_lanes - t116_lanes * t819_lanes;
  const Lanes<2> t881_lanes = detail::make_pack<Real>(c11, c18) * t847_lanes +
      detail::make_pack<Real>(s11, s18) * t838_lanes;
  const Lanes<2> t882_lanes = detail::make_pack<Real>(s11, s18) * detail::make_pack<Real>(c12, c19);

  // links 11, 15, 18, force propagation
  const Real t885 = t783_lanes[1] * t870;
  const Lanes<2> t886_lanes = detail::make_pack<Real>(s11, s18) * t843_lanes +
      detail::make_pack<Real>(c11, c18) * t862_lanes;
  const Lanes<2> t894_lanes = detail::make_pack<Real>(c11, c18) * detail::make_pack<Real>(c12, c19);
  const Lanes<2> t895_lanes = detail::make_pack<Real>(c11, c18) * t843_lanes -
      detail::make_pack<Real>(s11, s18) * t862_lanes;
  const Lanes<2> t900_lanes = detail::make_pack<Real>(s11, s18) * t849_lanes +
      detail::make_pack<Real>(c11, c18) * t871_lanes;
  const Lanes<2> t901_lanes = detail::make_pack<Real>(c11, c18) * t849_lanes -
      detail::make_pack<Real>(s11, s18) * t871_lanes;
  const Lanes<2> t909_lanes = detail::make_pack<Real>(c11, c18) * t875_lanes -
      detail::make_pack<Real>(s11, s18) * t876_lanes;
  const Lanes<2> t913_lanes = t188_lanes * neg_c12_19_lanes;

  // links 10 and 11, 17 and 18, force propagation
  const Lanes<2> t915_lanes = detail::make_pack<Real>(c11, c18) * t879_lanes -
      detail::make_pack<Real>(s11, s18) * t880_lanes;
  const Lanes<2> t916_lanes = detail::make_pack<Real>(c11, c18) * t873_lanes +
      detail::make_pack<Real>(s11, s18) * t874_lanes;
  const Lanes<8> t917_lanes = t158_lanes[0] * detail::make_pack<Real>(t789_lanes[0], t765_lanes[0],
      t851_lanes[0], t877_lanes[0], t886_lanes[0], t900_lanes[0], t789_lanes[0], t789_lanes[0]);
  const Lanes<2> neg_neg_s12_19_lanes = -neg_s12_19_lanes;
  const Lanes<2> t919_lanes = detail::make_pack<Real>(s11, s18) * t875_lanes +
      detail::make_pack<Real>(c11, c18) * t876_lanes;

  // links 11, 15, 18, force propagation; link 3 (hip), articulated inertia
  const Lanes<2> t920_lanes = detail::make_pack<Real>(s11, s18) * t879_lanes +
      detail::make_pack<Real>(c11, c18) * t880_lanes;
  const Real t921 = s16 * t823 + c16 * t841 - t364_lanes[1] * t870;
  const Lanes<2> t923_lanes = detail::make_pack<Real>(s11, s18) * t873_lanes -
      detail::make_pack<Real>(c11, c18) * t874_lanes;
  const Real t924 = J_2_zz + (t760 * (t759 * t808 + t760 * (t788 + t804)) + t759 * t829);
  const Lanes<2> t926_lanes = -(detail::make_pack<Real>(s12, s19) * t815_lanes +
      detail::make_pack<Real>(c12, c19) * t824_lanes) - t188_lanes * t830_lanes;

  // links 10, 16 and 17, force propagation; link 2 (thigh), articulated inertia
  const Lanes<8> t927_lanes = detail::make_pack<Real>(t794_lanes[0], t766_lanes[0], t867_lanes[0],
      t881_lanes[0], t895_lanes[0], t901_lanes[0], t794_lanes[0], t794_lanes[0]) - t166_lanes[0] *
      detail::make_pack<Real>(t789_lanes[0], t765_lanes[0], t851_lanes[0], t877_lanes[0],
      t886_lanes[0], t900_lanes[0], t789_lanes[0], t789_lanes[0]);
  const Lanes<8> t928_lanes = detail::make_pack<Real>(t797_lanes[0], t797_lanes[0], t894_lanes[0],
      t916_lanes[0], t915_lanes[0], t909_lanes[0], t797_lanes[0], t797_lanes[0]) - t183_lanes[0] *
      detail::make_pack<Real>(t789_lanes[0], t789_lanes[0], t851_lanes[0], t877_lanes[0],
      t886_lanes[0], t900_lanes[0], t789_lanes[0], t789_lanes[0]);
  const Lanes<8> t932_lanes = detail::make_pack<Real>(t795_lanes[0], c11, t882_lanes[0],
      t923_lanes[0], t920_lanes[0], t919_lanes[0], t795_lanes[0], t795_lanes[0]) - t169_lanes[0] *
      detail::make_pack<Real>(t789_lanes[0], t765_lanes[0], t851_lanes[0], t877_lanes[0],
      t886_lanes[0], t900_lanes[0], t789_lanes[0], t789_lanes[0]);
  const Lanes<2> t933_lanes = -t926_lanes;
  const Real t937 = t781_lanes[1] + t307_lanes[1] * t776;
  const Real inverse_D2 = 1.0 / t924;
  const Lanes<2> t938_lanes = -(detail::make_pack<Real>(c12, c19) * t44_lanes -
      detail::make_pack<Real>(s12, s19) * t45_lanes - t188_lanes * t819_lanes);

  // links 10, 15 and 16, force propagation
  const Lanes<8> t939_lanes = detail::make_pack<Real>(neg_neg_c12_19_lanes[0],
      neg_neg_c12_19_lanes[0], neg_neg_s12_19_lanes[0], t913_lanes[0], t938_lanes[0], t933_lanes[0],
      neg_neg_c12_19_lanes[0], neg_neg_c12_19_lanes[0]) - t250_lanes[0] *
      detail::make_pack<Real>(t789_lanes[0], t789_lanes[0], t851_lanes[0], t877_lanes[0],
      t886_lanes[0], t900_lanes[0], t789_lanes[0], t789_lanes[0]);
  const Real t941 = t772 - t310_lanes[1] * t776;
  const Real t942 = s15 * t885 + c15 * t921;
  const Real t943 = -t814 + t307_lanes[1] * t807;
  const Lanes<8> t944_lanes = c10 * t917_lanes - s10 * t927_lanes;
  const Real t946 = t799 - t310_lanes[1] * t807;

  // links 9 and 10, 17, force propagation
  const Lanes<8> t948_lanes = t270_lanes[0] * t944_lanes;
  const Lanes<8> t955_lanes = s10 * t939_lanes - c10 * t928_lanes;
  const Lanes<8> t956_lanes = c10 * t927_lanes + s10 * t917_lanes + 0.282 * t932_lanes - t948_lanes;
  const Lanes<8> t957_lanes = 0.282 * t955_lanes;
  const Lanes<8> t958_lanes = -t955_lanes;
  const Lanes<8> t959_lanes = detail::make_pack<Real>(t958_lanes[0], t781_lanes[0], t958_lanes[2],
      t958_lanes[3], t958_lanes[4], t958_lanes[5], t958_lanes[0], t958_lanes[0]) + t307_lanes[0] *
      t944_lanes;
  const Lanes<8> t960_lanes = t932_lanes - t310_lanes[0] * t944_lanes;
  const Lanes<2> t961_lanes = detail::make_pack<Real>(c10, c17) * t774_lanes -
      detail::make_pack<Real>(s10, s17) * t775_lanes;

  // links 9 (left_upperarm) and 15 (right_shoulder2), force propagation; link 2 (thigh),
  //   articulated inertia
  const Real t964 = s16 * t937 + c16 * t941 - t367_lanes[1] * t796;
  const Lanes<8> t969_lanes = detail::make_pack<Real>(t957_lanes[0], t791_lanes[0], t957_lanes[2],
      t957_lanes[3], t957_lanes[4], t957_lanes[5], t957_lanes[0], t957_lanes[0]) - t315_lanes[0] *
      t944_lanes;
  const Real t973 = s16 * t943 + c16 * t946 - t367_lanes[1] * t870;
  const Real t974 = t844 * inverse_D2;
  const Real t978 = -(t961_lanes[1] + t302_lanes[1] * t776) + t366_lanes[1] * t796;
  const Lanes<8> t981_lanes = c9 * t956_lanes - s9 * t969_lanes;
  const Real t983 = -(-(s17 * t802 + c17 * t803) + t302_lanes[1] * t807) + t366_lanes[1] * t870;
  const Lanes<8> t984_lanes = -(s10 * t928_lanes + c10 * t939_lanes);

  // link 8 (left_shoulder2), force propagation; links 7 (left_shoulder1) and 14 (right_shoulder1),
  //   articulated inertia
  const Lanes<8> t987_lanes = t783_lanes[0] * t981_lanes;
  const Lanes<2> t992_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / t431_lanes;
  const Lanes<8> t993_lanes = s9 * t956_lanes + c9 * t969_lanes - t364_lanes[0] * t981_lanes;
  const Lanes<8> t995_lanes = s9 * t959_lanes + c9 * t960_lanes - t367_lanes[0] * t981_lanes;
  const Lanes<8> t996_lanes = -(detail::make_pack<Real>(t984_lanes[0], t961_lanes[0], t984_lanes[2],
      t984_lanes[3], t984_lanes[4], t984_lanes[5], t984_lanes[0], t984_lanes[0]) + t302_lanes[0] *
      t944_lanes) + t366_lanes[0] * t981_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> t997_lanes = c9 * t959_lanes - s9 * t960_lanes - t368_lanes[0] * t981_lanes;
  const Lanes<8> t1005_lanes = s8 * t987_lanes + c8 * t993_lanes;
  const Lanes<8> t1006_lanes = c8 * t996_lanes - s8 * t995_lanes;
  const Lanes<8> t1007_lanes = s8 * t996_lanes + c8 * t995_lanes;
  const Lanes<8> t1008_lanes = c8 * t987_lanes - s8 * t993_lanes;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), force propagation
  const Lanes<8> t1013_lanes = detail::make_pack<Real>(t992_lanes[0], t992_lanes[0], t992_lanes[0],
      t992_lanes[0], t992_lanes[0], t992_lanes[0], t992_lanes[1], t992_lanes[1]) *
      detail::make_pack<Real>(t1005_lanes[0], t1005_lanes[1], t1005_lanes[2], t1005_lanes[3],
      t1005_lanes[4], t1005_lanes[5], t942, t820);
  const Lanes<8> t1014_lanes = detail::make_pack<Real>(t997_lanes[0], t997_lanes[1], t997_lanes[2],
      t997_lanes[3], t997_lanes[4], t997_lanes[5], c16 * t943 - s16 * t946 - t368_lanes[1] * t870,
      c16 * t937 - s16 * t941 - t368_lanes[1] * t796) -
      detail::make_pack<Real>(t462_lanes[0], t462_lanes[0], t462_lanes[0], t462_lanes[0],
      t462_lanes[0], t462_lanes[0], t462_lanes[1], t462_lanes[1]) *
      detail::make_pack<Real>(t1005_lanes[0], t1005_lanes[1], t1005_lanes[2], t1005_lanes[3],
      t1005_lanes[4], t1005_lanes[5], t942, t820);
  const Lanes<8> t1015_lanes = detail::make_pack<Real>(t1006_lanes[0], t1006_lanes[1],
      t1006_lanes[2], t1006_lanes[3], t1006_lanes[4], t1006_lanes[5], c15 * t983 - s15 * t973, c15 *
      t978 - s15 * t964) - detail::make_pack<Real>(t461_lanes[0], t461_lanes[0], t461_lanes[0],
      t461_lanes[0], t461_lanes[0], t461_lanes[0], t461_lanes[1], t461_lanes[1]) *
      detail::make_pack<Real>(t1005_lanes[0], t1005_lanes[1], t1005_lanes[2], t1005_lanes[3],
      t1005_lanes[4], t1005_lanes[5], t942, t820);
  const Lanes<8> t1016_lanes = detail::make_pack<Real>(t1007_lanes[0], t1007_lanes[1],
      t1007_lanes[2], t1007_lanes[3], t1007_lanes[4], t1007_lanes[5], s15 * t983 + c15 * t973, s15 *
      t978 + c15 * t964) - detail::make_pack<Real>(t464_lanes[0], t464_lanes[0], t464_lanes[0],
      t464_lanes[0], t464_lanes[0], t464_lanes[0], t464_lanes[1], t464_lanes[1]) *
      detail::make_pack<Real>(t1005_lanes[0], t1005_lanes[1], t1005_lanes[2], t1005_lanes[3],
      t1005_lanes[4], t1005_lanes[5], t942, t820);
  const Lanes<8> t1017_lanes = detail::make_pack<Real>(t1008_lanes[0], t1008_lanes[1],
      t1008_lanes[2], t1008_lanes[3], t1008_lanes[4], t1008_lanes[5], c15 * t885 - s15 * t921, c15 *
      t801 - s15 * t805) - detail::make_pack<Real>(t557_lanes[0], t557_lanes[0], t557_lanes[0],
      t557_lanes[0], t557_lanes[0], t557_lanes[0], t557_lanes[1], t557_lanes[1]) *
      detail::make_pack<Real>(t1005_lanes[0], t1005_lanes[1], t1005_lanes[2], t1005_lanes[3],
      t1005_lanes[4], t1005_lanes[5], t942, t820);
  const Lanes<8> t1027_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      t1014_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * t1015_lanes;
  const Lanes<8> t1029_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      t1014_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * t1015_lanes;
  const Lanes<8> t1034_lanes = 0.226 * t1016_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) * t1027_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> t1037_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      t1013_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * t1017_lanes +
      t1034_lanes);
  const Lanes<8> t1038_lanes = t674 * t1037_lanes;
  const Lanes<8> t1043_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18),
      (-0.18)) * t1029_lanes - (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      t1013_lanes - detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * t1017_lanes) -
      t1038_lanes;
  const Lanes<8> t1044_lanes = 0.226 * t1029_lanes - t676 * t1037_lanes;
  const Lanes<8> t1045_lanes = t1029_lanes - t670 * t1037_lanes;
  const Lanes<8> t1046_lanes = t1027_lanes + t672 * t1037_lanes;
  const Lanes<8> t1047_lanes = t1016_lanes - t673 * t1037_lanes;
  const Lanes<8> t1059_lanes = s6 * t1046_lanes + c6 * t1047_lanes;
  const Lanes<8> t1061_lanes = s6 * t1043_lanes + c6 * t1044_lanes + minus_link5_to_6_y *
      t1045_lanes;

  // links 4 (chest1) and 5 (chest2), force propagation
  const Lanes<8> t1069_lanes = c6 * t1046_lanes - s6 * t1047_lanes - t716 * t1061_lanes;
  const Lanes<8> t1070_lanes = t1045_lanes - t715 * t1061_lanes;
  const Lanes<8> t1071_lanes = c6 * t1043_lanes - s6 * t1044_lanes - t731 * t1061_lanes;
  const Lanes<8> t1072_lanes = -(minus_link5_to_6_y * t1059_lanes) + t730 * t1061_lanes;
  const Lanes<8> t1078_lanes = s4 * (t1059_lanes - t717 * t1061_lanes);
  const Lanes<8> t1089_lanes = -(s5 * t1072_lanes + c5 * t1071_lanes);
  const Lanes<8> t1093_lanes = t1061_lanes * inverse_D5;

  // links 6 to 8, force propagation
  const Lanes<8> t1095_lanes = t1037_lanes * inverse_D6;
  const Real t1096 = t1037_lanes[7] * inverse_D6;
  const Lanes<8> t1097_lanes = t1005_lanes * inverse_D7_14_lanes[0];
  const Real t1098 = t1037_lanes[6] * inverse_D6;
  const Lanes<8> t1099_lanes = t981_lanes * inverse_D8_15_lanes[0];

  // links 4 and 5, 9 and 10, force propagation
  const Lanes<8> t1100_lanes = t1089_lanes * inverse_D4;
  const Lanes<8> t1101_lanes = t944_lanes * inverse_D9_16_lanes[0];
  const Lanes<8> t1102_lanes = c4 * (s5 * t1069_lanes - c5 * t1070_lanes) + t1078_lanes;
  const Lanes<8> t1103_lanes = detail::make_pack<Real>(t789_lanes[0], t765_lanes[0], t851_lanes[0],
      t877_lanes[0], t886_lanes[0], t900_lanes[0], t789_lanes[0], t789_lanes[0]) *
      inverse_D10_17_lanes[0];
  const Lanes<8> t1104_lanes = -(s5 * t1070_lanes + c5 * t1069_lanes) - t763 * t1089_lanes;

  // links 4 and 5, 7, force propagation; link 1 (calf), articulated inertia
  const Lanes<8> t1106_lanes = t1097_lanes * t1005_lanes[0];
  const Real inverse_D1 = 1.0 / (J_1_zz + 0.188356 * (t811 - t844 * t974));
  const Lanes<8> t1116_lanes = s4 * (s5 * t1071_lanes - c5 * t1072_lanes) + link4_to_5_z *
      t1102_lanes;
  const Lanes<8> t1119_lanes = -t1116_lanes - t761 * t1089_lanes;
  const Lanes<8> t1124_lanes = t1097_lanes * t1005_lanes[1];

  // links 3, 6 and 7, force propagation
  const Lanes<8> t1128_lanes = t1119_lanes * inverse_D3;
  const Lanes<8> t1130_lanes = t1103_lanes * t789_lanes[0] + t1101_lanes * t944_lanes[0] +
      t1099_lanes * t981_lanes[0] + t1106_lanes;
  const Lanes<8> t1132_lanes = -t1102_lanes - t762 * t1089_lanes - t780 * t1119_lanes;
  const Lanes<8> t1133_lanes = -t1104_lanes + t779 * t1119_lanes;
  const Lanes<8> t1134_lanes = t1130_lanes + t1095_lanes * t1037_lanes[0];
  const Lanes<8> t1145_lanes = c2_plus_3 * t1132_lanes - s2_plus_3 * t1133_lanes;
  const Lanes<8> t1147_lanes = t1103_lanes * t765_lanes[0] + t1101_lanes * t944_lanes[1] +
      t1099_lanes * t981_lanes[1] + t1124_lanes;
  const Lanes<8> t1150_lanes = detail::make_pack<Real>(t1134_lanes[0], t1134_lanes[1],
      t1134_lanes[2], t1134_lanes[3], t1134_lanes[4], t1134_lanes[5], t1098 * t1037_lanes[0],
      t1096 * t1037_lanes[0]) + t1093_lanes * t1061_lanes[0] + t1100_lanes * t1089_lanes[0] +
      t1128_lanes * t1119_lanes[0];
  const Lanes<8> t1151_lanes = t1147_lanes + t1095_lanes * t1037_lanes[1];
  const Lanes<8> t1154_lanes = t1097_lanes * t1005_lanes[2];
  const Lanes<8> t1161_lanes = t760 * (s2_plus_3 * t1132_lanes + c2_plus_3 * t1133_lanes) + t759 *
      t1145_lanes;

  // links 2 and 3, 6 and 7, force propagation
  const Lanes<8> t1165_lanes = t1161_lanes * inverse_D2;
  const Lanes<8> t1166_lanes = detail::make_pack<Real>(t1151_lanes[1], t1151_lanes[1],
      t1151_lanes[2], t1151_lanes[3], t1151_lanes[4], t1151_lanes[5], t1098 * t1037_lanes[1],
      t1096 * t1037_lanes[1]) + t1093_lanes * t1061_lanes[1] + t1100_lanes * t1089_lanes[1] +
      t1128_lanes * t1119_lanes[1];
  const Lanes<8> t1172_lanes = t1103_lanes * t851_lanes[0] + t1101_lanes * t944_lanes[2] +
      t1099_lanes * t981_lanes[2] + t1154_lanes;
  const Lanes<8> t1173_lanes = minus_link1_to_2_y * (t1145_lanes - t974 * t1161_lanes);
  const Lanes<8> t1176_lanes = t1172_lanes + t1095_lanes * t1037_lanes[2];

  // links 1, 3, 8, 11, force propagation
  const Lanes<8> t1177_lanes = t1173_lanes * inverse_D1;
  const Lanes<8> t1185_lanes = t1099_lanes * t981_lanes[3];
  const Lanes<8> t1188_lanes = detail::make_pack<Real>(neg_c12_19_lanes[0], neg_c12_19_lanes[0],
      neg_c12_19_lanes[0], neg_c12_19_lanes[0], t819_lanes[0], t830_lanes[0], neg_c12_19_lanes[0],
      neg_c12_19_lanes[0]) * inverse_D11_18_lanes[0];
  const Lanes<8> t1194_lanes = detail::make_pack<Real>(t1176_lanes[2], t1176_lanes[2],
      t1176_lanes[2], t1176_lanes[3], t1176_lanes[4], t1176_lanes[5], t1098 * t1037_lanes[2],
      t1096 * t1037_lanes[2]) + t1093_lanes * t1061_lanes[2] + t1100_lanes * t1089_lanes[2] +
      t1128_lanes * t1119_lanes[2];
  const Lanes<8> t1196_lanes = t1150_lanes + t1165_lanes * t1161_lanes[0] + t1177_lanes *
      t1173_lanes[0];
  const Real t1199 = t1196_lanes[0] * t1196_lanes[0];

  // links 1, 3, 6, 8, force propagation
  const Real t1203 = t1199 * t1196_lanes[0];
  const Lanes<8> t1204_lanes = t1188_lanes * neg_c12_19_lanes[0] + t1103_lanes * t877_lanes[0] +
      t1101_lanes * t944_lanes[3] + t1185_lanes;
  const Lanes<8> t1206_lanes = t1204_lanes + t1097_lanes * t1005_lanes[3] + t1095_lanes *
      t1037_lanes[3];
  const Real t1207 = t1203 * t1199 / (1.9721522630525295e-31 + t1203 * t1203);
  const Lanes<8> t1210_lanes = detail::make_pack<Real>(t1206_lanes[3], t1206_lanes[3],
      t1206_lanes[3], t1206_lanes[3], t1206_lanes[4], t1206_lanes[5], t1098 * t1037_lanes[3],
      t1096 * t1037_lanes[3]) + t1093_lanes * t1061_lanes[3] + t1100_lanes * t1089_lanes[3] +
      t1128_lanes * t1119_lanes[3];

  // links 1 (calf) and 17 (right_lowerarm), force propagation
  const Lanes<8> t1218_lanes = detail::make_pack<Real>(t867_lanes[1], t881_lanes[1], t895_lanes[1],
      t901_lanes[1], t867_lanes[1], t867_lanes[1], t867_lanes[1], t867_lanes[1]) - t166_lanes[1] *
      detail::make_pack<Real>(t851_lanes[1], t877_lanes[1], t886_lanes[1], t900_lanes[1],
      t851_lanes[1], t851_lanes[1], t851_lanes[1], t851_lanes[1]);
  const Lanes<8> t1219_lanes = t158_lanes[1] * detail::make_pack<Real>(t851_lanes[1], t877_lanes[1],
      t886_lanes[1], t900_lanes[1], t851_lanes[1], t851_lanes[1], t851_lanes[1], t851_lanes[1]);
  const Lanes<8> t1221_lanes = t1196_lanes * t1207;
  const Lanes<8> t1231_lanes = detail::make_pack<Real>(t882_lanes[1], t923_lanes[1], t920_lanes[1],
      t919_lanes[1], t882_lanes[1], t882_lanes[1], t882_lanes[1], t882_lanes[1]) - t169_lanes[1] *
      detail::make_pack<Real>(t851_lanes[1], t877_lanes[1], t886_lanes[1], t900_lanes[1],
      t851_lanes[1], t851_lanes[1], t851_lanes[1], t851_lanes[1]);
  const Lanes<8> t1232_lanes = c17 * t1219_lanes - s17 * t1218_lanes;
  const Lanes<8> t1235_lanes = t1166_lanes + t1165_lanes * t1161_lanes[1] + t1177_lanes *
      t1173_lanes[1] - t1221_lanes * t1196_lanes[1];
  const Lanes<8> t1237_lanes = t1194_lanes + t1165_lanes * t1161_lanes[2] + t1177_lanes *
      t1173_lanes[2] - t1221_lanes * t1196_lanes[2];
  const Lanes<8> t1238_lanes = t1210_lanes + t1165_lanes * t1161_lanes[3] + t1177_lanes *
      t1173_lanes[3] - t1221_lanes * t1196_lanes[3];

  // links 1, 16 and 17, force propagation
  const Lanes<8> t1240_lanes = t270_lanes[1] * t1232_lanes;
  const Real t1242 = t1235_lanes[1] * t1235_lanes[1];
  const Lanes<8> t1243_lanes = detail::make_pack<Real>(t894_lanes[1], t916_lanes[1], t915_lanes[1],
      t909_lanes[1], t894_lanes[1], t894_lanes[1], t894_lanes[1], t894_lanes[1]) - t183_lanes[1] *
      detail::make_pack<Real>(t851_lanes[1], t877_lanes[1], t886_lanes[1], t900_lanes[1],
      t851_lanes[1], t851_lanes[1], t851_lanes[1], t851_lanes[1]);
  const Lanes<8> t1244_lanes = detail::make_pack<Real>(neg_neg_s12_19_lanes[1], t913_lanes[1],
      t938_lanes[1], t933_lanes[1], neg_neg_s12_19_lanes[1], neg_neg_s12_19_lanes[1],
      neg_neg_s12_19_lanes[1], neg_neg_s12_19_lanes[1]) - t250_lanes[1] *
      detail::make_pack<Real>(t851_lanes[1], t877_lanes[1], t886_lanes[1], t900_lanes[1],
      t851_lanes[1], t851_lanes[1], t851_lanes[1], t851_lanes[1]);
  const Real t1247 = t1242 * t1235_lanes[1];
  const Lanes<8> t1249_lanes = c17 * t1218_lanes + s17 * t1219_lanes + 0.282 * t1231_lanes -
      t1240_lanes;
  const Lanes<8> t1250_lanes = s17 * t1244_lanes - c17 * t1243_lanes;
  const Lanes<8> t1254_lanes = t1232_lanes * inverse_D9_16_lanes[1];
  const Real t1255 = t1247 * t1242 / (1.262177448353619e-29 + t1247 * t1247);
  const Lanes<8> t1256_lanes = 0.282 * t1250_lanes - t315_lanes[1] * t1232_lanes;
  const Lanes<8> t1257_lanes = detail::make_pack<Real>(t851_lanes[1], t877_lanes[1], t886_lanes[1],
      t900_lanes[1], t851_lanes[1], t851_lanes[1], t851_lanes[1], t851_lanes[1]) *
      inverse_D10_17_lanes[1];

  // links 12, 15 and 16, 18 and 19, force propagation
  const Lanes<8> t1258_lanes = detail::make_pack<Real>(neg_c12_19_lanes[1], neg_c12_19_lanes[1],
      t819_lanes[1], t830_lanes[1], neg_c12_19_lanes[1], neg_c12_19_lanes[1], neg_c12_19_lanes[1],
      neg_c12_19_lanes[1]) * inverse_D11_18_lanes[1];
  const Lanes<2> t1260_lanes = t16_lanes * inverse_D12_19_lanes;
  const Lanes<8> t1265_lanes = c16 * t1249_lanes - s16 * t1256_lanes;
  const Lanes<8> t1269_lanes = t783_lanes[1] * t1265_lanes;
  const Lanes<8> t1272_lanes = t1265_lanes * inverse_D8_15_lanes[1];

  // links 1, 9, 15 and 16, force propagation
  const Lanes<8> t1275_lanes = t1235_lanes * t1255;
  const Lanes<8> t1276_lanes = s16 * t1249_lanes + c16 * t1256_lanes - t364_lanes[1] * t1265_lanes;
  const Lanes<2> t1279_lanes = t1260_lanes + detail::make_pack<Real>(t1188_lanes[5],
      t1258_lanes[3]) * t819_lanes + detail::make_pack<Real>(t1103_lanes[5], t1257_lanes[3]) *
      t886_lanes + detail::make_pack<Real>(t1101_lanes[5], t1254_lanes[3]) *
      detail::make_pack<Real>(t944_lanes[4], t1232_lanes[2]);
  const Lanes<2> t1288_lanes = inverse_D12_19_lanes +
      detail::make_pack<Real>(t1188_lanes[4], t1258_lanes[2]) * t819_lanes +
      detail::make_pack<Real>(t1103_lanes[4], t1257_lanes[2]) * t886_lanes +
      detail::make_pack<Real>(t1101_lanes[4], t1254_lanes[2]) *
      detail::make_pack<Real>(t944_lanes[4], t1232_lanes[2]);
  const Lanes<8> t1289_lanes = t1237_lanes - t1275_lanes * t1235_lanes[2];
  const Lanes<8> t1290_lanes = s15 * t1269_lanes + c15 * t1276_lanes;

  // links 1, 7, 14, force propagation
  const Real t1293 = t1289_lanes[2] * t1289_lanes[2];
  const Lanes<8> t1294_lanes = t1290_lanes * inverse_D7_14_lanes[1];
  const Real t1295 = t1293 * t1289_lanes[2];
  const Lanes<2> t1308_lanes = t1279_lanes + detail::make_pack<Real>(t1099_lanes[5],
      t1272_lanes[3]) * detail::make_pack<Real>(t981_lanes[4], t1265_lanes[2]) +
      detail::make_pack<Real>(t1097_lanes[5], t1294_lanes[3]) *
      detail::make_pack<Real>(t1005_lanes[4], t1290_lanes[2]);
  const Lanes<2> t1309_lanes = t1288_lanes + detail::make_pack<Real>(t1099_lanes[4],
      t1272_lanes[2]) * detail::make_pack<Real>(t981_lanes[4], t1265_lanes[2]) +
      detail::make_pack<Real>(t1097_lanes[4], t1294_lanes[2]) *
      detail::make_pack<Real>(t1005_lanes[4], t1290_lanes[2]);

  // links 1, 3, 7, 10, 14, 17, force propagation
  const Real t1315 = t1295 * t1293 / (3.0814879110195774e-33 + t1295 * t1295);
  const Lanes<2> t1318_lanes = 1065.380700001509 + t1260_lanes * t16_lanes +
      detail::make_pack<Real>(t1188_lanes[5], t1258_lanes[3]) * t830_lanes +
      detail::make_pack<Real>(t1103_lanes[5], t1257_lanes[3]) * t900_lanes;
  const Lanes<8> t1319_lanes = detail::make_pack<Real>(t1309_lanes[0] + t1095_lanes[4] *
      t1037_lanes[4], t1309_lanes[0] + t1095_lanes[4] * t1037_lanes[4], t1309_lanes[0] +
      t1095_lanes[4] * t1037_lanes[4], t1309_lanes[0] + t1095_lanes[4] * t1037_lanes[4],
      t1309_lanes[0] + t1095_lanes[4] * t1037_lanes[4], t1308_lanes[0] + t1095_lanes[5] *
      t1037_lanes[4], t1098 * t1037_lanes[4], t1096 * t1037_lanes[4]) + t1093_lanes *
      t1061_lanes[4] + t1100_lanes * t1089_lanes[4] + t1128_lanes * t1119_lanes[4];
  const Lanes<8> t1324_lanes = t1289_lanes * t1315;
  const Lanes<2> t1325_lanes = t1318_lanes + detail::make_pack<Real>(t1101_lanes[5],
      t1254_lanes[3]) * detail::make_pack<Real>(t944_lanes[5], t1232_lanes[3]) +
      detail::make_pack<Real>(t1099_lanes[5], t1272_lanes[3]) *
      detail::make_pack<Real>(t981_lanes[5], t1265_lanes[3]) +
      detail::make_pack<Real>(t1097_lanes[5], t1294_lanes[3]) *
      detail::make_pack<Real>(t1005_lanes[5], t1290_lanes[3]);

  // links 1 (calf) and 3 (hip), force propagation
  const Lanes<8> t1326_lanes = t1319_lanes + t1165_lanes * t1161_lanes[4] + t1177_lanes *
      t1173_lanes[4] - t1221_lanes * t1196_lanes[4];
  const Lanes<8> t1332_lanes = t1238_lanes - t1275_lanes * t1235_lanes[3] - t1324_lanes *
      t1289_lanes[3];
  const Real t1335 = t1332_lanes[3] * t1332_lanes[3];
  const Lanes<8> t1336_lanes = detail::make_pack<Real>(t1325_lanes[0] + t1095_lanes[5] *
      t1037_lanes[5], t1325_lanes[0] + t1095_lanes[5] * t1037_lanes[5], t1325_lanes[0] +
      t1095_lanes[5] * t1037_lanes[5], t1325_lanes[0] + t1095_lanes[5] * t1037_lanes[5],
      t1325_lanes[0] + t1095_lanes[5] * t1037_lanes[5], t1325_lanes[0] + t1095_lanes[5] *
      t1037_lanes[5], t1098 * t1037_lanes[5], t1096 * t1037_lanes[5]) + t1093_lanes *
      t1061_lanes[5] + t1100_lanes * t1089_lanes[5] + t1128_lanes * t1119_lanes[5];
  const Real t1337 = t1335 * t1332_lanes[3];

  // links 1, 4, 14 and 15, force propagation
  const Real t1340 = t789_lanes[1] * inverse_D10_17_lanes[1] * t789_lanes[1] + t807 *
      inverse_D9_16_lanes[1] * t807 + t870 * inverse_D8_15_lanes[1] * t870;
  const Lanes<8> t1341_lanes = t1336_lanes + t1165_lanes * t1161_lanes[5] + t1177_lanes *
      t1173_lanes[5] - t1221_lanes * t1196_lanes[5];
  const Real t1343 = t1337 * t1335 / (2.2737367544323206e-13 + t1337 * t1337);
  const Real t1345 = t1340 + t942 * inverse_D7_14_lanes[1] * t942 + t1098 * t1037_lanes[6] +
      t1093_lanes[6] * t1061_lanes[6] + t1100_lanes[6] * t1089_lanes[6];
  const Lanes<8> t1346_lanes = t1332_lanes * t1343;
  const Real t1347 = t820 * inverse_D7_14_lanes[1];
  const Real t1348 = t796 * inverse_D8_15_lanes[1];

  // links 1, 16 and 17, force propagation
  const Real t1351 = t776 * inverse_D9_16_lanes[1];
  const Real t1352 = t765_lanes[1] * inverse_D10_17_lanes[1];
  const Real t1353 = t1345 + t1128_lanes[6] * t1119_lanes[6] + t1165_lanes[6] * t1161_lanes[6] +
      t1177_lanes[6] * t1173_lanes[6] - t1221_lanes[6] * t1196_lanes[6];
  const Lanes<8> t1354_lanes = t1326_lanes - t1275_lanes * t1235_lanes[4] - t1324_lanes *
      t1289_lanes[4] - t1346_lanes * t1332_lanes[4];
  const Lanes<8> t1355_lanes = t1341_lanes - t1275_lanes * t1235_lanes[5] - t1324_lanes *
      t1289_lanes[5] - t1346_lanes * t1332_lanes[5];
  const Real t1356 = t1354_lanes[4] * t1354_lanes[4];

  // links 1 and 2, 6, force propagation
  const Real t1357 = t1356 * t1354_lanes[4];
  const Real t1358 = t1352 * t789_lanes[1] + t1351 * t807 + t1348 * t870 + t1347 * t942 + t1096 *
      t1037_lanes[6];
  const Real t1359 = t1357 * t1356 / (2.2737367544323206e-13 + t1357 * t1357);
  const Real t1360 = t1358 + t1093_lanes[7] * t1061_lanes[6] + t1100_lanes[7] * t1089_lanes[6] +
      t1128_lanes[7] * t1119_lanes[6] + t1165_lanes[7] * t1161_lanes[6];
  const Real t1361 = t1352 * t765_lanes[1] + t1351 * t776 + t1348 * t796 + t1347 * t820 + t1096 *
      t1037_lanes[7];

  // links 1 (calf) and 14 (right_shoulder1), force propagation
  const Lanes<8> t1362_lanes = t1354_lanes * t1359;
  const Real t1364 = t1360 + t1177_lanes[7] * t1173_lanes[6] - t1221_lanes[7] * t1196_lanes[6] -
      t1275_lanes[7] * t1235_lanes[6] - t1324_lanes[7] * t1289_lanes[6];
  const Lanes<8> t1365_lanes = t462_lanes[1] * t1290_lanes;
  const Lanes<8> t1369_lanes = t1355_lanes - t1362_lanes * t1354_lanes[5];
  const Real t1370 = t1353 - t1275_lanes[6] * t1235_lanes[6] - t1324_lanes[6] * t1289_lanes[6] -
      t1346_lanes[6] * t1332_lanes[6] - t1362_lanes[6] * t1354_lanes[6];

  // links 1 and 2, 16, force propagation
  const Real t1372 = t1361 + t1093_lanes[7] * t1061_lanes[7] + t1100_lanes[7] * t1089_lanes[7] +
      t1128_lanes[7] * t1119_lanes[7] + t1165_lanes[7] * t1161_lanes[7];
  const Lanes<8> t1373_lanes = -t1250_lanes + t307_lanes[1] * t1232_lanes;
  const Real t1374 = t1369_lanes[5] * t1369_lanes[5];
  const Lanes<8> t1375_lanes = t1231_lanes - t310_lanes[1] * t1232_lanes;
  const Real t1386 = t1374 * t1369_lanes[5];

  // links 1, 14 to 16, force propagation
  const Lanes<8> t1390_lanes = s16 * t1373_lanes + c16 * t1375_lanes - t367_lanes[1] * t1265_lanes;
  const Real t1392 = t1372 + t1177_lanes[7] * t1173_lanes[7] - t1221_lanes[7] * t1196_lanes[7] -
      t1275_lanes[7] * t1235_lanes[7] - t1324_lanes[7] * t1289_lanes[7];
  const Lanes<8> t1395_lanes = -(s17 * t1243_lanes + c17 * t1244_lanes) + t302_lanes[1] *
      t1232_lanes;
  const Lanes<8> t1397_lanes = c16 * t1373_lanes - s16 * t1375_lanes - t368_lanes[1] * t1265_lanes -
      t1365_lanes;
  const Lanes<8> t1401_lanes = -t1395_lanes + t366_lanes[1] * t1265_lanes;

  // links 1 (calf) and 14 (right_shoulder1), force propagation
  const Lanes<8> t1404_lanes = t992_lanes[1] * t1290_lanes;
  const Real t1405 = t1386 * t1374 / (2.2737367544323206e-13 + t1386 * t1386);
  const Lanes<8> t1414_lanes = c15 * t1269_lanes - s15 * t1276_lanes - t557_lanes[1] * t1290_lanes;
  const Lanes<8> t1416_lanes = c15 * t1401_lanes - s15 * t1390_lanes - t461_lanes[1] * t1290_lanes;
  const Lanes<8> t1417_lanes = s15 * t1401_lanes + c15 * t1390_lanes - t464_lanes[1] * t1290_lanes;
  const Real t1425 = t1369_lanes[6] * t1405;
  const Real t1426 = t1369_lanes[7] * t1405;
  const Lanes<8> t1427_lanes = s14 * t1397_lanes + c14 * t1416_lanes;
  const Lanes<8> t1428_lanes = c14 * t1397_lanes - s14 * t1416_lanes;
  const Real t1432 = t1370 - t1425 * t1369_lanes[6];
  const Real t1433 = t1364 - t1346_lanes[7] * t1332_lanes[6] - t1362_lanes[7] * t1354_lanes[6] -
      t1426 * t1369_lanes[6];
  const Lanes<8> t1434_lanes = 0.226 * t1417_lanes + (-0.18) * t1427_lanes;
  const Real t1436 = t1432 * t1432;
  const Real t1438 = t1436 * t1432;

  // links 1 (calf) and 6 (chest3), force propagation
  const Lanes<8> t1439_lanes = -(c14 * t1404_lanes + s14 * t1414_lanes + t1434_lanes);
  const Lanes<8> t1440_lanes = t674 * t1439_lanes;
  const Lanes<8> t1445_lanes = (-0.18) * t1428_lanes - (s14 * t1404_lanes - c14 * t1414_lanes) -
      t1440_lanes;
  const Lanes<8> t1446_lanes = 0.226 * t1428_lanes - t676 * t1439_lanes;
  const Lanes<8> t1447_lanes = t1428_lanes - t670 * t1439_lanes;
  const Lanes<8> t1448_lanes = t1427_lanes + t672 * t1439_lanes;
  const Lanes<8> t1449_lanes = t1417_lanes - t673 * t1439_lanes;
  const Lanes<8> t1461_lanes = s6 * t1448_lanes + c6 * t1449_lanes;
  const Real t1462 = t1438 * t1436 / (3.0814879110195774e-33 + t1438 * t1438);
  const Lanes<8> t1464_lanes = s6 * t1445_lanes + c6 * t1446_lanes + minus_link5_to_6_y *
      t1447_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> t1472_lanes = c6 * t1448_lanes - s6 * t1449_lanes - t716 * t1464_lanes;
  const Lanes<8> t1473_lanes = t1447_lanes - t715 * t1464_lanes;
  const Lanes<8> t1474_lanes = c6 * t1445_lanes - s6 * t1446_lanes - t731 * t1464_lanes;
  const Lanes<8> t1475_lanes = -(minus_link5_to_6_y * t1461_lanes) + t730 * t1464_lanes;
  const Lanes<8> t1481_lanes = s4 * (t1461_lanes - t717 * t1464_lanes);

  // links 1, 4 to 6, force propagation
  const Real t1486 = t1433 * t1462;
  const Lanes<8> t1493_lanes = -(s5 * t1475_lanes + c5 * t1474_lanes);
  const Lanes<8> t1497_lanes = t1493_lanes * inverse_D4;
  const Lanes<8> t1499_lanes = t1464_lanes * inverse_D5;
  const Lanes<8> t1500_lanes = t1439_lanes * inverse_D6;
  const Real t1501 = t1392 - t1346_lanes[7] * t1332_lanes[7] - t1362_lanes[7] * t1354_lanes[7] -
      t1426 * t1369_lanes[7] - t1486 * t1433;
  const Lanes<8> t1502_lanes = c4 * (s5 * t1472_lanes - c5 * t1473_lanes) + t1481_lanes;
  const Lanes<8> t1503_lanes = -(s5 * t1473_lanes + c5 * t1472_lanes) - t763 * t1493_lanes;
  const Real t1507 = t1501 * t1501;
  const Real t1516 = t1507 * t1501;
  const Lanes<8> t1517_lanes = s4 * (s5 * t1474_lanes - c5 * t1475_lanes) + link4_to_5_z *
      t1502_lanes;
  const Lanes<8> t1521_lanes = -t1517_lanes - t761 * t1493_lanes;

  // links 1 (calf) and 3 (hip), force propagation
  const Lanes<8> t1525_lanes = t1521_lanes * inverse_D3;
  const Lanes<8> t1529_lanes = -t1502_lanes - t762 * t1493_lanes - t780 * t1521_lanes;
  const Lanes<8> t1530_lanes = -t1503_lanes + t779 * t1521_lanes;
  const Lanes<8> t1531_lanes = t1525_lanes * t1119_lanes[0];
  const Lanes<8> t1532_lanes = t1525_lanes * t1119_lanes[1];
  const Lanes<8> t1534_lanes = t1525_lanes * t1119_lanes[2];
  const Real t1535 = t1516 * t1507 / (1.262177448353619e-29 + t1516 * t1516);
  const Lanes<8> t1540_lanes = t1500_lanes * t1037_lanes[0] + t1499_lanes * t1061_lanes[0] +
      t1497_lanes * t1089_lanes[0] + t1531_lanes;
  const Lanes<8> t1541_lanes = t1500_lanes * t1037_lanes[1] + t1499_lanes * t1061_lanes[1] +
      t1497_lanes * t1089_lanes[1] + t1532_lanes;
  const Lanes<8> t1546_lanes = t1525_lanes * t1119_lanes[3];
  const Lanes<8> t1548_lanes = c2_plus_3 * t1529_lanes - s2_plus_3 * t1530_lanes;
  const Lanes<8> t1549_lanes = t1500_lanes * t1037_lanes[2] + t1499_lanes * t1061_lanes[2] +
      t1497_lanes * t1089_lanes[2] + t1534_lanes;

  // links 2 (thigh) and 3 (hip), force propagation
  const Lanes<8> t1554_lanes = t760 * (s2_plus_3 * t1529_lanes + c2_plus_3 * t1530_lanes) + t759 *
      t1548_lanes;
  const Lanes<8> t1555_lanes = t1500_lanes * t1037_lanes[3] + t1499_lanes * t1061_lanes[3] +
      t1497_lanes * t1089_lanes[3] + t1546_lanes;
  const Lanes<8> t1557_lanes = t1554_lanes * inverse_D2;
  const Lanes<8> t1566_lanes = t1525_lanes * t1119_lanes[4];
  const Lanes<8> t1568_lanes = minus_link1_to_2_y * (t1548_lanes - t974 * t1554_lanes);

  // links 1 (calf) and 3 (hip), force propagation
  const Lanes<8> t1574_lanes = t1568_lanes * inverse_D1;
  const Lanes<8> t1580_lanes = t1500_lanes * t1037_lanes[4] + t1499_lanes * t1061_lanes[4] +
      t1497_lanes * t1089_lanes[4] + t1566_lanes;
  const Lanes<8> t1585_lanes = t1525_lanes * t1119_lanes[5];
  const Lanes<8> t1588_lanes = t1540_lanes + t1557_lanes * t1161_lanes[0] + t1574_lanes *
      t1173_lanes[0];
  const Lanes<8> t1594_lanes = t1588_lanes * t1207;
  const Lanes<8> t1601_lanes = t1500_lanes * t1037_lanes[5] + t1499_lanes * t1061_lanes[5] +
      t1497_lanes * t1089_lanes[5] + t1585_lanes;

  // links 1 (calf) and 14 (right_shoulder1), force propagation
  const Lanes<8> t1607_lanes = t1294_lanes * t942;
  const Lanes<8> t1613_lanes = t1541_lanes + t1557_lanes * t1161_lanes[1] + t1574_lanes *
      t1173_lanes[1] - t1594_lanes * t1196_lanes[1];
  const Lanes<8> t1614_lanes = t1549_lanes + t1557_lanes * t1161_lanes[2] + t1574_lanes *
      t1173_lanes[2] - t1594_lanes * t1196_lanes[2];
  const Lanes<8> t1615_lanes = t1555_lanes + t1557_lanes * t1161_lanes[3] + t1574_lanes *
      t1173_lanes[3] - t1594_lanes * t1196_lanes[3];
  const Lanes<8> t1616_lanes = t1580_lanes + t1557_lanes * t1161_lanes[4] + t1574_lanes *
      t1173_lanes[4] - t1594_lanes * t1196_lanes[4];
  const Lanes<8> t1619_lanes = t1613_lanes * t1255;
  const Lanes<8> t1627_lanes = t1601_lanes + t1557_lanes * t1161_lanes[5] + t1574_lanes *
      t1173_lanes[5] - t1594_lanes * t1196_lanes[5];
  const Lanes<8> t1629_lanes = t1257_lanes * t789_lanes[1] + t1254_lanes * t807 + t1272_lanes *
      t870 + t1607_lanes;
  const Lanes<8> t1630_lanes = t1614_lanes - t1619_lanes * t1235_lanes[2];
  const Lanes<8> t1640_lanes = t1294_lanes * t820;
  const Lanes<8> t1642_lanes = t1630_lanes * t1315;

  // links 1, 4, 14, force propagation
  const Lanes<8> t1652_lanes = t1629_lanes + t1500_lanes * t1037_lanes[6] + t1499_lanes *
      t1061_lanes[6] + t1497_lanes * t1089_lanes[6];
  const Lanes<8> t1658_lanes = t1615_lanes - t1619_lanes * t1235_lanes[3] - t1642_lanes *
      t1289_lanes[3];
  const Lanes<8> t1661_lanes = t1257_lanes * t765_lanes[1] + t1254_lanes * t776 + t1272_lanes *
      t796 + t1640_lanes;
  const Lanes<8> t1663_lanes = t1658_lanes * t1343;
  const Lanes<8> t1665_lanes = t1652_lanes + t1525_lanes * t1119_lanes[6] + t1557_lanes *
      t1161_lanes[6] + t1574_lanes * t1173_lanes[6];
  const Lanes<8> t1675_lanes = t1294_lanes * t1290_lanes[0];
  const Lanes<8> t1686_lanes = t1616_lanes - t1619_lanes * t1235_lanes[4] - t1642_lanes *
      t1289_lanes[4] - t1663_lanes * t1332_lanes[4];
  const Lanes<8> t1687_lanes = t1661_lanes + t1500_lanes * t1037_lanes[7] + t1499_lanes *
      t1061_lanes[7] + t1497_lanes * t1089_lanes[7];
  const Lanes<8> t1688_lanes = t1627_lanes - t1619_lanes * t1235_lanes[5] - t1642_lanes *
      t1289_lanes[5] - t1663_lanes * t1332_lanes[5];
  const Lanes<8> t1691_lanes = t1686_lanes * t1359;
  const Lanes<8> t1694_lanes = t1665_lanes - t1594_lanes * t1196_lanes[6] - t1619_lanes *
      t1235_lanes[6] - t1642_lanes * t1289_lanes[6];
  const Lanes<8> t1696_lanes = t1257_lanes * t851_lanes[1] + t1254_lanes * t1232_lanes[0] +
      t1272_lanes * t1265_lanes[0] + t1675_lanes;
  const Lanes<8> t1702_lanes = t1687_lanes + t1525_lanes * t1119_lanes[7] + t1557_lanes *
      t1161_lanes[7] + t1574_lanes * t1173_lanes[7];
  const Lanes<8> t1704_lanes = t1688_lanes - t1691_lanes * t1354_lanes[5];
  const Lanes<8> t1714_lanes = t1704_lanes * t1405;

  // links 1, 4, 15, force propagation
  const Lanes<8> t1719_lanes = t1272_lanes * t1265_lanes[1];
  const Lanes<8> t1722_lanes = t1696_lanes + t1500_lanes * t1439_lanes[0] + t1499_lanes *
      t1464_lanes[0] + t1497_lanes * t1493_lanes[0];
  const Lanes<8> t1728_lanes = t1702_lanes - t1594_lanes * t1196_lanes[7] - t1619_lanes *
      t1235_lanes[7] - t1642_lanes * t1289_lanes[7];
  const Lanes<8> t1736_lanes = t1694_lanes - t1663_lanes * t1332_lanes[6] - t1691_lanes *
      t1354_lanes[6] - t1714_lanes * t1369_lanes[6];
  const Lanes<8> t1739_lanes = t1722_lanes + t1525_lanes * t1521_lanes[0] + t1557_lanes *
      t1554_lanes[0] + t1574_lanes * t1568_lanes[0];
  const Lanes<8> t1740_lanes = t1736_lanes * t1462;
  const Lanes<8> t1741_lanes = t1258_lanes * neg_c12_19_lanes[1] + t1257_lanes * t877_lanes[1] +
      t1254_lanes * t1232_lanes[1] + t1719_lanes;
  const Lanes<8> t1742_lanes = t1728_lanes - t1663_lanes * t1332_lanes[7] - t1691_lanes *
      t1354_lanes[7] - t1714_lanes * t1369_lanes[7];
  const Lanes<8> t1750_lanes = t1742_lanes - t1740_lanes * t1433;

  // links 1 and 2, 5, force propagation
  const Lanes<8> t1751_lanes = t1739_lanes - t1594_lanes * t1588_lanes[0] - t1619_lanes *
      t1613_lanes[0] - t1642_lanes * t1630_lanes[0];
  const Lanes<8> t1752_lanes = t1741_lanes + t1294_lanes * t1290_lanes[1] + t1500_lanes *
      t1439_lanes[1] + t1499_lanes * t1464_lanes[1];
  const Lanes<8> t1753_lanes = t1750_lanes * t1535;
  const Lanes<8> t1760_lanes = t1751_lanes - t1663_lanes * t1658_lanes[0] - t1691_lanes *
      t1686_lanes[0] - t1714_lanes * t1704_lanes[0];
  const Lanes<8> t1761_lanes = t1752_lanes + t1497_lanes * t1493_lanes[1] + t1525_lanes *
      t1521_lanes[1] + t1557_lanes * t1554_lanes[1];

  // links 1 (calf) and 3 (hip), force propagation
  const Lanes<8> t1764_lanes = t1760_lanes - t1740_lanes * t1736_lanes[0] - t1753_lanes *
      t1750_lanes[0];
  const Real t1766 = t1309_lanes[1] + t1500_lanes[2] * t1439_lanes[2] + t1499_lanes[2] *
      t1464_lanes[2] + t1497_lanes[2] * t1493_lanes[2] + t1525_lanes[2] * t1521_lanes[2];
  const Real t1767 = t1764_lanes[0] * t1764_lanes[0];
  const Lanes<8> t1768_lanes = t1761_lanes + t1574_lanes * t1568_lanes[1] - t1594_lanes *
      t1588_lanes[1] - t1619_lanes * t1613_lanes[1];
  const Real t1769 = t1767 * t1764_lanes[0];
  const Lanes<8> t1772_lanes = t1768_lanes - t1642_lanes * t1630_lanes[1] - t1663_lanes *
      t1658_lanes[1] - t1691_lanes * t1686_lanes[1];
  const Real t1773 = t1766 + t1557_lanes[2] * t1554_lanes[2] + t1574_lanes[2] * t1568_lanes[2] -
      t1594_lanes[2] * t1588_lanes[2] - t1619_lanes[2] * t1613_lanes[2];
  const Real t1775 = t1769 * t1767 / (3.0814879110195774e-33 + t1769 * t1769);
  const Lanes<8> t1777_lanes = t1772_lanes - t1714_lanes * t1704_lanes[1] - t1740_lanes *
      t1736_lanes[1] - t1753_lanes * t1750_lanes[1];
  const Real t1778 = t1308_lanes[1] + t1500_lanes[3] * t1439_lanes[2] + t1499_lanes[3] *
      t1464_lanes[2] + t1497_lanes[3] * t1493_lanes[2] + t1525_lanes[3] * t1521_lanes[2];
  const Real t1779 = t1773 - t1642_lanes[2] * t1630_lanes[2] - t1663_lanes[2] * t1658_lanes[2] -
      t1691_lanes[2] * t1686_lanes[2] - t1714_lanes[2] * t1704_lanes[2];
  const Lanes<8> t1780_lanes = t1764_lanes * t1775;
  const Real t1782 = t1778 + t1557_lanes[3] * t1554_lanes[2] + t1574_lanes[3] * t1568_lanes[2] -
      t1594_lanes[3] * t1588_lanes[2] - t1619_lanes[3] * t1613_lanes[2];
  const Lanes<8> t1783_lanes = t1777_lanes - t1780_lanes * t1764_lanes[1];
  const Real t1784 = t1783_lanes[1] * t1783_lanes[1];
  const Real t1785 = t1325_lanes[1] + t1500_lanes[3] * t1439_lanes[3] + t1499_lanes[3] *
      t1464_lanes[3] + t1497_lanes[3] * t1493_lanes[3] + t1525_lanes[3] * t1521_lanes[3];
  const Real t1786 = t1784 * t1783_lanes[1];
  const Real t1787 = t1782 - t1642_lanes[3] * t1630_lanes[2] - t1663_lanes[3] * t1658_lanes[2] -
      t1691_lanes[3] * t1686_lanes[2] - t1714_lanes[3] * t1704_lanes[2];

  // link 24 (right_eye), outward; link 1 (calf), force propagation
  const Lanes<2> t1789_lanes = minus_gravity_z + detail::make_pack<Real>(xdd_cmd[2], xdd_cmd[8]);
  const Lanes<2> t1794_lanes = c1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) - s1 *
      t1789_lanes;
  const Lanes<2> t1795_lanes = s1 * detail::make_pack<Real>(xdd_cmd[0], xdd_cmd[6]) + c1 *
      t1789_lanes;
  const Real t1796 = t1785 + t1557_lanes[3] * t1554_lanes[3] + t1574_lanes[3] * t1568_lanes[3] -
      t1594_lanes[3] * t1588_lanes[3] - t1619_lanes[3] * t1613_lanes[3];
  const Real t1797 = t1786 * t1784 / (1.4551915228366852e-11 + t1786 * t1786);
  const Lanes<2> t1803_lanes = c2_plus_3 * t1794_lanes - s2_plus_3 * t1795_lanes;
  const Lanes<2> t1804_lanes = s2_plus_3 * t1794_lanes + c2_plus_3 * t1795_lanes;
  const Lanes<2> t1809_lanes = c4 * t1803_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]);
  const Lanes<2> t1810_lanes = s4 * t1803_lanes - c4 *
      detail::make_pack<Real>(xdd_cmd[1], xdd_cmd[7]);
  const Real t1811 = t1796 - t1642_lanes[3] * t1630_lanes[3] - t1663_lanes[3] * t1658_lanes[3] -
      t1691_lanes[3] * t1686_lanes[3] - t1714_lanes[3] * t1704_lanes[3];
  const Real t1812 = t1783_lanes[2] * t1797;
  const Real t1813 = t1783_lanes[3] * t1797;
  const Lanes<2> t1818_lanes = s5 * t1809_lanes + c5 * t1804_lanes;
  const Lanes<2> t1819_lanes = c5 * t1809_lanes - s5 * t1804_lanes;
  const Real t1820 = t1779 - t1740_lanes[2] * t1736_lanes[2] - t1753_lanes[2] * t1750_lanes[2] -
      t1780_lanes[2] * t1764_lanes[2] - t1812 * t1783_lanes[2];
  const Real t1821 = t1787 - t1740_lanes[3] * t1736_lanes[2] - t1753_lanes[3] * t1750_lanes[2] -
      t1780_lanes[3] * t1764_lanes[2] - t1813 * t1783_lanes[2];
  const Real t1826 = t1820 * t1820;
  const Lanes<2> t1827_lanes = c6 * t1818_lanes + s6 * t1810_lanes;
  const Lanes<2> t1828_lanes = s6 * t1818_lanes - c6 * t1810_lanes;
  const Real t1829 = t1811 - t1740_lanes[3] * t1736_lanes[3] - t1753_lanes[3] * t1750_lanes[3] -
      t1780_lanes[3] * t1764_lanes[3] - t1813 * t1783_lanes[3];
  const Real t1830 = t1826 * t1820;

  // links 1 and 2, 24, outward
  const Real wd2_z = qdd_0[0] + qdd_0[1];
  const Real w2_z = qd[0] + qd[1];
  const Real t1835 = w2_z * w2_z;
  const Real minus_a1_y = minus_gravity_z * c1;
  const Lanes<2> t1836_lanes = detail::make_pack<Real>(c7, c14) * t1827_lanes +
      detail::make_pack<Real>(s7, s14) * t1819_lanes;
  const Lanes<2> t1837_lanes = detail::make_pack<Real>(c7, c14) * t1819_lanes -
      detail::make_pack<Real>(s7, s14) * t1827_lanes;
  const Real minus_a1_x = minus_gravity_z * s1;

  // links 2 (thigh) and 3 (hip), outward
  const Real w3_z = w2_z + qd[2];
  const Real a2_y = minus_link1_to_2_y * (qd[0] * qd[0]) - minus_a1_y;
  const Real t1842 = w3_z * w3_z;
  const Real wd3_z = wd2_z + qdd_0[2];
  const Real a2_x = minus_link1_to_2_y * qdd_0[0] - minus_a1_x;

  // links 3, 5, 24, outward; link 1 (calf), force propagation
  const Lanes<2> t1843_lanes = detail::make_pack<Real>(s8, s15) * t1836_lanes +
      detail::make_pack<Real>(c8, c15) * t1828_lanes;
  const Real t1844 = t1830 * t1826 / (2.2737367544323206e-13 + t1830 * t1830);
  const Lanes<2> t1845_lanes = detail::make_pack<Real>(s8, s15) * t1828_lanes -
      detail::make_pack<Real>(c8, c15) * t1836_lanes;
  const Real t1846 = a2_y + (wd2_z * t760 + t1835 * t759);
  const Real t1847 = s4 * w3_z;
  const Real t1848 = a2_x + (wd2_z * t759 - t1835 * t760);

  // links 4 and 5, 24, outward
  const Real wd4_x = w3_z * qd[3];
  const Real w5_z = c4 * w3_z + qd[4];
  const Lanes<2> t1853_lanes = detail::make_pack<Real>(s9, s16) * t1843_lanes +
      detail::make_pack<Real>(c9, c16) * t1837_lanes;
  const Lanes<2> t1854_lanes = detail::make_pack<Real>(c9, c16) * t1843_lanes -
      detail::make_pack<Real>(s9, s16) * t1837_lanes;
  const Real w5_x = c5 * t1847 - s5 * qd[3];

  // links 3 (hip) and 5 (chest2), outward
  const Real a3_x = c2_plus_3 * t1848 + s2_plus_3 * t1846;
  const Real a3_y = c2_plus_3 * t1846 - s2_plus_3 * t1848;
  const Real t1855 = w5_z * w5_z;
  const Real minus_w5_y = s5 * t1847 + c5 * qd[3];
  const Real t1859 = a3_x + link4_to_5_z * wd3_z;
  const Real t1860 = w5_x * w5_x;
  const Real t1861 = c4 * wd4_x + s4 * wd3_z;
  const Real t1862 = a3_y + link4_to_5_z * t1842;

  // links 5 and 6, 24, outward; link 1 (calf), force propagation
  const Real w6_z = w5_x + qd[5];
  const Real t1863 = t1821 * t1844;
  const Lanes<2> t1864_lanes = detail::make_pack<Real>(c10, c17) * t1853_lanes +
      detail::make_pack<Real>(s10, s17) * t1845_lanes;
  const Lanes<2> t1865_lanes = detail::make_pack<Real>(c10, c17) * t1845_lanes -
      detail::make_pack<Real>(s10, s17) * t1853_lanes;
  const Real t1866 = c4 * t1859;

  // links 5 (chest2) and 6 (chest3), outward
  const Real t1867 = t1860 + t1855;
  const Real minus_a5_z = s4 * t1859;
  const Real t1868 = w6_z * w6_z;
  const Real t1869 = w5_x * minus_w5_y;
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real t1872 = w6_x * w6_y;
  const Real t1873 = w6_x * w6_z;
  const Real wd5_x = c5 * t1861 - s5 * qdd_0[3] - minus_w5_y * qd[4];
  const Real a5_y = c5 * t1862 - s5 * t1866;

  // links 5 and 6, 24, outward; link 1 (calf), force propagation
  const Lanes<2> t1874_lanes = detail::make_pack<Real>(c11, c18) * t1864_lanes +
      detail::make_pack<Real>(s11, s18) * t1854_lanes;
  const Real wd5_z = qdd_0[4] - (s4 * wd4_x - c4 * wd3_z);
  const Real t1875 = w6_y * w6_z;
  const Real a5_x = c5 * t1866 + s5 * t1862;
  const Real t1876 = t1829 - t1863 * t1821;

  // links 5 (chest2) and 6 (chest3), outward
  const Real t1877 = wd5_x - minus_w5_y * w5_z;
  const Real wd6_z = wd5_x + qdd_0[5];
  const Real t1878 = a5_y + minus_link5_to_6_y * t1867;
  const Real t1879 = w6_y * w6_y + t1868;
  const Real t1880 = s5 * t1861 + c5 * qdd_0[3] + (w5_z + qd[4]) * w5_x;
  const Real t1882 = wd5_z - t1869;
  const Real t1883 = t1869 + wd5_z;

  // link 1 (calf), force propagation; link 6 (chest3), outward
  const Real t1884 = t1876 * t1876;
  const Real t1885 = t1872 - wd6_z;
  const Real t1886 = w6_x * w6_x;
  const Real t1887 = t1872 + wd6_z;
  const Real t1892 = minus_a5_z + minus_link5_to_6_y * t1877;
  const Real t1895 = t1884 * t1876;
  const Real t1896 = t1886 + t1868;
  const Real t1897 = c6 * t1880 - s6 * t1882;
  const Real a6_z = a5_x + minus_link5_to_6_y * t1883;

  // links 6 to 8, 14 and 15, outward
  const Lanes<2> w7_14_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;
  const Lanes<2> w7_14_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);
  const Lanes<2> w7_14_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;
  const Real wd6_x = t1875 - t1897;
  const Real wd6_y = c6 * t1882 + s6 * t1880 - t1873;
  const Lanes<2> w8_15_z_lanes = w7_14_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);

  // links 6 and 7, 14, outward
  const Lanes<2> t1903_lanes = w7_14_x_lanes * w7_14_y_lanes;
  const Real a6_x = c6 * t1878 - s6 * t1892;
  const Real t1905 = t1875 + wd6_x;
  const Real t1906 = t1873 - wd6_y;
  const Lanes<2> wd7_14_z_lanes = wd6_y + detail::make_pack<Real>(qdd_0[6], qdd_0[13]);
  const Lanes<2> t1907_lanes = w7_14_y_lanes * w7_14_z_lanes;
  const Real minus_a6_y = s6 * t1878 + c6 * t1892;
  const Real t1911 = a6_x + 0.226 * t1879;

  // links 7 and 8, 14 and 15, outward
  const Lanes<2> w8_15_x_lanes = detail::make_pack<Real>(c8, c15) * w7_14_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_14_z_lanes;
  const Lanes<2> t1915_lanes = t1903_lanes + wd7_14_z_lanes;
  const Real t1916 = minus_a6_y + 0.226 * t1887;
  const Lanes<2> w8_15_y_lanes = detail::make_pack<Real>(c8, c15) * w7_14_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_14_y_lanes;
  const Lanes<2> t1917_lanes = t1911 + detail::make_pack<Real>(0.18, (-0.18)) * t1885;
  const Lanes<2> t1918_lanes = w8_15_z_lanes * w8_15_z_lanes;
  const Lanes<2> t1919_lanes = detail::make_pack<Real>(s7, s14) * t1885 +
      detail::make_pack<Real>(c7, c14) * t1905;
  const Real t1920 = a6_z - 0.226 * t1906;
  const Lanes<2> t1921_lanes = detail::make_pack<Real>(c7, c14) * t1885 -
      detail::make_pack<Real>(s7, s14) * t1905;
  const Lanes<2> t1925_lanes = w8_15_x_lanes * w8_15_y_lanes;
  const Lanes<2> minus_a7_14_z_lanes = t1916 + detail::make_pack<Real>(0.18, (-0.18)) * t1896;
  const Lanes<2> t1927_lanes = w8_15_y_lanes * w8_15_y_lanes;
  const Lanes<2> t1928_lanes = 2.0 * (w7_14_x_lanes * w7_14_z_lanes) - t1919_lanes;
  const Lanes<2> t1929_lanes = t1920 + detail::make_pack<Real>(0.18, (-0.18)) * t1905;
  const Lanes<2> wd7_14_x_lanes = t1907_lanes - t1921_lanes;
  const Lanes<2> t1934_lanes = w8_15_y_lanes * w8_15_z_lanes;
  const Lanes<2> wd8_15_z_lanes = wd7_14_x_lanes + detail::make_pack<Real>(qdd_0[7], qdd_0[14]);
  const Lanes<2> t1943_lanes = t1927_lanes + t1918_lanes;
  const Lanes<2> t1944_lanes = t1925_lanes + wd8_15_z_lanes;

  // links 7 to 9, 14 to 16, outward
  const Lanes<2> w9_16_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_15_x_lanes;
  const Lanes<2> t1945_lanes = detail::make_pack<Real>(c8, c15) * t1915_lanes +
      detail::make_pack<Real>(s8, s15) * t1928_lanes;
  const Lanes<2> a7_14_y_lanes = detail::make_pack<Real>(c7, c14) * t1917_lanes -
      detail::make_pack<Real>(s7, s14) * t1929_lanes;
  const Lanes<2> t1946_lanes = detail::make_pack<Real>(c8, c15) * t1928_lanes -
      detail::make_pack<Real>(s8, s15) * t1915_lanes;
  const Lanes<2> w9_16_x_lanes = detail::make_pack<Real>(s9, s16) * w8_15_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_15_z_lanes;
  const Lanes<2> a7_14_x_lanes = detail::make_pack<Real>(s7, s14) * t1917_lanes +
      detail::make_pack<Real>(c7, c14) * t1929_lanes;

  // links 8 and 9, 15 and 16, outward
  const Lanes<2> w9_16_y_lanes = detail::make_pack<Real>(c9, c16) * w8_15_y_lanes -
      detail::make_pack<Real>(s9, s16) * w8_15_z_lanes;
  const Lanes<2> t1951_lanes = 2.0 * (w8_15_x_lanes * w8_15_z_lanes) - t1945_lanes;
  const Lanes<2> wd8_15_x_lanes = t1934_lanes - t1946_lanes;
  const Lanes<2> t1956_lanes = w9_16_x_lanes * w9_16_z_lanes;
  const Lanes<2> t1959_lanes = w9_16_x_lanes * w9_16_y_lanes;

  // links 8 to 10, 15 to 17, outward
  const Lanes<2> w10_17_z_lanes = w9_16_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);
  const Lanes<2> wd9_16_z_lanes = detail::make_pack<Real>(qdd_0[8], qdd_0[15]) - wd8_15_x_lanes;
  const Lanes<2> minus_a8_15_y_lanes = detail::make_pack<Real>(s8, s15) * a7_14_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_14_z_lanes;
  const Lanes<2> a8_15_x_lanes = detail::make_pack<Real>(c8, c15) * a7_14_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_14_z_lanes;
  const Lanes<2> minus_w10_17_y_lanes = detail::make_pack<Real>(s10, s17) * w9_16_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_16_z_lanes;

  // links 9 and 10, 16 and 17, outward
  const Lanes<2> t1965_lanes = t1959_lanes - wd9_16_z_lanes;
  const Lanes<2> t1966_lanes = w10_17_z_lanes * w10_17_z_lanes;
  const Lanes<2> t1967_lanes = detail::make_pack<Real>(s9, s16) * t1951_lanes -
      detail::make_pack<Real>(c9, c16) * t1944_lanes;
  const Lanes<2> t1969_lanes = detail::make_pack<Real>(s9, s16) * t1944_lanes +
      detail::make_pack<Real>(c9, c16) * t1951_lanes;
  const Lanes<2> w10_17_x_lanes = detail::make_pack<Real>(c10, c17) * w9_16_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_16_z_lanes;
  const Lanes<2> t1971_lanes = 0.282 * t1943_lanes - a8_15_x_lanes;
  const Lanes<2> t1975_lanes = 2.0 * (w9_16_y_lanes * w9_16_z_lanes) - t1967_lanes;
  const Lanes<2> minus_wd9_16_y_lanes = t1969_lanes + t1956_lanes;
  const Lanes<2> t1977_lanes = w10_17_x_lanes * minus_w10_17_y_lanes;
  const Lanes<2> a9_16_x_lanes = detail::make_pack<Real>(c9, c16) * a7_14_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_15_y_lanes;
  const Lanes<2> minus_a9_16_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_15_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_14_x_lanes;

  // links 10 and 11, 17 and 18, outward
  const Lanes<2> t1983_lanes = w10_17_x_lanes * w10_17_x_lanes;
  const Lanes<2> wd10_17_z_lanes = detail::make_pack<Real>(qdd_0[9], qdd_0[16]) -
      minus_wd9_16_y_lanes;
  const Lanes<2> w11_18_z_lanes = minus_w10_17_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);
  const Lanes<2> t1986_lanes = a9_16_x_lanes + 0.282 * t1969_lanes;
  const Lanes<2> w11_18_x_lanes = detail::make_pack<Real>(c11, c18) * w10_17_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_17_z_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), outward
  const Lanes<2> t1992_lanes = 0.086 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> t1994_lanes = t1977_lanes + wd10_17_z_lanes;
  const Lanes<2> minus_a10_17_z_lanes = minus_a9_16_y_lanes + 0.282 * t1967_lanes;
  const Lanes<2> t1996_lanes = detail::make_pack<Real>(s10, s17) * t1965_lanes +
      detail::make_pack<Real>(c10, c17) * t1975_lanes;
  const Lanes<2> t1999_lanes = t1983_lanes + t1966_lanes;

  // links 10 and 11, 17 and 18, 24, outward
  const Lanes<2> t2000_lanes = c1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) - s1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);
  const Lanes<2> w11_18_y_lanes = detail::make_pack<Real>(c11, c18) * w10_17_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_17_x_lanes;
  const Lanes<2> t2003_lanes = s1 * detail::make_pack<Real>(xdd_cmd[3], xdd_cmd[9]) + c1 *
      detail::make_pack<Real>(xdd_cmd[5], xdd_cmd[11]);
  const Lanes<2> t2006_lanes = t1996_lanes - 2.0 * (minus_w10_17_y_lanes * w10_17_z_lanes);
  const Lanes<2> a10_17_x_lanes = detail::make_pack<Real>(c10, c17) * t1986_lanes -
      detail::make_pack<Real>(s10, s17) * t1971_lanes;
  const Lanes<2> minus_a10_17_y_lanes = detail::make_pack<Real>(s10, s17) * t1986_lanes +
      detail::make_pack<Real>(c10, c17) * t1971_lanes;

  // links 12 and 13, 19 and 20, outward
  const Lanes<2> w12_19_x_lanes = detail::make_pack<Real>(c12, c19) * w11_18_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_18_z_lanes;
  const Lanes<2> w12_19_z_lanes = w11_18_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);
  const Lanes<2> t2014_lanes = minus_a10_17_y_lanes + 0.269 * t1999_lanes;
  const Lanes<2> w13_20_z_lanes = w12_19_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> t2015_lanes = w12_19_z_lanes * w12_19_z_lanes;

  // links 11, 13, 18, 20, 24, outward
  const Lanes<2> t2016_lanes = c2_plus_3 * t2000_lanes - s2_plus_3 * t2003_lanes;
  const Lanes<2> t2017_lanes = s2_plus_3 * t2000_lanes + c2_plus_3 * t2003_lanes;
  const Lanes<2> t2018_lanes = detail::make_pack<Real>(c11, c18) * t1994_lanes -
      detail::make_pack<Real>(s11, s18) * t2006_lanes;
  const Lanes<2> a11_18_x_lanes = detail::make_pack<Real>(c11, c18) * a10_17_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_17_z_lanes;
  const Lanes<2> t2020_lanes = w13_20_z_lanes * w13_20_z_lanes;
  const Lanes<2> t2026_lanes = t2015_lanes + t2020_lanes;

  // links 12, 19, 24, outward
  const Lanes<2> t2027_lanes = c4 * t2016_lanes + s4 *
      detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]);
  const Lanes<2> t2028_lanes = s4 * t2016_lanes - c4 *
      detail::make_pack<Real>(xdd_cmd[4], xdd_cmd[10]);
  const Lanes<2> t2029_lanes = a11_18_x_lanes - 0.269 * t2018_lanes;
  const Lanes<2> t2038_lanes = s5 * t2027_lanes + c5 * t2017_lanes;
  const Lanes<2> t2039_lanes = c5 * t2027_lanes - s5 * t2017_lanes;
  const Lanes<2> t2040_lanes = 0.086 * detail::make_pack<Real>(s13, s20);
  const Lanes<2> minus_w12_19_y_lanes = detail::make_pack<Real>(s12, s19) * w11_18_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_18_z_lanes;
  const Lanes<2> minus_a12_19_y_lanes = detail::make_pack<Real>(s12, s19) * t2029_lanes +
      detail::make_pack<Real>(c12, c19) * t2014_lanes;
  const Lanes<2> t2045_lanes = minus_w12_19_y_lanes * w12_19_z_lanes;
  const Lanes<2> t2053_lanes = c6 * t2038_lanes + s6 * t2028_lanes;
  const Lanes<2> t2054_lanes = s6 * t2038_lanes - c6 * t2028_lanes;
  const Lanes<2> t2055_lanes = minus_w12_19_y_lanes * minus_w12_19_y_lanes;

  // links 11, 13, 18, 20, 24, outward; link 1 (calf), force propagation
  const Lanes<2> minus_a11_18_y_lanes = detail::make_pack<Real>(s11, s18) * a10_17_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_17_z_lanes;
  const Lanes<2> t2056_lanes = detail::make_pack<Real>(c12, c19) * t1865_lanes -
      detail::make_pack<Real>(s12, s19) * t1874_lanes + minus_a12_19_y_lanes + t2026_lanes *
      t1992_lanes;
  const Lanes<2> t2057_lanes = detail::make_pack<Real>(s11, s18) * t1994_lanes +
      detail::make_pack<Real>(c11, c18) * t2006_lanes;
  const Lanes<2> t2063_lanes = t2055_lanes + t2020_lanes;
  const Lanes<2> t2069_lanes = detail::make_pack<Real>(c7, c14) * t2053_lanes +
      detail::make_pack<Real>(s7, s14) * t2039_lanes;
  const Lanes<2> t2070_lanes = detail::make_pack<Real>(c7, c14) * t2039_lanes -
      detail::make_pack<Real>(s7, s14) * t2053_lanes;

  // links 12 and 13, 19 and 20, outward; link 1 (calf), force propagation
  const Lanes<2> a12_19_z_lanes = 0.269 * t2057_lanes - minus_a11_18_y_lanes;
  const Lanes<2> a12_19_x_lanes = detail::make_pack<Real>(c12, c19) * t2029_lanes -
      detail::make_pack<Real>(s12, s19) * t2014_lanes;
  const Lanes<2> t2073_lanes = minus_w12_19_y_lanes * w13_20_z_lanes;
  const Lanes<2> t2079_lanes = detail::make_pack<Real>(c12, c19) * t1874_lanes +
      detail::make_pack<Real>(s12, s19) * t1865_lanes - a12_19_x_lanes;
  const Lanes<2> t2080_lanes = w12_19_z_lanes * w13_20_z_lanes;

  // links 10, 17, 24, outward; link 1 (calf), force propagation
  const Lanes<2> t2081_lanes = detail::make_pack<Real>(s8, s15) * t2069_lanes +
      detail::make_pack<Real>(c8, c15) * t2054_lanes;
  const Lanes<2> t2082_lanes = detail::make_pack<Real>(s8, s15) * t2054_lanes -
      detail::make_pack<Real>(c8, c15) * t2069_lanes;
  const Lanes<2> t2083_lanes = detail::make_pack<Real>(c11, c18) * t1854_lanes -
      detail::make_pack<Real>(s11, s18) * t1864_lanes - a12_19_z_lanes + t2063_lanes * t2040_lanes;
  const Lanes<2> t2090_lanes = w10_17_x_lanes * w10_17_z_lanes;
  const Lanes<2> t2091_lanes = detail::make_pack<Real>(s9, s16) * t2081_lanes +
      detail::make_pack<Real>(c9, c16) * t2070_lanes;

  // links 10 and 11, 17 and 18, 24, outward
  const Lanes<2> t2092_lanes = detail::make_pack<Real>(c9, c16) * t2081_lanes -
      detail::make_pack<Real>(s9, s16) * t2070_lanes;
  const Lanes<2> t2093_lanes = w11_18_x_lanes * w11_18_y_lanes;
  const Lanes<2> t2094_lanes = detail::make_pack<Real>(c10, c17) * t1965_lanes -
      detail::make_pack<Real>(s10, s17) * t1975_lanes;
  const Lanes<2> wd10_17_y_lanes = t2094_lanes - t2090_lanes;
  const Lanes<2> t2101_lanes = detail::make_pack<Real>(c10, c17) * t2091_lanes +
      detail::make_pack<Real>(s10, s17) * t2082_lanes;

  // links 11, 18, 24, outward
  const Lanes<2> t2102_lanes = detail::make_pack<Real>(c10, c17) * t2082_lanes -
      detail::make_pack<Real>(s10, s17) * t2091_lanes;
  const Lanes<2> wd11_18_z_lanes = detail::make_pack<Real>(qdd_0[10], qdd_0[17]) - wd10_17_y_lanes;
  const Lanes<2> t2107_lanes = t2093_lanes - wd11_18_z_lanes;
  const Lanes<2> t2109_lanes = t2057_lanes + 2.0 * (w11_18_y_lanes * w11_18_z_lanes);
  const Lanes<2> t2111_lanes = w11_18_x_lanes * w11_18_z_lanes;
  const Lanes<2> t2113_lanes = detail::make_pack<Real>(c11, c18) * t2101_lanes +
      detail::make_pack<Real>(s11, s18) * t2092_lanes;

  // links 11 and 12, 18 and 19, 24, outward
  const Lanes<2> t2115_lanes = detail::make_pack<Real>(c11, c18) * t2092_lanes -
      detail::make_pack<Real>(s11, s18) * t2101_lanes;
  const Lanes<2> t2116_lanes = w12_19_x_lanes * minus_w12_19_y_lanes;
  const Lanes<2> wd11_18_y_lanes = t2018_lanes - t2111_lanes;
  const Lanes<2> t2120_lanes = detail::make_pack<Real>(c12, c19) * t2107_lanes -
      detail::make_pack<Real>(s12, s19) * t2109_lanes;
  const Lanes<2> wd12_19_z_lanes = wd11_18_y_lanes + detail::make_pack<Real>(qdd_0[11], qdd_0[18]);

  // link 1 (calf), force propagation; links 12, 19, 24, outward
  const Lanes<2> t2121_lanes = (t2073_lanes + t2115_lanes) * t1992_lanes;
  const Lanes<2> t2122_lanes = detail::make_pack<Real>(c12, c19) * t2113_lanes +
      detail::make_pack<Real>(s12, s19) * t2102_lanes;
  const Lanes<2> t2123_lanes = detail::make_pack<Real>(c12, c19) * t2102_lanes -
      detail::make_pack<Real>(s12, s19) * t2113_lanes;
  const Lanes<2> t2124_lanes = 2.0 * (w12_19_x_lanes * w12_19_z_lanes) - t2120_lanes;
  const Lanes<2> t2127_lanes = wd12_19_z_lanes - t2116_lanes;

  // links 13, 20, 24, outward; link 1 (calf), force propagation
  const Lanes<2> wd13_20_x_lanes = t2080_lanes - t2124_lanes;
  const Lanes<2> wd13_20_y_lanes = t2127_lanes + t2073_lanes;
  const Lanes<2> t2132_lanes = (t2045_lanes + t2122_lanes) * t2040_lanes;
  const Lanes<2> t2133_lanes = (t2045_lanes - t2122_lanes) * t1992_lanes;
  const Lanes<2> t2134_lanes = (t2080_lanes + t2123_lanes) * t2040_lanes;
  const Lanes<2> t2135_lanes = t2123_lanes - wd13_20_x_lanes;

  // links 12 and 13, 19 and 20, 24, outward
  const Lanes<2> t2136_lanes = t2115_lanes - wd13_20_y_lanes;
  const Lanes<2> wd12_19_x_lanes = detail::make_pack<Real>(s12, s19) * t2107_lanes +
      detail::make_pack<Real>(c12, c19) * t2109_lanes - t2045_lanes;
  const Real t2137 = t2056_lanes[0] + t2132_lanes[0];
  const Lanes<2> wd13_20_z_lanes = wd12_19_x_lanes + detail::make_pack<Real>(qdd_0[12], qdd_0[19]);
  const Lanes<2> t2138_lanes = t2122_lanes - wd13_20_z_lanes;

  // link 1 (calf), force propagation
  const Real t2139 = t2083_lanes[0] - t1221_lanes[1] * t2137 + t2133_lanes[0];
  const Real t2140 = t2079_lanes[0] - t1221_lanes[2] * t2137 - t1275_lanes[2] * t2139 +
      t2121_lanes[0] - t2134_lanes[0];
  const Real t2141 = t2135_lanes[0] - t1221_lanes[3] * t2137 - t1275_lanes[3] * t2139 -
      t1324_lanes[3] * t2140;
  const Real t2142 = t2136_lanes[0] - t1221_lanes[4] * t2137 - t1275_lanes[4] * t2139 -
      t1324_lanes[4] * t2140 - t1346_lanes[4] * t2141;
  const Real t2143 = t2138_lanes[0] - t1221_lanes[5] * t2137 - t1275_lanes[5] * t2139 -
      t1324_lanes[5] * t2140 - t1346_lanes[5] * t2141;
  const Real t2144 = t2056_lanes[1] - t1221_lanes[6] * t2137 - t1275_lanes[6] * t2139 -
      t1324_lanes[6] * t2140 - t1346_lanes[6] * t2141;
  const Real t2145 = t2083_lanes[1] - t1221_lanes[7] * t2137 - t1275_lanes[7] * t2139 -
      t1324_lanes[7] * t2140 - t1346_lanes[7] * t2141;
  const Real t2146 = t2079_lanes[1] - t1594_lanes[0] * t2137 - t1619_lanes[0] * t2139 -
      t1642_lanes[0] * t2140 - t1663_lanes[0] * t2141;
  const Real t2147 = t2143 - t1362_lanes[5] * t2142;
  const Real t2148 = t2135_lanes[1] - t1594_lanes[1] * t2137 - t1619_lanes[1] * t2139 -
      t1642_lanes[1] * t2140 - t1663_lanes[1] * t2141;
  const Real t2149 = t2144 - t1362_lanes[6] * t2142 - t1425 * t2147 + t2132_lanes[1];
  const Real t2150 = t2136_lanes[1] - t1594_lanes[2] * t2137 - t1619_lanes[2] * t2139 -
      t1642_lanes[2] * t2140 - t1663_lanes[2] * t2141;
  const Real t2151 = t2138_lanes[1] - t1594_lanes[3] * t2137 - t1619_lanes[3] * t2139 -
      t1642_lanes[3] * t2140 - t1663_lanes[3] * t2141;
  const Real t2152 = t2145 - t1362_lanes[7] * t2142 - t1426 * t2147 - t1486 * t2149 +
      t2133_lanes[1];
  const Real t2153 = t2146 - t1691_lanes[0] * t2142 - t1714_lanes[0] * t2147 - t1740_lanes[0] *
      t2149 - t1753_lanes[0] * t2152;
  const Real t2154 = t2148 - t1691_lanes[1] * t2142 - t1714_lanes[1] * t2147 - t1740_lanes[1] *
      t2149 - t1753_lanes[1] * t2152;
  const Real t2155 = t2150 - t1691_lanes[2] * t2142 - t1714_lanes[2] * t2147 - t1740_lanes[2] *
      t2149 - t1753_lanes[2] * t2152;
  const Real t2156 = t2151 - t1691_lanes[3] * t2142 - t1714_lanes[3] * t2147 - t1740_lanes[3] *
      t2149 - t1753_lanes[3] * t2152;
  const Real t2157 = t2153 + t2121_lanes[1] - t2134_lanes[1];
  const Real t2158 = t2154 - t1780_lanes[1] * t2157;
  const Real t2159 = t2155 - t1780_lanes[2] * t2157 - t1812 * t2158;
  const Real t2160 = (t2156 - t1780_lanes[3] * t2157 - t1813 * t2158 - t1863 * t2159) *
      (t1895 * t1884 / (2.2737367544323206e-13 + t1895 * t1895));
  const Real t2161 = t2159 * t1844 - t1863 * t2160;
  const Real t2162 = t2158 * t1797 - t1812 * t2161 - t1813 * t2160;
  const Real t2163 = t2157 * t1775 - t1780_lanes[1] * t2162 - t1780_lanes[2] * t2161 -
      t1780_lanes[3] * t2160;
  const Real t2164 = t2152 * t1535 - t1753_lanes[0] * t2163 - t1753_lanes[1] * t2162 -
      t1753_lanes[2] * t2161 - t1753_lanes[3] * t2160;
  const Real t2165 = t2149 * t1462 - t1486 * t2164 - t1740_lanes[0] * t2163 - t1740_lanes[1] *
      t2162 - t1740_lanes[2] * t2161;
  const Real t2166 = t2165 - t1740_lanes[3] * t2160;
  const Real t2167 = t2147 * t1405 - t1425 * t2166 - t1426 * t2164 - t1714_lanes[0] * t2163 -
      t1714_lanes[1] * t2162;
  const Real t2168 = t2167 - t1714_lanes[2] * t2161 - t1714_lanes[3] * t2160;
  const Real t2169 = t2142 * t1359 - t1362_lanes[5] * t2168 - t1362_lanes[6] * t2166 -
      t1362_lanes[7] * t2164 - t1691_lanes[0] * t2163;
  const Real t2170 = t2169 - t1691_lanes[1] * t2162 - t1691_lanes[2] * t2161 - t1691_lanes[3] *
      t2160;
  const Real t2171 = t2141 * t1343 - t1346_lanes[4] * t2170 - t1346_lanes[5] * t2168 -
      t1346_lanes[6] * t2166 - t1346_lanes[7] * t2164;

  // links 13 (left_hand) and 20 (right_hand), outward and inertial wrench; link 1 (calf), force
  //   propagation
  const Lanes<2> t2172_lanes = t2045_lanes + wd13_20_z_lanes;
  const Lanes<2> t2177_lanes = t2026_lanes * t15_lanes + t2172_lanes * t14_lanes;
  const Real t2179 = t2171 - t1663_lanes[0] * t2163 - t1663_lanes[1] * t2162 - t1663_lanes[2] *
      t2161 - t1663_lanes[3] * t2160;
  const Lanes<2> t2181_lanes = t2080_lanes + wd13_20_x_lanes;
  const Lanes<2> t2182_lanes = t2073_lanes + wd13_20_y_lanes;

  // links 12 and 13, 19 and 20, inertial wrench; links 11 and 12, 18 and 19, outward
  const Lanes<2> t2185_lanes = 0.0025100003499999995 * t2127_lanes - 0.0006000000000000001 *
      (w12_19_x_lanes * w12_19_x_lanes + t2015_lanes);
  const Lanes<2> t2186_lanes = t2116_lanes + wd12_19_z_lanes;
  const Lanes<2> t2190_lanes = t2181_lanes * t14_lanes - t2182_lanes * t15_lanes;
  const Lanes<2> t2191_lanes = w11_18_y_lanes * w11_18_y_lanes;
  const Lanes<2> t2192_lanes = w11_18_z_lanes * w11_18_z_lanes;
  const Lanes<2> t2194_lanes = 0.0025100003499999995 * (t2055_lanes + t2015_lanes) +
      0.0006000000000000001 * t2186_lanes;

  // link 1 (calf), force propagation; links 11 to 13, 18 to 20, outward; links 11 (left_wrist1)
  //   and 18 (right_wrist1), inertial wrench
  const Real t2196 = t2140 * t1315 - t1324_lanes[3] * t2179 - t1324_lanes[4] * t2170 -
      t1324_lanes[5] * t2168 - t1324_lanes[6] * t2166;
  const Lanes<2> t2197_lanes = wd13_20_z_lanes - t2045_lanes;
  const Lanes<2> t2202_lanes = wd12_19_x_lanes - t2045_lanes;
  const Lanes<2> t2203_lanes = detail::make_pack<Real>(0.001, (-0.001)) * t2107_lanes - 6e-04 *
      (t2191_lanes + t2192_lanes);
  const Lanes<2> t2205_lanes = t2093_lanes + wd11_18_z_lanes;

  // links 12 and 13, 19 and 20, inertial wrench; links 10 and 11, 17 and 18, outward; link 1
  //   (calf), force propagation
  const Lanes<2> t2206_lanes = t2197_lanes * t15_lanes - t2063_lanes * t14_lanes;
  const Lanes<2> t2207_lanes = w11_18_x_lanes * w11_18_x_lanes;
  const Lanes<2> t2209_lanes = 0.0025100003499999995 * t2124_lanes + 0.0006000000000000001 *
      t2202_lanes;
  const Real t2211 = t2196 - t1324_lanes[7] * t2164 - t1642_lanes[0] * t2163 - t1642_lanes[1] *
      t2162 - t1642_lanes[2] * t2161;
  const Lanes<2> t2213_lanes = t2090_lanes - wd10_17_y_lanes;

  // link 1 (calf), force propagation; links 10 and 11, 17 and 18, 24, inertial wrench; link 13
  //   (left_hand), inward
  const Real t2214 = t2211 - t1642_lanes[3] * t2160;
  const Real f13_z = t2190_lanes[0] + t2214;
  const Lanes<2> t2219_lanes = 6e-04 * t2205_lanes - detail::make_pack<Real>(0.001, (-0.001)) *
      (t2207_lanes + t2192_lanes);
  const Real f12_x = f13_z - t2194_lanes[0];
  const Lanes<2> t2222_lanes = 0.0014999985000000002 * t2213_lanes + 0.28049749700000004 *
      t2006_lanes;

  // links 12 and 13, 19 and 20, inertial wrench; link 1 (calf), force propagation
  const Lanes<2> t2225_lanes = (t2020_lanes - t2015_lanes) * t11_lanes;
  const Lanes<2> t2233_lanes = t2181_lanes * t28_lanes - t2182_lanes * t26_lanes - t2197_lanes *
      t13_lanes + t2225_lanes;
  const Real t2235 = t2139 * t1255 - t1275_lanes[2] * t2214 - t1275_lanes[3] * t2179 -
      t1275_lanes[4] * t2170 - t1275_lanes[5] * t2168;
  const Lanes<2> t2238_lanes = t2015_lanes - t2055_lanes;
  const Lanes<2> t2239_lanes = t2233_lanes + t14_lanes * a12_19_x_lanes;
  const Lanes<2> t2240_lanes = 0.000195227662257343 * t2124_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * t2186_lanes +
      0.0025100003499999995 * a12_19_z_lanes;

  // links 13, 20, 24, inertial wrench; link 13 (left_hand), inward; links 11 (left_wrist1) and 18
  //   (right_wrist1), outward
  const Real n13_x = t2239_lanes[0] + t2179;
  const Lanes<2> t2247_lanes = t15_lanes * a12_19_z_lanes + t14_lanes * minus_a12_19_y_lanes;
  const Lanes<2> t2249_lanes = 0.0009386316083993107 * wd13_20_z_lanes - t2045_lanes *
      (t24_lanes - t28_lanes) + t2124_lanes * t13_lanes;
  const Real n12_y = n13_x - t2240_lanes[0];
  const Lanes<2> t2252_lanes = t2111_lanes - wd11_18_y_lanes;

  // links 11 to 13, 18 to 20, inertial wrench; link 1 (calf), force propagation
  const Lanes<2> t2256_lanes = 1.16e-05 * t2202_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * t2238_lanes +
      0.0006000000000000001 * a12_19_z_lanes;
  const Real t2259 = t2235 - t1275_lanes[6] * t2166 - t1275_lanes[7] * t2164 - t1619_lanes[0] *
      t2163 - t1619_lanes[1] * t2162;
  const Lanes<2> t2261_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (t2192_lanes - t2191_lanes);
  const Lanes<2> t2265_lanes = t2249_lanes - t2127_lanes * t11_lanes + t2238_lanes * t26_lanes +
      t2247_lanes;
  const Lanes<2> t2267_lanes = 0.0025100003499999995 * minus_a12_19_y_lanes;
  const Real t2268 = t2259 - t1619_lanes[2] * t2161 - t1619_lanes[3] * t2160;

  // link 24 (right_eye), inertial wrench; links 13 (left_hand) and 20 (right_hand), inward
  const Real n13_z = t2265_lanes[0] + t2168;
  tau[12] = n13_z;
  const Real f13_y = t2206_lanes[0] + t2268;
  const Lanes<2> t2276_lanes = t22_lanes * a12_19_x_lanes;
  const Real n12_x = t2256_lanes[0] + n13_z;

  // links 11 (left_wrist1) and 18 (right_wrist1), inertial wrench; links 13 (left_hand) and 20
  //   (right_hand), inward
  const Lanes<2> t2280_lanes = 0.0001194 * t2109_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      t2252_lanes + 0.000144 * t2205_lanes + t2261_lanes;
  const Real f12_z = t2209_lanes[0] + f13_y;
  const Lanes<2> t2283_lanes = 0.000206827662257343 * wd12_19_z_lanes - 0.000183627662257343 *
      t2116_lanes - detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) *
      t2120_lanes - t2267_lanes;
  const Lanes<2> t2285_lanes = t2280_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      minus_a10_17_y_lanes;
  const Lanes<2> t2287_lanes = 0.000144 * (t2207_lanes - t2192_lanes);

  // links 10 (left_lowerarm) and 17 (right_lowerarm), outward; link 12 (left_wrist2), inward;
  //   links 11 (left_wrist1) and 18 (right_wrist1), inertial wrench; link 1 (calf), force
  //   propagation
  const Lanes<2> t2291_lanes = wd10_17_z_lanes - t1977_lanes;
  const Lanes<2> t2292_lanes = minus_w10_17_y_lanes * minus_w10_17_y_lanes;
  const Real f11_y = t2219_lanes[0] + f12_z;
  const Lanes<2> t2300_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) * t2107_lanes -
      0.0001098 * t2252_lanes - detail::make_pack<Real>(6e-06, (-6e-06)) * t2109_lanes -
      t2287_lanes;
  const Real t2304 = t2137 * t1207 - t1221_lanes[1] * t2268 - t1221_lanes[2] * t2214 -
      t1221_lanes[3] * t2179 - t1221_lanes[4] * t2170;

  // links 12 and 13, 20, inward; links 10 and 11, 17 and 18, inertial wrench
  const Lanes<2> t2305_lanes = t2283_lanes + t2182_lanes * t24_lanes - t2172_lanes * t11_lanes -
      t2181_lanes * t26_lanes;
  const Lanes<2> t2307_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) * t2018_lanes;
  const Real n11_x = t2285_lanes[0] + (0.269 * f12_z - (s12 * n12_y - c12 * n12_x));
  const Lanes<2> t2310_lanes = t2300_lanes - 6e-04 * minus_a10_17_y_lanes;
  const Lanes<2> t2313_lanes = detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      (t1966_lanes - t2292_lanes);
  const Lanes<2> t2314_lanes = t2305_lanes + (t2055_lanes - t2020_lanes) * t13_lanes;
  const Lanes<2> t2319_lanes = 6e-04 * minus_a11_18_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_18_x_lanes;
  const Lanes<2> t2325_lanes = 0.06060754126741261 * t2006_lanes + 0.0001499998887063 *
      t2213_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      t2291_lanes + t2313_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), outward; links 11 (left_wrist1) and 18
  //   (right_wrist1), inertial wrench; link 13 (left_hand), inward
  const Lanes<2> t2326_lanes = t1956_lanes + minus_wd9_16_y_lanes;
  const Lanes<2> t2327_lanes = w9_16_y_lanes * w9_16_y_lanes;
  const Lanes<2> t2328_lanes = w9_16_z_lanes * w9_16_z_lanes;
  const Lanes<2> t2329_lanes = t1959_lanes + wd9_16_z_lanes;
  const Lanes<2> t2330_lanes = 0.00022920000000000001 * wd11_18_z_lanes - 9.6e-06 * t2093_lanes +
      0.000144 * t2057_lanes - t2307_lanes;
  const Real n12_z = t2314_lanes[0] + t2170 - t2276_lanes[0];
  tau[11] = n12_z;

  // links 10 and 11, 17 and 18, inertial wrench; link 1 (calf), force propagation
  const Lanes<2> t2331_lanes = 0.00028099984685315 * t2213_lanes +
      detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) * t1994_lanes +
      0.0001499998887063 * t2006_lanes;
  const Lanes<2> t2332_lanes = t2325_lanes - 0.28049749700000004 * minus_a10_17_z_lanes;
  const Real t2339 = t2304 - t1221_lanes[5] * t2168 - t1221_lanes[6] * t2166 - t1221_lanes[7] *
      t2164 - t1594_lanes[0] * t2163;
  const Lanes<2> t2342_lanes = detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      t2094_lanes;
  const Lanes<2> t2349_lanes = t2330_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      (t2191_lanes - t2207_lanes) - t2319_lanes;
  const Lanes<2> t2350_lanes = detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      (t1983_lanes - t1966_lanes) - t2331_lanes + 0.0014999985000000002 * minus_a10_17_z_lanes;
  const Lanes<2> t2354_lanes = 0.0014999985000000002 * minus_a10_17_y_lanes + 0.28049749700000004 *
      a10_17_x_lanes;

  // links 9 and 10, 16 and 17, inertial wrench; links 11 (left_wrist1) and 12 (left_wrist2),
  //   inward
  const Lanes<2> t2355_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * (t2328_lanes - t2327_lanes);
  const Real n11_z = t2349_lanes[0] - (s12 * n12_x + c12 * n12_y);
  tau[10] = n11_z;
  const Lanes<2> t2363_lanes = 0.06032654142055946 * t1977_lanes + 0.060888541114265754 *
      wd10_17_z_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      t1996_lanes - t2342_lanes;
  const Lanes<2> t2364_lanes = 0.0019585440854647937 * t1975_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * t2326_lanes -
      0.0005895000784280001 * t2329_lanes + t2355_lanes;
  const Real n10_y = t2350_lanes[0] - n11_z;

  // links 10 and 11, 17 and 18, 24, inertial wrench; links 9 (left_upperarm) and 16
  //   (right_upperarm), outward
  const Lanes<2> t2365_lanes = 6e-04 * t2252_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      t2109_lanes;
  const Lanes<2> t2366_lanes = 0.0014999985000000002 * (t2292_lanes + t1966_lanes) +
      0.28049749700000004 * t1994_lanes;
  const Real f13_x = t2339 - t1594_lanes[1] * t2162 - t1594_lanes[2] * t2161 - t1594_lanes[3] *
      t2160 - t2177_lanes[0];
  const Lanes<2> t2369_lanes = 0.0014999985000000002 * t2291_lanes - 0.28049749700000004 *
      t1999_lanes;
  const Lanes<2> t2371_lanes = w9_16_x_lanes * w9_16_x_lanes;

  // links 8 to 10, 15 to 17, inertial wrench; link 13 (left_hand), inward
  const Lanes<2> t2373_lanes = t2364_lanes - detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) * a8_15_x_lanes;
  const Real f12_y = t2185_lanes[0] + f13_x;
  const Lanes<2> t2377_lanes = t2363_lanes + 0.0001499998887063 * (t2292_lanes - t1983_lanes) -
      t2354_lanes;
  const Lanes<2> t2382_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * t1945_lanes;
  const Lanes<2> t2383_lanes = 0.0005895000784280001 * (t2371_lanes - t2328_lanes);

  // links 7 and 8, 14 and 15, outward; link 12 (left_wrist2), inward; links 9 (left_upperarm) and
  //   16 (right_upperarm), inertial wrench
  const Lanes<2> t2384_lanes = w8_15_x_lanes * w8_15_x_lanes;
  const Real t2386 = s12 * f12_y - c12 * f12_x;
  const Lanes<2> t2389_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * t1965_lanes - 0.0008177492704690715 * t2326_lanes -
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * t1975_lanes +
      t2383_lanes;
  const Lanes<2> t2391_lanes = t1907_lanes + wd7_14_x_lanes;
  const Real f11_x = t2203_lanes[0] - t2386;
  const Real f11_z = t2365_lanes[0] - (s12 * f12_x + c12 * f12_y);

  // links 7 (left_shoulder1) and 14 (right_shoulder1), outward; links 8 and 9, 15 and 16, inertial
  //   wrench
  const Lanes<2> t2394_lanes = w7_14_y_lanes * w7_14_y_lanes;
  const Lanes<2> t2395_lanes = t2389_lanes - 0.0022500062 * a8_15_x_lanes;
  const Lanes<2> t2396_lanes = w7_14_z_lanes * w7_14_z_lanes;
  const Lanes<2> t2400_lanes = 0.18101044219699997 * t1925_lanes + 0.18125194219699997 *
      wd8_15_z_lanes + 0.00010499999999999999 * t1946_lanes - t2382_lanes;
  const Lanes<2> t2401_lanes = 0.7139200499999999 * minus_a8_15_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_15_x_lanes;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), inertial wrench; links 11 (left_wrist1) and
  //   12 (left_wrist2), inward; links 8 (left_shoulder2) and 15 (right_shoulder2), outward
  const Lanes<2> t2402_lanes = 0.0017499999999999998 * minus_a7_14_z_lanes;
  const Real f10_y = t2369_lanes[0] - f11_z;
  const Lanes<2> t2404_lanes = t1925_lanes - wd8_15_z_lanes;
  const Lanes<2> t2406_lanes = t1934_lanes + wd8_15_x_lanes;
  const Real n11_y = t2310_lanes[0] + (n12_z + 0.269 * t2386);
  const Lanes<2> t2413_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (t2396_lanes - t2394_lanes);

  // links 8 and 9, 15 and 16, inertial wrench; link 11 (left_wrist1), inward
  const Lanes<2> t2416_lanes = 0.00010499999999999999 * (t2384_lanes - t1918_lanes);
  const Real f10_x = c11 * f11_x - s11 * f11_y - t2366_lanes[0];
  const Lanes<2> t2420_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * t1969_lanes;
  const Real f10_z = t2222_lanes[0] + (s11 * f11_x + c11 * f11_y);
  const Lanes<2> t2424_lanes = t2400_lanes + detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * (t1927_lanes - t2384_lanes) - t2401_lanes;
  const Lanes<2> t2428_lanes = 0.0022500062 * minus_a9_16_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_16_x_lanes;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), outward and inertial wrench; links 10
  //   (left_lowerarm) and 11 (left_wrist1), inward
  const Lanes<2> t2434_lanes = t1903_lanes - wd7_14_z_lanes;
  const Lanes<2> t2435_lanes = 0.0001505 * t2391_lanes + 8.75e-06 * t1928_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * t1915_lanes +
      t2413_lanes;
  const Real n10_x = t2332_lanes[0] + (c11 * n11_x - s11 * n11_y);
  const Real t2437 = s10 * f10_y - c10 * f10_x;
  const Real n10_z = t2377_lanes[0] + (s11 * n11_x + c11 * n11_y);

  // link 11 (left_wrist1), inward; links 7 and 8, 14 and 15, inertial wrench; links 7
  //   (left_shoulder1) and 14 (right_shoulder1), outward
  tau[9] = n10_z;
  const Lanes<2> t2440_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (t1918_lanes - t1927_lanes);
  const Lanes<2> t2441_lanes = w7_14_x_lanes * w7_14_x_lanes;
  const Lanes<2> t2442_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * t2404_lanes -
      0.18113119219699997 * t1951_lanes - detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * t2406_lanes + t2416_lanes;
  const Lanes<2> t2445_lanes = t2435_lanes + t2402_lanes;

  // links 7 to 9, 14 to 16, inertial wrench
  const Lanes<2> t2448_lanes = 0.0027762933559338653 * wd9_16_z_lanes - 0.0011407948149957223 *
      t1959_lanes + 0.0005895000784280001 * t1967_lanes + t2420_lanes;
  const Lanes<2> t2452_lanes = t2442_lanes - 0.7139200499999999 * a7_14_x_lanes;
  const Lanes<2> t2459_lanes = 0.00012075 * t2406_lanes +
      detail::make_pack<Real>(5.2499999999999995e-05, (-5.2499999999999995e-05)) * t1951_lanes -
      0.00010499999999999999 * t1944_lanes + t2440_lanes;
  const Lanes<2> t2462_lanes = 0.7139200499999999 * t1951_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * t2406_lanes;
  const Lanes<2> t2463_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (t2441_lanes - t2396_lanes);

  // links 8 and 9, 15 and 16, inertial wrench; link 10 (left_lowerarm), inward
  const Lanes<2> t2464_lanes = t2448_lanes + detail::make_pack<Real>((-4.4999986458742003e-05),
      4.4999986458742003e-05) * (t2327_lanes - t2371_lanes) + t2428_lanes;
  const Lanes<2> t2468_lanes = 0.0022500062 * (t2327_lanes + t2328_lanes) +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * t1965_lanes;
  const Real n9_y = t2395_lanes[0] + (n10_z + 0.282 * t2437);
  const Lanes<2> t2469_lanes = t2459_lanes + detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_14_x_lanes;
  const Lanes<2> t2472_lanes = 0.0022500062 * t2329_lanes +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * (t2371_lanes + t2328_lanes);
  const Real f9_x = t2468_lanes[0] - t2437;
  const Real n9_x = t2373_lanes[0] + (0.282 * f10_z - (s10 * n10_y - c10 * n10_x));

  // link 10 (left_lowerarm), inward; links 7, 9, 14, 16, inertial wrench
  const Real n9_z = t2464_lanes[0] - (s10 * n10_x + c10 * n10_y);
  tau[8] = n9_z;
  const Lanes<2> t2478_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * t2434_lanes - 0.0002975 * t1928_lanes - 8.75e-06 * t2391_lanes +
      t2463_lanes;
  const Real f9_y = f10_z - t2472_lanes[0];
  const Lanes<2> t2479_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      t1975_lanes - 0.0022500062 * t2326_lanes;

  // links 8, 15, 24, inertial wrench; link 10 (left_lowerarm), inward
  const Real f20_x = t2166 - t2177_lanes[1];
  const Lanes<2> t2480_lanes = 0.7139200499999999 * t1944_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (t2384_lanes + t1918_lanes);
  const Lanes<2> t2481_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * t2404_lanes - 0.7139200499999999 * t1943_lanes;
  const Real f20_z = t2190_lanes[1] + t2163;
  const Real f9_z = t2479_lanes[0] - (s10 * f10_x + c10 * f10_y);
  const Real f20_y = t2206_lanes[1] + t2164;

  // links 8 and 9, 15, 20, inward
  const Real f19_y = t2185_lanes[1] + f20_x;
  const Lanes<2> t2483_lanes = 0.0017499999999999998 * (t2394_lanes + t2396_lanes + t2434_lanes);
  const Real n8_x = t2469_lanes[0] - n9_z;
  const Real f19_x = f20_z - t2194_lanes[1];
  const Lanes<2> t2484_lanes = 0.0017499999999999998 * (t1915_lanes + (t2441_lanes + t2396_lanes));

  // links 7, 14, 24, inertial wrench; link 20 (right_hand), inward
  const Real n20_x = t2239_lanes[1] + t2162;
  const Lanes<2> t2485_lanes = t2478_lanes + t2402_lanes;
  const Real f19_z = t2209_lanes[1] + f20_y;
  const Real n20_z = t2265_lanes[1] + t2160;
  tau[19] = n20_z;

  // links 9, 19 and 20, inward
  const Real f8_x = t2481_lanes[0] - f9_z;
  const Real n19_y = n20_x - t2240_lanes[1];
  const Real n19_x = t2256_lanes[1] + n20_z;
  const Real f18_y = t2219_lanes[1] + f19_z;
  const Real f8_y = t2480_lanes[0] + (s9 * f9_x + c9 * f9_y);
  const Real n8_y = t2452_lanes[0] + (s9 * n9_x + c9 * n9_y);
  const Real n19_z = t2314_lanes[1] + t2161 - t2276_lanes[1];
  tau[18] = n19_z;
  const Real n8_z = t2424_lanes[0] + (c9 * n9_x - s9 * n9_y);
  tau[7] = n8_z;

  // links 8 (left_shoulder2) and 19 (right_wrist2), inward
  const Real t2486 = s19 * f19_y - c19 * f19_x;
  const Real f7_x = t2462_lanes[0] + c9 * f9_x - s9 * f9_y - t2483_lanes[0];
  const Real n7_x = t2445_lanes[0] + n8_z;
  const Real f18_x = t2203_lanes[1] - t2486;
  const Real n18_z = t2349_lanes[1] - (s19 * n19_x + c19 * n19_y);
  tau[17] = n18_z;
  const Real f7_y = c8 * f8_x - s8 * f8_y + t2484_lanes[0];
  const Real n7_y = t2485_lanes[0] + (c8 * n8_x - s8 * n8_y);
  const Real n18_x = t2285_lanes[1] + (0.269 * f19_z - (s19 * n19_y - c19 * n19_x));
  const Real n18_y = t2310_lanes[1] + (n19_z + 0.269 * t2486);
  const Real f18_z = t2365_lanes[1] - (s19 * f19_x + c19 * f19_y);

  // links 7 (left_shoulder1) and 18 (right_wrist1), inward
  const Real n17_y = t2350_lanes[1] - n18_z;
  const Real f17_x = c18 * f18_x - s18 * f18_y - t2366_lanes[1];
  const Real f17_y = t2369_lanes[1] - f18_z;
  const Real f17_z = t2222_lanes[1] + (s18 * f18_x + c18 * f18_y);
  const Real t2487 = c7 * f7_x - s7 * f7_y;

  // links 17 (right_lowerarm) and 18 (right_wrist1), inward
  const Real f16_y = f17_z - t2472_lanes[1];
  const Real n17_x = t2332_lanes[1] + (c18 * n18_x - s18 * n18_y);
  const Real t2488 = s17 * f17_y - c17 * f17_x;
  const Real n17_z = t2377_lanes[1] + (s18 * n18_x + c18 * n18_y);
  tau[16] = n17_z;
  const Real f16_x = t2468_lanes[1] - t2488;
  const Real f16_z = t2479_lanes[1] - (s17 * f17_x + c17 * f17_y);

  // link 21 (neck), outward; links 16 (right_upperarm) and 17 (right_lowerarm), inward
  const Real wd21_z = qdd_0[20] - wd6_x;
  const Real w21_x = s21 * w6_y + c21 * w6_z;
  const Real w21_z = qd[20] - w6_x;
  const Real n16_y = t2395_lanes[1] + (n17_z + 0.282 * t2488);
  const Real w21_y = c21 * w6_y - s21 * w6_z;
  const Real f15_x = t2481_lanes[1] - f16_z;
  const Real n16_z = t2464_lanes[1] - (s17 * n17_x + c17 * n17_y);
  tau[15] = n16_z;
  const Real n16_x = t2373_lanes[1] + (0.282 * f17_z - (s17 * n17_y - c17 * n17_x));
  const Real t2489 = s21 * t1906 - c21 * t1887;
  const Real t2490 = w21_x * w21_y;

  // links 21 (neck) and 22 (head), outward; link 16 (right_upperarm), inward
  const Real w22_z = w21_y + qd[21];
  const Real t2491 = w21_x * w21_z;
  const Real f15_y = t2480_lanes[1] + (s16 * f16_x + c16 * f16_y);
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;
  const Real n15_x = t2469_lanes[1] - n16_z;
  const Real t2492 = t2490 - wd21_z;

  // links 21 to 24, outward
  const Real t2493 = s21 * t1887 + c21 * t1906;
  const Real w22_x = c22 * w21_x - s22 * w21_z;
  const Lanes<2> w23_24_z_lanes = minus_w22_y + detail::make_pack<Real>(qd[22], qd[23]);
  const Real minus_wd21_y = t2493 + t2491;
  const Real t2495 = 2.0 * (w21_y * w21_z) - t2489;

  // links 15 (right_shoulder2) and 16 (right_upperarm), inward; link 22 (head), outward
  const Real n15_y = t2452_lanes[1] + (s16 * n16_x + c16 * n16_y);
  const Real f14_x = t2462_lanes[1] + c16 * f16_x - s16 * f16_y - t2483_lanes[1];
  const Real t2497 = w22_x * w22_z;
  const Real t2498 = w22_x * minus_w22_y;
  const Real wd22_z = qdd_0[21] - minus_wd21_y;

  // links 23 (left_eye) and 24 (right_eye), outward; link 16 (right_upperarm), inward
  const Lanes<2> t2501_lanes = 2.0 * w23_24_z_lanes;
  const Real n15_z = t2424_lanes[1] + (c16 * n16_x - s16 * n16_y);
  tau[14] = n15_z;
  const Lanes<2> w23_24_y_lanes = detail::make_pack<Real>(c23, c24) * w22_z -
      detail::make_pack<Real>(s23, s24) * w22_x;
  const Lanes<2> w23_24_x_lanes = detail::make_pack<Real>(c23, c24) * w22_x +
      detail::make_pack<Real>(s23, s24) * w22_z;

  // links 21 (neck) and 22 (head), outward
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;
  const Real t2502 = t2498 + wd22_z;
  const Real t2503 = wd22_z - t2498;
  const Real t2504 = c22 * t2492 - s22 * t2495;
  const Real t2505 = a6_x + link21_to_22_z * t1879;
  const Real t2506 = s22 * t2492 + c22 * t2495;

  // link 15 (right_shoulder2), inward; links 22 to 24, outward
  const Real f14_y = c15 * f15_x - s15 * f15_y + t2484_lanes[1];
  const Lanes<2> t2507_lanes = w23_24_x_lanes * w23_24_y_lanes;
  const Lanes<2> t2508_lanes = w23_24_z_lanes * w23_24_z_lanes;
  const Real t2511 = a21_x - link21_to_22_z * t2493;
  const Real wd22_y = t2504 - t2497;
  const Real t2514 = t2506 - 2.0 * (minus_w22_y * w22_z);
  const Real n14_x = t2445_lanes[1] + n15_z;
  const Real t2518 = t2497 - wd22_y;
  const Lanes<2> wd23_24_z_lanes = detail::make_pack<Real>(qdd_0[22], qdd_0[23]) - wd22_y;

  // links 21 (neck) and 22 (head), outward; link 15 (right_shoulder2), inward
  const Real t2521 = w21_x * w21_x;
  const Real t2522 = w21_z * w21_z;
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;
  const Real n14_y = t2485_lanes[1] + (c15 * n15_x - s15 * n15_y);
  const Real t2524 = minus_w22_y * minus_w22_y;
  const Real t2525 = w22_z * w22_z;
  const Real a22_y = c22 * t2505 - s22 * t2511;

  // links 21 to 24, outward
  const Lanes<2> t2527_lanes = t2507_lanes + wd23_24_z_lanes;
  const Real t2529 = t2521 + t2522;
  const Real a22_z = link21_to_22_z * t2489 - minus_a21_y;
  const Lanes<2> t2530_lanes = detail::make_pack<Real>(s23, s24) * t2502 +
      detail::make_pack<Real>(c23, c24) * t2514;
  const Real t2533 = t2524 + t2525;
  const Real a22_x = c22 * t2511 + s22 * t2505;
  const Real t2534 = a22_y + 0.095 * t2503;

  // links 23 (left_eye) and 24 (right_eye), outward and inertial wrench; link 14
  //   (right_shoulder1), inward
  const Lanes<2> t2535_lanes = t2501_lanes * w23_24_x_lanes -
      (detail::make_pack<Real>(c23, c24) * t2502 - detail::make_pack<Real>(s23, s24) * t2514);
  const Real t2537 = a22_z + 0.095 * t2518;
  const Lanes<2> f23_24_y_lanes = 0.00025 * t2527_lanes;
  const Lanes<2> minus_a23_24_z_lanes = t2534 - detail::make_pack<Real>(0.032, (-0.032)) * t2506;
  const Real t2547 = c14 * f14_x - s14 * f14_y;

  // links 23 (left_eye) and 24 (right_eye), inertial wrench; link 24 (right_eye), outward
  const Lanes<2> t2549_lanes = 0.00025 * minus_a23_24_z_lanes;
  const Real t2552 = a22_x - 0.095 * t2533;
  const Lanes<2> n23_24_x_lanes = 4e-06 * (t2530_lanes + t2501_lanes * w23_24_y_lanes) -
      2.8750000000000004e-05 * t2527_lanes;
  const Lanes<2> minus_f23_24_x_lanes = 0.00025 * (w23_24_y_lanes * w23_24_y_lanes + t2508_lanes);
  const Lanes<2> n23_24_y_lanes = 2.8750000000000004e-05 *
      (w23_24_x_lanes * w23_24_x_lanes - t2508_lanes) - 5.25e-06 * t2535_lanes + t2549_lanes;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), inertial wrench; links 23 (left_eye) and 24
  //   (right_eye), outward and inward
  const Lanes<2> t2561_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * t1919_lanes;
  const Lanes<2> t2562_lanes = detail::make_pack<Real>(s23, s24) *
      (t2552 + detail::make_pack<Real>(0.032, (-0.032)) * t2504);
  const Lanes<2> a23_24_y_lanes = detail::make_pack<Real>(c23, c24) *
      (t2537 - detail::make_pack<Real>(0.032, (-0.032)) * t2529) - t2562_lanes;
  const Lanes<2> t2569_lanes = detail::make_pack<Real>(c23, c24) * minus_f23_24_x_lanes +
      detail::make_pack<Real>(s23, s24) * f23_24_y_lanes;
  const Lanes<2> t2570_lanes = detail::make_pack<Real>(c23, c24) * f23_24_y_lanes -
      detail::make_pack<Real>(s23, s24) * minus_f23_24_x_lanes;

  // link 21 (neck), outward; links 8, 15, 23 and 24, inward; links 23 (left_eye) and 24
  //   (right_eye), inertial wrench
  const Real t2574 = t2490 + wd21_z;
  const Lanes<2> t2575_lanes = 0.0017499999999999998 * (a7_14_y_lanes + a7_14_x_lanes);
  const Lanes<2> t2576_lanes = 0.00025 * a23_24_y_lanes;
  const Real t2577 = t2570_lanes[1] + t2570_lanes[0];
  const Lanes<2> t2578_lanes = detail::make_pack<Real>(c23, c24) * n23_24_x_lanes -
      detail::make_pack<Real>(s23, s24) * n23_24_y_lanes +
      detail::make_pack<Real>(8.000000000000001e-06, (-8.000000000000001e-06)) * t2535_lanes;

  // link 22 (head), outward; links 7, 14, 23 and 24, inertial wrench
  const Real t2579 = w22_x * w22_x;
  const Lanes<2> t2580_lanes = 0.000147 * t1903_lanes + 0.000448 * wd7_14_z_lanes +
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * t1921_lanes -
      t2561_lanes;
  const Lanes<2> n23_24_z_lanes = 1.25e-06 * t2507_lanes + 9.25e-06 * wd23_24_z_lanes -
      2.8750000000000004e-05 * t2530_lanes + t2576_lanes;
  tau[22] = n23_24_z_lanes[0];
  tau[23] = n23_24_z_lanes[1];

  // links 23 (left_eye) and 24 (right_eye), inward; links 7 (left_shoulder1) and 14
  //   (right_shoulder1), inertial wrench
  const Lanes<2> t2581_lanes = detail::make_pack<Real>(s23, s24) * n23_24_x_lanes;
  const Real f22_z = h_22_x * t2518 - minus_h_22_y * t2514 + t2577;
  const Lanes<2> t2582_lanes = detail::make_pack<Real>(c23, c24) * n23_24_y_lanes;
  const Real t2583 = t2535_lanes[1] + t2535_lanes[0];
  const Lanes<2> t2584_lanes = t2580_lanes + 8.75e-06 * (t2394_lanes - t2441_lanes);
  const Real n22_x = J_22_xx * t2514 - J_22_xy * t2518 - minus_h_22_y * a22_z + t2578_lanes[1] +
      t2578_lanes[0];

  // links 7, 15, 23, inward; link 21 (neck), outward
  const Real t2585 = J_22_xy * t2514 - J_22_yy * t2518 - h_22_x * a22_z - n23_24_z_lanes[1] -
      (-0.032) * t2569_lanes[1];
  const Real t2586 = t2491 + minus_wd21_y;
  const Real t2587 = t2547 + t2487;
  const Real n14_z = t2584_lanes[1] + s15 * n15_x + c15 * n15_y + t2575_lanes[1];
  tau[13] = n14_z;

  // links 8 (left_shoulder2) and 23 (left_eye), inward
  const Real t2588 = 0.04506407500000001 * t2498 + J_22_zz * wd22_z - J_22_xy * (t2524 - t2579) +
      h_22_x * a22_y;
  const Real f22_y = h_22_x * t2503 + minus_h_22_y * (t2579 + t2525) - 0.00025 * t2583;
  const Real n7_z = t2584_lanes[0] + s8 * n8_x + c8 * n8_y + t2575_lanes[0];
  tau[6] = n7_z;
  const Real f22_x = minus_h_22_y * t2502 - h_22_x * t2533 - t2569_lanes[1] - t2569_lanes[0];
  const Real n22_y = t2585 - n23_24_z_lanes[0] - 0.032 * t2569_lanes[0] - 0.095 * t2577;

  // links 7 and 8, 14 and 15, 22, inward
  const Real t2589 = s22 * f22_y - c22 * f22_x;
  const Real t2590 = s14 * f14_x + c14 * f14_y;
  const Lanes<2> t2592_lanes = 0.0017499999999999998 * (t1928_lanes - t2391_lanes);
  const Real n21_x = J_21_xx * t2495 - minus_J_21_xz * t2574 -
      (s22 * n22_y - c22 * n22_x + link21_to_22_z * f22_z);
  const Real t2593 = s7 * f7_x + c7 * f7_y;

  // links 8, 22 and 23, inward
  const Real n21_z = J_21_zz * wd21_z - 0.0048105000000000005 * t2490 + minus_J_21_xz * t2489 -
      h_21_x * minus_a21_y - (s22 * n22_x + c22 * n22_y);
  tau[20] = n21_z;
  const Real n22_z = t2588 + minus_h_22_y * a22_x + t2581_lanes[1] + t2582_lanes[1] +
      t2581_lanes[0] + t2582_lanes[0] - 2.375e-05 * t2583;
  tau[21] = n22_z;
  const Real f7_z = s8 * f8_x + c8 * f8_y + t2592_lanes[0];

  // links 7, 14 and 15, 22, inward
  const Real f14_z = s15 * f15_x + c15 * f15_y + t2592_lanes[1];
  const Real t2594 = 1.26882463592404 * t1872 + J_6_zz * wd6_z - J_6_xz * t1897 + minus_h_6_x *
      minus_a6_y + c21 * n21_x;
  const Real f21_z = h_21_x * t2586 - (s22 * f22_x + c22 * f22_y);
  const Real t2595 = J_6_xx * t1905 + J_6_xz * t1887 - n21_z +
      (s14 * n14_x + c14 * n14_y + (-0.18) * t2547);
  const Real t2596 = f14_z + f7_z;

  // links 7 (left_shoulder1) and 22 (head), inward; link 4 (chest1), outward
  const Real f21_y = h_21_x * t2574 + f22_z;
  const Real t2597 = minus_h_6_x * a6_z - J_6_yy * t1906 - J_6_xz * (t1886 - t1868) + s21 * n21_x;
  const Real n21_y = minus_J_21_xz * (t2521 - t2522) - J_21_yy * t2586 + h_21_x * a6_x +
      (n22_z - link21_to_22_z * t2589);
  const Real n6_x = t2595 + (s7 * n7_x + c7 * n7_y + 0.18 * t2487);
  const Real t2598 = 2.0 * wd4_x;
  const Real t2599 = c4 * t743;
  const Real minus_f21_x = h_21_x * (w21_y * w21_y + t2522) + t2589;

  // link 7 (left_shoulder1), inward; link 5 (chest2), outward
  const Real f6_x = minus_h_6_x * t1879 - f21_z + t2590 + t2593;
  const Real t2600 = minus_w5_y * minus_w5_y;
  const Real f6_y = t2596 - minus_h_6_x * t1887 - s21 * minus_f21_x + c21 * f21_y;
  const Real f6_z = t2587 - minus_h_6_x * t1906 - c21 * minus_f21_x - s21 * f21_y;
  const Real t2601 = t2594 - s21 * n21_y + c14 * n14_x - s14 * n14_y - (-0.18) * t2590;
  const Real n6_y = t2597 + c21 * n21_y + n14_z + n7_z + 0.226 * t2587;

  // link 4 (chest1), outward; link 6 (chest3), inward
  const Real t2602 = qd[3] * qd[3];
  const Real t2603 = s6 * f6_x + c6 * f6_y;
  const Real f5_x = minus_h_5_y * t1883 - h_5_x * (t2600 + t1855) + f6_z;
  const Real f5_y = h_5_x * t1882 + minus_h_5_y * t1867 + (c6 * f6_x - s6 * f6_y);
  const Real f5_z = h_5_x * t1880 - minus_h_5_y * t1877 + t2603;
  const Real n5_y = J_5_xy * t1877 - J_5_yy * t1880 + h_5_x * minus_a5_z + (c6 * n6_x - s6 * n6_y);

  // link 5 (chest2), inertial wrench; links 6 (chest3) and 7 (left_shoulder1), inward
  const Real t2604 = 0.10961925816937634 * t1869 + J_5_zz * wd5_z - J_5_xy * (t2600 - t1860) +
      (h_5_x * a5_y + minus_h_5_y * a5_x);
  const Real n6_z = t2601 + c7 * n7_x - s7 * n7_y - 0.18 * t2593 - 0.226 * t2596;
  tau[5] = n6_z;
  const Real n5_z = t2604 + (s6 * n6_x + c6 * n6_y + minus_link5_to_6_y * f6_z);
  tau[4] = n5_z;
  const Real n5_x = J_5_xx * t1877 - J_5_xy * t1880 + minus_h_5_y * minus_a5_z +
      (n6_z - minus_link5_to_6_y * t2603);

  // links 4 (chest1) and 5 (chest2), inward
  const Real t2605 = h_2_x * c2 + minus_h_2_y * s2;
  const Real f3_y = minus_h_3_y * t1842 + t2598 * t735 + s5 * f5_x + c5 * f5_y - t754 * wd3_z;
  const Real t2606 = c4 * (s5 * f5_y - c5 * f5_x) + s4 * f5_z;
  const Real f4_x = (t1842 + t2602) * t751 + qdd_0[3] * t735 - t2606;
  const Real f3_x = minus_h_3_x * t1842 + minus_h_3_y * wd3_z + f4_x;
  const Real t2607 = minus_h_3_y * a3_x + qdd_0[3] * t732 + t2598 * t2599 - s4 *
      (s5 * n5_y - c5 * n5_x);
  const Real n4_z = J_4_zz * qdd_0[3] + wd3_z * t732 - t1842 * t2599 + t735 * a3_x -
      (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

  // links 2 to 4, inward
  const Real t2608 = c2_plus_3 * f3_x - s2_plus_3 * f3_y;
  const Real f2_x = t2608 - (t1835 * t2605 + wd2_z * t768);
  const Real t2609 = t2607 - link4_to_5_z * t2606 + (J_4_xz * t2602 + n5_z) * c4 - t754 * a3_y;
  const Real n3_z = t2609 + (1.7947593951550056 + t745) * wd3_z;
  tau[2] = n3_z;
  const Real n2_z = J_2_zz * wd2_z + (t2605 * a2_y - t768 * a2_x) +
      (n3_z + (t760 * (s2_plus_3 * f3_x + c2_plus_3 * f3_y) + t759 * t2608));
  tau[1] = n2_z;
  const Real n1_z = J_1_zz * qdd_0[0] + (0.1569597827085 * c1 - 299.6743959432 * s1) +
      (n2_z + minus_link1_to_2_y * f2_x);
  tau[0] = n1_z;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
