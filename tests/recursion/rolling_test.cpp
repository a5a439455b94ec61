#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "looped_robot.hpp"

// Wheels and balls that roll, by the emitted recursion in double, against closed forms of
// textbooks. Would catch: a lever that does not move with the contact, a contact that moves with
// the wheel's matter, rows along wrong axes, and a wheel that may slip or lift.

namespace treeline::tests {
namespace {

using V = interpreter::Vector<double>;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kG = 9.81;
const std::vector<double> kNoGains{0, 0};

LoopedRobot robot_of(const std::string& urdf, const std::string& scene) {
  Diagnostics diagnostics;
  return {parse_urdf(urdf, "roller.urdf", diagnostics).value(), scene};
}

std::string link(const std::string& name, double mass, const Vector3d& moments,
                 const std::string& center = "0 0 0") {
  return "<link name=\"" + name + "\"><inertial><origin xyz=\"" + center + "\"/><mass value=\"" +
         std::to_string(mass) + "\"/><inertia ixx=\"" + std::to_string(moments.x()) +
         "\" ixy=\"0\" ixz=\"0\" iyy=\"" + std::to_string(moments.y()) + "\" iyz=\"0\" izz=\"" +
         std::to_string(moments.z()) + "\"/></inertial></link>";
}

std::string joint(const std::string& name, const std::string& type, const std::string& parent,
                  const std::string& child, const std::string& axis,
                  const std::string& at = "0 0 0") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent link=\"" + parent +
         "\"/><child link=\"" + child + "\"/><origin xyz=\"" + at + "\"/><axis xyz=\"" + axis +
         "\"/><limit lower=\"-1e3\" upper=\"1e3\" effort=\"1e3\" velocity=\"1e3\"/></joint>";
}

std::string in_robot(const std::string& parts) {
  return "<robot name=\"roller\">" + parts + "</robot>";
}

/// A floating link of its own: quaternion x y z w behind x y z.
V pose(const Vector3d& at, const Eigen::Quaterniond& turn) {
  return (V(7) << at, turn.coeffs()).finished();
}

/// Velocity and acceleration of a floating link, in its own axes, from those in the world.
V twist(const Matrix3d& R, const Vector3d& v, const Vector3d& w) {
  return (V(6) << R.transpose() * v, R.transpose() * w).finished();
}
V twist_rate(const Matrix3d& R, const Vector3d& v, const Vector3d& w, const Vector3d& a,
             const Vector3d& alpha) {
  return (V(6) << R.transpose() * (a - w.cross(v)), R.transpose() * alpha).finished();
}

void expect_near(const std::vector<double>& found, const V& expected, double tolerance) {
  ASSERT_EQ(found.size(), static_cast<std::size_t>(expected.size()));
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i], expected(static_cast<Eigen::Index>(i)), tolerance) << "entry " << i;
  }
}

/// A uniform ball of 2 kg with this radius, free to move.
LoopedRobot ball(double radius, const std::string& rolling, const std::string& ground) {
  const double J = 0.4 * 2 * radius * radius;
  return robot_of(in_robot(link("ball", 2, {J, J, J})),
                  "base: floating\nfunctions: [constrained_forward_dynamics]\nconstraints: [{name: "
                  "ground, between: [ball, world], other_origin: " +
                      ground + ", rolling: " + rolling + "}]\n");
}

// 5/7 g sin(slope) down the slope, and 2/7 m g sin(slope) of friction.
TEST(RollingBall, RunsDownASlope) {
  const double slope = 0.3;
  const LoopedRobot robot = ball(0.1, "{radius: 0.1}", "{rpy: [0, 0.3, 0]}");
  const Vector3d down(std::cos(slope), 0, -std::sin(slope));
  const Vector3d normal(std::sin(slope), 0, std::cos(slope));
  const Vector3d v = 0.7 * down, w = normal.cross(v) / 0.1;
  const Vector3d a = 5.0 / 7 * kG * std::sin(slope) * down, alpha = normal.cross(a) / 0.1;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.8, Vector3d(1, 2, 2) / 3));
  const Matrix3d R = turn.toRotationMatrix();
  const auto motion = robot.motion(pose(0.1 * normal + 0.4 * down, turn), twist(R, v, w), kNoGains);
  expect_near(motion.qdd, twist_rate(R, v, w, a, alpha), 1e-11);
  expect_near(motion.f,
              V(Vector3d(-2.0 / 7 * 2 * kG * std::sin(slope), 0, 2 * kG * std::cos(slope))), 1e-11);
}

// On another ball, or in a bowl, it runs as down the slope there.
TEST(RollingBall, RunsOffABallAndThroughABowl) {
  for (const double other : {0.4, -0.5}) {
    const LoopedRobot robot =
        ball(0.1, "{radius: 0.1, on_radius: " + std::to_string(other) + "}", "{}");
    const double distance = std::abs(other + 0.1), side = other > 0 ? 1 : -1, angle = 0.4;
    const Vector3d normal(std::sin(angle), 0, std::cos(angle));  // from the ground to the ball
    const Vector3d down(std::cos(angle), 0, -std::sin(angle));
    const double speed = 0.6;
    const Vector3d v = side * speed * down, w = normal.cross(v) / 0.1;
    const Vector3d along = 5.0 / 7 * kG * std::sin(angle) * down;
    const Vector3d a = along - side * speed * speed / distance * normal;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(-0.5, Vector3d::UnitY()));
    const Matrix3d R = turn.toRotationMatrix();
    const auto motion =
        robot.motion(pose(side * distance * normal, turn), twist(R, v, w), kNoGains);
    expect_near(motion.qdd, twist_rate(R, v, w, a, normal.cross(along) / 0.1), 1e-10);
  }
}

// On a turntable a ball's centre turns at 2/7 of the table's speed, wherever it is.
TEST(RollingBall, CirclesOnATurntable) {
  const double J = 0.4 * 2 * 0.1 * 0.1, speed = 3;
  const LoopedRobot robot = robot_of(
      in_robot("<link name=\"ground\"/>" + link("table", 1e9, {1e12, 1e12, 1e12}) +
               link("ball", 2, {J, J, J}) +
               joint("spin", "continuous", "ground", "table", "0 0 1", "0.2 0.1 0.5") +
               joint("free", "floating", "ground", "ball", "1 0 0")),
      "functions: [constrained_forward_dynamics]\nconstraints: [{name: on_table, between: [ball, "
      "table], rolling: {radius: 0.1}}]\n");
  const Vector3d at(0.7, -0.2, 0.6), center(0.2, 0.1, 0.6);
  int table = 0, free = 0, place = 0;
  for (const auto& each : robot.model().bodies) {
    if (each.name == "table") table = each.v;
    if (each.name == "ball") free = each.v, place = each.q;
  }
  V q = V::Zero(8);
  q.segment(place, 7) = pose(at, Eigen::Quaterniond::Identity());
  const Vector3d up = Vector3d::UnitZ(), v(0.3, 0.5, 0), rim = speed * up.cross(at - center);
  // Of the contact: v - radius w x z = that of the table.
  const Vector3d w = up.cross(v - rim) / 0.1 + 0.9 * up;
  V qd = V::Zero(7);
  qd(table) = speed;
  qd.segment(free, 6) << v, w;
  const auto motion = robot.motion(q, qd, kNoGains);
  const Vector3d a = 2.0 / 7 * speed * up.cross(v) - w.cross(v);  // in the ball's axes
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(motion.qdd[static_cast<std::size_t>(free + i)], a(i), 1e-9);
  }
}

/// A uniform thin disc about its z axis, of 1.5 kg and 0.2 m.
constexpr double kMass = 1.5, kRadius = 0.2, kAcross = kMass * kRadius * kRadius / 4;
LoopedRobot coin() {
  return robot_of(in_robot(link("coin", kMass, {kAcross, kAcross, 2 * kAcross})),
                  "base: floating\nfunctions: [constrained_forward_dynamics]\nconstraints: [{name: "
                  "rim, between: [coin, world], rolling: {radius: 0.2, axis: [0, 0, 1]}}]\n");
}

// A disc that leans and precesses steadily: (C + m r^2) w3 W sin(t) - A W^2 sin(t) cos(t) + m g r
// cos(t) = 0, t: from the vertical to its axis, W: precession, w3: turn about its axis.
TEST(RollingDisc, PrecessesSteadily) {
  const LoopedRobot robot = coin();
  for (const double lean : {0.3, 0.9, 1.4}) {
    for (const double W : {1.5, -4.0}) {
      const double s = std::sin(lean), c = std::cos(lean);
      const double w3 = (kAcross * W * W * s * c - kMass * kG * kRadius * c) /
                        ((2 * kAcross + kMass * kRadius * kRadius) * W * s);
      const Eigen::Quaterniond turn =
          Eigen::AngleAxisd(lean, Vector3d::UnitY()) * Eigen::AngleAxisd(0.7, Vector3d::UnitZ());
      const Matrix3d R = turn.toRotationMatrix();
      const Vector3d up = Vector3d::UnitZ(), axis(s, 0, c), rise(-c, 0, s);
      const Vector3d w = W * s * rise + w3 * axis, v = kRadius * w.cross(rise);
      const auto motion =
          robot.motion(pose(Vector3d(0.1, 0.2, kRadius * s), turn), twist(R, v, w), kNoGains);
      const Vector3d a = W * up.cross(v), alpha = W * up.cross(w);
      expect_near(motion.qdd, twist_rate(R, v, w, a, alpha), 1e-9 * (1 + a.norm() + w.norm()));
      expect_near(motion.f, V(Vector3d(kMass * (a + kG * up))), 1e-9 * (1 + kMass * a.norm()));
    }
  }
}

// No slip does no work. The contact neither drifts off the ground nor slips. Bars: ten times what
// steps of fourth order leave.
TEST(RollingDisc, KeepsItsEnergyAndItsContact) {
  const LoopedRobot robot = coin();
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.2, Vector3d::UnitY()));
  V q = robot.closed(pose(Vector3d(0, 0, 0.19), turn));
  V qd = robot.permitted(q, (V(6) << 0, 0, 0, 0.5, -0.3, 9).finished());
  const double before = robot.energy(q, qd);
  double lifts = 0, slips = 0, change = 0, least = 1;
  for (int i = 0; i < 4000; ++i) {
    robot.step(0.0005, {0, 0}, q, qd);
    lifts = std::max(lifts, robot.errors(q).cwiseAbs().maxCoeff());
    slips = std::max(slips, (robot.jacobian(q) * qd).cwiseAbs().maxCoeff());
    change = std::max(change, std::abs(robot.energy(q, qd) - before));
    least = std::min(least, q(2));
  }
  EXPECT_LE(lifts, 1e-9);
  EXPECT_LE(slips, 1e-8);
  EXPECT_LE(change, 1e-8 * before);
  EXPECT_LT(least, 0.19);  // it leans, so that the contact moves along the rim
}

// A body on two driven wheels whose centre of mass is ahead of the axle.
TEST(DifferentialDrive, AcceleratesAsTheUnicycleModelSays) {
  const double body = 8, ahead = 0.07, Iz = 0.3, wheel = 0.6, half = 0.15, r = 0.05;
  const double Iw = 0.5 * wheel * r * r, Id = 0.25 * wheel * r * r;
  std::string parts = "<link name=\"ground\"/><link name=\"on_x\"/><link name=\"on_y\"/>";
  parts += link("body", body, {1, 1, Iz}, "0.07 0 0.05");
  for (const char* side : {"left", "right"}) {
    const bool left = side == std::string("left");
    parts += link(side, wheel, {Id, Iw, Id});
    parts += joint(std::string(side) + "_axle", "continuous", "body", side, "0 1 0",
                   left ? "0 0.15 0.05" : "0 -0.15 0.05");
  }
  parts += joint("x", "prismatic", "ground", "on_x", "1 0 0") +
           joint("y", "prismatic", "on_x", "on_y", "0 1 0") +
           joint("yaw", "continuous", "on_y", "body", "0 0 1");
  for (const std::string rolling : {"{radius: 0.05}", "{radius: 0.05, axis: [0, 1, 0]}"}) {
    const LoopedRobot robot = robot_of(
        in_robot(parts),
        "passive: [x, y, yaw]\nfunctions: [constrained_forward_dynamics]\n"
        "constraints: [{name: l, between: [left, world], rows: [x, y], rolling: " +
            rolling + "}, {name: r, between: [right, world], rolling: " + rolling + "}]\n");
    ASSERT_EQ(robot.model().nv, 5);
    int left = 3;
    for (const auto& each : robot.model().bodies) left = each.name == "left" ? each.v : left;
    const int right = 7 - left;
    const double yaw = 0.8, v = 0.9, w = -1.7, torque_l = 0.4, torque_r = -0.25;
    V q = (V(5) << 0.3, -0.2, yaw, 1.1, -0.4).finished();
    V qd(5), tau = V::Zero(5);
    qd << v * std::cos(yaw), v * std::sin(yaw), w, 0, 0;
    qd(left) = (v - half * w) / r;
    qd(right) = (v + half * w) / r;
    tau(left) = torque_l;
    tau(right) = torque_r;
    const double forward =
        ((torque_l + torque_r) / r + body * ahead * w * w) / (body + 2 * wheel + 2 * Iw / (r * r));
    const double turning = ((torque_r - torque_l) * half / r - body * ahead * v * w) /
                           (Iz + body * ahead * ahead + 2 * (Id + wheel * half * half) +
                            2 * Iw * half * half / (r * r));
    V expected(5);
    expected << forward * std::cos(yaw) - v * w * std::sin(yaw),
        forward * std::sin(yaw) + v * w * std::cos(yaw), turning, 0, 0;
    expected(left) = (forward - half * turning) / r;
    expected(right) = (forward + half * turning) / r;
    expect_near(robot.motion(q, qd, kNoGains, tau).qdd, expected, 1e-9);
  }
}

}  // namespace
}  // namespace treeline::tests
