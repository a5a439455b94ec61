#pragma once

#include <chrono>
#include <string>

namespace treeline {

/// Whether somebody sees what is written to stderr while it is.
bool is_watched();

/// Writes a line over the last one; an empty one clears it.
void show_progress(const std::string& line);

/// A line for what may be over at once: nothing is shown in the first two seconds, nor where nobody
/// sees it, and nothing is left in the end.
class LateProgress {
 public:
  LateProgress() = default;
  ~LateProgress();
  LateProgress(const LateProgress&) = delete;
  LateProgress& operator=(const LateProgress&) = delete;

  void show(const std::string& line);

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool shown_ = false;
};

}  // namespace treeline
