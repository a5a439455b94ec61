#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "description/robot_queries.hpp"
#include "launch/driven_scenes.hpp"

namespace treeline {
namespace {

double length(const std::array<double, 3>& xyz) {
  return std::hypot(xyz[0], xyz[1], xyz[2]);
}

/// Mass of what joints move, kg: of all links but the root, if that is held.
double moved_mass(const Robot& robot, const Scene& scene) {
  const double all = total_mass(robot);
  const Link& root = robot.links[static_cast<std::size_t>(robot.root)];
  return scene.base == Base::fixed && root.inertial ? all - root.inertial->mass : all;
}

/// The longest way from the root to an operational point, along the joints' origins, m.
double longest_way(const Robot& robot, const Scene& scene) {
  double longest = 0;
  for (const ScenePoint& point : scene.operational_points) {
    double way = length(point.origin.xyz);
    std::string link = point.link;
    for (bool found = true; found;) {
      found = false;
      for (const Joint& joint : robot.joints) {
        if (robot.links[static_cast<std::size_t>(joint.child)].name != link) continue;
        link = robot.links[static_cast<std::size_t>(joint.parent)].name;
        way += length(joint.origin.xyz);
        found = true;
        break;
      }
    }
    longest = std::max(longest, way);
  }
  return longest;
}

}  // namespace

void assume_damping(const Robot& robot, Scene& scene, Diagnostics& diagnostics) {
  constexpr double kTimesHeavier = 6;
  constexpr double kShareOfReach = 0.125;
  if (scene.operational_points.empty() || scene.damped || scene.singular == SingularTasks::exact ||
      has_priorities(scene.operational_points)) {
    return;
  }
  const double mass = kTimesHeavier * moved_mass(robot, scene);
  const double radius = kShareOfReach * longest_way(robot, scene);
  if (!(mass > 0 && radius > 0)) return;
  scene.damped = EffectiveMassLimit{mass, mass * radius * radius};
  diagnostics.add({Severity::note, scene.file, 0, "operational_points",
                   fmt::format("near singularities the task yields in directions that feel heavier "
                               "than {:.3g} kg or {:.3g} kg m^2",
                               scene.damped->mass, scene.damped->inertia),
                   "`damped` in the scene states other figures, `singular: exact` none"});
}

}  // namespace treeline
