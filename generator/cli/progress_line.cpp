#include "cli/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace treeline {

bool is_watched() {
  return isatty(STDERR_FILENO) != 0;
}

void show_progress(const std::string& line) {
  fmt::print(stderr, "\r\033[K{}", line);
  std::fflush(stderr);
}

}  // namespace treeline
