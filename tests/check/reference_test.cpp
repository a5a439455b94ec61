#include "oracle/reference.hpp"

#include <cmath>
#include <limits>

#include "check/judges.hpp"
#include "fixture.hpp"
#include "oracle/result_sizes.hpp"
#include "oracle/symmetric_matrices.hpp"

// Arithmetic of errors, scales, condition numbers and bounds. Would catch: a scale that a result
// exceeds, a condition number that depends on units, and NaN that counts as no error.

namespace treeline::tests {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(Error, IsInUnitsOfTheEntrysSize) {
  FunctionReference reference;
  reference.high = {1, 100};
  reference.low = {0, 0};
  reference.size = {4, 100};
  EXPECT_EQ(error_in_ulp({1 + 8 * 0x1p-52, 100}, reference, 0x1p-52), 2);
  EXPECT_EQ(error_in_ulp({1, 100}, reference, 0x1p-52), 0);
}

TEST(Error, SeesWhatADoubleCannotHold) {
  FunctionReference reference;
  reference.high = {1};
  reference.low = {0x1p-54};
  reference.size = {1};
  EXPECT_EQ(error_in_ulp({1}, reference, 0x1p-52), 0.25);
}

TEST(Error, IsInfiniteWhereNothingCanBeCompared) {
  FunctionReference reference;
  reference.high = {0};
  reference.low = {0};
  reference.size = {1};
  EXPECT_EQ(error_in_ulp({kNaN}, reference, 0x1p-52), kInfinity);
  EXPECT_EQ(error_in_ulp({kInfinity}, reference, 0x1p-52), kInfinity);
  reference.size = {0};  // a structural zero has no rounding
  EXPECT_EQ(error_in_ulp({1e-300}, reference, 0x1p-52), kInfinity);
  EXPECT_EQ(error_in_ulp({0}, reference, 0x1p-52), 0);
}

TEST(Condition, OfTwoByTwo) {
  Eigen::Matrix2d A;
  A << 1, 0.75, 0.75, 1;
  EXPECT_NEAR(scaled_condition(A, A.diagonal()), 4, 1e-12);  // smallest eigenvalue 1/4
}

TEST(Condition, DoesNotDependOnUnits) {
  Eigen::Matrix3d A;
  A << 4, 1, 0.5, 1, 3, 0.2, 0.5, 0.2, 2;
  const Eigen::Vector3d units(1e-6, 1, 1e6);
  const Eigen::Matrix3d B = units.asDiagonal() * A * units.asDiagonal();
  const double condition = scaled_condition(A, A.diagonal());
  EXPECT_NEAR(scaled_condition(B, B.diagonal()), condition, 1e-9 * condition);
}

TEST(Condition, IsInfiniteForWhatIsNotPositiveDefinite) {
  const Eigen::Vector2d d(1, 1);
  Eigen::Matrix2d A;
  A << 1, 2, 2, 1;
  EXPECT_EQ(scaled_condition(A, d), kInfinity);
  A << 1, 0, 0, 0;
  EXPECT_EQ(scaled_condition(A, A.diagonal()), kInfinity);
  A << 1, kNaN, kNaN, 1;
  EXPECT_EQ(scaled_condition(A, d), kInfinity);
}

// A diagonal that is only rounding error: well-conditioned by its own scale, singular by the sizes
// of its terms.
TEST(Condition, TakesRoundingForZero) {
  const Eigen::Matrix2d A = Eigen::Vector2d(1, 1e-17).asDiagonal();
  EXPECT_NEAR(scaled_condition(A, A.diagonal()), 1, 1e-12);
  EXPECT_GT(scaled_condition(A, Eigen::Vector2d(1, 1)), 1e16);
}

// A matrix whose entries were computed with errors of `first` roundings, as the inverse of another.
// The oracle is the inverse of a 2 by 2 matrix, 1 / (1 - c^2) on the diagonal.
TEST(Condition, OfTwoSolvesMultiply) {
  constexpr long double kRounding = 0x1p-53L;
  constexpr double kFirst = 50;
  const long double c = 1 - 1e-3L;
  const long double off = c + kFirst * kRounding;
  const Eigen::Matrix2d A{{1, static_cast<double>(c)}, {static_cast<double>(c), 1}};
  const Conditions conditions{kFirst, scaled_condition(A, A.diagonal())};
  const auto change = static_cast<double>((1 - c * c) / (1 - off * off) - 1);
  EXPECT_NEAR(change, conditions.amplification() * 0x1p-53, 0.01 * change);
  EXPECT_GT(change, 10 * conditions.largest() * 0x1p-53);
}

std::vector<StateReference> references_with(const std::vector<FunctionReference>& functions) {
  std::vector<StateReference> references;
  for (const FunctionReference& function : functions) references.push_back({{}, {function}});
  return references;
}

TEST(Bound, IsTheWorstOfTheInterpreterPerCondition) {
  FunctionReference good;
  good.interpreter_error = 2;
  FunctionReference bad;
  bad.amplification = 1000;
  bad.interpreter_error = 500;
  FunctionReference singular;
  singular.singular = true;
  singular.interpreter_error = 1e9;
  FunctionReference failed;
  failed.interpreter_error = kInfinity;
  const Bound bound =
      find_bound(0, Function::forward_dynamics, references_with({good, bad, singular, failed}));
  EXPECT_EQ(bound.interpreter, 2);
  EXPECT_EQ(bound.solve, Solve::mass_matrix);
  EXPECT_EQ(bound.at(good), 8 + 16 * 2);
  EXPECT_EQ(bound.at(bad), 8 + 16 * 2 * 1000);
  good.computed_angles = 3;
  EXPECT_EQ(bound.at(good), 8 + 3 + 16 * 2);
}

TEST(Bound, WithoutASolveKnowsNoCondition) {
  EXPECT_EQ(find_bound(0, Function::gravity, {}).solve, Solve::none);
  EXPECT_EQ(find_bound(0, Function::lambda_inverse, {}).solve, Solve::mass_matrix);
  EXPECT_EQ(find_bound(0, Function::lambda, {}).solve, Solve::lambda_inverse);
  EXPECT_EQ(find_bound(0, Function::control_torque, {}).solve, Solve::lambda_inverse);
}

TEST(Quantile, OfFew) {
  std::vector<double> values = {5, 1, 4, 2, 3};
  EXPECT_EQ(quantile(values, 0.5), 3);
  EXPECT_EQ(quantile(values, 0.99), 5);
  std::vector<double> none;
  EXPECT_EQ(quantile(none, 0.5), 0);
}

// Sums of magnitudes are at least as large as the magnitude of the sum, for every function of
// random robots in all classes of states. A scale that omits a term would be exceeded somewhere.
TEST(Sizes, NoResultExceedsThem) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    RandomOptions options;
    options.floating_base = seed % 3 == 0;
    options.mimic = seed % 2 == 0 ? 0.3 : 0;
    options.external_forces = 1;
    options.mix.planar = 1;
    const Subjects subjects = draw(seed, options);
    ReferenceOptions some;
    some.states = 20;
    some.seed = seed;
    for (const StateReference& reference :
         make_references(subjects.robot, subjects.scene, subjects.generation, some)) {
      for (std::size_t i = 0; i < reference.functions.size(); ++i) {
        const FunctionReference& function = reference.functions[i];
        if (function.singular) continue;
        ASSERT_EQ(function.size.size(), function.high.size());
        ASSERT_EQ(function.graph.size(), function.high.size());
        for (std::size_t k = 0; k < function.high.size(); ++k) {
          // Due to a quaternion's rounding, a rotation matrix may be a little larger than one. The
          // bound of the condition number was found with these figures in double.
          EXPECT_LE(std::abs(function.high[k]),
                    function.size[k] * (1 + 1e-13 * function.condition) + 1e-40)
              << function_name(subjects.generation.functions[i].function) << " entry " << k
              << ", seed " << seed << ", state " << reference.state.index;
        }
      }
    }
  }
}

TEST(References, AreTheSameOnAnyNumberOfThreads) {
  const Subjects subjects = load("planar3r");
  ReferenceOptions options;
  options.states = 12;
  options.threads = 1;
  const auto one = make_references(subjects.robot, subjects.scene, subjects.generation, options);
  options.threads = 5;
  int told = 0;
  options.progress = [&](int done, int total) {
    EXPECT_EQ(done, ++told);
    EXPECT_EQ(total, 12);
  };
  const auto many = make_references(subjects.robot, subjects.scene, subjects.generation, options);
  EXPECT_EQ(told, 12);
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t s = 0; s < one.size(); ++s) {
    EXPECT_EQ(one[s].state.q, many[s].state.q);
    for (std::size_t i = 0; i < one[s].functions.size(); ++i) {
      EXPECT_EQ(one[s].functions[i].high, many[s].functions[i].high);
      EXPECT_EQ(one[s].functions[i].low, many[s].functions[i].low);
    }
  }
}

}  // namespace
}  // namespace treeline::tests
