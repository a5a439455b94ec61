#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// Removes the functions that need M^-1 from the scene if M is singular in every pose. One warning
/// names the directions without inertia and a cure. Functions that were requested by name
/// (`listed` says where: `functions` of the scene, or an option), including `damped`, are not
/// removed; an error with the same content is reported for them.
void leave_out_singular(const Robot& robot, Scene& scene, const std::string& listed,
                        Diagnostics& diagnostics);

/// Whether joint forces determine accelerations: an error with the same content says that M is
/// singular in every pose.
bool has_accelerations(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

/// Reports what `has_accelerations` does, and warns where M is singular with all coordinates at 0.
void require_accelerations(const Robot& robot, const Scene& scene, Diagnostics& diagnostics);

/// Motions without inertia in any pose, that is, a part of the null space of M. Each of these
/// groups has one joint, or the base, in the lead.
struct MasslessDirections {
  std::string what;                ///< `joint "a" against rotation of the base about z`
  std::string joint;               ///< leading joint; empty: the base
  bool one_degree = false;         ///< the joint has one degree of freedom
  bool moves_base = false;         ///< a floating base moves too
  std::vector<std::string> links;  ///< links that move, from the root outward
};

/// Finds the massless directions of a robot in a scene, in the order of the joints. The list is
/// empty if M is invertible within double precision: in some pose every eigenvalue of M, scaled to
/// a unit diagonal by the sizes of its terms, exceeds 2^-46. M is computed in 50 digits at two
/// poses drawn from a fixed seed.
std::vector<MasslessDirections> find_massless_directions(const Robot& robot, const Scene& scene);

/// Finds the directions that are massless where all coordinates are 0, though they need not be so
/// elsewhere: three axes through one point with rings without inertia between them, of which two
/// agree there. The list is empty if M is invertible there within double precision.
std::vector<MasslessDirections> find_massless_at_zero(const Robot& robot, const Scene& scene);

}  // namespace treeline
