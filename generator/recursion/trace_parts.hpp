#pragma once

#include <string>
#include <utility>
#include <vector>

#include "program/program.hpp"
#include "recursion/dense_matrix.hpp"

namespace treeline {

/// Adds an argument to a program that is being traced and returns its entries. Adds nothing if the
/// size is 0.
inline std::vector<Expression> declare(Program& program, const std::string& name, int size,
                                       const std::string& meaning) {
  std::vector<Expression> entries;
  if (size > 0) program.arguments.push_back({name, size, 1, meaning});
  for (int i = 0; i < size; ++i) {
    entries.push_back(program.graph.input(name + "[" + std::to_string(i) + "]"));
  }
  return entries;
}

inline Result vector_result(const char* name, const char* meaning, std::vector<Expression> values) {
  const int size = static_cast<int>(values.size());
  return {{name, size, 1, meaning}, std::move(values)};
}

inline Result matrix_result(const char* name, const char* meaning,
                            const DenseMatrix<Expression>& matrix) {
  return {{name, static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()), meaning},
          matrix.values()};
}

}  // namespace treeline
