// Would catch: numbers that are read in part, read in the user's locale or rounded, and text that
// is not a number but accepted as one.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <locale>

#include "description/read_number.hpp"
#include "description/read_urdf.hpp"
#include "diagnosed.hpp"

namespace treeline {
namespace {

TEST(Number, IsReadWhole) {
  EXPECT_EQ(read_number("0.1"), 0.1);
  EXPECT_EQ(read_number(" \t-2.5e-1\n"), -0.25);
  EXPECT_EQ(read_number("+3"), 3.0);
  EXPECT_EQ(read_number("1."), 1.0);
  EXPECT_EQ(read_number(".5"), 0.5);
  EXPECT_EQ(read_number("5e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(read_number("inf"), std::numeric_limits<double>::infinity());
  for (const char* text : {"", " ", "a", "1.57.", "0x10", "1,5", "1 2", "nan", "-nan", "1e999",
                           "--1", "+-1", "+ 1", "1e", "1d3", "1.0f", "1_000"}) {
    EXPECT_FALSE(read_number(text)) << text;
  }
}

// The oracle is the position of the first digit, counted by hand.
TEST(Number, BelowEveryDoubleIsZero) {
  for (const char* text : {"1e-400", "-1e-400", "0.0001e-399", "1e-99999999999999999999",
                           "1000e-403", ".0e-400", "0.00e5"}) {
    ASSERT_TRUE(read_number(text)) << text;
    EXPECT_EQ(*read_number(text), 0) << text;
    EXPECT_EQ(std::signbit(*read_number(text)), text[0] == '-') << text;
  }
  EXPECT_EQ(read_number("0." + std::string(400, '0') + "1"), 0);
  EXPECT_EQ(read_number("0." + std::string(400, '0') + "1e401"), 1);
  for (const char* text : {"1e400", "1e+400", "0.001e312", "-1e99999999999999999999"}) {
    EXPECT_FALSE(read_number(text)) << text;
  }
  EXPECT_FALSE(read_number("1" + std::string(400, '0') + "."));
  EXPECT_TRUE(rounds_to_zero("-1e-400"));
  EXPECT_FALSE(rounds_to_zero("0.00e5"));
}

class DecimalComma : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(Number, DoesNotDependOnTheLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new DecimalComma));
  EXPECT_EQ(read_number("0.5"), 0.5);
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='r'><link name='a'><inertial><mass value='0.5'/></inertial></link></robot>",
      "r.urdf", diagnostics);
  std::locale::global(before);
  ASSERT_TRUE(robot) << to_string(diagnostics);
  EXPECT_EQ(robot->links[0].inertial->mass, 0.5);
}

TEST(Numbers, AreCounted) {
  EXPECT_EQ(read_numbers(" 1  2\t3\n"), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(read_numbers(""), std::vector<double>{});
  EXPECT_FALSE(read_numbers("1, 2, 3"));
  EXPECT_FALSE(read_numbers("1 inf 3"));
}

}  // namespace
}  // namespace treeline
