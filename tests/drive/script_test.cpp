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

}  // namespace
}  // namespace treeline::drive
