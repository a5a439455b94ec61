#include "oracle/symmetric_matrices.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace treeline {
namespace {

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;

}  // namespace

SymmetricDecomposition decompose_symmetric(const Eigen::MatrixXd& A) {
  const Solver solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd eigenvalues_of_symmetric(const Eigen::MatrixXd& A) {
  return Solver(A, Eigen::EigenvaluesOnly).eigenvalues();
}

Eigen::MatrixXd inverse_of_symmetric(const Eigen::MatrixXd& A) {
  return A.ldlt().solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()));
}

double scaled_condition(const Eigen::MatrixXd& A, const Eigen::VectorXd& d) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (!A.allFinite() || !d.allFinite() || d.minCoeff() <= 0) return kInfinity;
  const Eigen::VectorXd s = d.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = s.asDiagonal() * A * s.asDiagonal();
  const double least = eigenvalues_of_symmetric(scaled)(0);
  return least > 0 ? 1 / least : kInfinity;
}

}  // namespace treeline
