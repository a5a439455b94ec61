// SPDX-License-Identifier: 0BSD
// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in
//   lanes.
// 6251 flops (add 2644, mul 3575, div 32), sine and cosine of 24 angles
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
void lambda_inverse(const Real (&TREELINE_RESTRICT q)[24],
    Real (&TREELINE_RESTRICT Lambda_inv)[144]) noexcept {
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

  // links 7, 10, 14, force propagation; link 16 (right_upperarm), pose
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
  const Real t1092 = s16 * t872_lanes[1] + c16 * t864_lanes[1];
  const Lanes<8> t1093_lanes = detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      t1071_lanes + detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * t1072_lanes;
  const Real t1095 = c16 * t872_lanes[1] - s16 * t864_lanes[1];
  const Lanes<8> t1096_lanes = detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      t1071_lanes - detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * t1072_lanes;
  const Lanes<8> t1102_lanes = t1070_lanes * t916_lanes[0] + t1068_lanes * t926_lanes[0] +
      t1066_lanes * t954_lanes[0] + t1078_lanes;

  // links 17 (right_lowerarm) and 18 (right_wrist1), pose; links 7 (left_shoulder1) and 14
  //   (right_shoulder1), force propagation
  const Real t1103 = c17 * t1092 + s17 * t873_lanes[1];
  const Real t1104 = c17 * t873_lanes[1] - s17 * t1092;
  const Lanes<8> t1105_lanes = 0.226 * t1073_lanes +
      detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18), (-0.18)) * t1093_lanes;
  const Real t1110 = c18 * t1103 + s18 * t1095;
  const Real t1111 = c18 * t1095 - s18 * t1103;

  // links 6 (chest3) and 7 (left_shoulder1), force propagation
  const Lanes<8> t1112_lanes = -(detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) *
      t1063_lanes + detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) * t1074_lanes +
      t1105_lanes);
  const Lanes<8> t1113_lanes = t674 * t1112_lanes;
  const Real t1118 = t1112_lanes[7] * inverse_D6;
  const Real t1119 = t1112_lanes[6] * inverse_D6;
  const Lanes<8> t1120_lanes = t1112_lanes * inverse_D6;
  const Lanes<8> t1121_lanes = t1102_lanes + t1065_lanes * t1007_lanes[0] + t1067_lanes *
      t1034_lanes[0] + t1069_lanes * t1055_lanes[0];
  const Lanes<8> t1122_lanes = detail::make_pack<Real>(0.18, 0.18, 0.18, 0.18, 0.18, 0.18, (-0.18),
      (-0.18)) * t1096_lanes - (detail::make_pack<Real>(s7, s7, s7, s7, s7, s7, s14, s14) *
      t1063_lanes - detail::make_pack<Real>(c7, c7, c7, c7, c7, c7, c14, c14) * t1074_lanes) -
      t1113_lanes;
  const Lanes<8> t1123_lanes = 0.226 * t1096_lanes - t673 * t1112_lanes;

  // link 6 (chest3), force propagation; link 19 (right_wrist2), pose
  const Lanes<8> t1124_lanes = t1096_lanes - t672 * t1112_lanes;
  const Lanes<8> t1125_lanes = t1093_lanes + t675 * t1112_lanes;
  const Lanes<8> t1126_lanes = t1073_lanes - t676 * t1112_lanes;
  const Real t1128 = c19 * t1104 - s19 * t1110;
  const Real t1129 = c19 * t1110 + s19 * t1104;

  // links 6 (chest3) and 20 (right_hand), force propagation; link 1 (calf), articulated inertia
  const Lanes<8> t1139_lanes = t23_lanes[1] * detail::make_pack<Real>(t849, t849, t785, t1129, t849,
      t849, t849, t849);
  const Lanes<8> t1142_lanes = t1121_lanes + t1120_lanes * t1112_lanes[0];
  const Lanes<8> t1144_lanes = s6 * t1125_lanes + c6 * t1126_lanes;
  const Real t1146 = t755_lanes[1] * t1111 - t747_lanes[1] * t1128;
  const Lanes<8> t1147_lanes = s6 * t1122_lanes + c6 * t1123_lanes + minus_link5_to_6_y *
      t1124_lanes;

  // links 5, 19 and 20, force propagation
  const Lanes<8> t1148_lanes = -(t24_lanes[1] * detail::make_pack<Real>(t849, t849, t785, t1129,
      t849, t849, t849, t849));
  const Lanes<8> t1157_lanes = t1147_lanes * inverse_D5;
  const Lanes<8> t1159_lanes = detail::make_pack<Real>(-(t755_lanes[1] * t1129), t841, t780, t1111,
      -(t755_lanes[1] * t1129), -(t755_lanes[1] * t1129), -(t755_lanes[1] * t1129),
      -(t755_lanes[1] * t1129)) + t19_lanes[1] * detail::make_pack<Real>(t1146, t849, t785, t1129,
      t1146, t1146, t1146, t1146);
  const Lanes<8> t1161_lanes = c6 * t1125_lanes - s6 * t1126_lanes - t715 * t1147_lanes;
  const Lanes<8> t1162_lanes = t1124_lanes - t714 * t1147_lanes;
  const Lanes<8> t1163_lanes = c6 * t1122_lanes - s6 * t1123_lanes - t718 * t1147_lanes;
  const Lanes<8> t1164_lanes = -(minus_link5_to_6_y * t1144_lanes) + t717 * t1147_lanes;
  const Lanes<8> t1169_lanes = t48_lanes[1] * t1159_lanes;
  const Lanes<8> t1175_lanes = s4 * (t1144_lanes - t716 * t1147_lanes);

  // links 4 (chest1) and 19 (right_wrist2), force propagation
  const Lanes<8> t1181_lanes = detail::make_pack<Real>(t1128 + t23_lanes[1] * t1146, t1139_lanes[1],
      t1139_lanes[2], t1139_lanes[3], t1128 + t23_lanes[1] * t1146, t1128 + t23_lanes[1] * t1146,
      t1128 + t23_lanes[1] * t1146, t1128 + t23_lanes[1] * t1146) - t47_lanes[1] * t1159_lanes;
  const Real t1182 = t1129 + t48_lanes[1] * t1159_lanes[0];
  const Lanes<8> t1183_lanes = detail::make_pack<Real>(t747_lanes[1] * t1129, t848, t784, t1128,
      t747_lanes[1] * t1129, t747_lanes[1] * t1129, t747_lanes[1] * t1129, t747_lanes[1] * t1129) +
      t22_lanes[1] * detail::make_pack<Real>(t1146, t849, t785, t1129, t1146, t1146, t1146, t1146) -
      t46_lanes[1] * t1159_lanes;
  const Lanes<8> t1184_lanes = detail::make_pack<Real>(t1111 - t24_lanes[1] * t1146, t1148_lanes[1],
      t1148_lanes[2], t1148_lanes[3], t1111 - t24_lanes[1] * t1146, t1111 - t24_lanes[1] * t1146,
      t1111 - t24_lanes[1] * t1146, t1111 - t24_lanes[1] * t1146) - t49_lanes[1] * t1159_lanes;
  const Lanes<8> t1197_lanes = -(s5 * t1164_lanes + c5 * t1163_lanes);
  const Lanes<8> t1202_lanes = t1197_lanes * inverse_D4;
  const Lanes<8> t1203_lanes = s19 * t1181_lanes - c19 *
      detail::make_pack<Real>(t1182, t1169_lanes[1], t1169_lanes[2], t1169_lanes[3], t1182, t1182,
      t1182, t1182);

  // links 4 and 5, 18, force propagation
  const Lanes<8> t1204_lanes = -(c19 * t1183_lanes);
  const Lanes<8> t1212_lanes = c4 * (s5 * t1161_lanes - c5 * t1162_lanes) + t1175_lanes;
  const Lanes<8> t1214_lanes = -(s5 * t1162_lanes + c5 * t1161_lanes) - t773 * t1197_lanes;
  const Lanes<8> t1218_lanes = 0.269 * t1184_lanes - s19 * t1183_lanes - t124_lanes[1] *
      t1204_lanes;
  const Lanes<8> t1219_lanes = -t1203_lanes + t126_lanes[1] * t1204_lanes;
  const Lanes<8> t1221_lanes = t1184_lanes - t127_lanes[1] * t1204_lanes;
  const Lanes<8> t1222_lanes = -(s19 * detail::make_pack<Real>(t1182, t1169_lanes[1],
      t1169_lanes[2], t1169_lanes[3], t1182, t1182, t1182, t1182) + c19 * t1181_lanes) -
      t128_lanes[1] * t1204_lanes;
  const Lanes<8> t1227_lanes = 0.269 * t1203_lanes - t125_lanes[1] * t1204_lanes;
  const Lanes<8> t1236_lanes = s4 * (s5 * t1163_lanes - c5 * t1164_lanes) + link4_to_5_z *
      t1212_lanes;
  const Lanes<8> t1242_lanes = -t1236_lanes - t772 * t1197_lanes;
  const Lanes<8> t1243_lanes = s18 * t1218_lanes + c18 * t1227_lanes;

  // links 3 (hip) and 17 (right_lowerarm), force propagation
  const Lanes<8> t1247_lanes = t1242_lanes * inverse_D3;
  const Lanes<8> t1251_lanes = t208_lanes[1] * t1243_lanes;
  const Lanes<8> t1253_lanes = -t1212_lanes - t774 * t1197_lanes - t796 * t1242_lanes;
  const Lanes<8> t1254_lanes = -t1214_lanes + t795 * t1242_lanes;
  const Lanes<8> t1256_lanes = c18 * t1218_lanes - s18 * t1227_lanes - t210_lanes[1] * t1243_lanes;
  const Lanes<8> t1257_lanes = -t1222_lanes - t214_lanes[1] * t1243_lanes;
  const Lanes<8> t1258_lanes = c18 * t1219_lanes - s18 * t1221_lanes - t213_lanes[1] * t1243_lanes;
  const Lanes<8> t1261_lanes = s18 * t1219_lanes + c18 * t1221_lanes - t215_lanes[1] * t1243_lanes;
  const Lanes<8> t1266_lanes = detail::make_pack<Real>(t1142_lanes[0], t1142_lanes[1],
      t1142_lanes[2], t1142_lanes[3], t1142_lanes[4], t1142_lanes[5], t1119 * t1112_lanes[0],
      t1118 * t1112_lanes[0]) + t1157_lanes * t1147_lanes[0] + t1202_lanes * t1197_lanes[0] +
      t1247_lanes * t1242_lanes[0];
  const Lanes<8> t1275_lanes = c2_plus_3 * t1253_lanes - s2_plus_3 * t1254_lanes;
  const Lanes<8> t1276_lanes = c17 * t1251_lanes - s17 * t1256_lanes;
  const Lanes<8> t1277_lanes = s17 * t1257_lanes - c17 * t1258_lanes;

  // links 3 (hip) and 16 (right_upperarm), force propagation
  const Lanes<8> t1282_lanes = t308_lanes[1] * t1276_lanes;
  const Lanes<8> t1291_lanes = t738 * (s2_plus_3 * t1253_lanes + c2_plus_3 * t1254_lanes) + t736 *
      t1275_lanes;
  const Lanes<8> t1292_lanes = c17 * t1256_lanes + s17 * t1251_lanes + 0.282 * t1261_lanes -
      t1282_lanes;
  const Lanes<8> t1293_lanes = 0.282 * t1277_lanes - t309_lanes[1] * t1276_lanes;
  const Lanes<8> t1294_lanes = -t1277_lanes + t310_lanes[1] * t1276_lanes;

  // links 2 (thigh) and 16 (right_upperarm), force propagation
  const Lanes<8> t1295_lanes = t1261_lanes - t311_lanes[1] * t1276_lanes;
  const Lanes<8> t1296_lanes = -(s17 * t1258_lanes + c17 * t1257_lanes) + t312_lanes[1] *
      t1276_lanes;
  const Lanes<8> t1298_lanes = t1291_lanes * inverse_D2;
  const Lanes<8> t1310_lanes = c16 * t1292_lanes - s16 * t1293_lanes;
  const Lanes<8> t1314_lanes = minus_link1_to_2_y * (t1275_lanes - t870 * t1291_lanes);

  // links 1 (calf) and 15 (right_shoulder2), force propagation
  const Lanes<8> t1316_lanes = t783_lanes[1] * t1310_lanes;
  const Lanes<8> t1321_lanes = t1314_lanes * inverse_D1;
  const Lanes<8> t1322_lanes = s16 * t1292_lanes + c16 * t1293_lanes - t413_lanes[1] * t1310_lanes;
  const Lanes<8> t1324_lanes = s16 * t1294_lanes + c16 * t1295_lanes - t416_lanes[1] * t1310_lanes;
  const Lanes<8> t1325_lanes = -t1296_lanes + t415_lanes[1] * t1310_lanes;
  const Lanes<8> t1335_lanes = s15 * t1316_lanes + c15 * t1322_lanes;

  // links 1, 10, 14, force propagation
  const Lanes<8> t1344_lanes = t521_lanes[1] * t1335_lanes;
  const Lanes<8> t1348_lanes = t968_lanes[1] * t1335_lanes;
  const Lanes<8> t1352_lanes = t1064_lanes * t987_lanes[1];
  const Lanes<8> t1357_lanes = t1266_lanes + t1298_lanes * t1291_lanes[0] + t1321_lanes *
      t1314_lanes[0];
  Lambda_inv[0] = t1357_lanes[0];

  // link 1 (calf), force propagation
  Lambda_inv[1] = t1357_lanes[1];
  Lambda_inv[12] = t1357_lanes[1];
  Lambda_inv[2] = t1357_lanes[2];
  Lambda_inv[24] = t1357_lanes[2];
  Lambda_inv[3] = t1357_lanes[3];
  Lambda_inv[36] = t1357_lanes[3];
  Lambda_inv[4] = t1357_lanes[4];
  Lambda_inv[48] = t1357_lanes[4];
  Lambda_inv[5] = t1357_lanes[5];
  Lambda_inv[60] = t1357_lanes[5];
  Lambda_inv[6] = t1357_lanes[6];
  Lambda_inv[72] = t1357_lanes[6];
  Lambda_inv[7] = t1357_lanes[7];
  Lambda_inv[84] = t1357_lanes[7];

  // link 14 (right_shoulder1), force propagation
  const Lanes<8> t1358_lanes = c16 * t1294_lanes - s16 * t1295_lanes - t419_lanes[1] * t1310_lanes -
      t1344_lanes;
  const Lanes<8> t1359_lanes = c15 * t1325_lanes - s15 * t1324_lanes - t520_lanes[1] * t1335_lanes;
  const Lanes<8> t1360_lanes = c15 * t1316_lanes - s15 * t1322_lanes - t543_lanes[1] * t1335_lanes;
  const Lanes<8> t1361_lanes = s15 * t1325_lanes + c15 * t1324_lanes - t525_lanes[1] * t1335_lanes;
  const Lanes<8> t1373_lanes = s14 * t1358_lanes + c14 * t1359_lanes;

  // links 7, 10, 14, force propagation
  const Lanes<8> t1375_lanes = t1070_lanes * t916_lanes[1] + t1068_lanes * t926_lanes[1] +
      t1066_lanes * t954_lanes[1] + t1352_lanes;
  const Lanes<8> t1377_lanes = c14 * t1358_lanes - s14 * t1359_lanes;
  const Lanes<8> t1384_lanes = t1064_lanes * t987_lanes[2];
  const Lanes<8> t1395_lanes = 0.226 * t1361_lanes + (-0.18) * t1373_lanes;
  const Lanes<8> t1401_lanes = t1375_lanes + t1065_lanes * t1007_lanes[1] + t1067_lanes *
      t1034_lanes[1] + t1069_lanes * t1055_lanes[1];

  // links 6 (chest3) and 10 (left_lowerarm), force propagation
  const Lanes<8> t1402_lanes = -(c14 * t1348_lanes + s14 * t1360_lanes + t1395_lanes);
  const Lanes<8> t1403_lanes = t674 * t1402_lanes;
  const Lanes<8> t1408_lanes = t1070_lanes * t916_lanes[2] + t1068_lanes * t926_lanes[2] +
      t1066_lanes * t954_lanes[2] + t1384_lanes;
  const Lanes<8> t1409_lanes = t1402_lanes * inverse_D6;
  const Lanes<8> t1410_lanes = t1401_lanes + t1120_lanes * t1112_lanes[1];
  const Lanes<8> t1417_lanes = (-0.18) * t1377_lanes - (s14 * t1348_lanes - c14 * t1360_lanes) -
      t1403_lanes;
  const Lanes<8> t1418_lanes = 0.226 * t1377_lanes - t673 * t1402_lanes;
  const Lanes<8> t1419_lanes = t1377_lanes - t672 * t1402_lanes;
  const Lanes<8> t1420_lanes = t1373_lanes + t675 * t1402_lanes;
  const Lanes<8> t1421_lanes = t1361_lanes - t676 * t1402_lanes;
  const Lanes<8> t1425_lanes = t1064_lanes * t987_lanes[3];
  const Lanes<8> t1450_lanes = s6 * t1420_lanes + c6 * t1421_lanes;

  // links 6 and 7, 14 to 16, force propagation
  const Lanes<8> t1452_lanes = t1408_lanes + t1065_lanes * t1007_lanes[2] + t1067_lanes *
      t1034_lanes[2] + t1069_lanes * t1055_lanes[2];
  const Lanes<8> t1454_lanes = t1335_lanes * inverse_D7_14_lanes[1];
  const Lanes<8> t1456_lanes = s6 * t1417_lanes + c6 * t1418_lanes + minus_link5_to_6_y *
      t1419_lanes;
  const Lanes<8> t1457_lanes = t1310_lanes * inverse_D8_15_lanes[1];
  const Lanes<8> t1458_lanes = t1276_lanes * inverse_D9_16_lanes[1];

  // links 6, 10, 17 to 19, force propagation
  const Lanes<8> t1460_lanes = t1243_lanes * inverse_D10_17_lanes[1];
  const Lanes<8> t1461_lanes = t1204_lanes * inverse_D11_18_lanes[1];
  const Lanes<8> t1462_lanes = t1070_lanes * t908_lanes[0] + t1068_lanes * t926_lanes[3] +
      t1066_lanes * t954_lanes[3] + t1425_lanes;
  const Lanes<8> t1463_lanes = t1159_lanes * inverse_D12_19_lanes[1];
  const Lanes<8> t1465_lanes = t1452_lanes + t1120_lanes * t1112_lanes[2];

  // links 8 and 9, 11, 15 and 16, 18, force propagation
  const Lanes<2> t1471_lanes = detail::make_pack<Real>(t1065_lanes[5], t1458_lanes[3]) *
      detail::make_pack<Real>(t1007_lanes[4], t1276_lanes[2]);
  const Lanes<2> t1472_lanes = detail::make_pack<Real>(t1065_lanes[4], t1458_lanes[2]) *
      detail::make_pack<Real>(t1007_lanes[4], t1276_lanes[2]);
  const Lanes<2> t1473_lanes = detail::make_pack<Real>(t1067_lanes[5], t1457_lanes[3]) *
      detail::make_pack<Real>(t1034_lanes[4], t1310_lanes[2]);
  const Lanes<2> t1475_lanes = detail::make_pack<Real>(t1066_lanes[5], t1461_lanes[3]) *
      detail::make_pack<Real>(t954_lanes[4], t1204_lanes[2]);
  const Lanes<2> t1476_lanes = detail::make_pack<Real>(t1066_lanes[4], t1461_lanes[2]) *
      detail::make_pack<Real>(t954_lanes[4], t1204_lanes[2]);

  // links 8, 10, 12, 15, 17, 19, force propagation
  const Lanes<2> t1477_lanes = detail::make_pack<Real>(t1064_lanes[5], t1460_lanes[3]) *
      detail::make_pack<Real>(t987_lanes[4], t1243_lanes[2]);
  const Lanes<2> t1478_lanes = detail::make_pack<Real>(t1064_lanes[4], t1460_lanes[2]) *
      detail::make_pack<Real>(t987_lanes[4], t1243_lanes[2]);
  const Lanes<2> t1479_lanes = detail::make_pack<Real>(t1068_lanes[5], t1463_lanes[3]) *
      detail::make_pack<Real>(t926_lanes[4], t1159_lanes[2]);
  const Lanes<2> t1480_lanes = detail::make_pack<Real>(t1068_lanes[4], t1463_lanes[2]) *
      detail::make_pack<Real>(t926_lanes[4], t1159_lanes[2]);
  const Lanes<2> t1481_lanes = detail::make_pack<Real>(t1067_lanes[4], t1457_lanes[2]) *
      detail::make_pack<Real>(t1034_lanes[4], t1310_lanes[2]);

  // links 5, 7, 14, force propagation
  const Lanes<8> t1483_lanes = c6 * t1420_lanes - s6 * t1421_lanes - t715 * t1456_lanes;
  const Lanes<8> t1484_lanes = t1419_lanes - t714 * t1456_lanes;
  const Lanes<8> t1485_lanes = c6 * t1417_lanes - s6 * t1418_lanes - t718 * t1456_lanes;
  const Lanes<8> t1486_lanes = -(minus_link5_to_6_y * t1450_lanes) + t717 * t1456_lanes;
  const Lanes<2> t1488_lanes = detail::make_pack<Real>(t1069_lanes[5], t1454_lanes[3]) *
      detail::make_pack<Real>(t1055_lanes[4], t1335_lanes[2]);
  const Lanes<2> t1489_lanes = detail::make_pack<Real>(t1069_lanes[4], t1454_lanes[2]) *
      detail::make_pack<Real>(t1055_lanes[4], t1335_lanes[2]);
  const Lanes<8> t1490_lanes = t1456_lanes * inverse_D5;
  const Lanes<8> t1498_lanes = s4 * (t1450_lanes - t716 * t1456_lanes);

  // links 4, 7, 10, 17, 20, force propagation
  const Lanes<2> t1505_lanes = detail::make_pack<Real>(t1064_lanes[5], t1460_lanes[3]) *
      detail::make_pack<Real>(t987_lanes[5], t1243_lanes[3]);
  const Lanes<8> t1508_lanes = 1065.380700001509 * detail::make_pack<Real>(t1146, t849, t785, t1129,
      t1146, t1146, t1146, t1146);
  const Lanes<8> t1515_lanes = t1462_lanes + t1065_lanes * t1007_lanes[3] + t1067_lanes *
      t1034_lanes[3] + t1069_lanes * t1055_lanes[3];
  const Lanes<8> t1525_lanes = -(s5 * t1486_lanes + c5 * t1485_lanes);
  const Lanes<8> t1531_lanes = t1525_lanes * inverse_D4;

  // links 4 and 5, 14 to 16, force propagation
  const Real t1535 = t871 * inverse_D7_14_lanes[1];
  const Lanes<8> t1536_lanes = c4 * (s5 * t1483_lanes - c5 * t1484_lanes) + t1498_lanes;
  const Real t1538 = t853 * inverse_D8_15_lanes[1];
  const Real t1539 = t837 * inverse_D9_16_lanes[1];
  const Lanes<8> t1540_lanes = -(s5 * t1484_lanes + c5 * t1483_lanes) - t773 * t1525_lanes;

  // links 6, 17 to 20, force propagation
  const Real t1541 = t824 * inverse_D10_17_lanes[1];
  const Real t1543 = 1065.380700001509 * t789;
  const Real t1544 = t790 * inverse_D12_19_lanes[1];
  const Lanes<8> t1545_lanes = t1515_lanes + t1120_lanes * t1112_lanes[3];
  const Real t1549 = t811 * inverse_D11_18_lanes[1];

  // links 4 and 5, 8, 10, 17, force propagation
  const Lanes<8> t1553_lanes = s4 * (s5 * t1485_lanes - c5 * t1486_lanes) + link4_to_5_z *
      t1536_lanes;
  const Lanes<2> t1554_lanes = detail::make_pack<Real>(t1070_lanes[5], t1508_lanes[3]) *
      detail::make_pack<Real>(t908_lanes[2], t1129) +
      detail::make_pack<Real>(t1068_lanes[5], t1463_lanes[3]) *
      detail::make_pack<Real>(t926_lanes[5], t1159_lanes[3]) +
      detail::make_pack<Real>(t1066_lanes[5], t1461_lanes[3]) *
      detail::make_pack<Real>(t954_lanes[5], t1204_lanes[3]) + t1505_lanes;
  const Lanes<8> t1555_lanes = t1070_lanes * t908_lanes[1] +
      detail::make_pack<Real>(t1480_lanes[0], t1480_lanes[0], t1480_lanes[0], t1480_lanes[0],
      t1480_lanes[0], t1479_lanes[0], t1480_lanes[0], t1480_lanes[0]) +
      detail::make_pack<Real>(t1476_lanes[0], t1476_lanes[0], t1476_lanes[0], t1476_lanes[0],
      t1476_lanes[0], t1475_lanes[0], t1476_lanes[0], t1476_lanes[0]) +
      detail::make_pack<Real>(t1478_lanes[0], t1478_lanes[0], t1478_lanes[0], t1478_lanes[0],
      t1478_lanes[0], t1477_lanes[0], t1478_lanes[0], t1478_lanes[0]) +
      detail::make_pack<Real>(t1472_lanes[0], t1472_lanes[0], t1472_lanes[0], t1472_lanes[0],
      t1472_lanes[0], t1471_lanes[0], t1472_lanes[0], t1472_lanes[0]) +
      detail::make_pack<Real>(t1481_lanes[0], t1481_lanes[0], t1481_lanes[0], t1481_lanes[0],
      t1481_lanes[0], t1473_lanes[0], t1481_lanes[0], t1481_lanes[0]);
  const Lanes<8> t1559_lanes = -t1553_lanes - t772 * t1525_lanes;
  const Lanes<8> t1567_lanes = t1460_lanes * t902;

  // links 3, 6 and 7, 14, force propagation
  const Lanes<8> t1576_lanes = t1555_lanes + detail::make_pack<Real>(t1489_lanes[0], t1489_lanes[0],
      t1489_lanes[0], t1489_lanes[0], t1489_lanes[0], t1488_lanes[0], t1489_lanes[0],
      t1489_lanes[0]) + detail::make_pack<Real>(t1120_lanes[4] * t1112_lanes[4], t1120_lanes[4] *
      t1112_lanes[4], t1120_lanes[4] * t1112_lanes[4], t1120_lanes[4] * t1112_lanes[4],
      t1120_lanes[4] * t1112_lanes[4], t1120_lanes[5] * t1112_lanes[4], t1120_lanes[4] *
      t1112_lanes[4], t1120_lanes[4] * t1112_lanes[4]);
  const Lanes<8> t1577_lanes = t1559_lanes * inverse_D3;
  const Lanes<8> t1583_lanes = -t1536_lanes - t774 * t1525_lanes - t796 * t1559_lanes;
  const Lanes<8> t1584_lanes = -t1540_lanes + t795 * t1559_lanes;
  const Lanes<2> t1593_lanes = t1554_lanes + detail::make_pack<Real>(t1065_lanes[5],
      t1458_lanes[3]) * detail::make_pack<Real>(t1007_lanes[5], t1276_lanes[3]) +
      detail::make_pack<Real>(t1067_lanes[5], t1457_lanes[3]) *
      detail::make_pack<Real>(t1034_lanes[5], t1310_lanes[3]) +
      detail::make_pack<Real>(t1069_lanes[5], t1454_lanes[3]) *
      detail::make_pack<Real>(t1055_lanes[5], t1335_lanes[3]);

  // links 3, 15, 17, force propagation
  const Lanes<8> t1601_lanes = c2_plus_3 * t1583_lanes - s2_plus_3 * t1584_lanes;
  const Lanes<8> t1602_lanes = t1508_lanes * t856 + t1463_lanes * t865 + t1461_lanes * t885 +
      t1567_lanes;
  const Lanes<8> t1604_lanes = t1460_lanes * t824;
  const Lanes<8> t1610_lanes = detail::make_pack<Real>(1065.380700001509 * t856, 1065.380700001509 *
      t856, 1065.380700001509 * t856, 1065.380700001509 * t856, 1065.380700001509 * t856,
      1065.380700001509 * t856, 1065.380700001509 * t856, t1543) * t856 +
      detail::make_pack<Real>(t865 * inverse_D12_19_lanes[1] * t865, t865 *
      inverse_D12_19_lanes[1] * t865, t865 * inverse_D12_19_lanes[1] * t865, t865 *
      inverse_D12_19_lanes[1] * t865, t865 * inverse_D12_19_lanes[1] * t865, t865 *
      inverse_D12_19_lanes[1] * t865, t865 * inverse_D12_19_lanes[1] * t865, t1544 * t865) +
      detail::make_pack<Real>(t885 * inverse_D11_18_lanes[1] * t885, t885 *
      inverse_D11_18_lanes[1] * t885, t885 * inverse_D11_18_lanes[1] * t885, t885 *
      inverse_D11_18_lanes[1] * t885, t885 * inverse_D11_18_lanes[1] * t885, t885 *
      inverse_D11_18_lanes[1] * t885, t885 * inverse_D11_18_lanes[1] * t885, t1549 * t885) +
      detail::make_pack<Real>(t902 * inverse_D10_17_lanes[1] * t902, t902 *
      inverse_D10_17_lanes[1] * t902, t902 * inverse_D10_17_lanes[1] * t902, t902 *
      inverse_D10_17_lanes[1] * t902, t902 * inverse_D10_17_lanes[1] * t902, t902 *
      inverse_D10_17_lanes[1] * t902, t902 * inverse_D10_17_lanes[1] * t902, t1541 * t902) +
      detail::make_pack<Real>(t918 * inverse_D9_16_lanes[1] * t918, t918 * inverse_D9_16_lanes[1] *
      t918, t918 * inverse_D9_16_lanes[1] * t918, t918 * inverse_D9_16_lanes[1] * t918, t918 *
      inverse_D9_16_lanes[1] * t918, t918 * inverse_D9_16_lanes[1] * t918, t918 *
      inverse_D9_16_lanes[1] * t918, t1539 * t918) + detail::make_pack<Real>(t950 *
      inverse_D8_15_lanes[1] * t950, t950 * inverse_D8_15_lanes[1] * t950, t950 *
      inverse_D8_15_lanes[1] * t950, t950 * inverse_D8_15_lanes[1] * t950, t950 *
      inverse_D8_15_lanes[1] * t950, t950 * inverse_D8_15_lanes[1] * t950, t950 *
      inverse_D8_15_lanes[1] * t950, t1538 * t950);
  const Lanes<8> t1626_lanes = t1460_lanes * t1243_lanes[0];

  // links 3, 14, 16 and 17, force propagation
  const Real t1631 = t1543 * t789 + t1544 * t790 + t1549 * t811 + t1541 * t824 + t1539 * t837;
  const Lanes<8> t1632_lanes = t738 * (s2_plus_3 * t1583_lanes + c2_plus_3 * t1584_lanes) + t736 *
      t1601_lanes;
  const Lanes<8> t1633_lanes = t1602_lanes + t1458_lanes * t918 + t1457_lanes * t950 + t1454_lanes *
      t986;
  const Lanes<8> t1640_lanes = t1577_lanes * t1242_lanes[0];
  const Lanes<8> t1641_lanes = t1508_lanes * t789 + t1463_lanes * t790 + t1461_lanes * t811 +
      t1604_lanes;

  // links 2 and 3, 17, force propagation
  const Lanes<8> t1643_lanes = t1632_lanes * inverse_D2;
  const Lanes<8> t1650_lanes = t1460_lanes * t1243_lanes[1];
  const Lanes<8> t1660_lanes = t1577_lanes * t1242_lanes[1];
  const Lanes<8> t1661_lanes = t1577_lanes * t1242_lanes[2];
  const Lanes<8> t1662_lanes = t1577_lanes * t1242_lanes[3];
  const Lanes<8> t1665_lanes = t1577_lanes * t1242_lanes[4];
  const Lanes<8> t1667_lanes = t1508_lanes * t1146 + t1463_lanes * t1159_lanes[0] + t1461_lanes *
      t1204_lanes[0] + t1626_lanes;
  const Lanes<8> t1669_lanes = minus_link1_to_2_y * (t1601_lanes - t870 * t1632_lanes);

  // links 3, 5, 14, 17, force propagation
  const Lanes<8> t1671_lanes = t1641_lanes + t1458_lanes * t837 + t1457_lanes * t853 + t1454_lanes *
      t871;
  const Real t1672 = t1631 + t1538 * t853 + t1535 * t871 + t1118 * t1112_lanes[7] + t1157_lanes[7] *
      t1147_lanes[7];
  const Lanes<8> t1676_lanes = t1577_lanes * t1242_lanes[5];
  const Lanes<8> t1681_lanes = t1508_lanes * t849 + t1463_lanes * t1159_lanes[1] + t1461_lanes *
      t1204_lanes[1] + t1650_lanes;
  const Lanes<8> t1688_lanes = t1667_lanes + t1458_lanes * t1276_lanes[0] + t1457_lanes *
      t1310_lanes[0] + t1454_lanes * t1335_lanes[0];

  // links 1, 4, 14 and 15, force propagation
  const Lanes<8> t1704_lanes = t1633_lanes + t1409_lanes * t1112_lanes[6] + t1490_lanes *
      t1147_lanes[6] + t1531_lanes * t1197_lanes[6];
  const Lanes<8> t1706_lanes = t1671_lanes + t1409_lanes * t1112_lanes[7] + t1490_lanes *
      t1147_lanes[7] + t1531_lanes * t1197_lanes[7];
  const Lanes<8> t1707_lanes = t1669_lanes * inverse_D1;
  const Lanes<8> t1708_lanes = t1681_lanes + t1458_lanes * t1276_lanes[1] + t1457_lanes *
      t1310_lanes[1] + t1454_lanes * t1335_lanes[1];
  const Lanes<8> t1716_lanes = t1508_lanes * t785 +
      detail::make_pack<Real>(t1480_lanes[1], t1480_lanes[1], t1480_lanes[1], t1479_lanes[1],
      t1480_lanes[1], t1480_lanes[1], t1480_lanes[1], t1480_lanes[1]) +
      detail::make_pack<Real>(t1476_lanes[1], t1476_lanes[1], t1476_lanes[1], t1475_lanes[1],
      t1476_lanes[1], t1476_lanes[1], t1476_lanes[1], t1476_lanes[1]) +
      detail::make_pack<Real>(t1478_lanes[1], t1478_lanes[1], t1478_lanes[1], t1477_lanes[1],
      t1478_lanes[1], t1478_lanes[1], t1478_lanes[1], t1478_lanes[1]) +
      detail::make_pack<Real>(t1472_lanes[1], t1472_lanes[1], t1472_lanes[1], t1471_lanes[1],
      t1472_lanes[1], t1472_lanes[1], t1472_lanes[1], t1472_lanes[1]) +
      detail::make_pack<Real>(t1481_lanes[1], t1481_lanes[1], t1481_lanes[1], t1473_lanes[1],
      t1481_lanes[1], t1481_lanes[1], t1481_lanes[1], t1481_lanes[1]);
  const Lanes<8> t1719_lanes = t1688_lanes + t1409_lanes * t1402_lanes[0] + t1490_lanes *
      t1456_lanes[0] + t1531_lanes * t1525_lanes[0];

  // link 3 (hip), force propagation
  const Lanes<8> t1726_lanes = t1409_lanes * t1112_lanes[0] + t1490_lanes * t1147_lanes[0] +
      t1531_lanes * t1197_lanes[0] + t1640_lanes;
  const Lanes<8> t1727_lanes = detail::make_pack<Real>(t1410_lanes[1], t1410_lanes[1],
      t1410_lanes[2], t1410_lanes[3], t1410_lanes[4], t1410_lanes[5], t1119 * t1112_lanes[1],
      t1118 * t1112_lanes[1]) + t1157_lanes * t1147_lanes[1] + t1202_lanes * t1197_lanes[1] +
      t1247_lanes * t1242_lanes[1];
  const Lanes<8> t1728_lanes = t1409_lanes * t1112_lanes[1] + t1490_lanes * t1147_lanes[1] +
      t1531_lanes * t1197_lanes[1] + t1660_lanes;
  const Lanes<8> t1729_lanes = detail::make_pack<Real>(t1465_lanes[2], t1465_lanes[2],
      t1465_lanes[2], t1465_lanes[3], t1465_lanes[4], t1465_lanes[5], t1119 * t1112_lanes[2],
      t1118 * t1112_lanes[2]) + t1157_lanes * t1147_lanes[2] + t1202_lanes * t1197_lanes[2] +
      t1247_lanes * t1242_lanes[2];
  const Lanes<8> t1730_lanes = t1409_lanes * t1112_lanes[2] + t1490_lanes * t1147_lanes[2] +
      t1531_lanes * t1197_lanes[2] + t1661_lanes;
  const Lanes<8> t1731_lanes = detail::make_pack<Real>(t1545_lanes[3], t1545_lanes[3],
      t1545_lanes[3], t1545_lanes[3], t1545_lanes[4], t1545_lanes[5], t1119 * t1112_lanes[3],
      t1118 * t1112_lanes[3]) + t1157_lanes * t1147_lanes[3] + t1202_lanes * t1197_lanes[3] +
      t1247_lanes * t1242_lanes[3];
  const Lanes<8> t1732_lanes = t1409_lanes * t1112_lanes[3] + t1490_lanes * t1147_lanes[3] +
      t1531_lanes * t1197_lanes[3] + t1662_lanes;
  const Lanes<8> t1734_lanes = detail::make_pack<Real>(t1576_lanes[4], t1576_lanes[4],
      t1576_lanes[4], t1576_lanes[4], t1576_lanes[4], t1576_lanes[5], t1119 * t1112_lanes[4],
      t1118 * t1112_lanes[4]) + t1157_lanes * t1147_lanes[4] + t1202_lanes * t1197_lanes[4] +
      t1247_lanes * t1242_lanes[4];
  const Lanes<8> t1735_lanes = t1409_lanes * t1112_lanes[4] + t1490_lanes * t1147_lanes[4] +
      t1531_lanes * t1197_lanes[4] + t1665_lanes;
  const Lanes<8> t1736_lanes = detail::make_pack<Real>(t1593_lanes[0] + t1120_lanes[5] *
      t1112_lanes[5], t1593_lanes[0] + t1120_lanes[5] * t1112_lanes[5], t1593_lanes[0] +
      t1120_lanes[5] * t1112_lanes[5], t1593_lanes[0] + t1120_lanes[5] * t1112_lanes[5],
      t1593_lanes[0] + t1120_lanes[5] * t1112_lanes[5], t1593_lanes[0] + t1120_lanes[5] *
      t1112_lanes[5], t1119 * t1112_lanes[5], t1118 * t1112_lanes[5]) + t1157_lanes *
      t1147_lanes[5] + t1202_lanes * t1197_lanes[5] + t1247_lanes * t1242_lanes[5];

  // links 2 to 4, force propagation
  const Lanes<8> t1737_lanes = t1708_lanes + t1409_lanes * t1402_lanes[1] + t1490_lanes *
      t1456_lanes[1] + t1531_lanes * t1525_lanes[1];
  const Lanes<8> t1738_lanes = t1409_lanes * t1112_lanes[5] + t1490_lanes * t1147_lanes[5] +
      t1531_lanes * t1197_lanes[5] + t1676_lanes;
  const Real t1743 = t1593_lanes[1] + t1409_lanes[3] * t1402_lanes[3] + t1490_lanes[3] *
      t1456_lanes[3] + t1531_lanes[3] * t1525_lanes[3] + t1577_lanes[3] * t1559_lanes[3];
  const Lanes<8> t1770_lanes = t1610_lanes + detail::make_pack<Real>(t986 * inverse_D7_14_lanes[1] *
      t986, t986 * inverse_D7_14_lanes[1] * t986, t986 * inverse_D7_14_lanes[1] * t986, t986 *
      inverse_D7_14_lanes[1] * t986, t986 * inverse_D7_14_lanes[1] * t986, t986 *
      inverse_D7_14_lanes[1] * t986, t986 * inverse_D7_14_lanes[1] * t986, t1535 * t986) +
      detail::make_pack<Real>(t1119 * t1112_lanes[6], t1119 * t1112_lanes[6], t1119 *
      t1112_lanes[6], t1119 * t1112_lanes[6], t1119 * t1112_lanes[6], t1119 * t1112_lanes[6],
      t1119 * t1112_lanes[6], t1118 * t1112_lanes[6]) +
      detail::make_pack<Real>(t1157_lanes[6] * t1147_lanes[6], t1157_lanes[6] * t1147_lanes[6],
      t1157_lanes[6] * t1147_lanes[6], t1157_lanes[6] * t1147_lanes[6], t1157_lanes[6] *
      t1147_lanes[6], t1157_lanes[6] * t1147_lanes[6], t1157_lanes[6] * t1147_lanes[6],
      t1157_lanes[7] * t1147_lanes[6]) + detail::make_pack<Real>(t1202_lanes[6] * t1197_lanes[6],
      t1202_lanes[6] * t1197_lanes[6], t1202_lanes[6] * t1197_lanes[6], t1202_lanes[6] *
      t1197_lanes[6], t1202_lanes[6] * t1197_lanes[6], t1202_lanes[6] * t1197_lanes[6],
      t1202_lanes[6] * t1197_lanes[6], t1202_lanes[7] * t1197_lanes[6]) +
      detail::make_pack<Real>(t1247_lanes[6] * t1242_lanes[6], t1247_lanes[6] * t1242_lanes[6],
      t1247_lanes[6] * t1242_lanes[6], t1247_lanes[6] * t1242_lanes[6], t1247_lanes[6] *
      t1242_lanes[6], t1247_lanes[6] * t1242_lanes[6], t1247_lanes[6] * t1242_lanes[6],
      t1247_lanes[7] * t1242_lanes[6]) + detail::make_pack<Real>(t1298_lanes[6] * t1291_lanes[6],
      t1298_lanes[6] * t1291_lanes[6], t1298_lanes[6] * t1291_lanes[6], t1298_lanes[6] *
      t1291_lanes[6], t1298_lanes[6] * t1291_lanes[6], t1298_lanes[6] * t1291_lanes[6],
      t1298_lanes[6] * t1291_lanes[6], t1298_lanes[7] * t1291_lanes[6]);
  const Lanes<8> t1775_lanes = t1716_lanes + detail::make_pack<Real>(t1489_lanes[1], t1489_lanes[1],
      t1489_lanes[1], t1488_lanes[1], t1489_lanes[1], t1489_lanes[1], t1489_lanes[1],
      t1489_lanes[1]) + detail::make_pack<Real>(t1409_lanes[2] * t1402_lanes[2], t1409_lanes[2] *
      t1402_lanes[2], t1409_lanes[2] * t1402_lanes[2], t1409_lanes[3] * t1402_lanes[2],
      t1409_lanes[2] * t1402_lanes[2], t1409_lanes[2] * t1402_lanes[2], t1409_lanes[2] *
      t1402_lanes[2], t1409_lanes[2] * t1402_lanes[2]) +
      detail::make_pack<Real>(t1490_lanes[2] * t1456_lanes[2], t1490_lanes[2] * t1456_lanes[2],
      t1490_lanes[2] * t1456_lanes[2], t1490_lanes[3] * t1456_lanes[2], t1490_lanes[2] *
      t1456_lanes[2], t1490_lanes[2] * t1456_lanes[2], t1490_lanes[2] * t1456_lanes[2],
      t1490_lanes[2] * t1456_lanes[2]) + detail::make_pack<Real>(t1531_lanes[2] * t1525_lanes[2],
      t1531_lanes[2] * t1525_lanes[2], t1531_lanes[2] * t1525_lanes[2], t1531_lanes[3] *
      t1525_lanes[2], t1531_lanes[2] * t1525_lanes[2], t1531_lanes[2] * t1525_lanes[2],
      t1531_lanes[2] * t1525_lanes[2], t1531_lanes[2] * t1525_lanes[2]) +
      detail::make_pack<Real>(t1577_lanes[2] * t1559_lanes[2], t1577_lanes[2] * t1559_lanes[2],
      t1577_lanes[2] * t1559_lanes[2], t1577_lanes[3] * t1559_lanes[2], t1577_lanes[2] *
      t1559_lanes[2], t1577_lanes[2] * t1559_lanes[2], t1577_lanes[2] * t1559_lanes[2],
      t1577_lanes[2] * t1559_lanes[2]) + detail::make_pack<Real>(t1643_lanes[2] * t1632_lanes[2],
      t1643_lanes[2] * t1632_lanes[2], t1643_lanes[2] * t1632_lanes[2], t1643_lanes[3] *
      t1632_lanes[2], t1643_lanes[2] * t1632_lanes[2], t1643_lanes[2] * t1632_lanes[2],
      t1643_lanes[2] * t1632_lanes[2], t1643_lanes[2] * t1632_lanes[2]);

  // link 1 (calf), force propagation
  const Lanes<8> t1776_lanes = t1726_lanes + t1643_lanes * t1291_lanes[0] + t1707_lanes *
      t1314_lanes[0];
  Lambda_inv[8] = t1776_lanes[0];
  Lambda_inv[96] = t1776_lanes[0];
  Lambda_inv[9] = t1776_lanes[1];
  Lambda_inv[108] = t1776_lanes[1];
  Lambda_inv[10] = t1776_lanes[2];
  Lambda_inv[120] = t1776_lanes[2];
  Lambda_inv[11] = t1776_lanes[3];
  Lambda_inv[132] = t1776_lanes[3];
  const Lanes<8> t1777_lanes = t1727_lanes + t1298_lanes * t1291_lanes[1] + t1321_lanes *
      t1314_lanes[1];
  Lambda_inv[13] = t1777_lanes[1];
  Lambda_inv[14] = t1777_lanes[2];
  Lambda_inv[25] = t1777_lanes[2];
  Lambda_inv[15] = t1777_lanes[3];
  Lambda_inv[37] = t1777_lanes[3];
  Lambda_inv[16] = t1777_lanes[4];
  Lambda_inv[49] = t1777_lanes[4];
  Lambda_inv[17] = t1777_lanes[5];
  Lambda_inv[61] = t1777_lanes[5];
  Lambda_inv[18] = t1777_lanes[6];
  Lambda_inv[73] = t1777_lanes[6];
  Lambda_inv[19] = t1777_lanes[7];
  Lambda_inv[85] = t1777_lanes[7];
  const Lanes<8> t1778_lanes = t1728_lanes + t1643_lanes * t1291_lanes[1] + t1707_lanes *
      t1314_lanes[1];
  Lambda_inv[20] = t1778_lanes[0];
  Lambda_inv[97] = t1778_lanes[0];
  Lambda_inv[21] = t1778_lanes[1];
  Lambda_inv[109] = t1778_lanes[1];
  Lambda_inv[22] = t1778_lanes[2];
  Lambda_inv[121] = t1778_lanes[2];
  Lambda_inv[23] = t1778_lanes[3];
  Lambda_inv[133] = t1778_lanes[3];
  const Lanes<8> t1779_lanes = t1729_lanes + t1298_lanes * t1291_lanes[2] + t1321_lanes *
      t1314_lanes[2];
  Lambda_inv[26] = t1779_lanes[2];
  Lambda_inv[27] = t1779_lanes[3];
  Lambda_inv[38] = t1779_lanes[3];
  Lambda_inv[28] = t1779_lanes[4];
  Lambda_inv[50] = t1779_lanes[4];
  Lambda_inv[29] = t1779_lanes[5];
  Lambda_inv[62] = t1779_lanes[5];
  Lambda_inv[30] = t1779_lanes[6];
  Lambda_inv[74] = t1779_lanes[6];
  Lambda_inv[31] = t1779_lanes[7];
  Lambda_inv[86] = t1779_lanes[7];
  const Lanes<8> t1780_lanes = t1730_lanes + t1643_lanes * t1291_lanes[2] + t1707_lanes *
      t1314_lanes[2];
  Lambda_inv[32] = t1780_lanes[0];
  Lambda_inv[98] = t1780_lanes[0];
  Lambda_inv[33] = t1780_lanes[1];
  Lambda_inv[110] = t1780_lanes[1];
  Lambda_inv[34] = t1780_lanes[2];
  Lambda_inv[122] = t1780_lanes[2];
  Lambda_inv[35] = t1780_lanes[3];
  Lambda_inv[134] = t1780_lanes[3];
  const Lanes<8> t1781_lanes = t1731_lanes + t1298_lanes * t1291_lanes[3] + t1321_lanes *
      t1314_lanes[3];
  Lambda_inv[39] = t1781_lanes[3];
  Lambda_inv[40] = t1781_lanes[4];
  Lambda_inv[51] = t1781_lanes[4];
  Lambda_inv[41] = t1781_lanes[5];
  Lambda_inv[63] = t1781_lanes[5];
  Lambda_inv[42] = t1781_lanes[6];
  Lambda_inv[75] = t1781_lanes[6];
  Lambda_inv[43] = t1781_lanes[7];
  Lambda_inv[87] = t1781_lanes[7];
  const Lanes<8> t1782_lanes = t1732_lanes + t1643_lanes * t1291_lanes[3] + t1707_lanes *
      t1314_lanes[3];
  Lambda_inv[44] = t1782_lanes[0];
  Lambda_inv[99] = t1782_lanes[0];
  Lambda_inv[45] = t1782_lanes[1];
  Lambda_inv[111] = t1782_lanes[1];
  Lambda_inv[46] = t1782_lanes[2];
  Lambda_inv[123] = t1782_lanes[2];
  Lambda_inv[47] = t1782_lanes[3];
  Lambda_inv[135] = t1782_lanes[3];
  const Lanes<8> t1783_lanes = t1734_lanes + t1298_lanes * t1291_lanes[4] + t1321_lanes *
      t1314_lanes[4];
  Lambda_inv[52] = t1783_lanes[4];
  Lambda_inv[53] = t1783_lanes[5];
  Lambda_inv[64] = t1783_lanes[5];
  Lambda_inv[54] = t1783_lanes[6];
  Lambda_inv[76] = t1783_lanes[6];
  Lambda_inv[55] = t1783_lanes[7];
  Lambda_inv[88] = t1783_lanes[7];
  const Lanes<8> t1784_lanes = t1735_lanes + t1643_lanes * t1291_lanes[4] + t1707_lanes *
      t1314_lanes[4];
  Lambda_inv[56] = t1784_lanes[0];
  Lambda_inv[100] = t1784_lanes[0];
  Lambda_inv[57] = t1784_lanes[1];
  Lambda_inv[112] = t1784_lanes[1];
  Lambda_inv[58] = t1784_lanes[2];
  Lambda_inv[124] = t1784_lanes[2];
  Lambda_inv[59] = t1784_lanes[3];
  Lambda_inv[136] = t1784_lanes[3];
  const Lanes<8> t1785_lanes = t1736_lanes + t1298_lanes * t1291_lanes[5] + t1321_lanes *
      t1314_lanes[5];
  Lambda_inv[65] = t1785_lanes[5];
  Lambda_inv[66] = t1785_lanes[6];
  Lambda_inv[77] = t1785_lanes[6];
  Lambda_inv[67] = t1785_lanes[7];
  Lambda_inv[89] = t1785_lanes[7];
  const Lanes<8> t1786_lanes = t1738_lanes + t1643_lanes * t1291_lanes[5] + t1707_lanes *
      t1314_lanes[5];
  Lambda_inv[68] = t1786_lanes[0];
  Lambda_inv[101] = t1786_lanes[0];
  Lambda_inv[69] = t1786_lanes[1];
  Lambda_inv[113] = t1786_lanes[1];
  Lambda_inv[70] = t1786_lanes[2];
  Lambda_inv[125] = t1786_lanes[2];
  Lambda_inv[71] = t1786_lanes[3];
  Lambda_inv[137] = t1786_lanes[3];
  const Lanes<8> t1787_lanes = t1770_lanes + detail::make_pack<Real>(t1321_lanes[6] *
      t1314_lanes[6], t1321_lanes[6] * t1314_lanes[6], t1321_lanes[6] * t1314_lanes[6],
      t1321_lanes[6] * t1314_lanes[6], t1321_lanes[6] * t1314_lanes[6], t1321_lanes[6] *
      t1314_lanes[6], t1321_lanes[6] * t1314_lanes[6], t1321_lanes[7] * t1314_lanes[6]);
  Lambda_inv[78] = t1787_lanes[6];
  Lambda_inv[79] = t1787_lanes[7];
  Lambda_inv[90] = t1787_lanes[7];
  const Lanes<8> t1788_lanes = t1704_lanes + t1577_lanes * t1242_lanes[6] + t1643_lanes *
      t1291_lanes[6] + t1707_lanes * t1314_lanes[6];
  Lambda_inv[80] = t1788_lanes[0];
  Lambda_inv[102] = t1788_lanes[0];
  Lambda_inv[81] = t1788_lanes[1];
  Lambda_inv[114] = t1788_lanes[1];
  Lambda_inv[82] = t1788_lanes[2];
  Lambda_inv[126] = t1788_lanes[2];
  Lambda_inv[83] = t1788_lanes[3];
  Lambda_inv[138] = t1788_lanes[3];
  Lambda_inv[91] = t1672 + t1202_lanes[7] * t1197_lanes[7] + t1247_lanes[7] * t1242_lanes[7] +
      t1298_lanes[7] * t1291_lanes[7] + t1321_lanes[7] * t1314_lanes[7];
  const Lanes<8> t1789_lanes = t1706_lanes + t1577_lanes * t1242_lanes[7] + t1643_lanes *
      t1291_lanes[7] + t1707_lanes * t1314_lanes[7];
  Lambda_inv[92] = t1789_lanes[0];
  Lambda_inv[103] = t1789_lanes[0];
  Lambda_inv[93] = t1789_lanes[1];
  Lambda_inv[115] = t1789_lanes[1];
  Lambda_inv[94] = t1789_lanes[2];
  Lambda_inv[127] = t1789_lanes[2];
  Lambda_inv[95] = t1789_lanes[3];
  Lambda_inv[139] = t1789_lanes[3];
  const Lanes<8> t1790_lanes = t1719_lanes + t1577_lanes * t1559_lanes[0] + t1643_lanes *
      t1632_lanes[0] + t1707_lanes * t1669_lanes[0];
  Lambda_inv[104] = t1790_lanes[0];
  Lambda_inv[105] = t1790_lanes[1];
  Lambda_inv[116] = t1790_lanes[1];
  Lambda_inv[106] = t1790_lanes[2];
  Lambda_inv[128] = t1790_lanes[2];
  Lambda_inv[107] = t1790_lanes[3];
  Lambda_inv[140] = t1790_lanes[3];
  const Lanes<8> t1791_lanes = t1737_lanes + t1577_lanes * t1559_lanes[1] + t1643_lanes *
      t1632_lanes[1] + t1707_lanes * t1669_lanes[1];
  Lambda_inv[117] = t1791_lanes[1];
  Lambda_inv[118] = t1791_lanes[2];
  Lambda_inv[129] = t1791_lanes[2];
  Lambda_inv[119] = t1791_lanes[3];
  Lambda_inv[141] = t1791_lanes[3];
  const Lanes<8> t1792_lanes = t1775_lanes + detail::make_pack<Real>(t1707_lanes[2] *
      t1669_lanes[2], t1707_lanes[2] * t1669_lanes[2], t1707_lanes[2] * t1669_lanes[2],
      t1707_lanes[3] * t1669_lanes[2], t1707_lanes[2] * t1669_lanes[2], t1707_lanes[2] *
      t1669_lanes[2], t1707_lanes[2] * t1669_lanes[2], t1707_lanes[2] * t1669_lanes[2]);
  Lambda_inv[130] = t1792_lanes[2];
  Lambda_inv[131] = t1792_lanes[3];
  Lambda_inv[142] = t1792_lanes[3];
  Lambda_inv[143] = t1743 + t1643_lanes[3] * t1632_lanes[3] + t1707_lanes[3] * t1669_lanes[3];
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
