// SPDX-License-Identifier: 0BSD
// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points.
// 1001 flops (add 395, mul 600, div 6), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

template <int count>
using Lanes = detail::Pack<Real, count>;
void lambda_inverse(const Real (&TREELINE_RESTRICT q)[9],
    Real (&TREELINE_RESTRICT Lambda_inv)[36]) noexcept {
  // constants
  const Real minus_h_8_y = 0.0028799999999999997;
  const Real minus_link6_to_7_x = 0.0203;
  const Real minus_link6_to_7_y = 0.4331;
  const Real J_7_yy = 0.00065;
  const Real J_6_zz = 0.312455249;
  const Real minus_h_6_x = 0.025374999999999998;
  const Real minus_h_6_y = 0.861795;
  const Real link5_to_6_x = 0.4318;
  const Real J_6_yz = 0.004704000000000001;
  const Real link5_to_6_z = 0.1501;
  const Real minus_J_5_xz = 0.690314699;
  const Real minus_J_5_yz = 0.023750999999999998;
  const Real J_5_zz = 1.7481140020000001;
  const Real h_5_x = 3.79559;
  const Real h_5_y = 0.10439999999999999;
  const Real h_4_y = 4.9338049999999996;
  const Real mass_2 = 186.45;
  const Real link9_to_tool_z = 0.05625;

  // sines and cosines
  const Real angles[6] = {q[7], q[6], q[4], q[5], q[2], q[3]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c8 = cosines[0];
  const Real c7 = cosines[1];
  const Real s5 = sines[2];
  const Real s6 = sines[3];
  const Real c5 = cosines[2];
  const Real c6 = cosines[3];
  const Real c3 = cosines[4];
  const Real c4 = cosines[5];
  const Real s3 = sines[4];
  const Real s4 = sines[5];
  const Real s7 = sines[1];
  const Real s8 = sines[0];

  // link 8 (link5), articulated inertia
  const Real t1 = 0.00024216 * s8;
  const Real t2 = minus_h_8_y * s8;
  const Real t3 = 0.012916407125949918 * s8;
  const Real t4 = link5_to_6_x * c5;
  const Real t5 = link5_to_6_x * s5;
  const Real t6 = s8 * t1;
  const Real t7 = s8 * t3;
  const Real t8 = c8 * t3;
  const Real t9 = c8 * t1;
  const Real s56 = s5 * c6 + c5 * s6;
  const Real minus_c56 = s5 * s6 - c5 * c6;
  const Real t10 = t7 - 0.012916407125949918;

  // link 7 (link4), articulated inertia and force propagation
  const Real t11 = c7 * t8;
  const Real t12 = s7 * t8;
  const Real inverse_D7 = 1.0 / (0.0015999999999999999 + t6);
  const Real t13 = c7 * s56;
  const Real t14 = minus_link6_to_7_x * s56 - minus_link6_to_7_y * minus_c56;

  // link 7 (link4), articulated inertia
  const Real t15 = minus_link6_to_7_x * minus_c56 + minus_link6_to_7_y * s56;
  const Real t16 = minus_h_6_x * minus_c56 + minus_h_6_y * s56;
  const Real t17 = t2 * inverse_D7;
  const Real t18 = t9 * inverse_D7;
  const Real t19 = t2 * t17;
  const Real t20 = t9 * t17 - minus_h_8_y * c8;
  const Real t21 = 0.0011921599999999998 - t6 - t9 * t18;
  const Real t22 = s7 * (t10 + t19);
  const Real t23 = c7 * t20;
  const Real t24 = s7 * (t21 - J_7_yy);
  const Real t25 = s7 * t22;
  const Real t26 = c7 * t23;
  const Real t27 = c7 * t22;
  const Real t28 = s7 * t23;
  const Real t29 = s7 * t24;
  const Real t30 = t10 - t25;
  const Real t31 = t26 - t20;
  const Real t32 = s56 * t28;
  const Real t33 = t25 - t19;
  const Real t34 = s56 * t26;
  const Real t35 = s56 * t31;
  const Real t36 = minus_c56 * t31;
  const Real t37 = minus_c56 * t27 - s56 * t12;
  const Real t38 = s56 * t27 + minus_c56 * t12;
  const Real t39 = s56 * t32;
  const Real t40 = minus_c56 * t32;
  const Real t41 = t15 * t38;
  const Real t42 = t15 * t33 - t34;
  const Real t43 = s56 * (t30 + t7) + minus_c56 * (2.0 * t11);
  const Real s34 = s3 * c4 + c3 * s4;
  const Real t44 = s56 * t43;
  const Real t45 = t28 - (t14 * t37 - t41);
  const Real c34 = c3 * c4 - s3 * s4;

  // link 7 (link4), pose; links 5 (link2) and 7 (link4), articulated inertia
  const Real t46 = minus_c56 * s34;
  const Real t47 = t11 - minus_c56 * t43;
  const Real t48 = t44 - t7;
  const Real t49 = t30 - t44;
  const Real t50 = s56 * s34;
  const Real t51 = 3.153482265 - s5 * (1.601861202 * s5 + 0.0141984 * c5) + t15 * (t42 - t34);

  // links 7 (link4) and 8 (link5), pose
  const Real t52 = minus_c56 * c34;
  const Real t53 = s56 * c34;
  const Real t54 = s7 * s56;
  const Real t55 = s8 * minus_c56 - c8 * t13;
  const Real t56 = s7 * c34 - c7 * t46;
  const Real t57 = s7 * t46 + c7 * c34;

  // link 7 (link4), articulated inertia and pose; link 8 (link5), force propagation
  const Real t58 = t35 + (t14 * t47 + t15 * t48);
  const Real t59 = t36 - (t14 * t49 + t15 * t47);
  const Real t60 = c7 * t52 + s7 * s34;
  const Real t61 = 4.484863585399277 * t54;
  const Real t62 = s7 * t52 - c7 * s34;

  // links 8 (link5) and 9 (link6), force propagation; link 7 (link4), articulated inertia
  const Real t63 = -(link9_to_tool_z * t54);
  const Real t64 = 4.484863585399277 * t57;
  const Real t65 = t16 + t58;
  const Real t66 = t59 - (minus_h_6_x * s56 - minus_h_6_y * minus_c56);
  const Real t67 = J_6_yz * minus_c56 + (t15 * (t39 + t45) - t14 * t40 - t13 * t24);

  // link 8 (link5), pose; links 8 (link5) and 9 (link6), force propagation
  const Real t68 = c8 * t56 - s8 * t50;
  const Real t69 = -(link9_to_tool_z * t57);
  const Real t70 = 0.7477264233212907 * t55;
  const Real t71 = 4.484863585399277 * t62;
  const Real t72 = c8 * t60 + s8 * t53;
  const Real t73 = -(link9_to_tool_z * t62);
  const Real t74 = 0.7477264233212907 * t68;
  const Real t75 = s8 * t56 + c8 * t50;
  const Real t76 = -t72;

  // links 7 to 9, force propagation
  const Real t78 = -(c8 * t61);
  const Real t79 = -(c8 * t64);
  const Real t80 = s8 * t61;
  const Real t81 = -(s8 * t13 + c8 * minus_c56);
  const Real t82 = -t81;
  const Real t83 = -t75;
  const Real t84 = s8 * t64;
  const Real t85 = -(s8 * t60 - c8 * t53);
  const Real t86 = -t85;
  const Real t88 = s8 * t71;
  const Real t89 = -(link9_to_tool_z * t72);

  // link 7 (link4), force propagation; links 6 (link3) and 7 (link4), articulated inertia
  const Lanes<8> t90_lanes = -(s8 * detail::make_pack<Real>(t73, t69, t63, t76, t68, t55, t73,
      t73));
  const Lanes<8> t92_lanes = t17 * t90_lanes;
  const Real t93 = -(c8 * t71);
  const Real t95 = J_6_zz + (J_7_yy + t29 + (t15 * (t35 + t58) - t14 * (t36 + t59)));
  const Real inverse_D6 = 1.0 / t95;

  // links 7 (link4) and 8 (link5), force propagation
  const Real t98 = t76 - 4.484863585399277 * t89;
  const Lanes<8> t99_lanes = detail::make_pack<Real>(t62, t57, t54, t62, t62, t62, t62, t62) - t17 *
      t90_lanes;
  const Real t101 = -(s8 * t70 + c8 * t82);
  const Real t102 = -(s8 * t74 + c8 * t83);
  const Lanes<8> t103_lanes = c8 * detail::make_pack<Real>(t73, t69, t63, t76, t68, t55, t73, t73) +
      t18 * t90_lanes;
  const Lanes<8> t106_lanes = c7 * detail::make_pack<Real>(t93, t93, t93, t93, t79, t78, t93, t93) +
      s7 * t92_lanes;
  const Lanes<8> t108_lanes = s8 * detail::make_pack<Real>(t86, t83, t82, t86, t86, t86, t86, t86) -
      c8 * detail::make_pack<Real>(t98, t74, t70, t98, t98, t98, t98, t98);
  const Real t109 = s7 * t78 - c7 * t92_lanes[5];
  const Real t110 = -t108_lanes[2];
  const Real t111 = -t108_lanes[1];
  const Real t112 = -t108_lanes[0];
  const Real t114 = -(s8 * t98 + c8 * t86);
  const Real t119 = s7 * t79 - c7 * t92_lanes[4];
  const Real t121 = s7 * t93 - c7 * t92_lanes[3];

  // link 6 (link3), articulated inertia; link 7 (link4), force propagation
  const Real t122 = t65 * inverse_D6;
  const Real t123 = t66 * inverse_D6;
  const Real t124 = t45 * inverse_D6;
  const Real t125 = t67 * inverse_D6;
  const Lanes<8> t126_lanes = c7 * detail::make_pack<Real>(t112, t111, t110, t112, t112, t112, t112,
      t112) - s7 * t99_lanes;
  const Lanes<8> t127_lanes = s7 * detail::make_pack<Real>(t112, t111, t110, t112, t112, t112, t112,
      t112) + c7 * t99_lanes;
  const Real t131 = t47 + t66 * t122;
  const Real t132 = t49 - t66 * t123;
  const Real t133 = t37 - t66 * t124;
  const Real t134 = t40 + t15 * t37 - t67 * t123;
  const Real t135 = t33 - t45 * t124;
  const Real t136 = t16 + t42 - t67 * t124;

  // links 7 (link4) and 8 (link5), force propagation; link 6 (link3), articulated inertia
  const Lanes<8> t137_lanes = s56 * detail::make_pack<Real>(t126_lanes[0], t126_lanes[1],
      t126_lanes[2], t106_lanes[3], t106_lanes[4], t106_lanes[5], t126_lanes[0], t126_lanes[0]) +
      minus_c56 * detail::make_pack<Real>(t114, t102, t101, t88, t84, t80, t114, t114);
  const Lanes<8> t138_lanes = minus_c56 * detail::make_pack<Real>(t126_lanes[0], t126_lanes[1],
      t126_lanes[2], t106_lanes[3], t106_lanes[4], t106_lanes[5], t126_lanes[0], t126_lanes[0]) -
      s56 * detail::make_pack<Real>(t114, t102, t101, t88, t84, t80, t114, t114);
  const Lanes<8> t143_lanes = detail::make_pack<Real>(1557.24430048586, 87.59499190232964,
      87.59499190232964, 1557.24430048586, 1557.24430048586, 1557.24430048586, 1557.24430048586,
      1557.24430048586) * detail::make_pack<Real>(t89, t68, t55, t62, t57, t54, t89, t89);
  const Lanes<8> t144_lanes = t90_lanes * inverse_D7;
  const Real t145 = t4 * t131 - t5 * t132;

  // links 1 (base_x) and 6 (link3), articulated inertia; link 7 (link4), force propagation
  const Real t146 = link9_to_tool_z * t68;
  const Real t147 = t4 * (t65 * t124 - t38) - t5 * t133;
  const Real t148 = h_5_x * s5 + h_5_y * c5 - t145;
  const Real t149 = t134 + (t4 * t133 + link5_to_6_z * t132);
  const Real t152 = t136 + (t4 * t135 + link5_to_6_z * t133);
  const Real t153 = link9_to_tool_z * t55;
  const Real t158 = t4 * (t4 * (t48 - t65 * t122) - t5 * t131) - t5 * t145;
  const Lanes<8> t159_lanes = s7 * t103_lanes + (t15 * t137_lanes - t14 * t138_lanes);

  // links 6 (link3) and 9 (link6), force propagation; links 5 (link2) and 6 (link3), articulated
  //   inertia
  const Lanes<8> t162_lanes = 24999.999999999996 * detail::make_pack<Real>(t85, t85, t85, t85, t75,
      t81, t85, t85);
  const Lanes<8> t168_lanes = t159_lanes * inverse_D6;
  const Real inverse_D5 = 1.0 / (J_5_zz + t158);
  const Real t174 = t5 * t134 - t4 * (t67 * t122 - (t39 + t41) + t147) - link5_to_6_z * t145;
  const Lanes<8> t175_lanes = t138_lanes - t123 * t159_lanes;
  const Lanes<8> t177_lanes = detail::make_pack<Real>(t127_lanes[0], t127_lanes[1], t127_lanes[2],
      t121, t119, t109, t127_lanes[0], t127_lanes[0]) - t124 * t159_lanes;
  const Real t181 = minus_J_5_xz * s5 + minus_J_5_yz * c5 + t174;
  const Real t182 = t51 - t67 * t125 + link5_to_6_z * (t134 + t149) + t4 * (t136 + t152);

  // link 6 (link3), force propagation
  const Lanes<8> t190_lanes = t168_lanes * t159_lanes[3];
  const Lanes<8> t191_lanes = t5 * t175_lanes - t4 * (-t137_lanes + t122 * t159_lanes);
  const Lanes<8> t195_lanes = link5_to_6_z * t175_lanes + t4 * t177_lanes;
  const Lanes<8> t198_lanes = t162_lanes * t85 + t143_lanes * t62 + t144_lanes * t90_lanes[3] +
      t190_lanes;
  const Lanes<8> t199_lanes = t15 * detail::make_pack<Real>(t127_lanes[0], t127_lanes[1],
      t127_lanes[2], t121, t119, t109, t127_lanes[0], t127_lanes[0]) - t13 * t103_lanes - t125 *
      t159_lanes + t195_lanes;

  // link 5 (link2), articulated inertia and force propagation
  const Real t201 = t181 * inverse_D5;
  const Real t202 = t148 * inverse_D5;
  const Real t203 = t147 * inverse_D5;
  const Lanes<8> t204_lanes = t191_lanes * inverse_D5;
  const Lanes<8> t208_lanes = t204_lanes * t191_lanes[0];
  const Lanes<8> t209_lanes = t204_lanes * t191_lanes[1];
  const Lanes<8> t210_lanes = t204_lanes * t191_lanes[2];
  const Real t212 = t152 - (h_5_y * s5 - h_5_x * c5) + t181 * t203;
  const Lanes<8> t213_lanes = t199_lanes - t201 * t191_lanes;
  const Lanes<8> t216_lanes = t143_lanes * t89 + t144_lanes * t90_lanes[0] + t168_lanes *
      t159_lanes[0] + t208_lanes;
  const Lanes<8> t217_lanes = t143_lanes * t146 + t144_lanes * t90_lanes[1] + t168_lanes *
      t159_lanes[1] + t209_lanes;
  const Real t218 = t182 - t181 * t201 + (0.298925024 * s56 + 0.021347276999999998 * minus_c56 +
      s56 * (t21 - t29)) * s56;
  const Real t219 = h_4_y + (t149 - t181 * t202);
  const Lanes<8> t220_lanes = t143_lanes * t153 + t144_lanes * t90_lanes[2] + t168_lanes *
      t159_lanes[2] + t210_lanes;
  const Real t224 = t162_lanes[5] * t81 + t143_lanes[5] * t54 + t144_lanes[5] * t90_lanes[5] +
      t168_lanes[5] * t159_lanes[5] + t204_lanes[5] * t191_lanes[5];

  // link 4 (link1), articulated inertia and force propagation
  const Real inverse_D4 = 1.0 / t218;
  const Real t225 = t212 * inverse_D4;
  const Real t226 = t219 * inverse_D4;
  const Lanes<8> t227_lanes = t213_lanes * inverse_D4;
  const Real t234 = t219 * t225 - (t133 + t148 * t203);
  const Real t235 = t132 - t148 * t202 - t219 * t226;
  const Real t236 = t135 - t147 * t203 - t212 * t225;
  const Lanes<8> t237_lanes = -(t175_lanes - t202 * t191_lanes) + t226 * t213_lanes;
  const Lanes<8> t238_lanes = t177_lanes + t203 * t191_lanes - t225 * t213_lanes;
  const Lanes<8> t243_lanes = t162_lanes * t75 + detail::make_pack<Real>(t143_lanes[4] * t57,
      t143_lanes[4] * t57, t143_lanes[4] * t57, t143_lanes[4] * t57, t143_lanes[4] * t57,
      t143_lanes[5] * t57, t143_lanes[4] * t57, t143_lanes[4] * t57) +
      detail::make_pack<Real>(t144_lanes[4] * t90_lanes[4], t144_lanes[4] * t90_lanes[4],
      t144_lanes[4] * t90_lanes[4], t144_lanes[4] * t90_lanes[4], t144_lanes[4] * t90_lanes[4],
      t144_lanes[5] * t90_lanes[4], t144_lanes[4] * t90_lanes[4], t144_lanes[4] * t90_lanes[4]) +
      detail::make_pack<Real>(t168_lanes[4] * t159_lanes[4], t168_lanes[4] * t159_lanes[4],
      t168_lanes[4] * t159_lanes[4], t168_lanes[4] * t159_lanes[4], t168_lanes[4] * t159_lanes[4],
      t168_lanes[5] * t159_lanes[4], t168_lanes[4] * t159_lanes[4], t168_lanes[4] * t159_lanes[4]) +
      detail::make_pack<Real>(t204_lanes[4] * t191_lanes[4], t204_lanes[4] * t191_lanes[4],
      t204_lanes[4] * t191_lanes[4], t204_lanes[4] * t191_lanes[4], t204_lanes[4] * t191_lanes[4],
      t204_lanes[5] * t191_lanes[4], t204_lanes[4] * t191_lanes[4], t204_lanes[4] * t191_lanes[4]) +
      detail::make_pack<Real>(t227_lanes[4] * t213_lanes[4], t227_lanes[4] * t213_lanes[4],
      t227_lanes[4] * t213_lanes[4], t227_lanes[4] * t213_lanes[4], t227_lanes[4] * t213_lanes[4],
      t227_lanes[5] * t213_lanes[4], t227_lanes[4] * t213_lanes[4], t227_lanes[4] * t213_lanes[4]);
  const Lanes<8> t248_lanes = s34 * t237_lanes + c34 * t238_lanes;
  const Real t250 = s34 * (t235 - t236) + c34 * (2.0 * t234);
  const Real t251 = s34 * t250;
  const Real t252 = c34 * t250 - t234;

  // links 1 (base_x) and 2 (base_y), articulated inertia; link 2 (base_y), force propagation
  const Real inverse_D2 = 1.0 / (mass_2 + (t236 + t251));
  const Real t253 = t252 * inverse_D2;
  const Lanes<8> t254_lanes = t248_lanes * inverse_D2;
  const Lanes<8> t260_lanes = c34 * t237_lanes - s34 * t238_lanes - t253 * t248_lanes;
  const Lanes<8> t264_lanes = t198_lanes + t204_lanes * t191_lanes[3] + t227_lanes * t213_lanes[3] +
      t254_lanes * t248_lanes[3];
  const Real inverse_D1 = 1.0 / (mass_2 + (t235 - t251) - t252 * t253);

  // link 1 (base_x), force propagation
  const Lanes<8> t266_lanes = t260_lanes * inverse_D1;
  const Lanes<8> t271_lanes = t216_lanes + t227_lanes * t213_lanes[0] + t254_lanes * t248_lanes[0] +
      t266_lanes * t260_lanes[0];
  Lambda_inv[0] = t271_lanes[0];
  Lambda_inv[1] = t271_lanes[1];
  Lambda_inv[6] = t271_lanes[1];
  Lambda_inv[2] = t271_lanes[2];
  Lambda_inv[12] = t271_lanes[2];
  Lambda_inv[3] = t271_lanes[3];
  Lambda_inv[18] = t271_lanes[3];
  Lambda_inv[4] = t271_lanes[4];
  Lambda_inv[24] = t271_lanes[4];
  Lambda_inv[5] = t271_lanes[5];
  Lambda_inv[30] = t271_lanes[5];
  const Lanes<8> t272_lanes = t217_lanes + t227_lanes * t213_lanes[1] + t254_lanes * t248_lanes[1] +
      t266_lanes * t260_lanes[1];
  Lambda_inv[7] = t272_lanes[1];
  Lambda_inv[8] = t272_lanes[2];
  Lambda_inv[13] = t272_lanes[2];
  Lambda_inv[9] = t272_lanes[3];
  Lambda_inv[19] = t272_lanes[3];
  Lambda_inv[10] = t272_lanes[4];
  Lambda_inv[25] = t272_lanes[4];
  Lambda_inv[11] = t272_lanes[5];
  Lambda_inv[31] = t272_lanes[5];
  const Lanes<8> t273_lanes = t220_lanes + t227_lanes * t213_lanes[2] + t254_lanes * t248_lanes[2] +
      t266_lanes * t260_lanes[2];
  Lambda_inv[14] = t273_lanes[2];
  Lambda_inv[15] = t273_lanes[3];
  Lambda_inv[20] = t273_lanes[3];
  Lambda_inv[16] = t273_lanes[4];
  Lambda_inv[26] = t273_lanes[4];
  Lambda_inv[17] = t273_lanes[5];
  Lambda_inv[32] = t273_lanes[5];
  const Lanes<8> t274_lanes = t264_lanes + t266_lanes * t260_lanes[3];
  Lambda_inv[21] = t274_lanes[3];
  Lambda_inv[22] = t274_lanes[4];
  Lambda_inv[27] = t274_lanes[4];
  Lambda_inv[23] = t274_lanes[5];
  Lambda_inv[33] = t274_lanes[5];
  const Lanes<8> t275_lanes = t243_lanes + detail::make_pack<Real>(t254_lanes[4] * t248_lanes[4],
      t254_lanes[4] * t248_lanes[4], t254_lanes[4] * t248_lanes[4], t254_lanes[4] * t248_lanes[4],
      t254_lanes[4] * t248_lanes[4], t254_lanes[5] * t248_lanes[4], t254_lanes[4] * t248_lanes[4],
      t254_lanes[4] * t248_lanes[4]) + detail::make_pack<Real>(t266_lanes[4] * t260_lanes[4],
      t266_lanes[4] * t260_lanes[4], t266_lanes[4] * t260_lanes[4], t266_lanes[4] * t260_lanes[4],
      t266_lanes[4] * t260_lanes[4], t266_lanes[5] * t260_lanes[4], t266_lanes[4] * t260_lanes[4],
      t266_lanes[4] * t260_lanes[4]);
  Lambda_inv[28] = t275_lanes[4];
  Lambda_inv[29] = t275_lanes[5];
  Lambda_inv[34] = t275_lanes[5];
  Lambda_inv[35] = t224 + t227_lanes[5] * t213_lanes[5] + t254_lanes[5] * t248_lanes[5] +
      t266_lanes[5] * t260_lanes[5];
}

}  // namespace samm

#undef TREELINE_RESTRICT
