// Would catch: an object that is read as something else, and faults in a scene's objects that are
// reported without their place or a remedy.
#include <gtest/gtest.h>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "diagnosed.hpp"

namespace treeline {
namespace {

const std::string kBody =
    "<inertial><mass value='1'/>"
    "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>";

/// Two arms with six hinges each on one base, and a stub with one.
Robot make_robot() {
  std::string text = "<robot name='pair'><link name='base'>" + kBody + "</link>";
  const auto add = [&](const std::string& parent, const std::string& child) {
    text += "<link name='" + child + "'>" + kBody + "</link><joint name='to_" + child +
            "' type='continuous'><parent link='" + parent + "'/><child link='" + child +
            "'/></joint>";
  };
  for (const std::string side : {"left", "right"}) {
    for (int i = 1; i <= 6; ++i) {
      add(i == 1 ? "base" : side + std::to_string(i - 1), side + std::to_string(i));
    }
  }
  add("base", "stub");
  Diagnostics diagnostics;
  const auto robot = parse_urdf(text + "</robot>", "r.urdf", diagnostics);
  EXPECT_TRUE(robot) << to_string(diagnostics);
  return robot.value_or(Robot{});
}

const std::string kPoints =
    "operational_points: [{name: left, link: left6}, {name: right, link: right6}, "
    "{name: stub, link: stub, rows: [x]}]\n";

const std::string kBox =
    "objects:\n"
    "  - name: box\n"
    "    mass: 2\n"
    "    center: [0.1, 0, 0]\n"
    "    inertia: {ixx: 1, iyy: 2, izz: 2.5, ixy: 0.1, ixz: 0.2, iyz: 0.3}\n"
    "    grasps:\n"
    "      - {point: left, origin: {xyz: [0, -0.1, 0]}}\n"
    "      - {point: right, origin: {xyz: [0, 0.1, 0], rpy: [0, 0, 0.5]}}\n";

std::optional<Scene> read(const std::string& text, Diagnostics& diagnostics) {
  static const Robot robot = make_robot();
  return parse_scene(text, "s.yaml", robot, diagnostics);
}

TEST(ReadObjects, ReadsEverySetting) {
  Diagnostics diagnostics;
  const auto scene = read(kPoints + kBox, diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  ASSERT_EQ(scene->objects.size(), 1U);
  const SceneObject& box = scene->objects[0];
  EXPECT_EQ(box.name, "box");
  EXPECT_EQ(box.inertial.mass, 2);
  EXPECT_EQ(box.inertial.origin.xyz, (std::array{0.1, 0.0, 0.0}));
  EXPECT_EQ(box.inertial.ixx, 1);
  EXPECT_EQ(box.inertial.iyy, 2);
  EXPECT_EQ(box.inertial.izz, 2.5);
  EXPECT_EQ(box.inertial.ixy, 0.1);
  EXPECT_EQ(box.inertial.ixz, 0.2);
  EXPECT_EQ(box.inertial.iyz, 0.3);
  ASSERT_EQ(box.grasps.size(), 2U);
  EXPECT_EQ(box.grasps[0].point, "left");
  EXPECT_EQ(box.grasps[0].origin.xyz, (std::array{0.0, -0.1, 0.0}));
  EXPECT_EQ(box.grasps[1].origin.rpy, (std::array{0.0, 0.0, 0.5}));
}

// Functions about objects are part of the scene's default only if there are objects.
TEST(ReadObjects, BringTheirFunctions) {
  Diagnostics diagnostics;
  const auto held = read(kPoints + kBox, diagnostics);
  const auto bare = read(kPoints, diagnostics);
  ASSERT_TRUE(held && bare) << to_string(diagnostics);
  for (const Function function : kObjectFunctions) {
    const auto lists = [&](const Scene& scene) {
      return std::count(scene.functions.begin(), scene.functions.end(), function) == 1;
    };
    EXPECT_TRUE(lists(*held)) << function_name(function);
    EXPECT_FALSE(lists(*bare)) << function_name(function);
  }
}

/// A tray that is held at these places of it.
std::string tray(const std::vector<const char*>& places) {
  std::string text =
      "operational_points: [{name: p0, link: left6}, {name: p1, link: right6}, "
      "{name: p2, link: left5}, {name: p3, link: right5}]\n"
      "objects:\n"
      "  - name: tray\n"
      "    mass: 2\n"
      "    inertia: {ixx: 1, iyy: 2, izz: 2.5}\n"
      "    grasps:\n";
  for (std::size_t i = 0; i < places.size(); ++i) {
    text += "      - {point: p" + std::to_string(i) + ", origin: {xyz: " + places[i] + "}}\n";
  }
  return text;
}

TEST(ReadObjects, MayBeHeldByFourHandsInAPlane) {
  Diagnostics diagnostics;
  const auto scene = read(
      tray({"[0.3, 0.2, 0]", "[-0.3, 0.2, 0]", "[-0.3, -0.2, 0]", "[0.3, -0.2, 0]"}), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_EQ(scene->objects.front().grasps.size(), 4U);
}

struct Fault {
  const char* name;
  std::string scene;
  Expected expected;
};

std::ostream& operator<<(std::ostream& out, const Fault& fault) {
  return out << fault.name;
}

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = kPoints + kBox;
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::vector<Fault> faults() {
  const auto error = [](int line, const char* element, const char* fault, const char* remedy) {
    return Expected{Severity::error, line, element, fault, remedy};
  };
  return {
      {"unknown_point", replaced("point: right", "point: wright"),
       error(9, "objects[0]/grasps[1]/point", "no operational point \"wright\"", "right")},
      {"point_twice", replaced("point: right", "point: left"),
       error(9, "objects[0]/grasps[1]", "\"left\" holds an object already", "once")},
      {"no_mass", replaced("    mass: 2\n", ""),
       error(3, "objects[0]", "\"mass\" is missing", "kg")},
      {"negative_mass", replaced("mass: 2", "mass: -2"),
       error(4, "objects[0]/mass", "not positive", "kg")},
      {"no_moment", replaced("iyy: 2, ", ""),
       error(6, "objects[0]/inertia", "\"iyy\" is missing", "products")},
      {"no_body_has_it", replaced("izz: 2.5", "izz: 25"),
       error(6, "objects[0]/inertia", "no body has this inertia", "units")},
      {"no_inertia_about_an_axis",
       replaced("ixx: 1, iyy: 2, izz: 2.5, ixy: 0.1, ixz: 0.2, iyz: 0.3", "ixx: 0, iyy: 1, izz: 1"),
       error(6, "objects[0]/inertia", "no inertia about some axis", "every axis")},
      {"unknown_key", replaced("center:", "centre:"),
       error(5, "objects[0]/centre", "unknown", "center")},
      {"one_place", replaced("xyz: [0, 0.1, 0], rpy: [0, 0, 0.5]", "xyz: [0, -0.1, 0]"),
       error(1, "", "at the same place", "origins")},
      {"on_a_line", tray({"[0.3, 0.2, 0]", "[0, 0.2, 0]", "[-0.3, 0.2, 0]"}),
       error(1, "", "the first three grasps of object \"tray\" are on a line", "a triangle")},
      {"too_few_coordinates", replaced("point: right", "point: stub") + "singular: exact\n",
       error(1, "", "needs six coordinates at point \"stub\", which has 1", "every direction")},
      {"function_without_object", kPoints + "functions: [object_state]",
       error(2, "functions", "object_state is listed, but there is no object", "objects")}};
}

class BadObjects : public testing::TestWithParam<Fault> {};

INSTANTIATE_TEST_SUITE_P(Faults, BadObjects, testing::ValuesIn(faults()),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST_P(BadObjects, AreDiagnosed) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read(GetParam().scene, diagnostics));
  expect_diagnosed(diagnostics, "s.yaml", GetParam().expected);
}

}  // namespace
}  // namespace treeline
