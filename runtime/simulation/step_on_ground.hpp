#pragma once

#include <functional>
#include <map>
#include <utility>

#include "simulation/ground.hpp"
#include "simulation/strike.hpp"

namespace treeline::simulation {

/// Moves a state for `dt` seconds as if there were no ground; false where that fails.
using Flight = std::function<bool(double time, double dt, State& state)>;

/// What the ground did to a robot.
struct GroundAccount {
  Vector3 impulse = Vector3::Zero();  ///< N s, all of it
  double energy = 0;                  ///< J, gained by contact: never positive but for rounding
  double deepest = 0;                 ///< m, of a point after a step
  int contacts = 0;                   ///< points that were pressed in the last step
  int most_contacts = 0;              ///< the most of any step
  int bounces = 0;
  int left_out = 0;  ///< steps in which points in the ground were more than count
  std::map<std::pair<int, int>, Vector3> last;  ///< N s, of each point of a shape in the last blow
  int unconverged = 0;  ///< blows whose impulses miss a law of contact by more than 1e-9 m/s
};

/// A robot on the ground.
struct OnGround {
  const Model& model;
  const Ground& ground;
  Surface surface;
  Flight flight;
  /// Changes of velocities act for all of a step, as flight by the semi-implicit Euler method
  /// needs.
  bool whole_step = false;
  std::function<void(const Blow&)> on_blow = {};  ///< hears of each blow
};

/// Advances a robot by one step of `dt` seconds on the ground.
///
/// The robot flies. Impulses then stop the points that flew into the ground, or would next: along
/// the normal so that they are at the ground and rest there at the end, across it by Coulomb's law.
/// `Blow::dqd` acts for half of the step, as a force that is spread over it would, or for longer
/// where a point flew deeper; never for so long that the energy exceeds both what it was before the
/// step and what it was in flight.
///
/// With restitution, a point that approaches faster than `Surface::slow` cuts the step: it is
/// struck at the moment at which it touches, and all others with it (Newton's law; what bounces
/// again and again within one step stops).
///
/// Joints stop at the ends of their ranges by the same rules, without restitution and friction.
///
/// Returns false where flight failed.
bool step_on_ground(const OnGround& robot, double time, double dt, State& state,
                    GroundAccount& account);

}  // namespace treeline::simulation
