#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "description/read_number.hpp"
#include "description/urdf_parts.hpp"

namespace treeline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// From here on a number stands for no limit. Nothing turns 1600 times between two ends, or slides
/// as far in metres.
constexpr double kFarthest = 1e4;  // rad or m
/// Fast dental drills turn with 40,000 rad/s and no joint does.
constexpr double kFastest = 1e4;  // rad/s or m/s
/// The cylinder of a large excavator's boom pushes with 0.8 MN.
constexpr double kStrongest = 1e6;  // N m or N

/// Few joints turn more than twice and have an end; 1000 and more mean that there is none.
void warn_of_degrees(const UrdfElement& element, const Limits& limits) {
  constexpr double kTwoTurns = 12.6, kDegrees = 720;  // rad, and the degrees of as many turns
  const double most = std::max(std::abs(limits.lower.value()), std::abs(limits.upper.value()));
  if (most <= kTwoTurns || most > kDegrees) return;
  element.reading().pass_over(
      Severity::warning, "limits in degrees", element.line(), element.path(),
      fmt::format("the limits {} and {} rad let the joint turn more than twice",
                  limits.lower.value(), limits.upper.value()),
      kRadiansForDegrees);
}

/// The limit `written`, where no more than `most` is one. The largest number that a file may have
/// is no placeholder: the URDF of an MJCF or SDF file has it where that states no limit.
Limit limit_of(double written, double most, double none) {
  if (std::isinf(written) || std::abs(written) == kLargestNumber) return none;
  if (std::abs(written) < most) return written;
  return Limit::implausible(Placeholder::enormous, written, none);
}

/// Says that a range is stated of a joint that moves without one.
void pass_over_range(const UrdfElement& element, JointType type, double low, double high) {
  const JointTypeInfo& info = info_of(type);
  if (!info.moves() || !(low < high)) return;
  element.reading().pass_over(
      Severity::warning, fmt::format("range of a {} joint", info.name), element.line(),
      element.path(),
      fmt::format("the range {} to {} of a {} joint is ignored", low, high, info.name),
      info.has_one_freedom() ? "type=\"revolute\" has a range"
                             : "URDF does not say which of its coordinates that would be of");
}

void read_range(const UrdfElement& element, JointType type, Limits& limits) {
  const auto lower = element.number("lower", true);
  const auto upper = element.number("upper", true);
  if (!info_of(type).has_range) {
    pass_over_range(element, type, lower.value_or(0), upper.value_or(0));
    return;
  }
  if (!element.has("lower") && !element.has("upper")) {
    element.warn("there is neither \"lower\" nor \"upper\"; the joint counts as unlimited",
                 "give the range, or type=\"continuous\" if there is none", Minor::limit);
    return;
  }
  const double low = lower.value_or(0), high = upper.value_or(0);
  if (low < high) {
    limits.lower = limit_of(low, kFarthest, -kInfinity);
    limits.upper = limit_of(high, kFarthest, kInfinity);
    if (type == JointType::revolute) warn_of_degrees(element, limits);
    return;
  }
  const Placeholder placeholder = low > high ? Placeholder::reversed : Placeholder::equal;
  limits.lower = Limit::implausible(placeholder, low, -kInfinity);
  limits.upper = Limit::implausible(placeholder, high, kInfinity);
}

Limit read_bound(const UrdfElement& element, const char* name, double most) {
  const double bound = element.number(name, true).value_or(kInfinity);
  if (!element.has(name)) {
    element.warn(fmt::format("the attribute \"{}\" is missing; it counts as unlimited", name),
                 "add it: other readers of URDF refuse the joint without it", Minor::limit);
  }
  if (bound > 0) return limit_of(bound, most, kInfinity);
  return Limit::implausible(bound < 0 ? Placeholder::negative : Placeholder::zero, bound,
                            kInfinity);
}

}  // namespace

std::optional<Limits> read_joint_limits(const UrdfElement& joint, JointType type) {
  const auto element = joint.child("limit");
  if (!element) {
    if (info_of(type).has_range) {
      joint.warn("the joint has no <limit>; it counts as unlimited",
                 "add <limit lower=... upper=... effort=... velocity=.../>, or type=\"continuous\"",
                 Minor::limit);
    }
    return std::nullopt;
  }
  element->holds_only_attributes(
      {"lower", "upper", "effort", "velocity", "acceleration", "deceleration", "jerk"});
  Limits limits;
  limits.line = element->line();
  read_range(*element, type, limits);
  const bool moves = info_of(type).has_axis;
  if (moves || element->has("effort")) limits.effort = read_bound(*element, "effort", kStrongest);
  if (moves || element->has("velocity")) {
    limits.velocity = read_bound(*element, "velocity", kFastest);
  }
  return limits;
}

}  // namespace treeline
