#pragma once

#include <fstream>
#include <string>

#include "text/diagnostic.hpp"

namespace treeline {

/// The file of `--record`: JSON lines, of which the first is the `hello` of the drive.
class RecordWriter {
 public:
  /// `file` empty: nothing is recorded.
  explicit RecordWriter(std::string file) : file_(std::move(file)) {}

  bool open(const std::string& hello, Diagnostics& diagnostics);
  bool is_wanted() const { return !file_.empty(); }
  /// Whether the state of `time` (s) is to be recorded: a hundred are a second.
  bool wants_state(double time);
  /// Writes a line. The first that cannot be written is said; the robot goes on without its record.
  void write(const std::string& line, double time);
  /// Writes what is left. Returns whether all of the record has been written.
  bool close(double time);

 private:
  void watch(double time);

  std::string file_;
  std::ofstream stream_;
  double recorded_ = -1;
  bool failed_ = false;
};

}  // namespace treeline
