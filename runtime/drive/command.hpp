#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "drive/instruction.hpp"
#include "drive/robot_description.hpp"

namespace treeline::drive {

/// The first word of a command; `drag joint` and `drag POINT` are two.
enum class Verb {
  start,
  stop,
  brake,
  reset,
  mode,
  joint,
  move,
  turn,
  posture,
  home,
  hold,
  release,
  drag_point,
  drag_joint,
  pull,
  gains,
  follow,
  rehearse,
  go,
  discard,
  take,
  give,
  wait,
  help,
  quit
};

/// Longest line that is read, bytes.
inline constexpr std::size_t kLongestCommand = 400;

/// One line of the command language, understood. Numbers are in SI units and rad.
struct Command {
  Verb verb = Verb::stop;
  int target = 0;  ///< coordinate, point (`kBasePoint`: the base) or link; -1 with `hold`: all
  bool has_target = false;
  bool relative = false;  ///< by, not to
  bool degrees = false;   ///< angles were given in degrees, and answers say them so
  Control control = Control::joint;
  std::array<double, 7> numbers{};
  int number_count = 0;
  double duration = 0.0;  ///< s; 0: none was given
};

/// What its angles were given in and are answered in, rad; in rad itself 1.
double angle_unit(const Command& command);
/// Name of the unit of its angles: `deg` or `rad`.
const char* angle_unit_name(const Command& command);

/// Why a line is no command.
struct CommandFault {
  std::string text;    ///< what was expected
  std::size_t at = 0;  ///< byte of the line where that is
};

/// Reads one line for this robot. A line of blanks or a comment is a fault with an empty text. The
/// same line gives the same result; any bytes may be in it.
std::variant<Command, CommandFault> parse_command(std::string_view line,
                                                  const RobotDescription& robot);

/// One line of help: how a command is written and what it does.
struct CommandUsage {
  const char* usage;
  const char* does;
};

/// All commands, in the order in which they are explained.
const std::vector<CommandUsage>& command_usages();

/// Effect of the command, as an answer to it: "tool moves by (0, 0, -0.1) m in 2 s".
std::string describe(const Command& command, const RobotDescription& robot);

/// Whether the command needs the robot to be in the hands of the front end. `stop` and what does
/// not concern the robot do not.
bool needs_authority(Verb verb);
/// Whether it sets a goal or pulls, so that the loop has to be running.
bool needs_running(Verb verb);
/// Whether it is obeyed only for a short while.
bool is_lease(Verb verb);
/// Whether a twin does it in a rehearsal: motions, controls and gains.
bool is_rehearsed(Verb verb);
/// Whether it is `rehearse`, `go` or `discard`.
bool is_of_rehearsal(Verb verb);
/// Whether it is for scripts and standard input only.
bool is_local(Verb verb);

/// The message to the loop for a command that has one; all but those of rehearsals, `take`,
/// `give`, `wait`, `help` and `quit` do.
servo::Message message_for(const Command& command);

}  // namespace treeline::drive
