#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_report.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "timing/time_cold_calls.hpp"

namespace treeline {

/// A function as one or more values of `Scene::optimize` make it.
struct ColdRow {
  std::vector<Optimize> optimize;  ///< values of `optimize` that make this code
  std::string method;              ///< full name of the route
  bool is_small = false;           ///< compiled to small code
  std::optional<int> bytes;        ///< code and constants; absent without `nm` and `size`
  Timing warm;                     ///< ratios here and in `cold` are to the first row's
  ColdTiming cold;
};

struct ColdFunction {
  Function function{};
  std::vector<ColdRow> rows;  ///< `speed` first
};

/// Time in caches and out of them, and bytes, of what `Scene::optimize` chooses between.
struct ColdReport {
  std::string name, robot;
  BenchMachine machine;
  std::string flags;
  std::vector<ColdFunction> functions;
};

struct ColdBenchOptions {
  std::string flags = kBenchFlags;  ///< for the compiler
  int rounds = 31;                  ///< of cold calls
  TimingOptions warm = {};
  std::uint64_t seed = 1;
  /// Reports progress: what is done, how much of it, and how much in all ("compiling", 1, 3).
  std::function<void(const std::string& what, int done, int total)> progress = {};
};

/// "speed, size".
std::string names_of(const ColdRow& row);

/// Generates and compiles the scene's functions, of one state, for each value of `optimize`, and
/// measures them. Returns nothing if something cannot be generated or compiled; `diagnostics` says
/// why.
std::optional<ColdReport> run_cold_bench(const Robot& robot, const Scene& scene,
                                         const ColdBenchOptions& options, Diagnostics& diagnostics);

/// Prints a table for each function.
std::string print_table(const ColdReport& report);
/// Prints JSON objects, one per line: the machine, then every row of every function.
std::string print_json_lines(const ColdReport& report);

}  // namespace treeline
