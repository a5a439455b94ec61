#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "interpreter/instances.hpp"
#include "oracle/model_from_robot.hpp"
#include "random_state.hpp"
#include "recursion/function_results.hpp"

/// Random robots that stand on random constraints or have joints without a motor, with tasks that
/// they can do, in 50 digits.
namespace treeline::tests {

using Vector50 = interpreter::Vector<Digits50>;
using Matrix50 = interpreter::Matrix<Digits50>;

using Rows = std::array<bool, 6>;
inline constexpr Rows kAllRows{true, true, true, true, true, true};
inline constexpr Rows kPointFoot{true, true, true, false, false, false};
inline constexpr Rows kHinge{true, true, true, true, true, false};

struct Standing {
  const char* name;
  std::vector<Rows> feet;
  int task_rows = 6;
  bool floating_base = true;
  int passive = 0;  ///< joints without a motor
  double mimic = 0;
  int external_forces = 0;
  double drives = 0;                       ///< chance of a rotor, of friction, and of a spring
  std::vector<Rows> loops = {};            ///< constraints between two links
  int couplings = 0;                       ///< constraints between two joints
  std::vector<SceneRolling> rolling = {};  ///< of the loops, on the world where `on_world`
  bool on_world = false;
};

std::ostream& operator<<(std::ostream& out, const Standing& standing);

/// One to four supports, and less than what would hold a floating base.
const std::vector<Standing>& standings();

/// Robots with loops of their own, on the ground too.
const std::vector<Standing>& looped();

/// Robots that roll, on themselves and on the ground.
const std::vector<Standing>& rolling();

std::vector<Standing> standings_and_loops();

struct StandingCase {
  RandomMechanism made;
  interpreter::Model<Digits50> model;
  interpreter::SupportedTask<Digits50> task;
  Vector50 q, qd, tau, drift;
  double growth = 1;  ///< largest condition number that amplifies rounding
};

StandingCase draw_standing(std::uint64_t seed, const Standing& standing);

/// The first case from this seed on in which constraints are independent and tasks possible.
StandingCase draw_standing_regular(std::uint64_t seed, const Standing& standing);

}  // namespace treeline::tests
