#pragma once

#include <vector>

#include "interpreter/types.hpp"

namespace treeline {

/// Converts the entries of a state or result to a vector of the interpreter.
template <class Scalar>
interpreter::Vector<Scalar> vector_of(const std::vector<double>& entries) {
  interpreter::Vector<Scalar> x(static_cast<Eigen::Index>(entries.size()));
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    x(i) = static_cast<Scalar>(entries[static_cast<std::size_t>(i)]);
  }
  return x;
}

inline Eigen::VectorXd magnitudes(const std::vector<double>& entries) {
  return vector_of<double>(entries).cwiseAbs();
}

/// Appends the entries of a matrix, row by row.
template <class Derived>
void append(const Eigen::DenseBase<Derived>& matrix,
            std::vector<typename Derived::Scalar>& entries) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) entries.push_back(matrix(i, j));
  }
}

/// Returns the entries of a matrix, row by row.
template <class Derived>
std::vector<typename Derived::Scalar> entries_of(const Eigen::DenseBase<Derived>& matrix) {
  std::vector<typename Derived::Scalar> entries;
  append(matrix, entries);
  return entries;
}

}  // namespace treeline
