#include <gtest/gtest.h>

#include "interpreter/physics.hpp"

// Momentum about the centre of mass, and what subtrees weigh, for random mechanisms. Would catch: a
// moment about another point than the centre, rows in other axes than the world's, a rate that
// leaves out a velocity product or that gravity and external forces do not explain, rotors that
// count as links.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)

class Centroidal : public testing::TestWithParam<NamedOptions> {
 protected:
  [[nodiscard]] Vector3<Digits50> center() const {
    return center_of_mass<Digits50>(c_.model, c_.q);
  }
  [[nodiscard]] Matrix50 A() const { return centroidal_momentum_matrix<Digits50>(c_.model, c_.q); }

  const Case c_ = random_case(GetParam().seed, GetParam().options);
};

std::vector<NamedOptions> mechanisms() {
  std::vector<NamedOptions> list = assorted_mechanisms();
  std::erase_if(list, [](const NamedOptions& named) { return named.options.joints > 30; });
  list.push_back({"rotors", 5, {.joints = 6, .mimic = 0.3, .rotors = 0.7}});
  list.push_back({"rotors_floating", 6, {.joints = 6, .floating_base = true, .rotors = 0.7}});
  return list;
}

class FloatingCentroidal : public Centroidal {};

std::vector<NamedOptions> floating_mechanisms() {
  std::vector<NamedOptions> list = mechanisms();
  std::erase_if(list, [](const NamedOptions& named) { return !named.options.floating_base; });
  for (NamedOptions& named : list) named.options.external_forces = 2;
  return list;
}

std::string test_name(const testing::TestParamInfo<NamedOptions>& tested) {
  return std::string(tested.param.name) + "_" + std::to_string(tested.index);
}

INSTANTIATE_TEST_SUITE_P(Assorted, Centroidal, testing::ValuesIn(mechanisms()), test_name);
INSTANTIATE_TEST_SUITE_P(Assorted, FloatingCentroidal, testing::ValuesIn(floating_mechanisms()),
                         test_name);

TEST_P(Centroidal, MomentumIsThatOfAllBodiesAboutTheCentre) {
  const Vector6<Digits50> about_origin = momentum(c_.model, c_.q, c_.qd);
  Vector6<Digits50> expected = about_origin;
  expected.tail<3>() -= cross(center(), linear(about_origin));
  EXPECT_LT(relative_error(Vector50(A() * c_.qd), expected), kAlgebra);
  EXPECT_LT(relative_error(centroidal_momentum<Digits50>(c_.model, c_.q, c_.qd), expected),
            kAlgebra);
}

TEST_P(Centroidal, UpperRowsAreMassTimesTheJacobianOfTheCentre) {
  const Matrix50 J = center_of_mass_jacobian<Digits50>(c_.model, c_.q);
  EXPECT_LT(relative_error(A().topRows(3), Matrix50(total_mass(c_.model) * J)), kAlgebra);
}

TEST_P(Centroidal, BiasIsTheRateOfTheMatrixTimesVelocity) {
  const auto momentum_at = [&](const Digits50& t) {
    const Vector50 q = moved(c_.model, c_.q, c_.qd, t);
    return Vector50(centroidal_momentum_matrix<Digits50>(c_.model, q) * c_.qd);
  };
  const Vector50 bias = centroidal_bias<Digits50>(c_.model, c_.q, c_.qd);
  EXPECT_LT(relative_error(bias, derivative(momentum_at)), kDifference);
  EXPECT_LT(relative_error(center_of_mass_bias_acceleration<Digits50>(c_.model, c_.q, c_.qd),
                           Vector50(bias.head(3) / total_mass(c_.model))),
            kAlgebra);
}

TEST_P(Centroidal, PointAccelerationIsTheRateOfPointVelocity) {
  const auto velocity = [&](const Digits50& t) {
    return point_velocity<Digits50>(c_.model, c_.points, moved(c_.model, c_.q, c_.qd, t),
                                    c_.qd + t * c_.qdd);
  };
  EXPECT_EQ(velocity(0).size(), 6 * static_cast<int>(c_.points.size()));
  EXPECT_LT(relative_error(point_acceleration<Digits50>(c_.model, c_.points, c_.q, c_.qd, c_.qdd),
                           derivative(velocity)),
            kDifference);
}

// A subtree is its root with the subtrees of the root's children.
TEST_P(Centroidal, SubtreesAddUp) {
  const auto k = kinematics_of(c_, c_.q, c_.qd);
  const auto all = subtrees<Digits50>(c_.model, c_.q);
  Digits50 whole = 0;
  Vector3<Digits50> whole_moment = Vector3<Digits50>::Zero();
  for (int i = 0; i < c_.model.size(); ++i) {
    const auto& body = c_.model.body(i);
    Digits50 mass = body.mass;
    Vector3<Digits50> moment = body.mass * (k.p_world[i] + k.R_world[i] * body.com);
    for (int child = i + 1; child < c_.model.size(); ++child) {
      if (c_.model.body(child).parent != i) continue;
      const auto& own = all[static_cast<std::size_t>(child)];
      mass += own.mass;
      moment += own.mass * own.center;
    }
    const auto& [subtree_mass, subtree_center] = all[static_cast<std::size_t>(i)];
    EXPECT_LT(Digits50(abs(subtree_mass - mass)), kAlgebra * 100);
    const Vector3<Digits50> expected = mass == 0 ? k.p_world[i] : Vector3<Digits50>(moment / mass);
    EXPECT_LT(relative_error(subtree_center, expected), kAlgebra);
    if (body.parent == kWorld) {
      whole += mass;
      whole_moment += moment;
    }
  }
  EXPECT_LT(relative_error(Vector3<Digits50>(whole_moment / whole), center()), kAlgebra);
}

// In free motion only gravity and external forces change the momentum, whatever the joints do.
TEST_P(FloatingCentroidal, RateOfMomentumIsWeightAndExternalForces) {
  Vector50 tau = c_.tau;
  tau.head(6).setZero();
  const Vector50 qdd =
      forward_dynamics<Digits50>(c_.model, c_.q, c_.qd, tau, c_.external_points, c_.f_ext);
  Vector6<Digits50> expected = Vector6<Digits50>::Zero();
  expected.head<3>() = total_mass(c_.model) * c_.model.gravity;
  int at = 0;
  for (const auto& pose : forward_kinematics<Digits50>(c_.model, c_.external_points, c_.q)) {
    const bool local =
        c_.external_points[static_cast<std::size_t>(at / 6)].axes == PointAxes::local;
    const Matrix3<Digits50> axes =
        local ? pose.rotation : Matrix3<Digits50>(Matrix3<Digits50>::Identity());
    const Vector3<Digits50> f = axes * c_.f_ext.segment<3>(at);
    const Vector3<Digits50> n = axes * c_.f_ext.segment<3>(at + 3);
    expected += stack<Digits50>(f, n + cross<Digits50>(pose.position - center(), f));
    at += 6;
  }
  const Vector50 rate = A() * qdd + centroidal_bias<Digits50>(c_.model, c_.q, c_.qd);
  EXPECT_LT(relative_error(rate, expected), kAlgebra * 1000 * scale(qdd));
}

// The base's rows of M are the momentum in its frame.
TEST_P(FloatingCentroidal, MatrixIsTheBasesRowsOfTheMassMatrix) {
  const Matrix50 M = mass_matrix<Digits50>(c_.model, c_.q);
  const auto k = kinematics_of(c_, c_.q, c_.qd);
  const Matrix3<Digits50>& R = k.R_world[0];
  const Vector3<Digits50> arm = k.p_world[0] - center();
  Matrix50 expected(6, c_.model.nv);
  expected.topRows(3) = R * M.topRows(3);
  expected.bottomRows(3) = R * M.middleRows(3, 3) + cross_matrix(arm) * expected.topRows(3);
  EXPECT_LT(relative_error(A(), expected), kAlgebra);
}

}  // namespace
}  // namespace treeline::tests
