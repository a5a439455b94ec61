#pragma once

#include <functional>
#include <string>
#include <vector>

#include "program/link_loops.hpp"

namespace treeline {

/// How a language names what the loops over links use.
struct LoopNames {
  std::function<std::string(const std::string&)> type;      ///< `LinkBody`
  std::function<std::string(const std::string&)> function;  ///< `copy_bodies`
  std::function<std::string(const std::string&)> array;     ///< local, or an argument
  std::function<std::string(const std::string&)> constant;  ///< of the robot: `links`
  std::string none;                                         ///< a pointer to nothing
  std::string number;                                       ///< the type of numbers
  std::string table;                                        ///< the function's own, as an argument
};

/// Code that a function executes before it loops if arguments change the table: arrays `bodies`,
/// `rotors`, `drives`, `frictions` and `points` take the place of constants. Empty where none does.
std::string print_link_inputs(const LinkLoops& loops, const LoopNames& names);

/// The table of a function whose arguments change it, member by member: of an initializer g++ makes
/// a call of memset. `gravity` are constants; `all`: members without a value too.
std::string print_members(const LinkLoops& loops, const LoopNames& names, const std::string& type,
                          const std::vector<std::string>& gravity, bool all);

/// Whether arguments move points of the table.
bool moves_points(const LinkTableData& table);

/// Whether the table of the function has rotors, or friction of joints, of its own.
bool changes_rotors(const LinkLoops& loops);
bool changes_drives(const LinkLoops& loops);
bool changes_frictions(const LinkLoops& loops);

/// `payload_frames`, the constants of an input, or `base_parameters_rotors`.
std::string frames_name(const LinkInput& input);

/// `base_parameters_entries`, where it gives parts of bodies.
std::string entries_name(const LinkInput& input);

}  // namespace treeline
