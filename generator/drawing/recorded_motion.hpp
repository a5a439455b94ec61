#pragma once

#include <optional>
#include <string>
#include <vector>

#include "text/diagnostic.hpp"

namespace treeline {

/// Motion of a robot that was recorded.
struct RecordedMotion {
  std::vector<double> times;           ///< s, rising
  std::vector<std::vector<double>> q;  ///< the robot's coordinates at each time, rad, m
};

/// Reads a motion: a table of `treeline simulate --csv` or of an experiment, with a column `time`
/// or `time_s` and columns `q0`, `q1` and so on, or `q_JOINT`; or the lines of `treeline drive
/// --record`. `joints` names the joint of each coordinate, `home` is what a coordinate without a
/// column has. Errors name the line.
std::optional<RecordedMotion> read_motion(const std::string& path,
                                          const std::vector<std::string>& joints,
                                          const std::vector<double>& home,
                                          Diagnostics& diagnostics);

}  // namespace treeline
