#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <utility>

#include "bench/contender.hpp"

namespace treeline {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Matrix invert_by_lu(const Matrix& A) {
  return A.partialPivLu().inverse();
}

Matrix invert_by_ldlt(const Matrix& A) {
  return A.ldlt().solve(Matrix::Identity(A.rows(), A.cols()));
}

Contender factorise(const Contender& from, int rows, const char* name,
                    Matrix (*invert)(const Matrix&)) {
  Contender contender = from;
  contender.variant.function = Function::lambda;
  contender.variant.group = VariantGroup::solve;
  contender.variant.name = name;
  contender.variant.repeats.clear();
  contender.variant.flops = 0;
  contender.call = [call = from.call, rows, invert](const State& state) {
    const std::vector<double> entries = call(state);
    const Matrix Lambda = invert(Eigen::Map<const Matrix>(entries.data(), rows, rows));
    return std::vector<double>(Lambda.data(), Lambda.data() + Lambda.size());
  };
  // The time does not depend on the matrix as long as it is positive definite.
  Matrix A = Matrix::Constant(rows, rows, 0.1);
  A.diagonal().array() += 1;
  contender.passes.push_back({[pass = from.passes.front(), invert, A, sink = Matrix(A)]() mutable {
                                pass.pass();
                                for (std::size_t call = 0; call < pass.calls; ++call)
                                  sink = invert(A);
                              },
                              from.passes.front().calls});
  return contender;
}

}  // namespace

std::vector<Contender> factorisation_contenders(const Contender& lambda_inverse, int rows) {
  return {factorise(lambda_inverse, rows, "emitted Lambda^-1, Eigen's LU", invert_by_lu),
          factorise(lambda_inverse, rows, "emitted Lambda^-1, Eigen's LDL^T", invert_by_ldlt)};
}

}  // namespace treeline
