// Would catch: a repaired inertia that is still impossible or not the nearest possible one, and a
// body without extent that is not named.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <random>

#include "description/inertias.hpp"

namespace treeline {
namespace {

using Eigen::Matrix3d;

Inertial inertial(const Matrix3d& J) {
  Inertial i;
  i.mass = 1;
  i.ixx = J(0, 0);
  i.ixy = J(0, 1);
  i.ixz = J(0, 2);
  i.iyy = J(1, 1);
  i.iyz = J(1, 2);
  i.izz = J(2, 2);
  return i;
}

Inertial diagonal(double x, double y, double z) {
  return inertial(Eigen::Vector3d(x, y, z).asDiagonal());
}

Matrix3d second_moments(const Inertial& i) {
  Matrix3d J;
  J << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
  return J.trace() / 2 * Matrix3d::Identity() - J;
}

TEST(NearestInertia, PossibleOnesStay) {
  for (const Inertial& i : {diagonal(1, 1, 1), diagonal(1, 2, 3), diagonal(0, 1, 1),
                            diagonal(0, 0, 0), diagonal(1, 1, 2.0001)}) {
    EXPECT_FALSE(nearest_possible_inertia(i)) << i.ixx << " " << i.iyy << " " << i.izz;
  }
}

TEST(NearestInertia, ClosedForm) {
  // Sigma = diag(0.2, 0.2, -0.1): its last entry becomes 0 and J = diag(0.2, 0.2, 0.4).
  const auto nearest = nearest_possible_inertia(diagonal(0.1, 0.1, 0.4));
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->ixx, 0.2);
  EXPECT_EQ(nearest->iyy, 0.2);
  EXPECT_EQ(nearest->izz, 0.4);
  EXPECT_EQ(nearest->ixy, 0);
  EXPECT_EQ(nearest->mass, 1);
}

TEST(NearestInertia, NearerThanOtherPossibleOnes) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  int repaired = 0;
  for (int k = 0; k < 2000; ++k) {
    const Matrix3d A = Matrix3d::NullaryExpr([&] { return normal(random); });
    const double size = std::pow(10, 3 * normal(random));
    const Inertial i = inertial(size * (A + A.transpose()));
    const auto nearest = nearest_possible_inertia(i);
    if (!nearest) continue;
    ++repaired;
    const Matrix3d before = second_moments(i), after = second_moments(*nearest);
    const double least = Eigen::SelfAdjointEigenSolver<Matrix3d>(after).eigenvalues()[0];
    EXPECT_GE(least, -1e-14 * size) << "state " << k;
    EXPECT_FALSE(find_unphysical(*nearest));
    // The nearest point a of a closed convex set to b has (b - a) (c - a) <= 0 for all c in the
    // set.
    const Matrix3d B = Matrix3d::NullaryExpr([&] { return normal(random); });
    const Matrix3d other = size * B * B.transpose();
    EXPECT_LE((before - after).cwiseProduct(other - after).sum(), 1e-6 * size * size);
  }
  EXPECT_GT(repaired, 1000);
}

TEST(NearestInertia, TheSameInOtherAxes) {
  const Matrix3d J = Eigen::Vector3d(0.1, 0.2, 0.9).asDiagonal();
  const Matrix3d R = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  const auto plain = nearest_possible_inertia(inertial(J));
  const auto turned = nearest_possible_inertia(inertial(R * J * R.transpose()));
  ASSERT_TRUE(plain && turned);
  const Matrix3d expected = R * second_moments(*plain) * R.transpose();
  EXPECT_LT((second_moments(*turned) - expected).cwiseAbs().maxCoeff(), 1e-7);
}

TEST(FlatBody, ByRank) {
  const auto name = [](const Inertial& i) { return name_of_flat_body(i).value_or("none"); };
  EXPECT_EQ(name(diagonal(0, 0, 0)), "a point");
  EXPECT_EQ(name(diagonal(0, 1, 1)), "a rod");
  EXPECT_EQ(name(diagonal(1, 1, 2)), "a plate");
  EXPECT_EQ(name(diagonal(1, 1, 1.9999)), "none");
  EXPECT_EQ(name(diagonal(1, 1, 4)), "none");  // impossible, not flat
  Inertial massless = diagonal(0, 0, 0);
  massless.mass = 0;
  EXPECT_EQ(name(massless), "none");
}

}  // namespace
}  // namespace treeline
