#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// What one pass did to the operations that results need, and to the nodes of the graph, dead ones
/// included.
struct PassReport {
  std::string pass;
  OperationCount before, after;
  std::size_t nodes_before = 0, nodes_after = 0;
};

/// Traced program to one of the operations that are emitted: dead code out, cheaper forms, lanes.
/// What it costs is settled then. Each pass appends a line to `log`.
Program reduce_operations(Program program, std::vector<PassReport>& log);

/// The same operations in the order of emission; for the route that is chosen.
Program put_in_order(const Program& program, std::vector<PassReport>& log);

/// `inverse_dynamics: eliminate_dead 2600 -> 2219 flops, 3500 -> 2800 nodes`
std::string to_string(const std::string& function, const PassReport& report);

}  // namespace treeline
