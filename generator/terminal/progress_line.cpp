#include "terminal/progress_line.hpp"

#include <unistd.h>

#include <cstdio>

#include "terminal/write_output.hpp"

namespace treeline {

bool is_watched() {
  return isatty(STDERR_FILENO) != 0;
}

void show_progress(const std::string& line) {
  print_message("\r\033[K" + line);
  std::fflush(stderr);
}

LateProgress::~LateProgress() {
  if (shown_) show_progress("");
}

void LateProgress::show(const std::string& line) {
  constexpr std::chrono::seconds kPatience{2};
  if (!is_watched() || std::chrono::steady_clock::now() - start_ < kPatience) return;
  show_progress(line);
  shown_ = true;
}

}  // namespace treeline
