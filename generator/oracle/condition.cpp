#include "oracle/condition.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace treeline {

double scaled_condition(const Eigen::MatrixXd& A, const Eigen::VectorXd& d) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!A.allFinite() || !d.allFinite() || d.minCoeff() <= 0) return kInfinity;
  const Eigen::VectorXd s = d.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = s.asDiagonal() * A * s.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scaled, Eigen::EigenvaluesOnly);
  const double least = solver.eigenvalues()(0);
  return least > 0 ? 1 / least : kInfinity;
}

}  // namespace treeline
