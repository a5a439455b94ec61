#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "description/mjcf/read_bodies.hpp"

namespace treeline {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Whether an actuator's control is, but for a factor, its force.
bool is_motor(const MjcfElement& element) {
  return element.name() == "motor" ||
         (element.name() == "general" && element.text("gaintype", "fixed") == "fixed" &&
          element.text("biastype", "none") == "none" && element.text("dyntype", "none") == "none");
}

double force_of(const MjcfElement& element, const MjcfCompiler& compiler) {
  const double force = bound_of(element, "forcerange", "forcelimited", compiler);
  if (!is_motor(element)) return force;
  const auto gain =
      element.name() == "general" ? element.numbers("gainprm", 1, 10) : std::vector<double>{};
  const double factor = gain.empty() ? 1 : std::abs(gain.front());
  return std::min(force, factor * bound_of(element, "ctrlrange", "ctrllimited", compiler));
}

double gear_of(const MjcfElement& element) {
  const auto gear = element.numbers("gear", 1, 6);
  return gear.empty() ? 1 : std::abs(gear.front());
}

/// The axis of the one joint that it drives; null, with a warning, where it drives something else.
FlatAxis* driven_by(const MjcfElement& element, MjcfTree& tree) {
  const char* const attribute = element.has("joint") ? "joint" : "jointinparent";
  const auto name = element.find(attribute);
  if (!name) {
    element.warn("an actuator that does not drive one joint is not read",
                 "give limits under torque_limits in the scene, or forces at points");
    return nullptr;
  }
  const auto found = tree.joints.find(*name);
  if (found == tree.joints.end()) {
    element.note("it drives no joint of the robot and is passed over", "");
    return nullptr;
  }
  auto& axes = tree.tree.joints[found->second].axes;
  return axes.empty() ? nullptr : &axes.front();
}

}  // namespace

double bound_of(const MjcfElement& element, const char* range, const char* limited,
                const MjcfCompiler& compiler) {
  const auto ends = element.numbers(range, 2, 2);
  if (!is_limited(element, limited, ends, compiler)) return kUnbounded;
  const auto [least, most] = std::minmax({std::abs(ends[0]), std::abs(ends[1])});
  if (least == most) return most;
  const bool one_way = least == 0;
  element.note(fmt::format("{} is not symmetric: {} N m or N counts as the limit either way", range,
                           one_way ? most : least),
               "");
  return one_way ? most : least;
}

void read_actuators(const std::vector<MjcfElement>& sections, const MjcfCompiler& compiler,
                    MjcfTree& tree) {
  std::map<FlatAxis*, double> sums;
  for (const MjcfElement& section : sections) {
    for (const MjcfElement& element : section.children()) {
      FlatAxis* const axis = driven_by(element, tree);
      if (axis == nullptr) continue;
      const double gear = gear_of(element);
      sums[axis] += gear * force_of(element, compiler);
      axis->armature += gear * gear * element.number("armature", 0);
    }
  }
  for (const auto& [axis, sum] : sums) axis->effort = std::min(axis->effort, sum);
}

}  // namespace treeline
