#pragma once

#include <span>
#include <string>
#include <vector>

#include "emission/syntax.hpp"
#include "program/link_loops.hpp"
#include "program/program.hpp"

namespace treeline {

/// A table of links as initializers, which C and C++ write alike: the lists of its links, points,
/// rows of points, drives, frictions, couplings, ball joints and the frames of each of its inputs
/// without the braces around them.
struct LinkTableText {
  const LinkTableData* data = nullptr;
  bool shares = false;       ///< all but points and rows with a table before it
  bool is_constant = false;  ///< a function has it as it is: no argument changes it
  std::string links, points, pushed_points, rows, row_entries, drives, frictions, couplings, balls;
  std::string loaded_links;
  std::vector<std::string> gravity;
  std::vector<std::string> frames;
};

/// A constant array of the robot. The type is called as in `runtime/emitted/link_types.h`.
struct LinkArray {
  const char* type;
  std::string name;
  std::size_t count;
  std::string rows;
};

/// The arrays of a table, but for those that one before it has.
std::vector<LinkArray> list_arrays(const LinkTableText& table);

LinkTableText print_link_table(const LinkTableData& table, const Syntax& syntax);

/// Whether arguments of a function change its table, or this one does.
bool changes_table(const LinkLoops& loops);
bool changes_table(const LinkLoops& loops, const std::string& argument);

/// Whether any function has arguments that say something of links or points.
bool has_inputs(std::span<const Program> programs);

/// The tables of the functions that loop, each once: with points, and without. Throws
/// std::logic_error where there are more.
std::vector<LinkTableText> list_link_tables(std::span<const Program> programs,
                                            const Syntax& syntax);

/// The array of what the function's law takes of rows that yield, which `name` declares; empty
/// where it has no such law.
std::string print_yields(const LinkLoops& loops, const Syntax& syntax, const std::string& name);

/// Whether the function takes rows in the order of priority.
bool is_ranked(const LinkLoops& loops);

/// Entries of factors in the work space, see `TlFactorWork`; without any an array has one.
std::size_t count_base_entries(const LinkTableData& table);

bool has_points(const LinkTableData& table);

}  // namespace treeline
