#include "passes/choose.hpp"

#include <gtest/gtest.h>

// Would catch: the more expensive program being emitted, rejected candidates that are missing from
// the report, and ties that are decided by chance.
namespace treeline {
namespace {

Program sum_of(const char* key, int terms, bool divide) {
  Program program;
  program.route = {key, key};
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
  const auto choice =
      choose({sum_of("long", 9, false), sum_of("short", 4, false), sum_of("middle", 6, false)});
  ASSERT_TRUE(choice.has_value());
  EXPECT_EQ(choice->chosen.route.algorithm, "short");
  EXPECT_EQ(choice->chosen.count.add, 4);
  EXPECT_EQ(count_operations(choice->program).add, 4);
  ASSERT_EQ(choice->rejected.size(), 2u);
  EXPECT_EQ(choice->rejected[0].route.algorithm, "middle");
  EXPECT_EQ(choice->rejected[1].route.algorithm, "long");
}

TEST(Choose, DivisionsWeighMore) {
  const auto choice = choose({sum_of("divides", 3, true), sum_of("adds", 5, false)});
  EXPECT_EQ(choice->chosen.route.algorithm, "adds");
}

// Would catch: costs of a processor that one of the parts of the choice does not know.
TEST(Choose, CostsAreThoseOfTheProcessor) {
  const auto algorithm = [](const OperationCosts& costs) {
    const auto choice = choose({sum_of("divides", 3, true), sum_of("adds", 10, false)}, costs);
    EXPECT_EQ(choice->rejected.size(), 1U);
    EXPECT_LT(choice->chosen.weighted, choice->rejected.front().weighted);
    return choice->chosen.route.algorithm;
  };
  EXPECT_EQ(algorithm({.quotient = 1, .waiting = 0}), "divides");  // 3 against 10
  EXPECT_EQ(algorithm({.quotient = 4, .waiting = 0}), "adds");     // 12
}

TEST(Choose, FirstOfEqualsWins) {
  EXPECT_EQ(choose({sum_of("a", 3, false), sum_of("b", 3, false)})->chosen.route.algorithm, "a");
}

TEST(Choose, NothingFromNothing) {
  EXPECT_FALSE(choose({}).has_value());
}

}  // namespace
}  // namespace treeline
