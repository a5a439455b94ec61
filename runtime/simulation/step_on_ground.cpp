#include "simulation/step_on_ground.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace treeline::simulation {
namespace {

/// A step, and what is counted of it.
struct Step {
  const OnGround& robot;
  GroundAccount& account;

  [[nodiscard]] bool is_fast(const Touch& touch, double speed) const {
    return touch.joint < 0 && speed < -robot.surface.slow;
  }
  [[nodiscard]] GroundTouches touches(const State& state, const Nearness& near) const {
    return robot.ground.touches(robot.model, state, near);
  }
  [[nodiscard]] double energy(const State& state) const {
    return mechanical_energy(robot.model, state);
  }
};

void count(const Blow& blow, Step& step) {
  constexpr double kFine = 1e-9;  // m/s
  GroundAccount& account = step.account;
  int pressed = 0;
  account.last.clear();
  for (std::size_t i = 0; i < blow.touches.size(); ++i) {
    const Vector3 impulse = blow.impulses.segment<3>(3 * static_cast<Eigen::Index>(i));
    account.last[{blow.touches[i].shape, blow.touches[i].point}] = impulse;
    if (blow.touches[i].joint >= 0) continue;
    account.impulse += impulse;
    pressed += impulse.z() > 0 ? 1 : 0;
  }
  account.contacts = std::max(account.contacts, pressed);
  account.most_contacts = std::max(account.most_contacts, pressed);
  if (step.robot.on_blow) step.robot.on_blow(blow);
  const bool converged = blow.solution.converged || blow.solution.miss < kFine;
  account.unconverged += blow.touches.empty() || converged ? 0 : 1;
}

/// Touches after a flight of `dt`: what is in the ground, and with it what the fastest of these
/// would reach in another step, and what was so near before.
GroundTouches touches_after(const Step& step, const State& flown, double dt) {
  GroundTouches found = step.touches(flown, {});
  if (found.touches.empty() || found.left_out > 0) return found;
  const double fastest = -*std::min_element(found.speeds.begin(), found.speeds.end());
  constexpr double kTouching = 1e-6;  // m
  return fastest > 0 ? step.touches(flown, {std::max(kTouching, fastest * dt), dt}) : found;
}

/// The share of a flight for which a change of velocities acts: half of it, or as long as the
/// deepest point was in the ground.
double share_in_ground(const GroundTouches& found, double dt) {
  double share = 0.5;
  for (std::size_t i = 0; i < found.touches.size(); ++i) {
    const double way = -found.speeds[i] * dt;
    if (way > 0) share = std::max(share, found.touches[i].depth / way);
  }
  return std::min(share, 1.0);
}

State pushed(const Step& step, const State& struck, const Vector& dqd, double seconds) {
  State state = struck;
  move(coordinates_of(step.robot.model), dqd, seconds, state.q);
  return state;
}

/// Moves the coordinates by a change of velocities for `seconds`, or for as long as the energy
/// stays below `most`. Returns the energy.
double push_out(const Step& step, double most, const Vector& dqd, double seconds, State& state) {
  constexpr double kShorter = 1 - 1e-6;  // so that rounding does not refuse the next turn
  const double least = step.energy(state);
  const State struck = state;
  for (int turn = 0; turn < 4; ++turn) {
    state = pushed(step, struck, dqd, seconds);
    const double energy = step.energy(state);
    if (energy <= most) return energy;
    seconds *= kShorter * std::max(0.0, (most - least) / (energy - least));
  }
  state = struck;
  return least;
}

/// Stops points that flew into the ground from `start`, all but those that bounce later.
void settle(Step& step, double dt, bool bounces_later, const State& start, State& state) {
  GroundTouches found = touches_after(step, state, dt);
  if (bounces_later) {
    for (std::size_t i = found.touches.size(); i-- > 0;) {
      if (!step.is_fast(found.touches[i], found.speeds[i])) continue;
      found.touches.erase(found.touches.begin() + static_cast<std::ptrdiff_t>(i));
      found.speeds.erase(found.speeds.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  step.account.left_out += found.left_out > 0 ? 1 : 0;
  if (found.touches.empty()) return;
  const double share = step.robot.whole_step ? 1 : share_in_ground(found, dt);
  for (std::size_t i = 0; i < found.touches.size(); ++i) {
    Touch& touch = found.touches[i];
    touch.allowed = std::max(0.0, -(touch.depth / dt + share * found.speeds[i]));
    const auto last = step.account.last.find({touch.shape, touch.point});
    if (last != step.account.last.end()) touch.start = last->second;
  }
  const double energy = std::max(step.energy(start), step.energy(state));
  const Blow blow =
      strike(step.robot.model, found.touches, {0, step.robot.surface.friction, 0}, state);
  count(blow, step);
  step.account.energy += push_out(step, energy, blow.dqd, share * dt, state) - energy;
}

/// A point that approaches fast enough to bounce.
struct FastPoint {
  double depth = 0;  ///< m, less than 0 before it touches
  double speed = 0;  ///< m/s, upward
};

/// The deepest of these below `margin` (m); where there is none, one at the margin.
FastPoint deepest_fast(const Step& step, const State& state, double margin) {
  const GroundTouches found = step.touches(state, {margin});
  FastPoint deepest{-margin, 0};
  for (std::size_t i = 0; i < found.touches.size(); ++i) {
    const FastPoint point{found.touches[i].depth, found.speeds[i]};
    const bool is_fast = step.is_fast(found.touches[i], point.speed);
    if (is_fast && point.depth > deepest.depth) deepest = point;
  }
  return deepest;
}

/// When a point that bounces touches first within a flight from `start` to `flown`: by regula falsi
/// in the form called Illinois, to 1e-10 m.
std::optional<double> time_of_bounce(const Step& step, double time, double dt, const State& start,
                                     const State& flown) {
  const FastPoint deepest = deepest_fast(step, flown, 0);
  if (!(deepest.depth > 0)) return std::nullopt;
  const double margin = -2 * dt * deepest.speed;
  double before = 0;
  double after = dt;
  double above = deepest_fast(step, start, margin).depth;
  double below = deepest.depth;
  if (above >= 0) return 0;
  int side = 0;
  for (int turn = 0; turn < 50; ++turn) {
    const double middle = (before * below - after * above) / (below - above);
    State at = start;
    if (!step.robot.flight(time, middle, at)) break;
    const double depth = deepest_fast(step, at, margin).depth;
    if (std::abs(depth) < 1e-10) return middle;
    if (depth > 0) {
      after = middle;
      below = depth;
      above *= side == 1 ? 0.5 : 1;
      side = 1;
    } else {
      before = middle;
      above = depth;
      below *= side == -1 ? 0.5 : 1;
      side = -1;
    }
  }
  return after;
}

/// Strikes everything that touches, by Newton's law.
void bounce(Step& step, double dt, State& state) {
  constexpr double kTouching = 1e-9;  // m
  GroundTouches found = step.touches(state, {std::max(kTouching, step.robot.surface.slow * dt)});
  const Blow blow = strike(step.robot.model, std::move(found.touches), step.robot.surface, state);
  count(blow, step);
  step.account.energy += blow.energy;
  ++step.account.bounces;
}

}  // namespace

bool step_on_ground(const OnGround& robot, double time, double dt, State& state,
                    GroundAccount& account) {
  constexpr int kMostBounces = 16;  // in one step
  Step step{robot, account};
  account.contacts = 0;
  for (int bounces = 0; dt > 0; ++bounces) {
    State flown = state;
    if (!robot.flight(time, dt, flown)) return false;
    const bool may_bounce = robot.surface.restitution > 0 && bounces < kMostBounces;
    const auto touched = may_bounce ? time_of_bounce(step, time, dt, state, flown) : std::nullopt;
    if (touched && *touched < dt) {
      flown = state;
      if (*touched > 0 && !robot.flight(time, *touched, flown)) return false;
    }
    const double part = touched.value_or(dt);
    if (part > 0) settle(step, part, touched.has_value(), state, flown);
    if (touched) bounce(step, part > 0 ? part : dt, flown);
    state = flown;
    time += part;
    dt -= part;
    if (!touched) break;
  }
  if (robot.ground.is_in_reach()) {
    account.deepest = std::max(account.deepest, robot.ground.lowest(robot.model, state.q).depth);
  }
  return true;
}

}  // namespace treeline::simulation
