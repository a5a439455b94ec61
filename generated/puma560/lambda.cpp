// SPDX-License-Identifier: 0BSD
// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J carried inward, in the axes asked for at link origins.
// 811 flops (add 328, mul 473, div 10), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

template <int count>
using Lanes = detail::Pack<Real, count>;
void lambda(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
  // constants
  const Real minus_h_5_y = 0.0028799999999999997;
  const Real J_6_zz = 4e-05;
  const Real minus_link3_to_4_x = 0.0203;
  const Real minus_link3_to_4_y = 0.4331;
  const Real minus_h_3_x = 0.025374999999999998;
  const Real minus_h_3_y = 0.861795;
  const Real J_3_zz = 0.312455249;
  const Real link2_to_3_x = 0.4318;
  const Real J_3_yz = 0.004704000000000001;
  const Real J_2_zz = 1.7481140020000001;
  const Real link2_to_3_z = 0.1501;
  const Real minus_J_2_xz = 0.690314699;
  const Real minus_J_2_yz = 0.023750999999999998;
  const Real link6_to_tool_z = 0.05625;

  // sines and cosines
  const Real angles[5] = {q[1], q[2], q[0], q[3], q[4]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real c1 = cosines[2];
  const Real s4 = sines[3];
  const Real s5 = sines[4];
  const Real c4 = cosines[3];
  const Real c5 = cosines[4];
  const Real s1 = sines[2];

  // link 5 (link5), composite inertia; link 6 (link6), mass matrix
  const Real t1 = minus_h_5_y * s5;
  const Real t2 = minus_h_5_y * c5;
  const Real t3 = 0.00020215999999999998 * s5;
  const Real t4 = J_6_zz * c5;
  const Real t5 = J_6_zz * s5;
  const Real t6 = link2_to_3_x * c2;
  const Real t7 = link2_to_3_x * s2;

  // link 4 (link4), composite inertia; link 5 (link5), mass matrix
  const Real t8 = c4 * t1;
  const Real minus_c23 = s2 * s3 - c2 * c3;
  const Real t9 = s4 * t1;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real t10 = c4 * t2;

  // link 5 (link5), composite inertia; links 4 (link4) and 6 (link6), mass matrix
  const Real t11 = s5 * t3;
  const Real t12 = c5 * t3;
  const Real t13 = s4 * t5;
  const Real t14 = 0.00164 + t11;
  const Real t15 = minus_c23 * t9;
  const Real t16 = s23 * t9;

  // link 4 (link4), composite inertia; links 1 (link1) and 5 (link5), mass matrix
  const Real t17 = s4 * t12;
  const Real t18 = 24999.999999999996 * t13;
  const Real t19 = minus_link3_to_4_x * minus_c23 + minus_link3_to_4_y * s23;
  const Real t20 = minus_c23 * t8 - s23 * t2;
  const Real t21 = minus_link3_to_4_x * s23 - minus_link3_to_4_y * minus_c23;
  const Real t22 = s23 * t8 + minus_c23 * t2;
  const Real t23 = minus_c23 * t1 - s23 * t10;
  const Real t24 = minus_c23 * t10 + s23 * t1;
  const Real t25 = s4 * (0.00010000000000000005 + t11);
  const Real t26 = t19 * t20;
  const Real t27 = 1.0 / (t14 - c5 * t4);
  const Real t28 = s4 * t25;
  const Real t29 = s23 * c4;
  const Real t30 = c4 * t12;
  const Real t31 = s23 * s4;
  const Real t32 = minus_h_3_x * s23 - minus_h_3_y * minus_c23 - t22;
  const Real t33 = 0.00064216 * c4 - (t19 * t23 + t21 * t24);

  // link 3 (link3), composite inertia and Jacobian; links 1, 5 and 6, mass matrix
  const Real t34 = t6 * (t20 - (minus_h_3_x * minus_c23 + minus_h_3_y * s23));
  const Real t35 = t19 + t6;
  const Real t36 = t21 * t15 - t19 * t16 - t17 - c5 * t13;
  const Real t37 = 1557.24430048586 * t33;
  const Real t38 = t33 + (t7 * t24 - t6 * t23);
  const Real t39 = t29 * t5 + minus_c23 * t4;
  const Real t40 = t34 + t7 * t32;

  // links 1, 3, 5, mass matrix
  const Real t41 = t36 * t27;
  const Real t42 = 1557.24430048586 * t38;
  const Real t43 = t36 - t6 * t16 - t7 * t15;
  const Real t44 = t29 * t25 - t21 * t9 + (J_3_yz + t17) * minus_c23 - link2_to_3_z * t32;
  const Real t45 = 0.00064216 * t31 + link2_to_3_z * t24 + t35 * (s4 * t2);

  // link 1 (link1), mass matrix; link 4 (link4), pose
  const Real t46 = J_3_zz + (0.0012921599999999999 - t28 - 2.0 * (t26 + t21 * t22)) - t18 * t13;
  const Real t47 = t43 * t27;
  const Real t48 = minus_c23 * s1;
  const Real t49 = t44 + t18 * t39;
  const Real t50 = s23 * t30 - minus_c23 * t14 - link2_to_3_z * t15 + c5 * t39 + t35 * t8;
  const Real t51 = 24999.999999999996 * t39;
  const Real t52 = s23 * s1;
  const Real t53 = 1557.24430048586 * t45;
  const Real t54 = t50 * t27;
  const Real t55 = 1.0 / (t46 - t37 * t33 - t41 * t36);
  const Real t56 = t46 - t40 - t37 * t38 - t41 * t43;
  const Real t57 = t49 - t37 * t45 - t41 * t50;
  const Real t58 = minus_J_2_xz * s2 + minus_J_2_yz * c2 + t49 + t7 * t9 - t42 * t45;

  // links 4 (link4) and 5 (link5), pose; link 1 (link1), mass matrix; link 3 (link3), Jacobian
  const Real t59 = s5 * t29 + c5 * minus_c23;
  const Real t60 = 3.153482265 - s2 * (1.601861202 * s2 + 0.0141984 * c2) + t14 - t51 * t39;
  const Real t61 = t18 * t59;
  const Real t62 = t21 * s1;
  const Real t63 = s5 * (s4 * c1 - c4 * t48) + c5 * t52;
  const Real t64 = s4 * t48 + c4 * c1;
  const Real t65 = t21 - t7;

  // link 1 (link1), mass matrix
  const Real t66 = c5 * t59 - minus_c23;
  const Real t67 = 24999.999999999996 * t59;
  const Real t68 = 1557.24430048586 * t31;
  const Real t69 = t56 * t55;
  const Real t70 = t57 * t55;
  const Real t71 = 0.298925024 * s23 + 0.021347276999999998 * minus_c23 -
      (minus_c23 * (2.0 * t30) - s23 * (0.0011921599999999998 - t11 + t28 - t14));
  const Real t72 = t52 - c5 * t63;
  const Real t73 = c1 - t18 * t63;
  const Real t74 = 24999.999999999996 * t63;
  const Real t75 = 1557.24430048586 * t64;
  const Real t76 = t66 * t27;
  const Real t77 = t61 - t37 * t31 - t41 * t66;

  // link 4 (link4), pose; link 1 (link1), mass matrix; link 3 (link3), Jacobian
  const Real t79 = minus_c23 * c1;
  const Real t80 = t72 * t27;
  const Real t81 = J_2_zz + t46 - 2.0 * t40 - t42 * t38 - t47 * t43 - t69 * t56;
  const Real t82 = t58 - t47 * t50 - t69 * t57;
  const Real t83 = t73 - t37 * t64 - t41 * t72;
  const Real t85 = t21 * c1;
  const Real t86 = 1.0 / t81;
  const Lanes<8> t89_lanes = detail::make_pack<Real>(t62, t62, t62, t62, t83, t77, t62, t62) * t55;
  const Real t90 = s23 * c1;
  const Lanes<8> t91_lanes = detail::make_pack<Real>(t65 * s1, t65 * s1, t65 * s1, t65 * s1, t73 -
      t42 * t64 - t47 * t72, t61 - t42 * t31 - t47 * t66, t65 * s1, t65 * s1) - t69 *
      detail::make_pack<Real>(t62, t62, t62, t62, t83, t77, t62, t62);

  // link 1 (link1), mass matrix; links 4 (link4) and 5 (link5), pose
  const Real t93 = t65 * c1 - t69 * t85;
  const Real t94 = link6_to_tool_z * t63;
  const Real t95 = link6_to_tool_z * t59;
  const Real t96 = s4 * t79 - c4 * s1;
  const Real t98 = s5 * (c4 * t79 + s4 * s1) - c5 * t90;

  // link 1 (link1), mass matrix
  const Real t99 = t82 * t86;
  const Lanes<8> t100_lanes = t91_lanes * t86;
  const Real t101 = link6_to_tool_z * t98;
  const Real t103 = t90 + c5 * t98;
  const Real t104 = t18 * t98 - s1;
  const Real t105 = t60 - t53 * t45 - t54 * t50 - t70 * t57 - t99 * t82;
  const Lanes<8> t106_lanes = detail::make_pack<Real>(t35 * c1, t35 * c1, t35 * c1, t35 * c1, t51 *
      t63 - t53 * t64, 1.0 - t51 * t59 - t53 * t31, t35 * c1, t35 * c1) -
      detail::make_pack<Real>(link2_to_3_z, link2_to_3_z, link2_to_3_z, link2_to_3_z, t54, t54,
      link2_to_3_z, link2_to_3_z) * detail::make_pack<Real>(s1, s1, s1, s1, t72, t66, s1, s1) -
      t70 * detail::make_pack<Real>(t62, t62, t62, t62, t83, t77, t62, t62) - t99 * t91_lanes;
  const Real t107 = t67 * t59 + t68 * t31 + t76 * t66 + t89_lanes[5] * t77 + t100_lanes[5] *
      t91_lanes[5];
  const Real t108 = t68 * t64 - t67 * t63 + t76 * t72 + t89_lanes[5] * t83 + t100_lanes[5] *
      t91_lanes[4];
  const Real t109 = t74 * t63 + t75 * t64 + t80 * t72 + t89_lanes[4] * t83 + t100_lanes[4] *
      t91_lanes[4];
  const Real t110 = t35 * s1 + link2_to_3_z * c1 + t70 * t85 + t99 * t93;
  const Real t112 = t104 - t37 * t96 - t41 * t103;
  const Real t113 = t19 * t55;
  const Real t114 = 1.0 / (t105 + 2.0 * (link2_to_3_z * t9 - t34 - t26) + t71 * s23);
  const Real t115 = t112 * t55;
  const Real t117 = t69 * t19 - t35;
  const Real t118 = 24999.999999999996 * t98 * t98 + 1557.24430048586 * t96 * t96 + t103 * t27 *
      t103;
  const Real t119 = t104 - t42 * t96 - t47 * t103 - t69 * t112;
  const Real t120 = t117 * t86;
  const Real t121 = t119 * t86;
  const Real t122 = t70 * t19 - t99 * t117;
  const Real t123 = t51 * t98 + t53 * t96 + t54 * t103 + t70 * t112 + t99 * t119;
  const Real t124 = t67 * t98 + t68 * t96 + t76 * t103 + t89_lanes[5] * t112 + t100_lanes[5] * t119;
  const Real t125 = t75 * t96 - t74 * t98 + t80 * t103 + t89_lanes[4] * t112 + t100_lanes[4] * t119;
  const Lanes<8> t126_lanes = t106_lanes * t114;
  const Real t127 = t122 * t114;
  const Real t128 = t123 * t114;
  const Real t130 = t107 + t126_lanes[5] * t106_lanes[5];
  const Real t131 = t108 + t126_lanes[5] * t106_lanes[4];
  const Real t132 = t109 + t126_lanes[4] * t106_lanes[4];
  const Real t133 = t89_lanes[5] * t85 + t100_lanes[5] * t93 - t126_lanes[5] * t110;
  const Real t134 = t89_lanes[4] * t85 + t100_lanes[4] * t93 - t126_lanes[4] * t110;
  const Real t135 = t85 * t55 * t85 + t93 * t86 * t93 + t110 * t114 * t110;
  const Real t136 = t124 - t126_lanes[5] * t123;
  const Real t137 = t125 - t126_lanes[4] * t123;
  const Real t138 = t118 + t115 * t112 + t121 * t119 + t128 * t123;
  const Lanes<8> t139_lanes = t89_lanes * t62 + t100_lanes * t91_lanes[1] + t126_lanes *
      t106_lanes[1];
  const Real t140 = t136 * t94;
  const Real t141 = t137 * t95;
  const Real t142 = t115 * t62 + t121 * t91_lanes[1] - t128 * t106_lanes[1];
  const Real t143 = t100_lanes[4] * t117 - t89_lanes[4] * t19 + t126_lanes[4] * t122;
  const Real t144 = t100_lanes[5] * t117 - t89_lanes[5] * t19 + t126_lanes[5] * t122;
  const Real t145 = t131 * t101;
  const Real t146 = t133 - (t130 * t94 + t131 * t95);
  const Real t147 = t134 - (t131 * t94 + t132 * t95);
  const Real t148 = t121 * t117 - t115 * t19 - t128 * t122;
  const Real t149 = t115 * t85 + t121 * t93 + t128 * t110 - (t140 + t141);
  const Real t150 = t139_lanes[5] - (t130 * t101 - t136 * t95);
  const Real t151 = t142 - (t136 * t101 - t138 * t95);
  const Real t152 = t139_lanes[4] - (t145 - t141);
  const Real t153 = t143 + (t132 * t101 + t137 * t94);
  const Real t154 = t89_lanes[1] * t85 + t100_lanes[1] * t93 - t126_lanes[1] * t110 - t94 *
      t139_lanes[5] - t101 * t146;
  const Real t155 = t120 * t93 - t113 * t85 - t127 * t110 - t95 * t143 + t101 * t147;
  const Real t156 = t148 + (t137 * t101 + t138 * t94);
  const Real t157 = t154 + (t149 - t139_lanes[4]) * t95;
  const Real t158 = t155 + (t149 - t144) * t94;
  const Real t159 = t120 * t91_lanes[1] - t113 * t62 + t127 * t106_lanes[1] + t95 * t148 + t94 *
      t151;
  const Real t160 = t135 - (t94 * (t133 + t146) + t95 * (t134 + t147));
  const Real t161 = t160 * t160;
  const Real t162 = t161 * t160;
  const Real t163 = t113 * t19 + t120 * t117 + t127 * t122 +
      (t101 * (t143 + t153) + t94 * (t148 + t156));
  const Real t164 = t162 * t161 / (1.262177448353619e-29 + t162 * t162);
  const Real t165 = t157 * t164;
  const Real t166 = t158 * t164;
  const Real t167 = t146 * t164;
  const Real t168 = t147 * t164;
  const Real t169 = t149 * t164;
  const Real t172 = t139_lanes[1] - (t101 * (t139_lanes[5] + t150) - t95 * (t142 + t151)) - t165 *
      t157;
  const Real t173 = t150 - t167 * t157;
  const Real t174 = t152 - t168 * t157;
  const Real t175 = t151 - t169 * t157;
  const Real t178 = t172 * t172;
  const Real t179 = t159 - t166 * t157 + (t152 - t144) * t101;
  const Real t180 = t178 * t172;
  const Real t181 = t180 * t178 / (1.9721522630525295e-31 + t180 * t180);
  const Real t182 = t173 * t181;
  const Real t183 = t174 * t181;
  const Real t184 = t175 * t181;
  const Real t185 = t179 * t181;
  const Real t186 = t165 * t181;
  const Lanes<8> t189_lanes = detail::make_pack<Real>(t163, t163, t163, t156, t153, t144 +
      (t145 + t140), t163, t163) - detail::make_pack<Real>(t166, t166, t166, t169, t168, t167, t166,
      t166) * t158 - detail::make_pack<Real>(t185, t185, t185, t184, t183, t182, t185, t185) * t179;
  const Real t191 = t185 * t165 - t166;
  const Real t192 = t189_lanes[2] * t189_lanes[2];
  const Real t193 = t192 * t189_lanes[2];
  const Real t194 = t193 * t192 / (1.262177448353619e-29 + t193 * t193);
  const Lanes<8> t195_lanes = t189_lanes * t194;
  const Real t196 = t191 * t194;
  const Real t197 = t185 * t194;
  const Lanes<8> t199_lanes = detail::make_pack<Real>(t138, t138, t138, t138, t137, t136, t138,
      t138) - detail::make_pack<Real>(t169, t169, t169, t169, t168, t167, t169, t169) * t149 -
      detail::make_pack<Real>(t184, t184, t184, t184, t183, t182, t184, t184) * t175 - t195_lanes *
      t189_lanes[3];
  const Real t200 = t184 * t165 - t169 - t195_lanes[3] * t191;
  const Real t201 = t195_lanes[3] * t185 - t184;
  const Real t202 = t199_lanes[3] * t199_lanes[3];
  const Real t203 = t202 * t199_lanes[3];
  const Real t204 = t203 * t202 / (9.313225746154785e-10 + t203 * t203);
  const Real t205 = t199_lanes[4] * t204;
  const Real t206 = t199_lanes[5] * t204;
  const Real t207 = t200 * t204;
  const Real t208 = t201 * t204;
  const Real t209 = t195_lanes[3] * t204;
  const Real t210 = t132 - t168 * t147 - t183 * t174 - t195_lanes[4] * t189_lanes[4] - t205 *
      t199_lanes[4];
  const Real t211 = t131 - t167 * t147 - t182 * t174 - t195_lanes[5] * t189_lanes[4] - t206 *
      t199_lanes[4];
  const Real t212 = t130 - t167 * t146 - t182 * t173 - t195_lanes[5] * t189_lanes[5] - t206 *
      t199_lanes[5];
  const Real t213 = t183 * t165 - t168 - t195_lanes[4] * t191 - t205 * t200;
  const Real t214 = t195_lanes[4] * t185 - t183 - t205 * t201;
  const Real t215 = t205 * t195_lanes[3] - t195_lanes[4];
  const Real t216 = t210 * t210;
  const Real t217 = t216 * t210;
  const Real t218 = t217 * t216 / (8.673617379884035e-19 + t217 * t217);
  const Real t219 = t211 * t218;
  const Real t220 = t213 * t218;
  const Real t221 = t214 * t218;
  const Real t222 = t215 * t218;
  const Real t223 = t205 * t218;
  const Real t224 = t212 - t219 * t211;
  const Real t225 = t182 * t165 - t167 - t195_lanes[5] * t191 - t206 * t200 - t219 * t213;
  const Real t226 = t195_lanes[5] * t185 - t182 - t206 * t201 - t219 * t214;
  const Real t227 = t206 * t195_lanes[3] - t195_lanes[5] - t219 * t215;
  const Real t228 = t219 * t205 - t206;
  const Real t229 = t164 + t186 * t165 + t196 * t191 + t207 * t200 + t220 * t213;
  const Real t230 = t224 * t224;
  const Real t231 = t230 * t224;
  const Real Lambda_5_5 = t231 * t230 / (2.117582368135751e-22 + t231 * t231);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5 = t225 * Lambda_5_5;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_1_5 = t226 * Lambda_5_5;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_2_5 = t227 * Lambda_5_5;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_3_5 = t228 * Lambda_5_5;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_4_5 = t219 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  Lambda[0] = t229 + Lambda_0_5 * t225;
  const Real Lambda_0_1 = t208 * t200 - (t186 + t197 * t191) + t221 * t213 + Lambda_1_5 * t225;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_0_2 = t196 - t209 * t200 + t222 * t213 + Lambda_2_5 * t225;
  Lambda[2] = Lambda_0_2;
  Lambda[12] = Lambda_0_2;
  const Real Lambda_0_3 = t207 - t223 * t213 + Lambda_3_5 * t225;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_0_4 = t220 - Lambda_4_5 * t225;
  Lambda[4] = Lambda_0_4;
  Lambda[24] = Lambda_0_4;
  Lambda[7] = t181 + t197 * t185 + t208 * t201 + t221 * t214 + Lambda_1_5 * t226;
  const Real Lambda_1_2 = t222 * t214 - (t197 + t209 * t201) + Lambda_2_5 * t226;
  Lambda[8] = Lambda_1_2;
  Lambda[13] = Lambda_1_2;
  const Real Lambda_1_3 = t208 - t223 * t214 + Lambda_3_5 * t226;
  Lambda[9] = Lambda_1_3;
  Lambda[19] = Lambda_1_3;
  const Real Lambda_1_4 = t221 - Lambda_4_5 * t226;
  Lambda[10] = Lambda_1_4;
  Lambda[25] = Lambda_1_4;
  Lambda[14] = t194 + t209 * t195_lanes[3] + t222 * t215 + Lambda_2_5 * t227;
  const Real Lambda_2_3 = Lambda_3_5 * t227 - (t209 + t223 * t215);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = t222 - Lambda_4_5 * t227;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = t204 + t223 * t205 + Lambda_3_5 * t228;
  const Real Lambda_3_4 = t223 + Lambda_4_5 * t228;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = t218 + Lambda_4_5 * t219;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
