// Would catch: memory or time that exceeds the stated limits for inputs made to be large, and a
// refusal of such inputs without a message.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <string>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "description/xml_faults.hpp"
#include "diagnosed.hpp"

namespace treeline {
namespace {

#if defined(__SANITIZE_ADDRESS__)
constexpr long kMostMemory = 4L << 20U;  // KiB: the sanitizer keeps what is freed
#else
constexpr long kMostMemory = 1L << 20U;
#endif

std::string repeated(std::size_t times, const std::string& text) {
  std::string result;
  result.reserve(times * text.size());
  for (std::size_t i = 0; i < times; ++i) result += text;
  return result;
}

std::string fault_of_urdf(const std::string& text) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(text, "large.urdf", diagnostics);
  if (robot.has_value() == diagnostics.has_errors()) return "neither or both";
  return diagnostics.has_errors() ? to_string(diagnostics) : "accepted";
}

std::string fault_of_scene(const std::string& text) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='r'><link name='a'/><link name='b'><inertial><mass value='1'/></inertial></link>"
      "<joint name='j' type='continuous'><parent link='a'/><child link='b'/></joint></robot>",
      "small.urdf", diagnostics);
  Diagnostics of_scene;
  const auto scene = parse_scene(text, "large.yaml", robot.value(), of_scene);
  if (scene.has_value() == of_scene.has_errors()) return "neither or both";
  return of_scene.has_errors() ? to_string(of_scene) : "accepted";
}

/// Reads in a separate process, so that its memory is known. Its message must contain `expected`.
void expect_bounded(const std::function<std::string()>& read, const std::string& expected) {
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    const std::string said = read();
    const bool found = said.find(expected) != std::string::npos;
    if (!found) fprintf(stderr, "expected \"%s\" in: %.2000s\n", expected.c_str(), said.c_str());
    _exit(found ? 0 : 1);
  }
  int status = 0;
  rusage usage{};
  ASSERT_EQ(wait4(child, &status, 0, &usage), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "status " << status;
  EXPECT_LT(usage.ru_maxrss, kMostMemory) << "KiB at most";
}

void expect_urdf(const std::string& text, const std::string& expected) {
  expect_bounded([&] { return fault_of_urdf(text); }, expected);
}

void expect_scene(const std::string& text, const std::string& expected) {
  expect_bounded([&] { return fault_of_scene(text); }, expected);
}

TEST(BoundedUrdf, MillionLinks) {
  expect_urdf("<robot name='r'>" + repeated(1000000, "<link name='a'/>") + "</robot>",
              "more than 400000 tags");
}

TEST(BoundedUrdf, MoreLinksThanCanBeGenerated) {
  expect_urdf("<robot name='r'>" + repeated(100000, "<link name='a'/>") + "</robot>",
              "has 100000 links, more than 4096");
}

TEST(BoundedUrdf, MillionAttributesOfOneElement) {
  std::string text = "<robot name='r'";
  for (int i = 0; i < 1000000; ++i) text += " a" + std::to_string(i) + "=''";
  expect_urdf(text + "/>", "1000001 attributes, more than 64");
}

TEST(BoundedUrdf, MillionsOfAttributes) {
  expect_urdf("<robot name='r'>" +
                  repeated(300000, "<a a='' b='' c='' d='' e='' f='' g='' h='' i='' j=''/>") +
                  "</robot>",
              "more than 1000000 attributes");
}

TEST(BoundedUrdf, MillionComments) {
  expect_urdf("<robot name='r'>" + repeated(1000000, "<!---->") + "</robot>", "tags");
}

TEST(BoundedUrdf, AsMuchAsIsRead) {
  const std::string element = "<a a='' b=''/>" + std::string(120, ' ');
  expect_urdf("<robot name='r'><link name='a'/>" + repeated(kMostTags - 10, element) + "</robot>",
              "accepted");
}

TEST(BoundedUrdf, DeepNesting) {
  expect_urdf(repeated(100000, "<robot>"), "nested too deeply");
  expect_urdf(
      "<robot name='r'>" + repeated(1000, "<gazebo>") + repeated(1000, "</gazebo>") + "</robot>",
      "nested too deeply");
}

TEST(BoundedUrdf, LongNames) {
  const std::string name(60U << 20U, 'a');
  expect_urdf("<robot name='r'><link name='" + name + "'/></robot>", "bytes, more than 1000");
  expect_urdf("<robot name='" + name + "'><link name='a'/></robot>", "bytes, more than 1000");
}

TEST(BoundedUrdf, LongNumbers) {
  const std::string zeros(1U << 20U, '0');
  const auto robot = [](const std::string& mass) {
    return "<robot name='r'><link name='a'><inertial><mass value='" + mass +
           "'/></inertial></link></robot>";
  };
  expect_urdf(robot("1." + zeros + "1"), "accepted");
  expect_urdf(robot("1" + zeros), "not a finite number");
}

TEST(BoundedUrdf, EntitiesAreNotExpanded) {
  std::string text = "<!DOCTYPE r [<!ENTITY a0 'aaaaaaaaaa'>";
  for (int i = 1; i < 20; ++i) {
    const std::string last = "&a" + std::to_string(i - 1) + ";";
    text += "<!ENTITY a" + std::to_string(i) + " '" + repeated(10, last) + "'>";
  }
  expect_urdf(text + "]><robot name='&a19;'><link name='a'/></robot>", "error");
}

TEST(BoundedUrdf, FaultsByTheHundredThousand) {
  expect_urdf("<robot name='r'><link name='a'/>" + repeated(4000, "<link/>") +
                  repeated(4000, "<joint><origin xyz='a' rpy='b'/><axis xyz='c'/></joint>") +
                  "</robot>",
              "more faults are not listed");
  std::string attributes = "<robot name='r'><link name='a'>";
  for (int i = 0; i < 100000; ++i) attributes += "<inertial a" + std::to_string(i) + "=''/>";
  expect_urdf(attributes + "</link></robot>", "<inertial> has no <mass>");
}

TEST(BoundedNumbers, BeyondComputing) {
  const auto robot = [](const std::string& origin, const std::string& mass) {
    return "<robot name='r'><link name='a'><inertial><mass value='" + mass +
           "'/></inertial></link><link name='b'/><joint name='j' type='fixed'><parent "
           "link='a'/><child link='b'/><origin " +
           origin + "/></joint></robot>";
  };
  expect_urdf(robot("xyz='1e30 0 0'", "1e30"), "accepted");
  expect_urdf(robot("xyz='1.1e30 0 0'", "1"), "too large to compute with");
  expect_urdf(robot("xyz='0 0 0'", "1e308"), "too large to compute with");
  expect_urdf(robot("rpy='0 1e9 0'", "1"), "accepted");
  expect_urdf(robot("rpy='0 1.1e9 0'", "1"), "at most 1000000000 rad");
  expect_urdf(robot("xyz='5e-324 0 -1e-310'", "1e-99"), "accepted");
  expect_urdf(robot("xyz='0 0 0'", "2e-320"), "accepted");  // with a warning, as 0
  expect_urdf(robot("xyz='1e-400 0 0'", "1e-400"), "accepted");
  expect_urdf(robot("xyz='nan 0 0'", "1"), "not three finite numbers");
  expect_urdf(robot("xyz='0 inf 0'", "1"), "not three finite numbers");
}

TEST(BoundedScene, LargeText) {
  expect_scene("name: r\n#" + std::string(2U << 20U, 'a'), "more than 1 MiB");
}

TEST(BoundedScene, LongLists) {
  expect_scene("operational_points: [" + repeated(100000, "{},") + "]", "more than 4096");
  expect_scene("functions: [" + repeated(4000, "gravity,") + "]", "4000 functions are listed");
  expect_scene("operational_points: [{name: p, link: b, rows: [" + repeated(4000, "x,") + "]}]",
               "4000 rows are listed");
}

TEST(BoundedScene, AliasesOfFaults) {
  expect_scene(
      "operational_points: [&p {" + repeated(50, "a: b, ") + "}," + repeated(4000, "*p,") + "]",
      "more faults");
  std::string text = "a0: &a0 [x]\n";
  for (int i = 1; i < 30; ++i) {
    const std::string name = fmt::format("a{}", i), last = fmt::format("*a{} ", i - 1);
    text += fmt::format("{0}: &{0} [{1},{1}]\n", name, last);
  }
  expect_scene(text + "gravity: *a29", "error");
}

TEST(BoundedScene, Numbers) {
  expect_scene("gravity: [0, 0, 1e31]", "too large to compute with");
  expect_scene("operational_points: [{name: p, link: b, origin: {rpy: [1e10, 0, 0]}}]",
               "at most 1000000000 rad");
  expect_scene("locked: {j: 2e9}", "at most 1000000000 rad");
}

}  // namespace
}  // namespace treeline
