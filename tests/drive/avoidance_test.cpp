// Would catch: a distance or a gradient that is wrong, a field that is no gradient of its
// potential, a point that enters an obstacle through which it was commanded, energy that grows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

#include "drive/drive_loop.hpp"
#include "linked_robots.hpp"
#include "rig.hpp"

namespace treeline::drive {
namespace {

using test::kNone;

Obstacle sphere(double x, double y, double z, double radius) {
  Obstacle obstacle;
  obstacle.center[0] = x;
  obstacle.center[1] = y;
  obstacle.center[2] = z;
  obstacle.radius = radius;
  return obstacle;
}

/// A box of half edges 0.1, 0.2, 0.3 at the origin that is turned by a right angle about z: its
/// edges in the world are 0.4, 0.2 and 0.6 long.
Obstacle turned_box() {
  Obstacle box;
  const double turn[9] = {0, -1, 0, 1, 0, 0, 0, 0, 1};
  std::copy_n(turn, 9, box.rotation);
  const double half[3] = {0.1, 0.2, 0.3};
  std::copy_n(half, 3, box.half);
  return box;
}

struct Seen {
  double distance;
  std::array<double, 3> away;
};
Seen see(const Obstacle& obstacle, double x, double y, double z) {
  double away[3];
  const double place[3] = {x, y, z};
  const double distance = distance_to(obstacle, place, away);
  return {distance, {away[0], away[1], away[2]}};
}

TEST(Obstacle, DistancesOfASphere) {
  const Obstacle ball = sphere(1, 2, 3, 0.5);
  EXPECT_NEAR(see(ball, 1, 2, 5).distance, 1.5, 1e-15);
  EXPECT_NEAR(see(ball, 1, 2, 5).away[2], 1.0, 1e-15);
  EXPECT_NEAR(see(ball, 1.3, 2.4, 3).distance, 0.0, 1e-15);
  EXPECT_NEAR(see(ball, 1.1, 2, 3).distance, -0.4, 1e-15);
  EXPECT_NEAR(see(ball, 1.1, 2, 3).away[0], 1.0, 1e-15);
  const Seen middle = see(ball, 1, 2, 3);
  EXPECT_NEAR(middle.distance, -0.5, 1e-15);
  EXPECT_NEAR(std::hypot(middle.away[0], middle.away[1], middle.away[2]), 1.0, 1e-15);
}

TEST(Obstacle, DistancesOfATurnedBox) {
  const Obstacle box = turned_box();
  EXPECT_NEAR(see(box, 0.5, 0, 0).distance, 0.3, 1e-15);  // a face
  EXPECT_NEAR(see(box, 0, 0.5, 0).distance, 0.4, 1e-15);
  EXPECT_NEAR(see(box, 0.5, 0.5, 0).distance, 0.5, 1e-15);  // an edge: 3, 4, 5
  EXPECT_NEAR(see(box, 0.5, 0.5, 0).away[1], 0.8, 1e-15);
  EXPECT_NEAR(see(box, 0.4, 0.3, 0.4).distance, 0.3, 1e-15);  // a corner: 2, 2, 1
  EXPECT_NEAR(see(box, 0.15, 0, 0).distance, -0.05, 1e-15);   // within
  EXPECT_NEAR(see(box, 0.15, 0, 0).away[0], 1.0, 1e-15);
  EXPECT_NEAR(see(box, 0, -0.09, 0).away[1], -1.0, 1e-15);
}

// Central differences of the energy: their error is below h^2 U'''/6, about 1e-4 of the slope.
TEST(Obstacle, ThePushIsTheGradientOfItsPotential) {
  const Repulsion repulsion;
  constexpr double h = 1e-6;
  for (double distance = -0.02; distance < 0.2; distance += 0.0037) {
    const double slope =
        (push_at(repulsion, distance + h).energy - push_at(repulsion, distance - h).energy) /
        (2 * h);
    const double acceleration = push_at(repulsion, distance).acceleration;
    EXPECT_NEAR(-slope, acceleration, 1e-4 * std::fabs(acceleration) + 1e-7) << distance;
  }
  // Khatib 1986, eq. 17, where nothing is cut.
  const double rho = 0.08;
  const double gap = 1 / rho - 1 / repulsion.reach;
  EXPECT_DOUBLE_EQ(push_at(repulsion, rho + repulsion.clearance).acceleration,
                   repulsion.eta * gap / (rho * rho));
  EXPECT_EQ(push_at(repulsion, repulsion.reach + repulsion.clearance).acceleration, 0.0);
}

/// A loop in simulated time whose points keep away from obstacles.
template <class F>
class Rig : public test::Rig<F> {
 public:
  Rig(std::vector<double> start, const std::vector<Obstacle>& obstacles,
      const std::vector<GuardedPoint>& guarded)
      : test::Rig<F>(std::move(start), [&](LoopOptions& options) {
          options.surroundings.obstacles = obstacles.data();
          options.surroundings.obstacle_count = static_cast<int>(obstacles.size());
          options.surroundings.guarded = guarded.data();
          options.surroundings.guarded_count = static_cast<int>(guarded.size());
        }) {}
};

/// Runs for `seconds` and returns the smallest distance of the carriage from an obstacle.
double nearest_within(Rig<test::Gantry>& rig, const Obstacle& obstacle, double seconds) {
  double nearest = kNone;
  for (int i = 0; i < static_cast<int>(1000 * seconds); ++i) {
    rig.step();
    nearest = std::min(nearest, see(obstacle, rig.q(0), rig.q(1), rig.q(2)).distance);
  }
  return nearest;
}

const GuardedPoint kCarriage = {0, 0, {0, 0, 0}};

// The goal of a straight line through the middle of a ball leads through it in both controls. The
// carriage stops before it: at a goal behind the ball on the same line there is no way round that
// a potential field could see.
TEST(Avoidance, APointThatIsLedIntoASphereStopsBeforeIt) {
  const Obstacle ball = sphere(0.5, 0, 0, 0.2);
  for (const bool by_task : {true, false}) {
    Rig<test::Gantry> rig({0, 0, 0}, {ball}, {kCarriage});
    if (by_task) {
      rig.send(Instruction::move_point, {0, 0, 0.5, 0, 0}, 1.0);
    } else {
      rig.send(Instruction::move_joint, {0, 0, 0.5}, 1.0);
    }
    EXPECT_GT(nearest_within(rig, ball, 4.0), Repulsion{}.clearance) << by_task;
    EXPECT_GT(rig.q(0), 0.1) << by_task;
    EXPECT_NEAR(rig.qd(0), 0.0, 1e-3) << by_task;
    EXPECT_EQ(rig.head().fault_kind, 0);
  }
}

// A line that misses the middle by 1 cm leads round the ball to the goal.
TEST(Avoidance, APointGoesRoundASphere) {
  const Obstacle ball = sphere(0.5, 0.01, 0, 0.15);
  Rig<test::Gantry> rig({0, 0, 0}, {ball}, {kCarriage});
  rig.send(Instruction::move_point, {0, 0, 1, 0, 0}, 2.0);
  EXPECT_GT(nearest_within(rig, ball, 8.0), Repulsion{}.clearance);
  EXPECT_NEAR(rig.q(0), 1.0, 1e-3);
  EXPECT_NEAR(rig.q(1), 0.0, 1e-3);
}

TEST(Avoidance, APointStaysOutsideABoxThatItIsDraggedThrough) {
  Obstacle box = turned_box();
  box.center[0] = 0.8;
  Rig<test::Gantry> rig({0, 0.02, 0}, {box}, {kCarriage});
  double nearest = kNone;
  for (int i = 0; i < 60; ++i) {
    rig.send(Instruction::drag_point, {0, 0, 1.6, 0.02, 0});
    nearest = std::min(nearest, nearest_within(rig, box, 0.033));
  }
  EXPECT_GT(nearest, 0.5 * Repulsion{}.clearance);  // the lead runs 1 m ahead at 1 m/s
}

// In gravity control there is no goal: E = |qd|^2 / 2 + U may only fall. It is led by hand first.
// A step of the loop holds the torque, which errs by qdd dt: 1e-3 of E in a second.
TEST(Avoidance, EnergyDoesNotGrow) {
  const Obstacle ball = sphere(0, 0, 0, 0.2);
  Rig<test::Gantry> rig({0.5, 0.05, 0.02}, {ball}, {kCarriage});
  rig.send(Instruction::set_control, {2});
  for (int i = 0; i < 30; ++i) {
    rig.send(Instruction::pull_link, {0, 0, 0, 0, -1, 0, 0});
    for (int k = 0; k < 10; ++k) rig.step();
  }
  for (int i = 0; i < 400; ++i) rig.step();  // the pull and the blend have ended
  const auto energy = [&rig, &ball] {
    const double speed = std::hypot(rig.qd(0), rig.qd(1), rig.qd(2));
    Repulsion repulsion;
    repulsion.largest_curvature = 1e5;
    return 0.5 * speed * speed +
           push_at(repulsion, see(ball, rig.q(0), rig.q(1), rig.q(2)).distance).energy;
  };
  double last = energy();
  ASSERT_GT(last, 1e-6);
  for (int i = 0; i < 1000; ++i) {
    rig.step();
    const double now = energy();
    EXPECT_LT(now, last * (1 + 1e-3) + 1e-12) << i;
    last = now;
  }
}

// The elbow of an arm, whose tip is nowhere near, is held off by a ball; its Jacobian is not one.
TEST(Avoidance, AnElbowKeepsAway) {
  const double angle = 0.9;
  const Obstacle ball = sphere(std::cos(angle), 0, std::sin(angle), 0.1);
  Rig<test::LinkedArm> rig({0.2, 0.3}, {ball}, {{0, -1, {1, 0, 0}}});
  rig.send(Instruction::move_joint, {0, 0, 1.6}, 1.5);
  double nearest = kNone;
  for (int i = 0; i < 4000; ++i) {
    rig.step();
    nearest = std::min(nearest, see(ball, std::cos(rig.q(0)), 0, std::sin(rig.q(0))).distance);
  }
  EXPECT_GT(nearest, 0.5 * Repulsion{}.clearance);
  EXPECT_GT(rig.q(0), 0.5);
  EXPECT_LT(rig.q(0), angle);
  EXPECT_EQ(rig.head().fault_kind, 0);
}

// An obstacle that is not avoided is touched, and the sensor at the point says how hard: at rest
// as hard as the law of the goal presses, K times the mass times the error.
TEST(Avoidance, AnObstacleThatIsNotAvoidedIsFelt) {
  Obstacle wall = turned_box();
  wall.center[0] = 0.5;  // its face is at x = 0.3
  wall.avoided = false;
  Rig<test::Gantry> rig({0, 0, 0}, {wall}, {kCarriage});
  rig.send(Instruction::move_joint, {0, 0, 0.32}, 1.0);
  for (int i = 0; i < 3000; ++i) rig.step();
  const double pressed = 225.0 * test::Gantry::kMass * (0.32 - rig.q(0));
  EXPECT_NEAR(rig.at(Rig<test::Gantry>::kLayout.contact_forces), -pressed, 1e-6);
  EXPECT_GT(pressed, 5.0);
  EXPECT_NEAR(rig.q(0), 0.3, 1e-3);
}

}  // namespace
}  // namespace treeline::drive
