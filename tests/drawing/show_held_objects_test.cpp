#include "drawing/show_held_objects.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "description/read_urdf.hpp"

// Would catch: an object that is shown at the hand's link in place of its point, or turned the
// wrong way, and text that is changed where nothing is held.
namespace treeline {
namespace {

constexpr const char* kHand = R"(<robot name="hand"><link name="palm"><inertial><mass value="1"/>
  <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link></robot>)";
constexpr double kQuarter = std::numbers::pi / 2;

Scene scene_with_box() {
  Scene scene;
  ScenePoint point;
  point.name = "grip";
  point.link = "palm";
  point.origin = {{0, 0, 0.5}, {0, 0, kQuarter}};
  scene.operational_points.push_back(point);
  SceneObject box;
  box.name = "box";
  box.grasps.push_back({"grip", {{0.2, 0, 0}, {kQuarter, 0, 0}}});
  scene.objects.push_back(box);
  return scene;
}

// The point is a quarter turn about z, so x of the grasp is y of the palm.
TEST(ShowHeldObjects, PutsAnObjectIntoItsFirstHand) {
  SceneShape shape;
  shape.size = {0.1, 0.2, 0.3};
  const std::string shown = show_held_objects(kHand, scene_with_box(), {{shape}});
  Diagnostics diagnostics;
  const auto robot = parse_urdf(shown, "hand.urdf", diagnostics);
  ASSERT_TRUE(robot.has_value());
  ASSERT_EQ(robot->joints.size(), 1U);
  const Joint& joint = robot->joints.front();
  EXPECT_EQ(joint.type, JointType::fixed);
  EXPECT_EQ(robot->links[static_cast<std::size_t>(joint.parent)].name, "palm");
  EXPECT_EQ(robot->links[static_cast<std::size_t>(joint.child)].name, "box, held");
  EXPECT_NEAR(joint.origin.xyz[0], 0.0, 1e-15);
  EXPECT_NEAR(joint.origin.xyz[1], 0.2, 1e-15);
  EXPECT_NEAR(joint.origin.xyz[2], 0.5, 1e-15);
  EXPECT_NEAR(joint.origin.rpy[0], kQuarter, 1e-15);
  EXPECT_NEAR(joint.origin.rpy[2], kQuarter, 1e-15);
  EXPECT_NE(shown.find("size=\"0.1 0.2 0.3\""), std::string::npos) << shown;
}

TEST(ShowHeldObjects, LeavesOutWhatHasNoShapeAndWhatIsNoUrdf) {
  EXPECT_EQ(show_held_objects(kHand, scene_with_box(), {{}}).find("held"), std::string::npos);
  EXPECT_EQ(show_held_objects("<robot", scene_with_box(), {}), "<robot");
}

}  // namespace
}  // namespace treeline
