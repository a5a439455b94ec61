// Would catch: a centre of mass that is read as a frame on a link, or with more than its rows;
// what it cannot be combined with that passes, or is refused without a name.
#include <gtest/gtest.h>

#include "description/check_scene.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

constexpr auto kError = Severity::error;

/// A scene with the centre of mass as the point "com", and more.
std::string with_center(const std::string& more) {
  return "operational_points: [{name: com, center_of_mass: true}, {name: hand, link: tool}]\n" +
         more;
}

TEST(ReadCenterOfMass, ReadsRowsAndPriority) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(
      "operational_points:\n"
      "  - {name: com, center_of_mass: true, rows: [x, z], axes: world, priority: 2}\n"
      "  - {name: hand, link: tool, center_of_mass: false, rows: [x]}\n",
      "scene.yaml", make_robot(), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  const ScenePoint& center = scene->operational_points[0];
  EXPECT_TRUE(center.center_of_mass);
  EXPECT_EQ(center.rows, (std::array<bool, 6>{true, false, true}));
  EXPECT_EQ(center.priority, 2);
  EXPECT_FALSE(scene->operational_points[1].center_of_mass);
}

TEST(ReadCenterOfMass, HasRowsOfTranslationUnlessToldOtherwise) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(with_center(""), "scene.yaml", make_robot(), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_EQ(scene->operational_points[0].rows, (std::array<bool, 6>{true, true, true}));
}

TEST(ReadCenterOfMass, RefusesWhatOnlyFramesHave) {
  const std::string point = "operational_points: [{name: com, center_of_mass: true, ";
  expect_told({
      {point + "link: tool}]",
       {kError, 1, "operational_points[0]/link", "the centre of mass has no link",
        "leave out this key"}},
      {point + "origin: {xyz: [0, 0, 1]}}]",
       {kError, 1, "operational_points[0]/origin", "the centre of mass has no origin",
        "leave out this key"}},
      {point + "axes: local}]",
       {kError, 1, "operational_points[0]/axes", "no axes of its own", "leave out this key"}},
      {point + "rows: [x, rz]}]",
       {kError, 1, "operational_points[0]/rows", "does not turn", "x y z"}},
      {"operational_points: [{name: a, center_of_mass: true},\n"
       "  {name: b, center_of_mass: true}]",
       {kError, 2, "operational_points[1]", "listed twice", "at one point"}},
      {"external_forces: [{name: com, center_of_mass: true}]",
       {kError, 1, "external_forces[0]/center_of_mass", "unknown", ""}},
  });
}

TEST(ReadCenterOfMass, RefusesByNameWhatItCannotBeCombinedWith) {
  const std::string object =
      "objects: [{name: box, mass: 1, inertia: {ixx: 1, iyy: 1, izz: 1}, grasps: [{point: com}]}]";
  const auto refused = [](const std::string& more, const char* what, const char* remedy) {
    return ToldScene{with_center(more), {kError, 1, "", what, remedy}};
  };
  expect_told({
      refused("inputs: [base_parameters]", "point \"com\" is the centre of mass, but base",
              "parameters of links"),
      refused("inputs: {tool: com}", "its origin is no argument", "from tool"),
      refused(object, "it holds the object \"box\"", "a point on a link"),
      refused("functions: [point_velocity_derivatives]", "point_velocity_derivatives is listed",
              "remove the function"),
      refused("functions: [point_acceleration_derivatives]",
              "point_acceleration_derivatives is listed", "remove the function"),
      refused("locked: {slide: 0.5}\ncontroller: {laws: [task_impedance, force]}",
              "the controller pushes with points on links", "law of forces"),
      refused("locked: {slide: 0.5}\ninputs: {payload: tool}\ncontroller: {laws: task_impedance}",
              "the controller measures points without inertial parameters", "from inputs"),
  });
}

TEST(ReadCenterOfMass, IsOfARobotWithMass) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(with_center("functions: [jacobian]"), "bad.yaml",
                                 make_robot("light", ""), diagnostics);
  EXPECT_FALSE(scene);
  expect_diagnosed(diagnostics, "bad.yaml",
                   {kError, 1, "", "but no link has mass", "give some link mass"});
}

// All that moves can move it; more rows than coordinates yield or are refused.
TEST(ReadCenterOfMass, CountsAllCoordinates) {
  expect_told({
      {"operational_points: [{name: com, center_of_mass: true}]\nsingular: exact\n"
       "locked: {slide: 0.5}",
       {kError, 1, "", "point \"com\" has 3 rows, but the centre of mass moves with 2 coordinates",
        "control fewer rows"}},
  });
}

}  // namespace
}  // namespace treeline
