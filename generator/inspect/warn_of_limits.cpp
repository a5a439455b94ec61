#include "inspect/warn_of_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "description/join_robots.hpp"
#include "functions/quantity.hpp"

namespace treeline {
namespace {

enum class Guard { position, speed, force };

/// Limits of files that are told as one, and what is said of them.
struct LimitRow {
  const char* attribute;  ///< of the ends of a range the upper one
  Limit Limits::*limit;
  Guard guard;
  const char* driven;  ///< how `drive` moves a joint without it
  const char* remedy;
};

constexpr std::array kLimits = {
    LimitRow{"upper", &Limits::upper, Guard::position, "anywhere",
             "give the range, type=\"continuous\" if there is none, or type=\"fixed\""},
    LimitRow{"velocity", &Limits::velocity, Guard::speed, "at any speed",
             "give the largest speed, rad/s or m/s"},
    LimitRow{"effort", &Limits::effort, Guard::force, "with any force",
             "give the largest force, N m or N"}};

/// Whether it is the lower end that is told of the joint's range.
bool tells_lower(const Limits& limits, const LimitRow& row) {
  return row.guard == Guard::position && limits.lower.state() == LimitState::implausible;
}

const Limit& told_limit(const Limits& limits, const LimitRow& row) {
  return tells_lower(limits, row) ? limits.lower : limits.*row.limit;
}

constexpr std::array kPlaceholders = {Placeholder::zero, Placeholder::negative,
                                      Placeholder::enormous, Placeholder::reversed,
                                      Placeholder::equal};

std::string describe_placeholder(const Joint& joint, const LimitRow& row) {
  const Limit& limit = told_limit(*joint.limits, row);
  const std::string written = fmt::format(
      "{}={:g}", tells_lower(*joint.limits, row) ? "lower" : row.attribute, limit.written());
  switch (limit.placeholder()) {
    case Placeholder::reversed:
      return fmt::format("{} is above upper={:g}", written, joint.limits->upper.written());
    case Placeholder::equal:
      return fmt::format("lower and upper are both {:g}", limit.written());
    case Placeholder::enormous:
      return written + " is more than anything reaches";
    case Placeholder::negative:
      return written + " is negative";
    case Placeholder::zero:
    case Placeholder::none:
      break;
  }
  return written;
}

/// Range that bounds of rounding errors assume where the URDF has no limit.
std::string bound_without(const Joint& joint, Guard guard) {
  const bool slides = info_of(joint.type).slides();
  if (guard == Guard::speed) {
    return fmt::format("{} {}", info_of(Quantity::qd).range, slides ? "m/s" : "rad/s");
  }
  if (guard == Guard::force) {
    return fmt::format("{} {}", info_of(Quantity::tau).range, slides ? "N" : "N m");
  }
  return slides ? fmt::format("{} m", kPositionRange) : "half a turn";
}

class LimitSummary {
 public:
  LimitSummary(const Robot& robot, const Scene& scene, LimitUse use, Diagnostics& diagnostics)
      : robot_(robot), scene_(scene), use_(use), diagnostics_(diagnostics) {}

  void report() const {
    for (const LimitRow& row : kLimits) {
      for (const Placeholder placeholder : kPlaceholders) report(row, placeholder);
    }
    if (use_ == LimitUse::drive) return;
    if (scene_.torque_limits_of_urdf) report_missing_efforts();
    report_fast();
  }

 private:
  template <class Applies>
  std::vector<const Joint*> joints_with(Guard guard, const Applies& applies) const {
    std::vector<const Joint*> joints;
    for (const Joint& joint : robot_.joints) {
      if (reads(joint, guard) && applies(*joint.limits)) joints.push_back(&joint);
    }
    return joints;
  }

  /// Whether anything depends on the limit. Followers have no motor, but lead those that they
  /// follow by their positions and speeds.
  [[nodiscard]] bool reads(const Joint& joint, Guard guard) const {
    const Joint& owner =
        joint.mimic ? robot_.joints[static_cast<std::size_t>(joint.mimic->joint)] : joint;
    if (!joint.limits || scene_.locked.contains(owner.name)) return false;
    const bool passive = std::count(scene_.passive.begin(), scene_.passive.end(), joint.name) > 0;
    return guard != Guard::force || (!joint.mimic && !passive);
  }

  void report(const LimitRow& row, Placeholder placeholder) const {
    const auto joints = joints_with(row.guard, [&](const Limits& limits) {
      return told_limit(limits, row).placeholder() == placeholder;
    });
    if (joints.empty()) return;
    warn(joints,
         describe_placeholder(*joints.front(), row) + count(joints) +
             ": a placeholder that counts as no limit; " + readers(*joints.front(), row),
         row.remedy);
  }

  /// Who takes what in place of the limit.
  [[nodiscard]] std::string readers(const Joint& joint, const LimitRow& row) const {
    if (use_ == LimitUse::drive) return fmt::format("drive moves the joint {}", row.driven);
    std::string text =
        fmt::format("bounds of rounding errors take {}, the table of joints has none",
                    bound_without(joint, row.guard));
    if (scene_.controller) text += ", the controller has what the scene says";
    if (row.guard == Guard::force && scene_.torque_limits_of_urdf) {
      text += ", torque_limits leaves the motor unlimited";
    }
    return text;
  }

  void report_missing_efforts() const {
    const auto joints = joints_with(Guard::force, [](const Limits& limits) {
      return limits.effort.state() == LimitState::absent;
    });
    if (joints.empty()) return;
    warn(joints,
         "no effort is stated" + count(joints) + ": torque_limits leaves the motor unlimited",
         kLimits.back().remedy);
  }

  void report_fast() const {
    const auto joints = joints_with(Guard::speed, [](const Limits& limits) {
      return limits.velocity.is_stated() && limits.velocity > kFastestInBounds;
    });
    if (joints.empty()) return;
    warn(joints,
         fmt::format("velocity={}{}: bounds of rounding errors, which grow with the square of "
                     "speeds, hold up to {} {}",
                     joints.front()->limits->velocity.value(), count(joints), kFastestInBounds,
                     info_of(joints.front()->type).slides() ? "m/s" : "rad/s"),
         "give the speed that the joint reaches");
  }

  static std::string count(const std::vector<const Joint*>& joints) {
    return joints.size() > 1 ? fmt::format(" (and {} more)", joints.size() - 1) : "";
  }

  void warn(const std::vector<const Joint*>& joints, std::string fault, const char* remedy) const {
    const Joint& first = *joints.front();
    diagnostics_.add({Severity::warning, file_of(robot_, first.name), first.limits->line,
                      fmt::format("joint[{}]/limit", first.name), std::move(fault), remedy});
  }

  const Robot& robot_;
  const Scene& scene_;
  LimitUse use_;
  Diagnostics& diagnostics_;
};

}  // namespace

void warn_of_limits(const Robot& robot, const Scene& scene, LimitUse use,
                    Diagnostics& diagnostics) {
  LimitSummary(robot, scene, use, diagnostics).report();
}

}  // namespace treeline
