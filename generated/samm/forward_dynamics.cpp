// SPDX-License-Identifier: 0BSD
// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 637 flops (add 266, mul 365, div 6), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void forward_dynamics(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    const Real (&TREELINE_RESTRICT tau)[9], Real (&TREELINE_RESTRICT qdd)[9]) noexcept {
  // constants
  const Real minus_h_8_y = 0.0028799999999999997;
  const Real minus_link6_to_7_x = 0.0203;
  const Real minus_link6_to_7_y = 0.4331;
  const Real minus_h_6_x = 0.025374999999999998;
  const Real minus_h_6_y = 0.861795;
  const Real link5_to_6_x = 0.4318;
  const Real link5_to_6_z = 0.1501;
  const Real minus_gravity_z = 9.81;
  const Real h_5_y = 0.10439999999999999;
  const Real h_5_x = 3.79559;
  const Real J_9_zz = 4e-05;
  const Real J_8_xx = 0.00042216;
  const Real J_8_yy = 2e-04;
  const Real J_8_zz = 0.00062216;
  const Real h_4_y = 4.9338049999999996;
  const Real J_7_xx = 0.0007499999999999999;
  const Real J_7_yy = 0.00065;
  const Real J_7_zz = 0.0014;
  const Real J_6_zz = 0.312455249;
  const Real J_5_zz = 1.7481140020000001;
  const Real minus_J_6_xy = 0.010673638499999999;
  const Real minus_J_5_yz = 0.023750999999999998;
  const Real minus_J_5_xz = 0.690314699;
  const Real J_6_yz = 0.004704000000000001;
  const Real minus_J_5_xy = 0.0070992;
  const Real mass_2 = 186.45;

  // sines and cosines
  const Real angles[6] = {q[2], q[3], q[4], q[5], q[6], q[7]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s3 = sines[0];
  const Real s4 = sines[1];
  const Real s5 = sines[2];
  const Real s6 = sines[3];
  const Real c5 = cosines[2];
  const Real c6 = cosines[3];
  const Real s7 = sines[4];
  const Real s8 = sines[5];
  const Real c7 = cosines[4];
  const Real c8 = cosines[5];
  const Real t1 = link5_to_6_x * c5;
  const Real t2 = link5_to_6_x * s5;

  // links 4 to 6, outward
  const Real w4_z = qd[2] + qd[3];
  const Real w6_z = qd[4] + qd[5];
  const Real t3 = qd[4] * qd[4];
  const Real s56 = s5 * c6 + c5 * s6;
  const Real minus_c56 = s5 * s6 - c5 * c6;
  const Real t4 = w4_z * w4_z;
  const Real t5 = w6_z * w6_z;
  const Real wd6_x = w4_z * w6_z;
  const Real wd5_x = w4_z * qd[4];

  // link 8 (link5), composite inertia; links 6 (link3) and 7 (link4), outward
  const Real c34 = c3 * c4 - s3 * s4;
  const Real t6 = minus_h_8_y * c8;
  const Real t7 = minus_h_8_y * s8;
  const Real t8 = s56 * w4_z;
  const Real t9 = t4 + t5;

  // link 8 (link5), mass matrix; links 5 (link2) and 7 (link4), outward
  const Real t10 = c7 * t6;
  const Real t11 = s7 * t6;
  const Real t12 = t4 + t3;
  const Real t13 = minus_c56 * wd6_x;
  const Real t14 = minus_link6_to_7_x * minus_c56 + minus_link6_to_7_y * s56;
  const Real t15 = 2.0 * wd5_x;

  // links 6 (link3) and 7 (link4), outward
  const Real a6_y = minus_gravity_z + t3 * t2;
  const Real t16 = minus_link6_to_7_x * s56 - minus_link6_to_7_y * minus_c56;
  const Real t17 = minus_h_6_x * minus_c56 + minus_h_6_y * s56;
  const Real t18 = 2.0 * wd6_x;
  const Real minus_wd7_z = s56 * wd6_x;
  const Real t19 = minus_h_6_x * s56 - minus_h_6_y * minus_c56;
  const Real w7_z = qd[6] - minus_c56 * w4_z;
  const Real a6_x = t12 * t1;
  const Real w7_x = s7 * w6_z - c7 * t8;
  const Real w7_y = s7 * t8 + c7 * w6_z;
  const Real s34 = s3 * c4 + c3 * s4;
  const Real t20 = h_5_x * s5 + h_5_y * c5;

  // link 8 (link5), mass matrix; link 7 (link4), composite inertia and outward
  const Real t21 = minus_c56 * t10 + s56 * t7;
  const Real t22 = s7 * t7;
  const Real t23 = a6_x + t9 * t14;
  const Real t24 = c7 * t7;
  const Real t25 = a6_y - t5 * t16;

  // links 6 (link3) and 7 (link4), outward; link 8 (link5), composite inertia; link 9 (link6),
  //   mass matrix
  const Real minus_a6_z = t15 * t2 + link5_to_6_z * t4;
  const Real t26 = 0.00020215999999999998 * s8;
  const Real t27 = h_5_y * s5 - h_5_x * c5;
  const Real t28 = J_9_zz * c8;
  const Real t29 = w7_x * w7_y;

  // links 7 (link4) and 8 (link5), outward; link 7 (link4), mass matrix; link 8 (link5), composite
  //   inertia
  const Real w8_z = w7_y + qd[7];
  const Real t30 = minus_c56 * t22;
  const Real t31 = t18 * t16 - minus_a6_z;
  const Real t32 = s8 * t26;
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;

  // links 7 (link4) and 8 (link5), outward; link 8 (link5), composite inertia
  const Real w8_x = c8 * w7_x - s8 * w7_z;
  const Real t33 = t29 + minus_wd7_z;
  const Real t34 = c7 * t13 + (w7_z + qd[6]) * w7_y;
  const Real t35 = 2.0 * w8_z;
  const Real minus_wd7_y = s7 * t13 + w7_x * qd[6];
  const Real t36 = minus_c56 * t23 - s56 * t25;
  const Real t37 = 0.00164 + t32;
  const Real t38 = w8_x * minus_w8_y;

  // links 7 to 9, outward; link 9 (link6), mass matrix
  const Real w9_z = minus_w8_y + qd[8];
  const Real t39 = J_9_zz * s8;
  const Real t40 = w8_x * w8_z;
  const Real minus_a7_z = s56 * t23 + minus_c56 * t25;
  const Real t41 = minus_wd7_y - t38;

  // links 1, 7, 9, mass matrix; link 8 (link5), inertial wrench
  const Real t42 = 1.0 / (t37 - c8 * t28);
  const Real t43 = s7 * t39;
  const Real t44 = s56 * t22;
  const Real minus_f8_x = minus_h_8_y * t41;
  const Real f8_y = minus_h_8_y * (w8_x * w8_x + w8_z * w8_z);

  // link 8 (link5), composite inertia; links 7 (link4) and 8 (link5), outward; link 8 (link5),
  //   mass matrix
  const Real t45 = c8 * t26;
  const Real a7_x = c7 * t36 + s7 * t31;
  const Real t46 = minus_c56 * t7 - s56 * t10;
  const Real t47 = s8 * t33 + c8 * t34 - t35 * minus_w8_y;
  const Real a7_y = c7 * t31 - s7 * t36;
  const Real wd8_y = c8 * t33 - s8 * t34 - t40;

  // link 7 (link4), composite inertia; link 1 (base_x), mass matrix; link 8 (link5), inertial
  //   wrench and inward
  const Real t48 = s7 * t45;
  const Real t49 = 24999.999999999996 * t43;
  const Real t50 = minus_c56 * t24 - s56 * t6;
  const Real t51 = s56 * t24 + minus_c56 * t6;
  const Real minus_f8_z = minus_h_8_y * t47;
  const Real t52 = s7 * (0.00010000000000000005 + t32);
  const Real t53 = t14 * t50;
  const Real minus_f7_x = c8 * minus_f8_x + s8 * f8_y;

  // link 9 (link6), inertial wrench; link 7 (link4), composite inertia; link 8 (link5), mass
  //   matrix and outward
  const Real n9_x = 2e-05 * (t47 + t35 * w9_z);
  const Real minus_n9_z = J_9_zz * wd8_y;
  const Real t54 = t19 - t51;
  const Real t55 = 0.00064216 * c7 - (t14 * t46 + t16 * t21);
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;
  const Real t56 = s7 * t52;

  // link 1 (base_x), mass matrix
  const Real t57 = t16 * t30 - t14 * t44 - t48 - c8 * t43;
  const Real t58 = 0.298925024 * s56 + 0.021347276999999998 * minus_c56;
  const Real t59 = 1557.24430048586 * t55;
  const Real t60 = 1.601861202 * s5 + 0.0141984 * c5;
  const Real t61 = t57 * t42;

  // links 7 to 9, inward; link 7 (link4), composite inertia
  const Real n8_x = J_8_xx * t47 - minus_h_8_y * a7_y + n9_x;
  const Real n8_y = minus_n9_z - J_8_yy * (t40 - wd8_y);
  const Real t62 = t50 - t17;
  const Real t63 = s7 * minus_f8_z - c7 * minus_f7_x;
  const Real f7_z = s8 * minus_f8_x - c8 * f8_y;

  // link 9 (link6), inertial wrench; link 6 (link3), composite inertia; links 1 (base_x) and 8
  //   (link5), mass matrix
  const Real minus_n9_y = 2e-05 * (t41 + 2.0 * (w8_x * w9_z));
  const Real t64 = t1 * t62;
  const Real t65 = t55 + (t2 * t21 - t1 * t46);
  const Real t66 = t57 - t1 * t44 - t2 * t30;
  const Real t67 = t54 - t20;

  // link 9 (link6), inward; link 6 (link3), composite inertia; link 1 (base_x), mass matrix
  const Real n8_z = 0.00022215999999999997 * t38 - J_8_zz * minus_wd7_y + minus_h_8_y * a8_x -
      minus_n9_y;
  const Real t68 = t64 + t2 * t54;
  const Real t69 = 1557.24430048586 * t65;
  const Real t70 = t66 * t42;
  const Real t71 = J_6_zz + (0.0012921599999999999 - t56 - 2.0 * (t53 + t16 * t51)) - t49 * t43;

  // links 7 (link4) and 8 (link5), inward
  const Real t72 = minus_c56 * t58 - minus_J_6_xy;
  const Real t73 = minus_c56 * t63 - s56 * f7_z;
  const Real n7_y = n8_z - J_7_yy * (w7_x * w7_z + minus_wd7_y);
  const Real t74 = s56 * t63 + minus_c56 * f7_z;
  const Real n7_x = J_7_xx * t34 - (s8 * n8_y - c8 * n8_x);

  // links 1, 8 and 9, mass matrix; link 7 (link4), composite inertia
  const Real t75 = s56 * c7;
  const Real t76 = t14 + t1;
  const Real t77 = c34 * t21 + s34 * t11;
  const Real t78 = c7 * t45;
  const Real t79 = 1.0 / (t71 - t59 * t55 - t61 * t57);
  const Real t80 = t71 - t68 - t59 * t65 - t61 * t66;
  const Real t81 = t75 * t39 + minus_c56 * t28;

  // links 7 (link4) and 8 (link5), inward; links 1, 7 and 8, mass matrix
  const Real minus_n7_z = 9.999999999999996e-05 * t29 + J_7_zz * minus_wd7_z +
      (s8 * n8_x + c8 * n8_y);
  const Real t82 = 24999.999999999996 * t81;
  const Real t83 = c34 * t30 - s34 * t24;
  const Real t84 = 0.00064216 * s56 * s7 + link5_to_6_z * t21 + t76 * t11;
  const Real t85 = c5 * t60 - minus_J_5_xy;
  const Real t86 = s7 * minus_f7_x + c7 * minus_f8_z;
  const Real t87 = 1557.24430048586 * t84;

  // links 5 (link2) and 6 (link3), composite inertia; links 1 (base_x) and 6 (link3), mass matrix;
  //   link 1 (base_x), inward
  const Real t88 = t27 + t62;
  const Real t89 = t80 * t79;
  const Real t90 = h_4_y + t22;
  const Real t91 = t75 * t52 - t16 * t22 + (J_6_yz + t48) * minus_c56 - link5_to_6_z * t54;
  const Real t92 = tau[8] + minus_n9_z;

  // link 7 (link4), inward; link 1 (base_x), mass matrix
  const Real f6_x = t9 * t17 + t73;
  const Real t93 = s56 * t78 - minus_c56 * t37 - link5_to_6_z * t30 + c8 * t81 + t76 * t24;
  const Real t94 = t91 + t49 * t81;
  const Real t95 = t93 * t42;
  const Real t96 = J_5_zz + t71 - 2.0 * t68 - t69 * t65 - t70 * t66 - t89 * t80;
  const Real f6_z = t18 * t19 - t86;
  const Real t97 = t94 - t59 * t84 - t61 * t93;
  const Real t98 = 1.0 / t96;
  const Real n6_z = t4 * t72 - (t17 * a6_y + t19 * a6_x) +
      (s7 * n7_x + c7 * n7_y + (t14 * t74 - t16 * t73));
  const Real t99 = minus_J_5_xz * s5 + minus_J_5_yz * c5 + t94 + t2 * t22 - t69 * t84;
  const Real t100 = t97 * t79;

  // links 1, 7 and 8, mass matrix; link 1 (base_x), inward
  const Real t101 = c34 * t54 + t59 * t77 - t61 * t83;
  const Real t102 = c34 * t11 - s34 * t21;
  const Real t103 = tau[3] + t18 * t72 + t17 * minus_a6_z - minus_c56 * minus_n7_z + t14 * t86;
  const Real t104 = s34 * t30 + c34 * t24;
  const Real t105 = 1557.24430048586 * t102;

  // link 1 (base_x), mass matrix; link 7 (link4), inward
  const Real t106 = t99 - t70 * t93 - t89 * t97;
  const Real t107 = 3.153482265 - s5 * t60 + t37 - t82 * t81 - t87 * t84 - t95 * t93;
  const Real minus_f6_y = t5 * t19 + t74;
  const Real t108 = t104 * t42;
  const Real t109 = t58 - (minus_c56 * (2.0 * t78) - s56 *
      (0.0011921599999999998 - t32 + t56 - t37));

  // link 1 (base_x), inward and mass matrix
  const Real t110 = n6_z + t49 * t92;
  const Real t111 = t106 * t98;
  const Real t112 = s34 * t54 - t59 * t102 - t61 * t104;
  const Real t113 = tau[7] - n8_z;
  const Real t114 = t112 * t79;
  const Real t115 = tau[6] + minus_n7_z - c8 * t92;
  const Real t116 = c34 * t67 + t69 * t77 - t70 * t83 - t89 * t101;
  const Real t117 = s34 * t67 - t69 * t102 - t70 * t104 - t89 * t112;
  const Real t118 = s34 * t90 + c34 * t88 + t87 * t102 + t95 * t104 + t100 * t112;
  const Real t119 = t107 - t100 * t97 - t111 * t106 + 2.0 * (link5_to_6_z * t22 - t64 - t53);
  const Real t120 = t117 * t98;
  const Real t121 = 1557.24430048586 * t77;

  // links 1 (base_x) and 6 (link3), inward; link 1 (base_x), mass matrix
  const Real f5_z = f6_z - t15 * t20;
  const Real t122 = s34 * t88 - c34 * t90 + t87 * t77 - t95 * t83 - t100 * t101;
  const Real t123 = t118 + t111 * t117;
  const Real t124 = t83 * t42;
  const Real t125 = tau[4] - t4 * t85 - minus_gravity_z * t27 - t110 - t1 * minus_f6_y - t2 * f6_x;
  const Real f5_x = f6_x - t12 * t27;
  const Real t126 = 1.0 / (t119 + t109 * s56);

  // links 1 (base_x) and 5 (link2), inward; link 1 (base_x), mass matrix
  const Real f4_y = f5_z - h_4_y * t4;
  const Real t127 = t103 - link5_to_6_z * f6_x - t1 * f6_z + t15 * t85 + t3 *
      (minus_J_5_yz * s5 - minus_J_5_xz * c5);
  const Real t128 = tau[5] - t110 - t59 * t113 - t61 * t115;
  const Real t129 = t122 - t111 * t116;
  const Real t130 = mass_2 - t105 * t102 - t108 * t104 - t114 * t112 - t120 * t117;

  // link 1 (base_x), mass matrix; links 1 (base_x) and 4 (link1), inward
  const Real t131 = t101 * t79;
  const Real t132 = t116 * t98;
  const Real f3_y = c34 * f4_y - s34 * f5_x;
  const Real t133 = t125 - t69 * t113 - t70 * t115 - t89 * t128;
  const Real minus_f3_x = c34 * f5_x + s34 * f4_y;

  // link 1 (base_x), inward and mass matrix
  const Real t134 = t127 + t82 * t92 - t87 * t113 - t95 * t115 - t100 * t128;
  const Real t135 = t123 * t126;
  const Real t136 = t129 * t126;
  const Real t137 = mass_2 - t121 * t77 - t124 * t83 - t131 * t101 - t132 * t116;
  const Real t138 = t134 - t111 * t133 + (c7 * n7_x - s7 * n7_y - J_6_yz * t5) * s56;
  const Real qdd_2 = 0.1388888888888889 * (tau[2] - tau[3]);
  qdd[2] = qdd_2;
  const Real t139 = t105 * t77 - t108 * t83 - t114 * t101 - t120 * t116 + t135 * t129;
  const Real t140 = tau[1] - f3_y - t105 * t113 - t108 * t115 - t114 * t128 - t120 * t133;
  const Real t141 = 1.0 / (t130 - t135 * t123);
  const Real t142 = t140 + t135 * t138;
  const Real t143 = tau[0] + minus_f3_x + t121 * t113 - t124 * t115 - t131 * t128 - t132 * t133;
  const Real t144 = t139 * t141;

  // link 1 (base_x), inward
  const Real qdd_0 = (t143 - t136 * t138 - t144 * t142) *
      (1.0 / (t137 - t136 * t129 - t144 * t139));
  qdd[0] = qdd_0;
  const Real qdd_1 = t142 * t141 - t144 * qdd_0;
  qdd[1] = qdd_1;
  const Real t145 = t138 * t126 - t136 * qdd_0 + t135 * qdd_1;
  qdd[3] = t145 - qdd_2;
  const Real qdd_4 = t133 * t98 - t132 * qdd_0 - t120 * qdd_1 - t145 * t111;
  qdd[4] = qdd_4;
  const Real qdd_5 = t128 * t79 - t131 * qdd_0 - t114 * qdd_1 - t89 * qdd_4 - t145 * t100;
  qdd[5] = qdd_5;
  const Real t146 = t115 * t42 - t124 * qdd_0 - t108 * qdd_1 - t70 * qdd_4 - t61 * qdd_5;
  const Real t147 = 1557.24430048586 * t113 + t121 * qdd_0 - t105 * qdd_1 - t69 * qdd_4 - t59 *
      qdd_5;
  const Real qdd_6 = t146 - t145 * t95;
  qdd[6] = qdd_6;
  qdd[7] = t147 - t145 * t87;
  qdd[8] = 24999.999999999996 * t92 - c8 * qdd_6 - (qdd_4 + qdd_5) * t49 + t145 * t82;
}

}  // namespace samm

#undef TREELINE_RESTRICT
