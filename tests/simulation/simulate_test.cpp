#include "simulation/simulate.hpp"

#include <gtest/gtest.h>

#include "simulation/sample.hpp"

// Would catch: bodies that sink into the ground, bounces that gain height, objects that pass
// through each other, sliding without the deceleration by friction, and an energy account that does
// not balance.

namespace treeline::tests {
namespace {

using namespace simulation;  // NOLINT(google-build-using-namespace)

TEST(Simulate, BallBouncesToTheHeightThatRestitutionLeaves) {
  Sample sample = balls(1);
  sample.state.q(2) = 1.1;  // falls 1 m
  const CollisionScene scene(sample.model, {sphere_on(0, 0.1), ground()});
  auto run = start_simulation(sample.model, scene, {.step = 1e-4, .surface = {.restitution = 0.8}},
                              sample.state);
  double highest = 0;
  while (run.time < 1.2) {  // once down, once up
    step(run);
    if (run.blows > 0 && run.state.qd(2) > 0) highest = std::max(highest, run.state.q(2) - 0.1);
  }
  // One step late, so about half of the step's depth and speed off.
  EXPECT_NEAR(highest, 0.64, 2e-3);
  EXPECT_LT(std::abs(run.energy.drift()), 0.02);
  EXPECT_LT(run.worst_account, 1e-12);
}

TEST(Simulate, BoxOfBallsRestsAndDoesNotSink) {
  Sample sample = balls(1);
  std::vector<Shape> shapes{ground()};
  for (const double x : {-0.3, 0.3}) {
    for (const double y : {-0.2, 0.2}) {
      shapes.push_back(sphere_on(0, 0.1));
      shapes.back().p = {x, y, 0};
    }
  }
  const CollisionScene scene(sample.model, shapes);
  sample.state.q(2) = 0.0999;
  auto run = start_simulation(sample.model, scene, {}, sample.state);
  for (int i = 0; i < 1000; ++i) step(run);
  EXPECT_NEAR(run.state.q(2), 0.0999, 1e-9);
  EXPECT_LT(run.state.qd.norm(), 1e-9);
}

// v^2 / (2 mu g), then at rest.
TEST(Simulate, SledSlidesAsFarAsFrictionLets) {
  Sample sample = balls(1);
  std::vector<Shape> shapes{ground()};
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      shapes.push_back(sphere_on(0, 0.1));
      shapes.back().p = {x, y, 0};
    }
  }
  const CollisionScene scene(sample.model, shapes);
  sample.state.q(2) = 0.0999;
  sample.state.qd(0) = 1;
  auto run = start_simulation(sample.model, scene, {.surface = {.friction = 0.3}}, sample.state);
  for (int i = 0; i < 1000; ++i) step(run);
  EXPECT_NEAR(run.state.q(0), 1 / (2 * 0.3 * 9.81), 2e-3);
  EXPECT_LT(run.state.qd.norm(), 1e-8);
}

// A ball thrown at another one at rest, both in the air.
TEST(Simulate, ObjectsMeetEachOther) {
  Sample sample = balls(2);
  sample.model.gravity.setZero();
  sample.state.q.segment<3>(7) << 0.5, 0.05, 0;
  sample.state.qd(0) = 1;
  const CollisionScene scene(sample.model, {sphere_on(0, 0.1), sphere_on(1, 0.1)});
  auto run = start_simulation(sample.model, scene, {.surface = {.restitution = 1}}, sample.state);
  const auto before = momentum(sample.model, run.state);
  while (run.time < 1) step(run);
  EXPECT_GT(run.blows, 0);
  EXPECT_GT(run.state.qd(6), 0.8);
  EXPECT_LT((momentum(sample.model, run.state) - before).norm(), 1e-9);
  EXPECT_NEAR(run.energy.now, run.energy.start, 1e-9);
}

}  // namespace
}  // namespace treeline::tests
