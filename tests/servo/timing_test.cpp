// Statistics compared with sorting, cycles compared with a clock set by hand. Would catch: a
// histogram bin that is off by one, jitter that accumulates, and a missed tick that is not skipped
// or not counted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "servo/clock.hpp"
#include "servo/cycle.hpp"
#include "servo/statistics.hpp"

namespace {

using treeline::servo::Cycle;
using treeline::servo::DurationStatistics;
using treeline::servo::SimulatedClock;
using treeline::servo::SteadyClock;

TEST(DurationStatistics, QuantilesAreThoseOfTheSortedSample) {
  std::mt19937_64 random(11);
  std::lognormal_distribution<double> spread(8.0, 3.0);
  DurationStatistics statistics;
  std::vector<double> sample;
  for (int i = 0; i < 10001; ++i) {
    const double value = std::floor(spread(random));
    sample.push_back(value);
    statistics.record(static_cast<std::int64_t>(value));
  }
  std::sort(sample.begin(), sample.end());
  EXPECT_EQ(statistics.count(), sample.size());
  EXPECT_EQ(statistics.minimum(), sample.front());
  EXPECT_EQ(statistics.maximum(), sample.back());
  for (const double fraction : {0.0, 0.01, 0.25, 0.5, 0.9, 0.99, 1.0}) {
    const auto rank = static_cast<std::size_t>(std::ceil(fraction * 10001.0));
    const double expected = sample[rank == 0 ? 0 : rank - 1];
    // Half a bin; an octave has 128 bins.
    EXPECT_NEAR(statistics.quantile(fraction), expected, expected / 256.0 + 0.5) << fraction;
  }
}

TEST(DurationStatistics, ExtremesOfTheRange) {
  DurationStatistics statistics;
  EXPECT_EQ(statistics.median(), 0.0);
  EXPECT_EQ(statistics.minimum(), 0.0);
  statistics.record(-5);
  EXPECT_EQ(statistics.maximum(), 0.0);
  statistics.record(std::numeric_limits<std::int64_t>::max());
  EXPECT_NEAR(statistics.quantile(1.0), 9.2e18, 9.2e18 / 128.0);
}

TEST(Cycle, PerfectClockHasPerfectPeriods) {
  SimulatedClock clock;
  Cycle cycle(clock, 1'000'000);
  for (int i = 0; i < 100; ++i) {
    cycle.begin_cycle();
    clock.advance(300'000);
    cycle.end_cycle();
  }
  EXPECT_EQ(cycle.periods().count(), 99U);
  EXPECT_EQ(cycle.periods().minimum(), 1e6);
  EXPECT_EQ(cycle.periods().maximum(), 1e6);
  EXPECT_EQ(cycle.jitters().maximum(), 0.0);
  EXPECT_EQ(cycle.timing().busy, 300'000);
  EXPECT_EQ(cycle.timing().slack, 700'000);
  EXPECT_EQ(cycle.skips(), 0U);
}

TEST(Cycle, OverrunSkipsTicksAndReturnsToTheGrid) {
  SimulatedClock clock;
  Cycle cycle(clock, 1'000'000);
  cycle.begin_cycle();
  clock.advance(2'500'000);  // past the ticks at 1 and 2 ms
  cycle.end_cycle();
  EXPECT_EQ(cycle.timing().skipped, 2);
  EXPECT_EQ(cycle.timing().slack, -1'500'000);
  EXPECT_EQ(clock.now(), 3'000'000);
  cycle.begin_cycle();
  EXPECT_EQ(cycle.timing().period, 3'000'000);
  EXPECT_EQ(cycle.timing().jitter, 0);
  cycle.end_cycle();
  EXPECT_EQ(cycle.skips(), 2U);
}

/// A clock that wakes late from time to time, as operating systems do.
struct LateClock {
  std::int64_t time = 0;
  std::int64_t lateness = 0;
  std::int64_t now() const { return time; }
  void sleep_until(std::int64_t until) {
    lateness = (lateness + 70'000) % 200'000;
    time = until + lateness;
  }
};

TEST(Cycle, LatenessDoesNotAccumulate) {
  LateClock clock;
  Cycle cycle(clock, 1'000'000);
  for (int i = 0; i < 1001; ++i) {
    cycle.begin_cycle();
    EXPECT_EQ(cycle.timing().jitter, clock.lateness);
    EXPECT_EQ(clock.time, 1'000'000LL * i + clock.lateness);
    cycle.end_cycle();
  }
  EXPECT_EQ(cycle.jitters().maximum(), 190'000.0);
  EXPECT_EQ(cycle.skips(), 0U);
}

// Would catch: preparations in the time of the next cycle, or none although there is time.
TEST(Cycle, PreparesBeforeTheTickWhereThereIsTime) {
  SimulatedClock clock;
  Cycle cycle(clock, 1'000'000);
  std::vector<std::int64_t> prepared;
  const auto prepare = [&] { prepared.push_back(clock.now()); };
  for (const std::int64_t busy : {300'000, 950'000, 100'000}) {
    cycle.begin_cycle();
    EXPECT_EQ(cycle.timing().jitter, 0);
    clock.advance(busy);
    cycle.end_cycle(100'000, prepare);
  }
  EXPECT_EQ(prepared, (std::vector<std::int64_t>{900'000, 2'900'000}));
  EXPECT_EQ(clock.now(), 3'000'000);
}

// The test assumes nothing about timing beyond what a monotonic clock guarantees.
TEST(Cycle, SteadyClockNeverWakesEarly) {
  SteadyClock clock;
  Cycle cycle(clock, 200'000);
  for (int i = 0; i < 20; ++i) {
    cycle.begin_cycle();
    EXPECT_GE(cycle.timing().jitter, 0);
    cycle.end_cycle();
  }
}

}  // namespace
