#include "board/find_tools.hpp"

#include <fmt/format.h>

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

}  // namespace

std::optional<Tools> find_tools(const Target& target, const std::filesystem::path& work,
                                Diagnostics& diagnostics) {
  const Board& board = target.board;
  Tools tools{std::string(target.prefix) + "g++",
              std::string(target.prefix) + "gcc",
              target.prefix,
              {},
              {}};
  const auto version = ask_version(tools.compiler, target.package, target, work, diagnostics);
  const auto simulator = ask_version(board.simulator, board.package, target, work, diagnostics);
  if (!version || !simulator) return std::nullopt;
  tools.compiler_version = *version;
  tools.simulator = {board.simulator};
  for (const std::string& word : split_words(board.machine)) tools.simulator.push_back(word);
  for (const char* word : {"-icount", "shift=0", "-display", "none", "-monitor", "none", "-serial",
                           "none", "-semihosting-config", "enable=on,target=native"}) {
    tools.simulator.emplace_back(word);
  }
  return tools;
}

}  // namespace treeline
