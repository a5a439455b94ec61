#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "emission/backend.hpp"
#include "emission/controller_faults.hpp"
#include "emission/controller_unit.hpp"
#include "emission/descriptions.hpp"
#include "safety/describe_safety.hpp"

namespace treeline {
namespace {

constexpr const char* kSafeState =
    "The safe state is the robot braked to rest and held there by torque: a reference begins at "
    "the "
    "present motion, slows down and stays, and the joints are led along it, in idle, stopping and "
    "faulted alike. All torques are within `torque` and change by at most `torque_rate`; the first "
    "step of a state knows none before it, and holds the robot at once. A spring "
    "up to three fifths of a motor's torque bears loads that the model does not know. It is a safe "
    "state only while measurements, motors and this computer work. A joint of which neither "
    "coordinate "
    "nor velocity is measured is held against gravity for `blind_ticks` steps and gets no torque "
    "after that. Where torques are not finite all joints get what last held them at rest. Brakes "
    "have to hold them then.\n\n"
    "The spring knows no inertias. A joint that is far lighter than its motor would be swung by "
    "it: "
    "each half of a swing within 30 ms that does not fade takes half of its firmness away until "
    "the "
    "robot brakes anew, so that the joint rests, held the more softly.\n\n"
    "`output.brakes` = 1 asks the surrounding program to close mechanical brakes in this step, and "
    "stays until RESET. It is set where torque cannot be trusted (\"at once\" below) and where a "
    "faulted robot has come to rest. Nothing is known of the brakes' own time and strength; a "
    "robot "
    "without brakes falls where torque cannot hold it.\n\n";

constexpr const char* kCommands =
    "A command that makes no sense is refused: the motion before goes on, and `output.refused` "
    "says why in that step. A motion of a joint takes as much longer as its limits of speed ask "
    "for.";
constexpr const char* kPoints =
    " A motion of a point slows down where the robot stays behind, and is given up where nothing "
    "leads to its goal: the joints come to rest and hold, without a fault, and `output.unmet` says "
    "why until another command. The way is not looked at before it is begun.";
constexpr const char* kCompliance =
    " While the robot complies (COMPLY) it yields: a blocked joint is then no fault.\n\n";

constexpr const char* kObserver =
    "Velocities are not measured: an observer of {0} rad/s finds them from coordinates. Under an "
    "acceleration a they are too slow by 2 a / {0}; an encoder's count of d rad changes them by "
    "{1} d rad/s. A coordinate that jumps is a fault at once. **One that is frozen is no fault of "
    "its own**: the joint seems to stand, and only a motion that leaves it behind by `following` "
    "is a fault.\n\n";

constexpr const char* kReactions =
    "Faults are looked for in every step, STALE and FOLLOWING while running, MOVED while the robot "
    "is braked and held, and POSITION, SPEED and JUMP where all that is measured is finite. The "
    "torque of the step that finds one brakes already, within torque_rate; "
    "a cycle is {} s. Reaction: mode "
    "faulted, brake and hold; the first fault stays in `output.reason`, all in `output.faults`, "
    "until RESET.\n\n";

/// Cycles from a fault to torque that brakes.
const char* reaction_time(const ControllerFault& fault, bool observes) {
  const bool jumps = fault.bit == kFaultJump;
  return jumps && observes ? "0 for a jump; a frozen encoder is not found" : fault.time;
}

std::string print_reactions(bool observes) {
  std::string text =
      "| bit | fault | found when | cycles until torque begins to brake | `brakes` "
      "|\n|---|---|---|---|---|\n";
  for (const ControllerFault& fault : kControllerFaults) {
    text += fmt::format("| {} | `{}` | {} | {} | {} |\n", fault.bit, fault.name, fault.meaning,
                        reaction_time(fault, observes),
                        fault.asks_brakes_at_once() ? "at once" : "once at rest");
  }
  return text;
}

/// A setting that can be so that it guards nothing.
struct Guard {
  const char* name;
  double value;
  const char* unit;
  const char* guards;
  const char* unsafe;  ///< beyond which values it guards nothing
  bool is_unsafe;
};

std::vector<Guard> list_guards(const SceneController& own) {
  constexpr double kQuarterTurn = 1.5707963267948966;
  constexpr double kLongest = 0.5;  // s
  return {
      {"stale_ticks", static_cast<double>(own.stale_ticks), "steps",
       "that whoever commands is there", "0: a command that stays away is never a fault",
       own.stale_ticks == 0},
      {"blind_ticks", static_cast<double>(own.blind_ticks), "steps",
       "against torque without a measurement", "more than half a second: unseen motion is held",
       own.blind_ticks * own.period > kLongest},
      {"position_margin", own.position_margin, "rad, m", "limits of position",
       "a quarter turn: limits are crossed without a fault", own.position_margin >= kQuarterTurn},
      {"speed_margin", own.speed_margin, "of the limit", "limits of speed",
       "1: twice the limit is no fault", own.speed_margin >= 1},
      {"jump", own.jump, "rad, m",
       own.observer > 0 ? "against sensors that jump" : "against sensors that jump or freeze",
       "a quarter turn: most jumps are taken for motion", own.jump >= kQuarterTurn},
      {"following", own.following, "rad, m", "against blocked joints and collisions",
       "a quarter turn: a blocked joint is pressed with all the torque",
       own.following >= kQuarterTurn},
      {"brake_damping", own.brake_damping, "1/s", "the time and way of braking",
       "less than 1: at rest only after many seconds", own.brake_damping < 1},
      {"hold_reach", own.hold_reach, "rad, m", "against robots that are dragged away at rest",
       "an eighth of a turn: one that is dragged by twice as much is no fault",
       own.hold_reach >= kQuarterTurn / 2},
      {"torque_rise", own.torque_rise, "s", "against steps in torque",
       "less than two steps: torque may jump to its limit", own.torque_rise < 2 * own.period}};
}

std::string print_guards(const SceneController& own) {
  std::string text =
      "| setting | default here | guards | guards nothing beyond |\n|---|---|---|---|\n";
  for (const Guard& guard : list_guards(own)) {
    text += fmt::format("| `{}` | {} {}{} | {} | {} |\n", guard.name, guard.value, guard.unit,
                        guard.is_unsafe ? ": **unsafe**" : "", guard.guards, guard.unsafe);
  }
  return text;
}

/// `elbow: torque; wrist: position, speed`
std::string list_missing_limits(const ControllerUnit& unit) {
  std::string text;
  for (const ControllerUnit::Joint& joint : unit.joints) {
    const bool open = std::isinf(joint.lower) || std::isinf(joint.upper);
    std::string missing;
    const auto add = [&](bool is_missing, const char* what) {
      if (is_missing) missing += (missing.empty() ? "" : ", ") + std::string(what);
    };
    add(open && joint.turns(), "position (turns without end)");
    add(open && !joint.turns(), "position");
    add(std::isinf(joint.speed), "speed");
    add(std::isinf(joint.torque), "torque (no spring bears loads in the safe state)");
    if (missing.empty()) continue;
    text += fmt::format("- `{}`: {}\n", joint.name, missing);
  }
  return text;
}

constexpr const char* kFromCaller =
    "- A timer that calls the step each period, and a watchdog that closes the brakes where a step "
    "does not come or does not end in time: the step cannot see that.\n"
    "- `NAME_check_config` before the first step. It refuses numbers that are not finite or "
    "without "
    "meaning, not those that guard nothing.\n"
    "- Memory that nobody else writes to: a step reads configuration and input, and changes state "
    "and output, without locks. Commands from another thread or interrupt come by `NAME_post` and "
    "`NAME_fetch`.\n"
    "- Zeros in the state before the first step, and nothing but the step that changes it.\n"
    "- A second channel for emergency stop: the command EMERGENCY_STOP is no safety function.\n";

}  // namespace

std::string describe_step_behaviour(const std::string& name) {
  return fmt::format(
      "- `{0}_step` is not straight-line: it branches on its inputs and its state, has loops of\n"
      "  constant length, and calls the functions `controller_*`, which are. Its instructions "
      "differ\n"
      "  by mode, input and command: least and most are below, where a report has them. It keeps\n"
      "  nothing but the caller's `{0}_state`; it allocates nothing, waits for nothing, and does "
      "not\n"
      "  call itself.\n",
      name);
}

std::string describe_step(const Scene& scene, const Generation& generation) {
  const ControllerUnit& unit = *generation.controller;
  std::string text = kSafeState;
  if (const double observer = unit.settings.observer; observer > 0) {
    text +=
        fmt::format(fmt::runtime(kObserver), observer, observer * observer * unit.settings.period);
  }
  text += fmt::format(fmt::runtime(kReactions), unit.settings.period) +
          print_reactions(unit.settings.observer > 0);
  text += std::string("\n### Commands that cannot be met\n\n") + kCommands +
          (unit.task_torque ? kPoints : "") + kCompliance;
  text += "### What settings guard\n\nThe defaults come from the scene; `" + scene.name +
          "_config` may have others at run time.\n\n" + print_guards(unit.settings);
  const std::string missing = list_missing_limits(unit);
  text += "\n### Limits that there are not\n\n" +
          (missing.empty() ? "None: each joint has limits of position, speed and torque.\n"
                           : "The scene waives them, or the joint has none by its kind. Nothing "
                             "guards these quantities:\n\n" +
                                 missing);
  text += "\n### What the surrounding program has to do\n\n";
  std::string caller = kFromCaller;
  for (std::size_t at = caller.find("NAME"); at != std::string::npos;
       at = caller.find("NAME", at)) {
    caller.replace(at, 4, scene.name);
  }
  text += caller;
  return text + fmt::format(
                    "\nThe stack of a step is estimated at {} bytes. Its {} sources are compiled "
                    "from {} files, which `{}_controller.h` lists.\n",
                    count_step_stack(unit, scene.profile == Profile::misra, bytes_of(scene.real)),
                    backend_of(scene.language).standard,
                    list_controller_sources(scene.language, unit).size(), scene.name);
}

}  // namespace treeline
