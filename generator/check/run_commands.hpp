#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace treeline {

/// A program and its arguments; the program is looked for in PATH. No shell reads them.
using Command = std::vector<std::string>;

struct CommandOutcome {
  bool started = false;  ///< false: there is no such program
  int exit_code = -1;    ///< -1: a signal ended it
  std::string output;    ///< standard output and error together
  double seconds = 0;
  long peak_kib = 0;  ///< of the largest process among it and its children
};

/// Runs the commands, at most `parallel` at a time, and waits for all. Outputs and temporary files
/// lie in `folder`. They read no input and end on signals to this program: `clean_up_on_signals`.
/// `progress` is told how many have ended, of how many, by one thread at a time.
std::vector<CommandOutcome> run_commands(const std::vector<Command>& commands, int parallel,
                                         const std::filesystem::path& folder,
                                         const std::function<void(int, int)>& progress = {});

/// All bytes of a file; none where it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// The words of a text, between white space.
std::vector<std::string> split_words(const std::string& text);

}  // namespace treeline
