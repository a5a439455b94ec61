#include <gtest/gtest.h>

#include "description/rotation.hpp"
#include "interpreter/physics.hpp"

// From a URDF's numbers to the interpreter's model. Would catch: a joint order, quarter turn,
// locked or mimic joint that differs from the contract.

namespace treeline::tests {
namespace {

using namespace interpreter;  // NOLINT(google-build-using-namespace)
using interpreter::JointKind;

constexpr double kPi = 3.141592653589793;

// Quarter turns as people write them are exact, other angles stay unchanged.
TEST(Rotation, QuarterTurnsAreExact) {
  Matrix3<double> expected;
  expected << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  EXPECT_EQ(rotation_from_rpy<double>({-kPi / 2, 0, 0}), expected);
  expected << -1, 0, 0, 0, -1, 0, 0, 0, 1;
  EXPECT_EQ(rotation_from_rpy<double>({0, 0, kPi}), expected);
  EXPECT_EQ(rotation_from_rpy<double>({0, 0, -3 * kPi}), expected);
  EXPECT_NE(rotation_from_rpy<double>({0, 0, 3.14159265359}), expected);
  EXPECT_NE(rotation_from_rpy<double>({1e-300, 0, 0})(2, 1), 0);
}

// R = Rz(yaw) Ry(pitch) Rx(roll), orthogonal to the last of 50 digits.
TEST(Rotation, FixedAxisAngles) {
  const std::array<double, 3> rpy{0.3, -0.5, 0.7};
  const Matrix3<Digits50> R = rotation_from_rpy<Digits50>(rpy);
  const Matrix3<Digits50> product =
      rotation_about<Digits50>(Vector3<Digits50>::UnitZ(), Digits50(rpy[2])) *
      rotation_about<Digits50>(Vector3<Digits50>::UnitY(), Digits50(rpy[1])) *
      rotation_about<Digits50>(Vector3<Digits50>::UnitX(), Digits50(rpy[0]));
  EXPECT_LT(relative_error(R, product), Digits50("1e-48"));
  EXPECT_LT(relative_error(R * R.transpose(), Matrix3<Digits50>::Identity()), Digits50("1e-48"));
}

TEST(Rotation, AxesHaveUnitLengthInAnyPrecision) {
  const Vector3<Digits50> n = unit_axis<Digits50>({0.7071, 0.7071, 1e-17});
  EXPECT_LT(Digits50(abs(n.squaredNorm() - 1)), Digits50("1e-48"));
  EXPECT_EQ(n(0), n(1));
  // As written: noise is removed where mechanisms are built, not in the reference.
  EXPECT_LT(Digits50(abs(n(2) * Digits50(0.7071) - n(0) * Digits50(1e-17))), Digits50("1e-60"));
  EXPECT_EQ(unit_axis<Digits50>({0, -1.0000000000000002, 0}), -Vector3<Digits50>::UnitY());
}

/// base -> a -> b, and base -> c written between them; b and c hinge on z, a slides on x.
Robot small_tree() {
  const Inertial inertial{1, {{0.1, 0, 0}, {}}, 0.1, 0, 0, 0.1, 0, 0.1};
  Robot robot;
  robot.name = "small_tree";
  for (const char* name : {"base", "a", "b", "c"}) robot.links.push_back({name, inertial, 0});
  robot.root = 0;
  const auto add = [&](const char* name, JointType type, int parent, int child,
                       std::array<double, 3> axis) {
    Joint joint;
    joint.name = name;
    joint.type = type;
    joint.parent = parent;
    joint.child = child;
    joint.origin.xyz = {0, 0.5, 0};
    joint.axis = axis;
    robot.joints.push_back(joint);
  };
  add("to_b", JointType::revolute, 1, 2, {0, 0, 1});
  add("to_c", JointType::revolute, 0, 3, {0, 0, 1});
  add("to_a", JointType::prismatic, 0, 1, {1, 0, 0});
  return robot;
}

// Depth-first, children in the file's order: c before a because the file has this order.
TEST(ModelFromRobot, JointOrderIsDepthFirstInFileOrder) {
  const auto fixed = model_from_robot<double>(small_tree(), {});
  ASSERT_EQ(fixed.size(), 4);
  EXPECT_EQ(fixed.body(1).name, "c");
  EXPECT_EQ(fixed.body(1).v, 0);
  EXPECT_EQ(fixed.body(2).name, "a");
  EXPECT_EQ(fixed.body(2).v, 1);
  EXPECT_EQ(fixed.body(3).name, "b");
  EXPECT_EQ(fixed.body(3).v, 2);
  Scene scene;
  scene.base = Base::floating;
  const auto floating = model_from_robot<double>(small_tree(), scene);
  EXPECT_EQ(floating.nq, 10);
  EXPECT_EQ(floating.nv, 9);
  EXPECT_EQ(floating.body(0).kind, JointKind::floating);
  EXPECT_EQ(floating.body(1).q, 7);
  EXPECT_EQ(floating.body(1).v, 6);
}

// A joint locked at a value is the same as the joint held at that value.
TEST(ModelFromRobot, LockedJointStandsWhereItWasLocked) {
  Scene scene;
  scene.locked = {{"to_a", 0.3}, {"to_c", -0.8}};
  const auto locked = model_from_robot<double>(small_tree(), scene);
  const auto whole = model_from_robot<double>(small_tree(), {});
  ASSERT_EQ(locked.nv, 1);
  const Points<double> tips{{.name = "b", .body = 3}, {.name = "c", .body = 1}};
  const Vector<double> q = Vector<double>::Constant(1, 0.4);
  const auto expected = forward_kinematics<double>(whole, tips, Vector3<double>(-0.8, 0.3, 0.4));
  const auto poses = forward_kinematics<double>(locked, tips, q);
  for (std::size_t e = 0; e < 2; ++e) {
    EXPECT_LT((poses[e].position - expected[e].position).norm(), 1e-15);
    EXPECT_LT((poses[e].rotation - expected[e].rotation).norm(), 1e-15);
  }
}

// Followers move with their leaders, through chains, and stand still if the leader is locked.
TEST(ModelFromRobot, MimicChainsCompose) {
  Robot robot = small_tree();
  robot.joints[0].mimic = Mimic{1, 2, 0.5};    // b = 2 c + 0.5
  robot.joints[1].mimic = Mimic{2, -3, 0.25};  // c = -3 a + 0.25
  const auto model = model_from_robot<double>(robot, {});
  ASSERT_EQ(model.nv, 1);
  EXPECT_EQ(model.body(3).multiplier, -6);
  EXPECT_EQ(model.body(3).offset, 1);
  EXPECT_EQ(model.body(1).offset, 0.25);
  Scene scene;
  scene.locked = {{"to_a", 0.125}};
  const auto held = model_from_robot<double>(robot, scene);
  EXPECT_EQ(held.nv, 0);
  EXPECT_FALSE(held.has_mimics());
  const Points<double> tip{{.name = "b", .body = 3}};
  EXPECT_LT((forward_kinematics<double>(held, tip, Vector<double>())[0].rotation -
             rotation_about<double>(Vector3<double>::UnitZ(), 0.25))
                .norm(),
            1e-15);
}

// Dynamics with mimic joints are those of the free tree, constrained by G: M = G^T M_all G.
TEST(ModelFromRobot, MimicsReduceTheFreeTree) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const RandomMechanism made =
        random_mechanism(seed, {.joints = 8, .mix = {2, 1, 1, 0, 0, 0}, .mimic = 0.6});
    Robot free_robot = made.robot;
    for (Joint& joint : free_robot.joints) joint.mimic.reset();
    const auto model = model_from_robot<Digits50>(made.robot, made.scene);
    const auto free_model = model_from_robot<Digits50>(free_robot, made.scene);
    Matrix50 G = Matrix50::Zero(free_model.nv, model.nv);
    Vector50 offset = Vector50::Zero(free_model.nv);
    for (int i = 1; i < model.size(); ++i) {
      G(free_model.body(i).v, model.body(i).v) = model.body(i).multiplier;
      offset(free_model.body(i).v) = model.body(i).offset;
    }
    Rng rng(seed);
    const Vector50 q = random_position(rng, model);
    const Vector50 qd = random_entries<Digits50>(rng, model.nv, 3);
    const Vector50 all_q = G * q + offset;
    EXPECT_LT(relative_error(mass_matrix<Digits50>(model, q),
                             G.transpose() * mass_matrix<Digits50>(free_model, all_q) * G),
              kAlgebra);
    EXPECT_LT(
        relative_error(nonlinear_effects<Digits50>(model, q, qd),
                       G.transpose() * nonlinear_effects<Digits50>(free_model, all_q, G * qd)),
        kAlgebra)
        << "seed " << seed;
  }
}

// The same seed gives the same robot. The options have an effect.
TEST(RandomMechanism, IsReproducible) {
  const RandomOptions options{.joints = 20, .mimic = 0.3, .locked = 0.3, .external_forces = 2};
  const RandomMechanism one = random_mechanism(5, options), again = random_mechanism(5, options);
  ASSERT_EQ(one.robot.joints.size(), 20U);
  EXPECT_EQ(one.scene.external_forces.size(), 2U);
  EXPECT_EQ(one.scene.locked, again.scene.locked);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(one.robot.joints[i].axis, again.robot.joints[i].axis);
    EXPECT_EQ(one.robot.joints[i].origin.rpy, again.robot.joints[i].origin.rpy);
  }
}

}  // namespace
}  // namespace treeline::tests
