#pragma once

#include <type_traits>
#include <vector>

#include "program/expression.hpp"

namespace treeline {

/// Declares in a trace that these values may share lanes, see `Graph::align_lanes`.
template <class Scalar>
void align_lanes(std::vector<Scalar>& values) {
  if constexpr (std::is_same_v<Scalar, Expression>) {
    Graph::current().align_lanes(values);
  }
}

}  // namespace treeline
