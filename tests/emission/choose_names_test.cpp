#include <gtest/gtest.h>

#include "emission/body_steps.hpp"
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

// Would catch: a value that is called after another link or another result than its own.
TEST(ChooseNames, ValuesAreNamedByWhatTheyAreOrNeutrally) {
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
  EXPECT_EQ(names[part.node()], "t1");
  EXPECT_EQ(names[other.node()], "tau_1");
  EXPECT_EQ(names[x[0].node()], "");
  const auto beside_taken = choose_names(program, wanted, {"f4_x", "t1"});
  EXPECT_EQ(beside_taken[whole.node()], "f4_x_2");
  EXPECT_EQ(beside_taken[part.node()], "t1_2");
}

// Would catch: lanes of several links under the name of one.
TEST(ChooseNames, LanesAreNamedAfterAllTheirLinks) {
  Program program;
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 6);
  const std::vector<Expression> alike = {x[0] * x[1], x[2] * x[3]};
  program.graph.name(alike[0], "f8_x");
  program.graph.name(alike[1], "f15_x");
  const std::vector<Expression> unlike = {x[0] + x[4], x[2] + x[5]};
  program.graph.name(unlike[0], "f8_x");
  program.graph.name(unlike[1], "w15_x");
  program.packs = {{alike[0].node(), alike[1].node()}, {unlike[0].node(), unlike[1].node()}};
  program.results = {{{"y", 4, 1, ""}, {alike[0], alike[1], unlike[0], unlike[1]}}};
  const auto names =
      choose_names(program, std::vector<bool>(program.graph.nodes().size(), true), {});
  EXPECT_EQ(names[alike[0].node()], "f8_15_x");
  EXPECT_EQ(names[alike[1].node()], "");
  EXPECT_EQ(names[unlike[0].node()].front(), 't');
}

// Would catch: a number of one link that is called after another of the same size.
TEST(NameConstants, NamesKnownConstantsApartFromWhatIsTaken) {
  Program program;
  const Graph::Scope scope(program.graph);
  const auto x = test::input_vector("x", 1);
  program.results = {{{"y", 2, 1, ""}, {x[0] * 0.25, x[0] * 0.75}}};
  program.constants = std::make_shared<const ConstantNames>(ConstantNames{{0.25, "mass_3"}});
  std::set<std::string> taken = {"mass_3"};
  const auto names = name_constants(program, taken);
  ASSERT_EQ(names.size(), 1u);
  EXPECT_EQ(names.begin()->second, "mass_3_2");
  EXPECT_TRUE(taken.contains("mass_3_2"));
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
