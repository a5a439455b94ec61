#pragma once

#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// What one pass did: its name and the operations before and after it.
struct PassReport {
  std::string pass;
  OperationCount before, after;
};

/// Traced program to program in the order of emission: dead code out, cheaper forms, schedule. Each
/// pass appends a line to `log`.
Program run_passes(Program program, std::vector<PassReport>& log);

/// `inverse_dynamics: eliminate_dead 2600 -> 2219 flops`
std::string to_string(const std::string& function, const PassReport& report);

}  // namespace treeline
