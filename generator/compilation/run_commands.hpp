#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace treeline {

/// A program and its arguments. The program is searched in PATH; no shell is involved.
using Command = std::vector<std::string>;

struct CommandOutcome {
  bool started = false;  ///< false: the program does not exist
  int exit_code = -1;    ///< -1: ended by a signal
  std::string output;    ///< standard output and standard error together
  double seconds = 0;
  long peak_kib = 0;  ///< of the largest of the process and its children
};

/// Runs the commands, at most `parallel` at a time, and waits for all. Outputs and temporary files
/// are written to `folder`. The commands have no input and end on signals to this program, see
/// `clean_up_on_signals`. `progress` receives the number of commands that have ended and the number
/// of all, from one thread at a time.
std::vector<CommandOutcome> run_commands(const std::vector<Command>& commands, int parallel,
                                         const std::filesystem::path& folder,
                                         const std::function<void(int, int)>& progress = {});

/// Number of commands to run at a time: `jobs`, or as many as there are cores if it is 0.
int count_cores(int jobs);

/// The first twelve lines of a command's output, each on a new line and indented, for a message.
std::string first_lines(const std::string& text);

/// Returns all bytes of a file; an empty string if it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Splits a text at white space.
std::vector<std::string> split_words(const std::string& text);

}  // namespace treeline
