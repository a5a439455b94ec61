#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "comparison/difference.hpp"

namespace treeline {
namespace {

bool is_close(double a, double b, double tolerance) {
  if (a == b || std::isinf(a) || std::isinf(b)) return a == b;
  return std::abs(a - b) <= tolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

class JointComparison {
 public:
  JointComparison(const Robot& first, const Robot& second, const RobotMatch& match,
                  double tolerance, JointDifference& difference)
      : first_(first),
        second_(second),
        match_(match),
        tolerance_(tolerance),
        difference_(difference) {}

  void compare(const Joint& a, const Joint& b) {
    if (a.type != b.type) {
      add(fmt::format("type: {} and {}", joint_type_name(a.type), joint_type_name(b.type)));
    }
    compare_mimics(a, b);
    const Limits limits_a = a.limits.value_or(Limits{}), limits_b = b.limits.value_or(Limits{});
    compare("lower", limits_a.lower, limits_b.lower);
    compare("upper", limits_a.upper, limits_b.upper);
    compare("effort", limits_a.effort, limits_b.effort);
    compare("velocity", limits_a.velocity, limits_b.velocity);
    compare("damping", a.damping, b.damping);
    compare("friction", a.friction, b.friction);
  }

 private:
  void add(std::string fault) { difference_.faults.push_back(std::move(fault)); }

  void compare(const char* what, double a, double b) {
    if (!is_close(a, b, tolerance_)) add(fmt::format("{}: {} and {}", what, a, b));
  }

  static std::string describe(const Robot& robot, const Joint& joint) {
    if (!joint.mimic) return "none";
    return fmt::format("{} * {} + {}", joint.mimic->multiplier,
                       robot.joints[static_cast<std::size_t>(joint.mimic->joint)].name,
                       joint.mimic->offset);
  }

  void compare_mimics(const Joint& a, const Joint& b) {
    if (!a.mimic && !b.mimic) return;
    if (a.mimic && b.mimic && is_same(*a.mimic, *b.mimic)) return;
    add(fmt::format("mimics: {} and {}", describe(first_, a), describe(second_, b)));
  }

  [[nodiscard]] bool is_same(const Mimic& a, const Mimic& b) const {
    const auto is_pair = [&](const Match& pair) {
      return pair.first == a.joint && pair.second == b.joint;
    };
    return std::any_of(match_.joints.begin(), match_.joints.end(), is_pair) &&
           is_close(a.multiplier, b.multiplier, tolerance_) &&
           is_close(a.offset, b.offset, tolerance_);
  }

  const Robot& first_;
  const Robot& second_;
  const RobotMatch& match_;
  double tolerance_;
  JointDifference& difference_;
};

}  // namespace

void compare_joints(const Robot& first, const Robot& second, const RobotMatch& match,
                    RobotDifference& difference) {
  for (const Match& pair : match.joints) {
    const Joint& a = first.joints[static_cast<std::size_t>(pair.first)];
    const Joint& b = second.joints[static_cast<std::size_t>(pair.second)];
    difference.joints.push_back({a.name, b.name, {}});
    JointComparison(first, second, match, difference.tolerance, difference.joints.back())
        .compare(a, b);
  }
}

}  // namespace treeline
