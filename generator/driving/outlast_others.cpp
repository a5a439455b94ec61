#include <malloc.h>

#include <csignal>

#include "driving/driver.hpp"

namespace treeline {

void outlast_others() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
#ifdef __GLIBC__
  mallopt(M_ARENA_MAX, 1);  // in locked memory an arena of each thread's own takes 64 MiB
#endif
}

}  // namespace treeline
