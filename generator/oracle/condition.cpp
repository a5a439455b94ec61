#include "oracle/condition.hpp"

#include <cmath>
#include <limits>

#include "oracle/symmetric_matrices.hpp"

namespace treeline {

double scaled_condition(const Eigen::MatrixXd& A, const Eigen::VectorXd& d) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!A.allFinite() || !d.allFinite() || d.minCoeff() <= 0) return kInfinity;
  const Eigen::VectorXd s = d.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = s.asDiagonal() * A * s.asDiagonal();
  const double least = eigenvalues_of_symmetric(scaled)(0);
  return least > 0 ? 1 / least : kInfinity;
}

}  // namespace treeline
