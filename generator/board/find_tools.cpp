#include <fmt/format.h>

#include "board/cross_compile.hpp"

namespace treeline {
namespace {

/// Starts a program for its version. Returns the first line that it prints.
std::optional<std::string> ask_version(const std::string& program, const char* package,
                                       const Target& target, const std::filesystem::path& work,
                                       Diagnostics& diagnostics) {
  const CommandOutcome outcome = run_commands({{program, "--version"}}, 1, work).front();
  if (outcome.started && outcome.exit_code == 0) {
    return outcome.output.substr(0, outcome.output.find('\n'));
  }
  diagnostics.add({Severity::error, "", 0, program,
                   outcome.started
                       ? "this program fails when asked for its version"
                       : fmt::format("there is no such program, which {} needs", target.name),
                   fmt::format("Install it (Debian: apt-get install {}).", package)});
  return std::nullopt;
}

/// QEMU with the options that every run has. What the program prints comes on standard output.
Command simulate(const Board& board) {
  Command command{board.simulator};
  for (const std::string& word : split_words(board.machine)) command.push_back(word);
  for (const char* word : {"-icount", "shift=0", "-display", "none", "-monitor", "none", "-serial",
                           "none", "-chardev", "stdio,id=host", "-semihosting-config",
                           "enable=on,target=native,chardev=host", "-kernel"}) {
    command.emplace_back(word);
  }
  return command;
}

}  // namespace

std::optional<Tools> find_tools(const Target& target, const std::string& runner,
                                const std::filesystem::path& work, Diagnostics& diagnostics) {
  const Board& board = target.board;
  Tools tools{std::string(target.prefix) + "g++",
              std::string(target.prefix) + "gcc",
              target.prefix,
              {},
              split_words(runner)};
  const auto version = ask_version(tools.compiler, target.package, target, work, diagnostics);
  if (tools.runner.empty()) {
    tools.runner = simulate(board);
    if (!ask_version(board.simulator, board.package, target, work, diagnostics)) {
      return std::nullopt;
    }
  }
  if (!version) return std::nullopt;
  tools.compiler_version = *version;
  return tools;
}

}  // namespace treeline
