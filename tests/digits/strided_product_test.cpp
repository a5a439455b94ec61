#include "digits/strided_product.hpp"

#include <gtest/gtest.h>

#include <random>

#include "digits/digits50.hpp"

// Products of matrices of 50 digits, which bypass Eigen's. Would catch: a wrong stride, a
// transposed factor, a sum that forgets or repeats a product, a factor that is overwritten while it
// is read, and a factor without memory of its own that is gone when it is read. Entries are small
// integers, whose products are exact in every order: results are compared with Eigen's in integers.

namespace treeline {
namespace {

template <class Scalar, int rows = Eigen::Dynamic, int cols = Eigen::Dynamic,
          int order = Eigen::ColMajor>
using Dense = Eigen::Matrix<Scalar, rows, cols, order>;
using Integers = Dense<int>;

class StridedProduct : public testing::Test {
 protected:
  Integers draw(Eigen::Index rows, Eigen::Index cols) {
    return Integers::NullaryExpr(rows, cols, [&] { return draw_(random_); });
  }

  std::mt19937 random_{12};
  std::uniform_int_distribution<int> draw_{-9, 9};
};

template <class Matrix>
Matrix in_50_digits(const Integers& x) {
  return x.cast<Digits50>();
}

void expect_equal(const Dense<Digits50>& product, const Integers& expected) {
  ASSERT_EQ(product.rows(), expected.rows());
  ASSERT_EQ(product.cols(), expected.cols());
  EXPECT_TRUE((product.array() == expected.cast<Digits50>().array()).all());
}

TEST_F(StridedProduct, OfAnySizeAndOrder) {
  for (const Eigen::Index n : {0, 1, 2, 3, 7, 25}) {
    const Integers a = draw(4, n), b = draw(n, 5);
    const auto A = in_50_digits<Dense<Digits50>>(a);
    const auto B = in_50_digits<Dense<Digits50>>(b);
    const Dense<Digits50, -1, -1, Eigen::RowMajor> A_by_rows = A, B_by_rows = B;
    expect_equal(A * B, a * b);
    expect_equal(A_by_rows * B, a * b);
    expect_equal(A * B_by_rows, a * b);
    expect_equal(B.transpose() * A_by_rows.transpose(), (a * b).transpose());
    expect_equal(A * B.col(2), a * b.col(2));
    expect_equal(A.row(1) * B, a.row(1) * b);
  }
}

TEST_F(StridedProduct, OfFixedSizes) {
  const Integers a = draw(6, 6), b = draw(6, 3), v = draw(6, 1);
  const auto A = in_50_digits<Dense<Digits50, 6, 6>>(a);
  const auto B = in_50_digits<Dense<Digits50, 6, 3>>(b);
  const auto x = in_50_digits<Dense<Digits50, 6, 1>>(v);
  expect_equal(A * B, a * b);
  expect_equal(B.transpose() * A, b.transpose() * a);
  expect_equal(A * x, a * v);
  expect_equal(x.transpose() * B, v.transpose() * b);
  expect_equal(A.topLeftCorner<3, 3>() * B.bottomRows<3>(),
               a.topLeftCorner(3, 3) * b.bottomRows(3));
}

TEST_F(StridedProduct, OfExpressionsWithoutMemory) {
  const Integers a = draw(5, 5), b = draw(5, 5), c = draw(5, 5);
  const auto A = in_50_digits<Dense<Digits50>>(a);
  const auto B = in_50_digits<Dense<Digits50>>(b);
  const auto C = in_50_digits<Dense<Digits50>>(c);
  expect_equal((A + B) * (B - C), (a + b) * (b - c));
  expect_equal(A * B * C, a * b * c);
  expect_equal(Digits50(3) * A * B, 3 * a * b);
  expect_equal(-A * B.transpose() * (Digits50(2) * C), -2 * a * b.transpose() * c);
}

TEST_F(StridedProduct, EntersSumsAndParts) {
  const Integers a = draw(5, 5), b = draw(5, 5);
  const auto A = in_50_digits<Dense<Digits50>>(a);
  const auto B = in_50_digits<Dense<Digits50>>(b);
  Integers sum = draw(5, 5);
  auto S = in_50_digits<Dense<Digits50>>(sum);
  sum += a * b;
  S += A * B;
  sum -= b * a.transpose();
  S.noalias() -= B * A.transpose();
  sum.block(1, 2, 3, 2) += a.topRows(3) * b.leftCols(2);
  S.block(1, 2, 3, 2).noalias() += A.topRows(3) * B.leftCols(2);
  sum.row(0) = sum.row(0) * a;
  S.row(0) = S.row(0) * A;
  sum = sum * sum;
  S = S * S;
  expect_equal(S, sum);
}

}  // namespace
}  // namespace treeline
