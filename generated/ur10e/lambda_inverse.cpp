// SPDX-License-Identifier: 0BSD
// lambda_inverse: Lambda^-1 = J M^-1 J^T
// By M = L^T D L, J carried inward, in the axes of link 4 (wrist_1) at link origins.
// 541 flops (add 234, mul 303, div 4), sine and cosine of 5 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void lambda_inverse(const Real (&TREELINE_RESTRICT q)[6],
    Real (&TREELINE_RESTRICT Lambda_inv)[36]) noexcept {
  // constants
  const Real h_5_y = 0.09132825;
  const Real minus_J_5_yz = 0.0106962107625;
  const Real minus_h_4_y = 0.33495075;
  const Real J_6_zz = 0.000623;
  const Real minus_link3_to_4_x = 0.57155;
  const Real minus_link2_to_3_x = 0.6127;
  const Real J_3_zz = 2.08330527531;
  const Real minus_h_3_x = 4.0059802;
  const Real link4_to_5_z = 0.17415;
  const Real J_4_yz = 0.0585962731125;
  const Real J_2_zz = 4.3866871861500005;
  const Real J_3_xz = 0.5656542411875001;
  const Real J_2_xz = 1.156008191975;
  const Real J_5_yy = 0.00124;
  const Real link6_to_tool_z = 0.11655;
  const Real link5_to_6_z = 0.11985;

  // sines and cosines
  const Real angles[5] = {q[1], q[2], q[3], q[4], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real s2 = sines[0];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];
  const Real s1 = sines[4];
  const Real c1 = cosines[4];

  // link 5 (wrist_2), composite inertia; link 1 (shoulder), mass matrix
  const Real t1 = 0.0054190910375000005 * s5;
  const Real t2 = h_5_y * s5;
  const Real t3 = c5 * c5;
  const Real t4 = h_5_y * c5;
  const Real t5 = minus_J_5_yz * c5;
  const Real t6 = 1.2551157591996094 * c5;
  const Real t7 = minus_link2_to_3_x * s2;
  const Real t8 = minus_link2_to_3_x * c2;
  const Real c23 = c2 * c3 - s2 * s3;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real t9 = s5 * t1;
  const Real t10 = J_6_zz * t3;
  const Real t11 = 1.0 - t3;
  const Real t12 = minus_link3_to_4_x * s23;
  const Real t13 = minus_link3_to_4_x * c23;
  const Real t14 = 0.0415928163875 + t9;
  const Real c234 = c23 * c4 - s23 * s4;
  const Real s234 = s23 * c4 + c23 * s4;
  const Real t15 = s234 * t2;

  // links 5 (wrist_2) and 6 (wrist_3), mass matrix; link 5 (wrist_2), composite inertia
  const Real t16 = s234 * t4;
  const Real t17 = c234 * t4;
  const Real t18 = s5 * s234;
  const Real t19 = c234 * s5;
  const Real t20 = minus_h_4_y * c234 + t15;
  const Real t21 = minus_h_4_y * s234 - c234 * t2;

  // links 1 (shoulder) and 6 (wrist_3), mass matrix; link 4 (wrist_1), composite inertia
  const Real t22 = 1.0 / (t14 - t10 - t6 * t5);
  const Real t23 = J_6_zz * t18;
  const Real t24 = t13 * t21;
  const Real t25 = t18 * c5;
  const Real t26 = c5 * t23;
  const Real t27 = t12 * t20 - t24;

  // links 3 (forearm) and 5 (wrist_2), composite inertia; links 1 (shoulder) and 5 (wrist_2), mass
  //   matrix
  const Real t28 = t8 * (t21 - minus_h_3_x * c23);
  const Real t29 = t13 * t16 - t12 * t17 - t5;
  const Real t30 = 1605.1364365971108 * c5;
  const Real t31 = s234 * c5 * t1 + link4_to_5_z * t15 + (J_4_yz + t5) * c234;
  const Real t32 = link6_to_tool_z * t18;
  const Real t33 = 0.0098370910375 + (6.9910934060975 - s2 * (4.36318718615 * s2) - s23 *
      (2.07831527531 * s23)) + 0.031809629475 * c5;
  const Real t34 = 117.34209310833121 * t29;
  const Real t35 = t29 + (t8 * t16 - t7 * t17);
  const Real t36 = t7 * (minus_h_3_x * s23 + t20) - t28;
  const Real t37 = minus_J_5_yz * t18 - 0.0085220910375 * c234 - link4_to_5_z * t17 - (t13 + t8) *
      t2;

  // link 1 (shoulder), mass matrix
  const Real t38 = t14 + t27 - t10;
  const Real t39 = t25 - t6 * c234;
  const Real t40 = 117.34209310833121 * t35;
  const Real t41 = t38 + t6 * t29;
  const Real t42 = 117.34209310833121 * t37;
  const Real t43 = J_3_xz * s23 + (t31 + t12 * t4) + t26;
  const Real t44 = t41 * t22;
  const Real t45 = t31 + t26 + t6 * t37;
  const Real t46 = J_3_zz + (t14 + 2.0 * t27) - t10;

  // link 6 (wrist_3), pose; link 1 (shoulder), mass matrix
  const Real t47 = link5_to_6_z * c234;
  const Real t48 = 1605.1364365971108 * t18;
  const Real t49 = t38 + t7 * t20 - t8 * t21 + t6 * t35;
  const Real t50 = t45 * t22;
  const Real t51 = 117.34209310833121 * c234;
  const Real t52 = t49 * t22;
  const Real t53 = (1.0 - t44) * t11;
  const Real t54 = t43 - t34 * t37 - t44 * t45;
  const Real t55 = t11 * t22;

  // link 4 (wrist_1), Jacobian; link 1 (shoulder), mass matrix
  const Real t56 = t47 + t12;
  const Real t57 = t46 + t36 - t34 * t35 - t44 * t49;
  const Real t58 = 1.0 / (t46 - t34 * t29 - t44 * t41);
  const Real t59 = c5 * t19;
  const Real t60 = t25 + t34 * c234 - t44 * t39;
  const Real t61 = t39 * t22;
  const Real t62 = J_2_xz * s2 + t43 + t7 * t4 - t40 * t37 - t52 * t45;
  const Real t63 = t59 + t6 * s234;

  // link 1 (shoulder), mass matrix; link 6 (wrist_3), pose
  const Real t64 = t56 - t44 * t47;
  const Real t65 = link5_to_6_z * s234;
  const Real t66 = t59 - t34 * s234 - t44 * t63;
  const Real t67 = t57 * t58;
  const Real t68 = t54 * t58;

  // link 1 (shoulder), mass matrix; link 4 (wrist_1), Jacobian
  const Real t69 = t63 * t22;
  const Real t70 = t53 * t58;
  const Real t71 = t60 * t58;
  const Real t72 = t66 * t58;
  const Real t73 = t65 - t13;

  // link 1 (shoulder), mass matrix
  const Real t74 = link6_to_tool_z * c5;
  const Real t75 = link6_to_tool_z * t19;
  const Real t76 = J_2_zz + t46 + 2.0 * t36 - t40 * t35 - t52 * t49 - t67 * t57;
  const Real t77 = t62 - t67 * t54;
  const Real t78 = t33 - t18 * t23 - t42 * t37 - t50 * t45 - t68 * t54;
  const Real t79 = (1.0 - t52) * t11 - t67 * t53;
  const Real t80 = t25 + t40 * c234 - t52 * t39 - t67 * t60;
  const Real t81 = t59 - t40 * s234 - t52 * t63 - t67 * t66;
  const Real t82 = 1.0 - t18 * t18 + t42 * c234 - t50 * t39 - t68 * t60;
  const Real t83 = t56 + t7 - t52 * t47 - t67 * t64;
  const Real t84 = 1.0 / t76;

  // link 3 (forearm), Jacobian; link 1 (shoulder), mass matrix and turn
  const Real t85 = t73 - t8;
  const Real t86 = 1605.1364365971108 * t19 * t19 + 117.34209310833121 * s234 * s234 + t69 * t63 +
      t72 * t66;
  const Real t87 = 2.0 * c1;
  const Real t88 = t73 - t44 * t65;
  const Real t89 = t65 * t22;

  // link 1 (shoulder), mass matrix
  const Real t90 = t88 * t58;
  const Real t91 = t77 * t84;
  const Real t92 = t79 * t84;
  const Real t93 = t80 * t84;
  const Real t94 = t81 * t84;
  const Real t95 = t85 - t52 * t65 - t67 * t88;
  const Real t96 = t25 - t50 * t11 - t68 * t53 - t91 * t79;
  const Real t97 = t82 - t91 * t80;
  const Real t98 = t18 * t19 + t42 * s234 + t50 * t63 + t68 * t66 + t91 * t81;
  const Real t99 = t48 * t18 + t51 * c234 + t61 * t39 + t71 * t60 + t93 * t80;
  const Real t100 = t48 * t19 - t51 * s234 + t61 * t63 + t71 * t66 + t93 * t81;
  const Real t101 = link4_to_5_z - t50 * t47 - t68 * t64 - t91 * t83;
  const Real t102 = t50 * t65 + t68 * t88 + t91 * t95;
  const Real t103 = t95 * t84;
  const Real t104 = t78 - t91 * t77 - 2.0 * (t24 + t28) +
      (0.037099816387500005 * s234 - (s234 * (J_5_yy + t9) + 0.021392421525 * t19)) * s234;
  const Real t105 = t47 * t22 * t47 + t64 * t58 * t64 + t83 * t84 * t83;
  const Real t106 = 1.0 / t104;
  const Real t107 = t96 * t106;
  const Real t108 = t97 * t106;
  const Real t109 = t98 * t106;
  const Real t110 = t85 * t106;
  const Real t111 = t102 * t106;
  const Real t112 = t108 * t85;
  const Real t113 = t109 * t85;
  const Real t114 = t107 * t85;
  const Real t115 = t30 * c5 + t55 * t11 + t70 * t53 + t92 * t79 + t107 * t96;
  const Real t116 = t55 * t39 - t30 * t18 + t70 * t60 + t92 * t80 + t107 * t97;
  const Real Lambda_inv_5_5 = t99 + t108 * t97;
  Lambda_inv[35] = Lambda_inv_5_5;
  const Real t117 = t100 - t108 * t98;
  const Real t118 = t86 + t94 * t81 + t109 * t98;
  const Real t119 = t55 * t63 - t30 * t19 + t70 * t66 + t92 * t81 - t107 * t98;
  const Real t120 = t55 * t47 + t70 * t64 + t92 * t83 + t107 * t101;
  const Real t121 = t61 * t47 + t71 * t64 + t93 * t83 + t108 * t101;
  const Real t122 = t119 * t32;
  const Real t123 = t117 * t74;
  const Real t124 = t116 * t75;
  const Real t125 = t61 * t65 + t71 * t88 + t93 * t95 - t108 * t102;
  const Real t126 = t69 * t65 + t72 * t88 + t94 * t95 + t109 * t102;
  const Real t127 = t55 * t65 + t70 * t88 + t92 * t95 - t107 * t102;
  const Real t128 = t120 + (t115 * t32 + t116 * t74);
  const Real t129 = t121 + (t116 * t32 + Lambda_inv_5_5 * t74);
  const Real t130 = t112 + (t117 * t32 - Lambda_inv_5_5 * t75);
  const Real t131 = t113 - (t118 * t32 - t117 * t75);
  const Real t132 = t69 * t47 + t72 * t64 + t94 * t83 - t109 * t101 + (t122 + t123);
  const Real t133 = t126 - (t118 * t74 + t119 * t75);
  const Real Lambda_inv_2_5 = t125 - (t123 + t124);
  Lambda_inv[17] = Lambda_inv_2_5;
  Lambda_inv[32] = Lambda_inv_2_5;
  const Real t134 = t114 + (t122 - t124);
  const Real t135 = t89 * t47 + t90 * t64 + t103 * t83 - t111 * t101 - t75 * t128;
  const Real t136 = t127 - (t119 * t74 + t115 * t75);
  const Real t137 = t110 * t101 + t74 * t112 - t75 * t129 + (t114 + t132) * t32;
  const Real t138 = t105 + t101 * t106 * t101 + (t32 * (t120 + t128) + t74 * (t121 + t129));
  const Real t139 = t110 * t85 - (t75 * (t112 + t130) + t32 * (t113 + t131));
  const Real t140 = t135 + t32 * t127 + (t125 - t132) * t74;
  const Real t141 = t110 * t102 - t74 * t113 - t32 * t133 + (t114 + Lambda_inv_2_5) * t75;

  // link 1 (shoulder), turn
  const Real t142 = s1 * (t118 - t115) - t87 * t119;
  const Real t143 = s1 * (t132 + t134) - c1 * (t131 + t128);
  const Real t144 = s1 * t143;
  const Real t145 = c1 * t143;
  const Real t146 = s1 * t142;
  const Real Lambda_inv_0_2 = c1 * t140 + s1 * t141;
  Lambda_inv[2] = Lambda_inv_0_2;
  Lambda_inv[12] = Lambda_inv_0_2;
  const Real Lambda_inv_0_3 = t132 - t144;
  Lambda_inv[3] = Lambda_inv_0_3;
  Lambda_inv[18] = Lambda_inv_0_3;
  const Real Lambda_inv_0_4 = t145 + t131;
  Lambda_inv[4] = Lambda_inv_0_4;
  Lambda_inv[24] = Lambda_inv_0_4;
  const Real Lambda_inv_0_5 = c1 * t129 - s1 * t130;
  Lambda_inv[5] = Lambda_inv_0_5;
  Lambda_inv[30] = Lambda_inv_0_5;
  const Real Lambda_inv_1_2 = s1 * t140 - c1 * t141;
  Lambda_inv[8] = Lambda_inv_1_2;
  Lambda_inv[13] = Lambda_inv_1_2;
  const Real Lambda_inv_1_3 = t145 + t128;
  Lambda_inv[9] = Lambda_inv_1_3;
  Lambda_inv[19] = Lambda_inv_1_3;
  const Real Lambda_inv_1_4 = t144 - t134;
  Lambda_inv[10] = Lambda_inv_1_4;
  Lambda_inv[25] = Lambda_inv_1_4;
  const Real Lambda_inv_1_5 = s1 * t129 + c1 * t130;
  Lambda_inv[11] = Lambda_inv_1_5;
  Lambda_inv[31] = Lambda_inv_1_5;
  const Real t147 = s1 * (t138 - t139) + t87 * t137;

  // link 1 (shoulder), mass matrix and turn
  Lambda_inv[14] = t89 * t65 + t90 * t88 + t103 * t95 + t111 * t102 -
      (t74 * (t126 + t133) + t75 * (t127 + t136));
  const Real Lambda_inv_2_3 = c1 * t133 + s1 * t136;
  Lambda_inv[15] = Lambda_inv_2_3;
  Lambda_inv[20] = Lambda_inv_2_3;
  const Real Lambda_inv_2_4 = s1 * t133 - c1 * t136;

  // link 1 (shoulder), turn
  Lambda_inv[16] = Lambda_inv_2_4;
  Lambda_inv[26] = Lambda_inv_2_4;
  Lambda_inv[21] = t118 - t146;
  const Real Lambda_inv_3_4 = c1 * t142 + t119;
  Lambda_inv[22] = Lambda_inv_3_4;
  Lambda_inv[27] = Lambda_inv_3_4;
  const Real Lambda_inv_3_5 = c1 * t117 + s1 * t116;
  Lambda_inv[23] = Lambda_inv_3_5;
  Lambda_inv[33] = Lambda_inv_3_5;
  Lambda_inv[28] = t115 + t146;
  const Real Lambda_inv_4_5 = s1 * t117 - c1 * t116;
  Lambda_inv[29] = Lambda_inv_4_5;
  Lambda_inv[34] = Lambda_inv_4_5;
  const Real t148 = s1 * t147;
  Lambda_inv[0] = t138 - t148;
  const Real Lambda_inv_0_1 = c1 * t147 - t137;
  Lambda_inv[1] = Lambda_inv_0_1;
  Lambda_inv[6] = Lambda_inv_0_1;
  Lambda_inv[7] = t139 + t148;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
