// forward_kinematics: x_world = R x_point + p, for every operational point
// By outward recursion.
// 98 flops (add 34, mul 64, div 0), sine and cosine of 6 angles
// Generated; see ur10e.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "ur10e.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace ur10e {

void forward_kinematics(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT position)[3],
    Real (&TREELINE_RESTRICT rotation)[9]) noexcept {
  const Real angles[6] = {q[0], q[1], q[2], q[3], q[4], q[5]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real s1 = sines[0];
  const Real c2 = cosines[1];
  const Real c1 = cosines[0];
  const Real c3 = cosines[2];
  const Real s3 = sines[2];
  const Real s2 = sines[1];
  const Real s4 = sines[3];
  const Real c4 = cosines[3];
  const Real c5 = cosines[4];
  const Real s5 = sines[4];
  const Real c6 = cosines[5];
  const Real s6 = sines[5];

  // link 2 (upper_arm), pose
  const Real rotation_2_p1 = c2 * c1;
  const Real rotation_2_p2 = s2 * c1;
  const Real rotation_5_p1 = c2 * s1;
  const Real rotation_5_p2 = s2 * s1;

  // link 3 (forearm), pose
  const Real rotation_8_p1 = c3 * c2 - s3 * s2;
  const Real rotation_8_p2 = c3 * s2 + s3 * c2;
  const Real minus_p3_x = 0.6127 * rotation_2_p1;
  const Real minus_p3_y = 0.6127 * rotation_5_p1;
  const Real p3_z = 0.1807 - 0.6127 * s2;
  const Real rotation_2_p3 = c3 * rotation_2_p1 - s3 * rotation_2_p2;
  const Real rotation_2_p4 = s3 * rotation_2_p1 + c3 * rotation_2_p2;
  const Real rotation_5_p3 = c3 * rotation_5_p1 - s3 * rotation_5_p2;
  const Real rotation_5_p4 = s3 * rotation_5_p1 + c3 * rotation_5_p2;

  // link 4 (wrist_1), pose
  const Real rotation_8_p3 = c4 * rotation_8_p2 + s4 * rotation_8_p1;
  const Real p6_z_p1 = c4 * rotation_8_p1 - s4 * rotation_8_p2;
  const Real p4_z = p3_z - 0.57155 * rotation_8_p2;
  const Real rotation_2_p5 = c4 * rotation_2_p3 - s4 * rotation_2_p4;
  const Real p6_x_p1 = s4 * rotation_2_p3 + c4 * rotation_2_p4;
  const Real rotation_5_p5 = c4 * rotation_5_p3 - s4 * rotation_5_p4;
  const Real p6_y_p1 = s4 * rotation_5_p3 + c4 * rotation_5_p4;

  // link 5 (wrist_2), pose
  const Real rotation_8 = s5 * rotation_8_p3;
  rotation[8] = -rotation_8;
  const Real rotation_6_p1 = c5 * rotation_8_p3;

  // link 4 (wrist_1), pose
  const Real minus_p4_x = minus_p3_x + 0.57155 * rotation_2_p3;
  const Real minus_p4_y = minus_p3_y + 0.57155 * rotation_5_p3;

  // link 5 (wrist_2), pose
  const Real p5_x = 0.17415 * s1 - minus_p4_x;
  const Real minus_p5_y = minus_p4_y + 0.17415 * c1;
  const Real rotation_2 = c5 * s1 - s5 * rotation_2_p5;
  rotation[2] = rotation_2;
  const Real rotation_0_p1 = c5 * rotation_2_p5 + s5 * s1;

  // link 6 (wrist_3), pose
  const Real p6_z = p4_z - 0.11985 * p6_z_p1;

  // link 5 (wrist_2), pose
  const Real rotation_5 = s5 * rotation_5_p5 + c5 * c1;
  rotation[5] = -rotation_5;
  const Real rotation_3_p1 = c5 * rotation_5_p5 - s5 * c1;

  // link 6 (wrist_3), pose
  const Real p6_x = p5_x + 0.11985 * p6_x_p1;
  const Real p6_y = 0.11985 * p6_y_p1 - minus_p5_y;
  position[2] = p6_z - 0.11655 * rotation_8;
  rotation[6] = c6 * rotation_6_p1 + s6 * p6_z_p1;
  rotation[7] = c6 * p6_z_p1 - s6 * rotation_6_p1;
  position[0] = p6_x + 0.11655 * rotation_2;
  rotation[0] = c6 * rotation_0_p1 - s6 * p6_x_p1;
  rotation[1] = -(s6 * rotation_0_p1 + c6 * p6_x_p1);
  position[1] = p6_y - 0.11655 * rotation_5;
  rotation[3] = c6 * rotation_3_p1 - s6 * p6_y_p1;
  rotation[4] = -(s6 * rotation_3_p1 + c6 * p6_y_p1);
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
