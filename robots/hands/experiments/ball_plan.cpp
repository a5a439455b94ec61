#include "ball_plan.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace treeline::experiments {
namespace {

/// Where each leg ends: shares of the way, and of the turn.
constexpr double kStops[][6] = {{0, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 0, -1}, {0, 0, 0, 0, 0, 0},
                                {0, 0, 0, 1, 0, 0}, {0, 0, 0, -1, 0, 0}, {0, 0, 0, 0, 0, 0},
                                {0, 0, 0, 0, 1, 0}, {0, 0, 0, 0, -1, 0}, {0, 0, 0, 0, 0, 0},
                                {1, 0, 0, 0, 0, 0}, {0, 1, 0, 0, 0, 0},  {0, 0, 1, 0, 0, 0},
                                {0, 0, 0, 0, 0, 0}};
constexpr int kLegs = static_cast<int>(std::size(kStops));

}  // namespace

double BallPlan::duration() const noexcept {
  return 2.0 * hold + kLegs * leg;
}

core::Motion<6, double> ball_at(const BallPlan& plan, double time) noexcept {
  const double moving = time - plan.hold;
  const int leg = std::clamp(static_cast<int>(std::floor(moving / plan.leg)), 0, kLegs - 1);
  double from[6] = {}, to[6];
  for (int i = 0; i < 6; ++i) {
    const double most = i < 3 ? plan.way : plan.turn;
    if (leg > 0) from[i] = most * kStops[leg - 1][i];
    to[i] = most * kStops[leg][i];
  }
  return core::rest_to_rest<6>(from, to, plan.leg).at(moving - leg * plan.leg);
}

}  // namespace treeline::experiments
