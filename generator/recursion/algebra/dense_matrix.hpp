#pragma once

#include <cstddef>
#include <vector>

namespace treeline {

/// Row-major matrix of run-time size. Entries start as zero, which a trace treats as structural.
template <class Scalar>
class DenseMatrix {
 public:
  DenseMatrix() = default;
  DenseMatrix(std::size_t rows, std::size_t cols)
      : rows_(rows), cols_(cols), values_(rows * cols, Scalar(0.0)) {}

  Scalar& operator()(std::size_t i, std::size_t j) { return values_[i * cols_ + j]; }
  const Scalar& operator()(std::size_t i, std::size_t j) const { return values_[i * cols_ + j]; }
  [[nodiscard]] std::size_t rows() const { return rows_; }
  [[nodiscard]] std::size_t cols() const { return cols_; }
  [[nodiscard]] const std::vector<Scalar>& values() const { return values_; }

 private:
  std::size_t rows_ = 0, cols_ = 0;
  std::vector<Scalar> values_;
};

}  // namespace treeline
