#include <gtest/gtest.h>

#include "passes/count_operations.hpp"
#include "passes/expect_same_function.hpp"
#include "passes/passes.hpp"
#include "passes/random_program.hpp"

// Would catch: terms that are lost or counted twice when groups are taken apart, and wrong signs of
// shared pairs.
namespace treeline {
namespace {

using test::Inputs, test::program_of;

void expect_flops(const Program& program, int before, int after) {
  const Program shared = share_pairs(program);
  EXPECT_EQ(count_operations(program).flops(), before);
  EXPECT_EQ(count_operations(shared).flops(), after);
  test::expect_same_function(program, shared);
}

TEST(SharePairs, OfSumsWhateverTheOrderAndSign) {
  expect_flops(program_of(4,
                          [](const Inputs& x) {
                            return Inputs{(x[0] + x[1]) - x[2], (x[3] - x[0]) + x[2]};
                          }),
               4, 3);
}

TEST(SharePairs, OfProducts) {
  expect_flops(program_of(4,
                          [](const Inputs& x) {
                            return Inputs{(x[0] * x[1]) * x[2], -(x[3] * x[0]) * x[2]};
                          }),
               4, 3);
}

TEST(SharePairs, PairsOfPairs) {
  expect_flops(program_of(5,
                          [](const Inputs& x) {
                            return Inputs{(x[0] + x[1]) + (x[2] + x[3]),
                                          (x[0] + x[2]) + (x[1] + x[4]),
                                          (x[2] + x[1]) - x[0] * x[3]};
                          }),
               9, 6);
}

TEST(SharePairs, SquaresAndRepeatedFactors) {
  expect_flops(program_of(2,
                          [](const Inputs& x) {
                            return Inputs{x[0] * x[0] * x[1], (x[0] * x[1]) * (x[0] * x[0])};
                          }),
               4, 3);
}

TEST(SharePairs, RandomProgramsKeepTheirValues) {
  for (unsigned seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    const Program program = test::random_program(seed, 120);
    const Program shared = share_pairs(program);
    EXPECT_LE(count_operations(shared).flops(), count_operations(program).flops());
    test::expect_same_function(program, shared);
  }
}

}  // namespace
}  // namespace treeline
