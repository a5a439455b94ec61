// Would catch: durations in a wrong bin, extremes or a mean that are not exact.
#include "firmware/statistics.hpp"

#include <gtest/gtest.h>

namespace treeline::firmware {
namespace {

TEST(FirmwareStatistics, BinsArePowersOfTwo) {
  using Small = Statistics<6>;
  EXPECT_EQ(Small::bin_of(0), 0U);
  EXPECT_EQ(Small::bin_of(1), 1U);
  EXPECT_EQ(Small::bin_of(7), 3U);
  EXPECT_EQ(Small::bin_of(8), 4U);
  EXPECT_EQ(Small::bin_of(0xffffffff), 5U);
  EXPECT_EQ(Statistics<33>::bin_of(0xffffffff), 32U);
}

TEST(FirmwareStatistics, ExtremesAndMeanAreExact) {
  Statistics<12> statistics;
  EXPECT_EQ(statistics.least(), 0U);
  EXPECT_EQ(statistics.mean(), 0U);
  for (const uint32_t ticks : {40U, 10U, 25U, 0xffffffffU}) statistics.record(ticks);
  EXPECT_EQ(statistics.count(), 4U);
  EXPECT_EQ(statistics.least(), 10U);
  EXPECT_EQ(statistics.largest(), 0xffffffffU);
  EXPECT_EQ(statistics.mean(), (40U + 10U + 25U + 0xffffffffULL) / 4);
  EXPECT_EQ(statistics.count_of(Statistics<12>::bin_of(10)), 1U);
}

}  // namespace
}  // namespace treeline::firmware
