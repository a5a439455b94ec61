#pragma once

#include "functions/function.hpp"

namespace treeline {

/// The symbol of the matrix that is solved with; empty where there is none.
const char* matrix_symbol(Solve solve);

}  // namespace treeline
