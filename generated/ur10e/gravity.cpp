// SPDX-License-Identifier: 0BSD
// gravity: g: the joint forces that hold the robot at rest
// By recursive Newton-Euler, Chang table 4.1.
// 25 flops (add 8, mul 17, div 0), sine and cosine of 4 angles
// Generated; see ur10e.hpp for the contract.
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

  // sines and cosines
  const Real angles[4] = {q[1], q[2], q[3], q[4]};
  Real sines[4];
  Real cosines[4];
  detail::sin_cos(angles, sines, cosines);
  const Real c2 = cosines[0];
  const Real c3 = cosines[1];
  const Real s2 = sines[0];
  const Real s3 = sines[1];
  const Real c4 = cosines[2];
  const Real s4 = sines[2];
  const Real c5 = cosines[3];
  const Real s5 = sines[3];
  const Real c23 = c2 * c3 - s2 * s3;
  const Real s23 = s2 * c3 + c2 * s3;
  const Real c234 = c23 * c4 - s23 * s4;
  const Real s234 = s23 * c4 + c23 * s4;

  // link 5 (wrist_2), inertial wrench and inward
  const Real minus_n5_x = 0.8959301325000001 * c234;
  const Real t1 = c5 * s234;
  const Real minus_n5_z = 0.8959301325000001 * t1;
  g[4] = -minus_n5_z;
  const Real n4_z = 3.2858668575000003 * s234 - s5 * minus_n5_x;
  g[3] = n4_z;

  // links 3 (forearm) and 4 (wrist_1), inward
  const Real n3_z = n4_z - 39.298665762000006 * c23;
  g[2] = n3_z;
  const Real n3_y = c234 * minus_n5_z - t1 * minus_n5_x;
  g[0] = n3_y;
  const Real n2_z = n3_z - 81.988590645 * c2;
  g[1] = n2_z;
}

}  // namespace ur10e

#undef TREELINE_RESTRICT
