#include "trot_plan.hpp"

#include <cmath>

namespace treeline::experiments {

TrotPhase phase_at(const TrotPlan& plan, double time) noexcept {
  const double trotting = time - plan.stand;
  if (trotting < 0.0) return {Support::all, -1, time};
  const int step = static_cast<int>(std::floor(trotting / plan.step()));
  if (step >= plan.steps()) {
    return {Support::all, plan.steps(), trotting - plan.steps() * plan.step()};
  }
  const double since = trotting - step * plan.step();
  if (since < plan.loading) return {Support::all, step, since};
  return {pair_of(step), step, since - plan.loading};
}

core::Motion<1, double> way_at(const TrotPlan& plan, double time) noexcept {
  const double duration = plan.steps_of_walk * plan.step();
  const double ramp = plan.steps_of_ramp * plan.step();
  const double speed = plan.way / (duration - ramp);
  const double walked = time - plan.stand - plan.steps_in_place * plan.step();
  const double left = duration - walked;
  if (walked <= 0.0) return {{0.0}, {0.0}, {0.0}};
  if (left <= 0.0) return {{plan.way}, {0.0}, {0.0}};
  const double gain = speed / ramp;
  if (walked < ramp) return {{0.5 * gain * walked * walked}, {gain * walked}, {gain}};
  if (left < ramp) return {{plan.way - 0.5 * gain * left * left}, {gain * left}, {-gain}};
  return {{speed * (walked - 0.5 * ramp)}, {speed}, {0.0}};
}

}  // namespace treeline::experiments
