// Orientation errors compared with Eigen's angle-axis from 1e-12 rad to half a turn, laws compared
// with closed forms. Would catch: a wrong sign or frame of the error (body for world), lost digits
// near 0 or pi, and a saturation that changes the direction.
#include "core/command_laws.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/orientation.hpp"

namespace {

using namespace treeline::core;  // NOLINT: the whole header is under test
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Eigen::Vector3d random_direction(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

TEST(Orientation, ErrorIsTheWorldRotationVector) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 2000; ++i) {
    const double angle = i % 4 == 0 ? std::pow(10.0, -12.0 + i * 0.006) : 3.1415926 * i / 2000.0;
    const Eigen::Vector3d axis = random_direction(random);
    const RowMajor from(Eigen::AngleAxisd(2.0, random_direction(random)));
    const RowMajor to = Eigen::AngleAxisd(angle, axis).toRotationMatrix() * from;
    double R[9];
    double R_wanted[9];
    double error[3];
    RowMajor::Map(R) = from;
    RowMajor::Map(R_wanted) = to;
    orientation_error(R, R_wanted, error);
    // The matrices carry a few roundings of 1; near pi nothing is amplified (Shepperd).
    EXPECT_LE((Eigen::Vector3d::Map(error) - angle * axis).norm(), 1e-14) << angle;
  }
}

// In float: a few roundings of the angle, also near zero and near half a turn.
TEST(Orientation, ErrorInFloatIsThatOfDouble) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    const double angle = i % 4 == 0 ? std::pow(10.0, -6.0 + i * 0.003) : 3.1415 * i / 2000.0;
    const Eigen::Vector3d axis = random_direction(random);
    const float vector[3] = {static_cast<float>(angle * axis.x()),
                             static_cast<float>(angle * axis.y()),
                             static_cast<float>(angle * axis.z())};
    const float straight[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    float R[9];
    float error[3];
    rotation_from_vector(vector, R);
    orientation_error(straight, R, error);
    // The matrix contains a few roundings of 1, and so does the angle.
    EXPECT_LE((Eigen::Vector3f::Map(error) - Eigen::Vector3f::Map(vector)).norm(), 1e-6F) << angle;
  }
}

TEST(Orientation, ErrorOfHalfATurnHasLengthPi) {
  const double R[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const double about_y[9] = {-1, 0, 0, 0, 1, 0, 0, 0, -1};
  double error[3];
  orientation_error(R, about_y, error);
  EXPECT_NEAR(std::fabs(error[1]), M_PI, 9e-16);
  EXPECT_EQ(error[0], 0.0);
  EXPECT_EQ(error[2], 0.0);
}

TEST(Orientation, ConversionsAgreeWithEigen) {
  std::mt19937_64 random(5);
  for (int i = 0; i <= 1000; ++i) {
    const double angle = i % 10 == 0 ? 1e-7 * i : M_PI * i / 1000.0;
    const Eigen::Vector3d axis = random_direction(random);
    const Eigen::AngleAxisd turn(angle, axis);
    const Eigen::Vector3d product = angle * axis;
    double vector[3];
    double R[9];
    double q[4];
    double R_again[9];
    Eigen::Vector3d::Map(vector) = product;
    rotation_from_vector(vector, R);
    EXPECT_LE((RowMajor::Map(R) - turn.toRotationMatrix()).norm(), 4e-15) << angle;
    quaternion_from_rotation(R, q);
    EXPECT_GE(q[3], 0.0);
    EXPECT_NEAR(Eigen::Vector4d::Map(q).norm(), 1.0, 1e-15);
    rotation_from_quaternion(q, R_again);
    EXPECT_LE((RowMajor::Map(R) - RowMajor::Map(R_again)).norm(), 4e-15) << angle;
  }
}

TEST(Orientation, PoseErrorIsLinearOverAngular) {
  const double R[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const double quarter_about_z[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};
  const double here[3] = {1, 2, 3};
  const double there[3] = {2, 4, 6};
  double error[6];
  pose_error(here, R, there, quarter_about_z, error);
  EXPECT_EQ(error[0], 1.0);
  EXPECT_EQ(error[1], 2.0);
  EXPECT_EQ(error[2], 3.0);
  EXPECT_NEAR(error[5], M_PI / 2, 5e-16);
}

TEST(CommandLaws, TrackingAndJointLawAreTheirFormulas) {
  const Gains<double> gains{100.0, 20.0};
  const double error[1] = {0.1};
  const double velocity[1] = {0.5};
  const double wanted[1] = {1.0};
  const double feedforward[1] = {3.0};
  double acceleration[1];
  tracking_law(gains, error, velocity, wanted, feedforward, acceleration);
  EXPECT_DOUBLE_EQ(acceleration[0], 3.0 + 20.0 * 0.5 + 100.0 * 0.1);
  const double q[1] = {0.2};
  joint_law(gains, wanted, q, velocity, acceleration);
  EXPECT_DOUBLE_EQ(acceleration[0], 100.0 * 0.8 - 20.0 * 0.5);
}

TEST(CommandLaws, SaturationKeepsDirectionAndReachesTheLimitSpeed) {
  const Gains<double> gains{100.0, 20.0};
  const double far_away[6] = {30.0, 40.0, 0.0, 0.0, 0.0, 0.01};
  const double at_limit[6] = {0.3, 0.4, 0.0, 0.0, 0.0, 0.05};
  double acceleration[6];
  // If the motion towards the goal has the speed limit, and the rotation is that of the unsaturated
  // law, there is no acceleration.
  saturated_goal_law(gains, far_away, at_limit, 0.5, 1.0, acceleration);
  for (const double a : acceleration) {
    EXPECT_NEAR(a, 0.0, 1e-14);
  }
  // Near the goal it is the plain PD law.
  const double near[6] = {0.01, 0.0, 0.0, 0.0, 0.0, 0.0};
  const double still[6] = {};
  saturated_goal_law(gains, near, still, 0.5, 1.0, acceleration);
  EXPECT_DOUBLE_EQ(acceleration[0], 1.0);
}

}  // namespace
