#pragma once

#include <string>
#include <vector>

#include "data/list_data.hpp"

/// Operations that `snap_angles: 1e-5` saves for published robots.
namespace treeline::growth {

/// Operations of inverse dynamics, forward dynamics and M: as written, and with exact quarter
/// turns.
struct Snapping {
  std::string robot;
  std::vector<int> written, snapped;
};

/// Measures a robot that can be read, on a fixed base, with `lanes: 1` and nothing else in the
/// scene.
Snapping measure_snapping(const tests::DataRobot& robot);

/// Whether a function of the robot saves three per cent or more, so that the robot has a row of its
/// own.
bool has_row(const Snapping& snapping);

/// Prints a row: `| fetch | 2 % | 2 % | 0 % |`.
std::string print_row(const Snapping& snapping);

/// Prints the table of docs/evidence/generated-code.md.
std::string print_snapping(const std::vector<Snapping>& all);

}  // namespace treeline::growth
