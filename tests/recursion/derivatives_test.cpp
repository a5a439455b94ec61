#include <gtest/gtest.h>

#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/central_differences.hpp"
#include "recursion/function_results.hpp"
#include "recursion/methods/forward_dynamics_derivatives.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/seeded.hpp"

// Derivatives of inverse and forward dynamics, compared with central differences of the interpreter
// in 50 digits for the robot as written in the files. Would catch: a wrong term of the recursion
// for any joint type, a displacement of a floating joint in the wrong axes or about the wrong
// point, an external force that keeps its direction in the wrong axes, a mimic joint without its
// multiplier, and an entry in the other triangle. The interpreter's own derivatives, which `check`
// uses, are compared with the same differences.

namespace treeline::tests {
namespace {

using interpreter::DynamicsDerivatives;

std::vector<Seeded> derivatives_robots() {
  std::vector<Seeded> all;
  const auto add = [&](RandomOptions options, int seeds, int forces = 2) {
    options.external_forces = forces;
    for (int i = 0; i < seeds; ++i) all.push_back({700 + all.size(), options});
  };
  add({.joints = 1}, 3);
  add({.joints = 8, .branching = 0}, 3);
  add({.joints = 8, .branching = 0.4, .locked = 0.2}, 4);
  add({.joints = 6, .branching = 0.4, .floating_base = true}, 3);
  add({.joints = 8, .branching = 0.4, .mimic = 0.4, .locked = 0.1}, 5);
  add({.joints = 6, .branching = 0.3, .mimic = 0.2, .rotors = 0.7, .drives = 0.6}, 3);
  add({.joints = 5, .branching = 0.2, .mix = {5, 1, 2, 1, 2, 2}}, 5);
  add({.joints = 5, .branching = 0.2, .mix = {2, 1, 2, 1, 1, 1, 5}}, 5);
  add({.joints = 4, .branching = 0.3, .mix = {2, 1, 1, 1, 0, 0, 5}, .floating_base = true}, 3);
  // In one common frame, where nothing acts at points.
  add({.joints = 1}, 1, 0);
  add({.joints = 9, .branching = 0}, 2, 0);
  add({.joints = 12, .branching = 0.5}, 3, 0);
  add({.joints = 11, .branching = 0.4, .floating_base = true}, 4, 0);
  add({.joints = 8, .branching = 0.3, .rotors = 0.7, .drives = 0.6}, 3, 0);
  return all;
}

class Derivatives : public testing::TestWithParam<Seeded> {
 protected:
  Derivatives()
      : made_(random_mechanism(GetParam().seed, GetParam().options)),
        mechanism_(reduced_mechanism(made_.robot, made_.scene)),
        model_(model_from_robot<Digits50>(made_.robot, made_.scene)),
        forces_(points_from_scene(model_, made_.scene.external_forces)) {
    Rng rng(GetParam().seed + 7);
    const Oracle<Digits50> oracle(made_.robot, made_.scene);
    in_ = oracle.random_inputs(rng, 2);
    q_ = vector(in_.q), qd_ = vector(in_.qd), qdd_ = vector(in_.qdd);
    tau_ = vector(in_.tau), f_ = vector(in_.f_ext);
  }

  static Vector50 vector(const std::vector<Digits50>& values) {
    return Eigen::Map<const Vector50>(values.data(), static_cast<Eigen::Index>(values.size()));
  }

  [[nodiscard]] DynamicsDerivatives<Digits50> of_inverse() const {
    const auto tau = [&](const Vector50& q, const Vector50& qd, const Vector50& qdd) {
      return interpreter::inverse_dynamics<Digits50>(model_, q, qd, qdd, forces_, f_);
    };
    return {
        differences(model_.nv, [&](auto d) { return tau(displaced(model_, q_, d), qd_, qdd_); }),
        differences(model_.nv, [&](auto d) { return tau(q_, Vector50(qd_ + d), qdd_); }),
        differences(model_.nv, [&](auto d) { return tau(q_, qd_, Vector50(qdd_ + d)); })};
  }

  [[nodiscard]] DynamicsDerivatives<Digits50> of_forward() const {
    const auto qdd = [&](const Vector50& q, const Vector50& qd, const Vector50& tau) {
      return interpreter::forward_dynamics<Digits50>(model_, q, qd, tau, forces_, f_);
    };
    return {
        differences(model_.nv, [&](auto d) { return qdd(displaced(model_, q_, d), qd_, tau_); }),
        differences(model_.nv, [&](auto d) { return qdd(q_, Vector50(qd_ + d), tau_); }),
        differences(model_.nv, [&](auto d) { return qdd(q_, qd_, Vector50(tau_ + d)); })};
  }

  [[nodiscard]] DynamicsDerivatives<Digits50> expected(Function function) const {
    return function == Function::inverse_dynamics_derivatives ? of_inverse() : of_forward();
  }

  [[nodiscard]] double condition() const {
    return tests::condition(interpreter::mass_matrix<Digits50>(model_, q_));
  }

  static Results<Digits50> listed_all(const DynamicsDerivatives<Digits50>& d) {
    return {listed(d.by_displacement), listed(d.by_velocity), listed(d.by_drive)};
  }

  RandomMechanism made_;
  Mechanism mechanism_;
  interpreter::Model<Digits50> model_;
  interpreter::Points<Digits50> forces_;
  Inputs<Digits50> in_;
  Vector50 q_, qd_, qdd_, tau_, f_;
};

INSTANTIATE_TEST_SUITE_P(Robots, Derivatives, testing::ValuesIn(derivatives_robots()));

TEST_P(Derivatives, RecursionsAgreeWithDifferencesInFiftyDigits) {
  const auto tree = tree_of<Digits50>(mechanism_);
  const auto X = joint_transforms<Digits50>(tree, in_.q);
  const auto inverse =
      inverse_dynamics_derivatives<Digits50>(tree, X, {in_.qd, in_.qdd}, in_.f_ext);
  EXPECT_LT(
      relative_error<Digits50>({inverse.dq.values(), inverse.dqd.values(), inverse.dqdd.values()},
                               listed_all(of_inverse()), 1),
      kDifferenceBound);
  const auto exact = listed_all(of_forward());
  for (const auto route : {DerivativeRoute::solve, DerivativeRoute::multiply}) {
    const auto forward =
        forward_dynamics_derivatives<Digits50>(tree, X, in_.qd, in_.tau, in_.f_ext, route);
    EXPECT_LT(relative_error<Digits50>(
                  {forward.dq.values(), forward.dqd.values(), forward.dtau.values()}, exact, 1),
              kDifferenceBound * condition());
  }
}

TEST_P(Derivatives, InterpreterAgreesWithDifferencesInFiftyDigits) {
  EXPECT_LT(relative_error(listed_all(interpreter::inverse_dynamics_derivatives<Digits50>(
                               model_, q_, qd_, qdd_, forces_, f_)),
                           listed_all(of_inverse()), 1),
            kDifferenceBound);
  EXPECT_LT(relative_error(listed_all(interpreter::forward_dynamics_derivatives<Digits50>(
                               model_, q_, qd_, tau_, forces_, f_)),
                           listed_all(of_forward()), 1),
            kDifferenceBound * condition());
}

// The emitted operations before the passes: roundings of constants, inputs and operations, some n
// per result. Results of a solve are multiplied by M^-1 twice.
TEST_P(Derivatives, TracedFunctionsAgreeInDouble) {
  for (const Function function : kDerivativeFunctions) {
    const auto exact = listed_all(expected(function));
    const double growth =
        function == Function::forward_dynamics_derivatives ? condition() * condition() : 1;
    for (const Program& program : trace_function(mechanism_, function, 4)) {
      std::vector<std::vector<double>> arguments;
      for (const Argument& argument : program.arguments) {
        const auto& name = argument.name;
        arguments.push_back(rounded_to<double>(name == "q"     ? in_.q
                                               : name == "qd"  ? in_.qd
                                               : name == "qdd" ? in_.qdd
                                               : name == "tau" ? in_.tau
                                                               : in_.f_ext));
      }
      EXPECT_LT(relative_error(evaluate<double>(program, arguments), exact, 1), 1e-13 * growth)
          << describe(program.route);
    }
  }
}

// dtau/dqdd = M and dqdd/dtau = M^-1, both symmetric, without differences.
TEST_P(Derivatives, ByAccelerationsAndForcesAreInverse) {
  const auto tree = tree_of<Digits50>(mechanism_);
  const auto X = joint_transforms<Digits50>(tree, in_.q);
  const auto inverse =
      inverse_dynamics_derivatives<Digits50>(tree, X, {in_.qd, in_.qdd}, in_.f_ext);
  const auto forward = forward_dynamics_derivatives<Digits50>(tree, X, in_.qd, in_.tau, in_.f_ext,
                                                              DerivativeRoute::solve);
  const auto one = product(inverse.dqdd, forward.dtau);
  for (std::size_t i = 0; i < one.rows(); ++i) {
    for (std::size_t j = 0; j < one.cols(); ++j) {
      EXPECT_LT(abs(Digits50(one(i, j) - (i == j ? 1 : 0))), 1e-44 * condition());
      EXPECT_EQ(forward.dtau(i, j), forward.dtau(j, i));
      EXPECT_LT(abs(Digits50(inverse.dqdd(i, j) - inverse.dqdd(j, i))), 1e-44);
    }
  }
}

// Joints on different branches do not affect each other: their entries are the constant zero
// wherever those of M are.
TEST_P(Derivatives, BranchesAreStructuralZeros) {
  const Program M = trace_function(mechanism_, Function::mass_matrix).front();
  const Program d = trace_function(mechanism_, Function::inverse_dynamics_derivatives).front();
  const int nv = mechanism_.nv();
  std::vector<bool> related(static_cast<std::size_t>(nv * nv));
  for (std::size_t i = 0; i < mechanism_.links.size(); ++i) {
    for (int j = static_cast<int>(i); j >= 0;
         j = mechanism_.links[static_cast<std::size_t>(j)].parent) {
      const MovingLink& a = mechanism_.links[i];
      const MovingLink& b = mechanism_.links[static_cast<std::size_t>(j)];
      for (int k = 0; k < a.velocities(); ++k) {
        for (int l = 0; l < b.velocities(); ++l) {
          related[static_cast<std::size_t>((a.v_index + k) * nv + b.v_index + l)] = true;
          related[static_cast<std::size_t>((b.v_index + l) * nv + a.v_index + k)] = true;
        }
      }
    }
  }
  for (std::size_t at = 0; at < related.size(); ++at) {
    for (const Result& result : d.results) {
      EXPECT_TRUE(related[at] || result.values[at].is_zero()) << result.argument.name << at;
    }
    EXPECT_TRUE(related[at] || M.results[0].values[at].is_zero());
  }
}

}  // namespace
}  // namespace treeline::tests
