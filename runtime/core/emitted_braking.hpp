#pragma once
// The headers of runtime/emitted that brake a robot and hold it, and those that wait for it, as
// members of classes. C++17, freestanding.

#include <stdbool.h>
#include <stdint.h>

namespace treeline::core {

#define TL_INLINE static inline
#define TL_REAL(x) real(x)
#define TL_AS_REAL(x) static_cast<real>(x)
#define TL_AS_INDEX(x) static_cast<int32_t>(x)

/// Everything of runtime/emitted/controller_numbers.h.
template <class Number>
struct EmittedNumbers {
  using real = Number;
  static constexpr real TL_ZERO = real(0), TL_ONE = real(1), TL_TEN = real(10);

#include "emitted/controller_numbers.h"
};

/// Everything of runtime/emitted/controller_braking.h. `Robot` has the number type `Real`,
/// `kJoints`, of each joint in `kTurns` whether it turns without end, the structs Config, Input,
/// State and Measured with the members that those headers name, and `joint_torque`.
template <class Robot>
struct EmittedBraking : EmittedNumbers<typename Robot::Real> {
  using Numbers = EmittedNumbers<typename Robot::Real>;
  using Numbers::TL_ZERO, Numbers::TL_ONE, Numbers::TL_TEN, Numbers::tl_is_number,
      Numbers::tl_are_numbers, Numbers::tl_magnitude, Numbers::tl_smaller, Numbers::tl_larger,
      Numbers::tl_within, Numbers::tl_shortest_turn, Numbers::tl_seconds, Numbers::tl_count_tick;
  using typename Numbers::real;
  using TlConfig = typename Robot::Config;
  using TlInput = typename Robot::Input;
  using TlState = typename Robot::State;
  using TlMeasured = typename Robot::Measured;
  static constexpr int32_t TL_JOINTS = Robot::kJoints;
  static constexpr auto TL_TURNS = Robot::kTurns;
  using TlJointsIn = const real (&)[TL_JOINTS];
  using TlJointsOut = real (&)[TL_JOINTS];

  static bool tl_inputs_are_numbers(const TlInput* /*input*/) { return true; }
  static void tl_adopt(const TlConfig* /*config*/, const TlInput* /*input*/, TlState* /*state*/) {}
  static void tl_measure(const TlInput* /*input*/, const TlState* /*state*/, TlMeasured* /*at*/) {}
  static void tl_joint_torque(const TlInput* input, const TlState* /*state*/, const TlMeasured* at,
                              TlJointsIn qdd, TlJointsOut tau) {
    Robot::joint_torque(*input, *at, qdd, tau);
  }

#include "emitted/controller_braking.h"
};

/// How far references may be left behind: everything of runtime/emitted/controller_waiting.h.
template <class Number>
struct EmittedWaiting : EmittedNumbers<Number> {
  using Numbers = EmittedNumbers<Number>;
  using Numbers::TL_ZERO, Numbers::TL_ONE, Numbers::tl_smaller, Numbers::tl_larger,
      Numbers::tl_within, Numbers::tl_seconds;
  using typename Numbers::real;
  struct TlConfig {
    real period, following, speed_rise;
  };

#include "emitted/controller_waiting.h"
};

#undef TL_INLINE
#undef TL_REAL
#undef TL_AS_REAL
#undef TL_AS_INDEX

/// `x` less its whole turns, between -pi and pi where |x| is below a million turns.
template <class Real>
inline Real shortest_turn(Real x) noexcept {
  return EmittedNumbers<Real>::tl_shortest_turn(x);
}

}  // namespace treeline::core
