#pragma once

#include <vector>

#include "bounds/trig_polynomial.hpp"

namespace treeline::bounds {

/// Largest number of rows and columns of a matrix: the number of entries of a 3x3 matrix.
constexpr std::size_t kMostRows = 9;

/// One entry of a matrix whose entries are polynomials in sine and cosine of one angle.
struct MatrixEntry {
  std::size_t row = 0, column = 0;
  TrigPolynomial value;
};

struct TrigMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<MatrixEntry> entries;  ///< entries at the same place add up
};

/// Largest norm of each column over sampled angles.
std::vector<double> column_norms(const TrigMatrix& A);

/// Upper bound of the 2-norm of A diag(1/scale) over all angles. Columns that are zero add nothing,
/// and neither does their scale. A trigonometric polynomial of degree n that is at most 1 at N > 2n
/// evenly spaced angles is at most 1/cos(pi n/N) everywhere (Ehlich & Zeller 1964). Here n = 4, the
/// degree of the squared norm. If the matrix of products of rows (or of columns) is the same at all
/// samples, it is the same at every angle.
double operator_norm(const TrigMatrix& A, const std::vector<double>& scale);

/// Upper bound, over all angles, of the root of the sum of squares of all entries, each divided by
/// the scale of its column.
double frobenius_norm(const TrigMatrix& A, const std::vector<double>& scale);

}  // namespace treeline::bounds
