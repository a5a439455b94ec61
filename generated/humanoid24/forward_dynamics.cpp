// SPDX-License-Identifier: 0BSD
// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By articulated bodies, Chang table 4.2, alike limbs in lanes.
// 4579 flops (add 2154, mul 2393, div 32), sine and cosine of 24 angles
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
void forward_dynamics(const Real (&TREELINE_RESTRICT q)[24], const Real (&TREELINE_RESTRICT qd)[24],
    const Real (&TREELINE_RESTRICT tau)[24], Real (&TREELINE_RESTRICT qdd)[24]) noexcept {
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
  const Real minus_link5_to_6_y = 0.072;
  const Real minus_h_6_x = 6.1665928899999995;
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
  const Real minus_h_3_x = 0.02999999505;
  const Real minus_link2_to_3_y = 0.422;
  const Real J_2_zz = 9.885744550888212;
  const Real h_2_x = 0.031999971599999996;
  const Real minus_h_2_y = 24.5839218;
  const Real J_1_zz = 13.049859506913753;
  const Real minus_gravity_z = 9.81;
  const Real minus_link1_to_2_y = 0.434;
  const Real J_22_zz = 0.06394132500000001;
  const Real J_6_xx = 0.40041499999999997;
  const Real t1 = 0.17435661841416683 + q[19];
  const Real t2 = (-0.17435661841416683) + q[12];

  // sines and cosines
  const Real angles[24] = {q[23], q[22], q[21], q[20], q[18], t1, q[17], q[16], q[15], q[14], q[13],
      q[11], t2, q[10], q[9], q[8], q[7], q[6], q[5], q[4], q[3], q[1], q[2], q[0]};
  Real sines[24];
  Real cosines[24];
  detail::sin_cos(angles, sines, cosines);
  const Real s24 = sines[0];
  const Real s23 = sines[1];
  const Real c24 = cosines[0];
  const Real c23 = cosines[1];
  const Real c22 = cosines[2];
  const Real s22 = sines[2];
  const Real c21 = cosines[3];
  const Real s21 = sines[3];
  const Real s19 = sines[4];
  const Real s20 = sines[5];
  const Real c20 = cosines[5];
  const Real c19 = cosines[4];
  const Real s18 = sines[6];
  const Real c18 = cosines[6];
  const Real s17 = sines[7];
  const Real c17 = cosines[7];
  const Real c16 = cosines[8];
  const Real s16 = sines[8];
  const Real s15 = sines[9];
  const Real c15 = cosines[9];
  const Real c14 = cosines[10];
  const Real s14 = sines[10];
  const Real s12 = sines[11];
  const Real s13 = sines[12];
  const Real c13 = cosines[12];
  const Real c12 = cosines[11];
  const Real s11 = sines[13];
  const Real c11 = cosines[13];
  const Real s10 = sines[14];
  const Real c10 = cosines[14];
  const Real c9 = cosines[15];
  const Real s9 = sines[15];
  const Real s8 = sines[16];
  const Real c8 = cosines[16];
  const Real c7 = cosines[17];
  const Real s7 = sines[17];
  const Real s6 = sines[18];
  const Real c6 = cosines[18];
  const Real s5 = sines[19];
  const Real c5 = cosines[19];
  const Real s4 = sines[20];
  const Real c4 = cosines[20];
  const Real s2 = sines[21];
  const Real c3 = cosines[22];
  const Real c2 = cosines[21];
  const Real s3 = sines[22];
  const Real c1 = cosines[23];
  const Real s1 = sines[23];

  // links 11, 13, 18, 20, articulated inertia
  const Lanes<2> t9_lanes = 17.595187778776946 * detail::make_pack<Real>(s13, s20);
  const Lanes<2> t10_lanes = 0.0165153994048813 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> t11_lanes = 17.595187778776946 * detail::make_pack<Real>(c13, c20);
  const Lanes<2> t12_lanes = 0.0165153994048813 * detail::make_pack<Real>(s13, s20);
  const Lanes<2> t15_lanes = 2.0 * detail::make_pack<Real>(c11, c18);

  // links 13 (left_hand) and 20 (right_hand), articulated inertia
  const Lanes<2> t16_lanes = 0.00011422720754895356 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>((-2.4414671283021662e-05), 2.4414671283021662e-05) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> t17_lanes = 0.0007965395222188762 * detail::make_pack<Real>(s13, s20) +
      detail::make_pack<Real>(2.0630162081277884e-05, (-2.0630162081277884e-05)) *
      detail::make_pack<Real>(c13, c20);
  const Lanes<2> t18_lanes = 0.00011422720754895356 * detail::make_pack<Real>(c13, c20) -
      detail::make_pack<Real>((-2.4414671283021662e-05), 2.4414671283021662e-05) *
      detail::make_pack<Real>(s13, s20);
  const Lanes<2> t19_lanes = 0.0006000000000000001 + t10_lanes;
  const Lanes<2> t23_lanes = 1065.380700001509 * t16_lanes;
  const Lanes<2> t24_lanes = detail::make_pack<Real>(s13, s20) * t17_lanes;
  const Lanes<2> t27_lanes = 1065.380700001509 * t18_lanes;
  const Lanes<2> t28_lanes = t16_lanes * t11_lanes;
  const Lanes<2> t32_lanes = 0.0008675855653090935 - t24_lanes;

  // links 10, 13, 17, 20, articulated inertia
  const Lanes<2> t34_lanes = detail::make_pack<Real>(c13, c20) * t17_lanes -
      detail::make_pack<Real>(1.0315081040638942e-05, (-1.0315081040638942e-05));
  const Lanes<2> t36_lanes = 7.104604309021728e-05 + t24_lanes;
  const Lanes<2> t37_lanes = 0.0025100003499999995 - t16_lanes * t9_lanes;
  const Lanes<2> t39_lanes = 2.0 * detail::make_pack<Real>(c10, c17);
  const Lanes<2> t44_lanes = detail::make_pack<Real>((-2.4000000000000003e-06),
      2.4000000000000003e-06) - (t34_lanes + t18_lanes * t23_lanes);

  // links 12 (left_wrist2) and 19 (right_wrist2), articulated inertia
  const Lanes<2> inverse_D12_19_lanes = 1.0 / (0.000206827662257343 +
      (t32_lanes - t16_lanes * t23_lanes));
  const Lanes<2> t46_lanes = t44_lanes * inverse_D12_19_lanes;
  const Lanes<2> t47_lanes = t37_lanes * inverse_D12_19_lanes;
  const Lanes<2> t48_lanes = t19_lanes * inverse_D12_19_lanes;
  const Lanes<2> t49_lanes = t28_lanes * inverse_D12_19_lanes;
  const Lanes<2> t55_lanes = t19_lanes * t47_lanes;
  const Lanes<2> t56_lanes = t19_lanes * t48_lanes;
  const Lanes<2> t59_lanes = t19_lanes * t49_lanes;
  const Lanes<2> t60_lanes = 0.000195227662257343 + (t36_lanes - t18_lanes * t27_lanes) -
      t44_lanes * t46_lanes;
  const Lanes<2> t61_lanes = t18_lanes * t9_lanes + t44_lanes * t47_lanes;
  const Lanes<2> t62_lanes = t12_lanes + t44_lanes * t48_lanes;
  const Lanes<2> t63_lanes = t18_lanes * t11_lanes - 0.0025100003499999995 - t44_lanes * t49_lanes;
  const Lanes<2> t64_lanes = t12_lanes * t9_lanes + t37_lanes * t47_lanes;
  const Lanes<2> t66_lanes = t12_lanes * t11_lanes - t37_lanes * t49_lanes;
  const Lanes<2> t67_lanes = t10_lanes * t11_lanes + t28_lanes * t49_lanes;
  const Lanes<2> t80_lanes = detail::make_pack<Real>(s12, s19) * (1.16e-05 - t60_lanes);
  const Lanes<2> t81_lanes = detail::make_pack<Real>(s12, s19) * t61_lanes +
      detail::make_pack<Real>(c12, c19) * t62_lanes;
  const Lanes<2> t82_lanes = 0.0006000000000000001 * detail::make_pack<Real>(s12, s19) +
      detail::make_pack<Real>(c12, c19) * t63_lanes;
  const Lanes<2> t84_lanes = detail::make_pack<Real>(s12, s19) * t63_lanes - 0.0006000000000000001 *
      detail::make_pack<Real>(c12, c19);
  const Lanes<2> t85_lanes = detail::make_pack<Real>(s12, s19) * t66_lanes -
      detail::make_pack<Real>(c12, c19) * t59_lanes;
  const Lanes<2> t86_lanes = detail::make_pack<Real>(s12, s19) * t59_lanes +
      detail::make_pack<Real>(c12, c19) * t66_lanes;
  const Lanes<2> t87_lanes = detail::make_pack<Real>(s12, s19) * t80_lanes;
  const Lanes<2> t88_lanes = detail::make_pack<Real>(c12, c19) * t81_lanes;
  const Lanes<2> t91_lanes = detail::make_pack<Real>(s12, s19) * (t64_lanes - t56_lanes) +
      detail::make_pack<Real>(c12, c19) * (2.0 * t55_lanes);
  const Lanes<2> t92_lanes = t84_lanes + 0.269 * t67_lanes;
  const Lanes<2> t93_lanes = detail::make_pack<Real>(s12, s19) * t81_lanes;
  const Lanes<2> t94_lanes = 0.269 * t85_lanes;
  const Lanes<2> t95_lanes = 6e-04 - t82_lanes;
  const Lanes<2> t100_lanes = detail::make_pack<Real>(s12, s19) * t91_lanes;
  const Lanes<2> t102_lanes = t93_lanes + t94_lanes;
  const Lanes<2> t104_lanes = detail::make_pack<Real>(0.001, (-0.001)) + t88_lanes;
  const Lanes<2> t106_lanes = t93_lanes - t61_lanes;
  const Lanes<2> t109_lanes = 0.000144 - (detail::make_pack<Real>(c12, c19) * t80_lanes + 0.269 *
      t82_lanes);
  const Lanes<2> t110_lanes = detail::make_pack<Real>(0.0002516, (-0.0002516)) + 0.269 * t88_lanes;
  const Lanes<2> t111_lanes = t56_lanes + t100_lanes;

  // links 11 and 12, 18 and 19, articulated inertia
  const Lanes<2> inverse_D11_18_lanes = 1.0 / (0.00022920000000000001 + (t60_lanes + t87_lanes));
  const Lanes<2> t115_lanes = detail::make_pack<Real>(c12, c19) * t91_lanes - t55_lanes;
  const Lanes<2> t124_lanes = t109_lanes * inverse_D11_18_lanes;
  const Lanes<2> t125_lanes = t110_lanes * inverse_D11_18_lanes;
  const Lanes<2> t126_lanes = t104_lanes * inverse_D11_18_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), articulated inertia
  const Lanes<2> t127_lanes = t95_lanes * inverse_D11_18_lanes;
  const Lanes<2> t128_lanes = t106_lanes * inverse_D11_18_lanes;
  const Lanes<2> t145_lanes = 0.000131 - t87_lanes - 0.269 * (t84_lanes + t92_lanes) - t109_lanes *
      t124_lanes;
  const Lanes<2> t146_lanes = 0.0001098 - 0.07236100000000001 * t111_lanes - t110_lanes *
      t125_lanes;
  const Lanes<2> t147_lanes = detail::make_pack<Real>((-6e-06), 6e-06) + 0.269 * t102_lanes -
      t109_lanes * t125_lanes;
  const Lanes<2> t148_lanes = t109_lanes * t126_lanes - t102_lanes;
  const Lanes<2> t149_lanes = t94_lanes - t110_lanes * t127_lanes;
  const Lanes<2> t150_lanes = 0.269 * t111_lanes + t110_lanes * t126_lanes;
  const Lanes<2> t151_lanes = t92_lanes + t109_lanes * t127_lanes;
  const Lanes<2> t152_lanes = detail::make_pack<Real>(0.001, (-0.001)) -
      (t88_lanes - t62_lanes + 0.269 * t86_lanes) - t109_lanes * t128_lanes;
  const Lanes<2> t153_lanes = 0.269 * t115_lanes - 6e-04 - t110_lanes * t128_lanes;
  const Lanes<2> t154_lanes = t111_lanes + t104_lanes * t126_lanes;
  const Lanes<2> t155_lanes = t67_lanes + t95_lanes * t127_lanes;
  const Lanes<2> t156_lanes = t104_lanes * t127_lanes - t85_lanes;
  const Lanes<2> t159_lanes = t104_lanes * t128_lanes - t115_lanes;
  const Lanes<2> t160_lanes = t86_lanes + t95_lanes * t128_lanes;
  const Lanes<2> t180_lanes = detail::make_pack<Real>(s11, s18) * (t145_lanes - t146_lanes) +
      t15_lanes * t147_lanes;
  const Lanes<2> t182_lanes = detail::make_pack<Real>(s11, s18) * (t148_lanes - t149_lanes) +
      detail::make_pack<Real>(c11, c18) * (t150_lanes - t151_lanes);
  const Lanes<2> t184_lanes = 0.0014999985000000002 -
      (detail::make_pack<Real>(s11, s18) * t152_lanes + detail::make_pack<Real>(c11, c18) *
      t153_lanes);
  const Lanes<2> t185_lanes = detail::make_pack<Real>(s11, s18) * (t155_lanes - t154_lanes) +
      t15_lanes * t156_lanes;
  const Lanes<2> t186_lanes = detail::make_pack<Real>(s11, s18) * t180_lanes;
  const Lanes<2> t188_lanes = detail::make_pack<Real>(c11, c18) * t182_lanes;
  const Lanes<2> t189_lanes = detail::make_pack<Real>(s11, s18) * t182_lanes;
  const Lanes<2> t190_lanes = detail::make_pack<Real>(s11, s18) * t185_lanes;

  // links 9, 11, 16, 18, articulated inertia
  const Lanes<2> t196_lanes = t149_lanes + t189_lanes;
  const Lanes<2> t202_lanes = 2.0 * detail::make_pack<Real>(s9, s16);
  const Lanes<2> t203_lanes = 0.060888541114265754 + (t146_lanes + t186_lanes);
  const Lanes<2> t204_lanes = detail::make_pack<Real>((-2.249994685315e-05), 2.249994685315e-05) +
      (detail::make_pack<Real>(c11, c18) * t180_lanes - t147_lanes);
  const Lanes<2> t206_lanes = t188_lanes + t151_lanes - 0.28049749700000004;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), articulated inertia
  const Lanes<2> inverse_D10_17_lanes = 1.0 / t203_lanes;
  const Lanes<2> t208_lanes = detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) /
      t203_lanes;
  const Lanes<2> t210_lanes = t204_lanes * inverse_D10_17_lanes;
  const Lanes<2> t212_lanes = 0.00028099984685315 -
      detail::make_pack<Real>(2.249996661190239e-08, 2.249996661190239e-08) / t203_lanes;
  const Lanes<2> t213_lanes = t206_lanes * inverse_D10_17_lanes;
  const Lanes<2> t214_lanes = t184_lanes * inverse_D10_17_lanes;
  const Lanes<2> t215_lanes = t196_lanes * inverse_D10_17_lanes;
  const Lanes<2> t217_lanes = 0.0001499998887063 + t204_lanes * t208_lanes;
  const Lanes<2> t219_lanes = detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) *
      t213_lanes;
  const Lanes<2> t221_lanes = detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) *
      t214_lanes;
  const Lanes<2> t231_lanes = 0.06060754126741261 + (t145_lanes - t186_lanes) - t204_lanes *
      t210_lanes;
  const Lanes<2> t232_lanes = t148_lanes - t189_lanes - t204_lanes * t213_lanes;
  const Lanes<2> t233_lanes = detail::make_pack<Real>(c11, c18) * t152_lanes -
      detail::make_pack<Real>(s11, s18) * t153_lanes + t204_lanes * t214_lanes;
  const Lanes<2> t234_lanes = 0.28049749700000004 + (t188_lanes - t150_lanes) - t204_lanes *
      t215_lanes;
  const Lanes<2> t235_lanes = 0.0014999985000000002 +
      detail::make_pack<Real>((-0.0001499998887063), 0.0001499998887063) * t215_lanes;
  const Lanes<2> t236_lanes = t154_lanes + t190_lanes + t206_lanes * t213_lanes;
  const Lanes<2> t237_lanes = t100_lanes - t64_lanes - t106_lanes * t128_lanes - t184_lanes *
      t214_lanes;
  const Lanes<2> t238_lanes = detail::make_pack<Real>(c11, c18) * t159_lanes +
      detail::make_pack<Real>(s11, s18) * t160_lanes + t206_lanes * t214_lanes;
  const Lanes<2> t239_lanes = t190_lanes - t155_lanes - t196_lanes * t215_lanes;
  const Lanes<2> t242_lanes = detail::make_pack<Real>(c11, c18) * t185_lanes - t156_lanes -
      t206_lanes * t215_lanes;
  const Lanes<2> t243_lanes = detail::make_pack<Real>(s11, s18) * t159_lanes -
      detail::make_pack<Real>(c11, c18) * t160_lanes + t184_lanes * t215_lanes;
  const Lanes<2> t259_lanes = detail::make_pack<Real>(c10, c17) * t235_lanes -
      detail::make_pack<Real>(s10, s17) * t234_lanes;

  // links 8, 10, 15, 17, articulated inertia
  const Lanes<2> t261_lanes = 2.0 * detail::make_pack<Real>(c8, c15);
  const Lanes<2> t262_lanes = detail::make_pack<Real>(c10, c17) * t234_lanes +
      detail::make_pack<Real>(s10, s17) * t235_lanes;
  const Lanes<2> t263_lanes = t39_lanes * t217_lanes - detail::make_pack<Real>(s10, s17) *
      (t231_lanes - t212_lanes);
  const Lanes<2> t264_lanes = detail::make_pack<Real>(c10, c17) * t242_lanes +
      detail::make_pack<Real>(s10, s17) * t243_lanes;
  const Lanes<2> t265_lanes = detail::make_pack<Real>(c10, c17) * (t219_lanes + t233_lanes) -
      detail::make_pack<Real>(s10, s17) * (t232_lanes + t221_lanes);

  // links 10 (left_lowerarm) and 17 (right_lowerarm), articulated inertia
  const Lanes<2> t267_lanes = t259_lanes - 0.0022500062;
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
  const Lanes<2> t299_lanes = 0.282 * t259_lanes - (t217_lanes - detail::make_pack<Real>(c10, c17) *
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
  const Lanes<2> t329_lanes = 0.0019585440854647937 +
      (t231_lanes + t271_lanes + 0.282 * (t262_lanes + t270_lanes)) - t313_lanes;
  const Lanes<2> t330_lanes = 0.0008177492704690715 + 0.07952399999999998 * t287_lanes -
      t302_lanes * t309_lanes;
  const Lanes<2> t331_lanes = detail::make_pack<Real>(4.4999986458742003e-05,
      (-4.4999986458742003e-05)) - 0.282 * t293_lanes - t299_lanes * t309_lanes;
  const Lanes<2> t332_lanes = t293_lanes + t299_lanes * t310_lanes;
  const Lanes<2> t333_lanes = t273_lanes + t302_lanes * t311_lanes;
  const Lanes<2> t334_lanes = t302_lanes * t310_lanes - 0.282 * t287_lanes;
  const Lanes<2> t335_lanes = t270_lanes - t299_lanes * t311_lanes;
  const Lanes<2> t336_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) +
      (0.282 * t268_lanes - (t219_lanes - t274_lanes)) + t299_lanes * t312_lanes;
  const Lanes<2> t337_lanes = 0.0022500062 + 0.282 * t288_lanes + t302_lanes * t312_lanes;
  const Lanes<2> t338_lanes = t287_lanes - t294_lanes * t310_lanes;
  const Lanes<2> t339_lanes = t239_lanes - t267_lanes * t311_lanes;
  const Lanes<2> t340_lanes = t264_lanes + t294_lanes * t311_lanes;
  const Lanes<2> t343_lanes = t288_lanes + t294_lanes * t312_lanes;

  // links 7, 9, 14, 16, articulated inertia
  const Lanes<2> t344_lanes = t268_lanes + t267_lanes * t312_lanes;
  const Lanes<2> t362_lanes = 2.0 * detail::make_pack<Real>(s7, s14);
  const Lanes<2> t365_lanes = detail::make_pack<Real>(c9, c16) * (t329_lanes - t330_lanes) -
      t202_lanes * t331_lanes;
  const Lanes<2> t367_lanes = detail::make_pack<Real>(c9, c16) * (t332_lanes + t333_lanes) -
      detail::make_pack<Real>(s9, s16) * (t334_lanes + t335_lanes);
  const Lanes<2> t369_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + (detail::make_pack<Real>(c9, c16) * t336_lanes -
      detail::make_pack<Real>(s9, s16) * t337_lanes);

  // links 9 (left_upperarm) and 16 (right_upperarm), articulated inertia
  const Lanes<2> t370_lanes = detail::make_pack<Real>(c9, c16) * (t338_lanes - t339_lanes) -
      t202_lanes * t340_lanes;
  const Lanes<2> t371_lanes = detail::make_pack<Real>(c9, c16) * t365_lanes;
  const Lanes<2> t373_lanes = detail::make_pack<Real>(s9, s16) * t367_lanes;
  const Lanes<2> t374_lanes = detail::make_pack<Real>(c9, c16) * t367_lanes;
  const Lanes<2> t375_lanes = detail::make_pack<Real>(c9, c16) * t370_lanes;

  // links 9, 16, 23 and 24, articulated inertia
  const Lanes<2> t379_lanes = 0.0007770270270270272 * detail::make_pack<Real>(c23, c24);
  const Lanes<2> t383_lanes = t374_lanes - t333_lanes;
  const Lanes<2> t384_lanes = 9.060810810810813e-05 * detail::make_pack<Real>(s23, s24);
  const Real t388 = c24 + c23;
  const Lanes<2> t389_lanes = 0.18125194219699997 + (t330_lanes + t371_lanes);
  const Lanes<2> t390_lanes = detail::make_pack<Real>((-1.75e-05), 1.75e-05) +
      (detail::make_pack<Real>(s9, s16) * t365_lanes + t331_lanes);
  const Lanes<2> t393_lanes = detail::make_pack<Real>(c23, c24) * t379_lanes;
  const Lanes<2> t394_lanes = 0.7139200499999999 + (t373_lanes + t335_lanes);

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
  const Lanes<2> t415_lanes = t369_lanes * inverse_D8_15_lanes;
  const Lanes<2> t416_lanes = t394_lanes * inverse_D8_15_lanes;
  const Lanes<2> t419_lanes = t383_lanes * inverse_D8_15_lanes;
  const Lanes<2> t424_lanes = 0.095 * t410_lanes + detail::make_pack<Real>(0.032, (-0.032)) *
      t411_lanes;
  const Lanes<2> t425_lanes = t411_lanes - 0.006756756756756758;

  // links 8, 15, 22, articulated inertia
  const Lanes<2> t426_lanes = 0.00010499999999999999 * t416_lanes;
  const Lanes<2> t428_lanes = 0.00010499999999999999 * t415_lanes;
  const Lanes<2> t435_lanes = 0.18113119219699997 + (t329_lanes - t371_lanes) - t390_lanes *
      t413_lanes;
  const Lanes<2> t436_lanes = detail::make_pack<Real>((-5.2499999999999995e-05),
      5.2499999999999995e-05) + 0.00010499999999999999 * t413_lanes;
  const Lanes<2> t437_lanes = t390_lanes * t415_lanes -
      (detail::make_pack<Real>(s9, s16) * t336_lanes + detail::make_pack<Real>(c9, c16) *
      t337_lanes);
  const Lanes<2> t438_lanes = t332_lanes - t374_lanes - t390_lanes * t416_lanes;
  const Lanes<2> t439_lanes = t373_lanes + t334_lanes - 0.7139200499999999 - t390_lanes *
      t419_lanes;
  const Real t441 = t393_lanes[1] + t393_lanes[0];
  const Lanes<2> t442_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) + 0.00010499999999999999 * t419_lanes;
  const Real t443 = t412 * inverse_D22;
  const Real t444 = t409 * inverse_D22;

  // links 22 to 24, articulated inertia
  const Lanes<2> t445_lanes = 0.095 * t425_lanes - detail::make_pack<Real>(0.032, (-0.032)) *
      t410_lanes;
  const Real t447 = 2.0 * c22;
  const Real t448 = t406 * inverse_D22;
  const Real t449 = t408 * inverse_D22;
  const Real t451 = t445_lanes[1] + t445_lanes[0];
  const Real t454 = t404 * inverse_D22;

  // links 8, 15, 22, articulated inertia
  const Lanes<2> t455_lanes = detail::make_pack<Real>(s8, s15) * (t414_lanes - t435_lanes) +
      t261_lanes * t436_lanes;
  const Real t458 = t412 * t449;
  const Lanes<2> t459_lanes = t338_lanes - t375_lanes - t394_lanes * t416_lanes;
  const Lanes<2> t460_lanes = t237_lanes - t277_lanes - t286_lanes * t312_lanes - t369_lanes *
      t415_lanes;
  const Lanes<2> t461_lanes = detail::make_pack<Real>(s8, s15) * t455_lanes;
  const Real t462 = t409 * t448 - t404;
  const Real t463 = t424_lanes[1] + t424_lanes[0] + t412 * t448;
  const Real t464 = t409 * t449 - 0.00025 * t395;
  const Lanes<2> t465_lanes = detail::make_pack<Real>(c8, c15) * (t437_lanes + t426_lanes) -
      detail::make_pack<Real>(s8, s15) * (t428_lanes + t438_lanes);
  const Real t467 = J_22_yy - (-0.032) * t424_lanes[1] - 0.032 * t424_lanes[0] - t412 * t443 +
      0.095 * t451;
  const Real t468 = J_22_xx + t403 + (-1.6000000000000003e-05) * s24 + 1.6000000000000003e-05 *
      s23 - t409 * t444 - 0.00017071621621621627;
  const Real t469 = J_22_xy - (-0.032) * t399_lanes[1] - 0.032 * t399_lanes[0] + t409 * t443 -
      0.095 * t441;
  const Lanes<2> t472_lanes = detail::make_pack<Real>(c8, c15) * t465_lanes;
  const Lanes<2> t474_lanes = detail::make_pack<Real>(s9, s16) * t343_lanes -
      detail::make_pack<Real>(c9, c16) * t344_lanes + t369_lanes * t416_lanes;
  const Real t475 = h_22_x + t451 + t412 * t454;
  const Real t476 = t441 - minus_h_22_y + t409 * t454;
  const Real t477 = t408 * t449;
  const Real t478 = t411_lanes[1] + t411_lanes[0] + t406 * t448;
  const Lanes<2> t479_lanes = 0.000448 + (t435_lanes + t461_lanes);
  const Real t484 = t406 * t449;

  // links 7 and 8, 14 and 15, 22, articulated inertia
  const Lanes<2> inverse_D7_14_lanes = 1.0 / t479_lanes;
  const Lanes<2> t487_lanes = 0.0017499999999999998 +
      (detail::make_pack<Real>(s8, s15) * t442_lanes + detail::make_pack<Real>(c8, c15) *
      t439_lanes);
  const Real t488 = s22 * (t462 + t458) + c22 * (t464 - t463);
  const Lanes<2> t489_lanes = 0.0017499999999999998 + (t472_lanes - t426_lanes);
  const Lanes<2> t490_lanes = detail::make_pack<Real>(s8, s15) * (t460_lanes - t459_lanes) +
      t261_lanes * t474_lanes;

  // links 8, 15, 22, articulated inertia
  const Real t491 = t408 * t454;
  const Real t492 = s22 * (t468 - t467) + t447 * t469;
  const Real t493 = c22 * t475 - s22 * t476;
  const Real t494 = c22 * t488;
  const Lanes<2> t496_lanes = detail::make_pack<Real>(s8, s15) * t490_lanes;
  const Real t498 = s22 * t492;
  const Lanes<2> t499_lanes = detail::make_pack<Real>(s9, s16) * t370_lanes + t340_lanes -
      t394_lanes * t419_lanes;
  const Lanes<2> t500_lanes = detail::make_pack<Real>(c9, c16) * t343_lanes +
      detail::make_pack<Real>(s9, s16) * t344_lanes + t369_lanes * t419_lanes;
  const Real t501 = t425_lanes[1] + t425_lanes[0] - t404 * t454;
  const Real t502 = c22 * t476 + s22 * t475;
  const Real t503 = t410_lanes[1] + t410_lanes[0] - t406 * t454;
  const Real t504 = t447 * t484 - s22 * (t477 - t478);
  const Lanes<2> t505_lanes = detail::make_pack<Real>(s8, s15) * t465_lanes;
  const Real t510 = t494 - t464;
  const Real t514 = s22 * t504;
  const Lanes<2> t515_lanes = t438_lanes + t505_lanes;
  const Real t516 = link21_to_22_z * t510;
  const Lanes<2> t517_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) + (detail::make_pack<Real>(c8, c15) * t455_lanes - t436_lanes);
  const Real t518 = s22 * t488;

  // links 7, 14, 21 and 22, articulated inertia
  const Lanes<2> t520_lanes = detail::make_pack<Real>(6.890624999999999e-10,
      6.890624999999999e-10) / t479_lanes;
  const Lanes<2> t521_lanes = t489_lanes * inverse_D7_14_lanes;
  const Lanes<2> t522_lanes = t487_lanes * inverse_D7_14_lanes;
  const Real t523 = t502 - link21_to_22_z * t501;
  const Real t524 = c22 * t503 + s22 * t491;
  const Real t525 = t514 - t478;
  const Lanes<2> t526_lanes = t515_lanes * inverse_D7_14_lanes;
  const Real inverse_D21 = 1.0 / (J_21_zz + (t467 + t498));
  const Real t528 = minus_J_21_xz + (c22 * t492 - t469 + link21_to_22_z * t493);
  const Real t538 = link21_to_22_z * t524;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), articulated inertia
  const Lanes<2> t539_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * t522_lanes;
  const Lanes<2> t540_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * t521_lanes;
  const Lanes<2> t543_lanes = t517_lanes * inverse_D7_14_lanes;
  const Lanes<2> t547_lanes = t460_lanes - t496_lanes - t489_lanes * t521_lanes;
  const Lanes<2> t548_lanes = t339_lanes + t375_lanes - t383_lanes * t419_lanes - t487_lanes *
      t522_lanes;
  const Lanes<2> t549_lanes = detail::make_pack<Real>(c8, c15) * t500_lanes -
      detail::make_pack<Real>(s8, s15) * t499_lanes - t487_lanes * t521_lanes;
  const Lanes<2> t550_lanes = t428_lanes + t505_lanes + t517_lanes * t521_lanes;
  const Lanes<2> t551_lanes = detail::make_pack<Real>(c8, c15) * t442_lanes -
      detail::make_pack<Real>(s8, s15) * t439_lanes - t517_lanes * t522_lanes;

  // links 7, 14, 21 and 22, articulated inertia
  const Real t552 = t462 - t518 - t538;
  const Real t553 = 2.0 * s21;
  const Lanes<2> t554_lanes = detail::make_pack<Real>(c8, c15) * t490_lanes - t474_lanes -
      t489_lanes * t526_lanes;
  const Lanes<2> t555_lanes = detail::make_pack<Real>(s8, s15) * t500_lanes +
      detail::make_pack<Real>(c8, c15) * t499_lanes - t487_lanes * t526_lanes;
  const Lanes<2> t563_lanes = 0.0001505 - t520_lanes;
  const Real t571 = t528 * inverse_D21;
  const Real t572 = t516 * inverse_D21;
  const Lanes<2> t574_lanes = 0.0002975 + (t414_lanes - t461_lanes) - t517_lanes * t543_lanes;
  const Lanes<2> t576_lanes = 8.75e-06 + detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) * t543_lanes;
  const Lanes<2> t579_lanes = detail::make_pack<Real>(s7, s14) * t555_lanes +
      detail::make_pack<Real>(c7, c14) * t554_lanes;
  const Real t582 = h_21_x + t493;

  // links 7, 14, 21, articulated inertia
  const Lanes<2> t583_lanes = detail::make_pack<Real>(c7, c14) * (t548_lanes - t547_lanes) -
      t362_lanes * t549_lanes;
  const Real t585 = t510 * inverse_D21;
  const Lanes<2> t586_lanes = detail::make_pack<Real>(c7, c14) * (t550_lanes - t539_lanes) -
      detail::make_pack<Real>(s7, s14) * (t551_lanes - t540_lanes);
  const Lanes<2> t589_lanes = t459_lanes + t496_lanes - t515_lanes * t526_lanes;
  const Lanes<2> t590_lanes = t472_lanes - t437_lanes - 0.0017499999999999998 - t517_lanes *
      t526_lanes;
  const Lanes<2> t591_lanes = detail::make_pack<Real>(c7, c14) * t583_lanes;
  const Lanes<2> t593_lanes = 0.0017499999999999998 +
      detail::make_pack<Real>((-2.6249999999999998e-05), 2.6249999999999998e-05) * t526_lanes;
  const Lanes<2> t595_lanes = detail::make_pack<Real>(s7, s14) * t586_lanes;
  const Lanes<2> t597_lanes = detail::make_pack<Real>(c7, c14) * t555_lanes -
      detail::make_pack<Real>(s7, s14) * t554_lanes;
  const Lanes<2> t598_lanes = detail::make_pack<Real>(c7, c14) * t586_lanes;
  const Real t599 = J_21_xx + (t468 - t498 - link21_to_22_z * (t502 + t523)) - t528 * t571;
  const Real t600 = J_21_yy + 0.155236 * t525 - t516 * t572;
  const Real t601 = link21_to_22_z * t552 - t528 * t572;
  const Real t605 = t582 * inverse_D21;
  const Lanes<2> t606_lanes = t548_lanes - t591_lanes;
  const Lanes<2> t607_lanes = detail::make_pack<Real>(c7, c14) * (t563_lanes - t574_lanes) +
      t362_lanes * t576_lanes;
  const Lanes<2> t608_lanes = detail::make_pack<Real>(s7, s14) * t583_lanes + t549_lanes;
  const Lanes<2> t609_lanes = 0.226 * t597_lanes;
  const Lanes<2> t610_lanes = t540_lanes - t595_lanes;
  const Lanes<2> t613_lanes = t539_lanes + t598_lanes;
  const Lanes<2> t615_lanes = detail::make_pack<Real>(c7, c14) * t607_lanes;
  const Lanes<2> t616_lanes = detail::make_pack<Real>(c7, c14) * t593_lanes +
      detail::make_pack<Real>(s7, s14) * t590_lanes;
  const Lanes<2> t617_lanes = detail::make_pack<Real>(0.18, (-0.18)) * t608_lanes;
  const Real t618 = t552 - t528 * t585;
  const Lanes<2> t619_lanes = detail::make_pack<Real>(s7, s14) * t607_lanes;
  const Lanes<2> t620_lanes = t616_lanes + (detail::make_pack<Real>(0.18, (-0.18)) * t579_lanes +
      0.226 * t589_lanes);
  const Real t621 = link21_to_22_z * t525 - t516 * t585;

  // links 7, 21 and 22, articulated inertia
  const Real t622 = t518 - t458;
  const Real t625 = t615_lanes[1] + t615_lanes[0];
  const Real t628 = c21 * (t599 - t600) - t553 * t601;
  const Real t629 = t538 + t516 * t605;
  const Real t630 = t523 + t528 * t605;
  const Real t631 = t620_lanes[1] + t620_lanes[0];

  // links 7, 14, 22, articulated inertia
  const Real t632 = c22 * t491 - s22 * t503;
  const Lanes<2> t633_lanes = t547_lanes + t591_lanes;
  const Real t634 = t484 - c22 * t504;
  const Lanes<2> t635_lanes = t610_lanes + (detail::make_pack<Real>(0.18, (-0.18)) * t606_lanes +
      0.226 * t579_lanes);
  const Lanes<2> t636_lanes = t598_lanes - t550_lanes - (t617_lanes + t609_lanes);

  // links 7, 14, 21, articulated inertia
  const Real t637 = t622 * inverse_D21;
  const Real t638 = c21 * t628;
  const Lanes<2> t639_lanes = t595_lanes + t551_lanes;
  const Lanes<2> t643_lanes = detail::make_pack<Real>(s7, s14) * t593_lanes -
      detail::make_pack<Real>(c7, c14) * t590_lanes;
  const Real t644 = t636_lanes[1] + t636_lanes[0];
  const Real t645 = t525 - t510 * t585;
  const Lanes<2> t646_lanes = detail::make_pack<Real>(0.18, (-0.18)) * (t610_lanes + t635_lanes);
  const Lanes<2> t647_lanes = detail::make_pack<Real>(0.18, (-0.18)) * (t636_lanes + t613_lanes);
  const Real t648 = t501 - t582 * t605;
  const Lanes<2> t649_lanes = t639_lanes + detail::make_pack<Real>(0.18, (-0.18)) * t633_lanes;
  const Real t650 = t643_lanes[1] + t643_lanes[0];

  // link 21 (neck), articulated inertia
  const Real t651 = c21 * (t618 - t629) - s21 * (t621 + t630);
  const Real t652 = t524 + t510 * t605;
  const Real t654 = c21 * t651;
  const Real t655 = t528 * t637 - (t494 + t463 + link21_to_22_z * t632);
  const Real t656 = s21 * t651;
  const Real t657 = t516 * t637 - (h_21_x + link21_to_22_z * t634);

  // links 6 and 7, 14, 21, articulated inertia
  const Real t658 = s21 * t628 + t601 + 0.226 * t644;
  const Lanes<2> t659_lanes = detail::make_pack<Real>(0.18, (-0.18)) * (t639_lanes + t649_lanes);
  const Real t660 = t633_lanes[1] + t633_lanes[0];
  const Real t661 = c21 * (t645 - t648) - t553 * t652;
  const Real t662 = t629 + t654 + t644;
  const Real t663 = c21 * t661;
  const Real t664 = 2.0 * c6;
  const Real t665 = J_6_zz + t600 + t638 + t574_lanes[1] + t625 + t646_lanes[1] + t574_lanes[0] +
      t646_lanes[0] + 0.226 * (t616_lanes[1] + t631 + t616_lanes[0]);
  const Real t666 = t656 + t630 - minus_h_6_x - t631;
  const Real t667 = t608_lanes[1] + t608_lanes[0];
  const Real t668 = t510 * t637 - t634;
  const Real t669 = c21 * t655 - s21 * t657 + t635_lanes[1] + t635_lanes[0];
  const Lanes<2> t670_lanes = t617_lanes - t613_lanes;
  const Real inverse_D6 = 1.0 / t665;
  const Real t671 = J_6_xz + t647_lanes[1] - t576_lanes[1] + t619_lanes[1] + t647_lanes[0] -
      t576_lanes[0] + t619_lanes[0] + 0.226 * t650;
  const Real t672 = t632 - t582 * t637;

  // links 5 (chest2) and 6 (chest3), articulated inertia
  const Real t673 = t662 * inverse_D6;
  const Real t674 = t658 * inverse_D6;
  const Real t675 = t671 * inverse_D6;
  const Real t676 = t669 * inverse_D6;
  const Real t677 = t666 * inverse_D6;
  const Real t678 = 2.0 * c5;

  // link 6 (chest3), articulated inertia
  const Real t679 = t649_lanes[1] + t649_lanes[0] - t671 * t673;
  const Real t680 = 0.40056549999999996 - t520_lanes[1] - t625 + t659_lanes[1] + t563_lanes[0] +
      t659_lanes[0] - t671 * t675;
  const Real t681 = t648 + t663 + t660 - t662 * t673;
  const Real t682 = t670_lanes[1] + t670_lanes[0] + t671 * t676;
  const Real t683 = t618 - t654 + t609_lanes[1] + t609_lanes[0] - t658 * t677;
  const Real t684 = (-0.18) * t597_lanes[1] - t650 + 0.18 * t597_lanes[0] - t671 * t677;
  const Real t685 = t667 - c21 * t668 + s21 * t672 + t669 * t673;
  const Real t686 = s21 * t661 + t652 + t597_lanes[1] + t597_lanes[0] - t666 * t673;
  const Real t687 = minus_h_6_x + t656 + t621 - t658 * t673 + 0.226 * t660;
  const Real t688 = J_6_yy + t599 - t638 - t658 * t674 + 0.051076 * t660;
  const Real t689 = t606_lanes[1] - (t477 + t514 + t622 * t637) + t606_lanes[0] - t669 * t676;
  const Real t690 = (-0.04068) * t633_lanes[1] + 0.04068 * t633_lanes[0] - t671 * t674 + 0.226 *
      (t639_lanes[1] + t639_lanes[0]);
  const Real t691 = t658 * t676 - (s21 * t655 + c21 * t657) + 0.226 * t667;
  const Real t692 = t645 - t663 + t589_lanes[1] + t589_lanes[0] - t666 * t677;
  const Real t693 = t579_lanes[1] - (s21 * t668 + c21 * t672) + t579_lanes[0] + t669 * t677;
  const Real t694 = c6 * t685 - s6 * t686;
  const Real t695 = s6 * t679 + c6 * t687;
  const Real t696 = s6 * t685 + c6 * t686;
  const Real t697 = c6 * t679 - s6 * t687;
  const Real t698 = minus_h_4_x * s4;
  const Real t699 = t695 + minus_link5_to_6_y * t681;
  const Real t700 = s6 * (t680 - t688) + t664 * t690;
  const Real t701 = minus_link5_to_6_y * t696;
  const Real t702 = s6 * (t682 - t683) + c6 * (t691 + t684);
  const Real t703 = s6 * (t689 - t692) + t664 * t693;
  const Real t704 = s6 * t700;
  const Real t705 = minus_h_5_y + t699;
  const Real t706 = c6 * t702;
  const Real t707 = s6 * t702;
  const Real t708 = s6 * t703;
  const Real t709 = 0.03561389675370483 * s4;
  const Real t710 = c6 * t703 - t693;
  const Real t711 = t692 + t708;
  const Real t712 = t706 - t691;
  const Real t713 = c6 * t700 - t690 + minus_link5_to_6_y * t697;
  const Real t714 = t683 + t707 + t701;
  const Real t715 = minus_h_4_x * c4;
  const Real t716 = h_5_x + (t706 - t684 + minus_link5_to_6_y * t694);
  const Real t717 = minus_link5_to_6_y * t714;

  // links 4 (chest1) and 5 (chest2), articulated inertia
  const Real inverse_D5 = 1.0 / (J_5_zz + (t688 + t704 + minus_link5_to_6_y * (t695 + t699)));
  const Real t718 = minus_h_3_x + t715;
  const Real t719 = t705 * inverse_D5;
  const Real t720 = t716 * inverse_D5;
  const Real t721 = t714 * inverse_D5;

  // link 5 (chest2), articulated inertia
  const Real t722 = t717 * inverse_D5;
  const Real t723 = t713 * inverse_D5;
  const Real t724 = t689 - t708 - t716 * t720;
  const Real t725 = t681 - t705 * t719;
  const Real t726 = t694 - t705 * t720;
  const Real t727 = minus_link2_to_3_y * c2;
  const Real s2_plus_3 = s2 * c3 + c2 * s3;
  const Real t728 = t717 * t719 - t701;
  const Real t729 = t682 - t707 - t713 * t720;
  const Real t730 = minus_link2_to_3_y * s2;
  const Real t731 = t697 - t713 * t719;
  const Real t732 = t717 * t720 - minus_link5_to_6_y * t710;
  const Real t733 = t710 - t716 * t721;
  const Real t734 = t696 - t705 * t721;
  const Real c2_plus_3 = c2 * c3 - s2 * s3;
  const Real t735 = J_5_xx + 0.005183999999999999 * t711 - t717 * t722;
  const Real t736 = J_5_yy + (t680 - t704) - t713 * t723;
  const Real t737 = J_5_xy - minus_link5_to_6_y * t712 + t717 * t723;

  // links 2 (thigh) and 3 (hip), outward; link 5 (chest2), articulated inertia
  const Real w2_z = qd[0] + qd[1];
  const Real t738 = t712 - h_5_x - t713 * t721;
  const Real t739 = t717 * t721 - (minus_h_5_y + minus_link5_to_6_y * t711);
  const Real w3_z = w2_z + qd[2];
  const Real t740 = s5 * (t725 - t724) + t678 * t726;

  // link 5 (chest2), articulated inertia and outward
  const Real t741 = s5 * (t728 - t729) + c5 * (t731 + t732);
  const Real t742 = s4 * w3_z;
  const Real t743 = s5 * t740;
  const Real t744 = s5 * (t735 - t736) + t678 * t737;
  const Real t745 = h_2_x * s2 - minus_h_2_y * c2;
  const Real t746 = s5 * t741;
  const Real t747 = s5 * t738 - c5 * t739;
  const Real t748 = c5 * t741;
  const Real w5_z = c4 * w3_z + qd[4];
  const Real t749 = t725 - t743;

  // links 4 (chest1) and 5 (chest2), outward; link 5 (chest2), articulated inertia
  const Real wd4_x = w3_z * qd[3];
  const Real t750 = s5 * t744;
  const Real minus_w5_y = s5 * t742 + c5 * qd[3];
  const Real w5_x = c5 * t742 - s5 * qd[3];
  const Real t751 = t729 + t746;
  const Real t752 = c4 * wd4_x;

  // links 5 (chest2) and 6 (chest3), outward; link 5 (chest2), articulated inertia
  const Real minus_wd5_z = s4 * wd4_x;
  const Real t753 = w5_x * minus_w5_y;
  const Real w6_z = w5_x + qd[5];
  const Real t754 = c4 * (2.0 * (s5 * t733 - c5 * t734)) - s4 * (t749 - (t711 - t714 * t721));
  const Real t755 = s4 * (s5 * t739 + c5 * t738) - c4 * (t748 - t732);

  // links 5 (chest2) and 6 (chest3), outward; link 4 (chest1), articulated inertia
  const Real t756 = t753 + minus_wd5_z;
  const Real w6_y = s6 * minus_w5_y + c6 * w5_z;
  const Real w6_x = s6 * w5_z - c6 * minus_w5_y;
  const Real inverse_D4 = 1.0 / (J_4_zz + (t736 + t750));
  const Real t759 = s5 * t752 + (w5_z + qd[4]) * w5_x;

  // links 5 to 7, 14, outward
  const Real wd5_x = c5 * t752 - minus_w5_y * qd[4];
  const Real t760 = w6_y * w6_z;
  const Real t762 = w6_x * w6_y;
  const Lanes<2> w7_14_z_lanes = w6_y + detail::make_pack<Real>(qd[6], qd[13]);
  const Real t764 = w6_x * w6_z;

  // link 5 (chest2), articulated inertia
  const Real t765 = t747 - c4 * (c4 * t747 - s4 * (t728 - t746));
  const Real t766 = t749 + s4 * t754;
  const Real t767 = link4_to_5_z * t755 + (J_4_xz - (c5 * t744 - t737)) * s4;
  const Real t768 = t698 + t755;
  const Real t769 = s4 * (s5 * t734 + c5 * t733) - c4 * (c5 * t740 - t726);

  // links 6 to 8, 14 and 15, outward
  const Lanes<2> w7_14_x_lanes = detail::make_pack<Real>(s7, s14) * w6_x +
      detail::make_pack<Real>(c7, c14) * w6_z;
  const Real t770 = t762 - wd5_x;
  const Lanes<2> w7_14_y_lanes = detail::make_pack<Real>(c7, c14) * w6_x -
      detail::make_pack<Real>(s7, s14) * w6_z;
  const Real t773 = s6 * t756 + c6 * t759;
  const Lanes<2> w8_15_z_lanes = w7_14_x_lanes + detail::make_pack<Real>(qd[7], qd[14]);
  const Lanes<2> t778_lanes = w7_14_x_lanes * w7_14_y_lanes;
  const Lanes<2> t780_lanes = w7_14_y_lanes * w7_14_z_lanes;

  // link 6 (chest3), outward; links 4 (chest1) and 5 (chest2), articulated inertia
  const Real wd6_x = t760 - t773;
  const Real wd6_y = s6 * t759 - c6 * t756 - t764;
  const Real t783 = t765 + link4_to_5_z * t766;
  const Real t785 = t767 * inverse_D4;
  const Real t786 = t768 * inverse_D4;
  const Real t787 = t751 * inverse_D4;
  const Real t788 = t760 + wd6_x;

  // links 7 to 9, 14 to 16, outward
  const Lanes<2> w8_15_x_lanes = detail::make_pack<Real>(c8, c15) * w7_14_y_lanes +
      detail::make_pack<Real>(s8, s15) * w7_14_z_lanes;
  const Lanes<2> t789_lanes = t778_lanes + wd6_y;
  const Lanes<2> w8_15_y_lanes = detail::make_pack<Real>(c8, c15) * w7_14_z_lanes -
      detail::make_pack<Real>(s8, s15) * w7_14_y_lanes;
  const Lanes<2> t795_lanes = w8_15_x_lanes * w8_15_y_lanes;
  const Lanes<2> w9_16_z_lanes = detail::make_pack<Real>(qd[8], qd[15]) - w8_15_x_lanes;
  const Lanes<2> t798_lanes = w8_15_y_lanes * w8_15_z_lanes;

  // links 7, 9, 14, 16, outward
  const Lanes<2> t800_lanes = detail::make_pack<Real>(s7, s14) * t770 +
      detail::make_pack<Real>(c7, c14) * t788;
  const Lanes<2> t801_lanes = detail::make_pack<Real>(c7, c14) * t770 -
      detail::make_pack<Real>(s7, s14) * t788;
  const Lanes<2> w9_16_y_lanes = detail::make_pack<Real>(c9, c16) * w8_15_y_lanes -
      detail::make_pack<Real>(s9, s16) * w8_15_z_lanes;
  const Lanes<2> w9_16_x_lanes = detail::make_pack<Real>(s9, s16) * w8_15_y_lanes +
      detail::make_pack<Real>(c9, c16) * w8_15_z_lanes;
  const Lanes<2> t805_lanes = 2.0 * (w7_14_x_lanes * w7_14_z_lanes) - t800_lanes;
  const Lanes<2> wd7_14_x_lanes = t780_lanes - t801_lanes;

  // link 4 (chest1), articulated inertia; links 2, 9 and 10, 16 and 17, outward
  const Real t806 = t718 + link4_to_5_z * t769 - s4 * (t748 - t731) - t767 * t787;
  const Lanes<2> t809_lanes = w9_16_x_lanes * w9_16_y_lanes;
  const Lanes<2> w10_17_z_lanes = w9_16_y_lanes + detail::make_pack<Real>(qd[9], qd[16]);
  const Real t811 = w2_z * w2_z;
  const Lanes<2> t812_lanes = w9_16_x_lanes * w9_16_z_lanes;

  // links 1, 3, 8, 10, 15, 17, outward; link 4 (chest1), articulated inertia
  const Real minus_a1_x = minus_gravity_z * s1;
  const Lanes<2> t815_lanes = t795_lanes + wd7_14_x_lanes;
  const Real minus_a1_y = minus_gravity_z * c1;
  const Real t816 = minus_h_3_y + (t783 - t767 * t786);
  const Lanes<2> minus_w10_17_y_lanes = detail::make_pack<Real>(s10, s17) * w9_16_x_lanes +
      detail::make_pack<Real>(c10, c17) * w9_16_z_lanes;
  const Real t818 = w3_z * w3_z;
  const Lanes<2> w10_17_x_lanes = detail::make_pack<Real>(c10, c17) * w9_16_x_lanes -
      detail::make_pack<Real>(s10, s17) * w9_16_z_lanes;

  // links 3, 5, 8, 15, outward
  const Lanes<2> t821_lanes = detail::make_pack<Real>(c8, c15) * t789_lanes +
      detail::make_pack<Real>(s8, s15) * t805_lanes;
  const Lanes<2> t822_lanes = detail::make_pack<Real>(c8, c15) * t805_lanes -
      detail::make_pack<Real>(s8, s15) * t789_lanes;
  const Real t824 = w5_x * w5_x;
  const Real t825 = w5_z * w5_z;
  const Real t830 = minus_a1_x + t811 * t730;

  // links 2, 6, 8, 10, 15, 17, outward
  const Lanes<2> t831_lanes = 2.0 * (w8_15_x_lanes * w8_15_z_lanes) - t821_lanes;
  const Lanes<2> wd8_15_x_lanes = t798_lanes - t822_lanes;
  const Lanes<2> t832_lanes = w10_17_x_lanes * minus_w10_17_y_lanes;
  const Real a2_y = minus_link1_to_2_y * (qd[0] * qd[0]) - minus_a1_y;
  const Real t833 = w6_z * w6_z;

  // links 3, 5, 11, 18, outward
  const Lanes<2> w11_18_z_lanes = minus_w10_17_y_lanes + detail::make_pack<Real>(qd[10], qd[17]);
  const Real t834 = t824 + t825;
  const Lanes<2> w11_18_x_lanes = detail::make_pack<Real>(c11, c18) * w10_17_x_lanes +
      detail::make_pack<Real>(s11, s18) * w10_17_z_lanes;
  const Real t837 = wd5_x - minus_w5_y * w5_z;
  const Real t839 = a2_y + t811 * t727;
  const Real t840 = minus_wd5_z - t753;

  // links 6, 9, 11, 16, 18, outward
  const Lanes<2> t841_lanes = t809_lanes + wd8_15_x_lanes;
  const Real t842 = t764 - wd6_y;
  const Real t843 = w6_y * w6_y + t833;
  const Lanes<2> w11_18_y_lanes = detail::make_pack<Real>(c11, c18) * w10_17_z_lanes -
      detail::make_pack<Real>(s11, s18) * w10_17_x_lanes;
  const Lanes<2> t848_lanes = detail::make_pack<Real>(s9, s16) * t831_lanes -
      detail::make_pack<Real>(c9, c16) * t815_lanes;
  const Real t849 = t762 + wd5_x;
  const Lanes<2> t851_lanes = detail::make_pack<Real>(s9, s16) * t815_lanes +
      detail::make_pack<Real>(c9, c16) * t831_lanes;
  const Real t852 = w6_x * w6_x;

  // links 3, 9 to 11, 16 to 18, outward
  const Lanes<2> t855_lanes = w10_17_x_lanes * w10_17_z_lanes;
  const Lanes<2> t858_lanes = w11_18_x_lanes * w11_18_y_lanes;
  const Real a3_x = s2_plus_3 * t839 - c2_plus_3 * t830;
  const Real a3_y = s2_plus_3 * t830 + c2_plus_3 * t839;
  const Lanes<2> t859_lanes = 2.0 * (w9_16_y_lanes * w9_16_z_lanes) - t848_lanes;
  const Lanes<2> minus_wd9_16_y_lanes = t851_lanes + t812_lanes;

  // links 6, 8, 12, 15, 19, outward
  const Lanes<2> w12_19_x_lanes = detail::make_pack<Real>(c12, c19) * w11_18_x_lanes -
      detail::make_pack<Real>(s12, s19) * w11_18_z_lanes;
  const Lanes<2> t861_lanes = w8_15_y_lanes * w8_15_y_lanes;
  const Real t862 = t852 + t833;
  const Lanes<2> t863_lanes = w8_15_z_lanes * w8_15_z_lanes;
  const Lanes<2> w12_19_z_lanes = w11_18_y_lanes + detail::make_pack<Real>(qd[11], qd[18]);

  // links 5, 10 to 12, 17 to 19, outward
  const Real t865 = c4 * a3_x;
  const Real t866 = a3_y + link4_to_5_z * t818;
  const Real minus_a5_z = s4 * a3_x;
  const Lanes<2> t869_lanes = minus_wd9_16_y_lanes - t832_lanes;
  const Lanes<2> minus_w12_19_y_lanes = detail::make_pack<Real>(s12, s19) * w11_18_x_lanes +
      detail::make_pack<Real>(c12, c19) * w11_18_z_lanes;
  const Lanes<2> t870_lanes = w11_18_x_lanes * w11_18_z_lanes;

  // links 6, 8, 12, 15, 19, outward; link 4 (chest1), articulated inertia
  const Lanes<2> t872_lanes = 2.0 * w12_19_z_lanes;
  const Lanes<2> t874_lanes = w12_19_z_lanes * w12_19_z_lanes;
  const Lanes<2> t875_lanes = t861_lanes + t863_lanes;
  const Real t876 = 1.7947593951550056 + link4_to_5_z * (t765 + t783) - t767 * t785 +
      (t709 + s4 * (t735 - t750)) * s4;
  const Real t877 = minus_a5_z + minus_link5_to_6_y * t837;

  // links 10, 12, 17, 19, outward
  const Lanes<2> t878_lanes = detail::make_pack<Real>(s10, s17) * t841_lanes +
      detail::make_pack<Real>(c10, c17) * t859_lanes;
  const Lanes<2> t880_lanes = detail::make_pack<Real>(c10, c17) * t841_lanes -
      detail::make_pack<Real>(s10, s17) * t859_lanes;
  const Lanes<2> t882_lanes = w12_19_x_lanes * minus_w12_19_y_lanes;
  const Lanes<2> t885_lanes = w10_17_x_lanes * w10_17_x_lanes;
  const Lanes<2> t886_lanes = w10_17_z_lanes * w10_17_z_lanes;
  const Lanes<2> t887_lanes = t878_lanes - 2.0 * (minus_w10_17_y_lanes * w10_17_z_lanes);
  const Lanes<2> t888_lanes = minus_w12_19_y_lanes * w12_19_z_lanes;

  // links 5, 10, 12, 17, 19, outward; link 3 (hip), articulated inertia
  const Real a5_y = c5 * t866 - s5 * t865;
  const Real a5_x = c5 * t865 + s5 * t866;
  const Lanes<2> wd10_17_y_lanes = t880_lanes - t855_lanes;
  const Lanes<2> t889_lanes = minus_w12_19_y_lanes * minus_w12_19_y_lanes;
  const Real inverse_D3 = 1.0 / t876;
  const Lanes<2> t892_lanes = t885_lanes + t886_lanes;

  // links 6, 11, 13, 18, 20, outward; links 12 (left_wrist2) and 19 (right_wrist2), inertial
  //   wrench
  const Real t893 = a5_y + minus_link5_to_6_y * t834;
  const Real a6_z = a5_x - minus_link5_to_6_y * t840;
  const Lanes<2> t894_lanes = t858_lanes + wd10_17_y_lanes;
  const Lanes<2> w13_20_z_lanes = w12_19_x_lanes + detail::make_pack<Real>(qd[12], qd[19]);
  const Lanes<2> t896_lanes = t874_lanes - t889_lanes;

  // links 7, 11, 13 and 14, 18, 20, outward
  const Real t898 = a6_z - 0.226 * t842;
  const Lanes<2> t899_lanes = detail::make_pack<Real>(s11, s18) * t869_lanes -
      detail::make_pack<Real>(c11, c18) * t887_lanes;
  const Lanes<2> t900_lanes = detail::make_pack<Real>(c11, c18) * t869_lanes +
      detail::make_pack<Real>(s11, s18) * t887_lanes;
  const Lanes<2> t905_lanes = w13_20_z_lanes * w13_20_z_lanes;
  const Lanes<2> t908_lanes = t898 + detail::make_pack<Real>(0.18, (-0.18)) * t788;

  // links 6, 11, 14, 18, outward
  const Lanes<2> t909_lanes = 2.0 * (w11_18_y_lanes * w11_18_z_lanes) - t899_lanes;
  const Real a6_x = c6 * t893 - s6 * t877;
  const Real minus_a6_y = s6 * t893 + c6 * t877;
  const Lanes<2> minus_wd11_18_y_lanes = t900_lanes + t870_lanes;
  const Real t917 = a6_x + 0.226 * t843;
  const Real t918 = minus_a6_y + 0.226 * t849;

  // links 11 and 12, 18 and 19, outward; link 3 (hip), articulated inertia
  const Lanes<2> t919_lanes = t882_lanes + minus_wd11_18_y_lanes;
  const Lanes<2> t920_lanes = minus_wd11_18_y_lanes - t882_lanes;
  const Lanes<2> t925_lanes = w11_18_y_lanes * w11_18_y_lanes;
  const Lanes<2> t926_lanes = w11_18_x_lanes * w11_18_x_lanes;
  const Real t928 = t806 * inverse_D3;

  // links 7, 12 to 14, 19 and 20, outward
  const Lanes<2> t929_lanes = t917 + detail::make_pack<Real>(0.18, (-0.18)) * t770;
  const Lanes<2> minus_a7_14_z_lanes = t918 + detail::make_pack<Real>(0.18, (-0.18)) * t862;
  const Lanes<2> t930_lanes = detail::make_pack<Real>(c12, c19) * t894_lanes -
      detail::make_pack<Real>(s12, s19) * t909_lanes;
  const Lanes<2> t931_lanes = detail::make_pack<Real>(s12, s19) * t894_lanes +
      detail::make_pack<Real>(c12, c19) * t909_lanes;
  const Lanes<2> t932_lanes = 2.0 * (minus_w12_19_y_lanes * w13_20_z_lanes) - t919_lanes;

  // links 13 (left_hand) and 20 (right_hand), inertial wrench; link 3 (hip), articulated inertia;
  //   links 12 (left_wrist2) and 19 (right_wrist2), outward
  const Lanes<2> t935_lanes = (t905_lanes - t874_lanes) * t16_lanes;
  const Real t938 = t816 * inverse_D3;
  const Lanes<2> t943_lanes = t872_lanes * w12_19_x_lanes - t930_lanes;
  const Lanes<2> wd12_19_x_lanes = t931_lanes - t888_lanes;
  const Lanes<2> t946_lanes = (t889_lanes - t905_lanes) * t18_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), inertial wrench; links 7, 12 to 14, 19 and 20,
  //   outward
  const Lanes<2> t952_lanes = 9.6e-06 * t858_lanes + 0.00022920000000000001 * wd10_17_y_lanes +
      0.000144 * t899_lanes;
  const Lanes<2> a7_14_y_lanes = detail::make_pack<Real>(c7, c14) * t929_lanes -
      detail::make_pack<Real>(s7, s14) * t908_lanes;
  const Lanes<2> a7_14_x_lanes = detail::make_pack<Real>(s7, s14) * t929_lanes +
      detail::make_pack<Real>(c7, c14) * t908_lanes;
  const Lanes<2> t953_lanes = t872_lanes * w13_20_z_lanes - t943_lanes;
  const Lanes<2> t957_lanes = wd12_19_x_lanes - t888_lanes;

  // link 3 (hip), articulated inertia; links 8 (left_shoulder2) and 15 (right_shoulder2), outward
  const Real t971 = t816 * t928 - (t769 - t768 * t787);
  const Real t973 = t766 - t768 * t786 - t816 * t938;
  const Real t974 = t724 + t743 - t751 * t787 - t806 * t928;
  const Lanes<2> minus_a8_15_y_lanes = detail::make_pack<Real>(s8, s15) * a7_14_y_lanes +
      detail::make_pack<Real>(c8, c15) * minus_a7_14_z_lanes;
  const Lanes<2> a8_15_x_lanes = detail::make_pack<Real>(c8, c15) * a7_14_y_lanes -
      detail::make_pack<Real>(s8, s15) * minus_a7_14_z_lanes;

  // links 13 (left_hand) and 20 (right_hand), inertial wrench; links 9 to 11, 16 to 18, outward
  const Lanes<2> t975_lanes = 0.0009386316083993107 * wd12_19_x_lanes - t888_lanes *
      (t32_lanes - t36_lanes) + t943_lanes * t18_lanes;
  const Lanes<2> t980_lanes = 0.282 * t875_lanes - a8_15_x_lanes;
  const Lanes<2> t983_lanes = t932_lanes * t32_lanes - t931_lanes * t16_lanes - t953_lanes *
      t34_lanes + t946_lanes;
  const Lanes<2> t991_lanes = t870_lanes + minus_wd11_18_y_lanes;
  const Lanes<2> a9_16_x_lanes = detail::make_pack<Real>(c9, c16) * a7_14_x_lanes -
      detail::make_pack<Real>(s9, s16) * minus_a8_15_y_lanes;
  const Lanes<2> minus_a9_16_y_lanes = detail::make_pack<Real>(c9, c16) * minus_a8_15_y_lanes +
      detail::make_pack<Real>(s9, s16) * a7_14_x_lanes;
  const Lanes<2> t993_lanes = t953_lanes * t36_lanes - t932_lanes * t34_lanes - t957_lanes *
      t18_lanes + t935_lanes;

  // links 10 and 11, 17 and 18, outward; link 3 (hip), articulated inertia
  const Lanes<2> t995_lanes = w11_18_z_lanes * w11_18_z_lanes;
  const Lanes<2> t997_lanes = t858_lanes - wd10_17_y_lanes;
  const Real t999 = s2_plus_3 * (t973 - t974) + c2_plus_3 * (2.0 * t971);
  const Lanes<2> t1000_lanes = a9_16_x_lanes + 0.282 * t851_lanes;
  const Lanes<2> minus_a10_17_z_lanes = minus_a9_16_y_lanes + 0.282 * t848_lanes;

  // links 13 (left_hand) and 20 (right_hand), inward; links 11, 13, 18, 20, inertial wrench; link
  //   3 (hip), articulated inertia
  const Lanes<2> t1015_lanes = t983_lanes - 0.000183627662257343 * t882_lanes -
      0.000206827662257343 * minus_wd11_18_y_lanes - detail::make_pack<Real>(2.4000000000000003e-06,
      (-2.4000000000000003e-06)) * t930_lanes;
  const Lanes<2> f13_20_z_lanes = t953_lanes * t12_lanes - t932_lanes * t10_lanes;
  const Lanes<2> f12_19_z_lanes = 0.0025100003499999995 * t943_lanes - (t889_lanes + t905_lanes) *
      t12_lanes + t19_lanes * t957_lanes;
  const Lanes<2> t1020_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) *
      (t995_lanes - t925_lanes);
  const Real t1023 = s2_plus_3 * t999;

  // links 10, 12, 17, 19, outward; link 3 (hip), articulated inertia; links 13 (left_hand) and 20
  //   (right_hand), inertial wrench
  const Lanes<2> a10_17_x_lanes = detail::make_pack<Real>(c10, c17) * t1000_lanes -
      detail::make_pack<Real>(s10, s17) * t980_lanes;
  const Lanes<2> minus_a10_17_y_lanes = detail::make_pack<Real>(s10, s17) * t1000_lanes +
      detail::make_pack<Real>(c10, c17) * t980_lanes;
  const Real t1031 = c2_plus_3 * t999 - t971;
  const Lanes<2> t1035_lanes = minus_a10_17_y_lanes + 0.269 * t892_lanes;
  const Lanes<2> minus_f13_20_x_lanes = (t874_lanes + t905_lanes) * t10_lanes + t931_lanes *
      t12_lanes;

  // links 13 (left_hand) and 20 (right_hand), inward; links 11 (left_wrist1) and 18
  //   (right_wrist1), inertial wrench; links 10 and 11, 17 and 18, outward
  const Lanes<2> f12_19_x_lanes = 0.0006000000000000001 * t920_lanes - 0.0025100003499999995 *
      (t889_lanes + t874_lanes) + f13_20_z_lanes;
  const Lanes<2> t1039_lanes = 0.000144 * (t926_lanes - t995_lanes);
  const Lanes<2> t1043_lanes = minus_w10_17_y_lanes * minus_w10_17_y_lanes;
  const Lanes<2> t1047_lanes = 0.0001194 * t909_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) *
      t991_lanes + 0.000144 * t997_lanes + t1020_lanes;
  const Lanes<2> a11_18_x_lanes = detail::make_pack<Real>(c11, c18) * a10_17_x_lanes -
      detail::make_pack<Real>(s11, s18) * minus_a10_17_z_lanes;
  const Lanes<2> minus_a11_18_y_lanes = detail::make_pack<Real>(s11, s18) * a10_17_x_lanes +
      detail::make_pack<Real>(c11, c18) * minus_a10_17_z_lanes;

  // links 10 and 11, 17 and 18, inertial wrench; links 12 (left_wrist2) and 19 (right_wrist2),
  //   outward; links 13 (left_hand) and 20 (right_hand), inward
  const Lanes<2> t1049_lanes = detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      t880_lanes;
  const Lanes<2> t1053_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) * t894_lanes -
      0.0001098 * t991_lanes - detail::make_pack<Real>(6e-06, (-6e-06)) * t909_lanes - t1039_lanes;
  const Lanes<2> t1057_lanes = a11_18_x_lanes + 0.269 * t900_lanes;
  const Lanes<2> minus_a12_19_z_lanes = minus_a11_18_y_lanes + 0.269 * t899_lanes;
  const Lanes<2> minus_f12_19_y_lanes = 0.0025100003499999995 * t919_lanes + 0.0006000000000000001 *
      (w12_19_x_lanes * w12_19_x_lanes + t874_lanes) + minus_f13_20_x_lanes;

  // link 3 (hip), articulated inertia; links 10 (left_lowerarm) and 17 (right_lowerarm), outward;
  //   links 10 and 11, 17 and 18, inertial wrench
  const Real t1060 = t973 - t1023;
  const Lanes<2> t1063_lanes = t855_lanes - wd10_17_y_lanes;
  const Lanes<2> t1071_lanes = 6e-04 * minus_a11_18_y_lanes +
      detail::make_pack<Real>(0.001, (-0.001)) * a11_18_x_lanes;
  const Lanes<2> t1073_lanes = 0.06032654142055946 * t832_lanes - 0.060888541114265754 *
      minus_wd9_16_y_lanes - detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      t878_lanes - t1049_lanes;
  const Lanes<2> t1075_lanes = t832_lanes + minus_wd9_16_y_lanes;

  // links 10 and 11, 17 and 18, inertial wrench; links 12 (left_wrist2) and 19 (right_wrist2),
  //   outward and inward
  const Lanes<2> t1078_lanes = 0.0014999985000000002 * minus_a10_17_y_lanes + 0.28049749700000004 *
      a10_17_x_lanes;
  const Lanes<2> minus_a12_19_y_lanes = detail::make_pack<Real>(s12, s19) * t1057_lanes +
      detail::make_pack<Real>(c12, c19) * t1035_lanes;
  const Lanes<2> a12_19_x_lanes = detail::make_pack<Real>(c12, c19) * t1057_lanes -
      detail::make_pack<Real>(s12, s19) * t1035_lanes;
  const Lanes<2> t1082_lanes = detail::make_pack<Real>((-0.0002516), 0.0002516) * t900_lanes -
      t952_lanes + detail::make_pack<Real>(6e-06, (-6e-06)) * (t925_lanes - t926_lanes) -
      t1071_lanes;
  const Lanes<2> t1084_lanes = detail::make_pack<Real>(c12, c19) * f12_19_x_lanes +
      detail::make_pack<Real>(s12, s19) * minus_f12_19_y_lanes;

  // links 9 and 10, 16 and 17, inertial wrench; links 9 (left_upperarm) and 16 (right_upperarm),
  //   outward
  const Lanes<2> t1089_lanes = detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      (t886_lanes - t1043_lanes);
  const Lanes<2> t1099_lanes = detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) *
      (t885_lanes - t886_lanes);
  const Lanes<2> t1103_lanes = w9_16_y_lanes * w9_16_y_lanes;
  const Lanes<2> t1104_lanes = w9_16_x_lanes * w9_16_x_lanes;
  const Lanes<2> t1106_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * t851_lanes;

  // links 10, 13, 17, 20, inertial wrench; links 13 (left_hand) and 20 (right_hand), inward
  const Lanes<2> t1107_lanes = t12_lanes * minus_a12_19_y_lanes - t10_lanes * minus_a12_19_z_lanes;
  const Lanes<2> n13_20_x_lanes = t993_lanes + t12_lanes * a12_19_x_lanes;
  const Lanes<2> t1110_lanes = 0.06060754126741261 * t887_lanes + 0.0001499998887063 * t1063_lanes +
      detail::make_pack<Real>(2.249994685315e-05, (-2.249994685315e-05)) * t1075_lanes +
      t1089_lanes;
  const Lanes<2> n13_20_z_lanes = t975_lanes + t919_lanes * t16_lanes + t896_lanes * t34_lanes +
      t1107_lanes;
  const Lanes<2> n12_19_z_lanes = t1015_lanes - 0.0025100003499999995 * minus_a12_19_y_lanes -
      t19_lanes * a12_19_x_lanes;
  const Lanes<2> n12_19_y_lanes = detail::make_pack<Real>(2.4000000000000003e-06,
      (-2.4000000000000003e-06)) * t920_lanes - 0.000195227662257343 * t943_lanes +
      0.0025100003499999995 * minus_a12_19_z_lanes + n13_20_x_lanes;
  const Lanes<2> t1114_lanes = detail::make_pack<Real>(0.0001499998887063, (-0.0001499998887063)) *
      t869_lanes - 0.00028099984685315 * t1063_lanes - 0.0001499998887063 * t887_lanes +
      t1099_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), inertial wrench; links 1, 13, 20, inward
  const Lanes<2> t1118_lanes = 0.0022500062 * minus_a9_16_y_lanes -
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * a9_16_x_lanes;
  const Lanes<2> t1119_lanes = detail::make_pack<Real>(tau[12], tau[19]) - n13_20_z_lanes;
  const Lanes<2> t1120_lanes = detail::make_pack<Real>(tau[11], tau[18]) - n12_19_z_lanes;
  const Lanes<2> n12_19_x_lanes = 1.16e-05 * t957_lanes +
      detail::make_pack<Real>(2.4000000000000003e-06, (-2.4000000000000003e-06)) * t896_lanes -
      0.0006000000000000001 * minus_a12_19_z_lanes + n13_20_z_lanes;
  const Lanes<2> t1128_lanes = 0.0005895000784280001 * t848_lanes -
      (0.0011407948149957223 * t809_lanes + 0.0027762933559338653 * wd8_15_x_lanes) + t1106_lanes;

  // links 12 (left_wrist2) and 19 (right_wrist2), inward; links 9 (left_upperarm) and 16
  //   (right_upperarm), outward; links 12 (left_wrist2) and 19 (right_wrist2), bias force
  const Lanes<2> n11_18_y_lanes = t1053_lanes - 6e-04 * minus_a10_17_y_lanes +
      (n12_19_z_lanes - 0.269 * t1084_lanes);
  const Lanes<2> t1142_lanes = t812_lanes + minus_wd9_16_y_lanes;
  const Lanes<2> t1145_lanes = t1120_lanes + t23_lanes * t1119_lanes;
  const Lanes<2> t1147_lanes = t809_lanes - wd8_15_x_lanes;
  const Lanes<2> t1148_lanes = w9_16_z_lanes * w9_16_z_lanes;

  // links 12 (left_wrist2) and 19 (right_wrist2), bias force; links 1, 12, 19, inward
  const Lanes<2> t1159_lanes = t48_lanes * t1145_lanes;
  const Lanes<2> n11_18_z_lanes = t1082_lanes - (detail::make_pack<Real>(s12, s19) *
      n12_19_x_lanes + detail::make_pack<Real>(c12, c19) * n12_19_y_lanes);
  const Lanes<2> t1161_lanes = 0.269 * f12_19_z_lanes -
      (detail::make_pack<Real>(s12, s19) * n12_19_y_lanes - detail::make_pack<Real>(c12, c19) *
      n12_19_x_lanes);
  const Lanes<2> f11_18_x_lanes = detail::make_pack<Real>(0.001, (-0.001)) * t894_lanes - 6e-04 *
      (t925_lanes + t995_lanes) + t1084_lanes;
  const Lanes<2> t1171_lanes = t46_lanes * t1145_lanes - t27_lanes * t1119_lanes;
  const Lanes<2> t1172_lanes = t47_lanes * t1145_lanes - t9_lanes * t1119_lanes;
  const Lanes<2> t1174_lanes = detail::make_pack<Real>(tau[10], tau[17]) - n11_18_z_lanes;
  const Lanes<2> t1175_lanes = t11_lanes * t1119_lanes + t49_lanes * t1145_lanes;

  // links 11 and 12, 18 and 19, inward
  const Lanes<2> n11_18_x_lanes = t1047_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      minus_a10_17_y_lanes + t1161_lanes;
  const Lanes<2> f11_18_y_lanes = 6e-04 * t997_lanes - detail::make_pack<Real>(0.001, (-0.001)) *
      (t926_lanes + t995_lanes) + f12_19_z_lanes;
  const Lanes<2> t1179_lanes = detail::make_pack<Real>(c12, c19) * minus_f12_19_y_lanes -
      detail::make_pack<Real>(s12, s19) * f12_19_x_lanes;
  const Lanes<2> n10_17_y_lanes = t1114_lanes + 0.0014999985000000002 * minus_a10_17_z_lanes -
      n11_18_z_lanes;
  const Lanes<2> f11_18_z_lanes = 6e-04 * t991_lanes + detail::make_pack<Real>(0.001, (-0.001)) *
      t909_lanes + t1179_lanes;

  // links 12 (left_wrist2) and 19 (right_wrist2), bias force; links 11 (left_wrist1) and 18
  //   (right_wrist1), inward
  const Lanes<2> t1196_lanes = detail::make_pack<Real>(c12, c19) * t1159_lanes +
      detail::make_pack<Real>(s12, s19) * t1172_lanes;
  const Lanes<2> t1199_lanes = detail::make_pack<Real>(s11, s18) * n11_18_x_lanes +
      detail::make_pack<Real>(c11, c18) * n11_18_y_lanes;
  const Lanes<2> t1201_lanes = detail::make_pack<Real>(c11, c18) * f11_18_x_lanes -
      detail::make_pack<Real>(s11, s18) * f11_18_y_lanes;
  const Lanes<2> minus_f10_17_y_lanes = 0.0014999985000000002 * t1075_lanes + 0.28049749700000004 *
      t892_lanes + f11_18_z_lanes;
  const Lanes<2> t1204_lanes = detail::make_pack<Real>(s11, s18) * f11_18_x_lanes +
      detail::make_pack<Real>(c11, c18) * f11_18_y_lanes;

  // links 11 (left_wrist1) and 18 (right_wrist1), bias force; links 1, 11, 18, inward
  const Lanes<2> t1206_lanes = t1174_lanes + (detail::make_pack<Real>(s12, s19) * t1119_lanes +
      detail::make_pack<Real>(c12, c19) * t1171_lanes);
  const Lanes<2> n10_17_z_lanes = t1073_lanes + 0.0001499998887063 * (t1043_lanes - t885_lanes) -
      t1078_lanes + t1199_lanes;
  const Lanes<2> n10_17_x_lanes = t1110_lanes - 0.28049749700000004 * minus_a10_17_z_lanes +
      (detail::make_pack<Real>(c11, c18) * n11_18_x_lanes - detail::make_pack<Real>(s11, s18) *
      n11_18_y_lanes);
  const Lanes<2> f10_17_x_lanes = 0.28049749700000004 * t869_lanes - 0.0014999985000000002 *
      (t1043_lanes + t886_lanes) + t1201_lanes;
  const Lanes<2> t1215_lanes = t124_lanes * t1206_lanes;
  const Lanes<2> t1220_lanes = detail::make_pack<Real>(tau[9], tau[16]) - n10_17_z_lanes;
  const Lanes<2> f10_17_z_lanes = 0.0014999985000000002 * t1063_lanes + 0.28049749700000004 *
      t887_lanes + t1204_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), inertial wrench; links 11 (left_wrist1) and
  //   18 (right_wrist1), bias force
  const Lanes<2> t1226_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * (t1148_lanes - t1103_lanes);
  const Lanes<2> t1227_lanes = 0.0005895000784280001 * (t1104_lanes - t1148_lanes);
  const Lanes<2> t1230_lanes = 0.269 * t1175_lanes -
      (detail::make_pack<Real>(s12, s19) * t1171_lanes - detail::make_pack<Real>(c12, c19) *
      t1119_lanes) + t1215_lanes;
  const Lanes<2> t1231_lanes = t1120_lanes + 0.269 * t1196_lanes + t125_lanes * t1206_lanes;
  const Lanes<2> t1232_lanes = t1175_lanes + t127_lanes * t1206_lanes;
  const Lanes<2> t1233_lanes = t1196_lanes + t126_lanes * t1206_lanes;
  const Lanes<2> t1234_lanes = detail::make_pack<Real>(s12, s19) * t1159_lanes -
      detail::make_pack<Real>(c12, c19) * t1172_lanes + t128_lanes * t1206_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), inward; links 8 (left_shoulder2) and 15
  //   (right_shoulder2), outward
  const Lanes<2> t1235_lanes = detail::make_pack<Real>(s10, s17) * n10_17_x_lanes +
      detail::make_pack<Real>(c10, c17) * n10_17_y_lanes;
  const Lanes<2> t1238_lanes = detail::make_pack<Real>(c10, c17) * f10_17_x_lanes +
      detail::make_pack<Real>(s10, s17) * minus_f10_17_y_lanes;
  const Lanes<2> t1239_lanes = t795_lanes - wd7_14_x_lanes;
  const Lanes<2> t1240_lanes = t798_lanes + wd8_15_x_lanes;
  const Lanes<2> t1241_lanes = w8_15_x_lanes * w8_15_x_lanes;
  const Lanes<2> n9_16_z_lanes = t1128_lanes + detail::make_pack<Real>((-4.4999986458742003e-05),
      4.4999986458742003e-05) * (t1103_lanes - t1104_lanes) + t1118_lanes - t1235_lanes;

  // links 9 (left_upperarm) and 16 (right_upperarm), inertial wrench; links 1, 10, 17, inward;
  //   links 10 (left_lowerarm) and 17 (right_lowerarm), bias force
  const Lanes<2> t1254_lanes = 0.0019585440854647937 * t859_lanes +
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * t1142_lanes -
      0.0005895000784280001 * t1147_lanes + t1226_lanes;
  const Lanes<2> t1255_lanes = detail::make_pack<Real>((-0.0012089992423205001),
      0.0012089992423205001) * t841_lanes - 0.0008177492704690715 * t1142_lanes -
      detail::make_pack<Real>((-4.4999986458742003e-05), 4.4999986458742003e-05) * t859_lanes +
      t1227_lanes;
  const Lanes<2> t1266_lanes = detail::make_pack<Real>(tau[8], tau[15]) - n9_16_z_lanes;
  const Lanes<2> t1267_lanes = 0.282 * f10_17_z_lanes -
      (detail::make_pack<Real>(s10, s17) * n10_17_y_lanes - detail::make_pack<Real>(c10, c17) *
      n10_17_x_lanes);
  const Lanes<2> t1269_lanes = t1220_lanes - (detail::make_pack<Real>(s11, s18) * t1230_lanes +
      detail::make_pack<Real>(c11, c18) * t1231_lanes);

  // links 8 (left_shoulder2) and 15 (right_shoulder2), inertial wrench; links 10 (left_lowerarm)
  //   and 17 (right_lowerarm), inward; links 7 (left_shoulder1) and 14 (right_shoulder1), outward
  const Lanes<2> t1272_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * t821_lanes;
  const Lanes<2> n9_16_x_lanes = t1254_lanes - detail::make_pack<Real>(0.004500002325,
      (-0.004500002325)) * a8_15_x_lanes + t1267_lanes;
  const Lanes<2> n9_16_y_lanes = t1255_lanes - 0.0022500062 * a8_15_x_lanes +
      (n10_17_z_lanes - 0.282 * t1238_lanes);
  const Lanes<2> t1289_lanes = 0.00010499999999999999 * (t1241_lanes - t863_lanes);
  const Lanes<2> t1290_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) *
      (t863_lanes - t861_lanes);
  const Lanes<2> t1291_lanes = w7_14_y_lanes * w7_14_y_lanes;
  const Lanes<2> t1292_lanes = 0.18101044219699997 * t795_lanes + 0.18125194219699997 *
      wd7_14_x_lanes + 0.00010499999999999999 * t822_lanes - t1272_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), bias force
  const Lanes<2> t1295_lanes = detail::make_pack<Real>(c11, c18) * t1230_lanes -
      detail::make_pack<Real>(s11, s18) * t1231_lanes + t210_lanes * t1269_lanes;
  const Lanes<2> t1296_lanes = t208_lanes * t1269_lanes - t1174_lanes;
  const Lanes<2> t1297_lanes = t213_lanes * t1269_lanes -
      (detail::make_pack<Real>(c11, c18) * t1233_lanes + detail::make_pack<Real>(s11, s18) *
      t1232_lanes);
  const Lanes<2> t1298_lanes = t214_lanes * t1269_lanes - t1234_lanes;
  const Lanes<2> t1299_lanes = detail::make_pack<Real>(c11, c18) * t1232_lanes -
      detail::make_pack<Real>(s11, s18) * t1233_lanes + t215_lanes * t1269_lanes;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), outward; links 8 (left_shoulder2) and 15
  //   (right_shoulder2), inertial wrench
  const Lanes<2> t1300_lanes = w7_14_x_lanes * w7_14_x_lanes;
  const Lanes<2> t1313_lanes = t780_lanes + wd7_14_x_lanes;
  const Lanes<2> t1315_lanes = w7_14_z_lanes * w7_14_z_lanes;
  const Lanes<2> t1317_lanes = 0.7139200499999999 * minus_a8_15_y_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * a8_15_x_lanes;
  const Lanes<2> t1319_lanes = detail::make_pack<Real>(1.75e-05, (-1.75e-05)) * t1239_lanes -
      0.18113119219699997 * t831_lanes - detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * t1240_lanes + t1289_lanes;
  const Lanes<2> t1320_lanes = 0.00012075 * t1240_lanes +
      detail::make_pack<Real>(5.2499999999999995e-05, (-5.2499999999999995e-05)) * t831_lanes -
      0.00010499999999999999 * t815_lanes + t1290_lanes;

  // links 10 (left_lowerarm) and 17 (right_lowerarm), bias force; link 21 (neck), outward; link 7
  //   (left_shoulder1), inertial wrench; links 8 (left_shoulder2) and 15 (right_shoulder2),
  //   articulated inertia
  const Lanes<2> t1322_lanes = detail::make_pack<Real>(s10, s17) * t1298_lanes -
      detail::make_pack<Real>(c10, c17) * t1297_lanes;
  const Real w21_z = qd[20] - w6_x;
  const Real t1328 = 0.000448 * wd6_y;
  const Lanes<2> t1329_lanes = 0.00010499999999999999 / t389_lanes;
  const Real w21_x = s21 * w6_y + c21 * w6_z;

  // links 9 (left_upperarm) and 16 (right_upperarm), bias force; link 21 (neck), outward; links 9
  //   (left_upperarm) and 16 (right_upperarm), inward
  const Lanes<2> t1330_lanes = t1266_lanes + (detail::make_pack<Real>(s10, s17) * t1295_lanes +
      detail::make_pack<Real>(c10, c17) * t1296_lanes);
  const Real w21_y = c21 * w6_y - s21 * w6_z;
  const Lanes<2> t1334_lanes = detail::make_pack<Real>(c9, c16) * n9_16_x_lanes -
      detail::make_pack<Real>(s9, s16) * n9_16_y_lanes;
  const Lanes<2> t1337_lanes = t308_lanes * t1330_lanes;
  const Real t1341 = w21_x * w21_z;

  // links 21 (neck) and 22 (head), outward; links 7 (left_shoulder1) and 14 (right_shoulder1),
  //   inertial wrench
  const Real t1342 = w21_x * w21_y;
  const Real t1343 = s21 * t842 - c21 * t849;
  const Real w22_z = w21_y + qd[21];
  const Lanes<2> t1345_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (t1315_lanes - t1291_lanes);
  const Real w22_x = c22 * w21_x - s22 * w21_z;

  // links 9 (left_upperarm) and 16 (right_upperarm), bias force; link 21 (neck), outward; links 9
  //   (left_upperarm) and 16 (right_upperarm), inward
  const Lanes<2> t1346_lanes = 0.282 * t1299_lanes -
      (detail::make_pack<Real>(s10, s17) * t1296_lanes - detail::make_pack<Real>(c10, c17) *
      t1295_lanes) + t1337_lanes;
  const Lanes<2> t1347_lanes = t1220_lanes + 0.282 * t1322_lanes + t309_lanes * t1330_lanes;
  const Real t1349 = s21 * t849 + c21 * t842;
  const Lanes<2> n8_15_z_lanes = t1292_lanes + detail::make_pack<Real>(5.2499999999999995e-05,
      (-5.2499999999999995e-05)) * (t861_lanes - t1241_lanes) - t1317_lanes + t1334_lanes;
  const Real t1352 = t1342 + wd6_x;

  // links 21 (neck) and 22 (head), outward
  const Real minus_w22_y = s22 * w21_x + c22 * w21_z;
  const Real t1353 = w22_x * w22_z;
  const Real minus_wd21_y = t1349 + t1341;
  const Real t1355 = w21_x * w21_x;
  const Real t1356 = w21_z * w21_z;
  const Real t1359 = 2.0 * (w21_y * w21_z) - t1343;
  const Real t1360 = w22_x * minus_w22_y;
  const Real minus_a21_y = c21 * minus_a6_y + s21 * a6_z;
  const Real t1362 = t1355 + t1356;

  // links 21 to 24, outward
  const Real t1363 = minus_w22_y * minus_w22_y;
  const Real t1364 = w22_z * w22_z;
  const Lanes<2> w23_24_x_lanes = detail::make_pack<Real>(c23, c24) * w22_x +
      detail::make_pack<Real>(s23, s24) * w22_z;
  const Real a21_x = c21 * a6_z - s21 * minus_a6_y;
  const Real a22_z = link21_to_22_z * t1343 - minus_a21_y;

  // links 9 (left_upperarm) and 16 (right_upperarm), inward; links 22 to 24, outward
  const Lanes<2> n8_15_y_lanes = t1319_lanes - 0.7139200499999999 * a7_14_x_lanes +
      (detail::make_pack<Real>(s9, s16) * n9_16_x_lanes + detail::make_pack<Real>(c9, c16) *
      n9_16_y_lanes);
  const Real t1367 = a6_x + link21_to_22_z * t843;
  const Real t1368 = minus_wd21_y - t1360;
  const Lanes<2> w23_24_y_lanes = detail::make_pack<Real>(c23, c24) * w22_z -
      detail::make_pack<Real>(s23, s24) * w22_x;
  const Real t1370 = t1363 + t1364;
  const Lanes<2> n8_15_x_lanes = t1320_lanes + detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * a7_14_x_lanes - n9_16_z_lanes;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), inertial wrench; links 22 to 24, outward
  const Lanes<2> t1371_lanes = 0.0017499999999999998 * minus_a7_14_z_lanes;
  const Real t1373 = c22 * t1352 - s22 * t1359;
  const Real t1374 = a21_x - link21_to_22_z * t1349;
  const Real t1375 = s22 * t1352 + c22 * t1359;
  const Lanes<2> w23_24_z_lanes = minus_w22_y + detail::make_pack<Real>(qd[22], qd[23]);
  const Lanes<2> t1376_lanes = w23_24_x_lanes * w23_24_y_lanes;
  const Lanes<2> t1380_lanes = 0.0001505 * t1313_lanes + 8.75e-06 * t805_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * t789_lanes +
      t1345_lanes;

  // links 22 to 24, outward; link 1 (calf), inward
  const Real wd22_y = t1373 - t1353;
  const Real t1381 = t1375 - 2.0 * (minus_w22_y * w22_z);
  const Lanes<2> t1383_lanes = w23_24_z_lanes * w23_24_z_lanes;
  const Lanes<2> t1386_lanes = 2.0 * w23_24_z_lanes;
  const Lanes<2> t1388_lanes = detail::make_pack<Real>(tau[7], tau[14]) - n8_15_z_lanes;
  const Real t1391 = t1353 - wd22_y;
  const Real a22_x = c22 * t1374 + s22 * t1367;
  const Lanes<2> t1395_lanes = t1376_lanes - wd22_y;

  // links 23 (left_eye) and 24 (right_eye), inertial wrench; links 22 to 24, outward
  const Real t1396 = 9.25e-06 * wd22_y;
  const Real t1401 = t1360 + minus_wd21_y;
  const Real t1402 = a22_x - 0.095 * t1370;
  const Lanes<2> t1405_lanes = detail::make_pack<Real>(s23, s24) * t1368 -
      detail::make_pack<Real>(c23, c24) * t1381;
  const Lanes<2> f23_24_y_lanes = 0.00025 * t1395_lanes;
  const Lanes<2> minus_f23_24_x_lanes = 0.00025 * (w23_24_y_lanes * w23_24_y_lanes + t1383_lanes);

  // links 22 to 24, outward
  const Real t1409 = a22_z + 0.095 * t1391;
  const Real a22_y = c22 * t1367 - s22 * t1374;
  const Lanes<2> t1411_lanes = detail::make_pack<Real>(c23, c24) * t1368 +
      detail::make_pack<Real>(s23, s24) * t1381 + t1386_lanes * w23_24_x_lanes;
  const Lanes<2> t1419_lanes = detail::make_pack<Real>(s23, s24) *
      (t1402 + detail::make_pack<Real>(0.032, (-0.032)) * t1373);
  const Real t1420 = a22_y - 0.095 * t1401;
  const Lanes<2> minus_a23_24_z_lanes = t1420 - detail::make_pack<Real>(0.032, (-0.032)) * t1375;

  // links 23 (left_eye) and 24 (right_eye), inward; link 22 (head), outward; links 23 (left_eye)
  //   and 24 (right_eye), inertial wrench
  const Lanes<2> t1427_lanes = detail::make_pack<Real>(c23, c24) * minus_f23_24_x_lanes +
      detail::make_pack<Real>(s23, s24) * f23_24_y_lanes;
  const Real t1429 = w22_x * w22_x;
  const Lanes<2> n23_24_x_lanes = 4e-06 * (t1386_lanes * w23_24_y_lanes - t1405_lanes) -
      2.8750000000000004e-05 * t1395_lanes;
  const Lanes<2> t1430_lanes = detail::make_pack<Real>(c23, c24) * f23_24_y_lanes -
      detail::make_pack<Real>(s23, s24) * minus_f23_24_x_lanes;
  const Lanes<2> t1431_lanes = 0.00025 * minus_a23_24_z_lanes;

  // links 21, 23 and 24, outward; links 23 (left_eye) and 24 (right_eye), inward
  const Lanes<2> a23_24_y_lanes = detail::make_pack<Real>(c23, c24) *
      (t1409 - detail::make_pack<Real>(0.032, (-0.032)) * t1362) - t1419_lanes;
  const Real t1432 = t1342 - wd6_x;
  const Real t1433 = t1411_lanes[1] + t1411_lanes[0];
  const Real t1435 = t1430_lanes[1] + t1430_lanes[0];
  const Lanes<2> t1436_lanes = detail::make_pack<Real>(s23, s24) * n23_24_x_lanes;

  // links 23 (left_eye) and 24 (right_eye), inertial wrench and inward; link 21 (neck), outward
  const Lanes<2> n23_24_y_lanes = 2.8750000000000004e-05 *
      (w23_24_x_lanes * w23_24_x_lanes - t1383_lanes) - 5.25e-06 * t1411_lanes + t1431_lanes;
  const Real f22_z = h_22_x * t1391 - minus_h_22_y * t1381 + t1435;
  const Lanes<2> t1439_lanes = detail::make_pack<Real>(c23, c24) * n23_24_y_lanes;
  const Lanes<2> n23_24_z_lanes = 1.25e-06 * t1376_lanes - t1396 + 2.8750000000000004e-05 *
      t1405_lanes + 0.00025 * a23_24_y_lanes;
  const Real t1440 = t1341 + minus_wd21_y;

  // links 7 (left_shoulder1) and 14 (right_shoulder1), outward; links 23 (left_eye) and 24
  //   (right_eye), inward
  const Lanes<2> t1441_lanes = t778_lanes - wd6_y;
  const Real t1444 = 0.04506407500000001 * t1360 - J_22_zz * minus_wd21_y - J_22_xy *
      (t1363 - t1429) + h_22_x * a22_y;
  const Real minus_f22_x = h_22_x * t1370 + minus_h_22_y * t1368 + t1427_lanes[1] + t1427_lanes[0];
  const Real t1450 = J_22_xy * t1381 - J_22_yy * t1391 - h_22_x * a22_z - n23_24_z_lanes[1] -
      (-0.032) * t1427_lanes[1];
  const Lanes<2> t1451_lanes = detail::make_pack<Real>(c23, c24) * n23_24_x_lanes -
      detail::make_pack<Real>(s23, s24) * n23_24_y_lanes +
      detail::make_pack<Real>(8.000000000000001e-06, (-8.000000000000001e-06)) * t1411_lanes;
  const Real f22_y = minus_h_22_y * (t1429 + t1364) - h_22_x * t1401 - 0.00025 * t1433;

  // links 10, 17, 22 and 23, inward; links 7 (left_shoulder1) and 14 (right_shoulder1), inertial
  //   wrench
  const Lanes<2> t1458_lanes = detail::make_pack<Real>(c10, c17) * minus_f10_17_y_lanes -
      detail::make_pack<Real>(s10, s17) * f10_17_x_lanes;
  const Real n22_x = J_22_xx * t1381 - J_22_xy * t1391 - minus_h_22_y * a22_z + t1451_lanes[1] +
      t1451_lanes[0];
  const Lanes<2> t1467_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * (t1300_lanes - t1315_lanes);
  const Lanes<2> f9_16_z_lanes = detail::make_pack<Real>(0.004500002325, (-0.004500002325)) *
      t859_lanes - 0.0022500062 * t1142_lanes + t1458_lanes;
  const Real t1471 = c22 * minus_f22_x + s22 * f22_y;

  // links 8 to 10, 15 to 17, 23, inward
  const Real n22_y = t1450 - n23_24_z_lanes[0] - 0.032 * t1427_lanes[0] - 0.095 * t1435;
  const Lanes<2> f8_15_x_lanes = detail::make_pack<Real>(0.0017499999999999998,
      (-0.0017499999999999998)) * t1239_lanes - 0.7139200499999999 * t875_lanes - f9_16_z_lanes;
  const Lanes<2> f9_16_x_lanes = 0.0022500062 * (t1103_lanes + t1148_lanes) +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * t841_lanes + t1238_lanes;
  const Lanes<2> f9_16_y_lanes = f10_17_z_lanes - (0.0022500062 * t1147_lanes +
      detail::make_pack<Real>(0.004500002325, (-0.004500002325)) * (t1104_lanes + t1148_lanes));
  const Lanes<2> t1483_lanes = 0.0017499999999999998 * (t789_lanes + (t1300_lanes + t1315_lanes));

  // links 7 (left_shoulder1) and 14 (right_shoulder1), inertial wrench; links 1 (calf) and 23
  //   (left_eye), inward
  const Lanes<2> t1488_lanes = detail::make_pack<Real>(2.6249999999999998e-05,
      (-2.6249999999999998e-05)) * t1441_lanes - 0.0002975 * t805_lanes - 8.75e-06 * t1313_lanes +
      t1467_lanes;
  const Lanes<2> t1489_lanes = 0.000147 * t778_lanes + t1328 +
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * t801_lanes -
      detail::make_pack<Real>(2.6249999999999998e-05, (-2.6249999999999998e-05)) * t800_lanes;
  const Real n22_z = t1444 + minus_h_22_y * a22_x + t1436_lanes[1] + t1439_lanes[1] +
      t1436_lanes[0] + t1439_lanes[0] - 2.375e-05 * t1433;
  const Real t1491 = tau[23] - n23_24_z_lanes[1];
  const Real t1493 = tau[22] - n23_24_z_lanes[0];

  // links 1, 9, 16, inward; links 8, 15, 23 and 24, bias force
  const Lanes<2> t1494_lanes = detail::make_pack<Real>(s9, s16) * f9_16_y_lanes;
  const Lanes<2> t1495_lanes = t1388_lanes - (detail::make_pack<Real>(c9, c16) * t1346_lanes -
      detail::make_pack<Real>(s9, s16) * t1347_lanes);
  const Real t1500 = tau[21] - n22_z;
  const Lanes<2> t1501_lanes = 3.108108108108109 * detail::make_pack<Real>(t1493, t1491);
  const Lanes<2> t1502_lanes = 27.027027027027028 * detail::make_pack<Real>(t1493, t1491);

  // links 8 and 9, 15 and 16, 22, inward
  const Lanes<2> t1505_lanes = detail::make_pack<Real>(s9, s16) * f9_16_x_lanes +
      detail::make_pack<Real>(c9, c16) * f9_16_y_lanes;
  const Lanes<2> n7_14_x_lanes = t1380_lanes + t1371_lanes + n8_15_z_lanes;
  const Real n21_x = J_21_xx * t1359 - minus_J_21_xz * t1432 -
      (s22 * n22_y - c22 * n22_x + link21_to_22_z * f22_z);
  const Lanes<2> t1508_lanes = 0.7139200499999999 * t831_lanes +
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) * t1240_lanes +
      detail::make_pack<Real>(c9, c16) * f9_16_x_lanes - t1494_lanes;
  const Real n21_y = minus_J_21_xz * (t1355 - t1356) - J_21_yy * t1440 + h_21_x * a6_x +
      (n22_z - link21_to_22_z * t1471);

  // links 9, 16, 23 and 24, bias force; links 9 (left_upperarm) and 16 (right_upperarm), inward
  const Lanes<2> t1512_lanes = t1322_lanes + t310_lanes * t1330_lanes;
  const Lanes<2> t1513_lanes = t1299_lanes + t311_lanes * t1330_lanes;
  const Lanes<2> f8_15_y_lanes = 0.7139200499999999 * t815_lanes -
      detail::make_pack<Real>(0.0017499999999999998, (-0.0017499999999999998)) *
      (t1241_lanes + t863_lanes) + t1505_lanes;
  const Lanes<2> t1514_lanes = detail::make_pack<Real>(s23, s24) * t1501_lanes;
  const Lanes<2> t1515_lanes = detail::make_pack<Real>(s23, s24) * t1502_lanes;

  // links 7 and 8, 14 and 15, inward; links 23 (left_eye) and 24 (right_eye), bias force
  const Lanes<2> f7_14_x_lanes = t1508_lanes - 0.0017499999999999998 *
      (t1291_lanes + t1315_lanes + t1441_lanes);
  const Lanes<2> t1517_lanes = detail::make_pack<Real>(c8, c15) * n8_15_y_lanes;
  const Lanes<2> t1521_lanes = detail::make_pack<Real>(c7, c14) * n7_14_x_lanes;
  const Lanes<2> n7_14_y_lanes = t1488_lanes + t1371_lanes +
      (detail::make_pack<Real>(c8, c15) * n8_15_x_lanes - detail::make_pack<Real>(s8, s15) *
      n8_15_y_lanes);
  const Lanes<2> t1524_lanes = detail::make_pack<Real>(c23, c24) * t1502_lanes;

  // links 8 (left_shoulder2) and 15 (right_shoulder2), bias force; links 7 and 8, 14 and 15,
  //   inward
  const Lanes<2> t1526_lanes = detail::make_pack<Real>(s9, s16) * t1346_lanes +
      detail::make_pack<Real>(c9, c16) * t1347_lanes + t413_lanes * t1495_lanes;
  const Real t1527 = 1.26882463592404 * t762 + J_6_zz * wd5_x - J_6_xz * t773 + minus_h_6_x *
      minus_a6_y + c21 * n21_x;
  const Lanes<2> t1528_lanes = t1266_lanes + t1329_lanes * t1495_lanes;
  const Lanes<2> t1533_lanes = detail::make_pack<Real>(s7, s14) * n7_14_y_lanes;
  const Lanes<2> t1534_lanes = t1489_lanes + 8.75e-06 * (t1291_lanes - t1300_lanes) +
      detail::make_pack<Real>(s8, s15) * n8_15_x_lanes + t1517_lanes;

  // links 8, 15, 22 to 24, bias force; links 7 (left_shoulder1) and 14 (right_shoulder1),
  //   articulated inertia; links 8 (left_shoulder2) and 15 (right_shoulder2), inward
  const Real t1536 = t1500 + (t1514_lanes[1] + t1514_lanes[0]);
  const Lanes<2> t1538_lanes = detail::make_pack<Real>((-2.6249999999999998e-05),
      2.6249999999999998e-05) / t479_lanes;
  const Lanes<2> f7_14_y_lanes = detail::make_pack<Real>(c8, c15) * f8_15_x_lanes -
      detail::make_pack<Real>(s8, s15) * f8_15_y_lanes + t1483_lanes;
  const Lanes<2> t1545_lanes = t415_lanes * t1495_lanes;
  const Lanes<2> t1546_lanes = detail::make_pack<Real>(c23, c24) * t1501_lanes;
  const Real t1547 = t1524_lanes[1] + t1524_lanes[0];
  const Lanes<2> n7_14_z_lanes = t1534_lanes + 0.0017499999999999998 *
      (a7_14_y_lanes + a7_14_x_lanes);

  // links 1, 7, 14, inward; links 8 (left_shoulder2) and 15 (right_shoulder2), bias force
  const Real t1556 = tau[13] - n7_14_z_lanes[1];
  const Real t1557 = tau[6] - n7_14_z_lanes[0];
  const Lanes<2> t1558_lanes = t416_lanes * t1495_lanes -
      (detail::make_pack<Real>(s9, s16) * t1512_lanes - detail::make_pack<Real>(c9, c16) *
      t1513_lanes);
  const Lanes<2> t1559_lanes = detail::make_pack<Real>(s10, s17) * t1297_lanes +
      detail::make_pack<Real>(c10, c17) * t1298_lanes + t312_lanes * t1330_lanes - t1545_lanes;
  const Lanes<2> t1560_lanes = detail::make_pack<Real>(s7, s14) * f7_14_x_lanes +
      detail::make_pack<Real>(c7, c14) * f7_14_y_lanes;

  // links 7 and 8, 15, inward; links 7, 14, 22, bias force
  const Lanes<2> f7_14_z_lanes = detail::make_pack<Real>(s8, s15) * f8_15_x_lanes +
      detail::make_pack<Real>(c8, c15) * f8_15_y_lanes + 0.0017499999999999998 *
      (t805_lanes - t1313_lanes);
  const Lanes<2> t1562_lanes = detail::make_pack<Real>(t1557, t1556) -
      (detail::make_pack<Real>(c8, c15) * t1526_lanes - detail::make_pack<Real>(s8, s15) *
      t1528_lanes);
  const Real t1565 = t1546_lanes[1] + t1546_lanes[0] + t444 * t1536;
  const Real t1567 = f7_14_z_lanes[1] + f7_14_z_lanes[0];
  const Real t1568 = t449 * t1536;

  // links 7, 14, 22, bias force; link 22 (head), inward
  const Lanes<2> t1569_lanes = t522_lanes * t1562_lanes;
  const Real t1571 = t448 * t1536 - (t1515_lanes[1] + t1515_lanes[0]);
  const Real n21_z = minus_J_21_xz * t1343 - (0.0048105000000000005 * t1342 + J_21_zz * wd6_x) -
      h_21_x * minus_a21_y - (s22 * n22_x + c22 * n22_y);
  const Real t1577 = t443 * t1536 - t1491 - (-0.032) * t1515_lanes[1] - t1493 - 0.032 *
      t1515_lanes[0] - 0.095 * t1547;
  const Lanes<2> t1579_lanes = t419_lanes * t1495_lanes -
      (detail::make_pack<Real>(c9, c16) * t1512_lanes + detail::make_pack<Real>(s9, s16) *
      t1513_lanes) + t1569_lanes;
  const Lanes<2> t1580_lanes = detail::make_pack<Real>(c8, c15) * t1559_lanes -
      detail::make_pack<Real>(s8, s15) * t1558_lanes + t521_lanes * t1562_lanes;
  const Real t1581 = t1547 + t454 * t1536;

  // links 1 (calf) and 7 (left_shoulder1), inward; links 7, 14, 22, bias force
  const Real t1582 = tau[20] - n21_z;
  const Lanes<2> t1584_lanes = t1388_lanes + t1538_lanes * t1562_lanes;
  const Real t1585 = t1527 - s21 * n21_y + t1521_lanes[1] - t1533_lanes[1] - (-0.18) *
      t1560_lanes[1] + t1521_lanes[0] - t1533_lanes[0];
  const Real t1588 = s22 * t1568 - c22 * t1571;
  const Lanes<2> t1591_lanes = t543_lanes * t1562_lanes -
      (detail::make_pack<Real>(c8, c15) * t1528_lanes + detail::make_pack<Real>(s8, s15) *
      t1526_lanes);

  // links 7, 14, 21, bias force; link 7 (left_shoulder1), inward
  const Lanes<2> t1592_lanes = detail::make_pack<Real>(c7, c14) * t1584_lanes;
  const Lanes<2> t1594_lanes = detail::make_pack<Real>(s7, s14) * t1579_lanes +
      detail::make_pack<Real>(c7, c14) * t1580_lanes;
  const Lanes<2> t1596_lanes = detail::make_pack<Real>(s7, s14) * t1591_lanes;
  const Real n6_z = t1585 - 0.18 * t1560_lanes[0] - 0.226 * t1567;
  const Real t1599 = t1582 - (s22 * t1565 - c22 * t1577);
  const Lanes<2> t1603_lanes = detail::make_pack<Real>(s8, s15) * t1559_lanes +
      detail::make_pack<Real>(c8, c15) * t1558_lanes + t526_lanes * t1562_lanes;

  // links 1, 7, 14, inward; links 6 and 7, 14, bias force
  const Real t1605 = tau[5] - n6_z;
  const Lanes<2> t1606_lanes = detail::make_pack<Real>(c7, c14) * f7_14_x_lanes -
      detail::make_pack<Real>(s7, s14) * f7_14_y_lanes;
  const Real t1607 = minus_h_6_x * a6_z - J_6_yy * t842 - J_6_xz * (t852 - t833) + s21 * n21_x;
  const Real t1608 = t1603_lanes[1] + t1603_lanes[0];
  const Lanes<2> t1609_lanes = detail::make_pack<Real>(c7, c14) * t1579_lanes -
      detail::make_pack<Real>(s7, s14) * t1580_lanes;

  // link 21 (neck), bias force; links 7, 14, 22, inward
  const Real t1613 = c22 * t1565 + s22 * t1577 + link21_to_22_z * t1581 + t571 * t1599;
  const Real t1614 = t1500 - link21_to_22_z * t1588 - t572 * t1599;
  const Real t1617 = t1606_lanes[1] + t1606_lanes[0];
  const Real minus_f21_x = h_21_x * (w21_y * w21_y + t1356) + t1471;
  const Lanes<2> t1619_lanes = detail::make_pack<Real>(s7, s14) * n7_14_x_lanes +
      detail::make_pack<Real>(c7, c14) * n7_14_y_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      t1606_lanes;
  const Real t1620 = t1588 + t585 * t1599;
  const Real f21_y = h_21_x * t1432 + f22_z;

  // link 5 (chest2), outward; links 6 and 7, 14, 21, bias force
  const Real t1621 = minus_w5_y * minus_w5_y;
  const Lanes<2> t1622_lanes = detail::make_pack<Real>(s7, s14) * t1584_lanes +
      detail::make_pack<Real>(c7, c14) * t1591_lanes + detail::make_pack<Real>(0.18, (-0.18)) *
      t1609_lanes;
  const Real t1623 = t1609_lanes[1] + t1609_lanes[0];
  const Real t1624 = t1581 + t605 * t1599;
  const Real t1625 = t1605 - t1592_lanes[1] + t1596_lanes[1] + (-0.18) * t1594_lanes[1] + c21 *
      t1613 + s21 * t1614;

  // links 7 (left_shoulder1) and 22 (head), inward
  const Real n6_x = J_6_xx * t788 + J_6_xz * t849 - n21_z + t1619_lanes[1] + t1619_lanes[0];
  const Real n6_y = t1607 + c21 * n21_y + n7_14_z_lanes[1] + n7_14_z_lanes[0] + 0.226 * t1617;
  const Real f6_z = t1617 - minus_h_6_x * t842 - c21 * minus_f21_x - s21 * f21_y;
  const Real f21_z = h_21_x * t1440 + (s22 * minus_f22_x - c22 * f22_y);
  const Real f6_y = t1567 - minus_h_6_x * t849 - s21 * minus_f21_x + c21 * f21_y;

  // link 6 (chest3), bias force; link 5 (chest2), inertial wrench; links 6 (chest3) and 7
  //   (left_shoulder1), inward
  const Real t1626 = t1625 - t1592_lanes[0] + t1596_lanes[0] + 0.18 * t1594_lanes[0] + 0.226 *
      t1608;
  const Real t1627 = 0.10961925816937634 * t753 - J_5_zz * minus_wd5_z - J_5_xy * (t1621 - t824) +
      (h_5_x * a5_y + minus_h_5_y * a5_x);
  const Real f6_x = minus_h_6_x * t843 - f21_z + t1560_lanes[1] + t1560_lanes[0];
  const Real n5_z = t1627 + (s6 * n6_x + c6 * n6_y + minus_link5_to_6_y * f6_z);
  const Real t1628 = t1622_lanes[1] - t1582 + t1622_lanes[0] + t675 * t1626;

  // link 6 (chest3), bias force; link 1 (calf), inward
  const Real t1629 = t1623 - c21 * t1620 - s21 * t1624 + t673 * t1626;
  const Real t1630 = t1594_lanes[1] - (t637 * t1599 - (s22 * t1571 + c22 * t1568)) +
      t1594_lanes[0] - t676 * t1626;
  const Real t1631 = t1608 - s21 * t1620 + c21 * t1624 + t677 * t1626;
  const Real t1632 = tau[4] - n5_z;
  const Real t1633 = t1556 - s21 * t1613 + c21 * t1614 + t1557 + t674 * t1626 + 0.226 * t1623;

  // link 6 (chest3), inward; link 4 (chest1), outward; link 6 (chest3), bias force
  const Real t1634 = s6 * f6_x + c6 * f6_y;
  const Real f5_x = f6_z - (h_5_x * (t1621 + t825) + minus_h_5_y * t840);
  const Real f5_y = minus_h_5_y * t834 - h_5_x * t756 + (c6 * f6_x - s6 * f6_y);
  const Real t1635 = c4 * t709;
  const Real t1636 = 2.0 * wd4_x;
  const Real t1637 = s6 * t1630 + c6 * t1631;
  const Real n5_y = J_5_xy * t837 - J_5_yy * t759 + h_5_x * minus_a5_z + (c6 * n6_x - s6 * n6_y);
  const Real t1638 = qd[3] * qd[3];

  // link 6 (chest3), inward; link 3 (hip), articulated inertia; link 5 (chest2), bias force
  const Real f5_z = h_5_x * t759 - minus_h_5_y * t837 + t1634;
  const Real t1639 = t727 * t1060 + t730 * t1031;
  const Real n5_x = J_5_xx * t837 - J_5_xy * t759 + minus_h_5_y * minus_a5_z +
      (n6_z - minus_link5_to_6_y * t1634);
  const Real t1640 = t1632 - (s6 * t1628 + c6 * t1633 + minus_link5_to_6_y * t1629);
  const Real t1641 = t1639 - t745;

  // link 5 (chest2), inward and bias force
  const Real t1642 = c4 * (s5 * f5_y - c5 * f5_x) + s4 * f5_z;
  const Real minus_f4_z = t1636 * t698 + (s5 * f5_x + c5 * f5_y);
  const Real t1643 = h_2_x * c2 + minus_h_2_y * s2;
  const Real t1644 = c6 * t1630 - s6 * t1631 + t720 * t1640;
  const Real t1645 = t1629 + t719 * t1640;
  const Real t1646 = c6 * t1628 - s6 * t1633 + t723 * t1640;
  const Real t1647 = t1605 - minus_link5_to_6_y * t1637 - t722 * t1640;
  const Real f4_x = (t818 + t1638) * t715 - t1642;

  // links 2 (thigh) and 3 (hip), articulated inertia; link 4 (chest1), inward
  const Real t1648 = J_2_zz + (t730 * (t727 * t1031 + t730 * (t974 + t1023)) + t727 * t1639);
  const Real f3_y = minus_h_3_y * t818 + minus_f4_z;
  const Real t1649 = minus_h_3_y * a3_x + t1636 * t1635 - s4 * (s5 * n5_y - c5 * n5_x);
  const Real f3_x = minus_h_3_x * t818 + f4_x;
  const Real inverse_D2 = 1.0 / t1648;

  // links 1, 3 and 4, inward; links 4 (chest1) and 5 (chest2), bias force
  const Real t1650 = c2_plus_3 * f3_x - s2_plus_3 * f3_y;
  const Real t1651 = c4 * (s5 * t1644 - c5 * t1645) + s4 * (t1637 + t721 * t1640);
  const Real t1652 = tau[3] - t698 * a3_x + t818 * t1635 + (n5_y + t1646) * c5 + (n5_x + t1647) *
      s5;
  const Real n3_z = t1649 - link4_to_5_z * t1642 + (J_4_xz * t1638 + n5_z) * c4 - t718 * a3_y;
  const Real f2_x = t1650 - t811 * t1643;
  const Real t1653 = tau[2] - n3_z;

  // link 2 (thigh), articulated inertia; links 3 (hip) and 5 (chest2), bias force; link 3 (hip),
  //   inward
  const Real t1654 = t1641 * inverse_D2;
  const Real t1655 = c4 * t1632 - s4 * (s5 * t1646 - c5 * t1647) - link4_to_5_z * t1651;
  const Real n2_z = t1643 * a2_y + t745 * minus_a1_x +
      (n3_z + (t730 * (s2_plus_3 * f3_x + c2_plus_3 * f3_y) + t727 * t1650));
  const Real t1656 = t1653 - (t1655 + t785 * t1652);
  const Real t1657 = t786 * t1652 - t1651 + t938 * t1656;
  const Real t1658 = t787 * t1652 - (s5 * t1645 + c5 * t1644) + t928 * t1656;

  // link 1 (calf), articulated inertia; links 7 (left_shoulder1) and 14 (right_shoulder1),
  //   acceleration; links 1 to 3, bias force
  const Real inverse_D1 = 1.0 / (J_1_zz + 0.188356 * (t1060 - t1641 * t1654));
  const Lanes<2> t1659_lanes = inverse_D7_14_lanes * t1562_lanes;
  const Real t1660 = c2_plus_3 * t1657 + s2_plus_3 * t1658;
  const Real t1661 = tau[1] - n2_z - (t1653 + (t730 * (s2_plus_3 * t1657 - c2_plus_3 * t1658) +
      t727 * t1660));
  const Real t1662 = tau[0] - 0.1569597827085 * c1 + 299.6743959432 * s1 - tau[1] -
      minus_link1_to_2_y * (f2_x + (t1660 + t1654 * t1661));

  // links 1 (calf) and 2 (thigh), acceleration
  const Real qdd_0 = inverse_D1 * t1662;
  qdd[0] = qdd_0;
  const Real t1663 = minus_link1_to_2_y * qdd_0;
  const Real qdd_1 = inverse_D2 * t1661 - (t1654 * t1663 + qdd_0);
  qdd[1] = qdd_1;
  const Real t1664 = qdd_0 + qdd_1;

  // links 3, 8, 15, acceleration
  const Real t1665 = t1664 * t730;
  const Real t1666 = t1663 + t1664 * t727;
  const Lanes<2> t1667_lanes = inverse_D8_15_lanes * t1495_lanes;
  const Real t1668 = c2_plus_3 * t1666 + s2_plus_3 * t1665;
  const Real t1669 = c2_plus_3 * t1665 - s2_plus_3 * t1666;
  const Real qdd_2 = inverse_D3 * t1656 - (t938 * t1668 - t928 * t1669 + t1664);
  qdd[2] = qdd_2;
  const Real t1670 = t1664 + qdd_2;

  // links 4 (chest1) and 5 (chest2), acceleration
  const Real t1671 = s4 * t1670;
  const Real t1672 = c4 * t1670;
  const Real t1673 = t1668 + link4_to_5_z * t1670;
  const Real t1674 = c4 * t1673;
  const Real qdd_3 = inverse_D4 * t1652 - (t786 * t1668 - t787 * t1669 + t785 * t1670);
  qdd[3] = qdd_3;
  const Real t1675 = s4 * t1673;

  // links 5, 9, 16, acceleration
  const Lanes<2> t1676_lanes = inverse_D9_16_lanes * t1330_lanes;
  const Real t1677 = c5 * t1671 - s5 * qdd_3;
  const Real t1678 = s5 * t1671 + c5 * qdd_3;
  const Real t1679 = c5 * t1674 + s5 * t1669;
  const Real t1680 = c5 * t1669 - s5 * t1674;

  // links 5 and 6, 10, 17, acceleration
  const Real t1681 = t1675 + minus_link5_to_6_y * t1677;
  const Real t1682 = t719 * t1679 + t720 * t1680 - t721 * t1675 +
      (t1672 - (t722 * t1677 + t723 * t1678));
  const Real t1683 = c6 * t1680 - s6 * t1681;
  const Real t1684 = s6 * t1680 + c6 * t1681;
  const Lanes<2> t1685_lanes = inverse_D10_17_lanes * t1269_lanes;
  const Real qdd_4 = inverse_D5 * t1640 - t1682;
  qdd[4] = qdd_4;
  const Real t1686 = t1672 + qdd_4;

  // links 6 (chest3) and 7 (left_shoulder1), acceleration
  const Real t1687 = s6 * t1686 - c6 * t1678;
  const Real t1688 = s6 * t1678 + c6 * t1686;
  const Real t1689 = t1679 + minus_link5_to_6_y * t1686;
  const Real t1690 = t1689 + 0.226 * t1688;
  const Real t1691 = t1690 + 0.18 * t1687;

  // links 6, 11, 18, acceleration
  const Lanes<2> t1692_lanes = inverse_D11_18_lanes * t1206_lanes;
  const Real t1693 = t673 * t1689 - (t676 * t1683 + t677 * t1684) +
      (t675 * t1687 + t674 * t1688 + t1677);
  const Real qdd_5 = inverse_D6 * t1626 - t1693;
  qdd[5] = qdd_5;
  const Real t1694 = t1677 + qdd_5;

  // links 7, 12, 19, acceleration
  const Real t1695 = t1683 - 0.18 * t1694;
  const Real t1696 = s7 * t1687 + c7 * t1694;
  const Real t1697 = c7 * t1687 - s7 * t1694;
  const Real t1698 = t1684 + 0.226 * t1694;
  const Lanes<2> t1699_lanes = inverse_D12_19_lanes * t1145_lanes;

  // links 7 and 8, 13, 20, acceleration
  const Real t1700 = s7 * t1695 + c7 * t1691;
  const Real t1701 = c7 * t1695 - s7 * t1691;
  const Real t1702 = c8 * t1701 - s8 * t1698;
  const Lanes<2> t1703_lanes = 1065.380700001509 * t1119_lanes;
  const Real t1704 = s8 * t1701 + c8 * t1698;

  // links 7, 9, 14, acceleration
  const Real t1705 = t1683 - (-0.18) * t1694;
  const Real t1706 = t522_lanes[0] * t1700 + t521_lanes[0] * t1701 - t526_lanes[0] * t1698 +
      (t1538_lanes[0] * t1696 + t543_lanes[0] * t1697 + t1688);
  const Real t1707 = t1690 + (-0.18) * t1687;
  const Real qdd_6 = t1659_lanes[0] - t1706;
  qdd[6] = qdd_6;
  const Real t1708 = c9 * t1700 - s9 * t1704;
  const Real t1709 = c9 * t1704 + s9 * t1700;
  const Real t1710 = s14 * t1687 + c14 * t1694;
  const Real t1711 = t1688 + qdd_6;
  const Real t1712 = c14 * t1687 - s14 * t1694;
  const Real t1713 = s14 * t1705 + c14 * t1707;

  // links 8, 14 and 15, acceleration
  const Real t1714 = c14 * t1705 - s14 * t1707;
  const Real t1715 = c8 * t1711 - s8 * t1697;
  const Real t1716 = c8 * t1697 + s8 * t1711;
  const Real t1717 = c15 * t1714 - s15 * t1698;
  const Real t1718 = s15 * t1714 + c15 * t1698;

  // links 14 (right_shoulder1) and 16 (right_upperarm), acceleration
  const Real t1719 = t522_lanes[1] * t1713 + t521_lanes[1] * t1714 - t526_lanes[1] * t1698 +
      (t1538_lanes[1] * t1710 + t543_lanes[1] * t1712 + t1688);
  const Real t1720 = c16 * t1713 - s16 * t1718;
  const Real qdd_13 = t1659_lanes[1] - t1719;
  qdd[13] = qdd_13;
  const Real t1721 = c16 * t1718 + s16 * t1713;

  // links 8 (left_shoulder2) and 14 (right_shoulder1), acceleration
  const Real t1722 = t419_lanes[0] * t1700 - (t415_lanes[0] * t1702 + t416_lanes[0] * t1704) +
      (t413_lanes[0] * t1715 - t1329_lanes[0] * t1716 + t1696);
  const Real t1723 = t1688 + qdd_13;
  const Real qdd_7 = t1667_lanes[0] - t1722;
  qdd[7] = qdd_7;
  const Real t1724 = t1696 + qdd_7;

  // links 9 and 10, 15, acceleration
  const Real t1725 = c15 * t1723 - s15 * t1712;
  const Real t1726 = c15 * t1712 + s15 * t1723;
  const Real t1727 = s9 * t1715 + c9 * t1724;
  const Real t1728 = c9 * t1715 - s9 * t1724;
  const Real t1729 = t1708 - 0.282 * t1728;
  const Real t1730 = t419_lanes[1] * t1713 - (t415_lanes[1] * t1717 + t416_lanes[1] * t1718) +
      (t413_lanes[1] * t1725 - t1329_lanes[1] * t1726 + t1710);
  const Real t1731 = 0.282 * t1727 - t1709;
  const Real qdd_14 = t1667_lanes[1] - t1730;
  qdd[14] = qdd_14;
  const Real t1732 = t312_lanes[0] * t1702 - (t310_lanes[0] * t1708 + t311_lanes[0] * t1709) +
      (t308_lanes[0] * t1727 + t309_lanes[0] * t1728 - t1716);
  const Real t1733 = t1710 + qdd_14;
  const Real t1734 = c10 * t1729 + s10 * t1702;
  const Real t1735 = c10 * t1702 - s10 * t1729;
  const Real qdd_8 = t1676_lanes[0] - t1732;
  qdd[8] = qdd_8;
  const Real t1736 = qdd_8 - t1716;

  // links 10 and 11, 16, acceleration
  const Real t1737 = s16 * t1725 + c16 * t1733;
  const Real t1738 = c16 * t1725 - s16 * t1733;
  const Real t1739 = c11 * t1731 - s11 * t1734;
  const Real t1740 = c11 * t1734 + s11 * t1731;
  const Real t1741 = c10 * t1727 - s10 * t1736;
  const Real t1742 = s10 * t1727 + c10 * t1736;

  // links 16 (right_upperarm) and 17 (right_lowerarm), acceleration
  const Real t1743 = t1720 - 0.282 * t1738;
  const Real t1744 = 0.282 * t1737 - t1721;
  const Real t1745 = t312_lanes[1] * t1717 - (t310_lanes[1] * t1720 + t311_lanes[1] * t1721) +
      (t308_lanes[1] * t1737 + t309_lanes[1] * t1738 - t1726);
  const Real t1746 = c17 * t1743 + s17 * t1717;
  const Real t1747 = c17 * t1717 - s17 * t1743;

  // links 10, 16, 21, acceleration
  const Real t1748 = s21 * t1688 + c21 * t1694;
  const Real qdd_15 = t1676_lanes[1] - t1745;
  qdd[15] = qdd_15;
  const Real t1749 = c21 * t1688 - s21 * t1694;
  const Real t1750 = t213_lanes[0] * t1734 + t214_lanes[0] * t1735 + t215_lanes[0] * t1731 +
      (t210_lanes[0] * t1741 - t208_lanes[0] * t1742 + t1728);
  const Real t1751 = c21 * t1689 - s21 * t1684;
  const Real t1752 = qdd_15 - t1726;
  const Real t1753 = c21 * t1684 + s21 * t1689;
  const Real qdd_9 = t1685_lanes[0] - t1750;
  qdd[9] = qdd_9;

  // links 10, 17 and 18, acceleration
  const Real t1754 = c18 * t1744 - s18 * t1746;
  const Real t1755 = c18 * t1746 + s18 * t1744;
  const Real t1756 = t1728 + qdd_9;
  const Real t1757 = c17 * t1737 - s17 * t1752;
  const Real t1758 = s17 * t1737 + c17 * t1752;

  // links 11, 21 and 22, acceleration
  const Real t1759 = t1751 + link21_to_22_z * t1749;
  const Real t1760 = t1753 + link21_to_22_z * t1748;
  const Real t1761 = c11 * t1741 + s11 * t1756;
  const Real t1762 = c11 * t1756 - s11 * t1741;
  const Real t1763 = t585 * t1751 + t605 * t1753 + t637 * t1683 +
      (t571 * t1748 + t572 * t1749 + t1687);
  const Real t1764 = c22 * t1759 + s22 * t1683;
  const Real qdd_20 = inverse_D21 * t1599 + t1763;

  // links 12, 17, 21, acceleration
  qdd[20] = qdd_20;
  const Real t1765 = t1740 - 0.269 * t1762;
  const Real t1766 = t213_lanes[1] * t1746 + t214_lanes[1] * t1747 + t215_lanes[1] * t1744 +
      (t210_lanes[1] * t1757 - t208_lanes[1] * t1758 + t1738);
  const Real t1767 = qdd_20 - t1687;
  const Real t1768 = t1739 + 0.269 * t1761;

  // links 11 and 12, 17, acceleration
  const Real qdd_16 = t1685_lanes[1] - t1766;
  qdd[16] = qdd_16;
  const Real t1769 = t127_lanes[0] * t1739 - t126_lanes[0] * t1740 - t128_lanes[0] * t1735 +
      (t124_lanes[0] * t1761 + t125_lanes[0] * t1762 + t1742);
  const Real t1770 = t1738 + qdd_16;
  const Real t1771 = c12 * t1735 - s12 * t1765;

  // links 11 (left_wrist1) and 22 (head), acceleration
  const Real t1772 = t448 * t1764 + t449 * (c22 * t1683 - s22 * t1759) - t454 * t1760;
  const Real t1773 = c22 * t1748 - s22 * t1767;
  const Real t1774 = s22 * t1748 + c22 * t1767;
  const Real qdd_10 = t1692_lanes[0] - t1769;
  qdd[10] = qdd_10;
  const Real t1775 = t1742 + qdd_10;

  // links 12, 18, 23, acceleration
  const Real t1776 = c18 * t1757 + s18 * t1770;
  const Real t1777 = c18 * t1770 - s18 * t1757;
  const Real t1778 = 0.095 * t1774 - t1760;
  const Real t1779 = t47_lanes[0] * t1771 - t48_lanes[0] * (c12 * t1765 + s12 * t1735) +
      t49_lanes[0] * t1768;
  const Real t1780 = s12 * t1761 + c12 * t1775;

  // links 18 and 19, 22, acceleration
  const Real t1781 = t1755 - 0.269 * t1777;
  const Real t1782 = t1754 + 0.269 * t1776;
  const Real qdd_21 = inverse_D22 * t1536 - (t1772 + (t1749 - (t444 * t1773 + t443 * t1774)));
  qdd[21] = qdd_21;
  const Real t1783 = t127_lanes[1] * t1754 - t126_lanes[1] * t1755 - t128_lanes[1] * t1747 +
      (t124_lanes[1] * t1776 + t125_lanes[1] * t1777 + t1758);
  const Real t1784 = c19 * t1747 - s19 * t1781;
  const Real t1785 = t1749 + qdd_21;
  const Real qdd_17 = t1692_lanes[1] - t1783;
  qdd[17] = qdd_17;

  // links 12, 18 and 19, acceleration
  const Real qdd_11 = t1699_lanes[0] - (t1779 + (t1762 - t46_lanes[0] * t1780));
  qdd[11] = qdd_11;
  const Real t1786 = t1758 + qdd_17;
  const Real t1787 = t47_lanes[1] * t1784 - t48_lanes[1] * (c19 * t1781 + s19 * t1747) +
      t49_lanes[1] * t1782;
  const Real t1788 = s19 * t1776 + c19 * t1786;

  // links 13, 23 and 24, acceleration
  const Real t1789 = t27_lanes[0] * t1780 - t23_lanes[0] * (t1762 + qdd_11) +
      (c12 * t1761 - s12 * t1775);
  const Real t1790 = 27.027027027027028 * (c23 * t1778 - s23 * (t1764 - 0.032 * t1774)) +
      (t1774 - 3.108108108108109 * (c23 * t1773 + s23 * t1785));
  const Real t1791 = 27.027027027027028 * (c24 * t1778 - s24 * (t1764 - (-0.032) * t1774)) +
      (t1774 - 3.108108108108109 * (c24 * t1773 + s24 * t1785));
  qdd[22] = 108108.1081081081 * t1493 - t1790;
  qdd[23] = 108108.1081081081 * t1491 - t1791;

  // links 13, 19 and 20, acceleration
  qdd[12] = t1703_lanes[0] - (t11_lanes[0] * t1768 - t9_lanes[0] * t1771 + t1789);
  const Real qdd_18 = t1699_lanes[1] - (t1787 + (t1777 - t46_lanes[1] * t1788));
  qdd[18] = qdd_18;
  const Real t1792 = t27_lanes[1] * t1788 - t23_lanes[1] * (t1777 + qdd_18) +
      (c19 * t1776 - s19 * t1786);
  qdd[19] = t1703_lanes[1] - (t11_lanes[1] * t1782 - t9_lanes[1] * t1784 + t1792);
}

}  // namespace humanoid24

#undef TREELINE_RESTRICT
