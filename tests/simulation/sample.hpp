#pragma once

#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"
#include "random_state.hpp"
#include "simulation/state.hpp"

namespace treeline::tests {

struct Sample {
  simulation::Model model;
  simulation::State state;
};

/// A random mechanism in a random state, in double.
inline Sample random_sample(std::uint64_t seed, const RandomOptions& options, double speed = 1) {
  const RandomMechanism made = random_mechanism(seed, options);
  Sample sample{model_from_robot<double>(made.robot, made.scene), {}};
  sample.model.gravity = {0, 0, -9.81};
  Rng rng(seed + 99);
  sample.state.q = random_position(rng, sample.model, 1);
  sample.state.qd = random_entries<double>(rng, sample.model.nv, speed);
  return sample;
}

inline interpreter::Body<double> ball(double mass, double radius) {
  interpreter::Body<double> body;
  body.kind = interpreter::JointKind::floating;
  body.mass = mass;
  body.inertia = 0.4 * mass * radius * radius * simulation::Matrix3::Identity();
  return body;
}

/// Balls of 1 kg and 0.1 m radius, each on a floating joint of its own, at rest.
inline Sample balls(int count) {
  Sample sample;
  for (int i = 0; i < count; ++i) interpreter::add_body(sample.model, ball(1, 0.1));
  sample.state.q = simulation::Vector::Zero(7 * count);
  sample.state.qd = simulation::Vector::Zero(6 * count);
  for (int i = 0; i < count; ++i) sample.state.q(7 * i + 6) = 1;
  return sample;
}

}  // namespace treeline::tests
