#pragma once

#include <string>
#include <utility>
#include <vector>

#include "program/program.hpp"
#include "recursion/algebra/dense_matrix.hpp"
#include "recursion/tree/declare_inputs.hpp"

namespace treeline {

inline Result vector_result(const char* name, const std::string& meaning,
                            std::vector<Expression> values) {
  const int size = static_cast<int>(values.size());
  return {{name, size, 1, meaning}, std::move(values)};
}

inline Result matrix_result(const char* name, const std::string& meaning,
                            const DenseMatrix<Expression>& matrix) {
  return {{name, static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols()), meaning},
          matrix.values()};
}

/// The results of a function that has only this one.
inline std::vector<Result> vector_output(const char* name, const std::string& meaning,
                                         std::vector<Expression> values) {
  return {vector_result(name, meaning, std::move(values))};
}
inline std::vector<Result> matrix_output(const char* name, const std::string& meaning,
                                         const DenseMatrix<Expression>& matrix) {
  return {matrix_result(name, meaning, matrix)};
}

/// End of the equations of functions with an argument `step`.
inline const std::string kImplicitTerms =
    ", D = d friction / d qd, K: stiffness of springs: both at the end of the step, to first order";

/// In which coordinates derivatives "by q" are need be said only where a joint has a quaternion.
inline std::string by_displacements(const Mechanism& mechanism) {
  return mechanism.nq() == mechanism.nv()
             ? "by q"
             : "by displacements: floating joints' are twists in the child's axes, linear over "
               "angular; others' are of q";
}

}  // namespace treeline
