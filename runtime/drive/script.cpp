#include "drive/script.hpp"

namespace treeline::drive {
namespace {

/// Time until a report shows what a command has changed, s.
constexpr double kUntilReported = 0.01;

bool says_something(const std::string& line) {
  const auto first = line.find_first_not_of(" \t\r");
  return first != std::string::npos && line[first] != '#';
}

}  // namespace

void Script::append(std::string_view text) {
  constexpr std::size_t kLongestKept = 4096;  // bytes: longer than any command
  for (const char c : text) {
    if (c != '\n') {
      if (rest_.size() < kLongestKept) rest_ += c;
      continue;
    }
    ++numbers_;
    if (says_something(rest_)) lines_.push_back({numbers_, rest_});
    rest_.clear();
  }
}

void Script::close() {
  if (!rest_.empty()) append("\n");
  closed_ = true;
}

bool Script::waits(double time, bool moving) const {
  return time < not_before_ || (until_rest_ && moving);
}

bool Script::next(double time, bool moving, Line& line) {
  if (lines_.empty() || waits(time, moving)) return false;
  until_rest_ = false;
  not_before_ = time + kUntilReported;
  line = lines_.front();
  lines_.pop_front();
  return true;
}

void Script::wait(double time, double seconds) {
  until_rest_ = seconds == 0.0;
  not_before_ = time + (seconds > 0.0 ? seconds : kUntilReported);
}

bool Script::has_more(double time, bool moving) const {
  return !lines_.empty() || waits(time, moving);
}

bool Script::ended(double time, bool moving) const {
  return closed_ && !has_more(time, moving);
}

}  // namespace treeline::drive
