#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "interpreter/instances.hpp"

// Mechanisms with textbook solutions. Would catch: errors that invariants cannot reveal, such as a
// wrong unit, or a convention of coordinates that is consistent but differs from the contract.

namespace treeline::interpreter {
namespace {

constexpr double kGravity = 9.81;
/// A few operations in double on numbers of size 1 to 100.
constexpr double kRounding = 1e-13;

using Vec = Vector<double>;

Body<double> hinge(int parent, const Vector3<double>& axis, const Vector3<double>& at) {
  Body<double> body;
  body.parent = parent;
  body.kind = JointKind::revolute;
  body.axis = axis;
  body.p_parent_joint = at;
  return body;
}

/// Puts a point mass at distance `length` along x.
void put_mass(Body<double>& body, double mass, double length) {
  body.mass = mass;
  body.com = {length, 0, 0};
  body.inertia.diagonal() << 0, mass * length * length, mass * length * length;
}

Vec vec(std::initializer_list<double> values) {
  Vec v(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), v.data());
  return v;
}

// A pendulum in the xz plane, angle from x toward -z about +y.
TEST(ClosedForm, Pendulum) {
  Model<double> model;
  Body<double> bob = hinge(kWorld, {0, 1, 0}, {0, 0, 2});
  put_mass(bob, 1.5, 0.7);
  add_body(model, bob);
  const double q = 0.4, qdd = 3;
  const double inertia = 1.5 * 0.7 * 0.7;
  const double tau = inertia * qdd - 1.5 * kGravity * 0.7 * std::cos(q);
  EXPECT_NEAR(inverse_dynamics<double>(model, vec({q}), vec({2}), vec({qdd}))(0), tau, kRounding);
  EXPECT_NEAR(mass_matrix<double>(model, vec({q}))(0, 0), inertia, kRounding);
  EXPECT_NEAR(forward_dynamics<double>(model, vec({q}), vec({2}), vec({tau}))(0), qdd, kRounding);
}

// The planar 2R arm with point masses (Craig, Introduction to Robotics, eq. 6.58).
TEST(ClosedForm, TwoHinges) {
  const double m1 = 2, m2 = 0.9, l1 = 0.8, l2 = 0.5;
  Model<double> model;
  model.gravity = {0, -kGravity, 0};
  Body<double> first = hinge(kWorld, {0, 0, 1}, {0, 0, 0});
  put_mass(first, m1, l1);
  Body<double> second = hinge(0, {0, 0, 1}, {l1, 0, 0});
  put_mass(second, m2, l2);
  add_body(model, first);
  add_body(model, second);
  const Vec q = vec({0.3, -1.1}), qd = vec({1.3, 0.7}), qdd = vec({-2, 5});
  const double c2 = std::cos(q(1)), s2 = std::sin(q(1));
  const double c1 = std::cos(q(0)), c12 = std::cos(q(0) + q(1));
  const double tau1 = m2 * l2 * l2 * (qdd(0) + qdd(1)) + m2 * l1 * l2 * c2 * (2 * qdd(0) + qdd(1)) +
                      (m1 + m2) * l1 * l1 * qdd(0) - m2 * l1 * l2 * s2 * qd(1) * qd(1) -
                      2 * m2 * l1 * l2 * s2 * qd(0) * qd(1) + m2 * l2 * kGravity * c12 +
                      (m1 + m2) * l1 * kGravity * c1;
  const double tau2 = m2 * l1 * l2 * c2 * qdd(0) + m2 * l1 * l2 * s2 * qd(0) * qd(0) +
                      m2 * l2 * kGravity * c12 + m2 * l2 * l2 * (qdd(0) + qdd(1));
  const Vec tau = inverse_dynamics<double>(model, q, qd, qdd);
  EXPECT_NEAR(tau(0), tau1, kRounding);
  EXPECT_NEAR(tau(1), tau2, kRounding);

  OperationalPoint<double> tip;
  tip.body = 1;
  tip.p = {l2, 0, 0};
  tip.rows = {true, true, false, false, false, false};
  Matrix<double> J(2, 2);
  J << -l1 * std::sin(q(0)) - l2 * std::sin(q(0) + q(1)), -l2 * std::sin(q(0) + q(1)),
      l1 * c1 + l2 * c12, l2 * c12;
  EXPECT_LT((jacobian<double>(model, {tip}, q) - J).norm(), kRounding);
}

// A prismatic joint on a hinge: Coriolis force 2 m r rd thd on the hinge, centrifugal force m r
// thd^2 on the slide.
TEST(ClosedForm, HingeThenSlide) {
  const double m = 1.7, izz = 0.2;
  Model<double> model;
  model.gravity = {0, -kGravity, 0};
  add_body(model, hinge(kWorld, {0, 0, 1}, {0, 0, 0}));
  Body<double> slide;
  slide.parent = 0;
  slide.kind = JointKind::prismatic;
  slide.axis = {1, 0, 0};
  slide.mass = m;
  slide.inertia.diagonal() << 0.1, 0.15, izz;
  add_body(model, slide);
  const double th = 0.6, r = 0.9, thd = 1.2, rd = -0.4, thdd = 2, rdd = 3;
  const Vec tau = inverse_dynamics<double>(model, vec({th, r}), vec({thd, rd}), vec({thdd, rdd}));
  EXPECT_NEAR(tau(0),
              (m * r * r + izz) * thdd + 2 * m * r * rd * thd + m * kGravity * r * std::cos(th),
              kRounding);
  EXPECT_NEAR(tau(1), m * rdd - m * r * thd * thd + m * kGravity * std::sin(th), kRounding);
}

// Euler's equations for a free body about its centre of mass. Its origin is in free fall; in body
// axes d(v)/dt = R^T g - w x v.
TEST(ClosedForm, TorqueFreeBody) {
  Model<double> model;
  Body<double> free_body;
  free_body.kind = JointKind::floating;
  free_body.mass = 3;
  free_body.inertia.diagonal() << 0.2, 0.5, 0.6;
  add_body(model, free_body);
  const double h = std::sqrt(0.5);
  const Vec q =
      vec({1, 2, 3, h, 0, 0, h});  // a quarter turn about x: z of the world is y of the body
  const Vector3<double> v(0.3, -0.2, 0.5), w(1, -2, 3);
  Vec qd(6);
  qd << v, w;
  const Vec qdd = forward_dynamics<double>(model, q, qd, Vec::Zero(6));
  const Vector3<double> fall(0, -kGravity, 0);
  EXPECT_LT((qdd.head<3>() - (fall - w.cross(v))).norm(), kRounding);
  EXPECT_NEAR(qdd(3), (0.5 - 0.6) * w(1) * w(2) / 0.2, kRounding);
  EXPECT_NEAR(qdd(4), (0.6 - 0.2) * w(2) * w(0) / 0.5, kRounding);
  EXPECT_NEAR(qdd(5), (0.2 - 0.5) * w(0) * w(1) / 0.6, kRounding);
}

// A gyroscope with three hinges (azimuth, tilt, spin) in steady precession, the heavy symmetric
// top: the tilt is constant if m g l = P (Iz (s + P cos th) - Ix P cos th).
TEST(ClosedForm, GyroscopeInSteadyPrecession) {
  const double m = 0.8, l = 0.3, ix = 0.11, iz = 0.02, tilt = 0.7, spin = 80;
  Model<double> model;
  add_body(model, hinge(kWorld, {0, 0, 1}, {0, 0, 0}));
  add_body(model, hinge(0, {1, 0, 0}, {0, 0, 0}));
  Body<double> top = hinge(1, {0, 0, 1}, {0, 0, 0});
  top.mass = m;
  top.com = {0, 0, l};
  top.inertia.diagonal() << ix, ix, iz;
  add_body(model, top);
  // (iz - ix) cos(th) P^2 + iz s P - m g l = 0, the slow root.
  const double a = (iz - ix) * std::cos(tilt), b = iz * spin, c = -m * kGravity * l;
  const double P = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
  const Vec qdd =
      forward_dynamics<double>(model, vec({0.2, tilt, 1.9}), vec({P, 0, spin}), Vec::Zero(3));
  EXPECT_LT(qdd.norm(), 1e-11);
}

// A planar joint equals two prismatic joints and a hinge, for any normal; its q is [x, y, theta].
TEST(ClosedForm, PlanarJointIsTwoSlidesAndAHinge) {
  for (const Vector3<double>& n :
       {Vector3<double>(0, 0, 1), Vector3<double>(0, 0, -1),
        Vector3<double>(2.0 / 3, -1.0 / 3, 2.0 / 3), Vector3<double>(0.6, 0, -0.8)}) {
    const Matrix3<double> plane = planar_directions(n);
    EXPECT_LT((plane.col(2) - n).norm() + (plane.transpose() * plane).norm() - std::sqrt(3.0),
              kRounding);
    Body<double> body;
    body.mass = 2;
    body.com = {0.1, 0.2, 0.3};
    body.inertia << 1, 0.1, 0.2, 0.1, 1.5, 0.3, 0.2, 0.3, 2;
    Model<double> one, three;
    body.kind = JointKind::planar;
    body.axis = n;
    add_body(one, body);
    Body<double> slide;
    slide.kind = JointKind::prismatic;
    slide.axis = plane.col(0);
    add_body(three, slide);
    slide.parent = 0;
    slide.axis = plane.col(1);
    add_body(three, slide);
    body.kind = JointKind::revolute;
    body.parent = 1;
    add_body(three, body);
    const Vec q = vec({0.4, -0.7, 1.1}), qd = vec({2, 3, -4}), qdd = vec({1, -5, 2});
    EXPECT_LT(
        (inverse_dynamics<double>(one, q, qd, qdd) - inverse_dynamics<double>(three, q, qd, qdd))
            .norm(),
        kRounding * 100);
  }
}

// The in-plane directions for the normal -z, according to the contract: x = (1, 0, 0), y = (0, -1,
// 0).
TEST(ClosedForm, PlanarDirectionsByTheContract) {
  Matrix3<double> flipped = Matrix3<double>::Identity();
  flipped.diagonal() << 1, -1, -1;
  EXPECT_EQ(planar_directions(Vector3<double>(0, 0, -1)), flipped);
  EXPECT_EQ(planar_directions(Vector3<double>(0, 0, 1)), Matrix3<double>::Identity());
  Matrix3<double> to_x;  // the turn about y that takes z to x
  to_x << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  EXPECT_EQ(planar_directions(Vector3<double>(1, 0, 0)), to_x);
}

// Two geared hinges on one axis: the inertia at the motor is J1 + k^2 J2.
TEST(ClosedForm, GearedHinges) {
  Model<double> model;
  Body<double> motor = hinge(kWorld, {0, 0, 1}, {0, 0, 0});
  motor.inertia(2, 2) = 0.5;
  add_body(model, motor);
  Body<double> wheel = hinge(kWorld, {0, 0, 1}, {1, 0, 0});
  wheel.inertia(2, 2) = 0.3;
  wheel.mimics = true;
  wheel.multiplier = -2;
  wheel.offset = 0.1;
  model.bodies.push_back(wheel);
  EXPECT_NEAR(mass_matrix<double>(model, vec({0.2}))(0, 0), 0.5 + 4 * 0.3, kRounding);
  EXPECT_NEAR(forward_dynamics<double>(model, vec({0.2}), vec({1}), vec({3.4}))(0), 2, kRounding);
  OperationalPoint<double> rim;
  rim.body = 1;
  const auto pose = forward_kinematics<double>(model, {rim}, vec({0.2}));
  EXPECT_NEAR(std::atan2(pose[0].rotation(1, 0), pose[0].rotation(0, 0)), -0.3, kRounding);
}

// A ball joint is a floating joint without its translations.
TEST(ClosedForm, BallJoint) {
  Model<double> model;
  Body<double> ball;
  ball.kind = JointKind::spherical;
  ball.inertia.diagonal() << 0.2, 0.5, 0.6;
  add_body(model, ball);
  ASSERT_EQ(model.nq, 4);
  const Vector3<double> w(1, -2, 3);
  const Vec tau = inverse_dynamics<double>(model, vec({0, 0, 0, 1}), w, Vec::Zero(3));
  EXPECT_LT((tau - w.cross(Vector3<double>(0.2 * w(0), 0.5 * w(1), 0.6 * w(2)))).norm(), kRounding);
}

// Another precision gives the same results up to its rounding: the conversion keeps every number.
TEST(ClosedForm, FloatAgreesWithDouble) {
  Model<double> model;
  Body<double> bob = hinge(kWorld, {0, 1, 0}, {0, 0, 2});
  put_mass(bob, 1.5, 0.7);
  add_body(model, bob);
  bob.parent = 0;
  add_body(model, bob);
  const Model<float> rounded = cast<float>(model);
  const Vec q = vec({0.25, -0.5}), qd = vec({1, 2}), qdd = vec({3, -4});
  const Vector<float> tau =
      inverse_dynamics<float>(rounded, q.cast<float>(), qd.cast<float>(), qdd.cast<float>());
  EXPECT_LT((tau.cast<double>() - inverse_dynamics<double>(model, q, qd, qdd)).norm(), 1e-4);
}

}  // namespace
}  // namespace treeline::interpreter
