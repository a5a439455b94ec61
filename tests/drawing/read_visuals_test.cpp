#include "drawing/read_visuals.hpp"

#include <gtest/gtest.h>

#include <numbers>

// Would catch: a shape at another place, of another size or colour, one that is dropped in silence,
// and a shape that is only to collide drawn beside one that is to be seen.
namespace treeline {
namespace {

constexpr const char* kRobot = R"(<robot name="arm">
<material name="red"><color rgba="0.9 0.1 0.2 1"/></material>
<link name="a">
  <visual><origin xyz="1 2 3" rpy="0 0 1.5707963267948966"/>
    <geometry><box size="0.1 0.2 0.3"/></geometry><material name="red"/></visual>
  <visual><geometry><cylinder radius="0.4" length="2"/></geometry>
    <material name="red"><color rgba="0 0 1 1"/></material></visual>
</link>
<link name="b">
  <visual><geometry><sphere radius="0.5"/></geometry></visual>
  <visual><geometry><mesh filename="package://arm/b.stl"/></geometry></visual>
  <visual><geometry><sphere radius="-1"/></geometry></visual>
  <visual/>
</link></robot>)";

TEST(ReadVisuals, HasPlaceSizeAndColour) {
  Diagnostics diagnostics;
  const auto visuals = read_visuals(kRobot, "arm.urdf", diagnostics);
  ASSERT_EQ(visuals.size(), 4U);
  EXPECT_EQ(visuals[0].link, "a");
  EXPECT_EQ(visuals[0].kind, VisualKind::box);
  EXPECT_EQ(visuals[0].size, Eigen::Vector3d(0.1, 0.2, 0.3));
  EXPECT_EQ(visuals[0].pose.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_LT((visuals[0].pose.linear() * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm(),
            1e-15);
  EXPECT_EQ(visuals[0].color, (Color{0.9, 0.1, 0.2}));
  EXPECT_EQ(visuals[1].kind, VisualKind::cylinder);
  EXPECT_EQ(visuals[1].size.head(2), Eigen::Vector2d(0.4, 2));
  EXPECT_EQ(visuals[1].color, (Color{0, 0, 1}));  // its own goes before that of the name
  EXPECT_EQ(visuals[2].kind, VisualKind::sphere);
  EXPECT_EQ(visuals[2].size[0], 0.5);
  EXPECT_EQ(visuals[3].kind, VisualKind::mesh);
  EXPECT_EQ(visuals[3].link, "b");
}

TEST(ReadVisuals, TakesCollisionsWhereALinkHasMeshesOnly) {
  constexpr const char* kMeshes = R"(<robot name="arm">
<link name="a">
  <visual><geometry><mesh filename="a.stl"/></geometry>
    <material name="own"><color rgba="0.2 0.4 0.6 1"/></material></visual>
  <collision><origin xyz="1 2 3"/><geometry><sphere radius="0.5"/></geometry></collision>
  <collision><geometry><mesh filename="a.stl"/></geometry></collision>
</link>
<link name="b">
  <visual><geometry><box size="1 1 1"/></geometry></visual>
  <visual><geometry><mesh filename="b.stl"/></geometry></visual>
  <collision><geometry><box size="2 2 2"/></geometry></collision>
</link>
<link name="unseen"><collision><geometry><sphere radius="1"/></geometry></collision></link>
</robot>)";
  Diagnostics diagnostics;
  const auto visuals = read_visuals(kMeshes, "arm.urdf", diagnostics);
  ASSERT_EQ(visuals.size(), 4U);
  EXPECT_EQ(visuals[1].link, "a");
  EXPECT_EQ(visuals[1].kind, VisualKind::sphere);
  EXPECT_EQ(visuals[1].size[0], 0.5);
  EXPECT_EQ(visuals[1].pose.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(visuals[1].color, (Color{0.2, 0.4, 0.6}));
  EXPECT_EQ(visuals[2].size, Eigen::Vector3d(1, 1, 1));
  EXPECT_EQ(visuals[3].kind, VisualKind::mesh);
}

TEST(ReadVisuals, WarnsOfShapesWithoutASize) {
  Diagnostics diagnostics;
  (void)read_visuals(kRobot, "arm.urdf", diagnostics);
  ASSERT_EQ(diagnostics.list().size(), 2U);
  EXPECT_EQ(diagnostics.list()[0].line, 12);
  EXPECT_EQ(diagnostics.list()[1].line, 13);
  EXPECT_EQ(diagnostics.list()[1].element, "robot/link[b]/visual");
}

TEST(ReadCollisions, HasWhatLinksCollideByAndNothingElse) {
  constexpr const char* kBoth = R"(<robot name="arm">
<link name="a">
  <visual><geometry><box size="1 1 1"/></geometry></visual>
  <collision><origin xyz="1 2 3"/><geometry><sphere radius="0.5"/></geometry></collision>
  <collision><geometry><mesh filename="a.stl"/></geometry></collision>
</link>
<link name="b"><collision><geometry><cylinder radius="0.1" length="2"/></geometry></collision>
  <collision><origin xyz="1 0 0"/><geometry><capsule radius="0.1" length="2"/></geometry></collision>
  <collision><geometry><capsule radius="0.1"/></geometry></collision>
  <collision><geometry><sphere radius="0.0"/></geometry></collision></link>
</robot>)";
  Diagnostics diagnostics;
  const auto shapes = read_collisions(kBoth, "arm.urdf", diagnostics);
  ASSERT_EQ(shapes.size(), 7U);
  EXPECT_EQ(shapes[0].link, "a");
  EXPECT_EQ(shapes[0].kind, VisualKind::sphere);
  EXPECT_EQ(shapes[0].pose.translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(shapes[1].kind, VisualKind::mesh);
  EXPECT_EQ(shapes[1].file, "a.stl");
  EXPECT_EQ(shapes[2].kind, VisualKind::cylinder);
  EXPECT_EQ(shapes[2].size.head(2), Eigen::Vector2d(0.1, 2));
  EXPECT_EQ(shapes[3].kind, VisualKind::cylinder);  // of a capsule, with two spheres at its ends
  EXPECT_EQ(shapes[4].pose.translation(), Eigen::Vector3d(1, 0, 1));
  EXPECT_EQ(shapes[5].pose.translation(), Eigen::Vector3d(1, 0, -1));
  EXPECT_EQ(shapes[6].size.norm(), 0);  // a point
  ASSERT_EQ(diagnostics.list().size(), 1U);
  EXPECT_EQ(diagnostics.list()[0].line, 9);
}

}  // namespace
}  // namespace treeline
