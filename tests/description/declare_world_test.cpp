// Would catch: a robot that hangs on an undeclared world and is refused, or held elsewhere; a world
// that is added where the file has one; a change that is not told.
#include <gtest/gtest.h>

#include "description/read_urdf.hpp"
#include "description/urdf_parts.hpp"
#include "diagnosed.hpp"

namespace treeline {
namespace {

const std::string kOnWorld =
    "<link name='arm'/><link name='tip'/>\n<joint name='stand' type='fixed'><parent link='world'/>"
    "<child link='arm'/><origin xyz='0 0 2'/></joint><joint name='j' type='continuous'>"
    "<parent link='arm'/><child link='tip'/></joint>";

TEST(DeclareWorld, HoldsTheBaseWithANote) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf("<robot name='r'>" + kOnWorld + "</robot>", "r.urdf", diagnostics);
  ASSERT_TRUE(robot) << to_string(diagnostics);
  EXPECT_EQ(robot->links[static_cast<std::size_t>(robot->root)].name, "world");
  EXPECT_EQ(robot->links.size(), 3U);
  EXPECT_EQ(robot->joints[0].origin.xyz[2], 2);
  expect_diagnosed(
      diagnostics, "r.urdf",
      {Severity::note, 2, "robot/joint", "it is the ground", "<link name=\"world\"/>"});
}

TEST(DeclareWorld, LeavesAWorldThatIsThere) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf("<robot name='r'><link name='world'/>" + kOnWorld + "</robot>",
                                "r.urdf", diagnostics);
  ASSERT_TRUE(robot) << to_string(diagnostics);
  EXPECT_EQ(robot->links.size(), 3U);
  EXPECT_EQ(to_string(diagnostics).find("ground"), std::string::npos);
}

}  // namespace
}  // namespace treeline
