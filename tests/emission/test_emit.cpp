#include <gtest/gtest.h>

#include <algorithm>

#include "emission/emit.hpp"
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

// Would catch: a file that is not made, or the contract silent about something it promises.
TEST(Emit, MakesTheFolder) {
  Diagnostics diagnostics;
  const auto files = emit_sample(diagnostics);
  EXPECT_TRUE(diagnostics.list().empty());
  std::vector<std::string> names;
  for (const GeneratedFile& file : files) {
    names.push_back(file.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"CMakeLists.txt", "arm.hpp", "arm_eigen.hpp",
                                             "corner_cases.cpp", "inverse_dynamics.cpp",
                                             "manifest.json", "sin_cos.hpp"}));
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

// Would catch: code that a reader has to scroll sideways.
TEST(Emit, LinesStayWithinTheWidth) {
  Diagnostics diagnostics;
  for (const GeneratedFile& file : emit_sample(diagnostics)) {
    std::size_t begin = 0;
    for (std::size_t end = 0;
         file.name != "manifest.json" && (end = file.text.find('\n', begin)) != std::string::npos;
         begin = end + 1) {
      EXPECT_LE(end - begin, 100u) << file.name << ": " << file.text.substr(begin, end - begin);
    }
  }
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

// Would catch: two robots of one program sharing symbols, or a path to this project in the output.
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

/// The fault reported for one program, or nothing.
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

// Would catch: code that does not compile or cannot work, without a word.
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
