#include "bench/peers/describe_to_peers.hpp"

#include <gtest/gtest.h>

#include "description/read_scene.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/inverse_dynamics.hpp"
#include "oracle/model_from_robot.hpp"
#include "random_mechanism.hpp"
#include "random_state.hpp"

// Peers receive the robot that is computed here. Would catch: a joint, an inertia or a gravity that
// is lost, a locked joint with another value, and coordinates in another order.

namespace treeline::tests {
namespace {

RandomOptions open_to_peers() {
  RandomOptions options;
  options.mix.floating = 0;
  options.mix.planar = 0;
  options.locked = 0.3;
  return options;
}

TEST(DescribeToPeers, WritesTheSameRobot) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomOptions options = open_to_peers();
    options.floating_base = seed % 3 == 0;
    const RandomMechanism drawn = random_mechanism(seed, options);
    Diagnostics diagnostics;
    const auto plain =
        parse_urdf(print_plain_urdf(drawn.robot, drawn.scene), "plain.urdf", diagnostics);
    ASSERT_TRUE(plain) << to_string(diagnostics.list().back());
    Scene scene = drawn.scene;
    scene.locked.clear();
    const auto own = model_from_robot<double>(drawn.robot, drawn.scene);
    const auto theirs = model_from_robot<double>(*plain, scene);
    ASSERT_EQ(own.nv, theirs.nv);
    Rng rng(seed);
    const auto q = random_position<double>(rng, own);
    const auto qd = random_entries<double>(rng, own.nv, 2);
    const auto qdd = random_entries<double>(rng, own.nv, 5);
    const auto tau = interpreter::inverse_dynamics<double>(own, q, qd, qdd);
    const auto same = interpreter::inverse_dynamics<double>(theirs, q, qd, qdd);
    // Rounding of a few bodies' recursion, and of the angles of locked joints.
    EXPECT_LE((tau - same).norm(), 1e-12 * tau.norm());
  }
}

TEST(DescribeToPeers, NamesTheLinkOfEachVelocity) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(R"(<robot name="two">
      <link name="a"/><link name="b"/><link name="c &amp; d"/>
      <joint name="first" type="prismatic">
        <parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
        <limit lower="0" upper="1" effort="1" velocity="1"/>
      </joint>
      <joint name="second" type="continuous">
        <parent link="b"/><child link="c &amp; d"/><axis xyz="0 0 1"/>
      </joint></robot>)",
                                "two.urdf", diagnostics);
  ASSERT_TRUE(robot);
  Scene scene;
  scene.base = Base::floating;
  scene.operational_points = {{"tip", "b", {{1, 2, 3}, {0, 0, 1.5707963267948966}}, Axes::local}};
  std::string why_not;
  const auto description = describe_to_peers(*robot, scene, why_not);
  ASSERT_TRUE(description);
  EXPECT_EQ(description->links,
            (std::vector<std::string>{"a", "a", "a", "a", "a", "a", "b", "c & d"}));
  ASSERT_EQ(description->points.size(), 1U);
  EXPECT_EQ(description->points[0].R, (std::array<double, 9>{0, -1, 0, 1, 0, 0, 0, 0, 1}));
  EXPECT_EQ(description->points[0].p, (std::array<double, 3>{1, 2, 3}));
  EXPECT_FALSE(description->points[0].world_axes);
  EXPECT_TRUE(parse_urdf(print_plain_urdf(*robot, scene), "plain.urdf", diagnostics));
}

TEST(DescribeToPeers, NamesWhatIsHeld) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(R"(<robot name="two">
      <link name="a"/><link name="b"/><link name="c"/>
      <joint name="first" type="continuous">
        <parent link="a"/><child link="b"/><axis xyz="0 1 0"/>
      </joint>
      <joint name="second" type="continuous">
        <parent link="a"/><child link="c"/><axis xyz="0 1 0"/>
      </joint></robot>)",
                                "two.urdf", diagnostics);
  ASSERT_TRUE(robot);
  const auto scene = parse_scene(R"(
constraints:
  - {name: closing, between: [b, c], origin: {xyz: [1, 0, 0]}, other_origin: {xyz: [0, 0, 2]}, rows: [x, z]}
  - {name: foot, between: [c, world], rows: [z, ry], axes: local}
functions: [constraint_jacobian]
)",
                                 "scene.yaml", *robot, diagnostics);
  ASSERT_TRUE(scene);
  std::string why_not;
  const auto description = describe_to_peers(*robot, *scene, why_not);
  ASSERT_TRUE(description);
  ASSERT_EQ(description->constraints.size(), 2U);
  const PeerConstraint& foot = description->constraints[0];
  EXPECT_EQ(foot.name, "foot");
  EXPECT_EQ(foot.frame.link, "c");
  EXPECT_EQ(foot.frame.rows, (std::array{false, false, true, false, true, false}));
  EXPECT_FALSE(foot.frame.world_axes);
  EXPECT_FALSE(foot.other);
  const PeerConstraint& closing = description->constraints[1];
  EXPECT_EQ(closing.name, "closing");
  EXPECT_EQ(closing.frame.link, "b");
  EXPECT_EQ(closing.frame.p, (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(closing.frame.rows, (std::array{true, false, true, false, false, false}));
  ASSERT_TRUE(closing.other);
  EXPECT_EQ(closing.other->link, "c");
  EXPECT_EQ(closing.other->p, (std::array<double, 3>{0, 0, 2}));
}

std::string refusal(RandomOptions options) {
  const RandomMechanism drawn = random_mechanism(1, options);
  std::string why_not;
  EXPECT_FALSE(describe_to_peers(drawn.robot, drawn.scene, why_not));
  return why_not;
}

TEST(DescribeToPeers, RefusesWhatSitsInJoints) {
  Diagnostics diagnostics;
  const auto robot = parse_urdf(R"(<robot name="one">
      <link name="a"/><link name="b"/>
      <joint name="first" type="continuous">
        <parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
      </joint></robot>)",
                                "one.urdf", diagnostics);
  ASSERT_TRUE(robot);
  Scene scene;
  std::string why_not;
  EXPECT_TRUE(describe_to_peers(*robot, scene, why_not)) << why_not;
  scene.rotors["first"] = {1e-4, 50, "", std::nullopt};
  EXPECT_FALSE(describe_to_peers(*robot, scene, why_not));
  EXPECT_EQ(why_not, "the scene adds rotors, friction or springs to joints");
}

TEST(DescribeToPeers, RefusesWhatPeersCannotDo) {
  RandomOptions mimics = open_to_peers();
  mimics.locked = 0;
  mimics.mimic = 1;
  EXPECT_EQ(refusal(mimics), "the robot has joints that mimic others");
  RandomOptions planar;
  planar.mix = {0, 0, 0, 0, 0, 1};
  EXPECT_EQ(refusal(planar), "the robot has planar, floating or ball joints");
}

}  // namespace
}  // namespace treeline::tests
