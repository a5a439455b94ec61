#include <gtest/gtest.h>

#include <iostream>

#include "interpreter/extend_force_propagators.hpp"
#include "interpreter/factor_mass_matrix.hpp"
#include "interpreter/physics.hpp"
#include "interpreter/propagate_inertia.hpp"
#include "interpreter/propagate_unit_forces.hpp"

// Every route to Lambda^-1 compared with the definition J M^-1 J^T, in 50 digits. Would catch: a
// wrong propagator, a common ancestor that is not the nearest, a pair of points on one path that is
// treated as on two, rows of the wrong point, and zeros that are assumed where there are none.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)

Matrix50 by_definition(const Case& c) {
  const Matrix50 J = jacobian<Digits50>(c.model, c.points, c.q);
  if (c.model.nv == 0) return J * J.transpose();
  const Matrix50 M_inverse = mass_matrix<Digits50>(c.model, c.q)
                                 .fullPivLu()
                                 .solve(Matrix50::Identity(c.model.nv, c.model.nv));
  return J * M_inverse * J.transpose();
}

/// kAlgebra has twelve of 50 digits for the condition number of M; these robots need ten.
const Digits50 kAgreement("1e-40");

void expect_all_routes(const Case& c) {
  const Matrix50 expected = by_definition(c);
  const auto check = [&](const char* route, const Matrix50& actual) {
    EXPECT_LT(relative_error(actual, expected), kAgreement) << route;
  };
  check("lambda_inverse", lambda_inverse<Digits50>(c.model, c.points, c.q));
  check("sparse factors", lambda_inverse_by_sparse_factors<Digits50>(c.model, c.points, c.q));
  if (c.model.has_mimics()) return;
  check("EFPA", lambda_inverse_by_extended_propagators<Digits50>(c.model, c.points, c.q));
  check("PV-OSIM", lambda_inverse_by_unit_forces<Digits50>(c.model, c.points, c.q));
  check("PV-OSIM reduced", lambda_inverse_by_reduced_unit_forces<Digits50>(c.model, c.points, c.q));
}

class LambdaRoutes : public testing::TestWithParam<NamedOptions> {};

INSTANTIATE_TEST_SUITE_P(Assorted, LambdaRoutes, testing::ValuesIn(assorted_mechanisms()),
                         [](const testing::TestParamInfo<NamedOptions>& tested) {
                           return std::string(tested.param.name) + "_" +
                                  std::to_string(tested.index);
                         });

TEST_P(LambdaRoutes, AgreeOnPointsAnywhere) {
  expect_all_routes(random_case(GetParam().seed, GetParam().options));
}

OperationalPoint<Digits50> point_on(int body, Rng& rng) {
  OperationalPoint<Digits50> point;
  point.name = "on " + std::to_string(body);
  point.body = body;
  point.p = random_entries<Digits50>(rng, 3, 0.5);
  point.R = rotation_about<Digits50>(Vector3<Digits50>::UnitX(), Digits50(rng.uniform(-3, 3)));
  point.axes = rng.chance(0.5) ? PointAxes::world : PointAxes::local;
  for (bool& row : point.rows) row = rng.chance(0.7);
  return point;
}

// Two points on the last body, its parent and grandparent, on the first body, on the base, and on
// any body.
TEST_P(LambdaRoutes, AgreeOnPointsThatShareLinksAndPaths) {
  Case c = random_case(GetParam().seed, GetParam().options);
  Rng rng(GetParam().seed + 77);
  const int last = c.model.size() - 1;
  if (last < 0) return;
  const auto parent = [&](int body) { return body == kWorld ? kWorld : c.model.body(body).parent; };
  c.points.clear();
  for (const int body : {last, last, parent(last), parent(parent(last)), 0, kWorld,
                         rng.below(last + 1), rng.below(last + 1)}) {
    c.points.push_back(point_on(body, rng));
  }
  expect_all_routes(c);
}

/// Like `random_case`, with two points on one body that has at least `depth` bodies above it.
Case case_of_one_body(std::uint64_t seed, const RandomOptions& options) {
  Case c = random_case(seed, options);
  Rng rng(seed + 78);
  const int body = c.model.size() - 1 - rng.below(2);
  c.points = {point_on(body, rng), point_on(body, rng)};
  return c;
}

// Table 5.1 for chains and, with the branches beside the path, for trees. Behind a floating joint
// the base is not felt, so its size must not matter.
TEST(InertiaPropagation, IsExactOnFloatingBases) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = case_of_one_body(seed, {.joints = 8,
                                           .branching = seed % 2 == 0 ? 0.4 : 0,
                                           .mix = {5, 1, 2, 0, 0.3, 0.5},
                                           .floating_base = true});
    ASSERT_TRUE(permits_inertia_propagation(c.model, c.points));
    EXPECT_LT(
        relative_error(lambda_inverse_by_inertia_propagation<Digits50>(c.model, c.points, c.q, 1e6),
                       by_definition(c)),
        kAgreement);
  }
}

Digits50 big_base_error(const Case& c, const Matrix50& expected, int exponent) {
  const Digits50 size = pow(Digits50(10), exponent);
  return relative_error(
      lambda_inverse_by_inertia_propagation<Digits50>(c.model, c.points, c.q, size), expected);
}

// A big base is not a fixed base: the error is c / size with c of the order of one, until rounding,
// about size times the last digit, becomes larger.
TEST(InertiaPropagation, ErrsByTheInverseOfTheBigBase) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    const Case c = case_of_one_body(
        seed, {.joints = 7, .branching = seed % 2 == 0 ? 0.4 : 0, .mix = {5, 1, 2, 0, 0, 0.5}});
    const Matrix50 expected = by_definition(c);
    const Digits50 c_over_size = big_base_error(c, expected, 8);
    EXPECT_GT(c_over_size * 1e8, 1e-3);
    EXPECT_LT(c_over_size * 1e8, 1e4);
    for (const int exponent : {12, 16, 20}) {
      const Digits50 predicted = c_over_size * pow(Digits50(10), 8 - exponent);
      const Digits50 error = big_base_error(c, expected, exponent);
      EXPECT_LT(abs(error / predicted - 1), 1e-3) << "base size 1e" << exponent;
    }
    EXPECT_GT(big_base_error(c, expected, 44), big_base_error(c, expected, 24));
  }
}

// What remains in double: at best about half of the digits.
TEST(InertiaPropagation, LosesDigitsInDoubleWhateverTheBase) {
  const Case c = case_of_one_body(
      1, {.joints = 7, .branching = 0, .mix = {5, 1, 2, 0, 0, 0.5}, .aligned = 0.3});
  const Matrix50 expected = by_definition(c);
  const auto model = cast<double>(c.model);
  const auto points = cast<double>(c.points);
  const Vector<double> q = c.q.cast<double>();
  double best = 1;
  for (int exponent = 2; exponent <= 16; ++exponent) {
    const Matrix<double> in_double =
        lambda_inverse_by_inertia_propagation<double>(model, points, q, std::pow(10.0, exponent));
    const double error = static_cast<double>(relative_error(in_double.cast<Digits50>(), expected));
    std::cout << "base size 1e" << exponent << ": error " << error << '\n';
    best = std::min(best, error);
  }
  EXPECT_GT(best, 1e-12);
  EXPECT_LT(best, 1e-4);
  const Matrix<double> by_forces = lambda_inverse_by_unit_forces<double>(model, points, q);
  EXPECT_LT(relative_error(by_forces.cast<Digits50>(), expected), 1e-12);
}

}  // namespace
}  // namespace treeline::tests
