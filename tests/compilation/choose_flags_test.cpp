
#include <set>

#include "check/fixture.hpp"
#include "compilation/compile_folder.hpp"

// Functions are judged as they are delivered. Would catch: a function that the emitted
// CMakeLists.txt compiles to small code and `check` does not, or the other way round, and a long
// function that is judged without optimisation though small code is delivered.

namespace treeline::tests {
namespace {

/// Names without ending of the sources behind which the emitted CMakeLists.txt puts -Os.
std::set<std::string> list_small_in_project(const Generation& generation) {
  std::string project;
  for (const GeneratedFile& file : generation.files) {
    if (file.name == "CMakeLists.txt") project = file.text;
  }
  const auto begin = project.find("set_property(SOURCE\n");
  if (begin == std::string::npos) return {};
  const auto end = project.find("APPEND PROPERTY COMPILE_OPTIONS -Os", begin);
  std::set<std::string> names;
  for (const std::string& word : split_words(project.substr(begin, end - begin))) {
    if (word.find('.') != std::string::npos) names.insert(word.substr(0, word.find('.')));
  }
  return names;
}

std::set<std::string> list_small_in_check(const Subjects& subjects) {
  CompileOptions options;
  options.language = subjects.scene.language;
  options.optimize = subjects.scene.optimize;
  options.long_flags = "-O0";
  std::set<std::string> names;
  for (const GeneratedFunction& generated : all_callable(subjects.generation)) {
    const FunctionFlags chosen = choose_flags(generated, options);
    EXPECT_EQ(chosen.is_small, chosen.flags.ends_with(" -Os")) << chosen.flags;
    EXPECT_FALSE(chosen.is_small && chosen.is_long);
    if (chosen.is_small) names.insert(source_stem(generated));
  }
  return names;
}

std::set<std::string> expect_same_names(Subjects subjects) {
  subjects.generation = generate(subjects.robot, subjects.scene);
  const std::set<std::string> names = list_small_in_check(subjects);
  EXPECT_EQ(names, list_small_in_project(subjects.generation));
  return names;
}

TEST(ChooseFlags, FollowsTheEmittedProject) {
  Subjects arm = load_unmade("ur10e", "scene.yaml");
  EXPECT_EQ(expect_same_names(arm).size(), 0U);
  arm.scene.optimize = Optimize::size;
  EXPECT_EQ(expect_same_names(arm).count("damped_control_torque"), 0U);  // a header
  arm.scene.batch = 4;
  EXPECT_EQ(expect_same_names(arm).count("batch_gravity"), 1U);
  arm.scene.batch = 0;
  arm.scene.lanes = 1;
  arm.scene.language = Language::c;
  EXPECT_EQ(expect_same_names(arm).count("damped_control_torque"), 1U);
}

GeneratedFunction multiply(int times) {
  GeneratedFunction generated;
  const Graph::Scope scope(generated.program.graph);
  Expression product = generated.program.graph.input("x[0]");
  for (int i = 0; i < times; ++i) product *= product;
  generated.program.results = {{{"y", 1, 1, "the product"}, {product}}};
  return generated;
}

TEST(ChooseFlags, HugeFunctionsAreOptimisedLess) {
  GeneratedFunction generated = multiply(100001);
  CompileOptions options;
  options.optimize = Optimize::size;
  for (const int states : {0, 4}) {
    generated.batch = states;
    EXPECT_EQ(choose_flags(generated, options).flags, options.flags + " -O1");
    EXPECT_FALSE(choose_flags(generated, options).is_small);
  }
  options.flags = "-O0";
  EXPECT_EQ(choose_flags(generated, options).flags, "-O0");
  options.long_flags = "-O0 -g";
  EXPECT_EQ(choose_flags(generated, options).flags, "-O0 -g");
}

TEST(ChooseFlags, LongFunctionsThatAreSmallCodeAreOptimised) {
  const GeneratedFunction generated = multiply(12001);
  CompileOptions options;
  options.long_flags = "-O0";
  EXPECT_EQ(choose_flags(generated, options).flags, "-O0");
  EXPECT_TRUE(choose_flags(generated, options).is_long);
  options.optimize = Optimize::size;
  EXPECT_EQ(choose_flags(generated, options).flags, options.flags + " -Os");
  EXPECT_FALSE(choose_flags(generated, options).is_long);
}

// The figures that `check` prints are those of small code.
TEST(ChooseFlags, CheckJudgesSmallCode) {
  Subjects arm = load_unmade("puma560", "scene.yaml");
  arm.scene.language = Language::c;
  arm.scene.lanes = 1;
  arm.scene.functions = {Function::mass_matrix};
  arm.generation = generate(arm.robot, arm.scene);
  const CheckReport fast = check_or_throw(arm, quick_options());
  arm.scene.optimize = Optimize::size;
  arm.generation = generate(arm.robot, arm.scene);
  const CheckReport small = check_or_throw(arm, quick_options());
  EXPECT_TRUE(small.passed()) << print_text(small);
  EXPECT_TRUE(fast.small_command.empty());
  EXPECT_FALSE(fast.functions.front().is_small);
  EXPECT_EQ(small.small_command, fast.compile_command + " -Os");
  EXPECT_TRUE(small.functions.front().is_small);
  EXPECT_LT(2 * small.functions.front().code_bytes.value(),
            fast.functions.front().code_bytes.value());
  EXPECT_NE(print_text(small).find("-Os: mass_matrix,"), std::string::npos) << print_text(small);
  EXPECT_NE(print_json(small).find("\"small\": true"), std::string::npos);
}

}  // namespace
}  // namespace treeline::tests
