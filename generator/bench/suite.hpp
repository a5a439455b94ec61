#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/bench_report.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A robot of a suite of benchmarks.
struct SuiteRobot {
  std::string urdf, scene;  ///< paths
};

/// Reads a list of robots: a line each, with the paths of a URDF and of a scene, relative to the
/// list's own folder. Lines that begin with # are comments. Errors: the file cannot be read, is
/// empty, or has a line of other than two words.
std::optional<std::vector<SuiteRobot>> read_suite(const std::filesystem::path& path,
                                                  Diagnostics& diagnostics);

/// How the emitted code does beside other libraries in one function of one robot.
struct SuiteResult {
  std::string scene;
  Function function{};
  const BenchRow* emitted = nullptr;
  const BenchRow* in_c = nullptr;      ///< null: not measured
  const BenchRow* batch = nullptr;     ///< of eight states a call; null: not measured
  const BenchRow* best = nullptr;      ///< the fastest peer that loads a robot; null: there is none
  const BenchRow* recorded = nullptr;  ///< the fastest that makes code for it; null: there is none
};

/// Pointers into `reports`, which must outlive them.
std::vector<SuiteResult> compare_to_best(const std::vector<BenchReport>& reports);

/// Prints a line for each function of each robot: times, errors, bytes, and how many times as long
/// the fastest peer takes, of those that load a robot and of those that make code for it.
std::string print_table(const std::vector<BenchReport>& reports);

/// Prints the reports of all robots, a line of JSON each for machine, variant and remark.
std::string print_json_lines(const std::vector<BenchReport>& reports);

/// Draws how many times as long the fastest peer takes, a dot for each robot in a row for each
/// function, on a scale of powers of ten.
std::string draw_svg(const std::vector<BenchReport>& reports);

}  // namespace treeline
