#pragma once

#include "program/program.hpp"

namespace treeline {

/// Counts the operations that the results need. A change of sign is not counted. An angle whose
/// sine and cosine are both needed counts once. Loops over links and solves for
/// columns count as what they execute.
OperationCount count_operations(const Program& program);

}  // namespace treeline
