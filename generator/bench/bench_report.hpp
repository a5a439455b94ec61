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

/// Another library that was measured.
struct BenchPeer {
  std::string name;                  ///< what its variants' names begin with
  std::string release;               ///< "1.5.1"
  std::vector<std::string> remarks;  ///< what it cannot do here, and why: "has no floating base"
};

struct BenchFunction {
  Function function{};
  std::vector<BenchRow> rows;  ///< the code that the scene asks for comes first
  int states = 0;              ///< that errors are of
  int singular = 0;            ///< states left out: the matrix solved with is singular in float
  /// Peers that compute something else, see `kAgreement`. They are not timed.
  std::vector<BenchRow> disagreeing = {};
};

struct BenchReport {
  std::string name, robot;
  BenchMachine machine;
  int states = 0;
  std::uint64_t seed = 1;
  std::vector<BenchFunction> functions;
  std::vector<BenchPeer> peers = {};
  std::vector<std::string> absent_peers = {};  ///< that could be measured, if they were there
  std::string no_peers = {};                   ///< why none can be asked for this robot
};

/// A peer whose median norm-wise error is larger computes another robot or another function.
inline constexpr double kAgreement = 1e-6;

/// Sets `on_front` of each row.
void mark_front(std::vector<BenchRow>& rows);

/// A table for each function.
std::string print_table(const BenchReport& report);
/// One JSON object a line: the machine, then every variant of every function.
std::string print_json_lines(const BenchReport& report);

}  // namespace treeline
