#include <gtest/gtest.h>

#include <sstream>

#include "mechanism/build_mechanism.hpp"
#include "mechanism/sample_robots.hpp"
#include "random_mechanism.hpp"

// The purpose of reductions: zeros, and fewer numbers. Would catch: a reduction that stays correct
// but no longer reduces, residue of cancellation that counts as a number, and output that depends
// on anything but the input.

namespace treeline::tests {
namespace {

bool is_quarter_turn(const Digits50Matrix3& R) {
  for (const Digits50& entry : R.reshaped()) {
    if (entry != 0 && entry != 1 && entry != -1) return false;
  }
  return true;
}

int nonzero_entries(const Digits50Vector3& v) {
  return static_cast<int>((v.array() != Digits50(0)).count());
}

/// Prints every number of a mechanism with all digits.
std::string all_numbers(const Mechanism& mechanism) {
  std::ostringstream text;
  text.precision(60);
  for (const MovingLink& link : mechanism.links) {
    text << link.name << link.placement.R << link.placement.p << link.offset << link.inertia.mass
         << link.inertia.h << link.inertia.Sigma << '\n';
  }
  for (const auto* points : {&mechanism.operational_points, &mechanism.external_forces}) {
    for (const MechanismPoint& point : *points) text << point.pose.R << point.pose.p << '\n';
  }
  for (const ReductionNote& note : mechanism.notes) text << note.text << '\n';
  return text.str();
}

/// The PUMA 560 in modified Denavit-Hartenberg form: Rx(alpha) Tx(a) Rz Tz(d) for each joint.
Robot puma() {
  constexpr double kQuarter = 1.5707963267948966;
  const auto joint = [](const char* name, const char* parent, Pose origin) {
    return SampleJoint{name, parent, JointType::revolute, {0, 0, 1}, origin};
  };
  return sample_robot({joint("j1", "base", {}),
                       joint("j2", "j1_link", {{0, 0.2435, 0}, {-kQuarter, 0, 0}}),
                       joint("j3", "j2_link", {{0.4318, 0, -0.0934}, {}}),
                       joint("j4", "j3_link", {{-0.0203, -0.4331, 0}, {kQuarter, 0, 0}}),
                       joint("j5", "j4_link", {{}, {-kQuarter, 0, 0}}),
                       joint("j6", "j5_link", {{}, {kQuarter, 0, 0}})});
}

TEST(Placements, OfThePumaAreQuarterTurnsWithAtMostTwoLengths) {
  Scene scene;
  scene.accuracy = Accuracy::fastest;  // joints without limits would keep turns of the tool's frame
  const Mechanism mechanism = reduced_mechanism(puma(), scene);
  int lengths = 0;
  for (const MovingLink& link : mechanism.links) {
    EXPECT_TRUE(is_quarter_turn(link.placement.R)) << link.name << "\n" << link.placement.R;
    EXPECT_LE(nonzero_entries(link.placement.p), 2) << link.name;
    lengths += nonzero_entries(link.placement.p);
  }
  EXPECT_LE(lengths, 4);  // a2, d3 (with d2), a3, d4
}

// The same robot with every frame rotated and shifted at random along its own axis, as in a
// careless URDF, becomes equally sparse.
TEST(Placements, UndoCarelessFrames) {
  Robot robot = puma();
  Mechanism mechanism = build_mechanism(robot, {});
  Rng rng(11);
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    MovingLink& link = mechanism.links[i];
    const Digits50 angle = rng.rounded(-1, 1);
    const Digits50Pose careless{rotation_z(angle), Digits50Vector3(0, 0, rng.rounded(-1, 1))};
    link.placement = link.placement * careless;
    link.offset = 0;
    link.inertia = transformed(link.inertia, inverse(careless));
    for (MovingLink& child : mechanism.links) {
      if (child.parent == static_cast<int>(i))
        child.placement = inverse(careless) * child.placement;
    }
  }
  regroup_inertias(mechanism);
  place_frames(mechanism);
  for (const MovingLink& link : mechanism.links) {
    EXPECT_TRUE(is_quarter_turn(link.placement.R)) << link.name << "\n" << link.placement.R;
    EXPECT_LE(nonzero_entries(link.placement.p), 2) << link.name;
  }
}

// Base inertial parameters: a revolute link keeps h_x, h_y, Sigma_xx, xy, xz, yy, yz, a prismatic
// link its mass and first moment.
TEST(Regrouping, LeavesSevenNumbersOrFour) {
  const Robot robot = sample_robot(
      {{"turn", "base", JointType::revolute, {0.6, 0.8, 0}, {{1, 2, 3}, {1, 2, 3}}},
       {"slide", "turn_link", JointType::prismatic, {0, 0.6, 0.8}, {{1, 2, 3}, {}}},
       {"spin", "slide_link", JointType::continuous, {1, 0, 0}, {{0, 1, 0}, {1, 0, 0}}},
       {"push", "spin_link", JointType::prismatic, {1, 0, 0}, {{0, 0, 1}, {}}}});
  Mechanism mechanism = build_mechanism(robot, {});
  for (const MovingLink& link : mechanism.links) {
    EXPECT_EQ(count_inertia_numbers(link.inertia), 10) << link.name;
  }
  regroup_inertias(mechanism);
  EXPECT_EQ(count_inertia_numbers(mechanism.links[0].inertia), 7);
  EXPECT_EQ(count_inertia_numbers(mechanism.links[1].inertia), 4);
  EXPECT_EQ(count_inertia_numbers(mechanism.links[2].inertia), 7);
  EXPECT_EQ(count_inertia_numbers(mechanism.links[3].inertia), 4);
  // Placing frames where first moments and products vanish leaves fewer numbers, never more:
  // shifting the frame of a prismatic link must not restore its second moment.
  const Mechanism reduced = reduced_mechanism(robot, {});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LE(count_inertia_numbers(reduced.links[i].inertia),
              count_inertia_numbers(mechanism.links[i].inertia))
        << reduced.links[i].name;
  }
}

// The motion of a free body depends on all its parameters.
TEST(Regrouping, LeavesAFloatingLinkWhole) {
  const Robot robot =
      sample_robot({{"turn", "base", JointType::revolute, {0, 0, 1}, {{0.3, 0.2, 0.1}, {}}}});
  Scene scene;
  scene.base = Base::floating;
  const Mechanism mechanism = reduced_mechanism(robot, scene);
  EXPECT_EQ(count_inertia_numbers(mechanism.links[0].inertia), 10);
  EXPECT_EQ(mechanism.links[0].inertia.mass, 1 + 2);
}

// Equal weights on opposite sides of a shaft, one rotated by 0.75 rad at once, the other by 0.25
// and then 0.5. Their first moments cancel except for the last of 50 digits, which must not count
// as a number.
TEST(Residue, OfABalancedShaftIsZero) {
  Robot robot = sample_robot({{"shaft", "base", JointType::revolute, {0, 0, 1}, {}},
                              {"one", "shaft_link", JointType::fixed, {}, {{}, {0, 0, 0.75}}},
                              {"arm", "shaft_link", JointType::fixed, {}, {{}, {0, 0, 0.25}}},
                              {"other", "arm_link", JointType::fixed, {}, {{}, {0, 0, 0.5}}}});
  for (Link& link : robot.links) link.inertial.reset();
  Inertial weight;
  weight.mass = 2;
  weight.ixx = weight.iyy = weight.izz = 0.01;
  weight.origin.xyz = {0.3, 0.1, 0};
  robot.links[2].inertial = weight;
  weight.origin.xyz = {-0.3, -0.1, 0};
  robot.links[4].inertial = weight;
  const Inertia inertia = reduced_mechanism(robot, {}).links[0].inertia;
  EXPECT_EQ(inertia.h, Digits50Vector3::Zero());
  EXPECT_EQ(inertia.Sigma(0, 2), 0);
  EXPECT_EQ(inertia.Sigma(1, 2), 0);
}

/// Whether a number is a residue of cancellation.
bool is_residue(const Digits50& value) {
  return value != 0 && abs(value) < 1e-20;
}

// In robots whose numbers all have three digits, no constant is smaller than 1e-20 unless it is
// zero.
TEST(Residue, StaysInNoRandomMechanism) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    RandomOptions options;
    options.aligned = 0.8;
    options.joints = 8;
    options.mix.fixed = 3;
    options.locked = 0.2;
    options.operational_points = 2;
    const RandomMechanism made = random_mechanism(seed, options);
    const Mechanism mechanism = reduced_mechanism(made.robot, made.scene);
    for (const MovingLink& link : mechanism.links) {
      SCOPED_TRACE(link.name);
      for (const Digits50& x : link.placement.R.reshaped()) EXPECT_FALSE(is_residue(x)) << x;
      for (const Digits50& x : link.placement.p) EXPECT_FALSE(is_residue(x)) << x;
      for (const Digits50& x : link.inertia.h) EXPECT_FALSE(is_residue(x)) << x;
      for (const Digits50& x : link.inertia.Sigma.reshaped()) EXPECT_FALSE(is_residue(x)) << x;
      EXPECT_FALSE(is_residue(link.offset)) << link.offset;
    }
    for (const MechanismPoint& point : mechanism.operational_points) {
      for (const Digits50& x : point.pose.R.reshaped()) EXPECT_FALSE(is_residue(x)) << x;
      for (const Digits50& x : point.pose.p) EXPECT_FALSE(is_residue(x)) << x;
    }
  }
}

TEST(Determinism, EqualInputsGiveEqualDigits) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    RandomOptions options;
    options.joints = 12;
    options.mimic = 0.2;
    options.operational_points = 2;
    options.external_forces = 1;
    const RandomMechanism one = random_mechanism(seed, options);
    const RandomMechanism other = random_mechanism(seed, options);
    EXPECT_TRUE(all_numbers(reduced_mechanism(one.robot, one.scene)) ==
                all_numbers(reduced_mechanism(other.robot, other.scene)));
  }
}

// After reduction nothing is left to regroup.
TEST(Regrouping, IsComplete) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    const RandomMechanism made = random_mechanism(seed);
    Mechanism mechanism = reduced_mechanism(made.robot, made.scene);
    const std::size_t notes = mechanism.notes.size();
    Mechanism again = mechanism;
    regroup_inertias(again);
    again.notes.resize(notes);
    EXPECT_TRUE(all_numbers(again) == all_numbers(mechanism));
  }
}

}  // namespace
}  // namespace treeline::tests
