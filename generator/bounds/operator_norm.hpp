#pragma once

#include <vector>

#include "bounds/trig_polynomial.hpp"

namespace treeline::bounds {

/// The most rows and columns that a matrix may have: those of a set of a 3x3 matrix's entries.
constexpr std::size_t kMostRows = 9;

/// One entry of a matrix whose entries are polynomials of one angle.
struct MatrixEntry {
  std::size_t row = 0, column = 0;
  TrigPolynomial value;
};

struct TrigMatrix {
  std::size_t rows = 0, columns = 0;
  std::vector<MatrixEntry> entries;  ///< those of one place add up
};

/// The largest that the norm of each column becomes, at sampled angles.
std::vector<double> column_norms(const TrigMatrix& A);

/// No angle gives A diag(1/scale) a larger 2-norm; columns that are zero, and their scale, add
/// nothing. A trigonometric polynomial of degree n that is
/// at most 1 at N > 2n evenly spread angles is at most 1/cos(pi n/N) everywhere (Ehlich & Zeller
/// 1964); here n = 4, of the squared norm. Where the matrix of products of rows (or of columns) is
/// the same at all of them, it is so everywhere.
double operator_norm(const TrigMatrix& A, const std::vector<double>& scale);

/// No angle makes the root of the sum of the squares of all entries, each divided by the scale of
/// its column, larger.
double frobenius_norm(const TrigMatrix& A, const std::vector<double>& scale);

}  // namespace treeline::bounds
