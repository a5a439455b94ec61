#pragma once

#include "core/emitted_braking.hpp"
#include "servo/safety.hpp"

namespace treeline::servo {

/// Finds a reference that is left behind, by the law of emitted controllers. A controller that has
/// references offers `compare`, which calls visit(error, coordinate, since, duration) for each:
/// how far what follows it is away, rad or m; the velocity of the joint that follows, -1: a point;
/// the s that the motion has gone on; its duration, s, infinite without an end.
template <class ControllerType>
Fault find_left_behind(const ControllerType& controller, double time, double following) noexcept {
  Fault fault;
  constexpr auto kNothing = [](double, int, double, double) {};
  if constexpr (requires { controller.compare(time, kNothing); }) {
    using Waiting = core::EmittedWaiting<double>;
    const typename Waiting::TlConfig config{0.0, following, 0.0};
    controller.compare(time, [&](double error, int coordinate, double since, double duration) {
      const double most = Waiting::tl_admitted_error(&config, since, 1.0 / duration);
      if (fault || error <= most) return;
      fault = {FaultKind::following, coordinate, error, most};
    });
  }
  return fault;
}

}  // namespace treeline::servo
