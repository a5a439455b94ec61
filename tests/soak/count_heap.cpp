// Counts what a servo thread takes from the heap: to be preloaded into `treeline drive`.
//   LD_PRELOAD=libcount_heap.so treeline drive ...
// A servo thread is one with the scheduling SCHED_FIFO. What it takes within the first five seconds
// after its first wait belongs to the start. The outcome is printed at the end.
#include <dlfcn.h>
#include <sched.h>
#include <time.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
}

namespace {

constexpr long kStart = 5;  // s

std::atomic<long> allocations{0}, waits{0};
thread_local long first_wait = 0;  // of this thread, s; 0: it is no servo thread so far

long now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec + 1;
}

void count() {
  if (first_wait != 0 && now() - first_wait >= kStart) ++allocations;
}

void note_wait() {
  if (first_wait == 0 && sched_getscheduler(0) == SCHED_FIFO) first_wait = now();
  waits += first_wait != 0 ? 1 : 0;
}

struct Outcome {
  ~Outcome() {
    std::fprintf(stderr, "servo threads: %ld waits, %ld allocations after the start\n",
                 waits.load(), allocations.load());
  }
} outcome;

}  // namespace

extern "C" {

void* malloc(std::size_t size) {
  count();
  return __libc_malloc(size);
}

void* calloc(std::size_t number, std::size_t size) {
  count();
  return __libc_calloc(number, size);
}

void* realloc(void* old, std::size_t size) {
  count();
  return __libc_realloc(old, size);
}

int clock_nanosleep(clockid_t clock, int flags, const timespec* until, timespec* rest) {
  using Sleep = int (*)(clockid_t, int, const timespec*, timespec*);
  static const auto sleep = reinterpret_cast<Sleep>(dlsym(RTLD_NEXT, "clock_nanosleep"));
  note_wait();
  return sleep(clock, flags, until, rest);
}

int nanosleep(const timespec* time, timespec* rest) {
  using Sleep = int (*)(const timespec*, timespec*);
  static const auto sleep = reinterpret_cast<Sleep>(dlsym(RTLD_NEXT, "nanosleep"));
  note_wait();
  return sleep(time, rest);
}
}
