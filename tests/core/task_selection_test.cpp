// Selection matrices as defined by Khatib 1987. Would catch: a transposed frame, directions that
// get both commands or none, and an integral that winds up.
#include "core/task_selection.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>

namespace {

using namespace treeline::core;  // NOLINT: the whole header is under test
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

struct Example {
  TaskSelection<double> selection;
  Matrix6 Omega = Matrix6::Zero();

  /// Presses along z of a tilted frame and does not resist moments about its x and y.
  Example() {
    const RowMajor R_force(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, -1).normalized()));
    const RowMajor R_moment(Eigen::AngleAxisd(-1.1, Eigen::Vector3d(0, 1, 3).normalized()));
    RowMajor::Map(selection.R_force) = R_force;
    RowMajor::Map(selection.R_moment) = R_moment;
    selection.motion[2] = selection.motion[3] = selection.motion[4] = false;
    const Eigen::Vector3d Sigma_F(1, 1, 0);
    const Eigen::Vector3d Sigma_M(0, 0, 1);
    Omega.topLeftCorner<3, 3>() = R_force * Sigma_F.asDiagonal() * R_force.transpose();
    Omega.bottomRightCorner<3, 3>() = R_moment * Sigma_M.asDiagonal() * R_moment.transpose();
  }
};

TEST(TaskSelection, PartsAreTheMatricesOfTheMethod) {
  const Example example;
  const double x[6] = {1, -2, 3, 0.5, 4, -1};
  double motion[6];
  double force[6];
  select_motion(example.selection, x, motion);
  select_force(example.selection, x, force);
  const Vector6 expected = example.Omega * Vector6::Map(x);
  EXPECT_LE((Vector6::Map(motion) - expected).norm(), 1e-14);
  EXPECT_LE((Vector6::Map(motion) + Vector6::Map(force) - Vector6::Map(x)).norm(), 1e-14);
}

// With F = Lambda xdd_cmd, force directions get the desired force and motion directions the desired
// acceleration.
TEST(TaskSelection, CommandSplitsMotionAndForce) {
  const Example example;
  const Matrix6 X = Matrix6::Random();
  const Matrix6 Lambda_inv = X * X.transpose() + Matrix6::Identity();
  const Vector6 motion = Vector6::Random();
  const Vector6 velocity = Vector6::Random();
  const Vector6 force = Vector6::Random();
  double packed[36];
  double in[3][6];
  double out[6];
  Matrix6::Map(packed) = Lambda_inv;
  Vector6::Map(in[0]) = motion;
  Vector6::Map(in[1]) = velocity;
  Vector6::Map(in[2]) = force;
  motion_force_command(example.selection, packed, in[0], in[1], in[2], 8.0, out);
  const Matrix6 Omega_bar = Matrix6::Identity() - example.Omega;
  const Vector6 F = Lambda_inv.inverse() * Vector6::Map(out);
  const Vector6 expected =
      Lambda_inv.inverse() * (example.Omega * motion - Omega_bar * (8.0 * velocity)) +
      Omega_bar * force;
  EXPECT_LE((F - expected).norm(), 1e-12);
}

TEST(TaskSelection, ForceLawIntegratesWithinItsBound) {
  const ForceGains<double> gains{0.5, 2.0, 0.0};
  const double wanted[6] = {10, 0, 0, 0, 0, -1};
  const double sensed[6] = {8, 0, 0, 0, 0, 0};
  double integral[6] = {};
  double force[6];
  force_law(gains, wanted, sensed, 0.1, 0.3, integral, force);
  EXPECT_DOUBLE_EQ(integral[0], 0.2);
  EXPECT_DOUBLE_EQ(force[0], 10 + 1.0 + 0.4);
  EXPECT_DOUBLE_EQ(force[5], -1 - 0.5 - 0.2);
  for (int i = 0; i < 10; ++i) {
    force_law(gains, wanted, sensed, 0.1, 0.3, integral, force);
  }
  EXPECT_DOUBLE_EQ(integral[0], 0.3);
  EXPECT_DOUBLE_EQ(integral[5], -0.3);
}

}  // namespace
