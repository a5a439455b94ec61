#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "description/urdf_parts.hpp"

namespace treeline {
namespace {

/// Files round a follower's limits: by no more they are those of its leader.
constexpr double kRoundingOfLimits = 1e-6;

/// Whether `inner` is nearer to zero speed, or to the other end of a range, than `outer`.
bool is_narrower(double inner, double outer) {
  if (std::isinf(inner) || std::isinf(outer)) return inner < outer;
  return outer - inner > kRoundingOfLimits * std::max(std::abs(inner), std::abs(outer));
}

/// Narrows `own` to `other`. Tells whether a limit that a file states is narrower now.
bool narrow(Limit& own, double other, double side) {
  if (!is_narrower(side * other, side * own)) return false;
  const bool was_stated = own.is_stated();
  own = other;
  return was_stated;
}

/// Limits of the leader that a follower permits.
Limits limits_of_leader(const Limits& follower, const Mimic& mimic) {
  Limits limits;
  double lower = (follower.lower - mimic.offset) / mimic.multiplier;
  double upper = (follower.upper - mimic.offset) / mimic.multiplier;
  if (mimic.multiplier < 0) std::swap(lower, upper);
  limits.lower = lower;
  limits.upper = upper;
  limits.velocity = follower.velocity / std::abs(mimic.multiplier);
  return limits;
}

/// Warns of the limits of a follower.
void warn(const NamedJoint& named, const std::string& kind, const std::string& fault) {
  const UrdfElement& element = named.element;
  element.reading().pass_over(Severity::warning, kind, named.joint.limits->line,
                              element.path() + "/limit", fault,
                              "make the limits, the multiplier or the offset agree");
}

/// Narrows the leader's range. Tells whether a limit of it that a file states is narrower now.
bool narrow_range(const NamedJoint& named, const Joint& leader, const Limits& permitted,
                  Limits& own) {
  Limits range = own;
  const bool narrows_lower = narrow(range.lower, permitted.lower, -1);
  const bool narrows_upper = narrow(range.upper, permitted.upper, 1);
  if (range.lower < range.upper) {
    own = range;
    return narrows_lower || narrows_upper;
  }
  warn(named, "mimic/no common position",
       fmt::format(
           "\"{}\" has no room from {} to {} that keeps \"{}\", which follows it, within its "
           "limits: these are left out",
           leader.name, own.lower.value(), own.upper.value(), named.joint.name));
  return false;
}

void fold(const NamedJoint& named, const Joint& follower, Joint& leader) {
  const Limits permitted = limits_of_leader(*follower.limits, *follower.mimic);
  Limits own = leader.limits.value_or(Limits{});
  if (!leader.limits) own.line = leader.line;
  const bool slows = narrow(own.velocity, permitted.velocity, 1);
  const bool narrows = narrow_range(named, leader, permitted, own);
  leader.limits = own;
  if (!slows && !narrows) return;
  const std::string range =
      narrows ? fmt::format("from {} to {}", own.lower.value(), own.upper.value()) : "";
  const std::string speed = slows ? fmt::format("up to {} a second", own.velocity.value()) : "";
  warn(named, "mimic/limits",
       fmt::format(
           "limits of \"{}\", which follows \"{}\", permit the latter less than its own do: {}{}{}",
           follower.name, leader.name, range, narrows && slows ? ", " : "", speed));
}

}  // namespace

void fold_follower_limits(const std::vector<NamedJoint>& joints, Robot& robot) {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const Joint& follower = robot.joints[i];
    if (!follower.mimic || !follower.limits || follower.mimic->multiplier == 0) continue;
    fold(joints[i], follower, robot.joints[static_cast<std::size_t>(follower.mimic->joint)]);
  }
}

}  // namespace treeline
