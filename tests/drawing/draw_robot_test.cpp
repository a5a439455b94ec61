#include "drawing/draw_robot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <regex>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
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

/// Faces that are drawn: closed lines.
std::size_t count_faces(const std::string& svg) {
  return count(svg, "zM") + count(svg, "z\"");
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
      count_faces(arm.draw({{{0, 0}, "", {}, {}}})),
      // the floor, the box with two long sides in quarters, half the sides of the rod, its end
      1 + (4 + 4 + 1) + 6 + 1);
}

/// Largest and least coordinates of all lines, px.
Eigen::AlignedBox2d extent_of(const std::string& svg) {
  Eigen::AlignedBox2d box;
  const std::regex line("M[-0-9 l]*");
  const std::regex number("-?[0-9]+");
  for (std::sregex_iterator it(svg.begin(), svg.end(), line), end; it != end; ++it) {
    const std::string points = it->str();
    Eigen::Vector2d at = Eigen::Vector2d::Zero();
    for (std::sregex_iterator n(points.begin(), points.end(), number); n != end; ++n) {
      const double x = std::stod((n++)->str());
      at += Eigen::Vector2d(x, std::stod(n->str())) / Camera::kUnits;
      box.extend(at);
    }
  }
  return box;
}

TEST(DrawRobot, EverythingIsInThePicture) {
  const Arm arm;
  std::string svg = arm.draw(
      {{{0, 0}, "rest", {}, {}}, {{kQuarter, 0.9}, "far", {{Eigen::Vector3d(0, -2, 3)}}, {}}});
  EXPECT_EQ(count(svg, "<svg x="), 2U);
  EXPECT_NE(svg.find(">far</text>"), std::string::npos);
  svg = std::regex_replace(svg, std::regex("<path class=.ground[^>]*>"), "");  // the floor
  const Eigen::AlignedBox2d box = extent_of(svg);
  EXPECT_GE(box.min().minCoeff(), 9.9);  // the margin
  EXPECT_LE(box.max().x(), 230.1);
  EXPECT_LE(box.max().y(), 270.1);
  EXPECT_GT(box.sizes().maxCoeff(), 200);
}

// The link `base` has no shape, the link `hand` only a mesh.
TEST(DrawRobot, RodsAndBallsStandForLinksWithoutShapes) {
  Arm arm;
  arm.robot.links[0].inertial = Inertial{};
  arm.robot.links[0].inertial->mass = 1;
  const Solids solids = arm.solids(0, 0.5);
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
  EXPECT_EQ(count_faces(with), count_faces(without) + 8);  // cut in halves
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
                      {azimuth, 0.25, 240, ""});
  };
  const std::regex circle("<circle color=\"#(..)0000\"|<circle color=\"#0000(..)\"");
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
  const std::string svg = draw_robot(arm.robot, arm.placer, arm.visuals, {{{0, 0}, "", {}, solids}},
                                     {0.75, 0.25, 240, ""});
  const std::regex red("<path color=\"#[^0].0000\"");
  const std::regex blue("<path color=\"#0000..\"");
  std::smatch near;
  ASSERT_TRUE(std::regex_search(svg, near, blue));
  // The board's far end is drawn before the cube, the near end after it.
  const std::string before = svg.substr(0, static_cast<std::size_t>(near.position()));
  EXPECT_TRUE(std::regex_search(before, red));
  EXPECT_TRUE(std::regex_search(near.suffix().str(), red));
}

// Two faces of one colour that overlap in the picture and go round in opposite directions. Would
// catch: a hole where they overlap.
TEST(DrawRobot, FacesOfOneColourLeaveNoHole) {
  const Arm arm;
  Solids solids;
  const Eigen::Vector3d normal = Eigen::Vector3d::UnitX();
  solids.faces.push_back({{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}, normal, {1, 0, 0}});
  solids.faces.push_back({{{2, 0, 0}, {2, 0, 1}, {2, 1, 1}, {2, 1, 0}}, normal, {1, 0, 0}});
  const std::string svg = draw_robot(arm.robot, arm.placer, {}, {{{0, 0}, "", {}, solids}}, {});
  std::smatch red;
  ASSERT_TRUE(std::regex_search(svg, red, std::regex("<path color=\"#[^0].0000\" d=\"([^\"]*)\"")));
  const std::string data = red[1];
  EXPECT_GT(count(data, "M"), 1U);
  const std::regex face("M[-0-9]+ ?[-0-9]+l(-?[0-9]+) ?(-?[0-9]+) ?(-?[0-9]+) ?(-?[0-9]+)");
  for (std::sregex_iterator it(data.begin(), data.end(), face), end; it != end; ++it) {
    const auto number = [&](std::size_t i) { return std::stod((*it)[i]); };
    EXPECT_GT(number(1) * number(4) - number(2) * number(3), 0) << it->str();
  }
}

// Would catch: a picture that grows without bound with a hall's floor, or a state that is no
// number.
TEST(DrawRobot, AFaceIsCutIntoFewPieces) {
  const Arm arm;
  Solids hall;
  add_box({1e4, 1e4, 1e4}, Eigen::Isometry3d::Identity(), {0, 1, 0}, hall);
  const std::string svg =
      draw_robot(arm.robot, arm.placer, arm.visuals, {{{0, 0}, "", {}, hall}}, {});
  EXPECT_EQ(count_faces(svg), 9U + 7U + 3U * 64U);  // no floor below ground
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
  EXPECT_EQ(count(svg, "<text fill=\"#1c1c1c\" x"), 2U);
  EXPECT_EQ(count(svg, "class=\"ground\""), 2U);
}

// Would catch: a picture that is black where `currentColor` is looked up where it is written, as by
// CairoSVG: every shape has its colour as an attribute, or gets its own by a rule of its own.
TEST(DrawRobot, ShapesHaveTheirColoursWhereInheritanceIsNotKnown) {
  const std::vector<Eigen::Vector3d> path = {{0, 0, 0}, {1, 0, 0}};
  const std::string svg = Arm().draw({{{0, 0.5}, "a", {path}, {}}});
  EXPECT_EQ(count(svg, "[color]{fill:currentColor;stroke:currentColor}"), 1U);
  const std::regex shape("<(path|circle|text|rect)[^>]*>");
  int shapes = 0;
  for (std::sregex_iterator at(svg.begin(), svg.end(), shape), end; at != end; ++at, ++shapes) {
    EXPECT_TRUE(std::regex_search(at->str(), std::regex(" (color|fill)=\"(#|none)"))) << at->str();
  }
  EXPECT_GT(shapes, 10);
}

// A pyramid in the hand, and its mirror image. Would catch: the inside of a mesh that is drawn, a
// rod that is drawn through it, and a colour of the file that is lost.
TEST(DrawRobot, MeshesHideTheirInside) {
  Arm arm;
  const std::array<Eigen::Vector3d, 4> corners = {
      {{0, 0, 0}, {0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}};
  Visual& hand = arm.visuals.back();
  for (const auto& [a, b, c] :
       {std::array<std::size_t, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
    hand.triangles.push_back({{corners[a], corners[b], corners[c]}, Color{0, 0, 1}});
  }
  const std::size_t before = count_faces(Arm().draw({{{0, 0}, "", {}, {}}}));
  const std::string svg = arm.draw({{{0, 0}, "", {}, {}}});
  EXPECT_EQ(count_faces(svg), before - 7 + 1);  // from x and y the slope alone is seen
  EXPECT_NE(svg.find("<path color=\"#0000"), std::string::npos);
  for (Triangle& triangle : hand.triangles) {
    triangle = moved(triangle, Eigen::Affine3d(Eigen::Scaling(-1.0, -1.0, -1.0)));
  }
  EXPECT_EQ(count_faces(arm.draw({{{0, 0}, "", {}, {}}})),
            before - 7 + 3);  // its other sides
}

// Between the base and the arm stands a link without mass. Would catch: rods of axes that are no
// part of a robot, and a stick figure that loses them.
TEST(DrawRobot, LinksWithoutMassAreDrawnOnlyInStickFigures) {
  Arm arm;
  const std::size_t without = arm.solids(0, 0).balls.size();
  arm.robot.links[0].inertial = Inertial{};
  EXPECT_EQ(arm.solids(0, 0).balls.size(), without);
  arm.robot.links[0].inertial->mass = 1;
  EXPECT_EQ(arm.solids(0, 0).balls.size(), without + 2);  // its rod
  arm.robot.links[0].inertial.reset();
  arm.visuals.clear();
  EXPECT_TRUE(std::ranges::any_of(arm.solids(0, 0).balls,
                                  [](const Ball& ball) { return ball.center.isZero(1e-9); }));
}

// Would catch: a link that is not in the middle of its close-up, or no larger there.
TEST(DrawRobot, ACloseUpShowsALink) {
  const Arm arm;
  View view;
  const auto extent = [&] {
    return extent_of(std::regex_replace(
        draw_robot(arm.robot, arm.placer, arm.visuals, {{{0, 0}, "", {}, {}}}, view),
        std::regex("<path class=.ground[^>]*>"), ""));
  };
  const double before = extent().sizes().y();
  view.close_up = "hand";
  const Eigen::AlignedBox2d box = extent();
  EXPECT_GT(box.sizes().y(), 2 * before);
  // The hand's origin is in the middle of 240 px, which are 0.3 m and two margins of 10 px; its rod
  // of 0.25 m reaches beyond.
  EXPECT_NEAR(box.min().y(), 120 - 0.25 * 220 / 0.3 * std::cos(0.25), 3);
}

// Would catch: a film that is out of step, that skips the first or the last moment, or that moves
// where a reader has asked for rest.
TEST(DrawRobot, AFilmShowsItsMomentsInTurn) {
  const Arm arm;
  const std::vector<Moment> moments = {
      {{0, 0}, "a", {}, {}}, {{0, 0.3}, "b", {}, {}}, {{0, 0.6}, "c", {}, {}}};
  const std::string svg =
      animate_robot(arm.robot, arm.placer, arm.visuals, moments, {0.75, 0.25, 300, ""}, {10, 0.6});
  EXPECT_NE(svg.find("<title>arm: 0.8 s, 10 frames a second, over and over</title>"),
            std::string::npos);
  EXPECT_NE(svg.find("animation:film 0.8s steps(2) infinite"), std::string::npos);
  // A step each 0.1 s; the second step is the last moment, which stays from 0.2 to 0.8 s.
  EXPECT_NE(svg.find("@keyframes film{25.0000%,to{transform:translateX(-600px)}}"),
            std::string::npos);
  EXPECT_NE(svg.find("@media(prefers-reduced-motion:reduce){.film{animation:none}}"),
            std::string::npos);
  EXPECT_EQ(count(svg, "class=\"ground\""), 1U);
  const auto at = [&](const char* part) { return svg.find(part); };
  EXPECT_LT(at("<g class=\"film\">"), at("<svg x=\"0\""));
  EXPECT_LT(at("<svg x=\"0\""), at(">a</text>"));
  EXPECT_LT(at(">a</text>"), at("<svg x=\"300\""));
  EXPECT_LT(at("<svg x=\"600\""), at(">c</text>"));
  EXPECT_EQ(count(svg, "<svg x="), 3U);
}

}  // namespace
}  // namespace treeline
