#include "oracle/draw_state.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "bounds/domain.hpp"
#include "check/fixture.hpp"
#include "description/read_urdf.hpp"
#include "interpreter/joint_parts.hpp"
#include "mechanism/build_mechanism.hpp"

// States belong to their class, and are reproducible from seed and index. Would catch: classes that
// are never drawn, limits that are not kept, and numbers that are not exact in float.

namespace treeline::tests {
namespace {

StateSpace space_of(const Subjects& subjects, std::uint64_t seed = 1) {
  return {make_subject<double>(subjects.robot, subjects.scene),
          subjects.generation.mechanism.coordinates, seed, subjects.scene.real == Real::float32};
}

double largest(const std::vector<double>& entries) {
  double size = 0;
  for (const double entry : entries) size = std::max(size, std::abs(entry));
  return size;
}

TEST(States, EveryClassInEveryTwenty) {
  std::map<StateClass, int> counts;
  for (int i = 0; i < 20; ++i) ++counts[class_of_state(i)];
  EXPECT_EQ(counts.size(), kStateClasses.size());
  EXPECT_EQ(counts[StateClass::neutral], 1);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(class_of_state(i), class_of_state(i + 140));
}

TEST(States, AreWhatTheirClassSays) {
  const Subjects subjects = load("puma560");
  const StateSpace space = space_of(subjects);
  for (int i = 0; i < 200; ++i) {
    const State state = draw_state(space, i);
    EXPECT_EQ(state.index, i);
    switch (state.kind) {
      case StateClass::neutral:
        EXPECT_EQ(largest(state.q), 0);
        EXPECT_EQ(largest(state.qd) > 0, i > 0) << "the first one is at rest";
        break;
      case StateClass::random:
      case StateClass::fast:
      case StateClass::limits:
        for (std::size_t k = 0; k < state.q.size(); ++k) {
          EXPECT_GE(state.q[k], space.coordinates[k].lower);
          EXPECT_LE(state.q[k], space.coordinates[k].upper);
        }
        break;
      case StateClass::large:
        EXPECT_GT(largest(state.q), 100);
        break;
      case StateClass::tiny:
        EXPECT_LE(largest(state.q), 1e-2);
        EXPECT_GT(largest(state.q), 0);
        break;
      case StateClass::aligned:
        EXPECT_TRUE(std::any_of(state.q.begin(), state.q.end(), [](double angle) {
          return std::abs(std::remainder(angle, std::acos(0.0))) < 0.011;
        })) << i;
        break;
    }
  }
}

// Gazebo's models give 1e16 rad for "no limit", where emitted sines have no digit.
TEST(States, TakeNoLimitFromWhereSinesHaveNoDigits) {
  Subjects subjects = load("planar3r");
  for (const bool single_precision : {false, true}) {
    StateSpace space = space_of(subjects);
    space.single_precision = single_precision;
    const double farthest = farthest_angle(single_precision);
    space.coordinates[0].lower = -1e16;
    space.coordinates[0].upper = 2 * farthest;
    space.coordinates[1].lower = -farthest / 2;
    space.coordinates[1].upper = farthest / 2;
    double at_limit = 0;
    for (int i = 0; i < 200; ++i) {
      const State state = draw_state(space, i);
      EXPECT_LE(std::abs(state.q[0]), 1000) << i;
      at_limit = std::max(at_limit, std::abs(state.q[1]));
    }
    EXPECT_EQ(at_limit, farthest / 2);
  }
}

TEST(States, DependOnSeedAndIndexAlone) {
  const Subjects subjects = load("planar3r");
  const State once = draw_state(space_of(subjects), 7);
  const State again = draw_state(space_of(subjects), 7);
  EXPECT_EQ(once.q, again.q);
  EXPECT_EQ(once.tau, again.tau);
  EXPECT_NE(once.q, draw_state(space_of(subjects, 2), 7).q);
  EXPECT_NE(once.q, draw_state(space_of(subjects), 8).q);
}

TEST(States, OfFloatCodeAreFloats) {
  const Subjects subjects = load("puma560", "scene_float.yaml");
  const State state = draw_state(space_of(subjects), 1);
  for (const auto* entries : {&state.q, &state.qd, &state.qdd, &state.tau, &state.xdd_cmd}) {
    ASSERT_FALSE(entries->empty());
    for (const double x : *entries) EXPECT_EQ(x, static_cast<double>(static_cast<float>(x)));
  }
}

// Every other quaternion has unit length only up to the rounding of float, some 1e-8.
TEST(States, QuaternionsHaveUnitLength) {
  double farthest = 0;
  int balls = 0;
  RandomOptions options;
  options.joints = 4;
  options.mix.ball = 6;
  options.floating_base = true;
  const Subjects subjects = draw(5, options);
  const StateSpace space = space_of(subjects);
  for (int i = 0; i < 60; ++i) {
    const State state = draw_state(space, i);
    for (const auto& body : space.subject.model.bodies) {
      const int first = interpreter::quaternion_of(body);
      if (first < 0) continue;
      balls += body.kind == interpreter::JointKind::spherical ? 1 : 0;
      double square = 0;
      for (int k = first; k < first + 4; ++k) {
        square += std::pow(state.q[static_cast<std::size_t>(k)], 2);
      }
      EXPECT_NEAR(square, 1, i % 2 == 1 ? 3e-7 : 1e-15) << i;
      farthest = std::max(farthest, std::abs(square - 1));
    }
  }
  EXPECT_GT(farthest, 1e-8);
  EXPECT_GT(balls, 0);
}

// Would catch: a coordinate that is taken for a length because of the words in its description.
TEST(States, TurnPlanarJointsAsFarAsRevoluteOnes) {
  Diagnostics diagnostics;
  const Robot robot =
      parse_urdf(
          "<robot name='r'><link name='a'/><joint name='j' type='planar'><parent link='a'/>"
          "<child link='b'/></joint><link name='b'><inertial><mass value='1'/><inertia "
          "ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link></robot>",
          "planar.urdf", diagnostics)
          .value();
  const Scene scene;
  const Mechanism mechanism = build_mechanism(robot, scene);
  const StateSpace space{make_subject<double>(robot, scene), mechanism.coordinates, 1, false, {}};
  double farthest = 0, across = 0;
  for (int i = 0; i < 100; ++i) {
    const State state = draw_state(space, i);
    if (state.kind != StateClass::large) continue;
    farthest = std::max(farthest, std::abs(state.q[2]));
    across = std::max(across, std::abs(state.q[0]));
  }
  EXPECT_GT(farthest, 500) << "radians";
  EXPECT_LE(across, 10) << "metres";
  const std::vector<double> stated = make_domain(robot, scene, mechanism).sizes.at("q");
  EXPECT_EQ(stated, (std::vector<double>{kPositionRange, kPositionRange, kAngleRange}));
}

}  // namespace
}  // namespace treeline::tests
