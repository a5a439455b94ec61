#pragma once

#include <Eigen/Core>

#include "oracle/draw_state.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// Scales of the rows of constraints between links and between joints, see `TermSizes`. Joints that
/// carry both links play no part.
struct LoopSizes {
  Eigen::MatrixXd J;       ///< rows x nv
  Eigen::VectorXd bias;    ///< of Jd qd
  Eigen::VectorXd errors;  ///< of how far they are from closed
  double condition = 1;    ///< of J: infinite where a disc lies flat
};

LoopSizes loop_sizes(const Subject<double>& subject, const State& state);

}  // namespace treeline
