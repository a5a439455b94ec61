// SPDX-License-Identifier: 0BSD
// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J carried inward, in the axes of link 2 (link2) at link origins.
// 559 flops (add 233, mul 322, div 4), sine and cosine of 5 angles
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

  // link 3 (link3), composite inertia; links 1, 5 and 6, mass matrix
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

  // link 1 (link1), mass matrix
  const Real t46 = J_3_zz + (0.0012921599999999999 - t28 - 2.0 * (t26 + t21 * t22)) - t18 * t13;
  const Real t47 = t43 * t27;
  const Real t48 = 24999.999999999996 * t39;
  const Real t49 = t44 + t18 * t39;
  const Real t50 = s23 * t30 - minus_c23 * t14 - link2_to_3_z * t15 + c5 * t39 + t35 * t8;
  const Real t51 = 1557.24430048586 * t45;
  const Real t52 = t50 * t27;
  const Real t53 = 1.0 / (t46 - t37 * t33 - t41 * t36);
  const Real t54 = t46 - t40 - t37 * t38 - t41 * t43;
  const Real t55 = t49 - t37 * t45 - t41 * t50;

  // link 5 (link5), pose; link 1 (link1), mass matrix
  const Real t56 = s5 * s4;
  const Real t57 = s5 * t29 + c5 * minus_c23;
  const Real t58 = minus_J_2_xz * s2 + minus_J_2_yz * c2 + t49 + t7 * t9 - t42 * t45;
  const Real t59 = t18 * t57;
  const Real t60 = c5 * t56;
  const Real t61 = 3.153482265 - s2 * (1.601861202 * s2 + 0.0141984 * c2) + t14 - t48 * t39;
  const Real t62 = c5 * t57 - minus_c23;
  const Real t63 = 24999.999999999996 * t56;
  const Real t64 = 1.0 - t18 * t56;
  const Real t65 = 0.298925024 * s23 + 0.021347276999999998 * minus_c23 -
      (minus_c23 * (2.0 * t30) - s23 * (0.0011921599999999998 - t11 + t28 - t14));

  // link 4 (link4), pose; link 1 (link1), mass matrix
  const Real t66 = s4 * minus_c23;
  const Real t67 = t54 * t53;
  const Real t68 = t55 * t53;
  const Real t69 = 1557.24430048586 * c4;
  const Real t70 = 24999.999999999996 * t57;
  const Real t71 = t64 - t37 * c4 + t41 * t60;

  // link 1 (link1), mass matrix; link 5 (link5), pose
  const Real t72 = t59 - t37 * t31 - t41 * t62;
  const Real t73 = 1557.24430048586 * t31;
  const Real t74 = t60 * t27;
  const Real t75 = t62 * t27;
  const Real t76 = c5 * s23 - s5 * (c4 * minus_c23);

  // link 1 (link1), mass matrix
  const Real t77 = J_2_zz + t46 - 2.0 * t40 - t42 * t38 - t47 * t43 - t67 * t54;
  const Real t78 = t58 - t47 * t50 - t67 * t55;
  const Real t79 = t64 - t42 * c4 + t47 * t60 - t67 * t71;
  const Real t80 = t59 - t42 * t31 - t47 * t62 - t67 * t72;
  const Real t81 = t18 * t76;
  const Real t82 = 1.0 / t77;
  const Real t83 = t71 * t53;
  const Real t84 = 1.0 - t48 * t57 - t51 * t31 - t52 * t62 - t68 * t72;
  const Real t85 = t72 * t53;
  const Real t86 = c5 * t76 - s23;
  const Real t87 = t7 + (t67 - 1.0) * t21;
  const Real t88 = t81 + t37 * t66 - t41 * t86;
  const Real t89 = link6_to_tool_z * t57;
  const Real t90 = link6_to_tool_z * t56;
  const Real t91 = t78 * t82;
  const Real t92 = t88 * t53;
  const Real t93 = t79 * t82;
  const Real t94 = t80 * t82;
  const Real t95 = 24999.999999999996 * t76 * t76 + 1557.24430048586 * t66 * t66 + t86 * t27 * t86;
  const Real t96 = link6_to_tool_z * t76;
  const Real t97 = t81 + t42 * t66 - t47 * t86 - t67 * t88;
  const Real t98 = t97 * t82;
  const Real t99 = t61 - t51 * t45 - t52 * t50 - t68 * t55 - t91 * t78;
  const Real t100 = t48 * t56 - t51 * c4 + t52 * t60 - t68 * t71 - t91 * t79;
  const Real t101 = t84 - t91 * t80;
  const Real t102 = t63 * t56 + t69 * c4 + t74 * t60 + t83 * t71 + t93 * t79;
  const Real t103 = t69 * t31 - t63 * t57 - t74 * t62 + t83 * t72 + t93 * t80;
  const Real t104 = t70 * t57 + t73 * t31 + t75 * t62 + t85 * t72 + t94 * t80;
  const Real t105 = link2_to_3_z + t68 * t21 - t91 * t87;
  const Real t106 = t51 * t66 - t48 * t76 - t52 * t86 - t68 * t88 - t91 * t97;
  const Real t107 = t70 * t76 - t73 * t66 + t75 * t86 + t85 * t88 + t94 * t97;
  const Real t108 = t83 * t88 - (t63 * t76 + t69 * t66 + t74 * t86) + t93 * t97;
  const Real t109 = t67 * t19 - t35;
  const Real t110 = t19 * t53;
  const Real t111 = t109 * t82;

  // link 1 (link1), turn and mass matrix
  const Real t112 = 2.0 * c1;
  const Real t113 = 1.0 / (t99 + 2.0 * (link2_to_3_z * t9 - t34 - t26) + t65 * s23);
  const Real t114 = t68 * t19 - t91 * t109;
  const Real t115 = t100 * t113;
  const Real t116 = t101 * t113;

  // link 1 (link1), mass matrix
  const Real t117 = t106 * t113;
  const Real t118 = t35 * t113;
  const Real t119 = t114 * t113;
  const Real t120 = t117 * t35;
  const Real t121 = t116 * t35;
  const Real t122 = t115 * t35;
  const Real t123 = t102 + t115 * t100;
  const Real t124 = t103 + t115 * t101;
  const Real Lambda_inv_5_5 = t104 + t116 * t101;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real t125 = t95 + t92 * t88 + t98 * t97 + t117 * t106;
  const Real t126 = t107 + t116 * t106;
  const Real t127 = t108 + t115 * t106;
  const Real t128 = t93 * t87 - t83 * t21 + t115 * t105;
  const Real t129 = t94 * t87 - t85 * t21 + t116 * t105;
  const Real t130 = t127 * t89;
  const Real t131 = t126 * t90;
  const Real t132 = t124 * t96;
  const Real t133 = t21 * t53 * t21 + t87 * t82 * t87 + t105 * t113 * t105;
  const Real t134 = t94 * t109 - t85 * t19 + t116 * t114;
  const Real t135 = t98 * t109 - t92 * t19 + t117 * t114;
  const Real t136 = t93 * t109 - t83 * t19 + t115 * t114;
  const Real t137 = t128 + (t123 * t89 + t124 * t90);
  const Real t138 = t129 + (t124 * t89 + Lambda_inv_5_5 * t90);
  const Real t139 = t120 - (t125 * t89 - t126 * t96);
  const Real t140 = t121 - (t126 * t89 - Lambda_inv_5_5 * t96);
  const Real t141 = t98 * t87 - t92 * t21 + t117 * t105 + (t130 + t131);
  const Real t142 = t135 - (t125 * t90 + t127 * t96);
  const Real Lambda_inv_2_5 = t134 - (t131 + t132);
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;
  const Real t143 = t122 - (t130 - t132);
  const Real t144 = t136 - (t127 * t90 + t123 * t96);
  const Real t145 = t110 * t21 + t111 * t87 + t119 * t105 - t96 * t137 + t89 * t136;
  const Real t146 = t133 + (t89 * (t128 + t137) + t90 * (t129 + t138));
  const Real t147 = t118 * t105 + t96 * t138 + t90 * t121 + (t122 - t141) * t89;

  // link 1 (link1), turn and mass matrix
  const Real t148 = s1 * (t125 - t123) - t112 * t127;
  const Real t149 = t118 * t35 - (t89 * (t120 + t139) - t96 * (t121 + t140));
  const Real t150 = t145 + (t134 - t141) * t90;
  const Real t151 = t118 * t114 - t90 * t120 - t89 * t142 + (Lambda_inv_2_5 - t122) * t96;
  const Real t152 = s1 * (t141 - t143) - c1 * (t139 + t137);

  // link 1 (link1), turn
  const Real t153 = s1 * t152;
  const Real t154 = c1 * t152;
  const Real t155 = s1 * t148;
  const Real Lambda_inv_0_2 = c1 * t150 + s1 * t151;
  Lambda_inv[2] = -Lambda_inv_0_2;
  Lambda_inv[12] = -Lambda_inv_0_2;
  const Real Lambda_inv_0_5 = c1 * t138 + s1 * t140;
  Lambda_inv[5] = -Lambda_inv_0_5;
  Lambda_inv[30] = -Lambda_inv_0_5;
  const Real Lambda_inv_0_3 = t141 - t153;
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;
  const Real Lambda_inv_0_4 = t154 + t139;
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[24] = Lambda_inv_0_4;
  const Real Lambda_inv_1_2 = c1 * t151 - s1 * t150;
  Lambda_inv[8] = Lambda_inv_1_2;
  Lambda_inv[13] = Lambda_inv_1_2;
  const Real Lambda_inv_1_3 = t154 + t137;
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  const Real Lambda_inv_1_4 = t143 + t153;
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_1_5 = c1 * t140 - s1 * t138;
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real Lambda_inv_2_3 = c1 * t142 + s1 * t144;
  Lambda_inv[15] = -Lambda_inv_2_3;
  Lambda_inv[20] = -Lambda_inv_2_3;
  const Real Lambda_inv_2_4 = c1 * t144 - s1 * t142;
  Lambda_inv[16] = Lambda_inv_2_4;
  Lambda_inv[26] = Lambda_inv_2_4;
  const Real t156 = s1 * (t146 - t149) - t112 * t147;

  // link 1 (link1), mass matrix and turn
  Lambda_inv[14] = t110 * t19 + t111 * t109 + t119 * t114 -
      (t90 * (t135 + t142) + t96 * (t136 + t144));
  Lambda_inv[21] = t125 - t155;
  const Real Lambda_inv_3_4 = c1 * t148 + t127;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;

  // link 1 (link1), turn
  const Real Lambda_inv_3_5 = c1 * t126 + s1 * t124;
  Lambda_inv[23] = -Lambda_inv_3_5;
  Lambda_inv[33] = -Lambda_inv_3_5;
  Lambda_inv[28] = t123 + t155;
  const Real Lambda_inv_4_5 = c1 * t124 - s1 * t126;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
  const Real t157 = s1 * t156;
  Lambda_inv[0] = t146 - t157;
  const Real Lambda_inv_0_1 = c1 * t156 + t147;
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;
  Lambda_inv[7] = t149 + t157;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
