#pragma once

#include "program/program.hpp"

namespace treeline {

/// Counts the operations that the results need. A change of sign is not counted. An angle whose
/// sine and cosine are both needed counts once. Of loops over links it is what they execute.
OperationCount count_operations(const Program& program);

}  // namespace treeline
