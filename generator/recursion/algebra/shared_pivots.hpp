#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "recursion/algebra/factor_ldlt.hpp"
#include "recursion/algebra/pivot_rule.hpp"

namespace treeline {

/// Inverts the pivots of a matrix A of inverse inertias by a rule while its first rows are held in
/// part, each to a share w of 0 to 1: row k has the compliance (1 - w) / w A_kk, which is added to
/// A_kk. The compliance is multiplied out, so that nothing is divided by w. With w = 1 the inverse
/// is the rule's, to the bit. With w = 0 it is 0, and all others are as if there were no such row.
template <class Scalar>
class SharedPivots {
 public:
  /// `shares`: w of the first rows; that of others is 1.
  SharedPivots(const DenseMatrix<Scalar>& A, const PivotRule& rule,
               const std::vector<Scalar>& shares)
      : rule_(rule), shares_(shares) {
    for (std::size_t k = 0; k < shares.size(); ++k) {
      yielding_.push_back((Scalar(1.0) - shares[k]) * A(k, k));
    }
  }

  Scalar operator()(std::size_t k, const Scalar& c) const {
    if (k >= shares_.size()) return rule_(k, c);
    return shares_[k] * rule_(k, shares_[k] * c + yielding_[k]);
  }

 private:
  const PivotRule& rule_;
  const std::vector<Scalar>& shares_;
  std::vector<Scalar> yielding_;  ///< compliance times w
};

/// Factors A with the compliances of rows that are held in part, see `SharedPivots`.
template <class Scalar>
LdltFactor<Scalar> factor_shared(DenseMatrix<Scalar> A, const PivotRule& rule,
                                 const std::vector<Scalar>& shares) {
  const SharedPivots<Scalar> pivots(A, rule, shares);
  return factor_ldlt(std::move(A), pivots);
}

}  // namespace treeline
