#include "inspect/condition.hpp"

#include <Eigen/Eigenvalues>
#include <limits>

namespace treeline {

double unit_condition(const Eigen::MatrixXd& A) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!A.allFinite() || A.diagonal().minCoeff() <= 0) return kInfinity;
  const Eigen::VectorXd s = A.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(s.asDiagonal() * A * s.asDiagonal(),
                                                              Eigen::EigenvaluesOnly);
  const double least = solver.eigenvalues()(0);
  return least > 0 ? 1 / least : kInfinity;
}

}  // namespace treeline
