#include <gtest/gtest.h>

#include "interpreter/physics.hpp"

// Tables 5.3 and 6.1 where the task is regular, with as many independent rows as requested. Would
// catch: a control torque that does not lead to the commanded acceleration, lets the posture affect
// the task, or uses F with the wrong sign, axes or reference point.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)

/// Ratio of the largest to the smallest pivot of a symmetric matrix; huge if its rows depend on
/// each other.
Digits50 pivot_ratio(const Matrix50& A) {
  const Vector50 pivots = A.ldlt().vectorD().cwiseAbs();
  return pivots.minCoeff() == 0 ? Digits50("1e60")
                                : Digits50(pivots.maxCoeff() / pivots.minCoeff());
}

class OperationalSpace : public testing::TestWithParam<std::uint64_t> {
 protected:
  /// The first mechanism from the seed on whose controlled rows are independent.
  OperationalSpace() {
    for (std::uint64_t seed = 100 * GetParam();; ++seed) {
      c_ = random_case(seed, {.joints = 16,
                              .branching = 0.12,
                              .mix = {5, 1, 2, 0, 0.2, 0.5},
                              .floating_base = seed % 2 == 0,
                              .mimic = seed % 3 == 0 ? 0.2 : 0,
                              .aligned = 0.3,
                              .operational_points = 2,
                              .all_rows = false,
                              .external_forces = 1});
      o_ = explicit_operational_space<Digits50>(c_.model, c_.points, c_.q);
      condition_ = pivot_ratio(o_.Lambda_inverse);
      if (condition_ < 1e8) {
        RecordProperty("seed", std::to_string(seed));
        return;
      }
    }
  }

  Case c_;
  ExplicitOperationalSpace<Digits50> o_;
  Digits50 condition_;
};

INSTANTIATE_TEST_SUITE_P(Seeds, OperationalSpace, testing::Range<std::uint64_t>(1, 13));

TEST_P(OperationalSpace, ControlTorqueBringsTheCommandedAcceleration) {
  const Digits50 tolerance = kAlgebra * condition_;
  const Vector50 tau = control_torque<Digits50>(c_.model, c_.points, c_.q, c_.qd, c_.qdd, c_.xdd,
                                                c_.external_points, c_.f_ext);
  const Vector50 qdd =
      forward_dynamics<Digits50>(c_.model, c_.q, c_.qd, tau, c_.external_points, c_.f_ext);
  EXPECT_LT(
      relative_error(point_accelerations<Digits50>(c_.model, c_.points, c_.q, c_.qd, qdd), c_.xdd),
      tolerance);
  // The posture's acceleration is kept in the null space: N (qdd - qdd_0) = 0.
  const Vector50 rest = o_.N * (qdd - c_.qdd);
  EXPECT_LT(Digits50(rest.cwiseAbs().maxCoeff()), tolerance * scale(c_.qdd) * scale(o_.N));
}

TEST_P(OperationalSpace, ControlTorqueIsTheExplicitOne) {
  const Digits50 tolerance = kAlgebra * condition_;
  const Vector50 expected = explicit_control_torque<Digits50>(
      o_, c_.qdd, c_.xdd, bias_acceleration<Digits50>(c_.model, c_.points, c_.q, c_.qd),
      nonlinear_effects<Digits50>(c_.model, c_.q, c_.qd));
  EXPECT_LT(
      relative_error(control_torque<Digits50>(c_.model, c_.points, c_.q, c_.qd, c_.qdd, c_.xdd),
                     expected),
      tolerance);
  EXPECT_LT(relative_error(lambda<Digits50>(c_.model, c_.points, c_.q), o_.Lambda), tolerance);
}

// J M^-1 N^T = 0: no torque in the null space accelerates a point.
TEST_P(OperationalSpace, NullSpaceTorqueAcceleratesNoPoint) {
  const Matrix50 through = o_.J * o_.M_inverse * o_.N.transpose();
  EXPECT_LT(Digits50(through.cwiseAbs().maxCoeff()),
            kAlgebra * condition_ * scale(o_.M_inverse) * scale(o_.J) * scale(o_.N));
}

}  // namespace
}  // namespace treeline::tests
