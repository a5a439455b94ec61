#pragma once

#include <string>

#include "inspect/report.hpp"

namespace treeline {

/// Prints for people which inertias are impossible, whether they affect the motion, and which
/// bodies are flat. Empty if there is nothing to report.
std::string print_inertias(const Report& report);

}  // namespace treeline
