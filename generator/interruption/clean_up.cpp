#include "interruption/clean_up.hpp"

#include <signal.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
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

/// Never destroyed: the thread that waits for signals lives as long as the process.
Leftovers& leftovers() {
  static auto* const all = new Leftovers;
  return *all;
}

/// Whether a process of the group is left. Those of this process count until they are waited for.
bool is_alive(pid_t group) {
  while (waitpid(-group, nullptr, WNOHANG) > 0) {
  }
  return kill(-group, 0) == 0;
}

/// Compilers remove their own files when they are asked to end; what does not end is made to.
void end_processes(const std::set<pid_t>& groups) {
#ifdef PR_SET_CHILD_SUBREAPER
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // what they started becomes ours, to be waited for
#endif
  for (const int by : {SIGTERM, SIGKILL}) {
    for (const pid_t group : groups) kill(-group, by);
    for (int i = 0; i < 200 && std::any_of(groups.begin(), groups.end(), is_alive); ++i) {
      std::this_thread::sleep_for(10ms);
    }
  }
}

/// A thread that had not noticed yet may have written into the folder meanwhile: then once more.
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

[[noreturn]] void end_by(int signal) {
  std::set<pid_t> groups;
  std::map<fs::path, Removal> folders;
  {
    const std::lock_guard lock(leftovers().mutex);
    leftovers().ending = true;  // from here on nobody makes or starts anything
    groups = leftovers().groups;
    folders = leftovers().folders;
  }
  end_processes(groups);
  // Deepest first: what is to be empty may hold what is to be removed.
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
      while (sigwait(&set, &signal) != 0) {
      }
      end_by(signal);
    }).detach();
  } catch (const std::system_error&) {  // no more threads: then signals end the program at once
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  }
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
