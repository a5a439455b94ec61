// Would catch: a bound that is told smaller than it is, a range that is told wider, and either
// moved where it has as few digits as are told.
#include "text/round_outward.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace treeline {
namespace {

TEST(RoundOutward, TellsTheNextDecimal) {
  EXPECT_EQ(rounded_up(1.2300001e-15, 2), "1.3e-15");
  EXPECT_EQ(rounded_up(1.2e-15, 2), "1.2e-15");
  EXPECT_EQ(rounded_up(std::nextafter(1.2e-15, 1.0), 2), "1.3e-15");
  EXPECT_EQ(rounded_up(9.91e-5, 1), "1e-04");
  EXPECT_EQ(rounded_up(9.91e-5, 2), "1.0e-04");
  EXPECT_EQ(rounded_up(0, 2), "0.0e+00");
  EXPECT_EQ(round_up(1234.5, 3), 1240);
  EXPECT_EQ(round_down(std::nextafter(3.142, 0.0), 4), 3.141);
  EXPECT_EQ(round_down(3.142, 4), 3.142);
  EXPECT_EQ(round_up(std::numeric_limits<double>::infinity(), 2),
            std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(round_up(std::nan(""), 2)));
}

TEST(RoundOutward, IsABoundOfEveryMagnitude) {
  double value = 4.94e-300;
  for (int i = 0; i < 4000; ++i, value *= 1.41421356) {
    for (int digits = 1; digits <= 4; ++digits) {
      const double up = round_up(value, digits);
      const double down = round_down(value, digits);
      ASSERT_GE(up, value);
      ASSERT_LE(down, value);
      ASSERT_LE(up - down, value * std::pow(10, 1 - digits) * (1 + 1e-9)) << value << " " << digits;
      ASSERT_EQ(round_up(up, digits), up);
    }
    if (value > 1e300) break;
  }
}

}  // namespace
}  // namespace treeline
