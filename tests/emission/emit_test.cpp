#include "emission/emit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "emission/c/print_files.hpp"
#include "emission/cpp/print_files.hpp"
#include "emission/descriptions.hpp"
#include "emission/generated_file.hpp"
#include "emission/print_files.hpp"
#include "emission/sample.hpp"

namespace treeline {
namespace {

std::string text_of(const std::vector<GeneratedFile>& files, const std::string& name) {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const GeneratedFile& file) { return file.name == name; });
  return found == files.end() ? "" : found->text;
}

std::vector<GeneratedFile> emit_sample(Diagnostics& diagnostics) {
  return emit(test::sample_context("arm", false), test::sample_programs(), diagnostics);
}

std::vector<GeneratedFile> emit_sample_in_c(Diagnostics& diagnostics) {
  return emit(test::sample_context("arm", false, Language::c), test::sample_programs(),
              diagnostics);
}

// Would catch: a file that is not made, and a contract that omits something it promises.
TEST(Emit, MakesTheFolder) {
  Diagnostics diagnostics;
  const auto files = emit_sample(diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  std::vector<std::string> names;
  for (const GeneratedFile& file : files) {
    names.push_back(file.name);
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"CMakeLists.txt", "arm.hpp", "arm_calls.hpp", "arm_eigen.hpp",
                                      "arm_joints.hpp", "corner_cases.cpp", "id.cpp",
                                      "inverse_dynamics.cpp", "manifest.json", "sin_cos.hpp"}));
  const std::string contract = text_of(files, "arm.hpp");
  for (const char* part :
       {"From arm.urdf and arm.yaml by", "treeline generate arm.urdf arm.yaml --output arm",
        "shoulder (revolute): -3.1 .. 3.1 rad", "Gravity (0.0, -9.81, 0.0) m/s^2",
        "tool on forearm", "Locked: gripper", "tau = M(q) qdd + b(q, qd) + g(q)",
        "belongs to whoever ran",
        "void inverse_dynamics(const Real (&q)[2], const Real (&qd)[2], const Real (&qdd)[2],\n"
        "    Real (&tau)[2]) noexcept;"}) {
    EXPECT_NE(contract.find(part), std::string::npos) << part << "\n" << contract;
  }
}

// Would catch: a file in the other language, a name that others see without the robot's before it,
// a declaration that leaves sizes open.
TEST(EmitInC, MakesTheFolder) {
  Diagnostics diagnostics;
  const auto files = emit_sample_in_c(diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  std::vector<std::string> names;
  for (const GeneratedFile& file : files) {
    names.push_back(file.name);
    for (const char* cpp :
         {"namespace", "::", "constexpr", "static_assert", "template", "noexcept"}) {
      EXPECT_TRUE(file.name == "manifest.json" || file.text.find(cpp) == std::string::npos)
          << file.name << " has " << cpp;
    }
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"CMakeLists.txt", "arm.h", "arm_joints.h", "corner_cases.c",
                                      "id.c", "inverse_dynamics.c", "manifest.json", "sin_cos.h"}));
  const std::string contract = text_of(files, "arm.h");
  for (const char* part :
       {"From arm.urdf and arm.yaml by", "shoulder (revolute): -3.1 .. 3.1 rad",
        "#ifndef TREELINE_ARM_H\n", "extern \"C\"", "restrict static (size)",
        "  ARM_VELOCITIES = 2,",
        "void arm_inverse_dynamics(const double q[TREELINE_ARM_ARRAY(2)],\n"
        "    const double qd[TREELINE_ARM_ARRAY(2)], const double qdd[TREELINE_ARM_ARRAY(2)],\n"
        "    double tau[TREELINE_ARM_ARRAY(2)]);"}) {
    EXPECT_NE(contract.find(part), std::string::npos) << part << "\n" << contract;
  }
  EXPECT_NE(text_of(files, "manifest.json").find("\"language\": \"c\""), std::string::npos);
  EXPECT_NE(text_of(files, "corner_cases.c").find("  (void)unread;\n"), std::string::npos);
}

// Would catch: headers of two robots of which one hides the other, whose names differ in case.
TEST(Emit, GuardsHeadersOfEachRobot) {
  const auto guards_of = [](const std::string& robot) {
    std::vector<GeneratedFile> files = {{robot + ".hpp", "#pragma once\n"},
                                        {robot + "_joints.hpp", "#pragma once\n"},
                                        {"sin_cos.hpp", "#pragma once\n"}};
    guard_headers(robot, files);
    std::vector<std::string> guards;
    for (const GeneratedFile& file : files) {
      guards.push_back(file.text.substr(0, file.text.find('\n')));
    }
    return guards;
  };
  EXPECT_EQ(guards_of("arm")[1], "#ifndef TREELINE_ARM_JOINTS_HPP");
  std::set<std::string> all;
  for (const char* robot : {"arm", "Arm", "ARM", "aRm"}) {
    for (const std::string& guard : guards_of(robot))
      EXPECT_TRUE(all.insert(guard).second) << guard;
  }
}

// Would catch: something that a scene asks for and C does not have, left out without a word; a
// header that hides one of C's own.
TEST(EmitInC, RefusesWhatItDoesNotHave) {
  const auto elements = [](const EmissionContext& context) {
    Diagnostics diagnostics;
    const bool is_empty = emit(context, test::sample_programs(), diagnostics).empty();
    EXPECT_EQ(is_empty, diagnostics.has_errors());
    std::vector<std::string> named;
    for (const Diagnostic& diagnostic : diagnostics.list()) named.push_back(diagnostic.element);
    return named;
  };
  EXPECT_TRUE(elements(test::sample_context("arm", false, Language::c)).empty());
  EXPECT_EQ(elements(test::sample_context("math", false, Language::c)),
            std::vector<std::string>{"name"});
}

/// Products x, x^2, ..., each from the one before.
Program trace_products(int count) {
  Program program;
  program.name = "products";
  program.arguments = {{"x", 1, 1, "a factor"}};
  const Graph::Scope scope(program.graph);
  const Expression x = program.graph.input("x[0]");
  Expression product = x;
  for (int i = 0; i < count; ++i) product *= x;
  program.results = {{{"y", 1, 1, "the product"}, {product}}};
  return program;
}

// Would catch: GCC passes that take minutes for long code if they are enabled there, or that are no
// longer enabled elsewhere, and pragmas in sources.
TEST(Emit, LongFunctionsDoWithoutSlowPasses) {
  for (const Language language : {Language::cpp, Language::c}) {
    const EmissionContext context = test::sample_context("arm", false, language);
    const std::vector<Program> usual{trace_products(12000)}, slow{trace_products(12001)};
    EXPECT_FALSE(is_long(usual.front()));
    EXPECT_TRUE(is_long(slow.front()));
    const std::string with = print_project(context, list_sources({context, usual, {}}));
    EXPECT_NE(with.find(":-frename-registers>"), std::string::npos) << with;
    EXPECT_EQ(with.find("set_property("), std::string::npos) << with;
    const std::string without = print_project(context, list_sources({context, {}, slow}));
    EXPECT_NE(without.find("    batch_products.c"), std::string::npos) << without;
    EXPECT_NE(without.find(kNoExtraPasses), std::string::npos) << without;
    const auto& print = language == Language::c ? c::print_source : cpp::print_source;
    EXPECT_EQ(print(context, usual.front()).find("#pragma"), std::string::npos);
  }
}

// Would catch: functions of which the emitted project never ends to compile, by -O2 or by -Os.
TEST(Emit, HugeFunctionsAreOptimisedLess) {
  EmissionContext context = test::sample_context("arm", false);
  context.optimize = Optimize::size;
  const std::vector<Program> usual{trace_products(12001)}, huge{trace_products(100001)};
  const auto print = [&](const std::vector<Program>& programs) {
    return print_project(context, list_sources({context, programs, programs}));
  };
  EXPECT_EQ(print(usual).find("Too long"), std::string::npos);
  std::string options = print(huge);
  options.erase(0, options.find("Too long"));
  EXPECT_NE(options.find("    products.cpp\n    batch_products.cpp\n"), std::string::npos)
      << options;
  EXPECT_NE(options.find("COMPILE_OPTIONS -O1)"), std::string::npos) << options;
  EXPECT_NE(print(usual).find("    batch_products.cpp\n    APPEND PROPERTY COMPILE_OPTIONS -Os)"),
            std::string::npos);
  EXPECT_EQ(print(huge).find("batch_products.cpp\n    APPEND PROPERTY COMPILE_OPTIONS -Os)"),
            std::string::npos);
}

// Would catch: output without the version of the generator that made it.
TEST(Emit, NamesTheGeneratorsVersion) {
  Diagnostics diagnostics;
  const auto files = emit_sample(diagnostics);
  const std::string version = generator_version();
  EXPECT_EQ(std::count(version.begin(), version.end(), '.'), 2) << version;
  EXPECT_NE(text_of(files, "arm.hpp").find("// Generated by Treeline " + version + ";"),
            std::string::npos);
  EXPECT_NE(text_of(files, "manifest.json").find("\"generator\": \"treeline " + version + "\""),
            std::string::npos);
}

// Would catch: code with lines so long that readers have to scroll sideways.
TEST(Emit, LinesStayWithinTheWidth) {
  Diagnostics diagnostics;
  auto files = emit_sample(diagnostics);
  for (GeneratedFile& file : emit_sample_in_c(diagnostics)) files.push_back(std::move(file));
  for (const GeneratedFile& file : files) {
    std::size_t begin = 0;
    for (std::size_t end = 0;
         file.name != "manifest.json" && (end = file.text.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
      EXPECT_LE(end - begin, 100u) << file.name << ": " << file.text.substr(begin, end - begin);
    }
  }
}

// Would catch: headers of two robots with equal names, of which a program would see only the first.
TEST(Emit, GuardsHeadersByRobotAndFile) {
  Diagnostics diagnostics;
  const std::string licence = "// SPDX-License-Identifier: 0BSD\n";
  const auto files = emit_sample(diagnostics);
  for (const auto& [file, guard] : {std::pair{"arm.hpp", "TREELINE_ARM_HPP"},
                                    {"arm_joints.hpp", "TREELINE_ARM_JOINTS_HPP"},
                                    {"sin_cos.hpp", "TREELINE_ARM_SIN_COS_HPP"}}) {
    const std::string text = text_of(files, file), name = guard;
    EXPECT_TRUE(text.starts_with(licence + "#ifndef " + name + "\n#define " + name + "\n")) << text;
    EXPECT_TRUE(text.ends_with("\n#endif  // " + name + "\n")) << text;
    EXPECT_EQ(text.find("pragma once"), std::string::npos) << file;
  }
  // Robots whose names begin alike, as those of files do.
  for (const char* robot : {"s", "si"}) {
    const auto own = emit(test::sample_context(robot, false), test::sample_programs(), diagnostics);
    const std::string name =
        robot == std::string("s") ? "TREELINE_S_SIN_COS_HPP" : "TREELINE_SI_SIN_COS_HPP";
    EXPECT_TRUE(text_of(own, "sin_cos.hpp").starts_with(licence + "#ifndef " + name + "\n"))
        << robot;
  }
}

// Would catch: a file that a tool for licences finds without one, and a script whose first line no
// longer names its interpreter.
TEST(Emit, StatesTheLicenceOfEachFile) {
  Diagnostics diagnostics;
  for (const GeneratedFile& file : emit_sample(diagnostics)) {
    const bool has_comments = file.name != "manifest.json";
    EXPECT_EQ(file.text.find("SPDX-License-Identifier: 0BSD\n") != std::string::npos, has_comments)
        << file.name;
  }
  GeneratedFile script{"build", "#!/bin/sh\ncc\n"};
  state_licence(script);
  EXPECT_EQ(script.text, "#!/bin/sh\n# SPDX-License-Identifier: 0BSD\ncc\n");
}

// Would catch: an order that depends on addresses or hashes.
TEST(Emit, SameInputSameBytes) {
  Diagnostics diagnostics;
  const auto once = emit_sample(diagnostics);
  const auto again = emit_sample(diagnostics);
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].text, again[i].text);
  }
}

// Would catch: two robots of one program that share symbols, and a path to this project in the
// output.
TEST(Emit, SineAndCosineAreTheRobotsOwn) {
  Diagnostics diagnostics;
  const std::string text = text_of(emit_sample(diagnostics), "sin_cos.hpp");
  EXPECT_NE(text.find("namespace arm::detail {"), std::string::npos);
  EXPECT_EQ(text.find("treeline::core"), std::string::npos);
}

TEST(Emit, NoFileEndsInBlanks) {
  Diagnostics diagnostics;
  for (const GeneratedFile& file : emit_sample(diagnostics)) {
    EXPECT_EQ(file.text.find(" \n"), std::string::npos) << file.name;
    EXPECT_EQ(file.text.find("{{"), std::string::npos) << file.name;
  }
}

/// The fault that is reported for one program, or nothing.
std::string fault_of(const EmissionContext& context, const std::vector<Program>& programs) {
  Diagnostics diagnostics;
  const auto files = emit(context, programs, diagnostics);
  EXPECT_EQ(files.empty(), diagnostics.has_errors());
  return diagnostics.list().empty() ? "" : diagnostics.list()[0].fault;
}

Program quotient(double numerator, double denominator, int rows) {
  Program program;
  program.name = "quotient";
  program.arguments = {{"x", rows, 1, ""}};
  const Graph::Scope scope(program.graph);
  program.results = {{{"y", 1, 1, ""}, {numerator * program.graph.input("x[0]") / denominator}}};
  return program;
}

// Would catch: code that does not compile or cannot work, without a message.
TEST(Emit, RefusesWhatCannotBecomeCode) {
  const EmissionContext arm = test::sample_context("arm", false);
  const EmissionContext arm32 = test::sample_context("arm", true);
  EXPECT_EQ(fault_of(arm, {quotient(1, 2, 1)}), "");
  EXPECT_NE(fault_of(arm, {quotient(1, 0, 1)}).find("divides by zero"), std::string::npos);
  EXPECT_NE(fault_of(arm, {quotient(1, 2, 0)}).find("no elements"), std::string::npos);
  EXPECT_NE(fault_of(arm32, {quotient(1e300, 1, 1)}).find("not finite"), std::string::npos);
  EXPECT_EQ(fault_of(arm, {quotient(1e300, 1, 1)}), "");
  EXPECT_NE(fault_of(arm, {quotient(1, 2, 1), quotient(1, 2, 1)}).find("taken"), std::string::npos);
  EXPECT_NE(fault_of(test::sample_context("namespace", false), {}).find("name in C++"),
            std::string::npos);
  EXPECT_NE(fault_of(test::sample_context("quotient", false), {quotient(1, 2, 1)}).find("taken"),
            std::string::npos);
}

}  // namespace
}  // namespace treeline
