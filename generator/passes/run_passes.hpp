#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Effect of one pass: the operations that the results need, and the nodes of the graph including
/// dead ones, before and after.
struct PassReport {
  std::string pass;
  OperationCount before, after;
  std::size_t nodes_before = 0, nodes_after = 0;
};

/// Reduces a traced program to the operations that are emitted: removes dead code, finds cheaper
/// forms, forms packs of lanes. The program's cost is final after this. Each pass appends a line to
/// `log`.
Program reduce_operations(Program program, std::vector<PassReport>& log);

/// Puts the operations of a program into the order of emission. Only the chosen route needs this.
Program put_in_order(const Program& program, std::vector<PassReport>& log);

/// One line of the log: `inverse_dynamics: eliminate_dead 2600 -> 2219 flops, 3500 -> 2800 nodes`
std::string to_string(const std::string& function, const PassReport& report);

}  // namespace treeline
