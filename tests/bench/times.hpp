#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace treeline::bench {

/// Nanoseconds per state in all repetitions of one benchmark.
struct Times {
  std::vector<double> repetitions;

  [[nodiscard]] double median() const;
  [[nodiscard]] double least() const;
};

using AllTimes = std::map<std::string, Times>;  ///< by name of the benchmark

/// Adds the times of earlier runs in the file `path`, then writes all times to it.
void add_times(const std::string& path, AllTimes& times);

/// Collects times. Prints only errors.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override;

  AllTimes times;
};

}  // namespace treeline::bench
