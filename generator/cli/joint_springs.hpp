#pragma once

#include "cli/simulate_motion.hpp"

namespace treeline {

/// Springs and dampers in the joints; one entry for each velocity.
struct JointSprings {
  simulation::Vector stiffness, rest, damping;
  std::vector<int> coordinates;  ///< where the spring's coordinate is in q; -1: it has no spring
};

/// Springs and dampers as `settings` has them: springs in joints of one freedom, at rest at
/// `start`. With springs, both are as strong in each joint as the step permits: the eigenvalues of
/// M^-1 K step^2 and of M^-1 D step at the start are at most 1, where explicit integrators are
/// stable. A note tells how many joints are weaker for that.
JointSprings make_springs(const simulation::Model& model, const MotionSettings& settings,
                          const simulation::State& start, Diagnostics& diagnostics);

/// Their joint forces.
simulation::Vector force_of(const JointSprings& springs, const simulation::State& state);

}  // namespace treeline
