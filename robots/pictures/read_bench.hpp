#pragma once

#include <string>
#include <vector>

namespace treeline::pictures {

/// One line of a report of `treeline bench`.
struct BenchLine {
  double nanoseconds = 0.0;  ///< median time of a call
  double worst = 0.0;        ///< largest norm-wise error over all states
  std::string variant;       ///< name of the variant in the report
};

/// All ways to compute one function. The first line is the code that the scene asks for.
struct BenchTable {
  std::string function;
  std::vector<BenchLine> lines;
};

struct BenchReport {
  std::string robot;
  std::vector<std::string> machine;  ///< processor and compiler, one line each
  std::vector<BenchTable> tables;
};

/// Reads a report of `treeline bench`. Empty, with the reason in `error`, if the file `path` is
/// missing or is not such a report.
BenchReport read_bench(const std::string& path, std::string& error);

}  // namespace treeline::pictures
