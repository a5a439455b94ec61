// Would catch: a script whose lines run into each other, whose waits end early or never, or whose
// last line is lost without a line break.
#include "drive/script.hpp"

#include <gtest/gtest.h>

namespace treeline::drive {
namespace {

TEST(Script, ObeysLineByLineAndWaits) {
  Script script("start\n\n# a comment\njoint a to 1\nwait\nhold");
  script.close();
  Script::Line line;
  ASSERT_TRUE(script.next(0.0, false, line));
  EXPECT_EQ(line.text, "start");
  EXPECT_FALSE(script.next(0.0, false, line));  // not in the same report
  ASSERT_TRUE(script.next(0.02, false, line));
  EXPECT_EQ(line.number, 4);
  ASSERT_TRUE(script.next(0.04, true, line));
  EXPECT_EQ(line.text, "wait");
  script.wait(0.04, 0.0);
  EXPECT_FALSE(script.next(5.0, true, line));
  EXPECT_FALSE(script.ended(5.0, false));
  ASSERT_TRUE(script.next(5.0, false, line));
  EXPECT_EQ(line.text, "hold");
  EXPECT_TRUE(script.ended(6.0, false));
}

TEST(Script, WaitsForATime) {
  Script script("a\nb\n");
  Script::Line line;
  script.wait(1.0, 2.5);
  EXPECT_FALSE(script.next(3.4, false, line));
  EXPECT_TRUE(script.next(3.5, true, line));
  EXPECT_FALSE(script.ended(9.0, false));  // more may come
  script.append("c");
  EXPECT_TRUE(script.next(4.0, false, line));
  EXPECT_FALSE(script.next(5.0, false, line));  // `c` is not complete
  script.append("d\n");
  EXPECT_TRUE(script.next(6.0, false, line));
  EXPECT_EQ(line.text, "cd");
}

// Would catch: memory that an input without end fills, of one line or of many.
TEST(Script, TakesNoMoreThanItHasRoomFor) {
  Script script;
  for (int i = 0; i < 1000; ++i) script.append(std::string(10000, 'x'));
  script.append("\n");
  Script::Line line;
  ASSERT_TRUE(script.next(1.0, false, line));
  EXPECT_GT(line.text.size(), 400U) << "it is refused as too long";
  EXPECT_LE(line.text.size(), 4096U);
  int lines = 0;
  for (; !script.is_full() && lines < 100000; ++lines) script.append("hold\n");
  EXPECT_LE(lines, 1000);
  EXPECT_TRUE(script.next(2.0, false, line));
  EXPECT_FALSE(script.is_full());
}

}  // namespace
}  // namespace treeline::drive
