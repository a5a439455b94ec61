#include <gtest/gtest.h>

#include "interpreter/physics.hpp"

// The dynamically consistent inverse, the null-space projector, and the forces mu and p, where the
// task is regular. Would catch: a transposed projector, forces with a wrong sign or with gravity
// counted twice, and an inverse of J that is another than the one that no load at the operational
// point changes.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)

Digits50 ratio_of_pivots(const Matrix50& A) {
  const Vector50 pivots = A.ldlt().vectorD().cwiseAbs();
  return pivots.minCoeff() == 0 ? Digits50("1e60")
                                : Digits50(pivots.maxCoeff() / pivots.minCoeff());
}

/// The first mechanism from the seed on whose controlled rows are independent.
Case case_with_task(std::uint64_t first, const RandomOptions& options) {
  for (std::uint64_t seed = first;; ++seed) {
    Case c = random_case(seed, options);
    if (ratio_of_pivots(lambda_inverse<Digits50>(c.model, c.points, c.q)) < 1e8) return c;
  }
}

class OperationalQuantities : public testing::TestWithParam<std::uint64_t> {
 protected:
  OperationalQuantities()
      : c_(case_with_task(100 * GetParam(), {.joints = 14,
                                             .branching = 0.12,
                                             .mix = {5, 1, 2, 0, 0.2, 0.5, 0.5},
                                             .floating_base = GetParam() % 2 == 0,
                                             .mimic = GetParam() % 3 == 0 ? 0.2 : 0,
                                             .aligned = 0.3,
                                             .rotors = GetParam() % 4 == 0 ? 0.5 : 0,
                                             .operational_points = 2,
                                             .all_rows = false})),
        J_(jacobian<Digits50>(c_.model, c_.points, c_.q)),
        M_(mass_matrix<Digits50>(c_.model, c_.q)),
        Jbar_(dynamically_consistent_inverse<Digits50>(c_.model, c_.points, c_.q, {})),
        N_(null_space_projector<Digits50>(c_.model, c_.points, c_.q, {})),
        tolerance_(kAlgebra * scale(M_) * scale(N_) *
                   ratio_of_pivots(lambda_inverse<Digits50>(c_.model, c_.points, c_.q))) {}

  Case c_;
  Matrix50 J_, M_, Jbar_, N_;
  Digits50 tolerance_;
};

INSTANTIATE_TEST_SUITE_P(Seeds, OperationalQuantities, testing::Range<std::uint64_t>(1, 11));

TEST_P(OperationalQuantities, InverseAndProjectorSatisfyTheirDefinitions) {
  const auto rows = J_.rows();
  EXPECT_LT(relative_error(Matrix50(J_ * Jbar_), Matrix50::Identity(rows, rows)), tolerance_);
  EXPECT_LT(Digits50((J_ * N_).cwiseAbs().maxCoeff()), tolerance_);
  EXPECT_LT(relative_error(Matrix50(N_ * N_), N_), tolerance_);
  // Motions of the task and of its null space have no kinetic energy in common.
  EXPECT_LT(Digits50((N_.transpose() * M_ * Jbar_).cwiseAbs().maxCoeff()), tolerance_);
}

// Khatib's equation of motion: Jbar^T tau = Lambda xdd + mu + p.
TEST_P(OperationalQuantities, ForcesAreThoseOfTheTasksEquationOfMotion) {
  const Vector50 qdd = forward_dynamics<Digits50>(c_.model, c_.q, c_.qd, c_.tau);
  const Vector50 xdd = point_accelerations<Digits50>(c_.model, c_.points, c_.q, c_.qd, qdd);
  const Vector50 F = lambda<Digits50>(c_.model, c_.points, c_.q) * xdd +
                     operational_bias_force<Digits50>(c_.model, c_.points, c_.q, c_.qd, {}) +
                     operational_gravity<Digits50>(c_.model, c_.points, c_.q, {});
  EXPECT_LT(relative_error(F, Vector50(Jbar_.transpose() * c_.tau)), tolerance_ * scale(qdd));
}

/// A mechanism with a load fixed to a body: mass, centre and inertia about it, in the body's
/// frame.
Model50 with_load(Model50 model, int body, const Digits50& mass, const Vector3<Digits50>& center,
                  const Matrix3<Digits50>& central) {
  auto& loaded = model.bodies[static_cast<std::size_t>(body)];
  const Matrix3<Digits50> C = cross_matrix(center);
  const Digits50 whole = loaded.mass + mass;
  loaded.com = Vector3<Digits50>((loaded.mass * loaded.com + mass * center) / whole);
  loaded.inertia += central - mass * Matrix3<Digits50>(C * C);
  loaded.mass = whole;
  return model;
}

class LoadedPoint : public testing::TestWithParam<std::uint64_t> {
 protected:
  static constexpr RandomOptions options(std::uint64_t seed) {
    RandomOptions options;
    options.joints = 9;
    options.branching = 0;
    options.mix = {5, 1, 2, 0, 0.2, 0.5, 0.5};
    options.floating_base = seed % 2 == 0;
    options.rotors = seed % 3 == 0 ? 0.5 : 0;
    return options;
  }
  const Case c_ = case_with_task(5000 + 100 * GetParam(), options(GetParam()));
  const int body_ = c_.points[0].body;
  const Matrix50 Lambda_inverse_ = lambda_inverse<Digits50>(c_.model, c_.points, c_.q);
  const Digits50 tolerance_ = kAlgebra * ratio_of_pivots(Lambda_inverse_) * 1000;
};

INSTANTIATE_TEST_SUITE_P(Seeds, LoadedPoint, testing::Range<std::uint64_t>(1, 9));

// Chang sect. 7.3.1: what is added at the operational point adds J^T Lambda_load J to M, which
// leaves Jbar = M^-1 J^T Lambda as it is, whatever the load weighs.
TEST_P(LoadedPoint, LeavesTheConsistentInverseAsItIs) {
  Matrix3<Digits50> central;
  central << 2, Digits50("0.3"), Digits50("-0.2"), Digits50("0.3"), 1, Digits50("0.1"),
      Digits50("-0.2"), Digits50("0.1"), Digits50("1.5");
  const Vector3<Digits50> at(Digits50("0.4"), Digits50("-0.7"), Digits50("0.2"));
  const Model50 loaded = with_load(c_.model, body_, 25, at, central);
  const Matrix50 before = dynamically_consistent_inverse<Digits50>(c_.model, c_.points, c_.q, {});
  const Matrix50 after = dynamically_consistent_inverse<Digits50>(loaded, c_.points, c_.q, {});
  EXPECT_LT(relative_error(after, before), tolerance_ * scale(before));
  // The load itself is felt.
  EXPECT_GT(relative_error(lambda<Digits50>(loaded, c_.points, c_.q),
                           lambda<Digits50>(c_.model, c_.points, c_.q)),
            Digits50("1e-3"));
}

// A point mass at the point leaves it as it is also where only the point's position is controlled;
// beside the point it does not.
TEST_P(LoadedPoint, OfPositionBearsAPointMassThere) {
  Points50 points = c_.points;
  points[0].rows = {true, true, true, false, false, false};
  const Vector3<Digits50> away(Digits50("0.4"), Digits50("-0.7"), Digits50("0.2"));
  const auto inverse_with_mass_at = [&](const Vector3<Digits50>& place) {
    return dynamically_consistent_inverse<Digits50>(
        with_load(c_.model, body_, 25, place, Matrix3<Digits50>::Zero()), points, c_.q, {});
  };
  const Matrix50 before = dynamically_consistent_inverse<Digits50>(c_.model, points, c_.q, {});
  EXPECT_LT(relative_error(inverse_with_mass_at(points[0].p), before), tolerance_ * scale(before));
  EXPECT_GT(relative_error(inverse_with_mass_at(points[0].p + away), before), Digits50("1e-6"));
}

}  // namespace
}  // namespace treeline::tests
