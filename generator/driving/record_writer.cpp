#include <fmt/format.h>

#include "driving/driver.hpp"
#include "terminal/write_output.hpp"
#include "text/printable.hpp"

namespace treeline {

bool RecordWriter::open(const std::string& hello, Diagnostics& diagnostics) {
  if (!is_wanted()) return true;
  stream_.open(file_, std::ios::binary);
  stream_ << hello << '\n';
  stream_.flush();
  if (stream_) return true;
  diagnostics.add({Severity::error, file_, 0, "", "cannot be written",
                   "name a file in a folder that exists and is yours to write, on a disk that is "
                   "not full"});
  return false;
}

bool RecordWriter::wants_state(double time) {
  constexpr double kInterval = 0.01;  // s
  if (!is_wanted() || time < recorded_ + kInterval - 1e-9) return false;
  recorded_ = time;
  return true;
}

void RecordWriter::write(const std::string& line, double time) {
  if (!is_wanted()) return;
  stream_ << line << '\n';
  watch(time);
}

void RecordWriter::watch(double time) {
  if (failed_ || stream_) return;
  failed_ = true;
  print_message(printable(fmt::format("error: {}: the record cannot be written any more and ends "
                                      "before {:.3f} s: is the disk full?",
                                      file_, time)) +
                "\n");
}

bool RecordWriter::close(double time) {
  if (!is_wanted()) return true;
  stream_.flush();
  watch(time);
  return !failed_;
}

}  // namespace treeline
