#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Motions that no inertia feels in any pose, all those with one joint, or the base, in the lead:
/// of the null space of M.
struct MasslessDirections {
  std::string what;                ///< `joint "a" against rotation of the base about z`
  std::string joint;               ///< that leads; empty: the base
  bool one_degree = false;         ///< the joint has one degree of freedom
  bool moves_base = false;         ///< a floating base takes part
  std::vector<std::string> links;  ///< that they move, from the root outward
};

/// Those of a robot in a scene, in the order of the joints; none where M has an inverse that double
/// precision can tell from none: in some pose no eigenvalue of M, scaled by the sizes of its terms
/// to a unit diagonal, is within 2^-46 of zero. M is computed in 50 digits at two poses drawn from
/// a fixed seed.
std::vector<MasslessDirections> find_massless_directions(const Robot& robot, const Scene& scene);

}  // namespace treeline
