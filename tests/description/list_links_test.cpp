// Would catch: lists of links that lose the tree, or that never end.
#include <gtest/gtest.h>

#include <algorithm>

#include "description/read_urdf.hpp"
#include "description/robot_queries.hpp"

namespace treeline {
namespace {

std::string link(const std::string& name) {
  return "<link name='" + name + "'/>";
}

std::string joint(const std::string& parent, const std::string& child, const std::string& type) {
  return "<joint name='" + child + "_joint' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/></joint>";
}

Robot robot_of(const std::string& content) {
  Diagnostics diagnostics;
  return parse_urdf("<robot name='r'>" + content + "</robot>", "r.urdf", diagnostics).value();
}

TEST(ListLinks, IndentsByTree) {
  const Robot robot =
      robot_of(link("base") + link("right") + link("hand") + link("left") +
               joint("base", "left", "continuous") + joint("left", "hand", "fixed") +
               joint("base", "right", "continuous"));
  EXPECT_EQ(list_links(robot), "  base\n    left\n      hand\n    right");
  EXPECT_EQ(suggest_link("hnd", robot), "did you mean \"hand\"?");
  EXPECT_EQ(suggest_link("gripper", robot),
            "its links are, each below the one that carries it:\n" + list_links(robot));
  EXPECT_EQ(suggest_link("left_joint", robot), "did you mean \"left\"?");
  EXPECT_EQ(suggest_joint("right", robot), "did you mean \"right_joint\"?");
  EXPECT_EQ(suggest_joint("wheel", robot), "its joints that move are left_joint, right_joint");
}

TEST(ListLinks, CutsLongOnes) {
  const auto name = [](int i) { return std::string("l").append(std::to_string(i)); };
  std::string content = link(name(0));
  for (int i = 1; i < 300; ++i) {
    content += link(name(i)) + joint(name(i - 1), name(i), "continuous");
  }
  const std::string list = list_links(robot_of(content));
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 40);
  EXPECT_NE(list.find("and 260 more, which `treeline inspect` lists"), std::string::npos) << list;
}

}  // namespace
}  // namespace treeline
