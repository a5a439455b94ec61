#include <gtest/gtest.h>

#include "interpreter/closed_chain_cases.hpp"

// Internal forces between hands (the virtual linkage, Williams and Khatib 1993) compared with their
// definition in words. Would catch: a sign, an arm, an axis or an order of rods that is another
// than the documented one, a resultant that is not zero, and forces that do not read back.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)

/// Grasps at the corners of a box, with the hands rotated away from it.
GraspedObject<Digits50> box(int grasps) {
  Rng rng(3);
  GraspedObject<Digits50> object;
  const double corners[5][3] = {
      {0, 0.2, 0}, {0, -0.2, 0}, {0.3, 0, 0.1}, {0.1, 0.1, 0.4}, {-0.2, 0.1, -0.3}};
  for (int i = 0; i < grasps; ++i) {
    Grasp<Digits50> grasp;
    grasp.R = random_rotation(rng);
    const Vector3<Digits50> r(corners[i][0], corners[i][1], corners[i][2]);
    grasp.p = -(grasp.R * r);
    object.grasps.push_back(grasp);
  }
  return object;
}

// Checks the definition in words, independently of the matrix: a squeeze of 7 N pushes each hand
// inward.
TEST(VirtualLinkage, SqueezesTwoHandsTowardsEachOther) {
  Vector50 internal = Vector50::Zero(6);
  internal(0) = -7;
  const Vector50 f = split_over_grasps<Digits50>(box(2), Vector6<Digits50>::Zero(), internal);
  Vector50 expected = Vector50::Zero(12);
  expected(1) = -7;  // the hand at y = 0.2 pushes towards -y
  expected(7) = 7;
  EXPECT_LT(relative_error(f, expected), kAlgebra);
}

// Torsion twists the object about the line between the hands; each hand has its own bending
// moments.
TEST(VirtualLinkage, TwistsAndBendsBetweenTwoHands) {
  Vector50 internal = Vector50::Zero(6);
  internal(1) = 3;  // about x of the linkage, which is -y of the object
  Vector50 f = split_over_grasps<Digits50>(box(2), Vector6<Digits50>::Zero(), internal);
  Vector50 expected = Vector50::Zero(12);
  expected(4) = 3;
  expected(10) = -3;
  EXPECT_LT(relative_error(f, expected), kAlgebra);
  internal(1) = 0;
  internal(2) = 2;  // m_1 about y = z x (-y) = x of the object; a couple of forces balances it
  f = split_over_grasps<Digits50>(box(2), Vector6<Digits50>::Zero(), internal);
  expected.setZero();
  expected(3) = 2;
  // The couple of forces f along z on an arm of 0.4 m: 0.4 f e_x = -2 e_x.
  expected(8) = 1 / Digits50(0.2);
  expected(2) = -expected(8);
  EXPECT_LT(relative_error(f, expected), kAlgebra);
}

// Rods push along themselves: tension alone needs no moments, has no resultant, and pulls a grasp
// along the unit vectors of its rods.
TEST(VirtualLinkage, TensionsPullAlongTheirRods) {
  for (const int n : {3, 4, 5}) {
    const auto object = box(n);
    const int rods = 3 * (n - 2);
    for (int rod = 0; rod < rods; ++rod) {
      Vector50 internal = Vector50::Zero(internal_force_count(n));
      internal(rod) = 1;
      const Vector50 f = split_over_grasps<Digits50>(object, Vector6<Digits50>::Zero(), internal);
      int pulled = 0;
      Vector3<Digits50> sum = Vector3<Digits50>::Zero();
      for (int i = 0; i < n; ++i) {
        const Vector3<Digits50> force = f.segment<3>(6 * i);
        sum += force;
        pulled += force.norm() > Digits50(0.5) ? 1 : 0;
        EXPECT_LT(Digits50(f.segment<3>(6 * i + 3).norm()), kAlgebra);
      }
      EXPECT_EQ(pulled, 2);
      EXPECT_LT(Digits50(sum.norm()), kAlgebra);
    }
  }
}

/// Hands that hold an object at these points of it, in their own axes.
GraspedObject<Digits50> held_at(const std::vector<Vector3<Digits50>>& points) {
  Rng rng(4);
  GraspedObject<Digits50> object;
  for (const Vector3<Digits50>& r : points) {
    Grasp<Digits50> grasp;
    grasp.R = random_rotation(rng);
    grasp.p = -(grasp.R * r);
    object.grasps.push_back(grasp);
  }
  return object;
}

/// The corners of a tray, in a plane that is along no axis; then a fifth point inside, and one
/// above.
std::vector<Vector3<Digits50>> tray(int points) {
  Rng rng(6);
  const Matrix3<Digits50> R = random_rotation(rng);
  const double places[6][3] = {{0.3, 0.2, 0},  {-0.3, 0.2, 0},  {-0.3, -0.2, 0},
                               {0.3, -0.2, 0}, {0.1, -0.05, 0}, {0, 0.1, 0.25}};
  std::vector<Vector3<Digits50>> corners;
  for (int i = 0; i < points; ++i) {
    const Vector3<Digits50> place(places[i][0], places[i][1], places[i][2]);
    corners.push_back(R * place + Vector3<Digits50>(0.1, 0.2, 0.3));
  }
  return corners;
}

// Newton and Euler judge, not W: forces of the hands and their moments about the object's origin
// add up to nothing, whatever the internal forces. Would catch: a warp that turns the object, and
// rods of which one is the sum of the others.
TEST(VirtualLinkage, HoldsATrayByItsCorners) {
  Rng rng(8);
  for (const int n : {4, 5, 6}) {
    const std::vector<Vector3<Digits50>> r = tray(n);
    const auto object = held_at(r);
    const int internal = internal_force_count(n);
    const Matrix50 inverse = grasp_description(object).fullPivLu().inverse();
    EXPECT_LT(Digits50(inverse.cwiseAbs().maxCoeff()), 10);
    for (int j = 0; j < internal; ++j) {
      const Vector50 one = Vector50::Unit(internal, j);
      const Vector50 f = split_over_grasps<Digits50>(object, Vector6<Digits50>::Zero(), one);
      Vector3<Digits50> force = Vector3<Digits50>::Zero(), moment = force;
      for (int i = 0; i < n; ++i) {
        force += f.segment<3>(6 * i);
        moment += f.segment<3>(6 * i + 3) +
                  cross<Digits50>(r[static_cast<std::size_t>(i)], f.segment<3>(6 * i));
      }
      EXPECT_GT(Digits50(f.norm()), Digits50("0.9")) << j;
      EXPECT_LT(Digits50(force.norm() + moment.norm()), kAlgebra) << "internal force " << j;
    }
    const Vector50 wanted = random_entries<Digits50>(rng, 6 * n, 9);
    const Vector50 f = split_over_grasps<Digits50>(object, wanted.head(6), wanted.tail(internal));
    EXPECT_LT(relative_error(grasp_description(object) * f, wanted), kAlgebra);
  }
}

// In words: the four corners of a rectangle are pulled along its sides and a diagonal, and warped
// by forces up and down in turn.
TEST(VirtualLinkage, WarpsATrayUpAndDownInTurn) {
  const std::vector<Vector3<Digits50>> r = tray(4);
  const auto object = held_at(r);
  Vector3<Digits50> normal = cross<Digits50>(r[1] - r[0], r[2] - r[0]);
  normal /= Digits50(sqrt(normal.squaredNorm()));
  Vector50 expected = Vector50::Zero(24);
  for (int i = 0; i < 4; ++i) expected.segment<3>(6 * i) = Digits50(i % 2 == 0 ? -1 : 1) * normal;
  const Vector50 warp = Vector50::Unit(18, 5);
  EXPECT_LT(relative_error(split_over_grasps<Digits50>(object, Vector6<Digits50>::Zero(), warp),
                           expected),
            kAlgebra);
  for (const auto& [rod, ends] : {std::pair{3, std::pair{2, 3}}, std::pair{4, std::pair{0, 3}}}) {
    const Vector50 pull = Vector50::Unit(18, rod);
    const Vector50 f = split_over_grasps<Digits50>(object, Vector6<Digits50>::Zero(), pull);
    for (int i = 0; i < 4; ++i) {
      const bool at_end = i == ends.first || i == ends.second;
      EXPECT_LT(Digits50(abs(Digits50(f.segment<3>(6 * i).norm() - (at_end ? 1 : 0)))), kAlgebra);
    }
  }
}

// W times its inverse is one: any resultant and any internal forces are recovered, and internal
// forces have no resultant.
TEST(VirtualLinkage, SplitsAndReadsBack) {
  Rng rng(9);
  for (const int n : {1, 2, 3, 4, 5}) {
    const auto object = box(n);
    const Matrix50 W = grasp_description(object);
    const Vector50 internal = random_entries<Digits50>(rng, internal_force_count(n), 9);
    const Vector6<Digits50> resultant = random_entries<Digits50>(rng, 6, 9);
    const Vector50 back = W * split_over_grasps<Digits50>(object, resultant, internal);
    EXPECT_LT(relative_error(back.head(6), resultant), kAlgebra);
    EXPECT_LT(relative_error(back.tail(internal.size()), internal), kAlgebra);
  }
}

}  // namespace
}  // namespace treeline::tests
