#pragma once

#include <string>
#include <vector>

#include "terminal/exit_code.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

enum class OutputForm { text, json };

/// Writes data to standard output, whole. Characters that would do something to a terminal are
/// written as `\x1b` (in JSON as `\u001b`). Returns `exit_code`; where the data cannot be written
/// to their end (full disk), complains on standard error and returns `kBadInput`.
ExitCode write_output(const std::string& data, OutputForm form, ExitCode exit_code);

/// Writes what people read to standard error. Where that is closed or full nobody can be told, so
/// the text is lost and the work goes on.
void print_message(const std::string& text);

/// Whether a file to write is none of those that are `read`, nor a link to one; else with an
/// error.
bool is_none_of(const std::string& path, const std::vector<std::string>& read,
                Diagnostics& diagnostics);

/// Whether a file can be written, or made: its folder exists and is ours to write. Nothing is
/// written; with an error if not.
bool can_write(const std::string& path, Diagnostics& diagnostics);

/// Whether both hold of a file that is to be written in the end: nobody should wait for results to
/// lose them then. An empty path and "-" are no file.
bool may_write(const std::string& path, const std::vector<std::string>& read,
               Diagnostics& diagnostics);

/// Writes data to a file as they are. Errors: the folder is missing or not ours, the disk is full;
/// then no part of the file stays; or it is one of the files that are `read`.
bool write_output_file(const std::string& path, const std::string& data, Diagnostics& diagnostics,
                       const std::vector<std::string>& read = {});

}  // namespace treeline
