// SPDX-License-Identifier: 0BSD
// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J carried inward, in the axes of link 2 (link2) at link origins.
// 560 flops (add 233, mul 323, div 4), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void lambda_inverse(const Real (&TREELINE_RESTRICT q)[6],
    Real (&TREELINE_RESTRICT Lambda_inv)[36]) noexcept {
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
  const Real angles[5] = {q[1], q[2], q[3], q[4], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real s4 = sines[2];
  const Real s5 = sines[3];
  const Real c4 = cosines[2];
  const Real c5 = cosines[3];
  const Real s1 = sines[4];
  const Real c1 = cosines[4];

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

  // link 3 (link3), composite inertia; links 1, 5 and 6, mass matrix
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

  // link 1 (link1), mass matrix
  const Real t47 = J_3_zz + (0.00129216 - t29 - 2.0 * (t27 + t22 * t23)) - t19 * t14;
  const Real t48 = t44 * t28;
  const Real t49 = 24999.999999999996 * t40;
  const Real t50 = t45 + t19 * t40;
  const Real t51 = s23 * t31 - minus_c23 * t15 - link2_to_3_z * t16 + t4 * t40 + t36 * t9;
  const Real t52 = 1557.24430048586 * t46;
  const Real t53 = t51 * t28;
  const Real t54 = 1.0 / (t47 - t38 * t34 - t42 * t37);
  const Real t55 = t47 - t41 - t38 * t39 - t42 * t44;
  const Real t56 = t50 - t38 * t46 - t42 * t51;

  // link 5 (link5), pose; link 1 (link1), mass matrix
  const Real t57 = s5 * s4;
  const Real t58 = s5 * t30 + c5 * minus_c23;
  const Real t59 = minus_J_2_xz * s2 + minus_J_2_yz * c2 + t50 + t8 * t10 - t43 * t46;
  const Real t60 = t19 * t58;
  const Real t61 = t4 * t57;
  const Real t62 = 3.153482265 - s2 * (1.601861202 * s2 + 0.0141984 * c2) + t15 - t49 * t40;
  const Real t63 = t4 * t58 - minus_c23;
  const Real t64 = 24999.999999999996 * t57;
  const Real t65 = 1.0 - t19 * t57;
  const Real t66 = 0.298925024 * s23 + 0.021347276999999998 * minus_c23 -
      (minus_c23 * (2.0 * t31) - s23 * (0.0011921599999999998 - t12 + t29 - t15));

  // link 4 (link4), pose; link 1 (link1), mass matrix
  const Real t67 = s4 * minus_c23;
  const Real t68 = t55 * t54;
  const Real t69 = t56 * t54;
  const Real t70 = 1557.24430048586 * c4;
  const Real t71 = 24999.999999999996 * t58;
  const Real t72 = t65 - t38 * c4 + t42 * t61;

  // link 1 (link1), mass matrix; link 5 (link5), pose
  const Real t73 = t60 - t38 * t32 - t42 * t63;
  const Real t74 = 1557.24430048586 * t32;
  const Real t75 = t61 * t28;
  const Real t76 = t63 * t28;
  const Real t77 = c5 * s23 - s5 * (c4 * minus_c23);

  // link 1 (link1), mass matrix
  const Real t78 = J_2_zz + t47 - 2.0 * t41 - t43 * t39 - t48 * t44 - t68 * t55;
  const Real t79 = t59 - t48 * t51 - t68 * t56;
  const Real t80 = t65 - t43 * c4 + t48 * t61 - t68 * t72;
  const Real t81 = t60 - t43 * t32 - t48 * t63 - t68 * t73;
  const Real t82 = t19 * t77;
  const Real t83 = 1.0 / t78;
  const Real t84 = t72 * t54;
  const Real t85 = 1.0 - t49 * t58 - t52 * t32 - t53 * t63 - t69 * t73;
  const Real t86 = t73 * t54;
  const Real t87 = t4 * t77 - s23;
  const Real t88 = t8 + (t68 - 1.0) * t22;
  const Real t89 = t82 + t38 * t67 - t42 * t87;
  const Real t90 = link6_to_tool_z * t58;
  const Real t91 = link6_to_tool_z * t57;
  const Real t92 = t79 * t83;
  const Real t93 = t89 * t54;
  const Real t94 = t80 * t83;
  const Real t95 = t81 * t83;
  const Real t96 = 24999.999999999996 * t77 * t77 + 1557.24430048586 * t67 * t67 + t87 * t28 * t87;
  const Real t97 = link6_to_tool_z * t77;
  const Real t98 = t82 + t43 * t67 - t48 * t87 - t68 * t89;
  const Real t99 = t98 * t83;
  const Real t100 = t62 - t52 * t46 - t53 * t51 - t69 * t56 - t92 * t79;
  const Real t101 = t49 * t57 - t52 * c4 + t53 * t61 - t69 * t72 - t92 * t80;
  const Real t102 = t85 - t92 * t81;
  const Real t103 = t64 * t57 + t70 * c4 + t75 * t61 + t84 * t72 + t94 * t80;
  const Real t104 = t70 * t32 - t64 * t58 - t75 * t63 + t84 * t73 + t94 * t81;
  const Real t105 = t71 * t58 + t74 * t32 + t76 * t63 + t86 * t73 + t95 * t81;
  const Real t106 = link2_to_3_z + t69 * t22 - t92 * t88;
  const Real t107 = t52 * t67 - t49 * t77 - t53 * t87 - t69 * t89 - t92 * t98;
  const Real t108 = t71 * t77 - t74 * t67 + t76 * t87 + t86 * t89 + t95 * t98;
  const Real t109 = t84 * t89 - (t64 * t77 + t70 * t67 + t75 * t87) + t94 * t98;
  const Real t110 = t68 * t20 - t36;
  const Real t111 = t20 * t54;
  const Real t112 = t110 * t83;

  // link 1 (link1), turn and mass matrix
  const Real t113 = 2.0 * c1;
  const Real t114 = 1.0 / (t100 + 2.0 * (link2_to_3_z * t10 - t35 - t27) + t66 * s23);
  const Real t115 = t69 * t20 - t92 * t110;
  const Real t116 = t101 * t114;
  const Real t117 = t102 * t114;

  // link 1 (link1), mass matrix
  const Real t118 = t107 * t114;
  const Real t119 = t36 * t114;
  const Real t120 = t115 * t114;
  const Real t121 = t118 * t36;
  const Real t122 = t117 * t36;
  const Real t123 = t116 * t36;
  const Real t124 = t103 + t116 * t101;
  const Real t125 = t104 + t116 * t102;
  const Real Lambda_inv_5_5 = t105 + t117 * t102;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real t126 = t96 + t93 * t89 + t99 * t98 + t118 * t107;
  const Real t127 = t108 + t117 * t107;
  const Real t128 = t109 + t116 * t107;
  const Real t129 = t94 * t88 - t84 * t22 + t116 * t106;
  const Real t130 = t95 * t88 - t86 * t22 + t117 * t106;
  const Real t131 = t128 * t90;
  const Real t132 = t127 * t91;
  const Real t133 = t125 * t97;
  const Real t134 = t22 * t54 * t22 + t88 * t83 * t88 + t106 * t114 * t106;
  const Real t135 = t95 * t110 - t86 * t20 + t117 * t115;
  const Real t136 = t99 * t110 - t93 * t20 + t118 * t115;
  const Real t137 = t94 * t110 - t84 * t20 + t116 * t115;
  const Real t138 = t129 + (t124 * t90 + t125 * t91);
  const Real t139 = t130 + (t125 * t90 + Lambda_inv_5_5 * t91);
  const Real t140 = t121 - (t126 * t90 - t127 * t97);
  const Real t141 = t122 - (t127 * t90 - Lambda_inv_5_5 * t97);
  const Real t142 = t99 * t88 - t93 * t22 + t118 * t106 + (t131 + t132);
  const Real t143 = t136 - (t126 * t91 + t128 * t97);
  const Real Lambda_inv_2_5 = t135 - (t132 + t133);
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;
  const Real t144 = t123 - (t131 - t133);
  const Real t145 = t137 - (t128 * t91 + t124 * t97);
  const Real t146 = t111 * t22 + t112 * t88 + t120 * t106 - t97 * t138 + t90 * t137;
  const Real t147 = t134 + (t90 * (t129 + t138) + t91 * (t130 + t139));
  const Real t148 = t119 * t106 + t97 * t139 + t91 * t122 + (t123 - t142) * t90;

  // link 1 (link1), turn and mass matrix
  const Real t149 = s1 * (t126 - t124) - t113 * t128;
  const Real t150 = t119 * t36 - (t90 * (t121 + t140) - t97 * (t122 + t141));
  const Real t151 = t146 + (t135 - t142) * t91;
  const Real t152 = t119 * t115 - t91 * t121 - t90 * t143 + (Lambda_inv_2_5 - t123) * t97;
  const Real t153 = s1 * (t142 - t144) - c1 * (t140 + t138);

  // link 1 (link1), turn
  const Real t154 = s1 * t153;
  const Real t155 = c1 * t153;
  const Real t156 = s1 * t149;
  const Real Lambda_inv_0_2 = c1 * t151 + s1 * t152;
  Lambda_inv[2] = -Lambda_inv_0_2;
  Lambda_inv[12] = -Lambda_inv_0_2;
  const Real Lambda_inv_0_5 = c1 * t139 + s1 * t141;
  Lambda_inv[5] = -Lambda_inv_0_5;
  Lambda_inv[30] = -Lambda_inv_0_5;
  const Real Lambda_inv_0_3 = t142 - t154;
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;
  const Real Lambda_inv_0_4 = t155 + t140;
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[24] = Lambda_inv_0_4;
  const Real Lambda_inv_1_2 = c1 * t152 - s1 * t151;
  Lambda_inv[8] = Lambda_inv_1_2;
  Lambda_inv[13] = Lambda_inv_1_2;
  const Real Lambda_inv_1_3 = t155 + t138;
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  const Real Lambda_inv_1_4 = t144 + t154;
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_1_5 = c1 * t141 - s1 * t139;
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real Lambda_inv_2_3 = c1 * t143 + s1 * t145;
  Lambda_inv[15] = -Lambda_inv_2_3;
  Lambda_inv[20] = -Lambda_inv_2_3;
  const Real Lambda_inv_2_4 = c1 * t145 - s1 * t143;
  Lambda_inv[16] = Lambda_inv_2_4;
  Lambda_inv[26] = Lambda_inv_2_4;
  const Real t157 = s1 * (t147 - t150) - t113 * t148;

  // link 1 (link1), mass matrix and turn
  Lambda_inv[14] = t111 * t20 + t112 * t110 + t120 * t115 -
      (t91 * (t136 + t143) + t97 * (t137 + t145));
  Lambda_inv[21] = t126 - t156;
  const Real Lambda_inv_3_4 = c1 * t149 + t128;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;

  // link 1 (link1), turn
  const Real Lambda_inv_3_5 = c1 * t127 + s1 * t125;
  Lambda_inv[23] = -Lambda_inv_3_5;
  Lambda_inv[33] = -Lambda_inv_3_5;
  Lambda_inv[28] = t124 + t156;
  const Real Lambda_inv_4_5 = c1 * t125 - s1 * t127;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
  const Real t158 = s1 * t157;
  Lambda_inv[0] = t147 - t158;
  const Real Lambda_inv_0_1 = c1 * t157 + t148;
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;
  Lambda_inv[7] = t150 + t158;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
