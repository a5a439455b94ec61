// Would catch: an obstacle that is read as another, and a slip in a scene that goes unnoticed.
#include "description/read_surroundings.hpp"

#include <gtest/gtest.h>

#include "description/read_scene.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

const std::string kBall = "obstacles: [{name: ball, sphere: {radius: 0.2}}]\n";

TEST(ReadSurroundings, ReadsObstaclesAndPoints) {
  const std::string text =
      "obstacles:\n"
      "  - {name: ball, sphere: {radius: 0.2}, origin: {xyz: [1, 2, 3]}}\n"
      "  - {name: table, box: {size: [0.4, 0.6, 0.1]}, origin: {rpy: [0, 0, 0.5]}, avoid: false}\n"
      "avoidance: {reach: 0.3, clearance: 0, strength: 0.01, points: [{link: fore},\n"
      "  {link: tool, xyz: [0, 0, 0.1]}]}\n";
  Diagnostics diagnostics;
  ASSERT_TRUE(parse_scene(text, "s.yaml", make_robot(), diagnostics)) << to_string(diagnostics);
  const SceneSurroundings read = surroundings_of(text, make_robot());
  ASSERT_EQ(read.obstacles.size(), 2U);
  EXPECT_EQ(read.obstacles[0].name, "ball");
  EXPECT_EQ(read.obstacles[0].radius, 0.2);
  EXPECT_EQ(read.obstacles[0].origin.xyz, (std::array<double, 3>{1, 2, 3}));
  EXPECT_TRUE(read.obstacles[0].avoided);
  EXPECT_EQ(read.obstacles[1].size, (std::array<double, 3>{0.4, 0.6, 0.1}));
  EXPECT_EQ(read.obstacles[1].origin.rpy[2], 0.5);
  EXPECT_FALSE(read.obstacles[1].avoided);
  EXPECT_EQ(read.avoidance.reach, 0.3);
  EXPECT_EQ(read.avoidance.clearance, 0.0);
  EXPECT_EQ(read.avoidance.strength, 0.01);
  ASSERT_EQ(read.avoidance.points.size(), 2U);
  EXPECT_EQ(read.avoidance.points[1].link, "tool");
  EXPECT_EQ(read.avoidance.points[1].xyz[2], 0.1);
}

const std::string kObject =
    "operational_points: [{name: hand, link: tool}]\n"
    "objects: [{name: box, mass: 1, inertia: {ixx: 1, iyy: 1, izz: 1}, grasps: [{point: hand}],\n";

TEST(ReadSurroundings, ReadsShapesOfObjects) {
  const std::string text = kObject +
                           "  shapes: [{box: {size: [1, 2, 3]}, origin: {xyz: [0, 0, 0.5]}},\n"
                           "    {sphere: {radius: 0.1}}]}]\n";
  Diagnostics diagnostics;
  ASSERT_TRUE(parse_scene(text, "s.yaml", make_robot(), diagnostics)) << to_string(diagnostics);
  const SceneSurroundings read = surroundings_of(text, make_robot());
  ASSERT_EQ(read.shapes.size(), 1U);
  ASSERT_EQ(read.shapes[0].size(), 2U);
  EXPECT_EQ(read.shapes[0][0].size, (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(read.shapes[0][0].origin.xyz[2], 0.5);
  EXPECT_EQ(read.shapes[0][1].radius, 0.1);
  const auto without = surroundings_of(kObject + "}]\n", make_robot()).shapes;
  ASSERT_EQ(without.size(), 1U);
  EXPECT_TRUE(without[0].empty());
}

TEST(ReadSurroundings, IsEmptyWithoutAScene) {
  EXPECT_TRUE(surroundings_of("", make_robot()).obstacles.empty());
  EXPECT_TRUE(surroundings_of("name: arm\n", make_robot()).obstacles.empty());
}

TEST(ReadSurroundings, RefusesWhatItDoesNotUnderstand) {
  struct Refused {
    std::string text;
    Expected expected;
  };
  constexpr auto kError = Severity::error;
  const std::vector<Refused> refused = {
      {"obstacles: [{name: a}]", {kError, 1, "obstacles[0]", "one sphere or one box", "radius"}},
      {"obstacles: [{name: a, sphere: {radius: 1}, box: {size: [1, 1, 1]}}]",
       {kError, 1, "obstacles[0]", "one sphere or one box", "size"}},
      {"obstacles: [{name: a, sphere: {}}]",
       {kError, 1, "obstacles[0]/sphere", "\"radius\" is missing", "radius"}},
      {"obstacles: [{name: a, sphere: {radius: -1}}]",
       {kError, 1, "obstacles[0]/sphere/radius", "-1 is not positive", "metres"}},
      {"obstacles: [{name: a, box: {size: [1, 0, 1]}}]",
       {kError, 1, "obstacles[0]/box/size", "not positive", "edges"}},
      {"obstacles: [{name: a, sphere: {radius: 1}, avoids: no}]",
       {kError, 1, "obstacles[0]/avoids", "avoids", "avoid"}},
      {"obstacles: [{name: a, sphere: {radius: 1}, avoid: perhaps}]",
       {kError, 1, "obstacles[0]/avoid", "perhaps", "true"}},
      {"obstacles: [{name: a, sphere: {radius: 1}}, {name: a, sphere: {radius: 2}}]",
       {kError, 1, "obstacles[1]", "already taken", "own"}},
      {"avoidance: {reach: 0.1}", {kError, 1, "avoidance", "no obstacles", "list"}},
      {kBall + "avoidance: {reach: 0}", {kError, 2, "avoidance/reach", "0 is not", "metres"}},
      {kBall + "avoidance: {clearance: -0.1}",
       {kError, 2, "avoidance/clearance", "negative", "free"}},
      {kBall + "avoidance: {points: [{link: tol}]}",
       {kError, 2, "avoidance/points[0]/link", "no link \"tol\"", "tool"}},
      {kBall + "avoidance: {points: [{xyz: [0, 0, 0]}]}",
       {kError, 2, "avoidance/points[0]", "\"link\" is missing", "link"}},
      {kObject + "  shapes: [{origin: {xyz: [0, 0, 1]}}]}]",
       {kError, 3, "objects[0]/shapes[0]", "a shape is one sphere or one box", "radius"}},
      {kObject + "  shapes: [{sphere: {radius: 0}}]}]",
       {kError, 3, "objects[0]/shapes[0]/sphere/radius", "0 is not positive", "metres"}},
      {kObject + "  shapes: [{sphere: {radius: 1}, color: red}]}]",
       {kError, 3, "objects[0]/shapes[0]/color", "color", "origin"}},
      {kBall + "avoidance: {points: [{link: tool}, {link: tool}]}",
       {kError, 2, "avoidance/points[1]", "twice", "once"}},
  };
  for (const Refused& each : refused) {
    SCOPED_TRACE(each.text);
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_scene(each.text, "s.yaml", make_robot(), diagnostics));
    expect_diagnosed(diagnostics, "s.yaml", each.expected);
  }
}

TEST(ReadSurroundings, ReadsTheGround) {
  const std::string text = "ground: {friction: 0.3, restitution: 1}\n";
  Diagnostics diagnostics;
  ASSERT_TRUE(parse_scene(text, "s.yaml", make_robot(), diagnostics)) << to_string(diagnostics);
  const auto ground = surroundings_of(text, make_robot()).ground;
  ASSERT_TRUE(ground);
  EXPECT_EQ(ground->friction, 0.3);
  EXPECT_EQ(ground->restitution, 1.0);
  EXPECT_TRUE(surroundings_of("ground: {}\n", make_robot()).ground);
  EXPECT_FALSE(parse_scene(text, "s.yaml", make_robot(), diagnostics)->ground_step);
  const auto stepped = parse_scene("functions: []\nground: {friction: 0.3, step: true}\n", "s.yaml",
                                   make_robot(), diagnostics);
  ASSERT_TRUE(stepped && stepped->ground_step) << to_string(diagnostics);
  EXPECT_EQ(stepped->ground_step->friction, 0.3);
  EXPECT_FALSE(surroundings_of("", make_robot()).ground);
}

TEST(ReadSurroundings, RefusesGroundThatIsNone) {
  for (const char* text :
       {"ground: {friction: -0.1}\n", "ground: {restitution: 1.1}\n", "ground: {restitution: -1}\n",
        "ground: {slip: 1}\n", "ground: {step: 2}\n", "ground: true\n"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_scene(text, "s.yaml", make_robot(), diagnostics)) << text;
  }
}

}  // namespace
}  // namespace treeline
