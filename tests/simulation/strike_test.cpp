#include "simulation/strike.hpp"

#include <gtest/gtest.h>

#include "simulation/sample.hpp"

// Would catch: impulses that act on one side only, restitution of the wrong velocity, contacts
// without coupling, and an energy loss that differs from that of restitution.

namespace treeline::tests {
namespace {

using namespace simulation;  // NOLINT(google-build-using-namespace)
using simulation::State;

/// Touches at random points of random bodies, some against the world, some against other roots.
std::vector<Touch> random_touches(const Sample& sample, Rng& rng, int count) {
  const auto k = interpreter::kinematics<double>(sample.model, sample.state.q, sample.state.qd);
  std::vector<Touch> touches;
  for (int i = 0; i < count; ++i) {
    Touch touch;
    touch.body = rng.below(sample.model.size());
    touch.position = k.p_world[touch.body] + Vector3(random_entries<double>(rng, 3, 0.2));
    touch.normal = Vector3(random_entries<double>(rng, 3, 1)).normalized();
    touches.push_back(touch);
  }
  return touches;
}

const RandomOptions kTree{
    .joints = 8, .branching = 0.5, .mix = {5, 1, 1, 0, 0.3, 0.3}, .floating_base = true};

// Without friction the normal velocity is reversed and multiplied by e. A single contact loses (1 -
// e^2) / 2 of its effective mass times the squared approach, and the momentum changes by the
// impulse.
TEST(Strike, OfOneContactLosesWhatRestitutionSays) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Sample sample = random_sample(seed, kTree);
    Rng rng(seed);
    const Surface surface{.restitution = 0.6};
    const auto p_before = momentum(sample.model, sample.state);
    auto touches = random_touches(sample, rng, 1);
    const State before = sample.state;
    Blow blow = strike(sample.model, touches, surface, sample.state);
    if (blow.impulses.norm() == 0) {  // was parting: struck from the other side
      touches[0].normal *= -1;
      blow = strike(sample.model, touches, surface, sample.state);
    }
    const Vector3 n = touches[0].normal;
    const double approach = n.dot(blow.before.head<3>());
    EXPECT_LT(approach, 0);
    EXPECT_NEAR(n.dot(blow.after.head<3>()), -0.6 * approach, 1e-10);
    const double mass = -n.dot(blow.impulses.head<3>()) / (1.6 * approach);
    const double lost = (1 - 0.36) / 2 * mass * approach * approach;
    const double size = 1e-11 * (1 + kinetic_energy(sample.model, before));
    EXPECT_NEAR(blow.energy, -lost, size);
    EXPECT_NEAR(blow.work, -lost, size);
    const interpreter::Vector6<double> gained = momentum(sample.model, sample.state) - p_before;
    EXPECT_LT((gained.head<3>() - blow.impulses.head<3>()).norm(), 1e-10);
    const Vector3 moment = touches[0].position.cross(Vector3(blow.impulses.head<3>()));
    EXPECT_LT((gained.tail<3>() - moment).norm(), 1e-10 * (1 + moment.norm()));
  }
}

// With e = 1 and no friction the energy is constant; with e = 0 no motion could have lost more.
TEST(Strike, OfSeveralContactsKeepsOrTakesEnergy) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    for (const double e : {0.0, 0.5, 1.0}) {
      Sample sample = random_sample(seed, kTree);
      Rng rng(seed);
      const auto touches = random_touches(sample, rng, 3);
      const double start = kinetic_energy(sample.model, sample.state);
      const Blow blow = strike(sample.model, touches, {.restitution = e}, sample.state);
      ASSERT_TRUE(blow.solution.converged);
      const double small = 1e-9 * (1 + start);
      EXPECT_NEAR(blow.energy, blow.work, small);
      EXPECT_LE(blow.energy, small);
      if (e == 1.0) {
        EXPECT_NEAR(blow.energy, 0, small);
      }
      for (int i = 0; i < 3; ++i) {
        const Vector3 n = blow.touches[static_cast<std::size_t>(i)].normal;
        const double before = n.dot(blow.before.segment<3>(3 * i));
        EXPECT_GE(n.dot(blow.after.segment<3>(3 * i)), -e * before - 1e-9);
        EXPECT_GE(n.dot(blow.impulses.segment<3>(3 * i)), -1e-15);
      }
    }
  }
}

// Newton's cradle with two equal balls, which exchange their velocities.
TEST(Strike, BallsExchangeVelocities) {
  Sample sample = balls(2);
  sample.state.q.segment<3>(7) << 0.2, 0, 0;
  sample.state.qd(0) = 1;
  Touch touch;
  touch.body = 1;
  touch.other_body = 0;
  touch.position = {0.1, 0, 0};
  touch.normal = Vector3::UnitX();
  strike(sample.model, {touch}, {.restitution = 1}, sample.state);
  EXPECT_NEAR(sample.state.qd(0), 0, 1e-12);
  EXPECT_NEAR(sample.state.qd(6), 1, 1e-12);
  strike(sample.model, {touch}, {.restitution = 1}, sample.state);  // parts: nothing happens
  EXPECT_NEAR(sample.state.qd(6), 1, 1e-12);
}

TEST(Strike, LeavesOutWhatCannotMove) {
  Sample sample = random_sample(1, {.joints = 3, .mix = {1, 0, 0, 0, 0, 0}});
  Touch touch;
  touch.body = 0;  // the base, fixed to the world
  const State before = sample.state;
  EXPECT_TRUE(strike(sample.model, {touch}, {}, sample.state).touches.empty());
  EXPECT_EQ(sample.state.qd, before.qd);
}

}  // namespace
}  // namespace treeline::tests
