#pragma once

#include "experiments.hpp"

namespace treeline::stress {

/// Closed loops move by generated code in steps whose own error is below rounding (Fehlberg 1968):
/// what is left is the rounding of that code and of the ways to keep loops closed.
Finding precise_loops(const Effort& effort);

}  // namespace treeline::stress
