#include "oracle/symmetric_matrices.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

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

}  // namespace treeline
