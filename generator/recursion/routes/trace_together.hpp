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

/// tau = -J_ext^T f_ext alone: the joint forces against the mechanism's external forces, of `q` and
/// `f_ext`, by the inward pass of Newton and Euler without motion and gravity.
Program trace_against_forces(const Mechanism& mechanism, int lanes);

}  // namespace treeline
