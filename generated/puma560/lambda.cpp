// SPDX-License-Identifier: 0BSD
// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J carried inward, in the axes asked for at link origins.
// 812 flops (add 328, mul 474, div 10), sine and cosine of 5 angles
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

  // link 5 (link5), composite inertia; links 1 (link1) and 6 (link6), mass matrix
  const Real t1 = minus_h_5_y * s5;
  const Real t2 = minus_h_5_y * c5;
  const Real t3 = 0.00020215999999999998 * s5;
  const Real t4 = 0.9999999999999999 * c5;
  const Real t5 = J_6_zz * c5;
  const Real t6 = J_6_zz * s5;

  // link 4 (link4), composite inertia; link 5 (link5), mass matrix
  const Real t7 = link2_to_3_x * c2;
  const Real t8 = link2_to_3_x * s2;
  const Real t9 = c4 * t1;
  const Real minus_c23 = s2 * s3 - c2 * c3;
  const Real t10 = s4 * t1;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real t11 = c4 * t2;

  // link 5 (link5), composite inertia; links 4 (link4) and 6 (link6), mass matrix
  const Real t12 = s5 * t3;
  const Real t13 = c5 * t3;
  const Real t14 = s4 * t6;
  const Real t15 = 0.00164 + t12;
  const Real t16 = minus_c23 * t10;
  const Real t17 = s23 * t10;

  // link 4 (link4), composite inertia; links 1 (link1) and 5 (link5), mass matrix
  const Real t18 = s4 * t13;
  const Real t19 = 24999.999999999996 * t14;
  const Real t20 = minus_link3_to_4_x * minus_c23 + minus_link3_to_4_y * s23;
  const Real t21 = minus_c23 * t9 - s23 * t2;
  const Real t22 = minus_link3_to_4_x * s23 - minus_link3_to_4_y * minus_c23;
  const Real t23 = s23 * t9 + minus_c23 * t2;
  const Real t24 = minus_c23 * t1 - s23 * t11;
  const Real t25 = minus_c23 * t11 + s23 * t1;
  const Real t26 = s4 * (0.00010000000000000026 + t12);
  const Real t27 = t20 * t21;
  const Real t28 = 1.0 / (t15 - t4 * t5);
  const Real t29 = s4 * t26;
  const Real t30 = s23 * c4;
  const Real t31 = c4 * t13;
  const Real t32 = s23 * s4;
  const Real t33 = minus_h_3_x * s23 - minus_h_3_y * minus_c23 - t23;
  const Real t34 = 0.00064216 * c4 - (t20 * t24 + t22 * t25);

  // link 3 (link3), composite inertia and Jacobian; links 1, 5 and 6, mass matrix
  const Real t35 = t7 * (t21 - (minus_h_3_x * minus_c23 + minus_h_3_y * s23));
  const Real t36 = t20 + t7;
  const Real t37 = t22 * t16 - t20 * t17 - t18 - t4 * t14;
  const Real t38 = 1557.24430048586 * t34;
  const Real t39 = t34 + (t8 * t25 - t7 * t24);
  const Real t40 = t30 * t6 + minus_c23 * t5;
  const Real t41 = t35 + t8 * t33;

  // links 1, 3, 5, mass matrix
  const Real t42 = t37 * t28;
  const Real t43 = 1557.24430048586 * t39;
  const Real t44 = t37 - t7 * t17 - t8 * t16;
  const Real t45 = t30 * t26 - t22 * t10 + (J_3_yz + t18) * minus_c23 - link2_to_3_z * t33;
  const Real t46 = 0.00064216 * t32 + link2_to_3_z * t25 + t36 * (s4 * t2);

  // link 1 (link1), mass matrix; link 4 (link4), pose
  const Real t47 = J_3_zz + (0.00129216 - t29 - 2.0 * (t27 + t22 * t23)) - t19 * t14;
  const Real t48 = t44 * t28;
  const Real t49 = minus_c23 * s1;
  const Real t50 = t45 + t19 * t40;
  const Real t51 = s23 * t31 - minus_c23 * t15 - link2_to_3_z * t16 + t4 * t40 + t36 * t9;
  const Real t52 = 24999.999999999996 * t40;
  const Real t53 = s23 * s1;
  const Real t54 = 1557.24430048586 * t46;
  const Real t55 = t51 * t28;
  const Real t56 = 1.0 / (t47 - t38 * t34 - t42 * t37);
  const Real t57 = t47 - t41 - t38 * t39 - t42 * t44;
  const Real t58 = t50 - t38 * t46 - t42 * t51;
  const Real t59 = minus_J_2_xz * s2 + minus_J_2_yz * c2 + t50 + t8 * t10 - t43 * t46;

  // links 4 (link4) and 5 (link5), pose; link 1 (link1), mass matrix; link 3 (link3), Jacobian
  const Real t60 = s5 * t30 + c5 * minus_c23;
  const Real t61 = 3.153482265 - s2 * (1.601861202 * s2 + 0.0141984 * c2) + t15 - t52 * t40;
  const Real t62 = t19 * t60;
  const Real t63 = t22 * s1;
  const Real t64 = s5 * (s4 * c1 - c4 * t49) + c5 * t53;
  const Real t65 = s4 * t49 + c4 * c1;
  const Real t66 = t22 - t8;

  // link 1 (link1), mass matrix
  const Real t67 = t4 * t60 - minus_c23;
  const Real t68 = 24999.999999999996 * t60;
  const Real t69 = 1557.24430048586 * t32;
  const Real t70 = t57 * t56;
  const Real t71 = t58 * t56;
  const Real t72 = 0.298925024 * s23 + 0.021347276999999998 * minus_c23 -
      (minus_c23 * (2.0 * t31) - s23 * (0.0011921599999999998 - t12 + t29 - t15));
  const Real t73 = t53 - t4 * t64;
  const Real t74 = c1 - t19 * t64;
  const Real t75 = 24999.999999999996 * t64;
  const Real t76 = 1557.24430048586 * t65;
  const Real t77 = t67 * t28;
  const Real t78 = t62 - t38 * t32 - t42 * t67;

  // link 4 (link4), pose; link 1 (link1), mass matrix; link 3 (link3), Jacobian
  const Real t80 = minus_c23 * c1;
  const Real t81 = t73 * t28;
  const Real t82 = J_2_zz + t47 - 2.0 * t41 - t43 * t39 - t48 * t44 - t70 * t57;
  const Real t83 = t59 - t48 * t51 - t70 * t58;
  const Real t84 = t74 - t38 * t65 - t42 * t73;
  const Real t86 = t22 * c1;
  const Real t87 = 1.0 / t82;
  const Lanes<8> t90_lanes = detail::make_pack<Real>(t63, t63, t63, t63, t84, t78, t63, t63) * t56;
  const Real t91 = s23 * c1;
  const Lanes<8> t92_lanes = detail::make_pack<Real>(t66 * s1, t66 * s1, t66 * s1, t66 * s1, t74 -
      t43 * t65 - t48 * t73, t62 - t43 * t32 - t48 * t67, t66 * s1, t66 * s1) - t70 *
      detail::make_pack<Real>(t63, t63, t63, t63, t84, t78, t63, t63);

  // link 1 (link1), mass matrix; links 4 (link4) and 5 (link5), pose
  const Real t94 = t66 * c1 - t70 * t86;
  const Real t95 = link6_to_tool_z * t64;
  const Real t96 = link6_to_tool_z * t60;
  const Real t97 = s4 * t80 - c4 * s1;
  const Real t99 = s5 * (c4 * t80 + s4 * s1) - c5 * t91;

  // link 1 (link1), mass matrix
  const Real t100 = t83 * t87;
  const Lanes<8> t101_lanes = t92_lanes * t87;
  const Real t102 = link6_to_tool_z * t99;
  const Real t104 = t91 + t4 * t99;
  const Real t105 = t19 * t99 - s1;
  const Real t106 = t61 - t54 * t46 - t55 * t51 - t71 * t58 - t100 * t83;
  const Lanes<8> t107_lanes = detail::make_pack<Real>(t36 * c1, t36 * c1, t36 * c1, t36 * c1, t52 *
      t64 - t54 * t65, 1.0 - t52 * t60 - t54 * t32, t36 * c1, t36 * c1) -
      detail::make_pack<Real>(link2_to_3_z, link2_to_3_z, link2_to_3_z, link2_to_3_z, t55, t55,
      link2_to_3_z, link2_to_3_z) * detail::make_pack<Real>(s1, s1, s1, s1, t73, t67, s1, s1) -
      t71 * detail::make_pack<Real>(t63, t63, t63, t63, t84, t78, t63, t63) - t100 * t92_lanes;
  const Real t108 = t68 * t60 + t69 * t32 + t77 * t67 + t90_lanes[5] * t78 + t101_lanes[5] *
      t92_lanes[5];
  const Real t109 = t69 * t65 - t68 * t64 + t77 * t73 + t90_lanes[5] * t84 + t101_lanes[5] *
      t92_lanes[4];
  const Real t110 = t75 * t64 + t76 * t65 + t81 * t73 + t90_lanes[4] * t84 + t101_lanes[4] *
      t92_lanes[4];
  const Real t111 = t36 * s1 + link2_to_3_z * c1 + t71 * t86 + t100 * t94;
  const Real t113 = t105 - t38 * t97 - t42 * t104;
  const Real t114 = t20 * t56;
  const Real t115 = 1.0 / (t106 + 2.0 * (link2_to_3_z * t10 - t35 - t27) + t72 * s23);
  const Real t116 = t113 * t56;
  const Real t118 = t70 * t20 - t36;
  const Real t119 = 24999.999999999996 * t99 * t99 + 1557.24430048586 * t97 * t97 + t104 * t28 *
      t104;
  const Real t120 = t105 - t43 * t97 - t48 * t104 - t70 * t113;
  const Real t121 = t118 * t87;
  const Real t122 = t120 * t87;
  const Real t123 = t71 * t20 - t100 * t118;
  const Real t124 = t52 * t99 + t54 * t97 + t55 * t104 + t71 * t113 + t100 * t120;
  const Real t125 = t68 * t99 + t69 * t97 + t77 * t104 + t90_lanes[5] * t113 + t101_lanes[5] * t120;
  const Real t126 = t76 * t97 - t75 * t99 + t81 * t104 + t90_lanes[4] * t113 + t101_lanes[4] * t120;
  const Lanes<8> t127_lanes = t107_lanes * t115;
  const Real t128 = t123 * t115;
  const Real t129 = t124 * t115;
  const Real t131 = t108 + t127_lanes[5] * t107_lanes[5];
  const Real t132 = t109 + t127_lanes[5] * t107_lanes[4];
  const Real t133 = t110 + t127_lanes[4] * t107_lanes[4];
  const Real t134 = t90_lanes[5] * t86 + t101_lanes[5] * t94 - t127_lanes[5] * t111;
  const Real t135 = t90_lanes[4] * t86 + t101_lanes[4] * t94 - t127_lanes[4] * t111;
  const Real t136 = t86 * t56 * t86 + t94 * t87 * t94 + t111 * t115 * t111;
  const Real t137 = t125 - t127_lanes[5] * t124;
  const Real t138 = t126 - t127_lanes[4] * t124;
  const Real t139 = t119 + t116 * t113 + t122 * t120 + t129 * t124;
  const Lanes<8> t140_lanes = t90_lanes * t63 + t101_lanes * t92_lanes[1] + t127_lanes *
      t107_lanes[1];
  const Real t141 = t137 * t95;
  const Real t142 = t138 * t96;
  const Real t143 = t116 * t63 + t122 * t92_lanes[1] - t129 * t107_lanes[1];
  const Real t144 = t101_lanes[4] * t118 - t90_lanes[4] * t20 + t127_lanes[4] * t123;
  const Real t145 = t101_lanes[5] * t118 - t90_lanes[5] * t20 + t127_lanes[5] * t123;
  const Real t146 = t132 * t102;
  const Real t147 = t134 - (t131 * t95 + t132 * t96);
  const Real t148 = t135 - (t132 * t95 + t133 * t96);
  const Real t149 = t122 * t118 - t116 * t20 - t129 * t123;
  const Real t150 = t116 * t86 + t122 * t94 + t129 * t111 - (t141 + t142);
  const Real t151 = t140_lanes[5] - (t131 * t102 - t137 * t96);
  const Real t152 = t143 - (t137 * t102 - t139 * t96);
  const Real t153 = t140_lanes[4] - (t146 - t142);
  const Real t154 = t144 + (t133 * t102 + t138 * t95);
  const Real t155 = t90_lanes[1] * t86 + t101_lanes[1] * t94 - t127_lanes[1] * t111 - t95 *
      t140_lanes[5] - t102 * t147;
  const Real t156 = t121 * t94 - t114 * t86 - t128 * t111 - t96 * t144 + t102 * t148;
  const Real t157 = t149 + (t138 * t102 + t139 * t95);
  const Real t158 = t155 + (t150 - t140_lanes[4]) * t96;
  const Real t159 = t156 + (t150 - t145) * t95;
  const Real t160 = t121 * t92_lanes[1] - t114 * t63 + t128 * t107_lanes[1] + t96 * t149 + t95 *
      t152;
  const Real t161 = t136 - (t95 * (t134 + t147) + t96 * (t135 + t148));
  const Real t162 = t161 * t161;
  const Real t163 = t162 * t161;
  const Real t164 = t114 * t20 + t121 * t118 + t128 * t123 +
      (t102 * (t144 + t154) + t95 * (t149 + t157));
  const Real t165 = t163 * t162 / (1.262177448353619e-29 + t163 * t163);
  const Real t166 = t158 * t165;
  const Real t167 = t159 * t165;
  const Real t168 = t147 * t165;
  const Real t169 = t148 * t165;
  const Real t170 = t150 * t165;
  const Real t173 = t140_lanes[1] - (t102 * (t140_lanes[5] + t151) - t96 * (t143 + t152)) - t166 *
      t158;
  const Real t174 = t151 - t168 * t158;
  const Real t175 = t153 - t169 * t158;
  const Real t176 = t152 - t170 * t158;
  const Real t179 = t173 * t173;
  const Real t180 = t160 - t167 * t158 + (t153 - t145) * t102;
  const Real t181 = t179 * t173;
  const Real t182 = t181 * t179 / (1.9721522630525295e-31 + t181 * t181);
  const Real t183 = t174 * t182;
  const Real t184 = t175 * t182;
  const Real t185 = t176 * t182;
  const Real t186 = t180 * t182;
  const Real t187 = t166 * t182;
  const Lanes<8> t190_lanes = detail::make_pack<Real>(t164, t164, t164, t157, t154, t145 +
      (t146 + t141), t164, t164) - detail::make_pack<Real>(t167, t167, t167, t170, t169, t168, t167,
      t167) * t159 - detail::make_pack<Real>(t186, t186, t186, t185, t184, t183, t186, t186) * t180;
  const Real t192 = t186 * t166 - t167;
  const Real t193 = t190_lanes[2] * t190_lanes[2];
  const Real t194 = t193 * t190_lanes[2];
  const Real t195 = t194 * t193 / (1.262177448353619e-29 + t194 * t194);
  const Lanes<8> t196_lanes = t190_lanes * t195;
  const Real t197 = t192 * t195;
  const Real t198 = t186 * t195;
  const Lanes<8> t200_lanes = detail::make_pack<Real>(t139, t139, t139, t139, t138, t137, t139,
      t139) - detail::make_pack<Real>(t170, t170, t170, t170, t169, t168, t170, t170) * t150 -
      detail::make_pack<Real>(t185, t185, t185, t185, t184, t183, t185, t185) * t176 - t196_lanes *
      t190_lanes[3];
  const Real t201 = t185 * t166 - t170 - t196_lanes[3] * t192;
  const Real t202 = t196_lanes[3] * t186 - t185;
  const Real t203 = t200_lanes[3] * t200_lanes[3];
  const Real t204 = t203 * t200_lanes[3];
  const Real t205 = t204 * t203 / (9.313225746154785e-10 + t204 * t204);
  const Real t206 = t200_lanes[4] * t205;
  const Real t207 = t200_lanes[5] * t205;
  const Real t208 = t201 * t205;
  const Real t209 = t202 * t205;
  const Real t210 = t196_lanes[3] * t205;
  const Real t211 = t133 - t169 * t148 - t184 * t175 - t196_lanes[4] * t190_lanes[4] - t206 *
      t200_lanes[4];
  const Real t212 = t132 - t168 * t148 - t183 * t175 - t196_lanes[5] * t190_lanes[4] - t207 *
      t200_lanes[4];
  const Real t213 = t131 - t168 * t147 - t183 * t174 - t196_lanes[5] * t190_lanes[5] - t207 *
      t200_lanes[5];
  const Real t214 = t184 * t166 - t169 - t196_lanes[4] * t192 - t206 * t201;
  const Real t215 = t196_lanes[4] * t186 - t184 - t206 * t202;
  const Real t216 = t206 * t196_lanes[3] - t196_lanes[4];
  const Real t217 = t211 * t211;
  const Real t218 = t217 * t211;
  const Real t219 = t218 * t217 / (8.673617379884035e-19 + t218 * t218);
  const Real t220 = t212 * t219;
  const Real t221 = t214 * t219;
  const Real t222 = t215 * t219;
  const Real t223 = t216 * t219;
  const Real t224 = t206 * t219;
  const Real t225 = t213 - t220 * t212;
  const Real t226 = t183 * t166 - t168 - t196_lanes[5] * t192 - t207 * t201 - t220 * t214;
  const Real t227 = t196_lanes[5] * t186 - t183 - t207 * t202 - t220 * t215;
  const Real t228 = t207 * t196_lanes[3] - t196_lanes[5] - t220 * t216;
  const Real t229 = t220 * t206 - t207;
  const Real t230 = t165 + t187 * t166 + t197 * t192 + t208 * t201 + t221 * t214;
  const Real t231 = t225 * t225;
  const Real t232 = t231 * t225;
  const Real Lambda_5_5 = t232 * t231 / (2.117582368135751e-22 + t232 * t232);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5 = t226 * Lambda_5_5;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_1_5 = t227 * Lambda_5_5;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_2_5 = t228 * Lambda_5_5;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_3_5 = t229 * Lambda_5_5;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_4_5 = t220 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  Lambda[0] = t230 + Lambda_0_5 * t226;
  const Real Lambda_0_1 = t209 * t201 - (t187 + t198 * t192) + t222 * t214 + Lambda_1_5 * t226;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_0_2 = t197 - t210 * t201 + t223 * t214 + Lambda_2_5 * t226;
  Lambda[2] = Lambda_0_2;
  Lambda[12] = Lambda_0_2;
  const Real Lambda_0_3 = t208 - t224 * t214 + Lambda_3_5 * t226;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_0_4 = t221 - Lambda_4_5 * t226;
  Lambda[4] = Lambda_0_4;
  Lambda[24] = Lambda_0_4;
  Lambda[7] = t182 + t198 * t186 + t209 * t202 + t222 * t215 + Lambda_1_5 * t227;
  const Real Lambda_1_2 = t223 * t215 - (t198 + t210 * t202) + Lambda_2_5 * t227;
  Lambda[8] = Lambda_1_2;
  Lambda[13] = Lambda_1_2;
  const Real Lambda_1_3 = t209 - t224 * t215 + Lambda_3_5 * t227;
  Lambda[9] = Lambda_1_3;
  Lambda[19] = Lambda_1_3;
  const Real Lambda_1_4 = t222 - Lambda_4_5 * t227;
  Lambda[10] = Lambda_1_4;
  Lambda[25] = Lambda_1_4;
  Lambda[14] = t195 + t210 * t196_lanes[3] + t223 * t216 + Lambda_2_5 * t228;
  const Real Lambda_2_3 = Lambda_3_5 * t228 - (t210 + t224 * t216);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = t223 - Lambda_4_5 * t228;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = t205 + t224 * t206 + Lambda_3_5 * t229;
  const Real Lambda_3_4 = t224 + Lambda_4_5 * t229;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = t219 + Lambda_4_5 * t220;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
