#include "timing/time_calls.hpp"

#include <gtest/gtest.h>

#include <algorithm>

// The order in which builds are called, independent of their times. Would catch: builds that are
// timed one after the other, states that are left out, and results that belong to another build.

namespace treeline::tests {
namespace {

std::vector<int> called;

template <int i>
void entry(const void* const*, void* const*) {
  called.push_back(i);
}

/// Arguments of a function without arguments, for three states.
CallArguments no_arguments() {
  static const GeneratedFunction kNone;
  return {kNone, std::vector<State>(3), Real::float64};
}

TEST(TimeCalls, CallsAllInEveryRound) {
  const CallArguments arguments = no_arguments();
  called.clear();
  const auto timings = time_calls({{entry<0>, &arguments}, {entry<1>, &arguments}}, {5, 1e-6});
  ASSERT_EQ(timings.size(), 2U);
  EXPECT_EQ(timings[0].ratio, 1);
  EXPECT_EQ(timings[0].noise, 0);
  // Twice three states for finding the number of passes; in each round three for warming up and
  // three timed.
  ASSERT_EQ(called.size(), 2U * 6 + 5 * 2 * 6);
  EXPECT_EQ(std::count(called.begin(), called.end(), 0), 6 + 5 * 6);
  for (std::size_t round = 0; round < 5; ++round) {
    const std::size_t first = 12 + round * 12;
    EXPECT_EQ(called[first], static_cast<int>(round % 2)) << "the other one begins each round";
    EXPECT_EQ(called[first + 6], 1 - static_cast<int>(round % 2));
  }
}

TEST(TimeCalls, NothingIsNothing) {
  EXPECT_TRUE(time_calls({}).empty());
}

}  // namespace
}  // namespace treeline::tests
