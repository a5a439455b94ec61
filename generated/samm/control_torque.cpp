// SPDX-License-Identifier: 0BSD
// control_torque: tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J
//   qdd_0)
// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at
//   link origins.
// 1112 flops (add 459, mul 642, div 11), sine and cosine of 6 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "lanes.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

template <int count>
using Lanes = detail::Pack<Real, count>;
void control_torque(const Real (&TREELINE_RESTRICT q)[9], const Real (&TREELINE_RESTRICT qd)[9],
    const Real (&TREELINE_RESTRICT qdd_0)[9], const Real (&TREELINE_RESTRICT xdd_cmd)[6],
    Real (&TREELINE_RESTRICT tau)[9]) noexcept {
  // constants
  const Real minus_h_8_y = 0.0028799999999999997;
  const Real minus_link6_to_7_x = 0.0203;
  const Real minus_link6_to_7_y = 0.4331;
  const Real J_7_yy = 0.00065;
  const Real J_6_zz = 0.312455249;
  const Real minus_h_6_x = 0.025374999999999998;
  const Real minus_h_6_y = 0.861795;
  const Real link5_to_6_x = 0.4318;
  const Real J_6_yz = 0.004704000000000001;
  const Real link5_to_6_z = 0.1501;
  const Real minus_J_5_xz = 0.690314699;
  const Real minus_J_5_yz = 0.023750999999999998;
  const Real J_5_zz = 1.7481140020000001;
  const Real h_5_x = 3.79559;
  const Real h_5_y = 0.10439999999999999;
  const Real h_4_y = 4.9338049999999996;
  const Real J_6_yy = 0.0067651125;
  const Real mass_2 = 186.45;
  const Real minus_gravity_z = 9.81;
  const Real link9_to_tool_z = 0.05625;
  const Real minus_J_5_xy = 0.0070992;
  const Real minus_J_6_xy = 0.010673638499999999;
  const Real J_8_xx = 0.00042216;
  const Real J_8_yy = 2e-04;
  const Real J_9_zz = 4e-05;
  const Real J_7_zz = 0.0014;
  const Real J_7_xx = 0.0007499999999999999;
  const Real J_8_zz = 0.00062216;
  const Real J_3_zz = 7.2;

  // sines and cosines
  const Real angles[6] = {q[2], q[3], q[4], q[5], q[7], q[6]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s3 = sines[0];
  const Real s4 = sines[1];
  const Real s5 = sines[2];
  const Real c5 = cosines[2];
  const Real s6 = sines[3];
  const Real c6 = cosines[3];
  const Real s8 = sines[4];
  const Real c8 = cosines[4];
  const Real s7 = sines[5];
  const Real c7 = cosines[5];

  // link 8 (link5), articulated inertia
  const Real t1 = 0.00024216 * s8;
  const Real t2 = minus_h_8_y * s8;
  const Real t3 = 0.012916407125949918 * s8;
  const Real t4 = link5_to_6_x * c5;
  const Real t5 = link5_to_6_x * s5;
  const Real t6 = s8 * t1;
  const Real t7 = s8 * t3;
  const Real t8 = c8 * t3;
  const Real t9 = c8 * t1;
  const Real s56 = s5 * c6 + c5 * s6;
  const Real minus_c56 = s5 * s6 - c5 * c6;
  const Real t10 = minus_J_5_xz * s5 + minus_J_5_yz * c5;
  const Real t11 = t7 - 0.012916407125949918;

  // link 7 (link4), articulated inertia
  const Real t12 = c7 * t8;
  const Real t13 = s7 * t8;
  const Real inverse_D7 = 1.0 / (0.0015999999999999999 + t6);
  const Real t14 = s56 * c7;
  const Real t15 = J_6_yz * minus_c56;
  const Real t16 = minus_link6_to_7_x * s56 - minus_link6_to_7_y * minus_c56;
  const Real t17 = minus_link6_to_7_x * minus_c56 + minus_link6_to_7_y * s56;
  const Real t18 = minus_h_6_x * minus_c56 + minus_h_6_y * s56;
  const Real t19 = minus_h_6_x * s56 - minus_h_6_y * minus_c56;
  const Real t20 = h_5_x * s5 + h_5_y * c5;
  const Real t21 = 0.298925024 * s56 + 0.021347276999999998 * minus_c56;
  const Real t22 = 1.601861202 * s5 + 0.0141984 * c5;
  const Real t23 = t2 * inverse_D7;
  const Real t24 = t9 * inverse_D7;
  const Real t25 = t2 * t23;

  // links 5 (link2) and 7 (link4), articulated inertia
  const Real t26 = 3.1467171525 - (s5 * t22 - (J_6_yy + s56 * t21));
  const Real t27 = t9 * t23 - minus_h_8_y * c8;
  const Real t28 = 0.0011921599999999998 - t6 - t9 * t24;
  const Real t29 = s7 * (t11 + t25);
  const Real t30 = c7 * t27;

  // link 7 (link4), articulated inertia
  const Real t31 = s7 * (t28 - J_7_yy);
  const Real t32 = s7 * t29;
  const Real t33 = c7 * t30;
  const Real t34 = c7 * t29;
  const Real t35 = s7 * t30;
  const Real t36 = s7 * t31;
  const Real t37 = t11 - t32;
  const Real t38 = t33 - t27;
  const Real t39 = s56 * t35;
  const Real t40 = t32 - t25;
  const Real t41 = s56 * t33;
  const Real t42 = s56 * t38;
  const Real t43 = minus_c56 * t38;
  const Real t44 = minus_c56 * t34 - s56 * t13;
  const Real t45 = s56 * t34 + minus_c56 * t13;
  const Real t46 = s56 * t39;
  const Real t47 = minus_c56 * t39;
  const Real t48 = t17 * t45;
  const Real t49 = t17 * t40 - t41;
  const Real t50 = h_5_y * s5 - h_5_x * c5;
  const Real t51 = s56 * (t37 + t7) + minus_c56 * (2.0 * t12);
  const Real s34 = s3 * c4 + c3 * s4;
  const Real t52 = s56 * t51;
  const Real t53 = t35 - (t16 * t44 - t48);
  const Real c34 = c3 * c4 - s3 * s4;

  // links 7 (link4) and 8 (link5), force propagation; link 7 (link4), articulated inertia
  const Real t54 = 4.484863585399277 * s8;
  const Real neg_s8 = -s8;
  const Real t55 = t12 - minus_c56 * t51;
  const Real t56 = t52 - t7;
  const Real t57 = t37 - t52;

  // link 7 (link4), force propagation
  const Real t58 = -(4.484863585399277 * c8);
  const Lanes<8> t59_lanes = c7 * detail::make_pack<Real>(c8, c8, s8, c8, t58, c8, c8, c8);
  const Real t60 = minus_c56 * s7;
  const Real t61 = s56 * s7;
  const Real t63 = t23 * neg_s8;
  const Real t67 = s7 * t63;
  const Real t68 = c8 + t24 * neg_s8;
  const Lanes<8> t69_lanes = s56 * t59_lanes + minus_c56 *
      detail::make_pack<Real>(neg_s8, neg_s8, c8, neg_s8, t54, neg_s8, neg_s8, neg_s8);
  const Lanes<8> t70_lanes = minus_c56 * t59_lanes - s56 *
      detail::make_pack<Real>(neg_s8, neg_s8, c8, neg_s8, t54, neg_s8, neg_s8, neg_s8);

  // link 7 (link4), articulated inertia and force propagation
  const Real t71 = t42 + (t16 * t55 + t17 * t56);
  const Real t72 = t43 - (t16 * t57 + t17 * t55);
  const Real t73 = s56 * t67;
  const Real t74 = minus_c56 * t67;
  const Real t77 = s7 * t58;
  const Real t78 = c7 * t63;
  const Real t79 = t18 + t71;
  const Real t80 = t72 - t19;
  const Real t81 = t15 + (t17 * (t46 + t53) - t16 * t47 - t14 * t31);
  const Real t82 = s7 * s8;
  const Real t83 = s7 * c8;
  const Lanes<8> t84_lanes = detail::make_pack<Real>(t17, t16, t17, t17, t17, t17, t17, t17) *
      detail::make_pack<Real>(t69_lanes[0], t60, t69_lanes[2], t69_lanes[0], t69_lanes[4],
      t69_lanes[0], t69_lanes[0], t69_lanes[0]) - detail::make_pack<Real>(t16, t17, t16, t16, t16,
      t16, t16, t16) * detail::make_pack<Real>(t70_lanes[0], t61, t70_lanes[2], t70_lanes[0],
      t70_lanes[4], t70_lanes[0], t70_lanes[0], t70_lanes[0]);
  const Real t85 = s7 * t68 + (t17 * t73 - t16 * t74);
  const Real t86 = J_6_zz + (J_7_yy + t36 + (t17 * (t42 + t71) - t16 * (t43 + t72)));

  // link 6 (link3), articulated inertia and force propagation
  const Real inverse_D6 = 1.0 / t86;
  const Real t87 = t79 * inverse_D6;
  const Real t88 = t80 * inverse_D6;
  const Real t89 = t53 * inverse_D6;
  const Real t90 = t81 * inverse_D6;
  const Lanes<8> t95_lanes = detail::make_pack<Real>(t84_lanes[0], t84_lanes[1], t84_lanes[2], t85,
      t84_lanes[4], t84_lanes[0], t84_lanes[0], t84_lanes[0]) * inverse_D6;
  const Real t96 = t55 + t80 * t87;
  const Real t97 = t57 - t80 * t88;
  const Real t98 = t44 - t80 * t89;
  const Real t99 = t47 + t17 * t44 - t81 * t88;
  const Real t100 = t40 - t53 * t89;
  const Real t101 = t18 + t49 - t81 * t89;

  // links 5 (link2) and 6 (link3), articulated inertia; link 6 (link3), force propagation
  const Real t102 = t26 + s56 * (s56 * (t28 - t36)) + t17 * (t49 - t41) - t81 * t90;
  const Lanes<8> t103_lanes = detail::make_pack<Real>(t70_lanes[0], -t60, t70_lanes[2], t74,
      t70_lanes[4], t70_lanes[0], t70_lanes[0], t70_lanes[0]) - t88 *
      detail::make_pack<Real>(t84_lanes[0], t84_lanes[1], t84_lanes[2], t85, t84_lanes[4],
      t84_lanes[0], t84_lanes[0], t84_lanes[0]);
  const Lanes<8> t105_lanes = detail::make_pack<Real>(t83, c7, t82, -t78, t77, t83, t83, t83) -
      t89 * detail::make_pack<Real>(t84_lanes[0], t84_lanes[1], t84_lanes[2], t85, t84_lanes[4],
      t84_lanes[0], t84_lanes[0], t84_lanes[0]);
  const Real t110 = t4 * t96 - t5 * t97;
  const Real t113 = t4 * (t79 * t89 - t45) - t5 * t98;
  const Real t116 = t20 - t110;
  const Real t117 = t99 + (t4 * t98 + link5_to_6_z * t97);
  const Lanes<8> t118_lanes = t5 * t103_lanes - t4 *
      (detail::make_pack<Real>(-t69_lanes[0], t61, -t69_lanes[2], -t73, -t69_lanes[4],
      -t69_lanes[0], -t69_lanes[0], -t69_lanes[0]) + t87 *
      detail::make_pack<Real>(t84_lanes[0], t84_lanes[1], t84_lanes[2], t85, t84_lanes[4],
      t84_lanes[0], t84_lanes[0], t84_lanes[0]));
  const Real t119 = t101 + (t4 * t100 + link5_to_6_z * t98);
  const Real t121 = t4 * (t4 * (t56 - t79 * t87) - t5 * t96) - t5 * t110;
  const Lanes<8> t122_lanes = detail::make_pack<Real>(t17 * t83, t17 * c7, t17 * t82,
      -(t14 * t68 + t17 * t78), t17 * t77, t17 * t83, t17 * t83, t17 * t83) - t90 *
      detail::make_pack<Real>(t84_lanes[0], t84_lanes[1], t84_lanes[2], t85, t84_lanes[4],
      t84_lanes[0], t84_lanes[0], t84_lanes[0]) + (link5_to_6_z * t103_lanes + t4 * t105_lanes);
  const Real inverse_D5 = 1.0 / (J_5_zz + t121);
  const Real t123 = t5 * t99 - t4 * (t81 * t87 - (t46 + t48) + t113) - link5_to_6_z * t110;
  const Real t124 = t10 + t123;

  // link 5 (link2), articulated inertia and force propagation
  const Real t125 = t124 * inverse_D5;
  const Real t126 = t116 * inverse_D5;
  const Real t127 = t113 * inverse_D5;
  const Lanes<8> t128_lanes = t118_lanes * inverse_D5;
  const Real t135 = t102 + link5_to_6_z * (t99 + t117) + t4 * (t101 + t119) - t124 * t125;
  const Real t136 = t119 - t50 + t124 * t127;
  const Lanes<8> t137_lanes = t122_lanes - t125 * t118_lanes;

  // links 4 (link1) and 5 (link2), articulated inertia; link 4 (link1), force propagation
  const Real inverse_D4 = 1.0 / t135;
  const Real t143 = h_4_y + (t117 - t124 * t126);
  const Real t145 = t136 * inverse_D4;
  const Real t146 = t143 * inverse_D4;
  const Lanes<8> t147_lanes = t137_lanes * inverse_D4;

  // links 4 (link1) and 6 (link3), outward; link 4 (link1), articulated inertia
  const Real w4_z = qd[2] + qd[3];
  const Real w6_z = qd[4] + qd[5];
  const Real wd6_z = qdd_0[4] + qdd_0[5];
  const Real t153 = t143 * t145 - (t98 + t116 * t127);
  const Real t154 = t97 - t116 * t126 - t143 * t146;
  const Real t155 = t100 - t113 * t127 - t136 * t145;

  // link 4 (link1), force propagation; links 4 to 6, outward
  const Lanes<8> t156_lanes = -(t103_lanes - t126 * t118_lanes) + t146 * t137_lanes;
  const Lanes<8> t157_lanes = t105_lanes + t127 * t118_lanes - t145 * t137_lanes;
  const Real t161 = w4_z * w4_z;
  const Real t162 = qd[4] * qd[4];
  const Real t163 = neg_s8 * inverse_D7 * neg_s8 + t95_lanes[3] * t85 + t128_lanes[3] *
      t118_lanes[3] + t147_lanes[3] * t137_lanes[3];
  const Real t164 = w6_z * w6_z;
  const Real wd4_z = qdd_0[2] + qdd_0[3];
  const Real t169 = t161 + t162;
  const Real t170 = t161 + t164;
  const Real wd5_x = w4_z * qd[4];
  const Lanes<8> t171_lanes = s34 * t156_lanes + c34 * t157_lanes;
  const Real a4_x = c34 * qdd_0[0] + s34 * qdd_0[1];

  // links 5 (link2) and 6 (link3), outward; link 4 (link1), articulated inertia
  const Real wd6_x = w4_z * w6_z;
  const Real t173 = s34 * (t154 - t155) + c34 * (2.0 * t153);
  const Real t174 = 2.0 * wd5_x;
  const Real t175 = 2.0 * wd6_x;
  const Real a6_y = minus_gravity_z + (t162 * t5 - qdd_0[4] * t4);
  const Real t176 = s34 * t173;

  // links 4, 7, 9, outward; link 4 (link1), articulated inertia
  const Real t177 = minus_gravity_z + xdd_cmd[2];
  const Real a4_y = c34 * qdd_0[1] - s34 * qdd_0[0];
  const Real t178 = a6_y - (wd6_z * t17 + t164 * t16);
  const Real t179 = c34 * t173 - t153;
  const Real t180 = c34 * xdd_cmd[0] + s34 * xdd_cmd[1];

  // links 6 and 7, 9, outward; link 2 (base_y), articulated inertia
  const Real a6_x = t169 * t4 + qdd_0[4] * t5 + link5_to_6_z * wd4_z - a4_x;
  const Real t181 = s56 * w4_z;
  const Real t182 = c34 * xdd_cmd[1] - s34 * xdd_cmd[0];
  const Real t183 = a6_x + (t170 * t17 - wd6_z * t16);
  const Real inverse_D2 = 1.0 / (mass_2 + (t155 + t176));
  const Real w7_z = qd[6] - minus_c56 * w4_z;
  const Real a6_z = a4_y + (wd4_z * t4 - t174 * t5 - link5_to_6_z * t161);

  // links 7 to 9, outward
  const Real t184 = minus_c56 * t180 + s56 * t177;
  const Real t185 = minus_c56 * wd6_x - s56 * wd4_z;
  const Real w7_x = s7 * w6_z - c7 * t181;
  const Real t186 = a6_z + (wd4_z * t17 + t175 * t16);
  const Real t187 = minus_c56 * t177 - s56 * t180;
  const Real t188 = minus_c56 * t183 - s56 * t178;
  const Real t189 = c34 * xdd_cmd[3] + s34 * xdd_cmd[4];
  const Real minus_a7_z = s56 * t183 + minus_c56 * t178;
  const Real t190 = c34 * xdd_cmd[4] - s34 * xdd_cmd[3];
  const Real w8_x = c8 * w7_x - s8 * w7_z;
  const Real minus_w8_y = s8 * w7_x + c8 * w7_z;
  const Real t191 = s7 * t182 - c7 * t184;

  // link 7 (link4), outward; link 2 (base_y), articulated inertia and force propagation
  const Real w7_y = s7 * t181 + c7 * w6_z;
  const Real wd7_y = c7 * wd6_z - s7 * t185 - w7_x * qd[6];
  const Real a7_x = c7 * t188 + s7 * t186;
  const Real t192 = t179 * inverse_D2;
  const Lanes<8> t193_lanes = t171_lanes * inverse_D2;

  // links 7 to 9, outward
  const Real t194 = w8_x * minus_w8_y;
  const Real w9_z = minus_w8_y + qd[8];
  const Real t195 = minus_c56 * t189 + s56 * xdd_cmd[5];
  const Real t196 = w7_x * w7_y;
  const Real wd8_z = wd7_y + qdd_0[7];
  const Real wd7_z = qdd_0[6] - (s56 * wd6_x + minus_c56 * wd4_z);
  const Real w8_z = w7_y + qd[7];

  // link 2 (base_y), force propagation; links 8 (link5) and 9 (link6), outward
  const Lanes<8> t198_lanes = t193_lanes * t171_lanes[0];
  const Lanes<8> t199_lanes = t193_lanes * t171_lanes[1];
  const Lanes<8> t200_lanes = t193_lanes * t171_lanes[2];
  const Real t201 = w8_x * w9_z;
  const Real t202 = t194 + wd8_z;

  // link 7 (link4), outward; link 2 (base_y), force propagation
  const Real t203 = t196 - wd7_z;
  const Real t204 = c7 * t185 + s7 * wd6_z + (w7_z + qd[6]) * w7_y;
  const Lanes<8> t205_lanes = c34 * t156_lanes - s34 * t157_lanes - t192 * t171_lanes;
  const Lanes<8> t206_lanes = t95_lanes * t84_lanes[0] + t128_lanes * t118_lanes[0] + t147_lanes *
      t137_lanes[0] + t198_lanes;
  const Lanes<8> t207_lanes = t95_lanes * t84_lanes[1] + t128_lanes * t118_lanes[1] + t147_lanes *
      t137_lanes[1] + t199_lanes;
  const Lanes<8> t208_lanes = t95_lanes * t84_lanes[2] + t128_lanes * t118_lanes[2] + t147_lanes *
      t137_lanes[2] + t200_lanes;

  // link 9 (link6), outward; link 1 (base_x), articulated inertia; link 2 (base_y), force
  //   propagation
  const Real wd9_y = t202 - t201;
  const Real t209 = minus_c56 * xdd_cmd[5] - s56 * t189;
  const Real inverse_D1 = 1.0 / (mass_2 + (t154 - t176) - t179 * t192);
  const Real t210 = s7 * t190 - c7 * t195;
  const Real t211 = w8_z * w9_z;
  const Real t212 = 1557.24430048586 + t95_lanes[4] * t84_lanes[4] + t128_lanes[4] * t118_lanes[4] +
      t147_lanes[4] * t137_lanes[4] + t193_lanes[4] * t171_lanes[4];

  // links 7 to 9, outward
  const Real a8_x = c8 * a7_x + s8 * minus_a7_z;
  const Real t213 = s7 * t195 + c7 * t190 - wd9_y;
  const Real a7_y = c7 * t186 - s7 * t188;
  const Real t214 = s8 * t203 + c8 * t204 - 2.0 * (minus_w8_y * w8_z);
  const Real t215 = w8_x * w8_x + w8_z * w8_z;
  const Real wd9_x = t211 + t214;
  const Real t216 = c8 * t191 + s8 * t187 - a8_x - link9_to_tool_z * (t202 + t213);
  const Real t217 = c8 * t210 + s8 * t209 - wd9_x;

  // link 1 (base_x), force propagation
  const Lanes<8> t218_lanes = t205_lanes * inverse_D1;
  const Lanes<8> t222_lanes = t206_lanes + t218_lanes * t205_lanes[0];
  const Real t225 = t95_lanes[4] * t85 + t128_lanes[4] * t118_lanes[3] + t147_lanes[4] *
      t137_lanes[3] + t193_lanes[4] * t171_lanes[3] + t218_lanes[4] * t205_lanes[3];
  const Real t226 = t222_lanes[0] * t222_lanes[0];
  const Real t227 = t226 * t222_lanes[0];
  const Real t228 = t227 * t226 / (7.52316384526264e-37 + t227 * t227);
  const Lanes<8> t229_lanes = t222_lanes * t228;
  const Lanes<8> t232_lanes = t207_lanes + t218_lanes * t205_lanes[1] - t229_lanes * t222_lanes[1];
  const Real t234 = c5 * t22 - minus_J_5_xy;
  const Real t235 = t232_lanes[1] * t232_lanes[1];
  const Real t236 = s7 * t184 + c7 * t182 - a7_y - t229_lanes[1] * t216 + link9_to_tool_z *
      (t214 + t217);
  const Real t237 = t235 * t232_lanes[1];
  const Real t238 = minus_c56 * t21 - minus_J_6_xy;

  // link 8 (link5), outward; link 5 (link2), inward; link 9 (link6), inertial wrench
  const Real t239 = w8_x * w8_z;
  const Real t240 = qdd_0[4] * t10 - h_4_y * a4_x - t174 * t234 - t162 *
      (minus_J_5_yz * s5 - minus_J_5_xz * c5);
  const Real wd8_y = c8 * t203 - s8 * t204 - t239;
  const Real minus_n9_z = J_9_zz * (c8 * t209 - s8 * t210);
  tau[8] = -minus_n9_z;

  // link 1 (base_x), force propagation; links 5 (link2) and 9 (link6), inward
  const Real t241 = t237 * t235 / (4.81482486096809e-35 + t237 * t237);
  const Real minus_n8_y = J_8_yy * (t239 - wd8_y) - minus_n9_z;
  const Real t242 = t240 - t50 * a4_y + wd6_z * t15 - t175 * t238 + t18 * a6_z;
  const Lanes<8> t243_lanes = t232_lanes * t241;
  const Lanes<8> t245_lanes = t208_lanes + t218_lanes * t205_lanes[2] - t229_lanes * t222_lanes[2] -
      t243_lanes * t232_lanes[2];
  const Real t246 = t163 + t193_lanes[3] * t171_lanes[3] + t218_lanes[3] * t205_lanes[3] -
      t229_lanes[3] * t222_lanes[3] - t243_lanes[3] * t232_lanes[3];
  const Real t247 = t245_lanes[2] * t245_lanes[2];
  const Real t248 = link9_to_tool_z * t215 - t229_lanes[2] * t216 - t243_lanes[2] * t236 +
      (t191 - a7_x) * s8;

  // link 1 (base_x), force propagation; links 5 (link2) and 6 (link3), inertial wrench
  const Real t249 = t247 * t245_lanes[2];
  const Real t250 = t248 + (minus_a7_z - t187) * c8;
  const Real t251 = J_6_zz * wd6_z + wd4_z * t15 + t161 * t238 - (t18 * a6_y + t19 * a6_x);
  const Real t252 = t249 * t247 / (1.1754943508222875e-38 + t249 * t249);
  const Real t253 = J_5_zz * qdd_0[4] + wd4_z * t10 + t161 * t234 +
      (minus_gravity_z * t50 - t20 * a4_x);

  // link 1 (base_x), force propagation
  const Real t254 = t245_lanes[3] * t252;
  const Real t255 = t245_lanes[4] * t252;
  const Real t256 = t246 - t254 * t245_lanes[3];
  const Real t257 = t225 - t229_lanes[4] * t222_lanes[3] - t243_lanes[4] * t232_lanes[3] - t255 *
      t245_lanes[3];
  const Real t258 = t212 + t218_lanes[4] * t205_lanes[4] - t229_lanes[4] * t222_lanes[4] -
      t243_lanes[4] * t232_lanes[4] - t255 * t245_lanes[4];
  const Real t259 = t217 - t229_lanes[3] * t216 - t243_lanes[3] * t236 - t254 * t250;
  const Real t260 = t256 * t256;
  const Real t261 = t260 * t256;
  const Real t262 = t261 * t260 / (3.552713678800501e-15 + t261 * t261);
  const Real t263 = t257 * t262;
  const Real t264 = t258 - t263 * t257;
  const Real t265 = t213 - t229_lanes[4] * t216 - t243_lanes[4] * t236 - t255 * t250 - t263 * t259;
  const Real t266 = t264 * t264;
  const Real t267 = t266 * t264;
  const Real t268 = t265 * (t267 * t266 / (1.4551915228366852e-11 + t267 * t267));

  // link 9 (link6), inertial wrench; link 1 (base_x), force propagation; link 9 (link6), inward
  const Real n9_y = t268 - 2e-05 * (t201 - wd9_y);
  const Real t269 = t259 * t262 - t263 * t268;
  const Real n8_z = 0.00022215999999999997 * t194 + J_8_zz * wd8_z + minus_h_8_y * a8_x + n9_y;
  tau[7] = n8_z;
  const Real n9_x = 2e-05 * (t211 + wd9_x) + t269;

  // links 8 (link5) and 9 (link6), inward; link 1 (base_x), force propagation
  const Real n7_y = n8_z - J_7_yy * (w7_x * w7_z - wd7_y);
  const Real n8_x = J_8_xx * t214 - minus_h_8_y * a7_y + n9_x;
  const Real f9_z = t250 * t252 - t254 * t269 - t255 * t268;
  const Real f8_y = minus_h_8_y * t215 - f9_z;
  const Real n7_x = J_7_xx * t204 + (c8 * n8_x + s8 * minus_n8_y);
  const Real n7_z = J_7_zz * wd7_z - 9.999999999999996e-05 * t196 + (c8 * minus_n8_y - s8 * n8_x);
  tau[6] = n7_z;
  const Real f9_y = t236 * t241 - t243_lanes[2] * f9_z - t243_lanes[3] * t269 - t243_lanes[4] *
      t268;
  const Real f8_z = f9_y - minus_h_8_y * t214;
  const Real f9_x = t216 * t228 - t229_lanes[1] * f9_y - t229_lanes[2] * f9_z - t229_lanes[3] *
      t269 - t229_lanes[4] * t268;
  const Real f8_x = minus_h_8_y * t202 + f9_x;
  const Real minus_f7_x = s8 * f8_y - c8 * f8_x;
  const Real minus_f7_z = s8 * f8_x + c8 * f8_y;

  // links 5 to 7, inward
  const Real t270 = c7 * minus_f7_x + s7 * f8_z;
  const Real t271 = c7 * f8_z - s7 * minus_f7_x;
  const Real f6_z = wd4_z * t18 + t175 * t19 + t271;
  const Real f5_z = f6_z - (wd4_z * t50 + t174 * t20);
  const Real t272 = s56 * minus_f7_z - minus_c56 * t270;
  const Real t273 = s56 * t270 + minus_c56 * minus_f7_z;
  const Real f4_y = f5_z - h_4_y * t161;
  const Real f6_x = t170 * t18 - wd6_z * t19 + t272;
  const Real f6_y = t273 - (wd6_z * t18 + t164 * t19);
  const Real f5_x = qdd_0[4] * t20 - t169 * t50 + f6_x;
  const Real minus_f4_x = h_4_y * wd4_z + f5_x;
  const Real t274 = t242 + t17 * t271 - minus_c56 * n7_z + link5_to_6_z * f6_x + t4 * f6_z;
  const Real n6_z = t251 + (s7 * n7_x + c7 * n7_y - (t17 * t273 + t16 * t272));
  tau[5] = n6_z;

  // links 3 to 5, inward
  const Real minus_f3_x = c34 * minus_f4_x + s34 * f4_y;
  const Real f3_y = c34 * f4_y - s34 * minus_f4_x;
  const Real n4_z = t274 + (J_6_yz * t164 - (c7 * n7_x - s7 * n7_y)) * s56 + t26 * wd4_z;
  tau[3] = n4_z;
  const Real f2_x = mass_2 * qdd_0[0] - minus_f3_x;
  tau[0] = f2_x;
  const Real f2_z = mass_2 * qdd_0[1] + f3_y;

  // links 3 and 4, 6, inward
  tau[1] = f2_z;
  const Real n5_z = t253 + (n6_z + (t5 * f6_x - t4 * f6_y));
  tau[4] = n5_z;
  const Real n3_z = J_3_zz * qdd_0[2] + n4_z;
  tau[2] = n3_z;
}

}  // namespace samm

#undef TREELINE_RESTRICT
