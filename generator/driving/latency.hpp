#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "driving/driver.hpp"
#include "launch/launch.hpp"
#include "terminal/exit_code.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// How a measurement of the loop's timing goes.
struct LatencySettings {
  double seconds = 600;
  int load = 1;        ///< threads of this program that compute and move memory meanwhile
  std::string report;  ///< PREFIX.json and PREFIX.svg are written; empty: neither
};

/// Runs the control loop of a simulated robot in real time, as `drive` does, and prints period,
/// jitter and control time. A fault of the loop ends it: `kMismatch`. Errors: `start` of another
/// length, files that cannot be written.
ExitCode measure_latency(const LaunchedRobot& robot, const DriveSettings& drive,
                         const LatencySettings& settings, Diagnostics& diagnostics);

/// Durations of all cycles of one kind.
struct LatencySeries {
  std::string name;            ///< "period", "jitter", "control"
  std::vector<float> samples;  ///< us
};

/// Median, shares and extremes, us.
struct LatencySummary {
  double median = 0, p99 = 0, p999 = 0, least = 0, largest = 0;
};
LatencySummary summarise(const LatencySeries& series);

/// Latencies that were measured, and the conditions of the measurement.
struct LatencyReport {
  std::string robot;
  double rate = 0, seconds = 0;
  int load_threads = 0;
  double load_average = 0;  ///< of the machine, at the end, over one minute
  std::string refused;      ///< of real-time scheduling; empty: nothing
  std::uint64_t cycles = 0, late = 0;
  std::string fault;
  std::vector<LatencySeries> series;
};

/// The report for people: conditions, then a line for each series.
std::string print_text(const LatencyReport& report);
/// The summaries, and histograms in bins of 10 us.
std::string print_json(const LatencyReport& report);
/// Histograms side by side as an SVG 1.1 file. Counts are in a logarithmic scale, so that single
/// late cycles are seen.
std::string print_svg(const LatencyReport& report);

}  // namespace treeline
