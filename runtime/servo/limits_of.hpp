#pragma once

#include <algorithm>
#include <iterator>

#include "servo/safety.hpp"

namespace treeline::servo {

/// The limits that a robot's generated header lists: `kLowerLimits`, `kUpperLimits`,
/// `kVelocityLimits` and `kEffortLimits` of NAME_joints.hpp.
template <int nq, int nv>
SafetyLimits<nq, nv> limits_of(const double (&lower)[nq], const double (&upper)[nq],
                               const double (&velocity)[nv], const double (&effort)[nv]) noexcept {
  SafetyLimits<nq, nv> limits;
  std::copy(std::begin(lower), std::end(lower), limits.lower.begin());
  std::copy(std::begin(upper), std::end(upper), limits.upper.begin());
  std::copy(std::begin(velocity), std::end(velocity), limits.velocity.begin());
  std::copy(std::begin(effort), std::end(effort), limits.torque.begin());
  return limits;
}

}  // namespace treeline::servo
