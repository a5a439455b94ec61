#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/measure_error.hpp"
#include "bench/variant.hpp"
#include "compilation/compile_folder.hpp"
#include "timing/time_calls.hpp"

namespace treeline {

/// The machine on which the measurements were made.
struct BenchMachine {
  std::string processor;
  std::string compiler;     ///< of the generated code: first line of its version text
  std::string command;      ///< compiler and flags of the code that the scene asks for
  std::string interpreter;  ///< the compiler that built the interpreter
};
/// Describes this machine. For `command` see `Compilation::command`.
BenchMachine describe_machine(const std::string& command);

/// Measurements of one variant.
struct BenchRow {
  Variant variant;
  Timing timing;         ///< with the ratio to the time of the first row
  double placement = 1;  ///< time at the slowest place in memory over that at the fastest
  ErrorSummary norm, component;
  /// No other row is both as fast and as accurate, by the largest norm-wise error. Always false if
  /// the caller must do a part of the work.
  bool on_front = false;
  std::optional<CompiledFunction> compiled = {};  ///< of code that was compiled for this
};

/// Another library that was measured.
struct BenchPeer {
  std::string name;                  ///< prefix of its variants' names
  std::string release;               ///< "1.5.1"
  std::vector<std::string> remarks;  ///< what it cannot do here, and why: "has no floating base"
};

struct BenchFunction {
  Function function{};
  std::vector<BenchRow> rows;  ///< the code that the scene asks for comes first
  int states = 0;              ///< number of states for the errors
  int singular = 0;            ///< states left out: the matrix is singular in float
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
  std::vector<std::string> absent_peers = {};  ///< could be measured if installed
  std::string no_peers = {};                   ///< why no peer can be measured for this robot
};

/// Largest median norm-wise error of a peer that agrees. With a larger one it computes another
/// robot or another function.
inline constexpr double kAgreement = 1e-6;

/// Flags for the compiler where the user names none.
inline constexpr const char* kBenchFlags = "-O3 -march=native -ffp-contract=fast";

/// Sets `on_front` of each row.
void mark_front(std::vector<BenchRow>& rows);

/// Share of the time by which a rejected route may be faster than the emitted one, whose cost is an
/// estimate.
inline constexpr double kFasterRoute = 0.05;

/// The fastest of the routes that were not chosen.
struct FastestRejected {
  const BenchRow* row = nullptr;
  /// Whether it is faster than the emitted one by more than `kFasterRoute`, and twice the noise.
  bool is_faster = false;
};
/// Returns nothing where there is one route. `function` must outlive the result.
std::optional<FastestRejected> find_fastest_rejected(const BenchFunction& function);

/// Nanoseconds, in three digits or more.
std::string print_time(double nanoseconds);

/// Prints a table for each function.
std::string print_table(const BenchReport& report);
/// Prints JSON objects, one per line: the machine, then every variant of every function.
std::string print_json_lines(const BenchReport& report);

}  // namespace treeline
