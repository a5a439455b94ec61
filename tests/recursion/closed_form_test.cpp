#include <gtest/gtest.h>

#include <cmath>

#include "mechanism/sample_robots.hpp"
#include "recursion/checked_programs.hpp"

// Robots whose equations fit on one line, from reading order through reductions, recursions and
// graph to numbers. Would catch: an error that the interpreter shares.

namespace treeline::tests {
namespace {

constexpr double kGravity = 9.81;

Inertial rod_inertial(double mass, double center, double izz) {
  Inertial inertial;
  inertial.mass = mass;
  inertial.origin.xyz = {center, 0, 0};
  inertial.ixx = inertial.iyy = inertial.izz = izz;
  return inertial;
}

std::vector<double> value(const Program& program, const Inputs<double>& in) {
  return evaluate<double>(program, CheckedPrograms::arguments(program, in)).front();
}

/// The result by one route.
std::vector<double> value(const Robot& robot, const Scene& scene, Function function,
                          const Inputs<double>& in, std::size_t route = 0) {
  const auto programs = trace_function(reduced_mechanism(robot, scene), function);
  return value(programs.at(route), in);
}

constexpr double kMass = 2.5, kCenter = 0.4, kInertia = 0.03;

/// Rotates about y. q = 0 is horizontal along x; positive q lowers the tip.
Robot pendulum() {
  Robot robot = sample_robot({{"swing", "base", JointType::revolute, {0, 1, 0}, {{0, 0, 1}, {}}}});
  robot.links[1].inertial = rod_inertial(kMass, kCenter, kInertia);
  return robot;
}

TEST(Pendulum, HasItsTextbookEquation) {
  const Robot robot = pendulum();
  const double M = kInertia + kMass * kCenter * kCenter;
  for (const double q : {0.0, 0.4, -2.0, 100.0}) {
    const double g = -kMass * kGravity * kCenter * std::cos(q);
    const Inputs<double> in{{q}, {3.0}, {-1.5}, {2.0}, {}, {}};
    EXPECT_NEAR(value(robot, {}, Function::mass_matrix, in)[0], M, 1e-15);
    EXPECT_NEAR(value(robot, {}, Function::gravity, in)[0], g, 1e-14);
    EXPECT_NEAR(value(robot, {}, Function::nonlinear_effects, in)[0], g, 1e-14);
    EXPECT_NEAR(value(robot, {}, Function::inverse_dynamics, in)[0], M * -1.5 + g, 1e-14);
    for (const std::size_t route : {0U, 1U}) {
      EXPECT_NEAR(value(robot, {}, Function::forward_dynamics, in, route)[0], (2 - g) / M, 1e-13);
    }
  }
}

/// Both joints rotate about z; gravity is along -y.
struct TwoLinks {
  double l1 = 0.7, c1 = 0.3, m1 = 3, I1 = 0.05;
  double l2 = 0.5, c2 = 0.2, m2 = 1.5, I2 = 0.02;

  [[nodiscard]] Robot robot() const {
    Robot made = sample_robot(
        {{"shoulder", "base"},
         {"elbow", "shoulder_link", JointType::revolute, {0, 0, 1}, {{l1, 0, 0}, {}}}});
    made.links[1].inertial = rod_inertial(m1, c1, I1);
    made.links[2].inertial = rod_inertial(m2, c2, I2);
    return made;
  }
  [[nodiscard]] Scene scene() const {
    Scene made;
    made.gravity = {0, -kGravity, 0};
    ScenePoint tip;
    tip.name = "tip";
    tip.link = "elbow_link";
    tip.origin.xyz = {l2, 0, 0};
    tip.rows = {true, true, false, false, false, false};
    made.operational_points = {tip};
    return made;
  }
};

constexpr double kQ1 = 0.6, kQ2 = -1.1, kQd1 = 1.3, kQd2 = -0.8;

Inputs<double> two_link_inputs() {
  return {{kQ1, kQ2}, {kQd1, kQd2}, {0.5, -2.0}, {4.0, 1.0}, {0.3, -0.7}, {}};
}

void expect_values(const std::vector<double>& found, const std::vector<double>& expected,
                   double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], tolerance);
}

TEST(TwoLinkArm, HasItsTextbookDynamics) {
  const TwoLinks arm;
  const double coupling = arm.m2 * arm.l1 * arm.c2;
  const double M22 = arm.I2 + arm.m2 * arm.c2 * arm.c2;
  const double M12 = M22 + coupling * std::cos(kQ2);
  const double M11 = arm.I1 + arm.m1 * arm.c1 * arm.c1 + arm.m2 * arm.l1 * arm.l1 + M22 +
                     2 * coupling * std::cos(kQ2);
  const double s = coupling * std::sin(kQ2);
  const double g2 = arm.m2 * arm.c2 * kGravity * std::cos(kQ1 + kQ2);
  const double g1 = (arm.m1 * arm.c1 + arm.m2 * arm.l1) * kGravity * std::cos(kQ1) + g2;
  const double h1 = -s * (2 * kQd1 * kQd2 + kQd2 * kQd2) + g1;
  const double h2 = s * kQd1 * kQd1 + g2;
  const auto in = two_link_inputs();
  const auto found = [&](Function function) {
    return value(arm.robot(), arm.scene(), function, in);
  };
  expect_values(found(Function::mass_matrix), {M11, M12, M12, M22}, 1e-14);
  expect_values(found(Function::gravity), {g1, g2}, 1e-13);
  expect_values(found(Function::nonlinear_effects), {h1, h2}, 1e-13);
  expect_values(found(Function::inverse_dynamics),
                {M11 * 0.5 - M12 * 2 + h1, M12 * 0.5 - M22 * 2 + h2}, 1e-13);
}

TEST(TwoLinkArm, HasItsTextbookTask) {
  const TwoLinks arm;
  const double s1 = std::sin(kQ1), c1 = std::cos(kQ1);
  const double s12 = std::sin(kQ1 + kQ2), c12 = std::cos(kQ1 + kQ2);
  const double w = kQd1 + kQd2;
  const auto in = two_link_inputs();
  const auto found = [&](Function function) {
    return value(arm.robot(), arm.scene(), function, in);
  };
  expect_values(found(Function::forward_kinematics),
                {arm.l1 * c1 + arm.l2 * c12, arm.l1 * s1 + arm.l2 * s12, 0}, 1e-15);
  expect_values(
      found(Function::jacobian),
      {-arm.l1 * s1 - arm.l2 * s12, -arm.l2 * s12, arm.l1 * c1 + arm.l2 * c12, arm.l2 * c12},
      1e-15);
  expect_values(found(Function::bias_acceleration),
                {-arm.l1 * c1 * kQd1 * kQd1 - arm.l2 * c12 * w * w,
                 -arm.l1 * s1 * kQd1 * kQd1 - arm.l2 * s12 * w * w},
                1e-14);
}

// With as many rows as joints, the task alone determines the joints' motion: whatever the posture
// commands, tau = M J^-1 (xdd - Jd qd) + h.
TEST(TwoLinkArm, ControlTorqueOfAFullTaskKnowsNoPosture) {
  const TwoLinks arm;
  Inputs<double> in = two_link_inputs();
  const auto first =
      trace_function(reduced_mechanism(arm.robot(), arm.scene()), Function::control_torque);
  for (std::size_t route = 0; route < first.size(); ++route) {
    in.qdd = {0.5, -2.0};
    const auto tau = value(arm.robot(), arm.scene(), Function::control_torque, in, route);
    in.qdd = {-7.0, 4.0};
    expect_values(value(arm.robot(), arm.scene(), Function::control_torque, in, route), tau, 1e-12);
    in.tau = tau;
    const auto qdd = value(arm.robot(), arm.scene(), Function::forward_dynamics, in);
    const auto J = value(arm.robot(), arm.scene(), Function::jacobian, in);
    const auto bias = value(arm.robot(), arm.scene(), Function::bias_acceleration, in);
    EXPECT_NEAR(J[0] * qdd[0] + J[1] * qdd[1] + bias[0], in.xdd_cmd[0], 1e-12);
    EXPECT_NEAR(J[2] * qdd[0] + J[3] * qdd[1] + bias[1], in.xdd_cmd[1], 1e-12);
  }
}

/// Product A * B of square matrices.
std::vector<double> product(const std::vector<double>& A, const std::vector<double>& B,
                            std::size_t n) {
  std::vector<double> C(n * n);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k) C[i * n + j] += A[i * n + k] * B[k * n + j];
    }
  }
  return C;
}

TEST(Structure, LambdaInvertsItsInverseAndMatricesAreSymmetricToTheBit) {
  RandomOptions options;
  options.joints = 9;
  options.branching = 0;
  options.mix = {1, 0, 0, 0, 0, 0};
  RandomMechanism made = random_mechanism(9, options);
  made.scene.operational_points[0].link = "link_8";
  const Oracle<Digits50> oracle(made.robot, made.scene);
  Rng rng(4);
  const auto in = rounded_to<double>(oracle.random_inputs(rng));
  const auto symmetric = [](const std::vector<double>& A) {
    const auto n = static_cast<std::size_t>(std::lround(std::sqrt(A.size())));
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (A[i * n + j] != A[j * n + i]) return false;
      }
    }
    return true;
  };
  const Mechanism mechanism = reduced_mechanism(made.robot, made.scene);
  const auto inverses = trace_function(mechanism, Function::lambda_inverse);
  const auto lambdas = trace_function(mechanism, Function::lambda);
  ASSERT_EQ(inverses.size(), lambdas.size());
  EXPECT_TRUE(symmetric(value(made.robot, made.scene, Function::mass_matrix, in)));
  const double slack = condition(oracle.lambda_inverse(rounded_to<Digits50>(in))) * 1e-13;
  for (std::size_t route = 0; route < inverses.size(); ++route) {
    const auto A = value(inverses[route], in);
    const auto B = value(lambdas[route], in);
    EXPECT_TRUE(symmetric(A)) << describe(inverses[route].route);
    EXPECT_TRUE(symmetric(B)) << describe(inverses[route].route);
    const auto one = product(A, B, 6);
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) EXPECT_NEAR(one[i * 6 + j], i == j ? 1 : 0, slack);
    }
  }
}

// Rows of a point on the base are zero in the graph itself, not by cancellation.
TEST(Structure, RowsOfAPointOnTheBaseAreStructurallyZero) {
  Robot robot = pendulum();
  Scene scene;
  scene.operational_points = {sample_point("base"), sample_point("swing_link")};
  const Mechanism mechanism = reduced_mechanism(robot, scene);
  for (const Function function :
       {Function::jacobian, Function::bias_acceleration, Function::lambda_inverse}) {
    for (const Program& program : trace_function(mechanism, function)) {
      const auto& entries = program.results[0].values;
      for (std::size_t i = 0; i < entries.size() / 2; ++i) EXPECT_TRUE(entries[i].is_zero());
    }
  }
}

}  // namespace
}  // namespace treeline::tests
