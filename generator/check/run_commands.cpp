#include "check/run_commands.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <future>
#include <iterator>
#include <sstream>

namespace treeline {
namespace {

std::string read_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Starts the command with its output going to `log`. Returns 0 or an error number.
int spawn(const Command& command, const std::filesystem::path& log, pid_t& child) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& argument : command) {
    arguments.push_back(const_cast<char*>(argument.c_str()));  // POSIX: not modified
  }
  arguments.push_back(nullptr);
  const int error =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

CommandOutcome run(const Command& command, const std::filesystem::path& log) {
  CommandOutcome outcome;
  const auto start = std::chrono::steady_clock::now();
  pid_t child = 0;
  if (spawn(command, log, child) != 0) return outcome;
  outcome.started = true;
  int status = 0;
  rusage usage{};
  while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.peak_kib = usage.ru_maxrss;
  outcome.output = read_file(log);
  return outcome;
}

}  // namespace

std::vector<CommandOutcome> run_commands(const std::vector<Command>& commands, int parallel,
                                         const std::filesystem::path& folder) {
  std::vector<CommandOutcome> outcomes(commands.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < commands.size(); i = next++) {
      outcomes[i] = run(commands[i], folder / ("command" + std::to_string(i) + ".log"));
    }
  };
  std::vector<std::future<void>> workers;
  for (int i = 0; i < std::max(1, parallel); ++i) {
    workers.push_back(std::async(std::launch::async, work));
  }
  for (auto& worker : workers) worker.get();
  return outcomes;
}

std::vector<std::string> split_words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace treeline
