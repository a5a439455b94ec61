// SPDX-License-Identifier: 0BSD
// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 638 flops (add 266, mul 366, div 6), sine and cosine of 6 angles
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
  const Real J_6_zz = 0.312455249;
  const Real J_5_zz = 1.7481140020000001;
  const Real J_7_zz = 0.0014;
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

  // link 7 (link4), outward; links 1 (base_x) and 8 (link5), mass matrix
  const Real w7_y = s7 * t8 + c7 * w6_z;
  const Real s34 = s3 * c4 + c3 * s4;
  const Real t20 = 0.9999999999999999 * c8;
  const Real t21 = minus_c56 * t10 + s56 * t7;
  const Real t22 = a6_x + t9 * t14;

  // link 7 (link4), composite inertia; links 6 (link3) and 7 (link4), outward
  const Real t23 = s7 * t7;
  const Real t24 = h_5_x * s5 + h_5_y * c5;
  const Real t25 = a6_y - t5 * t16;
  const Real t26 = c7 * t7;
  const Real minus_a6_z = t15 * t2 + link5_to_6_z * t4;

  // links 7 (link4) and 9 (link6), mass matrix; link 8 (link5), composite inertia; links 7 (link4)
  //   and 8 (link5), outward
  const Real t27 = J_9_zz * c8;
  const Real t28 = 0.00020215999999999998 * s8;
  const Real t29 = w7_x * w7_y;
  const Real w8_z = w7_y + qd[7];
  const Real t30 = minus_c56 * t23;

  // links 7 (link4) and 8 (link5), outward; link 8 (link5), composite inertia
  const Real t31 = t18 * t16 - minus_a6_z;
  const Real t32 = h_5_y * s5 - h_5_x * c5;
  const Real t33 = s8 * t28;
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real w8_x = c8 * w7_x - s8 * w7_z;
  const Real t34 = t29 + minus_wd7_z;
  const Real t35 = c7 * t13 + (w7_z + qd[6]) * w7_y;
  const Real t36 = 2.0 * w8_z;
  const Real minus_wd7_y = s7 * t13 + w7_x * qd[6];
  const Real t37 = minus_c56 * t22 - s56 * t25;
  const Real t38 = w8_x * minus_w8_y;
  const Real t39 = 0.00164 + t33;

  // links 7 to 9, outward; link 9 (link6), mass matrix
  const Real w9_z = minus_w8_y + qd[8];
  const Real t40 = J_9_zz * s8;
  const Real t41 = w8_x * w8_z;
  const Real minus_a7_z = s56 * t22 + minus_c56 * t25;
  const Real t42 = minus_wd7_y - t38;
  const Real t43 = s7 * t40;

  // links 1, 7 and 8, mass matrix; link 8 (link5), inertial wrench and composite inertia
  const Real t44 = s56 * t23;
  const Real t45 = 1.0 / (t39 - t20 * t27);
  const Real minus_f8_x = minus_h_8_y * t42;
  const Real t46 = c8 * t28;
  const Real t47 = minus_c56 * t7 - s56 * t10;
  const Real f8_y = minus_h_8_y * (w8_x * w8_x + w8_z * w8_z);

  // links 7 (link4) and 8 (link5), outward; link 1 (base_x), mass matrix
  const Real t48 = s8 * t34 + c8 * t35 - t36 * minus_w8_y;
  const Real a7_x = c7 * t37 + s7 * t31;
  const Real a7_y = c7 * t31 - s7 * t37;
  const Real wd8_y = c8 * t34 - s8 * t35 - t41;
  const Real t49 = 24999.999999999996 * t43;

  // link 7 (link4), composite inertia; link 8 (link5), inertial wrench and inward
  const Real t50 = s7 * t46;
  const Real t51 = minus_c56 * t26 - s56 * t6;
  const Real minus_f8_z = minus_h_8_y * t48;
  const Real t52 = s56 * t26 + minus_c56 * t6;
  const Real t53 = s7 * (0.00010000000000000026 + t33);
  const Real minus_f7_x = c8 * minus_f8_x + s8 * f8_y;

  // link 9 (link6), inertial wrench; link 7 (link4), composite inertia; link 8 (link5), outward
  //   and mass matrix
  const Real n9_x = 2e-05 * (t48 + t36 * w9_z);
  const Real minus_n9_z = J_9_zz * wd8_y;
  const Real t54 = t14 * t51;
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;
  const Real t55 = 0.00064216 * c7 - (t14 * t47 + t16 * t21);

  // link 7 (link4), composite inertia; link 1 (base_x), mass matrix; link 9 (link6), inward
  const Real t56 = t19 - t52;
  const Real t57 = s7 * t53;
  const Real t58 = 0.298925024 * s56 + 0.021347276999999998 * minus_c56;
  const Real t59 = 1557.24430048586 * t55;
  const Real t60 = t16 * t30 - t14 * t44 - t50 - t20 * t43;
  const Real t61 = 1.601861202 * s5 + 0.0141984 * c5;
  const Real n8_x = J_8_xx * t48 - minus_h_8_y * a7_y + n9_x;
  const Real t62 = t60 * t45;
  const Real n8_y = minus_n9_z - J_8_yy * (t41 - wd8_y);
  const Real t63 = t51 - t17;

  // links 7 (link4) and 8 (link5), inward; link 9 (link6), inertial wrench; link 6 (link3),
  //   composite inertia; link 8 (link5), mass matrix
  const Real t64 = s7 * minus_f8_z - c7 * minus_f7_x;
  const Real f7_z = s8 * minus_f8_x - c8 * f8_y;
  const Real minus_n9_y = 2e-05 * (t42 + 2.0 * (w8_x * w9_z));
  const Real t65 = t1 * t63;
  const Real t66 = t55 + (t2 * t21 - t1 * t47);

  // link 1 (base_x), mass matrix; link 9 (link6), inward; link 6 (link3), composite inertia
  const Real t67 = t60 - t1 * t44 - t2 * t30;
  const Real n8_z = 0.00022215999999999997 * t38 - J_8_zz * minus_wd7_y + minus_h_8_y * a8_x -
      minus_n9_y;
  const Real t68 = t56 - t24;
  const Real t69 = t65 + t2 * t56;
  const Real t70 = 1557.24430048586 * t66;
  const Real t71 = t67 * t45;

  // link 1 (base_x), mass matrix; links 7 (link4) and 8 (link5), inward
  const Real t72 = minus_c56 * t58 - minus_J_6_xy;
  const Real t73 = J_6_zz + (0.00129216 - t57 - 2.0 * (t54 + t16 * t52)) - t49 * t43;
  const Real t74 = minus_c56 * t64 - s56 * f7_z;
  const Real n7_x = J_7_xx * t35 - (s8 * n8_y - c8 * n8_x);
  const Real n7_y = n8_z - J_7_yy * (w7_x * w7_z + minus_wd7_y);

  // link 7 (link4), inward; links 8 (link5) and 9 (link6), mass matrix; link 7 (link4), composite
  //   inertia
  const Real t75 = s56 * t64 + minus_c56 * f7_z;
  const Real t76 = s56 * c7;
  const Real t77 = t14 + t1;
  const Real t78 = c34 * t21 + s34 * t11;
  const Real t79 = c7 * t46;

  // links 1 (base_x) and 9 (link6), mass matrix; link 8 (link5), inward
  const Real t80 = 1.0 / (t73 - t59 * t55 - t62 * t60);
  const Real t81 = t73 - t69 - t59 * t66 - t62 * t67;
  const Real t82 = t76 * t40 + minus_c56 * t27;
  const Real minus_n7_z = 9.999999999999994e-05 * t29 + J_7_zz * minus_wd7_z +
      (s8 * n8_x + c8 * n8_y);
  const Real t83 = 24999.999999999996 * t82;

  // links 1, 7 and 8, mass matrix; link 7 (link4), inward
  const Real t84 = 0.00064216 * s56 * s7 + link5_to_6_z * t21 + t77 * t11;
  const Real t85 = c34 * t30 - s34 * t26;
  const Real t86 = c5 * t61 - minus_J_5_xy;
  const Real t87 = s7 * minus_f7_x + c7 * minus_f8_z;
  const Real t88 = 1557.24430048586 * t84;

  // links 5 (link2) and 6 (link3), composite inertia; links 1 (base_x) and 6 (link3), mass matrix;
  //   link 1 (base_x), inward
  const Real t89 = t32 + t63;
  const Real t90 = h_4_y + t23;
  const Real t91 = t81 * t80;
  const Real t92 = t76 * t53 - t16 * t23 + (J_6_yz + t50) * minus_c56 - link5_to_6_z * t56;
  const Real t93 = tau[8] + minus_n9_z;

  // link 7 (link4), inward; link 1 (base_x), mass matrix
  const Real f6_x = t9 * t17 + t74;
  const Real t94 = s56 * t79 - minus_c56 * t39 - link5_to_6_z * t30 + t20 * t82 + t77 * t26;
  const Real t95 = t92 + t49 * t82;
  const Real t96 = t94 * t45;
  const Real t97 = J_5_zz + t73 - 2.0 * t69 - t70 * t66 - t71 * t67 - t91 * t81;
  const Real t98 = t95 - t59 * t84 - t62 * t94;
  const Real f6_z = t18 * t19 - t87;
  const Real t99 = 1.0 / t97;
  const Real n6_z = t4 * t72 - (t17 * a6_y + t19 * a6_x) +
      (s7 * n7_x + c7 * n7_y + (t14 * t75 - t16 * t74));
  const Real t100 = minus_J_5_xz * s5 + minus_J_5_yz * c5 + t95 + t2 * t23 - t70 * t84;
  const Real t101 = t98 * t80;

  // links 1, 7 and 8, mass matrix; link 1 (base_x), inward
  const Real t102 = c34 * t56 + t59 * t78 - t62 * t85;
  const Real t103 = c34 * t11 - s34 * t21;
  const Real t104 = tau[3] + t18 * t72 + t17 * minus_a6_z - minus_c56 * minus_n7_z + t14 * t87;
  const Real t105 = s34 * t30 + c34 * t26;
  const Real t106 = 1557.24430048586 * t103;

  // link 1 (base_x), mass matrix; link 7 (link4), inward
  const Real t107 = t100 - t71 * t94 - t91 * t98;
  const Real t108 = 3.153482265 - s5 * t61 + t39 - t83 * t82 - t88 * t84 - t96 * t94;
  const Real minus_f6_y = t5 * t19 + t75;
  const Real t109 = t105 * t45;
  const Real t110 = t58 - (minus_c56 * (2.0 * t79) - s56 *
      (0.0011921599999999998 - t33 + t57 - t39));

  // link 1 (base_x), inward and mass matrix
  const Real t111 = n6_z + t49 * t93;
  const Real t112 = t107 * t99;
  const Real t113 = s34 * t56 - t59 * t103 - t62 * t105;
  const Real t114 = tau[7] - n8_z;
  const Real t115 = t113 * t80;
  const Real t116 = tau[6] + minus_n7_z - t20 * t93;
  const Real t117 = c34 * t68 + t70 * t78 - t71 * t85 - t91 * t102;
  const Real t118 = s34 * t68 - t70 * t103 - t71 * t105 - t91 * t113;
  const Real t119 = s34 * t90 + c34 * t89 + t88 * t103 + t96 * t105 + t101 * t113;
  const Real t120 = t118 * t99;
  const Real t121 = t108 - t101 * t98 - t112 * t107 + 2.0 * (link5_to_6_z * t23 - t65 - t54);
  const Real t122 = 1557.24430048586 * t78;

  // links 1, 5 and 6, inward; link 1 (base_x), mass matrix
  const Real f5_z = f6_z - t15 * t24;
  const Real t123 = s34 * t89 - c34 * t90 + t88 * t78 - t96 * t85 - t101 * t102;
  const Real t124 = t119 + t112 * t118;
  const Real t125 = t85 * t45;
  const Real t126 = tau[4] - t4 * t86 - minus_gravity_z * t32 - t111 - t1 * minus_f6_y - t2 * f6_x;
  const Real f5_x = f6_x - t12 * t32;
  const Real f4_y = f5_z - h_4_y * t4;

  // links 1 (base_x) and 4 (link1), inward; link 1 (base_x), mass matrix
  const Real t127 = t104 - link5_to_6_z * f6_x - t1 * f6_z + t15 * t86 + t3 *
      (minus_J_5_yz * s5 - minus_J_5_xz * c5);
  const Real t128 = 1.0 / (t121 + t110 * s56);
  const Real t129 = tau[5] - t111 - t59 * t114 - t62 * t116;
  const Real t130 = t123 - t112 * t117;
  const Real t131 = mass_2 - t106 * t103 - t109 * t105 - t115 * t113 - t120 * t118;
  const Real t132 = t102 * t80;
  const Real t133 = t117 * t99;
  const Real f3_y = c34 * f4_y - s34 * f5_x;
  const Real t134 = t126 - t70 * t114 - t71 * t116 - t91 * t129;
  const Real minus_f3_x = c34 * f5_x + s34 * f4_y;

  // link 1 (base_x), inward and mass matrix
  const Real t135 = t127 + t83 * t93 - t88 * t114 - t96 * t116 - t101 * t129;
  const Real t136 = t124 * t128;
  const Real t137 = t130 * t128;
  const Real t138 = mass_2 - t122 * t78 - t125 * t85 - t132 * t102 - t133 * t117;
  const Real t139 = t135 - t112 * t134 + (c7 * n7_x - s7 * n7_y - J_6_yz * t5) * s56;
  const Real qdd_2 = 0.1388888888888889 * (tau[2] - tau[3]);
  qdd[2] = qdd_2;
  const Real t140 = t106 * t78 - t109 * t85 - t115 * t102 - t120 * t117 + t136 * t130;
  const Real t141 = tau[1] - f3_y - t106 * t114 - t109 * t116 - t115 * t129 - t120 * t134;
  const Real t142 = 1.0 / (t131 - t136 * t124);
  const Real t143 = t141 + t136 * t139;
  const Real t144 = tau[0] + minus_f3_x + t122 * t114 - t125 * t116 - t132 * t129 - t133 * t134;
  const Real t145 = t140 * t142;

  // link 1 (base_x), inward
  const Real qdd_0 = (t144 - t137 * t139 - t145 * t143) *
      (1.0 / (t138 - t137 * t130 - t145 * t140));
  qdd[0] = qdd_0;
  const Real qdd_1 = t143 * t142 - t145 * qdd_0;
  qdd[1] = qdd_1;
  const Real t146 = t139 * t128 - t137 * qdd_0 + t136 * qdd_1;
  qdd[3] = t146 - qdd_2;
  const Real qdd_4 = t134 * t99 - t133 * qdd_0 - t120 * qdd_1 - t146 * t112;
  qdd[4] = qdd_4;
  const Real qdd_5 = t129 * t80 - t132 * qdd_0 - t115 * qdd_1 - t91 * qdd_4 - t146 * t101;
  qdd[5] = qdd_5;
  const Real t147 = t116 * t45 - t125 * qdd_0 - t109 * qdd_1 - t71 * qdd_4 - t62 * qdd_5;
  const Real t148 = 1557.24430048586 * t114 + t122 * qdd_0 - t106 * qdd_1 - t70 * qdd_4 - t59 *
      qdd_5;
  const Real qdd_6 = t147 - t146 * t96;
  qdd[6] = qdd_6;
  qdd[7] = t148 - t146 * t88;
  qdd[8] = 24999.999999999996 * t93 - t20 * qdd_6 - (qdd_4 + qdd_5) * t49 + t146 * t83;
}

}  // namespace samm

#undef TREELINE_RESTRICT
