#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "program/program.hpp"

namespace treeline::bounds {

/// Identifies an angle by the node whose sine and cosine are taken, or by an input `sin_q[i]`. 0
/// means none.
using Angle = std::uint32_t;

/// c[0] + c[1] cos x + c[2] sin x + c[3] cos 2x + c[4] sin 2x of one angle x. Constants have no
/// angle.
struct TrigPolynomial {
  Angle angle = 0;
  std::array<double, 5> c{};

  [[nodiscard]] bool is_constant() const { return angle == 0; }
  /// Value at the angle with this cosine and sine.
  [[nodiscard]] double at(double cosine, double sine) const {
    return c[0] + c[1] * cosine + c[2] * sine + c[3] * (cosine * cosine - sine * sine) +
           c[4] * 2 * sine * cosine;
  }
  /// Upper bound of the magnitude over all angles.
  [[nodiscard]] double magnitude() const;
};

TrigPolynomial constant(double value);
TrigPolynomial operator-(TrigPolynomial p);
/// Sum and product of two polynomials. Nothing if their angles differ, or if a product is of more
/// than second degree.
std::optional<TrigPolynomial> add(const TrigPolynomial& a, const TrigPolynomial& b);
std::optional<TrigPolynomial> multiply(const TrigPolynomial& a, const TrigPolynomial& b);

/// Finds for each node its polynomial of at most second degree in one angle, if it has one: sines,
/// cosines, constants, and their sums and products. Inputs `sin_q[i]` and `cos_q[i]` count as sine
/// and cosine of one angle.
std::vector<std::optional<TrigPolynomial>> find_polynomials(const Graph& graph);

/// Value of a node times `factor`.
struct LinearTerm {
  std::uint32_t node = 0;
  TrigPolynomial factor;
};

/// An operation that was expanded. The sum depends on its value with a factor of at most `weight`.
struct ExpandedOperation {
  std::uint32_t node = 0;
  double weight = 0;
};

/// Value of a node as a sum of other values. `turned` has the terms whose factors turn with
/// `angle`, `rest` the other terms.
struct LinearForm {
  std::vector<LinearTerm> turned, rest;
  std::vector<ExpandedOperation> operations;
};

/// Finds the angle that turns terms of a sum, the one nearest below the node. Returns 0 if there is
/// none.
Angle find_turn(const Graph& graph, const std::vector<std::optional<TrigPolynomial>>& polynomials,
                std::uint32_t node);

/// Expresses the node's value by sines and cosines of `angle`. Sums are followed as long as one of
/// their terms has such a factor. Returns nothing if none has.
std::optional<LinearForm> expand_linear(
    const Graph& graph, const std::vector<std::optional<TrigPolynomial>>& polynomials,
    std::uint32_t node, Angle angle);

/// Splits a turned difference, in the sums of a set, into its two values if one of them also occurs
/// as a term of its own in some sum. It then is turned with them.
void split_sums(const Graph& graph, std::vector<LinearForm>& forms);

/// Moves a value to the turned terms of every sum if it is turned in one of them, even where it is
/// added without a factor.
void gather_turned(std::vector<LinearForm>& forms);

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

/// Bounds what rounding adds to the norm of the rows of a turn, whose products are t a_j with the
/// sines and cosines t: u |t| |a_j| for the product, u e_t |a_j| for the error e_t of t. By
/// Cauchy-Schwarz this is at most the Frobenius norms of the matrices of t and of e_t, times the
/// norm of the a_j. These norms are sqrt 2 and 2 for a rotation, whereas each product alone would
/// count as much as the whole vector.
class TurnRounding {
 public:
  TurnRounding(std::size_t rows, std::size_t columns);

  /// Adds a product in this row with the value of this column. Returns false if there is one
  /// already.
  bool add(std::size_t row, std::size_t column, const TrigPolynomial& t, double weight,
           double sine_error);
  /// Bound in rounding units. `computed` is an upper bound of the norm of the computed values times
  /// `scale`.
  [[nodiscard]] double bound(const std::vector<double>& scale, double computed, double unit) const;

 private:
  std::size_t columns_;
  TrigMatrix products_;
  std::vector<double> sine_errors_;  ///< by entry
  std::vector<bool> taken_;
};

}  // namespace treeline::bounds
