// Would catch: a placeholder among limits that nobody is told of, or told of twice; a reader of it
// in this scene that is not named, or one that is named and is not there; a joint whose limit
// nothing reads among them; and speeds for which rounding bounds would be absurd.
#include "inspect/warn_of_limits.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "description/diagnosed.hpp"
#include "description/limited_arm.hpp"
#include "description/read_scene.hpp"

namespace treeline {
namespace {

/// An arm of two joints, `a` and `b`, with these limits.
Robot make_arm(const std::string& of_a, const std::string& of_b,
               const std::string& more_of_b = "") {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='arm'><link name='base'/>\n" + limited_link("first") + limited_link("second") +
          limited_joint("a", "revolute", "base", "first", of_a) +
          limited_joint("b", "revolute", "first", "second", of_b, more_of_b) + "</robot>",
      "arm.urdf", diagnostics);
  EXPECT_TRUE(robot) << to_string(diagnostics);
  return robot.value();
}

std::string told(const Robot& robot, const std::string& scene_text = "",
                 LimitUse use = LimitUse::code) {
  Diagnostics of_scene, diagnostics;
  const auto scene = parse_scene(scene_text, "s.yaml", robot, of_scene);
  EXPECT_TRUE(scene) << to_string(of_scene);
  warn_of_limits(robot, scene.value(), use, diagnostics);
  return to_string(diagnostics);
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
  return found;
}

const std::string kSound = "lower='-1' upper='1' effort='3' velocity='2'";

TEST(WarnOfLimits, SaysNothingOfSoundOnes) {
  EXPECT_EQ(told(make_arm(kSound, kSound)), "");
  EXPECT_EQ(told(make_arm(kSound, kSound), "", LimitUse::drive), "");
}

struct Kind {
  const char* limits;
  const char* fault;
  const char* bound;  ///< what rounding bounds take
};
const std::vector<Kind> kKinds = {
    {"lower='1' upper='-1' effort='3' velocity='2'", "lower=1 is above upper=-1", "half a turn"},
    {"lower='0' upper='0' effort='3' velocity='2'", "lower and upper are both 0", "half a turn"},
    {"lower='-1' upper='1e8' effort='3' velocity='2'", "upper=1e+08 is more than anything",
     "half a turn"},
    {"lower='-1e16' upper='1' effort='3' velocity='2'", "lower=-1e+16 is more than anything",
     "half a turn"},
    {"lower='-1e8' upper='1e8' effort='3' velocity='2'", "lower=-1e+08 is more than anything",
     "half a turn"},
    {"lower='-1' upper='1' effort='3' velocity='0'", "velocity=0", "10 rad/s"},
    {"lower='-1' upper='1' effort='3' velocity='-2'", "velocity=-2 is negative", "10 rad/s"},
    {"lower='-1' upper='1' effort='3' velocity='1e8'", "velocity=1e+08 is more than anything",
     "10 rad/s"},
    {"lower='-1' upper='1' effort='0' velocity='2'", "effort=0", "1000 N m"},
    {"lower='-1' upper='1' effort='-1' velocity='2'", "effort=-1 is negative", "1000 N m"},
    {"lower='-1' upper='1' effort='1e9' velocity='2'", "effort=1e+09 is more than anything",
     "1000 N m"}};

TEST(WarnOfLimits, NamesEachKindOnceAndWhoReadsIt) {
  for (const Kind& kind : kKinds) {
    SCOPED_TRACE(kind.limits);
    const std::string text = told(make_arm(kind.limits, kind.limits));
    EXPECT_EQ(count(text, "warning"), 1) << text;
    EXPECT_EQ(count(text, kind.fault), 1) << text;
    EXPECT_EQ(count(text, "arm.urdf:4: warning: joint[a]/limit"), 1) << text;
    EXPECT_EQ(count(text, "(and 1 more)"), 1) << text;
    EXPECT_EQ(count(text, std::string("bounds of rounding errors take ") + kind.bound), 1) << text;
    EXPECT_EQ(count(text, "controller") + count(text, "torque_limits") + count(text, "drive"), 0)
        << text;
    EXPECT_EQ(count(told(make_arm(kSound, kind.limits)), "more)"), 0);
  }
}

// Would catch the line of the joint in place of that of its limits.
TEST(WarnOfLimits, NameTheLineOfTheLimits) {
  for (const char* limits : {"lower='1' upper='-1' effort='3' velocity='2'",
                             "lower='-1' upper='1' effort='3' velocity='-2'",
                             "lower='-1' upper='1' effort='3' velocity='1000'"}) {
    Diagnostics diagnostics;
    const auto robot = parse_urdf(
        "<robot name='arm'><link name='base'/>\n" + limited_link("first") +
            "<joint\nname='a' type='revolute'>\n<parent link='base'/><child link='first'/>\n"
            "<axis xyz='0 1 0'/>\n<limit\n" +
            limits + "/></joint></robot>",
        "arm.urdf", diagnostics);
    ASSERT_TRUE(robot) << to_string(diagnostics);
    const std::string text = told(*robot);
    EXPECT_EQ(count(text, "arm.urdf:7: warning: joint[a]/limit"), 1) << text;
  }
}

TEST(WarnOfLimits, OfDriveNameDriveAlone) {
  for (const Kind& kind : kKinds) {
    const std::string text = told(make_arm(kind.limits, kSound), "", LimitUse::drive);
    EXPECT_EQ(count(text, "drive moves the joint "), 1) << text;
    EXPECT_EQ(count(text, "bounds"), 0) << text;
  }
}

TEST(WarnOfLimits, NameTheControllerAndTorqueLimits) {
  const std::string no_effort = "lower='-1' upper='1' effort='0' velocity='2'";
  EXPECT_EQ(count(told(make_arm(no_effort, kSound),
                       "controller: {laws: joint_impedance, limits: {a: {torque: none}}}"),
                  "the controller has what the scene says"),
            1);
  const std::string standing =
      "base: floating\noperational_points: [{name: hand, link: second, rows: [x]}]\n"
      "constraints: [{name: foot, between: [base, world]}]\ntorque_limits: urdf\n";
  EXPECT_EQ(count(told(make_arm(no_effort, kSound), standing),
                  "torque_limits leaves the motor unlimited"),
            1);
  EXPECT_EQ(count(told(make_arm("lower='-1' upper='1' velocity='2'", kSound), standing),
                  "no effort is stated: torque_limits leaves the motor unlimited"),
            1);
  EXPECT_EQ(told(make_arm("lower='-1' upper='1' velocity='2'", kSound)), "");
}

TEST(WarnOfLimits, PassOverLimitsThatNothingReads) {
  const std::string none = "lower='0' upper='0' effort='0' velocity='0'";
  EXPECT_EQ(told(make_arm(kSound, none), "locked: {b: 0}"), "");
  EXPECT_EQ(count(told(make_arm(kSound, none, "<mimic joint='a'/>")), "effort"), 0);
  EXPECT_EQ(count(told(make_arm(kSound, none, "<mimic joint='a'/>")), "velocity=0"), 1);
  EXPECT_EQ(told(make_arm(kSound, none, "<mimic joint='a'/>"), "base: floating\nlocked: {a: 0}"),
            "");
  const std::string loose = "lower='-1' upper='1' effort='0' velocity='2'";
  EXPECT_EQ(told(make_arm(kSound, loose),
                 "operational_points: [{name: p, link: first, rows: [x]}]\npassive: [b]\n"
                 "functions: [supported_control_torque]"),
            "")
      << "what has no motor has no effort";
}

TEST(WarnOfLimits, SayUpToWhichSpeedBoundsHold) {
  const std::string fast = "lower='-1' upper='1' effort='3' velocity='1000'";
  const std::string text = told(make_arm(fast, fast));
  EXPECT_EQ(count(text, "velocity=1000 (and 1 more): bounds of rounding errors"), 1) << text;
  EXPECT_EQ(count(text, "hold up to 100 rad/s"), 1) << text;
  EXPECT_EQ(told(make_arm(fast, fast), "", LimitUse::drive), "");
  EXPECT_EQ(told(make_arm("lower='-1' upper='1' effort='3' velocity='100'", kSound)), "");
}

}  // namespace
}  // namespace treeline
