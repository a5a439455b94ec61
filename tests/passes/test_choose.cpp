#include <gtest/gtest.h>

#include "passes/choose.hpp"

// Would catch: the more expensive program being emitted, rejected candidates that are missing from
// the report, and ties that are decided by chance.
namespace treeline {
namespace {

Program sum_of(int terms, bool divide) {
  Program program;
  const Graph::Scope scope(program.graph);
  Expression sum;
  for (int i = 0; i <= terms; ++i) {
    const Expression x = program.graph.input("x[" + std::to_string(i) + "]");
    sum = divide && i > 0 ? sum / x : sum + x;
  }
  program.results = {{{"y", 1, 1, ""}, {sum}}};
  return program;
}

TEST(Choose, TakesTheCheapestAndReportsTheOthers) {
  const auto choice = choose(
      {{"long", sum_of(9, false)}, {"short", sum_of(4, false)}, {"middle", sum_of(6, false)}});
  ASSERT_TRUE(choice.has_value());
  EXPECT_EQ(choice->chosen.method, "short");
  EXPECT_EQ(choice->chosen.count.add, 4);
  EXPECT_EQ(count_operations(choice->program).add, 4);
  ASSERT_EQ(choice->rejected.size(), 2u);
  EXPECT_EQ(choice->rejected[0].method, "middle");
  EXPECT_EQ(choice->rejected[1].method, "long");
}

TEST(Choose, DivisionsWeighMore) {
  const auto choice = choose({{"divides", sum_of(3, true)}, {"adds", sum_of(5, false)}});
  EXPECT_EQ(choice->chosen.method, "adds");
}

TEST(Choose, FirstOfEqualsWins) {
  EXPECT_EQ(choose({{"a", sum_of(3, false)}, {"b", sum_of(3, false)}})->chosen.method, "a");
}

TEST(Choose, NothingFromNothing) {
  EXPECT_FALSE(choose({}).has_value());
}

}  // namespace
}  // namespace treeline
