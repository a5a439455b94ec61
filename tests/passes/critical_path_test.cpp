#include <gtest/gtest.h>

#include "passes/choose.hpp"
#include "passes/passes.hpp"

// Would catch: a path that counts all operations instead of those that wait for each other, dead
// code that counts, and a choice of a long chain because it has one operation less.
namespace treeline {
namespace {

/// The sum of x[0] to x[n - 1]: sequential, or in halves.
Program sum_of(int n, bool in_halves, int divisions = 0) {
  Program program;
  const Graph::Scope scope(program.graph);
  std::vector<Expression> terms;
  for (int i = 0; i < n; ++i) {
    terms.push_back(program.graph.input("x[" + std::to_string(i) + "]"));
  }
  const Expression first = terms.front();
  while (terms.size() > 1) {
    std::vector<Expression> sums;
    if (in_halves) {
      for (std::size_t i = 0; i + 1 < terms.size(); i += 2) {
        sums.push_back(terms[i] + terms[i + 1]);
      }
    } else {
      sums.assign(terms.begin() + 1, terms.end());
      sums.front() = terms[0] + terms[1];
    }
    terms = std::move(sums);
  }
  Expression sum = terms.front();
  for (int i = 0; i < divisions; ++i) sum = sum / first;
  program.results = {{{"y", 1, 1, ""}, {sum}}};
  return program;
}

TEST(CriticalPath, IsTheLongestChain) {
  EXPECT_EQ(critical_path(sum_of(1, false)), 0);
  EXPECT_EQ(critical_path(sum_of(16, false)), 15 * 3);
  EXPECT_EQ(critical_path(sum_of(16, true)), 4 * 3);
  EXPECT_EQ(critical_path(sum_of(16, true, 2)), 4 * 3 + 2 * 13);
}

TEST(CriticalPath, LeavesOutWhatNoResultNeeds) {
  Program program = sum_of(16, false);
  program.results.front().values = {Expression(0)};
  EXPECT_EQ(critical_path(program), 0);
}

TEST(CriticalPath, DecidesBetweenEqualCounts) {
  const auto choice = choose({sum_of(16, false), sum_of(16, true)});
  EXPECT_EQ(critical_path(choice->program), 4 * 3);
  EXPECT_EQ(choice->chosen.count.add, choice->rejected.front().count.add);
}

}  // namespace
}  // namespace treeline
