#include "passes/count_operations.hpp"

#include <gtest/gtest.h>

#include "passes/two_link_arm.hpp"

// Would catch: figures in the contract that do not match the code below them.
namespace treeline {
namespace {

TEST(CountOperations, CountsEachKindOnceANode) {
  Program program;
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 3);
  const Expression shared = x[0] * x[1];
  program.results = {
      {{"y", 3, 1, ""}, {shared + sin(x[2]), -(shared / cos(x[2])), shared - sin(x[0])}}};
  const OperationCount count = count_operations(program);
  EXPECT_EQ(count.add, 2);
  EXPECT_EQ(count.mul, 1);
  EXPECT_EQ(count.div, 1);
  EXPECT_EQ(count.sin_cos, 2);
  EXPECT_EQ(count.flops(), 4);
}

}  // namespace
}  // namespace treeline
