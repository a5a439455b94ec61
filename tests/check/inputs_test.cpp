// What changes the robot while it runs, as arguments of compiled functions. Would catch: an
// argument in another place of the list than the contract says, a function that does not take what
// it depends on, a bound that the new arguments make wrong, and costs that the manifest does not
// state. The reference is the interpreter with a payload as a body of its own.
#include <nlohmann/json.hpp>

#include "description/scene_inputs.hpp"
#include "fixture.hpp"

namespace treeline::tests {
namespace {

SceneInputs inputs_of_puma() {
  SceneInputs inputs;
  inputs.gravity = true;
  inputs.payloads = {{"link6", 3, 0.3}};
  inputs.parameters = {{"link3", 10, 0.5}};
  inputs.tools = {{"tool", 0.5, true}};
  return inputs;
}

std::vector<Function> all_of_a_robot() {
  std::vector<Function> functions;
  for (const Function function : kSceneFunctions) {
    if (needs_objects(function) || needs_contacts(function) || needs_constraints(function))
      continue;
    functions.push_back(function);
  }
  return functions;
}

void expect_right(const Subjects& subjects, int states) {
  const auto report = check_or_throw(subjects, quick_options(states));
  EXPECT_TRUE(report.passed()) << print_text(report);
  for (const GeneratedFunction& generated : subjects.generation.functions) {
    for (const Quantity quantity : info_of(generated.function).inputs) {
      if (!is_of_model(quantity)) continue;
      const auto& arguments = generated.program.arguments;
      EXPECT_EQ(std::any_of(
                    arguments.begin(), arguments.end(),
                    [&](const Argument& argument) { return argument.name == symbol_of(quantity); }),
                takes_input(subjects.scene, generated.function, quantity))
          << generated.program.name << " " << symbol_of(quantity);
    }
  }
}

TEST(CheckInputs, EveryFunctionOfPuma560) {
  Subjects subjects = load("puma560");
  subjects.scene.operational_points.front().axes = Axes::local;
  subjects.scene.inputs = inputs_of_puma();
  subjects.scene.functions = all_of_a_robot();
  subjects.generation = generate(subjects.robot, subjects.scene);
  expect_right(subjects, 60);
}

TEST(CheckInputs, InFloatInBatchesAndDamped) {
  Subjects subjects = load("puma560");
  subjects.scene.inputs = inputs_of_puma();
  subjects.scene.real = Real::float32;
  subjects.scene.batch = 4;
  subjects.scene.damped = EffectiveMassLimit{20, 0.5};
  subjects.scene.functions = {kDampedFunctions.begin(), kDampedFunctions.end()};
  subjects.generation = generate(subjects.robot, subjects.scene);
  expect_right(subjects, 40);
}

// A heavy payload lets rows yield, in the axes of the route: the batch has another route than the
// function of one state here.
TEST(CheckInputs, YieldsByTheRouteOfTheBatch) {
  Subjects subjects = load("puma560");
  subjects.scene.operational_points.front().axes = Axes::local;
  subjects.scene.inputs.payloads = {{"tool", 10, 0.5}};
  subjects.scene.batch = 4;
  subjects.scene.functions = {Function::control_torque};
  subjects.generation = generate(subjects.robot, subjects.scene);
  ASSERT_NE(key_of(subjects.generation.functions.front().chosen.route),
            key_of(subjects.generation.batch.front().chosen.route));
  expect_right(subjects, 40);
}

TEST(CheckInputs, InC) {
  Subjects subjects = load("puma560");
  subjects.scene.inputs = inputs_of_puma();
  subjects.scene.language = Language::c;
  subjects.scene.lanes = 1;
  subjects.scene.sin_cos = Sines::given;
  subjects.scene.damped = EffectiveMassLimit{20, 0.5};
  subjects.generation = generate(subjects.robot, subjects.scene);
  expect_right(subjects, 40);
}

TEST(CheckInputs, ContactsAndObjects) {
  for (const char* scene : {"scene_hit_wall.yaml", "scene_box.yaml"}) {
    SCOPED_TRACE(scene);
    Subjects subjects = load("humanoid24", scene);
    subjects.scene.inputs.gravity = true;
    subjects.scene.inputs.payloads = {{subjects.scene.operational_points.front().link, 2, 0.3}};
    if (!subjects.scene.contacts.empty()) {
      subjects.scene.inputs.contacts = {{subjects.scene.contacts.back().name, 0.3}};
    }
    subjects.generation = generate(subjects.robot, subjects.scene);
    expect_right(subjects, 20);
  }
}

// The points of tasks stand behind those of constraints there, by priority.
TEST(CheckInputs, ConstraintsAndTools) {
  Subjects subjects = load("humanoid24", "scene_stand.yaml");
  ScenePoint head = subjects.scene.operational_points.front();
  head.name = "head";
  head.link = "head";
  head.axes = Axes::local;
  subjects.scene.operational_points.front().priority = 2;
  subjects.scene.operational_points.push_back(head);
  subjects.scene.inputs.gravity = true;
  subjects.scene.inputs.payloads = {{"left_hand", 2, 0.3}};
  subjects.scene.inputs.parameters = {{"right_hand", 2, 0.3}};
  subjects.scene.inputs.tools = {{"left_hand", 0.3}, {"head", 0.2, true}};
  subjects.generation = generate(subjects.robot, subjects.scene);
  expect_right(subjects, 20);
}

TEST(CheckInputs, FloatingBase) {
  Subjects subjects = load("tumbler");
  subjects.scene.inputs.gravity = true;
  for (const Link& link : subjects.robot.links) {
    subjects.scene.inputs.payloads.push_back({link.name, 2, 0.3});
    if (link.inertial) subjects.scene.inputs.parameters.push_back({link.name, 5, 0.4});
  }
  subjects.scene.functions = {Function::inverse_dynamics, Function::mass_matrix,
                              Function::center_of_mass};
  subjects.generation = generate(subjects.robot, subjects.scene);
  expect_right(subjects, 40);
}

// Without and with rotors and friction among them.
TEST(CheckInputs, BaseParameters) {
  for (const bool drives : {false, true}) {
    Subjects subjects = load("puma560");
    subjects.scene.inputs.base_parameters = true;
    subjects.scene.inputs.gravity = drives;
    SceneRegressor& asked = subjects.scene.regressor;
    asked.rotors = asked.friction = asked.coulomb = drives;
    subjects.generation = generate(subjects.robot, subjects.scene);
    expect_right(subjects, 40);
  }
}

TEST(CheckInputs, BaseParametersOfAFloatingBase) {
  Subjects subjects = load("tumbler");
  subjects.scene.inputs.base_parameters = true;
  subjects.scene.functions = {Function::inverse_dynamics, Function::forward_dynamics,
                              Function::center_of_mass};
  subjects.generation = generate(subjects.robot, subjects.scene);
  expect_right(subjects, 40);
}

/// Costs by function and argument, as the manifest has them.
nlohmann::json costs_in(const Generation& generation) {
  nlohmann::json costs;
  for (const GeneratedFile& file : generation.files) {
    if (file.name != "manifest.json") continue;
    const auto manifest = nlohmann::json::parse(file.text);
    for (const auto& function : manifest.at("functions")) {
      costs[std::string(function.at("name"))] = function.value("input_flops", nlohmann::json{});
    }
  }
  return costs;
}

int flops_of(const Generation& generation, Function function) {
  for (const GeneratedFunction& each : generation.functions) {
    if (each.function == function) return each.chosen.count.flops();
  }
  return 0;
}

TEST(CheckInputs, ManifestStatesWhatTheyCost) {
  Subjects subjects = load("puma560");
  subjects.scene.functions = {Function::jacobian, Function::inverse_dynamics,
                              Function::mass_matrix};
  const Generation before = generate(subjects.robot, subjects.scene);
  EXPECT_TRUE(costs_in(before)["mass_matrix"].is_null());
  subjects.scene.inputs.payloads = {{"link6", 3, 0.3}};
  const Generation payload = generate(subjects.robot, subjects.scene);
  for (const Function function : {Function::inverse_dynamics, Function::mass_matrix}) {
    const int more = flops_of(payload, function) - flops_of(before, function);
    EXPECT_GT(more, 0);
    EXPECT_EQ(costs_in(payload)[function_name(function)]["payload"], more);
  }
  // What does not depend on it stays as it was.
  EXPECT_TRUE(costs_in(payload)["jacobian"].is_null());
  for (const GeneratedFile& file : before.files) {
    if (file.name != "jacobian.cpp") continue;
    const auto same = std::find_if(payload.files.begin(), payload.files.end(),
                                   [&](const auto& other) { return other.name == file.name; });
    EXPECT_EQ(file.text, same->text);
  }
}

std::string text_of(const Generation& generation, const std::string& name) {
  for (const GeneratedFile& file : generation.files) {
    if (file.name == name) return file.text;
  }
  return {};
}

// What the scene says of a tool, for those who want it unchanged: half a turn about y.
TEST(CheckInputs, ContractTellsTheScenesOrientation) {
  Subjects subjects = load("puma560");
  subjects.scene.functions = {Function::forward_kinematics};
  subjects.scene.operational_points.front().origin.rpy = {0, 3.141592653589793, 0};
  subjects.scene.inputs.tools = {{"tool", 0.5, true}};
  const std::string header = text_of(generate(subjects.robot, subjects.scene), "puma560.hpp");
  EXPECT_NE(header.find("tool_orientation 0..3: of point tool, in the scene {0.0, 1.0, 0.0, 0.0}"),
            std::string::npos)
      << header;
}

// Rows in the world's axes do not depend on those of the tool.
TEST(CheckInputs, OrientationCountsWhereItMatters) {
  Subjects subjects = load("puma560");
  subjects.scene.functions = {Function::forward_kinematics, Function::jacobian};
  subjects.scene.inputs.tools = {{"tool", 0.5}};
  const Generation origin = generate(subjects.robot, subjects.scene);
  subjects.scene.inputs.tools = {{"tool", 0.5, true}};
  const Generation both = generate(subjects.robot, subjects.scene);
  EXPECT_FALSE(text_of(origin, "jacobian.cpp").empty());
  EXPECT_EQ(text_of(both, "jacobian.cpp"), text_of(origin, "jacobian.cpp"));
  EXPECT_NE(text_of(both, "forward_kinematics.cpp"), text_of(origin, "forward_kinematics.cpp"));
  const nlohmann::json costs = costs_in(both);
  EXPECT_FALSE(costs["jacobian"].contains("tool_orientation"));
  EXPECT_EQ(costs["forward_kinematics"]["tool_orientation"],
            flops_of(both, Function::forward_kinematics) -
                flops_of(origin, Function::forward_kinematics));
}

}  // namespace
}  // namespace treeline::tests
