// Would catch: JSON that programs cannot read, coefficients that are shortened, an order or values
// other than those that the text has, and units of another parameter.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "description/read_urdf.hpp"
#include "inspect/print_tables.hpp"

namespace treeline {
namespace {

/// Two hinges about y, the second 1/3 m along x of the first.
Robot two_hinges() {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='two'><link name='base'/>"
      "<link name='a'><inertial><origin xyz='0.1 0 0.2'/><mass value='2'/>"
      "<inertia ixx='1' ixy='0' ixz='0' iyy='1.5' iyz='0' izz='1'/></inertial></link>"
      "<link name='b'><inertial><mass value='3'/>"
      "<inertia ixx='1' ixy='0' ixz='0' iyy='0.5' iyz='0' izz='1'/></inertial></link>"
      "<joint name='p' type='continuous'><parent link='base'/><child link='a'/>"
      "<axis xyz='0 1 0'/></joint>"
      "<joint name='q' type='continuous'><parent link='a'/><child link='b'/>"
      "<origin xyz='0.3333333333333333 0 0'/><axis xyz='0 1 0'/></joint></robot>",
      "two.urdf", diagnostics);
  EXPECT_TRUE(robot);
  return robot.value();
}

TEST(PrintBaseParameters, HasTheSameForPrograms) {
  Scene scene;
  scene.base = Base::fixed;
  scene.regressor.friction = true;
  scene.joint_friction["q"] = {0.25, 0, 0};
  const auto json = nlohmann::json::parse(print_base_parameters_json(two_hinges(), scene));
  EXPECT_EQ(json.at("robot"), "two");
  EXPECT_EQ(json.at("parameters"), 22);
  const auto& base = json.at("base_parameters");
  ASSERT_EQ(base.size(), 8U);
  EXPECT_EQ(base[0].at("name"), "a mc_x");
  EXPECT_EQ(base[0].at("unit"), "kg m");
  const auto& combination = base[0].at("combination");
  ASSERT_EQ(combination.size(), 2U);
  EXPECT_EQ(combination[0].at("parameter"), "a mc_x");
  EXPECT_EQ(combination[0].at("coefficient"), 1);
  EXPECT_EQ(combination[1].at("parameter"), "b m");
  EXPECT_EQ(combination[1].at("unit"), "kg");
  EXPECT_NEAR(combination[1].at("coefficient").get<double>(), 1.0 / 3, 1e-16);
  EXPECT_NEAR(base[0].at("value").get<double>(), 0.2 + 1, 1e-15);
  // About y, with the second link's mass at 1/3 m.
  EXPECT_EQ(base[2].at("name"), "a Iyy");
  EXPECT_EQ(base[2].at("unit"), "kg m^2");
  EXPECT_NEAR(base[2].at("value").get<double>(), 1.5 + 2 * (0.01 + 0.04) + 3.0 / 9, 1e-15);
  EXPECT_EQ(base[7].at("name"), "q viscous");
  EXPECT_EQ(base[7].at("unit"), "N m s/rad");
  EXPECT_EQ(base[7].at("value"), 0.25);
  EXPECT_EQ(json.at("without_effect").size(), 13U);
  const std::string text = print_base_parameters(two_hinges(), scene);
  std::size_t at = 0;
  for (const auto& each : base) {
    at = text.find(each.at("name").get<std::string>(), at);
    ASSERT_NE(at, std::string::npos) << each;
  }
}

}  // namespace
}  // namespace treeline
