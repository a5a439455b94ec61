// Would catch: a joint that closes a loop and holds other rows than its type says, or about another
// axis than the file's.
#include <gtest/gtest.h>

#include <cstdio>
#include <ostream>
#include <string>

#include "description/read_urdf.hpp"
#include "description/rotation.hpp"
#include "description/urdf_parts.hpp"
#include "diagnosed.hpp"

namespace treeline {
namespace {

constexpr const char* kTurned = "0.3 -0.4 1.2";
constexpr std::array<double, 3> kTurnedAngles{0.3, -0.4, 1.2};

/// The loop of a robot of two links, the second end turned.
RobotLoop loop_of(const std::string& type, const std::string& axis) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='fixed'>"
      "<parent link='a'/><child link='b'/></joint><loop_joint name='l' type='" +
          type + "'>" + (axis.empty() ? "" : "<axis xyz='" + axis + "'/>") +
          "<link1 link='a' xyz='1 2 3'/><link2 link='b' rpy='" + kTurned +
          "'/></loop_joint></robot>",
      "r.urdf", diagnostics);
  EXPECT_TRUE(diagnostics.list().empty()) << to_string(diagnostics);
  if (!robot || robot->loops.size() != 1) {
    ADD_FAILURE() << "the robot has no loop";
    return {};
  }
  return robot->loops[0];
}

struct LoopCase {
  const char* type;
  const char* axis;
  const char* held;  ///< of x y z rx ry rz
};

void PrintTo(const LoopCase& tested, std::ostream* out) {
  *out << tested.type << " " << tested.axis;
}

class LoopsAlongCoordinates : public testing::TestWithParam<LoopCase> {};

TEST_P(LoopsAlongCoordinates, HoldRowsInTheFramesOfTheFile) {
  const RobotLoop loop = loop_of(GetParam().type, GetParam().axis);
  std::string held;
  for (const bool row : loop.rows) held += row ? '1' : '0';
  EXPECT_EQ(held, GetParam().held);
  EXPECT_EQ(loop.first.origin.xyz, (std::array{1.0, 2.0, 3.0}));
  EXPECT_EQ(loop.first.origin.rpy, (std::array{0.0, 0.0, 0.0}));
  EXPECT_EQ(loop.second.origin.rpy, kTurnedAngles);
}

INSTANTIATE_TEST_SUITE_P(Kinds, LoopsAlongCoordinates,
                         testing::Values(LoopCase{"spherical", "", "111000"},
                                         LoopCase{"fixed", "", "111111"},
                                         LoopCase{"revolute", "", "111011"},
                                         LoopCase{"continuous", "0 0 1", "111110"},
                                         LoopCase{"continuous", "0 -1 0", "111101"},
                                         LoopCase{"prismatic", "1 0 0", "011111"},
                                         LoopCase{"prismatic", "0 0 1", "110111"}));

// The axis seen from each link is where the turned frame's z points: within a few roundings of the
// products of nine sines and cosines.
TEST(LoopsAlongOtherAxes, TurnBothFrames) {
  for (const char* axis : {"0.6 0 0.8", "-0.6 0.8 0", "0.48 -0.6 -0.64", "1e-9 0 -1"}) {
    const RobotLoop loop = loop_of("revolute", axis);
    EXPECT_EQ(loop.rows, (std::array{true, true, true, true, true, false}));
    std::array<double, 3> a{};
    ASSERT_EQ(std::sscanf(axis, "%lf %lf %lf", &a[0], &a[1], &a[2]), 3);
    const Eigen::Vector3d unit = Eigen::Vector3d(a[0], a[1], a[2]).normalized();
    const Eigen::Matrix3d turned = rotation_from_rpy<double>(kTurnedAngles);
    EXPECT_LT((rotation_from_rpy<double>(loop.first.origin.rpy).col(2) - unit).norm(), 1e-15);
    EXPECT_LT((rotation_from_rpy<double>(loop.second.origin.rpy).col(2) - turned * unit).norm(),
              1e-15);
  }
}

const std::string kTwoFingers =
    "<link name='a'/><link name='b'/><joint name='j' type='continuous'><parent link='a'/>"
    "<child link='b'/></joint>\n";

// The axis of each side is where z of its turned frame points.
TEST(LoopHints, AreReadFromConstraints) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='r'>" + kTwoFingers +
          "<constraint name='c' type='revolute'><parent link='a'/><parent_origin xyz='1 2 3'/>"
          "<parent_axis xyz='1 0 0'/><child link='b'/><child_origin rpy='" +
          kTurned + "'/><child_axis xyz='0 1 0'/></constraint></robot>",
      "r.urdf", diagnostics);
  ASSERT_TRUE(robot && robot->hints.loops.size() == 1) << to_string(diagnostics);
  const RobotLoop& loop = robot->hints.loops[0].loop;
  EXPECT_TRUE(robot->loops.empty());
  EXPECT_EQ(loop.first.origin.xyz, (std::array{1.0, 2.0, 3.0}));
  EXPECT_EQ(loop.rows, (std::array{true, true, true, true, true, false}));
  const Eigen::Matrix3d turned = rotation_from_rpy<double>(kTurnedAngles);
  EXPECT_LT(
      (rotation_from_rpy<double>(loop.first.origin.rpy).col(2) - Eigen::Vector3d::UnitX()).norm(),
      1e-15);
  EXPECT_LT((rotation_from_rpy<double>(loop.second.origin.rpy).col(2) - turned.col(1)).norm(),
            1e-15);
  expect_diagnosed(diagnostics, "r.urdf",
                   {Severity::note, 2, "robot/constraint[c]", "stays open", "init-scene"});
}

TEST(LoopHints, AreFoundInPairsOfClosingFrames) {
  Diagnostics diagnostics;
  std::string frames;
  for (const auto& [name, parent] :
       {std::pair{"closing_bar_1", "a"}, {"closing_bar_2", "b"}, {"closing_odd_1", "b"}}) {
    frames += std::string("<link name='") + name + "'/><joint name='" + name +
              "_at' type='fixed'><parent link='" + parent + "'/><child link='" + name +
              "'/></joint>";
  }
  const auto robot =
      parse_urdf("<robot name='r'>" + kTwoFingers + frames + "</robot>", "r.urdf", diagnostics);
  ASSERT_TRUE(robot && robot->hints.loops.size() == 1) << to_string(diagnostics);
  const RobotLoop& loop = robot->hints.loops[0].loop;
  EXPECT_EQ(loop.first.link, "closing_bar_1");
  EXPECT_EQ(loop.second.link, "closing_bar_2");
  EXPECT_EQ(loop.rows, (std::array{true, true, true, false, false, false}));
}

}  // namespace
}  // namespace treeline
