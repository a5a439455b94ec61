#pragma once

#include <gtest/gtest.h>

#include <ostream>
#include <string>

#include "description/read_urdf.hpp"
#include "diagnosed.hpp"

namespace treeline::bad_urdf {

/// One fault in an otherwise correct robot, and the expected diagnostic.
struct Case {
  std::string name;
  std::string text;
  Expected expected;
};

inline void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

/// Expects that the fault stops reading or not, according to its severity, and is reported as
/// expected.
inline void expect_case(const Case& c) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(c.text, "bad.urdf", diagnostics);
  EXPECT_EQ(robot.has_value(), c.expected.severity != Severity::error) << to_string(diagnostics);
  EXPECT_EQ(robot.has_value(), !diagnostics.has_errors()) << to_string(diagnostics);
  expect_diagnosed(diagnostics, "bad.urdf", c.expected);
}

inline std::string name_of(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

inline constexpr auto kError = Severity::error;
inline constexpr auto kWarning = Severity::warning;

// Functions, since tables of cases are made before `main`, in any order with other variables.
inline std::string link_body() {
  return "<inertial><mass value='1'/>"
         "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>";
}
inline std::string joint_limit() {
  return "<limit lower='-1' upper='1' effort='1' velocity='1'/>";
}

/// A robot with links a (line 2) and b (line 3) with mass, and `inside` within the joint in line 5.
inline std::string with_joint(const std::string& type, const std::string& inside) {
  return "<robot name='r'>\n<link name='a'>" + link_body() + "</link>\n<link name='b'>" +
         link_body() + "</link>\n<joint name='j' type='" + type +
         "'><parent link='a'/><child link='b'/>\n" + inside + "\n</joint></robot>";
}

/// A robot with `inside` within its only link, in line 3.
inline std::string with_link(const std::string& inside) {
  return "<robot name='r'>\n<link name='a'>\n" + inside + "\n</link></robot>";
}

/// A robot with `inside` after links a and b, in line 3.
inline std::string with_robot(const std::string& inside) {
  return "<robot name='r'>\n<link name='a'/> <link name='b'/>\n" + inside + "\n</robot>";
}

inline std::string inertia(const std::string& six) {
  return with_link("<inertial><mass value='1'/>\n<inertia " + six + "/></inertial>");
}

}  // namespace treeline::bad_urdf
