#pragma once

#include <span>

#include "functions/function.hpp"
#include "mechanism/mechanism.hpp"
#include "program/program.hpp"

namespace treeline {

/// Functions about the robot or its operational points as one program with the results of all, so
/// that what they share is computed once: each by its first route, on the same tree. At most one of
/// them may depend on inertias, whose arguments (`payload`) would else count twice. The caller
/// gives the program its name and equation.
Program trace_together(const Mechanism& mechanism, std::span<const Function> functions, int lanes);

}  // namespace treeline
