#pragma once

#include <vector>

#include "core/contact_solver.hpp"
#include "simulation/collide.hpp"

namespace treeline::simulation {

/// What holds wherever shapes touch.
struct Surface {
  double restitution = 0;
  double friction = 0;
  double slow = 0;      ///< m/s: slower approaches do not bounce
  double push_out = 0;  ///< 1/s: speed at which touching shapes part, for each metre of overlap
};

/// What blows did. Energies are kinetic: nothing moves while they last.
struct Blow {
  std::vector<Touch> touches;
  Vector impulses;  ///< N s on each touch's `body`, world axes, three entries each
  Vector before;    ///< velocities of the points of `body` seen from `other_body`
  Vector after;
  double energy = 0;  ///< J gained, from the states before and after
  double work = 0;    ///< J, y . (v before + v after) / 2: the same, from the contacts alone
  /// N s, N m s gained: momentum and angular momentum about the world's origin, from the states.
  interpreter::Vector6<double> momentum = interpreter::Vector6<double>::Zero();
  double restitution = 0;  ///< that was asked for
  core::ContactSolution solution;
};

/// Applies the impulses that the touches ask for to the state's velocities: contact-space inverse
/// inertia by table 5.3, `core::solve_contacts`, impulse propagation by table 8.2. Touches that no
/// motion can relieve, between bodies that do not move, are left out.
Blow strike(const Model& model, std::vector<Touch> touches, const Surface& surface, State& state);

}  // namespace treeline::simulation
