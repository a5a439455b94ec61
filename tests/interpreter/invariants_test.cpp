#include <gtest/gtest.h>

#include "interpreter/physics.hpp"

// The interpreter compared with physics for random mechanisms. A wrong joint model, velocity
// product, inertia, or sign of gravity or of external forces violates at least one of these tests.
// None of them depends on how the recursions are written.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)

class Invariants : public testing::TestWithParam<NamedOptions> {
 protected:
  const Case c_ = random_case(GetParam().seed, GetParam().options);
};

class FloatingInvariants : public Invariants {};

std::vector<NamedOptions> floating_mechanisms() {
  std::vector<NamedOptions> list = assorted_mechanisms();
  std::erase_if(list, [](const NamedOptions& named) { return !named.options.floating_base; });
  return list;
}

std::string test_name(const testing::TestParamInfo<NamedOptions>& tested) {
  return std::string(tested.param.name) + "_" + std::to_string(tested.index);
}

INSTANTIATE_TEST_SUITE_P(Assorted, Invariants, testing::ValuesIn(assorted_mechanisms()), test_name);
INSTANTIATE_TEST_SUITE_P(Assorted, FloatingInvariants, testing::ValuesIn(floating_mechanisms()),
                         test_name);

// Would catch: a Jacobian or velocity that is not the rate of change of the pose.
TEST_P(Invariants, JacobianIsTheDerivativeOfThePose) {
  Points50 points = c_.points;
  for (auto& e : points) {
    e.axes = PointAxes::world;
    e.rows.fill(true);
  }
  const auto poses = [&](const Digits50& t) {
    Matrix50 stacked(3, 4 * static_cast<int>(points.size()));
    int column = 0;
    for (const auto& pose :
         forward_kinematics<Digits50>(c_.model, points, moved(c_.model, c_.q, c_.qd, t))) {
      stacked.block<3, 4>(0, column) << pose.position, pose.rotation;
      column += 4;
    }
    return stacked;
  };
  const Matrix50 rate = derivative(poses);
  const Matrix50 at = poses(0);
  const Vector50 velocity = jacobian<Digits50>(c_.model, points, c_.q) * c_.qd;
  for (int e = 0; e < static_cast<int>(points.size()); ++e) {
    const Vector3<Digits50> v = velocity.segment<3>(6 * e);
    const Vector3<Digits50> w = velocity.segment<3>(6 * e + 3);
    EXPECT_LT(relative_error(v, rate.col(4 * e)), kDifference);
    const Matrix3<Digits50> R = at.block<3, 3>(0, 4 * e + 1);
    EXPECT_LT(relative_error(cross_matrix(w) * R, rate.block(0, 4 * e + 1, 3, 3)), kDifference);
  }
}

// Would catch: wrong selection of rows or axes. Local rows are world rows rotated into the frame's
// axes.
TEST_P(Invariants, LocalRowsAreWorldRowsTurned) {
  const auto pose = forward_kinematics<Digits50>(c_.model, c_.points, c_.q);
  int row = 0;
  for (std::size_t e = 0; e < c_.points.size(); ++e) {
    Points50 world{c_.points[e]};
    world[0].axes = PointAxes::world;
    world[0].rows.fill(true);
    Matrix50 all = jacobian<Digits50>(c_.model, world, c_.q);
    if (c_.points[e].axes == PointAxes::local) {
      all.topRows(3) = (pose[e].rotation.transpose() * all.topRows(3)).eval();
      all.bottomRows(3) = (pose[e].rotation.transpose() * all.bottomRows(3)).eval();
    }
    const Matrix50 J = jacobian<Digits50>(c_.model, c_.points, c_.q);
    for (int i = 0; i < 6; ++i) {
      if (!c_.points[e].rows[static_cast<std::size_t>(i)]) continue;
      EXPECT_LT(relative_error(J.row(row), all.row(i)), kAlgebra);
      ++row;
    }
  }
  EXPECT_EQ(row, row_count(c_.points));
}

// Would catch: a wrong velocity product, mainly of joints with a variable S, an acceleration that
// is not d(qd)/dt, and one along axes that turn which is not the rate of the velocity along them.
TEST_P(Invariants, PointAccelerationIsTheDerivativeOfItsVelocity) {
  const Points50& points = c_.points;
  const auto velocity = [&](const Digits50& t) {
    return Vector50(jacobian<Digits50>(c_.model, points, moved(c_.model, c_.q, c_.qd, t)) *
                    (c_.qd + t * c_.qdd));
  };
  EXPECT_LT(relative_error(point_accelerations<Digits50>(c_.model, points, c_.q, c_.qd, c_.qdd),
                           derivative(velocity)),
            kDifference);
}

// Would catch: a force whose work the energy does not show.
TEST_P(Invariants, PowerIsTheRateOfEnergy) {
  const Vector50 tau =
      inverse_dynamics<Digits50>(c_.model, c_.q, c_.qd, c_.qdd, c_.external_points, c_.f_ext);
  const auto energy = [&](const Digits50& t) {
    const Vector50 q = moved(c_.model, c_.q, c_.qd, t);
    return Digits50(kinetic_energy(c_.model, q, c_.qd + t * c_.qdd) +
                    potential_energy(c_.model, q));
  };
  const Digits50 supplied =
      tau.dot(c_.qd) +
      c_.f_ext.dot(Vector50(jacobian<Digits50>(c_.model, c_.external_points, c_.q) * c_.qd));
  EXPECT_LT(Digits50(abs(supplied - derivative(energy))),
            kDifference * (1 + abs(energy(0))) * 1000);
}

// Would catch: a wrong entry of M. It is the matrix of the kinetic energy, symmetric and positive
// definite.
TEST_P(Invariants, MassMatrixIsThatOfTheKineticEnergy) {
  const Matrix50 M = mass_matrix<Digits50>(c_.model, c_.q);
  EXPECT_LT(relative_error(M, M.transpose()), kAlgebra);
  EXPECT_TRUE((M.ldlt().vectorD().array() > 0).all());
  for (const Vector50& qd : {c_.qd, c_.qdd}) {
    const Digits50 energy = kinetic_energy(c_.model, c_.q, qd);
    EXPECT_LT(Digits50(abs(qd.dot(Vector50(M * qd)) / 2 - energy)), kAlgebra * (1 + energy));
  }
}

// Would catch: inverse dynamics whose coefficient of qdd is not M, and external forces that are not
// J^T f.
TEST_P(Invariants, InverseDynamicsIsAffineInAccelerationAndForce) {
  const Vector50 tau =
      inverse_dynamics<Digits50>(c_.model, c_.q, c_.qd, c_.qdd, c_.external_points, c_.f_ext);
  const Vector50 expected =
      mass_matrix<Digits50>(c_.model, c_.q) * c_.qdd +
      nonlinear_effects<Digits50>(c_.model, c_.q, c_.qd) -
      jacobian<Digits50>(c_.model, c_.external_points, c_.q).transpose() * c_.f_ext;
  EXPECT_LT(relative_error(tau, expected), kAlgebra);
}

// Would catch: Coriolis forces that do work. qd^T (Mdot - 2 C) qd = 0 with b = C qd.
TEST_P(Invariants, CoriolisForcesMatchTheRateOfM) {
  const auto M = [&](const Digits50& t) {
    return mass_matrix<Digits50>(c_.model, moved(c_.model, c_.q, c_.qd, t));
  };
  const Vector50 b =
      nonlinear_effects<Digits50>(c_.model, c_.q, c_.qd) - gravity<Digits50>(c_.model, c_.q);
  const Vector50 Mdot_qd = derivative(M) * c_.qd;
  EXPECT_LT(Digits50(abs(c_.qd.dot(Mdot_qd) / 2 - c_.qd.dot(b))),
            kDifference * scale(Mdot_qd) * 1000);
}

// Would catch: forward dynamics, by either algorithm, that are not the inverse of inverse dynamics.
TEST_P(Invariants, ForwardDynamicsInvertsInverseDynamics) {
  const Vector50 tau =
      inverse_dynamics<Digits50>(c_.model, c_.q, c_.qd, c_.qdd, c_.external_points, c_.f_ext);
  EXPECT_LT(relative_error(forward_dynamics<Digits50>(c_.model, c_.q, c_.qd, tau,
                                                      c_.external_points, c_.f_ext),
                           c_.qdd),
            kAlgebra);
  EXPECT_LT(relative_error(forward_dynamics_by_mass_matrix<Digits50>(c_.model, c_.q, c_.qd, tau,
                                                                     c_.external_points, c_.f_ext),
                           c_.qdd),
            kAlgebra);
}

// Table 5.3 compared with the definition: nearest common ancestors, floating base, transforms to
// tips.
TEST_P(Invariants, LambdaInverseIsItsDefinition) {
  const auto o = explicit_operational_space<Digits50>(c_.model, c_.points, c_.q);
  EXPECT_LT(relative_error(lambda_inverse<Digits50>(c_.model, c_.points, c_.q), o.Lambda_inverse),
            kAlgebra);
}

// The base's reaction is the rate of change of the whole robot's momentum: internal forces cancel
// (action = reaction), and gravity acts on the whole mass.
TEST_P(FloatingInvariants, MomentumChangesByOutsideForcesOnly) {
  Vector50 tau = c_.tau;
  tau.head<6>().setZero();
  const Vector50 qdd = forward_dynamics<Digits50>(c_.model, c_.q, c_.qd, tau);
  const auto of_time = [&](const Digits50& t) {
    return momentum(c_.model, moved(c_.model, c_.q, c_.qd, t), c_.qd + t * qdd);
  };
  Vector6<Digits50> weight = Vector6<Digits50>::Zero();
  const auto k = kinematics_of(c_, c_.q, c_.qd);
  for (int i = 0; i < c_.model.size(); ++i) {
    const auto& b = c_.model.body(i);
    const Vector3<Digits50> com = k.p_world[i] + k.R_world[i] * b.com;
    const Vector3<Digits50> f = b.mass * c_.model.gravity;
    weight += stack<Digits50>(f, com.cross(f));
  }
  const Vector6<Digits50> rate = derivative(of_time);
  EXPECT_LT(Digits50((rate - weight).cwiseAbs().maxCoeff()), kDifference * scale(qdd) * 1000);
}

}  // namespace
}  // namespace treeline::tests
