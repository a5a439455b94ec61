#include <gtest/gtest.h>

#include <memory>
#include <utility>

#include "emission/controller_unit.hpp"
#include "emission/print_files.hpp"
#include "emission/sample.hpp"
#include "program/link_loops.hpp"

// Would catch: flags that the scene did not ask for, on functions that have nothing to gain, and
// names of files that CMake does not have.
namespace treeline {
namespace {

std::string print_whole(const EmissionContext& context, std::span<const Program> programs) {
  return print_project(context, list_sources({context, programs, {}}));
}

/// Lines that compile sources to small code, and what precedes them: "" where there are none.
std::string print_small(const EmissionContext& context, std::span<const Program> programs) {
  const std::string project = print_whole(context, programs);
  const std::size_t begin = project.find("# `optimize` of the scene");
  return begin == std::string::npos ? "" : project.substr(begin);
}

std::string print(Optimize optimize, Language language) {
  EmissionContext context = test::sample_context("arm", false, language);
  context.optimize = optimize;
  return print_small(context, test::safe_programs());
}

TEST(PrintSmallCode, ListsWhatTheSceneAsksFor) {
  EXPECT_EQ(print(Optimize::speed, Language::c), "");
  const std::string all = print(Optimize::size, Language::c);
  EXPECT_NE(all.find("    inverse_dynamics.c\n"), std::string::npos) << all;
  EXPECT_NE(all.find("    long_chain.c\n"), std::string::npos) << all;
  EXPECT_NE(all.find("CMAKE_C_COMPILER_ID"), std::string::npos) << all;
}

// Would catch: a source of the folder that is compiled for speed where the scene asks for size.
TEST(PrintSmallCode, ListsControlInC) {
  EmissionContext context = test::sample_context("arm", false, Language::c);
  context.optimize = Optimize::size;
  context.effective_mass_limits = {10, 10};
  context.limits = LimitFacts{};
  const std::string all = print_small(context, test::safe_programs());
  EXPECT_NE(all.find("    damped_control_torque.c\n"), std::string::npos) << all;
  EXPECT_NE(all.find("    limited_control_torque.c\n"), std::string::npos) << all;
  context.language = Language::cpp;
  const std::string headers = print_small(context, test::safe_programs());
  EXPECT_EQ(headers.find("control_torque"), std::string::npos) << headers;
}

// Would catch: a joined source of loops that is compiled for speed, or beside those that it joins.
TEST(PrintSmallCode, JoinsLoopsInC) {
  EmissionContext context = test::sample_context("arm", false, Language::c);
  context.optimize = Optimize::size;
  std::vector<Program> programs = test::safe_programs();
  const auto loops = std::make_shared<const LinkLoops>();
  programs[0].loops = loops;
  EXPECT_EQ(print_small(context, programs).find("_loops"), std::string::npos);
  programs[1].loops = loops;
  const std::string path = "${CMAKE_CURRENT_BINARY_DIR}/arm_loops.c\n";
  EXPECT_NE(print_small(context, programs).find("    " + path), std::string::npos);
  const std::string project = print_whole(context, programs);
  const std::string library = project.substr(project.find("add_library"));
  const std::string sources = library.substr(0, library.find(')'));
  EXPECT_NE(sources.find("  " + path), std::string::npos) << sources;
  EXPECT_EQ(sources.find(programs[0].name), std::string::npos) << sources;
  EXPECT_NE(sources.find("  long_chain.c\n"), std::string::npos) << sources;
  const std::string joined = project.substr(0, project.find("add_library"));
  EXPECT_NE(joined.find("    " + programs[0].name + ".c\n"), std::string::npos) << joined;
}

/// A program of two operations for each link.
Program trace_chain(const std::string& name, int links) {
  Program program;
  program.name = name;
  program.arguments = {{"x", 2, 1, ""}};
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 2);
  Expression sum = x[0];
  for (int i = 0; i < links; ++i) sum = sum * x[1] + x[0];
  program.results = {{{"y", 1, 1, ""}, {sum}}};
  return program;
}

// Would catch: minutes of compilation of a long function that only the controller calls.
TEST(PrintExtraPasses, LeavesOutLongFunctionsOfTheController) {
  EmissionContext context = test::sample_context("arm", false);
  ControllerUnit unit;
  unit.kinematics = trace_chain("controller_kinematics", 100);
  unit.joint_torque = trace_chain("controller_joint_torque", 100);
  unit.task_torque = trace_chain("controller_task_torque", 6500);
  context.controller = std::make_shared<const ControllerUnit>(std::move(unit));
  const std::string project = print_whole(context, {});
  const std::string options = project.substr(project.find("-flive-range-shrinkage"));
  EXPECT_NE(options.find("    controller_task_torque.cpp\n"), std::string::npos) << options;
  EXPECT_EQ(options.find("controller_kinematics"), std::string::npos) << options;
  EXPECT_NE(options.find(kNoExtraPasses), std::string::npos) << options;
}

}  // namespace
}  // namespace treeline
