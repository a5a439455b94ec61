#include "drawing/draw_robot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <regex>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "drawing/robot_solids.hpp"
#include "drawing/scene_solids.hpp"

// Would catch: a joint that does not move what it carries, a hidden face that is drawn, a robot
// that is cut off, and a link with a mesh only that is not seen at all.
namespace treeline {
namespace {

constexpr const char* kArm = R"(<robot name="arm"><link name="base"/>
  <link name="arm"><visual><origin xyz="0 0 0.5"/><geometry><box size="0.1 0.2 1"/></geometry></visual>
    <inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="hand"><visual><geometry><mesh filename="hand.stl"/></geometry></visual>
    <inertial><mass value="1"/><origin xyz="0 0 0.25"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="a" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="1 0 0"/>
    <limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="b" type="prismatic"><parent link="arm"/><child link="hand"/><origin xyz="0 0 1"/>
    <axis xyz="0 0 1"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>)";

constexpr double kQuarter = std::numbers::pi / 2;

struct Arm {
  Diagnostics diagnostics;
  Robot robot = parse_urdf(kArm, "arm.urdf", diagnostics).value();
  Scene scene = read_scene("", robot, diagnostics).value();
  LinkPlacer placer{robot, scene};
  std::vector<Visual> visuals = read_visuals(kArm, "arm.urdf", diagnostics);

  [[nodiscard]] std::string draw(const std::vector<Moment>& moments) const {
    return draw_robot(robot, placer, visuals, moments, {});
  }
  [[nodiscard]] Solids solids(double a, double b) const {
    return robot_solids(robot, visuals, placer.place(std::vector{a, b}), 1);
  }
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++times;
  }
  return times;
}

/// Highest corner of all faces, m.
double top(const Solids& solids) {
  double highest = -1e9;
  for (const Face& face : solids.faces) {
    for (const auto& corner : face.corners) highest = std::max(highest, corner.z());
  }
  return highest;
}

TEST(DrawRobot, ShapesAreWhereTheJointsPutThem) {
  const Arm arm;
  EXPECT_NEAR(top(arm.solids(0, 0)), 1.25, 1e-12);       // the rod to the hand's centre of mass
  EXPECT_NEAR(top(arm.solids(0, 0.5)), 1.75, 1e-12);     // which the sliding joint lifts
  EXPECT_NEAR(top(arm.solids(kQuarter, 0)), 0.1, 0.02);  // lying: half the width of the box
}

// Of six faces of a box three are seen.
TEST(DrawRobot, HiddenFacesAreNotDrawn) {
  const Arm arm;
  const Solids solids = arm.solids(0, 0);
  const auto of_box = std::count_if(solids.faces.begin(), solids.faces.end(),
                                    [](const Face& face) { return face.color[0] == 0.7; });
  EXPECT_EQ(of_box, 6);
  EXPECT_EQ(
      count(arm.draw({{{0, 0}, "", {}, {}}}), "<polygon"),
      // the floor, the box with two long sides in quarters, half the sides of the rod, its end
      1 + (4 + 4 + 1) + 10 + 1);
}

TEST(DrawRobot, EverythingIsInThePicture) {
  const Arm arm;
  std::string svg = arm.draw(
      {{{0, 0}, "rest", {}, {}}, {{kQuarter, 0.9}, "far", {Eigen::Vector3d(0, -2, 3)}, {}}});
  EXPECT_EQ(count(svg, "<svg x="), 2U);
  EXPECT_NE(svg.find(">far</text>"), std::string::npos);
  svg = std::regex_replace(svg, std::regex("<polygon class=.ground[^>]*>"), "");  // the floor
  const std::regex corner("([0-9.-]+),([0-9.-]+)[ \"]");
  for (std::sregex_iterator it(svg.begin(), svg.end(), corner), end; it != end; ++it) {
    EXPECT_GE(std::stod((*it)[1]), 0) << (*it)[0];
    EXPECT_LE(std::stod((*it)[1]), 240) << (*it)[0];
    EXPECT_GE(std::stod((*it)[2]), 0) << (*it)[0];
    EXPECT_LE(std::stod((*it)[2]), 280) << (*it)[0];
  }
}

// The link `base` has no shape, the link `hand` only a mesh.
TEST(DrawRobot, RodsAndBallsStandForLinksWithoutShapes) {
  const Solids solids = Arm().solids(0, 0.5);
  const auto ball_at = [&](double z) {
    return std::any_of(solids.balls.begin(), solids.balls.end(), [&](const Ball& ball) {
      return (ball.center - Eigen::Vector3d(0, 0, z)).norm() < 1e-12;
    });
  };
  EXPECT_TRUE(ball_at(0));     // the base's rod
  EXPECT_TRUE(ball_at(1.5));   // the joint of the hand
  EXPECT_TRUE(ball_at(1.75));  // the hand's centre of mass
}

TEST(DrawRobot, CaptionsCannotBreakTheFile) {
  const Arm arm;
  const std::string svg = arm.draw({{{0, 0}, "<script>&\x1b", {}, {}}});
  EXPECT_EQ(svg.find("<script>"), std::string::npos);
  EXPECT_NE(svg.find("&lt;script&gt;&amp;\\x1b"), std::string::npos) << svg;
}

// A ball and a box beside the arm. Would catch: obstacles that are not drawn, or cut off.
TEST(DrawRobot, ObstaclesStandBesideIt) {
  const Arm arm;
  SceneObstacle ball;
  ball.radius = 0.2;
  ball.origin.xyz = {2, 0, 1};
  SceneObstacle box;
  box.size = {0.5, 0.5, 0.1};
  box.origin.xyz = {0, 1, 0.05};  // on the floor, which is not drawn above what is deeper
  box.avoided = false;
  const Solids solids = obstacle_solids({ball, box});
  ASSERT_EQ(solids.balls.size(), 1U);
  EXPECT_EQ(solids.faces.size(), 6U);
  EXPECT_NE(solids.balls[0].color, solids.faces[0].color);
  const std::string without = arm.draw({{{0, 0}, "", {}, {}}});
  const std::string with =
      draw_robot(arm.robot, arm.placer, arm.visuals, {{{0, 0}, "", {}, {}}}, {}, solids);
  EXPECT_EQ(count(with, "<circle"), count(without, "<circle") + 1);
  EXPECT_EQ(count(with, "<polygon"), count(without, "<polygon") + 8);  // cut in halves
}

// A red ball before the arm and a blue one behind it, as seen from x and y. Would catch: what is
// behind drawn over what is before it.
TEST(DrawRobot, WhatIsNearIsDrawnLast) {
  const Arm arm;
  Solids balls;
  balls.balls.push_back({{1, 1, 0.5}, 0.2, {1, 0, 0}});
  balls.balls.push_back({{-1, -1, 0.5}, 0.2, {0, 0, 1}});
  const auto draw = [&](double azimuth) {
    return draw_robot(arm.robot, arm.placer, arm.visuals, {{{0, 0}, "", {}, balls}},
                      {azimuth, 0.25});
  };
  const std::regex circle("<circle[^>]*fill=\"#(..)0000\"/>|<circle[^>]*fill=\"#0000(..)\"/>");
  const auto first = [&](const std::string& svg) {
    std::smatch match;
    return std::regex_search(svg, match, circle) && match[1].matched ? "red" : "blue";
  };
  EXPECT_STREQ(first(draw(0.75)), "blue");
  EXPECT_STREQ(first(draw(0.75 + 2 * kQuarter)), "red");
}

// A long board lies under a cube at its near end, whose middle is lower than the board's. Would
// catch: a long face sorted by its middle alone, so that it is drawn over what stands before it.
TEST(DrawRobot, LongFacesAreCutBeforeTheyAreSorted) {
  const Arm arm;
  Solids solids;
  const auto at = [](double x, double y, double z) {
    return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
  };
  add_box({4, 0.1, 0.1}, at(0, 3, 0.05), {1, 0, 0}, solids);
  add_box({0.1, 0.1, 0.1}, at(-1.5, 3.2, 0.05), {0, 0, 1}, solids);  // before it, far from the eye
  const std::string svg =
      draw_robot(arm.robot, arm.placer, arm.visuals, {{{0, 0}, "", {}, solids}}, {0.75, 0.25});
  const std::regex red("<polygon[^>]*fill=\"#[^0].0000\"");
  const std::regex blue("<polygon[^>]*fill=\"#0000..\"");
  EXPECT_GT(std::distance(std::sregex_iterator(svg.begin(), svg.end(), red), {}), 8);
  std::smatch near;
  ASSERT_TRUE(std::regex_search(svg, near, blue));
  // The board's far end is drawn before the cube, the near end after it.
  const std::string before = svg.substr(0, static_cast<std::size_t>(near.position()));
  EXPECT_TRUE(std::regex_search(before, red));
  EXPECT_TRUE(std::regex_search(near.suffix().str(), red));
}

// Would catch: a picture that grows without bound with a hall's floor, or a state that is no
// number.
TEST(DrawRobot, AFaceIsCutIntoFewPieces) {
  const Arm arm;
  Solids hall;
  add_box({1e4, 1e4, 1e4}, Eigen::Isometry3d::Identity(), {0, 1, 0}, hall);
  const std::string svg =
      draw_robot(arm.robot, arm.placer, arm.visuals, {{{0, 0}, "", {}, hall}}, {});
  EXPECT_EQ(count(svg, "<polygon"), 9U + 11U + 3U * 64U);  // no floor below ground
}

// An object in the hand, whose frame is a quarter turn and 0.3 m off it. Would catch: a grasp taken
// the wrong way round, and another hand's.
TEST(DrawRobot, ObjectsAreInTheirFirstHand) {
  SceneObject object;
  object.grasps = {{"hand", {{0.3, 0, 0}, {0, 0, kQuarter}}}, {"elbow", {}}};
  SceneShape shape;
  shape.radius = 0.1;
  shape.origin.xyz = {0.2, 0, 0};
  ScenePoint elbow, hand;
  elbow.name = "elbow";
  hand.name = "hand";
  const std::vector<Eigen::Isometry3d> poses = {Eigen::Isometry3d::Identity(),
                                                Eigen::Isometry3d(Eigen::Translation3d(0, 0, 2))};
  const Solids solids = object_solids({object}, {{shape}}, {elbow, hand}, poses);
  ASSERT_EQ(solids.balls.size(), 1U);
  EXPECT_LT((solids.balls[0].center - Eigen::Vector3d(0.3, 0.2, 2)).norm(), 1e-12);
  EXPECT_TRUE(object_solids({object}, {{}}, {elbow, hand}, poses).balls.empty());
}

// The same picture twice, and colours that a dark page changes. Would catch: an order that depends
// on addresses, and black captions on a dark page.
TEST(DrawRobot, IsTheSameEachTimeAndHasColoursForDarkPages) {
  const std::vector<Moment> moments = {{{0, 0}, "a", {}, {}}, {{0, 0.5}, "b", {}, {}}};
  const std::string svg = Arm().draw(moments);
  EXPECT_EQ(svg, Arm().draw(moments));
  EXPECT_EQ(count(svg, "prefers-color-scheme:dark"), 1U);
  EXPECT_EQ(count(svg, "<text x"), 2U);
  EXPECT_EQ(count(svg, "class=\"ground\""), 2U);
}

}  // namespace
}  // namespace treeline
