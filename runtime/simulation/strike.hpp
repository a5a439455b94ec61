#pragma once

#include <vector>

#include "core/contact_solver.hpp"
#include "simulation/touch.hpp"

namespace treeline::simulation {

/// Properties of all touching surfaces.
struct Surface {
  double restitution = 0;
  double friction = 0;
  double slow = 0;  ///< m/s: slower approaches do not bounce
};

/// Effect of blows. Energies are kinetic, because nothing moves during a blow.
struct Blow {
  std::vector<Touch> touches;
  Vector impulses;  ///< N s on the `body` of each touch, world axes, three entries each
  Vector before;    ///< velocities of the points of `body` relative to `other_body`
  Vector after;
  Vector dqd;         ///< change of the velocities qd
  double energy = 0;  ///< J gained, computed from the states before and after
  double work = 0;    ///< J gained, computed from the contacts alone: y . (v before + v after) / 2
  /// Gained momentum (N s) and angular momentum about the world's origin (N m s), computed from the
  /// states.
  interpreter::Vector6<double> momentum = interpreter::Vector6<double>::Zero();
  double restitution = 0;  ///< the restitution that was requested
  core::ContactSolution<double> solution;
};

/// Computes the impulses at the touches and applies them to the state's velocities: contact-space
/// inverse inertia J M^-1 J^T (Chang eq. 8.2), `core::ContactSolver`, dqd = M^-1 J^T y. Up to eight
/// touches meet the laws to 12 digits of the largest speed, more of them to 8. Touches
/// between bodies that cannot move are left out, since no impulse can separate them.
/// Throws std::length_error for more than 64 touches.
Blow strike(const Model& model, std::vector<Touch> touches, const Surface& surface, State& state);

}  // namespace treeline::simulation
