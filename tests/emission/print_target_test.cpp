// Would catch: a header or a build that does not say what processor it is for, flags that reach a
// build for this machine, and files that change where no processor is named.
#include "emission/print_target.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "emission/c/print_files.hpp"

namespace treeline {
namespace {

EmissionContext context_for(const char* target) {
  EmissionContext context;
  context.name = "arm";
  context.target = target;
  return context;
}

TEST(PrintTarget, SaysNothingOfTheGenericOne) {
  const EmissionContext context = context_for("generic");
  EXPECT_EQ(describe_target(context), "");
  EXPECT_EQ(print_section_macro(context), "");
  EXPECT_EQ(print_section(context), "");
  EXPECT_EQ(print_target_flags(context), "");
  EXPECT_EQ(print_target_lines(context), "");
  EXPECT_STREQ(contraction_default(context), "ON");
}

TEST(PrintTarget, FitsAMicrocontroller) {
  const EmissionContext context = context_for("cortex-m7");
  EXPECT_NE(describe_target(context).find("-mcpu=cortex-m7"), std::string::npos);
  EXPECT_NE(describe_target(context).find("--target cortex-m7"), std::string::npos);
  EXPECT_NE(print_section_macro(context).find("#define TREELINE_CODE_SECTION"), std::string::npos);
  EXPECT_EQ(print_section(context), "TREELINE_CODE_SECTION\n");
  const std::string flags = print_target_flags(context);
  EXPECT_NE(flags.find("target_compile_options(arm PRIVATE -mcpu=cortex-m7"), std::string::npos);
  EXPECT_NE(flags.find("${CMAKE_CROSSCOMPILING})"), std::string::npos);
  const std::string lines = print_target_lines(context);
  EXPECT_TRUE(
      lines.starts_with("  \"target\": \"cortex-m7\",\n  \"target_flags\": \"-mcpu=cortex-m7"))
      << lines;
  EXPECT_TRUE(lines.ends_with("  \"cross_compiled\": true,\n  \"contraction\": false,\n")) << lines;
  EXPECT_STREQ(contraction_default(context), "OFF");
}

TEST(PrintTarget, FitsALargeProcessor) {
  const EmissionContext context = context_for("x86-64-v3");
  EXPECT_EQ(describe_target(context).find("QEMU"), std::string::npos);
  EXPECT_NE(print_target_flags(context).find("-march=x86-64-v3\"\n  ON)"), std::string::npos);
  EXPECT_STREQ(contraction_default(context), "ON");
}

Program give_input(const std::string& name) {
  Program program;
  program.name = name;
  program.arguments = {{"q", 2, 1, ""}};
  const Graph::Scope scope(program.graph);
  program.results = {{{"y", 1, 1, ""}, {program.graph.input("q[0]")}}};
  return program;
}

// Would catch: a function in C that stays where it is while its callers go to fast memory.
TEST(PrintTarget, PlacesDampedControlInC) {
  EmissionContext context = context_for("cortex-m7");
  context.language = Language::c;
  context.velocities = 2;
  context.task_rows = 1;
  context.effective_mass_limits = {10};
  std::vector<Program> programs;
  for (const char* name : {"lambda_inverse", "jacobian", "bias_acceleration", "inverse_dynamics"}) {
    programs.push_back(give_input(name));
  }
  const std::string source = c::print_damped({context, programs, {}}).back().text;
  EXPECT_NE(source.find("#define TREELINE_CODE_SECTION"), std::string::npos) << source;
  EXPECT_NE(source.find("\nTREELINE_CODE_SECTION\ndouble arm_damped_control_torque("),
            std::string::npos)
      << source;
}

// Would catch: a long flag or phrase that makes a line of the header longer than 100 columns.
TEST(PrintTarget, KeepsLinesShort) {
  for (const char* target : {"cortex-m4f", "cortex-m33", "rv64gc", "aarch64", "x86-64-v4"}) {
    const std::string text = describe_target(context_for(target));
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      EXPECT_LE(end - begin, 97U) << text.substr(begin, end - begin);
      begin = end + 1;
    }
  }
}

}  // namespace
}  // namespace treeline
