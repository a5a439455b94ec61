// SPDX-License-Identifier: 0BSD
// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J
//   qdd_0)
// By Chang table 6.1, fused; Lambda^-1: M = L^T D L, J carried inward, in the axes of link 5
//   (wrist_2) at link origins.
// 835 flops (add 352, mul 474, div 9), sine and cosine of 5 angles
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
void control_torque(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT qdd_0)[6], const Real (&TREELINE_RESTRICT xdd_cmd)[6],
    Real (&TREELINE_RESTRICT tau)[6]) noexcept {
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
  const Real link5_to_6_z = 0.11985;
  const Real J_3_yy = 2.08081027531;
  const Real J_4_yy = 0.001315;
  const Real J_5_yy = 0.00124;
  const Real minus_gravity_z = 9.81;
  const Real link6_to_tool_z = 0.11655;
  const Real J_5_zz = 0.008210591037500001;
  const Real J_5_xx = 0.0069705910375000004;
  const Real J_4_zz = 0.0397298163875;

  // sines and cosines
  const Real angles[5] = {q[1], q[2], q[3], q[4], q[0]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];
  const Real c1 = cosines[4];
  const Real s1 = sines[4];

  // link 5 (wrist_2), composite inertia; link 1 (shoulder), mass matrix
  const Real t1 = 0.0054190910375000005 * s5;
  const Real t2 = h_5_y * s5;
  const Real t3 = h_5_y * c5;
  const Real t4 = minus_J_5_yz * c5;
  const Real t5 = 1.2551157591996094 * c5;
  const Real t6 = minus_link2_to_3_x * s2;
  const Real t7 = minus_link2_to_3_x * c2;
  const Real t8 = J_2_xz * s2;
  const Real c23 = c2 * c3 - s2 * s3;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real t9 = s5 * t1;
  const Real t10 = c5 * (J_6_zz * c5);

  // link 5 (wrist_2), composite inertia
  const Real t11 = minus_link3_to_4_x * s23;
  const Real t12 = minus_link3_to_4_x * c23;
  const Real t13 = minus_h_3_x * s23;
  const Real t14 = minus_h_3_x * c23;
  const Real t15 = 0.0415928163875 + t9;
  const Real t16 = J_3_xz * s23;
  const Real c234 = c23 * c4 - s23 * s4;
  const Real s234 = s23 * c4 + c23 * s4;
  const Real t17 = minus_h_4_y * c234;
  const Real t18 = s234 * t2;
  const Real t19 = minus_h_4_y * s234;

  // link 5 (wrist_2), mass matrix and pose
  const Real t20 = s234 * t3;
  const Real t21 = c234 * t3;
  const Real t22 = s234 * c5;
  const Real t23 = s234 * s5;
  const Real t24 = J_4_yz * c234;
  const Real t25 = c234 * s5;

  // link 5 (wrist_2), Jacobian and composite inertia; link 1 (shoulder), mass matrix
  const Real t26 = link5_to_6_z * c234;
  const Real t27 = link5_to_6_z * s234;
  const Real t28 = t17 + t18;
  const Real t29 = t19 - c234 * t2;
  const Real t30 = 1.0 / (t15 - t10 - t5 * t4);

  // links 1 (shoulder) and 6 (wrist_3), mass matrix; link 4 (wrist_1), composite inertia; link 5
  //   (wrist_2), pose
  const Real t31 = J_6_zz * t23;
  const Real t32 = t12 * t29;
  const Real t33 = c234 * c5;
  const Real t34 = c5 * t31;
  const Real t35 = t11 * t28 - t32;

  // link 3 (forearm), composite inertia; link 5 (wrist_2), mass matrix; link 4 (wrist_1), Jacobian
  const Real t36 = t7 * (t29 - t14);
  const Real t37 = t12 * t20 - t11 * t21 - t4;
  const Real t38 = t26 + t11;
  const Real t39 = t27 - t12;
  const Real t40 = t26 * s234 - t27 * c234;

  // links 1 (shoulder) and 5 (wrist_2), mass matrix; links 3 (forearm) and 5 (wrist_2), composite
  //   inertia
  const Real t41 = 117.34209310833121 * t37;
  const Real t42 = t37 + (t7 * t20 - t6 * t21);
  const Real t43 = t6 * (t13 + t28) - t36;
  const Real t44 = t24 + (t22 * t1 + c234 * t4 + link4_to_5_z * t18);
  const Real t45 = minus_J_5_yz * t23 - 0.0085220910375 * c234 - link4_to_5_z * t21 - (t12 + t7) *
      t2;

  // link 1 (shoulder), mass matrix; link 4 (wrist_1), Jacobian
  const Real t46 = t15 + t35 - t10;
  const Real t47 = t27 * t23 + t26 * t25;
  const Real t48 = 117.34209310833121 * t42;
  const Real t49 = 0.037099816387500005 * s234;
  const Real t50 = 2.07831527531 * s23;
  const Real t51 = t46 + t5 * t37;
  const Real t52 = 4.36318718615 * s2;
  const Real t53 = t51 * t30;
  const Real t54 = J_3_zz + (t15 + 2.0 * t35) - t10;
  const Real t55 = t44 + t34 + t5 * t45;
  const Real t56 = 117.34209310833121 * t45;
  const Real t57 = t46 + t6 * t28 - t7 * t29 + t5 * t42;
  const Real t58 = t27 * t22 + t26 * t33;

  // link 1 (shoulder), mass matrix; link 3 (forearm), Jacobian
  const Real t59 = t16 + (t44 + t11 * t3) + t34;
  const Real t60 = t57 * t30;
  const Real t61 = t55 * t30;
  const Real t62 = t38 + t6;
  const Real t63 = t39 - t7;

  // link 1 (shoulder), mass matrix
  const Real t64 = t54 + t43 - t41 * t42 - t53 * t57;
  const Real t65 = 1.0 / (t54 - t41 * t37 - t53 * t51);
  const Real t66 = 4.910283130787501 - s2 * t52 + (J_3_yy - s23 * t50) + (J_4_yy + s234 * t49);
  const Real t67 = t59 - t41 * t45 - t53 * t55;
  const Real t68 = (1.0 - t53) * s5;
  const Real t69 = t41 + t53 * t5;
  const Real t70 = t38 * s234 - t39 * c234 - t53 * t40;
  const Real t71 = t53 * t47 - (t39 * t23 + t38 * t25);
  const Real t72 = t39 * t22 + t38 * t33 - t53 * t58;
  const Real t73 = 0.0085220910375 + t66 - s234 * (s234 * (J_5_yy + t9) + 0.021392421525 * t25) +
      0.031809629475 * c5;
  const Real t74 = t64 * t65;
  const Real t75 = t67 * t65;
  const Real t76 = t69 * t65;
  const Real t77 = t5 * t30;
  const Lanes<8> t78_lanes = detail::make_pack<Real>(t72, t72, t70, t68, t72, t72, t72, t72) * t65;
  const Lanes<8> t79_lanes = detail::make_pack<Real>(t58, t58, t40, s5, t58, t58, t58, t58) * t30;
  const Real t80 = t71 * t65;
  const Real t81 = t47 * t30;
  const Real t82 = J_2_zz + t54 + 2.0 * t43 - t48 * t42 - t60 * t57 - t74 * t64;
  const Real t83 = t8 + t59 + t6 * t3 - t48 * t45 - t60 * t55 - t74 * t67;
  const Real t84 = t73 - t23 * t31 - t56 * t45 - t61 * t55 - t75 * t67;
  const Real t85 = t74 * t69 - (t48 + t60 * t5);
  const Real t86 = (1.0 - t60) * s5 - t74 * t68;
  const Real t87 = t62 * s234 - t63 * c234 - t60 * t40 - t74 * t70;
  const Real t88 = t60 * t47 - (t63 * t23 + t62 * t25) - t74 * t71;
  const Real t89 = t63 * t22 + t62 * t33 - t60 * t58 - t74 * t72;
  const Real t90 = 1.0 / t82;
  const Lanes<8> t93_lanes = t79_lanes * t58 + t78_lanes * t72;

  // links 1 to 3, outward
  const Real w3_z = qd[1] + qd[2];
  const Real t94 = qd[0] * qd[0];
  const Real t95 = qd[1] * qd[1];
  const Real t96 = w3_z * w3_z;
  const Real wd3_z = qdd_0[1] + qdd_0[2];
  const Real t97 = 2.0 * qd[0];

  // link 1 (shoulder), mass matrix; links 2 (upper_arm) and 3 (forearm), outward
  const Real t98 = t83 * t90;
  const Lanes<8> t99_lanes = detail::make_pack<Real>(t89, t88, t87, t86, t89, t85, t89, t89) * t90;
  const Real t100 = t94 + t96;
  const Real t101 = t97 * w3_z;
  const Real t102 = t97 * qd[1];

  // links 3 to 6, outward
  const Real t103 = minus_gravity_z + xdd_cmd[2];
  const Real w4_z = w3_z + qd[3];
  const Real t108 = s234 * qd[0];
  const Real a3_x = (t94 + t95) * t7 + qdd_0[1] * t6;
  const Real a3_y = minus_gravity_z + (t95 * t6 - qdd_0[1] * t7);

  // link 1 (shoulder), mass matrix; links 4 (wrist_1) and 6 (wrist_3), outward
  const Lanes<8> t109_lanes = detail::make_pack<Real>(link4_to_5_z * t33 - t63 * s5 - t61 * t58 -
      t75 * t72, t61 * t47 - (t63 * c5 + link4_to_5_z * t25) - t75 * t71, link4_to_5_z * s234 -
      t61 * t40 - t75 * t70, t22 - t61 * s5 - t75 * t68, link4_to_5_z * t33 - t63 * s5 - t61 * t58 -
      t75 * t72, t75 * t69 - (c234 + t56 + t61 * t5), link4_to_5_z * t33 - t63 * s5 - t61 * t58 -
      t75 * t72, link4_to_5_z * t33 - t63 * s5 - t61 * t58 - t75 * t72) - t98 *
      detail::make_pack<Real>(t89, t88, t87, t86, t89, t85, t89, t89);
  const Lanes<8> t111_lanes = detail::make_pack<Real>(t81 * t47 + t80 * t71, t81 * t47 + t80 * t71,
      t78_lanes[2] * t71 - t79_lanes[2] * t47, t78_lanes[3] * t71 - t79_lanes[3] * t47, t81 * t47 +
      t80 * t71, t81 * t47 + t80 * t71, t81 * t47 + t80 * t71, t81 * t47 + t80 * t71) + t99_lanes *
      t88;
  const Real wd4_x = qd[0] * w4_z;
  const Real a4_x = a3_x + (t100 * t12 + wd3_z * t11);
  const Real a4_y = a3_y + (t96 * t11 - wd3_z * t12);
  const Real t113 = c1 * xdd_cmd[0] + s1 * xdd_cmd[1];
  const Real wd4_z = wd3_z + qdd_0[3];

  // links 3 to 5, outward; link 1 (shoulder), mass matrix
  const Real a3_z = qdd_0[0] * t7 - t102 * t6;
  const Real t114 = 1.0 / (t84 - t98 * t83 - 2.0 * (t32 + t36));
  const Real t115 = a4_x + link4_to_5_z * qdd_0[0];
  const Real w5_x = c5 * t108 + s5 * w4_z;
  const Real w5_y = c5 * w4_z - s5 * t108;
  const Real a4_z = a3_z + (qdd_0[0] * t12 - t101 * t11);

  // links 5 (wrist_2) and 6 (wrist_3), outward
  const Real t116 = c1 * xdd_cmd[1] - s1 * xdd_cmd[0];
  const Real t117 = c234 * wd4_x + s234 * qdd_0[0];
  const Real w5_z = qd[4] - c234 * qd[0];
  const Real t118 = w5_x * w5_y;
  const Real w6_z = w5_y + qd[5];
  const Real t119 = c1 * xdd_cmd[3] + s1 * xdd_cmd[4];
  const Real t120 = a4_z - link4_to_5_z * t94;
  const Real t121 = c234 * t113 + s234 * t103;
  const Real wd5_z = qdd_0[4] - (c234 * qdd_0[0] - s234 * wd4_x);
  const Real t122 = w5_x * w5_z;
  const Real t123 = w5_x * w6_z;
  const Real t124 = c234 * t115 + s234 * a4_y;
  const Real t125 = w5_y * w5_z;
  const Real t126 = w5_x * w5_x;
  const Real t127 = t118 - wd5_z;
  const Real t128 = w5_z * w5_z;
  const Real wd6_y = t123 - t127;

  // link 1 (shoulder), mass matrix; links 5 (wrist_2) and 6 (wrist_3), outward
  const Lanes<8> t129_lanes = t109_lanes * t114;
  const Real wd5_y = c5 * wd4_z - s5 * t117 - w5_x * qd[4];
  const Real wd5_x = c5 * t117 + s5 * wd4_z + w5_y * qd[4];
  const Real t130 = t126 + t128;
  const Real a5_x = c5 * t124 + s5 * t120;
  const Real t131 = c234 * xdd_cmd[5] - s234 * t119 + wd6_y;
  const Real t132 = t122 + wd5_y;
  const Real t136 = c234 * t119 + s234 * xdd_cmd[5];
  const Real t137 = c1 * xdd_cmd[4] - s1 * xdd_cmd[3];
  const Real t138 = w5_y * w5_y;
  const Real t139 = w5_z * w6_z;
  const Lanes<8> t140_lanes = detail::make_pack<Real>(t93_lanes[0], t80 * t72 - t81 * t58,
      t93_lanes[2], t93_lanes[3], t93_lanes[0], t77 * t58 - t76 * t72, t93_lanes[0], t93_lanes[0]) +
      t99_lanes * t89 + t129_lanes * t109_lanes[0];
  const Real t143 = t140_lanes[0] * t140_lanes[0];
  const Real t144 = t125 + wd5_x;
  const Real t145 = 117.34209310833121 + t77 * t5 + t76 * t69 + t99_lanes[5] * t85 + t129_lanes[5] *
      t109_lanes[5];
  const Real t146 = c5 * t121 - s5 * t116 - a5_x - link5_to_6_z * t132 - link6_to_tool_z *
      (t127 + t131);
  const Real wd6_x = t139 - t144;
  const Real t147 = t143 * t140_lanes[0];
  const Real minus_a5_z = c234 * a4_y - s234 * t115;
  const Real t148 = c5 * t136 - s5 * t137 + wd6_x;

  // link 1 (shoulder), mass matrix; link 4 (wrist_1), outward
  const Real t149 = c2 * t52;
  const Real t150 = c23 * t50;
  const Real t151 = c234 * t49;
  const Real t152 = t147 * t143 / (4.81482486096809e-35 + t147 * t147);
  const Real t153 = 2.0 * wd4_x;

  // link 2 (upper_arm), inward; link 1 (shoulder), mass matrix; link 6 (wrist_3), outward
  const Real t154 = qdd_0[1] * t8 - t102 * t149 + J_2_xz * t95 * c2 + wd3_z * t16;
  const Lanes<8> t155_lanes = t140_lanes * t152;
  const Real wd6_z = wd5_y + qdd_0[5];
  const Real t158 = t154 - t101 * t150 + J_3_xz * t96 * c23 + t14 * a3_z + wd4_z * t24;
  const Lanes<8> t159_lanes = detail::make_pack<Real>(t111_lanes[1], t111_lanes[1], t111_lanes[2],
      t111_lanes[3], t111_lanes[1], t99_lanes[5] * t88 - (t77 * t47 + t76 * t71), t111_lanes[1],
      t111_lanes[1]) + t129_lanes * t109_lanes[1] - t155_lanes * t140_lanes[1];

  // link 1 (shoulder), mass matrix; link 4 (wrist_1), outward
  const Lanes<8> t160_lanes = detail::make_pack<Real>(t79_lanes[2] * t40 + t78_lanes[2] * t70,
      t79_lanes[2] * t40 + t78_lanes[2] * t70, t79_lanes[2] * t40 + t78_lanes[2] * t70,
      t79_lanes[3] * t40 + t78_lanes[3] * t70, t79_lanes[2] * t40 + t78_lanes[2] * t70, t77 * t40 -
      t76 * t70, t79_lanes[2] * t40 + t78_lanes[2] * t70, t79_lanes[2] * t40 + t78_lanes[2] * t70) +
      t99_lanes * t87 + t129_lanes * t109_lanes[2] - t155_lanes * t140_lanes[2];
  const Real t161 = t79_lanes[3] * s5 + t78_lanes[3] * t68 + t99_lanes[3] * t86 + t129_lanes[3] *
      t109_lanes[3] - t155_lanes[3] * t140_lanes[3];
  const Real t162 = t77 * s5 - t76 * t68 + t99_lanes[5] * t86 + t129_lanes[5] * t109_lanes[3] -
      t155_lanes[5] * t140_lanes[3];
  const Real t163 = t159_lanes[1] * t159_lanes[1];
  const Real t164 = link5_to_6_z * (t125 - wd5_x) - link6_to_tool_z * t130 + t155_lanes[1] * t146 +
      (t116 + t120) * c5;
  const Real t165 = w4_z * w4_z;
  const Real t166 = t163 * t159_lanes[1];

  // link 1 (shoulder), mass matrix; link 6 (wrist_3), inertial wrench
  const Real t167 = t164 + (t121 - t124) * s5;
  const Real n6_z = J_6_zz * wd6_z - J_6_zz * (s5 * t136 + c5 * t137 + wd6_z);
  tau[5] = n6_z;
  const Real t168 = t166 * t163 / (7.52316384526264e-37 + t166 * t166);
  const Lanes<8> t169_lanes = t159_lanes * t168;

  // links 3 (forearm) and 4 (wrist_1), inertial wrench; link 1 (shoulder), mass matrix
  const Real t170 = J_4_zz * wd4_z + qdd_0[0] * t24 - t94 * t151 + (t19 * a4_y + t17 * a4_x);
  const Lanes<8> t172_lanes = t160_lanes - t169_lanes * t159_lanes[2];
  const Real t173 = t172_lanes[2] * t172_lanes[2];
  const Real t174 = t173 * t172_lanes[2];
  const Real t175 = J_3_zz * wd3_z + qdd_0[0] * t16 + t94 * t150 + (t13 * a3_x - t14 * a3_y);

  // link 1 (shoulder), mass matrix
  const Real t176 = t169_lanes[2] * t167 - c234 * t103 + s234 * t113 + minus_a5_z + link5_to_6_z *
      (t126 + t138);
  const Real t177 = t176 - t155_lanes[2] * t146 - link6_to_tool_z * (t144 + t148);
  const Real t178 = t174 * t173 / (7.52316384526264e-37 + t174 * t174);
  const Real t179 = t172_lanes[3] * t178;
  const Real t180 = t172_lanes[5] * t178;
  const Real t181 = t161 - t169_lanes[3] * t159_lanes[3] - t179 * t172_lanes[3];
  const Real t182 = t162 - t169_lanes[5] * t159_lanes[3] - t180 * t172_lanes[3];
  const Real t183 = t148 - t155_lanes[3] * t146 + t169_lanes[3] * t167 - t179 * t177;
  const Real t184 = t181 * t181;
  const Real t185 = t184 * t181;
  const Real t186 = t185 * t184 / (8.077935669463161e-28 + t185 * t185);
  const Real t187 = t182 * t186;
  const Real t188 = t145 - t155_lanes[5] * t140_lanes[5] - t169_lanes[5] * t159_lanes[5] - t180 *
      t172_lanes[5] - t187 * t182;
  const Real t189 = t169_lanes[5] * t167 - (t131 + t155_lanes[5] * t146) - t180 * t177 - t187 *
      t183;
  const Real t190 = t188 * t188;
  const Real t191 = t190 * t188;
  const Real t192 = t189 * (t191 * t190 / (8.673617379884035e-19 + t191 * t191));

  // link 6 (wrist_3), inertial wrench; link 1 (shoulder), mass matrix; link 6 (wrist_3), inward
  const Real n6_y = 0.0003115 * (t123 + wd6_y) + t192;
  const Real t193 = t183 * t186 - t187 * t192;
  const Real n5_z = J_5_zz * wd5_z - 0.005730591037500001 * t118 - minus_J_5_yz * t132 - h_5_y *
      a5_x + n6_y;
  tau[4] = n5_z;
  const Real n6_x = 0.0003115 * (t139 + wd6_x) - t193;
  const Real f6_y = t177 * t178 - t179 * t193 - t180 * t192;
  const Real f5_z = h_5_y * t144 + f6_y;
  const Real minus_f6_z = t167 * t168 + t169_lanes[2] * f6_y + t169_lanes[3] * t193 +
      t169_lanes[5] * t192;
  const Real minus_f5_y = h_5_y * t130 + minus_f6_z;
  const Real n5_x = J_5_xx * t144 + minus_J_5_yz * (t128 - t138) - h_5_y * minus_a5_z +
      (link5_to_6_z * minus_f6_z - n6_x);
  const Real minus_f6_x = t146 * t152 + t155_lanes[1] * minus_f6_z - t155_lanes[2] * f6_y -
      t155_lanes[3] * t193 - t155_lanes[5] * t192;

  // links 5 (wrist_2) and 6 (wrist_3), inward
  const Real f5_x = h_5_y * t127 + minus_f6_x;
  const Real t194 = c5 * f5_x + s5 * minus_f5_y;
  const Real n5_y = minus_J_5_yz * t127 - J_5_yy * (t122 - wd5_y) +
      (n6_z + link5_to_6_z * minus_f6_x);
  const Real f4_z = s5 * f5_x - c5 * minus_f5_y - (qdd_0[0] * t19 + t153 * t17);
  const Real t195 = c234 * t194 + s234 * f5_z;

  // links 4 (wrist_1) and 5 (wrist_2), inward
  const Real f3_z = qdd_0[0] * t14 - t101 * t13 + f4_z;
  const Real f4_x = wd4_z * t17 - (t94 + t165) * t19 + t195;
  const Real f4_y = wd4_z * t19 + t165 * t17 + (s234 * t194 - c234 * f5_z);
  const Real n4_z = t170 + (s5 * n5_x + c5 * n5_y);
  tau[3] = n4_z;

  // links 2 (upper_arm) and 4 (wrist_1), inward
  const Real f3_x = t100 * t14 + wd3_z * t13 + f4_x;
  const Real f3_y = t96 * t13 - wd3_z * t14 + f4_y;
  const Real t196 = t158 + t153 * t151 - t19 * a4_z - c234 * n5_z + link4_to_5_z * t195;
  const Real n3_z = t175 + (n4_z + (t11 * f4_x - t12 * f4_y));
  tau[2] = n3_z;

  // links 2 (upper_arm) and 3 (forearm), inward
  const Real t197 = t196 + t12 * f4_z + t7 * f3_z + (c5 * n5_x - s5 * n5_y - J_4_yz * t165) * s234;
  const Real n1_z = t197 + t66 * qdd_0[0];
  tau[0] = n1_z;
  const Real n2_z = J_2_zz * qdd_0[1] + qdd_0[0] * t8 + t94 * t149 - 81.988590645 * c2 +
      (n3_z + (t6 * f3_x - t7 * f3_y));
  tau[1] = n2_z;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
