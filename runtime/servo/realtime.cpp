#include "servo/realtime.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace treeline::servo {
namespace {

void append(const std::string& what, std::string& text) {
  text += (text.empty() ? "" : "; ") + what;
}

/// The last of the cores in the set, where the fewest interrupts are served; -1: none.
int last_core(const cpu_set_t& cores) {
  int last = -1;
  for (int core = 0; core < CPU_SETSIZE; ++core) last = CPU_ISSET(core, &cores) ? core : last;
  return last;
}

/// Takes a core from all threads of this process but the calling one. Threads that they start later
/// inherit that. Returns whether all could be told; one that has ended meanwhile needs no telling.
bool keep_others_off(int core) {
  const auto self = static_cast<pid_t>(syscall(SYS_gettid));
  bool kept = true;
  std::error_code error;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task", error)) {
    const auto thread = static_cast<pid_t>(std::atoi(task.path().filename().c_str()));
    cpu_set_t cores;
    if (thread == self || sched_getaffinity(thread, sizeof(cores), &cores) != 0) continue;
    CPU_CLR(core, &cores);
    if (CPU_COUNT(&cores) == 0) continue;  // it was put there on purpose
    kept = (sched_setaffinity(thread, sizeof(cores), &cores) == 0 || errno == ESRCH) && kept;
  }
  return kept && !error;
}

/// Gives the calling thread the last core that it may run on, and keeps the others off it. Returns
/// what was refused.
std::string pin() {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof(allowed), &allowed) != 0) {
    return std::string("not pinned to a core: ") + std::strerror(errno);
  }
  const int core = last_core(allowed);
  if (CPU_COUNT(&allowed) < 2) return "one core for all threads";
  cpu_set_t own;
  CPU_ZERO(&own);
  CPU_SET(core, &own);
  if (sched_setaffinity(0, sizeof(own), &own) != 0) {
    return std::string("not pinned to a core: ") + std::strerror(errno);
  }
  return keep_others_off(core) ? std::string() : "other threads share its core";
}

}  // namespace

std::string request_realtime() {
  std::string refused;
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    append(std::string("memory is not locked: ") + std::strerror(errno), refused);
  }
  // Below the kernel's own threads (50) and above everything ordinary.
  sched_param parameters{};
  parameters.sched_priority = 40;
  if (const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters)) {
    append(std::string("no real-time scheduling: ") + std::strerror(error), refused);
    // Among others of its kind a thread that is pinned waits where one that is not would move on.
    append("so not pinned to a core", refused);
    return refused;
  }
  if (const std::string unpinned = pin(); !unpinned.empty()) append(unpinned, refused);
  return refused;
}

bool request_attention() {
  constexpr int kNice = -10;
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));  // of Linux's threads, not of all
  return setpriority(PRIO_PROCESS, thread, kNice) == 0;
}

}  // namespace treeline::servo
