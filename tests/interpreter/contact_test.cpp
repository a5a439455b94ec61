#include <gtest/gtest.h>

#include <iostream>

#include "interpreter/physics.hpp"
#include "interpreter/propagate_inertia.hpp"

// Contact by Chang chapter 8, compared with its definitions by M and J in O(n^3), and with momentum
// and energy, in 50 digits, for chains and trees with every joint type. Would catch: a wrong
// propagator, a branch beside the struck path that is left out, impulses in the wrong axes or at
// the wrong point, and restitution that is applied to a speed instead of along the normal.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)
using interpreter::JointKind;

using Vector3_50 = Vector3<Digits50>;

/// Robots with a spherical joint, which no URDF has. It carries body 1 and is followed by a hinge
/// and a prismatic joint.
Case case_with_ball_joint(std::uint64_t seed, JointKind base) {
  Case c;
  Rng rng(seed);
  for (const JointKind kind : {base, JointKind::spherical, JointKind::revolute,
                               JointKind::spherical, JointKind::prismatic}) {
    Body<Digits50> body;
    body.parent = c.model.size() - (c.model.size() == 3 ? 2 : 1);
    body.kind = kind;
    body.p_parent_joint = random_entries<Digits50>(rng, 3, 0.5);
    body.mass = Digits50(rng.uniform(1, 4));
    body.com = random_entries<Digits50>(rng, 3, 0.2);
    const auto C = cross_matrix(body.com);
    body.inertia = Vector3_50(Digits50(0.1), Digits50(0.2), Digits50(0.25)).asDiagonal();
    body.inertia -= body.mass * (C * C);
    add_body(c.model, body);
  }
  c.q = random_position(rng, c.model);
  c.qd = random_entries<Digits50>(rng, c.model.nv, 4);
  return c;
}

struct Struck {
  Case c;
  Points50 contacts;
  Vector50 impulses, normals;
};

/// Contacts on the last body, its parent, the first body, and any two bodies.
Struck struck(Case c, std::uint64_t seed) {
  Struck s;
  Rng rng(seed + 31);
  const int last = c.model.size() - 1;
  for (const int body : {last, std::max(0, c.model.body(last).parent), 0, rng.below(last + 1),
                         rng.below(last + 1)}) {
    s.contacts.push_back(contact_point<Digits50>(body, random_entries<Digits50>(rng, 3, 0.5)));
  }
  s.impulses = random_entries<Digits50>(rng, 15, 5);
  s.normals = random_entries<Digits50>(rng, 15, 1);
  for (int i = 0; i < 15; i += 3) s.normals.segment<3>(i).normalize();
  s.c = std::move(c);
  return s;
}

Matrix50 M_inverse(const Case& c) {
  return mass_matrix<Digits50>(c.model, c.q)
      .fullPivLu()
      .solve(Matrix50::Identity(c.model.nv, c.model.nv));
}

/// Difference relative to the entries' own size, however small.
template <class A, class B>
Digits50 error_of(const Eigen::MatrixBase<A>& actual, const Eigen::MatrixBase<B>& expected) {
  const Digits50 size = expected.cwiseAbs().maxCoeff();
  const Digits50 off = (actual - expected).cwiseAbs().maxCoeff();
  return off == 0 ? off : Digits50(off / size);
}

Matrix50 link_jacobian(const Case& c, int body) {
  OperationalPoint<Digits50> origin;
  origin.body = body;
  origin.axes = PointAxes::local;
  return jacobian<Digits50>(c.model, {origin}, c.q);
}

void expect_definitions(const Struck& s) {
  const Case& c = s.c;
  const Matrix50 inverse = M_inverse(c);
  const auto Omega = link_inverse_inertias<Digits50>(c.model, c.q);
  for (int i = 0; i < c.model.size(); ++i) {
    const Matrix50 J = link_jacobian(c, i);
    EXPECT_LT(error_of(Omega[i], Matrix50(J * inverse * J.transpose())), kAlgebra) << "body " << i;
  }
  const Matrix50 J = jacobian<Digits50>(c.model, s.contacts, c.q);
  const Matrix50 A = J * inverse * J.transpose();
  EXPECT_LT(error_of(contact_inverse_inertia<Digits50>(c.model, s.contacts, c.q), A), kAlgebra);
  const Vector50 masses = effective_masses<Digits50>(c.model, s.contacts, c.q, s.normals);
  for (int i = 0; i < 5; ++i) {
    const Vector3_50 n = s.normals.segment<3>(3 * i);
    const Digits50 per_mass = n.dot(Vector3_50(A.block(3 * i, 3 * i, 3, 3) * n));
    if (per_mass < 1e-30) continue;  // a body that cannot move along n
    EXPECT_LT(abs(masses(i) * per_mass - 1), kAlgebra) << "contact " << i;
  }
  const auto response = impulse_response<Digits50>(c.model, s.contacts, c.q, s.impulses);
  EXPECT_LT(error_of(response.dqd, Vector50(inverse * J.transpose() * s.impulses)), kAlgebra);
  for (int i = 0; i < c.model.size(); ++i) {
    EXPECT_LT(relative_error(response.dv[i], Vector50(link_jacobian(c, i) * response.dqd)),
              kAlgebra);
  }
  const auto motion = contact_motion<Digits50>(c.model, s.contacts, c.q, c.qd);
  EXPECT_LT(relative_error(motion.velocity, Vector50(J * c.qd)), kAlgebra);
  const auto poses = forward_kinematics<Digits50>(c.model, s.contacts, c.q);
  for (std::size_t i = 0; i < 5; ++i) {
    const Vector3_50 at = motion.position.segment<3>(3 * static_cast<int>(i));
    EXPECT_LT(relative_error(at, poses[i].position), kAlgebra);
  }
}

class Contact : public testing::TestWithParam<NamedOptions> {};

INSTANTIATE_TEST_SUITE_P(Assorted, Contact, testing::ValuesIn(assorted_mechanisms()),
                         [](const testing::TestParamInfo<NamedOptions>& tested) {
                           return std::string(tested.param.name) + "_" +
                                  std::to_string(tested.index);
                         });

TEST_P(Contact, IsWhatMassMatrixAndJacobianSay) {
  Case c = random_case(GetParam().seed, GetParam().options);
  if (c.model.nv == 0) return;
  expect_definitions(struck(std::move(c), GetParam().seed));
}

TEST(Contact, OfRobotsWithBallJoints) {
  for (const JointKind base : {JointKind::revolute, JointKind::floating, JointKind::spherical}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      expect_definitions(struck(case_with_ball_joint(seed, base), seed));
    }
  }
}

// One blow with restitution: v_n becomes -e v_n, and the energy falls by (1 - e^2) / 2 of the
// effective mass times the squared approach. Valid for every robot, including mimics.
TEST_P(Contact, BlowCostsWhatRestitutionSays) {
  Case drawn = random_case(GetParam().seed, GetParam().options);
  if (drawn.model.nv == 0) return;
  const Struck s = struck(std::move(drawn), GetParam().seed);
  const Case& c = s.c;
  const Vector50 masses = effective_masses<Digits50>(c.model, s.contacts, c.q, s.normals);
  const Vector50 before = contact_motion<Digits50>(c.model, s.contacts, c.q, c.qd).velocity;
  const Digits50 energy = kinetic_energy(c.model, c.q, c.qd);
  for (int i = 0; i < 5; ++i) {
    if (!(masses(i) < 1e15)) continue;
    const Digits50 e("0.3");
    const Vector3_50 n = s.normals.segment<3>(3 * i);
    const Vector3_50 v = before.segment<3>(3 * i);
    const Points50 at{s.contacts[static_cast<std::size_t>(i)]};
    const Vector50 y = restitution_impulse(n, v, masses(i), e);
    const Vector50 qd = c.qd + impulse_response<Digits50>(c.model, at, c.q, y).dqd;
    const Vector3_50 after = contact_motion<Digits50>(c.model, at, c.q, qd).velocity;
    EXPECT_LT(abs(n.dot(after) + e * n.dot(v)), kAlgebra * scale(before));
    const Digits50 lost = (1 - e * e) / 2 * masses(i) * n.dot(v) * n.dot(v);
    EXPECT_LT(abs(energy - kinetic_energy(c.model, c.q, qd) - lost),
              kAlgebra * scale(c.qd) * energy);
  }
}

// A body that nothing holds receives the whole impulse, and its moment about any point.
TEST(Contact, ImpulsesChangeAFreeRobotsMomentumByThemselves) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(seed);
    Case c = seed == 8 ? case_with_ball_joint(seed, JointKind::floating)
                       : random_case(seed, {.joints = 9,
                                            .branching = seed % 2 == 0 ? 0.5 : 0,
                                            .floating_base = true,
                                            .mimic = seed % 3 == 0 ? 0.4 : 0});
    const Struck s = struck(std::move(c), seed);
    const auto response = impulse_response<Digits50>(s.c.model, s.contacts, s.c.q, s.impulses);
    const Vector50 position =
        contact_motion<Digits50>(s.c.model, s.contacts, s.c.q, s.c.qd).position;
    Vector6<Digits50> total = Vector6<Digits50>::Zero();
    for (int i = 0; i < 15; i += 3) {
      const Vector3_50 y = s.impulses.segment<3>(i);
      const Vector3_50 at = position.segment<3>(i);
      total += stack<Digits50>(y, at.cross(y));
    }
    const Vector6<Digits50> gained =
        momentum(s.c.model, s.c.q, s.c.qd + response.dqd) - momentum(s.c.model, s.c.q, s.c.qd);
    EXPECT_LT(relative_error(gained, total), kAlgebra);
  }
}

// A free rigid body: 1 / (1/m + (r x n) J_c^-1 (r x n)).
TEST(EffectiveMass, OfAFreeBodyIsTheTextbooks) {
  Model50 model;
  Body<Digits50> body;
  body.kind = JointKind::floating;
  body.mass = 3;
  body.inertia = Vector3_50(2, 4, 5).asDiagonal();
  add_body(model, body);
  Vector50 q = Vector50::Zero(7);
  q(6) = 1;
  const Points50 contact{contact_point<Digits50>(0, Vector3_50(0, 1, 0))};
  const auto mass = [&](const Vector3_50& n) {
    return effective_masses<Digits50>(model, contact, q, Vector50(n))(0);
  };
  const Digits50 third = Digits50(1) / 3;
  EXPECT_LT(abs(mass(Vector3_50::UnitX()) - 1 / (third + Digits50(1) / 5)), kAlgebra);
  EXPECT_LT(abs(mass(Vector3_50::UnitY()) - 3), kAlgebra);
  EXPECT_LT(abs(mass(Vector3_50::UnitZ()) - 1 / (third + Digits50(1) / 2)), kAlgebra);
}

// Table 8.1 gives the inverse of the result of the inverse recursion, for chains and trees on a
// floating base; on a fixed base up to the effect of the big base.
TEST(LinkInertias, InvertTheInverseInertias) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    const bool floating = seed % 3 != 0;
    const Case c = random_case(seed, {.joints = 8,
                                      .branching = seed % 2 == 0 ? 0.5 : 0,
                                      .mix = {5, 1, 2, 1, 0.5, 0.5},
                                      .floating_base = floating});
    const Digits50 base = pow(Digits50(10), 12);
    const auto Lambda = link_inertias<Digits50>(c.model, c.q, base);
    const auto Omega = link_inverse_inertias<Digits50>(c.model, c.q);
    const Digits50 bound = floating ? kAlgebra : Digits50(1e4 / base);
    for (int i = 0; i < c.model.size(); ++i) {
      const Matrix50 unit = Lambda[i] * Omega[i];
      if (floating) {
        EXPECT_LT(relative_error(unit, Matrix50::Identity(6, 6)), bound) << "body " << i;
      }
      const Matrix50 inverse =
          Matrix50(Lambda[i]).ldlt().solve(Matrix50::Identity(6, 6)) - Matrix50(Omega[i]);
      EXPECT_LT(scale(inverse, Digits50("1e-60")), bound * scale(Omega[i])) << "body " << i;
    }
  }
}

struct Errors {
  double table = 0, inverse_recursion = 0;
};

/// Ways to make a chain more difficult than it was drawn.
enum class Hardship { heavy_tip, compact_bodies };

void make_harder(Hardship hardship, double ratio, Model50& model) {
  if (hardship == Hardship::heavy_tip) {
    model.bodies.back().mass *= ratio;
    model.bodies.back().inertia *= Digits50(ratio);
    return;
  }
  for (Body<Digits50>& body : model.bodies) {
    body.com /= Digits50(ratio);
    body.inertia /= Digits50(ratio * ratio);
  }
}

/// Largest errors in double of Lambda_i^-1 over all bodies of a floating chain: by inverting table
/// 8.1, and by the inverse recursion.
Errors errors_in_double(std::uint64_t seed, Hardship hardship, double ratio) {
  Case c = random_case(
      seed, {.joints = 8, .branching = 0, .mix = {1, 0, 0, 0, 0, 0}, .floating_base = true});
  make_harder(hardship, ratio, c.model);
  const auto model = cast<double>(c.model);
  const Vector<double> q = c.q.cast<double>();
  // Both use the same doubles as inputs, so that only arithmetic differs.
  const auto truth = link_inverse_inertias<Digits50>(cast<Digits50>(model), q.cast<Digits50>());
  const auto by_table = link_inertias<double>(model, q, 1);
  const auto by_inverse = link_inverse_inertias<double>(model, q);
  Errors errors;
  for (int i = 0; i < model.size(); ++i) {
    const Matrix<double> inverse =
        Matrix<double>(by_table[i]).fullPivLu().solve(Matrix<double>::Identity(6, 6));
    const auto error = [&](const Matrix<double>& m) {
      return static_cast<double>(error_of(m.cast<Digits50>(), truth[i]));
    };
    errors.table = std::max(errors.table, error(inverse));
    errors.inverse_recursion = std::max(errors.inverse_recursion, error(by_inverse[i]));
  }
  return errors;
}

std::vector<Errors> measured(Hardship hardship, const char* name) {
  std::vector<Errors> all;
  for (const double ratio : {1.0, 1e1, 1e2, 1e3, 1e4}) {
    Errors worst;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const Errors errors = errors_in_double(seed, hardship, ratio);
      worst.table = std::max(worst.table, errors.table);
      worst.inverse_recursion = std::max(worst.inverse_recursion, errors.inverse_recursion);
    }
    std::cout << name << " by " << ratio << ": table 8.1 off by " << worst.table
              << ", inverse recursion by " << worst.inverse_recursion << '\n';
    all.push_back(worst);
  }
  return all;
}

// If inertias differ only in mass, the subtraction in table 8.1 costs nothing: its loss is small
// compared with the body's own articulated inertia, and both ways have the digits of that inertia.
// If bodies are small compared with the distance between them, the rest is the difference of
// numbers that grow with the square of that distance, and the table loses some two digits more than
// the inverse recursion, which subtracts nothing.
TEST(LinkInertias, LoseDigitsByTheirSubtractionWhereBodiesAreCompact) {
  for (const Errors& errors : measured(Hardship::heavy_tip, "tip heavier")) {
    EXPECT_LT(errors.table, 10 * errors.inverse_recursion);
    EXPECT_LT(errors.inverse_recursion, 10 * errors.table);
  }
  const auto compact = measured(Hardship::compact_bodies, "bodies more compact");
  for (std::size_t i = 1; i < compact.size(); ++i) {
    EXPECT_GT(compact[i].table, 20 * compact[i].inverse_recursion);
  }
}

}  // namespace
}  // namespace treeline::tests
