// Base parameters as arguments, on random robots whose links get other inertias. Would catch: a
// function that takes them in another order or scale than they are listed; a parameter that still
// counts as in the files, or counts twice; a function that depends on more than them; rotors and
// friction that are not replaced. The oracle is the interpreter on the robot as changed files
// describe it, and the regressor times the parameters.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "description/robot_queries.hpp"
#include "mechanism/build_mechanism.hpp"
#include "program/evaluate.hpp"
#include "recursion/checked_programs.hpp"
#include "recursion/function_results.hpp"
#include "recursion/methods/inverse_dynamics_regressor.hpp"
#include "recursion/parameters/base_parameters.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/seeded.hpp"
#include "recursion/template_results.hpp"

namespace treeline::tests {
namespace {

namespace ip = interpreter;
using Digits = std::vector<Digits50>;

std::vector<Seeded> robots() {
  std::vector<Seeded> all;
  const auto add = [&](RandomOptions options, int seeds) {
    for (int i = 0; i < seeds; ++i) all.push_back({7300 + all.size(), options});
  };
  add({.joints = 2, .branching = 0, .mix = {1, 0, 0, 0, 0, 0}, .aligned = 1}, 3);
  add({.joints = 6, .branching = 0, .mix = {1, 0, 0, 0, 0, 0}, .rotors = 0.5}, 4);
  add({.joints = 7, .branching = 0.4, .locked = 0.2, .rotors = 0.5, .operational_points = 2}, 5);
  add({.joints = 6, .branching = 0.4, .floating_base = true}, 4);
  add({.joints = 6, .branching = 0.4, .mimic = 0.4, .massless = 0.5}, 4);
  add({.joints = 4, .branching = 0.3, .mix = {2, 0, 1, 1, 0.5, 0.5, 4}, .rotors = 0.5}, 4);
  add({.joints = 7, .branching = 0.4, .mimic = 0.7, .rotors = 0.5, .varied_mimics = true}, 8);
  return all;
}

/// A robot whose base parameters are arguments, and the same with other inertias and, of half of
/// the robots, other rotors and friction, which then are parameters too.
struct Changed {
  Robot robot, files_robot;
  Scene scene, files_scene;
};

Changed change(const Seeded& seeded) {
  const RandomMechanism made = random_mechanism(seeded.seed, seeded.options);
  Changed changed{made.robot, made.robot, made.scene, made.scene};
  Rng rng(seeded.seed + 5);
  for (Link& link : changed.files_robot.links) {
    if (link.inertial) link.inertial = detail::random_inertial(rng, 0.3);
  }
  changed.scene.inputs.base_parameters = true;
  SceneRegressor& asked = changed.scene.regressor;
  asked.rotors = asked.friction = asked.coulomb = seeded.seed % 2 == 0;
  asked.width = 0.3;
  if (!asked.rotors) return changed;
  changed.files_scene.armature.clear();
  for (const Joint& joint : made.robot.joints) {
    const bool has_column =
        info_of(joint.type).has_one_freedom() && !made.scene.locked.contains(joint.name);
    if (!has_column) continue;
    changed.files_scene.armature[joint.name] = rng.rounded(0.1, 1);
    changed.files_scene.joint_friction[joint.name] = {rng.rounded(0.1, 1), rng.rounded(0.1, 1),
                                                      0.3};
  }
  return changed;
}

class BaseParameterArguments : public testing::TestWithParam<Seeded> {
 protected:
  BaseParameterArguments()
      : changed_(change(GetParam())),
        mechanism_(reduced_mechanism(changed_.robot, changed_.scene)),
        found_(base_parameters_of(mechanism_)),
        oracle_(changed_.files_robot, changed_.files_scene) {
    const Mechanism files = build_mechanism(changed_.files_robot, changed_.files_scene);
    for (const BaseParameter& base : found_->base) {
      values_.push_back(value_in_files(base, *found_, files));
    }
    Rng rng(GetParam().seed + 9);
    in_ = oracle_.random_inputs(rng);
    size_ = yardstick(oracle_, in_);
  }

  [[nodiscard]] std::vector<Function> functions() const {
    std::vector<Function> wanted(kDefaultFunctions.begin(), kDefaultFunctions.end());
    wanted.push_back(Function::coriolis_matrix);
    wanted.push_back(Function::kinetic_energy);
    std::erase_if(wanted, [&](Function f) { return !permits(f, oracle_.has_points(), size_); });
    return wanted;
  }
  [[nodiscard]] ModelInputs<Digits50> model() const {
    ModelInputs<Digits50> inputs;
    realize_base_parameters(*found_, values_, inputs);
    return inputs;
  }
  [[nodiscard]] Digits argument(const std::string& name) const {
    return name == "q"                        ? in_.q
           : name == "qd"                     ? in_.qd
           : name == "qdd" || name == "qdd_0" ? in_.qdd
           : name == "tau"                    ? in_.tau
           : name == "xdd_cmd"                ? in_.xdd_cmd
           : name == "base_parameters"        ? values_
                                              : in_.f_ext;
  }
  [[nodiscard]] static ip::Vector<Digits50> vector(const Digits& values) {
    return Eigen::Map<const ip::Vector<Digits50>>(values.data(),
                                                  static_cast<Eigen::Index>(values.size()));
  }

  Changed changed_;
  Mechanism mechanism_;
  std::shared_ptr<const BaseParameters> found_;
  Oracle<Digits50> oracle_;
  Digits values_;
  Inputs<Digits50> in_;
  Yardstick size_;
};

INSTANTIATE_TEST_SUITE_P(Robots, BaseParameterArguments, testing::ValuesIn(robots()));

/// Robots that have a floating base.
std::vector<Seeded> floating_robots() {
  std::vector<Seeded> floating = robots();
  std::erase_if(floating,
                [](const Seeded& seeded) { return change(seeded).scene.base != Base::floating; });
  return floating;
}

class FloatingBaseParameterArguments : public BaseParameterArguments {};
INSTANTIATE_TEST_SUITE_P(Robots, FloatingBaseParameterArguments,
                         testing::ValuesIn(floating_robots()));

// Only a formula can be wrong: constants are not rounded.
TEST_P(BaseParameterArguments, AreWhatFilesWouldSay) {
  const TemplateRun<Digits50> run(mechanism_, in_, model());
  for (const Function function : functions()) {
    const Results<Digits50> expected = oracle_.results(function, in_);
    for (const auto& [route, results] : run.results(function)) {
      const double error = relative_error(results, expected, size_.least_scale(function));
      EXPECT_LT(error, 1e-30 * size_.growth(function)) << function_name(function) << " " << route;
    }
  }
}

// On a floating base M has the whole mass and its centre.
TEST_P(FloatingBaseParameterArguments, HaveTheCenterOfMass) {
  const TemplateRun<Digits50> run(mechanism_, in_, model());
  const auto center = run.center();
  const auto expected = ip::center_of_mass<Digits50>(oracle_.model(), vector(in_.q));
  EXPECT_LT(relative_error(Results<Digits50>{{center.x, center.y, center.z}},
                           Results<Digits50>{listed(expected)}, 1),
            1e-30);
  const auto energy = run.results(Function::potential_energy).front().results;
  EXPECT_LT(relative_error(energy, oracle_.results(Function::potential_energy, in_), 1), 1e-30);
}

// What the files say is what they say without arguments.
TEST_P(BaseParameterArguments, DefaultToTheFiles) {
  const Oracle<Digits50> oracle(changed_.robot, changed_.scene);
  const TemplateRun<Digits50> run(mechanism_, in_);
  for (const Function function : {Function::inverse_dynamics, Function::mass_matrix}) {
    const Results<Digits50> expected = oracle.results(function, in_);
    for (const auto& [route, results] : run.results(function)) {
      EXPECT_LT(relative_error(results, expected, size_.least_scale(function)), 1e-40)
          << function_name(function) << " " << route;
    }
  }
}

// The columns of the regressor are those of the argument.
TEST_P(BaseParameterArguments, TimesTheRegressorAreInverseDynamics) {
  Scene scene = changed_.scene;
  scene.regressor.base = true;
  const Mechanism mechanism = mechanism_in_frames_of_files(changed_.robot, scene);
  const auto columns = regressor_columns(mechanism);
  ASSERT_EQ(columns.size(), values_.size());
  const auto tree = tree_of<Digits50>(mechanism);
  const auto X = joint_transforms<Digits50>(tree, in_.q);
  const Digits Y =
      inverse_dynamics_regressor<Digits50>(tree, X, {in_.qd, in_.qdd}, columns).values();
  Digits product;
  for (std::size_t i = 0; i < in_.qd.size(); ++i) {
    Digits50 sum = 0;
    for (std::size_t k = 0; k < values_.size(); ++k) sum += Y[i * values_.size() + k] * values_[k];
    product.push_back(sum);
  }
  Inputs<Digits50> in = in_;
  in.f_ext.clear();
  const TemplateRun<Digits50> run(mechanism_, in, model());
  const bool rotors_without_column =
      !changed_.scene.regressor.rotors && !changed_.files_scene.armature.empty();
  if (rotors_without_column) return;  // they are no part of the product
  EXPECT_LT(relative_error(run.results(Function::inverse_dynamics).front().results,
                           Results<Digits50>{product}, 1),
            1e-30);
}

// Traces declare the argument and use it. Their constants are rounded to double.
TEST_P(BaseParameterArguments, AreArgumentsOfTraces) {
  for (const Function function : functions()) {
    const Results<Digits50> expected = oracle_.results(function, in_);
    for (const Program& program : trace_function(mechanism_, function)) {
      std::vector<Digits> arguments;
      bool taken = false;
      for (const Argument& each : program.arguments) {
        arguments.push_back(argument(each.name));
        EXPECT_EQ(static_cast<int>(arguments.back().size()), each.rows) << each.name;
        taken = taken || each.name == "base_parameters";
      }
      EXPECT_EQ(taken, takes(function, Quantity::base_parameters)) << function_name(function);
      const double error = relative_error(evaluate<Digits50>(program, arguments), expected,
                                          size_.least_scale(function));
      EXPECT_LT(error, kUlpBound * 0x1p-52 * size_.growth(function))
          << function_name(function) << " by " << describe(program.route);
    }
  }
}

}  // namespace
}  // namespace treeline::tests
