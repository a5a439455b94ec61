// gravity: g: the joint forces that hold the robot at rest
// By recursive Newton-Euler, Chang table 4.1.
// 40 flops (add 12, mul 28, div 0), sine and cosine of 4 angles
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

void gravity(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT g)[6]) noexcept {
  g[5] = 0.0;
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real c4 = cosines[2];
  const Real c5 = cosines[3];
  const Real s2 = sines[0];
  const Real s3 = sines[1];
  const Real s4 = sines[2];
  const Real s5 = sines[3];

  // link 2 (upper_arm), outward
  const Real a2_x = 9.81 * s2;
  const Real a2_y = 9.81 * c2;

  // link 3 (forearm), outward
  const Real a3_x = c3 * a2_x + s3 * a2_y;
  const Real a3_y = c3 * a2_y - s3 * a2_x;

  // link 4 (wrist_1), outward
  const Real a4_x = c4 * a3_x + s4 * a3_y;
  const Real a4_y = c4 * a3_y - s4 * a3_x;

  // link 5 (wrist_2), outward
  const Real a5_x = c5 * a4_x;

  // link 5 (wrist_2), inertial wrench
  const Real minus_n5_x = 0.09132825 * a4_y;
  const Real minus_n5_z = 0.09132825 * a5_x;
  g[4] = -minus_n5_z;

  // link 5 (wrist_2), inward
  const Real minus_n4_x = c5 * minus_n5_x;
  const Real n4_z = 0.33495075 * a4_x - s5 * minus_n5_x;
  g[3] = n4_z;

  // link 4 (wrist_1), inward
  const Real n3_y = c4 * minus_n5_z - s4 * minus_n4_x;
  const Real minus_n3_x = c4 * minus_n4_x + s4 * minus_n5_z;
  const Real n3_z = n4_z - 4.0059802 * a3_y;
  g[2] = n3_z;

  // link 3 (forearm), inward
  const Real n2_z = n3_z - 81.98859064500002 * c2;
  g[1] = n2_z;
  const Real n2_y = c3 * n3_y - s3 * minus_n3_x;
  const Real minus_n2_x = c3 * minus_n3_x + s3 * n3_y;

  // link 2 (upper_arm), inward
  const Real n1_z = c2 * n2_y - s2 * minus_n2_x;
  g[0] = n1_z;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
