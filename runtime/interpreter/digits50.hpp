#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>

namespace treeline::interpreter {

/// A floating-point number of 50 decimal digits, the truth that errors are measured against.
/// Without expression templates, which Eigen's kernels cannot take.
using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                               boost::multiprecision::et_off>;

}  // namespace treeline::interpreter

namespace Eigen::internal {

/// Eigenvalues take this; Eigen's own asks Boost's traits for an infinity that they do not have. No
/// exponent of these numbers overflows.
template <>
inline treeline::interpreter::Digits50 positive_real_hypot(
    const treeline::interpreter::Digits50& x, const treeline::interpreter::Digits50& y) {
  return sqrt(x * x + y * y);
}

}  // namespace Eigen::internal
