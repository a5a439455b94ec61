// gravity: g: the joint forces that hold the robot at rest
// By recursive Newton-Euler, Chang table 4.1.
// 40 flops (add 12, mul 28, div 0), sine and cosine of 4 angles
// Generated; see samm.hpp for the contract.
#if defined(__GNUC__) && !defined(__clang__)
// Fewer spills and copies in long straight-line code; no arithmetic changes.
#pragma GCC optimize("live-range-shrinkage", "rename-registers")
#endif
#include "samm.hpp"
#include "sin_cos.hpp"

#if defined(__GNUC__)
#define TREELINE_RESTRICT __restrict
#else
#define TREELINE_RESTRICT
#endif

namespace samm {

void gravity(const Real (&TREELINE_RESTRICT q)[9], Real (&TREELINE_RESTRICT g)[9]) noexcept {
  g[0] = 0.0;
  g[1] = 0.0;
  g[8] = 0.0;
  const Real angles[4] = {q[4], q[5], q[6], q[7]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real c5 = cosines[0];
  const Real s6 = sines[1];
  const Real c7 = cosines[2];
  const Real c8 = cosines[3];
  const Real s7 = sines[2];
  const Real c6 = cosines[1];
  const Real s5 = sines[0];
  const Real s8 = sines[3];

  // link 5 (link2), outward
  const Real minus_a5_x = 9.81 * s5;
  const Real minus_a5_y = 9.81 * c5;

  // link 6 (link3), outward
  const Real minus_a6_x = c6 * minus_a5_x + s6 * minus_a5_y;
  const Real a6_y = s6 * minus_a5_x - c6 * minus_a5_y;

  // link 7 (link4), outward
  const Real minus_a7_x = c7 * minus_a6_x;
  const Real a7_y = s7 * minus_a6_x;

  // link 8 (link5), inertial wrench
  const Real minus_n8_x = 0.0028799999999999997 * a7_y;

  // link 8 (link5), outward
  const Real a8_x = s8 * a6_y - c8 * minus_a7_x;

  // link 8 (link5), inward
  const Real minus_n7_x = c8 * minus_n8_x;
  const Real n7_z = s8 * minus_n8_x;
  g[6] = n7_z;

  // link 8 (link5), inertial wrench
  const Real n8_z = 0.0028799999999999997 * a8_x;
  g[7] = n8_z;

  // link 7 (link4), inward
  const Real minus_n6_x = c7 * minus_n7_x + s7 * n8_z;
  const Real n6_z = c7 * n8_z - s7 * minus_n7_x - (0.025374999999999998 * a6_y + 0.861795 *
      minus_a6_x);
  g[5] = n6_z;

  // link 6 (link3), inward
  const Real n5_z = 1.024164 * s5 - 37.2347379 * c5 + n6_z;
  g[4] = n5_z;
  const Real minus_n5_y = s6 * minus_n6_x + c6 * n7_z;
  const Real n5_x = s6 * n7_z - c6 * minus_n6_x;

  // link 5 (link2), inward
  const Real n4_z = c5 * minus_n5_y - s5 * n5_x;
  g[2] = n4_z;
  g[3] = n4_z;
}

}  // namespace samm

#undef TREELINE_RESTRICT
