// Friction and springs at the end of a step where loops hold. Would catch: M + step D + step^2 K
// with another D, K or step in a part of the solve, such as rows of loops that feel the plain M; a
// spring whose force stays at the step's begin; a step that is implicit in name only. The oracle is
// the whole KKT system in 50 digits, with D from differences of the forces.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/loop_instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "program/evaluate.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline::tests {
namespace {

namespace ip = interpreter;
using ip::Digits50;
using V50 = ip::Vector<Digits50>;
using M50 = ip::Matrix<Digits50>;

constexpr const char* kClosing =
    "constraints: [{name: closing, between: [rocker, coupler], origin: {xyz: [0, 0, 0.25]}, "
    "other_origin: {xyz: [0.3, 0, 0]}, rows: [x, z]}]\n"
    "functions: [constrained_forward_dynamics]\n";

/// Joints that no step of 1 ms can follow: damping step / inertia is above 100 at the crank.
constexpr const char* kStiff =
    "joint_friction: {model: viscous, implicit: true, joints: {crank_joint: {damping: 800}, "
    "coupler_joint: {damping: 900}, rocker_joint: {damping: 700}}}\n"
    "joint_springs: {crank_joint: {stiffness: 5.0e5, rest: 0.31}}\n";

constexpr const char* kOrdinary =
    "joint_friction: {model: coulomb, implicit: true, joints: {crank_joint: {damping: 0.3, "
    "friction: 0.5, width: 0.5}, coupler_joint: {friction: 0.2, width: 2}, rocker_joint: {damping: "
    "2}}}\n"
    "joint_springs: {rocker_joint: {stiffness: 40, rest: 0.3}, coupler_joint: {stiffness: 7}}\n";

struct FourBar {
  explicit FourBar(const std::string& drives) {
    Diagnostics diagnostics;
    robot = read_urdf(data_file("written/four_bar.urdf"), diagnostics).value();
    const auto read = parse_scene(kClosing + drives, "s.yaml", robot, diagnostics);
    if (!read) throw std::runtime_error(to_string(diagnostics.list().front()));
    scene = *read;
  }
  [[nodiscard]] Program function() const {
    return trace_function(reduced_mechanism(robot, scene), Function::constrained_forward_dynamics)
        .front();
  }

  Robot robot;
  Scene scene;
};

template <class Scalar>
ip::Vector<Scalar> closed(const ip::Model<Scalar>& model, const ip::Loops<Scalar>& loops,
                          ip::Vector<Scalar> q) {
  for (int i = 0; i < 60; ++i) {
    const ip::Matrix<Scalar> J = ip::loop_jacobian<Scalar>(model, loops, q);
    const ip::Matrix<Scalar> JJ = J * J.transpose();
    const ip::Vector<Scalar> e = ip::loop_errors<Scalar>(model, loops, q);
    q -= J.transpose() * JJ.partialPivLu().solve(e);
  }
  return q;
}

/// d friction / d qd by differences of what friction adds to the forces.
V50 slopes_by_differences(const FourBar& bar, const V50& q, const V50& qd) {
  const Digits50 e("1e-16");
  Scene without = bar.scene;
  without.joint_friction.clear();
  const auto with = model_from_robot<Digits50>(bar.robot, bar.scene);
  const auto none = model_from_robot<Digits50>(bar.robot, without);
  const auto friction = [&](const V50& at) {
    return V50(ip::nonlinear_effects<Digits50>(with, q, at) -
               ip::nonlinear_effects<Digits50>(none, q, at));
  };
  const V50 ones = V50::Constant(qd.size(), e);
  return (friction(qd + ones) - friction(qd - ones)) / (2 * e);
}

TEST(ImplicitLoops, SolveTheKktSystemOfTheStep) {
  const FourBar bar(kOrdinary);
  const auto model = model_from_robot<Digits50>(bar.robot, bar.scene);
  const auto loops = loops_from_scene(model, bar.robot, bar.scene);
  const V50 q = closed<Digits50>(model, loops, (V50(3) << 0.3, -0.6, 0.2).finished());
  const V50 qd = (V50(3) << 1.5, -0.7, 0.4).finished();
  const V50 tau = (V50(3) << 2, -1, 0.5).finished();
  const Digits50 step = 0.01, damping = 40, stiffness = 400;
  const M50 J = ip::loop_jacobian<Digits50>(model, loops, q);
  M50 A = M50::Zero(5, 5);
  A.topLeftCorner(3, 3) = ip::mass_matrix<Digits50>(model, q);
  A.topRightCorner(3, 2) = -J.transpose();
  A.bottomLeftCorner(2, 3) = J;
  const V50 D = slopes_by_differences(bar, q, qd);
  V50 b(5);
  b.head(3) = tau - ip::nonlinear_effects<Digits50>(model, q, qd);
  for (const auto& [joint, spring] : bar.scene.joint_springs) {
    const int i = joint == "rocker_joint" ? 2 : 1;
    A(i, i) += step * step * spring.stiffness;
    b(i) -= step * spring.stiffness * qd(i);
  }
  for (int i = 0; i < 3; ++i) A(i, i) += step * D(i);
  b.tail(2) = -ip::loop_bias<Digits50>(model, loops, q, qd) - damping * (J * qd) -
              stiffness * ip::loop_errors<Digits50>(model, loops, q);
  const V50 expected = A.partialPivLu().solve(b);
  const Program program = bar.function();
  ASSERT_EQ(program.arguments.back().name, "step");
  const auto result = evaluate<Digits50>(program, {{q.begin(), q.end()},
                                                   {qd.begin(), qd.end()},
                                                   {tau.begin(), tau.end()},
                                                   {damping, stiffness},
                                                   {step}});
  // Constants of the code are rounded to double.
  for (int i = 0; i < 3; ++i) {
    const Digits50 error = result[0][static_cast<std::size_t>(i)] - expected(i);
    EXPECT_LT(abs(error), 1e-13 * (1 + expected.head(3).norm())) << i;
  }
  for (int i = 0; i < 2; ++i) {
    const Digits50 error = result[1][static_cast<std::size_t>(i)] - expected(3 + i);
    EXPECT_LT(abs(error), 1e-13 * (1 + expected.tail(2).norm())) << i;
  }
}

struct Ride {
  double speed = 0, open = 0;
};

/// Half a second of semi-implicit Euler steps of 1 ms, from a crank at 5 rad/s.
Ride ride(bool implicit) {
  FourBar bar(kStiff);
  bar.scene.implicit_friction = implicit;
  const auto model = model_from_robot<double>(bar.robot, bar.scene);
  const auto loops = loops_from_scene(model, bar.robot, bar.scene);
  const Program program = bar.function();
  using V = ip::Vector<double>;
  V q = closed<double>(model, loops, (V(3) << 0.3, -0.6, 0.2).finished());
  const ip::Matrix<double> J = ip::loop_jacobian<double>(model, loops, q);
  V qd = (V(3) << 5, 0, 0).finished();
  const ip::Matrix<double> JJ = J * J.transpose();
  qd -= J.transpose() * JJ.partialPivLu().solve(V(J * qd));
  Ride ride;
  for (int i = 0; i < 500; ++i) {
    std::vector<std::vector<double>> arguments{
        {q.begin(), q.end()}, {qd.begin(), qd.end()}, {0, 0, 0}, {40, 400}};
    if (implicit) arguments.push_back({1e-3});
    const auto qdd = evaluate<double>(program, arguments).front();
    qd += 1e-3 * V::Map(qdd.data(), 3);
    q += 1e-3 * qd;
    ride.speed = qd.norm();
    ride.open = std::max(ride.open, ip::loop_errors<double>(model, loops, q).cwiseAbs().maxCoeff());
    if (!(ride.speed < 1e6)) return {1e9, 1e9};
  }
  return ride;
}

TEST(ImplicitLoops, StayStableWhereAnExplicitStepDiverges) {
  EXPECT_EQ(ride(false).speed, 1e9);
  const Ride stable = ride(true);
  EXPECT_LT(stable.speed, 5);
  EXPECT_LT(stable.open, 1e-3);  // m: first-order steps
}

}  // namespace
}  // namespace treeline::tests
