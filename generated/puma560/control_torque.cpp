// SPDX-License-Identifier: 0BSD
// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J
//   qdd_0)
// By resolved acceleration, spherical wrist, by pivots, J in the axes of link 1 (link1) and the
//   axes of link 5 (link5).
// 468 flops (add 191, mul 274, div 3), sine and cosine of 5 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void control_torque(const Real (&TREELINE_RESTRICT q)[6], const Real (&TREELINE_RESTRICT qd)[6],
    const Real (&/*qdd_0*/)[6], const Real (&TREELINE_RESTRICT xdd_cmd)[6],
    Real (&TREELINE_RESTRICT tau)[6]) noexcept {
  // constants
  const Real minus_link3_to_4_x = 0.0203;
  const Real minus_link3_to_4_y = 0.4331;
  const Real link2_to_3_x = 0.4318;
  const Real minus_gravity_z = 9.81;
  const Real link2_to_3_z = 0.1501;
  const Real link6_to_tool_z = 0.05625;
  const Real minus_h_5_y = 0.0028799999999999997;
  const Real J_5_xx = 0.00042216;
  const Real J_6_zz = 4e-05;
  const Real minus_J_2_xz = 0.690314699;
  const Real minus_J_2_yz = 0.023750999999999998;
  const Real minus_J_2_xy = 0.0070992;
  const Real J_5_yy = 2e-04;
  const Real J_3_yz = 0.004704000000000001;
  const Real minus_h_3_x = 0.025374999999999998;
  const Real minus_h_3_y = 0.861795;
  const Real J_4_zz = 0.0014;
  const Real minus_J_3_xy = 0.010673638499999999;
  const Real J_4_xx = 0.0007499999999999999;
  const Real J_5_zz = 0.00062216;
  const Real J_4_yy = 0.00065;
  const Real J_3_yy = 0.0067651125;
  const Real J_3_zz = 0.312455249;
  const Real J_2_zz = 1.7481140020000001;
  const Real h_2_y = 0.10439999999999999;
  const Real h_2_x = 3.79559;

  // sines and cosines
  const Real angles[5] = {q[1], q[2], q[0], q[4], q[3]};
  Real sines[5];
  Real cosines[5];
  detail::sin_cos(angles, sines, cosines);
  const Real s2 = sines[0];
  const Real s3 = sines[1];
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real c1 = cosines[2];
  const Real s1 = sines[2];
  const Real c5 = cosines[3];
  const Real s4 = sines[4];
  const Real c4 = cosines[4];
  const Real s5 = sines[3];

  // links 1 to 3, outward
  const Real w3_z = qd[1] + qd[2];
  const Real t1 = link2_to_3_x * s2;
  const Real t2 = qd[0] * qd[0];
  const Real t3 = qd[1] * qd[1];
  const Real t4 = link2_to_3_x * c2;
  const Real wd2_x = qd[0] * qd[1];

  // link 5 (link5), pose; links 2 (link2) and 3 (link3), outward
  const Real t5 = c5 * s4;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real minus_c23 = s2 * s3 - c2 * c3;
  const Real t6 = w3_z * w3_z;
  const Real wd3_x = qd[0] * w3_z;
  const Real t7 = 2.0 * wd2_x;
  const Real t8 = s5 * s4;

  // links 3 (link3) and 4 (link4), outward
  const Real t9 = s23 * qd[0];
  const Real t10 = t2 + t6;
  const Real a3_x = (t2 + t3) * t4;
  const Real t11 = minus_c23 * wd3_x;
  const Real a3_y = minus_gravity_z + t3 * t1;
  const Real t12 = 2.0 * wd3_x;
  const Real minus_wd4_z = s23 * wd3_x;

  // link 4 (link4), pose and outward
  const Real t13 = c4 * minus_c23;
  const Real t14 = c4 * s23;
  const Real t15 = minus_link3_to_4_x * s23 - minus_link3_to_4_y * minus_c23;
  const Real t16 = minus_link3_to_4_x * minus_c23 + minus_link3_to_4_y * s23;
  const Real w4_z = qd[3] - minus_c23 * qd[0];
  const Real t17 = s4 * minus_c23;
  const Real t18 = s4 * s23;
  const Real t19 = t6 * t15;

  // links 3 (link3) and 4 (link4), outward
  const Real t20 = t12 * t15;
  const Real minus_a3_z = t7 * t1 + link2_to_3_z * t2;
  const Real w4_y = s4 * t9 + c4 * w3_z;
  const Real t21 = t10 * t16;
  const Real w4_x = s4 * w3_z - c4 * t9;

  // link 3 (link3), Jacobian; link 4 (link4), pose and outward
  const Real t22 = t16 + t4;
  const Real t23 = t15 - t1;
  const Real t24 = a3_y - t19;
  const Real t25 = a3_x + t21;
  const Real t26 = w4_x * w4_y;

  // links 4 (link4) and 5 (link5), outward; link 1 (link1), Jacobian; link 5 (link5), pose
  const Real w5_z = w4_y + qd[4];
  const Real t27 = t20 - minus_a3_z;
  const Real t28 = w4_x * qd[3];
  const Real t29 = t22 * t22;
  const Real t30 = c5 * t13 + s5 * s23;
  const Real t31 = s5 * minus_c23 - c5 * t14;
  const Real t32 = s5 * t13 - c5 * s23;
  const Real t33 = w4_y * w4_z + w4_y * qd[3];
  const Real minus_w5_y = s5 * w4_x + c5 * w4_z;
  const Real t34 = t26 + minus_wd4_z;
  const Real w5_x = c5 * w4_x - s5 * w4_z;
  const Real minus_wd4_y = s4 * t11 + t28;
  const Real t35 = t29 * t29;
  const Real t36 = s5 * t14 + c5 * minus_c23;

  // links 4 to 6, outward
  const Real t37 = t33 + c4 * t11;
  const Real w6_z = minus_w5_y + qd[5];
  const Real t38 = minus_c23 * t25 - s23 * t24;
  const Real t39 = w5_x * minus_w5_y;
  const Real minus_a4_z = s23 * t25 + minus_c23 * t24;
  const Real t40 = w5_x * w5_z;
  const Real t41 = w5_x * w6_z;
  const Real t42 = w5_z * w6_z;
  const Real t43 = 2.0 * (minus_w5_y * w5_z);
  const Real t44 = minus_wd4_y - t39;
  const Real t45 = w5_x * w5_x + w5_z * w5_z;

  // link 6 (link6), pose; links 4 (link4) and 6 (link6), outward
  const Real t46 = link6_to_tool_z * t36;
  const Real t47 = link6_to_tool_z * t32;
  const Real a4_x = c4 * t38 + s4 * t27;
  const Real minus_wd6_y = t44 + t41;
  const Real a4_y = c4 * t27 - s4 * t38;

  // link 1 (link1), Jacobian; links 5 (link5) and 6 (link6), outward; link 6 (link6), pose
  const Real t48 = t23 * t16 - t22 * t15;
  const Real t49 = s5 * t34 + c5 * t37 - t43;
  const Real wd5_y = c5 * t34 - s5 * t37 - t40;
  const Real t50 = link6_to_tool_z * t8;
  const Real t51 = t48 * t48;
  const Real wd6_x = t42 + t49;
  const Real a5_x = c5 * a4_x + s5 * minus_a4_z;
  const Real a5_y = c5 * minus_a4_z - s5 * a4_x;

  // link 1 (link1), Jacobian; link 6 (link6), pose
  const Real t52 = s5 * s5;
  const Real t53 = t51 * t51;
  const Real t54 = a4_y - link6_to_tool_z * t49;
  const Real t55 = a5_x - link6_to_tool_z * t44;
  const Real t56 = a5_y + link6_to_tool_z * t45;
  const Real t57 = t52 * t52;
  const Real t58 = xdd_cmd[5] - (t31 * wd6_x - t18 * minus_wd6_y + t36 * wd5_y);
  const Real t59 = c1 * xdd_cmd[3] + s1 * xdd_cmd[4] -
      (t32 * wd5_y - (t30 * wd6_x + t17 * minus_wd6_y));
  const Real t60 = c1 * xdd_cmd[4] - s1 * xdd_cmd[3] - (t5 * wd6_x - c4 * minus_wd6_y - t8 * wd5_y);
  const Real t61 = c1 * xdd_cmd[1] - s1 * xdd_cmd[0] - (t5 * t55 + c4 * t54 - t8 * t56);
  const Real t62 = c1 * xdd_cmd[0] + s1 * xdd_cmd[1] - (t17 * t54 - t30 * t55 + t32 * t56);
  const Real t63 = 1.601861202 * s2 + 0.0141984 * c2;

  // link 5 (link5), inertial wrench; link 6 (link6), pose
  const Real t64 = minus_J_2_xz * s2 + minus_J_2_yz * c2;
  const Real t65 = J_3_yz * minus_c23;
  const Real f5_y = minus_h_5_y * t45;
  const Real t66 = 0.298925024 * s23 + 0.021347276999999998 * minus_c23;
  const Real t67 = minus_gravity_z + xdd_cmd[2] - (t31 * t55 + t18 * t54 + t36 * t56) -
      (t59 * t50 + t60 * t47);

  // link 1 (link1), Jacobian
  const Real wd1_z = t35 * (t29 * t22) / (3.2311742677852644e-27 + t35 * t35) *
      (t61 - (t59 * t46 - t58 * t47));
  const Real t68 = c2 * t63 - minus_J_2_xy;
  const Real t69 = minus_h_3_x * minus_c23 + minus_h_3_y * s23;
  const Real t70 = link2_to_3_z * wd1_z;
  const Real t71 = t58 - wd1_z;
  const Real t72 = minus_c23 * t66 - minus_J_3_xy;
  const Real t73 = minus_h_3_x * s23 - minus_h_3_y * minus_c23;
  const Real t74 = t62 + (t60 * t46 + t58 * t50) + t70;

  // links 3 (link3) and 4 (link4), outward; link 1 (link1), Jacobian
  const Real t75 = t11 - s23 * wd1_z;
  const Real a3_z = wd1_z * t4 - minus_a3_z;
  const Real t76 = minus_c23 * t59 + s23 * t71;
  const Real t77 = minus_c23 * t71 - s23 * t59;
  const Real t78 = a3_z + (wd1_z * t16 + t20);
  const Real wd2_z = t53 * (t51 * t48) / (4.930380657631324e-32 + t53 * t53) *
      (t67 * t15 + t74 * t16);

  // link 3 (link3), outward; link 2 (link2), inward; link 1 (link1), Jacobian
  const Real a3_y_2 = a3_y - wd2_z * t4;
  const Real a3_x_2 = a3_x + wd2_z * t1 + t70;
  const Real t79 = wd2_z * t64 - t7 * t68 - t3 * (minus_J_2_yz * s2 - minus_J_2_xz * c2);
  const Real t80 = 5.319496967088805 * ((t74 - t23 * wd2_z) * t15 - (t67 + t22 * wd2_z) * t16);
  const Real wd3_z = wd2_z + t80;

  // link 1 (link1), Jacobian; link 4 (link4), outward
  const Real t81 = t60 - wd3_z;
  const Real t82 = t33 + c4 * t75 + s4 * wd3_z;
  const Real t83 = s4 * t81 - c4 * t76;
  const Real t84 = a3_x_2 + (t21 - wd3_z * t15);
  const Real t85 = a3_y_2 - (wd3_z * t16 + t19);
  const Real wd4_y = c4 * wd3_z - s4 * t75 - t28;

  // links 4 (link4) and 5 (link5), outward; link 3 (link3), inertial wrench
  const Real wd5_z = wd4_y + (s4 * t76 + c4 * t81);
  const Real t86 = J_3_zz * wd3_z + wd1_z * t65 + t2 * t72 - (t69 * a3_y_2 + t73 * a3_x_2);
  const Real t87 = minus_c23 * t84 - s23 * t85;
  const Real t88 = t39 + wd5_z;
  const Real minus_a4_z_2 = s23 * t84 + minus_c23 * t85;

  // link 1 (link1), Jacobian; links 2 (link2) and 5 (link5), inertial wrench; link 4 (link4),
  //   outward
  const Real t89 = t57 * (t52 * s5) / (8.271806125530277e-25 + t57 * t57) * (c5 * t83 + s5 * t77);
  const Real f5_x = minus_h_5_y * t88;
  const Real t90 = J_2_zz * wd2_z + wd1_z * t64 + t2 * t68 + minus_gravity_z *
      (h_2_y * s2 - h_2_x * c2);
  const Real minus_wd4_z_2 = minus_wd4_z + minus_c23 * wd1_z + t89;
  const Real a4_y_2 = c4 * t78 - s4 * t87;

  // link 4 (link4), outward; link 6 (link6), inertial wrench; link 5 (link5), inward
  const Real a4_x_2 = c4 * t87 + s4 * t78;
  const Real minus_n6_y = 2e-05 * (2.0 * t41 - t88);
  const Real t91 = t26 + minus_wd4_z_2;
  const Real minus_f4_x = s5 * f5_y - c5 * f5_x;
  const Real minus_f4_z = s5 * f5_x + c5 * f5_y;

  // link 5 (link5), outward and inertial wrench; link 6 (link6), inward
  const Real a5_x_2 = c5 * a4_x_2 + s5 * minus_a4_z_2;
  const Real wd5_y_2 = c5 * t91 - s5 * t82 - t40;
  const Real t92 = s5 * t91 + c5 * t82 - t43;
  const Real minus_f5_z = minus_h_5_y * t92;
  const Real n5_z = 0.00022215999999999997 * t39 + J_5_zz * wd5_z + minus_h_5_y * a5_x_2 -
      minus_n6_y;
  tau[4] = n5_z;

  // link 6 (link6), outward and inertial wrench; link 5 (link5), inward
  const Real minus_wd6_z = wd5_y_2 - s5 * t83 + (t77 - t89) * c5;
  const Real n6_x = 2e-05 * (t92 + 2.0 * t42);
  const Real n4_y = n5_z - J_4_yy * (w4_x * w4_z - wd4_y);
  const Real minus_n6_z = J_6_zz * minus_wd6_z;
  tau[5] = -minus_n6_z;

  // links 4 (link4) and 6 (link6), inward
  const Real n5_x = J_5_xx * t92 - minus_h_5_y * a4_y_2 + n6_x;
  const Real t93 = s4 * minus_f5_z - c4 * minus_f4_x;
  const Real t94 = s4 * minus_f4_x + c4 * minus_f5_z;
  const Real n5_y = minus_n6_z - J_5_yy * (t40 - wd5_y_2);
  const Real f3_z = wd1_z * t69 + t12 * t73 - t94;
  const Real t95 = minus_c23 * t93 + s23 * minus_f4_z;
  const Real t96 = minus_c23 * minus_f4_z - s23 * t93;
  const Real f3_x = t10 * t69 - wd3_z * t73 + t95;
  const Real f3_y = t96 - (wd3_z * t69 + t6 * t73);

  // links 2, 4 and 5, inward
  const Real minus_n4_z = 9.999999999999996e-05 * t26 + J_4_zz * minus_wd4_z_2 +
      (s5 * n5_x + c5 * n5_y);
  tau[3] = -minus_n4_z;
  const Real n4_x = J_4_xx * t82 - (s5 * n5_y - c5 * n5_x);
  const Real t97 = t79 + wd3_z * t65 - t12 * t72 + t69 * a3_z + minus_c23 * minus_n4_z;
  const Real n3_z = t86 + (s4 * n4_x + c4 * n4_y - (t16 * t96 + t15 * t95));
  tau[2] = n3_z;

  // links 2 (link2) and 3 (link3), inward
  const Real t98 = t97 - t16 * t94 + link2_to_3_z * f3_x + t4 * f3_z +
      (J_3_yz * t6 - (c4 * n4_x - s4 * n4_y)) * s23;
  const Real n2_z = t90 + (n3_z + (t1 * f3_x - t4 * f3_y));
  tau[1] = n2_z;
  const Real n1_z = t98 + (3.1467171525 - s2 * t63 + (J_3_yy + s23 * t66)) * wd1_z;
  tau[0] = n1_z;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
