// Would catch: columns that are not aligned, and tables wider than a terminal.
#include "text/align_columns.hpp"

#include <gtest/gtest.h>

namespace treeline {
namespace {

TEST(AlignColumns, LinesUpAndLeavesOutEmptyOnes) {
  EXPECT_EQ(align_columns({{"name"}, {"kg", true}, {"empty"}, {"x"}},
                          {{"a", "1.25", "", "p"}, {"l\xC3\xA4nger", "3", "", ""}}),
            "  name      kg  x\n"
            "  a       1.25  p\n"
            "  l\xC3\xA4nger     3\n");
}

TEST(AlignColumns, BreaksWhatIsTooWide) {
  EXPECT_EQ(align_columns({{"name"}, {"kg", true}, {"why"}},
                          {{"left_upper_arm_link", "1.25", "because of this and that"}}, 32),
            "  name           kg  why\n"
            "  left_upper_  1.25  because of\n"
            "  arm_link           this and\n"
            "                     that\n");
}

// Would catch: numbers beyond the edge of the terminal, where no column can be made narrower.
TEST(AlignColumns, DividesWhatCannotStandSideBySide) {
  EXPECT_EQ(align_columns({{"name"}, {"kg", true}, {"m", true}, {"s", true}},
                          {{"arm", "1234567", "1234567", "7654321"}}, 24),
            "  name       kg        m\n"
            "  arm   1234567  1234567\n"
            "\n"
            "  name        s\n"
            "  arm   7654321\n");
}

}  // namespace
}  // namespace treeline
