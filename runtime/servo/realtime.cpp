#include "servo/realtime.hpp"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace treeline::servo {

std::string request_realtime() {
  std::string refused;
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
    refused = std::string("memory is not locked: ") + std::strerror(errno);
  }
  // Below the kernel's own threads (50) and above everything ordinary.
  sched_param parameters{};
  parameters.sched_priority = 40;
  if (const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters)) {
    refused += std::string(refused.empty() ? "" : "; ") +
               "no real-time scheduling: " + std::strerror(error);
  }
  return refused;
}

bool request_attention() {
  constexpr int kNice = -10;
  const auto thread = static_cast<id_t>(syscall(SYS_gettid));  // of Linux's threads, not of all
  return setpriority(PRIO_PROCESS, thread, kNice) == 0;
}

}  // namespace treeline::servo
