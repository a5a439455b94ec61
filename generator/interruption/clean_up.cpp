#include "interruption/clean_up.hpp"

#include <signal.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <set>
#include <system_error>
#include <thread>

namespace treeline {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

struct Leftovers {
  std::mutex mutex;
  bool ending = false;
  std::map<fs::path, Removal> folders;
  std::set<pid_t> groups;
};

/// Never destroyed, because the thread that waits for signals lives as long as the process.
Leftovers& leftovers() {
  static auto* const all = new Leftovers;
  return *all;
}

/// Whether a process of the group exists. Children of this process count until they are waited for.
bool is_alive(pid_t group) {
  while (waitpid(-group, nullptr, WNOHANG) > 0) {
  }
  return kill(-group, 0) == 0;
}

/// Asks the process groups to end, because compilers then remove their own files, and kills those
/// that do not.
void end_processes(const std::set<pid_t>& groups) {
#ifdef PR_SET_CHILD_SUBREAPER
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // adopts their children, so that they can be waited for
#endif
  for (const int by : {SIGTERM, SIGKILL}) {
    for (const pid_t group : groups) kill(-group, by);
    for (int i = 0; i < 200 && std::any_of(groups.begin(), groups.end(), is_alive); ++i) {
      std::this_thread::sleep_for(10ms);
    }
  }
}

/// Removes the folder. Repeats this if a thread that did not notice the signal has written to it
/// meanwhile.
void remove_folder(const fs::path& folder, Removal removal) {
  std::error_code error;
  for (int i = 0; i < 20; ++i) {
    if (removal == Removal::if_empty) {
      fs::remove(folder, error);
      return;
    }
    fs::remove_all(folder, error);
    if (!fs::exists(folder, error)) return;
    std::this_thread::sleep_for(10ms);
  }
}

std::atomic<void (*)()> first_answer{nullptr};

[[noreturn]] void end_by(int signal) {
  std::set<pid_t> groups;
  std::map<fs::path, Removal> folders;
  {
    const std::lock_guard lock(leftovers().mutex);
    leftovers().ending = true;  // from now on no thread creates folders or starts processes
    groups = leftovers().groups;
    folders = leftovers().folders;
  }
  end_processes(groups);
  // Deepest first, because a folder to be removed if empty may contain folders to be removed.
  for (auto folder = folders.rbegin(); folder != folders.rend(); ++folder) {
    remove_folder(folder->first, folder->second);
  }
  ::signal(signal, SIG_DFL);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  raise(signal);
  _exit(128 + signal);
}

bool is_ignored(int signal) {
  struct sigaction action {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void clean_up_on_signals() {
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!is_ignored(signal)) sigaddset(&set, signal);
  }
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  (void)leftovers();
  try {
    std::thread([set] {
      int signal = 0;
      for (;;) {
        while (sigwait(&set, &signal) != 0) {
        }
        const auto answer = first_answer.exchange(nullptr);
        if (answer == nullptr) end_by(signal);
        answer();
      }
    }).detach();
  } catch (const std::system_error&) {  // no more threads: signals then end the program at once
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  }
}

void answer_signals(void (*answer)()) {
  first_answer = answer;
}

Uninterrupted::Uninterrupted() : lock_(leftovers().mutex) {
  while (leftovers().ending) {
    lock_.unlock();
    std::this_thread::sleep_for(1h);
    lock_.lock();
  }
}

void remove_on_signal(const fs::path& folder, Removal removal) {
  leftovers().folders.insert_or_assign(folder, removal);
}

void keep_on_signal(const fs::path& folder) {
  leftovers().folders.erase(folder);
}

void end_on_signal(pid_t group) {
  leftovers().groups.insert(group);
}

void forget_process(pid_t group) {
  leftovers().groups.erase(group);
}

}  // namespace treeline
