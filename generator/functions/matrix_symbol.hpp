#pragma once

#include <string>

#include "functions/function.hpp"

namespace treeline {

/// The symbol of the matrix that is solved with; empty where there is none.
const char* matrix_symbol(Solve solve);

/// Symbols of the matrices that are inverted, with M before one that is made by inverting M.
std::string matrix_symbols(Solve solve);

}  // namespace treeline
