// Would catch: a placeholder in a file that counts as a limit, a limit that does not, and one of
// which it is forgotten what the file says.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "description/urdf_parts.hpp"
#include "diagnosed.hpp"
#include "limited_arm.hpp"

namespace treeline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Limits limits_of(const std::string& attributes, const std::string& type = "revolute") {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(limited_arm(attributes, type), "arm.urdf", diagnostics);
  EXPECT_TRUE(robot) << to_string(diagnostics);
  return robot.value().joints.front().limits.value();
}

struct Ends {
  const char* attributes;
  double lower, upper;
  Placeholder of_lower, of_upper;
};

TEST(ReadJointLimits, RangesThatAreNone) {
  constexpr auto kNone = Placeholder::none;
  for (const auto& [attributes, lower, upper, of_lower, of_upper] :
       {Ends{"lower='-1' upper='2'", -1, 2, kNone, kNone},
        {"upper='2'", 0, 2, kNone, kNone},
        {"lower='-2'", -2, 0, kNone, kNone},
        {"lower='-inf' upper='2'", -kInfinity, 2, kNone, kNone},
        {"lower='1' upper='-1'", -kInfinity, kInfinity, Placeholder::reversed,
         Placeholder::reversed},
        {"lower='0' upper='0'", -kInfinity, kInfinity, Placeholder::equal, Placeholder::equal},
        {"lower='0.5' upper='0.5'", -kInfinity, kInfinity, Placeholder::equal, Placeholder::equal},
        {"lower='-1e8' upper='1e8'", -kInfinity, kInfinity, Placeholder::enormous,
         Placeholder::enormous},
        {"lower='-1e16' upper='1'", -kInfinity, 1, Placeholder::enormous, kNone},
        {"lower='-9999' upper='1e4'", -9999, kInfinity, kNone, Placeholder::enormous}}) {
    SCOPED_TRACE(attributes);
    for (const char* type : {"revolute", "prismatic"}) {
      const Limits limits = limits_of(std::string(attributes) + " effort='1' velocity='1'", type);
      EXPECT_EQ(limits.lower.value(), lower);
      EXPECT_EQ(limits.upper.value(), upper);
      EXPECT_EQ(limits.lower.placeholder(), of_lower);
      EXPECT_EQ(limits.upper.placeholder(), of_upper);
    }
    const Limits endless =
        limits_of(std::string(attributes) + " effort='1' velocity='1'", "continuous");
    EXPECT_EQ(endless.lower.state(), LimitState::absent);
    EXPECT_EQ(endless.upper.state(), LimitState::absent);
  }
}

// Would catch: a range that a file states and nothing reads, without a word; and a word about
// placeholders of none.
TEST(ReadJointLimits, OfJointsWithoutARangeAreToldAsIgnored) {
  const auto told = [](const char* type, const std::string& range) {
    Diagnostics diagnostics;
    const auto robot =
        parse_urdf(limited_arm(range + " effort='1' velocity='1'", type), "arm.urdf", diagnostics);
    EXPECT_TRUE(robot) << to_string(diagnostics);
    return to_string(diagnostics);
  };
  for (const char* type : {"planar", "floating", "continuous"}) {
    const std::string range = "the range -1 to 2 of a " + std::string(type) + " joint is ignored";
    EXPECT_NE(told(type, "lower='-1' upper='2'").find(range), std::string::npos)
        << told(type, "lower='-1' upper='2'");
    for (const char* none : {"", "lower='0' upper='0'", "lower='1' upper='-1'"}) {
      EXPECT_EQ(told(type, none).find("ignored"), std::string::npos) << told(type, none);
    }
  }
  EXPECT_EQ(told("revolute", "lower='-1' upper='2'").find("ignored"), std::string::npos);
}

struct Bound {
  const char* text;
  double of_speed, of_force;
  Placeholder speed, force;
};

TEST(ReadJointLimits, SpeedsAndForcesThatAreNone) {
  constexpr auto kNone = Placeholder::none;
  constexpr auto kEnormous = Placeholder::enormous;
  for (const auto& [text, of_speed, of_force, speed, force] :
       {Bound{"2.5", 2.5, 2.5, kNone, kNone},
        {"0", kInfinity, kInfinity, Placeholder::zero, Placeholder::zero},
        {"-0.0", kInfinity, kInfinity, Placeholder::zero, Placeholder::zero},
        {"-1", kInfinity, kInfinity, Placeholder::negative, Placeholder::negative},
        {"-inf", kInfinity, kInfinity, Placeholder::negative, Placeholder::negative},
        {"1000", 1000, 1000, kNone, kNone},
        {"10000", kInfinity, 1e4, kEnormous, kNone},
        {"1000000", kInfinity, kInfinity, kEnormous, kEnormous},
        {"1e8", kInfinity, kInfinity, kEnormous, kEnormous},
        {"9.9e29", kInfinity, kInfinity, kEnormous, kEnormous},
        {"1e30", kInfinity, kInfinity, kNone, kNone},
        {"1.7976931348623157e+308", kInfinity, kInfinity, kEnormous, kEnormous},
        {"inf", kInfinity, kInfinity, kNone, kNone}}) {
    SCOPED_TRACE(text);
    for (const char* type : {"revolute", "prismatic", "continuous"}) {
      const std::string given =
          std::string("lower='-1' upper='1' effort='") + text + "' velocity='" + text + "'";
      const Limits limits = limits_of(given, type);
      EXPECT_EQ(limits.velocity.value(), of_speed);
      EXPECT_EQ(limits.effort.value(), of_force);
      EXPECT_EQ(limits.velocity.placeholder(), speed);
      EXPECT_EQ(limits.effort.placeholder(), force);
      if (speed != kNone) EXPECT_EQ(limits.velocity.written(), std::stod(text));
    }
  }
}

TEST(ReadJointLimits, WhatIsMissingIsAbsentAndNoNumberIsAFault) {
  const Limits limits = limits_of("lower='-1' upper='1'");
  EXPECT_EQ(limits.velocity.state(), LimitState::absent);
  EXPECT_EQ(limits.effort.state(), LimitState::absent);
  EXPECT_EQ(limits.lower.state(), LimitState::stated);
  for (const char* attributes : {"effort='nan'", "velocity='nan'", "lower='nan'", "upper='fast'"}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(parse_urdf(limited_arm(attributes), "arm.urdf", diagnostics)) << attributes;
  }
}

}  // namespace
}  // namespace treeline
