#include <gtest/gtest.h>

#include "recursion/checked_programs.hpp"
#include "recursion/read_robots.hpp"

// Every route of every function for real robots: those of the project compared with the
// interpreter, and seven compared with figures that another library computed in long double. Would
// catch: errors in cases that random robots do not have, such as large humanoid trees, spherical
// wrists, and singular poses at q = 0.

namespace treeline::tests {
namespace {

TEST(ProjectRobots, AgreeWithTheInterpreter) {
  const std::vector<RobotInScene> robots = read_robots();
  ASSERT_GE(robots.size(), 4U);
  for (const auto& [name, robot, scene] : robots) {
    SCOPED_TRACE(name);
    ErrorTable table;
    Rng rng(1);
    const CheckedPrograms programs(robot, scene);
    programs.compare<double>(programs.oracle().random_inputs(rng), table);
    programs.compare<double>(programs.oracle().random_inputs(rng, 100), table);
    programs.compare<double>(programs.oracle().random_inputs(rng, 1e-3), table);
    table.expect_below(kUlpBound);
    std::cout << name << '\n';
    table.print();
  }
}

/// A column or a matrix of figures in the form of a program's result.
std::vector<double> values(const DoubleMatrix& A) {
  std::vector<double> result;
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) result.push_back(A(i, j));
  }
  return result;
}

/// Rows of all points, stacked.
template <class Member>
std::vector<double> stacked(const GoldenState& state, Member member) {
  std::vector<double> result;
  for (const GoldenPoint& point : state.points) {
    const std::vector<double> rows = values(point.*member);
    result.insert(result.end(), rows.begin(), rows.end());
  }
  return result;
}

/// The golden figures for a function; empty if there are none.
Results<double> golden_results(const GoldenState& s, Function function) {
  switch (function) {
    case Function::forward_kinematics:
      return {stacked(s, &GoldenPoint::position), stacked(s, &GoldenPoint::rotation)};
    case Function::jacobian:
      return {stacked(s, &GoldenPoint::J_world)};
    case Function::bias_acceleration:
      return {stacked(s, &GoldenPoint::bias_world)};
    case Function::inverse_dynamics:
      return {values(s.rnea)};
    case Function::gravity:
      return {values(s.gravity)};
    case Function::nonlinear_effects:
      return {values(s.nonlinear_effects)};
    case Function::mass_matrix:
      return {values(s.M)};
    case Function::forward_dynamics:
      return {values(s.aba)};
    case Function::lambda_inverse:
      return {values(s.Lambda_inverse_world)};
    case Function::lambda:
      return s.Lambda_world.size() == 0 ? Results<double>{}
                                        : Results<double>{values(s.Lambda_world)};
    case Function::control_torque:
      return s.control_torque.size() == 0 ? Results<double>{}
                                          : Results<double>{values(s.control_torque)};
    default:
      break;
  }
  return {};
}

Inputs<double> inputs_of(const GoldenState& s) {
  return {values(s.q), values(s.qd), values(s.qdd), values(s.tau), values(s.xdd), {}};
}

class Golden : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Robots, Golden,
                         testing::Values("puma560", "samm", "humanoid24", "ur5", "panda", "anymal",
                                         "solo12"),
                         [](const auto& tested) { return std::string(tested.param); });

TEST_P(Golden, FiguresAreReached) {
  const GoldenRobot golden = read_golden(GetParam());
  const CheckedPrograms programs(golden.robot, golden.scene);
  ErrorTable table;
  for (const GoldenState& state : golden.states) {
    const Inputs<double> in = inputs_of(state);
    Yardstick size{state.M.cwiseAbs().maxCoeff(), condition(state.M),
                   condition(state.Lambda_inverse_world)};
    for (const auto& [function, routes] : programs.programs()) {
      const Results<double> expected = golden_results(state, function);
      if (expected.empty() || !permits(function, true, size)) continue;
      for (const Program& program : routes) {
        const auto results = evaluate<double>(program, CheckedPrograms::arguments(program, in));
        const double error = relative_error(results, expected, size.least_scale(function));
        table.note(function, describe(program.route), error * 0x1p52, size.growth(function));
      }
    }
  }
  table.expect_below(1e-12 * 0x1p52);
  table.print();
}

}  // namespace
}  // namespace treeline::tests
