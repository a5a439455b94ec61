#include <gtest/gtest.h>

#include "interpreter/physics.hpp"

// The Coriolis matrix and the energies of the interpreter against physics, in 50 digits. Would
// catch: a Christoffel symbol with its indices exchanged, brackets of body velocities that are
// missing or have the wrong sign, a mimic joint without its multiplier, energies that forces do not
// change as they should.

namespace treeline::tests {
namespace {

namespace ip = interpreter;

class Coriolis : public testing::TestWithParam<NamedOptions> {
 protected:
  const Case c_ = random_case(GetParam().seed, GetParam().options);
};

/// Mechanisms of few joints: the derivatives of M take as many mass matrices as there are
/// velocities.
std::vector<NamedOptions> small_mechanisms() {
  std::vector<NamedOptions> list = assorted_mechanisms();
  std::erase_if(list, [](const NamedOptions& named) { return named.options.joints > 10; });
  return list;
}

INSTANTIATE_TEST_SUITE_P(Assorted, Coriolis, testing::ValuesIn(small_mechanisms()),
                         [](const testing::TestParamInfo<NamedOptions>& tested) {
                           return std::string(tested.param.name) + "_" +
                                  std::to_string(tested.index);
                         });

void expect_factorisation(const Model50& model, const Vector50& q, const Vector50& qd) {
  const Matrix50 C = ip::coriolis_matrix<Digits50>(model, q, qd);
  const Vector50 b =
      ip::nonlinear_effects<Digits50>(model, q, qd) - ip::gravity<Digits50>(model, q);
  EXPECT_LT(relative_error(Vector50(C * qd), b), kAlgebra);
  const auto M_at = [&](const Digits50& t) {
    return ip::mass_matrix<Digits50>(model, moved(model, q, qd, t));
  };
  const Matrix50 rate = derivative(M_at);
  EXPECT_LT(relative_error(Matrix50(C + C.transpose()), rate), kDifference);
}

TEST_P(Coriolis, MatrixTakesVelocitiesToForcesAndLeavesASkewMatrix) {
  expect_factorisation(c_.model, c_.q, c_.qd);
}

TEST_P(Coriolis, KineticEnergyIsThatOfTheMassMatrix) {
  const Matrix50 M = ip::mass_matrix<Digits50>(c_.model, c_.q);
  const Digits50 expected = c_.qd.dot(Vector50(M * c_.qd)) / 2;
  const Digits50 energy = ip::kinetic_energy<Digits50>(c_.model, c_.q, c_.qd);
  EXPECT_LT(Digits50(abs(energy - expected)), kAlgebra * (1 + expected));
}

TEST_P(Coriolis, GravityIsTheGradientOfThePotentialEnergy) {
  const Digits50 rate = derivative([&](const Digits50& t) {
    return ip::potential_energy<Digits50>(c_.model, moved(c_.model, c_.q, c_.qd, t));
  });
  const Vector50 g = ip::gravity<Digits50>(c_.model, c_.q);
  EXPECT_LT(Digits50(abs(rate - g.dot(c_.qd))), kDifference * (1 + g.norm() * c_.qd.norm()));
}

TEST_P(Coriolis, PowerIsTheRateOfBothEnergies) {
  const Vector50 tau = ip::inverse_dynamics<Digits50>(c_.model, c_.q, c_.qd, c_.qdd);
  const auto energy = [&](const Digits50& t) {
    const Vector50 q = moved(c_.model, c_.q, c_.qd, t);
    return Digits50(ip::kinetic_energy<Digits50>(c_.model, q, Vector50(c_.qd + t * c_.qdd)) +
                    ip::potential_energy<Digits50>(c_.model, q));
  };
  EXPECT_LT(Digits50(abs(tau.dot(c_.qd) - derivative(energy))),
            kDifference * (1 + abs(energy(0))) * 1000);
}

// Joints that no URDF has.
TEST(CoriolisMatrix, OfSphericalJoints) {
  Case c = random_case(5, {.joints = 4, .mix = {1, 0, 1, 0, 0, 1}});
  Model50 model;
  for (ip::Body<Digits50> body : c.model.bodies) {
    if (body.kind == ip::JointKind::revolute) body.kind = ip::JointKind::spherical;
    add_body(model, body);
  }
  Rng rng(17);
  const Vector50 q = random_position(rng, model);
  expect_factorisation(model, q, random_entries<Digits50>(rng, model.nv, 4));
}

}  // namespace
}  // namespace treeline::tests
