#pragma once

#include <string>
#include <vector>

#include "bench/measure_error.hpp"
#include "bench/variant.hpp"
#include "timing/time_calls.hpp"

namespace treeline {

/// Where it was measured.
struct BenchMachine {
  std::string processor;
  std::string compiler;     ///< of the generated code: its first line about itself
  std::string command;      ///< compiler and flags of the code that the scene asks for
  std::string interpreter;  ///< the compiler that built the interpreter
};
/// `command`: see `Compilation::command`.
BenchMachine describe_machine(const std::string& command);

/// What became of one variant.
struct BenchRow {
  Variant variant;
  Timing timing;  ///< its ratio is to the first row's
  ErrorSummary norm, component;
  /// No other row is as fast and as accurate, by the worst norm-wise error. Never where work is
  /// left to the caller.
  bool on_front = false;
};

struct BenchFunction {
  Function function{};
  std::vector<BenchRow> rows;  ///< the code that the scene asks for comes first
  int states = 0;              ///< that errors are of
  int singular = 0;            ///< states left out: the matrix solved with is singular in float
};

struct BenchReport {
  std::string name, robot;
  BenchMachine machine;
  int states = 0;
  std::uint64_t seed = 1;
  std::vector<BenchFunction> functions;
};

/// Sets `on_front` of each row.
void mark_front(std::vector<BenchRow>& rows);

/// A table for each function.
std::string print_table(const BenchReport& report);
/// One JSON object a line: the machine, then every variant of every function.
std::string print_json_lines(const BenchReport& report);

}  // namespace treeline
