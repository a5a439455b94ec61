#pragma once

#include "core/spline.hpp"

namespace treeline::experiments {

/// Which feet carry the robot. A pair is named after its fore foot: the left fore and the right
/// hind foot are `left`.
enum class Support { all, left, right };

/// Stands, trots in place, walks straight ahead, trots in place again and stands. Each step loads
/// one pair of diagonal feet while all four stand, and then swings the other pair.
struct TrotPlan {
  double stand = 1.0;      ///< before the first step, and after the last one, s
  double loading = 0.1;    ///< of a step: all feet stand, s
  double swing = 0.3;      ///< of a step: two feet swing, s
  int steps_in_place = 6;  ///< before and after the walk
  int steps_of_walk = 60;
  int steps_of_ramp = 4;  ///< in which the walk gains, and loses, its speed
  double way = 10.0;      ///< m
  double lift = 0.07;     ///< of a swinging foot, m

  [[nodiscard]] int steps() const noexcept { return 2 * steps_in_place + steps_of_walk; }
  [[nodiscard]] double step() const noexcept { return loading + swing; }
  [[nodiscard]] double duration() const noexcept { return 2.0 * stand + steps() * step(); }
};

/// Where a plan is at a time.
struct TrotPhase {
  Support support = Support::all;
  int step = -1;       ///< from 0 on; -1 before the first one, the number of steps after the last
  double since = 0.0;  ///< since this phase of the step began, s
};

/// The phase `time` seconds after the plan's begin.
TrotPhase phase_at(const TrotPlan& plan, double time) noexcept;

/// Way of the body straight ahead, m, m/s, m/s^2.
core::Motion<1, double> way_at(const TrotPlan& plan, double time) noexcept;

/// The pair that carries the body while the other one swings.
constexpr Support pair_of(int step) noexcept {
  return step % 2 == 0 ? Support::left : Support::right;
}

/// Whether a foot (anymal_on_feet.hpp) is of this pair.
constexpr bool carries(Support support, int foot) noexcept {
  const bool left = foot == 0 || foot == 3;
  return support == Support::all || left == (support == Support::left);
}

/// To what share a foot is held: nothing of it while it swings. It grows at once after a foot has
/// landed, and ends just before it leaves, in 0.3 of the time for which all stand.
double held_share(const TrotPlan& plan, const TrotPhase& phase, int foot) noexcept;

/// To what share the body is led along the line between the feet of a pair: while they are held.
double led_share(const TrotPlan& plan, const TrotPhase& phase, Support pair) noexcept;

}  // namespace treeline::experiments
