// Counts what a program takes from the heap by `new`, and its locks, while `updating`. Apart from
// the program, so that no compiler joins `new` of one with `delete` of the other.
#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cstdlib>
#include <new>

std::atomic<bool> updating{false};
std::atomic<int> taken{0};

void* operator new(std::size_t size) {
  if (updating) ++taken;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

extern "C" int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  using Lock = int (*)(pthread_mutex_t*);
  static const auto next = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
  if (updating) ++taken;
  return next(mutex);
}
