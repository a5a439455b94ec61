#pragma once

#include <functional>
#include <string>

#include "program/link_loops.hpp"

namespace treeline {

/// How a language names what the loops over links use.
struct LoopNames {
  std::function<std::string(const std::string&)> type;      ///< `LinkBody`
  std::function<std::string(const std::string&)> function;  ///< `copy_bodies`
  std::function<std::string(const std::string&)> array;     ///< local, or an argument
  std::function<std::string(const std::string&)> constant;  ///< of the robot: `links`
};

/// What a function does before it loops where arguments change the table: arrays `bodies` and
/// `points` take the place of constants. Empty where none does.
std::string print_link_inputs(const LinkLoops& loops, const LoopNames& names);

/// Gravity with its braces: an argument of a function, if it has that, or else `constant`.
std::string print_gravity(const LinkLoops* loops, const std::string& constant);

/// Whether it is about links, not points.
bool is_of_links(const LinkInput& input);

/// Whether arguments move points of the table.
bool moves_points(const LinkTableData& table);

/// `payload_frames`, the constants of an input.
std::string frames_name(const LinkInput& input);

}  // namespace treeline
