// SPDX-License-Identifier: 0BSD
// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 459 flops (add 189, mul 266, div 4), sine and cosine of 4 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void forward_dynamics(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT tau)[6], Real (&TREELINE_RESTRICT qdd)[6]) noexcept {
  // constants
  const Real minus_h_5_y = 0.0028799999999999997;
  const Real J_6_zz = 4e-05;
  const Real minus_link3_to_4_x = 0.0203;
  const Real minus_link3_to_4_y = 0.4331;
  const Real link2_to_3_x = 0.4318;
  const Real minus_gravity_z = 9.81;
  const Real link2_to_3_z = 0.1501;
  const Real J_5_xx = 0.00042216;
  const Real J_5_yy = 2e-04;
  const Real J_5_zz = 0.00062216;
  const Real J_4_xx = 0.0007499999999999999;
  const Real J_4_yy = 0.00065;
  const Real minus_h_3_x = 0.025374999999999998;
  const Real minus_h_3_y = 0.861795;
  const Real minus_J_3_xy = 0.010673638499999999;
  const Real h_2_y = 0.10439999999999999;
  const Real h_2_x = 3.79559;
  const Real J_3_zz = 0.312455249;
  const Real J_3_yz = 0.004704000000000001;
  const Real J_2_zz = 1.7481140020000001;
  const Real minus_J_2_xz = 0.690314699;
  const Real minus_J_2_yz = 0.023750999999999998;
  const Real J_4_zz = 0.0014;
  const Real minus_J_2_xy = 0.0070992;

  // sines and cosines
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real s4 = sines[2];
  const Real c4 = cosines[2];
  const Real s5 = sines[3];
  const Real c5 = cosines[3];

  // links 1 to 3, outward
  const Real w3_z = qd[1] + qd[2];
  const Real t1 = qd[0] * qd[0];
  const Real t2 = qd[1] * qd[1];
  const Real t3 = link2_to_3_x * s2;
  const Real t4 = link2_to_3_x * c2;
  const Real wd2_x = qd[0] * qd[1];
  const Real s23 = s2 * c3 + c2 * s3;
  const Real minus_c23 = s2 * s3 - c2 * c3;
  const Real t5 = w3_z * w3_z;
  const Real wd3_x = qd[0] * w3_z;
  const Real t6 = 2.0 * wd2_x;

  // links 3 (link3) and 4 (link4), outward
  const Real t7 = s23 * qd[0];
  const Real t8 = t1 + t5;
  const Real a3_x = (t1 + t2) * t4;
  const Real t9 = minus_c23 * wd3_x;
  const Real a3_y = minus_gravity_z + t2 * t3;
  const Real t10 = 2.0 * wd3_x;
  const Real minus_wd4_z = s23 * wd3_x;
  const Real t11 = minus_link3_to_4_x * minus_c23 + minus_link3_to_4_y * s23;
  const Real t12 = minus_link3_to_4_x * s23 - minus_link3_to_4_y * minus_c23;

  // links 3 (link3) and 4 (link4), outward; link 6 (link6), mass matrix
  const Real w4_z = qd[3] - minus_c23 * qd[0];
  const Real t13 = J_6_zz * s5;
  const Real minus_a3_z = t6 * t3 + link2_to_3_z * t1;
  const Real t14 = minus_h_3_x * minus_c23 + minus_h_3_y * s23;
  const Real t15 = s4 * t13;

  // link 4 (link4), outward
  const Real w4_x = s4 * w3_z - c4 * t7;
  const Real w4_y = s4 * t7 + c4 * w3_z;
  const Real t16 = minus_h_3_x * s23 - minus_h_3_y * minus_c23;
  const Real t17 = 0.298925024 * s23 + 0.021347276999999998 * minus_c23;
  const Real t18 = a3_x + t8 * t11;
  const Real t19 = a3_y - t5 * t12;
  const Real t20 = t10 * t12 - minus_a3_z;
  const Real t21 = w4_x * w4_y;

  // link 5 (link5), composite inertia; link 1 (link1), mass matrix; link 5 (link5), outward
  const Real t22 = minus_h_5_y * s5;
  const Real t23 = 24999.999999999996 * t15;
  const Real t24 = minus_h_5_y * c5;
  const Real w5_z = w4_y + qd[4];
  const Real w5_x = c5 * w4_x - s5 * w4_z;
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;

  // link 5 (link5), mass matrix; links 4 (link4) and 5 (link5), outward
  const Real t25 = c4 * t24;
  const Real t26 = t21 + minus_wd4_z;
  const Real t27 = c4 * t9 + (w4_z + qd[3]) * w4_y;
  const Real t28 = 2.0 * w5_z;
  const Real minus_wd4_y = s4 * t9 + w4_x * qd[3];
  const Real t29 = minus_c23 * t18 - s23 * t19;
  const Real t30 = w5_x * minus_w5_y;

  // links 5 (link5) and 6 (link6), outward; links 4 (link4) and 5 (link5), composite inertia
  const Real t31 = w5_x * w5_z;
  const Real w6_z = minus_w5_y + qd[5];
  const Real t32 = s4 * t22;
  const Real t33 = 0.00020215999999999998 * s5;
  const Real t34 = minus_wd4_y - t30;

  // link 4 (link4), outward; links 4 to 6, mass matrix
  const Real minus_a4_z = s23 * t18 + minus_c23 * t19;
  const Real t35 = minus_c23 * t32;
  const Real t36 = s23 * t32;
  const Real t37 = minus_c23 * t22 - s23 * t25;
  const Real t38 = J_6_zz * c5;

  // link 5 (link5), composite inertia and mass matrix and inertial wrench
  const Real t39 = s5 * t33;
  const Real t40 = minus_c23 * t25 + s23 * t22;
  const Real t41 = c5 * t33;
  const Real minus_f5_x = minus_h_5_y * t34;
  const Real f5_y = minus_h_5_y * (w5_x * w5_x + w5_z * w5_z);

  // links 4 (link4) and 5 (link5), outward and composite inertia
  const Real wd5_y = c5 * t26 - s5 * t27 - t31;
  const Real t42 = s5 * t26 + c5 * t27 - t28 * minus_w5_y;
  const Real a4_y = c4 * t20 - s4 * t29;
  const Real a4_x = c4 * t29 + s4 * t20;
  const Real t43 = c4 * t22;
  const Real t44 = 0.00164 + t39;

  // link 4 (link4), composite inertia; links 1 (link1) and 5 (link5), mass matrix; link 5 (link5),
  //   inertial wrench
  const Real t45 = s4 * t41;
  const Real t46 = s4 * (0.00010000000000000005 + t39);
  const Real t47 = 1.0 / (t44 - c5 * t38);
  const Real t48 = 0.00064216 * c4 - (t11 * t37 + t12 * t40);
  const Real minus_f5_z = minus_h_5_y * t42;

  // link 6 (link6), inertial wrench; link 4 (link4), composite inertia; link 5 (link5), inward
  const Real minus_n6_z = J_6_zz * wd5_y;
  const Real t49 = minus_c23 * t43 - s23 * t24;
  const Real t50 = s23 * t43 + minus_c23 * t24;
  const Real n6_x = 2e-05 * (t42 + t28 * w6_z);
  const Real minus_f4_x = c5 * minus_f5_x + s5 * f5_y;
  const Real t51 = s4 * t46;

  // links 1 (link1) and 5 (link5), mass matrix; link 5 (link5), outward; link 4 (link4), composite
  //   inertia
  const Real t52 = 1557.24430048586 * t48;
  const Real t53 = t48 + (t3 * t40 - t4 * t37);
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;
  const Real t54 = t11 * t49;
  const Real t55 = t12 * t35 - t11 * t36 - t45 - c5 * t15;
  const Real t56 = t16 - t50;
  const Real t57 = 1557.24430048586 * t53;

  // link 3 (link3), composite inertia; links 1 (link1) and 6 (link6), mass matrix; link 6 (link6),
  //   inward
  const Real t58 = t4 * (t49 - t14);
  const Real t59 = s23 * c4;
  const Real n5_y = minus_n6_z - J_5_yy * (t31 - wd5_y);
  const Real t60 = t55 - t4 * t36 - t3 * t35;
  const Real n5_x = J_5_xx * t42 - minus_h_5_y * a4_y + n6_x;

  // links 3 (link3) and 4 (link4), composite inertia; links 1 (link1) and 5 (link5), mass matrix
  const Real t61 = c4 * t41;
  const Real t62 = t58 + t3 * t56;
  const Real t63 = t55 * t47;
  const Real t64 = t60 * t47;
  const Real t65 = t11 + t4;

  // links 1 (link1) and 6 (link6), mass matrix; link 6 (link6), inertial wrench; links 4 (link4)
  //   and 5 (link5), inward
  const Real t66 = t59 * t13 + minus_c23 * t38;
  const Real minus_n6_y = 2e-05 * (t34 + 2.0 * (w5_x * w6_z));
  const Real t67 = s4 * minus_f5_z - c4 * minus_f4_x;
  const Real f4_z = s5 * minus_f5_x - c5 * f5_y;
  const Real t68 = J_3_zz + (0.0012921599999999999 - t51 - 2.0 * (t54 + t12 * t50)) - t23 * t15;

  // links 3 (link3) and 5 (link5), mass matrix; link 6 (link6), inward
  const Real t69 = t59 * t46 - t12 * t32 + (J_3_yz + t45) * minus_c23 - link2_to_3_z * t56;
  const Real n5_z = 0.00022215999999999997 * t30 - J_5_zz * minus_wd4_y + minus_h_5_y * a5_x -
      minus_n6_y;
  const Real t70 = 0.00064216 * s23 * s4 + link2_to_3_z * t40 + t65 * (s4 * t24);
  const Real t71 = minus_c23 * t17 - minus_J_3_xy;
  const Real t72 = 1.601861202 * s2 + 0.0141984 * c2;

  // link 1 (link1), mass matrix; links 4 (link4) and 5 (link5), inward
  const Real t73 = t69 + t23 * t66;
  const Real n4_x = J_4_xx * t27 - (s5 * n5_y - c5 * n5_x);
  const Real n4_y = n5_z - J_4_yy * (w4_x * w4_z + minus_wd4_y);
  const Real t74 = s23 * t67 + minus_c23 * f4_z;
  const Real t75 = minus_c23 * t67 - s23 * f4_z;
  const Real t76 = s23 * t61 - minus_c23 * t44 - link2_to_3_z * t35 + c5 * t66 + t65 * t43;
  const Real t77 = 1.0 / (t68 - t52 * t48 - t63 * t55);
  const Real t78 = t68 - t62 - t52 * t53 - t63 * t60;
  const Real minus_n4_z = 9.999999999999996e-05 * t21 + J_4_zz * minus_wd4_z +
      (s5 * n5_x + c5 * n5_y);
  const Real t79 = 24999.999999999996 * t66;
  const Real t80 = c2 * t72 - minus_J_2_xy;
  const Real t81 = t73 - t52 * t70 - t63 * t76;
  const Real t82 = s4 * minus_f4_x + c4 * minus_f5_z;
  const Real t83 = minus_J_2_xz * s2 + minus_J_2_yz * c2 + t73 + t3 * t32 - t57 * t70;
  const Real t84 = 1557.24430048586 * t70;

  // links 1 (link1) and 4 (link4), inward; link 1 (link1), mass matrix
  const Real t85 = tau[5] + minus_n6_z;
  const Real f3_x = t8 * t14 + t75;
  const Real t86 = t78 * t77;
  const Real t87 = t76 * t47;
  const Real n3_z = t1 * t71 - (t14 * a3_y + t16 * a3_x) +
      (s4 * n4_x + c4 * n4_y + (t11 * t74 - t12 * t75));
  const Real f3_z = t10 * t16 - t82;
  const Real t88 = t81 * t77;
  const Real t89 = tau[0] + t10 * t71 + t14 * minus_a3_z - minus_c23 * minus_n4_z + t11 * t82;
  const Real minus_f3_y = t5 * t16 + t74;

  // link 1 (link1), inward and mass matrix
  const Real t90 = n3_z + t23 * t85;
  const Real t91 = tau[4] - n5_z;
  const Real t92 = J_2_zz + t68 - 2.0 * t62 - t57 * t53 - t64 * t60 - t86 * t78;
  const Real t93 = t83 - t64 * t76 - t86 * t81;
  const Real t94 = tau[1] - t1 * t80 - minus_gravity_z * (h_2_y * s2 - h_2_x * c2) - t90;
  const Real t95 = 3.153482265 - s2 * t72 + t44 - t79 * t66 - t84 * t70 - t87 * t76;
  const Real t96 = tau[3] + minus_n4_z - c5 * t85;
  const Real t97 = 1.0 / t92;
  const Real t98 = t17 - (minus_c23 * (2.0 * t61) - s23 *
      (0.0011921599999999998 - t39 + t51 - t44));
  const Real t99 = t89 - link2_to_3_z * f3_x - t4 * f3_z + t6 * t80 + t2 *
      (minus_J_2_yz * s2 - minus_J_2_xz * c2);
  const Real t100 = tau[2] - t90 - t52 * t91 - t63 * t96;
  const Real t101 = t94 - t4 * minus_f3_y - t3 * f3_x - t57 * t91 - t64 * t96;
  const Real t102 = t93 * t97;
  const Real t103 = t101 - t86 * t100;
  const Real t104 = t99 + t79 * t85 - t84 * t91 - t87 * t96 - t88 * t100;
  const Real t105 = t95 - t88 * t81 - t102 * t93 + 2.0 * (link2_to_3_z * t32 - t58 - t54);

  // link 1 (link1), inward
  const Real t106 = t104 - t102 * t103 + (c4 * n4_x - s4 * n4_y - J_3_yz * t5) * s23;
  const Real qdd_0 = t106 * (1.0 / (t105 + t98 * s23));
  qdd[0] = qdd_0;
  const Real qdd_1 = t103 * t97 - t102 * qdd_0;
  qdd[1] = qdd_1;
  const Real qdd_2 = t100 * t77 - t88 * qdd_0 - t86 * qdd_1;
  qdd[2] = qdd_2;
  const Real qdd_3 = t96 * t47 - t87 * qdd_0 - t64 * qdd_1 - t63 * qdd_2;
  qdd[3] = qdd_3;
  qdd[4] = 1557.24430048586 * t91 - t84 * qdd_0 - t57 * qdd_1 - t52 * qdd_2;
  qdd[5] = 24999.999999999996 * t85 + t79 * qdd_0 - c5 * qdd_3 - (qdd_1 + qdd_2) * t23;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
