#pragma once

#include <string>
#include <vector>

#include "text/diagnostic.hpp"

namespace CLI {
class App;
}

namespace treeline {

/// How much of what is no error is told.
enum class Warnings {
  all,      ///< each by itself
  summary,  ///< formatting problems in one line a file, see `Minor`
  none      ///< nothing: errors alone
};

/// `--warnings all|summary|none`; `warnings` must outlive the command.
void add_warnings_option(CLI::App& command, Warnings& warnings);

/// Selects the diagnostics to print, in order: notes, formatting problems (summarised in one line a
/// file unless all are asked for), other warnings, errors. Errors come last, where they are seen.
std::vector<Diagnostic> select_diagnostics(const Diagnostics& diagnostics, Warnings warnings);

/// The diagnostics as text, each with its remedy; where the same remedy is told several times in a
/// row, once behind the last. With colour, for a terminal.
std::string print_diagnostics_text(const std::vector<Diagnostic>& list, bool colour);

/// Prints the selected diagnostics on standard error, in colour if that is a terminal and neither
/// NO_COLOR nor TERM=dumb is set. With TREELINE_MESSAGES=json in the environment, for programs,
/// each is a line of JSON: its members, and as `text` what people are shown.
void print_diagnostics(const Diagnostics& diagnostics, Warnings warnings = Warnings::summary);

}  // namespace treeline
