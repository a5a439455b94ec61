#include <gtest/gtest.h>

#include "passes/count_operations.hpp"
#include "passes/expect_same_function.hpp"
#include "passes/passes.hpp"
#include "passes/random_program.hpp"

// Would catch: a factor taken from a term that does not have it, a lost sign or term, and products
// that are computed twice because they have another use.
namespace treeline {
namespace {

void expect_flops(const Program& program, int before, int after) {
  const Program factored = factor_sums(program);
  EXPECT_EQ(count_operations(program).flops(), before);
  EXPECT_EQ(count_operations(factored).flops(), after);
  test::expect_same_function(program, factored);
}

using test::Inputs, test::program_of;

TEST(FactorSums, TakesOutACommonFactor) {
  expect_flops(program_of(3, [](const Inputs& x) { return Inputs{x[0] * x[1] - x[2] * x[1]}; }), 3,
               2);
  expect_flops(
      program_of(4,
                 [](const Inputs& x) {
                   return Inputs{-(x[0] * x[1]) - x[2] * x[1] + x[3] + 0.5 * (x[1] * x[3])};
                 }),
      7, 5);
}

TEST(FactorSums, TheFactorItselfIsATerm) {
  expect_flops(program_of(2, [](const Inputs& x) { return Inputs{x[0] * x[1] + x[1] * 0.5}; }), 3,
               2);
}

TEST(FactorSums, ConstantsAreFactorsToo) {
  expect_flops(program_of(2, [](const Inputs& x) { return Inputs{0.3 * x[0] + 0.3 * x[1]}; }), 3,
               2);
}

TEST(FactorSums, LeavesProductsWithOtherUses) {
  expect_flops(program_of(3,
                          [](const Inputs& x) {
                            const Expression a = x[0] * x[1];
                            const Expression b = x[2] * x[1];
                            return Inputs{a + b, a / b};
                          }),
               4, 4);
}

TEST(FactorSums, RandomProgramsKeepTheirValues) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const Program program = test::random_program(seed, 120);
    const Program factored = factor_sums(program);
    EXPECT_LE(count_operations(factored).flops(), count_operations(program).flops());
    test::expect_same_function(program, factored);
  }
}

}  // namespace
}  // namespace treeline
