// Friction and springs of joints, compared with closed forms. Would catch: a smooth sign of another
// slope or limit, a derivative that is not its own, friction that drives, a spring that pushes away
// from its rest, either of them in a function that shall have none or missing in one that shall
// have it, and a joint that mimics whose coordinate feels too much. The other files of this folder
// compare all functions on random robots with the interpreter.
#include "recursion/tree/joint_drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "description/read_urdf.hpp"
#include "interpreter/dual.hpp"
#include "interpreter/instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "random_mechanism.hpp"
#include "recursion/template_results.hpp"

namespace treeline::tests {
namespace {

using interpreter::Dual;
using V = interpreter::Vector<double>;

/// tanh(128 artanh y) = (r - 1) / (r + 1) with y = x / 128 and r = ((1 + y) / (1 - y))^128.
Digits50 closed_form(const Digits50& x) {
  Digits50 plus(1), minus(1);
  for (int i = 0; i < 128; ++i) {
    plus *= 1 + x / 128;
    minus *= 1 - x / 128;
  }
  return (plus - minus) / (plus + minus);
}

TEST(SmoothSign, IsItsClosedForm) {
  for (const double x : {1e-3, 0.1, 0.5, 1.0, 3.0, 17.0, 100.0, 127.0}) {
    const Digits50 expected = closed_form(x);
    EXPECT_LT(abs(Digits50(smooth_sign<Digits50>(x).value - expected)), 1e-45) << x;
    EXPECT_LT(abs(Digits50(interpreter::smooth_sign<Digits50>(x) - expected)), 1e-45) << x;
    // Four steps of a few operations each.
    EXPECT_NEAR(smooth_sign<double>(x).value, static_cast<double>(expected), 8 * 0x1p-52) << x;
  }
}

TEST(SmoothSign, IsNearTheHyperbolicTangent) {
  for (double x = 1e-9; x < 2600; x *= 1.3) {
    EXPECT_NEAR(smooth_sign<double>(x).value, std::tanh(x), 1.3e-5) << x;
  }
  for (double x = 3.1; x < 5461; x *= 1.1) EXPECT_GT(smooth_sign<double>(x).value, 0.995) << x;
}

TEST(SmoothSign, IsOddBoundedAndFiniteEverywhere) {
  EXPECT_EQ(smooth_sign<double>(0).value, 0);
  EXPECT_EQ(smooth_sign<double>(0).slope, 1);
  EXPECT_EQ(smooth_sign<double>(128).value, 1);
  for (double x = 1e-300; x < 1e102; x *= 7) {
    const auto plus = smooth_sign<double>(x), minus = smooth_sign<double>(-x);
    EXPECT_EQ(plus.value, -minus.value) << x;
    EXPECT_EQ(plus.slope, minus.slope) << x;
    EXPECT_LE(std::abs(plus.value), 1) << x;
    EXPECT_TRUE(std::isfinite(plus.slope)) << x;
  }
}

TEST(SmoothSign, HasTheSlopeOfItsValue) {
  for (const double x : {0.0, 1e-8, 0.3, 1.0, 2.5, 12.0, 127.9, 128.1, 400.0, 1e5}) {
    const Dual<Digits50> moving(Digits50(x), Digits50(1));
    const Digits50 expected = interpreter::smooth_sign<Dual<Digits50>>(moving).slope;
    EXPECT_LT(abs(Digits50(smooth_sign<Digits50>(x).slope - expected)), 1e-44) << x;
  }
}

/// A wheel of 0.5 kg m^2 and a slide of 3 kg that follows it: position = 2 q + 0.1.
Robot wheel_and_slide() {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(
      "<robot name='r'><link name='base'/>"
      "<link name='wheel'><inertial><mass value='1'/>"
      "<inertia ixx='0.5' ixy='0' ixz='0' iyy='0.5' iyz='0' izz='0.5'/></inertial></link>"
      "<link name='slide'><inertial><mass value='3'/>"
      "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link>"
      "<joint name='turn' type='continuous'><parent link='base'/><child link='wheel'/>"
      "<axis xyz='0 1 0'/></joint>"
      "<joint name='push' type='prismatic'><parent link='base'/><child link='slide'/>"
      "<axis xyz='1 0 0'/><limit lower='-9' upper='9' effort='9' velocity='9'/>"
      "<mimic joint='turn' multiplier='2' offset='0.1'/></joint></robot>",
      "r.urdf", diagnostics);
  EXPECT_TRUE(robot);
  return robot.value();
}

Scene scene_with_drives() {
  Scene scene;
  scene.base = Base::fixed;
  scene.joint_friction = {{"turn", {0.4, 1.5, 0.2}}, {"push", {0.7, 0.9, 0.3}}};
  scene.joint_springs = {{"turn", {6, 0.25}}, {"push", {11, -0.2}}};
  return scene;
}

TEST(JointDrive, AddsFrictionAndSpringsWhereTheyBelong) {
  const Robot robot = wheel_and_slide();
  const Scene scene = scene_with_drives();
  const auto model = model_from_robot<double>(robot, scene);
  const Mechanism mechanism = reduced_mechanism(robot, scene);
  const double M = 0.5 + 4 * 3;
  for (const double q : {-1.2, 0.0, 0.6}) {
    for (const double qd : {-3.0, -0.05, 0.0, 0.4}) {
      const double qdd = 1.7;
      const double friction =
          0.4 * qd + 1.5 * std::tanh(qd / 0.2) + 2 * (0.7 * 2 * qd + 0.9 * std::tanh(2 * qd / 0.3));
      const double spring = 6 * (q - 0.25) + 2 * 11 * (2 * q + 0.1 + 0.2);
      const double energy = 3 * std::pow(q - 0.25, 2) + 5.5 * std::pow(2 * q + 0.1 + 0.2, 2);
      Inputs<double> in{{q}, {qd}, {qdd}, {M * qdd + friction + spring}, {}, {}};
      const TemplateRun<double> run(mechanism, in);
      const auto result = [&](Function function) {
        return run.results(function).front().results.front().front();
      };
      constexpr double kTanh = 4e-5;  // the smooth sign is no tanh
      EXPECT_NEAR(result(Function::inverse_dynamics), M * qdd + friction + spring, kTanh);
      EXPECT_NEAR(result(Function::nonlinear_effects), friction + spring, kTanh);
      EXPECT_NEAR(result(Function::forward_dynamics), qdd, kTanh);
      EXPECT_NEAR(result(Function::gravity), spring, 1e-13);
      EXPECT_NEAR(result(Function::mass_matrix), M, 1e-13);
      EXPECT_NEAR(result(Function::coriolis_matrix), 0, 1e-13);
      EXPECT_NEAR(result(Function::kinetic_energy), M * qd * qd / 2, 1e-12);
      EXPECT_NEAR(result(Function::potential_energy), energy, 1e-12);
      const V at = V::Constant(1, q), rate = V::Constant(1, qd);
      EXPECT_NEAR(interpreter::nonlinear_effects<double>(model, at, rate)(0), friction + spring,
                  kTanh);
      EXPECT_NEAR(interpreter::gravity<double>(model, at)(0), spring, 1e-13);
      EXPECT_NEAR(interpreter::potential_energy<double>(model, at), energy, 1e-12);
    }
  }
}

// dU/dq = g and d(T + U)/dt = qd (tau - friction), which is never more than without friction.
TEST(JointDrive, DissipatesWhatFrictionTakes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    RandomOptions options;
    options.joints = 5;
    options.mix.floating = options.mix.planar = 0;
    options.rotors = options.drives = 0.7;
    const RandomMechanism made = random_mechanism(seed, options);
    const auto model = model_from_robot<Digits50>(made.robot, made.scene);
    Rng rng(seed);
    using Numbers = interpreter::Vector<Digits50>;
    const Numbers q = random_position(rng, model, 2.0),
                  qd = random_entries<Digits50>(rng, model.nv, 3);
    const Digits50 h("1e-18");
    const auto U = [&](const Numbers& at) {
      return interpreter::potential_energy<Digits50>(model, at);
    };
    const auto T = [&](const Numbers& at, const Numbers& rate) {
      return interpreter::kinetic_energy<Digits50>(model, at, rate);
    };
    const Numbers zero = Numbers::Zero(model.nv);
    const Numbers qdd = interpreter::forward_dynamics<Digits50>(model, q, qd, zero);
    const Numbers after = q + h * qd, before = q - h * qd;
    const Numbers faster = qd + h * qdd, slower = qd - h * qdd;
    const Digits50 weight = qd.dot(interpreter::gravity<Digits50>(model, q));
    EXPECT_LT(abs(Digits50((U(after) - U(before)) / (2 * h) - weight)), 1e-28 * (1 + abs(weight)));
    const Digits50 power = (T(after, faster) + U(after) - T(before, slower) - U(before)) / (2 * h);
    auto frictionless = model;
    for (auto& body : frictionless.bodies) body.damping = body.friction = 0;
    const Digits50 lost =
        qd.dot(Numbers(interpreter::nonlinear_effects<Digits50>(model, q, qd) -
                       interpreter::nonlinear_effects<Digits50>(frictionless, q, qd)));
    EXPECT_GE(lost, 0);
    EXPECT_LT(abs(Digits50(power + lost)), 1e-28 * (1 + lost + abs(weight)));
  }
}

}  // namespace
}  // namespace treeline::tests
