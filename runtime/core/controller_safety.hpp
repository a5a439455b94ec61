#pragma once
// What keeps an emitted controller within its limits: checks of what was measured, torque and its
// rate within limits. C++17, freestanding, fixed size.
//
// `Robot` is the struct of constants and functions that is emitted beside these headers.

#include <stddef.h>
#include <stdint.h>

#include "core/mode.hpp"

namespace treeline::core {

/// Bits of a controller's faults.
inline constexpr uint32_t kFaultMeasurement = 1U;  ///< q, qd or a force is not finite
inline constexpr uint32_t kFaultPosition = 2U;     ///< beyond a limit by more than the margin
inline constexpr uint32_t kFaultSpeed = 4U;        ///< beyond a limit by more than the margin
inline constexpr uint32_t kFaultTorque = 8U;       ///< the law's torque is not finite
inline constexpr uint32_t kFaultStale = 16U;       ///< no command for too many steps
inline constexpr uint32_t kFaultEmergency = 32U;   ///< emergency stop, by command
inline constexpr uint32_t kFaultMoved = 64U;       ///< dragged away while it should stand
inline constexpr uint32_t kFaultJump = 128U;       ///< q moves otherwise than qd says
inline constexpr uint32_t kFaultFollowing = 256U;  ///< the reference is not followed
inline constexpr uint32_t kFaultConfig = 512U;     ///< a number of the configuration is not sound
/// Faults after which torque alone cannot be trusted.
inline constexpr uint32_t kFaultsUntrusted =
    kFaultMeasurement | kFaultTorque | kFaultMoved | kFaultJump | kFaultConfig;

/// What a controller computes with: the type that its functions take.
template <class Robot>
using RealOf = typename Robot::Real;

template <class Real>
constexpr bool is_finite(Real x) noexcept {
  return (x - x) == Real(0);
}

template <size_t N, class Real>
constexpr bool all_finite(const Real (&x)[N]) noexcept {
  bool finite = true;
  for (size_t i = 0; i < N; ++i) {
    finite = finite && is_finite(x[i]);
  }
  return finite;
}

template <class Real>
constexpr Real magnitude(Real x) noexcept {
  return (x < Real(0)) ? -x : x;
}

/// `x` between -most and most; 0 for NaN.
template <class Real>
constexpr Real within(Real x, Real most) noexcept {
  return (x > most) ? most : ((x < -most) ? -most : ((x == x) ? x : Real(0)));
}

/// `x` less its whole turns, between -pi and pi where |x| is below a million turns.
template <class Real>
constexpr Real shortest_turn(Real x) noexcept {
  const Real turns = x * Real(0.15915494309189535);
  if (!(magnitude(turns) < Real(1000000))) {
    return x;
  }
  const auto whole = static_cast<int32_t>(turns + ((turns < Real(0)) ? Real(-0.5) : Real(0.5)));
  return x - (static_cast<Real>(whole) * Real(6.283185307179586));
}

/// How far coordinate `i` is from `from` to `to`, rad or m: the short way round for a joint that
/// turns without end.
template <class Robot>
inline RealOf<Robot> way_to(int i, RealOf<Robot> from, RealOf<Robot> to) noexcept {
  return Robot::kTurns[i] ? shortest_turn(to - from) : (to - from);
}

template <class Robot>
inline Mode mode_of(const typename Robot::State& state) noexcept {
  return static_cast<Mode>(state.mode);
}

template <class Robot>
inline void apply_event(Event event, typename Robot::State& state) noexcept {
  state.mode = static_cast<int32_t>(next_mode(mode_of<Robot>(state), event));
}

template <class Robot>
inline void raise_fault(uint32_t faults, typename Robot::State& state) noexcept {
  state.reason = (state.faults == 0) ? faults : state.reason;
  state.faults |= faults;
  apply_event<Robot>(Event::fault, state);
}

/// How far a coordinate is beyond its limits, rad or m; negative within them.
template <class Robot>
inline RealOf<Robot> beyond_limits(const typename Robot::Config& config,
                                   const typename Robot::Input& input, int i) noexcept {
  const RealOf<Robot> above = input.q[i] - config.upper[i];
  const RealOf<Robot> below = config.lower[i] - input.q[i];
  return (above > below) ? above : below;
}

/// The faults of what was measured, which is finite. A joint that was beyond its limit at a reset
/// may stay there and be led back: what is admitted shrinks with it.
template <class Robot>
inline uint32_t check_motion(const typename Robot::Config& config, typename Robot::State& state,
                             const typename Robot::Input& input) noexcept {
  using Real = RealOf<Robot>;
  uint32_t faults = 0;
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real beyond = beyond_limits<Robot>(config, input, i);
    if (!(beyond <= (config.position_margin + state.admitted[i]))) {
      faults |= kFaultPosition;
    }
    const Real now = (beyond > Real(0)) ? beyond : Real(0);
    state.admitted[i] = (state.admitted[i] < now) ? state.admitted[i] : now;
    if (!(magnitude(input.qd[i]) <= (config.speed[i] * (Real(1) + config.speed_margin)))) {
      faults |= kFaultSpeed;
    }
  }
  return faults;
}

/// Lets joints be where they are, however far beyond their limits.
template <class Robot>
inline void admit(const typename Robot::Config& config, const typename Robot::Input& input,
                  typename Robot::State& state) noexcept {
  for (int i = 0; i < Robot::kJoints; ++i) {
    const RealOf<Robot> beyond = beyond_limits<Robot>(config, input, i);
    state.admitted[i] = (beyond > RealOf<Robot>(0)) ? beyond : RealOf<Robot>(0);
  }
}

/// Brings `tau` within its limits and returns the factor that was needed, 1 for none. By `scale`
/// what exceeds the torque that holds the robot against gravity, `held`, is shortened as a whole:
/// its direction is kept and the robot stays held. By `clamp` each torque is cut by itself, and the
/// factor is that of the torque that lost most.
template <class Robot>
inline RealOf<Robot> saturate(const typename Robot::Config& config,
                              const RealOf<Robot> (&held)[Robot::kJoints],
                              RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  Real factor = Real(1);
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real most = (tau[i] < held[i]) ? -config.torque[i] : config.torque[i];
    const Real room = most - held[i];
    const Real asked = tau[i] - held[i];
    if (magnitude(asked) > magnitude(room)) {
      const Real share = room / asked;
      factor = (share < factor) ? share : factor;
    }
  }
  for (int i = 0; i < Robot::kJoints; ++i) {
    if ((config.saturation == Robot::kScale) && (factor < Real(1))) {
      tau[i] = held[i] + (factor * (tau[i] - held[i]));
    }
    tau[i] = within(tau[i], config.torque[i]);
  }
  return factor;
}

/// Brings each torque within its limit, and within what `torque_rate` lets it differ from the last.
/// Returns whether one was cut.
template <class Robot>
inline bool limit_rate(const typename Robot::Config& config, typename Robot::State& state,
                       RealOf<Robot> (&tau)[Robot::kJoints]) noexcept {
  using Real = RealOf<Robot>;
  bool cut = false;
  for (int i = 0; i < Robot::kJoints; ++i) {
    const Real asked = within(tau[i], config.torque[i]);
    const Real last = (state.known != 0) ? within(state.tau[i], config.torque[i]) : asked;
    const Real most = config.torque_rate[i] * config.period;
    const Real change = asked - last;
    tau[i] = (magnitude(change) <= most) ? asked : (last + within(change, most));
    cut = cut || (magnitude(change) > most);
    state.tau[i] = tau[i];
  }
  state.known = 1;
  return cut;
}

}  // namespace treeline::core
