#include "trot_plan.hpp"

#include <cmath>

#include "core/prioritized_solve.hpp"

namespace treeline::experiments {
namespace {

/// The share of what a pair of feet does, which grows from `begin` to `end` of the time for which
/// all stand after the pair has landed, and ends likewise before it leaves.
double share_of(const TrotPlan& plan, const TrotPhase& phase, Support pair, double begin,
                double end) noexcept {
  if (phase.support != Support::all) return phase.support == pair ? 1.0 : 0.0;
  const auto risen = [&](double since) {
    return core::smooth_step((since / plan.loading - begin) / (end - begin));
  };
  const bool landed = phase.step > 0 && pair != pair_of(phase.step - 1);
  const bool leaves = phase.step >= 0 && phase.step < plan.steps() && pair != pair_of(phase.step);
  if (landed) return risen(phase.since);
  return leaves ? risen(plan.loading - phase.since) : 1.0;
}

}  // namespace

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

double held_share(const TrotPlan& plan, const TrotPhase& phase, int foot) noexcept {
  const Support pair = carries(Support::left, foot) ? Support::left : Support::right;
  return share_of(plan, phase, pair, 0.0, 0.3);
}

double led_share(const TrotPlan& plan, const TrotPhase& phase, Support pair) noexcept {
  return share_of(plan, phase, pair, 0.3, 0.5);
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
