#pragma once

#include <string>

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

}  // namespace treeline
