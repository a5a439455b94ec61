// gravity: g: the joint forces that hold the robot at rest
// By recursive Newton-Euler, Chang table 4.1.
// 40 flops (add 12, mul 28, div 0), sine and cosine of 4 angles
// Generated; see puma560.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "puma560.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace puma560 {

void gravity(const Real (&TREELINE_RESTRICT q)[6], Real (&TREELINE_RESTRICT g)[6]) noexcept {
  g[5] = 0.0;
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real c2 = cosines[0];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real c5 = cosines[3];
  const Real s4 = sines[2];
  const Real c3 = cosines[1];
  const Real s2 = sines[0];
  const Real s5 = sines[3];

  // link 2 (link2), outward
  const Real minus_a2_x = 9.81 * s2;
  const Real minus_a2_y = 9.81 * c2;

  // link 3 (link3), outward
  const Real minus_a3_x = c3 * minus_a2_x + s3 * minus_a2_y;
  const Real a3_y = s3 * minus_a2_x - c3 * minus_a2_y;

  // link 4 (link4), outward
  const Real minus_a4_x = c4 * minus_a3_x;
  const Real a4_y = s4 * minus_a3_x;

  // link 5 (link5), inertial wrench
  const Real minus_n5_x = 0.0028799999999999997 * a4_y;

  // link 5 (link5), outward
  const Real a5_x = s5 * a3_y - c5 * minus_a4_x;

  // link 5 (link5), inward
  const Real minus_n4_x = c5 * minus_n5_x;
  const Real n4_z = s5 * minus_n5_x;
  g[3] = n4_z;

  // link 5 (link5), inertial wrench
  const Real n5_z = 0.0028799999999999997 * a5_x;
  g[4] = n5_z;

  // link 4 (link4), inward
  const Real minus_n3_x = c4 * minus_n4_x + s4 * n5_z;
  const Real n3_z = c4 * n5_z - s4 * minus_n4_x - (0.025374999999999998 * a3_y + 0.861795 *
      minus_a3_x);
  g[2] = n3_z;

  // link 3 (link3), inward
  const Real n2_z = 1.024164 * s2 - 37.2347379 * c2 + n3_z;
  g[1] = n2_z;
  const Real minus_n2_y = s3 * minus_n3_x + c3 * n4_z;
  const Real n2_x = s3 * n4_z - c3 * minus_n3_x;

  // link 2 (link2), inward
  const Real n1_z = c2 * minus_n2_y - s2 * n2_x;
  g[0] = n1_z;
}

}  // namespace puma560

#undef TREELINE_RESTRICT
