// forward_kinematics: x_world = R x_point + p, for every operational point
// By outward recursion.
// 83 flops (add 28, mul 55, div 0), sine and cosine of 6 angles
// Generated; see puma560.hpp for the contract.
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void forward_kinematics(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT position)[3],
    Real (&TREELINE_RESTRICT rotation)[9]) noexcept {
  const Real angles[6] = {q[0], q[1], q[2], q[4], q[3], q[5]};
  Real sines[6];
  Real cosines[6];
  detail::sin_cos(angles, sines, cosines);
  const Real c1 = cosines[0];
  const Real c2 = cosines[1];
  const Real s1 = sines[0];
  const Real s2 = sines[1];
  const Real s3 = sines[2];
  const Real c3 = cosines[2];
  const Real s5 = sines[3];
  const Real c4 = cosines[4];
  const Real s4 = sines[4];
  const Real c5 = cosines[3];
  const Real s6 = sines[5];
  const Real c6 = cosines[5];
  const Real rotation_2_p1 = s2 * s3 - c2 * c3;
  const Real rotation_2_p2 = s2 * c3 + c2 * s3;

  // link 3 (link3), pose
  const Real p3_z = 0.6718 - 0.4318 * s2;

  // link 4 (link4), pose
  const Real rotation_2_p3 = rotation_2_p1 * c1;
  const Real rotation_5_p1 = rotation_2_p1 * s1;
  const Real rotation_2_p4 = rotation_2_p2 * c1;
  const Real rotation_5_p2 = rotation_2_p2 * s1;
  const Real rotation_8_p1 = c4 * rotation_2_p2;
  const Real rotation_6_p1 = s4 * rotation_2_p2;
  const Real rotation_2_p5 = c4 * rotation_2_p3 + s4 * s1;
  const Real rotation_5_p3 = s4 * c1 - c4 * rotation_5_p1;

  // link 6 (link6), pose
  const Real position_0_p1 = 0.4318 * c2 + (0.0203 * rotation_2_p1 + 0.4331 * rotation_2_p2);

  // link 5 (link5), pose
  const Real rotation_8 = s5 * rotation_8_p1 + c5 * rotation_2_p1;
  rotation[8] = -rotation_8;

  // link 4 (link4), pose
  const Real rotation_0_p1 = s4 * rotation_2_p3 - c4 * s1;
  const Real p4_z = p3_z + (0.0203 * rotation_2_p2 - 0.4331 * rotation_2_p1);
  const Real rotation_3_p1 = s4 * rotation_5_p1 + c4 * c1;

  // link 5 (link5), pose
  const Real rotation_6_p2 = s5 * rotation_2_p1 - c5 * rotation_8_p1;
  const Real rotation_2 = s5 * rotation_2_p5 - c5 * rotation_2_p4;
  rotation[2] = -rotation_2;
  const Real rotation_5 = s5 * rotation_5_p3 + c5 * rotation_5_p2;
  rotation[5] = rotation_5;
  const Real rotation_0_p2 = c5 * rotation_2_p5 + s5 * rotation_2_p4;
  const Real rotation_3_p2 = c5 * rotation_5_p3 - s5 * rotation_5_p2;

  // link 6 (link6), pose
  position[2] = p4_z - 0.05625 * rotation_8;
  rotation[6] = c6 * rotation_6_p2 + s6 * rotation_6_p1;
  rotation[7] = c6 * rotation_6_p1 - s6 * rotation_6_p2;
  rotation[0] = s6 * rotation_0_p1 - c6 * rotation_0_p2;
  rotation[1] = s6 * rotation_0_p2 + c6 * rotation_0_p1;
  rotation[3] = c6 * rotation_3_p2 + s6 * rotation_3_p1;
  rotation[4] = c6 * rotation_3_p1 - s6 * rotation_3_p2;
  position[0] = position_0_p1 * c1 - (0.1501 * s1 + 0.05625 * rotation_2);
  position[1] = 0.1501 * c1 + 0.05625 * rotation_5 + position_0_p1 * s1;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
