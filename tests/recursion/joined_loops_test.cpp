#include <gtest/gtest.h>

#include <Eigen/QR>
#include <iostream>

#include "joined_mechanisms.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "recursion/function_results.hpp"
#include "recursion/methods/constrained_forward_dynamics.hpp"
#include "recursion/tree/supported_mechanism.hpp"

// Hands of two robots that are welded together by a constraint of the scene. Would catch: hands
// that come apart, and forces of a weld that do not reach one of the robots. The hands' motion is
// followed by differences of their poses, without any Jacobian.

namespace treeline::tests {
namespace {

namespace ip = interpreter;
using Vector50 = ip::Vector<Digits50>;

PlacedMechanism draw_arm(std::uint64_t seed, double x) {
  RandomOptions options;
  options.joints = 6;
  options.branching = 0;
  options.mix = {1, 0, 0, 0, 0, 0, 0};
  PlacedMechanism part{random_mechanism(seed, options), {{x, 0.2, 0.1}, {0, 0, 0.7}}};
  part.made.scene.gravity = {0, 0, -9.81};
  ScenePoint& hand = part.made.scene.operational_points.front();
  hand.link = "link_5";
  hand.axes = Axes::local;
  return part;
}

struct Welded {
  RandomMechanism made;
  Vector50 q;
};

/// Two arms at a random pose, and a constraint under which their hands are where they are.
Welded draw_welded(std::uint64_t seed) {
  Welded welded{joined({draw_arm(seed, 0), draw_arm(seed + 7, 1.5)}), {}};
  const auto model = model_from_robot<Digits50>(welded.made.robot, welded.made.scene);
  const auto& points = welded.made.scene.operational_points;
  Rng rng(seed + 5);
  welded.q = random_position(rng, model, 2.0);
  const auto poses =
      ip::forward_kinematics<Digits50>(model, points_from_scene(model, points), welded.q);
  SceneLoop weld{points[0], points[1]};
  weld.first.name = "weld";
  // The first hand seen from the second link, rounded to the numbers of a scene.
  ScenePoint link = points[1];
  link.origin = {};
  const auto of_link =
      ip::forward_kinematics<Digits50>(model, points_from_scene(model, {link}), welded.q)[0];
  const ip::Matrix3<Digits50> R = of_link.rotation.transpose() * poses[0].rotation;
  const ip::Vector3<Digits50> p =
      of_link.rotation.transpose() * (poses[0].position - of_link.position);
  const Eigen::Matrix3d turn =
      R.unaryExpr([](const Digits50& x) { return static_cast<double>(x); });
  for (int i = 0; i < 3; ++i) {
    weld.second.origin.xyz[static_cast<std::size_t>(i)] = static_cast<double>(p(i));
  }
  weld.second.origin.rpy = {std::atan2(turn(2, 1), turn(2, 2)), -std::asin(turn(2, 0)),
                            std::atan2(turn(1, 0), turn(0, 0))};
  welded.made.scene.loops = {weld};
  welded.made.scene.functions = {Function::constrained_forward_dynamics};
  return welded;
}

/// The first hand's pose seen from the second: position, and the sines of its turn.
Vector50 gap(const Welded& welded, const Vector50& q) {
  const auto model = model_from_robot<Digits50>(welded.made.robot, welded.made.scene);
  const SceneLoop& weld = welded.made.scene.loops[0];
  const auto poses = ip::forward_kinematics<Digits50>(
      model, points_from_scene(model, {weld.first, weld.second}), q);
  const ip::Matrix3<Digits50> back = poses[1].rotation.transpose();
  const ip::Matrix3<Digits50> R = back * poses[0].rotation;
  Vector50 e(6);
  e.head<3>() = back * (poses[0].position - poses[1].position);
  e.tail<3>() << (R(2, 1) - R(1, 2)) / 2, (R(0, 2) - R(2, 0)) / 2, (R(1, 0) - R(0, 1)) / 2;
  return e;
}

const Digits50 kStep("1e-12");

/// d gap / dq by central differences.
ip::Matrix<Digits50> gap_rates(const Welded& welded) {
  const Eigen::Index n = welded.q.size();
  ip::Matrix<Digits50> J(6, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Vector50 step = kStep * Vector50::Unit(n, i);
    J.col(i) = (gap(welded, welded.q + step) - gap(welded, welded.q - step)) / Digits50(2 * kStep);
  }
  return J;
}

class WeldedHands : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Random, WeldedHands, testing::Range(1, 5));

TEST_P(WeldedHands, StayTogether) {
  const auto seed = 31 * static_cast<std::uint64_t>(GetParam());
  std::cout << "seed " << seed << '\n';
  const Welded welded = draw_welded(seed);
  const Eigen::Index n = welded.q.size();
  // Rounded numbers of the scene leave a gap of their size.
  EXPECT_LE(static_cast<double>(gap(welded, welded.q).cwiseAbs().maxCoeff()), 1e-14);
  Rng rng(seed + 11);
  const ip::Matrix<Digits50> J = gap_rates(welded);
  Vector50 qd = random_entries<Digits50>(rng, static_cast<int>(n), 1);
  const Vector50 tau = random_entries<Digits50>(rng, static_cast<int>(n), 20);
  qd -= J.transpose() * ip::Matrix<Digits50>(J * J.transpose()).ldlt().solve(Vector50(J * qd));
  const Mechanism seen =
      with_constraints_only(reduced_mechanism(welded.made.robot, welded.made.scene));
  const auto tree = tree_of<Digits50>(seen);
  const auto q = listed(welded.q), rates = listed(qd), forces = listed(tau);
  const std::vector<Digits50> gains{0, 0};
  const auto X = joint_transforms<Digits50>(tree, q);
  const auto motion =
      looped_forward_dynamics<Digits50>(tree, X, {q, rates, forces, gains, {}, {}}, {});
  const Vector50 qdd = Vector50::Map(motion.qdd.data(), n);
  const auto at = [&](const Digits50& t) {
    return gap(welded, welded.q + t * qd + t * t / 2 * qdd);
  };
  const Vector50 apart = (at(kStep) - 2 * at(0) + at(-kStep)) / (kStep * kStep);
  const double scale = 1 + static_cast<double>(qdd.cwiseAbs().maxCoeff());
  // The gap left by rounding turns with the second hand.
  EXPECT_LE(static_cast<double>(apart.cwiseAbs().maxCoeff()) / scale, 1e-12);
  // Only forces of the weld are added: what they do to each robot is J^T f of its own joints.
  const auto model = model_from_robot<Digits50>(welded.made.robot, welded.made.scene);
  const Vector50 extra =
      ip::inverse_dynamics<Digits50>(model, welded.q, qd, qdd, {}, Vector50(0)) - tau;
  const Vector50 f = Vector50::Map(motion.f.data(), 6);
  EXPECT_LE(static_cast<double>(Vector50(extra - J.transpose() * f).cwiseAbs().maxCoeff()) /
                (1 + static_cast<double>(f.cwiseAbs().maxCoeff())),
            1e-12);
  EXPECT_GT(static_cast<double>(extra.head(n / 2).cwiseAbs().maxCoeff()), 1e-3);
  EXPECT_GT(static_cast<double>(extra.tail(n / 2).cwiseAbs().maxCoeff()), 1e-3);
}

}  // namespace
}  // namespace treeline::tests
