#pragma once

#include <functional>
#include <string>
#include <vector>

#include "program/link_loops.hpp"

namespace treeline {

/// How a language names what the loops over links use.
struct LoopNames {
  std::function<std::string(const std::string&)> in_loops;  ///< `TlLinkBody`, `tl_copy_bodies`
  std::function<std::string(const std::string&)> constant;  ///< the robot's, as a pointer: `links`
  std::string none;                                         ///< a pointer to nothing
  std::string number;                                       ///< the type of numbers
};

/// Code that a function executes before it loops if arguments change the table: arrays `bodies`,
/// `rotors`, `drives`, `frictions` and `points` take the place of constants. Empty where none does.
std::string print_link_inputs(const LinkLoops& loops, const LoopNames& names);

/// A member of the table.
struct LinkMember {
  const char* name;
  std::string value;
};

/// The members that the robot's table has, in their order, as arguments of the function change
/// them. `gravity` are constants.
std::vector<LinkMember> list_members(const LinkLoops& loops, const LoopNames& names,
                                     const std::vector<std::string>& gravity);

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
