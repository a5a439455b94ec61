#include "emission/print_controller.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <regex>
#include <sstream>

#include "emission/controller_unit.hpp"
#include "emission/print_prefetch.hpp"
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

// Would catch: functions of the controller's own that have a section and that nothing loads, and a
// section that nothing is in.
TEST(PrintController, LoadsAStepAndItsDynamics) {
  EmissionContext context = test::sample_context("arm", false);
  context.prefetch = true;
  context.controller = std::make_shared<const ControllerUnit>(odd_unit());
  const std::vector<Program> programs = {give_first("gravity", "g")};
  const std::vector<GeneratedFile> files = print_prefetch({context, programs, {}});
  const std::string& source = files.back().text;
  for (const char* function : {"gravity", "controller_kinematics", "controller_joint_torque"}) {
    const std::string section = std::string("treeline_arm_") + function;
    EXPECT_NE(source.find("load(__start_" + section + ", __stop_" + section + ");"),
              std::string::npos)
        << section << source;
    EXPECT_NE(print_prefetch_macro(context, function).find('"' + section + '"'), std::string::npos);
  }
  EXPECT_NE(files.front().text.find("void prefetch_step() noexcept;"), std::string::npos);
  EXPECT_NE(source.find("load(__start_treeline_arm_controller, "), std::string::npos) << source;
  const auto controller = print_controller({context, {}, {}});
  const std::string& step = controller[1].text;
  EXPECT_NE(step.find("section(\"treeline_arm_controller\"), flatten"), std::string::npos) << step;
  EXPECT_NE(step.find("TREELINE_OWN_SECTION\nvoid arm_step("), std::string::npos) << step;
}

TEST(PrintController, KeepsLinesShort) {
  for (const GeneratedFile& file : print_odd()) {
    std::istringstream lines(file.text);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
  }
}

}  // namespace
}  // namespace treeline
