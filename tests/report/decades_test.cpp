// Would catch: values drawn outside their axis, an axis without length, and powers of ten under the
// wrong unit.
#include "report/decades.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace treeline::report {
namespace {

TEST(Decades, HoldTheirValues) {
  for (const double factor : {1e-18, 0.9, 1.0, 3e7}) {
    const std::vector<double> values{factor, 2 * factor, 150 * factor};
    const Decades decades = decades_of(values);
    EXPECT_LT(decades.last - decades.first, 5);
    for (const double value : values) {
      EXPECT_GE(decades.at(value), 0) << value;
      EXPECT_LE(decades.at(value), 1) << value;
    }
    EXPECT_LT(decades_of(values, 1).first, decades.first);
  }
  EXPECT_GT(decades_of({5}).last, decades_of({5}).first);
  EXPECT_GT(decades_of({}).last, decades_of({}).first);
}

TEST(Decades, LieEvenly) {
  const Decades decades{2, 5};
  EXPECT_DOUBLE_EQ(decades.at(1e2), 0);
  EXPECT_DOUBLE_EQ(decades.at(1e3), 1.0 / 3);
  EXPECT_DOUBLE_EQ(decades.at(1e5), 1);
}

TEST(Decades, AreNamed) {
  EXPECT_EQ(time_name(0), "1 ns");
  EXPECT_EQ(time_name(4), "10 µs");
  EXPECT_EQ(time_name(7), "10 ms");
  EXPECT_EQ(time_name(-1), "1e-1 ns");
  EXPECT_EQ(time_name(9), "1e9 ns");
}

}  // namespace
}  // namespace treeline::report
