// SPDX-License-Identifier: 0BSD
// forward_dynamics: qdd = M^-1 (tau - b - g + J_ext^T f_ext)
// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
// 410 flops (add 175, mul 231, div 4), sine and cosine of 4 angles
// Generated; see ur10e.hpp for the contract.
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void forward_dynamics(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&TREELINE_RESTRICT tau)[6], Real (&TREELINE_RESTRICT qdd)[6]) noexcept {
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
  const Real J_2_xz = 1.156008191975;
  const Real J_2_zz = 4.3866871861500005;
  const Real J_3_xz = 0.5656542411875001;
  const Real minus_gravity_z = 9.81;
  const Real J_5_xx = 0.0069705910375000004;
  const Real J_5_yy = 0.00124;
  const Real J_5_zz = 0.008210591037500001;

  // sines and cosines
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real c2 = cosines[0];
  const Real s2 = sines[0];
  const Real c3 = cosines[1];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];

  // link 5 (wrist_2), composite inertia; link 1 (shoulder), mass matrix; link 3 (forearm), outward
  const Real t1 = 0.0054190910375000005 * s5;
  const Real t2 = h_5_y * s5;
  const Real t3 = h_5_y * c5;
  const Real t4 = minus_J_5_yz * c5;
  const Real t5 = 1.2551157591996094 * c5;
  const Real t6 = minus_link2_to_3_x * s2;
  const Real t7 = minus_link2_to_3_x * c2;
  const Real w3_z = qd[1] + qd[2];
  const Real c23 = c2 * c3 - s2 * s3;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real t8 = s5 * t1;
  const Real t9 = c5 * (J_6_zz * c5);

  // links 3 (forearm) and 4 (wrist_1), outward
  const Real w4_z = w3_z + qd[3];
  const Real t10 = minus_link3_to_4_x * s23;
  const Real t11 = minus_link3_to_4_x * c23;
  const Real t12 = w3_z * w3_z;
  const Real t13 = minus_h_3_x * s23;

  // link 5 (wrist_2), composite inertia; links 1 and 2, 4, outward
  const Real t14 = 0.0415928163875 + t8;
  const Real t15 = qd[1] * qd[1];
  const Real t16 = minus_h_3_x * c23;
  const Real wd4_x = qd[0] * w4_z;
  const Real t17 = qd[0] * qd[0];

  // link 5 (wrist_2), composite inertia and mass matrix
  const Real c234 = c23 * c4 - s23 * s4;
  const Real s234 = s23 * c4 + c23 * s4;
  const Real t18 = minus_h_4_y * c234;
  const Real t19 = s234 * t2;
  const Real t20 = minus_h_4_y * s234;
  const Real t21 = s234 * t3;
  const Real t22 = c234 * t3;

  // links 3 (forearm) and 5 (wrist_2), outward; link 6 (wrist_3), mass matrix
  const Real t23 = s234 * qd[0];
  const Real t24 = t17 + t12;
  const Real t25 = c234 * wd4_x;
  const Real a3_y = minus_gravity_z + t15 * t6;
  const Real t26 = s234 * s5;

  // link 5 (wrist_2), composite inertia; link 1 (shoulder), mass matrix; link 5 (wrist_2), outward
  const Real t27 = t18 + t19;
  const Real t28 = t20 - c234 * t2;
  const Real t29 = 1.0 / (t14 - t9 - t5 * t4);
  const Real wd5_z = s234 * wd4_x;
  const Real w5_z = qd[4] - c234 * qd[0];

  // link 4 (wrist_1), composite inertia; links 3 to 5, outward
  const Real t30 = t11 * t28;
  const Real a3_x = (t17 + t15) * t7;
  const Real w5_y = c5 * w4_z - s5 * t23;
  const Real w5_x = c5 * t23 + s5 * w4_z;
  const Real t31 = w5_z * w5_z;
  const Real a4_y = a3_y + t12 * t10;
  const Real t32 = t10 * t27 - t30;

  // link 3 (forearm), composite inertia; link 5 (wrist_2), mass matrix; links 4 to 6, outward
  const Real t33 = t7 * (t28 - t16);
  const Real t34 = t11 * t21 - t10 * t22 - t4;
  const Real t35 = w5_x * w5_y;
  const Real w6_z = w5_y + qd[5];
  const Real a4_x = a3_x + t24 * t11;

  // links 1 (shoulder) and 5 (wrist_2), mass matrix; link 3 (forearm), composite inertia; links 5
  //   (wrist_2) and 6 (wrist_3), outward
  const Real t36 = 117.34209310833121 * t34;
  const Real t37 = t34 + (t7 * t21 - t6 * t22);
  const Real t38 = t6 * (t13 + t27) - t33;
  const Real t39 = t35 - wd5_z;
  const Real t40 = 2.0 * w6_z;

  // link 1 (shoulder), mass matrix; link 5 (wrist_2), outward and inertial wrench
  const Real t41 = t14 + t32 - t9;
  const Real t42 = w5_x * w5_z;
  const Real t43 = c5 * t25 + (w5_z + qd[4]) * w5_y;
  const Real minus_f5_y = h_5_y * (w5_x * w5_x + t31);
  const Real f5_x = h_5_y * t39;
  const Real t44 = t41 + t5 * t34;
  const Real minus_wd5_y = s5 * t25 + w5_x * qd[4];

  // links 2 and 3, 5, outward; link 1 (shoulder), mass matrix
  const Real t45 = 2.0 * qd[0];
  const Real t46 = 117.34209310833121 * t37;
  const Real t47 = t44 * t29;
  const Real t48 = J_3_zz + (t14 + 2.0 * t32) - t9;
  const Real minus_a5_z = c234 * a4_y - s234 * a4_x;
  const Real t49 = t45 * w3_z;
  const Real t50 = t45 * qd[1];

  // links 1 (shoulder) and 6 (wrist_3), mass matrix; link 5 (wrist_2), inertial wrench; link 4
  //   (wrist_1), outward
  const Real t51 = J_6_zz * t26;
  const Real t52 = t41 + t6 * t27 - t7 * t28 + t5 * t37;
  const Real f5_z = h_5_y * t43;
  const Real t53 = w4_z * w4_z;
  const Real t54 = 4.36318718615 * s2;

  // link 3 (forearm), outward; link 1 (shoulder), mass matrix; link 5 (wrist_2), composite inertia
  //   and inward
  const Real minus_a3_z = t50 * t6;
  const Real t55 = t52 * t29;
  const Real t56 = s234 * c5 * t1 + link4_to_5_z * t19 + (J_4_yz + t4) * c234;
  const Real t57 = c5 * f5_x + s5 * minus_f5_y;
  const Real t58 = c2 * t54;

  // links 1 (shoulder) and 5 (wrist_2), mass matrix; link 4 (wrist_1), outward
  const Real t59 = t48 + t38 - t36 * t37 - t47 * t52;
  const Real minus_a4_z = minus_a3_z + t49 * t10;
  const Real t60 = 0.037099816387500005 * s234;
  const Real t61 = 1.0 / (t48 - t36 * t34 - t47 * t44);
  const Real t62 = c5 * t51;
  const Real t63 = minus_J_5_yz * t26 - 0.0085220910375 * c234 - link4_to_5_z * t22 - (t11 + t7) *
      t2;

  // link 6 (wrist_3), inertial wrench and inward
  const Real n6_x = 0.0003115 * (t40 * w5_z - t43);
  const Real minus_n6_z = J_6_zz * minus_wd5_y;
  const Real t64 = 2.07831527531 * s23;
  const Real t65 = c234 * t60;
  const Real n5_x = J_5_xx * t43 + minus_J_5_yz * (t31 - w5_y * w5_y) - h_5_y * minus_a5_z - n6_x;
  const Real n5_y = minus_J_5_yz * t39 - J_5_yy * (t42 + minus_wd5_y) - minus_n6_z;

  // link 5 (wrist_2), inward; link 1 (shoulder), mass matrix
  const Real t66 = c234 * t57 + s234 * f5_z;
  const Real t67 = c23 * t64;
  const Real t68 = J_3_xz * s23 + (t56 + t10 * t3) + t62;
  const Real t69 = t56 + t62 + t5 * t63;
  const Real f4_x = t66 - (t17 + t53) * t20;
  const Real t70 = t59 * t61;
  const Real f4_y = t53 * t18 + (s234 * t57 - c234 * f5_z);

  // links 4 (wrist_1) and 5 (wrist_2), outward; link 1 (shoulder), inward; link 6 (wrist_3),
  //   inertial wrench; link 1 (shoulder), mass matrix
  const Real a5_x = c5 * (c234 * a4_x + s234 * a4_y) - s5 * (minus_a4_z + link4_to_5_z * t17);
  const Real t71 = tau[0] - J_2_xz * t15 * c2 + t50 * t58 - J_3_xz * t12 * c23;
  const Real t72 = 2.0 * wd4_x;
  const Real n6_y = 0.0003115 * (t40 * w5_x - t39);
  const Real t73 = J_2_zz + t48 + 2.0 * t38 - t46 * t37 - t55 * t52 - t70 * t59;

  // link 1 (shoulder), mass matrix; link 5 (wrist_2), inward and inertial wrench
  const Real t74 = t68 - t36 * t63 - t47 * t69;
  const Real n4_z = t20 * a4_y + t18 * a4_x - t17 * t65 + (s5 * n5_x + c5 * n5_y);
  const Real t75 = J_5_zz * wd5_z - 0.005730591037500001 * t35 - minus_J_5_yz *
      (t42 - minus_wd5_y) - h_5_y * a5_x;
  const Real t76 = 1.0 / t73;
  const Real t77 = 117.34209310833121 * t63;

  // links 1 (shoulder) and 6 (wrist_3), inward; link 1 (shoulder), mass matrix
  const Real t78 = tau[5] + minus_n6_z;
  const Real n5_z = t75 + n6_y;
  const Real t79 = J_2_xz * s2 + t68 + t6 * t3 - t46 * t63 - t55 * t69;
  const Real t80 = t69 * t29;
  const Real t81 = c5 * t78;

  // links 1, 4 and 5, inward; link 1 (shoulder), mass matrix
  const Real n3_z = t17 * t67 + (t13 * a3_x - t16 * a3_y) + (n4_z + (t10 * f4_x - t11 * f4_y));
  const Real t82 = tau[4] - n5_z;
  const Real t83 = 0.0098370910375 + (6.9910934060975 - s2 * t54 - s23 * t64) + 0.031809629475 *
      c5 - t26 * t51;
  const Real t84 = t79 - t70 * t74;
  const Real t85 = t71 + t49 * t67 + t16 * minus_a3_z - t72 * t65 - t20 * minus_a4_z;
  const Real t86 = t74 * t61;
  const Real f3_x = t24 * t16 + f4_x;
  const Real t87 = t81 + n3_z;
  const Real f4_z = s5 * f5_x - c5 * minus_f5_y - t72 * t18;
  const Real f3_y = t12 * t13 + f4_y;
  const Real t88 = t84 * t76;
  const Real f3_z = f4_z - t49 * t13;

  // link 1 (shoulder), inward and mass matrix
  const Real t89 = tau[3] - n4_z - t81 + t5 * t82;
  const Real t90 = tau[1] - t17 * t58 + 81.988590645 * c2 - t87 - t6 * f3_x + t7 * f3_y;
  const Real t91 = t85 + c234 * n5_z - link4_to_5_z * t66 - t11 * f4_z - t7 * f3_z;
  const Real t92 = t83 - t77 * t63 - t80 * t69 - t86 * t74 - t88 * t84;
  const Real t93 = tau[2] - t87 - t36 * t82 - t47 * t89;
  const Real t94 = t92 - 2.0 * (t30 + t33) + (t60 -
      (s234 * (J_5_yy + t8) + c234 * (0.021392421525 * s5))) * s234;

  // link 1 (shoulder), inward
  const Real t95 = t90 - t46 * t82 - t55 * t89 - t70 * t93;
  const Real t96 = t91 + t26 * t78 - t77 * t82 - t80 * t89 - t86 * t93;
  const Real t97 = t96 - t88 * t95 + (J_4_yz * t53 - (c5 * n5_x - s5 * n5_y)) * s234;
  const Real qdd_0 = t97 * (1.0 / t94);
  qdd[0] = qdd_0;
  const Real qdd_1 = t95 * t76 - t88 * qdd_0;
  qdd[1] = qdd_1;
  const Real qdd_2 = t93 * t61 - t86 * qdd_0 - t70 * qdd_1;
  qdd[2] = qdd_2;
  const Real qdd_3 = t89 * t29 - t80 * qdd_0 - t55 * qdd_1 - t47 * qdd_2;
  qdd[3] = qdd_3;
  qdd[4] = 117.34209310833121 * t82 - t77 * qdd_0 - t46 * qdd_1 - t36 * qdd_2 + t5 * qdd_3;
  qdd[5] = 1605.1364365971108 * t78 + t26 * qdd_0 - (qdd_1 + qdd_2 + qdd_3) * c5;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
