#include "compilation/run_commands.hpp"

#include <fcntl.h>
#include <signal.h>
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
#include <mutex>
#include <sstream>
#include <string_view>
#include <thread>

#include "interruption/clean_up.hpp"

namespace treeline {
namespace {

std::vector<char*> pointers_to(const std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (const std::string& word : words) {
    pointers.push_back(const_cast<char*>(word.c_str()));  // POSIX: spawn does not modify it
  }
  pointers.push_back(nullptr);
  return pointers;
}

/// This process's environment, but with `folder` as the place of temporary files.
std::vector<std::string> environment_in(const std::filesystem::path& folder) {
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    if (!std::string_view(*variable).starts_with("TMPDIR=")) variables.emplace_back(*variable);
  }
  variables.push_back("TMPDIR=" + std::filesystem::absolute(folder).string());
  return variables;
}

/// Attributes of a child process. It has a process group of its own, so that it can be ended
/// together with everything it starts. Signals that this program waits for are not blocked in it.
/// It has no input, and its output goes to `log`.
class Start {
 public:
  explicit Start(const std::filesystem::path& log) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setsigmask(&attributes_, &none);
  }
  ~Start() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  Start(const Start&) = delete;
  Start& operator=(const Start&) = delete;

  /// Starts the process. Returns 0 or an error number.
  int spawn(const Command& command, const std::filesystem::path& folder, pid_t& child) const {
    const std::vector<std::string> variables = environment_in(folder);
    const std::vector<char*> arguments = pointers_to(command);
    return posix_spawnp(&child, arguments[0], &actions_, &attributes_, arguments.data(),
                        pointers_to(variables).data());
  }

 private:
  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

/// Starts the command. From now on a signal to this program ends it.
bool spawn(const Command& command, const std::filesystem::path& log, pid_t& child) {
  const Start start(log);
  const Uninterrupted now;
  if (start.spawn(command, log.parent_path(), child) != 0) return false;
  end_on_signal(child);
  return true;
}

/// Waits for the end of a process. Its number is forgotten before the system may assign it to
/// another.
int wait_for(pid_t child, rusage& usage) {
  siginfo_t ended{};
  while (waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
  }
  const Uninterrupted now;
  forget_process(child);
  int status = 0;
  while (wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

CommandOutcome run(const Command& command, const std::filesystem::path& log) {
  CommandOutcome outcome;
  const auto start = std::chrono::steady_clock::now();
  pid_t child = 0;
  if (!spawn(command, log, child)) return outcome;
  outcome.started = true;
  rusage usage{};
  outcome.exit_code = wait_for(child, usage);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.peak_kib = usage.ru_maxrss;
  outcome.output = read_file(log);
  return outcome;
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<CommandOutcome> run_commands(const std::vector<Command>& commands, int parallel,
                                         const std::filesystem::path& folder,
                                         const std::function<void(int, int)>& progress) {
  std::vector<CommandOutcome> outcomes(commands.size());
  std::atomic<std::size_t> next = 0;
  std::mutex telling;
  int done = 0;
  const auto tell = [&](int more) {
    const std::lock_guard lock(telling);
    done += more;
    if (progress) progress(done, static_cast<int>(commands.size()));
  };
  tell(0);
  const auto work = [&] {
    for (std::size_t i = next++; i < commands.size(); i = next++) {
      outcomes[i] = run(commands[i], folder / ("command" + std::to_string(i) + ".log"));
      tell(1);
    }
  };
  std::vector<std::future<void>> workers;
  for (int i = 0; i < std::max(1, parallel); ++i) {
    workers.push_back(std::async(std::launch::async, work));
  }
  for (auto& worker : workers) worker.get();
  return outcomes;
}

std::string first_lines(const std::string& text) {
  constexpr int kLines = 12;
  std::istringstream stream(text);
  std::string lines;
  std::string line;
  for (int i = 0; i < kLines && std::getline(stream, line); ++i) lines += "\n  " + line;
  return lines + (std::getline(stream, line) ? "\n  ..." : "");
}

int count_cores(int jobs) {
  return jobs > 0 ? jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::vector<std::string> split_words(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace treeline
