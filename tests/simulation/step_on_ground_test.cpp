#include "simulation/step_on_ground.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "simulation/sample.hpp"

// Would catch: contacts that make energy, impulses that are not counted or act at the wrong place,
// bodies that sink, points that are chosen so that a robot tips over, and links that cannot move
// and yet touch the ground.

namespace treeline::tests {
namespace {

using namespace simulation;  // NOLINT(google-build-using-namespace)
using simulation::State;

const RandomOptions kFallingTree{
    .joints = 6, .branching = 0.5, .mix = {5, 1, 1, 0, 0.3, 0.3}, .floating_base = true};

/// A ball about each link's origin.
std::vector<GroundShape> balls_on(const Model& model, double radius) {
  std::vector<GroundShape> shapes;
  for (int i = 0; i < model.size(); ++i) {
    shapes.push_back({i, model.body(i).name, {Vector3::Zero()}, radius});
  }
  return shapes;
}

/// Stops on either side of where the joints are.
std::vector<JointRange> ranges_about(const Sample& sample, double reach) {
  std::vector<JointRange> ranges;
  for (const auto& body : sample.model.bodies) {
    if (interpreter::velocity_count(body.kind) != 1) continue;
    const double q = sample.state.q[body.q];
    ranges.push_back({body.q, body.v, q - reach, q + reach});
  }
  return ranges;
}

GroundShape box_on(int body, const Vector3& half) {
  GroundShape box{body, "box", {}};
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 signs(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    box.points.emplace_back(half.cwiseProduct(signs));
  }
  return box;
}

class Falling {
 public:
  Falling(Sample sample, std::vector<GroundShape> shapes, const Surface& surface,
          std::vector<JointRange> ranges = {})
      : sample_(std::move(sample)),
        ground_(sample_.model, std::move(shapes), std::move(ranges)),
        surface_(surface),
        coordinates_(coordinates_of(sample_.model)) {
    if (!ground_.is_in_reach()) return;
    state().q(2) += ground_.lowest(sample_.model, state().q).depth + 0.3;
  }

  void step(double dt) {
    const Acceleration free = [this](double, const State& at) {
      return interpreter::forward_dynamics<double>(sample_.model, at.q, at.qd,
                                                   Vector::Zero(sample_.model.nv));
    };
    const Flight flight = [&](double time, double part, State& at) {
      step_runge_kutta(coordinates_, free, time, part, at);
      return true;
    };
    const OnGround robot{sample_.model, ground_, surface_, flight};
    ASSERT_TRUE(step_on_ground(robot, 0, dt, state(), account));
  }

  State& state() { return sample_.state; }
  [[nodiscard]] double energy() const { return mechanical_energy(sample_.model, sample_.state); }
  [[nodiscard]] Vector3 linear_momentum() const {
    return momentum(sample_.model, sample_.state).head<3>();
  }

  GroundAccount account;

 private:
  Sample sample_;
  Ground ground_;
  Surface surface_;
  Coordinates coordinates_;
};

double mass_of(const Model& model) {
  double mass = 0;
  for (const auto& body : model.bodies) mass += body.mass;
  return mass;
}

// Contacts only take, by what is counted; the rest is the error of flight, (rate dt)^4 with rates
// of some 30/s.
TEST(StepOnGround, NeverMakesEnergy) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const Surface surface{seed % 3 == 0 ? 0.7 : 0, seed % 2 == 0 ? 0.6 : 0, 0.01};
    const Sample sample = random_sample(seed, kFallingTree);
    Falling robot(sample, balls_on(sample.model, 0.05), surface, ranges_about(sample, 0.2));
    const double start = robot.energy();
    double taken = 0;
    for (int i = 0; i < 500; ++i) {
      robot.step(1e-3);
      const double by_contacts = robot.account.energy - taken;
      EXPECT_LE(by_contacts, 1e-12 * (1 + std::abs(start))) << i;
      taken = robot.account.energy;
    }
    EXPECT_LT(taken, 0);
    EXPECT_NEAR(robot.energy() - start, taken, 1e-6 * (1 + std::abs(start)));
    EXPECT_EQ(robot.account.unconverged, 0);
  }
}

// Gravity and the counted impulses change the momentum, and nothing else does, but for coordinates
// that contacts move while velocities stay: an error of first order, which a tenth of the step
// makes at most a fifth.
TEST(StepOnGround, CountsTheMomentumThatTheGroundGives) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const Sample sample = random_sample(seed, kFallingTree);
    const auto miss = [&](int steps) {
      Falling robot(sample, balls_on(sample.model, 0.05), {0, 0.6, 0});
      const Vector3 start = robot.linear_momentum();
      for (int i = 0; i < steps; ++i) robot.step(0.35 / steps);
      const Vector3 weight = 0.35 * mass_of(sample.model) * sample.model.gravity;
      EXPECT_GT(robot.account.impulse.z(), 0);
      return (robot.linear_momentum() - start - weight - robot.account.impulse).norm() /
             robot.account.impulse.norm();
    };
    const double coarse = miss(175);
    EXPECT_LT(coarse, 0.01);
    EXPECT_LT(miss(1750), 0.2 * coarse + 1e-9);
  }
}

// Joints that are thrown against their stops, in flight.
TEST(StepOnGround, KeepsJointsBetweenTheirStops) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    const Sample sample = random_sample(seed, kFallingTree, 3);
    const auto ranges = ranges_about(sample, 0.1);
    Falling robot(sample, {}, {}, ranges);
    double farthest = 0;
    for (int i = 0; i < 300; ++i) {
      robot.step(1e-3);
      for (const JointRange& range : ranges) {
        const double q = robot.state().q[range.q];
        farthest = std::max({farthest, range.lower - q, q - range.upper});
      }
    }
    EXPECT_LT(robot.account.energy, 0);
    EXPECT_LT(farthest, 1e-3);
  }
}

// The depth that a step leaves is of second order.
TEST(StepOnGround, LetsNothingSink) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const Sample sample = random_sample(seed, kFallingTree);
    Falling robot(sample, balls_on(sample.model, 0.05), {0, 0.5, 0});
    for (int i = 0; i < 1000; ++i) robot.step(1e-3);
    EXPECT_GT(robot.account.impulse.z(), 0);
    EXPECT_LT(robot.account.deepest, 1e-3);
  }
}

// A box on some corners of its base but not on the others would tip.
TEST(Ground, ChoosesPointsThatABodyCanStandOn) {
  Sample sample = balls(1);
  GroundShape many = box_on(0, {0.2, 0.1, 0.1});
  for (int i = 0; i < 50; ++i) {  // more points in the base, all the same height
    const double turn = i * 2 * std::numbers::pi / 50;
    many.points.emplace_back(0.05 * std::cos(turn), 0.05 * std::sin(turn), -0.1);
  }
  const Ground ground(sample.model, {many});
  sample.state.q(2) = 0.0999;
  const GroundTouches found = ground.touches(sample.model, sample.state, {});
  ASSERT_EQ(found.touches.size(), 4U);
  for (const Touch& touch : found.touches) {
    EXPECT_NEAR(std::abs(touch.position.x()), 0.2, 1e-12);
    EXPECT_NEAR(std::abs(touch.position.y()), 0.1, 1e-12);
    EXPECT_NEAR(touch.depth, 1e-4, 1e-12);
  }
}

TEST(Ground, CountsWhatIsBeyondTheMost) {
  const Sample sample = balls(6);
  std::vector<GroundShape> shapes;
  for (int i = 0; i < 6; ++i) shapes.push_back(box_on(i, {0.1, 0.1, 0.1}));
  const Ground ground(sample.model, shapes);
  const GroundTouches found = ground.touches(sample.model, sample.state, {});  // all at z = 0
  EXPECT_EQ(found.touches.size(), 16U);
  EXPECT_EQ(found.left_out, 8);
  EXPECT_EQ(found.speeds.size(), 16U);
}

TEST(Ground, CountsStopsBeyondTheMostOfABlow) {
  const Sample sample = random_sample(1, {.joints = 70, .mix = {1, 0, 0, 0, 0, 0}});
  ASSERT_GT(sample.model.nv, kMostTouches);
  auto ranges = ranges_about(sample, 0);
  for (JointRange& range : ranges) range.upper = (range.lower += 0.1) + 1;  // all are beyond
  const Ground ground(sample.model, {}, ranges);
  const GroundTouches found = ground.touches(sample.model, sample.state, {});
  EXPECT_EQ(found.touches.size(), static_cast<std::size_t>(kMostTouches));
  EXPECT_EQ(found.left_out, sample.model.nv - kMostTouches);
  State state = sample.state;
  EXPECT_NO_THROW(strike(sample.model, found.touches, {}, state));
}

TEST(Ground, DoesNotTouchWhatCannotMove) {
  const Sample sample = random_sample(1, {.joints = 3, .mix = {1, 0, 0, 0, 0, 0}});
  const Ground ground(sample.model, {box_on(0, {1, 1, 1})});
  EXPECT_FALSE(ground.is_in_reach());
}

}  // namespace
}  // namespace treeline::tests
