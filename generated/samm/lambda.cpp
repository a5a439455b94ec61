// SPDX-License-Identifier: 0BSD
// lambda: Lambda = (J M^-1 J^T)^-1
// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points.
// 1247 flops (add 491, mul 744, div 12), sine and cosine of 6 angles
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
void lambda(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
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
  const Lanes<8> t137_lanes = s56 * detail::make_pack<Real>(t126_lanes[0], t126_lanes[1],
      t126_lanes[2], t106_lanes[3], t106_lanes[4], t106_lanes[5], t126_lanes[0], t126_lanes[0]) +
      minus_c56 * detail::make_pack<Real>(t114, t102, t101, t88, t84, t80, t114, t114);
  const Lanes<8> t138_lanes = minus_c56 * detail::make_pack<Real>(t126_lanes[0], t126_lanes[1],
      t126_lanes[2], t106_lanes[3], t106_lanes[4], t106_lanes[5], t126_lanes[0], t126_lanes[0]) -
      s56 * detail::make_pack<Real>(t114, t102, t101, t88, t84, t80, t114, t114);

  // links 7 (link4) and 8 (link5), force propagation; link 6 (link3), articulated inertia
  const Lanes<8> t143_lanes = detail::make_pack<Real>(1557.24430048586, 87.59499190232964,
      87.59499190232964, 1557.24430048586, 1557.24430048586, 1557.24430048586, 1557.24430048586,
      1557.24430048586) * detail::make_pack<Real>(t89, t68, t55, t62, t57, t54, t89, t89);
  const Lanes<8> t144_lanes = t90_lanes * inverse_D7;
  const Real t145 = t4 * t131 - t5 * t132;
  const Real t146 = t4 * (t65 * t124 - t38) - t5 * t133;
  const Real t147 = h_5_x * s5 + h_5_y * c5 - t145;
  const Real t148 = t134 + (t4 * t133 + link5_to_6_z * t132);
  const Real t151 = t136 + (t4 * t135 + link5_to_6_z * t133);

  // links 1 (base_x) and 6 (link3), articulated inertia; links 6 (link3) and 7 (link4), force
  //   propagation
  const Real t153 = link9_to_tool_z * t68;
  const Real t155 = t4 * (t4 * (t48 - t65 * t122) - t5 * t131) - t5 * t145;
  const Lanes<8> t156_lanes = s7 * t103_lanes + (t15 * t137_lanes - t14 * t138_lanes);
  const Lanes<8> t163_lanes = t156_lanes * inverse_D6;
  const Real t164 = link9_to_tool_z * t55;

  // links 5 (link2) and 6 (link3), articulated inertia; link 6 (link3), force propagation
  const Real inverse_D5 = 1.0 / (J_5_zz + t155);
  const Real t167 = t5 * t134 - t4 * (t67 * t122 - (t39 + t41) + t146) - link5_to_6_z * t145;
  const Lanes<8> t168_lanes = t138_lanes - t123 * t156_lanes;
  const Lanes<8> t170_lanes = detail::make_pack<Real>(t127_lanes[0], t127_lanes[1], t127_lanes[2],
      t121, t119, t109, t127_lanes[0], t127_lanes[0]) - t124 * t156_lanes;
  const Real t176 = minus_J_5_xz * s5 + minus_J_5_yz * c5 + t167;
  const Real t177 = t51 - t67 * t125 + link5_to_6_z * (t134 + t148) + t4 * (t136 + t151);

  // links 6 (link3) and 9 (link6), force propagation
  const Lanes<8> t185_lanes = t163_lanes * t156_lanes[3];
  const Lanes<8> t186_lanes = t5 * t168_lanes - t4 * (-t137_lanes + t122 * t156_lanes);
  const Lanes<8> t187_lanes = 24999.999999999996 * detail::make_pack<Real>(t85, t85, t85, t85, t75,
      t81, t85, t85);
  const Lanes<8> t189_lanes = link5_to_6_z * t168_lanes + t4 * t170_lanes;
  const Lanes<8> t192_lanes = t15 * detail::make_pack<Real>(t127_lanes[0], t127_lanes[1],
      t127_lanes[2], t121, t119, t109, t127_lanes[0], t127_lanes[0]) - t13 * t103_lanes - t125 *
      t156_lanes + t189_lanes;

  // link 5 (link2), articulated inertia and force propagation
  const Real t194 = t176 * inverse_D5;
  const Real t195 = t147 * inverse_D5;
  const Real t196 = t146 * inverse_D5;
  const Lanes<8> t197_lanes = t186_lanes * inverse_D5;
  const Lanes<8> t202_lanes = t197_lanes * t186_lanes[0];
  const Lanes<8> t203_lanes = t197_lanes * t186_lanes[1];
  const Lanes<8> t204_lanes = t197_lanes * t186_lanes[2];
  const Real t207 = t151 - (h_5_y * s5 - h_5_x * c5) + t176 * t196;
  const Lanes<8> t208_lanes = t192_lanes - t194 * t186_lanes;
  const Lanes<8> t211_lanes = t143_lanes * t89 + t144_lanes * t90_lanes[0] + t163_lanes *
      t156_lanes[0] + t202_lanes;
  const Lanes<8> t212_lanes = t143_lanes * t153 + t144_lanes * t90_lanes[1] + t163_lanes *
      t156_lanes[1] + t203_lanes;
  const Lanes<8> t213_lanes = t143_lanes * t164 + t144_lanes * t90_lanes[2] + t163_lanes *
      t156_lanes[2] + t204_lanes;
  const Real t214 = t177 - t176 * t194 + (0.298925024 * s56 + 0.021347276999999998 * minus_c56 +
      s56 * (t21 - t29)) * s56;
  const Real t215 = h_4_y + (t148 - t176 * t195);

  // links 5 and 6, 9, force propagation; link 4 (link1), articulated inertia
  const Lanes<8> t216_lanes = t187_lanes * t85 + t143_lanes * t62 + t144_lanes * t90_lanes[3] +
      t185_lanes;
  const Lanes<8> t217_lanes = t187_lanes * t75;
  const Real inverse_D4 = 1.0 / t214;
  const Real t220 = t217_lanes[4] + t143_lanes[4] * t57 + t144_lanes[4] * t90_lanes[4] +
      t163_lanes[4] * t156_lanes[4] + t197_lanes[4] * t186_lanes[4];
  const Real t221 = t207 * inverse_D4;

  // link 4 (link1), articulated inertia and force propagation
  const Real t222 = t215 * inverse_D4;
  const Lanes<8> t223_lanes = t208_lanes * inverse_D4;
  const Real t230 = t215 * t221 - (t133 + t147 * t196);
  const Real t231 = t132 - t147 * t195 - t215 * t222;
  const Real t232 = t135 - t146 * t196 - t207 * t221;
  const Lanes<8> t233_lanes = -(t168_lanes - t195 * t186_lanes) + t222 * t208_lanes;
  const Lanes<8> t234_lanes = t170_lanes + t196 * t186_lanes - t221 * t208_lanes;
  const Lanes<8> t243_lanes = s34 * t233_lanes + c34 * t234_lanes;

  // link 4 (link1), articulated inertia; link 5 (link2), force propagation
  const Real t245 = s34 * (t231 - t232) + c34 * (2.0 * t230);
  const Real t246 = t217_lanes[5] + t143_lanes[5] * t57 + t144_lanes[5] * t90_lanes[4] +
      t163_lanes[5] * t156_lanes[4] + t197_lanes[5] * t186_lanes[4];
  const Real t247 = s34 * t245;
  const Real t248 = t187_lanes[5] * t81 + t143_lanes[5] * t54 + t144_lanes[5] * t90_lanes[5] +
      t163_lanes[5] * t156_lanes[5] + t197_lanes[5] * t186_lanes[5];
  const Real t249 = c34 * t245 - t230;

  // links 1 (base_x) and 2 (base_y), articulated inertia; link 2 (base_y), force propagation
  const Real inverse_D2 = 1.0 / (mass_2 + (t232 + t247));
  const Real t250 = t249 * inverse_D2;
  const Lanes<8> t251_lanes = t243_lanes * inverse_D2;
  const Lanes<8> t257_lanes = c34 * t233_lanes - s34 * t234_lanes - t250 * t243_lanes;
  const Lanes<8> t261_lanes = t216_lanes + t197_lanes * t186_lanes[3] + t223_lanes * t208_lanes[3] +
      t251_lanes * t243_lanes[3];
  const Real inverse_D1 = 1.0 / (mass_2 + (t231 - t247) - t249 * t250);

  // link 1 (base_x), force propagation
  const Lanes<8> t262_lanes = t257_lanes * inverse_D1;
  const Lanes<8> t267_lanes = t211_lanes + t223_lanes * t208_lanes[0] + t251_lanes * t243_lanes[0] +
      t262_lanes * t257_lanes[0];
  const Lanes<8> t268_lanes = t212_lanes + t223_lanes * t208_lanes[1] + t251_lanes * t243_lanes[1] +
      t262_lanes * t257_lanes[1];
  const Lanes<8> t269_lanes = t213_lanes + t223_lanes * t208_lanes[2] + t251_lanes * t243_lanes[2] +
      t262_lanes * t257_lanes[2];
  const Real t271 = t267_lanes[0] * t267_lanes[0];
  const Real t272 = t271 * t267_lanes[0];
  const Real t273 = t272 * t271 / (1.262177448353619e-29 + t272 * t272);
  const Lanes<8> t274_lanes = t267_lanes * t273;
  const Lanes<8> t278_lanes = t268_lanes - t274_lanes * t267_lanes[1];
  const Real t281 = t220 + t223_lanes[4] * t208_lanes[4] + t251_lanes[4] * t243_lanes[4] +
      t262_lanes[4] * t257_lanes[4] - t274_lanes[4] * t267_lanes[4];
  const Real t282 = t246 + t223_lanes[5] * t208_lanes[4] + t251_lanes[5] * t243_lanes[4] +
      t262_lanes[5] * t257_lanes[4] - t274_lanes[5] * t267_lanes[4];
  const Real t283 = t248 + t223_lanes[5] * t208_lanes[5] + t251_lanes[5] * t243_lanes[5] +
      t262_lanes[5] * t257_lanes[5] - t274_lanes[5] * t267_lanes[5];
  const Real t284 = t278_lanes[1] * t278_lanes[1];
  const Real t285 = t284 * t278_lanes[1];
  const Real t286 = t285 * t284 / (1.9721522630525295e-31 + t285 * t285);
  const Lanes<8> t287_lanes = t278_lanes * t286;
  const Real t288 = t274_lanes[1] * t286;
  const Lanes<8> t291_lanes = t269_lanes - t274_lanes * t267_lanes[2] - t287_lanes * t278_lanes[2];
  const Lanes<8> t292_lanes = t261_lanes + t262_lanes * t257_lanes[3] - t274_lanes * t267_lanes[3] -
      t287_lanes * t278_lanes[3];
  const Real t293 = t287_lanes[2] * t274_lanes[1] - t274_lanes[2];
  const Real t294 = t291_lanes[2] * t291_lanes[2];
  const Real t295 = t294 * t291_lanes[2];
  const Real t296 = t295 * t294 / (3.0814879110195774e-33 + t295 * t295);
  const Lanes<8> t297_lanes = t291_lanes * t296;
  const Real t298 = t293 * t296;
  const Real t299 = t287_lanes[2] * t296;
  const Lanes<8> t301_lanes = t292_lanes - t297_lanes * t291_lanes[3];
  const Real t302 = t287_lanes[3] * t274_lanes[1] - t274_lanes[3] - t297_lanes[3] * t293;
  const Real t303 = t297_lanes[3] * t287_lanes[2] - t287_lanes[3];
  const Real t304 = t301_lanes[3] * t301_lanes[3];
  const Real t305 = t304 * t301_lanes[3];
  const Real t306 = t305 * t304 / (5.960464477539063e-08 + t305 * t305);
  const Real t307 = t301_lanes[4] * t306;
  const Real t308 = t301_lanes[5] * t306;
  const Real t309 = t302 * t306;
  const Real t310 = t303 * t306;
  const Real t311 = t297_lanes[3] * t306;
  const Real t312 = t281 - t287_lanes[4] * t278_lanes[4] - t297_lanes[4] * t291_lanes[4] - t307 *
      t301_lanes[4];
  const Real t313 = t282 - t287_lanes[5] * t278_lanes[4] - t297_lanes[5] * t291_lanes[4] - t308 *
      t301_lanes[4];
  const Real t314 = t287_lanes[4] * t274_lanes[1] - t274_lanes[4] - t297_lanes[4] * t293 - t307 *
      t302;
  const Real t315 = t297_lanes[4] * t287_lanes[2] - t287_lanes[4] - t307 * t303;
  const Real t316 = t307 * t297_lanes[3] - t297_lanes[4];
  const Real t317 = t312 * t312;
  const Real t318 = t317 * t312;
  const Real t319 = t318 * t317 / (1.3552527156068805e-20 + t318 * t318);
  const Real t320 = t313 * t319;
  const Real t321 = t314 * t319;
  const Real t322 = t315 * t319;
  const Real t323 = t316 * t319;
  const Real t324 = t307 * t319;
  const Real t325 = t283 - t287_lanes[5] * t278_lanes[5] - t297_lanes[5] * t291_lanes[5] - t308 *
      t301_lanes[5] - t320 * t313;
  const Real t326 = t287_lanes[5] * t274_lanes[1] - t274_lanes[5] - t297_lanes[5] * t293 - t308 *
      t302 - t320 * t314;
  const Real t327 = t297_lanes[5] * t287_lanes[2] - t287_lanes[5] - t308 * t303 - t320 * t315;
  const Real t328 = t308 * t297_lanes[3] - t297_lanes[5] - t320 * t316;
  const Real t329 = t320 * t307 - t308;
  const Real t330 = t273 + t288 * t274_lanes[1] + t298 * t293 + t309 * t302 + t321 * t314;
  const Real t331 = t325 * t325;
  const Real t332 = t331 * t325;
  const Real Lambda_5_5 = t332 * t331 / (2.117582368135751e-22 + t332 * t332);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5 = t326 * Lambda_5_5;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_1_5 = t327 * Lambda_5_5;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_2_5 = t328 * Lambda_5_5;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_3_5 = t329 * Lambda_5_5;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_4_5 = t320 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  Lambda[0] = t330 + Lambda_0_5 * t326;
  const Real Lambda_0_1 = t310 * t302 - (t288 + t299 * t293) + t322 * t314 + Lambda_1_5 * t326;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_0_2 = t298 - t311 * t302 + t323 * t314 + Lambda_2_5 * t326;
  Lambda[2] = Lambda_0_2;
  Lambda[12] = Lambda_0_2;
  const Real Lambda_0_3 = t309 - t324 * t314 + Lambda_3_5 * t326;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_0_4 = t321 - Lambda_4_5 * t326;
  Lambda[4] = Lambda_0_4;
  Lambda[24] = Lambda_0_4;
  Lambda[7] = t286 + t299 * t287_lanes[2] + t310 * t303 + t322 * t315 + Lambda_1_5 * t327;
  const Real Lambda_1_2 = t323 * t315 - (t299 + t311 * t303) + Lambda_2_5 * t327;
  Lambda[8] = Lambda_1_2;
  Lambda[13] = Lambda_1_2;
  const Real Lambda_1_3 = t310 - t324 * t315 + Lambda_3_5 * t327;
  Lambda[9] = Lambda_1_3;
  Lambda[19] = Lambda_1_3;
  const Real Lambda_1_4 = t322 - Lambda_4_5 * t327;
  Lambda[10] = Lambda_1_4;
  Lambda[25] = Lambda_1_4;
  Lambda[14] = t296 + t311 * t297_lanes[3] + t323 * t316 + Lambda_2_5 * t328;
  const Real Lambda_2_3 = Lambda_3_5 * t328 - (t311 + t324 * t316);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = t323 - Lambda_4_5 * t328;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = t306 + t324 * t307 + Lambda_3_5 * t329;
  const Real Lambda_3_4 = t324 + Lambda_4_5 * t329;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = t319 + Lambda_4_5 * t320;
}

}  // namespace samm

#undef TREELINE_RESTRICT
