// Would catch: a contract that gives joints the unit of others, or an argument without one.
#include "recursion/tree/declare_inputs.hpp"

#include <gtest/gtest.h>

#include "description/read_urdf.hpp"
#include "mechanism/build_mechanism.hpp"

namespace treeline::tests {
namespace {

/// One moving link behind a joint of this type.
Mechanism mechanism_with(const std::string& type) {
  const std::string limit = type == "revolute" || type == "prismatic"
                                ? "<limit lower='-1' upper='1' effort='1' velocity='1'/>"
                                : "";
  const std::string urdf =
      "<robot name='r'><link name='a'/><joint name='j' type='" + type +
      "'><parent link='a'/><child link='b'/>" + limit +
      "</joint><link name='b'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' "
      "iyy='1' iyz='0' izz='1'/></inertial></link></robot>";
  Diagnostics diagnostics;
  return build_mechanism(parse_urdf(urdf, "r.urdf", diagnostics).value(), Scene{});
}

TEST(Units, AreThoseOfTheJoints) {
  EXPECT_EQ(unit_of(Quantity::q, mechanism_with("continuous")), "rad");
  EXPECT_EQ(unit_of(Quantity::tau, mechanism_with("revolute")), "N m");
  EXPECT_EQ(unit_of(Quantity::qd, mechanism_with("prismatic")), "m/s");
  EXPECT_EQ(unit_of(Quantity::qdd, mechanism_with("planar")), "rad/s^2, m/s^2");
}

// A quaternion has no unit; its velocity is one of rotation.
TEST(Units, OfFloatingJoints) {
  EXPECT_EQ(unit_of(Quantity::q, mechanism_with("floating")), "m");
  EXPECT_EQ(unit_of(Quantity::qd, mechanism_with("floating")), "rad/s, m/s");
}

TEST(Units, StandInTheContract) {
  Program program;
  const Graph::Scope scope(program.graph);
  const TracedInputs inputs(mechanism_with("prismatic"), Function::inverse_dynamics, program);
  ASSERT_EQ(program.arguments.size(), 3U);
  EXPECT_EQ(program.arguments[0].meaning, "joint coordinates, m");
  EXPECT_EQ(program.arguments[2].meaning, "joint accelerations, m/s^2");
}

}  // namespace
}  // namespace treeline::tests
