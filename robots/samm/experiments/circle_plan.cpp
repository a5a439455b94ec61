#include "circle_plan.hpp"

#include <algorithm>
#include <cmath>

namespace treeline::experiments {
namespace {

/// A growing angle and its rates.
struct Phase {
  double angle = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
};

/// Accelerates from rest to `rate` by a cubic in time, which takes `ramp`.
Phase ramp_up(double rate, double ramp, double time) {
  const double u = std::clamp(time / ramp, 0.0, 1.0);
  const double after = std::max(time - ramp, 0.0);
  return {rate * (ramp * u * u * u * (1.0 - 0.5 * u) + after), rate * u * u * (3.0 - 2.0 * u),
          rate * 6.0 * u * (1.0 - u) / ramp};
}

Phase phase_at(const CirclePlan& plan, double time) {
  const double kTurn = 2.0 * std::acos(-1.0);
  const double rate = kTurn / plan.period;
  const double since = std::clamp(time - plan.lead, 0.0, plan.moving_time());
  // The end is the time reversal of the beginning.
  const double left = plan.moving_time() - since;
  if (since <= left) {
    return ramp_up(rate, plan.ramp, since);
  }
  const Phase from_end = ramp_up(rate, plan.ramp, left);
  return {plan.rounds * kTurn - from_end.angle, from_end.rate, -from_end.acceleration};
}

}  // namespace

CircleMotion circles_at(const CirclePlan& plan, double time) noexcept {
  const Phase phase = phase_at(plan, time);
  const double c = std::cos(phase.angle);
  const double s = std::sin(phase.angle);
  const double square = phase.rate * phase.rate;
  // Point on the unit circle from (1, 0), whose centre is at (-1, 0) relative to the start.
  const double position[2] = {c - 1.0, s};
  const double velocity[2] = {-s * phase.rate, c * phase.rate};
  const double acceleration[2] = {-s * phase.acceleration - c * square,
                                  c * phase.acceleration - s * square};
  CircleMotion motion;
  for (int i = 0; i < 2; ++i) {
    motion.tool[1 + i] = plan.tool_radius * position[i];
    motion.tool_velocity[1 + i] = plan.tool_radius * velocity[i];
    motion.tool_acceleration[1 + i] = plan.tool_radius * acceleration[i];
    motion.base[i] = plan.base_radius * position[i];
    motion.base_velocity[i] = plan.base_radius * velocity[i];
    motion.base_acceleration[i] = plan.base_radius * acceleration[i];
  }
  return motion;
}

}  // namespace treeline::experiments
