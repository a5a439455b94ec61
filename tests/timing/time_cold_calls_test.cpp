#include "timing/time_cold_calls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>

// What is called cold, and that it is cold. Would catch: a call that is timed more often than
// another, one whose memory is flushed for another state, and an eviction that evicts nothing.

namespace treeline::tests {
namespace {

std::vector<int> called;

template <int i>
void entry(const void* const*, void* const*) {
  called.push_back(i);
}

TEST(TimeColdCalls, CallsEachInEveryRound) {
  const CallArguments arguments(GeneratedFunction{}, std::vector<State>(3), Real::float64);
  called.clear();
  const auto timings = time_cold_calls(
      {{{entry<0>, &arguments}, "no such"}, {{entry<1>, &arguments}, "no such"}}, 4);
  ASSERT_EQ(timings.size(), 2U);
  EXPECT_EQ(timings[0].from_cache.ratio, 1);
  EXPECT_GT(timings[1].from_cache.nanoseconds, 0);
  const std::size_t ways = timings[0].from_memory ? 2 : 1;
  ASSERT_EQ(called.size(), 4 * 2 * ways);
  for (std::size_t round = 0; round < 4; ++round) {
    EXPECT_EQ(called[2 * ways * round], static_cast<int>(round % 2)) << "the other one begins";
  }
}

/// Nanoseconds to read a number, with those of the clock.
double time_to_read(const std::vector<double>& numbers, std::size_t i) {
  const auto start = std::chrono::steady_clock::now();
  const volatile double* const at = &numbers[i];
  (void)*at;
  return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
}

TEST(EvictCaches, MakesReadingSlower) {
  std::vector<double> numbers(4096, 1.0);
  std::vector<double> warm;
  std::vector<double> cold;
  for (int round = 0; round < 51; ++round) {
    (void)time_to_read(numbers, 2048);
    warm.push_back(time_to_read(numbers, 2048));
    const std::array<std::span<const std::byte>, 1> data{std::as_bytes(std::span(numbers))};
    if (!evict_from_caches(data, {})) GTEST_SKIP() << "no instruction to flush a cache line";
    (void)time_to_read(warm, 0);
    cold.push_back(time_to_read(numbers, 2048));
  }
  std::nth_element(warm.begin(), warm.begin() + 25, warm.end());
  std::nth_element(cold.begin(), cold.begin() + 25, cold.end());
  EXPECT_GT(cold[25], warm[25]);
}

}  // namespace
}  // namespace treeline::tests
