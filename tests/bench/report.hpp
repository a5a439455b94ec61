#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

#include "case.hpp"
#include "machine.hpp"
#include "subject.hpp"

namespace treeline::bench {

/// Nanoseconds a call, of all repetitions of one benchmark.
struct Times {
  std::vector<double> repetitions;

  [[nodiscard]] double median() const;
  [[nodiscard]] double least() const;
};

using AllTimes = std::map<std::string, Times>;  ///< by the benchmark's name

/// Collects times and prints nothing but errors.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override;

  AllTimes times;
};

struct Measured {
  Case robot;
  std::vector<Subject> subjects;
};

/// The tables: for each robot and function the times of all implementations and their ratios to the
/// first, then what the generated code is made of. The times are medians, or, for a machine that
/// is not quiet, the least of all repetitions.
std::string print_tables(const std::vector<Measured>& robots, const AllTimes& times,
                         const Machine& machine, bool least);

/// One JSON object a line for each robot, function and implementation.
std::string print_json_lines(const std::vector<Measured>& robots, const AllTimes& times,
                             const Machine& machine);

}  // namespace treeline::bench
