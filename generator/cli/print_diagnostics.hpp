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
  summary,  ///< faults of form in one line a file, see `Minor`
  none      ///< nothing: errors alone
};

/// `--warnings all|summary|none`; `warnings` must outlive the command.
void add_warnings_option(CLI::App& command, Warnings& warnings);

/// What is told, in order: notes, faults of form as one line a file unless all are asked for, other
/// warnings, errors. What matters most comes last, where a terminal shows it.
std::vector<Diagnostic> select_diagnostics(const Diagnostics& diagnostics, Warnings warnings);

/// The diagnostics as text, each with its remedy; where the same remedy is told several times in a
/// row, once behind the last. With colour, for a terminal.
std::string print_diagnostics_text(const std::vector<Diagnostic>& list, bool colour);

/// Those that are selected, on standard error; in colour where that is a terminal and the
/// environment does not say NO_COLOR or TERM=dumb. With TREELINE_MESSAGES=json in the environment,
/// for programs, each is a line of JSON: its members, and as `text` what people are shown.
void print_diagnostics(const Diagnostics& diagnostics, Warnings warnings = Warnings::summary);

}  // namespace treeline
