#pragma once

#include <Eigen/Core>
#include <type_traits>

/// Products of matrices and vectors for numbers whose arithmetic is a call. Eigen's own are
/// blocked, packed and unrolled for numbers of the processor. Here that gains nothing, and is
/// compiled anew for every pair of factors: it took 44 % of the compile time of the interpreter in
/// 50 digits.
namespace treeline {

/// Whether products of this scalar go through `strided_product`. Specialise it in the header of the
/// scalar, so that every unit has the same products.
template <class Scalar>
inline constexpr bool kHasStridedProducts = false;

/// A matrix in memory: element (i, j) is first[i * row_step + j * col_step].
template <class Scalar>
struct Strided {
  Scalar* first = nullptr;
  Eigen::Index row_step = 0;
  Eigen::Index col_step = 0;

  [[nodiscard]] Scalar& operator()(Eigen::Index i, Eigen::Index j) const {
    return first[i * row_step + j * col_step];
  }
};

struct ProductSize {
  Eigen::Index rows, depth, cols;
};

/// How a product enters the matrix it is written to.
enum class Enter { set, add, subtract };

/// Element (i, j) of a b, from `depth` products that begin at k. Summed by halves, as Eigen does
/// for fixed sizes: rounding errors grow with the logarithm of the depth.
template <class Scalar>
Scalar sum_of_products(Strided<const Scalar> a, Strided<const Scalar> b, Eigen::Index i,
                       Eigen::Index j, Eigen::Index k, Eigen::Index depth) {
  if (depth == 1) return a(i, k) * b(k, j);
  const Eigen::Index half = depth / 2;
  return sum_of_products(a, b, i, j, k, half) + sum_of_products(a, b, i, j, k + half, depth - half);
}

/// c = a b, c += a b or c -= a b. c overlaps neither factor.
template <class Scalar>
void strided_product(const ProductSize& size, Strided<const Scalar> a, Strided<const Scalar> b,
                     Strided<Scalar> c, Enter enter) {
  for (Eigen::Index i = 0; i < size.rows; ++i) {
    for (Eigen::Index j = 0; j < size.cols; ++j) {
      const Scalar sum =
          size.depth == 0 ? Scalar(0) : sum_of_products(a, b, i, j, Eigen::Index{0}, size.depth);
      if (enter == Enter::set) {
        c(i, j) = sum;
      } else if (enter == Enter::add) {
        c(i, j) += sum;
      } else {
        c(i, j) -= sum;
      }
    }
  }
}

namespace detail {

/// Traits that Eigen asks of a product of the factors `Lhs` and `Rhs`, with prescribed names.
// NOLINTBEGIN(readability-identifier-naming)
template <class Lhs, class Rhs>
struct StridedProduct {
  using Scalar = typename Lhs::Scalar;

  template <class To>
  static void evalTo(To& to, const Lhs& lhs, const Rhs& rhs) {
    enter(to, lhs, rhs, Enter::set);
  }
  template <class To>
  static void addTo(To& to, const Lhs& lhs, const Rhs& rhs) {
    enter(to, lhs, rhs, Enter::add);
  }
  template <class To>
  static void subTo(To& to, const Lhs& lhs, const Rhs& rhs) {
    enter(to, lhs, rhs, Enter::subtract);
  }
  template <class To>
  static void scaleAndAddTo(To& to, const Lhs& lhs, const Rhs& rhs, const Scalar& scale) {
    const typename Lhs::PlainObject scaled = lhs * scale;
    strided_product<Scalar>(size_of(lhs, rhs), strided(scaled), strided(in_memory(rhs)), target(to),
                            Enter::add);
  }

 private:
  template <class To>
  static void enter(To& to, const Lhs& lhs, const Rhs& rhs, Enter how) {
    strided_product<Scalar>(size_of(lhs, rhs), strided(in_memory(lhs)), strided(in_memory(rhs)),
                            target(to), how);
  }
  static ProductSize size_of(const Lhs& lhs, const Rhs& rhs) {
    return {lhs.rows(), lhs.cols(), rhs.cols()};
  }
  /// `factor` itself if it is in memory, else its values, which live until the call ends.
  template <class Factor>
  static decltype(auto) in_memory(const Factor& factor) {
    if constexpr (Eigen::internal::has_direct_access<Factor>::ret) {
      return static_cast<const Factor&>(factor);
    } else {
      return typename Factor::PlainObject(factor);
    }
  }
  template <class Factor>
  static Strided<const Scalar> strided(const Factor& factor) {
    return {factor.data(), factor.rowStride(), factor.colStride()};
  }
  template <class To>
  static Strided<Scalar> target(To& to) {
    return {to.data(), to.rowStride(), to.colStride()};
  }
};
// NOLINTEND(readability-identifier-naming)

template <class Lhs, class Rhs>
concept StridedFactors = kHasStridedProducts<typename Lhs::Scalar> &&
    std::is_same_v<typename Lhs::Scalar, typename Rhs::Scalar>;

}  // namespace detail
}  // namespace treeline

namespace Eigen::internal {

template <class Lhs, class Rhs>
requires treeline::detail::StridedFactors<Lhs, Rhs>
struct generic_product_impl<Lhs, Rhs, DenseShape, DenseShape, GemmProduct>
    : treeline::detail::StridedProduct<Lhs, Rhs> {
};

template <class Lhs, class Rhs>
requires treeline::detail::StridedFactors<Lhs, Rhs>
struct generic_product_impl<Lhs, Rhs, DenseShape, DenseShape, GemvProduct>
    : treeline::detail::StridedProduct<Lhs, Rhs> {
};

template <class Lhs, class Rhs>
requires treeline::detail::StridedFactors<Lhs, Rhs>
struct generic_product_impl<Lhs, Rhs, DenseShape, DenseShape, CoeffBasedProductMode>
    : treeline::detail::StridedProduct<Lhs, Rhs> {
};

}  // namespace Eigen::internal
