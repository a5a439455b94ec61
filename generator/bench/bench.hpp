#pragma once

#include <functional>
#include <optional>
#include <string>

#include "bench/bench_report.hpp"
#include "bench/find_peers.hpp"
#include "description/robot.hpp"

namespace treeline {

struct BenchOptions {
  int states = 300;  ///< within the joints' limits, at ordinary velocities
  std::uint64_t seed = 1;
  std::string flags = kBenchFlags;  ///< for the compiler
  TimingOptions timing = {};
  FoundPeers peers = {};  ///< peers to measure as well
  /// Kinds of variants that are measured beside the emitted code. Empty: all.
  std::vector<VariantGroup> groups = {};
  /// How many times compiled code is loaded, each at addresses of its own, and timed. The times of
  /// large functions depend on where they lie.
  int places = 1;
  /// Reports progress: what is done, how much of it, and how much in all ("states", 10, 300).
  std::function<void(const std::string& what, int done, int total)> progress = {};
};

/// Runs every variant of every function of the scene and measures its time and its error against
/// the interpreter in 50 digits; for the states see `BenchTruths`. Returns nothing if something
/// cannot be generated or compiled; `diagnostics` says why.
std::optional<BenchReport> run_bench(const Robot& robot, const Scene& scene,
                                     const BenchOptions& options, Diagnostics& diagnostics);

}  // namespace treeline
