#include <gtest/gtest.h>

#include "generation/warnings.hpp"
#include "program/ending.hpp"

// Would catch: code that compilers take long for, without a word before it is written, words about
// code that they do not, and remedies that do not help.

namespace treeline {
namespace {

Generation multiply(Function function, int times) {
  Generation generation;
  GeneratedFunction generated;
  generated.function = function;
  const Graph::Scope scope(generated.program.graph);
  Expression product = generated.program.graph.input("x[0]");
  for (int i = 0; i < times; ++i) product *= product;
  generated.program.results = {{{"y", 1, 1, "the product"}, {product}}};
  generation.functions.push_back(std::move(generated));
  generation.files = {{"product.cpp", std::string(2'000'000, ' ')}};
  return generation;
}

std::vector<Diagnostic> warnings(const Scene& scene, const Generation& generation) {
  Diagnostics diagnostics;
  warn_of_size(scene, generation, diagnostics);
  return diagnostics.list();
}

TEST(WarnOfSize, TellsWhatTakesLong) {
  EXPECT_TRUE(warnings({}, multiply(Function::mass_matrix, 20000)).empty());
  const auto told = warnings({}, multiply(Function::forward_dynamics_derivatives, 200000));
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].severity, Severity::warning);
  EXPECT_EQ(told[0].element, "forward_dynamics_derivatives");
  EXPECT_NE(told[0].fault.find("200000 operations; of the 2.0 MB"), std::string::npos);
  EXPECT_NE(told[0].fault.find("-O1"), std::string::npos);
  EXPECT_EQ(told[0].remedy.find("optimize"), std::string::npos);
}

// A routine has few lines however many operations its loops do.
TEST(WarnOfSize, CountsNoLoopsOfRoutines) {
  Generation generation = multiply(Function::forward_dynamics_derivatives, 200000);
  Program& program = generation.functions.front().program;
  Ending ending;
  ending.lines = multiply(Function::mass_matrix, 2000).functions.front().program;
  ending.executed.mul = 500000;
  program.ending = std::make_shared<const Ending>(std::move(ending));
  EXPECT_TRUE(warnings({}, generation).empty());
}

TEST(WarnOfSize, ProposesLoopsWhereThereAreSome) {
  Scene scene;
  const Generation generation = multiply(Function::forward_dynamics, 200000);
  EXPECT_NE(warnings(scene, generation).at(0).remedy.find("`optimize: size`"), std::string::npos);
  scene.optimize = Optimize::size;
  EXPECT_EQ(warnings(scene, generation).at(0).remedy.find("`optimize"), std::string::npos);
}

}  // namespace
}  // namespace treeline
