#include "mechanism/build_mechanism.hpp"

#include <gtest/gtest.h>

#include "mechanism/sample_robots.hpp"
#include "recursion/template_results.hpp"

// Numbering, limits, lumping and mimics of small robots that can be checked by eye. Would catch: a
// coordinate in the wrong place, a limit on the wrong coordinate, a held joint that still moves,
// and a mimic with the wrong factor.

namespace treeline::tests {
namespace {

/// Expects that all functions of two robots are equal in 50 digits at one state.
void expect_same_functions(const Mechanism& a, const Mechanism& b, const Oracle<Digits50>& inputs,
                           std::initializer_list<Function> functions) {
  ASSERT_EQ(a.nq(), b.nq());
  ASSERT_EQ(a.nv(), b.nv());
  Rng rng(7);
  const Inputs<Digits50> in = inputs.random_inputs(rng);
  const TemplateRun<Digits50> run_a(a, in), run_b(b, in);
  for (const Function function : functions) {
    EXPECT_LE(
        relative_error(run_a.results(function)[0].results, run_b.results(function)[0].results, 1),
        1e-44)
        << function_name(function);
  }
}

constexpr std::initializer_list<Function> kDynamics{
    Function::forward_kinematics, Function::jacobian,    Function::bias_acceleration,
    Function::inverse_dynamics,   Function::mass_matrix, Function::forward_dynamics};

std::vector<std::string> joints_of(const Mechanism& mechanism) {
  std::vector<std::string> joints;
  for (const Coordinate& coordinate : mechanism.coordinates) joints.push_back(coordinate.joint);
  return joints;
}

// The file lists both children of the base before the grandchildren. Depth-first order visits the
// first child's subtree before the second child.
TEST(Numbering, IsDepthFirstInTheFilesOrder) {
  const Robot robot = sample_robot({{"left", "base"},
                                    {"right", "base"},
                                    {"right_hand", "right_link"},
                                    {"left_hand", "left_link"},
                                    {"left_thumb", "left_hand_link"},
                                    {"left_finger", "left_hand_link"}});
  const std::vector<std::string> order{"left",        "left_hand", "left_thumb",
                                       "left_finger", "right",     "right_hand"};
  EXPECT_EQ(joints_of(build_mechanism(robot, {})), order);
  EXPECT_EQ(joints_of(reduced_mechanism(robot, {})), order);
}

TEST(Numbering, ParentsStandBeforeChildrenAndCoordinatesAreDense) {
  const Robot robot = sample_robot({{"slide", "base", JointType::prismatic},
                                    {"ride", "slide_link", JointType::planar},
                                    {"fly", "ride_link", JointType::floating},
                                    {"stuck", "fly_link", JointType::fixed},
                                    {"turn", "stuck_link", JointType::continuous}});
  Scene scene;
  scene.base = Base::floating;
  const Mechanism mechanism = build_mechanism(robot, scene);
  EXPECT_EQ(mechanism.nq(), 7 + 1 + 3 + 7 + 1);
  EXPECT_EQ(mechanism.nv(), 6 + 1 + 3 + 6 + 1);
  int q = 0;
  int v = 0;
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    const MovingLink& link = mechanism.links[i];
    EXPECT_LT(link.parent, static_cast<int>(i));
    EXPECT_EQ(link.q_index, q) << link.name;
    EXPECT_EQ(link.v_index, v) << link.name;
    q += link.kind == JointKind::floating ? 7 : 1;
    v += link.kind == JointKind::floating ? 6 : 1;
  }
  EXPECT_EQ(joints_of(mechanism).front(), "base");
  EXPECT_EQ(mechanism.coordinates[6].meaning, "quaternion w");
  EXPECT_EQ(mechanism.coordinates[7].meaning, "displacement, m");
  EXPECT_EQ(mechanism.coordinates[10].meaning, "theta, rad");
  EXPECT_EQ(mechanism.velocities[4], "base angular y, rad/s");
  EXPECT_EQ(mechanism.velocities[7], "ride x, m/s");
}

TEST(Numbering, OfABallJoint) {
  const Robot robot = sample_robot({{"slide", "base", JointType::prismatic},
                                    {"hip", "slide_link", JointType::ball},
                                    {"knee", "hip_link", JointType::continuous}});
  const Mechanism mechanism = reduced_mechanism(robot, {});
  ASSERT_EQ(mechanism.nq(), 1 + 4 + 1);
  ASSERT_EQ(mechanism.nv(), 1 + 3 + 1);
  ASSERT_EQ(mechanism.links.size(), 5U);
  EXPECT_EQ(mechanism.coordinates[1].meaning, "quaternion x");
  EXPECT_EQ(mechanism.coordinates[4].meaning, "quaternion w");
  EXPECT_EQ(mechanism.coordinates[4].neutral(), 1);
  EXPECT_EQ(mechanism.coordinates[5].joint, "knee");
  EXPECT_EQ(mechanism.velocities[1], "hip angular x, rad/s");
  EXPECT_EQ(mechanism.velocities[3], "hip angular z, rad/s");
  for (std::size_t i = 1; i <= 3; ++i) {
    EXPECT_EQ(mechanism.links[i].q_index, 1) << i;
    EXPECT_EQ(mechanism.links[i].v_index, static_cast<int>(i)) << i;
    EXPECT_EQ(mechanism.links[i].inertia.mass, 0) << i;  // at the centre, moved to the parent
    EXPECT_EQ(mechanism.links[i].inertia.h.isZero(), i < 3) << i;
  }
  EXPECT_EQ(mechanism.links[3].name, "hip_link");
  EXPECT_EQ(mechanism.links[4].q_index, 5);
  EXPECT_EQ(mechanism.links[4].v_index, 4);
}

TEST(Numbering, LimitsBelongToTheirCoordinate) {
  Robot robot = sample_robot({{"fly", "base", JointType::floating},
                              {"endless", "fly_link", JointType::continuous},
                              {"stuck", "endless_link", JointType::fixed},
                              {"elbow", "stuck_link", JointType::revolute},
                              {"follower", "elbow_link", JointType::revolute},
                              {"slide", "follower_link", JointType::prismatic}});
  joint_named(robot, "elbow").limits = Limits{-1, 2, 100, 5};
  joint_named(robot, "follower").limits = Limits{-9, 9, 100, 5};
  joint_named(robot, "follower").mimic = Mimic{3, 0.5, 0};
  joint_named(robot, "slide").limits = Limits{-0.25, 0.5, 100, 5};
  const Mechanism mechanism = reduced_mechanism(robot, {});
  ASSERT_EQ(mechanism.nq(), 10);
  EXPECT_TRUE(std::isinf(mechanism.coordinates[7].upper));  // endless
  EXPECT_EQ(mechanism.coordinates[8].lower, -1);
  EXPECT_EQ(mechanism.coordinates[8].upper, 2);
  EXPECT_EQ(mechanism.coordinates[9].joint, "slide");
  EXPECT_EQ(mechanism.coordinates[9].lower, -0.25);
  EXPECT_EQ(mechanism.coordinates[9].upper, 0.5);
}

/// An arm of three joints. The second, about x, may be held or fixed.
std::vector<SampleJoint> arm(SampleJoint second) {
  second.name = "second";
  second.parent = "first_link";
  return {{"first", "base", JointType::revolute, {0, 1, 0}, {{0, 0, 0.4}, {0.2, 0, 0}}},
          second,
          {"third", "second_link", JointType::revolute, {0.6, 0, 0.8}, {{0.3, 0, 0}, {0, 0.1, 0}}}};
}

Scene scene_with_point() {
  Scene scene;
  scene.operational_points = {sample_point("third_link")};
  return scene;
}

TEST(Locked, IsTheSameAsFixedAtThatAngle) {
  for (const double angle : {0.3, 1.5707963267948966, -3.141592653589793}) {
    Scene scene = scene_with_point();
    const Robot fixed =
        sample_robot(arm({"", "", JointType::fixed, {1, 0, 0}, {{0.1, 0.2, 0}, {angle, 0, 0}}}));
    const Robot moving =
        sample_robot(arm({"", "", JointType::revolute, {1, 0, 0}, {{0.1, 0.2, 0}, {}}}));
    Scene held = scene;
    held.locked["second"] = angle;
    expect_same_functions(build_mechanism(moving, held), build_mechanism(fixed, scene),
                          {fixed, scene}, kDynamics);
    expect_same_functions(reduced_mechanism(moving, held), reduced_mechanism(fixed, scene),
                          {fixed, scene}, kDynamics);
  }
}

TEST(Locked, IsTheSameAsFixedAtThatDisplacement) {
  const Scene scene = scene_with_point();
  const Robot fixed =
      sample_robot(arm({"", "", JointType::fixed, {1, 0, 0}, {{0.5, 0.2, 0}, {0, 0, 0.7}}}));
  const Robot moving =
      sample_robot(arm({"", "", JointType::prismatic, {0, -1, 0}, {{0.5, 0.2, 0}, {0, 0, 0.7}}}));
  Scene held = scene;
  held.locked["second"] = 0;
  expect_same_functions(reduced_mechanism(moving, held), reduced_mechanism(fixed, scene),
                        {fixed, scene}, kDynamics);
}

// A quarter turn that the scene gives as a double is exact: no transform has an entry of 6e-17.
TEST(Locked, AtAQuarterTurnLeavesNoResidue) {
  const Robot robot =
      sample_robot({{"first", "base", JointType::revolute, {0, 0, 1}, {}},
                    {"second", "first_link", JointType::revolute, {1, 0, 0}, {{0.5, 0, 0}, {}}},
                    {"third", "second_link", JointType::revolute, {0, 1, 0}, {{0, 0.5, 0}, {}}}});
  Scene held;
  held.locked["second"] = 1.5707963267948966;
  for (const MovingLink& link : build_mechanism(robot, held).links) {
    for (const Digits50& entry : link.placement.R.reshaped()) {
      EXPECT_TRUE(entry == 0 || abs(entry) == 1) << link.name << " " << entry;
    }
  }
}

// q_m = k q + o: the mechanism with a mimic is the free one restricted to a line of its
// coordinates, so its joint force is G^T times that of the free one.
TEST(Mimic, ForcesAreThoseOfTheFreeRobotProjected) {
  Robot robot = sample_robot({{"lead", "base"},
                              {"middle", "lead_link", JointType::prismatic, {0, 1, 0}},
                              {"follow", "middle_link", JointType::revolute, {1, 0, 0}}});
  const Mechanism free = reduced_mechanism(robot, {});
  joint_named(robot, "follow").mimic = Mimic{0, -0.5, 0.25};
  const Mechanism tied = reduced_mechanism(robot, {});
  ASSERT_EQ(tied.nq(), 2);
  Inputs<Digits50> in;
  in.q = {Digits50(0.4), Digits50(-0.2)};
  in.qd = {Digits50(1.5), Digits50(0.7)};
  in.qdd = {Digits50(-2.0), Digits50(0.3)};
  const Digits50 k(-0.5);
  Inputs<Digits50> whole = in;
  whole.q.push_back(k * in.q[0] + Digits50(0.25));
  whole.qd.push_back(k * in.qd[0]);
  whole.qdd.push_back(k * in.qdd[0]);
  const auto tau = TemplateRun(free, whole).results(Function::inverse_dynamics)[0].results[0];
  const Results<Digits50> projected{{tau[0] + k * tau[2], tau[1]}};
  const auto found = TemplateRun(tied, in).results(Function::inverse_dynamics)[0].results;
  EXPECT_LE(relative_error(found, projected, 1), 1e-44);
  const auto M = TemplateRun(free, whole).results(Function::mass_matrix)[0].results[0];
  const Digits50 cross = M[1] + k * M[7];
  const Results<Digits50> M_projected{
      {M[0] + k * (M[2] + M[6]) + k * k * M[8], cross, cross, M[4]}};
  const auto M_found = TemplateRun(tied, in).results(Function::mass_matrix)[0].results;
  EXPECT_LE(relative_error(M_found, M_projected, 1), 1e-44);
}

// A follower before its leader in the tree, and two followers of one leader.
TEST(Mimic, MayStandBeforeTheJointItFollows) {
  Robot robot = sample_robot({{"follow", "base"},
                              {"lead", "follow_link", JointType::revolute, {1, 0, 0}},
                              {"also", "lead_link", JointType::prismatic, {0, 0, 1}}});
  joint_named(robot, "follow").mimic = Mimic{1, 2, 0.5};
  joint_named(robot, "also").mimic = Mimic{1, 0.25, 0};
  const Mechanism mechanism = build_mechanism(robot, {});
  ASSERT_EQ(mechanism.nq(), 1);
  EXPECT_EQ(joints_of(mechanism), std::vector<std::string>{"lead"});
  for (const MovingLink& link : mechanism.links) {
    EXPECT_EQ(link.q_index, 0) << link.name;
    EXPECT_EQ(link.v_index, 0) << link.name;
  }
  EXPECT_EQ(mechanism.links[0].multiplier, 2);
  EXPECT_EQ(mechanism.links[0].offset, 0.5);
  EXPECT_TRUE(mechanism.links[0].mimics);
  EXPECT_FALSE(mechanism.links[1].mimics);
  EXPECT_EQ(mechanism.links[2].multiplier, 0.25);
}

// Chains multiply: q_c = 3 q_b + 1, q_b = 2 q_a + 0.5.
TEST(Mimic, ChainsMultiply) {
  Robot robot = sample_robot({{"a", "base"}, {"b", "a_link"}, {"c", "b_link"}});
  joint_named(robot, "b").mimic = Mimic{0, 2, 0.5};
  joint_named(robot, "c").mimic = Mimic{1, 3, 1};
  const Mechanism mechanism = build_mechanism(robot, {});
  EXPECT_EQ(mechanism.links[2].multiplier, 6);
  EXPECT_EQ(mechanism.links[2].offset, 2.5);
}

TEST(Mimic, OfALockedJointIsFixed) {
  Robot robot = sample_robot({{"lead", "base", JointType::revolute, {0, 0, 1}},
                              {"follow", "lead_link", JointType::revolute, {0, 0, 1}},
                              {"third", "follow_link", JointType::revolute, {0, 1, 0}}});
  joint_named(robot, "follow").mimic = Mimic{0, -2, 0.25};
  Scene scene = scene_with_point();
  Scene held = scene;
  held.locked["lead"] = 0.5;
  const Robot fixed =
      sample_robot({{"lead", "base", JointType::fixed, {}, {{}, {0, 0, 0.5}}},
                    {"follow", "lead_link", JointType::fixed, {}, {{}, {0, 0, -0.75}}},
                    {"third", "follow_link", JointType::revolute, {0, 1, 0}}});
  ASSERT_EQ(build_mechanism(robot, held).nq(), 1);
  expect_same_functions(reduced_mechanism(robot, held), reduced_mechanism(fixed, scene),
                        {fixed, scene}, kDynamics);
}

/// Position of the child's origin of a planar joint at q = (x, y, theta).
std::array<double, 3> planar_position(const std::array<double, 3>& normal, double x, double y) {
  const Robot robot = sample_robot({{"ride", "base", JointType::planar, normal}});
  Scene scene;
  ScenePoint point;
  point.name = point.link = "ride_link";
  scene.operational_points = {point};
  Inputs<Digits50> in;
  in.q = {Digits50(x), Digits50(y), Digits50(0.7)};
  const auto p = TemplateRun(reduced_mechanism(robot, scene), in)
                     .results(Function::forward_kinematics)[0]
                     .results[0];
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

// The contract's directions in the plane: images of x and y under the shortest rotation of z onto
// the normal.
TEST(Planar, DirectionsAreThoseOfTheContract) {
  using Position = std::array<double, 3>;
  EXPECT_EQ(planar_position({0, 0, 1}, 2, 3), (Position{2, 3, 0}));
  EXPECT_EQ(planar_position({0, 0, -1}, 2, 3), (Position{2, -3, 0}));
  EXPECT_EQ(planar_position({1, 0, 0}, 2, 3), (Position{0, 3, -2}));
  EXPECT_EQ(planar_position({0, 1, 0}, 2, 3), (Position{2, 0, -3}));
}

TEST(Points, OnTheWorldOrAFixedBaseDoNotMove) {
  const Robot robot = sample_robot({{"stand", "base", JointType::fixed, {}, {{0, 0, 1}, {}}},
                                    {"turn", "stand_link"},
                                    {"tool", "turn_link", JointType::fixed, {}, {{1, 0, 0}, {}}}});
  Scene scene;
  scene.operational_points = {sample_point("base"), sample_point("stand_link"),
                              sample_point("tool_link")};
  const Mechanism mechanism = reduced_mechanism(robot, scene);
  ASSERT_EQ(mechanism.operational_points.size(), 3U);
  EXPECT_EQ(mechanism.operational_points[0].link, -1);
  EXPECT_EQ(mechanism.operational_points[1].link, -1);
  EXPECT_EQ(mechanism.operational_points[1].pose.p(2), Digits50(-0.3) + 1);
  EXPECT_EQ(mechanism.operational_points[2].link, 0);
}

TEST(Lumping, AddsMassesAndSaysSo) {
  const Robot robot = sample_robot({{"turn", "base"},
                                    {"tool", "turn_link", JointType::fixed, {}, {{1, 0, 0}, {}}},
                                    {"tip", "tool_link", JointType::fixed, {}, {{1, 0, 0}, {}}}});
  const Mechanism mechanism = build_mechanism(robot, {});
  ASSERT_EQ(mechanism.links.size(), 1U);
  EXPECT_EQ(mechanism.links[0].inertia.mass, 2 + 3 + 4);
  int lumped = 0;
  for (const ReductionNote& note : mechanism.notes) {
    lumped += note.step == "lump" && note.text.find("turn_link") != std::string::npos ? 1 : 0;
  }
  EXPECT_EQ(lumped, 2);
}

TEST(Lumping, GravityIsTheScenes) {
  Scene scene;
  scene.gravity = {1, -2, 3};
  EXPECT_EQ(build_mechanism(sample_robot({{"turn", "base"}}), scene).gravity, scene.gravity);
}

}  // namespace
}  // namespace treeline::tests
