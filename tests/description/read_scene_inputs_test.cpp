// Would catch: an input that is read as another, ranges that are lost, and links or points that no
// argument can be of which are not reported with their place and a remedy.
#include <gtest/gtest.h>

#include <cmath>

#include "description/read_scene.hpp"
#include "scene_robot.hpp"

namespace treeline {
namespace {

const std::string kFoot = "constraints: [{name: foot, between: [tool, world]}]\n";
const std::string kPoints = "operational_points: [{name: a, link: tool}, {name: b, link: rail}]\n";

TEST(ReadInputs, ReadsEverySetting) {
  Diagnostics diagnostics;
  const auto scene =
      parse_scene(kPoints +
                      "inputs:\n"
                      "  gravity: true\n"
                      "  payload: [tool, {link: rail, mass: 3, reach: 0.2}]\n"
                      "  parameters: [fore, {link: upper, mass: 7}]\n"
                      "  tool: [{point: b, reach: 0.4}, {point: a, orientation: true}]\n"
                      "  contact: {contact: heel, reach: 0.2}\n"
                      "  active: [hand, b, palm]\n"
                      "contacts: [{name: toe, link: tool}, {name: heel, link: rail}]\n"
                      "constraints: [{name: palm, between: [tool, world]}, {name: hand, between: "
                      "[tool, base]}]\n",
                  "s.yaml", make_robot(), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  const SceneInputs& inputs = scene->inputs;
  EXPECT_TRUE(inputs.gravity);
  ASSERT_EQ(inputs.payloads.size(), 2U);
  EXPECT_EQ(inputs.payloads[0].link, "tool");
  EXPECT_EQ(inputs.payloads[0].mass, kPayloadMass);
  EXPECT_EQ(inputs.payloads[0].reach, kPayloadReach);
  EXPECT_EQ(inputs.payloads[1].mass, 3);
  EXPECT_EQ(inputs.payloads[1].reach, 0.2);
  ASSERT_EQ(inputs.parameters.size(), 2U);
  EXPECT_EQ(inputs.parameters[0].link, "fore");
  EXPECT_EQ(inputs.parameters[0].mass, 2);  // twice the file's 1 kg, with three moments of 1 kg m^2
  EXPECT_DOUBLE_EQ(inputs.parameters[0].reach, 2 * std::sqrt(1.5));
  EXPECT_EQ(inputs.parameters[1].mass, 7);
  ASSERT_EQ(inputs.tools.size(), 2U);
  EXPECT_EQ(inputs.tools[0].point, "b");
  EXPECT_EQ(inputs.tools[0].reach, 0.4);
  EXPECT_FALSE(inputs.tools[0].orientation);
  EXPECT_TRUE(inputs.tools[1].orientation);
  ASSERT_EQ(inputs.contacts.size(), 1U);
  EXPECT_EQ(inputs.contacts[0].point, "heel");
  EXPECT_EQ(inputs.contacts[0].reach, 0.2);
  EXPECT_EQ(inputs.active, (std::vector<std::string>{"hand", "palm"}));
  EXPECT_EQ(inputs.active_tasks, (std::vector<std::string>{"b"}));
}

TEST(ReadInputs, TakesBaseParameters) {
  Diagnostics diagnostics;
  const auto scene = parse_scene("inputs: {base_parameters: true}\nfunctions: [gravity]\n",
                                 "s.yaml", make_robot(), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_TRUE(scene->inputs.base_parameters);
  const auto refused = [](const std::string& text) {
    Diagnostics found;
    EXPECT_FALSE(parse_scene(text, "s.yaml", make_robot(), found)) << text;
    return to_string(found);
  };
  EXPECT_NE(refused("inputs: {base_parameters: true, parameters: fore}").find("in place of"),
            std::string::npos);
  for (const char* function : {"center_of_mass", "potential_energy", "centroidal_momentum"}) {
    const std::string text = refused("inputs: {base_parameters: true}\nfunctions: [" +
                                     std::string(function) + "]\nbase: fixed");
    EXPECT_NE(text.find("masses that base parameters do not contain"), std::string::npos) << text;
  }
  const auto floating =
      parse_scene("inputs: {base_parameters: true}\nfunctions: [center_of_mass]\nbase: floating",
                  "s.yaml", make_robot(), diagnostics);
  EXPECT_TRUE(floating) << to_string(diagnostics);
  EXPECT_NE(refused("inputs: {base_parameters: true}\nbase: floating\n"
                    "functions: [subtree_masses_and_centers]")
                .find("masses that base parameters do not contain"),
            std::string::npos);
}

TEST(ReadInputs, TakesOneForAList) {
  Diagnostics diagnostics;
  const auto scene =
      parse_scene(kPoints + "inputs: {payload: tool, parameters: fore, tool: a, gravity: false}\n",
                  "s.yaml", make_robot(), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_FALSE(scene->inputs.gravity);
  EXPECT_EQ(scene->inputs.payloads.at(0).link, "tool");
  EXPECT_EQ(scene->inputs.parameters.at(0).link, "fore");
  EXPECT_EQ(scene->inputs.tools.at(0).point, "a");
}

TEST(ReadInputs, TakesNamesOfWholeInputs) {
  Diagnostics diagnostics;
  const auto scene =
      parse_scene("inputs: [base_parameters, gravity]\n", "s.yaml", make_robot(), diagnostics);
  ASSERT_TRUE(scene) << to_string(diagnostics);
  EXPECT_TRUE(scene->inputs.gravity);
  EXPECT_TRUE(scene->inputs.base_parameters);
}

TEST(ReadInputs, SaysWhatIsWrong) {
  expect_told({
      {"inputs: {gravity: [0, 0, -9.81]}",
       {Severity::error, 1, "inputs/gravity", "one word is expected here, not a list", "true"}},
      {"inputs: [payload]", {Severity::error, 1, "inputs[0]", "\"payload\"", "gravity"}},
      {"inputs: [gravity, gravity]", {Severity::error, 1, "inputs[1]", "listed twice", "once"}},
      {"inputs: {wind: true}", {Severity::error, 1, "inputs/wind", "unknown", "gravity"}},
      {"inputs: {gravity: 9.81}", {Severity::error, 1, "inputs/gravity", "9.81", "true"}},
      {"inputs: {payload: tol}",
       {Severity::error, 1, "inputs/payload", "no link \"tol\"", "did you mean \"tool\"?"}},
      {"inputs: {payload: base}",
       {Severity::error, 1, "inputs/payload", "\"base\" cannot move", "behind a joint"}},
      {"locked: {shoulder: 0}\ninputs: {parameters: upper}",
       {Severity::error, 2, "inputs/parameters", "\"upper\" cannot move", "behind a joint"}},
      {"inputs: {payload: {mass: 3}}",
       {Severity::error, 1, "inputs/payload", "\"link\" is missing", ""}},
      {"inputs: {payload: {link: tool, mass: 0}}",
       {Severity::error, 1, "inputs/payload/mass", "0 is not positive", "largest"}},
      {"inputs: {parameters: [tool, tool]}",
       {Severity::error, 1, "inputs/parameters[1]", "listed twice", "once"}},
      {"inputs: {tool: a}",
       {Severity::error, 1, "inputs/tool", "no operational point \"a\"", "operational_points"}},
      {kPoints + "inputs: {tool: [a, a]}",
       {Severity::error, 2, "inputs/tool[1]", "listed twice", "once"}},
      {kPoints + "inputs: {tool: {point: a, orientation: 1}}",
       {Severity::error, 2, "inputs/tool/orientation", "\"1\"", "true"}},
      {"inputs: {contact: a}",
       {Severity::error, 1, "inputs/contact", "no contact \"a\"", "contacts"}},
      {"contacts: [{name: toe, link: tool}]\ninputs: {contact: [toe, toe]}",
       {Severity::error, 2, "inputs/contact[1]", "contact \"toe\" is listed twice", "once"}},
      {"contacts: [{name: toe, link: tool}]\ninputs: {contact: {contact: toe, orientation: true}}",
       {Severity::error, 2, "inputs/contact/orientation", "unknown", "reach"}},
      {kPoints +
           "objects: [{name: box, mass: 1, inertia: {ixx: 1, iyy: 1, izz: 1}, grasps: [{point: "
           "a}]}]\ninputs: {tool: a}",
       {Severity::error, 3, "inputs/tool", "\"a\" holds an object", "name a point"}},
      {"inputs: {active: foot}",
       {Severity::error, 1, "inputs/active", "no constraint or operational point \"foot\"",
        "a list"}},
      {kFoot + "inputs: {active: fot}",
       {Severity::error, 2, "inputs/active", "no constraint or operational point \"fot\"",
        "\"foot\""}},
      {kFoot + "inputs: {active: [foot, foot]}",
       {Severity::error, 2, "inputs/active[1]", "\"foot\" is listed twice", "once"}},
      {kFoot + "operational_points: [{name: foot, link: tool}]\ninputs: {active: foot}",
       {Severity::error, 3, "inputs/active", "both a constraint and", "another name"}},
      {kPoints + "inputs: {active: a}\ndamped: {mass: 40, inertia: 4}",
       {Severity::error, 1, "", "damped does every task all the time", "for each set"}},
      {kFoot + "inputs: {active: foot}\nfunctions: [constraint_jacobian]",
       {Severity::warning, 1, "", "active is listed under inputs", "add a function"}},
      {kPoints + "functions: [jacobian]\ninputs: {tool: {point: a, orientation: true}}",
       {Severity::warning, 1, "", "tool_orientation is listed under inputs", "add a function"}},
      {"functions: [mass_matrix]\ninputs: {gravity: true}",
       {Severity::warning, 1, "", "gravity is listed under inputs", "add a function"}},
  });
}

}  // namespace
}  // namespace treeline
