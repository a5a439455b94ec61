#pragma once

#include <Eigen/Core>

#include "interpreter/task_law.hpp"
#include "oracle/subject.hpp"

namespace treeline {

/// Of a solve whose rows yield near singularities: its condition, and the largest magnitudes that
/// Lambda can have at the state and in the neighbourhood of it, where a row's yielding is steep.
struct LawSizes {
  double condition = 1;
  Eigen::MatrixXd Lambda;
};

/// `law` is about Lambda^-1, not about a Jacobian; `terms` are the sizes of the terms of
/// `Lambda_inverse`, in rows as asked for.
LawSizes find_law_sizes(const Subject<double>& subject, const Eigen::VectorXd& q,
                        const Eigen::MatrixXd& Lambda_inverse, const Eigen::MatrixXd& terms,
                        const interpreter::TaskLaw<double>& law);

}  // namespace treeline
