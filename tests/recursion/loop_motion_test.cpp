#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <iostream>
#include <numeric>

#include "data/list_data.hpp"
#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/close_loops.hpp"
#include "interpreter/instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"
#include "recursion/constrained_forward_dynamics.hpp"
#include "recursion/supported_mechanism.hpp"
#include "recursion/task_law.hpp"

// Robots with loops move by the emitted recursion, in double. Would catch: loops that open or
// energy that appears, rows that prevent each other, and a robot file's loops that are not kept.

namespace treeline::tests {
namespace {

using interpreter::Matrix;
using interpreter::Vector;

/// What closes the four-bar: at the coupler's end and at the rocker's.
std::string closing(const std::string& rows) {
  return "constraints: [{name: closing, between: [rocker, coupler], origin: {xyz: [0, 0, 0.25]}, "
         "other_origin: {xyz: [0.3, 0, 0]}, rows: " +
         rows + "}]\n";
}

class Looped {
 public:
  Looped(const std::string& urdf, const std::string& scene_text) {
    Diagnostics diagnostics;
    const auto robot = read_urdf(data_file("written/" + urdf), diagnostics);
    if (!robot) throw std::runtime_error("the robot or its scene cannot be read");
    const auto scene = parse_scene(scene_text, "scene.yaml", *robot, diagnostics);
    if (!scene) throw std::runtime_error("the robot or its scene cannot be read");
    model_ = model_from_robot<double>(*robot, *scene);
    loops_ = loops_from_scene(model_, *robot, *scene);
    const Mechanism seen = with_constraints_only(reduced_mechanism(*robot, *scene));
    tree_ = tree_of<double>(seen);
    rule_ = TaskLaws(seen).find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {})->rule;
  }

  [[nodiscard]] const interpreter::Model<double>& model() const { return model_; }

  /// The closed pose near a guess.
  [[nodiscard]] Vector<double> closed(const Vector<double>& q) const {
    std::vector<int> all(static_cast<std::size_t>(model_.nv));
    std::iota(all.begin(), all.end(), 0);
    return interpreter::close_loops<double>(model_, loops_, q, all, 1e-14).value();
  }
  [[nodiscard]] Vector<double> errors(const Vector<double>& q) const {
    return interpreter::loop_errors<double>(model(), loops_, q);
  }
  [[nodiscard]] Matrix<double> jacobian(const Vector<double>& q) const {
    return interpreter::loop_jacobian<double>(model(), loops_, q);
  }
  /// The part of qd that the loops permit.
  [[nodiscard]] Vector<double> permitted(const Vector<double>& q, const Vector<double>& qd) const {
    const Matrix<double> J = jacobian(q);
    return qd - J.completeOrthogonalDecomposition().solve(Vector<double>(J * qd));
  }
  [[nodiscard]] Vector<double> moved(const Vector<double>& q, const Vector<double>& qd,
                                     double t) const {
    return interpreter::move_coordinates<double>(model(), q, qd, t);
  }

  [[nodiscard]] ConstrainedMotion<double> motion(const Vector<double>& q, const Vector<double>& qd,
                                                 const std::vector<double>& gains) const {
    const std::vector<double> at(q.begin(), q.end()), rates(qd.begin(), qd.end());
    const std::vector<double> tau(rates.size());
    const auto X = joint_transforms<double>(tree_, at);
    return looped_forward_dynamics<double>(tree_, X, {at, rates, tau, gains, {}, {}}, rule_);
  }

  [[nodiscard]] double energy(const Vector<double>& q, const Vector<double>& qd) const {
    return interpreter::kinetic_energy<double>(model(), q, qd) +
           interpreter::potential_energy<double>(model(), q);
  }

  /// One step of fourth order, of second order where there are quaternions.
  void step(double h, Vector<double>& q, Vector<double>& qd) const {
    const std::vector<double> gains{40, 400};
    const auto rate = [&](const Vector<double>& x, const Vector<double>& v) {
      const auto qdd = motion(x, v, gains).qdd;
      return Vector<double>(Vector<double>::Map(qdd.data(), v.size()));
    };
    const Vector<double> v1 = qd, a1 = rate(q, v1);
    const Vector<double> v2 = qd + h / 2 * a1, a2 = rate(moved(q, v1, h / 2), v2);
    const Vector<double> v3 = qd + h / 2 * a2, a3 = rate(moved(q, v2, h / 2), v3);
    const Vector<double> v4 = qd + h * a3, a4 = rate(moved(q, v3, h), v4);
    q = moved(q, (v1 + 2 * v2 + 2 * v3 + v4) / 6, h);
    qd += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }

 private:
  interpreter::Model<double> model_;
  interpreter::Loops<double> loops_;
  Tree<double> tree_;
  PivotRule rule_;
};

Looped four_bar(const std::string& rows = "[x, z]") {
  return {"four_bar.urdf", closing(rows)};
}
const Vector<double> kAssembled = (Vector<double>(3) << 0.3, -0.6, 0.2).finished();

// Where rocker and coupler meet follows from the three sides of a triangle.
TEST(FourBar, ClosesWhereTheSidesMeet) {
  const Looped robot = four_bar();
  for (const double crank : {-2.0, 0.4, 1.3}) {
    Vector<double> q = robot.closed((Vector<double>(3) << crank, -crank, 0).finished());
    const Eigen::Vector2d pin(0.12 * std::sin(q(0)), 0.12 * std::cos(q(0)));
    const Eigen::Vector2d end(0.3 + 0.25 * std::sin(q(2)), 0.25 * std::cos(q(2)));
    EXPECT_NEAR((end - pin).norm(), 0.3, 1e-12);
    EXPECT_LE(robot.errors(q).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(FourBar, KeepsItsEnergyAndStaysClosed) {
  const Looped robot = four_bar();
  Vector<double> q = robot.closed(kAssembled);
  Vector<double> qd = robot.permitted(q, (Vector<double>(3) << 25, 0, 0).finished());
  const double before = robot.energy(q, qd);
  double open = 0, change = 0;
  for (int i = 0; i < 20000; ++i) {
    robot.step(0.001, q, qd);
    open = std::max(open, robot.errors(q).cwiseAbs().maxCoeff());
    change = std::max(change, std::abs(robot.energy(q, qd) - before));
  }
  std::cout << "20 s: the loop opens by " << open << " m, the energy of " << before
            << " J changes by " << change << " J\n";
  // What is left is the integrator's: fourth order, at 1 ms and about four turns a second.
  EXPECT_LE(open, 1e-8);
  EXPECT_LE(change, 1e-5 * std::abs(before));
}

// All five rows of the hinge: three depend on the other two in every state.
TEST(FourBar, MovesTheSameWithRowsThatTheRestPreventsAlready) {
  const Looped two = four_bar(), five = four_bar("[x, y, z, rx, rz]");
  const Vector<double> q = two.closed(kAssembled);
  const Vector<double> qd = two.permitted(q, (Vector<double>(3) << 3, 1, -2).finished());
  const auto expected = two.motion(q, qd, {0, 0});
  const auto moving = five.motion(q, qd, {0, 0});
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(moving.qdd[i], expected.qdd[i], 1e-9);
  EXPECT_NEAR(moving.f[0], expected.f[0], 1e-9);
  EXPECT_NEAR(moving.f[2], expected.f[1], 1e-9);
  EXPECT_EQ(moving.f[1], 0);
}

// Five loops of ball joints, from the robot's file.
TEST(Stewart, FallsWithAllLegsAttached) {
  const Looped robot("stewart.urdf", "");
  Vector<double> q = Vector<double>::Zero(robot.model().nq);
  for (const auto& body : robot.model().bodies) {
    const int quaternion = interpreter::quaternion_of(body);
    if (quaternion >= 0) q(quaternion + 3) = 1;
  }
  q = robot.closed(q);
  ASSERT_LE(robot.errors(q).cwiseAbs().maxCoeff(), 1e-12);
  Vector<double> qd = robot.permitted(q, Vector<double>::Constant(robot.model().nv, 0.3));
  const double before = robot.energy(q, qd);
  for (int i = 0; i < 150; ++i) robot.step(0.001, q, qd);
  // Steps of the ball joint's quaternion are of second order.
  EXPECT_LE(robot.errors(q).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_NEAR(robot.energy(q, qd), before, 1e-7 * std::abs(before));
  EXPECT_GT(qd.norm(), 1);
}

}  // namespace
}  // namespace treeline::tests
