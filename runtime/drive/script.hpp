#pragma once

#include <deque>
#include <string>
#include <string_view>

namespace treeline::drive {

/// Lines of the command language that are obeyed one after the other. `wait` waits until all
/// motions have ended, `wait T s` for T seconds; every other line follows at once, but in a report
/// of its own, so that it sees what the line before has changed.
class Script {
 public:
  struct Line {
    int number = 0;
    std::string text;
  };

  Script() = default;
  explicit Script(std::string_view text) { append(text); }

  /// Adds lines at the end; all but the last are complete. A line that has no end is cut, and then
  /// longer than any command.
  void append(std::string_view text);
  /// Whether more should wait until some of what was added has been obeyed.
  bool is_full() const { return lines_.size() >= 1000; }
  /// No more lines will come: what is left of the last one is a line.
  void close();

  /// The next line that is due at `time` (s, of the loop), if there is one.
  bool next(double time, bool moving, Line& line);
  /// Waits before the next line: for `seconds`, or if 0, until nothing moves.
  void wait(double time, double seconds);
  /// Whether all lines are obeyed and all waits are over.
  bool ended(double time, bool moving) const;
  /// Whether a line has not been obeyed, or a wait is not over.
  bool has_more(double time, bool moving) const;

 private:
  bool waits(double time, bool moving) const;

  std::deque<Line> lines_;
  std::string rest_;
  int numbers_ = 0;
  bool closed_ = false;
  double not_before_ = 0.0;
  bool until_rest_ = false;
};

}  // namespace treeline::drive
