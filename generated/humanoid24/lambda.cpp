// SPDX-License-Identifier: 0BSD
// lambda: Lambda = (J M^-1 J^T)^-1
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in
//   lanes.
// 8039 flops (add 3448, mul 4547, div 44), sine and cosine of 24 angles
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
void lambda(const Real (&TREELINE_RESTRICT q)[24], Real (&TREELINE_RESTRICT Lambda)[144]) noexcept {
  // constants
  const Real h_22_x = 0.072575;
  const Real J_22_yy = 0.009438624999999999;
  const Real J_22_xx = 0.05450270000000001;
  const Real J_22_xy = 0.0074;
  const Real minus_h_22_y = 0.43200000000000005;
  const Real J_21_zz = 0.006216750000000001;
  const Real link21_to_22_z = 0.394;
  const Real minus_J_21_xz = 0.0016155;
  const Real J_21_xx = 0.005513625;
  const Real J_21_yy = 0.000703125;
  const Real J_6_zz = 2.06965463592404;
  const Real h_21_x = 0.0045000000000000005;
  const Real J_6_xz = 0.0187369177636143;
  const Real minus_h_6_x = 6.1665928899999995;
  const Real J_6_yy = 1.66923963592404;
  const Real minus_link5_to_6_y = 0.072;
  const Real J_5_zz = 0.203126912024134;
  const Real minus_h_5_y = 2.2194301519999997;
  const Real h_5_x = 0.069699984375;
  const Real J_5_xx = 0.15637308509675518;
  const Real J_5_yy = 0.04675382692737882;
  const Real J_5_xy = 0.005678398088837119;
  const Real link4_to_5_z = 0.21799999999999997;
  const Real J_4_xz = 0.005880002159562879;
  const Real minus_h_4_x = 0.0300000063;
  const Real J_4_zz = 0.060169103246295166;
  const Real minus_h_3_y = 8.419374554;
  const Real minus_h_3_x = 0.02999999505;
  const Real minus_link2_to_3_y = 0.422;
  const Real J_2_zz = 9.885744550888212;
  const Real h_2_x = 0.031999971599999996;
  const Real minus_h_2_y = 24.5839218;
  const Real minus_link1_to_2_y = 0.434;
  const Real J_1_zz = 13.049859506913753;

  // sines and cosines
  const Real angles[24] = {q[12], q[10], q[8], q[7], q[6], q[5], q[4], q[3], q[1], q[2], q[0], q[9],
      q[11], q[21], q[23], q[22], q[20], q[16], q[19], q[18], q[17], q[15], q[14], q[13]};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real c13 = cosines[0];
  const Real c11 = cosines[1];
  const Real c9 = cosines[2];
  const Real s8 = sines[3];
  const Real c7 = cosines[4];
  const Real c6 = cosines[5];
  const Real s5 = sines[6];
  const Real c4 = cosines[7];
  const Real c2 = cosines[8];
  const Real c3 = cosines[9];
  const Real s2 = sines[8];
  const Real s3 = sines[9];
  const Real c1 = cosines[10];
  const Real s1 = sines[10];
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
  const Real s22 = sines[13];
  const Real c22 = cosines[13];
  const Real c24 = cosines[14];
  const Real c23 = cosines[15];
  const Real s24 = sines[14];
  const Real s23 = sines[15];
  const Real c21 = cosines[16];
  const Real s21 = sines[16];
  const Real s17 = sines[17];
  const Real c20 = cosines[18];
  const Real s20 = sines[18];
  const Real s19 = sines[19];
  const Real c19 = cosines[19];
  const Real s18 = sines[20];
  const Real c18 = cosines[20];
  const Real c17 = cosines[17];
  const Real c16 = cosines[21];
  const Real s16 = sines[21];
  const Real s15 = sines[22];
  const Real c15 = cosines[22];
  const Real c14 = cosines[23];
  const Real s14 = sines[23];

  // links 11 (left_wrist1) and 18 (right_wrist1), articulated inertia
  const Lanes<2> t13_lanes = 2.0 * detail::make_pack<Real>(c11, c18);
  const Lanes<2> t14_lanes = 0.000108260010923775 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> t15_lanes = 0.0007556474228594393 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-0.000252780114665025), 0.000252780114665025) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> t16_lanes = 0.000108260010923775 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-4.38600177048965e-05), 4.38600177048965e-05) *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> t17_lanes = 0.01626499875 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> t18_lanes = 0.01626499875 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-0.002865001425), 0.002865001425) *
      detail::make_pack<Real>(s13, s20);

  // links 13 (left_hand) and 20 (right_hand), articulated inertia
  const Lanes<2> t19_lanes = 1065.380700001509 * t14_lanes;
  const Lanes<2> t20_lanes = detail::make_pack<Real>(s13, s20) * t15_lanes;
  const Lanes<2> t22_lanes = 1065.380700001509 * t16_lanes;
  const Lanes<2> t23_lanes = 1065.380700001509 * t17_lanes;
  const Lanes<2> t24_lanes = 1065.380700001509 * t18_lanes;
  const Lanes<2> t25_lanes = 0.0006000000000000001 + t18_lanes;
  const Lanes<2> t34_lanes = t14_lanes * t24_lanes;

  // links 10, 12 and 13, 17, 19 and 20, articulated inertia
  const Lanes<2> t39_lanes = 2.0 * detail::make_pack<Real>(c10, c17);
  const Lanes<2> t43_lanes = 0.0025100003499999995 - t14_lanes * t23_lanes;
  const Lanes<2> inverse_D12_19_lanes = 1.0 / (0.001053967177886718 - t20_lanes - t14_lanes *
      t19_lanes);
  const Lanes<2> t45_lanes = detail::make_pack<Real>((-2.4000000000000003e-06),
      2.4000000000000003e-06) - (detail::make_pack<Real>(c13, c20) * t15_lanes -
      detail::make_pack<Real>((-0.0001263900573325125), 0.0001263900573325125) + t16_lanes *
      t19_lanes);
  const Lanes<2> t46_lanes = t45_lanes * inverse_D12_19_lanes;

  // links 12 (left_wrist2) and 19 (right_wrist2), articulated inertia
  const Lanes<2> t47_lanes = t43_lanes * inverse_D12_19_lanes;
  const Lanes<2> t48_lanes = t25_lanes * inverse_D12_19_lanes;
  const Lanes<2> t49_lanes = t34_lanes * inverse_D12_19_lanes;
  const Lanes<2> t55_lanes = t25_lanes * t47_lanes;
  const Lanes<2> t56_lanes = t25_lanes * t48_lanes;
  const Lanes<2> t59_lanes = t25_lanes * t49_lanes;
  const Lanes<2> t60_lanes = 0.00028671975502727877 + t20_lanes - t16_lanes * t22_lanes -
      t45_lanes * t46_lanes;
  const Lanes<2> t61_lanes = t16_lanes * t23_lanes + t45_lanes * t47_lanes;
  const Lanes<2> t62_lanes = t17_lanes + t45_lanes * t48_lanes;
  const Lanes<2> t63_lanes = t16_lanes * t24_lanes - 0.0025100003499999995 - t45_lanes * t49_lanes;
  const Lanes<2> t64_lanes = t17_lanes * t23_lanes + t43_lanes * t47_lanes;
  const Lanes<2> t66_lanes = t17_lanes * t24_lanes - t43_lanes * t49_lanes;
  const Lanes<2> t67_lanes = t18_lanes * t24_lanes + t34_lanes * t49_lanes;
  const Lanes<2> t78_lanes = detail::make_pack<Real>(s12, s19) * (1.16e-05 - t60_lanes);
  const Lanes<2> t79_lanes = detail::make_pack<Real>(s12, s19) * t61_lanes +
      detail::make_pack<Real>(c12, c19) * t62_lanes;
  const Lanes<2> t80_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * t63_lanes;
  const Lanes<2> t82_lanes = detail::make_pack<Real>(s12, s19) * t63_lanes - 0.0006000000000000001 *
      detail::make_pack<Real>(c12, c19);
  const Lanes<2> t83_lanes = detail::make_pack<Real>(s12, s19) * t66_lanes -
      detail::make_pack<Real>(c12, c19) * t59_lanes;
  const Lanes<2> t84_lanes = detail::make_pack<Real>(s12, s19) * t78_lanes;
  const Lanes<2> t85_lanes = detail::make_pack<Real>(c12, c19) * t79_lanes;
  const Lanes<2> t88_lanes = detail::make_pack<Real>(s12, s19) * (t64_lanes - t56_lanes) +
      detail::make_pack<Real>(c12, c19) * (2.0 * t55_lanes);
  const Lanes<2> t89_lanes = t82_lanes + 0.269 * t67_lanes;
  const Lanes<2> t90_lanes = detail::make_pack<Real>(s12, s19) * t79_lanes;
  const Lanes<2> t91_lanes = 0.269 * t83_lanes;
  const Lanes<2> t92_lanes = 6e-04 - t80_lanes;
  const Lanes<2> t98_lanes = detail::make_pack<Real>(s12, s19) * t88_lanes;
  const Lanes<2> t100_lanes = t90_lanes + t91_lanes;
  const Lanes<2> t102_lanes = detail::make_pack<Real>(0.001, (-0.001)) + t85_lanes;
  const Lanes<2> t104_lanes = detail::make_pack<Real>(s12, s19) * t59_lanes +
      detail::make_pack<Real>(c12, c19) * t66_lanes;
  const Lanes<2> t105_lanes = t90_lanes - t61_lanes;
  const Lanes<2> t108_lanes = 0.000144 - (detail::make_pack<Real>(c12, c19) * t78_lanes + 0.269 *
      t80_lanes);
  const Lanes<2> t109_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 * t85_lanes;
  const Lanes<2> t110_lanes = t56_lanes + t98_lanes;

  // links 11 and 12, 18 and 19, articulated inertia
  const Lanes<2> inverse_D11_18_lanes = 1.0 / (0.00022920000000000001 + (t60_lanes + t84_lanes));
  const Lanes<2> t114_lanes = detail::make_pack<Real>(c12, c19) * t88_lanes - t55_lanes;
  const Lanes<2> t124_lanes = t108_lanes * inverse_D11_18_lanes;
  const Lanes<2> t125_lanes = t109_lanes * inverse_D11_18_lanes;
  const Lanes<2> t126_lanes = t102_lanes * inverse_D11_18_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), articulated inertia
  const Lanes<2> t127_lanes = t92_lanes * inverse_D11_18_lanes;
  const Lanes<2> t128_lanes = t105_lanes * inverse_D11_18_lanes;
  const Lanes<2> t145_lanes = 0.000131 - t84_lanes - 0.269 * (t82_lanes + t89_lanes) - t108_lanes *
      t124_lanes;
  const Lanes<2> t146_lanes = 0.0001098 - 0.07236100000000001 * t110_lanes - t109_lanes *
      t125_lanes;
  const Lanes<2> t147_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 * t100_lanes -
      t108_lanes * t125_lanes;
  const Lanes<2> t148_lanes = t108_lanes * t126_lanes - t100_lanes;
  const Lanes<2> t149_lanes = t91_lanes - t109_lanes * t127_lanes;
  const Lanes<2> t150_lanes = 0.269 * t110_lanes + t109_lanes * t126_lanes;
  const Lanes<2> t151_lanes = t89_lanes + t108_lanes * t127_lanes;
  const Lanes<2> t152_lanes = detail::make_pack<Real>(0.001, (-0.001)) -
      (t85_lanes - t62_lanes + 0.269 * t104_lanes) - t108_lanes * t128_lanes;
  const Lanes<2> t153_lanes = 0.269 * t114_lanes - 6e-04 - t109_lanes * t128_lanes;
  const Lanes<2> t154_lanes = t110_lanes + t102_lanes * t126_lanes;
  const Lanes<2> t155_lanes = t67_lanes + t92_lanes * t127_lanes;
  const Lanes<2> t156_lanes = t102_lanes * t127_lanes - t83_lanes;
  const Lanes<2> t159_lanes = t102_lanes * t128_lanes - t114_lanes;
  const Lanes<2> t160_lanes = t104_lanes + t92_lanes * t128_lanes;

  // links 9, 11, 16, 18, articulated inertia
  const Lanes<2> t178_lanes = 2.0 * detail::make_pack<Real>(s9, s16);
  const Lanes<2> t181_lanes = detail::make_pack<Real>(s11, s18) * (t145_lanes - t146_lanes) +
      t13_lanes * t147_lanes;
  const Lanes<2> t183_lanes = detail::make_pack<Real>(s11, s18) * (t148_lanes - t149_lanes) +
      detail::make_pack<Real>(c11, c18) * (t150_lanes - t151_lanes);
  const Lanes<2> t185_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * t152_lanes + detail::make_pack<Real>(c11, c18) *
      t153_lanes);
  const Lanes<2> t186_lanes = detail::make_pack<Real>(s11, s18) * (t155_lanes - t154_lanes) +
      t13_lanes * t156_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), articulated inertia
  const Lanes<2> t187_lanes = detail::make_pack<Real>(s11, s18) * t181_lanes;
  const Lanes<2> t189_lanes = detail::make_pack<Real>(c11, c18) * t183_lanes;
  const Lanes<2> t190_lanes = detail::make_pack<Real>(s11, s18) * t183_lanes;
  const Lanes<2> t191_lanes = detail::make_pack<Real>(s11, s18) * t186_lanes;
  const Lanes<2> t197_lanes = t149_lanes + t190_lanes;
  const Lanes<2> t203_lanes = 0.060888541114265754 + (t146_lanes + t187_lanes);
  const Lanes<2> t204_lanes = detail::make_pack<Real>((-2.249994685315e-05), 2.249994685315e-05) +
      (detail::make_pack<Real>(c11, c18) * t181_lanes - t147_lanes);
  const Lanes<2> t206_lanes = t189_lanes + t151_lanes - 0.28049749700000004;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_17_lanes = 1.0 / t203_lanes;
  const Lanes<2> t208_lanes = detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) /
      t203_lanes;
  const Lanes<2> t210_lanes = t204_lanes * inverse_D10_17_lanes;
  const Lanes<2> t212_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / t203_lanes;
  const Lanes<2> t213_lanes = t206_lanes * inverse_D10_17_lanes;
  const Lanes<2> t214_lanes = t185_lanes * inverse_D10_17_lanes;
  const Lanes<2> t215_lanes = t197_lanes * inverse_D10_17_lanes;
  const Lanes<2> t217_lanes = 0.0001499998887063 + t204_lanes * t208_lanes;
  const Lanes<2> t219_lanes = detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) *
      t213_lanes;
  const Lanes<2> t221_lanes = detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) *
      t214_lanes;
  const Lanes<2> t231_lanes = 0.06060754126741261 + (t145_lanes - t187_lanes) - t204_lanes *
      t210_lanes;
  const Lanes<2> t232_lanes = t148_lanes - t190_lanes - t204_lanes * t213_lanes;
  const Lanes<2> t233_lanes = detail::make_pack<Real>(c11, c18) * t152_lanes -
      detail::make_pack<Real>(s11, s18) * t153_lanes + t204_lanes * t214_lanes;
  const Lanes<2> t234_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * t215_lanes;
  const Lanes<2> t235_lanes = 0.28049749700000004 + (t189_lanes - t150_lanes) - t204_lanes *
      t215_lanes;
  const Lanes<2> t236_lanes = t154_lanes + t191_lanes + t206_lanes * t213_lanes;
  const Lanes<2> t237_lanes = t98_lanes - t64_lanes - t105_lanes * t128_lanes - t185_lanes *
      t214_lanes;
  const Lanes<2> t238_lanes = detail::make_pack<Real>(c11, c18) * t159_lanes +
      detail::make_pack<Real>(s11, s18) * t160_lanes + t206_lanes * t214_lanes;
  const Lanes<2> t239_lanes = t191_lanes - t155_lanes - t197_lanes * t215_lanes;
  const Lanes<2> t242_lanes = detail::make_pack<Real>(c11, c18) * t186_lanes - t156_lanes -
      t206_lanes * t215_lanes;
  const Lanes<2> t243_lanes = detail::make_pack<Real>(s11, s18) * t159_lanes -
      detail::make_pack<Real>(c11, c18) * t160_lanes + t185_lanes * t215_lanes;

  // links 8, 10, 15, 17, articulated inertia
  const Lanes<2> t259_lanes = 2.0 * detail::make_pack<Real>(c8, c15);
  const Lanes<2> t260_lanes = detail::make_pack<Real>(c10, c17) * t234_lanes -
      detail::make_pack<Real>(s10, s17) * t235_lanes;
  const Lanes<2> t262_lanes = detail::make_pack<Real>(c10, c17) * t235_lanes +
      detail::make_pack<Real>(s10, s17) * t234_lanes;
  const Lanes<2> t263_lanes = t39_lanes * t217_lanes - detail::make_pack<Real>(s10, s17) *
      (t231_lanes - t212_lanes);
  const Lanes<2> t264_lanes = detail::make_pack<Real>(c10, c17) * t242_lanes +
      detail::make_pack<Real>(s10, s17) * t243_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), articulated inertia
  const Lanes<2> t265_lanes = detail::make_pack<Real>(c10, c17) * (t219_lanes + t233_lanes) -
      detail::make_pack<Real>(s10, s17) * (t232_lanes + t221_lanes);
  const Lanes<2> t267_lanes = t260_lanes - 0.0022500062;
  const Lanes<2> t268_lanes = detail::make_pack<Real>(c10, c17) * t243_lanes -
      detail::make_pack<Real>(s10, s17) * t242_lanes;
  const Lanes<2> t269_lanes = detail::make_pack<Real>(s10, s17) * (t236_lanes + t237_lanes) +
      t39_lanes * t238_lanes;
  const Lanes<2> t270_lanes = t262_lanes + 0.282 * t239_lanes;
  const Lanes<2> t271_lanes = detail::make_pack<Real>(s10, s17) * t263_lanes;
  const Lanes<2> t273_lanes = 0.282 * t264_lanes;
  const Lanes<2> t274_lanes = detail::make_pack<Real>(c10, c17) * t265_lanes;
  const Lanes<2> t275_lanes = detail::make_pack<Real>(s10, s17) * t265_lanes;
  const Lanes<2> t277_lanes = detail::make_pack<Real>(s10, s17) * t269_lanes;
  const Lanes<2> t283_lanes = t233_lanes - t274_lanes;
  const Lanes<2> t286_lanes = t221_lanes + t275_lanes;
  const Lanes<2> t287_lanes = t277_lanes - t236_lanes;
  const Lanes<2> t288_lanes = t238_lanes - detail::make_pack<Real>(c10, c17) * t269_lanes;
  const Lanes<2> t293_lanes = t232_lanes + t275_lanes + t273_lanes;
  const Lanes<2> t294_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      t283_lanes;

  // links 9 and 10, 16 and 17, articulated inertia
  const Lanes<2> inverse_D9_16_lanes = 1.0 / (0.0027762933559338653 + (t212_lanes - t271_lanes));
  const Lanes<2> t299_lanes = 0.282 * t260_lanes - (t217_lanes - detail::make_pack<Real>(c10, c17) *
      t263_lanes) - 0.0005895000784280001;
  const Lanes<2> t302_lanes = detail::make_pack<Real>(0.0012089992423205001,
      (-0.0012089992423205001)) + 0.282 * t283_lanes;
  const Lanes<2> t308_lanes = t299_lanes * inverse_D9_16_lanes;
  const Lanes<2> t309_lanes = t302_lanes * inverse_D9_16_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), articulated inertia
  const Lanes<2> t310_lanes = t294_lanes * inverse_D9_16_lanes;
  const Lanes<2> t311_lanes = t267_lanes * inverse_D9_16_lanes;
  const Lanes<2> t312_lanes = t286_lanes * inverse_D9_16_lanes;
  const Lanes<2> t313_lanes = t299_lanes * t308_lanes;
  const Lanes<2> t328_lanes = 0.0019585440854647937 +
      (t231_lanes + t271_lanes + 0.282 * (t262_lanes + t270_lanes)) - t313_lanes;
  const Lanes<2> t329_lanes = 0.0008177492704690715 + 0.07952399999999998 * t287_lanes -
      t302_lanes * t309_lanes;
  const Lanes<2> t330_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - 0.282 * t293_lanes - t299_lanes * t309_lanes;
  const Lanes<2> t331_lanes = t293_lanes + t299_lanes * t310_lanes;
  const Lanes<2> t332_lanes = t273_lanes + t302_lanes * t311_lanes;
  const Lanes<2> t333_lanes = t270_lanes - t299_lanes * t311_lanes;
  const Lanes<2> t334_lanes = t302_lanes * t310_lanes - 0.282 * t287_lanes;
  const Lanes<2> t335_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      (0.282 * t268_lanes - (t219_lanes - t274_lanes)) + t299_lanes * t312_lanes;
  const Lanes<2> t336_lanes = 0.0022500062 + 0.282 * t288_lanes + t302_lanes * t312_lanes;
  const Lanes<2> t337_lanes = t287_lanes - t294_lanes * t310_lanes;
  const Lanes<2> t338_lanes = t239_lanes - t267_lanes * t311_lanes;
  const Lanes<2> t339_lanes = t264_lanes + t294_lanes * t311_lanes;
  const Lanes<2> t343_lanes = t288_lanes + t294_lanes * t312_lanes;

  // links 7, 9, 14, 16, articulated inertia
  const Lanes<2> t358_lanes = t268_lanes + t267_lanes * t312_lanes;
  const Lanes<2> t359_lanes = 2.0 * detail::make_pack<Real>(s7, s14);
  const Lanes<2> t363_lanes = detail::make_pack<Real>(c9, c16) * (t328_lanes - t329_lanes) -
      t178_lanes * t330_lanes;
  const Lanes<2> t366_lanes = detail::make_pack<Real>(c9, c16) * (t331_lanes + t332_lanes) -
      detail::make_pack<Real>(s9, s16) * (t334_lanes + t333_lanes);
  const Lanes<2> t367_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * t335_lanes -
      detail::make_pack<Real>(s9, s16) * t336_lanes);

  // links 9 (left_upperarm) and 16 (right_upperarm), articulated inertia
  const Lanes<2> t368_lanes = detail::make_pack<Real>(c9, c16) * (t337_lanes - t338_lanes) -
      t178_lanes * t339_lanes;
  const Lanes<2> t369_lanes = detail::make_pack<Real>(c9, c16) * t363_lanes;
  const Lanes<2> t371_lanes = detail::make_pack<Real>(s9, s16) * t366_lanes;
  const Lanes<2> t372_lanes = detail::make_pack<Real>(c9, c16) * t366_lanes;
  const Lanes<2> t375_lanes = detail::make_pack<Real>(c9, c16) * t368_lanes;

  // links 9, 16, 23 and 24, articulated inertia
  const Lanes<2> t379_lanes = 0.0007770270270270272 * detail::make_pack<Real>(c23, c24);
  const Lanes<2> t383_lanes = t372_lanes - t332_lanes;
  const Lanes<2> t384_lanes = 9.060810810810813e-05 * detail::make_pack<Real>(s23, s24);
  const Real t388 = c24 + c23;
  const Lanes<2> t389_lanes = 0.18125194219699997 + (t329_lanes + t369_lanes);
  const Lanes<2> t390_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * t363_lanes + t330_lanes);
  const Lanes<2> t393_lanes = detail::make_pack<Real>(c23, c24) * t379_lanes;
  const Lanes<2> t394_lanes = 0.7139200499999999 + (t371_lanes + t333_lanes);

  // links 8, 15, 23 and 24, articulated inertia
  const Real t395 = s24 + s23;
  const Lanes<2> t396_lanes = detail::make_pack<Real>(s23, s24) * t384_lanes;
  const Lanes<2> inverse_D8_15_lanes = 1.0 / t389_lanes;
  const Lanes<2> t399_lanes = detail::make_pack<Real>(s23, s24) * t379_lanes;
  const Lanes<2> t401_lanes = t393_lanes - 0.0007770270270270272;

  // links 22 to 24, articulated inertia
  const Lanes<2> t402_lanes = (detail::make_pack<Real>(8.000000000000001e-06,
      (-8.000000000000001e-06)) + t384_lanes) * detail::make_pack<Real>(c23, c24);
  const Real t403 = t396_lanes[1] + t396_lanes[0];
  const Real t404 = t399_lanes[1] + t399_lanes[0];
  const Lanes<2> t405_lanes = detail::make_pack<Real>(0.032, (-0.032)) * t401_lanes;
  const Real t406 = 0.431222972972973 + t393_lanes[1] + t401_lanes[0];
  const Lanes<2> t407_lanes = 0.006756756756756758 * detail::make_pack<Real>(s23, s24);
  const Real t408 = h_22_x + 0.00025 * t388;
  const Real t409 = t402_lanes[0] + 2.375e-05 * t395 + t402_lanes[1];
  const Lanes<2> t410_lanes = detail::make_pack<Real>(c23, c24) * t407_lanes;
  const Lanes<2> t411_lanes = detail::make_pack<Real>(s23, s24) * t407_lanes;
  const Real inverse_D22 = 1.0 / (0.063951825 - t403 + 4.75e-05 * t388);
  const Real t412 = t405_lanes[1] + t405_lanes[0] - 0.095 * t404;

  // links 8, 15, 23 and 24, articulated inertia
  const Lanes<2> t413_lanes = t390_lanes * inverse_D8_15_lanes;
  const Lanes<2> t414_lanes = 0.00012075 - 1.1024999999999998e-08 / t389_lanes;
  const Lanes<2> t415_lanes = t367_lanes * inverse_D8_15_lanes;
  const Lanes<2> t416_lanes = t394_lanes * inverse_D8_15_lanes;
  const Lanes<2> t419_lanes = t383_lanes * inverse_D8_15_lanes;
  const Lanes<2> t424_lanes = 0.095 * t410_lanes + detail::make_pack<Real>(0.032, (-0.032)) *
      t411_lanes;
  const Lanes<2> t425_lanes = t411_lanes - 0.006756756756756758;

  // links 8 (left_shoulder2) and 15 (right_shoulder2), articulated inertia
  const Lanes<2> t426_lanes = 0.00010499999999999999 * t416_lanes;
  const Lanes<2> t428_lanes = 0.00010499999999999999 * t415_lanes;
  const Lanes<2> t434_lanes = 0.18113119219699997 + (t328_lanes - t369_lanes) - t390_lanes *
      t413_lanes;
  const Lanes<2> t435_lanes = detail::make_pack<Real>((-5.2499999999999995e-05),
      5.2499999999999995e-05) + 0.00010499999999999999 * t413_lanes;
  const Lanes<2> t436_lanes = t390_lanes * t415_lanes -
      (detail::make_pack<Real>(s9, s16) * t335_lanes + detail::make_pack<Real>(c9, c16) *
      t336_lanes);
  const Lanes<2> t437_lanes = t331_lanes - t372_lanes - t390_lanes * t416_lanes;

  // links 8, 15, 22 to 24, articulated inertia
  const Lanes<2> t438_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * t419_lanes;
  const Real t440 = t393_lanes[1] + t393_lanes[0];
  const Lanes<2> t441_lanes = t371_lanes + t334_lanes - 0.7139200499999999 - t390_lanes *
      t419_lanes;
  const Real t442 = t412 * inverse_D22;
  const Lanes<2> t443_lanes = 0.095 * t425_lanes - detail::make_pack<Real>(0.032, (-0.032)) *
      t410_lanes;

  // link 22 (head), articulated inertia
  const Real t445 = 2.0 * c22;
  const Real t446 = t406 * inverse_D22;
  const Real t447 = t408 * inverse_D22;
  const Real t449 = t443_lanes[1] + t443_lanes[0];
  const Real t452 = t404 * inverse_D22;
  const Real t454 = J_22_xx + t403 + (-1.6000000000000003e-05) * s24 + 1.6000000000000003e-05 *
      s23 - t409 * t409 * inverse_D22;

  // links 8, 15, 22, articulated inertia
  const Lanes<2> t455_lanes = detail::make_pack<Real>(s8, s15) * (t414_lanes - t434_lanes) +
      t259_lanes * t435_lanes;
  const Real t458 = t412 * t447;
  const Lanes<2> t459_lanes = t337_lanes - t375_lanes - t394_lanes * t416_lanes;
  const Lanes<2> t460_lanes = t237_lanes - t277_lanes - t286_lanes * t312_lanes - t367_lanes *
      t415_lanes;
  const Real t461 = t454 - 0.00017071621621621627;
  const Lanes<2> t462_lanes = detail::make_pack<Real>(s8, s15) * t455_lanes;
  const Real t463 = t409 * t446 - t404;
  const Real t464 = t424_lanes[1] + t424_lanes[0] + t412 * t446;
  const Lanes<2> t465_lanes = detail::make_pack<Real>(c8, c15) * (t436_lanes + t426_lanes) -
      detail::make_pack<Real>(s8, s15) * (t428_lanes + t437_lanes);
  const Real t467 = J_22_yy - (-0.032) * t424_lanes[1] - 0.032 * t424_lanes[0] - t412 * t442 +
      0.095 * t449;
  const Real t468 = J_22_xy - (-0.032) * t399_lanes[1] - 0.032 * t399_lanes[0] + t409 * t442 -
      0.095 * t440;
  const Real t469 = t409 * t447 - 0.00025 * t395;
  const Lanes<2> t473_lanes = detail::make_pack<Real>(c8, c15) * t465_lanes;
  const Lanes<2> t474_lanes = detail::make_pack<Real>(s9, s16) * t343_lanes -
      detail::make_pack<Real>(c9, c16) * t358_lanes + t367_lanes * t416_lanes;
  const Real t475 = h_22_x + t449 + t412 * t452;
  const Real t476 = t440 - minus_h_22_y + t409 * t452;
  const Real t477 = t408 * t447;
  const Real t478 = t411_lanes[1] + t411_lanes[0] + t406 * t446;
  const Lanes<2> t480_lanes = 0.000448 + (t434_lanes + t462_lanes);
  const Real t484 = t406 * t447;

  // links 7 and 8, 14 and 15, 22, articulated inertia
  const Lanes<2> inverse_D7_14_lanes = 1.0 / t480_lanes;
  const Lanes<2> t487_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * t438_lanes + detail::make_pack<Real>(c8, c15) *
      t441_lanes);
  const Lanes<2> t488_lanes = 0.0017499999999999998 + (t473_lanes - t426_lanes);
  const Lanes<2> t489_lanes = detail::make_pack<Real>(s8, s15) * (t460_lanes - t459_lanes) +
      t259_lanes * t474_lanes;
  const Real t490 = t408 * t452;

  // links 8, 15, 22, articulated inertia
  const Real t492 = s22 * (t461 - t467) + t445 * t468;
  const Real t493 = s22 * (t463 + t458) + c22 * (t469 - t464);
  const Real t494 = c22 * t475 - s22 * t476;
  const Lanes<2> t496_lanes = detail::make_pack<Real>(s8, s15) * t489_lanes;
  const Lanes<2> t497_lanes = detail::make_pack<Real>(c9, c16) * t343_lanes +
      detail::make_pack<Real>(s9, s16) * t358_lanes + t367_lanes * t419_lanes;
  const Real t498 = s22 * t492;
  const Lanes<2> t499_lanes = detail::make_pack<Real>(s9, s16) * t368_lanes + t339_lanes -
      t394_lanes * t419_lanes;
  const Real t500 = t410_lanes[1] + t410_lanes[0] - t406 * t452;
  const Real t501 = t425_lanes[1] + t425_lanes[0] - t404 * t452;
  const Real t502 = c22 * t493;
  const Real t503 = c22 * t476 + s22 * t475;
  const Lanes<2> t504_lanes = detail::make_pack<Real>(s8, s15) * t465_lanes;
  const Real t508 = t445 * t484 - s22 * (t477 - t478);
  const Real t512 = t502 - t469;
  const Lanes<2> t513_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * t455_lanes - t435_lanes);
  const Real t515 = s22 * t508;
  const Lanes<2> t516_lanes = t437_lanes + t504_lanes;
  const Real t517 = s22 * t493;

  // links 7, 14, 21 and 22, articulated inertia
  const Lanes<2> t518_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / t480_lanes;
  const Lanes<2> t520_lanes = t488_lanes * inverse_D7_14_lanes;
  const Lanes<2> t521_lanes = t487_lanes * inverse_D7_14_lanes;
  const Real t522 = t503 - link21_to_22_z * t501;
  const Real t523 = link21_to_22_z * t512;
  const Real t524 = c22 * t500 + s22 * t490;
  const Lanes<2> t525_lanes = t516_lanes * inverse_D7_14_lanes;
  const Real inverse_D21 = 1.0 / (J_21_zz + (t467 + t498));
  const Real t528 = minus_J_21_xz + (c22 * t492 - t468 + link21_to_22_z * t494);
  const Real t529 = t515 - t478;
  const Real t538 = link21_to_22_z * t524;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), articulated inertia
  const Lanes<2> t539_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * t521_lanes;
  const Lanes<2> t540_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * t520_lanes;
  const Lanes<2> t543_lanes = t513_lanes * inverse_D7_14_lanes;
  const Lanes<2> t547_lanes = t338_lanes + t375_lanes - t383_lanes * t419_lanes - t487_lanes *
      t521_lanes;
  const Lanes<2> t548_lanes = t460_lanes - t496_lanes - t488_lanes * t520_lanes;
  const Lanes<2> t549_lanes = detail::make_pack<Real>(c8, c15) * t497_lanes -
      detail::make_pack<Real>(s8, s15) * t499_lanes - t487_lanes * t520_lanes;
  const Lanes<2> t550_lanes = t428_lanes + t504_lanes + t513_lanes * t520_lanes;
  const Lanes<2> t551_lanes = detail::make_pack<Real>(c8, c15) * t438_lanes -
      detail::make_pack<Real>(s8, s15) * t441_lanes - t513_lanes * t521_lanes;

  // links 7, 14, 21 and 22, articulated inertia
  const Real t552 = t463 - t517 - t538;
  const Real t553 = 2.0 * s21;
  const Lanes<2> t554_lanes = detail::make_pack<Real>(s8, s15) * t497_lanes +
      detail::make_pack<Real>(c8, c15) * t499_lanes - t487_lanes * t525_lanes;
  const Lanes<2> t555_lanes = detail::make_pack<Real>(c8, c15) * t489_lanes - t474_lanes -
      t488_lanes * t525_lanes;
  const Lanes<2> t563_lanes = 0.0001505 - t518_lanes;
  const Real t571 = t523 * inverse_D21;
  const Lanes<2> t573_lanes = 0.0002975 + (t414_lanes - t462_lanes) - t513_lanes * t543_lanes;
  const Lanes<2> t575_lanes = 8.75e-06 + detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * t543_lanes;
  const Lanes<2> t578_lanes = detail::make_pack<Real>(s7, s14) * t554_lanes +
      detail::make_pack<Real>(c7, c14) * t555_lanes;
  const Real t581 = h_21_x + t494;

  // links 7, 14, 21, articulated inertia
  const Lanes<2> t582_lanes = detail::make_pack<Real>(c7, c14) * (t547_lanes - t548_lanes) -
      t359_lanes * t549_lanes;
  const Lanes<2> t584_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) * t525_lanes;
  const Real t585 = t512 * inverse_D21;
  const Lanes<2> t586_lanes = detail::make_pack<Real>(c7, c14) * (t550_lanes - t539_lanes) -
      detail::make_pack<Real>(s7, s14) * (t551_lanes - t540_lanes);
  const Lanes<2> t589_lanes = t473_lanes - t436_lanes - 0.0017499999999999998 - t513_lanes *
      t525_lanes;
  const Lanes<2> t590_lanes = t459_lanes + t496_lanes - t516_lanes * t525_lanes;
  const Lanes<2> t591_lanes = detail::make_pack<Real>(c7, c14) * t582_lanes;
  const Lanes<2> t595_lanes = detail::make_pack<Real>(s7, s14) * t586_lanes;
  const Lanes<2> t597_lanes = detail::make_pack<Real>(c7, c14) * t554_lanes -
      detail::make_pack<Real>(s7, s14) * t555_lanes;
  const Lanes<2> t598_lanes = detail::make_pack<Real>(c7, c14) * t586_lanes;
  const Real t599 = J_21_xx + (t461 - t498 - link21_to_22_z * (t503 + t522)) - t528 *
      (t528 * inverse_D21);
  const Real t600 = J_21_yy + 0.155236 * t529 - t523 * t571;
  const Real t601 = link21_to_22_z * t552 - t528 * t571;
  const Real t604 = t581 * inverse_D21;
  const Lanes<2> t605_lanes = t547_lanes - t591_lanes;
  const Lanes<2> t606_lanes = detail::make_pack<Real>(c7, c14) * (t563_lanes - t573_lanes) +
      t359_lanes * t575_lanes;
  const Lanes<2> t607_lanes = detail::make_pack<Real>(s7, s14) * t582_lanes + t549_lanes;
  const Lanes<2> t608_lanes = 0.226 * t597_lanes;
  const Lanes<2> t609_lanes = t540_lanes - t595_lanes;
  const Lanes<2> t610_lanes = detail::make_pack<Real>(c7, c14) * t584_lanes +
      detail::make_pack<Real>(s7, s14) * t589_lanes;
  const Lanes<2> t612_lanes = t539_lanes + t598_lanes;
  const Lanes<2> t614_lanes = detail::make_pack<Real>(c7, c14) * t606_lanes;
  const Lanes<2> t616_lanes = detail::make_pack<Real>(0.18, (-0.18)) * t607_lanes;
  const Real t617 = t552 - t528 * t585;
  const Lanes<2> t618_lanes = detail::make_pack<Real>(s7, s14) * t606_lanes;
  const Lanes<2> t619_lanes = t610_lanes + (detail::make_pack<Real>(0.18, (-0.18)) * t578_lanes +
      0.226 * t590_lanes);
  const Real t620 = link21_to_22_z * t529 - t523 * t585;

  // links 7, 21 and 22, articulated inertia
  const Real t621 = t517 - t458;
  const Real t624 = t614_lanes[1] + t614_lanes[0];
  const Real t627 = c21 * (t599 - t600) - t553 * t601;
  const Real t628 = t538 + t523 * t604;
  const Real t629 = t522 + t528 * t604;
  const Real t630 = t619_lanes[1] + t619_lanes[0];
  const Real t631 = c22 * t490 - s22 * t500;
  const Real t632 = t484 - c22 * t508;

  // links 7, 14, 21, articulated inertia
  const Lanes<2> t633_lanes = t548_lanes + t591_lanes;
  const Lanes<2> t634_lanes = t609_lanes + (detail::make_pack<Real>(0.18, (-0.18)) * t605_lanes +
      0.226 * t578_lanes);
  const Lanes<2> t635_lanes = t598_lanes - t550_lanes - (t616_lanes + t608_lanes);
  const Real t636 = t621 * inverse_D21;
  const Real t637 = c21 * t627;
  const Lanes<2> t638_lanes = t595_lanes + t551_lanes;
  const Lanes<2> t642_lanes = detail::make_pack<Real>(s7, s14) * t584_lanes -
      detail::make_pack<Real>(c7, c14) * t589_lanes;
  const Real t643 = t635_lanes[1] + t635_lanes[0];
  const Real t644 = t529 - t512 * t585;
  const Lanes<2> t645_lanes = detail::make_pack<Real>(0.18, (-0.18)) * (t609_lanes + t634_lanes);
  const Lanes<2> t646_lanes = detail::make_pack<Real>(0.18, (-0.18)) * (t635_lanes + t612_lanes);
  const Real t647 = t501 - t581 * t604;
  const Lanes<2> t648_lanes = t638_lanes + detail::make_pack<Real>(0.18, (-0.18)) * t633_lanes;
  const Real t649 = t642_lanes[1] + t642_lanes[0];

  // link 21 (neck), articulated inertia
  const Real t650 = c21 * (t617 - t628) - s21 * (t620 + t629);
  const Real t651 = t524 + t512 * t604;
  const Real t653 = c21 * t650;
  const Real t654 = t528 * t636 - (t502 + t464 + link21_to_22_z * t631);
  const Real t655 = s21 * t650;
  const Real t656 = t523 * t636 - (h_21_x + link21_to_22_z * t632);

  // links 6 and 7, 14, 21, articulated inertia
  const Real t657 = s21 * t627 + t601 + 0.226 * t643;
  const Lanes<2> t658_lanes = detail::make_pack<Real>(0.18, (-0.18)) * (t638_lanes + t648_lanes);
  const Real t659 = t633_lanes[1] + t633_lanes[0];
  const Real t660 = c21 * (t644 - t647) - t553 * t651;
  const Real t661 = t628 + t653 + t643;
  const Real t662 = c21 * t660;
  const Real t663 = 2.0 * c6;
  const Real t664 = J_6_zz + t600 + t637 + t573_lanes[1] + t624 + t645_lanes[1] + t573_lanes[0] +
      t645_lanes[0] + 0.226 * (t610_lanes[1] + t630 + t610_lanes[0]);
  const Real t665 = t655 + t629 - minus_h_6_x - t630;
  const Real t666 = t607_lanes[1] + t607_lanes[0];
  const Real t667 = t512 * t636 - t632;
  const Real t668 = c21 * t654 - s21 * t656 + t634_lanes[1] + t634_lanes[0];
  const Lanes<2> t669_lanes = t616_lanes - t612_lanes;
  const Real inverse_D6 = 1.0 / t664;
  const Real t670 = J_6_xz + t646_lanes[1] - t575_lanes[1] + t618_lanes[1] + t646_lanes[0] -
      t575_lanes[0] + t618_lanes[0] + 0.226 * t649;
  const Real t671 = t631 - t581 * t636;

  // links 5 (chest2) and 6 (chest3), articulated inertia
  const Real t672 = t661 * inverse_D6;
  const Real t673 = t657 * inverse_D6;
  const Real t674 = t670 * inverse_D6;
  const Real t675 = t668 * inverse_D6;
  const Real t676 = t665 * inverse_D6;
  const Real t677 = 2.0 * c5;

  // link 6 (chest3), articulated inertia
  const Real t678 = t648_lanes[1] + t648_lanes[0] - t670 * t672;
  const Real t679 = 0.40056549999999996 - t518_lanes[1] - t624 + t658_lanes[1] + t563_lanes[0] +
      t658_lanes[0] - t670 * t674;
  const Real t680 = t647 + t662 + t659 - t661 * t672;
  const Real t681 = t669_lanes[1] + t669_lanes[0] + t670 * t675;
  const Real t682 = t617 - t653 + t608_lanes[1] + t608_lanes[0] - t657 * t676;
  const Real t683 = (-0.18) * t597_lanes[1] - t649 + 0.18 * t597_lanes[0] - t670 * t676;
  const Real t684 = t666 - c21 * t667 + s21 * t671 + t668 * t672;
  const Real t685 = s21 * t660 + t651 + t597_lanes[1] + t597_lanes[0] - t665 * t672;
  const Real t686 = minus_h_6_x + t655 + t620 - t657 * t672 + 0.226 * t659;
  const Real t687 = J_6_yy + t599 - t637 - t657 * t673 + 0.051076 * t659;
  const Real t688 = t605_lanes[1] - (t477 + t515 + t621 * t636) + t605_lanes[0] - t668 * t675;
  const Real t689 = (-0.04068) * t633_lanes[1] + 0.04068 * t633_lanes[0] - t670 * t673 + 0.226 *
      (t638_lanes[1] + t638_lanes[0]);
  const Real t690 = t657 * t675 - (s21 * t654 + c21 * t656) + 0.226 * t666;
  const Real t691 = t644 - t662 + t590_lanes[1] + t590_lanes[0] - t665 * t676;
  const Real t692 = t578_lanes[1] - (s21 * t667 + c21 * t671) + t578_lanes[0] + t668 * t676;
  const Real t693 = c6 * t684 - s6 * t685;
  const Real t694 = s6 * t678 + c6 * t686;
  const Real t695 = s6 * t684 + c6 * t685;
  const Real t696 = c6 * t678 - s6 * t686;
  const Real t697 = t694 + minus_link5_to_6_y * t680;
  const Real t698 = s6 * (t679 - t687) + t663 * t689;
  const Real t699 = minus_link5_to_6_y * t695;
  const Real t700 = s6 * (t681 - t682) + c6 * (t690 + t683);
  const Real t701 = s6 * (t688 - t691) + t663 * t692;
  const Real t702 = s6 * t698;
  const Real t703 = minus_h_5_y + t697;
  const Real t704 = c6 * t700;
  const Real t705 = s6 * t700;
  const Real t706 = s6 * t701;
  const Real t707 = c6 * t701 - t692;
  const Real t708 = t691 + t706;
  const Real t709 = t704 - t690;
  const Real t710 = c6 * t698 - t689 + minus_link5_to_6_y * t696;
  const Real t711 = t682 + t705 + t699;
  const Real t712 = h_5_x + (t704 - t683 + minus_link5_to_6_y * t693);
  const Real t713 = minus_link5_to_6_y * t711;

  // link 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (J_5_zz + (t687 + t702 + minus_link5_to_6_y * (t694 + t697)));
  const Real t714 = t703 * inverse_D5;
  const Real t715 = t712 * inverse_D5;
  const Real t716 = t711 * inverse_D5;
  const Real t717 = t713 * inverse_D5;
  const Real t718 = t710 * inverse_D5;
  const Real t719 = t688 - t706 - t712 * t715;
  const Real t720 = t680 - t703 * t714;
  const Real t721 = t693 - t703 * t715;
  const Real t722 = t713 * t714 - t699;
  const Real s2_plus_3 = s2 * c3 + c2 * s3;
  const Real t723 = t681 - t705 - t710 * t715;
  const Real t724 = t696 - t710 * t714;
  const Real t725 = t713 * t715 - minus_link5_to_6_y * t707;
  const Real t726 = t707 - t712 * t716;
  const Real t727 = t695 - t703 * t716;
  const Real t728 = J_5_xx + 0.005183999999999999 * t708 - t713 * t717;
  const Real c2_plus_3 = c2 * c3 - s2 * s3;
  const Real t729 = J_5_yy + (t679 - t702) - t710 * t718;
  const Real t730 = J_5_xy - minus_link5_to_6_y * t709 + t713 * t718;
  const Real t731 = t709 - h_5_x - t710 * t716;

  // link 5 (chest2), pose and articulated inertia
  const Real t732 = s5 * s4;
  const Real t733 = t713 * t716 - (minus_h_5_y + minus_link5_to_6_y * t708);
  const Real t734 = c5 * s4;
  const Real t735 = s5 * (t720 - t719) + t677 * t721;
  const Real t736 = minus_link2_to_3_y * c2;
  const Real t737 = s5 * (t722 - t723) + c5 * (t724 + t725);
  const Real t738 = minus_link2_to_3_y * s2;
  const Real t741 = s5 * t735;
  const Real t742 = s5 * (t728 - t729) + t677 * t730;

  // link 6 (chest3), pose; link 5 (chest2), articulated inertia
  const Real t743 = s6 * c4 - c6 * t732;
  const Real t744 = s6 * t732 + c6 * c4;
  const Real t745 = s5 * t737;
  const Real t746 = s5 * t731 - c5 * t733;
  const Lanes<2> t747_lanes = 0.086 * detail::make_pack<Real>(s13, s20);
  const Real t748 = s5 * t742;
  const Real t749 = c5 * t737;
  const Real t750 = t720 - t741;
  const Lanes<2> t755_lanes = 0.086 * detail::make_pack<Real>(c13, c20);

  // links 4 (chest1) and 5 (chest2), articulated inertia; links 7 (left_shoulder1) and 14
  //   (right_shoulder1), pose
  const Real t756 = t723 + t745;
  const Lanes<2> t757_lanes = detail::make_pack<Real>(c7, c14) * t743 -
      detail::make_pack<Real>(s7, s14) * t734;
  const Lanes<2> t758_lanes = detail::make_pack<Real>(s7, s14) * t743 +
      detail::make_pack<Real>(c7, c14) * t734;
  const Real inverse_D4 = 1.0 / (J_4_zz + (t729 + t748));
  const Real t761 = s4 * (s5 * t727 + c5 * t726) - c4 * (c5 * t735 - t721);

  // link 5 (chest2), articulated inertia; links 8 (left_shoulder2) and 15 (right_shoulder2), pose
  const Real t762 = c4 * (2.0 * (s5 * t726 - c5 * t727)) - s4 * (t750 - (t708 - t711 * t716));
  const Real t763 = s4 * (s5 * t733 + c5 * t731) - c4 * (t749 - t725);
  const Lanes<2> t764_lanes = detail::make_pack<Real>(c8, c15) * t744 -
      detail::make_pack<Real>(s8, s15) * t757_lanes;
  const Lanes<2> t765_lanes = detail::make_pack<Real>(c8, c15) * t757_lanes +
      detail::make_pack<Real>(s8, s15) * t744;
  const Real t766 = minus_h_4_x * s4 + t763;

  // link 5 (chest2), articulated inertia; link 16 (right_upperarm), pose
  const Real t767 = t746 - c4 * (c4 * t746 - s4 * (t722 - t745));
  const Real t768 = t750 + s4 * t762;
  const Real t769 = link4_to_5_z * t763 + (J_4_xz - (c5 * t742 - t730)) * s4;
  const Real t770 = s16 * t764_lanes[1] + c16 * t758_lanes[1];
  const Real t771 = c16 * t764_lanes[1] - s16 * t758_lanes[1];

  // links 4 (chest1) and 5 (chest2), articulated inertia; link 17 (right_lowerarm), pose
  const Real t772 = t769 * inverse_D4;
  const Real t773 = t756 * inverse_D4;
  const Real t774 = t766 * inverse_D4;
  const Real t775 = t767 + link4_to_5_z * t768;
  const Real t776 = c17 * t770 + s17 * t765_lanes[1];
  const Real t777 = c17 * t765_lanes[1] - s17 * t770;
  const Real t778 = minus_h_4_x * c4 + (link4_to_5_z * t761 - s4 * (t749 - t724)) - t769 * t773;

  // link 18 (right_wrist1), pose; links 4, 8, 15, articulated inertia
  const Real t779 = c18 * t776 + s18 * t771;
  const Real t780 = c18 * t771 - s18 * t776;
  const Real t781 = minus_h_3_x + t778;
  const Real t782 = minus_h_3_y + (t775 - t769 * t774);
  const Lanes<2> t783_lanes = 0.00010499999999999999 / t389_lanes;

  // links 3 (hip) and 19 (right_wrist2), pose; links 3 (hip) and 4 (chest1), articulated inertia
  const Real t784 = c19 * t777 - s19 * t779;
  const Real t785 = c19 * t779 + s19 * t777;
  const Real t786 = 1.7947593951550056 + link4_to_5_z * (t767 + t775) - t769 * t772 +
      (0.03561389675370483 + (t728 - t748)) * s4 * s4;
  const Real c1_plus_2_plus_3 = c2_plus_3 * c1 - s2_plus_3 * s1;
  const Real inverse_D3 = 1.0 / t786;
  const Real s1_plus_2_plus_3 = s2_plus_3 * c1 + c2_plus_3 * s1;

  // link 5 (chest2), pose; link 1 (calf), articulated inertia; link 20 (right_hand), force
  //   propagation
  const Real t787 = c4 * c1_plus_2_plus_3;
  const Real t788 = s4 * c1_plus_2_plus_3;
  const Real t789 = t755_lanes[1] * t780 - t747_lanes[1] * t784;
  const Real t790 = -(t755_lanes[1] * t785) + t19_lanes[1] * t789;
  const Real t791 = s5 * t787 + c5 * s1_plus_2_plus_3;
  const Real t792 = c5 * t787 - s5 * s1_plus_2_plus_3;

  // link 3 (hip), articulated inertia; link 19 (right_wrist2), force propagation
  const Real t795 = t781 * inverse_D3;
  const Real t796 = t782 * inverse_D3;
  const Real t797 = t784 + t23_lanes[1] * t789 - t47_lanes[1] * t790;
  const Real t798 = t785 + t48_lanes[1] * t790;
  const Real t799 = t747_lanes[1] * t785 + t22_lanes[1] * t789 - t46_lanes[1] * t790;
  const Real t800 = t780 - t24_lanes[1] * t789 - t49_lanes[1] * t790;

  // link 6 (chest3), pose; link 3 (hip), articulated inertia
  const Real t801 = c6 * t791 + s6 * t788;
  const Real t802 = s6 * t791 - c6 * t788;
  const Real t807 = t782 * t795 - (t761 - t766 * t773);
  const Real t808 = t768 - t766 * t774 - t782 * t796;
  const Real t809 = t719 + t741 - t756 * t773 - t781 * t795;

  // links 18 (right_wrist1) and 19 (right_wrist2), force propagation; links 7 (left_shoulder1) and
  //   14 (right_shoulder1), pose
  const Real t810 = s19 * t797 - c19 * t798;
  const Real t811 = -(c19 * t799);
  const Lanes<2> t812_lanes = detail::make_pack<Real>(c7, c14) * t801 +
      detail::make_pack<Real>(s7, s14) * t792;
  const Lanes<2> t813_lanes = detail::make_pack<Real>(c7, c14) * t792 -
      detail::make_pack<Real>(s7, s14) * t801;
  const Real t816 = 0.269 * t800 - s19 * t799 - t124_lanes[1] * t811;

  // link 18 (right_wrist1), force propagation; links 8 (left_shoulder2) and 15 (right_shoulder2),
  //   pose
  const Real t817 = -t810 + t126_lanes[1] * t811;
  const Real t818 = t800 - t127_lanes[1] * t811;
  const Real t819 = 0.269 * t810 - t125_lanes[1] * t811;
  const Lanes<2> t820_lanes = detail::make_pack<Real>(s8, s15) * t812_lanes +
      detail::make_pack<Real>(c8, c15) * t802;
  const Lanes<2> t821_lanes = detail::make_pack<Real>(s8, s15) * t802 -
      detail::make_pack<Real>(c8, c15) * t812_lanes;

  // link 3 (hip), articulated inertia; link 18 (right_wrist1), force propagation; link 16
  //   (right_upperarm), pose
  const Real t822 = s2_plus_3 * (t808 - t809) + c2_plus_3 * (2.0 * t807);
  const Real t823 = s2_plus_3 * t822;
  const Real t824 = s18 * t816 + c18 * t819;
  const Real t825 = s16 * t820_lanes[1] + c16 * t813_lanes[1];
  const Real t826 = c16 * t820_lanes[1] - s16 * t813_lanes[1];

  // link 17 (right_lowerarm), force propagation; link 3 (hip), articulated inertia; link 17
  //   (right_lowerarm), pose
  const Real t827 = t208_lanes[1] * t824;
  const Real t828 = c2_plus_3 * t822 - t807;
  const Real t829 = t808 - t823;
  const Real t830 = c18 * t816 - s18 * t819 - t210_lanes[1] * t824;
  const Real t831 = c18 * t817 - s18 * t818 - t213_lanes[1] * t824;
  const Real t832 = -(-(s19 * t798 + c19 * t797) - t128_lanes[1] * t811) - t214_lanes[1] * t824;
  const Real t833 = c17 * t825 + s17 * t821_lanes[1];
  const Real t834 = c17 * t821_lanes[1] - s17 * t825;
  const Real t835 = s18 * t817 + c18 * t818 - t215_lanes[1] * t824;
  const Real t836 = t736 * t829 + t738 * t828;
  const Real t837 = c17 * t827 - s17 * t830;
  const Real t838 = s17 * t832 - c17 * t831;

  // links 5 (chest2) and 18 (right_wrist1), pose; link 3 (hip), articulated inertia
  const Real t839 = c4 * s1_plus_2_plus_3;
  const Real t840 = c18 * t833 + s18 * t826;
  const Real t841 = c18 * t826 - s18 * t833;
  const Real t842 = s4 * s1_plus_2_plus_3;
  const Real t843 = t836 - (h_2_x * s2 - minus_h_2_y * c2);

  // link 16 (right_upperarm), force propagation; links 5 (chest2) and 19 (right_wrist2), pose
  const Real t844 = c17 * t830 + s17 * t827 + 0.282 * t835 - t308_lanes[1] * t837;
  const Real t845 = 0.282 * t838 - t309_lanes[1] * t837;
  const Real t846 = s5 * t839 - c5 * c1_plus_2_plus_3;
  const Real t847 = s5 * c1_plus_2_plus_3 + c5 * t839;
  const Real t848 = c19 * t834 - s19 * t840;
  const Real t849 = c19 * t840 + s19 * t834;

  // links 2 (thigh) and 3 (hip), articulated inertia; link 16 (right_upperarm), force propagation;
  //   link 6 (chest3), pose
  const Real t850 = J_2_zz + (t738 * (t736 * t828 + t738 * (t809 + t823)) + t736 * t836);
  const Real inverse_D2 = 1.0 / t850;
  const Real t853 = c16 * t844 - s16 * t845;
  const Real t854 = c6 * t846 + s6 * t842;
  const Real t855 = c6 * t842 - s6 * t846;

  // link 1 (calf), articulated inertia; link 15 (right_shoulder2), force propagation; links 7
  //   (left_shoulder1) and 14 (right_shoulder1), pose
  const Real t856 = t755_lanes[1] * t841 - t747_lanes[1] * t848;
  const Real t857 = t783_lanes[1] * t853;
  const Real t862 = s16 * t844 + c16 * t845 - t413_lanes[1] * t853;
  const Lanes<2> t863_lanes = detail::make_pack<Real>(c7, c14) * t854 +
      detail::make_pack<Real>(s7, s14) * t847;
  const Lanes<2> t864_lanes = detail::make_pack<Real>(s7, s14) * t854 -
      detail::make_pack<Real>(c7, c14) * t847;

  // links 15 (right_shoulder2) and 20 (right_hand), force propagation; link 2 (thigh), articulated
  //   inertia; links 8 (left_shoulder2) and 15 (right_shoulder2), pose
  const Real t865 = -(t755_lanes[1] * t849) + t19_lanes[1] * t856;
  const Real t870 = t843 * inverse_D2;
  const Real t871 = s15 * t857 + c15 * t862;
  const Lanes<2> t872_lanes = detail::make_pack<Real>(c8, c15) * t855 -
      detail::make_pack<Real>(s8, s15) * t863_lanes;
  const Lanes<2> t873_lanes = detail::make_pack<Real>(c8, c15) * t863_lanes +
      detail::make_pack<Real>(s8, s15) * t855;

  // link 19 (right_wrist2), force propagation; link 9 (left_upperarm), pose
  const Real t874 = t848 + t23_lanes[1] * t856 - t47_lanes[1] * t865;
  const Real t875 = t849 + t48_lanes[1] * t865;
  const Real t876 = t747_lanes[1] * t849 + t22_lanes[1] * t856 - t46_lanes[1] * t865;
  const Real t877 = t841 - t24_lanes[1] * t856 - t49_lanes[1] * t865;
  const Lanes<8> t882_lanes = s9 * detail::make_pack<Real>(t820_lanes[0], t764_lanes[0],
      t872_lanes[0], t820_lanes[0], t820_lanes[0], t820_lanes[0], t820_lanes[0], t820_lanes[0]) +
      c9 * detail::make_pack<Real>(t813_lanes[0], t758_lanes[0], t864_lanes[0], t813_lanes[0],
      t813_lanes[0], t813_lanes[0], t813_lanes[0], t813_lanes[0]);
  const Lanes<8> t883_lanes = c9 * detail::make_pack<Real>(t820_lanes[0], t764_lanes[0],
      t872_lanes[0], t820_lanes[0], t820_lanes[0], t820_lanes[0], t820_lanes[0], t820_lanes[0]) -
      s9 * detail::make_pack<Real>(t813_lanes[0], t758_lanes[0], t864_lanes[0], t813_lanes[0],
      t813_lanes[0], t813_lanes[0], t813_lanes[0], t813_lanes[0]);
  const Real t884 = s19 * t874 - c19 * t875;

  // link 18 (right_wrist1), force propagation; links 10 (left_lowerarm) and 11 (left_wrist1), pose
  const Real t885 = -(c19 * t876);
  const Real t890 = 0.269 * t877 - s19 * t876 - t124_lanes[1] * t885;
  const Real t891 = -t884 + t126_lanes[1] * t885;
  const Real t892 = t877 - t127_lanes[1] * t885;
  const Lanes<8> t893_lanes = c10 * t882_lanes + s10 *
      detail::make_pack<Real>(t821_lanes[0], t765_lanes[0], t873_lanes[0], t821_lanes[0],
      t821_lanes[0], t821_lanes[0], t821_lanes[0], t821_lanes[0]);
  const Lanes<8> t894_lanes = c10 * detail::make_pack<Real>(t821_lanes[0], t765_lanes[0],
      t873_lanes[0], t821_lanes[0], t821_lanes[0], t821_lanes[0], t821_lanes[0], t821_lanes[0]) -
      s10 * t882_lanes;
  const Real t895 = 0.269 * t884 - t125_lanes[1] * t885;
  const Lanes<8> t900_lanes = c11 * t893_lanes + s11 * t883_lanes;
  const Lanes<8> t901_lanes = c11 * t883_lanes - s11 * t893_lanes;
  const Real t902 = s18 * t890 + c18 * t895;

  // link 17 (right_lowerarm), force propagation; link 12 (left_wrist2), pose
  const Real t906 = t208_lanes[1] * t902;
  const Lanes<8> t907_lanes = c12 * t894_lanes - s12 * t900_lanes;
  const Lanes<8> t908_lanes = c12 * t900_lanes + s12 * t894_lanes;
  const Real t909 = c18 * t890 - s18 * t895 - t210_lanes[1] * t902;
  const Real t910 = c18 * t891 - s18 * t892 - t213_lanes[1] * t902;
  const Real t911 = -(-(s19 * t875 + c19 * t874) - t128_lanes[1] * t885) - t214_lanes[1] * t902;
  const Real t912 = s18 * t891 + c18 * t892 - t215_lanes[1] * t902;

  // link 1 (calf), articulated inertia; links 13 (left_hand) and 17 (right_lowerarm), force
  //   propagation
  const Lanes<8> t915_lanes = t747_lanes[0] * t908_lanes;
  const Lanes<8> t916_lanes = t755_lanes[0] * t901_lanes - t747_lanes[0] * t907_lanes;
  const Lanes<8> t917_lanes = -(t755_lanes[0] * t908_lanes);
  const Real t918 = c17 * t906 - s17 * t909;
  const Real t919 = s17 * t911 - c17 * t910;

  // links 13 (left_hand) and 16 (right_upperarm), force propagation
  const Real t924 = -t838 + t310_lanes[1] * t837;
  const Real t925 = t835 - t311_lanes[1] * t837;
  const Lanes<8> t926_lanes = detail::make_pack<Real>(t917_lanes[0], t917_lanes[1], t917_lanes[2],
      t901_lanes[0], t901_lanes[1], t901_lanes[2], t917_lanes[0], t917_lanes[0]) + t19_lanes[0] *
      detail::make_pack<Real>(t916_lanes[0], t916_lanes[1], t916_lanes[2], t908_lanes[0],
      t908_lanes[1], t908_lanes[2], t916_lanes[0], t916_lanes[0]);
  const Lanes<8> t927_lanes = t907_lanes + t23_lanes[0] * t916_lanes;
  const Lanes<8> t929_lanes = t901_lanes - t24_lanes[0] * t916_lanes;
  const Real t930 = 0.282 * t919 - t309_lanes[1] * t918;
  const Real t931 = -t919 + t310_lanes[1] * t918;

  // links 12 (left_wrist2) and 16 (right_upperarm), force propagation
  const Lanes<8> t935_lanes = t48_lanes[0] * t926_lanes;
  const Real t937 = c17 * t909 + s17 * t906 + 0.282 * t912 - t308_lanes[1] * t918;
  const Real t938 = t912 - t311_lanes[1] * t918;
  const Lanes<8> t939_lanes = detail::make_pack<Real>(t927_lanes[0], t927_lanes[1], t927_lanes[2],
      t23_lanes[0] * t908_lanes[0], t23_lanes[0] * t908_lanes[1], t23_lanes[0] * t908_lanes[2],
      t927_lanes[0], t927_lanes[0]) - t47_lanes[0] * t926_lanes;
  const Lanes<8> t940_lanes = t908_lanes + t48_lanes[0] * t926_lanes;
  const Lanes<8> t941_lanes = detail::make_pack<Real>(t915_lanes[0], t915_lanes[1], t915_lanes[2],
      t907_lanes[0], t907_lanes[1], t907_lanes[2], t915_lanes[0], t915_lanes[0]) + t22_lanes[0] *
      detail::make_pack<Real>(t916_lanes[0], t916_lanes[1], t916_lanes[2], t908_lanes[0],
      t908_lanes[1], t908_lanes[2], t916_lanes[0], t916_lanes[0]) - t46_lanes[0] * t926_lanes;
  const Lanes<8> t942_lanes = detail::make_pack<Real>(t929_lanes[0], t929_lanes[1], t929_lanes[2],
      -(t24_lanes[0] * t908_lanes[0]), -(t24_lanes[0] * t908_lanes[1]),
      -(t24_lanes[0] * t908_lanes[2]), t929_lanes[0], t929_lanes[0]) - t49_lanes[0] * t926_lanes;
  const Real t950 = c16 * t937 - s16 * t930;

  // links 11 and 12, 15, force propagation
  const Real t951 = s16 * t924 + c16 * t925 - t416_lanes[1] * t853;
  const Real t952 = -(-(s17 * t831 + c17 * t832) + t312_lanes[1] * t837) + t415_lanes[1] * t853;
  const Lanes<8> t953_lanes = s12 * t939_lanes - c12 *
      detail::make_pack<Real>(t940_lanes[0], t940_lanes[1], t940_lanes[2], t935_lanes[3],
      t935_lanes[4], t935_lanes[5], t940_lanes[0], t940_lanes[0]);
  const Lanes<8> t954_lanes = -(c12 * t941_lanes);
  const Real t962 = t783_lanes[1] * t950;

  // link 11 (left_wrist1), force propagation; links 7 (left_shoulder1) and 14 (right_shoulder1),
  //   articulated inertia
  const Lanes<8> t965_lanes = 0.269 * t942_lanes - s12 * t941_lanes - t124_lanes[0] * t954_lanes;
  const Lanes<8> t966_lanes = -t953_lanes + t126_lanes[0] * t954_lanes;
  const Lanes<2> t968_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / t480_lanes;
  const Lanes<8> t969_lanes = t942_lanes - t127_lanes[0] * t954_lanes;
  const Lanes<8> t970_lanes = -(s12 * detail::make_pack<Real>(t940_lanes[0], t940_lanes[1],
      t940_lanes[2], t935_lanes[3], t935_lanes[4], t935_lanes[5], t940_lanes[0], t940_lanes[0]) +
      c12 * t939_lanes) - t128_lanes[0] * t954_lanes;

  // links 11 (left_wrist1) and 15 (right_shoulder2), force propagation
  const Real t971 = s16 * t937 + c16 * t930 - t413_lanes[1] * t950;
  const Real t972 = s16 * t931 + c16 * t938 - t416_lanes[1] * t950;
  const Real t973 = -(-(s17 * t910 + c17 * t911) + t312_lanes[1] * t918) + t415_lanes[1] * t950;
  const Lanes<8> t974_lanes = 0.269 * t953_lanes - t125_lanes[0] * t954_lanes;
  const Real t986 = s15 * t962 + c15 * t971;
  const Lanes<8> t987_lanes = s11 * t965_lanes + c11 * t974_lanes;

  // link 10 (left_lowerarm), force propagation
  const Lanes<8> t992_lanes = t208_lanes[0] * t987_lanes;
  const Lanes<8> t994_lanes = c11 * t965_lanes - s11 * t974_lanes - t210_lanes[0] * t987_lanes;
  const Lanes<8> t995_lanes = -t970_lanes - t214_lanes[0] * t987_lanes;
  const Lanes<8> t996_lanes = c11 * t966_lanes - s11 * t969_lanes - t213_lanes[0] * t987_lanes;
  const Lanes<8> t999_lanes = s11 * t966_lanes + c11 * t969_lanes - t215_lanes[0] * t987_lanes;
  const Lanes<8> t1007_lanes = c10 * t992_lanes - s10 * t994_lanes;
  const Lanes<8> t1008_lanes = s10 * t995_lanes - c10 * t996_lanes;

  // link 9 (left_upperarm), force propagation
  const Lanes<8> t1011_lanes = t308_lanes[0] * t1007_lanes;
  const Lanes<8> t1020_lanes = c10 * t994_lanes + s10 * t992_lanes + 0.282 * t999_lanes -
      t1011_lanes;
  const Lanes<8> t1021_lanes = 0.282 * t1008_lanes - t309_lanes[0] * t1007_lanes;
  const Lanes<8> t1022_lanes = -t1008_lanes + t310_lanes[0] * t1007_lanes;
  const Lanes<8> t1023_lanes = t999_lanes - t311_lanes[0] * t1007_lanes;
  const Lanes<8> t1024_lanes = -(s10 * t996_lanes + c10 * t995_lanes) + t312_lanes[0] * t1007_lanes;
  const Lanes<8> t1034_lanes = c9 * t1020_lanes - s9 * t1021_lanes;

  // link 8 (left_shoulder2), force propagation
  const Lanes<8> t1039_lanes = t783_lanes[0] * t1034_lanes;
  const Lanes<8> t1043_lanes = s9 * t1020_lanes + c9 * t1021_lanes - t413_lanes[0] * t1034_lanes;
  const Lanes<8> t1045_lanes = s9 * t1022_lanes + c9 * t1023_lanes - t416_lanes[0] * t1034_lanes;
  const Lanes<8> t1046_lanes = -t1024_lanes + t415_lanes[0] * t1034_lanes;
  const Lanes<8> t1047_lanes = c9 * t1022_lanes - s9 * t1023_lanes - t419_lanes[0] * t1034_lanes;
  const Lanes<8> t1055_lanes = s8 * t1039_lanes + c8 * t1043_lanes;
  const Lanes<8> t1056_lanes = c8 * t1046_lanes - s8 * t1045_lanes;
  const Lanes<8> t1057_lanes = s8 * t1046_lanes + c8 * t1045_lanes;
  const Lanes<8> t1058_lanes = c8 * t1039_lanes - s8 * t1043_lanes;

  // links 7 to 11, 14, force propagation
  const Lanes<8> t1063_lanes = detail::make_pack<Real>(t968_lanes[0], t968_lanes[0], t968_lanes[0],
      t968_lanes[0], t968_lanes[0], t968_lanes[0], t968_lanes[1], t968_lanes[1]) *
      detail::make_pack<Real>(t1055_lanes[0], t1055_lanes[1], t1055_lanes[2], t1055_lanes[3],
      t1055_lanes[4], t1055_lanes[5], t986, t871);
  const Lanes<8> t1064_lanes = t987_lanes * inverse_D10_17_lanes[0];
  const Lanes<8> t1065_lanes = t1007_lanes * inverse_D9_16_lanes[0];
  const Lanes<8> t1066_lanes = t954_lanes * inverse_D11_18_lanes[0];
  const Lanes<8> t1067_lanes = t1034_lanes * inverse_D8_15_lanes[0];

  // links 7, 12 to 14, force propagation; link 1 (calf), articulated inertia
  const Lanes<8> t1068_lanes = t926_lanes * inverse_D12_19_lanes[0];
  const Lanes<8> t1069_lanes = t1055_lanes * inverse_D7_14_lanes[0];
  const Lanes<8> t1070_lanes = 1065.380700001509 * detail::make_pack<Real>(t916_lanes[0],
      t916_lanes[1], t916_lanes[2], t908_lanes[0], t908_lanes[1], t908_lanes[2], t916_lanes[0],
      t916_lanes[0]);
  const Real inverse_D1 = 1.0 / (J_1_zz + 0.188356 * (t829 - t843 * t870));
  const Lanes<8> t1071_lanes = detail::make_pack<Real>(t1047_lanes[0], t1047_lanes[1],
      t1047_lanes[2], t1047_lanes[3], t1047_lanes[4], t1047_lanes[5], c16 * t931 - s16 * t938 -
      t419_lanes[1] * t950, c16 * t924 - s16 * t925 - t419_lanes[1] * t853) -
      detail::make_pack<Real>(t521_lanes[0], t521_lanes[0], t521_lanes[0], t521_lanes[0],
      t521_lanes[0], t521_lanes[0], t521_lanes[1], t521_lanes[1]) *
      detail::make_pack<Real>(t1055_lanes[0], t1055_lanes[1], t1055_lanes[2], t1055_lanes[3],
      t1055_lanes[4], t1055_lanes[5], t986, t871);

  // links 7, 10, 14, force propagation
  const Lanes<8> t1072_lanes = detail::make_pack<Real>(t1056_lanes[0], t1056_lanes[1],
      t1056_lanes[2], t1056_lanes[3], t1056_lanes[4], t1056_lanes[5], c15 * t973 - s15 * t972, c15 *
      t952 - s15 * t951) - detail::make_pack<Real>(t520_lanes[0], t520_lanes[0], t520_lanes[0],
      t520_lanes[0], t520_lanes[0], t520_lanes[0], t520_lanes[1], t520_lanes[1]) *
      detail::make_pack<Real>(t1055_lanes[0], t1055_lanes[1], t1055_lanes[2], t1055_lanes[3],
      t1055_lanes[4], t1055_lanes[5], t986, t871);
  const Lanes<8> t1073_lanes = detail::make_pack<Real>(t1057_lanes[0], t1057_lanes[1],
      t1057_lanes[2], t1057_lanes[3], t1057_lanes[4], t1057_lanes[5], s15 * t973 + c15 * t972, s15 *
      t952 + c15 * t951) - detail::make_pack<Real>(t525_lanes[0], t525_lanes[0], t525_lanes[0],
      t525_lanes[0], t525_lanes[0], t525_lanes[0], t525_lanes[1], t525_lanes[1]) *
      detail::make_pack<Real>(t1055_lanes[0], t1055_lanes[1], t1055_lanes[2], t1055_lanes[3],
      t1055_lanes[4], t1055_lanes[5], t986, t871);
  const Lanes<8> t1074_lanes = detail::make_pack<Real>(t1058_lanes[0], t1058_lanes[1],
      t1058_lanes[2], t1058_lanes[3], t1058_lanes[4], t1058_lanes[5], c15 * t962 - s15 * t971, c15 *
      t857 - s15 * t862) - detail::make_pack<Real>(t543_lanes[0], t543_lanes[0], t543_lanes[0],
      t543_lanes[0], t543_lanes[0], t543_lanes[0], t543_lanes[1], t543_lanes[1]) *
      detail::make_pack<Real>(t1055_lanes[0], t1055_lanes[1], t1055_lanes[2], t1055_lanes[3],
      t1055_lanes[4], t1055_lanes[5], t986, t871);
  const Lanes<8> t1078_lanes = t1064_lanes * t987_lanes[0];
  const Lanes<8> t1092_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      t1071_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * t1072_lanes;
  const Lanes<8> t1094_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      t1071_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * t1072_lanes;
  const Lanes<8> t1102_lanes = t1070_lanes * t916_lanes[0] + t1068_lanes * t926_lanes[0] +
      t1066_lanes * t954_lanes[0] + t1078_lanes;
  const Lanes<8> t1106_lanes = t1064_lanes * t987_lanes[1];
  const Lanes<8> t1108_lanes = 0.226 * t1073_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) * t1092_lanes;

  // link 6 (chest3), force propagation
  const Lanes<8> t1115_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      t1063_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * t1074_lanes +
      t1108_lanes);
  const Lanes<8> t1116_lanes = t674 * t1115_lanes;
  const Lanes<8> t1121_lanes = t1115_lanes * inverse_D6;
  const Real t1122 = t1115_lanes[7] * inverse_D6;
  const Real t1123 = t1115_lanes[6] * inverse_D6;

  // links 6 and 7, 10, force propagation
  const Lanes<8> t1124_lanes = t1102_lanes + t1065_lanes * t1007_lanes[0] + t1067_lanes *
      t1034_lanes[0] + t1069_lanes * t1055_lanes[0];
  const Lanes<8> t1125_lanes = t1070_lanes * t916_lanes[1] + t1068_lanes * t926_lanes[1] +
      t1066_lanes * t954_lanes[1] + t1106_lanes;
  const Lanes<8> t1126_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18),
      (-0.18)) * t1094_lanes - (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      t1063_lanes - detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * t1074_lanes) -
      t1116_lanes;
  const Lanes<8> t1127_lanes = 0.226 * t1094_lanes - t673 * t1115_lanes;
  const Lanes<8> t1128_lanes = t1094_lanes - t672 * t1115_lanes;
  const Lanes<8> t1129_lanes = t1092_lanes + t675 * t1115_lanes;
  const Lanes<8> t1130_lanes = t1073_lanes - t676 * t1115_lanes;
  const Lanes<8> t1143_lanes = t1124_lanes + t1121_lanes * t1115_lanes[0];
  const Lanes<8> t1148_lanes = t1064_lanes * t987_lanes[2];
  const Lanes<8> t1155_lanes = s6 * t1129_lanes + c6 * t1130_lanes;
  const Lanes<8> t1156_lanes = t1125_lanes + t1065_lanes * t1007_lanes[1] + t1067_lanes *
      t1034_lanes[1] + t1069_lanes * t1055_lanes[1];
  const Lanes<8> t1158_lanes = s6 * t1126_lanes + c6 * t1127_lanes + minus_link5_to_6_y *
      t1128_lanes;
  const Lanes<8> t1161_lanes = t1156_lanes + t1121_lanes * t1115_lanes[1];

  // links 5 (chest2) and 10 (left_lowerarm), force propagation
  const Lanes<8> t1167_lanes = t1158_lanes * inverse_D5;
  const Lanes<8> t1172_lanes = t1064_lanes * t987_lanes[3];
  const Lanes<8> t1178_lanes = c6 * t1129_lanes - s6 * t1130_lanes - t715 * t1158_lanes;
  const Lanes<8> t1179_lanes = t1128_lanes - t714 * t1158_lanes;
  const Lanes<8> t1180_lanes = c6 * t1126_lanes - s6 * t1127_lanes - t718 * t1158_lanes;
  const Lanes<8> t1181_lanes = -(minus_link5_to_6_y * t1155_lanes) + t717 * t1158_lanes;
  const Lanes<8> t1185_lanes = t1070_lanes * t916_lanes[2] + t1068_lanes * t926_lanes[2] +
      t1066_lanes * t954_lanes[2] + t1148_lanes;
  const Lanes<8> t1192_lanes = s4 * (t1155_lanes - t716 * t1158_lanes);

  // links 4 and 5, 7, 10, force propagation
  const Lanes<8> t1211_lanes = -(s5 * t1181_lanes + c5 * t1180_lanes);
  const Lanes<8> t1215_lanes = t1211_lanes * inverse_D4;
  const Lanes<8> t1217_lanes = t1185_lanes + t1065_lanes * t1007_lanes[2] + t1067_lanes *
      t1034_lanes[2] + t1069_lanes * t1055_lanes[2];
  const Lanes<8> t1218_lanes = t1070_lanes * t908_lanes[0] + t1068_lanes * t926_lanes[3] +
      t1066_lanes * t954_lanes[3] + t1172_lanes;
  const Lanes<8> t1219_lanes = c4 * (s5 * t1178_lanes - c5 * t1179_lanes) + t1192_lanes;

  // links 4 to 7, force propagation
  const Lanes<8> t1220_lanes = -(s5 * t1179_lanes + c5 * t1178_lanes) - t773 * t1211_lanes;
  const Lanes<8> t1223_lanes = t1217_lanes + t1121_lanes * t1115_lanes[2];
  const Lanes<8> t1239_lanes = s4 * (s5 * t1180_lanes - c5 * t1181_lanes) + link4_to_5_z *
      t1219_lanes;
  const Lanes<8> t1241_lanes = t1218_lanes + t1065_lanes * t1007_lanes[3] + t1067_lanes *
      t1034_lanes[3] + t1069_lanes * t1055_lanes[3];
  const Lanes<8> t1245_lanes = -t1239_lanes - t772 * t1211_lanes;

  // link 16 (right_upperarm), pose; links 3, 6, 8, force propagation
  const Real t1246 = s16 * t872_lanes[1] + c16 * t864_lanes[1];
  const Lanes<8> t1247_lanes = t1241_lanes + t1121_lanes * t1115_lanes[3];
  const Lanes<8> t1251_lanes = t1245_lanes * inverse_D3;
  const Real t1252 = c16 * t872_lanes[1] - s16 * t864_lanes[1];
  const Lanes<8> t1254_lanes = t1070_lanes * t908_lanes[1] +
      detail::make_pack<Real>(t1068_lanes[4] * t926_lanes[4], t1068_lanes[4] * t926_lanes[4],
      t1068_lanes[4] * t926_lanes[4], t1068_lanes[4] * t926_lanes[4], t1068_lanes[4] *
      t926_lanes[4], t1068_lanes[5] * t926_lanes[4], t1068_lanes[4] * t926_lanes[4],
      t1068_lanes[4] * t926_lanes[4]) + detail::make_pack<Real>(t1066_lanes[4] * t954_lanes[4],
      t1066_lanes[4] * t954_lanes[4], t1066_lanes[4] * t954_lanes[4], t1066_lanes[4] *
      t954_lanes[4], t1066_lanes[4] * t954_lanes[4], t1066_lanes[5] * t954_lanes[4],
      t1066_lanes[4] * t954_lanes[4], t1066_lanes[4] * t954_lanes[4]) +
      detail::make_pack<Real>(t1064_lanes[4] * t987_lanes[4], t1064_lanes[4] * t987_lanes[4],
      t1064_lanes[4] * t987_lanes[4], t1064_lanes[4] * t987_lanes[4], t1064_lanes[4] *
      t987_lanes[4], t1064_lanes[5] * t987_lanes[4], t1064_lanes[4] * t987_lanes[4],
      t1064_lanes[4] * t987_lanes[4]) + detail::make_pack<Real>(t1065_lanes[4] * t1007_lanes[4],
      t1065_lanes[4] * t1007_lanes[4], t1065_lanes[4] * t1007_lanes[4], t1065_lanes[4] *
      t1007_lanes[4], t1065_lanes[4] * t1007_lanes[4], t1065_lanes[5] * t1007_lanes[4],
      t1065_lanes[4] * t1007_lanes[4], t1065_lanes[4] * t1007_lanes[4]) +
      detail::make_pack<Real>(t1067_lanes[4] * t1034_lanes[4], t1067_lanes[4] * t1034_lanes[4],
      t1067_lanes[4] * t1034_lanes[4], t1067_lanes[4] * t1034_lanes[4], t1067_lanes[4] *
      t1034_lanes[4], t1067_lanes[5] * t1034_lanes[4], t1067_lanes[4] * t1034_lanes[4],
      t1067_lanes[4] * t1034_lanes[4]);

  // link 3 (hip), force propagation; link 17 (right_lowerarm), pose
  const Lanes<8> t1255_lanes = -t1219_lanes - t774 * t1211_lanes - t796 * t1245_lanes;
  const Lanes<8> t1256_lanes = -t1220_lanes + t795 * t1245_lanes;
  const Real t1259 = c17 * t1246 + s17 * t873_lanes[1];
  const Real t1260 = c17 * t873_lanes[1] - s17 * t1246;
  const Lanes<8> t1271_lanes = detail::make_pack<Real>(t1143_lanes[0], t1143_lanes[1],
      t1143_lanes[2], t1143_lanes[3], t1143_lanes[4], t1143_lanes[5], t1123 * t1115_lanes[0],
      t1122 * t1115_lanes[0]) + t1167_lanes * t1158_lanes[0] + t1215_lanes * t1211_lanes[0] +
      t1251_lanes * t1245_lanes[0];

  // links 3 (hip) and 6 (chest3), force propagation
  const Lanes<8> t1272_lanes = detail::make_pack<Real>(t1161_lanes[1], t1161_lanes[1],
      t1161_lanes[2], t1161_lanes[3], t1161_lanes[4], t1161_lanes[5], t1123 * t1115_lanes[1],
      t1122 * t1115_lanes[1]) + t1167_lanes * t1158_lanes[1] + t1215_lanes * t1211_lanes[1] +
      t1251_lanes * t1245_lanes[1];
  const Lanes<8> t1273_lanes = detail::make_pack<Real>(t1223_lanes[2], t1223_lanes[2],
      t1223_lanes[2], t1223_lanes[3], t1223_lanes[4], t1223_lanes[5], t1123 * t1115_lanes[2],
      t1122 * t1115_lanes[2]) + t1167_lanes * t1158_lanes[2] + t1215_lanes * t1211_lanes[2] +
      t1251_lanes * t1245_lanes[2];
  const Lanes<8> t1274_lanes = detail::make_pack<Real>(t1247_lanes[3], t1247_lanes[3],
      t1247_lanes[3], t1247_lanes[3], t1247_lanes[4], t1247_lanes[5], t1123 * t1115_lanes[3],
      t1122 * t1115_lanes[3]) + t1167_lanes * t1158_lanes[3] + t1215_lanes * t1211_lanes[3] +
      t1251_lanes * t1245_lanes[3];
  const Lanes<8> t1275_lanes = t1254_lanes + detail::make_pack<Real>(t1069_lanes[4] *
      t1055_lanes[4], t1069_lanes[4] * t1055_lanes[4], t1069_lanes[4] * t1055_lanes[4],
      t1069_lanes[4] * t1055_lanes[4], t1069_lanes[4] * t1055_lanes[4], t1069_lanes[5] *
      t1055_lanes[4], t1069_lanes[4] * t1055_lanes[4], t1069_lanes[4] * t1055_lanes[4]) +
      detail::make_pack<Real>(t1121_lanes[4] * t1115_lanes[4], t1121_lanes[4] * t1115_lanes[4],
      t1121_lanes[4] * t1115_lanes[4], t1121_lanes[4] * t1115_lanes[4], t1121_lanes[4] *
      t1115_lanes[4], t1121_lanes[5] * t1115_lanes[4], t1121_lanes[4] * t1115_lanes[4],
      t1121_lanes[4] * t1115_lanes[4]);
  const Lanes<8> t1277_lanes = c2_plus_3 * t1255_lanes - s2_plus_3 * t1256_lanes;

  // links 18 (right_wrist1) and 19 (right_wrist2), pose; link 3 (hip), force propagation
  const Real t1278 = c18 * t1259 + s18 * t1252;
  const Real t1279 = c18 * t1252 - s18 * t1259;
  const Lanes<8> t1284_lanes = t738 * (s2_plus_3 * t1255_lanes + c2_plus_3 * t1256_lanes) + t736 *
      t1277_lanes;
  const Real t1285 = c19 * t1260 - s19 * t1278;
  const Real t1286 = c19 * t1278 + s19 * t1260;
  const Lanes<8> t1287_lanes = detail::make_pack<Real>(t1275_lanes[4], t1275_lanes[4],
      t1275_lanes[4], t1275_lanes[4], t1275_lanes[4], t1275_lanes[5], t1123 * t1115_lanes[4],
      t1122 * t1115_lanes[4]) + t1167_lanes * t1158_lanes[4] + t1215_lanes * t1211_lanes[4] +
      t1251_lanes * t1245_lanes[4];

  // links 2, 19 and 20, force propagation; link 1 (calf), articulated inertia
  const Lanes<8> t1289_lanes = t1284_lanes * inverse_D2;
  const Lanes<8> t1290_lanes = t23_lanes[1] * detail::make_pack<Real>(t849, t849, t785, t1286, t849,
      t849, t849, t849);
  const Real t1296 = t755_lanes[1] * t1279 - t747_lanes[1] * t1285;
  const Lanes<8> t1300_lanes = -(t24_lanes[1] * detail::make_pack<Real>(t849, t849, t785, t1286,
      t849, t849, t849, t849));
  const Lanes<8> t1301_lanes = minus_link1_to_2_y * (t1277_lanes - t870 * t1284_lanes);

  // links 1, 19 and 20, force propagation
  const Lanes<8> t1309_lanes = t1301_lanes * inverse_D1;
  const Lanes<8> t1310_lanes = detail::make_pack<Real>(-(t755_lanes[1] * t1286), t841, t780, t1279,
      -(t755_lanes[1] * t1286), -(t755_lanes[1] * t1286), -(t755_lanes[1] * t1286),
      -(t755_lanes[1] * t1286)) + t19_lanes[1] * detail::make_pack<Real>(t1296, t849, t785, t1286,
      t1296, t1296, t1296, t1296);
  const Lanes<8> t1316_lanes = t48_lanes[1] * t1310_lanes;
  const Lanes<8> t1322_lanes = t1271_lanes + t1289_lanes * t1284_lanes[0] + t1309_lanes *
      t1301_lanes[0];
  const Lanes<8> t1324_lanes = detail::make_pack<Real>(t1285 + t23_lanes[1] * t1296, t1290_lanes[1],
      t1290_lanes[2], t1290_lanes[3], t1285 + t23_lanes[1] * t1296, t1285 + t23_lanes[1] * t1296,
      t1285 + t23_lanes[1] * t1296, t1285 + t23_lanes[1] * t1296) - t47_lanes[1] * t1310_lanes;
  const Real t1325 = t1286 + t48_lanes[1] * t1310_lanes[0];
  const Lanes<8> t1326_lanes = detail::make_pack<Real>(t747_lanes[1] * t1286, t848, t784, t1285,
      t747_lanes[1] * t1286, t747_lanes[1] * t1286, t747_lanes[1] * t1286, t747_lanes[1] * t1286) +
      t22_lanes[1] * detail::make_pack<Real>(t1296, t849, t785, t1286, t1296, t1296, t1296, t1296) -
      t46_lanes[1] * t1310_lanes;
  const Lanes<8> t1327_lanes = detail::make_pack<Real>(t1279 - t24_lanes[1] * t1296, t1300_lanes[1],
      t1300_lanes[2], t1300_lanes[3], t1279 - t24_lanes[1] * t1296, t1279 - t24_lanes[1] * t1296,
      t1279 - t24_lanes[1] * t1296, t1279 - t24_lanes[1] * t1296) - t49_lanes[1] * t1310_lanes;
  const Real t1331 = t1322_lanes[0] * t1322_lanes[0];
  const Real t1339 = t1331 * t1322_lanes[0];

  // links 18 to 20, force propagation
  const Lanes<8> t1340_lanes = s19 * t1324_lanes - c19 *
      detail::make_pack<Real>(t1325, t1316_lanes[1], t1316_lanes[2], t1316_lanes[3], t1325, t1325,
      t1325, t1325);
  const Lanes<8> t1341_lanes = -(c19 * t1326_lanes);
  const Lanes<8> t1349_lanes = t1310_lanes * inverse_D12_19_lanes[1];
  const Lanes<8> t1352_lanes = 1065.380700001509 * detail::make_pack<Real>(t1296, t849, t785, t1286,
      t1296, t1296, t1296, t1296);
  const Lanes<8> t1353_lanes = t1341_lanes * inverse_D11_18_lanes[1];

  // links 1 (calf) and 18 (right_wrist1), force propagation
  const Lanes<8> t1354_lanes = 0.269 * t1327_lanes - s19 * t1326_lanes - t124_lanes[1] *
      t1341_lanes;
  const Lanes<8> t1355_lanes = -t1340_lanes + t126_lanes[1] * t1341_lanes;
  const Lanes<8> t1357_lanes = t1327_lanes - t127_lanes[1] * t1341_lanes;
  const Lanes<8> t1358_lanes = -(s19 * detail::make_pack<Real>(t1325, t1316_lanes[1],
      t1316_lanes[2], t1316_lanes[3], t1325, t1325, t1325, t1325) + c19 * t1324_lanes) -
      t128_lanes[1] * t1341_lanes;
  const Lanes<8> t1360_lanes = 0.269 * t1340_lanes - t125_lanes[1] * t1341_lanes;
  const Real t1372 = t1339 * t1331 / (8.077935669463161e-28 + t1339 * t1339);
  const Lanes<8> t1376_lanes = s18 * t1354_lanes + c18 * t1360_lanes;

  // link 17 (right_lowerarm), force propagation
  const Lanes<8> t1382_lanes = t208_lanes[1] * t1376_lanes;
  const Lanes<8> t1384_lanes = t1376_lanes * inverse_D10_17_lanes[1];
  const Lanes<8> t1385_lanes = c18 * t1354_lanes - s18 * t1360_lanes - t210_lanes[1] * t1376_lanes;
  const Lanes<8> t1386_lanes = -t1358_lanes - t214_lanes[1] * t1376_lanes;
  const Lanes<8> t1387_lanes = c18 * t1355_lanes - s18 * t1357_lanes - t213_lanes[1] * t1376_lanes;
  const Lanes<8> t1390_lanes = s18 * t1355_lanes + c18 * t1357_lanes - t215_lanes[1] * t1376_lanes;

  // links 1, 10, 17 and 18, force propagation
  const Lanes<2> t1391_lanes = detail::make_pack<Real>(t1064_lanes[5], t1384_lanes[3]) *
      detail::make_pack<Real>(t987_lanes[5], t1376_lanes[3]);
  const Lanes<8> t1392_lanes = t1322_lanes * t1372;
  const Lanes<2> t1398_lanes = detail::make_pack<Real>(t1070_lanes[5], t1352_lanes[3]) *
      detail::make_pack<Real>(t908_lanes[2], t1286) +
      detail::make_pack<Real>(t1068_lanes[5], t1349_lanes[3]) *
      detail::make_pack<Real>(t926_lanes[5], t1310_lanes[3]) +
      detail::make_pack<Real>(t1066_lanes[5], t1353_lanes[3]) *
      detail::make_pack<Real>(t954_lanes[5], t1341_lanes[3]) + t1391_lanes;
  const Lanes<8> t1401_lanes = c17 * t1382_lanes - s17 * t1385_lanes;
  const Lanes<8> t1402_lanes = s17 * t1386_lanes - c17 * t1387_lanes;
  const Real t1407 = 1065.380700001509 * t856 * t856 + t865 * inverse_D12_19_lanes[1] * t865 +
      t885 * inverse_D11_18_lanes[1] * t885;

  // links 1 (calf) and 16 (right_upperarm), force propagation
  const Lanes<8> t1408_lanes = t308_lanes[1] * t1401_lanes;
  const Lanes<8> t1411_lanes = t1401_lanes * inverse_D9_16_lanes[1];
  const Lanes<8> t1412_lanes = t1272_lanes + t1289_lanes * t1284_lanes[1] + t1309_lanes *
      t1301_lanes[1] - t1392_lanes * t1322_lanes[1];
  const Lanes<8> t1413_lanes = t1273_lanes + t1289_lanes * t1284_lanes[2] + t1309_lanes *
      t1301_lanes[2] - t1392_lanes * t1322_lanes[2];
  const Real t1415 = t837 * inverse_D9_16_lanes[1];
  const Lanes<8> t1416_lanes = t1274_lanes + t1289_lanes * t1284_lanes[3] + t1309_lanes *
      t1301_lanes[3] - t1392_lanes * t1322_lanes[3];
  const Lanes<8> t1417_lanes = t1287_lanes + t1289_lanes * t1284_lanes[4] + t1309_lanes *
      t1301_lanes[4] - t1392_lanes * t1322_lanes[4];

  // links 14 and 15, 17, 19 and 20, force propagation
  const Real t1418 = 1065.380700001509 * t789;
  const Real t1419 = t824 * inverse_D10_17_lanes[1];
  const Real t1420 = t790 * inverse_D12_19_lanes[1];
  const Real t1421 = t853 * inverse_D8_15_lanes[1];
  const Real t1422 = t871 * inverse_D7_14_lanes[1];

  // links 1, 16, 18, force propagation
  const Real t1423 = t1412_lanes[1] * t1412_lanes[1];
  const Lanes<8> t1424_lanes = c17 * t1385_lanes + s17 * t1382_lanes + 0.282 * t1390_lanes -
      t1408_lanes;
  const Lanes<8> t1425_lanes = 0.282 * t1402_lanes - t309_lanes[1] * t1401_lanes;
  const Real t1427 = t811 * inverse_D11_18_lanes[1];
  const Real t1432 = t1423 * t1412_lanes[1];

  // links 1, 4, 15 and 16, force propagation
  const Real t1434 = t1407 + t902 * inverse_D10_17_lanes[1] * t902 + t918 * inverse_D9_16_lanes[1] *
      t918 + t950 * inverse_D8_15_lanes[1] * t950;
  const Lanes<8> t1435_lanes = c16 * t1424_lanes - s16 * t1425_lanes;
  const Lanes<8> t1438_lanes = t783_lanes[1] * t1435_lanes;
  const Lanes<8> t1439_lanes = t1435_lanes * inverse_D8_15_lanes[1];
  const Lanes<8> t1440_lanes = s16 * t1424_lanes + c16 * t1425_lanes - t413_lanes[1] * t1435_lanes;
  const Real t1443 = t1432 * t1423 / (8.077935669463161e-28 + t1432 * t1432);
  const Real t1444 = t1434 + t986 * inverse_D7_14_lanes[1] * t986 + t1123 * t1115_lanes[6] +
      t1167_lanes[6] * t1158_lanes[6] + t1215_lanes[6] * t1211_lanes[6];
  const Real t1446 = t1418 * t856 + t1420 * t865 + t1427 * t885 + t1419 * t902 + t1415 * t918;
  const Lanes<8> t1448_lanes = s15 * t1438_lanes + c15 * t1440_lanes;

  // links 1, 14, 16, force propagation
  const Lanes<8> t1452_lanes = t968_lanes[1] * t1448_lanes;
  const Lanes<8> t1453_lanes = t1448_lanes * inverse_D7_14_lanes[1];
  const Lanes<8> t1454_lanes = t521_lanes[1] * t1448_lanes;
  const Real t1458 = t1418 * t789 + t1420 * t790 + t1427 * t811 + t1419 * t824 + t1415 * t837;
  const Lanes<8> t1461_lanes = t1412_lanes * t1443;
  const Real t1464 = t1444 + t1251_lanes[6] * t1245_lanes[6] + t1289_lanes[6] * t1284_lanes[6] +
      t1309_lanes[6] * t1301_lanes[6] - t1392_lanes[6] * t1322_lanes[6];

  // links 5, 7, 14, 16, force propagation
  const Lanes<8> t1465_lanes = -t1402_lanes + t310_lanes[1] * t1401_lanes;
  const Lanes<8> t1468_lanes = c15 * t1438_lanes - s15 * t1440_lanes - t543_lanes[1] * t1448_lanes;
  const Lanes<8> t1469_lanes = t1390_lanes - t311_lanes[1] * t1401_lanes;
  const Real t1470 = t1446 + t1421 * t950 + t1422 * t986 + t1122 * t1115_lanes[6] + t1167_lanes[7] *
      t1158_lanes[6];
  const Lanes<2> t1483_lanes = t1398_lanes + detail::make_pack<Real>(t1065_lanes[5],
      t1411_lanes[3]) * detail::make_pack<Real>(t1007_lanes[5], t1401_lanes[3]) +
      detail::make_pack<Real>(t1067_lanes[5], t1439_lanes[3]) *
      detail::make_pack<Real>(t1034_lanes[5], t1435_lanes[3]) +
      detail::make_pack<Real>(t1069_lanes[5], t1453_lanes[3]) *
      detail::make_pack<Real>(t1055_lanes[5], t1448_lanes[3]);

  // links 1, 15 and 16, force propagation
  const Lanes<8> t1487_lanes = t1413_lanes - t1461_lanes * t1412_lanes[2];
  const Lanes<8> t1493_lanes = -(s17 * t1387_lanes + c17 * t1386_lanes) + t312_lanes[1] *
      t1401_lanes;
  const Real t1497 = t1487_lanes[2] * t1487_lanes[2];
  const Lanes<8> t1498_lanes = s16 * t1465_lanes + c16 * t1469_lanes - t416_lanes[1] * t1435_lanes;
  const Lanes<8> t1501_lanes = -t1493_lanes + t415_lanes[1] * t1435_lanes;

  // links 1, 3, 5, 14, force propagation
  const Real t1504 = t1458 + t1421 * t853 + t1422 * t871 + t1122 * t1115_lanes[7] + t1167_lanes[7] *
      t1158_lanes[7];
  const Real t1505 = t1497 * t1487_lanes[2];
  const Lanes<8> t1507_lanes = c16 * t1465_lanes - s16 * t1469_lanes - t419_lanes[1] * t1435_lanes -
      t1454_lanes;
  const Real t1514 = t1470 + t1215_lanes[7] * t1211_lanes[6] + t1251_lanes[7] * t1245_lanes[6] +
      t1289_lanes[7] * t1284_lanes[6] + t1309_lanes[7] * t1301_lanes[6];
  const Lanes<8> t1517_lanes = detail::make_pack<Real>(t1483_lanes[0] + t1121_lanes[5] *
      t1115_lanes[5], t1483_lanes[0] + t1121_lanes[5] * t1115_lanes[5], t1483_lanes[0] +
      t1121_lanes[5] * t1115_lanes[5], t1483_lanes[0] + t1121_lanes[5] * t1115_lanes[5],
      t1483_lanes[0] + t1121_lanes[5] * t1115_lanes[5], t1483_lanes[0] + t1121_lanes[5] *
      t1115_lanes[5], t1123 * t1115_lanes[5], t1122 * t1115_lanes[5]) + t1167_lanes *
      t1158_lanes[5] + t1215_lanes * t1211_lanes[5] + t1251_lanes * t1245_lanes[5];

  // links 1 (calf) and 14 (right_shoulder1), force propagation
  const Lanes<8> t1518_lanes = c15 * t1501_lanes - s15 * t1498_lanes - t520_lanes[1] * t1448_lanes;
  const Lanes<8> t1519_lanes = s15 * t1501_lanes + c15 * t1498_lanes - t525_lanes[1] * t1448_lanes;
  const Real t1521 = t1505 * t1497 / (8.077935669463161e-28 + t1505 * t1505);
  const Real t1526 = t1504 + t1215_lanes[7] * t1211_lanes[7] + t1251_lanes[7] * t1245_lanes[7] +
      t1289_lanes[7] * t1284_lanes[7] + t1309_lanes[7] * t1301_lanes[7];
  const Lanes<8> t1527_lanes = s14 * t1507_lanes + c14 * t1518_lanes;
  const Lanes<8> t1528_lanes = c14 * t1507_lanes - s14 * t1518_lanes;
  const Lanes<8> t1529_lanes = t1517_lanes + t1289_lanes * t1284_lanes[5] + t1309_lanes *
      t1301_lanes[5] - t1392_lanes * t1322_lanes[5];
  const Lanes<8> t1534_lanes = 0.226 * t1519_lanes + (-0.18) * t1527_lanes;
  const Lanes<8> t1536_lanes = t1487_lanes * t1521;

  // links 1 (calf) and 6 (chest3), force propagation
  const Lanes<8> t1539_lanes = -(c14 * t1452_lanes + s14 * t1468_lanes + t1534_lanes);
  const Lanes<8> t1540_lanes = t674 * t1539_lanes;
  const Lanes<8> t1547_lanes = t1416_lanes - t1461_lanes * t1412_lanes[3] - t1536_lanes *
      t1487_lanes[3];
  const Lanes<8> t1548_lanes = (-0.18) * t1528_lanes - (s14 * t1452_lanes - c14 * t1468_lanes) -
      t1540_lanes;
  const Lanes<8> t1549_lanes = 0.226 * t1528_lanes - t673 * t1539_lanes;
  const Lanes<8> t1550_lanes = t1528_lanes - t672 * t1539_lanes;
  const Lanes<8> t1551_lanes = t1527_lanes + t675 * t1539_lanes;
  const Lanes<8> t1552_lanes = t1519_lanes - t676 * t1539_lanes;
  const Real t1555 = t1547_lanes[3] * t1547_lanes[3];
  const Real t1565 = t1555 * t1547_lanes[3];
  const Lanes<8> t1568_lanes = s6 * t1551_lanes + c6 * t1552_lanes;
  const Lanes<8> t1569_lanes = t1539_lanes * inverse_D6;
  const Lanes<8> t1571_lanes = s6 * t1548_lanes + c6 * t1549_lanes + minus_link5_to_6_y *
      t1550_lanes;

  // link 5 (chest2), force propagation
  const Lanes<8> t1579_lanes = t1571_lanes * inverse_D5;
  const Lanes<8> t1582_lanes = c6 * t1551_lanes - s6 * t1552_lanes - t715 * t1571_lanes;
  const Lanes<8> t1583_lanes = t1550_lanes - t714 * t1571_lanes;
  const Lanes<8> t1584_lanes = c6 * t1548_lanes - s6 * t1549_lanes - t718 * t1571_lanes;
  const Lanes<8> t1585_lanes = -(minus_link5_to_6_y * t1568_lanes) + t717 * t1571_lanes;

  // links 1, 4 and 5, force propagation
  const Real t1586 = t1565 * t1555 / (3.552713678800501e-15 + t1565 * t1565);
  const Lanes<8> t1594_lanes = s4 * (t1568_lanes - t716 * t1571_lanes);
  const Lanes<8> t1610_lanes = -(s5 * t1585_lanes + c5 * t1584_lanes);
  const Lanes<8> t1614_lanes = t1610_lanes * inverse_D4;
  const Lanes<8> t1618_lanes = t1547_lanes * t1586;
  const Lanes<8> t1619_lanes = c4 * (s5 * t1582_lanes - c5 * t1583_lanes) + t1594_lanes;
  const Lanes<8> t1620_lanes = -(s5 * t1583_lanes + c5 * t1582_lanes) - t773 * t1610_lanes;
  const Lanes<8> t1639_lanes = s4 * (s5 * t1584_lanes - c5 * t1585_lanes) + link4_to_5_z *
      t1619_lanes;
  const Lanes<8> t1640_lanes = t1417_lanes - t1461_lanes * t1412_lanes[4] - t1536_lanes *
      t1487_lanes[4] - t1618_lanes * t1547_lanes[4];
  const Lanes<8> t1641_lanes = t1529_lanes - t1461_lanes * t1412_lanes[5] - t1536_lanes *
      t1487_lanes[5] - t1618_lanes * t1547_lanes[5];
  const Real t1643 = t1514 - t1392_lanes[7] * t1322_lanes[6] - t1461_lanes[7] * t1412_lanes[6] -
      t1536_lanes[7] * t1487_lanes[6] - t1618_lanes[7] * t1547_lanes[6];
  const Lanes<8> t1645_lanes = -t1639_lanes - t772 * t1610_lanes;

  // links 1 (calf) and 3 (hip), force propagation
  const Real t1649 = t1640_lanes[4] * t1640_lanes[4];
  const Real t1651 = t1526 - t1392_lanes[7] * t1322_lanes[7] - t1461_lanes[7] * t1412_lanes[7] -
      t1536_lanes[7] * t1487_lanes[7] - t1618_lanes[7] * t1547_lanes[7];
  const Lanes<8> t1654_lanes = t1645_lanes * inverse_D3;
  const Real t1656 = t1649 * t1640_lanes[4];
  const Lanes<8> t1657_lanes = -t1619_lanes - t774 * t1610_lanes - t796 * t1645_lanes;

  // link 3 (hip), force propagation
  const Lanes<8> t1658_lanes = -t1620_lanes + t795 * t1645_lanes;
  const Lanes<8> t1659_lanes = t1654_lanes * t1245_lanes[0];
  const Lanes<8> t1660_lanes = t1654_lanes * t1245_lanes[1];
  const Lanes<8> t1661_lanes = t1654_lanes * t1245_lanes[2];
  const Lanes<8> t1662_lanes = t1654_lanes * t1245_lanes[3];
  const Lanes<8> t1663_lanes = t1654_lanes * t1245_lanes[4];
  const Lanes<8> t1664_lanes = t1654_lanes * t1245_lanes[5];
  const Lanes<8> t1671_lanes = t1569_lanes * t1115_lanes[0] + t1579_lanes * t1158_lanes[0] +
      t1614_lanes * t1211_lanes[0] + t1659_lanes;
  const Lanes<8> t1672_lanes = t1569_lanes * t1115_lanes[1] + t1579_lanes * t1158_lanes[1] +
      t1614_lanes * t1211_lanes[1] + t1660_lanes;

  // links 1, 3, 17, force propagation
  const Lanes<8> t1673_lanes = t1384_lanes * t902;
  const Lanes<8> t1675_lanes = t1569_lanes * t1115_lanes[2] + t1579_lanes * t1158_lanes[2] +
      t1614_lanes * t1211_lanes[2] + t1661_lanes;
  const Lanes<8> t1678_lanes = t1569_lanes * t1115_lanes[3] + t1579_lanes * t1158_lanes[3] +
      t1614_lanes * t1211_lanes[3] + t1662_lanes;
  const Lanes<8> t1681_lanes = t1569_lanes * t1115_lanes[4] + t1579_lanes * t1158_lanes[4] +
      t1614_lanes * t1211_lanes[4] + t1663_lanes;
  const Lanes<8> t1683_lanes = c2_plus_3 * t1657_lanes - s2_plus_3 * t1658_lanes;
  const Lanes<8> t1687_lanes = t1569_lanes * t1115_lanes[5] + t1579_lanes * t1158_lanes[5] +
      t1614_lanes * t1211_lanes[5] + t1664_lanes;
  const Real t1689 = t1656 * t1649 / (5.551115123125783e-17 + t1656 * t1656);
  const Lanes<8> t1694_lanes = t738 * (s2_plus_3 * t1657_lanes + c2_plus_3 * t1658_lanes) + t736 *
      t1683_lanes;
  const Lanes<8> t1695_lanes = t1352_lanes * t856 + t1349_lanes * t865 + t1353_lanes * t885 +
      t1673_lanes;

  // links 1 and 2, 14, 17, force propagation
  const Lanes<8> t1697_lanes = t1694_lanes * inverse_D2;
  const Lanes<8> t1703_lanes = t1640_lanes * t1689;
  const Lanes<8> t1711_lanes = minus_link1_to_2_y * (t1683_lanes - t870 * t1694_lanes);
  const Lanes<8> t1718_lanes = t1384_lanes * t824;
  const Lanes<8> t1722_lanes = t1695_lanes + t1411_lanes * t918 + t1439_lanes * t950 + t1453_lanes *
      t986;

  // links 1 (calf) and 17 (right_lowerarm), force propagation
  const Lanes<8> t1725_lanes = t1711_lanes * inverse_D1;
  const Lanes<8> t1732_lanes = t1641_lanes - t1703_lanes * t1640_lanes[5];
  const Real t1733 = t1464 - t1461_lanes[6] * t1412_lanes[6] - t1536_lanes[6] * t1487_lanes[6] -
      t1618_lanes[6] * t1547_lanes[6] - t1703_lanes[6] * t1640_lanes[6];
  const Real t1740 = t1732_lanes[5] * t1732_lanes[5];
  const Lanes<8> t1744_lanes = t1352_lanes * t789 + t1349_lanes * t790 + t1353_lanes * t811 +
      t1718_lanes;
  const Lanes<8> t1748_lanes = t1384_lanes * t1376_lanes[0];
  const Lanes<8> t1752_lanes = t1671_lanes + t1697_lanes * t1284_lanes[0] + t1725_lanes *
      t1301_lanes[0];

  // links 1, 4, 14, 17, force propagation
  const Real t1756 = t1740 * t1732_lanes[5];
  const Lanes<8> t1759_lanes = t1722_lanes + t1569_lanes * t1115_lanes[6] + t1579_lanes *
      t1158_lanes[6] + t1614_lanes * t1211_lanes[6];
  const Lanes<8> t1763_lanes = t1752_lanes * t1372;
  const Lanes<8> t1778_lanes = t1744_lanes + t1411_lanes * t837 + t1439_lanes * t853 + t1453_lanes *
      t871;
  const Lanes<8> t1782_lanes = t1352_lanes * t1296 + t1349_lanes * t1310_lanes[0] + t1353_lanes *
      t1341_lanes[0] + t1748_lanes;

  // link 1 (calf), force propagation
  const Lanes<8> t1789_lanes = t1672_lanes + t1697_lanes * t1284_lanes[1] + t1725_lanes *
      t1301_lanes[1] - t1763_lanes * t1322_lanes[1];
  const Lanes<8> t1790_lanes = t1675_lanes + t1697_lanes * t1284_lanes[2] + t1725_lanes *
      t1301_lanes[2] - t1763_lanes * t1322_lanes[2];
  const Lanes<8> t1791_lanes = t1678_lanes + t1697_lanes * t1284_lanes[3] + t1725_lanes *
      t1301_lanes[3] - t1763_lanes * t1322_lanes[3];
  const Lanes<8> t1792_lanes = t1681_lanes + t1697_lanes * t1284_lanes[4] + t1725_lanes *
      t1301_lanes[4] - t1763_lanes * t1322_lanes[4];
  const Real t1793 = t1756 * t1740 / (8.673617379884035e-19 + t1756 * t1756);
  const Lanes<8> t1796_lanes = t1687_lanes + t1697_lanes * t1284_lanes[5] + t1725_lanes *
      t1301_lanes[5] - t1763_lanes * t1322_lanes[5];
  const Lanes<8> t1797_lanes = t1759_lanes + t1654_lanes * t1245_lanes[6] + t1697_lanes *
      t1284_lanes[6] + t1725_lanes * t1301_lanes[6];
  const Lanes<8> t1801_lanes = t1789_lanes * t1443;

  // links 1, 4, 14, 17, force propagation
  const Lanes<8> t1802_lanes = t1384_lanes * t1376_lanes[1];
  const Lanes<8> t1817_lanes = t1782_lanes + t1411_lanes * t1401_lanes[0] + t1439_lanes *
      t1435_lanes[0] + t1453_lanes * t1448_lanes[0];
  const Lanes<8> t1818_lanes = t1778_lanes + t1569_lanes * t1115_lanes[7] + t1579_lanes *
      t1158_lanes[7] + t1614_lanes * t1211_lanes[7];
  const Lanes<8> t1824_lanes = t1790_lanes - t1801_lanes * t1412_lanes[2];
  const Lanes<8> t1831_lanes = t1352_lanes * t849 + t1349_lanes * t1310_lanes[1] + t1353_lanes *
      t1341_lanes[1] + t1802_lanes;

  // links 1, 4, 20, force propagation
  const Real t1832 = t1732_lanes[6] * t1793;
  const Lanes<8> t1833_lanes = t1824_lanes * t1521;
  const Real t1834 = t1732_lanes[7] * t1793;
  const Lanes<8> t1838_lanes = t1352_lanes * t785;
  const Lanes<8> t1843_lanes = t1817_lanes + t1569_lanes * t1539_lanes[0] + t1579_lanes *
      t1571_lanes[0] + t1614_lanes * t1610_lanes[0];

  // links 1 (calf) and 14 (right_shoulder1), force propagation
  const Lanes<8> t1844_lanes = t1818_lanes + t1654_lanes * t1245_lanes[7] + t1697_lanes *
      t1284_lanes[7] + t1725_lanes * t1301_lanes[7];
  const Real t1849 = t1733 - t1832 * t1732_lanes[6];
  const Lanes<8> t1850_lanes = t1791_lanes - t1801_lanes * t1412_lanes[3] - t1833_lanes *
      t1487_lanes[3];
  const Real t1851 = t1643 - t1703_lanes[7] * t1640_lanes[6] - t1834 * t1732_lanes[6];
  const Lanes<8> t1854_lanes = t1797_lanes - t1763_lanes * t1322_lanes[6] - t1801_lanes *
      t1412_lanes[6] - t1833_lanes * t1487_lanes[6];
  const Lanes<8> t1857_lanes = t1831_lanes + t1411_lanes * t1401_lanes[1] + t1439_lanes *
      t1435_lanes[1] + t1453_lanes * t1448_lanes[1];
  const Real t1858 = t1849 * t1849;
  const Lanes<8> t1859_lanes = t1850_lanes * t1586;
  const Real t1863 = t1858 * t1849;
  const Lanes<8> t1868_lanes = t1843_lanes + t1654_lanes * t1645_lanes[0] + t1697_lanes *
      t1694_lanes[0] + t1725_lanes * t1711_lanes[0];
  const Lanes<8> t1869_lanes = t1844_lanes - t1763_lanes * t1322_lanes[7] - t1801_lanes *
      t1412_lanes[7] - t1833_lanes * t1487_lanes[7];

  // links 1, 4, 16, force propagation
  const Real t1873 = t1838_lanes[2] + t1349_lanes[2] * t1310_lanes[2] + t1353_lanes[2] *
      t1341_lanes[2] + t1384_lanes[2] * t1376_lanes[2] + t1411_lanes[2] * t1401_lanes[2];
  const Lanes<8> t1874_lanes = t1792_lanes - t1801_lanes * t1412_lanes[4] - t1833_lanes *
      t1487_lanes[4] - t1859_lanes * t1547_lanes[4];
  const Lanes<8> t1875_lanes = t1796_lanes - t1801_lanes * t1412_lanes[5] - t1833_lanes *
      t1487_lanes[5] - t1859_lanes * t1547_lanes[5];
  const Lanes<8> t1879_lanes = t1857_lanes + t1569_lanes * t1539_lanes[1] + t1579_lanes *
      t1571_lanes[1] + t1614_lanes * t1610_lanes[1];
  const Lanes<8> t1880_lanes = t1874_lanes * t1689;
  const Real t1883 = t1863 * t1858 / (8.077935669463161e-28 + t1863 * t1863);

  // links 1, 5, 16, force propagation
  const Lanes<8> t1887_lanes = t1868_lanes - t1763_lanes * t1752_lanes[0] - t1801_lanes *
      t1789_lanes[0] - t1833_lanes * t1824_lanes[0];
  const Lanes<8> t1891_lanes = t1875_lanes - t1880_lanes * t1640_lanes[5];
  const Lanes<8> t1895_lanes = t1879_lanes + t1654_lanes * t1645_lanes[1] + t1697_lanes *
      t1694_lanes[1] + t1725_lanes * t1711_lanes[1];
  const Real t1896 = t1873 + t1439_lanes[2] * t1435_lanes[2] + t1453_lanes[2] * t1448_lanes[2] +
      t1569_lanes[2] * t1539_lanes[2] + t1579_lanes[2] * t1571_lanes[2];
  const Real t1897 = t1838_lanes[3] + t1349_lanes[3] * t1310_lanes[2] + t1353_lanes[3] *
      t1341_lanes[2] + t1384_lanes[3] * t1376_lanes[2] + t1411_lanes[3] * t1401_lanes[2];

  // link 1 (calf), force propagation
  const Lanes<8> t1898_lanes = t1891_lanes * t1793;
  const Real t1906 = t1851 * t1883;
  const Real t1907 = t1461_lanes[2] * t1392_lanes[1] - t1392_lanes[2];
  const Lanes<8> t1908_lanes = t1895_lanes - t1763_lanes * t1752_lanes[1] - t1801_lanes *
      t1789_lanes[1] - t1833_lanes * t1824_lanes[1];
  const Lanes<8> t1909_lanes = t1854_lanes - t1859_lanes * t1547_lanes[6] - t1880_lanes *
      t1640_lanes[6] - t1898_lanes * t1732_lanes[6];
  const Lanes<8> t1910_lanes = t1869_lanes - t1859_lanes * t1547_lanes[7] - t1880_lanes *
      t1640_lanes[7] - t1898_lanes * t1732_lanes[7];
  const Lanes<8> t1911_lanes = t1887_lanes - t1859_lanes * t1850_lanes[0] - t1880_lanes *
      t1874_lanes[0] - t1898_lanes * t1891_lanes[0];

  // links 1, 3, 5, force propagation
  const Real t1912 = t1483_lanes[1] + t1569_lanes[3] * t1539_lanes[3] + t1579_lanes[3] *
      t1571_lanes[3] + t1614_lanes[3] * t1610_lanes[3] + t1654_lanes[3] * t1645_lanes[3];
  const Lanes<8> t1914_lanes = t1909_lanes * t1883;
  const Real t1915 = t1896 + t1614_lanes[2] * t1610_lanes[2] + t1654_lanes[2] * t1645_lanes[2] +
      t1697_lanes[2] * t1694_lanes[2] + t1725_lanes[2] * t1711_lanes[2];
  const Real t1916 = t1897 + t1439_lanes[3] * t1435_lanes[2] + t1453_lanes[3] * t1448_lanes[2] +
      t1569_lanes[3] * t1539_lanes[2] + t1579_lanes[3] * t1571_lanes[2];
  const Real t1918 = t1461_lanes[3] * t1392_lanes[1] - t1392_lanes[3] - t1536_lanes[3] * t1907;

  // link 1 (calf), force propagation
  const Real t1919 = t1651 - t1703_lanes[7] * t1640_lanes[7] - t1834 * t1732_lanes[7] - t1906 *
      t1851;
  const Lanes<8> t1923_lanes = t1908_lanes - t1859_lanes * t1850_lanes[1] - t1880_lanes *
      t1874_lanes[1] - t1898_lanes * t1891_lanes[1];
  const Real t1924 = t1919 * t1919;
  const Lanes<8> t1925_lanes = t1910_lanes - t1914_lanes * t1851;
  const Real t1928 = t1461_lanes[4] * t1392_lanes[1] - t1392_lanes[4] - t1536_lanes[4] * t1907 -
      t1618_lanes[4] * t1918;
  const Real t1929 = t1924 * t1919;
  const Real t1930 = t1915 - t1763_lanes[2] * t1752_lanes[2] - t1801_lanes[2] * t1789_lanes[2] -
      t1833_lanes[2] * t1824_lanes[2] - t1859_lanes[2] * t1850_lanes[2];
  const Real t1931 = t1912 + t1697_lanes[3] * t1694_lanes[3] + t1725_lanes[3] * t1711_lanes[3] -
      t1763_lanes[3] * t1752_lanes[3] - t1801_lanes[3] * t1789_lanes[3];
  const Real t1932 = t1916 + t1614_lanes[3] * t1610_lanes[2] + t1654_lanes[3] * t1645_lanes[2] +
      t1697_lanes[3] * t1694_lanes[2] + t1725_lanes[3] * t1711_lanes[2];
  const Real t1933 = t1461_lanes[5] * t1392_lanes[1] - t1392_lanes[5] - t1536_lanes[5] * t1907 -
      t1618_lanes[5] * t1918 - t1703_lanes[5] * t1928;
  const Real t1934 = t1461_lanes[6] * t1392_lanes[1] - t1392_lanes[6] - t1536_lanes[6] * t1907 -
      t1618_lanes[6] * t1918 - t1703_lanes[6] * t1928;
  const Real t1935 = t1461_lanes[7] * t1392_lanes[1] - t1392_lanes[7] - t1536_lanes[7] * t1907 -
      t1618_lanes[7] * t1918 - t1703_lanes[7] * t1928;
  const Real t1936 = t1929 * t1924 / (8.077935669463161e-28 + t1929 * t1929);
  const Real t1937 = t1801_lanes[0] * t1392_lanes[1] - t1763_lanes[0] - t1833_lanes[0] * t1907 -
      t1859_lanes[0] * t1918 - t1880_lanes[0] * t1928;
  const Real t1938 = t1934 - t1832 * t1933;
  const Real t1939 = t1931 - t1833_lanes[3] * t1824_lanes[3] - t1859_lanes[3] * t1850_lanes[3] -
      t1880_lanes[3] * t1874_lanes[3] - t1898_lanes[3] * t1891_lanes[3];
  const Real t1940 = t1392_lanes[1] * t1443;
  const Real t1941 = t1801_lanes[1] * t1392_lanes[1] - t1763_lanes[1] - t1833_lanes[1] * t1907 -
      t1859_lanes[1] * t1918 - t1880_lanes[1] * t1928;
  const Real t1942 = t1932 - t1763_lanes[3] * t1752_lanes[2] - t1801_lanes[3] * t1789_lanes[2] -
      t1833_lanes[3] * t1824_lanes[2] - t1859_lanes[3] * t1850_lanes[2];
  const Real t1943 = t1907 * t1521;
  const Real t1944 = t1801_lanes[2] * t1392_lanes[1] - t1763_lanes[2] - t1833_lanes[2] * t1907 -
      t1859_lanes[2] * t1918 - t1880_lanes[2] * t1928;
  const Real t1945 = t1935 - t1834 * t1933 - t1906 * t1938;
  const Real t1946 = t1536_lanes[3] * t1461_lanes[2] - t1461_lanes[3];
  const Real t1947 = t1918 * t1586;
  const Lanes<8> t1948_lanes = t1925_lanes * t1936;
  const Real t1949 = t1801_lanes[3] * t1392_lanes[1] - t1763_lanes[3] - t1833_lanes[3] * t1907 -
      t1859_lanes[3] * t1918 - t1880_lanes[3] * t1928;
  const Real t1950 = t1928 * t1689;
  const Real t1953 = t1536_lanes[4] * t1461_lanes[2] - t1461_lanes[4] - t1618_lanes[4] * t1946;
  const Lanes<8> t1954_lanes = t1911_lanes - t1914_lanes * t1909_lanes[0] - t1948_lanes *
      t1925_lanes[0];
  const Real t1956 = t1930 - t1880_lanes[2] * t1874_lanes[2] - t1898_lanes[2] * t1891_lanes[2] -
      t1914_lanes[2] * t1909_lanes[2] - t1948_lanes[2] * t1925_lanes[2];
  const Real t1957 = t1942 - t1880_lanes[3] * t1874_lanes[2] - t1898_lanes[3] * t1891_lanes[2] -
      t1914_lanes[3] * t1909_lanes[2] - t1948_lanes[3] * t1925_lanes[2];
  const Real t1958 = t1954_lanes[0] * t1954_lanes[0];
  const Real t1959 = t1536_lanes[5] * t1461_lanes[2] - t1461_lanes[5] - t1618_lanes[5] * t1946 -
      t1703_lanes[5] * t1953;
  const Real t1960 = t1937 - t1898_lanes[0] * t1933 - t1914_lanes[0] * t1938 - t1948_lanes[0] *
      t1945;
  const Real t1961 = t1958 * t1954_lanes[0];
  const Real t1962 = t1933 * t1793;
  const Real t1963 = t1959 * t1793;
  const Real t1964 = t1536_lanes[6] * t1461_lanes[2] - t1461_lanes[6] - t1618_lanes[6] * t1946 -
      t1703_lanes[6] * t1953 - t1832 * t1959;
  const Real t1965 = t1536_lanes[7] * t1461_lanes[2] - t1461_lanes[7] - t1618_lanes[7] * t1946 -
      t1703_lanes[7] * t1953 - t1834 * t1959;
  const Real t1966 = t1833_lanes[0] * t1461_lanes[2] - t1801_lanes[0] - t1859_lanes[0] * t1946 -
      t1880_lanes[0] * t1953 - t1898_lanes[0] * t1959;
  const Real t1967 = t1461_lanes[2] * t1521;
  const Real t1968 = t1833_lanes[1] * t1461_lanes[2] - t1801_lanes[1] - t1859_lanes[1] * t1946 -
      t1880_lanes[1] * t1953 - t1898_lanes[1] * t1959;
  const Real t1969 = t1946 * t1586;
  const Real t1970 = t1953 * t1689;
  const Real t1971 = t1833_lanes[2] * t1461_lanes[2] - t1801_lanes[2] - t1859_lanes[2] * t1946 -
      t1880_lanes[2] * t1953 - t1898_lanes[2] * t1959;
  const Real t1972 = t1938 * t1883;
  const Real t1973 = t1964 * t1883;
  const Real t1974 = t1961 * t1958 / (8.077935669463161e-28 + t1961 * t1961);
  const Real t1975 = t1965 - t1906 * t1964;
  const Real t1976 = t1618_lanes[4] * t1536_lanes[3] - t1536_lanes[4];
  const Real t1977 = t1833_lanes[3] * t1461_lanes[2] - t1801_lanes[3] - t1859_lanes[3] * t1946 -
      t1880_lanes[3] * t1953 - t1898_lanes[3] * t1959;
  const Real t1978 = t1372 + t1940 * t1392_lanes[1] + t1943 * t1907 + t1947 * t1918 + t1950 * t1928;
  const Real t1979 = t1966 - t1914_lanes[0] * t1964 - t1948_lanes[0] * t1975;
  const Real t1980 = t1618_lanes[5] * t1536_lanes[3] - t1536_lanes[5] - t1703_lanes[5] * t1976;
  const Real t1981 = t1945 * t1936;
  const Real t1982 = t1975 * t1936;
  const Lanes<8> t1983_lanes = t1954_lanes * t1974;
  const Real t1984 = t1969 * t1918 - (t1940 + t1967 * t1907) + t1970 * t1928 + t1963 * t1933;
  const Real t1985 = t1960 * t1974;
  const Real t1986 = t1618_lanes[6] * t1536_lanes[3] - t1536_lanes[6] - t1703_lanes[6] * t1976 -
      t1832 * t1980;
  const Real t1987 = t1979 * t1974;
  const Real t1989 = t1536_lanes[3] * t1586;
  const Real t1990 = t1976 * t1689;
  const Real t1991 = t1980 * t1793;
  const Lanes<8> t1992_lanes = t1923_lanes - t1914_lanes * t1909_lanes[1] - t1948_lanes *
      t1925_lanes[1] - t1983_lanes * t1954_lanes[1];
  const Real t1993 = t1618_lanes[7] * t1536_lanes[3] - t1536_lanes[7] - t1703_lanes[7] * t1976 -
      t1834 * t1980 - t1906 * t1986;
  const Real t1994 = t1859_lanes[0] * t1536_lanes[3] - t1833_lanes[0] - t1880_lanes[0] * t1976 -
      t1898_lanes[0] * t1980 - t1914_lanes[0] * t1986;
  const Real t1995 = t1859_lanes[1] * t1536_lanes[3] - t1833_lanes[1] - t1880_lanes[1] * t1976 -
      t1898_lanes[1] * t1980 - t1914_lanes[1] * t1986;
  const Real t1996 = t1859_lanes[2] * t1536_lanes[3] - t1833_lanes[2] - t1880_lanes[2] * t1976 -
      t1898_lanes[2] * t1980 - t1914_lanes[2] * t1986;
  const Real t1997 = t1992_lanes[1] * t1992_lanes[1];
  const Real t1998 = t1941 - t1898_lanes[1] * t1933 - t1914_lanes[1] * t1938 - t1948_lanes[1] *
      t1945 - t1983_lanes[1] * t1960;
  const Real t1999 = t1703_lanes[5] * t1618_lanes[4] - t1618_lanes[5];
  const Real t2000 = t1968 - t1914_lanes[1] * t1964 - t1948_lanes[1] * t1975 - t1983_lanes[1] *
      t1979;
  const Real t2001 = t1997 * t1992_lanes[1];
  const Real t2002 = t1986 * t1883;
  const Real t2003 = t1994 - t1948_lanes[0] * t1993;
  const Real t2004 = t1859_lanes[3] * t1536_lanes[3] - t1833_lanes[3] - t1880_lanes[3] * t1976 -
      t1898_lanes[3] * t1980 - t1914_lanes[3] * t1986;
  const Real t2005 = t1944 - t1898_lanes[2] * t1933 - t1914_lanes[2] * t1938 - t1948_lanes[2] *
      t1945 - t1983_lanes[2] * t1960;
  const Real t2006 = t1703_lanes[6] * t1618_lanes[4] - t1618_lanes[6] - t1832 * t1999;
  const Real t2007 = t1995 - t1948_lanes[1] * t1993 - t1983_lanes[1] * t2003;
  const Real t2008 = t2006 * t1883;
  const Real t2009 = t2001 * t1997 / (5.551115123125783e-17 + t2001 * t2001);
  const Real t2010 = t1999 * t1793;
  const Real t2011 = t1618_lanes[4] * t1689;
  const Real t2012 = t1703_lanes[7] * t1618_lanes[4] - t1618_lanes[7] - t1834 * t1999 - t1906 *
      t2006;
  const Real t2013 = t1993 * t1936;
  const Real t2014 = t2012 * t1936;
  const Real t2015 = t1949 - t1898_lanes[3] * t1933 - t1914_lanes[3] * t1938 - t1948_lanes[3] *
      t1945 - t1983_lanes[3] * t1960;
  const Real t2016 = t1832 * t1703_lanes[5] - t1703_lanes[6];
  const Real t2017 = t2003 * t1974;
  const Real t2018 = t1880_lanes[0] * t1618_lanes[4] - t1859_lanes[0] - t1898_lanes[0] * t1999 -
      t1914_lanes[0] * t2006 - t1948_lanes[0] * t2012;
  const Real t2019 = t1880_lanes[1] * t1618_lanes[4] - t1859_lanes[1] - t1898_lanes[1] * t1999 -
      t1914_lanes[1] * t2006 - t1948_lanes[1] * t2012;
  const Real t2020 = t1880_lanes[2] * t1618_lanes[4] - t1859_lanes[2] - t1898_lanes[2] * t1999 -
      t1914_lanes[2] * t2006 - t1948_lanes[2] * t2012;
  const Real t2021 = t1880_lanes[3] * t1618_lanes[4] - t1859_lanes[3] - t1898_lanes[3] * t1999 -
      t1914_lanes[3] * t2006 - t1948_lanes[3] * t2012;
  const Real t2022 = t2018 * t1974;
  const Real t2023 = t1992_lanes[2] * t2009;
  const Real t2024 = t1992_lanes[3] * t2009;
  const Real t2025 = t1834 * t1703_lanes[5] - t1703_lanes[7] - t1906 * t2016;
  const Real t2026 = t2019 - t1983_lanes[1] * t2018;
  const Real t2027 = t1943 - t1989 * t1918 + t1990 * t1928 + t1991 * t1933 + t2002 * t1938;
  const Real t2028 = t2016 * t1883;
  const Real t2029 = t1703_lanes[5] * t1793;
  const Real t2030 = t1956 - t1983_lanes[2] * t1954_lanes[2] - t2023 * t1992_lanes[2];
  const Real t2031 = t1957 - t1983_lanes[3] * t1954_lanes[2] - t2024 * t1992_lanes[2];
  const Real t2032 = t1939 - t1914_lanes[3] * t1909_lanes[3] - t1948_lanes[3] * t1925_lanes[3] -
      t1983_lanes[3] * t1954_lanes[3] - t2024 * t1992_lanes[3];
  const Real t2033 = t1898_lanes[0] * t1703_lanes[5] - t1880_lanes[0] - t1914_lanes[0] * t2016 -
      t1948_lanes[0] * t2025;
  const Real t2034 = t1906 * t1832 - t1834;
  const Real t2035 = t2025 * t1936;
  const Real t2036 = t2030 * t2030;
  const Real t2037 = t2005 - t2023 * t1998;
  const Real t2038 = t1971 - t1914_lanes[2] * t1964 - t1948_lanes[2] * t1975 - t1983_lanes[2] *
      t1979 - t2023 * t2000;
  const Real t2039 = t1996 - t1948_lanes[2] * t1993 - t1983_lanes[2] * t2003 - t2023 * t2007;
  const Real t2040 = t2036 * t2030;
  const Real t2041 = t1898_lanes[1] * t1703_lanes[5] - t1880_lanes[1] - t1914_lanes[1] * t2016 -
      t1948_lanes[1] * t2025 - t1983_lanes[1] * t2033;
  const Real t2042 = t1832 * t1883;
  const Real t2043 = t1914_lanes[0] * t1832 - t1898_lanes[0] - t1948_lanes[0] * t2034;
  const Real t2044 = t1898_lanes[2] * t1703_lanes[5] - t1880_lanes[2] - t1914_lanes[2] * t2016 -
      t1948_lanes[2] * t2025 - t1983_lanes[2] * t2033;
  const Real t2045 = t2034 * t1936;
  const Real t2046 = t2020 - t1983_lanes[2] * t2018 - t2023 * t2026;
  const Real t2047 = t1948_lanes[0] * t1906 - t1914_lanes[0];
  const Real t2048 = t2044 - t2023 * t2041;
  const Real t2049 = t1898_lanes[3] * t1703_lanes[5] - t1880_lanes[3] - t1914_lanes[3] * t2016 -
      t1948_lanes[3] * t2025 - t1983_lanes[3] * t2033;
  const Real t2050 = t2033 * t1974;
  const Real t2051 = t1914_lanes[1] * t1832 - t1898_lanes[1] - t1948_lanes[1] * t2034 -
      t1983_lanes[1] * t2043;
  const Real t2052 = t2043 * t1974;
  const Real t2053 = t1906 * t1936;
  const Real t2054 = t2047 * t1974;
  const Real t2055 = t2040 * t2036 / (5.551115123125783e-17 + t2040 * t2040);
  const Real t2056 = t1948_lanes[1] * t1906 - t1914_lanes[1] - t1983_lanes[1] * t2047;
  const Real t2057 = t1983_lanes[1] * t1948_lanes[0] - t1948_lanes[1];
  const Real t2058 = t1914_lanes[2] * t1832 - t1898_lanes[2] - t1948_lanes[2] * t2034 -
      t1983_lanes[2] * t2043 - t2023 * t2051;
  const Real t2059 = t1998 * t2009;
  const Real t2060 = t1977 - t1914_lanes[3] * t1964 - t1948_lanes[3] * t1975 - t1983_lanes[3] *
      t1979 - t2024 * t2000;
  const Real t2061 = t1948_lanes[0] * t1974;
  const Real t2062 = t2000 * t2009;
  const Real t2063 = t2007 * t2009;
  const Real t2064 = t2026 * t2009;
  const Real t2065 = t2041 * t2009;
  const Real t2066 = t1948_lanes[2] * t1906 - t1914_lanes[2] - t1983_lanes[2] * t2047 - t2023 *
      t2056;
  const Real t2067 = t1914_lanes[3] * t1832 - t1898_lanes[3] - t1948_lanes[3] * t2034 -
      t1983_lanes[3] * t2043 - t2024 * t2051;
  const Real t2068 = t2051 * t2009;
  const Real t2069 = t2023 * t1983_lanes[1] - t1983_lanes[2];
  const Real t2070 = t2056 * t2009;
  const Real t2071 = t2057 * t2009;
  const Real t2072 = t1983_lanes[1] * t2009;
  const Real t2073 = t1983_lanes[2] * t1948_lanes[0] - t1948_lanes[2] - t2023 * t2057;
  const Real t2074 = t2031 * t2055;
  const Real t2075 = t1947 - t2011 * t1928 + t2010 * t1933 + t2008 * t1938 + t2014 * t1945;
  const Real t2076 = t2032 - t2074 * t2031;
  const Real t2077 = t2015 - t2024 * t1998 - t2074 * t2037;
  const Real t2078 = t2037 * t2055;
  const Real t2079 = t2060 - t2074 * t2038;
  const Real t2080 = t2076 * t2076;
  const Real t2081 = t2038 * t2055;
  const Real t2082 = t2004 - t1948_lanes[3] * t1993 - t1983_lanes[3] * t2003 - t2024 * t2007 -
      t2074 * t2039;
  const Real t2083 = t2039 * t2055;
  const Real t2084 = t2021 - t1983_lanes[3] * t2018 - t2024 * t2026 - t2074 * t2046;
  const Real t2085 = t2046 * t2055;
  const Real t2086 = t2049 - t2024 * t2041 - t2074 * t2048;
  const Real t2087 = t2048 * t2055;
  const Real t2088 = t2080 * t2076;
  const Real t2089 = t1443 + t1967 * t1461_lanes[2] + t1969 * t1946 + t1970 * t1953 + t1963 * t1959;
  const Real t2090 = t2067 - t2074 * t2058;
  const Real t2091 = t2058 * t2055;
  const Real t2092 = t1948_lanes[3] * t1906 - t1914_lanes[3] - t1983_lanes[3] * t2047 - t2024 *
      t2056 - t2074 * t2066;
  const Real t2093 = t2066 * t2055;
  const Real t2094 = t1983_lanes[3] * t1948_lanes[0] - t1948_lanes[3] - t2024 * t2057 - t2074 *
      t2073;
  const Real t2095 = t2073 * t2055;
  const Real t2096 = t2024 * t1983_lanes[1] - t1983_lanes[3] - t2074 * t2069;
  const Real t2097 = t1990 * t1953 - (t1967 + t1989 * t1946) + t1991 * t1959 + t2002 * t1964;
  const Real t2098 = t2069 * t2055;
  const Real t2099 = t2074 * t2023 - t2024;
  const Real t2100 = t2023 * t2055;
  const Real t2101 = t1969 - t2011 * t1953 + t2010 * t1959 + t2008 * t1964 + t2014 * t1975;
  const Real Lambda_11_11 = t2088 * t2080 / (8.673617379884035e-19 + t2088 * t2088);
  Lambda[143] = Lambda_11_11;
  const Real t2102 = t1978 + t1962 * t1933 + t1972 * t1938 + t1981 * t1945 + t1985 * t1960;
  const Real t2103 = t1950 - t2029 * t1933 + t2028 * t1938 + t2035 * t1945 + t2050 * t1960;
  const Real t2104 = t1970 - t2029 * t1959 + t2028 * t1964 + t2035 * t1975 + t2050 * t1979;
  const Real Lambda_0_11 = t2077 * Lambda_11_11;
  Lambda[11] = Lambda_0_11;
  Lambda[132] = Lambda_0_11;
  const Real Lambda_1_11 = t2079 * Lambda_11_11;
  Lambda[23] = Lambda_1_11;
  Lambda[133] = Lambda_1_11;
  const Real Lambda_2_11 = t2082 * Lambda_11_11;
  Lambda[35] = Lambda_2_11;
  Lambda[134] = Lambda_2_11;
  const Real Lambda_3_11 = t2084 * Lambda_11_11;
  Lambda[47] = Lambda_3_11;
  Lambda[135] = Lambda_3_11;
  const Real Lambda_4_11 = t2086 * Lambda_11_11;
  Lambda[59] = Lambda_4_11;
  Lambda[136] = Lambda_4_11;
  const Real t2105 = t1521 + t1989 * t1536_lanes[3] + t1990 * t1976 + t1991 * t1980 + t2002 * t1986;
  const Real Lambda_5_11 = t2090 * Lambda_11_11;
  Lambda[71] = Lambda_5_11;
  Lambda[137] = Lambda_5_11;
  const Real Lambda_6_11 = t2092 * Lambda_11_11;
  Lambda[83] = Lambda_6_11;
  Lambda[138] = Lambda_6_11;
  const Real Lambda_7_11 = t2094 * Lambda_11_11;
  Lambda[95] = Lambda_7_11;
  Lambda[139] = Lambda_7_11;
  const Real Lambda_8_11 = t2096 * Lambda_11_11;
  Lambda[107] = Lambda_8_11;
  Lambda[140] = Lambda_8_11;
  const Real Lambda_9_11 = t2099 * Lambda_11_11;
  Lambda[119] = Lambda_9_11;
  Lambda[141] = Lambda_9_11;
  const Real Lambda_10_11 = t2074 * Lambda_11_11;
  Lambda[131] = -Lambda_10_11;
  Lambda[142] = -Lambda_10_11;
  const Real t2106 = t2010 * t1980 - (t1989 + t2011 * t1976) + t2008 * t1986 + t2014 * t1993;
  const Real t2107 = t1990 - t2029 * t1980 + t2028 * t1986 + t2035 * t1993 + t2050 * t2003;
  const Real t2108 = t1984 + t1973 * t1938 + t1982 * t1945 + t1987 * t1960 + t2062 * t1998;
  const Real t2109 = t1962 - t2042 * t1938 + t2045 * t1945 + t2052 * t1960 + t2068 * t1998;
  const Real t2110 = t1586 + t2011 * t1618_lanes[4] + t2010 * t1999 + t2008 * t2006 + t2014 * t2012;
  const Real t2111 = t2089 + t1973 * t1964 + t1982 * t1975 + t1987 * t1979 + t2062 * t2000;
  const Real t2112 = t1963 - t2042 * t1964 + t2045 * t1975 + t2052 * t1979 + t2068 * t2000;
  const Real t2113 = t2028 * t2006 - (t2011 + t2029 * t1999) + t2035 * t2012 + t2050 * t2018;
  const Real t2114 = t1991 - t2042 * t1986 + t2045 * t1993 + t2052 * t2003 + t2068 * t2007;
  const Real t2115 = t2010 - t2042 * t2006 + t2045 * t2012 + t2052 * t2018 + t2068 * t2026;
  const Real t2116 = t1689 + t2029 * t1703_lanes[5] + t2028 * t2016 + t2035 * t2025 + t2050 * t2033;
  const Real t2117 = t2045 * t2025 - (t2029 + t2042 * t2016) + t2052 * t2033 + t2068 * t2041;
  const Real t2118 = t1793 + t2042 * t1832 + t2045 * t2034 + t2052 * t2043 + t2068 * t2051;
  const Real t2119 = t2027 + t2013 * t1945 + t2017 * t1960 + t2063 * t1998 + t2083 * t2037;
  const Real t2120 = t1972 - t2053 * t1945 + t2054 * t1960 + t2070 * t1998 + t2093 * t2037;
  const Real t2121 = t2097 + t2013 * t1975 + t2017 * t1979 + t2063 * t2000 + t2083 * t2038;
  const Real t2122 = t1973 - t2053 * t1975 + t2054 * t1979 + t2070 * t2000 + t2093 * t2038;
  const Real t2123 = t2105 + t2013 * t1993 + t2017 * t2003 + t2063 * t2007 + t2083 * t2039;
  const Real t2124 = t2002 - t2053 * t1993 + t2054 * t2003 + t2070 * t2007 + t2093 * t2039;
  const Real t2125 = t2008 - t2053 * t2012 + t2054 * t2018 + t2070 * t2026 + t2093 * t2046;
  const Real t2126 = t2028 - t2053 * t2025 + t2054 * t2033 + t2070 * t2041 + t2093 * t2048;
  const Real t2127 = t2054 * t2043 - (t2042 + t2053 * t2034) + t2070 * t2051 + t2093 * t2058;
  const Real t2128 = t1883 + t2053 * t1906 + t2054 * t2047 + t2070 * t2056 + t2093 * t2066;
  Lambda[0] = t2102 + t2059 * t1998 + t2078 * t2037 + Lambda_0_11 * t2077;
  const Real Lambda_0_1 = t2108 + t2081 * t2037 + Lambda_1_11 * t2077;
  Lambda[1] = Lambda_0_1;
  Lambda[12] = Lambda_0_1;
  const Real Lambda_0_2 = t2119 + Lambda_2_11 * t2077;
  Lambda[2] = Lambda_0_2;
  Lambda[24] = Lambda_0_2;
  const Real Lambda_0_3 = t2075 + t2022 * t1960 + t2064 * t1998 + t2085 * t2037 + Lambda_3_11 *
      t2077;
  Lambda[3] = Lambda_0_3;
  Lambda[36] = Lambda_0_3;
  const Real Lambda_0_4 = t2103 + t2065 * t1998 + t2087 * t2037 + Lambda_4_11 * t2077;
  Lambda[4] = Lambda_0_4;
  Lambda[48] = Lambda_0_4;
  const Real Lambda_0_5 = t2109 + t2091 * t2037 + Lambda_5_11 * t2077;
  Lambda[5] = Lambda_0_5;
  Lambda[60] = Lambda_0_5;
  const Real Lambda_0_6 = t2120 + Lambda_6_11 * t2077;
  Lambda[6] = Lambda_0_6;
  Lambda[72] = Lambda_0_6;
  const Real Lambda_0_7 = t1981 - t2061 * t1960 + t2071 * t1998 + t2095 * t2037 + Lambda_7_11 *
      t2077;
  Lambda[7] = Lambda_0_7;
  Lambda[84] = Lambda_0_7;
  const Real Lambda_0_8 = t1985 - t2072 * t1998 + t2098 * t2037 + Lambda_8_11 * t2077;
  Lambda[8] = Lambda_0_8;
  Lambda[96] = Lambda_0_8;
  const Real Lambda_0_9 = t2059 - t2100 * t2037 + Lambda_9_11 * t2077;
  Lambda[9] = Lambda_0_9;
  Lambda[108] = Lambda_0_9;
  const Real Lambda_0_10 = t2078 - Lambda_10_11 * t2077;
  Lambda[10] = Lambda_0_10;
  Lambda[120] = Lambda_0_10;
  Lambda[13] = t2111 + t2081 * t2038 + Lambda_1_11 * t2079;
  const Real Lambda_1_2 = t2121 + Lambda_2_11 * t2079;
  Lambda[14] = Lambda_1_2;
  Lambda[25] = Lambda_1_2;
  const Real Lambda_1_3 = t2101 + t2022 * t1979 + t2064 * t2000 + t2085 * t2038 + Lambda_3_11 *
      t2079;
  Lambda[15] = Lambda_1_3;
  Lambda[37] = Lambda_1_3;
  const Real Lambda_1_4 = t2104 + t2065 * t2000 + t2087 * t2038 + Lambda_4_11 * t2079;
  Lambda[16] = Lambda_1_4;
  Lambda[49] = Lambda_1_4;
  const Real Lambda_1_5 = t2112 + t2091 * t2038 + Lambda_5_11 * t2079;
  Lambda[17] = Lambda_1_5;
  Lambda[61] = Lambda_1_5;
  const Real Lambda_1_6 = t2122 + Lambda_6_11 * t2079;
  Lambda[18] = Lambda_1_6;
  Lambda[73] = Lambda_1_6;
  const Real Lambda_1_7 = t1982 - t2061 * t1979 + t2071 * t2000 + t2095 * t2038 + Lambda_7_11 *
      t2079;
  Lambda[19] = Lambda_1_7;
  Lambda[85] = Lambda_1_7;
  const Real Lambda_1_8 = t1987 - t2072 * t2000 + t2098 * t2038 + Lambda_8_11 * t2079;
  Lambda[20] = Lambda_1_8;
  Lambda[97] = Lambda_1_8;
  const Real Lambda_1_9 = t2062 - t2100 * t2038 + Lambda_9_11 * t2079;
  Lambda[21] = Lambda_1_9;
  Lambda[109] = Lambda_1_9;
  const Real Lambda_1_10 = t2081 - Lambda_10_11 * t2079;
  Lambda[22] = Lambda_1_10;
  Lambda[121] = Lambda_1_10;
  Lambda[26] = t2123 + Lambda_2_11 * t2082;
  const Real Lambda_2_3 = t2106 + t2022 * t2003 + t2064 * t2007 + t2085 * t2039 + Lambda_3_11 *
      t2082;
  Lambda[27] = Lambda_2_3;
  Lambda[38] = Lambda_2_3;
  const Real Lambda_2_4 = t2107 + t2065 * t2007 + t2087 * t2039 + Lambda_4_11 * t2082;
  Lambda[28] = Lambda_2_4;
  Lambda[50] = Lambda_2_4;
  const Real Lambda_2_5 = t2114 + t2091 * t2039 + Lambda_5_11 * t2082;
  Lambda[29] = Lambda_2_5;
  Lambda[62] = Lambda_2_5;
  const Real Lambda_2_6 = t2124 + Lambda_6_11 * t2082;
  Lambda[30] = Lambda_2_6;
  Lambda[74] = Lambda_2_6;
  const Real Lambda_2_7 = t2013 - t2061 * t2003 + t2071 * t2007 + t2095 * t2039 + Lambda_7_11 *
      t2082;
  Lambda[31] = Lambda_2_7;
  Lambda[86] = Lambda_2_7;
  const Real Lambda_2_8 = t2017 - t2072 * t2007 + t2098 * t2039 + Lambda_8_11 * t2082;
  Lambda[32] = Lambda_2_8;
  Lambda[98] = Lambda_2_8;
  const Real Lambda_2_9 = t2063 - t2100 * t2039 + Lambda_9_11 * t2082;
  Lambda[33] = Lambda_2_9;
  Lambda[110] = Lambda_2_9;
  const Real Lambda_2_10 = t2083 - Lambda_10_11 * t2082;
  Lambda[34] = Lambda_2_10;
  Lambda[122] = Lambda_2_10;
  Lambda[39] = t2110 + t2022 * t2018 + t2064 * t2026 + t2085 * t2046 + Lambda_3_11 * t2084;
  const Real Lambda_3_4 = t2113 + t2065 * t2026 + t2087 * t2046 + Lambda_4_11 * t2084;
  Lambda[40] = Lambda_3_4;
  Lambda[51] = Lambda_3_4;
  const Real Lambda_3_5 = t2115 + t2091 * t2046 + Lambda_5_11 * t2084;
  Lambda[41] = Lambda_3_5;
  Lambda[63] = Lambda_3_5;
  const Real Lambda_3_6 = t2125 + Lambda_6_11 * t2084;
  Lambda[42] = Lambda_3_6;
  Lambda[75] = Lambda_3_6;
  const Real Lambda_3_7 = t2014 - t2061 * t2018 + t2071 * t2026 + t2095 * t2046 + Lambda_7_11 *
      t2084;
  Lambda[43] = Lambda_3_7;
  Lambda[87] = Lambda_3_7;
  const Real Lambda_3_8 = t2022 - t2072 * t2026 + t2098 * t2046 + Lambda_8_11 * t2084;
  Lambda[44] = Lambda_3_8;
  Lambda[99] = Lambda_3_8;
  const Real Lambda_3_9 = t2064 - t2100 * t2046 + Lambda_9_11 * t2084;
  Lambda[45] = Lambda_3_9;
  Lambda[111] = Lambda_3_9;
  const Real Lambda_3_10 = t2085 - Lambda_10_11 * t2084;
  Lambda[46] = Lambda_3_10;
  Lambda[123] = Lambda_3_10;
  Lambda[52] = t2116 + t2065 * t2041 + t2087 * t2048 + Lambda_4_11 * t2086;
  const Real Lambda_4_5 = t2117 + t2091 * t2048 + Lambda_5_11 * t2086;
  Lambda[53] = Lambda_4_5;
  Lambda[64] = Lambda_4_5;
  const Real Lambda_4_6 = t2126 + Lambda_6_11 * t2086;
  Lambda[54] = Lambda_4_6;
  Lambda[76] = Lambda_4_6;
  const Real Lambda_4_7 = t2035 - t2061 * t2033 + t2071 * t2041 + t2095 * t2048 + Lambda_7_11 *
      t2086;
  Lambda[55] = Lambda_4_7;
  Lambda[88] = Lambda_4_7;
  const Real Lambda_4_8 = t2050 - t2072 * t2041 + t2098 * t2048 + Lambda_8_11 * t2086;
  Lambda[56] = Lambda_4_8;
  Lambda[100] = Lambda_4_8;
  const Real Lambda_4_9 = t2065 - t2100 * t2048 + Lambda_9_11 * t2086;
  Lambda[57] = Lambda_4_9;
  Lambda[112] = Lambda_4_9;
  const Real Lambda_4_10 = t2087 - Lambda_10_11 * t2086;
  Lambda[58] = Lambda_4_10;
  Lambda[124] = Lambda_4_10;
  Lambda[65] = t2118 + t2091 * t2058 + Lambda_5_11 * t2090;
  const Real Lambda_5_6 = t2127 + Lambda_6_11 * t2090;
  Lambda[66] = Lambda_5_6;
  Lambda[77] = Lambda_5_6;
  const Real Lambda_5_7 = t2045 - t2061 * t2043 + t2071 * t2051 + t2095 * t2058 + Lambda_7_11 *
      t2090;
  Lambda[67] = Lambda_5_7;
  Lambda[89] = Lambda_5_7;
  const Real Lambda_5_8 = t2052 - t2072 * t2051 + t2098 * t2058 + Lambda_8_11 * t2090;
  Lambda[68] = Lambda_5_8;
  Lambda[101] = Lambda_5_8;
  const Real Lambda_5_9 = t2068 - t2100 * t2058 + Lambda_9_11 * t2090;
  Lambda[69] = Lambda_5_9;
  Lambda[113] = Lambda_5_9;
  const Real Lambda_5_10 = t2091 - Lambda_10_11 * t2090;
  Lambda[70] = Lambda_5_10;
  Lambda[125] = Lambda_5_10;
  Lambda[78] = t2128 + Lambda_6_11 * t2092;
  const Real Lambda_6_7 = t2071 * t2056 - (t2053 + t2061 * t2047) + t2095 * t2066 + Lambda_7_11 *
      t2092;
  Lambda[79] = Lambda_6_7;
  Lambda[90] = Lambda_6_7;
  const Real Lambda_6_8 = t2054 - t2072 * t2056 + t2098 * t2066 + Lambda_8_11 * t2092;
  Lambda[80] = Lambda_6_8;
  Lambda[102] = Lambda_6_8;
  const Real Lambda_6_9 = t2070 - t2100 * t2066 + Lambda_9_11 * t2092;
  Lambda[81] = Lambda_6_9;
  Lambda[114] = Lambda_6_9;
  const Real Lambda_6_10 = t2093 - Lambda_10_11 * t2092;
  Lambda[82] = Lambda_6_10;
  Lambda[126] = Lambda_6_10;
  Lambda[91] = t1936 + t2061 * t1948_lanes[0] + t2071 * t2057 + t2095 * t2073 + Lambda_7_11 * t2094;
  const Real Lambda_7_8 = t2098 * t2073 - (t2061 + t2072 * t2057) + Lambda_8_11 * t2094;
  Lambda[92] = Lambda_7_8;
  Lambda[103] = Lambda_7_8;
  const Real Lambda_7_9 = t2071 - t2100 * t2073 + Lambda_9_11 * t2094;
  Lambda[93] = Lambda_7_9;
  Lambda[115] = Lambda_7_9;
  const Real Lambda_7_10 = t2095 - Lambda_10_11 * t2094;
  Lambda[94] = Lambda_7_10;
  Lambda[127] = Lambda_7_10;
  Lambda[104] = t1974 + t2072 * t1983_lanes[1] + t2098 * t2069 + Lambda_8_11 * t2096;
  const Real Lambda_8_9 = Lambda_9_11 * t2096 - (t2072 + t2100 * t2069);
  Lambda[105] = Lambda_8_9;
  Lambda[116] = Lambda_8_9;
  const Real Lambda_8_10 = t2098 - Lambda_10_11 * t2096;
  Lambda[106] = Lambda_8_10;
  Lambda[128] = Lambda_8_10;
  Lambda[117] = t2009 + t2100 * t2023 + Lambda_9_11 * t2099;
  const Real Lambda_9_10 = t2100 + Lambda_10_11 * t2099;
  Lambda[118] = -Lambda_9_10;
  Lambda[129] = -Lambda_9_10;
  Lambda[130] = t2055 + Lambda_10_11 * t2074;
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
