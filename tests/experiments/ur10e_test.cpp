// The UR10e through singularities: the physical claims, and its generated damped_control_torque
// compared with the interpreter's. Would catch: calls composed in the wrong order, rows with the
// limit of another row, a torque that jumps or grows without bound, and a stated bound that does
// not hold.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "core/damped_solve.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"
#include "singular_run.hpp"
#include "ur10e_damped.hpp"

namespace treeline::ur10e_experiments {

void PrintTo(Line line, std::ostream* out) {
  *out << (line == Line::reach ? "reach" : "wrist");
}

namespace {

class Lines : public testing::TestWithParam<Line> {};
INSTANTIATE_TEST_SUITE_P(All, Lines, testing::ValuesIn(kLines),
                         [](const auto& tested) { return file_name_of(tested.param); });

TEST_P(Lines, ArePassedWithinTheLimits) {
  std::vector<SingularRun> runs;
  for (const Law law : kLaws) runs.push_back(run_line(GetParam(), law));
  EXPECT_TRUE(claim_holds(GetParam(), runs)) << summary(GetParam(), runs);
}

struct Draw {
  double q[6], qd[6], qdd_0[6], xdd_cmd[6];
};

/// Every third state is at or very near one or two of the arm's singularities.
Draw draw(std::mt19937_64& engine, int round) {
  std::uniform_real_distribution<double> within(-3, 3);
  const double beside[] = {0.0, 1e-300, -1e-12, 1e-8, 1e-5, -1e-3, 0.03};
  Draw d{};
  for (int i = 0; i < 6; ++i) {
    d.q[i] = within(engine);
    d.qd[i] = within(engine) / 3;
    d.qdd_0[i] = within(engine);
    d.xdd_cmd[i] = within(engine);
  }
  if (round % 2 == 0) d.q[4] = beside[round % 7];
  if (round % 3 == 0) d.q[2] = beside[round % 5];
  return d;
}

TEST(DampedControlTorque, IsTheInterpreters) {
  const std::string folder = std::string(TREELINE_ROBOTS_DIR) + "/ur10e/";
  Diagnostics diagnostics;
  const auto robot = read_urdf(folder + "ur10e.urdf", diagnostics);
  ASSERT_TRUE(robot);
  const auto scene = read_scene(folder + "scene.yaml", *robot, diagnostics);
  ASSERT_TRUE(scene);
  const auto model = model_from_robot<double>(*robot, *scene);
  const auto points = points_from_scene(model, scene->operational_points);
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  std::mt19937_64 engine(4);
  for (int round = 0; round < 500; ++round) {
    const Draw d = draw(engine, round);
    double tau[6];
    ur10e::damped_control_torque(d.q, d.qd, d.qdd_0, d.xdd_cmd, tau);
    const Vector6 expected =
        interpreter::damped_control_torque<double>(
            model, points, Vector6::Map(d.q), Vector6::Map(d.qd), Vector6::Map(d.qdd_0),
            Vector6::Map(d.xdd_cmd), {Vector6::Map(ur10e::kHeaviest)})
            .tau;
    // Eigenvalues reach 1e5, which leaves an error of 1e-11 in eigenvalues near one.
    EXPECT_LT((Vector6::Map(tau) - expected).norm(), 1e-10 * (100 + expected.norm())) << round;
  }
}

TEST(DampedControlTorque, KeepsItsBoundEverywhere) {
  std::mt19937_64 engine(5);
  double largest = 0;
  for (int round = 0; round < 3000; ++round) {
    const Draw d = draw(engine, round);
    double tau[6];
    double tau_0[6];
    double M[36];
    double J[36];
    double bias[6];
    ur10e::damped_control_torque(d.q, d.qd, d.qdd_0, d.xdd_cmd, tau);
    ur10e::inverse_dynamics(d.q, d.qd, d.qdd_0, tau_0);
    ur10e::mass_matrix(d.q, M);
    ur10e::jacobian(d.q, J);
    ur10e::bias_acceleration(d.q, d.qd, bias);
    using Matrix = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
    using Column = Eigen::Matrix<double, 6, 1>;
    const Column added = Column::Map(tau) - Column::Map(tau_0);
    ASSERT_TRUE(added.allFinite()) << round;
    const Column missing =
        Column::Map(d.xdd_cmd) - Column::Map(bias) - Matrix::Map(J) * Column::Map(d.qdd_0);
    const double allowed =
        missing.cwiseProduct(Column::Map(ur10e::kHeaviest).cwiseSqrt()).squaredNorm();
    largest = std::max(largest, added.dot(Matrix::Map(M).ldlt().solve(added)) / allowed);
  }
  EXPECT_LE(largest, core::kLargestDampedEnergy * (1 + 1e-9));
  EXPECT_GT(largest, 0.5);
}

}  // namespace
}  // namespace treeline::ur10e_experiments
