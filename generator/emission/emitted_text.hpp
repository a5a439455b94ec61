#pragma once

#include <map>
#include <string>
#include <string_view>

#include "program/program.hpp"

namespace treeline {

/// `text` as lines of at most 100 columns, the first indented by `indentation` blanks, the others
/// by four more. Breaks behind an operator or comma, preferably one outside of parentheses.
std::string wrap_line(std::string_view text, std::size_t indentation);

/// A text for a hole of a template that has so much indentation: its first line without it, the
/// others indented beyond it. No end of line.
std::string wrap_in_hole(std::string_view text, std::size_t indentation);

/// What `print` makes of each argument (which is "const ") and each result (which is ""), with
/// commas between.
template <class Print>
std::string join_arguments(const Program& program, Print print) {
  std::string list;
  const auto append = [&](const std::string& one) { list += (list.empty() ? "" : ", ") + one; };
  for (const Argument& argument : program.arguments) append(print(argument, "const "));
  for (const Result& result : program.results) append(print(result.argument, ""));
  return list;
}

/// `text` with every `{{hole}}` replaced by the value of that name. A hole that stands alone on its
/// line keeps its indentation for every line of the value; an empty value takes the line with it.
/// Throws std::logic_error when a hole has no value, a value has no hole, or a hole is not closed:
/// template and emitter have parted, a fault of the program.
std::string fill_template(std::string_view text, const std::map<std::string, std::string>& values);

/// Fills the holes of `text` as `fill_template` does; `values` may have more than it has holes.
std::string fill_holes(std::string_view text, const std::map<std::string, std::string>& values);

}  // namespace treeline
