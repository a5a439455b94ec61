#pragma once

#include <span>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline::cpp {

/// NAME_eigen.hpp: every function for Eigen's fixed-size vectors and row-major matrices.
std::string print_eigen(const EmissionContext& context, std::span<const Program> programs);

}  // namespace treeline::cpp
