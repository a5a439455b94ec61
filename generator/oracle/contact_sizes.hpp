#pragma once

#include <Eigen/Core>
#include <vector>

#include "description/scene.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// Scales of the results of one of `kContactFunctions`, from the sizes of their terms. `M_inverse`
/// has the magnitudes of M^-1. `result` is what the function returns.
std::vector<double> contact_sizes(Function function, const Subject<double>& subject,
                                  const State& state, const Eigen::MatrixXd& M_inverse,
                                  const std::vector<double>& result);

}  // namespace treeline
