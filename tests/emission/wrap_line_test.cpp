#include <gtest/gtest.h>

#include "emission/emitted_text.hpp"

namespace treeline {
namespace {

const std::string kWord(101, 'w');

TEST(WrapLine, LeavesShortLinesAlone) {
  EXPECT_EQ(wrap_line("a = b + c;", 2), "  a = b + c;\n");
}

TEST(WrapLine, BreaksBehindOperators) {
  const std::string word(60, 'w');
  EXPECT_EQ(wrap_line("a = " + word + " + " + word + ";", 2),
            "  a = " + word + " +\n      " + word + ";\n");
}

// Would catch: a head of 430 columns, as its first argument alone is longer than a line.
TEST(WrapLine, GoesOnBehindAWordLongerThanALine) {
  EXPECT_EQ(wrap_line("f(" + kWord + ", b, " + kWord + ", d);", 0),
            "f(" + kWord + ",\n    b,\n    " + kWord + ",\n    d);\n");
  EXPECT_EQ(wrap_line(kWord, 0), kWord + "\n");
}

}  // namespace
}  // namespace treeline
