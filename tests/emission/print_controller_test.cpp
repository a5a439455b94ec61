#include <gtest/gtest.h>

#include <memory>
#include <regex>
#include <sstream>

#include "emission/controller_unit.hpp"
#include "emission/print_files.hpp"
#include "emission/sample.hpp"

// Would catch: a name from a file that ends a comment of the controller's header, so that what is
// behind it is compiled, and lines so long that readers have to scroll sideways.
namespace treeline {
namespace {

constexpr const char* kOdd = "arm */ evil; /*";

Program give_first(const std::string& name, const std::string& result) {
  Program program;
  program.name = name;
  program.arguments = {{"q", 1, 1, ""}, {"payload", 10, 1, kOdd + std::string(60, 'x') + " y"}};
  const Graph::Scope scope(program.graph);
  program.results = {{{result, 1, 1, ""}, {program.graph.input("q[0]")}}};
  return program;
}

ControllerUnit odd_unit() {
  ControllerUnit unit;
  unit.kinematics = give_first("controller_kinematics", "g");
  unit.joint_torque = give_first("controller_joint_torque", "tau");
  unit.joints = {{kOdd, false, -1, 1, 2, 3}};
  return unit;
}

std::vector<GeneratedFile> print_odd() {
  EmissionContext context = test::sample_context("arm", false);
  context.robot = kOdd;
  context.controller = std::make_shared<const ControllerUnit>(odd_unit());
  return print_controller({context, {}, {}});
}

TEST(PrintController, KeepsNamesWithinComments) {
  const std::string header = print_odd().front().text;
  EXPECT_NE(header.find("evil"), std::string::npos);
  const std::string code =
      std::regex_replace(header, std::regex(R"(/\*[^*]*(\*[^/][^*]*)*\*/)"), "");
  EXPECT_EQ(code.find("evil"), std::string::npos) << code;
  EXPECT_NE(code.find("arm_number payload[10];"), std::string::npos) << code;
}

TEST(PrintController, KeepsLinesShort) {
  for (const GeneratedFile& file : print_odd()) {
    std::istringstream lines(file.text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  }
}

}  // namespace
}  // namespace treeline
