#pragma once

#include <string>

#include "functions/function.hpp"

namespace treeline {

/// The symbol of the matrix that is solved with; empty where there is none.
const char* matrix_symbol(Solve solve);

/// The same with M before a matrix that is made with its inverse.
std::string matrix_symbols(Solve solve);

}  // namespace treeline
