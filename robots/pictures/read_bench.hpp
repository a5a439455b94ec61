#pragma once

#include <string>
#include <vector>

namespace treeline::pictures {

/// One line of a report of `treeline bench`.
struct BenchLine {
  double nanoseconds = 0.0;  ///< of a call, median
  double worst = 0.0;        ///< largest norm-wise error over all states
  std::string variant;       ///< what was timed, as the report names it
};

/// All ways to compute one function. The first line is the code that the scene asks for.
struct BenchTable {
  std::string function;
  std::vector<BenchLine> lines;
};

struct BenchReport {
  std::string robot;
  std::vector<std::string> machine;  ///< processor and compiler, a line each
  std::vector<BenchTable> tables;
};

/// Reads what `treeline bench` prints. Empty, with the reason in `error`, when `path` is missing or
/// is no such report.
BenchReport read_bench(const std::string& path, std::string& error);

}  // namespace treeline::pictures
