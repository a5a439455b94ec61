// Would catch: a joint that leads another beyond its limits, limits that are narrower than the
// followers need, and files whose limits contradict each other without a word.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "description/urdf_parts.hpp"
#include "diagnosed.hpp"
#include "limited_arm.hpp"

namespace treeline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Robot read(const std::string& text, Diagnostics& diagnostics) {
  const auto robot = parse_urdf(text, "arm.urdf", diagnostics);
  EXPECT_TRUE(robot) << to_string(diagnostics);
  return robot.value();
}

Limits limits_of_leader(const std::string& text, Diagnostics& diagnostics) {
  return read(text, diagnostics).joints.front().limits.value();
}

TEST(FollowerLimits, AreThoseOfTheirLeader) {
  Diagnostics diagnostics;
  const Limits limits =
      limits_of_leader(led_arm("lower='-3' upper='3' effort='10' velocity='5'",
                               "lower='-0.5' upper='0.5' effort='1' velocity='1'", "-2", "0.1"),
                       diagnostics);
  EXPECT_DOUBLE_EQ(limits.lower, -0.2);
  EXPECT_DOUBLE_EQ(limits.upper, 0.3);
  EXPECT_DOUBLE_EQ(limits.velocity, 0.5);
  EXPECT_EQ(limits.effort.value(), 10) << "a follower has no motor";
  expect_diagnosed(
      diagnostics, "arm.urdf",
      {Severity::warning, 5, "robot/joint[follow]/limit",
       "permit the latter less than its own do: from -0.2 to 0.3, up to 0.5 a second", "agree"});
}

// Would catch messages that name the line of the joint in place of that of `<limit>` or `<mimic>`.
TEST(FollowerLimits, AreNamedByTheirLine) {
  const std::string sound = "lower='-3' upper='3' effort='10' velocity='5'";
  const auto lines_between = [](std::string text) {
    for (const char* element : {"<limit", "<mimic"}) {
      text.insert(text.rfind(element), "\n\n");
    }
    return text;
  };
  Diagnostics narrow, unknown;
  read(lines_between(led_arm(sound, "lower='-0.5' upper='0.5' effort='1' velocity='5'", "1", "0")),
       narrow);
  expect_diagnosed(narrow, "arm.urdf",
                   {Severity::warning, 7, "robot/joint[follow]/limit", "permit", "agree"});
  std::string stray = lines_between(led_arm(sound, sound, "1", "0"));
  stray.replace(stray.find("joint='lead'"), 12, "joint='none'");
  EXPECT_FALSE(parse_urdf(stray, "arm.urdf", unknown));
  expect_diagnosed(
      unknown, "arm.urdf",
      {Severity::error, 9, "robot/joint[follow]/mimic", "\"none\" is not defined", ""});
}

TEST(FollowerLimits, ThatAgreeOrAreWiderChangeNothing) {
  for (const char* of_follower :
       {"lower='-1' upper='1' effort='1' velocity='1'",
        "lower='-0.9999999' upper='0.9999999' effort='1' velocity='0.9999999'",
        "lower='-7' upper='7' effort='1' velocity='7'",
        "lower='0' upper='0' effort='0' velocity='0'",
        "lower='1' upper='-1' effort='1' velocity='1e8'"}) {
    Diagnostics diagnostics;
    const Limits limits = limits_of_leader(
        led_arm("lower='-0.5' upper='0.5' effort='1' velocity='0.5'", of_follower, "2", "0"),
        diagnostics);
    EXPECT_EQ(limits.lower.value(), -0.5) << of_follower;
    EXPECT_EQ(limits.upper.value(), 0.5) << of_follower;
    EXPECT_EQ(limits.velocity.value(), 0.5) << of_follower;
    EXPECT_TRUE(diagnostics.list().empty()) << to_string(diagnostics);
  }
}

TEST(FollowerLimits, LimitALeaderThatHasNone) {
  for (const char* of_leader : {"", "lower='0' upper='0' effort='0' velocity='0'",
                                "lower='-1e8' upper='1e8' effort='1' velocity='1e8'"}) {
    Diagnostics diagnostics;
    const Limits limits = limits_of_leader(
        led_arm(of_leader, "lower='-1' upper='3' effort='1' velocity='1'", "-1", "1"), diagnostics);
    EXPECT_EQ(limits.lower.value(), -2) << of_leader;
    EXPECT_EQ(limits.upper.value(), 2) << of_leader;
    EXPECT_EQ(limits.velocity.value(), 1) << of_leader;
  }
}

TEST(FollowerLimits, WithoutACommonPositionAreLeftOut) {
  for (const char* offset : {"9", "-9", "2"}) {  // the last has one position in common
    Diagnostics diagnostics;
    const Limits limits =
        limits_of_leader(led_arm("lower='-1' upper='1' effort='1' velocity='1'",
                                 "lower='-1' upper='1' effort='1' velocity='0.5'", "1", offset),
                         diagnostics);
    EXPECT_EQ(limits.lower.value(), -1);
    EXPECT_EQ(limits.upper.value(), 1);
    EXPECT_EQ(limits.velocity.value(), 0.5);
    expect_diagnosed(diagnostics, "arm.urdf",
                     {Severity::warning, 5, "robot/joint[follow]/limit",
                      "\"lead\" has no room from -1 to 1 that keeps", "agree"});
  }
}

TEST(FollowerLimits, DoNotMatterWithoutMotion) {
  Diagnostics diagnostics;
  const Limits limits =
      limits_of_leader(led_arm("lower='-1' upper='1' effort='1' velocity='1'",
                               "lower='-0.1' upper='0.1' effort='1' velocity='0.1'", "0", "0"),
                       diagnostics);
  EXPECT_EQ(limits.upper.value(), 1);
  EXPECT_EQ(limits.velocity.value(), 1);
}

std::string drawn_limits(std::mt19937& rng) {
  std::uniform_real_distribution<double> draw(0.1, 3);
  return "lower='" + std::to_string(-draw(rng)) + "' upper='" + std::to_string(draw(rng)) +
         "' effort='1' velocity='" + std::to_string(draw(rng)) + "'";
}

/// A joint that others follow, one of them a follower's follower.
std::string drawn_robot(std::mt19937& rng) {
  std::uniform_real_distribution<double> draw(-2, 2);
  std::string text = "<robot name='r'><link name='l0'/>";
  for (int i = 0; i < 4; ++i) {
    const std::string at = std::to_string(i), child = "l" + std::to_string(i + 1);
    const std::string leader = "j" + std::to_string(i == 3 ? 2 : 0);
    const std::string mimic = "<mimic joint='" + leader + "' multiplier='" +
                              std::to_string(draw(rng)) + "' offset='" +
                              std::to_string(draw(rng) / 50) + "'/>";
    text += limited_link(child) + limited_joint("j" + at, "revolute", "l" + at, child,
                                                drawn_limits(rng), i == 0 ? "" : mimic);
  }
  return text + "</robot>";
}

/// Whether all joints are within the limits that a file states, where the first is at `q` and moves
/// at `speed`.
bool all_within(const Robot& robot, const Limits& first, double q, double speed) {
  for (const Joint& joint : robot.joints) {
    const Limits& limits = joint.mimic ? joint.limits.value() : first;
    const Mimic mimic = joint.mimic.value_or(Mimic{});
    const double at = mimic.multiplier * q + mimic.offset;
    if (at < limits.lower || at > limits.upper) return false;
    if (std::abs(mimic.multiplier * speed) > limits.velocity) return false;
  }
  return true;
}

TEST(FollowerLimits, KeepEveryFollowerWithinItsOwnAndNoMore) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 rng(seed);
    const std::string text = drawn_robot(rng);
    Diagnostics diagnostics;
    const Robot robot = read(text, diagnostics);
    // As the file has them: of the first joint alone.
    const auto mimic_at = text.find("<link name='l2'");
    Diagnostics of_first;
    const Limits first =
        read(text.substr(0, mimic_at) + "</robot>", of_first).joints.front().limits.value();
    const Limits& folded = robot.joints.front().limits.value();
    for (int k = 0; k <= 400; ++k) {
      const double q = -3.1 + 6.2 * k / 400;
      if (std::abs(q - folded.lower) < 1e-4 || std::abs(q - folded.upper) < 1e-4) continue;
      EXPECT_EQ(all_within(robot, first, q, 0), q > folded.lower && q < folded.upper) << q;
    }
    const double middle = (folded.lower + folded.upper) / 2;
    EXPECT_TRUE(all_within(robot, first, middle, folded.velocity * (1 - 1e-5)));
    EXPECT_FALSE(all_within(robot, first, middle, folded.velocity * (1 + 1e-5)));
    EXPECT_LT(folded.velocity, kInfinity);
  }
}

}  // namespace
}  // namespace treeline
