#include "inspect/warn_of_limits.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "description/join_robots.hpp"

namespace treeline {
namespace {

void warn(const Robot& robot, const std::vector<const Joint*>& joints, const std::string& fault,
          const char* remedy, Diagnostics& diagnostics) {
  if (joints.empty()) return;
  const Joint& first = *joints.front();
  const std::string more =
      joints.size() > 1 ? fmt::format(" (and {} more)", joints.size() - 1) : "";
  diagnostics.add({Severity::warning, file_of(robot, first.name), first.line,
                   fmt::format("joint[{}]/limit", first.name), fault + more, remedy});
}

}  // namespace

void warn_of_limits(const Robot& robot, const Scene& scene, Diagnostics& diagnostics) {
  std::vector<const Joint*> at_one_place, without_speed, without_force;
  for (const Joint& joint : robot.joints) {
    if (!joint.limits || joint.mimic || scene.locked.contains(joint.name)) continue;
    if (joint.limits->lower == joint.limits->upper) at_one_place.push_back(&joint);
    if (joint.limits->velocity == 0) without_speed.push_back(&joint);
    if (joint.limits->effort == 0) without_force.push_back(&joint);
  }
  warn(robot, at_one_place, "lower and upper are the same: the joint cannot move",
       "give the range, type=\"continuous\" if there is none, or type=\"fixed\"", diagnostics);
  warn(robot, without_speed,
       "velocity=0: the joint has no speed; bounds of rounding errors take it as unlimited",
       "give the largest speed, rad/s or m/s", diagnostics);
  warn(robot, without_force,
       "effort=0: the joint has no force; bounds of rounding errors take it as unlimited",
       "give the largest force, N m or N", diagnostics);
}

}  // namespace treeline
