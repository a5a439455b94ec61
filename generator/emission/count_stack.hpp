#pragma once

#include <cstddef>

#include "program/program.hpp"

namespace treeline {

/// How many numbers the emitted function is estimated to keep on the stack, beside the sines and
/// cosines: of straight lines those that are alive at once when the nodes are computed in their
/// order, and with `misra` those that its parts share; of loops over links their work space.
std::size_t count_stack_values(const Program& program, bool misra);

}  // namespace treeline
