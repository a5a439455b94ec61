// Would catch: a number taken as exact although its author meant it as written, a number changed
// without a message, noise that is left, and a request to keep every number that has no effect.
#include "description/noise.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "description/rotation.hpp"

namespace treeline {
namespace {

const double kPi = std::acos(-1.0);

constexpr const char* kUrdf = R"(<robot name="arm">
  <link name="base"/>
  <joint name="first" type="continuous">
    <origin xyz="0.3 -3.1e-17 4e-13" rpy="1.1476e-27 1.5707963267948968 3.1415926535897860"/>
    <axis xyz="0 -2e-17 1"/><parent link="base"/><child link="upper"/></joint>
  <link name="upper"><inertial><origin xyz="0 0 1e-18" rpy="-6.52e-42 0 1.57"/><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
</robot>)";

Robot arm() {
  Diagnostics diagnostics;
  return parse_urdf(kUrdf, "arm.urdf", diagnostics).value();
}

std::optional<Scene> scene_of(const std::string& text, Diagnostics& diagnostics) {
  return parse_scene(text, "scene.yaml", arm(), diagnostics);
}

TEST(Noise, IsWhatDoubleCannotResolve) {
  NoiseDecisions decisions;
  const Robot robot = without_noise(arm(), noise_limits(arm(), Scene{}), &decisions);
  EXPECT_EQ(robot.joints[0].origin.rpy, (std::array{0.0, kPi / 2, 3.1415926535897860}));
  EXPECT_EQ(robot.joints[0].origin.xyz, (std::array{0.3, 0.0, 4e-13}));
  EXPECT_EQ(robot.joints[0].axis, (std::array{0.0, 0.0, 1.0}));
  EXPECT_EQ(robot.links[1].inertial->origin.rpy, (std::array{0.0, 0.0, 1.57}));
  EXPECT_EQ(robot.links[1].inertial->origin.xyz, (std::array{0.0, 0.0, 0.0}));
  ASSERT_EQ(decisions.size(), 6U);
  for (const NoiseDecision& decision : decisions) EXPECT_EQ(decision.file, "arm.urdf");
  EXPECT_EQ(decisions[0].element, "robot/link[upper]/inertial/origin");
  EXPECT_EQ(decisions[0].text, "roll -6.52e-42 rad is 0");
  EXPECT_EQ(decisions[0].change, 6.52e-42);
  EXPECT_EQ(decisions[2].text, "roll 1.1476e-27 rad is 0");
  EXPECT_EQ(decisions[2].line, 4);
  EXPECT_EQ(decisions[3].text, "pitch 1.5707963267948968 rad is pi/2");
  EXPECT_EQ(decisions[5].text, "axis y -2e-17 is 0");
  EXPECT_EQ(decisions[5].line, 5);
}

// Would catch: a moment of a light tip that is off by more than its own rounding, because its
// centre of mass is judged beside the whole robot.
TEST(Noise, OfACentreIsJudgedBesideItsDistance) {
  Robot robot = arm();
  const auto center_of = [&](std::array<double, 3> xyz) {
    robot.links[1].inertial->origin.xyz = xyz;
    return without_noise(robot, noise_limits(robot, Scene{})).links[1].inertial->origin.xyz;
  };
  EXPECT_EQ(center_of({0, -8.8e-5, -1.7e-18}), (std::array{0.0, -8.8e-5, -1.7e-18}));
  EXPECT_EQ(center_of({0, -8.8e-5, -1.7e-20}), (std::array{0.0, -8.8e-5, 0.0}));
  EXPECT_EQ(center_of({0, -0.1, -1.7e-18}), (std::array{0.0, -0.1, 0.0}));
  EXPECT_EQ(center_of({3e-17, -3e-17, 1e-18}), (std::array{0.0, 0.0, 0.0}));
}

// Legs that are equal up to rounding get the same code.
TEST(Noise, IsWhatEqualNumbersDifferBy) {
  Robot robot = arm();
  robot.joints[0].origin = {{0.3, -0.30000000000000004, 0.3000000000000003}, {0.7, -0.7, 0.7}};
  robot.joints[0].origin.rpy[1] = std::nextafter(-0.7, -1);
  NoiseDecisions decisions;
  const Robot made = without_noise(robot, noise_limits(robot, Scene{}), &decisions);
  EXPECT_EQ(made.joints[0].origin.xyz, (std::array{0.3, -0.3, 0.3000000000000003}));
  EXPECT_EQ(made.joints[0].origin.rpy, (std::array{0.7, -0.7, 0.7}));
  EXPECT_EQ(decisions[3].text, "y -0.30000000000000004 m is -0.3, as elsewhere");
}

TEST(Noise, IsKeptOnRequest) {
  Diagnostics diagnostics;
  const auto scene = scene_of("noise: keep\n", diagnostics);
  ASSERT_TRUE(scene);
  NoiseDecisions decisions;
  const Robot robot = without_noise(arm(), noise_limits(arm(), *scene), &decisions);
  EXPECT_EQ(robot.joints[0].origin.rpy, arm().joints[0].origin.rpy);
  EXPECT_EQ(robot.joints[0].origin.xyz, arm().joints[0].origin.xyz);
  EXPECT_EQ(robot.joints[0].axis, arm().joints[0].axis);
  EXPECT_TRUE(decisions.empty());
}

// A wider limit is the author's statement about the file, and holds for everything that reads it.
TEST(Noise, HasAWiderLimitOnRequest) {
  Diagnostics diagnostics;
  const auto scene = scene_of(
      "noise: 2e-12\n"
      "operational_points: [{name: tip, link: upper, origin: {rpy: [0, 1e-13, 0]}, rows: [x]}]\n",
      diagnostics);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->operational_points[0].origin.rpy[1], 0);
  ASSERT_EQ(scene->taken_exact.size(), 1U);
  EXPECT_EQ(scene->taken_exact[0].file, "scene.yaml");
  const Robot robot = as_asked(arm(), *scene);
  EXPECT_EQ(robot.joints[0].origin.rpy, (std::array{0.0, kPi / 2, kPi}));
  EXPECT_EQ(robot.joints[0].origin.xyz, (std::array{0.3, 0.0, 0.0}));
  EXPECT_EQ(robot.links[1].inertial->origin.rpy[2], 1.57);
}

// The narrow limit is the generator's own; the reference uses the file as written.
TEST(Noise, IsInWhatResultsAreCheckedAgainst) {
  const Robot robot = as_asked(arm(), Scene{});
  EXPECT_EQ(robot.joints[0].origin.rpy, arm().joints[0].origin.rpy);
  EXPECT_EQ(robot.joints[0].axis, arm().joints[0].axis);
}

TEST(Noise, LimitsThatAreNoneAreRefused) {
  for (const char* text : {"noise: 1e-3\n", "noise: 0\n", "noise: -1e-16\n", "noise: drop\n"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(scene_of(text, diagnostics)) << text;
    EXPECT_TRUE(diagnostics.has_errors());
  }
}

TEST(Noise, IsNotedOnceAFile) {
  NoiseDecisions decisions;
  without_noise(arm(), noise_limits(arm(), Scene{}), &decisions);
  decisions.push_back({"scene.yaml", 0, "operational_points[tip]/origin", "yaw 1e-20 is 0", 1e-20});
  Diagnostics diagnostics;
  note_noise(decisions, Scene{}, diagnostics);
  ASSERT_EQ(diagnostics.list().size(), 2U);
  EXPECT_EQ(diagnostics.list()[0].severity, Severity::note);
  EXPECT_EQ(diagnostics.list()[0].file, "arm.urdf");
  EXPECT_EQ(diagnostics.list()[0].fault.substr(0, 10), "6 numbers ");
  EXPECT_NE(diagnostics.list()[0].remedy.find("noise: keep"), std::string::npos);
  EXPECT_EQ(diagnostics.list()[1].file, "scene.yaml");
  EXPECT_EQ(diagnostics.list()[1].fault.substr(0, 9), "a number ");
}

TEST(QuarterTurns, AreExactWhereTheDoubleIsNearest) {
  for (int turns = -9; turns <= 9; ++turns) {
    const auto angle = static_cast<double>(turns * std::acos(-1.0L) / 2);
    const auto [sine, cosine] = sin_cos_of_file_angle<double>(angle);
    EXPECT_EQ(std::abs(sine), std::abs(turns) % 2) << turns;
    EXPECT_EQ(std::abs(cosine), 1 - std::abs(turns) % 2) << turns;
    if (turns == 0) continue;
    const double beside = std::nextafter(angle, 100);
    EXPECT_EQ(sin_cos_of_file_angle<double>(beside).sin, std::sin(beside)) << turns;
  }
}

}  // namespace
}  // namespace treeline
