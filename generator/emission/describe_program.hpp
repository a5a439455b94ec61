#pragma once

#include <set>
#include <span>
#include <string>

#include "program/program.hpp"

namespace treeline {

/// Whether the function reads any element of this argument.
bool reads(const Program& program, const Argument& argument);

/// Names that no local may have: arguments, arrays of angles, and `taken`, what the language's
/// header and file declare.
std::set<std::string> find_taken_names(const Program& program, std::set<std::string> taken);

/// Whether the function has so many operations (12000) that some passes of compilers may take
/// minutes.
bool is_long(const Program& program);

/// Whether the function has so many operations (100000) that compilers take minutes and gigabytes
/// at -O2, or hours where it has several times as many.
bool is_huge(const Program& program);

/// Whether some numbers of the emitted function share registers.
bool uses_lanes(const Program& program);

/// Whether a function has loops: over a table of links, or in a routine with which it ends.
bool has_loops(std::span<const Program> programs);

/// How many functions loop over a table of links.
int count_loops(std::span<const Program> programs);

/// Whether the emitted function needs sine and cosine.
bool uses_trigonometry(const Program& program);

/// "320 flops (170 additions, 150 multiplications, 0 divisions), sine and cosine of 6 angles".
std::string describe_cost(const Program& program);

}  // namespace treeline
