// Would catch: a controller whose points have rows that no joint can move, of which nobody is told
// before the robot faults; and words where all rows can be moved, or no controller leads them.
#include "inspect/warn_of_rows.hpp"

#include <gtest/gtest.h>

#include <string>

#include "description/diagnosed.hpp"
#include "description/limited_arm.hpp"
#include "description/read_scene.hpp"

namespace treeline {
namespace {

const std::string kSound = "lower='-1' upper='1' effort='30' velocity='2'";

/// What is told of the tool of an arm that moves in a plane, with these rows.
std::string told(const std::string& rows, const std::string& more) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='arm'><link name='base'/>\n" + limited_link("first") + limited_link("second") +
          limited_joint("slide", "prismatic", "base", "first", kSound) +
          limited_joint("turn", "revolute", "first", "second", kSound) + "</robot>",
      "arm.urdf", diagnostics);
  const auto scene = parse_scene(
      "operational_points:\n  - {name: tool, link: second, rows: [" + rows + "]}\n" + more,
      "s.yaml", robot.value(), diagnostics);
  EXPECT_TRUE(scene) << to_string(diagnostics);
  Diagnostics of_rows;
  warn_of_rows(robot.value(), scene.value(), of_rows);
  return to_string(of_rows);
}

const std::string kController = "functions: []\ncontroller: {laws: task_impedance}\n";

TEST(WarnOfRows, NamesThoseThatNothingMoves) {
  const std::string text = told("x, y, z, rx, ry, rz", kController);
  EXPECT_NE(text.find("s.yaml: warning: operational_points: the joints cannot move rows x, z, rx, "
                      "rz of point \"tool\""),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("rows: [y, ry]"), std::string::npos) << text;
}

TEST(WarnOfRows, IsSilentWhereAllCanBeMovedOrNothingLeadsThem) {
  EXPECT_EQ(told("y, ry", kController), "");
  EXPECT_EQ(told("x, y, z, rx, ry, rz", "functions: [jacobian]\n"), "");
}

}  // namespace
}  // namespace treeline
