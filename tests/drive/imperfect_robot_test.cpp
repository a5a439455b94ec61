// Would catch: friction, play, delays, sensors or contacts that are not what was asked for, and an
// ideal robot that is no longer ideal. Closed forms of a mass on a slide.
#include "drive/imperfect_robot.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "linked_robots.hpp"
#include "servo/simulated_robot.hpp"

namespace treeline::drive {
namespace {

/// 2 kg on a slide without gravity; the link's frame is at the mass.
struct Slide {
  static constexpr int kCoordinates = 1;
  static constexpr int kVelocities = 1;
  static constexpr int kLinks = 1;
  static constexpr double kMass = 2.0;
  static void inverse_dynamics(const double (&)[1], const double (&)[1], const double (&qdd)[1],
                               double (&tau)[1]) noexcept {
    tau[0] = kMass * qdd[0];
  }
  static void forward_dynamics(const double (&)[1], const double (&)[1], const double (&tau)[1],
                               double (&qdd)[1]) noexcept {
    qdd[0] = tau[0] / kMass;
  }
  static void link_frames(const double (&q)[1], double (&p)[3], double (&R)[9]) noexcept {
    p[0] = q[0];
    p[1] = p[2] = 0.0;
    for (int i = 0; i < 9; ++i) R[i] = i % 4 == 0 ? 1.0 : 0.0;
  }
  static void link_inverse_dynamics(const double (&)[1], const double (&)[1],
                                    const double (&qdd)[1], const double (&f)[6],
                                    double (&tau)[1]) noexcept {
    tau[0] = kMass * qdd[0] - f[0];
  }
};

constexpr double kPeriod = 1e-3;

class SlideRig {
 public:
  explicit SlideRig(const SimulationOptions& options, double speed = 0.0,
                    const Surroundings& surroundings = {})
      : robot_(moving(speed), 2, {}, options, surroundings) {
    can_follow_ = robot_.can_follow_gears(kPeriod);
  }
  /// Holds a force for so many cycles.
  void push(double force, int cycles = 1) {
    for (int i = 0; i < cycles; ++i) {
      robot_.write({force});
      robot_.pass_time(kPeriod);
    }
  }
  servo::StateOf<Slide> seen() const {
    servo::StateOf<Slide> state;
    robot_.read(state);
    return state;
  }
  const ImperfectRobot<Slide>& robot() const { return robot_; }
  void restore() { robot_.restore(); }
  bool can_follow() const { return can_follow_; }

 private:
  static servo::StateOf<Slide> moving(double speed) {
    servo::StateOf<Slide> state;
    state.qd[0] = speed;
    return state;
  }
  ImperfectRobot<Slide> robot_;
  bool can_follow_ = false;
};

TEST(ImperfectRobot, IsIdealWithoutOptions) {
  servo::StateOf<test::TwoLink> start;
  start.q[0] = 0.3;
  start.q[1] = 0.8;
  servo::SimulatedRobot<test::TwoLink> ideal(start, 2);
  ImperfectRobot<test::LinkedArm> robot({{0.3, 0.8}, {0, 0}}, 2, {}, {}, {});
  EXPECT_TRUE(robot.can_follow_gears(kPeriod));
  for (int i = 0; i < 500; ++i) {
    const double tau[2] = {20 * std::sin(0.1 * i), 8.0};
    ideal.write(tau);
    robot.write(tau);
    ideal.pass_time(kPeriod);
    robot.pass_time(kPeriod);
    servo::StateOf<test::TwoLink> wanted;
    servo::StateOf<test::LinkedArm> got;
    ideal.read(wanted);
    robot.read(got);
    for (int k = 0; k < 2; ++k) {
      ASSERT_EQ(got.q[k], wanted.q[k]);
      ASSERT_EQ(got.qd[k], wanted.qd[k]);
    }
  }
}

// m dv/dt = -c v: v = v0 exp(-c t / m). Runge-Kutta steps of 0.5 ms err by less than 1e-12.
TEST(ImperfectRobot, ViscousFrictionSlowsExponentially) {
  const double viscous = 3.0;
  SimulationOptions options;
  options.viscous = &viscous;
  SlideRig rig(options, 1.0);
  rig.push(0.0, 700);
  EXPECT_NEAR(rig.seen().qd[0], std::exp(-viscous * 0.7 / Slide::kMass), 1e-12);
}

// m dv/dt = -F until it stops, after m v0 / F = 0.4 s; the smooth sign errs below 0.01 m/s.
TEST(ImperfectRobot, CoulombFrictionStopsIt) {
  const double coulomb = 5.0;
  SimulationOptions options;
  options.coulomb = &coulomb;
  SlideRig rig(options, 1.0);
  rig.push(0.0, 200);
  EXPECT_NEAR(rig.seen().qd[0], 0.5, 1e-6);
  rig.push(0.0, 300);
  EXPECT_NEAR(rig.seen().qd[0], 0.0, 1e-3);
  EXPECT_NEAR(rig.seen().q[0], 0.2, 2e-3);
  rig.push(0.5 * coulomb, 100);  // too little to move it but for creep
  EXPECT_LT(rig.seen().qd[0], 0.01);
}

TEST(ImperfectRobot, CommandsTakeEffectAfterTheDelay) {
  SimulationOptions options;
  options.delay = 3;
  SlideRig rig(options);
  rig.push(0.0);
  for (int i = 0; i < 3; ++i) {
    rig.push(4.0);
    EXPECT_EQ(rig.seen().qd[0], 0.0) << i;
  }
  rig.push(0.0);
  EXPECT_NEAR(rig.seen().qd[0], 2.0 * kPeriod, 1e-15);
  rig.push(0.0, 2);  // two more of 4 N
  EXPECT_NEAR(rig.seen().qd[0], 6.0 * kPeriod, 1e-15);
  rig.push(0.0, 10);
  EXPECT_NEAR(rig.seen().qd[0], 6.0 * kPeriod, 1e-15);
}

// Of 20000 samples the mean errs by sigma / 141 and the deviation by sigma / 200: five times that.
TEST(ImperfectRobot, NoiseHasItsDeviation) {
  const double noise = 1e-3;
  SimulationOptions options;
  options.noise = &noise;
  SlideRig rig(options);
  double sum = 0.0;
  double squares = 0.0;
  double speeds = 0.0;
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    rig.push(0.0);
    sum += rig.seen().q[0];
    squares += rig.seen().q[0] * rig.seen().q[0];
    speeds += rig.seen().qd[0] * rig.seen().qd[0];
  }
  EXPECT_NEAR(sum / kSamples, 0.0, 5 * noise / 141);
  EXPECT_NEAR(std::sqrt(squares / kSamples), noise, 5 * noise / 200);
  // White noise n, differences (n_k - n_(k-1)) / h behind v += a (d - v): the variance of v is
  // 2 a^2 / (2 - a) sigma^2 / h^2.
  const double a = 0.25;
  const double deviation = noise / kPeriod * std::sqrt(2 * a * a / (2 - a));
  EXPECT_NEAR(std::sqrt(speeds / kSamples), deviation, 0.05 * deviation);
  EXPECT_EQ(rig.robot().links().q[0], 0.0);  // the robot itself rests
}

TEST(ImperfectRobot, EncodersHaveSteps) {
  const double quantum = 0.01;
  SimulationOptions options;
  options.quantum = &quantum;
  SlideRig rig(options, 0.5);
  for (int i = 0; i < 300; ++i) {
    rig.push(0.0);
    const double steps = rig.seen().q[0] / quantum;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    EXPECT_LE(std::fabs(rig.seen().q[0] - rig.robot().links().q[0]), 0.5 * quantum + 1e-12);
  }
  EXPECT_NEAR(rig.seen().q[0], 0.15, 0.5 * quantum + 1e-12);
}

// The rotor of 1 kg crosses half the play of 2 cm alone: x = F t^2 / 2 / rotor. Then it takes the
// mass of 2 kg along, and all that the force has given is in their common momentum.
TEST(ImperfectRobot, ARotorCrossesThePlayAlone) {
  const double play = 0.02;
  const double rotor = 1.0;
  const double stiffness = 1e4;
  SimulationOptions options;
  options.play = &play;
  options.rotor = &rotor;
  options.gear_stiffness = &stiffness;
  SlideRig rig(options);
  ASSERT_TRUE(rig.can_follow());
  rig.push(1.0, 130);  // 8.45 mm
  EXPECT_NEAR(rig.seen().q[0], 0.5 * 0.13 * 0.13, 1e-12);
  EXPECT_EQ(rig.robot().links().q[0], 0.0);
  rig.push(1.0, 870);
  EXPECT_GT(rig.robot().links().q[0], 0.05);
  EXPECT_NEAR(rotor * rig.seen().qd[0] + Slide::kMass * rig.robot().links().qd[0], 1.0, 1e-9);
  EXPECT_LT(std::fabs(rig.seen().q[0] - rig.robot().links().q[0]), 0.5 * play + 1e-3);
}

TEST(ImperfectRobot, SaysWhenGearsAreTooStiff) {
  const double play = 0.02;
  const double rotor = 1e-6;
  SimulationOptions options;
  options.play = &play;
  options.rotor = &rotor;
  double stiffness = 1e9;
  options.gear_stiffness = &stiffness;
  EXPECT_FALSE(SlideRig(options).can_follow());
  stiffness = 1e3;
  EXPECT_TRUE(SlideRig(options).can_follow());
}

// Pressed against a wall it rests where the wall pushes back as hard.
/// The slide with end stops at +-0.1 m.
ImperfectRobot<Slide> stopped_slide(double place, double speed) {
  static constexpr double kLower[1] = {-0.1};
  static constexpr double kUpper[1] = {0.1};
  servo::StateOf<Slide> start;
  start.q[0] = place;
  start.qd[0] = speed;
  return {start, 2, {}, {}, {}, kLower, kUpper};
}

servo::StateOf<Slide> after(ImperfectRobot<Slide>& robot, double force, int cycles) {
  servo::StateOf<Slide> state;
  for (int i = 0; i < cycles; ++i) {
    robot.write({force});
    robot.pass_time(kPeriod);
  }
  robot.read(state);
  return state;
}

// A critically damped spring of w = 200 rad/s that only pushes lets a mass go v / (e w) beyond the
// limit and leaves it v / e^2 on the way back, when it would have to pull; under a force the mass
// rests at the limit. Would catch a stop that lets through, one that pulls, and one that throws
// back.
TEST(ImperfectRobot, RestsAtItsEndStops) {
  auto robot = stopped_slide(0.099, 2.0);
  double deepest = 0.0;
  for (int i = 0; i < 100; ++i) {
    deepest = std::fmax(deepest, after(robot, 0.0, 1).q[0] - 0.1);
  }
  // In steps of half a millisecond; they meet the stop within one.
  EXPECT_NEAR(deepest, 2.0 / (std::exp(1.0) * 200.0), 2e-4);
  EXPECT_NEAR(after(robot, 0.0, 1).qd[0], -2.0 / std::exp(2.0), 0.02);
  const auto held = after(robot, 50.0, 1000);
  EXPECT_NEAR(held.q[0], 0.1, 1e-6);
  EXPECT_NEAR(held.qd[0], 0.0, 1e-6);
  EXPECT_LT(after(robot, -50.0, 100).q[0], 0.0);  // 25 m/s^2 for 0.1 s: free to leave
}

// One that is found beyond its limit is not thrown back; on its way back it takes the stop along.
TEST(ImperfectRobot, TakesItsStopAlong) {
  auto robot = stopped_slide(0.3, 0.0);
  EXPECT_EQ(after(robot, 0.0, 100).q[0], 0.3);
  const auto back = after(robot, -2.0, 300);  // -1 m/s^2 for 0.3 s
  EXPECT_NEAR(back.q[0], 0.3 - 0.045, 1e-9);
  const auto again = after(robot, 400.0, 500);
  EXPECT_NEAR(again.q[0], 0.3 - 0.045, 0.02);  // v of 0.3 m/s the other way was taken first
  EXPECT_NEAR(again.qd[0], 0.0, 1e-6);
}

// Would catch numbers that are not finite and stay in a robot or reach a report as if measured.
TEST(ImperfectRobot, RecoversFromAMotionThatIsLost) {
  auto robot = stopped_slide(0.05, 0.0);
  EXPECT_TRUE(std::isnan(after(robot, std::numeric_limits<double>::infinity(), 1).qd[0]));
  const auto then = after(robot, 0.0, 1);
  EXPECT_EQ(then.q[0], 0.05);
  EXPECT_EQ(then.qd[0], 0.0);
}

TEST(ImperfectRobot, AWallPushesBack) {
  Obstacle wall;
  wall.center[0] = 1.0;
  wall.half[0] = wall.half[1] = wall.half[2] = 0.9;
  const GuardedPoint nose{0, -1, {0.05, 0, 0}};
  Surroundings surroundings;
  surroundings.obstacles = &wall;
  surroundings.obstacle_count = 1;
  surroundings.guarded = &nose;
  surroundings.guarded_count = 1;
  SlideRig rig({}, 0.1, surroundings);
  rig.push(10.0, 2000);
  EXPECT_NEAR(rig.robot().contact_force(0)[0], -10.0, 1e-6);
  EXPECT_NEAR(rig.seen().q[0], 0.05 + 10.0 / 2e4, 1e-6);
  EXPECT_NEAR(rig.seen().qd[0], 0.0, 1e-6);
  rig.push(-10.0, 300);
  EXPECT_EQ(rig.robot().contact_force(0)[0], 0.0);
}

// Driven beyond all numbers, the robot is measured as lost once, rests, and is where it began after
// `restore`; another one stays where it is.
TEST(ImperfectRobot, IsRestoredWhereItWasLost) {
  SlideRig lost({}, 0.5);
  lost.push(1e308, 3);
  EXPECT_TRUE(std::isfinite(lost.robot().links().q[0]));
  lost.restore();
  lost.push(0.0);
  EXPECT_NEAR(lost.seen().q[0], 0.5 * kPeriod, 1e-12);
  SlideRig thrown({});
  thrown.push(1e6, 10);
  thrown.restore();
  EXPECT_EQ(thrown.seen().q[0], 0.0);
  SlideRig moved({}, 0.5);
  moved.push(1.0, 100);
  const double q = moved.seen().q[0];
  moved.restore();
  EXPECT_EQ(moved.seen().q[0], q);
}

}  // namespace
}  // namespace treeline::drive
