// forward_kinematics: x_world = R x_point + p, for every operational point
// By outward recursion.
// 73 flops (add 25, mul 48, div 0), sine and cosine of 6 angles
// Generated; see ur10e.hpp for the contract.
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
  const Real c1 = cosines[0];
  const Real c2 = cosines[1];
  const Real c3 = cosines[2];
  const Real s2 = sines[1];
  const Real s3 = sines[2];
  const Real c4 = cosines[3];
  const Real s4 = sines[3];
  const Real c5 = cosines[4];
  const Real s5 = sines[4];
  const Real c6 = cosines[5];
  const Real s6 = sines[5];
  const Real rotation_2_p1 = s2 * c3 + c2 * s3;
  const Real rotation_2_p2 = c2 * c3 - s2 * s3;

  // link 3 (forearm), pose
  const Real p3_z = 0.1807 - 0.6127 * s2;
  const Real rotation_2_p3 = rotation_2_p2 * c4 - rotation_2_p1 * s4;
  const Real position_0_p1 = rotation_2_p1 * c4 + rotation_2_p2 * s4;

  // link 6 (wrist_3), pose
  const Real position_0_p2 = 0.6127 * c2 + 0.57155 * rotation_2_p2;

  // link 4 (wrist_1), pose
  const Real p4_z = p3_z - 0.57155 * rotation_2_p1;
  const Real rotation_2_p4 = rotation_2_p3 * c1;
  const Real rotation_5_p1 = rotation_2_p3 * s1;
  const Real position_0_p3 = position_0_p1 * c1;
  const Real position_1_p1 = position_0_p1 * s1;

  // link 5 (wrist_2), pose
  const Real rotation_8 = s5 * position_0_p1;
  rotation[8] = -rotation_8;
  const Real rotation_6_p1 = c5 * position_0_p1;

  // link 6 (wrist_3), pose
  const Real p6_z = p4_z - 0.11985 * rotation_2_p3;

  // link 5 (wrist_2), pose
  const Real rotation_2 = c5 * s1 - s5 * rotation_2_p4;
  rotation[2] = rotation_2;
  const Real rotation_5 = s5 * rotation_5_p1 + c5 * c1;
  rotation[5] = -rotation_5;
  const Real rotation_0_p1 = c5 * rotation_2_p4 + s5 * s1;
  const Real rotation_3_p1 = c5 * rotation_5_p1 - s5 * c1;

  // link 6 (wrist_3), pose
  position[2] = p6_z - 0.11655 * rotation_8;
  rotation[6] = c6 * rotation_6_p1 + s6 * rotation_2_p3;
  rotation[7] = c6 * rotation_2_p3 - s6 * rotation_6_p1;
  rotation[0] = c6 * rotation_0_p1 - s6 * position_0_p3;
  rotation[1] = -(s6 * rotation_0_p1 + c6 * position_0_p3);
  rotation[3] = c6 * rotation_3_p1 - s6 * position_1_p1;
  rotation[4] = -(s6 * rotation_3_p1 + c6 * position_1_p1);
  position[0] = 0.17415 * s1 + 0.11985 * position_0_p3 + 0.11655 * rotation_2 - position_0_p2 * c1;
  position[1] = 0.11985 * position_1_p1 - 0.17415 * c1 - 0.11655 * rotation_5 - position_0_p2 * s1;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
