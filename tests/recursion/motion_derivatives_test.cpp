#include <gtest/gtest.h>

#include "mechanism/build_mechanism.hpp"
#include "mechanism/find_limbs.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/central_differences.hpp"
#include "recursion/checked_programs.hpp"
#include "recursion/methods/centroidal_derivatives.hpp"
#include "recursion/methods/kinetic_energy_derivatives.hpp"
#include "recursion/methods/point_motion_derivatives.hpp"
#include "recursion/seeded.hpp"
#include "recursion/tree/deferred_rotations.hpp"

// Derivatives of the motion of points, of the momentum about the centre of mass and of the kinetic
// energy on reduced mechanisms, compared with central differences of the interpreter in 50 digits
// for the robot as written in the files. Would catch: a wrong term for any joint type, axes of a
// floating or ball joint that do not turn with the link, a centre of mass that stays, rotors that
// have momentum or no energy, a mimic joint without its multiplier, and digits that are lost where
// a floating base is far. The interpreter's own derivatives, which `check` uses, are compared with
// the same differences.

namespace treeline::tests {
namespace {

namespace ip = interpreter;

std::vector<Seeded> motion_derivatives_robots() {
  std::vector<Seeded> all;
  const auto add = [&](RandomOptions options, int seeds) {
    options.operational_points = 2;
    options.all_rows = false;
    for (int i = 0; i < seeds; ++i) all.push_back({4300 + all.size(), options});
  };
  add({.joints = 1}, 2);
  add({.joints = 7, .branching = 0}, 3);
  add({.joints = 8, .branching = 0.4, .locked = 0.2}, 3);
  add({.joints = 6, .branching = 0.4, .floating_base = true, .massless = 0.3}, 4);
  add({.joints = 8, .branching = 0.4, .mimic = 0.4, .locked = 0.1}, 4);
  add({.joints = 6, .branching = 0.3, .mimic = 0.2, .rotors = 0.7}, 3);
  add({.joints = 5, .branching = 0.2, .mix = {2, 0, 1, 1, 1, 4}}, 3);     // planar
  add({.joints = 5, .branching = 0.2, .mix = {2, 0, 2, 1, 3, 3}}, 4);     // floating joints within
  add({.joints = 6, .branching = 0.2, .mix = {3, 1, 2, 1, 1, 1, 5}}, 4);  // balls
  add({.joints = 4, .branching = 0.3, .mix = {2, 0, 1, 1, 0, 0, 5}, .floating_base = true}, 3);
  return all;
}

constexpr std::array kMotionDerivatives = {
    Function::point_velocity_derivatives, Function::point_acceleration_derivatives,
    Function::centroidal_momentum_derivatives, Function::centroidal_momentum_rate_derivatives,
    Function::kinetic_energy_derivatives};

Results<Digits50> listed_all(const ip::DynamicsDerivatives<Digits50>& d) {
  Results<Digits50> results{listed(d.by_displacement), listed(d.by_velocity)};
  if (d.by_drive.size() > 0) results.push_back(listed(d.by_drive));
  return results;
}

class MotionDerivatives : public testing::TestWithParam<Seeded> {
 protected:
  MotionDerivatives()
      : made_(random_mechanism(GetParam().seed, GetParam().options)),
        mechanism_(reduced_mechanism(made_.robot, made_.scene)),
        model_(model_from_robot<Digits50>(made_.robot, made_.scene)),
        points_(points_from_scene(model_, made_.scene.operational_points)) {
    Rng rng(GetParam().seed + 7);
    const Oracle<Digits50> oracle(made_.robot, made_.scene);
    in_ = oracle.random_inputs(rng, 2);
    q_ = vector(in_.q), qd_ = vector(in_.qd), qdd_ = vector(in_.qdd);
  }

  static Vector50 vector(const std::vector<Digits50>& values) {
    return Eigen::Map<const Vector50>(values.data(), static_cast<Eigen::Index>(values.size()));
  }

  /// What the function differentiates.
  [[nodiscard]] Vector50 value(Function function, const Vector50& q, const Vector50& qd,
                               const Vector50& qdd) const {
    switch (function) {
      case Function::point_velocity_derivatives:
        return ip::point_velocity<Digits50>(model_, points_, q, qd);
      case Function::point_acceleration_derivatives:
        return ip::point_acceleration<Digits50>(model_, points_, q, qd, qdd);
      case Function::centroidal_momentum_derivatives:
        return ip::centroidal_momentum<Digits50>(model_, q, qd);
      case Function::centroidal_momentum_rate_derivatives:
        return ip::centroidal_momentum_matrix<Digits50>(model_, q) * qdd +
               ip::centroidal_bias<Digits50>(model_, q, qd);
      default:
        return Vector50::Constant(1, ip::kinetic_energy<Digits50>(model_, q, qd));
    }
  }

  [[nodiscard]] Results<Digits50> by_differences(Function function) const {
    const int n = model_.nv;
    Results<Digits50> results{
        listed(differences(
            n, [&](auto d) { return value(function, displaced(model_, q_, d), qd_, qdd_); })),
        listed(
            differences(n, [&](auto d) { return value(function, q_, Vector50(qd_ + d), qdd_); }))};
    if (takes(function, Quantity::qdd)) {
      results.push_back(listed(
          differences(n, [&](auto d) { return value(function, q_, qd_, Vector50(qdd_ + d)); })));
    }
    return results;
  }

  [[nodiscard]] Results<Digits50> interpreted(Function function) const {
    switch (function) {
      case Function::point_velocity_derivatives:
        return listed_all(ip::point_velocity_derivatives<Digits50>(model_, points_, q_, qd_));
      case Function::point_acceleration_derivatives:
        return listed_all(
            ip::point_acceleration_derivatives<Digits50>(model_, points_, q_, qd_, qdd_));
      case Function::centroidal_momentum_derivatives:
        return listed_all(ip::centroidal_momentum_derivatives<Digits50>(model_, q_, qd_));
      case Function::centroidal_momentum_rate_derivatives:
        return listed_all(
            ip::centroidal_momentum_rate_derivatives<Digits50>(model_, q_, qd_, qdd_));
      default:
        return listed_all(ip::kinetic_energy_derivatives<Digits50>(model_, q_, qd_));
    }
  }

  /// By the recursions as they stand, with the constants unrounded.
  [[nodiscard]] Results<Digits50> recursion(Function function, const Mechanism& mechanism) const {
    auto tree = tree_of<Digits50>(mechanism);
    auto X = joint_transforms<Digits50>(tree, in_.q);
    defer_rotations(tree, X);
    const JointRates<Digits50> rates{in_.qd, in_.qdd};
    switch (function) {
      case Function::point_velocity_derivatives: {
        const auto d = point_motion_derivatives<Digits50>(tree, X, {in_.qd, {}});
        return {d.dv_dq.values(), d.J.values()};
      }
      case Function::point_acceleration_derivatives: {
        const auto d = point_motion_derivatives<Digits50>(tree, X, rates);
        return {d.da_dq.values(), d.da_dqd.values(), d.J.values()};
      }
      case Function::centroidal_momentum_derivatives:
        return {centroidal_momentum_by_displacements<Digits50>(tree, X, in_.qd).values(),
                centroidal_momentum_matrix(tree, X).values()};
      case Function::centroidal_momentum_rate_derivatives: {
        const auto d = centroidal_rate_derivatives<Digits50>(tree, X, rates);
        return {d.dq.values(), d.dqd.values(), centroidal_momentum_matrix(tree, X).values()};
      }
      default: {
        const auto d = kinetic_energy_derivatives<Digits50>(tree, X, rates);
        return {d.dq, d.dqd};
      }
    }
  }

  RandomMechanism made_;
  Mechanism mechanism_;
  ip::Model<Digits50> model_;
  ip::Points<Digits50> points_;
  Inputs<Digits50> in_;
  Vector50 q_, qd_, qdd_;
};

class FloatingMotionDerivatives : public MotionDerivatives {};

std::vector<Seeded> floating_motion_derivatives_robots() {
  std::vector<Seeded> floating = motion_derivatives_robots();
  std::erase_if(floating, [](const Seeded& robot) { return !robot.options.floating_base; });
  return floating;
}

INSTANTIATE_TEST_SUITE_P(Robots, MotionDerivatives, testing::ValuesIn(motion_derivatives_robots()));
INSTANTIATE_TEST_SUITE_P(Robots, FloatingMotionDerivatives,
                         testing::ValuesIn(floating_motion_derivatives_robots()));

TEST_P(MotionDerivatives, InterpreterAgreesWithDifferencesInFiftyDigits) {
  for (const Function function : kMotionDerivatives) {
    EXPECT_LT(relative_error(interpreted(function), by_differences(function), 1), kDifferenceBound)
        << function_name(function);
  }
}

// With all joints turned late and with none, regrouped and not.
TEST_P(MotionDerivatives, RecursionsAgreeWithDifferencesInFiftyDigits) {
  Mechanism late = mechanism_;
  for (MovingLink& link : late.links) {
    link.defers_rotation = link.carries_column = link.has_one_coordinate();
  }
  const Mechanism kept = build_mechanism(made_.robot, made_.scene);
  for (const Function function : kMotionDerivatives) {
    const Results<Digits50> expected = by_differences(function);
    for (const Mechanism* mechanism : std::array<const Mechanism*, 3>{&mechanism_, &late, &kept}) {
      EXPECT_LT(relative_error(recursion(function, *mechanism), expected, 1), kDifferenceBound)
          << function_name(function);
    }
  }
}

// A few roundings per link. With limbs in lanes and without.
TEST_P(MotionDerivatives, TracedFunctionsAgreeInDouble) {
  Mechanism in_lanes = mechanism_;
  in_lanes.limbs = find_limbs(mechanism_, 8);
  for (const Function function : kMotionDerivatives) {
    const Results<Digits50> expected = interpreted(function);
    for (const Mechanism& mechanism : {mechanism_, in_lanes}) {
      for (const Program& program : trace_function(mechanism, function)) {
        const auto results =
            evaluate<double>(program, CheckedPrograms::arguments(program, rounded_to<double>(in_)));
        EXPECT_LT(relative_error(results, expected, 1), 1e-12) << program.name;
      }
    }
  }
}

// T is quadratic in the velocities: dT/dqd qd = 2 T. The force of gravity is the gradient of U, so
// that there is no function for it.
TEST_P(MotionDerivatives, EnergiesHaveTheGradientsOfMechanics) {
  const auto d = kinetic_energy_derivatives<Digits50>(
      tree_of<Digits50>(mechanism_),
      joint_transforms<Digits50>(tree_of<Digits50>(mechanism_), in_.q), {in_.qd, {}});
  const Digits50 twice = 2 * ip::kinetic_energy<Digits50>(model_, q_, qd_);
  EXPECT_LT(abs(Digits50(vector(d.dqd).dot(qd_) - twice)), 1e-40 * (1 + abs(twice)));
  const Matrix50 by_q = differences(model_.nv, [&](auto step) {
    return Vector50::Constant(1,
                              ip::potential_energy<Digits50>(model_, displaced(model_, q_, step)))
        .eval();
  });
  EXPECT_LT(relative_error(Results<Digits50>{listed(by_q)},
                           Results<Digits50>{listed(ip::gravity<Digits50>(model_, q_))}, 1),
            kDifferenceBound);
}

// Where a floating base is does not matter, so no digits are lost there.
TEST_P(FloatingMotionDerivatives, DoNotFeelThePlace) {
  Inputs<double> near = rounded_to<double>(in_);
  Inputs<double> far = near;
  for (std::size_t i = 0; i < 3; ++i) far.q[i] *= 1e9;
  for (const Function function : kMotionDerivatives) {
    const Program program = trace_function(mechanism_, function).front();
    EXPECT_EQ(evaluate<double>(program, CheckedPrograms::arguments(program, near)),
              evaluate<double>(program, CheckedPrograms::arguments(program, far)))
        << program.name;
  }
}

}  // namespace
}  // namespace treeline::tests
