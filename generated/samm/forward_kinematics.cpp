// forward_kinematics: x_world = R x_point + p, for every operational point
// By outward recursion.
// 91 flops (add 32, mul 59, div 0), sine and cosine of 7 angles
// Generated; see samm.hpp for the contract.
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void forward_kinematics(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT position)[3],
    Real (&TREELINE_RESTRICT rotation)[9]) noexcept {
  const Real angles[7] = {q[2], q[3], q[4], q[5], q[7], q[6], q[8]};
  Real sines[7];
  Real cosines[7];
  detail::sin_cos(angles, sines, cosines);
  const Real c3 = cosines[0];
  const Real c4 = cosines[1];
  const Real s3 = sines[0];
  const Real s4 = sines[1];
  const Real c5 = cosines[2];
  const Real s5 = sines[2];
  const Real s6 = sines[3];
  const Real c6 = cosines[3];
  const Real s8 = sines[4];
  const Real c7 = cosines[5];
  const Real s7 = sines[5];
  const Real c8 = cosines[4];
  const Real s9 = sines[6];
  const Real c9 = cosines[6];
  const Real rotation_2_p1 = s5 * s6 - c5 * c6;
  const Real rotation_2_p2 = c3 * c4 - s3 * s4;
  const Real rotation_5_p1 = s3 * c4 + c3 * s4;
  const Real rotation_2_p3 = s5 * c6 + c5 * s6;

  // link 6 (link3), pose
  const Real p6_z = 1.15 - 0.4318 * s5;

  // link 7 (link4), pose
  const Real rotation_2_p4 = rotation_2_p1 * rotation_2_p2;
  const Real rotation_5_p2 = rotation_2_p1 * rotation_5_p1;
  const Real rotation_2_p5 = rotation_2_p3 * rotation_2_p2;
  const Real rotation_5_p3 = rotation_2_p3 * rotation_5_p1;
  const Real rotation_8_p1 = c7 * rotation_2_p3;
  const Real rotation_6_p1 = s7 * rotation_2_p3;
  const Real rotation_2_p6 = c7 * rotation_2_p4 + s7 * rotation_5_p1;
  const Real rotation_0_p1 = s7 * rotation_2_p4 - c7 * rotation_5_p1;
  const Real rotation_5_p4 = s7 * rotation_2_p2 - c7 * rotation_5_p2;

  // link 9 (link6), pose
  const Real position_0_p1 = 0.4318 * c5 + (0.0203 * rotation_2_p1 + 0.4331 * rotation_2_p3);

  // link 8 (link5), pose
  const Real rotation_8 = s8 * rotation_8_p1 + c8 * rotation_2_p1;
  rotation[8] = -rotation_8;

  // link 7 (link4), pose
  const Real rotation_3_p1 = s7 * rotation_5_p2 + c7 * rotation_2_p2;

  // link 8 (link5), pose
  const Real rotation_6_p2 = s8 * rotation_2_p1 - c8 * rotation_8_p1;

  // link 7 (link4), pose
  const Real p7_z = p6_z + (0.0203 * rotation_2_p3 - 0.4331 * rotation_2_p1);

  // link 8 (link5), pose
  const Real rotation_2 = s8 * rotation_2_p6 - c8 * rotation_2_p5;
  rotation[2] = -rotation_2;
  const Real rotation_0_p2 = c8 * rotation_2_p6 + s8 * rotation_2_p5;
  const Real rotation_5 = s8 * rotation_5_p4 + c8 * rotation_5_p3;
  rotation[5] = rotation_5;
  const Real rotation_3_p2 = c8 * rotation_5_p4 - s8 * rotation_5_p3;

  // link 9 (link6), pose
  position[2] = p7_z - 0.05625 * rotation_8;
  rotation[6] = c9 * rotation_6_p2 + s9 * rotation_6_p1;
  rotation[7] = c9 * rotation_6_p1 - s9 * rotation_6_p2;
  rotation[0] = s9 * rotation_0_p1 - c9 * rotation_0_p2;
  rotation[1] = s9 * rotation_0_p2 + c9 * rotation_0_p1;
  rotation[3] = c9 * rotation_3_p2 + s9 * rotation_3_p1;
  rotation[4] = c9 * rotation_3_p1 - s9 * rotation_3_p2;
  position[0] = q[0] - 0.1501 * rotation_5_p1 - 0.05625 * rotation_2 + position_0_p1 *
      rotation_2_p2;
  position[1] = q[1] + 0.1501 * rotation_2_p2 + 0.05625 * rotation_5 + position_0_p1 *
      rotation_5_p1;
}

}  // namespace samm

#undef TREELINE_RESTRICT
