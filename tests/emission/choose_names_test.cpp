#include "emission/choose_names.hpp"

#include <gtest/gtest.h>

#include "passes/two_link_arm.hpp"

// Would catch: generated code that does not compile because of a name.
namespace treeline {
namespace {

TEST(MakeIdentifier, MakesLegalNames) {
  EXPECT_EQ(make_identifier("w4_x"), "w4_x");
  EXPECT_EQ(make_identifier("left arm/elbow"), "left_arm_elbow");
  EXPECT_EQ(make_identifier("a__b"), "a_b");
  EXPECT_EQ(make_identifier("_Reserved_"), "Reserved");
  EXPECT_EQ(make_identifier("7dof"), "v7dof");
  EXPECT_EQ(make_identifier("double"), "double_value");
  EXPECT_EQ(make_identifier("\xc3\xa4"), "v");
  EXPECT_EQ(make_identifier(""), "v");
}

TEST(ChooseNames, TraceNamesWinPartsAreCalledAfterTheirWhole) {
  Program program;
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 4);
  const Expression part = x[0] + x[1];
  const Expression whole = part * x[2];
  program.graph.name(whole, "f4_x");
  const Expression other = part * x[3];
  program.results = {{{"tau", 2, 1, ""}, {whole, other}}};
  std::vector<bool> wanted(program.graph.nodes().size(), false);
  wanted[part.node()] = wanted[whole.node()] = wanted[other.node()] = true;
  const auto names = choose_names(program, wanted, {});
  EXPECT_EQ(names[whole.node()], "f4_x");
  EXPECT_EQ(names[part.node()], "f4_x_p1");
  EXPECT_EQ(names[other.node()], "tau_1");
  EXPECT_EQ(names[x[0].node()], "");
  EXPECT_EQ(choose_names(program, wanted, {"f4_x"})[whole.node()], "f4_x_2");
}

TEST(ChooseNames, EqualWishesAreKeptApart) {
  Program program;
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 3);
  std::vector<Expression> values = {x[0] * x[1], x[1] * x[2], x[0] * x[2]};
  for (const Expression& value : values) {
    program.graph.name(value, "w");
  }
  program.results = {{{"y", 3, 1, ""}, values}};
  const auto names =
      choose_names(program, std::vector<bool>(program.graph.nodes().size(), true), {});
  EXPECT_EQ(names[values[0].node()], "w");
  EXPECT_EQ(names[values[1].node()], "w_2");
  EXPECT_EQ(names[values[2].node()], "w_3");
}

}  // namespace
}  // namespace treeline
