#include <gtest/gtest.h>

#include "interpreter/instances.hpp"
#include "recursion/checked_programs.hpp"
#include "recursion/template_results.hpp"

// The centre of mass as a point of a task, beside points on links, for random robots. Would catch:
// forces that spread over links by other shares than their masses, or reach a joint twice where
// branches or followers meet; matter at rest that is forgotten or accelerates; rows in the axes of
// a link; and a route that is offered though it knows points on links alone.

namespace treeline::tests {
namespace {

using interpreter::Digits50;
using Vector50 = interpreter::Vector<Digits50>;

constexpr std::array kFunctionsOfTasks{
    Function::forward_kinematics, Function::jacobian, Function::bias_acceleration,
    Function::lambda_inverse,     Function::lambda,   Function::control_torque};

/// Robots of every kind in turn: fixed and floating, with followers, rotors, locked joints and
/// joints of several axes, one to two points on links before or behind the centre of mass.
RandomMechanism robot_with_center(std::uint64_t seed) {
  RandomOptions options;
  options.joints = 4 + static_cast<int>(seed % 5);
  options.branching = seed % 3 == 0 ? 0.2 : 0.6;
  options.floating_base = seed % 2 == 0;
  options.mimic = seed % 5 == 1 ? 0.4 : 0;
  options.locked = 0.1;
  options.massless = 0.5;
  options.rotors = seed % 4 == 3 ? 0.5 : 0;
  if (seed % 7 == 6) options.mix.ball = 3;
  options.operational_points = 1 + static_cast<int>(seed % 2);
  options.all_rows = seed % 4 == 1;
  options.external_forces = static_cast<int>(seed % 2);
  RandomMechanism made = random_mechanism(seed, options);
  Rng rng(seed + 70);
  auto& points = made.scene.operational_points;
  const auto at = seed % 3 == 0 ? points.begin() : points.end();
  points.insert(at, random_center(rng));
  return made;
}

TEST(CenterOfMassTask, EveryRouteAgreesWithTheInterpreterInFiftyDigits) {
  std::map<Function, int> compared;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const RandomMechanism made = robot_with_center(seed);
    const Oracle<Digits50> oracle(made.robot, made.scene);
    if (oracle.model().nv == 0) continue;
    Rng rng(seed);
    const Inputs<Digits50> in = oracle.random_inputs(rng);
    const Yardstick size = yardstick(oracle, in);
    const TemplateRun<Digits50> run(reduced_mechanism(made.robot, made.scene), in);
    for (const Function function : kFunctionsOfTasks) {
      if (!permits(function, oracle.has_points(), size)) continue;
      const auto expected = oracle.results(function, in);
      for (const auto& [route, results] : run.results(function)) {
        const double error =
            relative_error(results, expected, size.least_scale(function)) / size.growth(function);
        EXPECT_LE(error, 1e-40) << function_name(function) << " " << route;
        ++compared[function];
      }
    }
  }
  for (const Function function : kFunctionsOfTasks) {
    EXPECT_GE(compared[function], 15) << function_name(function);
  }
}

TEST(CenterOfMassTask, ProgramsAreRoundedAsOthersAre) {
  ErrorTable table;
  for (std::uint64_t seed = 41; seed <= 56; ++seed) {
    SCOPED_TRACE(seed);
    const RandomMechanism made = robot_with_center(seed);
    const CheckedPrograms programs(made.robot, made.scene);
    if (programs.oracle().model().nv == 0) continue;
    Rng rng(seed);
    programs.compare<double>(programs.oracle().random_inputs(rng), table);
  }
  table.print();
  table.expect_below(kUlpBound);
}

// Each priority's place is the interpreter's, whose recursion is over joint accelerations.
TEST(CenterOfMassTask, YieldsByPriorityAsTheInterpreterSays) {
  int compared = 0;
  for (std::uint64_t seed = 60; seed < 84; seed += 2) {
    SCOPED_TRACE(seed);
    RandomMechanism made = robot_with_center(seed);
    auto& points = made.scene.operational_points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i].priority = 1 + static_cast<int>((i + seed / 2) % points.size());
    }
    const Oracle<Digits50> oracle(made.robot, made.scene);
    Rng rng(seed);
    const Inputs<Digits50> in = oracle.random_inputs(rng);
    const Yardstick size = yardstick(oracle, in);
    const auto expected = oracle.results(Function::control_torque, in);
    const TemplateRun<Digits50> run(reduced_mechanism(made.robot, made.scene), in);
    for (const auto& [route, results] : run.results(Function::control_torque)) {
      EXPECT_LE(relative_error(results, expected, size.force), 1e-30 * size.condition_M) << route;
      ++compared;
    }
  }
  EXPECT_GE(compared, 12);
}

// A law of mechanics that neither formulation of the task uses: the weight acts at the centre of
// mass, g = -J^T m gravity.
TEST(CenterOfMassTask, JacobianTurnsTheWeightIntoTheForcesOfGravity) {
  for (std::uint64_t seed = 90; seed < 110; ++seed) {
    SCOPED_TRACE(seed);
    RandomMechanism made = robot_with_center(seed);
    made.scene.operational_points.front() = ScenePoint{
        .name = "center", .rows = {true, true, true, false, false, false}, .center_of_mass = true};
    made.scene.operational_points.resize(1);
    const Oracle<Digits50> oracle(made.robot, made.scene);
    const auto& model = oracle.model();
    if (model.nv == 0) continue;
    Rng rng(seed);
    const Inputs<Digits50> in = oracle.random_inputs(rng);
    const TemplateRun<Digits50> run(reduced_mechanism(made.robot, made.scene), in);
    const auto of_joints = oracle.results(Function::gravity, in).front();
    for (const auto& [route, results] : run.results(Function::jacobian)) {
      const auto nv = static_cast<std::size_t>(model.nv);
      for (std::size_t v = 0; v < nv; ++v) {
        Digits50 force = of_joints[v];
        for (std::size_t i = 0; i < 3; ++i) {
          force += results.front()[i * nv + v] * interpreter::total_mass(model) *
                   model.gravity(static_cast<Eigen::Index>(i));
        }
        EXPECT_LT(static_cast<double>(Digits50(abs(force))), 1e-40) << route;
      }
    }
  }
}

TEST(CenterOfMassTask, IsAskedOnlyOfRoutesThatKnowIt) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const RandomMechanism made = robot_with_center(seed);
    const auto tree = constant_tree<double>(reduced_mechanism(made.robot, made.scene));
    for (const auto& choices : {lambda_choices(tree), control_choices(tree)}) {
      EXPECT_FALSE(choices.empty());
      for (const LambdaChoice& choice : choices) {
        EXPECT_TRUE(choice.route == LambdaRoute::unit_forces ||
                    choice.route == LambdaRoute::factors_inward);
        EXPECT_FALSE(choice.basis.in_link_axes || choice.basis.at_link_origin);
        EXPECT_EQ(choice.basis.axes_link, -1);
      }
    }
  }
}

}  // namespace
}  // namespace treeline::tests
