#include <cmath>

#include "check/step_library.hpp"
#include "core/mode.hpp"
#include "emission/controller_faults.hpp"

namespace treeline {
namespace {

std::size_t count_joints(const SeenStep& seen) {
  return seen.library.find(StepPart::output, "tau")->count;
}

template <class Holds>
bool any_joint(const SeenStep& seen, const Holds& holds) {
  for (std::size_t i = 0; i < count_joints(seen); ++i) {
    if (holds(i)) return true;
  }
  return false;
}

bool is_not_finite(const SeenStep& seen) {
  return any_joint(
      seen, [&](std::size_t i) { return !std::isfinite(seen.number(StepPart::output, "tau", i)); });
}

bool is_beyond_limit(const SeenStep& seen) {
  return any_joint(seen, [&](std::size_t i) {
    const long double most = seen.number(StepPart::config, "torque", i);
    return !(std::abs(seen.number(StepPart::output, "tau", i)) <= most);
  });
}

bool changes_too_fast(const SeenStep& seen) {
  if (seen.number(StepPart::state, "known") == 0) return false;
  return any_joint(seen, [&](std::size_t i) {
    const long double tau = seen.number(StepPart::output, "tau", i);
    const long double change = tau - seen.number(StepPart::state, "tau", i);
    const long double most =
        seen.number(StepPart::config, "torque_rate", i) * seen.number(StepPart::config, "period");
    return !(std::abs(change) <= most + (4 * seen.unit * (most + std::abs(tau))));
  });
}

bool is_faulted(const SeenStep& seen) {
  const auto faulted = static_cast<std::uint32_t>(core::Mode::faulted);
  return seen.bits(StepPart::output, "mode") == faulted;
}

bool disagrees_with_faults(const SeenStep& seen) {
  return is_faulted(seen) != (seen.bits(StepPart::output, "faults") != 0);
}

bool has_no_reason(const SeenStep& seen) {
  return is_faulted(seen) && seen.bits(StepPart::output, "reason") == 0;
}

bool forgets_fault(const SeenStep& seen) {
  const std::uint32_t kept = seen.bits(StepPart::output, "faults");
  return !seen.reset && (seen.bits(StepPart::state, "faults") & ~kept) != 0;
}

bool misses_lost_sensor(const SeenStep& seen) {
  const bool observes = seen.number(StepPart::config, "observer") > 0;
  const bool lost = any_joint(seen, [&](std::size_t i) {
    return !std::isfinite(seen.number(StepPart::input, "q", i)) ||
           (!observes && !std::isfinite(seen.number(StepPart::input, "qd", i)));
  });
  return lost && (seen.bits(StepPart::output, "faults") & kFaultMeasurement) == 0;
}

bool lacks_brakes(const SeenStep& seen) {
  return (seen.bits(StepPart::output, "faults") & kFaultsUntrusted) != 0 &&
         seen.number(StepPart::output, "brakes") == 0;
}

struct Rule {
  bool (*broken)(const SeenStep& seen);
  const char* says;
};

constexpr Rule kRules[] = {
    {is_not_finite, "a torque is not finite"},
    {is_beyond_limit, "a torque is beyond its limit"},
    {changes_too_fast, "a torque changes faster than torque_rate"},
    {disagrees_with_faults, "the mode is faulted without a fault, or another with one"},
    {has_no_reason, "the mode is faulted without a reason"},
    {forgets_fault, "a fault is forgotten without a reset"},
    {misses_lost_sensor, "a lost measurement is no fault"},
    {lacks_brakes, "the torque cannot be trusted, and brakes are not asked for"}};

}  // namespace

long double SeenStep::number(StepPart part, const char* member, std::size_t i) const {
  const StepNumbers& numbers = part == StepPart::config  ? config
                               : part == StepPart::state ? before
                               : part == StepPart::input ? input
                                                         : output;
  return numbers[library.find(part, member)->at + i];
}

std::uint32_t SeenStep::bits(StepPart part, const char* member) const {
  return static_cast<std::uint32_t>(number(part, member));
}

std::string find_broken_rule(const SeenStep& seen) {
  for (const Rule& rule : kRules) {
    if (rule.broken(seen)) return rule.says;
  }
  return {};
}

}  // namespace treeline
