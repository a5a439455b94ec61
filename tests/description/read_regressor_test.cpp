// Would catch: a column that the scene asks for and does not get, and links without columns that
// are not reported with their place and a remedy.
#include <gtest/gtest.h>

#include "description/read_scene.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

const std::string kFunctions = "functions: [energy_regressor]\n";

TEST(ReadRegressor, ReadsEverySetting) {
  Diagnostics diagnostics;
  const auto scene =
      parse_scene(kFunctions + "regressor: {links: [fore, rail], rotors: true, friction: true}\n",
                  "s.yaml", make_robot(), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_FALSE(scene->regressor.base);
  EXPECT_EQ(scene->regressor.links, (std::vector<std::string>{"fore", "rail"}));
  EXPECT_TRUE(scene->regressor.rotors);
  EXPECT_TRUE(scene->regressor.friction);
}

TEST(ReadRegressor, ReadsPayloadsAndCoulombFriction) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(
      kFunctions + "regressor: {parameters: none, payload: tool, friction: coulomb, width: 0.2}\n",
      "s.yaml", make_robot(), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_TRUE(scene->regressor.none);
  EXPECT_EQ(scene->regressor.payloads, std::vector<std::string>{"tool"});
  EXPECT_TRUE(scene->regressor.friction);
  EXPECT_TRUE(scene->regressor.coulomb);
  EXPECT_EQ(scene->regressor.width, 0.2);
  const auto viscous =
      parse_scene(kFunctions + "regressor: {friction: viscous, payload: [fore, tool]}\n", "s.yaml",
                  make_robot(), diagnostics);
  ASSERT_TRUE(viscous) << to_string(diagnostics);
  EXPECT_TRUE(viscous->regressor.friction);
  EXPECT_FALSE(viscous->regressor.coulomb);
  EXPECT_EQ(viscous->regressor.payloads.size(), 2U);
}

TEST(ReadRegressor, TakesBaseParametersOfAllLinks) {
  Diagnostics diagnostics;
  const auto scene = parse_scene(kFunctions + "regressor: {parameters: base}\n", "s.yaml",
                                 make_robot(), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_TRUE(scene->regressor.base);
  EXPECT_TRUE(scene->regressor.links.empty());
  EXPECT_FALSE(scene->regressor.rotors);
}

TEST(ReadRegressor, SaysWhatIsWrong) {
  expect_told({
      {kFunctions + "regressor: {rotor: true}",
       {Severity::error, 2, "regressor/rotor", "unknown", "did you mean \"rotors\"?"}},
      {kFunctions + "regressor: {parameters: basic}",
       {Severity::error, 2, "regressor/parameters", "\"basic\"", "base"}},
      {kFunctions + "regressor: {links: [tol]}",
       {Severity::error, 2, "regressor/links[0]", "no link \"tol\"", "did you mean \"tool\"?"}},
      {kFunctions + "regressor: {links: base}",
       {Severity::error, 2, "regressor/links", "\"base\" cannot move", "behind a joint"}},
      {kFunctions + "regressor: {links: tool}",
       {Severity::error, 2, "regressor/links", "\"tool\" is fixed to \"fore\"", "name \"fore\""}},
      {kFunctions + "locked: {elbow: 0.1}\nregressor: {links: tool}",
       {Severity::error, 3, "regressor/links", "\"tool\" is fixed to \"upper\"", "name \"upper\""}},
      {kFunctions + "regressor: {links: [fore, fore]}",
       {Severity::error, 2, "regressor/links[1]", "listed twice", "once"}},
      {kFunctions + "regressor: {links: []}",
       {Severity::error, 2, "regressor/links", "no link is listed", "leave out"}},
      {kFunctions + "regressor: {links: fore, parameters: base}",
       {Severity::error, 2, "regressor/links", "those of several links", "parameters: all"}},
      {kFunctions + "regressor: {payload: base}",
       {Severity::error, 2, "regressor/payload", "\"base\" cannot move", "behind a joint"}},
      {kFunctions + "regressor: {payload: tool, parameters: base}",
       {Severity::error, 2, "regressor/payload", "cannot be told", "parameters: none"}},
      {kFunctions + "regressor: {parameters: none}",
       {Severity::error, 2, "regressor", "have no column", "add payload"}},
      {kFunctions + "regressor: {parameters: none, links: fore, rotors: true}",
       {Severity::error, 2, "regressor/links", "no columns of links", "parameters: all"}},
      {kFunctions + "regressor: {friction: true, width: 0.1}",
       {Severity::error, 2, "regressor/width", "only Coulomb friction", "friction: coulomb"}},
      {kFunctions + "regressor: {friction: coulomb, width: 0}",
       {Severity::error, 2, "regressor/width", "0 is not positive", "rad/s"}},
      {kFunctions + "regressor: {friction: colomb}",
       {Severity::error, 2, "regressor/friction", "\"colomb\"", "did you mean \"coulomb\"?"}},
      {"functions: [gravity]\nregressor: {parameters: base}",
       {Severity::warning, 1, "", "no function has them", "inverse_dynamics_regressor"}},
  });
}

}  // namespace
}  // namespace treeline
