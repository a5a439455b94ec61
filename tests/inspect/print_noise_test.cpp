// Would catch: a number that is taken as exact but not listed, or listed without its place, and a
// suggestion that does not help.
#include <gtest/gtest.h>

#include "description/read_urdf.hpp"
#include "inspect/print_tables.hpp"

namespace treeline {
namespace {

constexpr const char* kUrdf = R"(<robot name="arm">
  <link name="base"/>
  <joint name="first" type="continuous">
    <origin xyz="0.3 -3.1e-17 2e-13" rpy="1.1476e-27 0 3.1415926535897860"/>
    <axis xyz="0 0 1"/><parent link="base"/><child link="upper"/></joint>
  <link name="upper"><inertial><origin xyz="0 0 0.1"/><mass value="1"/>
    <inertia ixx="1" ixy="1e-19" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
</robot>)";

std::string printed(double noise) {
  Diagnostics diagnostics;
  Scene scene;
  scene.noise = noise;
  return print_noise(parse_urdf(kUrdf, "arm.urdf", diagnostics).value(), scene);
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(PrintNoise, ListsEveryNumberWithItsPlace) {
  const std::string text = printed(0x1p-51);
  EXPECT_TRUE(
      has(text, "line 4     1.1e-27    robot/joint[first]/origin: roll 1.1476e-27 rad is 0"))
      << text;
  EXPECT_TRUE(has(text, "robot/joint[first]/origin: y -3.1e-17 m is 0")) << text;
  EXPECT_TRUE(has(text, "robot/link[upper]/inertial: a first moment or product")) << text;
  EXPECT_FALSE(has(text, "2e-13 m is 0")) << text;
  EXPECT_TRUE(has(text, "within 1e-12 of an exact number: 2.")) << text;
  EXPECT_TRUE(has(text, "Taken as exact: 3 ")) << text;
}

TEST(PrintNoise, OfAWiderLimitListsMoreAndSuggestsNothing) {
  const std::string text = printed(2e-12);
  EXPECT_TRUE(has(text, "2e-13 m is 0")) << text;
  EXPECT_TRUE(has(text, "is pi")) << text;
  EXPECT_FALSE(has(text, "Used as written")) << text;
}

TEST(PrintNoise, OfKeptNumbersIsNone) {
  const std::string text = printed(0);
  EXPECT_TRUE(has(text, "every number is used as written")) << text;
  EXPECT_FALSE(has(text, "is 0\n")) << text;
}

}  // namespace
}  // namespace treeline
