#include <gtest/gtest.h>

#include "interpreter/physics.hpp"

// Lambda^-1 compared with its definition J M^-1 J^T, in 50 digits. Would catch: a
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

void expect_definition(const Case& c) {
  const Matrix50 actual = lambda_inverse<Digits50>(c.model, c.points, c.q);
  EXPECT_LT(relative_error(actual, by_definition(c)), kAgreement);
}

class LambdaInverse : public testing::TestWithParam<NamedOptions> {};

INSTANTIATE_TEST_SUITE_P(Assorted, LambdaInverse, testing::ValuesIn(assorted_mechanisms()),
                         [](const testing::TestParamInfo<NamedOptions>& tested) {
                           return std::string(tested.param.name) + "_" +
                                  std::to_string(tested.index);
                         });

TEST_P(LambdaInverse, OfPointsAnywhere) {
  expect_definition(random_case(GetParam().seed, GetParam().options));
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
TEST_P(LambdaInverse, OfPointsThatShareLinksAndPaths) {
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
  expect_definition(c);
}

}  // namespace
}  // namespace treeline::tests
