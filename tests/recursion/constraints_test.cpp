#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <set>

#include "interpreter/supported_cases.hpp"
#include "mechanism/build_mechanism.hpp"
#include "program/evaluate.hpp"
#include "recursion/least_flops.hpp"
#include "recursion/methods/supported_control_torque.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/trace_function.hpp"
#include "recursion/tree/supported_mechanism.hpp"

// The functions about constraints and passive joints, every route, for random robots, compared with
// the interpreter's KKT systems in 50 digits. Would catch: a wrong formula, sign, axes or order of
// rows, a law that relaxes what robots can do, and forces that grow where constraints are
// redundant.

namespace treeline::tests {
namespace {

std::vector<Digits50> list(const Vector50& x) {
  return listed(x);
}

std::vector<Digits50> applied_at(const StandingCase& c) {
  return list(c.task.f_ext);
}

interpreter::ConstrainedState<Digits50> stabilised(const StandingCase& c) {
  return {c.q, c.qd, c.tau, c.drift, 20, 100, c.task.external_points, c.task.f_ext, c.task.loops};
}

Results<Digits50> expected_motion(const StandingCase& c) {
  const auto motion = interpreter::constrained_forward_dynamics<Digits50>(
      c.model, c.task.constraints, stabilised(c));
  return {listed(motion.qdd), listed(motion.f)};
}

Results<Digits50> expected_torque(const StandingCase& c) {
  const auto torque = interpreter::supported_control_torque<Digits50>(c.model, c.task, c.q, c.qd);
  Results<Digits50> results{listed(torque.tau)};
  if (torque.f.size() > 0) results.push_back(listed(torque.f));
  return results;
}

class Constraints : public testing::TestWithParam<std::tuple<Standing, int>> {
 protected:
  Constraints()
      : c_(draw_standing_regular(1 + 41 * static_cast<std::uint64_t>(std::get<1>(GetParam())),
                                 std::get<0>(GetParam()))) {}
  [[nodiscard]] bool holds() const {
    return !c_.task.constraints.empty() || !c_.task.loops.empty();
  }

  StandingCase c_;
};

INSTANTIATE_TEST_SUITE_P(Random, Constraints,
                         testing::Combine(testing::ValuesIn(standings_and_loops()),
                                          testing::Range(0, 2)),
                         [](const auto& tested) {
                           return std::string(std::get<0>(tested.param).name) + "_" +
                                  std::to_string(std::get<1>(tested.param));
                         });

// In 50 digits with unrounded constants only the formulas can differ.
TEST_P(Constraints, MotionsAgreeInFiftyDigits) {
  if (!holds()) return;
  const Mechanism seen = with_constraints_only(reduced_mechanism(c_.made.robot, c_.made.scene));
  const auto tree = tree_of<Digits50>(seen);
  const auto q = list(c_.q), qd = list(c_.qd), tau = list(c_.tau), drift = list(c_.drift);
  const std::vector<Digits50> gains{20, 100};
  const auto X = joint_transforms<Digits50>(tree, q);
  const auto f_ext = applied_at(c_);
  const auto applied = applied_wrenches<Digits50>(tree, X, f_ext);
  const auto factor = factor_ltdl(mass_matrix(tree, X));
  const auto expected = expected_motion(c_);
  const ConstrainedInputs<Digits50> inputs{q, qd, tau, gains, drift, applied};
  const auto choices = has_loops(tree) ? std::vector<LambdaChoice>(1) : lambda_choices(tree);
  for (const LambdaChoice& choice : choices) {
    const auto motion =
        has_loops(tree) ? looped_forward_dynamics<Digits50>(tree, X, inputs, {})
                        : constrained_forward_dynamics<Digits50>(
                              tree, X, inputs, choice, [&](const std::vector<Digits50>& forces) {
                                return solve(factor, forces);
                              });
    EXPECT_LE(relative_error<Digits50>({motion.qdd, motion.f}, expected, 1) / c_.growth, 1e-38);
  }
}

// Laws relax rows by less than (2^-17)^6 of their share in an ordinary state.
TEST_P(Constraints, TorquesAgreeBeyondTheLaws) {
  const Mechanism mechanism = reduced_mechanism(c_.made.robot, c_.made.scene);
  EXPECT_EQ(mechanism.passive, c_.task.passive);
  const Mechanism seen = with_supports(mechanism);
  const SupportRules rules = split_rules(*TaskLaws(seen).supported());
  const auto tree = tree_of<Digits50>(seen);
  const auto q = list(c_.q), qd = list(c_.qd), qdd_0 = list(c_.task.qdd_0),
             wanted = list(c_.task.f_wanted);
  std::vector<Digits50> xdd;
  for (const std::size_t row : task_row_order(mechanism)) {
    xdd.push_back(c_.task.xdd_cmd(static_cast<Eigen::Index>(row)));
  }
  const auto X = joint_transforms<Digits50>(tree, q);
  const auto f_ext = applied_at(c_);
  const auto applied = applied_wrenches<Digits50>(tree, X, f_ext);
  const auto expected = expected_torque(c_);
  const auto choices = has_loops(tree) ? std::vector<LambdaChoice>(1) : lambda_choices(tree);
  for (const LambdaChoice& choice : choices) {
    const auto torque = supported_control_torque<Digits50>(
        tree, X, {{qd, qdd_0}, xdd, wanted, applied}, mechanism.passive, choice, rules);
    Results<Digits50> results{torque.tau};
    if (!torque.f.empty()) results.push_back(torque.f);
    EXPECT_LE(relative_error(results, expected, 1) / c_.growth, 1e-16);
  }
}

/// The case with numbers that double has.
StandingCase rounded_case(const StandingCase& c) {
  StandingCase rounded = c;
  for (Vector50* x : {&rounded.q, &rounded.qd, &rounded.tau, &rounded.drift, &rounded.task.qdd_0,
                      &rounded.task.xdd_cmd, &rounded.task.f_wanted, &rounded.task.f_ext}) {
    *x = x->unaryExpr([](const Digits50& value) { return Digits50(static_cast<double>(value)); });
  }
  return rounded;
}

std::vector<std::vector<double>> arguments(const Program& program, const StandingCase& c) {
  std::vector<std::vector<double>> values;
  for (const Argument& argument : program.arguments) {
    const std::string& name = argument.name;
    const Vector50 gains = (Vector50(2) << 20, 100).finished();
    const Vector50& x = name == "q"          ? c.q
                        : name == "qd"       ? c.qd
                        : name == "qdd_0"    ? c.task.qdd_0
                        : name == "tau"      ? c.tau
                        : name == "xdd_cmd"  ? c.task.xdd_cmd
                        : name == "f_wanted" ? c.task.f_wanted
                        : name == "drift"    ? c.drift
                        : name == "f_ext"    ? c.task.f_ext
                                             : gains;
    values.push_back(rounded_to<double>(listed(x)));
    EXPECT_EQ(static_cast<int>(values.back().size()), argument.rows) << name;
  }
  return values;
}

// Every route as it is emitted, in double.
TEST_P(Constraints, ProgramsAgreeInDouble) {
  const StandingCase c = rounded_case(c_);
  const Mechanism mechanism = reduced_mechanism(c.made.robot, c.made.scene);
  for (const Function function :
       {Function::constrained_forward_dynamics, Function::supported_control_torque}) {
    const bool moves = function == Function::constrained_forward_dynamics;
    if (moves && !holds()) continue;
    const auto expected = moves ? expected_motion(c) : expected_torque(c);
    double worst = 0;
    std::set<std::string> names;
    for (const Program& program : trace_function(mechanism, function)) {
      const auto results = evaluate<double>(program, arguments(program, c));
      // 64 ulp of the result's scale, times the condition number of the solves.
      const double error = relative_error(results, expected, 1) * 0x1p52 / c.growth;
      EXPECT_LE(error, 64) << program.name << " " << describe(program.route);
      worst = std::max(worst, error);
      EXPECT_TRUE(names.insert(describe(program.route)).second) << describe(program.route);
    }
    std::cout << function_name(function) << ": " << names.size() << " routes, worst " << worst
              << " ulp over the condition " << c.growth << '\n';
  }
}

// With as many rows as a control torque that controls feet and hands together, the support costs
// the choice of forces: J_sp^T W J_sp (6 x 6, symmetric, a multiplication by the weight and two
// operations per entry and row), its factor, three products with J_sp, and the joint forces of the
// rows a second time, some 40 operations per link.
TEST(ConstraintCounts, ASupportAddsTheChoiceOfItsForces) {
  const Standing& two_feet = standings()[1];
  const StandingCase c = draw_standing_regular(3, two_feet);
  RandomMechanism together = c.made;
  Scene& scene = together.scene;
  scene.operational_points.insert(scene.operational_points.begin(), scene.constraints.begin(),
                                  scene.constraints.end());
  for (ScenePoint& point : scene.operational_points) point.priority = 1;
  scene.constraints.clear();
  const int with = least_flops(c.made, Function::supported_control_torque);
  const int without = least_flops(together, Function::control_torque);
  std::cout << "control_torque of the same rows " << without << ", supported_control_torque "
            << with << " flops\n";
  const int rows = 12, links = static_cast<int>(c.made.robot.links.size());
  EXPECT_LT(with - without, rows * (3 * 21 + 3 * 12) + 150 + 40 * links + without / 5);
}

}  // namespace
}  // namespace treeline::tests
