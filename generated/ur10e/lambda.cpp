// SPDX-License-Identifier: 0BSD
// lambda: Lambda = (J M^-1 J^T)^-1
// By M = L^T D L, J carried inward, in the axes asked for at the points.
// 822 flops (add 331, mul 481, div 10), sine and cosine of 5 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

template <int count>
using Lanes = detail::Pack<Real, count>;
void lambda(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT Lambda)[36]) noexcept {
  // constants
  const Real h_5_y = 0.09132825;
  const Real J_6_zz = 0.000623;
  const Real minus_J_5_yz = 0.0106962107625;
  const Real minus_h_4_y = 0.33495075;
  const Real minus_link3_to_4_x = 0.57155;
  const Real minus_link2_to_3_x = 0.6127;
  const Real J_3_zz = 2.08330527531;
  const Real minus_h_3_x = 4.0059802;
  const Real link4_to_5_z = 0.17415;
  const Real J_4_yz = 0.0585962731125;
  const Real J_2_zz = 4.3866871861500005;
  const Real J_3_xz = 0.5656542411875001;
  const Real J_2_xz = 1.156008191975;
  const Real link6_to_tool_z = 0.11655;
  const Real link5_to_6_z = 0.11985;
  const Real J_5_yy = 0.00124;

  // sines and cosines
  const Real angles[5] = {q[4], q[1], q[2], q[3], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real c5 = cosines[0];
  const Real c2 = cosines[1];
  const Real c3 = cosines[2];
  const Real s2 = sines[1];
  const Real s3 = sines[2];
  const Real c4 = cosines[3];
  const Real s4 = sines[3];
  const Real c1 = cosines[4];
  const Real s5 = sines[0];
  const Real s1 = sines[4];

  // link 5 (wrist_2), composite inertia; link 1 (shoulder), mass matrix
  const Real t1 = 0.0054190910375000005 * s5;
  const Real t2 = h_5_y * s5;
  const Real t3 = h_5_y * c5;
  const Real t4 = minus_J_5_yz * c5;
  const Real t5 = 1.2551157591996094 * c5;
  const Real t6 = minus_link2_to_3_x * s2;
  const Real t7 = minus_link2_to_3_x * c2;
  const Real c23 = c2 * c3 - s2 * s3;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real t8 = s5 * t1;
  const Real t9 = c5 * (J_6_zz * c5);

  // link 5 (wrist_2), Jacobian and composite inertia
  const Real t10 = link6_to_tool_z * s5;
  const Real t11 = minus_link3_to_4_x * s23;
  const Real t12 = minus_link3_to_4_x * c23;
  const Real t13 = 0.0415928163875 + t8;
  const Real c234 = c23 * c4 - s23 * s4;
  const Real s234 = s23 * c4 + c23 * s4;
  const Real t14 = s234 * t2;

  // link 5 (wrist_2), mass matrix and composite inertia and pose
  const Real t15 = s234 * t3;
  const Real t16 = c234 * t3;
  const Real t17 = s234 * c5;
  const Real t18 = s5 * s234;
  const Real t19 = c234 * s1;
  const Real t20 = c234 * c1;
  const Real t21 = minus_h_4_y * c234 + t14;
  const Real t22 = minus_h_4_y * s234 - c234 * t2;

  // links 1 (shoulder) and 6 (wrist_3), mass matrix; link 4 (wrist_1), composite inertia; link 5
  //   (wrist_2), Jacobian
  const Real t23 = 1.0 / (t13 - t9 - t5 * t4);
  const Real t24 = J_6_zz * t18;
  const Real t25 = t12 * t22;
  const Real t26 = link6_to_tool_z * t17;
  const Real t27 = c5 * t24;
  const Real t28 = t11 * t21 - t25;

  // links 3 (forearm) and 5 (wrist_2), composite inertia; link 5 (wrist_2), mass matrix and pose
  const Real t29 = t7 * (t22 - minus_h_3_x * c23);
  const Real t30 = t12 * t15 - t11 * t16 - t4;
  const Real t31 = c5 * t19 - s5 * c1;
  const Real t32 = t17 * t1 + link4_to_5_z * t14 + (J_4_yz + t4) * c234;
  const Real t33 = c5 * t20 + s5 * s1;
  const Real t34 = c5 * s1 - s5 * t20;

  // links 1 (shoulder) and 5 (wrist_2), mass matrix; link 3 (forearm), composite inertia
  const Real t35 = 117.34209310833121 * t30;
  const Real t36 = t30 + (t7 * t15 - t6 * t16);
  const Real t37 = t6 * (minus_h_3_x * s23 + t21) - t29;
  const Real t38 = minus_J_5_yz * t18 - 0.0085220910375 * c234 - link4_to_5_z * t16 - (t12 + t7) *
      t2;
  const Real t39 = t13 + t28 - t9;
  const Real t40 = 117.34209310833121 * t36;
  const Real t41 = t39 + t5 * t30;

  // link 1 (shoulder), mass matrix; link 5 (wrist_2), Jacobian and pose
  const Real t42 = 117.34209310833121 * t38;
  const Real t43 = link6_to_tool_z * t31;
  const Real t44 = link6_to_tool_z * t33;
  const Real t45 = J_3_xz * s23 + (t32 + t11 * t3) + t27;
  const Real t46 = s234 * c1;

  // link 1 (shoulder), mass matrix; link 5 (wrist_2), Jacobian
  const Real t47 = t41 * t23;
  const Real t48 = t32 + t27 + t5 * t38;
  const Real t49 = s234 * t10 + link5_to_6_z * c234;
  const Real t50 = J_3_zz + (t13 + 2.0 * t28) - t9;
  const Real t51 = t39 + t6 * t21 - t7 * t22 + t5 * t36;
  const Real t52 = t48 * t23;
  const Real t53 = c5 * t18;
  const Real t55 = link5_to_6_z * s234 - c234 * t10;
  const Real t56 = t51 * t23;
  const Real t57 = 0.0098370910375 + (6.9910934060975 - s2 * (4.36318718615 * s2) - s23 *
      (2.07831527531 * s23)) + 0.031809629475 * c5;
  const Real t58 = s1 - c5 * t34;
  const Real t59 = t45 - t35 * t38 - t47 * t48;

  // link 4 (wrist_1), Jacobian; link 1 (shoulder), mass matrix
  const Real t60 = t49 + t11;
  const Real t61 = t50 + t37 - t35 * t36 - t47 * t51;
  const Real t62 = 1.0 / (t50 - t35 * t30 - t47 * t41);
  const Real t63 = t55 - t12;
  const Lanes<8> t64_lanes = detail::make_pack<Real>(t49 * c1, t49 * s1, t55, t49 * c1, t49 * c1,
      t53, t49 * c1, t49 * c1) - t5 * detail::make_pack<Real>(t44, t43, t26, t44, t44, c234, t44,
      t44);

  // link 1 (shoulder), mass matrix; links 3 (forearm) and 5 (wrist_2), Jacobian
  const Real t65 = t58 + t5 * t46;
  const Real t67 = t60 + t6;
  const Real t68 = J_2_xz * s2 + t45 + t6 * t3 - t40 * t38 - t56 * t48;
  const Real t69 = t63 - t7;
  const Real t70 = link4_to_5_z + link6_to_tool_z * c5;

  // link 1 (shoulder), mass matrix
  const Lanes<8> t73_lanes = detail::make_pack<Real>(t60 * c1, t60 * s1, t63, t60 * c1, t60 * c1,
      t53, t60 * c1, t60 * c1) + t35 * detail::make_pack<Real>(t44, t43, t26, t44, t44, c234, t44,
      t44);
  const Real t74 = (0.037099816387500005 * s234 - (s234 * (J_5_yy + t8) + c234 *
      (0.021392421525 * s5))) * s234;
  const Lanes<8> t77_lanes = detail::make_pack<Real>(t73_lanes[0], t73_lanes[1], t73_lanes[2], t58 -
      t35 * t46, t73_lanes[0], t73_lanes[5], t73_lanes[0], t73_lanes[0]) - t47 *
      detail::make_pack<Real>(t64_lanes[0], t64_lanes[1], t64_lanes[2], t65, t64_lanes[0],
      t64_lanes[5], t64_lanes[0], t64_lanes[0]);
  const Lanes<8> t78_lanes = detail::make_pack<Real>(t67 * c1, t67 * s1, t69, t67 * c1, t67 * c1,
      t53, t67 * c1, t67 * c1) + t40 * detail::make_pack<Real>(t44, t43, t26, t44, t44, c234, t44,
      t44);
  const Lanes<8> t80_lanes = t64_lanes * t23;
  const Lanes<8> t81_lanes = detail::make_pack<Real>(13.676220951776003, 13.676220951776003,
      13.676220951776003, 13.676220951776003, 13.676220951776003, 117.34209310833121,
      13.676220951776003, 13.676220951776003) * detail::make_pack<Real>(t33, t31, t17, t33, t33,
      c234, t33, t33);
  const Real t83 = t65 * t23;
  const Real t84 = 117.34209310833121 * t46;
  const Real t85 = t61 * t62;
  const Real t86 = t59 * t62;
  const Lanes<8> t87_lanes = t77_lanes * t62;

  // link 5 (wrist_2), pose; link 1 (shoulder), mass matrix
  const Real t88 = s234 * s1;
  const Lanes<8> t89_lanes = detail::make_pack<Real>(t70 * c1 - t69 * s1, t69 * c1 + t70 * s1, t70 *
      c1 - t69 * s1, t70 * c1 - t69 * s1, t70 * c1 - t69 * s1, 1.0 - t18 * t18, t70 * c1 - t69 * s1,
      t70 * c1 - t69 * s1) + t42 * detail::make_pack<Real>(t44, t43, t44, t44, t44, c234, t44, t44);
  const Real t90 = s5 * t19 + c5 * c1;
  const Lanes<8> t99_lanes = t81_lanes * t44 + t80_lanes * t64_lanes[0];
  const Real t100 = 117.34209310833121 * t88;

  // link 1 (shoulder), mass matrix
  const Real t101 = J_2_zz + t50 + 2.0 * t37 - t40 * t36 - t56 * t51 - t85 * t61;
  const Real t102 = t68 - t85 * t59;
  const Real t103 = t57 - t18 * t24 - t42 * t38 - t52 * t48 - t86 * t59;
  const Lanes<8> t104_lanes = detail::make_pack<Real>(t78_lanes[0], t78_lanes[1], t78_lanes[2],
      t58 - t40 * t46, t78_lanes[0], t78_lanes[5], t78_lanes[0], t78_lanes[0]) - t56 *
      detail::make_pack<Real>(t64_lanes[0], t64_lanes[1], t64_lanes[2], t65, t64_lanes[0],
      t64_lanes[5], t64_lanes[0], t64_lanes[0]) - t85 * t77_lanes;
  const Real t106 = c5 * t90 - c1;
  const Lanes<8> t109_lanes = t81_lanes * t43 + t80_lanes * t64_lanes[1];
  const Real t110 = 1.0 / t101;
  const Real t111 = t106 + t5 * t88;
  const Real t113 = 1605.1364365971108 * t18;
  const Real t114 = t111 * t23;
  const Real t116 = 1605.1364365971108 * t90;
  const Real t117 = t106 - t35 * t88 - t47 * t111;
  const Real t119 = t117 * t62;
  const Real t120 = t102 * t110;
  const Lanes<8> t121_lanes = t104_lanes * t110;
  const Real t122 = t106 - t40 * t88 - t56 * t111 - t85 * t117;
  const Real t126 = t122 * t110;
  const Lanes<8> t128_lanes = detail::make_pack<Real>(t89_lanes[0], t89_lanes[1], t42 * t26, t18 *
      t34 - t42 * t46, t89_lanes[0], t89_lanes[5], t89_lanes[0], t89_lanes[0]) - t52 *
      detail::make_pack<Real>(t64_lanes[0], t64_lanes[1], t64_lanes[2], t65, t64_lanes[0],
      t64_lanes[5], t64_lanes[0], t64_lanes[0]) - t86 * t77_lanes - t120 * t104_lanes;
  const Real t131 = t18 * t90 + t42 * t88 + t52 * t111 + t86 * t117 + t120 * t122;
  const Real t133 = 1605.1364365971108 * t34 * t34 + t84 * t46 + t83 * t65 + t87_lanes[3] *
      t77_lanes[3];
  const Real t134 = t80_lanes[5] * t65 - (t113 * t34 + t81_lanes[5] * t46) + t87_lanes[5] *
      t77_lanes[3] + t121_lanes[5] * t104_lanes[3];
  const Real t135 = t100 * t46 - t116 * t34 + t114 * t65 + t119 * t77_lanes[3] + t126 *
      t104_lanes[3];
  const Real t136 = t116 * t90 + t100 * t88 + t114 * t111 + t119 * t117 + t126 * t122;
  const Real t137 = 1.0 / (t103 - t120 * t102 - 2.0 * (t25 + t29) + t74);
  const Real t138 = t113 * t90 - t81_lanes[5] * t88 + t80_lanes[5] * t111 + t87_lanes[5] * t117 +
      t121_lanes[5] * t122;
  const Real t139 = t113 * t18 + t81_lanes[5] * c234 + t80_lanes[5] * t64_lanes[5] + t87_lanes[5] *
      t77_lanes[5] + t121_lanes[5] * t104_lanes[5];
  const Lanes<8> t140_lanes = t128_lanes * t137;
  const Real t141 = t131 * t137;
  const Lanes<8> t145_lanes = detail::make_pack<Real>(t99_lanes[0], t99_lanes[1], t99_lanes[2],
      t83 * t64_lanes[0] - t84 * t44, t99_lanes[0], t99_lanes[5], t99_lanes[0], t99_lanes[0]) +
      t87_lanes * t77_lanes[0] + t121_lanes * t104_lanes[0] + t140_lanes * t128_lanes[0];
  const Real t146 = t114 * t64_lanes[0] - t100 * t44 + t119 * t77_lanes[0] + t126 * t104_lanes[0] -
      t141 * t128_lanes[0];
  const Lanes<8> t147_lanes = detail::make_pack<Real>(t109_lanes[1], t109_lanes[1], t109_lanes[2],
      t83 * t64_lanes[1] - t84 * t43, t109_lanes[1], t109_lanes[5], t109_lanes[1], t109_lanes[1]) +
      t87_lanes * t77_lanes[1] + t121_lanes * t104_lanes[1] + t140_lanes * t128_lanes[1];
  const Real t148 = t114 * t64_lanes[1] - t100 * t43 + t119 * t77_lanes[1] + t126 * t104_lanes[1] -
      t141 * t128_lanes[1];
  const Lanes<8> t149_lanes = detail::make_pack<Real>(t81_lanes[2] * t26 + t80_lanes[2] *
      t64_lanes[2], t81_lanes[2] * t26 + t80_lanes[2] * t64_lanes[2], t81_lanes[2] * t26 +
      t80_lanes[2] * t64_lanes[2], t83 * t64_lanes[2] - t84 * t26, t81_lanes[2] * t26 +
      t80_lanes[2] * t64_lanes[2], t81_lanes[5] * t26 + t80_lanes[5] * t64_lanes[2], t81_lanes[2] *
      t26 + t80_lanes[2] * t64_lanes[2], t81_lanes[2] * t26 + t80_lanes[2] * t64_lanes[2]) +
      t87_lanes * t77_lanes[2] + t121_lanes * t104_lanes[2] + t140_lanes * t128_lanes[2];
  const Real t150 = t114 * t64_lanes[2] - t100 * t26 + t119 * t77_lanes[2] + t126 * t104_lanes[2] -
      t141 * t128_lanes[2];
  const Real t151 = t145_lanes[0] * t145_lanes[0];
  const Real t152 = t151 * t145_lanes[0];
  const Real t153 = t152 * t151 / (3.0814879110195774e-33 + t152 * t152);
  const Real t154 = t145_lanes[5] * t153;
  const Real t155 = t146 * t153;
  const Real t156 = t145_lanes[3] * t153;
  const Real t157 = t145_lanes[2] * t153;
  const Real t158 = t145_lanes[1] * t153;
  const Lanes<8> t164_lanes = detail::make_pack<Real>(t147_lanes[1], t147_lanes[1], t147_lanes[2],
      t147_lanes[3], t148, t147_lanes[5], t147_lanes[1], t147_lanes[1]) -
      detail::make_pack<Real>(t158, t158, t157, t156, t155, t154, t158, t158) * t145_lanes[1];
  const Real t165 = t164_lanes[1] * t164_lanes[1];
  const Real t166 = t165 * t164_lanes[1];
  const Real t167 = t166 * t165 / (3.0814879110195774e-33 + t166 * t166);
  const Lanes<8> t168_lanes = t164_lanes * t167;
  const Real t169 = t158 * t167;
  const Lanes<8> t172_lanes = detail::make_pack<Real>(t149_lanes[2], t149_lanes[2], t149_lanes[2],
      t149_lanes[3], t150, t149_lanes[5], t149_lanes[2], t149_lanes[2]) -
      detail::make_pack<Real>(t157, t157, t157, t156, t155, t154, t157, t157) * t145_lanes[2] -
      t168_lanes * t164_lanes[2];
  const Real t174 = t168_lanes[2] * t158 - t157;
  const Real t175 = t172_lanes[2] * t172_lanes[2];
  const Real t176 = t175 * t172_lanes[2];
  const Real t177 = t176 * t175 / (4.81482486096809e-35 + t176 * t176);
  const Lanes<8> t178_lanes = t172_lanes * t177;
  const Real t179 = t174 * t177;
  const Real t180 = t168_lanes[2] * t177;
  const Lanes<8> t182_lanes = detail::make_pack<Real>(t133 + t121_lanes[3] * t104_lanes[3] +
      t140_lanes[3] * t128_lanes[3], t133 + t121_lanes[3] * t104_lanes[3] + t140_lanes[3] *
      t128_lanes[3], t133 + t121_lanes[3] * t104_lanes[3] + t140_lanes[3] * t128_lanes[3], t133 +
      t121_lanes[3] * t104_lanes[3] + t140_lanes[3] * t128_lanes[3], t135 - t141 * t128_lanes[3],
      t134 + t140_lanes[5] * t128_lanes[3], t133 + t121_lanes[3] * t104_lanes[3] + t140_lanes[3] *
      t128_lanes[3], t133 + t121_lanes[3] * t104_lanes[3] + t140_lanes[3] * t128_lanes[3]) -
      detail::make_pack<Real>(t156, t156, t156, t156, t155, t154, t156, t156) * t145_lanes[3] -
      t168_lanes * t164_lanes[3] - t178_lanes * t172_lanes[3];
  const Real t183 = t136 + t141 * t131 - t155 * t146 - t168_lanes[4] * t164_lanes[4] -
      t178_lanes[4] * t172_lanes[4];
  const Real t184 = t138 - t140_lanes[5] * t131 - t154 * t146 - t168_lanes[5] * t164_lanes[4] -
      t178_lanes[5] * t172_lanes[4];
  const Real t185 = t139 + t140_lanes[5] * t128_lanes[5] - t154 * t145_lanes[5] - t168_lanes[5] *
      t164_lanes[5] - t178_lanes[5] * t172_lanes[5];
  const Real t186 = t168_lanes[3] * t158 - t156 - t178_lanes[3] * t174;
  const Real t187 = t178_lanes[3] * t168_lanes[2] - t168_lanes[3];
  const Real t188 = t182_lanes[3] * t182_lanes[3];
  const Real t189 = t188 * t182_lanes[3];
  const Real t190 = t189 * t188 / (3.552713678800501e-15 + t189 * t189);
  const Real t191 = t182_lanes[4] * t190;
  const Real t192 = t182_lanes[5] * t190;
  const Real t193 = t186 * t190;
  const Real t194 = t187 * t190;
  const Real t195 = t178_lanes[3] * t190;
  const Real t196 = t183 - t191 * t182_lanes[4];
  const Real t197 = t184 - t192 * t182_lanes[4];
  const Real t198 = t168_lanes[4] * t158 - t155 - t178_lanes[4] * t174 - t191 * t186;
  const Real t199 = t178_lanes[4] * t168_lanes[2] - t168_lanes[4] - t191 * t187;
  const Real t200 = t191 * t178_lanes[3] - t178_lanes[4];
  const Real t201 = t196 * t196;
  const Real t202 = t201 * t196;
  const Real t203 = t202 * t201 / (5.169878828456423e-26 + t202 * t202);
  const Real t204 = t197 * t203;
  const Real t205 = t198 * t203;
  const Real t206 = t199 * t203;
  const Real t207 = t200 * t203;
  const Real t208 = t191 * t203;
  const Real t209 = t185 - t192 * t182_lanes[5] - t204 * t197;
  const Real t210 = t168_lanes[5] * t158 - t154 - t178_lanes[5] * t174 - t192 * t186 - t204 * t198;
  const Real t211 = t178_lanes[5] * t168_lanes[2] - t168_lanes[5] - t192 * t187 - t204 * t199;
  const Real t212 = t192 * t178_lanes[3] - t178_lanes[5] - t204 * t200;
  const Real t213 = t204 * t191 - t192;
  const Real t214 = t153 + t169 * t158 + t179 * t174 + t193 * t186 + t205 * t198;
  const Real t215 = t209 * t209;
  const Real t216 = t215 * t209;
  const Real Lambda_5_5 = t216 * t215 / (8.077935669463161e-28 + t216 * t216);
  Lambda[35] = Lambda_5_5;
  const Real Lambda_0_5 = t210 * Lambda_5_5;
  Lambda[5] = Lambda_0_5;
  Lambda[30] = Lambda_0_5;
  const Real Lambda_1_5 = t211 * Lambda_5_5;
  Lambda[11] = Lambda_1_5;
  Lambda[31] = Lambda_1_5;
  const Real Lambda_2_5 = t212 * Lambda_5_5;
  Lambda[17] = Lambda_2_5;
  Lambda[32] = Lambda_2_5;
  const Real Lambda_3_5 = t213 * Lambda_5_5;
  Lambda[23] = Lambda_3_5;
  Lambda[33] = Lambda_3_5;
  const Real Lambda_4_5 = t204 * Lambda_5_5;
  Lambda[29] = -Lambda_4_5;
  Lambda[34] = -Lambda_4_5;
  Lambda[0] = t214 + Lambda_0_5 * t210;
  const Real Lambda_0_1 = t194 * t186 - (t169 + t180 * t174) + t206 * t198 + Lambda_1_5 * t210;
  Lambda[1] = Lambda_0_1;
  Lambda[6] = Lambda_0_1;
  const Real Lambda_0_2 = t179 - t195 * t186 + t207 * t198 + Lambda_2_5 * t210;
  Lambda[2] = Lambda_0_2;
  Lambda[12] = Lambda_0_2;
  const Real Lambda_0_3 = t193 - t208 * t198 + Lambda_3_5 * t210;
  Lambda[3] = Lambda_0_3;
  Lambda[18] = Lambda_0_3;
  const Real Lambda_0_4 = t205 - Lambda_4_5 * t210;
  Lambda[4] = Lambda_0_4;
  Lambda[24] = Lambda_0_4;
  Lambda[7] = t167 + t180 * t168_lanes[2] + t194 * t187 + t206 * t199 + Lambda_1_5 * t211;
  const Real Lambda_1_2 = t207 * t199 - (t180 + t195 * t187) + Lambda_2_5 * t211;
  Lambda[8] = Lambda_1_2;
  Lambda[13] = Lambda_1_2;
  const Real Lambda_1_3 = t194 - t208 * t199 + Lambda_3_5 * t211;
  Lambda[9] = Lambda_1_3;
  Lambda[19] = Lambda_1_3;
  const Real Lambda_1_4 = t206 - Lambda_4_5 * t211;
  Lambda[10] = Lambda_1_4;
  Lambda[25] = Lambda_1_4;
  Lambda[14] = t177 + t195 * t178_lanes[3] + t207 * t200 + Lambda_2_5 * t212;
  const Real Lambda_2_3 = Lambda_3_5 * t212 - (t195 + t208 * t200);
  Lambda[15] = Lambda_2_3;
  Lambda[20] = Lambda_2_3;
  const Real Lambda_2_4 = t207 - Lambda_4_5 * t212;
  Lambda[16] = Lambda_2_4;
  Lambda[26] = Lambda_2_4;
  Lambda[21] = t190 + t208 * t191 + Lambda_3_5 * t213;
  const Real Lambda_3_4 = t208 + Lambda_4_5 * t213;
  Lambda[22] = -Lambda_3_4;
  Lambda[27] = -Lambda_3_4;
  Lambda[28] = t203 + Lambda_4_5 * t204;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
