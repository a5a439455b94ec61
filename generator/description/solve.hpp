#pragma once

#include "description/scene.hpp"

namespace treeline {

/// Which matrix a function solves with: its errors grow with the condition of that matrix. M is
/// positive definite everywhere, Lambda^-1 singular in some configurations, Lambda^-1 + Delta in
/// none.
enum class Solve { none, mass_matrix, lambda_inverse, damped };
Solve solve_of(Function function);

/// The symbol of the matrix; empty where there is none.
const char* matrix_symbol(Solve solve);

}  // namespace treeline
