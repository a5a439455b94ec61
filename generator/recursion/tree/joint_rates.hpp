#pragma once

#include <cstddef>
#include <span>

namespace treeline {

/// Rates for a pass: qd and qdd with nv entries each. An empty span means zero.
template <class Scalar>
struct JointRates {
  std::span<const Scalar> qd, qdd;
  [[nodiscard]] Scalar velocity(std::size_t i) const { return qd.empty() ? Scalar(0.0) : qd[i]; }
  [[nodiscard]] Scalar acceleration(std::size_t i) const {
    return qdd.empty() ? Scalar(0.0) : qdd[i];
  }
};

}  // namespace treeline
